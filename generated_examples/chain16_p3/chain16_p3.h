// C interface of the solver chain16_p3: forward dynamics of "chain16" on 3 processes,
// emitted by adagen 0.1.0 (interface.h.j2). Do not edit: generate again.
#ifndef ADAGEN_CHAIN16_P3_H
#define ADAGEN_CHAIN16_P3_H

#ifdef ADAGEN_NO_MPI
#error "this solver runs on MPI processes: generate one with --procs 1 or --channel threads"
#endif
#include <mpi.h>

enum {
  CHAIN16_P3_PROCESSES = 3,
  CHAIN16_P3_JOINTS = 16,
  CHAIN16_P3_NQ = 16,  // numbers in q
  CHAIN16_P3_NV = 16,  // in v and qdd
  CHAIN16_P3_NTAU = 16  // in tau
};

// Index of each joint's first number in q, and in v, tau and qdd.
enum {
  CHAIN16_P3_Q_joint01 = 0,
  CHAIN16_P3_V_joint01 = 0,  // joint 0, "joint01": revolute, 1 in q, 1 in v
  CHAIN16_P3_Q_joint02 = 1,
  CHAIN16_P3_V_joint02 = 1,  // joint 1, "joint02": revolute, 1 in q, 1 in v
  CHAIN16_P3_Q_joint03 = 2,
  CHAIN16_P3_V_joint03 = 2,  // joint 2, "joint03": revolute, 1 in q, 1 in v
  CHAIN16_P3_Q_joint04 = 3,
  CHAIN16_P3_V_joint04 = 3,  // joint 3, "joint04": revolute, 1 in q, 1 in v
  CHAIN16_P3_Q_joint05 = 4,
  CHAIN16_P3_V_joint05 = 4,  // joint 4, "joint05": revolute, 1 in q, 1 in v
  CHAIN16_P3_Q_joint06 = 5,
  CHAIN16_P3_V_joint06 = 5,  // joint 5, "joint06": revolute, 1 in q, 1 in v
  CHAIN16_P3_Q_joint07 = 6,
  CHAIN16_P3_V_joint07 = 6,  // joint 6, "joint07": revolute, 1 in q, 1 in v
  CHAIN16_P3_Q_joint08 = 7,
  CHAIN16_P3_V_joint08 = 7,  // joint 7, "joint08": revolute, 1 in q, 1 in v
  CHAIN16_P3_Q_joint09 = 8,
  CHAIN16_P3_V_joint09 = 8,  // joint 8, "joint09": revolute, 1 in q, 1 in v
  CHAIN16_P3_Q_joint10 = 9,
  CHAIN16_P3_V_joint10 = 9,  // joint 9, "joint10": revolute, 1 in q, 1 in v
  CHAIN16_P3_Q_joint11 = 10,
  CHAIN16_P3_V_joint11 = 10,  // joint 10, "joint11": revolute, 1 in q, 1 in v
  CHAIN16_P3_Q_joint12 = 11,
  CHAIN16_P3_V_joint12 = 11,  // joint 11, "joint12": revolute, 1 in q, 1 in v
  CHAIN16_P3_Q_joint13 = 12,
  CHAIN16_P3_V_joint13 = 12,  // joint 12, "joint13": revolute, 1 in q, 1 in v
  CHAIN16_P3_Q_joint14 = 13,
  CHAIN16_P3_V_joint14 = 13,  // joint 13, "joint14": revolute, 1 in q, 1 in v
  CHAIN16_P3_Q_joint15 = 14,
  CHAIN16_P3_V_joint15 = 14,  // joint 14, "joint15": revolute, 1 in q, 1 in v
  CHAIN16_P3_Q_joint16 = 15,
  CHAIN16_P3_V_joint16 = 15  // joint 15, "joint16": revolute, 1 in q, 1 in v
};

// Reasons of failures: chain16_p3_reason gives that of a status.
enum {
  CHAIN16_P3_FINE = 0,  // none
  CHAIN16_P3_NOT_FINITE = 1,  // q, v or tau of a joint is not a finite number
  CHAIN16_P3_ZERO_QUATERNION = 2,  // a joint's quaternion cannot be normalised
  CHAIN16_P3_FACTORIZATION = 3,  // inertias beside a joint differ too much for the scalar
  CHAIN16_P3_OVERFLOW = 4,  // a joint's acceleration is not a finite number
  CHAIN16_P3_NO_ANSWER = 5,  // a process did not answer within the time limit
  CHAIN16_P3_ENDED = 6,  // process 0 has ended the evaluations
  CHAIN16_P3_NOT_REFINED = 7,  // refinement does not converge
  CHAIN16_P3_GIMBAL_LOCK = 8,  // gimbal lock of joints that are joined as one
  CHAIN16_P3_GROWTH = 9,  // a link beside a joint is too light for its neighbours
  CHAIN16_P3_NOT_SET = 16,  // a value is not finite, a mass not positive, or the constant cannot be set
  CHAIN16_P3_TOO_FEW_STEPS = 11,  // refinement converges too slowly
  CHAIN16_P3_LOOP_OPEN = 12,  // a loop or coupling is not closed in this configuration
  CHAIN16_P3_LOOP_TORN = 13,  // the velocity violates a loop or coupling
  CHAIN16_P3_LOOP_SINGULAR = 14,  // the rank of the loop constraints changes in this pose
  CHAIN16_P3_LOOP_FREE = 15  // the loops allow a motion of a joint that has no inertia
};

#ifdef __cplusplus
extern "C" {
#endif
typedef struct chain16_p3_solver chain16_p3_solver;

// Gives name, first index and size in q and v of joint k; pointers may be null. Returns 0 if there is
// no joint k.
int chain16_p3_joint(int k, const char** name, int* q, int* nq, int* v, int* nv);

// Collective over a communicator of 3 processes. channel: "auto", "window" (shared memory) or
// "message", the same on all; time_limit: seconds that a process waits for another; if one does not
// answer, no later call is answered. Close it before MPI_Finalize. Returns null on failure, on all
// processes; chain16_p3_failure(NULL) gives the reason.
chain16_p3_solver* chain16_p3_open(MPI_Comm comm, const char* channel, double time_limit);

// One evaluation, collective. q: 16 numbers, v and tau: 16 each, qdd: 16; joints in order, quaternions
// x y z w (normalised here), floating joints [linear; angular] in the body's frame; arrays do not
// overlap.
// solve: every process passes the state and gets its own joints' accelerations (others untouched);
// solve_at_root: process 0 passes the state and gets all; the others may pass null, or call serve.
// Returns 0, or a status that chain16_p3_failure explains; then no acceleration is written.
int chain16_p3_solve(chain16_p3_solver* solver, const double* q, const double* v, const double* tau, double* qdd);
int chain16_p3_solve_at_root(chain16_p3_solver* solver, const double* q, const double* v, const double* tau, double* qdd);

// For all processes but 0: joins every solve_at_root of process 0, and waits between them without a
// time limit, until process 0 calls end. Returns 0 then, or the status of a failure.
int chain16_p3_serve(chain16_p3_solver* solver);

// At process 0: makes serve return at the others, which may serve again, or all close.
int chain16_p3_end(chain16_p3_solver* solver);

// Reason of a status, and the joint that it is about, -1 for none.
int chain16_p3_reason(int status);
int chain16_p3_failed_joint(int status);

// Text of a solver's last failure, valid until its next call; for null, the reason why the last open
// of this thread failed.
const char* chain16_p3_failure(const chain16_p3_solver* solver);

// Collective.
void chain16_p3_close(chain16_p3_solver* solver);
#ifdef __cplusplus
}
#endif
#endif
