// adagen's runtime, the same for all robots.
// What follows the processes in a source: the solver, its C interface, the program around it.
// Of a sample solver there is none.
#pragma once
#if defined(ADAGEN_SOLVER)

#include <array>

#include "sizes.hpp"

namespace {

constexpr std::array<void (*)(Workspace&, Channel&), kProcesses> kRun{run_0};

}  // namespace

#include "alone.hpp"
#include "c_interface.hpp"

#ifndef ADAGEN_NO_MAIN
#include "program_alone.hpp"
#endif  // ADAGEN_NO_MAIN

#endif
