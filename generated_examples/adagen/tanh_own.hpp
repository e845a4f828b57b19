// adagen's runtime, the same for all robots.
#pragma once

#include <cmath>

#include "sizes.hpp"

namespace {

// The hyperbolic tangent by sums, products and quotients alone (Cephes), the same wherever the C
// library is.
[[maybe_unused]] inline Real tanh_of(Real argument) {
  const double x = static_cast<double>(argument), size = std::abs(x);
  if (!(size < 20)) return Real(x < 0 ? -1 : x > 0 ? 1 : x - x);
  if (size < 0.625) {
    const double z = x * x;
    const double above =
        (-9.64399179425052238628e-1 * z - 9.92877231001918586564e1) * z - 1.61468768441708447952e3;
    const double below = ((z + 1.12811678491632931402e2) * z + 2.23548839060100448583e3) * z +
                         4.84406305325125486048e3;
    return Real(x + x * z * (above / below));
  }
  // 1 - 2 / (exp(2 size) + 1): the exponent less n log 2, by a quotient of polynomials.
  const double n = std::floor(2 * size * 1.4426950408889634073599 + 0.5);
  const double r = (2 * size - n * 6.93145751953125e-1) - n * 1.42860682030941723212e-6;
  const double z = r * r;
  const double odd = r * ((1.26177193074810590878e-4 * z + 3.02994407707441961300e-2) * z + 1);
  const double even = ((3.00198505138664455042e-6 * z + 2.52448340349684104192e-3) * z +
                       2.27265548208155028766e-1) *
                          z +
                      2;
  const double power = std::ldexp(1 + 2 * (odd / (even - odd)), static_cast<int>(n));
  const double tangent = 1 - 2 / (power + 1);
  return Real(x < 0 ? -tangent : tangent);
}

}  // namespace
