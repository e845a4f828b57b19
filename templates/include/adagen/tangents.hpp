// adagen's runtime, the same for all robots.
#pragma once

#include "common.hpp"

namespace {

// The parts of a hyperbolic tangent (Cephes), of a number or of several side by side.

constexpr double kSmallTangent = 0.625, kLargeTangent = 20;

// Of sizes below 0.625: a quotient of polynomials.
template <class T>
ADAGEN_INLINE T small_tangent(const T& x) {
  const T z = x * x;
  const T above =
      (-9.64399179425052238628e-1 * z - 9.92877231001918586564e1) * z - 1.61468768441708447952e3;
  const T below = ((z + 1.12811678491632931402e2) * z + 2.23548839060100448583e3) * z +
                  4.84406305325125486048e3;
  return x + x * z * (above / below);
}

// exp(2 size), less n log 2 in the exponent.
template <class T>
ADAGEN_INLINE T rest_of_power(const T& size, const T& n) {
  const T r = (2 * size - n * 6.93145751953125e-1) - n * 1.42860682030941723212e-6;
  const T z = r * r;
  const T odd = r * ((1.26177193074810590878e-4 * z + 3.02994407707441961300e-2) * z + 1);
  const T even = ((3.00198505138664455042e-6 * z + 2.52448340349684104192e-3) * z +
                  2.27265548208155028766e-1) *
                     z +
                 2;
  return 1 + 2 * (odd / (even - odd));
}

}  // namespace
