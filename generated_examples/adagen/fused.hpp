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
    Mat3 E;
    ADAGEN_FOR (k, 0, 3) {
      const Vec3 of(i.X.E(0, k), i.X.E(1, k), i.X.E(2, k));
      ADAGEN_FOR (row, 0, 3)
        E(row, k) = X.E(row, 0) * of[0] + X.E(row, 1) * of[1] + X.E(row, 2) * of[2];
      i.X.r[k] += of[0] * X.r[0] + of[1] * X.r[1] + of[2] * X.r[2];
    }
    i.X.E = E;
    Eigen::Matrix<Real, 6, at> before;
    std::copy_n(i.S.data(), 6 * at, before.data());
    const Eigen::Matrix<Real, 6, at> beyond = X * before;
    std::copy_n(beyond.data(), 6 * at, i.S.data());
    const Columns6 c = X * i.c;
    i.c = c;
  }
  for (int k = 0; k < kFree<Kind>; ++k) i.S(Kind::Free::row[k], at + k) = 1;
}

// Below this a run is in gimbal lock, and near it.
constexpr Real kLocked = std::max(Real(1e-7), 16 * std::numeric_limits<Real>::epsilon());
constexpr Real kNearLock = Real(1e-3);

inline Real squares(const Real* x, int count) {
  Real sum = 0;
  for (int k = 0; k < count; ++k) sum += x[k] * x[k];
  return sum;
}
// x - factor u (u^T x) of some columns x.
inline void reflect(const Real (&u)[6], Real factor, Real* columns, int count) {
  for (Real* x = columns; x != columns + 6 * count; x += 6) {
    Real along = 0;
    ADAGEN_FOR (row, 0, 6) along += u[row] * x[row];
    along *= factor;
    ADAGEN_FOR (row, 0, 6) x[row] -= u[row] * along;
  }
}

// B by Householder's reflections of S, lengths times ``unit`` and columns scaled to length one.
// Returns false in gimbal lock.
template <int n>
ADAGEN_NOINLINE bool fuse(Run<n>& i, Real unit) {
  Eigen::Matrix<Real, 6, n> R = i.S;
  Real scale[n];
  for (int k = 0; k < n; ++k) {
    Real* column = R.data() + 6 * k;
    ADAGEN_FOR (row, 3, 6) column[row] *= unit;
    scale[k] = 1 / std::sqrt(squares(column, 6));
    ADAGEN_FOR (row, 0, 6) column[row] *= scale[k];
  }
  i.B.setZero();
  for (int k = 0; k < 6; ++k) i.B(k, k) = k < 3 ? Real(1) : unit;
  for (int k = 0; k < n; ++k) {
    Real u[6]{};
    for (int row = k; row < 6; ++row) u[row] = R(row, k);
    u[k] += std::copysign(std::sqrt(squares(u, 6)), u[k]);
    const Real factor = 2 / squares(u, 6);
    reflect(u, factor, R.data(), n);
    reflect(u, factor, i.B.data(), 6);
  }
  Real inverse[n][n]{};
  for (int k = 0; k < n; ++k) {
    inverse[k][k] = 1 / R(k, k);
    for (int j = k - 1; j >= 0; --j) {
      Real sum = 0;
      for (int l = j + 1; l <= k; ++l) sum += R(j, l) * inverse[l][k];
      inverse[j][k] = -sum / R(j, j);
    }
  }
  for (int column = 0; column < 6; ++column)
    for (int row = 0; row < n; ++row) {  // those below are not changed yet
      Real sum = 0;
      for (int l = row; l < n; ++l) sum += inverse[row][l] * i.B(l, column);
      i.B(row, column) = scale[row] * sum;
    }
  const Mat6 X = i.X * Mat6(Mat6::Identity());
  i.BX = i.B * X;
  const Columns6 c = i.c;
  i.c = i.B * c;
  Real size = 0;
  for (const auto& row : inverse) size += squares(row, n);
  i.lock = 1 / std::sqrt(size);
  return i.lock >= kLocked;
}

}  // namespace
