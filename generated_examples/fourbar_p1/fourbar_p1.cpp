// Forward dynamics of "fourbar" on 1 process, emitted by adagen 0.1.0 (solver.cpp.j2). Do not edit: emit anew.
//
// robot     "fourbar", 3 joints, 3 degrees of freedom, description sha256 4800d9bbec7e9c8eaf1d028c5dcc2b2c9b4ac7410509da822ae29051a7391834
// command   adagen ../models/fourbar.urdf --scene=../models/fourbar.toml --procs 1
// options   form segment, shape unrolled, scalar double, channel auto, fixed base, gravity 0.0, 0.0, -9.81
// links     adagen_program.cpp
// program   1 process; 0.0807 us predicted (default profile)
//           process 0: crank_pin .. rocker_pin
// licence   yours to choose: what adagen emits belongs to whoever emits it
//
// The articulated-body algorithm: I^A and p^A (IA, pA), a link's inertia and bias force with all that
// hangs on it, are swept to the base, and the accelerations come back. Where loops are closed,
// accelerations of their joints and the constraint forces are held back as unknowns, and eliminated at
// the last link that the joints have in common (docs/loops.md). Spatial vectors are [angular; linear], in
// link frames turned so that every joint axis is z.
//
// How to read on:
//   1. interface   what a program that links this file calls
//   2. model       the robot's constants
//   3. runtime     spatial algebra, joints, exchange between processes
//   4. joints      for each joint its memory, then what is done with it, step by step
//   5. processes   who does what, in order
//   6. program     what the program around it, adagen_program.cpp, is told; main

// ---- 1. interface -------------------------------------------------------------------------------
// To use it from a program of yours: compile this file with -DADAGEN_NO_MAIN and link it; fourbar_p1.h
// beside it is this part.
// C interface of the solver fourbar_p1: forward dynamics of "fourbar" on 1 process,
// emitted by adagen 0.1.0 (interface.h.j2). Do not edit: emit anew.
#ifndef ADAGEN_FOURBAR_P1_H
#define ADAGEN_FOURBAR_P1_H

enum {
  FOURBAR_P1_PROCESSES = 1,
  FOURBAR_P1_JOINTS = 3,
  FOURBAR_P1_NQ = 3,  // numbers in q
  FOURBAR_P1_NV = 3,  // in v and qdd
  FOURBAR_P1_NTAU = 3  // in tau
};

// Where each joint begins in q, and in v, tau and qdd.
enum {
  FOURBAR_P1_Q_crank_pin = 0,
  FOURBAR_P1_V_crank_pin = 0,  // joint 0, "crank_pin": revolute, 1 in q, 1 in v
  FOURBAR_P1_Q_coupler_pin = 1,
  FOURBAR_P1_V_coupler_pin = 1,  // joint 1, "coupler_pin": revolute, 1 in q, 1 in v
  FOURBAR_P1_Q_rocker_pin = 2,
  FOURBAR_P1_V_rocker_pin = 2  // joint 2, "rocker_pin": revolute, 1 in q, 1 in v
};

// Why a call failed, as fourbar_p1_reason tells of the status that it returned.
enum {
  FOURBAR_P1_FINE = 0,  // none
  FOURBAR_P1_NOT_FINITE = 1,  // q, v or tau of a joint is not a finite number
  FOURBAR_P1_ZERO_QUATERNION = 2,  // a joint's quaternion cannot be normalised
  FOURBAR_P1_FACTORIZATION = 3,  // inertias beside a joint differ too much for the scalar
  FOURBAR_P1_OVERFLOW = 4,  // a joint's acceleration is not a finite number
  FOURBAR_P1_NO_ANSWER = 5,  // a process did not answer within the time limit
  FOURBAR_P1_ENDED = 6,  // process 0 has ended the evaluations
  FOURBAR_P1_NOT_REFINED = 7,  // refinement does not converge
  FOURBAR_P1_GIMBAL_LOCK = 8,  // joints that are joined as one do not move in as many directions
  FOURBAR_P1_GROWTH = 9,  // a link beside a joint is too light for its neighbours
  FOURBAR_P1_NOT_SET = 16,  // what is to be set at run time is not finite, or is no mass
  FOURBAR_P1_TOO_FEW_STEPS = 11,  // refinement converges too slowly
  FOURBAR_P1_LOOP_OPEN = 12,  // a loop or coupling is not closed in this configuration
  FOURBAR_P1_LOOP_TORN = 13,  // this velocity tears a loop or coupling open
  FOURBAR_P1_LOOP_SINGULAR = 14,  // what a loop holds changes in this pose
  FOURBAR_P1_LOOP_FREE = 15  // loops leave a joint a motion that no inertia resists
};

