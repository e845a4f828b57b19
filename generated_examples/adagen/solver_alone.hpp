// adagen's runtime, the same for all robots.
#pragma once

#include "in_place.hpp"
#include "sizes.hpp"
#include "status.hpp"

namespace {

// A solver for one process.
class Solver : public InPlace {
 public:
  int solve_at_root(const Number* q, const Number* v, const Number* tau, Number* qdd) {
    return solve(q, v, tau, qdd);
  }
  int end_at_root() { return kFine; }
  void close() {}
};

}  // namespace
