// C interface of the solver fourbar_p1: forward dynamics of "fourbar" on 1 process,
// emitted by adagen 0.1.0 (interface.h.j2). Do not edit: emit anew.
#ifndef ADAGEN_FOURBAR_P1_H
#define ADAGEN_FOURBAR_P1_H

enum {
  FOURBAR_P1_PROCESSES = 1,
  FOURBAR_P1_JOINTS = 3,
  FOURBAR_P1_NQ = 3,  // numbers in q
  FOURBAR_P1_NV = 3,  // in v and qdd
  FOURBAR_P1_NTAU = 3  // in tau
};

// Where each joint begins in q, and in v, tau and qdd.
enum {
  FOURBAR_P1_Q_crank_pin = 0,
  FOURBAR_P1_V_crank_pin = 0,  // joint 0, "crank_pin": revolute, 1 in q, 1 in v
  FOURBAR_P1_Q_coupler_pin = 1,
  FOURBAR_P1_V_coupler_pin = 1,  // joint 1, "coupler_pin": revolute, 1 in q, 1 in v
  FOURBAR_P1_Q_rocker_pin = 2,
  FOURBAR_P1_V_rocker_pin = 2  // joint 2, "rocker_pin": revolute, 1 in q, 1 in v
};

// Why a call failed, as fourbar_p1_reason tells of the status that it returned.
enum {
  FOURBAR_P1_FINE = 0,  // none
  FOURBAR_P1_NOT_FINITE = 1,  // q, v or tau of a joint is not a finite number
  FOURBAR_P1_ZERO_QUATERNION = 2,  // a joint's quaternion cannot be normalised
  FOURBAR_P1_FACTORIZATION = 3,  // inertias beside a joint differ too much for the scalar
  FOURBAR_P1_OVERFLOW = 4,  // a joint's acceleration is not a finite number
  FOURBAR_P1_NO_ANSWER = 5,  // a process did not answer within the time limit
  FOURBAR_P1_ENDED = 6,  // process 0 has ended the evaluations
  FOURBAR_P1_NOT_REFINED = 7,  // refinement does not converge
  FOURBAR_P1_GIMBAL_LOCK = 8,  // joints that are joined as one do not move in as many directions
  FOURBAR_P1_GROWTH = 9,  // a link beside a joint is too light for its neighbours
  FOURBAR_P1_NOT_SET = 16,  // what is to be set at run time is not finite, or is no mass
  FOURBAR_P1_TOO_FEW_STEPS = 11,  // refinement converges too slowly
  FOURBAR_P1_LOOP_OPEN = 12,  // a loop or coupling is not closed in this configuration
  FOURBAR_P1_LOOP_TORN = 13,  // this velocity tears a loop or coupling open
  FOURBAR_P1_LOOP_SINGULAR = 14,  // what a loop holds changes in this pose
  FOURBAR_P1_LOOP_FREE = 15  // loops leave a joint a motion that no inertia resists
};

#ifdef __cplusplus
extern "C" {
#endif
typedef struct fourbar_p1_solver fourbar_p1_solver;

// Joints in order, each with its place in the state: gives name, start and size in q and v of joint
// k, or returns 0 where there is none.
int fourbar_p1_joint(int k, const char** name, int* q, int* nq, int* v, int* nv);

// A solver, with all the memory that it will ever need: no other call allocates, waits or takes a
// lock. One solver is for one thread at a time. Returns null where there is no memory;
// fourbar_p1_failure(NULL) says so.
fourbar_p1_solver* fourbar_p1_open(void);

// One evaluation. q: 3 numbers, v and tau: 3 each, qdd: 3; joints in order, quaternions
// x y z w (normalised here), floating joints [linear; angular] in the body's frame.
// Returns 0, or a status that fourbar_p1_failure puts into words; no acceleration is written then.
int fourbar_p1_solve(fourbar_p1_solver* solver, const double* q, const double* v, const double* tau, double* qdd);

// What a status says: its reason, and which joint it is about, -1 for none.
int fourbar_p1_reason(int status);
int fourbar_p1_failed_joint(int status);

// The last failure of a solver in words, valid until the next call; of null, why the last open of this
// thread returned null.
const char* fourbar_p1_failure(const fourbar_p1_solver* solver);

void fourbar_p1_close(fourbar_p1_solver* solver);
#ifdef __cplusplus
}
#endif
#endif
