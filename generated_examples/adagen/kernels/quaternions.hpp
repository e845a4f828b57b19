// adagen's runtime, the same for all robots.
#pragma once

#include <array>
#include <cstddef>
#include <cstring>
#include <utility>

#include "../common.hpp"
#include "../constants.hpp"
#include "../sample/robot.hpp"
#include "../sizes.hpp"
#include "../value.hpp"
#include "algebra.hpp"
#include "blocks.hpp"
#include "guards.hpp"
#include "lanes.hpp"
#include "links.hpp"
#include "loop_settings.hpp"
#include "memory.hpp"
#include "tables.hpp"

namespace {

// Turns of joints with a quaternion, for as many at once as a register holds.

// Where in q the quaternion of each joint of a block begins, for those that a process turns.
// Others, which keep the turn that they have, are given that of a neighbour.
struct QuaternionPlaces {
  PerJoint own{};  // 1 for a joint with a quaternion, else 0
  std::array<int, kPerBlock> q{};
};
template <int p>
constexpr std::array<QuaternionPlaces, kBlockCount> kQuaternionPlaces = [] {
  std::array<int, kBlockCount * kPerBlock> found{};
  for (int& place : found) place = -1;
  for (int j = 0; j < kJointCount; ++j) {
    const JointConstants& joint = kJoints[static_cast<std::size_t>(j)];
    const LinkRole role = kRoles[p][static_cast<std::size_t>(j + 1)];
    if (role.oriented) found[static_cast<std::size_t>(slot_of(j))] = joint.q + joint.nq - 4;
  }
  std::array<QuaternionPlaces, kBlockCount> result{};
  int last = -1;
  for (const int place : found) last = place > last ? place : last;
  for (std::size_t slot = 0; slot < found.size(); ++slot) {
    if (found[slot] >= 0) last = found[slot];
    result[slot / kPerBlock].own[slot % kPerBlock] = found[slot] >= 0;
    result[slot / kPerBlock].q[slot % kPerBlock] = last;
  }
  return result;
}();

template <std::size_t... lane>
ADAGEN_INLINE void take_quaternions(const Workspace& w, const QuaternionPlaces& places,
                                    Lanes (&to)[4], std::index_sequence<lane...>) {
  if constexpr (kPerBlock == 1) {
    ADAGEN_FOR (k, 0, 4) to[k] = from_memory<Lanes>(w.q + places.q[0] + k);
  } else {
    const Four each[]{number_at<Four>(w.q + places.q[lane])...};
    ADAGEN_FOR (k, 0, 4) to[k] = Lanes{each[lane][k]...};
  }
}

// Tells which quaternion of a block has no length.
template <int p>
ADAGEN_COLD void refuse_quaternion(Workspace& w, int b, const Lanes& squared) {
  Value each[kPerBlock];
  to_memory(squared, each);
  for (int j = 0; j < kJointCount; ++j)
    if (slot_of(j) / kPerBlock == b && kRoles[p][static_cast<std::size_t>(j + 1)].oriented)
      require_length(w, each[slot_of(j) % kPerBlock], j);
}

// Process p turns joints of blocks first .. last - 1.
template <int p, int first, int last>
void orient(Workspace& w) {
  for (int b = first; b < last; ++b) {
    Block& block = w.blocks[static_cast<std::size_t>(b)];
    const BlockConstants& constants = kBlockConstants[static_cast<std::size_t>(constants_at(b))];
    const QuaternionPlaces& places = kQuaternionPlaces<p>[static_cast<std::size_t>(b)];
    Lanes q[4];
    take_quaternions(w, places, q, std::make_index_sequence<kPerBlock>{});
    Matrix<Lanes> turn;
    const Lanes squared = rotation(q[0], q[1], q[2], q[3], turn);
    if (__builtin_expect(!has_length(squared), 0)) refuse_quaternion<p>(w, b, squared);
    const Vector<Lanes> x = wide_vector(constants.rotation);
    const Vector<Lanes> y = wide_vector(constants.rotation + 3), z = cross(x, y);
    turn = Matrix<Lanes>{{x.x, y.x, z.x}, {x.y, y.y, z.y}, {x.z, y.z, z.z}} * turn;
    const LaneBits own = wide(places.own) != 0;
    const Vector<Lanes> rows[3] = {turn.x, turn.y, turn.z};
    ADAGEN_FOR (k, 0, 3) {
      const Vector<Lanes> kept = wide_vector(block.entries + kTurn + 3 * k);
      narrow(Vector<Lanes>{chosen(own, rows[k].x, kept.x), chosen(own, rows[k].y, kept.y),
                           chosen(own, rows[k].z, kept.z)},
             block.entries + kTurn + 3 * k);
    }
  }
}

}  // namespace
