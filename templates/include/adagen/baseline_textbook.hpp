// adagen's runtime, the same for all robots.
#pragma once

#include <Eigen/Core>
#include <array>

#include "baseline.hpp"
#include "joins.hpp"
#include "sizes.hpp"
#include "spatial.hpp"

namespace {

// As the textbook has it: I^A as a full 6x6 matrix from which U D^-1 U^T is subtracted.

// What the joint passes on of its articulated body; false where D cannot be factorized.
template <class Kind>
bool hand_on(Body& body, const Real* tau, Columns6& force) {
  constexpr int n = kFree<Kind>;
  constexpr auto& free = Kind::Free::row;
  Eigen::Matrix<Real, 6, n> U;
  Eigen::Matrix<Real, n, 6> E;
  Eigen::Matrix<Real, n, 1> u;
  std::array<std::array<Real, n>, n> D, identity{};
  Mat6& A = body.A;
  for (int k = 0; k < n; ++k) {
    U.col(k) = A.col(free[k]);
    u[k] = tau[k] - body.p(free[k], 0);
    for (int l = 0; l < n; ++l) D[k][l] = A(free[k], free[l]);
    identity[k][k] = 1;
  }
  const bool good = factorize(D);
  forward_substitute(D, identity);
  backward_substitute(D, identity);
  Eigen::Matrix<Real, n, n> inverse;
  for (int k = 0; k < n; ++k)
    for (int l = 0; l < n; ++l) inverse(k, l) = identity[k][l];
  E.noalias() = inverse * U.transpose();
  u = inverse * u;
  A.noalias() -= U * E;
  force.noalias() = body.p + A * body.c + U * u;
  for (int k = 0; k < n; ++k) {
    for (int l = 0; l < 6; ++l) body.E[k][l] = E(k, l);
    body.u[k][0] = u[k];
  }
  return good;
}

// X^T A X is felt by the parent.
inline void give(const Body& body, Body& parent) {
  Mat6 X = Mat6::Zero();
  X.topLeftCorner<3, 3>() = X.bottomRightCorner<3, 3>() = body.X.E;
  Mat3 across;
  const Vec3& r = body.X.r;
  across << 0, -r[2], r[1], r[2], 0, -r[0], -r[1], r[0], 0;
  X.bottomLeftCorner<3, 3>().noalias() = -body.X.E * across;
  Mat6 half;
  half.noalias() = body.A * X;
  parent.A.noalias() += X.transpose() * half;
}

}  // namespace
