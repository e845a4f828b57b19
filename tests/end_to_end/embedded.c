/* A C99 program around an embedded solver, here named SOLVER: its memory begins at an odd address,
   with bytes in front and behind that nobody may touch. Reads states (numbers in text) and prints
   the accelerations, or how a call failed. */
#include <stdio.h>
#include <string.h>

#include "SOLVER.h"

enum { GUARD = 65 };
static unsigned char memory[GUARD + UPPER_BYTES + GUARD];

static int read_numbers(FILE* file, NUMBER* numbers, int count) {
  int k, read = 0;
  double x;
  for (k = 0; k < count; ++k)
    if (fscanf(file, "%lf", &x) == 1) numbers[k] = (NUMBER)x, ++read;
  return read == count;
}

int main(int count, char** words) {
  NUMBER q[UPPER_NQ], v[UPPER_NV], tau[UPPER_NTAU], qdd[UPPER_NV];
  FILE* file = fopen(words[count - 1], "r");
  SOLVER_solver* solver;
  int k;
  memset(memory, 0x5A, sizeof memory);
  if (file == NULL || SOLVER_open(NULL, UPPER_BYTES) || SOLVER_open(memory, UPPER_BYTES - 1))
    return 1;
  printf("%s\n", SOLVER_failure(NULL));
  solver = SOLVER_open(memory + GUARD, UPPER_BYTES);
  while (read_numbers(file, q, UPPER_NQ) && read_numbers(file, v, UPPER_NV) &&
         read_numbers(file, tau, UPPER_NTAU)) {
    const int status = SOLVER_solve(solver, q, v, tau, qdd);
    if (SOLVER_reason(status) != UPPER_FINE)
      printf("%d %d %s\n", SOLVER_reason(status) == UPPER_NOT_FINITE, SOLVER_failed_joint(status),
             SOLVER_failure(solver));
    else
      for (k = 0; k < UPPER_NV; ++k) printf("%.17g%s", qdd[k], k + 1 < UPPER_NV ? " " : "\n");
  }
  SOLVER_close(solver);
  for (k = 0; k < GUARD; ++k)
    if (memory[k] != 0x5A || memory[GUARD + UPPER_BYTES + k] != 0x5A) return 2;
  fclose(file);
  return 0;
}