#ifdef __cplusplus
extern "C" {
#endif
typedef struct fourbar_p1_solver fourbar_p1_solver;

// Joints in order, each with its place in the state: gives name, start and size in q and v of joint
// k, or returns 0 where there is none.
int fourbar_p1_joint(int k, const char** name, int* q, int* nq, int* v, int* nv);

// A solver, with all the memory that it will ever need: no other call allocates, waits or takes a
// lock. One solver is for one thread at a time. Returns null where there is no memory;
// fourbar_p1_failure(NULL) says so.
fourbar_p1_solver* fourbar_p1_open(void);

// One evaluation. q: 3 numbers, v and tau: 3 each, qdd: 3; joints in order, quaternions
// x y z w (normalised here), floating joints [linear; angular] in the body's frame.
// Returns 0, or a status that fourbar_p1_failure puts into words; no acceleration is written then.
int fourbar_p1_solve(fourbar_p1_solver* solver, const double* q, const double* v, const double* tau, double* qdd);

// What a status says: its reason, and which joint it is about, -1 for none.
int fourbar_p1_reason(int status);
int fourbar_p1_failed_joint(int status);

// The last failure of a solver in words, valid until the next call; of null, why the last open of this
// thread returned null.
const char* fourbar_p1_failure(const fourbar_p1_solver* solver);

void fourbar_p1_close(fourbar_p1_solver* solver);
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
constexpr int kJointCount = 3, kLinkCount = kJointCount + 1;
constexpr int kNq = 3, kNv = 3;
constexpr int kOuterCount = 0, kNtau = kNv + 6 * kOuterCount;
constexpr int kNqdd = 3;
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
    {"ground", 0.0, {0.0, 0.0, 0.0},
     {0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0},
     {}},
    {"crank", 0.4, {0.0, 0.1, 0.0},
     {0.00136333, 0.0, 0.0, 0.0, 6e-05, 0.0, 0.0, 0.0, 0.00136333},
     {}},
    {"coupler", 1.0, {0.0, 0.25, 0.0},
     {0.0209083, 0.0, 0.0, 0.0, 0.00015, 0.0, 0.0, 0.0, 0.0209083},
     {}},
    {"rocker", 0.8, {0.0, 0.2, 0.0},
     {0.0107267, 0.0, 0.0, 0.0, 0.00012, 0.0, 0.0, 0.0, 0.0107267},
     {}},
} };

constexpr std::array<JointConstants, kJointCount> kJoints{ {
    {"crank_pin", JointKind::kRevolute, 0, 0, 1, 0, 1,
     {0.0, 1.0, 0.0, 0.0, 0.0, 1.0, 1.0, 0.0, 0.0},
     {0.0, 0.0, 0.0}, -1, 0.0, 0.0},
    {"coupler_pin", JointKind::kRevolute, 1, 1, 1, 1, 1,
     {1.0, 0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 1.0},
     {0.0, 0.2, 0.0}, -1, 0.0, 0.0},
    {"rocker_pin", JointKind::kRevolute, 0, 2, 1, 2, 1,
     {0.0, 1.0, 0.0, 0.0, 0.0, 1.0, 1.0, 0.0, 0.0},
     {0.45, 0.0, 0.0}, -1, 0.0, 0.0},
} };

[[maybe_unused]] constexpr std::array<OuterForce, kOuterCount> kOuterForces{};

// Loops, then couplings: what statuses name them by.
#define ADAGEN_LOOPS
constexpr int kLoopCount = 1;
constexpr std::array<const char*, 1> kLoopNames{ {
    "pin",
} };

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
  alignas(kCacheLine) std::array<Value, 3> angle{}, sine{}, cosine{};
  std::array<Value, kNqdd> result{};
  std::array<Real*, kPlanMessages> to{};          // messages to be sent
  std::array<const Real*, kPlanMessages> from{};  // messages received
  alignas(kCacheLine) std::array<Value, 0> x{};
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

