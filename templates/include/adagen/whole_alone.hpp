// adagen's runtime, the same for all robots.
// What follows the processes in a source: the solver, its C interface, the program around it.
#pragma once

#include <array>

#include "sample/channel.hpp"
#include "sample/processes.hpp"
#include "sample/workspace.hpp"
#include "sizes.hpp"

namespace {

#if defined(ADAGEN_SOLVER)
constexpr std::array<void (*)(Workspace&, Channel&), kProcesses> kRun{run_0};
#endif

}  // namespace

#include "alone.hpp"
#include "c_interface.hpp"

#ifndef ADAGEN_NO_MAIN
#include "program_alone.hpp"
#endif  // ADAGEN_NO_MAIN
