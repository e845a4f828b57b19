// adagen's runtime, the same for all robots.
// A solver for several threads, one state at a time, of constants that are never set.
// Of a sample solver there is none.
#pragma once
#if defined(ADAGEN_SOLVER)

#include "no_parameters.hpp"
#include "open_threads.hpp"
#include "threads.hpp"

#endif
