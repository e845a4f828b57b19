// adagen's runtime, the same for all robots.
#pragma once

#include <cstddef>

#include "../constants.hpp"
#include "../sample/outer_forces.hpp"
#include "../sizes.hpp"
#include "../value.hpp"
#include "algebra.hpp"
#include "blocks.hpp"
#include "guards.hpp"
#include "lanes.hpp"
#include "links.hpp"
#include "loop_settings.hpp"
#include "memory.hpp"
#include "tables.hpp"

namespace {

// Inwards in the links' own axes, where axes of the base would cost digits: S is a coordinate axis
// there, D an entry of the body, and what is left along S exactly zero. Links beyond joints of
// kTurned express their bodies so, each about its own origin like all bodies. Joints of
// kTurnedIfLost are so only where a sweep found too few digits left and is repeated: lost is true
// then.
template <bool lost = false>
ADAGEN_INLINE constexpr bool turned(int j) {
  return (kAnyTurned && kTurned[j]) || (lost && kTurnedIfLost[j]);
}
template <bool lost = false>
ADAGEN_INLINE constexpr bool turned_link(int link) {
  return link > 0 && turned<lost>(link - 1);
}

// R M R^T.
template <class T, class S>
ADAGEN_INLINE Symmetric<T> congruent(const Matrix<S>& R, const Symmetric<T>& M) {
  const Vector<T> x = M * R.x, y = M * R.y, z = M * R.z;
  return {dot(x, R.x), dot(x, R.y), dot(x, R.z), dot(y, R.y), dot(y, R.z), dot(z, R.z)};
}
template <class T>
ADAGEN_INLINE Matrix<T> transposed(const Matrix<T>& m) {
  return {{m.x.x, m.y.x, m.z.x}, {m.x.y, m.y.y, m.z.y}, {m.x.z, m.y.z, m.z.z}};
}
// A body in the axes that R takes it to.
template <class T>
ADAGEN_INLINE void turn_body(Body<T>& X, const Matrix<T>& R) {
  X.A = congruent(R, X.A), X.C = congruent(R, X.C);
  X.B = R * X.B * transposed(R);
  X.n = R * X.n, X.f = R * X.f;
}

// From the axes that a link's body is expressed in to those of the base, and back.
template <bool lost = false>
ADAGEN_INLINE void to_base(Workspace& w, int link, Body<Value>& X) {
  if (turned_link<lost>(link)) turn_body(X, matrix_at(w.of(link - 1, kAxes)));
}
template <bool lost = false>
ADAGEN_INLINE void from_base(Workspace& w, int link, Body<Value>& X) {
  if (turned_link<lost>(link)) turn_body(X, transposed(matrix_at(w.of(link - 1, kAxes))));
}

// Mass, its moments and the pseudo-inertia of the links beyond joints.
template <class T>
ADAGEN_INLINE void own_inertia(const Workspace& w, const Joints<T>& joints, T& mass, Vector<T>& c,
                               Symmetric<T>& J) {
  if constexpr (kWidth<T> == 1) {
    const LinkInertia& link = w.inertia_of(joints.joint[0]);
    const auto x = [](Real number) { return T{} + number; };
    mass = x(link.mass);
    c = {x(link.moments[0]), x(link.moments[1]), x(link.moments[2])};
    J = {x(link.tensor[0]), x(link.tensor[1]), x(link.tensor[2]),
         x(link.tensor[3]), x(link.tensor[4]), x(link.tensor[5])};
  } else {
    const auto& block = w.constants_of(joints.slot / kPerBlock);
    const auto x = [&](const PerJoint& numbers) {
      return number_at<T>(&numbers[static_cast<std::size_t>(joints.slot % kPerBlock)]);
    };
    mass = x(block.mass);
    c = {x(block.moments[0]), x(block.moments[1]), x(block.moments[2])};
    J = {x(block.tensor[0]), x(block.tensor[1]), x(block.tensor[2]),
         x(block.tensor[3]), x(block.tensor[4]), x(block.tensor[5])};
  }
}

// Adds a bare link in its own axes: its inertia is constant, and nothing of its bias force is lost.
template <class T>
ADAGEN_INLINE void add_own_link(Workspace& w, const Joints<T>& joints, Body<T>& X) {
  const Matrix<T> back = transposed(matrix_at<T>(w.at(joints.slot, kAxes)));
  const auto in_own_axes = [&](Entry entry) {
    return back * vector_at<T>(w.at(joints.slot, entry));
  };
  T mass;
  Vector<T> c;
  Symmetric<T> J;
  own_inertia(w, joints, mass, c, J);
  Vector<T> n, f;
  if (kAgain && w.again) {
    n = in_own_axes(kTorque), f = in_own_axes(kForce);
  } else {
    bias_force(J, c, mass, in_own_axes(kOmega), in_own_axes(kAlpha), in_own_axes(kAcceleration), n,
               f);
    if constexpr (kOuterCount > 0) push_own(w, joints, n, f);
  }
  X.A += Symmetric<T>{J.yy + J.zz, -J.xy, -J.xz, J.xx + J.zz, -J.yz, J.xx + J.yy};
  X.B.x.y -= c.z, X.B.x.z += c.y, X.B.y.x += c.z;
  X.B.y.z -= c.x, X.B.z.x -= c.y, X.B.z.y += c.x;
  X.C.xx += mass, X.C.yy += mass, X.C.zz += mass;
  X.n += n, X.f += f;
}

// What is known of D, less what may be lost of it. What the bare link and the rotor bring is exact;
// what joints beyond bring is known to a few units in the last place of its trace, and is nothing
// but noise where links without inertia come near gimbal lock. Of a reversed joint the whole body
// was turned and shifted.
template <bool along, bool reversed, class T>
ADAGEN_INLINE T left_of(const Workspace& w, const Joints<T>& joints, const Body<T>& X, const T& D) {
  const Symmetric<T>& whole = along ? X.C : X.A;
  T brought = whole.xx + whole.yy + whole.zz;
  if constexpr (!reversed) {
    T mass;
    Vector<T> c;
    Symmetric<T> J;
    own_inertia(w, joints, mass, c, J);
    brought -= along ? 3 * mass : 2 * (J.xx + J.yy + J.zz);
  }
  return D - kLeast * brought;
}

// Takes the freedom along z out of the body, at the joint's origin and in its axes. With a rotor J
// a part J / D of what is taken along z stays: there, too, nothing is subtracted.
template <bool along, bool reversed, class T>
ADAGEN_INLINE void eliminate_own(Workspace& w, const Joints<T>& joints, Body<T>& X) {
  const Symmetric<T>&A = X.A, &C = X.C;
  const Matrix<T>& B = X.B;
  const Vector<T> n = along ? Vector<T>{B.x.z, B.y.z, B.z.z} : Vector<T>{A.xz, A.yz, A.zz};
  const Vector<T> f = along ? Vector<T>{C.xz, C.yz, C.zz} : B.z;
  T tau = each(joints, [&w](const JointConstants& own) { return torque(w, own); });
  if constexpr (reversed) tau = -tau;
  T D = along ? C.zz : A.zz, rotor{};
  if constexpr (kAnyRotor) {
    rotor = each(joints, [](const JointConstants& joint) { return joint.passive.rotor; });
    D += rotor;
  }
  const T left = left_of<along, reversed>(w, joints, X, D);
  if (__builtin_expect(!all_positive(left), 0)) fail_one(w, joints, left);
  const T inverse = 1 / D, u = (tau - (along ? X.f.z : X.n.z)) * inverse, kept = rotor * inverse;
  const Vector<T> e_n = n * inverse, e_f = f * inverse;
  subtract(X, n, f, e_n, e_f);
  X.n += n * u;
  X.f += f * u;
  if constexpr (along) {
    X.B.x.z = n.x * kept, X.B.y.z = n.y * kept, X.B.z.z = n.z * kept;
    X.C.xz = f.x * kept, X.C.yz = f.y * kept, X.C.zz = f.z * kept;
    X.f.z = tau - u * rotor;
  } else {
    X.A.xz = n.x * kept, X.A.yz = n.y * kept, X.A.zz = n.z * kept;
    X.B.z = f * kept;
    X.n.z = tau - u * rotor;
  }
  auto& memory = w.memory(joints);
  const Matrix<T> R = matrix_at<T>(w.at(joints.slot, kAxes));
  Vector<T> k_n = R * e_n;
  const Vector<T> k_f = R * e_f;
  if constexpr (!reversed) k_n += cross(memory.r, k_f);
  T* const e = memory.e;
  e[0] = k_n.x, e[1] = k_n.y, e[2] = k_n.z, e[3] = k_f.x, e[4] = k_f.y, e[5] = k_f.z;
  e[6] = u, e[7] = inverse;
}

}  // namespace
