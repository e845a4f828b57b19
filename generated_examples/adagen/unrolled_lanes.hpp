// adagen's runtime, the same for all robots.
#pragma once
#if !defined(ADAGEN_SOLVER)
#define ADAGEN_BATCH  // read alone, it is of a solver for batches
#endif

#include "kernels/lanes.hpp"

namespace {

// What straight lines of lanes need.
ADAGEN_INLINE bool all(const LaneBits& good) { return !any_of(~good); }
ADAGEN_INLINE bool all(const LaneBits& good, const LaneBits& also) { return all(good & also); }

// Zero for finite numbers only: x - x is, in all bits.
inline Lanes unlike_zero(const Lanes* x, int count) {
  LaneBits found{};
  for (int k = 0; k < count; ++k) found |= same_bits<LaneBits>(x[k] - x[k]);
  return same_bits<Lanes>(found);
}

template <int count>
inline void take_sines_and_cosines(const Lanes* angle, Lanes* sine, Lanes* cosine) {
  LaneBits beyond{};
  for (int k = 0; k < count; ++k) {
    near_sine_and_cosine(angle[k], sine[k], cosine[k]);
    beyond |= too_large(angle[k]);
  }
  if (__builtin_expect(!any_of(beyond), 1)) return;
  for (int k = 0; k < count; ++k) sine_and_cosine(angle[k], sine[k], cosine[k]);
}

}  // namespace
