// Forward dynamics of "humanoid" on 3 processes, emitted by adagen 0.1.0 (solver.cpp.j2). Do not edit: emit anew.
//
// robot     "humanoid", 30 joints, 35 degrees of freedom, description sha256 d573a89307ddd4ee9018ee9a0a94422a3db0c5f61f2798648f53f0e1b57ee437
// command   adagen ../models/humanoid.urdf --floating --procs 3 --form=ada
// options   form ada, shape joints, scalar double, channel auto, floating base, gravity 0.0, 0.0, -9.81
// links     adagen_program.cpp -DADAGEN_MPI
// program   3 processes, joined at cuts; 4.04 us predicted (default profile)
//           process 0: __base__ .. waist_yaw
//           process 1: waist_roll .. left_shoulder_pitch, neck_yaw .. right_wrist_pitch
//           process 2: left_shoulder_roll .. left_wrist_pitch
// schedule  waist_yaw@0-2(__base__@0(|left_hip_pitch(right_hip_pitch(|right_hip_roll(|right_hip_yaw(|right_knee(|right_ankle_pitch(|right_ankle_roll))))) | left_hip_roll(|left_hip_yaw(|left_knee(|left_ankle_pitch(|left_ankle_roll)))))) | waist_roll@1-2(|waist_pitch(|left_shoulder_pitch(neck_yaw@1(right_shoulder_pitch(|right_shoulder_roll(|right_shoulder_yaw(|right_elbow(|right_wrist_roll(|right_wrist_pitch))))) | neck_pitch) | left_shoulder_roll@2(|left_shoulder_yaw(|left_elbow(|left_wrist_roll(|left_wrist_pitch))))))))
// licence   yours to choose: what adagen emits belongs to whoever emits it
//
// The assembly-disassembly algorithm of Yamane and Nakamura. Phi are inverse articulated-body inertias, b
// bias accelerations. Joint i joins chain A (its parent link's side) and chain B (its child link's side)
// to chain C: assembly, Eq. (3)-(7), goes up the schedule, disassembly, Eq. (8)-(10), comes down. Spatial
// vectors are [angular; linear], in link frames turned so that every joint axis is z.
//
// How to read on:
//   1. interface   what a program that links this file calls
//   2. model       the robot's constants
//   3. runtime     spatial algebra, joints, exchange between processes
//   4. joints      for each joint its memory, then what is done with it, step by step
//   5. processes   who does what, in order
//   6. program     what the program around it, adagen_program.cpp, is told; main

// ---- 1. interface -------------------------------------------------------------------------------
// To use it from a program of yours: compile this file with -DADAGEN_NO_MAIN and link it; humanoid_p3.h
// beside it is this part.
// C interface of the solver humanoid_p3: forward dynamics of "humanoid" on 3 processes,
// emitted by adagen 0.1.0 (interface.h.j2). Do not edit: emit anew.
#ifndef ADAGEN_HUMANOID_P3_H
#define ADAGEN_HUMANOID_P3_H

#include <mpi.h>

enum {
  HUMANOID_P3_PROCESSES = 3,
  HUMANOID_P3_JOINTS = 30,
  HUMANOID_P3_NQ = 36,  // numbers in q
  HUMANOID_P3_NV = 35,  // in v and qdd
  HUMANOID_P3_NTAU = 35  // in tau
};

// Where each joint begins in q, and in v, tau and qdd.
enum {
  HUMANOID_P3_Q_base = 0,
  HUMANOID_P3_V_base = 0,  // joint 0, "__base__": floating, 7 in q, 6 in v
  HUMANOID_P3_Q_left_hip_pitch = 7,
  HUMANOID_P3_V_left_hip_pitch = 6,  // joint 1, "left_hip_pitch": revolute, 1 in q, 1 in v
  HUMANOID_P3_Q_left_hip_roll = 8,
  HUMANOID_P3_V_left_hip_roll = 7,  // joint 2, "left_hip_roll": revolute, 1 in q, 1 in v
  HUMANOID_P3_Q_left_hip_yaw = 9,
  HUMANOID_P3_V_left_hip_yaw = 8,  // joint 3, "left_hip_yaw": revolute, 1 in q, 1 in v
  HUMANOID_P3_Q_left_knee = 10,
  HUMANOID_P3_V_left_knee = 9,  // joint 4, "left_knee": revolute, 1 in q, 1 in v
  HUMANOID_P3_Q_left_ankle_pitch = 11,
  HUMANOID_P3_V_left_ankle_pitch = 10,  // joint 5, "left_ankle_pitch": revolute, 1 in q, 1 in v
  HUMANOID_P3_Q_left_ankle_roll = 12,
  HUMANOID_P3_V_left_ankle_roll = 11,  // joint 6, "left_ankle_roll": revolute, 1 in q, 1 in v
  HUMANOID_P3_Q_right_hip_pitch = 13,
  HUMANOID_P3_V_right_hip_pitch = 12,  // joint 7, "right_hip_pitch": revolute, 1 in q, 1 in v
  HUMANOID_P3_Q_right_hip_roll = 14,
  HUMANOID_P3_V_right_hip_roll = 13,  // joint 8, "right_hip_roll": revolute, 1 in q, 1 in v
  HUMANOID_P3_Q_right_hip_yaw = 15,
  HUMANOID_P3_V_right_hip_yaw = 14,  // joint 9, "right_hip_yaw": revolute, 1 in q, 1 in v
  HUMANOID_P3_Q_right_knee = 16,
  HUMANOID_P3_V_right_knee = 15,  // joint 10, "right_knee": revolute, 1 in q, 1 in v
  HUMANOID_P3_Q_right_ankle_pitch = 17,
  HUMANOID_P3_V_right_ankle_pitch = 16,  // joint 11, "right_ankle_pitch": revolute, 1 in q, 1 in v
  HUMANOID_P3_Q_right_ankle_roll = 18,
  HUMANOID_P3_V_right_ankle_roll = 17,  // joint 12, "right_ankle_roll": revolute, 1 in q, 1 in v
  HUMANOID_P3_Q_waist_yaw = 19,
  HUMANOID_P3_V_waist_yaw = 18,  // joint 13, "waist_yaw": revolute, 1 in q, 1 in v
  HUMANOID_P3_Q_waist_roll = 20,
  HUMANOID_P3_V_waist_roll = 19,  // joint 14, "waist_roll": revolute, 1 in q, 1 in v
  HUMANOID_P3_Q_waist_pitch = 21,
  HUMANOID_P3_V_waist_pitch = 20,  // joint 15, "waist_pitch": revolute, 1 in q, 1 in v
  HUMANOID_P3_Q_left_shoulder_pitch = 22,
  HUMANOID_P3_V_left_shoulder_pitch = 21,  // joint 16, "left_shoulder_pitch": revolute, 1 in q, 1 in v
  HUMANOID_P3_Q_left_shoulder_roll = 23,
  HUMANOID_P3_V_left_shoulder_roll = 22,  // joint 17, "left_shoulder_roll": revolute, 1 in q, 1 in v
  HUMANOID_P3_Q_left_shoulder_yaw = 24,
  HUMANOID_P3_V_left_shoulder_yaw = 23,  // joint 18, "left_shoulder_yaw": revolute, 1 in q, 1 in v
  HUMANOID_P3_Q_left_elbow = 25,
  HUMANOID_P3_V_left_elbow = 24,  // joint 19, "left_elbow": revolute, 1 in q, 1 in v
  HUMANOID_P3_Q_left_wrist_roll = 26,
  HUMANOID_P3_V_left_wrist_roll = 25,  // joint 20, "left_wrist_roll": revolute, 1 in q, 1 in v
  HUMANOID_P3_Q_left_wrist_pitch = 27,
  HUMANOID_P3_V_left_wrist_pitch = 26,  // joint 21, "left_wrist_pitch": revolute, 1 in q, 1 in v
  HUMANOID_P3_Q_neck_yaw = 28,
  HUMANOID_P3_V_neck_yaw = 27,  // joint 22, "neck_yaw": revolute, 1 in q, 1 in v
  HUMANOID_P3_Q_neck_pitch = 29,
  HUMANOID_P3_V_neck_pitch = 28,  // joint 23, "neck_pitch": revolute, 1 in q, 1 in v
  HUMANOID_P3_Q_right_shoulder_pitch = 30,
  HUMANOID_P3_V_right_shoulder_pitch = 29,  // joint 24, "right_shoulder_pitch": revolute, 1 in q, 1 in v
  HUMANOID_P3_Q_right_shoulder_roll = 31,
  HUMANOID_P3_V_right_shoulder_roll = 30,  // joint 25, "right_shoulder_roll": revolute, 1 in q, 1 in v
  HUMANOID_P3_Q_right_shoulder_yaw = 32,
  HUMANOID_P3_V_right_shoulder_yaw = 31,  // joint 26, "right_shoulder_yaw": revolute, 1 in q, 1 in v
  HUMANOID_P3_Q_right_elbow = 33,
  HUMANOID_P3_V_right_elbow = 32,  // joint 27, "right_elbow": revolute, 1 in q, 1 in v
  HUMANOID_P3_Q_right_wrist_roll = 34,
  HUMANOID_P3_V_right_wrist_roll = 33,  // joint 28, "right_wrist_roll": revolute, 1 in q, 1 in v
  HUMANOID_P3_Q_right_wrist_pitch = 35,
  HUMANOID_P3_V_right_wrist_pitch = 34  // joint 29, "right_wrist_pitch": revolute, 1 in q, 1 in v
};

// Why a call failed, as humanoid_p3_reason tells of the status that it returned.
enum {
  HUMANOID_P3_FINE = 0,  // none
  HUMANOID_P3_NOT_FINITE = 1,  // q, v or tau of a joint is not a finite number
  HUMANOID_P3_ZERO_QUATERNION = 2,  // a joint's quaternion cannot be normalised
  HUMANOID_P3_FACTORIZATION = 3,  // inertias beside a joint differ too much for the scalar
  HUMANOID_P3_OVERFLOW = 4,  // a joint's acceleration is not a finite number
  HUMANOID_P3_NO_ANSWER = 5,  // a process did not answer within the time limit
  HUMANOID_P3_ENDED = 6,  // process 0 has ended the evaluations
  HUMANOID_P3_NOT_REFINED = 7,  // refinement does not converge
  HUMANOID_P3_GIMBAL_LOCK = 8,  // joints that are joined as one do not move in as many directions
  HUMANOID_P3_GROWTH = 9,  // a link beside a joint is too light for its neighbours
  HUMANOID_P3_NOT_SET = 16,  // what is to be set at run time is not finite, or is no mass
  HUMANOID_P3_TOO_FEW_STEPS = 11,  // refinement converges too slowly
  HUMANOID_P3_LOOP_OPEN = 12,  // a loop or coupling is not closed in this configuration
  HUMANOID_P3_LOOP_TORN = 13,  // this velocity tears a loop or coupling open
  HUMANOID_P3_LOOP_SINGULAR = 14,  // what a loop holds changes in this pose
  HUMANOID_P3_LOOP_FREE = 15  // loops leave a joint a motion that no inertia resists
};

#ifdef __cplusplus
extern "C" {
#endif
typedef struct humanoid_p3_solver humanoid_p3_solver;

// Joints in order, each with its place in the state: gives name, start and size in q and v of joint
// k, or returns 0 where there is none.
int humanoid_p3_joint(int k, const char** name, int* q, int* nq, int* v, int* nv);

// Collective over a communicator of 3 processes. channel: "auto", "window" (shared memory) or
// "message"; time_limit: seconds that a process waits for another. Returns null where it cannot be
// done; humanoid_p3_failure(NULL) says why.
humanoid_p3_solver* humanoid_p3_open(MPI_Comm comm, const char* channel, double time_limit);

// One evaluation, collective. q: 36 numbers, v and tau: 35 each, qdd: 35; joints in order, quaternions
// x y z w (normalised here), floating joints [linear; angular] in the body's frame.
// solve: every process passes the state and gets its own joints' accelerations (others untouched);
// solve_at_root: process 0 passes the state and gets them all, the others may pass null, or serve.
// Returns 0, or a status that humanoid_p3_failure puts into words; no acceleration is written then.
int humanoid_p3_solve(humanoid_p3_solver* solver, const double* q, const double* v, const double* tau, double* qdd);
int humanoid_p3_solve_at_root(humanoid_p3_solver* solver, const double* q, const double* v, const double* tau, double* qdd);

// What every process but 0 can do all the time: takes part in each solve_at_root of process 0, however
// long that lets it wait, until process 0 ends it. Returns 0, or why it cannot go on.
int humanoid_p3_serve(humanoid_p3_solver* solver);

// At process 0: the others' serve returns. They may serve again, or all close.
int humanoid_p3_end(humanoid_p3_solver* solver);

// What a status says: its reason, and which joint it is about, -1 for none.
int humanoid_p3_reason(int status);
int humanoid_p3_failed_joint(int status);

// The last failure of a solver in words, valid until the next call; of null, why the last open of this
// thread returned null.
const char* humanoid_p3_failure(const humanoid_p3_solver* solver);

// Collective.
void humanoid_p3_close(humanoid_p3_solver* solver);
#ifdef __cplusplus
}
#endif
#endif

#include <algorithm>
#include <array>
#include <atomic>
#include <chrono>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <cstring>
#include <exception>
#include <limits>
#include <memory>
#include <new>
#include <string>
#include <thread>
#include <type_traits>
#include <utility>
#include <vector>

#include <Eigen/Core>
#include <Eigen/Geometry>
#include <Eigen/LU>

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
constexpr int kProcesses = 3;
[[maybe_unused]] constexpr bool kAlone = false;  // whether process 0 does all, and no other takes part
constexpr int kJointCount = 30, kLinkCount = kJointCount + 1;
constexpr int kNq = 36, kNv = 35;
constexpr int kOuterCount = 0, kNtau = kNv + 6 * kOuterCount;
constexpr int kNqdd = 35;
[[maybe_unused]] constexpr int kColumns = 1;  // right-hand sides: the motion, and one per slaved joint
[[maybe_unused]] constexpr std::size_t kSlavedCount = 0;  // joints that follow others
[[maybe_unused]] constexpr bool kBatch = false;  // whether many states are solved at once
[[maybe_unused]] constexpr int kRefine = 0;  // steps of iterative refinement
[[maybe_unused]] constexpr int kPlanMessages = 4;
constexpr std::size_t kCacheLine = 64, kTextSize = 1000;
[[maybe_unused]] constexpr double kTolerance = 1e-09;
const MPI_Datatype kMpiNumber = MPI_DOUBLE;

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
     {30.819775200559686, 0.0, 0.0, 0.0, 56.92588818617042, 0.0, 0.0, 0.0, 28.463025107234447}},
    {"left_hip", 1.4, {0.0, 0.0, 0.03},
     {0.00182, 0.0, 0.0, 0.0, 0.00182, 0.0, 0.0, 0.0, 0.00175},
     {549.4505494505495, 0.0, 0.0, 0.0, 549.4505494505495, 0.0, 0.0, 0.0, 571.4285714285714}},
    {"left_groin", 1.2, {0.0, -0.04, 0.02},
     {0.00139, 0.0, 0.0, 0.0, 0.00139, 0.0, 0.0, 0.0, 0.0015},
     {719.4244604316547, 0.0, 0.0, 0.0, 719.4244604316547, 0.0, 0.0, 0.0, 666.6666666666666}},
    {"left_thigh", 2.6, {0.0, 0.0, -0.1},
     {0.0169867, 0.0, 0.0, 0.0, 0.0169867, 0.0, 0.0, 0.0, 0.00468},
     {58.86958620567856, 0.0, 0.0, 0.0, 58.86958620567856, 0.0, 0.0, 0.0, 213.67521367521366}},
    {"left_shank", 1.8, {-0.13, 0.01, 0.0},
     {0.0018225, 0.0, 0.0, 0.0, 0.0126713, 0.0, 0.0, 0.0, 0.0126713},
     {548.6968449931413, 0.0, 0.0, 0.0, 78.91850086415758, 0.0, 0.0, 0.0, 78.91850086415758}},
    {"left_ankle", 0.2, {0.0, 0.0, 0.0},
     {7.2e-05, 0.0, 0.0, 0.0, 7.2e-05, 0.0, 0.0, 0.0, 7.2e-05},
     {13888.888888888889, 0.0, 0.0, 0.0, 13888.888888888889, 0.0, 0.0, 0.0, 13888.888888888889}},
    {"left_foot", 0.8, {0.0, -0.03, 0.03},
     {0.00272667, 0.0, 0.0, 0.0, 0.00309333, 0.0, 0.0, 0.0, 0.000486667},
     {366.7477179123253, 0.0, 0.0, 0.0, 323.2762104269509, 0.0, 0.0, 0.0, 2054.793113155402}},
    {"right_hip", 1.4, {0.0, 0.0, -0.03},
     {0.00182, 0.0, 0.0, 0.0, 0.00182, 0.0, 0.0, 0.0, 0.00175},
     {549.4505494505495, 0.0, 0.0, 0.0, 549.4505494505495, 0.0, 0.0, 0.0, 571.4285714285714}},
    {"right_groin", 1.2, {0.0, -0.04, 0.02},
     {0.00139, 0.0, 0.0, 0.0, 0.00139, 0.0, 0.0, 0.0, 0.0015},
     {719.4244604316547, 0.0, 0.0, 0.0, 719.4244604316547, 0.0, 0.0, 0.0, 666.6666666666666}},
    {"right_thigh", 2.6, {0.0, 0.0, -0.1},
     {0.0169867, 0.0, 0.0, 0.0, 0.0169867, 0.0, 0.0, 0.0, 0.00468},
     {58.86958620567856, 0.0, 0.0, 0.0, 58.86958620567856, 0.0, 0.0, 0.0, 213.67521367521366}},
    {"right_shank", 1.8, {-0.13, 0.01, 0.0},
     {0.0018225, 0.0, 0.0, 0.0, 0.0126713, 0.0, 0.0, 0.0, 0.0126713},
     {548.6968449931413, 0.0, 0.0, 0.0, 78.91850086415758, 0.0, 0.0, 0.0, 78.91850086415758}},
    {"right_ankle", 0.2, {0.0, 0.0, 0.0},
     {7.2e-05, 0.0, 0.0, 0.0, 7.2e-05, 0.0, 0.0, 0.0, 7.2e-05},
     {13888.888888888889, 0.0, 0.0, 0.0, 13888.888888888889, 0.0, 0.0, 0.0, 13888.888888888889}},
    {"right_foot", 0.8, {0.0, -0.03, 0.03},
     {0.00272667, 0.0, 0.0, 0.0, 0.00309333, 0.0, 0.0, 0.0, 0.000486667},
     {366.7477179123253, 0.0, 0.0, 0.0, 323.2762104269509, 0.0, 0.0, 0.0, 2054.793113155402}},
    {"waist_link", 0.8, {0.0, 0.0, 0.02},
     {0.00074, 0.0, 0.0, 0.0, 0.00074, 0.0, 0.0, 0.0, 0.001},
     {1351.3513513513515, 0.0, 0.0, 0.0, 1351.3513513513515, 0.0, 0.0, 0.0, 1000.0}},
    {"abdomen", 0.9, {0.0, 0.02, 0.0},
     {0.0010425, 0.0, 0.0, 0.0, 0.001125, 0.0, 0.0, 0.0, 0.0010425},
     {959.2326139088728, 0.0, 0.0, 0.0, 888.8888888888889, 0.0, 0.0, 0.0, 959.2326139088728}},
    {"torso", 9.5, {0.17, 0.01, 0.0},
     {0.0823333, 0.0, 0.0, 0.0, 0.153583, 0.0, 0.0, 0.0, 0.111783},
     {12.145753905163525, 0.0, 0.0, 0.0, 6.511137300352253, 0.0, 0.0, 0.0, 8.945904117799666}},
    {"left_shoulder", 0.8, {0.0, 0.0, 0.03},
     {0.000646667, 0.0, 0.0, 0.0, 0.000646667, 0.0, 0.0, 0.0, 0.00064},
     {1546.3909554685797, 0.0, 0.0, 0.0, 1546.3909554685797, 0.0, 0.0, 0.0, 1562.4999999999998}},
    {"left_shoulder_cap", 0.7, {0.01, -0.03, 0.0},
     {0.0007, 0.0, 0.0, 0.0, 0.0007, 0.0, 0.0, 0.0, 0.0007},
     {1428.5714285714287, 0.0, 0.0, 0.0, 1428.5714285714287, 0.0, 0.0, 0.0, 1428.5714285714287}},
    {"left_upper_arm", 0.8, {0.0, 0.0, -0.05},
     {0.00162667, 0.0, 0.0, 0.0, 0.00162667, 0.0, 0.0, 0.0, 0.00064},
     {614.7528386212323, 0.0, 0.0, 0.0, 614.7528386212323, 0.0, 0.0, 0.0, 1562.4999999999998}},
    {"left_forearm", 0.7, {-0.07, 0.02, 0.0},
     {0.00042875, 0.0, 0.0, 0.0, 0.00170771, 0.0, 0.0, 0.0, 0.00170771},
     {2332.3615160349855, 0.0, 0.0, 0.0, 585.5795187707514, 0.0, 0.0, 0.0, 585.5795187707514}},
    {"left_wrist", 0.2, {0.0, 0.0, -0.01},
     {8.66667e-05, 0.0, 0.0, 0.0, 8.66667e-05, 0.0, 0.0, 0.0, 9e-05},
     {11538.457100593423, 0.0, 0.0, 0.0, 11538.457100593423, 0.0, 0.0, 0.0, 11111.111111111111}},
    {"left_hand", 0.4, {-0.06, 0.0, 0.0},
     {0.000296667, 0.0, 0.0, 0.0, 0.000693333, 0.0, 0.0, 0.0, 0.000563333},
     {3370.7827294576073, 0.0, 0.0, 0.0, 1442.3083857251854, 0.0, 0.0, 0.0, 1775.1489793780945}},
    {"neck", 0.4, {0.0, 0.0, 0.02},
     {0.00021, 0.0, 0.0, 0.0, 0.00021, 0.0, 0.0, 0.0, 0.00018},
     {4761.9047619047615, 0.0, 0.0, 0.0, 4761.9047619047615, 0.0, 0.0, 0.0, 5555.555555555556}},
    {"head", 2.4, {0.09, 0.02, 0.0},
     {0.007776, 0.0, 0.0, 0.0, 0.007776, 0.0, 0.0, 0.0, 0.007776},
     {128.6008230452675, 0.0, 0.0, 0.0, 128.6008230452675, 0.0, 0.0, 0.0, 128.6008230452675}},
    {"right_shoulder", 0.8, {0.0, 0.0, -0.03},
     {0.000646667, 0.0, 0.0, 0.0, 0.000646667, 0.0, 0.0, 0.0, 0.00064},
     {1546.3909554685797, 0.0, 0.0, 0.0, 1546.3909554685797, 0.0, 0.0, 0.0, 1562.4999999999998}},
    {"right_shoulder_cap", 0.7, {-0.01, -0.03, 0.0},
     {0.0007, 0.0, 0.0, 0.0, 0.0007, 0.0, 0.0, 0.0, 0.0007},
     {1428.5714285714287, 0.0, 0.0, 0.0, 1428.5714285714287, 0.0, 0.0, 0.0, 1428.5714285714287}},
    {"right_upper_arm", 0.8, {0.0, 0.0, -0.05},
     {0.00162667, 0.0, 0.0, 0.0, 0.00162667, 0.0, 0.0, 0.0, 0.00064},
     {614.7528386212323, 0.0, 0.0, 0.0, 614.7528386212323, 0.0, 0.0, 0.0, 1562.4999999999998}},
    {"right_forearm", 0.7, {-0.07, 0.02, 0.0},
     {0.00042875, 0.0, 0.0, 0.0, 0.00170771, 0.0, 0.0, 0.0, 0.00170771},
     {2332.3615160349855, 0.0, 0.0, 0.0, 585.5795187707514, 0.0, 0.0, 0.0, 585.5795187707514}},
    {"right_wrist", 0.2, {0.0, 0.0, -0.01},
     {8.66667e-05, 0.0, 0.0, 0.0, 8.66667e-05, 0.0, 0.0, 0.0, 9e-05},
     {11538.457100593423, 0.0, 0.0, 0.0, 11538.457100593423, 0.0, 0.0, 0.0, 11111.111111111111}},
    {"right_hand", 0.4, {-0.06, 0.0, 0.0},
     {0.000296667, 0.0, 0.0, 0.0, 0.000693333, 0.0, 0.0, 0.0, 0.000563333},
     {3370.7827294576073, 0.0, 0.0, 0.0, 1442.3083857251854, 0.0, 0.0, 0.0, 1775.1489793780945}},
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

