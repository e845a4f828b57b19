// Forward dynamics of "humanoid" on 1 process, emitted by adagen 0.1.0 (solver.cpp.j2). Do not edit: emit anew.
//
// robot     "humanoid", 30 joints, 35 degrees of freedom, description sha256 d573a89307ddd4ee9018ee9a0a94422a3db0c5f61f2798648f53f0e1b57ee437
// command   adagen ../models/humanoid.urdf --floating --procs 1 --shape=kernels
// options   form segment, shape kernels, scalar double, channel auto, floating base, gravity 0.0, 0.0, -9.81
// links     adagen_program.cpp
// program   1 process; 0.631 us predicted (default profile)
//           process 0: left_hip_pitch .. left_ankle_roll | right_hip_pitch .. right_ankle_roll |
//           left_shoulder_pitch .. left_wrist_pitch | right_shoulder_pitch .. right_wrist_pitch in 4
//           lanes, __base__, waist_yaw .. waist_pitch, neck_yaw .. neck_pitch
// licence   yours to choose: what adagen emits belongs to whoever emits it
//
// The articulated-body algorithm: I^A and p^A (IA, pA), a link's inertia and bias force with all that
// hangs on it, are swept to the base, and the accelerations come back. Spatial vectors are [angular;
// linear], in the axes of the base, about each link's origin.
//
// How to read on:
//   1. interface   what a program that links this file calls
//   2. model       the robot's constants
//   3. runtime     spatial algebra, joints, exchange between processes
//   4. joints      for each joint its memory, then what is done with it, step by step
//   5. processes   who does what, in order
//   6. program     what the program around it, adagen_program.cpp, is told; main

// ---- 1. interface -------------------------------------------------------------------------------
// To use it from a program of yours: compile this file with -DADAGEN_NO_MAIN and link it; humanoid_p1.h
// beside it is this part.
// C interface of the solver humanoid_p1: forward dynamics of "humanoid" on 1 process,
// emitted by adagen 0.1.0 (interface.h.j2). Do not edit: emit anew.
#ifndef ADAGEN_HUMANOID_P1_H
#define ADAGEN_HUMANOID_P1_H

enum {
  HUMANOID_P1_PROCESSES = 1,
  HUMANOID_P1_JOINTS = 30,
  HUMANOID_P1_NQ = 36,  // numbers in q
  HUMANOID_P1_NV = 35,  // in v and qdd
  HUMANOID_P1_NTAU = 35  // in tau
};

// Where each joint begins in q, and in v, tau and qdd.
enum {
  HUMANOID_P1_Q_base = 0,
  HUMANOID_P1_V_base = 0,  // joint 0, "__base__": floating, 7 in q, 6 in v
  HUMANOID_P1_Q_left_hip_pitch = 7,
  HUMANOID_P1_V_left_hip_pitch = 6,  // joint 1, "left_hip_pitch": revolute, 1 in q, 1 in v
  HUMANOID_P1_Q_left_hip_roll = 8,
  HUMANOID_P1_V_left_hip_roll = 7,  // joint 2, "left_hip_roll": revolute, 1 in q, 1 in v
  HUMANOID_P1_Q_left_hip_yaw = 9,
  HUMANOID_P1_V_left_hip_yaw = 8,  // joint 3, "left_hip_yaw": revolute, 1 in q, 1 in v
  HUMANOID_P1_Q_left_knee = 10,
  HUMANOID_P1_V_left_knee = 9,  // joint 4, "left_knee": revolute, 1 in q, 1 in v
  HUMANOID_P1_Q_left_ankle_pitch = 11,
  HUMANOID_P1_V_left_ankle_pitch = 10,  // joint 5, "left_ankle_pitch": revolute, 1 in q, 1 in v
  HUMANOID_P1_Q_left_ankle_roll = 12,
  HUMANOID_P1_V_left_ankle_roll = 11,  // joint 6, "left_ankle_roll": revolute, 1 in q, 1 in v
  HUMANOID_P1_Q_right_hip_pitch = 13,
  HUMANOID_P1_V_right_hip_pitch = 12,  // joint 7, "right_hip_pitch": revolute, 1 in q, 1 in v
  HUMANOID_P1_Q_right_hip_roll = 14,
  HUMANOID_P1_V_right_hip_roll = 13,  // joint 8, "right_hip_roll": revolute, 1 in q, 1 in v
  HUMANOID_P1_Q_right_hip_yaw = 15,
  HUMANOID_P1_V_right_hip_yaw = 14,  // joint 9, "right_hip_yaw": revolute, 1 in q, 1 in v
  HUMANOID_P1_Q_right_knee = 16,
  HUMANOID_P1_V_right_knee = 15,  // joint 10, "right_knee": revolute, 1 in q, 1 in v
  HUMANOID_P1_Q_right_ankle_pitch = 17,
  HUMANOID_P1_V_right_ankle_pitch = 16,  // joint 11, "right_ankle_pitch": revolute, 1 in q, 1 in v
  HUMANOID_P1_Q_right_ankle_roll = 18,
  HUMANOID_P1_V_right_ankle_roll = 17,  // joint 12, "right_ankle_roll": revolute, 1 in q, 1 in v
  HUMANOID_P1_Q_waist_yaw = 19,
  HUMANOID_P1_V_waist_yaw = 18,  // joint 13, "waist_yaw": revolute, 1 in q, 1 in v
  HUMANOID_P1_Q_waist_roll = 20,
  HUMANOID_P1_V_waist_roll = 19,  // joint 14, "waist_roll": revolute, 1 in q, 1 in v
  HUMANOID_P1_Q_waist_pitch = 21,
  HUMANOID_P1_V_waist_pitch = 20,  // joint 15, "waist_pitch": revolute, 1 in q, 1 in v
  HUMANOID_P1_Q_left_shoulder_pitch = 22,
  HUMANOID_P1_V_left_shoulder_pitch = 21,  // joint 16, "left_shoulder_pitch": revolute, 1 in q, 1 in v
  HUMANOID_P1_Q_left_shoulder_roll = 23,
  HUMANOID_P1_V_left_shoulder_roll = 22,  // joint 17, "left_shoulder_roll": revolute, 1 in q, 1 in v
  HUMANOID_P1_Q_left_shoulder_yaw = 24,
  HUMANOID_P1_V_left_shoulder_yaw = 23,  // joint 18, "left_shoulder_yaw": revolute, 1 in q, 1 in v
  HUMANOID_P1_Q_left_elbow = 25,
  HUMANOID_P1_V_left_elbow = 24,  // joint 19, "left_elbow": revolute, 1 in q, 1 in v
  HUMANOID_P1_Q_left_wrist_roll = 26,
  HUMANOID_P1_V_left_wrist_roll = 25,  // joint 20, "left_wrist_roll": revolute, 1 in q, 1 in v
  HUMANOID_P1_Q_left_wrist_pitch = 27,
  HUMANOID_P1_V_left_wrist_pitch = 26,  // joint 21, "left_wrist_pitch": revolute, 1 in q, 1 in v
  HUMANOID_P1_Q_neck_yaw = 28,
  HUMANOID_P1_V_neck_yaw = 27,  // joint 22, "neck_yaw": revolute, 1 in q, 1 in v
  HUMANOID_P1_Q_neck_pitch = 29,
  HUMANOID_P1_V_neck_pitch = 28,  // joint 23, "neck_pitch": revolute, 1 in q, 1 in v
  HUMANOID_P1_Q_right_shoulder_pitch = 30,
  HUMANOID_P1_V_right_shoulder_pitch = 29,  // joint 24, "right_shoulder_pitch": revolute, 1 in q, 1 in v
  HUMANOID_P1_Q_right_shoulder_roll = 31,
  HUMANOID_P1_V_right_shoulder_roll = 30,  // joint 25, "right_shoulder_roll": revolute, 1 in q, 1 in v
  HUMANOID_P1_Q_right_shoulder_yaw = 32,
  HUMANOID_P1_V_right_shoulder_yaw = 31,  // joint 26, "right_shoulder_yaw": revolute, 1 in q, 1 in v
  HUMANOID_P1_Q_right_elbow = 33,
  HUMANOID_P1_V_right_elbow = 32,  // joint 27, "right_elbow": revolute, 1 in q, 1 in v
  HUMANOID_P1_Q_right_wrist_roll = 34,
  HUMANOID_P1_V_right_wrist_roll = 33,  // joint 28, "right_wrist_roll": revolute, 1 in q, 1 in v
  HUMANOID_P1_Q_right_wrist_pitch = 35,
  HUMANOID_P1_V_right_wrist_pitch = 34  // joint 29, "right_wrist_pitch": revolute, 1 in q, 1 in v
};

// Why a call failed, as humanoid_p1_reason tells of the status that it returned.
enum {
  HUMANOID_P1_FINE = 0,  // none
  HUMANOID_P1_NOT_FINITE = 1,  // q, v or tau of a joint is not a finite number
  HUMANOID_P1_ZERO_QUATERNION = 2,  // a joint's quaternion cannot be normalised
  HUMANOID_P1_FACTORIZATION = 3,  // inertias beside a joint differ too much for the scalar
  HUMANOID_P1_OVERFLOW = 4,  // a joint's acceleration is not a finite number
  HUMANOID_P1_NO_ANSWER = 5,  // a process did not answer within the time limit
  HUMANOID_P1_ENDED = 6,  // process 0 has ended the evaluations
  HUMANOID_P1_NOT_REFINED = 7,  // refinement does not converge
  HUMANOID_P1_GIMBAL_LOCK = 8,  // joints that are joined as one do not move in as many directions
  HUMANOID_P1_GROWTH = 9,  // a link beside a joint is too light for its neighbours
  HUMANOID_P1_NOT_SET = 16,  // what is to be set at run time is not finite, or is no mass
  HUMANOID_P1_TOO_FEW_STEPS = 11,  // refinement converges too slowly
  HUMANOID_P1_LOOP_OPEN = 12,  // a loop or coupling is not closed in this configuration
  HUMANOID_P1_LOOP_TORN = 13,  // this velocity tears a loop or coupling open
  HUMANOID_P1_LOOP_SINGULAR = 14,  // what a loop holds changes in this pose
  HUMANOID_P1_LOOP_FREE = 15  // loops leave a joint a motion that no inertia resists
};

#ifdef __cplusplus
extern "C" {
#endif
typedef struct humanoid_p1_solver humanoid_p1_solver;

// Joints in order, each with its place in the state: gives name, start and size in q and v of joint
// k, or returns 0 where there is none.
int humanoid_p1_joint(int k, const char** name, int* q, int* nq, int* v, int* nv);

// A solver, with all the memory that it will ever need: no other call allocates, waits or takes a
// lock. One solver is for one thread at a time. Returns null where there is no memory;
// humanoid_p1_failure(NULL) says so.
humanoid_p1_solver* humanoid_p1_open(void);

// One evaluation. q: 36 numbers, v and tau: 35 each, qdd: 35; joints in order, quaternions
// x y z w (normalised here), floating joints [linear; angular] in the body's frame.
// Returns 0, or a status that humanoid_p1_failure puts into words; no acceleration is written then.
int humanoid_p1_solve(humanoid_p1_solver* solver, const double* q, const double* v, const double* tau, double* qdd);

// What a status says: its reason, and which joint it is about, -1 for none.
int humanoid_p1_reason(int status);
int humanoid_p1_failed_joint(int status);

// The last failure of a solver in words, valid until the next call; of null, why the last open of this
// thread returned null.
const char* humanoid_p1_failure(const humanoid_p1_solver* solver);

void humanoid_p1_close(humanoid_p1_solver* solver);
#ifdef __cplusplus
}
#endif
#endif

#include <algorithm>
#include <array>
#include <chrono>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <cstring>
#include <limits>
#include <new>
#include <type_traits>
#include <utility>

#define ADAGEN_NOINLINE [[maybe_unused]] __attribute__((noinline))
// A counted loop that is to be unrolled whole, so that indices computed in it become constants.
#if defined(__clang__)
#define ADAGEN_FOR(k, first, last) _Pragma("clang loop unroll(full)") for (int k = first; k < last; ++k)
#else
#define ADAGEN_FOR(k, first, last) _Pragma("GCC unroll 16") for (int k = first; k < last; ++k)
#endif

namespace {

using Number = double;  // of states, answers and messages
using Real = double;    // of all between
constexpr int kProcesses = 1;
[[maybe_unused]] constexpr bool kAlone = true;  // whether process 0 does all, and no other takes part
constexpr int kJointCount = 30, kLinkCount = kJointCount + 1;
constexpr int kNq = 36, kNv = 35;
constexpr int kOuterCount = 0, kNtau = kNv + 6 * kOuterCount;
[[maybe_unused]] constexpr int kColumns = 1;  // right-hand sides: the motion, and one per slaved joint
[[maybe_unused]] constexpr std::size_t kSlavedCount = 0;  // joints that follow others
[[maybe_unused]] constexpr bool kBatch = false;  // whether many states are solved at once
[[maybe_unused]] constexpr int kRefine = 0;  // steps of iterative refinement
[[maybe_unused]] constexpr int kPlanMessages = 0;
constexpr std::size_t kCacheLine = 64, kTextSize = 1000;
[[maybe_unused]] constexpr double kTolerance = 1e-09;

// ---- 2. model -----------------------------------------------------------------------------------

enum class JointKind { kRevolute, kPrismatic, kSpherical, kPlanar, kFloating };

// What a joint does by itself: of its torque, damping qd + friction tanh(qd / friction_speed)
// + stiffness (q - rest) + rotor qdd do not reach the links. Where its acceleration is prescribed,
// tau holds that.
struct Passive {
  Number damping = 0, friction = 0, friction_speed = 1, stiffness = 0, rest = 0, rotor = 0;
  bool prescribed = false;
};

// A joint's frame is turned so that its axis is z (a planar joint's normal, too); the child link
// has the joint's frame at q = 0.
struct JointConstants {
  const char* name;
  JointKind kind;
  int parent;             // parent link; the child link has the joint's number plus one
  int q, nq, v, nv;       // where its configuration and velocity are
  Number rotation[9];     // joint frame to parent link's frame, row by row
  Number translation[3];  // origin of the joint frame in the parent link's frame, m
  int source;             // joint that it is slaved to, or -1: q = multiplier q_source + offset
  double multiplier, offset;
  Passive passive{};
};

// An outer force that is an input, told in the frame of the link that has its name.
struct OuterForce {
  const char* name;
  int link;               // that feels it
  Number rotation[9];     // from that frame to the link's, row by row
  Number translation[3];  // its origin in the link's frame, m
};

struct LinkConstants {
  const char* name;
  Number mass;               // kg
  Number com[3];             // centre of mass, m
  Number tensor[9];          // rotational inertia about it, kg m^2
  Number tensor_inverse[9];  // J, its inverse
};

// Entries first .. first + count - 1 of a vector.
struct Range {
  int first, count;
};
struct Ranges {
  int count;
  const Range* ranges;
};

// What a process reads of the state, and which velocity entries' accelerations it owns.
struct ProcessInfo {
  Ranges q, v, own, tau;
};

// What goes from one process to another once in an evaluation.
struct MessageInfo {
  int source, target, size;  // size in Number, the status not counted
};

[[maybe_unused]] constexpr std::array<double, 3> kGravity{0.0, 0.0, -9.81};  // m/s^2

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

// Slaved joints follow their sources; what was given for them is ignored.
template <class Joints, class Value>
void slave(const Joints& joints, [[maybe_unused]] Value* q, [[maybe_unused]] Value* v) {
  for (const auto& joint : joints) {
    if (joint.source < 0) continue;
    const auto& source = joints[joint.source];
    q[joint.q] = static_cast<Value>(joint.multiplier * double(q[source.q]) + joint.offset);
    v[joint.v] = static_cast<Value>(joint.multiplier * double(v[source.v]));
  }
}

// ---- 3. runtime ---------------------------------------------------------------------------------

// What can go wrong in an evaluation. A status travels with every message, so that all processes
// learn of a failure and none waits for an answer that cannot come. It must be exact in a float.
enum Failure : int {
  kFine = 0,
  kNotFinite = 1,       // the state of a joint is not a finite number
  kZeroQuaternion = 2,  // the orientation of a joint is a quaternion of no length, or of too much
  kFactorization = 3,   // V^-1 of a joint is not positive definite
  kOverflow = 4,        // the acceleration of a joint is not a finite number
  kGimbalLock = 8,      // joints that are joined as one do not move in as many directions
  kGrowth = 9,          // a link's mobility beside a joint is lost to its neighbours
  kSingularPose = 10,   // no failure: the evaluation is done again in another way
  kLoopOpen = 12,       // a loop or coupling is open (numbered behind all joints)
  kLoopTorn = 13,       // its velocity tears it open
  kLoopSingular = 14,   // what it holds cannot be told from this pose
  kLoopFree = 15,       // loops leave a joint a motion that nothing resists
  kNoAnswer = 5,        // a process did not answer in time (numbered in place of a joint)
  kEnded = 6,           // no failure: process 0 has no more to evaluate
  kNotRefined = 7,      // a correction is as large as the one before: refinement does not converge
  kTooFewSteps = 11,    // refinement converges, but has not reached the digits that it owes
  kNotSet = 16,         // what is to be set at run time is not finite, or is no mass
};

constexpr int kFailureBase = 1 << 20;
[[maybe_unused]] constexpr int failure(Failure kind, int joint) {
  return kind * kFailureBase + joint;
}
constexpr Failure failure_kind(int status) { return static_cast<Failure>(status / kFailureBase); }
[[maybe_unused]] constexpr int failure_place(int status) { return status % kFailureBase; }

// Words without memory from the heap; what is too long is cut.
class Text {
 public:
  Text() = default;
  explicit Text(const char* words) { *this += words; }
  Text& operator+=(char c) {
    if (size_ + 1 < sizeof data_) data_[size_++] = c, data_[size_] = '\0';
    return *this;
  }
  Text& operator+=(const char* more) {
    for (; *more != '\0'; ++more) *this += *more;
    return *this;
  }
  Text& operator+=(int number) {
    if (number < 0) *this += '-';
    long rest = number < 0 ? -static_cast<long>(number) : number, unit = 1;
    while (rest / unit > 9) unit *= 10;
    for (; unit > 0; unit /= 10) *this += static_cast<char>('0' + rest / unit % 10);
    return *this;
  }
  const char* c_str() const { return data_; }
  bool empty() const { return size_ == 0; }
  void clear() { data_[size_ = 0] = '\0'; }

