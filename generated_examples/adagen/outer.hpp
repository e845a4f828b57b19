// adagen's runtime, the same for all robots.
#pragma once

#include <cstddef>

#include "constants.hpp"
#include "memory.hpp"
#include "sample/joints.hpp"
#include "sample/robot.hpp"
#include "sizes.hpp"
#include "spatial.hpp"

namespace {

// The wrench [moment; force] of outer force k, given as [force; moment] in tau from `at` on, on its
// link at the link's origin.
[[maybe_unused]] inline Columns6 outer_force(Workspace& w, int k, int at, int joint) {
  require_finite(w, w.tau + at, 6, joint);
  const OuterForce& outer = kOuterForces[static_cast<std::size_t>(k)];
  const Number* const given = w.tau + at;  // force, moment
  Real turned[6];
  for (int i = 0; i < 6; ++i) {
    const Number* const of = given + i / 3 * 3;
    turned[i] = 0;
    for (int c = 0; c < 3; ++c) turned[i] += Real(outer.rotation[3 * (i % 3) + c]) * Real(of[c]);
  }
  const Vec3 force(turned[0], turned[1], turned[2]);
  const Vec3 place(Real(outer.translation[0]), Real(outer.translation[1]),
                   Real(outer.translation[2]));
  const Vec3 about = cross(place, force);
  Columns6 result = Columns6::Zero();
  ADAGEN_FOR (i, 0, 3) result(i, 0) = turned[3 + i] + about[i], result(3 + i, 0) = force[i];
  return result;
}

}  // namespace
