// adagen's runtime, the same for all robots.
#pragma once

#include <cmath>
#include <limits>

namespace {

// The bound of an answer's relative error, of the squares of two energy norms: of the error as it
// is bounded, and of the answer. Where hardly anything accelerates nothing is sure.
[[maybe_unused]] inline double bound_of(double error, double answer) {
  const double bound = std::sqrt(error / answer);
  return bound >= 0 ? bound : std::numeric_limits<double>::infinity();
}

}  // namespace
