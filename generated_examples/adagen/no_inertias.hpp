// adagen's runtime, the same for all robots.
#pragma once

#include "sample/workspace.hpp"

namespace {

[[maybe_unused]] inline void apply_parameters(Workspace&) {}

}  // namespace
