// C interface of the solver arm7_float_p2: forward dynamics of "arm7" on 2 processes,
// emitted by adagen 0.1.0 (interface.h.j2). Do not edit: emit anew.
#ifndef ADAGEN_ARM7_FLOAT_P2_H
#define ADAGEN_ARM7_FLOAT_P2_H

#include <mpi.h>

enum {
  ARM7_FLOAT_P2_PROCESSES = 2,
  ARM7_FLOAT_P2_JOINTS = 9,
  ARM7_FLOAT_P2_NQ = 9,  // numbers in q
  ARM7_FLOAT_P2_NV = 9,  // in v and qdd
  ARM7_FLOAT_P2_NTAU = 9  // in tau
};

// Where each joint begins in q, and in v, tau and qdd.
enum {
  ARM7_FLOAT_P2_Q_base_yaw = 0,
  ARM7_FLOAT_P2_V_base_yaw = 0,  // joint 0, "base_yaw": revolute, 1 in q, 1 in v
  ARM7_FLOAT_P2_Q_shoulder_pitch = 1,
  ARM7_FLOAT_P2_V_shoulder_pitch = 1,  // joint 1, "shoulder_pitch": revolute, 1 in q, 1 in v
  ARM7_FLOAT_P2_Q_upper_arm_roll = 2,
  ARM7_FLOAT_P2_V_upper_arm_roll = 2,  // joint 2, "upper_arm_roll": revolute, 1 in q, 1 in v
  ARM7_FLOAT_P2_Q_elbow_pitch = 3,
  ARM7_FLOAT_P2_V_elbow_pitch = 3,  // joint 3, "elbow_pitch": revolute, 1 in q, 1 in v
  ARM7_FLOAT_P2_Q_forearm_roll = 4,
  ARM7_FLOAT_P2_V_forearm_roll = 4,  // joint 4, "forearm_roll": revolute, 1 in q, 1 in v
  ARM7_FLOAT_P2_Q_wrist_pitch = 5,
  ARM7_FLOAT_P2_V_wrist_pitch = 5,  // joint 5, "wrist_pitch": revolute, 1 in q, 1 in v
  ARM7_FLOAT_P2_Q_flange_roll = 6,
  ARM7_FLOAT_P2_V_flange_roll = 6,  // joint 6, "flange_roll": revolute, 1 in q, 1 in v
  ARM7_FLOAT_P2_Q_left_finger_slide = 7,
  ARM7_FLOAT_P2_V_left_finger_slide = 7,  // joint 7, "left_finger_slide": prismatic, 1 in q, 1 in v
  ARM7_FLOAT_P2_Q_right_finger_slide = 8,
  ARM7_FLOAT_P2_V_right_finger_slide = 8  // joint 8, "right_finger_slide": prismatic, 1 in q, 1 in v
};

// Why a call failed, as arm7_float_p2_reason tells of the status that it returned.
enum {
  ARM7_FLOAT_P2_FINE = 0,  // none
  ARM7_FLOAT_P2_NOT_FINITE = 1,  // q, v or tau of a joint is not a finite number
  ARM7_FLOAT_P2_ZERO_QUATERNION = 2,  // a joint's quaternion cannot be normalised
  ARM7_FLOAT_P2_FACTORIZATION = 3,  // inertias beside a joint differ too much for the scalar
  ARM7_FLOAT_P2_OVERFLOW = 4,  // a joint's acceleration is not a finite number
  ARM7_FLOAT_P2_NO_ANSWER = 5,  // a process did not answer within the time limit
  ARM7_FLOAT_P2_ENDED = 6,  // process 0 has ended the evaluations
  ARM7_FLOAT_P2_NOT_REFINED = 7,  // refinement does not converge
  ARM7_FLOAT_P2_GIMBAL_LOCK = 8,  // joints that are joined as one do not move in as many directions
  ARM7_FLOAT_P2_GROWTH = 9,  // a link beside a joint is too light for its neighbours
  ARM7_FLOAT_P2_NOT_SET = 16,  // what is to be set at run time is not finite, or is no mass
  ARM7_FLOAT_P2_TOO_FEW_STEPS = 11,  // refinement converges too slowly
  ARM7_FLOAT_P2_LOOP_OPEN = 12,  // a loop or coupling is not closed in this configuration
  ARM7_FLOAT_P2_LOOP_TORN = 13,  // this velocity tears a loop or coupling open
  ARM7_FLOAT_P2_LOOP_SINGULAR = 14,  // what a loop holds changes in this pose
  ARM7_FLOAT_P2_LOOP_FREE = 15  // loops leave a joint a motion that no inertia resists
};

#ifdef __cplusplus
extern "C" {
#endif
typedef struct arm7_float_p2_solver arm7_float_p2_solver;

// Joints in order, each with its place in the state: gives name, start and size in q and v of joint
// k, or returns 0 where there is none.
int arm7_float_p2_joint(int k, const char** name, int* q, int* nq, int* v, int* nv);

// Collective over a communicator of 2 processes. channel: "auto", "window" (shared memory) or
// "message"; time_limit: seconds that a process waits for another. Returns null where it cannot be
// done; arm7_float_p2_failure(NULL) says why.
arm7_float_p2_solver* arm7_float_p2_open(MPI_Comm comm, const char* channel, double time_limit);

// One evaluation, collective. q: 9 numbers, v and tau: 9 each, qdd: 9; joints in order, quaternions
// x y z w (normalised here), floating joints [linear; angular] in the body's frame.
// solve: every process passes the state and gets its own joints' accelerations (others untouched);
// solve_at_root: process 0 passes the state and gets them all, the others may pass null, or serve.
// Returns 0, or a status that arm7_float_p2_failure puts into words; no acceleration is written then.
int arm7_float_p2_solve(arm7_float_p2_solver* solver, const float* q, const float* v, const float* tau, float* qdd);
int arm7_float_p2_solve_at_root(arm7_float_p2_solver* solver, const float* q, const float* v, const float* tau, float* qdd);

// What every process but 0 can do all the time: takes part in each solve_at_root of process 0, however
// long that lets it wait, until process 0 ends it. Returns 0, or why it cannot go on.
int arm7_float_p2_serve(arm7_float_p2_solver* solver);

// At process 0: the others' serve returns. They may serve again, or all close.
int arm7_float_p2_end(arm7_float_p2_solver* solver);

// What a status says: its reason, and which joint it is about, -1 for none.
int arm7_float_p2_reason(int status);
int arm7_float_p2_failed_joint(int status);

// The last failure of a solver in words, valid until the next call; of null, why the last open of this
// thread returned null.
const char* arm7_float_p2_failure(const arm7_float_p2_solver* solver);

// Collective.
void arm7_float_p2_close(arm7_float_p2_solver* solver);
#ifdef __cplusplus
}
#endif
#endif
