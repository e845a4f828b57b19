// adagen's runtime, the same for all robots.
#pragma once

#include <cstddef>
#include <cstring>

#include "../common.hpp"
#include "../constants.hpp"
#include "../sample/robot.hpp"
#include "../sizes.hpp"
#include "../value.hpp"
#include "algebra.hpp"
#include "blocks.hpp"
#include "lanes.hpp"
#include "memory.hpp"

namespace {

// Work without recursion, for as many links at once as a register has lanes.

// Constants of each of the joints.
template <class T>
ADAGEN_INLINE T constant(const Joints<T>& joints, PerJoint BlockConstants::* member) {
  const int place = constants_at(joints.slot / kPerBlock);
  const auto& block = kBlockConstants[static_cast<std::size_t>(place)];
  return number_at<T>(&(block.*member)[static_cast<std::size_t>(joints.slot % kPerBlock)]);
}
template <class T>
ADAGEN_INLINE auto mass_of(const Workspace& w, const Joints<T>& joints) {
  if constexpr (kWidth<T> == 1)
    return w.inertia_of(joints.joint[0]).mass;
  else
    return number_at<T>(&w.constants_of(joints.slot / kPerBlock)
                             .mass[static_cast<std::size_t>(joints.slot % kPerBlock)]);
}
template <class T>
ADAGEN_INLINE auto origin_of(const Joints<T>& joints) {
  if constexpr (kWidth<T> == 1) {
    const Number* const x = joints.any().translation;
    return Vector<Real>{Real(x[0]), Real(x[1]), Real(x[2])};
  } else {
    return Vector<T>{constant(joints, &BlockConstants::x), constant(joints, &BlockConstants::y),
                     constant(joints, &BlockConstants::z)};
  }
}

ADAGEN_INLINE Lanes wide(const PerJoint& x) {
  if constexpr (sizeof(PerJoint) == sizeof(Lanes))
    return from_memory<Lanes>(x.data());
  else
    return x[0] + Lanes{};
}
ADAGEN_INLINE void narrow(const Lanes& x, Value* to) { to_memory(x, to); }
ADAGEN_INLINE Vector<Lanes> wide_vector(const Value (*x)[kPerBlock]) {
  return {wide(x[0]), wide(x[1]), wide(x[2])};
}
ADAGEN_INLINE Vector<Lanes> wide_vector(const PerJoint* x) {
  return {wide(x[0]), wide(x[1]), wide(x[2])};
}
ADAGEN_INLINE void narrow(const Vector<Lanes>& a, Value (*x)[kPerBlock]) {
  narrow(a.x, x[0]), narrow(a.y, x[1]), narrow(a.z, x[2]);
}

// Copies the angles of those of joints first .. last that turn.
template <int first, int last>
void take_angles(Workspace& w) {
  ADAGEN_FOR (j, first, last + 1) {
    const JointConstants& joint = kJoints[static_cast<std::size_t>(j)];
    const int place = joint.q + (joint.kind == JointKind::kPlanar ? 2 : 0);
    if (joint.kind == JointKind::kRevolute || joint.kind == JointKind::kPlanar)
      w.angle[static_cast<std::size_t>(slot_of(j))] = w.q[place];
  }
}

// Turns the joints of blocks first .. last - 1 by their angles: columns x and y of the rotation.
// In tiles after the first, blocks are shifted by `beyond`.
template <int first, int last>
void turn(Workspace& w, int beyond = 0) {
  for (int b = first; b < last; ++b) {
    Block& block = w.blocks[static_cast<std::size_t>(b)];
    const int place = constants_at(b + beyond);
    const BlockConstants& constants = kBlockConstants[static_cast<std::size_t>(place)];
    Lanes s, c;
    sine_and_cosine(wide(&w.angle[static_cast<std::size_t>(b * kPerBlock)]), s, c);
    ADAGEN_FOR (k, 0, 3) {
      const Lanes x = wide(constants.rotation[k]), y = wide(constants.rotation[3 + k]);
      narrow(x * c + y * s, block.entries[kTurn + 3 * k]);
      narrow(y * c - x * s, block.entries[kTurn + 3 * k + 1]);
      if constexpr (kTile > 0)
        narrow(wide(constants.rotation[6 + k]), block.entries[kTurn + 3 * k + 2]);
    }
  }
}

// The bias force of a bare link of pseudo-inertia J and moments c about its origin: that of the
// acceleration field a + H x, H = alpha x + omega x omega x. All in the same axes.
template <class T>
ADAGEN_INLINE void bias_force(const Symmetric<T>& J, const Vector<T>& c, const T& mass,
                              const Vector<T>& w, const Vector<T>& al, const Vector<T>& a,
                              Vector<T>& n, Vector<T>& f) {
  const T xx = w.x * w.x, yy = w.y * w.y, zz = w.z * w.z;
  const T xy = w.x * w.y, xz = w.x * w.z, yz = w.y * w.z;
  const Matrix<T> H{{-(yy + zz), xy - al.z, xz + al.y},
                    {xy + al.z, -(xx + zz), yz - al.x},
                    {xz - al.y, yz + al.x, -(xx + yy)}};
  const Vector<T> Jx{J.xx, J.xy, J.xz}, Jy{J.xy, J.yy, J.yz}, Jz{J.xz, J.yz, J.zz};
  n = cross(c, a);
  n += Vector<T>{dot(H.z, Jy) - dot(H.y, Jz), dot(H.x, Jz) - dot(H.z, Jx),
                 dot(H.y, Jx) - dot(H.x, Jy)};
  f = a * mass + H * c;
}

// Inertia and bias force of the bare links of a block in the axes of their base, from how they lie
// and move. With the pseudo-inertia J = sum of m x x^T about the link's origin, A = tr(J) 1 - J.
ADAGEN_INLINE void set_up_block(Block& block, const BlockConstants& constants,
                                const Frame<Lanes>& at) {
  const Matrix<Lanes>& R = at.R;
  const Symmetric<Lanes> T{wide(constants.tensor[0]), wide(constants.tensor[1]),
                           wide(constants.tensor[2]), wide(constants.tensor[3]),
                           wide(constants.tensor[4]), wide(constants.tensor[5])};
  const Matrix<Lanes> RT{T * R.x, T * R.y, T * R.z};  // rows of R T
  const Symmetric<Lanes> J{dot(RT.x, R.x), dot(RT.x, R.y), dot(RT.x, R.z),
                           dot(RT.y, R.y), dot(RT.y, R.z), dot(RT.z, R.z)};
  narrow(J.yy + J.zz, block.entries[kRotational]);
  narrow(-J.xy, block.entries[kRotational + 1]);
  narrow(-J.xz, block.entries[kRotational + 2]);
  narrow(J.xx + J.zz, block.entries[kRotational + 3]);
  narrow(-J.yz, block.entries[kRotational + 4]);
  narrow(J.xx + J.yy, block.entries[kRotational + 5]);
  const Vector<Lanes> c = R * wide_vector(constants.moments);
  narrow(c, block.entries + kMoments);

  Vector<Lanes> n, f;
  bias_force(J, c, wide(constants.mass), at.omega, at.alpha, at.a, n, f);
  narrow(n, block.entries + kTorque);
  narrow(f, block.entries + kForce);
}

// The same of blocks first .. last - 1, whose frames are kept.
template <int first, int last>
void set_up_links(Workspace& w, int beyond = 0) {
  for (int b = first; b < last; ++b) {
    Block& block = w.blocks[static_cast<std::size_t>(b)];
    const auto& entries = block.entries;
    const Matrix<Lanes> R{wide_vector(entries + kAxes), wide_vector(entries + kAxes + 3),
                          wide_vector(entries + kAxes + 6)};
    set_up_block(block, w.constants_of(b + beyond),
                 {R, wide_vector(entries + kOmega), wide_vector(entries + kAlpha),
                  wide_vector(entries + kAcceleration)});
  }
}

}  // namespace
