// adagen's runtime, the same for all robots.
#pragma once
#if !defined(ADAGEN_SOLVER)
#define ADAGEN_SAMPLE_CUTS  // read alone, it is of a solver whose processes meet, and that refines
#endif

#include <array>
#include <cstddef>
#include <cstring>
#include <limits>
#include <utility>

#include "../common.hpp"
#include "../constants.hpp"
#include "../sample/robot.hpp"
#include "../sizes.hpp"
#include "../spatial.hpp"
#include "../value.hpp"
#include "accelerate.hpp"
#include "algebra.hpp"
#include "guards.hpp"
#include "lanes.hpp"
#include "links.hpp"
#include "memory.hpp"
#include "shuffles.hpp"
#include "strips.hpp"

namespace {

// The parts of a run are joined by Eq. (3)-(7) as a tree, in lanes: each even part with the one
// beyond it, then each second of these pairs with the next, and so on until one chain is left in
// the first lane. Other lanes hold numbers without meaning by then. Mobilities stay in the axes of
// the base: of a hinge only the axis and two directions across it are needed, and what is linear
// needs no axes of its own.

// What a chain shows at its two ends: mobilities about the origins of its first and its last link.
// They are shifted as bodies are, what is linear in the place of what turns: A and n are linear, C
// and f angular.
struct Ends {
  Body<Lanes> near, far;
  Lanes across[6][6];  // by a wrench on the first link (k), the last one's acceleration (i): [k][i]
};
ADAGEN_INLINE Body<Lanes> mobility_of(const Lanes (&Phi)[6][6], const Lanes (&b)[6]) {
  return {{Phi[3][3], Phi[3][4], Phi[3][5], Phi[4][4], Phi[4][5], Phi[5][5]},
          {{Phi[3][0], Phi[3][1], Phi[3][2]},
           {Phi[4][0], Phi[4][1], Phi[4][2]},
           {Phi[5][0], Phi[5][1], Phi[5][2]}},
          {Phi[0][0], Phi[0][1], Phi[0][2], Phi[1][1], Phi[1][2], Phi[2][2]},
          {b[3], b[4], b[5]},
          {b[0], b[1], b[2]}};
}

// Numbers that consist of lanes, each lane's from the one that lies so many beyond it: with a
// distance below zero, before it.
template <int distance, std::size_t... lane>
ADAGEN_INLINE Lanes moved_lanes(const Lanes& x, std::index_sequence<lane...>) {
  constexpr int n = kPerBlock;
  return shuffled<((static_cast<int>(lane) + distance + n) % n)...>(x, x);
}
template <int distance, class T>
ADAGEN_INLINE void from_lane(const T& numbers, T& to) {  // one by one: calls of memcpy take longer
  ADAGEN_FOR (k, 0, static_cast<int>(sizeof numbers / sizeof(Lanes))) {
    Lanes x;
    std::memcpy(&x, reinterpret_cast<const char*>(&numbers) + k * sizeof x, sizeof x);
    x = moved_lanes<distance>(x, std::make_index_sequence<kPerBlock>{});
    std::memcpy(reinterpret_cast<char*>(&to) + k * sizeof x, &x, sizeof x);
  }
}

// The lanes of the chains that are joined to one a distance before them.
template <int distance, std::size_t... lane>
constexpr LaneBits joined_lanes(std::index_sequence<lane...>) {
  return LaneBits{(static_cast<int>(lane) % (2 * distance) == distance ? -1 : 0)...};
}

// The torques of a row.
template <class Run, std::size_t... lane>
ADAGEN_INLINE Lanes torques(const Workspace& w, int row, std::index_sequence<lane...>) {
  return Lanes{torque(w, Run::joint(static_cast<int>(lane), row))...};
}

// What the release of joints needs, in the lanes of the chains before them: see Joined and Coupled
// in joins.hpp. Rows are two directions across the axis, three of sliding, and the axis: the last
// one is no constraint, but elimination of the others leaves the joint's acceleration there.
struct Hinges {
  Vector<Lanes> across[2], axis, r;
  Lanes tau, rotor;
};
struct JoinedLevel {
  Hinges hinges;
  Lanes L[6][6], over[6], z[6];
  Lanes near[6][6],
      far[6][6];  // L^-1 of how a wrench on the chain's ends moves the joint: [k][row]
  Lanes yields;   // 1 / (1 + D I), I the rotor's inertia: 1 without
};

ADAGEN_INLINE Vector<Lanes> angular_of(const Lanes (&x)[6]) { return {x[0], x[1], x[2]}; }
ADAGEN_INLINE Vector<Lanes> linear_of(const Lanes (&x)[6]) { return {x[3], x[4], x[5]}; }

// L D L^T of M = N (Phi_A + Phi_B) N^T, its last row with the axis, and z = L^-1 beta. Positive in
// lanes where each pivot exceeds what it must at least.
ADAGEN_INLINE Lanes factorize(JoinedLevel& i, const Body<Lanes>& Phi, const Vector<Lanes>& turns,
                              const Vector<Lanes>& slides) {
  constexpr Real kRounding = 8 * std::numeric_limits<Real>::epsilon();
  const Vector<Lanes>&x = i.hinges.across[0], &y = i.hinges.across[1], &s = i.hinges.axis;
  const Vector<Lanes> Cx = Phi.C * x, Cy = Phi.C * y, Cs = Phi.C * s;
  const Vector<Lanes> Bx = Phi.B * x, By = Phi.B * y, Bs = Phi.B * s;
  Lanes m[6][6]{{dot(x, Cx)},
                {dot(y, Cx), dot(y, Cy)},
                {Bx.x, By.x, Phi.A.xx},
                {Bx.y, By.y, Phi.A.xy, Phi.A.yy},
                {Bx.z, By.z, Phi.A.xz, Phi.A.yz, Phi.A.zz},
                {dot(s, Cx), dot(s, Cy), Bs.x, Bs.y, Bs.z, dot(s, Cs)}};
  const Lanes beta[6]{dot(x, turns), dot(y, turns), slides.x, slides.y, slides.z, dot(s, turns)};
  Lanes least[5];
  ADAGEN_FOR (c, 0, 5) least[c] = m[c][c] * kRounding;
  ADAGEN_FOR (c, 0, 6) i.z[c] = beta[c] - m[5][c] * i.hinges.tau;
  LaneBits good = ~LaneBits{};
  ADAGEN_FOR (c, 0, 5) {
    good &= (m[c][c] > least[c]) & (m[c][c] <= std::numeric_limits<Real>::max());
    i.over[c] = 1 / m[c][c];
    ADAGEN_FOR (row, c + 1, 6) {
      i.L[row][c] = m[row][c] * i.over[c];
      ADAGEN_FOR (k, c + 1, row + 1) m[row][k] -= i.L[row][c] * m[k][c];
      i.z[row] -= i.L[row][c] * i.z[c];
    }
  }
  i.yields = 1 / (1 + m[5][5] * i.hinges.rotor);
  i.over[5] = i.hinges.rotor * i.yields;
  return chosen(good, Lanes{} + 1, Lanes{} - 1);
}

// x becomes L^-1 x.
ADAGEN_INLINE void eliminate(const JoinedLevel& i, Lanes (&x)[6]) {
  ADAGEN_FOR (c, 0, 5)
    ADAGEN_FOR (row, c + 1, 6) x[row] -= i.L[row][c] * x[c];
}
// What a link's motion [angular; linear] is in the rows of a join.
ADAGEN_INLINE void in_rows(const Hinges& hinges, const Vector<Lanes>& turn,
                           const Vector<Lanes>& slide, Lanes (&x)[6]) {
  x[0] = dot(hinges.across[0], turn), x[1] = dot(hinges.across[1], turn);
  x[2] = slide.x, x[3] = slide.y, x[4] = slide.z, x[5] = dot(hinges.axis, turn);
}
// Number by number, so that it lies in registers: compilers call memcpy for a whole body.
ADAGEN_INLINE void copy(const Vector<Lanes>& from, Vector<Lanes>& to) {
  to.x = from.x, to.y = from.y, to.z = from.z;
}
ADAGEN_INLINE void copy(const Symmetric<Lanes>& from, Symmetric<Lanes>& to) {
  to.xx = from.xx, to.xy = from.xy, to.xz = from.xz;
  to.yy = from.yy, to.yz = from.yz, to.zz = from.zz;
}
ADAGEN_INLINE void copy(const Body<Lanes>& from, Body<Lanes>& to) {
  copy(from.A, to.A), copy(from.C, to.C), copy(from.n, to.n), copy(from.f, to.f);
  copy(from.B.x, to.B.x), copy(from.B.y, to.B.y), copy(from.B.z, to.B.z);
}

// Phi less Z^T D^-1 Z.
template <int rows>
ADAGEN_INLINE void lessen(const Body<Lanes>& Phi, const Lanes (&Z)[6][6], const Lanes (&over)[6],
                          Body<Lanes>& less) {
  Body<Lanes> X;
  copy(Phi, X);
  for (int row = 0; row < rows; ++row) {
    const Vector<Lanes> slide{Z[3][row], Z[4][row], Z[5][row]};
    const Vector<Lanes> turn{Z[0][row], Z[1][row], Z[2][row]};
    subtract(X, slide, turn, slide * over[row], turn * over[row]);
  }
  copy(X, less);
}

// Joins chains with those that lie beyond them, by Eq. (3)-(7). Rows that weigh: 6 where a joint
// has a rotor. One function for all levels, with loops: three times as much code, each run once,
// takes longer to fetch than to compute.
template <int rows>
ADAGEN_NOINLINE Lanes join_chains(Ends& chains, const Ends& beyond, JoinedLevel& i) {
  const Hinges& hinges = i.hinges;
  Body<Lanes> Phi;
  copy(chains.far, Phi);
  shift(Phi, -hinges.r);
  const Vector<Lanes> turns = Phi.f - beyond.near.f, slides = Phi.n - beyond.near.n;
  Phi += beyond.near;
  const Lanes good = factorize(i, Phi, turns, slides);
  Lanes n[rows], near_bias[6], far_bias[6];
  ADAGEN_FOR (row, 0, rows) n[row] = i.z[row] * i.over[row];
  for (int k = 0; k < 6; ++k) {
    const Lanes(&own)[6] = chains.across[k];
    Lanes x[6];
    in_rows(hinges, angular_of(own), linear_of(own) + cross(angular_of(own), hinges.r), x);
    near_bias[k] = x[5] * hinges.tau;
    eliminate(i, x);
    ADAGEN_FOR (row, 0, rows) near_bias[k] += x[row] * n[row];
    ADAGEN_FOR (row, 0, 6) i.near[k][row] = x[row];
  }
  for (int k = 0; k < 6; ++k) {
    const auto& own = beyond.across;
    Lanes x[6];
    in_rows(hinges, {own[0][k], own[1][k], own[2][k]}, {own[3][k], own[4][k], own[5][k]}, x);
    far_bias[k] = x[5] * hinges.tau;
    eliminate(i, x);
    ADAGEN_FOR (row, 0, rows) far_bias[k] += x[row] * n[row];
    ADAGEN_FOR (row, 0, 6) i.far[k][row] = x[row];
  }
  lessen<rows>(chains.near, i.near, i.over, chains.near);
  chains.near.f += -angular_of(near_bias), chains.near.n += -linear_of(near_bias);
  lessen<rows>(beyond.far, i.far, i.over, chains.far);
  chains.far.f += angular_of(far_bias), chains.far.n += linear_of(far_bias);
  for (int k = 0; k < 6; ++k) {
    Lanes weighed[rows];
    ADAGEN_FOR (row, 0, rows) weighed[row] = i.near[k][row] * i.over[row];
    ADAGEN_FOR (h, 0, 6) {
      chains.across[k][h] = weighed[0] * i.far[h][0];
      ADAGEN_FOR (row, 1, rows) chains.across[k][h] += weighed[row] * i.far[h][row];
    }
  }
  return good;
}

// Wrenches on both ends of chains.
struct EndForces {
  Lanes near[6]{}, far[6]{};
};

// Eq. (8)-(10): the joints' accelerations, and the wrenches on the two chains that each joined.
template <int distance, int rows>
ADAGEN_NOINLINE Lanes release_level(const JoinedLevel& i, EndForces& forces) {
  Lanes right[6], n[rows];
  ADAGEN_FOR (row, 0, 6) {
    Lanes of_near = i.near[0][row] * forces.near[0], of_far = i.far[0][row] * forces.far[0];
    ADAGEN_FOR (k, 1, 6)
      of_near += i.near[k][row] * forces.near[k], of_far += i.far[k][row] * forces.far[k];
    right[row] = i.z[row] + (of_near - of_far);
  }
  ADAGEN_FOR (row, 0, rows) n[row] = right[row] * i.over[row];
  ADAGEN_FOR (down, 0, rows - 1)
    ADAGEN_FOR (row, 0, rows - 1 - down) n[row] -= i.L[rows - 1 - down][row] * n[rows - 1 - down];
  Lanes drive = i.hinges.tau;
  if constexpr (rows > 5) drive += n[5];
  const Vector<Lanes> force{n[2], n[3], n[4]};
  const Vector<Lanes> moment =
      i.hinges.across[0] * n[0] + i.hinges.across[1] * n[1] + i.hinges.axis * drive;
  const Vector<Lanes> back = moment + cross(i.hinges.r, force);
  const Lanes on_child[6]{moment.x, moment.y, moment.z, force.x, force.y, force.z};
  const Lanes on_parent[6]{-back.x, -back.y, -back.z, -force.x, -force.y, -force.z};
  constexpr LaneBits beyond = joined_lanes<distance>(std::make_index_sequence<kPerBlock>{});
  constexpr auto lanes = std::make_index_sequence<kPerBlock>{};
  ADAGEN_FOR (k, 0, 6) {
    forces.near[k] = chosen(beyond, moved_lanes<-distance>(on_child[k], lanes), forces.near[k]);
    forces.far[k] = chosen(beyond, moved_lanes<-distance>(forces.far[k], lanes), on_parent[k]);
  }
  return -right[5] * i.yields;
}

constexpr int levels_of(int parts) { return parts > 1 ? 1 + levels_of(parts / 2) : 0; }

// All joins of a run's parts, level by level.
struct JoinedParts {
  std::array<JoinedLevel, levels_of(kPerBlock)> levels;
};

template <class Run, std::size_t... lane>
constexpr bool any_rotor(std::index_sequence<lane...>) {
  return ((kJoints[Run::joint(static_cast<int>(lane), 0)].passive.rotor != 0) || ...);
}
template <class Run>
[[maybe_unused]] constexpr int kJoinRows =
    any_rotor<Run>(std::make_index_sequence<kPerBlock>{}) ? 6 : 5;

// Where what the joined chain shows is put: Phi and b of its first link, and where more is joined
// to the last one, of that and across; nothing where not.
struct WholeChain {
  Mat6* near;
  Columns6* near_bias;
  Mat6 *far, *across;  // from the first link (rows) to the last one (columns)
  Columns6* far_bias;
};
ADAGEN_INLINE void put_mobility(const Body<Lanes>& of, Mat6& Phi, Columns6& b) {
  const auto& [A, B, C, n, f] = of;
  const auto row = [](const Vector<Lanes>& x) { return Vector<Real>{x.x[0], x.y[0], x.z[0]}; };
  const Vector<Real> linear_by_angular[3]{row(B.x), row(B.y), row(B.z)};
  const Vector<Real> linear[3]{row({A.xx, A.xy, A.xz}), row({A.xy, A.yy, A.yz}),
                               row({A.xz, A.yz, A.zz})};
  const Vector<Real> angular[3]{row({C.xx, C.xy, C.xz}), row({C.xy, C.yy, C.yz}),
                                row({C.xz, C.yz, C.zz})};
  ADAGEN_FOR (k, 0, 3) {
    const auto& [x, y, z] = linear_by_angular[k];
    Phi(k, 0) = angular[k].x, Phi(k, 1) = angular[k].y, Phi(k, 2) = angular[k].z;
    Phi(3 + k, 3) = linear[k].x, Phi(3 + k, 4) = linear[k].y, Phi(3 + k, 5) = linear[k].z;
    Phi(3 + k, 0) = Phi(0, 3 + k) = x, Phi(3 + k, 1) = Phi(1, 3 + k) = y;
    Phi(3 + k, 2) = Phi(2, 3 + k) = z;
  }
  b << f.x[0], f.y[0], f.z[0], n.x[0], n.y[0], n.z[0];
}

template <class Run, int distance = 1>
ADAGEN_INLINE void join_levels(Workspace& w, Ends& chains, const Hinges& hinges,
                               JoinedParts& joined) {
  if constexpr (distance < kPerBlock) {
    JoinedLevel& own = joined.levels[static_cast<std::size_t>(levels_of(distance))];
    from_lane<distance>(hinges, own.hinges);
    Ends further;
    from_lane<distance>(chains, further);
    const Lanes good = join_chains<kJoinRows<Run>>(chains, further, own);
    // Lanes without a chain of their own have nothing to fail.
    constexpr auto lanes = std::make_index_sequence<kPerBlock>{};
    constexpr LaneBits beyond = joined_lanes<distance>(lanes);
    const Lanes own_good = chosen(beyond, moved_lanes<-distance>(good, lanes), Lanes{} + 1);
    if (__builtin_expect(!all_positive(own_good), 0)) fail_one(w, Run::row(0, 0), own_good);
    join_levels<Run, 2 * distance>(w, chains, hinges, joined);
  }
}
template <int first, int last>
ADAGEN_NOINLINE JoinedParts join_parts(Workspace& w, Ends& chains, const WholeChain& whole) {
  using Run = Strips<first, last>;
  const Joints<Lanes> row = Run::row(0, 0);
  JoinedParts joined;
  const Matrix<Lanes> R = matrix_at<Lanes>(w.at(row.slot, kAxes));
  const Hinges hinges{{{R.x.x, R.y.x, R.z.x}, {R.x.y, R.y.y, R.z.y}},
                      {R.x.z, R.y.z, R.z.z},
                      w.memory(row).r,
                      torques<Run>(w, 0, kEachLane),
                      each(row, [](const JointConstants& own) { return own.passive.rotor; })};
  join_levels<Run>(w, chains, hinges, joined);
  put_mobility(chains.near, *whole.near, *whole.near_bias);
  if (whole.far != nullptr) {
    put_mobility(chains.far, *whole.far, *whole.far_bias);
    ADAGEN_FOR (k, 0, 6)
      ADAGEN_FOR (i, 0, 6) (*whole.across)(k, i) = chains.across[k][i][0];
  }
  return joined;
}

template <class Run, int distance>
ADAGEN_INLINE void release_levels(Workspace& w, const JoinedParts& joined, EndForces& forces) {
  if constexpr (distance > 0) {
    const JoinedLevel& own = joined.levels[static_cast<std::size_t>(levels_of(distance))];
    const Lanes found = release_level<distance, kJoinRows<Run>>(own, forces);
    ADAGEN_FOR (lane, 0, kPerBlock)
      if (lane % (2 * distance) == distance)
        answer(w, single(Run::joint(lane, 0)), 0, found[lane - distance]);
    release_levels<Run, distance / 2>(w, joined, forces);
  }
}
// The wrenches on the ends of all parts, from those on the ends of the joined chain.
template <int first, int last>
ADAGEN_NOINLINE EndForces release_parts(Workspace& w, const JoinedParts& joined,
                                        const Columns6& on_near, const Columns6& on_far) {
  EndForces forces;
  ADAGEN_FOR (k, 0, 6) forces.near[k][0] = on_near[k], forces.far[k][0] = on_far[k];
  release_levels<Strips<first, last>, kPerBlock / 2>(w, joined, forces);
  return forces;
}

}  // namespace
