// C interface of the solver humanoid_lanes_p1: forward dynamics of "humanoid" on 1 process,
// emitted by adagen 0.1.0 (interface.h.j2). Do not edit: generate again.
#ifndef ADAGEN_HUMANOID_LANES_P1_H
#define ADAGEN_HUMANOID_LANES_P1_H

enum {
  HUMANOID_LANES_P1_PROCESSES = 1,
  HUMANOID_LANES_P1_JOINTS = 30,
  HUMANOID_LANES_P1_NQ = 36,  // numbers in q
  HUMANOID_LANES_P1_NV = 35,  // in v and qdd
  HUMANOID_LANES_P1_NTAU = 35  // in tau
};

// Index of each joint's first number in q, and in v, tau and qdd.
enum {
  HUMANOID_LANES_P1_Q_base = 0,
  HUMANOID_LANES_P1_V_base = 0,  // joint 0, "__base__": floating, 7 in q, 6 in v
  HUMANOID_LANES_P1_Q_left_hip_pitch = 7,
  HUMANOID_LANES_P1_V_left_hip_pitch = 6,  // joint 1, "left_hip_pitch": revolute, 1 in q, 1 in v
  HUMANOID_LANES_P1_Q_left_hip_roll = 8,
  HUMANOID_LANES_P1_V_left_hip_roll = 7,  // joint 2, "left_hip_roll": revolute, 1 in q, 1 in v
  HUMANOID_LANES_P1_Q_left_hip_yaw = 9,
  HUMANOID_LANES_P1_V_left_hip_yaw = 8,  // joint 3, "left_hip_yaw": revolute, 1 in q, 1 in v
  HUMANOID_LANES_P1_Q_left_knee = 10,
  HUMANOID_LANES_P1_V_left_knee = 9,  // joint 4, "left_knee": revolute, 1 in q, 1 in v
  HUMANOID_LANES_P1_Q_left_ankle_pitch = 11,
  HUMANOID_LANES_P1_V_left_ankle_pitch = 10,  // joint 5, "left_ankle_pitch": revolute, 1 in q, 1 in v
  HUMANOID_LANES_P1_Q_left_ankle_roll = 12,
  HUMANOID_LANES_P1_V_left_ankle_roll = 11,  // joint 6, "left_ankle_roll": revolute, 1 in q, 1 in v
  HUMANOID_LANES_P1_Q_right_hip_pitch = 13,
  HUMANOID_LANES_P1_V_right_hip_pitch = 12,  // joint 7, "right_hip_pitch": revolute, 1 in q, 1 in v
  HUMANOID_LANES_P1_Q_right_hip_roll = 14,
  HUMANOID_LANES_P1_V_right_hip_roll = 13,  // joint 8, "right_hip_roll": revolute, 1 in q, 1 in v
  HUMANOID_LANES_P1_Q_right_hip_yaw = 15,
  HUMANOID_LANES_P1_V_right_hip_yaw = 14,  // joint 9, "right_hip_yaw": revolute, 1 in q, 1 in v
  HUMANOID_LANES_P1_Q_right_knee = 16,
  HUMANOID_LANES_P1_V_right_knee = 15,  // joint 10, "right_knee": revolute, 1 in q, 1 in v
  HUMANOID_LANES_P1_Q_right_ankle_pitch = 17,
  HUMANOID_LANES_P1_V_right_ankle_pitch = 16,  // joint 11, "right_ankle_pitch": revolute, 1 in q, 1 in v
  HUMANOID_LANES_P1_Q_right_ankle_roll = 18,
  HUMANOID_LANES_P1_V_right_ankle_roll = 17,  // joint 12, "right_ankle_roll": revolute, 1 in q, 1 in v
  HUMANOID_LANES_P1_Q_waist_yaw = 19,
  HUMANOID_LANES_P1_V_waist_yaw = 18,  // joint 13, "waist_yaw": revolute, 1 in q, 1 in v
  HUMANOID_LANES_P1_Q_waist_roll = 20,
  HUMANOID_LANES_P1_V_waist_roll = 19,  // joint 14, "waist_roll": revolute, 1 in q, 1 in v
  HUMANOID_LANES_P1_Q_waist_pitch = 21,
  HUMANOID_LANES_P1_V_waist_pitch = 20,  // joint 15, "waist_pitch": revolute, 1 in q, 1 in v
  HUMANOID_LANES_P1_Q_left_shoulder_pitch = 22,
  HUMANOID_LANES_P1_V_left_shoulder_pitch = 21,  // joint 16, "left_shoulder_pitch": revolute, 1 in q, 1 in v
  HUMANOID_LANES_P1_Q_left_shoulder_roll = 23,
  HUMANOID_LANES_P1_V_left_shoulder_roll = 22,  // joint 17, "left_shoulder_roll": revolute, 1 in q, 1 in v
  HUMANOID_LANES_P1_Q_left_shoulder_yaw = 24,
  HUMANOID_LANES_P1_V_left_shoulder_yaw = 23,  // joint 18, "left_shoulder_yaw": revolute, 1 in q, 1 in v
  HUMANOID_LANES_P1_Q_left_elbow = 25,
  HUMANOID_LANES_P1_V_left_elbow = 24,  // joint 19, "left_elbow": revolute, 1 in q, 1 in v
  HUMANOID_LANES_P1_Q_left_wrist_roll = 26,
  HUMANOID_LANES_P1_V_left_wrist_roll = 25,  // joint 20, "left_wrist_roll": revolute, 1 in q, 1 in v
  HUMANOID_LANES_P1_Q_left_wrist_pitch = 27,
  HUMANOID_LANES_P1_V_left_wrist_pitch = 26,  // joint 21, "left_wrist_pitch": revolute, 1 in q, 1 in v
  HUMANOID_LANES_P1_Q_neck_yaw = 28,
  HUMANOID_LANES_P1_V_neck_yaw = 27,  // joint 22, "neck_yaw": revolute, 1 in q, 1 in v
  HUMANOID_LANES_P1_Q_neck_pitch = 29,
  HUMANOID_LANES_P1_V_neck_pitch = 28,  // joint 23, "neck_pitch": revolute, 1 in q, 1 in v
  HUMANOID_LANES_P1_Q_right_shoulder_pitch = 30,
  HUMANOID_LANES_P1_V_right_shoulder_pitch = 29,  // joint 24, "right_shoulder_pitch": revolute, 1 in q, 1 in v
  HUMANOID_LANES_P1_Q_right_shoulder_roll = 31,
  HUMANOID_LANES_P1_V_right_shoulder_roll = 30,  // joint 25, "right_shoulder_roll": revolute, 1 in q, 1 in v
  HUMANOID_LANES_P1_Q_right_shoulder_yaw = 32,
  HUMANOID_LANES_P1_V_right_shoulder_yaw = 31,  // joint 26, "right_shoulder_yaw": revolute, 1 in q, 1 in v
  HUMANOID_LANES_P1_Q_right_elbow = 33,
  HUMANOID_LANES_P1_V_right_elbow = 32,  // joint 27, "right_elbow": revolute, 1 in q, 1 in v
  HUMANOID_LANES_P1_Q_right_wrist_roll = 34,
  HUMANOID_LANES_P1_V_right_wrist_roll = 33,  // joint 28, "right_wrist_roll": revolute, 1 in q, 1 in v
  HUMANOID_LANES_P1_Q_right_wrist_pitch = 35,
  HUMANOID_LANES_P1_V_right_wrist_pitch = 34  // joint 29, "right_wrist_pitch": revolute, 1 in q, 1 in v
};

