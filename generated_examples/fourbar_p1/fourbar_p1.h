// C interface of the solver fourbar_p1: forward dynamics of "fourbar" on 1 process,
// emitted by adagen 0.1.0 (interface.h.j2). Do not edit: generate again.
#ifndef ADAGEN_FOURBAR_P1_H
#define ADAGEN_FOURBAR_P1_H

enum {
  FOURBAR_P1_PROCESSES = 1,
  FOURBAR_P1_JOINTS = 3,
  FOURBAR_P1_NQ = 3,  // numbers in q
  FOURBAR_P1_NV = 3,  // in v and qdd
  FOURBAR_P1_NTAU = 3  // in tau
};

// Index of each joint's first number in q, and in v, tau and qdd.
enum {
  FOURBAR_P1_Q_crank_pin = 0,
  FOURBAR_P1_V_crank_pin = 0,  // joint 0, "crank_pin": revolute, 1 in q, 1 in v
  FOURBAR_P1_Q_coupler_pin = 1,
  FOURBAR_P1_V_coupler_pin = 1,  // joint 1, "coupler_pin": revolute, 1 in q, 1 in v
  FOURBAR_P1_Q_rocker_pin = 2,
  FOURBAR_P1_V_rocker_pin = 2  // joint 2, "rocker_pin": revolute, 1 in q, 1 in v
};

// Reasons of failures: fourbar_p1_reason gives that of a status.
enum {
  FOURBAR_P1_FINE = 0,  // none
  FOURBAR_P1_NOT_FINITE = 1,  // q, v or tau of a joint is not a finite number
  FOURBAR_P1_ZERO_QUATERNION = 2,  // a joint's quaternion cannot be normalised
  FOURBAR_P1_FACTORIZATION = 3,  // inertias beside a joint differ too much for the scalar
  FOURBAR_P1_OVERFLOW = 4,  // a joint's acceleration is not a finite number
  FOURBAR_P1_NO_ANSWER = 5,  // a process did not answer within the time limit
  FOURBAR_P1_ENDED = 6,  // process 0 has ended the evaluations
  FOURBAR_P1_NOT_REFINED = 7,  // refinement does not converge
  FOURBAR_P1_GIMBAL_LOCK = 8,  // gimbal lock of joints that are joined as one
  FOURBAR_P1_GROWTH = 9,  // a link beside a joint is too light for its neighbours
  FOURBAR_P1_NOT_SET = 16,  // a value is not finite, a mass not positive, or the constant cannot be set
  FOURBAR_P1_TOO_FEW_STEPS = 11,  // refinement converges too slowly
  FOURBAR_P1_LOOP_OPEN = 12,  // a loop or coupling is not closed in this configuration
  FOURBAR_P1_LOOP_TORN = 13,  // the velocity violates a loop or coupling
  FOURBAR_P1_LOOP_SINGULAR = 14,  // the rank of the loop constraints changes in this pose
  FOURBAR_P1_LOOP_FREE = 15  // the loops allow a motion of a joint that has no inertia
};

#ifdef __cplusplus
extern "C" {
#endif
typedef struct fourbar_p1_solver fourbar_p1_solver;

// Gives name, first index and size in q and v of joint k; pointers may be null. Returns 0 if there is
// no joint k.
int fourbar_p1_joint(int k, const char** name, int* q, int* nq, int* v, int* nv);

// A solver; allocates all its memory: no other call allocates, waits or locks. One thread at a time
// may use a solver. Returns null if there is no memory; fourbar_p1_failure(NULL) says so.
fourbar_p1_solver* fourbar_p1_open(void);

// One evaluation. q: 3 numbers, v and tau: 3 each, qdd: 3; joints in order, quaternions
// x y z w (normalised here), floating joints [linear; angular] in the body's frame; arrays do not
// overlap.
// Returns 0, or a status that fourbar_p1_failure explains; then no acceleration is written.
int fourbar_p1_solve(fourbar_p1_solver* solver, const double* q, const double* v, const double* tau, double* qdd);

// Reason of a status, and the joint that it is about, -1 for none.
int fourbar_p1_reason(int status);
int fourbar_p1_failed_joint(int status);

// Text of a solver's last failure, valid until its next call; for null, the reason why the last open
// of this thread failed.
const char* fourbar_p1_failure(const fourbar_p1_solver* solver);

void fourbar_p1_close(fourbar_p1_solver* solver);
#ifdef __cplusplus
}
#endif
#endif
