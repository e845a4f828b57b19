// adagen's runtime, the same for all robots.
#pragma once

#include <cstddef>

#include "../constants.hpp"
#include "../sample/robot.hpp"
#include "../sizes.hpp"
#include "../status.hpp"
#include "../value.hpp"
#include "algebra.hpp"
#include "guards.hpp"
#include "lanes.hpp"
#include "memory.hpp"

namespace {

// Outer force k, given as [force; moment] in tau behind all torques, about its link's origin and in
// the link's axes.
ADAGEN_INLINE Motion<Value> force_in_link(const Workspace& w, int k) {
  const OuterForce& outer = kOuterForces[static_cast<std::size_t>(k)];
  const Value* const given = w.tau + kNv + 6 * k;
  const Real *const P = outer.rotation, *const x = outer.translation;
  const auto in_axes = [P](const Value* a) {
    return Vector<Value>{a[0] * P[0] + (a[1] * P[1] + a[2] * P[2]),
                         a[0] * P[3] + (a[1] * P[4] + a[2] * P[5]),
                         a[0] * P[6] + (a[1] * P[7] + a[2] * P[8])};
  };
  const Vector<Value> f = in_axes(given);
  Vector<Value> n = in_axes(given + 3);
  n += -cross(f, Vector<Real>{x[0], x[1], x[2]});
  return {n, f};
}

// It acts on its link: that much less bias force.
template <int k>
void push(Workspace& w) {
  constexpr int j = kOuterForces[k].link - 1;
  if (__builtin_expect(!finite(w.tau + kNv + 6 * k, 6), 0)) fail(w, kNotFinite, j);
  const Motion<Value> pushed = force_in_link(w, k);
  const Matrix<Value> R = matrix_at(w.of(j, kAxes));
  put_at(w.of(j, kTorque), vector_at(w.of(j, kTorque)) - R * pushed.angular);
  put_at(w.of(j, kForce), vector_at(w.of(j, kForce)) - R * pushed.linear);
}

// Less the outer forces on links: the k-th of their six numbers, [moment; force].
template <class T>
ADAGEN_INLINE void push_own(Workspace& w, const Joints<T>& joints, Vector<T>& n, Vector<T>& f) {
  const auto pushed = [&](int k) {
    return each(joints, [&](const JointConstants& joint) {
      Value sum{};
      for (int i = 0; i < kOuterCount; ++i) {
        const OuterForce& outer = kOuterForces[static_cast<std::size_t>(i)];
        if (&kJoints[static_cast<std::size_t>(outer.link - 1)] != &joint) continue;
        const Motion<Value> own = force_in_link(w, i);
        const Value numbers[]{own.angular.x, own.angular.y, own.angular.z,
                              own.linear.x,  own.linear.y,  own.linear.z};
        sum += numbers[k];
      }
      return sum;
    });
  };
  n += -Vector<T>{pushed(0), pushed(1), pushed(2)};
  f += -Vector<T>{pushed(3), pushed(4), pushed(5)};
}

}  // namespace
