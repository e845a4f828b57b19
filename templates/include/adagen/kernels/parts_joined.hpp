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
// beyond it, then each second of these pairs with the next, and so on until one chain is left.
// Mobilities stay in the axes of the base: of a hinge only the axis and two directions across it
// are needed, and what is linear needs no axes of its own.
//
// What two ends of a chain show is computed alike, so that each has a lane: a chain of several
// parts shows in the lane of its first part what its first link does, and in that of its last part
// what its last link does. Lanes between them hold numbers without meaning. Two chains that are
// joined meet with the last lane of one and the first lane of the other, and the chain that comes
// of them needs no number moved.

// What a part shows at its two ends: mobilities about the origins of its first and its last link.
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

// Chains, an end in each lane: its mobility, and by a wrench there (k) the acceleration of the
// other end (i).
struct Chains {
  Body<Lanes> ends;
  Lanes across[6][6];
};

// Where lanes of joined chains find what is another lane's, of chains with so many parts.
struct Places {
  LaneBits before, beyond;    // the ends that meet
  LaneBits first, last;       // the ends of what they become
  LaneBits opposite;          // the other one of these
  LaneBits is_beyond, meets;  // masks: lanes of the chain beyond, and those of ends that meet
  Lanes sign;                 // 1, of the chain beyond -1
};
template <int count, std::size_t... lane>
constexpr Places places(std::index_sequence<lane...>) {
  constexpr int both = 2 * count;
  constexpr auto start = [](std::size_t own) { return static_cast<int>(own) / both * both; };
  constexpr auto at = [](std::size_t own) { return static_cast<int>(own) % both; };
  return {LaneBits{start(lane) + count - 1 ...},
          LaneBits{start(lane) + count...},
          LaneBits{start(lane)...},
          LaneBits{start(lane) + both - 1 ...},
          LaneBits{start(lane) + both - 1 - at(lane)...},
          LaneBits{(at(lane) >= count ? -1 : 0)...},
          LaneBits{(at(lane) == count - 1 || at(lane) == count ? -1 : 0)...},
          Lanes{(at(lane) >= count ? Real(-1) : Real(1))...}};
}
template <int count>
[[maybe_unused]] constexpr Places kPlaces = places<count>(std::make_index_sequence<kPerBlock>{});

// Not by constants, as levels share their code.
ADAGEN_INLINE Vector<Lanes> moved(const Vector<Lanes>& x, const LaneBits& from) {
  return {moved(x.x, from), moved(x.y, from), moved(x.z, from)};
}
// One or the other, number by number.
template <class T>
ADAGEN_INLINE void choose(const LaneBits& first, const T& x, const T& y, T& to) {
  ADAGEN_FOR (k, 0, static_cast<int>(sizeof x / sizeof(Lanes))) {
    const std::size_t at = static_cast<std::size_t>(k) * sizeof(Lanes);
    const Lanes own = from_memory<Lanes>(reinterpret_cast<const char*>(&x) + at);
    const Lanes other = from_memory<Lanes>(reinterpret_cast<const char*>(&y) + at);
    to_memory(chosen(first, own, other), reinterpret_cast<char*>(&to) + at);
  }
}

// The torques of a row.
template <class Run, std::size_t... lane>
ADAGEN_INLINE Lanes torques(const Workspace& w, int row, std::index_sequence<lane...>) {
  return Lanes{torque(w, Run::joint(static_cast<int>(lane), row))...};
}

// What the release of joints needs, the same in all lanes of two chains that are joined but for Z
// and r: see Joined and Coupled in joins.hpp. Rows are two directions across the axis, three of
// sliding, and the axis: the last one is no constraint, but elimination of the others leaves the
// joint's acceleration there.
struct Hinges {
  Vector<Lanes> across[2], axis, r;  // r: from the end before the joint to it; beyond it zero
  Lanes tau, rotor;
};
struct JoinedLevel {
  Hinges hinges;
  Lanes L[6][6], over[6], z[6];
  Lanes Z[6][6];  // L^-1 of how a wrench on the chain's end moves the joint: [k][row]
  Lanes yields;   // 1 / (1 + D I), I the rotor's inertia: 1 without
};

