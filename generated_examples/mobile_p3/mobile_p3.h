// C interface of the solver mobile_p3: forward dynamics of "mobile" on 3 processes,
// emitted by adagen 0.1.0 (interface.h.j2). Do not edit: generate again.
#ifndef ADAGEN_MOBILE_P3_H
#define ADAGEN_MOBILE_P3_H

#ifdef ADAGEN_NO_MPI
#error "this solver runs on MPI processes: generate one with --procs 1 or --channel threads"
#endif
#include <mpi.h>

enum {
  MOBILE_P3_PROCESSES = 3,
  MOBILE_P3_JOINTS = 6,
  MOBILE_P3_NQ = 14,  // numbers in q
  MOBILE_P3_NV = 13,  // in v and qdd
  MOBILE_P3_NTAU = 13  // in tau
};

// Index of each joint's first number in q, and in v, tau and qdd.
enum {
  MOBILE_P3_Q_drive = 0,
  MOBILE_P3_V_drive = 0,  // joint 0, "drive": planar, 3 in q, 3 in v
  MOBILE_P3_Q_laser_spin = 3,
  MOBILE_P3_V_laser_spin = 3,  // joint 1, "laser_spin": revolute, 1 in q, 1 in v
  MOBILE_P3_Q_lift = 4,
  MOBILE_P3_V_lift = 4,  // joint 2, "lift": prismatic, 1 in q, 1 in v
  MOBILE_P3_Q_shoulder = 5,
  MOBILE_P3_V_shoulder = 5,  // joint 3, "shoulder": revolute, 1 in q, 1 in v
  MOBILE_P3_Q_wrist = 6,
  MOBILE_P3_V_wrist = 6,  // joint 4, "wrist": revolute, 1 in q, 1 in v
  MOBILE_P3_Q_loose = 7,
  MOBILE_P3_V_loose = 7  // joint 5, "loose": floating, 7 in q, 6 in v
};

// Reasons of failures: mobile_p3_reason gives that of a status.
enum {
  MOBILE_P3_FINE = 0,  // none
  MOBILE_P3_NOT_FINITE = 1,  // q, v or tau of a joint is not a finite number
  MOBILE_P3_ZERO_QUATERNION = 2,  // a joint's quaternion cannot be normalised
  MOBILE_P3_FACTORIZATION = 3,  // inertias beside a joint differ too much for the scalar
  MOBILE_P3_OVERFLOW = 4,  // a joint's acceleration is not a finite number
  MOBILE_P3_NO_ANSWER = 5,  // a process did not answer within the time limit
  MOBILE_P3_ENDED = 6,  // process 0 has ended the evaluations
  MOBILE_P3_NOT_REFINED = 7,  // refinement does not converge
  MOBILE_P3_GIMBAL_LOCK = 8,  // gimbal lock of joints that are joined as one
  MOBILE_P3_GROWTH = 9,  // a link beside a joint is too light for its neighbours
  MOBILE_P3_NOT_SET = 16,  // a value is not finite, a mass not positive, or the constant cannot be set
  MOBILE_P3_TOO_FEW_STEPS = 11,  // refinement converges too slowly
  MOBILE_P3_LOOP_OPEN = 12,  // a loop or coupling is not closed in this configuration
  MOBILE_P3_LOOP_TORN = 13,  // the velocity violates a loop or coupling
  MOBILE_P3_LOOP_SINGULAR = 14,  // the rank of the loop constraints changes in this pose
  MOBILE_P3_LOOP_FREE = 15  // the loops allow a motion of a joint that has no inertia
};

#ifdef __cplusplus
extern "C" {
#endif
typedef struct mobile_p3_solver mobile_p3_solver;

// Gives name, first index and size in q and v of joint k; pointers may be null. Returns 0 if there is
// no joint k.
int mobile_p3_joint(int k, const char** name, int* q, int* nq, int* v, int* nv);

// Collective over a communicator of 3 processes. channel: "auto", "window" (shared memory) or
// "message", the same on all; time_limit: seconds that a process waits for another; if one does not
// answer, no later call is answered. Close it before MPI_Finalize. Returns null on failure, on all
// processes; mobile_p3_failure(NULL) gives the reason.
mobile_p3_solver* mobile_p3_open(MPI_Comm comm, const char* channel, double time_limit);

// One evaluation, collective. q: 14 numbers, v and tau: 13 each, qdd: 13; joints in order, quaternions
// x y z w (normalised here), floating joints [linear; angular] in the body's frame; arrays do not
// overlap.
// solve: every process passes the state and gets its own joints' accelerations (others untouched);
// solve_at_root: process 0 passes the state and gets all; the others may pass null, or call serve.
// Returns 0, or a status that mobile_p3_failure explains; then no acceleration is written.
int mobile_p3_solve(mobile_p3_solver* solver, const double* q, const double* v, const double* tau, double* qdd);
int mobile_p3_solve_at_root(mobile_p3_solver* solver, const double* q, const double* v, const double* tau, double* qdd);

// For all processes but 0: joins every solve_at_root of process 0, and waits between them without a
// time limit, until process 0 calls end. Returns 0 then, or the status of a failure.
int mobile_p3_serve(mobile_p3_solver* solver);

// At process 0: makes serve return at the others, which may serve again, or all close.
int mobile_p3_end(mobile_p3_solver* solver);

// Reason of a status, and the joint that it is about, -1 for none.
int mobile_p3_reason(int status);
int mobile_p3_failed_joint(int status);

// Text of a solver's last failure, valid until its next call; for null, the reason why the last open
// of this thread failed.
const char* mobile_p3_failure(const mobile_p3_solver* solver);

// Collective.
void mobile_p3_close(mobile_p3_solver* solver);
#ifdef __cplusplus
}
#endif
#endif
