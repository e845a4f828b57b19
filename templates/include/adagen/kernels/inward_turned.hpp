// adagen's runtime, the same for all robots.
#pragma once

#include <cstddef>

#include "../constants.hpp"
#include "../sample/keep.hpp"
#include "../sample/robot.hpp"
#include "../sizes.hpp"
#include "../value.hpp"
#include "algebra.hpp"
#include "blocks.hpp"
#include "inward.hpp"
#include "kinds.hpp"
#include "lanes.hpp"
#include "links.hpp"
#include "memory.hpp"
#include "turned.hpp"

namespace {

// From the parent link's origin to the child link's, in the parent link's axes.
template <class T>
ADAGEN_INLINE Vector<T> lever_on_parent(Workspace& w, const Joints<T>& joints, JointKind kind,
                                        const Matrix<T>& turn) {
  const auto origin = origin_of(joints);
  Vector<T> r{T{} + origin.x, T{} + origin.y, T{} + origin.z};
  if (kind == JointKind::kPrismatic) {
    const T q = each(joints, [&w](const JointConstants& own) { return w.q[own.q]; });
    r += Vector<T>{turn.x.z, turn.y.z, turn.z.z} * q;
  }
  return r;
}

// One joint, or one in each lane. The slot is that of the parent link if its body is expressed in
// its own axes, and negative if in those of the base.
template <bool reversed, bool lost, class T>
ADAGEN_INLINE void step_turned(Workspace& w, const Joints<T>& joints, JointKind kind, int slot,
                               Body<T>& X) {
  const bool own = slot >= 0;
  if (!turned<lost>(joints.joint[0])) {
    if (reversed && own) turn_body(X, matrix_at<T>(w.at(slot, kAxes)));
    step_inward<reversed>(w, joints, kind, X, [](const Body<T>&) {});
    if (!reversed && own) turn_body(X, transposed(matrix_at<T>(w.at(slot, kAxes))));
    return;
  }
  [[maybe_unused]] const Matrix<T> R = matrix_at<T>(w.at(joints.slot, kAxes));
  const Matrix<T> turn = matrix_at<T>(w.at(joints.slot, kTurn));
  if constexpr (reversed) {
    if (own) {
      shift(X, -lever_on_parent(w, joints, kind, turn));
      turn_body(X, transposed(turn));
    } else {
      shift(X, -w.memory(joints).r);
      turn_body(X, transposed(R));
    }
  }
  if (kind == JointKind::kRevolute)
    eliminate_own<false, reversed>(w, joints, X);
  else
    eliminate_own<true, reversed>(w, joints, X);
  if constexpr (reversed) return;
  if (own) {
    turn_body(X, turn);
    shift(X, lever_on_parent(w, joints, kind, turn));
  } else {
    turn_body(X, R);
    shift(X, w.memory(joints).r);
  }
}

// The slot of a link whose body is expressed in its own axes, -1 of others.
template <bool lost = false>
ADAGEN_INLINE int turned_slot(int link) {
  return turned_link<lost>(link) ? slot_of(link - 1) : -1;
}

// Keeps a body on the far side of joints for their forces, expressed in axes of the base.
template <class T>
ADAGEN_INLINE void keep_turned(Workspace& w, const Joints<T>& joints, int slot, Body<T> X) {
  if (slot >= 0) turn_body(X, matrix_at<T>(w.at(slot, kAxes)));
  keep_body(w, joints, X);
}

// See inward in inward.hpp: the same where a joint is turned, or the near link.
template <int p, int first, int last, bool starts, bool lost = false>
void inward_turned(Workspace& w) {
  Body<Value> X{};
  each_row<RunRows<first, last>, true>([&](int k, auto kind) ADAGEN_ALWAYS {
    const int j = first + k;
    meet<p, lost>(w, j + 1, X);
    if constexpr (kWide) keep_turned(w, single(j), turned_slot<lost>(j + 1), X);
    const int near = kJoints[static_cast<std::size_t>(j)].parent;
    step_turned<false, lost>(w, single(j), kind,
                             k > 0 ? turned_slot<lost>(near) : turned_slot(near), X);
  });
  if constexpr (!lost && may_lose(first, last))
    if (__builtin_expect(w.lost, 0)) return inward_again<p, first, last, starts, false>(w);
  constexpr int near = kJoints[first].parent;
  if constexpr (near > 0) add_to<starts>(w, near, X);
}

// See inward_reversed.
template <int p, int first, int last, bool starts, bool lost = false>
void inward_turned_reversed(Workspace& w) {
  Body<Value> X{};
  each_row<RunRows<first, last>, false>([&](int k, auto kind) ADAGEN_ALWAYS {
    const int j = first + k;
    const int parent = kJoints[static_cast<std::size_t>(j)].parent;
    meet<p, lost>(w, parent, X);
    if constexpr (kWide) keep_turned(w, single(j), turned_slot<lost>(parent), X);
    step_turned<true, lost>(w, single(j), kind, turned_slot<lost>(parent), X);
  });
  if constexpr (!lost && may_lose(first, last))
    if (__builtin_expect(w.lost, 0)) return inward_again<p, first, last, starts, true>(w);
  if (lost && !turned(last)) to_base<true>(w, last + 1, X);
  add_to<starts>(w, last + 1, X);
}

// The sweep of a run that lost digits, once more, now in the links' own axes.
template <int p, int first, int last, bool starts, bool reversed>
ADAGEN_COLD void inward_again(Workspace& w) {
  w.lost = false;
  if constexpr (reversed)
    inward_turned_reversed<p, first, last, starts, true>(w);
  else
    inward_turned<p, first, last, starts, true>(w);
}

}  // namespace
