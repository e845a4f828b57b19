// Forward dynamics of "human40" on 1 process, emitted by adagen 0.1.0 (solver.cpp.j2). Do not edit: emit anew.
//
// robot     "human40", 15 joints, 40 degrees of freedom, description sha256 bdc16488e5ef4610f46ad114b2f2b09a8601d7b212cf0d9aa1794a195cd4ce35
// command   adagen ../models/human40.urdf --procs 1 --shape=joints --form=ada
// options   form ada, shape joints, scalar double, channel auto, fixed base, gravity 0.0, 0.0, -9.81
// links     adagen_program.cpp
// program   1 process; 3.15 us predicted (default profile)
//           process 0: root .. right_wrist
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
// To use it from a program of yours: compile this file with -DADAGEN_NO_MAIN and link it; human40_p1.h
// beside it is this part.
// C interface of the solver human40_p1: forward dynamics of "human40" on 1 process,
// emitted by adagen 0.1.0 (interface.h.j2). Do not edit: emit anew.
#ifndef ADAGEN_HUMAN40_P1_H
#define ADAGEN_HUMAN40_P1_H

enum {
  HUMAN40_P1_PROCESSES = 1,
  HUMAN40_P1_JOINTS = 15,
  HUMAN40_P1_NQ = 51,  // numbers in q
  HUMAN40_P1_NV = 40,  // in v and qdd
  HUMAN40_P1_NTAU = 40  // in tau
};

// Where each joint begins in q, and in v, tau and qdd.
enum {
  HUMAN40_P1_Q_root = 0,
  HUMAN40_P1_V_root = 0,  // joint 0, "root": floating, 7 in q, 6 in v
  HUMAN40_P1_Q_left_hip = 7,
  HUMAN40_P1_V_left_hip = 6,  // joint 1, "left_hip": spherical, 4 in q, 3 in v
  HUMAN40_P1_Q_left_knee = 11,
  HUMAN40_P1_V_left_knee = 9,  // joint 2, "left_knee": revolute, 1 in q, 1 in v
  HUMAN40_P1_Q_left_ankle = 12,
  HUMAN40_P1_V_left_ankle = 10,  // joint 3, "left_ankle": spherical, 4 in q, 3 in v
  HUMAN40_P1_Q_right_hip = 16,
  HUMAN40_P1_V_right_hip = 13,  // joint 4, "right_hip": spherical, 4 in q, 3 in v
  HUMAN40_P1_Q_right_knee = 20,
  HUMAN40_P1_V_right_knee = 16,  // joint 5, "right_knee": revolute, 1 in q, 1 in v
  HUMAN40_P1_Q_right_ankle = 21,
  HUMAN40_P1_V_right_ankle = 17,  // joint 6, "right_ankle": spherical, 4 in q, 3 in v
  HUMAN40_P1_Q_spine = 25,
  HUMAN40_P1_V_spine = 20,  // joint 7, "spine": spherical, 4 in q, 3 in v
  HUMAN40_P1_Q_left_shoulder = 29,
  HUMAN40_P1_V_left_shoulder = 23,  // joint 8, "left_shoulder": spherical, 4 in q, 3 in v
  HUMAN40_P1_Q_left_elbow = 33,
  HUMAN40_P1_V_left_elbow = 26,  // joint 9, "left_elbow": revolute, 1 in q, 1 in v
  HUMAN40_P1_Q_left_wrist = 34,
  HUMAN40_P1_V_left_wrist = 27,  // joint 10, "left_wrist": spherical, 4 in q, 3 in v
  HUMAN40_P1_Q_neck = 38,
  HUMAN40_P1_V_neck = 30,  // joint 11, "neck": spherical, 4 in q, 3 in v
  HUMAN40_P1_Q_right_shoulder = 42,
  HUMAN40_P1_V_right_shoulder = 33,  // joint 12, "right_shoulder": spherical, 4 in q, 3 in v
  HUMAN40_P1_Q_right_elbow = 46,
  HUMAN40_P1_V_right_elbow = 36,  // joint 13, "right_elbow": revolute, 1 in q, 1 in v
  HUMAN40_P1_Q_right_wrist = 47,
  HUMAN40_P1_V_right_wrist = 37  // joint 14, "right_wrist": spherical, 4 in q, 3 in v
};

// Why a call failed, as human40_p1_reason tells of the status that it returned.
enum {
  HUMAN40_P1_FINE = 0,  // none
  HUMAN40_P1_NOT_FINITE = 1,  // q, v or tau of a joint is not a finite number
  HUMAN40_P1_ZERO_QUATERNION = 2,  // a joint's quaternion cannot be normalised
  HUMAN40_P1_FACTORIZATION = 3,  // inertias beside a joint differ too much for the scalar
  HUMAN40_P1_OVERFLOW = 4,  // a joint's acceleration is not a finite number
  HUMAN40_P1_NO_ANSWER = 5,  // a process did not answer within the time limit
  HUMAN40_P1_ENDED = 6,  // process 0 has ended the evaluations
  HUMAN40_P1_NOT_REFINED = 7,  // refinement does not converge
  HUMAN40_P1_GIMBAL_LOCK = 8,  // joints that are joined as one do not move in as many directions
  HUMAN40_P1_GROWTH = 9,  // a link beside a joint is too light for its neighbours
  HUMAN40_P1_NOT_SET = 16,  // what is to be set at run time is not finite, or is no mass
  HUMAN40_P1_TOO_FEW_STEPS = 11,  // refinement converges too slowly
  HUMAN40_P1_LOOP_OPEN = 12,  // a loop or coupling is not closed in this configuration
  HUMAN40_P1_LOOP_TORN = 13,  // this velocity tears a loop or coupling open
  HUMAN40_P1_LOOP_SINGULAR = 14,  // what a loop holds changes in this pose
  HUMAN40_P1_LOOP_FREE = 15  // loops leave a joint a motion that no inertia resists
};

