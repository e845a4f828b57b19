// adagen's runtime, the same for all robots.
#pragma once

#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>

#include "common.hpp"
#include "sizes.hpp"

namespace {

// Hyperbolic tangents by sums, products and quotients alone (Cephes), the same wherever the C
// library is: parts of one or of several side by side, then one.

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

[[maybe_unused]] inline Real hyperbolic_tangent(Real argument) {
  const double x = static_cast<double>(argument), size = std::abs(x);
  if (!(size < kLargeTangent)) return Real(x < 0 ? -1 : x > 0 ? 1 : x - x);
  if (size < kSmallTangent) return Real(small_tangent(x));
  const double n = std::floor(2 * size * 1.4426950408889634073599 + 0.5);
  const double two_to_n = static_cast<double>(std::uint64_t{1} << static_cast<int>(n));
  const double found = 1 - 2 / (rest_of_power(size, n) * two_to_n + 1);
  return Real(x < 0 ? -found : found);
}

// Which are taken, of rates in v times these factors; filled up with zeros to whole registers.
template <std::size_t count, std::size_t filled>
struct Tangents {
  std::array<int, filled> place;
  alignas(kCacheLine) std::array<Real, filled> factor;
};

}  // namespace
