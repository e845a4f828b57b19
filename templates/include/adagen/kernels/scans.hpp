// adagen's runtime, the same for all robots.
#pragma once

#include <cstddef>
#include <utility>

#include "../value.hpp"
#include "algebra.hpp"
#include "blocks.hpp"
#include "lanes.hpp"
#include "shuffles.hpp"

namespace {

// Sums and products over the lanes before each, by the scan of Hillis and Steele.
constexpr std::make_index_sequence<kPerBlock> kEachLane;

// What lies a distance before each lane. The first lanes keep their own.
template <int distance, std::size_t... lane>
ADAGEN_INLINE Lanes before(const Lanes& x, std::index_sequence<lane...>) {
  return shuffled<(lane < distance ? lane : lane - distance)...>(x, x);
}
template <int distance>
ADAGEN_INLINE Lanes before(const Lanes& x) {
  return before<distance>(x, kEachLane);
}
template <int distance>
ADAGEN_INLINE Vector<Lanes> before(const Vector<Lanes>& x) {
  return {before<distance>(x.x), before<distance>(x.y), before<distance>(x.z)};
}
template <int distance>
ADAGEN_INLINE Matrix<Lanes> before(const Matrix<Lanes>& x) {
  return {before<distance>(x.x), before<distance>(x.y), before<distance>(x.z)};
}
template <int distance, std::size_t... lane>
constexpr LaneBits far_lanes(std::index_sequence<lane...>) {
  return LaneBits{(lane < distance ? 0 : -1)...};
}
// One or the other, the other one in as many lanes as the distance.
template <int distance>
ADAGEN_INLINE Lanes beyond(const Lanes& x, const Lanes& y) {
  return chosen(far_lanes<distance>(kEachLane), x, y);
}
template <int distance>
ADAGEN_INLINE Vector<Lanes> beyond(const Vector<Lanes>& x, const Vector<Lanes>& y) {
  return {beyond<distance>(x.x, y.x), beyond<distance>(x.y, y.y), beyond<distance>(x.z, y.z)};
}
template <int distance>
ADAGEN_INLINE Matrix<Lanes> beyond(const Matrix<Lanes>& x, const Matrix<Lanes>& y) {
  return {beyond<distance>(x.x, y.x), beyond<distance>(x.y, y.y), beyond<distance>(x.z, y.z)};
}

// The lanes up to each put together: of one, two, four ... at a time.
template <int distance = 1, class T, class Join>
ADAGEN_INLINE T joined_up(const T& x, const Join& join) {
  if constexpr (distance < kPerBlock)
    return joined_up<2 * distance>(beyond<distance>(join(before<distance>(x), x), x), join);
  else
    return x;
}

ADAGEN_INLINE Vector<Lanes> in_all_lanes(const Vector<Value>& a) {
  return {Lanes{} + a.x, Lanes{} + a.y, Lanes{} + a.z};
}
ADAGEN_INLINE Vector<Value> last_of(const Vector<Lanes>& x) {
  return {x.x[kPerBlock - 1], x.y[kPerBlock - 1], x.z[kPerBlock - 1]};
}

// Sums of the lanes before each lane and start; start becomes the sum of all.
ADAGEN_INLINE Vector<Lanes> sums_before(const Vector<Lanes>& x, Vector<Value>& start) {
  const auto join = [](const Vector<Lanes>& a, const Vector<Lanes>& b)
                        ADAGEN_ALWAYS { return a + b; };
  const Vector<Lanes> first = in_all_lanes(start), sums = joined_up(x, join) + first;
  start = last_of(sums);
  return beyond<1>(before<1>(sums), first);
}

// The product of start and the rotations of the lanes before each; start becomes that of all.
ADAGEN_INLINE Matrix<Lanes> products_before(const Matrix<Lanes>& x, Matrix<Value>& start) {
  const auto join = [](const Matrix<Lanes>& a, const Matrix<Lanes>& b)
                        ADAGEN_ALWAYS { return a * b; };
  const Matrix<Lanes> first{in_all_lanes(start.x), in_all_lanes(start.y), in_all_lanes(start.z)};
  const Matrix<Lanes> products = first * joined_up(x, join);
  start = {last_of(products.x), last_of(products.y), last_of(products.z)};
  return beyond<1>(before<1>(products), first);
}

}  // namespace