 private:
  std::size_t size_ = 0;
  char data_[kTextSize] = "";
};

// Adds text as a JSON string, in one line.
template <class Words>
void add_quoted(Words& to, const char* text) {
  to += '"';
  for (; *text != '\0'; ++text) {
    const unsigned char c = static_cast<unsigned char>(*text);
    if (c == '"' || c == '\\') {
      to += '\\';
      to += *text;
    } else if (c < 0x20 || c == 0x7F) {
      const char* const digits = "0123456789abcdef";
      to += "\\u00";
      to += digits[c / 16];
      to += digits[c % 16];
    } else {
      to += *text;
    }
  }
  to += '"';
}

// Adds the names of a joint and of those before it that it is joined with: the links between them
// have neither mass nor inertia.
void add_names_of_run(Text& to, int joint) {
  const int link = kJoints[joint].parent;
  const LinkConstants& own = kLinks[link];
  if (link > 0 && !(own.mass > 0 || own.tensor[0] + own.tensor[4] + own.tensor[8] > 0)) {
    add_names_of_run(to, link - 1);
    to += ", ";
  }
  add_quoted(to, kJoints[joint].name);
}

// A failure in words, about a joint or not.
struct FailureWords {
  bool of_joint;
  const char* text;
};

constexpr FailureWords words_of(Failure kind) {
  switch (kind) {
    case kFine:
      return {false, "no error"};
    case kNotFinite:
      return {true, "its q, v or tau is not a finite number"};
    case kZeroQuaternion:
      return {true, "its quaternion cannot be normalised"};
    case kFactorization:
      return {true, "factorization failed: the inertias beside it differ too much for the scalar"};
    case kGimbalLock:
      return {false,
              "gimbal lock: through links without mass, they do not move in as many directions"};
    case kGrowth:
      return {true,
              "no digits left: a link beside it is too light for its neighbours and the scalar"};
    case kOverflow:
      return {true, "its acceleration is not a finite number (overflow)"};
    case kSingularPose:
      return {true, "its mobility is singular in this pose"};
    case kEnded:
      return {false, "the evaluations are over"};
    case kNotRefined:
      return {false, "refinement does not converge: the inertias differ too much for the scalar"};
    case kTooFewSteps:
      return {false,
              "refinement converges too slowly: its last correction is too large; take more steps "
              "(--refine) or --scalar double"};
    case kLoopOpen:
      return {false, "it is not closed in this configuration, by more than its tolerance"};
    case kLoopTorn:
      return {false, "this velocity tears it open"};
    case kLoopSingular:
      return {false, "this pose is singular: what it holds, and what it leaves free, changes here"};
    case kLoopFree:
      return {true, "closed loops leave it a motion that no inertia resists"};
    case kNotSet:
      return {false, "what is to be set at run time is not finite, or is no mass"};
    case kNoAnswer:
      return {false, " did not answer within the time limit"};
  }
  return {false, "unknown failure"};
}

// Whether a failure is numbered with a loop or coupling, behind all joints.
[[maybe_unused]] constexpr bool is_of_loop(Failure kind) {
  return kind == kLoopOpen || kind == kLoopTorn || kind == kLoopSingular;
}

// Whether a failure is numbered with a joint.
constexpr bool is_of_joint(Failure kind) { return words_of(kind).of_joint || kind == kGimbalLock; }

Text describe(int status) {
  const Failure kind = failure_kind(status);
  const FailureWords words = words_of(kind);
  Text text;
  if (words.of_joint) {
    text += "joint ";
    add_quoted(text, kJoints[failure_place(status)].name);
    text += ": ";
  } else if (kind == kGimbalLock) {
    text += "joints ";
    add_names_of_run(text, failure_place(status));
    text += ": ";
#ifdef ADAGEN_LOOPS
  } else if (is_of_loop(kind)) {
    const int place = failure_place(status) - static_cast<int>(kJoints.size());
    text += place < kLoopCount ? "loop " : "coupling ";
    add_quoted(text, kLoopNames[static_cast<std::size_t>(place)]);
    text += ": ";
#endif
  } else if (kind == kNoAnswer) {
    text += "process ";
    text += failure_place(status);
  }
  text += words.text;
  return text;
}

// Sine and cosine of an angle far from zero.
[[maybe_unused]] inline void far_sine_and_cosine(Real angle, Real& sine, Real& cosine) {
  sine = std::sin(angle), cosine = std::cos(angle);
}

// Numbers side by side, as many as the widest registers hold; narrower machines take them in parts.
constexpr int kLanes = 64 / static_cast<int>(sizeof(Real));
typedef Real Lanes __attribute__((vector_size(64)));
typedef std::conditional_t<sizeof(Real) == 8, std::int64_t, std::int32_t> Bits;
typedef Bits LaneBits __attribute__((vector_size(64)));

// Where registers are narrower, gcc tells that vectors are passed in other ways; none is, all is
// inlined.
#if defined(__GNUC__) && !defined(__clang__)
#pragma GCC diagnostic ignored "-Wpsabi"
#endif

#define ADAGEN_ALWAYS __attribute__((always_inline))
#define ADAGEN_COLD [[maybe_unused]] __attribute__((cold, noinline))  // out of the way of the rest
#define ADAGEN_INLINE [[maybe_unused]] inline ADAGEN_ALWAYS

ADAGEN_INLINE void load(const Real* from, Lanes& x) { std::memcpy(&x, from, sizeof x); }
ADAGEN_INLINE void store(const Lanes& x, Real* to) { std::memcpy(to, &x, sizeof x); }

// Whether any bit is set. Half by half: compilers take lanes apart one by one if left to it.
typedef std::int64_t FourWords __attribute__((vector_size(32)));
typedef std::int64_t TwoWords __attribute__((vector_size(16)));
template <class T>
ADAGEN_INLINE bool any_of(const T& x) {
  if constexpr (sizeof x > sizeof(TwoWords)) {
    typedef std::conditional_t<sizeof x == sizeof(FourWords), TwoWords, FourWords> Half;
    Half halves[2];
    std::memcpy(halves, &x, sizeof x);
    const Half either = halves[0] | halves[1];
    return any_of(either);
  } else {
    std::int64_t words[2]{};
    std::memcpy(words, &x, sizeof x);
    return (words[0] | words[1]) != 0;
  }
}

// Whether all numbers are positive: false for NaN.
ADAGEN_INLINE bool all_positive(const Real& x) { return x > 0; }
template <class T>
ADAGEN_INLINE bool all_positive(const T& x) {
  return !any_of(~(x > T{}));
}

// One number or the other, lane by lane.
ADAGEN_INLINE Lanes chosen(const LaneBits& first, const Lanes& x, const Lanes& y) {
  const LaneBits bits =
      (reinterpret_cast<LaneBits>(x) & first) | (reinterpret_cast<LaneBits>(y) & ~first);
  return reinterpret_cast<Lanes>(bits);
}

ADAGEN_INLINE bool all_zero(const Real& x) { return x == 0; }
ADAGEN_INLINE bool all_zero(const Lanes& x) { return !any_of(x != Lanes{}); }

ADAGEN_INLINE Real hyperbolic_tangent(const Real& x) { return std::tanh(x); }
ADAGEN_INLINE Lanes hyperbolic_tangent(const Lanes& x) {
  Lanes result = x;
  for (int k = 0; k < kLanes; ++k) result[k] = std::tanh(x[k]);
  return result;
}

// Sines and cosines, with an error of about one unit in the last place: the angle less n pi/2 by
// three parts of pi/2 (Cody and Waite), then polynomials (Cephes). The parts are exact up to
// kLargestAngle; beyond, each lane is taken by itself.
template <class R>
struct Trigonometry;

template <>
struct Trigonometry<double> {
  [[maybe_unused]] static constexpr double kLargestAngle = 1e5, kRound = 6755399441055744.0;
  [[maybe_unused]] static constexpr double kTwoOverPi = 0.63661977236758134308;
  [[maybe_unused]] static constexpr double kParts[3] = {
      1.57079632673412561417e+00, 6.07710050630396597660e-11, 2.02226624871116645580e-21};
  [[maybe_unused]] static constexpr double kSine[6] = {
      1.58962301576546568060e-10, -2.50507477628578072866e-8, 2.75573136213857245213e-6,
      -1.98412698295895385996e-4, 8.33333333332211858878e-3,  -1.66666666666666307295e-1};
  [[maybe_unused]] static constexpr double kCosine[6] = {
      -1.13585365213876817300e-11, 2.08757008419747316778e-9,  -2.75573141792967388112e-7,
      2.48015872888517045348e-5,   -1.38888888888730564116e-3, 4.16666666666665929218e-2};
};

template <>
struct Trigonometry<float> {
  [[maybe_unused]] static constexpr float kLargestAngle = 8000.0f, kRound = 12582912.0f;
  [[maybe_unused]] static constexpr float kTwoOverPi = 0.636619772f;
  [[maybe_unused]] static constexpr float kParts[3] = {1.5703125f, 4.837512969970703125e-4f,
                                                       7.54978995489188216e-8f};
  [[maybe_unused]] static constexpr float kSine[3] = {-1.9515295891e-4f, 8.3321608736e-3f,
                                                      -1.6666654611e-1f};
  [[maybe_unused]] static constexpr float kCosine[3] = {
      2.443315711809948e-5f, -1.388731625493765e-3f, 4.166664568298827e-2f};
};

template <std::size_t n>
ADAGEN_INLINE Lanes polynomial(const Real (&coefficients)[n], const Lanes& x) {
  Lanes result = Lanes{} + coefficients[0];
  ADAGEN_FOR (k, 1, static_cast<int>(n)) result = result * x + coefficients[k];
  return result;
}

ADAGEN_COLD inline void take_far_ones(const Lanes& angle, const LaneBits& lanes, Lanes& sine,
                                      Lanes& cosine) {
  for (int k = 0; k < kLanes; ++k) {
    if (!lanes[k]) continue;
    Real s, c;
    far_sine_and_cosine(angle[k], s, c);
    sine[k] = s, cosine[k] = c;
  }
}

// Of angles that are not too large.
ADAGEN_INLINE void near_sine_and_cosine(const Lanes& angle, Lanes& sine, Lanes& cosine) {
  using Table = Trigonometry<Real>;
  const Lanes shifted = angle * Table::kTwoOverPi + Table::kRound;
  const LaneBits quadrant = reinterpret_cast<LaneBits>(shifted);
  const Lanes turns = shifted - Table::kRound;
  const Lanes rest =
      ((angle - turns * Table::kParts[0]) - turns * Table::kParts[1]) - turns * Table::kParts[2];
  const Lanes square = rest * rest;
  const Lanes s = rest + rest * square * polynomial(Table::kSine, square);
  const Lanes c = 1 - square / 2 + square * square * polynomial(Table::kCosine, square);
  const LaneBits swapped = -(quadrant & 1);
  const LaneBits s_bits = reinterpret_cast<LaneBits>(s);
  const LaneBits c_bits = reinterpret_cast<LaneBits>(c);
  constexpr int kSign = 8 * static_cast<int>(sizeof(Real)) - 2;  // bit 1 of a quadrant to the sign
  const LaneBits sine_bits = ((s_bits & ~swapped) | (c_bits & swapped)) ^ ((quadrant & 2) << kSign);
  const LaneBits cosine_bits =
      ((c_bits & ~swapped) | (s_bits & swapped)) ^ (((quadrant + 1) & 2) << kSign);
  sine = reinterpret_cast<Lanes>(sine_bits);
  cosine = reinterpret_cast<Lanes>(cosine_bits);
}

ADAGEN_INLINE LaneBits too_large(const Lanes& angle) {
  constexpr Real kLargest = Trigonometry<Real>::kLargestAngle;
  return (angle > kLargest) | (angle < -kLargest);
}

ADAGEN_INLINE void sine_and_cosine(const Lanes& angle, Lanes& sine, Lanes& cosine) {
  near_sine_and_cosine(angle, sine, cosine);
  const LaneBits beyond = too_large(angle);
  if (__builtin_expect(any_of(beyond), 0)) take_far_ones(angle, beyond, sine, cosine);
}

// Vectors, matrices and spatial inertias in axes that all links of a base share. T is what is
// computed with: one number, or one for each of several states or links.
template <class T>
struct Vector {
  T x, y, z;
};

template <class T>
struct Matrix {
  Vector<T> x, y, z;  // rows
};

template <class T>
struct Symmetric {
  T xx, xy, xz, yy, yz, zz;
};

template <class T>
ADAGEN_INLINE Vector<T> operator+(const Vector<T>& a, const Vector<T>& b) {
  return {a.x + b.x, a.y + b.y, a.z + b.z};
}
template <class T>
ADAGEN_INLINE Vector<T> operator-(const Vector<T>& a, const Vector<T>& b) {
  return {a.x - b.x, a.y - b.y, a.z - b.z};
}
template <class T>
ADAGEN_INLINE Vector<T> operator-(const Vector<T>& a) {
  return {-a.x, -a.y, -a.z};
}
template <class T, class S>
ADAGEN_INLINE Vector<T> operator*(const Vector<T>& a, const S& s) {
  return {a.x * s, a.y * s, a.z * s};
}
template <class T>
ADAGEN_INLINE void operator+=(Vector<T>& a, const Vector<T>& b) {
  a.x += b.x, a.y += b.y, a.z += b.z;
}
template <class T, class S>
ADAGEN_INLINE T dot(const Vector<T>& a, const Vector<S>& b) {
  return a.x * b.x + (a.y * b.y + a.z * b.z);
}
template <class T, class S>
ADAGEN_INLINE Vector<T> cross(const Vector<T>& a, const Vector<S>& b) {
  return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}

template <class T, class S>
ADAGEN_INLINE Vector<T> operator*(const Matrix<T>& m, const Vector<S>& a) {
  return {dot(m.x, a), dot(m.y, a), dot(m.z, a)};
}
template <class T>
ADAGEN_INLINE Vector<T> transposed_times(const Matrix<T>& m, const Vector<T>& a) {
  return {m.x.x * a.x + (m.y.x * a.y + m.z.x * a.z), m.x.y * a.x + (m.y.y * a.y + m.z.y * a.z),
          m.x.z * a.x + (m.y.z * a.y + m.z.z * a.z)};
}
template <class T, class S>
ADAGEN_INLINE Vector<T> row_times(const Vector<T>& a, const Matrix<S>& m) {
  return {a.x * m.x.x + (a.y * m.y.x + a.z * m.z.x), a.x * m.x.y + (a.y * m.y.y + a.z * m.z.y),
          a.x * m.x.z + (a.y * m.y.z + a.z * m.z.z)};
}
template <class T, class S>
ADAGEN_INLINE Matrix<T> operator*(const Matrix<T>& a, const Matrix<S>& b) {
  return {row_times(a.x, b), row_times(a.y, b), row_times(a.z, b)};
}
template <class T>
ADAGEN_INLINE Vector<T> operator*(const Symmetric<T>& m, const Vector<T>& a) {
  return {m.xx * a.x + (m.xy * a.y + m.xz * a.z), m.xy * a.x + (m.yy * a.y + m.yz * a.z),
          m.xz * a.x + (m.yz * a.y + m.zz * a.z)};
}
template <class T>
ADAGEN_INLINE void operator+=(Symmetric<T>& a, const Symmetric<T>& b) {
  a.xx += b.xx, a.xy += b.xy, a.xz += b.xz, a.yy += b.yy, a.yz += b.yz, a.zz += b.zz;
}
template <class T>
ADAGEN_INLINE void operator+=(Matrix<T>& a, const Matrix<T>& b) {
  a.x += b.x, a.y += b.y, a.z += b.z;
}

// A body about a point: spatial inertia [[A, B], [B^T, C]] (A rotational, C of mass) and bias force
// [n; f]. It is a link, or a link with all that hangs on it.
template <class T>
struct Body {
  Symmetric<T> A;
  Matrix<T> B;
  Symmetric<T> C;
  Vector<T> n, f;
};

template <class T>
ADAGEN_INLINE void operator+=(Body<T>& a, const Body<T>& b) {
  a.A += b.A, a.B += b.B, a.C += b.C, a.n += b.n, a.f += b.f;
}

// The body told about the point at -r from the one that it is told about: B + rx C, and
// A + rx B^T - (B + rx C) rx.
template <class T>
ADAGEN_INLINE void shift(Body<T>& X, const Vector<T>& r) {
  const Symmetric<T>& C = X.C;
  const Matrix<T> B{{X.B.x.x + (r.y * C.xz - r.z * C.xy), X.B.x.y + (r.y * C.yz - r.z * C.yy),
                     X.B.x.z + (r.y * C.zz - r.z * C.yz)},
                    {X.B.y.x + (r.z * C.xx - r.x * C.xz), X.B.y.y + (r.z * C.xy - r.x * C.yz),
                     X.B.y.z + (r.z * C.xz - r.x * C.zz)},
                    {X.B.z.x + (r.x * C.xy - r.y * C.xx), X.B.z.y + (r.x * C.yy - r.y * C.xy),
                     X.B.z.z + (r.x * C.yz - r.y * C.xz)}};
  X.A.xx += (r.y * X.B.x.z - r.z * X.B.x.y) - (B.x.y * r.z - B.x.z * r.y);
  X.A.xy += (r.y * X.B.y.z - r.z * X.B.y.y) - (B.x.z * r.x - B.x.x * r.z);
  X.A.xz += (r.y * X.B.z.z - r.z * X.B.z.y) - (B.x.x * r.y - B.x.y * r.x);
  X.A.yy += (r.z * X.B.y.x - r.x * X.B.y.z) - (B.y.z * r.x - B.y.x * r.z);
  X.A.yz += (r.z * X.B.z.x - r.x * X.B.z.z) - (B.y.x * r.y - B.y.y * r.x);
  X.A.zz += (r.x * X.B.z.y - r.y * X.B.z.x) - (B.z.x * r.y - B.z.y * r.x);
  X.B = B;
  X.n += cross(r, X.f);
}

// The same for a body whose A and B are zero, as a point mass's: B = rx C, A = -B rx.
template <class T>
ADAGEN_INLINE void shift_mass(Body<T>& X, const Vector<T>& r) {
  const Symmetric<T>& C = X.C;
  const Vector<T> Cx{C.xx, C.xy, C.xz}, Cy{C.xy, C.yy, C.yz}, Cz{C.xz, C.yz, C.zz};
  X.B = {Cz * r.y - Cy * r.z, Cx * r.z - Cz * r.x, Cy * r.x - Cx * r.y};
  const Vector<T> Ax = cross(r, X.B.x), Ay = cross(r, X.B.y), Az = cross(r, X.B.z);
  X.A = {Ax.x, Ax.y, Ax.z, Ay.y, Ay.z, Az.z};
  X.n += cross(r, X.f);
}

// The inertia less U U^T / D, U = [n; f] and e = U / D.
template <class T>
ADAGEN_INLINE void subtract(Body<T>& X, const Vector<T>& n, const Vector<T>& f,
                            const Vector<T>& e_n, const Vector<T>& e_f) {
  X.A.xx -= e_n.x * n.x, X.A.xy -= e_n.x * n.y, X.A.xz -= e_n.x * n.z;
  X.A.yy -= e_n.y * n.y, X.A.yz -= e_n.y * n.z, X.A.zz -= e_n.z * n.z;
  X.B.x.x -= e_n.x * f.x, X.B.x.y -= e_n.x * f.y, X.B.x.z -= e_n.x * f.z;
  X.B.y.x -= e_n.y * f.x, X.B.y.y -= e_n.y * f.y, X.B.y.z -= e_n.y * f.z;
  X.B.z.x -= e_n.z * f.x, X.B.z.y -= e_n.z * f.y, X.B.z.z -= e_n.z * f.z;
  X.C.xx -= e_f.x * f.x, X.C.xy -= e_f.x * f.y, X.C.xz -= e_f.x * f.z;
  X.C.yy -= e_f.y * f.y, X.C.yz -= e_f.y * f.z, X.C.zz -= e_f.z * f.z;
}

// Where a point moves that is at r from one that moves as [angular; linear].
template <class T>
struct Motion {
  Vector<T> angular, linear;
};

template <class T, class S>
ADAGEN_INLINE void carry(Motion<T>& a, const Vector<S>& r) {
  a.linear += cross(a.angular, r);
}

// The rotation that a quaternion x y z w of any length stands for, and its squared length.
template <class T>
ADAGEN_INLINE T rotation(const T& x, const T& y, const T& z, const T& w, Matrix<T>& R) {
  const T squared = (x * x + y * y) + (z * z + w * w);
  const T s = 2 / squared;
  const T xx = s * x * x, yy = s * y * y, zz = s * z * z, xy = s * x * y, xz = s * x * z,
          yz = s * y * z, xw = s * x * w, yw = s * y * w, zw = s * z * w;
  R = {{1 - (yy + zz), xy - zw, xz + yw},
       {xy + zw, 1 - (xx + zz), yz - xw},
       {xz - yw, yz + xw, 1 - (xx + yy)}};
  return squared;
}

constexpr std::array<MessageInfo, 0> kMessages{ {
} };

// One process exchanges with none: what the code around it asks of a channel, without MPI.
class Take;

class Channel {
 public:
  template <class... Any>
  const char* open(const Any&...) {
    return "";
  }
  void close() {}
  Number* outgoing(int, int&) { return nullptr; }
  void send(int, int&) {}
  const Number* receive(int, int&, bool = false) { return nullptr; }
  void await_end() {}
  void send_end(int) {}
  void use(Take*) {}
  static void fail(int& status, int failure) {
    if (status == kFine) status = failure;
  }
  static constexpr int comm() { return 0; }
  static constexpr int rank() { return 0; }
  static constexpr bool broken() { return false; }
  static constexpr bool windowed() { return false; }
  static constexpr bool on_one_host() { return true; }
  static constexpr const char* name() { return "none"; }
};

// Time stamps between the stages of a process's work (--trace); nothing is stamped otherwise.
std::chrono::steady_clock::rep* trace_stamps =
    nullptr;  // where an evaluation puts them: its start, then each end

[[maybe_unused]] inline void stamp(int k) {
  if (trace_stamps) trace_stamps[k] = std::chrono::steady_clock::now().time_since_epoch().count();
}

// ---- 4. kernels ---------------------------------------------------------------------------------
// Vectors are in the axes of the base, which all its links share (of the ground, or of a floating
// base's link), about each link's own origin. Links move as they would were all joint accelerations
// zero (omega, alpha, a); joint accelerations are solved for as what comes on top.

// What is computed with.
using Value = Real;

// A link's mass, that times its centre of mass, and its pseudo-inertia, sum of m x x^T: xx xy xz yy
// yz zz. About the link's origin.
struct LinkInertia {
  Real mass, moments[3], tensor[6];
};
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

// Where a joint, and the link beyond it, lie in memory: limbs side by side take turns, and so do
// segments of long runs.
constexpr int kSlotCount = 30;
constexpr int kTile = 0;  // joints that are swept before others take their memory; 0: all
constexpr bool kAbreast = true;  // whether there are such
constexpr bool kPrescribedAbreast = false;  // with motions that are prescribed
constexpr bool kReordered = true;  // whether joints lie in another order than they have
constexpr int kSlots[kJointCount]{ 24, 0, 4, 8, 12, 16, 20, 1, 5, 9, 13, 17, 21, 25, 26, 27, 2, 6, 10, 14, 18, 22, 28, 29, 3, 7, 11, 15, 19, 23 };
// Blocks of slots of equal constants: the number of kinds (0: not looked at), each block's, and the
// first block of each.
constexpr int kBlockKindCount = 0;
[[maybe_unused]] constexpr int kBlockKinds[]{ 0 };
[[maybe_unused]] constexpr int kFirstOfKind[]{ 0 };
constexpr bool kByColumns = true;  // whether runs are taken by columns
// Joints that are eliminated in their own axes; others that are where those of the base lose digits.
constexpr bool kAnyTurned = false;
constexpr bool kTurned[kJointCount]{ 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0 };
constexpr bool kAnyTurnedIfLost = false;
constexpr bool kTurnedIfLost[kJointCount]{ 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0 };
constexpr double kLosing = 256.0;  // times D: a trace from which on they do
// Whether sweeps are done again for other forces on links than their motion takes.
constexpr bool kPassesFree = false;  // whether mobilities pass floating joints
constexpr bool kAgain = kRefine > 0 || kSlavedCount > 0;

// What a process does at a link.
struct LinkRole {
  bool gathers;   // paths meet at it inwards
  bool adds_own;  // its own inertia is this process's to add
  bool parts;     // paths part at it outwards
  bool oriented;  // the quaternion of the joint above it is this process's to take
};
constexpr LinkRole kRoles[1][kLinkCount]{
    {{0, 0, 0, 0}, {1, 1, 1, 0}, {0, 1, 0, 0}, {0, 1, 0, 0}, {0, 1, 0, 0}, {0, 1, 0, 0}, {0, 1, 0, 0}, {0, 1, 0, 0}, {0, 1, 0, 0}, {0, 1, 0, 0}, {0, 1, 0, 0}, {0, 1, 0, 0}, {0, 1, 0, 0}, {0, 1, 0, 0}, {0, 1, 0, 0}, {0, 1, 0, 0}, {1, 1, 1, 0}, {0, 1, 0, 0}, {0, 1, 0, 0}, {0, 1, 0, 0}, {0, 1, 0, 0}, {0, 1, 0, 0}, {0, 1, 0, 0}, {0, 1, 0, 0}, {0, 1, 0, 0}, {0, 1, 0, 0}, {0, 1, 0, 0}, {0, 1, 0, 0}, {0, 1, 0, 0}, {0, 1, 0, 0}, {0, 1, 0, 0}},
};

// Where an evaluation finds the state, and puts what it answers.
struct State {
  const Value* q = nullptr;
  const Value* v = nullptr;
  const Value* tau = nullptr;
  Value* qdd = nullptr;
};

// What is kept where segments meet, with the joint that it belongs to.
struct Cuts {
};

// Constants of the model. What is set up for many links at once lies in blocks, side by side.
constexpr int kPerBlock = static_cast<int>(sizeof(Lanes) / sizeof(Value));  // links in a block
constexpr int kBlockCount = (kSlotCount + kPerBlock - 1) / kPerBlock;

constexpr int slot_of(int j) { return kReordered ? kSlots[j] : j; }

// A number of each joint of a block, as constants of the model are kept.
using PerJoint = std::array<Real, sizeof(Value) == sizeof(Real) ? kPerBlock : 1>;

struct alignas(64) BlockConstants {
  PerJoint rotation[kTile > 0 ? 9 : 6];  // joint frame to parent link's axes: columns x, y, and z
                                         // in tiles
  PerJoint x, y, z;                      // of the joint's origin in the parent link's frame
  PerJoint mass, moments[3], tensor[6];
};

constexpr void fill(PerJoint& numbers, Real x) {
  for (Real& number : numbers) number = x;
}

// The constants of blocks that are alike stand once: which ones a block has, and a block that does.
constexpr int constants_at(int block) { return kBlockKindCount > 0 ? kBlockKinds[block] : block; }
constexpr bool has_own_constants(int block) {
  return kBlockKindCount == 0 || kFirstOfKind[kBlockKinds[block]] == block;
}
constexpr int kConstantsCount = kBlockKindCount > 0 ? kBlockKindCount : kBlockCount;
constexpr std::array<BlockConstants, kConstantsCount> kBlockConstants = [] {
  std::array<BlockConstants, kConstantsCount> result{};
  for (BlockConstants& block : result) {  // slots that are not filled do not turn, but weigh
    for (const int k : {0, 4}) fill(block.rotation[k], 1);
    if constexpr (kTile > 0) fill(block.rotation[8], 1);
    fill(block.mass, 1);
    for (const int k : {0, 3, 5}) fill(block.tensor[k], 1);
  }
  for (int j = 0; j < kJointCount; ++j) {
    const int place = slot_of(j) / kPerBlock;
    if (!has_own_constants(place)) continue;
    BlockConstants& block = result[static_cast<std::size_t>(constants_at(place))];
    const std::size_t lane = static_cast<std::size_t>(slot_of(j) % kPerBlock);
    const LinkInertia& link = kInertias[static_cast<std::size_t>(j)];
    const JointConstants& joint = kJoints[static_cast<std::size_t>(j)];
    for (int k = 0; k < (kTile > 0 ? 9 : 6); ++k)
      block.rotation[k][lane] = joint.rotation[k % 3 * 3 + k / 3];
    block.x[lane] = joint.translation[0];
    block.y[lane] = joint.translation[1];
    block.z[lane] = joint.translation[2];
    block.mass[lane] = link.mass;
    for (int k = 0; k < 3; ++k) block.moments[k][lane] = link.moments[k];
    for (int k = 0; k < 6; ++k) block.tensor[k][lane] = link.tensor[k];
  }
  return result;
}();

// Inertias of links are constants.
struct Inertias {
  static const LinkInertia& inertia_of(int joint) {
    return kInertias[static_cast<std::size_t>(joint)];
  }
  static const BlockConstants& constants_of(int block) {
    return kBlockConstants[static_cast<std::size_t>(constants_at(block))];
  }
};

// The memory of a process.

// Joints that are treated together, one in each lane of T; their slots follow each other.
template <class T>
[[maybe_unused]] constexpr int kWidth = static_cast<int>(sizeof(T) / sizeof(Value));
template <class T>
struct Joints {
  int slot;  // of the first one
  int joint[kWidth<T>];

