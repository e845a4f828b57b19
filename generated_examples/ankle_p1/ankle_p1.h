// C interface of the solver ankle_p1: forward dynamics of "ankle" on 1 process,
// emitted by adagen 0.1.0 (interface.h.j2). Do not edit: emit anew.
#ifndef ADAGEN_ANKLE_P1_H
#define ADAGEN_ANKLE_P1_H

enum {
  ANKLE_P1_PROCESSES = 1,
  ANKLE_P1_JOINTS = 8,
  ANKLE_P1_NQ = 14,  // numbers in q
  ANKLE_P1_NV = 12,  // in v and qdd
  ANKLE_P1_NTAU = 12  // in tau
};

// Where each joint begins in q, and in v, tau and qdd.
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

// Why a call failed, as ankle_p1_reason tells of the status that it returned.
enum {
  ANKLE_P1_FINE = 0,  // none
  ANKLE_P1_NOT_FINITE = 1,  // q, v or tau of a joint is not a finite number
  ANKLE_P1_ZERO_QUATERNION = 2,  // a joint's quaternion cannot be normalised
  ANKLE_P1_FACTORIZATION = 3,  // inertias beside a joint differ too much for the scalar
  ANKLE_P1_OVERFLOW = 4,  // a joint's acceleration is not a finite number
  ANKLE_P1_NO_ANSWER = 5,  // a process did not answer within the time limit
  ANKLE_P1_ENDED = 6,  // process 0 has ended the evaluations
  ANKLE_P1_NOT_REFINED = 7,  // refinement does not converge
  ANKLE_P1_GIMBAL_LOCK = 8,  // joints that are joined as one do not move in as many directions
  ANKLE_P1_GROWTH = 9,  // a link beside a joint is too light for its neighbours
  ANKLE_P1_NOT_SET = 16,  // what is to be set at run time is not finite, or is no mass
  ANKLE_P1_TOO_FEW_STEPS = 11,  // refinement converges too slowly
  ANKLE_P1_LOOP_OPEN = 12,  // a loop or coupling is not closed in this configuration
  ANKLE_P1_LOOP_TORN = 13,  // this velocity tears a loop or coupling open
  ANKLE_P1_LOOP_SINGULAR = 14,  // what a loop holds changes in this pose
  ANKLE_P1_LOOP_FREE = 15  // loops leave a joint a motion that no inertia resists
};

#ifdef __cplusplus
extern "C" {
#endif
typedef struct ankle_p1_solver ankle_p1_solver;

// Joints in order, each with its place in the state: gives name, start and size in q and v of joint
// k, or returns 0 where there is none.
int ankle_p1_joint(int k, const char** name, int* q, int* nq, int* v, int* nv);

// A solver, with all the memory that it will ever need: no other call allocates, waits or takes a
// lock. One solver is for one thread at a time. Returns null where there is no memory;
// ankle_p1_failure(NULL) says so.
ankle_p1_solver* ankle_p1_open(void);

// One evaluation. q: 14 numbers, v and tau: 12 each, qdd: 12; joints in order, quaternions
// x y z w (normalised here), floating joints [linear; angular] in the body's frame.
// Returns 0, or a status that ankle_p1_failure puts into words; no acceleration is written then.
int ankle_p1_solve(ankle_p1_solver* solver, const double* q, const double* v, const double* tau, double* qdd);

// What a status says: its reason, and which joint it is about, -1 for none.
int ankle_p1_reason(int status);
int ankle_p1_failed_joint(int status);

// The last failure of a solver in words, valid until the next call; of null, why the last open of this
// thread returned null.
const char* ankle_p1_failure(const ankle_p1_solver* solver);

void ankle_p1_close(ankle_p1_solver* solver);
#ifdef __cplusplus
}
#endif
#endif
