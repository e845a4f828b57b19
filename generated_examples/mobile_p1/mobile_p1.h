// C interface of the solver mobile_p1: forward dynamics of "mobile" on 1 process,
// emitted by adagen 0.1.0 (interface.h.j2). Do not edit: generate again.
#ifndef ADAGEN_MOBILE_P1_H
#define ADAGEN_MOBILE_P1_H

enum {
  MOBILE_P1_PROCESSES = 1,
  MOBILE_P1_JOINTS = 6,
  MOBILE_P1_NQ = 14,  // numbers in q
  MOBILE_P1_NV = 13,  // in v and qdd
  MOBILE_P1_NTAU = 13  // in tau
};

// Index of each joint's first number in q, and in v, tau and qdd.
enum {
  MOBILE_P1_Q_drive = 0,
  MOBILE_P1_V_drive = 0,  // joint 0, "drive": planar, 3 in q, 3 in v
  MOBILE_P1_Q_laser_spin = 3,
  MOBILE_P1_V_laser_spin = 3,  // joint 1, "laser_spin": revolute, 1 in q, 1 in v
  MOBILE_P1_Q_lift = 4,
  MOBILE_P1_V_lift = 4,  // joint 2, "lift": prismatic, 1 in q, 1 in v
  MOBILE_P1_Q_shoulder = 5,
  MOBILE_P1_V_shoulder = 5,  // joint 3, "shoulder": revolute, 1 in q, 1 in v
  MOBILE_P1_Q_wrist = 6,
  MOBILE_P1_V_wrist = 6,  // joint 4, "wrist": revolute, 1 in q, 1 in v
  MOBILE_P1_Q_loose = 7,
  MOBILE_P1_V_loose = 7  // joint 5, "loose": floating, 7 in q, 6 in v
};

// Reasons of failures: mobile_p1_reason gives that of a status.
enum {
  MOBILE_P1_FINE = 0,  // none
  MOBILE_P1_NOT_FINITE = 1,  // q, v or tau of a joint is not a finite number
  MOBILE_P1_ZERO_QUATERNION = 2,  // a joint's quaternion cannot be normalised
  MOBILE_P1_FACTORIZATION = 3,  // inertias beside a joint differ too much for the scalar
  MOBILE_P1_OVERFLOW = 4,  // a joint's acceleration is not a finite number
  MOBILE_P1_NO_ANSWER = 5,  // a process did not answer within the time limit
  MOBILE_P1_ENDED = 6,  // process 0 has ended the evaluations
  MOBILE_P1_NOT_REFINED = 7,  // refinement does not converge
  MOBILE_P1_GIMBAL_LOCK = 8,  // gimbal lock of joints that are joined as one
  MOBILE_P1_GROWTH = 9,  // a link beside a joint is too light for its neighbours
  MOBILE_P1_NOT_SET = 16,  // a value is not finite, a mass not positive, or the constant cannot be set
  MOBILE_P1_TOO_FEW_STEPS = 11,  // refinement converges too slowly
  MOBILE_P1_LOOP_OPEN = 12,  // a loop or coupling is not closed in this configuration
  MOBILE_P1_LOOP_TORN = 13,  // the velocity violates a loop or coupling
  MOBILE_P1_LOOP_SINGULAR = 14,  // the rank of the loop constraints changes in this pose
  MOBILE_P1_LOOP_FREE = 15  // the loops allow a motion of a joint that has no inertia
};

#ifdef __cplusplus
extern "C" {
#endif
typedef struct mobile_p1_solver mobile_p1_solver;

// Gives name, first index and size in q and v of joint k; pointers may be null. Returns 0 if there is
// no joint k.
int mobile_p1_joint(int k, const char** name, int* q, int* nq, int* v, int* nv);

// A solver; allocates all its memory: no other call allocates, waits or locks. One thread at a time
// may use a solver. Returns null if there is no memory; mobile_p1_failure(NULL) says so.
mobile_p1_solver* mobile_p1_open(void);

// One evaluation. q: 14 numbers, v and tau: 13 each, qdd: 13; joints in order, quaternions
// x y z w (normalised here), floating joints [linear; angular] in the body's frame; arrays do not
// overlap.
// Returns 0, or a status that mobile_p1_failure explains; then no acceleration is written.
int mobile_p1_solve(mobile_p1_solver* solver, const double* q, const double* v, const double* tau, double* qdd);

// Reason of a status, and the joint that it is about, -1 for none.
int mobile_p1_reason(int status);
int mobile_p1_failed_joint(int status);

// Text of a solver's last failure, valid until its next call; for null, the reason why the last open
// of this thread failed.
const char* mobile_p1_failure(const mobile_p1_solver* solver);

void mobile_p1_close(mobile_p1_solver* solver);
#ifdef __cplusplus
}
#endif
#endif
