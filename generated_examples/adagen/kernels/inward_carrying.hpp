// adagen's runtime, the same for all robots.
#pragma once
#if !defined(ADAGEN_SOLVER)
#define ADAGEN_SAMPLE_CUTS  // read alone, it is of a solver whose processes meet, and that refines
#endif

#include <cstddef>

#include "../common.hpp"
#include "../sample/robot.hpp"
#include "../spatial.hpp"
#include "../value.hpp"
#include "carry.hpp"
#include "columns.hpp"
#include "inward.hpp"
#include "inward_columns.hpp"
#include "kinds.hpp"
#include "lanes.hpp"
#include "memory.hpp"

namespace {

// Joints last .. first inwards by columns, and unit wrenches on the last link along with the sweep:
// each has to wait for its own numbers, so that the other one costs little.
template <int p, int first, int last, bool starts>
ADAGEN_NOINLINE Way inward_and_carry(Workspace& w) {
  if constexpr (kInColumns) {
    UnitWrenches<false, true> wrenches;
    const auto pass = [&](int j, auto kind) ADAGEN_ALWAYS { wrenches.pass(w, j, kind); };
    if (inward_in_columns_with<p, first, last, starts>(w, pass)) return wrenches.way();
  } else {
    inward<p, first, last, starts>(w);
  }
  UnitWrenches<false, true> wrenches;
  for (int j = last; j >= first; --j)
    wrenches.pass(w, j, kJoints[static_cast<std::size_t>(j)].kind);
  return wrenches.way();
}

// The load of the link beyond joints first .. last, of one freedom each: gives each joint its part
// by what unit wrenches there did to it, so that none waits for the next one.
template <int first, int last>
void deliver_along(Workspace& w, const Way& way) {
  const Columns6& load = w.loads[last + 1];
  Lanes wrench{};
  ADAGEN_FOR (i, 0, 6) wrench[i] = load[i];
  for (int j = first; j <= last; ++j) {
    const Lanes part = w.driven[static_cast<std::size_t>(j)] * wrench;
    Value* const e = w.joints[static_cast<std::size_t>(j)].e;
    e[6] += e[7] * (((part[0] + part[1]) + (part[2] + part[3])) + (part[4] + part[5]));
  }
  w.loads[kJoints[first].parent] += way.moved.transpose() * load;
}

}  // namespace
