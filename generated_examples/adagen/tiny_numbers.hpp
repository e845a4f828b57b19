// adagen's runtime, the same for all robots.
#pragma once

#include "sizes.hpp"

namespace {

// While it exists, subnormal numbers count as zero in a solver that makes them. They are below
// 1.2e-38 (float), and an operation with one takes a hundred cycles (x86-64). Where there are none,
// this would take five nanoseconds for nothing. A reproducible solver computes with them, as
// everywhere.
class TinyAreZero {
#if defined(__SSE_MATH__) && !defined(ADAGEN_REPRODUCIBLE)
 public:
  TinyAreZero() {
    if constexpr (Settings::kMeetsSubnormals) {
      kept_ = __builtin_ia32_stmxcsr();
      if ((kept_ & kTiny) != kTiny) __builtin_ia32_ldmxcsr(kept_ | kTiny);
    }
  }
  ~TinyAreZero() {
    if constexpr (Settings::kMeetsSubnormals)
      if ((kept_ & kTiny) != kTiny) __builtin_ia32_ldmxcsr(kept_);
  }
  TinyAreZero(const TinyAreZero&) = delete;
  TinyAreZero& operator=(const TinyAreZero&) = delete;

 private:
  static constexpr unsigned kTiny = 0x8040;  // bits FTZ and DAZ of MXCSR: results, operands
  unsigned kept_ = 0;
#endif
};

}  // namespace
