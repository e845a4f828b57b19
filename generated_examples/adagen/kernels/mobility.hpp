// adagen's runtime, the same for all robots.
#pragma once
#if !defined(ADAGEN_SOLVER)
#define ADAGEN_SAMPLE_CUTS  // read alone, it is of a solver whose processes meet, and that refines
#endif

#include <array>
#include <cmath>
#include <cstddef>
#include <cstring>
#include <limits>
#include <utility>

#include "../common.hpp"
#include "../constants.hpp"
#include "../sample/inertias.hpp"
#include "../sample/robot.hpp"
#include "../sizes.hpp"
#include "../spatial.hpp"
#include "../status.hpp"
#include "../value.hpp"
#include "accelerate.hpp"
#include "algebra.hpp"
#include "factors.hpp"
#include "guards.hpp"
#include "inward.hpp"
#include "lanes.hpp"
#include "loop_settings.hpp"
#include "memory.hpp"
#include "spherical.hpp"
#include "turned.hpp"

namespace {

// Nothing on the ground moves beyond its Frame, and the ground does not yield.
const Mat6 kZero = Mat6::Zero();
const Columns6 kGround = Columns6::Zero();

// Mobility: what a segment shows at its handles, and what forces there do inside it. Phi and b are
// about the handles' origins, in the axes that their bodies are expressed in (turned.hpp), and so
// are forces at handles; b are accelerations beyond those of a Frame.
template <class M>
ADAGEN_INLINE M block_of(const Real (&numbers)[M::SizeAtCompileTime]) {  // column by column
  M result;
  std::memcpy(result.data(), numbers, sizeof numbers);
  return result;
}
[[maybe_unused]] inline Mat3 mat3_of(const Matrix<Value>& R) {
  return block_of<Mat3>({R.x.x, R.y.x, R.z.x, R.x.y, R.y.y, R.z.y, R.x.z, R.y.z, R.z.z});
}
inline Mat3 transposed_of(const Matrix<Value>& R) {
  return block_of<Mat3>({R.x.x, R.x.y, R.x.z, R.y.x, R.y.y, R.y.z, R.z.x, R.z.y, R.z.z});
}
template <class M>
M rotated(const Mat3& R, const M& m) {
  M result;
  for (int k = 0; k < M::ColsAtCompileTime; ++k) {
    const Real* x = m.data() + 6 * k;
    Real* to = result.data() + 6 * k;
    ADAGEN_FOR (i, 0, 3) {
      to[i] = R(i, 0) * x[0] + R(i, 1) * x[1] + R(i, 2) * x[2];
      to[3 + i] = R(i, 0) * x[3] + R(i, 1) * x[4] + R(i, 2) * x[5];
    }
  }
  return result;
}
// Columns at a link from the axes that they are expressed in there to those of the base, and back.
template <class M>
M in_base(Workspace& w, int link, const M& m) {
  return turned_link(link) ? rotated(mat3_of(matrix_at(w.of(link - 1, kAxes))), m) : m;
}
template <class M>
M as_told(Workspace& w, int link, const M& m) {
  return turned_link(link) ? rotated(transposed_of(matrix_at(w.of(link - 1, kAxes))), m) : m;
}
[[maybe_unused]] inline Mat6 mobility_as_told(Workspace& w, int link, const Mat6& Phi) {
  if (!turned_link(link)) return Phi;
  const Mat6 half = as_told(w, link, Phi);
  return as_told(w, link, transposed(half));
}

ADAGEN_INLINE Motion<Value> motion_of(const Columns6& a) {
  return {{a[0], a[1], a[2]}, {a[3], a[4], a[5]}};
}
ADAGEN_INLINE Columns6 columns_of(const Motion<Value>& a) {
  return block_of<Columns6>(
      {a.angular.x, a.angular.y, a.angular.z, a.linear.x, a.linear.y, a.linear.z});
}

inline Mat6 inertia_of(const Body<Value>& X) {
  return block_of<Mat6>({X.A.xx,  X.A.xy,  X.A.xz,  X.B.x.x, X.B.x.y, X.B.x.z,  //
                         X.A.xy,  X.A.yy,  X.A.yz,  X.B.y.x, X.B.y.y, X.B.y.z,  //
                         X.A.xz,  X.A.yz,  X.A.zz,  X.B.z.x, X.B.z.y, X.B.z.z,  //
                         X.B.x.x, X.B.y.x, X.B.z.x, X.C.xx,  X.C.xy,  X.C.xz,   //
                         X.B.x.y, X.B.y.y, X.B.z.y, X.C.xy,  X.C.yy,  X.C.yz,   //
                         X.B.x.z, X.B.y.z, X.B.z.z, X.C.xz,  X.C.yz,  X.C.zz});
}
[[maybe_unused]] inline Columns6 force_of(const Body<Value>& X) { return columns_of({X.n, X.f}); }
[[maybe_unused]] inline Columns6 opposite_of(const Body<Value>& X) {
  return columns_of({-X.n, -X.f});
}

// The inverse of a symmetric matrix of six rows, and as symmetric: L^-T D^-1 L^-1, L^-1 by
// elimination of all six unit vectors at once. Where masses differ much, subtracting on the way
// back instead would cost digits. Whether each pivot exceeds what it must at least.
ADAGEN_INLINE bool invert(const Mat6& m, const Real (&least)[6], Mat6& inverse) {
  Lanes rows[6]{}, X[6]{};
  Real over[6];
  bool good = true;
  ADAGEN_FOR (i, 0, 6) {
    rows[i] = from_memory<Lanes, 6 * sizeof(Real)>(m.data() + 6 * i);
    X[i][i] = 1;
  }
  ADAGEN_FOR (c, 0, 6) {
    const Real pivot = rows[c][c];
    good = good && pivot > least[c] && pivot <= std::numeric_limits<Real>::max();
    over[c] = 1 / pivot;
    ADAGEN_FOR (i, c + 1, 6) {
      const Real l = rows[i][c] * over[c];
      rows[i] -= rows[c] * l;
      X[i] -= X[c] * l;
    }
  }
  ADAGEN_FOR (i, 0, 6) {
    Lanes sum{};
    ADAGEN_FOR (k, i, 6) sum += X[k] * (X[k][i] * over[k]);
    first_to_memory<6 * sizeof(Real)>(sum, inverse.data() + 6 * i);
  }
  ADAGEN_FOR (i, 0, 6)
    ADAGEN_FOR (k, 0, i) inverse(k, i) = inverse(i, k);
  return good;
}

// Phi = (I^A)^-1 and b = -Phi p^A of a segment's root.
[[maybe_unused]] inline bool invert(const Body<Value>& X, Mat6& Phi, Columns6& b) {
  constexpr Real kRounding = 8 * std::numeric_limits<Real>::epsilon();
  const Mat6 I = inertia_of(X);
  Real least[6];
  ADAGEN_FOR (k, 0, 6) least[k] = kRounding * I(k, k);
  const bool good = invert(I, least, Phi);
  b = Phi * opposite_of(X);
  return good;
}

template <int p, int link>
void invert_root(Workspace& w, Mat6& Phi, Columns6& b) {
  Body<Value> X{};
  meet<p>(w, link, X);
  if (!invert(X, Phi, b)) fail(w, kFactorization, link - 1);
}

// b = -Phi p of a bare link.
template <int link>
void bare_link(Workspace& w, const Mat6& Phi, Columns6& b) {
  static_assert(turned_link(link));
  Body<Value> X{};
  add_own_link(w, single(link - 1), X);
  b = Phi * opposite_of(X);
}

// A planar joint's freedoms one after the other, the last one to be eliminated first, at its
// origin.
ADAGEN_INLINE void slide_and_turn(Workspace& w, int j, Motion<Lanes>& a,
                                  const Vector<Lanes>& drive) {
  const Value* const e = w.joints[static_cast<std::size_t>(j)].e;
  const Matrix<Value> R = matrix_at(w.of(j, kAxes));
  const auto moved = [&a](const Value* of, const Lanes& driven) {
    return driven -
           ((of[0] * a.angular.x + of[1] * a.angular.y) +
            (of[2] * a.angular.z + of[3] * a.linear.x) + (of[4] * a.linear.y + of[5] * a.linear.z));
  };
  const auto along = [](const Value& x, const Value& y, const Value& z, const Lanes& by) {
    return Vector<Lanes>{x * by, y * by, z * by};
  };
  a.angular += along(R.x.z, R.y.z, R.z.z, moved(e + 16, drive.z));
  a.linear += along(R.x.y, R.y.y, R.z.y, moved(e + 8, drive.y));
  a.linear += along(R.x.x, R.y.x, R.z.x, moved(e, drive.x));
}

// Motions of a link, side by side: what the far link does, with what drives the joint beyond L a
// (of a joint with one freedom x).
template <bool reversed>
ADAGEN_INLINE void pass(Workspace& w, int j, Motion<Lanes>& a,
                        const Vector<Lanes>& drive = Vector<Lanes>{}) {
  const JointKind kind = kJoints[static_cast<std::size_t>(j)].kind;
  const Memory& memory = w.joints[static_cast<std::size_t>(j)];
  const Value* const e = memory.e;
  const Vector<Value> axis = axis_at(w.of(j, kAxes));
  if (kind == JointKind::kSpherical) {
    if constexpr (kAnySpherical) {
      if constexpr (!reversed) carry(a, memory.r);
      const Vector<Lanes> v = a.linear, spin = a.angular;
      a.angular = {drive.x - (e[0] * v.x + e[1] * v.y + e[2] * v.z),
                   drive.y - (e[3] * v.x + e[4] * v.y + e[5] * v.z),
                   drive.z - (e[6] * v.x + e[7] * v.y + e[8] * v.z)};
      if constexpr (kSphericalRotors) a.angular += solved(e + 12, spin) * rotor_of(single(j));
      if constexpr (reversed) carry(a, -memory.r);
    }
    return;
  }
  if (kind == JointKind::kPlanar) {
    if constexpr (kAnyPlanar) {
      if constexpr (!reversed) carry(a, memory.r);
      slide_and_turn(w, j, a, drive);
      if constexpr (reversed) carry(a, -memory.r);
    }
    return;
  }
  if (kind == JointKind::kFloating) {  // the far link moves as if there were no near one
    a = Motion<Lanes>{};
    return;
  }
  const Lanes x = drive.x - ((e[0] * a.angular.x + e[1] * a.angular.y) +
                             (e[2] * a.angular.z + e[3] * a.linear.x) +
                             (e[4] * a.linear.y + e[5] * a.linear.z));
  const Vector<Lanes> moved{axis.x * x, axis.y * x, axis.z * x};
  if constexpr (!reversed) carry(a, memory.r);
  if (kind == JointKind::kPrismatic)
    a.linear += moved;
  else
    a.angular += moved;
  if constexpr (reversed) carry(a, -memory.r);
}

ADAGEN_INLINE Motion<Lanes> rows_of(const Mat6& transposed) {
  const auto row = [&transposed](int k) {
    return from_memory<Lanes, 6 * sizeof(Real)>(transposed.data() + 6 * k);
  };
  return {{row(0), row(1), row(2)}, {row(3), row(4), row(5)}};
}
ADAGEN_INLINE Mat6 from_rows(const Motion<Lanes>& a) {  // transposed
  Mat6 result;
  const Lanes* rows[6] = {&a.angular.x, &a.angular.y, &a.angular.z,
                          &a.linear.x,  &a.linear.y,  &a.linear.z};
  for (int k = 0; k < 6; ++k) first_to_memory<6 * sizeof(Real)>(*rows[k], result.data() + 6 * k);
  return result;
}

template <bool reversed>
ADAGEN_INLINE constexpr int near_link(int j) {
  return reversed ? j + 1 : kJoints[static_cast<std::size_t>(j)].parent;
}

// L m, where the rows of m belong to the near link.
template <bool reversed>
Mat6 passed(Workspace& w, int j, const Mat6& m) {
  const Mat6 near = in_base(w, near_link<reversed>(j), m);
  Motion<Lanes> rows = rows_of(transposed(near));
  pass<reversed>(w, j, rows);
  const Mat6 far = transposed(from_rows(rows));
  return as_told(w, near_link<!reversed>(j), far);
}

// What joints with several freedoms do at the child link's origin is expressed at the far link's.
template <bool reversed>
Mat6 at_far_link(Workspace& w, int j, const Mat6& Phi) {
  if constexpr (!reversed) return mobility_as_told(w, j + 1, Phi);
  const Vector<Value> r = -w.joints[static_cast<std::size_t>(j)].r;
  Mat6 shifted = Mat6::Identity();  // linear += angular x r
  shifted(3, 1) = r.z, shifted(3, 2) = -r.y, shifted(4, 0) = -r.z;
  shifted(4, 2) = r.x, shifted(5, 0) = r.y, shifted(5, 1) = -r.x;
  return mobility_as_told(w, near_link<false>(j), shifted * Phi * transposed(shifted));
}

// S D^-1 S^T at the far link's origin.
template <bool reversed>
Mat6 own_mobility(Workspace& w, int j) {
  const JointKind kind = kJoints[static_cast<std::size_t>(j)].kind;
  const Memory& memory = w.joints[static_cast<std::size_t>(j)];
  Mat6 result = Mat6::Zero();
  if (kind == JointKind::kPlanar) {
    if constexpr (kAnyPlanar) {
      Motion<Lanes> a{};
      Vector<Lanes> unit{};
      unit.x[0] = 1, unit.y[1] = 1, unit.z[2] = 1;
      slide_and_turn(w, j, a, unit);
      const Mat6 moved = from_rows(a);  // transposed: what a freedom does is a column of lanes
      for (int k = 0; k < 3; ++k) {
        Vec6 s;
        put_six_at(s.data(), row_of(moved, k));
        result += outer_product(s, memory.e[8 * k + 7]);
      }
    }
    return at_far_link<reversed>(w, j, result);
  }
  if (kind == JointKind::kFloating) {
    if constexpr (kPassesFree) {
      Columns6 still;
      if (!invert(w.free[static_cast<std::size_t>(j)], result, still)) fail(w, kFactorization, j);
    }
    return at_far_link<reversed>(w, j, result);
  }
  if (kind == JointKind::kSpherical) {
    if constexpr (kAnySpherical) {
      for (int k = 0; k < 3; ++k) {
        const Vector<Value> unit{Value(k == 0), Value(k == 1), Value(k == 2)};
        const Vector<Value> x = solved(memory.e + 12, unit);
        result(0, k) = x.x, result(1, k) = x.y, result(2, k) = x.z;
      }
    }
    return at_far_link<reversed>(w, j, result);
  }
  Motion<Value> S{};
  Vector<Value>& along = kind == JointKind::kPrismatic ? S.linear : S.angular;
  if (!reversed && turned(j)) {
    along.z = 1;
  } else {
    along = axis_at(w.of(j, kAxes));
    if constexpr (reversed) carry(S, -memory.r);
  }
  const Columns6 s = reversed ? as_told(w, near_link<false>(j), columns_of(S)) : columns_of(S);
  return outer_product(s, memory.e[7]);
}

// Omega and b outwards across a joint: L Omega L^T + S D^-1 S^T. Nothing is subtracted.
template <bool reversed>
void propagate(Workspace& w, int j, const Mat6& near, const Columns6& near_bias, Mat6& far,
               Columns6& far_bias) {
  const Mat6 half = passed<reversed>(w, j, near);
  far = passed<reversed>(w, j, transposed(half)) + own_mobility<reversed>(w, j);
  Motion<Value> a = motion_of(in_base(w, near_link<reversed>(j), near_bias));
  move<reversed>(w, single(j), kJoints[static_cast<std::size_t>(j)].kind, a);
  far_bias = as_told(w, near_link<!reversed>(j), columns_of(a));
}

// x of M x = b by elimination, the largest number of each column being its pivot.
[[maybe_unused]] inline Columns6 solved(Mat6 M, Columns6 b) {
  Real* const x = b.data();
  for (int k = 0; k < 6; ++k) {
    int pivot = k;
    for (int i = k + 1; i < 6; ++i)
      if (std::abs(M(i, k)) > std::abs(M(pivot, k))) pivot = i;
    for (int c = k; c < 6; ++c) std::swap(M(k, c), M(pivot, c));
    std::swap(x[k], x[pivot]);
    for (int i = k + 1; i < 6; ++i) {
      const Real l = M(i, k) / M(k, k);
      for (int c = k + 1; c < 6; ++c) M(i, c) -= l * M(k, c);
      x[i] -= l * x[k];
    }
  }
  for (int k = 5; k >= 0; --k) {
    x[k] /= M(k, k);
    for (int i = 0; i < k; ++i) x[i] -= M(i, k) * x[k];
  }
  return b;
}

// A link whose other side shows Phi and b: (1 + Phi I^A) a = b - Phi p^A.
template <int link>
void solve_mobility(Workspace& w, const Mat6& Phi, const Columns6& b) {
  const Body<Value>& X = w.bodies[link];
  Mat6 M = Phi * inertia_of(X);
  ADAGEN_FOR (k, 0, 6) M(k, k) += 1;
  const Columns6 a = solved(M, b + Phi * opposite_of(X));
  w.motions[link] = motion_of(in_base(w, link, a));
}

// A root's acceleration under the forces at handles.
template <int link>
void accelerate_root(Workspace& w, const Mat6& Phi, const Columns6& b) {
  const Columns6 a = b + Phi * as_told(w, link, w.loads[link]);
  w.motions[link] = motion_of(in_base(w, link, a));
}

// The force that what was left at a link needs to move as the link does.
template <int link>
Columns6 force_on(Workspace& w) {
  Body<Value> X = w.bodies[link];
  to_base(w, link, X);
  return inertia_of(X) * columns_of(w.motions[link]) + force_of(X);
}

// --- joins: adapters to the joints' own frames ---------------------------------------------------

// From what is expressed about the parent's (X) and the child link's origin (Y) to the joint's
// frame.
[[maybe_unused]] inline void set_transforms(Workspace& w, int j, Transform& X, Transform& Y) {
  const int parent = kJoints[static_cast<std::size_t>(j)].parent;
  const Mat3 back = transposed_of(matrix_at(w.of(j, kAxes)));
  Vector<Value> r = w.joints[static_cast<std::size_t>(j)].r;
  X.E = back;
  if (turned_link(parent)) {
    X.E = transposed_of(matrix_at(w.of(j, kTurn)));
    const JointKind kind = kJoints[static_cast<std::size_t>(j)].kind;
    if (kind == JointKind::kRevolute || kind == JointKind::kSpherical)
      r = origin_of(single(j));
    else
      r = transposed(matrix_at(w.of(parent - 1, kAxes))) * r;
  }
  X.r = Vec3(r.x, r.y, r.z);
  Y.E = turned_link(j + 1) ? Mat3(Mat3::Identity()) : back;
  Y.r.setZero();
}

// The torques of a joint that reach the links, or its prescribed accelerations.
template <std::size_t n>
void load_torque(Workspace& w, int j, int, std::array<std::array<Real, kColumns>, n>& tau) {
  const JointConstants& joint = kJoints[static_cast<std::size_t>(j)];
  for (std::size_t k = 0; k < n; ++k) {
    const int entry = static_cast<int>(k);
    tau[k][0] = joint.passive.prescribed ? w.tau[joint.v + entry] : torque(w, joint, entry);
  }
}

template <std::size_t n>
void store_acceleration(Workspace& w, int, int v,
                        const std::array<std::array<Real, kColumns>, n>& qdd) {
  for (std::size_t k = 0; k < n; ++k) w.answer[static_cast<std::size_t>(v) + k] = qdd[k][0];
}

}  // namespace
