// adagen's runtime, the same for all robots.
#pragma once

#include <array>
#include <cstddef>

#include "../constants.hpp"
#include "../sample/robot.hpp"
#include "../sizes.hpp"
#include "../value.hpp"
#include "algebra.hpp"
#include "lanes.hpp"
#include "loop_settings.hpp"
#include "tables.hpp"

namespace {

// Constants of the model. What is set up for many links at once lies in blocks, side by side.
constexpr int kPerBlock = static_cast<int>(sizeof(Lanes) / sizeof(Value));  // links in a block
constexpr int kBlockCount = (kSlotCount + kPerBlock - 1) / kPerBlock;

constexpr int slot_of(int j) { return kReordered ? kSlots[j] : j; }

// A number of each joint of a block, as constants of the model are kept.
using PerJoint = std::array<Real, sizeof(Value) == sizeof(Real) ? kPerBlock : 1>;

struct alignas(64) BlockConstants {
  PerJoint rotation[kTile > 0 ? 9 : 6];  // joint frame to parent link's axes: columns x, y, and z
                                         // in tiles
  PerJoint x, y, z;                      // of the joint's origin in the parent link's frame
  PerJoint mass, moments[3], tensor[6];
};

constexpr void fill(PerJoint& numbers, Real x) {
  for (Real& number : numbers) number = x;
}

// Equal blocks share their constants: the index of a block's constants, and a block that has them.
constexpr int constants_at(int block) { return kBlockKindCount > 0 ? kBlockKinds[block] : block; }
constexpr bool has_own_constants(int block) {
  return kBlockKindCount == 0 || kFirstOfKind[kBlockKinds[block]] == block;
}
constexpr int kConstantsCount = kBlockKindCount > 0 ? kBlockKindCount : kBlockCount;
constexpr std::array<BlockConstants, kConstantsCount> kBlockConstants = [] {
  std::array<BlockConstants, kConstantsCount> result{};
  for (BlockConstants& block : result) {  // slots that are not filled do not turn, but weigh
    for (const int k : {0, 4}) fill(block.rotation[k], 1);
    if constexpr (kTile > 0) fill(block.rotation[8], 1);
    fill(block.mass, 1);
    for (const int k : {0, 3, 5}) fill(block.tensor[k], 1);
  }
  for (int j = 0; j < kJointCount; ++j) {
    const int place = slot_of(j) / kPerBlock;
    if (!has_own_constants(place)) continue;
    BlockConstants& block = result[static_cast<std::size_t>(constants_at(place))];
    const std::size_t lane = static_cast<std::size_t>(slot_of(j) % kPerBlock);
    const LinkInertia& link = kInertias[static_cast<std::size_t>(j)];
    const JointConstants& joint = kJoints[static_cast<std::size_t>(j)];
    for (int k = 0; k < (kTile > 0 ? 9 : 6); ++k)
      block.rotation[k][lane] = joint.rotation[k % 3 * 3 + k / 3];
    block.x[lane] = joint.translation[0];
    block.y[lane] = joint.translation[1];
    block.z[lane] = joint.translation[2];
    block.mass[lane] = link.mass;
    for (int k = 0; k < 3; ++k) block.moments[k][lane] = link.moments[k];
    for (int k = 0; k < 6; ++k) block.tensor[k][lane] = link.tensor[k];
  }
  return result;
}();

}  // namespace
