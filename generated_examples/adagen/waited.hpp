// adagen's runtime, the same for all robots.
#pragma once

#include <algorithm>
#include <chrono>

namespace {

// How long another process or thread has been waited for. Between two looks no more than an eighth
// of the limit counts, or 0.1 s: what the whole computer slept, or all processes were stopped for,
// is not held against the one that is waited for.
class Waited {
 public:
  using Clock = std::chrono::steady_clock;

  explicit Waited(Clock::duration limit) : limit_(limit), last_(Clock::now()) {}

  bool too_long() {
    const Clock::time_point now = Clock::now();
    waited_ += std::min(now - last_, std::max(limit_ / 8, kShort));
    last_ = now;
    return waited_ > limit_;
  }

 private:
  static constexpr Clock::duration kShort = std::chrono::milliseconds(100);

  Clock::duration limit_, waited_{};
  Clock::time_point last_;
};

}  // namespace
