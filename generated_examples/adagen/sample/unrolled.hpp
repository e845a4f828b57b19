// adagen's runtime, the same for all robots.
// A solver says this itself (ADAGEN_SOLVER). Read alone, headers take it of a sample.
#pragma once
#if !defined(ADAGEN_SOLVER) && !defined(ADAGEN_WORKSPACE)
#define ADAGEN_WORKSPACE

#include <array>

#include "../sizes.hpp"
#include "../unrolled_memory.hpp"
#include "../unrolled_numbers.hpp"
#include "../value.hpp"

namespace {

struct Workspace : StraightMemory<16, 0, 0> {
  std::array<Value, 2 + kRefine> energies{};
  struct {
    std::array<double, kRefine> corrections{};
  } refinement;
};

}  // namespace

#endif
