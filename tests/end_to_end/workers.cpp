// An MPI program around an emitted solver, here named SOLVER: process 0 asks, the others serve,
// twice. Each process says how that went for it; process 0 prints accelerations.
#include <mpi.h>

#include <chrono>
#include <cmath>
#include <cstdio>
#include <thread>

#include "SOLVER.h"

int main(int count, char** words) {
  MPI_Init(&count, &words);
  int rank = 0;
  MPI_Comm_rank(MPI_COMM_WORLD, &rank);
  SOLVER_solver* const solver = SOLVER_open(MPI_COMM_WORLD, words[1], 0.3);
  double q[UPPER_NQ], v[UPPER_NV], tau[UPPER_NTAU], qdd[UPPER_NV];
  for (double& x : q) x = 0.3;
  for (double& x : v) x = 0.2;
  for (double& x : tau) x = 0.1;
  for (int turn = 0; turn < 2; ++turn) {
    if (rank > 0) {
      std::printf("process %d served %d\n", rank, SOLVER_serve(solver));
      continue;
    }
    for (int k = 0; k < 3; ++k) {
      v[0] = k == 1 ? std::nan("") : 0.2;
      // Longer than a process waits for another; one that serves waits as long as it takes.
      std::this_thread::sleep_for(std::chrono::milliseconds(500));
      const int status = SOLVER_SOLVE(solver, COUNT q, v, tau, qdd);
      std::printf("process 0 asked %d", SOLVER_reason(status) == UPPER_FINE);
      for (const double x : qdd) std::printf(" %.17g", x);
      std::printf("\n");
    }
    std::printf("process 0 ended %d\n", SOLVER_end(solver));
  }
  SOLVER_close(solver);
  MPI_Finalize();
}
