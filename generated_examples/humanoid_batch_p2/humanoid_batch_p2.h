// C interface of the solver humanoid_batch_p2: forward dynamics of "humanoid" on 2 processes,
// emitted by adagen 0.1.0 (interface.h.j2). Do not edit: generate again.
#ifndef ADAGEN_HUMANOID_BATCH_P2_H
#define ADAGEN_HUMANOID_BATCH_P2_H

#ifdef ADAGEN_NO_MPI
#error "this solver runs on MPI processes: generate one with --procs 1 or --channel threads"
#endif
#include <mpi.h>

enum {
  HUMANOID_BATCH_P2_PROCESSES = 2,
  HUMANOID_BATCH_P2_JOINTS = 30,
  HUMANOID_BATCH_P2_NQ = 36,  // numbers in q
  HUMANOID_BATCH_P2_NV = 35,  // in v and qdd
  HUMANOID_BATCH_P2_NTAU = 35  // in tau
};

// Index of each joint's first number in q, and in v, tau and qdd.
enum {
  HUMANOID_BATCH_P2_Q_base = 0,
  HUMANOID_BATCH_P2_V_base = 0,  // joint 0, "__base__": floating, 7 in q, 6 in v
  HUMANOID_BATCH_P2_Q_left_hip_pitch = 7,
  HUMANOID_BATCH_P2_V_left_hip_pitch = 6,  // joint 1, "left_hip_pitch": revolute, 1 in q, 1 in v
  HUMANOID_BATCH_P2_Q_left_hip_roll = 8,
  HUMANOID_BATCH_P2_V_left_hip_roll = 7,  // joint 2, "left_hip_roll": revolute, 1 in q, 1 in v
  HUMANOID_BATCH_P2_Q_left_hip_yaw = 9,
  HUMANOID_BATCH_P2_V_left_hip_yaw = 8,  // joint 3, "left_hip_yaw": revolute, 1 in q, 1 in v
  HUMANOID_BATCH_P2_Q_left_knee = 10,
  HUMANOID_BATCH_P2_V_left_knee = 9,  // joint 4, "left_knee": revolute, 1 in q, 1 in v
  HUMANOID_BATCH_P2_Q_left_ankle_pitch = 11,
  HUMANOID_BATCH_P2_V_left_ankle_pitch = 10,  // joint 5, "left_ankle_pitch": revolute, 1 in q, 1 in v
  HUMANOID_BATCH_P2_Q_left_ankle_roll = 12,
  HUMANOID_BATCH_P2_V_left_ankle_roll = 11,  // joint 6, "left_ankle_roll": revolute, 1 in q, 1 in v
  HUMANOID_BATCH_P2_Q_right_hip_pitch = 13,
  HUMANOID_BATCH_P2_V_right_hip_pitch = 12,  // joint 7, "right_hip_pitch": revolute, 1 in q, 1 in v
  HUMANOID_BATCH_P2_Q_right_hip_roll = 14,
  HUMANOID_BATCH_P2_V_right_hip_roll = 13,  // joint 8, "right_hip_roll": revolute, 1 in q, 1 in v
  HUMANOID_BATCH_P2_Q_right_hip_yaw = 15,
  HUMANOID_BATCH_P2_V_right_hip_yaw = 14,  // joint 9, "right_hip_yaw": revolute, 1 in q, 1 in v
  HUMANOID_BATCH_P2_Q_right_knee = 16,
  HUMANOID_BATCH_P2_V_right_knee = 15,  // joint 10, "right_knee": revolute, 1 in q, 1 in v
  HUMANOID_BATCH_P2_Q_right_ankle_pitch = 17,
  HUMANOID_BATCH_P2_V_right_ankle_pitch = 16,  // joint 11, "right_ankle_pitch": revolute, 1 in q, 1 in v
  HUMANOID_BATCH_P2_Q_right_ankle_roll = 18,
  HUMANOID_BATCH_P2_V_right_ankle_roll = 17,  // joint 12, "right_ankle_roll": revolute, 1 in q, 1 in v
  HUMANOID_BATCH_P2_Q_waist_yaw = 19,
  HUMANOID_BATCH_P2_V_waist_yaw = 18,  // joint 13, "waist_yaw": revolute, 1 in q, 1 in v
  HUMANOID_BATCH_P2_Q_waist_roll = 20,
  HUMANOID_BATCH_P2_V_waist_roll = 19,  // joint 14, "waist_roll": revolute, 1 in q, 1 in v
  HUMANOID_BATCH_P2_Q_waist_pitch = 21,
  HUMANOID_BATCH_P2_V_waist_pitch = 20,  // joint 15, "waist_pitch": revolute, 1 in q, 1 in v
  HUMANOID_BATCH_P2_Q_left_shoulder_pitch = 22,
  HUMANOID_BATCH_P2_V_left_shoulder_pitch = 21,  // joint 16, "left_shoulder_pitch": revolute, 1 in q, 1 in v
  HUMANOID_BATCH_P2_Q_left_shoulder_roll = 23,
  HUMANOID_BATCH_P2_V_left_shoulder_roll = 22,  // joint 17, "left_shoulder_roll": revolute, 1 in q, 1 in v
  HUMANOID_BATCH_P2_Q_left_shoulder_yaw = 24,
  HUMANOID_BATCH_P2_V_left_shoulder_yaw = 23,  // joint 18, "left_shoulder_yaw": revolute, 1 in q, 1 in v
  HUMANOID_BATCH_P2_Q_left_elbow = 25,
  HUMANOID_BATCH_P2_V_left_elbow = 24,  // joint 19, "left_elbow": revolute, 1 in q, 1 in v
  HUMANOID_BATCH_P2_Q_left_wrist_roll = 26,
  HUMANOID_BATCH_P2_V_left_wrist_roll = 25,  // joint 20, "left_wrist_roll": revolute, 1 in q, 1 in v
  HUMANOID_BATCH_P2_Q_left_wrist_pitch = 27,
  HUMANOID_BATCH_P2_V_left_wrist_pitch = 26,  // joint 21, "left_wrist_pitch": revolute, 1 in q, 1 in v
  HUMANOID_BATCH_P2_Q_neck_yaw = 28,
  HUMANOID_BATCH_P2_V_neck_yaw = 27,  // joint 22, "neck_yaw": revolute, 1 in q, 1 in v
  HUMANOID_BATCH_P2_Q_neck_pitch = 29,
  HUMANOID_BATCH_P2_V_neck_pitch = 28,  // joint 23, "neck_pitch": revolute, 1 in q, 1 in v
  HUMANOID_BATCH_P2_Q_right_shoulder_pitch = 30,
  HUMANOID_BATCH_P2_V_right_shoulder_pitch = 29,  // joint 24, "right_shoulder_pitch": revolute, 1 in q, 1 in v
  HUMANOID_BATCH_P2_Q_right_shoulder_roll = 31,
  HUMANOID_BATCH_P2_V_right_shoulder_roll = 30,  // joint 25, "right_shoulder_roll": revolute, 1 in q, 1 in v
  HUMANOID_BATCH_P2_Q_right_shoulder_yaw = 32,
  HUMANOID_BATCH_P2_V_right_shoulder_yaw = 31,  // joint 26, "right_shoulder_yaw": revolute, 1 in q, 1 in v
  HUMANOID_BATCH_P2_Q_right_elbow = 33,
  HUMANOID_BATCH_P2_V_right_elbow = 32,  // joint 27, "right_elbow": revolute, 1 in q, 1 in v
  HUMANOID_BATCH_P2_Q_right_wrist_roll = 34,
  HUMANOID_BATCH_P2_V_right_wrist_roll = 33,  // joint 28, "right_wrist_roll": revolute, 1 in q, 1 in v
  HUMANOID_BATCH_P2_Q_right_wrist_pitch = 35,
  HUMANOID_BATCH_P2_V_right_wrist_pitch = 34  // joint 29, "right_wrist_pitch": revolute, 1 in q, 1 in v
};

