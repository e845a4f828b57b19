// Forward dynamics of "arm7" on 2 processes, emitted by adagen 0.1.0 (solver.cpp.j2). Do not edit: emit anew.
//
// robot     "arm7", 9 joints, 9 degrees of freedom, description sha256 35a799ae72b600eeca178cc12eccff22927d06b6ca76bda0ede3ef5832ebda29
// command   adagen ../models/arm7.urdf --procs 2 --batch --name=arm7_batch
// options   form segment, shape unrolled, scalar double, channel auto, fixed base, gravity 0.0, 0.0, -9.81
// program   1 process
//           process 0: base_yaw .. right_finger_slide
// licence   yours to choose: what adagen emits belongs to whoever emits it
//
// The articulated-body algorithm: I^A and p^A (IA, pA), a link's inertia and bias force with all that
// hangs on it, are swept to the base, and the accelerations come back. Spatial vectors are [angular;
// linear], in link frames turned so that every joint axis is z. Each SIMD lane holds a state; the
// processes share the states of a batch, not the robot.
//
// How to read on:
//   1. interface   what a program that links this file calls
//   2. model       the robot's constants
//   3. runtime     spatial algebra, joints, exchange between processes
//   4. joints      for each joint its memory, then what is done with it, step by step
//   5. processes   who does what, in order
//   6. program     states in, accelerations out; check; time

// ---- 1. interface -------------------------------------------------------------------------------
// To use it from a program of yours: compile this file with -DADAGEN_NO_MAIN and link it; arm7_batch_p2.h
// beside it is this part.
// C interface of the solver arm7_batch_p2: forward dynamics of "arm7" on 2 processes,
// emitted by adagen 0.1.0 (interface.h.j2). Do not edit: emit anew.
#ifndef ADAGEN_ARM7_BATCH_P2_H
#define ADAGEN_ARM7_BATCH_P2_H

#include <mpi.h>

enum {
  ARM7_BATCH_P2_PROCESSES = 2,
  ARM7_BATCH_P2_JOINTS = 9,
  ARM7_BATCH_P2_NQ = 9,  // numbers in q
  ARM7_BATCH_P2_NV = 9,  // in v and qdd
  ARM7_BATCH_P2_NTAU = 9  // in tau
};

// Where each joint begins in q, and in v, tau and qdd.
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

// Why a call failed, as arm7_batch_p2_reason tells of the status that it returned.
enum {
  ARM7_BATCH_P2_FINE = 0,  // none
  ARM7_BATCH_P2_NOT_FINITE = 1,  // q, v or tau of a joint is not a finite number
  ARM7_BATCH_P2_ZERO_QUATERNION = 2,  // a joint's quaternion cannot be normalised
  ARM7_BATCH_P2_FACTORIZATION = 3,  // inertias beside a joint differ too much for the scalar
  ARM7_BATCH_P2_OVERFLOW = 4,  // a joint's acceleration is not a finite number
  ARM7_BATCH_P2_NO_ANSWER = 5,  // a process did not answer within the time limit
  ARM7_BATCH_P2_ENDED = 6,  // process 0 has ended the evaluations
  ARM7_BATCH_P2_NOT_REFINED = 7,  // refinement does not converge
  ARM7_BATCH_P2_GIMBAL_LOCK = 8,  // joints that are joined as one do not move in as many directions
  ARM7_BATCH_P2_GROWTH = 9,  // a link beside a joint is too light for its neighbours
  ARM7_BATCH_P2_TOO_FEW_STEPS = 11  // refinement converges too slowly
};

#ifdef __cplusplus
extern "C" {
#endif
typedef struct arm7_batch_p2_solver arm7_batch_p2_solver;

// Joints in order, each with its place in the state: gives name, start and size in q and v of joint
// k, or returns 0 where there is none.
int arm7_batch_p2_joint(int k, const char** name, int* q, int* nq, int* v, int* nv);

// Collective over a communicator of 2 processes. channel: "auto", "window" (shared memory) or
// "message"; time_limit: seconds that a process waits for another. Returns null where it cannot be
// done; arm7_batch_p2_failure(NULL) says why.
arm7_batch_p2_solver* arm7_batch_p2_open(MPI_Comm comm, const char* channel, double time_limit);

// Accelerations of count states, each process for itself. Of each state in turn: q 9 numbers, v and
// tau 9 each, qdd 9; joints in order, quaternions x y z w (normalised here), floating joints [linear;
// angular] in the body's frame. Returns 0, or a status that arm7_batch_p2_failure puts into words:
// states that cannot be solved get NaN for accelerations, all others theirs.
int arm7_batch_p2_solve_batch(arm7_batch_p2_solver* solver, int count, const double* q, const double* v, const double* tau, double* qdd);

// The same, collective: process 0 passes all states and gets all accelerations, and hears of states
// that cannot be solved; the others may pass null and any count, or serve. Faster processes get more
// to solve.
int arm7_batch_p2_solve_batch_at_root(arm7_batch_p2_solver* solver, int count, const double* q, const double* v, const double* tau, double* qdd);

// The k-th of the states that the last call could not solve, counted from 0; -1 where there are not so
// many, or k is 256 or more. arm7_batch_p2_failure then says why.
int arm7_batch_p2_failed_state(arm7_batch_p2_solver* solver, int k);

// What every process but 0 can do all the time: takes part in each solve_batch_at_root of process 0, however
// long that lets it wait, until process 0 ends it. Returns 0, or why it cannot go on.
int arm7_batch_p2_serve(arm7_batch_p2_solver* solver);

// At process 0: the others' serve returns. They may serve again, or all close.
int arm7_batch_p2_end(arm7_batch_p2_solver* solver);

// What a status says: its reason, and which joint it is about, -1 for none.
int arm7_batch_p2_reason(int status);
int arm7_batch_p2_failed_joint(int status);

// The last failure of a solver in words, valid until the next call; of null, why the last open of this
// thread returned null.
const char* arm7_batch_p2_failure(const arm7_batch_p2_solver* solver);

// Collective.
void arm7_batch_p2_close(arm7_batch_p2_solver* solver);
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
[[maybe_unused]] constexpr bool kAlone = false;  // whether process 0 does all, and no other takes part
constexpr int kJointCount = 9, kLinkCount = kJointCount + 1;
constexpr int kNq = 9, kNv = 9;
constexpr int kOuterCount = 0, kNtau = kNv + 6 * kOuterCount;
[[maybe_unused]] constexpr int kColumns = 1;  // right-hand sides: the motion, and one per slaved joint
[[maybe_unused]] constexpr std::size_t kSlavedCount = 0;  // joints that follow others
[[maybe_unused]] constexpr bool kBatch = true;  // whether many states are solved at once
[[maybe_unused]] constexpr int kRefine = 0;  // steps of iterative refinement
[[maybe_unused]] constexpr int kPlanMessages = 0;
constexpr std::size_t kCacheLine = 64;
[[maybe_unused]] constexpr bool kFloatingBase = false;
[[maybe_unused]] constexpr double kTolerance = 1e-09;
[[maybe_unused]] constexpr int kRandomStates = 64;
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

// Words without memory from the heap; what is too long is cut.
class Text {
 public:
  Text& operator+=(char c) {
    if (size_ + 1 < sizeof data_) data_[size_++] = c, data_[size_] = '\0';
    return *this;
  }
  Text& operator+=(const char* more) {
    for (; *more != '\0'; ++more) *this += *more;
    return *this;
  }
  Text& operator+=(int number) {
    char digits[16];
    std::snprintf(digits, sizeof digits, "%d", number);
    return *this += digits;
  }
  const char* c_str() const { return data_; }
  void clear() { data_[size_ = 0] = '\0'; }

 private:
  std::size_t size_ = 0;
  char data_[1000] = "";
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
      char escape[8];
      std::snprintf(escape, sizeof escape, "\\u%04x", c);
      to += escape;
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
    case kNoAnswer:
      return {false, " did not answer within the time limit"};
  }
  return {false, "unknown failure"};
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
  } else if (kind == kNoAnswer) {
    text += "process ";
    text += failure_place(status);
  }
  text += words.text;
  return text;
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

