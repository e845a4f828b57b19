// adagen's runtime, the same for all robots.
#pragma once

#include <new>

#include "open_failure.hpp"
#include "status.hpp"

namespace {

template <class AnySolver>
AnySolver* opened(const int* cores, double time_limit) {
  open_failure.clear();
  auto* const solver = new (std::nothrow) AnySolver;
  if (solver == nullptr) {
    open_failure += "not enough memory";
    return nullptr;
  }
  open_failure = solver->open(cores, time_limit);
  if (open_failure.empty()) return solver;
  delete solver;
  return nullptr;
}

}  // namespace