// Tangents are those of a double, so that they are the same wherever the C library is.
[[maybe_unused]] inline Real tanh_of(Real x) { return Real(std::tanh(double(x))); }

// What straight lines call beside sums, products and quotients.
[[maybe_unused]] inline Real sqrt_of(Real x) { return std::sqrt(x); }
[[maybe_unused]] inline Real sign_of(Real x) { return std::copysign(Real(1), x); }
[[maybe_unused]] inline Real max_of(Real x, Real y) { return x > y ? x : y; }

// Each function is a straight line. A value is called x and its number in the expression graph; zeros
// and constants are folded in, nothing is computed twice, and what nobody needs is not there.
// Frames are the links' own; accelerations are deviations from the field that the links would have
// with all joint accelerations zero.

// =================================================================================================
// Process 0: 115 products, 70 sums, 4 quotients
// =================================================================================================

ADAGEN_NOINLINE void part_0_0(Workspace& w) {
  ADAGEN_INPUTS
  // joint 0 "crank_pin": placement, velocity and reference acceleration of its link
  const Real x11 = v[0] * v[0];
  const Real x8 = cosine[0] * 9.81;
  // joint 1 "coupler_pin": placement, velocity and reference acceleration of its link
  const Real x19 = v[0] + v[1];
  const Real x36 = x19 * x19;
  const Real x22 = sine[0] * 9.81 + x11 * 0.2;
  const Real x32 = x8 * sine[1] + cosine[1] * x22;
  const Real x27 = x8 * cosine[1] - sine[1] * x22;
  // joint 2 "rocker_pin": placement, velocity and reference acceleration of its link
  const Real x47 = v[2] * v[2];
  const Real x44 = 9.81 * cosine[2];
  // link 2 "coupler": force that the reference field takes
  const Real x76 = x27 * 0.25;
  // what a loop holds its two links by
  const Real x130 = v[0] * 0.2;
  const Real x124 = v[2] * 0.4;
  const Real x166 = cosine[0] * cosine[1] - sine[0] * sine[1];
  const Real x134 = sine[1] * x130;
  const Real x169 = sine[0] * cosine[1] + cosine[0] * sine[1];
  const Real x203 = 9.81 * sine[2] + x47 * 0.4;
  const Real x138 = cosine[1] * x130 + x19 * 0.5;
  const Real x189 = cosine[2] * x166 + sine[2] * x169;
  const Real x193 = cosine[2] * x169 - sine[2] * x166;
  const Real x105 = sine[1] * 0.5;
  const Real x108 = 0.2 + cosine[1] * 0.5;
  const Real x144 = cosine[1] * x138 + sine[1] * x134;
  const Real x219 = x44 * x193 + x189 * x203;
  const Real x149 = cosine[1] * x134 - sine[1] * x138;
  // joint 1 "coupler_pin": inertia and bias force of what is beyond, its own motion left open
  const Real x230 = cosine[1] * 0.25;
  const Real x236 = 0.0834083 + 0.2 * x230;
  // link 0 "ground": accelerations and constraint forces of loops below it are eliminated
  const Real x291 = sine[1] * 0.2 * 4.0;
  const Real x288 = 2.0 * (0.5 + cosine[1] * 0.2);
  const Real x298 = x291 * x291;
  const Real x289 = 2.0 * (0.4 * x189);
  const Real x293 = 0.4 * x193 * 4.0;
  const Real x294 = 2.0 * (x44 * x189 - x193 * x203 - x27);
  // what a loop holds its two links by
  const Real x120 = cosine[0] * x105 + sine[0] * x108 - sine[2] * 0.4;
  const Real x118 = cosine[0] * x108 - sine[0] * x105;
  const Real x119 = 0.45 + cosine[2] * 0.4 - x118;
  const Real x162 = cosine[0] * x144 + sine[0] * x149 - cosine[2] * x124;
  const Real x160 = cosine[0] * x149 - sine[0] * x144 + sine[2] * x124;
  const Real x185 = 1e-08 - (x119 * x119 + x120 * x120);
  require_more(w, x185, 0.0, kLoopOpen, 3);
  const Real x183 = (x11 + v[1] * v[1] + x47 + 1.0) * 1e-06;
  const Real x186 = x183 - (x160 * x160 + x162 * x162);
  require_more(w, x186, 0.0, kLoopTorn, 3);
  // joint 1 "coupler_pin": inertia and bias force of what is beyond, its own motion left open
  const Real x271 = cosine[1] * x27 + sine[1] * (x32 + x36 * 0.25);
  // link 0 "ground": accelerations and constraint forces of loops below it are eliminated
  const Real x295 = (x32 + x36 * 0.5 - x219) * 4.0;
  const Real x302 = sign_of(x288) * sqrt_of(x288 * x288 + x298);
  const Real x303 = x288 + x302;
  const Real x341 = 1 / x302;
  const Real x355 = x302 * x302;
  require_more(w, x355, 9.999999999999998e-15, kSingularPose, 3);
  const Real x305 = x298 + x303 * x303;
  const Real x307 = 2.0 * (1 / x305);
  const Real x314 = x307 * (x289 * x303 + x291 * x293);
  const Real x322 = x303 * x307;
  const Real x331 = x307 * (x294 * x303 - x291 * x295);
  const Real x321 = x293 - x291 * x314;
  const Real x320 = x303 * x314 - x289;
  const Real x338 = 1 / x321;
  const Real x358 = x321 * x321;
  require_more(w, x358, 9.999999999999998e-15, kSingularPose, 3);
  const Real x339 = x291 * x322 * x338;
  const Real x340 = (x295 + x291 * x331) * x338;
  const Real x366 = 0.042726700000000006 * x339;
  const Real x346 = x341 * (1.0 - x303 * x322 - x320 * x339);
  const Real x351 = x341 * (x294 - x303 * x331 - x320 * x340);
  // joint 0 "crank_pin": inertia and bias force of what is beyond, its own motion left open
  const Real x285 = x76 + 0.2 * x271 + x8 * 0.04000000000000001 + tau[0];
  // link 0 "ground": accelerations and constraint forces of loops below it are eliminated
  const Real x365 = (x236 - 0.2 * (-0.2 - x230) + 0.00536333) * x346;
  const Real x368 = x236 + x365;
  const Real x380 = (x44 * 0.16000000000000003 + tau[2]) * x339 - x285 * x346;
  const Real x364 = 40000.0 - (x346 * x346 + x339 * x339);
  require_more(w, x364, 0.0, kSingularPose, 3);
  const Real x385 = x351 * x368 + x340 * x366;
  const Real x373 = x346 * x368 + x339 * x366 + 0.0834083;
  const Real x375 = x373 + x236 * x346;
  require_more(w, x375, 0.0, kLoopFree, 1);
  const Real x388 = (x380 - (x76 + tau[1]) + x385) * (1 / x375);
  const Real x389 = -x388;
  w.result[1] = x389;
  // link 0 "ground": accelerations and constraint forces of loops below it
  const Real x394 = x351 - x346 * x388;
  w.result[0] = x394;
  const Real x395 = x339 * x388 - x340;
  w.result[2] = x395;
}

