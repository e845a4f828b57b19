// adagen's runtime, the same for all robots.
#pragma once

#include <algorithm>
#include <cmath>

#include "sizes.hpp"

namespace {

// Sine and cosine by the polynomials of fdlibm on [-pi/4, pi/4], after taking multiples of pi/2
// away in three parts. No branch: a loop over it is done in SIMD lanes.
inline void sine_and_cosine(double angle, double& sine, double& cosine) {
  constexpr double kRound = 6755399441055744.0;  // 1.5 * 2^52: adding it rounds to an integer
  const double n = (angle * 0.63661977236758134308 + kRound) - kRound;
  const double r = ((angle - n * 1.57079632673412561417e+00) - n * 6.07710050630396597660e-11) -
                   n * 2.02226624871116645580e-21;
  const double z = r * r, z2 = z * z, z4 = z2 * z2;
  const double s = r + r * z *
                           ((-1.66666666666666307295e-1 + z * 8.33333333332211858878e-3) +
                            z2 * (-1.98412698295895385996e-4 + z * 2.75573136213857245213e-6) +
                            z4 * (-2.50507477628578072866e-8 + z * 1.58962301576546568060e-10));
  const double c =
      (1 - 0.5 * z) + z2 * ((4.16666666666665929218e-2 - z * 1.38888888888730564116e-3) +
                            z2 * (2.48015872888517045348e-5 - z * 2.75573141792967388112e-7) +
                            z4 * (2.08757008419747316778e-9 - z * 1.13585365213876817300e-11));
  const double half = std::floor(n * 0.5), odd = n - 2 * half;
  const double sign = 1 - 2 * (half - 2 * std::floor(half * 0.5));
  sine = sign * (odd != 0 ? c : s);
  cosine = sign * (odd != 0 ? -s : c);
}

template <int count>
inline void take_sines_and_cosines(const Real* angle, Real* sine, Real* cosine) {
  constexpr double kFar = 1e5;  // beyond, the three parts of pi/2 would lose digits
  Real farthest = 0;
  for (int k = 0; k < count; ++k) {
    double s, c;
    sine_and_cosine(angle[k], s, c);
    sine[k] = Real(s), cosine[k] = Real(c);
  }
  for (int k = 0; k < count; ++k) farthest = std::max(farthest, std::abs(angle[k]));
  if (farthest <= kFar) return;
  for (int k = 0; k < count; ++k) sine[k] = std::sin(angle[k]), cosine[k] = std::cos(angle[k]);
}

}  // namespace