  constexpr const JointConstants& any() const {
    return kJoints[static_cast<std::size_t>(joint[0])];
  }
};
ADAGEN_INLINE Joints<Value> single(int j) { return {slot_of(j), {j}}; }

// The lanes of limbs side by side.
typedef Real Two __attribute__((vector_size(2 * sizeof(Real))));
typedef Real Four __attribute__((vector_size(4 * sizeof(Real))));

// A number of each of the joints.
template <class T, class Number, std::size_t... lane>
ADAGEN_INLINE T each_of(const Joints<T>& joints, const Number& number,
                        std::index_sequence<lane...>) {
  return T{Real(number(kJoints[static_cast<std::size_t>(joints.joint[lane])]))...};
}
template <class T, class Number>
ADAGEN_INLINE T each(const Joints<T>& joints, const Number& number) {
  if constexpr (kWidth<T> == 1) {
    const auto one = number(kJoints[static_cast<std::size_t>(joints.joint[0])]);
    if constexpr (std::is_same_v<decltype(one), const T>)
      return one;
    else
      return T{} + one;
  } else {
    return each_of(joints, number, std::make_index_sequence<kWidth<T>>{});
  }
}

// Blocks in memory: all, or those of a tile, which the tiles of a run take in turn (tiles.hpp).
constexpr int kWindow = kTile > 0 ? kTile / kPerBlock : kBlockCount;
[[maybe_unused]] constexpr int kColumnCount = kTile > 0 ? kTile : kJointCount;

// What a block holds of each link j + 1, joint j being the one above it; in the axes of its base.
enum Entry : int {
  kTurn = 0,           // rotation from the child's to the parent link's axes, row by row
  kAxes = 9,           // the link's orientation R, row by row: its z is the joint's axis
  kOmega = 18,         // angular velocity
  kAlpha = 21,         // angular acceleration and
  kAcceleration = 24,  // acceleration of its origin less gravity, were all joint accelerations zero
  kRotational = 27,    // A of the bare link
  kMoments = 33,       // mass times centre of mass: B of the bare link is its cross product
  kTorque = 36,        // bias force n
  kForce = 39,         // and f of the bare link
  kEntries = 42
};

// Whether joints have one freedom each, so that their numbers are those of their freedoms.
[[maybe_unused]] constexpr bool one_each() {
  for (int j = 0; j < kJointCount; ++j)
    if (kJoints[static_cast<std::size_t>(j)].v != j) return false;
  return kJointCount == kNv;
}
[[maybe_unused]] constexpr bool kOneEach = one_each();

struct alignas(64) Block {
  Value entries[kEntries][kPerBlock];
};

// Three numbers of each of the joints, that follow each other in x.
template <class T>
ADAGEN_INLINE Vector<T> each_vector(const Joints<T>& joints, const Value* x,
                                    int JointConstants::* place) {
  const auto number = [&](int k) {
    return each(joints, [&](const JointConstants& own) { return x[own.*place + k]; });
  };
  return {number(0), number(1), number(2)};
}

// Whether a joint between moving links is of a kind; one on the ground that floats needs nothing.
[[maybe_unused]] constexpr bool any_of(JointKind kind) {
  for (const JointConstants& joint : kJoints)
    if (joint.kind == kind && (joint.parent > 0 || kind != JointKind::kFloating)) return true;
  return false;
}
// Asked once each, not where templates use it: g++ takes time quadratic in the joints there.
[[maybe_unused]] constexpr bool kAnyPrismatic = any_of(JointKind::kPrismatic);
[[maybe_unused]] constexpr bool kAnySpherical = any_of(JointKind::kSpherical);
[[maybe_unused]] constexpr bool kAnyPlanar = any_of(JointKind::kPlanar);
[[maybe_unused]] constexpr bool kAnyFloating = any_of(JointKind::kFloating);
[[maybe_unused]] constexpr bool any_passive() {
  for (const JointConstants& joint : kJoints) {
    const Passive& own = joint.passive;
    if (own.damping != 0 || own.friction != 0 || own.stiffness != 0 || own.rotor != 0) return true;
  }
  return false;
}
[[maybe_unused]] constexpr bool kAnyPassive = any_passive();

// Whether a joint's axis lies beside what it is treated with, and not with those of its block.
template <class T>
constexpr bool kWithAxis = kByColumns && kWidth<T> == 1;
// Of a joint with one freedom: U / D (6), u / D, 1 / D; of others see inward.hpp.
constexpr int kMostFactors = kAnyPlanar ? 24 : kAnySpherical ? 18 : 8;

// What is kept of a joint from the inward to the outward sweep.
template <class T, bool with_axis = kWithAxis<T>>
struct Eliminated {
  Vector<T> r;  // from the parent link's origin to the child link's
  T e[kMostFactors];
};
template <class T>
struct alignas(64) Eliminated<T, true> {
  Vector<T> axis;
  T none;  // so that axis and r lie as the halves of a column
  Vector<T> r;
  T nothing;
  T e[kMostFactors];
};
using Memory = Eliminated<Value>;

// A bare link as it is added to columns (see inward_columns.hpp).
struct alignas(64) LinkColumns {
  Real tensor[8], moments[8], force[8];
};

// A link's orientation and how it moves, were all joint accelerations zero.
template <class T>
struct Frame {
  Matrix<T> R;
  Vector<T> omega, alpha, a;
};

struct Workspace : State, Cuts, Inertias {
  int status = kFine;
  bool lost = false;   // whether a sweep in axes of the base found too few digits left
  bool again = false;  // whether links feel the forces in their blocks, and no motion's
  alignas(64) std::array<Value, kWindow * kPerBlock> angle{};  // of each joint that turns
  std::array<Block, kWindow> blocks{};
  std::array<Memory, kJointCount> joints{};
  std::array<Eliminated<Two>, kAbreast ? kSlotCount / 2 : 0> twos{};  // of joints in lanes, by slot
  std::array<Eliminated<Four>, kAbreast ? kSlotCount / 4 : 0> fours{};
  // Of the link beyond each joint, and one for slots that are not filled.
  std::array<LinkColumns, kByColumns ? kColumnCount + 1 : 0> columns{};
  std::array<Body<Value>, kLinkCount> bodies{};     // what hangs on a link, where paths meet
  std::array<Motion<Value>, kLinkCount> motions{};  // accelerations beyond those of a Frame
  std::array<Value, kNv> answer{};
  std::array<Body<Value>, kPassesFree ? kJointCount : 0> free{};  // beyond floating joints
  std::array<Body<Value>, kRefine ? kJointCount : 0> whole{};  // beyond each joint, to be refined

  Workspace() {
    for (Block& block : blocks)  // slots that are not filled do not turn
      for (const int k : {0, 4, 8}) std::fill_n(block.entries[kTurn + k], kPerBlock, Value{} + 1);
    for (int j = 0; j < kJointCount; ++j)  // what an angle does not change stays as it is
      for (int k = 0; k < 9; ++k)
        of(j, kTurn)[k * kPerBlock] = Value{} + kJoints[static_cast<std::size_t>(j)].rotation[k];
  }

  Value* of(int joint, Entry entry) { return at(slot_of(joint), entry); }
  Value* at(int slot, Entry entry) {
    const int block = slot / kPerBlock % kWindow;
    return &blocks[static_cast<std::size_t>(block)].entries[entry][slot % kPerBlock];
  }

