// adagen's runtime, the same for all robots.
// A solver for one process, one state at a time, of constants that are never set.
#pragma once

#include "no_parameters.hpp"
#include "open_alone.hpp"
#include "solver_alone.hpp"
