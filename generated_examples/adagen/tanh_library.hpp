// adagen's runtime, the same for all robots.
#pragma once

#include <cmath>

#include "sizes.hpp"

namespace {

#if defined(ADAGEN_EMBEDDED)
// A controller may have no arithmetic but that of floats.
[[maybe_unused]] inline Real tanh_of(Real x) { return std::tanh(x); }
#else
// Tangents are those of a double, so that they are the same wherever the C library is.
[[maybe_unused]] inline Real tanh_of(Real x) { return Real(std::tanh(double(x))); }
#endif

}  // namespace
