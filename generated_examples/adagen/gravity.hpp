// adagen's runtime, the same for all robots.
#pragma once

#include <cstddef>

#include "sample/robot.hpp"
#include "sizes.hpp"

namespace {

struct Workspace;

#if defined(ADAGEN_SETS_GRAVITY)  // it is set at run time
inline Number gravity(const Workspace& w, int k) {
  return w.parameters[static_cast<std::size_t>(kGravityEntry + k)];
}
#else
inline double gravity(const Workspace&, int k) { return kGravity[static_cast<std::size_t>(k)]; }
#endif

}  // namespace
