// adagen's runtime, the same for all robots.
#pragma once

#include <cstddef>

#include "registers.hpp"
#include "sizes.hpp"

namespace {

#if defined(ADAGEN_BATCH) && !defined(ADAGEN_STATE_BY_STATE)
constexpr std::size_t kLaneBytes = kRegisterBytes;  // one state in each lane
#else
constexpr std::size_t kLaneBytes = 64;  // as the plan has it; narrower machines take them in parts
#endif

// Numbers side by side.
[[maybe_unused]] constexpr int kLanes = static_cast<int>(kLaneBytes / sizeof(Real));
using Lanes = SideBySide<Real, kLanes>::T;
using Two = SideBySide<Real, 2>::T;
using Four = SideBySide<Real, 4>::T;
using Eight = SideBySide<Real, 8>::T;

#if defined(ADAGEN_BATCH) && !defined(ADAGEN_STATE_BY_STATE)
using Value = Lanes;  // what is computed with
#else
using Value = Real;  // what is computed with
#endif

}  // namespace
