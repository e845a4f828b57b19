// adagen's runtime, the same for all robots.
#pragma once

#include <Eigen/Core>

#include "sizes.hpp"
#include "spatial.hpp"
#include "status.hpp"

namespace {

// Memory of a process beside its joints.
struct JointsMemory {
  const Number* q = nullptr;
  const Number* v = nullptr;
  const Number* tau = nullptr;
  Number* qdd = nullptr;
  int status = kFine;
  int near_lock = 0;  // 1 + the last joint of a run that has been near gimbal lock; 0: none
  Columns6 ground;    // its acceleration; zero for corrections
  EIGEN_MAKE_ALIGNED_OPERATOR_NEW
};

}  // namespace
