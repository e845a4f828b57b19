// adagen's runtime, the same for all robots.
#pragma once

#include <cstddef>

#include "sizes.hpp"
#include "take_tangents.hpp"
#include "tangents.hpp"
#include "unrolled_sines.hpp"

namespace {

// In registers as wide as those of as many angles.
template <std::size_t count, std::size_t filled>
ADAGEN_INLINE void take_tangents(const Real* v, const Tangents<count, filled>& of, Real* found) {
  take_tangents<Angles<static_cast<int>(count)>>(v, of, found);
}

}  // namespace