  template <class T>
  Eliminated<T>& memory(const Joints<T>& of) {
    if constexpr (kWidth<T> == 1)
      return joints[static_cast<std::size_t>(of.joint[0])];
    else if constexpr (kWidth<T> == 2)
      return twos[static_cast<std::size_t>(of.slot / 2)];
    else
      return fours[static_cast<std::size_t>(of.slot / 4)];
  }
};

template <class T = Value>
ADAGEN_INLINE T number_at(const Value* x) {
  T result;
  std::memcpy(&result, x, sizeof result);
  return result;
}
template <class T>
ADAGEN_INLINE void put_at(Value* x, const T& number) {
  std::memcpy(x, &number, sizeof number);
}
template <class T = Value>
ADAGEN_INLINE Vector<T> vector_at(const Value* x, int stride = kPerBlock) {
  return {number_at<T>(x), number_at<T>(x + stride), number_at<T>(x + 2 * stride)};
}
template <class T>
ADAGEN_INLINE void put_at(Value* x, const Vector<T>& a) {
  put_at(x, a.x), put_at(x + kPerBlock, a.y), put_at(x + 2 * kPerBlock, a.z);
}
template <class T = Value>
ADAGEN_INLINE Matrix<T> matrix_at(const Value* x) {
  return {vector_at<T>(x), vector_at<T>(x + 3 * kPerBlock), vector_at<T>(x + 6 * kPerBlock)};
}
template <class T>
ADAGEN_INLINE void put_at(Value* x, const Matrix<T>& m) {
  put_at(x, m.x), put_at(x + 3 * kPerBlock, m.y), put_at(x + 6 * kPerBlock, m.z);
}
template <class T = Value>
ADAGEN_INLINE Vector<T> axis_at(const Value* R) {
  return vector_at<T>(R + 2 * kPerBlock, 3 * kPerBlock);
}
template <class T>
ADAGEN_INLINE Vector<T> axis_of(Workspace& w, const Joints<T>& joints) {
  if constexpr (kWithAxis<T>)
    return w.memory(joints).axis;
  else
    return axis_at<T>(w.at(joints.slot, kAxes));
}

// A body in a message.
[[maybe_unused]] constexpr int kBodyNumbers = 27;
template <class T>
ADAGEN_INLINE Number* put(Number* to, const Body<T>& X) {
  static_assert(sizeof X == kBodyNumbers * sizeof(Real));
  Real numbers[kBodyNumbers];
  std::memcpy(numbers, &X, sizeof X);
  return std::copy_n(numbers, kBodyNumbers, to);
}
template <class T>
ADAGEN_INLINE const Number* get(const Number* from, Body<T>& X) {
  Real numbers[kBodyNumbers];
  std::copy_n(from, kBodyNumbers, numbers);
  std::memcpy(&X, numbers, sizeof X);
  return from + kBodyNumbers;
}
template <class T>
ADAGEN_INLINE const Number* add(const Number* from, Body<T>& X) {
  Body<T> other;
  from = get(from, other);
  X += other;
  return from;
}

ADAGEN_INLINE Lanes wide(const Value* x) {
  Lanes result;
  std::memcpy(&result, x, sizeof result);
  return result;
}

// The torque along one of a joint's freedoms that reaches the links: less damping, spring and
// friction.
ADAGEN_INLINE Value torque(const Workspace& w, const JointConstants& joint, int freedom = 0);
ADAGEN_INLINE Value torque(const Workspace& w, int joint) {
  if constexpr (kOneEach && !kAnyPassive) return w.tau[joint];
  return torque(w, kJoints[static_cast<std::size_t>(joint)]);
}
ADAGEN_INLINE Value torque(const Workspace& w, const JointConstants& joint, int freedom) {
  Value tau = w.tau[joint.v + freedom];
  if constexpr (kAnyPassive) {
    const Passive& own = joint.passive;
    const Value& qd = w.v[joint.v + freedom];
    if (own.damping != 0) tau -= own.damping * qd;
    if (own.stiffness != 0 && !(kAgain && w.again))
      tau -= own.stiffness * (w.q[joint.q] - own.rest);
    if (own.friction != 0) tau -= own.friction * hyperbolic_tangent(qd / own.friction_speed);
  }
  return tau;
}

// A joint of prescribed motion among limbs side by side gives way to nothing and moves as told.
ADAGEN_INLINE Real immovable(const JointConstants& joint) {
  return joint.passive.prescribed ? std::numeric_limits<Real>::infinity() : 0;
}
ADAGEN_INLINE Value prescribed(const Workspace& w, const JointConstants& joint) {
  return joint.passive.prescribed ? w.tau[joint.v] : Value{};
}

// Accelerations are given only where all went well.
inline void give(Workspace& w, int first, int count) {
  if (w.status == kFine)
    std::copy_n(&w.answer[static_cast<std::size_t>(first)], count, w.qdd + first);
}

[[maybe_unused]] constexpr int block(int joint) { return joint / kPerBlock; }
[[maybe_unused]] constexpr bool is_identity(const Number (&R)[9]) {
  for (int k = 0; k < 9; ++k)
    if (R[k] != (k % 4 == 0 ? 1 : 0)) return false;
  return true;
}

inline double gravity(const Workspace&, int k) { return kGravity[static_cast<std::size_t>(k)]; }

// What cannot be solved is refused, with the joint at fault.

// D beside the trace of what it is found in: less than this is rounding and nothing else.
constexpr Real kLeast = 16 * std::numeric_limits<Real>::epsilon();

// Less than this calls for the joint's own axes, where there is a way to take them: a sweep in axes
// of the base loses as many digits as D is smaller than the trace.
constexpr Real kEnough = kAnyTurnedIfLost ? Real(1 / kLosing) : kLeast;

ADAGEN_COLD inline void fail(Workspace& w, Failure kind, int joint) {
  Channel::fail(w.status, failure(kind, joint));
}

// x - x is zero, in all bits, for finite x only.
ADAGEN_INLINE LaneBits unlike_zero(const Value* x) {
  return reinterpret_cast<LaneBits>(wide(x) - wide(x));
}
ADAGEN_INLINE bool finite(const Value* x, int count) {
  LaneBits found{};
  int k = 0;
  for (; k + kPerBlock <= count; k += kPerBlock) found |= unlike_zero(x + k);
  if (k > 0 && k < count)
    found |= unlike_zero(x + count - kPerBlock);  // some of them once more
  else
    for (; k < count; ++k)
      if (!all_zero(x[k] - x[k])) return false;
  return !any_of(found);
}

// Tells which of entries first .. is the first that is not finite; place says where a joint's
// entries start.
ADAGEN_COLD inline void refuse(Workspace& w, const Value* x, int first, int JointConstants::* place,
                               Failure kind) {
  while (finite(x + first, 1)) ++first;
  int joint = 0;
  for (int j = 0; j < kJointCount; ++j)
    if (kJoints[static_cast<std::size_t>(j)].*place <= first) joint = j;
  fail(w, kind, joint);
}

// Refuses entries first .. first + count - 1 of the state, or of the answer, if one is not finite.
inline void require_finite(Workspace& w, const Value* x, int first, int count,
                           int JointConstants::* place, Failure kind) {
  if (__builtin_expect(!finite(x + first, count), 0)) refuse(w, x, first, place, kind);
}

// Whether nothing failed, and entries first .. first + count - 1 of the answer are finite.
ADAGEN_INLINE bool went_well(const Workspace& w, int first, int count) {
  return __builtin_expect(
      w.status == kFine && finite(&w.answer[static_cast<std::size_t>(first)], count), 1);
}

template <class T>
ADAGEN_INLINE bool has_length(const T& squared) {
  return all_positive(squared - std::numeric_limits<Real>::min()) &&
         all_positive(std::numeric_limits<Real>::max() - squared);
}
template <class T>
void require_length(Workspace& w, const T& squared, int joint) {
  if (!has_length(squared)) fail(w, kZeroQuaternion, joint);
}

// An elimination failed for one of the joints: for that whose number is not positive.
template <class T>
ADAGEN_COLD void fail_one(Workspace& w, const Joints<T>& joints, [[maybe_unused]] const T& x) {
  int lane = 0;
  if constexpr (kWidth < T >> 1)
    while (lane + 1 < kWidth<T> && x[lane] > 0) ++lane;
  fail(w, kFactorization, joints.joint[lane]);
}

// D is less than enough beside the trace of what it is found in, for one of the joints at least:
// its sweep is repeated in other axes, or fails where that is no way and nothing but rounding is
// left.
template <class T>
ADAGEN_COLD void lose(Workspace& w, const Joints<T>& joints, const T& D, const T& trace) {
  for (std::size_t lane = 0; lane < kWidth<T>; ++lane) {
    Value own = Value{}, whole = Value{};
    if constexpr (kWidth<T> == 1)
      own = D, whole = trace;
    else
      own = D[lane], whole = trace[lane];
    const int j = joints.joint[lane];
    if (kAnyTurnedIfLost && kTurnedIfLost[j])
      w.lost |= !all_positive(own - kEnough * whole);
    else if (!all_positive(own - kLeast * whole))
      fail(w, kFactorization, j);
  }
}

// Loops over rows of joints: a run's joints, or those of limbs side by side, of one kind each.
// Where few stretches of one kind follow each other, each is a loop of its own that knows its kind.
template <int first, int last>
struct RunRows {
  static constexpr int kCount = last - first + 1;
  static constexpr JointKind kind(int k) {
    return kJoints[static_cast<std::size_t>(first + k)].kind;
  }
};

constexpr int kMostStretches = 8;

// Where the stretch ends that begins with the k-th row of an order.
template <class Rows, bool backwards>
constexpr int end_of_stretch(int k) {
  const auto kind = [](int i) { return Rows::kind(backwards ? Rows::kCount - 1 - i : i); };
  int end = k + 1;
  while (end < Rows::kCount && kind(end) == kind(k)) ++end;
  return end;
}
template <class Rows>
constexpr bool few_stretches() {
  int count = 0;
  for (int k = 0; k < Rows::kCount; ++count) k = end_of_stretch<Rows, false>(k);
  return count <= kMostStretches;
}

// Calls step(row, kind) for each row, the last one first if backwards.
template <class Rows, bool backwards, int begin = 0, class Step>
ADAGEN_INLINE void each_row(const Step& step) {
  constexpr auto row = [](int k) { return backwards ? Rows::kCount - 1 - k : k; };
  if constexpr (few_stretches<Rows>()) {
    constexpr int end = end_of_stretch<Rows, backwards>(begin);
    constexpr std::integral_constant<JointKind, Rows::kind(row(begin))> kind;
    for (int k = begin; k < end; ++k) step(row(k), kind);
    if constexpr (end < Rows::kCount) each_row<Rows, backwards, end>(step);
  } else {
    for (int k = 0; k < Rows::kCount; ++k) step(row(k), Rows::kind(row(k)));
  }
}

// What needs no recursion, for as many links at once as a register holds.

// Constants of each of the joints.
template <class T>
ADAGEN_INLINE T constant(const Joints<T>& joints, PerJoint BlockConstants::* member) {
  const int place = constants_at(joints.slot / kPerBlock);
  const auto& block = kBlockConstants[static_cast<std::size_t>(place)];
  return number_at<T>(&(block.*member)[static_cast<std::size_t>(joints.slot % kPerBlock)]);
}
template <class T>
ADAGEN_INLINE auto mass_of(const Workspace& w, const Joints<T>& joints) {
  if constexpr (kWidth<T> == 1)
    return w.inertia_of(joints.joint[0]).mass;
  else
    return number_at<T>(&w.constants_of(joints.slot / kPerBlock)
                             .mass[static_cast<std::size_t>(joints.slot % kPerBlock)]);
}
template <class T>
ADAGEN_INLINE auto origin_of(const Joints<T>& joints) {
  if constexpr (kWidth<T> == 1) {
    const Number* const x = joints.any().translation;
    return Vector<Real>{Real(x[0]), Real(x[1]), Real(x[2])};
  } else {
    return Vector<T>{constant(joints, &BlockConstants::x), constant(joints, &BlockConstants::y),
                     constant(joints, &BlockConstants::z)};
  }
}

ADAGEN_INLINE Lanes wide(const PerJoint& x) {
  Lanes result;
  if constexpr (sizeof(PerJoint) == sizeof(Lanes))
    std::memcpy(&result, x.data(), sizeof result);
  else
    result = x[0] + Lanes{};
  return result;
}
ADAGEN_INLINE void narrow(const Lanes& x, Value* to) { std::memcpy(to, &x, sizeof x); }
ADAGEN_INLINE Vector<Lanes> wide_vector(const Value (*x)[kPerBlock]) {
  return {wide(x[0]), wide(x[1]), wide(x[2])};
}
ADAGEN_INLINE Vector<Lanes> wide_vector(const PerJoint* x) {
  return {wide(x[0]), wide(x[1]), wide(x[2])};
}
ADAGEN_INLINE void narrow(const Vector<Lanes>& a, Value (*x)[kPerBlock]) {
  narrow(a.x, x[0]), narrow(a.y, x[1]), narrow(a.z, x[2]);
}

// Copies the angles of those of joints first .. last that turn.
template <int first, int last>
void take_angles(Workspace& w) {
  ADAGEN_FOR (j, first, last + 1) {
    const JointConstants& joint = kJoints[static_cast<std::size_t>(j)];
    const int place = joint.q + (joint.kind == JointKind::kPlanar ? 2 : 0);
    if (joint.kind == JointKind::kRevolute || joint.kind == JointKind::kPlanar)
      w.angle[static_cast<std::size_t>(slot_of(j))] = w.q[place];
  }
}

// Turns the joints of blocks first .. last - 1 by their angles: columns x and y of the rotation.
// Of tiles beyond the first one blocks lie behind by as many as told.
template <int first, int last>
void turn(Workspace& w, int beyond = 0) {
  for (int b = first; b < last; ++b) {
    Block& block = w.blocks[static_cast<std::size_t>(b)];
    const int place = constants_at(b + beyond);
    const BlockConstants& constants = kBlockConstants[static_cast<std::size_t>(place)];
    Lanes s, c;
    sine_and_cosine(wide(&w.angle[static_cast<std::size_t>(b * kPerBlock)]), s, c);
    ADAGEN_FOR (k, 0, 3) {
      const Lanes x = wide(constants.rotation[k]), y = wide(constants.rotation[3 + k]);
      narrow(x * c + y * s, block.entries[kTurn + 3 * k]);
      narrow(y * c - x * s, block.entries[kTurn + 3 * k + 1]);
      if constexpr (kTile > 0)
        narrow(wide(constants.rotation[6 + k]), block.entries[kTurn + 3 * k + 2]);
    }
  }
}

// The bias force of a bare link of pseudo-inertia J and moments c about its origin: that of the
// acceleration field a + H x, H = alpha x + omega x omega x. All in the same axes.
template <class T>
ADAGEN_INLINE void bias_force(const Symmetric<T>& J, const Vector<T>& c, const T& mass,
                              const Vector<T>& w, const Vector<T>& al, const Vector<T>& a,
                              Vector<T>& n, Vector<T>& f) {
  const T xx = w.x * w.x, yy = w.y * w.y, zz = w.z * w.z;
  const T xy = w.x * w.y, xz = w.x * w.z, yz = w.y * w.z;
  const Matrix<T> H{{-(yy + zz), xy - al.z, xz + al.y},
                    {xy + al.z, -(xx + zz), yz - al.x},
                    {xz - al.y, yz + al.x, -(xx + yy)}};
  const Vector<T> Jx{J.xx, J.xy, J.xz}, Jy{J.xy, J.yy, J.yz}, Jz{J.xz, J.yz, J.zz};
  n = cross(c, a);
  n += Vector<T>{dot(H.z, Jy) - dot(H.y, Jz), dot(H.x, Jz) - dot(H.z, Jx),
                 dot(H.y, Jx) - dot(H.x, Jy)};
  f = a * mass + H * c;
}

// Inertia and bias force of the bare links of blocks first .. last - 1 in the axes of their base.
// With the pseudo-inertia J = sum of m x x^T about the link's origin, A = tr(J) 1 - J.
template <int first, int last>
void set_up_links(Workspace& w, int beyond = 0) {
  for (int b = first; b < last; ++b) {
    Block& block = w.blocks[static_cast<std::size_t>(b)];
    const BlockConstants& constants = w.constants_of(b + beyond);
    const auto& entries = block.entries;
    const Matrix<Lanes> R{wide_vector(entries + kAxes), wide_vector(entries + kAxes + 3),
                          wide_vector(entries + kAxes + 6)};
    const Symmetric<Lanes> T{wide(constants.tensor[0]), wide(constants.tensor[1]),
                             wide(constants.tensor[2]), wide(constants.tensor[3]),
                             wide(constants.tensor[4]), wide(constants.tensor[5])};
    const Matrix<Lanes> RT{T * R.x, T * R.y, T * R.z};  // rows of R T
    const Symmetric<Lanes> J{dot(RT.x, R.x), dot(RT.x, R.y), dot(RT.x, R.z),
                             dot(RT.y, R.y), dot(RT.y, R.z), dot(RT.z, R.z)};
    narrow(J.yy + J.zz, block.entries[kRotational]);
    narrow(-J.xy, block.entries[kRotational + 1]);
    narrow(-J.xz, block.entries[kRotational + 2]);
    narrow(J.xx + J.zz, block.entries[kRotational + 3]);
    narrow(-J.yz, block.entries[kRotational + 4]);
    narrow(J.xx + J.yy, block.entries[kRotational + 5]);
    const Vector<Lanes> c = R * wide_vector(constants.moments);
    narrow(c, block.entries + kMoments);

    Vector<Lanes> n, f;
    bias_force(J, c, wide(constants.mass), wide_vector(entries + kOmega),
               wide_vector(entries + kAlpha), wide_vector(entries + kAcceleration), n, f);
    narrow(n, block.entries + kTorque);
    narrow(f, block.entries + kForce);
  }
}

// From the base outwards: where links are and how they would move without joint accelerations.

ADAGEN_INLINE Frame<Value> frame_of(Workspace& w, int joint) {
  const Value* R = w.of(joint, kAxes);
  return {matrix_at(R), vector_at(w.of(joint, kOmega)), vector_at(w.of(joint, kAlpha)),
          vector_at(w.of(joint, kAcceleration))};
}

template <class T>
ADAGEN_INLINE void keep(Workspace& w, int slot, const Frame<T>& frame) {
  put_at(w.at(slot, kAxes), frame.R);
  put_at(w.at(slot, kOmega), frame.omega);
  put_at(w.at(slot, kAlpha), frame.alpha);
  put_at(w.at(slot, kAcceleration), frame.a);
}

// The ground accelerates against gravity: accelerations are relative to free fall.
ADAGEN_INLINE Frame<Value> ground(const Workspace& w) {
  const Value one = Value{} + 1, none{};
  return {{{one, none, none}, {none, one, none}, {none, none, one}},
          {none, none, none},
          {none, none, none},
          {none - Real(gravity(w, 0)), none - Real(gravity(w, 1)), none - Real(gravity(w, 2))}};
}

// The axes of a floating base are the link's own: only gravity is turned.
template <int j>
void free_base_frame(Workspace& w) {
  constexpr const JointConstants& joint = kJoints[j];
  const Value* q = w.q + joint.q + 3;
  Matrix<Value> turn;
  require_length(w, rotation(q[0], q[1], q[2], q[3], turn), j);
  Frame<Value> frame = ground(w);
  const Vector<Real> down{Real(gravity(w, 0)), Real(gravity(w, 1)), Real(gravity(w, 2))};
  const Number* const P = joint.rotation;
  const auto along = [&](int k) {
    return Real(P[k] * down.x + P[3 + k] * down.y + P[6 + k] * down.z);
  };
  const Vector<Real> fixed{along(0), along(1), along(2)};
  const Value none{};
  frame.a = -transposed_times(turn, Vector<Value>{none + fixed.x, none + fixed.y, none + fixed.z});
  const Value* v = w.v + joint.v + 3;
  frame.omega = {v[0], v[1], v[2]};
  keep(w, slot_of(j), frame);
}

ADAGEN_INLINE Matrix<Real> placement(const JointConstants& joint) {
  const auto row = [P = joint.rotation](int k) {
    return Vector<Real>{Real(P[k]), Real(P[k + 1]), Real(P[k + 2])};
  };
  return {row(0), row(3), row(6)};
}

// One joint, or one in each lane, outwards from the parent link's frame; what a joint is treated
// with later is kept.
template <bool kept, class T>
ADAGEN_INLINE void step_outward(Workspace& w, const Joints<T>& joints, JointKind kind,
                                Frame<T>& at) {
  const JointConstants& joint = joints.any();
  const auto moved = [&](const Value* x, int JointConstants::* place) {
    return each(joints, [&](const JointConstants& own) { return x[own.*place]; });
  };
  const Matrix<T> R = at.R * matrix_at<T>(w.at(joints.slot, kTurn));
  const Vector<T> axis{R.x.z, R.y.z, R.z.z};
  Vector<T> r = at.R * origin_of(joints);
  const Vector<T> omega = at.omega;
  const auto turn_with = [&](const Vector<T>& relative) {
    at.omega += relative;
    return cross(omega, relative);
  };
  const auto ride_along = [&] {
    at.a += cross(omega, cross(omega, r));
    at.a += cross(at.alpha, r);
  };
  const auto slide_and_spin = [&](const Vector<T>& q, const Vector<T>& slide,
                                  const Vector<T>& spin) {
    const Matrix<Real> P = placement(joint);
    r += at.R * Vector<T>{dot(q, P.x), dot(q, P.y), dot(q, P.z)};
    ride_along();
    at.a += cross(omega + omega + spin, slide);
    at.alpha += turn_with(spin);
  };
  switch (kind) {
    case JointKind::kRevolute:
      ride_along();
      at.alpha += turn_with(axis * moved(w.v, &JointConstants::v));
      break;
    case JointKind::kPrismatic: {
      r += axis * moved(w.q, &JointConstants::q);
      ride_along();
      const T v = moved(w.v, &JointConstants::v);
      at.a += cross(omega, axis * (v + v));
      break;
    }
    case JointKind::kSpherical:
      ride_along();
      if constexpr (kAnySpherical)
        at.alpha += turn_with(R * each_vector(joints, w.v, &JointConstants::v));
      break;
    case JointKind::kPlanar:
      if constexpr (kAnyPlanar && kWidth<T> == 1) {
        const Value *q = w.q + joint.q, *v = w.v + joint.v;
        const Vector<T> x{R.x.x, R.y.x, R.z.x}, y{R.x.y, R.y.y, R.z.y};
        slide_and_spin(Vector<T>{q[0], q[1], T{}}, x * v[0] + y * v[1], axis * v[2]);
      }
      break;
    case JointKind::kFloating:
      if constexpr (kAnyFloating && kWidth<T> == 1) {
        const Value *q = w.q + joint.q, *v = w.v + joint.v;
        slide_and_spin(Vector<T>{q[0], q[1], q[2]}, R * Vector<T>{v[0], v[1], v[2]},
                       R * Vector<T>{v[3], v[4], v[5]});
      }
      break;
  }
  at.R = R;
  if constexpr (!kept) return;
  w.memory(joints).r = r;
  if constexpr (kWithAxis<T>) w.memory(joints).axis = axis;
  keep(w, joints.slot, at);
}

// The frame of the link that a joint is on.
template <int j>
ADAGEN_INLINE Frame<Value> frame_near(Workspace& w) {
  constexpr int parent = kJoints[j].parent - 1;
  return parent < 0 ? ground(w) : frame_of(w, parent < 0 ? 0 : parent);
}

// Joints first .. last, each on the link of the one before.
template <int first, int last>
void outward(Workspace& w) {
  Frame<Value> at = frame_near<first>(w);
  each_row<RunRows<first, last>, false>(
      [&](int k, auto kind) ADAGEN_ALWAYS { step_outward<true>(w, single(first + k), kind, at); });
}

// The same on the way to joints that are treated: only the last link's frame is kept.
template <int first, int last>
void pass_outward(Workspace& w) {
  Frame<Value> at = frame_near<first>(w);
  each_row<RunRows<first, last>, false>(
      [&](int k, auto kind) ADAGEN_ALWAYS { step_outward<false>(w, single(first + k), kind, at); });
  keep(w, slot_of(last), at);
}

// Without refinement nothing is kept of joints' forces.
template <class T, class X>
ADAGEN_INLINE void keep_body(Workspace&, const Joints<T>&, const X&) {}
template <bool reversed, class T>
ADAGEN_INLINE void keep_force(Workspace&, const Joints<T>&, const Motion<T>&) {}
template <class T>
ADAGEN_INLINE void keep_load(Workspace&, int, const T&, const T&) {}
[[maybe_unused]] inline void keep_side(Workspace&, std::size_t) {}

// Symmetric matrices of three rows, eliminated.

// The factors 1 / D and L of A = L D L^T: 0 1 2, 10 20 21. Without fractions (Bareiss) the three
// divisions need not wait for each other: with m = xx yy - xy^2 and so on the pivots are xx, m / xx
// and (m m' - t^2) / (xx m), as exact as by turns while fourth powers of A keep their digits: in
// float they would not. All numbers that checks gets are positive if A could be factorized.
template <class T>
ADAGEN_INLINE void factorize(const Symmetric<T>& A, T* factors, T (&checks)[4]) {
  using Limits = std::numeric_limits<Real>;
  T* const l = factors + 3;
  const T d0 = 1 / A.xx;
  l[0] = A.xy * d0, l[1] = A.xz * d0;
  T p1, p2;
  if constexpr (Limits::min_exponent10 < -300) {
    const T m = A.xx * A.yy - A.xy * A.xy, t = A.xx * A.yz - A.xy * A.xz;
    p1 = m, p2 = m * (A.xx * A.zz - A.xz * A.xz) - t * t;
    const T inverse = 1 / m;
    factors[1] = A.xx * inverse, factors[2] = A.xx * m / p2;
    l[2] = t * inverse;
    checks[2] = p2 - Limits::min() / Limits::epsilon();
  } else {
    const T t = A.yz - l[1] * A.xy;
    p1 = A.yy - l[0] * A.xy;
    factors[1] = 1 / p1, l[2] = t * factors[1];
    p2 = A.zz - l[1] * A.xz - l[2] * t;
    factors[2] = 1 / p2;
    checks[2] = p2;
  }
  factors[0] = d0;
  checks[0] = A.xx, checks[1] = p1, checks[3] = Limits::max() - p2;
}

// A^-1 b, by the factors of A.
template <class F, class T>
ADAGEN_INLINE Vector<T> solved(const F* factors, const Vector<T>& b) {
  const F *d = factors, *l = factors + 3;
  const T y1 = b.y - l[0] * b.x, y2 = b.z - l[1] * b.x - l[2] * y1;
  const T z = y2 * d[2], y = y1 * d[1] - l[2] * z;
  return {b.x * d[0] - l[0] * y - l[1] * z, y, z};
}

// C becomes C - B^T A^-1 B, by the factors of A; returns A^-1 B. With L Y = B what is subtracted is
// Y^T D^-1 Y, which waits for no more than the last division.
template <class T>
ADAGEN_INLINE Matrix<T> complement(Symmetric<T>& C, const Matrix<T>& B, const T* factors) {
  const T *d = factors, *l = factors + 3;
  const Vector<T> Yx = B.x, Yy = B.y - B.x * l[0], Yz = (B.z - B.x * l[1]) - Yy * l[2];
  const Vector<T> Zx = Yx * d[0], Zy = Yy * d[1], Zz = Yz * d[2];
  using V = Vector<T>;
  const auto subtract = [&](T& c, T V::* i, T V::* k) ADAGEN_ALWAYS {
    c = ((c - Yx.*i * Zx.*k) - Yy.*i * Zy.*k) - Yz.*i * Zz.*k;
  };
  subtract(C.xx, &V::x, &V::x), subtract(C.xy, &V::x, &V::y), subtract(C.xz, &V::x, &V::z);
  subtract(C.yy, &V::y, &V::y), subtract(C.yz, &V::y, &V::z), subtract(C.zz, &V::z, &V::z);
  const Vector<T> Ky = Zy - Zz * l[2];
  return {(Zx - Zz * l[1]) - Ky * l[0], Ky, Zz};
}

// Spherical joints: three rotations at once. Damping and a rotor are the same about all axes.
[[maybe_unused]] constexpr bool any_spherical_rotor() {
  for (const JointConstants& joint : kJoints)
    if (joint.kind == JointKind::kSpherical && joint.passive.rotor != 0) return true;
  return false;
}
[[maybe_unused]] constexpr bool kSphericalRotors = any_spherical_rotor();

// The torque that reaches the links, in the child link's axes: less damping.
template <class T>
ADAGEN_INLINE Vector<T> spherical_torque(const Workspace& w, const Joints<T>& joints) {
  const Vector<T> tau = each_vector(joints, w.tau, &JointConstants::v);
  if constexpr (!kAnyPassive) return tau;
  const T damping = each(joints, [](const JointConstants& own) { return own.passive.damping; });
  return tau - each_vector(joints, w.v, &JointConstants::v) * damping;
}

template <class T>
ADAGEN_INLINE T rotor_of(const Joints<T>& joints) {
  return each(joints, [](const JointConstants& own) { return own.passive.rotor; });
}

template <class T>
ADAGEN_INLINE Symmetric<T> with_rotor(Symmetric<T> A, const T& rotor) {
  A.xx += rotor, A.yy += rotor, A.zz += rotor;
  return A;
}

// Takes the three rotations out of the body at the joint's origin: what is left of it is C and f,
// and the torque, so that no rounding stays behind. e gets K = A^-1 B, y = A^-1 (torque - n) and
// the factors of A. With a rotor J, which is the same about all axes, A + J is in the place of A
// there, and J K, J (A + J)^-1 A and torque - J y are left, too.
template <bool reversed, class T>
ADAGEN_INLINE void take_out_rotations(Workspace& w, const Joints<T>& joints, Body<T>& X) {
  T* const e = w.memory(joints).e;
  Vector<T> torque = matrix_at<T>(w.at(joints.slot, kAxes)) * spherical_torque(w, joints);
  if constexpr (reversed) torque = -torque;
  T* const factors = e + 12;
  T checks[4];
  const T rotor = rotor_of(joints);
  factorize(kSphericalRotors ? with_rotor(X.A, rotor) : X.A, factors, checks);
  for (const T& check : checks)
    if (__builtin_expect(!all_positive(check), 0)) fail_one(w, joints, check);
  const Matrix<T>& B = X.B;
  const Matrix<T> K = complement(X.C, B, factors);
  const Vector<T> y = solved(factors, torque - X.n);
  e[0] = K.x.x, e[1] = K.x.y, e[2] = K.x.z, e[3] = K.y.x, e[4] = K.y.y, e[5] = K.y.z;
  e[6] = K.z.x, e[7] = K.z.y, e[8] = K.z.z, e[9] = y.x, e[10] = y.y, e[11] = y.z;
  X.f += transposed_times(B, y);
  X.n = torque;
  if constexpr (kSphericalRotors) {
    const Symmetric<T>& A = X.A;
    const Vector<T> x = solved(factors, Vector<T>{A.xx, A.xy, A.xz});
    const Vector<T> z = solved(factors, Vector<T>{A.xz, A.yz, A.zz});
    const T yy = solved(factors, Vector<T>{A.xy, A.yy, A.yz}).y;
    X.A = {x.x * rotor, x.y * rotor, x.z * rotor, yy * rotor, z.y * rotor, z.z * rotor};
    X.B = {K.x * rotor, K.y * rotor, K.z * rotor};
    X.n += -(y * rotor);
  } else {
    X.A = Symmetric<T>{}, X.B = Matrix<T>{};
  }
}

// The same, from the far link's side to the near link's origin.
template <bool reversed, class T>
ADAGEN_INLINE void eliminate_rotations(Workspace& w, const Joints<T>& joints, Body<T>& X) {
  const Vector<T>& r = w.memory(joints).r;
  if constexpr (reversed) shift(X, -r);
  take_out_rotations<reversed>(w, joints, X);
  if constexpr (!reversed && kSphericalRotors) shift(X, r);
  if constexpr (!reversed && !kSphericalRotors) shift_mass(X, r);
}

// Whether joints first .. last leave of a body no more than its mass.
[[maybe_unused]] constexpr bool leave_mass_alone(int first, int last) {
  for (int j = first; j <= last; ++j)
    if (kJoints[j].kind != JointKind::kSpherical) return false;
  return !kSphericalRotors;
}

// Inwards in the links' own axes, where axes of the base would cost digits: S is a coordinate axis
// there, D an entry of the body, and what is left along S exactly zero. Links beyond joints of
// kTurned have their bodies told so, each about its own origin as all are. Joints of kTurnedIfLost
// are so only where a sweep found too few digits left and is repeated: lost is true then.
template <bool lost = false>
ADAGEN_INLINE constexpr bool turned(int j) {
  return (kAnyTurned && kTurned[j]) || (lost && kTurnedIfLost[j]);
}
template <bool lost = false>
ADAGEN_INLINE constexpr bool turned_link(int link) {
  return link > 0 && turned<lost>(link - 1);
}

// R M R^T.
template <class T, class S>
ADAGEN_INLINE Symmetric<T> congruent(const Matrix<S>& R, const Symmetric<T>& M) {
  const Vector<T> x = M * R.x, y = M * R.y, z = M * R.z;
  return {dot(x, R.x), dot(x, R.y), dot(x, R.z), dot(y, R.y), dot(y, R.z), dot(z, R.z)};
}
template <class T>
ADAGEN_INLINE Matrix<T> transposed(const Matrix<T>& m) {
  return {{m.x.x, m.y.x, m.z.x}, {m.x.y, m.y.y, m.z.y}, {m.x.z, m.y.z, m.z.z}};
}
// A body in the axes that R takes it to.
template <class T>
ADAGEN_INLINE void turn_body(Body<T>& X, const Matrix<T>& R) {
  X.A = congruent(R, X.A), X.C = congruent(R, X.C);
  X.B = R * X.B * transposed(R);
  X.n = R * X.n, X.f = R * X.f;
}

// From the axes that a link's body is told in to those of the base, and back.
template <bool lost = false>
ADAGEN_INLINE void to_base(Workspace& w, int link, Body<Value>& X) {
  if (turned_link<lost>(link)) turn_body(X, matrix_at(w.of(link - 1, kAxes)));
}
template <bool lost = false>
ADAGEN_INLINE void from_base(Workspace& w, int link, Body<Value>& X) {
  if (turned_link<lost>(link)) turn_body(X, transposed(matrix_at(w.of(link - 1, kAxes))));
}

// Mass, its moments and the pseudo-inertia of the links beyond joints.
template <class T>
ADAGEN_INLINE void own_inertia(const Workspace& w, const Joints<T>& joints, T& mass, Vector<T>& c,
                               Symmetric<T>& J) {
  if constexpr (kWidth<T> == 1) {
    const LinkInertia& link = w.inertia_of(joints.joint[0]);
    const auto x = [](Real number) { return T{} + number; };
    mass = x(link.mass);
    c = {x(link.moments[0]), x(link.moments[1]), x(link.moments[2])};
    J = {x(link.tensor[0]), x(link.tensor[1]), x(link.tensor[2]),
         x(link.tensor[3]), x(link.tensor[4]), x(link.tensor[5])};
  } else {
    const auto& block = w.constants_of(joints.slot / kPerBlock);
    const auto x = [&](const PerJoint& numbers) {
      return number_at<T>(&numbers[static_cast<std::size_t>(joints.slot % kPerBlock)]);
    };
    mass = x(block.mass);
    c = {x(block.moments[0]), x(block.moments[1]), x(block.moments[2])};
    J = {x(block.tensor[0]), x(block.tensor[1]), x(block.tensor[2]),
         x(block.tensor[3]), x(block.tensor[4]), x(block.tensor[5])};
  }
}

// Adds a bare link in its own axes: its inertia is constant, and nothing of its bias force is lost.
template <class T>
ADAGEN_INLINE void add_own_link(Workspace& w, const Joints<T>& joints, Body<T>& X) {
  const Matrix<T> back = transposed(matrix_at<T>(w.at(joints.slot, kAxes)));
  const auto told = [&](Entry entry) { return back * vector_at<T>(w.at(joints.slot, entry)); };
  T mass;
  Vector<T> c;
  Symmetric<T> J;
  own_inertia(w, joints, mass, c, J);
  Vector<T> n, f;
  if (kAgain && w.again) {
    n = told(kTorque), f = told(kForce);
  } else {
    bias_force(J, c, mass, told(kOmega), told(kAlpha), told(kAcceleration), n, f);
    if constexpr (kOuterCount > 0) push_own(w, joints, n, f);
  }
  X.A += Symmetric<T>{J.yy + J.zz, -J.xy, -J.xz, J.xx + J.zz, -J.yz, J.xx + J.yy};
  X.B.x.y -= c.z, X.B.x.z += c.y, X.B.y.x += c.z;
  X.B.y.z -= c.x, X.B.z.x -= c.y, X.B.z.y += c.x;
  X.C.xx += mass, X.C.yy += mass, X.C.zz += mass;
  X.n += n, X.f += f;
}

// What is known of D, less what may be lost of it. What the bare link and the rotor bring is exact;
// what joints beyond bring is known to a few units in the last place of its trace, and is nothing
// but noise where links without inertia come near gimbal lock. Of a reversed joint the whole body
// was turned and shifted.
template <bool along, bool reversed, class T>
ADAGEN_INLINE T left_of(const Workspace& w, const Joints<T>& joints, const Body<T>& X, const T& D) {
  const Symmetric<T>& whole = along ? X.C : X.A;
  T brought = whole.xx + whole.yy + whole.zz;
  if constexpr (!reversed) {
    T mass;
    Vector<T> c;
    Symmetric<T> J;
    own_inertia(w, joints, mass, c, J);
    brought -= along ? 3 * mass : 2 * (J.xx + J.yy + J.zz);
  }
  return D - kLeast * brought;
}

// Takes the freedom along z out of the body, at the joint's origin and in its axes. With a rotor J
// a part J / D of what is taken along z stays: there, too, nothing is subtracted.
template <bool along, bool reversed, class T>
ADAGEN_INLINE void eliminate_own(Workspace& w, const Joints<T>& joints, Body<T>& X) {
  const Symmetric<T>&A = X.A, &C = X.C;
  const Matrix<T>& B = X.B;
  const Vector<T> n = along ? Vector<T>{B.x.z, B.y.z, B.z.z} : Vector<T>{A.xz, A.yz, A.zz};
  const Vector<T> f = along ? Vector<T>{C.xz, C.yz, C.zz} : B.z;
  T tau = each(joints, [&w](const JointConstants& own) { return torque(w, own); });
  if constexpr (reversed) tau = -tau;
  T D = along ? C.zz : A.zz, rotor{};
  if constexpr (kAnyPassive) {
    rotor = each(joints, [](const JointConstants& joint) { return joint.passive.rotor; });
    D += rotor;
  }
  const T left = left_of<along, reversed>(w, joints, X, D);
  if (__builtin_expect(!all_positive(left), 0)) fail_one(w, joints, left);
  const T inverse = 1 / D, u = (tau - (along ? X.f.z : X.n.z)) * inverse, kept = rotor * inverse;
  const Vector<T> e_n = n * inverse, e_f = f * inverse;
  subtract(X, n, f, e_n, e_f);
  X.n += n * u;
  X.f += f * u;
  if constexpr (along) {
    X.B.x.z = n.x * kept, X.B.y.z = n.y * kept, X.B.z.z = n.z * kept;
    X.C.xz = f.x * kept, X.C.yz = f.y * kept, X.C.zz = f.z * kept;
    X.f.z = tau - u * rotor;
  } else {
    X.A.xz = n.x * kept, X.A.yz = n.y * kept, X.A.zz = n.z * kept;
    X.B.z = f * kept;
    X.n.z = tau - u * rotor;
  }
  auto& memory = w.memory(joints);
  const Matrix<T> R = matrix_at<T>(w.at(joints.slot, kAxes));
  Vector<T> k_n = R * e_n;
  const Vector<T> k_f = R * e_f;
  if constexpr (!reversed) k_n += cross(memory.r, k_f);
  T* const e = memory.e;
  e[0] = k_n.x, e[1] = k_n.y, e[2] = k_n.z, e[3] = k_f.x, e[4] = k_f.y, e[5] = k_f.z;
  e[6] = u, e[7] = inverse;
}

// Inwards: articulated bodies. A joint is treated at its own origin, the child link's, and the body
// is handed on about the near link's origin. Seen from the sweep's root, the child link may be the
// near one (the joint is reversed): then sigma = -1, and -qdd takes the place of qdd.

template <class T>
ADAGEN_INLINE void add_bare_link(Workspace& w, const Joints<T>& joints, Body<T>& X) {
  const Value* const A = w.at(joints.slot, kRotational);
  const auto mass = mass_of(w, joints);
  const Vector<T> c = vector_at<T>(w.at(joints.slot, kMoments));
  const Vector<T> Ax = vector_at<T>(A), Ay = vector_at<T>(A + 3 * kPerBlock);
  X.A += Symmetric<T>{Ax.x, Ax.y, Ax.z, Ay.x, Ay.y, Ay.z};  // xx xy xz yy yz zz
  X.B.x.y -= c.z, X.B.x.z += c.y, X.B.y.x += c.z;
  X.B.y.z -= c.x, X.B.z.x -= c.y, X.B.z.y += c.x;
  X.C.xx += mass, X.C.yy += mass, X.C.zz += mass;
  X.n += vector_at<T>(w.at(joints.slot, kTorque));
  X.f += vector_at<T>(w.at(joints.slot, kForce));
}

// A bare link told about the point at -r from its origin: A - (rx dx + dx rx), d = c + m r / 2.
template <class T>
ADAGEN_INLINE Body<T> bare_link_from(Workspace& w, const Joints<T>& joints, const Vector<T>& r) {
  Body<T> X{};
  add_bare_link(w, joints, X);
  const Vector<T> c{X.B.z.y, X.B.x.z, X.B.y.x};
  const T m = X.C.xx;
  const Vector<T> d = c + r * (m / 2), moved = c + r * m;
  const T xx = 2 * d.x * r.x, yy = 2 * d.y * r.y, zz = 2 * d.z * r.z;
  X.A += Symmetric<T>{yy + zz, -(d.x * r.y + d.y * r.x), -(d.x * r.z + d.z * r.x),
                      xx + zz, -(d.y * r.z + d.z * r.y), xx + yy};
  const T none{};
  X.B = {{none, -moved.z, moved.y}, {moved.z, none, -moved.x}, {-moved.y, moved.x, none}};
  X.n += cross(r, X.f);
  return X;
}

// Takes one freedom out of the body, which is shifted by r, and added to by arrive, before the
// subtraction, so that the division has time. e gets U / D, u / D and 1 / D, told at the near
// link's origin: outwards the joint has the acceleration u / D - (U / D) a, a being the near
// link's.
template <bool along, bool reversed, class T, class Arrive>
ADAGEN_INLINE void eliminate(Workspace& w, const Joints<T>& joints, Body<T>& X, const Vector<T>& s,
                             const Vector<T>& r, const T& tau, T* e, const Arrive& arrive) {
  if constexpr (reversed) shift(X, -r);
  Vector<T> n = along ? X.B * s : X.A * s;
  const Vector<T> f = along ? X.C * s : transposed_times(X.B, s);
  T D = dot(s, along ? f : n);
  if constexpr (kAnyPassive)
    D += each(joints, [](const JointConstants& joint) { return joint.passive.rotor; });
  if constexpr (kPrescribedAbreast && kWidth < T >> 1) D += each(joints, immovable);
  const T inverse = 1 / D;
  T u = ((reversed ? -tau : tau) - dot(s, along ? X.f : X.n)) * inverse;
  if constexpr (kPrescribedAbreast && kWidth < T >> 1)
    u += each(joints, [&w](const JointConstants& joint) { return prescribed(w, joint); });
  const Symmetric<T>& whole = along ? X.C : X.A;  // D beside it tells what digits are left
  const T trace = whole.xx + whole.yy + whole.zz;
  if (__builtin_expect(!all_positive(D - kEnough * trace), 0)) lose(w, joints, D, trace);
  if constexpr (!reversed) {
    shift(X, r);
    n += cross(r, f);
  }
  arrive(X);
  const Vector<T> e_n = n * inverse, e_f = f * inverse;
  e[0] = e_n.x, e[1] = e_n.y, e[2] = e_n.z, e[3] = e_f.x, e[4] = e_f.y, e[5] = e_f.z, e[6] = u;
  e[7] = inverse;
  subtract(X, n, f, e_n, e_f);
  X.n += n * u;
  X.f += f * u;
}

// Acceleration of a body that nothing holds: (A, B; B^T, C) a = -(n; f), A and what it leaves of C
// by their factors. Whether that could be done.
ADAGEN_INLINE bool solve_free(const Body<Value>& X, Motion<Value>& a) {
  Value turning[6], sliding[6], checks[2][4];
  factorize(X.A, turning, checks[0]);
  Symmetric<Value> C = X.C;
  const Matrix<Value> K = complement(C, X.B, turning);
  factorize(C, sliding, checks[1]);
  const Vector<Value> y = solved(turning, -X.n);
  a.linear = solved(sliding, -(X.f + transposed_times(X.B, y)));
  a.angular = y - K * a.linear;
  bool fine = true;
  for (const auto& of : checks)
    for (const Value& check : of) fine &= all_positive(check);
  return fine;
}

// A joint with all freedoms hands on its force alone; e gets the acceleration of the body beyond.
template <bool reversed>
ADAGEN_INLINE void set_free(Workspace& w, int j, Body<Value>& X, const Vector<Value>& r,
                            const Value* tau, Value* e) {
  if constexpr (reversed) shift(X, -r);
  const Matrix<Value> R = matrix_at(w.of(j, kAxes));
  Vector<Value> n = R * Vector<Value>{tau[3], tau[4], tau[5]};
  Vector<Value> f = R * Vector<Value>{tau[0], tau[1], tau[2]};
  if constexpr (reversed) n = -n, f = -f;
  X.n += -n, X.f += -f;
  Motion<Value> a;
  if (!solve_free(X, a)) fail(w, kFactorization, j);
  if constexpr (kPassesFree) w.free[static_cast<std::size_t>(j)] = X;
  e[0] = a.angular.x, e[1] = a.angular.y, e[2] = a.angular.z;
  e[3] = a.linear.x, e[4] = a.linear.y, e[5] = a.linear.z;
  X = Body<Value>{};
  X.n = n, X.f = f;
  if constexpr (!reversed) shift(X, r);
}

// A planar joint: along x and y, then about z.
template <bool reversed>
ADAGEN_INLINE void eliminate_planar(Workspace& w, const Joints<Value>& joints, Body<Value>& X) {
  Memory& memory = w.memory(joints);
  const Value* tau = w.tau + joints.any().v;
  const Matrix<Value> R = matrix_at(w.at(joints.slot, kAxes));
  const Vector<Value> x{R.x.x, R.y.x, R.z.x}, y{R.x.y, R.y.y, R.z.y}, z{R.x.z, R.y.z, R.z.z};
  const Vector<Value> none{};
  const auto told = [](const Value& torque) { return reversed ? -torque : torque; };
  if constexpr (reversed) shift(X, -memory.r);
  const auto nothing = [](const Body<Value>&) {};
  eliminate<true, false>(w, joints, X, x, none, told(tau[0]), memory.e, nothing);
  eliminate<true, false>(w, joints, X, y, none, told(tau[1]), memory.e + 8, nothing);
  eliminate<false, false>(w, joints, X, z, none, told(tau[2]), memory.e + 16, nothing);
  if constexpr (!reversed) shift(X, memory.r);
}

// One joint, or one in each lane, all of a kind; arrive adds what is found at the near link.
template <bool reversed, class T, class Arrive>
ADAGEN_INLINE void step_inward(Workspace& w, const Joints<T>& joints, JointKind kind, Body<T>& X,
                               const Arrive& arrive) {
  const JointConstants& joint = joints.any();
  Eliminated<T>& memory = w.memory(joints);
  const Value* R = w.at(joints.slot, kAxes);
  const auto freedom = [&] {
    return each(joints, [&w](const JointConstants& own) { return torque(w, own); });
  };
  switch (kind) {
    case JointKind::kRevolute:
      eliminate<false, reversed>(w, joints, X, axis_at<T>(R), memory.r, freedom(), memory.e,
                                 arrive);
      return;
    case JointKind::kPrismatic:
      eliminate<true, reversed>(w, joints, X, axis_at<T>(R), memory.r, freedom(), memory.e, arrive);
      return;
    case JointKind::kSpherical:
      if constexpr (kAnySpherical) eliminate_rotations<reversed>(w, joints, X);
      break;
    case JointKind::kPlanar:
      if constexpr (kAnyPlanar && kWidth<T> == 1) eliminate_planar<reversed>(w, joints, X);
      break;
    case JointKind::kFloating:
      if constexpr (kAnyFloating && kWidth<T> == 1)
        set_free<reversed>(w, joints.joint[0], X, memory.r, w.tau + joint.v, memory.e);
      break;
  }
  arrive(X);
}

// Adds a bare link in the axes in which what is found at it is told.
template <bool lost = false>
ADAGEN_INLINE void add_link(Workspace& w, int link, Body<Value>& X) {
  if (turned_link<lost>(link))
    add_own_link(w, single(link - 1), X);
  else
    add_bare_link(w, single(link - 1), X);
}

// Adds to a body what the sweep finds at a link.
template <int p, bool lost = false>
ADAGEN_INLINE void meet(Workspace& w, int link, Body<Value>& X) {
  const LinkRole role = kRoles[p][static_cast<std::size_t>(link)];
  if (role.gathers) {
    Body<Value> gathered = w.bodies[static_cast<std::size_t>(link)];
    if (lost && !turned_link(link)) from_base<true>(w, link, gathered);
    X += gathered;
  }
  if (role.adds_own) add_link<lost>(w, link, X);
}

// What is found at a link, in axes of the base.
template <int p>
ADAGEN_INLINE Body<Value> whole(Workspace& w, int link) {
  Body<Value> X{};
  meet<p>(w, link, X);
  to_base(w, link, X);
  return X;
}

// Leaves a body at a link, in the axes in which that is told.
template <bool starts>
ADAGEN_INLINE void add_to(Workspace& w, int link, const Body<Value>& X) {
  Body<Value>& body = w.bodies[static_cast<std::size_t>(link)];
  if constexpr (starts)
    body = X;
  else
    body += X;
}
// The same of one in axes of the base.
template <bool starts>
ADAGEN_INLINE void leave(Workspace& w, int link, Body<Value> X) {
  from_base(w, link, X);
  add_to<starts>(w, link, X);
}

// Whether nothing but the links themselves is found at links first .. last.
template <int p>
constexpr bool bare(int first, int last) {
  for (int link = first; link <= last; ++link) {
    const LinkRole role = kRoles[p][static_cast<std::size_t>(link)];
    if (role.gathers || !role.adds_own) return false;
  }
  return true;
}

// Whether a sweep of joints first .. last may lose digits and be repeated in their own axes.
constexpr bool may_lose(int first, int last) {
  for (int j = first; j <= last; ++j)
    if (kAnyTurnedIfLost && kTurnedIfLost[j]) return true;
  return false;
}
template <int p, int first, int last, bool starts, bool reversed>
void inward_again(Workspace& w);

// Process p takes joints last .. first inwards, each on the link of the one before.
template <int p, int first, int last, bool starts>
void inward(Workspace& w) {
  Body<Value> X{};
  constexpr bool quick = bare<p>(first + 1, last);
  if constexpr (quick) meet<p>(w, last + 1, X);
  each_row<RunRows<first, last>, true>([&](int k, auto kind) ADAGEN_ALWAYS {
    const int j = first + k;
    if constexpr (!quick) meet<p>(w, j + 1, X);
    if constexpr (kRefine > 0) keep_body(w, single(j), X);
    step_inward<false>(w, single(j), kind, X, [&](Body<Value>& near) ADAGEN_ALWAYS {
      if (quick && j > first) add_bare_link(w, single(j - 1), near);
    });
  });
  if constexpr (may_lose(first, last))
    if (__builtin_expect(w.lost, 0)) return inward_again<p, first, last, starts, false>(w);
  constexpr int near = kJoints[first].parent;
  if constexpr (near > 0) leave<starts>(w, near, X);
}

// The next for spherical joints with bare links between them: a link is told at the next joint's
// origin before what is left of the body gets there.
template <int p, int first, int last>
ADAGEN_INLINE Body<Value> turn_inward_reversed(Workspace& w) {
  Body<Value> X{};
  meet<p>(w, kJoints[first].parent, X);
  shift(X, -w.joints[first].r);
  take_out_rotations<true>(w, single(first), X);
  for (int j = first + 1; j <= last; ++j) {
    const Vector<Value> r = -w.joints[static_cast<std::size_t>(j)].r;
    shift_mass(X, r);
    X += bare_link_from(w, single(j - 1), r);
    take_out_rotations<true>(w, single(j), X);
  }
  return X;
}

// The same for a root beyond joint last: from the parent link of joint first to the child of last.
template <int p, int first, int last, bool starts>
void inward_reversed(Workspace& w) {
  constexpr bool quick = bare<p>(first + 1, last);
  if constexpr (quick && leave_mass_alone(first, last) && kRefine == 0)
    return leave<starts>(w, last + 1, turn_inward_reversed<p, first, last>(w));
  Body<Value> X{};
  if constexpr (quick) meet<p>(w, kJoints[first].parent, X);
  each_row<RunRows<first, last>, false>([&](int k, auto kind) ADAGEN_ALWAYS {
    const int j = first + k;
    if constexpr (!quick) meet<p>(w, kJoints[static_cast<std::size_t>(j)].parent, X);
    if constexpr (kRefine > 0) keep_body(w, single(j), X);
    step_inward<true>(w, single(j), kind, X, [&](Body<Value>& near) ADAGEN_ALWAYS {
      if (quick && j < last) add_bare_link(w, single(j), near);
    });
  });
  if constexpr (may_lose(first, last))
    if (__builtin_expect(w.lost, 0)) return inward_again<p, first, last, starts, true>(w);
  leave<starts>(w, last + 1, X);
}

// Adds a link itself to what was found at it.
template <int link, bool starts>
void place(Workspace& w) {
  Body<Value> X{};
  add_link(w, link, X);
  add_to<starts>(w, link, X);
}

// A floating joint on the ground only adds its torque to the link.
template <int j, bool starts>
void free_base(Workspace& w) {
  const Value* tau = w.tau + kJoints[j].v;
  Body<Value> X{};
  X.n = {-tau[3], -tau[4], -tau[5]};
  X.f = {-tau[0], -tau[1], -tau[2]};
  leave<starts>(w, j + 1, X);
}

// Acceleration of a root that nothing holds.
template <int p, int link>
void solve_root(Workspace& w) {
  if (!solve_free(whole<p>(w, link), w.motions[link])) fail(w, kFactorization, link - 1);
}


// Numbers of x, or beyond its last one of y.
template <int... k, class V>
ADAGEN_INLINE V shuffled(const V& x, const V& y) {
#if defined(__clang__)
  return __builtin_shufflevector(x, y, k...);
#else
  return __builtin_shuffle(x, y, decltype(x < y){k...});
#endif
}

// Rows x and y of a square: what lies in columns apart by a distance changes places.
template <int distance, class V, std::size_t... column>
ADAGEN_INLINE void exchange(V& x, V& y, std::index_sequence<column...>) {
  constexpr int n = sizeof...(column);
  const V row = shuffled<(column & distance ? n + column - distance : column)...>(x, y);
  y = shuffled<(column & distance ? n + column : column + distance)...>(x, y);
  x = row;
}

// A square of as many rows as each has numbers becomes its transpose: blocks of one number, then of
// two by two, and so on.
template <int distance = 1, class V, std::size_t n>
ADAGEN_INLINE void transpose(V (&rows)[n]) {
  if constexpr (distance < static_cast<int>(n)) {
    ADAGEN_FOR (k, 0, static_cast<int>(n))
      if ((k & distance) == 0)
        exchange<distance>(rows[k], rows[k + distance], std::make_index_sequence<n>{});
    transpose<2 * distance>(rows);
  }
}

// A body by columns of eight lanes, for what takes one joint at a time: each column a register.
typedef Real Column __attribute__((vector_size(8 * sizeof(Real))));  // [angular, -, linear, -]

#if defined(__AVX512F__)
constexpr bool kInColumns = sizeof(Column) <= 64;
#elif defined(__AVX2__)
constexpr bool kInColumns = sizeof(Column) <= 32;
#else
constexpr bool kInColumns = false;
#endif

// An articulated body about a point: the columns of its inertia along three rotations and three
// translations, and its bias force.
struct Columns {
  Column angular[3]{}, linear[3]{}, force{};
};

ADAGEN_INLINE void operator+=(Columns& a, const Columns& b) {
  ADAGEN_FOR (k, 0, 3) {
    a.angular[k] += b.angular[k];
    a.linear[k] += b.linear[k];
  }
  a.force += b.force;
}

ADAGEN_INLINE Column column(const Vector<Real>& angular, const Vector<Real>& linear) {
  return Column{angular.x, angular.y, angular.z, 0, linear.x, linear.y, linear.z, 0};
}
ADAGEN_INLINE Columns columns(const Body<Real>& X) {
  const auto& [A, B, C, n, f] = X;
  return {{column({A.xx, A.xy, A.xz}, B.x), column({A.xy, A.yy, A.yz}, B.y),
           column({A.xz, A.yz, A.zz}, B.z)},
          {column({B.x.x, B.y.x, B.z.x}, {C.xx, C.xy, C.xz}),
           column({B.x.y, B.y.y, B.z.y}, {C.xy, C.yy, C.yz}),
           column({B.x.z, B.y.z, B.z.z}, {C.xz, C.yz, C.zz})},
          column(n, f)};
}
ADAGEN_INLINE Body<Real> body(const Columns& X) {
  const Column &x = X.angular[0], &y = X.angular[1], &z = X.angular[2];
  const Column &u = X.linear[0], &v = X.linear[1], &w = X.linear[2], &p = X.force;
  return {{x[0], x[1], x[2], y[1], y[2], z[2]},
          {{x[4], x[5], x[6]}, {y[4], y[5], y[6]}, {z[4], z[5], z[6]}},
          {u[4], u[5], u[6], v[5], v[6], w[6]},
          {p[0], p[1], p[2]},
          {p[4], p[5], p[6]}};
}

// Eight lanes of a register that may hold more.
template <int first>
ADAGEN_INLINE Column eight(const Lanes& x) {
  Real numbers[kLanes];
  std::memcpy(numbers, &x, sizeof x);
  Column result;
  std::memcpy(&result, numbers + first, sizeof result);
  return result;
}

// One number of a column in all lanes.
template <int k>
ADAGEN_INLINE Column spread(const Column& x) {
  return shuffled<k, k, k, k, k, k, k, k>(x, x);
}

// The lever arm r of a force: [n; f] becomes [n + r x f; f].
struct Arm {
  Column ahead, behind;  // y z x and z x y of r in the angular lanes
  Vector<Real> r;
};
ADAGEN_INLINE Arm arm(const Vector<Real>& r) {
  return {Column{r.y, r.z, r.x}, Column{r.z, r.x, r.y}, r};
}
// The same where x, too, has r as its linear half.
ADAGEN_INLINE Arm arm(const Column& x, const Vector<Real>& r) {
  return {shuffled<5, 6, 4, 7, 7, 7, 7, 7>(x, x), shuffled<6, 4, 5, 7, 7, 7, 7, 7>(x, x), r};
}
ADAGEN_INLINE Column carried(const Arm& arm, const Column& x) {
  return x + arm.ahead * shuffled<6, 4, 5, 7, 7, 7, 7, 7>(x, x) -
         arm.behind * shuffled<5, 6, 4, 7, 7, 7, 7, 7>(x, x);
}

// Gives A below its diagonal what it has above. What is left of a heavy body's inertia along axes
// that joints have taken out falls off from joint to joint while the inertia stays symmetric, and
// grows where it does not.
ADAGEN_INLINE void mirror(Columns& X) {
  X.angular[1] = shuffled<0, 1, 9, 3, 4, 5, 6, 7>(X.angular[1], X.angular[2]);
  const Column xy = shuffled<0, 8, 2, 3, 4, 5, 6, 7>(X.angular[0], X.angular[1]);
  X.angular[0] = shuffled<0, 1, 8, 3, 4, 5, 6, 7>(xy, X.angular[2]);
}

// The body told about the point at -r from the one that it is told about: what forces become, then
// what motions were, term by term in the same order.
ADAGEN_INLINE void shift(Columns& X, const Arm& arm) {
  ADAGEN_FOR (k, 0, 3) {
    X.angular[k] = carried(arm, X.angular[k]);
    X.linear[k] = carried(arm, X.linear[k]);
  }
  const auto& [x, y, z] = arm.r;
  X.angular[0] = X.angular[0] + X.linear[2] * y - X.linear[1] * z;
  X.angular[1] = X.angular[1] + X.linear[0] * z - X.linear[2] * x;
  X.angular[2] = X.angular[2] + X.linear[1] * x - X.linear[0] * y;
  X.force = carried(arm, X.force);
}

// U and 1 / D of the joint before: what is still to be subtracted from the body. So the next D need
// not wait for that.
struct Due {
  Column U{};
  Real inverse = 0, root = 0;  // root: of the inverse
};

// The inertia less U U^T / D, as g g^T: as symmetric to the last bit as it was.
ADAGEN_INLINE void subtract(Columns& X, const Due& due) {
  const Column g = due.U * due.root;
  X.angular[0] -= g * spread<0>(g);
  X.angular[1] -= g * spread<1>(g);
  X.angular[2] -= g * spread<2>(g);
  X.linear[0] -= g * spread<4>(g);
  X.linear[1] -= g * spread<5>(g);
  X.linear[2] -= g * spread<6>(g);
}
ADAGEN_INLINE void settle(Columns& X, Due& due) {
  subtract(X, due);
  due = {};
}
ADAGEN_INLINE Body<Real> settled(Columns X, Due due) {
  settle(X, due);
  return body(X);
}

// Inwards by columns: a joint takes a few instructions for each. For runs of joints that nothing
// lies beside; where no register holds a column, such runs are taken number by number.

// The joint that fills a slot.
constexpr std::array<std::size_t, kBlockCount * kPerBlock> kJointAt = [] {
  std::array<std::size_t, kBlockCount * kPerBlock> result{};
  for (std::size_t& joint : result) joint = kJointCount;
  for (int j = 0; j < kJointCount; ++j)
    result[static_cast<std::size_t>(slot_of(j))] = static_cast<std::size_t>(j);
  return result;
}();

// Where a joint's columns lie: all joints have a place, or those of a tile.
ADAGEN_INLINE constexpr std::size_t columns_place(std::size_t joint) {
  if constexpr (kTile == 0) return joint;
  return joint == kJointCount ? kColumnCount : joint % kColumnCount;
}

// What set_up_links found of the links of blocks first .. last - 1, as it is added to columns.
template <int first, int last>
void set_up_columns(Workspace& w, int beyond = 0) {
  if constexpr (!kInColumns) return;
  for (int slot = (first + beyond) * kPerBlock; slot < (last + beyond) * kPerBlock; slot += 8) {
    const auto row = [&](int entry) {
      return number_at<Column>(w.at(slot, static_cast<Entry>(entry)));
    };
    const auto put = [&](Real(LinkColumns::* place)[8], const Column(&found)[8]) {
      ADAGEN_FOR (k, 0, 8) {
        const std::size_t joint = kJointAt[static_cast<std::size_t>(slot + k)];
        LinkColumns& link = w.columns[kTile > 0 ? columns_place(joint) : joint];
        std::memcpy(link.*place, &found[k], sizeof found[k]);
      }
    };
    const auto& all = w.constants_of(slot / kPerBlock);
    const Column mass = number_at<Column>(&all.mass[static_cast<std::size_t>(slot % kPerBlock)]);
    const Column x = row(kMoments), y = row(kMoments + 1), z = row(kMoments + 2);
    const Column none = mass - mass;  // a zero unknown to gcc 12, which errs in shuffles with it
    constexpr int A = kRotational, n = kTorque, f = kForce;
    Column tensor[]{row(A), row(A + 1), row(A + 2), row(A + 3), row(A + 4), row(A + 5), mass, none};
    transpose(tensor);
    put(&LinkColumns::tensor, tensor);
    Column moments[]{x, y, z, -x, -y, -z, none, none};
    transpose(moments);
    put(&LinkColumns::moments, moments);
    Column force[]{row(n), row(n + 1), row(n + 2), none, row(f), row(f + 1), row(f + 2), none};
    transpose(force);
    put(&LinkColumns::force, force);
  }
}

ADAGEN_INLINE void add_bare_link(Workspace& w, int link, Columns& X) {
  const LinkColumns& own = w.columns[columns_place(static_cast<std::size_t>(link - 1))];
  const Column a = number_at<Column>(own.tensor);   // xx xy xz yy yz zz m 0
  const Column b = number_at<Column>(own.moments);  // x y z -x -y -z 0 0
  X.angular[0] += shuffled<0, 1, 2, 7, 7, 13, 9, 7>(a, b);
  X.angular[1] += shuffled<1, 3, 4, 7, 10, 7, 11, 7>(a, b);
  X.angular[2] += shuffled<2, 4, 5, 7, 12, 8, 7, 7>(a, b);
  X.linear[0] += shuffled<7, 10, 12, 7, 6, 7, 7, 7>(a, b);
  X.linear[1] += shuffled<13, 7, 8, 7, 7, 6, 7, 7>(a, b);
  X.linear[2] += shuffled<9, 11, 7, 7, 7, 7, 6, 7>(a, b);
  X.force += number_at<Column>(own.force);
}

template <int p>
ADAGEN_INLINE void meet(Workspace& w, int link, Columns& X) {
  const LinkRole role = kRoles[p][static_cast<std::size_t>(link)];
  if (role.gathers) X += columns(w.bodies[static_cast<std::size_t>(link)]);
  if (role.adds_own) add_bare_link(w, link, X);
}

// S^T x with S = [s; 0] or [0; s].
template <bool along>
ADAGEN_INLINE Real component(const Column& s, const Column& x) {
  constexpr int first = along ? 4 : 0;
  const Column part = s * x;
  return (part[first] + part[first + 1]) + part[first + 2];
}

// See eliminate in inward.hpp. With X less U U^T / D due, S^T X S is less (S^T U)^2 / D.
template <bool along, bool reversed, class Arrive>
ADAGEN_INLINE void eliminate(Workspace& w, int j, Columns& X, Due& due, const Arrive& arrive) {
  const JointConstants& joint = kJoints[static_cast<std::size_t>(j)];
  Memory& memory = w.joints[static_cast<std::size_t>(j)];
  const Vector<Real>& axis = memory.axis;
  Column both;  // [axis, -, r, -]
  std::memcpy(&both, &memory, sizeof both);
  const Column s = shuffled<0, 1, 2, 3, 0, 1, 2, 3>(both, both);
  if constexpr (reversed) both = -both;
  const Arm lever = arm(both, reversed ? -memory.r : memory.r);
  if constexpr (reversed) {
    shift(X, lever);
    due.U = carried(lever, due.U);
  }
  const Column(&side)[3] = along ? X.linear : X.angular;
  const Column V = side[0] * axis.x + side[1] * axis.y + side[2] * axis.z;
  mirror(X);  // no sooner, so that V need not wait
  const Real q = component<along>(s, due.U);
  Real D = component<along>(s, V) - q * q * due.inverse;
  if constexpr (kAnyPassive) D += joint.passive.rotor;
  const Real inverse = 1 / D;
  const Column before = due.U * due.inverse;
  subtract(X, due);
  Column U = V - before * q;
  const Real tau = torque(w, j);
  const Real u = ((reversed ? -tau : tau) - component<along>(s, X.force)) * inverse;
  constexpr int first = along ? 4 : 0;  // D beside the trace tells what digits are left
  const Real trace = side[0][first] + side[1][first + 1] + side[2][first + 2];
  if (__builtin_expect(!all_positive(D - kEnough * trace), 0)) lose(w, single(j), D, trace);
  if constexpr (!reversed) {
    shift(X, lever);
    U = carried(lever, U);
  }
  arrive(X);
  const Column e = U * inverse;
  Column kept = shuffled<0, 1, 2, 4, 5, 6, 3, 7>(e, e);
  kept[6] = u, kept[7] = inverse;
  std::memcpy(memory.e, &kept, sizeof kept);
  due = {U, inverse, std::sqrt(D) * inverse};  // the root need not wait for the division
  X.force += U * u;
}

template <bool reversed, class Arrive>
ADAGEN_INLINE void step_inward(Workspace& w, int j, JointKind kind, Columns& X, Due& due,
                               const Arrive& arrive) {
  [[maybe_unused]] const auto number_by_number = [&] {
    settle(X, due);
    Body<Real> whole = body(X);
    step_inward<reversed>(w, single(j), kind, whole, [](const Body<Real>&) {});
    X = columns(whole);
  };
  switch (kind) {
    case JointKind::kRevolute:
      eliminate<false, reversed>(w, j, X, due, arrive);
      return;
    case JointKind::kPrismatic:
      if constexpr (kAnyPrismatic) eliminate<true, reversed>(w, j, X, due, arrive);
      return;
    default:
      if constexpr (kAnySpherical || kAnyPlanar || kAnyFloating) number_by_number();
  }
  arrive(X);
}

// See inward in inward.hpp.
template <int p, int first, int last, bool starts>
void inward_in_columns(Workspace& w) {
  if constexpr (!kInColumns) return inward<p, first, last, starts>(w);
  constexpr bool quick = bare<p>(first + 1, last);
  Columns X;
  Due due;
  if constexpr (quick) meet<p>(w, last + 1, X);
  each_row<RunRows<first, last>, true>([&](int k, auto kind) ADAGEN_ALWAYS {
    const int j = first + k;
    if constexpr (!quick) meet<p>(w, j + 1, X);
    if constexpr (kRefine > 0) keep_body(w, single(j), settled(X, due));
    step_inward<false>(w, j, kind, X, due, [&](Columns& near) ADAGEN_ALWAYS {
      if (quick && j > first) add_bare_link(w, j, near);
    });
  });
  settle(X, due);
  if constexpr (may_lose(first, last))
    if (__builtin_expect(w.lost, 0)) return inward_again<p, first, last, starts, false>(w);
  constexpr int near = kJoints[first].parent;
  if constexpr (near > 0) leave<starts>(w, near, body(X));
}

// See inward_reversed in inward.hpp.
template <int p, int first, int last, bool starts>
void inward_in_columns_reversed(Workspace& w) {
  if constexpr (!kInColumns) return inward_reversed<p, first, last, starts>(w);
  constexpr bool quick = bare<p>(first + 1, last);
  Columns X;
  Due due;
  if constexpr (quick) meet<p>(w, kJoints[first].parent, X);
  each_row<RunRows<first, last>, false>([&](int k, auto kind) ADAGEN_ALWAYS {
    const int j = first + k;
    if constexpr (!quick) meet<p>(w, kJoints[static_cast<std::size_t>(j)].parent, X);
    if constexpr (kRefine > 0) keep_body(w, single(j), settled(X, due));
    step_inward<true>(w, j, kind, X, due, [&](Columns& near) ADAGEN_ALWAYS {
      if (quick && j < last) add_bare_link(w, j + 1, near);
    });
  });
  settle(X, due);
  if constexpr (may_lose(first, last))
    if (__builtin_expect(w.lost, 0)) return inward_again<p, first, last, starts, true>(w);
  leave<starts>(w, last + 1, body(X));
}

// Outwards again: the joints' accelerations.

template <class T>
ADAGEN_INLINE T freedom(const T* e, const Motion<T>& a) {
  return (e[6] - (e[0] * a.angular.x + e[1] * a.angular.y)) -
         ((e[2] * a.angular.z + e[3] * a.linear.x) + (e[4] * a.linear.y + e[5] * a.linear.z));
}

// Gives the k-th acceleration of each of the joints.
template <class T>
ADAGEN_INLINE void answer(Workspace& w, const Joints<T>& joints, int k, const T& x) {
  const auto place = [&](int lane) -> Value& {
    const int j = joints.joint[lane];
    const int v = kOneEach ? j : kJoints[static_cast<std::size_t>(j)].v;
    return w.answer[static_cast<std::size_t>(v + k)];
  };
  if constexpr (kWidth<T> == 1)
    place(0) = x;
  else
    ADAGEN_FOR (lane, 0, kWidth<T>) place(lane) = x[lane];
}

// The same for joints with several freedoms, told at the joint's origin throughout.
template <bool reversed>
ADAGEN_INLINE void move_at_joint(Workspace& w, const Joints<Value>& joints, Motion<Value>& a) {
  const JointConstants& joint = joints.any();
  [[maybe_unused]] const Value* const e = w.memory(joints).e;
  [[maybe_unused]] const Matrix<Value> R = matrix_at(w.at(joints.slot, kAxes));
  [[maybe_unused]] Value* qdd = &w.answer[static_cast<std::size_t>(joint.v)];
  if constexpr (kAnyPlanar) {
    if (joint.kind == JointKind::kPlanar) {
      const Value spin = freedom(e + 16, a);
      a.angular += Vector<Value>{R.x.z, R.y.z, R.z.z} * spin;
      const Value y = freedom(e + 8, a);
      a.linear += Vector<Value>{R.x.y, R.y.y, R.z.y} * y;
      const Value x = freedom(e, a);
      a.linear += Vector<Value>{R.x.x, R.y.x, R.z.x} * x;
      qdd[0] = reversed ? -x : x, qdd[1] = reversed ? -y : y, qdd[2] = reversed ? -spin : spin;
    }
  }
  if constexpr (kAnyFloating) {
    if (joint.kind == JointKind::kFloating) {
      const Motion<Value> far{{e[0], e[1], e[2]}, {e[3], e[4], e[5]}};
      const Vector<Value> slide = transposed_times(R, far.linear - a.linear);
      const Vector<Value> spin = transposed_times(R, far.angular - a.angular);
      const Value x[6] = {slide.x, slide.y, slide.z, spin.x, spin.y, spin.z};
      ADAGEN_FOR (k, 0, 6) qdd[k] = reversed ? -x[k] : x[k];
      a = far;
    }
  }
}

// The same for spherical joints.
template <bool reversed, class T>
ADAGEN_INLINE void turn_at_joint(Workspace& w, const Joints<T>& joints, Motion<T>& a) {
  const T* const e = w.memory(joints).e;
  const Matrix<T> K{{e[0], e[1], e[2]}, {e[3], e[4], e[5]}, {e[6], e[7], e[8]}};
  Vector<T> far = Vector<T>{e[9], e[10], e[11]} - K * a.linear;
  if constexpr (kSphericalRotors) far += solved(e + 12, a.angular) * rotor_of(joints);
  const Matrix<T> R = matrix_at<T>(w.at(joints.slot, kAxes));
  const Vector<T> x = transposed_times(R, far - a.angular);
  answer(w, joints, 0, reversed ? -x.x : x.x);
  answer(w, joints, 1, reversed ? -x.y : x.y);
  answer(w, joints, 2, reversed ? -x.z : x.z);
  a.angular = far;
}

// A joint's acceleration from the near link's, which becomes the far link's; each is told at its
// own origin. Where the joint is reversed, the far link's acceleration differs by -S qdd.
template <bool reversed, class T>
ADAGEN_INLINE void move(Workspace& w, const Joints<T>& joints, JointKind kind, Motion<T>& a) {
  const T* const e = w.memory(joints).e;
  const Vector<T>& r = w.memory(joints).r;
  switch (kind) {
    case JointKind::kRevolute: {
      const Vector<T> axis = axis_of(w, joints);
      const T x = freedom(e, a);
      answer(w, joints, 0, reversed ? -x : x);
      carry(a, reversed ? -r : r);
      a.angular += axis * x;
      if constexpr (reversed) a.linear += cross(r, axis) * x;
      break;
    }
    case JointKind::kPrismatic: {
      const T x = freedom(e, a);
      answer(w, joints, 0, reversed ? -x : x);
      carry(a, reversed ? -r : r);
      a.linear += axis_of(w, joints) * x;
      break;
    }
    case JointKind::kSpherical:
      if constexpr (kAnySpherical) {
        if constexpr (!reversed) carry(a, r);
        turn_at_joint<reversed>(w, joints, a);
        if constexpr (reversed) carry(a, -r);
      }
      break;
    default:
      if constexpr (kWidth<T> == 1) {
        if constexpr (!reversed) carry(a, r);
        move_at_joint<reversed>(w, joints, a);
        if constexpr (reversed) carry(a, -r);
      }
  }
}

// Joints first .. last outwards; what moves along with a link is kept where other paths start.
template <int p, int first, int last>
void accelerate(Workspace& w) {
  Motion<Value> a = w.motions[static_cast<std::size_t>(kJoints[first].parent)];
  each_row<RunRows<first, last>, false>([&](int k, auto kind) ADAGEN_ALWAYS {
    move<false>(w, single(first + k), kind, a);
    if constexpr (kRefine > 0) keep_force<false>(w, single(first + k), a);
    const std::size_t far = static_cast<std::size_t>(first + k + 1);
    if (kRoles[p][far].parts) w.motions[far] = a;
  });
}

// Six numbers that follow from each other are no work for lanes: g++ takes a fifth longer with
// them.
#if defined(__clang__)
#define ADAGEN_ONE_BY_ONE
#else
#define ADAGEN_ONE_BY_ONE __attribute__((optimize("no-tree-slp-vectorize")))
#endif
template <int p, int first, int last>
ADAGEN_ONE_BY_ONE void accelerate_reversed(Workspace& w) {
  Motion<Value> a = w.motions[last + 1];
  each_row<RunRows<first, last>, true>([&](int k, auto kind) ADAGEN_ALWAYS {
    const int j = first + k;
    move<true>(w, single(j), kind, a);
    if constexpr (kRefine > 0) keep_force<true>(w, single(j), a);
    const std::size_t far = static_cast<std::size_t>(kJoints[static_cast<std::size_t>(j)].parent);
    if (kRoles[p][far].parts) w.motions[far] = a;
  });
}

// The Frame of a floating base knows nothing of its linear velocity, whose axes turn with the base.
template <int j>
void as_joint_acceleration(Workspace& w) {
  const Value* v = w.v + kJoints[j].v;
  Value* qdd = &w.answer[kJoints[j].v];
  const Vector<Value> turned =
      cross(Vector<Value>{v[3], v[4], v[5]}, Vector<Value>{v[0], v[1], v[2]});
  qdd[0] -= turned.x, qdd[1] -= turned.y, qdd[2] -= turned.z;
}

// A floating base's joint acceleration, [linear; angular] in its own axes.
template <int j>
void free_acceleration(Workspace& w) {
  const Motion<Value>& a = w.motions[j + 1];
  Value* qdd = &w.answer[kJoints[j].v];
  qdd[0] = a.linear.x, qdd[1] = a.linear.y, qdd[2] = a.linear.z;
  qdd[3] = a.angular.x, qdd[4] = a.angular.y, qdd[5] = a.angular.z;
  as_joint_acceleration<j>(w);
}

// Limbs side by side: joints of as many limbs as there are lanes are treated together, from the
// limbs' first joints outwards or back. A first lane that is idle goes by the second one's joints,
// has memory of its own, and what it gives is written over.
template <int count, int rows>
struct Limbs {
  int slot;                 // of the first joint of the first limb
  int joints[rows][count];  // all limbs' k-th joints, which are of one kind

