// adagen's runtime, the same for all robots.
#pragma once

#include <cstddef>
#include <vector>

#include "channel_threads.hpp"
#include "description.hpp"
#include "measured_alone.hpp"
#include "sizes.hpp"
#include "status.hpp"
#include "threads.hpp"
#include "topology.hpp"

namespace {

// Threads of processes 1, 2, .. onto the cores behind that of the program, in the order in which
// they share caches, if there are as many and nothing else is set.
Text open_solver(Solver& solver, adagen::OneProcess, const adagen::Opening& how) {
  std::vector<int> cores;
#if defined(__linux__)
  cpu_set_t own;
  if (sched_getaffinity(0, sizeof own, &own) == 0)
    for (int core = 0; core < CPU_SETSIZE; ++core)
      if (CPU_ISSET(core, &own)) cores.push_back(core);
#endif
  cores = adagen::in_order_of_caches(cores);
  const bool pin = how.pin && cores.size() >= static_cast<std::size_t>(kProcesses);
  return solver.open(pin ? cores.data() + 1 : nullptr, how.time_limit);
}

}  // namespace
