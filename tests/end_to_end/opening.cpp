// An MPI program around an emitted solver for two processes, here named SOLVER: what cannot be
// opened is told to all processes, and what a late process is told as. A line for each fact.
#include <mpi.h>

#include <chrono>
#include <cstdio>
#include <thread>

#include "SOLVER.h"

namespace {

int rank = 0;

void refuse(const char* what, MPI_Comm comm, const char* channel, double time_limit) {
  const SOLVER_solver* const solver = SOLVER_open(comm, channel, time_limit);
  std::printf("%s %d %d: %s\n", what, rank, solver == nullptr, SOLVER_failure(nullptr));
}

// Process 1 comes late; the first failure and those after it name the process that was late.
void be_late(SOLVER_solver* solver) {
  double q[UPPER_NQ] = {}, v[UPPER_NV] = {}, tau[UPPER_NTAU] = {}, qdd[UPPER_NV];
  for (int again = 0; again < 2 && rank == 0; ++again) {
    const int status = SOLVER_solve_at_root(solver, q, v, tau, qdd);
    std::printf("late %d: %s\n", SOLVER_reason(status) == UPPER_NO_ANSWER, SOLVER_failure(solver));
  }
  if (rank == 0) SOLVER_end(solver);
  std::this_thread::sleep_for(std::chrono::milliseconds(rank == 1 ? 400 : 0));
  if (rank == 1) SOLVER_serve(solver);
  SOLVER_close(solver);
}

}  // namespace

int main(int count, char** words) {
  MPI_Init(&count, &words);
  MPI_Comm_rank(MPI_COMM_WORLD, &rank);
  MPI_Comm alone, between;
  MPI_Comm_split(MPI_COMM_WORLD, rank, 0, &alone);
  MPI_Intercomm_create(alone, 0, MPI_COMM_WORLD, 1 - rank, 7, &between);
  refuse("null", MPI_COMM_NULL, "auto", 1);
  refuse("between", between, "auto", 1);
  refuse("channels", MPI_COMM_WORLD, rank == 0 ? "message" : "window", 1);
  refuse("word", MPI_COMM_WORLD, rank == 0 ? "pigeon" : "auto", 1);
  refuse("limit", MPI_COMM_WORLD, "auto", rank == 0 ? 1 : 0);
  std::printf("joint %d\n", SOLVER_joint(0, nullptr, nullptr, nullptr, nullptr, nullptr));
  be_late(SOLVER_open(MPI_COMM_WORLD, "auto", 0.2));
  MPI_Finalize();
  refuse("after", MPI_COMM_WORLD, "auto", 1);
}
