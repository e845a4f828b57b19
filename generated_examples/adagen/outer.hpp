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
  const Vec3 given_force = Vec3::of(w.tau + at);
  const Vec3 given_moment = Vec3::of(w.tau + at + 3);
  const Mat3 turn = Mat3::of_rows(outer.rotation);
  const Vec3 place = Vec3::of(outer.translation);
  const Vec3 force = turn * given_force;
  Columns6 result = Columns6::Zero();
  result.col(0).template head<3>() = turn * given_moment + place.cross(force);
  result.col(0).template tail<3>() = force;
  return result;
}

}  // namespace
