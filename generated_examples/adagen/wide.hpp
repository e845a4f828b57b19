// adagen's runtime, the same for all robots.
#pragma once

#include <Eigen/Core>
#include <cmath>
#include <type_traits>

#include "constants.hpp"
#include "joins.hpp"
#include "sample/robot.hpp"
#include "sizes.hpp"

namespace {

// Joints and links in higher precision, for the residuals of refinement.
using Wide = std::conditional_t<std::is_same_v<Real, float>, double, long double>;
using Wide3 = Eigen::Matrix<Wide, 3, 1>;
using Wide6 = Eigen::Matrix<Wide, 6, 1>;
using WideMat3 = Eigen::Matrix<Wide, 3, 3>;
template <class T>
using Six = Eigen::Matrix<T, 6, 1>;

template <class T>
using Three = Eigen::Matrix<T, 3, 1>;

// Written out, as in spatial.hpp.
template <class T>
Six<T> spatial(const Three<T>& angular, const Three<T>& linear) {
  Six<T> result;
  ADAGEN_FOR (k, 0, 3) result[k] = angular[k], result[3 + k] = linear[k];
  return result;
}
template <class T>
Three<T> angular_of(const Six<T>& m) {
  return {m[0], m[1], m[2]};
}
template <class T>
Three<T> linear_of(const Six<T>& m) {
  return {m[3], m[4], m[5]};
}
template <class T>
Three<T> crossed(const Three<T>& a, const Three<T>& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}
template <class T>
Three<T> sum(const Three<T>& a, const Three<T>& b) {
  return {a[0] + b[0], a[1] + b[1], a[2] + b[2]};
}
template <class T>
Three<T> turned(const Eigen::Matrix<T, 3, 3>& E, const Three<T>& x) {
  Three<T> result;
  ADAGEN_FOR (i, 0, 3) result[i] = E(i, 0) * x[0] + E(i, 1) * x[1] + E(i, 2) * x[2];
  return result;
}
template <class T>
Three<T> turned_back(const Eigen::Matrix<T, 3, 3>& E, const Three<T>& x) {  // E^T x
  Three<T> result;
  ADAGEN_FOR (i, 0, 3) result[i] = E(0, i) * x[0] + E(1, i) * x[1] + E(2, i) * x[2];
  return result;
}

// From a joint's parent link's coordinates to its child link's.
template <class T>
struct Carrier {
  Eigen::Matrix<T, 3, 3> E;
  Three<T> r;  // origin of the child frame in the parent's

