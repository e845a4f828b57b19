// Forward dynamics of "humanoid" on 2 processes, emitted by adagen 0.1.0 (solver.cpp.j2). Do not edit: generate again.
//
// robot     "humanoid", 30 joints, 35 degrees of freedom, description sha256 d573a89307ddd4ee9018ee9a0a94422a3db0c5f61f2798648f53f0e1b57ee437
// command   adagen ../models/humanoid.urdf --floating --procs 2 --shape=kernels --batch --name=humanoid_batch
// options   form segment, shape kernels, scalar double, channel auto, floating base, gravity 0.0, 0.0, -9.81
// links     adagen_program.cpp -DADAGEN_MPI
// program   1 process
//           process 0: __base__ .. right_wrist_pitch
// licence   yours to choose: generated code belongs to its user
//
// Articulated-body algorithm: the articulated-body inertias I^A and bias forces p^A (IA, pA) are computed
// from the ends to the base, then the accelerations from the base outwards. Spatial vectors are [angular;
// linear], in the axes of the base, about each link's origin. Each SIMD lane holds a state; the processes
// share the states of a batch, not the robot.
//
// Contents:
//   1. interface   the C functions for a program that links this file
//   2. model       the robot's constants
//   3. runtime     spatial algebra, joints, exchange between processes
//   4. joints      memory of each joint, and the functions that compute its steps
//   5. processes   the work of each process, in order
//   6. program     description for the program around it (adagen_program.cpp), and main

// ---- 1. interface -------------------------------------------------------------------------------
// To call it from your program, compile this file with -DADAGEN_NO_MAIN and link it. This part is also in
// humanoid_batch_p2.h.
// C interface of the solver humanoid_batch_p2: forward dynamics of "humanoid" on 2 processes,
// emitted by adagen 0.1.0 (interface.h.j2). Do not edit: generate again.
#ifndef ADAGEN_HUMANOID_BATCH_P2_H
#define ADAGEN_HUMANOID_BATCH_P2_H

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
  HUMANOID_BATCH_P2_NOT_SET = 16,  // a run-time constant is not finite, or a mass is not positive
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

// Gives name, first index and size in q and v of joint k; returns 0 if there is no joint k.
int humanoid_batch_p2_joint(int k, const char** name, int* q, int* nq, int* v, int* nv);

// Collective over a communicator of 2 processes. channel: "auto", "window" (shared memory) or
// "message"; time_limit: seconds that a process waits for another. Returns null on failure;
// humanoid_batch_p2_failure(NULL) gives the reason.
humanoid_batch_p2_solver* humanoid_batch_p2_open(MPI_Comm comm, const char* channel, double time_limit);

// Accelerations of count states, each process on its own, one state after the other: 36 numbers of q, 35
// of v and tau, 35 of qdd; joints in order, quaternions x y z w (normalised here), floating joints [linear;
// angular] in the body's frame. Returns 0, or a status that humanoid_batch_p2_failure explains:
// accelerations of states that cannot be solved are NaN; all other states are solved.
int humanoid_batch_p2_solve_batch(humanoid_batch_p2_solver* solver, int count, const double* q, const double* v, const double* tau, double* qdd);

// The same, collective: process 0 passes all states and gets all accelerations and failures; the
// others may pass null and any count, or call serve. Faster processes solve more states.
int humanoid_batch_p2_solve_batch_at_root(humanoid_batch_p2_solver* solver, int count, const double* q, const double* v, const double* tau, double* qdd);

// Index of the k-th state that the last call could not solve, k from 0; -1 if there are fewer, or
// from k = 256 on. humanoid_batch_p2_failure then gives the reason.
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

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <utility>

// ---- 2. model -----------------------------------------------------------------------------------

// Configuration of the runtime headers (adagen/).
#define ADAGEN_SOLVER
#define ADAGEN_MPI
#define ADAGEN_BATCH
#include "adagen/version.hpp"
#if ADAGEN_VERSION != 100
#error "the headers in adagen/ are of another version than adagen 0.1.0, which wrote this file"
#endif

namespace {

using Number = double;  // type of states, results and messages
using Real = double;    // type of all other values
constexpr int kProcesses = 2;
[[maybe_unused]] constexpr bool kAlone = false;  // whether process 0 does all the work
constexpr int kJointCount = 30, kLinkCount = kJointCount + 1;
constexpr int kNq = 36, kNv = 35;
[[maybe_unused]] constexpr int kNqdd = kNv;  // numbers in qdd
constexpr int kOuterCount = 0, kNtau = kNv + 6 * kOuterCount;
[[maybe_unused]] constexpr int kColumns = 1;  // right-hand sides: the motion, and one per slaved joint
[[maybe_unused]] constexpr std::size_t kSlavedCount = 0;  // joints that follow others
[[maybe_unused]] constexpr bool kGivesAll = true;  // whether accelerations of all joints are found
[[maybe_unused]] constexpr bool kBatch = true;  // whether many states are solved at once
[[maybe_unused]] constexpr int kRefine = 0;  // steps of iterative refinement
[[maybe_unused]] constexpr bool kWide = false;  // whether their residuals are found in wider numbers
[[maybe_unused]] constexpr bool kCertified = false;  // whether the error of each answer is bounded
[[maybe_unused]] constexpr bool kWeighed = kCertified || (kRefine > 0 && !kWide);  // whether residuals are swept inwards
[[maybe_unused]] constexpr int kPlanMessages = 0;
[[maybe_unused]] constexpr double kTolerance = 1e-09;

}  // namespace