// Reasons of failures: humanoid_batch_p2_reason gives that of a status.
enum {
  HUMANOID_BATCH_P2_FINE = 0,  // none
  HUMANOID_BATCH_P2_NOT_FINITE = 1,  // q, v or tau of a joint is not a finite number
  HUMANOID_BATCH_P2_ZERO_QUATERNION = 2,  // a joint's quaternion cannot be normalised
  HUMANOID_BATCH_P2_FACTORIZATION = 3,  // inertias beside a joint differ too much for the scalar
  HUMANOID_BATCH_P2_OVERFLOW = 4,  // a joint's acceleration is not a finite number
  HUMANOID_BATCH_P2_NO_ANSWER = 5,  // a process did not answer within the time limit
  HUMANOID_BATCH_P2_ENDED = 6,  // process 0 has ended the evaluations
  HUMANOID_BATCH_P2_NOT_REFINED = 7,  // refinement does not converge
  HUMANOID_BATCH_P2_GIMBAL_LOCK = 8,  // gimbal lock of joints that are joined as one
  HUMANOID_BATCH_P2_GROWTH = 9,  // a link beside a joint is too light for its neighbours
  HUMANOID_BATCH_P2_NOT_SET = 16,  // a value is not finite, a mass not positive, or the constant cannot be set
  HUMANOID_BATCH_P2_TOO_FEW_STEPS = 11,  // refinement converges too slowly
  HUMANOID_BATCH_P2_LOOP_OPEN = 12,  // a loop or coupling is not closed in this configuration
  HUMANOID_BATCH_P2_LOOP_TORN = 13,  // the velocity violates a loop or coupling
  HUMANOID_BATCH_P2_LOOP_SINGULAR = 14,  // the rank of the loop constraints changes in this pose
  HUMANOID_BATCH_P2_LOOP_FREE = 15  // the loops allow a motion of a joint that has no inertia
};

