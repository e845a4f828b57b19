// adagen's runtime, the same for all robots.
#pragma once

#include <cstddef>
#include <cstring>
#include <utility>

#include "../common.hpp"
#include "../constants.hpp"
#include "../sample/robot.hpp"
#include "../value.hpp"
#include "algebra.hpp"
#include "blocks.hpp"
#include "columns.hpp"
#include "lanes.hpp"
#include "links.hpp"
#include "loop_settings.hpp"
#include "memory.hpp"
#include "outward.hpp"
#include "passage.hpp"
#include "scans.hpp"
#include "shuffles.hpp"

namespace {

// Outwards along a long run, cut into as many strips as a register has lanes: each lane passes
// its own. Where a strip starts from is a product of the rotations before it, and sums of what
// the joints before it add to velocities and accelerations.

// Joints first .. last, or as many of a tile that lies beyond them by some joints, so many slots
// behind (tiles.hpp). The k-th joints of all strips are a row; their slots follow each other.
// The last strips may be a joint shorter: the slots that they leave empty do not turn.
template <int first, int last>
struct Strips {
  static constexpr int kCount = last - first + 1;
  static constexpr int kRows = (kCount + kPerBlock - 1) / kPerBlock;
  static constexpr int kLonger = kCount - (kRows - 1) * kPerBlock;  // strips of kRows joints
  static constexpr int kBlock = slot_of(first) / kPerBlock;
  static constexpr int kPlace = kBlock % kWindow;  // in memory
  static constexpr const JointConstants& kFirst = kJoints[first];