#include "adagen/constants.hpp"

namespace {

[[maybe_unused]] constexpr std::array<double, 3> kGravity{0.0, 0.0, -9.81};  // m/s^2
// What can be set at run time, and what it is until then.
[[maybe_unused]] constexpr int kParameterCount = 0;

constexpr std::array<LinkConstants, kLinkCount> kLinks{ {
    {"__world__", 0.0, {0.0, 0.0, 0.0},
     {0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0},
     {}},
    {"pelvis", 6.2, {0.0, 0.0, 0.02},
     {0.0324467, 0.0, 0.0, 0.0, 0.0175667, 0.0, 0.0, 0.0, 0.0351333},
     {}},
    {"left_hip", 1.4, {0.0, 0.0, 0.03},
     {0.00182, 0.0, 0.0, 0.0, 0.00182, 0.0, 0.0, 0.0, 0.00175},
     {}},
    {"left_groin", 1.2, {0.0, -0.04, 0.02},
     {0.00139, 0.0, 0.0, 0.0, 0.00139, 0.0, 0.0, 0.0, 0.0015},
     {}},
    {"left_thigh", 2.6, {0.0, 0.0, -0.1},
     {0.0169867, 0.0, 0.0, 0.0, 0.0169867, 0.0, 0.0, 0.0, 0.00468},
     {}},
    {"left_shank", 1.8, {-0.13, 0.01, 0.0},
     {0.0018225, 0.0, 0.0, 0.0, 0.0126713, 0.0, 0.0, 0.0, 0.0126713},
     {}},
    {"left_ankle", 0.2, {0.0, 0.0, 0.0},
     {7.2e-05, 0.0, 0.0, 0.0, 7.2e-05, 0.0, 0.0, 0.0, 7.2e-05},
     {}},
    {"left_foot", 0.8, {0.0, -0.03, 0.03},
     {0.00272667, 0.0, 0.0, 0.0, 0.00309333, 0.0, 0.0, 0.0, 0.000486667},
     {}},
    {"right_hip", 1.4, {0.0, 0.0, -0.03},
     {0.00182, 0.0, 0.0, 0.0, 0.00182, 0.0, 0.0, 0.0, 0.00175},
     {}},
    {"right_groin", 1.2, {0.0, -0.04, 0.02},
     {0.00139, 0.0, 0.0, 0.0, 0.00139, 0.0, 0.0, 0.0, 0.0015},
     {}},
    {"right_thigh", 2.6, {0.0, 0.0, -0.1},
     {0.0169867, 0.0, 0.0, 0.0, 0.0169867, 0.0, 0.0, 0.0, 0.00468},
     {}},
    {"right_shank", 1.8, {-0.13, 0.01, 0.0},
     {0.0018225, 0.0, 0.0, 0.0, 0.0126713, 0.0, 0.0, 0.0, 0.0126713},
     {}},
    {"right_ankle", 0.2, {0.0, 0.0, 0.0},
     {7.2e-05, 0.0, 0.0, 0.0, 7.2e-05, 0.0, 0.0, 0.0, 7.2e-05},
     {}},
    {"right_foot", 0.8, {0.0, -0.03, 0.03},
     {0.00272667, 0.0, 0.0, 0.0, 0.00309333, 0.0, 0.0, 0.0, 0.000486667},
     {}},
    {"waist_link", 0.8, {0.0, 0.0, 0.02},
     {0.00074, 0.0, 0.0, 0.0, 0.00074, 0.0, 0.0, 0.0, 0.001},
     {}},
    {"abdomen", 0.9, {0.0, 0.02, 0.0},
     {0.0010425, 0.0, 0.0, 0.0, 0.001125, 0.0, 0.0, 0.0, 0.0010425},
     {}},
    {"torso", 9.5, {0.17, 0.01, 0.0},
     {0.0823333, 0.0, 0.0, 0.0, 0.153583, 0.0, 0.0, 0.0, 0.111783},
     {}},
    {"left_shoulder", 0.8, {0.0, 0.0, 0.03},
     {0.000646667, 0.0, 0.0, 0.0, 0.000646667, 0.0, 0.0, 0.0, 0.00064},
     {}},
    {"left_shoulder_cap", 0.7, {0.01, -0.03, 0.0},
     {0.0007, 0.0, 0.0, 0.0, 0.0007, 0.0, 0.0, 0.0, 0.0007},
     {}},
    {"left_upper_arm", 0.8, {0.0, 0.0, -0.05},
     {0.00162667, 0.0, 0.0, 0.0, 0.00162667, 0.0, 0.0, 0.0, 0.00064},
     {}},
    {"left_forearm", 0.7, {-0.07, 0.02, 0.0},
     {0.00042875, 0.0, 0.0, 0.0, 0.00170771, 0.0, 0.0, 0.0, 0.00170771},
     {}},
    {"left_wrist", 0.2, {0.0, 0.0, -0.01},
     {8.66667e-05, 0.0, 0.0, 0.0, 8.66667e-05, 0.0, 0.0, 0.0, 9e-05},
     {}},
    {"left_hand", 0.4, {-0.06, 0.0, 0.0},
     {0.000296667, 0.0, 0.0, 0.0, 0.000693333, 0.0, 0.0, 0.0, 0.000563333},
     {}},
    {"neck", 0.4, {0.0, 0.0, 0.02},
     {0.00021, 0.0, 0.0, 0.0, 0.00021, 0.0, 0.0, 0.0, 0.00018},
     {}},
    {"head", 2.4, {0.09, 0.02, 0.0},
     {0.007776, 0.0, 0.0, 0.0, 0.007776, 0.0, 0.0, 0.0, 0.007776},
     {}},
    {"right_shoulder", 0.8, {0.0, 0.0, -0.03},
     {0.000646667, 0.0, 0.0, 0.0, 0.000646667, 0.0, 0.0, 0.0, 0.00064},
     {}},
    {"right_shoulder_cap", 0.7, {-0.01, -0.03, 0.0},
     {0.0007, 0.0, 0.0, 0.0, 0.0007, 0.0, 0.0, 0.0, 0.0007},
     {}},
    {"right_upper_arm", 0.8, {0.0, 0.0, -0.05},
     {0.00162667, 0.0, 0.0, 0.0, 0.00162667, 0.0, 0.0, 0.0, 0.00064},
     {}},
    {"right_forearm", 0.7, {-0.07, 0.02, 0.0},
     {0.00042875, 0.0, 0.0, 0.0, 0.00170771, 0.0, 0.0, 0.0, 0.00170771},
     {}},
    {"right_wrist", 0.2, {0.0, 0.0, -0.01},
     {8.66667e-05, 0.0, 0.0, 0.0, 8.66667e-05, 0.0, 0.0, 0.0, 9e-05},
     {}},
    {"right_hand", 0.4, {-0.06, 0.0, 0.0},
     {0.000296667, 0.0, 0.0, 0.0, 0.000693333, 0.0, 0.0, 0.0, 0.000563333},
     {}},
} };

constexpr std::array<JointConstants, kJointCount> kJoints{ {
    {"__base__", JointKind::kFloating, 0, 0, 7, 0, 6,
     {1.0, 0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 1.0},
     {0.0, 0.0, 0.0}, -1, 0.0, 0.0},
    {"left_hip_pitch", JointKind::kRevolute, 1, 7, 1, 6, 1,
     {0.0, 1.0, 0.0, 0.0, 0.0, 1.0, 1.0, 0.0, 0.0},
     {0.0, 0.09, -0.05}, -1, 0.0, 0.0},
    {"left_hip_roll", JointKind::kRevolute, 2, 8, 1, 7, 1,
     {0.0, 1.0, 0.0, 0.0, 0.0, 1.0, 1.0, 0.0, 0.0},
     {0.0, 0.0, 0.04}, -1, 0.0, 0.0},
    {"left_hip_yaw", JointKind::kRevolute, 3, 9, 1, 8, 1,
     {0.0, 1.0, 0.0, 0.0, 0.0, 1.0, 1.0, 0.0, 0.0},
     {0.0, -0.12, 0.0}, -1, 0.0, 0.0},
    {"left_knee", JointKind::kRevolute, 4, 10, 1, 9, 1,
     {0.0, 1.0, 0.0, 0.0, 0.0, 1.0, 1.0, 0.0, 0.0},
     {0.0, 0.0, -0.24}, -1, 0.0, 0.0},
    {"left_ankle_pitch", JointKind::kRevolute, 5, 11, 1, 10, 1,
     {1.0, 0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 1.0},
     {-0.3, 0.0, 0.0}, -1, 0.0, 0.0},
    {"left_ankle_roll", JointKind::kRevolute, 6, 12, 1, 11, 1,
     {0.0, 1.0, 0.0, 0.0, 0.0, 1.0, 1.0, 0.0, 0.0},
     {-0.02, 0.0, 0.0}, -1, 0.0, 0.0},
    {"right_hip_pitch", JointKind::kRevolute, 1, 13, 1, 12, 1,
     {0.0, 1.0, 0.0, 0.0, 0.0, 1.0, 1.0, 0.0, 0.0},
     {0.0, -0.09, -0.05}, -1, 0.0, 0.0},
    {"right_hip_roll", JointKind::kRevolute, 8, 14, 1, 13, 1,
     {0.0, 1.0, 0.0, 0.0, 0.0, 1.0, 1.0, 0.0, 0.0},
     {0.0, 0.0, -0.04}, -1, 0.0, 0.0},
    {"right_hip_yaw", JointKind::kRevolute, 9, 15, 1, 14, 1,
     {0.0, 1.0, 0.0, 0.0, 0.0, 1.0, 1.0, 0.0, 0.0},
     {0.0, -0.12, 0.0}, -1, 0.0, 0.0},
    {"right_knee", JointKind::kRevolute, 10, 16, 1, 15, 1,
     {0.0, 1.0, 0.0, 0.0, 0.0, 1.0, 1.0, 0.0, 0.0},
     {0.0, 0.0, -0.24}, -1, 0.0, 0.0},
    {"right_ankle_pitch", JointKind::kRevolute, 11, 17, 1, 16, 1,
     {1.0, 0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 1.0},
     {-0.3, 0.0, 0.0}, -1, 0.0, 0.0},
    {"right_ankle_roll", JointKind::kRevolute, 12, 18, 1, 17, 1,
     {0.0, 1.0, 0.0, 0.0, 0.0, 1.0, 1.0, 0.0, 0.0},
     {-0.02, 0.0, 0.0}, -1, 0.0, 0.0},
    {"waist_yaw", JointKind::kRevolute, 1, 19, 1, 18, 1,
     {1.0, 0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 1.0},
     {0.0, 0.0, 0.09}, -1, 0.0, 0.0},
    {"waist_roll", JointKind::kRevolute, 14, 20, 1, 19, 1,
     {0.0, 0.0, 1.0, 1.0, 0.0, 0.0, 0.0, 1.0, 0.0},
     {0.0, 0.0, 0.05}, -1, 0.0, 0.0},
    {"waist_pitch", JointKind::kRevolute, 15, 21, 1, 20, 1,
     {0.0, 0.0, 1.0, 1.0, 0.0, 0.0, 0.0, 1.0, 0.0},
     {0.0, 0.04, 0.0}, -1, 0.0, 0.0},
    {"left_shoulder_pitch", JointKind::kRevolute, 16, 22, 1, 21, 1,
     {1.0, 0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 1.0},
     {0.29, 0.0, 0.15}, -1, 0.0, 0.0},
    {"left_shoulder_roll", JointKind::kRevolute, 17, 23, 1, 22, 1,
     {0.0, 1.0, 0.0, 0.0, 0.0, 1.0, 1.0, 0.0, 0.0},
     {0.0, 0.0, 0.05}, -1, 0.0, 0.0},
    {"left_shoulder_yaw", JointKind::kRevolute, 18, 24, 1, 23, 1,
     {0.0, 1.0, 0.0, 0.0, 0.0, 1.0, 1.0, 0.0, 0.0},
     {0.0, -0.1, 0.0}, -1, 0.0, 0.0},
    {"left_elbow", JointKind::kRevolute, 19, 25, 1, 24, 1,
     {0.0, 1.0, 0.0, 0.0, 0.0, 1.0, 1.0, 0.0, 0.0},
     {0.0, 0.0, -0.11}, -1, 0.0, 0.0},
    {"left_wrist_roll", JointKind::kRevolute, 20, 26, 1, 25, 1,
     {0.0, 0.0, 1.0, 1.0, 0.0, 0.0, 0.0, 1.0, 0.0},
     {-0.16, 0.01, 0.0}, -1, 0.0, 0.0},
    {"left_wrist_pitch", JointKind::kRevolute, 21, 27, 1, 26, 1,
     {0.0, 1.0, 0.0, 0.0, 0.0, 1.0, 1.0, 0.0, 0.0},
     {0.0, 0.0, -0.04}, -1, 0.0, 0.0},
    {"neck_yaw", JointKind::kRevolute, 16, 28, 1, 27, 1,
     {0.0, 0.0, 1.0, 1.0, 0.0, 0.0, 0.0, 1.0, 0.0},
     {0.38, 0.0, 0.0}, -1, 0.0, 0.0},
    {"neck_pitch", JointKind::kRevolute, 23, 29, 1, 28, 1,
     {0.0, 1.0, 0.0, 0.0, 0.0, 1.0, 1.0, 0.0, 0.0},
     {0.0, 0.0, 0.06}, -1, 0.0, 0.0},
    {"right_shoulder_pitch", JointKind::kRevolute, 16, 30, 1, 29, 1,
     {1.0, 0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 1.0},
     {0.29, 0.0, -0.15}, -1, 0.0, 0.0},
    {"right_shoulder_roll", JointKind::kRevolute, 25, 31, 1, 30, 1,
     {0.0, 1.0, 0.0, 0.0, 0.0, 1.0, 1.0, 0.0, 0.0},
     {0.0, 0.0, -0.05}, -1, 0.0, 0.0},
    {"right_shoulder_yaw", JointKind::kRevolute, 26, 32, 1, 31, 1,
     {0.0, 1.0, 0.0, 0.0, 0.0, 1.0, 1.0, 0.0, 0.0},
     {0.0, -0.1, 0.0}, -1, 0.0, 0.0},
    {"right_elbow", JointKind::kRevolute, 27, 33, 1, 32, 1,
     {0.0, 1.0, 0.0, 0.0, 0.0, 1.0, 1.0, 0.0, 0.0},
     {0.0, 0.0, -0.11}, -1, 0.0, 0.0},
    {"right_wrist_roll", JointKind::kRevolute, 28, 34, 1, 33, 1,
     {0.0, 0.0, 1.0, 1.0, 0.0, 0.0, 0.0, 1.0, 0.0},
     {-0.16, 0.01, 0.0}, -1, 0.0, 0.0},
    {"right_wrist_pitch", JointKind::kRevolute, 29, 35, 1, 34, 1,
     {0.0, 1.0, 0.0, 0.0, 0.0, 1.0, 1.0, 0.0, 0.0},
     {0.0, 0.0, -0.04}, -1, 0.0, 0.0},
} };

[[maybe_unused]] constexpr std::array<OuterForce, kOuterCount> kOuterForces{};

}  // namespace

