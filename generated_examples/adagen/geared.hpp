// adagen's runtime, the same for all robots.
#pragma once

#include <array>

#include "articulated.hpp"
#include "common.hpp"
#include "inertia.hpp"
#include "joins.hpp"
#include "sizes.hpp"
#include "spatial.hpp"

namespace {

// A joint with a rotor inside an articulated body: D = S^T I^A S + J. What of the projection does
// not vanish along S is computed from products with J, never as a difference.
template <class Kind>
struct Geared : Articulated<Kind> {
  using Articulated<Kind>::n;
  Real J;                                       // the rotor's inertia
  std::array<std::array<Real, n>, n> of_rotor;  // J D^-1
  std::array<std::array<Real, n>, n> of_body;   // D^-1 S^T I^A S
};

template <class Kind>
bool articulate(Geared<Kind>& i, Real sigma, const Inertia& I, const Columns6& p, Inertia& passed,
                Columns6& force) {
  constexpr int n = kFree<Kind>;
  constexpr auto& free = Kind::Free::row;
  Inertia with = I;
  ADAGEN_FOR (k, 0, n) {
    with.set(free[k], free[k], I(free[k], free[k]) + i.J);
    ADAGEN_FOR (l, 0, n) {
      i.of_rotor[k][l] = k == l ? i.J : Real(0);
      i.of_body[k][l] = I(free[k], free[l]);
    }
  }
  Articulated<Kind>& body = i;
  const bool good = articulate(body, sigma, with, p, passed, force);
  body.solve(i.of_rotor);
  body.solve(i.of_body);
  auto moved = body.u;
  body.solve(moved);
  ADAGEN_FOR (k, 0, n) {
    ADAGEN_FOR (l, k, n) passed.set(free[k], free[l], i.J * i.of_body[k][l]);
    for (int r : Kind::Constrained::row) passed.set(free[k], r, i.J * body.E[k][r]);
  }
  ADAGEN_FOR (c, 0, kColumns)
    ADAGEN_FOR (k, 0, n) {
      Real& along = force(free[k], c);
      along -= i.J * moved[k][c];
      ADAGEN_FOR (r, 0, 6) along += passed(free[k], r) * body.c(r, c);
      for (int r : Kind::Constrained::row) force(r, c) += passed(r, free[k]) * body.c(free[k], c);
    }
  return good;
}

template <class Kind>
std::array<std::array<Real, kColumns>, kFree<Kind>> accelerate(const Geared<Kind>& i, Columns6& a) {
  constexpr int n = kFree<Kind>;
  constexpr auto& free = Kind::Free::row;
  std::array<std::array<Real, kColumns>, n> near;
  ADAGEN_FOR (k, 0, n)
    ADAGEN_FOR (c, 0, kColumns) {
      near[k][c] = a(free[k], c) + i.c(free[k], c);
      a(free[k], c) = -i.c(free[k], c);
    }
  const Articulated<Kind>& body = i;
  auto moved = accelerate(body, a);
  ADAGEN_FOR (k, 0, n)
    ADAGEN_FOR (c, 0, kColumns) {
      ADAGEN_FOR (l, 0, n) moved[k][c] -= i.of_body[k][l] * near[l][c];
      a(free[k], c) = near[k][c] + moved[k][c];
    }
  return moved;
}

template <class Kind>
void share(const Geared<Kind>& i, Mat6& m) {
  constexpr int n = kFree<Kind>;
  const Mat6 near = m;
  const Articulated<Kind>& body = i;
  share(body, m);
  ADAGEN_FOR (k, 0, n)
    ADAGEN_FOR (l, 0, n)
      m.row(Kind::Free::row[k]) += i.of_rotor[k][l] * near.row(Kind::Free::row[l]);
}

template <class Kind>
void carry(const Geared<Kind>& i, Mat6& m) {
  Mat6 own = Mat6::Zero();
  const Articulated<Kind>& body = i;
  carry(body, own);
  share(i, m);
  m.transposeInPlace();
  share(i, m);
  m += own;
}

template <class Kind>
void deliver(Geared<Kind>& i, Columns6& load) {
  constexpr int n = kFree<Kind>;
  const Columns6 far = load;
  Articulated<Kind>& body = i;
  deliver(body, load);
  ADAGEN_FOR (k, 0, n)
    ADAGEN_FOR (l, 0, n)
      load.row(Kind::Free::row[k]) += i.of_rotor[l][k] * far.row(Kind::Free::row[l]);
}

}  // namespace
