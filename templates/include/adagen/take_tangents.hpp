// adagen's runtime, the same for all robots.
#pragma once

#include <cstddef>
#include <utility>

#include "common.hpp"
#include "kernels/lanes.hpp"
#include "registers.hpp"
#include "sizes.hpp"
#include "tangents.hpp"

namespace {

// Hyperbolic tangents that friction asks for, as many at once as T holds; of several states, T is
// not asked for. As many are written as fill registers.
template <class T, std::size_t count, std::size_t filled>
ADAGEN_INLINE void take_tangents(const Real* v, const Tangents<count, filled>& of, Real* found) {
  constexpr std::size_t width = sizeof(T) / sizeof(Real);
  static_assert(filled % width == 0);
  for (std::size_t k = 0; k < count; k += width) {
    const T rates = numbers_at<T>(v, &of.place[k], std::make_index_sequence<width>{});
    to_memory(hyperbolic_tangent(T(rates * from_memory<T>(&of.factor[k]))), found + k);
  }
}
template <class T, std::size_t count, std::size_t filled>
ADAGEN_INLINE void take_tangents(const T* v, const Tangents<count, filled>& of, T* found) {
  for (std::size_t k = 0; k < count; ++k)
    found[k] = hyperbolic_tangent(T(v[of.place[k]] * of.factor[k]));
}

}  // namespace
