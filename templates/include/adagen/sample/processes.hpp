// adagen's runtime, the same for all robots.
// A solver says this itself (ADAGEN_SOLVER). Read alone, headers take it of a sample.
#pragma once
#if !defined(ADAGEN_SOLVER)

#include <array>

#include "../constants.hpp"
#include "channel.hpp"
#include "workspace.hpp"

namespace {

constexpr std::array<void (*)(Workspace&, Channel&), kProcesses> kRun{};
constexpr std::array<void (*)(Workspace&, Channel&), kProcesses> kRecover{};
constexpr std::array<void (*)(Workspace&), 2> kParts{};
constexpr std::array<ProcessInfo, kProcesses> kProcess{};
constexpr std::array<StageInfo, 1> kStages_0{};

}  // namespace

#endif
