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

// What a joint hands on to its near side: an articulated body's inertia and bias force.
struct Handed {
  Inertia inertia;
  Columns6 force;
};

template <class Body>
Handed hand_on(Workspace& w, int joint, Body& body, Real sigma, const Inertia& I,
               const Columns6& p) {
  Handed handed;
  if (!articulate(body, sigma, I, p, handed.inertia, handed.force)) fail(w, kFactorization, joint);
  return handed;
}

}  // namespace
