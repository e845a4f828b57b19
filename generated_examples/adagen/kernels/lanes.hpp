// adagen's runtime, the same for all robots.
#pragma once

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <type_traits>
#include <utility>

#include "../common.hpp"
#include "../sample/angles.hpp"
#include "../sizes.hpp"
#include "../tangents.hpp"
#include "../trigonometry.hpp"
#include "../value.hpp"

namespace {

// What comparisons of vectors give: of as many whole numbers, of the same size.
template <class T>
using BitsOf = decltype(T{} < T{});
typedef BitsOf<Lanes> LaneBits;

ADAGEN_INLINE void load(const Real* from, Lanes& x) { x = from_memory<Lanes>(from); }
ADAGEN_INLINE void store(const Lanes& x, Real* to) { to_memory(x, to); }

// Whether any bit is set. Half by half: compilers take lanes apart one by one if left to it.
typedef std::int64_t FourWords __attribute__((vector_size(32)));
typedef std::int64_t TwoWords __attribute__((vector_size(16)));
template <class T>
ADAGEN_INLINE bool any_of(const T& x) {
  if constexpr (sizeof x > sizeof(TwoWords)) {
    typedef std::conditional_t<sizeof x == sizeof(FourWords), TwoWords, FourWords> Half;
    Half halves[2];
    std::memcpy(halves, &x, sizeof x);
    const Half either = halves[0] | halves[1];
    return any_of(either);
  } else {
    std::int64_t words[2]{};
    std::memcpy(words, &x, sizeof x);
    return (words[0] | words[1]) != 0;
  }
}

template <class T>
ADAGEN_INLINE bool any_of(const Halves<T>& x) {
  return any_of(x.low | x.high);
}

// Whether all numbers are positive: false for NaN.
ADAGEN_INLINE bool all_positive(const Real& x) { return x > 0; }
template <class T>
ADAGEN_INLINE bool all_positive(const T& x) {
  return !any_of(~(x > T{}));
}

ADAGEN_INLINE bool all_zero(const Real& x) { return x == 0; }
ADAGEN_INLINE bool all_zero(const Lanes& x) { return !any_of(x != Lanes{}); }

template <class T, std::size_t n>
ADAGEN_INLINE T polynomial(const Real (&coefficients)[n], const T& x) {
  T result = T{} + coefficients[0];
  ADAGEN_FOR (k, 1, static_cast<int>(n)) result = result * x + coefficients[k];
  return result;
}

// Of angles that are not too large.
template <class T>
ADAGEN_INLINE void near_sine_and_cosine(const T& angle, T& sine, T& cosine) {
  using Table = Trigonometry<Real>;
  using Whole = BitsOf<T>;
  const T shifted = angle * Table::kTwoOverPi + Table::kRound;
  const Whole quadrant = same_bits<Whole>(shifted);
  const T turns = shifted - Table::kRound;
  const T rest =
      ((angle - turns * Table::kParts[0]) - turns * Table::kParts[1]) - turns * Table::kParts[2];
  const T square = rest * rest;
  const T s = rest + rest * square * polynomial(Table::kSine, square);
  const T c = 1 - square / 2 + square * square * polynomial(Table::kCosine, square);
  const Whole swapped = -(quadrant & 1);
  const Whole s_bits = same_bits<Whole>(s);
  const Whole c_bits = same_bits<Whole>(c);
  constexpr int kSign = 8 * static_cast<int>(sizeof(Real)) - 2;  // bit 1 of a quadrant to the sign
  const Whole sine_bits = ((s_bits & ~swapped) | (c_bits & swapped)) ^ ((quadrant & 2) << kSign);
  const Whole cosine_bits =
      ((c_bits & ~swapped) | (s_bits & swapped)) ^ (((quadrant + 1) & 2) << kSign);
  sine = same_bits<T>(sine_bits);
  cosine = same_bits<T>(cosine_bits);
}

template <class T>
ADAGEN_INLINE BitsOf<T> too_large(const T& angle) {
  constexpr Real kLargest = Trigonometry<Real>::kLargestAngle;
  return (angle > kLargest) | (angle < -kLargest);
}

ADAGEN_COLD inline void take_far_ones(const Lanes& angle, const LaneBits& lanes, Lanes& sine,
                                      Lanes& cosine) {
  for (int k = 0; k < kLanes; ++k) {
    if (!lanes[k]) continue;
    Real s, c;
    far_sine_and_cosine(angle[k], s, c);
    sine[k] = s, cosine[k] = c;
  }
}

ADAGEN_INLINE void sine_and_cosine(const Lanes& angle, Lanes& sine, Lanes& cosine) {
  near_sine_and_cosine(angle, sine, cosine);
  const LaneBits beyond = too_large(angle);
  if (__builtin_expect(any_of(beyond), 0)) take_far_ones(angle, beyond, sine, cosine);
}

// As of one number, bit for bit: all lanes go all ways, and each takes what its own one gives.
template <class T>
ADAGEN_INLINE T tangent_by_parts(const T& x) {
  using Whole = BitsOf<T>;
  constexpr double kRound = Trigonometry<double>::kRound;
  const T size = chosen(x < 0, T(-x), x), turned = 2 * size * 1.4426950408889634073599 + 0.5;
  const T nearest = (turned + kRound) - kRound;
  const T n = chosen(nearest > turned, T(nearest - 1), nearest);
  const T two_to_n = same_bits<T>((same_bits<Whole>(n + kRound) + 1023) << 52);
  const T tangent = 1 - 2 / (rest_of_power(size, n) * two_to_n + 1);
  const T large = chosen(size < kLargeTangent, tangent, T(T{} + 1));
  const T either = chosen(size < kSmallTangent, small_tangent(size), large);
  return chosen(x == x, chosen(x < 0, T(-either), either), x);
}

template <class T, class F>
ADAGEN_INLINE T in_each_lane(const T& x, const F& f) {
  T result = x;
  for (std::size_t k = 0; k < sizeof(T) / sizeof(Real); ++k) result[k] = f(x[k]);
  return result;
}

// Of floats, lane by lane: their tangents are those of a double, rounded.
template <class T>
ADAGEN_INLINE T hyperbolic_tangent(const T& x) {
  if constexpr (std::is_same_v<Real, double>) {
    return tangent_by_parts(x);
  } else {
    return in_each_lane(x, [](Real y) { return hyperbolic_tangent(y); });
  }
}

// Numbers from several places in memory.
template <class T, std::size_t... lane>
ADAGEN_INLINE T numbers_at(const Real* x, const int* place, std::index_sequence<lane...>) {
  return T{x[place[lane]]...};
}

}  // namespace