// ---- 3. runtime ---------------------------------------------------------------------------------

#include "adagen/status.hpp"
#include "adagen/failures.hpp"
#include "adagen/far_angles.hpp"
#include "adagen/kernels/lanes.hpp"
#include "adagen/kernels/algebra.hpp"

namespace {

constexpr std::array<MessageInfo, 0> kMessages{ {
} };

}  // namespace

#include "adagen/channel.hpp"
#include "adagen/stamp.hpp"

// ---- 4. kernels ---------------------------------------------------------------------------------
// Vectors are expressed in the axes of the base (of the ground, or of a floating base's link), about
// each link's own origin. omega, alpha, a: motion of links for zero joint accelerations; the joint
// accelerations that are solved for come on top.

#include "adagen/kernels/tables.hpp"

namespace {

// Type of values: one state in each lane.
using Value = Lanes;

// Mass, mass times centre of mass, and pseudo-inertia of each link.
constexpr std::array<LinkInertia, kJointCount> kInertias{ {
    {6.2, {0.0, 0.0, 0.12400000000000001},
     {0.01012665, 0.0, 0.0, 0.02500665, 0.0, 0.009920050000000001}},
    {1.4, {0.0, 0.0, 0.041999999999999996},
     {0.000875, 0.0, 0.0, 0.000875, 0.0, 0.002205}},
    {1.2, {0.0, -0.048, 0.024},
     {0.00075, 0.0, 0.0, 0.00267, -0.00096, 0.00112}},
    {2.6, {0.0, 0.0, -0.26},
     {0.00234, 0.0, 0.0, 0.00234, 0.0, 0.0406467}},
    {1.8, {-0.234, 0.018000000000000002, 0.0},
     {0.042180050000000004, -0.00234, 0.0, 0.00109125, 0.0, 0.00091125}},
    {0.2, {0.0, 0.0, 0.0},
     {3.6e-05, 0.0, 0.0, 3.6e-05, 0.0, 3.6e-05}},
    {0.8, {0.0, -0.024, 0.024},
     {0.0004266635, 0.0, 0.0, 0.0007800035, -0.0007199999999999999, 0.0033866665}},
    {1.4, {0.0, 0.0, -0.041999999999999996},
     {0.000875, 0.0, 0.0, 0.000875, 0.0, 0.002205}},
    {1.2, {0.0, -0.048, 0.024},
     {0.00075, 0.0, 0.0, 0.00267, -0.00096, 0.00112}},
    {2.6, {0.0, 0.0, -0.26},
     {0.00234, 0.0, 0.0, 0.00234, 0.0, 0.0406467}},
    {1.8, {-0.234, 0.018000000000000002, 0.0},
     {0.042180050000000004, -0.00234, 0.0, 0.00109125, 0.0, 0.00091125}},
    {0.2, {0.0, 0.0, 0.0},
     {3.6e-05, 0.0, 0.0, 3.6e-05, 0.0, 3.6e-05}},
    {0.8, {0.0, -0.024, 0.024},
     {0.0004266635, 0.0, 0.0, 0.0007800035, -0.0007199999999999999, 0.0033866665}},
    {0.8, {0.0, 0.0, 0.016},
     {0.0005, 0.0, 0.0, 0.0005, 0.0, 0.0005600000000000001}},
    {0.9, {0.0, 0.018000000000000002, 0.0},
     {0.0005625, 0.0, 0.0, 0.0008400000000000001, 0.0, 0.0005625}},
    {9.5, {1.6150000000000002, 0.095, 0.0},
     {0.36606635000000004, 0.01615, 0.0, 0.021216649999999997, 0.0, 0.06206665}},
    {0.8, {0.0, 0.0, 0.024},
     {0.00032, 0.0, 0.0, 0.00032, 0.0, 0.0010466669999999998}},
    {0.7, {0.006999999999999999, -0.020999999999999998, 0.0},
     {0.00042, -0.00020999999999999998, 0.0, 0.00098, 0.0, 0.00035}},
    {0.8, {0.0, 0.0, -0.04000000000000001},
     {0.00032, 0.0, 0.0, 0.00032, 0.0, 0.0033066700000000003}},
    {0.7, {-0.049, 0.013999999999999999, 0.0},
     {0.004923335000000001, -0.00098, 0.0, 0.000494375, 0.0, 0.000214375}},
    {0.2, {0.0, 0.0, -0.002},
     {4.5e-05, 0.0, 0.0, 4.5e-05, 0.0, 6.16667e-05}},
    {0.4, {-0.024, 0.0, 0.0},
     {0.0019199994999999999, 0.0, 0.0, 8.33335e-05, 0.0, 0.00021333350000000002}},
    {0.4, {0.0, 0.0, 0.008},
     {9e-05, 0.0, 0.0, 9e-05, 0.0, 0.00028000000000000003}},
    {2.4, {0.216, 0.048, 0.0},
     {0.023327999999999998, 0.00432, 0.0, 0.004848, 0.0, 0.003888}},
    {0.8, {0.0, 0.0, -0.024},
     {0.00032, 0.0, 0.0, 0.00032, 0.0, 0.0010466669999999998}},
    {0.7, {-0.006999999999999999, -0.020999999999999998, 0.0},
     {0.00042, 0.00020999999999999998, 0.0, 0.00098, 0.0, 0.00035}},
    {0.8, {0.0, 0.0, -0.04000000000000001},
     {0.00032, 0.0, 0.0, 0.00032, 0.0, 0.0033066700000000003}},
    {0.7, {-0.049, 0.013999999999999999, 0.0},
     {0.004923335000000001, -0.00098, 0.0, 0.000494375, 0.0, 0.000214375}},
    {0.2, {0.0, 0.0, -0.002},
     {4.5e-05, 0.0, 0.0, 4.5e-05, 0.0, 6.16667e-05}},
    {0.4, {-0.024, 0.0, 0.0},
     {0.0019199994999999999, 0.0, 0.0, 8.33335e-05, 0.0, 0.00021333350000000002}},
} };

// Memory slot of each joint and its child link; limbs that share lanes, and segments of long runs,
// are interleaved.
constexpr int kSlotCount = 30;
constexpr int kTile = 0;  // joints whose memory is in use at the same time; 0: all
constexpr bool kInLanes = false;  // whether limbs share lanes
constexpr bool kPrescribedInLanes = false;  // with prescribed motions
constexpr bool kReordered = false;  // whether slots are in another order than joints
constexpr int kSlots[kJointCount]{ 0, 1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12, 13, 14, 15, 16, 17, 18, 19, 20, 21, 22, 23, 24, 25, 26, 27, 28, 29 };
// Blocks of slots with equal constants: number of kinds (0: not compared), kind of each block, and
// first block of each kind.
constexpr int kBlockKindCount = 0;
[[maybe_unused]] constexpr int kBlockKinds[]{ 0 };
[[maybe_unused]] constexpr int kFirstOfKind[]{ 0 };
constexpr bool kByColumns = false;  // whether runs are computed by columns
// Joints that are eliminated in their own axes: always, or only if the axes of the base lose digits.
constexpr bool kAnyTurned = false;
constexpr bool kTurned[kJointCount]{ 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0 };
constexpr bool kAnyTurnedIfLost = false;
constexpr bool kTurnedIfLost[kJointCount]{ 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0 };
constexpr double kLosing = 256.0;  // they do if trace > kLosing * D
// Whether sweeps are repeated with other forces.
constexpr bool kPassesFree = false;  // whether mobilities pass floating joints
constexpr bool kAgain = kWide || kSlavedCount > 0;

// Role of each process at each link: gathers, adds_own, parts, oriented.
constexpr LinkRole kRoles[1][kLinkCount]{
    {{0, 0, 0, 0}, {1, 1, 1, 0}, {0, 1, 0, 0}, {0, 1, 0, 0}, {0, 1, 0, 0}, {0, 1, 0, 0}, {0, 1, 0, 0}, {0, 1, 0, 0}, {0, 1, 0, 0}, {0, 1, 0, 0}, {0, 1, 0, 0}, {0, 1, 0, 0}, {0, 1, 0, 0}, {0, 1, 0, 0}, {0, 1, 0, 0}, {0, 1, 0, 0}, {1, 1, 1, 0}, {0, 1, 0, 0}, {0, 1, 0, 0}, {0, 1, 0, 0}, {0, 1, 0, 0}, {0, 1, 0, 0}, {0, 1, 0, 0}, {0, 1, 0, 0}, {0, 1, 0, 0}, {0, 1, 0, 0}, {0, 1, 0, 0}, {0, 1, 0, 0}, {0, 1, 0, 0}, {0, 1, 0, 0}, {0, 1, 0, 0}},
};


}  // namespace

