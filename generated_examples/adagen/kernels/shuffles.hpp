// adagen's runtime, the same for all robots.
#pragma once

#include <cstddef>
#include <utility>

#include "../common.hpp"
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

// Rows x and y of a square: what lies in columns apart by a distance changes places.
template <int distance, class V, std::size_t... column>
ADAGEN_INLINE void exchange(V& x, V& y, std::index_sequence<column...>) {
  constexpr int n = sizeof...(column);
  const V row = shuffled<(column & distance ? n + column - distance : column)...>(x, y);
  y = shuffled<(column & distance ? n + column : column + distance)...>(x, y);
  x = row;
}

// A square of as many rows as each has numbers becomes its transpose: blocks of one number, then of
// two by two, and so on.
template <int distance = 1, class V, std::size_t n>
ADAGEN_INLINE void transpose(V (&rows)[n]) {
  if constexpr (distance < static_cast<int>(n)) {
    ADAGEN_FOR (k, 0, static_cast<int>(n))
      if ((k & distance) == 0)
        exchange<distance>(rows[k], rows[k + distance], std::make_index_sequence<n>{});
    transpose<2 * distance>(rows);
  }
}

}  // namespace
