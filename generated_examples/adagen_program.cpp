// The program around a solver, emitted by adagen 0.1.0 (adagen_program.cpp.j2). Do not edit: emit anew.
//
// It is the same for all robots: states in, accelerations out; check; time; trace; simulate. Compile
// it as the last section of a solver, NAME_pP.cpp, says, and link both:
//   -DADAGEN_MPI    the solver is for several processes
//   -DADAGEN_FLOAT  its states and accelerations are float
//
// licence   yours to choose: what adagen emits belongs to whoever emits it

#include "adagen/start.hpp"
