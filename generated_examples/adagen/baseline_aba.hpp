// adagen's runtime, the same for all robots.
#pragma once

#include <array>
#include <cstddef>

#include "baseline.hpp"
#include "baseline_kinematics.hpp"
#include "constants.hpp"
#include "joins.hpp"
#include "memory.hpp"
#include "sample/channel.hpp"
#include "sample/robot.hpp"
#include "sample/textbook.hpp"
#include "sizes.hpp"
#include "spatial.hpp"
#include "status.hpp"

namespace {

// The articulated-body algorithm (Featherstone 2008, Table 7.1).
template <class Kind>
void accelerate_child(Workspace& w, int j, Body& body, const JointConstants& joint) {
  constexpr int n = kFree<Kind>;
  body.a = carried(w, joint, body);
  std::array<std::array<Real, kColumns>, n> qdd;
  for (int k = 0; k < n; ++k) {
    qdd[k] = body.u[k];
    for (int l = 0; l < 6; ++l) qdd[k][0] -= body.E[k][l] * body.a(l, 0);
  }
  for (int k = 0; k < n; ++k) body.a(Kind::Free::row[k], 0) += qdd[k][0];
  store_acceleration(w, j, joint.v, qdd);
}

void run_0(Workspace& w, Channel&) {
  start(w);
  for (int j = kJointCount - 1; j >= 0; --j) {
    const JointConstants& joint = kJoints[static_cast<std::size_t>(j)];
    Body& body = w.body[static_cast<std::size_t>(j)];
    with_kind(joint.kind, [&](auto kind) {
      Columns6 force;
      if (!hand_on<decltype(kind)>(body, w.tau + joint.v, force)) fail(w, kFactorization, j);
      if (joint.parent == 0) return;
      Body& parent = w.body[static_cast<std::size_t>(joint.parent - 1)];
      give(body, parent);
      parent.p += body.X.transposed_times(force);
    });
  }
  for (int j = 0; j < kJointCount; ++j) {
    const JointConstants& joint = kJoints[static_cast<std::size_t>(j)];
    with_kind(joint.kind, [&](auto kind) {
      accelerate_child<decltype(kind)>(w, j, w.body[static_cast<std::size_t>(j)], joint);
    });
  }
}

}  // namespace