// Spatial vectors are [angular; linear], in link frames. A right-hand side has kColumns columns:
// the motion itself, and one for each slaved joint's coupling torque.
using Vec3 = Eigen::Matrix<Real, 3, 1>;
using Mat3 = Eigen::Matrix<Real, 3, 3>;
using Vec6 = Eigen::Matrix<Real, 6, 1>;
using Mat6 = Eigen::Matrix<Real, 6, 6>;
using Columns6 = Eigen::Matrix<Real, 6, kColumns>;

// Motion transform X = [[E, 0], [-E rx, E]] from the parent link's to the child link's frame.
struct Transform {
  Mat3 E;  // rotates parent coordinates into child coordinates
  Vec3 r;  // origin of the child frame in parent coordinates

  template <class M>
  void times(const M& m, M& result) const {
    for (int k = 0; k < M::ColsAtCompileTime; ++k) {
      const Vec3 angular = m.col(k).template head<3>();
      const Vec3 linear = m.col(k).template tail<3>();
      result.col(k).template head<3>().noalias() = E * angular;
      result.col(k).template tail<3>().noalias() = E * (linear - r.cross(angular));
    }
  }

  // X^T m: takes a wrench on the child to the same wrench on the parent.
  Columns6 transposed_times(const Columns6& m) const {
    Columns6 result;
    for (int k = 0; k < kColumns; ++k) {
      const Vec3 force = E.transpose() * m.col(k).template tail<3>();
      result.col(k).template head<3>() =
          E.transpose() * m.col(k).template head<3>() + r.cross(force);
      result.col(k).template tail<3>() = force;
    }
    return result;
  }
};

ADAGEN_NOINLINE Mat6 operator*(const Transform& X, const Mat6& m) {
  Mat6 result;
  X.times(m, result);
  return result;
}

ADAGEN_NOINLINE Mat6 times_transposed(const Transform& X, const Mat6& m) {
  Mat6 transposed, result;
  transposed.noalias() = m.transpose();
  X.times(transposed, result);
  return result;
}

// m X^T, which is (X m^T)^T: with m = X Phi the congruence X Phi X^T.
ADAGEN_NOINLINE Mat6 from_right(const Mat6& m, const Transform& X) {
  Mat6 result = times_transposed(X, m);
  result.transposeInPlace();
  return result;
}

template <int columns>
Eigen::Matrix<Real, 6, columns> operator*(const Transform& X,
                                          const Eigen::Matrix<Real, 6, columns>& m) {
  Eigen::Matrix<Real, 6, columns> result;
  X.times(m, result);
  return result;
}

// Phi = I^-1 of a bare link at its origin, from its upper triangle row by row.
[[maybe_unused]] Mat6 symmetric(const std::array<Real, 21>& upper) {
  Mat6 result;
  std::size_t k = 0;
  for (int i = 0; i < 6; ++i)
    for (int j = i; j < 6; ++j) result(i, j) = result(j, i) = upper[k++];
  return result;
}

// Rotation of a unit quaternion's conjugate: parent coordinates into child coordinates. The
// quaternion (x, y, z, w) is normalised here; its squared length is returned, to be checked.
[[maybe_unused]] Real conjugate_rotation(const Number* quaternion, Mat3& E) {
  const Real x = Real(quaternion[0]), y = Real(quaternion[1]);
  const Real z = Real(quaternion[2]), w = Real(quaternion[3]);
  const Real squared = x * x + y * y + z * z + w * w;
  const Real s = 2 / squared;
  E << 1 - s * (y * y + z * z), s * (x * y + z * w), s * (x * z - y * w),  //
      s * (x * y - z * w), 1 - s * (x * x + z * z), s * (y * z + x * w),   //
      s * (x * z + y * w), s * (y * z - x * w), 1 - s * (x * x + y * y);
  return squared;
}

// b of a bare link: its acceleration (relative to free fall) when nothing acts on it.
ADAGEN_NOINLINE void link_bias(const LinkConstants& link, const Vec6& velocity, Columns6& b) {
  using Constant3 = Eigen::Map<const Eigen::Matrix<Number, 3, 3, Eigen::RowMajor>>;
  const Vec3 omega = velocity.head<3>(), v = velocity.tail<3>();
  const Vec3 c(Real(link.com[0]), Real(link.com[1]), Real(link.com[2]));
  const Vec3 momentum = Constant3(link.tensor).cast<Real>() * omega;
  const Vec3 alpha = Constant3(link.tensor_inverse).cast<Real>() * momentum.cross(omega);
  b.setZero();
  b.col(0).template head<3>() = alpha;
  b.col(0).template tail<3>() = c.cross(alpha) - omega.cross(omega.cross(c) + v);
}

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

// Joint kinds in their canonical frames: the rows of a spatial vector that a joint frees (R, S) and
// those it constrains (N). Both are selections, so N and R cost nothing and round nothing.
template <int... Rows>
struct Selection {
  static constexpr int count = sizeof...(Rows);
  static constexpr std::array<int, sizeof...(Rows)> row{Rows...};
};

struct Revolute {
  using Free = Selection<2>;
  using Constrained = Selection<0, 1, 3, 4, 5>;
};
struct Prismatic {
  using Free = Selection<5>;
  using Constrained = Selection<0, 1, 2, 3, 4>;
};
struct Spherical {
  using Free = Selection<0, 1, 2>;
  using Constrained = Selection<3, 4, 5>;
};
struct Planar {
  using Free = Selection<3, 4, 2>;
  using Constrained = Selection<0, 1, 5>;
};
struct Floating {
  using Free = Selection<3, 4, 5, 0, 1, 2>;
  using Constrained = Selection<>;
};

template <class Kind>
[[maybe_unused]] constexpr int kFree = Kind::Free::count;
template <class Kind>
[[maybe_unused]] constexpr int kConstrained = Kind::Constrained::count;

// S qd, the velocity across a joint.
template <class Kind>
Vec6 joint_velocity(const Number* qd) {
  Vec6 result = Vec6::Zero();
  for (int k = 0; k < kFree<Kind>; ++k) result[Kind::Free::row[k]] = Real(qd[k]);
  return result;
}

// c_i = v_i x S qd, the part of the acceleration across a joint that qdd has no say in.
template <class Kind>
Columns6 velocity_product(const Vec6& velocity, const Number* qd) {
  const Vec6 motion = joint_velocity<Kind>(qd);
  Columns6 result = Columns6::Zero();
  result.col(0).template head<3>() = velocity.head<3>().cross(motion.head<3>());
  result.col(0).template tail<3>() =
      velocity.head<3>().cross(motion.tail<3>()) + velocity.tail<3>().cross(motion.head<3>());
  return result;
}

// What disassembly needs of a joint i that was assembled.
template <class Kind>
struct Joined {
  static constexpr int n = kFree<Kind>, m = kConstrained<Kind>;
  std::array<std::array<Real, m>, m> L;         // Cholesky factor of V_i^-1; its diagonal inverted
  std::array<std::array<Real, m>, n> RPN;       // R_i (Phi_Ai + Phi_Bi) N_i^T
  std::array<std::array<Real, kColumns>, m> z;  // L^-1 N_i beta_i
  std::array<std::array<Real, kColumns>, n> R_beta;  // R_i beta_i
  std::array<std::array<Real, kColumns>, n> tau;
};

// How a joint i and a handle j of one chain feel each other: Z = L^-1 N_i Phi_ij, Y = R_i Phi_ij.
template <class Kind>
struct Coupled {
  std::array<std::array<Real, 6>, kConstrained<Kind>> Z;
  std::array<std::array<Real, 6>, kFree<Kind>> Y;
};

// x <- L^-1 x, row by row.
template <std::size_t m, std::size_t k>
void forward_substitute(const std::array<std::array<Real, m>, m>& L,
                        std::array<std::array<Real, k>, m>& x) {
  for (std::size_t i = 0; i < m; ++i) {
    for (std::size_t j = 0; j < i; ++j)
      for (std::size_t c = 0; c < k; ++c) x[i][c] -= L[i][j] * x[j][c];
    for (std::size_t c = 0; c < k; ++c) x[i][c] *= L[i][i];
  }
}

// x <- L^-T x.
template <std::size_t m, std::size_t k>
void backward_substitute(const std::array<std::array<Real, m>, m>& L,
                         std::array<std::array<Real, k>, m>& x) {
  for (std::size_t i = m; i-- > 0;) {
    for (std::size_t c = 0; c < k; ++c) x[i][c] *= L[i][i];
    for (std::size_t j = 0; j < i; ++j)
      for (std::size_t c = 0; c < k; ++c) x[j][c] -= L[i][j] * x[i][c];
  }
}

// Cholesky's factorization in place, the inverse of the diagonal in its place. False where a pivot
// has lost every digit, or was none to begin with.
template <std::size_t m>
bool factorize(std::array<std::array<Real, m>, m>& L) {
  bool good = true;
  for (std::size_t j = 0; j < m; ++j) {
    Real pivot = L[j][j];
    const Real least = 8 * std::numeric_limits<Real>::epsilon() * pivot;
    for (std::size_t k = 0; k < j; ++k) pivot -= L[j][k] * L[j][k];
    good = good && pivot > least && pivot <= std::numeric_limits<Real>::max();
    const Real inverse = 1 / std::sqrt(pivot);
    L[j][j] = inverse;
    for (std::size_t i = j + 1; i < m; ++i) {
      for (std::size_t k = 0; k < j; ++k) L[i][j] -= L[i][k] * L[j][k];
      L[i][j] *= inverse;
    }
  }
  return good;
}

// Whether M = N (Phi_A + Phi_B) N^T keeps digits. Phi - Z^T Z of earlier joins has taken away most
// of a light link's mobility, with a rounding error of eps times what the bare link had: least, for
// each row, is 64 eps times that.
template <class Kind>
bool keeps_digits(const Mat6& Phi_A, const Mat6& Phi_B, const std::array<Real, 6>& least) {
  bool good = true;
  for (int k : Kind::Constrained::row)
    good = good && Phi_A(k, k) + Phi_B(k, k) > least[static_cast<std::size_t>(k)];
  return good;
}

// V_i and beta_i of Eq. (3)-(7): Phi_A and Phi_B are those of the joint's two sides in its frame,
// b_A, b_B and c the accelerations there. Returns false where the factorization fails.
template <class Kind>
ADAGEN_NOINLINE bool join(Joined<Kind>& i, const Mat6& Phi_A, const Mat6& Phi_B,
                          const Columns6& b_A, const Columns6& b_B, const Columns6& c) {
  constexpr int n = kFree<Kind>, m = kConstrained<Kind>;
  constexpr auto& free = Kind::Free::row;
  [[maybe_unused]] constexpr auto& constrained = Kind::Constrained::row;
  const Mat6 Phi = Phi_A + Phi_B;
  Columns6 beta = b_A - b_B + c;
  for (int k = 0; k < n; ++k)
    for (int column = 0; column < kColumns; ++column)
      beta.col(column) -= Phi.col(free[k]) * i.tau[k][column];
  for (int row = 0; row < n; ++row) {
    for (int column = 0; column < kColumns; ++column)
      i.R_beta[row][column] = beta(free[row], column);
    for (int k = 0; k < m; ++k) i.RPN[row][k] = Phi(free[row], constrained[k]);
  }
  if constexpr (m > 0) {
    for (int row = 0; row < m; ++row) {
      for (int k = 0; k <= row; ++k) i.L[row][k] = Phi(constrained[row], constrained[k]);
      for (int column = 0; column < kColumns; ++column)
        i.z[row][column] = beta(constrained[row], column);
    }
    const bool good = factorize(i.L);
    forward_substitute(i.L, i.z);
    return good;
  }
  return true;
}

// Z and Y of a handle j, Phi_ij being given with the joint's frame on its left.
template <class Kind>
ADAGEN_NOINLINE void couple(const Joined<Kind>& i, const Mat6& Phi_ij, Coupled<Kind>& j) {
  for (int row = 0; row < kFree<Kind>; ++row)
    for (int k = 0; k < 6; ++k) j.Y[row][k] = Phi_ij(Kind::Free::row[row], k);
  if constexpr (kConstrained<Kind> > 0) {
    for (int row = 0; row < kConstrained<Kind>; ++row)
      for (int k = 0; k < 6; ++k) j.Z[row][k] = Phi_ij(Kind::Constrained::row[row], k);
    forward_substitute(i.L, j.Z);
  }
}

// Phi_Aji W_i Phi_Aik = Z_j^T Z_k: what Eq. (3) and (4) subtract and Eq. (5) is.
template <class Kind>
ADAGEN_NOINLINE Mat6 product([[maybe_unused]] const Coupled<Kind>& j,
                             [[maybe_unused]] const Coupled<Kind>& k) {
  Mat6 result = Mat6::Zero();
  if constexpr (kConstrained<Kind> > 0) {
    for (int row = 0; row < kConstrained<Kind>; ++row) {
      const Vec6 left = Eigen::Map<const Vec6>(j.Z[row].data());
      const Vec6 right = Eigen::Map<const Vec6>(k.Z[row].data());
      result.noalias() += left * right.transpose();
    }
  }
  return result;
}

// Phi_ji gamma_i = Z^T z + Y^T tau: the change of b_j in Eq. (6) and (7).
template <class Kind>
Columns6 bias_change(const Joined<Kind>& i, const Coupled<Kind>& j) {
  Columns6 result = Columns6::Zero();
  for (int column = 0; column < kColumns; ++column) {
    for (int row = 0; row < kConstrained<Kind>; ++row)
      result.col(column) += Eigen::Map<const Vec6>(j.Z[row].data()) * i.z[row][column];
    for (int row = 0; row < kFree<Kind>; ++row)
      result.col(column) += Eigen::Map<const Vec6>(j.Y[row].data()) * i.tau[row][column];
  }
  return result;
}

// Disassembly of a joint: collects what the outer forces do to it, then gives its acceleration and
// its force.
template <class Kind>
class Release {
 public:
  explicit Release(const Joined<Kind>& i) : i_(i), z_(i.z), qdd_(i.R_beta) {
    for (auto& row : qdd_)
      for (Real& x : row) x = -x;
  }

  void feel_A(const Coupled<Kind>& j, const Columns6& f) { feel(j, f, Real(1)); }
  void feel_B(const Coupled<Kind>& k, const Columns6& f) { feel(k, f, Real(-1)); }

  // f_i, Eq. (10); on the way n_i, Eq. (8), and qdd_i, Eq. (9).
  Columns6 force() {
    if constexpr (kConstrained<Kind> > 0) backward_substitute(i_.L, z_);
    Columns6 f;
    for (int column = 0; column < kColumns; ++column) {
      for (int k = 0; k < kConstrained<Kind>; ++k)
        f(Kind::Constrained::row[k], column) = z_[k][column];
      for (int k = 0; k < kFree<Kind>; ++k) {
        f(Kind::Free::row[k], column) = i_.tau[k][column];
        for (int l = 0; l < kConstrained<Kind>; ++l)
          qdd_[k][column] += i_.RPN[k][l] * z_[l][column];
      }
    }
    return f;
  }

  const std::array<std::array<Real, kColumns>, kFree<Kind>>& qdd() const { return qdd_; }

 private:
  void feel(const Coupled<Kind>& j, const Columns6& f, Real sign) {
    for (int column = 0; column < kColumns; ++column) {
      const Vec6 signed_f = sign * f.col(column);
      for (int row = 0; row < kConstrained<Kind>; ++row)
        z_[row][column] += Eigen::Map<const Vec6>(j.Z[row].data()).dot(signed_f);
      for (int row = 0; row < kFree<Kind>; ++row)
        qdd_[row][column] -= Eigen::Map<const Vec6>(j.Y[row].data()).dot(signed_f);
    }
  }

  const Joined<Kind>& i_;
  std::array<std::array<Real, kColumns>, kConstrained<Kind>> z_;
  std::array<std::array<Real, kColumns>, kFree<Kind>> qdd_;
};

constexpr std::array<MessageInfo, 8> kMessages{ {
    {2, 1, 42},  // 0: assembled: chain of "left_shoulder_roll"
    {1, 0, 42},  // 1: assembled: chain of "waist_roll"
    {0, 1, 6},  // 2: forces on: chain of "waist_roll"
    {1, 2, 6},  // 3: forces on: chain of "left_shoulder_roll"
    {0, 1, 48},  // 4: state
    {1, 0, 11},  // 5: accelerations
    {0, 2, 36},  // 6: state
    {2, 0, 5},  // 7: accelerations
} };

enum class ChannelMode { kAuto, kWindow, kMessage };

inline void relax() {
#if defined(__x86_64__) || defined(__i386__)
  __builtin_ia32_pause();
#elif defined(__aarch64__)
  asm volatile("yield");
#endif
}

// What a process does in an evaluation as the others see it: the messages that it sends and
// receives, in order, and what those received hold. Played again, it computes the same by itself:
// what it sends goes nowhere, and what it receives is there at once. (--stretches)
class Take {
 public:
  using Clock = std::chrono::steady_clock;

  // Notes from here on what goes through the channel.
  void record() { playing_ = false; }

  // Plays from the start, and looks at the clock at each message.
  void play() {
    playing_ = true;
    next_ = 0;
  }

  bool playing() const { return playing_; }
  const std::vector<int>& messages() const { return messages_; }
  const std::vector<Clock::rep>& looks() const { return looks_; }  // one at each message

  // Message k was sent, or received with this content, its status before it.
  ADAGEN_NOINLINE void note(int k, const Number* content = nullptr) {
    messages_.push_back(k);
    looks_.push_back(0);
    starts_.push_back(contents_.size());
    const std::size_t size =
        content ? static_cast<std::size_t>(kMessages[static_cast<std::size_t>(k)].size) + 1 : 0;
    contents_.insert(contents_.end(), content, content + size);
  }

  // The next message is due; returns its content, if it is one received.
  ADAGEN_NOINLINE const Number* pass() {
    looks_[next_] = Clock::now().time_since_epoch().count();
    return contents_.data() + starts_[next_++];
  }

 private:
  bool playing_ = false;
  std::size_t next_ = 0;
  std::vector<int> messages_;
  std::vector<Clock::rep> looks_;
  std::vector<std::size_t> starts_;  // in contents_
  std::vector<Number> contents_;
};

// Exchange between processes. Processes on one node meet in a shared window: a message is a slot
// that its source fills and then numbers (release), and that its target reads once it sees the
// number (acquire). Other pairs exchange MPI messages. A message has two slots, taken in turn: when
// one is written again, two evaluations later, its target has answered in the one between.
class Channel {
 public:
  Channel() = default;
  Channel(const Channel&) = delete;
  Channel& operator=(const Channel&) = delete;

  // Collective. Returns an empty string, or what is wrong. hosts: if not 0, processes are taken to
  // be on so many hosts, in equal parts, whatever they share.
  std::string open(MPI_Comm comm, ChannelMode mode, double time_limit, int hosts = 0) {
    MPI_Comm_dup(comm, &comm_);
    MPI_Comm_rank(comm_, &rank_);
    time_limit_ = std::chrono::duration_cast<Clock::duration>(
        std::chrono::duration<double>(std::min(time_limit, 1e8)));
    ports_.resize(kMessages.size());
    find_node(hosts);
    const bool window = mode == ChannelMode::kMessage || open_window();
    std::array<int, 2> ways{};  // messages through MPI, through the window
    for (std::size_t k = 0; k < ports_.size(); ++k) {
      const MessageInfo& info = kMessages[k];
      if (info.source != rank_ && info.target != rank_) continue;
      if (info.size > 0) ++ways[ports_[k].slots ? 1 : 0];  // none goes to a process without work
      if (!ports_[k].slots) ports_[k].buffer.resize(static_cast<std::size_t>(info.size) + 1);
    }
    MPI_Allreduce(MPI_IN_PLACE, ways.data(), 2, MPI_INT, MPI_SUM, comm_);
    name_ = ways[0] == 0   ? (ways[1] == 0 ? "message" : "window")
            : ways[1] == 0 ? "message"
                           : "mixed";
    if (mode != ChannelMode::kWindow || ways[0] == 0) return "";
    return window ? "channel window: not all processes are on one node"
                  : "channel window: this MPI gives processes no common memory";
  }

  void close() {
    if (comm_ == MPI_COMM_NULL) return;
    int status = kFine;
    for (std::size_t k = 0; k < ports_.size(); ++k)  // what others still wait for gets there
      wait(ports_[k].request, kMessages[k].target, status);
    if (window_ != MPI_WIN_NULL) {
      MPI_Win_unlock_all(window_);
      MPI_Win_free(&window_);
    }
    if (node_ != MPI_COMM_NULL) MPI_Comm_free(&node_);
    MPI_Comm_free(&comm_);
  }

  // Where to write message k. Waits for an MPI message that is still under way.
  Number* outgoing(int k, int& status) {
    Port& port = ports_[k];
    if (port.slots) return port.slot(port.count + 1, k).content() + 1;
    wait(port.request, kMessages[k].target, status);
    return port.buffer.data() + 1;
  }

  void send(int k, int& status) {
    if (take_) {
      if (take_->playing()) return void(take_->pass());
      take_->note(k);
    }
    Port& port = ports_[k];
    if (port.slots) {
      Slot& slot = port.slot(++port.count, k);
      slot.content()[0] = static_cast<Number>(status);
      slot.number.store(port.count, std::memory_order_release);
      return;
    }
    port.buffer[0] = static_cast<Number>(status);
    MPI_Isend(port.buffer.data(), static_cast<int>(port.buffer.size()), kMpiNumber,
              kMessages[k].target, k, comm_, &port.request);
  }

  // Waits for message k, patient: however long it takes, and returns its content; what its source
  // knows of failures joins the status.
  const Number* receive(int k, int& status, bool patient = false) {
    if (take_ && take_->playing()) return opened(take_->pass(), status);
    Port& port = ports_[k];
    const Number* content;
    if (port.slots) {
      const std::uint64_t number = ++port.count;
      Slot& slot = port.slot(number, k);
      const auto is_there = [&] { return slot.number.load(std::memory_order_acquire) >= number; };
      if (!wait_until(is_there, patient)) fail(status, failure(kNoAnswer, kMessages[k].source));
      content = slot.content();
    } else {
      MPI_Irecv(port.buffer.data(), static_cast<int>(port.buffer.size()), kMpiNumber,
                kMessages[k].source, k, comm_, &port.request);
      wait(port.request, kMessages[k].source, status, [](const MPI_Status&) {}, patient);
      content = port.buffer.data();
    }
    if (take_) take_->note(k, content);
    return opened(content, status);
  }

  // Notes from here on what is sent and received, or plays it; null for neither.
  void use(Take* take) { take_ = take; }

  // Waits until a peer has done its part; then tells done of it. What never comes is given up.
  template <class Done>
  void wait(MPI_Request& request, int peer, int& status, Done done, bool patient = false) {
    if (request == MPI_REQUEST_NULL) return;
    MPI_Status found;
    const auto is_done = [&] {
      int flag = 0;
      MPI_Test(&request, &flag, &found);
      return flag != 0;
    };
    const bool in_time = wait_until(is_done, patient);
    if (in_time) return done(found);
    give_up(request);
    fail(status, failure(kNoAnswer, peer));
  }
  void wait(MPI_Request& request, int peer, int& status) {
    wait(request, peer, status, [](const MPI_Status&) {});
  }