  static constexpr bool filled(int lane, int row) { return row + 1 < kRows || lane < kLonger; }
  // The joint of a strip in a row, or the strip's last where the row is not filled.
  static constexpr int joint(int lane, int row) {
    return first + lane * kRows - (lane > kLonger ? lane - kLonger : 0) +
           (filled(lane, row) ? row : row - 1);
  }
  template <std::size_t... lane>
  static constexpr Joints<Lanes> row_of(int row, int beyond, std::index_sequence<lane...>) {
    return {(kBlock + row) * kPerBlock + beyond, {joint(static_cast<int>(lane), row) + beyond...}};
  }
  static constexpr Joints<Lanes> row(int k, int beyond) {
    return row_of(k, beyond, std::make_index_sequence<kPerBlock>{});
  }
  static constexpr bool all_revolute() {
    for (int j = first; j <= last; ++j)
      if (kJoints[j].kind != JointKind::kRevolute) return false;
    return true;
  }
  // Whether numbers of the state follow each other as the joints do, one each.
  static constexpr bool in_order(int JointConstants::* place) {
    for (int j = first; j <= last; ++j)
      if (kJoints[j].*place != kJoints[first].*place + j - first) return false;
    return all_revolute();
  }
  static constexpr bool kAllRevolute = all_revolute();
  static constexpr bool kAnglesInOrder = in_order(&JointConstants::q);
  static constexpr bool kSpeedsInOrder = in_order(&JointConstants::v);
};

// The origins of a row. Where g++ 12 knows all of these constants, as it does of few rows, it adds
// them to others in wrong lanes: what it reads them from is hidden from it.
ADAGEN_INLINE Vector<Lanes> origins_of(const Joints<Lanes>& row) {
  const int place = constants_at(row.slot / kPerBlock);
  const BlockConstants* block = &kBlockConstants[static_cast<std::size_t>(place)];
  asm("" : "+r"(block));
  return {number_at<Lanes>(block->x.data()), number_at<Lanes>(block->y.data()),
          number_at<Lanes>(block->z.data())};
}

// The k-th of three numbers that each joint of a row turns with; a hinge has only the last.
template <class Run, std::size_t... lane>
ADAGEN_INLINE Lanes speeds(const Workspace& w, int row, int beyond, int k,
                           std::index_sequence<lane...>) {
  const auto speed = [&](int at) -> Value {
    const int j = Run::joint(at, row) + beyond;
    if constexpr (Run::kSpeedsInOrder) return w.v[Run::kFirst.v + j - Run::joint(0, 0)];
    const JointConstants& joint = kJoints[static_cast<std::size_t>(j)];
    if (joint.kind == JointKind::kSpherical) return w.v[joint.v + k];
    return k == 2 ? w.v[joint.v] : 0;
  };
  return Lanes{(Run::filled(lane, row) ? speed(lane) : 0)...};
}
template <class Run>
ADAGEN_INLINE Vector<Lanes> spins(const Workspace& w, int row, int beyond, const Matrix<Lanes>& R) {
  const Lanes z = speeds<Run>(w, row, beyond, 2, kEachLane);
  if constexpr (Run::kAllRevolute) return Vector<Lanes>{R.x.z, R.y.z, R.z.z} * z;
  const Lanes x = speeds<Run>(w, row, beyond, 0, kEachLane);
  const Lanes y = speeds<Run>(w, row, beyond, 1, kEachLane);
  return R * Vector<Lanes>{x, y, z};
}

// Keeps r, and axes where they belong to it, of the joints of a row, those of eight lanes at a
// time.
template <class Run, int begin = 0>
ADAGEN_INLINE void keep_levers(Workspace& w, int row, int beyond, const Vector<Lanes>& axis,
                               const Vector<Lanes>& r) {
  const auto memory = [&](int lane) -> Memory& {
    return w.joints[static_cast<std::size_t>(Run::joint(lane, row) + beyond)];
  };
  if constexpr (kByColumns && kInColumns) {
    const Column x = eight<begin>(r.x), none = x - x;  // see set_up_columns
    Column levers[8]{eight<begin>(axis.x),
                     eight<begin>(axis.y),
                     eight<begin>(axis.z),
                     none,
                     x,
                     eight<begin>(r.y),
                     eight<begin>(r.z),
                     none};
    transpose(levers);
    ADAGEN_FOR (k, 0, 8)
      if (Run::filled(begin + k, row))
        std::memcpy(&memory(begin + k), &levers[k], sizeof levers[k]);
  } else {
    ADAGEN_FOR (lane, begin, begin + 8) {
      if (!Run::filled(lane, row)) continue;
      memory(lane).r = {r.x[lane], r.y[lane], r.z[lane]};
      if constexpr (kWithAxis<Value>)
        memory(lane).axis = {axis.x[lane], axis.y[lane], axis.z[lane]};
    }
  }
  if constexpr (begin + 8 < kPerBlock) keep_levers<Run, begin + 8>(w, row, beyond, axis, r);
}

// A row's numbers, from one of its blocks.
template <class Run, class Memory>
ADAGEN_INLINE auto* row_at(Memory& w, int row, Entry entry) {
  return w.blocks[static_cast<std::size_t>(Run::kPlace + row)].entries[entry];
}

// How the last link of each strip lies and moves relative to the strip's start.
template <class Run>
ADAGEN_INLINE Passage<Lanes> through_strips(Workspace& w, int beyond) {
  const Vector<Lanes> first = origins_of(Run::row(0, beyond));
  Passage<Lanes> at{matrix_at<Lanes>(row_at<Run>(w, 0, kTurn)), {}, {}, first, {}, {}};
  at.omega = spins<Run>(w, 0, beyond, at.R);
  for (int row = 1; row < Run::kRows; ++row) {
    const Vector<Lanes> r = at.R * origins_of(Run::row(row, beyond)), v = cross(at.omega, r);
    at.p += r;
    at.v += v;
    at.a += cross(at.omega, v) + cross(at.alpha, r);
    at.R = at.R * matrix_at<Lanes>(row_at<Run>(w, row, kTurn));
    const Vector<Lanes> spin = spins<Run>(w, row, beyond, at.R);
    at.alpha += cross(at.omega, spin);
    at.omega += spin;
  }
  return at;
}

// A run's passage: that of each strip's start, and of all.
struct Passages {
  Passage<Lanes> starts;
  Passage<Value> all;
};

// Places and velocities are as seen from the run's start. Seen from a start that turns, what moves
// there has the acceleration of Coriolis besides, 2 omega x v, and its spin omega x its own.
template <class Run>
ADAGEN_INLINE Passages passages_of_strips(Workspace& w, int beyond, const Frame<Value>& at) {
  const Passage<Lanes> own = through_strips<Run>(w, beyond);
  Passages found{{}, {at.R, at.omega, at.alpha, {}, {}, at.a}};
  auto& [starts, all] = found;
  starts.R = products_before(own.R, all.R);
  const Vector<Lanes> spin = starts.R * own.omega, p = starts.R * own.p, v = starts.R * own.v;
  starts.omega = sums_before(spin, all.omega);
  const Vector<Lanes> turns = starts.R * own.alpha + cross(starts.omega, spin);
  starts.alpha = sums_before(turns, all.alpha);
  const Vector<Lanes> ride = cross(starts.omega, p);
  starts.p = sums_before(p, all.p);
  starts.v = sums_before(v + ride, all.v);
  starts.a = sums_before(
      starts.R * own.a + cross(starts.alpha, p) + cross(starts.omega, ride + (v + v)), all.a);
  return found;
}

// How the strips' starts lie and move; what `at` says of the run's start becomes that of its end.
template <class Run>
ADAGEN_INLINE Frame<Lanes> starts_of_strips(Workspace& w, int beyond, Frame<Value>& at) {
  const auto [starts, all] = passages_of_strips<Run>(w, beyond, at);
  at = {all.R, all.omega, all.alpha, all.a};
  return {starts.R, starts.omega, starts.alpha, starts.a};
}

// What may be rounding of a link's bias force, as its inertia is expressed in axes of the base: the
// links' frames are not kept until they are weighed (certify_parts.hpp). The trace of an inertia
// and the length of a vector are those in any axes.
ADAGEN_INLINE Lanes units_of(const BlockConstants& constants, const Frame<Lanes>& at) {
  const Lanes trace =
      2 * (wide(constants.tensor[0]) + wide(constants.tensor[3]) + wide(constants.tensor[5]));
  const Vector<Lanes> c = wide_vector(constants.moments);
  const Lanes spin = dot(at.omega, at.omega);
  const Lanes turning = dot(at.alpha, at.alpha) + spin * spin;
  return trace * trace * turning + dot(c, c) * dot(at.a, at.a);
}

// The links' frames, left in their blocks, from how the strips' starts lie and move. Where strips
// are parts (parts.hpp), their links are set up at once, from registers: storing frames would take
// longer than the work on them. Then a link keeps its axis alone, unless others ask for its frame:
// joints at which parts are joined, what hangs on the run, and outer forces.
template <class Run, bool in_parts = false>
ADAGEN_INLINE void along_strips(Workspace& w, int beyond, const Frame<Lanes>& starts) {
  Frame<Lanes> at = starts;
  auto& [R, omega, alpha, a] = at;
  for (int row = 0; row < Run::kRows; ++row) {
    const Vector<Lanes> r = R * origins_of(Run::row(row, beyond));
    a += cross(omega, cross(omega, r)) + cross(alpha, r);
    R = R * matrix_at<Lanes>(row_at<Run>(w, row, kTurn));
    const Vector<Lanes> relative = spins<Run>(w, row, beyond, R), axis{R.x.z, R.y.z, R.z.z};
    alpha += cross(omega, relative);
    omega += relative;
    if (!in_parts || kOuterCount > 0 || row == 0 || row + 2 >= Run::kRows) {
      put_at(row_at<Run>(w, row, kAxes), R), put_at(row_at<Run>(w, row, kOmega), omega);
      put_at(row_at<Run>(w, row, kAlpha), alpha), put_at(row_at<Run>(w, row, kAcceleration), a);
    } else {
      put_axis_at(row_at<Run>(w, row, kAxes), axis);
    }
    if constexpr (in_parts && kWeighed)
      put_at(row_at<Run>(w, row, kTakenUnits), units_of(w.constants_of(Run::kBlock + row), at));
    if constexpr (in_parts) {
      set_up_block(w.blocks[static_cast<std::size_t>(Run::kPlace + row)],
                   w.constants_of(Run::kBlock + row), at);
      w.memory(Run::row(row, beyond)).r = r;
    }
    if (!in_parts || row == 0) keep_levers<Run>(w, row, beyond, axis, r);
  }
}

// Whether a run hangs on the ground, which does not turn: what is seen from there needs no more
// than gravity, and nobody asks where it is or how fast it goes, only how it turns and accelerates.
template <int first>
[[maybe_unused]] constexpr bool kFromGround = kJoints[first].parent == 0;

// The same, where the strips' starts are known as seen from the run's.
template <class Run, bool in_parts, bool from_ground>
ADAGEN_INLINE void along_traversed(Workspace& w, const Passage<Lanes>& starts,
                                   const Frame<Value>& at) {
  const Vector<Lanes> free = in_all_lanes(at.a);
  if constexpr (from_ground)
    return along_strips<Run, in_parts>(w, 0,
                                       {starts.R, starts.omega, starts.alpha, free + starts.a});
  const Matrix<Lanes> base{in_all_lanes(at.R.x), in_all_lanes(at.R.y), in_all_lanes(at.R.z)};
  const Vector<Lanes> turning = in_all_lanes(at.omega), spin = base * starts.omega;
  const Vector<Lanes> p = base * starts.p, v = base * starts.v;
  along_strips<Run, in_parts>(w, 0,
                              {base * starts.R, turning + spin,
                               in_all_lanes(at.alpha) + base * starts.alpha + cross(turning, spin),
                               free + base * starts.a + cross(in_all_lanes(at.alpha), p) +
                                   cross(turning, cross(turning, p) + (v + v))});
}

// See outward and pass_outward in outward.hpp, and take_angles in links.hpp. Functions of their
// own: as part of a large one, gcc 12 spills what is carried along.
template <int first, int last, bool in_parts = false>
ADAGEN_NOINLINE void outward_in_strips(Workspace& w) {
  using Run = Strips<first, last>;
  Frame<Value> at = frame_near<first>(w);
  along_strips<Run, in_parts>(w, 0, starts_of_strips<Run>(w, 0, at));
}
template <int first, int last>
ADAGEN_NOINLINE void pass_outward_in_strips(Workspace& w) {
  Frame<Value> at = frame_near<first>(w);
  starts_of_strips<Strips<first, last>>(w, 0, at);
  keep(w, slot_of(last), at);
}
// The same as seen from the link that they hang on, were that at rest, and then for the links
// themselves as that moves.
template <int first, int last>
ADAGEN_NOINLINE Passage<Lanes> traverse_in_strips(Workspace& w, Passage<Value>& own) {
  const Value one = Value{} + 1, none{};
  const Frame<Value> still{{{one, none, none}, {none, one, none}, {none, none, one}}, {}, {}, {}};
  Passages found = passages_of_strips<Strips<first, last>>(w, 0, still);
  if constexpr (kFromGround<first>) {
    found.all.p = found.all.v = Vector<Value>{};
    found.starts.p = found.starts.v = Vector<Lanes>{};
  }
  own = found.all;
  return found.starts;
}
template <int first, int last, bool in_parts = false>
ADAGEN_NOINLINE void outward_traversed(Workspace& w, const Passage<Lanes>& starts) {
  along_traversed<Strips<first, last>, in_parts, kFromGround<first>>(w, starts,
                                                                     frame_near<first>(w));
}
template <int first, int last>
void take_angles_in_strips(Workspace& w, int beyond = 0) {
  using Run = Strips<first, last>;
  if constexpr (!Run::kAnglesInOrder) return take_angles<first, last>(w);
  const Value* const q = w.q + beyond;
  for (int row = 0; row < Run::kRows; ++row) {
    Value* const angles = &w.angle[static_cast<std::size_t>((Run::kPlace + row) * kPerBlock)];
    ADAGEN_FOR (lane, 0, kPerBlock)
      if (Run::filled(lane, row)) angles[lane] = q[Run::kFirst.q + Run::joint(lane, row) - first];
  }
}

}  // namespace