#ifdef __cplusplus
extern "C" {
#endif
typedef struct humanoid_batch_p2_solver humanoid_batch_p2_solver;

// Gives name, first index and size in q and v of joint k; pointers may be null. Returns 0 if there is
// no joint k.
int humanoid_batch_p2_joint(int k, const char** name, int* q, int* nq, int* v, int* nv);

// Collective over a communicator of 2 processes. channel: "auto", "window" (shared memory) or
// "message", the same on all; time_limit: seconds that a process waits for another; if one does not
// answer, no later call is answered. Close it before MPI_Finalize. Returns null on failure, on all
// processes; humanoid_batch_p2_failure(NULL) gives the reason.
humanoid_batch_p2_solver* humanoid_batch_p2_open(MPI_Comm comm, const char* channel, double time_limit);

// Accelerations of count states, each process on its own, one state after the other: 36 numbers of q, 35
// of v and tau, 35 of qdd; joints in order, quaternions x y z w (normalised here), floating joints [linear;
// angular] in the body's frame; arrays do not overlap. Returns 0, or a status that
// humanoid_batch_p2_failure explains: accelerations of states that cannot be solved are NaN; all other
// states are solved.
int humanoid_batch_p2_solve_batch(humanoid_batch_p2_solver* solver, int count, const double* q, const double* v, const double* tau, double* qdd);

// The same, collective: process 0 passes all states and gets all accelerations and failures; the
// others may pass null and any count, or call serve. Faster processes solve more states.
// If a process does not answer, accelerations that are missing are NaN, and failed_state names none;
// keep the arrays until the solver is closed: a message that comes late may still touch them.
int humanoid_batch_p2_solve_batch_at_root(humanoid_batch_p2_solver* solver, int count, const double* q, const double* v, const double* tau, double* qdd);

// Index of the k-th state that the last call could not solve, k from 0; -1 if there are fewer, or
// from k = 256 on. humanoid_batch_p2_failure then gives the reason, and counts states from 1.
int humanoid_batch_p2_failed_state(humanoid_batch_p2_solver* solver, int k);

// For all processes but 0: joins every solve_batch_at_root of process 0, and waits between them without a
// time limit, until process 0 calls end. Returns 0 then, or the status of a failure.
int humanoid_batch_p2_serve(humanoid_batch_p2_solver* solver);

// At process 0: makes serve return at the others, which may serve again, or all close.
int humanoid_batch_p2_end(humanoid_batch_p2_solver* solver);

// Reason of a status, and the joint that it is about, -1 for none.
int humanoid_batch_p2_reason(int status);
int humanoid_batch_p2_failed_joint(int status);

// Text of a solver's last failure, valid until its next call; for null, the reason why the last open
// of this thread failed.
const char* humanoid_batch_p2_failure(const humanoid_batch_p2_solver* solver);

// Collective.
void humanoid_batch_p2_close(humanoid_batch_p2_solver* solver);
#ifdef __cplusplus
}
#endif
#endif
