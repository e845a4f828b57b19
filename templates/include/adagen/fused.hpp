// adagen's runtime, the same for all robots.
#pragma once

#include <Eigen/Core>
#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>

#include "common.hpp"
#include "joins.hpp"
#include "sizes.hpp"
#include "spatial.hpp"

namespace {

// Several joints in a row, through links without mass, as one. S = [X_(last<-j) S_j] in the last
// link's frame; in the coordinates B a of a motion a, B S = [1; 0]: the first rows of B are R, a
// left inverse of S, the others N, its left null space. There the run is a joint like any other.
template <int first, int... k>
constexpr Selection<first + k...> selection(std::integer_sequence<int, k...>) {
  return {};
}

template <int n>
struct Fused {
  using Free = decltype(selection<0>(std::make_integer_sequence<int, n>{}));
  using Constrained = decltype(selection<n>(std::make_integer_sequence<int, 6 - n>{}));
};

template <int n>
struct Run {
  Transform X;  // from the frame of the link before the run to the last one's
  Eigen::Matrix<Real, 6, n> S;
  Columns6 c;  // sum of X_(last<-j) (v_j x S_j qd_j); fused: B c
  Mat6 B;
  Mat6 BX;
  Real lock;  // 1 / |S^+|, how far from gimbal lock; about the least singular value of S near it
};

// Part of the rows of a run, those of one joint.
template <int first, std::size_t count, std::size_t n>
std::array<std::array<Real, kColumns>, count> part(
    const std::array<std::array<Real, kColumns>, n>& rows) {
  std::array<std::array<Real, kColumns>, count> result;
  for (std::size_t k = 0; k < count; ++k) result[k] = rows[first + k];
  return result;
}

template <int first, std::size_t count, std::size_t n>
void place(const std::array<std::array<Real, kColumns>, count>& rows,
           std::array<std::array<Real, kColumns>, n>& whole) {
  for (std::size_t k = 0; k < count; ++k) whole[first + k] = rows[k];
}

// Adds a joint beyond those that are in the run already; ``at`` counts their freedoms.
template <class Kind, int at, int n>
void extend(Run<n>& i, const Transform& X) {
  if constexpr (at == 0) {
    i.X = X;
    i.S.setZero();
    i.c.setZero();
  } else {
    const Mat3 E = X.E * i.X.E;
    i.X.r += i.X.E.transpose() * X.r;
    i.X.E = E;
    const Eigen::Matrix<Real, 6, at> before = i.S.template leftCols<at>();
    i.S.template leftCols<at>() = X * before;
    const Columns6 c = X * i.c;
    i.c = c;
  }
  for (int k = 0; k < kFree<Kind>; ++k) i.S(Kind::Free::row[k], at + k) = 1;
}

// Below this a run is in gimbal lock, and near it.
constexpr Real kLocked = std::max(Real(1e-7), 16 * std::numeric_limits<Real>::epsilon());
constexpr Real kNearLock = Real(1e-3);

// B by Householder's reflections of S, scaled: lengths by the largest distance of an axis from the
// link's origin, columns to length one. Returns false in gimbal lock.
template <int n>
ADAGEN_NOINLINE bool fuse(Run<n>& i) {
  Real squared = 0;
  for (int k = 0; k < n; ++k)
    if (i.S.col(k).template head<3>().squaredNorm() > 0)
      squared = std::max(squared, i.S.col(k).template tail<3>().squaredNorm());
  const Real unit = squared > 0 ? 1 / std::sqrt(squared) : Real(1);
  Eigen::Matrix<Real, 6, n> R = i.S;
  R.template bottomRows<3>() *= unit;
  Eigen::Matrix<Real, n, 1> scale;
  for (int k = 0; k < n; ++k) {
    scale[k] = 1 / R.col(k).norm();
    R.col(k) *= scale[k];
  }
  i.B.setZero();
  for (int k = 0; k < 6; ++k) i.B(k, k) = k < 3 ? Real(1) : unit;
  for (int k = 0; k < n; ++k) {
    Vec6 u = R.col(k);
    u.head(k).setZero();
    u[k] += std::copysign(u.norm(), u[k]);
    const Real factor = 2 / u.squaredNorm();
    const Eigen::Matrix<Real, 1, n> on_R = factor * (u.transpose() * R);
    const Eigen::Matrix<Real, 1, 6> on_B = factor * (u.transpose() * i.B);
    R -= u * on_R;
    i.B -= u * on_B;
  }
  Eigen::Matrix<Real, n, n> inverse = Eigen::Matrix<Real, n, n>::Zero();
  for (int k = 0; k < n; ++k) {
    inverse(k, k) = 1 / R(k, k);
    for (int j = k - 1; j >= 0; --j) {
      Real sum = 0;
      for (int l = j + 1; l <= k; ++l) sum += R(j, l) * inverse(l, k);
      inverse(j, k) = -sum / R(j, j);
    }
  }
  const Eigen::Matrix<Real, n, 6> top = inverse * i.B.template topRows<n>();
  i.B.template topRows<n>() = scale.asDiagonal() * top;
  const Mat6 X = i.X * Mat6(Mat6::Identity());
  i.BX.noalias() = i.B * X;
  const Columns6 c = i.c;
  i.c.noalias() = i.B * c;
  i.lock = 1 / inverse.norm();
  return i.lock >= kLocked;
}

}  // namespace
