// adagen's runtime, the same for all robots.
#pragma once

#include <array>
#include <cstddef>

#include "channel_threads.hpp"
#include "description.hpp"
#include "measured_alone.hpp"
#include "sizes.hpp"
#include "status.hpp"
#include "threads.hpp"

namespace {

// Threads of processes 1, 2, .. onto the cores behind that of the program, if there are as many and
// nothing else is set.
Text open_solver(Solver& solver, adagen::OneProcess, const adagen::Opening& how) {
  std::array<int, static_cast<std::size_t>(kProcesses)> cores{};
  std::size_t count = 0;
#if defined(__linux__)
  cpu_set_t own;
  if (sched_getaffinity(0, sizeof own, &own) == 0)
    for (int core = 0; core < CPU_SETSIZE && count < cores.size(); ++core)
      if (CPU_ISSET(core, &own)) cores[count++] = core;
#endif
  const bool pin = how.pin && count == cores.size();
  return solver.open(pin ? cores.data() + 1 : nullptr, how.time_limit);
}

}  // namespace
