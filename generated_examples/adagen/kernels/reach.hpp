// adagen's runtime, the same for all robots.
#pragma once

#include <cstddef>

#include "../gravity.hpp"
#include "../sample/robot.hpp"
#include "../sizes.hpp"
#include "../value.hpp"
#include "algebra.hpp"
#include "arms.hpp"
#include "lanes.hpp"
#include "loop_settings.hpp"
#include "memory.hpp"
#include "outward.hpp"
#include "weights.hpp"

namespace {

// What certificates take of the sweep of accelerations.
ADAGEN_INLINE Reached<Value> reached_at(const Workspace& w, int link) {
  return w.reached[static_cast<std::size_t>(link)];
}
inline void reach_ground(Workspace& w) {
  const Frame<Value> at = ground(w);
  w.reached[0] = {Value{}, dot(at.a, at.a)};
}

// Keeps what the link beyond each of the joints gains beyond its Frame, for its certificate.
template <class T>
ADAGEN_INLINE void keep_gained(Workspace& w, int slot, const Motion<T>& a, const Reached<T>& to) {
  put_at(w.at(slot, kGained), a.angular);
  put_at(w.at(slot, kGainedAlong), a.linear);
  put_at(w.at(slot, kReached), to.turning);
  put_at(w.at(slot, kReachedAlong), to.sliding);
}
// A correction adds to it.
template <class T>
ADAGEN_INLINE void gain_more(Workspace& w, int slot, const Motion<T>& a) {
  put_at(w.at(slot, kGained), vector_at<T>(w.at(slot, kGained)) + a.angular);
  put_at(w.at(slot, kGainedAlong), vector_at<T>(w.at(slot, kGainedAlong)) + a.linear);
}
template <class T>
ADAGEN_INLINE void reach_link(Workspace& w, int slot, const Joints<T>& joints, JointKind kind,
                              const Motion<T>& a, Reached<T>& to) {
  if constexpr (kRefine > 0) {
    if (w.again) {
      if constexpr (kRefine > 1) gain_more(w, slot, a);
      return;
    }
  }
  to.sliding += arm_square(joints, kind, w.memory(joints).r) * to.turning;
  if (kind != JointKind::kRevolute && kind != JointKind::kSpherical)
    to.sliding = larger(to.sliding, dot(a.linear, a.linear));
  to.turning = larger(to.turning, dot(a.angular, a.angular));
  keep_gained(w, slot, a, to);
}
template <class T>
ADAGEN_INLINE void reach(Workspace& w, const Joints<T>& joints, JointKind kind, const Motion<T>& a,
                         Reached<T>& to) {
  reach_link(w, joints.slot, joints, kind, a, to);
}
// Of a joint that is reversed: its parent link is reached.
ADAGEN_INLINE void reach_back(Workspace& w, int j, JointKind kind, const Motion<Value>& a,
                              Reached<Value>& to) {
  const int far = kJoints[static_cast<std::size_t>(j)].parent;
  if (far > 0) reach_link(w, slot_of(far - 1), single(j), kind, a, to);
}
ADAGEN_INLINE void keep_reached(Workspace& w, std::size_t link, const Reached<Value>& to) {
  w.reached[link] = to;
}

// A floating base: its joint's acceleration is less by what turns with its axes, the fall.
template <int j>
void reach_fall(Workspace& w) {
  const Value* v = w.v + kJoints[j].v;
  w.fall = cross(Vector<Value>{v[3], v[4], v[5]}, Vector<Value>{v[0], v[1], v[2]});
}
// The link that all others are reached from.
template <int link>
void reach_root(Workspace& w) {
  const Motion<Value>& a = w.motions[link];
  if constexpr (kRefine > 1) {
    if (w.again) return gain_more(w, slot_of(link - 1), a);
  }
  w.reached[link] = {dot(a.angular, a.angular), dot(a.linear, a.linear) + dot(w.fall, w.fall)};
  keep_gained(w, slot_of(link - 1), a, w.reached[link]);
}

}  // namespace
