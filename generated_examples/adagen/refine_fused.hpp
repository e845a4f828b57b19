// adagen's runtime, the same for all robots.
#pragma once

#include <Eigen/Core>

#include "fused.hpp"
#include "joins.hpp"
#include "sizes.hpp"
#include "spatial.hpp"

namespace {

// A run that has been joined, for other biases and the torques in i.tau, which its forces lack.
// P is R (Phi_A + Phi_B) R^T.
template <int n>
void rejoin(Joined<Fused<n>>& i, const Eigen::Matrix<Real, n, n>& P, const Columns6& b_A,
            const Columns6& b_B) {
  Vec6 beta;
  ADAGEN_FOR (k, 0, 6) beta[k] = b_A(k, 0) - b_B(k, 0);
  for (int k = 0; k < n; ++k) {
    const Real tau = i.tau[k][0];
    for (int row = 0; row < n; ++row) beta[row] -= P(row, k) * tau;
    for (int row = 0; row < 6 - n; ++row) beta[n + row] -= i.RPN[k][row] * tau;
  }
  resolve(i, beta);
}

}  // namespace
