// adagen's runtime, the same for all robots.
#pragma once

// Angles are reduced by sums that cancel, and faults are found by numbers that are not finite. With
// these options both are optimised away, and answers are wrong.
#if defined(__FAST_MATH__) || defined(__ASSOCIATIVE_MATH__) || \
    (defined(__FINITE_MATH_ONLY__) && __FINITE_MATH_ONLY__)
#error "compile solvers without -ffast-math, -Ofast, -ffinite-math-only and -fassociative-math"
#endif
