// adagen's runtime, the same for all robots.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstring>
#include <limits>
#include <type_traits>
#include <utility>

#include "common.hpp"
#include "kernels/lanes.hpp"
#include "sample/unrolled.hpp"
#include "short_vectors.hpp"
#include "sizes.hpp"
#include "status.hpp"
#include "unrolled.hpp"

namespace {

// Limbs of the same structure share code, one limb in each lane.
template <class T>
using Half =
    std::conditional_t<kWidth<T> == 8, Four, std::conditional_t<kWidth<T> == 4, Two, Real>>;

// The sum of the first numbers, half by half.
template <int count>
ADAGEN_INLINE Real across(const Real& x) {
  return x;
}
template <int count, class T>
ADAGEN_INLINE Real across(const T& x) {
  constexpr int half = kWidth<T> / 2;
  Half<T> halves[2];
  to_memory(x, halves);
  if constexpr (count == kWidth<T>) {
    const Half<T> sum = halves[0] + halves[1];
    return across<half>(sum);
  } else if constexpr (count > half) {
    return across<half>(halves[0]) + across<count - half>(halves[1]);
  } else {
    return across<count>(halves[0]);
  }
}

// Zero for finite numbers only, of rows that lie one after the other.
template <class T, int rows>
ADAGEN_INLINE Real unlike_zero(const Real* from) {
  T sum{};
  ADAGEN_FOR (k, 0, rows) {
    const T x = load<T>(from + k * kWidth<T>);
    sum += x - x;
  }
  return across<kWidth<T>>(sum);
}

// The same as for single numbers, in the name of a joint for each lane.
template <class T, std::size_t count>
ADAGEN_COLD void name_what_is_not_more(Workspace& w, const T& x, const T& least, Failure kind,
                                       const int (&joints)[count]) {
  for (std::size_t k = 0; k < count; ++k) require_more(w, x[k], least[k], kind, joints[k]);
}
template <class T, class L, std::size_t count>
ADAGEN_INLINE void require_more(Workspace& w, const T& x, const L& least, Failure kind,
                                const int (&joints)[count]) {
  const auto good = (x > least) & (x <= std::numeric_limits<Real>::max());
  if (__builtin_expect(any_of(~good), 0)) name_what_is_not_more(w, x, T{} + least, kind, joints);
}
template <class T, std::size_t count>
ADAGEN_INLINE void require_length(Workspace& w, const T& squared, const int (&joints)[count]) {
  for (std::size_t k = 0; k < count; ++k) require_length(w, squared[k], joints[k]);
}

}  // namespace
