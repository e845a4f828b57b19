// adagen's runtime, the same for all robots.
#pragma once

#include <algorithm>
#include <array>

#include "baseline.hpp"
#include "inertia.hpp"
#include "joins.hpp"
#include "sizes.hpp"
#include "spatial.hpp"

namespace {

// Exact projection: nothing is left of an articulated inertia along its joint's motion, to the bit,
// and an inertia is 21 numbers.

// What the joint passes on of its articulated body; false where D cannot be factorized.
template <class Kind>
bool hand_on(Body& body, const Real* tau, Columns6& force) {
  constexpr int n = kFree<Kind>;
  constexpr auto& free = Kind::Free::row;
  std::array<std::array<Real, n>, n> D;
  std::array<std::array<Real, 6>, n> E;
  std::array<std::array<Real, kColumns>, n> u;
  for (int k = 0; k < n; ++k) {
    for (int l = 0; l < n; ++l) D[k][l] = body.I(free[k], free[l]);
    for (int l = 0; l < 6; ++l) E[k][l] = body.I(free[k], l);
    u[k][0] = tau[k] - body.p(free[k], 0);
  }
  const bool good = factorize(D);
  forward_substitute(D, E);
  backward_substitute(D, E);
  forward_substitute(D, u);
  backward_substitute(D, u);
  Inertia passed = body.I;
  for (int r : Kind::Constrained::row)
    for (int s : Kind::Constrained::row) {
      if (s < r) continue;
      Real x = body.I(r, s);
      for (int k = 0; k < n; ++k) x -= body.I(r, free[k]) * E[k][s];
      passed.set(r, s, x);
    }
  for (int k = 0; k < n; ++k)
    for (int l = 0; l < 6; ++l) passed.set(free[k], l, 0);
  for (int r : Kind::Constrained::row) {
    Real x = body.p(r, 0);
    for (int k = 0; k < n; ++k) x += body.I(r, free[k]) * u[k][0];
    for (int s : Kind::Constrained::row) x += passed(r, s) * body.c(s, 0);
    force(r, 0) = x;
  }
  for (int k = 0; k < n; ++k) {
    force(free[k], 0) = tau[k];
    for (int l = 0; l < n; ++l) E[k][free[l]] = k == l ? 1 : 0;
  }
  body.I = passed;
  std::copy(E.begin(), E.end(), body.E.begin());
  std::copy(u.begin(), u.end(), body.u.begin());
  return good;
}

inline void give(const Body& body, Body& parent) { add_in_parent(body.X, body.I, parent.I); }

}  // namespace
