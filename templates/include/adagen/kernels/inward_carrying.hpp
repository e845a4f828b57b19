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
#include "accelerate.hpp"
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

// Joints first .. last, of one freedom each, outwards. Each takes its part of that load: what unit
// wrenches there did to it, so that none waits for the next one.
template <int p, int first, int last>
ADAGEN_ONE_BY_ONE void accelerate_along(Workspace& w) {
  const Columns6 load = w.loads[last + 1];
  accelerate_after<p, first, last>(w, [&](int j) ADAGEN_ALWAYS {
    const Lanes& x = w.driven[static_cast<std::size_t>(j)];
    Value* const e = w.joints[static_cast<std::size_t>(j)].e;
    e[6] += e[7] * (((x[0] * load[0] + x[1] * load[1]) + (x[2] * load[2] + x[3] * load[3])) +
                    (x[4] * load[4] + x[5] * load[5]));
  });
}

}  // namespace
