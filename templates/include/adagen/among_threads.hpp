// adagen's runtime, the same for all robots.
// A solver for several threads, one state at a time, of constants that are never set.
#pragma once

#include "no_parameters.hpp"
#include "open_threads.hpp"
#include "threads.hpp"