ADAGEN_INLINE Vector<Lanes> angular_of(const Lanes (&x)[6]) { return {x[0], x[1], x[2]}; }
ADAGEN_INLINE Vector<Lanes> linear_of(const Lanes (&x)[6]) { return {x[3], x[4], x[5]}; }

// L D L^T of M = N (Phi_A + Phi_B) N^T, its last row with the axis, and z = L^-1 beta, from what
// the two ends that meet have of both. Positive in lanes where each pivot exceeds what it must at
// least.
ADAGEN_INLINE Lanes factorize(JoinedLevel& i, const Body<Lanes>& Phi, const Places& at) {
  constexpr Real kRounding = 8 * std::numeric_limits<Real>::epsilon();
  const Vector<Lanes>&x = i.hinges.across[0], &y = i.hinges.across[1], &s = i.hinges.axis;
  const Vector<Lanes> Cx = Phi.C * x, Cy = Phi.C * y, Cs = Phi.C * s;
  const Vector<Lanes> Bx = Phi.B * x, By = Phi.B * y, Bs = Phi.B * s;
  const Vector<Lanes> turns = Phi.f * at.sign, slides = Phi.n * at.sign;
  Lanes m[6][6]{{dot(x, Cx)},
                {dot(y, Cx), dot(y, Cy)},
                {Bx.x, By.x, Phi.A.xx},
                {Bx.y, By.y, Phi.A.xy, Phi.A.yy},
                {Bx.z, By.z, Phi.A.xz, Phi.A.yz, Phi.A.zz},
                {dot(s, Cx), dot(s, Cy), Bs.x, Bs.y, Bs.z, dot(s, Cs)}};
  Lanes beta[6]{dot(x, turns), dot(y, turns), slides.x, slides.y, slides.z, dot(s, turns)};
  ADAGEN_FOR (row, 0, 6) {
    ADAGEN_FOR (c, 0, row + 1)
      m[row][c] = moved(m[row][c], at.before) + moved(m[row][c], at.beyond);
    beta[row] = moved(beta[row], at.before) + moved(beta[row], at.beyond);
  }
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
ADAGEN_INLINE void lessen(Body<Lanes>& Phi, const Lanes (&Z)[6][6], const Lanes (&over)[6]) {
  Body<Lanes> X;
  copy(Phi, X);
  for (int row = 0; row < rows; ++row) {
    const Vector<Lanes> slide{Z[3][row], Z[4][row], Z[5][row]};
    const Vector<Lanes> turn{Z[0][row], Z[1][row], Z[2][row]};
    subtract(X, slide, turn, slide * over[row], turn * over[row]);
  }
  copy(X, Phi);
}

// What is asked of joined chains: what each end shows, and how the ends feel each other, too.
enum class Asked { kNone, kEnds, kAll };

// Joins chains with those that lie beyond them, by Eq. (3)-(7); the ends that meet are seen from
// where they lie. Rows that weigh: 6 where a joint has a rotor. One function for all levels, with
// loops: three times as much code, each run once, takes longer to fetch than to compute.
template <int rows>
ADAGEN_NOINLINE Lanes join_chains(Chains& chains, const Body<Lanes>& meeting, const Hinges& hinges,
                                  const Places& at, Asked asked, JoinedLevel& i) {
  i.hinges = {{moved(hinges.across[0], at.beyond), moved(hinges.across[1], at.beyond)},
              moved(hinges.axis, at.beyond),
              moved(hinges.r, at.beyond),
              moved(hinges.tau, at.beyond),
              moved(hinges.rotor, at.beyond)};
  Vector<Lanes>& r = i.hinges.r;
  choose(at.is_beyond, Vector<Lanes>{}, r, r);
  Body<Lanes> Phi;
  copy(meeting, Phi);
  shift(Phi, -r);
  const Lanes good = factorize(i, Phi, at);
  Lanes n[rows], bias[6];
  ADAGEN_FOR (row, 0, rows) n[row] = i.z[row] * i.over[row];
  for (int k = 0; k < 6; ++k) {
    const Lanes(&own)[6] = chains.across[k];
    Lanes x[6];
    in_rows(i.hinges, angular_of(own), linear_of(own) + cross(angular_of(own), r), x);
    bias[k] = x[5] * i.hinges.tau;
    eliminate(i, x);
    ADAGEN_FOR (row, 0, rows) bias[k] += x[row] * n[row];
    ADAGEN_FOR (row, 0, 6) i.Z[k][row] = x[row];
  }
  if (asked == Asked::kNone) return good;
  lessen<rows>(chains.ends, i.Z, i.over);
  chains.ends.f += angular_of(bias) * -at.sign, chains.ends.n += linear_of(bias) * -at.sign;
  if (asked == Asked::kEnds) return good;
  Lanes other[6][rows];
  for (int k = 0; k < 6; ++k)
    ADAGEN_FOR (row, 0, rows) other[k][row] = moved(i.Z[k][row], at.opposite);
  for (int k = 0; k < 6; ++k) {
    Lanes weighed[rows];
    ADAGEN_FOR (row, 0, rows) weighed[row] = i.Z[k][row] * i.over[row];
    for (int h = k; h < 6; ++h) {
      Lanes sum = weighed[0] * other[h][0];
      ADAGEN_FOR (row, 1, rows) sum += weighed[row] * other[h][row];
      chains.across[k][h] = sum;
      chains.across[h][k] = moved(sum, at.opposite);  // as seen from the other end
    }
  }
  return good;
}

// Eq. (8)-(10): the joints' accelerations, and the wrenches on the ends that meet, from those on
// the ends of what they have become.
template <int rows>
ADAGEN_NOINLINE Lanes release_level(const JoinedLevel& i, const Places& at,
                                    const Lanes (&wrench)[6], Lanes (&meeting)[6]) {
  Lanes right[6], n[rows];
  ADAGEN_FOR (row, 0, 6) {
    Lanes own = i.Z[0][row] * wrench[0];
    ADAGEN_FOR (k, 1, 6) own += i.Z[k][row] * wrench[k];
    right[row] = i.z[row] + (moved(own, at.first) - moved(own, at.last));
  }
  ADAGEN_FOR (row, 0, rows) n[row] = right[row] * i.over[row];
  ADAGEN_FOR (down, 0, rows - 1)
    ADAGEN_FOR (row, 0, rows - 1 - down) n[row] -= i.L[rows - 1 - down][row] * n[rows - 1 - down];
  Lanes drive = i.hinges.tau;
  if constexpr (rows > 5) drive += n[5];
  const Vector<Lanes> force = Vector<Lanes>{n[2], n[3], n[4]} * -at.sign;
  const Vector<Lanes> moment =
      (i.hinges.across[0] * n[0] + i.hinges.across[1] * n[1] + i.hinges.axis * drive) * -at.sign +
      cross(i.hinges.r, force);
  meeting[0] = moment.x, meeting[1] = moment.y, meeting[2] = moment.z;
  meeting[3] = force.x, meeting[4] = force.y, meeting[5] = force.z;
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

// Where what the joined chain shows is put: Phi and b of its first and its last link, and across;
// nothing at ends to which nothing is joined.
struct WholeChain {
  Mat6* near;
  Columns6* near_bias;
  Mat6 *far, *across;  // from the first link (rows) to the last one (columns)
  Columns6* far_bias;

  Asked asked() const {
    if (across != nullptr) return Asked::kAll;
    return near != nullptr || far != nullptr ? Asked::kEnds : Asked::kNone;
  }
};
template <int lane>
ADAGEN_INLINE void put_mobility(const Body<Lanes>& of, Mat6& Phi, Columns6& b) {
  const auto& [A, B, C, n, f] = of;
  const auto row = [](const Vector<Lanes>& x) {
    return Vector<Real>{x.x[lane], x.y[lane], x.z[lane]};
  };
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
  b << f.x[lane], f.y[lane], f.z[lane], n.x[lane], n.y[lane], n.z[lane];
}

template <class Run, int count = 1>
ADAGEN_INLINE void join_levels(Workspace& w, Chains& chains, const Body<Lanes>& meeting,
                               const Hinges& hinges, Asked asked, JoinedParts& joined) {
  if constexpr (count < kPerBlock) {
    constexpr const Places& at = kPlaces<count>;
    JoinedLevel& own = joined.levels[static_cast<std::size_t>(levels_of(count))];
    const Asked now = 2 * count < kPerBlock ? Asked::kAll : asked;
    const Lanes good = join_chains<kJoinRows<Run>>(chains, meeting, hinges, at, now, own);
    if (__builtin_expect(!all_positive(good), 0))
      fail_one(w, Run::row(0, 0), chosen(at.is_beyond & at.meets, good, Lanes{} + 1));
    join_levels<Run, 2 * count>(w, chains, chains.ends, hinges, asked, joined);
  }
}
template <int first, int last>
ADAGEN_NOINLINE JoinedParts join_parts(Workspace& w, const Ends& parts, const WholeChain& whole) {
  using Run = Strips<first, last>;
  const Joints<Lanes> row = Run::row(0, 0);
  JoinedParts joined;
  const Matrix<Lanes> R = matrix_at<Lanes>(w.at(row.slot, kAxes));
  const Hinges hinges{{{R.x.x, R.y.x, R.z.x}, {R.x.y, R.y.y, R.z.y}},
                      {R.x.z, R.y.z, R.z.z},
                      w.memory(row).r,
                      torques<Run>(w, 0, kEachLane),
                      each(row, [](const JointConstants& own) { return own.passive.rotor; })};
  constexpr const LaneBits& odd = kPlaces<1>.is_beyond;
  Chains chains;
  Body<Lanes> meeting;
  choose(odd, parts.far, parts.near, chains.ends);
  choose(odd, parts.near, parts.far, meeting);
  ADAGEN_FOR (k, 0, 6)
    ADAGEN_FOR (i, 0, 6) chains.across[k][i] = chosen(odd, parts.across[i][k], parts.across[k][i]);
  join_levels<Run>(w, chains, meeting, hinges, whole.asked(), joined);
  if (whole.near != nullptr) put_mobility<0>(chains.ends, *whole.near, *whole.near_bias);
  if (whole.far != nullptr) put_mobility<kPerBlock - 1>(chains.ends, *whole.far, *whole.far_bias);
  if (whole.across != nullptr)
    ADAGEN_FOR (k, 0, 6)
      ADAGEN_FOR (i, 0, 6) (*whole.across)(k, i) = chains.across[k][i][0];
  return joined;
}

// Wrenches on both ends of parts.
struct EndForces {
  Lanes near[6], far[6];
};
// From wrenches on the ends of chains of twice as many parts.
template <class Run, int count>
ADAGEN_INLINE EndForces release_levels(Workspace& w, const JoinedParts& joined,
                                       Lanes (&wrench)[6]) {
  constexpr const Places& at = kPlaces<count>;
  const JoinedLevel& own = joined.levels[static_cast<std::size_t>(levels_of(count))];
  Lanes meeting[6];
  const Lanes found = release_level<kJoinRows<Run>>(own, at, wrench, meeting);
  ADAGEN_FOR (lane, 0, kPerBlock)
    if (lane % (2 * count) == count) answer(w, single(Run::joint(lane, 0)), 0, found[lane]);
  if constexpr (count > 1) {
    choose(at.meets, meeting, wrench, wrench);
    return release_levels<Run, count / 2>(w, joined, wrench);
  } else {
    EndForces forces;
    choose(at.is_beyond, meeting, wrench, forces.near);
    choose(at.is_beyond, wrench, meeting, forces.far);
    return forces;
  }
}
// The wrenches on the ends of all parts, from those on the ends of the joined chain.
template <int first, int last>
ADAGEN_NOINLINE EndForces release_parts(Workspace& w, const JoinedParts& joined,
                                        const Columns6& on_near, const Columns6& on_far) {
  Lanes wrench[6]{};
  ADAGEN_FOR (k, 0, 6) wrench[k][0] = on_near[k], wrench[k][kPerBlock - 1] = on_far[k];
  return release_levels<Strips<first, last>, kPerBlock / 2>(w, joined, wrench);
}

}  // namespace
