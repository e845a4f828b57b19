// adagen's runtime, the same for all robots.
// The program's main, in a file of a solver's that is not linked with another program.
#pragma once

#include "description.hpp"
#include "sample/described.hpp"
#include "this_solver.hpp"

// Compiled for size: it runs once.
[[gnu::cold]] int main(int count, char** words) {
  auto* const solver = new ThisSolver;
  const int status = adagen::program<ADAGEN_VERSION>(description(), *solver, count, words);
  delete solver;
  return status;
}
