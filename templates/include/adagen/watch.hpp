// adagen's runtime, the same for all robots.
#pragma once

#include <cmath>
#include <csignal>
#include <cstddef>
#include <cstdio>
#include <cstring>

#include "options.hpp"

namespace adagen {
namespace {

// Bounds the waits that the channel does not: MPI's own collective calls wait for ever for a
// process that was stopped. Whoever sees no progress for the time limit, and a second for the
// channel to say it better, ends, and mpiexec ends the others. Time is counted in parts, by a
// signal after each: however long the computer slept in one, or this process was stopped, it is one
// part.
class Watch {
 public:
  // Before MPI is there, which takes a while to start on many hosts, and waits for all of them.
  void start_of_mpi(double time_limit) {
    constexpr double kStart = 10;
    std::snprintf(text(), kLength, "error: MPI did not start within %g s\n", time_limit + kStart);
    watch(time_limit + kStart);
  }

  void start(int rank, double time_limit) {
    std::snprintf(text(), kLength,
                  "error: process %d: another process did not answer within the time limit\n",
                  rank);
    watch(time_limit + 1);
  }

  // There was progress: the time starts again.
  void again() const {
#if defined(__unix__) || defined(__APPLE__)
    const double part = seconds_ / kParts;
    itimerval timer = {};
    timer.it_value.tv_sec = static_cast<decltype(timer.it_value.tv_sec)>(part);
    timer.it_value.tv_usec =
        static_cast<decltype(timer.it_value.tv_usec)>(1e6 * (part - std::floor(part)));
    timer.it_interval = timer.it_value;
    parts() = 0;
    setitimer(ITIMER_REAL, &timer, nullptr);
#endif
  }

 private:
  static constexpr std::size_t kLength = 100;

  void watch(double seconds) {
    seconds_ = seconds;
#if defined(__unix__) || defined(__APPLE__)
    struct sigaction action = {};
    action.sa_handler = give_up;
    sigaction(SIGALRM, &action, nullptr);
#endif
    again();
  }

#if defined(__unix__) || defined(__APPLE__)
  static constexpr int kParts = 8;

  // How many parts have passed without progress.
  static volatile std::sig_atomic_t& parts() {
    static volatile std::sig_atomic_t count = 0;
    return count;
  }
#endif

  static char* text() {
    static char place[kLength];
    return place;
  }

#if defined(__unix__) || defined(__APPLE__)
  // Only what a signal handler may call.
  static void give_up(int) {
    parts() = parts() + 1;
    if (parts() < kParts) return;
    [[maybe_unused]] const auto written = write(STDERR_FILENO, text(), std::strlen(text()));
    _exit(kFault);
  }
#endif

  double seconds_ = 0;
};

}  // namespace
}  // namespace adagen
