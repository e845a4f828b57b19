// adagen's runtime, the same for all robots.
#pragma once

#include <cstddef>

#include "constants.hpp"
#include "sample/robot.hpp"
#include "status.hpp"

namespace {

// Adds the names of a joint and of those before it that it is joined with: the links between them
// have neither mass nor inertia.
void add_names_of_run(Text& to, int joint) {
  const int link = kJoints[joint].parent;
  const LinkConstants& own = kLinks[link];
  if (link > 0 && !(own.mass > 0 || own.tensor[0] + own.tensor[4] + own.tensor[8] > 0)) {
    add_names_of_run(to, link - 1);
    to += ", ";
  }
  add_quoted(to, kJoints[joint].name);
}

// A failure in words, about a joint or not.
struct FailureWords {
  bool of_joint;
  const char* text;
};

constexpr FailureWords words_of(Failure kind) {
  switch (kind) {
    case kFine:
      return {false, "no error"};
    case kNotFinite:
      return {true, "its q, v or tau is not a finite number"};
    case kZeroQuaternion:
      return {true, "its quaternion cannot be normalised"};
    case kFactorization:
      return {true, "factorization failed: the inertias beside it differ too much for the scalar"};
    case kGimbalLock:
      return {false, "gimbal lock of joints that are joined as one through links without mass"};
    case kGrowth:
      return {true,
              "no digits left: a link beside it is too light for its neighbours and the scalar"};
    case kOverflow:
      return {true, "its acceleration is not a finite number (overflow)"};
    case kSingularPose:
      return {true, "its mobility is singular in this pose"};
    case kEnded:
      return {false, "process 0 has ended the evaluations"};
    case kNotRefined:
      return {false, "refinement does not converge: the inertias differ too much for the scalar"};
    case kTooFewSteps:
      return {false,
              "refinement converges too slowly: its last correction is too large; take more steps "
              "(--refine) or --scalar double"};
    case kLoopOpen:
      return {false, "it is not closed in this configuration, by more than its tolerance"};
    case kLoopTorn:
      return {false, "the velocity violates it"};
    case kLoopSingular:
      return {false, "this pose is singular: the rank of its constraints changes here"};
    case kLoopFree:
      return {true, "the closed loops allow a motion of it that has no inertia"};
    case kNotSet:
      return {false, "a value is not finite, a mass not positive, or the constant cannot be set"};
    case kNoAnswer:
      return {false, " did not answer within the time limit"};
  }
  return {false, "unknown failure"};
}

// Whether a failure is numbered with a loop or coupling, behind all joints.
[[maybe_unused]] constexpr bool is_of_loop(Failure kind) {
  return kind == kLoopOpen || kind == kLoopTorn || kind == kLoopSingular;
}

// Whether a failure is numbered with a joint.
constexpr bool is_of_joint(Failure kind) { return words_of(kind).of_joint || kind == kGimbalLock; }

Text describe(int status) {
  const Failure kind = failure_kind(status);
  const FailureWords words = words_of(kind);
  Text text;
  if (words.of_joint) {
    text += "joint ";
    add_quoted(text, kJoints[failure_place(status)].name);
    text += ": ";
  } else if (kind == kGimbalLock) {
    text += "joints ";
    add_names_of_run(text, failure_place(status));
    text += ": ";
#ifdef ADAGEN_LOOPS
  } else if (is_of_loop(kind)) {
    const int place = failure_place(status) - static_cast<int>(kJoints.size());
    text += place < kLoopCount ? "loop " : "coupling ";
    add_quoted(text, kLoopNames[static_cast<std::size_t>(place)]);
    text += ": ";
#endif
  } else if (kind == kNoAnswer) {
    text += "process ";
    text += failure_place(status);
  }
  text += words.text;
  return text;
}

}  // namespace
