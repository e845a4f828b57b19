// C interface of the solver ankle_p1: forward dynamics of "ankle" on 1 process,
// emitted by adagen 0.1.0 (interface.h.j2). Do not edit: generate again.
#ifndef ADAGEN_ANKLE_P1_H
#define ADAGEN_ANKLE_P1_H

enum {
  ANKLE_P1_PROCESSES = 1,
  ANKLE_P1_JOINTS = 8,
  ANKLE_P1_NQ = 14,  // numbers in q
  ANKLE_P1_NV = 12,  // in v and qdd
  ANKLE_P1_NTAU = 12  // in tau
};

// Index of each joint's first number in q, and in v, tau and qdd.
enum {
  ANKLE_P1_Q_hip = 0,
  ANKLE_P1_V_hip = 0,  // joint 0, "hip": revolute, 1 in q, 1 in v
  ANKLE_P1_Q_knee = 1,
  ANKLE_P1_V_knee = 1,  // joint 1, "knee": revolute, 1 in q, 1 in v
  ANKLE_P1_Q_ankle_pitch = 2,
  ANKLE_P1_V_ankle_pitch = 2,  // joint 2, "ankle_pitch": revolute, 1 in q, 1 in v
  ANKLE_P1_Q_ankle_roll = 3,
  ANKLE_P1_V_ankle_roll = 3,  // joint 3, "ankle_roll": revolute, 1 in q, 1 in v
  ANKLE_P1_Q_left_motor = 4,
  ANKLE_P1_V_left_motor = 4,  // joint 4, "left_motor": revolute, 1 in q, 1 in v
  ANKLE_P1_Q_left_ball = 5,
  ANKLE_P1_V_left_ball = 5,  // joint 5, "left_ball": spherical, 4 in q, 3 in v
  ANKLE_P1_Q_right_motor = 9,
  ANKLE_P1_V_right_motor = 8,  // joint 6, "right_motor": revolute, 1 in q, 1 in v
  ANKLE_P1_Q_right_ball = 10,
  ANKLE_P1_V_right_ball = 9  // joint 7, "right_ball": spherical, 4 in q, 3 in v
};

// Reasons of failures: ankle_p1_reason gives that of a status.
enum {
  ANKLE_P1_FINE = 0,  // none
  ANKLE_P1_NOT_FINITE = 1,  // q, v or tau of a joint is not a finite number
  ANKLE_P1_ZERO_QUATERNION = 2,  // a joint's quaternion cannot be normalised
  ANKLE_P1_FACTORIZATION = 3,  // inertias beside a joint differ too much for the scalar
  ANKLE_P1_OVERFLOW = 4,  // a joint's acceleration is not a finite number
  ANKLE_P1_NO_ANSWER = 5,  // a process did not answer within the time limit
  ANKLE_P1_ENDED = 6,  // process 0 has ended the evaluations
  ANKLE_P1_NOT_REFINED = 7,  // refinement does not converge
  ANKLE_P1_GIMBAL_LOCK = 8,  // gimbal lock of joints that are joined as one
  ANKLE_P1_GROWTH = 9,  // a link beside a joint is too light for its neighbours
  ANKLE_P1_NOT_SET = 16,  // a value is not finite, a mass not positive, or the constant cannot be set
  ANKLE_P1_TOO_FEW_STEPS = 11,  // refinement converges too slowly
  ANKLE_P1_LOOP_OPEN = 12,  // a loop or coupling is not closed in this configuration
  ANKLE_P1_LOOP_TORN = 13,  // the velocity violates a loop or coupling
  ANKLE_P1_LOOP_SINGULAR = 14,  // the rank of the loop constraints changes in this pose
  ANKLE_P1_LOOP_FREE = 15  // the loops allow a motion of a joint that has no inertia
};

#ifdef __cplusplus
extern "C" {
#endif
typedef struct ankle_p1_solver ankle_p1_solver;

// Gives name, first index and size in q and v of joint k; pointers may be null. Returns 0 if there is
// no joint k.
int ankle_p1_joint(int k, const char** name, int* q, int* nq, int* v, int* nv);

// A solver; allocates all its memory: no other call allocates, waits or locks. One thread at a time
// may use a solver. Returns null if there is no memory; ankle_p1_failure(NULL) says so.
ankle_p1_solver* ankle_p1_open(void);

// One evaluation. q: 14 numbers, v and tau: 12 each, qdd: 12; joints in order, quaternions
// x y z w (normalised here), floating joints [linear; angular] in the body's frame; arrays do not
// overlap.
// Returns 0, or a status that ankle_p1_failure explains; then no acceleration is written.
int ankle_p1_solve(ankle_p1_solver* solver, const double* q, const double* v, const double* tau, double* qdd);

// Reason of a status, and the joint that it is about, -1 for none.
int ankle_p1_reason(int status);
int ankle_p1_failed_joint(int status);

// Text of a solver's last failure, valid until its next call; for null, the reason why the last open
// of this thread failed.
const char* ankle_p1_failure(const ankle_p1_solver* solver);

void ankle_p1_close(ankle_p1_solver* solver);
#ifdef __cplusplus
}
#endif
#endif