// =================================================================================================
// Process 0 in a singular pose: 129 products, 80 sums, 5 quotients
// =================================================================================================

ADAGEN_NOINLINE void part_1_0(Workspace& w) {
  ADAGEN_INPUTS
  // joint 0 "crank_pin": placement, velocity and reference acceleration of its link
  const Real x11 = v[0] * v[0];
  const Real x8 = cosine[0] * 9.81;
  // joint 1 "coupler_pin": placement, velocity and reference acceleration of its link
  const Real x19 = v[0] + v[1];
  const Real x36 = x19 * x19;
  const Real x22 = sine[0] * 9.81 + x11 * 0.2;
  const Real x27 = x8 * cosine[1] - sine[1] * x22;
  const Real x32 = x8 * sine[1] + cosine[1] * x22;
  // joint 2 "rocker_pin": placement, velocity and reference acceleration of its link
  const Real x47 = v[2] * v[2];
  const Real x44 = 9.81 * cosine[2];
  // link 2 "coupler": force that the reference field takes
  const Real x76 = x27 * 0.25;
  // what a loop holds its two links by
  const Real x130 = v[0] * 0.2;
  const Real x124 = v[2] * 0.4;
  const Real x166 = cosine[0] * cosine[1] - sine[0] * sine[1];
  const Real x134 = sine[1] * x130;
  const Real x169 = sine[0] * cosine[1] + cosine[0] * sine[1];
  const Real x203 = 9.81 * sine[2] + x47 * 0.4;
  const Real x138 = cosine[1] * x130 + x19 * 0.5;
  const Real x189 = cosine[2] * x166 + sine[2] * x169;
  const Real x193 = cosine[2] * x169 - sine[2] * x166;
  const Real x105 = sine[1] * 0.5;
  const Real x108 = 0.2 + cosine[1] * 0.5;
  const Real x144 = cosine[1] * x138 + sine[1] * x134;
  const Real x149 = cosine[1] * x134 - sine[1] * x138;
  const Real x219 = x44 * x193 + x189 * x203;
  // joint 1 "coupler_pin": inertia and bias force of what is beyond, its own motion left open
  const Real x230 = cosine[1] * 0.25;
  const Real x236 = 0.0834083 + 0.2 * x230;
  // link 0 "ground": accelerations and constraint forces of loops below it are eliminated
  const Real x291 = sine[1] * 0.2 * 4.0;
  const Real x288 = 2.0 * (0.5 + cosine[1] * 0.2);
  const Real x289 = 2.0 * (0.4 * x189);
  const Real x293 = 0.4 * x193 * 4.0;
  const Real x296 = x289 * x289;
  // what a loop holds its two links by
  const Real x120 = cosine[0] * x105 + sine[0] * x108 - sine[2] * 0.4;
  const Real x118 = cosine[0] * x108 - sine[0] * x105;
  const Real x119 = 0.45 + cosine[2] * 0.4 - x118;
  const Real x162 = cosine[0] * x144 + sine[0] * x149 - cosine[2] * x124;
  const Real x160 = cosine[0] * x149 - sine[0] * x144 + sine[2] * x124;
  const Real x185 = 1e-08 - (x119 * x119 + x120 * x120);
  require_more(w, x185, 0.0, kLoopOpen, 3);
  const Real x183 = (x11 + v[1] * v[1] + x47 + 1.0) * 1e-06;
  const Real x186 = x183 - (x160 * x160 + x162 * x162);
  require_more(w, x186, 0.0, kLoopTorn, 3);
  // joint 1 "coupler_pin": inertia and bias force of what is beyond, its own motion left open
  const Real x271 = cosine[1] * x27 + sine[1] * (x32 + x36 * 0.25);
  // link 0 "ground": accelerations and constraint forces of loops below it are eliminated
  const Real x301 = sign_of(x288) * sqrt_of(1.0 + x288 * x288 + x296);
  const Real x302 = x288 + x301;
  const Real x335 = x301 * x301;
  require_more(w, x335, 9.999999999999998e-15, kLoopSingular, 3);
  const Real x305 = 1.0 + x296 + x302 * x302;
  const Real x340 = 2.0 * (x44 * x189 - x193 * x203 - x27);
  const Real x346 = x340 * (1 / x301);
  const Real x307 = 2.0 * (1 / x305);
  const Real x314 = x307 * (x291 * x302 + x289 * x293);
  const Real x321 = x293 - x289 * x314;
  const Real x325 = x321 * x321;
  const Real x341 = (x32 + x36 * 0.5 - x219) * 4.0;
  const Real x328 = sign_of(x314) * sqrt_of(x314 * x314 + x325);
  const Real x329 = x314 + x328;
  const Real x338 = x328 * x328;
  require_more(w, x338, 9.999999999999998e-15, kLoopSingular, 3);
  const Real x331 = x325 + x329 * x329;
  const Real x354 = 1 / x328 * (x341 + (x302 * x314 - x291) * x346);
  const Real x333 = 2.0 * (1 / x331);
  const Real x356 = x321 * x333;
  const Real x362 = x333 * (x329 * x354);
  const Real x357 = x329 * x356;
  const Real x364 = x321 * x362;
  const Real x360 = 1.0 - x321 * x356;
  const Real x365 = x354 - x329 * x362;
  const Real x371 = x307 * (x357 + x289 * x360);
  const Real x384 = x307 * (x365 + x302 * x346 + x289 * x364);
  const Real x373 = x302 * x371;
  const Real x377 = x371 - x357;
  const Real x389 = x365 - x384;
  const Real x378 = x360 - x289 * x371;
  const Real x388 = x346 - x302 * x384;
  const Real x390 = x289 * x384 - x364;
  // joint 0 "crank_pin": inertia and bias force of what is beyond, its own motion left open
  const Real x285 = x76 + 0.2 * x271 + x8 * 0.04000000000000001 + tau[0];
  // link 0 "ground": accelerations and constraint forces of loops below it are eliminated
  const Real x391 = (x236 - 0.2 * (-0.2 - x230) + 0.00536333) * x373;
  const Real x393 = x391 + x236 * x377;
  const Real x396 = x236 * x373 + 0.0834083 * x377;
  const Real x397 = 0.042726700000000006 * x378;
  const Real x404 = x285 * x373 + (x76 + tau[1]) * x377;
  const Real x418 = x373 * x393 + x377 * x396 + x378 * x397;
  require_more(w, x418, 0.0, kLoopFree, 0);
  const Real x412 = x388 * x393 + x389 * x396 + x390 * x397;
  const Real x413 = x412 - ((x44 * 0.16000000000000003 + tau[2]) * x378 + x404);
  const Real x420 = x413 * (1 / x418);
  // link 0 "ground": accelerations and constraint forces of loops below it
  const Real x428 = x388 - x373 * x420;
  w.result[0] = x428;
  const Real x429 = x389 - x377 * x420;
  w.result[1] = x429;
  const Real x430 = x390 - x378 * x420;
  w.result[2] = x430;
}

