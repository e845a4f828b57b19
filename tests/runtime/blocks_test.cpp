// 6x6 blocks: frames, articulated bodies and joins beside dense linear algebra of Eigen's own.
#include <Eigen/Dense>
#include <array>
#include <cmath>

#include "adagen/articulated.hpp"
#include "adagen/inertia.hpp"
#include "adagen/joins.hpp"
#include "adagen/spatial.hpp"
#include "doctest/doctest.h"
#include "near.hpp"

namespace {

using Dense = Eigen::MatrixXd;

// A frame that is turned about an axis and moved.
Transform frame() {
  const Vec3 axis = Vec3(1, -2, 0.5).normalized();
  return {Eigen::AngleAxisd(0.7, axis).toRotationMatrix(), Vec3(0.3, -0.2, 0.5)};
}

Mat3 skew(const Vec3& r) {
  Mat3 m;
  m << 0, -r[2], r[1], r[2], 0, -r[0], -r[1], r[0], 0;
  return m;
}

// X = [[E, 0], [-E rx, E]], entry by entry.
Mat6 matrix(const Transform& X) {
  Mat6 m = Mat6::Zero();
  m.topLeftCorner<3, 3>() = m.bottomRightCorner<3, 3>() = X.E;
  m.bottomLeftCorner<3, 3>() = -X.E * skew(X.r);
  return m;
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
Dense rows() {
  Dense S = Dense::Zero(6, Rows::count);
  for (int k = 0; k < Rows::count; ++k) S(Rows::row[static_cast<std::size_t>(k)], k) = 1;
  return S;
}

constexpr double kClose = 1e-13;

}  // namespace

TEST_CASE("frames are matrices of motions") {
  const Transform X = frame();
  const Mat6 m = matrix(X), other = some(1) * some(2).transpose() + Mat6::Identity();
  CHECK((X * some(3) - m * some(3)).norm() < kClose);
  CHECK((X * other - m * other).norm() < kClose);
  CHECK((from_right(other, X) - other * m.transpose()).norm() < kClose);
  const Columns6 f = some(4);
  CHECK((X.transposed_times(f) - m.transpose() * f).norm() < kClose);
  CHECK((wrench_in_child(X, f) - m.transpose().inverse() * f).norm() < kClose);
  CHECK((motion_in_parent(X, Vec6(some(5))) - m.inverse() * some(5)).norm() < kClose);
}

TEST_CASE("a link's inertia is that of its mass at its centre") {
  const Mat6 I = matrix(spatial_inertia(link()));
  const Mat3 c = skew(Vec3(0.1, -0.2, 0.3));
  Mat3 about_com;
  about_com << 2, 0.1, 0.2, 0.1, 3, -0.3, 0.2, -0.3, 1.5;
  CHECK((I.topLeftCorner<3, 3>() - (about_com - 3 * c * c)).norm() < kClose);
  CHECK((I.topRightCorner<3, 3>() - 3 * c).norm() < kClose);
  CHECK((I - I.transpose()).norm() == 0);
}

TEST_CASE("inertias go from frame to frame by congruence, there and back") {
  const Transform X = frame();
  const Inertia I = spatial_inertia(link());
  Inertia in_parent{};
  add_in_parent(X, I, in_parent);
  const Mat6 m = matrix(X);
  CHECK((matrix(in_parent) - m.transpose() * matrix(I) * m).norm() < 10 * kClose);
  CHECK((matrix(in_child(X, in_parent)) - matrix(I)).norm() < 10 * kClose);
  const Mat6 Phi = matrix(I).inverse();
  CHECK((congruent_in_parent(X, Phi) - m.inverse() * Phi * m.inverse().transpose()).norm() <
        10 * kClose);
}

TEST_CASE("a free link accelerates as Newton and Euler say") {
  const Vec6 v = some(6);
  const Vec3 w = v.head<3>(), c(0.1, -0.2, 0.3);
  LinkConstants constants = link();
  Mat3 I;
  I << 2, 0.1, 0.2, 0.1, 3, -0.3, 0.2, -0.3, 1.5;
  const Mat3 inverse = I.inverse();
  for (int k = 0; k < 9; ++k) constants.tensor_inverse[k] = inverse(k / 3, k % 3);
  Columns6 b;
  link_bias(constants, v, b);
  const Vec3 alpha = b.col(0).head<3>(), a = b.col(0).tail<3>();
  CHECK((I * alpha + w.cross(I * w)).norm() < kClose);
  // The centre of mass is not accelerated: that of the origin is a + w x v.
  const Vec3 at_com = a + w.cross(Vec3(v.tail<3>())) + alpha.cross(c) + w.cross(w.cross(c));
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
  Dense tau(n, 1);
  for (int k = 0; k < n; ++k) tau(k, 0) = joint.tau[static_cast<std::size_t>(k)][0] = 0.5 + k;
  Inertia passed{};
  Columns6 force;
  REQUIRE(articulate(joint, 1.0, I, p, passed, force));
  const Dense S = rows<typename Kind::Free>(), M = matrix(I);
  const Dense D = S.transpose() * M * S, U = M * S, solved = D.inverse();
  const Dense Ia = M - U * solved * U.transpose();
  CHECK((matrix(passed) - Ia).norm() < 10 * kClose);
  const Dense due = p + Ia * c + U * solved * (tau - S.transpose() * p);
  CHECK((force - due).norm() < 10 * kClose);
  // Joint accelerations, and that of the far link.
  const Columns6 near_side = some(9);
  Columns6 a = near_side;
  const auto qdd = accelerate(joint, a);
  const Dense expected = solved * (tau - S.transpose() * p - U.transpose() * Dense(near_side + c));
  for (int k = 0; k < n; ++k) CHECK(near(qdd[static_cast<std::size_t>(k)][0], expected(k, 0), 400));
  CHECK((a - (near_side + c + Columns6(S * expected))).norm() < 10 * kClose);
}

TEST_CASE_TEMPLATE("two bodies that are joined move as the dense equations say", Kind, Revolute,
                   Prismatic, Spherical, Planar, Floating) {
  // Bodies A (far) and B with mobilities Phi and accelerations b of their own; a force f at the
  // joint moves them by Phi_A f and -Phi_B f.
  const Mat6 Phi_A = matrix(spatial_inertia(link())).inverse(), Phi_B = 2 * Phi_A;
  const Columns6 b_A = some(10), b_B = some(11), c = some(12);
  Joined<Kind> joint;
  constexpr int n = kFree<Kind>, m = kConstrained<Kind>;
  Dense tau(n, 1);
  for (int k = 0; k < n; ++k) tau(k, 0) = joint.tau[static_cast<std::size_t>(k)][0] = 0.25 * k - 1;
  REQUIRE(join(joint, Phi_A, Phi_B, b_A, b_B, c));
  Release<Kind> release(joint);
  const Columns6 f = release.force();
  // What the joint transmits holds its constrained rows: N (b + Phi f) = 0 with f = N n - S tau ...
  const Dense S = rows<typename Kind::Free>(), N = rows<typename Kind::Constrained>();
  CHECK((S.transpose() * Dense(f) - tau).norm() < kClose);
  // ... so that across it both sides move apart along its freedoms alone.
  const Dense across = Dense(b_A - b_B + c) - (Phi_A + Phi_B) * Dense(f);
  if (m > 0) CHECK((N.transpose() * across).norm() < 100 * kClose);
  for (int k = 0; k < n; ++k)
    CHECK(
        near(release.qdd()[static_cast<std::size_t>(k)][0], -(S.transpose() * across)(k, 0), 1000));
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
