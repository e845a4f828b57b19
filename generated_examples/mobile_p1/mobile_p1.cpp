// Forward dynamics of "mobile" on 1 process, emitted by adagen 0.1.0 (solver.cpp.j2). Do not edit: emit anew.
//
// robot     "mobile", 6 joints, 13 degrees of freedom, description sha256 421e40d13e3d94e0ea25fa3a829795267d134cdc98cb6abe58b7ec78cf6d9704
// command   adagen ../models/mobile.urdf --procs 1
// options   form segment, shape unrolled, scalar double, channel auto, fixed base, gravity 0.0, 0.0, -9.81
// program   1 process; 0.205 us predicted (default profile)
//           process 0: drive .. loose
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
// To use it from a program of yours: compile this file with -DADAGEN_NO_MAIN and link it; mobile_p1.h
// beside it is this part.
// C interface of the solver mobile_p1: forward dynamics of "mobile" on 1 process,
// emitted by adagen 0.1.0 (interface.h.j2). Do not edit: emit anew.
#ifndef ADAGEN_MOBILE_P1_H
#define ADAGEN_MOBILE_P1_H

enum {
  MOBILE_P1_PROCESSES = 1,
  MOBILE_P1_JOINTS = 6,
  MOBILE_P1_NQ = 14,  // numbers in q
  MOBILE_P1_NV = 13,  // in v and qdd
  MOBILE_P1_NTAU = 13  // in tau
};

// Where each joint begins in q, and in v, tau and qdd.
enum {
  MOBILE_P1_Q_drive = 0,
  MOBILE_P1_V_drive = 0,  // joint 0, "drive": planar, 3 in q, 3 in v
  MOBILE_P1_Q_laser_spin = 3,
  MOBILE_P1_V_laser_spin = 3,  // joint 1, "laser_spin": revolute, 1 in q, 1 in v
  MOBILE_P1_Q_lift = 4,
  MOBILE_P1_V_lift = 4,  // joint 2, "lift": prismatic, 1 in q, 1 in v
  MOBILE_P1_Q_shoulder = 5,
  MOBILE_P1_V_shoulder = 5,  // joint 3, "shoulder": revolute, 1 in q, 1 in v
  MOBILE_P1_Q_wrist = 6,
  MOBILE_P1_V_wrist = 6,  // joint 4, "wrist": revolute, 1 in q, 1 in v
  MOBILE_P1_Q_loose = 7,
  MOBILE_P1_V_loose = 7  // joint 5, "loose": floating, 7 in q, 6 in v
};

// Why a call failed, as mobile_p1_reason tells of the status that it returned.
enum {
  MOBILE_P1_FINE = 0,  // none
  MOBILE_P1_NOT_FINITE = 1,  // q, v or tau of a joint is not a finite number
  MOBILE_P1_ZERO_QUATERNION = 2,  // a joint's quaternion cannot be normalised
  MOBILE_P1_FACTORIZATION = 3,  // inertias beside a joint differ too much for the scalar
  MOBILE_P1_OVERFLOW = 4,  // a joint's acceleration is not a finite number
  MOBILE_P1_NO_ANSWER = 5,  // a process did not answer within the time limit
  MOBILE_P1_ENDED = 6,  // process 0 has ended the evaluations
  MOBILE_P1_NOT_REFINED = 7,  // refinement does not converge
  MOBILE_P1_GIMBAL_LOCK = 8,  // joints that are joined as one do not move in as many directions
  MOBILE_P1_GROWTH = 9,  // a link beside a joint is too light for its neighbours
  MOBILE_P1_TOO_FEW_STEPS = 11  // refinement converges too slowly
};

#ifdef __cplusplus
extern "C" {
#endif
typedef struct mobile_p1_solver mobile_p1_solver;

// Joints in order, each with its place in the state: gives name, start and size in q and v of joint
// k, or returns 0 where there is none.
int mobile_p1_joint(int k, const char** name, int* q, int* nq, int* v, int* nv);

// A solver, with all the memory that it will ever need: no other call allocates, waits or takes a
// lock. One solver is for one thread at a time. Returns null where there is no memory;
// mobile_p1_failure(NULL) says so.
mobile_p1_solver* mobile_p1_open(void);

// One evaluation. q: 14 numbers, v and tau: 13 each, qdd: 13; joints in order, quaternions
// x y z w (normalised here), floating joints [linear; angular] in the body's frame.
// Returns 0, or a status that mobile_p1_failure puts into words; no acceleration is written then.
int mobile_p1_solve(mobile_p1_solver* solver, const double* q, const double* v, const double* tau, double* qdd);

// What a status says: its reason, and which joint it is about, -1 for none.
int mobile_p1_reason(int status);
int mobile_p1_failed_joint(int status);

// The last failure of a solver in words, valid until the next call; of null, why the last open of this
// thread returned null.
const char* mobile_p1_failure(const mobile_p1_solver* solver);

void mobile_p1_close(mobile_p1_solver* solver);
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
constexpr int kJointCount = 6, kLinkCount = kJointCount + 1;
constexpr int kNq = 14, kNv = 13;
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
    {"floor", 0.0, {0.0, 0.0, 0.0},
     {0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0},
     {}},
    {"cart", 35.5, {-0.02799449804688646, 0.0, 0.21497801221230384},
     {2.082900209661478, 0.0, 0.33755007267889864, 0.0, 2.5480080181799307, 0.0, 0.33755007267889864, 0.0, 1.442107808518453},
     {}},
    {"laser", 0.35, {0.0, 0.0, -0.04},
     {0.000245, 0.0, 0.0, 0.0, 0.000245, 0.0, 0.0, 0.0, 0.00028},
     {}},
    {"carriage", 4.2, {0.08, 0.0, 0.0},
     {0.02086, 0.0, 0.0, 0.0, 0.01372, 0.0, 0.0, 0.0, 0.02086},
     {}},
    {"boom", 2.4, {0.17560487334233152, 0.02197563328834232, 0.03286335345030997},
     {0.0031240337753782573, -0.002972881060907817, -0.0044457804600413296, -0.002972881060907817, 0.026507966224621746, -0.0005563560920082658, -0.0044457804600413296, -0.0005563560920082658, 0.026048},
     {}},
    {"bowl", 0.9, {0.0, 0.0, 0.1},
     {0.0021075, 0.0, 0.0, 0.0, 0.00384, 0.0, 0.0, 0.0, 0.0021075},
     {}},
    {"load", 0.6, {0.01, -0.02, 0.015},
     {0.0006, 0.0, 0.0, 0.0, 0.0006, 0.0, 0.0, 0.0, 0.0006},
     {}},
} };

