// adagen's runtime, the same for all robots.
#pragma once

#include "sample/channel.hpp"
#include "sample/workspace.hpp"
#include "sizes.hpp"

namespace {

// States of process 0 alone; there are no other processes.
struct Batch {
  int count;
  const Number *q, *v, *tau;
  Number* qdd;
  double* bounds;
};

class Handout {
 public:
  template <class Solve>
  static bool hand_out(Channel&, int, const Batch&, const Workspace&, Solve, int&) {
    return true;
  }
  static void lose_all(const Batch&) {}
  static void end(Channel&, int&) {}
  template <class Solve, class Take>
  static void help(Channel&, Solve, Take, int&, bool) {}
};

}  // namespace
