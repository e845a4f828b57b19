// adagen's runtime, the same for all robots.
#pragma once

#include <cmath>
#include <cstddef>
#include <type_traits>

#include "sizes.hpp"
#include "tangents.hpp"

namespace {

// A controller may have no arithmetic but that of floats: tangents are those of its own library
// then, unless answers are to be the same everywhere.
#if defined(ADAGEN_REPRODUCIBLE)
constexpr bool kOwnTangents = true;
#else
constexpr bool kOwnTangents = std::is_same_v<Real, double>;
#endif

[[maybe_unused]] inline Real embedded_tangent(Real x) {
  if constexpr (kOwnTangents)
    return hyperbolic_tangent(x);
  else
    return std::tanh(x);
}

// Hyperbolic tangents that friction asks for, one by one.
template <std::size_t count, std::size_t filled>
inline void take_tangents(const Real* v, const Tangents<count, filled>& of, Real* found) {
  for (std::size_t k = 0; k < count; ++k)
    found[k] = embedded_tangent(v[of.place[k]] * of.factor[k]);
}

}  // namespace
