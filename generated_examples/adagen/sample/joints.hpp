// adagen's runtime, the same for all robots.
// A solver says this itself (ADAGEN_SOLVER). Read alone, headers take it of a sample.
#pragma once
#if !defined(ADAGEN_SOLVER) && !defined(ADAGEN_WORKSPACE)
#define ADAGEN_WORKSPACE

#include <array>

#include "../first_parameters.hpp"
#include "../refine.hpp"
#include "../spatial.hpp"

namespace {

struct Workspace {
  const Number* q = nullptr;
  const Number* v = nullptr;
  const Number* tau = nullptr;
  Number* qdd = nullptr;
  int status = 0;
  std::array<Real, kColumns - 1> coupling{};
  std::array<Number, kParameterCount> parameters = first_parameters<Number>();
  Columns6 ground;
  Refinement refinement;
  EIGEN_MAKE_ALIGNED_OPERATOR_NEW
};

}  // namespace

#endif
