// 6x6 blocks: frames, articulated bodies and joins beside plain loops over matrices of any size.
#include <array>
#include <cmath>
#include <utility>
#include <vector>

#include "adagen/articulated.hpp"
#include "adagen/dense.hpp"
#include "adagen/inertia.hpp"
#include "adagen/joins.hpp"
#include "adagen/spatial.hpp"
#include "doctest/doctest.h"
#include "near.hpp"

namespace {

// A matrix of any size, by the schoolbook.
struct Whole {
  int rows, columns;
  std::vector<double> entry;

  Whole(int r, int c) : rows(r), columns(c), entry(static_cast<std::size_t>(r * c)) {}
  template <class T, int r, int c>
  Whole(const Dense<T, r, c>& m) : Whole(r, c) {
    for (int i = 0; i < r; ++i)
      for (int k = 0; k < c; ++k) (*this)(i, k) = m(i, k);
  }
  double& operator()(int i, int k) { return entry[static_cast<std::size_t>(i * columns + k)]; }
  double operator()(int i, int k) const { return entry[static_cast<std::size_t>(i * columns + k)]; }
};

template <class Entry>
Whole made(int rows, int columns, Entry entry) {
  Whole m(rows, columns);
  for (int i = 0; i < rows; ++i)
    for (int k = 0; k < columns; ++k) m(i, k) = entry(i, k);
  return m;
}

Whole operator+(const Whole& a, const Whole& b) {
  return made(a.rows, a.columns, [&](int i, int k) { return a(i, k) + b(i, k); });
}
Whole operator-(const Whole& a, const Whole& b) {
  return made(a.rows, a.columns, [&](int i, int k) { return a(i, k) - b(i, k); });
}
Whole operator*(const Whole& a, const Whole& b) {
  return made(a.rows, b.columns, [&](int i, int k) {
    double sum = 0;
    for (int l = 0; l < a.columns; ++l) sum += a(i, l) * b(l, k);
    return sum;
  });
}
Whole transposed(const Whole& a) {
  return made(a.columns, a.rows, [&](int i, int k) { return a(k, i); });
}
Whole identity(int n) {
  return made(n, n, [](int i, int k) { return double(i == k); });
}
double size(const Whole& a) {
  double sum = 0;
  for (const double x : a.entry) sum += x * x;
  return std::sqrt(sum);
}

// Gauss and Jordan's elimination, with pivots from the column.
Whole inverse(Whole a) {
  Whole b = identity(a.rows);
  for (int c = 0; c < a.rows; ++c) {
    int most = c;
    for (int i = c; i < a.rows; ++i)
      if (std::abs(a(i, c)) > std::abs(a(most, c))) most = i;
    for (int k = 0; k < a.rows; ++k) std::swap(a(c, k), a(most, k)), std::swap(b(c, k), b(most, k));
    const double pivot = a(c, c);
    for (int k = 0; k < a.rows; ++k) a(c, k) /= pivot, b(c, k) /= pivot;
    for (int i = 0; i < a.rows; ++i) {
      const double factor = i == c ? 0 : a(i, c);
      for (int k = 0; k < a.rows; ++k) a(i, k) -= factor * a(c, k), b(i, k) -= factor * b(c, k);
    }
  }
  return b;
}

Mat3 skew(const Vec3& r) { return {0, -r[2], r[1], r[2], 0, -r[0], -r[1], r[0], 0}; }

// A frame that is turned about an axis (Rodrigues) and moved.
Transform frame() {
  Vec3 axis(1, -2, 0.5);
  axis *= 1 / axis.norm();
  const Mat3 K = skew(axis);
  return {Mat3::Identity() + std::sin(0.7) * K + (1 - std::cos(0.7)) * (K * K),
          Vec3(0.3, -0.2, 0.5)};
}

// X = [[E, 0], [-E rx, E]], entry by entry.
Whole matrix(const Transform& X) {
  const Whole across = Whole(X.E) * skew(X.r);
  return made(6, 6, [&](int i, int k) {
    if (i / 3 == k / 3) return X.E(i % 3, k % 3);
    return i < 3 ? 0 : -across(i - 3, k);
  });
}

Mat6 matrix(const Inertia& m) {
  Mat6 result;
  for (int i = 0; i < 6; ++i)
    for (int k = 0; k < 6; ++k) result(i, k) = m(i, k);
  return result;
}

// A link of 3 kg that is no ball.
const LinkConstants& link() {
  static const LinkConstants constants{
      "link", 3, {0.1, -0.2, 0.3}, {2, 0.1, 0.2, 0.1, 3, -0.3, 0.2, -0.3, 1.5}, {}};
  return constants;
}

Vec6 some(double seed) {
  Vec6 x;
  for (int k = 0; k < 6; ++k) x[k] = std::sin(seed + 1.7 * k);
  return x;
}

// Selects the rows of a joint.
template <class Rows>
Whole rows() {
  Whole S(6, Rows::count);
  for (int k = 0; k < Rows::count; ++k) S(Rows::row[static_cast<std::size_t>(k)], k) = 1;
  return S;
}

constexpr double kClose = 1e-13;

}  // namespace