  using T = std::conditional_t<count == 2, Two, Four>;
  static constexpr int kRows = rows;
  constexpr Joints<T> at(int k) const {
    Joints<T> result{slot + count * k, {}};
    for (int lane = 0; lane < count; ++lane) result.joint[lane] = joints[k][lane];
    return result;
  }
  // The link that a limb hangs on.
  constexpr int near(int lane) const {
    return kJoints[static_cast<std::size_t>(joints[0][lane])].parent;
  }
};

template <const auto& limbs>
struct LimbRows {
  static constexpr int kCount = limbs.kRows;
  static constexpr JointKind kind(int k) { return limbs.at(k).any().kind; }
};

constexpr int kMostNumbers = 27;  // of what is taken apart or made one: a Body

// One lane of what consists of numbers alone, and all lanes made one.
template <class T, template <class> class S, std::size_t... k>
ADAGEN_INLINE S<Value> lane_of(const S<T>& all, int lane, std::index_sequence<k...>) {
  T numbers[sizeof...(k)];
  std::memcpy(numbers, &all, sizeof all);
  const Value own[]{numbers[k][lane]...};
  S<Value> result;
  std::memcpy(&result, own, sizeof result);
  return result;
}
template <class T, template <class> class S>
ADAGEN_INLINE S<Value> lane(const S<T>& all, int lane) {
  return lane_of(all, lane, std::make_index_sequence<sizeof all / sizeof(T)>{});
}
template <class T, std::size_t... lane>
ADAGEN_INLINE T lanes_of(const Value (&numbers)[kWidth<T>][kMostNumbers], std::size_t k,
                         std::index_sequence<lane...>) {
  return T{numbers[lane][k]...};
}
template <class T, template <class> class S, std::size_t... k>
ADAGEN_INLINE S<T> side_by_side(const S<Value>* const (&sides)[kWidth<T>],
                                std::index_sequence<k...>) {
  Value own[kWidth<T>][kMostNumbers];
  ADAGEN_FOR (lane, 0, kWidth<T>) std::memcpy(own[lane], sides[lane], sizeof *sides[lane]);
  const T numbers[]{lanes_of<T>(own, k, std::make_index_sequence<kWidth<T>>{})...};
  S<T> result;
  std::memcpy(&result, numbers, sizeof result);
  return result;
}
template <class T, template <class> class S>
ADAGEN_INLINE S<T> side_by_side(const S<Value>* const (&sides)[kWidth<T>]) {
  return side_by_side<T, S>(sides, std::make_index_sequence<sizeof(S<T>) / sizeof(T)>{});
}

template <const auto& limbs>
void outward_group(Workspace& w) {
  using T = typename std::decay_t<decltype(limbs)>::T;
  Frame<Value> frames[kWidth<T>];
  const Frame<Value>* sides[kWidth<T>];
  ADAGEN_FOR (lane, 0, kWidth<T>) {
    const int near = limbs.near(lane);
    frames[lane] = near == 0 ? ground(w) : frame_of(w, near == 0 ? 0 : near - 1);
    sides[lane] = &frames[lane];
  }
  Frame<T> at = side_by_side<T, Frame>(sides);
  each_row<LimbRows<limbs>, false>(
      [&](int k, auto kind) ADAGEN_ALWAYS { step_outward<true>(w, limbs.at(k), kind, at); });
}

// Adds to bodies what the sweep finds at the links beyond a row of joints.
template <int p, bool lost = false, class T>
ADAGEN_INLINE void meet_group(Workspace& w, const Joints<T>& joints, Body<T>& X) {
  const Body<Value> none{};
  const Body<Value>* sides[kWidth<T>];
  bool any = false;
  ADAGEN_FOR (lane, 0, kWidth<T>) {
    const std::size_t link = static_cast<std::size_t>(joints.joint[lane] + 1);
    const bool gathers = kRoles[p][link].gathers;
    any |= gathers;
    sides[lane] = gathers ? &w.bodies[link] : &none;
  }
  const int first = joints.joint[0];
  if (any) {
    Body<T> gathered = side_by_side<T, Body>(sides);
    if (lost && turned<true>(first) && !turned(first))
      turn_body(gathered, transposed(matrix_at<T>(w.at(joints.slot, kAxes))));
    X += gathered;
  }
  if (turned<lost>(first))
    add_own_link(w, joints, X);
  else
    add_bare_link(w, joints, X);
}

// Whether nothing but the links themselves is found between the limbs' joints.
template <int p, class L>
constexpr bool bare_rows(const L& limbs) {
  for (int k = 0; k + 1 < L::kRows; ++k)
    for (const int joint : limbs.at(k).joint)
      if (kRoles[p][static_cast<std::size_t>(joint + 1)].gathers) return false;
  return true;
}

// The same of a sweep of limbs.
template <class L>
constexpr bool may_lose(const L& limbs) {
  for (int k = 0; k < L::kRows; ++k)
    if (kAnyTurnedIfLost && kTurnedIfLost[limbs.at(k).joint[0]]) return true;
  return false;
}
template <int p, const auto& limbs, class T>
void inward_group_again(Workspace& w, Body<T>& X);

// What hangs on the links that the limbs hang on.
template <int p, const auto& limbs>
auto inward_group(Workspace& w) {
  using T = typename std::decay_t<decltype(limbs)>::T;
  Body<T> X{};
  constexpr bool quick = bare_rows<p>(limbs);
  if constexpr (quick) meet_group<p>(w, limbs.at(limbs.kRows - 1), X);
  each_row<LimbRows<limbs>, true>([&](int k, auto kind) ADAGEN_ALWAYS {
    if constexpr (!quick) meet_group<p>(w, limbs.at(k), X);
    if constexpr (kRefine > 0) keep_body(w, limbs.at(k), X);
    step_inward<false>(w, limbs.at(k), kind, X, [&](Body<T>& near) ADAGEN_ALWAYS {
      if (quick && k > 0) add_bare_link(w, limbs.at(k - 1), near);
    });
  });
  if constexpr (may_lose(limbs))
    if (__builtin_expect(w.lost, 0)) inward_group_again<p, limbs>(w, X);
  return X;
}

template <int p, const auto& limbs>
void accelerate_group(Workspace& w) {
  using T = typename std::decay_t<decltype(limbs)>::T;
  const Motion<Value>* sides[kWidth<T>];
  ADAGEN_FOR (lane, 0, kWidth<T>)
    sides[lane] = &w.motions[static_cast<std::size_t>(limbs.near(lane))];
  Motion<T> a = side_by_side<T, Motion>(sides);
  each_row<LimbRows<limbs>, false>([&](int k, auto kind) ADAGEN_ALWAYS {
    const Joints<T> joints = limbs.at(k);
    move<false>(w, joints, kind, a);
    if constexpr (kRefine > 0) keep_force<false>(w, joints, a);
    ADAGEN_FOR (side, 0, kWidth<T>) {
      const std::size_t link = static_cast<std::size_t>(joints.joint[side] + 1);
      if (kRoles[p][link].parts) w.motions[link] = lane(a, side);
    }
  });
}


// "left_hip_pitch" .. "left_ankle_roll", "right_hip_pitch" .. "right_ankle_roll", "left_shoulder_pitch" .. "left_wrist_pitch", "right_shoulder_pitch" .. "right_wrist_pitch"
constexpr Limbs<4, 6> kLimbs0{0, {{1, 7, 16, 24}, {2, 8, 17, 25}, {3, 9, 18, 26}, {4, 10, 19, 27}, {5, 11, 20, 28}, {6, 12, 21, 29}}};


// ---- 5. processes -------------------------------------------------------------------------------

// Process 0: 30 of 30 joints: "__base__", "left_hip_pitch", "left_hip_roll", "left_hip_yaw", "left_knee", "left_ankle_pitch", ...
void run_0([[maybe_unused]] Workspace& w, [[maybe_unused]] Channel& channel) {
  require_finite(w, w.q, 0, 3, &JointConstants::q, kNotFinite);
  stamp(0);
  take_angles<0, 29>(w);
  turn<block(0), block(29) + 1>(w);
  free_base_frame<0>(w);
  outward<13, 15>(w);  // "waist_yaw" .. "waist_pitch"
  outward_group<kLimbs0>(w);
  outward<22, 23>(w);  // "neck_yaw" .. "neck_pitch"
  stamp(1);
  set_up_links<block(0), block(29) + 1>(w);
  free_base<0, true>(w);
  set_up_columns<block(25), block(29) + 1>(w);
  {
    const auto X = inward_group<0, kLimbs0>(w);
    leave<false>(w, 1, lane(X, 0));
    leave<false>(w, 1, lane(X, 1));
    leave<true>(w, 16, lane(X, 2));
    leave<false>(w, 16, lane(X, 3));
  }
  inward_in_columns<0, 22, 23, false>(w);  // "neck_yaw" .. "neck_pitch"
  inward_in_columns<0, 13, 15, false>(w);  // "waist_yaw" .. "waist_pitch"
  solve_root<0, 1>(w);
  stamp(2);
  accelerate<0, 13, 15>(w);  // "waist_yaw" .. "waist_pitch"
  accelerate_group<0, kLimbs0>(w);
  accelerate<0, 22, 23>(w);  // "neck_yaw" .. "neck_pitch"
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

[[maybe_unused]] constexpr std::array<void (*)(Workspace&, Channel&), kProcesses> kRun{run_0};

// What each process reads of q and v, the velocity entries whose qdd is its own, and whose tau it
// reads.
constexpr std::array<Range, 1> kReadQ_0{ {{0, 36}} };
constexpr std::array<Range, 1> kReadV_0{ {{0, 35}} };
constexpr std::array<Range, 1> kOwn_0{ {{0, 35}} };
constexpr std::array<Range, 1> kTorque_0{ {{0, 35}} };
[[maybe_unused]] constexpr std::array<ProcessInfo, kProcesses> kProcess{ {
    {{1, kReadQ_0.data()}, {1, kReadV_0.data()}, {1, kOwn_0.data()}, {1, kTorque_0.data()}},
} };

// All constants are as they were emitted.
constexpr int kParameterCount = 0;
inline Number* pack_parameters(Number* to, const Workspace&) { return to; }
inline const Number* unpack_parameters(const Number* from, Workspace&) { return from; }
[[maybe_unused]] inline void copy_parameters(const Workspace&, Workspace&) {}

// One process, or thread, of a solver: state and result in place.
class InPlace {
 public:
  Workspace w;
  Channel channel;
  Text text;  // of the last failure

  static constexpr int kWorkspaces = 1;
  Workspace& workspace(int) { return w; }

  // Reads what this process needs, writes what it owns.
  int solve(const Number* q, const Number* v, const Number* tau, Number* qdd) {
    if (kAlone && kProcesses > 1 && channel.rank() != 0) return finish(kFine);
    if (channel.broken()) return finish(failure(kNoAnswer, 0));
    prepare(q, v, tau, qdd);
    run();
    return finish(w.status);
  }

 protected:
  // A pose that a try cannot stand is known to all processes: they try the next way together.
  void run() {
    const std::size_t rank = kAlone ? 0 : static_cast<std::size_t>(channel.rank());
    kRun[rank](w, channel);
#ifdef ADAGEN_RECOVERS
    for (std::size_t k = rank; k < kRecover.size(); k += std::size_t(kProcesses)) {
      if (failure_kind(w.status) != kSingularPose) return;
      w.status = kFine;
      kRecover[k](w, channel);
    }
#endif
  }

  void prepare(const Number* q, const Number* v, const Number* tau, Number* qdd) {
    w.q = q;
    w.v = v;
    w.tau = tau;
    w.qdd = qdd;
    w.status = kFine;
  }

  int finish(int status) {
    if (status != kFine) text = describe(status);
    return status;
  }
};

// A solver for one process.
class Solver : public InPlace {
 public:
  int solve_at_root(const Number* q, const Number* v, const Number* tau, Number* qdd) {
    return solve(q, v, tau, qdd);
  }
  int end_at_root() { return kFine; }
  void close() {}
};

}  // namespace

static_assert(HUMANOID_P1_NQ == kNq && HUMANOID_P1_NV == kNv && HUMANOID_P1_NTAU == kNtau);
static_assert(int(HUMANOID_P1_FINE) == int(kFine));
static_assert(int(HUMANOID_P1_NOT_FINITE) == int(kNotFinite));
static_assert(int(HUMANOID_P1_ZERO_QUATERNION) == int(kZeroQuaternion));
static_assert(int(HUMANOID_P1_FACTORIZATION) == int(kFactorization));
static_assert(int(HUMANOID_P1_OVERFLOW) == int(kOverflow));
static_assert(int(HUMANOID_P1_NO_ANSWER) == int(kNoAnswer));
static_assert(int(HUMANOID_P1_ENDED) == int(kEnded));
static_assert(int(HUMANOID_P1_NOT_REFINED) == int(kNotRefined));
static_assert(int(HUMANOID_P1_GIMBAL_LOCK) == int(kGimbalLock));
static_assert(int(HUMANOID_P1_GROWTH) == int(kGrowth));
static_assert(int(HUMANOID_P1_NOT_SET) == int(kNotSet));
static_assert(int(HUMANOID_P1_TOO_FEW_STEPS) == int(kTooFewSteps));
static_assert(int(HUMANOID_P1_LOOP_OPEN) == int(kLoopOpen));
static_assert(int(HUMANOID_P1_LOOP_TORN) == int(kLoopTorn));
static_assert(int(HUMANOID_P1_LOOP_SINGULAR) == int(kLoopSingular));
static_assert(int(HUMANOID_P1_LOOP_FREE) == int(kLoopFree));

struct humanoid_p1_solver : Solver {};

namespace {

// Why the last open of a thread gave no solver.
thread_local Text open_failure;

template <class AnySolver>
AnySolver* opened() {
  auto* const solver = new (std::nothrow) AnySolver;
  open_failure.clear();
  if (solver == nullptr) open_failure += "not enough memory";
  return solver;
}

}  // namespace

extern "C" {

int humanoid_p1_joint(int k, const char** name, int* q, int* nq, int* v, int* nv) {
  if (k < 0 || k >= kJointCount) return 0;
  const JointConstants& joint = kJoints[k];
  *name = joint.name, *q = joint.q, *nq = joint.nq, *v = joint.v, *nv = joint.nv;
  return 1;
}

humanoid_p1_solver* humanoid_p1_open(void) { return opened<humanoid_p1_solver>(); }

int humanoid_p1_solve(humanoid_p1_solver* solver, const double* q, const double* v, const double* tau, double* qdd) {
  return solver->solve(q, v, tau, qdd);
}

int humanoid_p1_reason(int status) { return failure_kind(status); }

int humanoid_p1_failed_joint(int status) { return is_of_joint(failure_kind(status)) ? failure_place(status) : -1; }

const char* humanoid_p1_failure(const humanoid_p1_solver* solver) {
  return solver == nullptr ? open_failure.c_str() : solver->text.c_str();
}

void humanoid_p1_close(humanoid_p1_solver* solver) {
  if (solver == nullptr) return;
  solver->close();
  delete solver;
}

}  // extern "C"

// ---- 6. program ---------------------------------------------------------------------------------
// What this solver tells the program around it, which is the same for all robots: states in,
// accelerations out; check; time; trace; simulate.

#ifndef ADAGEN_NO_MAIN
// What a solver tells the program around it (adagen_program.cpp), and what that asks of it.
#ifndef ADAGEN_DESCRIPTION
#define ADAGEN_DESCRIPTION
namespace adagen {

struct OneProcess {};  // in place of a communicator where there is no MPI

template <class Item>
struct Table {
  const Item* items;
  int count;