constexpr std::array<MessageInfo, 0> kMessages{ {
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

// What is computed with: one state in each lane.
using Value = Lanes;

// The memory of a process: the state, angles with sine and cosine, what messages hold, and values
// that one function leaves to another.
struct Workspace {
  const Value* q = nullptr;
  const Value* v = nullptr;
  const Value* tau = nullptr;
  Value* qdd = nullptr;
  int status = kFine;
  alignas(kCacheLine) std::array<Value, 7> angle{}, sine{}, cosine{};
  std::array<Value, kNv> result{};
  std::array<Real*, kPlanMessages> to{};          // messages to be sent
  std::array<const Real*, kPlanMessages> from{};  // messages received
  alignas(kCacheLine) std::array<Value, 58> x{};
};

// What straight lines of lanes need.
ADAGEN_INLINE bool all(const LaneBits& good) { return !any_of(~good); }
ADAGEN_INLINE bool all(const LaneBits& good, const LaneBits& also) { return all(good & also); }

// Zero for finite numbers only: x - x is, in all bits.
inline Lanes unlike_zero(const Lanes* x, int count) {
  LaneBits found{};
  for (int k = 0; k < count; ++k) found |= reinterpret_cast<LaneBits>(x[k] - x[k]);
  return reinterpret_cast<Lanes>(found);
}

template <int count>
inline void take_sines_and_cosines(const Lanes* angle, Lanes* sine, Lanes* cosine) {
  LaneBits beyond{};
  for (int k = 0; k < count; ++k) {
    near_sine_and_cosine(angle[k], sine[k], cosine[k]);
    beyond |= too_large(angle[k]);
  }
  if (__builtin_expect(!any_of(beyond), 1)) return;
  for (int k = 0; k < count; ++k) sine_and_cosine(angle[k], sine[k], cosine[k]);
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
// Each process: 1044 products, 882 sums, 7 quotients
// =================================================================================================

ADAGEN_NOINLINE void part_0_0(Workspace& w) {
  ADAGEN_INPUTS
  // joint 1 "shoulder_pitch": placement, velocity and reference acceleration of its link
  const Lanes x20 = v[0] * 0.9999999999932537;
  const Lanes x25 = sine[1] * x20;
  const Lanes x27 = cosine[1] * x20;
  const Lanes x29 = v[1] - v[0] * 3.673205103346574e-06;
  const Lanes x30 = v[1] * x27;
  const Lanes x32 = v[1] * x25;
  const Lanes x37 = sine[1] * 9.809999999933819;
  const Lanes x55 = x25 * x27;
  const Lanes x59 = x27 * x29;
  // link 2 "upper_arm": force that the reference field takes
  const Lanes x699 = x32 * 0.00558;
  w.x[0] = x699;
  const Lanes x706 = 1.1170584039787268e-05 - (x30 * 0.048670000000000005 + x59 * 0.04309);
  w.x[1] = x706;
  const Lanes x709 = x55 * 0.04309 + x37 * 0.31000000000000005;
  w.x[2] = x709;
  // joint 2 "upper_arm_roll": placement, velocity and reference acceleration of its link
  const Lanes x80 = 3.673205103346574e-06 * x27 + 0.9999999999932537 * x29;
  const Lanes x89 = sine[2] * x80 - x25 * cosine[2];
  const Lanes x93 = x25 * sine[2] + cosine[2] * x80;
  const Lanes x94 = 0.9999999999932537 * x27 - 3.673205103346574e-06 * x29 + v[2];
  const Lanes x95 = 3.673205103346574e-06 * x32;
  const Lanes x97 = 0.9999999999932537 * x32;
  const Lanes x111 = v[2] * x93 - (x30 * cosine[2] + sine[2] * x95);
  const Lanes x114 = x30 * sine[2] - cosine[2] * x95 - v[2] * x89;
  const Lanes x118 = x37 + x55 * 0.3;
  const Lanes x120 = (x25 * x25 + x29 * x29) * 0.3;
  const Lanes x122 = x120 - cosine[1] * 9.809999999933819;
  const Lanes x125 = -3.603414206382989e-05 + (x30 + x59) * 0.3;
  const Lanes x129 = 0.9999999999932537 * x125 - 3.673205103346574e-06 * x122;
  const Lanes x134 = 0.9999999999932537 * x122 + 3.673205103346574e-06 * x125;
  const Lanes x139 = sine[2] * x129 - cosine[2] * x118;
  const Lanes x143 = sine[2] * x118 + cosine[2] * x129;
  const Lanes x148 = x93 * x93;
  const Lanes x157 = x93 * x94;
  const Lanes x162 = x89 * x94;
  // link 3 "elbow_housing": force that the reference field takes
  const Lanes x745 = x97 * 0.0039325;
  w.x[3] = x745;
  const Lanes x750 = x111 * 0.01132625 - x157 * 0.007393749999999999 + x143 * 0.078;
  w.x[4] = x750;
  const Lanes x753 = x114 * 0.01132625 + x162 * 0.007393749999999999 - x139 * 0.078;
  w.x[5] = x753;
  const Lanes x757 = x139 * 2.6 - (x114 + x162) * 0.078;
  w.x[6] = x757;
  const Lanes x761 = x143 * 2.6 - (x157 - x111) * 0.078;
  w.x[7] = x761;
  const Lanes x766 = (x89 * x89 + x148) * 0.078 - x134 * 2.6;
  w.x[8] = x766;
  // joint 3 "elbow_pitch": placement, velocity and reference acceleration of its link
  const Lanes x174 = 0.9999999999932537 * x94 - 3.673205103346574e-06 * x93;
  const Lanes x183 = x89 * cosine[3] + sine[3] * x174;
  const Lanes x187 = cosine[3] * x174 - x89 * sine[3];
  const Lanes x188 = v[3] - (0.9999999999932537 * x93 + 3.673205103346574e-06 * x94);
  const Lanes x193 = 3.673205103346574e-06 * x114 + 0.9999999999932537 * x97;
  const Lanes x199 = 3.673205103346574e-06 * x97 - 0.9999999999932537 * x114;
  const Lanes x211 = x111 * cosine[3] - sine[3] * x193 + v[3] * x187;
  const Lanes x214 = x111 * sine[3] + cosine[3] * x193 + v[3] * x183;
  const Lanes x218 = x139 - (x148 + x94 * x94) * 0.08;
  const Lanes x220 = x143 + (x89 * x93 - x97) * 0.08;
  const Lanes x222 = (x162 - x114) * 0.08 - x134;
  const Lanes x226 = 0.9999999999932537 * x222 - 3.673205103346574e-06 * x220;
  const Lanes x231 = 0.9999999999932537 * x220 + 3.673205103346574e-06 * x222;
  const Lanes x235 = cosine[3] * x218 + sine[3] * x226;
  const Lanes x239 = cosine[3] * x226 - sine[3] * x218;
  const Lanes x246 = x188 * x188;
  const Lanes x247 = x187 * x187 + x246;
  const Lanes x249 = x183 * x187;
  const Lanes x250 = x249 - x199;
  const Lanes x251 = x199 + x249;
  const Lanes x252 = x183 * x183 + x246;
  const Lanes x254 = x187 * x188;
  const Lanes x256 = x211 + x254;
  const Lanes x259 = x183 * x188;
  const Lanes x260 = x214 + x259;
  // link 4 "forearm": force that the reference field takes
  const Lanes x808 = x199 * 0.037748300000000005 - x249 * 0.023998300000000004;
  const Lanes x790 = x211 * 0.03224830000000001 + x254 * 0.029498300000000005 - x260 * 0.011000000000000003;
  const Lanes x812 = x790 - x231 * 0.22000000000000003;
  w.x[9] = x812;
  const Lanes x800 = x256 * 0.011000000000000003 - (x214 * 0.00825 + x259 * 0.005500000000000001);
  const Lanes x815 = x800 - x231 * 0.11000000000000001;
  w.x[10] = x815;
  const Lanes x820 = 0.011000000000000003 * (x252 - x247) + x808 - x239 * 0.11000000000000001;
  const Lanes x821 = x820 - x235 * 0.22000000000000003;
  w.x[11] = x821;
  const Lanes x827 = x247 * 0.11000000000000001 + x250 * 0.22000000000000003 + x235 * 2.2;
  w.x[12] = x827;
  const Lanes x835 = x239 * 2.2 - (x251 * 0.11000000000000001 + x252 * 0.22000000000000003);
  w.x[13] = x835;
  const Lanes x843 = x256 * 0.22000000000000003 - (x231 * 2.2 + x260 * 0.11000000000000001);
  w.x[14] = x843;
  // joint 4 "forearm_roll": placement, velocity and reference acceleration of its link
  const Lanes x273 = 3.673205103346574e-06 * x187 + 0.9999999999932537 * x188;
  const Lanes x282 = x183 * cosine[4] - sine[4] * x273;
  const Lanes x287 = x183 * sine[4] + cosine[4] * x273;
  const Lanes x289 = 0.9999999999932537 * x187 - 3.673205103346574e-06 * x188 + v[4];
  const Lanes x294 = 3.673205103346574e-06 * x214 - 0.9999999999932537 * x199;
  const Lanes x299 = 0.9999999999932537 * x214 + 3.673205103346574e-06 * x199;
  const Lanes x310 = x211 * cosine[4] + sine[4] * x294 - v[4] * x287;
  const Lanes x313 = cosine[4] * x294 - x211 * sine[4] - v[4] * x282;
  const Lanes x318 = 0.08 * x247 + x250 * 0.38 + x235;
  const Lanes x325 = x239 - (0.08 * x251 + x252 * 0.38);
  const Lanes x331 = x256 * 0.38 - (x231 + 0.08 * x260);
  const Lanes x336 = 3.673205103346574e-06 * x325 + 0.9999999999932537 * x331;
  const Lanes x341 = 0.9999999999932537 * x325 - 3.673205103346574e-06 * x331;
  const Lanes x345 = cosine[4] * x318 - sine[4] * x336;
  const Lanes x350 = sine[4] * x318 + cosine[4] * x336;
  const Lanes x356 = x282 * x282;
  const Lanes x362 = x282 * x287;
  const Lanes x364 = x299 - x362;
  const Lanes x367 = x356 + x289 * x289;
  const Lanes x369 = x287 * x289;
  const Lanes x374 = x356 + x287 * x287;
  const Lanes x376 = x282 * x289;
  const Lanes x378 = x313 + x376;
  // link 5 "wrist_housing": force that the reference field takes
  const Lanes x867 = x369 * 0.01347604 + 0.00136 * (x374 - x367);
  const Lanes x889 = x310 * 0.01553729 + x867 + x341 * 0.017;
  const Lanes x890 = x889 - x350 * 0.136;
  w.x[15] = x890;
  const Lanes x876 = x376 * 0.01364604 - x364 * 0.00136 + x313 * 0.01536729;
  const Lanes x893 = x876 - x345 * 0.136;
  w.x[16] = x893;
  const Lanes x885 = x362 * 0.00017 - x299 * 0.00189125 + x378 * 0.00136;
  const Lanes x896 = x885 - x345 * 0.017;
  w.x[17] = x896;
  const Lanes x902 = x364 * 0.017 - x378 * 0.136 + x345 * 1.7;
  w.x[18] = x902;
  const Lanes x909 = (x310 + x369) * 0.136 - x367 * 0.017;
  const Lanes x910 = x909 - x350 * 1.7;
  w.x[19] = x910;
  const Lanes x915 = x341 * 1.7 + x374 * 0.136;
  const Lanes x916 = (x310 - x369) * 0.017 + x915;
  w.x[20] = x916;
  // joint 5 "wrist_pitch": placement, velocity and reference acceleration of its link
  const Lanes x387 = 3.673205103346574e-06 * x287 + 0.9999999999932537 * x289;
  const Lanes x395 = x282 * cosine[5] + sine[5] * x387;
  const Lanes x399 = cosine[5] * x387 - x282 * sine[5];
  const Lanes x400 = 0.9999999999932537 * x287 - 3.673205103346574e-06 * x289 + v[5];
  const Lanes x405 = 3.673205103346574e-06 * x313 + 0.9999999999932537 * x299;
  const Lanes x411 = 3.673205103346574e-06 * x299 - 0.9999999999932537 * x313;
  const Lanes x423 = x310 * cosine[5] - sine[5] * x405 + v[5] * x399;
  const Lanes x426 = x310 * sine[5] + cosine[5] * x405 + v[5] * x395;
  const Lanes x431 = 3.673205103346574e-06 * x350 + 0.9999999999932537 * x341;
  const Lanes x436 = 0.9999999999932537 * x350 - 3.673205103346574e-06 * x341;
  const Lanes x439 = x345 * cosine[5] + sine[5] * x431;
  const Lanes x443 = cosine[5] * x431 - x345 * sine[5];
  const Lanes x449 = x400 * x400;
  const Lanes x450 = x399 * x399 + x449;
  const Lanes x452 = x395 * x399;
  const Lanes x454 = x411 + x452;
  const Lanes x455 = x395 * x395 + x449;
  const Lanes x457 = x399 * x400;
  const Lanes x459 = x423 + x457;
  const Lanes x462 = x395 * x400;
  const Lanes x463 = x426 + x462;
  // link 6 "wrist": force that the reference field takes
  const Lanes x957 = x411 * 0.00351 + x452 * 0.0019500000000000001;
  const Lanes x938 = x423 * 0.0014299999999999998 + x457 * 0.00013000000000000002 + x463 * 0.0005200000000000001;
  const Lanes x949 = x426 * 0.00338 + x462 * 0.0020800000000000003 + x459 * 0.0005200000000000001;
  const Lanes x968 = x957 - 0.0005200000000000001 * (x455 - x450) + x443 * 0.052000000000000005;
  const Lanes x974 = (x452 - x411) * 0.013000000000000001 - x450 * 0.052000000000000005;
  // joint 6 "flange_roll": placement, velocity and reference acceleration of its link
  const Lanes x474 = 0.9999999999932537 * x400 - 3.673205103346574e-06 * x399;
  const Lanes x483 = x395 * cosine[6] + sine[6] * x474;
  const Lanes x487 = cosine[6] * x474 - x395 * sine[6];
  const Lanes x488 = v[6] - (0.9999999999932537 * x399 + 3.673205103346574e-06 * x400);
  const Lanes x492 = 3.673205103346574e-06 * x426 + 0.9999999999932537 * x411;
  const Lanes x497 = 0.9999999999932537 * x426 - 3.673205103346574e-06 * x411;
  const Lanes x506 = x423 * cosine[6] + sine[6] * x492 + v[6] * x487;
  const Lanes x509 = cosine[6] * x492 - x423 * sine[6] - v[6] * x483;
  const Lanes x512 = x439 - x450 * 0.09;
  const Lanes x514 = x443 + x454 * 0.09;
  const Lanes x516 = x436 + x463 * 0.09;
  const Lanes x520 = 0.9999999999932537 * x516 - 3.673205103346574e-06 * x514;
  const Lanes x525 = 0.9999999999932537 * x514 + 3.673205103346574e-06 * x516;
  const Lanes x529 = cosine[6] * x512 + sine[6] * x520;
  const Lanes x533 = cosine[6] * x520 - sine[6] * x512;
  const Lanes x538 = x483 * x483;
  const Lanes x539 = x487 * x487;
  const Lanes x540 = x488 * x488;
  const Lanes x541 = x539 + x540;
  const Lanes x543 = x483 * x487;
  const Lanes x544 = x543 - x497;
  const Lanes x545 = x497 + x543;
  const Lanes x546 = x538 + x540;
  const Lanes x548 = x487 * x488;
  const Lanes x549 = x548 - x506;
  const Lanes x550 = x506 + x548;
  const Lanes x551 = x538 + x539;
  const Lanes x553 = x483 * x488;
  const Lanes x554 = x553 - x509;
  const Lanes x555 = x509 + x553;
  // link 7 "hand": force that the reference field takes
  const Lanes x1025 = x553 * 0.006916 - 0.00014399999999999992 * (x541 - x551);
  const Lanes x1018 = x506 * 0.01009033 - (x548 * 0.00506167 + x545 * 0.00014399999999999992);
  const Lanes x1043 = x509 * 0.008236 + x1025 + x525 * 0.007199999999999999;
  const Lanes x1036 = x497 * 0.00317433 - x543 * 0.0018543300000000004 + x549 * 0.00014399999999999992;
  // joint 7 "left_finger_slide": placement, velocity and reference acceleration of its link
  const Lanes x560 = x555 * 0.13;
  const Lanes x565 = x549 * 0.13;
  const Lanes x567 = x533 - x546 * q[7] + x565;
  const Lanes x571 = x525 + x551 * 0.13;
  const Lanes x574 = 2.0 * x488;
  const Lanes x576 = x550 * q[7] - x571 + 2.0 * x483 * v[7];
  const Lanes x579 = x529 + x544 * q[7] + x560 - v[7] * x574;
  // link 8 "left_finger": force that the reference field takes
  const Lanes x1082 = x497 * 8.33333e-06;
  const Lanes x1097 = x548 * 5.333337e-05 + (x551 - x546) * 1.5e-05;
  const Lanes x1089 = x1082 - x543 * 5e-06 - x555 * 1.5e-05;
  const Lanes x1113 = x506 * 6.66667e-05 - x1097 + x576 * 0.0005;
  const Lanes x1106 = x553 * 5.833337e-05 + x544 * 1.5e-05 + x509 * 6.16667e-05;
  const Lanes x1122 = x550 * 0.0005 - x551 * 0.0015 + x576 * 0.05;
  const Lanes x1127 = x555 * 0.0015 + x544 * 0.0005 + x579 * 0.05;
  // joint 8 "right_finger_slide": placement, velocity and reference acceleration of its link
  const Lanes x585 = q[8] * 2.65358979335273e-06;
  w.x[21] = x585;
  const Lanes x588 = q[8] * 0.9999999999964793;
  w.x[22] = x588;
  const Lanes x593 = x487 * 2.65358979335273e-06 - x483 * 0.9999999999964793;
  const Lanes x598 = x483 * 2.65358979335273e-06 + x487 * 0.9999999999964793;
  const Lanes x603 = x509 * 2.65358979335273e-06 - x506 * 0.9999999999964793;
  const Lanes x608 = x506 * 2.65358979335273e-06 + x509 * 0.9999999999964793;
  const Lanes x616 = x541 * x585 - x544 * x588 + x529 + x560;
  const Lanes x623 = x546 * x588 - x545 * x585 + x533 + x565;
  const Lanes x640 = 2.65358979335273e-06 * x616 + 0.9999999999964793 * x623;
  const Lanes x630 = x571 + x554 * x585 + x550 * x588;
  const Lanes x646 = v[8] * (2.0 * x593) - x630;
  const Lanes x649 = 2.65358979335273e-06 * x623 - 0.9999999999964793 * x616 - x574 * v[8];
  const Lanes x650 = x593 * x593;
  const Lanes x653 = x650 + x598 * x598;
  const Lanes x655 = x488 * x593;
  const Lanes x657 = x655 - x608;
  const Lanes x660 = x593 * x598;
  const Lanes x662 = x497 + x660;
  const Lanes x665 = x540 + x650;
  const Lanes x667 = x488 * x598;
  // link 9 "right_finger": force that the reference field takes
  const Lanes x1147 = x667 * 5.333337e-05 - 1.5e-05 * (x653 - x665);
  const Lanes x1140 = x1082 + x660 * 5e-06 - x657 * 1.5e-05;
  const Lanes x1163 = x603 * 6.66667e-05 + x1147 + x646 * 0.0005;
  const Lanes x1156 = x655 * 5.833337e-05 - x662 * 1.5e-05 - x608 * 6.16667e-05;
  const Lanes x1166 = x1156 + x649 * 0.0015;
  const Lanes x1171 = (x603 - x667) * 0.0005 - x653 * 0.0015;
  const Lanes x1172 = x646 * 0.05 + x1171;
  const Lanes x1178 = x657 * 0.0015 - x662 * 0.0005 + x649 * 0.05;
  const Lanes x1185 = (x603 + x667) * 0.0015 + x665 * 0.0005;
  // joint 8 "right_finger_slide": articulated-body inertia and bias force through it
  const Lanes x1192 = 20.0 * (x640 * 0.05 + x1185 + tau[8]);
  w.x[23] = x1192;
  const Lanes x1197 = x640 * 0.0015 + x1163 - 0.0015 * x1192;
  const Lanes x1234 = 0.0004999999999982397 + x585 * 1.3267948966716939e-07 + x588 * 0.04999999999964792;
  const Lanes x1244 = -1.3267948966763652e-09 - x585 * 3.5207693956928924e-13 - x588 * 1.3267948966716939e-07;
  const Lanes x1247 = -0.0004999999999982397 - x588 * 0.05;
  const Lanes x1250 = 1.3267948966763652e-09 + x585 * 0.05;
  const Lanes x1251 = x588 * 0.0004999999999982397;
  const Lanes x1285 = x585 * 1.3267948966763652e-09;
  const Lanes x1308 = 8.33333e-06 + x1285 + x1251 - x585 * x1244;
  const Lanes x1324 = 0.9999999999964793 * x1178 + 2.65358979335273e-06 * tau[8];
  const Lanes x1329 = 2.65358979335273e-06 * x1178 - 0.9999999999964793 * tau[8];
  const Lanes x1314 = 0.9999999999964793 * x1197 + 2.65358979335273e-06 * x1166;
  const Lanes x1319 = 2.65358979335273e-06 * x1197 - 0.9999999999964793 * x1166;
  const Lanes x1348 = x1140 - x649 * 0.0005 - x585 * x1329;
  const Lanes x1351 = x585 * 5.6332219911062896e-14 + 2.122871834682184e-10 + x588 * 2.1228718346747102e-08 + -0.00014399999999999992;
  const Lanes x1355 = -0.007199999999999999 + x1250;
  const Lanes x1357 = 0.007199999999999999 + x1244;
  const Lanes x1336 = x588 * x1172 + 0.13 * x1329 + x1314;
  const Lanes x1343 = x585 * x1172 - 0.13 * x1324 + x1319;
  // link 7 "hand": force that the reference field takes
  const Lanes x1052 = x555 * 0.0754 - x541 * 0.007199999999999999 + x529 * 0.85;
  const Lanes x1057 = x545 * 0.007199999999999999 + x549 * 0.0754 + x533 * 0.85;
  const Lanes x1065 = x554 * 0.007199999999999999 - (x525 * 0.85 + x551 * 0.0754);
  // link 8 "left_finger": force that the reference field takes
  const Lanes x1133 = x549 * 0.0015 - x546 * 0.0005 + x567 * 0.05;
  // joint 7 "left_finger_slide": articulated-body inertia and bias force through it
  const Lanes x1369 = 20.0 * (tau[7] - x1133);
  w.x[24] = x1369;
  const Lanes x1375 = q[7] * 0.05;
  const Lanes x1377 = -0.0005 - x1375;
  const Lanes x1378 = 0.0005 + x1375;
  const Lanes x1379 = q[7] * 0.0005;
  const Lanes x1372 = x1113 - x567 * 0.0015 - 0.0015 * x1369;
  // joint 8 "right_finger_slide": articulated-body inertia and bias force through it
  const Lanes x1350 = x1251 + 2.166670000897794e-05 - x588 * x1247 + 0.01009033;
  // joint 7 "left_finger_slide": articulated-body inertia and bias force through it
  const Lanes x1408 = x1247 + x1378;
  // joint 8 "right_finger_slide": articulated-body inertia and bias force through it
  const Lanes x1301 = x585 * 2.1228718346747102e-08 + 7.999999999971834e-05 + x588 * 0.007999999999943668;
  // joint 7 "left_finger_slide": articulated-body inertia and bias force through it
  const Lanes x1410 = -8e-05 - q[7] * 0.008 + x1301;
  // joint 8 "right_finger_slide": articulated-body inertia and bias force through it
  const Lanes x1356 = x588 * x1234 + x1308 + 0.00317433;
  // joint 7 "left_finger_slide": articulated-body inertia and bias force through it
  const Lanes x1412 = 8.33333e-06 + x1379 - q[7] * x1377 + x1356;
  require_more(w, x1412, 0.0, kFactorization, 6);
  const Lanes x1413 = x1234 + x1377;
  const Lanes x1401 = q[7] * x1122 - 0.13 * tau[7] + x1372;
  const Lanes x1403 = x1106 + x579 * 0.0015 + 0.13 * x1127;
  // joint 8 "right_finger_slide": articulated-body inertia and bias force through it
  const Lanes x1363 = x1036 + x533 * 0.007199999999999999 + (x1348 - x588 * x1324);
  // joint 7 "left_finger_slide": articulated-body inertia and bias force through it
  const Lanes x1421 = x1065 + x1172 + x1122;
  // joint 6 "flange_roll": articulated-body inertia and bias force through it
  const Lanes x1423 = 1 / x1412;
  // joint 7 "left_finger_slide": articulated-body inertia and bias force through it
  const Lanes x1418 = x1089 - x579 * 0.0005 - q[7] * x1127 + x1363;
  // joint 6 "flange_roll": articulated-body inertia and bias force through it
  const Lanes x1425 = x1423 * (tau[6] - x1418);
  w.x[25] = x1425;
  const Lanes x1426 = x1351 * x1423;
  w.x[26] = x1426;
  const Lanes x1427 = x1410 * x1423;
  w.x[27] = x1427;
  const Lanes x1428 = x1413 * x1423;
  w.x[28] = x1428;
  const Lanes x1429 = x1357 * x1423;
  w.x[29] = x1429;
  // joint 7 "left_finger_slide": articulated-body inertia and bias force through it
  const Lanes x1407 = 2.16667e-05 + x1379 + q[7] * x1378 + x1350;
  // joint 6 "flange_roll": articulated-body inertia and bias force through it
  const Lanes x1432 = x1407 - x1351 * x1426;
  // joint 8 "right_finger_slide": articulated-body inertia and bias force through it
  const Lanes x1273 = 3.3833269865128193e-09 - x588 * 1.3267948966763652e-09 + x585 * x1247;
  // joint 6 "flange_roll": articulated-body inertia and bias force through it
  const Lanes x1435 = x1273 - x1351 * x1427;
  const Lanes x1438 = 2.1228718346747102e-08 - x1351 * x1428;
  const Lanes x1441 = -0.07540000000005632 - x1351 * x1429;
  // joint 7 "left_finger_slide": articulated-body inertia and bias force through it
  const Lanes x1409 = x1285 + 0.001296666699991022 + x585 * x1250 + 0.008236 + 0.0012966667000000002;
  // joint 6 "flange_roll": articulated-body inertia and bias force through it
  const Lanes x1444 = x1409 - x1410 * x1427;
  const Lanes x1447 = 0.09139999999994367 - x1410 * x1428;
  const Lanes x1450 = -2.1228718346747102e-08 - x1410 * x1429;
  const Lanes x1453 = 0.9499999999996479 - x1413 * x1428;
  const Lanes x1456 = -1.3267948966716939e-07 - x1413 * x1429;
  const Lanes x1459 = 0.850000000000352 - x1357 * x1429;
  // joint 7 "left_finger_slide": articulated-body inertia and bias force through it
  const Lanes x1416 = x1018 - x533 * 0.0754 - x1336 + x1401;
  // joint 6 "flange_roll": articulated-body inertia and bias force through it
  const Lanes x1461 = x1416 + x1351 * x1425;
  // joint 7 "left_finger_slide": articulated-body inertia and bias force through it
  const Lanes x1417 = x529 * 0.0754 + x1043 + x1343 + x1403;
  // joint 6 "flange_roll": articulated-body inertia and bias force through it
  const Lanes x1463 = x1417 + x1410 * x1425;
  const Lanes x1465 = x1052 - x1324 + x1127 + x1413 * x1425;
  const Lanes x1467 = x1057 + x1329 + tau[7] + x1357 * x1425;
  const Lanes x1471 = cosine[6] * x1408 - sine[6] * x1355;
  const Lanes x1474 = sine[6] * x1408 + cosine[6] * x1355;
  const Lanes x1480 = cosine[6] * (x1438 - x1450) - sine[6] * (x1441 + x1447);
  const Lanes x1481 = sine[6] * x1480;
  const Lanes x1483 = x1441 + x1481;
  const Lanes x1484 = x1447 + x1481;
  const Lanes x1485 = cosine[6] * x1480;
  const Lanes x1487 = x1438 - x1485;
  const Lanes x1495 = 3.673205103346574e-06 * x1483 + 0.9999999999932537 * x1471;
  const Lanes x1500 = 0.9999999999932537 * x1483 - 3.673205103346574e-06 * x1471;
  const Lanes x1505 = 3.673205103346574e-06 * x1487 + 0.9999999999932537 * x1474;
  const Lanes x1507 = 0.9999999999932537 * x1505;
  const Lanes x1509 = x1474 - x1507;
  const Lanes x1510 = 3.673205103346574e-06 * x1505;
  const Lanes x1512 = x1487 - x1510;
  const Lanes x1515 = 2.0 * sine[6];
  const Lanes x1519 = cosine[6] * (x1432 - x1444) - x1435 * x1515;
  const Lanes x1522 = x1435 + sine[6] * x1519;
  const Lanes x1523 = cosine[6] * x1519;
  const Lanes x1525 = x1432 - x1523;
  const Lanes x1529 = 3.673205103346574e-06 * x1525;
  const Lanes x1534 = 3.673205103346574e-06 * x1529;
  const Lanes x1541 = cosine[6] * (x1453 - x1459) - x1456 * x1515;
  const Lanes x1544 = x1456 + sine[6] * x1541;
  const Lanes x1545 = cosine[6] * x1541;
  const Lanes x1547 = x1453 - x1545;
  const Lanes x1548 = 3.673205103346574e-06 * x1544;
  const Lanes x1550 = 0.9999999999932537 * x1544;
  const Lanes x1552 = 3.673205103346574e-06 * (x1547 - 0.95);
  const Lanes x1554 = 0.9999999999932537 * x1552;
  const Lanes x1556 = 3.673205103346574e-06 * x1552;
  const Lanes x1558 = 0.95 + x1556;
  const Lanes x1559 = x1547 - x1556;
  const Lanes x1567 = 0.09 * x1554;
  const Lanes x1569 = x1510 + x1567;
  const Lanes x1571 = 0.09 * x1558 - x1507;
  const Lanes x1574 = x1509 - 0.09 * x1559;
  const Lanes x1575 = x1512 - x1567;
  const Lanes x1582 = 0.9999999999932537 * x1522 - 0.09 * x1495;
  const Lanes x1594 = 0.09 * x1569 - (0.9999999999932537 * x1529 + 0.09 * x1512);
  const Lanes x1606 = sine[6] * x1461 + cosine[6] * x1463;
  const Lanes x1623 = sine[6] * x1465 + cosine[6] * x1467;
  const Lanes x1628 = 3.673205103346574e-06 * x1623 + 0.9999999999932537 * x1421;
  const Lanes x1633 = 0.9999999999932537 * x1623 - 3.673205103346574e-06 * x1421;
  const Lanes x1599 = x1525 - x1534 - 0.09 * x1507 + 0.09 * x1571;
  const Lanes x1646 = 0.00351 + x1599;
  require_more(w, x1646, 0.0, kFactorization, 5);
  const Lanes x1647 = 0.9999999999932537 * x1484 - 0.09 * x1548 + -0.013000000000000001;
  const Lanes x1648 = 0.052000000000000005 + x1571;
  const Lanes x1603 = cosine[6] * x1461 - sine[6] * x1463;
  const Lanes x1636 = 3.673205103346574e-06 * x1606 + 0.9999999999932537 * tau[6] + 0.09 * x1633;
  const Lanes x1640 = 0.9999999999932537 * x1606 - 3.673205103346574e-06 * tau[6] - 0.09 * x1628;
  const Lanes x1620 = cosine[6] * x1465 - sine[6] * x1467;
  // link 6 "wrist": force that the reference field takes
  const Lanes x981 = x454 * 0.052000000000000005 - x455 * 0.013000000000000001 + x443 * 1.3;
  const Lanes x986 = x436 * 1.3 + x463 * 0.052000000000000005 + x459 * 0.013000000000000001;
  // joint 5 "wrist_pitch": articulated-body inertia and bias force through it
  const Lanes x1660 = 1 / x1646;
  const Lanes x1662 = x1660 * (tau[5] - (x968 - x439 * 0.013000000000000001 + x1640));
  w.x[30] = x1662;
  const Lanes x1663 = x1582 * x1660;
  w.x[31] = x1663;
  const Lanes x1664 = x1594 * x1660;
  w.x[32] = x1664;
  const Lanes x1665 = x1647 * x1660;
  w.x[33] = x1665;
  const Lanes x1666 = x1648 * x1660;
  w.x[34] = x1666;
  const Lanes x1667 = x1575 * x1660;
  w.x[35] = x1667;
  const Lanes x1670 = x1444 + x1523 + 0.0014299999999999998 - x1582 * x1663;
  w.x[36] = x1670;
  // joint 6 "flange_roll": articulated-body inertia and bias force through it
  const Lanes x1642 = -0.0005200000000000001 - (3.673205103346574e-06 * x1522 + 0.09 * x1500);
  // joint 5 "wrist_pitch": articulated-body inertia and bias force through it
  const Lanes x1673 = x1642 - x1582 * x1664;
  w.x[37] = x1673;
  const Lanes x1676 = x1450 + x1485 - x1582 * x1665;
  const Lanes x1679 = x1495 + x1582 * x1666;
  const Lanes x1683 = 0.013000000000000001 + x1500 - x1582 * x1667;
  // joint 6 "flange_roll": articulated-body inertia and bias force through it
  const Lanes x1644 = x1534 - 0.09 * x1509 - 0.09 * x1574 + 0.00338;
  // joint 5 "wrist_pitch": articulated-body inertia and bias force through it
  const Lanes x1686 = x1644 - x1594 * x1664;
  w.x[38] = x1686;
  const Lanes x1689 = 3.673205103346574e-06 * x1484 + 0.09 * x1550 + x1594 * x1665;
  const Lanes x1693 = x1569 - x1594 * x1666;
  const Lanes x1696 = -0.052000000000000005 + x1574 - x1594 * x1667;
  const Lanes x1699 = x1459 + x1545 + 1.3 - x1647 * x1665;
  w.x[39] = x1699;
  const Lanes x1702 = x1548 + x1647 * x1666;
  w.x[40] = x1702;
  const Lanes x1706 = x1550 - x1647 * x1667;
  w.x[41] = x1706;
  const Lanes x1709 = 1.3 + x1558 - x1648 * x1666;
  w.x[42] = x1709;
  const Lanes x1712 = x1554 + x1648 * x1667;
  w.x[43] = x1712;
  const Lanes x1716 = 1.3 + x1559 - x1575 * x1667;
  w.x[44] = x1716;
  const Lanes x1718 = x938 + x436 * 0.013000000000000001 + x1603 + x1582 * x1662;
  w.x[45] = x1718;
  const Lanes x1720 = x1594 * x1662 - (x949 + x436 * 0.052000000000000005 + x1636);
  w.x[46] = x1720;
  const Lanes x1722 = x439 * 1.3 + x974 + x1620 + x1647 * x1662;
  w.x[47] = x1722;
  const Lanes x1724 = x981 - x1628 + x1648 * x1662;
  w.x[48] = x1724;
  const Lanes x1726 = x986 + x1633 + x1575 * x1662;
  w.x[49] = x1726;
  const Lanes x1730 = cosine[5] * x1683 - sine[5] * x1696;
  const Lanes x1733 = sine[5] * x1683 + cosine[5] * x1696;
  w.x[50] = x1733;
  const Lanes x1740 = cosine[5] * (x1676 - x1693) + sine[5] * (x1679 + x1689);
  const Lanes x1741 = sine[5] * x1740;
  const Lanes x1743 = x1741 - x1679;
  const Lanes x1744 = x1741 - x1689;
  const Lanes x1745 = cosine[5] * x1740;
  const Lanes x1746 = x1693 + x1745;
  w.x[51] = x1746;
  const Lanes x1747 = x1676 - x1745;
  w.x[52] = x1747;
  const Lanes x1748 = 3.673205103346574e-06 * x1744;
  w.x[53] = x1748;
  const Lanes x1750 = 0.9999999999932537 * x1744;
  w.x[54] = x1750;
  const Lanes x1755 = 3.673205103346574e-06 * x1743 + 0.9999999999932537 * x1730;
  w.x[55] = x1755;
  const Lanes x1760 = 0.9999999999932537 * x1743 - 3.673205103346574e-06 * x1730;
  w.x[56] = x1760;
  const Lanes x1765 = 3.673205103346574e-06 * x1747 + 0.9999999999932537 * x1733;
  w.x[57] = x1765;
}

ADAGEN_NOINLINE void part_0_1(Workspace& w) {
  ADAGEN_INPUTS
  const Lanes x585 = w.x[21];
  const Lanes x588 = w.x[22];
  const Lanes x699 = w.x[0];
  const Lanes x706 = w.x[1];
  const Lanes x709 = w.x[2];
  const Lanes x745 = w.x[3];
  const Lanes x750 = w.x[4];
  const Lanes x753 = w.x[5];
  const Lanes x757 = w.x[6];
  const Lanes x761 = w.x[7];
  const Lanes x766 = w.x[8];
  const Lanes x812 = w.x[9];
  const Lanes x815 = w.x[10];
  const Lanes x821 = w.x[11];
  const Lanes x827 = w.x[12];
  const Lanes x835 = w.x[13];
  const Lanes x843 = w.x[14];
  const Lanes x890 = w.x[15];
  const Lanes x893 = w.x[16];
  const Lanes x896 = w.x[17];
  const Lanes x902 = w.x[18];
  const Lanes x910 = w.x[19];
  const Lanes x916 = w.x[20];
  const Lanes x1192 = w.x[23];
  const Lanes x1369 = w.x[24];
  const Lanes x1425 = w.x[25];
  const Lanes x1426 = w.x[26];
  const Lanes x1427 = w.x[27];
  const Lanes x1428 = w.x[28];
  const Lanes x1429 = w.x[29];
  const Lanes x1662 = w.x[30];
  const Lanes x1663 = w.x[31];
  const Lanes x1664 = w.x[32];
  const Lanes x1665 = w.x[33];
  const Lanes x1666 = w.x[34];
  const Lanes x1667 = w.x[35];
  const Lanes x1670 = w.x[36];
  const Lanes x1673 = w.x[37];
  const Lanes x1686 = w.x[38];
  const Lanes x1699 = w.x[39];
  const Lanes x1702 = w.x[40];
  const Lanes x1706 = w.x[41];
  const Lanes x1709 = w.x[42];
  const Lanes x1712 = w.x[43];
  const Lanes x1716 = w.x[44];
  const Lanes x1718 = w.x[45];
  const Lanes x1720 = w.x[46];
  const Lanes x1722 = w.x[47];
  const Lanes x1724 = w.x[48];
  const Lanes x1726 = w.x[49];
  const Lanes x1733 = w.x[50];
  const Lanes x1746 = w.x[51];
  const Lanes x1747 = w.x[52];
  const Lanes x1748 = w.x[53];
  const Lanes x1750 = w.x[54];
  const Lanes x1755 = w.x[55];
  const Lanes x1760 = w.x[56];
  const Lanes x1765 = w.x[57];
  // joint 5 "wrist_pitch": articulated-body inertia and bias force through it
  const Lanes x1767 = 0.9999999999932537 * x1765;
  const Lanes x1770 = 3.673205103346574e-06 * x1765;
  const Lanes x1772 = x1747 - x1770;
  const Lanes x1775 = 2.0 * sine[5];
  const Lanes x1779 = cosine[5] * (x1670 - x1686) - x1673 * x1775;
  const Lanes x1782 = x1673 + sine[5] * x1779;
  const Lanes x1783 = cosine[5] * x1779;
  const Lanes x1785 = x1670 - x1783;
  const Lanes x1788 = 0.9999999999932537 * x1782;
  const Lanes x1789 = 3.673205103346574e-06 * x1785;
  const Lanes x1793 = 3.673205103346574e-06 * x1789;
  const Lanes x1799 = cosine[5] * x1706 + sine[5] * x1712;
  const Lanes x1803 = sine[5] * x1706 - cosine[5] * x1712;
  const Lanes x1808 = cosine[5] * (x1699 - x1709) + x1702 * x1775;
  const Lanes x1811 = sine[5] * x1808 - x1702;
  const Lanes x1812 = cosine[5] * x1808;
  const Lanes x1814 = x1699 - x1812;
  const Lanes x1831 = 3.673205103346574e-06 * (x1814 - x1716) + x1803 * 1.9999999999865075;
  const Lanes x1836 = 3.673205103346574e-06 * x1831;
  const Lanes x1846 = sine[5] * x1718 + cosine[5] * x1720;
  const Lanes x1863 = sine[5] * x1722 + cosine[5] * x1724;
  const Lanes x1878 = 0.00136 - 0.9999999999932537 * x1789;
  const Lanes x1880 = x1785 - x1793 + 0.00189125;
  require_more(w, x1880, 0.0, kFactorization, 4);
  const Lanes x1881 = -0.017 + x1750;
  // joint 4 "forearm_roll": articulated-body inertia and bias force through it
  const Lanes x1892 = 1 / x1880;
  const Lanes x1893 = tau[4] - (0.9999999999932537 * x1846 - 3.673205103346574e-06 * tau[5] + x896);
  const Lanes x1894 = x1892 * x1893;
  const Lanes x1895 = x1788 * x1892;
  const Lanes x1896 = x1878 * x1892;
  const Lanes x1897 = x1881 * x1892;
  const Lanes x1898 = x1767 * x1892;
  const Lanes x1900 = x1772 * x1892;
  const Lanes x1903 = x1686 + x1783 + 0.01553729 - x1788 * x1895;
  const Lanes x1906 = 3.673205103346574e-06 * x1782 + x1788 * x1896;
  const Lanes x1910 = x1746 - x1788 * x1897;
  const Lanes x1913 = 0.136 - x1755 + x1788 * x1898;
  const Lanes x1916 = 0.017 + x1760 - x1788 * x1900;
  const Lanes x1919 = 0.01536729 + x1793 - x1878 * x1896;
  const Lanes x1922 = -0.136 - x1748 - x1878 * x1897;
  const Lanes x1925 = x1770 + x1878 * x1898;
  const Lanes x1928 = x1733 - x1767 - x1878 * x1900;
  const Lanes x1931 = x1709 + x1812 + 1.7 - x1881 * x1897;
  const Lanes x1934 = x1881 * x1898 - (3.673205103346574e-06 * x1811 + 0.9999999999932537 * x1799);
  const Lanes x1937 = 0.9999999999932537 * x1811 - 3.673205103346574e-06 * x1799 - x1881 * x1900;
  const Lanes x1940 = x1716 + x1836 + 1.7 - x1767 * x1898;
  const Lanes x1943 = x1803 - 0.9999999999932537 * x1831 + x1767 * x1900;
  const Lanes x1946 = x1814 - x1836 + 1.7 - x1772 * x1900;
  // joint 5 "wrist_pitch": articulated-body inertia and bias force through it
  const Lanes x1885 = cosine[5] * x1718 - sine[5] * x1720 + x890;
  // joint 4 "forearm_roll": articulated-body inertia and bias force through it
  const Lanes x1948 = x1885 + x1788 * x1894;
  // joint 5 "wrist_pitch": articulated-body inertia and bias force through it
  const Lanes x1886 = x893 - (3.673205103346574e-06 * x1846 + 0.9999999999932537 * tau[5]);
  // joint 4 "forearm_roll": articulated-body inertia and bias force through it
  const Lanes x1950 = x1886 + x1878 * x1894;
  // joint 5 "wrist_pitch": articulated-body inertia and bias force through it
  const Lanes x1888 = cosine[5] * x1722 - sine[5] * x1724 + x902;
  // joint 4 "forearm_roll": articulated-body inertia and bias force through it
  const Lanes x1952 = x1888 + x1881 * x1894;
  // joint 5 "wrist_pitch": articulated-body inertia and bias force through it
  const Lanes x1889 = x910 - (3.673205103346574e-06 * x1863 + 0.9999999999932537 * x1726);
  // joint 4 "forearm_roll": articulated-body inertia and bias force through it
  const Lanes x1955 = x1889 - x1767 * x1894;
  // joint 5 "wrist_pitch": articulated-body inertia and bias force through it
  const Lanes x1890 = 0.9999999999932537 * x1863 - 3.673205103346574e-06 * x1726 + x916;
  // joint 4 "forearm_roll": articulated-body inertia and bias force through it
  const Lanes x1957 = x1890 + x1772 * x1894;
  const Lanes x1961 = cosine[4] * x1916 - sine[4] * x1928;
  const Lanes x1964 = sine[4] * x1916 + cosine[4] * x1928;
  const Lanes x1970 = cosine[4] * (x1910 - x1925) - sine[4] * (x1913 + x1922);
  const Lanes x1971 = sine[4] * x1970;
  const Lanes x1973 = x1913 + x1971;
  const Lanes x1974 = x1922 + x1971;
  const Lanes x1975 = cosine[4] * x1970;
  const Lanes x1977 = x1910 - x1975;
  const Lanes x1980 = 0.9999999999932537 * x1974;
  const Lanes x1990 = 0.9999999999932537 * x1973 + 3.673205103346574e-06 * x1961;
  const Lanes x1995 = 0.9999999999932537 * x1964 - 3.673205103346574e-06 * x1977;
  const Lanes x1996 = 0.9999999999932537 * x1995;
  const Lanes x1997 = x1964 - x1996;
  const Lanes x1999 = 3.673205103346574e-06 * x1995;
  const Lanes x2001 = x1977 + x1999;
  const Lanes x2004 = 2.0 * sine[4];
  const Lanes x2008 = cosine[4] * (x1903 - x1919) + x1906 * x2004;
  const Lanes x2011 = sine[4] * x2008 - x1906;
  const Lanes x2012 = cosine[4] * x2008;
  const Lanes x2014 = x1903 - x2012;
  const Lanes x2019 = 3.673205103346574e-06 * x2014;
  const Lanes x2023 = 3.673205103346574e-06 * x2019;
  const Lanes x2029 = cosine[4] * x1937 - sine[4] * x1943;
  const Lanes x2032 = sine[4] * x1937 + cosine[4] * x1943;
  const Lanes x2037 = cosine[4] * (x1931 - x1940) - x1934 * x2004;
  const Lanes x2040 = x1934 + sine[4] * x2037;
  const Lanes x2041 = cosine[4] * x2037;
  const Lanes x2042 = x1940 + x2041;
  const Lanes x2043 = x1931 - x2041;
  const Lanes x2047 = 0.9999999999932537 * x2029 - 3.673205103346574e-06 * x2040;
  const Lanes x2052 = 0.9999999999932537 * x2040 + 3.673205103346574e-06 * x2029;
  const Lanes x2058 = 1.9999999999865075 * x2032 - 3.673205103346574e-06 * (x2043 - x1946);
  const Lanes x2060 = x2032 - 0.9999999999932537 * x2058;
  const Lanes x2061 = 3.673205103346574e-06 * x2058;
  const Lanes x2063 = x1946 - x2061;
  const Lanes x2064 = x2043 + x2061;
  const Lanes x2065 = 0.38 * x2052;
  const Lanes x2067 = x1925 + x1975 - x2065;
  const Lanes x2070 = 3.673205103346574e-06 * x1974 + 0.08 * x2052;
  const Lanes x2078 = x1980 + 0.38 * x2042 + 0.08 * x2047;
  const Lanes x2081 = 0.9999999999932537 * x1961 - 3.673205103346574e-06 * x1973 + 0.38 * x2060;
  const Lanes x2082 = 0.08 * x2060;
  const Lanes x2084 = x2082 - x1999;
  const Lanes x2091 = x1996 + 0.38 * x2047 + 0.08 * x2063;
  const Lanes x2094 = 0.38 * x2064 - x1990;
  const Lanes x2097 = x1997 + 0.08 * x2064;
  const Lanes x2099 = x2001 + x2065 - x2082;
  const Lanes x2116 = 0.38 * x2001 - 0.9999999999932537 * x2011 - 0.38 * x2067;
  const Lanes x2117 = x2116 - 0.08 * x2081;
  const Lanes x2131 = 0.9999999999932537 * x2019 + 0.08 * x2001 + 0.38 * x2070;
  const Lanes x2132 = x2131 - 0.08 * x2084;
  const Lanes x2142 = x2014 - x2023 + 0.38 * x1980 + 0.08 * x1996;
  const Lanes x2151 = sine[4] * x1948 + cosine[4] * x1950;
  const Lanes x2165 = cosine[4] * x1952 - sine[4] * x1955;
  const Lanes x2168 = sine[4] * x1952 + cosine[4] * x1955;
  const Lanes x2172 = 0.9999999999932537 * x1957 - 3.673205103346574e-06 * x2168;
  const Lanes x2177 = 0.9999999999932537 * x2168 + 3.673205103346574e-06 * x1957;
  const Lanes x2189 = 0.9999999999932537 * x2151 + 3.673205103346574e-06 * tau[4] + 0.38 * x2165;
  const Lanes x2104 = x1919 + x2012 - 0.38 * x1990 + 0.38 * x2094;
  const Lanes x2109 = 0.38 * x1997 - 3.673205103346574e-06 * x2011 + 0.08 * x2094;
  const Lanes x2198 = 0.38 * x2078 + x2142 + 0.08 * x2091 + 0.037748300000000005;
  require_more(w, x2198, 0.0, kFactorization, 3);
  const Lanes x2199 = -0.22000000000000003 - x2078;
  const Lanes x2200 = -0.11000000000000001 - x2091;
  const Lanes x2181 = cosine[4] * x1948 - sine[4] * x1950 - 0.38 * x2177;
  const Lanes x2184 = 0.9999999999932537 * tau[4] - 3.673205103346574e-06 * x2151 - 0.08 * x2177;
  // joint 3 "elbow_pitch": articulated-body inertia and bias force through it
  const Lanes x2211 = 1 / x2198;
  const Lanes x2213 = x2211 * (tau[3] - (x821 - (0.08 * x2172 + x2189)));
  const Lanes x2214 = x2117 * x2211;
  const Lanes x2215 = x2132 * x2211;
  const Lanes x2216 = x2199 * x2211;
  const Lanes x2217 = x2200 * x2211;
  const Lanes x2218 = x2099 * x2211;
  const Lanes x2221 = 0.03224830000000001 + x2104 - x2117 * x2214;
  const Lanes x2224 = 0.011000000000000003 + x2109 - x2117 * x2215;
  const Lanes x2227 = x2067 - x2117 * x2216;
  const Lanes x2230 = x2081 - x2117 * x2217;
  const Lanes x2233 = 0.22000000000000003 + x2094 - x2117 * x2218;
  // joint 4 "forearm_roll": articulated-body inertia and bias force through it
  const Lanes x2196 = x2023 + 0.08 * x1997 + 0.08 * x2097 + 0.00825;
  // joint 3 "elbow_pitch": articulated-body inertia and bias force through it
  const Lanes x2236 = x2196 - x2132 * x2215;
  const Lanes x2239 = x2070 + x2132 * x2216;
  const Lanes x2243 = x2084 - x2132 * x2217;
  const Lanes x2246 = 0.11000000000000001 + x2097 - x2132 * x2218;
  const Lanes x2249 = 2.2 + x2042 - x2199 * x2216;
  const Lanes x2252 = x2047 - x2199 * x2217;
  const Lanes x2255 = x2052 + x2199 * x2218;
  const Lanes x2259 = 2.2 + x2063 - x2200 * x2217;
  const Lanes x2262 = x2060 - x2200 * x2218;
  const Lanes x2265 = 2.2 + x2064 - x2099 * x2218;
  const Lanes x2267 = x812 + x2181 + x2117 * x2213;
  const Lanes x2269 = x815 + x2184 + x2132 * x2213;
  const Lanes x2271 = x827 + x2165 + x2199 * x2213;
  const Lanes x2273 = x835 + x2172 + x2200 * x2213;
  const Lanes x2275 = x843 - x2177 + x2099 * x2213;
  const Lanes x2279 = cosine[3] * x2233 - sine[3] * x2246;
  const Lanes x2282 = sine[3] * x2233 + cosine[3] * x2246;
  const Lanes x2288 = cosine[3] * (x2227 - x2243) - sine[3] * (x2230 - x2239);
  const Lanes x2289 = sine[3] * x2288;
  const Lanes x2291 = x2230 + x2289;
  const Lanes x2292 = x2289 - x2239;
  const Lanes x2293 = cosine[3] * x2288;
  const Lanes x2295 = x2227 - x2293;
  const Lanes x2303 = 3.673205103346574e-06 * x2291 + 0.9999999999932537 * x2279;
  const Lanes x2308 = 0.9999999999932537 * x2291 - 3.673205103346574e-06 * x2279;
  const Lanes x2313 = 3.673205103346574e-06 * x2295 + 0.9999999999932537 * x2282;
  const Lanes x2315 = 0.9999999999932537 * x2313;
  const Lanes x2317 = x2282 - x2315;
  const Lanes x2318 = 3.673205103346574e-06 * x2313;
  const Lanes x2320 = x2295 - x2318;
  const Lanes x2323 = 2.0 * sine[3];
  const Lanes x2327 = cosine[3] * (x2221 - x2236) - x2224 * x2323;
  const Lanes x2330 = x2224 + sine[3] * x2327;
  const Lanes x2331 = cosine[3] * x2327;
  const Lanes x2333 = x2221 - x2331;
  const Lanes x2337 = 3.673205103346574e-06 * x2333;
  const Lanes x2341 = 3.673205103346574e-06 * x2337;
  const Lanes x2348 = cosine[3] * x2255 + sine[3] * x2262;
  const Lanes x2353 = cosine[3] * x2262 - sine[3] * x2255;
  const Lanes x2358 = cosine[3] * (x2249 - x2259) - x2252 * x2323;
  const Lanes x2361 = x2252 + sine[3] * x2358;
  const Lanes x2362 = cosine[3] * x2358;
  const Lanes x2364 = x2249 - x2362;
  const Lanes x2369 = 0.9999999999932537 * x2348 - 3.673205103346574e-06 * x2361;
  const Lanes x2373 = 0.9999999999932537 * x2361 + 3.673205103346574e-06 * x2348;
  const Lanes x2379 = 3.673205103346574e-06 * (x2364 - x2265) + 1.9999999999865075 * x2353;
  const Lanes x2383 = x2353 - 0.9999999999932537 * x2379;
  const Lanes x2384 = 3.673205103346574e-06 * x2379;
  const Lanes x2386 = x2265 + x2384;
  const Lanes x2387 = x2364 - x2384;
  const Lanes x2393 = 0.9999999999932537 * x2292 + 0.08 * x2369;
  const Lanes x2394 = 0.08 * x2383;
  const Lanes x2396 = x2318 - x2394;
  const Lanes x2398 = 0.08 * x2386 - x2315;
  const Lanes x2401 = x2317 - 0.08 * x2387;
  const Lanes x2402 = x2320 + x2394;
  const Lanes x2409 = 0.9999999999932537 * x2330 - 0.08 * x2303;
  const Lanes x2421 = 0.08 * x2396 - (0.9999999999932537 * x2337 + 0.08 * x2320);
  const Lanes x2433 = sine[3] * x2267 + cosine[3] * x2269;
  const Lanes x2450 = sine[3] * x2271 + cosine[3] * x2273;
  const Lanes x2455 = 3.673205103346574e-06 * x2450 + 0.9999999999932537 * x2275;
  const Lanes x2460 = 0.9999999999932537 * x2450 - 3.673205103346574e-06 * x2275;
  const Lanes x2426 = x2333 - x2341 - 0.08 * x2315 + 0.08 * x2398;
  const Lanes x2472 = 0.0039325 + x2426;
  require_more(w, x2472, 0.0, kFactorization, 2);
  const Lanes x2463 = 3.673205103346574e-06 * x2433 + 0.9999999999932537 * tau[3] + 0.08 * x2460;
  const Lanes x2467 = 0.9999999999932537 * x2433 - 3.673205103346574e-06 * tau[3] - 0.08 * x2455;
  // joint 2 "upper_arm_roll": articulated-body inertia and bias force through it
  const Lanes x2483 = 1 / x2472;
  const Lanes x2485 = x2483 * (tau[2] - (x2467 - x745));
  const Lanes x2486 = x2409 * x2483;
  const Lanes x2487 = x2421 * x2483;
  const Lanes x2488 = x2393 * x2483;
  const Lanes x2489 = x2398 * x2483;
  const Lanes x2490 = x2402 * x2483;
  const Lanes x2493 = x2236 + x2331 + 0.01132625 - x2409 * x2486;
  const Lanes x2496 = 3.673205103346574e-06 * x2330 + 0.08 * x2308 + x2409 * x2487;
  const Lanes x2500 = x2243 + x2293 - x2409 * x2488;
  const Lanes x2503 = 0.078 - x2303 - x2409 * x2489;
  const Lanes x2506 = x2308 - x2409 * x2490;
  // joint 3 "elbow_pitch": articulated-body inertia and bias force through it
  const Lanes x2470 = x2341 - 0.08 * x2317 - 0.08 * x2401 + 0.01132625;
  // joint 2 "upper_arm_roll": articulated-body inertia and bias force through it
  const Lanes x2509 = x2470 - x2421 * x2487;
  // joint 3 "elbow_pitch": articulated-body inertia and bias force through it
  const Lanes x2471 = -0.078 - (3.673205103346574e-06 * x2292 + 0.08 * x2373);
  // joint 2 "upper_arm_roll": articulated-body inertia and bias force through it
  const Lanes x2512 = x2471 - x2421 * x2488;
  const Lanes x2515 = x2396 - x2421 * x2489;
  const Lanes x2518 = x2401 - x2421 * x2490;
  const Lanes x2521 = x2259 + x2362 + 2.6 - x2393 * x2488;
  const Lanes x2524 = x2369 - x2393 * x2489;
  const Lanes x2527 = x2373 - x2393 * x2490;
  const Lanes x2530 = 2.6 + x2386 - x2398 * x2489;
  const Lanes x2533 = x2383 - x2398 * x2490;
  // joint 3 "elbow_pitch": articulated-body inertia and bias force through it
  const Lanes x2476 = cosine[3] * x2267 - sine[3] * x2269 + x750;
  // joint 2 "upper_arm_roll": articulated-body inertia and bias force through it
  const Lanes x2538 = x2476 + x2409 * x2485;
  const Lanes x2540 = x753 - x2463 + x2421 * x2485;
  // joint 3 "elbow_pitch": articulated-body inertia and bias force through it
  const Lanes x2479 = cosine[3] * x2271 - sine[3] * x2273 + x757;
  // joint 2 "upper_arm_roll": articulated-body inertia and bias force through it
  const Lanes x2542 = x2479 + x2393 * x2485;
  const Lanes x2544 = x761 - x2455 + x2398 * x2485;
  const Lanes x2553 = sine[2] * x2506 + cosine[2] * x2518;
  const Lanes x2559 = cosine[2] * (x2500 - x2515) - sine[2] * (x2503 + x2512);
  const Lanes x2560 = sine[2] * x2559;
  const Lanes x2563 = x2512 + x2560;
  const Lanes x2564 = cosine[2] * x2559;
  const Lanes x2566 = x2500 - x2564;
  const Lanes x2569 = 0.9999999999932537 * x2563;
  const Lanes x2577 = 3.673205103346574e-06 * (cosine[2] * x2506 - sine[2] * x2518);
  const Lanes x2579 = 0.9999999999932537 * (x2503 + x2560) - x2577;
  const Lanes x2584 = 3.673205103346574e-06 * x2566 + 0.9999999999932537 * x2553;
  const Lanes x2594 = 2.0 * sine[2];
  const Lanes x2598 = cosine[2] * (x2493 - x2509) + x2496 * x2594;
  const Lanes x2601 = sine[2] * x2598 - x2496;
  const Lanes x2602 = cosine[2] * x2598;
  const Lanes x2604 = x2493 - x2602;
  const Lanes x2608 = 3.673205103346574e-06 * x2604;
  const Lanes x2612 = 3.673205103346574e-06 * x2608;
  const Lanes x2626 = cosine[2] * (x2521 - x2530) - x2524 * x2594;
  const Lanes x2630 = cosine[2] * x2626;
  const Lanes x2632 = x2521 - x2630;
  const Lanes x2640 = 3.673205103346574e-06 * (cosine[2] * x2527 - sine[2] * x2533);
  const Lanes x2644 = 3.673205103346574e-06 * (x2632 - (2.6 + x2387 - x2402 * x2490));
  const Lanes x2648 = x2644 + 1.9999999999865075 * (sine[2] * x2527 + cosine[2] * x2533);
  const Lanes x2657 = 0.3 * (0.9999999999932537 * (x2524 + sine[2] * x2626) - x2640);
  const Lanes x2677 = 0.3 * (x2579 - 0.3 * (x2632 - 3.673205103346574e-06 * x2648));
  const Lanes x2689 = 0.9999999999932537 * x2601 - 0.3 * (x2566 - 3.673205103346574e-06 * x2584);
  const Lanes x2690 = 0.3 * (x2515 + x2564 - x2657) + x2689;
  const Lanes x2693 = 0.9999999999932537 * x2608 + 0.3 * (3.673205103346574e-06 * x2563);
  const Lanes x2697 = 0.3 * (x2569 + 0.3 * (x2530 + x2630));
  const Lanes x2707 = sine[2] * x2538 + cosine[2] * x2540;
  const Lanes x2731 = 0.9999999999932537 * (sine[2] * x2542 + cosine[2] * x2544);
  const Lanes x2734 = x2731 - 3.673205103346574e-06 * (x766 + x2460 + x2402 * x2485);
  const Lanes x2738 = 0.3 * (cosine[2] * x2542 - sine[2] * x2544);
  const Lanes x2744 = x2604 - x2612 + 0.3 * x2569 + x2697 + 0.048670000000000005;
  require_more(w, x2744, 0.0, kFactorization, 1);
  const Lanes x2737 = cosine[2] * x2538 - sine[2] * x2540 - 0.3 * x2734;
  // joint 1 "shoulder_pitch": articulated-body inertia and bias force through it
  const Lanes x2756 = 1 / x2744;
  // joint 2 "upper_arm_roll": articulated-body inertia and bias force through it
  const Lanes x2751 = 0.9999999999932537 * x2707 - 3.673205103346574e-06 * tau[2] + x2738 - x709;
  // joint 1 "shoulder_pitch": articulated-body inertia and bias force through it
  const Lanes x2758 = x2756 * (tau[1] - x2751);
  const Lanes x2759 = x2690 * x2756;
  const Lanes x2760 = x2693 * x2756;
  // joint 2 "upper_arm_roll": articulated-body inertia and bias force through it
  const Lanes x2741 = x2509 + x2602 - 0.3 * x2579 - x2677 + 0.048670000000000005;
  // joint 1 "shoulder_pitch": articulated-body inertia and bias force through it
  const Lanes x2768 = x2741 - x2690 * x2759;
  // joint 2 "upper_arm_roll": articulated-body inertia and bias force through it
  const Lanes x2683 = 3.673205103346574e-06 * x2601 + 0.3 * (x2553 - 0.9999999999932537 * x2584);
  const Lanes x2750 = x699 - (3.673205103346574e-06 * x2707 + 0.9999999999932537 * tau[2]);
  // joint 1 "shoulder_pitch": articulated-body inertia and bias force through it
  const Lanes x2868 = cosine[1] * (x2768 - (0.00558 + x2612 - x2693 * x2760));
  const Lanes x2873 = x2868 - (x2690 * x2760 - x2683) * (sine[1] * 2.0);
  const Lanes x2879 = x2768 - cosine[1] * x2873;
  const Lanes x2972 = sine[1] * (x706 + x2737 + x2690 * x2758);
  const Lanes x2979 = 0.9999999999932537 * (x2972 + cosine[1] * (x2750 - x2693 * x2758));
  const Lanes x3011 = x2879 - 3.673205103346574e-06 * (3.673205103346574e-06 * x2879) + 0.00882;
  require_more(w, x3011, 0.0, kFactorization, 0);
  // joint 0 "base_yaw": articulated-body inertia and bias force through it
  const Lanes x3019 = 1 / x3011 * (x2979 + 3.673205103346574e-06 * tau[1] + tau[0]);
  w.result[0] = x3019;
  // joint 1 "shoulder_pitch": its acceleration, and that of the link beyond
  const Lanes x3028 = 0.9999999999932537 * x3019;
  const Lanes x3032 = sine[1] * x3028;
  const Lanes x3034 = cosine[1] * x3028;
  const Lanes x3041 = x2758 + x2759 * x3032 - x2760 * x3034;
  const Lanes x3042 = 3.673205103346574e-06 * x3019 + x3041;
  w.result[1] = x3042;
  // joint 2 "upper_arm_roll": its acceleration, and that of the link beyond
  const Lanes x3043 = 0.3 * x3041;
  const Lanes x3044 = 0.3 * x3032;
  const Lanes x3049 = 3.673205103346574e-06 * x3034 + 0.9999999999932537 * x3041;
  const Lanes x3058 = sine[2] * x3049 - cosine[2] * x3032;
  const Lanes x3062 = sine[2] * x3032 + cosine[2] * x3049;
  const Lanes x3063 = 0.9999999999932537 * x3044;
  const Lanes x3064 = 3.673205103346574e-06 * x3044;
  const Lanes x3068 = cosine[2] * x3043 + sine[2] * x3063;
  const Lanes x3072 = cosine[2] * x3063 - sine[2] * x3043;
  const Lanes x3084 = x2485 + x2490 * x3064 - x2488 * x3068;
  const Lanes x3086 = x3084 - x2489 * x3072 - x2486 * x3058;
  const Lanes x3087 = x3086 - x2487 * x3062;
  const Lanes x3088 = x3087 - (0.9999999999932537 * x3034 - 3.673205103346574e-06 * x3041);
  w.result[2] = x3088;
  // joint 3 "elbow_pitch": its acceleration, and that of the link beyond
  const Lanes x3091 = x3072 + 0.08 * x3087;
  const Lanes x3094 = x3064 + 0.08 * x3062;
  const Lanes x3099 = 0.9999999999932537 * x3087 - 3.673205103346574e-06 * x3062;
  const Lanes x3108 = cosine[3] * x3058 + sine[3] * x3099;
  const Lanes x3112 = cosine[3] * x3099 - sine[3] * x3058;
  const Lanes x3117 = 3.673205103346574e-06 * x3091 + 0.9999999999932537 * x3094;
  const Lanes x3123 = 3.673205103346574e-06 * x3094 - 0.9999999999932537 * x3091;
  const Lanes x3127 = cosine[3] * x3068 - sine[3] * x3117;
  const Lanes x3132 = sine[3] * x3068 + cosine[3] * x3117;
  const Lanes x3145 = x2213 - x2214 * x3108 - x2215 * x3112;
  const Lanes x3147 = x3145 - x2218 * x3123 - x2216 * x3127;
  const Lanes x3148 = x2217 * x3132 + x3147;
  const Lanes x3149 = 0.9999999999932537 * x3062 + 3.673205103346574e-06 * x3087 + x3148;
  w.result[3] = x3149;
  // joint 4 "forearm_roll": its acceleration, and that of the link beyond
  const Lanes x3153 = x3127 - 0.38 * x3148;
  const Lanes x3156 = x3132 + 0.08 * x3148;
  const Lanes x3162 = x3123 + 0.08 * x3112 + 0.38 * x3108;
  const Lanes x3167 = 3.673205103346574e-06 * x3112 + 0.9999999999932537 * x3148;
  const Lanes x3176 = cosine[4] * x3108 - sine[4] * x3167;
  const Lanes x3181 = sine[4] * x3108 + cosine[4] * x3167;
  const Lanes x3187 = 3.673205103346574e-06 * x3156 - 0.9999999999932537 * x3162;
  const Lanes x3192 = 0.9999999999932537 * x3156 + 3.673205103346574e-06 * x3162;
  const Lanes x3196 = cosine[4] * x3153 + sine[4] * x3187;
  const Lanes x3200 = cosine[4] * x3187 - sine[4] * x3153;
  const Lanes x3212 = x1894 - x1895 * x3176 + x1896 * x3181;
  const Lanes x3214 = x1900 * x3192 + x3212 - x1897 * x3196;
  const Lanes x3215 = x1898 * x3200 + x3214;
  const Lanes x3216 = x3215 - (0.9999999999932537 * x3112 - 3.673205103346574e-06 * x3148);
  w.result[4] = x3216;
  // joint 5 "wrist_pitch": its acceleration, and that of the link beyond
  const Lanes x3220 = 3.673205103346574e-06 * x3181 + 0.9999999999932537 * x3215;
  const Lanes x3228 = cosine[5] * x3176 + sine[5] * x3220;
  const Lanes x3232 = cosine[5] * x3220 - sine[5] * x3176;
  const Lanes x3237 = 3.673205103346574e-06 * x3200 + 0.9999999999932537 * x3192;
  const Lanes x3243 = 3.673205103346574e-06 * x3192 - 0.9999999999932537 * x3200;
  const Lanes x3247 = cosine[5] * x3196 - sine[5] * x3237;
  const Lanes x3252 = sine[5] * x3196 + cosine[5] * x3237;
  const Lanes x3265 = x1662 - x1667 * x3243 - x1665 * x3247;
  const Lanes x3267 = x1666 * x3252 + x3265 - x1663 * x3228;
  const Lanes x3268 = x3267 - x1664 * x3232;
  const Lanes x3269 = x3268 - (0.9999999999932537 * x3181 - 3.673205103346574e-06 * x3215);
  w.result[5] = x3269;
  // joint 6 "flange_roll": its acceleration, and that of the link beyond
  const Lanes x3280 = 0.9999999999932537 * x3268 - 3.673205103346574e-06 * x3232;
  const Lanes x3289 = cosine[6] * x3228 + sine[6] * x3280;
  const Lanes x3293 = cosine[6] * x3280 - sine[6] * x3228;
  const Lanes x3296 = 0.9999999999932537 * (x3243 - 0.09 * x3232);
  const Lanes x3297 = x3296 - 3.673205103346574e-06 * (0.09 * x3268 - x3252);
  const Lanes x3306 = cosine[6] * x3247 + sine[6] * x3297;
  const Lanes x3310 = cosine[6] * x3297 - sine[6] * x3247;
  const Lanes x3320 = x1425 - x1426 * x3289 - x1427 * x3293;
  const Lanes x3322 = x3320 - x1428 * x3306 - x1429 * x3310;
  const Lanes x3323 = 0.9999999999932537 * x3232 + 3.673205103346574e-06 * x3268 + x3322;
  w.result[6] = x3323;
  // joint 7 "left_finger_slide": its acceleration, and that of the link beyond
  const Lanes x3334 = x3310 - 0.13 * x3289;
  const Lanes x3341 = x1369 + 0.03 * x3289 - x3334;
  w.result[7] = x3341;
  // joint 8 "right_finger_slide": its acceleration, and that of the link beyond
  const Lanes x3366 = 2.65358979335273e-06 * (x3306 + 0.13 * x3293 + x588 * x3322);
  const Lanes x3374 = x1192 + 0.03 * (2.65358979335273e-06 * x3293 - 0.9999999999964793 * x3289);
  const Lanes x3375 = x3366 + 0.9999999999964793 * (x3334 - x585 * x3322) + x3374;
  w.result[8] = x3375;
}

// ---- 5. processes -------------------------------------------------------------------------------

// Each process: 9 of 9 joints: "base_yaw", "shoulder_pitch", "upper_arm_roll", "elbow_pitch", "forearm_roll", "wrist_pitch", ...
constexpr std::array<int, 9> kRead_0{0, 1, 2, 3, 4, 5, 6, 7, 8};
constexpr std::array<int, 9> kOwned_0{0, 1, 2, 3, 4, 5, 6, 7, 8};

void begin_group(Workspace& w) {
  ADAGEN_INPUTS
  if (!all(unlike_zero(q + 0, 1) == 0))
    name_what_is_not_finite(w, kRead_0, kOwned_0);
  take_sines_and_cosines<7>(q + 0, w.sine.data(), w.cosine.data());
}

void end_group(Workspace& w) {
  ADAGEN_INPUTS
  if (__builtin_expect(w.status != kFine || !all(unlike_zero(w.result.data() + 0, 9) == 0), 0)) {
    // The state's own faults are named before all others.
    const int found = std::exchange(w.status, kFine);
    name_what_is_not_finite(w, kRead_0, kOwned_0);
    Channel::fail(w.status, found);
    name_what_overflows(w, kOwned_0);
  }
  if (w.status != kFine) return;
  std::copy_n(w.result.data() + 0, 9, w.qdd + 0);
}

// What is done for a group of states, in order.
constexpr std::array kParts{begin_group, part_0_0, part_0_1, end_group};


// What each process reads of q and v, the velocity entries whose qdd is its own, and whose tau it
// reads.
constexpr std::array<Range, 1> kReadQ_0{ {{0, 9}} };
constexpr std::array<Range, 1> kReadV_0{ {{0, 9}} };
constexpr std::array<Range, 1> kOwn_0{ {{0, 9}} };
constexpr std::array<Range, 1> kTorque_0{ {{0, 9}} };
[[maybe_unused]] constexpr std::array<ProcessInfo, kProcesses> kProcess{ {
    {{1, kReadQ_0.data()}, {1, kReadV_0.data()}, {1, kOwn_0.data()}, {1, kTorque_0.data()}},
    {{1, kReadQ_0.data()}, {1, kReadV_0.data()}, {1, kOwn_0.data()}, {1, kTorque_0.data()}},
} };

// States of process 0, one after the other, and where their accelerations go.
struct Batch {
  int count;
  const Number *q, *v, *tau;
  Number* qdd;
};

// Process 0 hands pieces of a batch to the others as they finish earlier ones, and solves pieces in
// between itself: faster processes get more, wherever they are. A process has two pieces, so that
// one is on its way while the other is solved. A piece is one message, all q, then all v, then all
// tau; an empty one is the end. The answer is the accelerations.
class Handout {
 public:
  // At process 0. Returns whether all states could be solved; that a process is gone joins the
  // status.
  template <class Solve>
  bool hand_out(Channel& channel, int helpers, const Batch& batch, Solve solve, int& status) {
    bool good = true;
    int next = 0;
    const auto take = [&] {
      const int first = next;
      next += piece(batch.count - first);
      return first;
    };
    while (next < batch.count && status == kFine) {
      for (int p = 1; p <= helpers; ++p) {
        Helper& helper = helpers_[static_cast<std::size_t>(p - 1)];
        while (helper.busy > 0 && is_done(helper.oldest().answered, good)) helper.drop_oldest();
        while (helper.busy < 2 && next < batch.count) {
          const int first = take();
          give(channel, helper.add(), p, batch, first, next - first, status);
        }
      }
      const int first = take();
      if (first < next) good &= solve_in_place(batch, first, next - first, solve);
    }
    for (int p = 1; p < kProcesses; ++p) {
      Helper& helper = helpers_[static_cast<std::size_t>(p - 1)];
      for (; helper.busy > 0; helper.drop_oldest())
        channel.wait(helper.oldest().answered, p, status,
                     [&](const MPI_Status& s) { good &= s.MPI_TAG == kSolved; });
      for (Given& given : helper.given) {
        channel.wait(given.sent, p, status);
        MPI_Isend(nullptr, 0, kMpiNumber, p, kStates, channel.comm(), &given.sent);
      }
    }
    for (int p = 1; p < kProcesses; ++p)
      for (Given& given : helpers_[static_cast<std::size_t>(p - 1)].given)
        channel.wait(given.sent, p, status);
    return good;
  }

  // At process 0: the others' help is over, and so is what they do it for.
  void end(Channel& channel, int& status) {
    Number nothing = 0;
    for (int p = 1; p < kProcesses; ++p)
      for (int k = 0; k < 2; ++k) {
        MPI_Request sent;
        MPI_Isend(&nothing, kEnd, kMpiNumber, p, kStates, channel.comm(), &sent);
        channel.wait(sent, p, status);
      }
  }

  // At the others, until process 0 has nothing more; patient: however long it takes. That process
  // 0 has ended it all joins the status.
  template <class Solve>
  void help(Channel& channel, Solve solve, int& status, bool patient) {
    for (Taken& piece : taken_) ask(channel, piece);
    int ends = 0;
    for (std::size_t k = 0; ends < 2 && status == kFine; k ^= 1) {
      Taken& piece = taken_[k];
      int numbers = 0;
      channel.wait(
          piece.asked, 0, status,
          [&](const MPI_Status& s) { MPI_Get_count(&s, kMpiNumber, &numbers); }, patient);
      channel.wait(piece.answered, 0, status);
      if (numbers <= kEnd) {
        if (numbers == kEnd && ++ends == 2) Channel::fail(status, failure(kEnded, 0));
        if (numbers == 0) ++ends;
        continue;
      }
      const int count = numbers / kNumbers;
      const Number* const v = piece.states.data() + count * kNq;
      const bool good = solve(count, piece.states.data(), v, v + count * kNv, piece.qdd.data());
      MPI_Isend(piece.qdd.data(), count * kNv, kMpiNumber, 0, good ? kSolved : kFailed,
                channel.comm(), &piece.answered);
      ask(channel, piece);
    }
  }

 private:
  static constexpr int kNumbers = kNq + kNv + kNtau;           // of a state
  static constexpr int kStates = 0, kSolved = 1, kFailed = 2;  // what a message is
  static constexpr int kEnd = 1;                               // numbers in one that ends it all
  // States of a piece, at most: about 64 kB, which is on its way for less time than it takes.
  static constexpr int kMost =
      std::max(1, (1 << 16) / (kNumbers * static_cast<int>(sizeof(Number)) * kLanes)) * kLanes;

  // A piece at process 0, which another solves, and at that one.
  struct Given {
    MPI_Request sent = MPI_REQUEST_NULL, answered = MPI_REQUEST_NULL;
  };
  struct Taken {
    std::array<Number, static_cast<std::size_t>(kMost) * kNumbers> states;
    std::array<Number, static_cast<std::size_t>(kMost) * kNv> qdd;
    MPI_Request asked = MPI_REQUEST_NULL, answered = MPI_REQUEST_NULL;
  };

  struct Helper {
    std::array<Given, 2> given;
    std::size_t next = 0;
    int busy = 0;
    Given& oldest() { return given[busy == 2 ? next : next ^ 1]; }
    void drop_oldest() { --busy; }
    Given& add() {
      ++busy;
      next ^= 1;
      return given[next ^ 1];
    }
  };

  // Pieces shrink towards the end, so that all are done at about the same time; but for the last,
  // they fill all lanes.
  static int piece(int left) {
    const int share = left / (4 * kProcesses) / kLanes * kLanes;
    return std::min(left, std::clamp(share, kLanes, kMost));
  }

  static bool is_done(MPI_Request& answered, bool& good) {
    int done = 0;
    MPI_Status status;
    MPI_Test(&answered, &done, &status);
    if (done != 0) good &= status.MPI_TAG == kSolved;
    return done != 0;
  }

  static void give(Channel& channel, Given& given, int p, const Batch& batch, int first, int count,
                   int& status) {
    const long row = first;
    const std::array<const Number*, 3> from{batch.q + row * kNq, batch.v + row * kNv,
                                            batch.tau + row * kNtau};
    const std::array<int, 3> lengths{count * kNq, count * kNv, count * kNtau};
    std::array<MPI_Aint, 3> places;
    for (std::size_t k = 0; k < 3; ++k) MPI_Get_address(from[k], &places[k]);
    MPI_Datatype rows;
    MPI_Type_create_hindexed(3, lengths.data(), places.data(), kMpiNumber, &rows);
    MPI_Type_commit(&rows);
    channel.wait(given.sent, p, status);
    MPI_Isend(MPI_BOTTOM, 1, rows, p, kStates, channel.comm(), &given.sent);
    MPI_Type_free(&rows);
    MPI_Irecv(batch.qdd + row * kNv, count * kNv, kMpiNumber, p, MPI_ANY_TAG, channel.comm(),
              &given.answered);
  }

  template <class Solve>
  static bool solve_in_place(const Batch& batch, int first, int count, Solve solve) {
    const long row = first;
    return solve(count, batch.q + row * kNq, batch.v + row * kNv, batch.tau + row * kNtau,
                 batch.qdd + row * kNv);
  }

  static void ask(Channel& channel, Taken& piece) {
    MPI_Irecv(piece.states.data(), static_cast<int>(piece.states.size()), kMpiNumber, 0, kStates,
              channel.comm(), &piece.asked);
  }

  std::array<Helper, kProcesses> helpers_;
  std::array<Taken, 2> taken_;
};

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

// As many states as there are lanes, one in each, and what they are solved with.
struct Group {
  Workspace w;
  std::array<Value, kNq> q{};
  std::array<Value, kNv> v{}, qdd{};
  std::array<Value, kNtau> tau{};
};

// Groups that go through each part before the next one, so that its instructions are fetched once
// for all: as many as fill half of the second-level cache, or many where not even the code fits.
constexpr int kGroups = [] {
  constexpr std::size_t kCache = 1 << 20, kCodeOfPart = 8 << 10, kMost = 8;
  constexpr std::size_t kCode = kParts.size() * kCodeOfPart;
  if (kParts.size() == 1) return 1;
  if (kCode + sizeof(Group) > kCache) return static_cast<int>(kMost);
  return static_cast<int>(std::clamp<std::size_t>(kCache / 2 / sizeof(Group), 1, kMost));
}();

// Rows of numbers, one for each state, become lanes; lanes without a state repeat the last one.
template <std::size_t width>
void to_lanes(int states, const Number* rows, std::array<Value, width>& lanes) {
  static_assert(std::is_same_v<Number, Real>);
  constexpr std::size_t kSquare = static_cast<std::size_t>(kLanes);
  if constexpr (width >= kSquare) {
    for (std::size_t k = 0; k < width && states == kLanes; k += kSquare) {
      const std::size_t first = std::min(k, width - kSquare);  // the last ones overlap
      Lanes square[kLanes];
      ADAGEN_FOR (s, 0, kLanes) load(rows + static_cast<std::size_t>(s) * width + first, square[s]);
      transpose(square);
      ADAGEN_FOR (s, 0, kLanes) lanes[first + static_cast<std::size_t>(s)] = square[s];
    }
    if (states == kLanes) return;
  }
  for (std::size_t k = 0; k < width; ++k)
    ADAGEN_FOR (s, 0, kLanes)
      lanes[k][s] = rows[static_cast<std::size_t>(std::min(s, states - 1)) * width + k];
}

// Lanes become rows of numbers.
template <std::size_t width>
void to_rows(int states, const std::array<Value, width>& lanes, Number* rows) {
  constexpr std::size_t kSquare = static_cast<std::size_t>(kLanes);
  if constexpr (width >= kSquare) {
    for (std::size_t k = 0; k < width && states == kLanes; k += kSquare) {
      const std::size_t first = std::min(k, width - kSquare);
      Lanes square[kLanes];
      ADAGEN_FOR (s, 0, kLanes) square[s] = lanes[first + static_cast<std::size_t>(s)];
      transpose(square);
      ADAGEN_FOR (s, 0, kLanes)
        store(square[s], rows + static_cast<std::size_t>(s) * width + first);
    }
    if (states == kLanes) return;
  }
  for (int s = 0; s < states; ++s)
    for (std::size_t k = 0; k < width; ++k) *rows++ = lanes[k][s];
}

// Solves many states at once, one in each lane of a register. Each process solves states of its
// own; where process 0 has them all, it hands them out (handout.hpp).
class Solver {
 public:
  Channel channel;
  Text text;  // of the last failure

  // States one after the other, as are their accelerations; nothing is said to other processes.
  // Accelerations of a state that fails are not numbers; the others are what they should be.
  int solve_batch(int count, const Number* q, const Number* v, const Number* tau, Number* qdd) {
    forget();
    return solve_rows(count, q, v, tau, qdd) ? kFine : name_failures(count, q, v, tau, qdd);
  }

  int solve(const Number* q, const Number* v, const Number* tau, Number* qdd) {
    return solve_batch(1, q, v, tau, qdd);
  }

  // Collective: process 0 has all states and gets all accelerations, and to know what failed; the
  // others return once it has. Of them, processes 1 to helpers help.
  int solve_batch_at_root(int count, const Number* q, const Number* v, const Number* tau,
                          Number* qdd, int helpers = kProcesses - 1) {
    if constexpr (kProcesses == 1) return solve_batch(count, q, v, tau, qdd);
    forget();
    const auto solve = [this](auto... rows) { return solve_rows(rows...); };
    int status = channel.broken() ? failure(kNoAnswer, 0) : kFine;
    if (status == kFine && channel.rank() > 0)
      handout_.help(channel, solve, status, false);
    else if (status == kFine &&
             !handout_.hand_out(channel, helpers, {count, q, v, tau, qdd}, solve, status))
      return name_failures(count, q, v, tau, qdd);
    if (status != kFine) text = describe(status);
    return status;
  }

  // At the others: helps process 0 with batch after batch, until it ends that.
  int serve() {
    if (channel.rank() == 0) return kFine;
    const auto solve = [this](auto... rows) { return solve_rows(rows...); };
    int status = channel.broken() ? failure(kNoAnswer, 0) : kFine;
    while (status == kFine) handout_.help(channel, solve, status, true);
    if (failure_kind(status) == kEnded) return kFine;
    text = describe(status);
    return status;
  }

  // At process 0: the others serve no longer.
  int end() {
    int status = kFine;
    if (channel.rank() == 0) handout_.end(channel, status);
    if (status != kFine) text = describe(status);
    return status;
  }

  // How many states of the last call could not be solved.
  int failures() const { return count_; }

  // The k-th of them, counted from 0; -1 where there is none, or it is not one of the first kKept.
  int failed_state(int k) {
    if (k < 0 || k >= std::min(count_, kKept)) return -1;
    text = in_words(failures_[size(k)]);
    return failures_[size(k)].state;
  }

  // Why: its status.
  int failed_status(int k) const { return failures_[size(k)].status; }

  // What simulates asks for one state at a time.
  int solve_at_root(const Number* q, const Number* v, const Number* tau, Number* qdd) {
    return solve(q, v, tau, qdd);
  }
  int end_at_root() { return kFine; }

 private:
  struct FailedState {
    int state = 0, status = kFine;
  };

  static std::size_t size(int n) { return static_cast<std::size_t>(n); }

  void forget() {
    count_ = 0;
    text.clear();
  }

  // Returns whether all states could be solved.
  bool solve_rows(int count, const Number* q, const Number* v, const Number* tau, Number* qdd) {
    bool good = true;
    for (int first = 0; first < count; first += kGroups * kLanes) {
      const int groups = std::min(kGroups, (count - first + kLanes - 1) / kLanes);
      for (int g = 0; g < groups; ++g) {
        const int at = first + g * kLanes;
        take(groups_[size(g)], at, std::min(kLanes, count - at), q, v, tau);
      }
      run(groups);
      for (int g = 0; g < groups; ++g) {
        const int at = first + g * kLanes;
        good &= give(groups_[size(g)], std::min(kLanes, count - at), qdd + size(at) * kNv);
      }
    }
    return good;
  }

  // The states from the one numbered first on.
  static void take(Group& group, int first, int states, const Number* q, const Number* v,
                   const Number* tau) {
    to_lanes(states, q + size(first) * kNq, group.q);
    to_lanes(states, v + size(first) * kNv, group.v);
    to_lanes(states, tau + size(first) * kNtau, group.tau);
  }

  // Where a group fails, each of its states is tried once more, by itself; returns whether all were
  // solved.
  bool give(Group& group, int states, Number* qdd) {
    if (group.w.status == kFine) {
      to_rows(states, group.qdd, qdd);
      return true;
    }
    Group& alone = groups_.front();
    const auto all_q = group.q;
    const auto all_v = group.v;
    const auto all_tau = group.tau;
    for (int s = 0; s < states; ++s, qdd += kNv) {
      everywhere(alone.q, all_q, s), everywhere(alone.v, all_v, s);
      everywhere(alone.tau, all_tau, s);
      if (run(1) == kFine)
        to_rows(1, alone.qdd, qdd);
      else
        std::fill_n(qdd, kNv, std::numeric_limits<Number>::quiet_NaN());
    }
    return false;
  }

  // Tries the states that have no accelerations once more, each by itself; returns the first
  // failure.
  int name_failures(int count, const Number* q, const Number* v, const Number* tau,
                    const Number* qdd) {
    for (int s = 0; s < count; ++s) {
      const Number first = qdd[size(s) * kNv];
      if (first == first) continue;
      take(groups_.front(), s, 1, q, v, tau);
      const int status = run(1);
      if (count_ < kKept) failures_[size(count_)] = {s, status};
      ++count_;
    }
    text = in_words(failures_.front());
    if (count_ > 1) {
      text += " (and ";
      text += count_ - 1;
      text += " more states)";
    }
    return failures_.front().status;
  }

  static Text in_words(const FailedState& failed) {
    Text words;
    words += "state ";
    words += failed.state + 1;
    words += ": ";
    return words += describe(failed.status).c_str();
  }

  // One lane of some values in all lanes.
  template <class Values>
  static void everywhere(Values& lanes, const Values& all, int s) {
    for (std::size_t k = 0; k < lanes.size(); ++k) lanes[k] = Value{} + all[k][s];
  }

  // Returns how the first group fares.
  int run(int groups) {
    for (int g = 0; g < groups; ++g) {
      Group& group = groups_[size(g)];
      group.w.q = group.q.data(), group.w.v = group.v.data();
      group.w.tau = group.tau.data(), group.w.qdd = group.qdd.data();
      group.w.status = kFine;
    }
    for (const auto part : kParts)
      for (int g = 0; g < groups; ++g) part(groups_[size(g)].w);
    return groups_.front().w.status;
  }

  std::array<Group, kGroups> groups_;
  static constexpr int kKept = 256;  // what fails beyond is only counted
  std::array<FailedState, kKept> failures_;
  int count_ = 0;
  Handout handout_;
};

}  // namespace

static_assert(ARM7_BATCH_P2_NQ == kNq && ARM7_BATCH_P2_NV == kNv && ARM7_BATCH_P2_NTAU == kNtau);
static_assert(int(ARM7_BATCH_P2_FINE) == int(kFine));
static_assert(int(ARM7_BATCH_P2_NOT_FINITE) == int(kNotFinite));
static_assert(int(ARM7_BATCH_P2_ZERO_QUATERNION) == int(kZeroQuaternion));
static_assert(int(ARM7_BATCH_P2_FACTORIZATION) == int(kFactorization));
static_assert(int(ARM7_BATCH_P2_OVERFLOW) == int(kOverflow));
static_assert(int(ARM7_BATCH_P2_NO_ANSWER) == int(kNoAnswer));
static_assert(int(ARM7_BATCH_P2_ENDED) == int(kEnded));
static_assert(int(ARM7_BATCH_P2_NOT_REFINED) == int(kNotRefined));
static_assert(int(ARM7_BATCH_P2_GIMBAL_LOCK) == int(kGimbalLock));
static_assert(int(ARM7_BATCH_P2_GROWTH) == int(kGrowth));
static_assert(int(ARM7_BATCH_P2_TOO_FEW_STEPS) == int(kTooFewSteps));

struct arm7_batch_p2_solver : Solver {};

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

template <class AnySolver>
AnySolver* opened(MPI_Comm comm, const char* channel, double time_limit) {
  open_failure.clear();
  try {
    const std::string kind = channel == nullptr ? "auto" : channel;
    std::string wrong = why_not_open(comm, kind, time_limit);
    if (wrong.empty()) {
      auto solver = std::make_unique<AnySolver>();
      const ChannelMode mode = kind == "window"    ? ChannelMode::kWindow
                               : kind == "message" ? ChannelMode::kMessage
                                                   : ChannelMode::kAuto;
      wrong = solver->channel.open(comm, mode, time_limit);
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

int arm7_batch_p2_joint(int k, const char** name, int* q, int* nq, int* v, int* nv) {
  if (k < 0 || k >= kJointCount) return 0;
  const JointConstants& joint = kJoints[k];
  *name = joint.name, *q = joint.q, *nq = joint.nq, *v = joint.v, *nv = joint.nv;
  return 1;
}

arm7_batch_p2_solver* arm7_batch_p2_open(MPI_Comm comm, const char* channel, double time_limit) {
  return opened<arm7_batch_p2_solver>(comm, channel, time_limit);
}

int arm7_batch_p2_solve_batch(arm7_batch_p2_solver* solver, int count, const double* q, const double* v, const double* tau, double* qdd) {
  return solver->solve_batch(count, q, v, tau, qdd);
}

int arm7_batch_p2_solve_batch_at_root(arm7_batch_p2_solver* solver, int count, const double* q, const double* v, const double* tau, double* qdd) {
  return solver->solve_batch_at_root(count, q, v, tau, qdd);
}

int arm7_batch_p2_failed_state(arm7_batch_p2_solver* solver, int k) { return solver->failed_state(k); }

int arm7_batch_p2_serve(arm7_batch_p2_solver* solver) { return solver->serve(); }

int arm7_batch_p2_end(arm7_batch_p2_solver* solver) { return solver->end(); }

int arm7_batch_p2_reason(int status) { return failure_kind(status); }

int arm7_batch_p2_failed_joint(int status) { return is_of_joint(failure_kind(status)) ? failure_place(status) : -1; }

const char* arm7_batch_p2_failure(const arm7_batch_p2_solver* solver) {
  return solver == nullptr ? open_failure.c_str() : solver->text.c_str();
}

void arm7_batch_p2_close(arm7_batch_p2_solver* solver) {
  if (solver == nullptr) return;
  solver->channel.close();
  delete solver;
}

}  // extern "C"

// ---- 6. program ---------------------------------------------------------------------------------

#ifndef ADAGEN_NO_MAIN
#include <atomic>
#include <charconv>
#include <cstdlib>
#include <fstream>
#include <initializer_list>
#include <iterator>
#include <memory>
#include <sstream>
#include <stdexcept>
#include <string>
#include <thread>
#include <vector>
#if defined(__linux__)
#include <sched.h>
#endif
#if defined(__unix__) || defined(__APPLE__)
#include <sys/time.h>
#include <unistd.h>

#include <csignal>
#endif

namespace {

constexpr const char* kRobot = "arm7";

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

// Text as a JSON string, in one line.
std::string quoted(const char* text) {
  std::string result;
  add_quoted(result, text);
  return result;
}

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
constexpr std::array<Stage, 3> kStages_0{ {
    {"kinematics", 8, -1},
    {"assembly", 0, -1},
    {"disassembly", 0, -1},
} };
constexpr std::array<Stage, 3> kStages_1{ {
    {"kinematics", 8, -1},
    {"assembly", 0, -1},
    {"disassembly", 0, -1},
} };
constexpr std::array<const Stage*, kProcesses> kStages{kStages_0.data(), kStages_1.data()};
constexpr std::array<int, kProcesses> kStageCount{3, 3};

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
    long long first = stages_ == 0 ? std::numeric_limits<long long>::max() : stamps_[0];
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
    if (kAlone) return "none";
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
constexpr Hop kWindowHop{0, 159, 0.437};
constexpr Hop kMessageHop{26, 228, 0.644};

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
        if (!kAlone) MPI_Barrier(session_.comm());
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
      return session_.complain(kInputAtFault,
                               "random state: " + std::string(describe(failed).c_str()));
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
      return session_.complain(kInputAtFault,
                               "random state: " + std::string(describe(failed).c_str()));
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
      return session_.complain(kInputAtFault,
                               "random states: " + std::string(describe(failed).c_str()));
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
      return session_.complain(kInputAtFault,
                               "random state: " + std::string(describe(failed).c_str()));
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

  // All processes that take part in an evaluation start it at the same instant of their common
  // clock; hosts have none. One alone starts at once: to meet others that it does not need would
  // only cool its caches.
  Clock::time_point start_together() const {
    if (kAlone) return Clock::now();
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
      if (failed != kFine) return describe(failed).c_str() + at(time) + (k > 0 ? kSmaller : "");
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
      return on.complain(kInputAtFault,
                         "state " + std::to_string(at + 1) + ": " + describe(failed).c_str(),
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
      solved_ = on.states.count - solver.failures();
      if (solver.failures() > 0) status = kInputAtFault;
      for (int k = 0; k < kNamed && solver.failed_state(k) >= 0; ++k)
        on.complain(status, solver.text.c_str(), on.options.states);
      if (solver.failures() > kNamed) on.complain(status, "and more states", on.options.states);
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
    Text names;
    add_names_of_run(names, joint - 1);
    warning_ = std::string("joints ") + names.c_str() +
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
      std::fprintf(stderr, "error: this solver is for exactly 2 processes, started with %d: use mpiexec -n 2\n",
                   size);
  } else if (options.help) {
    if (rank == 0) std::printf("usage: mpiexec -n 2 %s [options]\n%s", words[0], kUsageText);
  } else {
    status = std::make_unique<Program>(options, rank)->run();
  }
  MPI_Finalize();
  return status;
}
#endif  // ADAGEN_NO_MAIN