  // To a process that has no part in evaluations: they are over. And there: waits for that, asleep.
  void send_end(int target) { MPI_Send(nullptr, 0, kMpiNumber, target, kEndTag, comm_); }
  void await_end() {
    MPI_Request over;
    MPI_Irecv(nullptr, 0, kMpiNumber, 0, kEndTag, comm_, &over);
    for (int done = 0; MPI_Test(&over, &done, MPI_STATUS_IGNORE), !done;)
      std::this_thread::sleep_for(std::chrono::milliseconds(1));
  }

  static void give_up(MPI_Request& request) {
    if (request != MPI_REQUEST_NULL) MPI_Cancel(&request), MPI_Request_free(&request);
  }

  static void fail(int& status, int failure) {
    if (status == kFine) status = failure;
  }

  MPI_Comm comm() const { return comm_; }
  int rank() const { return rank_; }
  bool broken() const { return broken_; }
  bool windowed() const { return window_ != MPI_WIN_NULL; }
  bool on_one_host() const { return on_one_host_; }
  const char* name() const { return name_; }

 private:
  using Clock = std::chrono::steady_clock;
  // Behind those of all other messages, in batches, too.
  static constexpr int kEndTag = static_cast<int>(kMessages.size()) + 3;
  static constexpr std::chrono::milliseconds kPatience{100};

  struct alignas(kCacheLine) Slot {
    std::atomic<std::uint64_t> number;
    Number* content() {
      return reinterpret_cast<Number*>(reinterpret_cast<char*>(this) + kCacheLine);
    }
  };

  struct Port {
    char* slots = nullptr;
    std::uint64_t count = 0;
    Slot& slot(std::uint64_t number, int k) const {
      return *reinterpret_cast<Slot*>(slots + (number & 1) * slot_bytes(kMessages[k]));
    }
    std::vector<Number> buffer;
    MPI_Request request = MPI_REQUEST_NULL;
  };

  static const Number* opened(const Number* content, int& status) {
    if (failure_kind(status) != kNoAnswer) fail(status, static_cast<int>(content[0]));
    return content + 1;
  }

  static std::size_t slot_bytes(const MessageInfo& info) {
    const std::size_t content = (static_cast<std::size_t>(info.size) + 1) * sizeof(Number);
    return kCacheLine + (content + kCacheLine - 1) / kCacheLine * kCacheLine;
  }

  void find_node(int hosts) {
    MPI_Comm real;
    MPI_Comm_split_type(comm_, MPI_COMM_TYPE_SHARED, 0, MPI_INFO_NULL, &real);
    MPI_Comm_split(real, rank_ * hosts / kProcesses, 0, &node_);
    MPI_Comm_free(&real);
    int size = 0;
    MPI_Comm_size(node_, &size);
    on_one_host_ = size == kProcesses;
  }

  // Each process holds the slots of the messages that it sends to processes on its node. Returns
  // whether there was memory to share.
  bool open_window() {
    std::vector<int> on_node(kProcesses, MPI_UNDEFINED), all(kProcesses);
    for (int p = 0; p < kProcesses; ++p) all[p] = p;
    MPI_Group whole, near;
    MPI_Comm_group(comm_, &whole);
    MPI_Comm_group(node_, &near);
    MPI_Group_translate_ranks(whole, kProcesses, all.data(), near, on_node.data());
    MPI_Group_free(&whole);
    MPI_Group_free(&near);
    const auto near_pair = [&](const MessageInfo& info) {
      return info.size > 0 && on_node[info.source] != MPI_UNDEFINED &&
             on_node[info.target] != MPI_UNDEFINED;
    };
    if (std::none_of(kMessages.begin(), kMessages.end(), near_pair)) return true;
    std::size_t own = 0;
    for (const MessageInfo& info : kMessages)
      if (info.source == rank_ && near_pair(info)) own += 2 * slot_bytes(info);
    if (!share_memory(own)) return false;
    std::vector<char*> next(kProcesses, nullptr);
    for (int p = 0; p < kProcesses; ++p) {
      if (on_node[p] == MPI_UNDEFINED) continue;
      MPI_Aint bytes;
      int unit;
      MPI_Win_shared_query(window_, on_node[p], &bytes, &unit, &next[p]);
    }
    for (std::size_t k = 0; k < ports_.size(); ++k) {
      const MessageInfo& info = kMessages[k];
      if (!near_pair(info)) continue;
      ports_[k].slots = next[info.source];
      next[info.source] += 2 * slot_bytes(info);
      if (info.source == rank_) {
        std::memset(ports_[k].slots, 0, 2 * slot_bytes(info));  // first touch
        for (std::uint64_t n : {0, 1}) new (&ports_[k].slot(n, static_cast<int>(k))) Slot{};
      }
    }
    MPI_Win_sync(window_);
    MPI_Barrier(node_);
    MPI_Win_sync(window_);
    return true;
  }

  // Returns whether all processes of the node could.
  bool share_memory(std::size_t own) {
    char* base = nullptr;
    MPI_Info hints;
    MPI_Info_create(&hints);
    MPI_Info_set(hints, "alloc_shared_noncontig",
                 "true");  // every part on pages of its own process
    MPI_Comm_set_errhandler(node_, MPI_ERRORS_RETURN);
    int good = MPI_Win_allocate_shared(static_cast<MPI_Aint>(own), 1, hints, node_, &base,
                                       &window_) == MPI_SUCCESS;
    MPI_Comm_set_errhandler(node_, MPI_ERRORS_ARE_FATAL);
    MPI_Info_free(&hints);
    MPI_Allreduce(MPI_IN_PLACE, &good, 1, MPI_INT, MPI_MIN, node_);
    if (good != 0)
      MPI_Win_lock_all(MPI_MODE_NOCHECK, window_);
    else
      window_ = MPI_WIN_NULL;
    return good != 0;
  }

  // Spins briefly, then yields, so that more processes than cores still finish. Who waits without
  // limit sleeps between looks once it has waited for long.
  template <class Ready>
  bool wait_until(Ready ready, bool patient) {
    for (int k = 0; k < 4000; ++k) {
      if (ready()) return true;
      relax();
    }
    if (broken_) return false;  // a peer is gone: do not wait for it once more
    const Clock::time_point end =
        Clock::now() + (patient ? Clock::duration(kPatience) : time_limit_);
    while (!ready()) {
      std::this_thread::yield();
      if (Clock::now() <= end) continue;
      if (patient) {
        std::this_thread::sleep_for(std::chrono::microseconds(50));
      } else {
        broken_ = true;
        return false;
      }
    }
    return true;
  }

  MPI_Comm comm_ = MPI_COMM_NULL, node_ = MPI_COMM_NULL;
  MPI_Win window_ = MPI_WIN_NULL;
  int rank_ = 0;
  Clock::duration time_limit_{};
  bool broken_ = false, on_one_host_ = true;
  Take* take_ = nullptr;
  const char* name_ = "message";
  std::vector<Port> ports_;
};

// Time stamps between the stages of a process's work (--trace); nothing is stamped otherwise.
std::chrono::steady_clock::rep* trace_stamps =
    nullptr;  // where an evaluation puts them: its start, then each end

[[maybe_unused]] inline void stamp(int k) {
  if (trace_stamps) trace_stamps[k] = std::chrono::steady_clock::now().time_since_epoch().count();
}

// ---- 4. joints ----------------------------------------------------------------------------------

// The memory of a process. Whatever belongs to a joint is kept with it.
struct Workspace;

struct Joint_base {
  Transform X;  // parent link's to child link's frame
  Vec6 v;  // velocity of link "pelvis"
  Columns6 b;  // bias of the bare link "pelvis"
  Mat6 Phi_pelvis;  // of the chain it completes
  Columns6 b_pelvis;
  Joined<Floating> joined;
  Coupled<Floating> at_pelvis;
  Columns6 F_on_pelvis;  // outer wrench on that chain
};

struct Joint_left_hip_pitch {
  Transform X;  // parent link's to child link's frame
  Vec6 v;  // velocity of link "left_hip"
  Columns6 b;  // bias of the bare link "left_hip"
  Mat6 Phi_pelvis;  // of the chain it completes
  Columns6 b_pelvis;
  Joined<Revolute> joined;
  Coupled<Revolute> at_pelvis;
  Columns6 F_on_pelvis;  // outer wrench on that chain
};

struct Joint_left_hip_roll {
  Transform X;  // parent link's to child link's frame
  Vec6 v;  // velocity of link "left_groin"
  Columns6 b;  // bias of the bare link "left_groin"
  Mat6 Phi_left_hip;  // of the chain it completes
  Columns6 b_left_hip;
  Joined<Revolute> joined;
  Coupled<Revolute> at_left_hip;
  Columns6 F_on_left_hip;  // outer wrench on that chain
};

struct Joint_left_hip_yaw {
  Transform X;  // parent link's to child link's frame
  Vec6 v;  // velocity of link "left_thigh"
  Columns6 b;  // bias of the bare link "left_thigh"
  Mat6 Phi_left_groin;  // of the chain it completes
  Columns6 b_left_groin;
  Joined<Revolute> joined;
  Coupled<Revolute> at_left_groin;
  Columns6 F_on_left_groin;  // outer wrench on that chain
};

struct Joint_left_knee {
  Transform X;  // parent link's to child link's frame
  Vec6 v;  // velocity of link "left_shank"
  Columns6 b;  // bias of the bare link "left_shank"
  Mat6 Phi_left_thigh;  // of the chain it completes
  Columns6 b_left_thigh;
  Joined<Revolute> joined;
  Coupled<Revolute> at_left_thigh;
  Columns6 F_on_left_thigh;  // outer wrench on that chain
};

struct Joint_left_ankle_pitch {
  Transform X;  // parent link's to child link's frame
  Vec6 v;  // velocity of link "left_ankle"
  Columns6 b;  // bias of the bare link "left_ankle"
  Mat6 Phi_left_shank;  // of the chain it completes
  Columns6 b_left_shank;
  Joined<Revolute> joined;
  Coupled<Revolute> at_left_shank;
  Columns6 F_on_left_shank;  // outer wrench on that chain
};

struct Joint_left_ankle_roll {
  Transform X;  // parent link's to child link's frame
  Vec6 v;  // velocity of link "left_foot"
  Columns6 b;  // bias of the bare link "left_foot"
  Mat6 Phi_left_ankle;  // of the chain it completes
  Columns6 b_left_ankle;
  Joined<Revolute> joined;
  Coupled<Revolute> at_left_ankle;
  Columns6 F_on_left_ankle;  // outer wrench on that chain
};

struct Joint_right_hip_pitch {
  Transform X;  // parent link's to child link's frame
  Vec6 v;  // velocity of link "right_hip"
  Columns6 b;  // bias of the bare link "right_hip"
  Mat6 Phi_pelvis;  // of the chain it completes
  Columns6 b_pelvis;
  Joined<Revolute> joined;
  Coupled<Revolute> at_pelvis;
  Columns6 F_on_pelvis;  // outer wrench on that chain
};

struct Joint_right_hip_roll {
  Transform X;  // parent link's to child link's frame
  Vec6 v;  // velocity of link "right_groin"
  Columns6 b;  // bias of the bare link "right_groin"
  Mat6 Phi_right_hip;  // of the chain it completes
  Columns6 b_right_hip;
  Joined<Revolute> joined;
  Coupled<Revolute> at_right_hip;
  Columns6 F_on_right_hip;  // outer wrench on that chain
};

struct Joint_right_hip_yaw {
  Transform X;  // parent link's to child link's frame
  Vec6 v;  // velocity of link "right_thigh"
  Columns6 b;  // bias of the bare link "right_thigh"
  Mat6 Phi_right_groin;  // of the chain it completes
  Columns6 b_right_groin;
  Joined<Revolute> joined;
  Coupled<Revolute> at_right_groin;
  Columns6 F_on_right_groin;  // outer wrench on that chain
};

struct Joint_right_knee {
  Transform X;  // parent link's to child link's frame
  Vec6 v;  // velocity of link "right_shank"
  Columns6 b;  // bias of the bare link "right_shank"
  Mat6 Phi_right_thigh;  // of the chain it completes
  Columns6 b_right_thigh;
  Joined<Revolute> joined;
  Coupled<Revolute> at_right_thigh;
  Columns6 F_on_right_thigh;  // outer wrench on that chain
};

struct Joint_right_ankle_pitch {
  Transform X;  // parent link's to child link's frame
  Vec6 v;  // velocity of link "right_ankle"
  Columns6 b;  // bias of the bare link "right_ankle"
  Mat6 Phi_right_shank;  // of the chain it completes
  Columns6 b_right_shank;
  Joined<Revolute> joined;
  Coupled<Revolute> at_right_shank;
  Columns6 F_on_right_shank;  // outer wrench on that chain
};

struct Joint_right_ankle_roll {
  Transform X;  // parent link's to child link's frame
  Vec6 v;  // velocity of link "right_foot"
  Columns6 b;  // bias of the bare link "right_foot"
  Mat6 Phi_right_ankle;  // of the chain it completes
  Columns6 b_right_ankle;
  Joined<Revolute> joined;
  Coupled<Revolute> at_right_ankle;
  Columns6 F_on_right_ankle;  // outer wrench on that chain
};

struct Joint_waist_yaw {
  Transform X;  // parent link's to child link's frame
  Vec6 v;  // velocity of link "waist_link"
  Joined<Revolute> joined;
  Columns6 b;  // bias of the bare link "waist_link"
};

struct Joint_waist_roll {
  Transform X;  // parent link's to child link's frame
  Vec6 v;  // velocity of link "abdomen"
  Columns6 b;  // bias of the bare link "abdomen"
  Mat6 Phi_waist_link;  // of the chain it completes
  Columns6 b_waist_link;
  Joined<Revolute> joined;
  Coupled<Revolute> at_waist_link;
  Columns6 F_on_waist_link;  // outer wrench on that chain
};

struct Joint_waist_pitch {
  Transform X;  // parent link's to child link's frame
  Vec6 v;  // velocity of link "torso"
  Columns6 b;  // bias of the bare link "torso"
  Mat6 Phi_abdomen;  // of the chain it completes
  Columns6 b_abdomen;
  Joined<Revolute> joined;
  Coupled<Revolute> at_abdomen;
  Columns6 F_on_abdomen;  // outer wrench on that chain
};

struct Joint_left_shoulder_pitch {
  Transform X;  // parent link's to child link's frame
  Vec6 v;  // velocity of link "left_shoulder"
  Mat6 Phi_torso;  // of the chain it completes
  Columns6 b_torso;
  Joined<Revolute> joined;
  Coupled<Revolute> at_torso;
  Columns6 b;  // bias of the bare link "left_shoulder"
  Columns6 F_on_torso;  // outer wrench on that chain
};

struct Joint_left_shoulder_roll {
  Transform X;  // parent link's to child link's frame
  Vec6 v;  // velocity of link "left_shoulder_cap"
  Columns6 b;  // bias of the bare link "left_shoulder_cap"
  Mat6 Phi_left_shoulder;  // of the chain it completes
  Columns6 b_left_shoulder;
  Joined<Revolute> joined;
  Coupled<Revolute> at_left_shoulder;
  Columns6 F_on_left_shoulder;  // outer wrench on that chain
};

struct Joint_left_shoulder_yaw {
  Transform X;  // parent link's to child link's frame
  Vec6 v;  // velocity of link "left_upper_arm"
  Columns6 b;  // bias of the bare link "left_upper_arm"
  Mat6 Phi_left_shoulder_cap;  // of the chain it completes
  Columns6 b_left_shoulder_cap;
  Joined<Revolute> joined;
  Coupled<Revolute> at_left_shoulder_cap;
  Columns6 F_on_left_shoulder_cap;  // outer wrench on that chain
};

struct Joint_left_elbow {
  Transform X;  // parent link's to child link's frame
  Vec6 v;  // velocity of link "left_forearm"
  Columns6 b;  // bias of the bare link "left_forearm"
  Mat6 Phi_left_upper_arm;  // of the chain it completes
  Columns6 b_left_upper_arm;
  Joined<Revolute> joined;
  Coupled<Revolute> at_left_upper_arm;
  Columns6 F_on_left_upper_arm;  // outer wrench on that chain
};

struct Joint_left_wrist_roll {
  Transform X;  // parent link's to child link's frame
  Vec6 v;  // velocity of link "left_wrist"
  Columns6 b;  // bias of the bare link "left_wrist"
  Mat6 Phi_left_forearm;  // of the chain it completes
  Columns6 b_left_forearm;
  Joined<Revolute> joined;
  Coupled<Revolute> at_left_forearm;
  Columns6 F_on_left_forearm;  // outer wrench on that chain
};

struct Joint_left_wrist_pitch {
  Transform X;  // parent link's to child link's frame
  Vec6 v;  // velocity of link "left_hand"
  Columns6 b;  // bias of the bare link "left_hand"
  Mat6 Phi_left_wrist;  // of the chain it completes
  Columns6 b_left_wrist;
  Joined<Revolute> joined;
  Coupled<Revolute> at_left_wrist;
  Columns6 F_on_left_wrist;  // outer wrench on that chain
};

struct Joint_neck_yaw {
  Transform X;  // parent link's to child link's frame
  Vec6 v;  // velocity of link "neck"
  Columns6 b;  // bias of the bare link "neck"
  Mat6 Phi_torso;  // of the chain it completes
  Columns6 b_torso;
  Joined<Revolute> joined;
  Coupled<Revolute> at_torso;
  Columns6 F_on_torso;  // outer wrench on that chain
};

struct Joint_neck_pitch {
  Transform X;  // parent link's to child link's frame
  Vec6 v;  // velocity of link "head"
  Columns6 b;  // bias of the bare link "head"
  Mat6 Phi_neck;  // of the chain it completes
  Columns6 b_neck;
  Joined<Revolute> joined;
  Coupled<Revolute> at_neck;
  Columns6 F_on_neck;  // outer wrench on that chain
};

struct Joint_right_shoulder_pitch {
  Transform X;  // parent link's to child link's frame
  Vec6 v;  // velocity of link "right_shoulder"
  Columns6 b;  // bias of the bare link "right_shoulder"
  Mat6 Phi_torso;  // of the chain it completes
  Columns6 b_torso;
  Joined<Revolute> joined;
  Coupled<Revolute> at_torso;
  Columns6 F_on_torso;  // outer wrench on that chain
};

struct Joint_right_shoulder_roll {
  Transform X;  // parent link's to child link's frame
  Vec6 v;  // velocity of link "right_shoulder_cap"
  Columns6 b;  // bias of the bare link "right_shoulder_cap"
  Mat6 Phi_right_shoulder;  // of the chain it completes
  Columns6 b_right_shoulder;
  Joined<Revolute> joined;
  Coupled<Revolute> at_right_shoulder;
  Columns6 F_on_right_shoulder;  // outer wrench on that chain
};

struct Joint_right_shoulder_yaw {
  Transform X;  // parent link's to child link's frame
  Vec6 v;  // velocity of link "right_upper_arm"
  Columns6 b;  // bias of the bare link "right_upper_arm"
  Mat6 Phi_right_shoulder_cap;  // of the chain it completes
  Columns6 b_right_shoulder_cap;
  Joined<Revolute> joined;
  Coupled<Revolute> at_right_shoulder_cap;
  Columns6 F_on_right_shoulder_cap;  // outer wrench on that chain
};

struct Joint_right_elbow {
  Transform X;  // parent link's to child link's frame
  Vec6 v;  // velocity of link "right_forearm"
  Columns6 b;  // bias of the bare link "right_forearm"
  Mat6 Phi_right_upper_arm;  // of the chain it completes
  Columns6 b_right_upper_arm;
  Joined<Revolute> joined;
  Coupled<Revolute> at_right_upper_arm;
  Columns6 F_on_right_upper_arm;  // outer wrench on that chain
};

struct Joint_right_wrist_roll {
  Transform X;  // parent link's to child link's frame
  Vec6 v;  // velocity of link "right_wrist"
  Columns6 b;  // bias of the bare link "right_wrist"
  Mat6 Phi_right_forearm;  // of the chain it completes
  Columns6 b_right_forearm;
  Joined<Revolute> joined;
  Coupled<Revolute> at_right_forearm;
  Columns6 F_on_right_forearm;  // outer wrench on that chain
};

struct Joint_right_wrist_pitch {
  Transform X;  // parent link's to child link's frame
  Vec6 v;  // velocity of link "right_hand"
  Columns6 b;  // bias of the bare link "right_hand"
  Mat6 Phi_right_wrist;  // of the chain it completes
  Columns6 b_right_wrist;
  Joined<Revolute> joined;
  Coupled<Revolute> at_right_wrist;
  Columns6 F_on_right_wrist;  // outer wrench on that chain
};

struct Workspace {
  const Number* q = nullptr;
  const Number* v = nullptr;
  const Number* tau = nullptr;
  Number* qdd = nullptr;
  int status = kFine;
  int near_lock = 0;  // 1 + the last joint of a run that has been near gimbal lock; 0: none
  Columns6 ground;  // its acceleration
  Joint_base j_base;
  Joint_left_hip_pitch j_left_hip_pitch;
  Joint_left_hip_roll j_left_hip_roll;
  Joint_left_hip_yaw j_left_hip_yaw;
  Joint_left_knee j_left_knee;
  Joint_left_ankle_pitch j_left_ankle_pitch;
  Joint_left_ankle_roll j_left_ankle_roll;
  Joint_right_hip_pitch j_right_hip_pitch;
  Joint_right_hip_roll j_right_hip_roll;
  Joint_right_hip_yaw j_right_hip_yaw;
  Joint_right_knee j_right_knee;
  Joint_right_ankle_pitch j_right_ankle_pitch;
  Joint_right_ankle_roll j_right_ankle_roll;
  Joint_waist_yaw j_waist_yaw;
  Joint_waist_roll j_waist_roll;
  Joint_waist_pitch j_waist_pitch;
  Joint_left_shoulder_pitch j_left_shoulder_pitch;
  Joint_left_shoulder_roll j_left_shoulder_roll;
  Joint_left_shoulder_yaw j_left_shoulder_yaw;
  Joint_left_elbow j_left_elbow;
  Joint_left_wrist_roll j_left_wrist_roll;
  Joint_left_wrist_pitch j_left_wrist_pitch;
  Joint_neck_yaw j_neck_yaw;
  Joint_neck_pitch j_neck_pitch;
  Joint_right_shoulder_pitch j_right_shoulder_pitch;
  Joint_right_shoulder_roll j_right_shoulder_roll;
  Joint_right_shoulder_yaw j_right_shoulder_yaw;
  Joint_right_elbow j_right_elbow;
  Joint_right_wrist_roll j_right_wrist_roll;
  Joint_right_wrist_pitch j_right_wrist_pitch;

  EIGEN_MAKE_ALIGNED_OPERATOR_NEW
};

inline double gravity(const Workspace&, int k) { return kGravity[static_cast<std::size_t>(k)]; }

inline void fail(Workspace& w, Failure kind, int joint) {
  Channel::fail(w.status, failure(kind, joint));
}

// x - x is zero for finite x only.
inline void require_finite(Workspace& w, const Number* x, int count, int joint) {
  Number sum = 0;
  for (int k = 0; k < count; ++k) sum += x[k] - x[k];
  if (!(sum == 0)) fail(w, kNotFinite, joint);
}

[[maybe_unused]] inline void require_length(Workspace& w, Real squared, int joint) {
  if (!(squared >= std::numeric_limits<Real>::min() && squared <= std::numeric_limits<Real>::max()))
    fail(w, kZeroQuaternion, joint);
}

template <std::size_t n>
void load_torque(Workspace& w, int joint, int v, std::array<std::array<Real, kColumns>, n>& tau) {
  require_finite(w, w.tau + v, static_cast<int>(n), joint);
  for (std::size_t k = 0; k < n; ++k) {
    tau[k] = {};
    tau[k][0] = Real(w.tau[v + static_cast<int>(k)]);
  }
}