  const Item* begin() const { return items; }
  const Item* end() const { return items + count; }
  const Item& operator[](int k) const { return items[k]; }
};

enum class JointKind { kRevolute, kPrismatic, kSpherical, kPlanar, kFloating };

// Joints, links and outer forces as section 2 of the solver has them; rotations have 9 entries, row
// by row.
template <class Number>
struct Joint {
  const char* name;
  JointKind kind;
  int parent, q, nq, v, nv;
  const Number *rotation, *translation;
  int source;
  double multiplier, offset;
  double damping, friction, friction_speed, stiffness, rest, rotor;
  bool prescribed;
};

template <class Number>
struct Link {
  double mass;
  const Number *com, *tensor;
};

template <class Number>
struct OuterForce {
  const char* name;
  int link;
  const Number *rotation, *translation;
};

// A joint that closes a loop; axes of frame 1 along which it holds places together, and about which
// it bars turns, as bits.
template <class Number>
struct Loop {
  const char* name;
  int link1, link2;
  const Number *rotation1, *translation1, *rotation2, *translation2;
  unsigned linear, angular;
  bool universal;

  bool holds(int axis) const { return (linear >> axis & 1u) != 0; }
  bool bars(int axis) const { return (angular >> axis & 1u) != 0; }
};

// Coordinates of joints whose sum, each times its factor, is the offset.
template <class Number>
struct Coupling {
  const char* name;
  int count;
  const int* joints;
  const Number* factors;
  Number offset;
};

struct Message {
  int source, target, size;  // size in numbers, the status not counted
};

// Between two time stamps of a process.
struct Stage {
  const char* what;
  int joint;    // that it ends or begins with; -1 for none
  int message;  // sent or received; -1 for work
};

// What a message costs, ns: its sender, from sent to seen, and per number to put it in and take it
// out again.
struct Hop {
  double send, latency, number;
};

template <class Number>
struct Description {
  const char *robot, *channel;
  int processes, threads, nq, nv, ntau, refine;
  bool floating, alone, batch, sets_gravity;
  double tolerance;
  const double* gravity;
  Table<Joint<Number>> joints;
  Table<Link<Number>> links;
  Table<OuterForce<Number>> outer_forces;
  Table<Loop<Number>> loops;
  Table<Coupling<Number>> couplings;
  Table<Message> messages;
  const Table<Stage>* stages;  // of each process
  Hop window_hop, message_hop;
};

// How a solver is opened: its channel, s that processes wait for each other, hosts to play, and
// whether threads of its own are to stay on a core each.
struct Opening {
  const char* channel;
  double time_limit;
  int hosts;
  bool pin;
};

// How long an evaluation took, ns, and its status: state and result in place, and everything
// through process 0.
struct Elapsed {
  double in_place, at_root;
  int status_in_place, status_at_root;
};

// The solver. What is measured is compiled with it.
template <class Number, class Comm>
class AnySolver {
 public:
  using Ticks = std::chrono::steady_clock::rep;

