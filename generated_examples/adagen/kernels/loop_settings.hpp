// adagen's runtime, the same for all robots.
// What a solver's Settings say of its loops, as it is called everywhere.
#pragma once

#include "../sample/loop_settings.hpp"
#include "../sizes.hpp"

namespace {

#if defined(ADAGEN_SOLVER)
using LoopSettings = Settings;
#endif
constexpr int kSlotCount = LoopSettings::kSlotCount, kTile = LoopSettings::kTile;
constexpr bool kReordered = LoopSettings::kReordered;
constexpr const auto& kSlots = LoopSettings::kSlots;
constexpr bool kInLanes = LoopSettings::kInLanes,
               kPrescribedInLanes = LoopSettings::kPrescribedInLanes;
constexpr bool kByColumns = LoopSettings::kByColumns;
constexpr int kBlockKindCount = LoopSettings::kBlockKindCount;
[[maybe_unused]] constexpr const auto& kBlockKinds = LoopSettings::kBlockKinds;
[[maybe_unused]] constexpr const auto& kFirstOfKind = LoopSettings::kFirstOfKind;
constexpr bool kAnyTurned = LoopSettings::kAnyTurned,
               kAnyTurnedIfLost = LoopSettings::kAnyTurnedIfLost;
constexpr const auto& kTurned = LoopSettings::kTurned;
constexpr const auto& kTurnedIfLost = LoopSettings::kTurnedIfLost;
constexpr double kLosing = LoopSettings::kLosing;
[[maybe_unused]] constexpr bool kCarriesAlong = LoopSettings::kCarriesAlong;
[[maybe_unused]] constexpr bool kInParts = LoopSettings::kInParts;
constexpr bool kPassesFree = LoopSettings::kPassesFree;
[[maybe_unused]] constexpr bool kFloats = LoopSettings::kFloats;
[[maybe_unused]] constexpr Real kUnit = Real(LoopSettings::kUnit);
// Whether sweeps are repeated with other forces.
constexpr bool kAgain = kWide || kSlavedCount > 0;

}  // namespace
