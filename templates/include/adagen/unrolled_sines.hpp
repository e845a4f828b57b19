// adagen's runtime, the same for all robots.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <type_traits>
#include <utility>

#include "kernels/lanes.hpp"
#include "sample/angles.hpp"
#include "short_vectors.hpp"
#include "sizes.hpp"
#include "value.hpp"

namespace {

// Sines and cosines of angles, whose places in q are given. Up to two registers of 256 bits are
// taken before one of 512: of 6 or 7 angles, one register of 512 bits takes 30 to 45 ns longer on
// an Intel Xeon. There is no branch for an angle's quadrant, which processors do not foresee.
typedef std::conditional_t<sizeof(Real) == 8, Two, Four> Register128;
typedef std::conditional_t<sizeof(Real) == 8, Four, Eight> Register256;
template <int left>  // for so many angles
using Angles =
    std::conditional_t<(left <= kWidth<Register128> || kRegisterBytes == 16), Register128,
                       std::conditional_t<(left <= 2 * kWidth<Register256> || kRegisterBytes == 32),
                                          Register256, Lanes>>;

template <class T, std::size_t count, std::size_t... lane>
ADAGEN_INLINE T angles_of(const Real* q, const std::array<int, count>& places, std::size_t first,
                          std::index_sequence<lane...>) {
  return T{q[places[std::min(first + lane, count - 1)]]...};
}

// Tells whether an angle is too large. As many are written as fill registers.
template <std::size_t first, std::size_t count>
ADAGEN_INLINE bool take_near_ones(const Real* q, const std::array<int, count>& places, Real* sine,
                                  Real* cosine) {
  using T = Angles<static_cast<int>(count - first)>;
  constexpr std::size_t width = kWidth<T>;
  const T angle = angles_of<T>(q, places, first, std::make_index_sequence<width>{});
  T s, c;
  near_sine_and_cosine(angle, s, c);
  put(s, sine + first);
  put(c, cosine + first);
  bool beyond = any_of(too_large(angle));
  if constexpr (first + width < count)
    beyond |= take_near_ones<first + width>(q, places, sine, cosine);
  return beyond;
}

template <std::size_t count>
ADAGEN_COLD void take_far_ones(const Real* q, const std::array<int, count>& places, Real* sine,
                               Real* cosine) {
  for (std::size_t k = 0; k < count; ++k) {
    const Real angle = q[places[k]];
    if (std::abs(angle) > Trigonometry<Real>::kLargestAngle)
      far_sine_and_cosine(angle, sine[k], cosine[k]);
  }
}

template <std::size_t count>
ADAGEN_INLINE void take_sines_and_cosines(const Real* q, const std::array<int, count>& places,
                                          Real* sine, Real* cosine) {
  if (__builtin_expect(take_near_ones<0>(q, places, sine, cosine), 0))
    take_far_ones(q, places, sine, cosine);
}

}  // namespace
