// adagen's runtime, the same for all robots.
// A solver says this itself (ADAGEN_SOLVER). Read alone, headers take it of a sample.
#pragma once
#if !defined(ADAGEN_SOLVER)

#if defined(ADAGEN_BATCH)
#include "../kernels/state.hpp"
#else
#include "../kernels/copied_state.hpp"
#endif

#endif
