// adagen's runtime, the same for all robots.
#pragma once

#include "common.hpp"
#include "inertia.hpp"
#include "memory.hpp"
#include "sample/joints.hpp"
#include "sizes.hpp"
#include "spatial.hpp"
#include "status.hpp"

namespace {

// The projected articulated inertia and bias force that a joint passes to its near side.
struct Passed {
  Inertia inertia;
  Columns6 force;
};

template <class Body>
Passed hand_on(Workspace& w, int joint, Body& body, Real sigma, const Inertia& I,
               const Columns6& p) {
  Passed passed;
  if (!articulate(body, sigma, I, p, passed.inertia, passed.force)) fail(w, kFactorization, joint);
  return passed;
}

// Added to the near link, in the same axes or in those of the parent link.
[[maybe_unused]] inline void add(const Passed& passed, Inertia& IA, Columns6& pA) {
  IA += passed.inertia;
  pA += passed.force;
}
[[maybe_unused]] inline void add_in_parent(const Transform& X, const Passed& passed, Inertia& IA,
                                           Columns6& pA) {
  add_in_parent(X, passed.inertia, IA);
  pA += X.transposed_times(passed.force);
}

}  // namespace
