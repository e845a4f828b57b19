// C interface of the solver arm7_batch_p2: forward dynamics of "arm7" on 2 processes,
// emitted by adagen 0.1.0 (interface.h.j2). Do not edit: generate again.
#ifndef ADAGEN_ARM7_BATCH_P2_H
#define ADAGEN_ARM7_BATCH_P2_H

#ifdef ADAGEN_NO_MPI
#error "this solver runs on MPI processes: generate one with --procs 1 or --channel threads"
#endif
#include <mpi.h>

enum {
  ARM7_BATCH_P2_PROCESSES = 2,
  ARM7_BATCH_P2_JOINTS = 9,
  ARM7_BATCH_P2_NQ = 9,  // numbers in q
  ARM7_BATCH_P2_NV = 9,  // in v and qdd
  ARM7_BATCH_P2_NTAU = 9  // in tau
};

// Index of each joint's first number in q, and in v, tau and qdd.
enum {
  ARM7_BATCH_P2_Q_base_yaw = 0,
  ARM7_BATCH_P2_V_base_yaw = 0,  // joint 0, "base_yaw": revolute, 1 in q, 1 in v
  ARM7_BATCH_P2_Q_shoulder_pitch = 1,
  ARM7_BATCH_P2_V_shoulder_pitch = 1,  // joint 1, "shoulder_pitch": revolute, 1 in q, 1 in v
  ARM7_BATCH_P2_Q_upper_arm_roll = 2,
  ARM7_BATCH_P2_V_upper_arm_roll = 2,  // joint 2, "upper_arm_roll": revolute, 1 in q, 1 in v
  ARM7_BATCH_P2_Q_elbow_pitch = 3,
  ARM7_BATCH_P2_V_elbow_pitch = 3,  // joint 3, "elbow_pitch": revolute, 1 in q, 1 in v
  ARM7_BATCH_P2_Q_forearm_roll = 4,
  ARM7_BATCH_P2_V_forearm_roll = 4,  // joint 4, "forearm_roll": revolute, 1 in q, 1 in v
  ARM7_BATCH_P2_Q_wrist_pitch = 5,
  ARM7_BATCH_P2_V_wrist_pitch = 5,  // joint 5, "wrist_pitch": revolute, 1 in q, 1 in v
  ARM7_BATCH_P2_Q_flange_roll = 6,
  ARM7_BATCH_P2_V_flange_roll = 6,  // joint 6, "flange_roll": revolute, 1 in q, 1 in v
  ARM7_BATCH_P2_Q_left_finger_slide = 7,
  ARM7_BATCH_P2_V_left_finger_slide = 7,  // joint 7, "left_finger_slide": prismatic, 1 in q, 1 in v
  ARM7_BATCH_P2_Q_right_finger_slide = 8,
  ARM7_BATCH_P2_V_right_finger_slide = 8  // joint 8, "right_finger_slide": prismatic, 1 in q, 1 in v
};

// Reasons of failures: arm7_batch_p2_reason gives that of a status.
enum {
  ARM7_BATCH_P2_FINE = 0,  // none
  ARM7_BATCH_P2_NOT_FINITE = 1,  // q, v or tau of a joint is not a finite number
  ARM7_BATCH_P2_ZERO_QUATERNION = 2,  // a joint's quaternion cannot be normalised
  ARM7_BATCH_P2_FACTORIZATION = 3,  // inertias beside a joint differ too much for the scalar
  ARM7_BATCH_P2_OVERFLOW = 4,  // a joint's acceleration is not a finite number
  ARM7_BATCH_P2_NO_ANSWER = 5,  // a process did not answer within the time limit
  ARM7_BATCH_P2_ENDED = 6,  // process 0 has ended the evaluations
  ARM7_BATCH_P2_NOT_REFINED = 7,  // refinement does not converge
  ARM7_BATCH_P2_GIMBAL_LOCK = 8,  // gimbal lock of joints that are joined as one
  ARM7_BATCH_P2_GROWTH = 9,  // a link beside a joint is too light for its neighbours
  ARM7_BATCH_P2_NOT_SET = 16,  // a value is not finite, a mass not positive, or the constant cannot be set
  ARM7_BATCH_P2_TOO_FEW_STEPS = 11,  // refinement converges too slowly
  ARM7_BATCH_P2_LOOP_OPEN = 12,  // a loop or coupling is not closed in this configuration
  ARM7_BATCH_P2_LOOP_TORN = 13,  // the velocity violates a loop or coupling
  ARM7_BATCH_P2_LOOP_SINGULAR = 14,  // the rank of the loop constraints changes in this pose
  ARM7_BATCH_P2_LOOP_FREE = 15  // the loops allow a motion of a joint that has no inertia
};

#ifdef __cplusplus
extern "C" {
#endif
typedef struct arm7_batch_p2_solver arm7_batch_p2_solver;

// Gives name, first index and size in q and v of joint k; pointers may be null. Returns 0 if there is
// no joint k.
int arm7_batch_p2_joint(int k, const char** name, int* q, int* nq, int* v, int* nv);

// Collective over a communicator of 2 processes. channel: "auto", "window" (shared memory) or
// "message", the same on all; time_limit: seconds that a process waits for another; if one does not
// answer, no later call is answered. Close it before MPI_Finalize. Returns null on failure, on all
// processes; arm7_batch_p2_failure(NULL) gives the reason.
arm7_batch_p2_solver* arm7_batch_p2_open(MPI_Comm comm, const char* channel, double time_limit);

// Accelerations of count states, each process on its own, one state after the other: 9 numbers of q, 9
// of v and tau, 9 of qdd; joints in order, quaternions x y z w (normalised here), floating joints [linear;
// angular] in the body's frame; arrays do not overlap. Returns 0, or a status that
// arm7_batch_p2_failure explains: accelerations of states that cannot be solved are NaN; all other
// states are solved.
int arm7_batch_p2_solve_batch(arm7_batch_p2_solver* solver, int count, const double* q, const double* v, const double* tau, double* qdd);

// The same, collective: process 0 passes all states and gets all accelerations and failures; the
// others may pass null and any count, or call serve. Faster processes solve more states.
// If a process does not answer, accelerations that are missing are NaN, and failed_state names none;
// keep the arrays until the solver is closed: a message that comes late may still touch them.
int arm7_batch_p2_solve_batch_at_root(arm7_batch_p2_solver* solver, int count, const double* q, const double* v, const double* tau, double* qdd);

// Index of the k-th state that the last call could not solve, k from 0; -1 if there are fewer, or
// from k = 256 on. arm7_batch_p2_failure then gives the reason, and counts states from 1.
int arm7_batch_p2_failed_state(arm7_batch_p2_solver* solver, int k);

// For all processes but 0: joins every solve_batch_at_root of process 0, and waits between them without a
// time limit, until process 0 calls end. Returns 0 then, or the status of a failure.
int arm7_batch_p2_serve(arm7_batch_p2_solver* solver);

// At process 0: makes serve return at the others, which may serve again, or all close.
int arm7_batch_p2_end(arm7_batch_p2_solver* solver);

// Reason of a status, and the joint that it is about, -1 for none.
int arm7_batch_p2_reason(int status);
int arm7_batch_p2_failed_joint(int status);

// Text of a solver's last failure, valid until its next call; for null, the reason why the last open
// of this thread failed.
const char* arm7_batch_p2_failure(const arm7_batch_p2_solver* solver);

// Collective.
void arm7_batch_p2_close(arm7_batch_p2_solver* solver);
#ifdef __cplusplus
}
#endif
#endif