TEST_CASE("matrices of fixed size do as the schoolbook says") {
  Dense<double, 6, 4> a;
  Dense<double, 4, 6> b;
  for (int k = 0; k < 24; ++k) a[k] = std::sin(1 + k), b[k] = std::cos(2 * k);
  CHECK(size(Whole(a * b) - Whole(a) * Whole(b)) < kClose);
  CHECK(size(Whole(a.transpose()) - transposed(a)) == 0);
  CHECK(size(Whole(2 * a - b.transpose()) - (Whole(a) + Whole(a) - transposed(b))) == 0);
  const Dense<double, 6, 4> given = a;
  a.row(1) -= 0.5 * a.row(3);
  a.col(2) = a.col(0) + a.col(3);
  a.block<2, 2>(4, 0) = Dense<double, 2, 2>(1, 2, 3, 4);
  CHECK(size(Whole(a) - made(6, 4, [&given](int i, int k) {
               if (i >= 4 && k < 2) return 1.0 + 2 * (i - 4) + k;
               const auto lessened = [&given, i](int c) {
                 return i == 1 ? given(1, c) - 0.5 * given(3, c) : given(i, c);
               };
               return k == 2 ? lessened(0) + lessened(3) : lessened(k);
             })) == 0);
  CHECK(size(Whole(given.block<3, 2>(1, 2)) -
             made(3, 2, [&given](int i, int k) { return given(i + 1, k + 2); })) == 0);
  const double numbers[] = {1, 2, 3, 4, 5, 6};
  CHECK(Dense<double, 2, 3>::of_rows(numbers)(1, 0) == 4);
  CHECK(Dense<double, 2, 3>::of(numbers)(1, 0) == 2);
  Vec6 x;
  for (int k = 0; k < 6; ++k) x[k] = k - 2.5;
  x.tail<3>() *= 2;
  x.head<2>() = x.tail<2>();
  CHECK((x[0] == 3 && x[1] == 5 && x[2] == -0.5 && x[5] == 5));
  const Vec3 left = x.head<3>(), right = x.tail<3>();
  CHECK(size(Whole(left.cross(right)) - Whole(skew(left)) * right) < kClose);
  CHECK(near(left.dot(right), (transposed(left) * right)(0, 0)));
  const Mat6 m = a * b + Mat6::Identity();
  CHECK(size(Whole(m) * solve(m, x) - x) < 100 * kClose);
}

TEST_CASE("frames are matrices of motions") {
  const Transform X = frame();
  const Mat6 other = some(1) * some(2).transpose() + Mat6::Identity();
  const Whole m = matrix(X), back = inverse(m), whole = other;
  CHECK(size(Whole(X * some(3)) - m * some(3)) < kClose);
  CHECK(size(Whole(X * other) - m * whole) < kClose);
  CHECK(size(Whole(from_right(other, X)) - whole * transposed(m)) < kClose);
  const Columns6 f = some(4);
  CHECK(size(Whole(X.transposed_times(f)) - transposed(m) * f) < kClose);
  CHECK(size(Whole(wrench_in_child(X, f)) - transposed(back) * f) < kClose);
  CHECK(size(Whole(motion_in_parent(X, some(5))) - back * some(5)) < kClose);
}

TEST_CASE("a link's inertia is that of its mass at its centre") {
  const Whole I = matrix(spatial_inertia(link()));
  const Whole c = skew(Vec3(0.1, -0.2, 0.3)), shifted = c * c;
  for (int i = 0; i < 3; ++i)
    for (int k = 0; k < 3; ++k) {
      CHECK(near(I(i, k), link().tensor[3 * i + k] - 3 * shifted(i, k)));
      CHECK(near(I(i, 3 + k), 3 * c(i, k)));
    }
  CHECK(size(I - transposed(I)) == 0);
}

TEST_CASE("inertias go from frame to frame by congruence, there and back") {
  const Transform X = frame();
  const Inertia I = spatial_inertia(link());
  Inertia in_parent{};
  add_in_parent(X, I, in_parent);
  const Whole m = matrix(X), back = inverse(m);
  CHECK(size(matrix(in_parent) - transposed(m) * matrix(I) * m) < 10 * kClose);
  CHECK(size(Whole(matrix(in_child(X, in_parent))) - matrix(I)) < 10 * kClose);
  const Whole Phi = inverse(matrix(I));
  const Mat6 given = Mat6::of_rows(Phi.entry.data());
  CHECK(size(congruent_in_parent(X, given) - back * Phi * transposed(back)) < 10 * kClose);
}