#include "adagen/kernels/state.hpp"

namespace {

// Memory where segments meet, by joint.
struct Cuts {
};

}  // namespace

#include "adagen/kernels/blocks.hpp"
#include "adagen/kernels/inertias.hpp"
#include "adagen/kernels/memory.hpp"
#include "adagen/gravity.hpp"
#include "adagen/kernels/guards.hpp"
#include "adagen/kernels/kinds.hpp"
#include "adagen/kernels/links.hpp"
#include "adagen/kernels/outward.hpp"
#include "adagen/kernels/keep_nothing.hpp"
#include "adagen/kernels/factors.hpp"
#include "adagen/kernels/spherical.hpp"
#include "adagen/kernels/turned.hpp"
#include "adagen/kernels/inward.hpp"
#include "adagen/kernels/reach_nothing.hpp"
#include "adagen/kernels/accelerate.hpp"

namespace {

// ---- 5. processes -------------------------------------------------------------------------------

// Each process: 30 of 30 joints: "__base__", "left_hip_pitch", "left_hip_roll", "left_hip_yaw", "left_knee", "left_ankle_pitch", ...
void run_0([[maybe_unused]] Workspace& w) {
  require_finite(w, w.q, 0, 3, &JointConstants::q, kNotFinite);
  stamp(0);
  std::copy_n(w.q + 7, 29, w.angle.data() + 1);
  turn<block(1), block(29) + 1>(w);
  free_base_frame<0>(w);
  outward<1, 6>(w);  // "left_hip_pitch" .. "left_ankle_roll"
  outward<7, 12>(w);  // "right_hip_pitch" .. "right_ankle_roll"
  outward<13, 21>(w);  // "waist_yaw" .. "left_wrist_pitch"
  outward<22, 23>(w);  // "neck_yaw" .. "neck_pitch"
  outward<24, 29>(w);  // "right_shoulder_pitch" .. "right_wrist_pitch"
  stamp(1);
  set_up_links<block(0), block(29) + 1>(w);
  free_base<0, true>(w);
  inward<0, 24, 29, true>(w);  // "right_shoulder_pitch" .. "right_wrist_pitch"
  inward<0, 22, 23, false>(w);  // "neck_yaw" .. "neck_pitch"
  inward<0, 13, 21, false>(w);  // "waist_yaw" .. "left_wrist_pitch"
  inward<0, 7, 12, false>(w);  // "right_hip_pitch" .. "right_ankle_roll"
  inward<0, 1, 6, false>(w);  // "left_hip_pitch" .. "left_ankle_roll"
  solve_root<0, 1>(w);
  stamp(2);
  accelerate<0, 1, 6>(w);  // "left_hip_pitch" .. "left_ankle_roll"
  accelerate<0, 7, 12>(w);  // "right_hip_pitch" .. "right_ankle_roll"
  accelerate<0, 13, 21>(w);  // "waist_yaw" .. "left_wrist_pitch"
  accelerate<0, 22, 23>(w);  // "neck_yaw" .. "neck_pitch"
  accelerate<0, 24, 29>(w);  // "right_shoulder_pitch" .. "right_wrist_pitch"
  free_acceleration<0>(w);
  stamp(3);
  if (!went_well(w, 0, 35)) {
    // The state's own faults are named before all others.
    const int found = std::exchange(w.status, kFine);
    require_finite(w, w.q, 0, 36, &JointConstants::q, kNotFinite);
    require_finite(w, w.v, 0, 35, &JointConstants::v, kNotFinite);
    require_finite(w, w.tau, 0, 35, &JointConstants::v, kNotFinite);
    Channel::fail(w.status, found);
    require_finite(w, w.answer.data(), 0, 35, &JointConstants::v, kOverflow);
  }
  give(w, 0, 35);
}

constexpr std::array kParts{run_0};  // what is done for a group of states, in order

// What each process reads of q and v, the velocity entries whose qdd is its own, and whose tau it
// reads.
constexpr std::array<Range, 1> kReadQ_0{ {{0, 36}} };
constexpr std::array<Range, 1> kReadV_0{ {{0, 35}} };
constexpr std::array<Range, 1> kOwn_0{ {{0, 35}} };
constexpr std::array<Range, 1> kTorque_0{ {{0, 35}} };
[[maybe_unused]] constexpr std::array<ProcessInfo, kProcesses> kProcess{ {
    {{1, kReadQ_0.data()}, {1, kReadV_0.data()}, {1, kOwn_0.data()}, {1, kTorque_0.data()}},
    {{1, kReadQ_0.data()}, {1, kReadV_0.data()}, {1, kOwn_0.data()}, {1, kTorque_0.data()}},
} };

}  // namespace

