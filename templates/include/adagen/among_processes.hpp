// adagen's runtime, the same for all robots.
// A solver for several MPI processes, one state at a time, of constants that are never set.
#pragma once

#include "no_parameters.hpp"
#include "open.hpp"
#include "solver.hpp"
