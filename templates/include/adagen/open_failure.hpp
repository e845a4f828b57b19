// adagen's runtime, the same for all robots.
#pragma once

#include "status.hpp"

namespace {

// Why the last open of a thread gave no solver.
thread_local Text open_failure;

}  // namespace
