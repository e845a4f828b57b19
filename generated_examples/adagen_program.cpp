// The program around a solver, emitted by adagen 0.1.0 (adagen_program.cpp.j2). Do not edit: generate again.
//
// It is the same for all robots: it reads states, writes accelerations, checks, times, traces and
// simulates. Compile it as the head of a solver, NAME_pP.cpp, says ("links"), and link both:
//   -DADAGEN_MPI    the solver is for several processes
//   -DADAGEN_FLOAT  its states and accelerations are float
//
// licence   yours to choose: generated code belongs to its user

#include "adagen/start.hpp"
