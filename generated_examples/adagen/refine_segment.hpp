// adagen's runtime, the same for all robots.
#pragma once

#include "articulated.hpp"
#include "joins.hpp"
#include "sizes.hpp"
#include "spatial.hpp"

namespace {

// What a joint's far link feels through it: I^A a + p^A, handle forces not counted.
template <class Body>
Columns6 effort(const Body& IA, const Columns6& a, const Columns6& pA) {
  Columns6 f = pA;
  for (int c = 0; c < kColumns; ++c)
    for (int row = 0; row < 6; ++row)
      for (int k = 0; k < 6; ++k) f(row, c) += IA(row, k) * a(k, c);
  return f;
}

// A joint that has been articulated, for another p^A on its far side, no torque of its own and no
// velocity: what it passes on.
template <class Kind>
Columns6 rearticulate(Articulated<Kind>& i, Real sigma, const Columns6& p) {
  Columns6 force;
  i.c.setZero();
  for (int k = 0; k < kFree<Kind>; ++k) {
    i.tau[k][0] = 0;
    for (int c = 0; c < kColumns; ++c) {
      i.u[k][c] = sigma * i.tau[k][c] - p(Kind::Free::row[k], c);
      force(Kind::Free::row[k], c) = sigma * i.tau[k][c];
    }
  }
  for (int row : Kind::Constrained::row)
    for (int c = 0; c < kColumns; ++c) {
      force(row, c) = p(row, c);
      for (int k = 0; k < kFree<Kind>; ++k) force(row, c) += i.E[k][row] * i.u[k][c];
    }
  return force;
}

}  // namespace
