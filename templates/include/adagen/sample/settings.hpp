// adagen's runtime, the same for all robots.
// A solver says this itself (ADAGEN_SOLVER). Read alone, headers take it of a sample.
#pragma once
#if !defined(ADAGEN_SOLVER)

#include "../settings.hpp"

namespace {

struct Settings : PlainSettings {
  static constexpr int kJointCount = 4, kNq = 13, kNv = 11;
  static constexpr int kProcesses = 2;
  static constexpr bool kAlone = false;
  static constexpr int kParameterCount = 4;
  static constexpr int kOuterCount = 1;
  static constexpr std::size_t kSlavedCount = 1;
  static constexpr int kRefine = 2;
  static constexpr bool kWide = true;
  static constexpr bool kCertified = true;
  static constexpr int kPlanMessages = 2;
};

}  // namespace

#endif
