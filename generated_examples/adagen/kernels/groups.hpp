// adagen's runtime, the same for all robots.
#pragma once

#include <cstddef>
#include <cstring>
#include <type_traits>
#include <utility>

#include "../common.hpp"
#include "../constants.hpp"
#include "../sample/keep.hpp"
#include "../sample/robot.hpp"
#include "../sizes.hpp"
#include "../value.hpp"
#include "accelerate.hpp"
#include "algebra.hpp"
#include "inward.hpp"
#include "kinds.hpp"
#include "lanes.hpp"
#include "loop_settings.hpp"
#include "memory.hpp"
#include "outward.hpp"
#include "turned.hpp"
#include "weights.hpp"

namespace {

// Limbs side by side: joints of as many limbs as there are lanes are treated together, from the
// limbs' first joints outwards or back. A first lane that is idle goes by the second one's joints,
// has memory of its own, and what it gives is written over.
template <int count, int rows>
struct Limbs {
  int slot;                 // of the first joint of the first limb
  int joints[rows][count];  // all limbs' k-th joints, which are of one kind

  using T = std::conditional_t<count == 2, Two, Four>;
  static constexpr int kRows = rows;
  constexpr Joints<T> at(int k) const {
    Joints<T> result{slot + count * k, {}};
    for (int lane = 0; lane < count; ++lane) result.joint[lane] = joints[k][lane];
    return result;
  }
  // The link that a limb hangs on.
  constexpr int near(int lane) const {
    return kJoints[static_cast<std::size_t>(joints[0][lane])].parent;
  }
};

template <const auto& limbs, int first = 0, int last = limbs.kRows - 1>
struct LimbRows {
  static constexpr int kCount = last - first + 1;
  static constexpr JointKind kind(int k) { return limbs.at(first + k).any().kind; }
};

constexpr int kMostNumbers = 27;  // of what is split into lanes or joined: a Body

// One lane of what consists of numbers alone, and all lanes made one.
template <class T, template <class> class S, std::size_t... k>
ADAGEN_INLINE S<Value> lane_of(const S<T>& all, int lane, std::index_sequence<k...>) {
  const T* const numbers = reinterpret_cast<const T*>(&all);
  const Value own[]{numbers[k][lane]...};
  S<Value> result;
  std::memcpy(&result, own, sizeof result);
  return result;
}
template <class T, template <class> class S>
ADAGEN_INLINE S<Value> lane(const S<T>& all, int lane) {
  return lane_of(all, lane, std::make_index_sequence<sizeof all / sizeof(T)>{});
}
template <class T, std::size_t... lane>
ADAGEN_INLINE T lanes_of(const Value (&numbers)[kWidth<T>][kMostNumbers], std::size_t k,
                         std::index_sequence<lane...>) {
  return T{numbers[lane][k]...};
}
template <class T, template <class> class S, std::size_t... k>
ADAGEN_INLINE S<T> side_by_side(const S<Value>* const (&sides)[kWidth<T>],
                                std::index_sequence<k...>) {
  Value own[kWidth<T>][kMostNumbers];
  ADAGEN_FOR (lane, 0, kWidth<T>) std::memcpy(own[lane], sides[lane], sizeof *sides[lane]);
  S<T> result;
  T* const numbers = reinterpret_cast<T*>(&result);
  ((numbers[k] = lanes_of<T>(own, k, std::make_index_sequence<kWidth<T>>{})), ...);
  return result;
}
template <class T, template <class> class S>
ADAGEN_INLINE S<T> side_by_side(const S<Value>* const (&sides)[kWidth<T>]) {
  return side_by_side<T, S>(sides, std::make_index_sequence<sizeof(S<T>) / sizeof(T)>{});
}

template <const auto& limbs>
void outward_group(Workspace& w) {
  using T = typename std::decay_t<decltype(limbs)>::T;
  Frame<Value> frames[kWidth<T>];
  const Frame<Value>* sides[kWidth<T>];
  ADAGEN_FOR (lane, 0, kWidth<T>) {
    const int near = limbs.near(lane);
    frames[lane] = near == 0 ? ground(w) : frame_of(w, near == 0 ? 0 : near - 1);
    sides[lane] = &frames[lane];
  }
  Frame<T> at = side_by_side<T, Frame>(sides);
  each_row<LimbRows<limbs>, false>(
      [&](int k, auto kind) ADAGEN_ALWAYS { step_outward<true>(w, limbs.at(k), kind, at); });
}

// Adds to bodies those at the links beyond a row of joints.
template <int p, bool lost = false, class T>
ADAGEN_INLINE void meet_group(Workspace& w, const Joints<T>& joints, Body<T>& X) {
  const Body<Value> none{};
  const Body<Value>* sides[kWidth<T>];
  bool any = false;
  ADAGEN_FOR (lane, 0, kWidth<T>) {
    const std::size_t link = static_cast<std::size_t>(joints.joint[lane] + 1);
    const bool gathers = kRoles[p][link].gathers;
    any |= gathers;
    sides[lane] = gathers ? &w.bodies[link] : &none;
  }
  const int first = joints.joint[0];
  if (any) {
    Body<T> gathered = side_by_side<T, Body>(sides);
    if (lost && turned<true>(first) && !turned(first))
      turn_body(gathered, transposed(matrix_at<T>(w.at(joints.slot, kAxes))));
    X += gathered;
  }
  if (turned<lost>(first))
    add_own_link(w, joints, X);
  else
    add_bare_link(w, joints, X);
}

// Whether nothing but the links themselves is found beyond rows first .. last of limbs.
template <int p, class L>
constexpr bool bare_rows(const L& limbs, int first, int last) {
  for (int k = first; k <= last; ++k)
    for (const int joint : limbs.at(k).joint)
      if (kRoles[p][static_cast<std::size_t>(joint + 1)].gathers) return false;
  return true;
}

// See end_of_piece.
template <int p, class L>
constexpr int end_of_rows(const L& limbs, int last) {
  int more = 0;
  for (int k = 0; k < last; ++k) more += !bare_rows<p>(limbs, k, k);
  if (more >= kMostStretches) return 0;
  int end = last;
  while (end > 0 && bare_rows<p>(limbs, end - 1, end - 1)) --end;
  return end;
}

// The same of a sweep of limbs.
template <class L>
constexpr bool may_lose(const L& limbs) {
  for (int k = 0; k < L::kRows; ++k)
    if (kAnyTurnedIfLost && kTurnedIfLost[limbs.at(k).joint[0]]) return true;
  return false;
}
template <int p, const auto& limbs, class T>
void inward_group_again(Workspace& w, Body<T>& X);

// See each_inward.
template <int p, const auto& limbs, int last, class T>
ADAGEN_INLINE void take_inward(Workspace& w, Body<T>& X) {
  constexpr int end = end_of_rows<p>(limbs, last);
  constexpr bool quick = bare_rows<p>(limbs, end, last - 1);
  if constexpr (quick) meet_group<p>(w, limbs.at(last), X);
  each_row<LimbRows<limbs, end, last>, true>([&](int row, auto kind) ADAGEN_ALWAYS {
    const int k = end + row;
    if constexpr (!quick) meet_group<p>(w, limbs.at(k), X);
    if constexpr (kWide) keep_body(w, limbs.at(k), X);
    step_inward<false>(w, limbs.at(k), kind, X, [&](Body<T>& near) ADAGEN_ALWAYS {
      if (quick && k > end) add_bare_link(w, limbs.at(k - 1), near);
    });
  });
  if constexpr (end > 0) take_inward<p, limbs, end - 1>(w, X);
}

// The bodies that the limbs add to the links before them.
template <int p, const auto& limbs>
auto inward_group(Workspace& w) {
  using T = typename std::decay_t<decltype(limbs)>::T;
  Body<T> X{};
  take_inward<p, limbs, limbs.kRows - 1>(w, X);
  if constexpr (may_lose(limbs))
    if (__builtin_expect(w.lost, 0)) inward_group_again<p, limbs>(w, X);
  return X;
}

template <class T, class W, class L>
ADAGEN_INLINE Reached<T> reached_at([[maybe_unused]] const W& w, [[maybe_unused]] const L& limbs) {
  if constexpr (kWeighed) {
    const Reached<Value>* sides[kWidth<T>];
    ADAGEN_FOR (lane, 0, kWidth<T>)
      sides[lane] = &w.reached[static_cast<std::size_t>(limbs.near(lane))];
    return side_by_side<T, Reached>(sides);
  } else {
    return Reached<T>{};
  }
}

template <int p, const auto& limbs>
void accelerate_group(Workspace& w) {
  using T = typename std::decay_t<decltype(limbs)>::T;
  const Motion<Value>* sides[kWidth<T>];
  ADAGEN_FOR (lane, 0, kWidth<T>)
    sides[lane] = &w.motions[static_cast<std::size_t>(limbs.near(lane))];
  Motion<T> a = side_by_side<T, Motion>(sides);
  Reached<T> reached = reached_at<T>(w, limbs);
  each_row<LimbRows<limbs>, false>([&](int k, auto kind) ADAGEN_ALWAYS {
    const Joints<T> joints = limbs.at(k);
    move<false>(w, joints, kind, a);
    if constexpr (kWide) keep_force<false>(w, joints, a);
    reach(w, joints, kind, a, reached);
    ADAGEN_FOR (side, 0, kWidth<T>) {
      const std::size_t link = static_cast<std::size_t>(joints.joint[side] + 1);
      if (kRoles[p][link].parts) {
        w.motions[link] = lane(a, side);
        if constexpr (kWeighed) keep_reached(w, link, lane(reached, side));
      }
    }
  });
}

}  // namespace