  virtual ~AnySolver() = default;

  // Collective. Returns what is wrong, or an empty string.
  virtual const char* open(Comm comm, const Opening& how) = 0;
  virtual void close() = 0;
  // For all evaluations to come, of this process: where it can be set.
  virtual void set_gravity(const double*) {}
  virtual Comm comm() const = 0;
  virtual const char* channel_name() const = 0;
  virtual bool windowed() const = 0;

  // One evaluation; at the root: process 0 has the state and gets all accelerations. Returns a
  // status.
  virtual int solve(const Number* q, const Number* v, const Number* tau, Number* qdd) = 0;
  virtual int solve_at_root(const Number* q, const Number* v, const Number* tau, Number* qdd) = 0;
  virtual int end_at_root() = 0;
  virtual bool has_part() const = 0;  // whether this process takes part in it

  // Many at once, where the solver is for batches. The k-th state that failed, or -1; then, why.
  virtual int solve_batch_at_root(int, const Number*, const Number*, const Number*, Number*) {
    return 0;
  }
  virtual int failures() const { return 0; }
  virtual int failed_state(int) { return -1; }
  virtual const char* why() const { return ""; }

  // A status in words, valid until the next; the names of the joints that one is joined with.
  virtual const char* in_words(int status) = 0;
  virtual const char* names_of_run(int joint) = 0;
  // The size of the k-th correction of the last evaluation.
  virtual double correction(int k) const = 0;
  // 1 + the last joint of a run that has been near gimbal lock; 0: none.
  virtual int near_lock() const = 0;