constexpr std::array<JointConstants, kJointCount> kJoints{ {
    {"drive", JointKind::kPlanar, 0, 0, 3, 0, 3,
     {1.0, 0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 1.0},
     {0.0, 0.0, 0.0}, -1, 0.0, 0.0},
    {"laser_spin", JointKind::kRevolute, 1, 3, 1, 3, 1,
     {1.0, 0.0, 0.0, 0.0, -1.0, 0.0, 0.0, 0.0, -1.0},
     {0.22, 0.0, 0.23}, -1, 0.0, 0.0},
    {"lift", JointKind::kPrismatic, 1, 4, 1, 4, 1,
     {0.9987502603949663, 0.0, 0.04997916927067833, 0.0, 1.0, 0.0, -0.04997916927067833, 0.0, 0.9987502603949663},
     {-0.08507706744923418, 0.0, 0.31687627588325595}, -1, 0.0, 0.0},
    {"shoulder", JointKind::kRevolute, 3, 5, 1, 5, 1,
     {0.9755826296796196, 0.12208685160190179, 0.18257418583505539, -0.12208685160190179, -0.3895657419904911, 0.9128709291752769, 0.18257418583505539, -0.9128709291752769, -0.36514837167011077},
     {0.15, 0.0, 0.02}, -1, 0.0, 0.0},
    {"wrist", JointKind::kRevolute, 4, 6, 1, 6, 1,
     {-0.4028214625008311, 0.04136261787763011, 0.9143434820629502, -0.4955543024180784, -0.8497464879390758, -0.17988007001927067, 0.7695198520529689, -0.5255663993041366, 0.3627935462750979},
     {0.3707213992782555, 0.04639300360872268, 0.06937819061732105}, -1, 0.0, 0.0},
    {"loose", JointKind::kFloating, 5, 7, 7, 7, 6,
     {-0.19866933079506122, 0.9362933635841992, -0.28962947762551555, 0.0, 0.29552020666133955, 0.955336489125606, 0.9800665778412416, 0.18979606097868743, -0.058710801693826524},
     {0.0, 0.08, 0.1}, -1, 0.0, 0.0},
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
  alignas(kCacheLine) std::array<Value, 4> angle{}, sine{}, cosine{};
  std::array<Value, kNv> result{};
  std::array<Real*, kPlanMessages> to{};          // messages to be sent
  std::array<const Real*, kPlanMessages> from{};  // messages received
  alignas(kCacheLine) std::array<Value, 71> x{};
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
// Process 0: 764 products, 627 sums, 6 quotients
// =================================================================================================

ADAGEN_NOINLINE void part_0_0(Workspace& w) {
  ADAGEN_INPUTS
  // joint 0 "drive": placement, velocity and reference acceleration of its link
  const Real x12 = v[1] * v[2];
  const Real x14 = v[0] * v[2];
  const Real x15 = v[2] * v[2];
  // link 1 "cart": force that the reference field takes
  const Real x659 = x14 * 0.9938046806644694;
  w.x[0] = x659;
  const Real x665 = x15 * 0.9938046806644694 - x12 * 35.5;
  w.x[1] = x665;
  const Real x666 = x14 * 35.5;
  w.x[2] = x666;
  // joint 1 "laser_spin": placement, velocity and reference acceleration of its link
  const Real x29 = x12 + x15 * 0.22;
  // link 2 "laser": force that the reference field takes
  const Real x682 = (cosine[1] * x29 + x14 * sine[1]) * 0.35;
  w.x[3] = x682;
  const Real x684 = (sine[1] * x29 - x14 * cosine[1]) * 0.35;
  w.x[4] = x684;
  // joint 2 "lift": placement, velocity and reference acceleration of its link
  const Real x57 = -0.08507706744923418 + q[4] * 0.04997916927067833;
  w.x[5] = x57;
  const Real x60 = v[2] * 0.9987502603949663;
  const Real x61 = v[2] * 0.04997916927067833;
  const Real x65 = x12 + x15 * x57;
  const Real x70 = 9.79774005447462 - 0.04997916927067833 * x65;
  const Real x74 = -0.49029565054535446 - 0.9987502603949663 * x65;
  const Real x80 = x14 + v[4] * (2.0 * x61);
  const Real x83 = x60 * x60;
  const Real x87 = x60 * x61;
  // link 3 "carriage": force that the reference field takes
  const Real x705 = x80 * 0.336;
  w.x[6] = x705;
  const Real x709 = x74 * 4.2 - x83 * 0.336;
  w.x[7] = x709;
  const Real x710 = x80 * 4.2;
  w.x[8] = x710;
  const Real x714 = x70 * 4.2 - x87 * 0.336;
  w.x[9] = x714;
  // joint 3 "shoulder": placement, velocity and reference acceleration of its link
  const Real x105 = 0.12208685160190179 * sine[2];
  const Real x106 = 0.9755826296796196 * cosine[2] + x105;
  w.x[10] = x106;
  const Real x107 = 0.12208685160190179 * cosine[2];
  const Real x109 = x107 - 0.9755826296796196 * sine[2];
  w.x[11] = x109;
  const Real x114 = x107 + sine[2] * 0.3895657419904911;
  w.x[12] = x114;
  const Real x119 = x105 - cosine[2] * 0.3895657419904911;
  w.x[13] = x119;
  const Real x123 = 0.18257418583505539 * cosine[2] - 0.9128709291752769 * sine[2];
  w.x[14] = x123;
  const Real x127 = 0.9128709291752769 * cosine[2] + 0.18257418583505539 * sine[2];
  w.x[15] = x127;
  const Real x132 = x60 * x123 - x61 * x106;
  const Real x137 = x61 * x109 + x60 * x127;
  const Real x146 = v[5] - (x61 * 0.18257418583505539 + x60 * 0.36514837167011077);
  const Real x147 = v[5] * x137;
  const Real x149 = v[5] * x132;
  const Real x157 = x74 - (x83 * 0.15 + x87 * 0.02);
  const Real x164 = x70 - (x87 * 0.15 + x61 * x61 * 0.02);
  const Real x170 = x106 * x157 - x80 * x114 + x123 * x164;
  const Real x176 = x109 * x157 + x80 * x119 - x127 * x164;
  const Real x182 = 0.18257418583505539 * x157 + x80 * 0.9128709291752769 - 0.36514837167011077 * x164;
  const Real x188 = x132 * x132;
  const Real x189 = x137 * x137;
  const Real x191 = x146 * x146;
  const Real x192 = x189 + x191;
  const Real x194 = x132 * x137;
  const Real x196 = x188 + x191;
  const Real x198 = x137 * x146;
  const Real x200 = x147 - x198;
  const Real x201 = x147 + x198;
  const Real x203 = x188 + x189;
  const Real x205 = x132 * x146;
  const Real x206 = x149 + x205;
  const Real x207 = x205 - x149;
  // link 4 "boom": force that the reference field takes
  const Real x767 = x198 * 0.0018929379244048662 - x147 * 0.0068750620755951355 + x194 * 0.01829609650863162;
  const Real x785 = x149 * 0.10310893792440486 + x205 * 0.09434093792440484 + x194 * 0.0022896193017263246;
  const Real x800 = x200 * 0.01829609650863162 - x194 * 0.09623387584880971 - x207 * 0.0022896193017263246;
  const Real x769 = x206 * 0.012234548981428322 + x767 - (x203 - x196) * 0.0022896193017263246;
  const Real x788 = x201 * 0.012234548981428322 - x785 - 0.01829609650863162 * (x192 - x203);
  const Real x801 = x800 - 0.012234548981428322 * (x196 - x192);
  const Real x824 = x170 * 2.4 - x194 * 0.05274151989202157 - x192 * 0.42145169602159566;
  const Real x833 = x176 * 2.4 - x194 * 0.42145169602159566 - x196 * 0.05274151989202157;
  const Real x842 = x182 * 2.4 + x206 * 0.42145169602159566 - x201 * 0.05274151989202157;
  // joint 4 "wrist": placement, velocity and reference acceleration of its link
  const Real x229 = 0.04136261787763011 * sine[3] - cosine[3] * 0.4028214625008311;
  w.x[16] = x229;
  const Real x233 = 0.04136261787763011 * cosine[3] + sine[3] * 0.4028214625008311;
  w.x[17] = x233;
  const Real x240 = cosine[3] * 0.4955543024180784 + sine[3] * 0.8497464879390758;
  w.x[18] = x240;
  const Real x246 = sine[3] * 0.4955543024180784 - cosine[3] * 0.8497464879390758;
  w.x[19] = x246;
  const Real x251 = 0.7695198520529689 * cosine[3] - sine[3] * 0.5255663993041366;
  w.x[20] = x251;
  const Real x255 = cosine[3] * 0.5255663993041366 + 0.7695198520529689 * sine[3];
  w.x[21] = x255;
  const Real x262 = x132 * x229 + x146 * x251 + x137 * x240;
  const Real x269 = x132 * x233 - x146 * x255 - x137 * x246;
  const Real x276 = x132 * 0.9143434820629502 + x146 * 0.3627935462750979 + x137 * 0.17988007001927067;
  const Real x277 = v[6] + x276;
  const Real x293 = x149 * 0.17988007001927067 - x147 * 0.9143434820629502;
  const Real x295 = x149 * x240 - x147 * x229 + v[6] * x269;
  const Real x298 = x147 * x233 + x149 * x246 + v[6] * x262;
  const Real x306 = x170 - x194 * 0.04639300360872268 - x192 * 0.3707213992782555;
  const Real x307 = x207 * 0.06937819061732105 + x306;
  const Real x314 = x176 - x194 * 0.3707213992782555 - x196 * 0.04639300360872268;
  const Real x315 = x200 * 0.06937819061732105 + x314;
  const Real x322 = x182 + x206 * 0.3707213992782555 - x201 * 0.04639300360872268;
  const Real x323 = x322 - x203 * 0.06937819061732105;
  const Real x329 = x229 * x307 - x240 * x315 + x251 * x323;
  const Real x335 = x233 * x307 + x246 * x315 - x255 * x323;
  const Real x341 = 0.9143434820629502 * x307 - 0.17988007001927067 * x315 + 0.3627935462750979 * x323;
  const Real x345 = x262 * x262;
  const Real x346 = x269 * x269;
  const Real x347 = x277 * x277;
  const Real x350 = x262 * x269;
  const Real x355 = x269 * x277;
  const Real x356 = x355 - x295;
  const Real x358 = x345 + x346;
  const Real x360 = x262 * x277;
  const Real x362 = x360 - x298;
  // joint 5 "loose": placement, velocity and reference acceleration of its link
  const Real x389 = q[10] * q[10] + q[11] * q[11] + q[12] * q[12];
  const Real x390 = q[13] * q[13] + x389;
  require_length(w, x390, 5);
  const Real x392 = 2.0 * (1 / x390);
  const Real x393 = q[10] * x392;
  const Real x394 = q[11] * x392;
  const Real x395 = q[12] * x392;
  const Real x396 = q[11] * x394;
  const Real x397 = q[12] * x395;
  const Real x399 = 1.0 - (x396 + x397);
  const Real x400 = q[11] * x393;
  const Real x401 = q[13] * x395;
  const Real x402 = x400 - x401;
  const Real x403 = q[12] * x393;
  const Real x404 = q[13] * x394;
  const Real x405 = x403 + x404;
  const Real x406 = x400 + x401;
  const Real x407 = q[10] * x393;
  const Real x409 = 1.0 - (x397 + x407);
  const Real x410 = q[12] * x394;
  const Real x411 = q[13] * x393;
  const Real x412 = x410 - x411;
  const Real x413 = x403 - x404;
  const Real x414 = x410 + x411;
  const Real x416 = 1.0 - (x396 + x407);
  const Real x427 = q[8] * 0.9362933635841992 - q[7] * 0.19866933079506122 - q[9] * 0.28962947762551555;
  w.x[22] = x427;
  const Real x431 = 0.08 + q[8] * 0.29552020666133955 + q[9] * 0.955336489125606;
  w.x[23] = x431;
  const Real x438 = 0.1 + q[7] * 0.9800665778412416 + q[8] * 0.18979606097868743;
  const Real x439 = x438 - q[9] * 0.058710801693826524;
  w.x[24] = x439;
  const Real x446 = 0.9362933635841992 * x406 - x413 * 0.28962947762551555 - x399 * 0.19866933079506122;
  w.x[25] = x446;
  const Real x454 = 0.9362933635841992 * x409 - (x402 * 0.19866933079506122 + x414 * 0.28962947762551555);
  w.x[26] = x454;
  const Real x461 = 0.9362933635841992 * x412 - x405 * 0.19866933079506122 - x416 * 0.28962947762551555;
  w.x[27] = x461;
  const Real x464 = 0.29552020666133955 * x406 + 0.955336489125606 * x413;
  w.x[28] = x464;
  const Real x467 = 0.29552020666133955 * x409 + 0.955336489125606 * x414;
  w.x[29] = x467;
  const Real x470 = 0.29552020666133955 * x412 + 0.955336489125606 * x416;
  w.x[30] = x470;
  const Real x476 = 0.18979606097868743 * x406 - x413 * 0.058710801693826524 + 0.9800665778412416 * x399;
  w.x[31] = x476;
  const Real x482 = 0.9800665778412416 * x402 - x414 * 0.058710801693826524 + 0.18979606097868743 * x409;
  w.x[32] = x482;
  const Real x488 = 0.9800665778412416 * x405 + 0.18979606097868743 * x412 - x416 * 0.058710801693826524;
  w.x[33] = x488;
  const Real x493 = x262 * x446 + x269 * x464 + x277 * x476;
  const Real x498 = x262 * x454 + x269 * x467 + x277 * x482;
  const Real x503 = x262 * x461 + x269 * x470 + x277 * x488;
  const Real x504 = v[10] + x493;
  const Real x505 = v[11] + x498;
  const Real x506 = v[12] + x503;
  const Real x512 = x295 * x446 + x293 * x476 - x298 * x464;
  const Real x529 = v[12] * x498 - v[11] * x503 + x512;
  const Real x518 = x295 * x454 + x293 * x482 - x298 * x467;
  const Real x534 = v[10] * x503 - v[12] * x493 + x518;
  const Real x524 = x295 * x461 + x293 * x488 - x298 * x470;
  const Real x539 = v[11] * x493 - v[10] * x498 + x524;
  const Real x544 = (x350 - x293) * x431 - (x346 + x347) * x427;
  const Real x546 = x362 * x439 + x544 + x329;
  const Real x551 = (x293 + x350) * x427 - (x345 + x347) * x431;
  const Real x553 = x356 * x439 + x551 + x335;
  const Real x558 = (x298 + x360) * x427 - x358 * x439;
  const Real x560 = (x295 + x355) * x431 + x558 + x341;
  const Real x576 = 2.0 * x493;
  const Real x577 = 2.0 * x498;
  const Real x578 = 2.0 * x503;
  const Real x565 = x446 * x546 + x464 * x553 + x476 * x560;
  const Real x570 = x454 * x546 + x467 * x553 + x482 * x560;
  const Real x575 = x461 * x546 + x470 * x553 + x488 * x560;
  const Real x583 = v[9] * x577 - v[8] * x578 + x565;
  const Real x598 = v[9] * v[11] - v[8] * v[12] + x583;
  const Real x588 = v[7] * x578 - v[9] * x576 + x570;
  const Real x603 = v[7] * v[12] - v[9] * v[10] + x588;
  const Real x593 = v[8] * x576 - v[7] * x577 + x575;
  const Real x608 = v[8] * v[10] - v[7] * v[11] + x593;
  const Real x609 = x504 * x504;
  const Real x610 = x505 * x505;
  const Real x611 = x506 * x506;
  const Real x612 = x610 + x611;
  const Real x614 = x504 * x505;
  const Real x615 = x614 - x539;
  const Real x616 = x539 + x614;
  const Real x617 = x609 + x611;
  const Real x619 = x505 * x506;
  const Real x620 = x619 - x529;
  const Real x621 = x529 + x619;
  const Real x622 = x609 + x610;
  const Real x624 = x504 * x506;
  const Real x625 = x624 - x534;
  const Real x626 = x534 + x624;
  // link 6 "load": force that the reference field takes
  const Real x921 = x529 * 0.000975 + x619 * 0.00010500000000000002 - x625 * 0.00012;
  const Real x934 = x534 * 0.0007949999999999999 + x624 * 7.499999999999998e-05 - x615 * 0.00017999999999999998;
  const Real x948 = x539 * 0.0009 - x614 * 0.00018 + x620 * 8.999999999999999e-05;
  const Real x923 = x921 - x616 * 8.999999999999999e-05 + 0.00017999999999999998 * (x622 - x617);
  const Real x936 = x621 * 0.00012 + x934 - 8.999999999999999e-05 * (x612 - x622);
  const Real x950 = x626 * 0.00017999999999999998 + x948 + 0.00012 * (x617 - x612);
  const Real x975 = x626 * 0.009 - (x612 * 0.006 + x615 * 0.012);
  const Real x983 = x616 * 0.006 + x617 * 0.012 + x620 * 0.009;
  const Real x992 = x625 * 0.006 - x622 * 0.009 - x621 * 0.012;
  // joint 5 "loose": articulated-body inertia and bias force through it
  const Real x1013 = tau[7] - (x598 * 0.6 + x975);
  const Real x1014 = tau[8] - (x603 * 0.6 + x983);
  const Real x1015 = tau[9] - (x608 * 0.6 + x992);
  const Real x1016 = tau[10] - (x923 - x608 * 0.012 - x603 * 0.009);
  const Real x1017 = tau[11] - (x936 + x598 * 0.009 - x608 * 0.006);
  const Real x1018 = tau[12] - (x950 + x603 * 0.006 + x598 * 0.012);
  const Real x1040 = 1666.6666666666667 * (x1016 + 0.015 * x1014 + 0.02 * x1015);
  w.x[34] = x1040;
  const Real x1041 = 1666.6666666666667 * (x1017 - 0.015 * x1013 + 0.01 * x1015);
  w.x[35] = x1041;
  const Real x1042 = 1666.6666666666667 * (x1018 - 0.02 * x1013 - 0.01 * x1014);
  w.x[36] = x1042;
  const Real x1048 = 1.6666666666666667 * x1015 + 0.02 * x1040 + 0.01 * x1041;
  w.x[37] = x1048;
  const Real x1054 = 1.6666666666666667 * x1014 + 0.015 * x1040 - 0.01 * x1042;
  w.x[38] = x1054;
  const Real x1060 = 1.6666666666666667 * x1013 - 0.015 * x1041 - 0.02 * x1042;
  w.x[39] = x1060;
  const Real x1080 = x446 * tau[7] + x454 * tau[8] + x461 * tau[9];
  const Real x1085 = x464 * tau[7] + x467 * tau[8] + x470 * tau[9];
  const Real x1090 = x476 * tau[7] + x482 * tau[8] + x488 * tau[9];
  const Real x1065 = x446 * tau[10] + x454 * tau[11] + x461 * tau[12];
  const Real x1070 = x464 * tau[10] + x467 * tau[11] + x470 * tau[12];
  const Real x1075 = x476 * tau[10] + x482 * tau[11] + x488 * tau[12];
  // link 5 "bowl": force that the reference field takes
  const Real x871 = x295 * 0.011107500000000001 - x355 * 0.0107325 - x335 * 0.09000000000000001;
  // joint 5 "loose": articulated-body inertia and bias force through it
  const Real x1106 = x1065 + x431 * x1090 - x439 * x1085 + x871;
  // link 5 "bowl": force that the reference field takes
  const Real x873 = x360 * 0.009000000000000001 - x298 * 0.01284 + x329 * 0.09000000000000001;
  // joint 5 "loose": articulated-body inertia and bias force through it
  const Real x1107 = x1070 + x439 * x1080 - x427 * x1090 + x873;
  const Real x1105 = x1075 + x427 * x1085 - x431 * x1080;
  const Real x1109 = x329 * 0.9 + x362 * 0.09000000000000001 + x1080;
  const Real x1110 = x335 * 0.9 + x356 * 0.09000000000000001 + x1085;
  const Real x1111 = x341 * 0.9 - x358 * 0.09000000000000001 + x1090;
  // joint 4 "wrist": articulated-body inertia and bias force through it
  const Real x1114 = tau[6] - (x293 * 0.0021075 + x350 * 0.0017325 + x1105);
  const Real x1115 = 474.4958481613286 * x1114;
  w.x[40] = x1115;
  const Real x1116 = x233 * 0.09000000000000001;
  const Real x1117 = x229 * 0.09000000000000001;
  const Real x1119 = x246 * 0.09000000000000001;
  const Real x1120 = x240 * 0.09000000000000001;
  const Real x1122 = x255 * 0.09000000000000001;
  const Real x1124 = x251 * 0.09000000000000001;
  const Real x1134 = x240 * x1116 + x246 * x1117;
  const Real x1139 = x251 * x1116 + x255 * x1117;
  const Real x1142 = x229 * x1119 + x233 * x1120;
  const Real x1146 = x246 * x1120 - x240 * x1119;
  const Real x1150 = x251 * x1119 - x255 * x1120;
  const Real x1155 = x229 * x1122 + x233 * x1124;
  const Real x1161 = x240 * x1122 - x246 * x1124;
  const Real x1166 = x255 * x1124 - x251 * x1122;
  const Real x1167 = x229 * 0.011107500000000001;
  const Real x1168 = x233 * 0.01284;
  const Real x1169 = x240 * 0.011107500000000001;
  const Real x1171 = x246 * 0.01284;
  const Real x1200 = x229 * 0.9;
  const Real x1201 = x233 * 0.9;
  const Real x1203 = x240 * 0.9;
  const Real x1205 = x246 * 0.9;
  const Real x1215 = x229 * x1200 + 0.7524216028719005 + x233 * x1201;
  const Real x1221 = -0.14802495261763252 - x240 * x1200 + x246 * x1201;
  const Real x1227 = x251 * x1200 + 0.2985461229340252 - x255 * x1201;
  const Real x1233 = x240 * x1203 + 0.029121155631123948 + x246 * x1205;
  const Real x1240 = -0.05873339565585371 - x251 * x1203 - x255 * x1205;
  const Real x1245 = x251 * (x251 * 0.9) + 0.11845724149697545;
  const Real x1246 = x255 * (x255 * 0.9) + x1245;
  const Real x1247 = 0.04639300360872268 * x1227;
  const Real x1248 = 0.06937819061732105 * x1221;
  const Real x1251 = x229 * x1116 - x233 * x1117 + x1247 - x1248;
  const Real x1256 = x1142 + 0.06937819061732105 * x1215 - 0.3707213992782555 * x1227;
  const Real x1261 = 0.3707213992782555 * x1221 - x1155 - 0.04639300360872268 * x1215;
  const Real x1266 = 0.04639300360872268 * x1240 - x1134 - 0.06937819061732105 * x1233;
  const Real x1267 = 0.3707213992782555 * x1240;
  const Real x1270 = x1146 + x1248 - x1267;
  const Real x1275 = x1161 + 0.3707213992782555 * x1233 - 0.04639300360872268 * x1221;
  const Real x1280 = x1139 + 0.04639300360872268 * x1246 - 0.06937819061732105 * x1240;
  const Real x1285 = x1150 + 0.06937819061732105 * x1227 - 0.3707213992782555 * x1246;
  const Real x1288 = x1166 + x1267 - x1247;
  const Real x1295 = x229 * x1167 + x233 * x1168 + 0.04639300360872268 * x1139;
  const Real x1297 = 0.06937819061732105 * x1134 + x1295 + 0.04639300360872268 * x1280;
  const Real x1305 = x246 * x1168 - x240 * x1167 + 0.04639300360872268 * x1150;
  const Real x1307 = x1305 - 0.06937819061732105 * x1146 + 0.06937819061732105 * x1251;
  const Real x1315 = x251 * x1167 - x255 * x1168 + 0.04639300360872268 * x1166;
  const Real x1317 = x1315 - 0.06937819061732105 * x1161 + 0.3707213992782555 * x1266;
  const Real x1325 = x240 * x1169 + x246 * x1171 + 0.06937819061732105 * x1142;
  const Real x1327 = x1325 - 0.3707213992782555 * x1150 + 0.06937819061732105 * x1256;
  const Real x1336 = x251 * x1169 + x255 * x1171 + 0.06937819061732105 * x1155;
  const Real x1340 = 0.3707213992782555 * x1270 - (0.3707213992782555 * x1166 + x1336);
  const Real x1199 = x251 * (x251 * 0.011107500000000001) + x255 * (x255 * 0.01284);
  const Real x1349 = x1199 + 0.3707213992782555 * x1161 + 0.04639300360872268 * x1155;
  const Real x1375 = x229 * x1109 + x233 * x1110 + 0.9143434820629502 * x1111;
  const Real x1382 = x246 * x1110 - x240 * x1109 - 0.17988007001927067 * x1111;
  const Real x1388 = x251 * x1109 - x255 * x1110 + 0.3627935462750979 * x1111;
  const Real x1356 = x229 * x1106 + 0.9143434820629502 * tau[6] + x233 * x1107;
  const Real x1364 = x246 * x1107 - (x240 * x1106 + 0.17988007001927067 * tau[6]);
  const Real x1370 = x251 * x1106 + 0.3627935462750979 * tau[6] - x255 * x1107;
  const Real x1406 = x1317 - 0.04639300360872268 * x1251 + -0.01829609650863162;
  const Real x1410 = x1340 - 0.04639300360872268 * x1256 + -0.0022896193017263246;
  const Real x1413 = 0.3707213992782555 * x1275 + x1349 - 0.04639300360872268 * x1261 + 0.10121599999999999;
  require_more(w, x1413, 0.0, kFactorization, 3);
  const Real x1414 = -0.05274151989202157 + x1261;
  const Real x1415 = 0.42145169602159566 + x1275;
  // link 4 "boom": force that the reference field takes
  const Real x806 = x182 * 0.05274151989202157 - x176 * 0.07887204828074391 + x769;
  const Real x811 = x170 * 0.07887204828074391 - x182 * 0.42145169602159566 + x788;
  const Real x816 = x176 * 0.42145169602159566 - x170 * 0.05274151989202157 + x801;
  // joint 3 "shoulder": articulated-body inertia and bias force through it
  const Real x1426 = 1 / x1413;
  // joint 4 "wrist": articulated-body inertia and bias force through it
  const Real x1421 = x1370 + 0.3707213992782555 * x1382 - 0.04639300360872268 * x1375 + x816;
  // joint 3 "shoulder": articulated-body inertia and bias force through it
  const Real x1428 = x1426 * (tau[5] - x1421);
  w.x[41] = x1428;
  const Real x1429 = x1406 * x1426;
  w.x[42] = x1429;
  const Real x1430 = x1410 * x1426;
  w.x[43] = x1430;
  const Real x1431 = x1414 * x1426;
  w.x[44] = x1431;
  const Real x1432 = x1415 * x1426;
  w.x[45] = x1432;
  const Real x1433 = x1288 * x1426;
  w.x[46] = x1433;
  const Real x1436 = x1297 - 0.06937819061732105 * x1266 + 0.0068750620755951355 - x1406 * x1429;
  const Real x1439 = x1307 - 0.3707213992782555 * x1280 + -0.012234548981428322 - x1406 * x1430;
  const Real x1442 = x1251 - x1406 * x1431;
  const Real x1445 = -0.07887204828074391 + x1266 - x1406 * x1432;
  const Real x1448 = 0.05274151989202157 + x1280 - x1406 * x1433;
  const Real x1451 = x1327 - 0.3707213992782555 * x1285 + 0.10310893792440486 - x1410 * x1430;
  const Real x1454 = 0.07887204828074391 + x1256 - x1410 * x1431;
  const Real x1457 = x1270 - x1410 * x1432;
  const Real x1460 = -0.42145169602159566 + x1285 - x1410 * x1433;
  const Real x1463 = 2.4 + x1215 - x1414 * x1431;
  w.x[47] = x1463;
  const Real x1466 = x1221 - x1414 * x1432;
  w.x[48] = x1466;
  const Real x1469 = x1227 - x1414 * x1433;
  w.x[49] = x1469;
  const Real x1472 = 2.4 + x1233 - x1415 * x1432;
  w.x[50] = x1472;
  const Real x1475 = x1240 - x1415 * x1433;
  w.x[51] = x1475;
  const Real x1478 = 2.4 + x1246 - x1288 * x1433;
  w.x[52] = x1478;
  // joint 4 "wrist": articulated-body inertia and bias force through it
  const Real x1419 = x1356 + 0.04639300360872268 * x1388 - 0.06937819061732105 * x1382 + x806;
  // joint 3 "shoulder": articulated-body inertia and bias force through it
  const Real x1480 = x1419 + x1406 * x1428;
  w.x[53] = x1480;
  // joint 4 "wrist": articulated-body inertia and bias force through it
  const Real x1420 = x1364 + 0.06937819061732105 * x1375 - 0.3707213992782555 * x1388 + x811;
  // joint 3 "shoulder": articulated-body inertia and bias force through it
  const Real x1482 = x1420 + x1410 * x1428;
  w.x[54] = x1482;
  const Real x1484 = x207 * 0.07887204828074391 + x824 + x1375 + x1414 * x1428;
  w.x[55] = x1484;
  const Real x1486 = x200 * 0.07887204828074391 + x833 + x1382 + x1415 * x1428;
  w.x[56] = x1486;
  const Real x1488 = x842 - x203 * 0.07887204828074391 + x1388 + x1288 * x1428;
  w.x[57] = x1488;
  const Real x1491 = x106 * x1442 + x109 * x1454;
  const Real x1494 = x106 * x1445 + x109 * x1457;
  const Real x1497 = x106 * x1448 + x109 * x1460;
  const Real x1513 = x123 * x1442 - x127 * x1454;
  const Real x1517 = x123 * x1445 - x127 * x1457;
  const Real x1521 = x123 * x1448 - x127 * x1460;
  const Real x1526 = x106 * x1491 + x109 * x1494 + 0.18257418583505539 * x1497;
  w.x[58] = x1526;
  const Real x1532 = x119 * x1494 - x114 * x1491 + 0.9128709291752769 * x1497;
  w.x[59] = x1532;
  const Real x1539 = x123 * x1491 - x127 * x1494 - 0.36514837167011077 * x1497;
  w.x[60] = x1539;
  const Real x1562 = x106 * x1513 + x109 * x1517 + 0.18257418583505539 * x1521;
  w.x[61] = x1562;
  const Real x1568 = x119 * x1517 - x114 * x1513 + 0.9128709291752769 * x1521;
  w.x[62] = x1568;
  const Real x1575 = x123 * x1513 - x127 * x1517 - 0.36514837167011077 * x1521;
  w.x[63] = x1575;
  const Real x1578 = x106 * x1436 + x109 * x1439;
  const Real x1581 = x106 * x1439 + x109 * x1451;
  const Real x1600 = x106 * x1578 + x109 * x1581;
  w.x[64] = x1600;
  const Real x1608 = x123 * x1578 - x127 * x1581;
  w.x[65] = x1608;
  const Real x1617 = x123 * (x123 * x1436 - x127 * x1439);
  const Real x1620 = x1617 - x127 * (x123 * x1439 - x127 * x1451);
  w.x[66] = x1620;
  const Real x1625 = x106 * x1463 + x109 * x1466 + 0.18257418583505539 * x1469;
  w.x[67] = x1625;
  const Real x1630 = x106 * x1466 + x109 * x1472 + 0.18257418583505539 * x1475;
  w.x[68] = x1630;
  const Real x1631 = x106 * x1469;
  w.x[69] = x1631;
  const Real x1632 = x109 * x1475;
  w.x[70] = x1632;
}

ADAGEN_NOINLINE void part_0_1(Workspace& w) {
  ADAGEN_INPUTS
  const Real x57 = w.x[5];
  const Real x106 = w.x[10];
  const Real x109 = w.x[11];
  const Real x114 = w.x[12];
  const Real x119 = w.x[13];
  const Real x123 = w.x[14];
  const Real x127 = w.x[15];
  const Real x229 = w.x[16];
  const Real x233 = w.x[17];
  const Real x240 = w.x[18];
  const Real x246 = w.x[19];
  const Real x251 = w.x[20];
  const Real x255 = w.x[21];
  const Real x427 = w.x[22];
  const Real x431 = w.x[23];
  const Real x439 = w.x[24];
  const Real x446 = w.x[25];
  const Real x454 = w.x[26];
  const Real x461 = w.x[27];
  const Real x464 = w.x[28];
  const Real x467 = w.x[29];
  const Real x470 = w.x[30];
  const Real x476 = w.x[31];
  const Real x482 = w.x[32];
  const Real x488 = w.x[33];
  const Real x659 = w.x[0];
  const Real x665 = w.x[1];
  const Real x666 = w.x[2];
  const Real x682 = w.x[3];
  const Real x684 = w.x[4];
  const Real x705 = w.x[6];
  const Real x709 = w.x[7];
  const Real x710 = w.x[8];
  const Real x714 = w.x[9];
  const Real x1040 = w.x[34];
  const Real x1041 = w.x[35];
  const Real x1042 = w.x[36];
  const Real x1048 = w.x[37];
  const Real x1054 = w.x[38];
  const Real x1060 = w.x[39];
  const Real x1115 = w.x[40];
  const Real x1428 = w.x[41];
  const Real x1429 = w.x[42];
  const Real x1430 = w.x[43];
  const Real x1431 = w.x[44];
  const Real x1432 = w.x[45];
  const Real x1433 = w.x[46];
  const Real x1463 = w.x[47];
  const Real x1466 = w.x[48];
  const Real x1469 = w.x[49];
  const Real x1472 = w.x[50];
  const Real x1475 = w.x[51];
  const Real x1478 = w.x[52];
  const Real x1480 = w.x[53];
  const Real x1482 = w.x[54];
  const Real x1484 = w.x[55];
  const Real x1486 = w.x[56];
  const Real x1488 = w.x[57];
  const Real x1526 = w.x[58];
  const Real x1532 = w.x[59];
  const Real x1539 = w.x[60];
  const Real x1562 = w.x[61];
  const Real x1568 = w.x[62];
  const Real x1575 = w.x[63];
  const Real x1600 = w.x[64];
  const Real x1608 = w.x[65];
  const Real x1620 = w.x[66];
  const Real x1625 = w.x[67];
  const Real x1630 = w.x[68];
  const Real x1631 = w.x[69];
  const Real x1632 = w.x[70];
  // joint 3 "shoulder": articulated-body inertia and bias force through it
  const Real x1635 = x1631 + x1632 + 0.18257418583505539 * x1478;
  const Real x1641 = x119 * x1466 - x114 * x1463 + 0.9128709291752769 * x1469;
  const Real x1647 = x119 * x1472 - x114 * x1466 + 0.9128709291752769 * x1475;
  const Real x1653 = x119 * x1475 - x114 * x1469 + 0.9128709291752769 * x1478;
  const Real x1685 = x119 * x1630 - x114 * x1625 + 0.9128709291752769 * x1635;
  const Real x1692 = x123 * x1625 - x127 * x1630 - 0.36514837167011077 * x1635;
  const Real x1698 = x119 * x1647 - x114 * x1641 + 0.9128709291752769 * x1653;
  const Real x1705 = x123 * x1641 - x127 * x1647 - 0.36514837167011077 * x1653;
  const Real x1660 = x123 * x1463 - x127 * x1466 - 0.36514837167011077 * x1469;
  const Real x1667 = x123 * x1466 - x127 * x1472 - 0.36514837167011077 * x1475;
  const Real x1674 = x123 * x1469 - x127 * x1475 - 0.36514837167011077 * x1478;
  const Real x1725 = x1532 - 0.02 * x1698;
  const Real x1731 = x1568 + 0.15 * x1698;
  const Real x1734 = x1539 - 0.02 * x1705;
  const Real x1740 = x1575 + 0.15 * x1705;
  const Real x1809 = x119 * x1486 - x114 * x1484 + 0.9128709291752769 * x1488;
  const Real x1785 = x106 * x1480 + 0.18257418583505539 * tau[5] + x109 * x1482;
  const Real x1798 = x123 * x1480 - 0.36514837167011077 * tau[5] - x127 * x1482;
  const Real x1679 = x106 * x1625 + x109 * x1630 + 0.18257418583505539 * x1635;
  const Real x1712 = x123 * x1660 - x127 * x1667 - 0.36514837167011077 * x1674;
  const Real x1834 = 4.2 + x1712;
  require_more(w, x1834, 0.0, kFactorization, 2);
  const Real x1803 = x106 * x1484 + x109 * x1486 + 0.18257418583505539 * x1488;
  const Real x1816 = x123 * x1484 - x127 * x1486 - 0.36514837167011077 * x1488;
  // joint 2 "lift": articulated-body inertia and bias force through it
  const Real x1841 = 1 / x1834;
  const Real x1843 = x1841 * (tau[4] - (x714 + x1816));
  const Real x1844 = x1734 * x1841;
  const Real x1846 = x1740 * x1841;
  const Real x1847 = x1692 * x1841;
  const Real x1848 = x1705 * x1841;
  // joint 3 "shoulder": articulated-body inertia and bias force through it
  const Real x1827 = x1600 - 0.02 * x1532 - 0.02 * x1725 + 0.02086;
  const Real x1759 = x1608 - 0.02 * x1568 + 0.15 * x1725;
  const Real x1830 = x1620 + 0.15 * x1568 + 0.15 * x1731 + 0.047740000000000005;
  // joint 2 "lift": articulated-body inertia and bias force through it
  const Real x1878 = x1830 - x1740 * x1846;
  const Real x1887 = 4.2 + x1679 - x1692 * x1847;
  const Real x1893 = 4.2 + x1698 - x1705 * x1848;
  const Real x1903 = x710 + x1809 + x1705 * x1843;
  const Real x1904 = 0.9987502603949663 * (0.336 + x1731 - x1740 * x1848);
  const Real x1907 = x1904 - 0.04997916927067833 * (x1725 - x1734 * x1848);
  const Real x1915 = 0.04997916927067833 * (x1526 - 0.02 * x1685 - x1734 * x1847);
  const Real x1917 = 0.9987502603949663 * (x1562 + 0.15 * x1685 - x1740 * x1847);
  const Real x1934 = 0.04997916927067833 * (x1878 - (x1827 - x1734 * x1844));
  const Real x1943 = 0.04997916927067833 * (x1934 + (x1759 - x1734 * x1846) * 1.9975005207899326);
  const Real x1949 = 0.9987502603949663 * (x1685 - x1692 * x1848);
  const Real x1967 = x57 * x1949 - 0.9987502603949663 * (x1915 - x1917);
  const Real x1976 = x1907 + x57 * x1893;
  const Real x1899 = x1798 + 0.15 * x1809 + x705 + x1740 * x1843;
  const Real x2032 = 0.04997916927067833 * (x1785 - 0.02 * x1809 + x1734 * x1843);
  const Real x2043 = 0.9987502603949663 * (x709 + x1803 + x1692 * x1843);
  const Real x2030 = x1878 - x1943 + (x57 * x1907 + x57 * x1976);
  // joint 1 "laser_spin": articulated-body inertia and bias force through it
  const Real x2111 = cosine[1] * x684 - sine[1] * x682;
  const Real x2133 = 1.4699288717103012 + x2030 + 0.01694;
  const Real x2135 = x1887 - 0.04997916927067833 * (0.04997916927067833 * x1887) + 35.5 + 0.35;
  require_more(w, x2135, 0.0, kFactorization, 0);
  const Real x2136 = 35.5 + x1893 + 0.35;
  // joint 2 "lift": articulated-body inertia and bias force through it
  const Real x2068 = 0.9987502603949663 * x1899 - x2032 + x57 * x1903 - x659;
  const Real x2069 = 0.04997916927067833 * tau[4] + x2043 + x665;
  // joint 0 "drive": articulated-body inertia and bias force through it
  const Real x2147 = 1 / x2135;
  const Real x2148 = x1949 * x2147;
  const Real x2149 = x1967 * x2147;
  const Real x2152 = x2136 - x1949 * x2148;
  const Real x2155 = -0.9938046806644694 + x1976 + 0.077 - x1967 * x2148;
  const Real x2156 = 1 / x2152;
  const Real x2157 = x2155 * x2156;
  const Real x2163 = x2133 - x1967 * x2149 - x2155 * x2157;
  const Real x2165 = 1.7763568394002505e-15 * x2136;
  require_more(w, x2152, x2165, kFactorization, 0);
  const Real x2166 = 1.7763568394002505e-15 * x2133;
  require_more(w, x2163, x2166, kFactorization, 0);
  const Real x2167 = tau[0] - (x2069 - (cosine[1] * x682 + sine[1] * x684));
  const Real x2172 = tau[1] - (x666 + x1903 - x2111) - x2148 * x2167;
  const Real x2169 = tau[2] - (x2068 - (tau[3] + 0.22 * x2111));
  const Real x2181 = 1 / x2163 * (x2169 - x2149 * x2167 - x2157 * x2172);
  w.result[2] = x2181;
  const Real x2184 = x2156 * x2172 - x2157 * x2181;
  w.result[1] = x2184;
  const Real x2190 = x2147 * x2167 - x2149 * x2181 - x2148 * x2184;
  w.result[0] = x2190;
  // joint 1 "laser_spin": its acceleration, and that of the link beyond
  const Real x2274 = tau[3] * 3571.4285714285716 + x2181;
  w.result[3] = x2274;
  // joint 2 "lift": its acceleration, and that of the link beyond
  const Real x2279 = x2184 + x57 * x2181;
  const Real x2280 = 0.9987502603949663 * x2181;
  const Real x2281 = 0.04997916927067833 * x2181;
  const Real x2284 = 0.9987502603949663 * x2190;
  const Real x2294 = x1843 + x1844 * x2281 - x1846 * x2280;
  const Real x2296 = x2294 - x1848 * x2279 - x1847 * x2284;
  const Real x2297 = x2296 - 0.04997916927067833 * x2190;
  w.result[4] = x2297;
  // joint 3 "shoulder": its acceleration, and that of the link beyond
  const Real x2304 = 0.02 * x2281 + 0.15 * x2280 + x2279;
  const Real x2308 = x123 * x2280 - x106 * x2281;
  const Real x2313 = x109 * x2281 + x127 * x2280;
  const Real x2326 = x106 * x2284 - x114 * x2304 + x123 * x2296;
  const Real x2332 = x109 * x2284 + x119 * x2304 - x127 * x2296;
  const Real x2338 = 0.18257418583505539 * x2284 + 0.9128709291752769 * x2304 - 0.36514837167011077 * x2296;
  const Real x2350 = x1428 - x1429 * x2308 + x1430 * x2313;
  const Real x2352 = x2350 - x1431 * x2326 - x1432 * x2332;
  const Real x2353 = x2352 - x1433 * x2338;
  const Real x2354 = 0.18257418583505539 * x2281 + 0.36514837167011077 * x2280 + x2353;
  w.result[5] = x2354;
  // joint 4 "wrist": its acceleration, and that of the link beyond
  const Real x2363 = x2326 - 0.06937819061732105 * x2313 - 0.04639300360872268 * x2353;
  const Real x2369 = x2332 - 0.06937819061732105 * x2308 + 0.3707213992782555 * x2353;
  const Real x2375 = 0.3707213992782555 * x2313 + 0.04639300360872268 * x2308 + x2338;
  const Real x2381 = x229 * x2308 + x240 * x2313 + x251 * x2353;
  const Real x2388 = x233 * x2308 - x246 * x2313 - x255 * x2353;
  const Real x2394 = 0.9143434820629502 * x2308 + 0.17988007001927067 * x2313 + 0.3627935462750979 * x2353;
  const Real x2413 = x1115 - x2394;
  w.result[6] = x2413;
  const Real x2400 = x229 * x2363 + x251 * x2375 - x240 * x2369;
  // joint 5 "loose": its acceleration, and that of the link beyond
  const Real x2422 = x439 * x2388 - x431 * x1115 + x2400;
  // joint 4 "wrist": its acceleration, and that of the link beyond
  const Real x2406 = x233 * x2363 - x255 * x2375 + x246 * x2369;
  // joint 5 "loose": its acceleration, and that of the link beyond
  const Real x2428 = x427 * x1115 - x439 * x2381 + x2406;
  // joint 4 "wrist": its acceleration, and that of the link beyond
  const Real x2412 = 0.9143434820629502 * x2363 + 0.3627935462750979 * x2375 - 0.17988007001927067 * x2369;
  // joint 5 "loose": its acceleration, and that of the link beyond
  const Real x2434 = x431 * x2381 - x427 * x2388 + x2412;
  const Real x2454 = x446 * x2422 + x464 * x2428 + x476 * x2434;
  const Real x2465 = x1060 - x2454;
  w.result[7] = x2465;
  const Real x2459 = x454 * x2422 + x467 * x2428 + x482 * x2434;
  const Real x2466 = x1054 - x2459;
  w.result[8] = x2466;
  const Real x2464 = x461 * x2422 + x470 * x2428 + x488 * x2434;
  const Real x2467 = x1048 - x2464;
  w.result[9] = x2467;
  const Real x2439 = x446 * x2381 + x476 * x1115 + x464 * x2388;
  const Real x2468 = x1040 - x2439;
  w.result[10] = x2468;
  const Real x2444 = x454 * x2381 + x482 * x1115 + x467 * x2388;
  const Real x2469 = x1041 - x2444;
  w.result[11] = x2469;
  const Real x2449 = x461 * x2381 + x488 * x1115 + x470 * x2388;
  const Real x2470 = x1042 - x2449;
  w.result[12] = x2470;
}

// ---- 5. processes -------------------------------------------------------------------------------

// Process 0: 6 of 6 joints: "drive", "laser_spin", "lift", "shoulder", "wrist", "loose"
constexpr std::array<int, 6> kRead_0{0, 1, 2, 3, 4, 5};
constexpr std::array<int, 6> kOwned_0{0, 1, 2, 3, 4, 5};

void run_0([[maybe_unused]] Workspace& w, [[maybe_unused]] Channel& channel) {
  ADAGEN_INPUTS
  stamp(0);
  if (!all(unlike_zero(q + 0, 3) + unlike_zero(v + 3, 1) == 0))
    name_what_is_not_finite(w, kRead_0, kOwned_0);
  w.angle[0] = q[2];
  w.angle[1] = q[3];
  w.angle[2] = q[5];
  w.angle[3] = q[6];
  take_sines_and_cosines<4>(w.angle.data(), w.sine.data(), w.cosine.data());
  part_0_0(w);
  part_0_1(w);
  stamp(1);
  stamp(2);
  stamp(3);
  if (__builtin_expect(w.status != kFine || !all(unlike_zero(w.result.data() + 0, 13) == 0), 0)) {
    // The state's own faults are named before all others.
    const int found = std::exchange(w.status, kFine);
    name_what_is_not_finite(w, kRead_0, kOwned_0);
    Channel::fail(w.status, found);
    name_what_overflows(w, kOwned_0);
  }
  if (w.status != kFine) return;
  std::copy_n(w.result.data() + 0, 13, w.qdd + 0);
}

[[maybe_unused]] constexpr std::array<void (*)(Workspace&, Channel&), kProcesses> kRun{run_0};

// What each process reads of q and v, the velocity entries whose qdd is its own, and whose tau it
// reads.
constexpr std::array<Range, 1> kReadQ_0{ {{0, 14}} };
constexpr std::array<Range, 1> kReadV_0{ {{0, 13}} };
constexpr std::array<Range, 1> kOwn_0{ {{0, 13}} };
constexpr std::array<Range, 1> kTorque_0{ {{0, 13}} };
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

static_assert(MOBILE_P1_NQ == kNq && MOBILE_P1_NV == kNv && MOBILE_P1_NTAU == kNtau);
static_assert(int(MOBILE_P1_FINE) == int(kFine));
static_assert(int(MOBILE_P1_NOT_FINITE) == int(kNotFinite));
static_assert(int(MOBILE_P1_ZERO_QUATERNION) == int(kZeroQuaternion));
static_assert(int(MOBILE_P1_FACTORIZATION) == int(kFactorization));
static_assert(int(MOBILE_P1_OVERFLOW) == int(kOverflow));
static_assert(int(MOBILE_P1_NO_ANSWER) == int(kNoAnswer));
static_assert(int(MOBILE_P1_ENDED) == int(kEnded));
static_assert(int(MOBILE_P1_NOT_REFINED) == int(kNotRefined));
static_assert(int(MOBILE_P1_GIMBAL_LOCK) == int(kGimbalLock));
static_assert(int(MOBILE_P1_GROWTH) == int(kGrowth));
static_assert(int(MOBILE_P1_TOO_FEW_STEPS) == int(kTooFewSteps));

struct mobile_p1_solver : Solver {};

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

int mobile_p1_joint(int k, const char** name, int* q, int* nq, int* v, int* nv) {
  if (k < 0 || k >= kJointCount) return 0;
  const JointConstants& joint = kJoints[k];
  *name = joint.name, *q = joint.q, *nq = joint.nq, *v = joint.v, *nv = joint.nv;
  return 1;
}

mobile_p1_solver* mobile_p1_open(void) { return opened<mobile_p1_solver>(); }

int mobile_p1_solve(mobile_p1_solver* solver, const double* q, const double* v, const double* tau, double* qdd) {
  return solver->solve(q, v, tau, qdd);
}

int mobile_p1_reason(int status) { return failure_kind(status); }

int mobile_p1_failed_joint(int status) { return is_of_joint(failure_kind(status)) ? failure_place(status) : -1; }

const char* mobile_p1_failure(const mobile_p1_solver* solver) {
  return solver == nullptr ? open_failure.c_str() : solver->text.c_str();
}

void mobile_p1_close(mobile_p1_solver* solver) {
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

constexpr const char* kRobot = "mobile";

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
    {"kinematics", 5, -1},
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
