// adagen's runtime, the same for all robots.
#pragma once
#if !defined(ADAGEN_SOLVER)
#define ADAGEN_SAMPLE_CUTS  // read alone, it is of a solver whose processes meet, and that refines
#endif

#include <cstddef>

#include "../spatial.hpp"
#include "../value.hpp"
#include "algebra.hpp"
#include "lanes.hpp"
#include "memory.hpp"
#include "mobility.hpp"
#include "prescribed.hpp"

namespace {

// Mobility across joints of prescribed motion: L only tells it at another point.

template <bool reversed>
Mat6 passed_prescribed(Workspace& w, int j, const Mat6& m) {
  const Vector<Value>& r = w.joints[static_cast<std::size_t>(j)].r;
  const Mat6 near = in_base(w, near_link<reversed>(j), m);
  Motion<Lanes> rows = rows_of(transposed(near));
  carry(rows, reversed ? -r : r);
  const Mat6 far = transposed(from_rows(rows));
  return as_told(w, near_link<!reversed>(j), far);
}

// S qdd in the joint's frame.
[[maybe_unused]] inline Columns6 prescribed_across(Workspace& w, int j) {
  const Columns6 a = columns_of(prescribed_motion(w, j));
  return rotated(transposed_of(matrix_at(w.of(j, kAxes))), a);
}

template <bool reversed>
void propagate_prescribed(Workspace& w, int j, const Mat6& near, const Columns6& near_bias,
                          Mat6& far, Columns6& far_bias) {
  const Mat6 half = passed_prescribed<reversed>(w, j, near);
  far = passed_prescribed<reversed>(w, j, transposed(half));
  Motion<Value> a = motion_of(in_base(w, near_link<reversed>(j), near_bias));
  move_prescribed<reversed>(w, j, a);
  far_bias = as_told(w, near_link<!reversed>(j), columns_of(a));
}

template <bool reversed>
void deliver_prescribed(Workspace& w, int j, const Columns6& load, Columns6& passed) {
  const Vector<Value>& r = w.joints[static_cast<std::size_t>(j)].r;
  Vector<Value> n{load[0], load[1], load[2]};
  const Vector<Value> f{load[3], load[4], load[5]};
  n += reversed ? cross(f, r) : cross(r, f);
  passed += columns_of({n, f});
}

}  // namespace
