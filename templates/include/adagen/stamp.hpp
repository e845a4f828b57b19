// adagen's runtime, the same for all robots.
#pragma once

#if !defined(ADAGEN_EMBEDDED)
#include <chrono>
#endif

namespace {

#if defined(ADAGEN_EMBEDDED)
// Nothing tells the time.
[[maybe_unused]] inline void stamp(int) {}
#else
// Time stamps between the stages of a process's work (--trace); nothing is stamped otherwise.
std::chrono::steady_clock::rep* trace_stamps =
    nullptr;  // where an evaluation puts them: its start, then each end

[[maybe_unused]] inline void stamp(int k) {
  if (trace_stamps) trace_stamps[k] = std::chrono::steady_clock::now().time_since_epoch().count();
}
#endif

}  // namespace