  Six<T> operator()(const Six<T>& m) const {
    const Three<T> angular = angular_of(m);
    return spatial(turned(E, angular), turned(E, sum(linear_of(m), crossed(angular, r))));
  }
};

// Which entry of a motion the k-th freedom of a joint is.
inline int free_row(JointKind kind, int k) {
  switch (kind) {
    case JointKind::kRevolute:
      return Revolute::Free::row[k];
    case JointKind::kPrismatic:
      return Prismatic::Free::row[k];
    case JointKind::kSpherical:
      return Spherical::Free::row[k];
    case JointKind::kPlanar:
      return Planar::Free::row[k];
    case JointKind::kFloating:
      return Floating::Free::row[k];
  }
  return 0;
}

// A joint's rates as a motion or force of its child link.
template <class T, class Rate>
Six<T> along_joint(int j, const Rate* rates) {
  Six<T> result = Six<T>::Zero();
  const JointConstants& joint = kJoints[j];
  for (int k = 0; k < joint.nv; ++k)
    result[free_row(joint.kind, k)] = static_cast<T>(rates[joint.v + k]);
  return result;
}

// A wrench on a joint's child link, in its parent link's frame.
inline Wide6 returned(const Carrier<Wide>& X, const Wide6& f) {
  const auto& [E, r] = X;
  const Wide3 linear = turned_back(E, linear_of(f));
  return spatial(sum(turned_back(E, angular_of(f)), crossed(r, linear)), linear);
}

// I m of a link: its mass at the centre of mass, its tensor about it.
template <class T>
Six<T> times_inertia(int link, const Six<T>& m) {
  const LinkConstants& body = kLinks[link];
  const Three<T> c(body.com[0], body.com[1], body.com[2]), angular = angular_of(m);
  Three<T> force = sum(linear_of(m), crossed(angular, c));
  for (int i = 0; i < 3; ++i) force[i] *= T(body.mass);
  Three<T> moment = crossed(c, force);
  for (int i = 0; i < 3; ++i)
    for (int k = 0; k < 3; ++k) moment[i] += T(body.tensor[3 * i + k]) * angular[k];
  return spatial(moment, force);
}

// The rotation that a quaternion x y z w of any length stands for.
inline WideMat3 oriented(const Number* quaternion) {
  const Wide x = quaternion[0], y = quaternion[1], z = quaternion[2], w = quaternion[3];
  const Wide s = 2 / (x * x + y * y + z * z + w * w);
  const Wide rows[3][3]{{1 - s * (y * y + z * z), s * (x * y - z * w), s * (x * z + y * w)},
                        {s * (x * y + z * w), 1 - s * (x * x + z * z), s * (y * z - x * w)},
                        {s * (x * z - y * w), s * (y * z + x * w), 1 - s * (x * x + y * y)}};
  WideMat3 turn;
  for (int k = 0; k < 9; ++k) turn(k / 3, k % 3) = rows[k / 3][k % 3];
  return turn;
}

// From its parent link's frame to its child link's, at a configuration.
inline Carrier<Wide> carrier_of(int j, const Number* q) {
  const JointConstants& joint = kJoints[j];
  Carrier<Wide> result;
  auto& [E, r] = result;
  WideMat3 base;
  for (int k = 0; k < 9; ++k) base(k / 3, k % 3) = Wide(joint.rotation[k]);
  for (int k = 0; k < 3; ++k) r[k] = Wide(joint.translation[k]);
  const Number* const own = q + (joint.source < 0 ? joint.q : kJoints[joint.source].q);
  const auto scalar = [&joint, own](int k) {
    if (joint.source < 0) return Wide(own[k]);
    return Wide(joint.multiplier) * Wide(own[k]) + Wide(joint.offset);
  };
  const auto rotated_by = [&E = E, &base](Wide angle) {
    const Wide c = std::cos(angle), s = std::sin(angle);
    for (int k = 0; k < 3; ++k) {
      E(0, k) = c * base(k, 0) + s * base(k, 1);
      E(1, k) = c * base(k, 1) - s * base(k, 0);
      E(2, k) = base(k, 2);
    }
  };
  const auto oriented_by = [&E = E, &base](const Number* quaternion) {  // (base times it)^T
    const WideMat3 turn = oriented(quaternion);
    for (int i = 0; i < 3; ++i)
      for (int k = 0; k < 3; ++k)
        E(k, i) = base(i, 0) * turn(0, k) + base(i, 1) * turn(1, k) + base(i, 2) * turn(2, k);
  };
  const auto slid = [&r = r, &base](int column, Wide by) {
    for (int k = 0; k < 3; ++k) r[k] += base(k, column) * by;
  };
  switch (joint.kind) {
    case JointKind::kRevolute:
      rotated_by(scalar(0));
      break;
    case JointKind::kPrismatic:
      for (int k = 0; k < 9; ++k) E(k % 3, k / 3) = base(k / 3, k % 3);
      slid(2, scalar(0));
      break;
    case JointKind::kPlanar:
      rotated_by(Wide(own[2]));
      slid(0, Wide(own[0])), slid(1, Wide(own[1]));
      break;
    case JointKind::kFloating:
      oriented_by(own + 3);
      for (int k = 0; k < 3; ++k) slid(k, Wide(own[k]));
      break;
    case JointKind::kSpherical:
      oriented_by(own);
      break;
  }
  return result;
}

}  // namespace