#include "adagen/no_parameters.hpp"
#include "adagen/handout.hpp"
#include "adagen/batch.hpp"
#include "adagen/open.hpp"

static_assert(HUMANOID_BATCH_P2_NQ == kNq && HUMANOID_BATCH_P2_NV == kNv && HUMANOID_BATCH_P2_NTAU == kNtau);
static_assert(int(HUMANOID_BATCH_P2_FINE) == int(kFine));
static_assert(int(HUMANOID_BATCH_P2_NOT_FINITE) == int(kNotFinite));
static_assert(int(HUMANOID_BATCH_P2_ZERO_QUATERNION) == int(kZeroQuaternion));
static_assert(int(HUMANOID_BATCH_P2_FACTORIZATION) == int(kFactorization));
static_assert(int(HUMANOID_BATCH_P2_OVERFLOW) == int(kOverflow));
static_assert(int(HUMANOID_BATCH_P2_NO_ANSWER) == int(kNoAnswer));
static_assert(int(HUMANOID_BATCH_P2_ENDED) == int(kEnded));
static_assert(int(HUMANOID_BATCH_P2_NOT_REFINED) == int(kNotRefined));
static_assert(int(HUMANOID_BATCH_P2_GIMBAL_LOCK) == int(kGimbalLock));
static_assert(int(HUMANOID_BATCH_P2_GROWTH) == int(kGrowth));
static_assert(int(HUMANOID_BATCH_P2_NOT_SET) == int(kNotSet));
static_assert(int(HUMANOID_BATCH_P2_TOO_FEW_STEPS) == int(kTooFewSteps));
static_assert(int(HUMANOID_BATCH_P2_LOOP_OPEN) == int(kLoopOpen));
static_assert(int(HUMANOID_BATCH_P2_LOOP_TORN) == int(kLoopTorn));
static_assert(int(HUMANOID_BATCH_P2_LOOP_SINGULAR) == int(kLoopSingular));
static_assert(int(HUMANOID_BATCH_P2_LOOP_FREE) == int(kLoopFree));