// An acceleration is given only where all went well.
template <std::size_t n>
void store_acceleration(Workspace& w, int joint, int v,
                        const std::array<std::array<Real, kColumns>, n>& qdd) {
  Real sum = 0;
  for (std::size_t k = 0; k < n; ++k) sum += qdd[k][0] - qdd[k][0];
  if (!(sum == 0)) fail(w, kOverflow, joint);
  if (w.status != kFine) return;
  for (std::size_t k = 0; k < n; ++k) w.qdd[v + static_cast<int>(k)] = qdd[k][0];
}

const Mat6 kZero = Mat6::Zero();

// The ground accelerates against gravity: all accelerations are relative to free fall.
[[maybe_unused]] inline Columns6 ground(const Workspace& w) {
  Columns6 result = Columns6::Zero();
  for (int k = 0; k < 3; ++k) result(3 + k, 0) = -Real(gravity(w, k));
  return result;
}

// Accelerations of all right-hand sides, added up with the coupling torques.
template <std::size_t n, std::size_t m>
void store_coupled(Workspace& w, int joint, int v,
                   const std::array<std::array<Real, kColumns>, n>& qdd,
                   const std::array<Real, m>& torques) {
  std::array<std::array<Real, kColumns>, n> sum{};
  for (std::size_t k = 0; k < n; ++k) {
    sum[k][0] = qdd[k][0];
    for (std::size_t c = 0; c < m; ++c) sum[k][0] += qdd[k][c + 1] * torques[c];
  }
  store_acceleration(w, joint, v, sum);
}

// What goes into a message, and out of one.
template <class M>
Number* put(Number* to, const M& m) {
  Eigen::Map<Eigen::Matrix<Number, M::RowsAtCompileTime, M::ColsAtCompileTime>>{to} =
      m.template cast<Number>();
  return to + M::SizeAtCompileTime;
}

template <class M>
const Number* get(const Number* from, M& m) {
  using Content = Eigen::Matrix<Number, M::RowsAtCompileTime, M::ColsAtCompileTime>;
  m = Eigen::Map<const Content>(from).template cast<Real>();
  return from + M::SizeAtCompileTime;
}

template <std::size_t n>
Number* put(Number* to, const std::array<Real, n>& x) {
  return std::copy(x.begin(), x.end(), to);
}

template <std::size_t n>
const Number* get(const Number* from, std::array<Real, n>& x) {
  std::transform(from, from + n, x.begin(), [](Number value) { return Real(value); });
  return from + n;
}

const Mat6 kPhi_pelvis = symmetric({30.819775200559686, 0.0, 0.0, 0.0, 0.6163955040111937, 0.0, 56.92588818617042, 0.0, -1.1385177637234085, 0.0, 0.0, 28.463025107234447, 0.0, 0.0, 0.0, 0.18406067785511332, 0.0, 0.0, 0.17361823266086904, 0.0, 0.16129032258064516});
const Mat6 kPhi_left_hip = symmetric({549.4505494505495, 0.0, 0.0, 0.0, 16.483516483516482, 0.0, 549.4505494505495, 0.0, -16.483516483516482, 0.0, 0.0, 571.4285714285714, 0.0, 0.0, 0.0, 1.2087912087912087, 0.0, 0.0, 1.2087912087912087, 0.0, 0.7142857142857143});
const Mat6 kPhi_left_groin = symmetric({719.4244604316547, 0.0, 0.0, 0.0, 14.388489208633095, 28.77697841726619, 719.4244604316547, 0.0, -14.388489208633095, 0.0, 0.0, 666.6666666666666, -26.666666666666668, 0.0, 0.0, 2.1877697841726618, 0.0, 0.0, 1.1211031175059953, 0.5755395683453238, 1.984412470023981});
const Mat6 kPhi_left_thigh = symmetric({58.86958620567856, 0.0, 0.0, 0.0, -5.886958620567857, 0.0, 58.86958620567856, 0.0, 5.886958620567857, 0.0, 0.0, 213.67521367521366, 0.0, 0.0, 0.0, 0.9733112466721703, 0.0, 0.0, 0.9733112466721703, 0.0, 0.3846153846153846});
const Mat6 kPhi_left_shank = symmetric({548.6968449931413, 0.0, 0.0, 0.0, 0.0, -5.486968449931413, 78.91850086415758, 0.0, 0.0, 0.0, -10.259405112340486, 78.91850086415758, 0.7891850086415758, 10.259405112340486, 0.0, 0.5634474056419713, 0.10259405112340486, 0.0, 1.8892782201598188, 0.0, 1.944147904659133});
const Mat6 kPhi_left_ankle = symmetric({13888.888888888889, 0.0, 0.0, 0.0, 0.0, 0.0, 13888.888888888889, 0.0, 0.0, 0.0, 0.0, 13888.888888888889, 0.0, 0.0, 0.0, 5.0, 0.0, 0.0, 5.0, 0.0, 5.0});
const Mat6 kPhi_left_foot = symmetric({366.7477179123253, 0.0, 0.0, 0.0, 11.002431537369759, 11.002431537369759, 323.2762104269509, 0.0, -9.698286312808527, 0.0, 0.0, 2054.793113155402, -61.64379339466206, 0.0, 0.0, 3.3902623912241174, 0.0, 0.0, 1.5800729461210927, 0.3300729461210927, 1.5800729461210927});
const Mat6 kPhi_right_hip = symmetric({549.4505494505495, 0.0, 0.0, 0.0, -16.483516483516482, 0.0, 549.4505494505495, 0.0, 16.483516483516482, 0.0, 0.0, 571.4285714285714, 0.0, 0.0, 0.0, 1.2087912087912087, 0.0, 0.0, 1.2087912087912087, 0.0, 0.7142857142857143});
const Mat6 kPhi_right_groin = symmetric({719.4244604316547, 0.0, 0.0, 0.0, 14.388489208633095, 28.77697841726619, 719.4244604316547, 0.0, -14.388489208633095, 0.0, 0.0, 666.6666666666666, -26.666666666666668, 0.0, 0.0, 2.1877697841726618, 0.0, 0.0, 1.1211031175059953, 0.5755395683453238, 1.984412470023981});
const Mat6 kPhi_right_thigh = symmetric({58.86958620567856, 0.0, 0.0, 0.0, -5.886958620567857, 0.0, 58.86958620567856, 0.0, 5.886958620567857, 0.0, 0.0, 213.67521367521366, 0.0, 0.0, 0.0, 0.9733112466721703, 0.0, 0.0, 0.9733112466721703, 0.0, 0.3846153846153846});
const Mat6 kPhi_right_shank = symmetric({548.6968449931413, 0.0, 0.0, 0.0, 0.0, -5.486968449931413, 78.91850086415758, 0.0, 0.0, 0.0, -10.259405112340486, 78.91850086415758, 0.7891850086415758, 10.259405112340486, 0.0, 0.5634474056419713, 0.10259405112340486, 0.0, 1.8892782201598188, 0.0, 1.944147904659133});
const Mat6 kPhi_right_ankle = symmetric({13888.888888888889, 0.0, 0.0, 0.0, 0.0, 0.0, 13888.888888888889, 0.0, 0.0, 0.0, 0.0, 13888.888888888889, 0.0, 0.0, 0.0, 5.0, 0.0, 0.0, 5.0, 0.0, 5.0});
const Mat6 kPhi_right_foot = symmetric({366.7477179123253, 0.0, 0.0, 0.0, 11.002431537369759, 11.002431537369759, 323.2762104269509, 0.0, -9.698286312808527, 0.0, 0.0, 2054.793113155402, -61.64379339466206, 0.0, 0.0, 3.3902623912241174, 0.0, 0.0, 1.5800729461210927, 0.3300729461210927, 1.5800729461210927});
const Mat6 kPhi_waist_link = symmetric({1351.3513513513515, 0.0, 0.0, 0.0, 27.027027027027028, 0.0, 1351.3513513513515, 0.0, -27.027027027027028, 0.0, 0.0, 1000.0, 0.0, 0.0, 0.0, 1.7905405405405406, 0.0, 0.0, 1.7905405405405406, 0.0, 1.25});
const Mat6 kPhi_abdomen = symmetric({959.2326139088728, 0.0, 0.0, 0.0, 0.0, -19.18465227817746, 888.8888888888889, 0.0, 0.0, 0.0, 0.0, 959.2326139088728, 19.18465227817746, 0.0, 0.0, 1.4948041566746602, 0.0, 0.0, 1.1111111111111112, 0.0, 1.4948041566746602});
const Mat6 kPhi_torso = symmetric({12.145753905163525, 0.0, 0.0, 0.0, 0.0, -0.12145753905163525, 6.511137300352253, 0.0, 0.0, 0.0, 1.1068933410598831, 8.945904117799666, 0.08945904117799666, -1.5208037000259433, 0.0, 0.10615774830651681, -0.015208037000259434, 0.0, 0.3637997868991472, 0.0, 0.2946496012654333});
const Mat6 kPhi_left_shoulder = symmetric({1546.3909554685797, 0.0, 0.0, 0.0, 46.39172866405739, 0.0, 1546.3909554685797, 0.0, -46.39172866405739, 0.0, 0.0, 1562.4999999999998, 0.0, 0.0, 0.0, 2.6417518599217216, 0.0, 0.0, 2.6417518599217216, 0.0, 1.25});
const Mat6 kPhi_left_shoulder_cap = symmetric({1428.5714285714287, 0.0, 0.0, 0.0, 0.0, 42.857142857142854, 1428.5714285714287, 0.0, 0.0, 0.0, 14.285714285714286, 1428.5714285714287, -42.857142857142854, -14.285714285714286, 0.0, 2.7142857142857144, 0.42857142857142855, 0.0, 1.5714285714285716, 0.0, 2.857142857142857});
const Mat6 kPhi_left_upper_arm = symmetric({614.7528386212323, 0.0, 0.0, 0.0, -30.737641931061617, 0.0, 614.7528386212323, 0.0, 30.737641931061617, 0.0, 0.0, 1562.4999999999998, 0.0, 0.0, 0.0, 2.786882096553081, 0.0, 0.0, 2.786882096553081, 0.0, 1.25});
const Mat6 kPhi_left_forearm = symmetric({2332.3615160349855, 0.0, 0.0, 0.0, 0.0, -46.64723032069971, 585.5795187707514, 0.0, 0.0, 0.0, -40.990566313952606, 585.5795187707514, 11.71159037541503, 40.990566313952606, 0.0, 1.6628032360797294, 0.8198113262790521, 0.0, 4.297911070548111, 0.0, 5.230855676962106});
const Mat6 kPhi_left_wrist = symmetric({11538.457100593423, 0.0, 0.0, 0.0, -115.38457100593423, 0.0, 11538.457100593423, 0.0, 115.38457100593423, 0.0, 0.0, 11111.111111111111, 0.0, 0.0, 0.0, 6.1538457100593424, 0.0, 0.0, 6.1538457100593424, 0.0, 5.0});
const Mat6 kPhi_left_hand = symmetric({3370.7827294576073, 0.0, 0.0, 0.0, 0.0, 0.0, 1442.3083857251854, 0.0, 0.0, 0.0, -86.53850314351112, 1775.1489793780945, 0.0, 106.50893876268566, 0.0, 2.5, 0.0, 0.0, 8.89053632576114, 0.0, 7.6923101886106675});
const Mat6 kPhi_neck = symmetric({4761.9047619047615, 0.0, 0.0, 0.0, 95.23809523809524, 0.0, 4761.9047619047615, 0.0, -95.23809523809524, 0.0, 0.0, 5555.555555555556, 0.0, 0.0, 0.0, 4.404761904761904, 0.0, 0.0, 4.404761904761904, 0.0, 2.5});
const Mat6 kPhi_head = symmetric({128.6008230452675, 0.0, 0.0, 0.0, 0.0, -2.57201646090535, 128.6008230452675, 0.0, 0.0, 0.0, 11.574074074074074, 128.6008230452675, 2.57201646090535, -11.574074074074074, 0.0, 0.46810699588477367, -0.23148148148148148, 0.0, 1.4583333333333333, 0.0, 1.5097736625514402});
const Mat6 kPhi_right_shoulder = symmetric({1546.3909554685797, 0.0, 0.0, 0.0, -46.39172866405739, 0.0, 1546.3909554685797, 0.0, 46.39172866405739, 0.0, 0.0, 1562.4999999999998, 0.0, 0.0, 0.0, 2.6417518599217216, 0.0, 0.0, 2.6417518599217216, 0.0, 1.25});
const Mat6 kPhi_right_shoulder_cap = symmetric({1428.5714285714287, 0.0, 0.0, 0.0, 0.0, 42.857142857142854, 1428.5714285714287, 0.0, 0.0, 0.0, -14.285714285714286, 1428.5714285714287, -42.857142857142854, 14.285714285714286, 0.0, 2.7142857142857144, -0.42857142857142855, 0.0, 1.5714285714285716, 0.0, 2.857142857142857});
const Mat6 kPhi_right_upper_arm = symmetric({614.7528386212323, 0.0, 0.0, 0.0, -30.737641931061617, 0.0, 614.7528386212323, 0.0, 30.737641931061617, 0.0, 0.0, 1562.4999999999998, 0.0, 0.0, 0.0, 2.786882096553081, 0.0, 0.0, 2.786882096553081, 0.0, 1.25});
const Mat6 kPhi_right_forearm = symmetric({2332.3615160349855, 0.0, 0.0, 0.0, 0.0, -46.64723032069971, 585.5795187707514, 0.0, 0.0, 0.0, -40.990566313952606, 585.5795187707514, 11.71159037541503, 40.990566313952606, 0.0, 1.6628032360797294, 0.8198113262790521, 0.0, 4.297911070548111, 0.0, 5.230855676962106});
const Mat6 kPhi_right_wrist = symmetric({11538.457100593423, 0.0, 0.0, 0.0, -115.38457100593423, 0.0, 11538.457100593423, 0.0, 115.38457100593423, 0.0, 0.0, 11111.111111111111, 0.0, 0.0, 0.0, 6.1538457100593424, 0.0, 0.0, 6.1538457100593424, 0.0, 5.0});
const Mat6 kPhi_right_hand = symmetric({3370.7827294576073, 0.0, 0.0, 0.0, 0.0, 0.0, 1442.3083857251854, 0.0, 0.0, 0.0, -86.53850314351112, 1775.1489793780945, 0.0, 106.50893876268566, 0.0, 2.5, 0.0, 0.0, 8.89053632576114, 0.0, 7.6923101886106675});

// =================================================================================================
// Joint 0 "__base__": floating, between links "__world__" and "pelvis"
// =================================================================================================

void kinematics_base(Workspace& w) {
  auto& i = w.j_base;
  require_finite(w, w.q + 0, 7, 0);
  require_finite(w, w.v + 0, 6, 0);
  const Number* const q = w.q + 0;
  require_length(w, conjugate_rotation(q + 3, i.X.E), 0);
  i.X.r << q[0], q[1], q[2];
  i.v = joint_velocity<Floating>(w.v + 0);
}

// A: the ground "__world__"; B: the chain of "left_hip_pitch"; C feels the joint at "pelvis"
void assemble_base(Workspace& w) {
  auto& i = w.j_base;
  load_torque(w, 0, 0, i.joined.tau);
  const Columns6 c = Columns6::Zero();
  constexpr std::array<Real, 6> least{4.379753477303394e-13, 8.089655265475019e-13, 4.0448391455405566e-13, 2.615659551780614e-15, 2.4672634802537493e-15, 2.2920733411616134e-15};
  if (!keeps_digits<Floating>(kZero, w.j_left_hip_pitch.Phi_pelvis, least))
    fail(w, kGrowth, 0);
  if (!join(i.joined, kZero, w.j_left_hip_pitch.Phi_pelvis, i.X * w.ground, w.j_left_hip_pitch.b_pelvis, c))
    fail(w, kFactorization, 0);
  couple(i.joined, w.j_left_hip_pitch.Phi_pelvis, i.at_pelvis);
  i.Phi_pelvis = w.j_left_hip_pitch.Phi_pelvis - product(i.at_pelvis, i.at_pelvis);  // Eq. (4)
  i.b_pelvis = w.j_left_hip_pitch.b_pelvis + bias_change(i.joined, i.at_pelvis);  // Eq. (7)
}

void disassemble_base(Workspace& w) {
  auto& i = w.j_base;
  Release<Floating> release(i.joined);
  release.feel_B(i.at_pelvis, w.j_base.F_on_pelvis);
  const Columns6 f = release.force();  // Eq. (8), (10)
  store_acceleration(w, 0, 0, release.qdd());  // Eq. (9)
  w.j_left_hip_pitch.F_on_pelvis = w.j_base.F_on_pelvis + f;
}

// =================================================================================================
// Joint 1 "left_hip_pitch": revolute, between links "pelvis" and "left_hip"
// =================================================================================================

void kinematics_left_hip_pitch(Workspace& w) {
  auto& i = w.j_left_hip_pitch;
  require_finite(w, w.q + 7, 1, 1);
  require_finite(w, w.v + 6, 1, 1);
  const Real q = Real(w.q[7]);
  const Real c = std::cos(q), s = std::sin(q);
  i.X.E << s, 0.0, c,  //
      c, 0.0, -s,  //
      0.0, 1.0, 0.0;
  i.X.r << 0.0, 0.09, -0.05;
  i.v = i.X * w.j_base.v + joint_velocity<Revolute>(w.v + 6);
}

// A: the chain of "right_hip_pitch"; B: the chain of "left_hip_roll"; C feels the joint at "pelvis"
void assemble_left_hip_pitch(Workspace& w) {
  auto& i = w.j_left_hip_pitch;
  load_torque(w, 1, 6, i.joined.tau);
  const Mat6 X_Phi_A = i.X * w.j_right_hip_pitch.Phi_pelvis;
  const Mat6 Phi_A = from_right(X_Phi_A, i.X);
  const Columns6 c = velocity_product<Revolute>(i.v, w.v + 6);
  constexpr std::array<Real, 6> least{7.97506041035137e-12, 7.97506041035137e-12, 8.287386887608557e-12, 1.9470029590306893e-14, 1.9470029590306893e-14, 1.2442683852020187e-14};
  if (!keeps_digits<Revolute>(Phi_A, w.j_left_hip_roll.Phi_left_hip, least))
    fail(w, kGrowth, 1);
  if (!join(i.joined, Phi_A, w.j_left_hip_roll.Phi_left_hip, i.X * w.j_right_hip_pitch.b_pelvis, w.j_left_hip_roll.b_left_hip, c))
    fail(w, kFactorization, 1);
  couple(i.joined, X_Phi_A, i.at_pelvis);
  i.Phi_pelvis = w.j_right_hip_pitch.Phi_pelvis - product(i.at_pelvis, i.at_pelvis);  // Eq. (3)
  i.b_pelvis = w.j_right_hip_pitch.b_pelvis - bias_change(i.joined, i.at_pelvis);  // Eq. (6)
}

void disassemble_left_hip_pitch(Workspace& w) {
  auto& i = w.j_left_hip_pitch;
  Release<Revolute> release(i.joined);
  release.feel_A(i.at_pelvis, w.j_left_hip_pitch.F_on_pelvis);
  const Columns6 f = release.force();  // Eq. (8), (10)
  store_acceleration(w, 1, 6, release.qdd());  // Eq. (9)
  w.j_right_hip_pitch.F_on_pelvis = w.j_left_hip_pitch.F_on_pelvis - i.X.transposed_times(f);
  w.j_left_hip_roll.F_on_left_hip = f;
}

// =================================================================================================
// Joint 2 "left_hip_roll": revolute, between links "left_hip" and "left_groin"
// =================================================================================================

void kinematics_left_hip_roll(Workspace& w) {
  auto& i = w.j_left_hip_roll;
  require_finite(w, w.q + 8, 1, 2);
  require_finite(w, w.v + 7, 1, 2);
  const Real q = Real(w.q[8]);
  const Real c = std::cos(q), s = std::sin(q);
  i.X.E << s, 0.0, c,  //
      c, 0.0, -s,  //
      0.0, 1.0, 0.0;
  i.X.r << 0.0, 0.0, 0.04;
  i.v = i.X * w.j_left_hip_pitch.v + joint_velocity<Revolute>(w.v + 7);
}

// A: link "left_hip"; B: the chain of "left_hip_yaw"; C feels the joint at "left_hip"
void assemble_left_hip_roll(Workspace& w) {
  auto& i = w.j_left_hip_roll;
  load_torque(w, 2, 7, i.joined.tau);
  const Mat6 X_Phi_A = i.X * kPhi_left_hip;
  const Mat6 Phi_A = from_right(X_Phi_A, i.X);
  const Columns6 c = velocity_product<Revolute>(i.v, w.v + 7);
  constexpr std::array<Real, 6> least{1.2860158696369453e-11, 1.2860158696369453e-11, 1.2110425354080618e-11, 4.1240689064045116e-14, 2.6082444034496316e-14, 3.835080781740452e-14};
  if (!keeps_digits<Revolute>(Phi_A, w.j_left_hip_yaw.Phi_left_groin, least))
    fail(w, kGrowth, 2);
  if (!join(i.joined, Phi_A, w.j_left_hip_yaw.Phi_left_groin, i.X * w.j_left_hip_pitch.b, w.j_left_hip_yaw.b_left_groin, c))
    fail(w, kFactorization, 2);
  couple(i.joined, X_Phi_A, i.at_left_hip);
  i.Phi_left_hip = kPhi_left_hip - product(i.at_left_hip, i.at_left_hip);  // Eq. (3)
  i.b_left_hip = w.j_left_hip_pitch.b - bias_change(i.joined, i.at_left_hip);  // Eq. (6)
}

void disassemble_left_hip_roll(Workspace& w) {
  auto& i = w.j_left_hip_roll;
  Release<Revolute> release(i.joined);
  release.feel_A(i.at_left_hip, w.j_left_hip_roll.F_on_left_hip);
  const Columns6 f = release.force();  // Eq. (8), (10)
  store_acceleration(w, 2, 7, release.qdd());  // Eq. (9)
  w.j_left_hip_yaw.F_on_left_groin = f;
}

// =================================================================================================
// Joint 3 "left_hip_yaw": revolute, between links "left_groin" and "left_thigh"
// =================================================================================================

void kinematics_left_hip_yaw(Workspace& w) {
  auto& i = w.j_left_hip_yaw;
  require_finite(w, w.q + 9, 1, 3);
  require_finite(w, w.v + 8, 1, 3);
  const Real q = Real(w.q[9]);
  const Real c = std::cos(q), s = std::sin(q);
  i.X.E << s, 0.0, c,  //
      c, 0.0, -s,  //
      0.0, 1.0, 0.0;
  i.X.r << 0.0, -0.12, 0.0;
  i.v = i.X * w.j_left_hip_roll.v + joint_velocity<Revolute>(w.v + 8);
}

// A: link "left_groin"; B: the chain of "left_knee"; C feels the joint at "left_groin"
void assemble_left_hip_yaw(Workspace& w) {
  auto& i = w.j_left_hip_yaw;
  load_torque(w, 3, 8, i.joined.tau);
  const Mat6 X_Phi_A = i.X * kPhi_left_groin;
  const Mat6 Phi_A = from_right(X_Phi_A, i.X);
  const Columns6 c = velocity_product<Revolute>(i.v, w.v + 8);
  constexpr std::array<Real, 6> least{4.1568802944704355e-12, 4.1568802944704355e-12, 6.3568005755356835e-12, 2.5673963648465354e-14, 2.5673963648465354e-14, 1.7308092281335775e-14};
  if (!keeps_digits<Revolute>(Phi_A, w.j_left_knee.Phi_left_thigh, least))
    fail(w, kGrowth, 3);
  if (!join(i.joined, Phi_A, w.j_left_knee.Phi_left_thigh, i.X * w.j_left_hip_roll.b, w.j_left_knee.b_left_thigh, c))
    fail(w, kFactorization, 3);
  couple(i.joined, X_Phi_A, i.at_left_groin);
  i.Phi_left_groin = kPhi_left_groin - product(i.at_left_groin, i.at_left_groin);  // Eq. (3)
  i.b_left_groin = w.j_left_hip_roll.b - bias_change(i.joined, i.at_left_groin);  // Eq. (6)
}

