// adagen's runtime, the same for all robots.
#pragma once

#include <cmath>
#include <limits>

#include "sizes.hpp"

namespace {

// The energy norm of a part, relative to that of the whole, of their squares.
[[maybe_unused]] inline double energy_ratio(double part, double whole) {
  if (whole > 0) return std::sqrt(part / whole);
  return part > 0 ? std::numeric_limits<double>::infinity() : 0;
}

// Whether errors can be told beside an answer, by the square of its energy norm. Where hardly
// anything accelerates they cannot: squares of what rounding takes, which are smaller by the square
// of an epsilon, leave the range of numbers there.
[[maybe_unused]] inline bool tells_errors(double answer) {
  using Limits = std::numeric_limits<Real>;
  constexpr double epsilon = Limits::epsilon(),
                   least = Limits::min() / (epsilon * epsilon * epsilon);
  return answer >= least && answer <= double{Limits::max()};
}

// The bound of an answer's relative error, of the squares of two energy norms: of the error as it
// is bounded, and of the answer. Nothing is sure where the bound is large: it is found with factors
// that then have as few digits as the answer.
constexpr double kLargestBound = 1.0 / 64;
[[maybe_unused]] inline double bound_of(double error, double answer) {
  const double bound = std::sqrt(error / answer);
  const bool sure = tells_errors(answer) && bound <= kLargestBound;
  return sure ? bound : std::numeric_limits<double>::infinity();
}

}  // namespace
