// adagen's runtime, the same for all robots.
// A solver says this itself (ADAGEN_SOLVER). Read alone, headers take it of a sample.
#pragma once
#if !defined(ADAGEN_SOLVER)

#include <array>

#include "../first_parameters.hpp"
#include "../kernels/weights.hpp"
#include "../value.hpp"
#if defined(ADAGEN_SAMPLE_CUTS)
#include "../refine.hpp"
#include "../spatial.hpp"
#endif

namespace {

struct Cuts {
  int near_lock = 0;
  std::array<Number, kParameterCount> parameters = first_parameters<Number>();
  std::array<std::array<Value, kNv>, kSlavedCount> responses{};
  std::array<Real, kSlavedCount> coupling{};
  std::array<Value, 2> certificate{};
  Value seen{}, rounded{}, energy{}, parted{}, held{};
  Motion<Value> unheld{};
  Vector<Value> fall{};
  std::array<Reached<Value>, kLinkCount> reached{};
  std::array<Left<Value>, kLinkCount> lefts{};
  std::array<Value, kNv> sum{};
#if defined(ADAGEN_SAMPLE_CUTS)
  std::array<Columns6, kLinkCount> loads;
  Refinement refinement;
  EIGEN_MAKE_ALIGNED_OPERATOR_NEW
#else
  struct {
    std::array<double, kRefine> corrections{};
    double rounding = 0;
  } refinement;
#endif
};

}  // namespace

#endif
