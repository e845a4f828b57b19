// adagen's runtime, the same for all robots.
#pragma once

#include "sizes.hpp"

namespace {

// What straight lines of numbers need.
inline bool all(bool good, bool also = true) { return good && also; }

// Zero for finite numbers only: x - x is. Four sums: one would wait for itself.
inline Real unlike_zero(const Real* x, int count) {
  Real sum[4] = {};
  for (int k = 0; k < count; ++k) sum[k % 4] += x[k] - x[k];
  return (sum[0] + sum[1]) + (sum[2] + sum[3]);
}

}  // namespace
