// adagen's runtime, the same for all robots.
#pragma once

#include <new>

#include "open_failure.hpp"
#include "status.hpp"

namespace {

template <class AnySolver>
AnySolver* opened() {
  auto* const solver = new (std::nothrow) AnySolver;
  open_failure.clear();
  if (solver == nullptr) open_failure += "not enough memory";
  return solver;
}

}  // namespace
