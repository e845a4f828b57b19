// adagen's runtime, the same for all robots.
#pragma once

#include <algorithm>
#include <cstddef>

#include "../constants.hpp"
#include "../sample/robot.hpp"
#include "../value.hpp"
#include "algebra.hpp"
#include "inward.hpp"
#include "lanes.hpp"
#include "memory.hpp"

namespace {

// Joints of prescribed motion: tau holds their accelerations, and to forces they are rigid.

// S qdd of a joint, at the child link's origin.
inline Motion<Value> prescribed_motion(Workspace& w, int j) {
  const JointConstants& joint = kJoints[static_cast<std::size_t>(j)];
  const Value *const qdd = w.tau + joint.v, *const v = w.v + joint.v;
  Vector<Value> spin{}, slide{};  // in the child link's axes
  switch (joint.kind) {
    case JointKind::kRevolute:
      spin.z = qdd[0];
      break;
    case JointKind::kPrismatic:
      slide.z = qdd[0];
      break;
    case JointKind::kSpherical:
      spin = {qdd[0], qdd[1], qdd[2]};
      break;
    case JointKind::kPlanar:
      slide.x = qdd[0], slide.y = qdd[1], spin.z = qdd[2];
      break;
    case JointKind::kFloating:
      slide = {qdd[0], qdd[1], qdd[2]}, spin = {qdd[3], qdd[4], qdd[5]};
      if (joint.parent == 0)  // see as_joint_acceleration
        slide += cross(Vector<Value>{v[3], v[4], v[5]}, Vector<Value>{v[0], v[1], v[2]});
      break;
  }
  const Matrix<Value> R = matrix_at(w.of(j, kAxes));
  return {R * spin, R * slide};
}

// The force that a body needs beside its bias force to move like this at its point.
ADAGEN_INLINE void drive(Body<Value>& X, const Motion<Value>& a) {
  X.n += X.A * a.angular + X.B * a.linear;
  X.f += transposed_times(X.B, a.angular) + X.C * a.linear;
}

// Process p passes the body beyond joint j, whose motion is prescribed, to its near link.
template <int p, int j, bool starts>
void inward_prescribed(Workspace& w) {
  Body<Value> X = whole<p>(w, j + 1);
  drive(X, prescribed_motion(w, j));
  shift(X, w.joints[j].r);
  leave<starts>(w, kJoints[j].parent, X);
}

// The same where the child link is the near one.
template <int p, int j, bool starts>
void inward_prescribed_reversed(Workspace& w) {
  Body<Value> X = whole<p>(w, kJoints[j].parent);
  shift(X, -w.joints[j].r);
  const Motion<Value> a = prescribed_motion(w, j);
  drive(X, {-a.angular, -a.linear});
  leave<starts>(w, j + 1, X);
}

// The far link's acceleration from the near link's.
template <bool reversed>
void move_prescribed(Workspace& w, int j, Motion<Value>& a) {
  const Motion<Value> own = prescribed_motion(w, j);
  const Vector<Value>& r = w.joints[static_cast<std::size_t>(j)].r;
  if constexpr (reversed) {
    a.angular += -own.angular, a.linear += -own.linear;
    carry(a, -r);
  } else {
    carry(a, r);
    a.angular += own.angular, a.linear += own.linear;
  }
}

template <int p, int j>
void accelerate_prescribed(Workspace& w) {
  Motion<Value>& a = w.motions[j + 1];
  a = w.motions[kJoints[j].parent];
  move_prescribed<false>(w, j, a);
  std::copy_n(w.tau + kJoints[j].v, kJoints[j].nv, w.answer.data() + kJoints[j].v);
}

template <int p, int j>
void accelerate_prescribed_reversed(Workspace& w) {
  Motion<Value>& a = w.motions[kJoints[j].parent];
  a = w.motions[j + 1];
  move_prescribed<true>(w, j, a);
  std::copy_n(w.tau + kJoints[j].v, kJoints[j].nv, w.answer.data() + kJoints[j].v);
}

}  // namespace