void disassemble_left_hip_yaw(Workspace& w) {
  auto& i = w.j_left_hip_yaw;
  Release<Revolute> release(i.joined);
  release.feel_A(i.at_left_groin, w.j_left_hip_yaw.F_on_left_groin);
  const Columns6 f = release.force();  // Eq. (8), (10)
  store_acceleration(w, 3, 8, release.qdd());  // Eq. (9)
  w.j_left_knee.F_on_left_thigh = f;
}

// =================================================================================================
// Joint 4 "left_knee": revolute, between links "left_thigh" and "left_shank"
// =================================================================================================

void kinematics_left_knee(Workspace& w) {
  auto& i = w.j_left_knee;
  require_finite(w, w.q + 10, 1, 4);
  require_finite(w, w.v + 9, 1, 4);
  const Real q = Real(w.q[10]);
  const Real c = std::cos(q), s = std::sin(q);
  i.X.E << s, 0.0, c,  //
      c, 0.0, -s,  //
      0.0, 1.0, 0.0;
  i.X.r << 0.0, 0.0, -0.24;
  i.v = i.X * w.j_left_hip_yaw.v + joint_velocity<Revolute>(w.v + 9);
}

// A: link "left_thigh"; B: the chain of "left_ankle_pitch"; C feels the joint at "left_thigh"
void assemble_left_knee(Workspace& w) {
  auto& i = w.j_left_knee;
  load_torque(w, 4, 9, i.joined.tau);
  const Mat6 X_Phi_A = i.X * kPhi_left_thigh;
  const Mat6 Phi_A = from_right(X_Phi_A, i.X);
  const Columns6 c = velocity_product<Revolute>(i.v, w.v + 9);
  constexpr std::array<Real, 6> least{8.16509939297173e-12, 1.4891475962065713e-12, 1.4891475962065713e-12, 1.3472782573236314e-14, 3.231397165528738e-14, 3.3093716769976106e-14};
  if (!keeps_digits<Revolute>(Phi_A, w.j_left_ankle_pitch.Phi_left_shank, least))
    fail(w, kGrowth, 4);
  if (!join(i.joined, Phi_A, w.j_left_ankle_pitch.Phi_left_shank, i.X * w.j_left_hip_yaw.b, w.j_left_ankle_pitch.b_left_shank, c))
    fail(w, kFactorization, 4);
  couple(i.joined, X_Phi_A, i.at_left_thigh);
  i.Phi_left_thigh = kPhi_left_thigh - product(i.at_left_thigh, i.at_left_thigh);  // Eq. (3)
  i.b_left_thigh = w.j_left_hip_yaw.b - bias_change(i.joined, i.at_left_thigh);  // Eq. (6)
}

void disassemble_left_knee(Workspace& w) {
  auto& i = w.j_left_knee;
  Release<Revolute> release(i.joined);
  release.feel_A(i.at_left_thigh, w.j_left_knee.F_on_left_thigh);
  const Columns6 f = release.force();  // Eq. (8), (10)
  store_acceleration(w, 4, 9, release.qdd());  // Eq. (9)
  w.j_left_ankle_pitch.F_on_left_shank = f;
}

// =================================================================================================
// Joint 5 "left_ankle_pitch": revolute, between links "left_shank" and "left_ankle"
// =================================================================================================

void kinematics_left_ankle_pitch(Workspace& w) {
  auto& i = w.j_left_ankle_pitch;
  require_finite(w, w.q + 11, 1, 5);
  require_finite(w, w.v + 10, 1, 5);
  const Real q = Real(w.q[11]);
  const Real c = std::cos(q), s = std::sin(q);
  i.X.E << c, s, 0.0,  //
      -s, c, 0.0,  //
      0.0, 0.0, 1.0;
  i.X.r << -0.3, 0.0, 0.0;
  i.v = i.X * w.j_left_knee.v + joint_velocity<Revolute>(w.v + 10);
}

// A: link "left_shank"; B: the chain of "left_ankle_roll"; C feels the joint at "left_shank"
void assemble_left_ankle_pitch(Workspace& w) {
  auto& i = w.j_left_ankle_pitch;
  load_torque(w, 5, 10, i.joined.tau);
  const Mat6 X_Phi_A = i.X * kPhi_left_shank;
  const Mat6 Phi_A = from_right(X_Phi_A, i.X);
  const Columns6 c = velocity_product<Revolute>(i.v, w.v + 10);
  constexpr std::array<Real, 6> least{1.978961112703373e-10, 1.978961112703373e-10, 1.978961112703373e-10, 7.894919286223335e-14, 7.894919286223335e-14, 7.894919286223335e-14};
  if (!keeps_digits<Revolute>(Phi_A, w.j_left_ankle_roll.Phi_left_ankle, least))
    fail(w, kGrowth, 5);
  if (!join(i.joined, Phi_A, w.j_left_ankle_roll.Phi_left_ankle, i.X * w.j_left_knee.b, w.j_left_ankle_roll.b_left_ankle, c))
    fail(w, kFactorization, 5);
  couple(i.joined, X_Phi_A, i.at_left_shank);
  i.Phi_left_shank = kPhi_left_shank - product(i.at_left_shank, i.at_left_shank);  // Eq. (3)
  i.b_left_shank = w.j_left_knee.b - bias_change(i.joined, i.at_left_shank);  // Eq. (6)
}

void disassemble_left_ankle_pitch(Workspace& w) {
  auto& i = w.j_left_ankle_pitch;
  Release<Revolute> release(i.joined);
  release.feel_A(i.at_left_shank, w.j_left_ankle_pitch.F_on_left_shank);
  const Columns6 f = release.force();  // Eq. (8), (10)
  store_acceleration(w, 5, 10, release.qdd());  // Eq. (9)
  w.j_left_ankle_roll.F_on_left_ankle = f;
}

// =================================================================================================
// Joint 6 "left_ankle_roll": revolute, between links "left_ankle" and "left_foot"
// =================================================================================================

void kinematics_left_ankle_roll(Workspace& w) {
  auto& i = w.j_left_ankle_roll;
  require_finite(w, w.q + 12, 1, 6);
  require_finite(w, w.v + 11, 1, 6);
  const Real q = Real(w.q[12]);
  const Real c = std::cos(q), s = std::sin(q);
  i.X.E << s, 0.0, c,  //
      c, 0.0, -s,  //
      0.0, 1.0, 0.0;
  i.X.r << -0.02, 0.0, 0.0;
  i.v = i.X * w.j_left_ankle_pitch.v + joint_velocity<Revolute>(w.v + 11);
}

// A: link "left_ankle"; B: link "left_foot"; C feels the joint at "left_ankle"
void assemble_left_ankle_roll(Workspace& w) {
  auto& i = w.j_left_ankle_roll;
  load_torque(w, 6, 11, i.joined.tau);
  const Mat6 X_Phi_A = i.X * kPhi_left_ankle;
  const Mat6 Phi_A = from_right(X_Phi_A, i.X);
  const Columns6 c = velocity_product<Revolute>(i.v, w.v + 11);
  constexpr std::array<Real, 6> least{7.100279258824507e-11, 7.03850253111196e-11, 9.499136045271017e-11, 1.192327998641093e-13, 9.350846065275807e-14, 9.350846065275807e-14};
  if (!keeps_digits<Revolute>(Phi_A, kPhi_left_foot, least))
    fail(w, kGrowth, 6);
  if (!join(i.joined, Phi_A, kPhi_left_foot, i.X * w.j_left_ankle_pitch.b, w.j_left_ankle_roll.b, c))
    fail(w, kFactorization, 6);
  couple(i.joined, X_Phi_A, i.at_left_ankle);
  i.Phi_left_ankle = kPhi_left_ankle - product(i.at_left_ankle, i.at_left_ankle);  // Eq. (3)
  i.b_left_ankle = w.j_left_ankle_pitch.b - bias_change(i.joined, i.at_left_ankle);  // Eq. (6)
}

void disassemble_left_ankle_roll(Workspace& w) {
  auto& i = w.j_left_ankle_roll;
  Release<Revolute> release(i.joined);
  release.feel_A(i.at_left_ankle, w.j_left_ankle_roll.F_on_left_ankle);
  release.force();  // Eq. (8)
  store_acceleration(w, 6, 11, release.qdd());  // Eq. (9)
}

// =================================================================================================
// Joint 7 "right_hip_pitch": revolute, between links "pelvis" and "right_hip"
// =================================================================================================

void kinematics_right_hip_pitch(Workspace& w) {
  auto& i = w.j_right_hip_pitch;
  require_finite(w, w.q + 13, 1, 7);
  require_finite(w, w.v + 12, 1, 7);
  const Real q = Real(w.q[13]);
  const Real c = std::cos(q), s = std::sin(q);
  i.X.E << s, 0.0, c,  //
      c, 0.0, -s,  //
      0.0, 1.0, 0.0;
  i.X.r << 0.0, -0.09, -0.05;
  i.v = i.X * w.j_base.v + joint_velocity<Revolute>(w.v + 12);
}

// A: link "pelvis"; B: the chain of "right_hip_roll"; C feels the joint at "pelvis"
void assemble_right_hip_pitch(Workspace& w) {
  auto& i = w.j_right_hip_pitch;
  load_torque(w, 7, 12, i.joined.tau);
  const Mat6 X_Phi_A = i.X * kPhi_pelvis;
  const Mat6 Phi_A = from_right(X_Phi_A, i.X);
  const Columns6 c = velocity_product<Revolute>(i.v, w.v + 12);
  constexpr std::array<Real, 6> least{7.97506041035137e-12, 7.97506041035137e-12, 8.287386887608557e-12, 1.9470029590306893e-14, 1.9470029590306893e-14, 1.2442683852020187e-14};
  if (!keeps_digits<Revolute>(Phi_A, w.j_right_hip_roll.Phi_right_hip, least))
    fail(w, kGrowth, 7);
  if (!join(i.joined, Phi_A, w.j_right_hip_roll.Phi_right_hip, i.X * w.j_base.b, w.j_right_hip_roll.b_right_hip, c))
    fail(w, kFactorization, 7);
  couple(i.joined, X_Phi_A, i.at_pelvis);
  i.Phi_pelvis = kPhi_pelvis - product(i.at_pelvis, i.at_pelvis);  // Eq. (3)
  i.b_pelvis = w.j_base.b - bias_change(i.joined, i.at_pelvis);  // Eq. (6)
}

void disassemble_right_hip_pitch(Workspace& w) {
  auto& i = w.j_right_hip_pitch;
  Release<Revolute> release(i.joined);
  release.feel_A(i.at_pelvis, w.j_right_hip_pitch.F_on_pelvis);
  const Columns6 f = release.force();  // Eq. (8), (10)
  store_acceleration(w, 7, 12, release.qdd());  // Eq. (9)
  w.j_right_hip_roll.F_on_right_hip = f;
}

// =================================================================================================
// Joint 8 "right_hip_roll": revolute, between links "right_hip" and "right_groin"
// =================================================================================================

void kinematics_right_hip_roll(Workspace& w) {
  auto& i = w.j_right_hip_roll;
  require_finite(w, w.q + 14, 1, 8);
  require_finite(w, w.v + 13, 1, 8);
  const Real q = Real(w.q[14]);
  const Real c = std::cos(q), s = std::sin(q);
  i.X.E << s, 0.0, c,  //
      c, 0.0, -s,  //
      0.0, 1.0, 0.0;
  i.X.r << 0.0, 0.0, -0.04;
  i.v = i.X * w.j_right_hip_pitch.v + joint_velocity<Revolute>(w.v + 13);
}

// A: link "right_hip"; B: the chain of "right_hip_yaw"; C feels the joint at "right_hip"
void assemble_right_hip_roll(Workspace& w) {
  auto& i = w.j_right_hip_roll;
  load_torque(w, 8, 13, i.joined.tau);
  const Mat6 X_Phi_A = i.X * kPhi_right_hip;
  const Mat6 Phi_A = from_right(X_Phi_A, i.X);
  const Columns6 c = velocity_product<Revolute>(i.v, w.v + 13);
  constexpr std::array<Real, 6> least{1.2860158696369453e-11, 1.2860158696369453e-11, 1.2110425354080618e-11, 4.1240689064045116e-14, 2.6082444034496316e-14, 3.835080781740452e-14};
  if (!keeps_digits<Revolute>(Phi_A, w.j_right_hip_yaw.Phi_right_groin, least))
    fail(w, kGrowth, 8);
  if (!join(i.joined, Phi_A, w.j_right_hip_yaw.Phi_right_groin, i.X * w.j_right_hip_pitch.b, w.j_right_hip_yaw.b_right_groin, c))
    fail(w, kFactorization, 8);
  couple(i.joined, X_Phi_A, i.at_right_hip);
  i.Phi_right_hip = kPhi_right_hip - product(i.at_right_hip, i.at_right_hip);  // Eq. (3)
  i.b_right_hip = w.j_right_hip_pitch.b - bias_change(i.joined, i.at_right_hip);  // Eq. (6)
}

void disassemble_right_hip_roll(Workspace& w) {
  auto& i = w.j_right_hip_roll;
  Release<Revolute> release(i.joined);
  release.feel_A(i.at_right_hip, w.j_right_hip_roll.F_on_right_hip);
  const Columns6 f = release.force();  // Eq. (8), (10)
  store_acceleration(w, 8, 13, release.qdd());  // Eq. (9)
  w.j_right_hip_yaw.F_on_right_groin = f;
}

// =================================================================================================
// Joint 9 "right_hip_yaw": revolute, between links "right_groin" and "right_thigh"
// =================================================================================================

void kinematics_right_hip_yaw(Workspace& w) {
  auto& i = w.j_right_hip_yaw;
  require_finite(w, w.q + 15, 1, 9);
  require_finite(w, w.v + 14, 1, 9);
  const Real q = Real(w.q[15]);
  const Real c = std::cos(q), s = std::sin(q);
  i.X.E << s, 0.0, c,  //
      c, 0.0, -s,  //
      0.0, 1.0, 0.0;
  i.X.r << 0.0, -0.12, 0.0;
  i.v = i.X * w.j_right_hip_roll.v + joint_velocity<Revolute>(w.v + 14);
}

// A: link "right_groin"; B: the chain of "right_knee"; C feels the joint at "right_groin"
void assemble_right_hip_yaw(Workspace& w) {
  auto& i = w.j_right_hip_yaw;
  load_torque(w, 9, 14, i.joined.tau);
  const Mat6 X_Phi_A = i.X * kPhi_right_groin;
  const Mat6 Phi_A = from_right(X_Phi_A, i.X);
  const Columns6 c = velocity_product<Revolute>(i.v, w.v + 14);
  constexpr std::array<Real, 6> least{4.1568802944704355e-12, 4.1568802944704355e-12, 6.3568005755356835e-12, 2.5673963648465354e-14, 2.5673963648465354e-14, 1.7308092281335775e-14};
  if (!keeps_digits<Revolute>(Phi_A, w.j_right_knee.Phi_right_thigh, least))
    fail(w, kGrowth, 9);
  if (!join(i.joined, Phi_A, w.j_right_knee.Phi_right_thigh, i.X * w.j_right_hip_roll.b, w.j_right_knee.b_right_thigh, c))
    fail(w, kFactorization, 9);
  couple(i.joined, X_Phi_A, i.at_right_groin);
  i.Phi_right_groin = kPhi_right_groin - product(i.at_right_groin, i.at_right_groin);  // Eq. (3)
  i.b_right_groin = w.j_right_hip_roll.b - bias_change(i.joined, i.at_right_groin);  // Eq. (6)
}

void disassemble_right_hip_yaw(Workspace& w) {
  auto& i = w.j_right_hip_yaw;
  Release<Revolute> release(i.joined);
  release.feel_A(i.at_right_groin, w.j_right_hip_yaw.F_on_right_groin);
  const Columns6 f = release.force();  // Eq. (8), (10)
  store_acceleration(w, 9, 14, release.qdd());  // Eq. (9)
  w.j_right_knee.F_on_right_thigh = f;
}

// =================================================================================================
// Joint 10 "right_knee": revolute, between links "right_thigh" and "right_shank"
// =================================================================================================

void kinematics_right_knee(Workspace& w) {
  auto& i = w.j_right_knee;
  require_finite(w, w.q + 16, 1, 10);
  require_finite(w, w.v + 15, 1, 10);
  const Real q = Real(w.q[16]);
  const Real c = std::cos(q), s = std::sin(q);
  i.X.E << s, 0.0, c,  //
      c, 0.0, -s,  //
      0.0, 1.0, 0.0;
  i.X.r << 0.0, 0.0, -0.24;
  i.v = i.X * w.j_right_hip_yaw.v + joint_velocity<Revolute>(w.v + 15);
}

// A: link "right_thigh"; B: the chain of "right_ankle_pitch"; C feels the joint at "right_thigh"
void assemble_right_knee(Workspace& w) {
  auto& i = w.j_right_knee;
  load_torque(w, 10, 15, i.joined.tau);
  const Mat6 X_Phi_A = i.X * kPhi_right_thigh;
  const Mat6 Phi_A = from_right(X_Phi_A, i.X);
  const Columns6 c = velocity_product<Revolute>(i.v, w.v + 15);
  constexpr std::array<Real, 6> least{8.16509939297173e-12, 1.4891475962065713e-12, 1.4891475962065713e-12, 1.3472782573236314e-14, 3.231397165528738e-14, 3.3093716769976106e-14};
  if (!keeps_digits<Revolute>(Phi_A, w.j_right_ankle_pitch.Phi_right_shank, least))
    fail(w, kGrowth, 10);
  if (!join(i.joined, Phi_A, w.j_right_ankle_pitch.Phi_right_shank, i.X * w.j_right_hip_yaw.b, w.j_right_ankle_pitch.b_right_shank, c))
    fail(w, kFactorization, 10);
  couple(i.joined, X_Phi_A, i.at_right_thigh);
  i.Phi_right_thigh = kPhi_right_thigh - product(i.at_right_thigh, i.at_right_thigh);  // Eq. (3)
  i.b_right_thigh = w.j_right_hip_yaw.b - bias_change(i.joined, i.at_right_thigh);  // Eq. (6)
}

void disassemble_right_knee(Workspace& w) {
  auto& i = w.j_right_knee;
  Release<Revolute> release(i.joined);
  release.feel_A(i.at_right_thigh, w.j_right_knee.F_on_right_thigh);
  const Columns6 f = release.force();  // Eq. (8), (10)
  store_acceleration(w, 10, 15, release.qdd());  // Eq. (9)
  w.j_right_ankle_pitch.F_on_right_shank = f;
}

// =================================================================================================
// Joint 11 "right_ankle_pitch": revolute, between links "right_shank" and "right_ankle"
// =================================================================================================

void kinematics_right_ankle_pitch(Workspace& w) {
  auto& i = w.j_right_ankle_pitch;
  require_finite(w, w.q + 17, 1, 11);
  require_finite(w, w.v + 16, 1, 11);
  const Real q = Real(w.q[17]);
  const Real c = std::cos(q), s = std::sin(q);
  i.X.E << c, s, 0.0,  //
      -s, c, 0.0,  //
      0.0, 0.0, 1.0;
  i.X.r << -0.3, 0.0, 0.0;
  i.v = i.X * w.j_right_knee.v + joint_velocity<Revolute>(w.v + 16);
}

// A: link "right_shank"; B: the chain of "right_ankle_roll"; C feels the joint at "right_shank"
void assemble_right_ankle_pitch(Workspace& w) {
  auto& i = w.j_right_ankle_pitch;
  load_torque(w, 11, 16, i.joined.tau);
  const Mat6 X_Phi_A = i.X * kPhi_right_shank;
  const Mat6 Phi_A = from_right(X_Phi_A, i.X);
  const Columns6 c = velocity_product<Revolute>(i.v, w.v + 16);
  constexpr std::array<Real, 6> least{1.978961112703373e-10, 1.978961112703373e-10, 1.978961112703373e-10, 7.894919286223335e-14, 7.894919286223335e-14, 7.894919286223335e-14};
  if (!keeps_digits<Revolute>(Phi_A, w.j_right_ankle_roll.Phi_right_ankle, least))
    fail(w, kGrowth, 11);
  if (!join(i.joined, Phi_A, w.j_right_ankle_roll.Phi_right_ankle, i.X * w.j_right_knee.b, w.j_right_ankle_roll.b_right_ankle, c))
    fail(w, kFactorization, 11);
  couple(i.joined, X_Phi_A, i.at_right_shank);
  i.Phi_right_shank = kPhi_right_shank - product(i.at_right_shank, i.at_right_shank);  // Eq. (3)
  i.b_right_shank = w.j_right_knee.b - bias_change(i.joined, i.at_right_shank);  // Eq. (6)
}

void disassemble_right_ankle_pitch(Workspace& w) {
  auto& i = w.j_right_ankle_pitch;
  Release<Revolute> release(i.joined);
  release.feel_A(i.at_right_shank, w.j_right_ankle_pitch.F_on_right_shank);
  const Columns6 f = release.force();  // Eq. (8), (10)
  store_acceleration(w, 11, 16, release.qdd());  // Eq. (9)
  w.j_right_ankle_roll.F_on_right_ankle = f;
}

// =================================================================================================
// Joint 12 "right_ankle_roll": revolute, between links "right_ankle" and "right_foot"
// =================================================================================================

void kinematics_right_ankle_roll(Workspace& w) {
  auto& i = w.j_right_ankle_roll;
  require_finite(w, w.q + 18, 1, 12);
  require_finite(w, w.v + 17, 1, 12);
  const Real q = Real(w.q[18]);
  const Real c = std::cos(q), s = std::sin(q);
  i.X.E << s, 0.0, c,  //
      c, 0.0, -s,  //
      0.0, 1.0, 0.0;
  i.X.r << -0.02, 0.0, 0.0;
  i.v = i.X * w.j_right_ankle_pitch.v + joint_velocity<Revolute>(w.v + 17);
}

// A: link "right_ankle"; B: link "right_foot"; C feels the joint at "right_ankle"
void assemble_right_ankle_roll(Workspace& w) {
  auto& i = w.j_right_ankle_roll;
  load_torque(w, 12, 17, i.joined.tau);
  const Mat6 X_Phi_A = i.X * kPhi_right_ankle;
  const Mat6 Phi_A = from_right(X_Phi_A, i.X);
  const Columns6 c = velocity_product<Revolute>(i.v, w.v + 17);
  constexpr std::array<Real, 6> least{7.100279258824507e-11, 7.03850253111196e-11, 9.499136045271017e-11, 1.192327998641093e-13, 9.350846065275807e-14, 9.350846065275807e-14};
  if (!keeps_digits<Revolute>(Phi_A, kPhi_right_foot, least))
    fail(w, kGrowth, 12);
  if (!join(i.joined, Phi_A, kPhi_right_foot, i.X * w.j_right_ankle_pitch.b, w.j_right_ankle_roll.b, c))
    fail(w, kFactorization, 12);
  couple(i.joined, X_Phi_A, i.at_right_ankle);
  i.Phi_right_ankle = kPhi_right_ankle - product(i.at_right_ankle, i.at_right_ankle);  // Eq. (3)
  i.b_right_ankle = w.j_right_ankle_pitch.b - bias_change(i.joined, i.at_right_ankle);  // Eq. (6)
}