#ifdef __cplusplus
extern "C" {
#endif
typedef struct human40_p1_solver human40_p1_solver;

// Joints in order, each with its place in the state: gives name, start and size in q and v of joint
// k, or returns 0 where there is none.
int human40_p1_joint(int k, const char** name, int* q, int* nq, int* v, int* nv);

// A solver, with all the memory that it will ever need: no other call allocates, waits or takes a
// lock. One solver is for one thread at a time. Returns null where there is no memory;
// human40_p1_failure(NULL) says so.
human40_p1_solver* human40_p1_open(void);

// One evaluation. q: 51 numbers, v and tau: 40 each, qdd: 40; joints in order, quaternions
// x y z w (normalised here), floating joints [linear; angular] in the body's frame.
// Returns 0, or a status that human40_p1_failure puts into words; no acceleration is written then.
int human40_p1_solve(human40_p1_solver* solver, const double* q, const double* v, const double* tau, double* qdd);

// What a status says: its reason, and which joint it is about, -1 for none.
int human40_p1_reason(int status);
int human40_p1_failed_joint(int status);

// The last failure of a solver in words, valid until the next call; of null, why the last open of this
// thread returned null.
const char* human40_p1_failure(const human40_p1_solver* solver);

void human40_p1_close(human40_p1_solver* solver);
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
constexpr int kProcesses = 1;
[[maybe_unused]] constexpr bool kAlone = true;  // whether process 0 does all, and no other takes part
constexpr int kJointCount = 15, kLinkCount = kJointCount + 1;
constexpr int kNq = 51, kNv = 40;
constexpr int kOuterCount = 0, kNtau = kNv + 6 * kOuterCount;
constexpr int kNqdd = 40;
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
    {"world", 0.0, {0.0, 0.0, 0.0},
     {0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0},
     {}},
    {"pelvis", 9.6, {0.0, 0.0, 0.03},
     {0.104, 0.0, 0.0, 0.0, 0.05248, 0.0, 0.0, 0.0, 0.09248},
     {9.615384615384615, 0.0, 0.0, 0.0, 19.054878048780488, 0.0, 0.0, 0.0, 10.813148788927334}},
    {"left_thigh", 8.4, {0.0, 0.0, -0.19},
     {0.12544, 0.0, 0.0, 0.0, 0.12544, 0.0, 0.0, 0.0, 0.02688},
     {7.971938775510204, 0.0, 0.0, 0.0, 7.971938775510204, 0.0, 0.0, 0.0, 37.20238095238095}},
    {"left_shank", 3.2, {-0.18, 0.0, 0.0},
     {0.004, 0.0, 0.0, 0.0, 0.0446667, 0.0, 0.0, 0.0, 0.0446667},
     {250.0, 0.0, 0.0, 0.0, 22.388042993997768, 0.0, 0.0, 0.0, 22.388042993997768}},
    {"left_foot", 1.0, {0.06, 0.0, -0.04},
     {0.00108333, 0.0, 0.0, 0.0, 0.00561667, 0.0, 0.0, 0.0, 0.00588333},
     {923.0797633223488, 0.0, 0.0, 0.0, 178.04143736413212, 0.0, 0.0, 0.0, 169.97176768938678}},
    {"right_thigh", 8.4, {0.0, 0.0, -0.19},
     {0.12544, 0.0, 0.0, 0.0, 0.12544, 0.0, 0.0, 0.0, 0.02688},
     {7.971938775510204, 0.0, 0.0, 0.0, 7.971938775510204, 0.0, 0.0, 0.0, 37.20238095238095}},
    {"right_shank", 3.2, {-0.18, 0.0, 0.0},
     {0.004, 0.0, 0.0, 0.0, 0.0446667, 0.0, 0.0, 0.0, 0.0446667},
     {250.0, 0.0, 0.0, 0.0, 22.388042993997768, 0.0, 0.0, 0.0, 22.388042993997768}},
    {"right_foot", 1.0, {0.06, 0.0, -0.04},
     {0.00108333, 0.0, 0.0, 0.0, 0.00561667, 0.0, 0.0, 0.0, 0.00588333},
     {923.0797633223488, 0.0, 0.0, 0.0, 178.04143736413212, 0.0, 0.0, 0.0, 169.97176768938678}},
    {"trunk", 23.0, {0.0, 0.0, 0.23},
     {0.601833, 0.0, 0.0, 0.0, 0.467667, 0.0, 0.0, 0.0, 0.258367},
     {1.661590507665748, 0.0, 0.0, 0.0, 2.1382736006602987, 0.0, 0.0, 0.0, 3.870463333165613}},
    {"left_upper_arm", 1.9, {0.0, 0.0, -0.14},
     {0.0133752, 0.0, 0.0, 0.0, 0.0133752, 0.0, 0.0, 0.0, 0.00192375},
     {74.76523715533226, 0.0, 0.0, 0.0, 74.76523715533226, 0.0, 0.0, 0.0, 519.8180636777129}},
    {"left_forearm", 1.1, {-0.12, 0.0, 0.0},
     {0.00067375, 0.0, 0.0, 0.0, 0.00606604, 0.0, 0.0, 0.0, 0.00606604},
     {1484.2300556586272, 0.0, 0.0, 0.0, 164.852193523287, 0.0, 0.0, 0.0, 164.852193523287}},
    {"left_hand", 0.42, {0.0, 0.0, -0.08},
     {0.0012355, 0.0, 0.0, 0.0, 0.001043, 0.0, 0.0, 0.0, 0.0002555},
     {809.3889113719142, 0.0, 0.0, 0.0, 958.7727708533076, 0.0, 0.0, 0.0, 3913.894324853229}},
    {"head", 4.9, {0.01, 0.0, 0.14},
     {0.0196, 0.0, 0.0, 0.0, 0.0196, 0.0, 0.0, 0.0, 0.0196},
     {51.02040816326531, 0.0, 0.0, 0.0, 51.02040816326531, 0.0, 0.0, 0.0, 51.02040816326531}},
    {"right_upper_arm", 1.9, {0.0, 0.0, -0.14},
     {0.0133752, 0.0, 0.0, 0.0, 0.0133752, 0.0, 0.0, 0.0, 0.00192375},
     {74.76523715533226, 0.0, 0.0, 0.0, 74.76523715533226, 0.0, 0.0, 0.0, 519.8180636777129}},
    {"right_forearm", 1.1, {-0.12, 0.0, 0.0},
     {0.00067375, 0.0, 0.0, 0.0, 0.00606604, 0.0, 0.0, 0.0, 0.00606604},
     {1484.2300556586272, 0.0, 0.0, 0.0, 164.852193523287, 0.0, 0.0, 0.0, 164.852193523287}},
    {"right_hand", 0.42, {0.0, 0.0, -0.08},
     {0.0012355, 0.0, 0.0, 0.0, 0.001043, 0.0, 0.0, 0.0, 0.0002555},
     {809.3889113719142, 0.0, 0.0, 0.0, 958.7727708533076, 0.0, 0.0, 0.0, 3913.894324853229}},
} };

