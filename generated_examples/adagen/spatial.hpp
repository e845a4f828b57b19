// adagen's runtime, the same for all robots.
#pragma once

#include <Eigen/Core>
#include <array>
#include <cstddef>
#include <type_traits>

#include "common.hpp"
#include "constants.hpp"
#include "registers.hpp"
#include "sizes.hpp"
#include "value.hpp"

namespace {

// Spatial vectors are [angular; linear], in link frames. A right-hand side has kColumns columns:
// the motion itself, and one for each slaved joint's coupling torque.
using Vec3 = Eigen::Matrix<Real, 3, 1>;
using Mat3 = Eigen::Matrix<Real, 3, 3>;
using Vec6 = Eigen::Matrix<Real, 6, 1>;
using Mat6 = Eigen::Matrix<Real, 6, 6>;
using Columns6 = Eigen::Matrix<Real, 6, kColumns>;

// Functions that nearly every solver calls are written out, number by number: Eigen's expressions
// take longer to compile than everything else. Rare functions are templates.
inline Vec3 cross(const Vec3& a, const Vec3& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}

// Motion transform X = [[E, 0], [-E rx, E]] from the parent link's to the child link's frame.
struct Transform {
  Mat3 E;  // rotates parent coordinates into child coordinates
  Vec3 r;  // origin of the child frame in parent coordinates

  template <class M>
  void times(const M& m, M& result) const {
    for (int k = 0; k < M::ColsAtCompileTime; ++k) {
      const Real* c = m.data() + 6 * k;
      const Real x = c[0], y = c[1], z = c[2];
      const Real u = c[3] - (r[1] * z - r[2] * y), v = c[4] - (r[2] * x - r[0] * z),
                 w = c[5] - (r[0] * y - r[1] * x);
      Real* to = result.data() + 6 * k;
      ADAGEN_FOR (i, 0, 3) {
        to[i] = E(i, 0) * x + E(i, 1) * y + E(i, 2) * z;
        to[3 + i] = E(i, 0) * u + E(i, 1) * v + E(i, 2) * w;
      }
    }
  }

