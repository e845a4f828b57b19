// adagen's runtime, the same for all robots.
#pragma once

#include "../constants.hpp"
#include "../registers.hpp"
#include "algebra.hpp"
#include "memory.hpp"

namespace {

// The square of how far the link beyond a joint is from the one before, for certificates. Where the
// joint slides, that is no less than to its place, which sliding may take back: both are rounded.
template <class T>
ADAGEN_INLINE T arm_square(const Joints<T>& joints, JointKind kind, const Vector<T>& r) {
  const T square = dot(r, r);
  if (kind == JointKind::kRevolute || kind == JointKind::kSpherical) return square;
  return larger(square, each(joints, [](const JointConstants& own) {
                  const Number* const t = own.translation;
                  return Real(t[0] * t[0] + t[1] * t[1] + t[2] * t[2]);
                }));
}

}  // namespace
