// adagen's runtime, the same for all robots.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <utility>
#include <vector>

#include "inverse_dynamics.hpp"
#include "manifold.hpp"
#include "program_setting.hpp"

namespace adagen {
namespace {

// Closed loops: how far they are open, how fast, and states in which they are closed. In long
// double, straight from the frames of the model, in axes of the ground.
namespace loops {

using check::Mat;
using check::Real;
using check::Vec;
using check::operator+;

struct Pose {
  Mat turn;    // link to ground coordinates
  Vec origin;  // in ground coordinates
};

// Constraints at a configuration: gaps, and the rows J of their rates.
struct Constraints {
  std::vector<Real> gaps, rows;  // rows: one after the other

  int count() const { return static_cast<int>(gaps.size()); }
  Real* row(int k) { return rows.data() + static_cast<std::size_t>(k) * std::size_t(about.nv); }
  const Real* row(int k) const {
    return rows.data() + static_cast<std::size_t>(k) * std::size_t(about.nv);
  }
};

inline bool any() { return about.loops.count + about.couplings.count > 0; }
inline Real dot(const Vec& a, const Vec& b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }
inline Vec minus(const Vec& a, const Vec& b) { return {a[0] - b[0], a[1] - b[1], a[2] - b[2]}; }
inline Vec column(const Mat& m, int k) { return {m[0][k], m[1][k], m[2][k]}; }

inline std::vector<Pose> poses(const Number* q) {
  std::vector<Pose> result(static_cast<std::size_t>(about.links.count));
  result[0] = {{Vec{1, 0, 0}, Vec{0, 1, 0}, Vec{0, 0, 1}}, {}};
  for (int j = 0; j < about.joints.count; ++j) {
    const Joint& joint = about.joints[j];
    const Pose& parent = result[static_cast<std::size_t>(joint.parent)];
    Mat turn;
    Vec shift;
    check::displace(joint, q + joint.q, turn, shift);
    const Mat base = check::mat3(joint.rotation);
    const Vec place = check::vec3(joint.translation) + check::times(base, shift);
    result[static_cast<std::size_t>(j) + 1] = {check::times(parent.turn, check::times(base, turn)),
                                               parent.origin + check::times(parent.turn, place)};
  }
  return result;
}

// Both frames of a loop in ground coordinates.
struct Frames {
  const Loop& loop;
  Mat axes1, axes2;
  Vec place1, place2;  // of their origins
  Vec apart;           // from the first to the second
  Vec seen;            // where frame 2 is if the loop is closed: a point of link 1

  Frames(const Loop& given, const std::vector<Pose>& pose) : loop(given) {
    const Pose& one = pose[static_cast<std::size_t>(loop.link1)];
    const Pose& two = pose[static_cast<std::size_t>(loop.link2)];
    axes1 = check::times(one.turn, check::mat3(loop.rotation1));
    axes2 = check::times(two.turn, check::mat3(loop.rotation2));
    place1 = one.origin + check::times(one.turn, check::vec3(loop.translation1));
    place2 = two.origin + check::times(two.turn, check::vec3(loop.translation2));
    apart = minus(place2, place1);
    seen = place1;
    for (int k = 0; k < 3; ++k) {
      if (loop.holds(k)) continue;
      const Vec axis = column(axes1, k);
      for (int i = 0; i < 3; ++i) seen[i] += axis[i] * dot(axis, apart);
    }
  }

  // The direction about which the k-th angular row is: an axis of frame 1, or the common normal.
  Vec turning_axis(int k) const {
    return loop.universal ? check::cross(column(axes2, 2), column(axes1, 2)) : column(axes1, k);
  }

  Real misaligned(int k) const {
    if (loop.universal) return dot(column(axes1, 2), column(axes2, 2));
    const bool whole = loop.bars(2);
    Vec twist{};
    for (int i = whole ? 0 : 2; i < 3; ++i)
      twist = twist + check::cross(column(axes1, i), column(axes2, i));
    return dot(column(axes1, k), twist) / (whole ? 2 : 1);
  }

