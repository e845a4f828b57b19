// adagen's runtime, the same for all robots.
#pragma once

#include "lanes.hpp"

namespace {

// Vectors, matrices and spatial inertias in axes that all links of a base share. T is what is
// computed with: one number, or one for each of several states or links.
template <class T>
struct Vector {
  T x, y, z;
};

template <class T>
struct Matrix {
  Vector<T> x, y, z;  // rows
};

template <class T>
struct Symmetric {
  T xx, xy, xz, yy, yz, zz;
};

template <class T>
ADAGEN_INLINE Vector<T> operator+(const Vector<T>& a, const Vector<T>& b) {
  return {a.x + b.x, a.y + b.y, a.z + b.z};
}
template <class T>
ADAGEN_INLINE Vector<T> operator-(const Vector<T>& a, const Vector<T>& b) {
  return {a.x - b.x, a.y - b.y, a.z - b.z};
}
template <class T>
ADAGEN_INLINE Vector<T> operator-(const Vector<T>& a) {
  return {-a.x, -a.y, -a.z};
}
template <class T, class S>
ADAGEN_INLINE Vector<T> operator*(const Vector<T>& a, const S& s) {
  return {a.x * s, a.y * s, a.z * s};
}
template <class T>
ADAGEN_INLINE void operator+=(Vector<T>& a, const Vector<T>& b) {
  a.x += b.x, a.y += b.y, a.z += b.z;
}
template <class T, class S>
ADAGEN_INLINE T dot(const Vector<T>& a, const Vector<S>& b) {
  return a.x * b.x + (a.y * b.y + a.z * b.z);
}
template <class T, class S>
ADAGEN_INLINE Vector<T> cross(const Vector<T>& a, const Vector<S>& b) {
  return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}

template <class T, class S>
ADAGEN_INLINE Vector<T> operator*(const Matrix<T>& m, const Vector<S>& a) {
  return {dot(m.x, a), dot(m.y, a), dot(m.z, a)};
}
template <class T>
ADAGEN_INLINE Vector<T> transposed_times(const Matrix<T>& m, const Vector<T>& a) {
  return {m.x.x * a.x + (m.y.x * a.y + m.z.x * a.z), m.x.y * a.x + (m.y.y * a.y + m.z.y * a.z),
          m.x.z * a.x + (m.y.z * a.y + m.z.z * a.z)};
}
template <class T, class S>
ADAGEN_INLINE Vector<T> row_times(const Vector<T>& a, const Matrix<S>& m) {
  return {a.x * m.x.x + (a.y * m.y.x + a.z * m.z.x), a.x * m.x.y + (a.y * m.y.y + a.z * m.z.y),
          a.x * m.x.z + (a.y * m.y.z + a.z * m.z.z)};
}
template <class T, class S>
ADAGEN_INLINE Matrix<T> operator*(const Matrix<T>& a, const Matrix<S>& b) {
  return {row_times(a.x, b), row_times(a.y, b), row_times(a.z, b)};
}
template <class T>
ADAGEN_INLINE Vector<T> operator*(const Symmetric<T>& m, const Vector<T>& a) {
  return {m.xx * a.x + (m.xy * a.y + m.xz * a.z), m.xy * a.x + (m.yy * a.y + m.yz * a.z),
          m.xz * a.x + (m.yz * a.y + m.zz * a.z)};
}
template <class T>
ADAGEN_INLINE void operator+=(Symmetric<T>& a, const Symmetric<T>& b) {
  a.xx += b.xx, a.xy += b.xy, a.xz += b.xz, a.yy += b.yy, a.yz += b.yz, a.zz += b.zz;
}
template <class T>
ADAGEN_INLINE void operator+=(Matrix<T>& a, const Matrix<T>& b) {
  a.x += b.x, a.y += b.y, a.z += b.z;
}

// A body about a point: spatial inertia [[A, B], [B^T, C]] (A rotational, C of mass) and bias force
// [n; f]. It is a link, or a link with all that hangs on it.
template <class T>
struct Body {
  Symmetric<T> A;
  Matrix<T> B;
  Symmetric<T> C;
  Vector<T> n, f;
};

template <class T>
ADAGEN_INLINE void operator+=(Body<T>& a, const Body<T>& b) {
  a.A += b.A, a.B += b.B, a.C += b.C, a.n += b.n, a.f += b.f;
}

// The body expressed about the point at -r from the one that it is expressed about: B + rx C, and
// A + rx B^T - (B + rx C) rx.
template <class T>
ADAGEN_INLINE void shift(Body<T>& X, const Vector<T>& r) {
  const Symmetric<T>& C = X.C;
  const Matrix<T> B{{X.B.x.x + (r.y * C.xz - r.z * C.xy), X.B.x.y + (r.y * C.yz - r.z * C.yy),
                     X.B.x.z + (r.y * C.zz - r.z * C.yz)},
                    {X.B.y.x + (r.z * C.xx - r.x * C.xz), X.B.y.y + (r.z * C.xy - r.x * C.yz),
                     X.B.y.z + (r.z * C.xz - r.x * C.zz)},
                    {X.B.z.x + (r.x * C.xy - r.y * C.xx), X.B.z.y + (r.x * C.yy - r.y * C.xy),
                     X.B.z.z + (r.x * C.yz - r.y * C.xz)}};
  X.A.xx += (r.y * X.B.x.z - r.z * X.B.x.y) - (B.x.y * r.z - B.x.z * r.y);
  X.A.xy += (r.y * X.B.y.z - r.z * X.B.y.y) - (B.x.z * r.x - B.x.x * r.z);
  X.A.xz += (r.y * X.B.z.z - r.z * X.B.z.y) - (B.x.x * r.y - B.x.y * r.x);
  X.A.yy += (r.z * X.B.y.x - r.x * X.B.y.z) - (B.y.z * r.x - B.y.x * r.z);
  X.A.yz += (r.z * X.B.z.x - r.x * X.B.z.z) - (B.y.x * r.y - B.y.y * r.x);
  X.A.zz += (r.x * X.B.z.y - r.y * X.B.z.x) - (B.z.x * r.y - B.z.y * r.x);
  X.B = B;
  X.n += cross(r, X.f);
}

// The same for a body whose A and B are zero, as a point mass's: B = rx C, A = -B rx.
template <class T>
ADAGEN_INLINE void shift_mass(Body<T>& X, const Vector<T>& r) {
  const Symmetric<T>& C = X.C;
  const Vector<T> Cx{C.xx, C.xy, C.xz}, Cy{C.xy, C.yy, C.yz}, Cz{C.xz, C.yz, C.zz};
  X.B = {Cz * r.y - Cy * r.z, Cx * r.z - Cz * r.x, Cy * r.x - Cx * r.y};
  const Vector<T> Ax = cross(r, X.B.x), Ay = cross(r, X.B.y), Az = cross(r, X.B.z);
  X.A = {Ax.x, Ax.y, Ax.z, Ay.y, Ay.z, Az.z};
  X.n += cross(r, X.f);
}

// The inertia less U U^T / D, U = [n; f] and e = U / D.
template <class T>
ADAGEN_INLINE void subtract(Body<T>& X, const Vector<T>& n, const Vector<T>& f,
                            const Vector<T>& e_n, const Vector<T>& e_f) {
  X.A.xx -= e_n.x * n.x, X.A.xy -= e_n.x * n.y, X.A.xz -= e_n.x * n.z;
  X.A.yy -= e_n.y * n.y, X.A.yz -= e_n.y * n.z, X.A.zz -= e_n.z * n.z;
  X.B.x.x -= e_n.x * f.x, X.B.x.y -= e_n.x * f.y, X.B.x.z -= e_n.x * f.z;
  X.B.y.x -= e_n.y * f.x, X.B.y.y -= e_n.y * f.y, X.B.y.z -= e_n.y * f.z;
  X.B.z.x -= e_n.z * f.x, X.B.z.y -= e_n.z * f.y, X.B.z.z -= e_n.z * f.z;
  X.C.xx -= e_f.x * f.x, X.C.xy -= e_f.x * f.y, X.C.xz -= e_f.x * f.z;
  X.C.yy -= e_f.y * f.y, X.C.yz -= e_f.y * f.z, X.C.zz -= e_f.z * f.z;
}

// Where a point moves that is at r from one that moves as [angular; linear].
template <class T>
struct Motion {
  Vector<T> angular, linear;
};

template <class T, class S>
ADAGEN_INLINE void carry(Motion<T>& a, const Vector<S>& r) {
  a.linear += cross(a.angular, r);
}

// The rotation that a quaternion x y z w of any length stands for, and its squared length.
template <class T>
ADAGEN_INLINE T rotation(const T& x, const T& y, const T& z, const T& w, Matrix<T>& R) {
  const T squared = (x * x + y * y) + (z * z + w * w);
  const T s = 2 / squared;
  const T xx = s * x * x, yy = s * y * y, zz = s * z * z, xy = s * x * y, xz = s * x * z,
          yz = s * y * z, xw = s * x * w, yw = s * y * w, zw = s * z * w;
  R = {{1 - (yy + zz), xy - zw, xz + yw},
       {xy + zw, 1 - (xx + zz), yz - xw},
       {xz - yw, yz + xw, 1 - (xx + yy)}};
  return squared;
}

}  // namespace
