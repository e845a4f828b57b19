// Forward dynamics of "arm7" on 2 processes, emitted by adagen 0.1.0 (solver.cpp.j2). Do not edit: emit anew.
//
// robot     "arm7", 9 joints, 9 degrees of freedom, description sha256 35a799ae72b600eeca178cc12eccff22927d06b6ca76bda0ede3ef5832ebda29
// command   adagen ../models/arm7.urdf --procs 2 --schedule=balanced --scalar=mixed --name=arm7_mixed
// options   form segment, shape kernels, scalar mixed, refine 3, channel auto, fixed base, gravity 0.0, 0.0, -9.81
// links     adagen_program.cpp -DADAGEN_MPI
// program   2 processes, joined at cuts; 0.953 us predicted (default profile)
//           process 0: base_yaw .. forearm_roll
//           process 1: wrist_pitch .. right_finger_slide
// schedule  forearm_roll@0-1(shoulder_pitch@0(base_yaw | upper_arm_roll(|elbow_pitch)) | flange_roll@1(wrist_pitch | left_finger_slide(right_finger_slide|)))
// licence   yours to choose: what adagen emits belongs to whoever emits it
//
// Each process treats a segment of the robot by the articulated-body algorithm: I^A and p^A (IA, pA), a
// link's inertia and bias force with all that hangs on it, are swept to the segment's root, and the
// accelerations come back. Where segments meet, the assembly-disassembly algorithm of Yamane and Nakamura
// joins them: Phi = (I^A)^-1 and b are what a segment shows at a cut; joint i joins chain A (its parent
// link's side) and chain B (its child link's side), Eq. (3)-(7), and gives back its force, Eq. (8)-(10).
// Spatial vectors are [angular; linear], in the axes of the base, about each link's origin.
//
// How to read on:
//   1. interface   what a program that links this file calls
//   2. model       the robot's constants
//   3. runtime     spatial algebra, joints, exchange between processes
//   4. joints      for each joint its memory, then what is done with it, step by step
//   5. processes   who does what, in order
//   6. program     what the program around it, adagen_program.cpp, is told; main

// ---- 1. interface -------------------------------------------------------------------------------
// To use it from a program of yours: compile this file with -DADAGEN_NO_MAIN and link it; arm7_mixed_p2.h
// beside it is this part.
// C interface of the solver arm7_mixed_p2: forward dynamics of "arm7" on 2 processes,
// emitted by adagen 0.1.0 (interface.h.j2). Do not edit: emit anew.
#ifndef ADAGEN_ARM7_MIXED_P2_H
#define ADAGEN_ARM7_MIXED_P2_H

#include <mpi.h>

enum {
  ARM7_MIXED_P2_PROCESSES = 2,
  ARM7_MIXED_P2_JOINTS = 9,
  ARM7_MIXED_P2_NQ = 9,  // numbers in q
  ARM7_MIXED_P2_NV = 9,  // in v and qdd
  ARM7_MIXED_P2_NTAU = 9  // in tau
};

// Where each joint begins in q, and in v, tau and qdd.
enum {
  ARM7_MIXED_P2_Q_base_yaw = 0,
  ARM7_MIXED_P2_V_base_yaw = 0,  // joint 0, "base_yaw": revolute, 1 in q, 1 in v
  ARM7_MIXED_P2_Q_shoulder_pitch = 1,
  ARM7_MIXED_P2_V_shoulder_pitch = 1,  // joint 1, "shoulder_pitch": revolute, 1 in q, 1 in v
  ARM7_MIXED_P2_Q_upper_arm_roll = 2,
  ARM7_MIXED_P2_V_upper_arm_roll = 2,  // joint 2, "upper_arm_roll": revolute, 1 in q, 1 in v
  ARM7_MIXED_P2_Q_elbow_pitch = 3,
  ARM7_MIXED_P2_V_elbow_pitch = 3,  // joint 3, "elbow_pitch": revolute, 1 in q, 1 in v
  ARM7_MIXED_P2_Q_forearm_roll = 4,
  ARM7_MIXED_P2_V_forearm_roll = 4,  // joint 4, "forearm_roll": revolute, 1 in q, 1 in v
  ARM7_MIXED_P2_Q_wrist_pitch = 5,
  ARM7_MIXED_P2_V_wrist_pitch = 5,  // joint 5, "wrist_pitch": revolute, 1 in q, 1 in v
  ARM7_MIXED_P2_Q_flange_roll = 6,
  ARM7_MIXED_P2_V_flange_roll = 6,  // joint 6, "flange_roll": revolute, 1 in q, 1 in v
  ARM7_MIXED_P2_Q_left_finger_slide = 7,
  ARM7_MIXED_P2_V_left_finger_slide = 7,  // joint 7, "left_finger_slide": prismatic, 1 in q, 1 in v
  ARM7_MIXED_P2_Q_right_finger_slide = 8,
  ARM7_MIXED_P2_V_right_finger_slide = 8  // joint 8, "right_finger_slide": prismatic, 1 in q, 1 in v
};

// Why a call failed, as arm7_mixed_p2_reason tells of the status that it returned.
enum {
  ARM7_MIXED_P2_FINE = 0,  // none
  ARM7_MIXED_P2_NOT_FINITE = 1,  // q, v or tau of a joint is not a finite number
  ARM7_MIXED_P2_ZERO_QUATERNION = 2,  // a joint's quaternion cannot be normalised
  ARM7_MIXED_P2_FACTORIZATION = 3,  // inertias beside a joint differ too much for the scalar
  ARM7_MIXED_P2_OVERFLOW = 4,  // a joint's acceleration is not a finite number
  ARM7_MIXED_P2_NO_ANSWER = 5,  // a process did not answer within the time limit
  ARM7_MIXED_P2_ENDED = 6,  // process 0 has ended the evaluations
  ARM7_MIXED_P2_NOT_REFINED = 7,  // refinement does not converge
  ARM7_MIXED_P2_GIMBAL_LOCK = 8,  // joints that are joined as one do not move in as many directions
  ARM7_MIXED_P2_GROWTH = 9,  // a link beside a joint is too light for its neighbours
  ARM7_MIXED_P2_NOT_SET = 16,  // what is to be set at run time is not finite, or is no mass
  ARM7_MIXED_P2_TOO_FEW_STEPS = 11,  // refinement converges too slowly
  ARM7_MIXED_P2_LOOP_OPEN = 12,  // a loop or coupling is not closed in this configuration
  ARM7_MIXED_P2_LOOP_TORN = 13,  // this velocity tears a loop or coupling open
  ARM7_MIXED_P2_LOOP_SINGULAR = 14,  // what a loop holds changes in this pose
  ARM7_MIXED_P2_LOOP_FREE = 15  // loops leave a joint a motion that no inertia resists
};

#ifdef __cplusplus
extern "C" {
#endif
typedef struct arm7_mixed_p2_solver arm7_mixed_p2_solver;

// Joints in order, each with its place in the state: gives name, start and size in q and v of joint
// k, or returns 0 where there is none.
int arm7_mixed_p2_joint(int k, const char** name, int* q, int* nq, int* v, int* nv);

// Collective over a communicator of 2 processes. channel: "auto", "window" (shared memory) or
// "message"; time_limit: seconds that a process waits for another. Returns null where it cannot be
// done; arm7_mixed_p2_failure(NULL) says why.
arm7_mixed_p2_solver* arm7_mixed_p2_open(MPI_Comm comm, const char* channel, double time_limit);

// One evaluation, collective. q: 9 numbers, v and tau: 9 each, qdd: 9; joints in order, quaternions
// x y z w (normalised here), floating joints [linear; angular] in the body's frame.
// solve: every process passes the state and gets its own joints' accelerations (others untouched);
// solve_at_root: process 0 passes the state and gets them all, the others may pass null, or serve.
// Returns 0, or a status that arm7_mixed_p2_failure puts into words; no acceleration is written then.
int arm7_mixed_p2_solve(arm7_mixed_p2_solver* solver, const double* q, const double* v, const double* tau, double* qdd);
int arm7_mixed_p2_solve_at_root(arm7_mixed_p2_solver* solver, const double* q, const double* v, const double* tau, double* qdd);

// What every process but 0 can do all the time: takes part in each solve_at_root of process 0, however
// long that lets it wait, until process 0 ends it. Returns 0, or why it cannot go on.
int arm7_mixed_p2_serve(arm7_mixed_p2_solver* solver);

// At process 0: the others' serve returns. They may serve again, or all close.
int arm7_mixed_p2_end(arm7_mixed_p2_solver* solver);

// The size of the k-th correction (0 to 2) of the last evaluation, relative to the answer in the energy
// norm sqrt(e^T H e / t^T H t): the error that the answer had before it. On processes that own joints.
double arm7_mixed_p2_correction(const arm7_mixed_p2_solver* solver, int k);

// What a status says: its reason, and which joint it is about, -1 for none.
int arm7_mixed_p2_reason(int status);
int arm7_mixed_p2_failed_joint(int status);

// The last failure of a solver in words, valid until the next call; of null, why the last open of this
// thread returned null.
const char* arm7_mixed_p2_failure(const arm7_mixed_p2_solver* solver);

// Collective.
void arm7_mixed_p2_close(arm7_mixed_p2_solver* solver);
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
using Real = float;    // of all between
constexpr int kProcesses = 2;
[[maybe_unused]] constexpr bool kAlone = false;  // whether process 0 does all, and no other takes part
constexpr int kJointCount = 9, kLinkCount = kJointCount + 1;
constexpr int kNq = 9, kNv = 9;
constexpr int kOuterCount = 0, kNtau = kNv + 6 * kOuterCount;
[[maybe_unused]] constexpr int kColumns = 1;  // right-hand sides: the motion, and one per slaved joint
[[maybe_unused]] constexpr std::size_t kSlavedCount = 0;  // joints that follow others
[[maybe_unused]] constexpr bool kBatch = false;  // whether many states are solved at once
[[maybe_unused]] constexpr int kRefine = 3;  // steps of iterative refinement
[[maybe_unused]] constexpr int kPlanMessages = 2;
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
    {"pedestal", 0.0, {0.0, 0.0, 0.0},
     {0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0},
     {}},
    {"turret", 3.6, {0.0, 0.0, 0.1},
     {0.01641, 0.0, 0.0, 0.0, 0.01641, 0.0, 0.0, 0.0, 0.00882},
     {}},
    {"upper_arm", 3.1, {0.0, -0.1, 0.0},
     {0.01767, 0.0, 0.0, 0.0, 0.00558, 0.0, 0.0, 0.0, 0.01767},
     {}},
    {"elbow_housing", 2.6, {0.0, 0.0, -0.03},
     {0.00898625, 0.0, 0.0, 0.0, 0.00898625, 0.0, 0.0, 0.0, 0.0039325},
     {}},
    {"forearm", 2.2, {-0.05, 0.1, 0.0},
     {0.0102483, 0.0, 0.0, 0.0, 0.00275, 0.0, 0.0, 0.0, 0.0102483},
     {}},
    {"wrist_housing", 1.7, {0.0, 0.01, -0.08},
     {0.00448729, 0.0, 0.0, 0.0, 0.00448729, 0.0, 0.0, 0.0, 0.00172125},
     {}},
    {"wrist", 1.3, {0.04, 0.01, 0.0},
     {0.0013, 0.0, 0.0, 0.0, 0.0013, 0.0, 0.0, 0.0, 0.0013},
     {}},
    {"hand", 0.85, {0.008470588235294117, 0.0, 0.08870588235294118},
     {0.0034019064705882356, 0.0, 0.0004946823529411765, 0.0, 0.0014865882352941176, 0.0, 0.0004946823529411765, 0.0, 0.0031133417647058823},
     {}},
    {"left_finger", 0.05, {0.03, 0.0, 0.01},
     {3.33333e-06, 0.0, 0.0, 0.0, 1.66667e-05, 0.0, 0.0, 0.0, 1.66667e-05},
     {}},
    {"right_finger", 0.05, {0.03, 0.0, 0.01},
     {3.33333e-06, 0.0, 0.0, 0.0, 1.66667e-05, 0.0, 0.0, 0.0, 1.66667e-05},
     {}},
} };

