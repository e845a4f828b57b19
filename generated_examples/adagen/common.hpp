// adagen's runtime, the same for all robots.
// Definitions for all headers.
#pragma once

#include <cstddef>

#include "arithmetic.hpp"

#define ADAGEN_ALWAYS __attribute__((always_inline))
#define ADAGEN_INLINE [[maybe_unused]] inline ADAGEN_ALWAYS
#define ADAGEN_NOINLINE [[maybe_unused]] __attribute__((noinline))
#define ADAGEN_COLD [[maybe_unused]] __attribute__((cold, noinline))  // out of the way of the rest
// A counted loop that is to be unrolled whole, so that indices computed in it become constants.
#if defined(__clang__)
#define ADAGEN_FOR(k, first, last) \
  _Pragma("clang loop unroll(full)") for (int k = first; k < last; ++k)
#else
#define ADAGEN_FOR(k, first, last) _Pragma("GCC unroll 16") for (int k = first; k < last; ++k)
#endif

namespace {

[[maybe_unused]] constexpr std::size_t kCacheLine = 64;
#if defined(ADAGEN_EMBEDDED)
constexpr std::size_t kTextSize = 200;  // of a failure in words
#else
constexpr std::size_t kTextSize = 1000;
#endif

}  // namespace
