// adagen's runtime, the same for all robots.
#pragma once

#include <array>
#include <cstddef>

#include "common.hpp"
#include "sizes.hpp"
#include "status.hpp"
#include "value.hpp"

namespace {

// The memory of a process that straight lines have: the state, angles with sine and cosine, results
// (those of rows in lanes by themselves), what messages hold, and values that one function leaves
// to another.
template <std::size_t angles, std::size_t rows, std::size_t places>
struct StraightMemory {
  const Value* q = nullptr;
  const Value* v = nullptr;
  const Value* tau = nullptr;
  Value* qdd = nullptr;
  int status = kFine;
  alignas(kCacheLine) std::array<Value, angles> angle{}, sine{}, cosine{};
  std::array<Value, kNqdd> result{};
  alignas(kCacheLine) std::array<Value, rows> lanes{};
  std::array<Real*, kPlanMessages> to{};          // messages to be sent
  std::array<const Real*, kPlanMessages> from{};  // messages received
  alignas(kCacheLine) std::array<Value, places> x{};
};

}  // namespace
