// adagen's runtime, the same for all robots.
#pragma once

namespace {

// Nothing tells the time.
[[maybe_unused]] inline void stamp(int) {}

}  // namespace
