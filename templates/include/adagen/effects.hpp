// adagen's runtime, the same for all robots.
#pragma once

#include <array>
#include <cstddef>

#include "joins.hpp"
#include "sizes.hpp"
#include "spatial.hpp"

namespace {

// A joint without freedom: its acceleration is known, or its rotor's inertia stands for it.
struct Held {
  using Free = Selection<>;
  using Constrained = Selection<0, 1, 2, 3, 4, 5>;
};

// c + S qdd, qdd being prescribed.
template <class Kind>
void prescribe(const Number* qdd, Columns6& c) {
  c.col(0) += joint_velocity<Kind>(qdd);
}

template <class Kind>
using Freedoms = std::array<std::array<Real, kColumns>, kFree<Kind>>;

// A joint with a rotor, where chains are joined: S qdd = S J^-1 (tau - S^T f), so that S J^-1 S^T
// is added to Phi_B and S J^-1 tau to c.
template <class Kind>
Mat6 with_rotor(const Mat6& Phi, Real rotor) {
  Mat6 result = Phi;
  for (int row : Kind::Free::row) result(row, row) += 1 / rotor;
  return result;
}

template <class Kind>
void drive(const Freedoms<Kind>& tau, Real rotor, Columns6& c) {
  for (std::size_t k = 0; k < tau.size(); ++k)
    for (int column = 0; column < kColumns; ++column)
      c(Kind::Free::row[k], column) += tau[k][static_cast<std::size_t>(column)] / rotor;
}

// And its acceleration, J^-1 (tau - S^T f).
template <class Kind>
Freedoms<Kind> rotor_acceleration(const Freedoms<Kind>& tau, Real rotor, const Columns6& f) {
  Freedoms<Kind> qdd;
  for (std::size_t k = 0; k < tau.size(); ++k)
    for (std::size_t c = 0; c < kColumns; ++c)
      qdd[k][c] = (tau[k][c] - f(Kind::Free::row[k], static_cast<int>(c))) / rotor;
  return qdd;
}

}  // namespace
