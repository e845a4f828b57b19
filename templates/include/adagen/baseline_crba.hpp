// adagen's runtime, the same for all robots.
#pragma once

#include <array>
#include <cmath>
#include <cstddef>

#include "baseline.hpp"
#include "baseline_kinematics.hpp"
#include "constants.hpp"
#include "inertia.hpp"
#include "joins.hpp"
#include "memory.hpp"
#include "sample/channel.hpp"
#include "sample/robot.hpp"
#include "sizes.hpp"
#include "spatial.hpp"
#include "status.hpp"

namespace {

// Composite rigid bodies (Featherstone 2008, Table 6.2), and the joint-space inertia factorized as
// L^T L along the tree's branches (Table 6.3).

// The last degree of freedom before each one on the way to the ground, or -1.
constexpr std::array<int, kNv> kBefore = [] {
  std::array<int, kNv> result{};
  for (std::size_t j = 0; j < kJointCount; ++j) {
    const JointConstants& joint = kJoints[j];
    const std::size_t above = static_cast<std::size_t>(joint.parent) - 1;
    const int last = joint.parent == 0 ? -1 : kJoints[above].v + kJoints[above].nv - 1;
    for (int k = 0; k < joint.nv; ++k)
      result[static_cast<std::size_t>(joint.v + k)] = k == 0 ? last : joint.v + k - 1;
  }
  return result;
}();
constexpr std::array<int, kNv> kJointOf = [] {
  std::array<int, kNv> result{};
  for (int j = 0; j < kJointCount; ++j)
    for (int k = 0; k < kJoints[static_cast<std::size_t>(j)].nv; ++k)
      result[static_cast<std::size_t>(kJoints[static_cast<std::size_t>(j)].v + k)] = j;
  return result;
}();

std::array<std::array<Real, kNv>, kNv> joint_space_inertia;  // its lower triangle
std::array<Real, kNv> right_side;

// One column of H: force is the wrench for a unit acceleration of joint j in its kth direction.
inline void column_of_inertia(const Workspace& w, int j, int column, Columns6 force) {
  for (;;) {
    const JointConstants& joint = kJoints[static_cast<std::size_t>(j)];
    with_kind(joint.kind, [&](auto kind) {
      using Kind = decltype(kind);
      for (int k = 0; k < kFree<Kind> && joint.v + k <= column; ++k)
        joint_space_inertia[static_cast<std::size_t>(column)]
                           [static_cast<std::size_t>(joint.v + k)] = force(Kind::Free::row[k], 0);
    });
    if (joint.parent == 0) return;
    force = w.body[static_cast<std::size_t>(j)].X.transposed_times(force);
    j = joint.parent - 1;
  }
}

// H = L^T L in place.
inline void factorize_inertia(Workspace& w) {
  auto& H = joint_space_inertia;
  for (int k = kNv - 1; k >= 0; --k) {
    auto& row = H[static_cast<std::size_t>(k)];
    Real& pivot = row[static_cast<std::size_t>(k)];
    if (!(pivot > 0)) fail(w, kFactorization, kJointOf[static_cast<std::size_t>(k)]);
    pivot = std::sqrt(pivot);
    for (int i = kBefore[static_cast<std::size_t>(k)]; i >= 0;
         i = kBefore[static_cast<std::size_t>(i)])
      row[static_cast<std::size_t>(i)] /= pivot;
    for (int i = kBefore[static_cast<std::size_t>(k)]; i >= 0;
         i = kBefore[static_cast<std::size_t>(i)])
      for (int j = i; j >= 0; j = kBefore[static_cast<std::size_t>(j)])
        H[static_cast<std::size_t>(i)][static_cast<std::size_t>(j)] -=
            row[static_cast<std::size_t>(i)] * row[static_cast<std::size_t>(j)];
  }
}

inline void solve_inertia() {
  const auto& H = joint_space_inertia;
  auto& x = right_side;
  for (std::size_t k = kNv; k-- > 0;) {
    x[k] /= H[k][k];
    for (int i = kBefore[k]; i >= 0; i = kBefore[static_cast<std::size_t>(i)])
      x[static_cast<std::size_t>(i)] -= H[k][static_cast<std::size_t>(i)] * x[k];
  }
  for (std::size_t k = 0; k < kNv; ++k) {
    for (int i = kBefore[k]; i >= 0; i = kBefore[static_cast<std::size_t>(i)])
      x[k] -= H[k][static_cast<std::size_t>(i)] * x[static_cast<std::size_t>(i)];
    x[k] /= H[k][k];
  }
}

// Torques less those that hold the accelerations at zero (Newton and Euler), and H.
template <class Kind>
void gather(Workspace& w, int j, Body& body, const JointConstants& joint) {
  for (int k = 0; k < kFree<Kind>; ++k) {
    const int row = Kind::Free::row[k];
    right_side[static_cast<std::size_t>(joint.v + k)] = w.tau[joint.v + k] - body.p(row, 0);
    Columns6 force;
    for (int l = 0; l < 6; ++l) force(l, 0) = body.I(l, row);
    column_of_inertia(w, j, joint.v + k, force);
  }
  if (joint.parent == 0) return;
  Body& parent = w.body[static_cast<std::size_t>(joint.parent - 1)];
  parent.p += body.X.transposed_times(body.p);
  add_in_parent(body.X, body.I, parent.I);
}

void run_0(Workspace& w, Channel&) {
  start(w);
  for (int j = 0; j < kJointCount; ++j) {
    Body& body = w.body[static_cast<std::size_t>(j)];
    body.a = carried(w, kJoints[static_cast<std::size_t>(j)], body);
    for (int l = 0; l < 6; ++l)
      for (int k = 0; k < 6; ++k) body.p(l, 0) += body.I(l, k) * body.a(k, 0);
  }
  for (int j = kJointCount - 1; j >= 0; --j) {
    const JointConstants& joint = kJoints[static_cast<std::size_t>(j)];
    with_kind(joint.kind, [&](auto kind) {
      gather<decltype(kind)>(w, j, w.body[static_cast<std::size_t>(j)], joint);
    });
  }
  factorize_inertia(w);
  solve_inertia();
  for (int j = 0; j < kJointCount; ++j) {
    const JointConstants& joint = kJoints[static_cast<std::size_t>(j)];
    with_kind(joint.kind, [&](auto kind) {
      std::array<std::array<Real, kColumns>, kFree<decltype(kind)>> qdd;
      for (std::size_t k = 0; k < qdd.size(); ++k)
        qdd[k][0] = right_side[static_cast<std::size_t>(joint.v) + k];
      store_acceleration(w, j, joint.v, qdd);
    });
  }
}

}  // namespace
