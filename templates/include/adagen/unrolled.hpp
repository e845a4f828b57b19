// adagen's runtime, the same for all robots.
#pragma once

#include <array>
#include <cstddef>
#include <limits>
#include <utility>

#include "common.hpp"
#include "constants.hpp"
#include "sample/channel.hpp"
#include "sample/robot.hpp"
#include "sample/unrolled.hpp"
#include "sizes.hpp"
#include "status.hpp"
#include "value.hpp"

// Lanes are for limbs, and joints after each other have none in common: g++ must not vectorise
// anything else. Of reproducible solvers it is expressed so for the whole file: options of single
// functions would keep others from being inlined.
#if defined(__clang__) || defined(ADAGEN_REPRODUCIBLE)
#define ADAGEN_AS_IT_STANDS
#else
#define ADAGEN_AS_IT_STANDS __attribute__((optimize("no-tree-slp-vectorize")))
#endif

namespace {

// The code around straight lines: tests of the state, sines and cosines, checks, results.
#define ADAGEN_INPUTS                                                              \
  [[maybe_unused]] const Value *const q = w.q, *const v = w.v, *const tau = w.tau; \
  [[maybe_unused]] const Value *const sine = w.sine.data(), *const cosine = w.cosine.data();

[[maybe_unused]] constexpr Real kInfinity = std::numeric_limits<Real>::infinity();

inline void fail(Workspace& w, Failure kind, int joint) {
#if defined(ADAGEN_REPRODUCIBLE) && defined(ADAGEN_RECOVERS)
  // Whatever is found first: a pose that another way may stand goes before what is refused.
  if (kind == kSingularPose && failure_kind(w.status) != kNoAnswer) w.status = kFine;
#endif
  Channel::fail(w.status, failure(kind, joint));
}

#if defined(ADAGEN_REPRODUCIBLE) && defined(ADAGEN_LOOPS)
// Receives a message, and what failed at its source.
template <class AnyChannel>
const Real* heard(Workspace& w, AnyChannel& channel, int k) {
  int told = kFine;
  const Real* const content = channel.receive(k, told);
  if (told != kFine) fail(w, failure_kind(told), failure_place(told));
  return content;
}
#endif

#if defined(ADAGEN_BATCH) && defined(ADAGEN_RECOVERS)
inline void require_all(Workspace& w, const LaneBits& good, Failure kind, int joint) {
  if (__builtin_expect(all(good), 1)) return;
  (kind == kSingularPose ? w.ways.poor : w.ways.refused) |= ~good;
  fail(w, kind, joint);
}
#define ADAGEN_REQUIRE(w, good, also, kind, joint) require_all(w, (good) & (also), kind, joint)
#else
#define ADAGEN_REQUIRE(w, good, also, kind, joint) \
  if (!all(good, also)) fail(w, kind, joint)
#endif

// A state was found not to be finite: which joint's?
template <std::size_t reads, std::size_t owns>
[[gnu::cold]] ADAGEN_NOINLINE void name_what_is_not_finite(Workspace& w,
                                                           const std::array<int, reads>& read,
                                                           const std::array<int, owns>& owned) {
  for (const int j : read) {
    const JointConstants& joint = kJoints[static_cast<std::size_t>(j)];
    if (!all(unlike_zero(w.q + joint.q, joint.nq) + unlike_zero(w.v + joint.v, joint.nv) == 0))
      fail(w, kNotFinite, j);
  }
  for (const int j : owned) {
    const JointConstants& joint = kJoints[static_cast<std::size_t>(j)];
    if (!all(unlike_zero(w.tau + joint.v, joint.nv) == 0)) fail(w, kNotFinite, j);
  }
}

[[maybe_unused]] inline void require_length(Workspace& w, const Value& squared, int joint) {
  ADAGEN_REQUIRE(w, squared >= std::numeric_limits<Real>::min(),
                 squared <= std::numeric_limits<Real>::max(), kZeroQuaternion, joint);
}

// A pivot or a mobility has to be more than what rounding may have left of it.
template <class T>
[[maybe_unused]] void require_more(Workspace& w, const Value& x, const T& least, Failure kind,
                                   int joint) {
  ADAGEN_REQUIRE(w, x > least, x <= std::numeric_limits<Real>::max(), kind, joint);
}

// A result was found not to be finite: which joint's?
template <std::size_t owns>
[[gnu::cold]] ADAGEN_NOINLINE void name_what_overflows(Workspace& w,
                                                       const std::array<int, owns>& owned) {
  for (const int j : owned) {
    const JointConstants& joint = kJoints[static_cast<std::size_t>(j)];
    if (!all(unlike_zero(w.result.data() + joint.v, joint.nv) == 0)) fail(w, kOverflow, j);
  }
}

// Something was found amiss at the end: the state's own faults are named before all others.
template <std::size_t reads, std::size_t owns>
[[gnu::cold]] ADAGEN_NOINLINE void find_fault(Workspace& w, const std::array<int, reads>& read,
                                              const std::array<int, owns>& owned) {
  const int found = std::exchange(w.status, kFine);
  name_what_is_not_finite(w, read, owned);
  Channel::fail(w.status, found);
  name_what_overflows(w, owned);
}

}  // namespace
