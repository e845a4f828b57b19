// adagen's runtime, the same for all robots.
// What a solver's Settings say of its loops, as it is called everywhere.
#pragma once

#include "../sample/layout.hpp"
#include "../sizes.hpp"

namespace {

#if defined(ADAGEN_SOLVER)
using Layout = Settings;
#endif
constexpr int kSlotCount = Layout::kSlotCount, kTile = Layout::kTile;
constexpr bool kReordered = Layout::kReordered;
constexpr const auto& kSlots = Layout::kSlots;
constexpr bool kInLanes = Layout::kInLanes, kPrescribedInLanes = Layout::kPrescribedInLanes;
constexpr bool kByColumns = Layout::kByColumns;
constexpr int kBlockKindCount = Layout::kBlockKindCount;
[[maybe_unused]] constexpr const auto& kBlockKinds = Layout::kBlockKinds;
[[maybe_unused]] constexpr const auto& kFirstOfKind = Layout::kFirstOfKind;
constexpr bool kAnyTurned = Layout::kAnyTurned, kAnyTurnedIfLost = Layout::kAnyTurnedIfLost;
constexpr const auto& kTurned = Layout::kTurned;
constexpr const auto& kTurnedIfLost = Layout::kTurnedIfLost;
constexpr double kLosing = Layout::kLosing;
[[maybe_unused]] constexpr bool kCarriesAlong = Layout::kCarriesAlong;
constexpr bool kPassesFree = Layout::kPassesFree;
[[maybe_unused]] constexpr bool kFloats = Layout::kFloats;
[[maybe_unused]] constexpr Real kUnit = Real(Layout::kUnit);
// Whether sweeps are repeated with other forces.
constexpr bool kAgain = kWide || kSlavedCount > 0;

}  // namespace