// Reasons of failures: humanoid_lanes_p1_reason gives that of a status.
enum {
  HUMANOID_LANES_P1_FINE = 0,  // none
  HUMANOID_LANES_P1_NOT_FINITE = 1,  // q, v or tau of a joint is not a finite number
  HUMANOID_LANES_P1_ZERO_QUATERNION = 2,  // a joint's quaternion cannot be normalised
  HUMANOID_LANES_P1_FACTORIZATION = 3,  // inertias beside a joint differ too much for the scalar
  HUMANOID_LANES_P1_OVERFLOW = 4,  // a joint's acceleration is not a finite number
  HUMANOID_LANES_P1_NO_ANSWER = 5,  // a process did not answer within the time limit
  HUMANOID_LANES_P1_ENDED = 6,  // process 0 has ended the evaluations
  HUMANOID_LANES_P1_NOT_REFINED = 7,  // refinement does not converge
  HUMANOID_LANES_P1_GIMBAL_LOCK = 8,  // gimbal lock of joints that are joined as one
  HUMANOID_LANES_P1_GROWTH = 9,  // a link beside a joint is too light for its neighbours
  HUMANOID_LANES_P1_NOT_SET = 16,  // a value is not finite, a mass not positive, or the constant cannot be set
  HUMANOID_LANES_P1_TOO_FEW_STEPS = 11,  // refinement converges too slowly
  HUMANOID_LANES_P1_LOOP_OPEN = 12,  // a loop or coupling is not closed in this configuration
  HUMANOID_LANES_P1_LOOP_TORN = 13,  // the velocity violates a loop or coupling
  HUMANOID_LANES_P1_LOOP_SINGULAR = 14,  // the rank of the loop constraints changes in this pose
  HUMANOID_LANES_P1_LOOP_FREE = 15  // the loops allow a motion of a joint that has no inertia
};

#ifdef __cplusplus
extern "C" {
#endif
typedef struct humanoid_lanes_p1_solver humanoid_lanes_p1_solver;

// Gives name, first index and size in q and v of joint k; pointers may be null. Returns 0 if there is
// no joint k.
int humanoid_lanes_p1_joint(int k, const char** name, int* q, int* nq, int* v, int* nv);

// A solver; allocates all its memory: no other call allocates, waits or locks. One thread at a time
// may use a solver. Returns null if there is no memory; humanoid_lanes_p1_failure(NULL) says so.
humanoid_lanes_p1_solver* humanoid_lanes_p1_open(void);

// One evaluation. q: 36 numbers, v and tau: 35 each, qdd: 35; joints in order, quaternions
// x y z w (normalised here), floating joints [linear; angular] in the body's frame; arrays do not
// overlap.
// Returns 0, or a status that humanoid_lanes_p1_failure explains; then no acceleration is written.
int humanoid_lanes_p1_solve(humanoid_lanes_p1_solver* solver, const double* q, const double* v, const double* tau, double* qdd);

// Reason of a status, and the joint that it is about, -1 for none.
int humanoid_lanes_p1_reason(int status);
int humanoid_lanes_p1_failed_joint(int status);

// Text of a solver's last failure, valid until its next call; for null, the reason why the last open
// of this thread failed.
const char* humanoid_lanes_p1_failure(const humanoid_lanes_p1_solver* solver);

void humanoid_lanes_p1_close(humanoid_lanes_p1_solver* solver);
#ifdef __cplusplus
}
#endif
#endif
