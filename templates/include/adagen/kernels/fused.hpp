// adagen's runtime, the same for all robots.
#pragma once
#if !defined(ADAGEN_SOLVER)
#define ADAGEN_SAMPLE_CUTS  // read alone, it is of a solver whose processes meet, and that refines
#endif

#include <cstddef>

#include "../constants.hpp"
#include "../sample/robot.hpp"
#include "../sizes.hpp"
#include "../spatial.hpp"
#include "../value.hpp"
#include "algebra.hpp"
#include "inward_turned.hpp"
#include "memory.hpp"
#include "mobility.hpp"
#include "outward.hpp"
#include "turned.hpp"

namespace {

// Runs through links without mass, joined as one: in their links' own axes, as fused.hpp has them.

// From joint j's parent link to its child link, in their own axes.
inline Transform own_transform(Workspace& w, int j) {
  const JointConstants& joint = kJoints[static_cast<std::size_t>(j)];
  const Matrix<Value> turn = matrix_at(w.of(j, kTurn));
  Vector<Value> r = lever_on_parent(w, single(j), joint.kind, turn);
  if (joint.kind == JointKind::kPlanar || joint.kind == JointKind::kFloating) {
    const Value* q = w.q + joint.q;
    const Matrix<Real> P = placement(joint);
    const Vector<Value> slide{q[0], q[1], joint.kind == JointKind::kFloating ? q[2] : Value{}};
    r += Vector<Value>{dot(slide, P.x), dot(slide, P.y), dot(slide, P.z)};
  }
  return {transposed_of(turn), {r.x, r.y, r.z}};
}

// From a link's own axes to those that its mobility and forces at it are expressed in, which may be
// those of the base; and the matrix for arguments expressed there instead of in the link's own
// axes.
[[maybe_unused]] inline Columns6 to_expressed(Workspace& w, int link, const Columns6& f) {
  return turned_link(link) ? f : rotated(mat3_of(matrix_at(w.of(link - 1, kAxes))), f);
}
[[maybe_unused]] inline Mat6 for_expressed(Workspace& w, int link, const Mat6& m) {
  if (turned_link(link)) return m;
  return transposed(rotated(mat3_of(matrix_at(w.of(link - 1, kAxes))), transposed(m)));
}

}  // namespace
