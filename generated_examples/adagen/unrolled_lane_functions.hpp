// adagen's runtime, the same for all robots.
#pragma once
#if !defined(ADAGEN_SOLVER)
#define ADAGEN_BATCH  // read alone, it is of a solver for batches
#endif

#include "kernels/lanes.hpp"
#include "sizes.hpp"
#include "unrolled_functions.hpp"

namespace {

// The same, lane by lane.
[[maybe_unused]] inline Lanes sqrt_of(const Lanes& x) {
  return in_each_lane(x, [](Real y) { return sqrt_of(y); });
}
[[maybe_unused]] inline Lanes sign_of(const Lanes& x) {
  return in_each_lane(x, [](Real y) { return sign_of(y); });
}
[[maybe_unused]] inline Lanes max_of(const Lanes& x, const Lanes& y) { return larger(x, y); }
[[maybe_unused]] inline Lanes max_of(const Lanes& x, Real y) { return max_of(x, Lanes{} + y); }
[[maybe_unused]] inline Lanes max_of(Real x, const Lanes& y) { return max_of(Lanes{} + x, y); }

}  // namespace
