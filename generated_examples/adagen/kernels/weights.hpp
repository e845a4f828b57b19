// adagen's runtime, the same for all robots.
#pragma once

#include "algebra.hpp"
#include "lanes.hpp"

namespace {

// What is left for the links on the near side of a joint, for certificates: a wrench, and the
// squares of the moments and of the forces that it was added up from.
template <class T>
struct Left {
  Vector<T> n, f;
  T moments, forces;
};

// How large accelerations are on the way to a link: squares of the largest angular one and of what
// linear ones are added up from. What rounding does to them is of that size.
template <class T>
struct Reached {
  T turning, sliding;
};

}  // namespace
