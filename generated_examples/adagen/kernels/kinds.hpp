// adagen's runtime, the same for all robots.
#pragma once

#include <cstddef>

#include "../constants.hpp"
#include "../sample/robot.hpp"
#include "lanes.hpp"

namespace {

// Loops over rows of joints: a run's joints, or those of limbs side by side, of one kind each.
// Where few stretches of one kind follow each other, each is a loop of its own that knows its kind.
template <int first, int last>
struct RunRows {
  static constexpr int kCount = last - first + 1;
  static constexpr JointKind kind(int k) {
    return kJoints[static_cast<std::size_t>(first + k)].kind;
  }
};

constexpr int kMostStretches = 8;

// Where the stretch ends that begins with the k-th row of an order.
template <class Rows, bool backwards>
constexpr int end_of_stretch(int k) {
  const auto kind = [](int i) { return Rows::kind(backwards ? Rows::kCount - 1 - i : i); };
  int end = k + 1;
  while (end < Rows::kCount && kind(end) == kind(k)) ++end;
  return end;
}
template <class Rows>
constexpr bool few_stretches() {
  int count = 0;
  for (int k = 0; k < Rows::kCount; ++count) k = end_of_stretch<Rows, false>(k);
  return count <= kMostStretches;
}

// Calls step(row, kind) for each row, the last one first if backwards.
template <class Rows, bool backwards, int begin = 0, class Step>
ADAGEN_INLINE void each_row(const Step& step) {
  constexpr auto row = [](int k) { return backwards ? Rows::kCount - 1 - k : k; };
  if constexpr (few_stretches<Rows>()) {
    constexpr int end = end_of_stretch<Rows, backwards>(begin);
    constexpr std::integral_constant<JointKind, Rows::kind(row(begin))> kind;
    for (int k = begin; k < end; ++k) step(row(k), kind);
    if constexpr (end < Rows::kCount) each_row<Rows, backwards, end>(step);
  } else {
    for (int k = 0; k < Rows::kCount; ++k) step(row(k), Rows::kind(row(k)));
  }
}

}  // namespace
