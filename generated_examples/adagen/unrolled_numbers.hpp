// adagen's runtime, the same for all robots.
#pragma once

#include "sizes.hpp"

namespace {

// What straight lines of numbers need.
inline bool all(bool good, bool also = true) { return good && also; }

// Zero for finite numbers only: x - x is.
inline Real unlike_zero(const Real* x, int count) {
  Real sum = 0;
  for (int k = 0; k < count; ++k) sum += x[k] - x[k];
  return sum;
}

}  // namespace