constexpr std::array<JointConstants, kJointCount> kJoints{ {
    {"base_yaw", JointKind::kRevolute, 0, 0, 1, 0, 1,
     {1.0, 0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 1.0},
     {0.0, 0.0, 0.16}, -1, 0.0, 0.0},
    {"shoulder_pitch", JointKind::kRevolute, 1, 1, 1, 1, 1,
     {1.0, 0.0, 0.0, 0.0, -3.673205103346574e-06, 0.9999999999932537, 0.0, -0.9999999999932537, -3.673205103346574e-06},
     {0.0, 0.0, 0.18}, -1, 0.0, 0.0},
    {"upper_arm_roll", JointKind::kRevolute, 2, 2, 1, 2, 1,
     {1.0, 0.0, 0.0, 0.0, -3.673205103346574e-06, -0.9999999999932537, 0.0, 0.9999999999932537, -3.673205103346574e-06},
     {0.0, -0.3, 0.0}, -1, 0.0, 0.0},
    {"elbow_pitch", JointKind::kRevolute, 3, 3, 1, 3, 1,
     {1.0, 0.0, 0.0, 0.0, -3.673205103346574e-06, -0.9999999999932537, 0.0, 0.9999999999932537, -3.673205103346574e-06},
     {0.08, 0.0, 0.0}, -1, 0.0, 0.0},
    {"forearm_roll", JointKind::kRevolute, 4, 4, 1, 4, 1,
     {1.0, 0.0, 0.0, 0.0, -3.673205103346574e-06, 0.9999999999932537, 0.0, -0.9999999999932537, -3.673205103346574e-06},
     {-0.08, 0.38, 0.0}, -1, 0.0, 0.0},
    {"wrist_pitch", JointKind::kRevolute, 5, 5, 1, 5, 1,
     {1.0, 0.0, 0.0, 0.0, -3.673205103346574e-06, -0.9999999999932537, 0.0, 0.9999999999932537, -3.673205103346574e-06},
     {0.0, 0.0, 0.0}, -1, 0.0, 0.0},
    {"flange_roll", JointKind::kRevolute, 6, 6, 1, 6, 1,
     {1.0, 0.0, 0.0, 0.0, -3.673205103346574e-06, -0.9999999999932537, 0.0, 0.9999999999932537, -3.673205103346574e-06},
     {0.09, 0.0, 0.0}, -1, 0.0, 0.0},
    {"left_finger_slide", JointKind::kPrismatic, 7, 7, 1, 7, 1,
     {0.0, 1.0, 0.0, 0.0, 0.0, 1.0, 1.0, 0.0, 0.0},
     {0.0, 0.0, 0.13}, -1, 0.0, 0.0},
    {"right_finger_slide", JointKind::kPrismatic, 7, 8, 1, 8, 1,
     {0.0, -0.9999999999964793, -2.65358979335273e-06, 0.0, 2.65358979335273e-06, -0.9999999999964793, 1.0, 0.0, 0.0},
     {0.0, 0.0, 0.13}, -1, 0.0, 0.0},
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

// Joints and links in wide numbers, for what refinement finds to be left over.
using Wide = std::conditional_t<std::is_same_v<Real, float>, double, long double>;
using Wide3 = Eigen::Matrix<Wide, 3, 1>;
using Wide6 = Eigen::Matrix<Wide, 6, 1>;
using WideMat3 = Eigen::Matrix<Wide, 3, 3>;
template <class T>
using Six = Eigen::Matrix<T, 6, 1>;

template <class T>
Six<T> spatial(const Eigen::Matrix<T, 3, 1>& angular, const Eigen::Matrix<T, 3, 1>& linear) {
  Six<T> result;
  result << angular, linear;
  return result;
}
inline Wide6 wide(const Wide3& angular, const Wide3& linear) { return spatial(angular, linear); }

// From a joint's parent link's coordinates to its child link's.
template <class T>
struct Carrier {
  Eigen::Matrix<T, 3, 3> E;
  Eigen::Matrix<T, 3, 1> r;  // origin of the child frame in the parent's

  Six<T> operator()(const Six<T>& m) const {
    const Eigen::Matrix<T, 3, 1> angular = m.template head<3>();
    return spatial<T>(E * angular, E * (m.template tail<3>() - r.cross(angular)));
  }
};

// Which entry of a motion the k-th freedom of a joint is.
inline int free_row(JointKind kind, int k) {
  switch (kind) {
    case JointKind::kRevolute:
      return Revolute::Free::row[k];
    case JointKind::kPrismatic:
      return Prismatic::Free::row[k];
    case JointKind::kSpherical:
      return Spherical::Free::row[k];
    case JointKind::kPlanar:
      return Planar::Free::row[k];
    case JointKind::kFloating:
      return Floating::Free::row[k];
  }
  return 0;
}

// A joint's rates as a motion or force of its child link.
template <class T, class Rate>
Six<T> along_joint(int j, const Rate* rates) {
  Six<T> result = Six<T>::Zero();
  const JointConstants& joint = kJoints[j];
  for (int k = 0; k < joint.nv; ++k)
    result[free_row(joint.kind, k)] = static_cast<T>(rates[joint.v + k]);
  return result;
}

// A wrench on a joint's child link, in its parent link's frame.
inline Wide6 returned(const Carrier<Wide>& X, const Wide6& f) {
  const auto& [E, r] = X;
  const Wide3 linear = E.transpose() * f.tail<3>();
  return wide(E.transpose() * f.head<3>() + r.cross(linear), linear);
}

// I m of a link: its mass at the centre of mass, its tensor about it.
template <class T>
Six<T> times_inertia(int link, const Six<T>& m) {
  using Vector = Eigen::Matrix<T, 3, 1>;
  const LinkConstants& body = kLinks[link];
  const Vector c(body.com[0], body.com[1], body.com[2]), angular = m.template head<3>();
  const Vector force = T(body.mass) * (m.template tail<3>() + angular.cross(c));
  Vector moment = c.cross(force);
  for (int i = 0; i < 3; ++i)
    for (int k = 0; k < 3; ++k) moment[i] += T(body.tensor[3 * i + k]) * angular[k];
  return spatial(moment, force);
}

// The rotation that a quaternion x y z w of any length stands for.
inline WideMat3 oriented(const Number* quaternion) {
  const Wide x = quaternion[0], y = quaternion[1], z = quaternion[2], w = quaternion[3];
  const Wide s = 2 / (x * x + y * y + z * z + w * w);
  WideMat3 turn;
  turn << 1 - s * (y * y + z * z), s * (x * y - z * w), s * (x * z + y * w),  //
      s * (x * y + z * w), 1 - s * (x * x + z * z), s * (y * z - x * w),      //
      s * (x * z - y * w), s * (y * z + x * w), 1 - s * (x * x + y * y);
  return turn;
}

// From its parent link's frame to its child link's, at a configuration.
inline Carrier<Wide> carrier_of(int j, const Number* q) {
  const JointConstants& joint = kJoints[j];
  Carrier<Wide> result;
  auto& [E, r] = result;
  WideMat3 base;
  for (int k = 0; k < 9; ++k) base(k / 3, k % 3) = Wide(joint.rotation[k]);
  for (int k = 0; k < 3; ++k) r[k] = Wide(joint.translation[k]);
  const Number* const own = q + (joint.source < 0 ? joint.q : kJoints[joint.source].q);
  const auto scalar = [&joint, own](int k) {
    if (joint.source < 0) return Wide(own[k]);
    return Wide(joint.multiplier) * Wide(own[k]) + Wide(joint.offset);
  };
  const auto turned = [&E = E, &base](Wide angle) {
    const Wide c = std::cos(angle), s = std::sin(angle);
    for (int k = 0; k < 3; ++k) {
      E(0, k) = c * base(k, 0) + s * base(k, 1);
      E(1, k) = c * base(k, 1) - s * base(k, 0);
      E(2, k) = base(k, 2);
    }
  };
  switch (joint.kind) {
    case JointKind::kRevolute:
      turned(scalar(0));
      break;
    case JointKind::kPrismatic:
      E = base.transpose();
      r += base.col(2) * scalar(0);
      break;
    case JointKind::kPlanar:
      turned(Wide(own[2]));
      r += base.col(0) * Wide(own[0]) + base.col(1) * Wide(own[1]);
      break;
    case JointKind::kFloating:
      E = (base * oriented(own + 3)).transpose();
      r += base * Wide3(Wide(own[0]), Wide(own[1]), Wide(own[2]));
      break;
    case JointKind::kSpherical:
      E = (base * oriented(own)).transpose();
      break;
  }
  return result;
}

// Iterative refinement. The unknowns are the joints' accelerations and forces together; both are
// summed up in wide numbers. From them follows what is left over at each link,
// rho = f - sum X_c^T f_c - I a - v x* I v, and from rho, with the factors at hand, a correction
// that is as large as the error was.
// Numbers of joints, links or entries, ascending.
struct Table {
  int count;
  const int* first;
  const int* begin() const { return first; }
  const int* end() const { return first + count; }
};

// A process's part in the refinement.
struct RefinedProcess {
  Table own;      // velocity entries whose acceleration it gives
  Table entries;  // velocity entries whose acceleration it sums up: those that it needs
  Table forces;   // joints whose force it computes
  Table path;     // joints between its links and the ground
  Table at;       // joints at its links
  Table links;    // its links
  Table slaved;   // slaved joints among all of these
  Table inner;    // joints of its runs whose far link has no mass, from the ends inwards
  Table beyond;   // the joint beyond each of them
};

// What one process tells another of a step.
struct ExchangeInfo {
  int source, target;
  Table entries;  // of the velocity, whose acceleration is told
  Table forces;   // joints whose force is told
};

// The slaved joint that a right-hand side is of; the first is of none.
constexpr int kSides = 1 + kSlavedCount;
constexpr std::array<int, kSides> kSlaved = [] {
  std::array<int, kSides> result{};
  for (int j = 0, column = 0; j < kJointCount; ++j)
    if (kJoints[j].source >= 0) result[++column] = j;
  return result;
}();

// A joint and the link under it.
struct WideJoint {
  Carrier<Wide> carried;
  Wide6 v, c;      // velocity of the link; v x S qd
  Wide6 gyration;  // v x* I v
  Wide6 f;         // the joint's force on the link
  Wide6 a;         // acceleration of the link, relative to free fall
  // What of it comes of qdd, and of the last step: for sizes, of which a digit or two matter.
  Carrier<double> roughly_carried;
  Six<double> moved, stepped;
};

inline const Number* given(const Number* x) { return x; }

class Refinement {
 public:
  // Joint forces of the last step, every right-hand side, and which of these is being found where
  // they are found one after the other.
  std::array<Eigen::Matrix<Real, 6, kSides>, kJointCount> f;
  int side = 0;
  std::array<Eigen::Matrix<Number, 6, 1>, kJointCount> force;  // the same with coupling torques
  std::array<Number, kNv> step{};                              // accelerations of the last step
  std::array<Number, kNv> still{};                             // no velocities
  std::array<Number, kNv> lacking{};  // torques that forces inside runs lack along the joints
  std::array<Vec6, kLinkCount> rho;
  std::array<Wide, kNv> qdd{};
  // Its process's shares of e^T H e, t^T H t, and the same of all that holds links in free fall.
  double step_energy = 0, energy = 0, whole_energy = 0;
  std::array<double, kRefine> corrections{};
  double rounding = 0;           // the last correction, relative to the larger of these
  Wide6 ground = Wide6::Zero();  // its acceleration, relative to free fall

  void begin(const RefinedProcess& own, const Number* q, const Number* v) {
    qdd.fill(0);
    for (const int j : own.path) place(j, q), move(j, v);
    for (const int j : own.at) {
      if (!std::binary_search(own.path.begin(), own.path.end(), j)) place(j, q);
      joints_[j].f.setZero();
    }
    for (const int link : own.links) {
      WideJoint& i = joints_[link - 1];
      const Wide6 momentum = times_inertia(link, i.v);
      const Wide3 w = i.v.head<3>(), n = momentum.head<3>(), p = momentum.tail<3>();
      i.gyration = wide(w.cross(n) + Wide3(i.v.tail<3>()).cross(p), w.cross(p));
    }
  }

  // The joint's force, column by column, along the joint the torque as it was given.
  void collect(int j, const Number* tau) {
    const JointConstants& joint = kJoints[j];
    force[j] = f[j].col(0).cast<Number>();
    for (int k = 0; k < joint.nv; ++k) force[j][free_row(joint.kind, k)] = tau[joint.v + k];
  }

  // What a coupling torque adds to it: along the slaved joint the torque itself, along the source
  // that times the multiplier, and nothing along others.
  void couple(int j, int column, Number torque) {
    const JointConstants &joint = kJoints[j], &slaved = kJoints[kSlaved[column]];
    Eigen::Matrix<Number, 6, 1> of_unit = f[j].col(column).template cast<Number>();
    for (int k = 0; k < joint.nv; ++k) of_unit[free_row(joint.kind, k)] = 0;
    if (kSlaved[column] == j) of_unit[free_row(joint.kind, 0)] = 1;
    if (slaved.source == j) of_unit[free_row(joint.kind, 0)] = -Number(slaved.multiplier);
    force[j] += of_unit * torque;
  }

  // A link without mass hands on what it gets.
  void hand_on(int j, int beyond) {
    force[j] = returned(joints_[beyond].carried, force[beyond].cast<Wide>()).cast<Number>();
  }

  // What the forces inside runs lack of these torques.
  void miss(const RefinedProcess& own, const Number* tau) {
    for (const int j : own.inner) {
      const JointConstants& joint = kJoints[j];
      for (int k = 0; k < joint.nv; ++k)
        lacking[joint.v + k] =
            static_cast<Number>(Wide(tau[joint.v + k]) - joints_[j].f[free_row(joint.kind, k)]);
    }
  }

  // The last step becomes part of the answer.
  void add(const RefinedProcess& own) {
    for (const int k : own.entries) qdd[k] += Wide(step[k]);
    for (const int j : own.at) joints_[j].f += force[j].cast<Wide>();
    for (const int j : own.slaved) {
      const JointConstants& joint = kJoints[j];
      const int source = kJoints[joint.source].v;
      qdd[joint.v] = Wide(joint.multiplier) * qdd[source];
      step[joint.v] = static_cast<Number>(joint.multiplier * double(step[source]));
    }
  }

  // What the answer and its last step weigh, and all accelerations relative to free fall.
  void weigh(const RefinedProcess& own) {
    const Six<double> still = Six<double>::Zero();
    for (const int j : own.path) {
      const int parent = kJoints[j].parent;
      WideJoint& i = joints_[j];
      const auto& carried = i.roughly_carried;
      i.moved = carried(parent > 0 ? joints_[parent - 1].moved : still) +
                along_joint<double>(j, qdd.data());
      i.stepped = carried(parent > 0 ? joints_[parent - 1].stepped : still) +
                  along_joint<double>(j, step.data());
    }
    energy = step_energy = whole_energy = 0;
    for (const int link : own.links) {
      const WideJoint& i = joints_[link - 1];
      energy += i.moved.dot(times_inertia(link, i.moved));
      step_energy += i.stepped.dot(times_inertia(link, i.stepped));
      const Six<double> a = i.a.cast<double>();
      whole_energy += a.dot(times_inertia(link, a));
    }
  }

  // What is left over at the process's links.
  void residual(const RefinedProcess& own) {
    for (const int j : own.path) {
      const int parent = kJoints[j].parent;
      WideJoint& i = joints_[j];
      i.a = i.carried(parent > 0 ? joints_[parent - 1].a : ground) +
            along_joint<Wide>(j, qdd.data()) + i.c;
    }
    for (const int link : own.links)
      left_[link] = -times_inertia(link, joints_[link - 1].a) - joints_[link - 1].gyration;
    for (const int j : own.at) {  // adds to other processes' links, too, which nobody reads
      const WideJoint& i = joints_[j];
      left_[j + 1] += i.f;
      left_[kJoints[j].parent] -= returned(i.carried, i.f);
    }
    for (const int link : own.links) rho[link] = left_[link].cast<Real>();
  }

 private:
  void place(int j, const Number* q) {
    auto& [E, r] = joints_[j].carried = carrier_of(j, q);
    joints_[j].roughly_carried = {E.cast<double>(), r.cast<double>()};
  }

  void move(int j, const Number* v) {
    const JointConstants& joint = kJoints[j];
    WideJoint& i = joints_[j];
    Wide6 motion;
    if (joint.source < 0) {
      motion = along_joint<Wide>(j, v);
    } else {
      motion.setZero();
      motion[free_row(joint.kind, 0)] = Wide(joint.multiplier) * Wide(v[kJoints[joint.source].v]);
    }
    i.v = motion;
    if (joint.parent > 0) i.v += i.carried(joints_[joint.parent - 1].v);
    const Wide3 w = i.v.head<3>(), u = i.v.tail<3>(), turning = motion.head<3>();
    i.c = wide(w.cross(turning), w.cross(Wide3(motion.tail<3>())) + u.cross(turning));
  }

  std::array<WideJoint, kJointCount> joints_;
  std::array<Wide6, kLinkCount> left_;
};

constexpr std::array<MessageInfo, 7> kMessages{ {
    {1, 0, 42},  // 0: assembled: chain of "flange_roll"
    {0, 1, 6},  // 1: forces on: chain of "flange_roll"
    {0, 1, 22},  // 2: state
    {1, 0, 4},  // 3: accelerations
    {0, 1, 11},  // 4: step of refinement
    {1, 0, 3},  // 5: energies
    {0, 1, 2},  // 6: size of the correction
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
    {3.6f, {0.0f, 0.0f, 0.36000000000000004f},
     {0.00441f, 0.0f, 0.0f, 0.00441f, 0.0f, 0.04800000000000001f}},
    {3.1f, {0.0f, -0.31000000000000005f, 0.0f},
     {0.00279f, 0.0f, 0.0f, 0.045880000000000004f, 0.0f, 0.00279f}},
    {2.6f, {0.0f, 0.0f, -0.078f},
     {0.00196625f, 0.0f, 0.0f, 0.00196625f, 0.0f, 0.009359999999999999f}},
    {2.2f, {-0.11000000000000001f, 0.22000000000000003f, 0.0f},
     {0.006875000000000001f, -0.011000000000000003f, 0.0f, 0.030873300000000003f, 0.0f, 0.001375f}},
    {1.7f, {0.0f, 0.017f, -0.136f},
     {0.000860625f, 0.0f, 0.0f, 0.0010306249999999999f, -0.00136f, 0.014506665f}},
    {1.3f, {0.052000000000000005f, 0.013000000000000001f, 0.0f},
     {0.0027300000000000002f, 0.0005200000000000001f, 0.0f, 0.00078f, 0.0f, 0.00065f}},
    {0.85f, {0.007199999999999999f, 0.0f, 0.0754f},
     {0.0006599999999999998f, 0.0f, 0.00014399999999999992f, 0.0025143300000000004f, 0.0f, 0.007576f}},
    {0.05f, {0.0015f, 0.0f, 0.0005f},
     {6.0000035e-05f, 0.0f, 1.5e-05f, 1.666665e-06f, 0.0f, 6.666665e-06f}},
    {0.05f, {0.0015f, 0.0f, 0.0005f},
     {6.0000035e-05f, 0.0f, 1.5e-05f, 1.666665e-06f, 0.0f, 6.666665e-06f}},
} };

// Where a joint, and the link beyond it, lie in memory: limbs side by side take turns, and so do
// segments of long runs.
constexpr int kSlotCount = 9;
constexpr int kTile = 0;  // joints that are swept before others take their memory; 0: all
constexpr bool kAbreast = false;  // whether there are such
constexpr bool kPrescribedAbreast = false;  // with motions that are prescribed
constexpr bool kReordered = false;  // whether joints lie in another order than they have
constexpr int kSlots[kJointCount]{ 0, 1, 2, 3, 4, 5, 6, 7, 8 };
// Blocks of slots of equal constants: the number of kinds (0: not looked at), each block's, and the
// first block of each.
constexpr int kBlockKindCount = 0;
[[maybe_unused]] constexpr int kBlockKinds[]{ 0 };
[[maybe_unused]] constexpr int kFirstOfKind[]{ 0 };
constexpr bool kByColumns = true;  // whether runs are taken by columns
// Joints that are eliminated in their own axes; others that are where those of the base lose digits.
constexpr bool kAnyTurned = false;
constexpr bool kTurned[kJointCount]{ 0, 0, 0, 0, 0, 0, 0, 0, 0 };
constexpr bool kAnyTurnedIfLost = false;
constexpr bool kTurnedIfLost[kJointCount]{ 0, 0, 0, 0, 0, 0, 0, 0, 0 };
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
constexpr LinkRole kRoles[2][kLinkCount]{
    {{1, 0, 1, 0}, {0, 1, 0, 0}, {0, 1, 0, 0}, {0, 1, 0, 0}, {0, 1, 0, 0}, {0, 0, 0, 0}, {0, 0, 0, 0}, {0, 0, 0, 0}, {0, 0, 0, 0}, {0, 0, 0, 0}},
    {{0, 0, 0, 0}, {0, 0, 0, 0}, {0, 0, 0, 0}, {0, 0, 0, 0}, {0, 0, 0, 0}, {1, 1, 1, 0}, {0, 1, 0, 0}, {1, 1, 1, 0}, {0, 1, 0, 0}, {0, 1, 0, 0}},
};

// Numbers of the state, copied to the type that is computed with; as they were given, too.
template <int count>
class Copied {
 public:
  Copied& operator=(const Number* x) {
    given_ = x;
    for (int k = 0; k < count; ++k) copy_[k] = static_cast<Value>(x[k]);
    return *this;
  }
  operator const Value*() const { return copy_; }
  const Number* given() const { return given_; }
  Value* data() { return copy_; }

 private:
  const Number* given_ = nullptr;
  Value copy_[count > 0 ? count : 1]{};
};
template <int count>
const Number* given(const Copied<count>& x) {
  return x.given();
}

// Where an evaluation finds the state, and puts what it answers.
struct State {
  Copied<kNq> q;
  Copied<kNv> v;
  Copied<kNtau> tau;
  Number* qdd = nullptr;
};

// What is kept where segments meet, with the joint that it belongs to.
struct Joint_shoulder_pitch {
  Mat6 Phi_forearm;
  Columns6 b_forearm;
  Columns6 F_on_forearm;
};
struct Joint_forearm_roll {
  Transform X, Y;  // to the joint's frame, about its two links' origins
  Joined<Revolute> joined;
};
struct Joint_flange_roll {
  Mat6 Phi_wrist_housing;
  Columns6 b_wrist_housing;
  Columns6 F_on_wrist_housing;
};
struct Cuts {
  Joint_shoulder_pitch j_shoulder_pitch;
  Joint_forearm_roll j_forearm_roll;
  Joint_flange_roll j_flange_roll;
  std::array<Columns6, kLinkCount> loads;  // wrenches on links, from handle forces
  Refinement refinement;
  EIGEN_MAKE_ALIGNED_OPERATOR_NEW
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

// What refinement needs of a joint: the articulated body on its far side, and its force.

template <class T>
ADAGEN_INLINE void keep_body(Workspace& w, const Joints<T>& joints, const Body<T>& X) {
  if constexpr (kWidth<T> == 1)
    w.whole[static_cast<std::size_t>(joints.joint[0])] = X;
  else
    ADAGEN_FOR (k, 0, kWidth<T>) w.whole[static_cast<std::size_t>(joints.joint[k])] = lane(X, k);
}

// Handle forces on a link count as its body's.
ADAGEN_INLINE void keep_load(Workspace& w, int j, const Vector<Value>& n, const Vector<Value>& f) {
  Body<Value>& X = w.whole[static_cast<std::size_t>(j)];
  X.n += -n, X.f += -f;
}

// The force of a joint on its child link, in that link's axes: I^A a + p^A of its far link.
template <bool reversed>
inline void keep_one_force(Workspace& w, int j, const Motion<Value>& a) {
  const Body<Value>& X = w.whole[static_cast<std::size_t>(j)];
  Vector<Value> n = X.A * a.angular + X.B * a.linear + X.n;
  Vector<Value> f = transposed_times(X.B, a.angular) + X.C * a.linear + X.f;
  if constexpr (reversed) {
    n = cross(w.joints[static_cast<std::size_t>(j)].r, f) - n;
    f = -f;
  }
  const Matrix<Value> R = matrix_at(w.of(j, kAxes));
  n = transposed_times(R, n), f = transposed_times(R, f);
  w.refinement.f[static_cast<std::size_t>(j)].col(w.refinement.side) << n.x, n.y, n.z, f.x, f.y,
      f.z;
}
template <bool reversed, class T>
ADAGEN_INLINE void keep_force(Workspace& w, const Joints<T>& joints, const Motion<T>& a) {
  if constexpr (kWidth<T> == 1)
    keep_one_force<reversed>(w, joints.joint[0], a);
  else
    ADAGEN_FOR (k, 0, kWidth<T>) keep_one_force<reversed>(w, joints.joint[k], lane(a, k));
}

// The forces that are kept next are of the motion (0), or of the torque at a slaved joint.
[[maybe_unused]] inline void keep_side(Workspace& w, std::size_t side) {
  w.refinement.side = static_cast<int>(side);
}

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


// Nothing on the ground moves beyond its Frame, and the ground does not yield.
const Mat6 kZero = Mat6::Zero();
const Columns6 kGround = Columns6::Zero();

// Mobility: what a segment shows at its handles, and what forces there do inside it. Phi and b are
// about the handles' origins, in the axes that their bodies are told in (turned.hpp), and so are
// forces at handles; b are accelerations beyond those of a Frame.
inline Mat3 mat3_of(const Matrix<Value>& R) {
  Mat3 result;
  result << R.x.x, R.x.y, R.x.z, R.y.x, R.y.y, R.y.z, R.z.x, R.z.y, R.z.z;
  return result;
}
template <class M>
M rotated(const Mat3& R, const M& m) {
  M result;
  result.template topRows<3>().noalias() = R * m.template topRows<3>();
  result.template bottomRows<3>().noalias() = R * m.template bottomRows<3>();
  return result;
}
// Columns at a link from the axes that they are told in there to those of the base, and back.
template <class M>
M in_base(Workspace& w, int link, const M& m) {
  return turned_link(link) ? rotated(mat3_of(matrix_at(w.of(link - 1, kAxes))), m) : m;
}
template <class M>
M as_told(Workspace& w, int link, const M& m) {
  return turned_link(link) ? rotated(mat3_of(matrix_at(w.of(link - 1, kAxes))).transpose(), m) : m;
}
[[maybe_unused]] inline Mat6 mobility_as_told(Workspace& w, int link, const Mat6& Phi) {
  if (!turned_link(link)) return Phi;
  const Mat6 half = as_told(w, link, Phi);
  return as_told(w, link, Mat6(half.transpose()));
}

ADAGEN_INLINE Motion<Value> motion_of(const Columns6& a) {
  return {{a[0], a[1], a[2]}, {a[3], a[4], a[5]}};
}
ADAGEN_INLINE Columns6 columns_of(const Motion<Value>& a) {
  Columns6 result;
  result << a.angular.x, a.angular.y, a.angular.z, a.linear.x, a.linear.y, a.linear.z;
  return result;
}

inline Mat6 inertia_of(const Body<Value>& X) {
  Mat6 I;
  I << X.A.xx, X.A.xy, X.A.xz, X.B.x.x, X.B.x.y, X.B.x.z,  //
      X.A.xy, X.A.yy, X.A.yz, X.B.y.x, X.B.y.y, X.B.y.z,   //
      X.A.xz, X.A.yz, X.A.zz, X.B.z.x, X.B.z.y, X.B.z.z,   //
      X.B.x.x, X.B.y.x, X.B.z.x, X.C.xx, X.C.xy, X.C.xz,   //
      X.B.x.y, X.B.y.y, X.B.z.y, X.C.xy, X.C.yy, X.C.yz,   //
      X.B.x.z, X.B.y.z, X.B.z.z, X.C.xz, X.C.yz, X.C.zz;
  return I;
}
inline Columns6 force_of(const Body<Value>& X) { return columns_of({X.n, X.f}); }

// The inverse of a symmetric matrix of six rows, and as symmetric: L^-T D^-1 L^-1, L^-1 by
// elimination of all six unit vectors at once. Where masses differ much, subtracting on the way
// back instead would cost digits. Whether each pivot exceeds what it must at least.
ADAGEN_INLINE bool invert(const Mat6& m, const Real (&least)[6], Mat6& inverse) {
  Lanes rows[6]{}, X[6]{};
  Real over[6];
  bool good = true;
  ADAGEN_FOR (i, 0, 6) {
    std::memcpy(&rows[i], m.data() + 6 * i, 6 * sizeof(Real));
    X[i][i] = 1;
  }
  ADAGEN_FOR (c, 0, 6) {
    const Real pivot = rows[c][c];
    good = good && pivot > least[c] && pivot <= std::numeric_limits<Real>::max();
    over[c] = 1 / pivot;
    ADAGEN_FOR (i, c + 1, 6) {
      const Real l = rows[i][c] * over[c];
      rows[i] -= rows[c] * l;
      X[i] -= X[c] * l;
    }
  }
  ADAGEN_FOR (i, 0, 6) {
    Lanes sum{};
    ADAGEN_FOR (k, i, 6) sum += X[k] * (X[k][i] * over[k]);
    std::memcpy(inverse.data() + 6 * i, &sum, 6 * sizeof(Real));
  }
  ADAGEN_FOR (i, 0, 6)
    ADAGEN_FOR (k, 0, i) inverse(k, i) = inverse(i, k);
  return good;
}

// Phi = (I^A)^-1 and b = -Phi p^A of a segment's root.
[[maybe_unused]] inline bool invert(const Body<Value>& X, Mat6& Phi, Columns6& b) {
  constexpr Real kRounding = 8 * std::numeric_limits<Real>::epsilon();
  const Mat6 I = inertia_of(X);
  Real least[6];
  ADAGEN_FOR (k, 0, 6) least[k] = kRounding * I(k, k);
  const bool good = invert(I, least, Phi);
  b.noalias() = -Phi * force_of(X);
  return good;
}

template <int p, int link>
void invert_root(Workspace& w, Mat6& Phi, Columns6& b) {
  Body<Value> X{};
  meet<p>(w, link, X);
  if (!invert(X, Phi, b)) fail(w, kFactorization, link - 1);
}

// b = -Phi p of a bare link.
template <int link>
void bare_link(Workspace& w, const Mat6& Phi, Columns6& b) {
  static_assert(turned_link(link));
  Body<Value> X{};
  add_own_link(w, single(link - 1), X);
  b.noalias() = -Phi * force_of(X);
}

// A planar joint's freedoms one after the other, the last one to be eliminated first, at its
// origin.
ADAGEN_INLINE void slide_and_turn(Workspace& w, int j, Motion<Lanes>& a,
                                  const Vector<Lanes>& drive) {
  const Value* const e = w.joints[static_cast<std::size_t>(j)].e;
  const Matrix<Value> R = matrix_at(w.of(j, kAxes));
  const auto moved = [&a](const Value* of, const Lanes& driven) {
    return driven -
           ((of[0] * a.angular.x + of[1] * a.angular.y) +
            (of[2] * a.angular.z + of[3] * a.linear.x) + (of[4] * a.linear.y + of[5] * a.linear.z));
  };
  const auto along = [](const Value& x, const Value& y, const Value& z, const Lanes& by) {
    return Vector<Lanes>{x * by, y * by, z * by};
  };
  a.angular += along(R.x.z, R.y.z, R.z.z, moved(e + 16, drive.z));
  a.linear += along(R.x.y, R.y.y, R.z.y, moved(e + 8, drive.y));
  a.linear += along(R.x.x, R.y.x, R.z.x, moved(e, drive.x));
}

// Motions of a link, side by side: what the far link does, with what drives the joint beyond L a
// (of a joint with one freedom x).
template <bool reversed>
ADAGEN_INLINE void pass(Workspace& w, int j, Motion<Lanes>& a,
                        const Vector<Lanes>& drive = Vector<Lanes>{}) {
  const JointKind kind = kJoints[static_cast<std::size_t>(j)].kind;
  const Memory& memory = w.joints[static_cast<std::size_t>(j)];
  const Value* const e = memory.e;
  const Vector<Value> axis = axis_at(w.of(j, kAxes));
  if (kind == JointKind::kSpherical) {
    if constexpr (kAnySpherical) {
      if constexpr (!reversed) carry(a, memory.r);
      const Vector<Lanes> v = a.linear, spin = a.angular;
      a.angular = {drive.x - (e[0] * v.x + e[1] * v.y + e[2] * v.z),
                   drive.y - (e[3] * v.x + e[4] * v.y + e[5] * v.z),
                   drive.z - (e[6] * v.x + e[7] * v.y + e[8] * v.z)};
      if constexpr (kSphericalRotors) a.angular += solved(e + 12, spin) * rotor_of(single(j));
      if constexpr (reversed) carry(a, -memory.r);
    }
    return;
  }
  if (kind == JointKind::kPlanar) {
    if constexpr (kAnyPlanar) {
      if constexpr (!reversed) carry(a, memory.r);
      slide_and_turn(w, j, a, drive);
      if constexpr (reversed) carry(a, -memory.r);
    }
    return;
  }
  if (kind == JointKind::kFloating) {  // the far link moves as if there were no near one
    a = Motion<Lanes>{};
    return;
  }
  const Lanes x = drive.x - ((e[0] * a.angular.x + e[1] * a.angular.y) +
                             (e[2] * a.angular.z + e[3] * a.linear.x) +
                             (e[4] * a.linear.y + e[5] * a.linear.z));
  const Vector<Lanes> moved{axis.x * x, axis.y * x, axis.z * x};
  if constexpr (!reversed) carry(a, memory.r);
  if (kind == JointKind::kPrismatic)
    a.linear += moved;
  else
    a.angular += moved;
  if constexpr (reversed) carry(a, -memory.r);
}

ADAGEN_INLINE Motion<Lanes> rows_of(const Mat6& transposed) {
  const auto row = [&transposed](int k) {
    Lanes result{};
    std::memcpy(&result, transposed.data() + 6 * k, 6 * sizeof(Real));
    return result;
  };
  return {{row(0), row(1), row(2)}, {row(3), row(4), row(5)}};
}
ADAGEN_INLINE Mat6 from_rows(const Motion<Lanes>& a) {  // transposed
  Mat6 result;
  const Lanes* rows[6] = {&a.angular.x, &a.angular.y, &a.angular.z,
                          &a.linear.x,  &a.linear.y,  &a.linear.z};
  for (int k = 0; k < 6; ++k) std::memcpy(result.data() + 6 * k, rows[k], 6 * sizeof(Real));
  return result;
}

template <bool reversed>
ADAGEN_INLINE constexpr int near_link(int j) {
  return reversed ? j + 1 : kJoints[static_cast<std::size_t>(j)].parent;
}

// L m, m being told with the near link in its rows.
template <bool reversed>
Mat6 passed(Workspace& w, int j, const Mat6& m) {
  const Mat6 near = in_base(w, near_link<reversed>(j), m);
  Motion<Lanes> rows = rows_of(near.transpose());
  pass<reversed>(w, j, rows);
  const Mat6 far = from_rows(rows).transpose();
  return as_told(w, near_link<!reversed>(j), far);
}

// What joints with several freedoms do at the child link's origin is told at the far link's.
template <bool reversed>
Mat6 at_far_link(Workspace& w, int j, const Mat6& Phi) {
  if constexpr (!reversed) return mobility_as_told(w, j + 1, Phi);
  const Vector<Value> r = -w.joints[static_cast<std::size_t>(j)].r;
  Mat6 shifted = Mat6::Identity();  // linear += angular x r
  shifted(3, 1) = r.z, shifted(3, 2) = -r.y, shifted(4, 0) = -r.z;
  shifted(4, 2) = r.x, shifted(5, 0) = r.y, shifted(5, 1) = -r.x;
  return mobility_as_told(w, near_link<false>(j), shifted * Phi * shifted.transpose());
}

// S D^-1 S^T at the far link's origin.
template <bool reversed>
Mat6 own_mobility(Workspace& w, int j) {
  const JointKind kind = kJoints[static_cast<std::size_t>(j)].kind;
  const Memory& memory = w.joints[static_cast<std::size_t>(j)];
  Mat6 result = Mat6::Zero();
  if (kind == JointKind::kPlanar) {
    if constexpr (kAnyPlanar) {
      Motion<Lanes> a{};
      Vector<Lanes> unit{};
      unit.x[0] = 1, unit.y[1] = 1, unit.z[2] = 1;
      slide_and_turn(w, j, a, unit);
      const Mat6 moved = from_rows(a);  // transposed: what a freedom does is a column of lanes
      for (int k = 0; k < 3; ++k) {
        const Columns6 s = moved.row(k).transpose();
        result += s * memory.e[8 * k + 7] * s.transpose();
      }
    }
    return at_far_link<reversed>(w, j, result);
  }
  if (kind == JointKind::kFloating) {
    if constexpr (kPassesFree) {
      Columns6 still;
      if (!invert(w.free[static_cast<std::size_t>(j)], result, still)) fail(w, kFactorization, j);
    }
    return at_far_link<reversed>(w, j, result);
  }
  if (kind == JointKind::kSpherical) {
    if constexpr (kAnySpherical) {
      for (int k = 0; k < 3; ++k) {
        const Vector<Value> unit{Value(k == 0), Value(k == 1), Value(k == 2)};
        const Vector<Value> x = solved(memory.e + 12, unit);
        result(0, k) = x.x, result(1, k) = x.y, result(2, k) = x.z;
      }
    }
    return at_far_link<reversed>(w, j, result);
  }
  Motion<Value> S{};
  Vector<Value>& along = kind == JointKind::kPrismatic ? S.linear : S.angular;
  if (!reversed && turned(j)) {
    along.z = 1;
  } else {
    along = axis_at(w.of(j, kAxes));
    if constexpr (reversed) carry(S, -memory.r);
  }
  const Columns6 s = reversed ? as_told(w, near_link<false>(j), columns_of(S)) : columns_of(S);
  return s * memory.e[7] * s.transpose();
}

// Omega and b outwards across a joint: L Omega L^T + S D^-1 S^T. Nothing is subtracted.
template <bool reversed>
void propagate(Workspace& w, int j, const Mat6& near, const Columns6& near_bias, Mat6& far,
               Columns6& far_bias) {
  const Mat6 half = passed<reversed>(w, j, near);
  far = passed<reversed>(w, j, half.transpose()) + own_mobility<reversed>(w, j);
  Motion<Value> a = motion_of(in_base(w, near_link<reversed>(j), near_bias));
  move<reversed>(w, single(j), kJoints[static_cast<std::size_t>(j)].kind, a);
  far_bias = as_told(w, near_link<!reversed>(j), columns_of(a));
}

// A link whose other side shows Phi and b: (1 + Phi I^A) a = b - Phi p^A.
template <int link>
void solve_mobility(Workspace& w, const Mat6& Phi, const Columns6& b) {
  const Body<Value>& X = w.bodies[link];
  const Mat6 M = Mat6::Identity() + Phi * inertia_of(X);
  const Columns6 a = M.partialPivLu().solve(b - Phi * force_of(X));
  w.motions[link] = motion_of(in_base(w, link, a));
}

// A root's acceleration under the forces at handles.
template <int link>
void accelerate_root(Workspace& w, const Mat6& Phi, const Columns6& b) {
  const Columns6 a = b + Phi * as_told(w, link, w.loads[link]);
  w.motions[link] = motion_of(in_base(w, link, a));
}

// The force that what was left at a link needs to move as the link does.
template <int link>
Columns6 force_on(Workspace& w) {
  Body<Value> X = w.bodies[link];
  to_base(w, link, X);
  return inertia_of(X) * columns_of(w.motions[link]) + force_of(X);
}

// --- joins: adapters to the joints' own frames ---------------------------------------------------

// From what is told about the parent's (X) and the child link's origin (Y) to the joint's frame.
[[maybe_unused]] inline void set_transforms(Workspace& w, int j, Transform& X, Transform& Y) {
  const int parent = kJoints[static_cast<std::size_t>(j)].parent;
  const Mat3 back = mat3_of(matrix_at(w.of(j, kAxes))).transpose();
  const Vector<Value>& r = w.joints[static_cast<std::size_t>(j)].r;
  X.E = back;
  X.r << r.x, r.y, r.z;
  if (turned_link(parent)) {
    const Mat3 R = mat3_of(matrix_at(w.of(parent - 1, kAxes)));
    X.E = mat3_of(matrix_at(w.of(j, kTurn))).transpose();
    X.r = (R.transpose() * X.r).eval();
  }
  Y.E = turned_link(j + 1) ? Mat3(Mat3::Identity()) : back;
  Y.r.setZero();
}

// The torques of a joint that reach the links, or its prescribed accelerations.
template <std::size_t n>
void load_torque(Workspace& w, int j, int, std::array<std::array<Real, kColumns>, n>& tau) {
  const JointConstants& joint = kJoints[static_cast<std::size_t>(j)];
  for (std::size_t k = 0; k < n; ++k) {
    const int entry = static_cast<int>(k);
    tau[k][0] = joint.passive.prescribed ? w.tau[joint.v + entry] : torque(w, joint, entry);
  }
}

template <std::size_t n>
void store_acceleration(Workspace& w, int, int v,
                        const std::array<std::array<Real, kColumns>, n>& qdd) {
  for (std::size_t k = 0; k < n; ++k) w.answer[static_cast<std::size_t>(v) + k] = qdd[k][0];
}

// Forces at handles: what they do inside a run.

// How a wrench drives a joint: S^T and D^-1 S^T times it, freedom by freedom.
template <class T>
struct Driven {
  Vector<T> along, by;
};

// A wrench on the far link becomes what the near link feels of it, L^T times it; what it drives the
// joint with is returned.
template <bool reversed, class T>
ADAGEN_INLINE Driven<T> hand_on(Workspace& w, int j, JointKind kind, Vector<T>& n, Vector<T>& f) {
  const Memory& memory = w.joints[static_cast<std::size_t>(j)];
  const Value* const e = memory.e;
  const Vector<Value>& r = memory.r;
  if constexpr (reversed) n += cross(f, r);
  Driven<T> driven{};
  if (kind == JointKind::kSpherical) {
    if constexpr (kAnySpherical) {
      driven = {n, solved(e + 12, n)};
      f.x -= e[0] * n.x + e[3] * n.y + e[6] * n.z;
      f.y -= e[1] * n.x + e[4] * n.y + e[7] * n.z;
      f.z -= e[2] * n.x + e[5] * n.y + e[8] * n.z;
      n = kSphericalRotors ? driven.by * rotor_of(single(j)) : Vector<T>{};
      if constexpr (!reversed) n += -cross(f, r);
    }
    return driven;
  }
  if (kind == JointKind::kPlanar) {
    if constexpr (kAnyPlanar) {
      const Matrix<Value> R = matrix_at(w.of(j, kAxes));
      const auto taken = [&n, &f](const Value* of, const T& x) {
        n.x -= of[0] * x, n.y -= of[1] * x, n.z -= of[2] * x;
        f.x -= of[3] * x, f.y -= of[4] * x, f.z -= of[5] * x;
        return x * of[7];
      };
      driven.along.x = dot(f, Vector<Value>{R.x.x, R.y.x, R.z.x});
      driven.by.x = taken(e, driven.along.x);
      driven.along.y = dot(f, Vector<Value>{R.x.y, R.y.y, R.z.y});
      driven.by.y = taken(e + 8, driven.along.y);
      driven.along.z = dot(n, Vector<Value>{R.x.z, R.y.z, R.z.z});
      driven.by.z = taken(e + 16, driven.along.z);
    }
    if constexpr (!reversed) n += -cross(f, r);
    return driven;
  }
  const T x = dot(kind == JointKind::kPrismatic ? f : n, axis_of(w, single(j)));
  driven.along.x = x;
  driven.by.x = x * e[7];
  if constexpr (!reversed) n += -cross(f, r);
  n.x -= e[0] * x, n.y -= e[1] * x, n.z -= e[2] * x;
  f.x -= e[3] * x, f.y -= e[4] * x, f.z -= e[5] * x;
  return driven;
}

// What a link is loaded with is added to what is handed on to it.
ADAGEN_INLINE void take_load(const Workspace& w, int link, Vector<Value>& n, Vector<Value>& f) {
  const Columns6& load = w.loads[static_cast<std::size_t>(link)];
  n += Vector<Value>{load[0], load[1], load[2]};
  f += Vector<Value>{load[3], load[4], load[5]};
}

// A wrench on a link beyond a floating joint moves that link and nothing else.
template <bool reversed>
ADAGEN_INLINE void push_free(Workspace& w, int j, Vector<Value>& n, Vector<Value>& f) {
  if constexpr (reversed) n += cross(f, w.joints[static_cast<std::size_t>(j)].r);
  Body<Value> X = w.free[static_cast<std::size_t>(j)];
  X.n = -n, X.f = -f;
  Motion<Value> a;
  if (!solve_free(X, a)) fail(w, kFactorization, j);
  Value* const e = w.joints[static_cast<std::size_t>(j)].e;
  e[0] += a.angular.x, e[1] += a.angular.y, e[2] += a.angular.z;
  e[3] += a.linear.x, e[4] += a.linear.y, e[5] += a.linear.z;
  n = f = Vector<Value>{};
}

// A wrench on the far link: the joint is told, and what the near link feels is left.
template <bool reversed>
ADAGEN_INLINE void deliver(Workspace& w, int j, Vector<Value>& n, Vector<Value>& f) {
  Value* const e = w.joints[static_cast<std::size_t>(j)].e;
  if constexpr (kPassesFree) {
    if (kJoints[static_cast<std::size_t>(j)].kind == JointKind::kFloating)
      return push_free<reversed>(w, j, n, f);
  }
  const JointKind kind = kJoints[static_cast<std::size_t>(j)].kind;
  const Vector<Value> driven = hand_on<reversed>(w, j, kind, n, f).by;
  if (kind == JointKind::kPlanar) {
    if constexpr (kAnyPlanar) e[6] += driven.x, e[14] += driven.y, e[22] += driven.z;
    return;
  }
  if (kind == JointKind::kSpherical) {
    if constexpr (kAnySpherical) e[9] += driven.x, e[10] += driven.y, e[11] += driven.z;
  } else {
    e[6] += driven.x;
  }
}

// The loads of links beyond joints first .. last, each on the link of the one before, from the last
// link to the one that the first joint is on; through: of the last link alone.
template <int first, int last, bool through = false>
void deliver(Workspace& w) {
  Vector<Value> n{}, f{};
  for (int j = last; j >= first; --j) {
    if (!through || j == last) take_load(w, j + 1, n, f);
    if constexpr (kRefine > 0) keep_load(w, j, n, f);
    deliver<false>(w, j, n, f);
  }
  w.loads[kJoints[first].parent] += columns_of({n, f});
}
// The same where the ground's side lies beyond: from the first joint's link to the last one's.
template <int first, int last, bool through = false>
void deliver_reversed(Workspace& w) {
  Vector<Value> n{}, f{};
  for (int j = first; j <= last; ++j) {
    if (!through || j == first) take_load(w, kJoints[static_cast<std::size_t>(j)].parent, n, f);
    if constexpr (kRefine > 0) keep_load(w, j, n, f);
    deliver<true>(w, j, n, f);
  }
  w.loads[last + 1] += columns_of({n, f});
}

// The mobility of a run's last link, by unit wrenches on it that are carried to the run's first
// one, each in a lane: no mobility of the links between is needed, and nothing is subtracted.

// What wrenches on the far link of a run find on their way, told in axes of the base.
struct Way {
  Mat6 moved;     // how the far link moves as the near one does: L of the whole run
  Mat6 own;       // mobility of the far link, the near one being held
  Columns6 free;  // acceleration of the far link by itself, the near one being held
};

// Joints first .. last, each on the link of the one before. With x = S^T times the wrenches on a
// joint, its share of the mobility is x^T D^-1 x, and of the acceleration x^T times the joint's.
template <bool reversed, int first, int last>
ADAGEN_NOINLINE Way carry(Workspace& w) {
  static_assert(sizeof(Value) == sizeof(Real));
  Vector<Lanes> n{}, f{};
  n.x[0] = 1, n.y[1] = 1, n.z[2] = 1, f.x[3] = 1, f.y[4] = 1, f.z[5] = 1;
  Lanes own[6]{}, free{};
  each_row<RunRows<first, last>, !reversed>([&](int k, auto kind) ADAGEN_ALWAYS {
    const Value* const e = w.joints[static_cast<std::size_t>(first + k)].e;
    const auto take = [&](const Lanes& x, const Lanes& driven, Value drive) ADAGEN_ALWAYS {
      ADAGEN_FOR (i, 0, 6) own[i] += driven * x[i];
      free += x * drive;
    };
    const auto [along, by] = hand_on<reversed>(w, first + k, kind, n, f);
    if (kind == JointKind::kSpherical) {
      if constexpr (kAnySpherical)
        take(along.x, by.x, e[9]), take(along.y, by.y, e[10]), take(along.z, by.z, e[11]);
    } else if (kind == JointKind::kPlanar) {
      if constexpr (kAnyPlanar)
        take(along.x, by.x, e[6]), take(along.y, by.y, e[14]), take(along.z, by.z, e[22]);
    } else {
      take(along.x, by.x, e[6]);
    }
  });
  Way way;
  way.moved = from_rows({n, f});
  ADAGEN_FOR (i, 0, 6) {
    ADAGEN_FOR (k, 0, 6) way.own(i, k) = own[i < k ? i : k][i < k ? k : i];
    way.free[i] = free[i];
  }
  return way;
}

// Phi and b of the last link of a run that hangs on the ground.
template <int link>
void show(Workspace& w, const Way& way, Mat6& Phi, Columns6& b) {
  Phi = mobility_as_told(w, link, way.own);
  b = as_told(w, link, way.free);
}
// The same beyond a link whose Phi and b are known: Phi = L Phi L^T and what the run itself lets
// the far link do.
[[maybe_unused]] inline void show(const Way& way, const Mat6& near, const Columns6& near_bias,
                                  Mat6& Phi, Columns6& b) {
  const Mat6 half = way.moved * near;
  Phi = way.own;
  Phi.noalias() += half * way.moved.transpose();
  b = way.free;
  b.noalias() += way.moved * near_bias;
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

// ---- 5. processes -------------------------------------------------------------------------------

// Process 0: 5 of 9 joints: "base_yaw", "shoulder_pitch", "upper_arm_roll", "elbow_pitch", "forearm_roll"
void run_0([[maybe_unused]] Workspace& w, [[maybe_unused]] Channel& channel) {
  require_finite(w, w.q, 0, 5, &JointConstants::q, kNotFinite);
  require_finite(w, w.v, 0, 5, &JointConstants::v, kNotFinite);
  require_finite(w, w.tau, 0, 5, &JointConstants::v, kNotFinite);
  stamp(0);
  std::copy_n(w.q + 0, 5, w.angle.data() + 0);
  turn<block(0), block(4) + 1>(w);
  outward<0, 4>(w);  // "base_yaw" .. "forearm_roll"
  stamp(1);
  set_up_links<block(0), block(3) + 1>(w);
  set_up_columns<block(0), block(3) + 1>(w);
  inward_in_columns<0, 0, 3, true>(w);  // "base_yaw" .. "elbow_pitch"
  {  // "base_yaw" .. "elbow_pitch"
    const Way way = carry<false, 0, 3>(w);
    show<4>(w, way, w.j_shoulder_pitch.Phi_forearm, w.j_shoulder_pitch.b_forearm);
  }
  stamp(2);
  {  // from process 1: assembled: chain of "flange_roll"
    const Number* from = channel.receive(0, w.status);
    from = get(from, w.j_flange_roll.Phi_wrist_housing);
    from = get(from, w.j_flange_roll.b_wrist_housing);
  }
  stamp(3);
  {
    auto& i = w.j_forearm_roll;
    set_transforms(w, 4, i.X, i.Y);
    load_torque(w, 4, 4, i.joined.tau);
    const Mat6 X_Phi_A = i.X * w.j_shoulder_pitch.Phi_forearm;
    const Mat6 Phi_A = from_right(X_Phi_A, i.X);
    const Mat6 Phi_B = from_right(i.Y * w.j_flange_roll.Phi_wrist_housing, i.Y);
    const Columns6 c = Columns6::Zero();
    if (!join(i.joined, Phi_A, Phi_B, i.X * w.j_shoulder_pitch.b_forearm, i.Y * w.j_flange_roll.b_wrist_housing, c))
      fail(w, kFactorization, 4);
  }
  stamp(4);
  {
    auto& i = w.j_forearm_roll;
    Release<Revolute> release(i.joined);
    const Columns6 f = release.force();  // Eq. (8), (10)
    w.refinement.f[4].col(w.refinement.side) = f;
    store_acceleration(w, 4, 4, release.qdd());  // Eq. (9)
    w.j_shoulder_pitch.F_on_forearm = -i.X.transposed_times(f);
    w.j_flange_roll.F_on_wrist_housing = i.Y.transposed_times(f);
  }
  stamp(5);
  {  // to process 1: forces on: chain of "flange_roll"
    Number* to = channel.outgoing(1, w.status);
    to = put(to, w.j_flange_roll.F_on_wrist_housing);
    channel.send(1, w.status);
  }
  stamp(6);
  w.loads[4] = in_base(w, 4, w.j_shoulder_pitch.F_on_forearm);
  deliver<0, 3, true>(w);  // "base_yaw" .. "elbow_pitch"
  accelerate<0, 0, 3>(w);  // "base_yaw" .. "elbow_pitch"
  stamp(7);
  require_finite(w, w.answer.data(), 0, 5, &JointConstants::v, kOverflow);
  give(w, 0, 5);
}

// Process 1: 4 of 9 joints: "wrist_pitch", "flange_roll", "left_finger_slide", "right_finger_slide"; kinematics of 5 more on the way to the ground
void run_1([[maybe_unused]] Workspace& w, [[maybe_unused]] Channel& channel) {
  require_finite(w, w.q, 0, 9, &JointConstants::q, kNotFinite);
  require_finite(w, w.v, 0, 9, &JointConstants::v, kNotFinite);
  require_finite(w, w.tau, 5, 4, &JointConstants::v, kNotFinite);
  stamp(0);
  std::copy_n(w.q + 0, 7, w.angle.data() + 0);
  turn<block(0), block(8) + 1>(w);
  pass_outward<0, 4>(w);  // "base_yaw" .. "forearm_roll"
  outward<5, 7>(w);  // "wrist_pitch" .. "left_finger_slide"
  outward<8, 8>(w);  // "right_finger_slide"
  stamp(1);
  set_up_links<block(4), block(8) + 1>(w);
  set_up_columns<block(5), block(8) + 1>(w);
  inward_in_columns<1, 8, 8, true>(w);  // "right_finger_slide"
  inward_in_columns<1, 5, 7, true>(w);  // "wrist_pitch" .. "left_finger_slide"
  invert_root<1, 5>(w, w.j_flange_roll.Phi_wrist_housing, w.j_flange_roll.b_wrist_housing);
  stamp(2);
  {  // to process 0: assembled: chain of "flange_roll"
    Number* to = channel.outgoing(0, w.status);
    to = put(to, w.j_flange_roll.Phi_wrist_housing);
    to = put(to, w.j_flange_roll.b_wrist_housing);
    channel.send(0, w.status);
  }
  stamp(3);
  {  // from process 0: forces on: chain of "flange_roll"
    const Number* from = channel.receive(1, w.status);
    from = get(from, w.j_flange_roll.F_on_wrist_housing);
  }
  stamp(4);
  w.loads[5] = in_base(w, 5, w.j_flange_roll.F_on_wrist_housing);
  accelerate_root<5>(w, w.j_flange_roll.Phi_wrist_housing, w.j_flange_roll.b_wrist_housing);
  accelerate<1, 5, 7>(w);  // "wrist_pitch" .. "left_finger_slide"
  accelerate<1, 8, 8>(w);  // "right_finger_slide"
  stamp(5);
  require_finite(w, w.answer.data(), 5, 4, &JointConstants::v, kOverflow);
  give(w, 5, 4);
}

// ---- refinement ---------------------------------------------------------------------------------

// Process 0, a correction: its steps again with the factors that they left, for what is
// left over at the links.
void correct_0([[maybe_unused]] Workspace& w, [[maybe_unused]] Channel& channel) {
  set_up_columns<block(0), block(3) + 1>(w);
  inward_in_columns<0, 0, 3, true>(w);  // "base_yaw" .. "elbow_pitch"
  {  // "base_yaw" .. "elbow_pitch"
    const Way way = carry<false, 0, 3>(w);
    show<4>(w, way, w.j_shoulder_pitch.Phi_forearm, w.j_shoulder_pitch.b_forearm);
  }
  {  // from process 1: assembled: chain of "flange_roll"
    const Number* from = channel.receive(0, w.status);
    from = get(from, w.j_flange_roll.Phi_wrist_housing);
    from = get(from, w.j_flange_roll.b_wrist_housing);
  }
  {
    auto& i = w.j_forearm_roll;
    set_transforms(w, 4, i.X, i.Y);
    load_torque(w, 4, 4, i.joined.tau);
    const Mat6 X_Phi_A = i.X * w.j_shoulder_pitch.Phi_forearm;
    const Mat6 Phi_A = from_right(X_Phi_A, i.X);
    const Mat6 Phi_B = from_right(i.Y * w.j_flange_roll.Phi_wrist_housing, i.Y);
    const Columns6 c = Columns6::Zero();
    if (!join(i.joined, Phi_A, Phi_B, i.X * w.j_shoulder_pitch.b_forearm, i.Y * w.j_flange_roll.b_wrist_housing, c))
      fail(w, kFactorization, 4);
  }
  {
    auto& i = w.j_forearm_roll;
    Release<Revolute> release(i.joined);
    const Columns6 f = release.force();  // Eq. (8), (10)
    w.refinement.f[4].col(w.refinement.side) = f;
    store_acceleration(w, 4, 4, release.qdd());  // Eq. (9)
    w.j_shoulder_pitch.F_on_forearm = -i.X.transposed_times(f);
    w.j_flange_roll.F_on_wrist_housing = i.Y.transposed_times(f);
  }
  {  // to process 1: forces on: chain of "flange_roll"
    Number* to = channel.outgoing(1, w.status);
    to = put(to, w.j_flange_roll.F_on_wrist_housing);
    channel.send(1, w.status);
  }
  w.loads[4] = in_base(w, 4, w.j_shoulder_pitch.F_on_forearm);
  deliver<0, 3, true>(w);  // "base_yaw" .. "elbow_pitch"
  accelerate<0, 0, 3>(w);  // "base_yaw" .. "elbow_pitch"
  require_finite(w, w.answer.data(), 0, 5, &JointConstants::v, kOverflow);
  give(w, 0, 5);
}

// Process 1, a correction: its steps again with the factors that they left, for what is
// left over at the links.
void correct_1([[maybe_unused]] Workspace& w, [[maybe_unused]] Channel& channel) {
  set_up_columns<block(5), block(8) + 1>(w);
  inward_in_columns<1, 8, 8, true>(w);  // "right_finger_slide"
  inward_in_columns<1, 5, 7, true>(w);  // "wrist_pitch" .. "left_finger_slide"
  invert_root<1, 5>(w, w.j_flange_roll.Phi_wrist_housing, w.j_flange_roll.b_wrist_housing);
  {  // to process 0: assembled: chain of "flange_roll"
    Number* to = channel.outgoing(0, w.status);
    to = put(to, w.j_flange_roll.Phi_wrist_housing);
    to = put(to, w.j_flange_roll.b_wrist_housing);
    channel.send(0, w.status);
  }
  {  // from process 0: forces on: chain of "flange_roll"
    const Number* from = channel.receive(1, w.status);
    from = get(from, w.j_flange_roll.F_on_wrist_housing);
  }
  w.loads[5] = in_base(w, 5, w.j_flange_roll.F_on_wrist_housing);
  accelerate_root<5>(w, w.j_flange_roll.Phi_wrist_housing, w.j_flange_roll.b_wrist_housing);
  accelerate<1, 5, 7>(w);  // "wrist_pitch" .. "left_finger_slide"
  accelerate<1, 8, 8>(w);  // "right_finger_slide"
  require_finite(w, w.answer.data(), 5, 4, &JointConstants::v, kOverflow);
  give(w, 5, 4);
}

constexpr std::array<void (*)(Workspace&, Channel&), kProcesses> kSolve{run_0, run_1};
constexpr std::array<void (*)(Workspace&, Channel&), kProcesses> kCorrect{correct_0, correct_1};

constexpr std::array<int, 5> kRefined_0_0{0, 1, 2, 3, 4};
constexpr std::array<int, 5> kRefined_0_1{0, 1, 2, 3, 4};
constexpr std::array<int, 5> kRefined_0_2{0, 1, 2, 3, 4};
constexpr std::array<int, 4> kRefined_0_3{0, 1, 2, 3};
constexpr std::array<int, 5> kRefined_0_4{0, 1, 2, 3, 4};
constexpr std::array<int, 4> kRefined_0_5{1, 2, 3, 4};
constexpr std::array<int, 4> kRefined_1_0{5, 6, 7, 8};
constexpr std::array<int, 9> kRefined_1_1{0, 1, 2, 3, 4, 5, 6, 7, 8};
constexpr std::array<int, 4> kRefined_1_2{5, 6, 7, 8};
constexpr std::array<int, 9> kRefined_1_3{0, 1, 2, 3, 4, 5, 6, 7, 8};
constexpr std::array<int, 5> kRefined_1_4{4, 5, 6, 7, 8};
constexpr std::array<int, 5> kRefined_1_5{5, 6, 7, 8, 9};
constexpr std::array<RefinedProcess, kProcesses> kRefined{ {
    {{5, kRefined_0_0.data()}, {5, kRefined_0_1.data()}, {5, kRefined_0_2.data()}, {4, kRefined_0_3.data()}, {5, kRefined_0_4.data()}, {4, kRefined_0_5.data()}, {0, nullptr}, {0, nullptr}, {0, nullptr}},
    {{4, kRefined_1_0.data()}, {9, kRefined_1_1.data()}, {4, kRefined_1_2.data()}, {9, kRefined_1_3.data()}, {5, kRefined_1_4.data()}, {5, kRefined_1_5.data()}, {0, nullptr}, {0, nullptr}, {0, nullptr}},
} };

constexpr std::array<int, 5> kToldEntries_0{0, 1, 2, 3, 4};
constexpr std::array<int, 1> kToldForces_0{4};
constexpr std::array<ExchangeInfo, 1> kExchanges{ {
    {0, 1, {5, kToldEntries_0.data()}, {1, kToldForces_0.data()}},
} };
constexpr std::array<int, 1> kSharing{1};  // processes that tell process 0 of their part
constexpr int kFirstExchange = kPlanMessages + 2 * (kProcesses - 1);
constexpr int kFirstShare = kFirstExchange + 1;

// Torque by which a slaved joint and its source are held in step.
inline Real coupling_torque([[maybe_unused]] const Workspace& w, [[maybe_unused]] int k) {
  return 0;
}

// A correction: links feel what is left over of their equations of motion and nothing else.
inline void begin_answer(Workspace& w) {
  w.again = false;
  for (auto& f : w.refinement.f) f.setZero();
}
inline void begin_correction(Workspace& w, const RefinedProcess& own) {
  w.again = true;
  w.v = w.refinement.still.data();
  for (const int link : own.links) {
    const Vec6& rho = w.refinement.rho[static_cast<std::size_t>(link)];
    const Matrix<Value> R = matrix_at(w.of(link - 1, kAxes));
    put_at(w.of(link - 1, kTorque), -(R * Vector<Value>{rho[0], rho[1], rho[2]}));
    put_at(w.of(link - 1, kForce), -(R * Vector<Value>{rho[3], rho[4], rho[5]}));
  }
}

// One evaluation, refined: as if it were a process's only list of steps.
inline void exchange_step(Workspace& w, Channel& channel) {
  Refinement& r = w.refinement;
  int number = kFirstExchange;
  for (const ExchangeInfo& info : kExchanges) {
    const int message = number++;
    if (info.source != channel.rank()) continue;
    Number* to = channel.outgoing(message, w.status);
    for (const int k : info.entries) *to++ = r.step[k];
    for (const int j : info.forces) to = std::copy_n(r.force[j].data(), 6, to);
    channel.send(message, w.status);
  }
  number = kFirstExchange;
  for (const ExchangeInfo& info : kExchanges) {
    const int message = number++;
    if (info.target != channel.rank()) continue;
    const Number* from = channel.receive(message, w.status);
    for (const int k : info.entries) r.step[k] = *from++;
    for (const int j : info.forces) std::copy_n(from, 6, r.force[j].data()), from += 6;
  }
}

// The joints' forces with the torques that hold slaved joints in step.
inline void collect_forces(Workspace& w, const RefinedProcess& own, const Number* tau) {
  Refinement& r = w.refinement;
  for (const int j : own.forces) {
    r.collect(j, tau);
    for (int c = 1; c < kSides; ++c) r.couple(j, c, Number(coupling_torque(w, c - 1)));
  }
  for (int k = 0; k < own.inner.count; ++k) r.hand_on(own.inner.first[k], own.beyond.first[k]);
}

// One energy beside another.
inline double ratio(Number part, Number whole) {
  if (whole > 0) return std::sqrt(double(part) / double(whole));
  return part > 0 ? std::numeric_limits<double>::infinity() : 0;
}

// Shares of the energies to process 0, and what they come to back to all.
inline double share_size(Workspace& w, Channel& channel) {
  Refinement& r = w.refinement;
  Number e = static_cast<Number>(r.step_energy), t = static_cast<Number>(r.energy),
         s = static_cast<Number>(r.whole_energy);
  int message = kFirstShare;
  for (const int p : kSharing) {
    if (channel.rank() == 0) {
      const Number* from = channel.receive(message, w.status);
      e += from[0], t += from[1], s += from[2];
    } else if (channel.rank() == p) {
      Number* to = channel.outgoing(message, w.status);
      to[0] = e, to[1] = t, to[2] = s;
      channel.send(message, w.status);
    }
    ++message;
  }
  double size = ratio(e, t);
  r.rounding = ratio(e, std::max(t, s));
  for (const int p : kSharing) {
    if (channel.rank() == 0) {
      Number* to = channel.outgoing(message, w.status);
      to[0] = static_cast<Number>(size), to[1] = static_cast<Number>(r.rounding);
      channel.send(message, w.status);
    } else if (channel.rank() == p) {
      const Number* from = channel.receive(message, w.status);
      size = double(from[0]), r.rounding = double(from[1]);
    }
    ++message;
  }
  return size;
}

constexpr bool kMixed = !std::is_same_v<Real, Number>;
// Corrections of this size need not fall further: residuals in Number are rounded, too, where it is
// no narrower than they are. What that leaves in a mixed solver is far smaller (2e-14 on chains of
// 200), and what is passed below this is right to kTolerance all the same. Where hardly anything
// accelerates, the answer is a small difference of what holds it, which sets the size of rounding.
constexpr double kSettled = kMixed ? 1e-10 : 16 * double(std::numeric_limits<Number>::epsilon());

// A correction must be smaller than the one before (the first, than all that accelerates), down to
// rounding. A mixed solver owes the digits of a double: its last correction must be within them,
// for what that leaves is smaller. By how much, the ones before do not tell: what converges slowest
// is seen last, so that the rate only gets worse.
inline void require_convergence(Workspace& w, int k) {
  const Refinement& r = w.refinement;
  const double size = r.corrections[k];
  const bool settled = r.rounding < kSettled;
  if (!(settled || (k > 0 ? size < r.corrections[k - 1] / 2 : r.rounding < 0.5)))
    fail(w, kNotRefined, 0);
  if (kMixed && k == kRefine - 1 && !(settled || size < kTolerance)) fail(w, kTooFewSteps, 0);
}

using Steps = void (*)(Workspace&, Channel&);
inline void refine(Workspace& w, Channel& channel, Steps solve, Steps correct) {
  const RefinedProcess& own = kRefined[channel.rank()];
  if (own.own.count == 0) return;
  Refinement& r = w.refinement;
  const Number* const tau = given(w.tau);
  Number* const qdd = w.qdd;
  for (int k = 0; k < 3; ++k) r.ground[3 + k] = -Wide(gravity(w, k));
  r.begin(own, given(w.q), given(w.v));
  r.step.fill(0);
  w.qdd = r.step.data();
  begin_answer(w);
  solve(w, channel);
  for (int k = 0;; ++k) {
    collect_forces(w, own, k == 0 ? tau : r.lacking.data());
    exchange_step(w, channel);
    r.add(own);
    if (k > 0) {
      r.weigh(own);
      r.corrections[k - 1] = share_size(w, channel);
      require_convergence(w, k - 1);
    }
    if (k == kRefine) break;
    r.residual(own);
    r.miss(own, tau);
    w.tau = r.lacking.data();
    begin_correction(w, own);
    correct(w, channel);
  }
  w.tau = tau;
  w.qdd = qdd;
  if (w.status != kFine) return;
  for (const int k : own.own) qdd[k] = static_cast<Number>(r.qdd[k]);
}

void refined(Workspace& w, Channel& channel) {
  refine(w, channel, kSolve[channel.rank()], kCorrect[channel.rank()]);
}

[[maybe_unused]] constexpr std::array<void (*)(Workspace&, Channel&), kProcesses> kRun{refined, refined};

// What each process reads of q and v, the velocity entries whose qdd is its own, and whose tau it
// reads.
constexpr std::array<Range, 1> kReadQ_0{ {{0, 5}} };
constexpr std::array<Range, 1> kReadV_0{ {{0, 5}} };
constexpr std::array<Range, 1> kOwn_0{ {{0, 5}} };
constexpr std::array<Range, 1> kTorque_0{ {{0, 5}} };
constexpr std::array<Range, 1> kReadQ_1{ {{0, 9}} };
constexpr std::array<Range, 1> kReadV_1{ {{0, 9}} };
constexpr std::array<Range, 1> kOwn_1{ {{5, 4}} };
constexpr std::array<Range, 1> kTorque_1{ {{5, 4}} };
[[maybe_unused]] constexpr std::array<ProcessInfo, kProcesses> kProcess{ {
    {{1, kReadQ_0.data()}, {1, kReadV_0.data()}, {1, kOwn_0.data()}, {1, kTorque_0.data()}},
    {{1, kReadQ_1.data()}, {1, kReadV_1.data()}, {1, kOwn_1.data()}, {1, kTorque_1.data()}},
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
  std::array<Number, kNv> v_{}, qdd_{};
  std::array<Number, kNtau> tau_{};
};

}  // namespace

static_assert(ARM7_MIXED_P2_NQ == kNq && ARM7_MIXED_P2_NV == kNv && ARM7_MIXED_P2_NTAU == kNtau);
static_assert(int(ARM7_MIXED_P2_FINE) == int(kFine));
static_assert(int(ARM7_MIXED_P2_NOT_FINITE) == int(kNotFinite));
static_assert(int(ARM7_MIXED_P2_ZERO_QUATERNION) == int(kZeroQuaternion));
static_assert(int(ARM7_MIXED_P2_FACTORIZATION) == int(kFactorization));
static_assert(int(ARM7_MIXED_P2_OVERFLOW) == int(kOverflow));
static_assert(int(ARM7_MIXED_P2_NO_ANSWER) == int(kNoAnswer));
static_assert(int(ARM7_MIXED_P2_ENDED) == int(kEnded));
static_assert(int(ARM7_MIXED_P2_NOT_REFINED) == int(kNotRefined));
static_assert(int(ARM7_MIXED_P2_GIMBAL_LOCK) == int(kGimbalLock));
static_assert(int(ARM7_MIXED_P2_GROWTH) == int(kGrowth));
static_assert(int(ARM7_MIXED_P2_NOT_SET) == int(kNotSet));
static_assert(int(ARM7_MIXED_P2_TOO_FEW_STEPS) == int(kTooFewSteps));
static_assert(int(ARM7_MIXED_P2_LOOP_OPEN) == int(kLoopOpen));
static_assert(int(ARM7_MIXED_P2_LOOP_TORN) == int(kLoopTorn));
static_assert(int(ARM7_MIXED_P2_LOOP_SINGULAR) == int(kLoopSingular));
static_assert(int(ARM7_MIXED_P2_LOOP_FREE) == int(kLoopFree));

struct arm7_mixed_p2_solver : Solver {};

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

int arm7_mixed_p2_joint(int k, const char** name, int* q, int* nq, int* v, int* nv) {
  if (k < 0 || k >= kJointCount) return 0;
  const JointConstants& joint = kJoints[k];
  *name = joint.name, *q = joint.q, *nq = joint.nq, *v = joint.v, *nv = joint.nv;
  return 1;
}

arm7_mixed_p2_solver* arm7_mixed_p2_open(MPI_Comm comm, const char* channel, double time_limit) {
  return opened<arm7_mixed_p2_solver>(comm, channel, time_limit);
}

int arm7_mixed_p2_solve(arm7_mixed_p2_solver* solver, const double* q, const double* v, const double* tau, double* qdd) {
  return solver->solve(q, v, tau, qdd);
}

int arm7_mixed_p2_solve_at_root(arm7_mixed_p2_solver* solver, const double* q, const double* v, const double* tau, double* qdd) {
  return solver->solve_at_root(q, v, tau, qdd);
}

int arm7_mixed_p2_serve(arm7_mixed_p2_solver* solver) { return solver->serve(); }

int arm7_mixed_p2_end(arm7_mixed_p2_solver* solver) { return solver->end(); }

double arm7_mixed_p2_correction(const arm7_mixed_p2_solver* solver, int k) {
  if (k < 0 || k >= kRefine) return std::numeric_limits<double>::quiet_NaN();
  return solver->w.refinement.corrections[static_cast<std::size_t>(k)];
}

int arm7_mixed_p2_reason(int status) { return failure_kind(status); }

int arm7_mixed_p2_failed_joint(int status) { return is_of_joint(failure_kind(status)) ? failure_place(status) : -1; }

const char* arm7_mixed_p2_failure(const arm7_mixed_p2_solver* solver) {
  return solver == nullptr ? open_failure.c_str() : solver->text.c_str();
}

void arm7_mixed_p2_close(arm7_mixed_p2_solver* solver) {
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
    return solver_.w.refinement.corrections[static_cast<std::size_t>(k)];
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
    {"kinematics", 4, -1},
    {"assembly", 3, -1},
    {"receive", -1, 0},
    {"assembly", 4, -1},
    {"disassembly", 4, -1},
    {"send", -1, 1},
    {"disassembly", 3, -1},
} };
constexpr std::array<adagen::Stage, 5> kStages_1{ {
    {"kinematics", 8, -1},
    {"assembly", 5, -1},
    {"send", -1, 0},
    {"receive", -1, 1},
    {"disassembly", 5, -1},
} };
constexpr std::array<adagen::Table<adagen::Stage>, kProcesses> kStages{ {
    {kStages_0.data(), 7},
    {kStages_1.data(), 5},
} };

// As the cost profile default has them.
constexpr adagen::Hop kWindowHop{0, 159, 0.437};
constexpr adagen::Hop kMessageHop{26, 228, 0.644};

}  // namespace

// Compiled for size: it runs once.
[[gnu::cold]] int main(int count, char** words) {
  const adagen::Description<Number> description{
      "arm7", "auto", kProcesses, 1, kNq, kNv, kNtau, kRefine,
      false, kAlone, kBatch, false, kTolerance, kGravity.data(),
      table(kJoints), table(kLinks), table(kOuterForces), {}, {}, table(kMessages), kStages.data(), kWindowHop,
      kMessageHop};
  auto* const solver = new ThisSolver;
  const int status = adagen::program(description, *solver, count, words);
  delete solver;
  return status;
}
#endif  // ADAGEN_NO_MAIN
