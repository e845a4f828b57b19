// adagen's runtime, the same for all robots.
// What follows the processes in a source: the solver, its C interface, the program around it.
#pragma once

#include "among_processes.hpp"
#include "c_interface.hpp"

#ifndef ADAGEN_NO_MAIN
#include "measured.hpp"
#include "program_processes.hpp"
#endif  // ADAGEN_NO_MAIN
