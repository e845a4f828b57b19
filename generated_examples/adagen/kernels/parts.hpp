// adagen's runtime, the same for all robots.
#pragma once
#if !defined(ADAGEN_SOLVER)
#define ADAGEN_SAMPLE_CUTS  // read alone, it is of a solver whose processes meet, and that refines
#endif

#include <array>
#include <cstddef>
#include <cstring>
#include <limits>
#include <type_traits>
#include <utility>

#include "../common.hpp"
#include "../constants.hpp"
#include "../sample/robot.hpp"
#include "../sizes.hpp"
#include "../spatial.hpp"
#include "../value.hpp"
#include "accelerate.hpp"
#include "algebra.hpp"
#include "carry.hpp"
#include "columns.hpp"
#include "guards.hpp"
#include "inward.hpp"
#include "lanes.hpp"
#include "links.hpp"
#include "loop_settings.hpp"
#include "memory.hpp"
#include "mobility.hpp"
#include "parts_joined.hpp"
#include "shuffles.hpp"
#include "strips.hpp"

namespace {

// A long run of hinges that is parted (adagen/plan/parts.py), one part in each lane: a part is a
// strip (strips.hpp) without its first joint, by which it is joined to what is before it. So all
// parts are swept at once, and what each shows at both of its ends comes out lane by lane.

// The lanes whose strips have a joint in the last row.
template <class Run, std::size_t... lane>
constexpr LaneBits filled_lanes(std::index_sequence<lane...>) {
  return LaneBits{(Run::filled(static_cast<int>(lane), Run::kRows - 1) ? -1 : 0)...};
}

template <std::size_t... lane>
constexpr LaneBits first_lane(std::index_sequence<lane...>) {
  return LaneBits{(lane == 0 ? -1 : 0)...};
}
[[maybe_unused]] constexpr LaneBits kFirstLane = first_lane(kEachLane);

// Numbers that consist of lanes become zero in all lanes but some.
template <class T>
ADAGEN_INLINE void clear_others(const LaneBits& kept, T& numbers) {
  ADAGEN_FOR (k, 0, static_cast<int>(sizeof numbers / sizeof(Lanes))) {
    char* const own = reinterpret_cast<char*>(&numbers) + k * sizeof(Lanes);
    to_memory(chosen(kept, from_memory<Lanes>(own), Lanes{}), own);
  }
}

// Bodies beyond the joints that parts hang on by, each about its first link, without that.
template <class Run>
ADAGEN_NOINLINE Body<Lanes> inward_along_parts(Workspace& w) {
  constexpr int last = Run::kRows - 1;
  Body<Lanes> X{};
  const auto pass = [&w, &X](int row, const auto& arrive) ADAGEN_ALWAYS {
    const Joints<Lanes> joints = Run::row(row, 0);
    Eliminated<Lanes>& memory = w.memory(joints);
    const Vector<Lanes> axis = axis_at<Lanes>(w.at(joints.slot, kAxes));
    eliminate<false, false>(w, joints, X, axis, memory.r, torques<Run>(w, row, kEachLane), memory.e,
                            arrive);
  };
  const auto add_near = [&w](int row, Body<Lanes>& near)
                            ADAGEN_ALWAYS { add_bare_link(w, Run::row(row - 1, 0), near); };
  add_bare_link(w, Run::row(last, 0), X);
  pass(last, [](const Body<Lanes>&) {});
  if constexpr (Run::kLonger < kPerBlock) {  // slots that are not filled weigh, but hold no link
    constexpr LaneBits filled = filled_lanes<Run>(kEachLane);
    clear_others(filled, X);
    clear_others(filled, w.memory(Run::row(last, 0)).e);
  }
  add_near(last, X);
  for (int row = last - 1; row > 1; --row)
    pass(row, [&](Body<Lanes>& near) ADAGEN_ALWAYS { add_near(row, near); });
  pass(1, [](const Body<Lanes>&) {});
  return X;
}

// See UnitWrenches in carry.hpp: three of those on each part's last link, moments or forces.
struct ThreeWrenches {
  Vector<Lanes> n[3]{}, f[3]{};
};
template <class Run, int first>
ADAGEN_NOINLINE ThreeWrenches carry_along_parts(Workspace& w) {
  ThreeWrenches found;
  auto& [n, f] = found;
  auto& unit = first == 0 ? n : f;
  unit[0].x += 1, unit[1].y += 1, unit[2].z += 1;
  for (int row = Run::kRows - 1; row > 0; --row) {
    const Joints<Lanes> joints = Run::row(row, 0);
    const auto& [r, e] = w.memory(joints);
    const Vector<Lanes> axis = axis_at<Lanes>(w.at(joints.slot, kAxes));
    Lanes* const drives = &w.drives[static_cast<std::size_t>(joints.slot / kPerBlock)][first];
    ADAGEN_FOR (k, 0, 3) {
      const Lanes x = dot(n[k], axis);
      drives[k] = x;
      n[k] += cross(r, f[k]);
      n[k].x -= e[0] * x, n[k].y -= e[1] * x, n[k].z -= e[2] * x;
      f[k].x -= e[3] * x, f[k].y -= e[4] * x, f[k].z -= e[5] * x;
    }
  }
  return found;
}

// What wrenches on the parts' last links find on their way, once it is known what they do to each
// joint: the mobility of the last links, row by row of its upper triangle, and how they move.
struct Yields {
  Lanes own[21]{}, free[6]{};
};
template <class Run>
ADAGEN_NOINLINE Yields yields_of_parts(Workspace& w) {
  Yields found;
  auto& [own, free] = found;
  for (int row = Run::kRows - 1; row > 0; --row) {
    const Joints<Lanes> joints = Run::row(row, 0);
    const Lanes* const e = w.memory(joints).e;
    const auto& drives = w.drives[static_cast<std::size_t>(joints.slot / kPerBlock)];
    int at = 0;
    ADAGEN_FOR (i, 0, 6) {
      const Lanes by = drives[static_cast<std::size_t>(i)] * e[7];
      free[i] += drives[static_cast<std::size_t>(i)] * e[6];
      ADAGEN_FOR (k, i, 6) own[at++] += by * drives[static_cast<std::size_t>(k)];
    }
  }
  return found;
}

// What the sweep inwards of a run's parts finds: the bodies at the parts' first links, without the
// joints that these hang on, and how unit wrenches on the last ones arrive there.
struct SweptParts {
  Body<Lanes> bodies;
  ThreeWrenches moments, forces;

