// adagen's runtime, the same for all robots.
#pragma once

#include <type_traits>

#include "../sizes.hpp"
#include "../value.hpp"
#include "algebra.hpp"
#include "groups.hpp"
#include "inward.hpp"
#include "inward_turned.hpp"
#include "kinds.hpp"
#include "lanes.hpp"
#include "memory.hpp"
#include "turned.hpp"

namespace {

// Whether limbs add their bodies to the trunk in the near links' axes: where the joints at both
// ends of such a link are computed in their own axes.
template <class L>
constexpr bool hands_own(const L& limbs) {
  bool any = false;
  for (int lane = 0; lane < kWidth<typename L::T>; ++lane) any |= turned_link(limbs.near(lane));
  return any && turned(limbs.at(0).joint[0]);
}
template <bool starts>
ADAGEN_INLINE void leave_own(Workspace& w, int link, Body<Value> X) {
  if (!turned_link(link)) turn_body(X, matrix_at(w.of(link - 1, kAxes)));
  add_to<starts>(w, link, X);
}

// See inward_group in groups.hpp: the same where limbs have turned joints.
template <int p, const auto& limbs, bool lost = false>
auto inward_group_turned(Workspace& w) {
  using T = typename std::decay_t<decltype(limbs)>::T;
  Body<T> X{};
  each_row<LimbRows<limbs>, true>([&](int k, auto kind) ADAGEN_ALWAYS {
    meet_group<p, lost>(w, limbs.at(k), X);
    if constexpr (kWide)
      keep_turned(w, limbs.at(k), turned<lost>(limbs.at(k).joint[0]) ? limbs.at(k).slot : -1, X);
    const auto slot = [k] {
      if (k > 0) return turned<lost>(limbs.at(k - 1).joint[0]) ? limbs.at(k - 1).slot : -1;
      return hands_own(limbs) ? 0 : -1;
    };
    step_turned<false, lost>(w, limbs.at(k), kind, slot(), X);
  });
  if constexpr (!lost && may_lose(limbs))
    if (__builtin_expect(w.lost, 0)) inward_group_again<p, limbs>(w, X);
  return X;
}

// The sweep of limbs that lost digits, once more, now in the links' own axes.
template <int p, const auto& limbs, class T>
ADAGEN_COLD void inward_group_again(Workspace& w, Body<T>& X) {
  w.lost = false;
  X = inward_group_turned<p, limbs, true>(w);
}

}  // namespace
