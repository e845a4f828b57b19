// Forward dynamics of "humanoid" on 2 processes, emitted by adagen 0.1.0 (solver.cpp.j2). Do not edit: emit anew.
//
// robot     "humanoid", 30 joints, 35 degrees of freedom, description sha256 d573a89307ddd4ee9018ee9a0a94422a3db0c5f61f2798648f53f0e1b57ee437
// options   form segment, shape unrolled, scalar double, channel auto, floating base, gravity 0.0, 0.0, -9.81
// program   2 processes, gathered at torso; 0.536 us predicted (default profile)
//           process 0: __base__ .. waist_pitch
//           process 1: left_shoulder_pitch .. right_wrist_pitch
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
  alignas(kCacheLine) std::array<Value, 17> angle{}, sine{}, cosine{};
  std::array<Value, kNv> result{};
  std::array<Real*, kPlanMessages> to{};          // messages to be sent
  std::array<const Real*, kPlanMessages> from{};  // messages received
  alignas(kCacheLine) std::array<Value, 199> x{};
};

// What straight lines of numbers need.
inline bool all(bool good, bool also = true) { return good && also; }

// Zero for finite numbers only: x - x is.
inline Real unlike_zero(const Real* x, int count) {
  Real sum = 0;
  for (int k = 0; k < count; ++k) sum += x[k] - x[k];
  return sum;
}

// Sine and cosine by the polynomials of fdlibm on [-pi/4, pi/4], after taking multiples of pi/2
// away in three parts. No branch: a loop over it is done in SIMD lanes.
inline void sine_and_cosine(double angle, double& sine, double& cosine) {
  constexpr double kRound = 6755399441055744.0;  // 1.5 * 2^52: adding it rounds to an integer
  const double n = (angle * 0.63661977236758134308 + kRound) - kRound;
  const double r = ((angle - n * 1.57079632673412561417e+00) - n * 6.07710050630396597660e-11) -
                   n * 2.02226624871116645580e-21;
  const double z = r * r, z2 = z * z, z4 = z2 * z2;
  const double s = r + r * z *
                           ((-1.66666666666666307295e-1 + z * 8.33333333332211858878e-3) +
                            z2 * (-1.98412698295895385996e-4 + z * 2.75573136213857245213e-6) +
                            z4 * (-2.50507477628578072866e-8 + z * 1.58962301576546568060e-10));
  const double c =
      (1 - 0.5 * z) + z2 * ((4.16666666666665929218e-2 - z * 1.38888888888730564116e-3) +
                            z2 * (2.48015872888517045348e-5 - z * 2.75573141792967388112e-7) +
                            z4 * (2.08757008419747316778e-9 - z * 1.13585365213876817300e-11));
  const double half = std::floor(n * 0.5), odd = n - 2 * half;
  const double sign = 1 - 2 * (half - 2 * std::floor(half * 0.5));
  sine = sign * (odd != 0 ? c : s);
  cosine = sign * (odd != 0 ? -s : c);
}

