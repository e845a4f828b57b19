// adagen's runtime, the same for all robots.
#pragma once

#include <Eigen/Core>
#include <array>
#include <cmath>
#include <cstddef>

#include "articulated.hpp"
#include "baseline.hpp"
#include "constants.hpp"
#include "inertia.hpp"
#include "joins.hpp"
#include "memory.hpp"
#include "sample/full_matrices.hpp"
#include "sample/robot.hpp"
#include "sizes.hpp"
#include "spatial.hpp"

namespace {

const std::array<Inertia, kJointCount> kInertias = [] {
  std::array<Inertia, kJointCount> result;
  for (std::size_t j = 0; j < result.size(); ++j) result[j] = spatial_inertia(kLinks[j + 1]);
  return result;
}();

// A turn by an angle about z, joint frame to child frame.
inline Mat3 turned(Real angle) {
  const Real c = std::cos(angle), s = std::sin(angle);
  Mat3 E;
  E << c, s, 0, -s, c, 0, 0, 0, 1;
  return E;
}

// Where the joint puts its child: turn and move in the joint frame.
inline void displace(Workspace& w, int j, const Real* q, Mat3& turn, Vec3& move) {
  turn.setIdentity();
  move.setZero();
  switch (kJoints[j].kind) {
    case JointKind::kRevolute:
      turn = turned(q[0]);
      return;
    case JointKind::kPrismatic:
      move[2] = q[0];
      return;
    case JointKind::kSpherical:
      return require_length(w, conjugate_rotation(q, turn), j);
    case JointKind::kPlanar:
      turn = turned(q[2]);
      move << q[0], q[1], 0;
      return;
    case JointKind::kFloating:
      move << q[0], q[1], q[2];
      return require_length(w, conjugate_rotation(q + 3, turn), j);
  }
}

// Velocities outwards; each link starts with its own inertia and v x* I v.
inline void start(Workspace& w) {
  using Constant3 = Eigen::Map<const Eigen::Matrix<Real, 3, 3, Eigen::RowMajor>>;
  for (int j = 0; j < kJointCount; ++j) {
    const JointConstants& joint = kJoints[static_cast<std::size_t>(j)];
    Body& body = w.body[static_cast<std::size_t>(j)];
    require_finite(w, w.q + joint.q, joint.nq, j);
    require_finite(w, w.v + joint.v, joint.nv, j);
    require_finite(w, w.tau + joint.v, joint.nv, j);
    const Constant3 rotation(joint.rotation);
    Mat3 turn;
    Vec3 move;
    displace(w, j, w.q + joint.q, turn, move);
    body.X.E.noalias() = turn * rotation.transpose();
    body.X.r = Eigen::Map<const Vec3>(joint.translation) + rotation * move;
    with_kind(joint.kind, [&](auto kind) {
      using Kind = decltype(kind);
      body.v = joint_velocity<Kind>(w.v + joint.v);
      if (joint.parent > 0) body.v += body.X * w.body[static_cast<std::size_t>(joint.parent - 1)].v;
      body.c = velocity_product<Kind>(body.v, w.v + joint.v);
    });
    start_link(kInertias[static_cast<std::size_t>(j)], body.v, body.I, body.p);
    if constexpr (kFullMatrices)
      for (int r = 0; r < 6; ++r)
        for (int s = 0; s < 6; ++s) body.A(r, s) = body.I(r, s);
  }
}

// The acceleration of a joint's child as far as its parent's and c decide on it.
inline Columns6 carried(const Workspace& w, const JointConstants& joint, const Body& body) {
  if (joint.parent == 0) return body.X * ground(w) + body.c;
  return body.X * w.body[static_cast<std::size_t>(joint.parent - 1)].a + body.c;
}

}  // namespace
