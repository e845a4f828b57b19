// adagen's runtime, the same for all robots.
// What follows the processes in a source: the solver, its C interface, the program around it.
// Of a sample solver there is none.
#pragma once
#if defined(ADAGEN_SOLVER)

#include "among_processes.hpp"
#include "c_interface.hpp"

#ifndef ADAGEN_NO_MAIN
#include "measured.hpp"
#include "program_processes.hpp"
#endif  // ADAGEN_NO_MAIN

#endif
