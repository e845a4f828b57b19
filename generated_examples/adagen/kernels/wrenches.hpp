// adagen's runtime, the same for all robots.
#pragma once
#if !defined(ADAGEN_SOLVER)
#define ADAGEN_SAMPLE_CUTS  // read alone, it is of a solver whose processes meet, and that refines
#endif

#include <cstddef>

#include "../constants.hpp"
#include "../sample/keep.hpp"
#include "../sample/robot.hpp"
#include "../sizes.hpp"
#include "../spatial.hpp"
#include "../status.hpp"
#include "../value.hpp"
#include "algebra.hpp"
#include "factors.hpp"
#include "guards.hpp"
#include "inward.hpp"
#include "lanes.hpp"
#include "loop_settings.hpp"
#include "memory.hpp"
#include "mobility.hpp"
#include "spherical.hpp"

namespace {

// Forces at handles: what they do inside a run.

// How a wrench drives a joint: S^T and D^-1 S^T times it, freedom by freedom.
template <class T>
struct Driven {
  Vector<T> along, by;
};

// A wrench on the far link becomes what the near link feels of it, L^T times it; what it drives the
// joint with is returned.
template <bool reversed, class T>
ADAGEN_INLINE Driven<T> hand_on(Workspace& w, int j, JointKind kind, Vector<T>& n, Vector<T>& f) {
  const Memory& memory = w.joints[static_cast<std::size_t>(j)];
  const Value* const e = memory.e;
  const Vector<Value>& r = memory.r;
  if constexpr (reversed) n += cross(f, r);
  Driven<T> driven{};
  if (kind == JointKind::kSpherical) {
    if constexpr (kAnySpherical) {
      driven = {n, solved(e + 12, n)};
      f.x -= e[0] * n.x + e[3] * n.y + e[6] * n.z;
      f.y -= e[1] * n.x + e[4] * n.y + e[7] * n.z;
      f.z -= e[2] * n.x + e[5] * n.y + e[8] * n.z;
      n = kSphericalRotors ? driven.by * rotor_of(single(j)) : Vector<T>{};
      if constexpr (!reversed) n += -cross(f, r);
    }
    return driven;
  }
  if (kind == JointKind::kPlanar) {
    if constexpr (kAnyPlanar) {
      const Matrix<Value> R = matrix_at(w.of(j, kAxes));
      const auto taken = [&n, &f](const Value* of, const T& x) {
        n.x -= of[0] * x, n.y -= of[1] * x, n.z -= of[2] * x;
        f.x -= of[3] * x, f.y -= of[4] * x, f.z -= of[5] * x;
        return x * of[7];
      };
      driven.along.x = dot(f, Vector<Value>{R.x.x, R.y.x, R.z.x});
      driven.by.x = taken(e, driven.along.x);
      driven.along.y = dot(f, Vector<Value>{R.x.y, R.y.y, R.z.y});
      driven.by.y = taken(e + 8, driven.along.y);
      driven.along.z = dot(n, Vector<Value>{R.x.z, R.y.z, R.z.z});
      driven.by.z = taken(e + 16, driven.along.z);
    }
    if constexpr (!reversed) n += -cross(f, r);
    return driven;
  }
  const T x = dot(kind == JointKind::kPrismatic ? f : n, axis_of(w, single(j)));
  driven.along.x = x;
  driven.by.x = x * e[7];
  if constexpr (!reversed) n += -cross(f, r);
  n.x -= e[0] * x, n.y -= e[1] * x, n.z -= e[2] * x;
  f.x -= e[3] * x, f.y -= e[4] * x, f.z -= e[5] * x;
  return driven;
}

// A link's own load is added to the wrench that is passed to it.
ADAGEN_INLINE void take_load(const Workspace& w, int link, Vector<Value>& n, Vector<Value>& f) {
  const Columns6& load = w.loads[static_cast<std::size_t>(link)];
  n += Vector<Value>{load[0], load[1], load[2]};
  f += Vector<Value>{load[3], load[4], load[5]};
}

// A wrench on a link beyond a floating joint moves that link and nothing else.
template <bool reversed>
ADAGEN_INLINE void push_free(Workspace& w, int j, Vector<Value>& n, Vector<Value>& f) {
  if constexpr (reversed) n += cross(f, w.joints[static_cast<std::size_t>(j)].r);
  Body<Value> X = w.free[static_cast<std::size_t>(j)];
  X.n = -n, X.f = -f;
  Motion<Value> a;
  if (!solve_free(X, a)) fail(w, kFactorization, j);
  Value* const e = w.joints[static_cast<std::size_t>(j)].e;
  e[0] += a.angular.x, e[1] += a.angular.y, e[2] += a.angular.z;
  e[3] += a.linear.x, e[4] += a.linear.y, e[5] += a.linear.z;
  n = f = Vector<Value>{};
}

// Wrench on the far link: its effect on the joint, and the wrench that reaches the near link.
template <bool reversed>
ADAGEN_INLINE void deliver(Workspace& w, int j, Vector<Value>& n, Vector<Value>& f) {
  Value* const e = w.joints[static_cast<std::size_t>(j)].e;
  if constexpr (kPassesFree) {
    if (kJoints[static_cast<std::size_t>(j)].kind == JointKind::kFloating)
      return push_free<reversed>(w, j, n, f);
  }
  const JointKind kind = kJoints[static_cast<std::size_t>(j)].kind;
  const Vector<Value> driven = hand_on<reversed>(w, j, kind, n, f).by;
  if (kind == JointKind::kPlanar) {
    if constexpr (kAnyPlanar) e[6] += driven.x, e[14] += driven.y, e[22] += driven.z;
    return;
  }
  if (kind == JointKind::kSpherical) {
    if constexpr (kAnySpherical) e[9] += driven.x, e[10] += driven.y, e[11] += driven.z;
  } else {
    e[6] += driven.x;
  }
}

// The loads of links beyond joints first .. last, each on the link of the one before, from the last
// link to the one that the first joint is on; through: of the last link alone.
template <int first, int last, bool through = false>
void deliver(Workspace& w) {
  Vector<Value> n{}, f{};
  for (int j = last; j >= first; --j) {
    if (!through || j == last) take_load(w, j + 1, n, f);
    if constexpr (kWide) keep_load(w, j, n, f);
    deliver<false>(w, j, n, f);
  }
  w.loads[kJoints[first].parent] += columns_of({n, f});
}
// The same where the ground's side lies beyond: from the first joint's link to the last one's.
template <int first, int last, bool through = false>
void deliver_reversed(Workspace& w) {
  Vector<Value> n{}, f{};
  for (int j = first; j <= last; ++j) {
    if (!through || j == first) take_load(w, kJoints[static_cast<std::size_t>(j)].parent, n, f);
    if constexpr (kWide) keep_load(w, j, n, f);
    deliver<true>(w, j, n, f);
  }
  w.loads[last + 1] += columns_of({n, f});
}

}  // namespace