  // Calls for each row: whether it is of places, its direction, its gap.
  template <class Do>
  void each(Do row) const {
    for (int k = 0; k < 3; ++k)
      if (loop.holds(k)) row(true, column(axes1, k), dot(column(axes1, k), apart));
    for (int k = 0; k < 3; ++k)
      if (loop.bars(k)) row(false, turning_axis(k), misaligned(k));
  }
};

// Adds how fast a point of a link moves along a direction, or the link turns about it. Returns how
// fast it moves in whatever direction, the size of what is added.
inline Real add_rate(const std::vector<Pose>& pose, int link, Real sign, bool linear, const Vec& n,
                     const Vec& place, Real* row) {
  Real size = 0;
  for (; link > 0; link = about.joints[link - 1].parent) {
    const Joint& joint = about.joints[link - 1];
    const Pose& own = pose[static_cast<std::size_t>(link)];
    for (int k = 0; k < joint.nv; ++k) {
      Number unit[6] = {};
      unit[k] = 1;
      Vec angular, sliding;
      check::motion(joint, unit, angular, sliding);
      const Vec w = check::times(own.turn, angular);
      const Vec v = check::times(own.turn, sliding) + check::cross(w, minus(place, own.origin));
      row[joint.v + k] += sign * dot(n, linear ? v : w);
      size += check::length(linear ? v : w);
    }
  }
  return size;
}

// A row that is rounding beside what it is made of is none: across the plane of a linkage nothing
// moves.
inline void clear_noise(Real* row, Real size) {
  constexpr Real kNoise = sizeof(Number) == sizeof(double) ? 1e-10L : 1e-5L;
  Real squared = 0;
  for (int j = 0; j < about.nv; ++j) squared += row[j] * row[j];
  if (std::sqrt(squared) <= kNoise * size) std::fill_n(row, about.nv, Real(0));
}

inline Constraints constraints(const Number* q) {
  Constraints found;
  const std::vector<Pose> pose = poses(q);
  const auto add = [&found](Real gap) {
    found.gaps.push_back(gap);
    found.rows.resize(found.rows.size() + static_cast<std::size_t>(about.nv));
    return found.row(found.count() - 1);
  };
  for (const Loop& loop : about.loops) {
    const Frames frames(loop, pose);
    frames.each([&](bool linear, const Vec& n, Real gap) {
      Real* const row = add(gap);
      const Real size = add_rate(pose, loop.link2, 1, linear, n, frames.place2, row) +
                        add_rate(pose, loop.link1, -1, linear, n, frames.seen, row);
      clear_noise(row, size);
    });
  }
  for (const Coupling& coupling : about.couplings) {
    Real gap = -Real(coupling.offset);
    for (int k = 0; k < coupling.count; ++k)
      gap += Real(coupling.factors[k]) * Real(q[about.joints[coupling.joints[k]].q]);
    Real* const row = add(gap);
    for (int k = 0; k < coupling.count; ++k)
      row[about.joints[coupling.joints[k]].v] += Real(coupling.factors[k]);
  }
  return found;
}

// x = W J^T y with (J W J^T + damping) y = r, the damping beside rows brought to one size: for a
// small one the x of least size that moves the gaps by r, as far as it can be had. W: weights,
// or 1.
inline std::vector<Real> least(const Constraints& at, const std::vector<Real>& r, Real damping,
                               const std::vector<Real>* weights, std::vector<Real>* forces) {
  const int m = at.count(), n = about.nv;
  const std::size_t rows = static_cast<std::size_t>(m);
  std::vector<Real> square(rows * rows), y(r), x(static_cast<std::size_t>(n));
  const auto weight = [weights](int k) { return weights ? (*weights)[std::size_t(k)] : Real(1); };
  const auto entry = [&square, m](int i, int k) -> Real& {
    return square[static_cast<std::size_t>(i * m + k)];
  };
  std::vector<Real> scale(rows);  // rows in metres and radians, light and heavy, come to one size
  for (int i = 0; i < m; ++i) {
    for (int k = 0; k <= i; ++k)
      for (int j = 0; j < n; ++j) entry(i, k) += at.row(i)[j] * weight(j) * at.row(k)[j];
    scale[std::size_t(i)] = entry(i, i) > 0 ? 1 / std::sqrt(entry(i, i)) : 0;
    for (int k = 0; k <= i; ++k) entry(i, k) *= scale[std::size_t(i)] * scale[std::size_t(k)];
    entry(i, i) += damping;
    y[std::size_t(i)] *= scale[std::size_t(i)];
  }
  for (int i = 0; i < m; ++i) {  // L L^T
    for (int k = 0; k <= i; ++k) {
      for (int j = 0; j < k; ++j) entry(i, k) -= entry(i, j) * entry(k, j);
      if (k < i)
        entry(i, k) /= entry(k, k) > 0 ? entry(k, k) : 1;
      else
        entry(i, i) = entry(i, i) > 0 ? std::sqrt(entry(i, i)) : 0;
    }
  }
  const auto divided = [&entry](Real value, int i) {
    return entry(i, i) > 0 ? value / entry(i, i) : 0;
  };
  for (int i = 0; i < m; ++i) {
    for (int k = 0; k < i; ++k) y[std::size_t(i)] -= entry(i, k) * y[std::size_t(k)];
    y[std::size_t(i)] = divided(y[std::size_t(i)], i);
  }
  for (int i = m - 1; i >= 0; --i) {
    for (int k = i + 1; k < m; ++k) y[std::size_t(i)] -= entry(k, i) * y[std::size_t(k)];
    y[std::size_t(i)] = divided(y[std::size_t(i)], i);
  }
  for (int i = 0; i < m; ++i) y[std::size_t(i)] *= scale[std::size_t(i)];
  for (int i = 0; i < m; ++i)
    for (int j = 0; j < n; ++j) x[std::size_t(j)] += weight(j) * at.row(i)[j] * y[std::size_t(i)];
  if (forces != nullptr) *forces = std::move(y);
  return x;
}

inline Real largest(const std::vector<Real>& values) {
  Real size = 0;
  for (const Real x : values) size = std::max(size, std::abs(x));
  return size;
}

// Damping beside rows that follow from others, up to the rounding of poses, squared.
constexpr Real kLittle = sizeof(Number) == sizeof(double) ? 1e-15L : 1e-9L;

// Newton's method with Levenberg's damping, as near as can be. Returns how far loops stay open.
inline Real close(std::vector<double>& q) {
  std::vector<Number> at(q.size());
  const auto found = [&at](const std::vector<double>& x) {
    std::transform(x.begin(), x.end(), at.begin(), [](double y) { return static_cast<Number>(y); });
    return constraints(at.data());
  };
  const auto cost = [](const Constraints& one) {
    Real sum = 0;
    for (const Real gap : one.gaps) sum += gap * gap;
    return sum;
  };
  constexpr Real kRounding = std::numeric_limits<Number>::epsilon();
  Constraints now = found(q);
  Real damping = 1e-3L;
  for (int k = 0; k < 100 && largest(now.gaps) > kRounding && damping < 1e6L; ++k) {
    const std::vector<Real> step =
        least(now, now.gaps, std::max(damping, kLittle), nullptr, nullptr);
    std::vector<double> by(step.size()), next(q);
    std::transform(step.begin(), step.end(), by.begin(), [](Real x) { return double(-x); });
    manifold::move(q, by, next);
    Constraints tried = found(next);
    if (cost(tried) < cost(now))
      q = next, now = std::move(tried), damping *= 0.1L;
    else
      damping = std::max(damping, kLittle) * 10;
  }
  return largest(now.gaps);
}

// Removes from velocities the part that would open loops.
inline void hold(const Number* q, std::vector<double>& v) {
  const Constraints now = constraints(q);
  for (int again = 0; again < 2; ++again) {
    std::vector<Real> rates(now.gaps.size());
    for (int i = 0; i < now.count(); ++i)
      for (int j = 0; j < about.nv; ++j)
        rates[std::size_t(i)] += now.row(i)[j] * Real(v[std::size_t(j)]);
    const std::vector<Real> excess = least(now, rates, kLittle, nullptr, nullptr);
    for (std::size_t j = 0; j < v.size(); ++j) v[j] -= double(excess[j]);
  }
}

// Closes a state that is nearly closed; whether that can be.
inline bool settle(std::vector<double>& q, std::vector<double>& v) {
  constexpr Real kClosed = sizeof(Number) == sizeof(double) ? 1e-10L : 3e-5L;
  if (!(close(q) <= kClosed)) return false;
  std::vector<Number> at(q.begin(), q.end());
  hold(at.data(), v);
  return true;
}

// The size of a row of the acceleration, and how far it is from zero.
struct Parting {
  Real value, size;
};

inline Parting parting(const Frames& frames, const std::vector<Pose>& pose,
                       const std::vector<check::Body>& body, const Number* v, bool linear,
                       const Vec& n) {
  const Loop& loop = frames.loop;
  Vec spin[2], spin_rate[2], at[2];
  Real size = 0;
  const int links[] = {loop.link1, loop.link2};
  const Vec places[] = {frames.seen, frames.place2};
  for (int k = 0; k < 2; ++k) {
    const check::Body& b = body[static_cast<std::size_t>(links[k])];
    const Pose& own = pose[static_cast<std::size_t>(links[k])];
    const Vec arm = minus(places[k], own.origin);
    spin[k] = check::times(own.turn, b.w), spin_rate[k] = check::times(own.turn, b.dw);
    at[k] = check::times(own.turn, b.a) + check::cross(spin_rate[k], arm) +
            check::cross(spin[k], check::cross(spin[k], arm));
    const Real turning = b.size.dw + dot(b.w, b.w);
    size += linear ? b.size.a + turning * check::length(arm) : turning;
  }
  const Vec turning = minus(spin[1], spin[0]);
  if (linear) {
    Vec sliding{};
    for (int k = 0; k < 3; ++k) {
      if (loop.holds(k)) continue;
      const Vec axis = column(frames.axes1, k);
      std::vector<Real> row(static_cast<std::size_t>(about.nv));
      add_rate(pose, loop.link2, 1, true, axis, frames.place2, row.data());
      add_rate(pose, loop.link1, -1, true, axis, frames.seen, row.data());
      Real speed = 0;
      for (std::size_t j = 0; j < row.size(); ++j) speed += row[j] * Real(v[j]);
      for (int i = 0; i < 3; ++i) sliding[i] += axis[i] * speed;
    }
    const Vec coriolis = check::cross(spin[0], sliding);
    size += 2 * check::length(coriolis);
    return {dot(n, minus(minus(at[1], at[0]), coriolis + coriolis)), size};
  }
  const Real rates = dot(n, minus(spin_rate[1], spin_rate[0]));
  if (!loop.universal) return {rates - dot(n, check::cross(spin[0], turning)), size};
  const Vec a = column(frames.axes1, 2), b = column(frames.axes2, 2);
  const Vec changing =
      check::cross(check::cross(spin[1], b), a) + check::cross(b, check::cross(spin[0], a));
  return {rates + dot(changing, turning), size};
}

// The residual of the equation of motion may be constraint forces: those that fit best are
// subtracted. In exchange, accelerations must not open loops.
inline void account(const Number* q, const Number* v, const Number* qdd, check::Left& left) {
  const Constraints now = constraints(q);
  const std::size_t nv = left.over.size();
  std::vector<Real> weights(nv), held(nv);
  // Links without mass have rows of no size, which constraint forces have to balance all the same.
  const Real usual = std::max(largest(left.size), std::numeric_limits<Real>::min()) * 1e-4L;
  for (const auto& joint : about.joints)
    for (std::size_t k = std::size_t(joint.v); k < std::size_t(joint.v + joint.nv); ++k) {
      const Real size = std::max(left.size[k], usual);
      weights[k] = joint.prescribed ? 0 : 1 / (size * size);  // its torque is not needed
    }
  const auto squares = [&left] {
    Real sum = 0;
    for (const Real x : left.over) sum += x * x;
    return sum;
  };
  const Real before = squares();
  for (int again = 0; again < 4; ++again) {  // the damping's share is left to the next
    std::vector<Real> right(now.gaps.size()), forces;
    for (int i = 0; i < now.count(); ++i)
      for (std::size_t k = 0; k < nv; ++k)
        right[static_cast<std::size_t>(i)] += now.row(i)[k] * weights[k] * left.over[k];
    least(now, right, kLittle, &weights, &forces);
    for (std::size_t k = 0; k < nv; ++k)
      for (int i = 0; i < now.count(); ++i) {
        const Real part = now.row(i)[k] * forces[static_cast<std::size_t>(i)];
        if (weights[k] > 0) left.over[k] -= part;
        if (again == 0) held[k] += std::abs(part);
      }
  }
  for (std::size_t k = 0; k < nv; ++k) left.size[k] += held[k];
  const Real after = squares();
  left.residual *= before > 0 ? double(std::sqrt(after / before)) : 1;
  left.backward = 0;
  // Beside the largest, what is as small as this is rounding noise: of joints that nothing moves.
  constexpr Real kNoise = 1e-8L;
  const auto note = [&left](Real value, Real size, int joint) {
    const double part = size > 0 ? double(std::abs(value) / size) : 0;
    if (!(part <= left.backward)) left.backward = part, left.joint = joint;
  };
  const Real least_size = kNoise * largest(left.size);
  for (int j = 0; j < about.joints.count; ++j)
    for (int k = about.joints[j].v; k < about.joints[j].v + about.joints[j].nv; ++k)
      note(left.over[static_cast<std::size_t>(k)],
           std::max(least_size, left.size[static_cast<std::size_t>(k)]), j);
  std::vector<check::Body> body(static_cast<std::size_t>(about.links.count));
  for (int k = 0; k < 3; ++k) body[0].a[k] = -about.gravity[k];
  body[0].size.a = check::length(body[0].a);
  for (int j = 0; j < about.joints.count; ++j) check::set_motion(j, q, v, qdd, body);
  const std::vector<Pose> pose = poses(q);
  for (const Loop& loop : about.loops) {
    const Frames frames(loop, pose);
    frames.each([&](bool linear, const Vec& n, Real) {
      const Parting found = parting(frames, pose, body, v, linear, n);
      note(found.value, found.size, std::max(loop.link1, loop.link2) - 1);
    });
  }
  Real fastest = 0;
  for (int k = 0; k < about.nv; ++k) fastest = std::max(fastest, std::abs(Real(qdd[k])));
  for (const Coupling& coupling : about.couplings) {
    Real sum = 0, size = kNoise * fastest;
    for (int k = 0; k < coupling.count; ++k) {
      const Real part = Real(coupling.factors[k]) * Real(qdd[about.joints[coupling.joints[k]].v]);
      sum += part, size += std::abs(part);
    }
    note(sum, size, coupling.joints[0]);
  }
}

}  // namespace loops

}  // namespace
}  // namespace adagen
