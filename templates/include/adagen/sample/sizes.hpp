// adagen's runtime, the same for all robots.
// A solver says this itself (ADAGEN_SOLVER). Read alone, headers take it of a sample.
#pragma once
#if !defined(ADAGEN_SOLVER)

#include <cstddef>

namespace {

using Number = double;  // type of states, results and messages
using Real = double;    // type of all other values
constexpr int kProcesses = 2;
constexpr bool kAlone = false;  // whether process 0 does all the work
constexpr int kJointCount = 4, kLinkCount = kJointCount + 1;
constexpr int kNq = 13, kNv = 11, kNqdd = kNv;
constexpr int kOuterCount = 1, kNtau = kNv + 6 * kOuterCount;
constexpr int kColumns = 1;              // right-hand sides: the motion, and one per slaved joint
constexpr std::size_t kSlavedCount = 1;  // joints that follow others
constexpr bool kBatch = false;           // whether many states are solved at once
constexpr int kRefine = 2;               // steps of iterative refinement
constexpr bool kWide = true;             // whether their residuals are found in wider numbers
constexpr bool kCertified = true;        // whether the error of each answer is bounded
constexpr bool kWeighed = true;          // whether residuals are swept inwards
constexpr int kPlanMessages = 2;
constexpr double kTolerance = 1e-9;

}  // namespace

#endif
