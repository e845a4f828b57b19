// adagen's runtime, the same for all robots.
#pragma once

#include <limits>

#include "../sizes.hpp"
#include "algebra.hpp"
#include "lanes.hpp"

namespace {

// Symmetric matrices of three rows, eliminated.

// The factors 1 / D and L of A = L D L^T: 0 1 2, 10 20 21. Without fractions (Bareiss) the three
// divisions need not wait for each other: with m = xx yy - xy^2 and so on the pivots are xx, m / xx
// and (m m' - t^2) / (xx m), as exact as alternately while fourth powers of A keep their digits: in
// float they would not. All numbers that checks gets are positive if A could be factorized.
template <class T>
ADAGEN_INLINE void factorize(const Symmetric<T>& A, T* factors, T (&checks)[4]) {
  using Limits = std::numeric_limits<Real>;
  T* const l = factors + 3;
  const T d0 = 1 / A.xx;
  l[0] = A.xy * d0, l[1] = A.xz * d0;
  T p1, p2;
  if constexpr (Limits::min_exponent10 < -300) {
    const T m = A.xx * A.yy - A.xy * A.xy, t = A.xx * A.yz - A.xy * A.xz;
    p1 = m, p2 = m * (A.xx * A.zz - A.xz * A.xz) - t * t;
    const T inverse = 1 / m;
    factors[1] = A.xx * inverse, factors[2] = A.xx * m / p2;
    l[2] = t * inverse;
    checks[2] = p2 - Limits::min() / Limits::epsilon();
  } else {
    const T t = A.yz - l[1] * A.xy;
    p1 = A.yy - l[0] * A.xy;
    factors[1] = 1 / p1, l[2] = t * factors[1];
    p2 = A.zz - l[1] * A.xz - l[2] * t;
    factors[2] = 1 / p2;
    checks[2] = p2;
  }
  factors[0] = d0;
  checks[0] = A.xx, checks[1] = p1, checks[3] = Limits::max() - p2;
}

// A^-1 b, by the factors of A.
template <class F, class T>
ADAGEN_INLINE Vector<T> solved(const F* factors, const Vector<T>& b) {
  const F *d = factors, *l = factors + 3;
  const T y1 = b.y - l[0] * b.x, y2 = b.z - l[1] * b.x - l[2] * y1;
  const T z = y2 * d[2], y = y1 * d[1] - l[2] * z;
  return {b.x * d[0] - l[0] * y - l[1] * z, y, z};
}

// C becomes C - B^T A^-1 B, by the factors of A; returns A^-1 B. With L Y = B what is subtracted is
// Y^T D^-1 Y, which waits for no more than the last division.
template <class T>
ADAGEN_INLINE Matrix<T> complement(Symmetric<T>& C, const Matrix<T>& B, const T* factors) {
  const T *d = factors, *l = factors + 3;
  const Vector<T> Yx = B.x, Yy = B.y - B.x * l[0], Yz = (B.z - B.x * l[1]) - Yy * l[2];
  const Vector<T> Zx = Yx * d[0], Zy = Yy * d[1], Zz = Yz * d[2];
  using V = Vector<T>;
  const auto subtract = [&](T& c, T V::* i, T V::* k) ADAGEN_ALWAYS {
    c = ((c - Yx.*i * Zx.*k) - Yy.*i * Zy.*k) - Yz.*i * Zz.*k;
  };
  subtract(C.xx, &V::x, &V::x), subtract(C.xy, &V::x, &V::y), subtract(C.xz, &V::x, &V::z);
  subtract(C.yy, &V::y, &V::y), subtract(C.yz, &V::y, &V::z), subtract(C.zz, &V::z, &V::z);
  const Vector<T> Ky = Zy - Zz * l[2];
  return {(Zx - Zz * l[1]) - Ky * l[0], Ky, Zz};
}

}  // namespace
