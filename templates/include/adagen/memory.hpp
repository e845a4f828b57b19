// adagen's runtime, the same for all robots.
#pragma once

#include <array>
#include <cstddef>
#include <limits>

#include "gravity.hpp"
#include "sample/channel.hpp"
#include "sample/joints.hpp"
#include "sizes.hpp"
#include "spatial.hpp"
#include "status.hpp"

namespace {

inline void fail(Workspace& w, Failure kind, int joint) {
  Channel::fail(w.status, failure(kind, joint));
}

// x - x is zero for finite x only.
inline void require_finite(Workspace& w, const Number* x, int count, int joint) {
  Number sum = 0;
  for (int k = 0; k < count; ++k) sum += x[k] - x[k];
  if (!(sum == 0)) fail(w, kNotFinite, joint);
}

[[maybe_unused]] inline void require_length(Workspace& w, Real squared, int joint) {
  if (!(squared >= std::numeric_limits<Real>::min() && squared <= std::numeric_limits<Real>::max()))
    fail(w, kZeroQuaternion, joint);
}

template <std::size_t n>
void load_torque(Workspace& w, int joint, int v, std::array<std::array<Real, kColumns>, n>& tau) {
  require_finite(w, w.tau + v, static_cast<int>(n), joint);
  for (std::size_t k = 0; k < n; ++k) {
    tau[k] = {};
    tau[k][0] = Real(w.tau[v + static_cast<int>(k)]);
  }
}

// An acceleration is given only where all went well.
template <std::size_t n>
void store_acceleration(Workspace& w, int joint, int v,
                        const std::array<std::array<Real, kColumns>, n>& qdd) {
  Real sum = 0;
  for (std::size_t k = 0; k < n; ++k) sum += qdd[k][0] - qdd[k][0];
  if (!(sum == 0)) fail(w, kOverflow, joint);
  if (w.status != kFine) return;
  for (std::size_t k = 0; k < n; ++k) w.qdd[v + static_cast<int>(k)] = qdd[k][0];
}

const Mat6 kZero = Mat6::Zero();

// The ground accelerates against gravity: all accelerations are relative to free fall.
[[maybe_unused]] inline Columns6 ground(const Workspace& w) {
  Columns6 result = Columns6::Zero();
  for (int k = 0; k < 3; ++k) result(3 + k, 0) = -Real(gravity(w, k));
  return result;
}

// Accelerations of all right-hand sides, added up with the coupling torques.
template <std::size_t n, std::size_t m>
void store_coupled(Workspace& w, int joint, int v,
                   const std::array<std::array<Real, kColumns>, n>& qdd,
                   const std::array<Real, m>& torques) {
  std::array<std::array<Real, kColumns>, n> sum{};
  for (std::size_t k = 0; k < n; ++k) {
    sum[k][0] = qdd[k][0];
    for (std::size_t c = 0; c < m; ++c) sum[k][0] += qdd[k][c + 1] * torques[c];
  }
  store_acceleration(w, joint, v, sum);
}

}  // namespace
