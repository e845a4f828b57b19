// adagen's runtime, the same for all robots.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <vector>

#include "program_setting.hpp"

namespace adagen {
namespace {

// An independent check: inverse dynamics by Newton's and Euler's equations, body by body, in
// long double. It shares the model's constants with the solver, and no arithmetic.
namespace check {

using Real = long double;
using Vec = std::array<Real, 3>;
using Mat = std::array<Vec, 3>;

Vec operator+(const Vec& a, const Vec& b) { return {a[0] + b[0], a[1] + b[1], a[2] + b[2]}; }
Vec cross(const Vec& a, const Vec& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}
Vec times(const Mat& m, const Vec& a) {
  Vec result{};
  for (int i = 0; i < 3; ++i) result[i] = m[i][0] * a[0] + m[i][1] * a[1] + m[i][2] * a[2];
  return result;
}
Vec transposed_times(const Mat& m, const Vec& a) {
  Vec result{};
  for (int i = 0; i < 3; ++i) result[i] = m[0][i] * a[0] + m[1][i] * a[1] + m[2][i] * a[2];
  return result;
}
Mat times(const Mat& a, const Mat& b) {
  Mat result{};
  for (int i = 0; i < 3; ++i)
    for (int j = 0; j < 3; ++j)
      for (int k = 0; k < 3; ++k) result[i][j] += a[i][k] * b[k][j];
  return result;
}
Real length(const Vec& a) { return std::sqrt(a[0] * a[0] + a[1] * a[1] + a[2] * a[2]); }
Vec vec3(const Number* x) { return {Real(x[0]), Real(x[1]), Real(x[2])}; }
Mat mat3(const Number* x) { return {vec3(x), vec3(x + 3), vec3(x + 6)}; }

// How large the terms are from which something is added up: what rounding errors are relative to.
// A rotation changes no length, so that sizes hold in every frame. The moment about the base is
// what n becomes in a solver that works in the axes of the base: the way there times f.
struct Sizes {
  Real dw, a, f, n;
  Real way;         // from the base to the body's origin, through all joints
  Real about_base;  // moment
};

struct Body {
  Mat turn;   // child to parent coordinates
  Vec shift;  // child origin in parent coordinates
  Vec w, dw;  // angular velocity and acceleration, in the body's frame
  Vec a;      // acceleration of its origin minus gravity, in the body's frame
  Vec f, n;   // force on it through its joint, and moment about its origin
  Sizes size;
};

// Rotation and origin of the child frame in the joint frame.
void displace(const Joint& joint, const Number* q, Mat& turn, Vec& shift) {
  turn = {Vec{1, 0, 0}, Vec{0, 1, 0}, Vec{0, 0, 1}};
  shift = {};
  const auto about_z = [&turn](Real angle) {
    const Real c = std::cos(angle), s = std::sin(angle);
    turn = {Vec{c, -s, 0}, Vec{s, c, 0}, Vec{0, 0, 1}};
  };
  const auto orient = [&turn](const Number* p) {
    Real x = p[0], y = p[1], z = p[2], w = p[3];
    const Real size = std::sqrt(x * x + y * y + z * z + w * w);
    x /= size, y /= size, z /= size, w /= size;
    turn = {Vec{1 - 2 * (y * y + z * z), 2 * (x * y - z * w), 2 * (x * z + y * w)},
            Vec{2 * (x * y + z * w), 1 - 2 * (x * x + z * z), 2 * (y * z - x * w)},
            Vec{2 * (x * z - y * w), 2 * (y * z + x * w), 1 - 2 * (x * x + y * y)}};
  };
  switch (joint.kind) {
    case JointKind::kRevolute:
      about_z(q[0]);
      break;
    case JointKind::kPrismatic:
      shift[2] = Real(q[0]);
      break;
    case JointKind::kSpherical:
      orient(q);
      break;
    case JointKind::kPlanar:
      about_z(q[2]), shift = {Real(q[0]), Real(q[1]), 0};
      break;
    case JointKind::kFloating:
      orient(q + 3), shift = vec3(q);
      break;
  }
}

// Angular and linear part of a joint's velocity or acceleration, in the child's frame.
void motion(const Joint& joint, const Number* x, Vec& angular, Vec& linear) {
  angular = linear = {};
  switch (joint.kind) {
    case JointKind::kRevolute:
      angular[2] = Real(x[0]);
      break;
    case JointKind::kPrismatic:
      linear[2] = Real(x[0]);
      break;
    case JointKind::kSpherical:
      angular = vec3(x);
      break;
    case JointKind::kPlanar:
      linear = {Real(x[0]), Real(x[1]), 0}, angular[2] = Real(x[2]);
      break;
    case JointKind::kFloating:
      linear = vec3(x), angular = vec3(x + 3);
      break;
  }
}

// What is added up in a row of the equation of motion, and the size of it. A light body that falls
// freely has no moment about its centre of mass, and a solver in the axes of the base finds none
// but the rounding of moments about the base.
struct Row {
  Real value = 0, size = 0;
  Real about_base = 0;  // the size with moments about the base

