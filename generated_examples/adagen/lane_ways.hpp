// adagen's runtime, the same for all robots.
#pragma once
#if !defined(ADAGEN_SOLVER)
#define ADAGEN_BATCH  // read alone, it is of a solver for batches
#endif

#include <cstddef>

#include "kernels/lanes.hpp"

namespace {

struct Workspace;

// Lanes whose pose the way that they go cannot stand, and those that it refuses.
struct LaneWays {
  LaneBits poor{}, refused{};
};

// The functions that go a way one after the other; the last one gives results.
struct Way {
  void (*const* parts)(Workspace&);
  std::size_t count;
};

}  // namespace
