// adagen's runtime, the same for all robots.
#pragma once
#if !defined(ADAGEN_SOLVER)
#define ADAGEN_SAMPLE_CUTS  // read alone, it is of a solver whose processes meet, and that refines
#endif

#include <algorithm>
#include <cstddef>

#include "../common.hpp"
#include "../constants.hpp"
#include "../sample/inertias.hpp"
#include "../sample/robot.hpp"
#include "../sizes.hpp"
#include "../spatial.hpp"
#include "../status.hpp"
#include "../value.hpp"
#include "accelerate.hpp"
#include "algebra.hpp"
#include "blocks.hpp"
#include "guards.hpp"
#include "lanes.hpp"
#include "memory.hpp"
#include "mobility.hpp"
#include "turned.hpp"

namespace {

// The ground as a body: the mobility that joints on it give a link serves as that link's inertia.

// What holds a link, as a body: Phi^-1 and -Phi^-1 b. Pivots tell whether Phi is too near to
// a singular matrix for that, angular and linear ones beside the largest of their kind.
template <int link>
void hold(Workspace& w, const Mat6& Phi, const Columns6& b) {
  constexpr Real kLeastPivot = sizeof(Real) == 8 ? Real(1e-5) : Real(1e-2);
  const Real most[2] = {std::max({Phi(0, 0), Phi(1, 1), Phi(2, 2)}),
                        std::max({Phi(3, 3), Phi(4, 4), Phi(5, 5)})};
  Real least[6];
  ADAGEN_FOR (k, 0, 6) least[k] = kLeastPivot * most[k / 3];
  Mat6 I;
  if (!invert(Phi, least, I)) return fail(w, kSingularPose, link - 1);
  Body<Value>& X = w.bodies[link];
  X.A = {I(0, 0), I(1, 0), I(2, 0), I(1, 1), I(2, 1), I(2, 2)};
  X.B = {{I(3, 0), I(4, 0), I(5, 0)}, {I(3, 1), I(4, 1), I(5, 1)}, {I(3, 2), I(4, 2), I(5, 2)}};
  X.C = {I(3, 3), I(4, 3), I(5, 3), I(4, 4), I(5, 4), I(5, 5)};
  const Columns6 f = inertia_of(X) * b;
  X.n = {-f[0], -f[1], -f[2]}, X.f = {-f[3], -f[4], -f[5]};
}

}  // namespace
