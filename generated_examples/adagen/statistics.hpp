// adagen's runtime, the same for all robots.
#pragma once

#include <algorithm>
#include <chrono>
#include <cstddef>
#include <numeric>
#include <vector>

#include "program_setting.hpp"

namespace adagen {
namespace {

struct Statistics {
  double median = 0, least = 0, percentile99 = 0, middle = 0;
};

// The mean of the middle half, of sorted times: a median that is finer than the clock, which may
// tick every 10 ns only.
double middle_of(const std::vector<double>& ns) {
  const std::size_t quarter = ns.size() / 4;
  const auto first = ns.begin() + static_cast<std::ptrdiff_t>(quarter);
  const auto last = ns.end() - static_cast<std::ptrdiff_t>(quarter);
  return std::accumulate(first, last, 0.0) / static_cast<double>(last - first);
}

Statistics statistics(std::vector<double> ns) {
  std::sort(ns.begin(), ns.end());
  const auto at = [&ns](double part) {
    return ns[std::min(ns.size() - 1,
                       static_cast<std::size_t>(part * static_cast<double>(ns.size())))];
  };
  return {at(0.5), ns.front(), at(0.99), middle_of(ns)};
}

double nanoseconds(std::chrono::steady_clock::rep ticks) {
  using Duration = std::chrono::steady_clock::duration;
  return std::chrono::duration<double, std::nano>(Duration(ticks)).count();
}

// Time of one clock reading; each time between two readings contains one.
double clock_cost() {
  using Clock = std::chrono::steady_clock;
  double best = 1e9;
  for (int k = 0; k < 64; ++k) {
    const Clock::time_point start = Clock::now();
    for (int i = 0; i < 64; ++i) (void)Clock::now();
    best = std::min(best, nanoseconds((Clock::now() - start).count()) / 65);
  }
  return best;
}

}  // namespace
}  // namespace adagen
