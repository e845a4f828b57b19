// adagen's runtime, the same for all robots.
#pragma once

#include <cstddef>

#include "../constants.hpp"
#include "../sample/keep.hpp"
#include "../sample/robot.hpp"
#include "../sizes.hpp"
#include "../status.hpp"
#include "../value.hpp"
#include "algebra.hpp"
#include "blocks.hpp"
#include "factors.hpp"
#include "guards.hpp"
#include "kinds.hpp"
#include "lanes.hpp"
#include "links.hpp"
#include "loop_settings.hpp"
#include "memory.hpp"
#include "spherical.hpp"
#include "tables.hpp"
#include "turned.hpp"

namespace {

// Inwards: articulated bodies. A joint is treated at its own origin, the child link's, and the body
// is passed on about the near link's origin. Seen from the sweep's root, the child link may be the
// near one (the joint is reversed): then sigma = -1, and -qdd takes the place of qdd.

template <class T>
ADAGEN_INLINE void add_bare_link(Workspace& w, const Joints<T>& joints, Body<T>& X) {
  const Value* const A = w.at(joints.slot, kRotational);
  const auto mass = mass_of(w, joints);
  const Vector<T> c = vector_at<T>(w.at(joints.slot, kMoments));
  const Vector<T> Ax = vector_at<T>(A), Ay = vector_at<T>(A + 3 * kPerBlock);
  X.A += Symmetric<T>{Ax.x, Ax.y, Ax.z, Ay.x, Ay.y, Ay.z};  // xx xy xz yy yz zz
  X.B.x.y -= c.z, X.B.x.z += c.y, X.B.y.x += c.z;
  X.B.y.z -= c.x, X.B.z.x -= c.y, X.B.z.y += c.x;
  X.C.xx += mass, X.C.yy += mass, X.C.zz += mass;
  X.n += vector_at<T>(w.at(joints.slot, kTorque));
  X.f += vector_at<T>(w.at(joints.slot, kForce));
}

ADAGEN_INLINE void add_bare_link(Workspace& w, int link, Body<Value>& X) {
  add_bare_link(w, single(link - 1), X);
}

// A bare link expressed about the point at -r from its origin: A - (rx dx + dx rx), d = c + m r
// / 2.
template <class T>
ADAGEN_INLINE Body<T> bare_link_from(Workspace& w, const Joints<T>& joints, const Vector<T>& r) {
  Body<T> X{};
  add_bare_link(w, joints, X);
  const Vector<T> c{X.B.z.y, X.B.x.z, X.B.y.x};
  const T m = X.C.xx;
  const Vector<T> d = c + r * (m / 2), moved = c + r * m;
  const T xx = 2 * d.x * r.x, yy = 2 * d.y * r.y, zz = 2 * d.z * r.z;
  X.A += Symmetric<T>{yy + zz, -(d.x * r.y + d.y * r.x), -(d.x * r.z + d.z * r.x),
                      xx + zz, -(d.y * r.z + d.z * r.y), xx + yy};
  const T none{};
  X.B = {{none, -moved.z, moved.y}, {moved.z, none, -moved.x}, {-moved.y, moved.x, none}};
  X.n += cross(r, X.f);
  return X;
}

// Takes one freedom out of the body, which is shifted by r, and added to by arrive, before the
// subtraction, so that the division has time. e gets U / D, u / D and 1 / D, expressed at the near
// link's origin: outwards the joint has the acceleration u / D - (U / D) a, a being the near
// link's.
template <bool along, bool reversed, class T, class Arrive>
ADAGEN_INLINE void eliminate(Workspace& w, const Joints<T>& joints, Body<T>& X, const Vector<T>& s,
                             const Vector<T>& r, const T& tau, T* e, const Arrive& arrive) {
  if constexpr (reversed) shift(X, -r);
  Vector<T> n = along ? X.B * s : X.A * s;
  const Vector<T> f = along ? X.C * s : transposed_times(X.B, s);
  T D = dot(s, along ? f : n);
  if constexpr (kAnyRotor)
    D += each(joints, [](const JointConstants& joint) { return joint.passive.rotor; });
  if constexpr (kPrescribedInLanes && kWidth < T >> 1) D += each(joints, immovable);
  const T inverse = 1 / D;
  T u = ((reversed ? -tau : tau) - dot(s, along ? X.f : X.n)) * inverse;
  if constexpr (kPrescribedInLanes && kWidth < T >> 1)
    u += each(joints, [&w](const JointConstants& joint) { return prescribed(w, joint); });
  const Symmetric<T>& whole = along ? X.C : X.A;  // D beside it tells what digits are left
  const T trace = whole.xx + whole.yy + whole.zz;
  if (__builtin_expect(!all_positive(D - kEnough * trace), 0)) lose(w, joints, D, trace);
  if constexpr (!reversed) {
    shift(X, r);
    n += cross(r, f);
  }
  arrive(X);
  const Vector<T> e_n = n * inverse, e_f = f * inverse;
  e[0] = e_n.x, e[1] = e_n.y, e[2] = e_n.z, e[3] = e_f.x, e[4] = e_f.y, e[5] = e_f.z, e[6] = u;
  e[7] = inverse;
  subtract(X, n, f, e_n, e_f);
  X.n += n * u;
  X.f += f * u;
}

// Acceleration of a body that nothing holds: (A, B; B^T, C) a = -(n; f), A and what it leaves of C
// by their factors. Whether that could be done.
ADAGEN_INLINE bool solve_free(const Body<Value>& X, Motion<Value>& a) {
  Value turning[6], sliding[6], checks[2][4];
  factorize(X.A, turning, checks[0]);
  Symmetric<Value> C = X.C;
  const Matrix<Value> K = complement(C, X.B, turning);
  factorize(C, sliding, checks[1]);
  const Vector<Value> y = solved(turning, -X.n);
  a.linear = solved(sliding, -(X.f + transposed_times(X.B, y)));
  a.angular = y - K * a.linear;
  bool fine = true;
  for (const auto& of : checks)
    for (const Value& check : of) fine &= all_positive(check);
  return fine;
}

// A joint with all freedoms passes on its force alone; e gets the acceleration of the body beyond.
template <bool reversed>
ADAGEN_INLINE void set_free(Workspace& w, int j, Body<Value>& X, const Vector<Value>& r,
                            const Value* tau, Value* e) {
  if constexpr (reversed) shift(X, -r);
  const Matrix<Value> R = matrix_at(w.of(j, kAxes));
  Vector<Value> n = R * Vector<Value>{tau[3], tau[4], tau[5]};
  Vector<Value> f = R * Vector<Value>{tau[0], tau[1], tau[2]};
  if constexpr (reversed) n = -n, f = -f;
  X.n += -n, X.f += -f;
  Motion<Value> a;
  if (!solve_free(X, a)) fail(w, kFactorization, j);
  if constexpr (kKeepsFree) w.free[static_cast<std::size_t>(j)] = X;
  e[0] = a.angular.x, e[1] = a.angular.y, e[2] = a.angular.z;
  e[3] = a.linear.x, e[4] = a.linear.y, e[5] = a.linear.z;
  X = Body<Value>{};
  X.n = n, X.f = f;
  if constexpr (!reversed) shift(X, r);
}

// A planar joint: along x and y, then about z.
template <bool reversed>
ADAGEN_INLINE void eliminate_planar(Workspace& w, const Joints<Value>& joints, Body<Value>& X) {
  Memory& memory = w.memory(joints);
  const Value* tau = w.tau + joints.any().v;
  const Matrix<Value> R = matrix_at(w.at(joints.slot, kAxes));
  const Vector<Value> x{R.x.x, R.y.x, R.z.x}, y{R.x.y, R.y.y, R.z.y}, z{R.x.z, R.y.z, R.z.z};
  const Vector<Value> none{};
  const auto signed_torque = [](const Value& torque) { return reversed ? -torque : torque; };
  if constexpr (reversed) shift(X, -memory.r);
  const auto nothing = [](const Body<Value>&) {};
  eliminate<true, false>(w, joints, X, x, none, signed_torque(tau[0]), memory.e, nothing);
  eliminate<true, false>(w, joints, X, y, none, signed_torque(tau[1]), memory.e + 8, nothing);
  eliminate<false, false>(w, joints, X, z, none, signed_torque(tau[2]), memory.e + 16, nothing);
  if constexpr (!reversed) shift(X, memory.r);
}

// One joint, or one in each lane, all of one kind; arrive adds the bodies at the near link.
template <bool reversed, class T, class Arrive>
ADAGEN_INLINE void step_inward(Workspace& w, const Joints<T>& joints, JointKind kind, Body<T>& X,
                               const Arrive& arrive) {
  const JointConstants& joint = joints.any();
  Eliminated<T>& memory = w.memory(joints);
  const Value* R = w.at(joints.slot, kAxes);
  const auto freedom = [&] {
    return each(joints, [&w](const JointConstants& own) { return torque(w, own); });
  };
  switch (kind) {
    case JointKind::kRevolute:
      eliminate<false, reversed>(w, joints, X, axis_at<T>(R), memory.r, freedom(), memory.e,
                                 arrive);
      return;
    case JointKind::kPrismatic:
      eliminate<true, reversed>(w, joints, X, axis_at<T>(R), memory.r, freedom(), memory.e, arrive);
      return;
    case JointKind::kSpherical:
      if constexpr (kAnySpherical) eliminate_rotations<reversed>(w, joints, X);
      break;
    case JointKind::kPlanar:
      if constexpr (kAnyPlanar && kWidth<T> == 1) eliminate_planar<reversed>(w, joints, X);
      break;
    case JointKind::kFloating:
      if constexpr (kAnyFloating && kWidth<T> == 1)
        set_free<reversed>(w, joints.joint[0], X, memory.r, w.tau + joint.v, memory.e);
      break;
  }
  arrive(X);
}

// Adds a bare link in the axes of its body.
template <bool lost = false>
ADAGEN_INLINE void add_link(Workspace& w, int link, Body<Value>& X) {
  if (turned_link<lost>(link))
    add_own_link(w, single(link - 1), X);
  else
    add_bare_link(w, link, X);
}

// Adds to a body those at a link.
template <int p, bool lost = false>
ADAGEN_INLINE void meet(Workspace& w, int link, Body<Value>& X) {
  const LinkRole role = kRoles[p][static_cast<std::size_t>(link)];
  if (role.gathers) {
    Body<Value> gathered = w.bodies[static_cast<std::size_t>(link)];
    if (lost && !turned_link(link)) from_base<true>(w, link, gathered);
    X += gathered;
  }
  if (role.adds_own) add_link<lost>(w, link, X);
}

// The bodies at a link, in base axes.
template <int p>
ADAGEN_INLINE Body<Value> whole(Workspace& w, int link) {
  Body<Value> X{};
  meet<p>(w, link, X);
  to_base(w, link, X);
  return X;
}

// Adds a body to a link, in the axes in which the link's body is expressed.
template <bool starts>
ADAGEN_INLINE void add_to(Workspace& w, int link, const Body<Value>& X) {
  Body<Value>& body = w.bodies[static_cast<std::size_t>(link)];
  if constexpr (starts)
    body = X;
  else
    body += X;
}
// The same of one in axes of the base.
template <bool starts>
ADAGEN_INLINE void leave(Workspace& w, int link, Body<Value> X) {
  from_base(w, link, X);
  add_to<starts>(w, link, X);
}

// Whether nothing but the links themselves is found at links first .. last.
template <int p>
constexpr bool bare(int first, int last) {
  for (int link = first; link <= last; ++link) {
    const LinkRole role = kRoles[p][static_cast<std::size_t>(link)];
    if (role.gathers || !role.adds_own) return false;
  }
  return true;
}

// Whether a sweep of joints first .. last may lose digits and be repeated in their own axes.
[[maybe_unused]] constexpr bool may_lose(int first, int last) {
  for (int j = first; j <= last; ++j)
    if (kAnyTurnedIfLost && kTurnedIfLost[j]) return true;
  return false;
}
template <int p, int first, int last, bool starts, bool reversed>
void inward_again(Workspace& w);

// The joint up to which a run is swept inwards before the next link where more is found than
// itself; its end where there are many such links.
template <int p, bool reversed>
constexpr int end_of_piece(int first, int last) {
  int more = 0;
  for (int link = first + 1; link <= last; ++link) more += !bare<p>(link, link);
  if (more >= kMostStretches) return reversed ? last : first;
  int first_of_piece = last, last_of_piece = first;
  while (first_of_piece > first && bare<p>(first_of_piece, first_of_piece)) --first_of_piece;
  while (last_of_piece < last && bare<p>(last_of_piece + 1, last_of_piece + 1)) ++last_of_piece;
  return reversed ? last_of_piece : first_of_piece;
}

// Calls step for joints last .. first, if reversed first .. last, with the body before each: what
// is found at links is added. Bare links are added by arrive, the third argument of step.
template <int p, int first, int last, bool reversed, class X, class Step>
ADAGEN_INLINE void each_inward(Workspace& w, X& body, const Step& step) {
  constexpr int end = end_of_piece<p, reversed>(first, last);
  constexpr int low = reversed ? first : end, high = reversed ? end : last;
  constexpr bool quick = bare<p>(low + 1, high);
  const auto meet_before = [&](int j) ADAGEN_ALWAYS {
    meet<p>(w, reversed ? kJoints[static_cast<std::size_t>(j)].parent : j + 1, body);
  };
  if constexpr (quick) meet_before(reversed ? low : high);
  each_row<RunRows<low, high>, !reversed>([&](int k, auto kind) ADAGEN_ALWAYS {
    const int j = low + k;
    if constexpr (!quick) meet_before(j);
    step(j, kind, [&](X& near) ADAGEN_ALWAYS {
      if (quick && j != end) add_bare_link(w, reversed ? j + 1 : j, near);
    });
  });
  if constexpr (reversed && high < last) each_inward<p, high + 1, last, true>(w, body, step);
  if constexpr (!reversed && low > first) each_inward<p, first, low - 1, false>(w, body, step);
}

// Process p sweeps joints last .. first inwards, each on the link of the one before.
template <int p, int first, int last, bool starts>
void inward(Workspace& w) {
  Body<Value> X{};
  each_inward<p, first, last, false>(w, X, [&](int j, auto kind, auto arrive) ADAGEN_ALWAYS {
    if constexpr (kWide) keep_body(w, single(j), X);
    step_inward<false>(w, single(j), kind, X, arrive);
  });
  if constexpr (may_lose(first, last))
    if (__builtin_expect(w.lost, 0)) return inward_again<p, first, last, starts, false>(w);
  constexpr int near = kJoints[first].parent;
  if constexpr (near > 0) leave<starts>(w, near, X);
}

// The next for spherical joints with bare links between them: a link is expressed at the next
// joint's origin before what is left of the body gets there.
template <int p, int first, int last>
ADAGEN_INLINE Body<Value> turn_inward_reversed(Workspace& w) {
  Body<Value> X{};
  meet<p>(w, kJoints[first].parent, X);
  shift(X, -w.joints[first].r);
  take_out_rotations<true>(w, single(first), X);
  for (int j = first + 1; j <= last; ++j) {
    const Vector<Value> r = -w.joints[static_cast<std::size_t>(j)].r;
    shift_mass(X, r);
    X += bare_link_from(w, single(j - 1), r);
    take_out_rotations<true>(w, single(j), X);
  }
  return X;
}

// The same for a root beyond joint last: from the parent link of joint first to the child of last.
template <int p, int first, int last, bool starts>
void inward_reversed(Workspace& w) {
  if constexpr (bare<p>(first + 1, last) && leave_mass_alone(first, last) && !kWide)
    return leave<starts>(w, last + 1, turn_inward_reversed<p, first, last>(w));
  Body<Value> X{};
  each_inward<p, first, last, true>(w, X, [&](int j, auto kind, auto arrive) ADAGEN_ALWAYS {
    if constexpr (kWide) keep_body(w, single(j), X);
    step_inward<true>(w, single(j), kind, X, arrive);
  });
  if constexpr (may_lose(first, last))
    if (__builtin_expect(w.lost, 0)) return inward_again<p, first, last, starts, true>(w);
  leave<starts>(w, last + 1, X);
}

// Adds a link itself to what was found at it.
template <int link, bool starts>
void place(Workspace& w) {
  Body<Value> X{};
  add_link(w, link, X);
  add_to<starts>(w, link, X);
}

// A floating joint on the ground only adds its torque to the link.
template <int j, bool starts>
void free_base(Workspace& w) {
  const Value* tau = w.tau + kJoints[j].v;
  Body<Value> X{};
  X.n = {-tau[3], -tau[4], -tau[5]};
  X.f = {-tau[0], -tau[1], -tau[2]};
  leave<starts>(w, j + 1, X);
}

// Acceleration of a root that nothing holds.
template <int p, int link>
void solve_root(Workspace& w) {
  if (!solve_free(whole<p>(w, link), w.motions[link])) fail(w, kFactorization, link - 1);
}

}  // namespace
