// adagen's runtime, the same for all robots.
#pragma once

#include <cmath>
#include <cstddef>

#include "../sizes.hpp"
#include "../value.hpp"
#include "algebra.hpp"
#include "certify.hpp"
#include "links.hpp"
#include "memory.hpp"
#include "weights.hpp"

namespace {

// A bound to which several processes add. Each sweeps what its own limbs leave over to the links
// that they hang on, and tells that process 0, with the accelerations that it has found for these
// links, and what its limbs would take for moving with others: at most turning |x|^2 +
// sliding |y|^2 of angular and linear ones.

[[maybe_unused]] constexpr int kSums = 3, kAtLink = 16;

ADAGEN_INLINE Number* put_vector(Number* to, const Vector<Value>& x) {
  to[0] = Number(x.x), to[1] = Number(x.y), to[2] = Number(x.z);
  return to + 3;
}
ADAGEN_INLINE Vector<Value> vector_in(const Number* from) { return {from[0], from[1], from[2]}; }

ADAGEN_INLINE Number* tell_sums(Number* to, const Workspace& w) {
  to[0] = Number(w.seen), to[1] = Number(w.rounded), to[2] = Number(w.energy);
  return to + kSums;
}
ADAGEN_INLINE Number* tell_link(Number* to, const Workspace& w, int link, Value turning,
                                Value sliding) {
  const Left<Value>& left = w.lefts[static_cast<std::size_t>(link)];
  const Motion<Value>& a = w.motions[static_cast<std::size_t>(link)];
  to = put_vector(put_vector(to, left.n), left.f);
  to = put_vector(put_vector(to, a.angular), a.linear);
  to[0] = Number(left.moments), to[1] = Number(left.forces);
  to[2] = Number(turning), to[3] = Number(sliding);
  return to + 4;
}

// Of long limbs, turning has the squares of the distances of links from the one that they hang on:
// what takes at most K |x|^2 + M |y|^2 of its own acceleration takes at most (K + 2 M d^2) |x|^2 +
// 2 M |y|^2 at a distance d. Adds the links beyond joints first .. last, the first of which is on a
// link at p from there; returns where the last one is.
template <int first, int last>
Vector<Value> spread_along(Workspace& w, Vector<Value> p, Value& turning) {
  Value sum{};
  for (int j = first; j <= last; ++j) {
    p += w.memory(single(j)).r;
    sum += mass_of(w, single(j)) * dot(p, p);
  }
  turning += 4 * sum;
  return p;
}
// What limbs of another process take that hang on the link itself, and on one at p from there.
ADAGEN_INLINE void spread_told(const Number* from, Value& turning, Value& sliding) {
  turning += from[14], sliding += from[15];
}
ADAGEN_INLINE void spread_told(const Number* from, const Vector<Value>& p, Value& turning,
                               Value& sliding) {
  turning += from[14] + 2 * from[15] * dot(p, p), sliding += 2 * from[15];
}

ADAGEN_INLINE void hear_sums(Workspace& w, const Number* from) {
  w.seen += from[0], w.rounded += from[1], w.energy += from[2];
}
template <bool starts>
ADAGEN_INLINE void hear_link(Workspace& w, int link, const Number* from) {
  leave_left<starts>(w, link, {vector_in(from), vector_in(from + 3), from[12], from[13]});
  const Motion<Value>& a = w.motions[static_cast<std::size_t>(link)];
  const Vector<Value> turn = vector_in(from + 6) - a.angular,
                      slide = vector_in(from + 9) - a.linear;
  w.parted += from[14] * dot(turn, turn) + from[15] * dot(slide, slide);
}

inline void begin_shared_weighing(Workspace& w) { w.parted = w.held = Value{}; }

// Lengths add up, those of what is weighed up to a held link and beyond it: |a + b|^2 <=
// 9/8 |a|^2 + 9 |b|^2 where b is what limbs take.
inline void end_shared_weighing(Workspace& w) {
  const Value seen = w.seen + w.held + 2 * std::sqrt(w.seen * w.held);
  w.certificate = {Real(1.125) * seen + 9 * w.parted + kUnit * kUnit * w.rounded, w.energy};
}

}  // namespace
