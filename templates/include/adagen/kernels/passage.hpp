// adagen's runtime, the same for all robots.
#pragma once

#include "algebra.hpp"

namespace {

// How a run of joints moves its last link, seen from the link that it hangs on, were that at rest:
// orientation, angular velocity and acceleration, place, velocity and acceleration of the origin.
template <class T>
struct Passage {
  Matrix<T> R;
  Vector<T> omega, alpha, p, v, a;
};

}  // namespace
