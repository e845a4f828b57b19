// adagen's runtime, the same for all robots.
// Names of a solver's Settings for all headers, and derived constants.
#pragma once

#include <array>
#include <cstddef>

#include "sample/settings.hpp"
#include "settings.hpp"
#include "version.hpp"

namespace {

#if defined(ADAGEN_SOLVER) && defined(ADAGEN_CALL)
using Settings = ::ADAGEN_CALL(settings);
#endif
static_assert(
    Settings::kVersion == ADAGEN_VERSION,
    "the headers in adagen/ are of another version than the adagen that wrote this solver");
using Number = Settings::Number;  // type of states, results and messages
using Real = Number;              // type of what is computed from them
[[maybe_unused]] constexpr int kProcesses = Settings::kProcesses;
[[maybe_unused]] constexpr bool kAlone = Settings::kAlone;
[[maybe_unused]] constexpr int kJointCount = Settings::kJointCount, kLinkCount = kJointCount + 1;
[[maybe_unused]] constexpr int kNq = Settings::kNq, kNv = Settings::kNv;
[[maybe_unused]] constexpr int kNqdd = kNv + Settings::kOutputCount;
[[maybe_unused]] constexpr std::array<double, 3> kGravity = Settings::kGravity;  // m/s^2
[[maybe_unused]] constexpr int kParameterCount = Settings::kParameterCount;
[[maybe_unused]] constexpr int kOuterCount = Settings::kOuterCount, kNtau = kNv + 6 * kOuterCount;
[[maybe_unused]] constexpr int kColumns = Settings::kColumns;
[[maybe_unused]] constexpr std::size_t kSlavedCount = Settings::kSlavedCount;
[[maybe_unused]] constexpr bool kGivesAll = Settings::kGivesAll;
[[maybe_unused]] constexpr bool kBatch = Settings::kBatch;
[[maybe_unused]] constexpr int kRefine = Settings::kRefine;
[[maybe_unused]] constexpr bool kWide = Settings::kWide;
[[maybe_unused]] constexpr bool kCertified = Settings::kCertified;
// Whether residuals are swept inwards.
[[maybe_unused]] constexpr bool kWeighed = kCertified || (kRefine > 0 && !kWide);
[[maybe_unused]] constexpr int kPlanMessages = Settings::kPlanMessages;
[[maybe_unused]] constexpr double kTolerance = Settings::kTolerance;

// The velocities of a state: where all are at rest, none that a caller may give.
[[maybe_unused]] inline const Number* velocities_of(const Number* v) {
  static constexpr std::array<Number, static_cast<std::size_t>(kNv)> kStill{};
  return Settings::kAtRest ? kStill.data() : v;
}

}  // namespace
