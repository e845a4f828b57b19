// adagen's runtime, the same for all robots.
// Default settings of a solver, from which its own Settings are derived.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <utility>

#include "version.hpp"

#if defined(ADAGEN_CALL) && !defined(ADAGEN_SOLVER)
#define ADAGEN_SOLVER  // a solver's source, which says what it is before it includes more
#endif

namespace {

// What a message costs, ns: its sender, from sent to seen, and per number; through a window, and
// as one of MPI.
struct Hops {
  double window[3], message[3];
};

struct PlainSettings {
  // Version of adagen that wrote the source.
  [[maybe_unused]] static constexpr int kVersion = ADAGEN_VERSION;
  [[maybe_unused]] static constexpr const char* kRobot = "robot";  // its name
  // Of a base that floats; of states in which nothing moves; how processes meet.
  [[maybe_unused]] static constexpr bool kFloating = false;
  [[maybe_unused]] static constexpr bool kAtRest = false;
  [[maybe_unused]] static constexpr const char* kChannel = "auto";
  using Number = double;
  [[maybe_unused]] static constexpr int kProcesses = 1;
  // Whether process 0 does all the work.
  [[maybe_unused]] static constexpr bool kAlone = true;
  // m/s^2
  [[maybe_unused]] static constexpr std::array<double, 3> kGravity{0.0, 0.0, -9.81};
  // Constants that can be set at run time.
  [[maybe_unused]] static constexpr int kParameterCount = 0;
  // Outer forces that are inputs.
  [[maybe_unused]] static constexpr int kOuterCount = 0;
  // Numbers in qdd behind accelerations.
  [[maybe_unused]] static constexpr int kOutputCount = 0;
  // Right-hand sides: the motion, and one per slaved joint.
  [[maybe_unused]] static constexpr int kColumns = 1;
  // Joints that follow others.
  [[maybe_unused]] static constexpr std::size_t kSlavedCount = 0;
  // Whether accelerations of all joints are found.
  [[maybe_unused]] static constexpr bool kGivesAll = true;
  // Whether many states are solved at once.
  [[maybe_unused]] static constexpr bool kBatch = false;
  // Bytes of a core's second-level cache, by the profile of costs.
  [[maybe_unused]] static constexpr std::size_t kCache = 2097152;
  // Steps of iterative refinement.
  [[maybe_unused]] static constexpr int kRefine = 0;
  // Whether their residuals are found in wider numbers.
  [[maybe_unused]] static constexpr bool kWide = false;
  // Whether the error of each answer is bounded.
  [[maybe_unused]] static constexpr bool kCertified = false;
  [[maybe_unused]] static constexpr int kPlanMessages = 0;
  // As the cost profile has them.
  [[maybe_unused]] static constexpr Hops kHops{};
  // Whether the solver makes subnormal numbers.
  [[maybe_unused]] static constexpr bool kMeetsSubnormals = false;
  // Backward error that a check lets pass.
  [[maybe_unused]] static constexpr double kTolerance = 1e-9;
};

}  // namespace
