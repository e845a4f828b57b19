// C interface of the solver arm7_unrolled_p1: forward dynamics of "arm7" on 1 process,
// emitted by adagen 0.1.0 (interface.h.j2). Do not edit: generate again.
#ifndef ADAGEN_ARM7_UNROLLED_P1_H
#define ADAGEN_ARM7_UNROLLED_P1_H

enum {
  ARM7_UNROLLED_P1_PROCESSES = 1,
  ARM7_UNROLLED_P1_JOINTS = 9,
  ARM7_UNROLLED_P1_NQ = 9,  // numbers in q
  ARM7_UNROLLED_P1_NV = 9,  // in v and qdd
  ARM7_UNROLLED_P1_NTAU = 9  // in tau
};

// Index of each joint's first number in q, and in v, tau and qdd.
enum {
  ARM7_UNROLLED_P1_Q_base_yaw = 0,
  ARM7_UNROLLED_P1_V_base_yaw = 0,  // joint 0, "base_yaw": revolute, 1 in q, 1 in v
  ARM7_UNROLLED_P1_Q_shoulder_pitch = 1,
  ARM7_UNROLLED_P1_V_shoulder_pitch = 1,  // joint 1, "shoulder_pitch": revolute, 1 in q, 1 in v
  ARM7_UNROLLED_P1_Q_upper_arm_roll = 2,
  ARM7_UNROLLED_P1_V_upper_arm_roll = 2,  // joint 2, "upper_arm_roll": revolute, 1 in q, 1 in v
  ARM7_UNROLLED_P1_Q_elbow_pitch = 3,
  ARM7_UNROLLED_P1_V_elbow_pitch = 3,  // joint 3, "elbow_pitch": revolute, 1 in q, 1 in v
  ARM7_UNROLLED_P1_Q_forearm_roll = 4,
  ARM7_UNROLLED_P1_V_forearm_roll = 4,  // joint 4, "forearm_roll": revolute, 1 in q, 1 in v
  ARM7_UNROLLED_P1_Q_wrist_pitch = 5,
  ARM7_UNROLLED_P1_V_wrist_pitch = 5,  // joint 5, "wrist_pitch": revolute, 1 in q, 1 in v
  ARM7_UNROLLED_P1_Q_flange_roll = 6,
  ARM7_UNROLLED_P1_V_flange_roll = 6,  // joint 6, "flange_roll": revolute, 1 in q, 1 in v
  ARM7_UNROLLED_P1_Q_left_finger_slide = 7,
  ARM7_UNROLLED_P1_V_left_finger_slide = 7,  // joint 7, "left_finger_slide": prismatic, 1 in q, 1 in v
  ARM7_UNROLLED_P1_Q_right_finger_slide = 8,
  ARM7_UNROLLED_P1_V_right_finger_slide = 8  // joint 8, "right_finger_slide": prismatic, 1 in q, 1 in v
};

// Reasons of failures: arm7_unrolled_p1_reason gives that of a status.
enum {
  ARM7_UNROLLED_P1_FINE = 0,  // none
  ARM7_UNROLLED_P1_NOT_FINITE = 1,  // q, v or tau of a joint is not a finite number
  ARM7_UNROLLED_P1_ZERO_QUATERNION = 2,  // a joint's quaternion cannot be normalised
  ARM7_UNROLLED_P1_FACTORIZATION = 3,  // inertias beside a joint differ too much for the scalar
  ARM7_UNROLLED_P1_OVERFLOW = 4,  // a joint's acceleration is not a finite number
  ARM7_UNROLLED_P1_NO_ANSWER = 5,  // a process did not answer within the time limit
  ARM7_UNROLLED_P1_ENDED = 6,  // process 0 has ended the evaluations
  ARM7_UNROLLED_P1_NOT_REFINED = 7,  // refinement does not converge
  ARM7_UNROLLED_P1_GIMBAL_LOCK = 8,  // gimbal lock of joints that are joined as one
  ARM7_UNROLLED_P1_GROWTH = 9,  // a link beside a joint is too light for its neighbours
  ARM7_UNROLLED_P1_NOT_SET = 16,  // a value is not finite, a mass not positive, or the constant cannot be set
  ARM7_UNROLLED_P1_TOO_FEW_STEPS = 11,  // refinement converges too slowly
  ARM7_UNROLLED_P1_LOOP_OPEN = 12,  // a loop or coupling is not closed in this configuration
  ARM7_UNROLLED_P1_LOOP_TORN = 13,  // the velocity violates a loop or coupling
  ARM7_UNROLLED_P1_LOOP_SINGULAR = 14,  // the rank of the loop constraints changes in this pose
  ARM7_UNROLLED_P1_LOOP_FREE = 15  // the loops allow a motion of a joint that has no inertia
};

#ifdef __cplusplus
extern "C" {
#endif
typedef struct arm7_unrolled_p1_solver arm7_unrolled_p1_solver;

// Gives name, first index and size in q and v of joint k; pointers may be null. Returns 0 if there is
// no joint k.
int arm7_unrolled_p1_joint(int k, const char** name, int* q, int* nq, int* v, int* nv);

// A solver; allocates all its memory: no other call allocates, waits or locks. One thread at a time
// may use a solver. Returns null if there is no memory; arm7_unrolled_p1_failure(NULL) says so.
arm7_unrolled_p1_solver* arm7_unrolled_p1_open(void);

// One evaluation. q: 9 numbers, v and tau: 9 each, qdd: 9; joints in order, quaternions
// x y z w (normalised here), floating joints [linear; angular] in the body's frame; arrays do not
// overlap.
// Returns 0, or a status that arm7_unrolled_p1_failure explains; then no acceleration is written.
int arm7_unrolled_p1_solve(arm7_unrolled_p1_solver* solver, const double* q, const double* v, const double* tau, double* qdd);

// Reason of a status, and the joint that it is about, -1 for none.
int arm7_unrolled_p1_reason(int status);
int arm7_unrolled_p1_failed_joint(int status);

// Text of a solver's last failure, valid until its next call; for null, the reason why the last open
// of this thread failed.
const char* arm7_unrolled_p1_failure(const arm7_unrolled_p1_solver* solver);

void arm7_unrolled_p1_close(arm7_unrolled_p1_solver* solver);
#ifdef __cplusplus
}
#endif
#endif
