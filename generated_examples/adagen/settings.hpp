// adagen's runtime, the same for all robots.
// What a solver is where its source says nothing else: it derives its Settings from these.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <utility>

#include "version.hpp"

namespace {

struct PlainSettings {
  using Number = double;  // type of states, results and messages
  using Real = double;    // type of all other values
  static constexpr int kProcesses = 1;
  static constexpr bool kAlone = true;    // whether process 0 does all the work
  static constexpr int kOuterCount = 0;   // outer forces that are inputs
  static constexpr int kOutputCount = 0;  // numbers in qdd behind accelerations
  static constexpr int kColumns = 1;      // right-hand sides: the motion, and one per slaved joint
  static constexpr std::size_t kSlavedCount = 0;  // joints that follow others
  static constexpr bool kGivesAll = true;         // whether accelerations of all joints are found
  static constexpr bool kBatch = false;           // whether many states are solved at once
  static constexpr int kRefine = 0;               // steps of iterative refinement
  static constexpr bool kWide = false;       // whether their residuals are found in wider numbers
  static constexpr bool kCertified = false;  // whether the error of each answer is bounded
  static constexpr int kPlanMessages = 0;
  static constexpr double kTolerance = 1e-9;  // backward error that a check lets pass
};

}  // namespace
