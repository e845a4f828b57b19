// A program that solves batches with an emitted solver and prints what it finds, a line each.
// Words: channel, the file of states, then cases: how many states, and which of them are spoilt.
// With CERTIFIED, every other case asks for the bounds of errors as well.
#include <mpi.h>

#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <fstream>
#include <sstream>
#include <string>
#include <vector>

#include "SOLVER.h"

namespace {

constexpr int kJoints = 9;  // all with one freedom

using Numbers = std::vector<double>;

// The first count of the states, over and over.
Numbers rows(const Numbers& given, int count) {
  Numbers result(static_cast<std::size_t>(count * kJoints));
  for (std::size_t k = 0; k < result.size(); ++k) result[k] = given[k % given.size()];
  return result;
}

struct States {
  Numbers q, v, tau;
};

// Solves states on this process, or on all; without states it helps. Bounds are wanted where there
// is room for them.
int solve(SOLVER_solver* solver, bool shared, int count, const double* q, const double* v,
          const double* tau, double* qdd, Numbers& bounds) {
#if defined(CERTIFIED)
  if (!bounds.empty())
    return (shared ? SOLVER_solve_batch_at_root_certified : SOLVER_solve_batch_certified)(
        solver, count, q, v, tau, qdd, bounds.data());
#else
  bounds.clear();
#endif
  return (shared ? SOLVER_solve_batch_at_root : SOLVER_solve_batch)(solver, count, q, v, tau, qdd);
}

// "same" where each state's accelerations and bounds are, bit by bit, those that it has by itself.
const char* verdict(SOLVER_solver* solver, const States& s, int count, const Numbers& qdd,
                    const Numbers& bounds) {
  for (int k = 0; k < count; ++k) {
    const long row = kJoints * k;
    const std::size_t at = static_cast<std::size_t>(k);
    double alone[kJoints];
    Numbers own(bounds.empty() ? 0 : 1);
    const int failed = solve(solver, false, 1, &s.q[row], &s.v[row], &s.tau[row], alone, own);
    for (int j = 0; j < kJoints; ++j)
      if (failed != 0 ? !std::isnan(qdd[row + j]) : qdd[row + j] != alone[j]) return "other";
    if (own.empty()) continue;
    if (failed != 0 ? !std::isnan(bounds[at]) : !(bounds[at] > 1e-17 && bounds[at] < 1e-12))
      return "no bound";
    if (failed == 0 && bounds[at] != own[0]) return "another bound";
  }
  return "same";
}

void report(const char* what, const std::string& words, SOLVER_solver* solver, int failed,
            const States& s, int count, const Numbers& qdd, const Numbers& bounds) {
  std::printf("%s %s: %s;", what, words.c_str(), failed == 0 ? "fine" : "failed");
  if (failed != 0) std::printf(" %s;", SOLVER_failure(solver));
  for (int k = 0; SOLVER_failed_state(solver, k) >= 0; ++k)
    std::printf(" %d", SOLVER_failed_state(solver, k));
  std::printf("; %s\n", verdict(solver, s, count, qdd, bounds));
}

}  // namespace

int main(int count, char** words) {
  MPI_Init(&count, &words);
  int rank = 0;
  MPI_Comm_rank(MPI_COMM_WORLD, &rank);
  SOLVER_solver* const solver = SOLVER_open(MPI_COMM_WORLD, words[1], 30);
  Numbers q, v, tau;
  std::ifstream file(words[2]);
  for (std::string line; std::getline(file, line);) {
    std::istringstream numbers(line);
    for (Numbers* part : {&q, &v, &tau})
      for (int k = 0; k < kJoints; ++k) {
        double x = 0;
        numbers >> x;
        part->push_back(x);
      }
  }
  for (int k = 3; k < count; ++k) {
    std::istringstream numbers(words[k]);
    int states = 0;
    numbers >> states;
    States s{rows(q, states), rows(v, states), rows(tau, states)};
    for (int spoilt; numbers >> spoilt;) s.v[kJoints * spoilt + 3] = std::nan("");
    Numbers qdd(s.q.size(), 12345), bounds(k % 2 == 0 ? 0 : static_cast<std::size_t>(states), -1);
    int failed =
        solve(solver, false, states, s.q.data(), s.v.data(), s.tau.data(), qdd.data(), bounds);
    if (rank == 1) report("alone", words[k], solver, failed, s, states, qdd, bounds);
    qdd.assign(qdd.size(), 12345), bounds.assign(bounds.size(), -1);
    Numbers none;  // what the others get is not theirs to ask for
    failed = rank == 0 ? solve(solver, true, states, s.q.data(), s.v.data(), s.tau.data(),
                               qdd.data(), bounds)
                       : solve(solver, true, -1, nullptr, nullptr, nullptr, nullptr, none);
    if (rank == 0) report("shared", words[k], solver, failed, s, states, qdd, bounds);
    if (rank > 0 && failed != 0) std::printf("process %d failed\n", rank);
  }
  SOLVER_close(solver);
  MPI_Finalize();
}
