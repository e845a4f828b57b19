// adagen's runtime, the same for all robots.
// A solver says this itself (ADAGEN_SOLVER). Read alone, headers take it of a sample.
#pragma once
#if !defined(ADAGEN_SOLVER)

#include <array>

#include "../kernels/plain_loops.hpp"
#include "../kernels/tables.hpp"
#include "../sizes.hpp"

namespace {

constexpr std::array<LinkInertia, kJointCount> kInertias{};

struct LoopSettings : PlainLoops<kJointCount> {
  static constexpr int kTile = 16;
  static constexpr bool kInLanes = true, kByColumns = true;
  static constexpr int kBlockKindCount = 1;  // other lengths than each other, as in solvers
  [[maybe_unused]] static constexpr int kBlockKinds[]{0, 0, 0, 0}, kFirstOfKind[]{0};
  static constexpr bool kAnyTurned = true, kAnyTurnedIfLost = true;
  static constexpr double kLosing = 1e6;
  static constexpr bool kCarriesAlong = true, kInParts = true;
  static constexpr bool kPassesFree = true, kFloats = true;
  static constexpr double kUnit = 1e-15;
};
constexpr LinkRole kRoles[2][kLinkCount]{};
[[maybe_unused]] constexpr bool kStarts[2][kJointCount]{};

}  // namespace

#endif
