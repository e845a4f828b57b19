// adagen's runtime, the same for all robots.
#pragma once
#if !defined(ADAGEN_SOLVER)
#define ADAGEN_BATCH  // read alone, it is of a solver for batches
#endif

#include <array>
#include <cstddef>

#include "kernels/lanes.hpp"
#include "sizes.hpp"
#include "value.hpp"

namespace {

struct Workspace;

// In reproducible batches, a state goes the way that it would go alone: in a pose that one cannot
// stand, its lane has its answer of a later one.
struct LaneWays {
  LaneBits done{}, poor{}, refused{};  // lanes that have an answer, and what became of the others
  std::array<Value, kNqdd> result{};   // of those that have one
  std::array<Value, 2> certificate{};
  void begin() { done = poor = refused = LaneBits{}; }
};

// The functions that go a way one after the other; the last one gives results.
struct Way {
  void (*const* parts)(Workspace&);
  std::size_t count;
};

}  // namespace
