// adagen's runtime, the same for all robots.
#pragma once

#include <Eigen/Core>
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
  using Given = Eigen::Map<const Eigen::Matrix<Number, 3, 1>>;
  const Vec3 given_force = Given(w.tau + at).cast<Real>();
  const Vec3 given_moment = Given(w.tau + at + 3).cast<Real>();
  Mat3 turn;
  Vec3 place;
  for (int i = 0; i < 3; ++i) {
    place[i] = Real(outer.translation[i]);
    for (int c = 0; c < 3; ++c) turn(i, c) = Real(outer.rotation[3 * i + c]);
  }
  const Vec3 force = turn * given_force;
  Columns6 result = Columns6::Zero();
  result.col(0).template head<3>() = turn * given_moment + cross(place, force);
  result.col(0).template tail<3>() = force;
  return result;
}

}  // namespace
