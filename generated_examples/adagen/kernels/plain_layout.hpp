// adagen's runtime, the same for all robots.
// How loops lie in memory and what they do where a source says nothing else: it derives its Layout
// from these.
#pragma once

#include "../sizes.hpp"
#include "tables.hpp"

namespace {

struct PlainLayout {
  // Memory slot of each joint and its child link, where they are reordered: limbs that share lanes,
  // and segments of long runs, are interleaved.
  static constexpr int kSlotCount = kJointCount;
  static constexpr bool kReordered = false;
  static constexpr int kSlots[kJointCount]{};
  static constexpr int kTile = 0;          // joints whose memory is in use at a time; 0: all
  static constexpr bool kInLanes = false;  // whether limbs share lanes
  static constexpr bool kPrescribedInLanes = false;  // with prescribed motions
  static constexpr bool kByColumns = false;          // whether runs are computed by columns
  // Blocks of slots with equal constants: number of kinds (0: not compared), kind of each block,
  // and first block of each kind.
  static constexpr int kBlockKindCount = 0;
  static constexpr int kBlockKinds[]{0}, kFirstOfKind[]{0};
  // Joints that are eliminated in their own axes: always, or only if the axes of the base lose
  // digits, which they do if trace > kLosing * D.
  static constexpr bool kAnyTurned = false, kAnyTurnedIfLost = false;
  static constexpr bool kTurned[kJointCount]{}, kTurnedIfLost[kJointCount]{};
  static constexpr double kLosing = 1;
  static constexpr bool kPassesFree = false;  // whether mobilities pass floating joints
  // Of solvers that sweep residuals inwards.
  static constexpr bool kFloats = false;  // whether a base floats
  static constexpr Real kUnit = 0;        // relative uncertainty of summands
};

}  // namespace
