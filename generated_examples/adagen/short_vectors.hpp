// adagen's runtime, the same for all robots.
#pragma once

#include "kernels/lanes.hpp"
#include "registers.hpp"
#include "sizes.hpp"
#include "value.hpp"

namespace {

template <class T>
[[maybe_unused]] constexpr int kWidth = static_cast<int>(sizeof(T) / sizeof(Real));
template <class T>
ADAGEN_INLINE T load(const Real* from) {
  return from_memory<T>(from);
}
template <class T>
ADAGEN_INLINE T put(const T& x, Real* to) {
  to_memory(x, to);
  return x;
}

}  // namespace