// ---- 5. processes -------------------------------------------------------------------------------

// Process 0: 3 of 3 joints: "crank_pin", "coupler_pin", "rocker_pin"; all of them in a singular pose
constexpr std::array<int, 3> kRead_0{0, 1, 2};
constexpr std::array<int, 3> kOwned_0{0, 1, 2};

void run_0([[maybe_unused]] Workspace& w, [[maybe_unused]] Channel& channel) {
  ADAGEN_INPUTS
  stamp(0);
  take_sines_and_cosines<3>(q + 0, w.sine.data(), w.cosine.data());
  part_0_0(w);
  stamp(1);
  stamp(2);
  stamp(3);
  if (__builtin_expect(w.status != kFine || !all(unlike_zero(w.result.data() + 0, 3) == 0), 0)) {
    // The state's own faults are named before all others.
    const int found = std::exchange(w.status, kFine);
    name_what_is_not_finite(w, kRead_0, kOwned_0);
    Channel::fail(w.status, found);
    name_what_overflows(w, kOwned_0);
  }
  if (w.status != kFine) return;
  std::copy_n(w.result.data() + 0, 3, w.qdd + 0);
}


// What is done instead in a pose in which a mobility cannot be taken for an inertia.
void recover_0([[maybe_unused]] Workspace& w, [[maybe_unused]] Channel& channel) {
  ADAGEN_INPUTS
  stamp(0);
  take_sines_and_cosines<3>(q + 0, w.sine.data(), w.cosine.data());
  part_1_0(w);
  stamp(1);
  stamp(2);
  stamp(3);
  if (__builtin_expect(w.status != kFine || !all(unlike_zero(w.result.data() + 0, 3) == 0), 0)) {
    // The state's own faults are named before all others.
    const int found = std::exchange(w.status, kFine);
    name_what_is_not_finite(w, kRead_0, kOwned_0);
    Channel::fail(w.status, found);
    name_what_overflows(w, kOwned_0);
  }
  if (w.status != kFine) return;
  std::copy_n(w.result.data() + 0, 3, w.qdd + 0);
}

