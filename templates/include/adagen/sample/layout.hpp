// adagen's runtime, the same for all robots.
// A solver says this itself (ADAGEN_SOLVER). Read alone, headers take it of a sample.
#pragma once
#if !defined(ADAGEN_SOLVER)

#include <array>

#include "../kernels/tables.hpp"
#include "sizes.hpp"

namespace {

constexpr std::array<LinkInertia, kJointCount> kInertias{};
constexpr int kSlotCount = 4, kTile = 16, kBlockKindCount = 0;
constexpr int kBlockKinds[]{0}, kFirstOfKind[]{0};
constexpr bool kInLanes = true, kPrescribedInLanes = false, kReordered = false, kByColumns = true;
constexpr int kSlots[kJointCount]{0, 1, 2, 3};
constexpr bool kAnyTurned = true, kAnyTurnedIfLost = true;
constexpr bool kTurned[kJointCount]{}, kTurnedIfLost[kJointCount]{};
constexpr double kLosing = 1e6;
constexpr bool kPassesFree = true, kAgain = true;
constexpr bool kFloats = true;  // whether a base floats
constexpr Real kUnit = 1e-15;
constexpr LinkRole kRoles[2][kLinkCount]{};

}  // namespace

#endif