template <int count>
inline void take_sines_and_cosines(const Real* angle, Real* sine, Real* cosine) {
  constexpr double kFar = 1e5;  // beyond, the three parts of pi/2 would lose digits
  Real farthest = 0;
  for (int k = 0; k < count; ++k) {
    double s, c;
    sine_and_cosine(angle[k], s, c);
    sine[k] = Real(s), cosine[k] = Real(c);
  }
  for (int k = 0; k < count; ++k) farthest = std::max(farthest, std::abs(angle[k]));
  if (farthest <= kFar) return;
  for (int k = 0; k < count; ++k) sine[k] = std::sin(angle[k]), cosine[k] = std::cos(angle[k]);
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

// Each function is a straight line. A value is called x and its number in the expression graph; zeros
// and constants are folded in, nothing is computed twice, and what nobody needs is not there.
// Frames are the links' own; accelerations are deviations from the field that the links would have
// with all joint accelerations zero.

// =================================================================================================
// Process 0: 1834 products, 1622 sums, 20 quotients
// =================================================================================================

ADAGEN_NOINLINE void part_0_0(Workspace& w) {
  ADAGEN_INPUTS
  // joint 0 "__base__": placement, velocity and reference acceleration of its link
  const Real x68 = v[3] * v[3];
  const Real x73 = v[3] * v[4];
  const Real x76 = v[4] * v[5];
  const Real x77 = x68 + v[4] * v[4];
  const Real x79 = v[3] * v[5];
  // joint 1 "left_hip_pitch": placement, velocity and reference acceleration of its link
  const Real x89 = v[5] * cosine[0] + v[3] * sine[0];
  const Real x93 = v[3] * cosine[0] - v[5] * sine[0];
  const Real x94 = v[4] + v[6];
  const Real x95 = v[6] * x93;
  const Real x96 = v[6] * x89;
  const Real x98 = x73 * 0.09;
  const Real x100 = x79 * 0.05;
  const Real x102 = x98 - x100;
  const Real x103 = (x68 + v[5] * v[5]) * 0.09;
  const Real x105 = x76 * 0.05;
  const Real x107 = x103 + x105;
  const Real x109 = x76 * 0.09;
  const Real x110 = x77 * 0.05;
  const Real x112 = x109 + x110;
  const Real x115 = cosine[0] * x112 + sine[0] * x102;
  const Real x119 = cosine[0] * x102 - sine[0] * x112;
  const Real x131 = x93 * x94;
  const Real x132 = x131 - x95;
  const Real x134 = x89 * x89 + x93 * x93;
  const Real x136 = x89 * x94;
  const Real x138 = x136 - x96;
  // link 2 "left_hip": force that the reference field takes
  const Real x1096 = x95 * 0.00308 - x131 * 0.0013299999999999998 - x119 * 0.041999999999999996;
  w.x[0] = x1096;
  const Real x1098 = x136 * 0.0013299999999999998 - x96 * 0.00308 + x115 * 0.041999999999999996;
  w.x[1] = x1098;
  const Real x1101 = x115 * 1.4 + x138 * 0.041999999999999996;
  w.x[2] = x1101;
  const Real x1104 = x119 * 1.4 + x132 * 0.041999999999999996;
  w.x[3] = x1104;
  const Real x1109 = x107 * 1.4 + x134 * 0.041999999999999996;
  w.x[4] = x1109;
  // joint 2 "left_hip_roll": placement, velocity and reference acceleration of its link
  const Real x147 = x94 * cosine[1] + x89 * sine[1];
  const Real x151 = x89 * cosine[1] - x94 * sine[1];
  const Real x152 = x93 + v[7];
  const Real x156 = x95 * sine[1] + v[7] * x151;
  const Real x159 = x95 * cosine[1] - v[7] * x147;
  const Real x161 = x115 + x138 * 0.04;
  const Real x163 = x119 + x132 * 0.04;
  const Real x166 = x107 + x134 * 0.04;
  const Real x171 = sine[1] * x161 - cosine[1] * x166;
  const Real x175 = sine[1] * x166 + cosine[1] * x161;
  const Real x178 = x147 * x147;
  const Real x183 = x147 * x151;
  const Real x184 = x96 + x183;
  const Real x186 = x178 + x152 * x152;
  const Real x188 = x151 * x152;
  const Real x190 = x156 + x188;
  const Real x191 = x178 + x151 * x151;
  const Real x193 = x147 * x152;
  const Real x195 = x159 + x193;
  // link 3 "left_groin": force that the reference field takes
  const Real x1131 = x156 * 0.00379 + x188 * 0.0015500000000000002;
  const Real x1155 = 0.00096 * (x191 - x186) + x1131 - x163 * 0.048;
  const Real x1156 = x1155 - x175 * 0.024;
  w.x[5] = x1156;
  const Real x1140 = x159 * 0.00187 + x193 * 0.00036999999999999994 - x184 * 0.00096;
  const Real x1158 = x1140 + x171 * 0.024;
  w.x[6] = x1158;
  const Real x1150 = x195 * 0.00096 - (x96 * 0.00342 + x183 * 0.00192);
  const Real x1161 = x1150 + x171 * 0.048;
  w.x[7] = x1161;
  const Real x1167 = x195 * 0.024 - x184 * 0.048 + x171 * 1.2;
  w.x[8] = x1167;
  const Real x1172 = x186 * 0.048 + (x188 - x156) * 0.024;
  const Real x1173 = x175 * 1.2 + x1172;
  w.x[9] = x1173;
  const Real x1180 = x163 * 1.2 - x191 * 0.024 - x190 * 0.048;
  w.x[10] = x1180;
  // joint 3 "left_hip_yaw": placement, velocity and reference acceleration of its link
  const Real x204 = x152 * cosine[2] + x147 * sine[2];
  const Real x208 = x147 * cosine[2] - x152 * sine[2];
  const Real x209 = x151 + v[8];
  const Real x219 = x156 * sine[2] - x96 * cosine[2] + v[8] * x208;
  const Real x222 = x96 * sine[2] + x156 * cosine[2] - v[8] * x204;
  const Real x226 = x171 - x184 * 0.12;
  const Real x229 = x175 + x186 * 0.12;
  const Real x232 = x163 - x190 * 0.12;
  const Real x235 = cosine[2] * x232 + sine[2] * x226;
  const Real x239 = cosine[2] * x226 - sine[2] * x232;
  const Real x252 = x208 * x209;
  const Real x253 = x252 - x219;
  const Real x255 = x204 * x204 + x208 * x208;
  const Real x257 = x204 * x209;
  const Real x259 = x222 + x257;
  // link 4 "left_thigh": force that the reference field takes
  const Real x1200 = x159 * 0.00468;
  w.x[11] = x1200;
  const Real x1204 = x219 * 0.0429867 - x252 * 0.038306700000000006 + x239 * 0.26;
  w.x[12] = x1204;
  const Real x1207 = x222 * 0.0429867 + x257 * 0.038306700000000006 - x235 * 0.26;
  w.x[13] = x1207;
  const Real x1211 = x235 * 2.6 - x259 * 0.26;
  w.x[14] = x1211;
  const Real x1215 = x239 * 2.6 - x253 * 0.26;
  w.x[15] = x1215;
  const Real x1219 = x229 * 2.6 + x255 * 0.26;
  w.x[16] = x1219;
  // joint 4 "left_knee": placement, velocity and reference acceleration of its link
  const Real x268 = x209 * cosine[3] + x204 * sine[3];
  const Real x272 = x204 * cosine[3] - x209 * sine[3];
  const Real x273 = x208 + v[9];
  const Real x282 = x159 * cosine[3] + x219 * sine[3] + v[9] * x272;
  const Real x285 = x219 * cosine[3] - x159 * sine[3] - v[9] * x268;
  const Real x289 = x235 - x259 * 0.24;
  const Real x292 = x239 - x253 * 0.24;
  const Real x295 = x229 + x255 * 0.24;
  const Real x298 = cosine[3] * x295 + sine[3] * x289;
  const Real x302 = cosine[3] * x289 - sine[3] * x295;
  const Real x307 = x273 * x273;
  const Real x308 = x272 * x272 + x307;
  const Real x310 = x268 * x272;
  const Real x312 = x222 + x310;
  const Real x313 = x268 * x268 + x307;
  const Real x315 = x272 * x273;
  const Real x317 = x282 + x315;
  const Real x320 = x268 * x273;
  const Real x321 = x320 - x285;
  // link 5 "left_shank": force that the reference field takes
  const Real x1256 = x222 * 0.043271300000000006 + x310 * 0.0410888;
  const Real x1241 = x282 * 0.0020025 + x315 * 0.00018 - x321 * 0.00234;
  const Real x1259 = x1241 + x292 * 0.018000000000000002;
  w.x[17] = x1259;
  const Real x1250 = x285 * 0.043091300000000006 - x320 * 0.0412688 + x317 * 0.00234;
  const Real x1262 = x1250 + x292 * 0.234;
  w.x[18] = x1262;
  const Real x1267 = 0.00234 * (x313 - x308) + x1256 - x302 * 0.234;
  const Real x1268 = x1267 - x298 * 0.018000000000000002;
  w.x[19] = x1268;
  const Real x1273 = x308 * 0.234 + (x310 - x222) * 0.018000000000000002;
  const Real x1274 = x298 * 1.8 + x1273;
  w.x[20] = x1274;
  const Real x1282 = x302 * 1.8 - (x312 * 0.234 + x313 * 0.018000000000000002);
  w.x[21] = x1282;
  const Real x1288 = x292 * 1.8 - x321 * 0.234 + x317 * 0.018000000000000002;
  w.x[22] = x1288;
  // joint 5 "left_ankle_pitch": placement, velocity and reference acceleration of its link
  const Real x331 = x268 * cosine[4] + x272 * sine[4];
  const Real x335 = x272 * cosine[4] - x268 * sine[4];
  const Real x336 = x273 + v[10];
  const Real x345 = x282 * cosine[4] + x285 * sine[4] + v[10] * x335;
  const Real x348 = x285 * cosine[4] - x282 * sine[4] - v[10] * x331;
  const Real x352 = x298 + x308 * 0.3;
  const Real x355 = x302 - x312 * 0.3;
  const Real x358 = x292 - x321 * 0.3;
  const Real x361 = cosine[4] * x352 + sine[4] * x355;
  const Real x365 = cosine[4] * x355 - sine[4] * x352;
  // link 6 "left_ankle": force that the reference field takes
  const Real x1291 = x345 * 7.2e-05;
  w.x[23] = x1291;
  const Real x1293 = x348 * 7.2e-05;
  w.x[24] = x1293;
  const Real x1295 = x222 * 7.2e-05;
  w.x[25] = x1295;
  const Real x1297 = x361 * 0.2;
  w.x[26] = x1297;
  const Real x1298 = x365 * 0.2;
  w.x[27] = x1298;
  const Real x1299 = x358 * 0.2;
  w.x[28] = x1299;
  // joint 6 "left_ankle_roll": placement, velocity and reference acceleration of its link
  const Real x395 = x336 * cosine[5] + x331 * sine[5];
  const Real x399 = x331 * cosine[5] - x336 * sine[5];
  const Real x400 = x335 + v[11];
  const Real x409 = x222 * cosine[5] + x345 * sine[5] + v[11] * x399;
  const Real x412 = x345 * cosine[5] - x222 * sine[5] - v[11] * x395;
  const Real x416 = x361 + (x335 * x335 + x336 * x336) * 0.02;
  const Real x419 = x365 - (x222 + x331 * x335) * 0.02;
  const Real x422 = x358 - (x331 * x336 - x348) * 0.02;
  const Real x425 = cosine[5] * x422 + sine[5] * x416;
  const Real x429 = cosine[5] * x416 - sine[5] * x422;
  const Real x432 = x395 * x395;
  const Real x437 = x395 * x399;
  const Real x438 = x437 - x348;
  const Real x440 = x432 + x400 * x400;
  const Real x442 = x399 * x400;
  const Real x445 = x432 + x399 * x399;
  const Real x447 = x395 * x400;
  const Real x449 = x412 + x447;
  // link 7 "left_foot": force that the reference field takes
  const Real x1319 = 0.0007199999999999999 * (x445 - x440) - x442 * 0.002606663;
  const Real x1342 = x409 * 0.00416667 + x1319 - x419 * 0.024;
  const Real x1343 = x1342 - x429 * 0.024;
  w.x[29] = x1343;
  const Real x1344 = x425 * 0.024;
  const Real x1328 = x447 * 0.002960003 - x438 * 0.0007199999999999999 + x412 * 0.00381333;
  const Real x1345 = x1328 + x1344;
  w.x[30] = x1345;
  const Real x1337 = x348 * 0.001206667 - x437 * 0.00035334 + x449 * 0.0007199999999999999;
  const Real x1347 = x1337 + x1344;
  w.x[31] = x1347;
  const Real x1353 = x449 * 0.024 - x438 * 0.024 + x425 * 0.8;
  w.x[32] = x1353;
  const Real x1358 = x440 * 0.024 + (x442 - x409) * 0.024;
  const Real x1359 = x429 * 0.8 + x1358;
  w.x[33] = x1359;
  const Real x1365 = x419 * 0.8 - x445 * 0.024;
  const Real x1366 = x1365 - (x409 + x442) * 0.024;
  w.x[34] = x1366;
  // joint 7 "right_hip_pitch": placement, velocity and reference acceleration of its link
  const Real x458 = v[5] * cosine[6] + v[3] * sine[6];
  const Real x462 = v[3] * cosine[6] - v[5] * sine[6];
  const Real x463 = v[4] + v[12];
  const Real x464 = v[12] * x462;
  const Real x465 = v[12] * x458;
  const Real x468 = x98 + x100;
  const Real x470 = x103 - x105;
  const Real x472 = x110 - x109;
  const Real x476 = cosine[6] * x472 - sine[6] * x468;
  const Real x481 = sine[6] * x472 + cosine[6] * x468;
  const Real x493 = x462 * x463;
  const Real x494 = x493 - x464;
  const Real x496 = x458 * x458 + x462 * x462;
  const Real x498 = x458 * x463;
  const Real x500 = x498 - x465;
  // link 8 "right_hip": force that the reference field takes
  const Real x1380 = x464 * 0.00308 - x493 * 0.0013299999999999998 - x481 * 0.041999999999999996;
  w.x[35] = x1380;
  const Real x1383 = x498 * 0.0013299999999999998 - x465 * 0.00308 - x476 * 0.041999999999999996;
  w.x[36] = x1383;
  const Real x1387 = x476 * 1.4 - x500 * 0.041999999999999996;
  w.x[37] = x1387;
  const Real x1392 = x481 * 1.4 + x494 * 0.041999999999999996;
  w.x[38] = x1392;
  const Real x1397 = x470 * 1.4 + x496 * 0.041999999999999996;
  w.x[39] = x1397;
  // joint 8 "right_hip_roll": placement, velocity and reference acceleration of its link
  const Real x509 = x463 * cosine[7] + x458 * sine[7];
  const Real x513 = x458 * cosine[7] - x463 * sine[7];
  const Real x514 = x462 + v[13];
  const Real x518 = x464 * sine[7] + v[13] * x513;
  const Real x521 = x464 * cosine[7] - v[13] * x509;
  const Real x524 = x476 - 0.04 * x500;
  const Real x527 = x481 + 0.04 * x494;
  const Real x531 = x470 + 0.04 * x496;
  const Real x534 = cosine[7] * x531 + sine[7] * x524;
  const Real x538 = cosine[7] * x524 - sine[7] * x531;
  const Real x541 = x509 * x509;
  const Real x546 = x509 * x513;
  const Real x547 = x465 + x546;
  const Real x549 = x541 + x514 * x514;
  const Real x551 = x513 * x514;
  const Real x553 = x518 + x551;
  const Real x554 = x541 + x513 * x513;
  const Real x556 = x509 * x514;
  const Real x558 = x521 + x556;
  // link 9 "right_groin": force that the reference field takes
  const Real x1402 = x518 * 0.00379 + x551 * 0.0015500000000000002;
  const Real x1424 = 0.00096 * (x554 - x549) + x1402 + x527 * 0.048;
  const Real x1425 = x1424 - x538 * 0.024;
  w.x[40] = x1425;
  const Real x1410 = x521 * 0.00187 + x556 * 0.00036999999999999994 - x547 * 0.00096;
  const Real x1427 = x1410 + x534 * 0.024;
  w.x[41] = x1427;
  const Real x1419 = x558 * 0.00096 - (x465 * 0.00342 + x546 * 0.00192);
  const Real x1430 = x1419 + x534 * 0.048;
  w.x[42] = x1430;
  const Real x1436 = x558 * 0.024 - x547 * 0.048 + x534 * 1.2;
  w.x[43] = x1436;
  const Real x1441 = x549 * 0.048 + (x551 - x518) * 0.024;
  const Real x1442 = x538 * 1.2 + x1441;
  w.x[44] = x1442;
  const Real x1451 = x527 * 1.2 + x554 * 0.024 + x553 * 0.048;
  w.x[45] = x1451;
  // joint 9 "right_hip_yaw": placement, velocity and reference acceleration of its link
  const Real x566 = x514 * cosine[8] + x509 * sine[8];
  const Real x570 = x509 * cosine[8] - x514 * sine[8];
  const Real x571 = x513 + v[14];
  const Real x581 = x518 * sine[8] - x465 * cosine[8] + v[14] * x570;
  const Real x584 = x465 * sine[8] + x518 * cosine[8] - v[14] * x566;
  const Real x587 = x534 - 0.12 * x547;
  const Real x590 = x538 + 0.12 * x549;
  const Real x593 = x527 + 0.12 * x553;
  const Real x598 = sine[8] * x587 - cosine[8] * x593;
  const Real x602 = sine[8] * x593 + cosine[8] * x587;
  const Real x615 = x570 * x571;
  const Real x616 = x615 - x581;
  const Real x618 = x566 * x566 + x570 * x570;
  const Real x620 = x566 * x571;
  const Real x622 = x584 + x620;
  // link 10 "right_thigh": force that the reference field takes
  const Real x1462 = x521 * 0.00468;
  w.x[46] = x1462;
  const Real x1466 = x581 * 0.0429867 - x615 * 0.038306700000000006 + x602 * 0.26;
  w.x[47] = x1466;
  const Real x1469 = x584 * 0.0429867 + x620 * 0.038306700000000006 - x598 * 0.26;
  w.x[48] = x1469;
  const Real x1473 = x598 * 2.6 - x622 * 0.26;
  w.x[49] = x1473;
  const Real x1477 = x602 * 2.6 - x616 * 0.26;
  w.x[50] = x1477;
  const Real x1481 = x590 * 2.6 + x618 * 0.26;
  w.x[51] = x1481;
  // joint 10 "right_knee": placement, velocity and reference acceleration of its link
  const Real x630 = x571 * cosine[9] + x566 * sine[9];
  const Real x634 = x566 * cosine[9] - x571 * sine[9];
  const Real x635 = x570 + v[15];
  const Real x644 = x521 * cosine[9] + x581 * sine[9] + v[15] * x634;
  const Real x647 = x581 * cosine[9] - x521 * sine[9] - v[15] * x630;
  const Real x650 = x598 - 0.24 * x622;
  const Real x653 = x602 - 0.24 * x616;
  const Real x656 = x590 + 0.24 * x618;
  const Real x659 = cosine[9] * x656 + sine[9] * x650;
  const Real x663 = cosine[9] * x650 - sine[9] * x656;
  const Real x668 = x635 * x635;
  const Real x669 = x634 * x634 + x668;
  const Real x671 = x630 * x634;
  const Real x673 = x584 + x671;
  const Real x674 = x630 * x630 + x668;
  const Real x676 = x634 * x635;
  const Real x678 = x644 + x676;
  const Real x681 = x630 * x635;
  const Real x682 = x681 - x647;
  // link 11 "right_shank": force that the reference field takes
  const Real x1500 = x584 * 0.043271300000000006 + x671 * 0.0410888;
  const Real x1488 = x644 * 0.0020025 + x676 * 0.00018 - x682 * 0.00234;
  const Real x1503 = x1488 + x653 * 0.018000000000000002;
  w.x[52] = x1503;
  const Real x1495 = x647 * 0.043091300000000006 - x681 * 0.0412688 + x678 * 0.00234;
  const Real x1506 = x1495 + x653 * 0.234;
  w.x[53] = x1506;
  const Real x1511 = 0.00234 * (x674 - x669) + x1500 - x663 * 0.234;
  const Real x1512 = x1511 - x659 * 0.018000000000000002;
  w.x[54] = x1512;
  const Real x1517 = x669 * 0.234 + (x671 - x584) * 0.018000000000000002;
  const Real x1518 = x659 * 1.8 + x1517;
  w.x[55] = x1518;
  const Real x1526 = x663 * 1.8 - (x673 * 0.234 + x674 * 0.018000000000000002);
  w.x[56] = x1526;
  const Real x1532 = x653 * 1.8 - x682 * 0.234 + x678 * 0.018000000000000002;
  w.x[57] = x1532;
  // joint 11 "right_ankle_pitch": placement, velocity and reference acceleration of its link
  const Real x691 = x630 * cosine[10] + x634 * sine[10];
  const Real x695 = x634 * cosine[10] - x630 * sine[10];
  const Real x696 = x635 + v[16];
  const Real x705 = x644 * cosine[10] + x647 * sine[10] + v[16] * x695;
  const Real x708 = x647 * cosine[10] - x644 * sine[10] - v[16] * x691;
  const Real x711 = x659 + 0.3 * x669;
  const Real x714 = x663 - 0.3 * x673;
  const Real x717 = x653 - 0.3 * x682;
  const Real x720 = cosine[10] * x711 + sine[10] * x714;
  const Real x724 = cosine[10] * x714 - sine[10] * x711;
  // joint 12 "right_ankle_roll": placement, velocity and reference acceleration of its link
  const Real x753 = x696 * cosine[11] + x691 * sine[11];
  const Real x757 = x691 * cosine[11] - x696 * sine[11];
  const Real x758 = x695 + v[17];
  const Real x767 = x584 * cosine[11] + x705 * sine[11] + v[17] * x757;
  const Real x770 = x705 * cosine[11] - x584 * sine[11] - v[17] * x753;
  const Real x773 = x720 + 0.02 * (x695 * x695 + x696 * x696);
  const Real x776 = x724 - 0.02 * (x584 + x691 * x695);
  const Real x779 = x717 - 0.02 * (x691 * x696 - x708);
  const Real x782 = cosine[11] * x779 + sine[11] * x773;
  const Real x786 = cosine[11] * x773 - sine[11] * x779;
  const Real x789 = x753 * x753;
  const Real x794 = x753 * x757;
  const Real x795 = x794 - x708;
  const Real x797 = x789 + x758 * x758;
  const Real x799 = x757 * x758;
  const Real x802 = x789 + x757 * x757;
  const Real x804 = x753 * x758;
  const Real x806 = x770 + x804;
  // link 13 "right_foot": force that the reference field takes
  const Real x1547 = 0.0007199999999999999 * (x802 - x797) - x799 * 0.002606663;
  const Real x1567 = x767 * 0.00416667 + x1547 - x776 * 0.024;
  const Real x1568 = x1567 - x786 * 0.024;
  const Real x1569 = x782 * 0.024;
  const Real x1555 = x804 * 0.002960003 - x795 * 0.0007199999999999999 + x770 * 0.00381333;
  const Real x1562 = x708 * 0.001206667 - x794 * 0.00035334 + x806 * 0.0007199999999999999;
  const Real x1583 = x797 * 0.024 + (x799 - x767) * 0.024;
  const Real x1584 = x786 * 0.8 + x1583;
  const Real x1590 = x776 * 0.8 - x802 * 0.024;
  const Real x1591 = x1590 - (x767 + x799) * 0.024;
  // joint 13 "waist_yaw": placement, velocity and reference acceleration of its link
  const Real x814 = v[3] * cosine[12] + v[4] * sine[12];
  const Real x818 = v[4] * cosine[12] - v[3] * sine[12];
  const Real x819 = v[5] + v[18];
  const Real x820 = v[18] * x818;
  const Real x821 = v[18] * x814;
  const Real x823 = x79 * 0.09;
  const Real x824 = x77 * 0.09;
  const Real x828 = cosine[12] * x823 + x109 * sine[12];
  const Real x832 = x109 * cosine[12] - sine[12] * x823;
  const Real x844 = x818 * x819;
  const Real x845 = x844 - x820;
  const Real x847 = x814 * x814 + x818 * x818;
  const Real x849 = x814 * x819;
  const Real x851 = x849 - x821;
  // link 14 "waist_link": force that the reference field takes
  const Real x1032 = x820 * 0.00106 - x844 * 6e-05 - x832 * 0.016;
  w.x[58] = x1032;
  const Real x1034 = x849 * 6e-05 - x821 * 0.00106 + x828 * 0.016;
  w.x[59] = x1034;
  const Real x1037 = x828 * 0.8 + x851 * 0.016;
  w.x[60] = x1037;
  const Real x1040 = x832 * 0.8 + x845 * 0.016;
  w.x[61] = x1040;
  const Real x1045 = x824 * 0.8 + x847 * 0.016;
  w.x[62] = x1045;
  // joint 14 "waist_roll": placement, velocity and reference acceleration of its link
  const Real x859 = x818 * cosine[13] + x819 * sine[13];
  const Real x863 = x819 * cosine[13] - x818 * sine[13];
  const Real x864 = x814 + v[19];
  const Real x870 = v[19] * x863 - x821 * cosine[13];
  const Real x875 = x828 + 0.05 * x851;
  const Real x877 = x832 + 0.05 * x845;
  const Real x880 = x824 + 0.05 * x847;
  const Real x885 = cosine[13] * x877 - sine[13] * x880;
  const Real x899 = x859 * x863;
  const Real x904 = x863 * x864;
  // link 15 "abdomen": force that the reference field takes
  const Real x985 = (x821 * sine[13] - v[19] * x859) * 0.001125;
  w.x[63] = x985;
  const Real x994 = x870 * 0.0014025 + x904 * 0.00027750000000000013 + x875 * 0.018000000000000002;
  w.x[64] = x994;
  const Real x997 = x820 * 0.0014025 - x899 * 0.00027750000000000013 - x885 * 0.018000000000000002;
  w.x[65] = x997;
  const Real x1000 = x885 * 0.9 + (x899 - x820) * 0.018000000000000002;
  w.x[66] = x1000;
  const Real x1001 = (sine[13] * x877 + cosine[13] * x880) * 0.9;
  const Real x1005 = x1001 + (x859 * x859 + x864 * x864) * 0.018000000000000002;
  w.x[67] = x1005;
  const Real x1009 = x875 * 0.9 + (x870 + x904) * 0.018000000000000002;
  w.x[68] = x1009;
  // joint 0 "__base__": its torque on the base
  const Real x1598 = x79 * 0.12400000000000001 - tau[0];
  w.x[69] = x1598;
  const Real x1599 = x76 * 0.12400000000000001 - tau[1];
  w.x[70] = x1599;
  const Real x1600 = x77 * 0.12400000000000001 + tau[2];
  w.x[71] = x1600;
  const Real x1602 = x76 * 0.015086599999999999 - tau[3];
  w.x[72] = x1602;
  const Real x1603 = x79 * 0.00020659999999999716 + tau[4];
  w.x[73] = x1603;
  const Real x1605 = x73 * 0.01488 + tau[5];
  w.x[74] = x1605;
  // joint 12 "right_ankle_roll": articulated-body inertia and bias force through it
  const Real x1610 = 828.7290528372782 * (tau[17] - (x1562 + x1569));
  w.x[75] = x1610;
  const Real x1623 = x1555 + x1569 + 0.0007199999999999999 * x1610;
  // link 13 "right_foot": force that the reference field takes
  const Real x1578 = x806 * 0.024 - x795 * 0.024 + x782 * 0.8;
  // joint 12 "right_ankle_roll": articulated-body inertia and bias force through it
  const Real x1625 = x1578 + 0.024 * x1610;
  const Real x1626 = cosine[11] * 0.024;
  const Real x1628 = sine[11] * 0.024;
  const Real x1630 = sine[11] * 0.014320438033028168;
  const Real x1632 = sine[11] * x1630;
  const Real x1634 = -0.024 + x1632;
  const Real x1635 = 0.009679561966971832 + x1632;
  const Real x1636 = cosine[11] * x1630;
  const Real x1639 = cosine[11] * 0.000782953140990845;
  const Real x1644 = cosine[11] * x1639;
  const Real x1647 = cosine[11] * 0.47734793443427226;
  const Real x1649 = sine[11] * x1647;
  const Real x1651 = cosine[11] * x1647;
  const Real x1653 = 0.8 - x1651;
  const Real x1657 = -0.016 - x1626;
  const Real x1658 = 0.02 * x1653;
  const Real x1664 = sine[11] * x1639 + 0.02 * x1628;
  const Real x1667 = 0.02 * x1636;
  const Real x1685 = cosine[11] * x1625 - sine[11] * x1584;
  const Real x1674 = 0.003383716859009155 + x1644 + 0.02 * x1626 - 0.02 * x1657;
  const Real x1697 = 7.2e-05 + x1674;
  require_more(w, x1697, 0.0, kFactorization, 11);
  const Real x1694 = cosine[11] * x1568 - sine[11] * x1623 - 0.02 * x1591;
  // joint 11 "right_ankle_pitch": articulated-body inertia and bias force through it
  const Real x1708 = 1 / x1697;
  const Real x1710 = x1708 * (tau[16] - (x584 * 7.2e-05 + x1694));
  w.x[76] = x1710;
  const Real x1711 = x1664 * x1708;
  w.x[77] = x1711;
  const Real x1712 = x1667 * x1708;
  w.x[78] = x1712;
  const Real x1713 = x1634 * x1708;
  w.x[79] = x1713;
  const Real x1714 = x1657 * x1708;
  w.x[80] = x1714;
  const Real x1715 = x1636 * x1708;
  w.x[81] = x1715;
  const Real x1718 = 0.00416667 - x1644 + 7.2e-05 - x1664 * x1711;
  w.x[82] = x1718;
  const Real x1721 = 0.02 * x1635 - x1664 * x1712;
  w.x[83] = x1721;
  const Real x1724 = x1636 + x1664 * x1713;
  const Real x1728 = x1628 + x1664 * x1714;
  const Real x1732 = x1635 - x1664 * x1715;
  const Real x1735 = 7.2e-05 + 0.02 * x1658 - x1667 * x1712;
  w.x[84] = x1735;
  const Real x1738 = 0.02 * x1649 + x1667 * x1713;
  const Real x1740 = x1667 * x1714;
  const Real x1744 = x1658 - x1667 * x1715;
  const Real x1747 = 0.3226520655657278 + x1651 + 0.2 - x1634 * x1713;
  w.x[85] = x1747;
  const Real x1748 = x1634 * x1714;
  w.x[86] = x1748;
  const Real x1752 = x1649 + x1634 * x1715;
  w.x[87] = x1752;
  const Real x1756 = 1.0 - x1657 * x1714;
  w.x[88] = x1756;
  const Real x1757 = x1657 * x1715;
  w.x[89] = x1757;
  const Real x1761 = 0.2 + x1653 - x1636 * x1715;
  w.x[90] = x1761;
  // joint 12 "right_ankle_roll": articulated-body inertia and bias force through it
  const Real x1701 = sine[11] * x1568 + cosine[11] * x1623 + x705 * 7.2e-05;
  // joint 11 "right_ankle_pitch": articulated-body inertia and bias force through it
  const Real x1763 = x1701 + x1664 * x1710;
  w.x[91] = x1763;
  // joint 12 "right_ankle_roll": articulated-body inertia and bias force through it
  const Real x1702 = tau[17] + 0.02 * x1685 + x708 * 7.2e-05;
  // joint 11 "right_ankle_pitch": articulated-body inertia and bias force through it
  const Real x1765 = x1702 + x1667 * x1710;
  w.x[92] = x1765;
  // joint 12 "right_ankle_roll": articulated-body inertia and bias force through it
  const Real x1704 = sine[11] * x1625 + cosine[11] * x1584 + x720 * 0.2;
  // joint 11 "right_ankle_pitch": articulated-body inertia and bias force through it
  const Real x1767 = x1704 + x1634 * x1710;
  w.x[93] = x1767;
  const Real x1769 = x724 * 0.2 + x1591 + x1657 * x1710;
  w.x[94] = x1769;
  const Real x1771 = x717 * 0.2 + x1685 + x1636 * x1710;
  w.x[95] = x1771;
  const Real x1775 = cosine[10] * x1732 - sine[10] * x1744;
  w.x[96] = x1775;
  const Real x1778 = sine[10] * x1732 + cosine[10] * x1744;
  w.x[97] = x1778;
  const Real x1785 = cosine[10] * (x1740 - x1724) + sine[10] * (x1728 + x1738);
  const Real x1786 = sine[10] * x1785;
  const Real x1788 = x1786 - x1728;
  w.x[98] = x1788;
  const Real x1789 = x1786 - x1738;
  w.x[99] = x1789;
  const Real x1790 = cosine[10] * x1785;
  const Real x1791 = x1790 - x1740;
  w.x[100] = x1791;
  const Real x1792 = x1724 + x1790;
  w.x[101] = x1792;
  const Real x1794 = x1718 - x1735;
  w.x[102] = x1794;
}

ADAGEN_NOINLINE void part_0_1(Workspace& w) {
  ADAGEN_INPUTS
  const Real x1200 = w.x[11];
  const Real x1204 = w.x[12];
  const Real x1207 = w.x[13];
  const Real x1211 = w.x[14];
  const Real x1215 = w.x[15];
  const Real x1219 = w.x[16];
  const Real x1259 = w.x[17];
  const Real x1262 = w.x[18];
  const Real x1268 = w.x[19];
  const Real x1274 = w.x[20];
  const Real x1282 = w.x[21];
  const Real x1288 = w.x[22];
  const Real x1291 = w.x[23];
  const Real x1293 = w.x[24];
  const Real x1295 = w.x[25];
  const Real x1297 = w.x[26];
  const Real x1298 = w.x[27];
  const Real x1299 = w.x[28];
  const Real x1343 = w.x[29];
  const Real x1345 = w.x[30];
  const Real x1347 = w.x[31];
  const Real x1353 = w.x[32];
  const Real x1359 = w.x[33];
  const Real x1366 = w.x[34];
  const Real x1380 = w.x[35];
  const Real x1383 = w.x[36];
  const Real x1387 = w.x[37];
  const Real x1392 = w.x[38];
  const Real x1397 = w.x[39];
  const Real x1425 = w.x[40];
  const Real x1427 = w.x[41];
  const Real x1430 = w.x[42];
  const Real x1436 = w.x[43];
  const Real x1442 = w.x[44];
  const Real x1451 = w.x[45];
  const Real x1462 = w.x[46];
  const Real x1466 = w.x[47];
  const Real x1469 = w.x[48];
  const Real x1473 = w.x[49];
  const Real x1477 = w.x[50];
  const Real x1481 = w.x[51];
  const Real x1503 = w.x[52];
  const Real x1506 = w.x[53];
  const Real x1512 = w.x[54];
  const Real x1518 = w.x[55];
  const Real x1526 = w.x[56];
  const Real x1532 = w.x[57];
  const Real x1598 = w.x[69];
  const Real x1599 = w.x[70];
  const Real x1600 = w.x[71];
  const Real x1602 = w.x[72];
  const Real x1603 = w.x[73];
  const Real x1605 = w.x[74];
  const Real x1718 = w.x[82];
  const Real x1721 = w.x[83];
  const Real x1735 = w.x[84];
  const Real x1747 = w.x[85];
  const Real x1748 = w.x[86];
  const Real x1752 = w.x[87];
  const Real x1756 = w.x[88];
  const Real x1757 = w.x[89];
  const Real x1761 = w.x[90];
  const Real x1763 = w.x[91];
  const Real x1765 = w.x[92];
  const Real x1767 = w.x[93];
  const Real x1769 = w.x[94];
  const Real x1771 = w.x[95];
  const Real x1775 = w.x[96];
  const Real x1778 = w.x[97];
  const Real x1788 = w.x[98];
  const Real x1789 = w.x[99];
  const Real x1791 = w.x[100];
  const Real x1792 = w.x[101];
  const Real x1794 = w.x[102];
  // joint 11 "right_ankle_pitch": articulated-body inertia and bias force through it
  const Real x1796 = 2.0 * sine[10];
  const Real x1800 = cosine[10] * x1794 - x1721 * x1796;
  const Real x1804 = cosine[10] * x1800;
  const Real x1811 = sine[10] * x1757 - cosine[10] * x1752;
  const Real x1816 = sine[10] * x1752 + cosine[10] * x1757;
  const Real x1822 = cosine[10] * (x1747 - x1756) + x1748 * x1796;
  const Real x1825 = sine[10] * x1822 - x1748;
  const Real x1826 = cosine[10] * x1822;
  const Real x1828 = x1747 - x1826;
  const Real x1834 = 0.3 * x1816;
  const Real x1836 = x1792 + x1834;
  const Real x1838 = 0.3 * x1828;
  const Real x1842 = x1778 + 0.3 * x1761;
  const Real x1846 = 0.3 * x1788;
  const Real x1854 = 0.3 * x1836;
  const Real x1871 = sine[10] * x1767 + cosine[10] * x1769;
  const Real x1853 = x1718 - x1804 + (0.3 * x1778 + 0.3 * x1842);
  const Real x1883 = 0.043271300000000006 + 0.3 * x1838;
  require_more(w, x1883, 0.0, kFactorization, 10);
  const Real x1884 = -0.018000000000000002 - 0.3 * x1825;
  const Real x1885 = -0.234 - x1838;
  const Real x1874 = sine[10] * x1763 + cosine[10] * x1765 + 0.3 * x1771;
  // joint 10 "right_knee": articulated-body inertia and bias force through it
  const Real x1896 = 1 / x1883;
  const Real x1898 = x1896 * (tau[15] - (tau[16] - 0.3 * x1871 + x1512));
  w.x[103] = x1898;
  const Real x1899 = x1846 * x1896;
  w.x[104] = x1899;
  const Real x1901 = x1854 * x1896;
  w.x[105] = x1901;
  const Real x1902 = x1884 * x1896;
  w.x[106] = x1902;
  const Real x1903 = x1885 * x1896;
  w.x[107] = x1903;
  const Real x1904 = x1834 * x1896;
  w.x[108] = x1904;
  const Real x1907 = x1735 + x1804 + 0.0020025 - x1846 * x1899;
  // joint 11 "right_ankle_pitch": articulated-body inertia and bias force through it
  const Real x1879 = x1721 + sine[10] * x1800 + 0.3 * x1775 + 0.00234;
  // joint 10 "right_knee": articulated-body inertia and bias force through it
  const Real x1910 = x1879 + x1846 * x1901;
  const Real x1913 = x1791 + x1846 * x1902;
  const Real x1916 = x1788 + x1846 * x1903;
  const Real x1919 = 0.018000000000000002 + x1775 + x1846 * x1904;
  const Real x1922 = 0.043091300000000006 + x1853 - x1854 * x1901;
  const Real x1925 = x1789 + 0.3 * x1811 - x1854 * x1902;
  const Real x1928 = x1836 + x1854 * x1903;
  const Real x1932 = 0.234 + x1842 - x1854 * x1904;
  const Real x1935 = x1756 + x1826 + 1.8 - x1884 * x1902;
  const Real x1938 = x1825 - x1884 * x1903;
  const Real x1941 = x1811 - x1884 * x1904;
  const Real x1944 = 1.8 + x1828 - x1885 * x1903;
  const Real x1947 = x1816 + x1885 * x1904;
  const Real x1951 = 1.8 + x1761 - x1834 * x1904;
  // joint 11 "right_ankle_pitch": articulated-body inertia and bias force through it
  const Real x1889 = cosine[10] * x1763 - sine[10] * x1765 + x1503;
  // joint 10 "right_knee": articulated-body inertia and bias force through it
  const Real x1954 = x1889 - x1846 * x1898;
  const Real x1956 = x1506 + x1874 + x1854 * x1898;
  // joint 11 "right_ankle_pitch": articulated-body inertia and bias force through it
  const Real x1892 = cosine[10] * x1767 - sine[10] * x1769 + x1518;
  // joint 10 "right_knee": articulated-body inertia and bias force through it
  const Real x1958 = x1892 + x1884 * x1898;
  const Real x1960 = x1526 + x1871 + x1885 * x1898;
  const Real x1962 = x1532 + x1771 + x1834 * x1898;
  const Real x1966 = cosine[9] * x1919 - sine[9] * x1932;
  const Real x1969 = sine[9] * x1919 + cosine[9] * x1932;
  const Real x1975 = cosine[9] * (x1913 + x1928) - sine[9] * (x1916 + x1925);
  const Real x1976 = sine[9] * x1975;
  const Real x1978 = x1916 + x1976;
  const Real x1980 = cosine[9] * x1975;
  const Real x1981 = x1980 - x1928;
  const Real x1985 = 2.0 * sine[9];
  const Real x1989 = cosine[9] * (x1907 - x1922) - x1910 * x1985;
  const Real x1993 = cosine[9] * x1989;
  const Real x1999 = cosine[9] * x1941 + sine[9] * x1947;
  const Real x2003 = sine[9] * x1941 - cosine[9] * x1947;
  const Real x2008 = cosine[9] * (x1935 - x1944) - x1938 * x1985;
  const Real x2011 = x1938 + sine[9] * x2008;
  const Real x2012 = cosine[9] * x2008;
  const Real x2014 = x1935 - x2012;
  const Real x2015 = 0.24 * x2003;
  const Real x2017 = x1913 - x1980 + x2015;
  const Real x2018 = 0.24 * x2014;
  const Real x2022 = x1969 + 0.24 * x1951;
  const Real x2038 = x1910 + sine[9] * x1989 + 0.24 * x1966;
  const Real x2041 = 0.24 * x1978;
  const Real x2056 = sine[9] * x1958 + cosine[9] * x1960;
  const Real x2033 = x1907 - x1993 + (0.24 * x1969 + 0.24 * x2022);
  const Real x2067 = x1922 + x1993 + 0.00468;
  require_more(w, x2067, 0.0, kFactorization, 9);
  const Real x2059 = sine[9] * x1954 + cosine[9] * x1956 + 0.24 * x1962;
  // joint 9 "right_hip_yaw": articulated-body inertia and bias force through it
  const Real x2078 = 1 / x2067;
  const Real x2079 = tau[14] - (cosine[9] * x1954 - sine[9] * x1956 + x1462);
  const Real x2080 = x2078 * x2079;
  w.x[109] = x2080;
  const Real x2081 = x2038 * x2078;
  w.x[110] = x2081;
  const Real x2082 = x2041 * x2078;
  w.x[111] = x2082;
  const Real x2084 = x1978 * x2078;
  w.x[112] = x2084;
  const Real x2085 = x1966 * x2078;
  w.x[113] = x2085;
  const Real x2086 = x1981 * x2078;
  w.x[114] = x2086;
  const Real x2089 = 0.0429867 + x2033 - x2038 * x2081;
  const Real x2092 = x2038 * x2082 - 0.24 * x2017;
  const Real x2095 = x2017 - x2038 * x2084;
  const Real x2098 = 0.26 + x2022 - x2038 * x2085;
  const Real x2101 = x1925 + x1976 + 0.24 * x1999 - x2038 * x2086;
  const Real x2104 = 0.0429867 + 0.24 * x2018 - x2041 * x2082;
  const Real x2107 = -0.26 - x2018 + x2041 * x2084;
  const Real x2110 = x2041 * x2085 - x2015;
  const Real x2113 = x2041 * x2086 - 0.24 * x2011;
  const Real x2116 = 2.6 + x2014 - x1978 * x2084;
  const Real x2119 = x2003 - x1978 * x2085;
  const Real x2122 = x2011 - x1978 * x2086;
  const Real x2125 = 2.6 + x1951 - x1966 * x2085;
  const Real x2128 = x1999 - x1966 * x2086;
  const Real x2133 = x1466 + x2059 + x2038 * x2080;
  const Real x2136 = tau[15] - 0.24 * x2056 + x1469 - x2041 * x2080;
  const Real x2138 = x1473 + x2056 + x1978 * x2080;
  const Real x2140 = x1477 + x1962 + x1966 * x2080;
  // joint 10 "right_knee": articulated-body inertia and bias force through it
  const Real x2076 = cosine[9] * x1958 - sine[9] * x1960 + x1481;
  // joint 9 "right_hip_yaw": articulated-body inertia and bias force through it
  const Real x2155 = cosine[8] * (x2095 - x2110) - sine[8] * (x2098 + x2107);
  const Real x2156 = sine[8] * x2155;
  const Real x2158 = x2098 + x2156;
  const Real x2159 = x2107 + x2156;
  const Real x2160 = cosine[8] * x2155;
  const Real x2161 = x2110 + x2160;
  const Real x2165 = 2.0 * sine[8];
  const Real x2169 = cosine[8] * (x2089 - x2104) - x2092 * x2165;
  const Real x2173 = cosine[8] * x2169;
  const Real x2179 = cosine[8] * x2122 - sine[8] * x2128;
  const Real x2182 = sine[8] * x2122 + cosine[8] * x2128;
  const Real x2187 = cosine[8] * (x2116 - x2125) - x2119 * x2165;
  const Real x2190 = x2119 + sine[8] * x2187;
  const Real x2191 = cosine[8] * x2187;
  const Real x2192 = x2125 + x2191;
  const Real x2193 = x2116 - x2191;
  const Real x2194 = 0.12 * x2190;
  const Real x2196 = x2095 - x2160 - x2194;
  const Real x2199 = x2158 + 0.12 * x2193;
  const Real x2205 = cosine[8] * x2101 - sine[8] * x2113 + 0.12 * x2182;
  const Real x2208 = x2159 - 0.12 * x2192;
  const Real x2209 = x2161 + x2194;
  const Real x2220 = x2092 + sine[8] * x2169 - 0.12 * x2161;
  const Real x2221 = 0.12 * x2196 + x2220;
  const Real x2238 = cosine[8] * x2138 - sine[8] * x2140;
  const Real x2241 = sine[8] * x2138 + cosine[8] * x2140;
  const Real x2215 = x2089 - x2173 - 0.12 * x2159 - 0.12 * x2208;
  const Real x2202 = sine[8] * x2101 + cosine[8] * x2113 - 0.12 * x2179;
  const Real x2227 = x2104 + x2173 + 0.12 * x2158 + 0.12 * x2199;
  const Real x2251 = 0.00342 + x2227;
  require_more(w, x2251, 0.0, kFactorization, 8);
  const Real x2252 = 0.048 + x2199;
  const Real x2244 = sine[8] * x2133 + cosine[8] * x2136 - 0.12 * x2238;
  const Real x2247 = cosine[8] * x2133 - sine[8] * x2136 + 0.12 * x2241;
  // joint 8 "right_hip_roll": articulated-body inertia and bias force through it
  const Real x2263 = 1 / x2251;
  const Real x2265 = x2263 * (tau[13] - (x1430 + x2247));
  w.x[115] = x2265;
  const Real x2266 = x2221 * x2263;
  w.x[116] = x2266;
  const Real x2267 = 0.00096 * x2263;
  w.x[117] = x2267;
  const Real x2268 = x2252 * x2263;
  w.x[118] = x2268;
  const Real x2269 = x2205 * x2263;
  w.x[119] = x2269;
  const Real x2270 = x2209 * x2263;
  w.x[120] = x2270;
  const Real x2273 = 0.00379 + x2215 - x2221 * x2266;
  const Real x2274 = x2221 * x2267;
  const Real x2278 = x2196 - x2221 * x2268;
  const Real x2281 = -0.024 + x2202 - x2221 * x2269;
  const Real x2284 = -0.048 + x2208 - x2221 * x2270;
  const Real x2287 = 0.00187 - 0.00096 * x2267;
  const Real x2290 = 0.024 - 0.00096 * x2268;
  const Real x2291 = 0.00096 * x2269;
  const Real x2293 = 0.00096 * x2270;
  const Real x2297 = 1.2 + x2193 - x2252 * x2268;
  const Real x2300 = x2182 - x2252 * x2269;
  const Real x2303 = x2190 - x2252 * x2270;
  // joint 9 "right_hip_yaw": articulated-body inertia and bias force through it
  const Real x2254 = x1944 + x2012 + 2.6 - x1981 * x2086 + 1.2;
  // joint 8 "right_hip_roll": articulated-body inertia and bias force through it
  const Real x2306 = x2254 - x2205 * x2269;
  const Real x2309 = x2179 - x2205 * x2270;
  const Real x2312 = 1.2 + x2192 - x2209 * x2270;
  const Real x2314 = x1425 + x2244 + x2221 * x2265;
  const Real x2316 = x1427 + tau[14] + 0.00096 * x2265;
  const Real x2318 = x1436 + x2241 + x2252 * x2265;
  const Real x2320 = x2076 + x1981 * x2080 + x1442 + x2205 * x2265;
  const Real x2322 = x2238 - x1451 + x2209 * x2265;
  const Real x2326 = cosine[7] * x2284 + sine[7] * x2293;
  const Real x2330 = sine[7] * x2284 - cosine[7] * x2293;
  const Real x2336 = cosine[7] * (x2278 + x2291) - sine[7] * (x2281 + x2290);
  const Real x2337 = sine[7] * x2336;
  const Real x2339 = x2281 + x2337;
  const Real x2341 = cosine[7] * x2336;
  const Real x2342 = x2341 - x2291;
  const Real x2346 = 2.0 * sine[7];
  const Real x2350 = cosine[7] * (x2273 - x2287) + x2274 * x2346;
  const Real x2354 = cosine[7] * x2350;
  const Real x2360 = cosine[7] * x2303 - sine[7] * x2309;
  const Real x2363 = sine[7] * x2303 + cosine[7] * x2309;
  const Real x2368 = cosine[7] * (x2297 - x2306) - x2300 * x2346;
  const Real x2371 = x2300 + sine[7] * x2368;
  const Real x2372 = cosine[7] * x2368;
  const Real x2374 = x2297 - x2372;
  const Real x2375 = 0.04 * x2363;
  const Real x2377 = x2278 - x2341 + x2375;
  const Real x2378 = 0.04 * x2374;
  const Real x2382 = x2330 + 0.04 * x2312;
  const Real x2398 = sine[7] * x2350 - x2274 + 0.04 * x2326;
  const Real x2401 = 0.04 * x2339;
  const Real x2416 = sine[7] * x2318 + cosine[7] * x2320;
  const Real x2393 = x2273 - x2354 + (0.04 * x2330 + 0.04 * x2382);
  const Real x2427 = x2287 + x2354 + 0.00175;
  require_more(w, x2427, 0.0, kFactorization, 7);
  const Real x2419 = sine[7] * x2314 + cosine[7] * x2316 + 0.04 * x2322;
  // joint 7 "right_hip_pitch": articulated-body inertia and bias force through it
  const Real x2437 = 1 / x2427;
  const Real x2439 = x2437 * (tau[12] - (cosine[7] * x2314 - sine[7] * x2316));
  w.x[121] = x2439;
  const Real x2440 = x2398 * x2437;
  w.x[122] = x2440;
  const Real x2441 = x2401 * x2437;
  w.x[123] = x2441;
  const Real x2443 = x2339 * x2437;
  w.x[124] = x2443;
  const Real x2444 = x2326 * x2437;
  w.x[125] = x2444;
  const Real x2445 = x2342 * x2437;
  w.x[126] = x2445;
  const Real x2448 = 0.00308 + x2393 - x2398 * x2440;
  const Real x2451 = x2398 * x2441 - 0.04 * x2377;
  const Real x2454 = x2377 - x2398 * x2443;
  const Real x2457 = 0.041999999999999996 + x2382 - x2398 * x2444;
  const Real x2460 = x2290 + x2337 + 0.04 * x2360 - x2398 * x2445;
  const Real x2463 = 0.00308 + 0.04 * x2378 - x2401 * x2441;
  const Real x2466 = -0.041999999999999996 - x2378 + x2401 * x2443;
  const Real x2469 = x2401 * x2444 - x2375;
  const Real x2472 = x2401 * x2445 - 0.04 * x2371;
  const Real x2475 = 1.4 + x2374 - x2339 * x2443;
  const Real x2478 = x2363 - x2339 * x2444;
  const Real x2481 = x2371 - x2339 * x2445;
  const Real x2484 = 1.4 + x2312 - x2326 * x2444;
  const Real x2487 = x2360 - x2326 * x2445;
  const Real x2490 = x2306 + x2372 + 1.4 - x2342 * x2445;
  const Real x2492 = x1380 + x2419 + x2398 * x2439;
  const Real x2495 = tau[13] - 0.04 * x2416 + x1383 - x2401 * x2439;
  const Real x2497 = x1387 + x2416 + x2339 * x2439;
  const Real x2499 = x2322 - x1392 + x2326 * x2439;
  // joint 8 "right_hip_roll": articulated-body inertia and bias force through it
  const Real x2435 = cosine[7] * x2318 - sine[7] * x2320 + x1397;
  // joint 7 "right_hip_pitch": articulated-body inertia and bias force through it
  const Real x2501 = x2435 + x2342 * x2439;
  const Real x2505 = cosine[6] * x2460 - sine[6] * x2472;
  const Real x2508 = sine[6] * x2460 + cosine[6] * x2472;
  const Real x2514 = cosine[6] * (x2454 - x2469) - sine[6] * (x2457 + x2466);
  const Real x2515 = sine[6] * x2514;
  const Real x2517 = x2457 + x2515;
  const Real x2518 = x2466 + x2515;
  const Real x2519 = cosine[6] * x2514;
  const Real x2520 = x2469 + x2519;
  const Real x2524 = 2.0 * sine[6];
  const Real x2528 = cosine[6] * (x2448 - x2463) - x2451 * x2524;
  const Real x2532 = cosine[6] * x2528;
  const Real x2538 = cosine[6] * x2481 - sine[6] * x2487;
  w.x[127] = x2538;
  const Real x2541 = sine[6] * x2481 + cosine[6] * x2487;
  w.x[128] = x2541;
  const Real x2546 = cosine[6] * (x2475 - x2484) - x2478 * x2524;
  const Real x2549 = x2478 + sine[6] * x2546;
  w.x[129] = x2549;
  const Real x2550 = cosine[6] * x2546;
  const Real x2551 = x2484 + x2550;
  const Real x2552 = x2475 - x2550;
  const Real x2553 = 0.09 * x2549;
  const Real x2555 = 0.05 * x2541;
  w.x[130] = x2555;
  const Real x2558 = x2454 - x2519 + x2555 - x2553;
  w.x[131] = x2558;
  const Real x2559 = 0.05 * x2552;
  const Real x2563 = x2517 + 0.09 * x2552;
  w.x[132] = x2563;
  const Real x2569 = x2508 + 0.05 * x2490 - 0.09 * x2538;
  const Real x2572 = x2505 + 0.09 * x2541;
  w.x[133] = x2572;
  const Real x2578 = x2518 + 0.05 * x2538 - 0.09 * x2551;
  w.x[134] = x2578;
  const Real x2579 = 0.05 * x2549;
  w.x[135] = x2579;
  const Real x2581 = x2520 + x2553;
  w.x[136] = x2581;
  const Real x2591 = x2448 - x2532 + 0.05 * x2508 + 0.05 * x2569;
  const Real x2594 = 0.05 * x2558;
  w.x[137] = x2594;
  const Real x2602 = x2451 + sine[6] * x2528 + 0.05 * x2505;
  const Real x2604 = x2602 - 0.09 * x2520 + 0.09 * x2558;
  w.x[138] = x2604;
  const Real x2611 = 0.05 * x2517 + 0.09 * x2559;
  w.x[139] = x2611;
  const Real x2629 = cosine[6] * x2497 - sine[6] * x2499;
  const Real x2632 = sine[6] * x2497 + cosine[6] * x2499;
  const Real x2637 = sine[6] * x2492 + cosine[6] * x2495 + 0.05 * x2501;
  const Real x2645 = x2591 - 0.09 * x2518 - 0.09 * x2578 + 0.034926700000000005;
  w.x[140] = x2645;
  const Real x2646 = -0.12400000000000001 + x2569;
  w.x[141] = x2646;
  const Real x2647 = 0.0200467 + 0.05 * x2559;
  w.x[142] = x2647;
  const Real x2648 = 0.12400000000000001 - x2559;
  w.x[143] = x2648;
  const Real x2618 = x2463 + x2532 + 0.09 * x2517 + 0.09 * x2563;
  const Real x2649 = 0.0351333 + x2618;
  w.x[144] = x2649;
  const Real x2650 = 6.2 + x2552;
  w.x[145] = x2650;
  const Real x2651 = 6.2 + x2490;
  w.x[146] = x2651;
  const Real x2652 = 6.2 + x2551;
  w.x[147] = x2652;
  const Real x2653 = x2637 - 0.09 * x2629 + x1602;
  w.x[148] = x2653;
  const Real x2654 = tau[12] - 0.05 * x2632 - x1603;
  w.x[149] = x2654;
  const Real x2644 = cosine[6] * x2492 - sine[6] * x2495 + 0.09 * x2632;
  const Real x2655 = x2644 - x1605;
  w.x[150] = x2655;
  const Real x2656 = x1598 + x2632;
  w.x[151] = x2656;
  const Real x2657 = x1599 + x2501;
  w.x[152] = x2657;
  const Real x2658 = x2629 - x1600;
  w.x[153] = x2658;
  // joint 6 "left_ankle_roll": articulated-body inertia and bias force through it
  const Real x2661 = 828.7290528372782 * (tau[11] - x1347);
  w.x[154] = x2661;
  const Real x2663 = x1345 + 0.0007199999999999999 * x2661;
  const Real x2665 = x1353 + 0.024 * x2661;
  const Real x2666 = cosine[5] * 0.024;
  const Real x2668 = sine[5] * 0.024;
  const Real x2670 = sine[5] * 0.014320438033028168;
  const Real x2672 = sine[5] * x2670;
  const Real x2674 = -0.024 + x2672;
  const Real x2675 = 0.009679561966971832 + x2672;
  const Real x2676 = cosine[5] * x2670;
  const Real x2678 = cosine[5] * 0.000782953140990845;
  const Real x2683 = cosine[5] * x2678;
  const Real x2686 = cosine[5] * 0.47734793443427226;
  const Real x2688 = sine[5] * x2686;
  const Real x2690 = cosine[5] * x2686;
  const Real x2692 = 0.8 - x2690;
  const Real x2696 = -0.016 - x2666;
  const Real x2697 = 0.02 * x2692;
  const Real x2703 = sine[5] * x2678 + 0.02 * x2668;
  const Real x2706 = 0.02 * x2676;
  const Real x2724 = cosine[5] * x2665 - sine[5] * x1359;
  const Real x2713 = 0.003383716859009155 + x2683 + 0.02 * x2666 - 0.02 * x2696;
  const Real x2736 = 7.2e-05 + x2713;
  require_more(w, x2736, 0.0, kFactorization, 5);
  const Real x2733 = cosine[5] * x1343 - sine[5] * x2663 - 0.02 * x1366;
  // joint 5 "left_ankle_pitch": articulated-body inertia and bias force through it
  const Real x2746 = 1 / x2736;
  const Real x2748 = x2746 * (tau[10] - (x1295 + x2733));
  w.x[155] = x2748;
  const Real x2749 = x2703 * x2746;
  w.x[156] = x2749;
  const Real x2750 = x2706 * x2746;
  w.x[157] = x2750;
  const Real x2751 = x2674 * x2746;
  w.x[158] = x2751;
  const Real x2752 = x2696 * x2746;
  w.x[159] = x2752;
  const Real x2753 = x2676 * x2746;
  w.x[160] = x2753;
  const Real x2756 = 0.00416667 - x2683 + 7.2e-05 - x2703 * x2749;
  const Real x2759 = 0.02 * x2675 - x2703 * x2750;
  const Real x2762 = x2676 + x2703 * x2751;
  const Real x2766 = x2668 + x2703 * x2752;
  const Real x2770 = x2675 - x2703 * x2753;
  const Real x2773 = 7.2e-05 + 0.02 * x2697 - x2706 * x2750;
  const Real x2776 = 0.02 * x2688 + x2706 * x2751;
  const Real x2778 = x2706 * x2752;
  const Real x2782 = x2697 - x2706 * x2753;
  const Real x2785 = 0.3226520655657278 + x2690 + 0.2 - x2674 * x2751;
  const Real x2786 = x2674 * x2752;
  const Real x2790 = x2688 + x2674 * x2753;
  const Real x2794 = 1.0 - x2696 * x2752;
  const Real x2795 = x2696 * x2753;
  const Real x2799 = 0.2 + x2692 - x2676 * x2753;
  // joint 6 "left_ankle_roll": articulated-body inertia and bias force through it
  const Real x2739 = sine[5] * x1343 + cosine[5] * x2663 + x1291;
  // joint 5 "left_ankle_pitch": articulated-body inertia and bias force through it
  const Real x2801 = x2739 + x2703 * x2748;
  const Real x2803 = tau[11] + 0.02 * x2724 + x1293 + x2706 * x2748;
  // joint 6 "left_ankle_roll": articulated-body inertia and bias force through it
  const Real x2742 = sine[5] * x2665 + cosine[5] * x1359 + x1297;
  // joint 5 "left_ankle_pitch": articulated-body inertia and bias force through it
  const Real x2805 = x2742 + x2674 * x2748;
  const Real x2807 = x1298 + x1366 + x2696 * x2748;
  const Real x2809 = x1299 + x2724 + x2676 * x2748;
  const Real x2813 = cosine[4] * x2770 - sine[4] * x2782;
  const Real x2816 = sine[4] * x2770 + cosine[4] * x2782;
  const Real x2823 = cosine[4] * (x2778 - x2762) + sine[4] * (x2766 + x2776);
  const Real x2824 = sine[4] * x2823;
  const Real x2826 = x2824 - x2766;
  const Real x2828 = cosine[4] * x2823;
  const Real x2834 = 2.0 * sine[4];
  const Real x2838 = cosine[4] * (x2756 - x2773) - x2759 * x2834;
  const Real x2842 = cosine[4] * x2838;
  const Real x2849 = sine[4] * x2795 - cosine[4] * x2790;
  const Real x2854 = sine[4] * x2790 + cosine[4] * x2795;
  const Real x2860 = cosine[4] * (x2785 - x2794) + x2786 * x2834;
  const Real x2863 = sine[4] * x2860 - x2786;
  const Real x2864 = cosine[4] * x2860;
  const Real x2866 = x2785 - x2864;
  const Real x2872 = 0.3 * x2854;
  const Real x2874 = x2762 + x2828 + x2872;
  const Real x2876 = 0.3 * x2866;
  const Real x2880 = x2816 + 0.3 * x2799;
  const Real x2884 = 0.3 * x2826;
  const Real x2892 = 0.3 * x2874;
  const Real x2909 = sine[4] * x2805 + cosine[4] * x2807;
  const Real x2891 = x2756 - x2842 + (0.3 * x2816 + 0.3 * x2880);
  const Real x2921 = 0.043271300000000006 + 0.3 * x2876;
  require_more(w, x2921, 0.0, kFactorization, 4);
  const Real x2922 = -0.018000000000000002 - 0.3 * x2863;
  const Real x2923 = -0.234 - x2876;
  const Real x2912 = sine[4] * x2801 + cosine[4] * x2803 + 0.3 * x2809;
  // joint 4 "left_knee": articulated-body inertia and bias force through it
  const Real x2934 = 1 / x2921;
  const Real x2936 = x2934 * (tau[9] - (tau[10] - 0.3 * x2909 + x1268));
  w.x[161] = x2936;
  const Real x2937 = x2884 * x2934;
  w.x[162] = x2937;
  const Real x2939 = x2892 * x2934;
  w.x[163] = x2939;
  const Real x2940 = x2922 * x2934;
  w.x[164] = x2940;
  const Real x2941 = x2923 * x2934;
  w.x[165] = x2941;
  const Real x2942 = x2872 * x2934;
  w.x[166] = x2942;
  const Real x2945 = x2773 + x2842 + 0.0020025 - x2884 * x2937;
  // joint 5 "left_ankle_pitch": articulated-body inertia and bias force through it
  const Real x2917 = x2759 + sine[4] * x2838 + 0.3 * x2813 + 0.00234;
  // joint 4 "left_knee": articulated-body inertia and bias force through it
  const Real x2948 = x2917 + x2884 * x2939;
  const Real x2951 = x2828 - x2778 + x2884 * x2940;
  const Real x2954 = x2826 + x2884 * x2941;
  const Real x2957 = 0.018000000000000002 + x2813 + x2884 * x2942;
  const Real x2960 = 0.043091300000000006 + x2891 - x2892 * x2939;
  const Real x2963 = x2824 - x2776 + 0.3 * x2849 - x2892 * x2940;
  const Real x2966 = x2874 + x2892 * x2941;
  const Real x2970 = 0.234 + x2880 - x2892 * x2942;
  const Real x2973 = x2794 + x2864 + 1.8 - x2922 * x2940;
  const Real x2976 = x2863 - x2922 * x2941;
  const Real x2979 = x2849 - x2922 * x2942;
  const Real x2982 = 1.8 + x2866 - x2923 * x2941;
  const Real x2985 = x2854 + x2923 * x2942;
  const Real x2989 = 1.8 + x2799 - x2872 * x2942;
  // joint 5 "left_ankle_pitch": articulated-body inertia and bias force through it
  const Real x2927 = cosine[4] * x2801 - sine[4] * x2803 + x1259;
  // joint 4 "left_knee": articulated-body inertia and bias force through it
  const Real x2992 = x2927 - x2884 * x2936;
  const Real x2994 = x1262 + x2912 + x2892 * x2936;
  // joint 5 "left_ankle_pitch": articulated-body inertia and bias force through it
  const Real x2930 = cosine[4] * x2805 - sine[4] * x2807 + x1274;
  // joint 4 "left_knee": articulated-body inertia and bias force through it
  const Real x2996 = x2930 + x2922 * x2936;
  const Real x2998 = x1282 + x2909 + x2923 * x2936;
  const Real x3000 = x1288 + x2809 + x2872 * x2936;
  const Real x3004 = cosine[3] * x2957 - sine[3] * x2970;
  w.x[167] = x3004;
  const Real x3007 = sine[3] * x2957 + cosine[3] * x2970;
  const Real x3013 = cosine[3] * (x2951 + x2966) - sine[3] * (x2954 + x2963);
  const Real x3014 = sine[3] * x3013;
  const Real x3016 = x2954 + x3014;
  w.x[168] = x3016;
  const Real x3018 = cosine[3] * x3013;
  const Real x3019 = x3018 - x2966;
  w.x[169] = x3019;
  const Real x3023 = 2.0 * sine[3];
  const Real x3027 = cosine[3] * (x2945 - x2960) - x2948 * x3023;
  const Real x3031 = cosine[3] * x3027;
  const Real x3037 = cosine[3] * x2979 + sine[3] * x2985;
  w.x[170] = x3037;
  const Real x3041 = sine[3] * x2979 - cosine[3] * x2985;
  w.x[171] = x3041;
  const Real x3046 = cosine[3] * (x2973 - x2982) - x2976 * x3023;
  const Real x3049 = x2976 + sine[3] * x3046;
  w.x[172] = x3049;
  const Real x3050 = cosine[3] * x3046;
  const Real x3052 = x2973 - x3050;
  const Real x3053 = 0.24 * x3041;
  w.x[173] = x3053;
  const Real x3055 = x2951 - x3018 + x3053;
  w.x[174] = x3055;
  const Real x3056 = 0.24 * x3052;
  const Real x3060 = x3007 + 0.24 * x2989;
  const Real x3063 = x2963 + x3014 + 0.24 * x3037;
  w.x[175] = x3063;
  const Real x3064 = 0.24 * x3049;
  w.x[176] = x3064;
  const Real x3072 = 0.24 * x3055;
  w.x[177] = x3072;
  const Real x3076 = x2948 + sine[3] * x3027 + 0.24 * x3004;
  w.x[178] = x3076;
  const Real x3079 = 0.24 * x3016;
  w.x[179] = x3079;
  const Real x3094 = sine[3] * x2996 + cosine[3] * x2998;
  const Real x3071 = x2945 - x3031 + (0.24 * x3007 + 0.24 * x3060);
  const Real x3102 = 0.26 + x3060;
  w.x[180] = x3102;
  const Real x3103 = 0.0429867 + 0.24 * x3056;
  w.x[181] = x3103;
  const Real x3104 = -0.26 - x3056;
  w.x[182] = x3104;
  const Real x3105 = x2960 + x3031 + 0.00468;
  require_more(w, x3105, 0.0, kFactorization, 3);
  const Real x3106 = 2.6 + x3052;
  w.x[183] = x3106;
  const Real x3107 = 2.6 + x2989;
  w.x[184] = x3107;
  const Real x3108 = x2982 + x3050 + 2.6;
  w.x[185] = x3108;
  const Real x3097 = sine[3] * x2992 + cosine[3] * x2994 + 0.24 * x3000;
  const Real x3109 = x1204 + x3097;
  w.x[186] = x3109;
  const Real x3110 = tau[9] - 0.24 * x3094 + x1207;
  w.x[187] = x3110;
  const Real x3112 = x1211 + x3094;
  w.x[188] = x3112;
  const Real x3113 = x1215 + x3000;
  w.x[189] = x3113;
  const Real x3114 = cosine[3] * x2996 - sine[3] * x2998 + x1219;
  w.x[190] = x3114;
  // joint 3 "left_hip_yaw": articulated-body inertia and bias force through it
  const Real x3116 = 1 / x3105;
  const Real x3117 = tau[8] - (cosine[3] * x2992 - sine[3] * x2994 + x1200);
  const Real x3118 = x3116 * x3117;
  w.x[191] = x3118;
  const Real x3119 = x3076 * x3116;
  w.x[192] = x3119;
  const Real x3120 = x3079 * x3116;
  w.x[193] = x3120;
  const Real x3122 = x3016 * x3116;
  w.x[194] = x3122;
  const Real x3123 = x3004 * x3116;
  w.x[195] = x3123;
  const Real x3124 = x3019 * x3116;
  w.x[196] = x3124;
  const Real x3127 = 0.0429867 + x3071 - x3076 * x3119;
  w.x[197] = x3127;
  const Real x3128 = x3076 * x3120;
  w.x[198] = x3128;
}

ADAGEN_NOINLINE void part_0_2(Workspace& w) {
  ADAGEN_INPUTS
  const Real x985 = w.x[63];
  const Real x994 = w.x[64];
  const Real x997 = w.x[65];
  const Real x1000 = w.x[66];
  const Real x1005 = w.x[67];
  const Real x1009 = w.x[68];
  const Real x1032 = w.x[58];
  const Real x1034 = w.x[59];
  const Real x1037 = w.x[60];
  const Real x1040 = w.x[61];
  const Real x1045 = w.x[62];
  const Real x1096 = w.x[0];
  const Real x1098 = w.x[1];
  const Real x1101 = w.x[2];
  const Real x1104 = w.x[3];
  const Real x1109 = w.x[4];
  const Real x1156 = w.x[5];
  const Real x1158 = w.x[6];
  const Real x1161 = w.x[7];
  const Real x1167 = w.x[8];
  const Real x1173 = w.x[9];
  const Real x1180 = w.x[10];
  const Real x2538 = w.x[127];
  const Real x2541 = w.x[128];
  const Real x2549 = w.x[129];
  const Real x2555 = w.x[130];
  const Real x2558 = w.x[131];
  const Real x2563 = w.x[132];
  const Real x2572 = w.x[133];
  const Real x2578 = w.x[134];
  const Real x2579 = w.x[135];
  const Real x2581 = w.x[136];
  const Real x2594 = w.x[137];
  const Real x2604 = w.x[138];
  const Real x2611 = w.x[139];
  const Real x2645 = w.x[140];
  const Real x2646 = w.x[141];
  const Real x2647 = w.x[142];
  const Real x2648 = w.x[143];
  const Real x2649 = w.x[144];
  const Real x2650 = w.x[145];
  const Real x2651 = w.x[146];
  const Real x2652 = w.x[147];
  const Real x2653 = w.x[148];
  const Real x2654 = w.x[149];
  const Real x2655 = w.x[150];
  const Real x2656 = w.x[151];
  const Real x2657 = w.x[152];
  const Real x2658 = w.x[153];
  const Real x3004 = w.x[167];
  const Real x3016 = w.x[168];
  const Real x3019 = w.x[169];
  const Real x3037 = w.x[170];
  const Real x3041 = w.x[171];
  const Real x3049 = w.x[172];
  const Real x3053 = w.x[173];
  const Real x3055 = w.x[174];
  const Real x3063 = w.x[175];
  const Real x3064 = w.x[176];
  const Real x3072 = w.x[177];
  const Real x3076 = w.x[178];
  const Real x3079 = w.x[179];
  const Real x3102 = w.x[180];
  const Real x3103 = w.x[181];
  const Real x3104 = w.x[182];
  const Real x3106 = w.x[183];
  const Real x3107 = w.x[184];
  const Real x3108 = w.x[185];
  const Real x3109 = w.x[186];
  const Real x3110 = w.x[187];
  const Real x3112 = w.x[188];
  const Real x3113 = w.x[189];
  const Real x3114 = w.x[190];
  const Real x3118 = w.x[191];
  const Real x3120 = w.x[193];
  const Real x3122 = w.x[194];
  const Real x3123 = w.x[195];
  const Real x3124 = w.x[196];
  const Real x3127 = w.x[197];
  const Real x3128 = w.x[198];
  // joint 3 "left_hip_yaw": articulated-body inertia and bias force through it
  const Real x3130 = x3128 - x3072;
  const Real x3133 = x3055 - x3076 * x3122;
  const Real x3136 = x3102 - x3076 * x3123;
  const Real x3139 = x3063 - x3076 * x3124;
  const Real x3142 = x3103 - x3079 * x3120;
  const Real x3145 = x3104 + x3079 * x3122;
  const Real x3148 = x3079 * x3123 - x3053;
  const Real x3151 = x3079 * x3124 - x3064;
  const Real x3154 = x3106 - x3016 * x3122;
  const Real x3157 = x3041 - x3016 * x3123;
  const Real x3160 = x3049 - x3016 * x3124;
  const Real x3163 = x3107 - x3004 * x3123;
  const Real x3166 = x3037 - x3004 * x3124;
  const Real x3171 = x3109 + x3076 * x3118;
  const Real x3174 = x3110 - x3079 * x3118;
  const Real x3176 = x3112 + x3016 * x3118;
  const Real x3178 = x3113 + x3004 * x3118;
  const Real x3193 = cosine[2] * (x3133 - x3148) - sine[2] * (x3136 + x3145);
  const Real x3194 = sine[2] * x3193;
  const Real x3196 = x3136 + x3194;
  const Real x3197 = x3145 + x3194;
  const Real x3198 = cosine[2] * x3193;
  const Real x3199 = x3148 + x3198;
  const Real x3203 = 2.0 * sine[2];
  const Real x3207 = cosine[2] * (x3127 - x3142) - x3130 * x3203;
  const Real x3211 = cosine[2] * x3207;
  const Real x3217 = cosine[2] * x3160 - sine[2] * x3166;
  const Real x3220 = sine[2] * x3160 + cosine[2] * x3166;
  const Real x3225 = cosine[2] * (x3154 - x3163) - x3157 * x3203;
  const Real x3228 = x3157 + sine[2] * x3225;
  const Real x3229 = cosine[2] * x3225;
  const Real x3230 = x3163 + x3229;
  const Real x3231 = x3154 - x3229;
  const Real x3232 = 0.12 * x3228;
  const Real x3234 = x3133 - x3198 - x3232;
  const Real x3237 = x3196 + 0.12 * x3231;
  const Real x3243 = cosine[2] * x3139 - sine[2] * x3151 + 0.12 * x3220;
  const Real x3246 = x3197 - 0.12 * x3230;
  const Real x3247 = x3199 + x3232;
  const Real x3258 = x3130 + sine[2] * x3207 - 0.12 * x3199;
  const Real x3259 = 0.12 * x3234 + x3258;
  const Real x3276 = cosine[2] * x3176 - sine[2] * x3178;
  const Real x3279 = sine[2] * x3176 + cosine[2] * x3178;
  const Real x3253 = x3127 - x3211 - 0.12 * x3197 - 0.12 * x3246;
  const Real x3240 = sine[2] * x3139 + cosine[2] * x3151 - 0.12 * x3217;
  const Real x3265 = x3142 + x3211 + 0.12 * x3196 + 0.12 * x3237;
  const Real x3289 = 0.00342 + x3265;
  require_more(w, x3289, 0.0, kFactorization, 2);
  const Real x3290 = 0.048 + x3237;
  const Real x3282 = sine[2] * x3171 + cosine[2] * x3174 - 0.12 * x3276;
  const Real x3285 = cosine[2] * x3171 - sine[2] * x3174 + 0.12 * x3279;
  // joint 2 "left_hip_roll": articulated-body inertia and bias force through it
  const Real x3301 = 1 / x3289;
  const Real x3303 = x3301 * (tau[7] - (x1161 + x3285));
  w.x[102] = x3303;
  const Real x3304 = x3259 * x3301;
  w.x[101] = x3304;
  const Real x3305 = 0.00096 * x3301;
  w.x[100] = x3305;
  const Real x3306 = x3290 * x3301;
  w.x[99] = x3306;
  const Real x3307 = x3243 * x3301;
  w.x[98] = x3307;
  const Real x3308 = x3247 * x3301;
  w.x[97] = x3308;
  const Real x3311 = 0.00379 + x3253 - x3259 * x3304;
  const Real x3312 = x3259 * x3305;
  const Real x3316 = x3234 - x3259 * x3306;
  const Real x3319 = -0.024 + x3240 - x3259 * x3307;
  const Real x3322 = -0.048 + x3246 - x3259 * x3308;
  const Real x3325 = 0.00187 - 0.00096 * x3305;
  const Real x3328 = 0.024 - 0.00096 * x3306;
  const Real x3329 = 0.00096 * x3307;
  const Real x3331 = 0.00096 * x3308;
  const Real x3335 = 1.2 + x3231 - x3290 * x3306;
  const Real x3338 = x3220 - x3290 * x3307;
  const Real x3341 = x3228 - x3290 * x3308;
  const Real x3344 = x3108 - x3019 * x3124 + 1.2 - x3243 * x3307;
  const Real x3347 = x3217 - x3243 * x3308;
  const Real x3350 = 1.2 + x3230 - x3247 * x3308;
  const Real x3352 = x1156 + x3282 + x3259 * x3303;
  const Real x3354 = x1158 + tau[8] + 0.00096 * x3303;
  const Real x3356 = x1167 + x3279 + x3290 * x3303;
  const Real x3358 = x3114 + x3019 * x3118 + x1173 + x3243 * x3303;
  const Real x3360 = x1180 + x3276 + x3247 * x3303;
  const Real x3364 = cosine[1] * x3322 + sine[1] * x3331;
  const Real x3368 = sine[1] * x3322 - cosine[1] * x3331;
  const Real x3374 = cosine[1] * (x3316 + x3329) - sine[1] * (x3319 + x3328);
  const Real x3375 = sine[1] * x3374;
  const Real x3377 = x3319 + x3375;
  const Real x3379 = cosine[1] * x3374;
  const Real x3380 = x3379 - x3329;
  const Real x3384 = 2.0 * sine[1];
  const Real x3388 = cosine[1] * (x3311 - x3325) + x3312 * x3384;
  const Real x3392 = cosine[1] * x3388;
  const Real x3398 = cosine[1] * x3341 - sine[1] * x3347;
  const Real x3401 = sine[1] * x3341 + cosine[1] * x3347;
  const Real x3406 = cosine[1] * (x3335 - x3344) - x3338 * x3384;
  const Real x3409 = x3338 + sine[1] * x3406;
  const Real x3410 = cosine[1] * x3406;
  const Real x3412 = x3335 - x3410;
  const Real x3413 = 0.04 * x3401;
  const Real x3415 = x3316 - x3379 - x3413;
  const Real x3416 = 0.04 * x3412;
  const Real x3419 = x3368 - 0.04 * x3350;
  const Real x3434 = sine[1] * x3388 - x3312 - 0.04 * x3364;
  const Real x3436 = 0.04 * x3377;
  const Real x3450 = sine[1] * x3356 + cosine[1] * x3358;
  const Real x3430 = x3311 - x3392 - (0.04 * x3368 + 0.04 * x3419);
  const Real x3460 = x3325 + x3392 + 0.00175;
  require_more(w, x3460, 0.0, kFactorization, 1);
  const Real x3453 = sine[1] * x3352 + cosine[1] * x3354 - 0.04 * x3360;
  // joint 1 "left_hip_pitch": articulated-body inertia and bias force through it
  const Real x3470 = 1 / x3460;
  const Real x3472 = x3470 * (tau[6] - (cosine[1] * x3352 - sine[1] * x3354));
  w.x[96] = x3472;
  const Real x3473 = x3434 * x3470;
  w.x[95] = x3473;
  const Real x3474 = x3436 * x3470;
  w.x[94] = x3474;
  const Real x3475 = x3377 * x3470;
  w.x[93] = x3475;
  const Real x3476 = x3364 * x3470;
  w.x[92] = x3476;
  const Real x3477 = x3380 * x3470;
  w.x[91] = x3477;
  const Real x3480 = 0.00308 + x3430 - x3434 * x3473;
  const Real x3483 = 0.04 * x3415 - x3434 * x3474;
  const Real x3486 = x3415 - x3434 * x3475;
  const Real x3489 = -0.041999999999999996 + x3419 - x3434 * x3476;
  const Real x3492 = x3328 + x3375 - 0.04 * x3398 - x3434 * x3477;
  const Real x3495 = 0.00308 + 0.04 * x3416 - x3436 * x3474;
  const Real x3498 = 0.041999999999999996 + x3416 - x3436 * x3475;
  const Real x3501 = x3413 - x3436 * x3476;
  const Real x3504 = 0.04 * x3409 - x3436 * x3477;
  const Real x3507 = 1.4 + x3412 - x3377 * x3475;
  const Real x3510 = x3401 - x3377 * x3476;
  const Real x3513 = x3409 - x3377 * x3477;
  const Real x3516 = 1.4 + x3350 - x3364 * x3476;
  const Real x3519 = x3398 - x3364 * x3477;
  const Real x3522 = x3344 + x3410 + 1.4 - x3380 * x3477;
  const Real x3524 = x1096 + x3453 + x3434 * x3472;
  const Real x3526 = tau[7] + 0.04 * x3450 + x1098 + x3436 * x3472;
  const Real x3528 = x1101 + x3450 + x3377 * x3472;
  const Real x3530 = x1104 + x3360 + x3364 * x3472;
  // joint 2 "left_hip_roll": articulated-body inertia and bias force through it
  const Real x3468 = cosine[1] * x3356 - sine[1] * x3358 - x1109;
  // joint 1 "left_hip_pitch": articulated-body inertia and bias force through it
  const Real x3532 = x3468 + x3380 * x3472;
  const Real x3536 = cosine[0] * x3492 - sine[0] * x3504;
  const Real x3539 = sine[0] * x3492 + cosine[0] * x3504;
  const Real x3545 = cosine[0] * (x3486 - x3501) - sine[0] * (x3489 + x3498);
  const Real x3546 = sine[0] * x3545;
  const Real x3548 = x3489 + x3546;
  const Real x3549 = x3498 + x3546;
  const Real x3550 = cosine[0] * x3545;
  const Real x3551 = x3501 + x3550;
  const Real x3555 = 2.0 * sine[0];
  const Real x3559 = cosine[0] * (x3480 - x3495) - x3483 * x3555;
  const Real x3563 = cosine[0] * x3559;
  const Real x3569 = cosine[0] * x3513 - sine[0] * x3519;
  const Real x3572 = sine[0] * x3513 + cosine[0] * x3519;
  const Real x3577 = cosine[0] * (x3507 - x3516) - x3510 * x3555;
  const Real x3580 = x3510 + sine[0] * x3577;
  const Real x3581 = cosine[0] * x3577;
  const Real x3582 = x3516 + x3581;
  const Real x3583 = x3507 - x3581;
  const Real x3584 = 0.09 * x3580;
  const Real x3585 = 0.05 * x3572;
  const Real x3588 = x3486 - x3550 + x3585 + x3584;
  const Real x3589 = 0.05 * x3583;
  const Real x3593 = x3548 - 0.09 * x3583;
  const Real x3598 = x3539 + 0.05 * x3522 + 0.09 * x3569;
  const Real x3606 = x3549 + 0.05 * x3569 + 0.09 * x3582;
  const Real x3618 = x3480 - x3563 + 0.05 * x3539 + 0.05 * x3598;
  const Real x3628 = x3483 + sine[0] * x3559 + 0.05 * x3536;
  const Real x3654 = cosine[0] * x3528 - sine[0] * x3530;
  const Real x3657 = sine[0] * x3528 + cosine[0] * x3530;
  const Real x3661 = sine[0] * x3524 + cosine[0] * x3526 + 0.05 * x3532;
  const Real x3674 = x2646 + x3598;
  const Real x3678 = x2648 - x3589;
  const Real x3679 = x2555 + x3585;
  const Real x3643 = x3495 + x3563 - 0.09 * x3548 - 0.09 * x3593;
  const Real x3683 = x2649 + x3643;
  require_more(w, x3683, 0.0, kFactorization, 13);
  const Real x3684 = x2563 + x3593;
  const Real x3685 = x3536 - 0.09 * x3572 + x2572;
  const Real x3686 = x3551 - x3584 + x2581;
  const Real x3687 = x2650 + x3583;
  const Real x3688 = x2541 + x3572;
  const Real x3689 = x2549 + x3580;
  const Real x3690 = x2651 + x3522;
  const Real x3691 = x2538 + x3569;
  const Real x3668 = cosine[0] * x3524 - sine[0] * x3526 - 0.09 * x3657;
  const Real x3696 = x2656 + x3657;
  const Real x3697 = x2657 + x3532;
  // joint 13 "waist_yaw": articulated-body inertia and bias force through it
  const Real x3699 = 0.09 * x3688;
  const Real x3701 = x2558 + x3588 + x3699;
  const Real x3704 = x3678 - 0.09 * x3687;
  const Real x3707 = x3674 + 0.09 * x3690;
  const Real x3708 = x3679 + x3699;
  const Real x3712 = x2578 + x3606 + 0.09 * x3691;
  const Real x3715 = x2579 + 0.05 * x3580 + 0.09 * x3689;
  // joint 1 "left_hip_pitch": articulated-body inertia and bias force through it
  const Real x3669 = 0.09 * x3549 + x3618 + 0.09 * x3606 + x2645;
  // joint 13 "waist_yaw": articulated-body inertia and bias force through it
  const Real x3722 = 0.09 * x3674 + 0.09 * x3707 + x3669;
  const Real x3727 = x2594 + 0.05 * x3588 + 0.09 * x3679;
  const Real x3729 = 0.09 * x3701 + x3727;
  // joint 1 "left_hip_pitch": articulated-body inertia and bias force through it
  const Real x3672 = 0.09 * x3551 + x3628 - 0.09 * x3588 + x2604;
  // joint 13 "waist_yaw": articulated-body inertia and bias force through it
  const Real x3733 = x3672 + 0.09 * x3685;
  const Real x3738 = x2647 + 0.05 * x3589 - 0.09 * x3678;
  const Real x3739 = x3738 - 0.09 * x3704;
  // joint 1 "left_hip_pitch": articulated-body inertia and bias force through it
  const Real x3677 = 0.09 * x3589 - 0.05 * x3548 - x2611;
  // joint 13 "waist_yaw": articulated-body inertia and bias force through it
  const Real x3742 = x3677 - 0.09 * x3684;
  const Real x3755 = cosine[12] * x3684 + sine[12] * x3685;
  const Real x3759 = cosine[12] * x3685 - sine[12] * x3684;
  const Real x3764 = cosine[12] * (x3701 + x3708) + sine[12] * (x3704 + x3707);
  const Real x3765 = sine[12] * x3764;
  const Real x3768 = cosine[12] * x3764;
  const Real x3773 = cosine[12] * x3733 + sine[12] * x3742;
  const Real x3777 = cosine[12] * x3742 - sine[12] * x3733;
  const Real x3780 = 2.0 * sine[12];
  const Real x3783 = cosine[12] * (x3722 - x3739) - x3729 * x3780;
  const Real x3787 = cosine[12] * x3783;
  const Real x3800 = cosine[12] * (x3687 - x3690) + x3688 * x3780;
  const Real x3803 = cosine[12] * x3800;
  const Real x3808 = 0.09 * x3654 + x3661 + x2653 + 0.09 * x3697;
  const Real x3811 = tau[6] - 0.05 * x3657 + x2654 - 0.09 * x3696;
  const Real x3829 = 1 / x3683;
  const Real x3832 = x3829 * (x2655 + x3668 + tau[18]);
  w.x[90] = x3832;
  const Real x3834 = x3773 * x3829;
  w.x[89] = x3834;
  const Real x3835 = x3777 * x3829;
  w.x[88] = x3835;
  const Real x3836 = x3755 * x3829;
  w.x[87] = x3836;
  const Real x3837 = x3759 * x3829;
  w.x[86] = x3837;
  const Real x3838 = x3686 * x3829;
  w.x[85] = x3838;
  const Real x3863 = x3701 - x3768 - x3777 * x3837;
  const Real x3873 = x3688 - sine[12] * x3800 - x3755 * x3837;
  const Real x3876 = cosine[12] * x3689 + sine[12] * x3691 - x3755 * x3838;
  const Real x3882 = cosine[12] * x3691 - sine[12] * x3689 - x3759 * x3838;
  const Real x3902 = x3707 - x3765 - x3773 * x3837 + -0.016;
  const Real x3904 = x3704 - x3765 - x3777 * x3836 + 0.016;
  const Real x3905 = x3690 + x3803 - x3755 * x3836 + 0.8;
  const Real x3906 = x3687 - x3803 - x3759 * x3837 + 0.8;
  const Real x3907 = x2652 + x3582 - x3686 * x3838 + 0.8;
  const Real x3888 = cosine[12] * x3808 + sine[12] * x3811 - x3773 * x3832;
  const Real x3891 = cosine[12] * x3811 - sine[12] * x3808 - x3777 * x3832;
  const Real x3894 = cosine[12] * x3696 + sine[12] * x3697 - x3755 * x3832;
  const Real x3910 = x1037 + x3894;
  const Real x3897 = cosine[12] * x3697 - sine[12] * x3696 - x3759 * x3832;
  const Real x3911 = x1040 + x3897;
  const Real x3912 = x2658 + x3654 - x3686 * x3832 - x1045;
  // joint 14 "waist_roll": articulated-body inertia and bias force through it
  const Real x3913 = 0.05 * x3873;
  const Real x3915 = x3768 - x3708 - x3773 * x3836 + x3913;
  const Real x3918 = x3904 - 0.05 * x3905;
  const Real x3921 = x3902 + 0.05 * x3906;
  const Real x3922 = x3863 - x3913;
  // joint 13 "waist_yaw": articulated-body inertia and bias force through it
  const Real x3854 = cosine[12] * x3712 - sine[12] * x3715 - x3773 * x3838;
  // joint 14 "waist_roll": articulated-body inertia and bias force through it
  const Real x3925 = x3854 + 0.05 * x3882;
  // joint 13 "waist_yaw": articulated-body inertia and bias force through it
  const Real x3866 = sine[12] * x3712 + cosine[12] * x3715 + x3777 * x3838;
  // joint 14 "waist_roll": articulated-body inertia and bias force through it
  const Real x3928 = x3866 + 0.05 * x3876;
  // joint 13 "waist_yaw": articulated-body inertia and bias force through it
  const Real x3901 = x3739 + x3787 - x3773 * x3834 + 0.00106;
  // joint 14 "waist_roll": articulated-body inertia and bias force through it
  const Real x3935 = x3901 + 0.05 * x3902 + 0.05 * x3921;
  require_more(w, x3935, 0.0, kFactorization, 14);
  // joint 13 "waist_yaw": articulated-body inertia and bias force through it
  const Real x3844 = x3729 + sine[12] * x3783 + x3773 * x3835;
  // joint 14 "waist_roll": articulated-body inertia and bias force through it
  const Real x3941 = 0.05 * x3863 - x3844 - 0.05 * x3915;
  // joint 13 "waist_yaw": articulated-body inertia and bias force through it
  const Real x3903 = x3722 - x3787 - x3777 * x3835 + 0.00106;
  // joint 14 "waist_roll": articulated-body inertia and bias force through it
  const Real x3947 = x3903 - 0.05 * x3904 - 0.05 * x3918;
  const Real x3953 = cosine[13] * x3921 + sine[13] * x3925;
  const Real x3957 = cosine[13] * x3925 - sine[13] * x3921;
  const Real x3961 = cosine[13] * x3922 - sine[13] * x3928;
  const Real x3962 = sine[13] * x3961;
  const Real x3966 = cosine[13] * x3961;
  const Real x3968 = cosine[13] * x3941;
  const Real x3969 = sine[13] * x3941;
  const Real x3972 = cosine[13] * (x3947 - 0.001);
  const Real x3976 = cosine[13] * x3972;
  const Real x3989 = cosine[13] * (x3906 - x3907) + x3882 * (2.0 * sine[13]);
  const Real x3992 = cosine[13] * x3989;
  const Real x4000 = x1034 + x3891 - 0.05 * x3910;
  const Real x4020 = 1 / x3935;
  const Real x4023 = x4020 * (x1032 + x3888 + 0.05 * x3911 + tau[19]);
  w.x[84] = x4023;
  const Real x4025 = x3968 * x4020;
  w.x[83] = x4025;
  const Real x4026 = x3969 * x4020;
  w.x[82] = x4026;
  const Real x4028 = x3953 * x4020;
  w.x[74] = x4028;
  const Real x4029 = x3957 * x4020;
  w.x[73] = x4029;
  const Real x4030 = x3915 * x4020;
  w.x[72] = x4030;
  const Real x4052 = x3969 * x4028 - x3962;
  const Real x4055 = x3922 - x3966 + x3969 * x4029;
  const Real x4058 = x3969 * x4030 - sine[13] * x3918;
  const Real x4064 = x3882 - sine[13] * x3989 - x3953 * x4029;
  const Real x4067 = cosine[13] * x3873 + sine[13] * x3876 - x3953 * x4030;
  const Real x4073 = cosine[13] * x3876 - sine[13] * x3873 - x3957 * x4030;
  const Real x4093 = cosine[13] * x3918 - x3968 * x4030 + 0.018000000000000002;
  const Real x4094 = x3947 - x3976 - x3969 * x4026 + 0.001125;
  const Real x4095 = x3907 + x3992 - x3953 * x4028 + 0.9;
  const Real x4096 = x3906 - x3992 - x3957 * x4029 + 0.9;
  const Real x4097 = x3905 - x3915 * x4030 + 0.9;
  const Real x4079 = cosine[13] * x4000 - sine[13] * tau[18] - x3968 * x4023;
  const Real x4082 = x3969 * x4023 - (sine[13] * x4000 + cosine[13] * tau[18]);
  const Real x4099 = x985 + x4082;
  const Real x4085 = cosine[13] * x3911 + sine[13] * x3912 - x3953 * x4023;
  const Real x4101 = x1000 + x4085;
  const Real x4088 = cosine[13] * x3912 - sine[13] * x3911 - x3957 * x4023;
  const Real x4102 = x4088 - x1005;
  const Real x4103 = x3910 - x3915 * x4023 + x1009;
  // joint 15 "waist_pitch": articulated-body inertia and bias force through it
  const Real x4104 = 0.04 * x4067;
  const Real x4106 = x3966 - x3968 * x4028 - x4104;
  const Real x4109 = -0.018000000000000002 + 0.04 * x4095;
  const Real x4112 = x3928 + x3962 + x3968 * x4029 + 0.04 * x4073;
  const Real x4114 = 0.04 * x4064;
  const Real x4118 = x4093 - 0.04 * x4097;
  // joint 14 "waist_roll": articulated-body inertia and bias force through it
  const Real x4092 = 0.001 + x3976 - x3968 * x4025 + 0.0014025;
  // joint 15 "waist_pitch": articulated-body inertia and bias force through it
  const Real x4124 = x4092 - 0.04 * x4093 - 0.04 * x4118;
  require_more(w, x4124, 0.0, kFactorization, 15);
  const Real x4127 = x3968 * x4026 - sine[13] * x3972 - 0.04 * x4058;
  const Real x4128 = 0.04 * x4106;
  const Real x4130 = 0.04 * x4052;
  const Real x4137 = 0.04 * x4109 + 0.0006825;
  const Real x4148 = sine[14] * x4118 - cosine[14] * x4112;
  const Real x4152 = sine[14] * x4112 + cosine[14] * x4118;
  const Real x4157 = cosine[14] * (x4055 - x4104) + sine[14] * (x4058 + x4114);
  const Real x4158 = sine[14] * x4157;
  const Real x4161 = cosine[14] * x4157;
  const Real x4166 = cosine[14] * x4127 + sine[14] * x4128;
  const Real x4170 = cosine[14] * x4128 - sine[14] * x4127;
  const Real x4173 = 2.0 * sine[14];
  const Real x4175 = cosine[14] * (x4094 - x4137) + x4130 * x4173;
  const Real x4178 = cosine[14] * x4175;
  const Real x4191 = cosine[14] * (x4096 - x4097) + x4073 * x4173;
  const Real x4194 = cosine[14] * x4191;
  const Real x4202 = x997 - tau[19] + 0.04 * x4101;
  const Real x4218 = -tau[20];
  w.to[0][17] = x4218;
  const Real x4219 = 1 / x4124;
  const Real x4222 = x4219 * (x994 + x4079 - 0.04 * x4103 + tau[20]);
  w.x[71] = x4222;
  const Real x4224 = x4166 * x4219;
  w.x[70] = x4224;
  const Real x4225 = x4170 * x4219;
  w.x[69] = x4225;
  const Real x4226 = x4148 * x4219;
  w.x[57] = x4226;
  const Real x4227 = x4152 * x4219;
  w.x[56] = x4227;
  const Real x4228 = x4106 * x4219;
  w.x[55] = x4228;
  const Real x4231 = x4137 + x4178 - x4166 * x4224;
  w.x[54] = x4231;
  w.to[0][0] = x4231;
  const Real x4234 = x4130 - sine[14] * x4175 - x4166 * x4225;
  w.x[53] = x4234;
  w.to[0][1] = x4234;
  const Real x4237 = x4104 + x4161 - x4166 * x4226;
  w.x[52] = x4237;
  w.to[0][2] = x4237;
  const Real x4240 = x4058 - x4158 - x4166 * x4227;
  w.x[51] = x4240;
  w.to[0][3] = x4240;
  const Real x4243 = cosine[14] * x4052 + sine[14] * x4109 - x4166 * x4228;
  w.x[50] = x4243;
  w.to[0][4] = x4243;
  const Real x4246 = x4094 - x4178 - x4170 * x4225;
  w.x[49] = x4246;
  w.to[0][5] = x4246;
  const Real x4249 = x4114 - x4158 - x4170 * x4226;
  w.x[48] = x4249;
  w.to[0][6] = x4249;
  const Real x4252 = x4055 - x4161 - x4170 * x4227;
  w.x[47] = x4252;
  w.to[0][7] = x4252;
  const Real x4255 = cosine[14] * x4109 - sine[14] * x4052 - x4170 * x4228;
  w.x[46] = x4255;
  w.to[0][8] = x4255;
  const Real x4258 = x4097 + x4194 - x4148 * x4226;
  w.x[45] = x4258;
  w.to[0][9] = x4258;
  const Real x4261 = x4073 - sine[14] * x4191 - x4148 * x4227;
  w.x[44] = x4261;
  w.to[0][10] = x4261;
  const Real x4264 = cosine[14] * x4064 + sine[14] * x4067 - x4148 * x4228;
  w.x[43] = x4264;
  w.to[0][11] = x4264;
  const Real x4267 = x4096 - x4194 - x4152 * x4227;
  w.x[42] = x4267;
  w.to[0][12] = x4267;
  const Real x4270 = cosine[14] * x4067 - sine[14] * x4064 - x4152 * x4228;
  w.x[41] = x4270;
  w.to[0][13] = x4270;
  const Real x4273 = x4095 - x4106 * x4228;
  w.x[40] = x4273;
  w.to[0][14] = x4273;
  const Real x4276 = cosine[14] * x4099 + sine[14] * x4202 - x4166 * x4222;
  w.x[39] = x4276;
  w.to[0][15] = x4276;
  const Real x4279 = cosine[14] * x4202 - sine[14] * x4099 - x4170 * x4222;
  w.x[38] = x4279;
  w.to[0][16] = x4279;
  const Real x4282 = cosine[14] * x4102 + sine[14] * x4103 - x4148 * x4222;
  w.x[37] = x4282;
  w.to[0][18] = x4282;
  const Real x4285 = cosine[14] * x4103 - sine[14] * x4102 - x4152 * x4222;
  w.x[36] = x4285;
  w.to[0][19] = x4285;
  const Real x4288 = x4101 - x4106 * x4222;
  w.x[35] = x4288;
  w.to[0][20] = x4288;
}

ADAGEN_NOINLINE void part_0_3(Workspace& w) {
  ADAGEN_INPUTS
  // joint 0 "__base__": placement, velocity and reference acceleration of its link
  const Real x20 = q[3] * q[3] + q[4] * q[4] + q[5] * q[5];
  const Real x21 = q[6] * q[6] + x20;
  require_length(w, x21, 0);
  const Real x24 = 1 / x21 * 2.0;
  const Real x25 = q[3] * x24;
  const Real x26 = q[4] * x24;
  const Real x50 = (q[5] * x25 - q[6] * x26) * 9.81;
  const Real x57 = v[2] * v[4] - v[1] * v[5] + x50;
  w.x[198] = x57;
  const Real x51 = (q[5] * x26 + q[6] * x25) * 9.81;
  const Real x62 = v[0] * v[5] - v[2] * v[3] + x51;
  w.x[197] = x62;
  const Real x52 = (1.0 - (q[4] * x26 + q[3] * x25)) * 9.81;
  const Real x67 = v[1] * v[3] - v[0] * v[4] + x52;
  w.x[190] = x67;
}

ADAGEN_NOINLINE void part_0_4(Workspace& w) {
  ADAGEN_INPUTS
  const Real x57 = w.x[198];
  const Real x62 = w.x[197];
  const Real x67 = w.x[190];
  const Real x1610 = w.x[75];
  const Real x1710 = w.x[76];
  const Real x1711 = w.x[77];
  const Real x1712 = w.x[78];
  const Real x1713 = w.x[79];
  const Real x1714 = w.x[80];
  const Real x1715 = w.x[81];
  const Real x1898 = w.x[103];
  const Real x1899 = w.x[104];
  const Real x1901 = w.x[105];
  const Real x1902 = w.x[106];
  const Real x1903 = w.x[107];
  const Real x1904 = w.x[108];
  const Real x2080 = w.x[109];
  const Real x2081 = w.x[110];
  const Real x2082 = w.x[111];
  const Real x2084 = w.x[112];
  const Real x2085 = w.x[113];
  const Real x2086 = w.x[114];
  const Real x2265 = w.x[115];
  const Real x2266 = w.x[116];
  const Real x2267 = w.x[117];
  const Real x2268 = w.x[118];
  const Real x2269 = w.x[119];
  const Real x2270 = w.x[120];
  const Real x2439 = w.x[121];
  const Real x2440 = w.x[122];
  const Real x2441 = w.x[123];
  const Real x2443 = w.x[124];
  const Real x2444 = w.x[125];
  const Real x2445 = w.x[126];
  const Real x2661 = w.x[154];
  const Real x2748 = w.x[155];
  const Real x2749 = w.x[156];
  const Real x2750 = w.x[157];
  const Real x2751 = w.x[158];
  const Real x2752 = w.x[159];
  const Real x2753 = w.x[160];
  const Real x2936 = w.x[161];
  const Real x2937 = w.x[162];
  const Real x2939 = w.x[163];
  const Real x2940 = w.x[164];
  const Real x2941 = w.x[165];
  const Real x2942 = w.x[166];
  const Real x3118 = w.x[191];
  const Real x3119 = w.x[192];
  const Real x3120 = w.x[193];
  const Real x3122 = w.x[194];
  const Real x3123 = w.x[195];
  const Real x3124 = w.x[196];
  const Real x3303 = w.x[102];
  const Real x3304 = w.x[101];
  const Real x3305 = w.x[100];
  const Real x3306 = w.x[99];
  const Real x3307 = w.x[98];
  const Real x3308 = w.x[97];
  const Real x3472 = w.x[96];
  const Real x3473 = w.x[95];
  const Real x3474 = w.x[94];
  const Real x3475 = w.x[93];
  const Real x3476 = w.x[92];
  const Real x3477 = w.x[91];
  const Real x3832 = w.x[90];
  const Real x3834 = w.x[89];
  const Real x3835 = w.x[88];
  const Real x3836 = w.x[87];
  const Real x3837 = w.x[86];
  const Real x3838 = w.x[85];
  const Real x4023 = w.x[84];
  const Real x4025 = w.x[83];
  const Real x4026 = w.x[82];
  const Real x4028 = w.x[74];
  const Real x4029 = w.x[73];
  const Real x4030 = w.x[72];
  const Real x4222 = w.x[71];
  const Real x4224 = w.x[70];
  const Real x4225 = w.x[69];
  const Real x4226 = w.x[57];
  const Real x4227 = w.x[56];
  const Real x4228 = w.x[55];
  const Real x4231 = w.x[54];
  const Real x4234 = w.x[53];
  const Real x4237 = w.x[52];
  const Real x4240 = w.x[51];
  const Real x4243 = w.x[50];
  const Real x4246 = w.x[49];
  const Real x4249 = w.x[48];
  const Real x4252 = w.x[47];
  const Real x4255 = w.x[46];
  const Real x4258 = w.x[45];
  const Real x4261 = w.x[44];
  const Real x4264 = w.x[43];
  const Real x4267 = w.x[42];
  const Real x4270 = w.x[41];
  const Real x4273 = w.x[40];
  const Real x4276 = w.x[39];
  const Real x4279 = w.x[38];
  const Real x4282 = w.x[37];
  const Real x4285 = w.x[36];
  const Real x4288 = w.x[35];
  // message received
  const Real x4289 = w.from[1][0];
  const Real x4290 = w.from[1][1];
  const Real x4295 = w.from[1][6];
  const Real x4291 = w.from[1][2];
  const Real x4296 = w.from[1][7];
  const Real x4300 = w.from[1][11];
  const Real x4292 = w.from[1][3];
  const Real x4297 = w.from[1][8];
  const Real x4301 = w.from[1][12];
  const Real x4304 = w.from[1][15];
  const Real x4293 = w.from[1][4];
  const Real x4298 = w.from[1][9];
  const Real x4302 = w.from[1][13];
  const Real x4305 = w.from[1][16];
  const Real x4294 = w.from[1][5];
  const Real x4307 = w.from[1][18];
  const Real x4299 = w.from[1][10];
  const Real x4303 = w.from[1][14];
  const Real x4306 = w.from[1][17];
  const Real x4308 = w.from[1][19];
  const Real x4325 = w.from[1][21];
  const Real x4326 = w.from[1][22];
  const Real x4309 = w.from[1][20];
  const Real x4327 = w.from[1][23];
  const Real x4328 = w.from[1][24];
  const Real x4329 = w.from[1][25];
  const Real x4330 = w.from[1][26];
  const Real x4310 = x4231 + x4289;
  require_more(w, x4310, 0.0, kFactorization, 15);
  const Real x4311 = x4234 + x4290;
  const Real x4315 = x4246 + x4295;
  const Real x4312 = x4237 + x4292;
  const Real x4319 = x4258 + x4304;
  const Real x4313 = x4240 + x4293;
  const Real x4314 = x4243 + x4294;
  const Real x4322 = x4267 + x4307;
  const Real x4331 = x4276 + x4325;
  const Real x4324 = x4273 + x4309;
  // link 16 "torso": acceleration from its articulated-body inertia
  const Real x4465 = x4300 * 1.7763568394002505e-15;
  const Real x4337 = 1 / x4310;
  const Real x4464 = x4315 * 1.7763568394002505e-15;
  const Real x4466 = x4319 * 1.7763568394002505e-15;
  const Real x4467 = x4322 * 1.7763568394002505e-15;
  const Real x4468 = x4324 * 1.7763568394002505e-15;
  const Real x4338 = x4311 * x4337;
  const Real x4339 = x4291 * x4337;
  const Real x4340 = x4312 * x4337;
  const Real x4341 = x4313 * x4337;
  const Real x4342 = x4314 * x4337;
  const Real x4345 = x4315 - x4311 * x4338;
  require_more(w, x4345, x4464, kFactorization, 15);
  const Real x4348 = x4296 - x4291 * x4338;
  const Real x4351 = x4249 + x4297 - x4312 * x4338;
  const Real x4354 = x4252 + x4298 - x4313 * x4338;
  const Real x4357 = x4255 + x4299 - x4314 * x4338;
  const Real x4358 = 1 / x4345;
  const Real x4477 = x4331 * x4338 - (x4279 + x4326);
  const Real x4359 = x4348 * x4358;
  const Real x4360 = x4351 * x4358;
  const Real x4361 = x4354 * x4358;
  const Real x4362 = x4357 * x4358;
  const Real x4368 = x4300 - x4291 * x4339 - x4348 * x4359;
  require_more(w, x4368, x4465, kFactorization, 15);
  const Real x4374 = x4301 - x4312 * x4339 - x4351 * x4359;
  const Real x4380 = x4302 - x4313 * x4339 - x4354 * x4359;
  const Real x4386 = x4303 - x4314 * x4339 - x4357 * x4359;
  const Real x4483 = x4331 * x4339 - (x4327 - tau[20]) - x4359 * x4477;
  const Real x4387 = 1 / x4368;
  const Real x4388 = x4374 * x4387;
  const Real x4389 = x4380 * x4387;
  const Real x4390 = x4386 * x4387;
  const Real x4398 = x4319 - x4312 * x4340 - x4351 * x4360;
  const Real x4399 = x4398 - x4374 * x4388;
  require_more(w, x4399, x4466, kFactorization, 15);
  const Real x4407 = x4261 + x4305 - x4313 * x4340 - x4354 * x4360;
  const Real x4408 = x4407 - x4380 * x4388;
  const Real x4430 = x4322 - x4313 * x4341 - x4354 * x4361;
  const Real x4416 = x4264 + x4306 - x4314 * x4340 - x4357 * x4360;
  const Real x4417 = x4416 - x4386 * x4388;
  const Real x4442 = x4270 + x4308 - x4314 * x4341 - x4357 * x4361;
  const Real x4458 = x4324 - x4314 * x4342 - x4357 * x4362;
  const Real x4491 = x4331 * x4340 - (x4282 + x4328) - x4360 * x4477;
  const Real x4492 = x4491 - x4388 * x4483;
  const Real x4502 = x4331 * x4341 - (x4285 + x4329) - x4361 * x4477;
  const Real x4516 = x4331 * x4342 - (x4288 + x4330) - x4362 * x4477;
  const Real x4418 = 1 / x4399;
  const Real x4419 = x4408 * x4418;
  const Real x4420 = x4417 * x4418;
  const Real x4432 = x4430 - x4380 * x4389 - x4408 * x4419;
  require_more(w, x4432, x4467, kFactorization, 15);
  const Real x4444 = x4442 - x4386 * x4389 - x4417 * x4419;
  const Real x4504 = x4502 - x4389 * x4483 - x4419 * x4492;
  const Real x4445 = 1 / x4432;
  const Real x4446 = x4444 * x4445;
  const Real x4460 = x4458 - x4386 * x4390 - x4417 * x4420;
  const Real x4461 = x4460 - x4444 * x4446;
  require_more(w, x4461, x4468, kFactorization, 15);
  const Real x4518 = x4516 - x4390 * x4483 - x4420 * x4492;
  const Real x4526 = 1 / x4461 * (x4518 - x4446 * x4504);
  const Real x4529 = x4445 * x4504 - x4446 * x4526;
  const Real x4535 = x4418 * x4492 - x4420 * x4526 - x4419 * x4529;
  const Real x4543 = x4387 * x4483 - x4390 * x4526 - x4389 * x4529;
  const Real x4544 = x4543 - x4388 * x4535;
  const Real x4554 = x4358 * x4477 - x4362 * x4526 - x4361 * x4529;
  const Real x4569 = x4331 * x4337 + x4342 * x4526 + x4341 * x4529;
  const Real x4556 = x4554 - x4360 * x4535 - x4359 * x4544;
  const Real x4573 = x4340 * x4535 + x4569 + x4339 * x4544;
  const Real x4575 = x4338 * x4556 + x4573;
  // joint 15 "waist_pitch": its acceleration, and that of the link beyond
  const Real x4589 = x4222 + x4228 * x4526 + x4227 * x4529;
  const Real x4610 = cosine[14] * x4535 - sine[14] * x4529;
  const Real x4593 = x4226 * x4535 + x4589 + x4225 * x4556;
  const Real x4595 = x4224 * x4575 - x4593;
  const Real x4601 = cosine[14] * x4575 + sine[14] * x4556;
  const Real x4606 = cosine[14] * x4556 - sine[14] * x4575;
  const Real x4615 = x4526 + 0.04 * x4606;
  const Real x4618 = sine[14] * x4535 + cosine[14] * x4529 - 0.04 * x4595;
  const Real x4619 = -(x4595 - x4544);
  w.result[20] = x4619;
  // joint 14 "waist_roll": its acceleration, and that of the link beyond
  const Real x4645 = cosine[13] * x4595 + sine[13] * x4601;
  const Real x4632 = x4023 + x4029 * x4610 + x4025 * x4595;
  const Real x4659 = x4618 - 0.05 * x4645;
  const Real x4656 = sine[13] * x4615 + cosine[13] * x4610;
  const Real x4636 = x4026 * x4601 + x4632 + x4028 * x4615;
  const Real x4638 = x4030 * x4618 + x4636;
  const Real x4640 = x4606 + x4638;
  w.result[19] = x4640;
  const Real x4662 = cosine[13] * x4615 - sine[13] * x4610 - 0.05 * x4638;
  // joint 13 "waist_yaw": its acceleration, and that of the link beyond
  const Real x4675 = x3832 + x3835 * x4645 + x3836 * x4659;
  const Real x4691 = cosine[12] * x4645 - sine[12] * x4638;
  w.result[4] = x4691;
  const Real x4686 = cosine[12] * x4638 + sine[12] * x4645;
  const Real x4702 = 0.09 * x4686;
  const Real x4679 = x3834 * x4638 - (x3838 * x4656 + x4675);
  const Real x4680 = x4679 - x3837 * x4662;
  w.result[5] = x4680;
  const Real x4687 = -x4686;
  w.result[3] = x4687;
  // joint 1 "left_hip_pitch": its acceleration, and that of the link beyond
  const Real x4715 = x4656 - x4702;
  // joint 7 "right_hip_pitch": its acceleration, and that of the link beyond
  const Real x4917 = x4656 + x4702;
  // joint 0 "__base__": acceleration of the base
  const Real x5119 = x4656 - x67;
  w.result[2] = x5119;
  // joint 13 "waist_yaw": its acceleration, and that of the link beyond
  const Real x4701 = cosine[12] * x4659 - sine[12] * x4662 - 0.09 * x4691;
  const Real x4704 = sine[12] * x4659 + cosine[12] * x4662 - x4702;
  const Real x4705 = -(x4680 - (sine[13] * x4595 - cosine[13] * x4601));
  w.result[18] = x4705;
  // joint 1 "left_hip_pitch": its acceleration, and that of the link beyond
  const Real x4706 = 0.09 * x4680;
  const Real x4719 = cosine[0] * x4680 - sine[0] * x4686;
  const Real x4710 = x4701 - 0.05 * x4691;
  const Real x4724 = sine[0] * x4680 + cosine[0] * x4686;
  const Real x4714 = x4704 - 0.05 * x4686;
  const Real x4711 = x4710 - x4706;
  const Real x4728 = cosine[0] * x4715 + sine[0] * x4711;
  const Real x4732 = cosine[0] * x4711 - sine[0] * x4715;
  const Real x4744 = x3472 - x3473 * x4719 + x3474 * x4724;
  const Real x4746 = x4744 - x3477 * x4714 - x3475 * x4728;
  const Real x4747 = x4746 - x3476 * x4732;
  // joint 2 "left_hip_roll": its acceleration, and that of the link beyond
  const Real x4751 = x4728 - 0.04 * x4724;
  const Real x4754 = x4732 - 0.04 * x4719;
  const Real x4764 = cosine[1] * x4714 + sine[1] * x4751;
  const Real x4768 = cosine[1] * x4751 - sine[1] * x4714;
  const Real x4757 = cosine[1] * x4747 + sine[1] * x4719;
  const Real x4761 = cosine[1] * x4719 - sine[1] * x4747;
  // joint 7 "right_hip_pitch": its acceleration, and that of the link beyond
  const Real x4921 = cosine[6] * x4680 - sine[6] * x4686;
  const Real x4926 = sine[6] * x4680 + cosine[6] * x4686;
  const Real x4916 = x4706 + x4710;
  const Real x4930 = cosine[6] * x4917 + sine[6] * x4916;
  const Real x4934 = cosine[6] * x4916 - sine[6] * x4917;
  const Real x4946 = x2439 - x2440 * x4921 - x2441 * x4926;
  const Real x4948 = x4946 - x2445 * x4714 - x2443 * x4930;
  const Real x4949 = x4948 - x2444 * x4934;
  // joint 8 "right_hip_roll": its acceleration, and that of the link beyond
  const Real x4953 = x4930 + 0.04 * x4926;
  const Real x4955 = x4934 + 0.04 * x4921;
  const Real x4965 = cosine[7] * x4714 + sine[7] * x4953;
  const Real x4969 = cosine[7] * x4953 - sine[7] * x4714;
  const Real x4958 = cosine[7] * x4949 + sine[7] * x4921;
  const Real x4962 = cosine[7] * x4921 - sine[7] * x4949;
  // joint 0 "__base__": acceleration of the base
  const Real x5117 = x4701 - x57;
  w.result[0] = x5117;
  const Real x5118 = x4704 - x62;
  w.result[1] = x5118;
  // joint 1 "left_hip_pitch": its acceleration, and that of the link beyond
  const Real x4748 = x4747 - x4691;
  w.result[6] = x4748;
  // joint 2 "left_hip_roll": its acceleration, and that of the link beyond
  const Real x4780 = x3303 - x3308 * x4754 - x3306 * x4764;
  const Real x4782 = x4780 - x3307 * x4768 - x3304 * x4757;
  const Real x4783 = x4782 - x3305 * x4761;
  const Real x4784 = x4724 + x4783;
  w.result[7] = x4784;
  // joint 3 "left_hip_yaw": its acceleration, and that of the link beyond
  const Real x4789 = x4754 - 0.12 * x4757;
  const Real x4786 = x4764 + 0.12 * x4783;
  const Real x4792 = cosine[2] * x4783 + sine[2] * x4757;
  const Real x4796 = cosine[2] * x4757 - sine[2] * x4783;
  const Real x4799 = cosine[2] * x4789 + sine[2] * x4786;
  const Real x4803 = cosine[2] * x4786 - sine[2] * x4789;
  const Real x4815 = x3118 - x3124 * x4768 - x3119 * x4792;
  const Real x4817 = x3120 * x4796 + x4815 - x3122 * x4799;
  const Real x4818 = x4817 - x3123 * x4803;
  // joint 4 "left_knee": its acceleration, and that of the link beyond
  const Real x4822 = x4799 - 0.24 * x4796;
  const Real x4824 = x4803 + 0.24 * x4792;
  const Real x4834 = cosine[3] * x4768 + sine[3] * x4822;
  const Real x4838 = cosine[3] * x4822 - sine[3] * x4768;
  const Real x4827 = cosine[3] * x4818 + sine[3] * x4792;
  const Real x4831 = cosine[3] * x4792 - sine[3] * x4818;
  // joint 7 "right_hip_pitch": its acceleration, and that of the link beyond
  const Real x4950 = x4949 - x4691;
  w.result[12] = x4950;
  // joint 8 "right_hip_roll": its acceleration, and that of the link beyond
  const Real x4981 = x2265 - x2270 * x4955 - x2268 * x4965;
  const Real x4983 = x4981 - x2269 * x4969 - x2266 * x4958;
  const Real x4984 = x4983 - x2267 * x4962;
  const Real x4985 = x4926 + x4984;
  w.result[13] = x4985;
  // joint 9 "right_hip_yaw": its acceleration, and that of the link beyond
  const Real x4990 = x4955 - 0.12 * x4958;
  const Real x4987 = x4965 + 0.12 * x4984;
  const Real x4993 = cosine[8] * x4984 + sine[8] * x4958;
  const Real x4997 = cosine[8] * x4958 - sine[8] * x4984;
  const Real x5000 = cosine[8] * x4990 + sine[8] * x4987;
  const Real x5004 = cosine[8] * x4987 - sine[8] * x4990;
  const Real x5016 = x2080 - x2086 * x4969 - x2081 * x4993;
  const Real x5018 = x2082 * x4997 + x5016 - x2084 * x5000;
  const Real x5019 = x5018 - x2085 * x5004;
  // joint 10 "right_knee": its acceleration, and that of the link beyond
  const Real x5023 = x5000 - 0.24 * x4997;
  const Real x5025 = x5004 + 0.24 * x4993;
  const Real x5035 = cosine[9] * x4969 + sine[9] * x5023;
  const Real x5039 = cosine[9] * x5023 - sine[9] * x4969;
  // joint 3 "left_hip_yaw": its acceleration, and that of the link beyond
  const Real x4819 = x4818 - x4761;
  w.result[8] = x4819;
  // joint 4 "left_knee": its acceleration, and that of the link beyond
  const Real x4850 = x2936 - x2942 * x4824 - x2940 * x4834;
  const Real x4852 = x4850 - x2941 * x4838 + x2937 * x4827;
  const Real x4853 = x4852 - x2939 * x4831;
  const Real x4854 = x4853 - x4796;
  w.result[9] = x4854;
  // joint 5 "left_ankle_pitch": its acceleration, and that of the link beyond
  const Real x4862 = cosine[4] * x4827 + sine[4] * x4831;
  const Real x4866 = cosine[4] * x4831 - sine[4] * x4827;
  const Real x4859 = x4824 + 0.3 * x4831;
  const Real x4857 = x4838 - 0.3 * x4853;
  const Real x4885 = x2748 - x2749 * x4862 - x2750 * x4866;
  const Real x4869 = cosine[4] * x4834 + sine[4] * x4857;
  const Real x4887 = x4885 - x2753 * x4859 - x2751 * x4869;
  const Real x4888 = x4887 - x2752 * (cosine[4] * x4857 - sine[4] * x4834);
  const Real x4889 = x4888 - x4853;
  w.result[10] = x4889;
  // joint 6 "left_ankle_roll": its acceleration, and that of the link beyond
  const Real x4904 = cosine[5] * (x4859 + 0.02 * x4866) + sine[5] * x4869;
  const Real x4909 = 0.5966849180428403 * (cosine[5] * x4862 - sine[5] * x4888);
  const Real x4915 = x2661 - 19.88949726809468 * x4904 - x4909 - x4866;
  w.result[11] = x4915;
  // joint 9 "right_hip_yaw": its acceleration, and that of the link beyond
  const Real x5020 = x5019 - x4962;
  w.result[14] = x5020;
  // joint 10 "right_knee": its acceleration, and that of the link beyond
  const Real x5028 = cosine[9] * x5019 + sine[9] * x4993;
  const Real x5032 = cosine[9] * x4993 - sine[9] * x5019;
  const Real x5051 = x1898 - x1904 * x5025 - x1902 * x5035;
  const Real x5053 = x5051 - x1903 * x5039 + x1899 * x5028;
  const Real x5054 = x5053 - x1901 * x5032;
  const Real x5055 = x5054 - x4997;
  w.result[15] = x5055;
  // joint 11 "right_ankle_pitch": its acceleration, and that of the link beyond
  const Real x5063 = cosine[10] * x5028 + sine[10] * x5032;
  const Real x5067 = cosine[10] * x5032 - sine[10] * x5028;
  const Real x5060 = x5025 + 0.3 * x5032;
  const Real x5058 = x5039 - 0.3 * x5054;
  const Real x5086 = x1710 - x1711 * x5063 - x1712 * x5067;
  const Real x5070 = cosine[10] * x5035 + sine[10] * x5058;
  const Real x5088 = x5086 - x1715 * x5060 - x1713 * x5070;
  const Real x5089 = x5088 - x1714 * (cosine[10] * x5058 - sine[10] * x5035);
  const Real x5090 = x5089 - x5054;
  w.result[16] = x5090;
  // joint 12 "right_ankle_roll": its acceleration, and that of the link beyond
  const Real x5105 = cosine[11] * (x5060 + 0.02 * x5067) + sine[11] * x5070;
  const Real x5110 = 0.5966849180428403 * (cosine[11] * x5063 - sine[11] * x5089);
  const Real x5116 = x1610 - 19.88949726809468 * x5105 - x5110 - x5067;
  w.result[17] = x5116;
}

// =================================================================================================
// Process 1: 1691 products, 1524 sums, 17 quotients
// =================================================================================================

ADAGEN_NOINLINE void part_1_0(Workspace& w) {
  ADAGEN_INPUTS
  // joint 13 "waist_yaw": placement, velocity and reference acceleration of its link
  const Real x88 = v[3] * cosine[0] + v[4] * sine[0];
  const Real x92 = v[4] * cosine[0] - v[3] * sine[0];
  const Real x93 = v[5] + v[18];
  const Real x94 = v[18] * x92;
  const Real x95 = v[18] * x88;
  const Real x97 = v[3] * v[5] * 0.09;
  const Real x98 = v[4] * v[5] * 0.09;
  // joint 14 "waist_roll": placement, velocity and reference acceleration of its link
  const Real x135 = x92 * cosine[1] + x93 * sine[1];
  const Real x139 = x93 * cosine[1] - x92 * sine[1];
  const Real x140 = x88 + v[19];
  const Real x146 = v[19] * x139 - x95 * cosine[1];
  const Real x149 = x95 * sine[1] - v[19] * x135;
  // joint 13 "waist_yaw": placement, velocity and reference acceleration of its link
  const Real x103 = cosine[0] * x97 + sine[0] * x98;
  const Real x107 = cosine[0] * x98 - sine[0] * x97;
  // joint 14 "waist_roll": placement, velocity and reference acceleration of its link
  const Real x153 = x107 + (x92 * x93 - x94) * 0.05;
  // joint 13 "waist_yaw": placement, velocity and reference acceleration of its link
  const Real x99 = (v[3] * v[3] + v[4] * v[4]) * 0.09;
  // joint 14 "waist_roll": placement, velocity and reference acceleration of its link
  const Real x156 = x99 + (x88 * x88 + x92 * x92) * 0.05;
  // joint 15 "waist_pitch": placement, velocity and reference acceleration of its link
  const Real x196 = x139 * cosine[2] + x140 * sine[2];
  const Real x200 = x140 * cosine[2] - x139 * sine[2];
  const Real x201 = x135 + v[20];
  const Real x210 = x149 * cosine[2] + x94 * sine[2] + v[20] * x200;
  const Real x213 = x94 * cosine[2] - x149 * sine[2] - v[20] * x196;
  // joint 14 "waist_roll": placement, velocity and reference acceleration of its link
  const Real x161 = cosine[1] * x153 - sine[1] * x156;
  // joint 15 "waist_pitch": placement, velocity and reference acceleration of its link
  const Real x215 = x161 + (x135 * x139 - x94) * 0.04;
  const Real x216 = (x135 * x135 + x140 * x140) * 0.04;
  const Real x218 = sine[1] * x153 + cosine[1] * x156 + x216;
  // joint 14 "waist_roll": placement, velocity and reference acceleration of its link
  const Real x151 = x103 + (x88 * x93 - x95) * 0.05;
  // joint 15 "waist_pitch": placement, velocity and reference acceleration of its link
  const Real x221 = x151 + (x146 + x139 * x140) * 0.04;
  const Real x225 = sine[2] * x221 - cosine[2] * x218;
  const Real x229 = sine[2] * x218 + cosine[2] * x221;
  const Real x232 = x196 * x196;
  const Real x233 = x200 * x200;
  const Real x234 = x201 * x201;
  const Real x235 = x233 + x234;
  const Real x237 = x196 * x200;
  const Real x239 = x146 + x237;
  const Real x240 = x232 + x234;
  const Real x242 = x200 * x201;
  const Real x244 = x210 + x242;
  const Real x247 = x196 * x201;
  const Real x248 = x247 - x213;
  // link 16 "torso": force that the reference field takes
  const Real x1794 = x146 * 0.38728300000000004 + x237 * 0.34484970000000004;
  const Real x1777 = x210 * 0.0832833 - x242 * 0.040850000000000004 + x248 * 0.01615;
  const Real x1797 = x1777 + x215 * 0.095;
  w.x[0] = x1797;
  const Real x1787 = x213 * 0.42813300000000004 - x247 * 0.30399970000000004 - x244 * 0.01615;
  const Real x1800 = x1787 - x215 * 1.6150000000000002;
  w.x[1] = x1800;
  const Real x1804 = x1794 - 0.01615 * (x240 - x235) + x229 * 1.6150000000000002;
  const Real x1805 = x1804 - x225 * 0.095;
  w.x[2] = x1805;
  const Real x1810 = (x237 - x146) * 0.095 - x235 * 1.6150000000000002;
  const Real x1811 = x225 * 9.5 + x1810;
  w.x[3] = x1811;
  const Real x1817 = x239 * 1.6150000000000002 - x240 * 0.095 + x229 * 9.5;
  w.x[4] = x1817;
  const Real x1822 = x215 * 9.5 + x248 * 1.6150000000000002 + x244 * 0.095;
  w.x[5] = x1822;
  // joint 16 "left_shoulder_pitch": placement, velocity and reference acceleration of its link
  const Real x259 = x196 * cosine[3] + x200 * sine[3];
  const Real x263 = x200 * cosine[3] - x196 * sine[3];
  const Real x264 = x201 + v[21];
  const Real x273 = x210 * cosine[3] + x213 * sine[3] + v[21] * x263;
  const Real x276 = x213 * cosine[3] - x210 * sine[3] - v[21] * x259;
  const Real x279 = (x213 + x247) * 0.15;
  const Real x280 = x225 - x235 * 0.29;
  const Real x281 = x279 + x280;
  const Real x283 = (x242 - x210) * 0.15;
  const Real x284 = x229 + x239 * 0.29;
  const Real x285 = x283 + x284;
  const Real x286 = x248 * 0.29;
  const Real x287 = (x232 + x233) * 0.15;
  const Real x290 = x215 - x287 + x286;
  const Real x293 = cosine[3] * x281 + sine[3] * x285;
  const Real x297 = cosine[3] * x285 - sine[3] * x281;
  const Real x311 = x263 * x264;
  const Real x312 = x311 - x273;
  const Real x314 = x259 * x259 + x263 * x263;
  const Real x316 = x259 * x264;
  const Real x318 = x276 + x316;
  // link 17 "left_shoulder": force that the reference field takes
  const Real x1150 = x146 * 0.00064;
  w.x[6] = x1150;
  const Real x1154 = x273 * 0.001366667 - x311 * 0.0007266669999999999 - x297 * 0.024;
  w.x[7] = x1154;
  const Real x1156 = x276 * 0.001366667 + x316 * 0.0007266669999999999 + x293 * 0.024;
  w.x[8] = x1156;
  const Real x1159 = x293 * 0.8 + x318 * 0.024;
  w.x[9] = x1159;
  const Real x1162 = x297 * 0.8 + x312 * 0.024;
  w.x[10] = x1162;
  const Real x1166 = x290 * 0.8 - x314 * 0.024;
  w.x[11] = x1166;
  // joint 17 "left_shoulder_roll": placement, velocity and reference acceleration of its link
  const Real x326 = x264 * cosine[4] + x259 * sine[4];
  const Real x330 = x259 * cosine[4] - x264 * sine[4];
  const Real x331 = x263 + v[22];
  const Real x340 = x146 * cosine[4] + x273 * sine[4] + v[22] * x330;
  const Real x343 = x273 * cosine[4] - x146 * sine[4] - v[22] * x326;
  const Real x345 = x293 + 0.05 * x318;
  const Real x347 = x297 + 0.05 * x312;
  const Real x350 = x290 - 0.05 * x314;
  const Real x353 = cosine[4] * x350 + sine[4] * x345;
  const Real x357 = cosine[4] * x345 - sine[4] * x350;
  const Real x362 = x331 * x331;
  const Real x363 = x330 * x330 + x362;
  const Real x365 = x326 * x330;
  const Real x366 = x365 - x276;
  const Real x368 = x326 * x326 + x362;
  const Real x370 = x330 * x331;
  const Real x372 = x340 + x370;
  const Real x375 = x326 * x331;
  const Real x376 = x375 - x343;
  // link 18 "left_shoulder_cap": force that the reference field takes
  const Real x1204 = x276 * 0.0014 - x365 * 0.00056;
  const Real x1188 = x340 * 0.0013299999999999998 + x370 * 0.0006299999999999999 - x376 * 0.00020999999999999998;
  const Real x1208 = x1188 - x347 * 0.020999999999999998;
  w.x[12] = x1208;
  const Real x1196 = x343 * 0.00077 - x375 * 7e-05 + x372 * 0.00020999999999999998;
  const Real x1211 = x1196 - x347 * 0.006999999999999999;
  w.x[13] = x1211;
  const Real x1215 = 0.00020999999999999998 * (x368 - x363) + x1204 + x357 * 0.006999999999999999;
  const Real x1216 = x353 * 0.020999999999999998 + x1215;
  w.x[14] = x1216;
  const Real x1224 = x353 * 0.7 - (x363 * 0.006999999999999999 + x366 * 0.020999999999999998);
  w.x[15] = x1224;
  const Real x1229 = (x276 + x365) * 0.006999999999999999 + x368 * 0.020999999999999998;
  const Real x1230 = x357 * 0.7 + x1229;
  w.x[16] = x1230;
  const Real x1236 = x347 * 0.7 + x376 * 0.006999999999999999 - x372 * 0.020999999999999998;
  w.x[17] = x1236;
  // joint 18 "left_shoulder_yaw": placement, velocity and reference acceleration of its link
  const Real x386 = x331 * cosine[5] + x326 * sine[5];
  const Real x390 = x326 * cosine[5] - x331 * sine[5];
  const Real x391 = x330 + v[23];
  const Real x400 = x276 * cosine[5] + x340 * sine[5] + v[23] * x390;
  const Real x403 = x340 * cosine[5] - x276 * sine[5] - v[23] * x386;
  const Real x407 = x353 - x366 * 0.1;
  const Real x410 = x357 + x368 * 0.1;
  const Real x413 = x347 - x372 * 0.1;
  const Real x416 = cosine[5] * x413 + sine[5] * x407;
  const Real x420 = cosine[5] * x407 - sine[5] * x413;
  const Real x433 = x390 * x391;
  const Real x434 = x433 - x400;
  const Real x436 = x386 * x386 + x390 * x390;
  const Real x438 = x386 * x391;
  const Real x440 = x403 + x438;
  // link 19 "left_upper_arm": force that the reference field takes
  const Real x1253 = x343 * 0.00064;
  w.x[18] = x1253;
  const Real x1257 = x400 * 0.0036266700000000002 - x433 * 0.0029866700000000003 + x420 * 0.04000000000000001;
  w.x[19] = x1257;
  const Real x1260 = x403 * 0.0036266700000000002 + x438 * 0.0029866700000000003 - x416 * 0.04000000000000001;
  w.x[20] = x1260;
  const Real x1264 = x416 * 0.8 - x440 * 0.04000000000000001;
  w.x[21] = x1264;
  const Real x1268 = x420 * 0.8 - x434 * 0.04000000000000001;
  w.x[22] = x1268;
  const Real x1272 = x410 * 0.8 + x436 * 0.04000000000000001;
  w.x[23] = x1272;
  // joint 19 "left_elbow": placement, velocity and reference acceleration of its link
  const Real x449 = x391 * cosine[6] + x386 * sine[6];
  const Real x453 = x386 * cosine[6] - x391 * sine[6];
  const Real x454 = x390 + v[24];
  const Real x463 = x343 * cosine[6] + x400 * sine[6] + v[24] * x453;
  const Real x466 = x400 * cosine[6] - x343 * sine[6] - v[24] * x449;
  const Real x470 = x416 - x440 * 0.11;
  const Real x473 = x420 - x434 * 0.11;
  const Real x476 = x410 + x436 * 0.11;
  const Real x479 = cosine[6] * x476 + sine[6] * x470;
  const Real x483 = cosine[6] * x470 - sine[6] * x476;
  const Real x488 = x454 * x454;
  const Real x489 = x453 * x453 + x488;
  const Real x491 = x449 * x453;
  const Real x492 = x491 - x403;
  const Real x493 = x403 + x491;
  const Real x494 = x449 * x449 + x488;
  const Real x496 = x453 * x454;
  const Real x498 = x463 + x496;
  const Real x501 = x449 * x454;
  const Real x502 = x501 - x466;
  // link 20 "left_forearm": force that the reference field takes
  const Real x1310 = x491 * 0.004428960000000001 + 0.00098 * (x494 - x489);
  const Real x1295 = x463 * 0.00070875 + x496 * 0.00028 - x502 * 0.00098;
  const Real x1313 = x1295 + x473 * 0.013999999999999999;
  w.x[24] = x1313;
  const Real x1304 = x466 * 0.00513771 - x501 * 0.004708960000000001 + x498 * 0.00098;
  const Real x1316 = x1304 + x473 * 0.049;
  w.x[25] = x1316;
  const Real x1321 = x403 * 0.005417710000000001 + x1310 - x483 * 0.049;
  const Real x1322 = x1321 - x479 * 0.013999999999999999;
  w.x[26] = x1322;
  const Real x1328 = x489 * 0.049 + x492 * 0.013999999999999999 + x479 * 0.7;
  w.x[27] = x1328;
  const Real x1336 = x483 * 0.7 - (x493 * 0.049 + x494 * 0.013999999999999999);
  w.x[28] = x1336;
  const Real x1342 = x473 * 0.7 - x502 * 0.049 + x498 * 0.013999999999999999;
  w.x[29] = x1342;
  // joint 20 "left_wrist_roll": placement, velocity and reference acceleration of its link
  const Real x513 = x453 * cosine[7] + x454 * sine[7];
  const Real x517 = x454 * cosine[7] - x453 * sine[7];
  const Real x518 = x449 + v[25];
  const Real x527 = x466 * cosine[7] + x403 * sine[7] + v[25] * x517;
  const Real x530 = x403 * cosine[7] - x466 * sine[7] - v[25] * x513;
  const Real x536 = x489 * 0.16 + x492 * 0.01 + x479;
  const Real x543 = x483 - (x493 * 0.16 + x494 * 0.01);
  const Real x548 = x473 - x502 * 0.16 + x498 * 0.01;
  const Real x551 = cosine[7] * x543 + sine[7] * x548;
  const Real x555 = cosine[7] * x548 - sine[7] * x543;
  const Real x568 = x517 * x518;
  const Real x569 = x568 - x527;
  const Real x571 = x513 * x513 + x517 * x517;
  const Real x573 = x513 * x518;
  const Real x575 = x530 + x573;
  // link 21 "left_wrist": force that the reference field takes
  const Real x1362 = x463 * 9e-05;
  w.x[30] = x1362;
  const Real x1366 = x527 * 0.00010666669999999999 - x568 * 1.666669999999999e-05 + x555 * 0.002;
  w.x[31] = x1366;
  const Real x1369 = x530 * 0.00010666669999999999 + x573 * 1.666669999999999e-05 - x551 * 0.002;
  w.x[32] = x1369;
  const Real x1373 = x551 * 0.2 - x575 * 0.002;
  w.x[33] = x1373;
  const Real x1377 = x555 * 0.2 - x569 * 0.002;
  w.x[34] = x1377;
  const Real x1381 = x536 * 0.2 + x571 * 0.002;
  w.x[35] = x1381;
  // joint 21 "left_wrist_pitch": placement, velocity and reference acceleration of its link
  const Real x584 = x518 * cosine[8] + x513 * sine[8];
  const Real x588 = x513 * cosine[8] - x518 * sine[8];
  const Real x589 = x517 + v[26];
  const Real x601 = x527 * cosine[8] - x463 * sine[8] - v[26] * x584;
  const Real x604 = x551 - 0.04 * x575;
  const Real x607 = x555 - 0.04 * x569;
  const Real x610 = x536 + 0.04 * x571;
  const Real x617 = cosine[8] * x604 - sine[8] * x610;
  const Real x625 = x584 * x588;
  const Real x635 = x584 * x589;
  const Real x598 = x463 * cosine[8] + x527 * sine[8] + v[26] * x588;
  // link 22 "left_hand": force that the reference field takes
  const Real x1396 = x598 * 0.000296667 - x588 * x589 * 0.00013000000000000002;
  w.x[36] = x1396;
  const Real x1411 = x601 * 0.002133333 - x635 * 0.001706666 + x607 * 0.024;
  w.x[37] = x1411;
  const Real x1414 = x530 * 0.002003333 + x625 * 0.0018366659999999998 - x617 * 0.024;
  w.x[38] = x1414;
  const Real x1415 = (cosine[8] * x610 + sine[8] * x604) * 0.4;
  const Real x1418 = x1415 + (x588 * x588 + x589 * x589) * 0.024;
  w.x[39] = x1418;
  const Real x1422 = x617 * 0.4 - (x530 + x625) * 0.024;
  w.x[40] = x1422;
  const Real x1426 = x607 * 0.4 - (x635 - x601) * 0.024;
  w.x[41] = x1426;
  // joint 22 "neck_yaw": placement, velocity and reference acceleration of its link
  const Real x646 = x200 * cosine[9] + x201 * sine[9];
  const Real x650 = x201 * cosine[9] - x200 * sine[9];
  const Real x651 = x196 + v[27];
  const Real x660 = x213 * cosine[9] + x146 * sine[9] + v[27] * x650;
  const Real x663 = x146 * cosine[9] - x213 * sine[9] - v[27] * x646;
  const Real x666 = x225 - x235 * 0.38;
  const Real x668 = x229 + x239 * 0.38;
  const Real x670 = x215 + x248 * 0.38;
  const Real x673 = cosine[9] * x668 + sine[9] * x670;
  const Real x677 = cosine[9] * x670 - sine[9] * x668;
  const Real x690 = x650 * x651;
  const Real x691 = x690 - x660;
  const Real x693 = x646 * x646 + x650 * x650;
  const Real x695 = x646 * x651;
  const Real x697 = x663 + x695;
  // link 23 "neck": force that the reference field takes
  const Real x1444 = x210 * 0.00018;
  w.x[42] = x1444;
  const Real x1448 = x660 * 0.00037000000000000005 - x690 * 0.00019 - x677 * 0.008;
  w.x[43] = x1448;
  const Real x1450 = x663 * 0.00037000000000000005 + x695 * 0.00019 + x673 * 0.008;
  w.x[44] = x1450;
  const Real x1453 = x673 * 0.4 + x697 * 0.008;
  w.x[45] = x1453;
  const Real x1456 = x677 * 0.4 + x691 * 0.008;
  w.x[46] = x1456;
  const Real x1460 = x666 * 0.4 - x693 * 0.008;
  w.x[47] = x1460;
  // joint 23 "neck_pitch": placement, velocity and reference acceleration of its link
  const Real x706 = x651 * cosine[10] + x646 * sine[10];
  const Real x710 = x646 * cosine[10] - x651 * sine[10];
  const Real x711 = x650 + v[28];
  const Real x720 = x210 * cosine[10] + x660 * sine[10] + v[28] * x710;
  const Real x723 = x660 * cosine[10] - x210 * sine[10] - v[28] * x706;
  const Real x725 = x673 + x697 * 0.06;
  const Real x727 = x677 + x691 * 0.06;
  const Real x730 = x666 - x693 * 0.06;
  const Real x733 = cosine[10] * x730 + sine[10] * x725;
  const Real x737 = cosine[10] * x725 - sine[10] * x730;
  const Real x742 = x711 * x711;
  const Real x743 = x710 * x710 + x742;
  const Real x745 = x706 * x710;
  const Real x748 = x706 * x706 + x742;
  const Real x750 = x710 * x711;
  const Real x752 = x720 + x750;
  const Real x755 = x706 * x711;
  const Real x756 = x755 - x723;
  // link 24 "head": force that the reference field takes
  const Real x1497 = x663 * 0.028175999999999996 + x745 * 0.018479999999999996;
  const Real x1481 = x720 * 0.008736 + x750 * 0.00096 + x756 * 0.00432;
  const Real x1500 = x1481 + x727 * 0.048;
  w.x[48] = x1500;
  const Real x1490 = x723 * 0.027215999999999997 - x755 * 0.01944 - x752 * 0.00432;
  const Real x1503 = x1490 - x727 * 0.216;
  w.x[49] = x1503;
  const Real x1507 = x1497 - 0.00432 * (x748 - x743) + x737 * 0.216;
  const Real x1508 = x1507 - x733 * 0.048;
  w.x[50] = x1508;
  const Real x1513 = (x745 - x663) * 0.048 - x743 * 0.216;
  const Real x1514 = x733 * 2.4 + x1513;
  w.x[51] = x1514;
  const Real x1519 = (x663 + x745) * 0.216 - x748 * 0.048;
  const Real x1520 = x737 * 2.4 + x1519;
  w.x[52] = x1520;
  const Real x1525 = x727 * 2.4 + x756 * 0.216 + x752 * 0.048;
  w.x[53] = x1525;
  // joint 24 "right_shoulder_pitch": placement, velocity and reference acceleration of its link
  const Real x766 = x196 * cosine[11] + x200 * sine[11];
  const Real x770 = x200 * cosine[11] - x196 * sine[11];
  const Real x771 = x201 + v[29];
  const Real x780 = x210 * cosine[11] + x213 * sine[11] + v[29] * x770;
  const Real x783 = x213 * cosine[11] - x210 * sine[11] - v[29] * x766;
  const Real x785 = x280 - x279;
  const Real x787 = x284 - x283;
  const Real x789 = x215 + x287 + x286;
  const Real x792 = cosine[11] * x785 + sine[11] * x787;
  const Real x796 = cosine[11] * x787 - sine[11] * x785;
  const Real x809 = x770 * x771;
  const Real x810 = x809 - x780;
  const Real x812 = x766 * x766 + x770 * x770;
  const Real x814 = x766 * x771;
  const Real x816 = x783 + x814;
  // link 25 "right_shoulder": force that the reference field takes
  const Real x1538 = x780 * 0.001366667 - x809 * 0.0007266669999999999 + x796 * 0.024;
  w.x[54] = x1538;
  const Real x1541 = x783 * 0.001366667 + x814 * 0.0007266669999999999 - x792 * 0.024;
  w.x[55] = x1541;
  const Real x1545 = x792 * 0.8 - x816 * 0.024;
  w.x[56] = x1545;
  const Real x1549 = x796 * 0.8 - x810 * 0.024;
  w.x[57] = x1549;
  const Real x1553 = x789 * 0.8 + x812 * 0.024;
  w.x[58] = x1553;
  // joint 25 "right_shoulder_roll": placement, velocity and reference acceleration of its link
  const Real x825 = x771 * cosine[12] + x766 * sine[12];
  const Real x829 = x766 * cosine[12] - x771 * sine[12];
  const Real x830 = x770 + v[30];
  const Real x839 = x146 * cosine[12] + x780 * sine[12] + v[30] * x829;
  const Real x842 = x780 * cosine[12] - x146 * sine[12] - v[30] * x825;
  const Real x845 = x792 - 0.05 * x816;
  const Real x848 = x796 - 0.05 * x810;
  const Real x851 = x789 + 0.05 * x812;
  const Real x854 = cosine[12] * x851 + sine[12] * x845;
  const Real x858 = cosine[12] * x845 - sine[12] * x851;
  const Real x863 = x830 * x830;
  const Real x864 = x829 * x829 + x863;
  const Real x866 = x825 * x829;
  const Real x867 = x866 - x783;
  const Real x869 = x825 * x825 + x863;
  const Real x871 = x829 * x830;
  const Real x873 = x839 + x871;
  const Real x876 = x825 * x830;
  const Real x877 = x876 - x842;
  // link 26 "right_shoulder_cap": force that the reference field takes
  const Real x1575 = x783 * 0.0014 - x866 * 0.00056;
  const Real x1560 = x839 * 0.0013299999999999998 + x871 * 0.0006299999999999999 + x877 * 0.00020999999999999998;
  const Real x1579 = x1560 - x848 * 0.020999999999999998;
  w.x[59] = x1579;
  const Real x1568 = x842 * 0.00077 - x876 * 7e-05 - x873 * 0.00020999999999999998;
  const Real x1582 = x1568 + x848 * 0.006999999999999999;
  w.x[60] = x1582;
  const Real x1587 = x1575 - 0.00020999999999999998 * (x869 - x864) - x858 * 0.006999999999999999;
  const Real x1588 = x854 * 0.020999999999999998 + x1587;
  w.x[61] = x1588;
  const Real x1595 = x864 * 0.006999999999999999 - x867 * 0.020999999999999998 + x854 * 0.7;
  w.x[62] = x1595;
  const Real x1601 = x869 * 0.020999999999999998 - (x783 + x866) * 0.006999999999999999;
  const Real x1602 = x858 * 0.7 + x1601;
  w.x[63] = x1602;
  const Real x1609 = x848 * 0.7 - x877 * 0.006999999999999999 - x873 * 0.020999999999999998;
  w.x[64] = x1609;
  // joint 26 "right_shoulder_yaw": placement, velocity and reference acceleration of its link
  const Real x886 = x830 * cosine[13] + x825 * sine[13];
  const Real x890 = x825 * cosine[13] - x830 * sine[13];
  const Real x891 = x829 + v[31];
  const Real x900 = x783 * cosine[13] + x839 * sine[13] + v[31] * x890;
  const Real x903 = x839 * cosine[13] - x783 * sine[13] - v[31] * x886;
  const Real x906 = x854 - 0.1 * x867;
  const Real x909 = x858 + 0.1 * x869;
  const Real x912 = x848 - 0.1 * x873;
  const Real x915 = cosine[13] * x912 + sine[13] * x906;
  const Real x919 = cosine[13] * x906 - sine[13] * x912;
  const Real x932 = x890 * x891;
  const Real x933 = x932 - x900;
  const Real x935 = x886 * x886 + x890 * x890;
  const Real x937 = x886 * x891;
  const Real x939 = x903 + x937;
  // link 27 "right_upper_arm": force that the reference field takes
  const Real x1619 = x842 * 0.00064;
  w.x[65] = x1619;
  const Real x1623 = x900 * 0.0036266700000000002 - x932 * 0.0029866700000000003 + x919 * 0.04000000000000001;
  w.x[66] = x1623;
  const Real x1626 = x903 * 0.0036266700000000002 + x937 * 0.0029866700000000003 - x915 * 0.04000000000000001;
  w.x[67] = x1626;
  const Real x1630 = x915 * 0.8 - x939 * 0.04000000000000001;
  w.x[68] = x1630;
  const Real x1634 = x919 * 0.8 - x933 * 0.04000000000000001;
  w.x[69] = x1634;
  const Real x1638 = x909 * 0.8 + x935 * 0.04000000000000001;
  w.x[70] = x1638;
  // joint 27 "right_elbow": placement, velocity and reference acceleration of its link
  const Real x947 = x891 * cosine[14] + x886 * sine[14];
  const Real x951 = x886 * cosine[14] - x891 * sine[14];
  const Real x952 = x890 + v[32];
  const Real x961 = x842 * cosine[14] + x900 * sine[14] + v[32] * x951;
  w.x[71] = x961;
  const Real x964 = x900 * cosine[14] - x842 * sine[14] - v[32] * x947;
  const Real x967 = x915 - 0.11 * x939;
  const Real x970 = x919 - 0.11 * x933;
  const Real x973 = x909 + 0.11 * x935;
  const Real x976 = cosine[14] * x973 + sine[14] * x967;
  const Real x980 = cosine[14] * x967 - sine[14] * x973;
  const Real x985 = x952 * x952;
  const Real x986 = x951 * x951 + x985;
  const Real x988 = x947 * x951;
  const Real x989 = x988 - x903;
  const Real x990 = x903 + x988;
  const Real x991 = x947 * x947 + x985;
  const Real x993 = x951 * x952;
  const Real x995 = x961 + x993;
  const Real x998 = x947 * x952;
  const Real x999 = x998 - x964;
  // link 28 "right_forearm": force that the reference field takes
  const Real x1657 = x988 * 0.004428960000000001 + 0.00098 * (x991 - x986);
  const Real x1645 = x961 * 0.00070875 + x993 * 0.00028 - x999 * 0.00098;
  const Real x1660 = x1645 + x970 * 0.013999999999999999;
  w.x[72] = x1660;
  const Real x1652 = x964 * 0.00513771 - x998 * 0.004708960000000001 + x995 * 0.00098;
  const Real x1663 = x1652 + x970 * 0.049;
  w.x[73] = x1663;
  const Real x1668 = x903 * 0.005417710000000001 + x1657 - x980 * 0.049;
  const Real x1669 = x1668 - x976 * 0.013999999999999999;
  w.x[74] = x1669;
  const Real x1675 = x986 * 0.049 + x989 * 0.013999999999999999 + x976 * 0.7;
  w.x[75] = x1675;
  const Real x1683 = x980 * 0.7 - (x990 * 0.049 + x991 * 0.013999999999999999);
  w.x[76] = x1683;
  const Real x1689 = x970 * 0.7 - x999 * 0.049 + x995 * 0.013999999999999999;
  w.x[77] = x1689;
  // joint 28 "right_wrist_roll": placement, velocity and reference acceleration of its link
  const Real x1008 = x951 * cosine[15] + x952 * sine[15];
  w.x[78] = x1008;
  const Real x1012 = x952 * cosine[15] - x951 * sine[15];
  w.x[79] = x1012;
  const Real x1013 = x947 + v[33];
  w.x[80] = x1013;
  const Real x1022 = x964 * cosine[15] + x903 * sine[15] + v[33] * x1012;
  w.x[81] = x1022;
  const Real x1025 = x903 * cosine[15] - x964 * sine[15] - v[33] * x1008;
  w.x[82] = x1025;
  const Real x1030 = 0.16 * x986 + 0.01 * x989 + x976;
  w.x[83] = x1030;
  const Real x1037 = x980 - (0.16 * x990 + 0.01 * x991);
  const Real x1042 = x970 - 0.16 * x999 + 0.01 * x995;
  const Real x1045 = cosine[15] * x1037 + sine[15] * x1042;
  w.x[84] = x1045;
  const Real x1049 = cosine[15] * x1042 - sine[15] * x1037;
  w.x[85] = x1049;
  const Real x1062 = x1012 * x1013;
  const Real x1063 = x1062 - x1022;
  w.x[86] = x1063;
  const Real x1065 = x1008 * x1008 + x1012 * x1012;
  w.x[87] = x1065;
  const Real x1067 = x1008 * x1013;
  const Real x1069 = x1025 + x1067;
  w.x[88] = x1069;
  // link 29 "right_wrist": force that the reference field takes
  const Real x1698 = x1025 * 0.00010666669999999999 + x1067 * 1.666669999999999e-05;
  w.x[89] = x1698;
  const Real x1699 = x961 * 9e-05;
  w.x[90] = x1699;
  const Real x1703 = x1022 * 0.00010666669999999999 - x1062 * 1.666669999999999e-05 + x1049 * 0.002;
  w.x[91] = x1703;
}

ADAGEN_NOINLINE void part_1_1(Workspace& w) {
  ADAGEN_INPUTS
  const Real x961 = w.x[71];
  const Real x1008 = w.x[78];
  const Real x1012 = w.x[79];
  const Real x1013 = w.x[80];
  const Real x1022 = w.x[81];
  const Real x1025 = w.x[82];
  const Real x1030 = w.x[83];
  const Real x1045 = w.x[84];
  const Real x1049 = w.x[85];
  const Real x1063 = w.x[86];
  const Real x1065 = w.x[87];
  const Real x1069 = w.x[88];
  const Real x1150 = w.x[6];
  const Real x1414 = w.x[38];
  const Real x1422 = w.x[40];
  const Real x1444 = w.x[42];
  const Real x1448 = w.x[43];
  const Real x1450 = w.x[44];
  const Real x1453 = w.x[45];
  const Real x1456 = w.x[46];
  const Real x1460 = w.x[47];
  const Real x1500 = w.x[48];
  const Real x1503 = w.x[49];
  const Real x1508 = w.x[50];
  const Real x1514 = w.x[51];
  const Real x1520 = w.x[52];
  const Real x1525 = w.x[53];
  const Real x1538 = w.x[54];
  const Real x1541 = w.x[55];
  const Real x1545 = w.x[56];
  const Real x1549 = w.x[57];
  const Real x1553 = w.x[58];
  const Real x1579 = w.x[59];
  const Real x1582 = w.x[60];
  const Real x1588 = w.x[61];
  const Real x1595 = w.x[62];
  const Real x1602 = w.x[63];
  const Real x1609 = w.x[64];
  const Real x1619 = w.x[65];
  const Real x1623 = w.x[66];
  const Real x1626 = w.x[67];
  const Real x1630 = w.x[68];
  const Real x1634 = w.x[69];
  const Real x1638 = w.x[70];
  const Real x1660 = w.x[72];
  const Real x1663 = w.x[73];
  const Real x1669 = w.x[74];
  const Real x1675 = w.x[75];
  const Real x1683 = w.x[76];
  const Real x1689 = w.x[77];
  const Real x1698 = w.x[89];
  const Real x1699 = w.x[90];
  const Real x1703 = w.x[91];
  const Real x1797 = w.x[0];
  const Real x1800 = w.x[1];
  const Real x1805 = w.x[2];
  const Real x1811 = w.x[3];
  const Real x1817 = w.x[4];
  const Real x1822 = w.x[5];
  // joint 29 "right_wrist_pitch": placement, velocity and reference acceleration of its link
  const Real x1077 = x1013 * cosine[16] + x1008 * sine[16];
  const Real x1081 = x1008 * cosine[16] - x1013 * sine[16];
  const Real x1082 = x1012 + v[34];
  const Real x1094 = x1022 * cosine[16] - x961 * sine[16] - v[34] * x1077;
  const Real x1097 = x1045 - 0.04 * x1069;
  const Real x1100 = x1049 - 0.04 * x1063;
  const Real x1103 = x1030 + 0.04 * x1065;
  const Real x1110 = cosine[16] * x1097 - sine[16] * x1103;
  const Real x1118 = x1077 * x1081;
  const Real x1128 = x1077 * x1082;
  const Real x1091 = x961 * cosine[16] + x1022 * sine[16] + v[34] * x1081;
  // link 30 "right_hand": force that the reference field takes
  const Real x1723 = x1091 * 0.000296667 - x1081 * x1082 * 0.00013000000000000002;
  const Real x1735 = x1094 * 0.002133333 - x1128 * 0.001706666 + x1100 * 0.024;
  const Real x1739 = (cosine[16] * x1103 + sine[16] * x1097) * 0.4;
  const Real x1742 = x1739 + (x1081 * x1081 + x1082 * x1082) * 0.024;
  const Real x1750 = x1100 * 0.4 - (x1128 - x1094) * 0.024;
  const Real x1738 = x1025 * 0.002003333 + x1118 * 0.0018366659999999998 - x1110 * 0.024;
  // joint 29 "right_wrist_pitch": articulated-body inertia and bias force through it
  const Real x1826 = 499.16813630085466 * (tau[34] - x1738);
  w.x[92] = x1826;
  // link 30 "right_hand": force that the reference field takes
  const Real x1746 = x1110 * 0.4 - (x1025 + x1118) * 0.024;
  // joint 29 "right_wrist_pitch": articulated-body inertia and bias force through it
  const Real x1833 = x1746 - 0.024 * x1826;
  const Real x1834 = sine[16] * 0.024;
  const Real x1836 = cosine[16] * 0.024;
  const Real x1840 = cosine[16] * 0.0018366659999999998;
  const Real x1844 = cosine[16] * x1840;
  const Real x1848 = cosine[16] * 0.28752084650929227;
  const Real x1849 = sine[16] * x1848;
  const Real x1851 = cosine[16] * x1848;
  const Real x1853 = 0.4 - x1851;
  const Real x1854 = 0.04 * x1853;
  const Real x1858 = x1836 + 0.016;
  const Real x1859 = 0.04 * x1849;
  const Real x1869 = sine[16] * x1840 + 0.04 * x1834;
  const Real x1886 = sine[16] * x1742 + cosine[16] * x1833;
  const Real x1866 = 0.000296667 + x1844 + 0.04 * x1836 + 0.04 * x1858;
  const Real x1895 = 0.00010666669999999999 + 0.04 * x1854;
  const Real x1896 = -0.002 - x1854;
  const Real x1897 = 0.002133333 - x1844 + 9e-05;
  require_more(w, x1897, 0.0, kFactorization, 28);
  const Real x1898 = 0.2 + x1853;
  const Real x1900 = 0.11247915349070774 + x1851 + 0.2;
  const Real x1889 = sine[16] * x1723 + cosine[16] * x1735 + 0.04 * x1750;
  const Real x1902 = x1698 - x1045 * 0.002 + (tau[34] - 0.04 * x1886);
  const Real x1904 = x1045 * 0.2 - x1069 * 0.002 + x1886;
  // link 29 "right_wrist": force that the reference field takes
  const Real x1718 = x1030 * 0.2 + x1065 * 0.002;
  // joint 29 "right_wrist_pitch": articulated-body inertia and bias force through it
  const Real x1906 = cosine[16] * x1742 - sine[16] * x1833 + x1718;
  // joint 28 "right_wrist_roll": articulated-body inertia and bias force through it
  const Real x1908 = 1 / x1897;
  const Real x1909 = tau[33] - (cosine[16] * x1723 - sine[16] * x1735 + x1699);
  const Real x1910 = x1908 * x1909;
  w.x[93] = x1910;
  const Real x1911 = x1869 * x1908;
  w.x[94] = x1911;
  const Real x1913 = x1834 * x1908;
  w.x[95] = x1913;
  const Real x1917 = 0.00010666669999999999 + x1866 - x1869 * x1911;
  const Real x1920 = 0.002 + x1858 - x1869 * x1913;
  const Real x1923 = 0.6000000000000001 - x1834 * x1913;
  const Real x1926 = x1703 + x1889 - x1869 * x1910;
  // joint 29 "right_wrist_pitch": articulated-body inertia and bias force through it
  const Real x1905 = x1049 * 0.2 - x1063 * 0.002 + x1750;
  // joint 28 "right_wrist_roll": articulated-body inertia and bias force through it
  const Real x1929 = x1905 - x1834 * x1910;
  const Real x1932 = cosine[15] * x1859;
  const Real x1935 = sine[15] * (x1896 + x1920);
  const Real x1937 = sine[15] * x1935;
  const Real x1939 = x1920 - x1937;
  const Real x1940 = x1896 - x1937;
  const Real x1941 = cosine[15] * x1935;
  const Real x1944 = cosine[15] * (x1917 - x1895);
  const Real x1949 = cosine[15] * x1944;
  const Real x1952 = cosine[15] * x1849;
  const Real x1953 = sine[15] * x1849;
  const Real x1955 = cosine[15] * (x1898 - x1923);
  const Real x1956 = sine[15] * x1955;
  const Real x1958 = cosine[15] * x1955;
  const Real x1959 = x1923 + x1958;
  const Real x1960 = x1898 - x1958;
  const Real x1961 = 0.01 * x1953;
  const Real x1964 = sine[15] * x1859 + 0.16 * x1953;
  const Real x1971 = x1932 + 0.16 * x1952 + 0.01 * x1900;
  const Real x1973 = 0.01 * x1956;
  const Real x1974 = 0.16 * x1956;
  const Real x1976 = x1974 - x1941;
  const Real x1982 = x1940 - 0.01 * x1952 - 0.16 * x1959;
  const Real x1983 = 0.01 * x1960;
  const Real x1986 = x1939 + 0.16 * x1960;
  const Real x1989 = x1941 - x1961 - x1974;
  const Real x2001 = 0.01 * x1941 - 0.01 * x1961 - 0.16 * x1973;
  const Real x2015 = sine[15] * x1944 - 0.01 * x1964 + 0.16 * x1941;
  const Real x2016 = x2015 - 0.16 * x1976;
  const Real x2026 = x1917 - x1949 + (0.01 * x1932 + 0.01 * x1971);
  const Real x2039 = cosine[15] * x1904 - sine[15] * x1929;
  const Real x2042 = sine[15] * x1904 + cosine[15] * x1929;
  const Real x2035 = sine[15] * x1926 + cosine[15] * x1902;
  const Real x2007 = x1895 + x1949 + 0.16 * x1939 + 0.16 * x1986;
  const Real x2060 = x2026 - 0.16 * x1940 - 0.16 * x1982 + 0.005417710000000001;
  require_more(w, x2060, 0.0, kFactorization, 27);
  const Real x2061 = -0.013999999999999999 - x1971;
  const Real x2062 = -0.049 + x1982;
  const Real x2047 = cosine[15] * x1926 - sine[15] * x1902 + 0.16 * x2042;
  // joint 27 "right_elbow": articulated-body inertia and bias force through it
  const Real x2073 = 1 / x2060;
  // joint 28 "right_wrist_roll": articulated-body inertia and bias force through it
  const Real x2068 = x2035 - (0.16 * x2039 + 0.01 * x1906) + x1669;
  // joint 27 "right_elbow": articulated-body inertia and bias force through it
  const Real x2075 = x2073 * (tau[32] - x2068);
  w.x[96] = x2075;
  const Real x2076 = x2001 * x2073;
  w.x[97] = x2076;
  const Real x2077 = x2016 * x2073;
  w.x[98] = x2077;
  const Real x2078 = x2061 * x2073;
  w.x[99] = x2078;
  const Real x2079 = x2062 * x2073;
  w.x[100] = x2079;
  const Real x2080 = x1989 * x2073;
  w.x[101] = x2080;
  const Real x2083 = 0.00070875 + 0.01 * x1983 - x2001 * x2076;
  // joint 28 "right_wrist_roll": articulated-body inertia and bias force through it
  const Real x2056 = 0.01 * x1939 + 0.16 * x1983 + 0.00098;
  // joint 27 "right_elbow": articulated-body inertia and bias force through it
  const Real x2086 = x2056 - x2001 * x2077;
  const Real x2089 = x1961 - x2001 * x2078;
  const Real x2092 = x1973 - x2001 * x2079;
  const Real x2095 = 0.013999999999999999 + x1983 - x2001 * x2080;
  const Real x2098 = 0.00513771 + x2007 - x2016 * x2077;
  const Real x2101 = x1964 - x2016 * x2078;
  const Real x2104 = x1976 - x2016 * x2079;
  const Real x2107 = 0.049 + x1986 - x2016 * x2080;
  const Real x2110 = 0.7 + x1900 - x2061 * x2078;
  const Real x2113 = x1952 - x2061 * x2079;
  const Real x2116 = x1953 - x2061 * x2080;
  const Real x2119 = 0.7 + x1959 - x2062 * x2079;
  const Real x2122 = x1956 - x2062 * x2080;
  const Real x2125 = 0.7 + x1960 - x1989 * x2080;
  const Real x2127 = tau[33] + 0.01 * x2042 + x1660 + x2001 * x2075;
  const Real x2129 = x1663 + x2047 + x2016 * x2075;
  const Real x2131 = x1675 + x1906 + x2061 * x2075;
  const Real x2133 = x1683 + x2039 + x2062 * x2075;
  const Real x2135 = x1689 + x2042 + x1989 * x2075;
  const Real x2139 = cosine[14] * x2095 - sine[14] * x2107;
  const Real x2142 = sine[14] * x2095 + cosine[14] * x2107;
  const Real x2148 = cosine[14] * (x2089 - x2104) - sine[14] * (x2092 + x2101);
  const Real x2149 = sine[14] * x2148;
  const Real x2151 = x2092 + x2149;
  const Real x2153 = cosine[14] * x2148;
  const Real x2154 = x2104 + x2153;
  const Real x2158 = 2.0 * sine[14];
  const Real x2162 = cosine[14] * (x2083 - x2098) - x2086 * x2158;
  const Real x2166 = cosine[14] * x2162;
  const Real x2172 = cosine[14] * x2116 - sine[14] * x2122;
  const Real x2175 = sine[14] * x2116 + cosine[14] * x2122;
  const Real x2180 = cosine[14] * (x2110 - x2119) - x2113 * x2158;
  const Real x2183 = x2113 + sine[14] * x2180;
  const Real x2184 = cosine[14] * x2180;
  const Real x2186 = x2110 - x2184;
  const Real x2187 = 0.11 * x2175;
  const Real x2189 = x2089 - x2153 + x2187;
  const Real x2190 = 0.11 * x2186;
  const Real x2194 = x2142 + 0.11 * x2125;
  const Real x2210 = x2086 + sine[14] * x2162 + 0.11 * x2139;
  const Real x2213 = 0.11 * x2151;
  const Real x2228 = sine[14] * x2131 + cosine[14] * x2133;
  const Real x2205 = x2083 - x2166 + (0.11 * x2142 + 0.11 * x2194);
  const Real x2239 = x2098 + x2166 + 0.00064;
  require_more(w, x2239, 0.0, kFactorization, 26);
  const Real x2231 = sine[14] * x2127 + cosine[14] * x2129 + 0.11 * x2135;
  // joint 26 "right_shoulder_yaw": articulated-body inertia and bias force through it
  const Real x2250 = 1 / x2239;
  const Real x2251 = tau[31] - (cosine[14] * x2127 - sine[14] * x2129 + x1619);
  const Real x2252 = x2250 * x2251;
  w.x[102] = x2252;
  const Real x2253 = x2210 * x2250;
  w.x[103] = x2253;
  const Real x2254 = x2213 * x2250;
  w.x[104] = x2254;
  const Real x2256 = x2151 * x2250;
  w.x[105] = x2256;
  const Real x2257 = x2139 * x2250;
  w.x[106] = x2257;
  const Real x2258 = x2154 * x2250;
  w.x[107] = x2258;
  const Real x2261 = 0.0036266700000000002 + x2205 - x2210 * x2253;
  const Real x2264 = x2210 * x2254 - 0.11 * x2189;
  const Real x2267 = x2189 - x2210 * x2256;
  const Real x2270 = 0.04000000000000001 + x2194 - x2210 * x2257;
  const Real x2273 = x2101 + x2149 + 0.11 * x2172 - x2210 * x2258;
  const Real x2276 = 0.0036266700000000002 + 0.11 * x2190 - x2213 * x2254;
  const Real x2279 = -0.04000000000000001 - x2190 + x2213 * x2256;
  const Real x2282 = x2213 * x2257 - x2187;
  const Real x2285 = x2213 * x2258 - 0.11 * x2183;
  const Real x2288 = 0.8 + x2186 - x2151 * x2256;
  const Real x2291 = x2175 - x2151 * x2257;
  const Real x2294 = x2183 - x2151 * x2258;
  const Real x2297 = 0.8 + x2125 - x2139 * x2257;
  const Real x2300 = x2172 - x2139 * x2258;
  const Real x2305 = x1623 + x2231 + x2210 * x2252;
  const Real x2308 = tau[32] - 0.11 * x2228 + x1626 - x2213 * x2252;
  const Real x2310 = x1630 + x2228 + x2151 * x2252;
  const Real x2312 = x1634 + x2135 + x2139 * x2252;
  // joint 27 "right_elbow": articulated-body inertia and bias force through it
  const Real x2248 = cosine[14] * x2131 - sine[14] * x2133 + x1638;
  // joint 26 "right_shoulder_yaw": articulated-body inertia and bias force through it
  const Real x2327 = cosine[13] * (x2267 - x2282) - sine[13] * (x2270 + x2279);
  const Real x2328 = sine[13] * x2327;
  const Real x2330 = x2270 + x2328;
  const Real x2331 = x2279 + x2328;
  const Real x2332 = cosine[13] * x2327;
  const Real x2333 = x2282 + x2332;
  const Real x2337 = 2.0 * sine[13];
  const Real x2341 = cosine[13] * (x2261 - x2276) - x2264 * x2337;
  const Real x2345 = cosine[13] * x2341;
  const Real x2351 = cosine[13] * x2294 - sine[13] * x2300;
  const Real x2354 = sine[13] * x2294 + cosine[13] * x2300;
  const Real x2359 = cosine[13] * (x2288 - x2297) - x2291 * x2337;
  const Real x2362 = x2291 + sine[13] * x2359;
  const Real x2363 = cosine[13] * x2359;
  const Real x2364 = x2297 + x2363;
  const Real x2365 = x2288 - x2363;
  const Real x2366 = 0.1 * x2362;
  const Real x2368 = x2267 - x2332 - x2366;
  const Real x2371 = x2330 + 0.1 * x2365;
  const Real x2380 = x2331 - 0.1 * x2364;
  const Real x2381 = x2333 + x2366;
  const Real x2392 = x2264 + sine[13] * x2341 - 0.1 * x2333;
  const Real x2393 = 0.1 * x2368 + x2392;
  const Real x2410 = cosine[13] * x2310 - sine[13] * x2312;
  const Real x2413 = sine[13] * x2310 + cosine[13] * x2312;
  const Real x2387 = x2261 - x2345 - 0.1 * x2331 - 0.1 * x2380;
  const Real x2399 = x2276 + x2345 + 0.1 * x2330 + 0.1 * x2371;
  const Real x2422 = 0.0014 + x2399;
  require_more(w, x2422, 0.0, kFactorization, 25);
  const Real x2423 = 0.020999999999999998 + x2371;
  const Real x2377 = cosine[13] * x2273 - sine[13] * x2285 + 0.1 * x2354;
  const Real x2424 = -0.006999999999999999 + x2377;
  const Real x2416 = sine[13] * x2305 + cosine[13] * x2308 - 0.1 * x2410;
  const Real x2429 = x1582 + tau[31];
  const Real x2419 = cosine[13] * x2305 - sine[13] * x2308 + 0.1 * x2413;
  // joint 25 "right_shoulder_roll": articulated-body inertia and bias force through it
  const Real x2435 = 1 / x2422;
  const Real x2437 = x2435 * (tau[30] - (x1588 + x2419));
  w.x[108] = x2437;
  const Real x2438 = x2393 * x2435;
  w.x[109] = x2438;
  const Real x2439 = x2423 * x2435;
  w.x[110] = x2439;
  const Real x2440 = x2424 * x2435;
  w.x[111] = x2440;
  const Real x2441 = x2381 * x2435;
  w.x[112] = x2441;
  const Real x2444 = 0.0013299999999999998 + x2387 - x2393 * x2438;
  const Real x2447 = x2368 - x2393 * x2439;
  // joint 26 "right_shoulder_yaw": articulated-body inertia and bias force through it
  const Real x2374 = sine[13] * x2273 + cosine[13] * x2285 - 0.1 * x2351;
  // joint 25 "right_shoulder_roll": articulated-body inertia and bias force through it
  const Real x2450 = x2374 - x2393 * x2440;
  const Real x2453 = -0.020999999999999998 + x2380 - x2393 * x2441;
  const Real x2456 = 0.7 + x2365 - x2423 * x2439;
  const Real x2459 = x2354 - x2423 * x2440;
  const Real x2462 = x2362 - x2423 * x2441;
  // joint 26 "right_shoulder_yaw": articulated-body inertia and bias force through it
  const Real x2426 = x2119 + x2184 + 0.8 - x2154 * x2258 + 0.7;
  // joint 25 "right_shoulder_roll": articulated-body inertia and bias force through it
  const Real x2465 = x2426 - x2424 * x2440;
  const Real x2468 = x2351 - x2424 * x2441;
  const Real x2471 = 0.7 + x2364 - x2381 * x2441;
  const Real x2473 = x1579 + x2416 + x2393 * x2437;
  const Real x2475 = x1595 + x2413 + x2423 * x2437;
  const Real x2477 = x2248 + x2154 * x2252 + x1602 + x2424 * x2437;
  const Real x2479 = x1609 + x2410 + x2381 * x2437;
  const Real x2483 = cosine[12] * x2453 - sine[12] * 0.006999999999999999;
  const Real x2486 = sine[12] * x2453 + cosine[12] * 0.006999999999999999;
  const Real x2490 = cosine[12] * x2447 - sine[12] * x2450;
  const Real x2491 = sine[12] * x2490;
  const Real x2493 = x2450 + x2491;
  const Real x2494 = cosine[12] * x2490;
  const Real x2498 = 2.0 * sine[12];
  const Real x2502 = cosine[12] * (x2444 - 0.00077) + 0.00020999999999999998 * x2498;
  const Real x2506 = cosine[12] * x2502;
  const Real x2512 = cosine[12] * x2462 - sine[12] * x2468;
  const Real x2515 = sine[12] * x2462 + cosine[12] * x2468;
  const Real x2520 = cosine[12] * (x2456 - x2465) - x2459 * x2498;
  const Real x2523 = x2459 + sine[12] * x2520;
  const Real x2524 = cosine[12] * x2520;
  const Real x2526 = x2456 - x2524;
  const Real x2527 = 0.05 * x2515;
  const Real x2529 = x2447 - x2494 + x2527;
  const Real x2530 = 0.05 * x2526;
  const Real x2534 = x2486 + 0.05 * x2471;
  const Real x2550 = -0.00020999999999999998 + sine[12] * x2502 + 0.05 * x2483;
  const Real x2553 = 0.05 * x2493;
  const Real x2568 = sine[12] * x2475 + cosine[12] * x2477;
  const Real x2545 = x2444 - x2506 + (0.05 * x2486 + 0.05 * x2534);
  const Real x2579 = 0.00077 + x2506 + 0.00064;
  require_more(w, x2579, 0.0, kFactorization, 24);
  const Real x2571 = sine[12] * x2473 + cosine[12] * x2429 + 0.05 * x2479;
  // joint 24 "right_shoulder_pitch": articulated-body inertia and bias force through it
  const Real x2590 = 1 / x2579;
  const Real x2591 = tau[29] - (cosine[12] * x2473 - sine[12] * x2429 + x1150);
  const Real x2592 = x2590 * x2591;
  w.x[113] = x2592;
  const Real x2593 = x2550 * x2590;
  w.x[114] = x2593;
  const Real x2594 = x2553 * x2590;
  w.x[115] = x2594;
  const Real x2596 = x2493 * x2590;
  w.x[116] = x2596;
  const Real x2597 = x2483 * x2590;
  w.x[117] = x2597;
  const Real x2598 = x2494 * x2590;
  w.x[118] = x2598;
  const Real x2601 = 0.001366667 + x2545 - x2550 * x2593;
  const Real x2604 = x2550 * x2594 - 0.05 * x2529;
  const Real x2607 = x2529 - x2550 * x2596;
  const Real x2610 = 0.024 + x2534 - x2550 * x2597;
  const Real x2613 = x2491 + 0.05 * x2512 - x2550 * x2598;
  const Real x2616 = 0.001366667 + 0.05 * x2530 - x2553 * x2594;
  const Real x2619 = -0.024 - x2530 + x2553 * x2596;
  const Real x2622 = x2553 * x2597 - x2527;
  const Real x2625 = x2553 * x2598 - 0.05 * x2523;
  const Real x2628 = 0.8 + x2526 - x2493 * x2596;
  const Real x2631 = x2515 - x2493 * x2597;
  const Real x2634 = x2523 - x2493 * x2598;
  const Real x2637 = 0.8 + x2471 - x2483 * x2597;
  const Real x2640 = x2512 - x2483 * x2598;
  const Real x2643 = x2465 + x2524 + 0.8 - x2494 * x2598;
  const Real x2645 = x1538 + x2571 + x2550 * x2592;
  const Real x2648 = tau[30] - 0.05 * x2568 + x1541 - x2553 * x2592;
  const Real x2650 = x1545 + x2568 + x2493 * x2592;
  const Real x2652 = x1549 + x2479 + x2483 * x2592;
  // joint 25 "right_shoulder_roll": articulated-body inertia and bias force through it
  const Real x2588 = cosine[12] * x2475 - sine[12] * x2477 + x1553;
  // joint 24 "right_shoulder_pitch": articulated-body inertia and bias force through it
  const Real x2654 = x2588 + x2494 * x2592;
  const Real x2661 = sine[11] * x2613 + cosine[11] * x2625;
  const Real x2667 = cosine[11] * (x2607 - x2622) - sine[11] * (x2610 + x2619);
  const Real x2668 = sine[11] * x2667;
  const Real x2670 = x2610 + x2668;
  const Real x2671 = x2619 + x2668;
  const Real x2672 = cosine[11] * x2667;
  const Real x2674 = x2607 - x2672;
  const Real x2677 = 2.0 * sine[11];
  const Real x2681 = cosine[11] * (x2601 - x2616) - x2604 * x2677;
  const Real x2685 = cosine[11] * x2681;
  const Real x2691 = cosine[11] * x2634 - sine[11] * x2640;
  const Real x2694 = sine[11] * x2634 + cosine[11] * x2640;
  const Real x2699 = cosine[11] * (x2628 - x2637) - x2631 * x2677;
  const Real x2702 = x2631 + sine[11] * x2699;
  const Real x2703 = cosine[11] * x2699;
  const Real x2704 = x2637 + x2703;
  const Real x2705 = x2628 - x2703;
  const Real x2706 = 0.15 * x2702;
  const Real x2708 = x2622 + x2672 + x2706;
  w.x[119] = x2708;
  const Real x2714 = x2671 - 0.29 * x2691 - 0.15 * x2704;
  const Real x2718 = x2670 + 0.15 * x2705;
  w.x[120] = x2718;
  const Real x2719 = 0.29 * x2694;
  const Real x2722 = x2674 - x2719 - x2706;
  const Real x2723 = 0.29 * x2705;
  const Real x2726 = cosine[11] * x2613 - sine[11] * x2625 + 0.15 * x2694;
  const Real x2732 = x2661 - 0.29 * x2643 - 0.15 * x2691;
  const Real x2745 = x2604 + sine[11] * x2681 - 0.29 * x2726;
  const Real x2748 = 0.29 * x2718;
  w.x[121] = x2748;
  const Real x2758 = x2601 - x2685 - 0.29 * x2661 - 0.29 * x2732;
  const Real x2773 = cosine[11] * x2650 - sine[11] * x2652;
  const Real x2776 = sine[11] * x2650 + cosine[11] * x2652;
  const Real x2784 = sine[11] * x2645 + cosine[11] * x2648 - 0.29 * x2654;
  const Real x2738 = x2616 + x2685 + 0.15 * x2670 + 0.15 * x2718;
  const Real x2788 = 0.0832833 + x2738;
  w.x[122] = x2788;
  const Real x2789 = 0.15 * x2674 + x2745 - 0.15 * x2708 + -0.01615;
  w.x[123] = x2789;
  const Real x2790 = 0.095 + x2726;
  w.x[124] = x2790;
  const Real x2779 = cosine[11] * x2645 - sine[11] * x2648 + 0.15 * x2776;
  // joint 23 "neck_pitch": articulated-body inertia and bias force through it
  const Real x2808 = 35.49119818285065 * (tau[28] - x1508);
  w.x[125] = x2808;
  const Real x2821 = x1514 - 0.048 * x2808;
  const Real x2823 = x1520 + 0.216 * x2808;
  const Real x2827 = cosine[10] * 0.048 + sine[10] * 0.216;
  const Real x2831 = sine[10] * 0.048 - cosine[10] * 0.216;
  const Real x2832 = 2.0 * sine[10];
  const Real x2839 = 0.00432 * x2832 - cosine[10] * 0.018479999999999996;
  const Real x2843 = cosine[10] * x2839;
  const Real x2850 = cosine[10] * 1.574105621805792 - 0.3679727427597956 * x2832;
  const Real x2853 = 0.3679727427597956 + sine[10] * x2850;
  const Real x2854 = cosine[10] * x2850;
  const Real x2856 = 2.318228279386712 - x2854;
  const Real x2857 = 0.06 * x2856;
  const Real x2860 = x2831 + -0.144;
  const Real x2861 = 0.06 * x2853;
  const Real x2871 = -0.00432 + sine[10] * x2839 - 0.06 * x2827;
  const Real x2886 = sine[10] * x2821 + cosine[10] * x2823;
  const Real x2868 = 0.008736 - x2843 - (0.06 * x2831 + 0.06 * x2860);
  const Real x2894 = 0.00037000000000000005 + 0.06 * x2857;
  const Real x2895 = 0.008 + x2857;
  const Real x2896 = 0.027215999999999997 + x2843 + 0.00018;
  require_more(w, x2896, 0.0, kFactorization, 22);
  const Real x2897 = 0.4 + x2856;
  const Real x2889 = sine[10] * x1500 + cosine[10] * x1503 - 0.06 * x1525;
  const Real x2901 = tau[28] + 0.06 * x2886 + x1450;
  const Real x2903 = x1453 + x2886;
  // joint 22 "neck_yaw": articulated-body inertia and bias force through it
  const Real x2907 = 1 / x2896;
  const Real x2908 = tau[27] - (cosine[10] * x1500 - sine[10] * x1503 + x1444);
  const Real x2909 = x2907 * x2908;
  w.x[126] = x2909;
  const Real x2910 = x2871 * x2907;
  w.x[127] = x2910;
  const Real x2911 = x2827 * x2907;
  w.x[128] = x2911;
  const Real x2914 = 0.00037000000000000005 + x2868 - x2871 * x2910;
  const Real x2917 = -0.008 + x2860 - x2871 * x2911;
  const Real x2920 = 2.8 - x2827 * x2911;
  const Real x2922 = x1448 + x2889 + x2871 * x2909;
  const Real x2924 = x1456 + x1525 + x2827 * x2909;
  const Real x2929 = sine[9] * (x2895 + x2917);
  const Real x2931 = sine[9] * x2929;
  const Real x2933 = x2917 - x2931;
  const Real x2934 = x2895 - x2931;
  const Real x2935 = cosine[9] * x2929;
  const Real x2938 = cosine[9] * (x2914 - x2894);
  const Real x2943 = cosine[9] * x2938;
  const Real x2946 = cosine[9] * x2853;
  const Real x2947 = sine[9] * x2853;
  const Real x2949 = cosine[9] * (x2897 - x2920);
  const Real x2950 = sine[9] * x2949;
  const Real x2952 = cosine[9] * x2949;
  const Real x2953 = x2920 + x2952;
  const Real x2954 = x2897 - x2952;
  const Real x2963 = x2935 + 0.38 * x2950;
  const Real x2966 = x2934 + 0.38 * x2953;
  const Real x2969 = x2933 - 0.38 * x2954;
  const Real x2996 = cosine[9] * x2903 - sine[9] * x2924;
  const Real x2999 = sine[9] * x2903 + cosine[9] * x2924;
  // joint 24 "right_shoulder_pitch": articulated-body inertia and bias force through it
  const Real x2791 = x2758 - 0.15 * x2671 - 0.15 * x2714 + 0.42813300000000004;
  // joint 22 "neck_yaw": articulated-body inertia and bias force through it
  const Real x2975 = x2894 + x2943 - 0.38 * x2933 - 0.38 * x2969;
  const Real x3005 = x2791 + x2975;
  w.x[129] = x3005;
  const Real x2981 = sine[9] * x2938 - 0.38 * x2935 - 0.38 * x2963;
  const Real x3006 = 0.29 * x2722 + x2981;
  w.x[130] = x3006;
  const Real x3007 = x2714 - (sine[9] * x2861 + 0.38 * x2947);
  w.x[131] = x3007;
  const Real x3008 = x2722 - x2963;
  w.x[132] = x3008;
  const Real x3009 = -1.6150000000000002 + x2732 + x2969;
  w.x[133] = x3009;
  const Real x2985 = x2914 - x2943 + 0.38 * x2934 + 0.38 * x2966;
  const Real x3010 = 0.38728300000000004 + 0.29 * x2723 + x2985;
  w.x[134] = x3010;
  const Real x2960 = cosine[9] * x2861 + 0.38 * x2946;
  const Real x3011 = -0.095 + 0.29 * x2702 + x2960;
  w.x[135] = x3011;
  const Real x3012 = 1.6150000000000002 + x2723 + x2966;
  w.x[136] = x3012;
  const Real x3013 = x2719 + x2963;
  w.x[137] = x3013;
  const Real x3014 = 9.5 + x2704 + (0.74412265758092 + x2854 + 0.4);
  w.x[138] = x3014;
  const Real x3015 = x2702 + x2946;
  w.x[139] = x3015;
  const Real x3016 = x2691 + x2947;
  w.x[140] = x3016;
  const Real x3017 = 9.5 + x2705 + x2953;
  w.x[141] = x3017;
  const Real x3018 = x2694 + x2950;
  w.x[142] = x3018;
  const Real x3019 = 9.5 + x2643 + x2954;
  w.x[143] = x3019;
  const Real x3020 = x1797 + x2779 + tau[27];
  w.x[144] = x3020;
  const Real x3002 = cosine[9] * x2922 - sine[9] * x2901 - 0.38 * x2999;
  const Real x3021 = x2784 - 0.15 * x2773 + x1800 + x3002;
  w.x[145] = x3021;
  const Real x3004 = sine[9] * x2922 + cosine[9] * x2901 + 0.38 * x2996;
  const Real x3022 = tau[29] + 0.29 * x2776 + x1805 + x3004;
  w.x[146] = x3022;
  // joint 23 "neck_pitch": articulated-body inertia and bias force through it
  const Real x2905 = cosine[10] * x2821 - sine[10] * x2823 + x1460;
  // joint 22 "neck_yaw": articulated-body inertia and bias force through it
  const Real x3023 = x1811 + x2773 + x2905;
  w.x[147] = x3023;
  const Real x3024 = x1817 + x2776 + x2996;
  w.x[148] = x3024;
  const Real x3025 = x1822 + x2654 + x2999;
  w.x[149] = x3025;
  // joint 21 "left_wrist_pitch": articulated-body inertia and bias force through it
  const Real x3028 = 499.16813630085466 * (tau[26] - x1414);
  w.x[150] = x3028;
  const Real x3031 = x1422 - 0.024 * x3028;
  w.x[151] = x3031;
  const Real x3032 = sine[8] * 0.024;
  w.x[152] = x3032;
  const Real x3034 = cosine[8] * 0.024;
  const Real x3037 = cosine[8] * 0.0018366659999999998;
  const Real x3039 = sine[8] * x3037;
  w.x[153] = x3039;
  const Real x3041 = cosine[8] * x3037;
  const Real x3043 = 0.002133333 - x3041;
  w.x[154] = x3043;
  const Real x3045 = cosine[8] * 0.28752084650929227;
  const Real x3046 = sine[8] * x3045;
  w.x[155] = x3046;
  const Real x3048 = cosine[8] * x3045;
  const Real x3049 = 0.11247915349070774 + x3048;
  w.x[156] = x3049;
  const Real x3050 = 0.4 - x3048;
  w.x[157] = x3050;
  const Real x3051 = 0.04 * x3050;
  w.x[158] = x3051;
  const Real x3053 = 0.016 + x3034;
  w.x[159] = x3053;
  const Real x3054 = 0.04 * x3046;
  w.x[160] = x3054;
  const Real x3061 = 0.000296667 + x3041 + 0.04 * x3034 + 0.04 * x3053;
  w.x[161] = x3061;
  const Real x3062 = 0.04 * x3032;
  w.x[162] = x3062;
}

ADAGEN_NOINLINE void part_1_2(Workspace& w) {
  ADAGEN_INPUTS
  const Real x1150 = w.x[6];
  const Real x1154 = w.x[7];
  const Real x1156 = w.x[8];
  const Real x1159 = w.x[9];
  const Real x1162 = w.x[10];
  const Real x1166 = w.x[11];
  const Real x1208 = w.x[12];
  const Real x1211 = w.x[13];
  const Real x1216 = w.x[14];
  const Real x1224 = w.x[15];
  const Real x1230 = w.x[16];
  const Real x1236 = w.x[17];
  const Real x1253 = w.x[18];
  const Real x1257 = w.x[19];
  const Real x1260 = w.x[20];
  const Real x1264 = w.x[21];
  const Real x1268 = w.x[22];
  const Real x1272 = w.x[23];
  const Real x1313 = w.x[24];
  const Real x1316 = w.x[25];
  const Real x1322 = w.x[26];
  const Real x1328 = w.x[27];
  const Real x1336 = w.x[28];
  const Real x1342 = w.x[29];
  const Real x1362 = w.x[30];
  const Real x1366 = w.x[31];
  const Real x1369 = w.x[32];
  const Real x1373 = w.x[33];
  const Real x1377 = w.x[34];
  const Real x1381 = w.x[35];
  const Real x1396 = w.x[36];
  const Real x1411 = w.x[37];
  const Real x1418 = w.x[39];
  const Real x1426 = w.x[41];
  const Real x2708 = w.x[119];
  const Real x2718 = w.x[120];
  const Real x2748 = w.x[121];
  const Real x2788 = w.x[122];
  const Real x2789 = w.x[123];
  const Real x2790 = w.x[124];
  const Real x3005 = w.x[129];
  const Real x3006 = w.x[130];
  const Real x3007 = w.x[131];
  const Real x3008 = w.x[132];
  const Real x3009 = w.x[133];
  const Real x3010 = w.x[134];
  const Real x3011 = w.x[135];
  const Real x3012 = w.x[136];
  const Real x3013 = w.x[137];
  const Real x3014 = w.x[138];
  const Real x3015 = w.x[139];
  const Real x3016 = w.x[140];
  const Real x3017 = w.x[141];
  const Real x3018 = w.x[142];
  const Real x3019 = w.x[143];
  const Real x3020 = w.x[144];
  const Real x3021 = w.x[145];
  const Real x3022 = w.x[146];
  const Real x3023 = w.x[147];
  const Real x3024 = w.x[148];
  const Real x3025 = w.x[149];
  const Real x3031 = w.x[151];
  const Real x3032 = w.x[152];
  const Real x3039 = w.x[153];
  const Real x3043 = w.x[154];
  const Real x3046 = w.x[155];
  const Real x3049 = w.x[156];
  const Real x3050 = w.x[157];
  const Real x3051 = w.x[158];
  const Real x3053 = w.x[159];
  const Real x3054 = w.x[160];
  const Real x3061 = w.x[161];
  const Real x3062 = w.x[162];
  // joint 21 "left_wrist_pitch": articulated-body inertia and bias force through it
  const Real x3064 = x3039 + x3062;
  const Real x3081 = sine[8] * x1418 + cosine[8] * x3031;
  const Real x3090 = 0.00010666669999999999 + 0.04 * x3051;
  const Real x3091 = -0.002 - x3051;
  const Real x3092 = 9e-05 + x3043;
  require_more(w, x3092, 0.0, kFactorization, 20);
  const Real x3093 = 0.2 + x3050;
  const Real x3094 = 0.2 + x3049;
  const Real x3084 = sine[8] * x1396 + cosine[8] * x1411 + 0.04 * x1426;
  const Real x3096 = tau[26] - 0.04 * x3081 + x1369;
  const Real x3098 = x1373 + x3081;
  const Real x3100 = cosine[8] * x1418 - sine[8] * x3031 + x1381;
  // joint 20 "left_wrist_roll": articulated-body inertia and bias force through it
  const Real x3102 = 1 / x3092;
  const Real x3103 = tau[25] - (cosine[8] * x1396 - sine[8] * x1411 + x1362);
  const Real x3104 = x3102 * x3103;
  w.x[5] = x3104;
  const Real x3105 = x3064 * x3102;
  w.x[4] = x3105;
  const Real x3107 = x3032 * x3102;
  w.x[3] = x3107;
  const Real x3111 = 0.00010666669999999999 + x3061 - x3064 * x3105;
  const Real x3114 = 0.002 + x3053 - x3064 * x3107;
  const Real x3117 = 0.6000000000000001 - x3032 * x3107;
  const Real x3120 = x1366 + x3084 - x3064 * x3104;
  const Real x3123 = x1377 + x1426 - x3032 * x3104;
  const Real x3126 = cosine[7] * x3054;
  const Real x3129 = sine[7] * (x3091 + x3114);
  const Real x3131 = sine[7] * x3129;
  const Real x3133 = x3114 - x3131;
  const Real x3134 = x3091 - x3131;
  const Real x3135 = cosine[7] * x3129;
  const Real x3138 = cosine[7] * (x3111 - x3090);
  const Real x3143 = cosine[7] * x3138;
  const Real x3146 = cosine[7] * x3046;
  const Real x3147 = sine[7] * x3046;
  const Real x3149 = cosine[7] * (x3093 - x3117);
  const Real x3150 = sine[7] * x3149;
  const Real x3152 = cosine[7] * x3149;
  const Real x3153 = x3117 + x3152;
  const Real x3154 = x3093 - x3152;
  const Real x3155 = 0.01 * x3147;
  const Real x3158 = sine[7] * x3054 + 0.16 * x3147;
  const Real x3165 = x3126 + 0.16 * x3146 + 0.01 * x3094;
  const Real x3167 = 0.01 * x3150;
  const Real x3168 = 0.16 * x3150;
  const Real x3170 = x3168 - x3135;
  const Real x3176 = x3134 - 0.01 * x3146 - 0.16 * x3153;
  const Real x3177 = 0.01 * x3154;
  const Real x3180 = x3133 + 0.16 * x3154;
  const Real x3183 = x3135 - x3155 - x3168;
  const Real x3195 = 0.01 * x3135 - 0.01 * x3155 - 0.16 * x3167;
  const Real x3209 = sine[7] * x3138 - 0.01 * x3158 + 0.16 * x3135;
  const Real x3210 = x3209 - 0.16 * x3170;
  const Real x3220 = x3111 - x3143 + (0.01 * x3126 + 0.01 * x3165);
  const Real x3233 = cosine[7] * x3098 - sine[7] * x3123;
  const Real x3236 = sine[7] * x3098 + cosine[7] * x3123;
  const Real x3229 = sine[7] * x3120 + cosine[7] * x3096;
  const Real x3201 = x3090 + x3143 + 0.16 * x3133 + 0.16 * x3180;
  const Real x3254 = x3220 - 0.16 * x3134 - 0.16 * x3176 + 0.005417710000000001;
  require_more(w, x3254, 0.0, kFactorization, 19);
  const Real x3255 = -0.013999999999999999 - x3165;
  const Real x3256 = -0.049 + x3176;
  const Real x3241 = cosine[7] * x3120 - sine[7] * x3096 + 0.16 * x3236;
  // joint 19 "left_elbow": articulated-body inertia and bias force through it
  const Real x3267 = 1 / x3254;
  // joint 20 "left_wrist_roll": articulated-body inertia and bias force through it
  const Real x3262 = x3229 - (0.16 * x3233 + 0.01 * x3100) + x1322;
  // joint 19 "left_elbow": articulated-body inertia and bias force through it
  const Real x3269 = x3267 * (tau[24] - x3262);
  w.x[2] = x3269;
  const Real x3270 = x3195 * x3267;
  w.x[1] = x3270;
  const Real x3271 = x3210 * x3267;
  w.x[0] = x3271;
  const Real x3272 = x3255 * x3267;
  w.x[91] = x3272;
  const Real x3273 = x3256 * x3267;
  w.x[90] = x3273;
  const Real x3274 = x3183 * x3267;
  w.x[89] = x3274;
  const Real x3277 = 0.00070875 + 0.01 * x3177 - x3195 * x3270;
  // joint 20 "left_wrist_roll": articulated-body inertia and bias force through it
  const Real x3250 = 0.01 * x3133 + 0.16 * x3177 + 0.00098;
  // joint 19 "left_elbow": articulated-body inertia and bias force through it
  const Real x3280 = x3250 - x3195 * x3271;
  const Real x3283 = x3155 - x3195 * x3272;
  const Real x3286 = x3167 - x3195 * x3273;
  const Real x3289 = 0.013999999999999999 + x3177 - x3195 * x3274;
  const Real x3292 = 0.00513771 + x3201 - x3210 * x3271;
  const Real x3295 = x3158 - x3210 * x3272;
  const Real x3298 = x3170 - x3210 * x3273;
  const Real x3301 = 0.049 + x3180 - x3210 * x3274;
  const Real x3304 = 0.7 + x3094 - x3255 * x3272;
  const Real x3307 = x3146 - x3255 * x3273;
  const Real x3310 = x3147 - x3255 * x3274;
  const Real x3313 = 0.7 + x3153 - x3256 * x3273;
  const Real x3316 = x3150 - x3256 * x3274;
  const Real x3319 = 0.7 + x3154 - x3183 * x3274;
  const Real x3321 = tau[25] + 0.01 * x3236 + x1313 + x3195 * x3269;
  const Real x3323 = x1316 + x3241 + x3210 * x3269;
  const Real x3325 = x1328 + x3100 + x3255 * x3269;
  const Real x3327 = x1336 + x3233 + x3256 * x3269;
  const Real x3329 = x1342 + x3236 + x3183 * x3269;
  const Real x3333 = cosine[6] * x3289 - sine[6] * x3301;
  const Real x3336 = sine[6] * x3289 + cosine[6] * x3301;
  const Real x3342 = cosine[6] * (x3283 - x3298) - sine[6] * (x3286 + x3295);
  const Real x3343 = sine[6] * x3342;
  const Real x3345 = x3286 + x3343;
  const Real x3347 = cosine[6] * x3342;
  const Real x3348 = x3298 + x3347;
  const Real x3352 = 2.0 * sine[6];
  const Real x3356 = cosine[6] * (x3277 - x3292) - x3280 * x3352;
  const Real x3360 = cosine[6] * x3356;
  const Real x3366 = cosine[6] * x3310 - sine[6] * x3316;
  const Real x3369 = sine[6] * x3310 + cosine[6] * x3316;
  const Real x3374 = cosine[6] * (x3304 - x3313) - x3307 * x3352;
  const Real x3377 = x3307 + sine[6] * x3374;
  const Real x3378 = cosine[6] * x3374;
  const Real x3380 = x3304 - x3378;
  const Real x3381 = 0.11 * x3369;
  const Real x3383 = x3283 - x3347 + x3381;
  const Real x3384 = 0.11 * x3380;
  const Real x3388 = x3336 + 0.11 * x3319;
  const Real x3404 = x3280 + sine[6] * x3356 + 0.11 * x3333;
  const Real x3407 = 0.11 * x3345;
  const Real x3422 = sine[6] * x3325 + cosine[6] * x3327;
  const Real x3399 = x3277 - x3360 + (0.11 * x3336 + 0.11 * x3388);
  const Real x3433 = x3292 + x3360 + 0.00064;
  require_more(w, x3433, 0.0, kFactorization, 18);
  const Real x3425 = sine[6] * x3321 + cosine[6] * x3323 + 0.11 * x3329;
  // joint 18 "left_shoulder_yaw": articulated-body inertia and bias force through it
  const Real x3444 = 1 / x3433;
  const Real x3445 = tau[23] - (cosine[6] * x3321 - sine[6] * x3323 + x1253);
  const Real x3446 = x3444 * x3445;
  w.x[77] = x3446;
  const Real x3447 = x3404 * x3444;
  w.x[76] = x3447;
  const Real x3448 = x3407 * x3444;
  w.x[75] = x3448;
  const Real x3450 = x3345 * x3444;
  w.x[74] = x3450;
  const Real x3451 = x3333 * x3444;
  w.x[73] = x3451;
  const Real x3452 = x3348 * x3444;
  w.x[72] = x3452;
  const Real x3455 = 0.0036266700000000002 + x3399 - x3404 * x3447;
  const Real x3458 = x3404 * x3448 - 0.11 * x3383;
  const Real x3461 = x3383 - x3404 * x3450;
  const Real x3464 = 0.04000000000000001 + x3388 - x3404 * x3451;
  const Real x3467 = x3295 + x3343 + 0.11 * x3366 - x3404 * x3452;
  const Real x3470 = 0.0036266700000000002 + 0.11 * x3384 - x3407 * x3448;
  const Real x3473 = -0.04000000000000001 - x3384 + x3407 * x3450;
  const Real x3476 = x3407 * x3451 - x3381;
  const Real x3479 = x3407 * x3452 - 0.11 * x3377;
  const Real x3482 = 0.8 + x3380 - x3345 * x3450;
  const Real x3485 = x3369 - x3345 * x3451;
  const Real x3488 = x3377 - x3345 * x3452;
  const Real x3491 = 0.8 + x3319 - x3333 * x3451;
  const Real x3494 = x3366 - x3333 * x3452;
  const Real x3499 = x1257 + x3425 + x3404 * x3446;
  const Real x3502 = tau[24] - 0.11 * x3422 + x1260 - x3407 * x3446;
  const Real x3504 = x1264 + x3422 + x3345 * x3446;
  const Real x3506 = x1268 + x3329 + x3333 * x3446;
  // joint 19 "left_elbow": articulated-body inertia and bias force through it
  const Real x3442 = cosine[6] * x3325 - sine[6] * x3327 + x1272;
  // joint 18 "left_shoulder_yaw": articulated-body inertia and bias force through it
  const Real x3521 = cosine[5] * (x3461 - x3476) - sine[5] * (x3464 + x3473);
  const Real x3522 = sine[5] * x3521;
  const Real x3524 = x3464 + x3522;
  const Real x3525 = x3473 + x3522;
  const Real x3526 = cosine[5] * x3521;
  const Real x3527 = x3476 + x3526;
  const Real x3531 = 2.0 * sine[5];
  const Real x3535 = cosine[5] * (x3455 - x3470) - x3458 * x3531;
  const Real x3539 = cosine[5] * x3535;
  const Real x3545 = cosine[5] * x3488 - sine[5] * x3494;
  const Real x3548 = sine[5] * x3488 + cosine[5] * x3494;
  const Real x3553 = cosine[5] * (x3482 - x3491) - x3485 * x3531;
  const Real x3556 = x3485 + sine[5] * x3553;
  const Real x3557 = cosine[5] * x3553;
  const Real x3558 = x3491 + x3557;
  const Real x3559 = x3482 - x3557;
  const Real x3560 = 0.1 * x3556;
  const Real x3562 = x3461 - x3526 - x3560;
  const Real x3565 = x3524 + 0.1 * x3559;
  const Real x3574 = x3525 - 0.1 * x3558;
  const Real x3575 = x3527 + x3560;
  const Real x3586 = x3458 + sine[5] * x3535 - 0.1 * x3527;
  const Real x3587 = 0.1 * x3562 + x3586;
  const Real x3604 = cosine[5] * x3504 - sine[5] * x3506;
  const Real x3607 = sine[5] * x3504 + cosine[5] * x3506;
  const Real x3581 = x3455 - x3539 - 0.1 * x3525 - 0.1 * x3574;
  const Real x3593 = x3470 + x3539 + 0.1 * x3524 + 0.1 * x3565;
  const Real x3616 = 0.0014 + x3593;
  require_more(w, x3616, 0.0, kFactorization, 17);
  const Real x3617 = 0.020999999999999998 + x3565;
  const Real x3571 = cosine[5] * x3467 - sine[5] * x3479 + 0.1 * x3548;
  const Real x3618 = 0.006999999999999999 + x3571;
  const Real x3610 = sine[5] * x3499 + cosine[5] * x3502 - 0.1 * x3604;
  const Real x3623 = x1211 + tau[23];
  const Real x3613 = cosine[5] * x3499 - sine[5] * x3502 + 0.1 * x3607;
  // joint 17 "left_shoulder_roll": articulated-body inertia and bias force through it
  const Real x3629 = 1 / x3616;
  const Real x3631 = x3629 * (tau[22] - (x1216 + x3613));
  w.x[70] = x3631;
  const Real x3632 = x3587 * x3629;
  w.x[69] = x3632;
  const Real x3633 = x3617 * x3629;
  w.x[68] = x3633;
  const Real x3634 = x3618 * x3629;
  w.x[67] = x3634;
  const Real x3635 = x3575 * x3629;
  w.x[66] = x3635;
  const Real x3638 = 0.0013299999999999998 + x3581 - x3587 * x3632;
  const Real x3641 = x3562 - x3587 * x3633;
  // joint 18 "left_shoulder_yaw": articulated-body inertia and bias force through it
  const Real x3568 = sine[5] * x3467 + cosine[5] * x3479 - 0.1 * x3545;
  // joint 17 "left_shoulder_roll": articulated-body inertia and bias force through it
  const Real x3644 = x3568 - x3587 * x3634;
  const Real x3647 = -0.020999999999999998 + x3574 - x3587 * x3635;
  const Real x3650 = 0.7 + x3559 - x3617 * x3633;
  const Real x3653 = x3548 - x3617 * x3634;
  const Real x3656 = x3556 - x3617 * x3635;
  // joint 18 "left_shoulder_yaw": articulated-body inertia and bias force through it
  const Real x3620 = x3313 + x3378 + 0.8 - x3348 * x3452 + 0.7;
  // joint 17 "left_shoulder_roll": articulated-body inertia and bias force through it
  const Real x3659 = x3620 - x3618 * x3634;
  const Real x3662 = x3545 - x3618 * x3635;
  const Real x3665 = 0.7 + x3558 - x3575 * x3635;
  const Real x3667 = x1208 + x3610 + x3587 * x3631;
  const Real x3669 = x1224 + x3607 + x3617 * x3631;
  const Real x3671 = x3442 + x3348 * x3446 + x1230 + x3618 * x3631;
  const Real x3673 = x1236 + x3604 + x3575 * x3631;
  const Real x3677 = cosine[4] * x3647 + sine[4] * 0.006999999999999999;
  const Real x3681 = sine[4] * x3647 - cosine[4] * 0.006999999999999999;
  const Real x3685 = cosine[4] * x3641 - sine[4] * x3644;
  const Real x3686 = sine[4] * x3685;
  const Real x3688 = x3644 + x3686;
  const Real x3689 = cosine[4] * x3685;
  const Real x3693 = 2.0 * sine[4];
  const Real x3697 = cosine[4] * (x3638 - 0.00077) - 0.00020999999999999998 * x3693;
  const Real x3701 = cosine[4] * x3697;
  const Real x3707 = cosine[4] * x3656 - sine[4] * x3662;
  const Real x3710 = sine[4] * x3656 + cosine[4] * x3662;
  const Real x3715 = cosine[4] * (x3650 - x3659) - x3653 * x3693;
  const Real x3718 = x3653 + sine[4] * x3715;
  const Real x3719 = cosine[4] * x3715;
  const Real x3721 = x3650 - x3719;
  const Real x3722 = 0.05 * x3710;
  const Real x3724 = x3641 - x3689 - x3722;
  const Real x3725 = 0.05 * x3721;
  const Real x3728 = x3681 - 0.05 * x3665;
  const Real x3743 = 0.00020999999999999998 + sine[4] * x3697 - 0.05 * x3677;
  const Real x3745 = 0.05 * x3688;
  const Real x3759 = sine[4] * x3669 + cosine[4] * x3671;
  const Real x3739 = x3638 - x3701 - (0.05 * x3681 + 0.05 * x3728);
  const Real x3769 = 0.00077 + x3701 + 0.00064;
  require_more(w, x3769, 0.0, kFactorization, 16);
  const Real x3762 = sine[4] * x3667 + cosine[4] * x3623 - 0.05 * x3673;
  // joint 16 "left_shoulder_pitch": articulated-body inertia and bias force through it
  const Real x3780 = 1 / x3769;
  const Real x3781 = tau[21] - (cosine[4] * x3667 - sine[4] * x3623 + x1150);
  const Real x3782 = x3780 * x3781;
  w.x[65] = x3782;
  const Real x3783 = x3743 * x3780;
  w.x[64] = x3783;
  const Real x3784 = x3745 * x3780;
  w.x[63] = x3784;
  const Real x3785 = x3688 * x3780;
  w.x[62] = x3785;
  const Real x3786 = x3677 * x3780;
  w.x[61] = x3786;
  const Real x3787 = x3689 * x3780;
  w.x[60] = x3787;
  const Real x3790 = 0.001366667 + x3739 - x3743 * x3783;
  const Real x3793 = 0.05 * x3724 - x3743 * x3784;
  const Real x3796 = x3724 - x3743 * x3785;
  const Real x3799 = -0.024 + x3728 - x3743 * x3786;
  const Real x3802 = x3686 - 0.05 * x3707 - x3743 * x3787;
  const Real x3805 = 0.001366667 + 0.05 * x3725 - x3745 * x3784;
  const Real x3808 = 0.024 + x3725 - x3745 * x3785;
  const Real x3811 = x3722 - x3745 * x3786;
  const Real x3814 = 0.05 * x3718 - x3745 * x3787;
  const Real x3817 = 0.8 + x3721 - x3688 * x3785;
  const Real x3820 = x3710 - x3688 * x3786;
  const Real x3823 = x3718 - x3688 * x3787;
  const Real x3826 = 0.8 + x3665 - x3677 * x3786;
  const Real x3829 = x3707 - x3677 * x3787;
  const Real x3832 = x3659 + x3719 + 0.8 - x3689 * x3787;
  const Real x3834 = x1154 + x3762 + x3743 * x3782;
  const Real x3836 = tau[22] + 0.05 * x3759 + x1156 + x3745 * x3782;
  const Real x3838 = x1159 + x3759 + x3688 * x3782;
  const Real x3840 = x1162 + x3673 + x3677 * x3782;
  // joint 17 "left_shoulder_roll": articulated-body inertia and bias force through it
  const Real x3778 = cosine[4] * x3669 - sine[4] * x3671 + x1166;
  // joint 16 "left_shoulder_pitch": articulated-body inertia and bias force through it
  const Real x3842 = x3778 + x3689 * x3782;
  const Real x3849 = sine[3] * x3802 + cosine[3] * x3814;
  const Real x3855 = cosine[3] * (x3796 - x3811) - sine[3] * (x3799 + x3808);
  const Real x3856 = sine[3] * x3855;
  const Real x3858 = x3799 + x3856;
  const Real x3859 = x3808 + x3856;
  const Real x3860 = cosine[3] * x3855;
  const Real x3862 = x3796 - x3860;
  const Real x3865 = 2.0 * sine[3];
  const Real x3869 = cosine[3] * (x3790 - x3805) - x3793 * x3865;
  const Real x3873 = cosine[3] * x3869;
  const Real x3879 = cosine[3] * x3823 - sine[3] * x3829;
  const Real x3882 = sine[3] * x3823 + cosine[3] * x3829;
  const Real x3887 = cosine[3] * (x3817 - x3826) - x3820 * x3865;
  const Real x3890 = x3820 + sine[3] * x3887;
  const Real x3891 = cosine[3] * x3887;
  const Real x3892 = x3826 + x3891;
  const Real x3893 = x3817 - x3891;
  const Real x3894 = 0.15 * x3890;
  const Real x3896 = x3811 + x3860 - x3894;
  const Real x3901 = x3859 - 0.29 * x3879 + 0.15 * x3892;
  const Real x3905 = x3858 - 0.15 * x3893;
  const Real x3906 = 0.29 * x3882;
  const Real x3909 = x3862 - x3906 + x3894;
  const Real x3910 = 0.29 * x3893;
  const Real x3913 = cosine[3] * x3802 - sine[3] * x3814 - 0.15 * x3882;
  const Real x3918 = x3849 - 0.29 * x3832 + 0.15 * x3879;
  const Real x3930 = x3793 + sine[3] * x3869 - 0.29 * x3913;
  const Real x3941 = x3790 - x3873 - 0.29 * x3849 - 0.29 * x3918;
  const Real x3956 = cosine[3] * x3838 - sine[3] * x3840;
  const Real x3959 = sine[3] * x3838 + cosine[3] * x3840;
  const Real x3966 = sine[3] * x3834 + cosine[3] * x3836 - 0.29 * x3842;
  const Real x3924 = x3805 + x3873 - 0.15 * x3858 - 0.15 * x3905;
  const Real x3970 = x2788 + x3924;
  w.x[59] = x3970;
  w.to[1][0] = x3970;
  const Real x3971 = x3930 - 0.15 * x3862 + 0.15 * x3896 + x2789;
  w.x[58] = x3971;
  w.to[1][1] = x3971;
  const Real x3972 = x2748 + 0.29 * x3905;
  w.x[57] = x3972;
  w.to[1][2] = x3972;
  const Real x3973 = x2708 + x3896;
  w.x[56] = x3973;
  w.to[1][3] = x3973;
  const Real x3974 = x2718 + x3905;
  w.x[55] = x3974;
  w.to[1][4] = x3974;
  const Real x3975 = x2790 + x3913;
  w.x[54] = x3975;
  w.to[1][5] = x3975;
  const Real x3976 = 0.15 * x3859 + x3941 + 0.15 * x3901 + x3005;
  w.x[53] = x3976;
  w.to[1][6] = x3976;
  const Real x3977 = x3006 + 0.29 * x3909;
  w.x[52] = x3977;
  w.to[1][7] = x3977;
  const Real x3978 = x3007 + x3901;
  w.x[51] = x3978;
  w.to[1][8] = x3978;
  const Real x3979 = x3008 + x3909;
  w.x[50] = x3979;
  w.to[1][9] = x3979;
  const Real x3980 = x3009 + x3918;
  w.x[49] = x3980;
  w.to[1][10] = x3980;
  const Real x3981 = x3010 + 0.29 * x3910;
  w.x[48] = x3981;
  w.to[1][11] = x3981;
  const Real x3982 = x3011 + 0.29 * x3890;
  w.x[47] = x3982;
  w.to[1][12] = x3982;
  const Real x3983 = x3012 + x3910;
  w.x[46] = x3983;
  w.to[1][13] = x3983;
  const Real x3984 = x3013 + x3906;
  w.x[45] = x3984;
  w.to[1][14] = x3984;
  const Real x3985 = x3014 + x3892;
  w.x[44] = x3985;
  w.to[1][15] = x3985;
  const Real x3986 = x3015 + x3890;
  w.x[43] = x3986;
  w.to[1][16] = x3986;
  const Real x3987 = x3016 + x3879;
  w.x[42] = x3987;
  w.to[1][17] = x3987;
  const Real x3988 = x3017 + x3893;
  w.x[40] = x3988;
  w.to[1][18] = x3988;
  const Real x3989 = x3018 + x3882;
  w.x[38] = x3989;
  w.to[1][19] = x3989;
  const Real x3990 = x3019 + x3832;
  w.x[88] = x3990;
  w.to[1][20] = x3990;
  const Real x3962 = cosine[3] * x3834 - sine[3] * x3836 - 0.15 * x3959;
  const Real x3991 = x3020 + x3962;
  w.x[87] = x3991;
  w.to[1][21] = x3991;
  const Real x3992 = 0.15 * x3956 + x3966 + x3021;
  w.x[86] = x3992;
  w.to[1][22] = x3992;
  const Real x3993 = tau[21] + 0.29 * x3959 + x3022;
  w.x[85] = x3993;
  w.to[1][23] = x3993;
  const Real x3994 = x3023 + x3956;
  w.x[84] = x3994;
  w.to[1][24] = x3994;
  const Real x3995 = x3024 + x3959;
  w.x[83] = x3995;
  w.to[1][25] = x3995;
  const Real x3996 = x3025 + x3842;
  w.x[82] = x3996;
  w.to[1][26] = x3996;
}

ADAGEN_NOINLINE void part_1_3(Workspace& w) {
  ADAGEN_INPUTS
  // joint 0 "__base__": placement, velocity and reference acceleration of its link
  const Real x20 = q[3] * q[3] + q[4] * q[4] + q[5] * q[5];
  const Real x21 = q[6] * q[6] + x20;
  require_length(w, x21, 0);
}

ADAGEN_NOINLINE void part_1_4(Workspace& w) {
  ADAGEN_INPUTS
  const Real x1826 = w.x[92];
  const Real x1910 = w.x[93];
  const Real x1911 = w.x[94];
  const Real x1913 = w.x[95];
  const Real x2075 = w.x[96];
  const Real x2076 = w.x[97];
  const Real x2077 = w.x[98];
  const Real x2078 = w.x[99];
  const Real x2079 = w.x[100];
  const Real x2080 = w.x[101];
  const Real x2252 = w.x[102];
  const Real x2253 = w.x[103];
  const Real x2254 = w.x[104];
  const Real x2256 = w.x[105];
  const Real x2257 = w.x[106];
  const Real x2258 = w.x[107];
  const Real x2437 = w.x[108];
  const Real x2438 = w.x[109];
  const Real x2439 = w.x[110];
  const Real x2440 = w.x[111];
  const Real x2441 = w.x[112];
  const Real x2592 = w.x[113];
  const Real x2593 = w.x[114];
  const Real x2594 = w.x[115];
  const Real x2596 = w.x[116];
  const Real x2597 = w.x[117];
  const Real x2598 = w.x[118];
  const Real x2808 = w.x[125];
  const Real x2909 = w.x[126];
  const Real x2910 = w.x[127];
  const Real x2911 = w.x[128];
  const Real x3028 = w.x[150];
  const Real x3104 = w.x[5];
  const Real x3105 = w.x[4];
  const Real x3107 = w.x[3];
  const Real x3269 = w.x[2];
  const Real x3270 = w.x[1];
  const Real x3271 = w.x[0];
  const Real x3272 = w.x[91];
  const Real x3273 = w.x[90];
  const Real x3274 = w.x[89];
  const Real x3446 = w.x[77];
  const Real x3447 = w.x[76];
  const Real x3448 = w.x[75];
  const Real x3450 = w.x[74];
  const Real x3451 = w.x[73];
  const Real x3452 = w.x[72];
  const Real x3631 = w.x[70];
  const Real x3632 = w.x[69];
  const Real x3633 = w.x[68];
  const Real x3634 = w.x[67];
  const Real x3635 = w.x[66];
  const Real x3782 = w.x[65];
  const Real x3783 = w.x[64];
  const Real x3784 = w.x[63];
  const Real x3785 = w.x[62];
  const Real x3786 = w.x[61];
  const Real x3787 = w.x[60];
  const Real x3970 = w.x[59];
  const Real x3971 = w.x[58];
  const Real x3972 = w.x[57];
  const Real x3973 = w.x[56];
  const Real x3974 = w.x[55];
  const Real x3975 = w.x[54];
  const Real x3976 = w.x[53];
  const Real x3977 = w.x[52];
  const Real x3978 = w.x[51];
  const Real x3979 = w.x[50];
  const Real x3980 = w.x[49];
  const Real x3981 = w.x[48];
  const Real x3982 = w.x[47];
  const Real x3983 = w.x[46];
  const Real x3984 = w.x[45];
  const Real x3985 = w.x[44];
  const Real x3986 = w.x[43];
  const Real x3987 = w.x[42];
  const Real x3988 = w.x[40];
  const Real x3989 = w.x[38];
  const Real x3990 = w.x[88];
  const Real x3991 = w.x[87];
  const Real x3992 = w.x[86];
  const Real x3993 = w.x[85];
  const Real x3994 = w.x[84];
  const Real x3995 = w.x[83];
  const Real x3996 = w.x[82];
  // message received
  const Real x3997 = w.from[0][0];
  const Real x3998 = w.from[0][1];
  const Real x4002 = w.from[0][5];
  const Real x3999 = w.from[0][2];
  const Real x4003 = w.from[0][6];
  const Real x4006 = w.from[0][9];
  const Real x4000 = w.from[0][3];
  const Real x4004 = w.from[0][7];
  const Real x4007 = w.from[0][10];
  const Real x4001 = w.from[0][4];
  const Real x4009 = w.from[0][12];
  const Real x4005 = w.from[0][8];
  const Real x4008 = w.from[0][11];
  const Real x4010 = w.from[0][13];
  const Real x4027 = w.from[0][15];
  const Real x4028 = w.from[0][16];
  const Real x4011 = w.from[0][14];
  const Real x4029 = w.from[0][17];
  const Real x4030 = w.from[0][18];
  const Real x4031 = w.from[0][19];
  const Real x4032 = w.from[0][20];
  const Real x4026 = x3990 + x4011;
  const Real x4016 = x3975 + x4001;
  const Real x4014 = x3973 + x3999;
  const Real x4021 = x3985 + x4006;
  const Real x4015 = x3974 + x4000;
  const Real x4024 = x3988 + x4009;
  const Real x4012 = x3970 + x3997;
  require_more(w, x4012, 0.0, kFactorization, 15);
  const Real x4013 = x3971 + x3998;
  const Real x4033 = x3991 + x4027;
  const Real x4017 = x3976 + x4002;
  // link 16 "torso": acceleration from its articulated-body inertia
  const Real x4170 = x4026 * 1.7763568394002505e-15;
  const Real x4168 = x4021 * 1.7763568394002505e-15;
  const Real x4169 = x4024 * 1.7763568394002505e-15;
  const Real x4167 = x3981 * 1.7763568394002505e-15;
  const Real x4039 = 1 / x4012;
  const Real x4166 = x4017 * 1.7763568394002505e-15;
  const Real x4040 = x4013 * x4039;
  const Real x4041 = x3972 * x4039;
  const Real x4042 = x4014 * x4039;
  const Real x4043 = x4015 * x4039;
  const Real x4044 = x4016 * x4039;
  const Real x4047 = x4017 - x4013 * x4040;
  require_more(w, x4047, x4166, kFactorization, 15);
  const Real x4050 = x3977 - x3972 * x4040;
  const Real x4053 = x3978 + x4003 - x4014 * x4040;
  const Real x4056 = x3979 + x4004 - x4015 * x4040;
  const Real x4059 = x3980 + x4005 - x4016 * x4040;
  const Real x4060 = 1 / x4047;
  const Real x4179 = x4033 * x4040 - (x3992 + x4028);
  const Real x4061 = x4050 * x4060;
  const Real x4062 = x4053 * x4060;
  const Real x4063 = x4056 * x4060;
  const Real x4064 = x4059 * x4060;
  const Real x4070 = x3981 - x3972 * x4041 - x4050 * x4061;
  require_more(w, x4070, x4167, kFactorization, 15);
  const Real x4076 = x3982 - x4014 * x4041 - x4053 * x4061;
  const Real x4082 = x3983 - x4015 * x4041 - x4056 * x4061;
  const Real x4088 = x3984 - x4016 * x4041 - x4059 * x4061;
  const Real x4185 = x4033 * x4041 - (x3993 + x4029) - x4061 * x4179;
  const Real x4089 = 1 / x4070;
  const Real x4090 = x4076 * x4089;
  const Real x4091 = x4082 * x4089;
  const Real x4092 = x4088 * x4089;
  const Real x4100 = x4021 - x4014 * x4042 - x4053 * x4062;
  const Real x4101 = x4100 - x4076 * x4090;
  require_more(w, x4101, x4168, kFactorization, 15);
  const Real x4109 = x3986 + x4007 - x4015 * x4042 - x4056 * x4062;
  const Real x4110 = x4109 - x4082 * x4090;
  const Real x4132 = x4024 - x4015 * x4043 - x4056 * x4063;
  const Real x4118 = x3987 + x4008 - x4016 * x4042 - x4059 * x4062;
  const Real x4119 = x4118 - x4088 * x4090;
  const Real x4144 = x3989 + x4010 - x4016 * x4043 - x4059 * x4063;
  const Real x4160 = x4026 - x4016 * x4044 - x4059 * x4064;
  const Real x4193 = x4033 * x4042 - (x3994 + x4030) - x4062 * x4179;
  const Real x4194 = x4193 - x4090 * x4185;
  const Real x4204 = x4033 * x4043 - (x3995 + x4031) - x4063 * x4179;
  const Real x4218 = x4033 * x4044 - (x3996 + x4032) - x4064 * x4179;
  const Real x4120 = 1 / x4101;
  const Real x4121 = x4110 * x4120;
  const Real x4122 = x4119 * x4120;
  const Real x4134 = x4132 - x4082 * x4091 - x4110 * x4121;
  require_more(w, x4134, x4169, kFactorization, 15);
  const Real x4146 = x4144 - x4088 * x4091 - x4119 * x4121;
  const Real x4206 = x4204 - x4091 * x4185 - x4121 * x4194;
  const Real x4147 = 1 / x4134;
  const Real x4148 = x4146 * x4147;
  const Real x4162 = x4160 - x4088 * x4092 - x4119 * x4122;
  const Real x4163 = x4162 - x4146 * x4148;
  require_more(w, x4163, x4170, kFactorization, 15);
  const Real x4220 = x4218 - x4092 * x4185 - x4122 * x4194;
  const Real x4228 = 1 / x4163 * (x4220 - x4148 * x4206);
  const Real x4231 = x4147 * x4206 - x4148 * x4228;
  const Real x4237 = x4120 * x4194 - x4122 * x4228 - x4121 * x4231;
  const Real x4245 = x4089 * x4185 - x4092 * x4228 - x4091 * x4231;
  const Real x4246 = x4245 - x4090 * x4237;
  const Real x4256 = x4060 * x4179 - x4064 * x4228 - x4063 * x4231;
  const Real x4271 = x4033 * x4039 + x4044 * x4228 + x4043 * x4231;
  const Real x4258 = x4256 - x4062 * x4237 - x4061 * x4246;
  const Real x4275 = x4042 * x4237 + x4271 + x4041 * x4246;
  const Real x4277 = x4040 * x4258 + x4275;
  // joint 16 "left_shoulder_pitch": its acceleration, and that of the link beyond
  const Real x4287 = x4231 + 0.29 * x4246;
  const Real x4280 = 0.15 * x4258;
  const Real x4291 = x4228 - 0.29 * x4258;
  const Real x4282 = x4237 + x4280;
  const Real x4283 = 0.15 * x4277;
  const Real x4288 = x4283 + x4287;
  const Real x4295 = sine[3] * x4258 - cosine[3] * x4277;
  const Real x4299 = sine[3] * x4277 + cosine[3] * x4258;
  const Real x4302 = cosine[3] * x4282 + sine[3] * x4288;
  const Real x4306 = cosine[3] * x4288 - sine[3] * x4282;
  const Real x4318 = x3782 - x3787 * x4291 - x3783 * x4295;
  const Real x4320 = x4318 - x3784 * x4299 - x3785 * x4302;
  const Real x4321 = x4320 - x3786 * x4306;
  // joint 17 "left_shoulder_roll": its acceleration, and that of the link beyond
  const Real x4325 = x4302 + 0.05 * x4299;
  const Real x4328 = x4306 - 0.05 * x4295;
  const Real x4338 = cosine[4] * x4291 + sine[4] * x4325;
  const Real x4342 = cosine[4] * x4325 - sine[4] * x4291;
  // joint 22 "neck_yaw": its acceleration, and that of the link beyond
  const Real x4485 = x4231 + 0.38 * x4246;
  const Real x4488 = x4228 - 0.38 * x4258;
  const Real x4495 = cosine[9] * x4246 - sine[9] * x4258;
  // joint 23 "neck_pitch": its acceleration, and that of the link beyond
  const Real x4512 = cosine[9] * x4485 + sine[9] * x4488 + 0.06 * x4495;
  // joint 24 "right_shoulder_pitch": its acceleration, and that of the link beyond
  const Real x4538 = x4237 - x4280;
  const Real x4539 = x4287 - x4283;
  const Real x4543 = sine[11] * x4258 - cosine[11] * x4277;
  const Real x4547 = sine[11] * x4277 + cosine[11] * x4258;
  const Real x4550 = cosine[11] * x4538 + sine[11] * x4539;
  const Real x4554 = cosine[11] * x4539 - sine[11] * x4538;
  const Real x4566 = x2592 - x2598 * x4291 - x2593 * x4543;
  const Real x4568 = x2594 * x4547 + x4566 - x2596 * x4550;
  const Real x4569 = x4568 - x2597 * x4554;
  // joint 25 "right_shoulder_roll": its acceleration, and that of the link beyond
  const Real x4573 = x4550 - 0.05 * x4547;
  const Real x4575 = x4554 + 0.05 * x4543;
  // joint 16 "left_shoulder_pitch": its acceleration, and that of the link beyond
  const Real x4322 = x4321 - x4246;
  w.result[21] = x4322;
  // joint 17 "left_shoulder_roll": its acceleration, and that of the link beyond
  const Real x4331 = cosine[4] * x4321 + sine[4] * x4295;
  const Real x4352 = x3631 - x3635 * x4328 - x3633 * x4338;
  const Real x4354 = x4352 - x3634 * x4342 - x3632 * x4331;
  const Real x4355 = x4354 - x4299;
  w.result[22] = x4355;
  // joint 18 "left_shoulder_yaw": its acceleration, and that of the link beyond
  const Real x4360 = x4328 - 0.1 * x4331;
  const Real x4357 = x4338 + 0.1 * x4354;
  const Real x4363 = cosine[5] * x4354 + sine[5] * x4331;
  const Real x4367 = cosine[5] * x4331 - sine[5] * x4354;
  const Real x4370 = cosine[5] * x4360 + sine[5] * x4357;
  const Real x4374 = cosine[5] * x4357 - sine[5] * x4360;
  const Real x4386 = x3446 - x3452 * x4342 - x3447 * x4363;
  // joint 19 "left_elbow": its acceleration, and that of the link beyond
  const Real x4393 = x4370 - 0.11 * x4367;
  // joint 22 "neck_yaw": its acceleration, and that of the link beyond
  const Real x4507 = x2909 - x2910 * (cosine[9] * x4258 + sine[9] * x4246);
  const Real x4508 = x4507 - x2911 * (cosine[9] * x4488 - sine[9] * x4485);
  const Real x4509 = x4277 + x4508;
  w.result[27] = x4509;
  // joint 23 "neck_pitch": its acceleration, and that of the link beyond
  const Real x4535 = x2808 + (cosine[10] * x4237 + sine[10] * x4512) * 1.7035775127768316;
  // joint 24 "right_shoulder_pitch": its acceleration, and that of the link beyond
  const Real x4570 = x4569 - x4246;
  w.result[29] = x4570;
  // joint 25 "right_shoulder_roll": its acceleration, and that of the link beyond
  const Real x4585 = cosine[12] * x4291 + sine[12] * x4573;
  const Real x4589 = cosine[12] * x4573 - sine[12] * x4291;
  const Real x4578 = cosine[12] * x4569 + sine[12] * x4543;
  const Real x4599 = x2437 - x2441 * x4575 - x2439 * x4585;
  const Real x4601 = x4599 - x2440 * x4589 - x2438 * x4578;
  // joint 26 "right_shoulder_yaw": its acceleration, and that of the link beyond
  const Real x4607 = x4575 - 0.1 * x4578;
  const Real x4604 = x4585 + 0.1 * x4601;
  const Real x4610 = cosine[13] * x4601 + sine[13] * x4578;
  const Real x4614 = cosine[13] * x4578 - sine[13] * x4601;
  const Real x4617 = cosine[13] * x4607 + sine[13] * x4604;
  const Real x4621 = cosine[13] * x4604 - sine[13] * x4607;
  // joint 18 "left_shoulder_yaw": its acceleration, and that of the link beyond
  const Real x4388 = x3448 * x4367 + x4386 - x3450 * x4370;
  const Real x4389 = x4388 - x3451 * x4374;
  const Real x4390 = x4389 - (cosine[4] * x4295 - sine[4] * x4321);
  w.result[23] = x4390;
  // joint 19 "left_elbow": its acceleration, and that of the link beyond
  const Real x4395 = x4374 + 0.11 * x4363;
  const Real x4405 = cosine[6] * x4342 + sine[6] * x4393;
  const Real x4409 = cosine[6] * x4393 - sine[6] * x4342;
  const Real x4398 = cosine[6] * x4389 + sine[6] * x4363;
  const Real x4402 = cosine[6] * x4363 - sine[6] * x4389;
  const Real x4421 = x3269 - x3274 * x4395 - x3272 * x4405;
  const Real x4423 = x4421 - x3273 * x4409 - x3270 * x4398;
  const Real x4424 = x4423 - x3271 * x4402;
  const Real x4425 = x4424 - x4367;
  w.result[24] = x4425;
  // joint 20 "left_wrist_roll": its acceleration, and that of the link beyond
  const Real x4436 = x4395 + 0.16 * x4402 + 0.01 * x4398;
  const Real x4431 = x4409 - 0.16 * x4424;
  const Real x4443 = cosine[7] * x4424 - sine[7] * x4402;
  // joint 23 "neck_pitch": its acceleration, and that of the link beyond
  const Real x4536 = x4535 - 7.666098807495741 * (cosine[10] * x4512 - sine[10] * x4237);
  const Real x4537 = x4536 - x4495;
  w.result[28] = x4537;
  // joint 25 "right_shoulder_roll": its acceleration, and that of the link beyond
  const Real x4602 = x4601 - x4547;
  w.result[30] = x4602;
  // joint 26 "right_shoulder_yaw": its acceleration, and that of the link beyond
  const Real x4633 = x2252 - x2258 * x4589 - x2253 * x4610;
  const Real x4635 = x2254 * x4614 + x4633 - x2256 * x4617;
  const Real x4636 = x4635 - x2257 * x4621;
  const Real x4637 = x4636 - (cosine[12] * x4543 - sine[12] * x4569);
  w.result[31] = x4637;
  // joint 27 "right_elbow": its acceleration, and that of the link beyond
  const Real x4640 = x4617 - 0.11 * x4614;
  const Real x4642 = x4621 + 0.11 * x4610;
  const Real x4652 = cosine[14] * x4589 + sine[14] * x4640;
  const Real x4656 = cosine[14] * x4640 - sine[14] * x4589;
  const Real x4645 = cosine[14] * x4636 + sine[14] * x4610;
  const Real x4649 = cosine[14] * x4610 - sine[14] * x4636;
  const Real x4668 = x2075 - x2080 * x4642 - x2078 * x4652;
  const Real x4670 = x4668 - x2079 * x4656 - x2076 * x4645;
  const Real x4671 = x4670 - x2077 * x4649;
  const Real x4672 = x4671 - x4614;
  w.result[32] = x4672;
  // joint 28 "right_wrist_roll": its acceleration, and that of the link beyond
  const Real x4683 = x4642 + 0.16 * x4649 + 0.01 * x4645;
  const Real x4678 = x4656 - 0.16 * x4671;
  const Real x4690 = cosine[15] * x4671 - sine[15] * x4649;
  // joint 20 "left_wrist_roll": its acceleration, and that of the link beyond
  const Real x4455 = x3104 + x3105 * (cosine[7] * x4402 + sine[7] * x4424);
  const Real x4456 = x3107 * (cosine[7] * x4436 - sine[7] * x4431) + x4455;
  const Real x4457 = x4456 - x4398;
  w.result[25] = x4457;
  // joint 21 "left_wrist_pitch": its acceleration, and that of the link beyond
  const Real x4460 = cosine[7] * x4431 + sine[7] * x4436 - 0.04 * x4443;
  const Real x4476 = cosine[8] * x4460 - sine[8] * (x4405 - 0.01 * x4424);
  const Real x4481 = x3028 + x4476 * 11.980035271220512 - x4443;
  w.result[26] = x4481;
  // joint 28 "right_wrist_roll": its acceleration, and that of the link beyond
  const Real x4702 = x1910 + x1911 * (cosine[15] * x4649 + sine[15] * x4671);
  const Real x4703 = x1913 * (cosine[15] * x4683 - sine[15] * x4678) + x4702;
  const Real x4704 = x4703 - x4645;
  w.result[33] = x4704;
  // joint 29 "right_wrist_pitch": its acceleration, and that of the link beyond
  const Real x4707 = cosine[15] * x4678 + sine[15] * x4683 - 0.04 * x4690;
  const Real x4723 = cosine[16] * x4707 - sine[16] * (x4652 - 0.01 * x4671);
  const Real x4727 = x1826 + 11.980035271220512 * x4723 - x4690;
  w.result[34] = x4727;
}

// ---- 5. processes -------------------------------------------------------------------------------

// Process 0: 16 of 30 joints: "__base__", "left_hip_pitch", "left_hip_roll", "left_hip_yaw", "left_knee", "left_ankle_pitch", ...
constexpr std::array<int, 16> kRead_0{0, 1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12, 13, 14, 15};
constexpr std::array<int, 16> kOwned_0{0, 1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12, 13, 14, 15};

void run_0([[maybe_unused]] Workspace& w, [[maybe_unused]] Channel& channel) {
  ADAGEN_INPUTS
  stamp(0);
  if (!all(unlike_zero(q + 0, 22) + unlike_zero(v + 0, 21) + unlike_zero(tau + 0, 21) == 0))
    name_what_is_not_finite(w, kRead_0, kOwned_0);
  w.to[0] = channel.outgoing(0, w.status);
  take_sines_and_cosines<15>(q + 7, w.sine.data(), w.cosine.data());
  part_0_0(w);
  part_0_1(w);
  part_0_2(w);
  stamp(1);
  stamp(2);
  channel.send(0, w.status);  // to process 1: what hangs on "torso"
  stamp(3);
  part_0_3(w);
  w.from[1] = channel.receive(1, w.status);  // from process 1: what hangs on "torso"
  stamp(4);
  part_0_4(w);
  stamp(5);
  stamp(6);
  if (!all(unlike_zero(w.result.data() + 0, 21) == 0)) name_what_overflows(w, kOwned_0);
  if (w.status != kFine) return;
  std::copy_n(w.result.data() + 0, 21, w.qdd + 0);
}

// Process 1: 14 of 30 joints: "left_shoulder_pitch", "left_shoulder_roll", "left_shoulder_yaw", "left_elbow", "left_wrist_roll", "left_wrist_pitch", ...; kinematics of 4 more on the way to the ground
constexpr std::array<int, 18> kRead_1{0, 13, 14, 15, 16, 17, 18, 19, 20, 21, 22, 23, 24, 25, 26, 27, 28, 29};
constexpr std::array<int, 14> kOwned_1{16, 17, 18, 19, 20, 21, 22, 23, 24, 25, 26, 27, 28, 29};

void run_1([[maybe_unused]] Workspace& w, [[maybe_unused]] Channel& channel) {
  ADAGEN_INPUTS
  stamp(0);
  if (!all(unlike_zero(q + 0, 7) + unlike_zero(q + 19, 17) + unlike_zero(v + 0, 6) + unlike_zero(v + 18, 17) + unlike_zero(tau + 21, 14) == 0))
    name_what_is_not_finite(w, kRead_1, kOwned_1);
  w.to[1] = channel.outgoing(1, w.status);
  w.angle[0] = q[19];
  w.angle[1] = q[20];
  w.angle[2] = q[21];
  w.angle[3] = q[22];
  w.angle[4] = q[23];
  w.angle[5] = q[24];
  w.angle[6] = q[25];
  w.angle[7] = q[26];
  w.angle[8] = q[27];
  w.angle[9] = q[28];
  w.angle[10] = q[29];
  w.angle[11] = q[30];
  w.angle[12] = q[31];
  w.angle[13] = q[32];
  w.angle[14] = q[33];
  w.angle[15] = q[34];
  w.angle[16] = q[35];
  take_sines_and_cosines<17>(w.angle.data(), w.sine.data(), w.cosine.data());
  part_1_0(w);
  part_1_1(w);
  part_1_2(w);
  stamp(1);
  stamp(2);
  channel.send(1, w.status);  // to process 0: what hangs on "torso"
  stamp(3);
  part_1_3(w);
  w.from[0] = channel.receive(0, w.status);  // from process 0: what hangs on "torso"
  stamp(4);
  part_1_4(w);
  stamp(5);
  stamp(6);
  if (!all(unlike_zero(w.result.data() + 21, 14) == 0)) name_what_overflows(w, kOwned_1);
  if (w.status != kFine) return;
  std::copy_n(w.result.data() + 21, 14, w.qdd + 21);
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
