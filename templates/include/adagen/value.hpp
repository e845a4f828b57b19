// adagen's runtime, the same for all robots.
#pragma once

#include "sizes.hpp"

namespace {

// Numbers side by side, as many as the widest registers hold; narrower machines take them in parts.
[[maybe_unused]] constexpr int kLanes = 64 / static_cast<int>(sizeof(Real));
typedef Real Lanes __attribute__((vector_size(64)));

#if defined(ADAGEN_BATCH) && !defined(ADAGEN_STATE_BY_STATE)
using Value = Lanes;  // what is computed with: one state in each lane
#else
using Value = Real;  // what is computed with
#endif

}  // namespace
