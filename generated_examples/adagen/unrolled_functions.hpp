// adagen's runtime, the same for all robots.
#pragma once

#include <cmath>

#include "sizes.hpp"

namespace {

// What straight lines call beside sums, products and quotients.
[[maybe_unused]] inline Real sqrt_of(Real x) { return std::sqrt(x); }
[[maybe_unused]] inline Real sign_of(Real x) { return std::copysign(Real(1), x); }
[[maybe_unused]] inline Real max_of(Real x, Real y) { return x > y ? x : y; }

}  // namespace
