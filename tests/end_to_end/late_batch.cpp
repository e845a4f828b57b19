// An MPI program around an emitted solver of batches on two processes, here named SOLVER: process 1
// comes late, twice. Process 0 says how each call went, and how many accelerations are what they
// were before, not a number, or right.
#include <mpi.h>

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <thread>
#include <vector>

#include "SOLVER.h"

int main(int count, char** words) {
  MPI_Init(&count, &words);
  int rank = 0;
  MPI_Comm_rank(MPI_COMM_WORLD, &rank);
  SOLVER_solver* const solver = SOLVER_open(MPI_COMM_WORLD, "auto", 0.2);
  constexpr int kStates = 3000;
  const std::vector<double> q(kStates * UPPER_NQ, 0.3), v(kStates * UPPER_NV, 0.2);
  const std::vector<double> tau(kStates * UPPER_NTAU, 0.1);
  double right[UPPER_NV];
  SOLVER_solve_batch(solver, 1, q.data(), v.data(), tau.data(), right);
  for (int again = 0; again < 2 && rank == 0; ++again) {
    std::vector<double> qdd(kStates * UPPER_NV, 12345);
    const int status =
        SOLVER_solve_batch_at_root(solver, kStates, q.data(), v.data(), tau.data(), qdd.data());
    long left = 0, none = 0, found = 0;
    for (std::size_t k = 0; k < qdd.size(); ++k) {
      left += qdd[k] == 12345, none += qdd[k] != qdd[k];
      found += qdd[k] == right[k % UPPER_NV];
    }
    std::printf("%d %d %d %d %d: %s\n", SOLVER_reason(status) == UPPER_NO_ANSWER, left > 0,
                none > 0, none + found == long(qdd.size()), SOLVER_failed_state(solver, 0),
                SOLVER_failure(solver));
  }
  if (rank == 0) SOLVER_end(solver);
  std::this_thread::sleep_for(std::chrono::milliseconds(rank == 1 ? 500 : 0));
  if (rank == 1) SOLVER_serve(solver);
  SOLVER_close(solver);
  MPI_Finalize();
}
