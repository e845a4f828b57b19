// C interface of the solver human40_p4: forward dynamics of "human40" on 4 processes,
// emitted by adagen 0.1.0 (interface.h.j2). Do not edit: generate again.
#ifndef ADAGEN_HUMAN40_P4_H
#define ADAGEN_HUMAN40_P4_H

#ifdef ADAGEN_NO_MPI
#error "this solver runs on MPI processes: generate one with --procs 1 or --channel threads"
#endif
#include <mpi.h>

enum {
  HUMAN40_P4_PROCESSES = 4,
  HUMAN40_P4_JOINTS = 15,
  HUMAN40_P4_NQ = 51,  // numbers in q
  HUMAN40_P4_NV = 40,  // in v and qdd
  HUMAN40_P4_NTAU = 40  // in tau
};

// Index of each joint's first number in q, and in v, tau and qdd.
enum {
  HUMAN40_P4_Q_root = 0,
  HUMAN40_P4_V_root = 0,  // joint 0, "root": floating, 7 in q, 6 in v
  HUMAN40_P4_Q_left_hip = 7,
  HUMAN40_P4_V_left_hip = 6,  // joint 1, "left_hip": spherical, 4 in q, 3 in v
  HUMAN40_P4_Q_left_knee = 11,
  HUMAN40_P4_V_left_knee = 9,  // joint 2, "left_knee": revolute, 1 in q, 1 in v
  HUMAN40_P4_Q_left_ankle = 12,
  HUMAN40_P4_V_left_ankle = 10,  // joint 3, "left_ankle": spherical, 4 in q, 3 in v
  HUMAN40_P4_Q_right_hip = 16,
  HUMAN40_P4_V_right_hip = 13,  // joint 4, "right_hip": spherical, 4 in q, 3 in v
  HUMAN40_P4_Q_right_knee = 20,
  HUMAN40_P4_V_right_knee = 16,  // joint 5, "right_knee": revolute, 1 in q, 1 in v
  HUMAN40_P4_Q_right_ankle = 21,
  HUMAN40_P4_V_right_ankle = 17,  // joint 6, "right_ankle": spherical, 4 in q, 3 in v
  HUMAN40_P4_Q_spine = 25,
  HUMAN40_P4_V_spine = 20,  // joint 7, "spine": spherical, 4 in q, 3 in v
  HUMAN40_P4_Q_left_shoulder = 29,
  HUMAN40_P4_V_left_shoulder = 23,  // joint 8, "left_shoulder": spherical, 4 in q, 3 in v
  HUMAN40_P4_Q_left_elbow = 33,
  HUMAN40_P4_V_left_elbow = 26,  // joint 9, "left_elbow": revolute, 1 in q, 1 in v
  HUMAN40_P4_Q_left_wrist = 34,
  HUMAN40_P4_V_left_wrist = 27,  // joint 10, "left_wrist": spherical, 4 in q, 3 in v
  HUMAN40_P4_Q_neck = 38,
  HUMAN40_P4_V_neck = 30,  // joint 11, "neck": spherical, 4 in q, 3 in v
  HUMAN40_P4_Q_right_shoulder = 42,
  HUMAN40_P4_V_right_shoulder = 33,  // joint 12, "right_shoulder": spherical, 4 in q, 3 in v
  HUMAN40_P4_Q_right_elbow = 46,
  HUMAN40_P4_V_right_elbow = 36,  // joint 13, "right_elbow": revolute, 1 in q, 1 in v
  HUMAN40_P4_Q_right_wrist = 47,
  HUMAN40_P4_V_right_wrist = 37  // joint 14, "right_wrist": spherical, 4 in q, 3 in v
};

// Reasons of failures: human40_p4_reason gives that of a status.
enum {
  HUMAN40_P4_FINE = 0,  // none
  HUMAN40_P4_NOT_FINITE = 1,  // q, v or tau of a joint is not a finite number
  HUMAN40_P4_ZERO_QUATERNION = 2,  // a joint's quaternion cannot be normalised
  HUMAN40_P4_FACTORIZATION = 3,  // inertias beside a joint differ too much for the scalar
  HUMAN40_P4_OVERFLOW = 4,  // a joint's acceleration is not a finite number
  HUMAN40_P4_NO_ANSWER = 5,  // a process did not answer within the time limit
  HUMAN40_P4_ENDED = 6,  // process 0 has ended the evaluations
  HUMAN40_P4_NOT_REFINED = 7,  // refinement does not converge
  HUMAN40_P4_GIMBAL_LOCK = 8,  // gimbal lock of joints that are joined as one
  HUMAN40_P4_GROWTH = 9,  // a link beside a joint is too light for its neighbours
  HUMAN40_P4_NOT_SET = 16,  // a value is not finite, a mass not positive, or the constant cannot be set
  HUMAN40_P4_TOO_FEW_STEPS = 11,  // refinement converges too slowly
  HUMAN40_P4_LOOP_OPEN = 12,  // a loop or coupling is not closed in this configuration
  HUMAN40_P4_LOOP_TORN = 13,  // the velocity violates a loop or coupling
  HUMAN40_P4_LOOP_SINGULAR = 14,  // the rank of the loop constraints changes in this pose
  HUMAN40_P4_LOOP_FREE = 15  // the loops allow a motion of a joint that has no inertia
};

#ifdef __cplusplus
extern "C" {
#endif
typedef struct human40_p4_solver human40_p4_solver;

// Gives name, first index and size in q and v of joint k; pointers may be null. Returns 0 if there is
// no joint k.
int human40_p4_joint(int k, const char** name, int* q, int* nq, int* v, int* nv);

// Collective over a communicator of 4 processes. channel: "auto", "window" (shared memory) or
// "message", the same on all; time_limit: seconds that a process waits for another; if one does not
// answer, no later call is answered. Close it before MPI_Finalize. Returns null on failure, on all
// processes; human40_p4_failure(NULL) gives the reason.
human40_p4_solver* human40_p4_open(MPI_Comm comm, const char* channel, double time_limit);

// One evaluation, collective. q: 51 numbers, v and tau: 40 each, qdd: 40; joints in order, quaternions
// x y z w (normalised here), floating joints [linear; angular] in the body's frame; arrays do not
// overlap.
// solve: every process passes the state and gets its own joints' accelerations (others untouched);
// solve_at_root: process 0 passes the state and gets all; the others may pass null, or call serve.
// Returns 0, or a status that human40_p4_failure explains; then no acceleration is written.
int human40_p4_solve(human40_p4_solver* solver, const double* q, const double* v, const double* tau, double* qdd);
int human40_p4_solve_at_root(human40_p4_solver* solver, const double* q, const double* v, const double* tau, double* qdd);

// For all processes but 0: joins every solve_at_root of process 0, and waits between them without a
// time limit, until process 0 calls end. Returns 0 then, or the status of a failure.
int human40_p4_serve(human40_p4_solver* solver);

// At process 0: makes serve return at the others, which may serve again, or all close.
int human40_p4_end(human40_p4_solver* solver);

// Reason of a status, and the joint that it is about, -1 for none.
int human40_p4_reason(int status);
int human40_p4_failed_joint(int status);

// Text of a solver's last failure, valid until its next call; for null, the reason why the last open
// of this thread failed.
const char* human40_p4_failure(const human40_p4_solver* solver);

// Collective.
void human40_p4_close(human40_p4_solver* solver);
#ifdef __cplusplus
}
#endif
#endif
