// adagen's runtime, the same for all robots.
#pragma once

#include "sample/robot.hpp"
#include "sample/workspace.hpp"
#include "sizes.hpp"

namespace {

// All constants are as they were emitted.
[[maybe_unused]] inline Number* pack_parameters(Number* to, const Workspace&) { return to; }
[[maybe_unused]] inline const Number* unpack_parameters(const Number* from, Workspace&) {
  return from;
}
[[maybe_unused]] inline void copy_parameters(const Workspace&, Workspace&) {}

}  // namespace
