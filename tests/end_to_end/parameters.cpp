// An MPI program around an emitted solver, here named SOLVER: gravity is set at process 0 alone,
// and at each process. Words: channel. Process 0 prints accelerations.
#include <mpi.h>

#include <cmath>
#include <cstdio>

#include "SOLVER.h"

int main(int count, char** words) {
  MPI_Init(&count, &words);
  int rank = 0;
  MPI_Comm_rank(MPI_COMM_WORLD, &rank);
  SOLVER_solver* const solver = SOLVER_open(MPI_COMM_WORLD, "auto", 20);
  double q[UPPER_NQ], v[UPPER_NV], tau[UPPER_NTAU], qdd[UPPER_NV], all[UPPER_NV];
  for (double& x : q) x = 0.3;
  for (double& x : v) x = 0.2;
  for (double& x : tau) x = 0.1;
  const double moon[3] = {0.1, -0.2, -1.62}, sideways[3] = {9.81, 0, 0};
  const double wrong[3] = {0, 0, INFINITY};
  const auto print = [&](const double* numbers) {
    for (int k = 0; k < UPPER_NV && rank == 0; ++k) std::printf("%.17g ", numbers[k]);
    if (rank == 0) std::printf("\n");
  };
  if (rank == 0) {
    SOLVER_SOLVE_at_root(solver, COUNT q, v, tau, qdd);
    print(qdd);
    SOLVER_set_gravity(solver, moon);
    const int status = SOLVER_set_gravity(solver, wrong);
    std::printf("%d %s\n", SOLVER_reason(status) == UPPER_NOT_SET, SOLVER_failure(solver));
    SOLVER_SOLVE_at_root(solver, COUNT q, v, tau, qdd);
    print(qdd);
    const double center[3] = {0.1, -0.02, 0.03}, nowhere[3] = {NAN, 0, 0};
    std::printf("%d ", SOLVER_set_mass(solver, UPPER_LINK_hand, 2.5));
    std::printf("%d ", SOLVER_set_center(solver, UPPER_LINK_hand, center));
    std::printf("%d ", SOLVER_reason(SOLVER_set_center(solver, UPPER_LINK_hand, nowhere)));
    std::printf("%d ", SOLVER_reason(SOLVER_set_mass(solver, UPPER_LINK_hand, -1)));
    std::printf("%d\n", SOLVER_reason(SOLVER_set_mass(solver, 1, 2.5)));
    SOLVER_SOLVE_at_root(solver, COUNT q, v, tau, qdd);
    print(qdd);
    SOLVER_end(solver);
  } else {
    SOLVER_serve(solver);
  }
  SOLVER_set_gravity(solver, sideways);
  for (double& x : qdd) x = 0;
  SOLVER_SOLVE(solver, COUNT q, v, tau, qdd);
  MPI_Reduce(qdd, all, UPPER_NV, MPI_DOUBLE, MPI_SUM, 0, MPI_COMM_WORLD);
  print(all);
  SOLVER_close(solver);
  MPI_Finalize();
}