[[maybe_unused]] constexpr std::array<void (*)(Workspace&, Channel&), kProcesses> kRun{run_0};
constexpr std::array<void (*)(Workspace&, Channel&), 1> kRecover{recover_0};

// What each process reads of q and v, the velocity entries whose qdd is its own, and whose tau it
// reads.
constexpr std::array<Range, 1> kReadQ_0{ {{0, 3}} };
constexpr std::array<Range, 1> kReadV_0{ {{0, 3}} };
constexpr std::array<Range, 1> kOwn_0{ {{0, 3}} };
constexpr std::array<Range, 1> kTorque_0{ {{0, 3}} };
[[maybe_unused]] constexpr std::array<ProcessInfo, kProcesses> kProcess{ {
    {{1, kReadQ_0.data()}, {1, kReadV_0.data()}, {1, kOwn_0.data()}, {1, kTorque_0.data()}},
} };

#define ADAGEN_RECOVERS  // the processes can do otherwise in a singular pose

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

static_assert(FOURBAR_P1_NQ == kNq && FOURBAR_P1_NV == kNv && FOURBAR_P1_NTAU == kNtau);
static_assert(int(FOURBAR_P1_FINE) == int(kFine));
static_assert(int(FOURBAR_P1_NOT_FINITE) == int(kNotFinite));
static_assert(int(FOURBAR_P1_ZERO_QUATERNION) == int(kZeroQuaternion));
static_assert(int(FOURBAR_P1_FACTORIZATION) == int(kFactorization));
static_assert(int(FOURBAR_P1_OVERFLOW) == int(kOverflow));
static_assert(int(FOURBAR_P1_NO_ANSWER) == int(kNoAnswer));
static_assert(int(FOURBAR_P1_ENDED) == int(kEnded));
static_assert(int(FOURBAR_P1_NOT_REFINED) == int(kNotRefined));
static_assert(int(FOURBAR_P1_GIMBAL_LOCK) == int(kGimbalLock));
static_assert(int(FOURBAR_P1_GROWTH) == int(kGrowth));
static_assert(int(FOURBAR_P1_NOT_SET) == int(kNotSet));
static_assert(int(FOURBAR_P1_TOO_FEW_STEPS) == int(kTooFewSteps));
static_assert(int(FOURBAR_P1_LOOP_OPEN) == int(kLoopOpen));
static_assert(int(FOURBAR_P1_LOOP_TORN) == int(kLoopTorn));
static_assert(int(FOURBAR_P1_LOOP_SINGULAR) == int(kLoopSingular));
static_assert(int(FOURBAR_P1_LOOP_FREE) == int(kLoopFree));

