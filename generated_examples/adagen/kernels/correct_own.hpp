// adagen's runtime, the same for all robots.
#pragma once

#include <cstddef>
#include <limits>

#include "../error_bound.hpp"
#include "../sample/cuts.hpp"
#include "../sizes.hpp"
#include "../status.hpp"
#include "../value.hpp"
#include "guards.hpp"
#include "loop_settings.hpp"
#include "memory.hpp"

namespace {

// Refinement by residuals in the solver's own numbers. The sweep that weighs what the links'
// equations of motion leave over (certify.hpp) leaves u / D at each joint; one more sweep outwards
// makes the correction of it, H^-1 times the residual, whose energy norm that sweep has found.

// A correction must be smaller than half of the answer, later ones than half of the one before, and
// the last one so small that what it leaves, about its square, has digits; down to what the
// residual itself is rounded by.
constexpr double kSmallEnough = std::numeric_limits<Real>::digits > 30 ? 1e-3 : 0.1;
inline void begin_own_correction(Workspace& w, int k) {
  const double seen = double(w.seen), settled = 4 * double(kUnit) * double(kUnit);
  const double size = energy_ratio(seen, double(w.energy));
  auto& sizes = w.refinement.corrections;
  const double before = k > 0 ? sizes[static_cast<std::size_t>(k) - 1] : 1;
  sizes[static_cast<std::size_t>(k)] = size;
  if (!(seen <= settled * double(w.rounded))) {
    if (!(size < before / 2)) fail(w, kNotRefined, 0);
    if (k == kRefine - 1 && !(size < kSmallEnough)) fail(w, kTooFewSteps, 0);
  }
  if (k == kRefine - 1 && !tells_errors(double(w.energy)))
    sizes.fill(std::numeric_limits<double>::infinity());
  w.sum = w.answer;
  w.again = true;
}

inline void end_own_correction(Workspace& w) {
  for (std::size_t k = 0; k < std::size_t(kNv); ++k) w.answer[k] += w.sum[k];
  w.again = false;
}

}  // namespace
