// adagen's runtime, the same for all robots.
#pragma once
#if !defined(ADAGEN_SOLVER)
#define ADAGEN_SAMPLE_CUTS  // read alone, it is of a solver whose processes meet
#endif

#include <initializer_list>

#include "../common.hpp"
#include "../constants.hpp"
#include "../sample/robot.hpp"
#include "../sizes.hpp"
#include "../value.hpp"
#include "algebra.hpp"
#include "blocks.hpp"
#include "kinds.hpp"
#include "loop_settings.hpp"
#include "memory.hpp"
#include "outward.hpp"
#include "passage.hpp"
#include "turned.hpp"

namespace {

// Processes send each other how their runs of joints move, so that none passes those of others.

// The passage of two runs, the second one on the last link of the first. Seen from a link that
// turns, what moves there has the acceleration of Coriolis besides, 2 omega x v, and its spin
// omega x its own.
[[maybe_unused]] inline Passage<Value> appended(const Passage<Value>& near,
                                                const Passage<Value>& far) {
  const Vector<Value> spin = near.R * far.omega, p = near.R * far.p, v = near.R * far.v;
  return {near.R * far.R,
          near.omega + spin,
          near.alpha + near.R * far.alpha + cross(near.omega, spin),
          near.p + p,
          near.v + v + cross(near.omega, p),
          near.a + near.R * far.a + cross(near.alpha, p) +
              cross(near.omega, cross(near.omega, p) + (v + v))};
}

// The frame of a run's last link from that of the link that the run hangs on, the ground if 0.
template <int near, int link>
void arrive(Workspace& w, const Passage<Value>& own) {
  const Frame<Value> at = near == 0 ? ground(w) : frame_of(w, near == 0 ? 0 : near - 1);
  const Vector<Value> spin = at.R * own.omega, p = at.R * own.p, v = at.R * own.v;
  keep(w, slot_of(link - 1),
       Frame<Value>{at.R * own.R, at.omega + spin,
                    at.alpha + at.R * own.alpha + cross(at.omega, spin),
                    at.a + at.R * own.a + cross(at.alpha, p) +
                        cross(at.omega, cross(at.omega, p) + (v + v))});
}

// A run of hinges and ball joints, joint by joint.
template <int first, int last>
void traverse(Workspace& w, Passage<Value>& own) {
  const Value one = Value{} + 1, none{};
  own = {{{one, none, none}, {none, one, none}, {none, none, one}}, {}, {}, {}, {}, {}};
  each_row<RunRows<first, last>, false>([&](int k, auto kind) ADAGEN_ALWAYS {
    const Joints<Value> at = single(first + k);
    const JointConstants& joint = at.any();
    const Vector<Value> p = own.R * origin_of(at), v = cross(own.omega, p);
    own.a += cross(own.omega, v) + cross(own.alpha, p);
    own.p += p;
    own.v += v;
    own.R = own.R * matrix_at<Value>(w.at(at.slot, kTurn));
    Vector<Value> spin{own.R.x.z, own.R.y.z, own.R.z.z};
    if (kind == JointKind::kSpherical)
      spin = own.R * Vector<Value>{w.v[joint.v], w.v[joint.v + 1], w.v[joint.v + 2]};
    else
      spin = spin * w.v[joint.v];
    own.alpha += cross(own.omega, spin);
    own.omega += spin;
  });
}

// How a joint lies, for those that join it but do not move it: its axes and its lever. Where what
// it hangs on is told in that link's own axes, how it is turned there, and its axes if they are
// asked for, too (set_transforms in mobility.hpp).
template <int j>
[[maybe_unused]] constexpr bool kInLinkAxes = turned_link(kJoints[j].parent);
template <class Put>
ADAGEN_INLINE Number* put_matrix(Number* to, const Matrix<Put>& m) {
  for (const Vector<Put>* u : {&m.x, &m.y, &m.z}) {
    to[0] = Number(u->x), to[1] = Number(u->y), to[2] = Number(u->z);
    to += 3;
  }
  return to;
}
inline Matrix<Value> get_matrix(const Number* from) {
  const auto row = [from](int k) {
    return Vector<Value>{Value(from[k]), Value(from[k + 1]), Value(from[k + 2])};
  };
  return {row(0), row(3), row(6)};
}
template <int j>
Number* put_placement(Number* to, Workspace& w) {
  if constexpr (kInLinkAxes<j>) {
    to = put_matrix(to, matrix_at(w.of(j, kTurn)));
    return turned(j) ? to : put_matrix(to, matrix_at(w.of(j, kAxes)));
  }
  const Vector<Value> r = w.joints[j].r;
  to = put_matrix(to, matrix_at(w.of(j, kAxes)));
  to[0] = Number(r.x), to[1] = Number(r.y), to[2] = Number(r.z);
  return to + 3;
}
template <int j>
const Number* get_placement(const Number* from, Workspace& w) {
  if constexpr (kInLinkAxes<j>) {
    put_at(w.of(j, kTurn), get_matrix(from));
    if (turned(j)) return from + 9;
    put_at(w.of(j, kAxes), get_matrix(from + 9));
    return from + 18;
  }
  put_at(w.of(j, kAxes), get_matrix(from));
  w.joints[j].r = {Value(from[9]), Value(from[10]), Value(from[11])};
  return from + 12;
}

// Into a message, and out of one.
inline Number* put(Number* to, const Passage<Value>& own) {
  for (const Vector<Value>* u :
       {&own.R.x, &own.R.y, &own.R.z, &own.omega, &own.alpha, &own.p, &own.v, &own.a}) {
    to[0] = Number(u->x), to[1] = Number(u->y), to[2] = Number(u->z);
    to += 3;
  }
  return to;
}
inline const Number* get(const Number* from, Passage<Value>& own) {
  for (Vector<Value>* u :
       {&own.R.x, &own.R.y, &own.R.z, &own.omega, &own.alpha, &own.p, &own.v, &own.a}) {
    *u = {Value(from[0]), Value(from[1]), Value(from[2])};
    from += 3;
  }
  return from;
}

}  // namespace
