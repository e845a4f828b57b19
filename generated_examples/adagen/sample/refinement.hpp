// adagen's runtime, the same for all robots.
// A solver says this itself (ADAGEN_SOLVER). Read alone, headers take it of a sample.
#pragma once
#if !defined(ADAGEN_SOLVER)

#include <array>

#include "../refine.hpp"
#include "channel.hpp"
#include "workspace.hpp"

namespace {

constexpr std::array<RefinedProcess, kProcesses> kRefined{};
constexpr std::array<ExchangeInfo, 1> kExchanges{};
constexpr std::array<int, 1> kSharing{1};
constexpr std::array<void (*)(Workspace&, Channel&), kProcesses> kSolve{}, kCorrect{};
constexpr int kFirstExchange = 0, kFirstShare = 0;
inline Real coupling_torque(const Workspace&, int) { return 0; }

}  // namespace

#endif
