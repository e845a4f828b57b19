// adagen's runtime, the same for all robots.
#pragma once

#include <Eigen/Core>
#include <algorithm>
#include <array>

#include "common.hpp"
#include "constants.hpp"
#include "sizes.hpp"
#include "spatial.hpp"

namespace {

// Spatial inertias, and how they, wrenches and motions are expressed in another frame.

// A spatial inertia [[A, B], [B^T, C]]: A and C symmetric, their upper triangles row by row; B row
// by row. 21 numbers, and half the work of a 6x6 matrix.
struct Inertia {
  std::array<Real, 6> A, C;
  std::array<Real, 9> B;

  static constexpr int symmetric(int i, int k) {
    return i <= k ? i * (5 - i) / 2 + k : symmetric(k, i);
  }

  constexpr Real operator()(int i, int k) const {
    if (i < 3 && k < 3) return A[symmetric(i, k)];
    if (i >= 3 && k >= 3) return C[symmetric(i - 3, k - 3)];
    return i < 3 ? B[3 * i + k - 3] : B[3 * k + i - 3];
  }

  // Sets the entries (i, k) and (k, i), which are one.
  constexpr void set(int i, int k, Real value) {
    if (i < 3 && k < 3)
      A[symmetric(i, k)] = value;
    else if (i >= 3 && k >= 3)
      C[symmetric(i - 3, k - 3)] = value;
    else if (i < 3)
      B[3 * i + k - 3] = value;
    else
      B[3 * k + i - 3] = value;
  }

