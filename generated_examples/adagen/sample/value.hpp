// adagen's runtime, the same for all robots.
// A solver says this itself (ADAGEN_SOLVER). Read alone, headers take it of a sample.
#pragma once
#if !defined(ADAGEN_SOLVER)

#if defined(ADAGEN_SAMPLE_BATCH)
#include "../kernels/lanes.hpp"
#else
#include "../sizes.hpp"
#endif

namespace {

#if defined(ADAGEN_SAMPLE_BATCH)
using Value = Lanes;  // what is computed with: one state in each lane
#else
using Value = Real;  // what is computed with
#endif

}  // namespace

#endif
