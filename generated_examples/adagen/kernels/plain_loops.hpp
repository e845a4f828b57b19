// adagen's runtime, the same for all robots.
// What a solver in loops is, how these lie in memory and what they do where its source says nothing
// else: it derives its Settings from these.
#pragma once

#include "../settings.hpp"

namespace {

template <int joints>
struct PlainLoops : PlainSettings {
  // Memory slot of each joint and its child link, where they are reordered: limbs that share lanes,
  // and strips of long runs, are interleaved.
  [[maybe_unused]] static constexpr int kSlotCount = joints;
  [[maybe_unused]] static constexpr bool kReordered = false;
  [[maybe_unused]] static constexpr int kSlots[joints]{};
  // Joints whose memory is in use at a time; 0: all.
  [[maybe_unused]] static constexpr int kTile = 0;
  // Whether limbs share lanes.
  [[maybe_unused]] static constexpr bool kInLanes = false;
  // Whether they do with prescribed motions.
  [[maybe_unused]] static constexpr bool kPrescribedInLanes = false;
  // Whether runs are computed by columns.
  [[maybe_unused]] static constexpr bool kByColumns = false;
  // Blocks of slots with equal constants: number of kinds (0: not compared), kind of each block,
  // and first block of each kind.
  [[maybe_unused]] static constexpr int kBlockKindCount = 0;
  [[maybe_unused]] static constexpr int kBlockKinds[]{0}, kFirstOfKind[]{0};
  // Joints that are eliminated in their own axes: always, or only if the axes of the base lose
  // digits, which they do if trace > kLosing * D.
  [[maybe_unused]] static constexpr bool kAnyTurned = false, kAnyTurnedIfLost = false;
  [[maybe_unused]] static constexpr bool kTurned[joints]{}, kTurnedIfLost[joints]{};
  [[maybe_unused]] static constexpr double kLosing = 1;
  // Whether wrenches are carried through runs along with their sweep inwards.
  [[maybe_unused]] static constexpr bool kCarriesAlong = false;
  // Whether long runs are parted, and swept one part in each lane.
  [[maybe_unused]] static constexpr bool kInParts = false;
  // Whether mobilities pass floating joints.
  [[maybe_unused]] static constexpr bool kPassesFree = false;
  // Of solvers that sweep residuals inwards: whether a base floats, and ..
  [[maybe_unused]] static constexpr bool kFloats = false;
  // .. the relative uncertainty of summands.
  [[maybe_unused]] static constexpr double kUnit = 0;
};

}  // namespace
