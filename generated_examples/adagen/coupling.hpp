// adagen's runtime, the same for all robots.
#pragma once

#include <array>
#include <cstddef>

#include "joins.hpp"
#include "sample/workspace.hpp"
#include "sizes.hpp"
#include "status.hpp"

namespace {

// One row of A qdd = 0, which keeps a slaved joint in step with its source.
template <std::size_t columns>
void coupling_row(std::array<Real, columns>& row, const std::array<Real, columns>& slaved,
                  const std::array<Real, columns>& source, double multiplier) {
  for (std::size_t k = 0; k < columns; ++k) row[k] = slaved[k] - Real(multiplier) * source[k];
}

// The torques that make A qdd zero: (A H^-1 A^T) torques = -A qdd, by Cholesky's factorization.
template <std::size_t m>
void solve_coupling(Workspace& w, int joint, const std::array<std::array<Real, m + 1>, m>& rows,
                    std::array<Real, m>& torques) {
  std::array<std::array<Real, m>, m> L;
  std::array<std::array<Real, 1>, m> x;
  for (std::size_t i = 0; i < m; ++i) {
    x[i][0] = -rows[i][0];
    for (std::size_t k = 0; k < m; ++k) L[i][k] = rows[i][k + 1];
  }
  if (!factorize(L)) fail(w, kFactorization, joint);
  forward_substitute(L, x);
  backward_substitute(L, x);
  for (std::size_t i = 0; i < m; ++i) torques[i] = x[i][0];
}

}  // namespace