  // Collective: processes start together. An evaluation; batches of so many states for each
  // process, on the first of all processes; an evaluation with a stamp at its start, and at each
  // end of a stage.
  virtual Elapsed time(const Number* q, const Number* v, const Number* tau, Number* qdd) = 0;
  virtual Elapsed time_batch(int, int, const Number*, const Number*, const Number*, Number*) {
    return {};
  }
  virtual int trace(const Number* q, const Number* v, const Number* tau, Number* qdd,
                    Ticks* stamps) = 0;

  // Evaluations whose messages are noted once, and then played (take.hpp); numbered from 0 to
  // count - 1. looks has room for the clock at the start, at each message and at the end.
  virtual void forget(int count) = 0;
  virtual int record(int k, bool at_root, const Number* q, const Number* v, const Number* tau,
                     Number* qdd) = 0;
  virtual void play(int k, bool at_root, const Number* q, const Number* v, const Number* tau,
                    Number* qdd, Ticks* looks) = 0;
  virtual Table<int> noted(int k) const = 0;
};

// The whole program; returns its exit status. Of a number and a communicator, as adagen_program.cpp
// is compiled for them.
template <class Number, class Comm>
int program(const Description<Number>& description, AnySolver<Number, Comm>& solver, int count,
            char** words);

}  // namespace adagen
#endif

namespace {

// What is measured (--time, --stretches), of one program: no other starts with it.
using Clock = std::chrono::steady_clock;

template <class AnySolver>
Text open_solver(AnySolver&, adagen::OneProcess, const adagen::Opening&) {
  return {};
}
Clock::time_point start_together(const Channel&) { return Clock::now(); }
Clock::time_point start_again(const Channel&) { return Clock::now(); }

class Takes {
 public:
  void forget(int) {}

  template <class Evaluate>
  int record(Channel&, int, Evaluate evaluate) {
    return evaluate();
  }

  // looks: at the clock, at the start and at the end.
  template <class Evaluate>
  void play(Channel&, int, Clock::rep* looks, Evaluate evaluate) {
    looks[0] = Clock::now().time_since_epoch().count();
    evaluate();
    looks[1] = Clock::now().time_since_epoch().count();
  }

  adagen::Table<int> messages(int) const { return {}; }
};

// The model as the program takes it.
adagen::Joint<Number> told(const JointConstants& joint) {
  const Passive& own = joint.passive;
  const auto kind = static_cast<adagen::JointKind>(joint.kind);
  return {joint.name,       kind,         joint.parent,   joint.q,           joint.nq,
          joint.v,          joint.nv,     joint.rotation, joint.translation, joint.source,
          joint.multiplier, joint.offset, own.damping,    own.friction,      own.friction_speed,
          own.stiffness,    own.rest,     own.rotor,      own.prescribed};
}
adagen::Link<Number> told(const LinkConstants& link) { return {link.mass, link.com, link.tensor}; }
[[maybe_unused]] adagen::OuterForce<Number> told(const OuterForce& outer) {
  return {outer.name, outer.link, outer.rotation, outer.translation};
}
[[maybe_unused]] adagen::Message told(const MessageInfo& message) {
  return {message.source, message.target, message.size};
}

// All of a table, as long as the program runs.
template <class Own, std::size_t n>
auto table(const std::array<Own, n>& all) {
  using Told = decltype(told(all[0]));
  static std::array<Told, n> items{};
  for (std::size_t k = 0; k < n; ++k) items[k] = told(all[k]);
  return adagen::Table<Told>{items.data(), static_cast<int>(n)};
}

// Shapes that join no runs of joints as one are never near gimbal lock.
template <class S>
auto near_lock_of(const S& solver, int) -> decltype(solver.w.near_lock) {
  return solver.w.near_lock;
}
template <class S>
int near_lock_of(const S&, long) {
  return 0;
}

class ThisSolver final : public adagen::AnySolver<Number, adagen::OneProcess> {
 public:
  const char* open(adagen::OneProcess comm, const adagen::Opening& how) override {
    words_ = open_solver(solver_, comm, how);
    return words_.c_str();
  }
  void close() override { solver_.close(); }
  adagen::OneProcess comm() const override { return {}; }
  const char* channel_name() const override { return kAlone ? "none" : solver_.channel.name(); }
  bool windowed() const override { return solver_.channel.windowed(); }

  int solve(const Number* q, const Number* v, const Number* tau, Number* qdd) override {
    return in_place(q, v, tau, qdd);
  }
  int solve_at_root(const Number* q, const Number* v, const Number* tau, Number* qdd) override {
    return at_root(q, v, tau, qdd);
  }
  int end_at_root() override { return solver_.end_at_root(); }
  bool has_part() const override {
    return kProcess[static_cast<std::size_t>(solver_.channel.rank())].own.count > 0;
  }

  const char* in_words(int status) override {
    words_ = describe(status);
    return words_.c_str();
  }
  const char* names_of_run(int joint) override {
    words_.clear();
    add_names_of_run(words_, joint);
    return words_.c_str();
  }
  double correction([[maybe_unused]] int k) const override {
    return 0;
  }
  int near_lock() const override { return near_lock_of(solver_, 0); }

  adagen::Elapsed time(const Number* q, const Number* v, const Number* tau, Number* qdd) override {
    const Clock::time_point start = start_together(solver_.channel);
    const int first = solver_.solve(q, v, tau, qdd);
    const double in_place_ns = since(start);
    const Clock::time_point again = start_again(solver_.channel);
    const int second = solver_.solve_at_root(q, v, tau, qdd);
    const double at_root_ns = since(again);
    return {in_place_ns, at_root_ns, first, second};
  }
  int trace(const Number* q, const Number* v, const Number* tau, Number* qdd, Ticks* stamps) override {
    start_together(solver_.channel);
    trace_stamps = stamps;
    const int status = in_place(q, v, tau, qdd);
    trace_stamps = nullptr;
    return status;
  }

  void forget(int count) override { takes_.forget(count); }
  int record(int k, bool root, const Number* q, const Number* v, const Number* tau, Number* qdd) override {
    return takes_.record(solver_.channel, k, [&] {
      return root ? at_root(q, v, tau, qdd) : in_place(q, v, tau, qdd);
    });
  }
  void play(int k, bool root, const Number* q, const Number* v, const Number* tau, Number* qdd, Ticks* looks) override {
    if (root)
      takes_.play(solver_.channel, k, looks, [&] { at_root(q, v, tau, qdd); });
    else
      takes_.play(solver_.channel, k, looks, [&] { in_place(q, v, tau, qdd); });
  }
  adagen::Table<int> noted(int k) const override { return takes_.messages(k); }

 private:
  // For all but the clock: once in the code, whoever calls it.
  ADAGEN_NOINLINE int in_place(const Number* q, const Number* v, const Number* tau, Number* qdd) {
    return solver_.solve(q, v, tau, qdd);
  }
  ADAGEN_NOINLINE int at_root(const Number* q, const Number* v, const Number* tau, Number* qdd) {
    return solver_.solve_at_root(q, v, tau, qdd);
  }

  static double since(Clock::time_point start) {
    return std::chrono::duration<double, std::nano>(Clock::now() - start).count();
  }

  Solver solver_;
  Takes takes_;
  Text words_;
};

// The stages of each process's work, for --trace.
constexpr std::array<adagen::Stage, 3> kStages_0{ {
    {"kinematics", 29, -1},
    {"assembly", 1, -1},
    {"disassembly", 1, -1},
} };
constexpr std::array<adagen::Table<adagen::Stage>, kProcesses> kStages{ {
    {kStages_0.data(), 3},
} };

// As the cost profile default has them.
constexpr adagen::Hop kWindowHop{0, 159, 0.437};
constexpr adagen::Hop kMessageHop{26, 228, 0.644};

}  // namespace

// Compiled for size: it runs once.
[[gnu::cold]] int main(int count, char** words) {
  const adagen::Description<Number> description{
      "humanoid", "auto", kProcesses, 1, kNq, kNv, kNtau, kRefine,
      true, kAlone, kBatch, false, kTolerance, kGravity.data(),
      table(kJoints), table(kLinks), table(kOuterForces), {}, {}, table(kMessages), kStages.data(), kWindowHop,
      kMessageHop};
  auto* const solver = new ThisSolver;
  const int status = adagen::program(description, *solver, count, words);
  delete solver;
  return status;
}
#endif  // ADAGEN_NO_MAIN
