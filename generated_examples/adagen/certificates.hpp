// adagen's runtime, the same for all robots.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdio>
#include <limits>
#include <string>
#include <vector>

#include "json.hpp"

namespace adagen {
namespace {

// The bounds of the errors of all states, for people and programs.
class Certificates {
 public:
  void note(double bound) { bounds_.push_back(bound); }

  // As a member of a JSON object, a comma before it; nothing where answers are not certified.
  std::string json() const {
    if (bounds_.empty()) return "";
    return ", \"error_bound\": {\"median\": " + figure(at(0.5)) + ", \"max\": " + figure(at(1)) +
           "}";
  }

  // The same of every state, for the result file.
  std::string every() const {
    if (bounds_.empty()) return "";
    std::string text = ", \"error_bounds\": [";
    for (std::size_t s = 0; s < bounds_.size(); ++s)
      text += (s == 0 ? "" : ", ") + figure(bounds_[s]);
    return text + "]";
  }

  void print(std::FILE* out) const {
    if (bounds_.empty()) return;
    std::fprintf(out, "error bound: median %.1e, largest %.1e\n", at(0.5), at(1));
  }

 private:
  // The least bound that a part of all states does not exceed; states without answers come last.
  double at(double part) const {
    std::vector<double> sorted = bounds_;
    for (double& bound : sorted)
      if (!(bound == bound)) bound = std::numeric_limits<double>::infinity();
    std::sort(sorted.begin(), sorted.end());
    return sorted[static_cast<std::size_t>(part * static_cast<double>(sorted.size() - 1))];
  }

  // Infinity is no JSON number, nor is the bound of a state that failed.
  std::vector<double> bounds_;
};

}  // namespace
}  // namespace adagen
