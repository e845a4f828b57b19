// adagen's runtime, the same for all robots.
#pragma once

#include <type_traits>

#include "common.hpp"
#include "sizes.hpp"
#include "unrolled_wide.hpp"

namespace {

// The same of limbs, lane by lane; a single number stands for all lanes.
template <class T, class R = std::enable_if_t<(kWidth<T> > 1), T>>
[[maybe_unused]] ADAGEN_INLINE R max_of(const T& x, const T& y) {
  return larger(x, y);
}
template <class T, class R = std::enable_if_t<(kWidth<T> > 1), T>>
[[maybe_unused]] ADAGEN_INLINE R max_of(const T& x, const Real& y) {
  return max_of(x, T{} + y);
}
template <class T, class R = std::enable_if_t<(kWidth<T> > 1), T>>
[[maybe_unused]] ADAGEN_INLINE R max_of(const Real& x, const T& y) {
  return max_of(T{} + x, y);
}

}  // namespace
