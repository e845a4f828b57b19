// adagen's runtime, the same for all robots.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdio>
#include <string>
#include <vector>

#include "json.hpp"
#include "program_setting.hpp"

namespace adagen {
namespace {

// The sizes of the corrections of all states, for people and programs: errors before each step.
class Corrections {
 public:
  // Of the last evaluation.
  void note(const Solver& solver) {
    for (int k = 0; k < about.refine; ++k) sizes_.push_back(solver.correction(k));
  }

  // As a member of a JSON object, a comma before it; nothing without refinement.
  std::string json() const {
    if (sizes_.empty()) return "";
    std::string text = ", \"refine\": {\"steps\": " + std::to_string(about.refine);
    for (const double part : {0.5, 1.0}) {
      text += part < 1 ? ", \"correction_median\": [" : ", \"correction_max\": [";
      for (int k = 0; k < about.refine; ++k) text += (k == 0 ? "" : ", ") + figure(at(k, part));
      text += ']';
    }
    return text + "}";
  }

  // The same of every state, for the result file.
  std::string every() const {
    if (sizes_.empty()) return "";
    std::string text = ", \"corrections\": [";
    for (std::size_t s = 0; s < sizes_.size(); s += steps()) {
      text += s == 0 ? "[" : ", [";
      for (std::size_t k = 0; k < steps(); ++k)
        text += (k == 0 ? "" : ", ") + figure(sizes_[s + k]);
      text += ']';
    }
    return text + "]";
  }

  void print(std::FILE* out) const {
    if (sizes_.empty()) return;
    for (int k = 0; k < about.refine; ++k)
      std::fprintf(out, "refine error before step %d: median %.1e, largest %.1e\n", k + 1,
                   at(k, 0.5), at(k, 1));
  }

 private:
  static std::size_t steps() { return static_cast<std::size_t>(about.refine); }

  // Of correction k, the least value that a part of all states does not exceed.
  double at(int k, double part) const {
    std::vector<double> of_step;
    for (std::size_t s = static_cast<std::size_t>(k); s < sizes_.size(); s += steps())
      of_step.push_back(sizes_[s]);
    std::sort(of_step.begin(), of_step.end());
    const double place = part * static_cast<double>(of_step.size() - 1);
    return of_step[static_cast<std::size_t>(place)];
  }

  // Infinity is no JSON number.
  std::vector<double> sizes_;
};

}  // namespace
}  // namespace adagen