struct fourbar_p1_solver : Solver {};

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

int fourbar_p1_joint(int k, const char** name, int* q, int* nq, int* v, int* nv) {
  if (k < 0 || k >= kJointCount) return 0;
  const JointConstants& joint = kJoints[k];
  *name = joint.name, *q = joint.q, *nq = joint.nq, *v = joint.v, *nv = joint.nv;
  return 1;
}

fourbar_p1_solver* fourbar_p1_open(void) { return opened<fourbar_p1_solver>(); }

int fourbar_p1_solve(fourbar_p1_solver* solver, const double* q, const double* v, const double* tau, double* qdd) {
  return solver->solve(q, v, tau, qdd);
}

int fourbar_p1_reason(int status) { return failure_kind(status); }

int fourbar_p1_failed_joint(int status) { return is_of_joint(failure_kind(status)) ? failure_place(status) : -1; }

const char* fourbar_p1_failure(const fourbar_p1_solver* solver) {
  return solver == nullptr ? open_failure.c_str() : solver->text.c_str();
}

void fourbar_p1_close(fourbar_p1_solver* solver) {
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
    {"kinematics", 2, -1},
    {"assembly", 0, -1},
    {"disassembly", 0, -1},
} };
constexpr std::array<adagen::Table<adagen::Stage>, kProcesses> kStages{ {
    {kStages_0.data(), 3},
} };

// Joints that close loops, each between a frame of its first link and one of its second; z is its
// axis. Then joints whose coordinates are coupled.
constexpr Number kLoop_0[]{1.0, 0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 1.0, 0.0, 0.5, 0.0,
    1.0, 0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 1.0, 0.0, 0.4, 0.0};
constexpr std::array<adagen::Loop<Number>, 1> kLoops{ {
    {kLoopNames[0], 2, 3, kLoop_0, kLoop_0 + 9, kLoop_0 + 12, kLoop_0 + 21, 7u, 3u, false},
} };

// As the cost profile default has them.
constexpr adagen::Hop kWindowHop{0, 159, 0.437};
constexpr adagen::Hop kMessageHop{26, 228, 0.644};

}  // namespace

// Compiled for size: it runs once.
[[gnu::cold]] int main(int count, char** words) {
  const adagen::Description<Number> description{
      "fourbar", "auto", kProcesses, 1, kNq, kNv, kNtau, kNqdd, kRefine,
      false, kAlone, kBatch, false, kTolerance, kGravity.data(),
      table(kJoints), table(kLinks), table(kOuterForces), {kLoops.data(), kLoopCount}, {}, table(kMessages), kStages.data(), kWindowHop,
      kMessageHop};
  auto* const solver = new ThisSolver;
  const int status = adagen::program(description, *solver, count, words);
  delete solver;
  return status;
}
#endif  // ADAGEN_NO_MAIN