  // A column of L, by which a part's last link moves as its first one does: what each wrench has
  // become along one direction.
  ADAGEN_INLINE void column(int k, Lanes (&found)[6]) const {
    using V = Vector<Lanes>;
    constexpr Lanes V::* components[]{&V::x, &V::y, &V::z};
    ADAGEN_FOR (i, 0, 6) {
      const ThreeWrenches& own = i < 3 ? moments : forces;
      // Named first: where g++ checks shifts or overflow (-fsanitize=undefined), it takes another
      // place of an array that is chosen and indexed in one expression.
      const V(&arrived)[3] = k < 3 ? own.n : own.f;
      found[i] = arrived[i % 3].*components[k % 3];
    }
  }
};
template <int first, int last>
ADAGEN_NOINLINE SweptParts inward_in_parts(Workspace& w) {
  using Run = Strips<first, last>;
  static_assert(sizeof(Value) == sizeof(Real));
  SweptParts swept;
  swept.bodies = inward_along_parts<Run>(w);
  add_bare_link(w, Run::row(0, 0), swept.bodies);
  swept.moments = carry_along_parts<Run, 0>(w), swept.forces = carry_along_parts<Run, 3>(w);
  return swept;
}

// See invert in mobility.hpp: the same of a body in each lane, Phi and b = -Phi p. What is returned
// is positive in lanes where each pivot exceeds what it must at least.
ADAGEN_INLINE Lanes invert(const Body<Lanes>& X, Lanes (&Phi)[6][6], Lanes (&b)[6]) {
  constexpr Real kRounding = 8 * std::numeric_limits<Real>::epsilon();
  const auto& [A, B, C, n, f] = X;
  Lanes m[6][6]{{A.xx},
                {A.xy, A.yy},
                {A.xz, A.yz, A.zz},
                {B.x.x, B.y.x, B.z.x, C.xx},
                {B.x.y, B.y.y, B.z.y, C.xy, C.yy},
                {B.x.z, B.y.z, B.z.z, C.xz, C.yz, C.zz}};
  const Lanes p[6]{n.x, n.y, n.z, f.x, f.y, f.z};
  Lanes over[6], least[6], L[6][6]{};
  LaneBits good = ~LaneBits{};
  ADAGEN_FOR (c, 0, 6) least[c] = m[c][c] * kRounding;
  ADAGEN_FOR (c, 0, 6) {
    good &= (m[c][c] > least[c]) & (m[c][c] <= std::numeric_limits<Real>::max());
    over[c] = 1 / m[c][c];
    ADAGEN_FOR (i, c + 1, 6) {
      const Lanes l = m[i][c] * over[c];
      ADAGEN_FOR (k, c + 1, i + 1) m[i][k] -= l * m[k][c];
      ADAGEN_FOR (k, 0, c) L[i][k] -= l * L[c][k];
      L[i][c] -= l;
    }
  }
  ADAGEN_FOR (i, 0, 6)
    ADAGEN_FOR (k, 0, i + 1) {
      Lanes sum = k == i ? over[i] : over[i] * L[i][k];
      ADAGEN_FOR (row, i + 1, 6) sum += L[row][i] * over[row] * L[row][k];
      Phi[i][k] = Phi[k][i] = sum;
    }
  ADAGEN_FOR (i, 0, 6) {
    b[i] = Lanes{};
    ADAGEN_FOR (k, 0, 6) b[i] -= Phi[i][k] * p[k];
  }
  return chosen(good, Lanes{} + 1, Lanes{} - 1);
}

// Whether a run's first joint hangs on the ground, by which its first part does.
template <class Run>
[[maybe_unused]] constexpr bool kOnGround = kJoints[Run::joint(0, 0)].parent == 0;

// Phi and b of the first link of a part that hangs on the ground by its hinge: of its body X the
// hinge leaves one freedom, so that there is nothing to join. What is returned is as of invert.
template <class Run>
ADAGEN_INLINE Lanes hold_first(Workspace& w, const Body<Lanes>& X, const Lanes& good,
                               Lanes (&Phi)[6][6], Lanes (&b)[6]) {
  const Joints<Lanes> row = Run::row(0, 0);
  const Vector<Lanes> axis = axis_at<Lanes>(w.at(row.slot, kAxes)), n = X.A * axis;
  Lanes D = dot(axis, n);
  if constexpr (kAnyRotor)
    D += each(row, [](const JointConstants& joint) { return joint.passive.rotor; });
  const Lanes trace = X.A.xx + X.A.yy + X.A.zz;
  const Lanes left = chosen(kFirstLane, D - kEnough * trace, Lanes{} + 1);
  if (__builtin_expect(!all_positive(left), 0)) lose(w, row, chosen(kFirstLane, D, trace), trace);
  const Lanes inverse = 1 / D;
  const Lanes u = (torques<Run>(w, 0, kEachLane) - dot(axis, X.n)) * inverse;
  const Lanes s[3]{axis.x, axis.y, axis.z};
  ADAGEN_FOR (i, 0, 6) {
    b[i] = chosen(kFirstLane, i < 3 ? s[i % 3] * u : Lanes{}, b[i]);
    ADAGEN_FOR (k, 0, 6) {
      const Lanes held = i < 3 && k < 3 ? s[i % 3] * s[k % 3] * inverse : Lanes{};
      Phi[i][k] = chosen(kFirstLane, held, Phi[i][k]);
    }
  }
  return chosen(kFirstLane, Lanes{} + 1, good);
}

// What each part shows; nothing is joined to the last one's last link where the chain ends there.
struct ShownParts {
  Ends ends;
  Lanes Phi[6][6], b[6];  // of the first links
};
template <int first, int last>
ADAGEN_NOINLINE ShownParts show_parts(Workspace& w, const SweptParts& swept) {
  using Run = Strips<first, last>;
  ShownParts shown;
  auto& [ends, Phi, b] = shown;
  Lanes good = invert(swept.bodies, Phi, b);
  if constexpr (kOnGround<Run>) good = hold_first<Run>(w, swept.bodies, good, Phi, b);
  if (__builtin_expect(!all_positive(good), 0)) fail_one(w, Run::row(0, 0), good);
  ends.near = mobility_of(Phi, b);
  const Yields yields = yields_of_parts<Run>(w);
  Lanes L[6][6], far[6][6], far_bias[6];  // L by columns
  ADAGEN_FOR (k, 0, 6) swept.column(k, L[k]);
  ADAGEN_FOR (i, 0, 6)
    ADAGEN_FOR (k, 0, 6) {
      ends.across[k][i] = L[0][i] * Phi[0][k];
      ADAGEN_FOR (h, 1, 6) ends.across[k][i] += L[h][i] * Phi[h][k];
    }
  int at = 0;
  ADAGEN_FOR (i, 0, 6)
    ADAGEN_FOR (k, i, 6) {
      Lanes sum = yields.own[at++];
      ADAGEN_FOR (h, 0, 6) sum += ends.across[h][i] * L[h][k];
      far[i][k] = far[k][i] = sum;
    }
  ADAGEN_FOR (i, 0, 6) {
    far_bias[i] = yields.free[i];
    ADAGEN_FOR (h, 0, 6) far_bias[i] += L[h][i] * b[h];
  }
  ends.far = mobility_of(far, far_bias);
  return shown;
}

// How parts start outwards: their first links' accelerations, and the loads of their last links.
struct StartedParts {
  Motion<Lanes> first;
  Lanes load[6];
};
[[maybe_unused]] ADAGEN_NOINLINE StartedParts start_parts(const SweptParts& swept,
                                                          const ShownParts& shown,
                                                          const EndForces& forces) {
  Lanes load[6], a[6], L[6];
  ADAGEN_FOR (k, 0, 6) load[k] = forces.near[k];
  ADAGEN_FOR (k, 0, 6) {  // of the last link, as the first one feels it
    swept.column(k, L);
    ADAGEN_FOR (i, 0, 6) load[k] += L[i] * forces.far[i];
  }
  ADAGEN_FOR (i, 0, 6) {
    a[i] = shown.b[i];
    ADAGEN_FOR (k, 0, 6) a[i] += shown.Phi[i][k] * load[k];
  }
  StartedParts started{{angular_of(a), linear_of(a)}, {}};
  ADAGEN_FOR (k, 0, 6) started.load[k] = forces.far[k];
  return started;
}

// The parts' joints outwards, and what is done `with` each row and how its links move, and whether
// lanes of it are empty. Each joint takes its part of the load of its part's last link: what unit
// wrenches there did to it.
template <class Run, class With>
ADAGEN_INLINE void pass_parts_outward(Workspace& w, const StartedParts& started, const With& with) {
  Motion<Lanes> a = started.first;
  if constexpr (kOnGround<Run>) {
    const Vector<Lanes> axis = axis_at<Lanes>(w.at(Run::row(0, 0).slot, kAxes));
    answer(w, single(Run::joint(0, 0)), 0, dot(axis, a.angular)[0]);
  }
  const Lanes(&load)[6] = started.load;
  const auto pass = [&](int row, auto empty) ADAGEN_ALWAYS {
    const Joints<Lanes> joints = Run::row(row, 0);
    const auto& [r, e] = w.memory(joints);
    const auto& x = w.drives[static_cast<std::size_t>(joints.slot / kPerBlock)];
    const Vector<Lanes> axis = axis_at<Lanes>(w.at(joints.slot, kAxes));
    const Lanes driven = ((x[0] * load[0] + x[1] * load[1]) + (x[2] * load[2] + x[3] * load[3])) +
                         (x[4] * load[4] + x[5] * load[5]);
    const Lanes found = freedom(e, a) + e[7] * driven;
    carry(a, r);
    a.angular += axis * found;
    with(row, a, empty);
    return found;
  };
  const std::false_type full;
  for (int row = 1; row + 1 < Run::kRows; ++row) answer(w, Run::row(row, 0), 0, pass(row, full));
  constexpr int final_row = Run::kRows - 1;
  const Lanes found = pass(final_row, std::bool_constant<(Run::kLonger < kPerBlock)>{});
  ADAGEN_FOR (lane, 0, kPerBlock)
    if (Run::filled(lane, final_row))
      answer(w, single(Run::joint(lane, final_row)), 0, found[lane]);
}
template <int first, int last>
ADAGEN_NOINLINE void accelerate_in_parts(Workspace& w, const StartedParts& started) {
  pass_parts_outward<Strips<first, last>>(w, started,
                                          [](int, const Motion<Lanes>&, auto) ADAGEN_ALWAYS {});
}

}  // namespace
