// adagen's runtime, the same for all robots.
#pragma once

#include <cmath>
#include <limits>

#include "sizes.hpp"

namespace {

// The bound of an answer's relative error, of the squares of two energy norms: of the error as it
// is bounded, and of the answer. Where hardly anything accelerates nothing is sure: squares of what
// rounding takes, which are smaller by the square of an epsilon, leave the range of numbers there.
// Nor is it where the bound is large: it is found with factors that then have as few digits as the
// answer.
constexpr double kLargestBound = 1.0 / 64;
[[maybe_unused]] inline double bound_of(double error, double answer) {
  using Limits = std::numeric_limits<Real>;
  constexpr double epsilon = Limits::epsilon(),
                   least = Limits::min() / (epsilon * epsilon * epsilon);
  const bool in_range = answer >= least && answer <= double{Limits::max()};
  const double bound = std::sqrt(error / answer);
  return in_range && bound <= kLargestBound ? bound : std::numeric_limits<double>::infinity();
}

}  // namespace
