// adagen's runtime, the same for all robots.
#pragma once

#include <cmath>
#include <limits>

namespace {

// The bound of an answer's relative error, of the squares of two energy norms: of the error as it
// is bounded, and of the answer. Where hardly anything accelerates nothing is sure. Nor is it where
// the bound is large: it is found with factors that then have as few digits as the answer.
constexpr double kLargestBound = 1.0 / 64;
[[maybe_unused]] inline double bound_of(double error, double answer) {
  const double bound = std::sqrt(error / answer);
  return bound <= kLargestBound ? bound : std::numeric_limits<double>::infinity();
}

}  // namespace
