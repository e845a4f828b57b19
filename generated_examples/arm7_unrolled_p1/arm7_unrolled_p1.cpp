// Forward dynamics of "arm7" on 1 process, emitted by adagen 0.1.0 (solver.cpp.j2). Do not edit: emit anew.
//
// robot     "arm7", 9 joints, 9 degrees of freedom, description sha256 35a799ae72b600eeca178cc12eccff22927d06b6ca76bda0ede3ef5832ebda29
// command   adagen ../models/arm7.urdf --procs 1 --shape=unrolled --name=arm7_unrolled
// options   form segment, shape unrolled, scalar double, channel auto, fixed base, gravity 0.0, 0.0, -9.81
// program   1 process; 0.283 us predicted (default profile)
//           process 0: left_finger_slide | right_finger_slide in 2 lanes, base_yaw .. flange_roll
// licence   yours to choose: what adagen emits belongs to whoever emits it
//
// The articulated-body algorithm: I^A and p^A (IA, pA), a link's inertia and bias force with all that
// hangs on it, are swept to the base, and the accelerations come back. Spatial vectors are [angular;
// linear], in link frames turned so that every joint axis is z.
//
// How to read on:
//   1. interface   what a program that links this file calls
//   2. model       the robot's constants
//   3. runtime     spatial algebra, joints, exchange between processes
//   4. joints      for each joint its memory, then what is done with it, step by step
//   5. processes   who does what, in order
//   6. program     states in, accelerations out; check; time

// ---- 1. interface -------------------------------------------------------------------------------
// To use it from a program of yours: compile this file with -DADAGEN_NO_MAIN and link it; arm7_unrolled_p1.h
// beside it is this part.
// C interface of the solver arm7_unrolled_p1: forward dynamics of "arm7" on 1 process,
// emitted by adagen 0.1.0 (interface.h.j2). Do not edit: emit anew.
#ifndef ADAGEN_ARM7_UNROLLED_P1_H
#define ADAGEN_ARM7_UNROLLED_P1_H

enum {
  ARM7_UNROLLED_P1_PROCESSES = 1,
  ARM7_UNROLLED_P1_JOINTS = 9,
  ARM7_UNROLLED_P1_NQ = 9,  // numbers in q
  ARM7_UNROLLED_P1_NV = 9,  // in v and qdd
  ARM7_UNROLLED_P1_NTAU = 9  // in tau
};

// Where each joint begins in q, and in v, tau and qdd.
enum {
  ARM7_UNROLLED_P1_Q_base_yaw = 0,
  ARM7_UNROLLED_P1_V_base_yaw = 0,  // joint 0, "base_yaw": revolute, 1 in q, 1 in v
  ARM7_UNROLLED_P1_Q_shoulder_pitch = 1,
  ARM7_UNROLLED_P1_V_shoulder_pitch = 1,  // joint 1, "shoulder_pitch": revolute, 1 in q, 1 in v
  ARM7_UNROLLED_P1_Q_upper_arm_roll = 2,
  ARM7_UNROLLED_P1_V_upper_arm_roll = 2,  // joint 2, "upper_arm_roll": revolute, 1 in q, 1 in v
  ARM7_UNROLLED_P1_Q_elbow_pitch = 3,
  ARM7_UNROLLED_P1_V_elbow_pitch = 3,  // joint 3, "elbow_pitch": revolute, 1 in q, 1 in v
  ARM7_UNROLLED_P1_Q_forearm_roll = 4,
  ARM7_UNROLLED_P1_V_forearm_roll = 4,  // joint 4, "forearm_roll": revolute, 1 in q, 1 in v
  ARM7_UNROLLED_P1_Q_wrist_pitch = 5,
  ARM7_UNROLLED_P1_V_wrist_pitch = 5,  // joint 5, "wrist_pitch": revolute, 1 in q, 1 in v
  ARM7_UNROLLED_P1_Q_flange_roll = 6,
  ARM7_UNROLLED_P1_V_flange_roll = 6,  // joint 6, "flange_roll": revolute, 1 in q, 1 in v
  ARM7_UNROLLED_P1_Q_left_finger_slide = 7,
  ARM7_UNROLLED_P1_V_left_finger_slide = 7,  // joint 7, "left_finger_slide": prismatic, 1 in q, 1 in v
  ARM7_UNROLLED_P1_Q_right_finger_slide = 8,
  ARM7_UNROLLED_P1_V_right_finger_slide = 8  // joint 8, "right_finger_slide": prismatic, 1 in q, 1 in v
};

// Why a call failed, as arm7_unrolled_p1_reason tells of the status that it returned.
enum {
  ARM7_UNROLLED_P1_FINE = 0,  // none
  ARM7_UNROLLED_P1_NOT_FINITE = 1,  // q, v or tau of a joint is not a finite number
  ARM7_UNROLLED_P1_ZERO_QUATERNION = 2,  // a joint's quaternion cannot be normalised
  ARM7_UNROLLED_P1_FACTORIZATION = 3,  // inertias beside a joint differ too much for the scalar
  ARM7_UNROLLED_P1_OVERFLOW = 4,  // a joint's acceleration is not a finite number
  ARM7_UNROLLED_P1_NO_ANSWER = 5,  // a process did not answer within the time limit
  ARM7_UNROLLED_P1_ENDED = 6,  // process 0 has ended the evaluations
  ARM7_UNROLLED_P1_NOT_REFINED = 7,  // refinement does not converge
  ARM7_UNROLLED_P1_GIMBAL_LOCK = 8,  // joints that are joined as one do not move in as many directions
  ARM7_UNROLLED_P1_GROWTH = 9,  // a link beside a joint is too light for its neighbours
  ARM7_UNROLLED_P1_TOO_FEW_STEPS = 11  // refinement converges too slowly
};

