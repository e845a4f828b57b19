// adagen's runtime, the same for all robots.
#pragma once

#include <cmath>

#include "sizes.hpp"

namespace {

// Sine and cosine of an angle far from zero.
[[maybe_unused]] inline void far_sine_and_cosine(Real angle, Real& sine, Real& cosine) {
  sine = std::sin(angle), cosine = std::cos(angle);
}

}  // namespace