struct humanoid_batch_p2_solver : Solver {};

extern "C" {

int humanoid_batch_p2_joint(int k, const char** name, int* q, int* nq, int* v, int* nv) {
  if (k < 0 || k >= kJointCount) return 0;
  const JointConstants& joint = kJoints[k];
  *name = joint.name, *q = joint.q, *nq = joint.nq, *v = joint.v, *nv = joint.nv;
  return 1;
}

humanoid_batch_p2_solver* humanoid_batch_p2_open(MPI_Comm comm, const char* channel, double time_limit) {
  return opened<humanoid_batch_p2_solver>(comm, channel, time_limit);
}

int humanoid_batch_p2_solve_batch(humanoid_batch_p2_solver* solver, int count, const double* q, const double* v, const double* tau, double* qdd) {
  return solver->solve_batch(count, q, v, tau, qdd);
}

int humanoid_batch_p2_solve_batch_at_root(humanoid_batch_p2_solver* solver, int count, const double* q, const double* v, const double* tau, double* qdd) {
  return solver->solve_batch_at_root(count, q, v, tau, qdd);
}

int humanoid_batch_p2_failed_state(humanoid_batch_p2_solver* solver, int k) { return solver->failed_state(k); }

int humanoid_batch_p2_serve(humanoid_batch_p2_solver* solver) { return solver->serve(); }

int humanoid_batch_p2_end(humanoid_batch_p2_solver* solver) { return solver->end(); }

int humanoid_batch_p2_reason(int status) { return failure_kind(status); }

int humanoid_batch_p2_failed_joint(int status) { return is_of_joint(failure_kind(status)) ? failure_place(status) : -1; }

const char* humanoid_batch_p2_failure(const humanoid_batch_p2_solver* solver) {
  return solver == nullptr ? open_failure.c_str() : solver->text.c_str();
}

void humanoid_batch_p2_close(humanoid_batch_p2_solver* solver) {
  if (solver == nullptr) return;
  solver->close();
  delete solver;
}

}  // extern "C"

