// adagen's runtime, the same for all robots.
#pragma once
#if !defined(ADAGEN_SOLVER)
#define ADAGEN_SAMPLE_CUTS  // read alone, it is of a solver whose processes meet, and that refines
#endif

#include <cstddef>
#include <cstring>

#include "../common.hpp"
#include "../constants.hpp"
#include "../sample/inertias.hpp"
#include "../sample/robot.hpp"
#include "../sample/sizes.hpp"
#include "../sample/value.hpp"
#include "../spatial.hpp"
#include "../status.hpp"
#include "accelerate.hpp"
#include "algebra.hpp"
#include "blocks.hpp"
#include "guards.hpp"
#include "lanes.hpp"
#include "memory.hpp"
#include "mobility.hpp"
#include "shuffles.hpp"
#include "turned.hpp"

namespace {

// The ground as a body: what joints on it let a link do is taken for that link's inertia.

[[maybe_unused]] constexpr int freedoms(int first, int last) {
  int count = 0;
  for (int j = first; j <= last; ++j) count += kJoints[j].kind == JointKind::kSpherical ? 3 : 1;
  return count;
}

// Unit drives of joint j, each in a lane of its own from the given one on, and their mobilities, so
// that they add up to D^-1: of a spherical joint the columns of L^-T.
template <std::size_t n>
ADAGEN_INLINE void drive(const Workspace& w, int j, int lane, Vector<Lanes> (&drives)[n],
                         Lanes (&D)[n]) {
  const Value* const e = w.joints[static_cast<std::size_t>(j)].e;
  const auto unit = [&](Value x, Value y, Value z, Value mobility) {
    const int group = lane / kPerBlock, k = lane % kPerBlock;
    drives[group].x[k] = x, drives[group].y[k] = y, drives[group].z[k] = z;
    D[group][k] = mobility;
    ++lane;
  };
  if (kJoints[static_cast<std::size_t>(j)].kind != JointKind::kSpherical) {
    unit(1, 0, 0, e[7]);
  } else if constexpr (kAnySpherical) {
    const Value *const d = e + 12, *const l = d + 3;  // l: 10, 20, 21
    unit(1, 0, 0, d[0]);
    unit(-l[0], 1, 0, d[1]);
    unit(l[0] * l[2] - l[1], -l[2], 1, d[2]);
  }
}

// Phi and b of the last of joints first .. last, which hang on the ground. With g what a unit drive
// of a freedom makes the link do, Phi is the sum of g D^-1 g^T: nothing is subtracted.
template <int first, int last>
void respond(Workspace& w, Mat6& Phi, Columns6& b) {
  static_assert(sizeof(Value) == sizeof(Real));
  constexpr int kGroups = (freedoms(first, last) + kPerBlock - 1) / kPerBlock;
  Motion<Lanes> g[kGroups]{};
  Lanes D[kGroups]{};
  Motion<Value> a{};
  ADAGEN_FOR (j, first, last + 1) {
    Vector<Lanes> drives[kGroups]{};
    drive(w, j, freedoms(first, j - 1), drives, D);
    ADAGEN_FOR (k, 0, kGroups) pass<false>(w, j, g[k], drives[k]);
    move<false>(w, single(j), kJoints[j].kind, a);
  }
  b = as_told(w, last + 1, columns_of(a));
  Lanes columns[6]{};
  ADAGEN_FOR (k, 0, kGroups) {
    Lanes rows[kPerBlock]{g[k].angular.x, g[k].angular.y, g[k].angular.z,
                          g[k].linear.x,  g[k].linear.y,  g[k].linear.z};
    transpose(rows);
    ADAGEN_FOR (n, 0, kPerBlock) {
      const Lanes weighted = rows[n] * D[k][n];
      ADAGEN_FOR (i, 0, 6) columns[i] += weighted * rows[n][i];
    }
  }
  ADAGEN_FOR (i, 0, 6) std::memcpy(Phi.data() + 6 * i, &columns[i], 6 * sizeof(Real));
  if constexpr (turned_link(last + 1)) Phi = mobility_as_told(w, last + 1, Phi);
}

// What holds a link taken for a body: Phi^-1 and -Phi^-1 b. Pivots tell whether Phi is too near to
// a singular matrix for that, angular and linear ones beside the largest of their kind.
template <int link>
void hold(Workspace& w, const Mat6& Phi, const Columns6& b) {
  constexpr Real kLeastPivot = sizeof(Real) == 8 ? Real(1e-5) : Real(1e-2);
  const Real most[2] = {Phi.diagonal().template head<3>().maxCoeff(),
                        Phi.diagonal().template tail<3>().maxCoeff()};
  Real least[6];
  ADAGEN_FOR (k, 0, 6) least[k] = kLeastPivot * most[k / 3];
  Mat6 I;
  if (!invert(Phi, least, I)) return fail(w, kSingularPose, link - 1);
  Body<Value>& X = w.bodies[link];
  X.A = {I(0, 0), I(1, 0), I(2, 0), I(1, 1), I(2, 1), I(2, 2)};
  X.B = {{I(3, 0), I(4, 0), I(5, 0)}, {I(3, 1), I(4, 1), I(5, 1)}, {I(3, 2), I(4, 2), I(5, 2)}};
  X.C = {I(3, 3), I(4, 3), I(5, 3), I(4, 4), I(5, 4), I(5, 5)};
  const Columns6 p = -(inertia_of(X) * b);
  X.n = {p[0], p[1], p[2]}, X.f = {p[3], p[4], p[5]};
}

}  // namespace
