// Numbers that are equal but for rounding.
#pragma once

#include <algorithm>
#include <cmath>
#include <limits>

namespace {

// Whether they differ by so many units in the last place of the larger one, or of 1.
[[maybe_unused]] bool near(double a, double b, double units = 4) {
  const double size = std::max({1.0, std::abs(a), std::abs(b)});
  return std::abs(a - b) <= units * std::numeric_limits<double>::epsilon() * size;
}

}  // namespace
