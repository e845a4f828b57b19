// adagen's runtime, the same for all robots.
#pragma once

#include <cmath>
#include <cstddef>

#include "sample/angles.hpp"
#include "sizes.hpp"
#include "trigonometry.hpp"

namespace {

// Sines and cosines one by one, for processors without vectors of numbers.
template <std::size_t n>
inline Real polynomial(const Real (&coefficients)[n], Real x) {
  Real result = coefficients[0];
  for (std::size_t k = 1; k < n; ++k) result = result * x + coefficients[k];
  return result;
}

inline void near_sine_and_cosine(Real angle, Real& sine, Real& cosine) {
  using Table = Trigonometry<Real>;
  const Real turns = (angle * Table::kTwoOverPi + Table::kRound) - Table::kRound;
  const Real rest =
      ((angle - turns * Table::kParts[0]) - turns * Table::kParts[1]) - turns * Table::kParts[2];
  const Real square = rest * rest;
  const Real s = rest + rest * square * polynomial(Table::kSine, square);
  const Real c = 1 - square / 2 + square * square * polynomial(Table::kCosine, square);
  const int quadrant = static_cast<int>(turns) & 3;
  const bool swapped = (quadrant & 1) != 0;
  sine = swapped ? c : s;
  cosine = swapped ? s : c;
  if ((quadrant & 2) != 0) sine = -sine;
  if (((quadrant + 1) & 2) != 0) cosine = -cosine;
}

template <int count>
inline void take_sines_and_cosines(const Real* angle, Real* sine, Real* cosine) {
  constexpr Real kLargest = Trigonometry<Real>::kLargestAngle;
  for (int k = 0; k < count; ++k) {
    if (angle[k] <= kLargest && angle[k] >= -kLargest)
      near_sine_and_cosine(angle[k], sine[k], cosine[k]);
    else
      far_sine_and_cosine(angle[k], sine[k], cosine[k]);
  }
}

}  // namespace
