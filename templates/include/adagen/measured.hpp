// adagen's runtime, the same for all robots.
#pragma once

#include <mpi.h>

#include <algorithm>
#include <chrono>
#include <cstddef>
#include <string>
#include <vector>

#include "channel.hpp"
#include "description.hpp"
#include "open.hpp"
#include "relax.hpp"
#include "sample/solver.hpp"
#include "sizes.hpp"
#include "status.hpp"

namespace {

// Measurements (--time, --stretches) of several processes.
using Clock = std::chrono::steady_clock;

Text open_solver(Solver& solver, MPI_Comm comm, const adagen::Opening& how) {
  const std::string wrong =
      solver.channel.open(comm, mode_of(how.channel), how.time_limit, how.hosts);
  return Text(wrong.c_str());
}

// All processes that take part in an evaluation start it at the same instant of their common clock;
// hosts have none. One alone starts at once: to meet others that it does not need would only cool
// its caches.
Clock::time_point start_together(const Channel& channel) {
  if (kAlone) return Clock::now();
  if (!channel.on_one_host()) {
    MPI_Barrier(channel.comm());
    return Clock::now();
  }
  Clock::rep start = 0;
  if (channel.rank() == 0)
    start = (Clock::now() + std::chrono::microseconds(5)).time_since_epoch().count();
  MPI_Bcast(&start, static_cast<int>(sizeof start), MPI_BYTE, 0, channel.comm());
  const Clock::time_point at{Clock::duration(start)};
  const Clock::time_point latest = Clock::now() + std::chrono::microseconds(50);
  Clock::time_point now;
  while ((now = Clock::now()) < at && now < latest) relax();
  return now;
}

// The same where an evaluation has just ended.
Clock::time_point start_again(const Channel& channel) {
  if (!kAlone) MPI_Barrier(channel.comm());
  return Clock::now();
}

// Evaluations whose messages are noted once, and played as often as asked for.
class Takes {
 public:
  void forget(int count) { takes_.assign(static_cast<std::size_t>(count), Take()); }

  template <class Evaluate>
  int record(Channel& channel, int k, Evaluate evaluate) {
    Take& take = takes_[static_cast<std::size_t>(k)];
    take.record();
    channel.use(&take);
    const int status = evaluate();
    channel.use(nullptr);
    return status;
  }

  // looks: at the clock, at the start, at each message and at the end.
  template <class Evaluate>
  void play(Channel& channel, int k, Clock::rep* looks, Evaluate evaluate) {
    Take& take = takes_[static_cast<std::size_t>(k)];
    take.play();
    channel.use(&take);
    const Clock::rep start = Clock::now().time_since_epoch().count();
    evaluate();
    const Clock::rep end = Clock::now().time_since_epoch().count();
    channel.use(nullptr);
    *looks = start;
    *std::copy(take.looks().begin(), take.looks().end(), looks + 1) = end;
  }

  adagen::Table<int> messages(int k) const {
    const std::vector<int>& found = takes_[static_cast<std::size_t>(k)].messages();
    return {found.data(), static_cast<int>(found.size())};
  }

 private:
  std::vector<Take> takes_;
};

}  // namespace