#ifdef __cplusplus
extern "C" {
#endif
typedef struct arm7_unrolled_p1_solver arm7_unrolled_p1_solver;

// Joints in order, each with its place in the state: gives name, start and size in q and v of joint
// k, or returns 0 where there is none.
int arm7_unrolled_p1_joint(int k, const char** name, int* q, int* nq, int* v, int* nv);

// A solver, with all the memory that it will ever need: no other call allocates, waits or takes a
// lock. One solver is for one thread at a time. Returns null where there is no memory;
// arm7_unrolled_p1_failure(NULL) says so.
arm7_unrolled_p1_solver* arm7_unrolled_p1_open(void);

// One evaluation. q: 9 numbers, v and tau: 9 each, qdd: 9; joints in order, quaternions
// x y z w (normalised here), floating joints [linear; angular] in the body's frame.
// Returns 0, or a status that arm7_unrolled_p1_failure puts into words; no acceleration is written then.
int arm7_unrolled_p1_solve(arm7_unrolled_p1_solver* solver, const double* q, const double* v, const double* tau, double* qdd);

// What a status says: its reason, and which joint it is about, -1 for none.
int arm7_unrolled_p1_reason(int status);
int arm7_unrolled_p1_failed_joint(int status);

// The last failure of a solver in words, valid until the next call; of null, why the last open of this
// thread returned null.
const char* arm7_unrolled_p1_failure(const arm7_unrolled_p1_solver* solver);

void arm7_unrolled_p1_close(arm7_unrolled_p1_solver* solver);
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
constexpr int kProcesses = 1;
[[maybe_unused]] constexpr bool kAlone = true;  // whether process 0 does all, and no other takes part
constexpr int kJointCount = 9, kLinkCount = kJointCount + 1;
constexpr int kNq = 9, kNv = 9;
constexpr int kOuterCount = 0, kNtau = kNv + 6 * kOuterCount;
[[maybe_unused]] constexpr int kColumns = 1;  // right-hand sides: the motion, and one per slaved joint
[[maybe_unused]] constexpr std::size_t kSlavedCount = 0;  // joints that follow others
[[maybe_unused]] constexpr bool kBatch = false;  // whether many states are solved at once
[[maybe_unused]] constexpr int kRefine = 0;  // steps of iterative refinement
[[maybe_unused]] constexpr int kPlanMessages = 0;
constexpr std::size_t kCacheLine = 64;
[[maybe_unused]] constexpr bool kFloatingBase = false;
[[maybe_unused]] constexpr double kTolerance = 1e-09;
[[maybe_unused]] constexpr int kRandomStates = 64;

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
  alignas(kCacheLine) std::array<Value, 16> angle{}, sine{}, cosine{};
  std::array<Value, kNv> result{};
  alignas(kCacheLine) std::array<Value, 2> lanes{};  // results of rows
  std::array<Real*, kPlanMessages> to{};          // messages to be sent
  std::array<const Real*, kPlanMessages> from{};  // messages received
  alignas(kCacheLine) std::array<Value, 136> x{};
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
// Process 0: 1005 products, 831 sums, 7 quotients, 167 of them in lanes
// =================================================================================================

ADAGEN_NOINLINE ADAGEN_AS_IT_STANDS void part_0_0(Workspace& w) {
  ADAGEN_INPUTS
  // joint 1 "shoulder_pitch": placement, velocity and reference acceleration of its link
  const Real x20 = v[0] * 0.9999999999932537;
  const Real x29 = v[1] - v[0] * 3.673205103346574e-06;
  const Real x27 = cosine[1] * x20;
  const Real x25 = sine[1] * x20;
  const Real x37 = sine[1] * 9.809999999933819;
  w.x[0] = x37;
  const Real x30 = v[1] * x27;
  w.x[1] = x30;
  const Real x32 = v[1] * x25;
  w.x[2] = x32;
  const Real x59 = x27 * x29;
  w.x[3] = x59;
  const Real x55 = x25 * x27;
  w.x[4] = x55;
  // joints 7 "left_finger_slide", 8 "right_finger_slide": placement, velocity and reference acceleration of their links
  const Two x558 = Two{q[7], q[8]};
  const Two x561 = Two{v[7], v[8]};
  const Two x569 = x558 * Two{0.0, 2.65358979335273e-06};
  put(x569, w.x.data() + 6);
  const Two x571 = x558 * Two{1.0, -0.9999999999964793};
  put(x571, w.x.data() + 8);
  // joints 7 "left_finger_slide", 8 "right_finger_slide": articulated-body inertia and bias force through them
  const Two x1111 = Two{tau[7], tau[8]};
  const Two x1203 = x569 * Two{0.0, 1.3267948966763652e-09};
  const Two x1172 = x571 * Two{0.0005, -0.0004999999999982397};
  const Two x1168 = Two{0.0005, -0.0004999999999982397} + x571 * 0.05;
  const Two x1171 = Two{0.0, 1.3267948966763652e-09} + x569 * 0.05;
  const Two x1166 = Two{0.0, -1.3267948966763652e-09} - x569 * Two{0.0, 3.5207693956928924e-13} + x571 * Two{0.0, 1.3267948966716939e-07};
  const Two x1156 = Two{-0.0005, 0.0004999999999982397} + x569 * Two{0.0, 1.3267948966716939e-07} - x571 * Two{0.05, 0.04999999999964792};
  const Two x1201 = x569 * Two{0.0, 5.6332219911062896e-14} + Two{0.0, 2.122871834682184e-10} - x571 * Two{0.0, 2.1228718346747102e-08};
  const Real x1271 = across<2>(x1156);
  const Two x1219 = x569 * Two{0.0, 2.1228718346747102e-08} + Two{-8e-05, 7.999999999971834e-05} - x571 * Two{0.008, 0.007999999999943668};
  const Two x1181 = x1172 + Two{2.16667e-05, 2.166670000897794e-05} + x571 * x1168;
  const Two x1211 = x1203 + Two{0.0012966667000000002, 0.001296666699991022} + x569 * x1171;
  const Real x1264 = across<2>(x1168);
  const Real x1266 = across<2>(x1219);
  const Two x1191 = x571 * Two{0.0, 1.3267948966763652e-09} + Two{0.0, 3.3833269865128193e-09} + x569 * x1168;
  const Two x1227 = 8.33333e-06 + x1203 + x1172 - x569 * x1166;
  const Two x1228 = x1227 - x571 * x1156;
  const Real x1283 = 0.007199999999999999 + across<2>(x1166);
  const Real x1281 = -0.007199999999999999 + across<2>(x1171);
  const Real x1277 = -0.00014399999999999992 + across<2>(x1201);
  const Real x1282 = 0.00317433 + across<2>(x1228);
  require_more(w, x1282, 0.0, kFactorization, 6);
  // joint 6 "flange_roll": articulated-body inertia and bias force through it
  const Real x1486 = 0.9999999999932537 * tau[6];
  w.x[10] = x1486;
  const Real x1392 = 2.0 * sine[6];
  const Real x1351 = sine[6] * x1264 + cosine[6] * x1281;
  const Real x1300 = 1 / x1282;
  // joint 5 "wrist_pitch": articulated-body inertia and bias force through it
  const Real x1731 = 3.673205103346574e-06 * tau[5];
  w.x[11] = x1731;
  const Real x1726 = 0.9999999999932537 * tau[5];
  w.x[12] = x1726;
  const Real x1652 = 2.0 * sine[5];
  // joint 4 "forearm_roll": articulated-body inertia and bias force through it
  const Real x2035 = 3.673205103346574e-06 * tau[4];
  w.x[13] = x2035;
  const Real x2031 = 0.9999999999932537 * tau[4];
  w.x[14] = x2031;
  const Real x1881 = 2.0 * sine[4];
  // joint 3 "elbow_pitch": articulated-body inertia and bias force through it
  const Real x2318 = 3.673205103346574e-06 * tau[3];
  w.x[15] = x2318;
  const Real x2313 = 0.9999999999932537 * tau[3];
  w.x[16] = x2313;
  // joint 2 "upper_arm_roll": articulated-body inertia and bias force through it
  const Real x2592 = 3.673205103346574e-06 * tau[2];
  w.x[17] = x2592;
  const Real x2587 = 0.9999999999932537 * tau[2];
  w.x[18] = x2587;
  // joint 1 "shoulder_pitch": articulated-body inertia and bias force through it
  const Real x2858 = 3.673205103346574e-06 * tau[1];
  w.x[19] = x2858;
  // joint 2 "upper_arm_roll": placement, velocity and reference acceleration of its link
  const Real x80 = 3.673205103346574e-06 * x27 + 0.9999999999932537 * x29;
  const Real x95 = 3.673205103346574e-06 * x32;
  const Real x97 = 0.9999999999932537 * x32;
  w.x[20] = x97;
  const Real x94 = 0.9999999999932537 * x27 - 3.673205103346574e-06 * x29 + v[2];
  w.x[21] = x94;
  const Real x118 = x37 + x55 * 0.3;
  const Real x89 = sine[2] * x80 - x25 * cosine[2];
  w.x[22] = x89;
  const Real x93 = x25 * sine[2] + cosine[2] * x80;
  w.x[23] = x93;
  const Real x120 = (x25 * x25 + x29 * x29) * 0.3;
  const Real x122 = x120 - cosine[1] * 9.809999999933819;
  const Real x125 = -3.603414206382989e-05 + (x30 + x59) * 0.3;
  const Real x114 = x30 * sine[2] - cosine[2] * x95 - v[2] * x89;
  w.x[24] = x114;
  const Real x129 = 0.9999999999932537 * x125 - 3.673205103346574e-06 * x122;
  const Real x162 = x89 * x94;
  w.x[25] = x162;
  const Real x111 = v[2] * x93 - (x30 * cosine[2] + sine[2] * x95);
  w.x[26] = x111;
  const Real x134 = 0.9999999999932537 * x122 + 3.673205103346574e-06 * x125;
  w.x[27] = x134;
  const Real x143 = sine[2] * x118 + cosine[2] * x129;
  w.x[28] = x143;
  const Real x148 = x93 * x93;
  w.x[29] = x148;
  // joint 3 "elbow_pitch": placement, velocity and reference acceleration of its link
  const Real x174 = 0.9999999999932537 * x94 - 3.673205103346574e-06 * x93;
  const Real x193 = 3.673205103346574e-06 * x114 + 0.9999999999932537 * x97;
  const Real x183 = x89 * cosine[3] + sine[3] * x174;
  // joint 6 "flange_roll": articulated-body inertia and bias force through it
  const Real x1348 = cosine[6] * x1264 - sine[6] * x1281;
  const Real x1305 = x1271 * x1300;
  w.x[30] = x1305;
  const Real x1306 = x1283 * x1300;
  w.x[31] = x1306;
  const Real x1303 = x1277 * x1300;
  w.x[32] = x1303;
  const Real x1304 = x1266 * x1300;
  w.x[33] = x1304;
  const Real x1330 = 0.9499999999996479 - x1271 * x1305;
  const Real x1336 = 0.850000000000352 - x1283 * x1306;
  const Real x1333 = -1.3267948966716939e-07 - x1271 * x1306;
  const Real x1315 = 2.1228718346747102e-08 - x1277 * x1305;
  const Real x1318 = -0.07540000000005632 - x1277 * x1306;
  const Real x1324 = 0.09139999999994367 - x1266 * x1305;
  const Real x1327 = -2.1228718346747102e-08 - x1266 * x1306;
  const Real x1309 = 0.01009033 + across<2>(x1181) - x1277 * x1303;
  const Real x1321 = 0.008236 + across<2>(x1211) - x1266 * x1304;
  const Real x1312 = across<2>(x1191) - x1277 * x1304;
  const Real x1418 = cosine[6] * (x1330 - x1336) - x1333 * x1392;
  const Real x1357 = cosine[6] * (x1315 - x1327) - sine[6] * (x1318 + x1324);
  const Real x1396 = cosine[6] * (x1309 - x1321) - x1312 * x1392;
  const Real x1422 = cosine[6] * x1418;
  // joint 2 "upper_arm_roll": placement, velocity and reference acceleration of its link
  const Real x139 = sine[2] * x129 - cosine[2] * x118;
  w.x[34] = x139;
  // joint 3 "elbow_pitch": placement, velocity and reference acceleration of its link
  const Real x187 = cosine[3] * x174 - x89 * sine[3];
  const Real x188 = v[3] - (0.9999999999932537 * x93 + 3.673205103346574e-06 * x94);
  const Real x220 = x143 + (x89 * x93 - x97) * 0.08;
  const Real x222 = (x162 - x114) * 0.08 - x134;
  const Real x199 = 3.673205103346574e-06 * x97 - 0.9999999999932537 * x114;
  w.x[35] = x199;
  const Real x214 = x111 * sine[3] + cosine[3] * x193 + v[3] * x183;
  w.x[36] = x214;
  const Real x246 = x188 * x188;
  const Real x249 = x183 * x187;
  w.x[37] = x249;
  const Real x259 = x183 * x188;
  w.x[38] = x259;
  const Real x211 = x111 * cosine[3] - sine[3] * x193 + v[3] * x187;
  w.x[39] = x211;
  const Real x218 = x139 - (x148 + x94 * x94) * 0.08;
  const Real x226 = 0.9999999999932537 * x222 - 3.673205103346574e-06 * x220;
  const Real x251 = x199 + x249;
  w.x[40] = x251;
  const Real x252 = x183 * x183 + x246;
  w.x[41] = x252;
  const Real x254 = x187 * x188;
  w.x[42] = x254;
  const Real x260 = x214 + x259;
  w.x[43] = x260;
  const Real x231 = 0.9999999999932537 * x220 + 3.673205103346574e-06 * x222;
  w.x[44] = x231;
  const Real x256 = x211 + x254;
  w.x[45] = x256;
  // joint 4 "forearm_roll": placement, velocity and reference acceleration of its link
  const Real x273 = 3.673205103346574e-06 * x187 + 0.9999999999932537 * x188;
  const Real x294 = 3.673205103346574e-06 * x214 - 0.9999999999932537 * x199;
  // joint 6 "flange_roll": articulated-body inertia and bias force through it
  const Real x1362 = cosine[6] * x1357;
  const Real x1358 = sine[6] * x1357;
  const Real x1400 = cosine[6] * x1396;
  const Real x1424 = x1330 - x1422;
  const Real x1364 = x1315 - x1362;
  const Real x1360 = x1318 + x1358;
  const Real x1402 = x1309 - x1400;
  const Real x1406 = 3.673205103346574e-06 * x1402;
  const Real x1429 = 3.673205103346574e-06 * (x1424 - 0.95);
  const Real x1382 = 3.673205103346574e-06 * x1364 + 0.9999999999932537 * x1351;
  const Real x1411 = 3.673205103346574e-06 * x1406;
  const Real x1433 = 3.673205103346574e-06 * x1429;
  const Real x1431 = 0.9999999999932537 * x1429;
  const Real x1384 = 0.9999999999932537 * x1382;
  const Real x1387 = 3.673205103346574e-06 * x1382;
  const Real x1435 = 0.95 + x1433;
  const Real x1436 = x1424 - x1433;
  const Real x1444 = 0.09 * x1431;
  const Real x1389 = x1364 - x1387;
  const Real x1372 = 3.673205103346574e-06 * x1360 + 0.9999999999932537 * x1348;
  const Real x1386 = x1351 - x1384;
  const Real x1399 = x1312 + sine[6] * x1396;
  const Real x1446 = x1387 + x1444;
  const Real x1448 = 0.09 * x1435 - x1384;
  const Real x1451 = x1386 - 0.09 * x1436;
  const Real x1476 = x1402 - x1411 - 0.09 * x1384 + 0.09 * x1448;
  const Real x1523 = 0.00351 + x1476;
  require_more(w, x1523, 0.0, kFactorization, 5);
  // joint 3 "elbow_pitch": placement, velocity and reference acceleration of its link
  const Real x239 = cosine[3] * x226 - sine[3] * x218;
  w.x[46] = x239;
  const Real x247 = x187 * x187 + x246;
  w.x[47] = x247;
  const Real x250 = x249 - x199;
  w.x[48] = x250;
  const Real x235 = cosine[3] * x218 + sine[3] * x226;
  w.x[49] = x235;
  // joint 4 "forearm_roll": placement, velocity and reference acceleration of its link
  const Real x282 = x183 * cosine[4] - sine[4] * x273;
  w.x[50] = x282;
  const Real x287 = x183 * sine[4] + cosine[4] * x273;
  w.x[51] = x287;
  const Real x289 = 0.9999999999932537 * x187 - 3.673205103346574e-06 * x188 + v[4];
  w.x[52] = x289;
  const Real x325 = x239 - (0.08 * x251 + x252 * 0.38);
  const Real x331 = x256 * 0.38 - (x231 + 0.08 * x260);
  const Real x299 = 0.9999999999932537 * x214 + 3.673205103346574e-06 * x199;
  w.x[53] = x299;
  const Real x313 = cosine[4] * x294 - x211 * sine[4] - v[4] * x282;
  w.x[54] = x313;
  const Real x318 = 0.08 * x247 + x250 * 0.38 + x235;
  const Real x336 = 3.673205103346574e-06 * x325 + 0.9999999999932537 * x331;
  const Real x310 = x211 * cosine[4] + sine[4] * x294 - v[4] * x287;
  w.x[55] = x310;
  const Real x341 = 0.9999999999932537 * x325 - 3.673205103346574e-06 * x331;
  w.x[56] = x341;
  const Real x350 = sine[4] * x318 + cosine[4] * x336;
  w.x[57] = x350;
  // joint 5 "wrist_pitch": placement, velocity and reference acceleration of its link
  const Real x387 = 3.673205103346574e-06 * x287 + 0.9999999999932537 * x289;
  const Real x405 = 3.673205103346574e-06 * x313 + 0.9999999999932537 * x299;
  const Real x395 = x282 * cosine[5] + sine[5] * x387;
  // joint 6 "flange_roll": articulated-body inertia and bias force through it
  const Real x1421 = x1333 + sine[6] * x1418;
  const Real x1377 = 0.9999999999932537 * x1360 - 3.673205103346574e-06 * x1348;
  const Real x1459 = 0.9999999999932537 * x1399 - 0.09 * x1372;
  w.x[58] = x1459;
  const Real x1471 = 0.09 * x1446 - (0.9999999999932537 * x1406 + 0.09 * x1389);
  w.x[59] = x1471;
  const Real x1361 = x1324 + x1358;
  const Real x1425 = 3.673205103346574e-06 * x1421;
  const Real x1524 = 0.9999999999932537 * x1361 - 0.09 * x1425 + -0.013000000000000001;
  w.x[60] = x1524;
  const Real x1525 = 0.052000000000000005 + x1448;
  w.x[61] = x1525;
  const Real x1427 = 0.9999999999932537 * x1421;
  // joint 5 "wrist_pitch": articulated-body inertia and bias force through it
  const Real x1537 = 1 / x1523;
  w.x[62] = x1537;
  const Real x1540 = x1459 * x1537;
  w.x[63] = x1540;
  const Real x1541 = x1471 * x1537;
  w.x[64] = x1541;
  const Real x1547 = x1321 + x1400 + 0.0014299999999999998 - x1459 * x1540;
  // joint 6 "flange_roll": articulated-body inertia and bias force through it
  const Real x1521 = x1411 - 0.09 * x1386 - 0.09 * x1451 + 0.00338;
  // joint 5 "wrist_pitch": articulated-body inertia and bias force through it
  const Real x1563 = x1521 - x1471 * x1541;
  // joint 6 "flange_roll": articulated-body inertia and bias force through it
  const Real x1519 = -0.0005200000000000001 - (3.673205103346574e-06 * x1399 + 0.09 * x1377);
  // joint 5 "wrist_pitch": articulated-body inertia and bias force through it
  const Real x1550 = x1519 - x1459 * x1541;
  const Real x1542 = x1524 * x1537;
  w.x[65] = x1542;
  const Real x1543 = x1525 * x1537;
  w.x[66] = x1543;
  // joint 4 "forearm_roll": placement, velocity and reference acceleration of its link
  const Real x345 = cosine[4] * x318 - sine[4] * x336;
  w.x[67] = x345;
  // joint 5 "wrist_pitch": placement, velocity and reference acceleration of its link
  const Real x399 = cosine[5] * x387 - x282 * sine[5];
  const Real x400 = 0.9999999999932537 * x287 - 3.673205103346574e-06 * x289 + v[5];
  const Real x411 = 3.673205103346574e-06 * x299 - 0.9999999999932537 * x313;
  w.x[68] = x411;
  const Real x426 = x310 * sine[5] + cosine[5] * x405 + v[5] * x395;
  const Real x431 = 3.673205103346574e-06 * x350 + 0.9999999999932537 * x341;
  const Real x452 = x395 * x399;
  w.x[69] = x452;
  const Real x462 = x395 * x400;
  const Real x454 = x411 + x452;
  w.x[70] = x454;
  const Real x463 = x426 + x462;
  w.x[71] = x463;
  const Real x436 = 0.9999999999932537 * x350 - 3.673205103346574e-06 * x341;
  w.x[72] = x436;
  const Real x443 = cosine[5] * x431 - x345 * sine[5];
  w.x[73] = x443;
  const Real x449 = x400 * x400;
  const Real x423 = x310 * cosine[5] - sine[5] * x405 + v[5] * x399;
  const Real x450 = x399 * x399 + x449;
  w.x[74] = x450;
  // joint 6 "flange_roll": placement, velocity and reference acceleration of its link
  const Real x474 = 0.9999999999932537 * x400 - 3.673205103346574e-06 * x399;
  const Real x483 = x395 * cosine[6] + sine[6] * x474;
  const Real x487 = cosine[6] * x474 - x395 * sine[6];
  const Real x488 = v[6] - (0.9999999999932537 * x399 + 3.673205103346574e-06 * x400);
  const Real x492 = 3.673205103346574e-06 * x426 + 0.9999999999932537 * x411;
  const Real x514 = x443 + x454 * 0.09;
  const Real x516 = x436 + x463 * 0.09;
  // joint 6 "flange_roll": articulated-body inertia and bias force through it
  const Real x1452 = x1389 - x1444;
  w.x[75] = x1452;
  // joint 5 "wrist_pitch": articulated-body inertia and bias force through it
  const Real x1656 = cosine[5] * (x1547 - x1563) - x1550 * x1652;
  const Real x1576 = x1336 + x1422 + 1.3 - x1524 * x1542;
  const Real x1586 = 1.3 + x1435 - x1525 * x1543;
  const Real x1660 = cosine[5] * x1656;
  const Real x1553 = x1327 + x1362 - x1459 * x1542;
  const Real x1556 = x1372 + x1459 * x1543;
  const Real x1566 = 3.673205103346574e-06 * x1361 + 0.09 * x1427 + x1471 * x1542;
  const Real x1570 = x1446 - x1471 * x1543;
  const Real x1579 = x1425 + x1524 * x1543;
  const Real x1662 = x1547 - x1660;
  const Real x1544 = x1452 * x1537;
  w.x[76] = x1544;
  const Real x1666 = 3.673205103346574e-06 * x1662;
  const Real x1685 = cosine[5] * (x1576 - x1586) + x1579 * x1652;
  const Real x1670 = 3.673205103346574e-06 * x1666;
  const Real x1560 = 0.013000000000000001 + x1377 - x1459 * x1544;
  const Real x1573 = -0.052000000000000005 + x1451 - x1471 * x1544;
  const Real x1583 = x1427 - x1524 * x1544;
  const Real x1589 = x1431 + x1525 * x1544;
  const Real x1617 = cosine[5] * (x1553 - x1570) + sine[5] * (x1556 + x1566);
  // joint 5 "wrist_pitch": placement, velocity and reference acceleration of its link
  const Real x439 = x345 * cosine[5] + sine[5] * x431;
  w.x[77] = x439;
  // joint 6 "flange_roll": placement, velocity and reference acceleration of its link
  const Real x497 = 0.9999999999932537 * x426 - 3.673205103346574e-06 * x411;
  const Real x538 = x483 * x483;
  const Real x539 = x487 * x487;
  const Real x540 = x488 * x488;
  const Real x543 = x483 * x487;
  const Real x512 = x439 - x450 * 0.09;
  const Real x520 = 0.9999999999932537 * x516 - 3.673205103346574e-06 * x514;
  const Real x541 = x539 + x540;
  const Real x545 = x497 + x543;
  const Real x506 = x423 * cosine[6] + sine[6] * x492 + v[6] * x487;
  const Real x509 = cosine[6] * x492 - x423 * sine[6] - v[6] * x483;
  const Real x548 = x487 * x488;
  const Real x553 = x483 * x488;
  const Real x529 = cosine[6] * x512 + sine[6] * x520;
  const Real x533 = cosine[6] * x520 - sine[6] * x512;
  const Real x549 = x548 - x506;
  const Real x555 = x509 + x553;
  // joints 7 "left_finger_slide", 8 "right_finger_slide": placement, velocity and reference acceleration of their links
  const Two x574 = x483 * Two{1.0, -0.9999999999964793} + x487 * Two{0.0, 2.65358979335273e-06};
  const Two x578 = x487 * Two{1.0, -0.9999999999964793} - x483 * Two{0.0, 2.65358979335273e-06};
  const Two x591 = x541 * x569 + (x543 - x497) * x571 + x529;
  const Two x592 = x555 * 0.13 + x591;
  const Two x600 = x533 - (x545 * x569 + (x538 + x540) * x571);
  const Two x601 = x549 * 0.13 + x600;
  const Two x585 = x509 * Two{1.0, -0.9999999999964793} - x506 * Two{0.0, 2.65358979335273e-06};
  // joint 5 "wrist_pitch": articulated-body inertia and bias force through it
  const Real x1689 = cosine[5] * x1685;
  const Real x1593 = 1.3 + x1436 - x1452 * x1544;
  const Real x1622 = cosine[5] * x1617;
  const Real x1691 = x1576 - x1689;
  const Real x1757 = x1662 - x1670 + 0.00189125;
  require_more(w, x1757, 0.0, kFactorization, 4);
  const Real x1610 = sine[5] * x1560 + cosine[5] * x1573;
  const Real x1618 = sine[5] * x1617;
  const Real x1624 = x1553 - x1622;
  const Real x1680 = sine[5] * x1583 - cosine[5] * x1589;
  const Real x1621 = x1618 - x1566;
  const Real x1642 = 3.673205103346574e-06 * x1624 + 0.9999999999932537 * x1610;
  const Real x1708 = 3.673205103346574e-06 * (x1691 - x1593) + x1680 * 1.9999999999865075;
  const Real x1644 = 0.9999999999932537 * x1642;
  w.x[78] = x1644;
  const Real x1713 = 3.673205103346574e-06 * x1708;
  const Real x1758 = -0.017 + 0.9999999999932537 * x1621;
  w.x[79] = x1758;
  const Real x1607 = cosine[5] * x1560 - sine[5] * x1573;
  const Real x1620 = x1618 - x1556;
  const Real x1659 = x1550 + sine[5] * x1656;
  const Real x1676 = cosine[5] * x1583 + sine[5] * x1589;
  const Real x1688 = sine[5] * x1685 - x1579;
  // joint 4 "forearm_roll": articulated-body inertia and bias force through it
  const Real x1769 = 1 / x1757;
  w.x[80] = x1769;
  const Real x1774 = x1758 * x1769;
  w.x[81] = x1774;
  const Real x1775 = x1644 * x1769;
  w.x[82] = x1775;
  // joint 6 "flange_roll": placement, velocity and reference acceleration of its link
  const Real x551 = x538 + x539;
  const Real x525 = 0.9999999999932537 * x514 + 3.673205103346574e-06 * x516;
  const Real x554 = x553 - x509;
  // joints 7 "left_finger_slide", 8 "right_finger_slide": placement, velocity and reference acceleration of their links
  const Two x631 = x488 * x574;
  const Two x636 = x574 * x578;
  const Two x633 = x585 + x631;
  const Two x637 = x636 - x497;
  const Two x581 = x506 * Two{1.0, -0.9999999999964793} + x509 * Two{0.0, 2.65358979335273e-06};
  const Two x614 = Two{1.0, -0.9999999999964793} * x592 + Two{0.0, 2.65358979335273e-06} * x601;
  const Two x626 = x614 - x561 * (2.0 * x488);
  const Two x627 = x574 * x574;
  const Two x641 = x488 * x578;
  const Two x629 = x627 + x578 * x578;
  const Two x639 = x540 + x627;
  const Two x618 = Two{1.0, -0.9999999999964793} * x601 - Two{0.0, 2.65358979335273e-06} * x592;
  // links 8 "left_finger", 9 "right_finger": force that the reference field takes
  const Two x1102 = x633 * 0.0015 + x637 * 0.0005 + x626 * 0.05;
  // joint 5 "wrist_pitch": articulated-body inertia and bias force through it
  const Real x1665 = 0.9999999999932537 * x1659;
  w.x[83] = x1665;
  const Real x1755 = 0.00136 - 0.9999999999932537 * x1666;
  w.x[84] = x1755;
  const Real x1647 = 3.673205103346574e-06 * x1642;
  const Real x1649 = x1624 - x1647;
  w.x[85] = x1649;
  // joint 4 "forearm_roll": articulated-body inertia and bias force through it
  const Real x1772 = x1665 * x1769;
  w.x[86] = x1772;
  const Real x1773 = x1755 * x1769;
  w.x[87] = x1773;
  const Real x1808 = x1586 + x1689 + 1.7 - x1758 * x1774;
  const Real x1817 = x1593 + x1713 + 1.7 - x1644 * x1775;
  const Real x1811 = x1758 * x1775 - (3.673205103346574e-06 * x1688 + 0.9999999999932537 * x1676);
  const Real x1777 = x1649 * x1769;
  w.x[88] = x1777;
  const Real x1780 = x1563 + x1660 + 0.01553729 - x1665 * x1772;
  const Real x1787 = x1570 + x1622 - x1665 * x1774;
  // joint 5 "wrist_pitch": articulated-body inertia and bias force through it
  const Real x1752 = 0.136 - (3.673205103346574e-06 * x1620 + 0.9999999999932537 * x1607);
  // joint 4 "forearm_roll": articulated-body inertia and bias force through it
  const Real x1790 = x1752 + x1665 * x1775;
  const Real x1796 = 0.01536729 + x1670 - x1755 * x1773;
  const Real x1799 = -0.136 - 3.673205103346574e-06 * x1621 - x1755 * x1774;
  const Real x1802 = x1647 + x1755 * x1775;
  const Real x1783 = 3.673205103346574e-06 * x1659 + x1665 * x1773;
  // joints 7 "left_finger_slide", 8 "right_finger_slide": placement, velocity and reference acceleration of their links
  const Two x609 = x525 + x551 * 0.13 + x554 * x569;
  const Two x611 = (x506 + x548) * x571 - x609;
  const Two x623 = x611 + x561 * (2.0 * x574);
  // links 8 "left_finger", 9 "right_finger": force that the reference field takes
  const Two x1107 = (x641 - x581) * 0.0015 - x639 * 0.0005;
  const Two x1071 = x641 * 5.333337e-05 + 1.5e-05 * (x629 - x639);
  const Two x1062 = x497 * 8.33333e-06 - x636 * 5e-06 - x633 * 1.5e-05;
  const Two x1088 = x581 * 6.66667e-05 - x1071 + x623 * 0.0005;
  const Two x1081 = x631 * 5.833337e-05 + x637 * 1.5e-05 + x585 * 6.16667e-05;
  const Two x1091 = x1081 + x626 * 0.0015;
  const Two x1096 = (x581 + x641) * 0.0005 - x629 * 0.0015;
  const Two x1097 = x623 * 0.05 + x1096;
  // joints 7 "left_finger_slide", 8 "right_finger_slide": articulated-body inertia and bias force through them
  const Two x1242 = Two{0.0, 2.65358979335273e-06} * x1102 + Two{1.0, -0.9999999999964793} * x1111;
  const Two x1239 = Two{1.0, -0.9999999999964793} * x1102 - Two{0.0, 2.65358979335273e-06} * x1111;
  const Two x1114 = 20.0 * (x1111 - (x618 * 0.05 + x1107));
  put(x1114, w.x.data() + 90);
  const Two x1257 = x1062 - x626 * 0.0005 - x569 * x1242;
  const Two x1258 = x1257 - x571 * x1239;
  const Two x1119 = x1088 - x618 * 0.0015 - 0.0015 * x1114;
  // joint 4 "forearm_roll": articulated-body inertia and bias force through it
  const Real x1914 = cosine[4] * (x1808 - x1817) - x1811 * x1881;
  const Real x1814 = 0.9999999999932537 * x1688 - 3.673205103346574e-06 * x1676 - x1758 * x1777;
  const Real x1820 = x1680 - 0.9999999999932537 * x1708 + x1644 * x1777;
  const Real x1918 = cosine[4] * x1914;
  // joint 5 "wrist_pitch": articulated-body inertia and bias force through it
  const Real x1753 = 0.9999999999932537 * x1620 - 3.673205103346574e-06 * x1607 + 0.017;
  // joint 4 "forearm_roll": articulated-body inertia and bias force through it
  const Real x1793 = x1753 - x1665 * x1777;
  const Real x1805 = x1610 - x1644 - x1755 * x1777;
  const Real x1823 = x1691 - x1713 + 1.7 - x1649 * x1777;
  const Real x1847 = cosine[4] * (x1787 - x1802) - sine[4] * (x1790 + x1799);
  const Real x1885 = cosine[4] * (x1780 - x1796) + x1783 * x1881;
  const Real x1920 = x1808 - x1918;
  const Real x1852 = cosine[4] * x1847;
  const Real x1889 = cosine[4] * x1885;
  const Real x1909 = sine[4] * x1814 + cosine[4] * x1820;
  const Real x1841 = sine[4] * x1793 + cosine[4] * x1805;
  const Real x1848 = sine[4] * x1847;
  const Real x1854 = x1787 - x1852;
  const Real x1891 = x1780 - x1889;
  const Real x1906 = cosine[4] * x1814 - sine[4] * x1820;
  const Real x1917 = x1811 + sine[4] * x1914;
  const Real x1851 = x1799 + x1848;
  const Real x1896 = 3.673205103346574e-06 * x1891;
  const Real x1919 = x1817 + x1918;
  const Real x1935 = 1.9999999999865075 * x1909 - 3.673205103346574e-06 * (x1920 - x1823);
  // joint 5 "wrist_pitch": placement, velocity and reference acceleration of its link
  const Real x455 = x395 * x395 + x449;
  w.x[92] = x455;
  // link 7 "hand": force that the reference field takes
  const Real x1008 = x497 * 0.00317433 - x543 * 0.0018543300000000004 + x549 * 0.00014399999999999992;
  const Real x997 = x553 * 0.006916 - 0.00014399999999999992 * (x541 - x551);
  const Real x990 = x506 * 0.01009033 - (x548 * 0.00506167 + x545 * 0.00014399999999999992);
  const Real x1015 = x509 * 0.008236 + x997 + x525 * 0.007199999999999999;
  // joints 7 "left_finger_slide", 8 "right_finger_slide": articulated-body inertia and bias force through them
  const Two x1232 = Two{1.0, -0.9999999999964793} * x1119 - Two{0.0, 2.65358979335273e-06} * x1091;
  const Two x1247 = x571 * x1097 - 0.13 * x1242 + x1232;
  const Two x1235 = Two{0.0, 2.65358979335273e-06} * x1119 + Two{1.0, -0.9999999999964793} * x1091;
  const Two x1252 = 0.13 * x1239 + x569 * x1097 + x1235;
  // link 7 "hand": force that the reference field takes
  const Real x1024 = x555 * 0.0754 - x541 * 0.007199999999999999 + x529 * 0.85;
  const Real x1029 = x545 * 0.007199999999999999 + x549 * 0.0754 + x533 * 0.85;
  // joint 6 "flange_roll": articulated-body inertia and bias force through it
  const Real x1302 = x1300 * (tau[6] - (x1008 + x533 * 0.007199999999999999 + across<2>(x1258)));
  w.x[93] = x1302;
  const Real x1342 = x1024 + across<2>(x1239) + x1271 * x1302;
  w.x[94] = x1342;
  const Real x1344 = x1029 + across<2>(x1242) + x1283 * x1302;
  w.x[95] = x1344;
  // joint 4 "forearm_roll": articulated-body inertia and bias force through it
  const Real x1857 = 0.9999999999932537 * x1851;
  const Real x1872 = 0.9999999999932537 * x1841 - 3.673205103346574e-06 * x1854;
  const Real x1900 = 3.673205103346574e-06 * x1896;
  const Real x1924 = 0.9999999999932537 * x1906 - 3.673205103346574e-06 * x1917;
  w.x[96] = x1924;
  const Real x1938 = 3.673205103346574e-06 * x1935;
  const Real x1873 = 0.9999999999932537 * x1872;
  const Real x1940 = x1823 - x1938;
  const Real x1955 = x1857 + 0.38 * x1919 + 0.08 * x1924;
  const Real x1968 = x1873 + 0.38 * x1924 + 0.08 * x1940;
  const Real x2019 = x1891 - x1900 + 0.38 * x1857 + 0.08 * x1873;
  const Real x2075 = 0.38 * x1955 + x2019 + 0.08 * x1968 + 0.037748300000000005;
  require_more(w, x2075, 0.0, kFactorization, 3);
  const Real x1850 = x1790 + x1848;
  // joint 3 "elbow_pitch": articulated-body inertia and bias force through it
  const Real x2088 = 1 / x2075;
  w.x[97] = x2088;
  // joint 5 "wrist_pitch": placement, velocity and reference acceleration of its link
  const Real x457 = x399 * x400;
  const Real x459 = x423 + x457;
  w.x[98] = x459;
  // link 6 "wrist": force that the reference field takes
  const Real x929 = x411 * 0.00351 + x452 * 0.0019500000000000001;
  const Real x904 = x423 * 0.0014299999999999998;
  w.x[99] = x904;
  const Real x905 = x457 * 0.00013000000000000002;
  w.x[100] = x905;
  const Real x911 = x426 * 0.00338;
  w.x[101] = x911;
  const Real x914 = x462 * 0.0020800000000000003;
  w.x[102] = x914;
  const Real x940 = x929 - 0.0005200000000000001 * (x455 - x450) + x443 * 0.052000000000000005;
  const Real x941 = x940 - x439 * 0.013000000000000001;
  w.x[103] = x941;
  // link 7 "hand": force that the reference field takes
  const Real x1037 = x554 * 0.007199999999999999 - (x525 * 0.85 + x551 * 0.0754);
  // joints 7 "left_finger_slide", 8 "right_finger_slide": articulated-body inertia and bias force through them
  const Real x1298 = x1037 + across<2>(x1097);
  // joint 6 "flange_roll": articulated-body inertia and bias force through it
  const Real x1338 = x990 - x533 * 0.0754 + across<2>(x1247) + x1277 * x1302;
  w.x[104] = x1338;
  const Real x1340 = x529 * 0.0754 + x1015 + across<2>(x1252) + x1266 * x1302;
  w.x[105] = x1340;
  const Real x1500 = sine[6] * x1342 + cosine[6] * x1344;
  const Real x1483 = sine[6] * x1338 + cosine[6] * x1340;
  w.x[106] = x1483;
  const Real x1505 = 3.673205103346574e-06 * x1500 + 0.9999999999932537 * x1298;
  w.x[107] = x1505;
  const Real x1507 = 0.9999999999932537 * x1500;
  w.x[108] = x1507;
  const Real x1508 = 3.673205103346574e-06 * x1298;
  w.x[109] = x1508;
  const Real x1517 = 0.9999999999932537 * x1483 - 3.673205103346574e-06 * tau[6] - 0.09 * x1505;
  w.x[110] = x1517;
  // joint 4 "forearm_roll": articulated-body inertia and bias force through it
  const Real x1838 = cosine[4] * x1793 - sine[4] * x1805;
  const Real x1876 = 3.673205103346574e-06 * x1872;
  const Real x1929 = 0.9999999999932537 * x1917 + 3.673205103346574e-06 * x1906;
  w.x[111] = x1929;
  const Real x1878 = x1854 + x1876;
  const Real x1888 = sine[4] * x1885 - x1783;
  const Real x1937 = x1909 - 0.9999999999932537 * x1935;
  w.x[112] = x1937;
  const Real x1942 = 0.38 * x1929;
  const Real x2076 = -0.22000000000000003 - x1955;
  w.x[113] = x2076;
  const Real x2077 = -0.11000000000000001 - x1968;
  w.x[114] = x2077;
  const Real x1941 = x1920 + x1938;
  w.x[115] = x1941;
  const Real x1944 = x1802 + x1852 - x1942;
  w.x[116] = x1944;
  const Real x1947 = 3.673205103346574e-06 * x1851 + 0.08 * x1929;
  w.x[117] = x1947;
  const Real x1959 = 0.08 * x1937;
  const Real x1867 = 0.9999999999932537 * x1850 + 3.673205103346574e-06 * x1838;
  const Real x1874 = x1841 - x1873;
  const Real x1958 = 0.9999999999932537 * x1838 - 3.673205103346574e-06 * x1850 + 0.38 * x1937;
  w.x[118] = x1958;
  const Real x1961 = x1959 - x1876;
  w.x[119] = x1961;
  const Real x1971 = 0.38 * x1941 - x1867;
  w.x[120] = x1971;
  const Real x1974 = x1874 + 0.08 * x1941;
  w.x[121] = x1974;
  const Real x1892 = 3.673205103346574e-06 * x1888;
  w.x[122] = x1892;
  const Real x1976 = x1878 + x1942 - x1959;
  w.x[123] = x1976;
  const Real x1979 = 0.38 * x1971;
  w.x[124] = x1979;
  const Real x1980 = x1796 + x1889 - 0.38 * x1867;
  w.x[125] = x1980;
  const Real x1982 = 0.38 * x1874;
  w.x[126] = x1982;
  const Real x1993 = 0.38 * x1878 - 0.9999999999932537 * x1888 - 0.38 * x1944;
  const Real x1994 = x1993 - 0.08 * x1958;
  w.x[127] = x1994;
  const Real x1997 = 0.08 * x1974;
  w.x[128] = x1997;
  const Real x1999 = x1900 + 0.08 * x1874;
  w.x[129] = x1999;
  const Real x2008 = 0.9999999999932537 * x1896 + 0.08 * x1878 + 0.38 * x1947;
  const Real x2009 = x2008 - 0.08 * x1961;
  w.x[130] = x2009;
  // joint 3 "elbow_pitch": articulated-body inertia and bias force through it
  const Real x2093 = x2076 * x2088;
  w.x[131] = x2093;
  const Real x2094 = x2077 * x2088;
  w.x[132] = x2094;
  const Real x2126 = 2.2 + x1919 - x2076 * x2093;
  w.x[133] = x2126;
  const Real x2127 = x2076 * x2094;
  w.x[134] = x2127;
  const Real x2136 = 2.2 + x1940 - x2077 * x2094;
  w.x[135] = x2136;
}

ADAGEN_NOINLINE ADAGEN_AS_IT_STANDS void part_0_1(Workspace& w) {
  ADAGEN_INPUTS
  const Real x30 = w.x[1];
  const Real x32 = w.x[2];
  const Real x37 = w.x[0];
  const Real x55 = w.x[4];
  const Real x59 = w.x[3];
  const Real x89 = w.x[22];
  const Real x93 = w.x[23];
  const Real x94 = w.x[21];
  const Real x97 = w.x[20];
  const Real x111 = w.x[26];
  const Real x114 = w.x[24];
  const Real x134 = w.x[27];
  const Real x139 = w.x[34];
  const Real x143 = w.x[28];
  const Real x148 = w.x[29];
  const Real x162 = w.x[25];
  const Real x199 = w.x[35];
  const Real x211 = w.x[39];
  const Real x214 = w.x[36];
  const Real x231 = w.x[44];
  const Real x235 = w.x[49];
  const Real x239 = w.x[46];
  const Real x247 = w.x[47];
  const Real x249 = w.x[37];
  const Real x250 = w.x[48];
  const Real x251 = w.x[40];
  const Real x252 = w.x[41];
  const Real x254 = w.x[42];
  const Real x256 = w.x[45];
  const Real x259 = w.x[38];
  const Real x260 = w.x[43];
  const Real x282 = w.x[50];
  const Real x287 = w.x[51];
  const Real x289 = w.x[52];
  const Real x299 = w.x[53];
  const Real x310 = w.x[55];
  const Real x313 = w.x[54];
  const Real x341 = w.x[56];
  const Real x345 = w.x[67];
  const Real x350 = w.x[57];
  const Real x411 = w.x[68];
  const Real x436 = w.x[72];
  const Real x439 = w.x[77];
  const Real x443 = w.x[73];
  const Real x450 = w.x[74];
  const Real x452 = w.x[69];
  const Real x454 = w.x[70];
  const Real x455 = w.x[92];
  const Real x459 = w.x[98];
  const Real x463 = w.x[71];
  const Two x569 = taken<Two>(w.x.data() + 6);
  const Two x571 = taken<Two>(w.x.data() + 8);
  const Real x904 = w.x[99];
  const Real x905 = w.x[100];
  const Real x911 = w.x[101];
  const Real x914 = w.x[102];
  const Real x941 = w.x[103];
  const Two x1114 = taken<Two>(w.x.data() + 90);
  const Real x1302 = w.x[93];
  const Real x1303 = w.x[32];
  const Real x1304 = w.x[33];
  const Real x1305 = w.x[30];
  const Real x1306 = w.x[31];
  const Real x1338 = w.x[104];
  const Real x1340 = w.x[105];
  const Real x1342 = w.x[94];
  const Real x1344 = w.x[95];
  const Real x1452 = w.x[75];
  const Real x1459 = w.x[58];
  const Real x1471 = w.x[59];
  const Real x1483 = w.x[106];
  const Real x1486 = w.x[10];
  const Real x1505 = w.x[107];
  const Real x1507 = w.x[108];
  const Real x1508 = w.x[109];
  const Real x1517 = w.x[110];
  const Real x1524 = w.x[60];
  const Real x1525 = w.x[61];
  const Real x1537 = w.x[62];
  const Real x1540 = w.x[63];
  const Real x1541 = w.x[64];
  const Real x1542 = w.x[65];
  const Real x1543 = w.x[66];
  const Real x1544 = w.x[76];
  const Real x1644 = w.x[78];
  const Real x1649 = w.x[85];
  const Real x1665 = w.x[83];
  const Real x1726 = w.x[12];
  const Real x1731 = w.x[11];
  const Real x1755 = w.x[84];
  const Real x1758 = w.x[79];
  const Real x1769 = w.x[80];
  const Real x1772 = w.x[86];
  const Real x1773 = w.x[87];
  const Real x1774 = w.x[81];
  const Real x1775 = w.x[82];
  const Real x1777 = w.x[88];
  const Real x1892 = w.x[122];
  const Real x1924 = w.x[96];
  const Real x1929 = w.x[111];
  const Real x1937 = w.x[112];
  const Real x1941 = w.x[115];
  const Real x1944 = w.x[116];
  const Real x1947 = w.x[117];
  const Real x1958 = w.x[118];
  const Real x1961 = w.x[119];
  const Real x1971 = w.x[120];
  const Real x1974 = w.x[121];
  const Real x1976 = w.x[123];
  const Real x1979 = w.x[124];
  const Real x1980 = w.x[125];
  const Real x1982 = w.x[126];
  const Real x1994 = w.x[127];
  const Real x1997 = w.x[128];
  const Real x1999 = w.x[129];
  const Real x2009 = w.x[130];
  const Real x2031 = w.x[14];
  const Real x2035 = w.x[13];
  const Real x2076 = w.x[113];
  const Real x2077 = w.x[114];
  const Real x2088 = w.x[97];
  const Real x2093 = w.x[131];
  const Real x2094 = w.x[132];
  const Real x2126 = w.x[133];
  const Real x2127 = w.x[134];
  const Real x2136 = w.x[135];
  const Real x2313 = w.x[16];
  const Real x2318 = w.x[15];
  const Real x2587 = w.x[18];
  const Real x2592 = w.x[17];
  const Real x2858 = w.x[19];
  // joint 4 "forearm_roll": placement, velocity and reference acceleration of its link
  const Real x356 = x282 * x282;
  const Real x362 = x282 * x287;
  const Real x376 = x282 * x289;
  // joint 6 "flange_roll": articulated-body inertia and bias force through it
  const Real x1510 = x1507 - x1508;
  // link 6 "wrist": force that the reference field takes
  const Real x932 = x904 + x905 + x463 * 0.0005200000000000001 + x436 * 0.013000000000000001;
  const Real x935 = x911 + x914 + x459 * 0.0005200000000000001 + x436 * 0.052000000000000005;
  // joint 5 "wrist_pitch": articulated-body inertia and bias force through it
  const Real x1539 = x1537 * (tau[5] - (x941 + x1517));
  // joint 6 "flange_roll": articulated-body inertia and bias force through it
  const Real x1529 = cosine[6] * x1338 - sine[6] * x1340 + x932;
  // joint 5 "wrist_pitch": articulated-body inertia and bias force through it
  const Real x1595 = x1529 + x1459 * x1539;
  // joint 6 "flange_roll": articulated-body inertia and bias force through it
  const Real x1530 = 3.673205103346574e-06 * x1483 + x1486 + 0.09 * x1510 + x935;
  // joint 5 "wrist_pitch": articulated-body inertia and bias force through it
  const Real x1597 = x1471 * x1539 - x1530;
  // joint 3 "elbow_pitch": articulated-body inertia and bias force through it
  const Real x2129 = x1924 - x2127;
  const Real x2200 = 2.0 * sine[3];
  const Real x2091 = x1994 * x2088;
  const Real x2092 = x2009 * x2088;
  const Real x2095 = x1976 * x2088;
  const Real x2104 = x1944 - x1994 * x2093;
  const Real x2107 = x1958 - x1994 * x2094;
  const Real x2116 = x1947 + x2009 * x2093;
  const Real x2120 = x1961 - x2009 * x2094;
  const Real x2235 = cosine[3] * (x2126 - x2136) - x2129 * x2200;
  const Real x2098 = x1979 + x1980 + 0.03224830000000001 - x1994 * x2091;
  const Real x2113 = x1997 + x1999 + 0.00825 - x2009 * x2092;
  const Real x2132 = x1929 + x2076 * x2095;
  const Real x2139 = x1937 - x2077 * x2095;
  const Real x2239 = cosine[3] * x2235;
  // joint 4 "forearm_roll": articulated-body inertia and bias force through it
  const Real x2071 = x1982 - x1892 + 0.08 * x1971 + 0.011000000000000003;
  // joint 3 "elbow_pitch": articulated-body inertia and bias force through it
  const Real x2101 = x2071 - x1994 * x2092;
  const Real x2142 = 2.2 + x1941 - x1976 * x2095;
  const Real x2241 = x2126 - x2239;
  const Real x2110 = 0.22000000000000003 + x1971 - x1994 * x2095;
  const Real x2123 = 0.11000000000000001 + x1974 - x2009 * x2095;
  const Real x2165 = cosine[3] * (x2104 - x2120) - sine[3] * (x2107 - x2116);
  const Real x2230 = cosine[3] * x2139 - sine[3] * x2132;
  // joint 4 "forearm_roll": placement, velocity and reference acceleration of its link
  const Real x367 = x356 + x289 * x289;
  const Real x374 = x356 + x287 * x287;
  const Real x378 = x313 + x376;
  const Real x369 = x287 * x289;
  const Real x364 = x299 - x362;
  // link 5 "wrist_housing": force that the reference field takes
  const Real x857 = x362 * 0.00017 - x299 * 0.00189125 + x378 * 0.00136;
  const Real x839 = x369 * 0.01347604 + 0.00136 * (x374 - x367);
  const Real x861 = x310 * 0.01553729 + x839 + x341 * 0.017;
  const Real x848 = x376 * 0.01364604 - x364 * 0.00136 + x313 * 0.01536729;
  const Real x881 = (x310 + x369) * 0.136 - x367 * 0.017;
  // link 6 "wrist": force that the reference field takes
  const Real x946 = (x452 - x411) * 0.013000000000000001 - x450 * 0.052000000000000005;
  // joint 6 "flange_roll": articulated-body inertia and bias force through it
  const Real x1497 = cosine[6] * x1342 - sine[6] * x1344;
  // link 6 "wrist": force that the reference field takes
  const Real x953 = x454 * 0.052000000000000005 - x455 * 0.013000000000000001 + x443 * 1.3;
  const Real x958 = x436 * 1.3 + x463 * 0.052000000000000005 + x459 * 0.013000000000000001;
  // joint 5 "wrist_pitch": articulated-body inertia and bias force through it
  const Real x1723 = sine[5] * x1595 + cosine[5] * x1597;
  const Real x1599 = x439 * 1.3 + x946 + x1497 + x1524 * x1539;
  const Real x1601 = x953 - x1505 + x1525 * x1539;
  const Real x1603 = x958 + x1510 + x1452 * x1539;
  const Real x1740 = sine[5] * x1599 + cosine[5] * x1601;
  const Real x1764 = x857 - x345 * 0.017 + (0.9999999999932537 * x1723 - x1731);
  // joint 3 "elbow_pitch": articulated-body inertia and bias force through it
  const Real x2170 = cosine[3] * x2165;
  const Real x2204 = cosine[3] * (x2098 - x2113) - x2101 * x2200;
  const Real x2159 = sine[3] * x2110 + cosine[3] * x2123;
  const Real x2172 = x2104 - x2170;
  const Real x2208 = cosine[3] * x2204;
  const Real x2256 = 3.673205103346574e-06 * (x2241 - x2142) + 1.9999999999865075 * x2230;
  const Real x2210 = x2098 - x2208;
  const Real x2261 = 3.673205103346574e-06 * x2256;
  const Real x2190 = 3.673205103346574e-06 * x2172 + 0.9999999999932537 * x2159;
  const Real x2214 = 3.673205103346574e-06 * x2210;
  const Real x2263 = x2142 + x2261;
  const Real x2192 = 0.9999999999932537 * x2190;
  const Real x2218 = 3.673205103346574e-06 * x2214;
  const Real x2275 = 0.08 * x2263 - x2192;
  // link 4 "forearm": force that the reference field takes
  const Real x780 = x199 * 0.037748300000000005 - x249 * 0.023998300000000004;
  // link 5 "wrist_housing": force that the reference field takes
  const Real x887 = x341 * 1.7 + x374 * 0.136;
  // joint 5 "wrist_pitch": articulated-body inertia and bias force through it
  const Real x1720 = cosine[5] * x1595 - sine[5] * x1597;
  // link 5 "wrist_housing": force that the reference field takes
  const Real x874 = x364 * 0.017 - x378 * 0.136 + x345 * 1.7;
  // joint 5 "wrist_pitch": articulated-body inertia and bias force through it
  const Real x1745 = 3.673205103346574e-06 * x1740 + 0.9999999999932537 * x1603;
  // link 5 "wrist_housing": force that the reference field takes
  const Real x888 = (x310 - x369) * 0.017 + x887;
  // joint 4 "forearm_roll": articulated-body inertia and bias force through it
  const Real x1771 = x1769 * (tau[4] - x1764);
  const Real x1825 = x861 - x350 * 0.136 + x1720 + x1665 * x1771;
  // joint 5 "wrist_pitch": articulated-body inertia and bias force through it
  const Real x1763 = x848 - x345 * 0.136 - (3.673205103346574e-06 * x1723 + x1726);
  // joint 4 "forearm_roll": articulated-body inertia and bias force through it
  const Real x1827 = x1763 + x1755 * x1771;
  // joint 5 "wrist_pitch": articulated-body inertia and bias force through it
  const Real x1765 = cosine[5] * x1599 - sine[5] * x1601 + x874;
  // joint 4 "forearm_roll": articulated-body inertia and bias force through it
  const Real x1829 = x1765 + x1758 * x1771;
  const Real x1832 = x881 - x350 * 1.7 - x1745 - x1644 * x1771;
  // joint 5 "wrist_pitch": articulated-body inertia and bias force through it
  const Real x1767 = 0.9999999999932537 * x1740 - 3.673205103346574e-06 * x1603 + x888;
  // joint 4 "forearm_roll": articulated-body inertia and bias force through it
  const Real x1834 = x1767 + x1649 * x1771;
  const Real x2028 = sine[4] * x1825 + cosine[4] * x1827;
  const Real x2045 = sine[4] * x1829 + cosine[4] * x1832;
  const Real x2042 = cosine[4] * x1829 - sine[4] * x1832;
  const Real x2049 = 0.9999999999932537 * x1834 - 3.673205103346574e-06 * x2045;
  // joint 3 "elbow_pitch": articulated-body inertia and bias force through it
  const Real x2166 = sine[3] * x2165;
  const Real x2195 = 3.673205103346574e-06 * x2190;
  const Real x2156 = cosine[3] * x2110 - sine[3] * x2123;
  const Real x2168 = x2107 + x2166;
  const Real x2260 = x2230 - 0.9999999999932537 * x2256;
  const Real x2303 = x2210 - x2218 - 0.08 * x2192 + 0.08 * x2275;
  const Real x2349 = 0.0039325 + x2303;
  require_more(w, x2349, 0.0, kFactorization, 2);
  const Real x2197 = x2172 - x2195;
  const Real x2225 = cosine[3] * x2132 + sine[3] * x2139;
  const Real x2238 = x2129 + sine[3] * x2235;
  const Real x2264 = x2241 - x2261;
  const Real x2271 = 0.08 * x2260;
  const Real x2180 = 3.673205103346574e-06 * x2168 + 0.9999999999932537 * x2156;
  const Real x2194 = x2159 - x2192;
  const Real x2207 = x2101 + sine[3] * x2204;
  const Real x2273 = x2195 - x2271;
  const Real x2169 = x2166 - x2116;
  const Real x2246 = 0.9999999999932537 * x2225 - 3.673205103346574e-06 * x2238;
  const Real x2278 = x2194 - 0.08 * x2264;
  const Real x2250 = 0.9999999999932537 * x2238 + 3.673205103346574e-06 * x2225;
  const Real x2286 = 0.9999999999932537 * x2207 - 0.08 * x2180;
  // joint 2 "upper_arm_roll": articulated-body inertia and bias force through it
  const Real x2360 = 1 / x2349;
  // link 4 "forearm": force that the reference field takes
  const Real x792 = 0.011000000000000003 * (x252 - x247) + x780 - x239 * 0.11000000000000001;
  const Real x762 = x211 * 0.03224830000000001 + x254 * 0.029498300000000005 - x260 * 0.011000000000000003;
  const Real x772 = x256 * 0.011000000000000003 - (x214 * 0.00825 + x259 * 0.005500000000000001);
  // joint 4 "forearm_roll": articulated-body inertia and bias force through it
  const Real x2066 = 0.9999999999932537 * x2028 + x2035 + 0.38 * x2042;
  const Real x2054 = 0.9999999999932537 * x2045 + 3.673205103346574e-06 * x1834;
  // joint 3 "elbow_pitch": articulated-body inertia and bias force through it
  const Real x2298 = 0.08 * x2273 - (0.9999999999932537 * x2214 + 0.08 * x2197);
  const Real x2185 = 0.9999999999932537 * x2168 - 3.673205103346574e-06 * x2156;
  const Real x2270 = 0.9999999999932537 * x2169 + 0.08 * x2246;
  // joint 4 "forearm_roll": articulated-body inertia and bias force through it
  const Real x2083 = x792 - x235 * 0.22000000000000003 - (0.08 * x2049 + x2066);
  // joint 3 "elbow_pitch": articulated-body inertia and bias force through it
  const Real x2090 = x2088 * (tau[3] - x2083);
  const Real x2279 = x2197 + x2271;
  // joint 2 "upper_arm_roll": articulated-body inertia and bias force through it
  const Real x2363 = x2286 * x2360;
  const Real x2364 = x2298 * x2360;
  const Real x2365 = x2270 * x2360;
  const Real x2366 = x2275 * x2360;
  const Real x2370 = x2113 + x2208 + 0.01132625 - x2286 * x2363;
  // joint 3 "elbow_pitch": articulated-body inertia and bias force through it
  const Real x2347 = x2218 - 0.08 * x2194 - 0.08 * x2278 + 0.01132625;
  // joint 2 "upper_arm_roll": articulated-body inertia and bias force through it
  const Real x2386 = x2347 - x2298 * x2364;
  const Real x2373 = 3.673205103346574e-06 * x2207 + 0.08 * x2185 + x2286 * x2364;
  const Real x2377 = x2120 + x2170 - x2286 * x2365;
  const Real x2380 = 0.078 - x2180 - x2286 * x2366;
  // joint 3 "elbow_pitch": articulated-body inertia and bias force through it
  const Real x2348 = -0.078 - (3.673205103346574e-06 * x2169 + 0.08 * x2250);
  // joint 2 "upper_arm_roll": articulated-body inertia and bias force through it
  const Real x2389 = x2348 - x2298 * x2365;
  const Real x2392 = x2273 - x2298 * x2366;
  const Real x2398 = x2136 + x2239 + 2.6 - x2270 * x2365;
  const Real x2407 = 2.6 + x2263 - x2275 * x2366;
  const Real x2471 = 2.0 * sine[2];
  const Real x2401 = x2246 - x2270 * x2366;
  // joint 2 "upper_arm_roll": placement, velocity and reference acceleration of its link
  const Real x157 = x93 * x94;
  // link 4 "forearm": force that the reference field takes
  const Real x799 = x247 * 0.11000000000000001 + x250 * 0.22000000000000003 + x235 * 2.2;
  const Real x807 = x239 * 2.2 - (x251 * 0.11000000000000001 + x252 * 0.22000000000000003);
  // joint 4 "forearm_roll": articulated-body inertia and bias force through it
  const Real x2058 = cosine[4] * x1825 - sine[4] * x1827 - 0.38 * x2054;
  const Real x2061 = x2031 - 3.673205103346574e-06 * x2028 - 0.08 * x2054;
  // link 4 "forearm": force that the reference field takes
  const Real x815 = x256 * 0.22000000000000003 - (x231 * 2.2 + x260 * 0.11000000000000001);
  // joint 3 "elbow_pitch": articulated-body inertia and bias force through it
  const Real x2148 = x799 + x2042 + x2076 * x2090;
  const Real x2150 = x807 + x2049 + x2077 * x2090;
  const Real x2144 = x762 - x231 * 0.22000000000000003 + x2058 + x1994 * x2090;
  const Real x2146 = x772 - x231 * 0.11000000000000001 + x2061 + x2009 * x2090;
  const Real x2152 = x815 - x2054 + x1976 * x2090;
  const Real x2327 = sine[3] * x2148 + cosine[3] * x2150;
  const Real x2310 = sine[3] * x2144 + cosine[3] * x2146;
  const Real x2332 = 3.673205103346574e-06 * x2327 + 0.9999999999932537 * x2152;
  // joint 2 "upper_arm_roll": articulated-body inertia and bias force through it
  const Real x2475 = cosine[2] * (x2370 - x2386) + x2373 * x2471;
  const Real x2367 = x2279 * x2360;
  const Real x2436 = cosine[2] * (x2377 - x2392) - sine[2] * (x2380 + x2389);
  const Real x2479 = cosine[2] * x2475;
  const Real x2503 = cosine[2] * (x2398 - x2407) - x2401 * x2471;
  const Real x2437 = sine[2] * x2436;
  const Real x2481 = x2370 - x2479;
  const Real x2507 = cosine[2] * x2503;
  const Real x2383 = x2185 - x2286 * x2367;
  const Real x2395 = x2278 - x2298 * x2367;
  const Real x2404 = x2250 - x2270 * x2367;
  const Real x2410 = x2260 - x2275 * x2367;
  const Real x2440 = x2389 + x2437;
  const Real x2485 = 3.673205103346574e-06 * x2481;
  const Real x2441 = cosine[2] * x2436;
  const Real x2509 = x2398 - x2507;
  const Real x2446 = 0.9999999999932537 * x2440;
  const Real x2489 = 3.673205103346574e-06 * x2485;
  const Real x2430 = sine[2] * x2383 + cosine[2] * x2395;
  const Real x2443 = x2377 - x2441;
  const Real x2461 = 3.673205103346574e-06 * x2443 + 0.9999999999932537 * x2430;
  const Real x2521 = 3.673205103346574e-06 * (x2509 - (2.6 + x2264 - x2279 * x2367));
  const Real x2574 = 0.3 * (x2446 + 0.3 * (x2407 + x2507));
  const Real x2517 = 3.673205103346574e-06 * (cosine[2] * x2404 - sine[2] * x2410);
  const Real x2525 = x2521 + 1.9999999999865075 * (sine[2] * x2404 + cosine[2] * x2410);
  // joint 3 "elbow_pitch": articulated-body inertia and bias force through it
  const Real x2337 = 0.9999999999932537 * x2327 - 3.673205103346574e-06 * x2152;
  const Real x2344 = 0.9999999999932537 * x2310 - x2318 - 0.08 * x2332;
  // link 3 "elbow_housing": force that the reference field takes
  const Real x722 = x111 * 0.01132625 - x157 * 0.007393749999999999 + x143 * 0.078;
  const Real x725 = x114 * 0.01132625 + x162 * 0.007393749999999999 - x139 * 0.078;
  const Real x729 = x139 * 2.6 - (x114 + x162) * 0.078;
  const Real x738 = (x89 * x89 + x148) * 0.078 - x134 * 2.6;
  // joint 2 "upper_arm_roll": articulated-body inertia and bias force through it
  const Real x2621 = x2481 - x2489 + 0.3 * x2446 + x2574 + 0.048670000000000005;
  require_more(w, x2621, 0.0, kFactorization, 1);
  const Real x2478 = sine[2] * x2475 - x2373;
  const Real x2454 = 3.673205103346574e-06 * (cosine[2] * x2383 - sine[2] * x2395);
  const Real x2456 = 0.9999999999932537 * (x2380 + x2437) - x2454;
  const Real x2534 = 0.3 * (0.9999999999932537 * (x2401 + sine[2] * x2503) - x2517);
  const Real x2362 = x2360 * (tau[2] - (x2344 - x97 * 0.0039325));
  const Real x2566 = 0.9999999999932537 * x2478 - 0.3 * (x2443 - 3.673205103346574e-06 * x2461);
  const Real x2567 = 0.3 * (x2392 + x2441 - x2534) + x2566;
  const Real x2570 = 0.9999999999932537 * x2485 + 0.3 * (3.673205103346574e-06 * x2440);
  // joint 3 "elbow_pitch": articulated-body inertia and bias force through it
  const Real x2353 = cosine[3] * x2144 - sine[3] * x2146 + x722;
  // joint 2 "upper_arm_roll": articulated-body inertia and bias force through it
  const Real x2415 = x2353 + x2286 * x2362;
  // joint 3 "elbow_pitch": articulated-body inertia and bias force through it
  const Real x2354 = x725 - (3.673205103346574e-06 * x2310 + x2313 + 0.08 * x2337);
  // joint 2 "upper_arm_roll": articulated-body inertia and bias force through it
  const Real x2417 = x2354 + x2298 * x2362;
  const Real x2554 = 0.3 * (x2456 - 0.3 * (x2509 - 3.673205103346574e-06 * x2525));
  // joint 3 "elbow_pitch": articulated-body inertia and bias force through it
  const Real x2356 = cosine[3] * x2148 - sine[3] * x2150 + x729;
  // joint 2 "upper_arm_roll": articulated-body inertia and bias force through it
  const Real x2419 = x2356 + x2270 * x2362;
  // joint 3 "elbow_pitch": articulated-body inertia and bias force through it
  const Real x2357 = x143 * 2.6 - (x157 - x111) * 0.078 - x2332;
  // joint 2 "upper_arm_roll": articulated-body inertia and bias force through it
  const Real x2421 = x2357 + x2275 * x2362;
  const Real x2584 = sine[2] * x2415 + cosine[2] * x2417;
  // joint 1 "shoulder_pitch": articulated-body inertia and bias force through it
  const Real x2633 = 1 / x2621;
  const Real x2636 = x2567 * x2633;
  const Real x2637 = x2570 * x2633;
  // joint 2 "upper_arm_roll": articulated-body inertia and bias force through it
  const Real x2618 = x2386 + x2479 - 0.3 * x2456 - x2554 + 0.048670000000000005;
  // joint 1 "shoulder_pitch": articulated-body inertia and bias force through it
  const Real x2645 = x2618 - x2567 * x2636;
  // joint 2 "upper_arm_roll": articulated-body inertia and bias force through it
  const Real x2615 = 0.3 * (cosine[2] * x2419 - sine[2] * x2421);
  const Real x2608 = 0.9999999999932537 * (sine[2] * x2419 + cosine[2] * x2421);
  const Real x2617 = 0.9999999999932537 * x2584 - x2592 + x2615;
  const Real x2611 = x2608 - 3.673205103346574e-06 * (x738 + x2337 + x2279 * x2362);
  const Real x2614 = cosine[2] * x2415 - sine[2] * x2417 - 0.3 * x2611;
  const Real x2560 = 3.673205103346574e-06 * x2478 + 0.3 * (x2430 - 0.9999999999932537 * x2461);
  // joint 1 "shoulder_pitch": articulated-body inertia and bias force through it
  const Real x2745 = cosine[1] * (x2645 - (0.00558 + x2489 - x2570 * x2637));
  const Real x2750 = x2745 - (x2567 * x2637 - x2560) * (sine[1] * 2.0);
  const Real x2756 = x2645 - cosine[1] * x2750;
  const Real x2634 = tau[1] - (x2617 - (x55 * 0.04309 + x37 * 0.31000000000000005));
  const Real x2635 = x2633 * x2634;
  // joint 2 "upper_arm_roll": articulated-body inertia and bias force through it
  const Real x2626 = 1.1170584039787268e-05 - (x30 * 0.048670000000000005 + x59 * 0.04309) + x2614;
  const Real x2627 = x32 * 0.00558 - (3.673205103346574e-06 * x2584 + x2587);
  // joint 1 "shoulder_pitch": articulated-body inertia and bias force through it
  const Real x2888 = x2756 - 3.673205103346574e-06 * (3.673205103346574e-06 * x2756) + 0.00882;
  require_more(w, x2888, 0.0, kFactorization, 0);
  const Real x2849 = sine[1] * (x2626 + x2567 * x2635);
  const Real x2856 = 0.9999999999932537 * (x2849 + cosine[1] * (x2627 - x2570 * x2635));
  // joint 0 "base_yaw": articulated-body inertia and bias force through it
  const Real x2896 = 1 / x2888 * (x2856 + x2858 + tau[0]);
  w.result[0] = x2896;
  // joint 1 "shoulder_pitch": its acceleration, and that of the link beyond
  const Real x2905 = 0.9999999999932537 * x2896;
  const Real x2909 = sine[1] * x2905;
  const Real x2911 = cosine[1] * x2905;
  const Real x2918 = x2635 + x2636 * x2909 - x2637 * x2911;
  const Real x2919 = 3.673205103346574e-06 * x2896 + x2918;
  w.result[1] = x2919;
  // joint 2 "upper_arm_roll": its acceleration, and that of the link beyond
  const Real x2921 = 0.3 * x2909;
  const Real x2940 = 0.9999999999932537 * x2921;
  const Real x2941 = 3.673205103346574e-06 * x2921;
  const Real x2920 = 0.3 * x2918;
  const Real x2926 = 3.673205103346574e-06 * x2911 + 0.9999999999932537 * x2918;
  const Real x2945 = cosine[2] * x2920 + sine[2] * x2940;
  const Real x2949 = cosine[2] * x2940 - sine[2] * x2920;
  const Real x2935 = sine[2] * x2926 - cosine[2] * x2909;
  const Real x2939 = sine[2] * x2909 + cosine[2] * x2926;
  const Real x2961 = x2362 + x2367 * x2941 - x2365 * x2945;
  // joint 3 "elbow_pitch": its acceleration, and that of the link beyond
  const Real x2971 = x2941 + 0.08 * x2939;
  // joint 2 "upper_arm_roll": its acceleration, and that of the link beyond
  const Real x2963 = x2961 - x2366 * x2949 - x2363 * x2935;
  const Real x2964 = x2963 - x2364 * x2939;
  const Real x2965 = x2964 - (0.9999999999932537 * x2911 - 3.673205103346574e-06 * x2918);
  w.result[2] = x2965;
  // joint 3 "elbow_pitch": its acceleration, and that of the link beyond
  const Real x2976 = 0.9999999999932537 * x2964 - 3.673205103346574e-06 * x2939;
  const Real x2968 = x2949 + 0.08 * x2964;
  const Real x2985 = cosine[3] * x2935 + sine[3] * x2976;
  const Real x2989 = cosine[3] * x2976 - sine[3] * x2935;
  const Real x2994 = 3.673205103346574e-06 * x2968 + 0.9999999999932537 * x2971;
  const Real x3000 = 3.673205103346574e-06 * x2971 - 0.9999999999932537 * x2968;
  const Real x3004 = cosine[3] * x2945 - sine[3] * x2994;
  const Real x3009 = sine[3] * x2945 + cosine[3] * x2994;
  const Real x3022 = x2090 - x2091 * x2985 - x2092 * x2989;
  const Real x3024 = x3022 - x2095 * x3000 - x2093 * x3004;
  const Real x3025 = x2094 * x3009 + x3024;
  const Real x3026 = 0.9999999999932537 * x2939 + 3.673205103346574e-06 * x2964 + x3025;
  w.result[3] = x3026;
  // joint 4 "forearm_roll": its acceleration, and that of the link beyond
  const Real x3039 = x3000 + 0.08 * x2989 + 0.38 * x2985;
  const Real x3044 = 3.673205103346574e-06 * x2989 + 0.9999999999932537 * x3025;
  const Real x3033 = x3009 + 0.08 * x3025;
  const Real x3030 = x3004 - 0.38 * x3025;
  const Real x3053 = cosine[4] * x2985 - sine[4] * x3044;
  const Real x3058 = sine[4] * x2985 + cosine[4] * x3044;
  const Real x3064 = 3.673205103346574e-06 * x3033 - 0.9999999999932537 * x3039;
  const Real x3069 = 0.9999999999932537 * x3033 + 3.673205103346574e-06 * x3039;
  const Real x3073 = cosine[4] * x3030 + sine[4] * x3064;
  const Real x3077 = cosine[4] * x3064 - sine[4] * x3030;
  const Real x3089 = x1771 - x1772 * x3053 + x1773 * x3058;
  const Real x3091 = x1777 * x3069 + x3089 - x1774 * x3073;
  const Real x3092 = x1775 * x3077 + x3091;
  const Real x3093 = x3092 - (0.9999999999932537 * x2989 - 3.673205103346574e-06 * x3025);
  w.result[4] = x3093;
  // joint 5 "wrist_pitch": its acceleration, and that of the link beyond
  const Real x3114 = 3.673205103346574e-06 * x3077 + 0.9999999999932537 * x3069;
  const Real x3120 = 3.673205103346574e-06 * x3069 - 0.9999999999932537 * x3077;
  const Real x3124 = cosine[5] * x3073 - sine[5] * x3114;
  const Real x3129 = sine[5] * x3073 + cosine[5] * x3114;
  const Real x3097 = 3.673205103346574e-06 * x3058 + 0.9999999999932537 * x3092;
  const Real x3142 = x1539 - x1544 * x3120 - x1542 * x3124;
  const Real x3105 = cosine[5] * x3053 + sine[5] * x3097;
  const Real x3109 = cosine[5] * x3097 - sine[5] * x3053;
  const Real x3144 = x1543 * x3129 + x3142 - x1540 * x3105;
  const Real x3145 = x3144 - x1541 * x3109;
  const Real x3146 = x3145 - (0.9999999999932537 * x3058 - 3.673205103346574e-06 * x3092);
  w.result[5] = x3146;
  // joint 6 "flange_roll": its acceleration, and that of the link beyond
  const Real x3157 = 0.9999999999932537 * x3145 - 3.673205103346574e-06 * x3109;
  const Real x3173 = 0.9999999999932537 * (x3120 - 0.09 * x3109);
  const Real x3174 = x3173 - 3.673205103346574e-06 * (0.09 * x3145 - x3129);
  const Real x3166 = cosine[6] * x3105 + sine[6] * x3157;
  const Real x3170 = cosine[6] * x3157 - sine[6] * x3105;
  const Real x3183 = cosine[6] * x3124 + sine[6] * x3174;
  const Real x3187 = cosine[6] * x3174 - sine[6] * x3124;
  const Real x3197 = x1302 - x1303 * x3166 - x1304 * x3170;
  const Real x3199 = x3197 - x1305 * x3183 - x1306 * x3187;
  const Real x3200 = 0.9999999999932537 * x3109 + 3.673205103346574e-06 * x3145 + x3199;
  w.result[6] = x3200;
  // joints 7 "left_finger_slide", 8 "right_finger_slide": their accelerations, and those of the links beyond
  const Two x3232 = Two{1.0, -0.9999999999964793} * (x3187 - 0.13 * x3166 - x569 * x3199);
  const Two x3230 = Two{0.0, 2.65358979335273e-06} * (x3183 + 0.13 * x3170 - x571 * x3199);
  const Two x3236 = x1114 + 0.03 * (Two{1.0, -0.9999999999964793} * x3166 + Two{0.0, 2.65358979335273e-06} * x3170);
  const Two x3237 = x3236 - (x3232 - x3230);
  put(x3237, w.lanes.data() + 0);
}

// ---- 5. processes -------------------------------------------------------------------------------

// Process 0: 9 of 9 joints: "base_yaw", "shoulder_pitch", "upper_arm_roll", "elbow_pitch", "forearm_roll", "wrist_pitch", ...
constexpr std::array<int, 9> kRead_0{0, 1, 2, 3, 4, 5, 6, 7, 8};
constexpr std::array<int, 9> kOwned_0{0, 1, 2, 3, 4, 5, 6, 7, 8};
constexpr std::array<int, 7> kAngles_0{0, 1, 2, 3, 4, 5, 6};

void run_0([[maybe_unused]] Workspace& w, [[maybe_unused]] Channel& channel) {
  ADAGEN_INPUTS
  stamp(0);
  if (!all(unlike_zero(q + 0, 1) == 0))
    name_what_is_not_finite(w, kRead_0, kOwned_0);
  take_sines_and_cosines(q, kAngles_0, w.sine.data(), w.cosine.data());
  part_0_0(w);
  part_0_1(w);
  stamp(1);
  stamp(2);
  stamp(3);
  if (__builtin_expect(w.status != kFine || !all(unlike_zero(w.result.data() + 0, 7) + unlike_zero<Two, 1>(w.lanes.data() + 0) == 0), 0)) {
    // The state's own faults are named before all others.
    const int found = std::exchange(w.status, kFine);
    name_what_is_not_finite(w, kRead_0, kOwned_0);
    Channel::fail(w.status, found);
    w.result[7] = w.lanes[0];
    w.result[8] = w.lanes[1];
    name_what_overflows(w, kOwned_0);
  }
  if (w.status != kFine) return;
  std::copy_n(w.result.data() + 0, 7, w.qdd + 0);
  w.qdd[7] = w.lanes[0];
  w.qdd[8] = w.lanes[1];
}

[[maybe_unused]] constexpr std::array<void (*)(Workspace&, Channel&), kProcesses> kRun{run_0};

// What each process reads of q and v, the velocity entries whose qdd is its own, and whose tau it
// reads.
constexpr std::array<Range, 1> kReadQ_0{ {{0, 9}} };
constexpr std::array<Range, 1> kReadV_0{ {{0, 9}} };
constexpr std::array<Range, 1> kOwn_0{ {{0, 9}} };
constexpr std::array<Range, 1> kTorque_0{ {{0, 9}} };
[[maybe_unused]] constexpr std::array<ProcessInfo, kProcesses> kProcess{ {
    {{1, kReadQ_0.data()}, {1, kReadV_0.data()}, {1, kOwn_0.data()}, {1, kTorque_0.data()}},
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
  Text text;  // of the last failure

  // State and result in place: reads what this process needs, writes what it owns.
  int solve(const Number* q, const Number* v, const Number* tau, Number* qdd) {
    if (kAlone && kProcesses > 1 && channel.rank() != 0) return finish(kFine);
    if (channel.broken()) return finish(failure(kNoAnswer, 0));
    prepare(q, v, tau, qdd);
    run();
    return finish(w.status);
  }

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

  // A pose that the first try cannot stand is known to all processes: they try again together.
  void run() {
    const std::size_t rank = kAlone ? 0 : static_cast<std::size_t>(channel.rank());
    kRun[rank](w, channel);
#ifdef ADAGEN_RECOVERS
    if (failure_kind(w.status) != kSingularPose) return;
    w.status = kFine;
    kRecover[rank](w, channel);
#endif
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

static_assert(ARM7_UNROLLED_P1_NQ == kNq && ARM7_UNROLLED_P1_NV == kNv && ARM7_UNROLLED_P1_NTAU == kNtau);
static_assert(int(ARM7_UNROLLED_P1_FINE) == int(kFine));
static_assert(int(ARM7_UNROLLED_P1_NOT_FINITE) == int(kNotFinite));
static_assert(int(ARM7_UNROLLED_P1_ZERO_QUATERNION) == int(kZeroQuaternion));
static_assert(int(ARM7_UNROLLED_P1_FACTORIZATION) == int(kFactorization));
static_assert(int(ARM7_UNROLLED_P1_OVERFLOW) == int(kOverflow));
static_assert(int(ARM7_UNROLLED_P1_NO_ANSWER) == int(kNoAnswer));
static_assert(int(ARM7_UNROLLED_P1_ENDED) == int(kEnded));
static_assert(int(ARM7_UNROLLED_P1_NOT_REFINED) == int(kNotRefined));
static_assert(int(ARM7_UNROLLED_P1_GIMBAL_LOCK) == int(kGimbalLock));
static_assert(int(ARM7_UNROLLED_P1_GROWTH) == int(kGrowth));
static_assert(int(ARM7_UNROLLED_P1_TOO_FEW_STEPS) == int(kTooFewSteps));

struct arm7_unrolled_p1_solver : Solver {};

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

int arm7_unrolled_p1_joint(int k, const char** name, int* q, int* nq, int* v, int* nv) {
  if (k < 0 || k >= kJointCount) return 0;
  const JointConstants& joint = kJoints[k];
  *name = joint.name, *q = joint.q, *nq = joint.nq, *v = joint.v, *nv = joint.nv;
  return 1;
}

arm7_unrolled_p1_solver* arm7_unrolled_p1_open(void) { return opened<arm7_unrolled_p1_solver>(); }

int arm7_unrolled_p1_solve(arm7_unrolled_p1_solver* solver, const double* q, const double* v, const double* tau, double* qdd) {
  return solver->solve(q, v, tau, qdd);
}

int arm7_unrolled_p1_reason(int status) { return failure_kind(status); }

int arm7_unrolled_p1_failed_joint(int status) { return is_of_joint(failure_kind(status)) ? failure_place(status) : -1; }

const char* arm7_unrolled_p1_failure(const arm7_unrolled_p1_solver* solver) {
  return solver == nullptr ? open_failure.c_str() : solver->text.c_str();
}

void arm7_unrolled_p1_close(arm7_unrolled_p1_solver* solver) {
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

// What the program asks of MPI, for one process without it: there is nobody else. A launcher's word
// is taken for how many were started, so that none of several goes on by itself.
using MPI_Comm = int;
using MPI_Datatype = std::size_t;  // its size
using MPI_Aint = std::ptrdiff_t;
using MPI_Request = int;
struct MPI_Status {};
constexpr MPI_Comm MPI_COMM_WORLD = 0;
constexpr MPI_Datatype MPI_BYTE = 1, MPI_INT = sizeof(int), MPI_DOUBLE = sizeof(double),
                       MPI_LONG_LONG = sizeof(long long), kMpiNumber = sizeof(Number);
constexpr int MPI_MAX = 0, MPI_MIN = 0, MPI_SUM = 0, MPI_BOR = 0, MPI_COMM_TYPE_SHARED = 0,
              MPI_INFO_NULL = 0;
constexpr std::nullptr_t MPI_IN_PLACE = nullptr, MPI_STATUS_IGNORE = nullptr;

int of_launcher(std::initializer_list<const char*> names, int alone) {
  for (const char* const name : names)
    if (const char* const said = std::getenv(name)) return std::atoi(said);
  return alone;
}

inline void MPI_Init(int*, char***) {}
inline void MPI_Finalize() {}
inline void MPI_Comm_rank(MPI_Comm, int* rank) {
  *rank = of_launcher({"OMPI_COMM_WORLD_RANK", "PMI_RANK"}, 0);
}
inline void MPI_Comm_size(MPI_Comm, int* size) {
  *size = of_launcher({"OMPI_COMM_WORLD_SIZE", "PMI_SIZE"}, 1);
}
inline void MPI_Comm_split_type(MPI_Comm, int, int, int, MPI_Comm* node) { *node = 0; }
inline void MPI_Comm_free(MPI_Comm*) {}
[[noreturn]] inline void MPI_Abort(MPI_Comm, int status) { std::_Exit(status); }
inline void MPI_Barrier(MPI_Comm) {}
inline void MPI_Ibarrier(MPI_Comm, MPI_Request*) {}
inline void MPI_Test(MPI_Request*, int* done, std::nullptr_t) { *done = 1; }
inline void MPI_Bcast(void*, int, MPI_Datatype, int, MPI_Comm) {}
inline void MPI_Allreduce(const void* from, void* to, int count, MPI_Datatype size, int, MPI_Comm) {
  if (from != nullptr) std::memcpy(to, from, static_cast<std::size_t>(count) * size);
}
inline void MPI_Reduce(const void*, void*, int, MPI_Datatype, int, int, MPI_Comm) {}
inline void MPI_Send(const void*, int, MPI_Datatype, int, int, MPI_Comm) {}
inline void MPI_Recv(void*, int, MPI_Datatype, int, int, MPI_Comm, std::nullptr_t) {}
inline void MPI_Probe(int, int, MPI_Comm, MPI_Status*) {}
inline void MPI_Get_count(const MPI_Status*, MPI_Datatype, int*) {}

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
constexpr std::array<const Stage*, kProcesses> kStages{kStages_0.data()};
constexpr std::array<int, kProcesses> kStageCount{3};

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
      std::fprintf(stderr, "error: this solver is for exactly 1 process, started with %d: start it without mpiexec\n",
                   size);
  } else if (options.help) {
    if (rank == 0) std::printf("usage: %s [options]\n%s", words[0], kUsageText);
  } else {
    status = std::make_unique<Program>(options, rank)->run();
  }
  MPI_Finalize();
  return status;
}
#endif  // ADAGEN_NO_MAIN