void disassemble_right_ankle_roll(Workspace& w) {
  auto& i = w.j_right_ankle_roll;
  Release<Revolute> release(i.joined);
  release.feel_A(i.at_right_ankle, w.j_right_ankle_roll.F_on_right_ankle);
  release.force();  // Eq. (8)
  store_acceleration(w, 12, 17, release.qdd());  // Eq. (9)
}

// =================================================================================================
// Joint 13 "waist_yaw": revolute, between links "pelvis" and "waist_link"
// =================================================================================================

void kinematics_waist_yaw(Workspace& w) {
  auto& i = w.j_waist_yaw;
  require_finite(w, w.q + 19, 1, 13);
  require_finite(w, w.v + 18, 1, 13);
  const Real q = Real(w.q[19]);
  const Real c = std::cos(q), s = std::sin(q);
  i.X.E << c, s, 0.0,  //
      -s, c, 0.0,  //
      0.0, 0.0, 1.0;
  i.X.r << 0.0, 0.0, 0.09;
  i.v = i.X * w.j_base.v + joint_velocity<Revolute>(w.v + 18);
}

// A: the chain of "__base__"; B: the chain of "waist_roll"; C feels the joint at no link
void assemble_waist_yaw(Workspace& w) {
  auto& i = w.j_waist_yaw;
  load_torque(w, 13, 18, i.joined.tau);
  const Mat6 X_Phi_A = i.X * w.j_base.Phi_pelvis;
  const Mat6 Phi_A = from_right(X_Phi_A, i.X);
  const Columns6 c = velocity_product<Revolute>(i.v, w.v + 18);
  constexpr std::array<Real, 6> least{1.937075620216765e-11, 1.937075620216765e-11, 1.4377753194123701e-11, 2.77371848244625e-14, 2.77371848244625e-14, 2.005564173516412e-14};
  if (!keeps_digits<Revolute>(Phi_A, w.j_waist_roll.Phi_waist_link, least))
    fail(w, kGrowth, 13);
  if (!join(i.joined, Phi_A, w.j_waist_roll.Phi_waist_link, i.X * w.j_base.b_pelvis, w.j_waist_roll.b_waist_link, c))
    fail(w, kFactorization, 13);
}

void disassemble_waist_yaw(Workspace& w) {
  auto& i = w.j_waist_yaw;
  Release<Revolute> release(i.joined);
  const Columns6 f = release.force();  // Eq. (8), (10)
  store_acceleration(w, 13, 18, release.qdd());  // Eq. (9)
  w.j_base.F_on_pelvis = -i.X.transposed_times(f);
  w.j_waist_roll.F_on_waist_link = f;
}

// =================================================================================================
// Joint 14 "waist_roll": revolute, between links "waist_link" and "abdomen"
// =================================================================================================

void kinematics_waist_roll(Workspace& w) {
  auto& i = w.j_waist_roll;
  require_finite(w, w.q + 20, 1, 14);
  require_finite(w, w.v + 19, 1, 14);
  const Real q = Real(w.q[20]);
  const Real c = std::cos(q), s = std::sin(q);
  i.X.E << 0.0, c, s,  //
      0.0, -s, c,  //
      1.0, 0.0, 0.0;
  i.X.r << 0.0, 0.0, 0.05;
  i.v = i.X * w.j_waist_yaw.v + joint_velocity<Revolute>(w.v + 19);
}

// A: link "waist_link"; B: the chain of "waist_pitch"; C feels the joint at "waist_link"
void assemble_waist_roll(Workspace& w) {
  auto& i = w.j_waist_roll;
  load_torque(w, 14, 19, i.joined.tau);
  const Mat6 X_Phi_A = i.X * kPhi_waist_link;
  const Mat6 Phi_A = from_right(X_Phi_A, i.X);
  const Columns6 c = velocity_product<Revolute>(i.v, w.v + 19);
  constexpr std::array<Real, 6> least{1.9361698667246485e-11, 1.836205421086137e-11, 1.9361698667246485e-11, 3.9006013092186154e-14, 3.3553406966449176e-14, 3.9006013092186154e-14};
  if (!keeps_digits<Revolute>(Phi_A, w.j_waist_pitch.Phi_abdomen, least))
    fail(w, kGrowth, 14);
  if (!join(i.joined, Phi_A, w.j_waist_pitch.Phi_abdomen, i.X * w.j_waist_yaw.b, w.j_waist_pitch.b_abdomen, c))
    fail(w, kFactorization, 14);
  couple(i.joined, X_Phi_A, i.at_waist_link);
  i.Phi_waist_link = kPhi_waist_link - product(i.at_waist_link, i.at_waist_link);  // Eq. (3)
  i.b_waist_link = w.j_waist_yaw.b - bias_change(i.joined, i.at_waist_link);  // Eq. (6)
}

void disassemble_waist_roll(Workspace& w) {
  auto& i = w.j_waist_roll;
  Release<Revolute> release(i.joined);
  release.feel_A(i.at_waist_link, w.j_waist_roll.F_on_waist_link);
  const Columns6 f = release.force();  // Eq. (8), (10)
  store_acceleration(w, 14, 19, release.qdd());  // Eq. (9)
  w.j_waist_pitch.F_on_abdomen = f;
}

// =================================================================================================
// Joint 15 "waist_pitch": revolute, between links "abdomen" and "torso"
// =================================================================================================

void kinematics_waist_pitch(Workspace& w) {
  auto& i = w.j_waist_pitch;
  require_finite(w, w.q + 21, 1, 15);
  require_finite(w, w.v + 20, 1, 15);
  const Real q = Real(w.q[21]);
  const Real c = std::cos(q), s = std::sin(q);
  i.X.E << 0.0, c, s,  //
      0.0, -s, c,  //
      1.0, 0.0, 0.0;
  i.X.r << 0.0, 0.04, 0.0;
  i.v = i.X * w.j_waist_roll.v + joint_velocity<Revolute>(w.v + 20);
}

// A: link "abdomen"; B: the chain of "left_shoulder_pitch"; C feels the joint at "abdomen"
void assemble_waist_pitch(Workspace& w) {
  auto& i = w.j_waist_pitch;
  load_torque(w, 15, 20, i.joined.tau);
  const Mat6 X_Phi_A = i.X * kPhi_abdomen;
  const Mat6 Phi_A = from_right(X_Phi_A, i.X);
  const Columns6 c = velocity_product<Revolute>(i.v, w.v + 20);
  constexpr std::array<Real, 6> least{4.5996590878295124e-12, 4.519586369882674e-12, 4.5541864873908146e-12, 1.7298430910523563e-14, 2.09597444894919e-14, 1.9977061247921946e-14};
  if (!keeps_digits<Revolute>(Phi_A, w.j_left_shoulder_pitch.Phi_torso, least))
    fail(w, kGrowth, 15);
  if (!join(i.joined, Phi_A, w.j_left_shoulder_pitch.Phi_torso, i.X * w.j_waist_roll.b, w.j_left_shoulder_pitch.b_torso, c))
    fail(w, kFactorization, 15);
  couple(i.joined, X_Phi_A, i.at_abdomen);
  i.Phi_abdomen = kPhi_abdomen - product(i.at_abdomen, i.at_abdomen);  // Eq. (3)
  i.b_abdomen = w.j_waist_roll.b - bias_change(i.joined, i.at_abdomen);  // Eq. (6)
}

void disassemble_waist_pitch(Workspace& w) {
  auto& i = w.j_waist_pitch;
  Release<Revolute> release(i.joined);
  release.feel_A(i.at_abdomen, w.j_waist_pitch.F_on_abdomen);
  const Columns6 f = release.force();  // Eq. (8), (10)
  store_acceleration(w, 15, 20, release.qdd());  // Eq. (9)
  w.j_left_shoulder_pitch.F_on_torso = f;
}

// =================================================================================================
// Joint 16 "left_shoulder_pitch": revolute, between links "torso" and "left_shoulder"
// =================================================================================================

void kinematics_left_shoulder_pitch(Workspace& w) {
  auto& i = w.j_left_shoulder_pitch;
  require_finite(w, w.q + 22, 1, 16);
  require_finite(w, w.v + 21, 1, 16);
  const Real q = Real(w.q[22]);
  const Real c = std::cos(q), s = std::sin(q);
  i.X.E << c, s, 0.0,  //
      -s, c, 0.0,  //
      0.0, 0.0, 1.0;
  i.X.r << 0.29, 0.0, 0.15;
  i.v = i.X * w.j_waist_pitch.v + joint_velocity<Revolute>(w.v + 21);
}

// A: the chain of "neck_yaw"; B: the chain of "left_shoulder_roll"; C feels the joint at "torso"
void assemble_left_shoulder_pitch(Workspace& w) {
  auto& i = w.j_left_shoulder_pitch;
  load_torque(w, 16, 21, i.joined.tau);
  const Mat6 X_Phi_A = i.X * w.j_neck_yaw.Phi_torso;
  const Mat6 Phi_A = from_right(X_Phi_A, i.X);
  const Columns6 c = velocity_product<Revolute>(i.v, w.v + 21);
  constexpr std::array<Real, 6> least{2.2016408306401386e-11, 2.2016408306401386e-11, 2.2245331597838116e-11, 3.903743131866773e-14, 3.903743131866773e-14, 1.9259447837707977e-14};
  if (!keeps_digits<Revolute>(Phi_A, w.j_left_shoulder_roll.Phi_left_shoulder, least))
    fail(w, kGrowth, 16);
  if (!join(i.joined, Phi_A, w.j_left_shoulder_roll.Phi_left_shoulder, i.X * w.j_neck_yaw.b_torso, w.j_left_shoulder_roll.b_left_shoulder, c))
    fail(w, kFactorization, 16);
  couple(i.joined, X_Phi_A, i.at_torso);
  i.Phi_torso = w.j_neck_yaw.Phi_torso - product(i.at_torso, i.at_torso);  // Eq. (3)
  i.b_torso = w.j_neck_yaw.b_torso - bias_change(i.joined, i.at_torso);  // Eq. (6)
}

void disassemble_left_shoulder_pitch(Workspace& w) {
  auto& i = w.j_left_shoulder_pitch;
  Release<Revolute> release(i.joined);
  release.feel_A(i.at_torso, w.j_left_shoulder_pitch.F_on_torso);
  const Columns6 f = release.force();  // Eq. (8), (10)
  store_acceleration(w, 16, 21, release.qdd());  // Eq. (9)
  w.j_neck_yaw.F_on_torso = w.j_left_shoulder_pitch.F_on_torso - i.X.transposed_times(f);
  w.j_left_shoulder_roll.F_on_left_shoulder = f;
}

// =================================================================================================
// Joint 17 "left_shoulder_roll": revolute, between links "left_shoulder" and "left_shoulder_cap"
// =================================================================================================

void kinematics_left_shoulder_roll(Workspace& w) {
  auto& i = w.j_left_shoulder_roll;
  require_finite(w, w.q + 23, 1, 17);
  require_finite(w, w.v + 22, 1, 17);
  const Real q = Real(w.q[23]);
  const Real c = std::cos(q), s = std::sin(q);
  i.X.E << s, 0.0, c,  //
      c, 0.0, -s,  //
      0.0, 1.0, 0.0;
  i.X.r << 0.0, 0.0, 0.05;
  i.v = i.X * w.j_left_shoulder_pitch.v + joint_velocity<Revolute>(w.v + 22);
}

// A: link "left_shoulder"; B: the chain of "left_shoulder_yaw"; C feels the joint at "left_shoulder"
void assemble_left_shoulder_roll(Workspace& w) {
  auto& i = w.j_left_shoulder_roll;
  load_torque(w, 17, 22, i.joined.tau);
  const Mat6 X_Phi_A = i.X * kPhi_left_shoulder;
  const Mat6 Phi_A = from_right(X_Phi_A, i.X);
  const Columns6 c = velocity_product<Revolute>(i.v, w.v + 22);
  constexpr std::array<Real, 6> least{2.765166058115282e-11, 2.765166058115282e-11, 2.765166058115282e-11, 5.633588833526509e-14, 4.009491151789137e-14, 5.836601043743681e-14};
  if (!keeps_digits<Revolute>(Phi_A, w.j_left_shoulder_yaw.Phi_left_shoulder_cap, least))
    fail(w, kGrowth, 17);
  if (!join(i.joined, Phi_A, w.j_left_shoulder_yaw.Phi_left_shoulder_cap, i.X * w.j_left_shoulder_pitch.b, w.j_left_shoulder_yaw.b_left_shoulder_cap, c))
    fail(w, kFactorization, 17);
  couple(i.joined, X_Phi_A, i.at_left_shoulder);
  i.Phi_left_shoulder = kPhi_left_shoulder - product(i.at_left_shoulder, i.at_left_shoulder);  // Eq. (3)
  i.b_left_shoulder = w.j_left_shoulder_pitch.b - bias_change(i.joined, i.at_left_shoulder);  // Eq. (6)
}

void disassemble_left_shoulder_roll(Workspace& w) {
  auto& i = w.j_left_shoulder_roll;
  Release<Revolute> release(i.joined);
  release.feel_A(i.at_left_shoulder, w.j_left_shoulder_roll.F_on_left_shoulder);
  const Columns6 f = release.force();  // Eq. (8), (10)
  store_acceleration(w, 17, 22, release.qdd());  // Eq. (9)
  w.j_left_shoulder_yaw.F_on_left_shoulder_cap = f;
}

// =================================================================================================
// Joint 18 "left_shoulder_yaw": revolute, between links "left_shoulder_cap" and "left_upper_arm"
// =================================================================================================

void kinematics_left_shoulder_yaw(Workspace& w) {
  auto& i = w.j_left_shoulder_yaw;
  require_finite(w, w.q + 24, 1, 18);
  require_finite(w, w.v + 23, 1, 18);
  const Real q = Real(w.q[24]);
  const Real c = std::cos(q), s = std::sin(q);
  i.X.E << s, 0.0, c,  //
      c, 0.0, -s,  //
      0.0, 1.0, 0.0;
  i.X.r << 0.0, -0.1, 0.0;
  i.v = i.X * w.j_left_shoulder_roll.v + joint_velocity<Revolute>(w.v + 23);
}

// A: link "left_shoulder_cap"; B: the chain of "left_elbow"; C feels the joint at "left_shoulder_cap"
void assemble_left_shoulder_yaw(Workspace& w) {
  auto& i = w.j_left_shoulder_yaw;
  load_torque(w, 18, 23, i.joined.tau);
  const Mat6 X_Phi_A = i.X * kPhi_left_shoulder_cap;
  const Mat6 Phi_A = from_right(X_Phi_A, i.X);
  const Columns6 c = velocity_product<Revolute>(i.v, w.v + 23);
  constexpr std::array<Real, 6> least{1.550323694931007e-11, 1.550323694931007e-11, 2.8971534166408843e-11, 5.990519760423054e-14, 5.990519760423054e-14, 3.8064789415719656e-14};
  if (!keeps_digits<Revolute>(Phi_A, w.j_left_elbow.Phi_left_upper_arm, least))
    fail(w, kGrowth, 18);
  if (!join(i.joined, Phi_A, w.j_left_elbow.Phi_left_upper_arm, i.X * w.j_left_shoulder_roll.b, w.j_left_elbow.b_left_upper_arm, c))
    fail(w, kFactorization, 18);
  couple(i.joined, X_Phi_A, i.at_left_shoulder_cap);
  i.Phi_left_shoulder_cap = kPhi_left_shoulder_cap - product(i.at_left_shoulder_cap, i.at_left_shoulder_cap);  // Eq. (3)
  i.b_left_shoulder_cap = w.j_left_shoulder_roll.b - bias_change(i.joined, i.at_left_shoulder_cap);  // Eq. (6)
}

void disassemble_left_shoulder_yaw(Workspace& w) {
  auto& i = w.j_left_shoulder_yaw;
  Release<Revolute> release(i.joined);
  release.feel_A(i.at_left_shoulder_cap, w.j_left_shoulder_yaw.F_on_left_shoulder_cap);
  const Columns6 f = release.force();  // Eq. (8), (10)
  store_acceleration(w, 18, 23, release.qdd());  // Eq. (9)
  w.j_left_elbow.F_on_left_upper_arm = f;
}

// =================================================================================================
// Joint 19 "left_elbow": revolute, between links "left_upper_arm" and "left_forearm"
// =================================================================================================

void kinematics_left_elbow(Workspace& w) {
  auto& i = w.j_left_elbow;
  require_finite(w, w.q + 25, 1, 19);
  require_finite(w, w.v + 24, 1, 19);
  const Real q = Real(w.q[25]);
  const Real c = std::cos(q), s = std::sin(q);
  i.X.E << s, 0.0, c,  //
      c, 0.0, -s,  //
      0.0, 1.0, 0.0;
  i.X.r << 0.0, 0.0, -0.11;
  i.v = i.X * w.j_left_shoulder_yaw.v + joint_velocity<Revolute>(w.v + 24);
}

// A: link "left_upper_arm"; B: the chain of "left_wrist_roll"; C feels the joint at "left_upper_arm"
void assemble_left_elbow(Workspace& w) {
  auto& i = w.j_left_elbow;
  load_torque(w, 19, 24, i.joined.tau);
  const Mat6 X_Phi_A = i.X * kPhi_left_upper_arm;
  const Mat6 Phi_A = from_right(X_Phi_A, i.X);
  const Columns6 c = velocity_product<Revolute>(i.v, w.v + 24);
  constexpr std::array<Real, 6> least{3.679489269776697e-11, 1.197162751551455e-11, 1.197162751551455e-11, 4.139342360189928e-14, 7.884055819642003e-14, 9.209849845550062e-14};
  if (!keeps_digits<Revolute>(Phi_A, w.j_left_wrist_roll.Phi_left_forearm, least))
    fail(w, kGrowth, 19);
  if (!join(i.joined, Phi_A, w.j_left_wrist_roll.Phi_left_forearm, i.X * w.j_left_shoulder_yaw.b, w.j_left_wrist_roll.b_left_forearm, c))
    fail(w, kFactorization, 19);
  couple(i.joined, X_Phi_A, i.at_left_upper_arm);
  i.Phi_left_upper_arm = kPhi_left_upper_arm - product(i.at_left_upper_arm, i.at_left_upper_arm);  // Eq. (3)
  i.b_left_upper_arm = w.j_left_shoulder_yaw.b - bias_change(i.joined, i.at_left_upper_arm);  // Eq. (6)
}

void disassemble_left_elbow(Workspace& w) {
  auto& i = w.j_left_elbow;
  Release<Revolute> release(i.joined);
  release.feel_A(i.at_left_upper_arm, w.j_left_elbow.F_on_left_upper_arm);
  const Columns6 f = release.force();  // Eq. (8), (10)
  store_acceleration(w, 19, 24, release.qdd());  // Eq. (9)
  w.j_left_wrist_roll.F_on_left_forearm = f;
}

// =================================================================================================
// Joint 20 "left_wrist_roll": revolute, between links "left_forearm" and "left_wrist"
// =================================================================================================

void kinematics_left_wrist_roll(Workspace& w) {
  auto& i = w.j_left_wrist_roll;
  require_finite(w, w.q + 26, 1, 20);
  require_finite(w, w.v + 25, 1, 20);
  const Real q = Real(w.q[26]);
  const Real c = std::cos(q), s = std::sin(q);
  i.X.E << 0.0, c, s,  //
      0.0, -s, c,  //
      1.0, 0.0, 0.0;
  i.X.r << -0.16, 0.01, 0.0;
  i.v = i.X * w.j_left_elbow.v + joint_velocity<Revolute>(w.v + 25);
}

// A: link "left_forearm"; B: the chain of "left_wrist_pitch"; C feels the joint at "left_forearm"
void assemble_left_wrist_roll(Workspace& w) {
  auto& i = w.j_left_wrist_roll;
  load_torque(w, 20, 25, i.joined.tau);
  const Mat6 X_Phi_A = i.X * kPhi_left_forearm;
  const Mat6 Phi_A = from_right(X_Phi_A, i.X);
  const Columns6 c = velocity_product<Revolute>(i.v, w.v + 25);
  constexpr std::array<Real, 6> least{1.6766806649289416e-10, 1.6766806649289416e-10, 1.6159511472323679e-10, 1.0775262834713958e-13, 1.0775262834713958e-13, 9.135549459772717e-14};
  if (!keeps_digits<Revolute>(Phi_A, w.j_left_wrist_pitch.Phi_left_wrist, least))
    fail(w, kGrowth, 20);
  if (!join(i.joined, Phi_A, w.j_left_wrist_pitch.Phi_left_wrist, i.X * w.j_left_elbow.b, w.j_left_wrist_pitch.b_left_wrist, c))
    fail(w, kFactorization, 20);
  couple(i.joined, X_Phi_A, i.at_left_forearm);
  i.Phi_left_forearm = kPhi_left_forearm - product(i.at_left_forearm, i.at_left_forearm);  // Eq. (3)
  i.b_left_forearm = w.j_left_elbow.b - bias_change(i.joined, i.at_left_forearm);  // Eq. (6)
}

void disassemble_left_wrist_roll(Workspace& w) {
  auto& i = w.j_left_wrist_roll;
  Release<Revolute> release(i.joined);
  release.feel_A(i.at_left_forearm, w.j_left_wrist_roll.F_on_left_forearm);
  const Columns6 f = release.force();  // Eq. (8), (10)
  store_acceleration(w, 20, 25, release.qdd());  // Eq. (9)
  w.j_left_wrist_pitch.F_on_left_wrist = f;
}

// =================================================================================================
// Joint 21 "left_wrist_pitch": revolute, between links "left_wrist" and "left_hand"
// =================================================================================================

void kinematics_left_wrist_pitch(Workspace& w) {
  auto& i = w.j_left_wrist_pitch;
  require_finite(w, w.q + 27, 1, 21);
  require_finite(w, w.v + 26, 1, 21);
  const Real q = Real(w.q[27]);
  const Real c = std::cos(q), s = std::sin(q);
  i.X.E << s, 0.0, c,  //
      c, 0.0, -s,  //
      0.0, 1.0, 0.0;
  i.X.r << 0.0, 0.0, -0.04;
  i.v = i.X * w.j_left_wrist_roll.v + joint_velocity<Revolute>(w.v + 26);
}

// A: link "left_wrist"; B: link "left_hand"; C feels the joint at "left_wrist"
void assemble_left_wrist_pitch(Workspace& w) {
  auto& i = w.j_left_wrist_pitch;
  load_torque(w, 21, 26, i.joined.tau);
  const Mat6 X_Phi_A = i.X * kPhi_left_wrist;
  const Mat6 Phi_A = from_right(X_Phi_A, i.X);
  const Columns6 c = velocity_product<Revolute>(i.v, w.v + 26);
  constexpr std::array<Real, 6> least{1.0186696105313099e-10, 7.446169233235501e-11, 7.919164165207809e-11, 1.0658141036401503e-13, 1.973963936416274e-13, 1.8036857609062434e-13};
  if (!keeps_digits<Revolute>(Phi_A, kPhi_left_hand, least))
    fail(w, kGrowth, 21);
  if (!join(i.joined, Phi_A, kPhi_left_hand, i.X * w.j_left_wrist_roll.b, w.j_left_wrist_pitch.b, c))
    fail(w, kFactorization, 21);
  couple(i.joined, X_Phi_A, i.at_left_wrist);
  i.Phi_left_wrist = kPhi_left_wrist - product(i.at_left_wrist, i.at_left_wrist);  // Eq. (3)
  i.b_left_wrist = w.j_left_wrist_roll.b - bias_change(i.joined, i.at_left_wrist);  // Eq. (6)
}

void disassemble_left_wrist_pitch(Workspace& w) {
  auto& i = w.j_left_wrist_pitch;
  Release<Revolute> release(i.joined);
  release.feel_A(i.at_left_wrist, w.j_left_wrist_pitch.F_on_left_wrist);
  release.force();  // Eq. (8)
  store_acceleration(w, 21, 26, release.qdd());  // Eq. (9)
}

// =================================================================================================
// Joint 22 "neck_yaw": revolute, between links "torso" and "neck"
// =================================================================================================

