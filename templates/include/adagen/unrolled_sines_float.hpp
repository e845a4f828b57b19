// adagen's runtime, the same for all robots.
#pragma once

#include <cmath>

namespace {

// Sine and cosine in floats alone: the angle less n pi/2 by three parts of pi/2 (Cody and Waite),
// then polynomials (Cephes).
inline void sine_and_cosine(float angle, float& sine, float& cosine) {
  constexpr float kRound = 12582912.0f;  // 1.5 * 2^23: adding it rounds to an integer
  const float n = (angle * 0.636619772f + kRound) - kRound;
  const float r =
      ((angle - n * 1.5703125f) - n * 4.837512969970703125e-4f) - n * 7.54978995489188216e-8f;
  const float z = r * r;
  const float s = r + r * z * ((-1.9515295891e-4f * z + 8.3321608736e-3f) * z - 1.6666654611e-1f);
  const float c =
      1 - z / 2 +
      z * z * ((2.443315711809948e-5f * z - 1.388731625493765e-3f) * z + 4.166664568298827e-2f);
  const int quadrant = static_cast<int>(n) & 3;
  const bool odd = (quadrant & 1) != 0;
  sine = odd ? c : s;
  cosine = odd ? s : c;
  if ((quadrant & 2) != 0) sine = -sine;
  if (((quadrant + 1) & 2) != 0) cosine = -cosine;
}

template <int count>
inline void take_sines_and_cosines(const float* angle, float* sine, float* cosine) {
  constexpr float kFar = 8000;  // beyond, the three parts of pi/2 would lose digits
  for (int k = 0; k < count; ++k) {
    if (angle[k] <= kFar && angle[k] >= -kFar)
      sine_and_cosine(angle[k], sine[k], cosine[k]);
    else
      sine[k] = std::sin(angle[k]), cosine[k] = std::cos(angle[k]);
  }
}

}  // namespace
