// adagen's runtime, the same for all robots.
#pragma once

#include <cstddef>
#include <initializer_list>
#include <limits>
#include <utility>

#include "../constants.hpp"
#include "../sample/channel.hpp"
#include "../sample/robot.hpp"
#include "../sizes.hpp"
#include "../status.hpp"
#include "../value.hpp"
#include "blocks.hpp"
#include "lanes.hpp"
#include "loop_settings.hpp"
#include "memory.hpp"

namespace {

// What cannot be solved is refused, with the joint at fault.

// Least ratio of D to the trace of its inertia: D below it is only rounding.
constexpr Real kLeast = 16 * std::numeric_limits<Real>::epsilon();

// Less than this calls for the joint's own axes, where there is a way to take them: a sweep in axes
// of the base loses as many digits as D is smaller than the trace.
constexpr Real kEnough = kAnyTurnedIfLost ? Real(1 / kLosing) : kLeast;

ADAGEN_COLD inline void fail(Workspace& w, Failure kind, int joint) {
  Channel::fail(w.status, failure(kind, joint));
}

// x - x is zero, in all bits, for finite x only.
ADAGEN_INLINE LaneBits unlike_zero(const Value* x) {
  return same_bits<LaneBits>(wide(x) - wide(x));
}
ADAGEN_INLINE bool finite(const Value* x, int count) {
  LaneBits found{};
  int k = 0;
  for (; k + kPerBlock <= count; k += kPerBlock) found |= unlike_zero(x + k);
  if (k > 0 && k < count)
    found |= unlike_zero(x + count - kPerBlock);  // some of them once more
  else
    for (; k < count; ++k)
      if (!all_zero(x[k] - x[k])) return false;
  return !any_of(found);
}

// Tells which of entries first .. is the first that is not finite; place says where a joint's
// entries start.
ADAGEN_COLD inline void refuse(Workspace& w, const Value* x, int first, int JointConstants::* place,
                               Failure kind) {
  while (finite(x + first, 1)) ++first;
  int joint = 0;
  for (int j = 0; j < kJointCount; ++j)
    if (kJoints[static_cast<std::size_t>(j)].*place <= first) joint = j;
  fail(w, kind, joint);
}

// Refuses entries first .. first + count - 1 of the state, or of the answer, if one is not finite.
inline void require_finite(Workspace& w, const Value* x, int first, int count,
                           int JointConstants::* place, Failure kind) {
  if (__builtin_expect(!finite(x + first, count), 0)) refuse(w, x, first, place, kind);
}

// Whether nothing failed, and entries first .. first + count - 1 of the answer are finite.
ADAGEN_INLINE bool went_well(const Workspace& w, int first, int count) {
  return __builtin_expect(
      w.status == kFine && finite(&w.answer[static_cast<std::size_t>(first)], count), 1);
}

// Something was found amiss at the end: the state's own faults are named before all others. What is
// looked at of q, v, tau and the answer.
using Entries = std::initializer_list<Range>;
ADAGEN_COLD inline void find_fault(Workspace& w, Entries q, Entries v, Entries tau,
                                   Entries answer) {
  const int found = std::exchange(w.status, kFine);
  const auto look = [&w](const Value* x, Entries entries, int JointConstants::* place,
                         Failure kind) {
    for (const Range& own : entries) require_finite(w, x, own.first, own.count, place, kind);
  };
  look(w.q, q, &JointConstants::q, kNotFinite);
  look(w.v, v, &JointConstants::v, kNotFinite);
  look(w.tau, tau, &JointConstants::v, kNotFinite);
  Channel::fail(w.status, found);
  look(w.answer.data(), answer, &JointConstants::v, kOverflow);
}

template <class T>
ADAGEN_INLINE bool has_length(const T& squared) {
  return all_positive(squared - std::numeric_limits<Real>::min()) &&
         all_positive(std::numeric_limits<Real>::max() - squared);
}
template <class T>
void require_length(Workspace& w, const T& squared, int joint) {
  if (!has_length(squared)) fail(w, kZeroQuaternion, joint);
}

// An elimination failed for one of the joints: for that whose number is not positive.
template <class T>
ADAGEN_COLD void fail_one(Workspace& w, const Joints<T>& joints, [[maybe_unused]] const T& x) {
  int lane = 0;
  if constexpr (kWidth < T >> 1)
    while (lane + 1 < kWidth<T> && x[lane] > 0) ++lane;
  fail(w, kFactorization, joints.joint[lane]);
}

// D is less than enough beside the trace of what it is found in, for one of the joints at least:
// its sweep is repeated in other axes, or fails where that is no way and nothing but rounding is
// left.
template <class T>
ADAGEN_COLD void lose(Workspace& w, const Joints<T>& joints, const T& D, const T& trace) {
  for (std::size_t lane = 0; lane < kWidth<T>; ++lane) {
    Value own = Value{}, whole = Value{};
    if constexpr (kWidth<T> == 1)
      own = D, whole = trace;
    else
      own = D[lane], whole = trace[lane];
    const int j = joints.joint[lane];
    if (kAnyTurnedIfLost && kTurnedIfLost[j])
      w.lost |= !all_positive(own - kEnough * whole);
    else if (!all_positive(own - kLeast * whole))
      fail(w, kFactorization, j);
  }
}

}  // namespace
