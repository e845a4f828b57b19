// adagen's runtime, the same for all robots.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstring>
#include <utility>

#include "../common.hpp"
#include "../registers.hpp"
#include "../sizes.hpp"
#include "lanes.hpp"

namespace {

// Numbers of x, or beyond its last one of y.
template <int... k, class V>
ADAGEN_INLINE V shuffled(const V& x, const V& y) {
#if defined(__clang__)
  return __builtin_shufflevector(x, y, k...);
#else
  return __builtin_shuffle(x, y, decltype(x < y){k...});
#endif
}

// The same of halves: each half of what comes out is mostly shuffled from two.
template <int... k, class T>
ADAGEN_INLINE T shuffled_half(const T (&halves)[4]) {
  constexpr int n = sizeof...(k), from[]{k / n...};
  constexpr int one = from[0], other = std::max({k / n == one ? 0 : k / n...});
  if constexpr (((k / n == one || k / n == other) && ...))
    return shuffled<(k / n == one ? k % n : n + k % n)...>(halves[one], halves[other]);
  else
    return T{halves[k / n][k % n]...};
}
template <int... k, class T, std::size_t... half>
ADAGEN_INLINE Halves<T> shuffled_halves(const T (&halves)[4], std::index_sequence<half...>) {
  constexpr int from[]{k...};
  return Halves<T>::of(shuffled_half<from[half]...>(halves),
                       shuffled_half<from[sizeof...(half) + half]...>(halves));
}
template <int... k, class T>
ADAGEN_INLINE Halves<T> shuffled(const Halves<T>& x, const Halves<T>& y) {
  return shuffled_halves<k...>({x.low, x.high, y.low, y.high},
                               std::make_index_sequence<sizeof...(k) / 2>{});
}

// Each lane's number from where it is said to be: not by constants.
template <class V>
ADAGEN_INLINE V moved(const V& x, const BitsOf<V>& from) {
#if !defined(__clang__)
  if constexpr (!kOfHalves<V>)
    return __builtin_shuffle(x, from);
  else if constexpr (!kOfHalves<decltype(V::low)>)
    return V::of(__builtin_shuffle(x.low, x.high, from.low),
                 __builtin_shuffle(x.low, x.high, from.high));
  else
#endif
  {
    V result = x;
    ADAGEN_FOR (k, 0, static_cast<int>(sizeof(V) / sizeof(Real))) result[k] = x[from[k]];
    return result;
  }
}

// Rows x and y of a square: what lies in columns apart by a distance changes places.
template <int distance, class V, std::size_t... column>
ADAGEN_INLINE void exchange(V& x, V& y, std::index_sequence<column...>) {
  constexpr int n = sizeof...(column);
  const V row = shuffled<(column & distance ? n + column - distance : column)...>(x, y);
  y = shuffled<(column & distance ? n + column : column + distance)...>(x, y);
  x = row;
}

// Squares of n rows, side by side, become their transposes: blocks of one number, then of two by
// two, and so on.
template <int distance = 1, class V, std::size_t n>
ADAGEN_INLINE void transpose(V (&rows)[n]) {
  if constexpr (distance < static_cast<int>(n)) {
    ADAGEN_FOR (k, 0, static_cast<int>(n))
      if ((k & distance) == 0)
        exchange<distance>(rows[k], rows[k + distance],
                           std::make_index_sequence<sizeof(V) / sizeof(Real)>{});
    transpose<2 * distance>(rows);
  }
}

// So many numbers side by side.
template <int count>
struct Several {
  typedef Real T __attribute__((vector_size(count * sizeof(Real))));
};

// The numbers of x and then of y, and a part of such numbers. Compilers that cannot say so in one
// instruction take the way through memory.
template <int count, std::size_t... k>
ADAGEN_INLINE typename Several<2 * count>::T joined(const typename Several<count>::T& x,
                                                    const typename Several<count>::T& y,
                                                    std::index_sequence<k...>) {
#if defined(__clang__) || __GNUC__ >= 12
  return __builtin_shufflevector(x, y, static_cast<int>(k)...);
#else
  const typename Several<count>::T halves[]{x, y};
  typename Several<2 * count>::T both;
  std::memcpy(&both, halves, sizeof both);
  return both;
#endif
}
template <int count, int first, class V, std::size_t... k>
ADAGEN_INLINE typename Several<count>::T part_of(const V& x, std::index_sequence<k...>) {
#if defined(__clang__) || __GNUC__ >= 12
  return __builtin_shufflevector(x, x, static_cast<int>(first + k)...);
#else
  typename Several<count>::T part;
  std::memcpy(&part, reinterpret_cast<const char*>(&x) + first * sizeof(Real), sizeof part);
  return part;
#endif
}

// A register of pieces that lie apart in memory by so many numbers, and back.
template <int piece, int count>
ADAGEN_INLINE typename Several<count>::T collected(const Real* from, std::size_t apart) {
  if constexpr (count == piece) {
    typename Several<count>::T x;
    std::memcpy(&x, from, sizeof x);
    return x;
  } else {
    constexpr int half = count / 2;
    return joined<half>(collected<piece, half>(from, apart),
                        collected<piece, half>(from + half / piece * apart, apart),
                        std::make_index_sequence<count>{});
  }
}
template <int piece, int count, class V>
ADAGEN_INLINE void scatter(const V& x, Real* to, std::size_t apart) {
  if constexpr (count == piece) {
    std::memcpy(to, &x, sizeof x);
  } else {
    constexpr int half = count / 2;
    constexpr auto numbers = std::make_index_sequence<half>{};
    scatter<piece, half>(part_of<half, 0>(x, numbers), to, apart);
    scatter<piece, half>(part_of<half, half>(x, numbers), to + half / piece * apart, apart);
  }
}

}  // namespace
