// adagen's runtime, the same for all robots.
#pragma once

#include "../sizes.hpp"

namespace {

// A link's mass, that times its centre of mass, and its pseudo-inertia, sum of m x x^T: xx xy xz yy
// yz zz. About the link's origin.
struct LinkInertia {
  Real mass, moments[3], tensor[6];
};

// What a process does at a link.
struct LinkRole {
  bool gathers;   // paths meet at it inwards
  bool adds_own;  // its own inertia is this process's to add
  bool parts;     // paths part at it outwards
  bool oriented;  // the quaternion of the joint above it is this process's to take
};

}  // namespace