constexpr std::array<JointConstants, kJointCount> kJoints{ {
    {"root", JointKind::kFloating, 0, 0, 7, 0, 6,
     {1.0, 0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 1.0},
     {0.0, 0.0, 0.95}, -1, 0.0, 0.0},
    {"left_hip", JointKind::kSpherical, 1, 7, 4, 6, 3,
     {1.0, 0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 1.0},
     {0.0, 0.09, -0.04}, -1, 0.0, 0.0},
    {"left_knee", JointKind::kRevolute, 2, 11, 1, 9, 1,
     {0.0, 1.0, 0.0, 0.0, 0.0, 1.0, 1.0, 0.0, 0.0},
     {0.0, 0.0, -0.41}, -1, 0.0, 0.0},
    {"left_ankle", JointKind::kSpherical, 3, 12, 4, 10, 3,
     {0.0, 0.0, 1.0, 1.0, 0.0, 0.0, 0.0, 1.0, 0.0},
     {-0.41, 0.0, 0.0}, -1, 0.0, 0.0},
    {"right_hip", JointKind::kSpherical, 1, 16, 4, 13, 3,
     {1.0, 0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 1.0},
     {0.0, -0.09, -0.04}, -1, 0.0, 0.0},
    {"right_knee", JointKind::kRevolute, 5, 20, 1, 16, 1,
     {0.0, 1.0, 0.0, 0.0, 0.0, 1.0, 1.0, 0.0, 0.0},
     {0.0, 0.0, -0.41}, -1, 0.0, 0.0},
    {"right_ankle", JointKind::kSpherical, 6, 21, 4, 17, 3,
     {0.0, 0.0, 1.0, 1.0, 0.0, 0.0, 0.0, 1.0, 0.0},
     {-0.41, 0.0, 0.0}, -1, 0.0, 0.0},
    {"spine", JointKind::kSpherical, 1, 25, 4, 20, 3,
     {1.0, 0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 1.0},
     {0.0, 0.0, 0.13}, -1, 0.0, 0.0},
    {"left_shoulder", JointKind::kSpherical, 8, 29, 4, 23, 3,
     {1.0, 0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 1.0},
     {0.0, 0.2, 0.42}, -1, 0.0, 0.0},
    {"left_elbow", JointKind::kRevolute, 9, 33, 1, 26, 1,
     {0.0, 1.0, 0.0, 0.0, 0.0, 1.0, 1.0, 0.0, 0.0},
     {0.0, 0.0, -0.29}, -1, 0.0, 0.0},
    {"left_wrist", JointKind::kSpherical, 10, 34, 4, 27, 3,
     {0.0, 0.0, 1.0, 1.0, 0.0, 0.0, 0.0, 1.0, 0.0},
     {-0.26, 0.0, 0.0}, -1, 0.0, 0.0},
    {"neck", JointKind::kSpherical, 8, 38, 4, 30, 3,
     {1.0, 0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 1.0},
     {0.0, 0.0, 0.48}, -1, 0.0, 0.0},
    {"right_shoulder", JointKind::kSpherical, 8, 42, 4, 33, 3,
     {1.0, 0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 1.0},
     {0.0, -0.2, 0.42}, -1, 0.0, 0.0},
    {"right_elbow", JointKind::kRevolute, 13, 46, 1, 36, 1,
     {0.0, 1.0, 0.0, 0.0, 0.0, 1.0, 1.0, 0.0, 0.0},
     {0.0, 0.0, -0.29}, -1, 0.0, 0.0},
    {"right_wrist", JointKind::kSpherical, 14, 47, 4, 37, 3,
     {0.0, 0.0, 1.0, 1.0, 0.0, 0.0, 0.0, 1.0, 0.0},
     {-0.26, 0.0, 0.0}, -1, 0.0, 0.0},
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

// ---- 4. joints ----------------------------------------------------------------------------------

// The memory of a process. Whatever belongs to a joint is kept with it.
struct Workspace;

struct Joint_root {
  Transform X;  // parent link's to child link's frame
  Vec6 v;  // velocity of link "pelvis"
  Columns6 b;  // bias of the bare link "pelvis"
  Joined<Floating> joined;
};

struct Joint_left_hip {
  Transform X;  // parent link's to child link's frame
  Vec6 v;  // velocity of link "left_thigh"
  Columns6 b;  // bias of the bare link "left_thigh"
  Mat6 Phi_pelvis;  // of the chain it completes
  Columns6 b_pelvis;
  Joined<Spherical> joined;
  Coupled<Spherical> at_pelvis;
  Columns6 F_on_pelvis;  // outer wrench on that chain
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

struct Joint_left_ankle {
  Transform X;  // parent link's to child link's frame
  Vec6 v;  // velocity of link "left_foot"
  Columns6 b;  // bias of the bare link "left_foot"
  Mat6 Phi_left_shank;  // of the chain it completes
  Columns6 b_left_shank;
  Joined<Spherical> joined;
  Coupled<Spherical> at_left_shank;
  Columns6 F_on_left_shank;  // outer wrench on that chain
};

struct Joint_right_hip {
  Transform X;  // parent link's to child link's frame
  Vec6 v;  // velocity of link "right_thigh"
  Columns6 b;  // bias of the bare link "right_thigh"
  Mat6 Phi_pelvis;  // of the chain it completes
  Columns6 b_pelvis;
  Joined<Spherical> joined;
  Coupled<Spherical> at_pelvis;
  Columns6 F_on_pelvis;  // outer wrench on that chain
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

struct Joint_right_ankle {
  Transform X;  // parent link's to child link's frame
  Vec6 v;  // velocity of link "right_foot"
  Columns6 b;  // bias of the bare link "right_foot"
  Mat6 Phi_right_shank;  // of the chain it completes
  Columns6 b_right_shank;
  Joined<Spherical> joined;
  Coupled<Spherical> at_right_shank;
  Columns6 F_on_right_shank;  // outer wrench on that chain
};

struct Joint_spine {
  Transform X;  // parent link's to child link's frame
  Vec6 v;  // velocity of link "trunk"
  Columns6 b;  // bias of the bare link "trunk"
  Mat6 Phi_pelvis;  // of the chain it completes
  Columns6 b_pelvis;
  Joined<Spherical> joined;
  Coupled<Spherical> at_pelvis;
  Columns6 F_on_pelvis;  // outer wrench on that chain
};

struct Joint_left_shoulder {
  Transform X;  // parent link's to child link's frame
  Vec6 v;  // velocity of link "left_upper_arm"
  Columns6 b;  // bias of the bare link "left_upper_arm"
  Mat6 Phi_trunk;  // of the chain it completes
  Columns6 b_trunk;
  Joined<Spherical> joined;
  Coupled<Spherical> at_trunk;
  Columns6 F_on_trunk;  // outer wrench on that chain
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

struct Joint_left_wrist {
  Transform X;  // parent link's to child link's frame
  Vec6 v;  // velocity of link "left_hand"
  Columns6 b;  // bias of the bare link "left_hand"
  Mat6 Phi_left_forearm;  // of the chain it completes
  Columns6 b_left_forearm;
  Joined<Spherical> joined;
  Coupled<Spherical> at_left_forearm;
  Columns6 F_on_left_forearm;  // outer wrench on that chain
};

struct Joint_neck {
  Transform X;  // parent link's to child link's frame
  Vec6 v;  // velocity of link "head"
  Columns6 b;  // bias of the bare link "head"
  Mat6 Phi_trunk;  // of the chain it completes
  Columns6 b_trunk;
  Joined<Spherical> joined;
  Coupled<Spherical> at_trunk;
  Columns6 F_on_trunk;  // outer wrench on that chain
};

struct Joint_right_shoulder {
  Transform X;  // parent link's to child link's frame
  Vec6 v;  // velocity of link "right_upper_arm"
  Columns6 b;  // bias of the bare link "right_upper_arm"
  Mat6 Phi_trunk;  // of the chain it completes
  Columns6 b_trunk;
  Joined<Spherical> joined;
  Coupled<Spherical> at_trunk;
  Columns6 F_on_trunk;  // outer wrench on that chain
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

struct Joint_right_wrist {
  Transform X;  // parent link's to child link's frame
  Vec6 v;  // velocity of link "right_hand"
  Columns6 b;  // bias of the bare link "right_hand"
  Mat6 Phi_right_forearm;  // of the chain it completes
  Columns6 b_right_forearm;
  Joined<Spherical> joined;
  Coupled<Spherical> at_right_forearm;
  Columns6 F_on_right_forearm;  // outer wrench on that chain
};

struct Workspace {
  const Number* q = nullptr;
  const Number* v = nullptr;
  const Number* tau = nullptr;
  Number* qdd = nullptr;
  int status = kFine;
  int near_lock = 0;  // 1 + the last joint of a run that has been near gimbal lock; 0: none
  Columns6 ground;  // its acceleration
  Joint_root j_root;
  Joint_left_hip j_left_hip;
  Joint_left_knee j_left_knee;
  Joint_left_ankle j_left_ankle;
  Joint_right_hip j_right_hip;
  Joint_right_knee j_right_knee;
  Joint_right_ankle j_right_ankle;
  Joint_spine j_spine;
  Joint_left_shoulder j_left_shoulder;
  Joint_left_elbow j_left_elbow;
  Joint_left_wrist j_left_wrist;
  Joint_neck j_neck;
  Joint_right_shoulder j_right_shoulder;
  Joint_right_elbow j_right_elbow;
  Joint_right_wrist j_right_wrist;

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

const Mat6 kPhi_pelvis = symmetric({9.615384615384615, 0.0, 0.0, 0.0, 0.2884615384615385, 0.0, 19.054878048780488, 0.0, -0.5716463414634146, 0.0, 0.0, 10.813148788927334, 0.0, 0.0, 0.0, 0.12131605691056911, 0.0, 0.0, 0.11282051282051282, 0.0, 0.10416666666666667});
const Mat6 kPhi_left_thigh = symmetric({7.971938775510204, 0.0, 0.0, 0.0, -1.5146683673469388, 0.0, 7.971938775510204, 0.0, 1.5146683673469388, 0.0, 0.0, 37.20238095238095, 0.0, 0.0, 0.0, 0.40683460884353745, 0.0, 0.0, 0.40683460884353745, 0.0, 0.11904761904761904});
const Mat6 kPhi_left_shank = symmetric({250.0, 0.0, 0.0, 0.0, 0.0, 0.0, 22.388042993997768, 0.0, 0.0, 0.0, -4.029847738919598, 22.388042993997768, 0.0, 4.029847738919598, 0.0, 0.3125, 0.0, 0.0, 1.0378725930055277, 0.0, 1.0378725930055277});
const Mat6 kPhi_left_foot = symmetric({923.0797633223488, 0.0, 0.0, 0.0, -36.92319053289395, 0.0, 178.04143736413212, 0.0, 7.1216574945652855, 0.0, 10.682486241847927, 169.97176768938678, 0.0, -10.198306061363207, 0.0, 1.2848662997826115, 0.0, 0.4272994496739171, 3.0888259849975506, 0.0, 1.6409491745108757});
const Mat6 kPhi_right_thigh = symmetric({7.971938775510204, 0.0, 0.0, 0.0, -1.5146683673469388, 0.0, 7.971938775510204, 0.0, 1.5146683673469388, 0.0, 0.0, 37.20238095238095, 0.0, 0.0, 0.0, 0.40683460884353745, 0.0, 0.0, 0.40683460884353745, 0.0, 0.11904761904761904});
const Mat6 kPhi_right_shank = symmetric({250.0, 0.0, 0.0, 0.0, 0.0, 0.0, 22.388042993997768, 0.0, 0.0, 0.0, -4.029847738919598, 22.388042993997768, 0.0, 4.029847738919598, 0.0, 0.3125, 0.0, 0.0, 1.0378725930055277, 0.0, 1.0378725930055277});
const Mat6 kPhi_right_foot = symmetric({923.0797633223488, 0.0, 0.0, 0.0, -36.92319053289395, 0.0, 178.04143736413212, 0.0, 7.1216574945652855, 0.0, 10.682486241847927, 169.97176768938678, 0.0, -10.198306061363207, 0.0, 1.2848662997826115, 0.0, 0.4272994496739171, 3.0888259849975506, 0.0, 1.6409491745108757});
const Mat6 kPhi_trunk = symmetric({1.661590507665748, 0.0, 0.0, 0.0, 0.38216581676312206, 0.0, 2.1382736006602987, 0.0, -0.49180292815186877, 0.0, 0.0, 3.870463333165613, 0.0, 0.0, 0.0, 0.15659293434449503, 0.0, 0.0, 0.1313763987250833, 0.0, 0.043478260869565216});
const Mat6 kPhi_left_upper_arm = symmetric({74.76523715533226, 0.0, 0.0, 0.0, -10.467133201746517, 0.0, 74.76523715533226, 0.0, 10.467133201746517, 0.0, 0.0, 519.8180636777129, 0.0, 0.0, 0.0, 1.9917144377181968, 0.0, 0.0, 1.9917144377181968, 0.0, 0.5263157894736842});
const Mat6 kPhi_left_forearm = symmetric({1484.2300556586272, 0.0, 0.0, 0.0, 0.0, 0.0, 164.852193523287, 0.0, 0.0, 0.0, -19.78226322279444, 164.852193523287, 0.0, 19.78226322279444, 0.0, 0.9090909090909091, 0.0, 0.0, 3.2829624958262418, 0.0, 3.2829624958262418});
const Mat6 kPhi_left_hand = symmetric({809.3889113719142, 0.0, 0.0, 0.0, -64.75111290975313, 0.0, 958.7727708533076, 0.0, 76.70182166826461, 0.0, 0.0, 3913.894324853229, 0.0, 0.0, 0.0, 8.51709811441355, 0.0, 0.0, 7.561041413732632, 0.0, 2.380952380952381});
const Mat6 kPhi_head = symmetric({51.02040816326531, 0.0, 0.0, 0.0, 7.142857142857144, 0.0, 51.02040816326531, 0.0, -7.142857142857144, 0.0, 0.5102040816326531, 51.02040816326531, 0.0, -0.5102040816326531, 0.0, 1.2040816326530615, 0.0, -0.07142857142857144, 1.209183673469388, 0.0, 0.20918367346938774});
const Mat6 kPhi_right_upper_arm = symmetric({74.76523715533226, 0.0, 0.0, 0.0, -10.467133201746517, 0.0, 74.76523715533226, 0.0, 10.467133201746517, 0.0, 0.0, 519.8180636777129, 0.0, 0.0, 0.0, 1.9917144377181968, 0.0, 0.0, 1.9917144377181968, 0.0, 0.5263157894736842});
const Mat6 kPhi_right_forearm = symmetric({1484.2300556586272, 0.0, 0.0, 0.0, 0.0, 0.0, 164.852193523287, 0.0, 0.0, 0.0, -19.78226322279444, 164.852193523287, 0.0, 19.78226322279444, 0.0, 0.9090909090909091, 0.0, 0.0, 3.2829624958262418, 0.0, 3.2829624958262418});
const Mat6 kPhi_right_hand = symmetric({809.3889113719142, 0.0, 0.0, 0.0, -64.75111290975313, 0.0, 958.7727708533076, 0.0, 76.70182166826461, 0.0, 0.0, 3913.894324853229, 0.0, 0.0, 0.0, 8.51709811441355, 0.0, 0.0, 7.561041413732632, 0.0, 2.380952380952381});

// =================================================================================================
// Joint 0 "root": floating, between links "world" and "pelvis"
// =================================================================================================

void kinematics_root(Workspace& w) {
  auto& i = w.j_root;
  require_finite(w, w.q + 0, 7, 0);
  require_finite(w, w.v + 0, 6, 0);
  const Number* const q = w.q + 0;
  require_length(w, conjugate_rotation(q + 3, i.X.E), 0);
  i.X.r << q[0], q[1], 0.95 + q[2];
  i.v = joint_velocity<Floating>(w.v + 0);
}

// A: the ground "world"; B: the chain of "left_hip"; C feels the joint at no link
void assemble_root(Workspace& w) {
  auto& i = w.j_root;
  load_torque(w, 0, 0, i.joined.tau);
  const Columns6 c = Columns6::Zero();
  constexpr std::array<Real, 6> least{1.3664283380001926e-13, 2.7078610356711135e-13, 1.5366408645330884e-13, 1.7240048593772757e-15, 1.6032759165868928e-15, 1.4802973661668755e-15};
  if (!keeps_digits<Floating>(kZero, w.j_left_hip.Phi_pelvis, least))
    fail(w, kGrowth, 0);
  if (!join(i.joined, kZero, w.j_left_hip.Phi_pelvis, i.X * w.ground, w.j_left_hip.b_pelvis, c))
    fail(w, kFactorization, 0);
}

void disassemble_root(Workspace& w) {
  auto& i = w.j_root;
  Release<Floating> release(i.joined);
  const Columns6 f = release.force();  // Eq. (8), (10)
  store_acceleration(w, 0, 0, release.qdd());  // Eq. (9)
  w.j_left_hip.F_on_pelvis = f;
}

// =================================================================================================
// Joint 1 "left_hip": spherical, between links "pelvis" and "left_thigh"
// =================================================================================================

void kinematics_left_hip(Workspace& w) {
  auto& i = w.j_left_hip;
  require_finite(w, w.q + 7, 4, 1);
  require_finite(w, w.v + 6, 3, 1);
  const Number* const q = w.q + 7;
  require_length(w, conjugate_rotation(q, i.X.E), 1);
  i.X.r << 0.0, 0.09, -0.04;
  i.v = i.X * w.j_root.v + joint_velocity<Spherical>(w.v + 6);
}

// A: the chain of "right_hip"; B: the chain of "left_knee"; C feels the joint at "pelvis"
void assemble_left_hip(Workspace& w) {
  auto& i = w.j_left_hip;
  load_torque(w, 1, 6, i.joined.tau);
  const Mat6 X_Phi_A = i.X * w.j_right_hip.Phi_pelvis;
  const Mat6 Phi_A = from_right(X_Phi_A, i.X);
  const Columns6 c = velocity_product<Spherical>(i.v, w.v + 6);
  constexpr std::array<Real, 6> least{1.7036893903932547e-13, 1.7036893903932547e-13, 5.857585060759486e-13, 7.261764885558423e-15, 7.261764885558423e-15, 3.172065784643304e-15};
  if (!keeps_digits<Spherical>(Phi_A, w.j_left_knee.Phi_left_thigh, least))
    fail(w, kGrowth, 1);
  if (!join(i.joined, Phi_A, w.j_left_knee.Phi_left_thigh, i.X * w.j_right_hip.b_pelvis, w.j_left_knee.b_left_thigh, c))
    fail(w, kFactorization, 1);
  couple(i.joined, X_Phi_A, i.at_pelvis);
  i.Phi_pelvis = w.j_right_hip.Phi_pelvis - product(i.at_pelvis, i.at_pelvis);  // Eq. (3)
  i.b_pelvis = w.j_right_hip.b_pelvis - bias_change(i.joined, i.at_pelvis);  // Eq. (6)
}

void disassemble_left_hip(Workspace& w) {
  auto& i = w.j_left_hip;
  Release<Spherical> release(i.joined);
  release.feel_A(i.at_pelvis, w.j_left_hip.F_on_pelvis);
  const Columns6 f = release.force();  // Eq. (8), (10)
  store_acceleration(w, 1, 6, release.qdd());  // Eq. (9)
  w.j_right_hip.F_on_pelvis = w.j_left_hip.F_on_pelvis - i.X.transposed_times(f);
  w.j_left_knee.F_on_left_thigh = f;
}

// =================================================================================================
// Joint 2 "left_knee": revolute, between links "left_thigh" and "left_shank"
// =================================================================================================

void kinematics_left_knee(Workspace& w) {
  auto& i = w.j_left_knee;
  require_finite(w, w.q + 11, 1, 2);
  require_finite(w, w.v + 9, 1, 2);
  const Real q = Real(w.q[11]);
  const Real c = std::cos(q), s = std::sin(q);
  i.X.E << s, 0.0, c,  //
      c, 0.0, -s,  //
      0.0, 1.0, 0.0;
  i.X.r << 0.0, 0.0, -0.41;
  i.v = i.X * w.j_left_hip.v + joint_velocity<Revolute>(w.v + 9);
}

// A: link "left_thigh"; B: the chain of "left_ankle"; C feels the joint at "left_thigh"
void assemble_left_knee(Workspace& w) {
  auto& i = w.j_left_knee;
  load_torque(w, 2, 9, i.joined.tau);
  const Mat6 X_Phi_A = i.X * kPhi_left_thigh;
  const Mat6 Phi_A = from_right(X_Phi_A, i.X);
  const Columns6 c = velocity_product<Revolute>(i.v, w.v + 9);
  constexpr std::array<Real, 6> least{3.6038760301657154e-12, 3.6931557771061296e-13, 3.6931557771061296e-13, 6.1326605169770555e-15, 1.6440825050567963e-14, 1.6440825050567963e-14};
  if (!keeps_digits<Revolute>(Phi_A, w.j_left_ankle.Phi_left_shank, least))
    fail(w, kGrowth, 2);
  if (!join(i.joined, Phi_A, w.j_left_ankle.Phi_left_shank, i.X * w.j_left_hip.b, w.j_left_ankle.b_left_shank, c))
    fail(w, kFactorization, 2);
  couple(i.joined, X_Phi_A, i.at_left_thigh);
  i.Phi_left_thigh = kPhi_left_thigh - product(i.at_left_thigh, i.at_left_thigh);  // Eq. (3)
  i.b_left_thigh = w.j_left_hip.b - bias_change(i.joined, i.at_left_thigh);  // Eq. (6)
}

void disassemble_left_knee(Workspace& w) {
  auto& i = w.j_left_knee;
  Release<Revolute> release(i.joined);
  release.feel_A(i.at_left_thigh, w.j_left_knee.F_on_left_thigh);
  const Columns6 f = release.force();  // Eq. (8), (10)
  store_acceleration(w, 2, 9, release.qdd());  // Eq. (9)
  w.j_left_ankle.F_on_left_shank = f;
}

// =================================================================================================
// Joint 3 "left_ankle": spherical, between links "left_shank" and "left_foot"
// =================================================================================================

void kinematics_left_ankle(Workspace& w) {
  auto& i = w.j_left_ankle;
  require_finite(w, w.q + 12, 4, 3);
  require_finite(w, w.v + 10, 3, 3);
  const Number* const q = w.q + 12;
  Mat3 Q;
  require_length(w, conjugate_rotation(q, Q), 3);
  i.X.E << Q(0, 2), Q(0, 0), Q(0, 1),  //
      Q(1, 2), Q(1, 0), Q(1, 1),  //
      Q(2, 2), Q(2, 0), Q(2, 1);
  i.X.r << -0.41, 0.0, 0.0;
  i.v = i.X * w.j_left_knee.v + joint_velocity<Spherical>(w.v + 10);
}

// A: link "left_shank"; B: link "left_foot"; C feels the joint at "left_shank"
void assemble_left_ankle(Workspace& w) {
  auto& i = w.j_left_ankle;
  load_torque(w, 3, 10, i.joined.tau);
  const Mat6 X_Phi_A = i.X * kPhi_left_shank;
  const Mat6 Phi_A = from_right(X_Phi_A, i.X);
  const Columns6 c = velocity_product<Spherical>(i.v, w.v + 10);
  constexpr std::array<Real, 6> least{1.3270011456023364e-11, 2.682380048573834e-12, 2.5677031452263567e-12, 2.26999404131705e-14, 4.833574941184154e-14, 2.776018241250534e-14};
  if (!keeps_digits<Spherical>(Phi_A, kPhi_left_foot, least))
    fail(w, kGrowth, 3);
  if (!join(i.joined, Phi_A, kPhi_left_foot, i.X * w.j_left_knee.b, w.j_left_ankle.b, c))
    fail(w, kFactorization, 3);
  couple(i.joined, X_Phi_A, i.at_left_shank);
  i.Phi_left_shank = kPhi_left_shank - product(i.at_left_shank, i.at_left_shank);  // Eq. (3)
  i.b_left_shank = w.j_left_knee.b - bias_change(i.joined, i.at_left_shank);  // Eq. (6)
}

void disassemble_left_ankle(Workspace& w) {
  auto& i = w.j_left_ankle;
  Release<Spherical> release(i.joined);
  release.feel_A(i.at_left_shank, w.j_left_ankle.F_on_left_shank);
  release.force();  // Eq. (8)
  store_acceleration(w, 3, 10, release.qdd());  // Eq. (9)
}

// =================================================================================================
// Joint 4 "right_hip": spherical, between links "pelvis" and "right_thigh"
// =================================================================================================

void kinematics_right_hip(Workspace& w) {
  auto& i = w.j_right_hip;
  require_finite(w, w.q + 16, 4, 4);
  require_finite(w, w.v + 13, 3, 4);
  const Number* const q = w.q + 16;
  require_length(w, conjugate_rotation(q, i.X.E), 4);
  i.X.r << 0.0, -0.09, -0.04;
  i.v = i.X * w.j_root.v + joint_velocity<Spherical>(w.v + 13);
}

// A: the chain of "spine"; B: the chain of "right_knee"; C feels the joint at "pelvis"
void assemble_right_hip(Workspace& w) {
  auto& i = w.j_right_hip;
  load_torque(w, 4, 13, i.joined.tau);
  const Mat6 X_Phi_A = i.X * w.j_spine.Phi_pelvis;
  const Mat6 Phi_A = from_right(X_Phi_A, i.X);
  const Columns6 c = velocity_product<Spherical>(i.v, w.v + 13);
  constexpr std::array<Real, 6> least{1.7036893903932547e-13, 1.7036893903932547e-13, 5.857585060759486e-13, 7.261764885558423e-15, 7.261764885558423e-15, 3.172065784643304e-15};
  if (!keeps_digits<Spherical>(Phi_A, w.j_right_knee.Phi_right_thigh, least))
    fail(w, kGrowth, 4);
  if (!join(i.joined, Phi_A, w.j_right_knee.Phi_right_thigh, i.X * w.j_spine.b_pelvis, w.j_right_knee.b_right_thigh, c))
    fail(w, kFactorization, 4);
  couple(i.joined, X_Phi_A, i.at_pelvis);
  i.Phi_pelvis = w.j_spine.Phi_pelvis - product(i.at_pelvis, i.at_pelvis);  // Eq. (3)
  i.b_pelvis = w.j_spine.b_pelvis - bias_change(i.joined, i.at_pelvis);  // Eq. (6)
}

void disassemble_right_hip(Workspace& w) {
  auto& i = w.j_right_hip;
  Release<Spherical> release(i.joined);
  release.feel_A(i.at_pelvis, w.j_right_hip.F_on_pelvis);
  const Columns6 f = release.force();  // Eq. (8), (10)
  store_acceleration(w, 4, 13, release.qdd());  // Eq. (9)
  w.j_spine.F_on_pelvis = w.j_right_hip.F_on_pelvis - i.X.transposed_times(f);
  w.j_right_knee.F_on_right_thigh = f;
}

// =================================================================================================
// Joint 5 "right_knee": revolute, between links "right_thigh" and "right_shank"
// =================================================================================================

void kinematics_right_knee(Workspace& w) {
  auto& i = w.j_right_knee;
  require_finite(w, w.q + 20, 1, 5);
  require_finite(w, w.v + 16, 1, 5);
  const Real q = Real(w.q[20]);
  const Real c = std::cos(q), s = std::sin(q);
  i.X.E << s, 0.0, c,  //
      c, 0.0, -s,  //
      0.0, 1.0, 0.0;
  i.X.r << 0.0, 0.0, -0.41;
  i.v = i.X * w.j_right_hip.v + joint_velocity<Revolute>(w.v + 16);
}

// A: link "right_thigh"; B: the chain of "right_ankle"; C feels the joint at "right_thigh"
void assemble_right_knee(Workspace& w) {
  auto& i = w.j_right_knee;
  load_torque(w, 5, 16, i.joined.tau);
  const Mat6 X_Phi_A = i.X * kPhi_right_thigh;
  const Mat6 Phi_A = from_right(X_Phi_A, i.X);
  const Columns6 c = velocity_product<Revolute>(i.v, w.v + 16);
  constexpr std::array<Real, 6> least{3.6038760301657154e-12, 3.6931557771061296e-13, 3.6931557771061296e-13, 6.1326605169770555e-15, 1.6440825050567963e-14, 1.6440825050567963e-14};
  if (!keeps_digits<Revolute>(Phi_A, w.j_right_ankle.Phi_right_shank, least))
    fail(w, kGrowth, 5);
  if (!join(i.joined, Phi_A, w.j_right_ankle.Phi_right_shank, i.X * w.j_right_hip.b, w.j_right_ankle.b_right_shank, c))
    fail(w, kFactorization, 5);
  couple(i.joined, X_Phi_A, i.at_right_thigh);
  i.Phi_right_thigh = kPhi_right_thigh - product(i.at_right_thigh, i.at_right_thigh);  // Eq. (3)
  i.b_right_thigh = w.j_right_hip.b - bias_change(i.joined, i.at_right_thigh);  // Eq. (6)
}

void disassemble_right_knee(Workspace& w) {
  auto& i = w.j_right_knee;
  Release<Revolute> release(i.joined);
  release.feel_A(i.at_right_thigh, w.j_right_knee.F_on_right_thigh);
  const Columns6 f = release.force();  // Eq. (8), (10)
  store_acceleration(w, 5, 16, release.qdd());  // Eq. (9)
  w.j_right_ankle.F_on_right_shank = f;
}

// =================================================================================================
// Joint 6 "right_ankle": spherical, between links "right_shank" and "right_foot"
// =================================================================================================

void kinematics_right_ankle(Workspace& w) {
  auto& i = w.j_right_ankle;
  require_finite(w, w.q + 21, 4, 6);
  require_finite(w, w.v + 17, 3, 6);
  const Number* const q = w.q + 21;
  Mat3 Q;
  require_length(w, conjugate_rotation(q, Q), 6);
  i.X.E << Q(0, 2), Q(0, 0), Q(0, 1),  //
      Q(1, 2), Q(1, 0), Q(1, 1),  //
      Q(2, 2), Q(2, 0), Q(2, 1);
  i.X.r << -0.41, 0.0, 0.0;
  i.v = i.X * w.j_right_knee.v + joint_velocity<Spherical>(w.v + 17);
}

// A: link "right_shank"; B: link "right_foot"; C feels the joint at "right_shank"
void assemble_right_ankle(Workspace& w) {
  auto& i = w.j_right_ankle;
  load_torque(w, 6, 17, i.joined.tau);
  const Mat6 X_Phi_A = i.X * kPhi_right_shank;
  const Mat6 Phi_A = from_right(X_Phi_A, i.X);
  const Columns6 c = velocity_product<Spherical>(i.v, w.v + 17);
  constexpr std::array<Real, 6> least{1.3270011456023364e-11, 2.682380048573834e-12, 2.5677031452263567e-12, 2.26999404131705e-14, 4.833574941184154e-14, 2.776018241250534e-14};
  if (!keeps_digits<Spherical>(Phi_A, kPhi_right_foot, least))
    fail(w, kGrowth, 6);
  if (!join(i.joined, Phi_A, kPhi_right_foot, i.X * w.j_right_knee.b, w.j_right_ankle.b, c))
    fail(w, kFactorization, 6);
  couple(i.joined, X_Phi_A, i.at_right_shank);
  i.Phi_right_shank = kPhi_right_shank - product(i.at_right_shank, i.at_right_shank);  // Eq. (3)
  i.b_right_shank = w.j_right_knee.b - bias_change(i.joined, i.at_right_shank);  // Eq. (6)
}

void disassemble_right_ankle(Workspace& w) {
  auto& i = w.j_right_ankle;
  Release<Spherical> release(i.joined);
  release.feel_A(i.at_right_shank, w.j_right_ankle.F_on_right_shank);
  release.force();  // Eq. (8)
  store_acceleration(w, 6, 17, release.qdd());  // Eq. (9)
}

// =================================================================================================
// Joint 7 "spine": spherical, between links "pelvis" and "trunk"
// =================================================================================================

void kinematics_spine(Workspace& w) {
  auto& i = w.j_spine;
  require_finite(w, w.q + 25, 4, 7);
  require_finite(w, w.v + 20, 3, 7);
  const Number* const q = w.q + 25;
  require_length(w, conjugate_rotation(q, i.X.E), 7);
  i.X.r << 0.0, 0.0, 0.13;
  i.v = i.X * w.j_root.v + joint_velocity<Spherical>(w.v + 20);
}

// A: link "pelvis"; B: the chain of "left_shoulder"; C feels the joint at "pelvis"
void assemble_spine(Workspace& w) {
  auto& i = w.j_spine;
  load_torque(w, 7, 20, i.joined.tau);
  const Mat6 X_Phi_A = i.X * kPhi_pelvis;
  const Mat6 Phi_A = from_right(X_Phi_A, i.X);
  const Columns6 c = velocity_product<Spherical>(i.v, w.v + 20);
  constexpr std::array<Real, 6> least{8.069349660266129e-14, 8.746757078239997e-14, 1.1208346741019762e-13, 3.70561680556366e-15, 3.347268281455484e-15, 2.098160614653919e-15};
  if (!keeps_digits<Spherical>(Phi_A, w.j_left_shoulder.Phi_trunk, least))
    fail(w, kGrowth, 7);
  if (!join(i.joined, Phi_A, w.j_left_shoulder.Phi_trunk, i.X * w.j_root.b, w.j_left_shoulder.b_trunk, c))
    fail(w, kFactorization, 7);
  couple(i.joined, X_Phi_A, i.at_pelvis);
  i.Phi_pelvis = kPhi_pelvis - product(i.at_pelvis, i.at_pelvis);  // Eq. (3)
  i.b_pelvis = w.j_root.b - bias_change(i.joined, i.at_pelvis);  // Eq. (6)
}

void disassemble_spine(Workspace& w) {
  auto& i = w.j_spine;
  Release<Spherical> release(i.joined);
  release.feel_A(i.at_pelvis, w.j_spine.F_on_pelvis);
  const Columns6 f = release.force();  // Eq. (8), (10)
  store_acceleration(w, 7, 20, release.qdd());  // Eq. (9)
  w.j_left_shoulder.F_on_trunk = f;
}

// =================================================================================================
// Joint 8 "left_shoulder": spherical, between links "trunk" and "left_upper_arm"
// =================================================================================================

void kinematics_left_shoulder(Workspace& w) {
  auto& i = w.j_left_shoulder;
  require_finite(w, w.q + 29, 4, 8);
  require_finite(w, w.v + 23, 3, 8);
  const Number* const q = w.q + 29;
  require_length(w, conjugate_rotation(q, i.X.E), 8);
  i.X.r << 0.0, 0.2, 0.42;
  i.v = i.X * w.j_spine.v + joint_velocity<Spherical>(w.v + 23);
}

// A: the chain of "neck"; B: the chain of "left_elbow"; C feels the joint at "trunk"
void assemble_left_shoulder(Workspace& w) {
  auto& i = w.j_left_shoulder;
  load_torque(w, 8, 23, i.joined.tau);
  const Mat6 X_Phi_A = i.X * w.j_neck.Phi_trunk;
  const Mat6 Phi_A = from_right(X_Phi_A, i.X);
  const Columns6 c = velocity_product<Spherical>(i.v, w.v + 23);
  constexpr std::array<Real, 6> least{1.073179939591126e-12, 1.073179939591126e-12, 7.397760997890678e-12, 2.892182775707059e-14, 2.892182775707059e-14, 8.097260467014413e-15};
  if (!keeps_digits<Spherical>(Phi_A, w.j_left_elbow.Phi_left_upper_arm, least))
    fail(w, kGrowth, 8);
  if (!join(i.joined, Phi_A, w.j_left_elbow.Phi_left_upper_arm, i.X * w.j_neck.b_trunk, w.j_left_elbow.b_left_upper_arm, c))
    fail(w, kFactorization, 8);
  couple(i.joined, X_Phi_A, i.at_trunk);
  i.Phi_trunk = w.j_neck.Phi_trunk - product(i.at_trunk, i.at_trunk);  // Eq. (3)
  i.b_trunk = w.j_neck.b_trunk - bias_change(i.joined, i.at_trunk);  // Eq. (6)
}

void disassemble_left_shoulder(Workspace& w) {
  auto& i = w.j_left_shoulder;
  Release<Spherical> release(i.joined);
  release.feel_A(i.at_trunk, w.j_left_shoulder.F_on_trunk);
  const Columns6 f = release.force();  // Eq. (8), (10)
  store_acceleration(w, 8, 23, release.qdd());  // Eq. (9)
  w.j_neck.F_on_trunk = w.j_left_shoulder.F_on_trunk - i.X.transposed_times(f);
  w.j_left_elbow.F_on_left_upper_arm = f;
}

// =================================================================================================
// Joint 9 "left_elbow": revolute, between links "left_upper_arm" and "left_forearm"
// =================================================================================================

void kinematics_left_elbow(Workspace& w) {
  auto& i = w.j_left_elbow;
  require_finite(w, w.q + 33, 1, 9);
  require_finite(w, w.v + 26, 1, 9);
  const Real q = Real(w.q[33]);
  const Real c = std::cos(q), s = std::sin(q);
  i.X.E << s, 0.0, c,  //
      c, 0.0, -s,  //
      0.0, 1.0, 0.0;
  i.X.r << 0.0, 0.0, -0.29;
  i.v = i.X * w.j_left_shoulder.v + joint_velocity<Revolute>(w.v + 26);
}

// A: link "left_upper_arm"; B: the chain of "left_wrist"; C feels the joint at "left_upper_arm"
void assemble_left_elbow(Workspace& w) {
  auto& i = w.j_left_elbow;
  load_torque(w, 9, 26, i.joined.tau);
  const Mat6 X_Phi_A = i.X * kPhi_left_upper_arm;
  const Mat6 Phi_A = from_right(X_Phi_A, i.X);
  const Columns6 c = velocity_product<Revolute>(i.v, w.v + 26);
  constexpr std::array<Real, 6> least{2.1587775800806794e-11, 2.8382886875476563e-12, 2.8382886875476563e-12, 2.039835605052919e-14, 5.4133100282171055e-14, 5.4133100282171055e-14};
  if (!keeps_digits<Revolute>(Phi_A, w.j_left_wrist.Phi_left_forearm, least))
    fail(w, kGrowth, 9);
  if (!join(i.joined, Phi_A, w.j_left_wrist.Phi_left_forearm, i.X * w.j_left_shoulder.b, w.j_left_wrist.b_left_forearm, c))
    fail(w, kFactorization, 9);
  couple(i.joined, X_Phi_A, i.at_left_upper_arm);
  i.Phi_left_upper_arm = kPhi_left_upper_arm - product(i.at_left_upper_arm, i.at_left_upper_arm);  // Eq. (3)
  i.b_left_upper_arm = w.j_left_shoulder.b - bias_change(i.joined, i.at_left_upper_arm);  // Eq. (6)
}

void disassemble_left_elbow(Workspace& w) {
  auto& i = w.j_left_elbow;
  Release<Revolute> release(i.joined);
  release.feel_A(i.at_left_upper_arm, w.j_left_elbow.F_on_left_upper_arm);
  const Columns6 f = release.force();  // Eq. (8), (10)
  store_acceleration(w, 9, 26, release.qdd());  // Eq. (9)
  w.j_left_wrist.F_on_left_forearm = f;
}

// =================================================================================================
// Joint 10 "left_wrist": spherical, between links "left_forearm" and "left_hand"
// =================================================================================================

void kinematics_left_wrist(Workspace& w) {
  auto& i = w.j_left_wrist;
  require_finite(w, w.q + 34, 4, 10);
  require_finite(w, w.v + 27, 3, 10);
  const Number* const q = w.q + 34;
  Mat3 Q;
  require_length(w, conjugate_rotation(q, Q), 10);
  i.X.E << Q(0, 2), Q(0, 0), Q(0, 1),  //
      Q(1, 2), Q(1, 0), Q(1, 1),  //
      Q(2, 2), Q(2, 0), Q(2, 1);
  i.X.r << -0.26, 0.0, 0.0;
  i.v = i.X * w.j_left_elbow.v + joint_velocity<Spherical>(w.v + 27);
}

// A: link "left_forearm"; B: link "left_hand"; C feels the joint at "left_forearm"
void assemble_left_wrist(Workspace& w) {
  auto& i = w.j_left_wrist;
  load_torque(w, 10, 27, i.joined.tau);
  const Mat6 X_Phi_A = i.X * kPhi_left_forearm;
  const Mat6 Phi_A = from_right(X_Phi_A, i.X);
  const Columns6 c = velocity_product<Spherical>(i.v, w.v + 27);
  constexpr std::array<Real, 6> least{1.2611825810546583e-11, 1.4734698134432816e-11, 5.672950120408767e-11, 1.339542027310537e-13, 1.203678198581818e-13, 4.67543272015304e-14};
  if (!keeps_digits<Spherical>(Phi_A, kPhi_left_hand, least))
    fail(w, kGrowth, 10);
  if (!join(i.joined, Phi_A, kPhi_left_hand, i.X * w.j_left_elbow.b, w.j_left_wrist.b, c))
    fail(w, kFactorization, 10);
  couple(i.joined, X_Phi_A, i.at_left_forearm);
  i.Phi_left_forearm = kPhi_left_forearm - product(i.at_left_forearm, i.at_left_forearm);  // Eq. (3)
  i.b_left_forearm = w.j_left_elbow.b - bias_change(i.joined, i.at_left_forearm);  // Eq. (6)
}

void disassemble_left_wrist(Workspace& w) {
  auto& i = w.j_left_wrist;
  Release<Spherical> release(i.joined);
  release.feel_A(i.at_left_forearm, w.j_left_wrist.F_on_left_forearm);
  release.force();  // Eq. (8)
  store_acceleration(w, 10, 27, release.qdd());  // Eq. (9)
}

// =================================================================================================
// Joint 11 "neck": spherical, between links "trunk" and "head"
// =================================================================================================

void kinematics_neck(Workspace& w) {
  auto& i = w.j_neck;
  require_finite(w, w.q + 38, 4, 11);
  require_finite(w, w.v + 30, 3, 11);
  const Number* const q = w.q + 38;
  require_length(w, conjugate_rotation(q, i.X.E), 11);
  i.X.r << 0.0, 0.0, 0.48;
  i.v = i.X * w.j_spine.v + joint_velocity<Spherical>(w.v + 30);
}

// A: the chain of "right_shoulder"; B: link "head"; C feels the joint at "trunk"
void assemble_neck(Workspace& w) {
  auto& i = w.j_neck;
  load_torque(w, 11, 30, i.joined.tau);
  const Mat6 X_Phi_A = i.X * w.j_right_shoulder.Phi_trunk;
  const Mat6 Phi_A = from_right(X_Phi_A, i.X);
  const Columns6 c = velocity_product<Spherical>(i.v, w.v + 30);
  constexpr std::array<Real, 6> least{7.357456245475462e-13, 7.357456245475462e-13, 7.357456245475462e-13, 1.772889239536293e-14, 1.7801396756154775e-14, 3.590542040952769e-15};
  if (!keeps_digits<Spherical>(Phi_A, kPhi_head, least))
    fail(w, kGrowth, 11);
  if (!join(i.joined, Phi_A, kPhi_head, i.X * w.j_right_shoulder.b_trunk, w.j_neck.b, c))
    fail(w, kFactorization, 11);
  couple(i.joined, X_Phi_A, i.at_trunk);
  i.Phi_trunk = w.j_right_shoulder.Phi_trunk - product(i.at_trunk, i.at_trunk);  // Eq. (3)
  i.b_trunk = w.j_right_shoulder.b_trunk - bias_change(i.joined, i.at_trunk);  // Eq. (6)
}

void disassemble_neck(Workspace& w) {
  auto& i = w.j_neck;
  Release<Spherical> release(i.joined);
  release.feel_A(i.at_trunk, w.j_neck.F_on_trunk);
  const Columns6 f = release.force();  // Eq. (8), (10)
  store_acceleration(w, 11, 30, release.qdd());  // Eq. (9)
  w.j_right_shoulder.F_on_trunk = w.j_neck.F_on_trunk - i.X.transposed_times(f);
}

// =================================================================================================
// Joint 12 "right_shoulder": spherical, between links "trunk" and "right_upper_arm"
// =================================================================================================

void kinematics_right_shoulder(Workspace& w) {
  auto& i = w.j_right_shoulder;
  require_finite(w, w.q + 42, 4, 12);
  require_finite(w, w.v + 33, 3, 12);
  const Number* const q = w.q + 42;
  require_length(w, conjugate_rotation(q, i.X.E), 12);
  i.X.r << 0.0, -0.2, 0.42;
  i.v = i.X * w.j_spine.v + joint_velocity<Spherical>(w.v + 33);
}

// A: link "trunk"; B: the chain of "right_elbow"; C feels the joint at "trunk"
void assemble_right_shoulder(Workspace& w) {
  auto& i = w.j_right_shoulder;
  load_torque(w, 12, 33, i.joined.tau);
  const Mat6 X_Phi_A = i.X * kPhi_trunk;
  const Mat6 Phi_A = from_right(X_Phi_A, i.X);
  const Columns6 c = velocity_product<Spherical>(i.v, w.v + 33);
  constexpr std::array<Real, 6> least{1.073179939591126e-12, 1.073179939591126e-12, 7.397760997890678e-12, 2.892182775707059e-14, 2.892182775707059e-14, 8.097260467014413e-15};
  if (!keeps_digits<Spherical>(Phi_A, w.j_right_elbow.Phi_right_upper_arm, least))
    fail(w, kGrowth, 12);
  if (!join(i.joined, Phi_A, w.j_right_elbow.Phi_right_upper_arm, i.X * w.j_spine.b, w.j_right_elbow.b_right_upper_arm, c))
    fail(w, kFactorization, 12);
  couple(i.joined, X_Phi_A, i.at_trunk);
  i.Phi_trunk = kPhi_trunk - product(i.at_trunk, i.at_trunk);  // Eq. (3)
  i.b_trunk = w.j_spine.b - bias_change(i.joined, i.at_trunk);  // Eq. (6)
}

void disassemble_right_shoulder(Workspace& w) {
  auto& i = w.j_right_shoulder;
  Release<Spherical> release(i.joined);
  release.feel_A(i.at_trunk, w.j_right_shoulder.F_on_trunk);
  const Columns6 f = release.force();  // Eq. (8), (10)
  store_acceleration(w, 12, 33, release.qdd());  // Eq. (9)
  w.j_right_elbow.F_on_right_upper_arm = f;
}

// =================================================================================================
// Joint 13 "right_elbow": revolute, between links "right_upper_arm" and "right_forearm"
// =================================================================================================

void kinematics_right_elbow(Workspace& w) {
  auto& i = w.j_right_elbow;
  require_finite(w, w.q + 46, 1, 13);
  require_finite(w, w.v + 36, 1, 13);
  const Real q = Real(w.q[46]);
  const Real c = std::cos(q), s = std::sin(q);
  i.X.E << s, 0.0, c,  //
      c, 0.0, -s,  //
      0.0, 1.0, 0.0;
  i.X.r << 0.0, 0.0, -0.29;
  i.v = i.X * w.j_right_shoulder.v + joint_velocity<Revolute>(w.v + 36);
}

// A: link "right_upper_arm"; B: the chain of "right_wrist"; C feels the joint at "right_upper_arm"
void assemble_right_elbow(Workspace& w) {
  auto& i = w.j_right_elbow;
  load_torque(w, 13, 36, i.joined.tau);
  const Mat6 X_Phi_A = i.X * kPhi_right_upper_arm;
  const Mat6 Phi_A = from_right(X_Phi_A, i.X);
  const Columns6 c = velocity_product<Revolute>(i.v, w.v + 36);
  constexpr std::array<Real, 6> least{2.1587775800806794e-11, 2.8382886875476563e-12, 2.8382886875476563e-12, 2.039835605052919e-14, 5.4133100282171055e-14, 5.4133100282171055e-14};
  if (!keeps_digits<Revolute>(Phi_A, w.j_right_wrist.Phi_right_forearm, least))
    fail(w, kGrowth, 13);
  if (!join(i.joined, Phi_A, w.j_right_wrist.Phi_right_forearm, i.X * w.j_right_shoulder.b, w.j_right_wrist.b_right_forearm, c))
    fail(w, kFactorization, 13);
  couple(i.joined, X_Phi_A, i.at_right_upper_arm);
  i.Phi_right_upper_arm = kPhi_right_upper_arm - product(i.at_right_upper_arm, i.at_right_upper_arm);  // Eq. (3)
  i.b_right_upper_arm = w.j_right_shoulder.b - bias_change(i.joined, i.at_right_upper_arm);  // Eq. (6)
}

void disassemble_right_elbow(Workspace& w) {
  auto& i = w.j_right_elbow;
  Release<Revolute> release(i.joined);
  release.feel_A(i.at_right_upper_arm, w.j_right_elbow.F_on_right_upper_arm);
  const Columns6 f = release.force();  // Eq. (8), (10)
  store_acceleration(w, 13, 36, release.qdd());  // Eq. (9)
  w.j_right_wrist.F_on_right_forearm = f;
}

// =================================================================================================
// Joint 14 "right_wrist": spherical, between links "right_forearm" and "right_hand"
// =================================================================================================

void kinematics_right_wrist(Workspace& w) {
  auto& i = w.j_right_wrist;
  require_finite(w, w.q + 47, 4, 14);
  require_finite(w, w.v + 37, 3, 14);
  const Number* const q = w.q + 47;
  Mat3 Q;
  require_length(w, conjugate_rotation(q, Q), 14);
  i.X.E << Q(0, 2), Q(0, 0), Q(0, 1),  //
      Q(1, 2), Q(1, 0), Q(1, 1),  //
      Q(2, 2), Q(2, 0), Q(2, 1);
  i.X.r << -0.26, 0.0, 0.0;
  i.v = i.X * w.j_right_elbow.v + joint_velocity<Spherical>(w.v + 37);
}

// A: link "right_forearm"; B: link "right_hand"; C feels the joint at "right_forearm"
void assemble_right_wrist(Workspace& w) {
  auto& i = w.j_right_wrist;
  load_torque(w, 14, 37, i.joined.tau);
  const Mat6 X_Phi_A = i.X * kPhi_right_forearm;
  const Mat6 Phi_A = from_right(X_Phi_A, i.X);
  const Columns6 c = velocity_product<Spherical>(i.v, w.v + 37);
  constexpr std::array<Real, 6> least{1.2611825810546583e-11, 1.4734698134432816e-11, 5.672950120408767e-11, 1.339542027310537e-13, 1.203678198581818e-13, 4.67543272015304e-14};
  if (!keeps_digits<Spherical>(Phi_A, kPhi_right_hand, least))
    fail(w, kGrowth, 14);
  if (!join(i.joined, Phi_A, kPhi_right_hand, i.X * w.j_right_elbow.b, w.j_right_wrist.b, c))
    fail(w, kFactorization, 14);
  couple(i.joined, X_Phi_A, i.at_right_forearm);
  i.Phi_right_forearm = kPhi_right_forearm - product(i.at_right_forearm, i.at_right_forearm);  // Eq. (3)
  i.b_right_forearm = w.j_right_elbow.b - bias_change(i.joined, i.at_right_forearm);  // Eq. (6)
}

void disassemble_right_wrist(Workspace& w) {
  auto& i = w.j_right_wrist;
  Release<Spherical> release(i.joined);
  release.feel_A(i.at_right_forearm, w.j_right_wrist.F_on_right_forearm);
  release.force();  // Eq. (8)
  store_acceleration(w, 14, 37, release.qdd());  // Eq. (9)
}


// ---- 5. processes -------------------------------------------------------------------------------

// Process 0: 15 of 15 joints: "root", "left_hip", "left_knee", "left_ankle", "right_hip", "right_knee", ...
void run_0([[maybe_unused]] Workspace& w, [[maybe_unused]] Channel& channel) {
  w.ground = ground(w);
  stamp(0);
  kinematics_root(w);
  kinematics_left_hip(w);
  kinematics_left_knee(w);
  kinematics_left_ankle(w);
  kinematics_right_hip(w);
  kinematics_right_knee(w);
  kinematics_right_ankle(w);
  kinematics_spine(w);
  kinematics_left_shoulder(w);
  kinematics_left_elbow(w);
  kinematics_left_wrist(w);
  kinematics_neck(w);
  kinematics_right_shoulder(w);
  kinematics_right_elbow(w);
  kinematics_right_wrist(w);
  stamp(1);
  link_bias(kLinks[14], w.j_right_elbow.v, w.j_right_elbow.b);
  link_bias(kLinks[15], w.j_right_wrist.v, w.j_right_wrist.b);
  assemble_right_wrist(w);
  link_bias(kLinks[13], w.j_right_shoulder.v, w.j_right_shoulder.b);
  assemble_right_elbow(w);
  link_bias(kLinks[8], w.j_spine.v, w.j_spine.b);
  assemble_right_shoulder(w);
  link_bias(kLinks[12], w.j_neck.v, w.j_neck.b);
  assemble_neck(w);
  link_bias(kLinks[10], w.j_left_elbow.v, w.j_left_elbow.b);
  link_bias(kLinks[11], w.j_left_wrist.v, w.j_left_wrist.b);
  assemble_left_wrist(w);
  link_bias(kLinks[9], w.j_left_shoulder.v, w.j_left_shoulder.b);
  assemble_left_elbow(w);
  assemble_left_shoulder(w);
  link_bias(kLinks[1], w.j_root.v, w.j_root.b);
  assemble_spine(w);
  link_bias(kLinks[6], w.j_right_knee.v, w.j_right_knee.b);
  link_bias(kLinks[7], w.j_right_ankle.v, w.j_right_ankle.b);
  assemble_right_ankle(w);
  link_bias(kLinks[5], w.j_right_hip.v, w.j_right_hip.b);
  assemble_right_knee(w);
  assemble_right_hip(w);
  link_bias(kLinks[3], w.j_left_knee.v, w.j_left_knee.b);
  link_bias(kLinks[4], w.j_left_ankle.v, w.j_left_ankle.b);
  assemble_left_ankle(w);
  link_bias(kLinks[2], w.j_left_hip.v, w.j_left_hip.b);
  assemble_left_knee(w);
  assemble_left_hip(w);
  assemble_root(w);
  stamp(2);
  disassemble_root(w);
  disassemble_left_hip(w);
  disassemble_right_hip(w);
  disassemble_spine(w);
  disassemble_left_shoulder(w);
  disassemble_neck(w);
  disassemble_right_shoulder(w);
  disassemble_right_elbow(w);
  disassemble_right_wrist(w);
  disassemble_left_elbow(w);
  disassemble_left_wrist(w);
  disassemble_right_knee(w);
  disassemble_right_ankle(w);
  disassemble_left_knee(w);
  disassemble_left_ankle(w);
  stamp(3);
}

[[maybe_unused]] constexpr std::array<void (*)(Workspace&, Channel&), kProcesses> kRun{run_0};

// What each process reads of q and v, the velocity entries whose qdd is its own, and whose tau it
// reads.
constexpr std::array<Range, 1> kReadQ_0{ {{0, 51}} };
constexpr std::array<Range, 1> kReadV_0{ {{0, 40}} };
constexpr std::array<Range, 1> kOwn_0{ {{0, 40}} };
constexpr std::array<Range, 1> kTorque_0{ {{0, 40}} };
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

static_assert(HUMAN40_P1_NQ == kNq && HUMAN40_P1_NV == kNv && HUMAN40_P1_NTAU == kNtau);
static_assert(int(HUMAN40_P1_FINE) == int(kFine));
static_assert(int(HUMAN40_P1_NOT_FINITE) == int(kNotFinite));
static_assert(int(HUMAN40_P1_ZERO_QUATERNION) == int(kZeroQuaternion));
static_assert(int(HUMAN40_P1_FACTORIZATION) == int(kFactorization));
static_assert(int(HUMAN40_P1_OVERFLOW) == int(kOverflow));
static_assert(int(HUMAN40_P1_NO_ANSWER) == int(kNoAnswer));
static_assert(int(HUMAN40_P1_ENDED) == int(kEnded));
static_assert(int(HUMAN40_P1_NOT_REFINED) == int(kNotRefined));
static_assert(int(HUMAN40_P1_GIMBAL_LOCK) == int(kGimbalLock));
static_assert(int(HUMAN40_P1_GROWTH) == int(kGrowth));
static_assert(int(HUMAN40_P1_NOT_SET) == int(kNotSet));
static_assert(int(HUMAN40_P1_TOO_FEW_STEPS) == int(kTooFewSteps));
static_assert(int(HUMAN40_P1_LOOP_OPEN) == int(kLoopOpen));
static_assert(int(HUMAN40_P1_LOOP_TORN) == int(kLoopTorn));
static_assert(int(HUMAN40_P1_LOOP_SINGULAR) == int(kLoopSingular));
static_assert(int(HUMAN40_P1_LOOP_FREE) == int(kLoopFree));

struct human40_p1_solver : Solver {};

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

int human40_p1_joint(int k, const char** name, int* q, int* nq, int* v, int* nv) {
  if (k < 0 || k >= kJointCount) return 0;
  const JointConstants& joint = kJoints[k];
  *name = joint.name, *q = joint.q, *nq = joint.nq, *v = joint.v, *nv = joint.nv;
  return 1;
}

human40_p1_solver* human40_p1_open(void) { return opened<human40_p1_solver>(); }

int human40_p1_solve(human40_p1_solver* solver, const double* q, const double* v, const double* tau, double* qdd) {
  return solver->solve(q, v, tau, qdd);
}

int human40_p1_reason(int status) { return failure_kind(status); }

int human40_p1_failed_joint(int status) { return is_of_joint(failure_kind(status)) ? failure_place(status) : -1; }

const char* human40_p1_failure(const human40_p1_solver* solver) {
  return solver == nullptr ? open_failure.c_str() : solver->text.c_str();
}

void human40_p1_close(human40_p1_solver* solver) {
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
    {"kinematics", 14, -1},
    {"assembly", 0, -1},
    {"disassembly", 0, -1},
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
      "human40", "auto", kProcesses, 1, kNq, kNv, kNtau, kNqdd, kRefine,
      false, kAlone, kBatch, false, kTolerance, kGravity.data(),
      table(kJoints), table(kLinks), table(kOuterForces), {}, {}, table(kMessages), kStages.data(), kWindowHop,
      kMessageHop};
  auto* const solver = new ThisSolver;
  const int status = adagen::program(description, *solver, count, words);
  delete solver;
  return status;
}
#endif  // ADAGEN_NO_MAIN
