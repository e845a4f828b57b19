// adagen's runtime, the same for all robots.
#pragma once

#include <cstddef>

#include "../common.hpp"
#include "../constants.hpp"
#include "../sample/keep.hpp"
#include "../sample/reach.hpp"
#include "../sample/robot.hpp"
#include "../sizes.hpp"
#include "../value.hpp"
#include "algebra.hpp"
#include "factors.hpp"
#include "kinds.hpp"
#include "lanes.hpp"
#include "loop_settings.hpp"
#include "memory.hpp"
#include "spherical.hpp"
#include "weights.hpp"

namespace {

// Outwards again: the joints' accelerations.

template <class T>
ADAGEN_INLINE T freedom(const T* e, const Motion<T>& a) {
  return (e[6] - (e[0] * a.angular.x + e[1] * a.angular.y)) -
         ((e[2] * a.angular.z + e[3] * a.linear.x) + (e[4] * a.linear.y + e[5] * a.linear.z));
}

// Gives the k-th acceleration of each of the joints.
template <class T>
ADAGEN_INLINE void answer(Workspace& w, const Joints<T>& joints, int k, const T& x) {
  const auto place = [&](int lane) -> Value& {
    const int j = joints.joint[lane];
    const int v = kOneEach ? j : kJoints[static_cast<std::size_t>(j)].v;
    return w.answer[static_cast<std::size_t>(v + k)];
  };
  if constexpr (kWidth<T> == 1)
    place(0) = x;
  else
    ADAGEN_FOR (lane, 0, kWidth<T>) place(lane) = x[lane];
}

// The same for joints with several freedoms, expressed at the joint's origin throughout.
template <bool reversed>
ADAGEN_INLINE void move_at_joint(Workspace& w, const Joints<Value>& joints, Motion<Value>& a) {
  const JointConstants& joint = joints.any();
  [[maybe_unused]] const Value* const e = w.memory(joints).e;
  [[maybe_unused]] const Matrix<Value> R = matrix_at(w.at(joints.slot, kAxes));
  [[maybe_unused]] Value* qdd = &w.answer[static_cast<std::size_t>(joint.v)];
  if constexpr (kAnyPlanar) {
    if (joint.kind == JointKind::kPlanar) {
      const Value spin = freedom(e + 16, a);
      a.angular += Vector<Value>{R.x.z, R.y.z, R.z.z} * spin;
      const Value y = freedom(e + 8, a);
      a.linear += Vector<Value>{R.x.y, R.y.y, R.z.y} * y;
      const Value x = freedom(e, a);
      a.linear += Vector<Value>{R.x.x, R.y.x, R.z.x} * x;
      qdd[0] = reversed ? -x : x, qdd[1] = reversed ? -y : y, qdd[2] = reversed ? -spin : spin;
    }
  }
  if constexpr (kAnyFloating) {
    if (joint.kind == JointKind::kFloating) {
      const Motion<Value> far{{e[0], e[1], e[2]}, {e[3], e[4], e[5]}};
      const Vector<Value> slide = transposed_times(R, far.linear - a.linear);
      const Vector<Value> spin = transposed_times(R, far.angular - a.angular);
      const Value x[6] = {slide.x, slide.y, slide.z, spin.x, spin.y, spin.z};
      ADAGEN_FOR (k, 0, 6) qdd[k] = reversed ? -x[k] : x[k];
      a = far;
    }
  }
}

// The same for spherical joints.
template <bool reversed, class T>
ADAGEN_INLINE void turn_at_joint(Workspace& w, const Joints<T>& joints, Motion<T>& a) {
  const T* const e = w.memory(joints).e;
  const Matrix<T> K{{e[0], e[1], e[2]}, {e[3], e[4], e[5]}, {e[6], e[7], e[8]}};
  Vector<T> far = Vector<T>{e[9], e[10], e[11]} - K * a.linear;
  if constexpr (kSphericalRotors) far += solved(e + 12, a.angular) * rotor_of(joints);
  const Matrix<T> R = matrix_at<T>(w.at(joints.slot, kAxes));
  const Vector<T> x = transposed_times(R, far - a.angular);
  answer(w, joints, 0, reversed ? -x.x : x.x);
  answer(w, joints, 1, reversed ? -x.y : x.y);
  answer(w, joints, 2, reversed ? -x.z : x.z);
  a.angular = far;
}

// A joint's acceleration from the near link's, which becomes the far link's; each is expressed at
// its own origin. Where the joint is reversed, the far link's acceleration differs by -S qdd.
template <bool reversed, class T>
ADAGEN_INLINE void move(Workspace& w, const Joints<T>& joints, JointKind kind, Motion<T>& a) {
  const T* const e = w.memory(joints).e;
  const Vector<T>& r = w.memory(joints).r;
  switch (kind) {
    case JointKind::kRevolute: {
      const Vector<T> axis = axis_of(w, joints);
      const T x = freedom(e, a);
      answer(w, joints, 0, reversed ? -x : x);
      carry(a, reversed ? -r : r);
      a.angular += axis * x;
      if constexpr (reversed) a.linear += cross(r, axis) * x;
      break;
    }
    case JointKind::kPrismatic: {
      const T x = freedom(e, a);
      answer(w, joints, 0, reversed ? -x : x);
      carry(a, reversed ? -r : r);
      a.linear += axis_of(w, joints) * x;
      break;
    }
    case JointKind::kSpherical:
      if constexpr (kAnySpherical) {
        if constexpr (!reversed) carry(a, r);
        turn_at_joint<reversed>(w, joints, a);
        if constexpr (reversed) carry(a, -r);
      }
      break;
    default:
      if constexpr (kWidth<T> == 1) {
        if constexpr (!reversed) carry(a, r);
        move_at_joint<reversed>(w, joints, a);
        if constexpr (reversed) carry(a, -r);
      }
  }
}

// The same for two hinges that follow each other: the second one's acceleration, too, is found from
// the near link's, and of the first one's by what that alone does to it. So it waits for one
// product instead of for the whole motion of the link between.
template <bool reversed>
ADAGEN_INLINE void move_two(Workspace& w, int j, Motion<Value>& a) {
  const Joints<Value> one = single(j), two = single(reversed ? j - 1 : j + 1);
  const Value* const e = w.memory(two).e;
  const Vector<Value> r = reversed ? -w.memory(one).r : w.memory(one).r;
  const Vector<Value> next = reversed ? -w.memory(two).r : w.memory(two).r, both = r + next;
  const Vector<Value> s = axis_of(w, one), t = axis_of(w, two);
  const Vector<Value> n{e[0], e[1], e[2]}, f{e[3], e[4], e[5]};
  const Vector<Value> moved = n + cross(r, f);  // of a turn about the near link's origin
  const Value between = dot(reversed ? moved : n, s);
  const Value x = freedom(w.memory(one).e, a);
  const Value seen[7] = {moved.x, moved.y, moved.z, f.x, f.y, f.z, e[6]};
  const Value y = freedom(seen, a) - between * x;
  answer(w, one, 0, reversed ? -x : x);
  answer(w, two, 0, reversed ? -y : y);
  carry(a, both);
  a.linear += cross(s, reversed ? both : next) * x;
  if constexpr (reversed) a.linear += cross(t, next) * y;
  a.angular += s * x;
  a.angular += t * y;
}

// Whether joints first .. last are hinges, enough of them for two at a time to pay, and nothing is
// wanted of the links between.
template <int p, int first, int last>
constexpr bool by_twos() {
  if (kWide || kWeighed || sizeof(Value) > sizeof(Real) || last - first + 1 < 8) return false;
  for (int j = first; j <= last; ++j) {
    if (kJoints[j].kind != JointKind::kRevolute) return false;
    if (j > first && kRoles[p][j].parts) return false;
  }
  return true;
}

// Six numbers that follow from each other are no work for lanes: on x86-64 g++ takes a fifth longer
// with them.
#if defined(__x86_64__) && !defined(__clang__)
#define ADAGEN_ONE_BY_ONE __attribute__((optimize("no-tree-slp-vectorize")))
#else
#define ADAGEN_ONE_BY_ONE
#endif

// Joints first .. last outwards, each after what is done before(joint); what moves along with a
// link is kept where other paths start.
template <int p, int first, int last, class Before>
ADAGEN_INLINE void accelerate_after(Workspace& w, const Before& before) {
  Motion<Value> a = w.motions[static_cast<std::size_t>(kJoints[first].parent)];
  if constexpr (by_twos<p, first, last>()) {
    int j = first;
    for (; j < last; j += 2) {
      before(j), before(j + 1);
      move_two<false>(w, j, a);
    }
    if (j == last) before(j), move<false>(w, single(j), JointKind::kRevolute, a);
    if constexpr (kRoles[p][last + 1].parts) w.motions[last + 1] = a;
    return;
  }
  Reached<Value> reached = reached_at(w, kJoints[first].parent);
  each_row<RunRows<first, last>, false>([&](int k, auto kind) ADAGEN_ALWAYS {
    before(first + k);
    move<false>(w, single(first + k), kind, a);
    if constexpr (kWide) keep_force<false>(w, single(first + k), a);
    reach(w, single(first + k), kind, a, reached);
    const std::size_t far = static_cast<std::size_t>(first + k + 1);
    if (kRoles[p][far].parts) w.motions[far] = a, keep_reached(w, far, reached);
  });
}
template <int p, int first, int last>
ADAGEN_ONE_BY_ONE void accelerate(Workspace& w) {
  accelerate_after<p, first, last>(w, [](int) ADAGEN_ALWAYS {});
}
template <int p, int first, int last>
ADAGEN_ONE_BY_ONE void accelerate_reversed(Workspace& w) {
  Motion<Value> a = w.motions[last + 1];
  if constexpr (by_twos<p, first, last>()) {
    int j = last;
    for (; j > first; j -= 2) move_two<true>(w, j, a);
    if (j == first) move<true>(w, single(j), JointKind::kRevolute, a);
    if constexpr (kRoles[p][kJoints[first].parent].parts) w.motions[kJoints[first].parent] = a;
    return;
  }
  Reached<Value> reached = reached_at(w, last + 1);
  each_row<RunRows<first, last>, true>([&](int k, auto kind) ADAGEN_ALWAYS {
    const int j = first + k;
    move<true>(w, single(j), kind, a);
    if constexpr (kWide) keep_force<true>(w, single(j), a);
    reach_back(w, j, kind, a, reached);
    const std::size_t far = static_cast<std::size_t>(kJoints[static_cast<std::size_t>(j)].parent);
    if (kRoles[p][far].parts) w.motions[far] = a, keep_reached(w, far, reached);
  });
}

// The Frame of a floating base knows nothing of its linear velocity, whose axes turn with the base.
template <int j>
void as_joint_acceleration(Workspace& w) {
  if (kRefine > 0 && w.again) return;  // a correction has none
  const Value* v = w.v + kJoints[j].v;
  Value* qdd = &w.answer[kJoints[j].v];
  const Vector<Value> turned =
      cross(Vector<Value>{v[3], v[4], v[5]}, Vector<Value>{v[0], v[1], v[2]});
  qdd[0] -= turned.x, qdd[1] -= turned.y, qdd[2] -= turned.z;
}

// A floating base's joint acceleration, [linear; angular] in its own axes.
template <int j>
void free_acceleration(Workspace& w) {
  const Motion<Value>& a = w.motions[j + 1];
  Value* qdd = &w.answer[kJoints[j].v];
  qdd[0] = a.linear.x, qdd[1] = a.linear.y, qdd[2] = a.linear.z;
  qdd[3] = a.angular.x, qdd[4] = a.angular.y, qdd[5] = a.angular.z;
  as_joint_acceleration<j>(w);
}

}  // namespace
