// adagen's runtime, the same for all robots.
#pragma once

#include "sizes.hpp"

namespace {

// Products and sums that are rounded once: one instruction where the processor that is compiled for
// has it. Baseline x86-64 has none, but nearly all processors since 2013 do: they are asked when a
// program is loaded. All others call the C library. The result is the same.
#if defined(__x86_64__) && !defined(__FMA__)
#define ADAGEN_ASKED_FOR_FMA
[[maybe_unused]] const bool kHasFma = (__builtin_cpu_init(), __builtin_cpu_supports("fma") != 0);
#endif

[[maybe_unused]] inline Real fused(Real a, Real b, Real c) {  // a b + c
  constexpr bool wide = sizeof(Real) == sizeof(double);
#if defined(ADAGEN_ASKED_FOR_FMA)
  if (__builtin_expect(kHasFma, 1)) {  // volatile: nothing is done before this is known
    if constexpr (wide)
      asm volatile("vfmadd231sd %2, %1, %0" : "+x"(c) : "x"(a), "x"(b));
    else
      asm volatile("vfmadd231ss %2, %1, %0" : "+x"(c) : "x"(a), "x"(b));
    return c;
  }
#endif
  if constexpr (wide)
    return static_cast<Real>(__builtin_fma(a, b, c));
  else
    return static_cast<Real>(__builtin_fmaf(a, b, c));
}
[[maybe_unused]] inline Real fused_less(Real a, Real b, Real c) {  // a b - c
  return fused(a, b, -c);
}
[[maybe_unused]] inline Real fused_from(Real a, Real b, Real c) {  // c - a b
  return fused(-a, b, c);
}

}  // namespace
