// adagen's runtime, the same for all robots.
#pragma once

#include <array>
#include <cmath>
#include <cstddef>
#include <cstring>

#include "../common.hpp"
#include "../constants.hpp"
#include "../sample/keep.hpp"
#include "../sample/robot.hpp"
#include "../sizes.hpp"
#include "algebra.hpp"
#include "blocks.hpp"
#include "columns.hpp"
#include "guards.hpp"
#include "inward.hpp"
#include "kinds.hpp"
#include "lanes.hpp"
#include "loop_settings.hpp"
#include "memory.hpp"
#include "shuffles.hpp"
#include "tables.hpp"

namespace {

// Inwards by columns: a joint takes a few instructions for each. For runs of joints that nothing
// lies beside; where no register holds a column, such runs are computed number by number.

// The joint that fills a slot.
constexpr std::array<std::size_t, kBlockCount * kPerBlock> kJointAt = [] {
  std::array<std::size_t, kBlockCount * kPerBlock> result{};
  for (std::size_t& joint : result) joint = kJointCount;
  for (int j = 0; j < kJointCount; ++j)
    result[static_cast<std::size_t>(slot_of(j))] = static_cast<std::size_t>(j);
  return result;
}();

// Where a joint's columns lie: all joints have a place, or those of a tile.
ADAGEN_INLINE constexpr std::size_t columns_place(std::size_t joint) {
  if constexpr (kTile == 0) return joint;
  return joint == kJointCount ? kColumnCount : joint % kColumnCount;
}

// What set_up_links found of the links of blocks first .. last - 1, as it is added to columns.
template <int first, int last>
void set_up_columns(Workspace& w, int beyond = 0) {
  if constexpr (!kInColumns) return;
  for (int slot = (first + beyond) * kPerBlock; slot < (last + beyond) * kPerBlock; slot += 8) {
    const auto row = [&](int entry) { return number_at<Column>(w.at(slot, entry)); };
    const auto put = [&](Real(LinkColumns::* place)[8], const Column(&found)[8]) {
      ADAGEN_FOR (k, 0, 8) {
        const std::size_t joint = kJointAt[static_cast<std::size_t>(slot + k)];
        LinkColumns& link = w.columns[kTile > 0 ? columns_place(joint) : joint];
        std::memcpy(link.*place, &found[k], sizeof found[k]);
      }
    };
    const auto& all = w.constants_of(slot / kPerBlock);
    const Column mass = number_at<Column>(&all.mass[static_cast<std::size_t>(slot % kPerBlock)]);
    const Column x = row(kMoments), y = row(kMoments + 1), z = row(kMoments + 2);
    const Column none = mass - mass;  // a zero unknown to gcc 12, which errs in shuffles with it
    constexpr int A = kRotational, n = kTorque, f = kForce;
    Column tensor[]{row(A), row(A + 1), row(A + 2), row(A + 3), row(A + 4), row(A + 5), mass, none};
    transpose(tensor);
    put(&LinkColumns::tensor, tensor);
    Column moments[]{x, y, z, -x, -y, -z, none, none};
    transpose(moments);
    put(&LinkColumns::moments, moments);
    Column force[]{row(n), row(n + 1), row(n + 2), none, row(f), row(f + 1), row(f + 2), none};
    transpose(force);
    put(&LinkColumns::force, force);
  }
}

ADAGEN_INLINE void add_bare_link(Workspace& w, int link, Columns& X) {
  const LinkColumns& own = w.columns[columns_place(static_cast<std::size_t>(link - 1))];
  const Column a = number_at<Column>(own.tensor);   // xx xy xz yy yz zz m 0
  const Column b = number_at<Column>(own.moments);  // x y z -x -y -z 0 0
  X.angular[0] += shuffled<0, 1, 2, 7, 7, 13, 9, 7>(a, b);
  X.angular[1] += shuffled<1, 3, 4, 7, 10, 7, 11, 7>(a, b);
  X.angular[2] += shuffled<2, 4, 5, 7, 12, 8, 7, 7>(a, b);
  X.linear[0] += shuffled<7, 10, 12, 7, 6, 7, 7, 7>(a, b);
  X.linear[1] += shuffled<13, 7, 8, 7, 7, 6, 7, 7>(a, b);
  X.linear[2] += shuffled<9, 11, 7, 7, 7, 7, 6, 7>(a, b);
  X.force += number_at<Column>(own.force);
}

template <int p>
ADAGEN_INLINE void meet(Workspace& w, int link, Columns& X) {
  const LinkRole role = kRoles[p][static_cast<std::size_t>(link)];
  if (role.gathers) X += columns(w.bodies[static_cast<std::size_t>(link)]);
  if (role.adds_own) add_bare_link(w, link, X);
}

// S^T x with S = [s; 0] or [0; s].
template <bool along>
ADAGEN_INLINE Real component(const Column& s, const Column& x) {
  constexpr int first = along ? 4 : 0;
  const Column part = s * x;
  return (part[first] + part[first + 1]) + part[first + 2];
}

// See eliminate in inward.hpp. With X less U U^T / D due, S^T X S is less (S^T U)^2 / D.
template <bool along, bool reversed, class Arrive>
ADAGEN_INLINE void eliminate(Workspace& w, int j, Columns& X, Due& due, const Arrive& arrive) {
  const JointConstants& joint = kJoints[static_cast<std::size_t>(j)];
  Memory& memory = w.joints[static_cast<std::size_t>(j)];
  const Vector<Real>& axis = memory.axis;
  Column both;  // [axis, -, r, -]
  std::memcpy(&both, &memory, sizeof both);
  const Column s = shuffled<0, 1, 2, 3, 0, 1, 2, 3>(both, both);
  if constexpr (reversed) both = -both;
  const Arm lever = arm(both, reversed ? -memory.r : memory.r);
  if constexpr (reversed) {
    shift(X, lever);
    due.U = carried(lever, due.U);
  }
  const Column(&side)[3] = along ? X.linear : X.angular;
  const Column V = side[0] * axis.x + side[1] * axis.y + side[2] * axis.z;
  mirror(X);  // no sooner, so that V need not wait
  const Real q = component<along>(s, due.U);
  // In this order: of a tiny robot q * q is below the least float.
  Real D = component<along>(s, V) - q * (q * due.inverse);
  if constexpr (kAnyRotor) D += joint.passive.rotor;
  const Real inverse = 1 / D;
  const Column before = due.U * due.inverse;
  subtract(X, due);
  Column U = V - before * q;
  const Real tau = torque(w, j);
  const Real u = ((reversed ? -tau : tau) - component<along>(s, X.force)) * inverse;
  constexpr int first = along ? 4 : 0;  // D beside the trace tells what digits are left
  const Real trace = side[0][first] + side[1][first + 1] + side[2][first + 2];
  if (__builtin_expect(!all_positive(D - kEnough * trace), 0)) lose(w, single(j), D, trace);
  if constexpr (!reversed) {
    shift(X, lever);
    U = carried(lever, U);
  }
  arrive(X);
  const Column e = U * inverse;
  Column kept = shuffled<0, 1, 2, 4, 5, 6, 3, 7>(e, e);
  kept[6] = u, kept[7] = inverse;
  std::memcpy(memory.e, &kept, sizeof kept);
  due = {U, inverse, std::sqrt(D) * inverse};  // the root need not wait for the division
  X.force += U * u;
}

template <bool reversed, class Arrive>
ADAGEN_INLINE void step_inward(Workspace& w, int j, JointKind kind, Columns& X, Due& due,
                               const Arrive& arrive) {
  [[maybe_unused]] const auto number_by_number = [&] {
    settle(X, due);
    Body<Real> whole = body(X);
    step_inward<reversed>(w, single(j), kind, whole, [](const Body<Real>&) {});
    X = columns(whole);
  };
  switch (kind) {
    case JointKind::kRevolute:
      eliminate<false, reversed>(w, j, X, due, arrive);
      return;
    case JointKind::kPrismatic:
      if constexpr (kAnyPrismatic) eliminate<true, reversed>(w, j, X, due, arrive);
      return;
    default:
      if constexpr (kAnySpherical || kAnyPlanar || kAnyFloating) number_by_number();
  }
  arrive(X);
}

// See inward in inward.hpp. What follows each joint is called with its number and kind; whether
// that saw how joints are eliminated in the end, which it did not where the sweep was repeated.
template <int p, int first, int last, bool starts, class Follow>
ADAGEN_INLINE bool inward_in_columns_with(Workspace& w, const Follow& follow) {
  Columns X;
  Due due;
  each_inward<p, first, last, false>(w, X, [&](int j, auto kind, auto arrive) ADAGEN_ALWAYS {
    if constexpr (kWide) keep_body(w, single(j), settled(X, due));
    step_inward<false>(w, j, kind, X, due, arrive);
    follow(j, kind);
  });
  settle(X, due);
  if constexpr (may_lose(first, last)) {
    if (__builtin_expect(w.lost, 0)) {
      inward_again<p, first, last, starts, false>(w);
      return false;
    }
  }
  constexpr int near = kJoints[first].parent;
  if constexpr (near > 0) leave<starts>(w, near, body(X));
  return true;
}
template <int p, int first, int last, bool starts>
void inward_in_columns(Workspace& w) {
  if constexpr (!kInColumns) return inward<p, first, last, starts>(w);
  inward_in_columns_with<p, first, last, starts>(w, [](int, JointKind) {});
}

// See inward_reversed in inward.hpp.
template <int p, int first, int last, bool starts>
void inward_in_columns_reversed(Workspace& w) {
  if constexpr (!kInColumns) return inward_reversed<p, first, last, starts>(w);
  Columns X;
  Due due;
  each_inward<p, first, last, true>(w, X, [&](int j, auto kind, auto arrive) ADAGEN_ALWAYS {
    if constexpr (kWide) keep_body(w, single(j), settled(X, due));
    step_inward<true>(w, j, kind, X, due, arrive);
  });
  settle(X, due);
  if constexpr (may_lose(first, last))
    if (__builtin_expect(w.lost, 0)) return inward_again<p, first, last, starts, true>(w);
  leave<starts>(w, last + 1, body(X));
}

}  // namespace
