// adagen's runtime, the same for all robots.
#pragma once

#include <cmath>

#include "sizes.hpp"

namespace {

// Tangents are those of a double, so that they are the same wherever the C library is.
[[maybe_unused]] inline Real tanh_of(Real x) { return Real(std::tanh(double(x))); }

}  // namespace