// ---- 6. program ---------------------------------------------------------------------------------
// Description of this solver for the program around it, which is the same for all robots: it reads
// states, writes accelerations, checks, times, traces and simulates.

#ifndef ADAGEN_NO_MAIN
#include "adagen/description.hpp"
#include "adagen/measured.hpp"
#include "adagen/this_solver.hpp"

namespace {

// The stages of each process's work, for --trace.
constexpr std::array<adagen::Stage, 3> kStages_0{ {
    {"kinematics", 29, -1},
    {"assembly", 1, -1},
    {"disassembly", 1, -1},
} };
constexpr std::array<adagen::Stage, 3> kStages_1{ {
    {"kinematics", 29, -1},
    {"assembly", 1, -1},
    {"disassembly", 1, -1},
} };
constexpr std::array<adagen::Table<adagen::Stage>, kProcesses> kStages{ {
    {kStages_0.data(), 3},
    {kStages_1.data(), 3},
} };

// From the cost profile default.
constexpr adagen::Hop kWindowHop{0, 159, 0.437};
constexpr adagen::Hop kMessageHop{26, 228, 0.644};

}  // namespace

// Compiled for size: it runs once.
[[gnu::cold]] int main(int count, char** words) {
  const adagen::Description<Number> description{
      "humanoid", "auto", kProcesses, 1, kNq, kNv, kNtau, kNqdd, kRefine,
      true, kAlone, kBatch, kCertified, false, false, kTolerance, kGravity.data(),
      table(kJoints), table(kLinks), table(kOuterForces), {}, {}, {}, table(kMessages), kStages.data(), kWindowHop,
      kMessageHop};
  auto* const solver = new ThisSolver;
  const int status = adagen::program(description, *solver, count, words);
  delete solver;
  return status;
}
#endif  // ADAGEN_NO_MAIN
