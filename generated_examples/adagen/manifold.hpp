// adagen's runtime, the same for all robots.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

#include "program_setting.hpp"

namespace adagen {
namespace {

// Configurations as points of a manifold. Near an anchor q0 a configuration has local coordinates
// x, as many as velocities: a rotation vector in the child's frame where there is a quaternion,
// the change of q itself elsewhere (of a floating or planar joint's position: in its joint frame).
namespace manifold {

using State = std::vector<double>;

// a x b.
inline void cross(const double* a, const double* b, double* result) {
  for (int k = 0; k < 3; ++k)
    result[k] = a[(k + 1) % 3] * b[(k + 2) % 3] - a[(k + 2) % 3] * b[(k + 1) % 3];
}

// The joint's own rotation takes v, in the child's frame, to the joint frame: v + 2 p x (w v + p x
// v) for a quaternion (p, w) of any length.
inline void rotate(const double* quaternion, const double* v, double* result) {
  double squared = 0, inner[3], outer[3];
  for (int k = 0; k < 4; ++k) squared += quaternion[k] * quaternion[k];
  cross(quaternion, v, inner);
  for (int k = 0; k < 3; ++k) inner[k] += quaternion[3] * v[k];
  cross(quaternion, inner, outer);
  for (int k = 0; k < 3; ++k) result[k] = v[k] + 2 / squared * outer[k];
}

// Quaternions p times (x, w).
inline void multiply(const double* p, const double* x, double w, double* result) {
  double twisted[3];
  cross(p, x, twisted);
  for (int k = 0; k < 3; ++k) result[k] = p[3] * x[k] + w * p[k] + twisted[k];
  result[3] = p[3] * w - (p[0] * x[0] + p[1] * x[1] + p[2] * x[2]);
}

inline double length(const double* x, int count) {
  double squared = 0;
  for (int k = 0; k < count; ++k) squared += x[k] * x[k];
  return std::sqrt(squared);
}

constexpr bool turns_freely(const Joint& joint) { return joint.nq >= 4; }

ADAGEN_HOT void normalise(State& q) {
  for (const Joint& joint : about.joints) {
    if (!turns_freely(joint)) continue;
    double* const quaternion = &q[static_cast<std::size_t>(joint.q + joint.nq - 4)];
    const double size = length(quaternion, 4);
    if (!(size > 0)) continue;  // the solver refuses it by name
    for (int k = 0; k < 4; ++k) quaternion[k] /= size;
  }
}

// Velocity of the origin of a floating or planar joint's child, expressed in the joint frame; its
// row count.
inline int position_rate(const Joint& joint, const double* q, const double* v, double* rate) {
  if (joint.kind == JointKind::kFloating) {
    rotate(q + 3, v, rate);
    return 3;
  }
  if (joint.kind != JointKind::kPlanar) return 0;
  const double c = std::cos(q[2]), s = std::sin(q[2]);
  rate[0] = c * v[0] - s * v[1];
  rate[1] = s * v[0] + c * v[1];
  return 2;
}

// q' as numbers: quaternions by half their product with the angular velocity.
ADAGEN_HOT void rate(const State& q, const State& v, State& result) {
  for (const Joint& joint : about.joints) {
    const double* const own = &q[static_cast<std::size_t>(joint.q)];
    const double* const speed = &v[static_cast<std::size_t>(joint.v)];
    double* const to = &result[static_cast<std::size_t>(joint.q)];
    const int done = position_rate(joint, own, speed, to);
    if (turns_freely(joint)) {
      const double half[3] = {speed[done] / 2, speed[done + 1] / 2, speed[done + 2] / 2};
      multiply(own + done, half, 0, to + done);
    } else {
      std::copy(speed + done, speed + joint.nv, to + done);
    }
  }
}

// x' at local coordinates x, where the configuration is q: for rotations the inverse of the
// exponential's derivative, v + x x v / 2 + c x x (x x v), c = (1 - a cot a) / (2 a)^2 at a =
// |x|/2.
ADAGEN_HOT void local_rate(const State& q, const State& x, const State& v, State& result) {
  for (const Joint& joint : about.joints) {
    const double* const speed = &v[static_cast<std::size_t>(joint.v)];
    double* const to = &result[static_cast<std::size_t>(joint.v)];
    const int done = position_rate(joint, &q[static_cast<std::size_t>(joint.q)], speed, to);
    std::copy(speed + done, speed + joint.nv, to + done);
    if (!turns_freely(joint)) continue;
    const double* const turn = &x[static_cast<std::size_t>(joint.v + done)];
    const double half = length(turn, 3) / 2;
    const double c = half < 1e-3 ? 1.0 / 12 + half * half / 180
                                 : (1 - half / std::tan(half)) / (4 * half * half);
    double once[3], twice[3];
    cross(turn, speed + done, once);
    cross(turn, once, twice);
    for (int k = 0; k < 3; ++k) to[done + k] += once[k] / 2 + c * twice[k];
  }
}

// The configuration with local coordinates x about the anchor.
ADAGEN_HOT void advance(const State& anchor, const State& x, State& q) {
  for (const Joint& joint : about.joints) {
    const double* const from = &anchor[static_cast<std::size_t>(joint.q)];
    const double* const by = &x[static_cast<std::size_t>(joint.v)];
    double* const to = &q[static_cast<std::size_t>(joint.q)];
    const int plain = turns_freely(joint) ? joint.nq - 4 : joint.nq;
    for (int k = 0; k < plain; ++k) to[k] = from[k] + by[k];
    if (!turns_freely(joint)) continue;
    const double* const turn = by + plain;
    const double half = length(turn, 3) / 2;
    const double part = half < 1e-3 ? 0.5 - half * half / 12 : std::sin(half) / (2 * half);
    const double vector[3] = {part * turn[0], part * turn[1], part * turn[2]};
    multiply(from + plain, vector, std::cos(half), to + plain);
  }
}

// A configuration moved by a step in the components of velocities.
inline void move(const State& from, const State& step, State& q) {
  State local = step;
  for (const Joint& joint : about.joints)  // positions are expressed in the joint frame
    position_rate(joint, &from[static_cast<std::size_t>(joint.q)],
                  &step[static_cast<std::size_t>(joint.v)],
                  &local[static_cast<std::size_t>(joint.v)]);
  advance(from, local, q);
  normalise(q);
}

}  // namespace manifold

}  // namespace
}  // namespace adagen
