/* A C99 program around an emitted solver for one process: reads states (numbers in text) and prints
   the accelerations, or how a call failed. */
#include <stdio.h>

#include "SOLVER.h"

int main(int count, char** words) {
  double q[UPPER_NQ], v[UPPER_NV], tau[UPPER_NTAU], qdd[UPPER_NV];
  FILE* file = fopen(words[count - 1], "r");
  SOLVER_solver* solver = SOLVER_open();
  int k;
  if (file == NULL || solver == NULL) return 1;
  for (;;) {
    int status, read = 0;
    for (k = 0; k < UPPER_NQ; ++k) read += fscanf(file, "%lf", &q[k]);
    for (k = 0; k < UPPER_NV; ++k) read += fscanf(file, "%lf", &v[k]);
    for (k = 0; k < UPPER_NTAU; ++k) read += fscanf(file, "%lf", &tau[k]);
    if (read != UPPER_NQ + UPPER_NV + UPPER_NTAU) break;
    status = SOLVER_solve(solver, q, v, tau, qdd);
    if (SOLVER_reason(status) != UPPER_FINE)
      printf("%d %d %s\n", SOLVER_reason(status) == UPPER_NOT_FINITE, SOLVER_failed_joint(status),
             SOLVER_failure(solver));
    else
      for (k = 0; k < UPPER_NV; ++k) printf("%.17g%s", qdd[k], k + 1 < UPPER_NV ? " " : "\n");
  }
  SOLVER_close(solver);
  fclose(file);
  return 0;
}
