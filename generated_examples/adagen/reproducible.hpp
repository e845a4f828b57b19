// adagen's runtime, the same for all robots.
#pragma once

#include <cfloat>
#include <limits>

#include "common.hpp"
#include "multiply_add.hpp"
#include "sizes.hpp"

namespace {

// Answers are the same to the last bit on every machine with numbers of IEEE 754: each operation of
// the text is done by itself and rounded to the nearest number. What would change that is refused.
#define ADAGEN_REPRODUCIBLE
#if FLT_EVAL_METHOD != 0
#error "this solver was emitted with --reproducible: compile it for SSE2 (-mfpmath=sse)"
#endif

// Why answers would be others here; null where they are not. Options can tell a compiler, and a
// program its processor, to compute in another way than the text says.
[[maybe_unused]] ADAGEN_NOINLINE const char* why_not_reproducible() {
  using Limits = std::numeric_limits<Real>;
  const volatile Real given[] = {1, Limits::epsilon(), Limits::min(), 3};
  const Real one = given[0], step = given[1], least = given[2], three = given[3];
  const Real above = one + step, below = one - step, large = 2 / step;
  if (one + step / 4 != one || one + step * 3 / 4 != above)
    return "this solver is reproducible, and the processor does not round to the nearest number: "
           "say fesetround(FE_TONEAREST)";
  if (least / 2 * 2 != least)
    return "this solver is reproducible, and the processor flushes subnormal numbers to zero: "
           "link without -ffast-math, or clear the bits FTZ and DAZ of MXCSR";
  if (above * below - one != 0)
    return "this solver is reproducible, and was compiled to fuse products and sums: compile it "
           "with -ffp-contract=off";
  if (fused(above * (step / 2), below, above) != above)  // next to the middle of two numbers
    return "this solver is reproducible, and the C library's fma rounds twice: compile it for a "
           "processor that has fma as an instruction";
  if ((large + one) - large != 0)
    return "this solver is reproducible, and was compiled to reorder sums: compile it without "
           "-ffast-math and -fassociative-math";
  if (one / three != Real(1) / 3)
    return "this solver is reproducible, and was compiled to approximate quotients: compile it "
           "without -mrecip and -freciprocal-math";
  return nullptr;
}

}  // namespace
