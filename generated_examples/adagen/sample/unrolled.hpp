// adagen's runtime, the same for all robots.
// A solver says this itself (ADAGEN_SOLVER). Read alone, headers take it of a sample.
#pragma once
#if !defined(ADAGEN_SOLVER) && !defined(ADAGEN_WORKSPACE)
#define ADAGEN_WORKSPACE

#include <array>

#include "../unrolled_numbers.hpp"
#include "value.hpp"

namespace {

struct Workspace {
  const Value* q = nullptr;
  const Value* v = nullptr;
  const Value* tau = nullptr;
  Value* qdd = nullptr;
  int status = 0;
  std::array<Value, 16> angle{}, sine{}, cosine{};
  std::array<Value, kNqdd> result{};
};

}  // namespace

#endif