TEST_CASE("a free link accelerates as Newton and Euler say") {
  const Vec6 v = some(6);
  const Vec3 w = v.head<3>(), c(0.1, -0.2, 0.3);
  LinkConstants constants = link();
  const Mat3 I = Mat3::of_rows(constants.tensor);
  const Whole of_tensor = inverse(I);
  for (int k = 0; k < 9; ++k) constants.tensor_inverse[k] = of_tensor(k / 3, k % 3);
  Columns6 b;
  link_bias(constants, v, b);
  const Vec3 alpha = Vec6(b.col(0)).head<3>(), a = Vec6(b.col(0)).tail<3>();
  CHECK((I * alpha + w.cross(I * w)).norm() < kClose);
  // The centre of mass is not accelerated: that of the origin is a + w x v.
  const Vec3 at_com = a + w.cross(v.tail<3>()) + alpha.cross(c) + w.cross(w.cross(c));
  CHECK(at_com.norm() < kClose);

  // The same from its inertia and bias force.
  Inertia IA;
  Columns6 pA, found;
  start_link(spatial_inertia(constants), v, IA, pA);
  CHECK(solve_root(IA, pA, found));
  CHECK((found - b).norm() < 10 * kClose);
  Mat6 Phi;
  CHECK(invert(IA, pA, Phi, found));
  CHECK((found - b).norm() < 10 * kClose);
  CHECK((Phi * matrix(IA) - Mat6::Identity()).norm() < 10 * kClose);
}

TEST_CASE_TEMPLATE("an articulated body is the Schur complement of its joint", Kind, Revolute,
                   Prismatic, Spherical, Planar) {
  const Inertia I = spatial_inertia(link());
  const Columns6 p = some(7), c = some(8);
  Articulated<Kind> joint;
  joint.c = c;
  constexpr int n = kFree<Kind>;
  Whole tau(n, 1);
  for (int k = 0; k < n; ++k) tau(k, 0) = joint.tau[static_cast<std::size_t>(k)][0] = 0.5 + k;
  Inertia passed{};
  Columns6 force;
  REQUIRE(articulate(joint, 1.0, I, p, passed, force));
  const Whole S = rows<typename Kind::Free>(), along = transposed(S), M = matrix(I);
  const Whole U = M * S, solved = inverse(along * U);
  const Whole Ia = M - U * solved * transposed(U);
  CHECK(size(matrix(passed) - Ia) < 10 * kClose);
  const Whole due = Whole(p) + Ia * c + U * solved * (tau - along * p);
  CHECK(size(force - due) < 10 * kClose);
  // Joint accelerations, and that of the far link.
  const Columns6 near_side = some(9);
  Columns6 a = near_side;
  const auto qdd = accelerate(joint, a);
  const Whole expected = solved * (tau - along * p - transposed(U) * (near_side + c));
  for (int k = 0; k < n; ++k) CHECK(near(qdd[static_cast<std::size_t>(k)][0], expected(k, 0), 400));
  CHECK(size(Whole(a) - (Whole(near_side + c) + S * expected)) < 10 * kClose);
}

TEST_CASE_TEMPLATE("two bodies that are joined move as the dense equations say", Kind, Revolute,
                   Prismatic, Spherical, Planar, Floating) {
  // Bodies A (far) and B with mobilities Phi and accelerations b of their own; a force f at the
  // joint moves them by Phi_A f and -Phi_B f.
  const Whole Phi = inverse(matrix(spatial_inertia(link())));
  const Mat6 Phi_A = Mat6::of_rows(Phi.entry.data()), Phi_B = 2 * Phi_A;
  const Columns6 b_A = some(10), b_B = some(11), c = some(12);
  Joined<Kind> joint;
  constexpr int n = kFree<Kind>, m = kConstrained<Kind>;
  Whole tau(n, 1);
  for (int k = 0; k < n; ++k) tau(k, 0) = joint.tau[static_cast<std::size_t>(k)][0] = 0.25 * k - 1;
  REQUIRE(join(joint, Phi_A, Phi_B, b_A, b_B, c));
  Release<Kind> release(joint);
  const Columns6 f = release.force();
  // What the joint transmits holds its constrained rows: N (b + Phi f) = 0 with f = N n - S tau ...
  const Whole along = transposed(rows<typename Kind::Free>());
  CHECK(size(along * f - tau) < kClose);
  // ... so that across it both sides move apart along its freedoms alone.
  const Whole across = Whole(b_A - b_B + c) - Whole(Phi_A + Phi_B) * f;
  if (m > 0) CHECK(size(transposed(rows<typename Kind::Constrained>()) * across) < 100 * kClose);
  for (int k = 0; k < n; ++k)
    CHECK(near(release.qdd()[static_cast<std::size_t>(k)][0], -(along * across)(k, 0), 1000));
}

TEST_CASE("what is not positive definite is not factorized") {
  std::array<std::array<Real, 2>, 2> L{{{4, 0}, {2, 1}}};  // [[4, 2], [2, 1]] is singular
  CHECK(!factorize(L));
  L = {{{4, 0}, {2, 2}}};
  CHECK(factorize(L));
  std::array<std::array<Real, 1>, 2> x{{{8}, {6}}};
  forward_substitute(L, x), backward_substitute(L, x);
  CHECK(near(4 * x[0][0] + 2 * x[1][0], 8));
  CHECK(near(2 * x[0][0] + 2 * x[1][0], 6));
}
