// adagen's runtime, the same for all robots.
#pragma once

#include <array>
#include <cstddef>
#include <cstring>
#include <utility>

#include "../constants.hpp"
#include "../sample/robot.hpp"
#include "../sizes.hpp"
#include "../tangents.hpp"
#include "../value.hpp"
#include "lanes.hpp"
#include "memory.hpp"
#if defined(ADAGEN_EMBEDDED)
#include "../embedded_tangents.hpp"
#endif

namespace {

// Passive forces of a process's joints, before all else and as many at once as a register holds.

// Numbers of a process's freedoms with passive forces, those with friction first; the last one
// comes again until registers are full.
template <std::size_t count>
struct PassiveForces {
  static constexpr std::size_t kFilled = (count + kLanes - 1) / kLanes * kLanes;
  typedef std::array<Real, kFilled> Numbers;

  std::array<int, kFilled> v{}, q{};
  alignas(kCacheLine) Numbers damping{}, friction{}, factor{}, stiffness{}, rest{};
  std::size_t with_friction = 0;
};

template <std::size_t count, std::size_t n>
constexpr PassiveForces<count> passive_forces(const int (&joints)[n]) {
  PassiveForces<count> result;
  std::size_t k = 0;
  for (const int j : joints) {
    const JointConstants& joint = kJoints[static_cast<std::size_t>(j)];
    const Passive& own = joint.passive;
    for (int freedom = 0; freedom < joint.nv; ++freedom) {
      const std::size_t end = k + 1 < count ? k + 1 : result.kFilled;
      if (own.friction != 0) result.with_friction = k + 1;
      for (; k < end; ++k) {
        result.v[k] = joint.v + freedom, result.q[k] = joint.q;
        result.damping[k] = Real(own.damping), result.friction[k] = Real(own.friction);
        result.factor[k] = Real(1 / own.friction_speed);
        result.stiffness[k] = Real(own.stiffness), result.rest[k] = Real(own.rest);
      }
    }
  }
  return result;
}

// Of one state as many freedoms as lanes; of a batch one, whose lanes hold states.
#if defined(ADAGEN_EMBEDDED)
typedef Value RatesAtOnce;
ADAGEN_INLINE Value tangent_of(const Value& rate) { return embedded_tangent(rate); }
#else
typedef Lanes RatesAtOnce;
ADAGEN_INLINE Lanes tangent_of(const Lanes& rate) { return hyperbolic_tangent(rate); }
#endif
constexpr std::size_t kRatesAtOnce = sizeof(RatesAtOnce) / sizeof(Value);

template <class T>
ADAGEN_INLINE T values_at(const Value* x, const int* place) {
  if constexpr (kRatesAtOnce == 1)
    return x[*place];
  else
    return numbers_at<T>(x, place, std::make_index_sequence<kRatesAtOnce>{});
}
template <class T>
ADAGEN_INLINE auto constants_from(const Real* x) {
  if constexpr (kRatesAtOnce == 1)
    return *x;
  else
    return from_memory<T>(x);
}

template <class T, std::size_t count>
ADAGEN_INLINE void put_spent(const T& x, const int* place, std::array<Value, count>& to) {
  Value each[kRatesAtOnce];
  std::memcpy(each, &x, sizeof each);
  for (std::size_t lane = 0; lane < kRatesAtOnce; ++lane)
    to[static_cast<std::size_t>(place[lane])] = each[lane];
}

template <std::size_t count>
void take_passive(Workspace& w, const PassiveForces<count>& of) {
  using T = RatesAtOnce;
  const Value *const q = w.q, *const v = w.v;
  for (std::size_t k = 0; k < count; k += kRatesAtOnce) {
    const T rates = values_at<T>(v, &of.v[k]);
    T spent = rates * constants_from<T>(&of.damping[k]), squares = spent * spent;
    const auto take = [&](const T& more) ADAGEN_ALWAYS { spent += more, squares += more * more; };
    if (kAnyFriction && k < of.with_friction)
      take(tangent_of(rates * constants_from<T>(&of.factor[k])) *
           constants_from<T>(&of.friction[k]));
    if constexpr (kAnySpring)
      take((values_at<T>(q, &of.q[k]) - constants_from<T>(&of.rest[k])) *
           constants_from<T>(&of.stiffness[k]));
    put_spent(spent, &of.v[k], w.spent);
    if constexpr (kWeighed) put_spent(squares, &of.v[k], w.spent_squares);
  }
}

}  // namespace
