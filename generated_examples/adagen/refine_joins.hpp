// adagen's runtime, the same for all robots.
#pragma once

#include <array>

#include "joins.hpp"
#include "sizes.hpp"
#include "spatial.hpp"

namespace {

// Along the joint its force is its torque, to the bit.
template <class Kind>
void along(const std::array<std::array<Real, kColumns>, kFree<Kind>>& tau, Columns6& f) {
  for (int k = 0; k < kFree<Kind>; ++k)
    for (int c = 0; c < kColumns; ++c) f(Kind::Free::row[k], c) = tau[k][c];
}

// The right-hand side that a residual makes: the others, of coupling torques, stay as they are.
[[maybe_unused]] inline Columns6 first_column(const Vec6& x) {
  Columns6 result = Columns6::Zero();
  result.col(0) = x;
  return result;
}

// A joint that has been joined, for another difference beta of accelerations across it.
template <class Kind>
void resolve(Joined<Kind>& i, const Vec6& beta) {
  constexpr int m = kConstrained<Kind>;
  for (int k = 0; k < kFree<Kind>; ++k) i.R_beta[k][0] = beta[Kind::Free::row[k]];
  for (int row = 0; row < m; ++row) {
    Real x = beta[Kind::Constrained::row[row]];
    for (int k = 0; k < row; ++k) x -= i.L[row][k] * i.z[k][0];
    i.z[row][0] = x * i.L[row][row];
  }
}

// The same for other biases and no torque of its own.
template <class Kind>
void rejoin(Joined<Kind>& i, const Columns6& b_A, const Columns6& b_B) {
  for (int k = 0; k < kFree<Kind>; ++k) i.tau[k][0] = 0;
  Vec6 beta;
  ADAGEN_FOR (k, 0, 6) beta[k] = b_A(k, 0) - b_B(k, 0);
  resolve(i, beta);
}

}  // namespace
