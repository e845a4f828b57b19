// adagen's runtime, the same for all robots.
#pragma once

#include <cstddef>
#include <type_traits>

#include "../common.hpp"
#include "../sizes.hpp"
#include "../value.hpp"
#include "certify.hpp"
#include "groups.hpp"
#include "kinds.hpp"
#include "lanes.hpp"
#include "loop_settings.hpp"
#include "memory.hpp"
#include "weights.hpp"

namespace {

// The same for limbs side by side; see groups.hpp.
template <int p, class T>
ADAGEN_INLINE void meet_left_group(Workspace& w, const Joints<T>& joints, Left<T>& X) {
  const Left<Value> none{};
  const Left<Value>* sides[kWidth<T>];
  bool any = false;
  ADAGEN_FOR (lane, 0, kWidth<T>) {
    const std::size_t link = static_cast<std::size_t>(joints.joint[lane] + 1);
    const bool gathers = kRoles[p][link].gathers;
    any |= gathers;
    sides[lane] = gathers ? &w.lefts[link] : &none;
  }
  if (any) X += side_by_side<T, Left>(sides);
  if (!weighed_apart(joints.joint[0])) add_weighed_link(w, joints, X);
}

// What is left for the links that the limbs hang on.
template <int p, const auto& limbs>
auto weigh_group(Workspace& w) {
  using T = typename std::decay_t<decltype(limbs)>::T;
  Left<T> X{};
  Found<T> found{};
  each_row<LimbRows<limbs>, true>([&](int k, auto kind) ADAGEN_ALWAYS {
    meet_left_group<p>(w, limbs.at(k), X);
    weigh_joint<false>(w, limbs.at(k), kind, X, found);
  });
  constexpr bool idle = limbs.at(0).joint[0] == limbs.at(0).joint[1];  // the first lane
  ADAGEN_FOR (side, idle, kWidth<T>) w.seen += found.seen[side], w.rounded += found.rounded[side];
  return X;
}

// The links beyond joints first .. last of one of the limbs; see spread_along.
template <const auto& limbs, int side, int first, int last>
[[maybe_unused]] Vector<Value> spread_in_lane(Workspace& w, Vector<Value> p, Value& turning) {
  Value sum{};
  for (int k = first; k <= last; ++k) {
    const auto joints = limbs.at(k);
    const auto& r = w.memory(joints).r;
    p += Vector<Value>{r.x[side], r.y[side], r.z[side]};
    sum += mass_of(w, single(joints.joint[side])) * dot(p, p);
  }
  turning += 4 * sum;
  return p;
}

}  // namespace