void kinematics_neck_yaw(Workspace& w) {
  auto& i = w.j_neck_yaw;
  require_finite(w, w.q + 28, 1, 22);
  require_finite(w, w.v + 27, 1, 22);
  const Real q = Real(w.q[28]);
  const Real c = std::cos(q), s = std::sin(q);
  i.X.E << 0.0, c, s,  //
      0.0, -s, c,  //
      1.0, 0.0, 0.0;
  i.X.r << 0.38, 0.0, 0.0;
  i.v = i.X * w.j_waist_pitch.v + joint_velocity<Revolute>(w.v + 27);
}

// A: the chain of "right_shoulder_pitch"; B: the chain of "neck_pitch"; C feels the joint at "torso"
void assemble_neck_yaw(Workspace& w) {
  auto& i = w.j_neck_yaw;
  load_torque(w, 22, 27, i.joined.tau);
  const Mat6 X_Phi_A = i.X * w.j_right_shoulder_pitch.Phi_torso;
  const Mat6 Phi_A = from_right(X_Phi_A, i.X);
  const Columns6 c = velocity_product<Revolute>(i.v, w.v + 27);
  constexpr std::array<Real, 6> least{6.771160784439214e-11, 6.771160784439214e-11, 7.899006396756834e-11, 6.409131092733334e-14, 6.409131092733334e-14, 3.702301623171048e-14};
  if (!keeps_digits<Revolute>(Phi_A, w.j_neck_pitch.Phi_neck, least))
    fail(w, kGrowth, 22);
  if (!join(i.joined, Phi_A, w.j_neck_pitch.Phi_neck, i.X * w.j_right_shoulder_pitch.b_torso, w.j_neck_pitch.b_neck, c))
    fail(w, kFactorization, 22);
  couple(i.joined, X_Phi_A, i.at_torso);
  i.Phi_torso = w.j_right_shoulder_pitch.Phi_torso - product(i.at_torso, i.at_torso);  // Eq. (3)
  i.b_torso = w.j_right_shoulder_pitch.b_torso - bias_change(i.joined, i.at_torso);  // Eq. (6)
}

void disassemble_neck_yaw(Workspace& w) {
  auto& i = w.j_neck_yaw;
  Release<Revolute> release(i.joined);
  release.feel_A(i.at_torso, w.j_neck_yaw.F_on_torso);
  const Columns6 f = release.force();  // Eq. (8), (10)
  store_acceleration(w, 22, 27, release.qdd());  // Eq. (9)
  w.j_right_shoulder_pitch.F_on_torso = w.j_neck_yaw.F_on_torso - i.X.transposed_times(f);
  w.j_neck_pitch.F_on_neck = f;
}

// =================================================================================================
// Joint 23 "neck_pitch": revolute, between links "neck" and "head"
// =================================================================================================

void kinematics_neck_pitch(Workspace& w) {
  auto& i = w.j_neck_pitch;
  require_finite(w, w.q + 29, 1, 23);
  require_finite(w, w.v + 28, 1, 23);
  const Real q = Real(w.q[29]);
  const Real c = std::cos(q), s = std::sin(q);
  i.X.E << s, 0.0, c,  //
      c, 0.0, -s,  //
      0.0, 1.0, 0.0;
  i.X.r << 0.0, 0.0, 0.06;
  i.v = i.X * w.j_neck_yaw.v + joint_velocity<Revolute>(w.v + 28);
}

// A: link "neck"; B: link "head"; C feels the joint at "neck"
void assemble_neck_pitch(Workspace& w) {
  auto& i = w.j_neck_pitch;
  load_torque(w, 23, 28, i.joined.tau);
  const Mat6 X_Phi_A = i.X * kPhi_neck;
  const Mat6 Phi_A = from_right(X_Phi_A, i.X);
  const Columns6 c = velocity_product<Revolute>(i.v, w.v + 28);
  constexpr std::array<Real, 6> least{2.5512285471221703e-11, 2.5512285471221703e-11, 2.5512285471221703e-11, 4.217933729769319e-14, 5.625129991434126e-14, 5.698231095936195e-14};
  if (!keeps_digits<Revolute>(Phi_A, kPhi_head, least))
    fail(w, kGrowth, 23);
  if (!join(i.joined, Phi_A, kPhi_head, i.X * w.j_neck_yaw.b, w.j_neck_pitch.b, c))
    fail(w, kFactorization, 23);
  couple(i.joined, X_Phi_A, i.at_neck);
  i.Phi_neck = kPhi_neck - product(i.at_neck, i.at_neck);  // Eq. (3)
  i.b_neck = w.j_neck_yaw.b - bias_change(i.joined, i.at_neck);  // Eq. (6)
}

void disassemble_neck_pitch(Workspace& w) {
  auto& i = w.j_neck_pitch;
  Release<Revolute> release(i.joined);
  release.feel_A(i.at_neck, w.j_neck_pitch.F_on_neck);
  release.force();  // Eq. (8)
  store_acceleration(w, 23, 28, release.qdd());  // Eq. (9)
}

// =================================================================================================
// Joint 24 "right_shoulder_pitch": revolute, between links "torso" and "right_shoulder"
// =================================================================================================

void kinematics_right_shoulder_pitch(Workspace& w) {
  auto& i = w.j_right_shoulder_pitch;
  require_finite(w, w.q + 30, 1, 24);
  require_finite(w, w.v + 29, 1, 24);
  const Real q = Real(w.q[30]);
  const Real c = std::cos(q), s = std::sin(q);
  i.X.E << c, s, 0.0,  //
      -s, c, 0.0,  //
      0.0, 0.0, 1.0;
  i.X.r << 0.29, 0.0, -0.15;
  i.v = i.X * w.j_waist_pitch.v + joint_velocity<Revolute>(w.v + 29);
}

// A: link "torso"; B: the chain of "right_shoulder_roll"; C feels the joint at "torso"
void assemble_right_shoulder_pitch(Workspace& w) {
  auto& i = w.j_right_shoulder_pitch;
  load_torque(w, 24, 29, i.joined.tau);
  const Mat6 X_Phi_A = i.X * kPhi_torso;
  const Mat6 Phi_A = from_right(X_Phi_A, i.X);
  const Columns6 c = velocity_product<Revolute>(i.v, w.v + 29);
  constexpr std::array<Real, 6> least{2.2016408306401386e-11, 2.2016408306401386e-11, 2.2245331597838116e-11, 3.903743131866773e-14, 3.903743131866773e-14, 1.9259447837707977e-14};
  if (!keeps_digits<Revolute>(Phi_A, w.j_right_shoulder_roll.Phi_right_shoulder, least))
    fail(w, kGrowth, 24);
  if (!join(i.joined, Phi_A, w.j_right_shoulder_roll.Phi_right_shoulder, i.X * w.j_waist_pitch.b, w.j_right_shoulder_roll.b_right_shoulder, c))
    fail(w, kFactorization, 24);
  couple(i.joined, X_Phi_A, i.at_torso);
  i.Phi_torso = kPhi_torso - product(i.at_torso, i.at_torso);  // Eq. (3)
  i.b_torso = w.j_waist_pitch.b - bias_change(i.joined, i.at_torso);  // Eq. (6)
}

void disassemble_right_shoulder_pitch(Workspace& w) {
  auto& i = w.j_right_shoulder_pitch;
  Release<Revolute> release(i.joined);
  release.feel_A(i.at_torso, w.j_right_shoulder_pitch.F_on_torso);
  const Columns6 f = release.force();  // Eq. (8), (10)
  store_acceleration(w, 24, 29, release.qdd());  // Eq. (9)
  w.j_right_shoulder_roll.F_on_right_shoulder = f;
}

// =================================================================================================
// Joint 25 "right_shoulder_roll": revolute, between links "right_shoulder" and "right_shoulder_cap"
// =================================================================================================

void kinematics_right_shoulder_roll(Workspace& w) {
  auto& i = w.j_right_shoulder_roll;
  require_finite(w, w.q + 31, 1, 25);
  require_finite(w, w.v + 30, 1, 25);
  const Real q = Real(w.q[31]);
  const Real c = std::cos(q), s = std::sin(q);
  i.X.E << s, 0.0, c,  //
      c, 0.0, -s,  //
      0.0, 1.0, 0.0;
  i.X.r << 0.0, 0.0, -0.05;
  i.v = i.X * w.j_right_shoulder_pitch.v + joint_velocity<Revolute>(w.v + 30);
}

// A: link "right_shoulder"; B: the chain of "right_shoulder_yaw"; C feels the joint at "right_shoulder"
void assemble_right_shoulder_roll(Workspace& w) {
  auto& i = w.j_right_shoulder_roll;
  load_torque(w, 25, 30, i.joined.tau);
  const Mat6 X_Phi_A = i.X * kPhi_right_shoulder;
  const Mat6 Phi_A = from_right(X_Phi_A, i.X);
  const Columns6 c = velocity_product<Revolute>(i.v, w.v + 30);
  constexpr std::array<Real, 6> least{2.765166058115282e-11, 2.765166058115282e-11, 2.765166058115282e-11, 5.633588833526509e-14, 4.009491151789137e-14, 5.836601043743681e-14};
  if (!keeps_digits<Revolute>(Phi_A, w.j_right_shoulder_yaw.Phi_right_shoulder_cap, least))
    fail(w, kGrowth, 25);
  if (!join(i.joined, Phi_A, w.j_right_shoulder_yaw.Phi_right_shoulder_cap, i.X * w.j_right_shoulder_pitch.b, w.j_right_shoulder_yaw.b_right_shoulder_cap, c))
    fail(w, kFactorization, 25);
  couple(i.joined, X_Phi_A, i.at_right_shoulder);
  i.Phi_right_shoulder = kPhi_right_shoulder - product(i.at_right_shoulder, i.at_right_shoulder);  // Eq. (3)
  i.b_right_shoulder = w.j_right_shoulder_pitch.b - bias_change(i.joined, i.at_right_shoulder);  // Eq. (6)
}

void disassemble_right_shoulder_roll(Workspace& w) {
  auto& i = w.j_right_shoulder_roll;
  Release<Revolute> release(i.joined);
  release.feel_A(i.at_right_shoulder, w.j_right_shoulder_roll.F_on_right_shoulder);
  const Columns6 f = release.force();  // Eq. (8), (10)
  store_acceleration(w, 25, 30, release.qdd());  // Eq. (9)
  w.j_right_shoulder_yaw.F_on_right_shoulder_cap = f;
}

// =================================================================================================
// Joint 26 "right_shoulder_yaw": revolute, between links "right_shoulder_cap" and "right_upper_arm"
// =================================================================================================

void kinematics_right_shoulder_yaw(Workspace& w) {
  auto& i = w.j_right_shoulder_yaw;
  require_finite(w, w.q + 32, 1, 26);
  require_finite(w, w.v + 31, 1, 26);
  const Real q = Real(w.q[32]);
  const Real c = std::cos(q), s = std::sin(q);
  i.X.E << s, 0.0, c,  //
      c, 0.0, -s,  //
      0.0, 1.0, 0.0;
  i.X.r << 0.0, -0.1, 0.0;
  i.v = i.X * w.j_right_shoulder_roll.v + joint_velocity<Revolute>(w.v + 31);
}

// A: link "right_shoulder_cap"; B: the chain of "right_elbow"; C feels the joint at "right_shoulder_cap"
void assemble_right_shoulder_yaw(Workspace& w) {
  auto& i = w.j_right_shoulder_yaw;
  load_torque(w, 26, 31, i.joined.tau);
  const Mat6 X_Phi_A = i.X * kPhi_right_shoulder_cap;
  const Mat6 Phi_A = from_right(X_Phi_A, i.X);
  const Columns6 c = velocity_product<Revolute>(i.v, w.v + 31);
  constexpr std::array<Real, 6> least{1.550323694931007e-11, 1.550323694931007e-11, 2.8971534166408843e-11, 5.990519760423054e-14, 5.990519760423054e-14, 3.8064789415719656e-14};
  if (!keeps_digits<Revolute>(Phi_A, w.j_right_elbow.Phi_right_upper_arm, least))
    fail(w, kGrowth, 26);
  if (!join(i.joined, Phi_A, w.j_right_elbow.Phi_right_upper_arm, i.X * w.j_right_shoulder_roll.b, w.j_right_elbow.b_right_upper_arm, c))
    fail(w, kFactorization, 26);
  couple(i.joined, X_Phi_A, i.at_right_shoulder_cap);
  i.Phi_right_shoulder_cap = kPhi_right_shoulder_cap - product(i.at_right_shoulder_cap, i.at_right_shoulder_cap);  // Eq. (3)
  i.b_right_shoulder_cap = w.j_right_shoulder_roll.b - bias_change(i.joined, i.at_right_shoulder_cap);  // Eq. (6)
}

void disassemble_right_shoulder_yaw(Workspace& w) {
  auto& i = w.j_right_shoulder_yaw;
  Release<Revolute> release(i.joined);
  release.feel_A(i.at_right_shoulder_cap, w.j_right_shoulder_yaw.F_on_right_shoulder_cap);
  const Columns6 f = release.force();  // Eq. (8), (10)
  store_acceleration(w, 26, 31, release.qdd());  // Eq. (9)
  w.j_right_elbow.F_on_right_upper_arm = f;
}

// =================================================================================================
// Joint 27 "right_elbow": revolute, between links "right_upper_arm" and "right_forearm"
// =================================================================================================

void kinematics_right_elbow(Workspace& w) {
  auto& i = w.j_right_elbow;
  require_finite(w, w.q + 33, 1, 27);
  require_finite(w, w.v + 32, 1, 27);
  const Real q = Real(w.q[33]);
  const Real c = std::cos(q), s = std::sin(q);
  i.X.E << s, 0.0, c,  //
      c, 0.0, -s,  //
      0.0, 1.0, 0.0;
  i.X.r << 0.0, 0.0, -0.11;
  i.v = i.X * w.j_right_shoulder_yaw.v + joint_velocity<Revolute>(w.v + 32);
}

// A: link "right_upper_arm"; B: the chain of "right_wrist_roll"; C feels the joint at "right_upper_arm"
void assemble_right_elbow(Workspace& w) {
  auto& i = w.j_right_elbow;
  load_torque(w, 27, 32, i.joined.tau);
  const Mat6 X_Phi_A = i.X * kPhi_right_upper_arm;
  const Mat6 Phi_A = from_right(X_Phi_A, i.X);
  const Columns6 c = velocity_product<Revolute>(i.v, w.v + 32);
  constexpr std::array<Real, 6> least{3.679489269776697e-11, 1.197162751551455e-11, 1.197162751551455e-11, 4.139342360189928e-14, 7.884055819642003e-14, 9.209849845550062e-14};
  if (!keeps_digits<Revolute>(Phi_A, w.j_right_wrist_roll.Phi_right_forearm, least))
    fail(w, kGrowth, 27);
  if (!join(i.joined, Phi_A, w.j_right_wrist_roll.Phi_right_forearm, i.X * w.j_right_shoulder_yaw.b, w.j_right_wrist_roll.b_right_forearm, c))
    fail(w, kFactorization, 27);
  couple(i.joined, X_Phi_A, i.at_right_upper_arm);
  i.Phi_right_upper_arm = kPhi_right_upper_arm - product(i.at_right_upper_arm, i.at_right_upper_arm);  // Eq. (3)
  i.b_right_upper_arm = w.j_right_shoulder_yaw.b - bias_change(i.joined, i.at_right_upper_arm);  // Eq. (6)
}

void disassemble_right_elbow(Workspace& w) {
  auto& i = w.j_right_elbow;
  Release<Revolute> release(i.joined);
  release.feel_A(i.at_right_upper_arm, w.j_right_elbow.F_on_right_upper_arm);
  const Columns6 f = release.force();  // Eq. (8), (10)
  store_acceleration(w, 27, 32, release.qdd());  // Eq. (9)
  w.j_right_wrist_roll.F_on_right_forearm = f;
}

// =================================================================================================
// Joint 28 "right_wrist_roll": revolute, between links "right_forearm" and "right_wrist"
// =================================================================================================

void kinematics_right_wrist_roll(Workspace& w) {
  auto& i = w.j_right_wrist_roll;
  require_finite(w, w.q + 34, 1, 28);
  require_finite(w, w.v + 33, 1, 28);
  const Real q = Real(w.q[34]);
  const Real c = std::cos(q), s = std::sin(q);
  i.X.E << 0.0, c, s,  //
      0.0, -s, c,  //
      1.0, 0.0, 0.0;
  i.X.r << -0.16, 0.01, 0.0;
  i.v = i.X * w.j_right_elbow.v + joint_velocity<Revolute>(w.v + 33);
}

// A: link "right_forearm"; B: the chain of "right_wrist_pitch"; C feels the joint at "right_forearm"
void assemble_right_wrist_roll(Workspace& w) {
  auto& i = w.j_right_wrist_roll;
  load_torque(w, 28, 33, i.joined.tau);
  const Mat6 X_Phi_A = i.X * kPhi_right_forearm;
  const Mat6 Phi_A = from_right(X_Phi_A, i.X);
  const Columns6 c = velocity_product<Revolute>(i.v, w.v + 33);
  constexpr std::array<Real, 6> least{1.6766806649289416e-10, 1.6766806649289416e-10, 1.6159511472323679e-10, 1.0775262834713958e-13, 1.0775262834713958e-13, 9.135549459772717e-14};
  if (!keeps_digits<Revolute>(Phi_A, w.j_right_wrist_pitch.Phi_right_wrist, least))
    fail(w, kGrowth, 28);
  if (!join(i.joined, Phi_A, w.j_right_wrist_pitch.Phi_right_wrist, i.X * w.j_right_elbow.b, w.j_right_wrist_pitch.b_right_wrist, c))
    fail(w, kFactorization, 28);
  couple(i.joined, X_Phi_A, i.at_right_forearm);
  i.Phi_right_forearm = kPhi_right_forearm - product(i.at_right_forearm, i.at_right_forearm);  // Eq. (3)
  i.b_right_forearm = w.j_right_elbow.b - bias_change(i.joined, i.at_right_forearm);  // Eq. (6)
}

void disassemble_right_wrist_roll(Workspace& w) {
  auto& i = w.j_right_wrist_roll;
  Release<Revolute> release(i.joined);
  release.feel_A(i.at_right_forearm, w.j_right_wrist_roll.F_on_right_forearm);
  const Columns6 f = release.force();  // Eq. (8), (10)
  store_acceleration(w, 28, 33, release.qdd());  // Eq. (9)
  w.j_right_wrist_pitch.F_on_right_wrist = f;
}

// =================================================================================================
// Joint 29 "right_wrist_pitch": revolute, between links "right_wrist" and "right_hand"
// =================================================================================================

void kinematics_right_wrist_pitch(Workspace& w) {
  auto& i = w.j_right_wrist_pitch;
  require_finite(w, w.q + 35, 1, 29);
  require_finite(w, w.v + 34, 1, 29);
  const Real q = Real(w.q[35]);
  const Real c = std::cos(q), s = std::sin(q);
  i.X.E << s, 0.0, c,  //
      c, 0.0, -s,  //
      0.0, 1.0, 0.0;
  i.X.r << 0.0, 0.0, -0.04;
  i.v = i.X * w.j_right_wrist_roll.v + joint_velocity<Revolute>(w.v + 34);
}

// A: link "right_wrist"; B: link "right_hand"; C feels the joint at "right_wrist"
void assemble_right_wrist_pitch(Workspace& w) {
  auto& i = w.j_right_wrist_pitch;
  load_torque(w, 29, 34, i.joined.tau);
  const Mat6 X_Phi_A = i.X * kPhi_right_wrist;
  const Mat6 Phi_A = from_right(X_Phi_A, i.X);
  const Columns6 c = velocity_product<Revolute>(i.v, w.v + 34);
  constexpr std::array<Real, 6> least{1.0186696105313099e-10, 7.446169233235501e-11, 7.919164165207809e-11, 1.0658141036401503e-13, 1.973963936416274e-13, 1.8036857609062434e-13};
  if (!keeps_digits<Revolute>(Phi_A, kPhi_right_hand, least))
    fail(w, kGrowth, 29);
  if (!join(i.joined, Phi_A, kPhi_right_hand, i.X * w.j_right_wrist_roll.b, w.j_right_wrist_pitch.b, c))
    fail(w, kFactorization, 29);
  couple(i.joined, X_Phi_A, i.at_right_wrist);
  i.Phi_right_wrist = kPhi_right_wrist - product(i.at_right_wrist, i.at_right_wrist);  // Eq. (3)
  i.b_right_wrist = w.j_right_wrist_roll.b - bias_change(i.joined, i.at_right_wrist);  // Eq. (6)
}

void disassemble_right_wrist_pitch(Workspace& w) {
  auto& i = w.j_right_wrist_pitch;
  Release<Revolute> release(i.joined);
  release.feel_A(i.at_right_wrist, w.j_right_wrist_pitch.F_on_right_wrist);
  release.force();  // Eq. (8)
  store_acceleration(w, 29, 34, release.qdd());  // Eq. (9)
}


// ---- 5. processes -------------------------------------------------------------------------------

// Process 0: 14 of 30 joints: "__base__", "left_hip_pitch", "left_hip_roll", "left_hip_yaw", "left_knee", "left_ankle_pitch", ...
void run_0([[maybe_unused]] Workspace& w, [[maybe_unused]] Channel& channel) {
  w.ground = ground(w);
  stamp(0);
  kinematics_base(w);
  kinematics_left_hip_pitch(w);
  kinematics_left_hip_roll(w);
  kinematics_left_hip_yaw(w);
  kinematics_left_knee(w);
  kinematics_left_ankle_pitch(w);
  kinematics_left_ankle_roll(w);
  kinematics_right_hip_pitch(w);
  kinematics_right_hip_roll(w);
  kinematics_right_hip_yaw(w);
  kinematics_right_knee(w);
  kinematics_right_ankle_pitch(w);
  kinematics_right_ankle_roll(w);
  kinematics_waist_yaw(w);
  stamp(1);
  link_bias(kLinks[12], w.j_right_ankle_pitch.v, w.j_right_ankle_pitch.b);
  link_bias(kLinks[13], w.j_right_ankle_roll.v, w.j_right_ankle_roll.b);
  assemble_right_ankle_roll(w);
  link_bias(kLinks[11], w.j_right_knee.v, w.j_right_knee.b);
  assemble_right_ankle_pitch(w);
  link_bias(kLinks[10], w.j_right_hip_yaw.v, w.j_right_hip_yaw.b);
  assemble_right_knee(w);
  link_bias(kLinks[9], w.j_right_hip_roll.v, w.j_right_hip_roll.b);
  assemble_right_hip_yaw(w);
  link_bias(kLinks[8], w.j_right_hip_pitch.v, w.j_right_hip_pitch.b);
  assemble_right_hip_roll(w);
  link_bias(kLinks[1], w.j_base.v, w.j_base.b);
  assemble_right_hip_pitch(w);
  link_bias(kLinks[6], w.j_left_ankle_pitch.v, w.j_left_ankle_pitch.b);
  link_bias(kLinks[7], w.j_left_ankle_roll.v, w.j_left_ankle_roll.b);
  assemble_left_ankle_roll(w);
  link_bias(kLinks[5], w.j_left_knee.v, w.j_left_knee.b);
  assemble_left_ankle_pitch(w);
  link_bias(kLinks[4], w.j_left_hip_yaw.v, w.j_left_hip_yaw.b);
  assemble_left_knee(w);
  link_bias(kLinks[3], w.j_left_hip_roll.v, w.j_left_hip_roll.b);
  assemble_left_hip_yaw(w);
  link_bias(kLinks[2], w.j_left_hip_pitch.v, w.j_left_hip_pitch.b);
  assemble_left_hip_roll(w);
  assemble_left_hip_pitch(w);
  assemble_base(w);
  stamp(2);
  {  // from process 1: assembled: chain of "waist_roll"
    const Number* from = channel.receive(1, w.status);
    from = get(from, w.j_waist_roll.Phi_waist_link);
    from = get(from, w.j_waist_roll.b_waist_link);
  }
  stamp(3);
  assemble_waist_yaw(w);
  stamp(4);
  disassemble_waist_yaw(w);
  stamp(5);
  {  // to process 1: forces on: chain of "waist_roll"
    Number* to = channel.outgoing(2, w.status);
    to = put(to, w.j_waist_roll.F_on_waist_link);
    channel.send(2, w.status);
  }
  stamp(6);
  disassemble_base(w);
  disassemble_left_hip_pitch(w);
  disassemble_right_hip_pitch(w);
  disassemble_right_hip_roll(w);
  disassemble_right_hip_yaw(w);
  disassemble_right_knee(w);
  disassemble_right_ankle_pitch(w);
  disassemble_right_ankle_roll(w);
  disassemble_left_hip_roll(w);
  disassemble_left_hip_yaw(w);
  disassemble_left_knee(w);
  disassemble_left_ankle_pitch(w);
  disassemble_left_ankle_roll(w);
  stamp(7);
}