  // X^T m: takes a wrench on the child to the same wrench on the parent.
  Columns6 transposed_times(const Columns6& m) const {
    Columns6 result;
    for (int k = 0; k < kColumns; ++k) {
      const Real* c = m.data() + 6 * k;
      Real moment[3], force[3];
      ADAGEN_FOR (i, 0, 3) {
        moment[i] = E(0, i) * c[0] + E(1, i) * c[1] + E(2, i) * c[2];
        force[i] = E(0, i) * c[3] + E(1, i) * c[4] + E(2, i) * c[5];
      }
      Real* to = result.data() + 6 * k;
      to[0] = moment[0] + (r[1] * force[2] - r[2] * force[1]);
      to[1] = moment[1] + (r[2] * force[0] - r[0] * force[2]);
      to[2] = moment[2] + (r[0] * force[1] - r[1] * force[0]);
      ADAGEN_FOR (i, 0, 3) to[3 + i] = force[i];
    }
    return result;
  }
};

// Six numbers, such as a column of a 6x6 matrix, in registers of four and two: Eigen takes them by
// twos or one by one.
struct InRegisters {
  Four low;
  Two high;
};
inline InRegisters operator+(const InRegisters& x, const InRegisters& y) {
  return {x.low + y.low, x.high + y.high};
}
inline InRegisters operator-(const InRegisters& x, const InRegisters& y) {
  return {x.low - y.low, x.high - y.high};
}
inline InRegisters operator*(const InRegisters& x, Real s) { return {x.low * s, x.high * s}; }
inline InRegisters six_at(const Real* from) {
  return {from_memory<Four>(from), from_memory<Two>(from + 4)};
}
inline void put_six_at(Real* to, const InRegisters& x) {
  to_memory(x.low, to), to_memory(x.high, to + 4);
}
inline InRegisters column_of(const Mat6& m, int k) { return six_at(m.data() + 6 * k); }
inline void put_column(const InRegisters& x, int k, Mat6& m) { put_six_at(m.data() + 6 * k, x); }
[[maybe_unused]] inline InRegisters row_of(const Mat6& m, int k) {
  const Real* x = m.data() + k;
  return {Four{x[0], x[6], x[12], x[18]}, Two{x[24], x[30]}};
}

// Products and transposes of blocks, so that none is put together from Eigen's expressions.
// What is an expression itself is left to Eigen.
template <class R, int columns>
auto operator*(const Eigen::Matrix<R, 6, 6>& m, const Eigen::Matrix<R, 6, columns>& n)
    -> std::enable_if_t<std::is_same_v<R, Real>, Eigen::Matrix<R, 6, columns>> {
  Eigen::Matrix<R, 6, columns> result;
  for (int k = 0; k < columns; ++k) {
    const Real* x = n.data() + 6 * k;
    InRegisters sum = column_of(m, 0) * x[0];
    ADAGEN_FOR (i, 1, 6) sum = sum + column_of(m, i) * x[i];
    put_six_at(result.data() + 6 * k, sum);
  }
  return result;
}
[[maybe_unused]] inline Mat6 transposed(const Mat6& m) {
  Mat6 result;
  ADAGEN_FOR (k, 0, 6) put_column(row_of(m, k), k, result);
  return result;
}
// s by s^T
[[maybe_unused]] inline Mat6 outer_product(const Vec6& s, Real by) {
  Mat6 result;
  const InRegisters scaled = six_at(s.data()) * by;
  ADAGEN_FOR (k, 0, 6) put_column(scaled * s[k], k, result);
  return result;
}

// m X^T, which is (X m^T)^T: with m = X Phi the congruence X Phi X^T.
ADAGEN_NOINLINE Mat6 from_right(const Mat6& m, const Transform& X) {
  Mat6 result;
  const Vec3& r = X.r;
  const InRegisters x = column_of(m, 0), y = column_of(m, 1), z = column_of(m, 2);
  const InRegisters u = column_of(m, 3) - (z * r[1] - y * r[2]);
  const InRegisters v = column_of(m, 4) - (x * r[2] - z * r[0]);
  const InRegisters w = column_of(m, 5) - (y * r[0] - x * r[1]);
  for (int k = 0; k < 3; ++k) {
    put_column(x * X.E(k, 0) + y * X.E(k, 1) + z * X.E(k, 2), k, result);
    put_column(u * X.E(k, 0) + v * X.E(k, 1) + w * X.E(k, 2), 3 + k, result);
  }
  return result;
}

template <class Matrix>
Matrix times_transposed(const Transform& X, const Matrix& m) {
  return from_right(m, X).transpose();
}

ADAGEN_NOINLINE Mat6 operator*(const Transform& X, const Mat6& m) {
  Mat6 result;
  const Vec3& r = X.r;
  Four E[3];  // columns; the fourth number is not used
  E[0] = from_memory<Four>(X.E.data()), E[1] = from_memory<Four>(X.E.data() + 3);
  E[2] = Four{X.E(0, 2), X.E(1, 2), X.E(2, 2), 0};
  for (int k = 0; k < 6; ++k) {
    const Real* c = m.data() + 6 * k;
    const Real x = c[0], y = c[1], z = c[2];
    const Real u = c[3] - (r[1] * z - r[2] * y), v = c[4] - (r[2] * x - r[0] * z),
               w = c[5] - (r[0] * y - r[1] * x);
    const Four angular = E[0] * x + E[1] * y + E[2] * z;
    const Four linear = E[0] * u + E[1] * v + E[2] * w;
    to_memory(angular, result.data() + 6 * k);
    to_memory(Two{linear[0], linear[1]}, result.data() + 6 * k + 3);
    result(5, k) = linear[2];
  }
  return result;
}

template <int columns>
Eigen::Matrix<Real, 6, columns> operator*(const Transform& X,
                                          const Eigen::Matrix<Real, 6, columns>& m) {
  Eigen::Matrix<Real, 6, columns> result;
  X.times(m, result);
  return result;
}

// Phi = I^-1 of a bare link at its origin, from its upper triangle row by row.
[[maybe_unused]] Mat6 symmetric(const std::array<Real, 21>& upper) {
  Mat6 result;
  std::size_t k = 0;
  for (int i = 0; i < 6; ++i)
    for (int j = i; j < 6; ++j) result(i, j) = result(j, i) = upper[k++];
  return result;
}

// Rotation of a unit quaternion's conjugate: parent coordinates into child coordinates. The
// quaternion (x, y, z, w) is normalised here; its squared length is returned, to be checked.
template <class Matrix>
Real conjugate_rotation(const Number* quaternion, Matrix& E) {
  const Real x = Real(quaternion[0]), y = Real(quaternion[1]);
  const Real z = Real(quaternion[2]), w = Real(quaternion[3]);
  const Real squared = x * x + y * y + z * z + w * w;
  const Real s = 2 / squared;
  E << 1 - s * (y * y + z * z), s * (x * y + z * w), s * (x * z - y * w),  //
      s * (x * y - z * w), 1 - s * (x * x + z * z), s * (y * z + x * w),   //
      s * (x * z + y * w), s * (y * z - x * w), 1 - s * (x * x + y * y);
  return squared;
}

// b of a bare link: its acceleration (relative to free fall) when nothing acts on it.
ADAGEN_NOINLINE void link_bias(const LinkConstants& link, const Vec6& velocity, Columns6& b) {
  const auto turned = [](const Number* m, const Vec3& x) {
    return Vec3(Real(m[0]) * x[0] + Real(m[1]) * x[1] + Real(m[2]) * x[2],
                Real(m[3]) * x[0] + Real(m[4]) * x[1] + Real(m[5]) * x[2],
                Real(m[6]) * x[0] + Real(m[7]) * x[1] + Real(m[8]) * x[2]);
  };
  const Vec3 omega(velocity[0], velocity[1], velocity[2]);
  const Vec3 c(Real(link.com[0]), Real(link.com[1]), Real(link.com[2]));
  const Vec3 alpha = turned(link.tensor_inverse, cross(turned(link.tensor, omega), omega));
  const Vec3 around = cross(omega, c), arm = cross(c, alpha);
  const Vec3 falls =
      cross(omega, Vec3(around[0] + velocity[3], around[1] + velocity[4], around[2] + velocity[5]));
  b.setZero();
  ADAGEN_FOR (k, 0, 3) {
    b(k, 0) = alpha[k];
    b(3 + k, 0) = arm[k] - falls[k];
  }
}

}  // namespace
