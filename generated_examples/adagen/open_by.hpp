// adagen's runtime, the same for all robots.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdio>
#include <string>

#include "loops.hpp"
#include "program_setting.hpp"
#include "status.hpp"

namespace adagen {
namespace {
namespace loops {

// How far a loop or coupling is open, or how fast it opens: lengths and angles for themselves.
struct OpenBy {
  Real places, turns;
  bool fast;

  std::string in_words() const {
    std::string text;
    const auto add = [this, &text](Real size, const char* unit) {
      if (!(size > 0)) return;
      char number[40];
      std::snprintf(number, sizeof number, "%.3g %s%s", double(size), unit, fast ? "/s" : "");
      text += (text.empty() ? "" : " and ") + std::string(number);
    };
    add(places, "m"), add(turns, "rad");
    return text;
  }
};

// Of the loop, or the coupling behind all loops, with a number.
inline OpenBy open_by(int number, const Number* q, const Number* v, bool fast) {
  const Constraints now = constraints(q);
  const auto gap = [&](int row) {
    if (!fast) return now.gaps[std::size_t(row)];
    Real rate = 0;
    for (int j = 0; j < about.nv; ++j) rate += now.row(row)[j] * Real(v[j]);
    return rate;
  };
  Real places = 0, turns = 0;
  int row = 0;
  for (int k = 0; k < std::min(number + 1, about.loops.count); ++k)
    for (int i = 0; i < 6; ++i) {
      const bool linear = i < 3;
      if (!(linear ? about.loops[k].holds(i) : about.loops[k].bars(i - 3))) continue;
      const Real size = k == number ? gap(row) : 0;
      (linear ? places : turns) += size * size;
      ++row;
    }
  if (number >= about.loops.count) {
    const int own = number - about.loops.count;
    const Coupling& coupling = about.couplings[own];
    const bool slides = about.joints[coupling.joints[0]].kind == JointKind::kPrismatic;
    const Real size = gap(row + own);
    (slides ? places : turns) += size * size;
  }
  return {std::sqrt(places), std::sqrt(turns), fast};
}

// What follows a failure's words where a loop is open or opens; nothing elsewhere.
inline std::string how_far(int status, const Number* q, const Number* v) {
  const Failure kind = failure_kind(status);
  if (kind != kLoopOpen && kind != kLoopTorn) return "";
  const int number = failure_place(status) - about.joints.count;
  const std::string words = open_by(number, q, v, kind == kLoopTorn).in_words();
  return words.empty() ? "" : (kind == kLoopTorn ? ": it opens by " : ": it is open by ") + words;
}

}  // namespace loops
}  // namespace
}  // namespace adagen
