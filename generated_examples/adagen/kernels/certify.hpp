// adagen's runtime, the same for all robots.
#pragma once

#include <array>
#include <cstddef>
#include <cstring>
#include <limits>

#include "../common.hpp"
#include "../constants.hpp"
#include "../sample/robot.hpp"
#include "../sizes.hpp"
#include "../value.hpp"
#include "algebra.hpp"
#include "arms.hpp"
#include "blocks.hpp"
#include "factors.hpp"
#include "inward.hpp"
#include "kinds.hpp"
#include "lanes.hpp"
#include "links.hpp"
#include "loop_settings.hpp"
#include "memory.hpp"
#include "spherical.hpp"
#include "turned.hpp"
#include "weights.hpp"

namespace {

// A bound of the answer's error: what the links' equations of motion leave over is swept inwards by
// the factors at hand, u at each joint, and sum u D^-1 u is the square of the error in the energy
// norm. Of rounding, which that does not see, the squares of what is added up are swept beside it.
// Joints may be reversed, as they are in inward.hpp.

template <class T>
ADAGEN_INLINE void operator+=(Left<T>& a, const Left<T>& b) {
  a.n += b.n, a.f += b.f;
  a.moments += b.moments, a.forces += b.forces;
}

// Whether a slot is filled by a process: it starts with the inertia of the link.
template <int p>
[[maybe_unused]] constexpr std::array<PerJoint, kBlockCount> kFilled = [] {
  std::array<PerJoint, kBlockCount> result{};
  for (int j = 0; j < kJointCount; ++j)
    result[static_cast<std::size_t>(slot_of(j) / kPerBlock)]
          [static_cast<std::size_t>(slot_of(j) % kPerBlock)] = kStarts[p][j];
  return result;
}();

// The sum of the numbers of a block's links.
ADAGEN_INLINE Value over_links(const Lanes& x) {
  Value found{};
  for (int k = 0; k < kPerBlock; ++k) {
    Value own;
    std::memcpy(&own, reinterpret_cast<const char*>(&x) + std::size_t(k) * sizeof own, sizeof own);
    found += own;
  }
  return found;
}

// What links of blocks first .. last - 1 take with all that they gain; what of it may be rounding,
// as their inertia is expressed in axes of the base; the energy of the answer, and of what is
// uncertain of it.
template <int p, int first, int last>
void weigh_links(Workspace& w) {
  Lanes energy{}, rounded{};
  const Vector<Lanes> fall{Lanes{} + w.fall.x, Lanes{} + w.fall.y, Lanes{} + w.fall.z};
  for (int b = first; b < last; ++b) {
    Block& block = w.blocks[static_cast<std::size_t>(b)];
    const auto& entries = block.entries;
    const auto at = [&](int entry) { return wide_vector(entries + entry); };
    const Vector<Lanes> Ax = at(kRotational), Ay = at(kRotational + 3), c = at(kMoments);
    const Symmetric<Lanes> A{Ax.x, Ax.y, Ax.z, Ay.x, Ay.y, Ay.z};
    const Lanes mass = wide(w.constants_of(b).mass), filled = wide(kFilled<p>[std::size_t(b)]);
    const Vector<Lanes> alpha = at(kGained), gained = at(kGainedAlong), a = gained - fall;
    Vector<Lanes> n = A * alpha + cross(c, a), f = a * mass + cross(alpha, c);
    energy += filled * (dot(alpha, n) + dot(a, f));
    if constexpr (kFloats) n += cross(c, fall), f += fall * mass;
    n += at(kTorque), f += at(kForce);
    narrow(n, block.entries + kTakenTorque), narrow(f, block.entries + kTakenForce);
    const Lanes trace = A.xx + A.yy + A.zz;
    rounded += filled * (trace * wide(entries[kReached]) + mass * wide(entries[kReachedAlong]));
    const Vector<Lanes> omega = at(kOmega), ahead = at(kAlpha), above = at(kAcceleration);
    const Lanes spin = dot(omega, omega);
    const Lanes turning = dot(alpha, alpha) + dot(ahead, ahead) + spin * spin;
    narrow(trace * trace * turning + dot(c, c) * (dot(gained, gained) + dot(above, above)),
           block.entries[kTakenUnits]);
  }
  w.energy += over_links(energy), w.rounded += over_links(rounded);
}

template <class T>
ADAGEN_INLINE void add_weighed_link(Workspace& w, const Joints<T>& joints, Left<T>& X) {
  X.n += vector_at<T>(w.at(joints.slot, kTakenTorque));
  X.f += vector_at<T>(w.at(joints.slot, kTakenForce));
  X.moments += number_at<T>(w.at(joints.slot, kTakenUnits));
}

// The trace of the inverse of a matrix, by its factors.
template <class T>
ADAGEN_INLINE T trace_of_inverse(const T* factors) {
  const T *d = factors, *l = factors + 3;
  const T corner = l[0] * l[2] - l[1];
  return d[0] + d[1] * (1 + l[0] * l[0]) + d[2] * (1 + l[2] * l[2] + corner * corner);
}

// The trace of a matrix, by its factors.
template <class T>
ADAGEN_INLINE T trace_of(const T* factors) {
  const T *d = factors, *l = factors + 3;
  return (1 + l[0] * l[0] + l[1] * l[1]) / d[0] + (1 + l[2] * l[2]) / d[1] + 1 / d[2];
}

// A part of the error that is seen by factors of a matrix in axes of the base, of which trace was
// left. The least of their pivots is uncertain by a part d = unit trace tr(A^-1) of it: the part
// is larger by 1 / (1 - d), infinite beyond.
template <class T>
ADAGEN_INLINE T seen_by(const T* factors, const T& trace, const T& part) {
  const T known = 1 - Real(kUnit) * trace * trace_of_inverse(factors);
  const T unknown = part + std::numeric_limits<Real>::infinity();
  return chosen(known > T{}, T(part / known), unknown);
}

// What was seen of the error at some joints, and what rounding may be.
template <class T>
struct Found {
  T seen, rounded;
};

// What drives the far side of a joint of one freedom, less what its rotor needs.
template <bool reversed, class T>
ADAGEN_INLINE T driving(Workspace& w, const Joints<T>& joints) {
  T tau = each(joints, [&w](const JointConstants& own) { return torque(w, own); });
  if constexpr (kAnyRotor)
    tau -= each(joints, [&w](const JointConstants& own) {
      return Value{} + w.answer[static_cast<std::size_t>(own.v)] * Real(own.passive.rotor);
    });
  return reversed ? -tau : tau;
}

// The square of what passive forces take of a joint's torque, which is rounded, too.
template <class T>
ADAGEN_INLINE T spent_square(Workspace& w, const Joints<T>& joints, int freedom = 0) {
  return each(joints, [&w, freedom](const JointConstants& own) {
    return w.spent_squares[static_cast<std::size_t>(own.v + freedom)];
  });
}

// A joint of one freedom that is left u, and has units of rounding; see eliminate in inward.hpp.
template <bool reversed, class T>
ADAGEN_INLINE void weigh_freedom(Workspace& w, const Joints<T>& joints, const T& u, const T& units,
                                 Left<T>& X, Found<T>& found) {
  T* const e = w.memory(joints).e;
  found.seen += u * (u * e[7]);  // u * u may be below the least number
  found.rounded += units * e[7];
  if constexpr (kRefine > 0) e[6] = u * e[7];
  if constexpr (!reversed) X.n += cross(w.memory(joints).r, X.f);
  X.n += Vector<T>{e[0], e[1], e[2]} * u;
  X.f += Vector<T>{e[3], e[4], e[5]} * u;
}

// The force a bare link needs along its joint, expressed in its own axes; adds the squares of what
// that is added up from. See add_own_link in turned.hpp.
template <bool along, class T>
ADAGEN_INLINE T own_share(Workspace& w, const Joints<T>& joints, T& units) {
  const Matrix<T> back = transposed(matrix_at<T>(w.at(joints.slot, kAxes)));
  const auto in_own_axes = [&](Entry entry) {
    return back * vector_at<T>(w.at(joints.slot, entry));
  };
  T mass;
  Vector<T> c, n, f;
  Symmetric<T> J;
  own_inertia(w, joints, mass, c, J);
  bias_force(J, c, mass, in_own_axes(kOmega), in_own_axes(kAlpha), in_own_axes(kAcceleration), n,
             f);
  const Vector<T> alpha = in_own_axes(kGained), a = in_own_axes(kGainedAlong);
  const T before = along ? f.z : n.z;
  const T gained =
      along ? a.z * mass + (alpha.x * c.y - alpha.y * c.x)
            : alpha.z * (J.xx + J.yy) - (alpha.x * J.xz + alpha.y * J.yz) + (c.x * a.y - c.y * a.x);
  units += before * before + gained * gained;
  return before + gained;
}

// A joint that is swept in its own axes: the force that its bare link needs is exact there.
template <bool along, class T>
ADAGEN_INLINE void weigh_turned(Workspace& w, const Joints<T>& joints, Left<T>& X,
                                Found<T>& found) {
  const Vector<T> s = axis_at<T>(w.at(joints.slot, kAxes));
  T units = along ? X.forces + dot(X.f, X.f) : X.moments + dot(X.n, X.n);
  const T brought = dot(s, along ? X.f : X.n);
  const T u = driving<false>(w, joints) - own_share<along>(w, joints, units) - brought;
  add_weighed_link(w, joints, X);
  X.moments += dot(X.n, X.n), X.forces += dot(X.f, X.f);
  if constexpr (kAnySpent) {
    const T spent = spent_square(w, joints);
    units += spent, (along ? X.forces : X.moments) += spent;
  }
  weigh_freedom<false>(w, joints, u, units, X, found);
}
template <bool along, bool reversed, class T>
ADAGEN_INLINE void weigh_in_base(Workspace& w, const Joints<T>& joints, Left<T>& X,
                                 Found<T>& found) {
  X.moments += dot(X.n, X.n), X.forces += dot(X.f, X.f);
  if constexpr (kAnySpent) (along ? X.forces : X.moments) += spent_square(w, joints);
  const T brought = dot(axis_at<T>(w.at(joints.slot, kAxes)), along ? X.f : X.n);
  const T u = driving<reversed>(w, joints) - brought;
  weigh_freedom<reversed>(w, joints, u, along ? X.forces : X.moments, X, found);
}

// A ball joint; see take_out_rotations in spherical.hpp. Of moments no more than its torque passes.
template <bool reversed, class T>
ADAGEN_INLINE void weigh_rotations(Workspace& w, const Joints<T>& joints, Left<T>& X,
                                   Found<T>& found) {
  T* const e = w.memory(joints).e;
  Vector<T> torque = matrix_at<T>(w.at(joints.slot, kAxes)) * spherical_torque(w, joints);
  if constexpr (reversed) torque = -torque;
  const Vector<T> u = torque - X.n;
  T spent{};
  if constexpr (kAnySpent)
    ADAGEN_FOR (k, 0, 3) spent += spent_square(w, joints, k);
  X.moments += dot(X.n, X.n) + spent, X.forces += dot(X.f, X.f);
  const Vector<T> y = solved(e + 12, u);
  found.seen += seen_by(e + 12, trace_of(e + 12), dot(u, y));
  if constexpr (kRefine > 0) e[9] = y.x, e[10] = y.y, e[11] = y.z;
  found.rounded += X.moments * trace_of_inverse(e + 12);
  X.f += transposed_times(Matrix<T>{{e[0], e[1], e[2]}, {e[3], e[4], e[5]}, {e[6], e[7], e[8]}}, u);
  X.n = torque;
  X.moments = dot(torque, torque) + spent;
  if constexpr (!reversed) X.n += cross(w.memory(joints).r, X.f);
}

// A planar joint, freedom by freedom; see eliminate_planar in inward.hpp.
template <bool along>
ADAGEN_INLINE void weigh_part(const Vector<Value>& s, const Value& tau, Value* e, Left<Value>& X,
                              Found<Value>& found) {
  X.moments += dot(X.n, X.n), X.forces += dot(X.f, X.f);
  const Value u = tau - dot(s, along ? X.f : X.n);
  found.seen += u * (u * e[7]);
  found.rounded += (along ? X.forces : X.moments) * e[7];
  if constexpr (kRefine > 0) e[6] = u * e[7];
  X.n += Vector<Value>{e[0], e[1], e[2]} * u;
  X.f += Vector<Value>{e[3], e[4], e[5]} * u;
}
template <bool reversed>
ADAGEN_INLINE void weigh_planar(Workspace& w, const Joints<Value>& joints, Left<Value>& X,
                                Found<Value>& found) {
  Memory& memory = w.memory(joints);
  const Value* const tau = w.tau + joints.any().v;
  const Matrix<Value> R = matrix_at(w.at(joints.slot, kAxes));
  const Vector<Value> x{R.x.x, R.y.x, R.z.x}, y{R.x.y, R.y.y, R.z.y}, z{R.x.z, R.y.z, R.z.z};
  const Real sign = reversed ? -1 : 1;
  weigh_part<true>(x, sign * tau[0], memory.e, X, found);
  weigh_part<true>(y, sign * tau[1], memory.e + 8, X, found);
  weigh_part<false>(z, sign * tau[2], memory.e + 16, X, found);
  if constexpr (!reversed) X.n += cross(memory.r, X.f);
}

// What is left over at a body that nothing holds; returns what it accelerates by for it.
ADAGEN_INLINE Motion<Value> weigh_unheld(const Body<Value>& body, const Left<Value>& X,
                                         Found<Value>& found) {
  Value turning[6], sliding[6], checks[4];
  factorize(body.A, turning, checks);
  Symmetric<Value> C = body.C;
  const Matrix<Value> K = complement(C, body.B, turning);
  factorize(C, sliding, checks);
  const Vector<Value> rest = X.f - transposed_times(K, X.n);
  const Vector<Value> turn = solved(turning, X.n), slide = solved(sliding, rest);
  const Symmetric<Value>&A = body.A, &D = body.C;
  found.seen += seen_by(turning, A.xx + A.yy + A.zz, dot(X.n, turn));
  found.seen += seen_by(sliding, D.xx + D.yy + D.zz, dot(rest, slide));
  const Vector<Value>&x = K.x, &y = K.y, &z = K.z;
  const Value passed =
      dot(x, solved(sliding, x)) + dot(y, solved(sliding, y)) + dot(z, solved(sliding, z));
  found.rounded += X.moments * (trace_of_inverse(turning) + passed);
  found.rounded += X.forces * trace_of_inverse(sliding);
  return {K * slide - turn, -slide};
}

// A joint with all freedoms hands on its force alone; see set_free in inward.hpp.
template <bool reversed>
ADAGEN_INLINE void weigh_free(Workspace& w, const Joints<Value>& joints, Left<Value>& X,
                              Found<Value>& found) {
  Memory& memory = w.memory(joints);
  const Value* const tau = w.tau + joints.any().v;
  const Matrix<Value> R = matrix_at(w.at(joints.slot, kAxes));
  Vector<Value> n = R * Vector<Value>{tau[3], tau[4], tau[5]};
  Vector<Value> f = R * Vector<Value>{tau[0], tau[1], tau[2]};
  if constexpr (reversed) n = -n, f = -f;
  X.moments += dot(X.n, X.n), X.forces += dot(X.f, X.f);
  X.n += -n, X.f += -f;
  const Body<Value>& body = w.free[static_cast<std::size_t>(joints.joint[0])];
  const Motion<Value> far = weigh_unheld(body, X, found);
  const Vector<Value>&turn = far.angular, &slide = far.linear;
  if constexpr (kRefine > 0) {
    Value* const e = memory.e;
    e[0] = turn.x, e[1] = turn.y, e[2] = turn.z, e[3] = slide.x, e[4] = slide.y, e[5] = slide.z;
  }
  X = {n, f, dot(n, n), dot(f, f)};
  if constexpr (!reversed) X.n += cross(memory.r, f);
}

// Whether the force that the bare link beyond a joint needs is added with the joint.
ADAGEN_INLINE constexpr bool weighed_apart(int joint) { return turned<true>(joint); }

// A joint whose far link's share is X, but for the bare link where that is added here.
template <bool reversed, class T>
ADAGEN_INLINE void weigh_joint(Workspace& w, const Joints<T>& joints, JointKind kind, Left<T>& X,
                               Found<T>& found) {
  const bool along = kind == JointKind::kPrismatic;
  const Vector<T>& r = w.memory(joints).r;
  const T arm = arm_square(joints, kind, r);
  if constexpr (reversed) X.n += cross(X.f, r), X.moments += arm * X.forces;
  if constexpr (kAnySpherical) {
    if (kind == JointKind::kSpherical) weigh_rotations<reversed>(w, joints, X, found);
  }
  if constexpr (kAnyPlanar && kWidth<T> == 1) {
    if (kind == JointKind::kPlanar) weigh_planar<reversed>(w, joints, X, found);
  }
  if constexpr (kAnyFloating && kWidth<T> == 1) {
    if (kind == JointKind::kFloating) weigh_free<reversed>(w, joints, X, found);
  }
  if (kind == JointKind::kRevolute || along) {
    if (!reversed && weighed_apart(joints.joint[0]))
      along ? weigh_turned<true>(w, joints, X, found) : weigh_turned<false>(w, joints, X, found);
    else
      along ? weigh_in_base<true, reversed>(w, joints, X, found)
            : weigh_in_base<false, reversed>(w, joints, X, found);
  }
  if constexpr (!reversed) X.moments += arm * X.forces;
}

// Adds what is found at a link; see meet. The link itself is added with the joint before it where
// that is swept next in its own axes; whole: it is not.
template <int p, bool whole = false>
ADAGEN_INLINE void meet_left(Workspace& w, int link, Left<Value>& X) {
  const LinkRole role = kRoles[p][static_cast<std::size_t>(link)];
  if (role.gathers) X += w.lefts[static_cast<std::size_t>(link)];
  if (role.adds_own && (whole || !weighed_apart(link - 1)))
    add_weighed_link(w, single(link - 1), X);
}
template <bool starts>
ADAGEN_INLINE void leave_left(Workspace& w, int link, const Left<Value>& X) {
  Left<Value>& left = w.lefts[static_cast<std::size_t>(link)];
  if constexpr (starts)
    left = X;
  else
    left += X;
}
template <int link, bool starts, bool whole>
void weigh_placed(Workspace& w) {
  Left<Value> X{};
  if constexpr (whole || !weighed_apart(link - 1)) add_weighed_link(w, single(link - 1), X);
  leave_left<starts>(w, link, X);
}
template <int j, bool starts>
void weigh_free_base(Workspace& w) {
  const Value* tau = w.tau + kJoints[j].v;
  Left<Value> X{};
  X.n = {-tau[3], -tau[4], -tau[5]}, X.f = {-tau[0], -tau[1], -tau[2]};
  leave_left<starts>(w, j + 1, X);
}

// Joints last .. first, each on the link of the one before; see inward.
template <int p, int first, int last, bool starts>
void weigh(Workspace& w) {
  Left<Value> X{};
  Found<Value> found{};
  each_row<RunRows<first, last>, true>([&](int k, auto kind) ADAGEN_ALWAYS {
    meet_left<p>(w, first + k + 1, X);
    weigh_joint<false>(w, single(first + k), kind, X, found);
  });
  w.seen += found.seen, w.rounded += found.rounded;
  constexpr int near = kJoints[first].parent;
  if constexpr (near > 0) leave_left<starts>(w, near, X);
}
// The same for a root beyond joint last.
template <int p, int first, int last, bool starts>
void weigh_reversed(Workspace& w) {
  Left<Value> X{};
  Found<Value> found{};
  each_row<RunRows<first, last>, false>([&](int k, auto kind) ADAGEN_ALWAYS {
    meet_left<p, true>(w, kJoints[static_cast<std::size_t>(first + k)].parent, X);
    weigh_joint<true>(w, single(first + k), kind, X, found);
  });
  w.seen += found.seen, w.rounded += found.rounded;
  leave_left<starts>(w, last + 1, X);
}

// A body that nothing holds: what is left over is its own to take.
template <int p, int link>
void weigh_root(Workspace& w) {
  Left<Value> X{};
  Found<Value> found{};
  meet_left<p, true>(w, link, X);
  X.moments += dot(X.n, X.n), X.forces += dot(X.f, X.f);
  const Motion<Value> gained = weigh_unheld(whole<p>(w, link), X, found);
  if constexpr (kRefine > 0) w.motions[link] = gained;
  w.seen += found.seen, w.rounded += found.rounded;
}

inline void begin_weighing(Workspace& w) { w.seen = w.rounded = w.energy = Value{}; }
[[maybe_unused]] inline void end_weighing(Workspace& w) {
  w.certificate = {w.seen + kUnit * kUnit * w.rounded, w.energy};
}

}  // namespace
