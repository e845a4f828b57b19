// adagen's runtime, the same for all robots.
#pragma once

#include <Eigen/Core>
#include <Eigen/Geometry>
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
Six<T> spatial(const Eigen::Matrix<T, 3, 1>& angular, const Eigen::Matrix<T, 3, 1>& linear) {
  Six<T> result;
  result << angular, linear;
  return result;
}
inline Wide6 wide(const Wide3& angular, const Wide3& linear) { return spatial(angular, linear); }

// From a joint's parent link's coordinates to its child link's.
template <class T>
struct Carrier {
  Eigen::Matrix<T, 3, 3> E;
  Eigen::Matrix<T, 3, 1> r;  // origin of the child frame in the parent's

  Six<T> operator()(const Six<T>& m) const {
    const Eigen::Matrix<T, 3, 1> angular = m.template head<3>();
    return spatial<T>(E * angular, E * (m.template tail<3>() - r.cross(angular)));
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
  const Wide3 linear = E.transpose() * f.tail<3>();
  return wide(E.transpose() * f.head<3>() + r.cross(linear), linear);
}

// I m of a link: its mass at the centre of mass, its tensor about it.
template <class T>
Six<T> times_inertia(int link, const Six<T>& m) {
  using Vector = Eigen::Matrix<T, 3, 1>;
  const LinkConstants& body = kLinks[link];
  const Vector c(body.com[0], body.com[1], body.com[2]), angular = m.template head<3>();
  const Vector force = T(body.mass) * (m.template tail<3>() + angular.cross(c));
  Vector moment = c.cross(force);
  for (int i = 0; i < 3; ++i)
    for (int k = 0; k < 3; ++k) moment[i] += T(body.tensor[3 * i + k]) * angular[k];
  return spatial(moment, force);
}

// The rotation that a quaternion x y z w of any length stands for.
inline WideMat3 oriented(const Number* quaternion) {
  const Wide x = quaternion[0], y = quaternion[1], z = quaternion[2], w = quaternion[3];
  const Wide s = 2 / (x * x + y * y + z * z + w * w);
  WideMat3 turn;
  turn << 1 - s * (y * y + z * z), s * (x * y - z * w), s * (x * z + y * w),  //
      s * (x * y + z * w), 1 - s * (x * x + z * z), s * (y * z - x * w),      //
      s * (x * z - y * w), s * (y * z + x * w), 1 - s * (x * x + y * y);
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
  const auto turned = [&E = E, &base](Wide angle) {
    const Wide c = std::cos(angle), s = std::sin(angle);
    for (int k = 0; k < 3; ++k) {
      E(0, k) = c * base(k, 0) + s * base(k, 1);
      E(1, k) = c * base(k, 1) - s * base(k, 0);
      E(2, k) = base(k, 2);
    }
  };
  switch (joint.kind) {
    case JointKind::kRevolute:
      turned(scalar(0));
      break;
    case JointKind::kPrismatic:
      E = base.transpose();
      r += base.col(2) * scalar(0);
      break;
    case JointKind::kPlanar:
      turned(Wide(own[2]));
      r += base.col(0) * Wide(own[0]) + base.col(1) * Wide(own[1]);
      break;
    case JointKind::kFloating:
      E = (base * oriented(own + 3)).transpose();
      r += base * Wide3(Wide(own[0]), Wide(own[1]), Wide(own[2]));
      break;
    case JointKind::kSpherical:
      E = (base * oriented(own)).transpose();
      break;
  }
  return result;
}

}  // namespace
