// adagen's runtime, the same for all robots.
#pragma once
#if !defined(ADAGEN_SOLVER)
#define ADAGEN_SAMPLE_CUTS  // read alone, it is of a solver whose processes meet, and that refines
#endif

#include <cstddef>

#include "../common.hpp"
#include "../value.hpp"
#include "algebra.hpp"
#include "lanes.hpp"
#include "memory.hpp"

namespace {

// What refinement needs of a joint: the articulated body on its far side, and its force.

template <class T>
ADAGEN_INLINE void keep_body(Workspace& w, const Joints<T>& joints, const Body<T>& X) {
  if constexpr (kWidth<T> == 1)
    w.whole[static_cast<std::size_t>(joints.joint[0])] = X;
  else
    ADAGEN_FOR (k, 0, kWidth<T>) w.whole[static_cast<std::size_t>(joints.joint[k])] = lane(X, k);
}

// Handle forces on a link count as its body's.
ADAGEN_INLINE void keep_load(Workspace& w, int j, const Vector<Value>& n, const Vector<Value>& f) {
  Body<Value>& X = w.whole[static_cast<std::size_t>(j)];
  X.n += -n, X.f += -f;
}

// The force of a joint on its child link, in that link's axes: I^A a + p^A of its far link.
template <bool reversed>
inline void keep_one_force(Workspace& w, int j, const Motion<Value>& a) {
  const Body<Value>& X = w.whole[static_cast<std::size_t>(j)];
  Vector<Value> n = X.A * a.angular + X.B * a.linear + X.n;
  Vector<Value> f = transposed_times(X.B, a.angular) + X.C * a.linear + X.f;
  if constexpr (reversed) {
    n = cross(w.joints[static_cast<std::size_t>(j)].r, f) - n;
    f = -f;
  }
  const Matrix<Value> R = matrix_at(w.of(j, kAxes));
  n = transposed_times(R, n), f = transposed_times(R, f);
  w.refinement.f[static_cast<std::size_t>(j)].col(w.refinement.side) << n.x, n.y, n.z, f.x, f.y,
      f.z;
}
template <bool reversed, class T>
ADAGEN_INLINE void keep_force(Workspace& w, const Joints<T>& joints, const Motion<T>& a) {
  if constexpr (kWidth<T> == 1)
    keep_one_force<reversed>(w, joints.joint[0], a);
  else
    ADAGEN_FOR (k, 0, kWidth<T>) keep_one_force<reversed>(w, joints.joint[k], lane(a, k));
}

// The forces that are kept next are of the motion (0), or of the torque at a slaved joint.
[[maybe_unused]] inline void keep_side(Workspace& w, std::size_t side) {
  w.refinement.side = static_cast<int>(side);
}

}  // namespace