  void add(Real x) { value += x, size += std::abs(x); }
};

// Torque of a joint's damping, friction, spring and rotor.
void add_passive(const Joint& joint, const Number* q, const Number* v, const Number* qdd,
                 Row* row) {
  for (int k = 0; k < joint.nv; ++k) {
    const double rate = double(v[joint.v + k]);
    row[k].add(joint.damping * rate);
    row[k].add(joint.rotor * double(qdd[joint.v + k]));
    row[k].add(joint.friction * std::tanh(rate / joint.friction_speed));
  }
  if (joint.stiffness != 0) row[0].add(joint.stiffness * (double(q[joint.q]) - joint.rest));
}

// The outer forces push their links.
void push(const Number* outer, std::vector<Body>& body) {
  for (const OuterForce& one : about.outer_forces) {
    Body& b = body[static_cast<std::size_t>(one.link)];
    const Mat turn = mat3(one.rotation);
    const Vec force = times(turn, vec3(outer)), moment = times(turn, vec3(outer + 3));
    const Vec place = vec3(one.translation), lever = cross(place, force);
    for (int k = 0; k < 3; ++k) b.f[k] -= force[k], b.n[k] -= moment[k] + lever[k];
    b.size.f += length(force), b.size.n += length(moment) + length(place) * length(force);
    outer += 6;
  }
}

// What moves a body: its inertia times its acceleration, and the force that this needs at its
// joint.
void set_in_motion(const Link& link, Body& b) {
  const Vec c = vec3(link.com);
  const Vec at_com = b.a + cross(b.dw, c) + cross(b.w, cross(b.w, c));
  const Mat inertia = mat3(link.tensor);
  for (int k = 0; k < 3; ++k) b.f[k] = link.mass * at_com[k];
  b.n = times(inertia, b.dw) + cross(b.w, times(inertia, b.w)) + cross(c, b.f);
  const Real turning = b.size.dw + length(b.w) * length(b.w);
  const Real about_com = std::hypot(length(inertia[0]), length(inertia[1]), length(inertia[2]));
  b.size.f = link.mass * (b.size.a + turning * length(c));
  b.size.n = about_com * turning + length(c) * b.size.f;
}

// The motion of body j + 1. Errors of joints' accelerations are independent of each other: what
// they add up to in an angular acceleration grows with their root mean square.
void set_motion(int j, const Number* q, const Number* v, const Number* qdd,
                std::vector<Body>& body) {
  const Joint& joint = about.joints[j];
  const Body& parent = body[static_cast<std::size_t>(joint.parent)];
  Body& b = body[static_cast<std::size_t>(j) + 1];
  Mat turn;
  Vec shift, spin, slide, spin_rate, slide_rate;
  displace(joint, q + joint.q, turn, shift);
  motion(joint, v + joint.v, spin, slide);
  motion(joint, qdd + joint.v, spin_rate, slide_rate);
  b.turn = times(mat3(joint.rotation), turn);
  b.shift = vec3(joint.translation) + times(mat3(joint.rotation), shift);
  const Vec carried = transposed_times(b.turn, parent.w);
  b.w = carried + spin;
  b.dw = transposed_times(b.turn, parent.dw) + cross(carried, spin) + spin_rate;
  const Vec at_origin =
      parent.a + cross(parent.dw, b.shift) + cross(parent.w, cross(parent.w, b.shift));
  const Vec coriolis = cross(carried, slide);
  b.a = transposed_times(b.turn, at_origin) + coriolis + coriolis + cross(spin, slide) + slide_rate;
  const Real turning = parent.size.dw + length(parent.w) * length(parent.w);
  b.size.dw = std::hypot(parent.size.dw, length(carried) * length(spin), length(spin_rate));
  b.size.a = parent.size.a + turning * length(b.shift) + 2 * length(b.w) * length(slide) +
             length(slide_rate);
  b.size.way = parent.size.way + length(b.shift);
}

// The torques of a joint: moments and forces along its freedoms.
void take_torques(const Joint& joint, const Body& b, Row* row) {
  const auto take = [&row](const Vec& x, Real size, Real about_base, int first, int count) {
    for (int k = first; k < first + count; ++k, ++row)
      row->value = x[k], row->size = size, row->about_base = about_base;
  };
  const auto forces = [&](int first, int count) { take(b.f, b.size.f, b.size.f, first, count); };
  const auto moments = [&](int first, int count) {
    take(b.n, b.size.n, b.size.n + b.size.about_base, first, count);
  };
  switch (joint.kind) {
    case JointKind::kRevolute:
      return moments(2, 1);
    case JointKind::kPrismatic:
      return forces(2, 1);
    case JointKind::kSpherical:
      return moments(0, 3);
    case JointKind::kPlanar:
      return forces(0, 2), moments(2, 1);
    case JointKind::kFloating:
      return forces(0, 3), moments(0, 3);
  }
}

// A slaved joint counts through its source's torque.
void fold(Row* row) {
  for (const Joint& joint : about.joints) {
    if (joint.source < 0) continue;
    Row& source = row[about.joints[joint.source].v];
    source.value += joint.multiplier * row[joint.v].value;
    source.size += std::abs(joint.multiplier) * row[joint.v].size;
    source.about_base += std::abs(joint.multiplier) * row[joint.v].about_base;
    row[joint.v] = {};
  }
}

// Torques that give accelerations qdd at (q, v) beside the outer forces.
void inverse_dynamics(const Number* q, const Number* v, const Number* qdd, const Number* outer,
                      std::vector<Row>& rows) {
  static std::vector<Body> body;
  body.resize(static_cast<std::size_t>(about.links.count));
  body[0] = {};
  for (int k = 0; k < 3; ++k) body[0].a[k] = -about.gravity[k];
  body[0].size.a = length(body[0].a);
  for (int j = 0; j < about.joints.count; ++j) {
    set_motion(j, q, v, qdd, body);
    set_in_motion(about.links[j + 1], body[static_cast<std::size_t>(j) + 1]);
  }
  push(outer, body);
  for (Body& b : body) b.size.about_base = b.size.way * b.size.f;
  for (int j = about.joints.count - 1; j >= 0; --j) {
    const Joint& joint = about.joints[j];
    const Body& b = body[static_cast<std::size_t>(j) + 1];
    take_torques(joint, b, &rows[static_cast<std::size_t>(joint.v)]);
    add_passive(joint, q, v, qdd, &rows[static_cast<std::size_t>(joint.v)]);
    Body& parent = body[static_cast<std::size_t>(joint.parent)];
    const Vec force = times(b.turn, b.f);
    parent.f = parent.f + force;
    parent.n = parent.n + times(b.turn, b.n) + cross(b.shift, force);
    parent.size.f += b.size.f;
    parent.size.n += b.size.n + length(b.shift) * b.size.f;
    parent.size.about_base += b.size.about_base;
  }
  fold(rows.data());
}

// How far a slaved acceleration is from following its source, relative to its size, and a
// prescribed one from what was prescribed.
double slip(const Joint& joint, const Number* tau, const Number* qdd) {
  double worst = 0;
  for (int k = joint.v; joint.prescribed && k < joint.v + joint.nv; ++k)
    worst = std::max(worst, std::abs(double(qdd[k]) - double(tau[k])));
  if (joint.source < 0) return worst;
  const double own = double(qdd[joint.v]);
  const double due = joint.multiplier * double(qdd[about.joints[joint.source].v]);
  return std::max(worst, std::abs(own - due) / std::max(1.0, std::abs(due)));
}

// Of each degree of freedom, whether the solver gives its acceleration.
std::vector<bool> given() {
  std::vector<bool> found(static_cast<std::size_t>(about.nv));
  for (const Joint& joint : about.joints)
    for (int k = joint.v; k < joint.v + joint.nv; ++k)
      found[static_cast<std::size_t>(k)] = joint.given;
  return found;
}

// Solves rows, each with its right-hand side behind it, by Gauss's elimination; nothing where they
// are singular.
std::vector<Real> solved(std::vector<std::vector<Real>> rows) {
  const std::size_t n = rows.size();
  std::vector<Real> x(n);
  for (std::size_t k = 0; k < n; ++k) {
    std::size_t most = k;
    for (std::size_t i = k; i < n; ++i)
      if (std::abs(rows[i][k]) > std::abs(rows[most][k])) most = i;
    std::swap(rows[k], rows[most]);
    if (rows[k][k] == 0) return {};
    for (std::size_t i = k + 1; i < n; ++i) {
      const Real part = rows[i][k] / rows[k][k];
      for (std::size_t j = k; j <= n; ++j) rows[i][j] -= part * rows[k][j];
    }
  }
  for (std::size_t k = n; k-- > 0;) {
    x[k] = rows[k][n];
    for (std::size_t j = k + 1; j < n; ++j) x[k] -= rows[k][j] * x[j];
    x[k] /= rows[k][k];
  }
  return x;
}

// Computes accelerations that the solver does not give, from their own rows of the equation of
// motion. Errors of the other accelerations remain as residuals in their rows.
void complete(const Number* q, const Number* v, const Number* tau, std::vector<Number>& qdd) {
  std::vector<std::size_t> open;
  for (const Joint& joint : about.joints)
    for (int at = joint.v; !joint.given && at < joint.v + joint.nv; ++at) {
      const std::size_t k = static_cast<std::size_t>(at);
      qdd[k] = joint.prescribed ? tau[k] : Number(0);
      if (!joint.prescribed) open.push_back(k);
    }
  if (open.empty()) return;
  const std::size_t nv = static_cast<std::size_t>(about.nv), n = open.size();
  std::vector<Row> needed(nv), moved(nv);
  inverse_dynamics(q, v, qdd.data(), tau + nv, needed);
  std::vector<std::vector<Real>> rows(n, std::vector<Real>(n + 1));
  for (std::size_t k = 0; k < n; ++k) {
    std::vector<Number> unit(qdd);
    unit[open[k]] = 1;
    std::fill(moved.begin(), moved.end(), Row{});
    inverse_dynamics(q, v, unit.data(), tau + nv, moved);
    for (std::size_t i = 0; i < n; ++i) rows[i][k] = moved[open[i]].value - needed[open[i]].value;
    rows[k][n] = Real(tau[open[k]]) - needed[open[k]].value;
  }
  const std::vector<Real> found = solved(rows);
  for (std::size_t k = 0; k < found.size(); ++k) qdd[open[k]] = static_cast<Number>(found[k]);
}

// The residual of the equation of motion.
struct Left {
  std::vector<Real> over, size;  // of each row: ID(q, v, qdd) - tau, and how much is added up there
  double residual = 0;           // length of over beside that of the torques that it balances
  double backward = 0;           // the largest of over / size, the backward error
  int joint = 0;                 // whose row that is
};

// What is left over as a part of the size of its row; of the size with moments about the base where
// it is no more than their rounding.
double part_of(Real over, Real size, Real about_base) {
  constexpr Real kRounding = 64 * std::numeric_limits<Number>::epsilon();
  const Real whole = std::abs(over) <= kRounding * about_base ? std::max(size, about_base) : size;
  return whole > 0 ? double(std::abs(over) / whole) : 0;
}

// Nobody asks for the torque of a prescribed joint.
Left left_over(const Number* q, const Number* v, const Number* tau, const Number* qdd) {
  const std::size_t nv = static_cast<std::size_t>(about.nv);
  static std::vector<Row> needed(nv), at_rest(nv), given(nv);
  static const std::vector<Number> zero(nv);
  inverse_dynamics(q, v, qdd, tau + nv, needed);
  inverse_dynamics(q, v, zero.data(), tau + nv, at_rest);
  for (std::size_t k = 0; k < nv; ++k) given[k] = {Real(tau[k]), std::abs(Real(tau[k])), 0};
  fold(given.data());
  Left left;
  left.over.resize(nv), left.size.resize(nv);
  Real error = 0, size = 0;
  for (int j = 0; j < about.joints.count; ++j) {
    const Joint& joint = about.joints[j];
    for (int at = joint.v; !joint.prescribed && at < joint.v + joint.nv; ++at) {
      const std::size_t k = static_cast<std::size_t>(at);
      left.over[k] = needed[k].value - given[k].value,
      left.size[k] = needed[k].size + given[k].size;
      const double part = part_of(left.over[k], left.size[k], needed[k].about_base);
      if (!(part <= left.backward)) left.backward = part, left.joint = j;
      error += left.over[k] * left.over[k];
      size += given[k].value * given[k].value + at_rest[k].value * at_rest[k].value;
    }
  }
  left.residual = double(size > 0 ? std::sqrt(error / size) : std::sqrt(error));
  return left;
}

}  // namespace check

}  // namespace
}  // namespace adagen
