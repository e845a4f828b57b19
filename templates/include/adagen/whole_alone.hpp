// adagen's runtime, the same for all robots.
// What follows the processes in a source: the solver, its C interface, the program around it.
#pragma once

#include "alone.hpp"
#include "c_interface.hpp"

#ifndef ADAGEN_NO_MAIN
#include "program_alone.hpp"
#endif  // ADAGEN_NO_MAIN
