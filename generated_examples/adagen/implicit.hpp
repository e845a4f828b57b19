// adagen's runtime, the same for all robots.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

#include "manifold.hpp"
#include "program_setting.hpp"
#include "status.hpp"

namespace adagen {
namespace {

// Damping D, stiffness K and friction of joints as they act at the end of a step, where these
// joints move with v + u instead of v: they take g(u) = (D + h K) u + friction at v + u less
// friction at v of the torques with springs at q + h v, for which a0 would be the answer. From the
// evaluations of unit torques, M = (H^-1) at these joints: u = h (a0 - M g(u)). One evaluation for
// each such degree of freedom, and two.
class PassiveTerms {
 public:
  using State = std::vector<double>;

  PassiveTerms() {
    for (State* x : {&extra_, &base_, &unit_}) x->resize(static_cast<std::size_t>(about.nv));
    for (const Joint& joint : about.joints)
      for (int k = 0; k < joint.nv; ++k) {
        if (!joint.prescribed && (joint.damping > 0 || joint.stiffness > 0 || joint.friction > 0))
          rows_.push_back({static_cast<std::size_t>(joint.v + k), double(joint.damping),
                           double(joint.stiffness), double(joint.friction),
                           double(joint.friction_speed)});
      }
    for (State* x : {&taken_, &next_, &slope_, &u_, &du_}) x->resize(rows_.size());
    for (State* x : {&matrix_, &factors_}) x->resize(rows_.size() * rows_.size());
  }

  // a at the end of a step of length h from (q, v).
  template <class Accelerate>
  int accelerate(double h, const State& q, const State& v, State& a, Accelerate evaluate) {
    const std::size_t n = rows_.size();
    std::fill(extra_.begin(), extra_.end(), 0.0);
    for (const Row& row : rows_) extra_[row.v] = -h * row.stiffness * v[row.v];
    if (const int failed = evaluate(q, v, extra_, base_)) return failed;
    if (n == 0) {
      a = base_;
      return kFine;
    }
    for (std::size_t k = 0; k < n; ++k) {
      const double before = extra_[rows_[k].v];
      extra_[rows_[k].v] += 1;
      if (const int failed = evaluate(q, v, extra_, unit_)) return failed;
      extra_[rows_[k].v] = before;
      for (std::size_t i = 0; i < n; ++i)
        matrix_[i * n + k] = unit_[rows_[i].v] - base_[rows_[i].v];
    }
    settle(h, v);
    for (std::size_t k = 0; k < n; ++k) extra_[rows_[k].v] -= taken_[k];
    return evaluate(q, v, extra_, a);
  }

 private:
  struct Row {
    std::size_t v;
    double damping, stiffness, friction, friction_speed;

    bool rubs() const { return friction > 0; }

    // The velocity used at the end of a step that changes v by u.
    double torque(double h, double at, double u) const {
      const double linear = (damping + h * stiffness) * u;
      if (!rubs()) return linear;
      return linear +
             friction * (std::tanh((at + u) / friction_speed) - std::tanh(at / friction_speed));
    }

    // Its derivative by u.
    double slope(double h, double end) const {
      if (!rubs()) return damping + h * stiffness;
      const double part = std::tanh(end / friction_speed);
      return damping + h * stiffness + friction / friction_speed * (1 - part) * (1 + part);
    }
  };

  static constexpr int kMostSteps = 100;
  static constexpr double kNear = 1e-10, kFlat = 0.1;

  // taken_ <- g(u) by Newton's method. g grows with u and M is positive semi-definite, so that u is
  // where a convex function is least: a step is shortened until that function no longer rises
  // steeply. Linear effects need one step.
  void settle(double h, const State& v) {
    const bool rubs =
        std::any_of(rows_.begin(), rows_.end(), [](const Row& row) { return row.rubs(); });
    std::fill(taken_.begin(), taken_.end(), 0.0);
    for (int step = 0; step < (rubs ? kMostSteps : 1); ++step) {
      aim(h, v);
      const double length = rubs ? step_length(h, v) : 1;
      bool near = true;
      for (std::size_t k = 0; k < rows_.size(); ++k) {
        const double change = next_[k] - taken_[k];
        taken_[k] += length * change;
        near &= std::abs(change) <= kNear * std::abs(taken_[k]) ||
                std::abs(du_[k]) <= kNear * (std::abs(v[rows_[k].v]) + std::abs(u_[k]));
      }
      if (near || length == 0) return;
    }
  }

  // From taken_: u_; by the derivative there, next_ as taken_ would be and du_ as u_ would change.
  ADAGEN_HOT void aim(double h, const State& v) {
    const std::size_t n = rows_.size();
    for (std::size_t i = 0; i < n; ++i) {
      const Row& row = rows_[i];
      double a = base_[row.v];
      for (std::size_t k = 0; k < n; ++k) a -= matrix_[i * n + k] * taken_[k];
      u_[i] = h * a;
      slope_[i] = row.slope(h, v[row.v] + u_[i]);
      next_[i] = slope_[i] * (h * base_[row.v] - u_[i]) + row.torque(h, v[row.v], u_[i]);
      for (std::size_t k = 0; k < n; ++k)
        factors_[i * n + k] = (i == k) + h * slope_[i] * matrix_[i * n + k];
    }
    solve();
    for (std::size_t i = 0; i < n; ++i) {
      du_[i] = 0;
      for (std::size_t k = 0; k < n; ++k) du_[i] -= h * matrix_[i * n + k] * (next_[k] - taken_[k]);
    }
  }

  // How much of the way from taken_ to next_ is gone, at most 1; 0 where there is nowhere to go.
  double step_length(double h, const State& v) const {
    const double start = rise(0, h, v);
    if (!(start < 0)) return 0;
    double low = 0, high = 1, length = 1;
    for (int halvings = 0; halvings < 60; ++halvings) {
      const double found = rise(length, h, v);
      if (std::abs(found) <= -kFlat * start || (length == 1 && found < 0)) break;
      (found > 0 ? high : low) = length;
      length = (low + high) / 2;
    }
    return length;
  }

  // The convex function's derivative at a part of the way.
  ADAGEN_HOT double rise(double part, double h, const State& v) const {
    double sum = 0;
    for (std::size_t k = 0; k < rows_.size(); ++k) {
      const double there = taken_[k] + part * (next_[k] - taken_[k]);
      sum += du_[k] * (rows_[k].torque(h, v[rows_[k].v], u_[k] + part * du_[k]) - there);
    }
    return sum;
  }

  // next_ <- factors_^-1 next_ by elimination, without pivoting: but for scales of rows and
  // columns the matrix is symmetric and positive definite.
  ADAGEN_HOT void solve() {
    const std::size_t n = rows_.size();
    for (std::size_t k = 0; k < n; ++k)
      for (std::size_t i = k + 1; i < n; ++i) {
        const double part = factors_[i * n + k] / factors_[k * n + k];
        for (std::size_t j = k; j < n; ++j) factors_[i * n + j] -= part * factors_[k * n + j];
        next_[i] -= part * next_[k];
      }
    for (std::size_t k = n; k-- > 0;) {
      for (std::size_t j = k + 1; j < n; ++j) next_[k] -= factors_[k * n + j] * next_[j];
      next_[k] /= factors_[k * n + k];
    }
  }

  std::vector<Row> rows_;
  State extra_, base_, unit_, matrix_, factors_;
  State taken_, next_, slope_, u_, du_;  // torques twice; their derivatives; changes of velocity
};

}  // namespace
}  // namespace adagen