  Inertia& operator+=(const Inertia& other) {
    ADAGEN_FOR (k, 0, 6) A[k] += other.A[k], C[k] += other.C[k];
    ADAGEN_FOR (k, 0, 9) B[k] += other.B[k];
    return *this;
  }
};

// T^T m T for a symmetric m, T being E or, transposed, E^T; both row by row.
template <bool transposed>
std::array<Real, 6> rotated(const Mat3& E, const std::array<Real, 6>& m) {
  const auto T = [&E](int i, int k) { return transposed ? E(k, i) : E(i, k); };
  std::array<Real, 9> half;  // m T
  ADAGEN_FOR (i, 0, 3)
    ADAGEN_FOR (k, 0, 3)
      half[3 * i + k] = m[Inertia::symmetric(i, 0)] * T(0, k) +
                        m[Inertia::symmetric(i, 1)] * T(1, k) +
                        m[Inertia::symmetric(i, 2)] * T(2, k);
  std::array<Real, 6> result;
  ADAGEN_FOR (i, 0, 3)
    ADAGEN_FOR (k, i, 3)
      result[Inertia::symmetric(i, k)] =
          T(0, i) * half[k] + T(1, i) * half[3 + k] + T(2, i) * half[6 + k];
  return result;
}

template <bool transposed>
std::array<Real, 9> rotated(const Mat3& E, const std::array<Real, 9>& m) {
  const auto T = [&E](int i, int k) { return transposed ? E(k, i) : E(i, k); };
  std::array<Real, 9> half, result;
  ADAGEN_FOR (i, 0, 3)
    ADAGEN_FOR (k, 0, 3)
      half[3 * i + k] = m[3 * i] * T(0, k) + m[3 * i + 1] * T(1, k) + m[3 * i + 2] * T(2, k);
  ADAGEN_FOR (i, 0, 3)
    ADAGEN_FOR (k, 0, 3)
      result[3 * i + k] = T(0, i) * half[k] + T(1, i) * half[3 + k] + T(2, i) * half[6 + k];
  return result;
}

// The inertia m expressed at a point whose origin is at -r from the one it is expressed at:
// B + rx C, and A + rx (B + rx C)^T - B rx.
template <class Place>
void shift(const Place& r, Inertia& m) {
  const auto& C = m.C;
  auto& A = m.A;
  const std::array<Real, 9> B = m.B;
  auto& S = m.B;
  const auto c = [&C](int i, int k) { return C[Inertia::symmetric(i, k)]; };
  ADAGEN_FOR (k, 0, 3) {
    S[k] += r[1] * c(2, k) - r[2] * c(1, k);
    S[3 + k] += r[2] * c(0, k) - r[0] * c(2, k);
    S[6 + k] += r[0] * c(1, k) - r[1] * c(0, k);
  }
  A[0] += r[1] * S[2] - r[2] * S[1] - (B[1] * r[2] - B[2] * r[1]);
  A[1] += r[1] * S[5] - r[2] * S[4] - (B[2] * r[0] - B[0] * r[2]);
  A[2] += r[1] * S[8] - r[2] * S[7] - (B[0] * r[1] - B[1] * r[0]);
  A[3] += r[2] * S[3] - r[0] * S[5] - (B[5] * r[0] - B[3] * r[2]);
  A[4] += r[2] * S[6] - r[0] * S[8] - (B[3] * r[1] - B[4] * r[0]);
  A[5] += r[0] * S[7] - r[1] * S[6] - (B[6] * r[1] - B[7] * r[0]);
}

// target += X^T m X: an inertia in the child's frame, felt in the parent's.
ADAGEN_NOINLINE void add_in_parent(const Transform& X, const Inertia& m, Inertia& target) {
  Inertia turned{rotated<false>(X.E, m.A), rotated<false>(X.E, m.C), rotated<false>(X.E, m.B)};
  shift(X.r, turned);
  target += turned;
}

// X^-T m X^-1: an inertia in the parent's frame, felt in the child's.
ADAGEN_NOINLINE Inertia in_child(const Transform& X, const Inertia& m) {
  Inertia moved = m;
  shift(std::array<Real, 3>{-X.r[0], -X.r[1], -X.r[2]}, moved);
  return {rotated<true>(X.E, moved.A), rotated<true>(X.E, moved.C), rotated<true>(X.E, moved.B)};
}

// X^-T f: a wrench on the parent, felt in the child's frame.
[[maybe_unused]] inline Columns6 wrench_in_child(const Transform& X, const Columns6& f) {
  Columns6 result;
  ADAGEN_FOR (k, 0, kColumns) {
    const Real* c = f.data() + 6 * k;
    const Vec3 force(c[3], c[4], c[5]), about = cross(X.r, force);
    const Real moment[3]{c[0] - about[0], c[1] - about[1], c[2] - about[2]};
    ADAGEN_FOR (i, 0, 3) {
      result(i, k) = X.E(i, 0) * moment[0] + X.E(i, 1) * moment[1] + X.E(i, 2) * moment[2];
      result(3 + i, k) = X.E(i, 0) * force[0] + X.E(i, 1) * force[1] + X.E(i, 2) * force[2];
    }
  }
  return result;
}

// X^-1 m: motions in the child's frame, expressed in the parent's.
template <int columns>
Eigen::Matrix<Real, 6, columns> motion_in_parent(const Transform& X,
                                                 const Eigen::Matrix<Real, 6, columns>& m) {
  Eigen::Matrix<Real, 6, columns> result;
  ADAGEN_FOR (k, 0, columns) {
    const Real* c = m.data() + 6 * k;
    Vec3 angular;
    ADAGEN_FOR (i, 0, 3) angular[i] = X.E(0, i) * c[0] + X.E(1, i) * c[1] + X.E(2, i) * c[2];
    const Vec3 swept = cross(X.r, angular);
    ADAGEN_FOR (i, 0, 3) {
      result(i, k) = angular[i];
      result(3 + i, k) = X.E(0, i) * c[3] + X.E(1, i) * c[4] + X.E(2, i) * c[5] + swept[i];
    }
  }
  return result;
}

// X^-1 m X^-T: a mobility in the child's frame, expressed in the parent's.
template <class Matrix>
ADAGEN_NOINLINE Matrix congruent_in_parent(const Transform& X, const Matrix& m) {
  const Matrix half = motion_in_parent(X, m).transpose();
  return motion_in_parent(X, half);
}

// Spatial inertia of a link at its origin.
Inertia spatial_inertia(const LinkConstants& link) {
  const Real x = Real(link.com[0]), y = Real(link.com[1]), z = Real(link.com[2]);
  const Real m = Real(link.mass);
  std::array<Real, 9> t;
  std::transform(link.tensor, link.tensor + 9, t.begin(), [](Number value) { return Real(value); });
  return {{t[0] + m * (y * y + z * z), t[1] - m * x * y, t[2] - m * x * z,
           t[4] + m * (x * x + z * z), t[5] - m * y * z, t[8] + m * (x * x + y * y)},
          {m, 0, 0, m, 0, m},
          {0, -m * z, m * y, m * z, 0, -m * x, -m * y, m * x, 0}};
}

}  // namespace