// Process 1: 11 of 30 joints: "waist_roll", "waist_pitch", "left_shoulder_pitch", "neck_yaw", "neck_pitch", "right_shoulder_pitch", ...; kinematics of 2 more on the way to the ground
void run_1([[maybe_unused]] Workspace& w, [[maybe_unused]] Channel& channel) {
  w.ground = ground(w);
  stamp(0);
  kinematics_base(w);
  kinematics_waist_yaw(w);
  kinematics_waist_roll(w);
  kinematics_waist_pitch(w);
  kinematics_left_shoulder_pitch(w);
  kinematics_neck_yaw(w);
  kinematics_neck_pitch(w);
  kinematics_right_shoulder_pitch(w);
  kinematics_right_shoulder_roll(w);
  kinematics_right_shoulder_yaw(w);
  kinematics_right_elbow(w);
  kinematics_right_wrist_roll(w);
  kinematics_right_wrist_pitch(w);
  stamp(1);
  link_bias(kLinks[29], w.j_right_wrist_roll.v, w.j_right_wrist_roll.b);
  link_bias(kLinks[30], w.j_right_wrist_pitch.v, w.j_right_wrist_pitch.b);
  assemble_right_wrist_pitch(w);
  link_bias(kLinks[28], w.j_right_elbow.v, w.j_right_elbow.b);
  assemble_right_wrist_roll(w);
  link_bias(kLinks[27], w.j_right_shoulder_yaw.v, w.j_right_shoulder_yaw.b);
  assemble_right_elbow(w);
  link_bias(kLinks[26], w.j_right_shoulder_roll.v, w.j_right_shoulder_roll.b);
  assemble_right_shoulder_yaw(w);
  link_bias(kLinks[25], w.j_right_shoulder_pitch.v, w.j_right_shoulder_pitch.b);
  assemble_right_shoulder_roll(w);
  link_bias(kLinks[16], w.j_waist_pitch.v, w.j_waist_pitch.b);
  assemble_right_shoulder_pitch(w);
  link_bias(kLinks[23], w.j_neck_yaw.v, w.j_neck_yaw.b);
  link_bias(kLinks[24], w.j_neck_pitch.v, w.j_neck_pitch.b);
  assemble_neck_pitch(w);
  assemble_neck_yaw(w);
  stamp(2);
  {  // from process 2: assembled: chain of "left_shoulder_roll"
    const Number* from = channel.receive(0, w.status);
    from = get(from, w.j_left_shoulder_roll.Phi_left_shoulder);
    from = get(from, w.j_left_shoulder_roll.b_left_shoulder);
  }
  stamp(3);
  assemble_left_shoulder_pitch(w);
  link_bias(kLinks[15], w.j_waist_roll.v, w.j_waist_roll.b);
  assemble_waist_pitch(w);
  link_bias(kLinks[14], w.j_waist_yaw.v, w.j_waist_yaw.b);
  assemble_waist_roll(w);
  stamp(4);
  {  // to process 0: assembled: chain of "waist_roll"
    Number* to = channel.outgoing(1, w.status);
    to = put(to, w.j_waist_roll.Phi_waist_link);
    to = put(to, w.j_waist_roll.b_waist_link);
    channel.send(1, w.status);
  }
  stamp(5);
  {  // from process 0: forces on: chain of "waist_roll"
    const Number* from = channel.receive(2, w.status);
    from = get(from, w.j_waist_roll.F_on_waist_link);
  }
  stamp(6);
  disassemble_waist_roll(w);
  disassemble_waist_pitch(w);
  disassemble_left_shoulder_pitch(w);
  stamp(7);
  {  // to process 2: forces on: chain of "left_shoulder_roll"
    Number* to = channel.outgoing(3, w.status);
    to = put(to, w.j_left_shoulder_roll.F_on_left_shoulder);
    channel.send(3, w.status);
  }
  stamp(8);
  disassemble_neck_yaw(w);
  disassemble_right_shoulder_pitch(w);
  disassemble_right_shoulder_roll(w);
  disassemble_right_shoulder_yaw(w);
  disassemble_right_elbow(w);
  disassemble_right_wrist_roll(w);
  disassemble_right_wrist_pitch(w);
  disassemble_neck_pitch(w);
  stamp(9);
}

// Process 2: 5 of 30 joints: "left_shoulder_roll", "left_shoulder_yaw", "left_elbow", "left_wrist_roll", "left_wrist_pitch"; kinematics of 5 more on the way to the ground
void run_2([[maybe_unused]] Workspace& w, [[maybe_unused]] Channel& channel) {
  w.ground = ground(w);
  stamp(0);
  kinematics_base(w);
  kinematics_waist_yaw(w);
  kinematics_waist_roll(w);
  kinematics_waist_pitch(w);
  kinematics_left_shoulder_pitch(w);
  kinematics_left_shoulder_roll(w);
  kinematics_left_shoulder_yaw(w);
  kinematics_left_elbow(w);
  kinematics_left_wrist_roll(w);
  kinematics_left_wrist_pitch(w);
  stamp(1);
  link_bias(kLinks[21], w.j_left_wrist_roll.v, w.j_left_wrist_roll.b);
  link_bias(kLinks[22], w.j_left_wrist_pitch.v, w.j_left_wrist_pitch.b);
  assemble_left_wrist_pitch(w);
  link_bias(kLinks[20], w.j_left_elbow.v, w.j_left_elbow.b);
  assemble_left_wrist_roll(w);
  link_bias(kLinks[19], w.j_left_shoulder_yaw.v, w.j_left_shoulder_yaw.b);
  assemble_left_elbow(w);
  link_bias(kLinks[18], w.j_left_shoulder_roll.v, w.j_left_shoulder_roll.b);
  assemble_left_shoulder_yaw(w);
  link_bias(kLinks[17], w.j_left_shoulder_pitch.v, w.j_left_shoulder_pitch.b);
  assemble_left_shoulder_roll(w);
  stamp(2);
  {  // to process 1: assembled: chain of "left_shoulder_roll"
    Number* to = channel.outgoing(0, w.status);
    to = put(to, w.j_left_shoulder_roll.Phi_left_shoulder);
    to = put(to, w.j_left_shoulder_roll.b_left_shoulder);
    channel.send(0, w.status);
  }
  stamp(3);
  {  // from process 1: forces on: chain of "left_shoulder_roll"
    const Number* from = channel.receive(3, w.status);
    from = get(from, w.j_left_shoulder_roll.F_on_left_shoulder);
  }
  stamp(4);
  disassemble_left_shoulder_roll(w);
  disassemble_left_shoulder_yaw(w);
  disassemble_left_elbow(w);
  disassemble_left_wrist_roll(w);
  disassemble_left_wrist_pitch(w);
  stamp(5);
}

[[maybe_unused]] constexpr std::array<void (*)(Workspace&, Channel&), kProcesses> kRun{run_0, run_1, run_2};

// What each process reads of q and v, the velocity entries whose qdd is its own, and whose tau it
// reads.
constexpr std::array<Range, 1> kReadQ_0{ {{0, 20}} };
constexpr std::array<Range, 1> kReadV_0{ {{0, 19}} };
constexpr std::array<Range, 1> kOwn_0{ {{0, 19}} };
constexpr std::array<Range, 1> kTorque_0{ {{0, 19}} };
constexpr std::array<Range, 3> kReadQ_1{ {{0, 7}, {19, 4}, {28, 8}} };
constexpr std::array<Range, 3> kReadV_1{ {{0, 6}, {18, 4}, {27, 8}} };
constexpr std::array<Range, 2> kOwn_1{ {{19, 3}, {27, 8}} };
constexpr std::array<Range, 2> kTorque_1{ {{19, 3}, {27, 8}} };
constexpr std::array<Range, 2> kReadQ_2{ {{0, 7}, {19, 9}} };
constexpr std::array<Range, 2> kReadV_2{ {{0, 6}, {18, 9}} };
constexpr std::array<Range, 1> kOwn_2{ {{22, 5}} };
constexpr std::array<Range, 1> kTorque_2{ {{22, 5}} };
[[maybe_unused]] constexpr std::array<ProcessInfo, kProcesses> kProcess{ {
    {{1, kReadQ_0.data()}, {1, kReadV_0.data()}, {1, kOwn_0.data()}, {1, kTorque_0.data()}},
    {{3, kReadQ_1.data()}, {3, kReadV_1.data()}, {2, kOwn_1.data()}, {2, kTorque_1.data()}},
    {{2, kReadQ_2.data()}, {2, kReadV_2.data()}, {1, kOwn_2.data()}, {1, kTorque_2.data()}},
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

// The entries of a vector that a process needs, one after another, and back.
inline Number* pack(Number* to, const Ranges& which, const Number* x) {
  for (int k = 0; k < which.count; ++k)
    to = std::copy_n(x + which.ranges[k].first, which.ranges[k].count, to);
  return to;
}
inline const Number* unpack(const Number* from, const Ranges& which, Number* x) {
  for (int k = 0; k < which.count; ++k) {
    const auto& [first, count] = which.ranges[k];
    std::copy_n(from, count, x + first);
    from += count;
  }
  return from;
}

// Hands states and accelerations between process 0 and the others. Messages behind the plan's own:
// first the state to each process, then the accelerations from each.
class Solver : public InPlace {
 public:
  // Everything through process 0: it has the state and gets all accelerations.
  int solve_at_root(const Number* q, const Number* v, const Number* tau, Number* qdd) {
    if constexpr (kAlone) return solve(q, v, tau, qdd);
    if (channel.broken()) return finish(failure(kNoAnswer, 0));
    return channel.rank() == 0 ? solve_as_root(q, v, tau, qdd) : solve_for_root();
  }

  // At process 0: the others' next solve_at_root returns kEnded, and so does this.
  int end_at_root() {
    if constexpr (kAlone) return kFine;
    return solve_as_root(q_.data(), v_.data(), tau_.data(), qdd_.data(), failure(kEnded, 0));
  }

  // At the others: takes part in what process 0 evaluates until it ends that.
  int serve() {
    const int rank = channel.rank();
    if (rank == 0) return kFine;
    int status = kFine;
    if (has_part(rank)) do
        status = channel.broken() ? failure(kNoAnswer, 0) : solve_for_root(true);
      while (failure_kind(status) != kEnded && failure_kind(status) != kNoAnswer);
    else
      channel.await_end();
    return failure_kind(status) == kEnded ? kFine : finish(status);
  }

  // Collective.
  void close() { channel.close(); }

  // At process 0: the others serve no longer.
  int end() {
    if (channel.rank() != 0) return kFine;
    const int status = end_at_root();
    for (int p = 1; p < kProcesses; ++p)
      if (!has_part(p)) channel.send_end(p);
    return failure_kind(status) == kEnded ? kFine : finish(status);
  }

 private:
  // Whether a process takes part when all goes through process 0.
  static bool has_part(int p) {
    return !kAlone && kProcess[static_cast<std::size_t>(p)].own.count > 0;
  }

  // patient: however long process 0 lets it wait.
  int solve_for_root(bool patient = false) {
    const int rank = channel.rank();
    const ProcessInfo& own = kProcess[static_cast<std::size_t>(rank)];
    if (own.own.count == 0) return finish(kFine);
    int status = kFine;
    const Number* content = channel.receive(state_message(rank), status, patient);
    content = unpack(content, own.q, q_.data());
    content = unpack(content, own.v, v_.data());
    content = unpack(content, own.tau, tau_.data());
    unpack_parameters(content, w);
    prepare(q_.data(), v_.data(), tau_.data(), qdd_.data());
    Channel::fail(w.status, status);
    run();
    Number* result = channel.outgoing(result_message(rank), w.status);
    pack(result, own.own, qdd_.data());
    channel.send(result_message(rank), w.status);
    return finish(w.status);
  }

  int solve_as_root(const Number* q, const Number* v, const Number* tau, Number* qdd,
                    int status = kFine) {
    for (int p = 1; p < kProcesses; ++p) {
      const ProcessInfo& other = kProcess[static_cast<std::size_t>(p)];
      if (other.own.count == 0) continue;
      Number* content = channel.outgoing(state_message(p), status);
      content = pack(content, other.q, q);
      content = pack(content, other.v, v);
      content = pack(content, other.tau, tau);
      pack_parameters(content, w);
      channel.send(state_message(p), status);
    }
    prepare(q, v, tau, qdd_.data());
    Channel::fail(w.status, status);
    run();
    for (int p = 1; p < kProcesses; ++p) {
      const ProcessInfo& other = kProcess[static_cast<std::size_t>(p)];
      if (other.own.count == 0) continue;
      const Number* result = channel.receive(result_message(p), w.status);
      unpack(result, other.own, qdd_.data());
    }
    if (w.status == kFine) std::copy(qdd_.begin(), qdd_.end(), qdd);
    return finish(w.status);
  }

  static int state_message(int process) { return kPlanMessages + 2 * (process - 1); }
  static int result_message(int process) { return kPlanMessages + 2 * (process - 1) + 1; }

  std::array<Number, kNq> q_{};
  std::array<Number, kNv> v_{};
  std::array<Number, kNqdd> qdd_{};
  std::array<Number, kNtau> tau_{};
};

}  // namespace

static_assert(HUMANOID_P3_NQ == kNq && HUMANOID_P3_NV == kNv && HUMANOID_P3_NTAU == kNtau);
static_assert(int(HUMANOID_P3_FINE) == int(kFine));
static_assert(int(HUMANOID_P3_NOT_FINITE) == int(kNotFinite));
static_assert(int(HUMANOID_P3_ZERO_QUATERNION) == int(kZeroQuaternion));
static_assert(int(HUMANOID_P3_FACTORIZATION) == int(kFactorization));
static_assert(int(HUMANOID_P3_OVERFLOW) == int(kOverflow));
static_assert(int(HUMANOID_P3_NO_ANSWER) == int(kNoAnswer));
static_assert(int(HUMANOID_P3_ENDED) == int(kEnded));
static_assert(int(HUMANOID_P3_NOT_REFINED) == int(kNotRefined));
static_assert(int(HUMANOID_P3_GIMBAL_LOCK) == int(kGimbalLock));
static_assert(int(HUMANOID_P3_GROWTH) == int(kGrowth));
static_assert(int(HUMANOID_P3_NOT_SET) == int(kNotSet));
static_assert(int(HUMANOID_P3_TOO_FEW_STEPS) == int(kTooFewSteps));
static_assert(int(HUMANOID_P3_LOOP_OPEN) == int(kLoopOpen));
static_assert(int(HUMANOID_P3_LOOP_TORN) == int(kLoopTorn));
static_assert(int(HUMANOID_P3_LOOP_SINGULAR) == int(kLoopSingular));
static_assert(int(HUMANOID_P3_LOOP_FREE) == int(kLoopFree));

struct humanoid_p3_solver : Solver {};

namespace {

// Why the last open of a thread gave no solver.
thread_local Text open_failure;

// What is wrong with what was asked for; an empty string for nothing.
inline std::string why_not_open(MPI_Comm comm, const std::string& kind, double time_limit) {
  int ready = 0, size = 0;
  MPI_Initialized(&ready);
  if (ready == 0) return "MPI is not initialised: call MPI_Init first";
  MPI_Comm_size(comm, &size);
  if (size != kProcesses)
    return "this solver is for exactly " + std::to_string(kProcesses) +
           " processes, the communicator has " + std::to_string(size);
  if (kind != "auto" && kind != "window" && kind != "message")
    return "channel takes auto, window or message, not " + kind;
  return time_limit > 0 ? "" : "the time limit must be more than 0 s";
}

inline ChannelMode mode_of(const std::string& kind) {
  return kind == "window"    ? ChannelMode::kWindow
         : kind == "message" ? ChannelMode::kMessage
                             : ChannelMode::kAuto;
}

template <class AnySolver>
AnySolver* opened(MPI_Comm comm, const char* channel, double time_limit) {
  open_failure.clear();
  try {
    const std::string kind = channel == nullptr ? "auto" : channel;
    std::string wrong = why_not_open(comm, kind, time_limit);
    if (wrong.empty()) {
      auto solver = std::make_unique<AnySolver>();
      wrong = solver->channel.open(comm, mode_of(kind), time_limit);
      if (wrong.empty()) return solver.release();
      solver->channel.close();
    }
    open_failure += wrong.c_str();
  } catch (const std::exception& error) {
    open_failure += error.what();
  }
  return nullptr;
}

}  // namespace

extern "C" {

int humanoid_p3_joint(int k, const char** name, int* q, int* nq, int* v, int* nv) {
  if (k < 0 || k >= kJointCount) return 0;
  const JointConstants& joint = kJoints[k];
  *name = joint.name, *q = joint.q, *nq = joint.nq, *v = joint.v, *nv = joint.nv;
  return 1;
}

humanoid_p3_solver* humanoid_p3_open(MPI_Comm comm, const char* channel, double time_limit) {
  return opened<humanoid_p3_solver>(comm, channel, time_limit);
}

int humanoid_p3_solve(humanoid_p3_solver* solver, const double* q, const double* v, const double* tau, double* qdd) {
  return solver->solve(q, v, tau, qdd);
}

int humanoid_p3_solve_at_root(humanoid_p3_solver* solver, const double* q, const double* v, const double* tau, double* qdd) {
  return solver->solve_at_root(q, v, tau, qdd);
}

int humanoid_p3_serve(humanoid_p3_solver* solver) { return solver->serve(); }

int humanoid_p3_end(humanoid_p3_solver* solver) { return solver->end(); }

int humanoid_p3_reason(int status) { return failure_kind(status); }

int humanoid_p3_failed_joint(int status) { return is_of_joint(failure_kind(status)) ? failure_place(status) : -1; }

const char* humanoid_p3_failure(const humanoid_p3_solver* solver) {
  return solver == nullptr ? open_failure.c_str() : solver->text.c_str();
}

void humanoid_p3_close(humanoid_p3_solver* solver) {
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
  int processes, threads, nq, nv, ntau, nqdd, refine;
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

// What is measured (--time, --stretches), of several processes.
using Clock = std::chrono::steady_clock;

Text open_solver(Solver& solver, MPI_Comm comm, const adagen::Opening& how) {
  const std::string wrong =
      solver.channel.open(comm, mode_of(how.channel), how.time_limit, how.hosts);
  return Text(wrong.c_str());
}

// All processes that take part in an evaluation start it at the same instant of their common clock;
// hosts have none. One alone starts at once: to meet others that it does not need would only cool
// its caches.
Clock::time_point start_together(const Channel& channel) {
  if (kAlone) return Clock::now();
  if (!channel.on_one_host()) {
    MPI_Barrier(channel.comm());
    return Clock::now();
  }
  Clock::rep start = 0;
  if (channel.rank() == 0)
    start = (Clock::now() + std::chrono::microseconds(5)).time_since_epoch().count();
  MPI_Bcast(&start, static_cast<int>(sizeof start), MPI_BYTE, 0, channel.comm());
  const Clock::time_point at{Clock::duration(start)};
  const Clock::time_point latest = Clock::now() + std::chrono::microseconds(50);
  Clock::time_point now;
  while ((now = Clock::now()) < at && now < latest) relax();
  return now;
}

// The same where an evaluation has just ended.
Clock::time_point start_again(const Channel& channel) {
  if (!kAlone) MPI_Barrier(channel.comm());
  return Clock::now();
}

// Evaluations whose messages are noted once, and played as often as asked for.
class Takes {
 public:
  void forget(int count) { takes_.assign(static_cast<std::size_t>(count), Take()); }

  template <class Evaluate>
  int record(Channel& channel, int k, Evaluate evaluate) {
    Take& take = takes_[static_cast<std::size_t>(k)];
    take.record();
    channel.use(&take);
    const int status = evaluate();
    channel.use(nullptr);
    return status;
  }

  // looks: at the clock, at the start, at each message and at the end.
  template <class Evaluate>
  void play(Channel& channel, int k, Clock::rep* looks, Evaluate evaluate) {
    Take& take = takes_[static_cast<std::size_t>(k)];
    take.play();
    channel.use(&take);
    const Clock::rep start = Clock::now().time_since_epoch().count();
    evaluate();
    const Clock::rep end = Clock::now().time_since_epoch().count();
    channel.use(nullptr);
    *looks = start;
    *std::copy(take.looks().begin(), take.looks().end(), looks + 1) = end;
  }

  adagen::Table<int> messages(int k) const {
    const std::vector<int>& found = takes_[static_cast<std::size_t>(k)].messages();
    return {found.data(), static_cast<int>(found.size())};
  }

 private:
  std::vector<Take> takes_;
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

class ThisSolver final : public adagen::AnySolver<Number, MPI_Comm> {
 public:
  const char* open(MPI_Comm comm, const adagen::Opening& how) override {
    words_ = open_solver(solver_, comm, how);
    return words_.c_str();
  }
  void close() override { solver_.close(); }
  MPI_Comm comm() const override { return solver_.channel.comm(); }
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
constexpr std::array<adagen::Stage, 7> kStages_0{ {
    {"kinematics", 13, -1},
    {"assembly", 0, -1},
    {"receive", -1, 1},
    {"assembly", 13, -1},
    {"disassembly", 13, -1},
    {"send", -1, 2},
    {"disassembly", 0, -1},
} };
constexpr std::array<adagen::Stage, 9> kStages_1{ {
    {"kinematics", 29, -1},
    {"assembly", 22, -1},
    {"receive", -1, 0},
    {"assembly", 14, -1},
    {"send", -1, 1},
    {"receive", -1, 2},
    {"disassembly", 14, -1},
    {"send", -1, 3},
    {"disassembly", 22, -1},
} };
constexpr std::array<adagen::Stage, 5> kStages_2{ {
    {"kinematics", 21, -1},
    {"assembly", 17, -1},
    {"send", -1, 0},
    {"receive", -1, 3},
    {"disassembly", 17, -1},
} };
constexpr std::array<adagen::Table<adagen::Stage>, kProcesses> kStages{ {
    {kStages_0.data(), 7},
    {kStages_1.data(), 9},
    {kStages_2.data(), 5},
} };

// As the cost profile default has them.
constexpr adagen::Hop kWindowHop{0, 159, 0.437};
constexpr adagen::Hop kMessageHop{26, 228, 0.644};

}  // namespace

// Compiled for size: it runs once.
[[gnu::cold]] int main(int count, char** words) {
  const adagen::Description<Number> description{
      "humanoid", "auto", kProcesses, 1, kNq, kNv, kNtau, kNqdd, kRefine,
      true, kAlone, kBatch, false, kTolerance, kGravity.data(),
      table(kJoints), table(kLinks), table(kOuterForces), {}, {}, table(kMessages), kStages.data(), kWindowHop,
      kMessageHop};
  auto* const solver = new ThisSolver;
  const int status = adagen::program(description, *solver, count, words);
  delete solver;
  return status;
}
#endif  // ADAGEN_NO_MAIN
