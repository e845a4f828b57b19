// adagen's runtime, the same for all robots.
#pragma once

#include "../constants.hpp"
#include "../sample/robot.hpp"
#include "algebra.hpp"
#include "factors.hpp"
#include "guards.hpp"
#include "lanes.hpp"
#include "memory.hpp"

namespace {

// Spherical joints: three rotations at once. Damping and a rotor are the same about all axes.
[[maybe_unused]] constexpr bool any_spherical_rotor() {
  for (const JointConstants& joint : kJoints)
    if (joint.kind == JointKind::kSpherical && joint.passive.rotor != 0) return true;
  return false;
}
[[maybe_unused]] constexpr bool kSphericalRotors = any_spherical_rotor();

// The torque that reaches the links, in the child link's axes.
template <class T>
ADAGEN_INLINE Vector<T> spherical_torque(const Workspace& w, const Joints<T>& joints) {
  const auto number = [&](int freedom) {
    return each(joints, [&](const JointConstants& own) { return torque(w, own, freedom); });
  };
  return {number(0), number(1), number(2)};
}

template <class T>
ADAGEN_INLINE T rotor_of(const Joints<T>& joints) {
  return each(joints, [](const JointConstants& own) { return own.passive.rotor; });
}

template <class T>
ADAGEN_INLINE Symmetric<T> with_rotor(Symmetric<T> A, const T& rotor) {
  A.xx += rotor, A.yy += rotor, A.zz += rotor;
  return A;
}

// Takes the three rotations out of the body at the joint's origin: what is left of it is C and f,
// and the torque, so that no rounding stays behind. e gets K = A^-1 B, y = A^-1 (torque - n) and
// the factors of A. With a rotor J, which is the same about all axes, A + J is in the place of A
// there, and J K, J (A + J)^-1 A and torque - J y are left, too.
template <bool reversed, class T>
ADAGEN_INLINE void take_out_rotations(Workspace& w, const Joints<T>& joints, Body<T>& X) {
  T* const e = w.memory(joints).e;
  Vector<T> torque = matrix_at<T>(w.at(joints.slot, kAxes)) * spherical_torque(w, joints);
  if constexpr (reversed) torque = -torque;
  T* const factors = e + 12;
  T checks[4];
  const T rotor = rotor_of(joints);
  factorize(kSphericalRotors ? with_rotor(X.A, rotor) : X.A, factors, checks);
  for (const T& check : checks)
    if (__builtin_expect(!all_positive(check), 0)) fail_one(w, joints, check);
  const Matrix<T>& B = X.B;
  const Matrix<T> K = complement(X.C, B, factors);
  const Vector<T> y = solved(factors, torque - X.n);
  e[0] = K.x.x, e[1] = K.x.y, e[2] = K.x.z, e[3] = K.y.x, e[4] = K.y.y, e[5] = K.y.z;
  e[6] = K.z.x, e[7] = K.z.y, e[8] = K.z.z, e[9] = y.x, e[10] = y.y, e[11] = y.z;
  X.f += transposed_times(B, y);
  X.n = torque;
  if constexpr (kSphericalRotors) {
    const Symmetric<T>& A = X.A;
    const Vector<T> x = solved(factors, Vector<T>{A.xx, A.xy, A.xz});
    const Vector<T> z = solved(factors, Vector<T>{A.xz, A.yz, A.zz});
    const T yy = solved(factors, Vector<T>{A.xy, A.yy, A.yz}).y;
    X.A = {x.x * rotor, x.y * rotor, x.z * rotor, yy * rotor, z.y * rotor, z.z * rotor};
    X.B = {K.x * rotor, K.y * rotor, K.z * rotor};
    X.n += -(y * rotor);
  } else {
    X.A = Symmetric<T>{}, X.B = Matrix<T>{};
  }
}

// The same, from the far link's side to the near link's origin.
template <bool reversed, class T>
ADAGEN_INLINE void eliminate_rotations(Workspace& w, const Joints<T>& joints, Body<T>& X) {
  const Vector<T>& r = w.memory(joints).r;
  if constexpr (reversed) shift(X, -r);
  take_out_rotations<reversed>(w, joints, X);
  if constexpr (!reversed && kSphericalRotors) shift(X, r);
  if constexpr (!reversed && !kSphericalRotors) shift_mass(X, r);
}

// Whether joints first .. last leave of a body no more than its mass.
[[maybe_unused]] constexpr bool leave_mass_alone(int first, int last) {
  for (int j = first; j <= last; ++j)
    if (kJoints[j].kind != JointKind::kSpherical) return false;
  return !kSphericalRotors;
}

}  // namespace
