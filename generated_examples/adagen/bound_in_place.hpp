// adagen's runtime, the same for all robots.
#pragma once

#include "error_bound.hpp"
#include "sample/workspace.hpp"

namespace {

// The bound of the error of the last evaluation.
[[maybe_unused]] inline double error_bound(const Workspace& w) {
  return bound_of(static_cast<double>(w.certificate[0]), static_cast<double>(w.certificate[1]));
}

}  // namespace
