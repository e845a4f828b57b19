// adagen's runtime, the same for all robots.
#pragma once

#include <chrono>

#include "description.hpp"
#include "sample/channel.hpp"
#include "status.hpp"

namespace {

// Measurements (--time, --stretches) of one program alone.
using Clock = std::chrono::steady_clock;

template <class AnySolver>
Text open_solver(AnySolver&, adagen::OneProcess, const adagen::Opening&) {
  return {};
}
Clock::time_point start_together(const Channel&) { return Clock::now(); }
Clock::time_point start_again(const Channel&) { return Clock::now(); }

class Takes {
 public:
  void forget(int) {}

  template <class Evaluate>
  int record(Channel&, int, Evaluate evaluate) {
    return evaluate();
  }

  // looks: at the clock, at the start and at the end.
  template <class Evaluate>
  void play(Channel&, int, Clock::rep* looks, Evaluate evaluate) {
    looks[0] = Clock::now().time_since_epoch().count();
    evaluate();
    looks[1] = Clock::now().time_since_epoch().count();
  }

  adagen::Table<int> messages(int) const { return {}; }
};

}  // namespace
