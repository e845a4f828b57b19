// adagen's runtime, the same for all robots.
#pragma once

#include <array>

#include "constants.hpp"
#include "inertia.hpp"
#include "joins.hpp"
#include "sizes.hpp"
#include "spatial.hpp"
#include "status.hpp"

#define ADAGEN_WORKSPACE  // there is one

namespace {

// Textbook algorithms as loops over the joints of any tree, beside which emitted code is judged.
// They share the kernels of rigid bodies with it, and nothing of its schedule.

// Calls the task with the joint's kind as a type.
template <class Task>
void with_kind(JointKind kind, Task task) {
  switch (kind) {
    case JointKind::kRevolute:
      return task(Revolute{});
    case JointKind::kPrismatic:
      return task(Prismatic{});
    case JointKind::kSpherical:
      return task(Spherical{});
    case JointKind::kPlanar:
      return task(Planar{});
    case JointKind::kFloating:
      return task(Floating{});
  }
}

// A joint and its child link.
struct Body {
  Transform X;
  Vec6 v;            // velocity of the link
  Columns6 c, p, a;  // velocity product, bias force, acceleration relative to free fall
  Inertia I;         // of the link, then of the articulated or the composite body
  Mat6 A;            // the same as a full matrix, where an algorithm wants that
  std::array<std::array<Real, 6>, 6> E;         // D^-1 S^T I^A
  std::array<std::array<Real, kColumns>, 6> u;  // D^-1 (tau - S^T p^A)

  EIGEN_MAKE_ALIGNED_OPERATOR_NEW
};

struct Workspace {
  const Real* q = nullptr;
  const Real* v = nullptr;
  const Real* tau = nullptr;
  Real* qdd = nullptr;
  int status = kFine;
  std::array<Body, kJointCount> body;

  EIGEN_MAKE_ALIGNED_OPERATOR_NEW
};

}  // namespace
