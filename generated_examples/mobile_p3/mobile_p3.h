// C interface of the solver mobile_p3: forward dynamics of "mobile" on 3 processes,
// emitted by adagen 0.1.0 (interface.h.j2). Do not edit: emit anew.
#ifndef ADAGEN_MOBILE_P3_H
#define ADAGEN_MOBILE_P3_H

#include <mpi.h>

enum {
  MOBILE_P3_PROCESSES = 3,
  MOBILE_P3_JOINTS = 6,
  MOBILE_P3_NQ = 14,  // numbers in q
  MOBILE_P3_NV = 13,  // in v and qdd
  MOBILE_P3_NTAU = 13  // in tau
};

// Where each joint begins in q, and in v, tau and qdd.
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

// Why a call failed, as mobile_p3_reason tells of the status that it returned.
enum {
  MOBILE_P3_FINE = 0,  // none
  MOBILE_P3_NOT_FINITE = 1,  // q, v or tau of a joint is not a finite number
  MOBILE_P3_ZERO_QUATERNION = 2,  // a joint's quaternion cannot be normalised
  MOBILE_P3_FACTORIZATION = 3,  // inertias beside a joint differ too much for the scalar
  MOBILE_P3_OVERFLOW = 4,  // a joint's acceleration is not a finite number
  MOBILE_P3_NO_ANSWER = 5,  // a process did not answer within the time limit
  MOBILE_P3_ENDED = 6,  // process 0 has ended the evaluations
  MOBILE_P3_NOT_REFINED = 7,  // refinement does not converge
  MOBILE_P3_GIMBAL_LOCK = 8,  // joints that are joined as one do not move in as many directions
  MOBILE_P3_GROWTH = 9,  // a link beside a joint is too light for its neighbours
  MOBILE_P3_NOT_SET = 16,  // what is to be set at run time is not finite, or is no mass
  MOBILE_P3_TOO_FEW_STEPS = 11,  // refinement converges too slowly
  MOBILE_P3_LOOP_OPEN = 12,  // a loop or coupling is not closed in this configuration
  MOBILE_P3_LOOP_TORN = 13,  // this velocity tears a loop or coupling open
  MOBILE_P3_LOOP_SINGULAR = 14,  // what a loop holds changes in this pose
  MOBILE_P3_LOOP_FREE = 15  // loops leave a joint a motion that no inertia resists
};

#ifdef __cplusplus
extern "C" {
#endif
typedef struct mobile_p3_solver mobile_p3_solver;

// Joints in order, each with its place in the state: gives name, start and size in q and v of joint
// k, or returns 0 where there is none.
int mobile_p3_joint(int k, const char** name, int* q, int* nq, int* v, int* nv);

// Collective over a communicator of 3 processes. channel: "auto", "window" (shared memory) or
// "message"; time_limit: seconds that a process waits for another. Returns null where it cannot be
// done; mobile_p3_failure(NULL) says why.
mobile_p3_solver* mobile_p3_open(MPI_Comm comm, const char* channel, double time_limit);

// One evaluation, collective. q: 14 numbers, v and tau: 13 each, qdd: 13; joints in order, quaternions
// x y z w (normalised here), floating joints [linear; angular] in the body's frame.
// solve: every process passes the state and gets its own joints' accelerations (others untouched);
// solve_at_root: process 0 passes the state and gets them all, the others may pass null, or serve.
// Returns 0, or a status that mobile_p3_failure puts into words; no acceleration is written then.
int mobile_p3_solve(mobile_p3_solver* solver, const double* q, const double* v, const double* tau, double* qdd);
int mobile_p3_solve_at_root(mobile_p3_solver* solver, const double* q, const double* v, const double* tau, double* qdd);

// What every process but 0 can do all the time: takes part in each solve_at_root of process 0, however
// long that lets it wait, until process 0 ends it. Returns 0, or why it cannot go on.
int mobile_p3_serve(mobile_p3_solver* solver);

// At process 0: the others' serve returns. They may serve again, or all close.
int mobile_p3_end(mobile_p3_solver* solver);

// What a status says: its reason, and which joint it is about, -1 for none.
int mobile_p3_reason(int status);
int mobile_p3_failed_joint(int status);

// The last failure of a solver in words, valid until the next call; of null, why the last open of this
// thread returned null.
const char* mobile_p3_failure(const mobile_p3_solver* solver);

// Collective.
void mobile_p3_close(mobile_p3_solver* solver);
#ifdef __cplusplus
}
#endif
#endif
