// adagen's runtime, the same for all robots.
#pragma once
#if !defined(ADAGEN_SOLVER)
#define ADAGEN_SAMPLE_CUTS  // read alone, it is of a solver whose processes meet, and that refines
#endif

#include <cstddef>

#include "../constants.hpp"
#include "../sample/robot.hpp"
#include "../spatial.hpp"
#include "../value.hpp"
#include "algebra.hpp"
#include "kinds.hpp"
#include "lanes.hpp"
#include "memory.hpp"
#include "mobility.hpp"
#include "wrenches.hpp"

namespace {

// The mobility of a run's last link, by unit wrenches on it that are carried to the run's first
// one, each in a lane: no mobility of the links between is needed, and nothing is subtracted.

// Results of unit wrenches carried from the far link of a run, in base axes.
struct Way {
  Mat6 moved;     // how the far link moves as the near one does: L of the whole run
  Mat6 own;       // mobility of the far link, the near one being held
  Columns6 free;  // acceleration of the far link by itself, the near one being held
};

// On the way from the far link: with x = S^T times the wrenches on a joint, its share of the
// mobility is x^T D^-1 x, and of the acceleration x^T times the joint's. kept: x is kept.
template <bool reversed, bool kept = false>
struct UnitWrenches {
  Vector<Lanes> n{}, f{};
  Lanes own[6]{}, free{};

  ADAGEN_INLINE UnitWrenches() {
    n.x[0] = 1, n.y[1] = 1, n.z[2] = 1, f.x[3] = 1, f.y[4] = 1, f.z[5] = 1;
  }

  ADAGEN_INLINE void take(const Lanes& x, const Lanes& driven, Value drive) {
    ADAGEN_FOR (i, 0, 6) own[i] += driven * x[i];
    free += x * drive;
  }

  // Passes a joint.
  ADAGEN_INLINE void pass(Workspace& w, int j, JointKind kind) {
    const Value* const e = w.joints[static_cast<std::size_t>(j)].e;
    const auto [along, by] = hand_on<reversed>(w, j, kind, n, f);
    if (kind == JointKind::kSpherical) {
      if constexpr (kAnySpherical)
        take(along.x, by.x, e[9]), take(along.y, by.y, e[10]), take(along.z, by.z, e[11]);
    } else if (kind == JointKind::kPlanar) {
      if constexpr (kAnyPlanar)
        take(along.x, by.x, e[6]), take(along.y, by.y, e[14]), take(along.z, by.z, e[22]);
    } else {
      take(along.x, by.x, e[6]);
      if constexpr (kept) w.driven[static_cast<std::size_t>(j)] = along.x;
    }
  }

  Way way() const {
    Way way;
    way.moved = from_rows({n, f});
    ADAGEN_FOR (i, 0, 6) {
      ADAGEN_FOR (k, 0, 6) way.own(i, k) = own[i < k ? i : k][i < k ? k : i];
      way.free[i] = free[i];
    }
    return way;
  }
};

// Joints first .. last, each on the link of the one before.
template <bool reversed, int first, int last>
ADAGEN_NOINLINE Way carry(Workspace& w) {
  static_assert(sizeof(Value) == sizeof(Real));
  UnitWrenches<reversed> wrenches;
  each_row<RunRows<first, last>, !reversed>(
      [&](int k, auto kind) ADAGEN_ALWAYS { wrenches.pass(w, first + k, kind); });
  return wrenches.way();
}

// Phi and b of the last link of a run that hangs on the ground.
template <int link>
void show(Workspace& w, const Way& way, Mat6& Phi, Columns6& b) {
  Phi = mobility_as_told(w, link, way.own);
  b = as_told(w, link, way.free);
}
// The same beyond a link whose Phi and b are known: Phi = L Phi L^T and what the run itself lets
// the far link do.
[[maybe_unused]] inline void show(const Way& way, const Mat6& near, const Columns6& near_bias,
                                  Mat6& Phi, Columns6& b) {
  Phi = way.own + way.moved * near * transposed(way.moved);
  b = way.free + way.moved * near_bias;
}

// What the near link feels of the load of the link beyond joints first .. last.
template <int first, int last>
void deliver_along(Workspace& w, const Mat6& moved) {
  w.loads[kJoints[first].parent] += transposed(moved) * w.loads[last + 1];
}

}  // namespace
