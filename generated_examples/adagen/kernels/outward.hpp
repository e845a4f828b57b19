// adagen's runtime, the same for all robots.
#pragma once

#include "../constants.hpp"
#include "../gravity.hpp"
#include "../sample/robot.hpp"
#include "../sizes.hpp"
#include "../value.hpp"
#include "algebra.hpp"
#include "blocks.hpp"
#include "guards.hpp"
#include "kinds.hpp"
#include "lanes.hpp"
#include "links.hpp"
#include "memory.hpp"

namespace {

// From the base outwards: where links are and how they would move without joint accelerations.

ADAGEN_INLINE Frame<Value> frame_of(Workspace& w, int joint) {
  const Value* R = w.of(joint, kAxes);
  return {matrix_at(R), vector_at(w.of(joint, kOmega)), vector_at(w.of(joint, kAlpha)),
          vector_at(w.of(joint, kAcceleration))};
}

template <class T>
ADAGEN_INLINE void keep(Workspace& w, int slot, const Frame<T>& frame) {
  put_at(w.at(slot, kAxes), frame.R);
  put_at(w.at(slot, kOmega), frame.omega);
  put_at(w.at(slot, kAlpha), frame.alpha);
  put_at(w.at(slot, kAcceleration), frame.a);
}

// The ground accelerates against gravity: accelerations are relative to free fall.
ADAGEN_INLINE Frame<Value> ground(const Workspace& w) {
  const Value one = Value{} + 1, none{};
  return {{{one, none, none}, {none, one, none}, {none, none, one}},
          {none, none, none},
          {none, none, none},
          {none - Real(gravity(w, 0)), none - Real(gravity(w, 1)), none - Real(gravity(w, 2))}};
}

// The axes of a floating base are the link's own: only gravity is turned.
template <int j>
void free_base_frame(Workspace& w) {
  constexpr const JointConstants& joint = kJoints[j];
  const Value* q = w.q + joint.q + 3;
  Matrix<Value> turn;
  require_length(w, rotation(q[0], q[1], q[2], q[3], turn), j);
  Frame<Value> frame = ground(w);
  const Vector<Real> down{Real(gravity(w, 0)), Real(gravity(w, 1)), Real(gravity(w, 2))};
  const Number* const P = joint.rotation;
  const auto along = [&](int k) {
    return Real(P[k] * down.x + P[3 + k] * down.y + P[6 + k] * down.z);
  };
  const Vector<Real> fixed{along(0), along(1), along(2)};
  const Value none{};
  frame.a = -transposed_times(turn, Vector<Value>{none + fixed.x, none + fixed.y, none + fixed.z});
  const Value* v = w.v + joint.v + 3;
  frame.omega = {v[0], v[1], v[2]};
  keep(w, slot_of(j), frame);
}

ADAGEN_INLINE Matrix<Real> placement(const JointConstants& joint) {
  const auto row = [P = joint.rotation](int k) {
    return Vector<Real>{Real(P[k]), Real(P[k + 1]), Real(P[k + 2])};
  };
  return {row(0), row(3), row(6)};
}

// One joint, or one in each lane, outwards from the parent link's frame; what a joint is treated
// with later is kept.
template <bool kept, class T>
ADAGEN_INLINE void step_outward(Workspace& w, const Joints<T>& joints, JointKind kind,
                                Frame<T>& at) {
  const JointConstants& joint = joints.any();
  const auto moved = [&](const Value* x, int JointConstants::* place) {
    return each(joints, [&](const JointConstants& own) { return x[own.*place]; });
  };
  const Matrix<T> R = at.R * matrix_at<T>(w.at(joints.slot, kTurn));
  const Vector<T> axis{R.x.z, R.y.z, R.z.z};
  Vector<T> r = at.R * origin_of(joints);
  const Vector<T> omega = at.omega;
  const auto turn_with = [&](const Vector<T>& relative) {
    at.omega += relative;
    return cross(omega, relative);
  };
  const auto ride_along = [&] {
    at.a += cross(omega, cross(omega, r));
    at.a += cross(at.alpha, r);
  };
  const auto slide_and_spin = [&](const Vector<T>& q, const Vector<T>& slide,
                                  const Vector<T>& spin) {
    const Matrix<Real> P = placement(joint);
    r += at.R * Vector<T>{dot(q, P.x), dot(q, P.y), dot(q, P.z)};
    ride_along();
    at.a += cross(omega + omega + spin, slide);
    at.alpha += turn_with(spin);
  };
  switch (kind) {
    case JointKind::kRevolute:
      ride_along();
      at.alpha += turn_with(axis * moved(w.v, &JointConstants::v));
      break;
    case JointKind::kPrismatic: {
      r += axis * moved(w.q, &JointConstants::q);
      ride_along();
      const T v = moved(w.v, &JointConstants::v);
      at.a += cross(omega, axis * (v + v));
      break;
    }
    case JointKind::kSpherical:
      ride_along();
      if constexpr (kAnySpherical)
        at.alpha += turn_with(R * each_vector(joints, w.v, &JointConstants::v));
      break;
    case JointKind::kPlanar:
      if constexpr (kAnyPlanar && kWidth<T> == 1) {
        const Value *q = w.q + joint.q, *v = w.v + joint.v;
        const Vector<T> x{R.x.x, R.y.x, R.z.x}, y{R.x.y, R.y.y, R.z.y};
        slide_and_spin(Vector<T>{q[0], q[1], T{}}, x * v[0] + y * v[1], axis * v[2]);
      }
      break;
    case JointKind::kFloating:
      if constexpr (kAnyFloating && kWidth<T> == 1) {
        const Value *q = w.q + joint.q, *v = w.v + joint.v;
        slide_and_spin(Vector<T>{q[0], q[1], q[2]}, R * Vector<T>{v[0], v[1], v[2]},
                       R * Vector<T>{v[3], v[4], v[5]});
      }
      break;
  }
  at.R = R;
  if constexpr (!kept) return;
  w.memory(joints).r = r;
  if constexpr (kWithAxis<T>) w.memory(joints).axis = axis;
  keep(w, joints.slot, at);
}

// The frame of the link that a joint is on.
template <int j>
ADAGEN_INLINE Frame<Value> frame_near(Workspace& w) {
  constexpr int parent = kJoints[j].parent - 1;
  return parent < 0 ? ground(w) : frame_of(w, parent < 0 ? 0 : parent);
}

// Joints first .. last, each on the link of the one before.
template <int first, int last>
void outward(Workspace& w) {
  Frame<Value> at = frame_near<first>(w);
  each_row<RunRows<first, last>, false>(
      [&](int k, auto kind) ADAGEN_ALWAYS { step_outward<true>(w, single(first + k), kind, at); });
}

// The same on the way to joints that are treated: only the last link's frame is kept.
template <int first, int last>
void pass_outward(Workspace& w) {
  Frame<Value> at = frame_near<first>(w);
  each_row<RunRows<first, last>, false>(
      [&](int k, auto kind) ADAGEN_ALWAYS { step_outward<false>(w, single(first + k), kind, at); });
  keep(w, slot_of(last), at);
}

}  // namespace
