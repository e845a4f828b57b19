// adagen's runtime, the same for all robots.
#pragma once

#include <cstddef>
#include <limits>

#include "error_bound.hpp"
#include "sample/unrolled.hpp"
#include "sizes.hpp"
#include "status.hpp"
#include "unrolled.hpp"

namespace {

// A correction must be smaller than half of the answer, later ones than half of the one before, and
// the last one so small that what it leaves, about its square, has digits. Where hardly anything
// accelerates, the answer is a small difference of what holds it: then what the links accelerate by
// relative to free fall sets the size of rounding.
inline void judge_corrections(Workspace& w) {
  constexpr bool small = std::numeric_limits<Real>::digits < 30;
  constexpr double kSettled = small ? 1e-4 : 1e-10, kSmallEnough = small ? 0.1 : 1e-3;
  const double answer = double(w.energies[0]), whole = answer + double(w.energies[1]);
  double before = 1;
  for (std::size_t k = 0; k < std::size_t(kRefine); ++k) {
    const double part = double(w.energies[2 + k]);
    const double size = energy_ratio(part, answer);
    w.refinement.corrections[k] = size;
    if (!(part <= kSettled * kSettled * whole)) {
      if (!(size < before / 2)) fail(w, kNotRefined, 0);
      if (k + 1 == std::size_t(kRefine) && !(size < kSmallEnough)) fail(w, kTooFewSteps, 0);
    }
    before = size;
  }
  if (!tells_errors(answer)) w.refinement.corrections.fill(std::numeric_limits<double>::infinity());
}

}  // namespace
