// adagen's runtime, the same for all robots.
#pragma once

#include <cstring>

#include "kernels/lanes.hpp"
#include "sizes.hpp"

namespace {

typedef Real Two __attribute__((vector_size(2 * sizeof(Real))));
typedef Real Four __attribute__((vector_size(4 * sizeof(Real))));
typedef Real Eight __attribute__((vector_size(8 * sizeof(Real))));
template <class T>
[[maybe_unused]] constexpr int kWidth = static_cast<int>(sizeof(T) / sizeof(Real));
template <class T>
ADAGEN_INLINE T load(const Real* from) {
  T x;
  std::memcpy(&x, from, sizeof x);
  return x;
}
template <class T>
ADAGEN_INLINE T put(const T& x, Real* to) {
  std::memcpy(to, &x, sizeof x);
  return x;
}

}  // namespace
