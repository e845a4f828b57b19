// Forward dynamics of "humanoid" on 2 processes, emitted by adagen 0.1.0 (solver.cpp.j2). Do not edit: emit anew.
//
// robot     "humanoid", 30 joints, 35 degrees of freedom, description sha256 d573a89307ddd4ee9018ee9a0a94422a3db0c5f61f2798648f53f0e1b57ee437
// options   form segment, shape unrolled, scalar double, channel auto, floating base, gravity 0.0, 0.0, -9.81
// program   2 processes, gathered at torso; 0.42 us predicted (default profile)
//           process 0: left_hip_pitch .. left_ankle_roll | right_hip_pitch .. right_ankle_roll in 2
//           lanes, __base__, waist_yaw .. waist_pitch
//           process 1: left_shoulder_pitch .. left_wrist_pitch | right_shoulder_pitch ..
//           right_wrist_pitch in 2 lanes, neck_yaw .. neck_pitch
// licence   yours to choose: what adagen emits belongs to whoever emits it
//
// Each process sweeps its own limbs by the articulated-body algorithm: I^A and p^A, a link's inertia and
// bias force with all that hangs on it. Processes meet once: each tells the others the I^A and p^A that
// it found at the links where limbs of several processes meet. What lies between those links, up to the
// root, every process then sweeps for itself, solves for the root's acceleration and goes outwards again
// through its own limbs. Spatial vectors are [angular; linear], in link frames turned so that every joint
// axis is z.
//
// How to read on:
//   1. interface   what a program that links this file calls
//   2. model       the robot's constants
//   3. runtime     spatial algebra, joints, exchange between processes
//   4. joints      for each joint its memory, then what is done with it, step by step
//   5. processes   who does what, in order
//   6. program     states in, accelerations out; check; time

#include <mpi.h>

// ---- 1. interface -------------------------------------------------------------------------------
// To use it from a program of yours: compile this file with -DADAGEN_NO_MAIN, link it, and get these
// declarations by including it with ADAGEN_DECLARATIONS defined.
#ifdef __cplusplus
extern "C" {
#endif
typedef struct humanoid_p2_solver humanoid_p2_solver;

// Joints in order, each with its place in the state: humanoid_p2_joint gives name, start and size in q
// and v of joint k, or returns 0 where there is none.
int humanoid_p2_joint(int k, const char** name, int* q, int* nq, int* v, int* nv);

// Collective over a communicator of 2 processes. channel: "auto", "window" or "message";
// time_limit: seconds that a process waits for another. Returns null where it cannot be done.
humanoid_p2_solver* humanoid_p2_open(MPI_Comm comm, const char* channel, double time_limit);

// One evaluation, collective. q: 36 numbers, v and tau: 35 each, qdd: 35; joints in order,
// quaternions x y z w (normalised here), floating joints [linear; angular] in the body's frame.
// solve: every process passes the state and gets its own joints' accelerations (others untouched);
// solve_at_root: process 0 passes the state and gets them all, the others may pass null.
// Returns 0, or what humanoid_p2_failure puts into words; no acceleration is written then.
int humanoid_p2_solve(humanoid_p2_solver* solver, const double* q, const double* v, const double* tau, double* qdd);
int humanoid_p2_solve_at_root(humanoid_p2_solver* solver, const double* q, const double* v, const double* tau, double* qdd);

// The last failure in words; valid until the next call.
const char* humanoid_p2_failure(const humanoid_p2_solver* solver);

// Collective.
void humanoid_p2_close(humanoid_p2_solver* solver);
#ifdef __cplusplus
}
#endif
#ifndef ADAGEN_DECLARATIONS

#include <algorithm>
#include <array>
#include <atomic>
#include <charconv>
#include <chrono>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <fstream>
#include <iterator>
#include <limits>
#include <memory>
#include <new>
#include <sstream>
#include <stdexcept>
#include <string>
#include <thread>
#include <type_traits>
#include <utility>
#include <vector>
#if defined(__linux__)
#include <sched.h>
#endif
#if defined(__unix__) || defined(__APPLE__)
#include <sys/time.h>
#include <unistd.h>

#include <csignal>
#endif

#define ADAGEN_NOINLINE [[maybe_unused]] __attribute__((noinline))
#define ADAGEN_HOT [[gnu::hot]] ADAGEN_NOINLINE  // called in each step of a simulation; main is cold
// A counted loop that is to be unrolled whole, so that indices computed in it become constants.
#if defined(__clang__)
#define ADAGEN_FOR(k, first, last) _Pragma("clang loop unroll(full)") for (int k = first; k < last; ++k)
#else
#define ADAGEN_FOR(k, first, last) _Pragma("GCC unroll 16") for (int k = first; k < last; ++k)
#endif

namespace {

using Number = double;  // of states, answers and messages
using Real = double;    // of all between
constexpr int kProcesses = 2;
constexpr int kJointCount = 30, kLinkCount = kJointCount + 1;
constexpr int kNq = 36, kNv = 35;
constexpr int kOuterCount = 0, kNtau = kNv + 6 * kOuterCount;
[[maybe_unused]] constexpr int kColumns = 1;  // right-hand sides: the motion, and one per slaved joint
[[maybe_unused]] constexpr bool kBatch = false;  // whether many states are solved at once
[[maybe_unused]] constexpr int kRefine = 0;  // steps of iterative refinement
[[maybe_unused]] constexpr int kPlanMessages = 2;
constexpr std::size_t kCacheLine = 64;
[[maybe_unused]] constexpr bool kFloatingBase = true;
[[maybe_unused]] constexpr double kTolerance = 1e-09;
[[maybe_unused]] constexpr int kRandomStates = 64;
[[maybe_unused]] constexpr const char* kRobot = "humanoid";
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
template <class Number>
void slave([[maybe_unused]] Number* q, [[maybe_unused]] Number* v) {
  for (const JointConstants& joint : kJoints) {
    if (joint.source < 0) continue;
    const JointConstants& source = kJoints[static_cast<std::size_t>(joint.source)];
    q[joint.q] = static_cast<Number>(joint.multiplier * double(q[source.q]) + joint.offset);
    v[joint.v] = static_cast<Number>(joint.multiplier * double(v[source.v]));
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
  kNoAnswer = 5,        // a process did not answer in time (numbered in place of a joint)
  kEnded = 6,           // no failure: process 0 has no more to evaluate
  kNotRefined = 7,      // a correction is as large as the one before: refinement does not converge
  kTooFewSteps = 11,    // refinement converges, but has not reached the digits that it owes
};

constexpr int kFailureBase = 1 << 20;
constexpr int failure(Failure kind, int joint) { return kind * kFailureBase + joint; }
constexpr Failure failure_kind(int status) { return static_cast<Failure>(status / kFailureBase); }
constexpr int failure_place(int status) { return status % kFailureBase; }

// Text as a JSON string, in one line.
std::string quoted(const char* text) {
  std::string result = "\"";
  for (; *text != '\0'; ++text) {
    const unsigned char c = static_cast<unsigned char>(*text);
    if (c == '"' || c == '\\') {
      result += '\\';
      result += *text;
    } else if (c < 0x20 || c == 0x7F) {
      char escape[8];
      std::snprintf(escape, sizeof escape, "\\u%04x", c);
      result += escape;
    } else {
      result += *text;
    }
  }
  return result + "\"";
}

// The names of a joint and of those before it that it is joined with: the links between them have
// neither mass nor inertia.
std::string names_of_run(int joint) {
  std::string names = quoted(kJoints[joint].name);
  for (int link = kJoints[joint].parent; link > 0; link = kJoints[link - 1].parent) {
    const LinkConstants& own = kLinks[link];
    if (own.mass > 0 || own.tensor[0] + own.tensor[4] + own.tensor[8] > 0) break;
    names = quoted(kJoints[link - 1].name) + ", " + names;
  }
  return names;
}

std::string describe(int status) {
  const int place = failure_place(status);
  const auto joint = [place] { return "joint " + quoted(kJoints[place].name) + ": "; };
  switch (failure_kind(status)) {
    case kFine:
      return "no error";
    case kNotFinite:
      return joint() + "its q, v or tau is not a finite number";
    case kZeroQuaternion:
      return joint() + "its quaternion cannot be normalised";
    case kFactorization:
      return joint() +
             "factorization failed: the inertias beside it differ too much for the scalar";
    case kGimbalLock:
      return "joints " + names_of_run(place) +
             ": gimbal lock: through links without mass, they do not move in as many directions";
    case kGrowth:
      return joint() +
             "no digits left: a link beside it is too light for its neighbours and the scalar";
    case kOverflow:
      return joint() + "its acceleration is not a finite number (overflow)";
    case kSingularPose:
      return joint() + "its mobility is singular in this pose";
    case kEnded:
      return "the evaluations are over";
    case kNotRefined:
      return "refinement does not converge: the inertias differ too much for the scalar";
    case kTooFewSteps:
      return "refinement converges too slowly: its last correction is too large; take more steps "
             "(--refine) or --scalar double";
    case kNoAnswer:
      return "process " + std::to_string(place) + " did not answer within the time limit";
  }
  return "unknown failure";
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
// kLargestAngle; beyond, each lane is left to the C library.
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

ADAGEN_COLD inline void leave_to_library(const Lanes& angle, const LaneBits& lanes, Lanes& sine,
                                         Lanes& cosine) {
  for (int k = 0; k < kLanes; ++k)
    if (lanes[k]) sine[k] = std::sin(angle[k]), cosine[k] = std::cos(angle[k]);
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
  if (__builtin_expect(any_of(beyond), 0)) leave_to_library(angle, beyond, sine, cosine);
}

constexpr std::array<MessageInfo, 4> kMessages{ {
    {0, 1, 27},  // 0: what hangs on "torso"
    {1, 0, 27},  // 1: what hangs on "torso"
    {0, 1, 61},  // 2: state
    {1, 0, 14},  // 3: accelerations
} };

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
enum class ChannelMode { kAuto, kWindow, kMessage };

inline void relax() {
#if defined(__x86_64__) || defined(__i386__)
  __builtin_ia32_pause();
#elif defined(__aarch64__)
  asm volatile("yield");
#endif
}

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
      ++ways[ports_[k].slots ? 1 : 0];
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

  // Waits for message k and returns its content; what its source knows of failures joins the
  // status.
  const Number* receive(int k, int& status) {
    if (take_ && take_->playing()) return opened(take_->pass(), status);
    Port& port = ports_[k];
    const Number* content;
    if (port.slots) {
      const std::uint64_t number = ++port.count;
      Slot& slot = port.slot(number, k);
      if (!wait_until([&] { return slot.number.load(std::memory_order_acquire) >= number; }))
        fail(status, failure(kNoAnswer, kMessages[k].source));
      content = slot.content();
    } else {
      MPI_Irecv(port.buffer.data(), static_cast<int>(port.buffer.size()), kMpiNumber,
                kMessages[k].source, k, comm_, &port.request);
      wait(port.request, kMessages[k].source, status);
      content = port.buffer.data();
    }
    if (take_) take_->note(k, content);
    return opened(content, status);
  }

  // Notes from here on what is sent and received, or plays it; null for neither.
  void use(Take* take) { take_ = take; }

  // Waits until a peer has done its part; then tells done of it. What never comes is given up.
  template <class Done>
  void wait(MPI_Request& request, int peer, int& status, Done done) {
    if (request == MPI_REQUEST_NULL) return;
    MPI_Status found;
    const bool in_time = wait_until([&] {
      int flag = 0;
      MPI_Test(&request, &flag, &found);
      return flag != 0;
    });
    if (in_time) return done(found);
    give_up(request);
    fail(status, failure(kNoAnswer, peer));
  }
  void wait(MPI_Request& request, int peer, int& status) {
    wait(request, peer, status, [](const MPI_Status&) {});
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
      return on_node[info.source] != MPI_UNDEFINED && on_node[info.target] != MPI_UNDEFINED;
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

  // Spins briefly, then yields, so that more processes than cores still finish.
  template <class Ready>
  bool wait_until(Ready ready) {
    for (int k = 0; k < 4000; ++k) {
      if (ready()) return true;
      relax();
    }
    if (broken_) return false;  // a peer is gone: do not wait for it once more
    const Clock::time_point end = Clock::now() + time_limit_;
    while (!ready()) {
      std::this_thread::yield();
      if (Clock::now() > end) {
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
struct Stage {
  const char* what;
  int joint;    // that it ends or begins with; -1 for none
  int message;  // sent or received; -1 for work
};

std::chrono::steady_clock::rep* trace_stamps =
    nullptr;  // where an evaluation puts them: its start, then each end

[[maybe_unused]] inline void stamp(int k) {
  if (trace_stamps) trace_stamps[k] = std::chrono::steady_clock::now().time_since_epoch().count();
}

// ---- 4. joints ----------------------------------------------------------------------------------

// What is computed with.
using Value = Real;

// The memory of a process: the state, angles with sine and cosine, what messages hold, and values
// that one function leaves to another.
struct Workspace {
  const Value* q = nullptr;
  const Value* v = nullptr;
  const Value* tau = nullptr;
  Value* qdd = nullptr;
  int status = kFine;
  alignas(kCacheLine) std::array<Value, 32> angle{}, sine{}, cosine{};
  std::array<Value, kNv> result{};
  alignas(kCacheLine) std::array<Value, 12> lanes{};  // results of rows
  std::array<Real*, kPlanMessages> to{};          // messages to be sent
  std::array<const Real*, kPlanMessages> from{};  // messages received
  alignas(kCacheLine) std::array<Value, 248> x{};
};

// What straight lines of numbers need.
inline bool all(bool good, bool also = true) { return good && also; }

// Zero for finite numbers only: x - x is.
inline Real unlike_zero(const Real* x, int count) {
  Real sum = 0;
  for (int k = 0; k < count; ++k) sum += x[k] - x[k];
  return sum;
}

// What the straight lines are surrounded by: the state looked at, sines and cosines, checks,
// results.
#define ADAGEN_INPUTS                                                              \
  [[maybe_unused]] const Value *const q = w.q, *const v = w.v, *const tau = w.tau; \
  [[maybe_unused]] const Value *const sine = w.sine.data(), *const cosine = w.cosine.data();

[[maybe_unused]] constexpr Real kInfinity = std::numeric_limits<Real>::infinity();

inline void fail(Workspace& w, Failure kind, int joint) {
  Channel::fail(w.status, failure(kind, joint));
}

// A state was found not to be finite: which joint's?
template <std::size_t reads, std::size_t owns>
[[gnu::cold]] ADAGEN_NOINLINE void name_what_is_not_finite(Workspace& w,
                                                           const std::array<int, reads>& read,
                                                           const std::array<int, owns>& owned) {
  for (const int j : read) {
    const JointConstants& joint = kJoints[static_cast<std::size_t>(j)];
    if (!all(unlike_zero(w.q + joint.q, joint.nq) + unlike_zero(w.v + joint.v, joint.nv) == 0))
      fail(w, kNotFinite, j);
  }
  for (const int j : owned) {
    const JointConstants& joint = kJoints[static_cast<std::size_t>(j)];
    if (!all(unlike_zero(w.tau + joint.v, joint.nv) == 0)) fail(w, kNotFinite, j);
  }
}

[[maybe_unused]] inline void require_length(Workspace& w, const Value& squared, int joint) {
  if (!all(squared >= std::numeric_limits<Real>::min(),
           squared <= std::numeric_limits<Real>::max()))
    fail(w, kZeroQuaternion, joint);
}

// A pivot or a mobility has to be more than what rounding may have left of it.
template <class T>
[[maybe_unused]] void require_more(Workspace& w, const Value& x, const T& least, Failure kind,
                                   int joint) {
  if (!all(x > least, x <= std::numeric_limits<Real>::max())) fail(w, kind, joint);
}

// A result was found not to be finite: which joint's?
template <std::size_t owns>
[[gnu::cold]] ADAGEN_NOINLINE void name_what_overflows(Workspace& w,
                                                       const std::array<int, owns>& owned) {
  for (const int j : owned) {
    const JointConstants& joint = kJoints[static_cast<std::size_t>(j)];
    if (!all(unlike_zero(w.result.data() + joint.v, joint.nv) == 0)) fail(w, kOverflow, j);
  }
}

// Limbs that are alike share code: one is in each lane.
typedef Real Two __attribute__((vector_size(2 * sizeof(Real))));
typedef Real Four __attribute__((vector_size(4 * sizeof(Real))));
typedef Real Eight __attribute__((vector_size(8 * sizeof(Real))));
template <class T>
[[maybe_unused]] constexpr int kWidth = static_cast<int>(sizeof(T) / sizeof(Real));
template <class T>
using Half =
    std::conditional_t<kWidth<T> == 8, Four, std::conditional_t<kWidth<T> == 4, Two, Real>>;

// Lanes are for limbs: g++ is told not to look for more to put side by side.
#if defined(__clang__)
#define ADAGEN_AS_IT_STANDS
#else
#define ADAGEN_AS_IT_STANDS __attribute__((optimize("no-tree-slp-vectorize")))
#endif

template <class T>
ADAGEN_INLINE T taken(const Real* from) {
  T x;
  std::memcpy(&x, from, sizeof x);
  return x;
}
template <class T>
ADAGEN_INLINE void put(const T& x, Real* to) {
  std::memcpy(to, &x, sizeof x);
}

// The sum of the first numbers, half by half.
template <int count>
ADAGEN_INLINE Real across(const Real& x) {
  return x;
}
template <int count, class T>
ADAGEN_INLINE Real across(const T& x) {
  constexpr int half = kWidth<T> / 2;
  Half<T> halves[2];
  std::memcpy(halves, &x, sizeof x);
  if constexpr (count == kWidth<T>) {
    const Half<T> sum = halves[0] + halves[1];
    return across<half>(sum);
  } else if constexpr (count > half) {
    return across<half>(halves[0]) + across<count - half>(halves[1]);
  } else {
    return across<count>(halves[0]);
  }
}

// Zero for finite numbers only, of rows that lie one after the other.
template <class T, int rows>
ADAGEN_INLINE Real unlike_zero(const Real* from) {
  T sum{};
  ADAGEN_FOR (k, 0, rows) {
    const T x = taken<T>(from + k * kWidth<T>);
    sum += x - x;
  }
  return across<kWidth<T>>(sum);
}

// The same as for single numbers, in the name of a joint for each lane.
template <class T, std::size_t count>
ADAGEN_COLD void name_what_is_not_more(Workspace& w, const T& x, const T& least, Failure kind,
                                       const int (&joints)[count]) {
  for (std::size_t k = 0; k < count; ++k) require_more(w, x[k], least[k], kind, joints[k]);
}
template <class T, class L, std::size_t count>
ADAGEN_INLINE void require_more(Workspace& w, const T& x, const L& least, Failure kind,
                                const int (&joints)[count]) {
  const auto good = (x > least) & (x <= std::numeric_limits<Real>::max());
  if (__builtin_expect(any_of(~good), 0)) name_what_is_not_more(w, x, T{} + least, kind, joints);
}
template <class T, std::size_t count>
ADAGEN_INLINE void require_length(Workspace& w, const T& squared, const int (&joints)[count]) {
  for (std::size_t k = 0; k < count; ++k) require_length(w, squared[k], joints[k]);
}

// Sines and cosines of angles, whose places in q are given; as many are written as fill registers.
template <std::size_t count, std::size_t... lane>
ADAGEN_INLINE Lanes angles_of(const Real* q, const std::array<int, count>& places,
                              std::size_t first, std::index_sequence<lane...>) {
  return Lanes{q[places[std::min(first + lane, count - 1)]]...};
}
template <std::size_t count>
ADAGEN_INLINE void take_sines_and_cosines(const Real* q, const std::array<int, count>& places,
                                          Real* sine, Real* cosine) {
  constexpr int kBlocks = (static_cast<int>(count) + kLanes - 1) / kLanes;
  ADAGEN_FOR (block, 0, kBlocks) {
    const Lanes angle = angles_of(q, places, static_cast<std::size_t>(block * kLanes),
                                  std::make_index_sequence<kLanes>{});
    Lanes s, c;
    sine_and_cosine(angle, s, c);
    store(s, sine + block * kLanes);
    store(c, cosine + block * kLanes);
  }
}

// Each function is a straight line. A value is called x and its number in the expression graph; zeros
// and constants are folded in, nothing is computed twice, and what nobody needs is not there.
// Frames are the links' own; accelerations are deviations from the field that the links would have
// with all joint accelerations zero.

// =================================================================================================
// Process 0: 1151 products, 998 sums, 15 quotients, 1292 of them in lanes
// =================================================================================================

ADAGEN_NOINLINE ADAGEN_AS_IT_STANDS void part_0_0(Workspace& w) {
  ADAGEN_INPUTS
  // joint 0 "__base__": placement, velocity and reference acceleration of its link
  const Real x98 = v[3] * v[3];
  const Real x103 = v[3] * v[4];
  const Real x106 = v[4] * v[5];
  const Real x107 = x98 + v[4] * v[4];
  const Real x109 = v[3] * v[5];
  // joints 1 "left_hip_pitch", 7 "right_hip_pitch": placement, velocity and reference acceleration of their links
  const Two x112 = Two{v[6], v[12]};
  const Two x120 = taken<Two>(cosine + 0) * v[5] + taken<Two>(sine + 0) * v[3];
  const Two x124 = taken<Two>(cosine + 0) * v[3] - taken<Two>(sine + 0) * v[5];
  const Two x125 = v[4] + x112;
  const Two x126 = x112 * x124;
  const Two x127 = x112 * x120;
  const Two x133 = x103 * Two{0.09, -0.09} - x109 * 0.05;
  const Two x138 = (x98 + v[5] * v[5]) * Two{0.09, -0.09} + x106 * 0.05;
  const Two x143 = x106 * Two{0.09, -0.09} + x107 * 0.05;
  const Two x146 = taken<Two>(cosine + 0) * x143 + taken<Two>(sine + 0) * x133;
  const Two x150 = taken<Two>(cosine + 0) * x133 - taken<Two>(sine + 0) * x143;
  const Two x162 = x124 * x125;
  const Two x163 = x162 - x126;
  const Two x165 = x120 * x120 + x124 * x124;
  const Two x167 = x120 * x125;
  const Two x169 = x167 - x127;
  // links 2 "left_hip", 8 "right_hip": force that the reference field takes
  const Two x770 = x126 * 0.00308 - x162 * 0.0013299999999999998 - x150 * Two{0.041999999999999996, -0.041999999999999996};
  put(x770, w.x.data() + 0);
  const Two x772 = x167 * 0.0013299999999999998 - x127 * 0.00308 + x146 * Two{0.041999999999999996, -0.041999999999999996};
  put(x772, w.x.data() + 2);
  const Two x775 = x146 * 1.4 + x169 * Two{0.041999999999999996, -0.041999999999999996};
  put(x775, w.x.data() + 4);
  const Two x778 = x150 * 1.4 + x163 * Two{0.041999999999999996, -0.041999999999999996};
  put(x778, w.x.data() + 6);
  const Two x783 = x138 * 1.4 + x165 * Two{0.041999999999999996, -0.041999999999999996};
  put(x783, w.x.data() + 8);
  // joints 2 "left_hip_roll", 8 "right_hip_roll": placement, velocity and reference acceleration of their links
  const Two x172 = Two{v[7], v[13]};
  const Two x179 = taken<Two>(cosine + 2) * x125 + taken<Two>(sine + 2) * x120;
  const Two x183 = taken<Two>(cosine + 2) * x120 - taken<Two>(sine + 2) * x125;
  const Two x184 = x124 + x172;
  const Two x188 = taken<Two>(sine + 2) * x126 + x172 * x183;
  const Two x191 = taken<Two>(cosine + 2) * x126 - x172 * x179;
  const Two x193 = x146 + x169 * Two{0.04, -0.04};
  const Two x195 = x150 + x163 * Two{0.04, -0.04};
  const Two x198 = x138 + x165 * Two{0.04, -0.04};
  const Two x203 = taken<Two>(sine + 2) * x193 - taken<Two>(cosine + 2) * x198;
  const Two x207 = taken<Two>(sine + 2) * x198 + taken<Two>(cosine + 2) * x193;
  const Two x210 = x179 * x179;
  const Two x215 = x179 * x183;
  const Two x216 = x127 + x215;
  const Two x218 = x210 + x184 * x184;
  const Two x220 = x183 * x184;
  const Two x222 = x188 + x220;
  const Two x223 = x210 + x183 * x183;
  const Two x225 = x179 * x184;
  const Two x227 = x191 + x225;
  // links 3 "left_groin", 9 "right_groin": force that the reference field takes
  const Two x805 = x188 * 0.00379 + x220 * 0.0015500000000000002;
  const Two x829 = 0.00096 * (x223 - x218) + x805 - x195 * 0.048;
  const Two x814 = x191 * 0.00187 + x225 * 0.00036999999999999994 - x216 * 0.00096;
  const Two x824 = x227 * 0.00096 - (x127 * 0.00342 + x215 * 0.00192);
  const Two x846 = x218 * 0.048 + (x220 - x188) * 0.024;
  // joints 3 "left_hip_yaw", 9 "right_hip_yaw": placement, velocity and reference acceleration of their links
  const Two x230 = Two{v[8], v[14]};
  const Two x235 = taken<Two>(cosine + 4) * x184 + taken<Two>(sine + 4) * x179;
  const Two x239 = taken<Two>(cosine + 4) * x179 - taken<Two>(sine + 4) * x184;
  const Two x240 = x183 + x230;
  const Two x250 = taken<Two>(sine + 4) * x188 - taken<Two>(cosine + 4) * x127 + x230 * x239;
  const Two x253 = taken<Two>(sine + 4) * x127 + taken<Two>(cosine + 4) * x188 - x230 * x235;
  const Two x257 = x203 - x216 * 0.12;
  const Two x260 = x207 + x218 * 0.12;
  const Two x263 = x195 - x222 * 0.12;
  const Two x266 = taken<Two>(cosine + 4) * x263 + taken<Two>(sine + 4) * x257;
  const Two x270 = taken<Two>(cosine + 4) * x257 - taken<Two>(sine + 4) * x263;
  const Two x283 = x239 * x240;
  const Two x284 = x283 - x250;
  const Two x286 = x235 * x235 + x239 * x239;
  const Two x288 = x235 * x240;
  const Two x290 = x253 + x288;
  // joints 4 "left_knee", 10 "right_knee": placement, velocity and reference acceleration of their links
  const Two x293 = Two{v[9], v[15]};
  const Two x298 = taken<Two>(cosine + 6) * x240 + taken<Two>(sine + 6) * x235;
  const Two x302 = taken<Two>(cosine + 6) * x235 - taken<Two>(sine + 6) * x240;
  const Two x303 = x239 + x293;
  const Two x312 = taken<Two>(cosine + 6) * x191 + taken<Two>(sine + 6) * x250 + x293 * x302;
  const Two x315 = taken<Two>(cosine + 6) * x250 - taken<Two>(sine + 6) * x191 - x293 * x298;
  const Two x319 = x266 - x290 * 0.24;
  const Two x322 = x270 - x284 * 0.24;
  const Two x325 = x260 + x286 * 0.24;
  const Two x328 = taken<Two>(cosine + 6) * x325 + taken<Two>(sine + 6) * x319;
  const Two x332 = taken<Two>(cosine + 6) * x319 - taken<Two>(sine + 6) * x325;
  const Two x337 = x303 * x303;
  const Two x338 = x302 * x302 + x337;
  const Two x340 = x298 * x302;
  const Two x342 = x253 + x340;
  const Two x343 = x298 * x298 + x337;
  const Two x345 = x302 * x303;
  const Two x347 = x312 + x345;
  const Two x350 = x298 * x303;
  const Two x351 = x350 - x315;
  // links 5 "left_shank", 11 "right_shank": force that the reference field takes
  const Two x930 = x253 * 0.043271300000000006 + x340 * 0.0410888;
  const Two x915 = x312 * 0.0020025 + x345 * 0.00018 - x351 * 0.00234;
  const Two x924 = x315 * 0.043091300000000006 - x350 * 0.0412688 + x347 * 0.00234;
  const Two x941 = 0.00234 * (x343 - x338) + x930 - x332 * 0.234;
  const Two x947 = x338 * 0.234 + (x340 - x253) * 0.018000000000000002;
  // joints 5 "left_ankle_pitch", 11 "right_ankle_pitch": placement, velocity and reference acceleration of their links
  const Two x355 = Two{v[10], v[16]};
  const Two x360 = taken<Two>(cosine + 8) * x298 + taken<Two>(sine + 8) * x302;
  const Two x364 = taken<Two>(cosine + 8) * x302 - taken<Two>(sine + 8) * x298;
  const Two x365 = x303 + x355;
  const Two x374 = taken<Two>(cosine + 8) * x312 + taken<Two>(sine + 8) * x315 + x355 * x364;
  const Two x377 = taken<Two>(cosine + 8) * x315 - taken<Two>(sine + 8) * x312 - x355 * x360;
  const Two x381 = x328 + x338 * 0.3;
  const Two x384 = x332 - x342 * 0.3;
  const Two x387 = x322 - x351 * 0.3;
  const Two x390 = taken<Two>(cosine + 8) * x381 + taken<Two>(sine + 8) * x384;
  const Two x394 = taken<Two>(cosine + 8) * x384 - taken<Two>(sine + 8) * x381;
  // joints 6 "left_ankle_roll", 12 "right_ankle_roll": placement, velocity and reference acceleration of their links
  const Two x418 = Two{v[11], v[17]};
  const Two x423 = taken<Two>(cosine + 10) * x365 + taken<Two>(sine + 10) * x360;
  const Two x427 = taken<Two>(cosine + 10) * x360 - taken<Two>(sine + 10) * x365;
  const Two x428 = x364 + x418;
  const Two x437 = taken<Two>(cosine + 10) * x253 + taken<Two>(sine + 10) * x374 + x418 * x427;
  const Two x440 = taken<Two>(cosine + 10) * x374 - taken<Two>(sine + 10) * x253 - x418 * x423;
  const Two x444 = x390 + (x364 * x364 + x365 * x365) * 0.02;
  const Two x447 = x394 - (x253 + x360 * x364) * 0.02;
  const Two x450 = x387 - (x360 * x365 - x377) * 0.02;
  const Two x453 = taken<Two>(cosine + 10) * x450 + taken<Two>(sine + 10) * x444;
  const Two x457 = taken<Two>(cosine + 10) * x444 - taken<Two>(sine + 10) * x450;
  const Two x460 = x423 * x423;
  const Two x465 = x423 * x427;
  const Two x466 = x465 - x377;
  const Two x468 = x460 + x428 * x428;
  const Two x470 = x427 * x428;
  const Two x473 = x460 + x427 * x427;
  const Two x475 = x423 * x428;
  const Two x477 = x440 + x475;
  // links 7 "left_foot", 13 "right_foot": force that the reference field takes
  const Two x992 = 0.0007199999999999999 * (x473 - x468) - x470 * 0.002606663;
  const Two x1015 = x437 * 0.00416667 + x992 - x447 * 0.024;
  const Two x1016 = x1015 - x457 * 0.024;
  const Two x1017 = x453 * 0.024;
  const Two x1001 = x475 * 0.002960003 - x466 * 0.0007199999999999999 + x440 * 0.00381333;
  const Two x1010 = x377 * 0.001206667 - x465 * 0.00035334 + x477 * 0.0007199999999999999;
  const Two x1031 = x468 * 0.024 + (x470 - x437) * 0.024;
  const Two x1032 = x457 * 0.8 + x1031;
  const Two x1038 = x447 * 0.8 - x473 * 0.024;
  const Two x1039 = x1038 - (x437 + x470) * 0.024;
  // joint 13 "waist_yaw": placement, velocity and reference acceleration of its link
  const Real x485 = v[3] * cosine[12] + v[4] * sine[12];
  const Real x489 = v[4] * cosine[12] - v[3] * sine[12];
  const Real x490 = v[5] + v[18];
  const Real x491 = v[18] * x489;
  const Real x492 = v[18] * x485;
  const Real x494 = x109 * 0.09;
  const Real x495 = x106 * 0.09;
  const Real x496 = x107 * 0.09;
  const Real x500 = cosine[12] * x494 + sine[12] * x495;
  const Real x504 = cosine[12] * x495 - sine[12] * x494;
  const Real x516 = x489 * x490;
  const Real x517 = x516 - x491;
  const Real x519 = x485 * x485 + x489 * x489;
  const Real x521 = x485 * x490;
  const Real x523 = x521 - x492;
  // link 14 "waist_link": force that the reference field takes
  const Real x704 = x491 * 0.00106 - x516 * 6e-05 - x504 * 0.016;
  w.x[10] = x704;
  const Real x706 = x521 * 6e-05 - x492 * 0.00106 + x500 * 0.016;
  w.x[11] = x706;
  const Real x709 = x500 * 0.8 + x523 * 0.016;
  w.x[12] = x709;
  const Real x712 = x504 * 0.8 + x517 * 0.016;
  w.x[13] = x712;
  const Real x717 = x496 * 0.8 + x519 * 0.016;
  w.x[14] = x717;
  // joint 14 "waist_roll": placement, velocity and reference acceleration of its link
  const Real x531 = x489 * cosine[13] + x490 * sine[13];
  const Real x535 = x490 * cosine[13] - x489 * sine[13];
  const Real x536 = x485 + v[19];
  const Real x542 = v[19] * x535 - x492 * cosine[13];
  const Real x547 = x500 + 0.05 * x523;
  const Real x549 = x504 + 0.05 * x517;
  const Real x552 = x496 + 0.05 * x519;
  const Real x557 = cosine[13] * x549 - sine[13] * x552;
  const Real x571 = x531 * x535;
  const Real x576 = x535 * x536;
  // link 15 "abdomen": force that the reference field takes
  const Real x657 = (x492 * sine[13] - v[19] * x531) * 0.001125;
  w.x[15] = x657;
  const Real x666 = x542 * 0.0014025 + x576 * 0.00027750000000000013 + x547 * 0.018000000000000002;
  w.x[16] = x666;
  const Real x669 = x491 * 0.0014025 - x571 * 0.00027750000000000013 - x557 * 0.018000000000000002;
  w.x[17] = x669;
  const Real x672 = x557 * 0.9 + (x571 - x491) * 0.018000000000000002;
  w.x[18] = x672;
  const Real x673 = (sine[13] * x549 + cosine[13] * x552) * 0.9;
  const Real x677 = x673 + (x531 * x531 + x536 * x536) * 0.018000000000000002;
  w.x[19] = x677;
  const Real x681 = x547 * 0.9 + (x542 + x576) * 0.018000000000000002;
  w.x[20] = x681;
  // joint 0 "__base__": its torque on the base
  const Real x1046 = x109 * 0.12400000000000001 - tau[0];
  w.x[21] = x1046;
  const Real x1047 = x106 * 0.12400000000000001 - tau[1];
  w.x[22] = x1047;
  const Real x1048 = x107 * 0.12400000000000001 + tau[2];
  w.x[23] = x1048;
  const Real x1050 = x106 * 0.015086599999999999 - tau[3];
  w.x[24] = x1050;
  const Real x1051 = x109 * 0.00020659999999999716 + tau[4];
  w.x[25] = x1051;
  const Real x1053 = x103 * 0.01488 + tau[5];
  w.x[26] = x1053;
  // joints 6 "left_ankle_roll", 12 "right_ankle_roll": articulated-body inertia and bias force through them
  const Two x1057 = Two{tau[11], tau[17]};
  const Two x1060 = 828.7290528372782 * (x1057 - (x1010 + x1017));
  put(x1060, w.x.data() + 28);
  const Two x1073 = x1001 + x1017 + 0.0007199999999999999 * x1060;
  // links 7 "left_foot", 13 "right_foot": force that the reference field takes
  const Two x1026 = x477 * 0.024 - x466 * 0.024 + x453 * 0.8;
  // joints 6 "left_ankle_roll", 12 "right_ankle_roll": articulated-body inertia and bias force through them
  const Two x1075 = x1026 + 0.024 * x1060;
  const Two x1076 = taken<Two>(cosine + 10) * 0.024;
  const Two x1078 = taken<Two>(sine + 10) * 0.024;
  const Two x1080 = taken<Two>(sine + 10) * 0.014320438033028168;
  const Two x1082 = taken<Two>(sine + 10) * x1080;
  const Two x1084 = -0.024 + x1082;
  const Two x1085 = 0.009679561966971832 + x1082;
  const Two x1086 = taken<Two>(cosine + 10) * x1080;
  const Two x1089 = taken<Two>(cosine + 10) * 0.000782953140990845;
  const Two x1094 = taken<Two>(cosine + 10) * x1089;
  const Two x1097 = taken<Two>(cosine + 10) * 0.47734793443427226;
  const Two x1099 = taken<Two>(sine + 10) * x1097;
  const Two x1101 = taken<Two>(cosine + 10) * x1097;
  const Two x1103 = 0.8 - x1101;
  const Two x1107 = -0.016 - x1076;
  const Two x1108 = 0.02 * x1103;
  const Two x1114 = taken<Two>(sine + 10) * x1089 + 0.02 * x1078;
  const Two x1117 = 0.02 * x1086;
  const Two x1135 = taken<Two>(cosine + 10) * x1075 - taken<Two>(sine + 10) * x1032;
  const Two x1124 = 0.003383716859009155 + x1094 + 0.02 * x1076 - 0.02 * x1107;
  const Two x1147 = 7.2e-05 + x1124;
  require_more(w, x1147, 0.0, kFactorization, {5, 11});
  const Two x1144 = taken<Two>(cosine + 10) * x1016 - taken<Two>(sine + 10) * x1073 - 0.02 * x1039;
  // joints 5 "left_ankle_pitch", 11 "right_ankle_pitch": articulated-body inertia and bias force through them
  const Two x1159 = Two{tau[10], tau[16]};
  const Two x1160 = 1 / x1147;
  const Two x1162 = x1160 * (x1159 - (x253 * 7.2e-05 + x1144));
  put(x1162, w.x.data() + 30);
  const Two x1163 = x1114 * x1160;
  put(x1163, w.x.data() + 32);
  const Two x1164 = x1117 * x1160;
  put(x1164, w.x.data() + 34);
  const Two x1165 = x1084 * x1160;
  put(x1165, w.x.data() + 36);
  const Two x1166 = x1107 * x1160;
  put(x1166, w.x.data() + 38);
  const Two x1167 = x1086 * x1160;
  put(x1167, w.x.data() + 40);
  const Two x1170 = 0.00416667 - x1094 + 7.2e-05 - x1114 * x1163;
  const Two x1173 = 0.02 * x1085 - x1114 * x1164;
  const Two x1176 = x1086 + x1114 * x1165;
  const Two x1180 = x1078 + x1114 * x1166;
  const Two x1184 = x1085 - x1114 * x1167;
  const Two x1187 = 7.2e-05 + 0.02 * x1108 - x1117 * x1164;
  const Two x1190 = 0.02 * x1099 + x1117 * x1165;
  const Two x1192 = x1117 * x1166;
  const Two x1196 = x1108 - x1117 * x1167;
  const Two x1199 = 0.3226520655657278 + x1101 + 0.2 - x1084 * x1165;
  const Two x1200 = x1084 * x1166;
  const Two x1204 = x1099 + x1084 * x1167;
  const Two x1208 = 1.0 - x1107 * x1166;
  const Two x1209 = x1107 * x1167;
  const Two x1213 = 0.2 + x1103 - x1086 * x1167;
  // joints 6 "left_ankle_roll", 12 "right_ankle_roll": articulated-body inertia and bias force through them
  const Two x1151 = taken<Two>(sine + 10) * x1016 + taken<Two>(cosine + 10) * x1073 + x374 * 7.2e-05;
  // joints 5 "left_ankle_pitch", 11 "right_ankle_pitch": articulated-body inertia and bias force through them
  const Two x1215 = x1151 + x1114 * x1162;
  // joints 6 "left_ankle_roll", 12 "right_ankle_roll": articulated-body inertia and bias force through them
  const Two x1152 = x1057 + 0.02 * x1135 + x377 * 7.2e-05;
  // joints 5 "left_ankle_pitch", 11 "right_ankle_pitch": articulated-body inertia and bias force through them
  const Two x1217 = x1152 + x1117 * x1162;
  // joints 6 "left_ankle_roll", 12 "right_ankle_roll": articulated-body inertia and bias force through them
  const Two x1154 = taken<Two>(sine + 10) * x1075 + taken<Two>(cosine + 10) * x1032 + x390 * 0.2;
  // joints 5 "left_ankle_pitch", 11 "right_ankle_pitch": articulated-body inertia and bias force through them
  const Two x1219 = x1154 + x1084 * x1162;
  const Two x1221 = x394 * 0.2 + x1039 + x1107 * x1162;
  const Two x1223 = x387 * 0.2 + x1135 + x1086 * x1162;
  const Two x1227 = taken<Two>(cosine + 8) * x1184 - taken<Two>(sine + 8) * x1196;
  const Two x1230 = taken<Two>(sine + 8) * x1184 + taken<Two>(cosine + 8) * x1196;
  const Two x1237 = taken<Two>(cosine + 8) * (x1192 - x1176) + taken<Two>(sine + 8) * (x1180 + x1190);
  const Two x1238 = taken<Two>(sine + 8) * x1237;
  const Two x1240 = x1238 - x1180;
  const Two x1242 = taken<Two>(cosine + 8) * x1237;
  const Two x1248 = taken<Two>(sine + 8) * 2.0;
  const Two x1252 = taken<Two>(cosine + 8) * (x1170 - x1187) - x1173 * x1248;
  const Two x1256 = taken<Two>(cosine + 8) * x1252;
  const Two x1263 = taken<Two>(sine + 8) * x1209 - taken<Two>(cosine + 8) * x1204;
  const Two x1268 = taken<Two>(sine + 8) * x1204 + taken<Two>(cosine + 8) * x1209;
  const Two x1274 = taken<Two>(cosine + 8) * (x1199 - x1208) + x1200 * x1248;
  const Two x1277 = taken<Two>(sine + 8) * x1274 - x1200;
  const Two x1278 = taken<Two>(cosine + 8) * x1274;
  const Two x1280 = x1199 - x1278;
  const Two x1286 = 0.3 * x1268;
  const Two x1288 = x1176 + x1242 + x1286;
  const Two x1290 = 0.3 * x1280;
  const Two x1294 = x1230 + 0.3 * x1213;
  const Two x1298 = 0.3 * x1240;
  const Two x1306 = 0.3 * x1288;
  const Two x1323 = taken<Two>(sine + 8) * x1219 + taken<Two>(cosine + 8) * x1221;
  const Two x1305 = x1170 - x1256 + (0.3 * x1230 + 0.3 * x1294);
  const Two x1335 = 0.043271300000000006 + 0.3 * x1290;
  require_more(w, x1335, 0.0, kFactorization, {4, 10});
  const Two x1336 = -0.018000000000000002 - 0.3 * x1277;
  const Two x1337 = -0.234 - x1290;
  const Two x1313 = taken<Two>(cosine + 8) * x1215 - taken<Two>(sine + 8) * x1217;
  const Two x1326 = taken<Two>(sine + 8) * x1215 + taken<Two>(cosine + 8) * x1217 + 0.3 * x1223;
  const Two x1320 = taken<Two>(cosine + 8) * x1219 - taken<Two>(sine + 8) * x1221;
  // links 5 "left_shank", 11 "right_shank": force that the reference field takes
  const Two x956 = x332 * 1.8 - (x342 * 0.234 + x343 * 0.018000000000000002);
  const Two x962 = x322 * 1.8 - x351 * 0.234 + x347 * 0.018000000000000002;
  // joints 4 "left_knee", 10 "right_knee": articulated-body inertia and bias force through them
  const Two x1349 = Two{tau[9], tau[15]};
  const Two x1350 = 1 / x1335;
  // joints 5 "left_ankle_pitch", 11 "right_ankle_pitch": articulated-body inertia and bias force through them
  const Two x1343 = x941 - x328 * 0.018000000000000002 + (x1159 - 0.3 * x1323);
  // joints 4 "left_knee", 10 "right_knee": articulated-body inertia and bias force through them
  const Two x1352 = x1350 * (x1349 - x1343);
  put(x1352, w.x.data() + 42);
  const Two x1353 = x1298 * x1350;
  put(x1353, w.x.data() + 44);
  const Two x1355 = x1306 * x1350;
  put(x1355, w.x.data() + 46);
  const Two x1356 = x1336 * x1350;
  put(x1356, w.x.data() + 48);
  const Two x1357 = x1337 * x1350;
  put(x1357, w.x.data() + 50);
  const Two x1358 = x1286 * x1350;
  put(x1358, w.x.data() + 52);
  const Two x1361 = x1187 + x1256 + 0.0020025 - x1298 * x1353;
  // joints 5 "left_ankle_pitch", 11 "right_ankle_pitch": articulated-body inertia and bias force through them
  const Two x1331 = x1173 + taken<Two>(sine + 8) * x1252 + 0.3 * x1227 + 0.00234;
  // joints 4 "left_knee", 10 "right_knee": articulated-body inertia and bias force through them
  const Two x1364 = x1331 + x1298 * x1355;
  const Two x1367 = x1242 - x1192 + x1298 * x1356;
  const Two x1370 = x1240 + x1298 * x1357;
  const Two x1373 = 0.018000000000000002 + x1227 + x1298 * x1358;
  const Two x1376 = 0.043091300000000006 + x1305 - x1306 * x1355;
  const Two x1379 = x1238 - x1190 + 0.3 * x1263 - x1306 * x1356;
  const Two x1382 = x1288 + x1306 * x1357;
  const Two x1386 = 0.234 + x1294 - x1306 * x1358;
  const Two x1389 = x1208 + x1278 + 1.8 - x1336 * x1356;
  const Two x1392 = x1277 - x1336 * x1357;
  const Two x1395 = x1263 - x1336 * x1358;
  const Two x1398 = 1.8 + x1280 - x1337 * x1357;
  const Two x1401 = x1268 + x1337 * x1358;
  const Two x1405 = 1.8 + x1213 - x1286 * x1358;
  const Two x1408 = x915 + x322 * 0.018000000000000002 + x1313 - x1298 * x1352;
  const Two x1410 = x924 + x322 * 0.234 + x1326 + x1306 * x1352;
  const Two x1412 = x328 * 1.8 + x947 + x1320 + x1336 * x1352;
  const Two x1414 = x956 + x1323 + x1337 * x1352;
  const Two x1416 = x962 + x1223 + x1286 * x1352;
  const Two x1420 = taken<Two>(cosine + 6) * x1373 - taken<Two>(sine + 6) * x1386;
  const Two x1423 = taken<Two>(sine + 6) * x1373 + taken<Two>(cosine + 6) * x1386;
  const Two x1429 = taken<Two>(cosine + 6) * (x1367 + x1382) - taken<Two>(sine + 6) * (x1370 + x1379);
  const Two x1430 = taken<Two>(sine + 6) * x1429;
  const Two x1432 = x1370 + x1430;
  const Two x1434 = taken<Two>(cosine + 6) * x1429;
  const Two x1435 = x1434 - x1382;
  const Two x1439 = taken<Two>(sine + 6) * 2.0;
  const Two x1443 = taken<Two>(cosine + 6) * (x1361 - x1376) - x1364 * x1439;
  const Two x1447 = taken<Two>(cosine + 6) * x1443;
  const Two x1453 = taken<Two>(cosine + 6) * x1395 + taken<Two>(sine + 6) * x1401;
  const Two x1457 = taken<Two>(sine + 6) * x1395 - taken<Two>(cosine + 6) * x1401;
  const Two x1462 = taken<Two>(cosine + 6) * (x1389 - x1398) - x1392 * x1439;
  const Two x1465 = x1392 + taken<Two>(sine + 6) * x1462;
  const Two x1466 = taken<Two>(cosine + 6) * x1462;
  const Two x1468 = x1389 - x1466;
  const Two x1469 = 0.24 * x1457;
  const Two x1471 = x1367 - x1434 + x1469;
  const Two x1472 = 0.24 * x1468;
  const Two x1476 = x1423 + 0.24 * x1405;
  const Two x1492 = x1364 + taken<Two>(sine + 6) * x1443 + 0.24 * x1420;
  const Two x1495 = 0.24 * x1432;
  const Two x1510 = taken<Two>(sine + 6) * x1412 + taken<Two>(cosine + 6) * x1414;
  const Two x1487 = x1361 - x1447 + (0.24 * x1423 + 0.24 * x1476);
  const Two x1521 = x1376 + x1447 + 0.00468;
  require_more(w, x1521, 0.0, kFactorization, {3, 9});
  // links 4 "left_thigh", 10 "right_thigh": force that the reference field takes
  const Two x878 = x250 * 0.0429867 - x283 * 0.038306700000000006 + x270 * 0.26;
  // joints 4 "left_knee", 10 "right_knee": articulated-body inertia and bias force through them
  const Two x1513 = taken<Two>(sine + 6) * x1408 + taken<Two>(cosine + 6) * x1410 + 0.24 * x1416;
  // links 4 "left_thigh", 10 "right_thigh": force that the reference field takes
  const Two x881 = x253 * 0.0429867 + x288 * 0.038306700000000006 - x266 * 0.26;
  const Two x893 = x260 * 2.6 + x286 * 0.26;
  // joints 3 "left_hip_yaw", 9 "right_hip_yaw": articulated-body inertia and bias force through them
  const Two x1533 = Two{tau[8], tau[14]};
  const Two x1534 = 1 / x1521;
  // joints 4 "left_knee", 10 "right_knee": articulated-body inertia and bias force through them
  const Two x1527 = taken<Two>(cosine + 6) * x1408 - taken<Two>(sine + 6) * x1410 + x191 * 0.00468;
  // joints 3 "left_hip_yaw", 9 "right_hip_yaw": articulated-body inertia and bias force through them
  const Two x1536 = x1534 * (x1533 - x1527);
  put(x1536, w.x.data() + 54);
  const Two x1537 = x1492 * x1534;
  put(x1537, w.x.data() + 56);
  const Two x1538 = x1495 * x1534;
  put(x1538, w.x.data() + 58);
  const Two x1540 = x1432 * x1534;
  put(x1540, w.x.data() + 60);
  const Two x1541 = x1420 * x1534;
  put(x1541, w.x.data() + 62);
  const Two x1542 = x1435 * x1534;
  put(x1542, w.x.data() + 64);
  const Two x1545 = 0.0429867 + x1487 - x1492 * x1537;
  const Two x1548 = x1492 * x1538 - 0.24 * x1471;
  const Two x1551 = x1471 - x1492 * x1540;
  const Two x1554 = 0.26 + x1476 - x1492 * x1541;
  const Two x1557 = x1379 + x1430 + 0.24 * x1453 - x1492 * x1542;
  const Two x1560 = 0.0429867 + 0.24 * x1472 - x1495 * x1538;
  const Two x1563 = -0.26 - x1472 + x1495 * x1540;
  const Two x1566 = x1495 * x1541 - x1469;
  const Two x1569 = x1495 * x1542 - 0.24 * x1465;
  const Two x1572 = 2.6 + x1468 - x1432 * x1540;
  const Two x1575 = x1457 - x1432 * x1541;
  const Two x1578 = x1465 - x1432 * x1542;
  const Two x1581 = 2.6 + x1405 - x1420 * x1541;
  const Two x1584 = x1453 - x1420 * x1542;
  const Two x1589 = x878 + x1513 + x1492 * x1536;
  const Two x1592 = x1349 - 0.24 * x1510 + x881 - x1495 * x1536;
  // joints 4 "left_knee", 10 "right_knee": articulated-body inertia and bias force through them
  const Two x1528 = x266 * 2.6 - x290 * 0.26 + x1510;
  // joints 3 "left_hip_yaw", 9 "right_hip_yaw": articulated-body inertia and bias force through them
  const Two x1594 = x1528 + x1432 * x1536;
  // joints 4 "left_knee", 10 "right_knee": articulated-body inertia and bias force through them
  const Two x1529 = x270 * 2.6 - x284 * 0.26 + x1416;
  // joints 3 "left_hip_yaw", 9 "right_hip_yaw": articulated-body inertia and bias force through them
  const Two x1596 = x1529 + x1420 * x1536;
  // joints 4 "left_knee", 10 "right_knee": articulated-body inertia and bias force through them
  const Two x1530 = taken<Two>(cosine + 6) * x1412 - taken<Two>(sine + 6) * x1414 + x893;
  // joints 3 "left_hip_yaw", 9 "right_hip_yaw": articulated-body inertia and bias force through them
  const Two x1611 = taken<Two>(cosine + 4) * (x1551 - x1566) - taken<Two>(sine + 4) * (x1554 + x1563);
  const Two x1612 = taken<Two>(sine + 4) * x1611;
  const Two x1614 = x1554 + x1612;
  const Two x1615 = x1563 + x1612;
  const Two x1616 = taken<Two>(cosine + 4) * x1611;
  const Two x1617 = x1566 + x1616;
  const Two x1621 = taken<Two>(sine + 4) * 2.0;
  const Two x1625 = taken<Two>(cosine + 4) * (x1545 - x1560) - x1548 * x1621;
  const Two x1629 = taken<Two>(cosine + 4) * x1625;
  const Two x1635 = taken<Two>(cosine + 4) * x1578 - taken<Two>(sine + 4) * x1584;
  put(x1635, w.x.data() + 66);
  const Two x1638 = taken<Two>(sine + 4) * x1578 + taken<Two>(cosine + 4) * x1584;
  put(x1638, w.x.data() + 68);
  const Two x1643 = taken<Two>(cosine + 4) * (x1572 - x1581) - x1575 * x1621;
  const Two x1646 = x1575 + taken<Two>(sine + 4) * x1643;
  put(x1646, w.x.data() + 70);
  const Two x1647 = taken<Two>(cosine + 4) * x1643;
  const Two x1648 = x1581 + x1647;
  const Two x1649 = x1572 - x1647;
  const Two x1650 = 0.12 * x1646;
  const Two x1652 = x1551 - x1616 - x1650;
  put(x1652, w.x.data() + 72);
  const Two x1655 = x1614 + 0.12 * x1649;
  const Two x1661 = taken<Two>(cosine + 4) * x1557 - taken<Two>(sine + 4) * x1569 + 0.12 * x1638;
  put(x1661, w.x.data() + 74);
  const Two x1664 = x1615 - 0.12 * x1648;
  const Two x1665 = x1617 + x1650;
  put(x1665, w.x.data() + 76);
  const Two x1676 = x1548 + taken<Two>(sine + 4) * x1625 - 0.12 * x1617;
  const Two x1677 = 0.12 * x1652 + x1676;
  put(x1677, w.x.data() + 78);
  const Two x1694 = taken<Two>(cosine + 4) * x1594 - taken<Two>(sine + 4) * x1596;
  const Two x1697 = taken<Two>(sine + 4) * x1594 + taken<Two>(cosine + 4) * x1596;
  const Two x1671 = x1545 - x1629 - 0.12 * x1615 - 0.12 * x1664;
  const Two x1658 = taken<Two>(sine + 4) * x1557 + taken<Two>(cosine + 4) * x1569 - 0.12 * x1635;
  const Two x1705 = -0.024 + x1658;
  put(x1705, w.x.data() + 80);
  const Two x1706 = -0.048 + x1664;
  put(x1706, w.x.data() + 82);
  const Two x1683 = x1560 + x1629 + 0.12 * x1614 + 0.12 * x1655;
  const Two x1707 = 0.00342 + x1683;
  require_more(w, x1707, 0.0, kFactorization, {2, 8});
  const Two x1708 = 0.048 + x1655;
  put(x1708, w.x.data() + 84);
  const Two x1709 = 1.2 + x1649;
  put(x1709, w.x.data() + 86);
  const Two x1710 = x1398 + x1466 + 2.6 - x1435 * x1542 + 1.2;
  put(x1710, w.x.data() + 88);
  const Two x1711 = 1.2 + x1648;
  put(x1711, w.x.data() + 90);
  const Two x1700 = taken<Two>(sine + 4) * x1589 + taken<Two>(cosine + 4) * x1592 - 0.12 * x1694;
  const Two x1712 = x829 - x207 * 0.024 + x1700;
  put(x1712, w.x.data() + 92);
  const Two x1713 = x814 + x203 * 0.024 + x1533;
  put(x1713, w.x.data() + 94);
  const Two x1703 = taken<Two>(cosine + 4) * x1589 - taken<Two>(sine + 4) * x1592 + 0.12 * x1697;
  // links 3 "left_groin", 9 "right_groin": force that the reference field takes
  const Two x841 = x227 * 0.024 - x216 * 0.048 + x203 * 1.2;
  // joints 3 "left_hip_yaw", 9 "right_hip_yaw": articulated-body inertia and bias force through them
  const Two x1715 = x841 + x1697;
  put(x1715, w.x.data() + 96);
  const Two x1716 = x207 * 1.2 + x846 + (x1530 + x1435 * x1536);
  put(x1716, w.x.data() + 98);
  // links 3 "left_groin", 9 "right_groin": force that the reference field takes
  const Two x854 = x195 * 1.2 - x223 * 0.024 - x222 * 0.048;
  // joints 3 "left_hip_yaw", 9 "right_hip_yaw": articulated-body inertia and bias force through them
  const Two x1717 = x854 + x1694;
  put(x1717, w.x.data() + 100);
  // joints 2 "left_hip_roll", 8 "right_hip_roll": articulated-body inertia and bias force through them
  const Two x1720 = Two{tau[7], tau[13]};
  put(x1720, w.x.data() + 102);
  const Two x1721 = 1 / x1707;
  const Two x1723 = x1721 * (x1720 - (x824 + x203 * 0.048 + x1703));
  put(x1723, w.x.data() + 104);
  const Two x1724 = x1677 * x1721;
  put(x1724, w.x.data() + 106);
  const Two x1725 = 0.00096 * x1721;
  put(x1725, w.x.data() + 108);
  const Two x1726 = x1708 * x1721;
  put(x1726, w.x.data() + 110);
  const Two x1727 = x1661 * x1721;
  put(x1727, w.x.data() + 112);
  const Two x1728 = x1665 * x1721;
  put(x1728, w.x.data() + 114);
  const Two x1731 = 0.00379 + x1671 - x1677 * x1724;
  put(x1731, w.x.data() + 116);
  const Two x1732 = x1677 * x1725;
  put(x1732, w.x.data() + 118);
}

ADAGEN_NOINLINE ADAGEN_AS_IT_STANDS void part_0_1(Workspace& w) {
  ADAGEN_INPUTS
  const Real x657 = w.x[15];
  const Real x666 = w.x[16];
  const Real x669 = w.x[17];
  const Real x672 = w.x[18];
  const Real x677 = w.x[19];
  const Real x681 = w.x[20];
  const Real x704 = w.x[10];
  const Real x706 = w.x[11];
  const Real x709 = w.x[12];
  const Real x712 = w.x[13];
  const Real x717 = w.x[14];
  const Two x770 = taken<Two>(w.x.data() + 0);
  const Two x772 = taken<Two>(w.x.data() + 2);
  const Two x775 = taken<Two>(w.x.data() + 4);
  const Two x778 = taken<Two>(w.x.data() + 6);
  const Two x783 = taken<Two>(w.x.data() + 8);
  const Real x1046 = w.x[21];
  const Real x1047 = w.x[22];
  const Real x1048 = w.x[23];
  const Real x1050 = w.x[24];
  const Real x1051 = w.x[25];
  const Real x1053 = w.x[26];
  const Two x1635 = taken<Two>(w.x.data() + 66);
  const Two x1638 = taken<Two>(w.x.data() + 68);
  const Two x1646 = taken<Two>(w.x.data() + 70);
  const Two x1652 = taken<Two>(w.x.data() + 72);
  const Two x1661 = taken<Two>(w.x.data() + 74);
  const Two x1665 = taken<Two>(w.x.data() + 76);
  const Two x1677 = taken<Two>(w.x.data() + 78);
  const Two x1705 = taken<Two>(w.x.data() + 80);
  const Two x1706 = taken<Two>(w.x.data() + 82);
  const Two x1708 = taken<Two>(w.x.data() + 84);
  const Two x1709 = taken<Two>(w.x.data() + 86);
  const Two x1710 = taken<Two>(w.x.data() + 88);
  const Two x1711 = taken<Two>(w.x.data() + 90);
  const Two x1712 = taken<Two>(w.x.data() + 92);
  const Two x1713 = taken<Two>(w.x.data() + 94);
  const Two x1715 = taken<Two>(w.x.data() + 96);
  const Two x1716 = taken<Two>(w.x.data() + 98);
  const Two x1717 = taken<Two>(w.x.data() + 100);
  const Two x1720 = taken<Two>(w.x.data() + 102);
  const Two x1723 = taken<Two>(w.x.data() + 104);
  const Two x1725 = taken<Two>(w.x.data() + 108);
  const Two x1726 = taken<Two>(w.x.data() + 110);
  const Two x1727 = taken<Two>(w.x.data() + 112);
  const Two x1728 = taken<Two>(w.x.data() + 114);
  const Two x1731 = taken<Two>(w.x.data() + 116);
  const Two x1732 = taken<Two>(w.x.data() + 118);
  // joints 2 "left_hip_roll", 8 "right_hip_roll": articulated-body inertia and bias force through them
  const Two x1736 = x1652 - x1677 * x1726;
  const Two x1739 = x1705 - x1677 * x1727;
  const Two x1742 = x1706 - x1677 * x1728;
  const Two x1745 = 0.00187 - 0.00096 * x1725;
  const Two x1748 = 0.024 - 0.00096 * x1726;
  const Two x1749 = 0.00096 * x1727;
  const Two x1751 = 0.00096 * x1728;
  const Two x1755 = x1709 - x1708 * x1726;
  const Two x1758 = x1638 - x1708 * x1727;
  const Two x1761 = x1646 - x1708 * x1728;
  const Two x1764 = x1710 - x1661 * x1727;
  const Two x1767 = x1635 - x1661 * x1728;
  const Two x1770 = x1711 - x1665 * x1728;
  const Two x1772 = x1712 + x1677 * x1723;
  const Two x1774 = x1713 + 0.00096 * x1723;
  const Two x1776 = x1715 + x1708 * x1723;
  const Two x1778 = x1716 + x1661 * x1723;
  const Two x1780 = x1717 + x1665 * x1723;
  const Two x1784 = taken<Two>(cosine + 2) * x1742 + taken<Two>(sine + 2) * x1751;
  const Two x1788 = taken<Two>(sine + 2) * x1742 - taken<Two>(cosine + 2) * x1751;
  const Two x1794 = taken<Two>(cosine + 2) * (x1736 + x1749) - taken<Two>(sine + 2) * (x1739 + x1748);
  const Two x1795 = taken<Two>(sine + 2) * x1794;
  const Two x1797 = x1739 + x1795;
  const Two x1799 = taken<Two>(cosine + 2) * x1794;
  const Two x1800 = x1799 - x1749;
  const Two x1804 = taken<Two>(sine + 2) * 2.0;
  const Two x1808 = taken<Two>(cosine + 2) * (x1731 - x1745) + x1732 * x1804;
  const Two x1812 = taken<Two>(cosine + 2) * x1808;
  const Two x1818 = taken<Two>(cosine + 2) * x1761 - taken<Two>(sine + 2) * x1767;
  const Two x1821 = taken<Two>(sine + 2) * x1761 + taken<Two>(cosine + 2) * x1767;
  const Two x1826 = taken<Two>(cosine + 2) * (x1755 - x1764) - x1758 * x1804;
  const Two x1829 = x1758 + taken<Two>(sine + 2) * x1826;
  const Two x1830 = taken<Two>(cosine + 2) * x1826;
  const Two x1832 = x1755 - x1830;
  const Two x1833 = Two{0.04, -0.04} * x1821;
  const Two x1835 = x1736 - x1799 - x1833;
  const Two x1836 = Two{0.04, -0.04} * x1832;
  const Two x1839 = x1788 - Two{0.04, -0.04} * x1770;
  const Two x1854 = taken<Two>(sine + 2) * x1808 - x1732 - Two{0.04, -0.04} * x1784;
  const Two x1856 = Two{0.04, -0.04} * x1797;
  const Two x1870 = taken<Two>(sine + 2) * x1776 + taken<Two>(cosine + 2) * x1778;
  const Two x1850 = x1731 - x1812 - (Two{0.04, -0.04} * x1788 + Two{0.04, -0.04} * x1839);
  const Two x1880 = x1745 + x1812 + 0.00175;
  require_more(w, x1880, 0.0, kFactorization, {1, 7});
  const Two x1873 = taken<Two>(sine + 2) * x1772 + taken<Two>(cosine + 2) * x1774 - Two{0.04, -0.04} * x1780;
  // joints 1 "left_hip_pitch", 7 "right_hip_pitch": articulated-body inertia and bias force through them
  const Two x1891 = Two{tau[6], tau[12]};
  const Two x1892 = 1 / x1880;
  const Two x1894 = x1892 * (x1891 - (taken<Two>(cosine + 2) * x1772 - taken<Two>(sine + 2) * x1774));
  put(x1894, w.x.data() + 120);
  const Two x1895 = x1854 * x1892;
  put(x1895, w.x.data() + 122);
  const Two x1896 = x1856 * x1892;
  put(x1896, w.x.data() + 124);
  const Two x1897 = x1797 * x1892;
  put(x1897, w.x.data() + 126);
  const Two x1898 = x1784 * x1892;
  put(x1898, w.x.data() + 128);
  const Two x1899 = x1800 * x1892;
  put(x1899, w.x.data() + 130);
  const Two x1902 = 0.00308 + x1850 - x1854 * x1895;
  const Two x1905 = Two{0.04, -0.04} * x1835 - x1854 * x1896;
  const Two x1908 = x1835 - x1854 * x1897;
  const Two x1911 = Two{-0.041999999999999996, 0.041999999999999996} + x1839 - x1854 * x1898;
  const Two x1914 = x1748 + x1795 - Two{0.04, -0.04} * x1818 - x1854 * x1899;
  const Two x1917 = 0.00308 + Two{0.04, -0.04} * x1836 - x1856 * x1896;
  const Two x1920 = Two{0.041999999999999996, -0.041999999999999996} + x1836 - x1856 * x1897;
  const Two x1923 = x1833 - x1856 * x1898;
  const Two x1926 = Two{0.04, -0.04} * x1829 - x1856 * x1899;
  const Two x1929 = 1.4 + x1832 - x1797 * x1897;
  const Two x1932 = x1821 - x1797 * x1898;
  const Two x1935 = x1829 - x1797 * x1899;
  const Two x1938 = 1.4 + x1770 - x1784 * x1898;
  const Two x1941 = x1818 - x1784 * x1899;
  const Two x1944 = x1764 + x1830 + 1.4 - x1800 * x1899;
  const Two x1946 = x770 + x1873 + x1854 * x1894;
  const Two x1948 = x1720 + Two{0.04, -0.04} * x1870 + x772 + x1856 * x1894;
  const Two x1950 = x775 + x1870 + x1797 * x1894;
  const Two x1952 = x778 + x1780 + x1784 * x1894;
  // joints 2 "left_hip_roll", 8 "right_hip_roll": articulated-body inertia and bias force through them
  const Two x1888 = taken<Two>(cosine + 2) * x1776 - taken<Two>(sine + 2) * x1778 - x783;
  // joints 1 "left_hip_pitch", 7 "right_hip_pitch": articulated-body inertia and bias force through them
  const Two x1954 = x1888 + x1800 * x1894;
  const Two x1958 = taken<Two>(cosine + 0) * x1914 - taken<Two>(sine + 0) * x1926;
  const Two x1961 = taken<Two>(sine + 0) * x1914 + taken<Two>(cosine + 0) * x1926;
  const Two x1967 = taken<Two>(cosine + 0) * (x1908 - x1923) - taken<Two>(sine + 0) * (x1911 + x1920);
  const Two x1968 = taken<Two>(sine + 0) * x1967;
  const Two x1970 = x1911 + x1968;
  const Two x1971 = x1920 + x1968;
  const Two x1972 = taken<Two>(cosine + 0) * x1967;
  const Two x1973 = x1923 + x1972;
  const Two x1977 = taken<Two>(sine + 0) * 2.0;
  const Two x1981 = taken<Two>(cosine + 0) * (x1902 - x1917) - x1905 * x1977;
  const Two x1985 = taken<Two>(cosine + 0) * x1981;
  const Two x1991 = taken<Two>(cosine + 0) * x1935 - taken<Two>(sine + 0) * x1941;
  const Two x1994 = taken<Two>(sine + 0) * x1935 + taken<Two>(cosine + 0) * x1941;
  const Two x1999 = taken<Two>(cosine + 0) * (x1929 - x1938) - x1932 * x1977;
  const Two x2002 = x1932 + taken<Two>(sine + 0) * x1999;
  const Two x2003 = taken<Two>(cosine + 0) * x1999;
  const Two x2004 = x1938 + x2003;
  const Two x2005 = x1929 - x2003;
  const Two x2006 = Two{0.09, -0.09} * x2002;
  const Two x2007 = 0.05 * x1994;
  const Two x2010 = x1908 - x1972 + x2007 + x2006;
  const Two x2011 = 0.05 * x2005;
  const Two x2015 = x1970 - Two{0.09, -0.09} * x2005;
  const Two x2020 = x1961 + 0.05 * x1944 + Two{0.09, -0.09} * x1991;
  const Two x2023 = x1958 - Two{0.09, -0.09} * x1994;
  const Two x2028 = x1971 + 0.05 * x1991 + Two{0.09, -0.09} * x2004;
  const Two x2029 = 0.05 * x2002;
  const Two x2032 = x1973 - x2006;
  const Two x2040 = x1902 - x1985 + 0.05 * x1961 + 0.05 * x2020;
  const Two x2042 = Two{0.09, -0.09} * x1971 + x2040 + Two{0.09, -0.09} * x2028;
  const Two x2043 = 0.05 * x2010;
  const Two x2050 = x1905 + taken<Two>(sine + 0) * x1981 + 0.05 * x1958;
  const Two x2052 = Two{0.09, -0.09} * x1973 + x2050 - Two{0.09, -0.09} * x2010;
  const Two x2053 = 0.05 * x2011;
  const Two x2059 = Two{0.09, -0.09} * x2011 - 0.05 * x1970;
  const Two x2065 = x1917 + x1985 - Two{0.09, -0.09} * x1970 - Two{0.09, -0.09} * x2015;
  const Two x2076 = taken<Two>(cosine + 0) * x1950 - taken<Two>(sine + 0) * x1952;
  const Two x2079 = taken<Two>(sine + 0) * x1950 + taken<Two>(cosine + 0) * x1952;
  const Two x2083 = taken<Two>(sine + 0) * x1946 + taken<Two>(cosine + 0) * x1948 + 0.05 * x1954;
  const Two x2084 = Two{0.09, -0.09} * x2076 + x2083;
  const Two x2087 = x1891 - 0.05 * x2079;
  const Two x2090 = taken<Two>(cosine + 0) * x1946 - taken<Two>(sine + 0) * x1948 - Two{0.09, -0.09} * x2079;
  const Real x2102 = across<2>(x2007);
  const Real x2107 = across<2>(x2015);
  const Real x2108 = across<2>(x2023);
  const Real x2109 = across<2>(x2032);
  const Real x2111 = across<2>(x1994);
  const Real x2112 = across<2>(x2002);
  const Real x2114 = across<2>(x1991);
  const Real x2117 = -0.12400000000000001 + across<2>(x2020);
  const Real x2119 = 0.12400000000000001 - across<2>(x2011);
  const Real x2120 = 0.0351333 + across<2>(x2065);
  require_more(w, x2120, 0.0, kFactorization, 13);
  const Real x2121 = 6.2 + across<2>(x2005);
  const Real x2122 = 6.2 + across<2>(x1944);
  const Real x2133 = x1046 + across<2>(x2079);
  const Real x2134 = x1047 + across<2>(x1954);
  // joint 13 "waist_yaw": articulated-body inertia and bias force through it
  const Real x2136 = 0.09 * x2111;
  const Real x2138 = across<2>(x2010) + x2136;
  const Real x2141 = x2119 - 0.09 * x2121;
  const Real x2144 = x2117 + 0.09 * x2122;
  const Real x2145 = x2102 + x2136;
  const Real x2149 = across<2>(x2028) + 0.09 * x2114;
  const Real x2152 = across<2>(x2029) + 0.09 * x2112;
  const Real x2159 = 0.034926700000000005 + across<2>(x2042) + (0.09 * x2117 + 0.09 * x2144);
  const Real x2166 = across<2>(x2043) + 0.09 * x2102 + 0.09 * x2138;
  const Real x2170 = across<2>(x2052) + 0.09 * x2108;
  const Real x2176 = 0.0200467 + across<2>(x2053) - 0.09 * x2119 - 0.09 * x2141;
  const Real x2179 = across<2>(x2059) - 0.09 * x2107;
  const Real x2192 = cosine[12] * x2107 + sine[12] * x2108;
  const Real x2196 = cosine[12] * x2108 - sine[12] * x2107;
  const Real x2201 = cosine[12] * (x2138 + x2145) + sine[12] * (x2141 + x2144);
  const Real x2202 = sine[12] * x2201;
  const Real x2205 = cosine[12] * x2201;
  const Real x2210 = cosine[12] * x2170 + sine[12] * x2179;
  const Real x2214 = cosine[12] * x2179 - sine[12] * x2170;
  const Real x2217 = 2.0 * sine[12];
  const Real x2220 = cosine[12] * (x2159 - x2176) - x2166 * x2217;
  const Real x2224 = cosine[12] * x2220;
  const Real x2237 = cosine[12] * (x2121 - x2122) + x2111 * x2217;
  const Real x2240 = cosine[12] * x2237;
  const Real x2245 = x1050 + across<2>(x2084) + 0.09 * x2134;
  const Real x2248 = across<2>(x2087) - x1051 - 0.09 * x2133;
  const Real x2266 = 1 / x2120;
  const Real x2269 = x2266 * (across<2>(x2090) - x1053 + tau[18]);
  w.x[132] = x2269;
  const Real x2271 = x2210 * x2266;
  w.x[133] = x2271;
  const Real x2272 = x2214 * x2266;
  w.x[134] = x2272;
  const Real x2273 = x2192 * x2266;
  w.x[135] = x2273;
  const Real x2274 = x2196 * x2266;
  w.x[136] = x2274;
  const Real x2275 = x2109 * x2266;
  w.x[137] = x2275;
  const Real x2300 = x2138 - x2205 - x2214 * x2274;
  const Real x2310 = x2111 - sine[12] * x2237 - x2192 * x2274;
  const Real x2313 = cosine[12] * x2112 + sine[12] * x2114 - x2192 * x2275;
  const Real x2319 = cosine[12] * x2114 - sine[12] * x2112 - x2196 * x2275;
  const Real x2339 = x2144 - x2202 - x2210 * x2274 + -0.016;
  const Real x2341 = x2141 - x2202 - x2214 * x2273 + 0.016;
  const Real x2342 = x2122 + x2240 - x2192 * x2273 + 0.8;
  const Real x2343 = x2121 - x2240 - x2196 * x2274 + 0.8;
  const Real x2344 = 6.2 + across<2>(x2004) - x2109 * x2275 + 0.8;
  const Real x2325 = cosine[12] * x2245 + sine[12] * x2248 - x2210 * x2269;
  const Real x2328 = cosine[12] * x2248 - sine[12] * x2245 - x2214 * x2269;
  const Real x2331 = cosine[12] * x2133 + sine[12] * x2134 - x2192 * x2269;
  const Real x2347 = x709 + x2331;
  const Real x2334 = cosine[12] * x2134 - sine[12] * x2133 - x2196 * x2269;
  const Real x2348 = x712 + x2334;
  const Real x2349 = across<2>(x2076) - x1048 - x2109 * x2269 - x717;
  // joint 14 "waist_roll": articulated-body inertia and bias force through it
  const Real x2350 = 0.05 * x2310;
  const Real x2352 = x2205 - x2145 - x2210 * x2273 + x2350;
  const Real x2355 = x2341 - 0.05 * x2342;
  const Real x2358 = x2339 + 0.05 * x2343;
  const Real x2359 = x2300 - x2350;
  // joint 13 "waist_yaw": articulated-body inertia and bias force through it
  const Real x2291 = cosine[12] * x2149 - sine[12] * x2152 - x2210 * x2275;
  // joint 14 "waist_roll": articulated-body inertia and bias force through it
  const Real x2362 = x2291 + 0.05 * x2319;
  // joint 13 "waist_yaw": articulated-body inertia and bias force through it
  const Real x2303 = sine[12] * x2149 + cosine[12] * x2152 + x2214 * x2275;
  // joint 14 "waist_roll": articulated-body inertia and bias force through it
  const Real x2365 = x2303 + 0.05 * x2313;
  // joint 13 "waist_yaw": articulated-body inertia and bias force through it
  const Real x2338 = x2176 + x2224 - x2210 * x2271 + 0.00106;
  // joint 14 "waist_roll": articulated-body inertia and bias force through it
  const Real x2372 = x2338 + 0.05 * x2339 + 0.05 * x2358;
  require_more(w, x2372, 0.0, kFactorization, 14);
  // joint 13 "waist_yaw": articulated-body inertia and bias force through it
  const Real x2281 = x2166 + sine[12] * x2220 + x2210 * x2272;
  // joint 14 "waist_roll": articulated-body inertia and bias force through it
  const Real x2378 = 0.05 * x2300 - x2281 - 0.05 * x2352;
  // joint 13 "waist_yaw": articulated-body inertia and bias force through it
  const Real x2340 = x2159 - x2224 - x2214 * x2272 + 0.00106;
  // joint 14 "waist_roll": articulated-body inertia and bias force through it
  const Real x2384 = x2340 - 0.05 * x2341 - 0.05 * x2355;
  const Real x2390 = cosine[13] * x2358 + sine[13] * x2362;
  const Real x2394 = cosine[13] * x2362 - sine[13] * x2358;
  const Real x2398 = cosine[13] * x2359 - sine[13] * x2365;
  const Real x2399 = sine[13] * x2398;
  const Real x2403 = cosine[13] * x2398;
  const Real x2405 = cosine[13] * x2378;
  const Real x2406 = sine[13] * x2378;
  const Real x2409 = cosine[13] * (x2384 - 0.001);
  const Real x2413 = cosine[13] * x2409;
  const Real x2426 = cosine[13] * (x2343 - x2344) + x2319 * (2.0 * sine[13]);
  const Real x2429 = cosine[13] * x2426;
  const Real x2437 = x706 + x2328 - 0.05 * x2347;
  const Real x2457 = 1 / x2372;
  const Real x2460 = x2457 * (x704 + x2325 + 0.05 * x2348 + tau[19]);
  w.x[138] = x2460;
  const Real x2462 = x2405 * x2457;
  w.x[139] = x2462;
  const Real x2463 = x2406 * x2457;
  w.x[140] = x2463;
  const Real x2465 = x2390 * x2457;
  w.x[141] = x2465;
  const Real x2466 = x2394 * x2457;
  w.x[142] = x2466;
  const Real x2467 = x2352 * x2457;
  w.x[143] = x2467;
  const Real x2489 = x2406 * x2465 - x2399;
  const Real x2492 = x2359 - x2403 + x2406 * x2466;
  const Real x2495 = x2406 * x2467 - sine[13] * x2355;
  const Real x2501 = x2319 - sine[13] * x2426 - x2390 * x2466;
  const Real x2504 = cosine[13] * x2310 + sine[13] * x2313 - x2390 * x2467;
  const Real x2510 = cosine[13] * x2313 - sine[13] * x2310 - x2394 * x2467;
  const Real x2530 = cosine[13] * x2355 - x2405 * x2467 + 0.018000000000000002;
  const Real x2531 = x2384 - x2413 - x2406 * x2463 + 0.001125;
  const Real x2532 = x2344 + x2429 - x2390 * x2465 + 0.9;
  const Real x2533 = x2343 - x2429 - x2394 * x2466 + 0.9;
  const Real x2534 = x2342 - x2352 * x2467 + 0.9;
  const Real x2516 = cosine[13] * x2437 - sine[13] * tau[18] - x2405 * x2460;
  const Real x2519 = x2406 * x2460 - (sine[13] * x2437 + cosine[13] * tau[18]);
  const Real x2536 = x657 + x2519;
  const Real x2522 = cosine[13] * x2348 + sine[13] * x2349 - x2390 * x2460;
  const Real x2538 = x672 + x2522;
  const Real x2525 = cosine[13] * x2349 - sine[13] * x2348 - x2394 * x2460;
  const Real x2539 = x2525 - x677;
  const Real x2540 = x2347 - x2352 * x2460 + x681;
  // joint 15 "waist_pitch": articulated-body inertia and bias force through it
  const Real x2541 = 0.04 * x2504;
  const Real x2543 = x2403 - x2405 * x2465 - x2541;
  const Real x2546 = -0.018000000000000002 + 0.04 * x2532;
  const Real x2549 = x2365 + x2399 + x2405 * x2466 + 0.04 * x2510;
  const Real x2551 = 0.04 * x2501;
  const Real x2555 = x2530 - 0.04 * x2534;
  // joint 14 "waist_roll": articulated-body inertia and bias force through it
  const Real x2529 = 0.001 + x2413 - x2405 * x2462 + 0.0014025;
  // joint 15 "waist_pitch": articulated-body inertia and bias force through it
  const Real x2561 = x2529 - 0.04 * x2530 - 0.04 * x2555;
  require_more(w, x2561, 0.0, kFactorization, 15);
  const Real x2564 = x2405 * x2463 - sine[13] * x2409 - 0.04 * x2495;
  const Real x2565 = 0.04 * x2543;
  const Real x2567 = 0.04 * x2489;
  const Real x2574 = 0.04 * x2546 + 0.0006825;
  const Real x2585 = sine[14] * x2555 - cosine[14] * x2549;
  const Real x2589 = sine[14] * x2549 + cosine[14] * x2555;
  const Real x2594 = cosine[14] * (x2492 - x2541) + sine[14] * (x2495 + x2551);
  const Real x2595 = sine[14] * x2594;
  const Real x2598 = cosine[14] * x2594;
  const Real x2603 = cosine[14] * x2564 + sine[14] * x2565;
  const Real x2607 = cosine[14] * x2565 - sine[14] * x2564;
  const Real x2610 = 2.0 * sine[14];
  const Real x2612 = cosine[14] * (x2531 - x2574) + x2567 * x2610;
  const Real x2615 = cosine[14] * x2612;
  const Real x2628 = cosine[14] * (x2533 - x2534) + x2510 * x2610;
  const Real x2631 = cosine[14] * x2628;
  const Real x2639 = x669 - tau[19] + 0.04 * x2538;
  const Real x2655 = -tau[20];
  w.to[0][17] = x2655;
  const Real x2656 = 1 / x2561;
  const Real x2659 = x2656 * (x666 + x2516 - 0.04 * x2540 + tau[20]);
  w.x[144] = x2659;
  const Real x2661 = x2603 * x2656;
  w.x[145] = x2661;
  const Real x2662 = x2607 * x2656;
  w.x[146] = x2662;
  const Real x2663 = x2585 * x2656;
  w.x[147] = x2663;
  const Real x2664 = x2589 * x2656;
  w.x[148] = x2664;
  const Real x2665 = x2543 * x2656;
  w.x[149] = x2665;
  const Real x2668 = x2574 + x2615 - x2603 * x2661;
  w.x[150] = x2668;
  w.to[0][0] = x2668;
  const Real x2671 = x2567 - sine[14] * x2612 - x2603 * x2662;
  w.x[151] = x2671;
  w.to[0][1] = x2671;
  const Real x2674 = x2541 + x2598 - x2603 * x2663;
  w.x[152] = x2674;
  w.to[0][2] = x2674;
  const Real x2677 = x2495 - x2595 - x2603 * x2664;
  w.x[153] = x2677;
  w.to[0][3] = x2677;
  const Real x2680 = cosine[14] * x2489 + sine[14] * x2546 - x2603 * x2665;
  w.x[154] = x2680;
  w.to[0][4] = x2680;
  const Real x2683 = x2531 - x2615 - x2607 * x2662;
  w.x[155] = x2683;
  w.to[0][5] = x2683;
  const Real x2686 = x2551 - x2595 - x2607 * x2663;
  w.x[156] = x2686;
  w.to[0][6] = x2686;
  const Real x2689 = x2492 - x2598 - x2607 * x2664;
  w.x[157] = x2689;
  w.to[0][7] = x2689;
  const Real x2692 = cosine[14] * x2546 - sine[14] * x2489 - x2607 * x2665;
  w.x[158] = x2692;
  w.to[0][8] = x2692;
  const Real x2695 = x2534 + x2631 - x2585 * x2663;
  w.x[159] = x2695;
  w.to[0][9] = x2695;
  const Real x2698 = x2510 - sine[14] * x2628 - x2585 * x2664;
  w.x[160] = x2698;
  w.to[0][10] = x2698;
  const Real x2701 = cosine[14] * x2501 + sine[14] * x2504 - x2585 * x2665;
  w.x[161] = x2701;
  w.to[0][11] = x2701;
  const Real x2704 = x2533 - x2631 - x2589 * x2664;
  w.x[162] = x2704;
  w.to[0][12] = x2704;
  const Real x2707 = cosine[14] * x2504 - sine[14] * x2501 - x2589 * x2665;
  w.x[163] = x2707;
  w.to[0][13] = x2707;
  const Real x2710 = x2532 - x2543 * x2665;
  w.x[164] = x2710;
  w.to[0][14] = x2710;
  const Real x2713 = cosine[14] * x2536 + sine[14] * x2639 - x2603 * x2659;
  w.x[165] = x2713;
  w.to[0][15] = x2713;
  const Real x2716 = cosine[14] * x2639 - sine[14] * x2536 - x2607 * x2659;
  w.x[166] = x2716;
  w.to[0][16] = x2716;
  const Real x2719 = cosine[14] * x2539 + sine[14] * x2540 - x2585 * x2659;
  w.x[167] = x2719;
  w.to[0][18] = x2719;
  const Real x2722 = cosine[14] * x2540 - sine[14] * x2539 - x2589 * x2659;
  w.x[168] = x2722;
  w.to[0][19] = x2722;
  const Real x2725 = x2538 - x2543 * x2659;
  w.x[169] = x2725;
  w.to[0][20] = x2725;
}

ADAGEN_NOINLINE ADAGEN_AS_IT_STANDS void part_0_2(Workspace& w) {
  ADAGEN_INPUTS
  // joint 0 "__base__": placement, velocity and reference acceleration of its link
  const Real x50 = q[3] * q[3] + q[4] * q[4] + q[5] * q[5];
  const Real x51 = q[6] * q[6] + x50;
  require_length(w, x51, 0);
  const Real x54 = 1 / x51 * 2.0;
  const Real x55 = q[3] * x54;
  const Real x56 = q[4] * x54;
  const Real x80 = (q[5] * x55 - q[6] * x56) * 9.81;
  const Real x87 = v[2] * v[4] - v[1] * v[5] + x80;
  w.x[26] = x87;
  const Real x81 = (q[5] * x56 + q[6] * x55) * 9.81;
  const Real x92 = v[0] * v[5] - v[2] * v[3] + x81;
  w.x[25] = x92;
  const Real x82 = (1.0 - (q[4] * x56 + q[3] * x55)) * 9.81;
  const Real x97 = v[1] * v[3] - v[0] * v[4] + x82;
  w.x[24] = x97;
}

ADAGEN_NOINLINE ADAGEN_AS_IT_STANDS void part_0_3(Workspace& w) {
  ADAGEN_INPUTS
  const Real x87 = w.x[26];
  const Real x92 = w.x[25];
  const Real x97 = w.x[24];
  const Two x1060 = taken<Two>(w.x.data() + 28);
  const Two x1162 = taken<Two>(w.x.data() + 30);
  const Two x1163 = taken<Two>(w.x.data() + 32);
  const Two x1164 = taken<Two>(w.x.data() + 34);
  const Two x1165 = taken<Two>(w.x.data() + 36);
  const Two x1166 = taken<Two>(w.x.data() + 38);
  const Two x1167 = taken<Two>(w.x.data() + 40);
  const Two x1352 = taken<Two>(w.x.data() + 42);
  const Two x1353 = taken<Two>(w.x.data() + 44);
  const Two x1355 = taken<Two>(w.x.data() + 46);
  const Two x1356 = taken<Two>(w.x.data() + 48);
  const Two x1357 = taken<Two>(w.x.data() + 50);
  const Two x1358 = taken<Two>(w.x.data() + 52);
  const Two x1536 = taken<Two>(w.x.data() + 54);
  const Two x1537 = taken<Two>(w.x.data() + 56);
  const Two x1538 = taken<Two>(w.x.data() + 58);
  const Two x1540 = taken<Two>(w.x.data() + 60);
  const Two x1541 = taken<Two>(w.x.data() + 62);
  const Two x1542 = taken<Two>(w.x.data() + 64);
  const Two x1723 = taken<Two>(w.x.data() + 104);
  const Two x1724 = taken<Two>(w.x.data() + 106);
  const Two x1725 = taken<Two>(w.x.data() + 108);
  const Two x1726 = taken<Two>(w.x.data() + 110);
  const Two x1727 = taken<Two>(w.x.data() + 112);
  const Two x1728 = taken<Two>(w.x.data() + 114);
  const Two x1894 = taken<Two>(w.x.data() + 120);
  const Two x1895 = taken<Two>(w.x.data() + 122);
  const Two x1896 = taken<Two>(w.x.data() + 124);
  const Two x1897 = taken<Two>(w.x.data() + 126);
  const Two x1898 = taken<Two>(w.x.data() + 128);
  const Two x1899 = taken<Two>(w.x.data() + 130);
  const Real x2269 = w.x[132];
  const Real x2271 = w.x[133];
  const Real x2272 = w.x[134];
  const Real x2273 = w.x[135];
  const Real x2274 = w.x[136];
  const Real x2275 = w.x[137];
  const Real x2460 = w.x[138];
  const Real x2462 = w.x[139];
  const Real x2463 = w.x[140];
  const Real x2465 = w.x[141];
  const Real x2466 = w.x[142];
  const Real x2467 = w.x[143];
  const Real x2659 = w.x[144];
  const Real x2661 = w.x[145];
  const Real x2662 = w.x[146];
  const Real x2663 = w.x[147];
  const Real x2664 = w.x[148];
  const Real x2665 = w.x[149];
  const Real x2668 = w.x[150];
  const Real x2671 = w.x[151];
  const Real x2674 = w.x[152];
  const Real x2677 = w.x[153];
  const Real x2680 = w.x[154];
  const Real x2683 = w.x[155];
  const Real x2686 = w.x[156];
  const Real x2689 = w.x[157];
  const Real x2692 = w.x[158];
  const Real x2695 = w.x[159];
  const Real x2698 = w.x[160];
  const Real x2701 = w.x[161];
  const Real x2704 = w.x[162];
  const Real x2707 = w.x[163];
  const Real x2710 = w.x[164];
  const Real x2713 = w.x[165];
  const Real x2716 = w.x[166];
  const Real x2719 = w.x[167];
  const Real x2722 = w.x[168];
  const Real x2725 = w.x[169];
  // message received
  const Real x2726 = w.from[1][0];
  const Real x2727 = w.from[1][1];
  const Real x2732 = w.from[1][6];
  const Real x2728 = w.from[1][2];
  const Real x2733 = w.from[1][7];
  const Real x2737 = w.from[1][11];
  const Real x2729 = w.from[1][3];
  const Real x2734 = w.from[1][8];
  const Real x2738 = w.from[1][12];
  const Real x2741 = w.from[1][15];
  const Real x2730 = w.from[1][4];
  const Real x2735 = w.from[1][9];
  const Real x2739 = w.from[1][13];
  const Real x2742 = w.from[1][16];
  const Real x2731 = w.from[1][5];
  const Real x2744 = w.from[1][18];
  const Real x2736 = w.from[1][10];
  const Real x2740 = w.from[1][14];
  const Real x2743 = w.from[1][17];
  const Real x2745 = w.from[1][19];
  const Real x2762 = w.from[1][21];
  const Real x2763 = w.from[1][22];
  const Real x2746 = w.from[1][20];
  const Real x2764 = w.from[1][23];
  const Real x2765 = w.from[1][24];
  const Real x2766 = w.from[1][25];
  const Real x2767 = w.from[1][26];
  const Real x2747 = x2668 + x2726;
  require_more(w, x2747, 0.0, kFactorization, 15);
  const Real x2748 = x2671 + x2727;
  const Real x2752 = x2683 + x2732;
  const Real x2749 = x2674 + x2729;
  const Real x2756 = x2695 + x2741;
  const Real x2750 = x2677 + x2730;
  const Real x2751 = x2680 + x2731;
  const Real x2759 = x2704 + x2744;
  const Real x2768 = x2713 + x2762;
  const Real x2761 = x2710 + x2746;
  // link 16 "torso": acceleration from its articulated-body inertia
  const Real x2902 = x2737 * 1.7763568394002505e-15;
  const Real x2774 = 1 / x2747;
  const Real x2901 = x2752 * 1.7763568394002505e-15;
  const Real x2903 = x2756 * 1.7763568394002505e-15;
  const Real x2904 = x2759 * 1.7763568394002505e-15;
  const Real x2905 = x2761 * 1.7763568394002505e-15;
  const Real x2775 = x2748 * x2774;
  const Real x2776 = x2728 * x2774;
  const Real x2777 = x2749 * x2774;
  const Real x2778 = x2750 * x2774;
  const Real x2779 = x2751 * x2774;
  const Real x2782 = x2752 - x2748 * x2775;
  require_more(w, x2782, x2901, kFactorization, 15);
  const Real x2785 = x2733 - x2728 * x2775;
  const Real x2788 = x2686 + x2734 - x2749 * x2775;
  const Real x2791 = x2689 + x2735 - x2750 * x2775;
  const Real x2794 = x2692 + x2736 - x2751 * x2775;
  const Real x2795 = 1 / x2782;
  const Real x2914 = x2768 * x2775 - (x2716 + x2763);
  const Real x2796 = x2785 * x2795;
  const Real x2797 = x2788 * x2795;
  const Real x2798 = x2791 * x2795;
  const Real x2799 = x2794 * x2795;
  const Real x2805 = x2737 - x2728 * x2776 - x2785 * x2796;
  require_more(w, x2805, x2902, kFactorization, 15);
  const Real x2811 = x2738 - x2749 * x2776 - x2788 * x2796;
  const Real x2817 = x2739 - x2750 * x2776 - x2791 * x2796;
  const Real x2823 = x2740 - x2751 * x2776 - x2794 * x2796;
  const Real x2920 = x2768 * x2776 - (x2764 - tau[20]) - x2796 * x2914;
  const Real x2824 = 1 / x2805;
  const Real x2825 = x2811 * x2824;
  const Real x2826 = x2817 * x2824;
  const Real x2827 = x2823 * x2824;
  const Real x2835 = x2756 - x2749 * x2777 - x2788 * x2797;
  const Real x2836 = x2835 - x2811 * x2825;
  require_more(w, x2836, x2903, kFactorization, 15);
  const Real x2844 = x2698 + x2742 - x2750 * x2777 - x2791 * x2797;
  const Real x2845 = x2844 - x2817 * x2825;
  const Real x2867 = x2759 - x2750 * x2778 - x2791 * x2798;
  const Real x2853 = x2701 + x2743 - x2751 * x2777 - x2794 * x2797;
  const Real x2854 = x2853 - x2823 * x2825;
  const Real x2879 = x2707 + x2745 - x2751 * x2778 - x2794 * x2798;
  const Real x2895 = x2761 - x2751 * x2779 - x2794 * x2799;
  const Real x2928 = x2768 * x2777 - (x2719 + x2765) - x2797 * x2914;
  const Real x2929 = x2928 - x2825 * x2920;
  const Real x2939 = x2768 * x2778 - (x2722 + x2766) - x2798 * x2914;
  const Real x2953 = x2768 * x2779 - (x2725 + x2767) - x2799 * x2914;
  const Real x2855 = 1 / x2836;
  const Real x2856 = x2845 * x2855;
  const Real x2857 = x2854 * x2855;
  const Real x2869 = x2867 - x2817 * x2826 - x2845 * x2856;
  require_more(w, x2869, x2904, kFactorization, 15);
  const Real x2881 = x2879 - x2823 * x2826 - x2854 * x2856;
  const Real x2941 = x2939 - x2826 * x2920 - x2856 * x2929;
  const Real x2882 = 1 / x2869;
  const Real x2883 = x2881 * x2882;
  const Real x2897 = x2895 - x2823 * x2827 - x2854 * x2857;
  const Real x2898 = x2897 - x2881 * x2883;
  require_more(w, x2898, x2905, kFactorization, 15);
  const Real x2955 = x2953 - x2827 * x2920 - x2857 * x2929;
  const Real x2963 = 1 / x2898 * (x2955 - x2883 * x2941);
  const Real x2966 = x2882 * x2941 - x2883 * x2963;
  const Real x2972 = x2855 * x2929 - x2857 * x2963 - x2856 * x2966;
  const Real x2980 = x2824 * x2920 - x2827 * x2963 - x2826 * x2966;
  const Real x2981 = x2980 - x2825 * x2972;
  const Real x2991 = x2795 * x2914 - x2799 * x2963 - x2798 * x2966;
  const Real x3006 = x2768 * x2774 + x2779 * x2963 + x2778 * x2966;
  const Real x2993 = x2991 - x2797 * x2972 - x2796 * x2981;
  const Real x3010 = x2777 * x2972 + x3006 + x2776 * x2981;
  const Real x3012 = x2775 * x2993 + x3010;
  // joint 15 "waist_pitch": its acceleration, and that of the link beyond
  const Real x3026 = x2659 + x2665 * x2963 + x2664 * x2966;
  const Real x3047 = cosine[14] * x2972 - sine[14] * x2966;
  const Real x3030 = x2663 * x2972 + x3026 + x2662 * x2993;
  const Real x3032 = x2661 * x3012 - x3030;
  const Real x3038 = cosine[14] * x3012 + sine[14] * x2993;
  const Real x3043 = cosine[14] * x2993 - sine[14] * x3012;
  const Real x3052 = x2963 + 0.04 * x3043;
  const Real x3055 = sine[14] * x2972 + cosine[14] * x2966 - 0.04 * x3032;
  const Real x3056 = -(x3032 - x2981);
  w.result[20] = x3056;
  // joint 14 "waist_roll": its acceleration, and that of the link beyond
  const Real x3082 = cosine[13] * x3032 + sine[13] * x3038;
  const Real x3069 = x2460 + x2466 * x3047 + x2462 * x3032;
  const Real x3096 = x3055 - 0.05 * x3082;
  const Real x3093 = sine[13] * x3052 + cosine[13] * x3047;
  const Real x3073 = x2463 * x3038 + x3069 + x2465 * x3052;
  const Real x3075 = x2467 * x3055 + x3073;
  const Real x3077 = x3043 + x3075;
  w.result[19] = x3077;
  const Real x3099 = cosine[13] * x3052 - sine[13] * x3047 - 0.05 * x3075;
  // joint 13 "waist_yaw": its acceleration, and that of the link beyond
  const Real x3112 = x2269 + x2272 * x3082 + x2273 * x3096;
  const Real x3128 = cosine[12] * x3082 - sine[12] * x3075;
  w.result[4] = x3128;
  const Real x3123 = cosine[12] * x3075 + sine[12] * x3082;
  const Real x3124 = -x3123;
  w.result[3] = x3124;
  const Real x3116 = x2271 * x3075 - (x2275 * x3093 + x3112);
  const Real x3117 = x3116 - x2274 * x3099;
  w.result[5] = x3117;
  const Real x3138 = cosine[12] * x3096 - sine[12] * x3099 - 0.09 * x3128;
  // joints 1 "left_hip_pitch", 7 "right_hip_pitch": their accelerations, and those of the links beyond
  const Two x3155 = x3093 - Two{0.09, -0.09} * x3123;
  // joint 0 "__base__": acceleration of the base
  const Real x3371 = x3093 - x97;
  w.result[2] = x3371;
  // joint 13 "waist_yaw": its acceleration, and that of the link beyond
  const Real x3141 = sine[12] * x3096 + cosine[12] * x3099 - 0.09 * x3123;
  const Real x3142 = -(x3117 - (sine[13] * x3032 - cosine[13] * x3038));
  w.result[18] = x3142;
  // joints 1 "left_hip_pitch", 7 "right_hip_pitch": their accelerations, and those of the links beyond
  const Two x3159 = taken<Two>(cosine + 0) * x3117 - taken<Two>(sine + 0) * x3123;
  const Two x3164 = taken<Two>(sine + 0) * x3117 + taken<Two>(cosine + 0) * x3123;
  const Real x3152 = x3141 - 0.05 * x3123;
  const Two x3149 = x3138 - 0.05 * x3128 - Two{0.09, -0.09} * x3117;
  const Two x3168 = taken<Two>(cosine + 0) * x3155 + taken<Two>(sine + 0) * x3149;
  const Two x3172 = taken<Two>(cosine + 0) * x3149 - taken<Two>(sine + 0) * x3155;
  const Two x3184 = x1894 - x1895 * x3159 + x1896 * x3164;
  const Two x3186 = x3184 - x1899 * x3152 - x1897 * x3168;
  const Two x3187 = x3186 - x1898 * x3172;
  const Two x3188 = x3187 - x3128;
  put(x3188, w.lanes.data() + 0);
  // joints 2 "left_hip_roll", 8 "right_hip_roll": their accelerations, and those of the links beyond
  const Two x3194 = x3168 - Two{0.04, -0.04} * x3164;
  const Two x3197 = x3172 - Two{0.04, -0.04} * x3159;
  const Two x3207 = taken<Two>(cosine + 2) * x3152 + taken<Two>(sine + 2) * x3194;
  const Two x3211 = taken<Two>(cosine + 2) * x3194 - taken<Two>(sine + 2) * x3152;
  const Two x3200 = taken<Two>(cosine + 2) * x3187 + taken<Two>(sine + 2) * x3159;
  const Two x3204 = taken<Two>(cosine + 2) * x3159 - taken<Two>(sine + 2) * x3187;
  const Two x3223 = x1723 - x1728 * x3197 - x1726 * x3207;
  const Two x3225 = x3223 - x1727 * x3211 - x1724 * x3200;
  const Two x3226 = x3225 - x1725 * x3204;
  const Two x3227 = x3164 + x3226;
  put(x3227, w.lanes.data() + 2);
  // joints 3 "left_hip_yaw", 9 "right_hip_yaw": their accelerations, and those of the links beyond
  const Two x3234 = x3197 - 0.12 * x3200;
  const Two x3231 = x3207 + 0.12 * x3226;
  const Two x3237 = taken<Two>(cosine + 4) * x3226 + taken<Two>(sine + 4) * x3200;
  const Two x3241 = taken<Two>(cosine + 4) * x3200 - taken<Two>(sine + 4) * x3226;
  const Two x3244 = taken<Two>(cosine + 4) * x3234 + taken<Two>(sine + 4) * x3231;
  const Two x3248 = taken<Two>(cosine + 4) * x3231 - taken<Two>(sine + 4) * x3234;
  const Two x3260 = x1536 - x1542 * x3211 - x1537 * x3237;
  const Two x3262 = x1538 * x3241 + x3260 - x1540 * x3244;
  const Two x3263 = x3262 - x1541 * x3248;
  // joints 4 "left_knee", 10 "right_knee": their accelerations, and those of the links beyond
  const Two x3269 = x3244 - 0.24 * x3241;
  const Two x3271 = x3248 + 0.24 * x3237;
  const Two x3281 = taken<Two>(cosine + 6) * x3211 + taken<Two>(sine + 6) * x3269;
  const Two x3285 = taken<Two>(cosine + 6) * x3269 - taken<Two>(sine + 6) * x3211;
  // joint 0 "__base__": acceleration of the base
  const Real x3369 = x3138 - x87;
  w.result[0] = x3369;
  const Real x3370 = x3141 - x92;
  w.result[1] = x3370;
  // joints 3 "left_hip_yaw", 9 "right_hip_yaw": their accelerations, and those of the links beyond
  const Two x3264 = x3263 - x3204;
  put(x3264, w.lanes.data() + 4);
  // joints 4 "left_knee", 10 "right_knee": their accelerations, and those of the links beyond
  const Two x3274 = taken<Two>(cosine + 6) * x3263 + taken<Two>(sine + 6) * x3237;
  const Two x3278 = taken<Two>(cosine + 6) * x3237 - taken<Two>(sine + 6) * x3263;
  const Two x3297 = x1352 - x1358 * x3271 - x1356 * x3281;
  const Two x3299 = x3297 - x1357 * x3285 + x1353 * x3274;
  const Two x3300 = x3299 - x1355 * x3278;
  const Two x3301 = x3300 - x3241;
  put(x3301, w.lanes.data() + 6);
  // joints 5 "left_ankle_pitch", 11 "right_ankle_pitch": their accelerations, and those of the links beyond
  const Two x3311 = taken<Two>(cosine + 8) * x3274 + taken<Two>(sine + 8) * x3278;
  const Two x3315 = taken<Two>(cosine + 8) * x3278 - taken<Two>(sine + 8) * x3274;
  const Two x3308 = x3271 + 0.3 * x3278;
  const Two x3306 = x3285 - 0.3 * x3300;
  const Two x3334 = x1162 - x1163 * x3311 - x1164 * x3315;
  const Two x3318 = taken<Two>(cosine + 8) * x3281 + taken<Two>(sine + 8) * x3306;
  const Two x3336 = x3334 - x1167 * x3308 - x1165 * x3318;
  const Two x3337 = x3336 - x1166 * (taken<Two>(cosine + 8) * x3306 - taken<Two>(sine + 8) * x3281);
  const Two x3338 = x3337 - x3300;
  put(x3338, w.lanes.data() + 8);
  // joints 6 "left_ankle_roll", 12 "right_ankle_roll": their accelerations, and those of the links beyond
  const Two x3355 = taken<Two>(cosine + 10) * (x3308 + 0.02 * x3315) + taken<Two>(sine + 10) * x3318;
  const Two x3360 = 0.5966849180428403 * (taken<Two>(cosine + 10) * x3311 - taken<Two>(sine + 10) * x3337);
  const Two x3366 = x1060 - 19.88949726809468 * x3355 - x3360 - x3315;
  put(x3366, w.lanes.data() + 10);
}

// =================================================================================================
// Process 1: 1027 products, 914 sums, 12 quotients, 1257 of them in lanes
// =================================================================================================

ADAGEN_NOINLINE ADAGEN_AS_IT_STANDS void part_1_0(Workspace& w) {
  ADAGEN_INPUTS
  // joint 13 "waist_yaw": placement, velocity and reference acceleration of its link
  const Real x118 = v[3] * cosine[12] + v[4] * sine[12];
  const Real x122 = v[4] * cosine[12] - v[3] * sine[12];
  const Real x123 = v[5] + v[18];
  const Real x124 = v[18] * x122;
  const Real x125 = v[18] * x118;
  const Real x127 = v[3] * v[5] * 0.09;
  const Real x128 = v[4] * v[5] * 0.09;
  // joint 14 "waist_roll": placement, velocity and reference acceleration of its link
  const Real x165 = x122 * cosine[13] + x123 * sine[13];
  const Real x169 = x123 * cosine[13] - x122 * sine[13];
  const Real x170 = x118 + v[19];
  const Real x176 = v[19] * x169 - x125 * cosine[13];
  const Real x179 = x125 * sine[13] - v[19] * x165;
  // joint 13 "waist_yaw": placement, velocity and reference acceleration of its link
  const Real x133 = cosine[12] * x127 + sine[12] * x128;
  const Real x137 = cosine[12] * x128 - sine[12] * x127;
  // joint 14 "waist_roll": placement, velocity and reference acceleration of its link
  const Real x183 = x137 + (x122 * x123 - x124) * 0.05;
  // joint 13 "waist_yaw": placement, velocity and reference acceleration of its link
  const Real x129 = (v[3] * v[3] + v[4] * v[4]) * 0.09;
  // joint 14 "waist_roll": placement, velocity and reference acceleration of its link
  const Real x186 = x129 + (x118 * x118 + x122 * x122) * 0.05;
  // joint 15 "waist_pitch": placement, velocity and reference acceleration of its link
  const Real x226 = x169 * cosine[14] + x170 * sine[14];
  const Real x230 = x170 * cosine[14] - x169 * sine[14];
  const Real x231 = x165 + v[20];
  const Real x240 = x179 * cosine[14] + x124 * sine[14] + v[20] * x230;
  const Real x243 = x124 * cosine[14] - x179 * sine[14] - v[20] * x226;
  // joint 14 "waist_roll": placement, velocity and reference acceleration of its link
  const Real x191 = cosine[13] * x183 - sine[13] * x186;
  // joint 15 "waist_pitch": placement, velocity and reference acceleration of its link
  const Real x245 = x191 + (x165 * x169 - x124) * 0.04;
  const Real x246 = (x165 * x165 + x170 * x170) * 0.04;
  const Real x248 = sine[13] * x183 + cosine[13] * x186 + x246;
  // joint 14 "waist_roll": placement, velocity and reference acceleration of its link
  const Real x181 = x133 + (x118 * x123 - x125) * 0.05;
  // joint 15 "waist_pitch": placement, velocity and reference acceleration of its link
  const Real x251 = x181 + (x176 + x169 * x170) * 0.04;
  const Real x255 = sine[14] * x251 - cosine[14] * x248;
  const Real x259 = sine[14] * x248 + cosine[14] * x251;
  const Real x262 = x226 * x226;
  const Real x263 = x230 * x230;
  const Real x264 = x231 * x231;
  const Real x265 = x263 + x264;
  const Real x267 = x226 * x230;
  const Real x269 = x176 + x267;
  const Real x270 = x262 + x264;
  const Real x272 = x230 * x231;
  const Real x274 = x240 + x272;
  const Real x277 = x226 * x231;
  const Real x278 = x277 - x243;
  // link 16 "torso": force that the reference field takes
  const Real x1228 = x176 * 0.38728300000000004 + x267 * 0.34484970000000004;
  const Real x1211 = x240 * 0.0832833 - x272 * 0.040850000000000004 + x278 * 0.01615;
  const Real x1231 = x1211 + x245 * 0.095;
  w.x[0] = x1231;
  const Real x1221 = x243 * 0.42813300000000004 - x277 * 0.30399970000000004 - x274 * 0.01615;
  const Real x1234 = x1221 - x245 * 1.6150000000000002;
  w.x[1] = x1234;
  const Real x1238 = x1228 - 0.01615 * (x270 - x265) + x259 * 1.6150000000000002;
  const Real x1239 = x1238 - x255 * 0.095;
  w.x[2] = x1239;
  const Real x1244 = (x267 - x176) * 0.095 - x265 * 1.6150000000000002;
  const Real x1245 = x255 * 9.5 + x1244;
  w.x[3] = x1245;
  const Real x1251 = x269 * 1.6150000000000002 - x270 * 0.095 + x259 * 9.5;
  w.x[4] = x1251;
  const Real x1256 = x245 * 9.5 + x278 * 1.6150000000000002 + x274 * 0.095;
  w.x[5] = x1256;
  // joints 16 "left_shoulder_pitch", 24 "right_shoulder_pitch": placement, velocity and reference acceleration of their links
  const Two x282 = Two{v[21], v[29]};
  const Two x290 = taken<Two>(cosine + 0) * x226 + taken<Two>(sine + 0) * x230;
  const Two x294 = taken<Two>(cosine + 0) * x230 - taken<Two>(sine + 0) * x226;
  const Two x295 = x231 + x282;
  const Two x304 = taken<Two>(cosine + 0) * x240 + taken<Two>(sine + 0) * x243 + x282 * x294;
  const Two x307 = taken<Two>(cosine + 0) * x243 - taken<Two>(sine + 0) * x240 - x282 * x290;
  const Two x312 = x255 - x265 * 0.29 + (x243 + x277) * Two{0.15, -0.15};
  const Two x316 = x259 + x269 * 0.29 + (x272 - x240) * Two{0.15, -0.15};
  const Two x321 = x245 - (x262 + x263) * Two{0.15, -0.15} + x278 * 0.29;
  const Two x324 = taken<Two>(cosine + 0) * x312 + taken<Two>(sine + 0) * x316;
  const Two x328 = taken<Two>(cosine + 0) * x316 - taken<Two>(sine + 0) * x312;
  const Two x342 = x294 * x295;
  const Two x343 = x342 - x304;
  const Two x345 = x290 * x290 + x294 * x294;
  const Two x347 = x290 * x295;
  const Two x349 = x307 + x347;
  // links 17 "left_shoulder", 25 "right_shoulder": force that the reference field takes
  const Real x807 = x176 * 0.00064;
  w.x[6] = x807;
  const Two x811 = x304 * 0.001366667 - x342 * 0.0007266669999999999 - x328 * Two{0.024, -0.024};
  put(x811, w.x.data() + 8);
  const Two x813 = x307 * 0.001366667 + x347 * 0.0007266669999999999 + x324 * Two{0.024, -0.024};
  put(x813, w.x.data() + 10);
  const Two x816 = x324 * 0.8 + x349 * Two{0.024, -0.024};
  put(x816, w.x.data() + 12);
  const Two x819 = x328 * 0.8 + x343 * Two{0.024, -0.024};
  put(x819, w.x.data() + 14);
  const Two x823 = x321 * 0.8 - x345 * Two{0.024, -0.024};
  put(x823, w.x.data() + 16);
  // joints 17 "left_shoulder_roll", 25 "right_shoulder_roll": placement, velocity and reference acceleration of their links
  const Two x352 = Two{v[22], v[30]};
  const Two x358 = taken<Two>(cosine + 2) * x295 + taken<Two>(sine + 2) * x290;
  const Two x362 = taken<Two>(cosine + 2) * x290 - taken<Two>(sine + 2) * x295;
  const Two x363 = x294 + x352;
  const Two x372 = taken<Two>(cosine + 2) * x176 + taken<Two>(sine + 2) * x304 + x352 * x362;
  const Two x375 = taken<Two>(cosine + 2) * x304 - taken<Two>(sine + 2) * x176 - x352 * x358;
  const Two x377 = x324 + x349 * Two{0.05, -0.05};
  const Two x379 = x328 + x343 * Two{0.05, -0.05};
  const Two x382 = x321 - x345 * Two{0.05, -0.05};
  const Two x385 = taken<Two>(cosine + 2) * x382 + taken<Two>(sine + 2) * x377;
  const Two x389 = taken<Two>(cosine + 2) * x377 - taken<Two>(sine + 2) * x382;
  const Two x394 = x363 * x363;
  const Two x395 = x362 * x362 + x394;
  const Two x397 = x358 * x362;
  const Two x398 = x397 - x307;
  const Two x400 = x358 * x358 + x394;
  const Two x402 = x362 * x363;
  const Two x404 = x372 + x402;
  const Two x407 = x358 * x363;
  const Two x408 = x407 - x375;
  // links 18 "left_shoulder_cap", 26 "right_shoulder_cap": force that the reference field takes
  const Two x862 = x307 * 0.0014 - x397 * 0.00056;
  const Two x846 = x372 * 0.0013299999999999998 + x402 * 0.0006299999999999999 - x408 * Two{0.00020999999999999998, -0.00020999999999999998};
  const Two x866 = x846 - x379 * 0.020999999999999998;
  put(x866, w.x.data() + 18);
  const Two x854 = x375 * 0.00077 - x407 * 7e-05 + x404 * Two{0.00020999999999999998, -0.00020999999999999998};
  const Two x869 = x854 - x379 * Two{0.006999999999999999, -0.006999999999999999};
  put(x869, w.x.data() + 20);
  const Two x873 = Two{0.00020999999999999998, -0.00020999999999999998} * (x400 - x395) + x862 + x389 * Two{0.006999999999999999, -0.006999999999999999};
  const Two x874 = x385 * 0.020999999999999998 + x873;
  put(x874, w.x.data() + 22);
  const Two x882 = x385 * 0.7 - (x395 * Two{0.006999999999999999, -0.006999999999999999} + x398 * 0.020999999999999998);
  put(x882, w.x.data() + 24);
  const Two x887 = (x307 + x397) * Two{0.006999999999999999, -0.006999999999999999} + x400 * 0.020999999999999998;
  const Two x888 = x389 * 0.7 + x887;
  put(x888, w.x.data() + 26);
  const Two x894 = x379 * 0.7 + x408 * Two{0.006999999999999999, -0.006999999999999999} - x404 * 0.020999999999999998;
  put(x894, w.x.data() + 28);
  // joints 18 "left_shoulder_yaw", 26 "right_shoulder_yaw": placement, velocity and reference acceleration of their links
  const Two x412 = Two{v[23], v[31]};
  const Two x417 = taken<Two>(cosine + 4) * x363 + taken<Two>(sine + 4) * x358;
  const Two x421 = taken<Two>(cosine + 4) * x358 - taken<Two>(sine + 4) * x363;
  const Two x422 = x362 + x412;
  const Two x431 = taken<Two>(cosine + 4) * x307 + taken<Two>(sine + 4) * x372 + x412 * x421;
  const Two x434 = taken<Two>(cosine + 4) * x372 - taken<Two>(sine + 4) * x307 - x412 * x417;
  const Two x438 = x385 - x398 * 0.1;
  const Two x441 = x389 + x400 * 0.1;
  const Two x444 = x379 - x404 * 0.1;
  const Two x447 = taken<Two>(cosine + 4) * x444 + taken<Two>(sine + 4) * x438;
  const Two x451 = taken<Two>(cosine + 4) * x438 - taken<Two>(sine + 4) * x444;
  const Two x464 = x421 * x422;
  const Two x465 = x464 - x431;
  const Two x467 = x417 * x417 + x421 * x421;
  const Two x469 = x417 * x422;
  const Two x471 = x434 + x469;
  // links 19 "left_upper_arm", 27 "right_upper_arm": force that the reference field takes
  const Two x911 = x375 * 0.00064;
  put(x911, w.x.data() + 30);
  const Two x915 = x431 * 0.0036266700000000002 - x464 * 0.0029866700000000003 + x451 * 0.04000000000000001;
  put(x915, w.x.data() + 32);
  const Two x918 = x434 * 0.0036266700000000002 + x469 * 0.0029866700000000003 - x447 * 0.04000000000000001;
  put(x918, w.x.data() + 34);
  const Two x922 = x447 * 0.8 - x471 * 0.04000000000000001;
  put(x922, w.x.data() + 36);
  const Two x926 = x451 * 0.8 - x465 * 0.04000000000000001;
  put(x926, w.x.data() + 38);
  const Two x930 = x441 * 0.8 + x467 * 0.04000000000000001;
  put(x930, w.x.data() + 40);
  // joints 19 "left_elbow", 27 "right_elbow": placement, velocity and reference acceleration of their links
  const Two x474 = Two{v[24], v[32]};
  const Two x479 = taken<Two>(cosine + 6) * x422 + taken<Two>(sine + 6) * x417;
  const Two x483 = taken<Two>(cosine + 6) * x417 - taken<Two>(sine + 6) * x422;
  const Two x484 = x421 + x474;
  const Two x493 = taken<Two>(cosine + 6) * x375 + taken<Two>(sine + 6) * x431 + x474 * x483;
  const Two x496 = taken<Two>(cosine + 6) * x431 - taken<Two>(sine + 6) * x375 - x474 * x479;
  const Two x500 = x447 - x471 * 0.11;
  const Two x503 = x451 - x465 * 0.11;
  const Two x506 = x441 + x467 * 0.11;
  const Two x509 = taken<Two>(cosine + 6) * x506 + taken<Two>(sine + 6) * x500;
  const Two x513 = taken<Two>(cosine + 6) * x500 - taken<Two>(sine + 6) * x506;
  const Two x518 = x484 * x484;
  const Two x519 = x483 * x483 + x518;
  const Two x521 = x479 * x483;
  const Two x522 = x521 - x434;
  const Two x523 = x434 + x521;
  const Two x524 = x479 * x479 + x518;
  const Two x526 = x483 * x484;
  const Two x528 = x493 + x526;
  const Two x531 = x479 * x484;
  const Two x532 = x531 - x496;
  // links 20 "left_forearm", 28 "right_forearm": force that the reference field takes
  const Two x968 = x521 * 0.004428960000000001 + 0.00098 * (x524 - x519);
  const Two x953 = x493 * 0.00070875 + x526 * 0.00028 - x532 * 0.00098;
  const Two x971 = x953 + x503 * 0.013999999999999999;
  put(x971, w.x.data() + 42);
  const Two x962 = x496 * 0.00513771 - x531 * 0.004708960000000001 + x528 * 0.00098;
  const Two x974 = x962 + x503 * 0.049;
  put(x974, w.x.data() + 44);
  const Two x979 = x434 * 0.005417710000000001 + x968 - x513 * 0.049;
  const Two x980 = x979 - x509 * 0.013999999999999999;
  put(x980, w.x.data() + 46);
  const Two x986 = x519 * 0.049 + x522 * 0.013999999999999999 + x509 * 0.7;
  put(x986, w.x.data() + 48);
  const Two x994 = x513 * 0.7 - (x523 * 0.049 + x524 * 0.013999999999999999);
  put(x994, w.x.data() + 50);
  const Two x1000 = x503 * 0.7 - x532 * 0.049 + x528 * 0.013999999999999999;
  put(x1000, w.x.data() + 52);
  // joints 20 "left_wrist_roll", 28 "right_wrist_roll": placement, velocity and reference acceleration of their links
  const Two x536 = Two{v[25], v[33]};
  const Two x542 = taken<Two>(cosine + 8) * x483 + taken<Two>(sine + 8) * x484;
  const Two x546 = taken<Two>(cosine + 8) * x484 - taken<Two>(sine + 8) * x483;
  const Two x547 = x479 + x536;
  const Two x556 = taken<Two>(cosine + 8) * x496 + taken<Two>(sine + 8) * x434 + x536 * x546;
  const Two x559 = taken<Two>(cosine + 8) * x434 - taken<Two>(sine + 8) * x496 - x536 * x542;
  const Two x565 = x519 * 0.16 + x522 * 0.01 + x509;
  const Two x572 = x513 - (x523 * 0.16 + x524 * 0.01);
  const Two x577 = x503 - x532 * 0.16 + x528 * 0.01;
  const Two x580 = taken<Two>(cosine + 8) * x572 + taken<Two>(sine + 8) * x577;
  const Two x584 = taken<Two>(cosine + 8) * x577 - taken<Two>(sine + 8) * x572;
  const Two x597 = x546 * x547;
  const Two x598 = x597 - x556;
  const Two x600 = x542 * x542 + x546 * x546;
  const Two x602 = x542 * x547;
  const Two x604 = x559 + x602;
  // links 21 "left_wrist", 29 "right_wrist": force that the reference field takes
  const Two x1019 = x493 * 9e-05;
  put(x1019, w.x.data() + 54);
  const Two x1023 = x556 * 0.00010666669999999999 - x597 * 1.666669999999999e-05 + x584 * 0.002;
  put(x1023, w.x.data() + 56);
  const Two x1026 = x559 * 0.00010666669999999999 + x602 * 1.666669999999999e-05 - x580 * 0.002;
  put(x1026, w.x.data() + 58);
  const Two x1030 = x580 * 0.2 - x604 * 0.002;
  put(x1030, w.x.data() + 60);
  const Two x1034 = x584 * 0.2 - x598 * 0.002;
  put(x1034, w.x.data() + 62);
  const Two x1038 = x565 * 0.2 + x600 * 0.002;
  put(x1038, w.x.data() + 64);
  // joints 21 "left_wrist_pitch", 29 "right_wrist_pitch": placement, velocity and reference acceleration of their links
  const Two x607 = Two{v[26], v[34]};
  const Two x612 = taken<Two>(cosine + 10) * x547 + taken<Two>(sine + 10) * x542;
  const Two x616 = taken<Two>(cosine + 10) * x542 - taken<Two>(sine + 10) * x547;
  const Two x617 = x546 + x607;
  const Two x629 = taken<Two>(cosine + 10) * x556 - taken<Two>(sine + 10) * x493 - x607 * x612;
  const Two x632 = x580 - 0.04 * x604;
  const Two x635 = x584 - 0.04 * x598;
  const Two x638 = x565 + 0.04 * x600;
  const Two x645 = taken<Two>(cosine + 10) * x632 - taken<Two>(sine + 10) * x638;
  const Two x653 = x612 * x616;
  const Two x663 = x612 * x617;
  const Two x626 = taken<Two>(cosine + 10) * x493 + taken<Two>(sine + 10) * x556 + x607 * x616;
  // links 22 "left_hand", 30 "right_hand": force that the reference field takes
  const Two x1055 = x626 * 0.000296667 - x616 * x617 * 0.00013000000000000002;
  put(x1055, w.x.data() + 66);
  const Two x1070 = x629 * 0.002133333 - x663 * 0.001706666 + x635 * 0.024;
  put(x1070, w.x.data() + 68);
  const Two x1073 = x559 * 0.002003333 + x653 * 0.0018366659999999998 - x645 * 0.024;
  put(x1073, w.x.data() + 70);
  const Two x1074 = (taken<Two>(cosine + 10) * x638 + taken<Two>(sine + 10) * x632) * 0.4;
  const Two x1077 = x1074 + (x616 * x616 + x617 * x617) * 0.024;
  put(x1077, w.x.data() + 72);
  const Two x1081 = x645 * 0.4 - (x559 + x653) * 0.024;
  put(x1081, w.x.data() + 74);
  const Two x1085 = x635 * 0.4 - (x663 - x629) * 0.024;
  put(x1085, w.x.data() + 76);
  // joint 22 "neck_yaw": placement, velocity and reference acceleration of its link
  const Real x674 = x230 * cosine[15] + x231 * sine[15];
  const Real x678 = x231 * cosine[15] - x230 * sine[15];
  const Real x679 = x226 + v[27];
  const Real x688 = x243 * cosine[15] + x176 * sine[15] + v[27] * x678;
  const Real x691 = x176 * cosine[15] - x243 * sine[15] - v[27] * x674;
  const Real x694 = x255 - x265 * 0.38;
  const Real x696 = x259 + x269 * 0.38;
  const Real x698 = x245 + x278 * 0.38;
  const Real x701 = cosine[15] * x696 + sine[15] * x698;
  const Real x705 = cosine[15] * x698 - sine[15] * x696;
  const Real x718 = x678 * x679;
  const Real x719 = x718 - x688;
  const Real x721 = x674 * x674 + x678 * x678;
  const Real x723 = x674 * x679;
  const Real x725 = x691 + x723;
  // joint 23 "neck_pitch": placement, velocity and reference acceleration of its link
  const Real x734 = x679 * cosine[16] + x674 * sine[16];
  const Real x738 = x674 * cosine[16] - x679 * sine[16];
  const Real x739 = x678 + v[28];
  const Real x748 = x240 * cosine[16] + x688 * sine[16] + v[28] * x738;
  const Real x751 = x688 * cosine[16] - x240 * sine[16] - v[28] * x734;
  const Real x753 = x701 + x725 * 0.06;
  const Real x755 = x705 + x719 * 0.06;
  const Real x758 = x694 - x721 * 0.06;
  const Real x761 = cosine[16] * x758 + sine[16] * x753;
  const Real x765 = cosine[16] * x753 - sine[16] * x758;
  const Real x770 = x739 * x739;
  const Real x771 = x738 * x738 + x770;
  const Real x773 = x734 * x738;
  const Real x776 = x734 * x734 + x770;
  const Real x778 = x738 * x739;
  const Real x780 = x748 + x778;
  const Real x783 = x734 * x739;
  const Real x784 = x783 - x751;
  // link 24 "head": force that the reference field takes
  const Real x1156 = x691 * 0.028175999999999996 + x773 * 0.018479999999999996;
  const Real x1140 = x748 * 0.008736 + x778 * 0.00096 + x784 * 0.00432;
  const Real x1159 = x1140 + x755 * 0.048;
  const Real x1149 = x751 * 0.027215999999999997 - x783 * 0.01944 - x780 * 0.00432;
  const Real x1162 = x1149 - x755 * 0.216;
  const Real x1166 = x1156 - 0.00432 * (x776 - x771) + x765 * 0.216;
  const Real x1172 = (x773 - x691) * 0.048 - x771 * 0.216;
  const Real x1178 = (x691 + x773) * 0.216 - x776 * 0.048;
  const Real x1184 = x755 * 2.4 + x784 * 0.216 + x780 * 0.048;
  // joint 23 "neck_pitch": articulated-body inertia and bias force through it
  const Real x2269 = 35.49119818285065 * (tau[28] - (x1166 - x761 * 0.048));
  w.x[78] = x2269;
  const Real x2282 = x761 * 2.4 + x1172 - 0.048 * x2269;
  const Real x2284 = x765 * 2.4 + x1178 + 0.216 * x2269;
  const Real x2288 = cosine[16] * 0.048 + sine[16] * 0.216;
  const Real x2292 = sine[16] * 0.048 - cosine[16] * 0.216;
  const Real x2293 = 2.0 * sine[16];
  const Real x2300 = 0.00432 * x2293 - cosine[16] * 0.018479999999999996;
  const Real x2304 = cosine[16] * x2300;
  const Real x2311 = cosine[16] * 1.574105621805792 - 0.3679727427597956 * x2293;
  const Real x2314 = 0.3679727427597956 + sine[16] * x2311;
  const Real x2315 = cosine[16] * x2311;
  const Real x2317 = 2.318228279386712 - x2315;
  const Real x2318 = 0.06 * x2317;
  const Real x2321 = x2292 + -0.144;
  const Real x2322 = 0.06 * x2314;
  const Real x2332 = -0.00432 + sine[16] * x2300 - 0.06 * x2288;
  const Real x2347 = sine[16] * x2282 + cosine[16] * x2284;
  const Real x2329 = 0.008736 - x2304 - (0.06 * x2292 + 0.06 * x2321);
  const Real x2355 = 0.00037000000000000005 + 0.06 * x2318;
  const Real x2356 = 0.008 + x2318;
  const Real x2357 = 0.027215999999999997 + x2304 + 0.00018;
  require_more(w, x2357, 0.0, kFactorization, 22);
  const Real x2358 = 0.4 + x2317;
  const Real x2360 = 0.74412265758092 + x2315 + 0.4;
  w.x[79] = x2360;
  // link 23 "neck": force that the reference field takes
  const Real x1107 = x688 * 0.00037000000000000005 - x718 * 0.00019 - x705 * 0.008;
  // joint 23 "neck_pitch": articulated-body inertia and bias force through it
  const Real x2350 = sine[16] * x1159 + cosine[16] * x1162 - 0.06 * x1184;
  // link 23 "neck": force that the reference field takes
  const Real x1109 = x691 * 0.00037000000000000005 + x723 * 0.00019 + x701 * 0.008;
  // joint 23 "neck_pitch": articulated-body inertia and bias force through it
  const Real x2362 = tau[28] + 0.06 * x2347 + x1109;
  const Real x2364 = x701 * 0.4 + x725 * 0.008 + x2347;
  // link 23 "neck": force that the reference field takes
  const Real x1119 = x694 * 0.4 - x721 * 0.008;
  // joint 23 "neck_pitch": articulated-body inertia and bias force through it
  const Real x2366 = cosine[16] * x2282 - sine[16] * x2284 + x1119;
  w.x[80] = x2366;
  // joint 22 "neck_yaw": articulated-body inertia and bias force through it
  const Real x2368 = 1 / x2357;
  // joint 23 "neck_pitch": articulated-body inertia and bias force through it
  const Real x2363 = cosine[16] * x1159 - sine[16] * x1162 + x240 * 0.00018;
  // joint 22 "neck_yaw": articulated-body inertia and bias force through it
  const Real x2370 = x2368 * (tau[27] - x2363);
  w.x[81] = x2370;
  const Real x2371 = x2332 * x2368;
  w.x[82] = x2371;
  const Real x2372 = x2288 * x2368;
  w.x[83] = x2372;
  const Real x2375 = 0.00037000000000000005 + x2329 - x2332 * x2371;
  const Real x2378 = -0.008 + x2321 - x2332 * x2372;
  const Real x2381 = 2.8 - x2288 * x2372;
  const Real x2383 = x1107 + x2350 + x2332 * x2370;
  // joint 23 "neck_pitch": articulated-body inertia and bias force through it
  const Real x2365 = x705 * 0.4 + x719 * 0.008 + x1184;
  // joint 22 "neck_yaw": articulated-body inertia and bias force through it
  const Real x2385 = x2365 + x2288 * x2370;
  const Real x2390 = sine[15] * (x2356 + x2378);
  const Real x2392 = sine[15] * x2390;
  const Real x2394 = x2378 - x2392;
  const Real x2395 = x2356 - x2392;
  const Real x2396 = cosine[15] * x2390;
  const Real x2399 = cosine[15] * (x2375 - x2355);
  const Real x2404 = cosine[15] * x2399;
  const Real x2407 = cosine[15] * x2314;
  w.x[84] = x2407;
  const Real x2408 = sine[15] * x2314;
  w.x[85] = x2408;
  const Real x2410 = cosine[15] * (x2358 - x2381);
  const Real x2411 = sine[15] * x2410;
  w.x[86] = x2411;
  const Real x2413 = cosine[15] * x2410;
  const Real x2414 = x2381 + x2413;
  w.x[87] = x2414;
  const Real x2415 = x2358 - x2413;
  w.x[88] = x2415;
  const Real x2418 = sine[15] * x2322 + 0.38 * x2408;
  w.x[89] = x2418;
  const Real x2421 = cosine[15] * x2322 + 0.38 * x2407;
  w.x[90] = x2421;
  const Real x2424 = x2396 + 0.38 * x2411;
  w.x[91] = x2424;
  const Real x2427 = x2395 + 0.38 * x2414;
  w.x[92] = x2427;
  const Real x2430 = x2394 - 0.38 * x2415;
  w.x[93] = x2430;
  const Real x2436 = x2355 + x2404 - 0.38 * x2394 - 0.38 * x2430;
  w.x[94] = x2436;
  const Real x2442 = sine[15] * x2399 - 0.38 * x2396 - 0.38 * x2424;
  w.x[95] = x2442;
  const Real x2446 = x2375 - x2404 + 0.38 * x2395 + 0.38 * x2427;
  w.x[96] = x2446;
  const Real x2457 = cosine[15] * x2364 - sine[15] * x2385;
  w.x[97] = x2457;
  const Real x2460 = sine[15] * x2364 + cosine[15] * x2385;
  w.x[98] = x2460;
  const Real x2463 = cosine[15] * x2383 - sine[15] * x2362 - 0.38 * x2460;
  w.x[99] = x2463;
  const Real x2465 = sine[15] * x2383 + cosine[15] * x2362 + 0.38 * x2457;
  w.x[100] = x2465;
  // joints 21 "left_wrist_pitch", 29 "right_wrist_pitch": articulated-body inertia and bias force through them
  const Two x1284 = taken<Two>(cosine + 10) * 0.28752084650929227;
  const Two x1287 = taken<Two>(cosine + 10) * x1284;
  const Two x1289 = 0.4 - x1287;
  const Two x1334 = 0.2 + x1289;
  const Two x1270 = taken<Two>(sine + 10) * 0.024;
  put(x1270, w.x.data() + 102);
  const Two x1276 = taken<Two>(cosine + 10) * 0.0018366659999999998;
  const Two x1280 = taken<Two>(cosine + 10) * x1276;
  const Two x1333 = 0.002133333 - x1280 + 9e-05;
  require_more(w, x1333, 0.0, kFactorization, {20, 28});
  // joints 20 "left_wrist_roll", 28 "right_wrist_roll": articulated-body inertia and bias force through them
  const Two x1346 = 1 / x1333;
  put(x1346, w.x.data() + 104);
  const Two x1351 = x1270 * x1346;
  put(x1351, w.x.data() + 106);
  const Two x1361 = 0.6000000000000001 - x1270 * x1351;
  const Two x1393 = taken<Two>(cosine + 8) * (x1334 - x1361);
  const Two x1396 = taken<Two>(cosine + 8) * x1393;
  const Two x1398 = x1334 - x1396;
  // joints 21 "left_wrist_pitch", 29 "right_wrist_pitch": articulated-body inertia and bias force through them
  const Two x1290 = 0.04 * x1289;
  const Two x1332 = -0.002 - x1290;
  const Two x1272 = taken<Two>(cosine + 10) * 0.024;
  const Two x1294 = x1272 + 0.016;
  const Two x1305 = taken<Two>(sine + 10) * x1276 + 0.04 * x1270;
  put(x1305, w.x.data() + 108);
  // joints 20 "left_wrist_roll", 28 "right_wrist_roll": articulated-body inertia and bias force through them
  const Two x1358 = 0.002 + x1294 - x1305 * x1351;
  const Two x1373 = taken<Two>(sine + 8) * (x1332 + x1358);
  const Two x1379 = taken<Two>(cosine + 8) * x1373;
  // joints 21 "left_wrist_pitch", 29 "right_wrist_pitch": articulated-body inertia and bias force through them
  const Two x1285 = taken<Two>(sine + 10) * x1284;
  // joints 20 "left_wrist_roll", 28 "right_wrist_roll": articulated-body inertia and bias force through them
  const Two x1391 = taken<Two>(sine + 8) * x1285;
  put(x1391, w.x.data() + 110);
  const Two x1399 = 0.01 * x1391;
  const Two x1394 = taken<Two>(sine + 8) * x1393;
  put(x1394, w.x.data() + 112);
  const Two x1412 = 0.16 * x1394;
  const Two x1427 = x1379 - x1399 - x1412;
  put(x1427, w.x.data() + 114);
  // joints 21 "left_wrist_pitch", 29 "right_wrist_pitch": articulated-body inertia and bias force through them
  const Two x1302 = 0.000296667 + x1280 + 0.04 * x1272 + 0.04 * x1294;
  // joints 20 "left_wrist_roll", 28 "right_wrist_roll": articulated-body inertia and bias force through them
  const Two x1349 = x1305 * x1346;
  put(x1349, w.x.data() + 116);
  const Two x1355 = 0.00010666669999999999 + x1302 - x1305 * x1349;
  // joints 21 "left_wrist_pitch", 29 "right_wrist_pitch": articulated-body inertia and bias force through them
  const Two x1331 = 0.00010666669999999999 + 0.04 * x1290;
  // joints 20 "left_wrist_roll", 28 "right_wrist_roll": articulated-body inertia and bias force through them
  const Two x1382 = taken<Two>(cosine + 8) * (x1355 - x1331);
  const Two x1387 = taken<Two>(cosine + 8) * x1382;
  // joints 21 "left_wrist_pitch", 29 "right_wrist_pitch": articulated-body inertia and bias force through them
  const Two x1295 = 0.04 * x1285;
  // joints 20 "left_wrist_roll", 28 "right_wrist_roll": articulated-body inertia and bias force through them
  const Two x1370 = taken<Two>(cosine + 8) * x1295;
  // joints 21 "left_wrist_pitch", 29 "right_wrist_pitch": articulated-body inertia and bias force through them
  const Two x1336 = 0.11247915349070774 + x1287 + 0.2;
  // joints 20 "left_wrist_roll", 28 "right_wrist_roll": articulated-body inertia and bias force through them
  const Two x1390 = taken<Two>(cosine + 8) * x1285;
  const Two x1409 = x1370 + 0.16 * x1390 + 0.01 * x1336;
  const Two x1375 = taken<Two>(sine + 8) * x1373;
  const Two x1378 = x1332 - x1375;
  const Two x1464 = x1355 - x1387 + (0.01 * x1370 + 0.01 * x1409);
  const Two x1397 = x1361 + x1396;
  const Two x1420 = x1378 - 0.01 * x1390 - 0.16 * x1397;
  const Two x1498 = x1464 - 0.16 * x1378 - 0.16 * x1420 + 0.005417710000000001;
  require_more(w, x1498, 0.0, kFactorization, {19, 27});
  // joints 19 "left_elbow", 27 "right_elbow": articulated-body inertia and bias force through them
  const Two x1513 = 1 / x1498;
  put(x1513, w.x.data() + 118);
  const Two x1520 = x1427 * x1513;
  put(x1520, w.x.data() + 120);
  const Two x1565 = 0.7 + x1398 - x1427 * x1520;
  put(x1565, w.x.data() + 122);
  // joints 20 "left_wrist_roll", 28 "right_wrist_roll": articulated-body inertia and bias force through them
  const Two x1421 = 0.01 * x1398;
  const Two x1411 = 0.01 * x1394;
  const Two x1439 = 0.01 * x1379 - 0.01 * x1399 - 0.16 * x1411;
  put(x1439, w.x.data() + 124);
  // joints 19 "left_elbow", 27 "right_elbow": articulated-body inertia and bias force through them
  const Two x1535 = 0.013999999999999999 + x1421 - x1439 * x1520;
  put(x1535, w.x.data() + 126);
  // joints 20 "left_wrist_roll", 28 "right_wrist_roll": articulated-body inertia and bias force through them
  const Two x1377 = x1358 - x1375;
  const Two x1424 = x1377 + 0.16 * x1398;
  const Two x1402 = taken<Two>(sine + 8) * x1295 + 0.16 * x1391;
  put(x1402, w.x.data() + 128);
  const Two x1414 = x1412 - x1379;
  const Two x1453 = taken<Two>(sine + 8) * x1382 - 0.01 * x1402 + 0.16 * x1379;
  const Two x1454 = x1453 - 0.16 * x1414;
  put(x1454, w.x.data() + 130);
  // joints 19 "left_elbow", 27 "right_elbow": articulated-body inertia and bias force through them
  const Two x1547 = 0.049 + x1424 - x1454 * x1520;
  put(x1547, w.x.data() + 132);
  const Two x1579 = taken<Two>(cosine + 6) * x1535 - taken<Two>(sine + 6) * x1547;
  put(x1579, w.x.data() + 134);
  // joints 20 "left_wrist_roll", 28 "right_wrist_roll": articulated-body inertia and bias force through them
  const Two x1445 = x1331 + x1387 + 0.16 * x1377 + 0.16 * x1424;
  // joints 19 "left_elbow", 27 "right_elbow": articulated-body inertia and bias force through them
  const Two x1517 = x1454 * x1513;
  put(x1517, w.x.data() + 136);
  const Two x1538 = 0.00513771 + x1445 - x1454 * x1517;
  const Two x1516 = x1439 * x1513;
  put(x1516, w.x.data() + 138);
  const Two x1523 = 0.00070875 + 0.01 * x1421 - x1439 * x1516;
  put(x1523, w.x.data() + 140);
  // joints 20 "left_wrist_roll", 28 "right_wrist_roll": articulated-body inertia and bias force through them
  const Two x1494 = 0.01 * x1377 + 0.16 * x1421 + 0.00098;
  // joints 19 "left_elbow", 27 "right_elbow": articulated-body inertia and bias force through them
  const Two x1526 = x1494 - x1439 * x1517;
  put(x1526, w.x.data() + 142);
  const Two x1598 = taken<Two>(sine + 6) * 2.0;
  const Two x1602 = taken<Two>(cosine + 6) * (x1523 - x1538) - x1526 * x1598;
  put(x1602, w.x.data() + 144);
  const Two x1606 = taken<Two>(cosine + 6) * x1602;
  put(x1606, w.x.data() + 146);
  const Two x1679 = x1538 + x1606 + 0.00064;
  require_more(w, x1679, 0.0, kFactorization, {18, 26});
  // joints 18 "left_shoulder_yaw", 26 "right_shoulder_yaw": articulated-body inertia and bias force through them
  const Two x1692 = 1 / x1679;
  put(x1692, w.x.data() + 148);
  const Two x1699 = x1579 * x1692;
  put(x1699, w.x.data() + 150);
  const Two x1739 = 0.8 + x1565 - x1579 * x1699;
  put(x1739, w.x.data() + 152);
  // joints 20 "left_wrist_roll", 28 "right_wrist_roll": articulated-body inertia and bias force through them
  const Two x1499 = -0.013999999999999999 - x1409;
  put(x1499, w.x.data() + 154);
  // joints 19 "left_elbow", 27 "right_elbow": articulated-body inertia and bias force through them
  const Two x1518 = x1499 * x1513;
  put(x1518, w.x.data() + 156);
  const Two x1550 = 0.7 + x1336 - x1499 * x1518;
  // joints 20 "left_wrist_roll", 28 "right_wrist_roll": articulated-body inertia and bias force through them
  const Two x1500 = -0.049 + x1420;
  put(x1500, w.x.data() + 158);
  // joints 19 "left_elbow", 27 "right_elbow": articulated-body inertia and bias force through them
  const Two x1519 = x1500 * x1513;
  put(x1519, w.x.data() + 160);
  const Two x1559 = 0.7 + x1397 - x1500 * x1519;
  put(x1559, w.x.data() + 162);
  const Two x1553 = x1390 - x1499 * x1519;
  put(x1553, w.x.data() + 164);
  const Two x1620 = taken<Two>(cosine + 6) * (x1550 - x1559) - x1553 * x1598;
  put(x1620, w.x.data() + 166);
  const Two x1624 = taken<Two>(cosine + 6) * x1620;
  put(x1624, w.x.data() + 168);
  const Two x1626 = x1550 - x1624;
  put(x1626, w.x.data() + 170);
  const Two x1680 = 0.8 + x1626;
  put(x1680, w.x.data() + 172);
  const Two x1532 = x1411 - x1439 * x1519;
  put(x1532, w.x.data() + 174);
  const Two x1529 = x1399 - x1439 * x1518;
  put(x1529, w.x.data() + 176);
  const Two x1544 = x1414 - x1454 * x1519;
  put(x1544, w.x.data() + 178);
  const Two x1583 = x1529 - x1544;
  put(x1583, w.x.data() + 180);
}

ADAGEN_NOINLINE ADAGEN_AS_IT_STANDS void part_1_1(Workspace& w) {
  ADAGEN_INPUTS
  const Real x807 = w.x[6];
  const Two x811 = taken<Two>(w.x.data() + 8);
  const Two x813 = taken<Two>(w.x.data() + 10);
  const Two x816 = taken<Two>(w.x.data() + 12);
  const Two x819 = taken<Two>(w.x.data() + 14);
  const Two x823 = taken<Two>(w.x.data() + 16);
  const Two x866 = taken<Two>(w.x.data() + 18);
  const Two x869 = taken<Two>(w.x.data() + 20);
  const Two x874 = taken<Two>(w.x.data() + 22);
  const Two x882 = taken<Two>(w.x.data() + 24);
  const Two x888 = taken<Two>(w.x.data() + 26);
  const Two x894 = taken<Two>(w.x.data() + 28);
  const Two x911 = taken<Two>(w.x.data() + 30);
  const Two x915 = taken<Two>(w.x.data() + 32);
  const Two x918 = taken<Two>(w.x.data() + 34);
  const Two x922 = taken<Two>(w.x.data() + 36);
  const Two x926 = taken<Two>(w.x.data() + 38);
  const Two x930 = taken<Two>(w.x.data() + 40);
  const Two x971 = taken<Two>(w.x.data() + 42);
  const Two x974 = taken<Two>(w.x.data() + 44);
  const Two x980 = taken<Two>(w.x.data() + 46);
  const Two x986 = taken<Two>(w.x.data() + 48);
  const Two x994 = taken<Two>(w.x.data() + 50);
  const Two x1000 = taken<Two>(w.x.data() + 52);
  const Two x1019 = taken<Two>(w.x.data() + 54);
  const Two x1023 = taken<Two>(w.x.data() + 56);
  const Two x1026 = taken<Two>(w.x.data() + 58);
  const Two x1030 = taken<Two>(w.x.data() + 60);
  const Two x1034 = taken<Two>(w.x.data() + 62);
  const Two x1038 = taken<Two>(w.x.data() + 64);
  const Two x1055 = taken<Two>(w.x.data() + 66);
  const Two x1070 = taken<Two>(w.x.data() + 68);
  const Two x1073 = taken<Two>(w.x.data() + 70);
  const Two x1077 = taken<Two>(w.x.data() + 72);
  const Two x1081 = taken<Two>(w.x.data() + 74);
  const Two x1085 = taken<Two>(w.x.data() + 76);
  const Real x1231 = w.x[0];
  const Real x1234 = w.x[1];
  const Real x1239 = w.x[2];
  const Real x1245 = w.x[3];
  const Real x1251 = w.x[4];
  const Real x1256 = w.x[5];
  const Two x1270 = taken<Two>(w.x.data() + 102);
  const Two x1305 = taken<Two>(w.x.data() + 108);
  const Two x1346 = taken<Two>(w.x.data() + 104);
  const Two x1391 = taken<Two>(w.x.data() + 110);
  const Two x1394 = taken<Two>(w.x.data() + 112);
  const Two x1402 = taken<Two>(w.x.data() + 128);
  const Two x1427 = taken<Two>(w.x.data() + 114);
  const Two x1439 = taken<Two>(w.x.data() + 124);
  const Two x1454 = taken<Two>(w.x.data() + 130);
  const Two x1499 = taken<Two>(w.x.data() + 154);
  const Two x1500 = taken<Two>(w.x.data() + 158);
  const Two x1513 = taken<Two>(w.x.data() + 118);
  const Two x1518 = taken<Two>(w.x.data() + 156);
  const Two x1520 = taken<Two>(w.x.data() + 120);
  const Two x1523 = taken<Two>(w.x.data() + 140);
  const Two x1526 = taken<Two>(w.x.data() + 142);
  const Two x1529 = taken<Two>(w.x.data() + 176);
  const Two x1532 = taken<Two>(w.x.data() + 174);
  const Two x1535 = taken<Two>(w.x.data() + 126);
  const Two x1544 = taken<Two>(w.x.data() + 178);
  const Two x1547 = taken<Two>(w.x.data() + 132);
  const Two x1553 = taken<Two>(w.x.data() + 164);
  const Two x1559 = taken<Two>(w.x.data() + 162);
  const Two x1565 = taken<Two>(w.x.data() + 122);
  const Two x1579 = taken<Two>(w.x.data() + 134);
  const Two x1583 = taken<Two>(w.x.data() + 180);
  const Two x1602 = taken<Two>(w.x.data() + 144);
  const Two x1606 = taken<Two>(w.x.data() + 146);
  const Two x1620 = taken<Two>(w.x.data() + 166);
  const Two x1624 = taken<Two>(w.x.data() + 168);
  const Two x1626 = taken<Two>(w.x.data() + 170);
  const Two x1680 = taken<Two>(w.x.data() + 172);
  const Two x1692 = taken<Two>(w.x.data() + 148);
  const Two x1699 = taken<Two>(w.x.data() + 150);
  const Two x1739 = taken<Two>(w.x.data() + 152);
  const Real x2360 = w.x[79];
  const Real x2366 = w.x[80];
  const Real x2407 = w.x[84];
  const Real x2408 = w.x[85];
  const Real x2411 = w.x[86];
  const Real x2414 = w.x[87];
  const Real x2415 = w.x[88];
  const Real x2418 = w.x[89];
  const Real x2421 = w.x[90];
  const Real x2424 = w.x[91];
  const Real x2427 = w.x[92];
  const Real x2430 = w.x[93];
  const Real x2436 = w.x[94];
  const Real x2442 = w.x[95];
  const Real x2446 = w.x[96];
  const Real x2457 = w.x[97];
  const Real x2460 = w.x[98];
  const Real x2463 = w.x[99];
  const Real x2465 = w.x[100];
  // joints 19 "left_elbow", 27 "right_elbow": articulated-body inertia and bias force through them
  const Two x1541 = x1402 - x1454 * x1518;
  const Two x1588 = taken<Two>(cosine + 6) * x1583 - taken<Two>(sine + 6) * (x1532 + x1541);
  const Two x1589 = taken<Two>(sine + 6) * x1588;
  const Two x1591 = x1532 + x1589;
  // joints 18 "left_shoulder_yaw", 26 "right_shoulder_yaw": articulated-body inertia and bias force through them
  const Two x1698 = x1591 * x1692;
  put(x1698, w.x.data() + 182);
  const Two x1730 = x1680 - x1591 * x1698;
  // joints 19 "left_elbow", 27 "right_elbow": articulated-body inertia and bias force through them
  const Two x1556 = x1391 - x1499 * x1520;
  const Two x1562 = x1394 - x1500 * x1520;
  const Two x1615 = taken<Two>(sine + 6) * x1556 + taken<Two>(cosine + 6) * x1562;
  // joints 18 "left_shoulder_yaw", 26 "right_shoulder_yaw": articulated-body inertia and bias force through them
  const Two x1733 = x1615 - x1591 * x1699;
  const Two x1779 = taken<Two>(sine + 4) * 2.0;
  const Two x1801 = taken<Two>(cosine + 4) * (x1730 - x1739) - x1733 * x1779;
  const Two x1805 = taken<Two>(cosine + 4) * x1801;
  const Two x1806 = x1739 + x1805;
  // joints 19 "left_elbow", 27 "right_elbow": articulated-body inertia and bias force through them
  const Two x1653 = 0.11 * x1591;
  const Two x1627 = 0.11 * x1615;
  // joints 18 "left_shoulder_yaw", 26 "right_shoulder_yaw": articulated-body inertia and bias force through them
  const Two x1724 = x1653 * x1699 - x1627;
  // joints 19 "left_elbow", 27 "right_elbow": articulated-body inertia and bias force through them
  const Two x1593 = taken<Two>(cosine + 6) * x1588;
  const Two x1629 = x1529 - x1593 + x1627;
  const Two x1650 = x1526 + taken<Two>(sine + 6) * x1602 + 0.11 * x1579;
  // joints 18 "left_shoulder_yaw", 26 "right_shoulder_yaw": articulated-body inertia and bias force through them
  const Two x1709 = x1629 - x1650 * x1698;
  // joints 19 "left_elbow", 27 "right_elbow": articulated-body inertia and bias force through them
  const Two x1582 = taken<Two>(sine + 6) * x1535 + taken<Two>(cosine + 6) * x1547;
  const Two x1634 = x1582 + 0.11 * x1565;
  // joints 18 "left_shoulder_yaw", 26 "right_shoulder_yaw": articulated-body inertia and bias force through them
  const Two x1712 = 0.04000000000000001 + x1634 - x1650 * x1699;
  // joints 19 "left_elbow", 27 "right_elbow": articulated-body inertia and bias force through them
  const Two x1630 = 0.11 * x1626;
  // joints 18 "left_shoulder_yaw", 26 "right_shoulder_yaw": articulated-body inertia and bias force through them
  const Two x1721 = -0.04000000000000001 - x1630 + x1653 * x1698;
  const Two x1769 = taken<Two>(cosine + 4) * (x1709 - x1724) - taken<Two>(sine + 4) * (x1712 + x1721);
  const Two x1774 = taken<Two>(cosine + 4) * x1769;
  const Two x1775 = x1724 + x1774;
  const Two x1804 = x1733 + taken<Two>(sine + 4) * x1801;
  const Two x1808 = 0.1 * x1804;
  const Two x1823 = x1775 + x1808;
  const Two x1770 = taken<Two>(sine + 4) * x1769;
  const Two x1772 = x1712 + x1770;
  const Two x1807 = x1730 - x1805;
  const Two x1813 = x1772 + 0.1 * x1807;
  const Two x1696 = x1653 * x1692;
  put(x1696, w.x.data() + 184);
  const Two x1718 = 0.0036266700000000002 + 0.11 * x1630 - x1653 * x1696;
  // joints 19 "left_elbow", 27 "right_elbow": articulated-body inertia and bias force through them
  const Two x1645 = x1523 - x1606 + (0.11 * x1582 + 0.11 * x1634);
  // joints 18 "left_shoulder_yaw", 26 "right_shoulder_yaw": articulated-body inertia and bias force through them
  const Two x1695 = x1650 * x1692;
  put(x1695, w.x.data() + 186);
  const Two x1703 = 0.0036266700000000002 + x1645 - x1650 * x1695;
  const Two x1706 = x1650 * x1696 - 0.11 * x1629;
  const Two x1783 = taken<Two>(cosine + 4) * (x1703 - x1718) - x1706 * x1779;
  const Two x1787 = taken<Two>(cosine + 4) * x1783;
  const Two x1841 = x1718 + x1787 + 0.1 * x1772 + 0.1 * x1813;
  const Two x1864 = 0.0014 + x1841;
  require_more(w, x1864, 0.0, kFactorization, {17, 25});
  // joints 17 "left_shoulder_roll", 25 "right_shoulder_roll": articulated-body inertia and bias force through them
  const Two x1879 = 1 / x1864;
  const Two x1885 = x1823 * x1879;
  put(x1885, w.x.data() + 188);
  const Two x1915 = 0.7 + x1806 - x1823 * x1885;
  // joints 18 "left_shoulder_yaw", 26 "right_shoulder_yaw": articulated-body inertia and bias force through them
  const Two x1773 = x1721 + x1770;
  const Two x1822 = x1773 - 0.1 * x1806;
  const Two x1810 = x1709 - x1774 - x1808;
  const Two x1834 = x1706 + taken<Two>(sine + 4) * x1783 - 0.1 * x1775;
  const Two x1835 = 0.1 * x1810 + x1834;
  // joints 17 "left_shoulder_roll", 25 "right_shoulder_roll": articulated-body inertia and bias force through them
  const Two x1897 = -0.020999999999999998 + x1822 - x1835 * x1885;
  const Two x1927 = taken<Two>(cosine + 2) * x1897 + taken<Two>(sine + 2) * Two{0.006999999999999999, -0.006999999999999999};
  // joints 18 "left_shoulder_yaw", 26 "right_shoulder_yaw": articulated-body inertia and bias force through them
  const Two x1829 = x1703 - x1787 - 0.1 * x1773 - 0.1 * x1822;
  // joints 17 "left_shoulder_roll", 25 "right_shoulder_roll": articulated-body inertia and bias force through them
  const Two x1882 = x1835 * x1879;
  put(x1882, w.x.data() + 190);
  const Two x1888 = 0.0013299999999999998 + x1829 - x1835 * x1882;
  const Two x1943 = taken<Two>(sine + 2) * 2.0;
  const Two x1947 = taken<Two>(cosine + 2) * (x1888 - 0.00077) - Two{0.00020999999999999998, -0.00020999999999999998} * x1943;
  const Two x1951 = taken<Two>(cosine + 2) * x1947;
  const Two x2019 = 0.00077 + x1951 + 0.00064;
  require_more(w, x2019, 0.0, kFactorization, {16, 24});
  // joints 16 "left_shoulder_pitch", 24 "right_shoulder_pitch": articulated-body inertia and bias force through them
  const Two x2032 = 1 / x2019;
  const Two x2038 = x1927 * x2032;
  put(x2038, w.x.data() + 192);
  const Two x2078 = 0.8 + x1915 - x1927 * x2038;
  // joints 18 "left_shoulder_yaw", 26 "right_shoulder_yaw": articulated-body inertia and bias force through them
  const Two x1865 = 0.020999999999999998 + x1813;
  // joints 17 "left_shoulder_roll", 25 "right_shoulder_roll": articulated-body inertia and bias force through them
  const Two x1883 = x1865 * x1879;
  put(x1883, w.x.data() + 194);
  const Two x1900 = 0.7 + x1807 - x1865 * x1883;
  // joints 19 "left_elbow", 27 "right_elbow": articulated-body inertia and bias force through them
  const Two x1594 = x1544 + x1593;
  // joints 18 "left_shoulder_yaw", 26 "right_shoulder_yaw": articulated-body inertia and bias force through them
  const Two x1700 = x1594 * x1692;
  put(x1700, w.x.data() + 196);
  // joints 19 "left_elbow", 27 "right_elbow": articulated-body inertia and bias force through them
  const Two x1612 = taken<Two>(cosine + 6) * x1556 - taken<Two>(sine + 6) * x1562;
  // joints 18 "left_shoulder_yaw", 26 "right_shoulder_yaw": articulated-body inertia and bias force through them
  const Two x1715 = x1541 + x1589 + 0.11 * x1612 - x1650 * x1700;
  // joints 19 "left_elbow", 27 "right_elbow": articulated-body inertia and bias force through them
  const Two x1623 = x1553 + taken<Two>(sine + 6) * x1620;
  // joints 18 "left_shoulder_yaw", 26 "right_shoulder_yaw": articulated-body inertia and bias force through them
  const Two x1727 = x1653 * x1700 - 0.11 * x1623;
  const Two x1736 = x1623 - x1591 * x1700;
  const Two x1742 = x1612 - x1579 * x1700;
  const Two x1796 = taken<Two>(sine + 4) * x1736 + taken<Two>(cosine + 4) * x1742;
  const Two x1819 = taken<Two>(cosine + 4) * x1715 - taken<Two>(sine + 4) * x1727 + 0.1 * x1796;
  const Two x1866 = Two{0.006999999999999999, -0.006999999999999999} + x1819;
  // joints 17 "left_shoulder_roll", 25 "right_shoulder_roll": articulated-body inertia and bias force through them
  const Two x1884 = x1866 * x1879;
  put(x1884, w.x.data() + 198);
  // joints 18 "left_shoulder_yaw", 26 "right_shoulder_yaw": articulated-body inertia and bias force through them
  const Two x1868 = x1559 + x1624 + 0.8 - x1594 * x1700 + 0.7;
  // joints 17 "left_shoulder_roll", 25 "right_shoulder_roll": articulated-body inertia and bias force through them
  const Two x1909 = x1868 - x1866 * x1884;
  const Two x1903 = x1796 - x1865 * x1884;
  const Two x1965 = taken<Two>(cosine + 2) * (x1900 - x1909) - x1903 * x1943;
  const Two x1969 = taken<Two>(cosine + 2) * x1965;
  const Two x1971 = x1900 - x1969;
  // joints 18 "left_shoulder_yaw", 26 "right_shoulder_yaw": articulated-body inertia and bias force through them
  const Two x1793 = taken<Two>(cosine + 4) * x1736 - taken<Two>(sine + 4) * x1742;
  const Two x1816 = taken<Two>(sine + 4) * x1715 + taken<Two>(cosine + 4) * x1727 - 0.1 * x1793;
  // joints 17 "left_shoulder_roll", 25 "right_shoulder_roll": articulated-body inertia and bias force through them
  const Two x1894 = x1816 - x1835 * x1884;
  const Two x1891 = x1810 - x1835 * x1883;
  const Two x1935 = taken<Two>(cosine + 2) * x1891 - taken<Two>(sine + 2) * x1894;
  const Two x1936 = taken<Two>(sine + 2) * x1935;
  const Two x1938 = x1894 + x1936;
  // joints 16 "left_shoulder_pitch", 24 "right_shoulder_pitch": articulated-body inertia and bias force through them
  const Two x2037 = x1938 * x2032;
  put(x2037, w.x.data() + 200);
  const Two x2069 = 0.8 + x1971 - x1938 * x2037;
  // joints 17 "left_shoulder_roll", 25 "right_shoulder_roll": articulated-body inertia and bias force through them
  const Two x1906 = x1804 - x1865 * x1885;
  const Two x1912 = x1793 - x1866 * x1885;
  const Two x1960 = taken<Two>(sine + 2) * x1906 + taken<Two>(cosine + 2) * x1912;
  // joints 16 "left_shoulder_pitch", 24 "right_shoulder_pitch": articulated-body inertia and bias force through them
  const Two x2072 = x1960 - x1938 * x2038;
  const Two x2117 = taken<Two>(sine + 0) * 2.0;
  const Two x2139 = taken<Two>(cosine + 0) * (x2069 - x2078) - x2072 * x2117;
  const Two x2143 = taken<Two>(cosine + 0) * x2139;
  const Two x2144 = x2078 + x2143;
  // joints 17 "left_shoulder_roll", 25 "right_shoulder_roll": articulated-body inertia and bias force through them
  const Two x1975 = Two{0.05, -0.05} * x1971;
  const Two x1995 = Two{0.05, -0.05} * x1938;
  // joints 16 "left_shoulder_pitch", 24 "right_shoulder_pitch": articulated-body inertia and bias force through them
  const Two x2060 = Two{0.024, -0.024} + x1975 - x1995 * x2037;
  // joints 17 "left_shoulder_roll", 25 "right_shoulder_roll": articulated-body inertia and bias force through them
  const Two x1939 = taken<Two>(cosine + 2) * x1935;
  const Two x1972 = Two{0.05, -0.05} * x1960;
  const Two x1974 = x1891 - x1939 - x1972;
  const Two x1993 = Two{0.00020999999999999998, -0.00020999999999999998} + taken<Two>(sine + 2) * x1947 - Two{0.05, -0.05} * x1927;
  // joints 16 "left_shoulder_pitch", 24 "right_shoulder_pitch": articulated-body inertia and bias force through them
  const Two x2048 = x1974 - x1993 * x2037;
  const Two x2063 = x1972 - x1995 * x2038;
  // joints 17 "left_shoulder_roll", 25 "right_shoulder_roll": articulated-body inertia and bias force through them
  const Two x1931 = taken<Two>(sine + 2) * x1897 - taken<Two>(cosine + 2) * Two{0.006999999999999999, -0.006999999999999999};
  const Two x1978 = x1931 - Two{0.05, -0.05} * x1915;
  // joints 16 "left_shoulder_pitch", 24 "right_shoulder_pitch": articulated-body inertia and bias force through them
  const Two x2051 = Two{-0.024, 0.024} + x1978 - x1993 * x2038;
  const Two x2107 = taken<Two>(cosine + 0) * (x2048 - x2063) - taken<Two>(sine + 0) * (x2051 + x2060);
  const Two x2108 = taken<Two>(sine + 0) * x2107;
  const Two x2111 = x2060 + x2108;
  // joints 17 "left_shoulder_roll", 25 "right_shoulder_roll": articulated-body inertia and bias force through them
  const Two x1968 = x1903 + taken<Two>(sine + 2) * x1965;
  // joints 16 "left_shoulder_pitch", 24 "right_shoulder_pitch": articulated-body inertia and bias force through them
  const Two x2039 = x1939 * x2032;
  put(x2039, w.x.data() + 202);
  const Two x2075 = x1968 - x1938 * x2039;
  // joints 17 "left_shoulder_roll", 25 "right_shoulder_roll": articulated-body inertia and bias force through them
  const Two x1957 = taken<Two>(cosine + 2) * x1906 - taken<Two>(sine + 2) * x1912;
  // joints 16 "left_shoulder_pitch", 24 "right_shoulder_pitch": articulated-body inertia and bias force through them
  const Two x2081 = x1957 - x1927 * x2039;
  const Two x2131 = taken<Two>(cosine + 0) * x2075 - taken<Two>(sine + 0) * x2081;
  const Two x2153 = x2111 - 0.29 * x2131 + Two{0.15, -0.15} * x2144;
  // joints 17 "left_shoulder_roll", 25 "right_shoulder_roll": articulated-body inertia and bias force through them
  const Two x1989 = x1888 - x1951 - (Two{0.05, -0.05} * x1931 + Two{0.05, -0.05} * x1978);
  // joints 16 "left_shoulder_pitch", 24 "right_shoulder_pitch": articulated-body inertia and bias force through them
  const Two x2035 = x1993 * x2032;
  put(x2035, w.x.data() + 204);
  const Two x2042 = 0.001366667 + x1989 - x1993 * x2035;
  const Two x2036 = x1995 * x2032;
  put(x2036, w.x.data() + 206);
  const Two x2057 = 0.001366667 + Two{0.05, -0.05} * x1975 - x1995 * x2036;
  const Two x2045 = Two{0.05, -0.05} * x1974 - x1993 * x2036;
  const Two x2121 = taken<Two>(cosine + 0) * (x2042 - x2057) - x2045 * x2117;
  const Two x2125 = taken<Two>(cosine + 0) * x2121;
  const Two x2054 = x1936 - Two{0.05, -0.05} * x1957 - x1993 * x2039;
  const Two x2066 = Two{0.05, -0.05} * x1968 - x1995 * x2039;
  const Two x2101 = taken<Two>(sine + 0) * x2054 + taken<Two>(cosine + 0) * x2066;
  const Two x2084 = x1909 + x1969 + 0.8 - x1939 * x2039;
  const Two x2170 = x2101 - 0.29 * x2084 + Two{0.15, -0.15} * x2131;
  const Two x2193 = x2042 - x2125 - 0.29 * x2101 - 0.29 * x2170;
  const Two x2195 = Two{0.15, -0.15} * x2111 + x2193 + Two{0.15, -0.15} * x2153;
  // joint 22 "neck_yaw": articulated-body inertia and bias force through it
  const Real x2466 = 0.42813300000000004 + across<2>(x2195) + x2436;
  w.x[208] = x2466;
  w.to[1][6] = x2466;
  // joints 16 "left_shoulder_pitch", 24 "right_shoulder_pitch": articulated-body inertia and bias force through them
  const Two x2142 = x2072 + taken<Two>(sine + 0) * x2139;
  const Two x2146 = Two{0.15, -0.15} * x2142;
  const Two x2112 = taken<Two>(cosine + 0) * x2107;
  const Two x2114 = x2048 - x2112;
  const Two x2134 = taken<Two>(sine + 0) * x2075 + taken<Two>(cosine + 0) * x2081;
  const Two x2158 = 0.29 * x2134;
  const Two x2161 = x2114 - x2158 + x2146;
  const Two x2196 = 0.29 * x2161;
  // joint 22 "neck_yaw": articulated-body inertia and bias force through it
  const Real x2467 = across<2>(x2196) + x2442;
  w.x[209] = x2467;
  w.to[1][7] = x2467;
  const Real x2468 = across<2>(x2153) - x2418;
  w.x[210] = x2468;
  w.to[1][8] = x2468;
  const Real x2469 = across<2>(x2161) - x2424;
  w.x[211] = x2469;
  w.to[1][9] = x2469;
  const Real x2470 = -1.6150000000000002 + across<2>(x2170) + x2430;
  w.x[212] = x2470;
  w.to[1][10] = x2470;
  // joints 16 "left_shoulder_pitch", 24 "right_shoulder_pitch": articulated-body inertia and bias force through them
  const Two x2145 = x2069 - x2143;
  const Two x2162 = 0.29 * x2145;
  const Two x2197 = 0.29 * x2162;
  // joint 22 "neck_yaw": articulated-body inertia and bias force through it
  const Real x2471 = 0.38728300000000004 + across<2>(x2197) + x2446;
  w.x[213] = x2471;
  w.to[1][11] = x2471;
  // joints 16 "left_shoulder_pitch", 24 "right_shoulder_pitch": articulated-body inertia and bias force through them
  const Two x2154 = 0.29 * x2142;
  // joint 22 "neck_yaw": articulated-body inertia and bias force through it
  const Real x2472 = -0.095 + across<2>(x2154) + x2421;
  w.x[214] = x2472;
  w.to[1][12] = x2472;
  const Real x2473 = 1.6150000000000002 + across<2>(x2162) + x2427;
  w.x[215] = x2473;
  w.to[1][13] = x2473;
  const Real x2474 = across<2>(x2158) + x2424;
  w.x[216] = x2474;
  w.to[1][14] = x2474;
  const Real x2475 = 9.5 + across<2>(x2144) + x2360;
  w.x[217] = x2475;
  w.to[1][15] = x2475;
  const Real x2476 = across<2>(x2142) + x2407;
  w.x[218] = x2476;
  w.to[1][16] = x2476;
  const Real x2477 = across<2>(x2131) + x2408;
  w.x[219] = x2477;
  w.to[1][17] = x2477;
  const Real x2478 = 9.5 + across<2>(x2145) + x2414;
  w.x[220] = x2478;
  w.to[1][18] = x2478;
  const Real x2479 = across<2>(x2134) + x2411;
  w.x[221] = x2479;
  w.to[1][19] = x2479;
  const Real x2480 = 9.5 + across<2>(x2084) + x2415;
  w.x[222] = x2480;
  w.to[1][20] = x2480;
  // joints 20 "left_wrist_roll", 28 "right_wrist_roll": articulated-body inertia and bias force through them
  const Two x1345 = Two{tau[25], tau[33]};
  // joints 21 "left_wrist_pitch", 29 "right_wrist_pitch": articulated-body inertia and bias force through them
  const Two x1259 = Two{tau[26], tau[34]};
  const Two x1262 = 499.16813630085466 * (x1259 - x1073);
  put(x1262, w.x.data() + 224);
  const Two x1269 = x1081 - 0.024 * x1262;
  const Two x1322 = taken<Two>(sine + 10) * x1077 + taken<Two>(cosine + 10) * x1269;
  const Two x1340 = x1030 + x1322;
  // joints 20 "left_wrist_roll", 28 "right_wrist_roll": articulated-body inertia and bias force through them
  const Two x1347 = x1345 - (taken<Two>(cosine + 10) * x1055 - taken<Two>(sine + 10) * x1070 + x1019);
  const Two x1348 = x1346 * x1347;
  put(x1348, w.x.data() + 226);
  const Two x1367 = x1034 + x1085 - x1270 * x1348;
  const Two x1480 = taken<Two>(sine + 8) * x1340 + taken<Two>(cosine + 8) * x1367;
  // joints 19 "left_elbow", 27 "right_elbow": articulated-body inertia and bias force through them
  const Two x1512 = Two{tau[24], tau[32]};
  // joints 21 "left_wrist_pitch", 29 "right_wrist_pitch": articulated-body inertia and bias force through them
  const Two x1325 = taken<Two>(sine + 10) * x1055 + taken<Two>(cosine + 10) * x1070 + 0.04 * x1085;
  // joints 20 "left_wrist_roll", 28 "right_wrist_roll": articulated-body inertia and bias force through them
  const Two x1364 = x1023 + x1325 - x1305 * x1348;
  // joints 21 "left_wrist_pitch", 29 "right_wrist_pitch": articulated-body inertia and bias force through them
  const Two x1338 = x1259 - 0.04 * x1322 + x1026;
  // joints 20 "left_wrist_roll", 28 "right_wrist_roll": articulated-body inertia and bias force through them
  const Two x1477 = taken<Two>(cosine + 8) * x1340 - taken<Two>(sine + 8) * x1367;
  // joints 21 "left_wrist_pitch", 29 "right_wrist_pitch": articulated-body inertia and bias force through them
  const Two x1342 = taken<Two>(cosine + 10) * x1077 - taken<Two>(sine + 10) * x1269 + x1038;
  // joints 20 "left_wrist_roll", 28 "right_wrist_roll": articulated-body inertia and bias force through them
  const Two x1473 = taken<Two>(sine + 8) * x1364 + taken<Two>(cosine + 8) * x1338;
  const Two x1506 = x1473 - (0.16 * x1477 + 0.01 * x1342) + x980;
  // joints 19 "left_elbow", 27 "right_elbow": articulated-body inertia and bias force through them
  const Two x1515 = x1513 * (x1512 - x1506);
  put(x1515, w.x.data() + 228);
  const Two x1567 = x1345 + 0.01 * x1480 + x971 + x1439 * x1515;
  // joints 20 "left_wrist_roll", 28 "right_wrist_roll": articulated-body inertia and bias force through them
  const Two x1485 = taken<Two>(cosine + 8) * x1364 - taken<Two>(sine + 8) * x1338 + 0.16 * x1480;
  // joints 19 "left_elbow", 27 "right_elbow": articulated-body inertia and bias force through them
  const Two x1569 = x974 + x1485 + x1454 * x1515;
  const Two x1575 = x1000 + x1480 + x1427 * x1515;
  const Two x1671 = taken<Two>(sine + 6) * x1567 + taken<Two>(cosine + 6) * x1569 + 0.11 * x1575;
  // joints 18 "left_shoulder_yaw", 26 "right_shoulder_yaw": articulated-body inertia and bias force through them
  const Two x1691 = Two{tau[23], tau[31]};
  const Two x1693 = x1691 - (taken<Two>(cosine + 6) * x1567 - taken<Two>(sine + 6) * x1569 + x911);
  const Two x1694 = x1692 * x1693;
  put(x1694, w.x.data() + 230);
  const Two x1747 = x915 + x1671 + x1650 * x1694;
  // joints 19 "left_elbow", 27 "right_elbow": articulated-body inertia and bias force through them
  const Two x1571 = x986 + x1342 + x1499 * x1515;
  const Two x1573 = x994 + x1477 + x1500 * x1515;
  const Two x1668 = taken<Two>(sine + 6) * x1571 + taken<Two>(cosine + 6) * x1573;
  // joints 18 "left_shoulder_yaw", 26 "right_shoulder_yaw": articulated-body inertia and bias force through them
  const Two x1750 = x1512 - 0.11 * x1668 + x918 - x1653 * x1694;
  const Two x1752 = x922 + x1668 + x1591 * x1694;
  const Two x1754 = x926 + x1575 + x1579 * x1694;
  const Two x1852 = taken<Two>(cosine + 4) * x1752 - taken<Two>(sine + 4) * x1754;
  const Two x1858 = taken<Two>(sine + 4) * x1747 + taken<Two>(cosine + 4) * x1750 - 0.1 * x1852;
  // joints 17 "left_shoulder_roll", 25 "right_shoulder_roll": articulated-body inertia and bias force through them
  const Two x1878 = Two{tau[22], tau[30]};
  // joints 18 "left_shoulder_yaw", 26 "right_shoulder_yaw": articulated-body inertia and bias force through them
  const Two x1855 = taken<Two>(sine + 4) * x1752 + taken<Two>(cosine + 4) * x1754;
  const Two x1861 = taken<Two>(cosine + 4) * x1747 - taken<Two>(sine + 4) * x1750 + 0.1 * x1855;
  // joints 17 "left_shoulder_roll", 25 "right_shoulder_roll": articulated-body inertia and bias force through them
  const Two x1881 = x1879 * (x1878 - (x874 + x1861));
  put(x1881, w.x.data() + 232);
  const Two x1917 = x866 + x1858 + x1835 * x1881;
  // joints 18 "left_shoulder_yaw", 26 "right_shoulder_yaw": articulated-body inertia and bias force through them
  const Two x1871 = x869 + x1691;
  // joints 17 "left_shoulder_roll", 25 "right_shoulder_roll": articulated-body inertia and bias force through them
  const Two x1923 = x894 + x1852 + x1823 * x1881;
  const Two x2012 = taken<Two>(sine + 2) * x1917 + taken<Two>(cosine + 2) * x1871 - Two{0.05, -0.05} * x1923;
  // joints 16 "left_shoulder_pitch", 24 "right_shoulder_pitch": articulated-body inertia and bias force through them
  const Two x2031 = Two{tau[21], tau[29]};
  const Two x2033 = x2031 - (taken<Two>(cosine + 2) * x1917 - taken<Two>(sine + 2) * x1871 + x807);
  const Two x2034 = x2032 * x2033;
  put(x2034, w.x.data() + 234);
  const Two x2086 = x811 + x2012 + x1993 * x2034;
  // joints 17 "left_shoulder_roll", 25 "right_shoulder_roll": articulated-body inertia and bias force through them
  const Two x1919 = x882 + x1855 + x1865 * x1881;
  // joints 19 "left_elbow", 27 "right_elbow": articulated-body inertia and bias force through them
  const Two x1688 = taken<Two>(cosine + 6) * x1571 - taken<Two>(sine + 6) * x1573 + x930;
  // joints 17 "left_shoulder_roll", 25 "right_shoulder_roll": articulated-body inertia and bias force through them
  const Two x1921 = x1688 + x1594 * x1694 + x888 + x1866 * x1881;
  const Two x2009 = taken<Two>(sine + 2) * x1919 + taken<Two>(cosine + 2) * x1921;
  // joints 16 "left_shoulder_pitch", 24 "right_shoulder_pitch": articulated-body inertia and bias force through them
  const Two x2088 = x1878 + Two{0.05, -0.05} * x2009 + x813 + x1995 * x2034;
  const Two x2090 = x816 + x2009 + x1938 * x2034;
  const Two x2092 = x819 + x1923 + x1927 * x2034;
  const Two x2211 = taken<Two>(sine + 0) * x2090 + taken<Two>(cosine + 0) * x2092;
  const Two x2214 = taken<Two>(cosine + 0) * x2086 - taken<Two>(sine + 0) * x2088 - Two{0.15, -0.15} * x2211;
  // joint 22 "neck_yaw": articulated-body inertia and bias force through it
  const Real x2481 = x1231 + across<2>(x2214) + tau[27];
  w.x[236] = x2481;
  w.to[1][21] = x2481;
  // joints 16 "left_shoulder_pitch", 24 "right_shoulder_pitch": articulated-body inertia and bias force through them
  const Two x2208 = taken<Two>(cosine + 0) * x2090 - taken<Two>(sine + 0) * x2092;
  // joints 17 "left_shoulder_roll", 25 "right_shoulder_roll": articulated-body inertia and bias force through them
  const Two x2028 = taken<Two>(cosine + 2) * x1919 - taken<Two>(sine + 2) * x1921 + x823;
  // joints 16 "left_shoulder_pitch", 24 "right_shoulder_pitch": articulated-body inertia and bias force through them
  const Two x2094 = x2028 + x1939 * x2034;
  const Two x2218 = taken<Two>(sine + 0) * x2086 + taken<Two>(cosine + 0) * x2088 - 0.29 * x2094;
  const Two x2219 = Two{0.15, -0.15} * x2208 + x2218;
  // joint 22 "neck_yaw": articulated-body inertia and bias force through it
  const Real x2482 = x1234 + across<2>(x2219) + x2463;
  w.x[237] = x2482;
  w.to[1][22] = x2482;
  // joints 16 "left_shoulder_pitch", 24 "right_shoulder_pitch": articulated-body inertia and bias force through them
  const Two x2221 = x2031 + 0.29 * x2211;
  // joint 22 "neck_yaw": articulated-body inertia and bias force through it
  const Real x2483 = x1239 + across<2>(x2221) + x2465;
  w.x[238] = x2483;
  w.to[1][23] = x2483;
  const Real x2484 = x1245 + across<2>(x2208) + x2366;
  w.x[239] = x2484;
  w.to[1][24] = x2484;
  const Real x2485 = x1251 + across<2>(x2211) + x2457;
  w.x[240] = x2485;
  w.to[1][25] = x2485;
  const Real x2486 = x1256 + across<2>(x2094) + x2460;
  w.x[241] = x2486;
  w.to[1][26] = x2486;
  // joints 16 "left_shoulder_pitch", 24 "right_shoulder_pitch": articulated-body inertia and bias force through them
  const Two x2110 = x2051 + x2108;
  const Two x2148 = x2063 + x2112 - x2146;
  const Two x2157 = x2110 - Two{0.15, -0.15} * x2145;
  const Two x2165 = taken<Two>(cosine + 0) * x2054 - taken<Two>(sine + 0) * x2066 - Two{0.15, -0.15} * x2134;
  const Two x2176 = x2057 + x2125 - Two{0.15, -0.15} * x2110 - Two{0.15, -0.15} * x2157;
  const Two x2182 = x2045 + taken<Two>(sine + 0) * x2121 - 0.29 * x2165;
  const Two x2184 = x2182 - Two{0.15, -0.15} * x2114 + Two{0.15, -0.15} * x2148;
  const Two x2185 = 0.29 * x2157;
  const Real x2224 = across<2>(x2185);
  w.x[242] = x2224;
  w.to[1][2] = x2224;
  const Real x2225 = across<2>(x2148);
  w.x[243] = x2225;
  w.to[1][3] = x2225;
  const Real x2226 = across<2>(x2157);
  w.x[244] = x2226;
  w.to[1][4] = x2226;
  const Real x2243 = 0.0832833 + across<2>(x2176);
  w.x[245] = x2243;
  w.to[1][0] = x2243;
  const Real x2244 = -0.01615 + across<2>(x2184);
  w.x[246] = x2244;
  w.to[1][1] = x2244;
  const Real x2245 = 0.095 + across<2>(x2165);
  w.x[247] = x2245;
  w.to[1][5] = x2245;
}

ADAGEN_NOINLINE ADAGEN_AS_IT_STANDS void part_1_2(Workspace& w) {
  ADAGEN_INPUTS
  // joint 0 "__base__": placement, velocity and reference acceleration of its link
  const Real x50 = q[3] * q[3] + q[4] * q[4] + q[5] * q[5];
  const Real x51 = q[6] * q[6] + x50;
  require_length(w, x51, 0);
}

ADAGEN_NOINLINE ADAGEN_AS_IT_STANDS void part_1_3(Workspace& w) {
  ADAGEN_INPUTS
  const Two x1262 = taken<Two>(w.x.data() + 224);
  const Two x1348 = taken<Two>(w.x.data() + 226);
  const Two x1349 = taken<Two>(w.x.data() + 116);
  const Two x1351 = taken<Two>(w.x.data() + 106);
  const Two x1515 = taken<Two>(w.x.data() + 228);
  const Two x1516 = taken<Two>(w.x.data() + 138);
  const Two x1517 = taken<Two>(w.x.data() + 136);
  const Two x1518 = taken<Two>(w.x.data() + 156);
  const Two x1519 = taken<Two>(w.x.data() + 160);
  const Two x1520 = taken<Two>(w.x.data() + 120);
  const Two x1694 = taken<Two>(w.x.data() + 230);
  const Two x1695 = taken<Two>(w.x.data() + 186);
  const Two x1696 = taken<Two>(w.x.data() + 184);
  const Two x1698 = taken<Two>(w.x.data() + 182);
  const Two x1699 = taken<Two>(w.x.data() + 150);
  const Two x1700 = taken<Two>(w.x.data() + 196);
  const Two x1881 = taken<Two>(w.x.data() + 232);
  const Two x1882 = taken<Two>(w.x.data() + 190);
  const Two x1883 = taken<Two>(w.x.data() + 194);
  const Two x1884 = taken<Two>(w.x.data() + 198);
  const Two x1885 = taken<Two>(w.x.data() + 188);
  const Two x2034 = taken<Two>(w.x.data() + 234);
  const Two x2035 = taken<Two>(w.x.data() + 204);
  const Two x2036 = taken<Two>(w.x.data() + 206);
  const Two x2037 = taken<Two>(w.x.data() + 200);
  const Two x2038 = taken<Two>(w.x.data() + 192);
  const Two x2039 = taken<Two>(w.x.data() + 202);
  const Real x2224 = w.x[242];
  const Real x2225 = w.x[243];
  const Real x2226 = w.x[244];
  const Real x2243 = w.x[245];
  const Real x2244 = w.x[246];
  const Real x2245 = w.x[247];
  const Real x2269 = w.x[78];
  const Real x2370 = w.x[81];
  const Real x2371 = w.x[82];
  const Real x2372 = w.x[83];
  const Real x2466 = w.x[208];
  const Real x2467 = w.x[209];
  const Real x2468 = w.x[210];
  const Real x2469 = w.x[211];
  const Real x2470 = w.x[212];
  const Real x2471 = w.x[213];
  const Real x2472 = w.x[214];
  const Real x2473 = w.x[215];
  const Real x2474 = w.x[216];
  const Real x2475 = w.x[217];
  const Real x2476 = w.x[218];
  const Real x2477 = w.x[219];
  const Real x2478 = w.x[220];
  const Real x2479 = w.x[221];
  const Real x2480 = w.x[222];
  const Real x2481 = w.x[236];
  const Real x2482 = w.x[237];
  const Real x2483 = w.x[238];
  const Real x2484 = w.x[239];
  const Real x2485 = w.x[240];
  const Real x2486 = w.x[241];
  // message received
  const Real x2487 = w.from[0][0];
  const Real x2488 = w.from[0][1];
  const Real x2492 = w.from[0][5];
  const Real x2489 = w.from[0][2];
  const Real x2493 = w.from[0][6];
  const Real x2496 = w.from[0][9];
  const Real x2490 = w.from[0][3];
  const Real x2494 = w.from[0][7];
  const Real x2497 = w.from[0][10];
  const Real x2491 = w.from[0][4];
  const Real x2499 = w.from[0][12];
  const Real x2495 = w.from[0][8];
  const Real x2498 = w.from[0][11];
  const Real x2500 = w.from[0][13];
  const Real x2517 = w.from[0][15];
  const Real x2518 = w.from[0][16];
  const Real x2501 = w.from[0][14];
  const Real x2519 = w.from[0][17];
  const Real x2520 = w.from[0][18];
  const Real x2521 = w.from[0][19];
  const Real x2522 = w.from[0][20];
  const Real x2516 = x2480 + x2501;
  const Real x2506 = x2245 + x2491;
  const Real x2504 = x2225 + x2489;
  const Real x2511 = x2475 + x2496;
  const Real x2505 = x2226 + x2490;
  const Real x2514 = x2478 + x2499;
  const Real x2502 = x2243 + x2487;
  require_more(w, x2502, 0.0, kFactorization, 15);
  const Real x2503 = x2244 + x2488;
  const Real x2523 = x2481 + x2517;
  const Real x2507 = x2466 + x2492;
  // link 16 "torso": acceleration from its articulated-body inertia
  const Real x2660 = x2516 * 1.7763568394002505e-15;
  const Real x2658 = x2511 * 1.7763568394002505e-15;
  const Real x2659 = x2514 * 1.7763568394002505e-15;
  const Real x2657 = x2471 * 1.7763568394002505e-15;
  const Real x2529 = 1 / x2502;
  const Real x2656 = x2507 * 1.7763568394002505e-15;
  const Real x2530 = x2503 * x2529;
  const Real x2531 = x2224 * x2529;
  const Real x2532 = x2504 * x2529;
  const Real x2533 = x2505 * x2529;
  const Real x2534 = x2506 * x2529;
  const Real x2537 = x2507 - x2503 * x2530;
  require_more(w, x2537, x2656, kFactorization, 15);
  const Real x2540 = x2467 - x2224 * x2530;
  const Real x2543 = x2468 + x2493 - x2504 * x2530;
  const Real x2546 = x2469 + x2494 - x2505 * x2530;
  const Real x2549 = x2470 + x2495 - x2506 * x2530;
  const Real x2550 = 1 / x2537;
  const Real x2669 = x2523 * x2530 - (x2482 + x2518);
  const Real x2551 = x2540 * x2550;
  const Real x2552 = x2543 * x2550;
  const Real x2553 = x2546 * x2550;
  const Real x2554 = x2549 * x2550;
  const Real x2560 = x2471 - x2224 * x2531 - x2540 * x2551;
  require_more(w, x2560, x2657, kFactorization, 15);
  const Real x2566 = x2472 - x2504 * x2531 - x2543 * x2551;
  const Real x2572 = x2473 - x2505 * x2531 - x2546 * x2551;
  const Real x2578 = x2474 - x2506 * x2531 - x2549 * x2551;
  const Real x2675 = x2523 * x2531 - (x2483 + x2519) - x2551 * x2669;
  const Real x2579 = 1 / x2560;
  const Real x2580 = x2566 * x2579;
  const Real x2581 = x2572 * x2579;
  const Real x2582 = x2578 * x2579;
  const Real x2590 = x2511 - x2504 * x2532 - x2543 * x2552;
  const Real x2591 = x2590 - x2566 * x2580;
  require_more(w, x2591, x2658, kFactorization, 15);
  const Real x2599 = x2476 + x2497 - x2505 * x2532 - x2546 * x2552;
  const Real x2600 = x2599 - x2572 * x2580;
  const Real x2622 = x2514 - x2505 * x2533 - x2546 * x2553;
  const Real x2608 = x2477 + x2498 - x2506 * x2532 - x2549 * x2552;
  const Real x2609 = x2608 - x2578 * x2580;
  const Real x2634 = x2479 + x2500 - x2506 * x2533 - x2549 * x2553;
  const Real x2650 = x2516 - x2506 * x2534 - x2549 * x2554;
  const Real x2683 = x2523 * x2532 - (x2484 + x2520) - x2552 * x2669;
  const Real x2684 = x2683 - x2580 * x2675;
  const Real x2694 = x2523 * x2533 - (x2485 + x2521) - x2553 * x2669;
  const Real x2708 = x2523 * x2534 - (x2486 + x2522) - x2554 * x2669;
  const Real x2610 = 1 / x2591;
  const Real x2611 = x2600 * x2610;
  const Real x2612 = x2609 * x2610;
  const Real x2624 = x2622 - x2572 * x2581 - x2600 * x2611;
  require_more(w, x2624, x2659, kFactorization, 15);
  const Real x2636 = x2634 - x2578 * x2581 - x2609 * x2611;
  const Real x2696 = x2694 - x2581 * x2675 - x2611 * x2684;
  const Real x2637 = 1 / x2624;
  const Real x2638 = x2636 * x2637;
  const Real x2652 = x2650 - x2578 * x2582 - x2609 * x2612;
  const Real x2653 = x2652 - x2636 * x2638;
  require_more(w, x2653, x2660, kFactorization, 15);
  const Real x2710 = x2708 - x2582 * x2675 - x2612 * x2684;
  const Real x2718 = 1 / x2653 * (x2710 - x2638 * x2696);
  const Real x2721 = x2637 * x2696 - x2638 * x2718;
  const Real x2727 = x2610 * x2684 - x2612 * x2718 - x2611 * x2721;
  const Real x2735 = x2579 * x2675 - x2582 * x2718 - x2581 * x2721;
  const Real x2736 = x2735 - x2580 * x2727;
  const Real x2746 = x2550 * x2669 - x2554 * x2718 - x2553 * x2721;
  const Real x2761 = x2523 * x2529 + x2534 * x2718 + x2533 * x2721;
  const Real x2748 = x2746 - x2552 * x2727 - x2551 * x2736;
  const Real x2765 = x2532 * x2727 + x2761 + x2531 * x2736;
  const Real x2767 = x2530 * x2748 + x2765;
  // joints 16 "left_shoulder_pitch", 24 "right_shoulder_pitch": their accelerations, and those of the links beyond
  const Real x2782 = x2718 - 0.29 * x2748;
  const Two x2773 = x2727 + Two{0.15, -0.15} * x2748;
  const Two x2779 = x2721 + 0.29 * x2736 + Two{0.15, -0.15} * x2767;
  const Two x2786 = taken<Two>(sine + 0) * x2748 - taken<Two>(cosine + 0) * x2767;
  const Two x2790 = taken<Two>(sine + 0) * x2767 + taken<Two>(cosine + 0) * x2748;
  const Two x2793 = taken<Two>(cosine + 0) * x2773 + taken<Two>(sine + 0) * x2779;
  const Two x2797 = taken<Two>(cosine + 0) * x2779 - taken<Two>(sine + 0) * x2773;
  const Two x2809 = x2034 - x2039 * x2782 - x2035 * x2786;
  const Two x2811 = x2809 - x2036 * x2790 - x2037 * x2793;
  const Two x2812 = x2811 - x2038 * x2797;
  const Two x2813 = x2812 - x2736;
  put(x2813, w.lanes.data() + 0);
  // joints 17 "left_shoulder_roll", 25 "right_shoulder_roll": their accelerations, and those of the links beyond
  const Two x2819 = x2793 + Two{0.05, -0.05} * x2790;
  const Two x2822 = x2797 - Two{0.05, -0.05} * x2786;
  const Two x2832 = taken<Two>(cosine + 2) * x2782 + taken<Two>(sine + 2) * x2819;
  const Two x2836 = taken<Two>(cosine + 2) * x2819 - taken<Two>(sine + 2) * x2782;
  const Two x2825 = taken<Two>(cosine + 2) * x2812 + taken<Two>(sine + 2) * x2786;
  const Two x2846 = x1881 - x1885 * x2822 - x1883 * x2832;
  const Two x2848 = x2846 - x1884 * x2836 - x1882 * x2825;
  // joint 22 "neck_yaw": its acceleration, and that of the link beyond
  const Real x2989 = x2721 + 0.38 * x2736;
  const Real x2992 = x2718 - 0.38 * x2748;
  const Real x2999 = cosine[15] * x2736 - sine[15] * x2748;
  const Real x3011 = x2370 - x2371 * (cosine[15] * x2748 + sine[15] * x2736);
  const Real x3012 = x3011 - x2372 * (cosine[15] * x2992 - sine[15] * x2989);
  const Real x3013 = x2767 + x3012;
  w.result[27] = x3013;
  // joint 23 "neck_pitch": its acceleration, and that of the link beyond
  const Real x3016 = cosine[15] * x2989 + sine[15] * x2992 + 0.06 * x2999;
  const Real x3039 = x2269 + (cosine[16] * x2727 + sine[16] * x3016) * 1.7035775127768316;
  const Real x3040 = x3039 - 7.666098807495741 * (cosine[16] * x3016 - sine[16] * x2727);
  const Real x3041 = x3040 - x2999;
  w.result[28] = x3041;
  // joints 17 "left_shoulder_roll", 25 "right_shoulder_roll": their accelerations, and those of the links beyond
  const Two x2849 = x2848 - x2790;
  put(x2849, w.lanes.data() + 2);
  // joints 18 "left_shoulder_yaw", 26 "right_shoulder_yaw": their accelerations, and those of the links beyond
  const Two x2856 = x2822 - 0.1 * x2825;
  const Two x2853 = x2832 + 0.1 * x2848;
  const Two x2859 = taken<Two>(cosine + 4) * x2848 + taken<Two>(sine + 4) * x2825;
  const Two x2863 = taken<Two>(cosine + 4) * x2825 - taken<Two>(sine + 4) * x2848;
  const Two x2866 = taken<Two>(cosine + 4) * x2856 + taken<Two>(sine + 4) * x2853;
  const Two x2870 = taken<Two>(cosine + 4) * x2853 - taken<Two>(sine + 4) * x2856;
  const Two x2882 = x1694 - x1700 * x2836 - x1695 * x2859;
  const Two x2884 = x1696 * x2863 + x2882 - x1698 * x2866;
  const Two x2885 = x2884 - x1699 * x2870;
  const Two x2886 = x2885 - (taken<Two>(cosine + 2) * x2786 - taken<Two>(sine + 2) * x2812);
  put(x2886, w.lanes.data() + 4);
  // joints 19 "left_elbow", 27 "right_elbow": their accelerations, and those of the links beyond
  const Two x2891 = x2866 - 0.11 * x2863;
  const Two x2893 = x2870 + 0.11 * x2859;
  const Two x2903 = taken<Two>(cosine + 6) * x2836 + taken<Two>(sine + 6) * x2891;
  const Two x2907 = taken<Two>(cosine + 6) * x2891 - taken<Two>(sine + 6) * x2836;
  const Two x2896 = taken<Two>(cosine + 6) * x2885 + taken<Two>(sine + 6) * x2859;
  const Two x2900 = taken<Two>(cosine + 6) * x2859 - taken<Two>(sine + 6) * x2885;
  const Two x2919 = x1515 - x1520 * x2893 - x1518 * x2903;
  const Two x2921 = x2919 - x1519 * x2907 - x1516 * x2896;
  const Two x2922 = x2921 - x1517 * x2900;
  const Two x2923 = x2922 - x2863;
  put(x2923, w.lanes.data() + 6);
  // joints 20 "left_wrist_roll", 28 "right_wrist_roll": their accelerations, and those of the links beyond
  const Two x2936 = x2893 + 0.16 * x2900 + 0.01 * x2896;
  const Two x2931 = x2907 - 0.16 * x2922;
  const Two x2943 = taken<Two>(cosine + 8) * x2922 - taken<Two>(sine + 8) * x2900;
  const Two x2955 = x1348 + x1349 * (taken<Two>(cosine + 8) * x2900 + taken<Two>(sine + 8) * x2922);
  const Two x2956 = x1351 * (taken<Two>(cosine + 8) * x2936 - taken<Two>(sine + 8) * x2931) + x2955;
  const Two x2957 = x2956 - x2896;
  put(x2957, w.lanes.data() + 8);
  // joints 21 "left_wrist_pitch", 29 "right_wrist_pitch": their accelerations, and those of the links beyond
  const Two x2962 = taken<Two>(cosine + 8) * x2931 + taken<Two>(sine + 8) * x2936 - 0.04 * x2943;
  const Two x2978 = taken<Two>(cosine + 10) * x2962 - taken<Two>(sine + 10) * (x2903 - 0.01 * x2922);
  const Two x2983 = x1262 + x2978 * 11.980035271220512 - x2943;
  put(x2983, w.lanes.data() + 10);
}

// ---- 5. processes -------------------------------------------------------------------------------

// Process 0: 16 of 30 joints: "__base__", "left_hip_pitch", "left_hip_roll", "left_hip_yaw", "left_knee", "left_ankle_pitch", ...
constexpr std::array<int, 16> kRead_0{0, 1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12, 13, 14, 15};
constexpr std::array<int, 16> kOwned_0{0, 1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12, 13, 14, 15};
constexpr std::array<int, 15> kAngles_0{7, 13, 8, 14, 9, 15, 10, 16, 11, 17, 12, 18, 19, 20, 21};

void run_0([[maybe_unused]] Workspace& w, [[maybe_unused]] Channel& channel) {
  ADAGEN_INPUTS
  stamp(0);
  if (!all(unlike_zero(q + 0, 22) + unlike_zero(v + 0, 21) + unlike_zero(tau + 0, 21) == 0))
    name_what_is_not_finite(w, kRead_0, kOwned_0);
  w.to[0] = channel.outgoing(0, w.status);
  take_sines_and_cosines(q, kAngles_0, w.sine.data(), w.cosine.data());
  part_0_0(w);
  part_0_1(w);
  stamp(1);
  stamp(2);
  channel.send(0, w.status);  // to process 1: what hangs on "torso"
  stamp(3);
  part_0_2(w);
  w.from[1] = channel.receive(1, w.status);  // from process 1: what hangs on "torso"
  stamp(4);
  part_0_3(w);
  stamp(5);
  stamp(6);
  if (!all(unlike_zero(w.result.data() + 0, 6) + unlike_zero(w.result.data() + 18, 3) + unlike_zero<Two, 6>(w.lanes.data() + 0) == 0)) {
    w.result[6] = w.lanes[0];
    w.result[7] = w.lanes[2];
    w.result[8] = w.lanes[4];
    w.result[9] = w.lanes[6];
    w.result[10] = w.lanes[8];
    w.result[11] = w.lanes[10];
    w.result[12] = w.lanes[1];
    w.result[13] = w.lanes[3];
    w.result[14] = w.lanes[5];
    w.result[15] = w.lanes[7];
    w.result[16] = w.lanes[9];
    w.result[17] = w.lanes[11];
    name_what_overflows(w, kOwned_0);
  }
  if (w.status != kFine) return;
  std::copy_n(w.result.data() + 0, 6, w.qdd + 0);
  std::copy_n(w.result.data() + 18, 3, w.qdd + 18);
  w.qdd[6] = w.lanes[0];
  w.qdd[7] = w.lanes[2];
  w.qdd[8] = w.lanes[4];
  w.qdd[9] = w.lanes[6];
  w.qdd[10] = w.lanes[8];
  w.qdd[11] = w.lanes[10];
  w.qdd[12] = w.lanes[1];
  w.qdd[13] = w.lanes[3];
  w.qdd[14] = w.lanes[5];
  w.qdd[15] = w.lanes[7];
  w.qdd[16] = w.lanes[9];
  w.qdd[17] = w.lanes[11];
}

// Process 1: 14 of 30 joints: "left_shoulder_pitch", "left_shoulder_roll", "left_shoulder_yaw", "left_elbow", "left_wrist_roll", "left_wrist_pitch", ...; kinematics of 4 more on the way to the ground
constexpr std::array<int, 18> kRead_1{0, 13, 14, 15, 16, 17, 18, 19, 20, 21, 22, 23, 24, 25, 26, 27, 28, 29};
constexpr std::array<int, 14> kOwned_1{16, 17, 18, 19, 20, 21, 22, 23, 24, 25, 26, 27, 28, 29};
constexpr std::array<int, 17> kAngles_1{22, 30, 23, 31, 24, 32, 25, 33, 26, 34, 27, 35, 19, 20, 21, 28, 29};

void run_1([[maybe_unused]] Workspace& w, [[maybe_unused]] Channel& channel) {
  ADAGEN_INPUTS
  stamp(0);
  if (!all(unlike_zero(q + 0, 7) + unlike_zero(q + 19, 17) + unlike_zero(v + 0, 6) + unlike_zero(v + 18, 17) + unlike_zero(tau + 21, 14) == 0))
    name_what_is_not_finite(w, kRead_1, kOwned_1);
  w.to[1] = channel.outgoing(1, w.status);
  take_sines_and_cosines(q, kAngles_1, w.sine.data(), w.cosine.data());
  part_1_0(w);
  part_1_1(w);
  stamp(1);
  stamp(2);
  channel.send(1, w.status);  // to process 0: what hangs on "torso"
  stamp(3);
  part_1_2(w);
  w.from[0] = channel.receive(0, w.status);  // from process 0: what hangs on "torso"
  stamp(4);
  part_1_3(w);
  stamp(5);
  stamp(6);
  if (!all(unlike_zero(w.result.data() + 27, 2) + unlike_zero<Two, 6>(w.lanes.data() + 0) == 0)) {
    w.result[21] = w.lanes[0];
    w.result[22] = w.lanes[2];
    w.result[23] = w.lanes[4];
    w.result[24] = w.lanes[6];
    w.result[25] = w.lanes[8];
    w.result[26] = w.lanes[10];
    w.result[29] = w.lanes[1];
    w.result[30] = w.lanes[3];
    w.result[31] = w.lanes[5];
    w.result[32] = w.lanes[7];
    w.result[33] = w.lanes[9];
    w.result[34] = w.lanes[11];
    name_what_overflows(w, kOwned_1);
  }
  if (w.status != kFine) return;
  std::copy_n(w.result.data() + 27, 2, w.qdd + 27);
  w.qdd[21] = w.lanes[0];
  w.qdd[22] = w.lanes[2];
  w.qdd[23] = w.lanes[4];
  w.qdd[24] = w.lanes[6];
  w.qdd[25] = w.lanes[8];
  w.qdd[26] = w.lanes[10];
  w.qdd[29] = w.lanes[1];
  w.qdd[30] = w.lanes[3];
  w.qdd[31] = w.lanes[5];
  w.qdd[32] = w.lanes[7];
  w.qdd[33] = w.lanes[9];
  w.qdd[34] = w.lanes[11];
}

[[maybe_unused]] constexpr std::array<void (*)(Workspace&, Channel&), kProcesses> kRun{run_0, run_1};

// What each process reads of q and v, the velocity entries whose qdd is its own, and whose tau it
// reads.
constexpr std::array<Range, 1> kReadQ_0{ {{0, 22}} };
constexpr std::array<Range, 1> kReadV_0{ {{0, 21}} };
constexpr std::array<Range, 1> kOwn_0{ {{0, 21}} };
constexpr std::array<Range, 1> kTorque_0{ {{0, 21}} };
constexpr std::array<Range, 2> kReadQ_1{ {{0, 7}, {19, 17}} };
constexpr std::array<Range, 2> kReadV_1{ {{0, 6}, {18, 17}} };
constexpr std::array<Range, 1> kOwn_1{ {{21, 14}} };
constexpr std::array<Range, 1> kTorque_1{ {{21, 14}} };
[[maybe_unused]] constexpr std::array<ProcessInfo, kProcesses> kProcess{ {
    {{1, kReadQ_0.data()}, {1, kReadV_0.data()}, {1, kOwn_0.data()}, {1, kTorque_0.data()}},
    {{2, kReadQ_1.data()}, {2, kReadV_1.data()}, {1, kOwn_1.data()}, {1, kTorque_1.data()}},
} };

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
class Solver {
 public:
  Workspace w;
  Channel channel;
  std::string text;  // of the last failure

  // State and result in place: reads what this process needs, writes what it owns.
  int solve(const Number* q, const Number* v, const Number* tau, Number* qdd) {
    if (channel.broken()) return finish(failure(kNoAnswer, 0));
    prepare(q, v, tau, qdd);
    run();
    return finish(w.status);
  }

  // Everything through process 0: it has the state and gets all accelerations.
  int solve_at_root(const Number* q, const Number* v, const Number* tau, Number* qdd) {
    if constexpr (kProcesses == 1) return solve(q, v, tau, qdd);
    if (channel.broken()) return finish(failure(kNoAnswer, 0));
    return channel.rank() == 0 ? solve_as_root(q, v, tau, qdd) : solve_for_root();
  }

  // At process 0: the others' next solve_at_root returns kEnded, and so does this.
  int end_at_root() {
    if constexpr (kProcesses == 1) return kFine;
    return solve_as_root(q_.data(), v_.data(), tau_.data(), qdd_.data(), failure(kEnded, 0));
  }

 private:
  // A pose that the first try cannot stand is known to all processes: they try again together.
  void run() {
    const std::size_t rank = static_cast<std::size_t>(channel.rank());
    kRun[rank](w, channel);
#ifdef ADAGEN_RECOVERS
    if (failure_kind(w.status) != kSingularPose) return;
    w.status = kFine;
    kRecover[rank](w, channel);
#endif
  }

  int solve_for_root() {
    const int rank = channel.rank();
    const ProcessInfo& own = kProcess[static_cast<std::size_t>(rank)];
    if (own.own.count == 0) return finish(kFine);
    int status = kFine;
    const Number* content = channel.receive(state_message(rank), status);
    content = unpack(content, own.q, q_.data());
    content = unpack(content, own.v, v_.data());
    unpack(content, own.tau, tau_.data());
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
      pack(content, other.tau, tau);
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

  static int state_message(int process) { return kPlanMessages + 2 * (process - 1); }
  static int result_message(int process) { return kPlanMessages + 2 * (process - 1) + 1; }

  std::array<Number, kNq> q_{};
  std::array<Number, kNv> v_{}, qdd_{};
  std::array<Number, kNtau> tau_{};
};

}  // namespace

struct humanoid_p2_solver : Solver {};

extern "C" {

int humanoid_p2_joint(int k, const char** name, int* q, int* nq, int* v, int* nv) {
  if (k < 0 || k >= kJointCount) return 0;
  const JointConstants& joint = kJoints[k];
  *name = joint.name, *q = joint.q, *nq = joint.nq, *v = joint.v, *nv = joint.nv;
  return 1;
}

humanoid_p2_solver* humanoid_p2_open(MPI_Comm comm, const char* channel, double time_limit) {
  int size = 0;
  MPI_Comm_size(comm, &size);
  const std::string kind = channel;
  if (size != kProcesses || (kind != "auto" && kind != "window" && kind != "message")) return nullptr;
  auto* const solver = new humanoid_p2_solver;
  const ChannelMode mode = kind == "window"    ? ChannelMode::kWindow
                           : kind == "message" ? ChannelMode::kMessage
                                               : ChannelMode::kAuto;
  if (solver->channel.open(comm, mode, time_limit).empty()) return solver;
  humanoid_p2_close(solver);
  return nullptr;
}

int humanoid_p2_solve(humanoid_p2_solver* solver, const double* q, const double* v, const double* tau, double* qdd) {
  return solver->solve(q, v, tau, qdd);
}

int humanoid_p2_solve_at_root(humanoid_p2_solver* solver, const double* q, const double* v, const double* tau, double* qdd) {
  return solver->solve_at_root(q, v, tau, qdd);
}

const char* humanoid_p2_failure(const humanoid_p2_solver* solver) { return solver->text.c_str(); }

void humanoid_p2_close(humanoid_p2_solver* solver) {
  solver->channel.close();
  delete solver;
}

}  // extern "C"

// ---- 6. program ---------------------------------------------------------------------------------

#ifndef ADAGEN_NO_MAIN
namespace {

// An independent check: inverse dynamics by Newton's and Euler's equations, body by body, in
// double. It shares the model's constants with the solver, and no arithmetic.
namespace check {

using Vec = std::array<double, 3>;
using Mat = std::array<Vec, 3>;

Vec operator+(const Vec& a, const Vec& b) { return {a[0] + b[0], a[1] + b[1], a[2] + b[2]}; }
Vec cross(const Vec& a, const Vec& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}
Vec times(const Mat& m, const Vec& a) {
  Vec result{};
  for (int i = 0; i < 3; ++i) result[i] = m[i][0] * a[0] + m[i][1] * a[1] + m[i][2] * a[2];
  return result;
}
Vec transposed_times(const Mat& m, const Vec& a) {
  Vec result{};
  for (int i = 0; i < 3; ++i) result[i] = m[0][i] * a[0] + m[1][i] * a[1] + m[2][i] * a[2];
  return result;
}
Mat times(const Mat& a, const Mat& b) {
  Mat result{};
  for (int i = 0; i < 3; ++i)
    for (int j = 0; j < 3; ++j)
      for (int k = 0; k < 3; ++k) result[i][j] += a[i][k] * b[k][j];
  return result;
}
Vec vec3(const Number* x) { return {double(x[0]), double(x[1]), double(x[2])}; }
Mat mat3(const Number* x) { return {vec3(x), vec3(x + 3), vec3(x + 6)}; }

struct Body {
  Mat turn;   // child to parent coordinates
  Vec shift;  // child origin in parent coordinates
  Vec w, dw;  // angular velocity and acceleration, in the body's frame
  Vec a;      // acceleration of its origin minus gravity, in the body's frame
  Vec f, n;   // force on it through its joint, and moment about its origin
};

// Rotation and origin of the child frame in the joint frame.
void displace(const JointConstants& joint, const Number* q, Mat& turn, Vec& shift) {
  turn = {Vec{1, 0, 0}, Vec{0, 1, 0}, Vec{0, 0, 1}};
  shift = {};
  const auto about_z = [&turn](double angle) {
    const double c = std::cos(angle), s = std::sin(angle);
    turn = {Vec{c, -s, 0}, Vec{s, c, 0}, Vec{0, 0, 1}};
  };
  const auto orient = [&turn](const Number* p) {
    double x = double(p[0]), y = double(p[1]), z = double(p[2]), w = double(p[3]);
    const double length = std::sqrt(x * x + y * y + z * z + w * w);
    x /= length, y /= length, z /= length, w /= length;
    turn = {Vec{1 - 2 * (y * y + z * z), 2 * (x * y - z * w), 2 * (x * z + y * w)},
            Vec{2 * (x * y + z * w), 1 - 2 * (x * x + z * z), 2 * (y * z - x * w)},
            Vec{2 * (x * z - y * w), 2 * (y * z + x * w), 1 - 2 * (x * x + y * y)}};
  };
  switch (joint.kind) {
    case JointKind::kRevolute:
      about_z(double(q[0]));
      break;
    case JointKind::kPrismatic:
      shift[2] = double(q[0]);
      break;
    case JointKind::kSpherical:
      orient(q);
      break;
    case JointKind::kPlanar:
      about_z(double(q[2])), shift = {double(q[0]), double(q[1]), 0};
      break;
    case JointKind::kFloating:
      orient(q + 3), shift = vec3(q);
      break;
  }
}

// Angular and linear part of a joint's velocity or acceleration, in the child's frame.
void motion(const JointConstants& joint, const Number* x, Vec& angular, Vec& linear) {
  angular = linear = {};
  switch (joint.kind) {
    case JointKind::kRevolute:
      angular[2] = double(x[0]);
      break;
    case JointKind::kPrismatic:
      linear[2] = double(x[0]);
      break;
    case JointKind::kSpherical:
      angular = vec3(x);
      break;
    case JointKind::kPlanar:
      linear = {double(x[0]), double(x[1]), 0}, angular[2] = double(x[2]);
      break;
    case JointKind::kFloating:
      linear = vec3(x), angular = vec3(x + 3);
      break;
  }
}

// What a joint's damping, friction, spring and rotor take of its torque.
void add_passive(const JointConstants& joint, const Number* q, const Number* v, const Number* qdd,
                 double* tau) {
  const Passive& own = joint.passive;
  for (int k = 0; k < joint.nv; ++k) {
    const double rate = double(v[joint.v + k]);
    tau[k] += double(own.damping) * rate + double(own.rotor) * double(qdd[joint.v + k]) +
              double(own.friction) * std::tanh(rate / double(own.friction_speed));
  }
  if (own.stiffness != 0) tau[0] += double(own.stiffness) * (double(q[joint.q]) - double(own.rest));
}

// The outer forces push their links.
void push(const Number* outer, std::array<Body, kLinkCount>& body) {
  for (const OuterForce& one : kOuterForces) {
    Body& b = body[static_cast<std::size_t>(one.link)];
    const Mat turn = mat3(one.rotation);
    const Vec force = times(turn, vec3(outer)), moment = times(turn, vec3(outer + 3));
    const Vec lever = cross(vec3(one.translation), force);
    for (int k = 0; k < 3; ++k) b.f[k] -= force[k], b.n[k] -= moment[k] + lever[k];
    outer += 6;
  }
}

// Torques that give accelerations qdd at (q, v) beside the outer forces; slaved joints count
// through their sources' torques.
void inverse_dynamics(const Number* q, const Number* v, const Number* qdd, const Number* outer,
                      double* tau) {
  static std::array<Body, kLinkCount> body;
  body[0] = {};
  for (int k = 0; k < 3; ++k) body[0].a[k] = -kGravity[k];
  for (int j = 0; j < kJointCount; ++j) {
    const JointConstants& joint = kJoints[j];
    const LinkConstants& link = kLinks[j + 1];
    const Body& parent = body[joint.parent];
    Body& b = body[j + 1];
    Mat turn;
    Vec shift, spin, slide, spin_rate, slide_rate;
    displace(joint, q + joint.q, turn, shift);
    motion(joint, v + joint.v, spin, slide);
    motion(joint, qdd + joint.v, spin_rate, slide_rate);
    b.turn = times(mat3(joint.rotation), turn);
    b.shift = vec3(joint.translation) + times(mat3(joint.rotation), shift);
    const Vec carried = transposed_times(b.turn, parent.w);
    b.w = carried + spin;
    b.dw = transposed_times(b.turn, parent.dw) + cross(carried, spin) + spin_rate;
    const Vec at_origin =
        parent.a + cross(parent.dw, b.shift) + cross(parent.w, cross(parent.w, b.shift));
    const Vec coriolis = cross(carried, slide);
    b.a =
        transposed_times(b.turn, at_origin) + coriolis + coriolis + cross(spin, slide) + slide_rate;
    const Vec c = vec3(link.com);
    const Vec at_com = b.a + cross(b.dw, c) + cross(b.w, cross(b.w, c));
    const Mat inertia = mat3(link.tensor);
    for (int k = 0; k < 3; ++k) b.f[k] = double(link.mass) * at_com[k];
    b.n = times(inertia, b.dw) + cross(b.w, times(inertia, b.w)) + cross(c, b.f);
  }
  push(outer, body);
  for (int j = kJointCount - 1; j >= 0; --j) {
    const JointConstants& joint = kJoints[j];
    const Body& b = body[j + 1];
    double* t = tau + joint.v;
    switch (joint.kind) {
      case JointKind::kRevolute:
        t[0] = b.n[2];
        break;
      case JointKind::kPrismatic:
        t[0] = b.f[2];
        break;
      case JointKind::kSpherical:
        std::copy(b.n.begin(), b.n.end(), t);
        break;
      case JointKind::kPlanar:
        t[0] = b.f[0], t[1] = b.f[1], t[2] = b.n[2];
        break;
      case JointKind::kFloating:
        std::copy(b.f.begin(), b.f.end(), t);
        std::copy(b.n.begin(), b.n.end(), t + 3);
        break;
    }
    add_passive(joint, q, v, qdd, t);
    Body& parent = body[joint.parent];
    const Vec force = times(b.turn, b.f);
    parent.f = parent.f + force;
    parent.n = parent.n + times(b.turn, b.n) + cross(b.shift, force);
  }
  for (int j = 0; j < kJointCount; ++j) {
    if (kJoints[j].source < 0) continue;
    tau[kJoints[kJoints[j].source].v] += kJoints[j].multiplier * tau[kJoints[j].v];
    tau[kJoints[j].v] = 0;
  }
}

// How far slaved accelerations are from following their sources, relative to their size, and
// prescribed ones from what was prescribed.
double slip(const Number* tau, const Number* qdd) {
  double worst = 0;
  for (const JointConstants& joint : kJoints) {
    for (int k = joint.v; joint.passive.prescribed && k < joint.v + joint.nv; ++k)
      worst = std::max(worst, std::abs(double(qdd[k]) - double(tau[k])));
    if (joint.source < 0) continue;
    const double own = double(qdd[joint.v]);
    const double due = joint.multiplier * double(qdd[kJoints[joint.source].v]);
    worst = std::max(worst, std::abs(own - due) / std::max(1.0, std::abs(due)));
  }
  return worst;
}

// The larger of that and of |ID(q, v, qdd) - tau| relative to the size of the torques that it
// balances.
double residual(const Number* q, const Number* v, const Number* tau, const Number* qdd) {
  static std::array<double, kNv> needed, at_rest;
  static std::array<Number, kNv> zero{};
  inverse_dynamics(q, v, qdd, tau + kNv, needed.data());
  inverse_dynamics(q, v, zero.data(), tau + kNv, at_rest.data());
  std::array<double, kNv> given{};
  for (int k = 0; k < kNv; ++k) given[k] = double(tau[k]);
  for (const JointConstants& joint : kJoints) {
    for (int k = joint.v; joint.passive.prescribed && k < joint.v + joint.nv; ++k)
      given[k] = needed[k] = at_rest[k] = 0;  // nobody asks for its torque
  }
  for (int j = 0; j < kJointCount; ++j) {
    if (kJoints[j].source < 0) continue;
    given[kJoints[kJoints[j].source].v] += kJoints[j].multiplier * given[kJoints[j].v];
    given[kJoints[j].v] = 0;
  }
  double error = 0, size = 0;
  for (int k = 0; k < kNv; ++k) {
    error += (needed[k] - given[k]) * (needed[k] - given[k]);
    size += given[k] * given[k] + at_rest[k] * at_rest[k];
  }
  return std::max(size > 0 ? std::sqrt(error / size) : std::sqrt(error), slip(tau, qdd));
}

}  // namespace check

// Reads JSON piece by piece; what is wrong is thrown.
class JsonReader {
 protected:
  explicit JsonReader(std::string text) : text_(std::move(text)) {}

  [[noreturn]] void refuse(const std::string& what) const {
    throw std::runtime_error(where_ + what);
  }

  void white() {
    while (at_ < text_.size() && std::strchr(" \t\r\n", text_[at_]) != nullptr) ++at_;
  }
  char peek() {
    white();
    if (at_ >= text_.size()) refuse("the file ends too early");
    return text_[at_];
  }
  void expect(char c) {
    if (peek() != c) refuse(std::string("expected '") + c + "', found '" + text_[at_] + "'");
    ++at_;
  }
  bool take(char c) {
    if (peek() != c) return false;
    ++at_;
    return true;
  }

  template <class Item>
  void array(Item item) {
    if (++depth_ > 64) refuse("nested too deeply");
    expect('[');
    if (!take(']')) {
      do item();
      while (take(','));
      expect(']');
    }
    --depth_;
  }
  template <class Item>
  void object(Item item) {
    if (++depth_ > 64) refuse("nested too deeply");
    expect('{');
    if (!take('}')) {
      do {
        const std::string key = string();
        expect(':');
        item(key);
      } while (take(','));
      expect('}');
    }
    --depth_;
  }

  std::vector<double> numbers() {
    std::vector<double> result;
    if (peek() == '[')
      array([&] { result.push_back(number()); });
    else
      result.push_back(number());
    return result;
  }

  double number() {
    peek();
    const std::size_t start = at_;
    const auto digits = [this] {
      const std::size_t first = at_;
      while (at_ < text_.size() && text_[at_] >= '0' && text_[at_] <= '9') ++at_;
      return at_ > first;
    };
    const auto next_is = [this](char a, char b) {
      return at_ < text_.size() && (text_[at_] == a || text_[at_] == b);
    };
    if (next_is('-', '-')) ++at_;
    bool good = digits();
    if (good && next_is('.', '.')) ++at_, good = digits();
    if (good && next_is('e', 'E')) {
      ++at_;
      if (next_is('+', '-')) ++at_;
      good = digits();
    }
    double value = 0;
    if (good) {
      const auto end = std::from_chars(text_.data() + start, text_.data() + at_, value);
      good = end.ec == std::errc() && end.ptr == text_.data() + at_ && std::isfinite(value);
    }
    if (!good) refuse("expected a finite number");
    return value;
  }

  bool boolean() {
    peek();
    for (const bool value : {true, false}) {
      const std::string word = value ? "true" : "false";
      if (text_.compare(at_, word.size(), word) == 0) {
        at_ += word.size();
        return value;
      }
    }
    refuse("expected true or false");
  }

  std::string string() {
    expect('"');
    std::string result;
    for (;;) {
      if (at_ >= text_.size()) refuse("a string does not end");
      const char c = text_[at_++];
      if (c == '"') return result;
      if (static_cast<unsigned char>(c) < 0x20) refuse("a control character in a string");
      if (c != '\\') {
        result += c;
        continue;
      }
      if (at_ >= text_.size()) refuse("a string does not end");
      const char escape = text_[at_++];
      const char* const from = "\"\\/bfnrt";
      const char* const to = "\"\\/\b\f\n\r\t";
      if (const char* place = std::strchr(from, escape); place != nullptr && escape != '\0')
        result += to[place - from];
      else if (escape == 'u')
        append_utf8(result, code_point());
      else
        refuse("an unknown escape in a string");
    }
  }

  unsigned hex4() {
    if (at_ + 4 > text_.size()) refuse("a string does not end");
    unsigned value = 0;
    const auto end = std::from_chars(text_.data() + at_, text_.data() + at_ + 4, value, 16);
    if (end.ec != std::errc() || end.ptr != text_.data() + at_ + 4)
      refuse("four hexadecimal digits expected");
    at_ += 4;
    return value;
  }
  unsigned code_point() {
    const unsigned high = hex4();
    if (high < 0xD800 || high > 0xDBFF) return high;
    if (text_.compare(at_, 2, "\\u") != 0) refuse("half a surrogate pair in a string");
    at_ += 2;
    return 0x10000 + ((high - 0xD800) << 10) + ((hex4() - 0xDC00) & 0x3FF);
  }
  static void append_utf8(std::string& s, unsigned c) {
    const auto put = [&s](unsigned byte) { s += static_cast<char>(byte); };
    if (c < 0x80) return put(c);
    if (c < 0x800) return put(0xC0 | c >> 6), put(0x80 | (c & 63));
    if (c < 0x10000) return put(0xE0 | c >> 12), put(0x80 | (c >> 6 & 63)), put(0x80 | (c & 63));
    put(0xF0 | c >> 18), put(0x80 | (c >> 12 & 63)), put(0x80 | (c >> 6 & 63)),
        put(0x80 | (c & 63));
  }

  void skip() {
    const char c = peek();
    if (c == '{')
      object([&](const std::string&) { skip(); });
    else if (c == '[')
      array([&] { skip(); });
    else if (c == '"')
      string();
    else if (c == 't' || c == 'f')
      boolean();
    else if (text_.compare(at_, 4, "null") == 0)
      at_ += 4;
    else
      number();
  }

  std::string text_, where_;
  std::size_t at_ = 0;
  int depth_ = 0;
};

// Reads a states file (JSON) and writes a result file, joints by name.
struct States {
  int count = 0;
  std::vector<Number> q, v, tau;  // one state after the other
};

class StatesReader : private JsonReader {
 public:
  explicit StatesReader(std::string text) : JsonReader(std::move(text)) {}

  // Returns an empty string, or what is wrong, as "LINE: message".
  std::string read(States& states) {
    try {
      parse(states);
      return "";
    } catch (const std::runtime_error& error) {
      return std::to_string(
                 1 + std::count(text_.begin(), text_.begin() + static_cast<long>(at_), '\n')) +
             ": error: " + error.what();
    }
  }

 private:
  void parse(States& states) {
    std::array<bool, kJointCount> seen{};
    std::vector<std::vector<double>> forces(kOuterCount);
    bool joints = false;
    object([&](const std::string& key) {
      if (key == "joints") {
        joints = true;
        object([&](const std::string& name) { read_joint(name, seen, states); });
      } else if (key == "forces" && kOuterCount > 0) {
        object([&](const std::string& name) { read_force(name, forces); });
      } else if (key == "floating") {
        if (boolean() != kFloatingBase)
          refuse(std::string("\"floating\": this solver's base is ") +
                 (kFloatingBase ? "floating" : "fixed") + "; generate it anew");
      } else if (key == "gravity") {
        const std::vector<double> given = numbers();
        if (given.size() != 3 || !std::equal(given.begin(), given.end(), kGravity.begin()))
          refuse("\"gravity\": another gravity is compiled into this solver; generate it anew");
      } else {
        refuse("unknown member " + quoted(key.c_str()));
      }
    });
    white();
    if (at_ != text_.size()) refuse("text behind the end");
    if (!joints) refuse("\"joints\" is missing");
    for (int j = 0; j < kJointCount; ++j)
      if (!seen[j] && kJoints[j].source < 0)
        refuse("joint " + quoted(kJoints[j].name) + " is missing");
    fill_slaved(states);
    for (std::size_t k = 0; k < kOuterCount; ++k) fill_force(k, forces[k], states);
  }

  void read_joint(const std::string& name, std::array<bool, kJointCount>& seen, States& states) {
    int j = 0;
    while (j < kJointCount && name != kJoints[j].name) ++j;
    if (j == kJointCount) refuse("unknown joint " + quoted(name.c_str()));
    const std::string joint = "joint " + quoted(name.c_str());
    if (seen[j]) refuse(joint + " comes twice");
    seen[j] = true;
    std::array<bool, 3> found{};
    const char* const input = kJoints[j].passive.prescribed ? "qdd" : "tau";
    object([&](const std::string& key) {
      if (key == "type" || (key == "qdd" && key != input))
        return skip();  // as in a file of true answers
      const char* const fields[] = {"q", "v", input};
      const auto field = std::find(std::begin(fields), std::end(fields), key);
      if (field == std::end(fields)) refuse(joint + ": unknown member " + quoted(key.c_str()));
      bool& there = found[static_cast<std::size_t>(field - std::begin(fields))];
      if (there) refuse(joint + ": " + key + " comes twice");
      there = true;
      where_ = joint + ": " + key + ": ";
      read_field(kJoints[j], key, states);
      where_.clear();
    });
    if (!found[0] || !found[1] || !found[2]) refuse(joint + " needs q, v and " + input);
  }

  // One of q, v and tau of a joint: an entry for each state.
  void read_field(const JointConstants& joint, const std::string& key, States& states) {
    const bool is_q = key == "q";
    const auto size = static_cast<std::size_t>(is_q ? joint.nq : joint.nv);
    const auto start = static_cast<std::size_t>(is_q ? joint.q : joint.v);
    const std::size_t stride = is_q ? kNq : key == "v" ? kNv : kNtau;
    std::vector<Number>& values = is_q ? states.q : key == "v" ? states.v : states.tau;
    int count = 0;
    array([&] {
      const std::vector<double> entry = numbers();
      if (entry.size() != size)
        refuse("state " + std::to_string(count + 1) + " has " + std::to_string(entry.size()) +
               " numbers, not " + std::to_string(size));
      const std::size_t row = stride * static_cast<std::size_t>(count);
      if (values.size() < row + stride) values.resize(row + stride);
      for (std::size_t k = 0; k < size; ++k)
        values[row + start + k] = static_cast<Number>(entry[k]);
      ++count;
    });
    if (count == 0) refuse("there is no state");
    if (states.count == 0) states.count = count;
    if (count != states.count)
      refuse(std::to_string(count) + " states, but others have " + std::to_string(states.count));
  }

  // One link's outer force: six numbers for each state.
  void read_force(const std::string& name, std::vector<std::vector<double>>& forces) {
    std::size_t k = 0;
    while (k < kOuterCount && name != kOuterForces[k].name) ++k;
    if (k == kOuterCount) refuse("no outer force acts on link " + quoted(name.c_str()));
    where_ = "force on link " + quoted(name.c_str()) + ": ";
    if (!forces[k].empty()) refuse("comes twice");
    array([&] {
      const std::vector<double> entry = numbers();
      if (entry.size() != 6) refuse("needs six numbers for each state");
      forces[k].insert(forces[k].end(), entry.begin(), entry.end());
    });
    where_.clear();
  }

  void fill_force(std::size_t k, const std::vector<double>& given, States& states) {
    if (given.size() != 6 * static_cast<std::size_t>(states.count))
      refuse("force on link " + quoted(kOuterForces[k].name) + ": " +
             std::to_string(given.size() / 6) + " states, but the joints have " +
             std::to_string(states.count));
    for (std::size_t i = 0; i < given.size(); ++i)
      states.tau[i / 6 * kNtau + kNv + 6 * k + i % 6] = static_cast<Number>(given[i]);
  }

  static void fill_slaved(States& states) {
    for (int s = 0; s < states.count; ++s)
      slave(states.q.data() + static_cast<long>(s) * kNq,
            states.v.data() + static_cast<long>(s) * kNv);
  }
};

// more: further members of the file, each after a comma.
bool write_result(const std::string& path, const std::vector<Number>& qdd, int count,
                  const std::string& more) {
  std::FILE* file = std::fopen(path.c_str(), "w");
  if (file == nullptr) return false;
  std::fputs("{\"joints\": {", file);
  for (int j = 0; j < kJointCount; ++j) {
    std::fprintf(file, "%s\n%s: {\"qdd\": [", j == 0 ? "" : ",", quoted(kJoints[j].name).c_str());
    for (int s = 0; s < count; ++s) {
      const Number* x = qdd.data() + static_cast<long>(s) * kNv + kJoints[j].v;
      std::fputs(s == 0 ? "" : ", ", file);
      if (kJoints[j].nv > 1) std::fputs("[", file);
      for (int k = 0; k < kJoints[j].nv; ++k)
        if (x[k] == x[k])
          std::fprintf(file, "%s%.17g", k == 0 ? "" : ", ", static_cast<double>(x[k]));
        else  // of a batch, a state that failed
          std::fputs(k == 0 ? "null" : ", null", file);
      if (kJoints[j].nv > 1) std::fputs("]", file);
    }
    std::fputs("]}", file);
  }
  std::fprintf(file, "\n}%s}\n", more.c_str());
  const bool good = std::ferror(file) == 0;
  return std::fclose(file) == 0 && good;
}

constexpr ChannelMode kChannelMode = ChannelMode::kAuto;

// Configurations as points of a manifold. Near an anchor q0 a configuration has local coordinates
// x, as many as velocities: a rotation vector in the child's frame where there is a quaternion,
// the change of q itself elsewhere (of a floating or planar joint's position: in its joint frame).
namespace manifold {

using State = std::vector<double>;

// a x b.
inline void cross(const double* a, const double* b, double* result) {
  for (int k = 0; k < 3; ++k)
    result[k] = a[(k + 1) % 3] * b[(k + 2) % 3] - a[(k + 2) % 3] * b[(k + 1) % 3];
}

// The joint's own rotation takes v, in the child's frame, to the joint frame: v + 2 p x (w v + p x
// v) for a quaternion (p, w) of any length.
inline void rotate(const double* quaternion, const double* v, double* result) {
  double squared = 0, inner[3], outer[3];
  for (int k = 0; k < 4; ++k) squared += quaternion[k] * quaternion[k];
  cross(quaternion, v, inner);
  for (int k = 0; k < 3; ++k) inner[k] += quaternion[3] * v[k];
  cross(quaternion, inner, outer);
  for (int k = 0; k < 3; ++k) result[k] = v[k] + 2 / squared * outer[k];
}

// Quaternions p times (x, w).
inline void multiply(const double* p, const double* x, double w, double* result) {
  double twisted[3];
  cross(p, x, twisted);
  for (int k = 0; k < 3; ++k) result[k] = p[3] * x[k] + w * p[k] + twisted[k];
  result[3] = p[3] * w - (p[0] * x[0] + p[1] * x[1] + p[2] * x[2]);
}

inline double length(const double* x, int count) {
  double squared = 0;
  for (int k = 0; k < count; ++k) squared += x[k] * x[k];
  return std::sqrt(squared);
}

constexpr bool turns_freely(const JointConstants& joint) { return joint.nq >= 4; }

ADAGEN_HOT void normalise(State& q) {
  for (const JointConstants& joint : kJoints) {
    if (!turns_freely(joint)) continue;
    double* const quaternion = &q[static_cast<std::size_t>(joint.q + joint.nq - 4)];
    const double size = length(quaternion, 4);
    if (!(size > 0)) continue;  // the solver refuses it by name
    for (int k = 0; k < 4; ++k) quaternion[k] /= size;
  }
}

// Velocity of the origin of a floating or planar joint's child, told in the joint frame; its row
// count.
inline int position_rate(const JointConstants& joint, const double* q, const double* v,
                         double* rate) {
  if (joint.kind == JointKind::kFloating) {
    rotate(q + 3, v, rate);
    return 3;
  }
  if (joint.kind != JointKind::kPlanar) return 0;
  const double c = std::cos(q[2]), s = std::sin(q[2]);
  rate[0] = c * v[0] - s * v[1];
  rate[1] = s * v[0] + c * v[1];
  return 2;
}

// q' as numbers: quaternions by half their product with the angular velocity.
ADAGEN_HOT void rate(const State& q, const State& v, State& result) {
  for (const JointConstants& joint : kJoints) {
    const double* const own = &q[static_cast<std::size_t>(joint.q)];
    const double* const speed = &v[static_cast<std::size_t>(joint.v)];
    double* const to = &result[static_cast<std::size_t>(joint.q)];
    const int done = position_rate(joint, own, speed, to);
    if (turns_freely(joint)) {
      const double half[3] = {speed[done] / 2, speed[done + 1] / 2, speed[done + 2] / 2};
      multiply(own + done, half, 0, to + done);
    } else {
      std::copy(speed + done, speed + joint.nv, to + done);
    }
  }
}

// x' at local coordinates x, where the configuration is q: for rotations the inverse of the
// exponential's derivative, v + x x v / 2 + c x x (x x v), c = (1 - a cot a) / (2 a)^2 at a =
// |x|/2.
ADAGEN_HOT void local_rate(const State& q, const State& x, const State& v, State& result) {
  for (const JointConstants& joint : kJoints) {
    const double* const speed = &v[static_cast<std::size_t>(joint.v)];
    double* const to = &result[static_cast<std::size_t>(joint.v)];
    const int done = position_rate(joint, &q[static_cast<std::size_t>(joint.q)], speed, to);
    std::copy(speed + done, speed + joint.nv, to + done);
    if (!turns_freely(joint)) continue;
    const double* const turn = &x[static_cast<std::size_t>(joint.v + done)];
    const double half = length(turn, 3) / 2;
    const double c = half < 1e-3 ? 1.0 / 12 + half * half / 180
                                 : (1 - half / std::tan(half)) / (4 * half * half);
    double once[3], twice[3];
    cross(turn, speed + done, once);
    cross(turn, once, twice);
    for (int k = 0; k < 3; ++k) to[done + k] += once[k] / 2 + c * twice[k];
  }
}

// The configuration with local coordinates x about the anchor.
ADAGEN_HOT void advance(const State& anchor, const State& x, State& q) {
  for (const JointConstants& joint : kJoints) {
    const double* const from = &anchor[static_cast<std::size_t>(joint.q)];
    const double* const by = &x[static_cast<std::size_t>(joint.v)];
    double* const to = &q[static_cast<std::size_t>(joint.q)];
    const int plain = turns_freely(joint) ? joint.nq - 4 : joint.nq;
    for (int k = 0; k < plain; ++k) to[k] = from[k] + by[k];
    if (!turns_freely(joint)) continue;
    const double* const turn = by + plain;
    const double half = length(turn, 3) / 2;
    const double part = half < 1e-3 ? 0.5 - half * half / 12 : std::sin(half) / (2 * half);
    const double vector[3] = {part * turn[0], part * turn[1], part * turn[2]};
    multiply(from + plain, vector, std::cos(half), to + plain);
  }
}

}  // namespace manifold

// Damping D, stiffness K and friction of joints as they act at the end of a step, where these
// joints move with v + u instead of v: they take g(u) = (D + h K) u + friction at v + u less
// friction at v of the torques with springs at q + h v, for which a0 would be the answer. From the
// evaluations of unit torques, M = (H^-1) at these joints: u = h (a0 - M g(u)). One evaluation for
// each such degree of freedom, and two.
class PassiveTerms {
 public:
  using State = std::vector<double>;

  PassiveTerms() : extra_(kNv), base_(kNv), unit_(kNv) {
    for (const JointConstants& joint : kJoints)
      for (int k = 0; k < joint.nv; ++k) {
        const Passive& own = joint.passive;
        if (!own.prescribed && (own.damping > 0 || own.stiffness > 0 || own.friction > 0))
          rows_.push_back({static_cast<std::size_t>(joint.v + k), double(own.damping),
                           double(own.stiffness), double(own.friction),
                           double(own.friction_speed)});
      }
    for (State* x : {&taken_, &next_, &slope_, &u_, &du_}) x->resize(rows_.size());
    for (State* x : {&matrix_, &factors_}) x->resize(rows_.size() * rows_.size());
  }

  // a at the end of a step of length h from (q, v).
  template <class Accelerate>
  int accelerate(double h, const State& q, const State& v, State& a, Accelerate evaluate) {
    const std::size_t n = rows_.size();
    std::fill(extra_.begin(), extra_.end(), 0.0);
    for (const Row& row : rows_) extra_[row.v] = -h * row.stiffness * v[row.v];
    if (const int failed = evaluate(q, v, extra_, base_)) return failed;
    if (n == 0) {
      a = base_;
      return kFine;
    }
    for (std::size_t k = 0; k < n; ++k) {
      const double before = extra_[rows_[k].v];
      extra_[rows_[k].v] += 1;
      if (const int failed = evaluate(q, v, extra_, unit_)) return failed;
      extra_[rows_[k].v] = before;
      for (std::size_t i = 0; i < n; ++i)
        matrix_[i * n + k] = unit_[rows_[i].v] - base_[rows_[i].v];
    }
    settle(h, v);
    for (std::size_t k = 0; k < n; ++k) extra_[rows_[k].v] -= taken_[k];
    return evaluate(q, v, extra_, a);
  }

 private:
  struct Row {
    std::size_t v;
    double damping, stiffness, friction, friction_speed;

    bool rubs() const { return friction > 0; }

    // What is taken at the end of a step that changes the velocity v by u.
    double torque(double h, double at, double u) const {
      const double linear = (damping + h * stiffness) * u;
      if (!rubs()) return linear;
      return linear +
             friction * (std::tanh((at + u) / friction_speed) - std::tanh(at / friction_speed));
    }

    // Its derivative by u.
    double slope(double h, double end) const {
      if (!rubs()) return damping + h * stiffness;
      const double part = std::tanh(end / friction_speed);
      return damping + h * stiffness + friction / friction_speed * (1 - part) * (1 + part);
    }
  };

  static constexpr int kMostSteps = 100;
  static constexpr double kNear = 1e-10, kFlat = 0.1;

  // taken_ <- g(u) by Newton's method. g grows with u and M is positive semi-definite, so that u is
  // where a convex function is least: a step is shortened until that function no longer rises
  // steeply. What is linear takes one step.
  void settle(double h, const State& v) {
    const bool rubs =
        std::any_of(rows_.begin(), rows_.end(), [](const Row& row) { return row.rubs(); });
    std::fill(taken_.begin(), taken_.end(), 0.0);
    for (int step = 0; step < (rubs ? kMostSteps : 1); ++step) {
      aim(h, v);
      const double length = rubs ? step_length(h, v) : 1;
      bool near = true;
      for (std::size_t k = 0; k < rows_.size(); ++k) {
        const double change = next_[k] - taken_[k];
        taken_[k] += length * change;
        near &= std::abs(change) <= kNear * std::abs(taken_[k]) ||
                std::abs(du_[k]) <= kNear * (std::abs(v[rows_[k].v]) + std::abs(u_[k]));
      }
      if (near || length == 0) return;
    }
  }

  // From taken_: u_; by the derivative there, next_ as taken_ would be and du_ as u_ would change.
  ADAGEN_HOT void aim(double h, const State& v) {
    const std::size_t n = rows_.size();
    for (std::size_t i = 0; i < n; ++i) {
      const Row& row = rows_[i];
      double a = base_[row.v];
      for (std::size_t k = 0; k < n; ++k) a -= matrix_[i * n + k] * taken_[k];
      u_[i] = h * a;
      slope_[i] = row.slope(h, v[row.v] + u_[i]);
      next_[i] = slope_[i] * (h * base_[row.v] - u_[i]) + row.torque(h, v[row.v], u_[i]);
      for (std::size_t k = 0; k < n; ++k)
        factors_[i * n + k] = (i == k) + h * slope_[i] * matrix_[i * n + k];
    }
    solve();
    for (std::size_t i = 0; i < n; ++i) {
      du_[i] = 0;
      for (std::size_t k = 0; k < n; ++k) du_[i] -= h * matrix_[i * n + k] * (next_[k] - taken_[k]);
    }
  }

  // How much of the way from taken_ to next_ is gone, at most 1; 0 where there is nowhere to go.
  double step_length(double h, const State& v) const {
    const double start = rise(0, h, v);
    if (!(start < 0)) return 0;
    double low = 0, high = 1, length = 1;
    for (int halvings = 0; halvings < 60; ++halvings) {
      const double found = rise(length, h, v);
      if (std::abs(found) <= -kFlat * start || (length == 1 && found < 0)) break;
      (found > 0 ? high : low) = length;
      length = (low + high) / 2;
    }
    return length;
  }

  // The convex function's derivative at a part of the way.
  ADAGEN_HOT double rise(double part, double h, const State& v) const {
    double sum = 0;
    for (std::size_t k = 0; k < rows_.size(); ++k) {
      const double there = taken_[k] + part * (next_[k] - taken_[k]);
      sum += du_[k] * (rows_[k].torque(h, v[rows_[k].v], u_[k] + part * du_[k]) - there);
    }
    return sum;
  }

  // next_ <- factors_^-1 next_ by elimination, without pivoting: but for scales of rows and
  // columns the matrix is symmetric and positive definite.
  ADAGEN_HOT void solve() {
    const std::size_t n = rows_.size();
    for (std::size_t k = 0; k < n; ++k)
      for (std::size_t i = k + 1; i < n; ++i) {
        const double part = factors_[i * n + k] / factors_[k * n + k];
        for (std::size_t j = k; j < n; ++j) factors_[i * n + j] -= part * factors_[k * n + j];
        next_[i] -= part * next_[k];
      }
    for (std::size_t k = n; k-- > 0;) {
      for (std::size_t j = k + 1; j < n; ++j) next_[k] -= factors_[k * n + j] * next_[j];
      next_[k] /= factors_[k * n + k];
    }
  }

  std::vector<Row> rows_;
  State extra_, base_, unit_, matrix_, factors_;
  State taken_, next_, slope_, u_, du_;  // torques twice; their derivatives; changes of velocity
};

// Fixed-step integrators of q' = G(q) v, v' = a(q, v). All but RK4 and the explicit Euler method
// move quaternions by the exponential map, so that these keep their length.
enum class Integrator { kEuler, kSemiImplicit, kImplicit, kRk4, kRkmk4 };

struct IntegratorInfo {
  const char* name;
  Integrator kind;
};

constexpr std::array<IntegratorInfo, 5> kIntegrators{{
    {"euler", Integrator::kEuler},
    {"semi-implicit", Integrator::kSemiImplicit},
    {"implicit", Integrator::kImplicit},
    {"rk4", Integrator::kRk4},
    {"rkmk4", Integrator::kRkmk4},
}};

class Stepper {
 public:
  using State = manifold::State;

  Stepper() {
    for (State* x : {&middle_q_, &q_rate_, &q_sum_}) x->resize(kNq);
    for (State* x : {&middle_v_, &a_, &v_sum_, &x_, &x_rate_, &x_sum_, &none_}) x->resize(kNv);
  }

  // One step of length h from (q, v) to (q, v). accelerate(q, v, extra, a) evaluates with extra
  // torques and returns a status; where that is a failure, the state stays as it was.
  template <class Accelerate>
  int step(Integrator kind, double h, State& q, State& v, Accelerate accelerate) {
    switch (kind) {
      case Integrator::kRk4:
        return runge_kutta(h, q, v, accelerate);
      case Integrator::kRkmk4:
        return munthe_kaas(h, q, v, accelerate);
      case Integrator::kImplicit:
        return implicit(h, q, v, accelerate);
      default:
        return euler(kind == Integrator::kSemiImplicit, h, q, v, accelerate);
    }
  }

 private:
  static constexpr std::array<double, 4> kNode{0, 0.5, 0.5, 1}, kWeight{1, 2, 2, 1};

  // y + h dy
  ADAGEN_HOT static void move(const State& y, double h, const State& dy, State& result) {
    for (std::size_t k = 0; k < y.size(); ++k) result[k] = y[k] + h * dy[k];
  }

  template <class Accelerate>
  int euler(bool semi_implicit, double h, State& q, State& v, Accelerate accelerate) {
    if (const int failed = accelerate(q, v, none_, a_)) return failed;
    manifold::rate(q, v, q_rate_);
    move(v, h, a_, v);
    if (semi_implicit)
      follow(h, q, v);
    else
      move(q, h, q_rate_, q);
    manifold::normalise(q);
    return kFine;
  }

  // The semi-implicit method with damping and springs as they are at the end of the step.
  template <class Accelerate>
  int implicit(double h, State& q, State& v, Accelerate accelerate) {
    if (const int failed = passive_.accelerate(h, q, v, a_, accelerate)) return failed;
    move(v, h, a_, v);
    follow(h, q, v);
    manifold::normalise(q);
    return kFine;
  }

  // Moves q along v by the exponential map.
  void follow(double h, State& q, const State& v) {
    std::fill(x_.begin(), x_.end(), 0.0);
    manifold::local_rate(q, x_, v, x_rate_);
    move(x_, h, x_rate_, x_);
    manifold::advance(q, x_, middle_q_);
    q.swap(middle_q_);
  }

  // The classical method on q as numbers; quaternions are normalised after the step.
  template <class Accelerate>
  int runge_kutta(double h, State& q, State& v, Accelerate accelerate) {
    middle_q_ = q;
    middle_v_ = v;
    std::fill(q_sum_.begin(), q_sum_.end(), 0.0);
    std::fill(v_sum_.begin(), v_sum_.end(), 0.0);
    for (std::size_t k = 0; k < kNode.size(); ++k) {
      if (k > 0) {
        move(q, kNode[k] * h, q_rate_, middle_q_);
        move(v, kNode[k] * h, a_, middle_v_);
      }
      if (const int failed = accelerate(middle_q_, middle_v_, none_, a_)) return failed;
      manifold::rate(middle_q_, middle_v_, q_rate_);
      move(q_sum_, kWeight[k] / 6, q_rate_, q_sum_);
      move(v_sum_, kWeight[k] / 6, a_, v_sum_);
    }
    move(q, h, q_sum_, q);
    move(v, h, v_sum_, v);
    manifold::normalise(q);
    return kFine;
  }

  // Runge-Kutta-Munthe-Kaas: the same method on local coordinates about the step's start.
  template <class Accelerate>
  int munthe_kaas(double h, State& q, State& v, Accelerate accelerate) {
    middle_q_ = q;
    middle_v_ = v;
    for (State* x : {&x_, &x_sum_, &v_sum_}) std::fill(x->begin(), x->end(), 0.0);
    for (std::size_t k = 0; k < kNode.size(); ++k) {
      if (k > 0) {
        for (std::size_t i = 0; i < x_.size(); ++i) x_[i] = kNode[k] * h * x_rate_[i];
        manifold::advance(q, x_, middle_q_);
        move(v, kNode[k] * h, a_, middle_v_);
      }
      if (const int failed = accelerate(middle_q_, middle_v_, none_, a_)) return failed;
      manifold::local_rate(middle_q_, x_, middle_v_, x_rate_);
      move(x_sum_, h * kWeight[k] / 6, x_rate_, x_sum_);
      move(v_sum_, h * kWeight[k] / 6, a_, v_sum_);
    }
    manifold::advance(q, x_sum_, middle_q_);
    q.swap(middle_q_);
    move(v, 1, v_sum_, v);
    manifold::normalise(q);
    return kFine;
  }

  State middle_q_, middle_v_, q_rate_, a_, q_sum_, v_sum_, x_, x_rate_, x_sum_;
  State none_;  // no extra torques
  PassiveTerms passive_;
};

// Where --trajectory goes: times, configurations and velocities as CSV, a line each, or as .npz
// (numpy: time (T), q (T, nq), v (T, nv), and the joints' names).
class Trajectory {
 public:
  static constexpr double kMostBytes = 4e9;  // a member of a zip file without 64-bit extensions

  static bool is_npz(const std::string& path) { return ends_with(path, ".npz"); }
  static bool is_known(const std::string& path) { return is_npz(path) || ends_with(path, ".csv"); }

  // False where the file cannot be written.
  bool open(const std::string& path) {
    path_ = path;
    if (path.empty()) return true;
    file_.reset(std::fopen(path.c_str(), "wb"));
    if (file_ == nullptr) return false;
    if (!is_npz(path)) write_names();
    return true;
  }

  void record(double time, const std::vector<double>& q, const std::vector<double>& v) {
    if (file_ == nullptr) return;
    if (is_npz(path_)) {
      times_.push_back(time);
      q_.insert(q_.end(), q.begin(), q.end());
      v_.insert(v_.end(), v.begin(), v.end());
      return;
    }
    std::fprintf(file_.get(), "%.17g", time);
    for (const std::vector<double>* values : {&q, &v})
      for (const double x : *values) std::fprintf(file_.get(), ",%.17g", x);
    std::fputc('\n', file_.get());
  }

  // False where writing has failed.
  bool close() {
    if (file_ == nullptr) return true;
    if (is_npz(path_)) write_archive();
    const bool good = std::ferror(file_.get()) == 0;
    return std::fclose(file_.release()) == 0 && good;
  }

 private:
  struct Close {
    void operator()(std::FILE* file) const { std::fclose(file); }
  };
  struct Member {
    std::string name;
    std::uint32_t check, size, offset;
  };

  static bool ends_with(const std::string& text, const std::string& end) {
    return text.size() >= end.size() &&
           text.compare(text.size() - end.size(), end.size(), end) == 0;
  }

  // "time", then a name for each number: JOINT.q, or JOINT.q0 and so on where there are several.
  void write_names() {
    std::fputs("time", file_.get());
    for (const char field : {'q', 'v'})
      for (const JointConstants& joint : kJoints) {
        std::string name;
        for (const char* c = joint.name; *c != '\0'; ++c)
          name += *c == '"' ? "\"\"" : std::string(1, *c);
        const int count = field == 'q' ? joint.nq : joint.nv;
        for (int k = 0; k < count; ++k)
          std::fprintf(file_.get(), ",\"%s.%c%s\"", name.c_str(), field,
                       count > 1 ? std::to_string(k).c_str() : "");
      }
    std::fputc('\n', file_.get());
  }

  void write_archive() {
    std::vector<Member> members;
    const auto rows = std::to_string(times_.size());
    const auto add = [&](const char* name, const std::string& type, const std::string& shape,
                         const void* data, std::size_t bytes) {
      members.push_back(write_member(name, npy_head(type, shape), data, bytes));
    };
    add("time.npy", "<f8", "(" + rows + ",)", times_.data(), 8 * times_.size());
    add("q.npy", "<f8", "(" + rows + ", " + std::to_string(kNq) + ")", q_.data(), 8 * q_.size());
    add("v.npy", "<f8", "(" + rows + ", " + std::to_string(kNv) + ")", v_.data(), 8 * v_.size());
    std::size_t longest = 1;
    for (const JointConstants& joint : kJoints)
      longest = std::max(longest, std::strlen(joint.name));
    std::string names;  // UTF-8, padded with zeros
    for (const JointConstants& joint : kJoints) {
      names += joint.name;
      names.resize((names.size() / longest + (names.size() % longest > 0)) * longest);
    }
    add("joints.npy", "|S" + std::to_string(longest), "(" + std::to_string(kJointCount) + ",)",
        names.data(), names.size());
    write_directory(members);
  }

  static std::string npy_head(const std::string& type, const std::string& shape) {
    std::string text =
        "{'descr': '" + type + "', 'fortran_order': False, 'shape': " + shape + ", }";
    text.resize((10 + text.size() + 1 + 63) / 64 * 64 - 11, ' ');
    text += '\n';
    return std::string("\x93NUMPY\x01\x00", 8) + low_bytes(text.size(), 2) + text;
  }

  static std::string low_bytes(std::uint64_t value, int count) {
    std::string result;
    for (int k = 0; k < count; ++k) result += static_cast<char>(value >> 8 * k & 0xFF);
    return result;
  }

  static std::uint32_t crc32(std::uint32_t before, const void* data, std::size_t bytes) {
    static const std::vector<std::uint32_t> table = [] {
      std::vector<std::uint32_t> rows(256);
      for (std::uint32_t k = 0; k < 256; ++k) {
        std::uint32_t x = k;
        for (int bit = 0; bit < 8; ++bit) x = x >> 1 ^ (x & 1 ? 0xEDB88320u : 0u);
        rows[k] = x;
      }
      return rows;
    }();
    std::uint32_t x = ~before;
    const auto* const at = static_cast<const unsigned char*>(data);
    for (std::size_t k = 0; k < bytes; ++k) x = table[(x ^ at[k]) & 0xFF] ^ x >> 8;
    return ~x;
  }

  // Method 0 (stored), 1 January 1980.
  static std::string zip_fields(const Member& member) {
    return low_bytes(20, 2) + low_bytes(0, 4) + low_bytes(0, 2) + low_bytes(0x21, 2) +
           low_bytes(member.check, 4) + low_bytes(member.size, 4) + low_bytes(member.size, 4) +
           low_bytes(member.name.size(), 2) + low_bytes(0, 2);
  }

  Member write_member(const char* name, const std::string& head, const void* data,
                      std::size_t bytes) {
    const Member member{name, crc32(crc32(0, head.data(), head.size()), data, bytes),
                        static_cast<std::uint32_t>(head.size() + bytes), written_};
    put(std::string("PK\x03\x04", 4) + zip_fields(member) + member.name + head);
    if (bytes > 0) std::fwrite(data, 1, bytes, file_.get());
    written_ += static_cast<std::uint32_t>(bytes);
    return member;
  }

  void write_directory(const std::vector<Member>& members) {
    const std::uint32_t start = written_;
    for (const Member& member : members)
      put(std::string("PK\x01\x02", 4) + low_bytes(20, 2) + zip_fields(member) + low_bytes(0, 10) +
          low_bytes(member.offset, 4) + member.name);
    const std::uint32_t size = written_ - start;
    put(std::string("PK\x05\x06", 4) + low_bytes(0, 4) + low_bytes(members.size(), 2) +
        low_bytes(members.size(), 2) + low_bytes(size, 4) + low_bytes(start, 4) + low_bytes(0, 2));
  }

  void put(const std::string& bytes) {
    std::fwrite(bytes.data(), 1, bytes.size(), file_.get());
    written_ += static_cast<std::uint32_t>(bytes.size());
  }

  std::string path_;
  std::unique_ptr<std::FILE, Close> file_;
  std::vector<double> times_, q_, v_;
  std::uint32_t written_ = 0;
};

struct SimulationOptions {
  double seconds = 0, step = 1e-3;  // no simulation where seconds are 0
  const IntegratorInfo* integrator = &kIntegrators[3];
  long long every = 1;  // steps between the rows of the trajectory
  std::string trajectory;
};

// What the program is asked to do.
struct Options {
  std::string states, result, trace;
  bool check = false, time = false, stretches = false, json = false, help = false, pin = true;
  int repeat = 200;
  std::uint64_t seed = 1;
  double time_limit = 30, tolerance = kTolerance;
  ChannelMode channel = kChannelMode;
  int hosts = 0;  // as many as there are
  SimulationOptions simulation;
};

enum ExitStatus : int { kDone = 0, kInputAtFault = 1, kUsage = 2, kFault = 3 };

const char* const kUsageText =
    "  --states FILE     solve these states (JSON, joints by name); --result FILE takes the "
    "answer\n"
    "  --result FILE     where the accelerations go (JSON); standard output if it is not given\n"
    "  --check           residual of an independent inverse dynamics, for the given or random "
    "states\n"
    "  --simulate S      integrate for S seconds from the one given state (or a random one), under "
    "its\n"
    "                    torques\n"
    "  --step H          length of a step in seconds (0.001)\n"
    "  --integrator NAME euler, semi-implicit, implicit, rk4 or rkmk4 (rk4)\n"
    "  --trajectory FILE where the motion goes: FILE.csv or FILE.npz\n"
    "  --every N         keep every Nth step of it (1), and the last\n"
    "  --trace FILE      when each process did what, as JSON (medians over random states)\n"
    "  --time            time an evaluation: median, minimum, 99th percentile over random states\n"
    "                    (where there are more processes than cores, as --stretches)\n"
    "  --stretches       time what each process computes between messages, one process at a time,\n"
    "                    and play it through with what messages cost; stands in for --time\n"
    "  --repeat N        evaluations of each random state when timing (200)\n"
    "  --seed N          seed of the random states (1)\n"
    "  --tolerance X     largest residual that --check lets pass\n"
    "  --channel KIND    auto, window (processes share memory) or message (MPI messages)\n"
    "  --hosts N         take the processes to be on N hosts, in equal parts: only those of one "
    "share memory\n"
    "  --timeout S       how long a process waits for another before it gives up, in seconds (30)\n"
    "  --no-pin          leave the processes to the system's scheduler when timing\n"
    "  --json            report as JSON on standard output\n"
    "  --help            this text\n"
    "Without --states, --check, --time, --trace or --simulate it checks and times. Exit status: 0 "
    "done, 1 "
    "input at "
    "fault\n"
    "(or a check that failed), 2 usage, 3 a process died or did not answer.\n";

constexpr std::array<const char*, 5> kSimulationWords{"--simulate", "--step", "--integrator",
                                                      "--trajectory", "--every"};

// Takes one option of a simulation; number is not a number where the value is none of 0 or more.
// Returns an empty string, or what is wrong.
std::string parse_simulation(const std::string& word, const std::string& value, double number,
                             SimulationOptions& options) {
  if (word == "--integrator") {
    std::string names;
    for (const IntegratorInfo& info : kIntegrators) {
      if (value == info.name) return options.integrator = &info, "";
      names += (names.empty() ? "" : ", ") + std::string(info.name);
    }
    return "--integrator takes one of " + names;
  }
  if (word == "--trajectory") {
    options.trajectory = value;
    return Trajectory::is_known(value) ? "" : "--trajectory takes FILE.csv or FILE.npz";
  }
  if (word == "--every") {
    options.every = number <= 1e12 ? static_cast<long long>(number) : 0;
    const bool whole = options.every >= 1 && number == std::floor(number);
    return whole ? "" : "--every takes a whole number from 1 to 1e12";
  }
  if (!(number > 0)) return word + " takes a number of seconds above 0";
  (word == "--step" ? options.step : options.seconds) = number;
  return "";
}

// Returns what is wrong with what was asked for together, and settles what was left open.
std::string settle(bool simulation_words, Options& options) {
  if (kBatch && (options.simulation.seconds > 0 || !options.trace.empty() || options.stretches))
    return "a batch solver has neither --simulate nor --trace nor --stretches";
  const bool others = options.check || options.time || !options.trace.empty();
  if (options.simulation.seconds > 0) {
    if (others || !options.result.empty())
      return "--simulate goes alone: without --check, --time, --trace and --result";
    return "";
  }
  if (simulation_words) return "--step, --integrator, --trajectory and --every need --simulate";
  if (!options.result.empty() && options.states.empty()) return "--result needs --states";
  if (options.json && options.result.empty() && !options.states.empty())
    return "--json needs --result FILE where there are --states: both would go to standard output";
  if (options.states.empty() && !others) options.check = options.time = true;
  return "";
}

// Returns an empty string, or what is wrong.
std::string parse(int count, char** words, Options& options) {
  bool simulation_words = false;
  for (int k = 1; k < count; ++k) {
    const std::string word = words[k];
    const auto flag = [&word](const char* name) { return word == name; };
    if (flag("--check"))
      options.check = true;
    else if (flag("--time"))
      options.time = true;
    else if (flag("--stretches"))
      options.time = options.stretches = true;
    else if (flag("--json"))
      options.json = true;
    else if (flag("--help"))
      options.help = true;
    else if (flag("--no-pin"))
      options.pin = false;
    else {
      const char* const known[] = {"--states",    "--result",  "--trace", "--repeat", "--seed",
                                   "--tolerance", "--channel", "--hosts", "--timeout"};
      const bool of_simulation =
          std::any_of(kSimulationWords.begin(), kSimulationWords.end(), flag);
      if (!of_simulation && std::none_of(std::begin(known), std::end(known), flag))
        return "unknown option " + word;
      if (k + 1 == count) return word + " needs a value";
      const std::string value = words[++k];
      char* end = nullptr;
      const double number = std::strtod(value.c_str(), &end);
      const bool numeric = !value.empty() && *end == '\0' && std::isfinite(number) && number >= 0;
      if (of_simulation) {
        simulation_words = true;
        const std::string wrong =
            parse_simulation(word, value, numeric ? number : std::nan(""), options.simulation);
        if (!wrong.empty()) return wrong;
      } else if (flag("--states"))
        options.states = value;
      else if (flag("--result"))
        options.result = value;
      else if (flag("--trace"))
        options.trace = value;
      else if (flag("--channel")) {
        if (value == "auto")
          options.channel = ChannelMode::kAuto;
        else if (value == "window")
          options.channel = ChannelMode::kWindow;
        else if (value == "message")
          options.channel = ChannelMode::kMessage;
        else
          return "--channel takes auto, window or message";
      } else if (!numeric)
        return word + " takes a number of 0 or more, not \"" + value + "\"";
      else if (flag("--repeat")) {
        if (number < 1 || number > 1e6 || number != std::floor(number))
          return "--repeat takes a whole number from 1 to 1000000";
        options.repeat = static_cast<int>(number);
      } else if (flag("--seed")) {
        if (number > 0x1p53 || number != std::floor(number))
          return "--seed takes a whole number of 0 or more";
        options.seed = static_cast<std::uint64_t>(number);
      } else if (flag("--hosts")) {
        if (number < 1 || number > kProcesses || number != std::floor(number))
          return "--hosts takes a whole number from 1 to " + std::to_string(kProcesses) +
                 ", that of processes";
        options.hosts = static_cast<int>(number);
      } else if (flag("--tolerance"))
        options.tolerance = number;
      else if (number <= 0 || number > 1e6)
        return "--timeout takes a number of seconds above 0, at most 1000000";
      else
        options.time_limit = number;
    }
  }
  return settle(simulation_words, options);
}

// Bounds the waits that the channel does not: MPI's own collective calls wait for ever for a
// process that was stopped. Whoever sees no progress for the time limit, and a second for the
// channel to say it better, ends, and mpiexec ends the others.
class Watch {
 public:
  void start(int rank, double time_limit) {
    std::snprintf(text(), kLength,
                  "error: process %d: another process did not answer within the time limit\n",
                  rank);
    seconds_ = time_limit + 1;
#if defined(__unix__) || defined(__APPLE__)
    struct sigaction action = {};
    action.sa_handler = give_up;
    sigaction(SIGALRM, &action, nullptr);
#endif
    again();
  }

  // There was progress: the time starts anew.
  void again() const {
#if defined(__unix__) || defined(__APPLE__)
    itimerval timer = {};
    timer.it_value.tv_sec = static_cast<decltype(timer.it_value.tv_sec)>(seconds_);
    timer.it_value.tv_usec =
        static_cast<decltype(timer.it_value.tv_usec)>(1e6 * (seconds_ - std::floor(seconds_)));
    setitimer(ITIMER_REAL, &timer, nullptr);
#endif
  }

 private:
  static constexpr std::size_t kLength = 100;

  static char* text() {
    static char place[kLength];
    return place;
  }

#if defined(__unix__) || defined(__APPLE__)
  // Only what a signal handler may call.
  static void give_up(int) {
    [[maybe_unused]] const auto written = write(STDERR_FILENO, text(), std::strlen(text()));
    _exit(kFault);
  }
#endif

  double seconds_ = 0;
};

// The stages of each process's work, for --trace.
constexpr std::array<Stage, 6> kStages_0{ {
    {"kinematics", 15, -1},
    {"assembly", 15, -1},
    {"send", -1, 0},
    {"receive", -1, 1},
    {"assembly", -1, -1},
    {"disassembly", 15, -1},
} };
constexpr std::array<Stage, 6> kStages_1{ {
    {"kinematics", 29, -1},
    {"assembly", 16, -1},
    {"send", -1, 1},
    {"receive", -1, 0},
    {"assembly", -1, -1},
    {"disassembly", 16, -1},
} };
constexpr std::array<const Stage*, kProcesses> kStages{kStages_0.data(), kStages_1.data()};
constexpr std::array<int, kProcesses> kStageCount{6, 6};

struct Statistics {
  double median = 0, least = 0, percentile99 = 0;
};

Statistics statistics(std::vector<double> ns) {
  std::sort(ns.begin(), ns.end());
  const auto at = [&ns](double part) {
    return ns[std::min(ns.size() - 1,
                       static_cast<std::size_t>(part * static_cast<double>(ns.size())))];
  };
  return {at(0.5), ns.front(), at(0.99)};
}

double nanoseconds(std::chrono::steady_clock::rep ticks) {
  using Duration = std::chrono::steady_clock::duration;
  return std::chrono::duration<double, std::nano>(Duration(ticks)).count();
}

// What one look at the clock takes; each time between two looks holds one.
double clock_cost() {
  using Clock = std::chrono::steady_clock;
  double best = 1e9;
  for (int k = 0; k < 64; ++k) {
    const Clock::time_point start = Clock::now();
    for (int i = 0; i < 64; ++i) (void)Clock::now();
    best = std::min(best, nanoseconds((Clock::now() - start).count()) / 65);
  }
  return best;
}

// What --trace FILE writes: when each stage of each process began and ended, as the medians over
// many evaluations of random states; ns from the instant at which the processes start together.
class Trace {
 public:
  using Clock = std::chrono::steady_clock;
  static constexpr std::size_t kMost = 12800;  // evaluations that are kept

  explicit Trace(int rank)
      : rank_(rank),
        stages_(kStageCount[static_cast<std::size_t>(rank)]),
        stamps_(static_cast<std::size_t>(stages_) + 1) {}

  void begin() { trace_stamps = stamps_.data(); }

  // Collective. An evaluation counts from when the first process began.
  void end(MPI_Comm comm, bool keep) {
    trace_stamps = nullptr;
    long long first = stamps_[0];
    MPI_Allreduce(MPI_IN_PLACE, &first, 1, MPI_LONG_LONG, MPI_MIN, comm);
    if (!keep || starts_.size() == kMost * (stamps_.size() - 1)) return;
    for (std::size_t k = 0; k + 1 < stamps_.size(); ++k) {
      starts_.push_back(nanoseconds(stamps_[k] - first));
      lengths_.push_back(nanoseconds(stamps_[k + 1] - stamps_[k]));
    }
    lasts_.push_back(nanoseconds(stamps_.back() - first));
  }

  // Collective; process 0 returns the text.
  std::string text(MPI_Comm comm, const char* channel, bool pinned) const {
    std::vector<double> own;
    for (int k = 0; k < stages_; ++k) {
      own.push_back(median(starts_, k));
      own.push_back(median(lengths_, k));
    }
    if (rank_ != 0) {
      MPI_Send(own.data(), static_cast<int>(own.size()), MPI_DOUBLE, 0, kTag, comm);
      return "";
    }
    std::string text = "{\"model\": " + quoted(kRobot) +
                       ", \"processes\": " + std::to_string(kProcesses) + ", \"channel\": \"" +
                       channel + "\", \"pinned\": " + (pinned ? "true" : "false") +
                       ", \"evaluations\": " + std::to_string(lasts_.size()) +
                       ", \"clock_ns\": " + number(clock_cost()) + ",\n \"stages\": [";
    for (int p = 0; p < kProcesses; ++p) {
      const std::size_t count = 2 * static_cast<std::size_t>(kStageCount[p]);
      std::vector<double> times(count);
      if (p == 0)
        times = own;
      else
        MPI_Recv(times.data(), static_cast<int>(count), MPI_DOUBLE, p, kTag, comm,
                 MPI_STATUS_IGNORE);
      for (std::size_t k = 0; 2 * k < count; ++k)
        text += row(p, kStages[p][k], times[2 * k], times[2 * k + 1]) + ",";
    }
    if (text.back() == ',') text.pop_back();
    return text + "\n ]}\n";
  }

 private:
  static constexpr int kTag = 0x7ace;

  static std::string number(double x) {
    char text[32];
    std::snprintf(text, sizeof text, "%.1f", x);
    return text;
  }

  static std::string row(int process, const Stage& stage, double start, double length) {
    const std::string joint = stage.joint < 0 ? "null" : quoted(kJoints[stage.joint].name);
    const std::string message = stage.message < 0 ? "null" : std::to_string(stage.message);
    return "\n  {\"process\": " + std::to_string(process) + ", \"what\": \"" + stage.what +
           "\", \"joint\": " + joint + ", \"message\": " + message +
           ", \"start_ns\": " + number(start) + ", \"length_ns\": " + number(length) + "}";
  }

  double median(const std::vector<double>& all, int stage) const {
    std::vector<double> one;
    const std::size_t step = stamps_.size() - 1;
    for (std::size_t k = static_cast<std::size_t>(stage); k < all.size(); k += step)
      one.push_back(all[k]);
    if (one.empty()) return 0;
    std::nth_element(one.begin(), one.begin() + static_cast<long>(one.size() / 2), one.end());
    return one[one.size() / 2];
  }

  int rank_, stages_;
  std::vector<Clock::rep> stamps_;
  std::vector<double> starts_, lengths_, lasts_;
};

// What the parts of the program share: the solver, the states at work, and how a failure is told.

// Random states, the same on every machine (splitmix64).
States random_states(int count, std::uint64_t seed) {
  const auto uniform = [&seed] {
    std::uint64_t z = (seed += 0x9E3779B97F4A7C15ULL);
    z = (z ^ (z >> 30)) * 0xBF58476D1CE4E5B9ULL;
    z = (z ^ (z >> 27)) * 0x94D049BB133111EBULL;
    return static_cast<double>((z ^ (z >> 31)) >> 11) * 0x1p-52 - 1;  // in [-1, 1)
  };
  States states;
  states.count = count;
  const auto size = [count](int n) {
    return static_cast<std::size_t>(count) * static_cast<std::size_t>(n);
  };
  states.q.resize(size(kNq));
  states.v.resize(size(kNv));
  states.tau.resize(size(kNtau));
  for (int s = 0; s < count; ++s) {
    Number* q =
        states.q.data() + size(kNq) / static_cast<std::size_t>(count) * static_cast<std::size_t>(s);
    Number* v =
        states.v.data() + size(kNv) / static_cast<std::size_t>(count) * static_cast<std::size_t>(s);
    Number* tau = states.tau.data() +
                  size(kNtau) / static_cast<std::size_t>(count) * static_cast<std::size_t>(s);
    for (const JointConstants& joint : kJoints) {
      const bool turns = joint.kind == JointKind::kRevolute;
      for (int k = 0; k < joint.nq; ++k)
        q[joint.q + k] = static_cast<Number>(turns ? 3.141592653589793 * uniform() : uniform());
      if (joint.nq >= 4) {
        double p[4], squared;
        do {
          squared = 0;
          for (double& x : p) x = uniform(), squared += x * x;
        } while (squared > 1 || squared < 0.01);
        for (int k = 0; k < 4; ++k)
          q[joint.q + joint.nq - 4 + k] = static_cast<Number>(p[k] / std::sqrt(squared));
      }
      for (int k = 0; k < joint.nv; ++k) {
        v[joint.v + k] = static_cast<Number>(uniform());
        tau[joint.v + k] = static_cast<Number>(uniform());
      }
    }
    for (int k = kNv; k < kNtau; ++k) tau[k] = static_cast<Number>(uniform());
    slave(q, v);
  }
  return states;
}

// The states file, read by process 0 and handed to all.
int load(const std::string& path, MPI_Comm comm, int rank, States& states) {
  int status = kDone;
  if (rank == 0) {
    std::ifstream file(path, std::ios::binary);
    file.peek();  // tells a folder from a file
    std::ostringstream text;
    if (!file.bad()) text << file.rdbuf();
    std::string wrong;
    if (!file.is_open() || file.bad())
      wrong = " error: cannot read the states file";
    else
      wrong = StatesReader(text.str()).read(states);
    if (!wrong.empty()) {
      std::fprintf(stderr, "%s:%s\n", path.c_str(), wrong.c_str());
      status = kInputAtFault;
    }
  }
  MPI_Bcast(&status, 1, MPI_INT, 0, comm);
  if (status != kDone) return status;
  MPI_Bcast(&states.count, 1, MPI_INT, 0, comm);
  const auto share = [&](std::vector<Number>& x, int n) {
    x.resize(static_cast<std::size_t>(states.count) * static_cast<std::size_t>(n));
    MPI_Bcast(x.data(), static_cast<int>(x.size()), kMpiNumber, 0, comm);
  };
  if (kBatch) return status;  // handed out as they are solved
  share(states.q, kNq);
  share(states.v, kNv);
  share(states.tau, kNtau);
  return status;
}

struct Session {
  Options options;
  int rank;
  Watch watch;
  Solver solver;
  States states;
  std::vector<Number> qdd;  // one acceleration after the other
  bool pinned = false;

  Session(Options given, int own_rank) : options(std::move(given)), rank(own_rank) {}

  MPI_Comm comm() const { return solver.channel.comm(); }
  const Number* q(int s) const { return states.q.data() + static_cast<long>(s) * kNq; }
  const Number* v(int s) const { return states.v.data() + static_cast<long>(s) * kNv; }
  const Number* tau(int s) const { return states.tau.data() + static_cast<long>(s) * kNtau; }
  Number* acceleration(int s) { return qdd.data() + static_cast<long>(s) * kNv; }

  void use(States given) {
    states = std::move(given);
    qdd.assign(static_cast<std::size_t>(states.count) * kNv, Number(0));
  }

  int complain(int status, const std::string& what, const std::string& file = "") const {
    const std::string place = file.empty() ? "" : file + ": ";
    if (rank == 0) std::fprintf(stderr, "%serror: %s\n", place.c_str(), what.c_str());
    return status;
  }

  // A process that waited in vain cannot be waited for: the whole run ends.
  void give_up_if_broken(int failed) const {
    if (failure_kind(failed) != kNoAnswer) return;
    std::fprintf(stderr, "error: process %d: %s\n", rank, describe(failed).c_str());
    std::fflush(stderr);
    MPI_Abort(MPI_COMM_WORLD, kFault);
  }

  const char* channel_name() const {
    if (kProcesses == 1) return "none";
    return solver.channel.name();
  }
};

// The cores that the processes on this node may use: whether there is one for each of them.
class Cores {
 public:
  // Collective.
  explicit Cores(MPI_Comm comm) : comm_(comm) {
    MPI_Comm node;
    int processes = 1;
    MPI_Comm_split_type(comm, MPI_COMM_TYPE_SHARED, 0, MPI_INFO_NULL, &node);
    MPI_Comm_rank(node, &place_);
    MPI_Comm_size(node, &processes);
#if defined(__linux__)
    CPU_ZERO(&own_);
    cpu_set_t all;
    known_ = sched_getaffinity(0, sizeof own_, &own_) == 0;
    // Each may be bound to one of its own.
    MPI_Allreduce(&own_, &all, static_cast<int>(sizeof all), MPI_BYTE, MPI_BOR, node);
    count_ = CPU_COUNT(&all);
    own_is_enough_ = known_ && CPU_COUNT(&own_) >= processes;
#endif
    if (count_ == 0) count_ = static_cast<int>(std::thread::hardware_concurrency());
    int enough = count_ == 0 || count_ >= processes;
    MPI_Allreduce(MPI_IN_PLACE, &enough, 1, MPI_INT, MPI_MIN, comm);
    enough_ = enough != 0;
    MPI_Comm_free(&node);
  }

  // Whether every process, on any node, can have one to itself.
  bool enough() const { return enough_; }

  int count() const { return count_; }

  // Collective. Each process onto one of its own, if there are as many; whether all are.
  bool pin() const {
    int pinned = own_is_enough_ && pin_to(place_);
    MPI_Allreduce(MPI_IN_PLACE, &pinned, 1, MPI_INT, MPI_MIN, comm_);
    return pinned != 0;
  }

  // This process onto one that others may have, too.
  void pin_in_turn() const { pin_to(place_); }

 private:
  // Onto the k-th of those that this process may use, counted round and round.
  bool pin_to([[maybe_unused]] int k) const {
#if defined(__linux__)
    if (!known_) return false;
    k %= CPU_COUNT(&own_);
    int cpu = 0;
    for (; cpu < CPU_SETSIZE; ++cpu)
      if (CPU_ISSET(cpu, &own_) && k-- == 0) break;
    cpu_set_t one;
    CPU_ZERO(&one);
    CPU_SET(cpu, &one);
    return sched_setaffinity(0, sizeof one, &one) == 0;
#else
    return false;
#endif
  }

  MPI_Comm comm_;
  int place_ = 0, count_ = 0;
  bool enough_ = true, own_is_enough_ = false;
#if defined(__linux__)
  bool known_ = false;
  cpu_set_t own_;
#endif
};

// A process's part in an evaluation: the messages that it sends and receives, in order, and how
// long it computes before each and after the last; ns.
struct Part {
  std::vector<int> messages;
  std::vector<double> stretches;  // one more than messages
};

// What a message costs, ns: its sender, from sent to seen, and per number to put it in and take it
// out again.
struct Hop {
  double send, latency, number;
};

// When the last process is done, were all to begin together on cores of their own: their parts
// played through, each message of a process waited for.
inline double makespan(const std::vector<Part>& parts, const std::vector<MessageInfo>& messages,
                       const Hop& hop) {
  std::vector<double> clock(parts.size(), 0);
  std::vector<std::size_t> at(parts.size(), 0), received(messages.size(), 0);
  std::vector<std::vector<double>> sent(messages.size());  // when, each time
  const auto advance = [&](std::size_t p) {
    const std::size_t k = static_cast<std::size_t>(parts[p].messages[at[p]]);
    const double ready = clock[p] + parts[p].stretches[at[p]];
    const double copying = hop.number * messages[k].size / 2;
    if (messages[k].source == static_cast<int>(p)) {
      clock[p] = ready + hop.send + copying;
      sent[k].push_back(clock[p]);
    } else {
      if (received[k] == sent[k].size()) return false;  // not sent yet
      clock[p] = std::max(ready, sent[k][received[k]++] + hop.latency) + copying;
    }
    ++at[p];
    return true;
  };
  for (bool moved = true; moved;) {
    moved = false;
    for (std::size_t p = 0; p < parts.size(); ++p)
      while (at[p] < parts[p].messages.size() && advance(p)) moved = true;
  }
  double last = 0;
  for (std::size_t p = 0; p < parts.size(); ++p)
    last = std::max(last, clock[p] + parts[p].stretches.back());
  return last;
}

// As the cost profile default has them.
constexpr Hop kWindowHop{0, 130, 0.176};
constexpr Hop kMessageHop{22.3, 196, 0.484};

// What messages cost on a channel.
inline const Hop& hop_of(const Channel& channel) {
  return channel.windowed() ? kWindowHop : kMessageHop;
}

// How long an evaluation would take if each process had a core of its own, where they have not: its
// processes compute one at a time, the others asleep, with the messages that they have once had
// (take.hpp); then these stretches and what messages cost are played through (makespan.hpp).
class Stretches {
 public:
  explicit Stretches(Session& session) : session_(session) {}

  // Collective. Evaluates each state of the session by evaluate(s), which returns its status; is
  // told before each turn, and after it. Returns the first failure.
  template <class Evaluate, class Turn>
  int measure(Evaluate evaluate, Turn turn) {
    takes_.assign(count(), Take());
    lengths_.assign(count(), {});
    int failed = record(evaluate);
    MPI_Allreduce(MPI_IN_PLACE, &failed, 1, MPI_INT, MPI_MAX, session_.comm());
    if (failed != kFine) return failed;
    const int repeat = evaluations() / session_.states.count, rounds = std::min(kRounds, repeat);
    for (int round = 0; round < rounds; ++round)
      for (int p = 0; p < kProcesses; ++p) {
        rest();
        if (p != session_.rank) continue;
        turn();
        play(evaluate, repeat * (round + 1) / rounds - repeat * round / rounds);
      }
    rest();
    return kFine;
  }

  // Of each state, at most as many as are kept.
  int evaluations() const {
    return std::min(session_.options.repeat, kMost) * session_.states.count;
  }

  // Collective. Over the states, at process 0: medians of the stretches played through, and the
  // least of all. Holds one look at the clock, as other times do.
  Statistics played_through() {
    const std::vector<std::vector<double>> told = bring_together();
    if (session_.rank != 0) return {};
    const std::vector<MessageInfo> messages(kMessages.begin(), kMessages.end());
    std::vector<const double*> next;
    for (const std::vector<double>& one : told) next.push_back(one.data());
    work_.assign(kProcesses, 0);
    std::vector<double> typical, least;
    for (std::size_t s = 0; s < count(); ++s) {
      std::vector<Part> medians(kProcesses), leasts(kProcesses);
      for (std::size_t p = 0; p < kProcesses; ++p) {
        next[p] = read(next[p], medians[p], leasts[p]);
        for (const double ns : medians[p].stretches) work_[p] += ns / static_cast<double>(count());
      }
      typical.push_back(makespan(medians, messages, hop()) + look_);
      least.push_back(makespan(leasts, messages, hop()) + look_);
    }
    Statistics found = statistics(std::move(typical));
    found.least = *std::min_element(least.begin(), least.end());
    return found;
  }

  // For how long each process computes in an evaluation, ns, as last played through.
  const std::vector<double>& work() const { return work_; }

 private:
  using Clock = std::chrono::steady_clock;
  static constexpr int kTag = 0x57e7, kRounds = 5, kMost = 1000;

  std::size_t count() const { return static_cast<std::size_t>(session_.states.count); }
  const Hop& hop() const { return hop_of(session_.solver.channel); }

  template <class Evaluate>
  int record(Evaluate evaluate) {
    int failed = kFine;
    for (int s = 0; s < session_.states.count; ++s) {
      Take& take = takes_[static_cast<std::size_t>(s)];
      take.record();
      session_.solver.channel.use(&take);
      const int found = evaluate(s);
      session_.solver.channel.use(nullptr);
      session_.give_up_if_broken(found);
      if (failed == kFine) failed = found;
    }
    return failed;
  }

  // A turn: all states as often as asked for, after once to warm up.
  template <class Evaluate>
  void play(Evaluate evaluate, int passes) {
    look_ = clock_cost();
    for (int pass = -1; pass < passes; ++pass)
      for (int s = 0; s < session_.states.count; ++s) {
        Take& take = takes_[static_cast<std::size_t>(s)];
        take.play();
        session_.solver.channel.use(&take);
        const Clock::rep start = Clock::now().time_since_epoch().count();
        evaluate(s);
        const Clock::rep end = Clock::now().time_since_epoch().count();
        session_.solver.channel.use(nullptr);
        if (pass >= 0) keep(start, take.looks(), end, lengths_[static_cast<std::size_t>(s)]);
      }
  }

  void keep(Clock::rep start, const std::vector<Clock::rep>& looks, Clock::rep end,
            std::vector<double>& lengths) const {
    for (std::size_t k = 0; k <= looks.size(); ++k) {
      const Clock::rep until = k < looks.size() ? looks[k] : end;
      lengths.push_back(std::max(0.0, nanoseconds(until - start) - look_));
      start = until;
    }
  }

  // Waits for the others, asleep: whoever computes is not disturbed.
  void rest() const {
    MPI_Request request;
    MPI_Ibarrier(session_.comm(), &request);
    for (int done = 0; MPI_Test(&request, &done, MPI_STATUS_IGNORE), !done;)
      std::this_thread::sleep_for(std::chrono::microseconds(200));
    session_.watch.again();
  }

  // Collective. At process 0, for each process what it found of all states, one after the other:
  // number of messages, the messages, then medians and least of their stretches.
  std::vector<std::vector<double>> bring_together() {
    std::vector<double> own;
    for (std::size_t s = 0; s < count(); ++s) {
      const std::vector<int>& messages = takes_[s].messages();
      own.push_back(static_cast<double>(messages.size()));
      own.insert(own.end(), messages.begin(), messages.end());
      const std::vector<Statistics> found = of_stretches(lengths_[s], messages.size() + 1);
      for (const Statistics& one : found) own.push_back(one.median);
      for (const Statistics& one : found) own.push_back(one.least);
    }
    std::vector<std::vector<double>> all(kProcesses);
    if (session_.rank != 0) {
      MPI_Send(own.data(), static_cast<int>(own.size()), MPI_DOUBLE, 0, kTag, session_.comm());
      return all;
    }
    all[0] = std::move(own);
    for (int p = 1; p < kProcesses; ++p) {
      MPI_Status status;
      int size = 0;
      MPI_Probe(p, kTag, session_.comm(), &status);
      MPI_Get_count(&status, MPI_DOUBLE, &size);
      all[static_cast<std::size_t>(p)].resize(static_cast<std::size_t>(size));
      MPI_Recv(all[static_cast<std::size_t>(p)].data(), size, MPI_DOUBLE, p, kTag, session_.comm(),
               MPI_STATUS_IGNORE);
    }
    return all;
  }

  static std::vector<Statistics> of_stretches(const std::vector<double>& lengths,
                                              std::size_t stretches) {
    std::vector<Statistics> found;
    for (std::size_t first = 0; first < stretches; ++first) {
      std::vector<double> one;
      for (std::size_t k = first; k < lengths.size(); k += stretches) one.push_back(lengths[k]);
      found.push_back(statistics(std::move(one)));
    }
    return found;
  }

  static const double* read(const double* from, Part& median, Part& least) {
    const std::size_t messages = static_cast<std::size_t>(*from++);
    median.messages.assign(from, from + messages);
    least.messages = median.messages;
    from += messages;
    median.stretches.assign(from, from + messages + 1);
    from += messages + 1;
    least.stretches.assign(from, from + messages + 1);
    return from + messages + 1;
  }

  Session& session_;
  std::vector<Take> takes_;                   // of each state
  std::vector<std::vector<double>> lengths_;  // of each state: one evaluation after the other
  double look_ = 0;                           // at the clock
  std::vector<double> work_;
};

// How long batches take (--time): on one process, two, four, ... and all.
class BatchTiming {
 public:
  explicit BatchTiming(Session& session) : session_(session) {}

  static constexpr int kStates = 1024;  // for each process

  // Collective. Times batches of random states, each begun by start(), which returns when that was.
  // Returns the first failure.
  template <class S, class Start>
  int measure(S& solver, Start start) {
    const int count = kStates * (session_.rank == 0 ? kProcesses : 1);
    session_.use(random_states(count, session_.options.seed));
    for (int active = 1;; active = std::min(2 * active, kProcesses)) {
      const int failed = measure_on(active, solver, start);
      if (failed != kFine || active == kProcesses) return failed;
    }
  }

  // Nanoseconds for each state and process, on all processes.
  const Statistics& in_place() const { return steps_.back().in_place; }
  const Statistics& at_root() const { return steps_.back().at_root; }

  // Nothing where nothing was timed.
  std::string json() const {
    std::string text;
    for (const Step& step : steps_) {
      char words[120];
      std::snprintf(words, sizeof words,
                    "%s{\"processes\": %d, \"in_place\": %.4g, \"through_root\": %.4g}",
                    text.empty() ? ", \"states_per_second\": [" : ", ", step.processes,
                    step.per_second(step.in_place), step.per_second(step.at_root));
      text += words;
    }
    return text + (text.empty() ? "" : "]");
  }

  void print(std::FILE* out) const {
    if (steps_.empty()) return;
    std::fprintf(out,
                 "       states per second:  in place  per process   through 0  per process\n");
    for (const Step& step : steps_) {
      const double in_place = step.per_second(step.in_place);
      const double at_root = step.per_second(step.at_root);
      std::fprintf(out, "       %4d process%-2s   %11.3g  %11.3g %11.3g  %11.3g\n", step.processes,
                   step.processes == 1 ? "" : "es", in_place, in_place / step.processes, at_root,
                   at_root / step.processes);
    }
  }

 private:
  struct Step {
    int processes;
    Statistics in_place, at_root;
    double per_second(const Statistics& ns) const { return 1e9 * processes / ns.median; }
  };

  template <class S, class Start>
  int measure_on(int active, S& solver, Start start) {
    std::vector<double> in_place, at_root;
    int failed = kFine;
    const auto time = [&](std::vector<double>* times, auto solve) {
      const std::chrono::steady_clock::time_point begin = start();
      const int found = solve();
      const double ns = nanoseconds((std::chrono::steady_clock::now() - begin).count());
      session_.give_up_if_broken(found);
      if (failed == kFine) failed = found;
      if (times != nullptr) times->push_back(ns / kStates);
    };
    for (int pass = -1; pass < session_.options.repeat && failed == kFine; ++pass) {
      session_.watch.again();
      const Number *const q = session_.q(0), *const v = session_.v(0), *const tau = session_.tau(0);
      Number* const qdd = session_.acceleration(0);
      time(pass < 0 ? nullptr : &in_place, [&] {
        return solver.solve_batch(session_.rank < active ? kStates : 0, q, v, tau, qdd);
      });
      time(pass < 0 ? nullptr : &at_root, [&] {
        return solver.solve_batch_at_root(kStates * active, q, v, tau, qdd, active - 1);
      });
      MPI_Allreduce(MPI_IN_PLACE, &failed, 1, MPI_INT, MPI_MAX, session_.comm());
    }
    if (failed != kFine) return failed;
    for (std::vector<double>* ns : {&in_place, &at_root})  // over when the last process is done
      MPI_Allreduce(MPI_IN_PLACE, ns->data(), static_cast<int>(ns->size()), MPI_DOUBLE, MPI_MAX,
                    session_.comm());
    steps_.push_back({active, statistics(std::move(in_place)), statistics(std::move(at_root))});
    return kFine;
  }

  Session& session_;
  std::vector<Step> steps_;
};

// How long an evaluation takes (--time, --stretches), and where the time goes (--trace).
class Timing {
 public:
  explicit Timing(Session& session) : session_(session) {}

  int time_all() {
    const Cores cores(session_.comm());
    crowded_ = !cores.enough();
    cores_ = cores.count();
    if constexpr (kBatch) return time_batch(session_.solver, cores);
    session_.use(random_states(kRandomStates, session_.options.seed));
    if (crowded_ || session_.options.stretches) return time_stretches(cores);
    session_.pinned = session_.options.pin && cores.pin();
    std::vector<double> in_place, at_root;
    int failed = kFine;
    for (int pass = -1; pass < session_.options.repeat && failed == kFine;
         ++pass) {  // the first one warms up
      session_.watch.again();
      for (int s = 0; s < session_.states.count; ++s) {
        Number* const qdd = session_.acceleration(s);
        const Clock::time_point start = start_together();
        const int first = session_.solver.solve(session_.q(s), session_.v(s), session_.tau(s), qdd);
        const double in_place_ns =
            std::chrono::duration<double, std::nano>(Clock::now() - start).count();
        if (kProcesses > 1) MPI_Barrier(session_.comm());
        const Clock::time_point start_root = Clock::now();
        const int second =
            session_.solver.solve_at_root(session_.q(s), session_.v(s), session_.tau(s), qdd);
        const double root_ns =
            std::chrono::duration<double, std::nano>(Clock::now() - start_root).count();
        session_.give_up_if_broken(first);
        session_.give_up_if_broken(second);
        if (failed == kFine) failed = first != kFine ? first : second;
        if (pass < 0) continue;
        in_place.push_back(in_place_ns);
        at_root.push_back(root_ns);
      }
      MPI_Allreduce(MPI_IN_PLACE, &failed, 1, MPI_INT, MPI_MAX, session_.comm());
    }
    if (failed != kFine)
      return session_.complain(kInputAtFault, "random state: " + describe(failed));
    // An evaluation is over when its last process is done.
    MPI_Allreduce(MPI_IN_PLACE, in_place.data(), static_cast<int>(in_place.size()), MPI_DOUBLE,
                  MPI_MAX, session_.comm());
    in_place_ = statistics(std::move(in_place));
    at_root_ = statistics(std::move(at_root));
    evaluations_ = session_.options.repeat * kRandomStates;
    return kDone;
  }

  // Where processes share cores, or where it is asked for.
  int time_stretches(const Cores& cores) {
    const auto turn = [&] {
      if (session_.options.pin) cores.pin_in_turn();
    };
    const auto in_place = [this](int s) {
      return session_.solver.solve(session_.q(s), session_.v(s), session_.tau(s),
                                   session_.acceleration(s));
    };
    const auto at_root = [this](int s) {
      return session_.solver.solve_at_root(session_.q(s), session_.v(s), session_.tau(s),
                                           session_.acceleration(s));
    };
    Stretches stretches(session_);
    int failed = stretches.measure(at_root, turn);
    if (failed == kFine) at_root_ = stretches.played_through();
    if (failed == kFine) failed = stretches.measure(in_place, turn);
    if (failed != kFine)
      return session_.complain(kInputAtFault, "random state: " + describe(failed));
    in_place_ = stretches.played_through();
    work_ = stretches.work();
    evaluations_ = stretches.evaluations();
    return kDone;
  }

  template <class S>
  int time_batch(S& solver, const Cores& cores) {
    session_.pinned = session_.options.pin && cores.pin();
    int failed = kFine;
    if constexpr (kBatch) failed = batches_.measure(solver, [this] { return start_together(); });
    if (failed != kFine)
      return session_.complain(kInputAtFault, "random states: " + describe(failed));
    in_place_ = batches_.in_place();
    at_root_ = batches_.at_root();
    evaluations_ = session_.options.repeat * BatchTiming::kStates;
    return kDone;
  }

  // The same evaluations with time stamps between the stages of each process.
  int trace_all() {
    session_.use(random_states(kRandomStates, session_.options.seed));
    if (!session_.pinned && session_.options.pin) session_.pinned = Cores(session_.comm()).pin();
    Trace trace(session_.rank);
    int failed = kFine;
    for (int pass = -1; pass < session_.options.repeat && failed == kFine; ++pass) {
      session_.watch.again();
      for (int s = 0; s < session_.states.count; ++s) {
        start_together();
        trace.begin();
        const int found = session_.solver.solve(session_.q(s), session_.v(s), session_.tau(s),
                                                session_.acceleration(s));
        session_.give_up_if_broken(found);
        trace.end(session_.comm(), pass >= 0);
        if (failed == kFine) failed = found;
      }
      MPI_Allreduce(MPI_IN_PLACE, &failed, 1, MPI_INT, MPI_MAX, session_.comm());
    }
    if (failed != kFine)
      return session_.complain(kInputAtFault, "random state: " + describe(failed));
    const std::string text = trace.text(session_.comm(), session_.channel_name(), session_.pinned);
    int status = kDone;
    if (session_.rank == 0) {
      std::ofstream file(session_.options.trace, std::ios::binary);
      if (!(file << text << std::flush))
        status = session_.complain(kFault, "cannot write the trace", session_.options.trace);
    }
    MPI_Bcast(&status, 1, MPI_INT, 0, session_.comm());
    return status;
  }

  // Nothing where nothing was timed.
  std::string json() const {
    if (evaluations_ == 0) return "";
    std::string text = ", \"time\": {\"source\": ";
    text += work_.empty() ? "\"clock\"" : "\"stretches\"";
    text += ", \"evaluations\": " + std::to_string(evaluations_);
    text += session_.pinned ? ", \"pinned\": true" : ", \"pinned\": false";
    text += figures("in_place", in_place_) + figures("through_root", at_root_);
    std::string each;
    for (const double ns : work_) each += (each.empty() ? "" : ", ") + whole(ns);
    if (!each.empty()) text += ", \"work_ns\": [" + each + "]";
    return text + batches_.json() + "}";
  }

  void print(std::FILE* out) const {
    if (evaluations_ == 0) return;
    std::fprintf(out, "time   %d process%s%s, ns per %s: median, minimum, 99th percentile\n",
                 kProcesses, kProcesses == 1 ? "" : "es", session_.pinned ? ", pinned" : "",
                 kBatch ? "state and process" : "evaluation");
    if (crowded_)
      std::fprintf(out, "       (%d cores for %d processes: a wall time %s)\n", cores_, kProcesses,
                   kBatch ? "says little" : "would mean nothing");
    if (!work_.empty())
      std::fprintf(out,
                   "       (from measured stretches of computing, one process at a time, played "
                   "through\n        with what messages cost: %.0f ns each and %.2f per number)\n",
                   hop().send + hop().latency, hop().number);
    std::fprintf(out, "       state and result in place       %8.0f %8.0f %8.0f\n",
                 in_place_.median, in_place_.least, in_place_.percentile99);
    std::fprintf(out, "       everything through process 0    %8.0f %8.0f %8.0f\n", at_root_.median,
                 at_root_.least, at_root_.percentile99);
    if (!work_.empty()) {
      std::fprintf(out, "       each process computes           ");
      for (const double ns : work_) std::fprintf(out, "%8.0f ", ns);
      std::fprintf(out, "\n");
    }
    batches_.print(out);
  }

 private:
  using Clock = std::chrono::steady_clock;

  // All processes start an evaluation at the same instant of their common clock; hosts have none.
  Clock::time_point start_together() const {
    if (kProcesses == 1) return Clock::now();
    if (!session_.solver.channel.on_one_host()) {
      MPI_Barrier(session_.comm());
      return Clock::now();
    }
    Clock::rep start = 0;
    if (session_.rank == 0)
      start = (Clock::now() + std::chrono::microseconds(5)).time_since_epoch().count();
    MPI_Bcast(&start, static_cast<int>(sizeof start), MPI_BYTE, 0, session_.comm());
    const Clock::time_point at{Clock::duration(start)};
    const Clock::time_point latest = Clock::now() + std::chrono::microseconds(50);
    Clock::time_point now;
    while ((now = Clock::now()) < at && now < latest) relax();
    return now;
  }

  static std::string whole(double ns) { return std::to_string(std::llround(ns)); }

  static std::string figures(const char* what, const Statistics& of) {
    return std::string(", \"") + what + "\": {\"median_ns\": " + whole(of.median) +
           ", \"min_ns\": " + whole(of.least) + ", \"p99_ns\": " + whole(of.percentile99) + "}";
  }

  const Hop& hop() const { return hop_of(session_.solver.channel); }

  Session& session_;
  int evaluations_ = 0;
  bool crowded_ = false;  // not a core for each process
  int cores_ = 0;
  Statistics in_place_, at_root_;
  BatchTiming batches_{session_};
  std::vector<double> work_;  // of each process, where times are from stretches
};

// --simulate: process 0 integrates, all processes evaluate. The torques of the initial state act
// all the time.
class Simulation {
 public:
  explicit Simulation(Session& session) : on_(session) {}

  // Collective.
  int run() {
    int status = start();
    MPI_Bcast(&status, 1, MPI_INT, 0, on_.comm());
    if (status != kDone) return status;
    status = kProcesses == 1 || on_.rank == 0 ? integrate() : serve();
    MPI_Bcast(&status, 1, MPI_INT, 0, on_.comm());
    return status;
  }

  // Nothing where nothing was simulated.
  std::string json() const {
    if (!done_) return "";
    char text[300];
    std::snprintf(text, sizeof text,
                  ", \"simulation\": {\"integrator\": \"%s\", \"step\": %.17g, \"seconds\": %.17g, "
                  "\"steps\": %lld, \"evaluations\": %lld, \"wall_s\": %.9g}",
                  asked().integrator->name, asked().step, asked().seconds, steps_, evaluations_,
                  wall_);
    return text;
  }

  void print() const {
    if (!done_) return;
    std::printf(
        "simulation  %s: %g s in %lld steps of %g s, %lld evaluations, %.3g s of wall time\n",
        asked().integrator->name, asked().seconds, steps_, asked().step, evaluations_, wall_);
  }

 private:
  using Clock = std::chrono::steady_clock;
  static constexpr const char* kSmaller = "; take a smaller --step";

  const SimulationOptions& asked() const { return on_.options.simulation; }

  // The initial state and the file to write; process 0's status counts.
  int start() {
    if (on_.options.states.empty()) {
      on_.use(random_states(1, on_.options.seed));
    } else {
      const int status = load(on_.options.states, on_.comm(), on_.rank, on_.states);
      if (status != kDone) return status;
      if (on_.states.count != 1)
        return on_.complain(
            kInputAtFault, std::to_string(on_.states.count) + " states; a simulation starts at one",
            on_.options.states);
    }
    const double steps = std::ceil(asked().seconds / asked().step * (1 - 1e-12));
    if (steps > 1e12) return on_.complain(kUsage, "--simulate: more than 1e12 steps");
    steps_ = std::max(1LL, static_cast<long long>(steps));
    if (on_.rank != 0) return kDone;
    const std::string& path = asked().trajectory;
    const double rows = static_cast<double>(steps_) / static_cast<double>(asked().every) + 2;
    if (Trajectory::is_npz(path) && rows * 8 * std::max(kNq, kNv) > Trajectory::kMostBytes)
      return on_.complain(kUsage,
                          "the trajectory has too many rows for .npz; say --every N or .csv");
    if (!trajectory_.open(path)) return on_.complain(kFault, "cannot write the trajectory", path);
    return kDone;
  }

  // Evaluates for process 0 until that says that it is over.
  int serve() {
    if (kProcess[static_cast<std::size_t>(on_.rank)].own.count == 0) return kDone;
    for (int status = kFine; failure_kind(status) != kEnded;) {
      status = on_.solver.solve_at_root(nullptr, nullptr, nullptr, nullptr);
      on_.give_up_if_broken(status);
      tick();
    }
    return kDone;
  }

  int integrate() {
    q_.assign(on_.q(0), on_.q(0) + kNq);
    v_.assign(on_.v(0), on_.v(0) + kNv);
    const Clock::time_point began = next_ = Clock::now();
    next_shown_ = began + std::chrono::seconds(1);
    std::string wrong = follow();
    wall_ = std::chrono::duration<double>(Clock::now() - began).count();
    if (told_) std::fputc('\n', stderr);
    on_.give_up_if_broken(on_.solver.end_at_root());
    if (!trajectory_.close())
      return on_.complain(kFault, "cannot write the trajectory", asked().trajectory);
    if (!wrong.empty()) return on_.complain(kInputAtFault, wrong, on_.options.states);
    done_ = true;
    return kDone;
  }

  // Takes all steps; returns an empty string, or what stopped it.
  std::string follow() {
    Stepper stepper;
    manifold::normalise(q_);
    trajectory_.record(0, q_, v_);
    for (long long k = 0; k < steps_; ++k) {
      const double time = static_cast<double>(k) * asked().step;
      const double next = k + 1 < steps_ ? time + asked().step : asked().seconds;
      const int failed = stepper.step(asked().integrator->kind, next - time, q_, v_,
                                      [this](const auto& q, const auto& v, const auto& extra,
                                             auto& a) { return accelerate(q, v, extra, a); });
      on_.give_up_if_broken(failed);
      if (failed != kFine) return describe(failed) + at(time) + (k > 0 ? kSmaller : "");
      slave(q_.data(), v_.data());
      const int joint = not_finite();
      if (joint >= 0)
        return "joint " + quoted(kJoints[joint].name) + ": its state is not finite" + at(next) +
               kSmaller;
      if ((k + 1) % asked().every == 0 || k + 1 == steps_) trajectory_.record(next, q_, v_);
      show(next);
    }
    return "";
  }

  static std::string at(double time) {
    char text[40];
    std::snprintf(text, sizeof text, ", at t = %.9g s", time);
    return text;
  }

  ADAGEN_HOT int accelerate(const manifold::State& q, const manifold::State& v,
                            const manifold::State& extra, manifold::State& a) {
    std::copy(q.begin(), q.end(), real_q_.begin());
    std::copy(v.begin(), v.end(), real_v_.begin());
    std::copy(on_.tau(0), on_.tau(0) + kNtau, real_tau_.begin());
    for (std::size_t k = 0; k < extra.size(); ++k)
      real_tau_[k] = static_cast<Number>(double(real_tau_[k]) + extra[k]);
    const int status =
        on_.solver.solve_at_root(real_q_.data(), real_v_.data(), real_tau_.data(), real_a_.data());
    std::copy(real_a_.begin(), real_a_.end(), a.begin());
    ++evaluations_;
    return status;
  }

  // The first joint whose state is not finite, or -1.
  int not_finite() const {
    const auto good = [](double x) { return std::isfinite(x); };
    for (int j = 0; j < kJointCount; ++j) {
      const auto q = q_.begin() + kJoints[j].q, v = v_.begin() + kJoints[j].v;
      if (!std::all_of(q, q + kJoints[j].nq, good) || !std::all_of(v, v + kJoints[j].nv, good))
        return j;
    }
    return -1;
  }

  // True about every tenth of a second; the watch hears of progress then.
  bool tick() {
    const Clock::time_point now = Clock::now();
    if (now < next_) return false;
    next_ = now + std::chrono::milliseconds(100);
    on_.watch.again();
    return true;
  }

  // Progress on stderr, on runs over a second: a bar that moves on a terminal, else a line every
  // ten seconds.
  void show(double time) {
    if (!tick() || next_ < next_shown_) return;
#if defined(__unix__) || defined(__APPLE__)
    const bool moves = isatty(STDERR_FILENO) != 0;
#else
    const bool moves = false;
#endif
    next_shown_ = next_ + std::chrono::seconds(moves ? 0 : 10);
    const double part = time / asked().seconds;
    std::string bar(30, ' ');
    std::fill_n(bar.begin(), static_cast<int>(30 * part), '#');
    std::fprintf(stderr, "%ssimulating [%s] %3.0f %%, %.4g of %g s%s", moves ? "\r" : "",
                 bar.c_str(), 100 * part, time, asked().seconds, moves ? "" : "\n");
    told_ = moves;
  }

  Session& on_;
  Trajectory trajectory_;
  manifold::State q_, v_;
  std::array<Number, kNq> real_q_{};
  std::array<Number, kNv> real_v_{}, real_a_{};
  std::array<Number, kNtau> real_tau_{};
  bool done_ = false, told_ = false;
  long long steps_ = 0, evaluations_ = 0;
  double wall_ = 0;
  Clock::time_point next_{}, next_shown_{};
};

// The sizes of the corrections of all states, for people and programs: errors before each step.
class Corrections {
 public:
  template <class AnySolver>
  void note([[maybe_unused]] const AnySolver& solver) {
    if constexpr (kRefine > 0)
      for (const double size : solver.w.refinement.corrections) sizes_.push_back(size);
  }

  // As a member of a JSON object, a comma before it; nothing without refinement.
  std::string json() const {
    if (sizes_.empty()) return "";
    std::string text = ", \"refine\": {\"steps\": " + std::to_string(kRefine);
    for (const double part : {0.5, 1.0}) {
      text += part < 1 ? ", \"correction_median\": [" : ", \"correction_max\": [";
      for (int k = 0; k < kRefine; ++k) text += (k == 0 ? "" : ", ") + number(at(k, part));
      text += "]";
    }
    return text + "}";
  }

  // The same of every state, for the result file.
  std::string every() const {
    if (sizes_.empty()) return "";
    std::string text = ", \"corrections\": [";
    for (std::size_t s = 0; s < sizes_.size(); s += kRefine) {
      text += s == 0 ? "[" : ", [";
      for (std::size_t k = 0; k < kRefine; ++k)
        text += (k == 0 ? "" : ", ") + number(sizes_[s + k]);
      text += "]";
    }
    return text + "]";
  }

  void print(std::FILE* out) const {
    if (sizes_.empty()) return;
    for (int k = 0; k < kRefine; ++k)
      std::fprintf(out, "refine error before step %d: median %.1e, largest %.1e\n", k + 1,
                   at(k, 0.5), at(k, 1));
  }

 private:
  // Of correction k, the least value that a part of all states does not exceed.
  double at(int k, double part) const {
    std::vector<double> of_step;
    for (std::size_t s = static_cast<std::size_t>(k); s < sizes_.size(); s += kRefine)
      of_step.push_back(sizes_[s]);
    std::sort(of_step.begin(), of_step.end());
    const double place = part * static_cast<double>(of_step.size() - 1);
    return of_step[static_cast<std::size_t>(place)];
  }

  // Infinity is no JSON number.
  static std::string number(double x) {
    char text[32];
    std::snprintf(text, sizeof text, "%.3g", x);
    return std::isfinite(x) ? text : "null";
  }

  std::vector<double> sizes_;
};

// The program around the solver: solves given states, checks, times, simulates, reports.

class Program {
 public:
  Program(Options options, int rank) : session_(std::move(options), rank) {}

  int run() {
    const Options& options = session_.options;
    session_.watch.start(session_.rank, options.time_limit);
    const std::string wrong = session_.solver.channel.open(MPI_COMM_WORLD, options.channel,
                                                           options.time_limit, options.hosts);
    if (!wrong.empty()) return session_.complain(kFault, wrong);
    int status = options.simulation.seconds > 0 ? simulation_.run() : answer();
    const auto also = [&status](bool asked, auto task) {
      if (!asked || status == kFault || status == kUsage) return;
      const int found = task();
      if (status == kDone) status = found;
    };
    also(options.time, [this] { return timing_.time_all(); });
    also(!options.trace.empty(), [this] { return timing_.trace_all(); });
    if (status != kFault) collect_warnings();
    if (session_.rank == 0 && status != kFault) report();
    session_.watch.again();
    session_.solver.channel.close();
    return status;
  }

 private:
  // Solves the given states, or random ones to be checked.
  int answer() {
    const Options& options = session_.options;
    int status = kDone;
    if (!options.states.empty()) {
      status = load(options.states, session_.comm(), session_.rank, session_.states);
      const bool loaded = status == kDone;
      if (loaded) status = solve_all();
      if ((status == kDone || (kBatch && loaded)) && session_.rank == 0) {
        const std::string path = options.result.empty() ? "/dev/stdout" : options.result;
        if (!write_result(path, session_.qdd, session_.states.count, corrections_.every()))
          status = session_.complain(kFault, "cannot write the result", path);
      }
      MPI_Bcast(&status, 1, MPI_INT, 0, session_.comm());
    } else if (options.check) {
      session_.states = random_states(kRandomStates, options.seed);
      status = solve_all();
    }
    session_.watch.again();
    if (status == kDone && options.check) status = check_all();
    return status;
  }

  // Accelerations of all states, in place, then gathered at process 0.
  int solve_all() {
    Session& on = session_;
    on.use(std::move(on.states));
    if constexpr (kBatch) return solve_many(on.solver);
    int failed = kFine, at = 0;
    for (int s = 0; s < on.states.count && failed == kFine; ++s) {
      on.watch.again();
      failed = on.solver.solve(on.q(s), on.v(s), on.tau(s), on.acceleration(s));
      on.give_up_if_broken(failed);
      corrections_.note(on.solver);
      // Processes that share no joint's motion do not hear of each other's failures by themselves.
      MPI_Allreduce(MPI_IN_PLACE, &failed, 1, MPI_INT, MPI_MAX, on.comm());
      at = s;
    }
    if (failed != kFine)
      return on.complain(kInputAtFault, "state " + std::to_string(at + 1) + ": " + describe(failed),
                         on.options.states);
    return bring_together();
  }

  // As many states at once as there are lanes. States that fail are named, all others solved.
  template <class S>
  int solve_many(S& solver) {
    constexpr int kNamed = 20;
    Session& on = session_;
    int status = kDone;
    if constexpr (kBatch) {
      on.give_up_if_broken(solver.solve_batch_at_root(on.states.count, on.q(0), on.v(0), on.tau(0),
                                                      on.acceleration(0)));
      solved_ = on.states.count;
      for (std::size_t k = 0; solver.failed_state(k) >= 0; ++k, --solved_) {
        status = kInputAtFault;
        if (k < kNamed) on.complain(status, solver.text, on.options.states);
        if (k == kNamed) on.complain(status, "and more states", on.options.states);
      }
    }
    MPI_Bcast(&status, 1, MPI_INT, 0, on.comm());
    return status;
  }

  int bring_together() {
    Session& on = session_;
    solved_ = on.states.count;
    // Each process wrote its own joints and left the others zero.
    void* const all = on.qdd.data();
    const int size = static_cast<int>(on.qdd.size());
    if (on.rank == 0)
      MPI_Reduce(MPI_IN_PLACE, all, size, kMpiNumber, MPI_SUM, 0, on.comm());
    else
      MPI_Reduce(all, nullptr, size, kMpiNumber, MPI_SUM, 0, on.comm());
    return kDone;
  }

  int check_all() {
    Session& on = session_;
    int status = kDone;
    if (on.rank == 0) {
      std::vector<double> residuals;
      for (int s = 0; s < on.states.count; ++s)
        residuals.push_back(check::residual(on.q(s), on.v(s), on.tau(s), on.acceleration(s)));
      std::sort(residuals.begin(), residuals.end());
      residual_median_ = residuals[residuals.size() / 2];
      residual_max_ = residuals.back();
      checked_ = true;
      if (!(residual_max_ <= on.options.tolerance)) status = kInputAtFault;
    }
    MPI_Bcast(&status, 1, MPI_INT, 0, on.comm());
    return status;
  }

  // What processes have met that costs digits but is no failure, told once.
  void collect_warnings() {
    int joint = near_lock(session_.solver, 0);
    MPI_Allreduce(MPI_IN_PLACE, &joint, 1, MPI_INT, MPI_MAX, session_.comm());
    if (joint == 0) return;
    warning_ = "joints " + names_of_run(joint - 1) +
               ": near gimbal lock at some state: accelerations lose three digits or more";
    if (session_.rank == 0) std::fprintf(stderr, "warning: %s\n", warning_.c_str());
  }

  // Shapes that join no runs of joints as one have nothing to tell.
  template <class S>
  static auto near_lock(const S& solver, int) -> decltype(solver.w.near_lock) {
    return solver.w.near_lock;
  }
  template <class S>
  static int near_lock(const S&, long) {
    return 0;
  }

  void report() const {
    const Options& options = session_.options;
    const bool right = residual_max_ <= options.tolerance;
    if (options.json) {
      std::printf("{\"model\": %s, \"processes\": %d, \"channel\": \"%s\"", quoted(kRobot).c_str(),
                  kProcesses, session_.channel_name());
      if (!options.states.empty() && options.simulation.seconds == 0)
        std::printf(", \"solved\": %d", solved_);
      if (!warning_.empty()) std::printf(", \"warnings\": [%s]", quoted(warning_.c_str()).c_str());
      if (checked_)
        std::printf(
            ", \"check\": {\"residual_median\": %.3g, \"residual_max\": %.3g, \"tolerance\": %.3g, "
            "\"ok\": %s}",
            residual_median_, residual_max_, options.tolerance, right ? "true" : "false");
      std::printf("%s%s%s}\n", corrections_.json().c_str(), timing_.json().c_str(),
                  simulation_.json().c_str());
      return;
    }
    std::FILE* const out = options.states.empty() || !options.result.empty() ? stdout : stderr;
    if (checked_)
      std::fprintf(out, "check  residual of inverse dynamics: median %.1e, largest %.1e: %s\n",
                   residual_median_, residual_max_, right ? "right" : "WRONG");
    corrections_.print(out);
    timing_.print(out);
    simulation_.print();
  }

  Session session_;
  Timing timing_{session_};
  Simulation simulation_{session_};
  Corrections corrections_;
  bool checked_ = false;
  int solved_ = 0;
  std::string warning_;
  double residual_median_ = 0, residual_max_ = 0;
};

}  // namespace

// Compiled for size, and with it what it alone calls: it runs once.
[[gnu::cold]] int main(int count, char** words) {
  Options options;
  const std::string wrong = parse(count, words, options);
  MPI_Init(&count, &words);
  int rank = 0, size = 0;
  MPI_Comm_rank(MPI_COMM_WORLD, &rank);
  MPI_Comm_size(MPI_COMM_WORLD, &size);
  int status = kDone;
  if (!wrong.empty() || (size != kProcesses && !options.help)) {
    status = kUsage;
    if (rank == 0 && !wrong.empty()) std::fprintf(stderr, "error: %s; see --help\n", wrong.c_str());
    else if (rank == 0)
      std::fprintf(stderr, "error: this solver is for exactly %d process%s, started with %d: use mpiexec -n %d\n",
                   kProcesses, kProcesses == 1 ? "" : "es", size, kProcesses);
  } else if (options.help) {
    if (rank == 0) std::printf("usage: mpiexec -n %d %s [options]\n%s", kProcesses, words[0], kUsageText);
  } else {
    status = std::make_unique<Program>(options, rank)->run();
  }
  MPI_Finalize();
  return status;
}
#endif  // ADAGEN_NO_MAIN
#endif  // ADAGEN_DECLARATIONS
