// adagen's runtime, the same for all robots.
#pragma once

#include <cmath>

#include "sizes.hpp"
#include "tangents.hpp"

namespace {

// The hyperbolic tangent by sums, products and quotients alone (Cephes), the same wherever the C
// library is.
[[maybe_unused]] inline Real tanh_of(Real argument) {
  const double x = static_cast<double>(argument), size = std::abs(x);
  if (!(size < kLargeTangent)) return Real(x < 0 ? -1 : x > 0 ? 1 : x - x);
  if (size < kSmallTangent) return Real(small_tangent(x));
  const double n = std::floor(2 * size * 1.4426950408889634073599 + 0.5);
  const double power = std::ldexp(rest_of_power(size, n), static_cast<int>(n));
  const double tangent = 1 - 2 / (power + 1);
  return Real(x < 0 ? -tangent : tangent);
}

}  // namespace
