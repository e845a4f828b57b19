// Forward dynamics of "chain16" on 3 processes, emitted by adagen 0.1.0 (solver.cpp.j2). Do not edit: emit anew.
//
// robot     "chain16", 16 joints, 16 degrees of freedom, description sha256 b739552da6e27ec438b5eb7d6da98218430542949a453e8cd1010513e6e26b8a
// options   form segment, shape unrolled, scalar double, channel auto, fixed base, gravity 0.0, 0.0, -9.81
// program   3 processes, joined at cuts; 0.839 us predicted (default profile)
//           process 0: joint01 .. joint08
//           process 1: joint09 .. joint12
//           process 2: joint13 .. joint16
// schedule  joint08@0-2(joint04@0(joint02(joint01 | joint03) | joint06(joint05 | joint07)) | joint12@1-2(joint10@1(joint09 | joint11) | joint14@2(joint13 | joint15(|joint16))))
// licence   yours to choose: what adagen emits belongs to whoever emits it
//
// Each process treats a segment of the robot by the articulated-body algorithm: I^A and p^A (IA, pA), a
// link's inertia and bias force with all that hangs on it, are swept to the segment's root, and the
// accelerations come back. Where segments meet, the assembly-disassembly algorithm of Yamane and Nakamura
// joins them: Phi = (I^A)^-1 and b are what a segment shows at a cut; joint i joins chain A (its parent
// link's side) and chain B (its child link's side), Eq. (3)-(7), and gives back its force, Eq. (8)-(10).
// Spatial vectors are [angular; linear], in link frames turned so that every joint axis is z.
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
typedef struct chain16_p3_solver chain16_p3_solver;

// Joints in order, each with its place in the state: chain16_p3_joint gives name, start and size in q
// and v of joint k, or returns 0 where there is none.
int chain16_p3_joint(int k, const char** name, int* q, int* nq, int* v, int* nv);

// Collective over a communicator of 3 processes. channel: "auto", "window" or "message";
// time_limit: seconds that a process waits for another. Returns null where it cannot be done.
chain16_p3_solver* chain16_p3_open(MPI_Comm comm, const char* channel, double time_limit);

// One evaluation, collective. q: 16 numbers, v and tau: 16 each, qdd: 16; joints in order,
// quaternions x y z w (normalised here), floating joints [linear; angular] in the body's frame.
// solve: every process passes the state and gets its own joints' accelerations (others untouched);
// solve_at_root: process 0 passes the state and gets them all, the others may pass null.
// Returns 0, or what chain16_p3_failure puts into words; no acceleration is written then.
int chain16_p3_solve(chain16_p3_solver* solver, const double* q, const double* v, const double* tau, double* qdd);
int chain16_p3_solve_at_root(chain16_p3_solver* solver, const double* q, const double* v, const double* tau, double* qdd);

// The last failure in words; valid until the next call.
const char* chain16_p3_failure(const chain16_p3_solver* solver);

// Collective.
void chain16_p3_close(chain16_p3_solver* solver);
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
constexpr int kProcesses = 3;
constexpr int kJointCount = 16, kLinkCount = kJointCount + 1;
constexpr int kNq = 16, kNv = 16;
constexpr int kOuterCount = 0, kNtau = kNv + 6 * kOuterCount;
[[maybe_unused]] constexpr int kColumns = 1;  // right-hand sides: the motion, and one per slaved joint
[[maybe_unused]] constexpr bool kBatch = false;  // whether many states are solved at once
[[maybe_unused]] constexpr int kRefine = 0;  // steps of iterative refinement
[[maybe_unused]] constexpr int kPlanMessages = 4;
constexpr std::size_t kCacheLine = 64;
[[maybe_unused]] constexpr bool kFloatingBase = false;
[[maybe_unused]] constexpr double kTolerance = 1e-09;
[[maybe_unused]] constexpr int kRandomStates = 64;
[[maybe_unused]] constexpr const char* kRobot = "chain16";
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
    {"ceiling", 0.0, {0.0, 0.0, 0.0},
     {0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0},
     {}},
    {"rod01", 1.0, {0.0, -0.2, 0.0},
     {0.0134333, 0.0, 0.0, 0.0, 0.0002, 0.0, 0.0, 0.0, 0.0134333},
     {}},
    {"rod02", 1.0, {-0.2, 0.0, 0.0},
     {0.0002, 0.0, 0.0, 0.0, 0.0134333, 0.0, 0.0, 0.0, 0.0134333},
     {}},
    {"rod03", 1.0, {0.0, 0.0, -0.2},
     {0.0134333, 0.0, 0.0, 0.0, 0.0134333, 0.0, 0.0, 0.0, 0.0002},
     {}},
    {"rod04", 1.0, {0.0, -0.2, 0.0},
     {0.0134333, 0.0, 0.0, 0.0, 0.0002, 0.0, 0.0, 0.0, 0.0134333},
     {}},
    {"rod05", 1.0, {-0.2, 0.0, 0.0},
     {0.0002, 0.0, 0.0, 0.0, 0.0134333, 0.0, 0.0, 0.0, 0.0134333},
     {}},
    {"rod06", 1.0, {0.0, 0.0, -0.2},
     {0.0134333, 0.0, 0.0, 0.0, 0.0134333, 0.0, 0.0, 0.0, 0.0002},
     {}},
    {"rod07", 1.0, {0.0, -0.2, 0.0},
     {0.0134333, 0.0, 0.0, 0.0, 0.0002, 0.0, 0.0, 0.0, 0.0134333},
     {}},
    {"rod08", 1.0, {-0.2, 0.0, 0.0},
     {0.0002, 0.0, 0.0, 0.0, 0.0134333, 0.0, 0.0, 0.0, 0.0134333},
     {}},
    {"rod09", 1.0, {0.0, 0.0, -0.2},
     {0.0134333, 0.0, 0.0, 0.0, 0.0134333, 0.0, 0.0, 0.0, 0.0002},
     {}},
    {"rod10", 1.0, {0.0, -0.2, 0.0},
     {0.0134333, 0.0, 0.0, 0.0, 0.0002, 0.0, 0.0, 0.0, 0.0134333},
     {}},
    {"rod11", 1.0, {-0.2, 0.0, 0.0},
     {0.0002, 0.0, 0.0, 0.0, 0.0134333, 0.0, 0.0, 0.0, 0.0134333},
     {}},
    {"rod12", 1.0, {0.0, 0.0, -0.2},
     {0.0134333, 0.0, 0.0, 0.0, 0.0134333, 0.0, 0.0, 0.0, 0.0002},
     {}},
    {"rod13", 1.0, {0.0, -0.2, 0.0},
     {0.0134333, 0.0, 0.0, 0.0, 0.0002, 0.0, 0.0, 0.0, 0.0134333},
     {}},
    {"rod14", 1.0, {-0.2, 0.0, 0.0},
     {0.0002, 0.0, 0.0, 0.0, 0.0134333, 0.0, 0.0, 0.0, 0.0134333},
     {}},
    {"rod15", 1.0, {0.0, 0.0, -0.2},
     {0.0134333, 0.0, 0.0, 0.0, 0.0134333, 0.0, 0.0, 0.0, 0.0002},
     {}},
    {"rod16", 1.0, {0.0, -0.2, 0.0},
     {0.0134333, 0.0, 0.0, 0.0, 0.0002, 0.0, 0.0, 0.0, 0.0134333},
     {}},
} };

constexpr std::array<JointConstants, kJointCount> kJoints{ {
    {"joint01", JointKind::kRevolute, 0, 0, 1, 0, 1,
     {0.0, 0.0, 1.0, 1.0, 0.0, 0.0, 0.0, 1.0, 0.0},
     {0.0, 0.0, 0.0}, -1, 0.0, 0.0},
    {"joint02", JointKind::kRevolute, 1, 1, 1, 1, 1,
     {0.0, 0.0, 1.0, 1.0, 0.0, 0.0, 0.0, 1.0, 0.0},
     {0.0, -0.4, 0.0}, -1, 0.0, 0.0},
    {"joint03", JointKind::kRevolute, 2, 2, 1, 2, 1,
     {0.0, 0.0, 1.0, 1.0, 0.0, 0.0, 0.0, 1.0, 0.0},
     {-0.4, 0.0, 0.0}, -1, 0.0, 0.0},
    {"joint04", JointKind::kRevolute, 3, 3, 1, 3, 1,
     {0.0, 0.0, 1.0, 1.0, 0.0, 0.0, 0.0, 1.0, 0.0},
     {0.0, 0.0, -0.4}, -1, 0.0, 0.0},
    {"joint05", JointKind::kRevolute, 4, 4, 1, 4, 1,
     {0.0, 0.0, 1.0, 1.0, 0.0, 0.0, 0.0, 1.0, 0.0},
     {0.0, -0.4, 0.0}, -1, 0.0, 0.0},
    {"joint06", JointKind::kRevolute, 5, 5, 1, 5, 1,
     {0.0, 0.0, 1.0, 1.0, 0.0, 0.0, 0.0, 1.0, 0.0},
     {-0.4, 0.0, 0.0}, -1, 0.0, 0.0},
    {"joint07", JointKind::kRevolute, 6, 6, 1, 6, 1,
     {0.0, 0.0, 1.0, 1.0, 0.0, 0.0, 0.0, 1.0, 0.0},
     {0.0, 0.0, -0.4}, -1, 0.0, 0.0},
    {"joint08", JointKind::kRevolute, 7, 7, 1, 7, 1,
     {0.0, 0.0, 1.0, 1.0, 0.0, 0.0, 0.0, 1.0, 0.0},
     {0.0, -0.4, 0.0}, -1, 0.0, 0.0},
    {"joint09", JointKind::kRevolute, 8, 8, 1, 8, 1,
     {0.0, 0.0, 1.0, 1.0, 0.0, 0.0, 0.0, 1.0, 0.0},
     {-0.4, 0.0, 0.0}, -1, 0.0, 0.0},
    {"joint10", JointKind::kRevolute, 9, 9, 1, 9, 1,
     {0.0, 0.0, 1.0, 1.0, 0.0, 0.0, 0.0, 1.0, 0.0},
     {0.0, 0.0, -0.4}, -1, 0.0, 0.0},
    {"joint11", JointKind::kRevolute, 10, 10, 1, 10, 1,
     {0.0, 0.0, 1.0, 1.0, 0.0, 0.0, 0.0, 1.0, 0.0},
     {0.0, -0.4, 0.0}, -1, 0.0, 0.0},
    {"joint12", JointKind::kRevolute, 11, 11, 1, 11, 1,
     {0.0, 0.0, 1.0, 1.0, 0.0, 0.0, 0.0, 1.0, 0.0},
     {-0.4, 0.0, 0.0}, -1, 0.0, 0.0},
    {"joint13", JointKind::kRevolute, 12, 12, 1, 12, 1,
     {0.0, 0.0, 1.0, 1.0, 0.0, 0.0, 0.0, 1.0, 0.0},
     {0.0, 0.0, -0.4}, -1, 0.0, 0.0},
    {"joint14", JointKind::kRevolute, 13, 13, 1, 13, 1,
     {0.0, 0.0, 1.0, 1.0, 0.0, 0.0, 0.0, 1.0, 0.0},
     {0.0, -0.4, 0.0}, -1, 0.0, 0.0},
    {"joint15", JointKind::kRevolute, 14, 14, 1, 14, 1,
     {0.0, 0.0, 1.0, 1.0, 0.0, 0.0, 0.0, 1.0, 0.0},
     {-0.4, 0.0, 0.0}, -1, 0.0, 0.0},
    {"joint16", JointKind::kRevolute, 15, 15, 1, 15, 1,
     {0.0, 0.0, 1.0, 1.0, 0.0, 0.0, 0.0, 1.0, 0.0},
     {0.0, 0.0, -0.4}, -1, 0.0, 0.0},
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

constexpr std::array<MessageInfo, 8> kMessages{ {
    {2, 1, 42},  // 0: assembled: chain of "joint14"
    {1, 0, 42},  // 1: assembled: chain of "joint12"
    {0, 1, 6},  // 2: forces on: chain of "joint12"
    {1, 2, 6},  // 3: forces on: chain of "joint14"
    {0, 1, 28},  // 4: state
    {1, 0, 4},  // 5: accelerations
    {0, 2, 36},  // 6: state
    {2, 0, 4},  // 7: accelerations
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
  alignas(kCacheLine) std::array<Value, 16> angle{}, sine{}, cosine{};
  std::array<Value, kNv> result{};
  std::array<Real*, kPlanMessages> to{};          // messages to be sent
  std::array<const Real*, kPlanMessages> from{};  // messages received
  alignas(kCacheLine) std::array<Value, 150> x{};
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
// Process 0: 1001 products, 850 sums, 11 quotients
// =================================================================================================

ADAGEN_NOINLINE void part_0_0(Workspace& w) {
  ADAGEN_INPUTS
  // joint 0 "joint01": placement, velocity and reference acceleration of its link
  const Real x8 = sine[0] * 9.81;
  // joint 1 "joint02": placement, velocity and reference acceleration of its link
  const Real x18 = v[0] * sine[1];
  const Real x19 = v[0] * cosine[1];
  const Real x21 = v[1] * x18;
  const Real x26 = cosine[0] * 9.81 + v[0] * v[0] * 0.4;
  const Real x38 = x18 * x19;
  const Real x44 = x21 * 2.0;
  const Real x28 = sine[1] * x26;
  const Real x20 = v[1] * x19;
  // joint 2 "joint03": placement, velocity and reference acceleration of its link
  const Real x52 = x19 * cosine[2] + v[1] * sine[2];
  const Real x56 = v[1] * cosine[2] - x19 * sine[2];
  const Real x57 = x18 + v[2];
  const Real x97 = x56 * x57;
  const Real x63 = v[2] * x56 - x21 * cosine[2];
  const Real x66 = x21 * sine[2] - v[2] * x52;
  const Real x72 = x28 + 0.4 * x38;
  const Real x76 = x8 - 0.4 * x44;
  const Real x98 = x97 - x63;
  const Real x67 = 0.4 * (x19 * x19 + v[1] * v[1]);
  const Real x84 = sine[2] * x72 + cosine[2] * x76;
  const Real x102 = x52 * x57;
  // joint 3 "joint04": placement, velocity and reference acceleration of its link
  const Real x112 = x56 * cosine[3] + x57 * sine[3];
  const Real x116 = x57 * cosine[3] - x56 * sine[3];
  // joint 6 "joint07": articulated-body inertia and bias force through it
  const Real x589 = cosine[6] * 0.053233300000000004;
  const Real x583 = cosine[6] * 0.2;
  const Real x585 = sine[6] * 0.2;
  const Real x595 = cosine[6] * 0.7485968487815651;
  const Real x592 = cosine[6] * x589;
  const Real x603 = -0.4 - x583;
  const Real x599 = cosine[6] * x595;
  const Real x597 = sine[6] * x595;
  const Real x601 = 1.0 - x599;
  const Real x618 = sine[6] * x589 + 0.4 * x585;
  const Real x606 = 0.4 * x597;
  const Real x643 = 0.0534333 - x592 + 0.0002;
  require_more(w, x643, 0.0, kFactorization, 5);
  const Real x604 = 0.4 * x601;
  const Real x644 = 1.0 + x601;
  const Real x640 = 0.2 + x604;
  const Real x615 = 0.0002 + x592 + 0.4 * x583 - 0.4 * x603;
  const Real x639 = 0.0534333 + 0.4 * x604;
  // joint 5 "joint06": articulated-body inertia and bias force through it
  const Real x695 = sine[5] * x597;
  const Real x697 = cosine[5] * x597;
  const Real x653 = 1 / x643;
  w.x[0] = x653;
  const Real x712 = sine[5] * x606 + 0.4 * x695;
  const Real x657 = x585 * x653;
  w.x[1] = x657;
  const Real x656 = x618 * x653;
  w.x[2] = x656;
  // joint 4 "joint05": articulated-body inertia and bias force through it
  const Real x844 = 2.0 * sine[4];
  w.x[3] = x844;
  // joint 3 "joint04": articulated-body inertia and bias force through it
  const Real x1030 = 2.0 * sine[3];
  // joint 2 "joint03": placement, velocity and reference acceleration of its link
  const Real x104 = x66 + x102;
  const Real x80 = sine[2] * x76 - cosine[2] * x72;
  // joint 3 "joint04": placement, velocity and reference acceleration of its link
  const Real x117 = x52 + v[3];
  const Real x126 = x66 * cosine[3] + x20 * sine[3] + v[3] * x116;
  const Real x129 = x20 * cosine[3] - x66 * sine[3] - v[3] * x112;
  const Real x135 = x84 - 0.4 * x98;
  const Real x136 = 0.4 * (x52 * x52 + x56 * x56);
  const Real x138 = cosine[1] * x26 + x67 + x136;
  const Real x158 = x116 * x117;
  const Real x156 = x112 * x112 + x117 * x117;
  const Real x160 = x126 + x158;
  const Real x132 = x80 - 0.4 * x104;
  const Real x145 = cosine[3] * x138 - sine[3] * x135;
  const Real x153 = x112 * x116;
  const Real x154 = x153 - x63;
  const Real x141 = cosine[3] * x135 + sine[3] * x138;
  // joint 4 "joint05": placement, velocity and reference acceleration of its link
  const Real x173 = x116 * cosine[4] + x117 * sine[4];
  const Real x177 = x117 * cosine[4] - x116 * sine[4];
  const Real x178 = x112 + v[4];
  const Real x190 = x63 * cosine[4] - x129 * sine[4] - v[4] * x173;
  const Real x214 = x173 * x177;
  const Real x224 = x173 * x178;
  const Real x196 = x145 + 0.4 * x156;
  const Real x199 = x132 - 0.4 * x160;
  const Real x216 = x126 + x214;
  // joint 5 "joint06": articulated-body inertia and bias force through it
  const Real x667 = 2.0 - x585 * x657;
  const Real x664 = -0.2 + x603 + x618 * x657;
  const Real x661 = 0.0534333 + x615 - x618 * x656;
  const Real x700 = cosine[5] * (x667 - x644);
  const Real x678 = sine[5] * (x640 + x664);
  const Real x687 = cosine[5] * (x639 - x661);
  const Real x703 = cosine[5] * x700;
  const Real x680 = sine[5] * x678;
  const Real x692 = cosine[5] * x687;
  const Real x701 = sine[5] * x700;
  const Real x684 = cosine[5] * x678;
  const Real x704 = x644 + x703;
  const Real x683 = x664 - x680;
  const Real x705 = x667 - x703;
  const Real x682 = x640 - x680;
  const Real x716 = 0.4 * x701 - x684;
  const Real x719 = x683 - 0.4 * x704;
  const Real x722 = x682 + 0.4 * x705;
  const Real x765 = -0.2 + x719;
  const Real x735 = sine[5] * x687 + 0.4 * x684 - 0.4 * x716;
  const Real x741 = x639 - x692 - 0.4 * x683 - 0.4 * x719;
  const Real x764 = 0.0534333 + x741;
  require_more(w, x764, 0.0, kFactorization, 4);
  const Real x729 = x661 + x692 + 0.4 * x682 + 0.4 * x722;
  // joint 2 "joint03": articulated-body inertia and bias force through it
  const Real x1211 = 2.0 * sine[2];
  // joint 4 "joint05": placement, velocity and reference acceleration of its link
  const Real x225 = x224 - x190;
  const Real x193 = x141 - 0.4 * x154;
  const Real x206 = cosine[4] * x199 - sine[4] * x196;
  const Real x212 = x177 * x177 + x178 * x178;
  const Real x202 = cosine[4] * x196 + sine[4] * x199;
  const Real x187 = x129 * cosine[4] + x63 * sine[4] + v[4] * x177;
  // joint 5 "joint06": placement, velocity and reference acceleration of its link
  const Real x238 = x178 * cosine[5] - x177 * sine[5];
  const Real x239 = x173 + v[5];
  const Real x234 = x177 * cosine[5] + x178 * sine[5];
  const Real x257 = x206 - 0.4 * x216;
  const Real x260 = x193 - 0.4 * x225;
  const Real x248 = x190 * cosine[5] + x126 * sine[5] + v[5] * x238;
  const Real x280 = x238 * x239;
  const Real x281 = x280 - x248;
  const Real x283 = x234 * x234 + x238 * x238;
  const Real x251 = x126 * cosine[5] - x190 * sine[5] - v[5] * x234;
  const Real x254 = x202 + 0.4 * x212;
  const Real x267 = cosine[5] * x260 - sine[5] * x257;
  // joint 4 "joint05": articulated-body inertia and bias force through it
  const Real x776 = 1 / x764;
  w.x[4] = x776;
  const Real x779 = x735 * x776;
  w.x[5] = x779;
  const Real x783 = x716 * x776;
  w.x[6] = x783;
  const Real x780 = x712 * x776;
  w.x[7] = x780;
  const Real x782 = x765 * x776;
  w.x[8] = x782;
  const Real x787 = 0.0534333 + x729 - x735 * x779;
  const Real x796 = 0.2 + x722 + x735 * x783;
  const Real x815 = 1.0 + x705 - x716 * x783;
  const Real x799 = 0.25140315121843493 + x599 + 1.0 + 1.0 - x712 * x780;
  const Real x809 = 1.0 + x704 - x765 * x782;
  const Real x790 = x735 * x780 - (cosine[5] * x606 + 0.4 * x697);
  const Real x793 = x716 - x735 * x782;
  const Real x802 = x695 + x712 * x782;
  const Real x805 = x697 + x712 * x783;
  const Real x812 = x701 + x765 * x783;
  const Real x828 = cosine[4] * x796;
  const Real x826 = sine[4] * x796;
  const Real x843 = cosine[4] * (0.0002 - x787);
  const Real x876 = x828 + 0.4 * x815;
  const Real x834 = cosine[4] * x793 + sine[4] * x790;
  const Real x860 = cosine[4] * x812 - sine[4] * x805;
  const Real x848 = cosine[4] * x843;
  const Real x928 = 0.2 + x876;
  const Real x865 = cosine[4] * (x799 - x809) - x802 * x844;
  const Real x839 = cosine[4] * x834;
  const Real x836 = sine[4] * x834;
  const Real x855 = cosine[4] * x805 + sine[4] * x812;
  const Real x872 = 0.4 * x860;
  const Real x897 = sine[4] * x843 - 0.4 * x826;
  // joint 5 "joint06": placement, velocity and reference acceleration of its link
  const Real x285 = x234 * x239;
  const Real x287 = x251 + x285;
  const Real x263 = cosine[5] * x257 + sine[5] * x260;
  // joint 6 "joint07": placement, velocity and reference acceleration of its link
  const Real x295 = x238 * cosine[6] + x239 * sine[6];
  const Real x299 = x239 * cosine[6] - x238 * sine[6];
  const Real x318 = x267 - 0.4 * x281;
  const Real x321 = x254 + 0.4 * x283;
  const Real x300 = x234 + v[6];
  const Real x336 = x295 * x299;
  const Real x341 = x299 * x300;
  const Real x309 = x251 * cosine[6] + x187 * sine[6] + v[6] * x299;
  const Real x324 = cosine[6] * x318 + sine[6] * x321;
  const Real x315 = x263 - 0.4 * x287;
  // link 6 "rod06": force that the reference field takes
  const Real x523 = x248 * 0.0534333;
  // joint 4 "joint05": articulated-body inertia and bias force through it
  const Real x869 = cosine[4] * x865;
  const Real x871 = x799 - x869;
  const Real x868 = x802 + sine[4] * x865;
  const Real x884 = x839 + x872;
  const Real x893 = 0.4 * x839 + 0.4 * x872;
  const Real x881 = x790 - x836 - 0.4 * x855;
  const Real x903 = 0.0002 - x848 + (0.4 * x828 + 0.4 * x876);
  const Real x927 = 0.0534333 + x903;
  require_more(w, x927, 0.0, kFactorization, 3);
  const Real x882 = 0.4 * x871;
  // joint 3 "joint04": articulated-body inertia and bias force through it
  const Real x939 = 1 / x927;
  w.x[9] = x939;
  const Real x942 = x893 * x939;
  w.x[10] = x942;
  const Real x944 = x897 * x939;
  w.x[11] = x944;
  const Real x945 = x928 * x939;
  w.x[12] = x945;
  const Real x946 = x881 * x939;
  w.x[13] = x946;
  const Real x947 = x884 * x939;
  w.x[14] = x947;
  const Real x950 = 0.0534333 + 0.4 * x882 - x893 * x942;
  const Real x965 = x787 + x848 + 0.0002 - x897 * x944;
  const Real x953 = 0.4 * x836 + x893 * x944;
  const Real x968 = x826 + x897 * x945;
  const Real x972 = x793 - x839 - x897 * x946;
  const Real x989 = x809 + x869 + 1.0 - x881 * x946;
  const Real x962 = -0.2 - x882 + x893 * x947;
  // link 5 "rod05": force that the reference field takes
  const Real x498 = x187 * 0.0002;
  // joint 6 "joint07": placement, velocity and reference acceleration of its link
  const Real x312 = x187 * cosine[6] - x251 * sine[6] - v[6] * x295;
  // link 7 "rod07": force that the reference field takes
  const Real x552 = x312 * 0.0002;
  const Real x560 = x309 * 0.0534333 + x341 * 0.053233300000000004 - x315 * 0.2;
  const Real x567 = (x295 * x295 + x300 * x300) * 0.2;
  const Real x569 = cosine[6] * x321 - sine[6] * x318 + x567;
  const Real x572 = x315 - (x309 + x341) * 0.2;
  // joint 6 "joint07": articulated-body inertia and bias force through it
  const Real x575 = tau[6] - (x523 - x336 * 0.053233300000000004 + x324 * 0.2);
  w.x[15] = x575;
  const Real x576 = 18.714921219539125 * x575;
  w.x[16] = x576;
  const Real x582 = x324 - (x336 - x248) * 0.2 + 0.2 * x576;
  // joint 3 "joint04": articulated-body inertia and bias force through it
  const Real x975 = x836 + x897 * x947;
  const Real x995 = 1.0 + x871 - x884 * x947;
  const Real x1034 = cosine[3] * (x950 - x965) - x953 * x1030;
  const Real x1018 = sine[3] * (x893 * x946 - 0.4 * x868 - x968);
  const Real x1020 = cosine[3] * (x893 * x945 - x872 - x972) - x1018;
  const Real x1010 = cosine[3] * x962 + sine[3] * x975;
  const Real x1049 = cosine[3] * (1.0 + x815 - x928 * x945 - x989);
  const Real x1038 = cosine[3] * x1034;
  const Real x1014 = sine[3] * x962 - cosine[3] * x975;
  const Real x1063 = x1010 - 0.4 * x995;
  const Real x1041 = cosine[3] * (x860 - x928 * x947);
  const Real x1044 = x1041 - sine[3] * (x868 - x881 * x947);
  const Real x1024 = sine[3] * x1020 - x968;
  const Real x1026 = x972 + cosine[3] * x1020;
  const Real x1056 = cosine[3] * (x1049 + (x855 + x928 * x946) * x1030);
  const Real x1057 = x989 + x1056;
  const Real x1115 = x950 - x1038 + 0.0002;
  require_more(w, x1115, 0.0, kFactorization, 2);
  const Real x1059 = 0.4 * x1044;
  const Real x1090 = x953 + sine[3] * x1034 - 0.4 * x1014;
  const Real x1079 = 0.4 * x1024;
  const Real x1064 = 0.4 * x1057;
  const Real x1087 = x965 + x1038 - (0.4 * x1010 + 0.4 * x1063);
  // joint 2 "joint03": articulated-body inertia and bias force through it
  const Real x1126 = 1 / x1115;
  w.x[17] = x1126;
  const Real x1131 = x1014 * x1126;
  w.x[18] = x1131;
  const Real x1132 = x1024 * x1126;
  w.x[19] = x1132;
  const Real x1129 = x1079 * x1126;
  w.x[20] = x1129;
  const Real x1130 = x1090 * x1126;
  w.x[21] = x1130;
  // link 4 "rod04": force that the reference field takes
  const Real x473 = x126 * 0.0534333;
  // joint 6 "joint07": articulated-body inertia and bias force through it
  const Real x629 = cosine[6] * x582 - sine[6] * x569;
  const Real x650 = x267 - x281 * 0.2 + x629;
  // link 6 "rod06": force that the reference field takes
  const Real x538 = x251 * 0.0534333 + x285 * 0.053233300000000004 - x263 * 0.2;
  // joint 6 "joint07": articulated-body inertia and bias force through it
  const Real x638 = cosine[6] * x560 - sine[6] * x552 - 0.4 * x572;
  // link 6 "rod06": force that the reference field takes
  const Real x535 = x523 - x280 * 0.053233300000000004 + x267 * 0.2;
  // joint 6 "joint07": articulated-body inertia and bias force through it
  const Real x646 = tau[6] + 0.4 * x629 + x535;
  // joint 5 "joint06": articulated-body inertia and bias force through it
  const Real x654 = tau[5] - (sine[6] * x560 + cosine[6] * x552 + x498);
  w.x[22] = x654;
  const Real x655 = x653 * x654;
  w.x[23] = x655;
  const Real x672 = x263 - x287 * 0.2 + x572 - x585 * x655;
  const Real x669 = x538 + x638 + x618 * x655;
  const Real x752 = cosine[5] * x672 - sine[5] * x650;
  // joint 2 "joint03": articulated-body inertia and bias force through it
  const Real x1163 = 1.0 + x995 - x1014 * x1131;
  const Real x1172 = 1.0 + x1057 - x1024 * x1132;
  const Real x1142 = x1059 - x1079 * x1131;
  const Real x1145 = 0.2 + x1064 - x1079 * x1132;
  const Real x1154 = -0.2 + x1063 - x1090 * x1131;
  const Real x1157 = x1026 - x1059 - x1090 * x1132;
  const Real x1166 = x1044 - x1014 * x1132;
  const Real x1136 = 0.0534333 + 0.4 * x1064 - x1079 * x1129;
  const Real x1151 = 0.0534333 + x1087 - x1090 * x1130;
  const Real x1139 = 0.4 * x1026 - 0.4 * x1059 - x1079 * x1130;
  const Real x1233 = cosine[2] * (x1163 - x1172) - x1166 * x1211;
  const Real x1201 = cosine[2] * (x1142 - x1157) - sine[2] * (x1145 + x1154);
  const Real x1215 = cosine[2] * (x1136 - x1151) - x1139 * x1211;
  const Real x1237 = cosine[2] * x1233;
  const Real x1202 = sine[2] * x1201;
  const Real x1206 = cosine[2] * x1201;
  const Real x1219 = cosine[2] * x1215;
  const Real x1239 = x1163 - x1237;
  const Real x1205 = x1154 + x1202;
  const Real x1208 = x1142 - x1206;
  const Real x1204 = x1145 + x1202;
  const Real x1246 = 0.4 * (x1166 + sine[2] * x1233);
  const Real x1254 = x1204 + 0.4 * x1239;
  const Real x1255 = x1208 - x1246;
  // link 2 "rod02": force that the reference field takes
  const Real x423 = x20 * 0.0002;
  // link 3 "rod03": force that the reference field takes
  const Real x448 = x63 * 0.0534333;
  // joint 6 "joint07": articulated-body inertia and bias force through it
  const Real x632 = sine[6] * x582 + cosine[6] * x569;
  // joint 5 "joint06": articulated-body inertia and bias force through it
  const Real x755 = sine[5] * x672 + cosine[5] * x650;
  const Real x761 = sine[5] * x646 + cosine[5] * x669 - 0.4 * x752;
  const Real x769 = x498 + tau[5];
  // link 5 "rod05": force that the reference field takes
  const Real x510 = x190 * 0.0534333 - x224 * 0.053233300000000004 + x193 * 0.2;
  // joint 5 "joint06": articulated-body inertia and bias force through it
  const Real x758 = cosine[5] * x646 - sine[5] * x669 + 0.4 * x755;
  // joint 6 "joint07": articulated-body inertia and bias force through it
  const Real x651 = x254 + x283 * 0.2 + x632;
  // joint 5 "joint06": articulated-body inertia and bias force through it
  const Real x771 = x473 + x214 * 0.053233300000000004 - x206 * 0.2 + x761;
  // joint 4 "joint05": articulated-body inertia and bias force through it
  const Real x777 = tau[4] - x771;
  w.x[24] = x777;
  const Real x778 = x776 * x777;
  w.x[25] = x778;
  const Real x817 = x510 + x758 + x735 * x778;
  const Real x825 = x193 - x225 * 0.2 + x755 - x716 * x778;
  const Real x820 = x202 + x212 * 0.2 + x651 - x712 * x778;
  const Real x822 = x206 - x216 * 0.2 + x752 + x765 * x778;
  const Real x917 = sine[4] * x820 + cosine[4] * x822;
  // joint 2 "joint03": articulated-body inertia and bias force through it
  const Real x1270 = 0.4 * (x1205 - 0.4 * (x1172 + x1237));
  const Real x1266 = x1139 + sine[2] * x1215 + 0.4 * x1208;
  const Real x1267 = x1266 - 0.4 * (x1157 + x1206 + x1246);
  const Real x1296 = x1136 - x1219 - 0.4 * x1205 - x1270 + 0.0534333;
  require_more(w, x1296, 0.0, kFactorization, 1);
  const Real x1261 = x1151 + x1219 + 0.4 * x1204 + 0.4 * x1254;
  // joint 1 "joint02": articulated-body inertia and bias force through it
  const Real x1308 = 1 / x1296;
  w.x[26] = x1308;
  const Real x1311 = x1267 * x1308;
  w.x[27] = x1311;
  const Real x1314 = x1255 * x1308;
  w.x[28] = x1314;
  const Real x1355 = cosine[1] * (0.2 + x1254 - x1267 * x1314);
  // link 1 "rod01": force that the reference field takes
  const Real x418 = x8 * 0.2;
  // joint 6 "joint07": articulated-body inertia and bias force through it
  const Real x587 = 2.0 * sine[6];
  w.x[29] = x587;
  // joint 5 "joint06": articulated-body inertia and bias force through it
  const Real x688 = 2.0 * sine[5];
  w.x[30] = x688;
  // joint 4 "joint05": articulated-body inertia and bias force through it
  const Real x914 = cosine[4] * x820 - sine[4] * x822;
  const Real x923 = sine[4] * x769 + cosine[4] * x817 + 0.4 * x825;
  // link 4 "rod04": force that the reference field takes
  const Real x485 = x473 + x158 * 0.053233300000000004 - x132 * 0.2;
  // joint 4 "joint05": articulated-body inertia and bias force through it
  const Real x934 = x448 - x153 * 0.053233300000000004 + x141 * 0.2 + x923;
  // joint 3 "joint04": articulated-body inertia and bias force through it
  const Real x940 = tau[3] - x934;
  w.x[31] = x940;
  const Real x941 = x939 * x940;
  w.x[32] = x941;
  const Real x998 = tau[4] - 0.4 * x917 + x485 - x893 * x941;
  // joint 4 "joint05": articulated-body inertia and bias force through it
  const Real x933 = cosine[4] * x769 - sine[4] * x817 + x129 * 0.0002;
  // joint 3 "joint04": articulated-body inertia and bias force through it
  const Real x1000 = x933 + x897 * x941;
  const Real x1006 = x132 - x160 * 0.2 + x917 + x884 * x941;
  const Real x1002 = x141 - x154 * 0.2 + x825 + x928 * x941;
  const Real x1004 = x145 + x156 * 0.2 + x914 + x881 * x941;
  const Real x1101 = cosine[3] * x1002 - sine[3] * x1004;
  // link 3 "rod03": force that the reference field takes
  const Real x463 = x66 * 0.0534333 + x102 * 0.053233300000000004 - x80 * 0.2;
  // joint 3 "joint04": articulated-body inertia and bias force through it
  const Real x1110 = cosine[3] * x998 - sine[3] * x1000 - 0.4 * x1006;
  // link 3 "rod03": force that the reference field takes
  const Real x460 = x448 - x97 * 0.053233300000000004 + x84 * 0.2;
  // joint 2 "joint03": articulated-body inertia and bias force through it
  const Real x1127 = tau[2] - (sine[3] * x998 + cosine[3] * x1000 + x423);
  w.x[33] = x1127;
  const Real x1128 = x1126 * x1127;
  w.x[34] = x1128;
  const Real x1184 = x80 - x104 * 0.2 + x1006 + x1014 * x1128;
  const Real x1186 = x84 - x98 * 0.2 + x1101 + x1024 * x1128;
  const Real x1180 = tau[3] + 0.4 * x1101 + x460 + x1079 * x1128;
  const Real x1182 = x463 + x1110 + x1090 * x1128;
  // joint 1 "joint02": articulated-body inertia and bias force through it
  const Real x1370 = cosine[1] * (0.0002 - (0.0534333 + x1261 - x1267 * x1311));
  const Real x1400 = x1355 + 0.4 * (1.0 + x1239 - x1255 * x1314);
  const Real x1426 = 0.4 * x1355 + 0.4 * x1400;
  const Real x1451 = 0.0002 - cosine[1] * x1370 + x1426 + 0.0534333;
  require_more(w, x1451, 0.0, kFactorization, 0);
  // joint 0 "joint01": articulated-body inertia and bias force through it
  const Real x1460 = 1 / x1451;
  w.x[35] = x1460;
  // joint 1 "joint02": mobility and acceleration beyond it
  const Real x1469 = 0.4 * x1460;
  const Real x1470 = 0.4 * x1469;
  const Real x1472 = cosine[1] * x1469;
  const Real x1478 = cosine[1] * (cosine[1] * x1460);
  const Real x1487 = x1311 * x1478 + x1314 * x1472;
  const Real x1491 = x1311 * x1472 + x1314 * x1470;
  // joint 2 "joint03": mobility and acceleration beyond it
  const Real x1516 = x1472 + 0.4 * x1478;
  const Real x1513 = 0.4 * x1487;
  // joint 2 "joint03": articulated-body inertia and bias force through it
  const Real x1287 = sine[2] * x1184 + cosine[2] * x1186;
  const Real x1291 = 0.4 * (cosine[2] * x1184 - sine[2] * x1186);
  const Real x1293 = sine[2] * x1180 + cosine[2] * x1182 - x1291;
  const Real x1290 = cosine[2] * x1180 - sine[2] * x1182 + 0.4 * x1287;
  // joint 1 "joint02": articulated-body inertia and bias force through it
  const Real x1309 = tau[1] - (x38 * 0.053233300000000004 + x28 * 0.2 + x1293);
  w.x[36] = x1309;
  const Real x1310 = x1308 * x1309;
  w.x[37] = x1310;
  // joint 2 "joint03": articulated-body inertia and bias force through it
  const Real x1302 = x418 - (x21 * 0.0534333 + x21 * 0.053233300000000004) + x1290;
  // joint 1 "joint02": mobility and acceleration beyond it
  const Real x1499 = x1311 * x1487 + x1314 * x1491 + x1308;
  // joint 2 "joint03": mobility and acceleration beyond it
  const Real x1519 = x1491 + x1513;
  const Real x1530 = x1470 + 0.4 * x1472 + 0.4 * x1516;
  const Real x1526 = 0.4 * x1491 + 0.4 * x1513;
  const Real x1517 = 0.4 * x1499;
  const Real x1521 = 0.4 * x1517;
  const Real x1564 = cosine[2] * (x1478 - x1499) - x1211 * x1487;
  const Real x1542 = cosine[2] * (x1513 + x1519) + sine[2] * (x1516 - x1517);
  const Real x1568 = cosine[2] * x1564;
  const Real x1574 = cosine[2] * (x1521 - x1530) + x1211 * x1526;
  const Real x1543 = sine[2] * x1542;
  const Real x1547 = cosine[2] * x1542;
  const Real x1566 = x1487 + sine[2] * x1564;
  const Real x1569 = x1499 + x1568;
  const Real x1570 = x1478 - x1568;
  const Real x1577 = cosine[2] * x1574;
  const Real x1545 = x1517 + x1543;
  const Real x1548 = x1547 - x1519;
  const Real x1544 = x1516 - x1543;
  const Real x1549 = x1513 - x1547;
  const Real x1578 = x1530 + x1577;
  const Real x1576 = x1526 - sine[2] * x1574;
  const Real x1579 = x1521 - x1577;
  const Real x1586 = x1129 * x1569 - x1130 * x1566 + x1131 * x1548;
  const Real x1587 = x1132 * x1544 + x1586;
  const Real x1596 = x1130 * x1570 - x1129 * x1566 - x1131 * x1545;
  const Real x1597 = x1132 * x1549 + x1596;
  const Real x1614 = x1129 * x1548 - x1130 * x1545 + x1131 * x1578;
  const Real x1615 = x1132 * x1576 + x1614;
  // joint 3 "joint04": mobility and acceleration beyond it
  const Real x1672 = 0.4 * x1566;
  const Real x1679 = x1545 + 0.4 * x1570;
  const Real x1681 = x1549 - x1672;
  // joint 1 "joint02": articulated-body inertia and bias force through it
  const Real x1352 = x8 - x44 * 0.2 + x1287 + x1255 * x1310;
  const Real x1433 = cosine[1] * (x1302 + x1267 * x1310);
  const Real x1447 = sine[1] * (x423 + tau[2]) + x1433 + 0.4 * x1352;
  // joint 0 "joint01": articulated-body inertia and bias force through it
  const Real x1461 = tau[0] - (x418 + x1447);
  w.x[38] = x1461;
  const Real x1462 = x1460 * x1461;
  w.x[39] = x1462;
  // joint 1 "joint02": mobility and acceleration beyond it
  const Real x1502 = cosine[1] * x1462;
  w.x[40] = x1502;
  // joint 2 "joint03": mobility and acceleration beyond it
  const Real x1622 = x1129 * x1544 + x1130 * x1549 + x1131 * x1576;
  const Real x1623 = x1132 * x1579 + x1622;
  const Real x1635 = x1129 * x1587 + x1130 * x1597 + x1131 * x1615;
  const Real x1639 = x1132 * x1623 + x1635 + x1126;
  // joint 3 "joint04": mobility and acceleration beyond it
  const Real x1701 = 0.4 * (x1544 + 0.4 * x1569);
  const Real x1703 = x1579 + 0.4 * x1544 + x1701;
  const Real x1699 = x1576 - 0.4 * x1549 + 0.4 * (x1548 + x1672);
  const Real x1750 = cosine[3] * x1703;
  const Real x1684 = 0.4 * x1597 - x1615;
  const Real x1687 = x1623 + 0.4 * x1587;
  const Real x1694 = x1578 + 0.4 * x1545 + 0.4 * x1679;
  const Real x1747 = cosine[3] * x1699;
  w.x[41] = x1747;
  const Real x1753 = cosine[3] * x1750;
  w.x[42] = x1753;
  const Real x1748 = sine[3] * x1699;
  const Real x1751 = sine[3] * x1750;
  w.x[43] = x1751;
  const Real x1707 = sine[3] * x1684 - cosine[3] * x1679;
  w.x[44] = x1707;
  const Real x1754 = x1703 - x1753;
  w.x[45] = x1754;
  const Real x1718 = cosine[3] * x1681 - sine[3] * x1687;
  const Real x1711 = sine[3] * x1679 + cosine[3] * x1684;
  w.x[46] = x1711;
  const Real x1719 = sine[3] * x1718;
  const Real x1723 = cosine[3] * x1718;
  w.x[47] = x1723;
  const Real x1721 = x1687 + x1719;
  w.x[48] = x1721;
  const Real x1724 = x1681 - x1723;
  w.x[49] = x1724;
  const Real x1827 = x945 * x1747 + x947 * x1694 - x946 * x1748;
  const Real x1801 = x945 * x1753 + x947 * x1747 - x946 * x1751;
  const Real x1740 = cosine[3] * (x1570 - x1639) - x1030 * x1597;
  const Real x1815 = x946 * x1754 - (x945 * x1751 + x947 * x1748);
  const Real x1829 = x1827 - x942 * x1707 + x944 * x1711;
  w.x[50] = x1829;
  const Real x1764 = x945 * x1723 + x947 * x1707 - x946 * x1719;
  w.x[51] = x1764;
  const Real x1803 = x1801 - x942 * x1723 - x944 * x1721;
  w.x[52] = x1803;
  const Real x1744 = cosine[3] * x1740;
  const Real x1817 = x942 * x1719 + x1815 + x944 * x1724;
  w.x[53] = x1817;
  const Real x1839 = x947 * x1829;
  w.x[54] = x1839;
  const Real x1776 = x947 * x1711 - x945 * x1721 + x946 * x1724;
  w.x[55] = x1776;
  const Real x1835 = x945 * x1803;
  w.x[56] = x1835;
  const Real x1745 = x1639 + x1744;
  w.x[57] = x1745;
  const Real x1742 = x1597 + sine[3] * x1740;
  w.x[58] = x1742;
  const Real x1746 = x1570 - x1744;
  w.x[59] = x1746;
  const Real x1837 = x946 * x1817;
  w.x[60] = x1837;
  // joint 4 "joint05": mobility and acceleration beyond it
  const Real x1918 = x1694 - 0.4 * x1707;
  w.x[61] = x1918;
  const Real x1913 = 0.4 * x1719 - x1748;
  w.x[62] = x1913;
  const Real x1905 = 0.4 * x1829;
  w.x[63] = x1905;
  const Real x1901 = 0.4 * x1817;
  w.x[64] = x1901;
  const Real x1980 = x844 * x1913;
  w.x[65] = x1980;
}

ADAGEN_NOINLINE void part_0_1(Workspace& w) {
  ADAGEN_INPUTS
  const Real x576 = w.x[16];
  const Real x587 = w.x[29];
  const Real x653 = w.x[0];
  const Real x655 = w.x[23];
  const Real x656 = w.x[2];
  const Real x657 = w.x[1];
  const Real x688 = w.x[30];
  const Real x776 = w.x[4];
  const Real x778 = w.x[25];
  const Real x779 = w.x[5];
  const Real x780 = w.x[7];
  const Real x782 = w.x[8];
  const Real x783 = w.x[6];
  const Real x844 = w.x[3];
  const Real x939 = w.x[9];
  const Real x941 = w.x[32];
  const Real x942 = w.x[10];
  const Real x944 = w.x[11];
  const Real x945 = w.x[12];
  const Real x946 = w.x[13];
  const Real x947 = w.x[14];
  const Real x1128 = w.x[34];
  const Real x1129 = w.x[20];
  const Real x1130 = w.x[21];
  const Real x1131 = w.x[18];
  const Real x1132 = w.x[19];
  const Real x1310 = w.x[37];
  const Real x1311 = w.x[27];
  const Real x1314 = w.x[28];
  const Real x1462 = w.x[39];
  const Real x1502 = w.x[40];
  const Real x1707 = w.x[44];
  const Real x1711 = w.x[46];
  const Real x1721 = w.x[48];
  const Real x1723 = w.x[47];
  const Real x1724 = w.x[49];
  const Real x1742 = w.x[58];
  const Real x1745 = w.x[57];
  const Real x1746 = w.x[59];
  const Real x1747 = w.x[41];
  const Real x1751 = w.x[43];
  const Real x1753 = w.x[42];
  const Real x1754 = w.x[45];
  const Real x1764 = w.x[51];
  const Real x1776 = w.x[55];
  const Real x1803 = w.x[52];
  const Real x1817 = w.x[53];
  const Real x1829 = w.x[50];
  const Real x1835 = w.x[56];
  const Real x1837 = w.x[60];
  const Real x1839 = w.x[54];
  const Real x1901 = w.x[64];
  const Real x1905 = w.x[63];
  const Real x1913 = w.x[62];
  const Real x1918 = w.x[61];
  const Real x1980 = w.x[65];
  // joint 1 "joint02": mobility and acceleration beyond it
  const Real x1500 = 0.4 * x1462;
  const Real x1508 = x1310 - x1311 * x1502 - x1314 * x1500;
  // joint 2 "joint03": mobility and acceleration beyond it
  const Real x1643 = x1500 + 0.4 * x1502;
  const Real x1640 = 0.4 * x1508;
  const Real x1646 = cosine[2] * x1502 + sine[2] * x1508;
  const Real x1650 = cosine[2] * x1508 - sine[2] * x1502;
  const Real x1654 = sine[2] * x1643 - cosine[2] * x1640;
  const Real x1658 = sine[2] * x1640 + cosine[2] * x1643;
  const Real x1668 = x1128 - x1129 * x1646 - x1130 * x1650;
  // joint 3 "joint04": mobility and acceleration beyond it
  const Real x1766 = x1764 - x942 * x1745 - x944 * x1742;
  const Real x1778 = x942 * x1742 + x1776 + x944 * x1746;
  const Real x1845 = x942 * x1766 - (x1835 + x1839 + x1837);
  const Real x1848 = x939 - (x1845 - x944 * x1778);
  const Real x1851 = x1654 - 0.4 * x1650;
  const Real x1853 = x1658 + 0.4 * x1646;
  const Real x1861 = cosine[3] * x1853;
  // joint 4 "joint05": mobility and acceleration beyond it
  const Real x1903 = x1751 + x1901;
  const Real x1880 = 0.4 * x1766;
  const Real x1919 = x1918 - 0.4 * (x1707 - 0.4 * x1745);
  const Real x1981 = cosine[4] * (x1754 - x1919) + x1980;
  const Real x1910 = x1747 - x1905 - 0.4 * (x1723 - x1880);
  const Real x1939 = sine[4] * (x1711 + 0.4 * x1742 - x1817);
  const Real x1940 = cosine[4] * (x1724 - (x1880 - x1829)) + x1939;
  const Real x1984 = cosine[4] * x1981;
  const Real x1894 = 0.4 * x1848 - x1803;
  const Real x1983 = x1913 - sine[4] * x1981;
  const Real x1985 = x1919 + x1984;
  const Real x1986 = x1754 - x1984;
  const Real x1973 = sine[4] * x1910 - cosine[4] * x1903;
  const Real x1977 = sine[4] * x1903 + cosine[4] * x1910;
  const Real x1943 = x1817 + sine[4] * x1940;
  const Real x1947 = x1724 - cosine[4] * x1940;
  // joint 2 "joint03": mobility and acceleration beyond it
  const Real x1670 = x1668 - x1131 * x1654 - x1132 * x1658;
  // joint 3 "joint04": mobility and acceleration beyond it
  const Real x1862 = sine[3] * x1853;
  const Real x1856 = cosine[3] * x1650 + sine[3] * x1670;
  const Real x1860 = cosine[3] * x1670 - sine[3] * x1650;
  const Real x1875 = x941 - x947 * x1851 - x945 * x1861;
  const Real x1877 = x946 * x1862 + x1875 + x942 * x1856;
  const Real x1878 = x1877 - x944 * x1860;
  // joint 4 "joint05": mobility and acceleration beyond it
  const Real x1927 = sine[4] * (x1721 + 0.4 * x1778) + cosine[4] * x1894;
  const Real x1900 = x1753 - 0.4 * x1803 + 0.4 * x1894;
  const Real x1967 = cosine[4] * (cosine[4] * (x1746 - x1848) - x844 * x1778);
  const Real x1969 = x1746 - x1967;
  const Real x2026 = x782 * x1983 - x780 * x1985 - x783 * x1973;
  const Real x2027 = x2026 - x779 * x1943;
  const Real x2036 = x782 * x1986 - x780 * x1983 - x783 * x1977;
  const Real x2037 = x779 * x1947 + x2036;
  const Real x2005 = x780 * x1943 + x782 * x1947 - x783 * x1927;
  const Real x2006 = x779 * x1969 + x2005;
  const Real x2046 = x782 * x1977 - x780 * x1973 + x779 * x1927;
  const Real x2047 = x2046 - x783 * x1900;
  const Real x2066 = x1851 - 0.4 * x1856;
  const Real x2058 = x780 * x2027 - x782 * x2037 - x779 * x2006;
  const Real x2077 = sine[4] * x2066 - cosine[4] * x1862;
  const Real x2061 = x776 - (x783 * x2047 + x2058);
  const Real x2081 = sine[4] * x1862 + cosine[4] * x2066;
  // joint 5 "joint06": mobility and acceleration beyond it
  const Real x2105 = x1927 + 0.4 * x1969;
  const Real x2101 = 0.4 * x2006;
  const Real x2103 = x1947 + x2101;
  const Real x2110 = x2047 + x2101;
  const Real x2132 = x1900 + 0.4 * x1927 + 0.4 * x2105;
  const Real x2114 = x1983 + 0.4 * x2027;
  const Real x2117 = x1973 - 0.4 * x1943;
  const Real x2128 = x1977 + 0.4 * x2047 + 0.4 * x2103;
  const Real x2143 = sine[5] * x1943 - cosine[5] * x2027;
  // joint 4 "joint05": mobility and acceleration beyond it
  const Real x2073 = cosine[4] * x1878 - sine[4] * x1860;
  const Real x2063 = x1861 + 0.4 * x1878;
  const Real x2091 = x778 + x780 * x2077 - x782 * x2081;
  const Real x2093 = x2091 - x779 * x2073 + x783 * x2063;
  // joint 5 "joint06": mobility and acceleration beyond it
  const Real x2187 = cosine[5] * x2114 + sine[5] * x2117;
  const Real x2108 = x2037 + 0.4 * x2061;
  const Real x2178 = cosine[5] * (x1969 - x2061) - x688 * x2006;
  const Real x2244 = x2063 + 0.4 * x2073;
  const Real x2231 = x656 * x2143 - x657 * x2187;
  const Real x2123 = x1986 + 0.4 * x2037 + 0.4 * x2108;
  const Real x2182 = cosine[5] * x2178;
  const Real x2155 = cosine[5] * (x2103 + x2110) + sine[5] * (x2105 - x2108);
  const Real x2180 = x2006 + sine[5] * x2178;
  const Real x2184 = x1969 - x2182;
  const Real x2156 = sine[5] * x2155;
  const Real x2160 = cosine[5] * x2155;
  const Real x2242 = x2081 - 0.4 * x2093;
  const Real x2251 = cosine[5] * x2093 - sine[5] * x2073;
  const Real x2195 = cosine[5] * (x2123 - x2132) + x688 * x2128;
  const Real x2157 = x2105 - x2156;
  const Real x2158 = x2108 + x2156;
  const Real x2161 = x2160 - x2110;
  const Real x2162 = x2103 - x2160;
  const Real x2198 = cosine[5] * x2195;
  const Real x2199 = x2132 + x2198;
  const Real x2197 = x2128 - sine[5] * x2195;
  const Real x2210 = x656 * x2184 + x657 * x2158;
  const Real x2254 = cosine[5] * x2242 + sine[5] * x2244;
  const Real x2221 = x656 * x2158 + x657 * x2199;
  // joint 6 "joint07": mobility and acceleration beyond it
  const Real x2299 = 0.4 * (cosine[5] * x1943 + sine[5] * x2027);
  const Real x2301 = cosine[5] * x2117 - sine[5] * x2114 - x2299;
  const Real x2294 = x2187 - 0.4 * x2143;
  const Real x2266 = 0.4 * x2180;
  const Real x2275 = x2162 - x2266;
  const Real x2384 = 0.4 * (cosine[5] * x2073 + sine[5] * x2093);
  const Real x2385 = cosine[5] * x2244 - sine[5] * x2242 + x2384;
  // joint 5 "joint06": mobility and acceleration beyond it
  const Real x2264 = x655 - x656 * x2251 + x657 * x2254;
  const Real x2239 = x656 * x2210 + x657 * x2221 + x653;
  // joint 6 "joint07": mobility and acceleration beyond it
  const Real x2296 = 0.4 * (x2157 + 0.4 * (x2061 + x2182));
  const Real x2298 = x2123 - x2198 + 0.4 * x2157 + x2296;
  const Real x2273 = x2158 + 0.4 * x2184;
  const Real x2291 = x2197 - 0.4 * x2162 + 0.4 * (x2161 + x2266);
  const Real x2279 = 0.4 * (x656 * x2180 + x657 * x2161);
  const Real x2280 = x2279 - (x656 * x2162 - x657 * x2197);
  const Real x2278 = x2221 + 0.4 * x2210;
  const Real x2395 = cosine[6] * x2385 + sine[6] * x2077;
  w.x[66] = x2395;
  const Real x2352 = cosine[6] * x2291 + sine[6] * x2294;
  w.x[67] = x2352;
  const Real x2360 = cosine[6] * (x2298 - x1985) + x587 * x2301;
  const Real x2286 = x2199 + 0.4 * x2158 + 0.4 * x2273;
  w.x[68] = x2286;
  const Real x2305 = sine[6] * x2278 - cosine[6] * x2273;
  w.x[69] = x2305;
  const Real x2309 = sine[6] * x2273 + cosine[6] * x2278;
  w.x[70] = x2309;
  const Real x2356 = cosine[6] * x2294 - sine[6] * x2291;
  w.x[71] = x2356;
  const Real x2376 = 3.742984243907825 * x2352;
  w.x[72] = x2376;
  const Real x2383 = x2254 - 0.4 * x2251;
  w.x[73] = x2383;
  const Real x2388 = cosine[6] * x2251 + sine[6] * x2264;
  w.x[74] = x2388;
  const Real x2392 = cosine[6] * x2264 - sine[6] * x2251;
  w.x[75] = x2392;
  const Real x2363 = cosine[6] * x2360;
  const Real x2324 = cosine[6] * (x2231 + x2275) + sine[6] * (x2143 + x2280);
  const Real x2399 = cosine[6] * x2077 - sine[6] * x2385;
  w.x[76] = x2399;
  const Real x2402 = x576 - 3.742984243907825 * x2395;
  w.x[77] = x2402;
  const Real x2364 = x1985 + x2363;
  w.x[78] = x2364;
  const Real x2325 = sine[6] * x2324;
  const Real x2328 = cosine[6] * x2324;
  const Real x2362 = x2301 - sine[6] * x2360;
  w.x[79] = x2362;
  const Real x2365 = x2298 - x2363;
  w.x[80] = x2365;
  const Real x2343 = cosine[6] * (x2184 - x2239) - x587 * x2210;
  const Real x2372 = 3.742984243907825 * x2364;
  w.x[81] = x2372;
  const Real x2327 = x2280 - x2325;
  w.x[82] = x2327;
  const Real x2329 = x2328 - x2231;
  w.x[83] = x2329;
  const Real x2326 = x2143 - x2325;
  w.x[84] = x2326;
  const Real x2330 = x2275 - x2328;
  w.x[85] = x2330;
  const Real x2374 = 3.742984243907825 * x2362;
  w.x[86] = x2374;
  const Real x2347 = cosine[6] * x2343;
  const Real x2366 = 3.742984243907825 * x2329;
  w.x[87] = x2366;
  const Real x2368 = 3.742984243907825 * x2327;
  w.x[88] = x2368;
  const Real x2345 = x2210 + sine[6] * x2343;
  w.x[89] = x2345;
  const Real x2348 = x2239 + x2347;
  w.x[90] = x2348;
  const Real x2349 = x2184 - x2347;
  w.x[91] = x2349;
  const Real x2380 = 18.714921219539125 + 3.742984243907825 * x2372;
  w.x[92] = x2380;
}

ADAGEN_NOINLINE void part_0_2(Workspace& w) {
  ADAGEN_INPUTS
  const Real x2286 = w.x[68];
  const Real x2305 = w.x[69];
  const Real x2309 = w.x[70];
  const Real x2326 = w.x[84];
  const Real x2327 = w.x[82];
  const Real x2329 = w.x[83];
  const Real x2330 = w.x[85];
  const Real x2345 = w.x[89];
  const Real x2348 = w.x[90];
  const Real x2349 = w.x[91];
  const Real x2352 = w.x[67];
  const Real x2356 = w.x[71];
  const Real x2362 = w.x[79];
  const Real x2364 = w.x[78];
  const Real x2365 = w.x[80];
  const Real x2366 = w.x[87];
  const Real x2368 = w.x[88];
  const Real x2372 = w.x[81];
  const Real x2374 = w.x[86];
  const Real x2376 = w.x[72];
  const Real x2380 = w.x[92];
  const Real x2383 = w.x[73];
  const Real x2388 = w.x[74];
  const Real x2392 = w.x[75];
  const Real x2395 = w.x[66];
  const Real x2399 = w.x[76];
  const Real x2402 = w.x[77];
  // message received
  const Real x2405 = w.from[1][0];
  const Real x2407 = w.from[1][2];
  const Real x2414 = w.from[1][9];
  const Real x2408 = w.from[1][3];
  const Real x2415 = w.from[1][10];
  const Real x2417 = w.from[1][12];
  const Real x2409 = w.from[1][4];
  const Real x2416 = w.from[1][11];
  const Real x2418 = w.from[1][13];
  const Real x2406 = w.from[1][1];
  const Real x2420 = w.from[1][15];
  const Real x2411 = w.from[1][6];
  const Real x2421 = w.from[1][16];
  const Real x2419 = w.from[1][14];
  const Real x2412 = w.from[1][7];
  const Real x2423 = w.from[1][18];
  const Real x2413 = w.from[1][8];
  const Real x2424 = w.from[1][19];
  const Real x2425 = w.from[1][20];
  const Real x2410 = w.from[1][5];
  w.x[65] = x2410;
  const Real x2422 = w.from[1][17];
  w.x[61] = x2422;
  // joint 7 "joint08": assembly: its two sides become one chain
  const Real x2504 = 2.0 * sine[7];
  const Real x2550 = x2383 - 0.4 * x2388;
  const Real x2427 = 0.4 * x2366;
  const Real x2458 = x2356 - 0.4 * x2326;
  const Real x2449 = x2362 - 0.4 * x2374;
  const Real x2441 = x2427 - x2376;
  const Real x2429 = x2329 - x2427;
  const Real x2435 = x2327 - 0.4 * x2368;
  const Real x2432 = x2305 - 0.4 * x2348;
  const Real x2438 = x2309 + 0.4 * x2345;
  const Real x2440 = 0.4 * x2380 - x2372;
  const Real x2539 = x2413 + x2429;
  w.x[62] = x2539;
  const Real x2495 = cosine[7] * x2345 + sine[7] * x2366;
  w.x[63] = x2495;
  const Real x2507 = cosine[7] * (x2349 - x2380) - x2368 * x2504;
  const Real x2455 = x2352 - 0.4 * x2376 - 0.4 * x2429;
  const Real x2511 = cosine[7] * x2507;
  const Real x2464 = x2286 - 0.4 * x2305 - 0.4 * x2432;
  const Real x2467 = cosine[7] * x2435 + sine[7] * x2440;
  const Real x2532 = sine[7] * x2345 - cosine[7] * x2366 + x2406;
  w.x[64] = x2532;
  const Real x2509 = x2368 + sine[7] * x2507;
  const Real x2483 = cosine[7] * (x2330 - x2441) + sine[7] * (x2438 - x2374);
  const Real x2537 = cosine[7] * x2326 + sine[7] * x2432 + x2411;
  w.x[54] = x2537;
  const Real x2530 = x2380 + x2511 + 5000.0;
  require_more(w, x2530, 0.0, kFactorization, 7);
  const Real x2531 = x2349 - x2511 + x2405;
  w.x[60] = x2531;
  const Real x2484 = sine[7] * x2483;
  const Real x2488 = cosine[7] * x2483;
  const Real x2565 = cosine[7] * x2392 + sine[7] * x2402 - x2420;
  const Real x2578 = x2565 + tau[7] * x2495;
  const Real x2545 = x2364 - 0.4 * x2372 + 0.4 * x2440 + x2419;
  w.x[56] = x2545;
  const Real x2538 = cosine[7] * x2432 - sine[7] * x2326 + x2412;
  w.x[50] = x2538;
  const Real x2584 = 1 / x2530;
  const Real x2566 = cosine[7] * x2402 - sine[7] * x2392 - x2421;
  const Real x2489 = x2441 + x2488;
  const Real x2524 = cosine[7] * (x2365 - x2464) + x2458 * x2504;
  const Real x2485 = x2438 - x2484;
  const Real x2568 = cosine[7] * x2399 + sine[7] * x2550 - x2423;
  const Real x2527 = cosine[7] * x2524;
  const Real x2569 = cosine[7] * x2550 - sine[7] * x2399 - x2424;
  const Real x2540 = x2464 + x2527 + x2414;
  w.x[53] = x2540;
  const Real x2585 = x2509 * x2584;
  const Real x2587 = x2489 * x2584;
  const Real x2588 = x2485 * x2584;
  const Real x2543 = x2365 - x2527 + x2417;
  w.x[52] = x2543;
  const Real x2589 = x2467 * x2584;
  const Real x2592 = x2531 - x2509 * x2585;
  w.x[55] = x2592;
  const Real x2595 = x2407 - (x2374 + x2484) + x2489 * x2585;
  const Real x2598 = x2330 - x2488 + x2408 + x2485 * x2585;
  const Real x2535 = cosine[7] * x2440 - sine[7] * x2435 + x2409;
  const Real x2601 = x2535 + x2467 * x2585;
  const Real x2542 = cosine[7] * x2449 + sine[7] * x2455 + x2416;
  const Real x2544 = cosine[7] * x2455 - sine[7] * x2449 + x2418;
  const Real x2667 = x2566 - tau[7] * x2532 + x2578 * x2585;
  const Real x2602 = 1 / x2592;
  const Real x2583 = x2395 + 0.4 * x2402 - x2425 - tau[7] * x2539;
  const Real x2603 = x2595 * x2602;
  const Real x2604 = x2598 * x2602;
  const Real x2605 = x2601 * x2602;
  const Real x2611 = x2540 - x2489 * x2587 - x2595 * x2603;
  w.x[51] = x2611;
  const Real x2616 = x2458 - sine[7] * x2524 + x2415 - x2485 * x2587;
  const Real x2617 = x2616 - x2598 * x2603;
  const Real x2623 = x2542 - x2467 * x2587 - x2601 * x2603;
  const Real x2672 = x2568 - tau[7] * x2537 - x2578 * x2587;
  const Real x2673 = x2672 - x2603 * x2667;
  const Real x2680 = x2569 - tau[7] * x2538 - x2578 * x2588;
  const Real x2624 = 1 / x2611;
  const Real x2625 = x2617 * x2624;
  const Real x2626 = x2623 * x2624;
  const Real x2634 = x2543 - x2485 * x2588 - x2598 * x2604;
  const Real x2635 = x2634 - x2617 * x2625;
  w.x[45] = x2635;
  const Real x2643 = x2544 - x2467 * x2588 - x2601 * x2604;
  const Real x2644 = x2643 - x2623 * x2625;
  const Real x2656 = x2545 - x2467 * x2589 - x2601 * x2605;
  const Real x2682 = x2680 - x2604 * x2667 - x2625 * x2673;
  const Real x2692 = x2583 - x2578 * x2589 - x2605 * x2667;
  const Real x2645 = 1 / x2635;
  const Real x2646 = x2644 * x2645;
  const Real x2658 = x2656 - x2623 * x2626 - x2644 * x2646;
  w.x[42] = x2658;
  // joint 7 "joint08": disassembly: its acceleration and force
  const Real x2700 = 1 / x2658 * (x2692 - x2626 * x2673 - x2646 * x2682);
  w.x[43] = x2700;
  w.to[2][5] = x2700;
  const Real x2703 = x2645 * x2682 - x2646 * x2700;
  w.x[41] = x2703;
  w.to[2][4] = x2703;
  const Real x2709 = x2624 * x2673 - x2626 * x2700 - x2625 * x2703;
  w.x[59] = x2709;
  w.to[2][3] = x2709;
  const Real x2717 = x2602 * x2667 - x2605 * x2700 - x2604 * x2703;
  const Real x2718 = x2717 - x2603 * x2709;
  w.x[57] = x2718;
  w.to[2][1] = x2718;
  const Real x2728 = x2578 * x2584 - x2589 * x2700 - x2588 * x2703;
  const Real x2730 = x2728 - x2587 * x2709 + x2585 * x2718;
  w.x[58] = x2730;
  w.to[2][0] = x2730;
}

ADAGEN_NOINLINE void part_0_3(Workspace& w) {
  ADAGEN_INPUTS
  const Real x575 = w.x[15];
  const Real x653 = w.x[0];
  const Real x654 = w.x[22];
  const Real x656 = w.x[2];
  const Real x657 = w.x[1];
  const Real x776 = w.x[4];
  const Real x777 = w.x[24];
  const Real x779 = w.x[5];
  const Real x780 = w.x[7];
  const Real x782 = w.x[8];
  const Real x783 = w.x[6];
  const Real x939 = w.x[9];
  const Real x940 = w.x[31];
  const Real x942 = w.x[10];
  const Real x944 = w.x[11];
  const Real x945 = w.x[12];
  const Real x946 = w.x[13];
  const Real x947 = w.x[14];
  const Real x1126 = w.x[17];
  const Real x1127 = w.x[33];
  const Real x1129 = w.x[20];
  const Real x1130 = w.x[21];
  const Real x1131 = w.x[18];
  const Real x1132 = w.x[19];
  const Real x1308 = w.x[26];
  const Real x1309 = w.x[36];
  const Real x1311 = w.x[27];
  const Real x1314 = w.x[28];
  const Real x1460 = w.x[35];
  const Real x1461 = w.x[38];
  const Real x2348 = w.x[90];
  const Real x2388 = w.x[74];
  const Real x2410 = w.x[65];
  const Real x2422 = w.x[61];
  const Real x2495 = w.x[63];
  const Real x2531 = w.x[60];
  const Real x2532 = w.x[64];
  const Real x2537 = w.x[54];
  const Real x2538 = w.x[50];
  const Real x2539 = w.x[62];
  const Real x2540 = w.x[53];
  const Real x2543 = w.x[52];
  const Real x2545 = w.x[56];
  const Real x2592 = w.x[55];
  const Real x2611 = w.x[51];
  const Real x2635 = w.x[45];
  const Real x2658 = w.x[42];
  const Real x2700 = w.x[43];
  const Real x2703 = w.x[41];
  const Real x2709 = w.x[59];
  const Real x2718 = w.x[57];
  const Real x2730 = w.x[58];
  // joint 7 "joint08": assembly: its two sides become one chain
  const Real x2664 = x2545 * 1.7763568394002505e-15;
  require_more(w, x2658, x2664, kFactorization, 7);
  const Real x2661 = x2531 * 1.7763568394002505e-15;
  require_more(w, x2592, x2661, kFactorization, 7);
  const Real x2662 = x2540 * 1.7763568394002505e-15;
  require_more(w, x2611, x2662, kFactorization, 7);
  const Real x2663 = x2543 * 1.7763568394002505e-15;
  require_more(w, x2635, x2663, kFactorization, 7);
  // joint 7 "joint08": disassembly: its acceleration and force
  const Real x2755 = sine[7] * x2709 + cosine[7] * x2703;
  const Real x2752 = cosine[7] * x2709 - sine[7] * x2703;
  const Real x2756 = 0.4 * x2755;
  const Real x2758 = tau[7] - x2756;
  const Real x2738 = x2538 * x2703 + x2539 * x2700 + x2537 * x2709;
  const Real x2745 = cosine[7] * x2730 - sine[7] * x2718;
  const Real x2761 = sine[7] * x2730 + cosine[7] * x2718 + 0.4 * x2700;
  const Real x2740 = x2532 * x2718 + x2738 - x2495 * x2730;
  const Real x2741 = x2740 - (x2388 - x2422 - tau[7] * (x2348 + x2410));
  w.result[7] = x2741;
  // joint 6 "joint07": handle forces through it
  const Real x2782 = sine[6] * x2758 + cosine[6] * x2745;
  const Real x2772 = 3.742984243907825 * x2761 - x2700;
  const Real x2787 = cosine[6] * x2772 + sine[6] * x2752;
  const Real x2792 = 0.4 * x2787;
  // joint 5 "joint06": handle forces through it
  const Real x2802 = x2755 + x657 * x2782;
  // joint 6 "joint07": handle forces through it
  const Real x2794 = sine[6] * x2745 - cosine[6] * x2758 + x2756;
  // joint 5 "joint06": handle forces through it
  const Real x2799 = x2794 + x656 * x2782;
  const Real x2815 = cosine[5] * x2802 + sine[5] * x2787;
  const Real x2820 = cosine[5] * x2787 - sine[5] * x2802;
  const Real x2826 = sine[5] * x2792 + cosine[5] * x2799 + 0.4 * x2815;
  const Real x2823 = cosine[5] * x2792 - sine[5] * x2799 + 0.4 * x2820;
  // joint 4 "joint05": handle forces through it
  const Real x2831 = x2823 - x779 * x2826;
  const Real x2834 = sine[6] * x2772 - cosine[6] * x2752 + x780 * x2826;
  const Real x2837 = x2815 + x782 * x2826;
  const Real x2841 = x2820 + x783 * x2826;
  const Real x2852 = sine[4] * x2834 - cosine[4] * x2837;
  const Real x2857 = cosine[4] * x2831 + 0.4 * x2841;
  // joint 3 "joint04": handle forces through it
  const Real x2862 = x942 * x2857 - 0.4 * x2852;
  const Real x2865 = sine[4] * x2831 + x944 * x2857;
  const Real x2875 = x2852 - x947 * x2857;
  const Real x2872 = cosine[4] * x2834 + sine[4] * x2837 - x946 * x2857;
  const Real x2883 = sine[3] * x2862 - cosine[3] * x2865;
  const Real x2887 = cosine[3] * (x2841 - x945 * x2857) - sine[3] * x2872;
  // joint 2 "joint03": handle forces through it
  const Real x2906 = x2875 - x1131 * x2883;
  const Real x2909 = x2887 - x1132 * x2883;
  const Real x2900 = 0.4 * x2887 - x1129 * x2883;
  // joint 3 "joint04": handle forces through it
  const Real x2895 = cosine[3] * x2862 + sine[3] * x2865 - 0.4 * x2875;
  // joint 2 "joint03": handle forces through it
  const Real x2903 = x2895 - x1130 * x2883;
  const Real x2926 = sine[2] * x2906 + cosine[2] * x2909;
  const Real x2930 = 0.4 * (cosine[2] * x2906 - sine[2] * x2909);
  const Real x2932 = sine[2] * x2900 + cosine[2] * x2903 - x2930;
  const Real x2929 = cosine[2] * x2900 - sine[2] * x2903 + 0.4 * x2926;
  // joint 1 "joint02": handle forces through it
  const Real x2949 = cosine[1] * (x2929 - x1311 * x2932);
  // joint 0 "joint01": handle forces through it
  const Real x2962 = x2949 + 0.4 * (x2926 - x1314 * x2932) + x1461;
  const Real x2963 = x1460 * x2962;
  w.result[0] = x2963;
  // joint 1 "joint02": its acceleration, and that of the link beyond
  const Real x2966 = cosine[1] * x2963;
  const Real x2964 = 0.4 * x2963;
  const Real x2971 = x1308 * (x1309 + x2932) - x1311 * x2966;
  const Real x2972 = x2971 - x1314 * x2964;
  w.result[1] = x2972;
  // joint 2 "joint03": its acceleration, and that of the link beyond
  const Real x2976 = x2964 + 0.4 * x2966;
  const Real x2973 = 0.4 * x2972;
  const Real x2979 = cosine[2] * x2966 + sine[2] * x2972;
  const Real x2983 = cosine[2] * x2972 - sine[2] * x2966;
  const Real x2987 = sine[2] * x2976 - cosine[2] * x2973;
  const Real x2991 = sine[2] * x2973 + cosine[2] * x2976;
  const Real x3000 = x1126 * (x1127 + x2883) - x1129 * x2979;
  const Real x3002 = x3000 - x1130 * x2983 - x1131 * x2987;
  const Real x3003 = x3002 - x1132 * x2991;
  // joint 3 "joint04": its acceleration, and that of the link beyond
  const Real x3007 = x2987 - 0.4 * x2983;
  const Real x3009 = x2991 + 0.4 * x2979;
  const Real x3017 = cosine[3] * x3009;
  const Real x3018 = sine[3] * x3009;
  // joint 2 "joint03": its acceleration, and that of the link beyond
  const Real x3004 = x3003 - sine[1] * x2963;
  w.result[2] = x3004;
  // joint 3 "joint04": its acceleration, and that of the link beyond
  const Real x3030 = x939 * (x940 + x2857) - x947 * x3007;
  const Real x3012 = cosine[3] * x2983 + sine[3] * x3003;
  const Real x3016 = cosine[3] * x3003 - sine[3] * x2983;
  const Real x3032 = x3030 - x945 * x3017 + x946 * x3018;
  const Real x3034 = x942 * x3012 + x3032 - x944 * x3016;
  const Real x3035 = x3034 - x2979;
  w.result[3] = x3035;
  // joint 4 "joint05": its acceleration, and that of the link beyond
  const Real x3040 = x3007 - 0.4 * x3012;
  const Real x3051 = sine[4] * x3040 - cosine[4] * x3018;
  const Real x3055 = sine[4] * x3018 + cosine[4] * x3040;
  const Real x3047 = cosine[4] * x3034 - sine[4] * x3016;
  const Real x3037 = x3017 + 0.4 * x3034;
  const Real x3064 = x776 * (x777 + x2826) + x780 * x3051;
  const Real x3066 = x3064 - x782 * x3055 - x779 * x3047;
  const Real x3067 = x783 * x3037 + x3066;
  const Real x3068 = x3067 - x3012;
  w.result[4] = x3068;
  // joint 5 "joint06": its acceleration, and that of the link beyond
  const Real x3073 = x3037 + 0.4 * x3047;
  const Real x3071 = x3055 - 0.4 * x3067;
  const Real x3076 = cosine[5] * x3047 + sine[5] * x3067;
  const Real x3088 = x656 * (cosine[5] * x3067 - sine[5] * x3047);
  const Real x3089 = x657 * (cosine[5] * x3071 + sine[5] * x3073);
  const Real x3093 = x653 * (x654 - x2782) - x3088 + x3089;
  const Real x3094 = x3093 - (cosine[4] * x3016 + sine[4] * x3034);
  w.result[5] = x3094;
  // joint 6 "joint07": its acceleration, and that of the link beyond
  const Real x3099 = cosine[5] * x3073 - sine[5] * x3071 + 0.4 * x3076;
  const Real x3114 = 3.742984243907825 * (cosine[6] * x3099 + sine[6] * x3051);
  const Real x3117 = 18.714921219539125 * (x575 - x2761) - x3114 - x3076;
  w.result[6] = x3117;
}

// =================================================================================================
// Process 1: 1312 products, 1062 sums, 12 quotients
// =================================================================================================

ADAGEN_NOINLINE void part_1_0(Workspace& w) {
  ADAGEN_INPUTS
  // joint 1 "joint02": placement, velocity and reference acceleration of its link
  const Real x18 = v[0] * sine[1];
  const Real x19 = v[0] * cosine[1];
  const Real x20 = v[1] * x19;
  const Real x21 = v[1] * x18;
  const Real x26 = cosine[0] * 9.81 + v[0] * v[0] * 0.4;
  // joint 2 "joint03": placement, velocity and reference acceleration of its link
  const Real x52 = x19 * cosine[2] + v[1] * sine[2];
  const Real x56 = v[1] * cosine[2] - x19 * sine[2];
  const Real x57 = x18 + v[2];
  const Real x63 = v[2] * x56 - x21 * cosine[2];
  const Real x66 = x21 * sine[2] - v[2] * x52;
  const Real x67 = 0.4 * (x19 * x19 + v[1] * v[1]);
  const Real x72 = sine[1] * x26 + 0.4 * (x18 * x19);
  const Real x76 = sine[0] * 9.81 - 0.4 * (x21 * 2.0);
  // joint 3 "joint04": placement, velocity and reference acceleration of its link
  const Real x112 = x56 * cosine[3] + x57 * sine[3];
  const Real x116 = x57 * cosine[3] - x56 * sine[3];
  const Real x117 = x52 + v[3];
  const Real x126 = x66 * cosine[3] + x20 * sine[3] + v[3] * x116;
  const Real x129 = x20 * cosine[3] - x66 * sine[3] - v[3] * x112;
  // joint 2 "joint03": placement, velocity and reference acceleration of its link
  const Real x80 = sine[2] * x76 - cosine[2] * x72;
  const Real x84 = sine[2] * x72 + cosine[2] * x76;
  // joint 3 "joint04": placement, velocity and reference acceleration of its link
  const Real x135 = x84 - 0.4 * (x56 * x57 - x63);
  const Real x136 = 0.4 * (x52 * x52 + x56 * x56);
  const Real x138 = cosine[1] * x26 + x67 + x136;
  // joint 4 "joint05": placement, velocity and reference acceleration of its link
  const Real x173 = x116 * cosine[4] + x117 * sine[4];
  const Real x177 = x117 * cosine[4] - x116 * sine[4];
  const Real x178 = x112 + v[4];
  const Real x187 = x129 * cosine[4] + x63 * sine[4] + v[4] * x177;
  const Real x190 = x63 * cosine[4] - x129 * sine[4] - v[4] * x173;
  // joint 3 "joint04": placement, velocity and reference acceleration of its link
  const Real x141 = cosine[3] * x135 + sine[3] * x138;
  // joint 4 "joint05": placement, velocity and reference acceleration of its link
  const Real x194 = 0.4 * (x112 * x112 + x117 * x117);
  const Real x196 = cosine[3] * x138 - sine[3] * x135 + x194;
  // joint 3 "joint04": placement, velocity and reference acceleration of its link
  const Real x132 = x80 - 0.4 * (x66 + x52 * x57);
  // joint 4 "joint05": placement, velocity and reference acceleration of its link
  const Real x199 = x132 - 0.4 * (x126 + x116 * x117);
  // joint 5 "joint06": placement, velocity and reference acceleration of its link
  const Real x234 = x177 * cosine[5] + x178 * sine[5];
  const Real x238 = x178 * cosine[5] - x177 * sine[5];
  const Real x239 = x173 + v[5];
  const Real x248 = x190 * cosine[5] + x126 * sine[5] + v[5] * x238;
  const Real x251 = x126 * cosine[5] - x190 * sine[5] - v[5] * x234;
  const Real x252 = 0.4 * (x177 * x177 + x178 * x178);
  // joint 4 "joint05": placement, velocity and reference acceleration of its link
  const Real x206 = cosine[4] * x199 - sine[4] * x196;
  // joint 5 "joint06": placement, velocity and reference acceleration of its link
  const Real x257 = x206 - 0.4 * (x126 + x173 * x177);
  // joint 4 "joint05": placement, velocity and reference acceleration of its link
  const Real x193 = x141 - 0.4 * (x112 * x116 - x63);
  // joint 5 "joint06": placement, velocity and reference acceleration of its link
  const Real x260 = x193 - 0.4 * (x173 * x178 - x190);
  // joint 6 "joint07": placement, velocity and reference acceleration of its link
  const Real x295 = x238 * cosine[6] + x239 * sine[6];
  const Real x299 = x239 * cosine[6] - x238 * sine[6];
  const Real x300 = x234 + v[6];
  const Real x309 = x251 * cosine[6] + x187 * sine[6] + v[6] * x299;
  const Real x312 = x187 * cosine[6] - x251 * sine[6] - v[6] * x295;
  // joint 5 "joint06": placement, velocity and reference acceleration of its link
  const Real x263 = cosine[5] * x257 + sine[5] * x260;
  const Real x267 = cosine[5] * x260 - sine[5] * x257;
  // joint 6 "joint07": placement, velocity and reference acceleration of its link
  const Real x318 = x267 - 0.4 * (x238 * x239 - x248);
  // joint 5 "joint06": placement, velocity and reference acceleration of its link
  const Real x254 = cosine[4] * x196 + sine[4] * x199 + x252;
  // joint 6 "joint07": placement, velocity and reference acceleration of its link
  const Real x321 = x254 + 0.4 * (x234 * x234 + x238 * x238);
  // joint 7 "joint08": placement, velocity and reference acceleration of its link
  const Real x356 = x299 * cosine[7] + x300 * sine[7];
  const Real x360 = x300 * cosine[7] - x299 * sine[7];
  const Real x361 = x295 + v[7];
  const Real x370 = x312 * cosine[7] + x248 * sine[7] + v[7] * x360;
  const Real x373 = x248 * cosine[7] - x312 * sine[7] - v[7] * x356;
  // joint 6 "joint07": placement, velocity and reference acceleration of its link
  const Real x324 = cosine[6] * x318 + sine[6] * x321;
  // joint 7 "joint08": placement, velocity and reference acceleration of its link
  const Real x376 = x324 - 0.4 * (x295 * x299 - x248);
  const Real x377 = 0.4 * (x295 * x295 + x300 * x300);
  const Real x379 = cosine[6] * x321 - sine[6] * x318 + x377;
  // joint 6 "joint07": placement, velocity and reference acceleration of its link
  const Real x315 = x263 - 0.4 * (x251 + x234 * x239);
  // joint 7 "joint08": placement, velocity and reference acceleration of its link
  const Real x382 = x315 - 0.4 * (x309 + x299 * x300);
  const Real x385 = cosine[7] * x379 + sine[7] * x382;
  const Real x389 = cosine[7] * x382 - sine[7] * x379;
  const Real x395 = x360 * x360 + x361 * x361;
  const Real x397 = x356 * x360;
  const Real x399 = x309 + x397;
  const Real x407 = x356 * x361;
  const Real x408 = x407 - x373;
  // link 8 "rod08": force that the reference field takes
  const Real x660 = x370 * 0.0002;
  // joint 8 "joint09": placement, velocity and reference acceleration of its link
  const Real x417 = x360 * cosine[8] + x361 * sine[8];
  const Real x421 = x361 * cosine[8] - x360 * sine[8];
  const Real x422 = x356 + v[8];
  const Real x431 = x373 * cosine[8] + x309 * sine[8] + v[8] * x421;
  const Real x434 = x309 * cosine[8] - x373 * sine[8] - v[8] * x417;
  const Real x437 = x385 + 0.4 * x395;
  const Real x440 = x389 - 0.4 * x399;
  const Real x443 = x376 - 0.4 * x408;
  const Real x446 = cosine[8] * x440 + sine[8] * x443;
  const Real x450 = cosine[8] * x443 - sine[8] * x440;
  const Real x463 = x421 * x422;
  const Real x464 = x463 - x431;
  const Real x466 = x417 * x417 + x421 * x421;
  const Real x468 = x417 * x422;
  const Real x470 = x434 + x468;
  // link 9 "rod09": force that the reference field takes
  const Real x688 = x431 * 0.0534333;
  // joint 9 "joint10": placement, velocity and reference acceleration of its link
  const Real x478 = x421 * cosine[9] + x422 * sine[9];
  const Real x482 = x422 * cosine[9] - x421 * sine[9];
  const Real x483 = x417 + v[9];
  const Real x492 = x434 * cosine[9] + x370 * sine[9] + v[9] * x482;
  const Real x495 = x370 * cosine[9] - x434 * sine[9] - v[9] * x478;
  const Real x498 = x446 - 0.4 * x470;
  const Real x501 = x450 - 0.4 * x464;
  const Real x504 = x437 + 0.4 * x466;
  const Real x507 = cosine[9] * x501 + sine[9] * x504;
  const Real x511 = cosine[9] * x504 - sine[9] * x501;
  const Real x519 = x478 * x482;
  const Real x520 = x519 - x431;
  const Real x522 = x478 * x478 + x483 * x483;
  const Real x524 = x482 * x483;
  const Real x526 = x492 + x524;
  // link 10 "rod10": force that the reference field takes
  const Real x713 = x492 * 0.0534333;
  // joint 10 "joint11": placement, velocity and reference acceleration of its link
  const Real x539 = x482 * cosine[10] + x483 * sine[10];
  const Real x543 = x483 * cosine[10] - x482 * sine[10];
  const Real x544 = x478 + v[10];
  const Real x556 = x431 * cosine[10] - x495 * sine[10] - v[10] * x539;
  const Real x559 = x507 - 0.4 * x520;
  const Real x562 = x511 + 0.4 * x522;
  const Real x565 = x498 - 0.4 * x526;
  const Real x572 = cosine[10] * x565 - sine[10] * x562;
  const Real x580 = x539 * x543;
  const Real x590 = x539 * x544;
  const Real x553 = x495 * cosine[10] + x431 * sine[10] + v[10] * x543;
  // link 11 "rod11": force that the reference field takes
  const Real x738 = x553 * 0.0002;
  const Real x750 = x556 * 0.0534333 - x590 * 0.053233300000000004 + x559 * 0.2;
  const Real x754 = (x543 * x543 + x544 * x544) * 0.2;
  const Real x756 = cosine[10] * x562 + sine[10] * x565 + x754;
  const Real x762 = x559 - (x590 - x556) * 0.2;
  // joint 10 "joint11": articulated-body inertia and bias force through it
  const Real x765 = tau[10] - (x713 + x580 * 0.053233300000000004 - x572 * 0.2);
  w.x[0] = x765;
  const Real x766 = 18.714921219539125 * x765;
  w.x[1] = x766;
  const Real x773 = x572 - (x492 + x580) * 0.2 - 0.2 * x766;
  const Real x774 = sine[10] * 0.2;
  const Real x776 = cosine[10] * 0.2;
  const Real x777 = 2.0 * sine[10];
  w.x[2] = x777;
  const Real x779 = cosine[10] * 0.053233300000000004;
  const Real x783 = cosine[10] * x779;
  const Real x787 = cosine[10] * 0.7485968487815651;
  const Real x788 = sine[10] * x787;
  const Real x790 = cosine[10] * x787;
  const Real x792 = 1.0 - x790;
  const Real x793 = 0.4 + x776;
  const Real x794 = 0.4 * x788;
  const Real x796 = 0.4 * x792;
  const Real x802 = sine[10] * x779 + 0.4 * x774;
  const Real x823 = sine[10] * x756 + cosine[10] * x773;
  const Real x830 = 0.0534333 + 0.4 * x796;
  const Real x831 = -0.2 - x796;
  const Real x809 = 0.0002 + x783 + 0.4 * x776 + 0.4 * x793;
  const Real x833 = 0.0534333 + x809;
  require_more(w, x833, 0.0, kFactorization, 9);
  const Real x834 = 0.2 + x793;
  const Real x835 = 0.25140315121843493 + x790 + 1.0;
  const Real x836 = 1.0 + x792;
  // link 10 "rod10": force that the reference field takes
  const Real x725 = x713 + x524 * 0.053233300000000004 - x498 * 0.2;
  // joint 10 "joint11": articulated-body inertia and bias force through it
  const Real x837 = tau[10] - 0.4 * x823 + x725;
  const Real x829 = sine[10] * x738 + cosine[10] * x750 + 0.4 * x762;
  const Real x820 = cosine[10] * x756 - sine[10] * x773;
  const Real x841 = x511 + x522 * 0.2 + x820;
  const Real x842 = x498 - x526 * 0.2 + x823;
  // joint 9 "joint10": articulated-body inertia and bias force through it
  const Real x844 = 1 / x833;
  w.x[3] = x844;
  // joint 10 "joint11": articulated-body inertia and bias force through it
  const Real x839 = x688 - x519 * 0.053233300000000004 + x507 * 0.2 + x829;
  // joint 9 "joint10": articulated-body inertia and bias force through it
  const Real x845 = tau[9] - x839;
  w.x[4] = x845;
  const Real x846 = x844 * x845;
  w.x[5] = x846;
  const Real x847 = x802 * x844;
  w.x[6] = x847;
  const Real x849 = x834 * x844;
  w.x[7] = x849;
  const Real x852 = 0.0534333 - x783 + 0.0002 - x802 * x847;
  const Real x855 = x802 * x849 - x774;
  const Real x858 = 2.0 - x834 * x849;
  // joint 10 "joint11": articulated-body inertia and bias force through it
  const Real x838 = cosine[10] * x738 - sine[10] * x750 + x495 * 0.0002;
  // joint 9 "joint10": articulated-body inertia and bias force through it
  const Real x861 = x838 - x802 * x846;
  const Real x863 = x507 - x520 * 0.2 + x762 + x834 * x846;
  const Real x864 = cosine[9] * x831;
  const Real x865 = sine[9] * x831;
  const Real x867 = sine[9] * (x855 - x794);
  const Real x869 = sine[9] * x867;
  const Real x873 = x855 - x869;
  const Real x874 = cosine[9] * x867;
  const Real x877 = cosine[9] * (x830 - x852);
  const Real x878 = 2.0 * sine[9];
  w.x[8] = x878;
  const Real x882 = cosine[9] * x877;
  const Real x885 = sine[9] * x788;
  const Real x887 = cosine[9] * x788;
  const Real x889 = cosine[9] * (x858 - x835);
  const Real x890 = sine[9] * x889;
  const Real x892 = cosine[9] * x889;
  const Real x893 = x835 + x892;
  const Real x895 = 0.4 * x885;
  const Real x899 = x864 - 0.4 * x836;
  const Real x900 = 0.4 * x893;
  const Real x916 = 0.4 * x873;
  const Real x927 = sine[9] * x877 - 0.4 * x865;
  const Real x938 = cosine[9] * x863 - sine[9] * x841;
  const Real x924 = x852 + x882 - (0.4 * x864 + 0.4 * x899);
  const Real x952 = x830 - x882 + 0.0002;
  require_more(w, x952, 0.0, kFactorization, 8);
  // link 9 "rod09": force that the reference field takes
  const Real x700 = x688 - x463 * 0.053233300000000004 + x450 * 0.2;
  const Real x703 = x434 * 0.0534333 + x468 * 0.053233300000000004 - x446 * 0.2;
  // joint 9 "joint10": articulated-body inertia and bias force through it
  const Real x947 = cosine[9] * x837 - sine[9] * x861 - 0.4 * x842;
  const Real x941 = sine[9] * x863 + cosine[9] * x841;
  // joint 8 "joint09": articulated-body inertia and bias force through it
  const Real x963 = 1 / x952;
  w.x[9] = x963;
  const Real x964 = tau[8] - (sine[9] * x837 + cosine[9] * x861 + x660);
  w.x[10] = x964;
  const Real x965 = x963 * x964;
  w.x[11] = x965;
  const Real x966 = x916 * x963;
  w.x[12] = x966;
  const Real x967 = x927 * x963;
  w.x[13] = x967;
  const Real x968 = x865 * x963;
  w.x[14] = x968;
  const Real x969 = x873 * x963;
  w.x[15] = x969;
  const Real x970 = x874 * x963;
  w.x[16] = x970;
  const Real x973 = 0.0534333 + 0.4 * x900 - x916 * x966;
  const Real x976 = 0.4 * x895 - 0.4 * x874 - x916 * x967;
  const Real x979 = x895 + x916 * x968;
  const Real x983 = 0.2 + x900 - x916 * x969;
  const Real x986 = 0.4 * x890 - x916 * x970;
  const Real x989 = 0.0534333 + x924 - x927 * x967;
  const Real x992 = -0.2 + x899 - x927 * x968;
  const Real x995 = x895 - x874 - x927 * x969;
  const Real x998 = x794 + x869 + 0.4 * x887 + x927 * x970;
  const Real x1002 = 1.0 + x836 - x865 * x968;
  const Real x1005 = x885 + x865 * x969;
  const Real x1009 = x887 - x865 * x970;
  const Real x1012 = 1.0 + x893 - x873 * x969;
  const Real x1015 = x890 - x873 * x970;
  const Real x1020 = tau[9] + 0.4 * x938 + x700 + x916 * x965;
  const Real x1022 = x703 + x947 + x927 * x965;
  const Real x1024 = x446 - x470 * 0.2 + x842 + x865 * x965;
  const Real x1026 = x450 - x464 * 0.2 + x938 + x873 * x965;
  const Real x1044 = cosine[8] * (x979 + x995) + sine[8] * (x983 + x992);
  const Real x1046 = sine[8] * x1044;
  const Real x1048 = x983 - x1046;
  const Real x1049 = x992 - x1046;
  const Real x1050 = cosine[8] * x1044;
  const Real x1053 = x1050 - x979;
  const Real x1056 = 2.0 * sine[8];
  const Real x1060 = cosine[8] * (x973 - x989) - x976 * x1056;
  const Real x1064 = cosine[8] * x1060;
  const Real x1070 = cosine[8] * x1009 - sine[8] * x1015;
  const Real x1073 = sine[8] * x1009 + cosine[8] * x1015;
  const Real x1078 = cosine[8] * (x1002 - x1012) + x1005 * x1056;
  const Real x1081 = sine[8] * x1078 - x1005;
  const Real x1082 = cosine[8] * x1078;
  const Real x1083 = x1012 + x1082;
  const Real x1084 = x1002 - x1082;
  const Real x1087 = cosine[8] * x986 + sine[8] * x998 + 0.4 * x1073;
  const Real x1091 = 0.4 * x1081;
  const Real x1093 = x995 - x1050 + x1091;
  const Real x1096 = x1049 - 0.4 * x1083;
  const Real x1099 = x1048 + 0.4 * x1084;
  const Real x1111 = x976 + sine[8] * x1060 + 0.4 * x1053;
  const Real x1112 = x1111 - 0.4 * x1093;
  const Real x1129 = cosine[8] * x1024 - sine[8] * x1026;
  const Real x1132 = sine[8] * x1024 + cosine[8] * x1026;
  const Real x1106 = x989 + x1064 + 0.4 * x1048 + 0.4 * x1099;
  const Real x1139 = 0.0534333 + x1106;
  require_more(w, x1139, 0.0, kFactorization, 7);
  const Real x1140 = 0.2 + x1099;
  const Real x1118 = x973 - x1064 - 0.4 * x1049 - 0.4 * x1096;
  const Real x1141 = 0.0534333 + x1118;
  const Real x1143 = x858 - x892 + 1.0 - x874 * x970 + 1.0;
  const Real x1144 = 1.0 + x1083;
  const Real x1145 = 1.0 + x1084;
  // link 8 "rod08": force that the reference field takes
  const Real x675 = x373 * 0.0534333 - x407 * 0.053233300000000004 + x376 * 0.2;
  // joint 8 "joint09": articulated-body inertia and bias force through it
  const Real x1135 = cosine[8] * x1020 - sine[8] * x1022 + 0.4 * x1132;
  const Real x1147 = x675 + x1135;
  // link 8 "rod08": force that the reference field takes
  const Real x678 = x309 * 0.0534333 + x397 * 0.053233300000000004 - x389 * 0.2;
  // joint 8 "joint09": articulated-body inertia and bias force through it
  const Real x1138 = sine[8] * x1020 + cosine[8] * x1022 - 0.4 * x1129;
  const Real x1148 = x678 + x1138;
  const Real x1028 = x437 + x466 * 0.2 + x941 + x874 * x965;
  const Real x1149 = x385 + x395 * 0.2 + x1028;
  const Real x1150 = x389 - x399 * 0.2 + x1129;
  const Real x1151 = x376 - x408 * 0.2 + x1132;
  // link 8 "rod08": mobility from its articulated-body inertia
  const Real x1153 = 1 / x1139;
  const Real x1154 = x1112 * x1153;
  const Real x1155 = x1087 * x1153;
  const Real x1156 = x1093 * x1153;
  const Real x1157 = x1140 * x1153;
  const Real x1160 = x1141 - x1112 * x1154;
  // joint 8 "joint09": articulated-body inertia and bias force through it
  const Real x1090 = sine[8] * x986 - cosine[8] * x998 - 0.4 * x1070;
  // link 8 "rod08": mobility from its articulated-body inertia
  const Real x1163 = x1090 - x1087 * x1154;
  const Real x1166 = -0.2 + x1096 - x1093 * x1154;
  const Real x1169 = x1053 - x1091 - x1140 * x1154;
  const Real x1170 = 1 / x1160;
  const Real x1171 = x1163 * x1170;
  const Real x1172 = x1166 * x1170;
  const Real x1173 = x1169 * x1170;
  const Real x1179 = x1143 - x1087 * x1155 - x1163 * x1171;
  const Real x1185 = x1070 - x1093 * x1155 - x1166 * x1171;
  const Real x1191 = x1073 - x1140 * x1155 - x1169 * x1171;
  const Real x1192 = 1 / x1179;
  const Real x1193 = x1185 * x1192;
  const Real x1194 = x1191 * x1192;
  const Real x1202 = x1144 - x1093 * x1156 - x1166 * x1172;
  const Real x1203 = x1202 - x1185 * x1193;
  const Real x1211 = x1081 - x1140 * x1156 - x1169 * x1172;
  const Real x1212 = x1211 - x1191 * x1193;
  const Real x1213 = 1 / x1203;
  const Real x1214 = x1212 * x1213;
  const Real x1224 = x1145 - x1140 * x1157 - x1169 * x1173;
  const Real x1226 = x1224 - x1191 * x1194 - x1212 * x1214;
  const Real x1227 = 1 / x1226;
  w.x[17] = x1227;
  const Real x1229 = x1141 * 1.7763568394002505e-15;
  require_more(w, x1160, x1229, kFactorization, 7);
  const Real x1230 = x1143 * 1.7763568394002505e-15;
  require_more(w, x1179, x1230, kFactorization, 7);
  const Real x1231 = x1144 * 1.7763568394002505e-15;
  require_more(w, x1203, x1231, kFactorization, 7);
  const Real x1232 = x1145 * 1.7763568394002505e-15;
  require_more(w, x1226, x1232, kFactorization, 7);
  const Real x1237 = x1154 * x1171 - x1155;
  const Real x1245 = x1154 * x1172 - x1156 - x1193 * x1237;
  const Real x1249 = x1171 * x1193 - x1172;
  const Real x1259 = x1154 * x1173 - x1157 - x1194 * x1237;
  const Real x1260 = x1259 - x1214 * x1245;
  const Real x1267 = x1171 * x1194 - x1173 - x1214 * x1249;
  const Real x1271 = x1193 * x1214 - x1194;
  const Real x1273 = x1154 * x1170;
  const Real x1275 = x1192 * x1237;
  const Real x1276 = x1171 * x1192;
  const Real x1278 = x1213 * x1245;
  const Real x1279 = x1213 * x1249;
  const Real x1280 = x1193 * x1213;
  const Real x1282 = x1227 * x1260;
  w.x[18] = x1282;
  const Real x1283 = x1227 * x1267;
  w.x[19] = x1283;
  const Real x1284 = x1227 * x1271;
  w.x[20] = x1284;
  const Real x1285 = x1214 * x1227;
  w.x[21] = x1285;
  const Real x1293 = x1153 + x1154 * x1273 + x1237 * x1275;
  const Real x1295 = x1245 * x1278 + x1293 + x1260 * x1282;
  w.x[22] = x1295;
  const Real x1302 = x1245 * x1279 - (x1273 + x1237 * x1276);
  const Real x1303 = x1260 * x1283 + x1302;
  w.x[23] = x1303;
  const Real x1308 = x1275 - x1245 * x1280 + x1260 * x1284;
  w.x[24] = x1308;
  const Real x1311 = x1278 - x1260 * x1285;
  w.x[25] = x1311;
  const Real x1317 = x1170 + x1171 * x1276 + x1249 * x1279;
  const Real x1318 = x1267 * x1283 + x1317;
  w.x[26] = x1318;
  const Real x1324 = x1267 * x1284 - (x1276 + x1249 * x1280);
  w.x[27] = x1324;
  const Real x1327 = x1279 - x1267 * x1285;
  w.x[28] = x1327;
  const Real x1332 = x1192 + x1193 * x1280 + x1271 * x1284;
  w.x[29] = x1332;
  const Real x1335 = x1280 + x1271 * x1285;
  w.x[30] = x1335;
  const Real x1339 = x1213 + x1214 * x1285;
  w.x[31] = x1339;
  const Real x1340 = (x660 + tau[8]) * 5000.0;
  w.x[32] = x1340;
  const Real x1347 = x1147 * x1295 + x1151 * x1282 + x1148 * x1303;
  const Real x1349 = x1149 * x1308 + x1347 + x1150 * x1311;
  w.x[33] = x1349;
  const Real x1356 = x1147 * x1303 + x1151 * x1283 + x1148 * x1318;
  const Real x1358 = x1149 * x1324 + x1356 + x1150 * x1327;
  w.x[34] = x1358;
  const Real x1366 = x1147 * x1308 + x1151 * x1284 + x1148 * x1324;
  const Real x1368 = x1149 * x1332 + x1366 - x1150 * x1335;
  w.x[35] = x1368;
  const Real x1377 = x1147 * x1311 - x1151 * x1285 + x1148 * x1327;
  const Real x1379 = x1377 - x1149 * x1335 + x1150 * x1339;
  w.x[36] = x1379;
  const Real x1387 = x1147 * x1282 + x1151 * x1227 + x1148 * x1283;
  const Real x1389 = x1149 * x1284 + x1387 - x1150 * x1285;
  w.x[37] = x1389;
  const Real x1390 = -x1340;
  w.to[1][15] = x1390;
  // joint 8 "joint09": mobility and acceleration beyond it
  const Real x1396 = 0.4 * x1303;
  const Real x1398 = x1311 - x1396;
  w.x[38] = x1398;
  const Real x1400 = x1282 + 0.4 * x1295;
  w.x[39] = x1400;
  const Real x1403 = x1327 - 0.4 * x1318;
  w.x[40] = x1403;
  const Real x1404 = x1283 + x1396;
  w.x[41] = x1404;
  const Real x1407 = x1335 + 0.4 * x1324;
  const Real x1410 = x1284 + 0.4 * x1308;
  const Real x1415 = x1339 - 0.4 * x1327;
  w.x[42] = x1415;
  const Real x1416 = x1415 - 0.4 * x1403;
  const Real x1420 = x1285 + 0.4 * x1283;
  w.x[43] = x1420;
  const Real x1422 = 0.4 * x1398 - x1420;
  const Real x1425 = x1227 + 0.4 * x1282;
  w.x[44] = x1425;
  const Real x1426 = 0.4 * x1400 + x1425;
  const Real x1429 = cosine[8] * x1308 + sine[8] * x1324;
  w.x[45] = x1429;
  const Real x1433 = cosine[8] * x1324 - sine[8] * x1308;
  w.x[46] = x1433;
  const Real x1438 = cosine[8] * (x1398 - x1404) + sine[8] * (x1400 + x1403);
  const Real x1439 = sine[8] * x1438;
  const Real x1440 = x1400 - x1439;
  w.x[47] = x1440;
  const Real x1441 = x1403 - x1439;
  w.x[48] = x1441;
  const Real x1442 = cosine[8] * x1438;
  const Real x1443 = x1404 + x1442;
  w.x[49] = x1443;
  const Real x1444 = x1398 - x1442;
  w.x[50] = x1444;
  const Real x1448 = cosine[8] * (x1295 - x1318) + x1056 * x1303;
  const Real x1450 = x1303 - sine[8] * x1448;
  w.x[51] = x1450;
  const Real x1451 = cosine[8] * x1448;
  const Real x1452 = x1318 + x1451;
  w.x[52] = x1452;
  const Real x1453 = x1295 - x1451;
  w.x[53] = x1453;
  const Real x1457 = sine[8] * x1410 - cosine[8] * x1407;
  w.x[54] = x1457;
  const Real x1461 = sine[8] * x1407 + cosine[8] * x1410;
  w.x[55] = x1461;
  const Real x1465 = cosine[8] * (x1416 - x1426) + x1056 * x1422;
  const Real x1467 = x1422 - sine[8] * x1465;
  w.x[56] = x1467;
  const Real x1468 = cosine[8] * x1465;
  const Real x1469 = x1426 + x1468;
  w.x[57] = x1469;
  const Real x1470 = x1416 - x1468;
  w.x[58] = x1470;
  const Real x1477 = x966 * x1452 + x970 * x1429 + x967 * x1450;
  const Real x1479 = x968 * x1443 + x1477 + x969 * x1440;
  w.x[59] = x1479;
  const Real x1487 = x966 * x1450 + x970 * x1433 + x967 * x1453;
  const Real x1489 = x968 * x1441 + x1487 + x969 * x1444;
  w.x[60] = x1489;
  const Real x1497 = x966 * x1443 + x970 * x1457 + x967 * x1441;
  const Real x1499 = x968 * x1469 + x1497 + x969 * x1467;
  w.x[61] = x1499;
  const Real x1507 = x966 * x1440 + x970 * x1461 + x967 * x1444;
  const Real x1509 = x968 * x1467 + x1507 + x969 * x1470;
  w.x[62] = x1509;
  const Real x1517 = x966 * x1429 + x970 * x1332 + x967 * x1433;
  const Real x1519 = x968 * x1457 + x1517 + x969 * x1461;
  w.x[63] = x1519;
  const Real x1533 = x966 * x1479 + x970 * x1519 + x967 * x1489;
  const Real x1539 = x968 * x1499 + x1533 + x969 * x1509 + x963;
  w.x[64] = x1539;
  const Real x1542 = 0.4 * x1358 - x1379;
  const Real x1545 = x1389 + 0.4 * x1349;
  const Real x1551 = cosine[8] * x1349 + sine[8] * x1358;
  w.x[65] = x1551;
  const Real x1557 = sine[8] * x1349 - cosine[8] * x1358;
  w.x[66] = x1557;
  const Real x1561 = cosine[8] * x1542 - sine[8] * x1545;
  w.x[67] = x1561;
  const Real x1566 = sine[8] * x1542 + cosine[8] * x1545;
  w.x[68] = x1566;
  const Real x1568 = x966 * x1551;
  w.x[69] = x1568;
  const Real x1570 = x967 * x1557;
  w.x[70] = x1570;
  const Real x1571 = x968 * x1561;
  w.x[71] = x1571;
}

ADAGEN_NOINLINE void part_1_1(Workspace& w) {
  ADAGEN_INPUTS
  const Real x766 = w.x[1];
  const Real x777 = w.x[2];
  const Real x844 = w.x[3];
  const Real x846 = w.x[5];
  const Real x847 = w.x[6];
  const Real x849 = w.x[7];
  const Real x878 = w.x[8];
  const Real x965 = w.x[11];
  const Real x966 = w.x[12];
  const Real x967 = w.x[13];
  const Real x968 = w.x[14];
  const Real x969 = w.x[15];
  const Real x970 = w.x[16];
  const Real x1282 = w.x[18];
  const Real x1283 = w.x[19];
  const Real x1284 = w.x[20];
  const Real x1285 = w.x[21];
  const Real x1295 = w.x[22];
  const Real x1303 = w.x[23];
  const Real x1308 = w.x[24];
  const Real x1311 = w.x[25];
  const Real x1318 = w.x[26];
  const Real x1324 = w.x[27];
  const Real x1327 = w.x[28];
  const Real x1332 = w.x[29];
  const Real x1335 = w.x[30];
  const Real x1368 = w.x[35];
  const Real x1398 = w.x[38];
  const Real x1400 = w.x[39];
  const Real x1403 = w.x[40];
  const Real x1404 = w.x[41];
  const Real x1415 = w.x[42];
  const Real x1420 = w.x[43];
  const Real x1425 = w.x[44];
  const Real x1429 = w.x[45];
  const Real x1433 = w.x[46];
  const Real x1440 = w.x[47];
  const Real x1441 = w.x[48];
  const Real x1443 = w.x[49];
  const Real x1444 = w.x[50];
  const Real x1450 = w.x[51];
  const Real x1452 = w.x[52];
  const Real x1453 = w.x[53];
  const Real x1457 = w.x[54];
  const Real x1461 = w.x[55];
  const Real x1467 = w.x[56];
  const Real x1469 = w.x[57];
  const Real x1470 = w.x[58];
  const Real x1479 = w.x[59];
  const Real x1489 = w.x[60];
  const Real x1499 = w.x[61];
  const Real x1509 = w.x[62];
  const Real x1519 = w.x[63];
  const Real x1539 = w.x[64];
  const Real x1551 = w.x[65];
  const Real x1557 = w.x[66];
  const Real x1561 = w.x[67];
  const Real x1566 = w.x[68];
  const Real x1568 = w.x[69];
  const Real x1570 = w.x[70];
  const Real x1571 = w.x[71];
  // joint 8 "joint09": mobility and acceleration beyond it
  const Real x1581 = x965 + x970 * x1368 + x1568 - x1570 - x1571;
  const Real x1582 = x969 * x1566 + x1581;
  const Real x1585 = sine[8] * x1303;
  const Real x1586 = cosine[8] * x1295 + x1585;
  const Real x1589 = cosine[8] * x1303;
  const Real x1590 = x1589 - sine[8] * x1295;
  const Real x1593 = cosine[8] * x1398 + sine[8] * x1400;
  const Real x1597 = cosine[8] * x1400 - sine[8] * x1398;
  const Real x1599 = x1589 + sine[8] * x1318;
  const Real x1602 = cosine[8] * x1318 - x1585;
  const Real x1605 = cosine[8] * x1403 + sine[8] * x1404;
  const Real x1609 = cosine[8] * x1404 - sine[8] * x1403;
  const Real x1611 = 0.4 * x1311 - x1285;
  const Real x1614 = cosine[8] * x1311 + sine[8] * x1327;
  const Real x1618 = cosine[8] * x1327 - sine[8] * x1311;
  const Real x1621 = cosine[8] * x1415 + sine[8] * x1611;
  const Real x1625 = cosine[8] * x1611 - sine[8] * x1415;
  const Real x1628 = cosine[8] * x1282 + sine[8] * x1283;
  const Real x1632 = cosine[8] * x1283 - sine[8] * x1282;
  const Real x1636 = sine[8] * x1425 - cosine[8] * x1420;
  const Real x1640 = sine[8] * x1420 + cosine[8] * x1425;
  const Real x1647 = x966 * x1586 + x970 * x1308 + x967 * x1590;
  const Real x1649 = x968 * x1593 + x1647 + x969 * x1597;
  const Real x1657 = x966 * x1599 + x970 * x1324 + x967 * x1602;
  const Real x1659 = x968 * x1605 + x1657 + x969 * x1609;
  const Real x1668 = x966 * x1614 - x970 * x1335 + x967 * x1618;
  const Real x1670 = x968 * x1621 + x1668 + x969 * x1625;
  const Real x1678 = x966 * x1628 + x970 * x1284 + x967 * x1632;
  const Real x1680 = x968 * x1636 + x1678 + x969 * x1640;
  // joint 9 "joint10": mobility and acceleration beyond it
  const Real x1682 = 0.4 * x1450;
  const Real x1689 = x1441 - 0.4 * x1453;
  const Real x1690 = x1444 + x1682;
  const Real x1693 = 0.4 * x1489 - x1499;
  const Real x1696 = x1509 + 0.4 * x1479;
  const Real x1708 = x1467 - 0.4 * x1444 + 0.4 * (x1443 - x1682);
  const Real x1711 = x1457 - 0.4 * x1433;
  const Real x1713 = 0.4 * (x1440 + 0.4 * x1452);
  const Real x1715 = x1470 + 0.4 * x1440 + x1713;
  const Real x1717 = x1461 + 0.4 * x1429;
  const Real x1720 = cosine[9] * x1689 + sine[9] * x1693;
  const Real x1724 = cosine[9] * x1693 - sine[9] * x1689;
  const Real x1736 = cosine[9] * (x1519 + x1690) + sine[9] * (x1433 - x1696);
  const Real x1737 = sine[9] * x1736;
  const Real x1739 = x1696 + x1737;
  const Real x1741 = cosine[9] * x1736;
  const Real x1742 = x1741 - x1519;
  const Real x1743 = x1690 - x1741;
  const Real x1758 = cosine[9] * (x1453 - x1539) - x878 * x1489;
  const Real x1760 = x1489 + sine[9] * x1758;
  const Real x1762 = cosine[9] * x1758;
  const Real x1764 = x1453 - x1762;
  const Real x1767 = cosine[9] * x1708 + sine[9] * x1711;
  const Real x1775 = cosine[9] * (x1715 - x1332) + x878 * x1717;
  const Real x1777 = x1717 - sine[9] * x1775;
  const Real x1778 = cosine[9] * x1775;
  const Real x1779 = x1332 + x1778;
  const Real x1780 = x1715 - x1778;
  const Real x1790 = x847 * x1764 + x849 * x1739;
  const Real x1800 = x847 * x1739 + x849 * x1779;
  const Real x1805 = x849 * x1777 - x847 * x1743;
  const Real x1810 = x849 * x1767 - x847 * x1724;
  const Real x1818 = x847 * x1790 + x849 * x1800 + x844;
  const Real x1824 = x1566 + 0.4 * x1551;
  const Real x1832 = cosine[9] * x1582 - sine[9] * x1557;
  const Real x1837 = cosine[9] * x1824 + sine[9] * x1368;
  const Real x1843 = sine[9] * x1824 - cosine[9] * x1368;
  const Real x1849 = x846 + x849 * x1837 + x847 * x1832;
  const Real x1855 = x1597 + 0.4 * x1586;
  const Real x1864 = sine[9] * x1590 + cosine[9] * x1649;
  const Real x1868 = cosine[9] * x1855 + sine[9] * x1308;
  const Real x1872 = cosine[9] * x1308 - sine[9] * x1855;
  const Real x1877 = x1609 + 0.4 * x1599;
  const Real x1886 = sine[9] * x1602 + cosine[9] * x1659;
  const Real x1890 = cosine[9] * x1877 + sine[9] * x1324;
  const Real x1894 = cosine[9] * x1324 - sine[9] * x1877;
  const Real x1903 = sine[9] * x1433 + cosine[9] * x1519;
  const Real x1907 = cosine[9] * x1717 + sine[9] * x1332;
  const Real x1911 = cosine[9] * x1332 - sine[9] * x1717;
  const Real x1916 = x1625 + 0.4 * x1614;
  const Real x1925 = sine[9] * x1618 + cosine[9] * x1670;
  const Real x1930 = cosine[9] * x1916 - sine[9] * x1335;
  const Real x1935 = sine[9] * x1916 + cosine[9] * x1335;
  const Real x1941 = x1640 + 0.4 * x1628;
  const Real x1950 = sine[9] * x1632 + cosine[9] * x1680;
  const Real x1954 = cosine[9] * x1941 + sine[9] * x1284;
  const Real x1958 = cosine[9] * x1284 - sine[9] * x1941;
  const Real x1962 = x847 * x1864 + x849 * x1868;
  const Real x1967 = x847 * x1886 + x849 * x1890;
  const Real x1972 = x847 * x1903 + x849 * x1907;
  const Real x1977 = x847 * x1925 + x849 * x1930;
  const Real x1982 = x847 * x1950 + x849 * x1954;
  // joint 10 "joint11": mobility and acceleration beyond it
  const Real x1984 = 0.4 * (x847 * x1760 + x849 * x1742);
  const Real x1991 = 0.4 * x1790 - x1739;
  const Real x1994 = x1724 + 0.4 * x1760;
  const Real x1996 = 0.4 * x1818 - x1800;
  const Real x1997 = x1984 - x1810;
  const Real x2002 = x1779 - 0.4 * x1800 + 0.4 * x1996;
  w.x[72] = x2002;
  const Real x2005 = x1777 - 0.4 * x1805;
  const Real x2011 = x1767 - 0.4 * x1810 - 0.4 * (x1742 - x1984);
  // joint 9 "joint10": mobility and acceleration beyond it
  const Real x1771 = cosine[9] * x1711 - sine[9] * x1708;
  // joint 10 "joint11": mobility and acceleration beyond it
  const Real x2014 = x1771 - 0.4 * (x1433 - x1737);
  // joint 9 "joint10": mobility and acceleration beyond it
  const Real x1703 = x1469 - 0.4 * x1441 - 0.4 * x1689;
  // joint 10 "joint11": mobility and acceleration beyond it
  const Real x2017 = 0.4 * (x1720 - 0.4 * (x1539 + x1762));
  const Real x2020 = x1703 - 0.4 * x1720 - x2017;
  const Real x2023 = cosine[10] * x1991 + sine[10] * x1996;
  w.x[73] = x2023;
  const Real x2027 = cosine[10] * x1996 - sine[10] * x1991;
  w.x[74] = x2027;
  const Real x2039 = cosine[10] * (x1743 - x1997) + sine[10] * (x1994 - x1805);
  const Real x2040 = sine[10] * x2039;
  const Real x2041 = x1994 - x2040;
  w.x[75] = x2041;
  const Real x2042 = x1805 + x2040;
  w.x[76] = x2042;
  const Real x2044 = cosine[10] * x2039;
  const Real x2045 = x1997 + x2044;
  w.x[77] = x2045;
  const Real x2046 = x1743 - x2044;
  w.x[78] = x2046;
  const Real x2061 = cosine[10] * (x1764 - x1818) + x777 * x1790;
  const Real x2063 = x1790 - sine[10] * x2061;
  w.x[79] = x2063;
  const Real x2064 = cosine[10] * x2061;
  const Real x2065 = x1818 + x2064;
  w.x[80] = x2065;
  const Real x2066 = x1764 - x2064;
  w.x[81] = x2066;
  const Real x2069 = cosine[10] * x2005 + sine[10] * x2011;
  w.x[82] = x2069;
  const Real x2073 = cosine[10] * x2011 - sine[10] * x2005;
  w.x[83] = x2073;
  const Real x2077 = cosine[10] * (x1780 - x2020) + x777 * x2014;
  const Real x2079 = x2014 - sine[10] * x2077;
  w.x[84] = x2079;
  const Real x2080 = cosine[10] * x2077;
  const Real x2081 = x2020 + x2080;
  w.x[85] = x2081;
  const Real x2082 = x1780 - x2080;
  w.x[86] = x2082;
  const Real x2084 = x2041 * 3.742984243907825;
  w.x[87] = x2084;
  const Real x2086 = x2046 * 3.742984243907825;
  w.x[88] = x2086;
  const Real x2090 = x2079 * 3.742984243907825;
  w.x[89] = x2090;
  const Real x2092 = x2082 * 3.742984243907825;
  w.x[90] = x2092;
  const Real x2094 = x2073 * 3.742984243907825;
  w.x[91] = x2094;
  const Real x2098 = 18.714921219539125 + 3.742984243907825 * x2092;
  w.x[92] = x2098;
  const Real x2100 = 0.4 * x1849 - x1837;
  w.x[93] = x2100;
  const Real x2101 = 0.4 * (cosine[9] * x1557 + sine[9] * x1582);
  const Real x2103 = x1561 - 0.4 * x1557 - x2101;
  const Real x2106 = cosine[10] * x1832 + sine[10] * x1849;
  w.x[94] = x2106;
  const Real x2110 = cosine[10] * x1849 - sine[10] * x1832;
  w.x[95] = x2110;
  const Real x2113 = cosine[10] * x1843 + sine[10] * x2103;
  w.x[96] = x2113;
  const Real x2117 = cosine[10] * x2103 - sine[10] * x1843;
  w.x[97] = x2117;
  const Real x2120 = x766 + 3.742984243907825 * x2117;
  w.x[98] = x2120;
  const Real x2124 = x1868 - 0.4 * x1962;
  w.x[99] = x2124;
  const Real x2125 = 0.4 * (cosine[9] * x1590 - sine[9] * x1649);
  const Real x2127 = x1593 - 0.4 * x1590 - x2125;
  const Real x2132 = cosine[10] * x1864 + sine[10] * x1962;
  w.x[100] = x2132;
  const Real x2138 = sine[10] * x1864 - cosine[10] * x1962;
  w.x[101] = x2138;
  const Real x2141 = cosine[10] * x1872 + sine[10] * x2127;
  w.x[102] = x2141;
  const Real x2145 = cosine[10] * x2127 - sine[10] * x1872;
  w.x[103] = x2145;
  const Real x2148 = x1890 - 0.4 * x1967;
  w.x[104] = x2148;
  const Real x2149 = 0.4 * (cosine[9] * x1602 - sine[9] * x1659);
  const Real x2151 = x1605 - 0.4 * x1602 - x2149;
  const Real x2156 = cosine[10] * x1886 + sine[10] * x1967;
  w.x[105] = x2156;
  const Real x2162 = sine[10] * x1886 - cosine[10] * x1967;
  w.x[106] = x2162;
  const Real x2165 = cosine[10] * x1894 + sine[10] * x2151;
  w.x[107] = x2165;
  const Real x2169 = cosine[10] * x2151 - sine[10] * x1894;
  w.x[108] = x2169;
  const Real x2172 = x1907 - 0.4 * x1972;
  w.x[109] = x2172;
  const Real x2175 = x1711 - 0.4 * (cosine[9] * x1433 - sine[9] * x1519);
  const Real x2180 = cosine[10] * x1903 + sine[10] * x1972;
  w.x[110] = x2180;
  const Real x2186 = sine[10] * x1903 - cosine[10] * x1972;
  w.x[111] = x2186;
  const Real x2189 = cosine[10] * x1911 + sine[10] * x2175;
  w.x[112] = x2189;
  const Real x2193 = cosine[10] * x2175 - sine[10] * x1911;
  w.x[113] = x2193;
  const Real x2196 = x1930 - 0.4 * x1977;
  w.x[114] = x2196;
  const Real x2197 = 0.4 * (cosine[9] * x1618 - sine[9] * x1670);
  const Real x2199 = x1621 - 0.4 * x1618 - x2197;
  const Real x2204 = cosine[10] * x1925 + sine[10] * x1977;
  w.x[115] = x2204;
  const Real x2210 = sine[10] * x1925 - cosine[10] * x1977;
  w.x[116] = x2210;
  const Real x2214 = sine[10] * x2199 - cosine[10] * x1935;
  w.x[117] = x2214;
  const Real x2218 = sine[10] * x1935 + cosine[10] * x2199;
  w.x[118] = x2218;
  const Real x2221 = x1954 - 0.4 * x1982;
  w.x[119] = x2221;
  const Real x2222 = 0.4 * (cosine[9] * x1632 - sine[9] * x1680);
  const Real x2224 = x1636 - 0.4 * x1632 - x2222;
  const Real x2229 = cosine[10] * x1950 + sine[10] * x1982;
  w.x[120] = x2229;
  const Real x2235 = sine[10] * x1950 - cosine[10] * x1982;
  w.x[121] = x2235;
  const Real x2238 = cosine[10] * x1958 + sine[10] * x2224;
  w.x[122] = x2238;
  const Real x2242 = cosine[10] * x2224 - sine[10] * x1958;
  w.x[123] = x2242;
  const Real x2243 = 3.742984243907825 * x2145;
  w.x[124] = x2243;
  const Real x2245 = 3.742984243907825 * x2169;
  w.x[125] = x2245;
  const Real x2247 = 3.742984243907825 * x2193;
  w.x[126] = x2247;
  const Real x2249 = 3.742984243907825 * x2218;
  w.x[127] = x2249;
  const Real x2251 = 3.742984243907825 * x2242;
  w.x[128] = x2251;
}

ADAGEN_NOINLINE void part_1_2(Workspace& w) {
  ADAGEN_INPUTS
  const Real x1227 = w.x[17];
  const Real x1282 = w.x[18];
  const Real x1283 = w.x[19];
  const Real x1284 = w.x[20];
  const Real x1285 = w.x[21];
  const Real x1295 = w.x[22];
  const Real x1303 = w.x[23];
  const Real x1308 = w.x[24];
  const Real x1311 = w.x[25];
  const Real x1318 = w.x[26];
  const Real x1324 = w.x[27];
  const Real x1327 = w.x[28];
  const Real x1332 = w.x[29];
  const Real x1335 = w.x[30];
  const Real x1339 = w.x[31];
  const Real x1349 = w.x[33];
  const Real x1358 = w.x[34];
  const Real x1368 = w.x[35];
  const Real x1379 = w.x[36];
  const Real x1389 = w.x[37];
  const Real x2002 = w.x[72];
  const Real x2023 = w.x[73];
  const Real x2027 = w.x[74];
  const Real x2041 = w.x[75];
  const Real x2042 = w.x[76];
  const Real x2045 = w.x[77];
  const Real x2046 = w.x[78];
  const Real x2063 = w.x[79];
  const Real x2066 = w.x[81];
  const Real x2069 = w.x[82];
  const Real x2073 = w.x[83];
  const Real x2079 = w.x[84];
  const Real x2081 = w.x[85];
  const Real x2082 = w.x[86];
  const Real x2084 = w.x[87];
  const Real x2086 = w.x[88];
  const Real x2090 = w.x[89];
  const Real x2092 = w.x[90];
  const Real x2094 = w.x[91];
  const Real x2098 = w.x[92];
  const Real x2100 = w.x[93];
  const Real x2110 = w.x[95];
  const Real x2113 = w.x[96];
  const Real x2117 = w.x[97];
  const Real x2120 = w.x[98];
  const Real x2124 = w.x[99];
  const Real x2132 = w.x[100];
  const Real x2138 = w.x[101];
  const Real x2141 = w.x[102];
  const Real x2145 = w.x[103];
  const Real x2148 = w.x[104];
  const Real x2156 = w.x[105];
  const Real x2162 = w.x[106];
  const Real x2165 = w.x[107];
  const Real x2169 = w.x[108];
  const Real x2172 = w.x[109];
  const Real x2180 = w.x[110];
  const Real x2186 = w.x[111];
  const Real x2189 = w.x[112];
  const Real x2193 = w.x[113];
  const Real x2196 = w.x[114];
  const Real x2204 = w.x[115];
  const Real x2210 = w.x[116];
  const Real x2214 = w.x[117];
  const Real x2218 = w.x[118];
  const Real x2221 = w.x[119];
  const Real x2229 = w.x[120];
  const Real x2235 = w.x[121];
  const Real x2238 = w.x[122];
  const Real x2242 = w.x[123];
  const Real x2243 = w.x[124];
  const Real x2245 = w.x[125];
  const Real x2247 = w.x[126];
  const Real x2249 = w.x[127];
  const Real x2251 = w.x[128];
  // message received
  const Real x2253 = w.from[0][0];
  const Real x2254 = w.from[0][1];
  const Real x2259 = w.from[0][6];
  const Real x2256 = w.from[0][3];
  const Real x2261 = w.from[0][8];
  const Real x2268 = w.from[0][15];
  const Real x2257 = w.from[0][4];
  const Real x2262 = w.from[0][9];
  const Real x2269 = w.from[0][16];
  const Real x2271 = w.from[0][18];
  const Real x2258 = w.from[0][5];
  const Real x2263 = w.from[0][10];
  const Real x2270 = w.from[0][17];
  const Real x2272 = w.from[0][19];
  const Real x2255 = w.from[0][2];
  const Real x2260 = w.from[0][7];
  const Real x2274 = w.from[0][21];
  const Real x2273 = w.from[0][20];
  const Real x2265 = w.from[0][12];
  const Real x2275 = w.from[0][22];
  const Real x2266 = w.from[0][13];
  const Real x2277 = w.from[0][24];
  const Real x2267 = w.from[0][14];
  const Real x2278 = w.from[0][25];
  const Real x2279 = w.from[0][26];
  const Real x2264 = w.from[0][11];
  w.x[71] = x2264;
  const Real x2276 = w.from[0][23];
  w.x[70] = x2276;
  // joint 11 "joint12": assembly: its two sides become one chain
  const Real x2351 = 2.0 * sine[11];
  const Real x2622 = x2221 + 0.4 * x2235;
  const Real x2546 = x2124 + 0.4 * x2138;
  const Real x2565 = x2148 + 0.4 * x2162;
  const Real x2544 = x2145 - 0.4 * x2243;
  const Real x2549 = cosine[11] * x2138 + sine[11] * x2243;
  w.x[69] = x2549;
  const Real x2563 = x2169 - 0.4 * x2245;
  const Real x2568 = cosine[11] * x2162 + sine[11] * x2245;
  w.x[68] = x2568;
  const Real x2582 = x2193 - 0.4 * x2247;
  const Real x2584 = x2172 + 0.4 * x2186;
  const Real x2587 = cosine[11] * x2186 + sine[11] * x2247;
  w.x[67] = x2587;
  const Real x2601 = x2218 - 0.4 * x2249;
  const Real x2603 = x2196 + 0.4 * x2210;
  const Real x2606 = cosine[11] * x2210 + sine[11] * x2249;
  w.x[66] = x2606;
  const Real x2620 = x2242 - 0.4 * x2251;
  const Real x2625 = cosine[11] * x2235 + sine[11] * x2251;
  w.x[65] = x2625;
  const Real x2400 = x2100 + 0.4 * x2110;
  const Real x2398 = x2117 - 0.4 * x2120;
  const Real x2395 = x2081 + x2273;
  w.x[64] = x2395;
  const Real x2389 = x2045 + x2267;
  w.x[63] = x2389;
  const Real x2286 = 0.4 * x2086;
  const Real x2300 = x2069 - 0.4 * x2042;
  const Real x2288 = x2046 - x2286;
  const Real x2290 = x2027 + 0.4 * x2066;
  const Real x2294 = x2094 + x2286;
  const Real x2297 = x2079 - 0.4 * x2090;
  const Real x2380 = sine[11] * x2090 - cosine[11] * x2042 + x2258;
  const Real x2293 = x2092 - 0.4 * x2098;
  const Real x2311 = x2073 - 0.4 * x2094 + 0.4 * x2288;
  const Real x2315 = x2002 + 0.4 * x2027 + 0.4 * x2290;
  const Real x2283 = x2041 - 0.4 * x2084;
  const Real x2285 = x2023 + 0.4 * x2063;
  const Real x2353 = cosine[11] * (x2066 - x2098) + x2086 * x2351;
  const Real x2377 = cosine[11] * x2063 + sine[11] * x2084 + x2255;
  w.x[62] = x2377;
  const Real x2356 = cosine[11] * x2353;
  const Real x2306 = x2082 - 0.4 * x2092 - 0.4 * x2293;
  const Real x2335 = cosine[11] * (x2288 - x2294) + sine[11] * (x2290 + x2293);
  const Real x2382 = cosine[11] * x2084 - sine[11] * x2063 + x2260;
  w.x[61] = x2382;
  const Real x2387 = cosine[11] * x2283 + sine[11] * x2285 + x2265;
  w.x[60] = x2387;
  const Real x2415 = cosine[11] * x2110 + sine[11] * x2120 - x2274;
  const Real x2427 = x2415 - tau[11] * x2377;
  w.x[59] = x2427;
  const Real x2375 = x2098 + x2356 + x2253;
  require_more(w, x2375, 0.0, kFactorization, 11);
  const Real x2376 = x2086 - sine[11] * x2353 + x2254;
  const Real x2381 = x2066 - x2356 + x2259;
  w.x[58] = x2381;
  const Real x2339 = cosine[11] * x2335;
  const Real x2336 = sine[11] * x2335;
  const Real x2388 = cosine[11] * x2285 - sine[11] * x2283 + x2266;
  w.x[57] = x2388;
  const Real x2433 = 1 / x2375;
  w.x[56] = x2433;
  const Real x2369 = cosine[11] * (x2306 - x2315) + x2311 * x2351;
  const Real x2416 = cosine[11] * x2120 - sine[11] * x2110 - x2275;
  const Real x2418 = cosine[11] * x2398 + sine[11] * x2400 - x2277;
  const Real x2378 = x2294 + x2339 + x2256;
  const Real x2372 = cosine[11] * x2369;
  const Real x2379 = x2290 - x2336 + x2257;
  const Real x2419 = cosine[11] * x2400 - sine[11] * x2398 - x2278;
  const Real x2390 = x2315 + x2372 + x2268;
  w.x[55] = x2390;
  const Real x2434 = x2376 * x2433;
  w.x[54] = x2434;
  const Real x2435 = x2378 * x2433;
  w.x[53] = x2435;
  const Real x2436 = x2379 * x2433;
  w.x[52] = x2436;
  const Real x2393 = x2306 - x2372 + x2271;
  w.x[51] = x2393;
  const Real x2437 = x2380 * x2433;
  w.x[50] = x2437;
  const Real x2787 = x2433 * x2549;
  const Real x2788 = x2433 * x2568;
  const Real x2789 = x2433 * x2587;
  const Real x2790 = x2433 * x2606;
  const Real x2791 = x2433 * x2625;
  const Real x2440 = x2381 - x2376 * x2434;
  w.x[49] = x2440;
  const Real x2443 = x2293 - x2336 + x2261 - x2378 * x2434;
  const Real x2446 = x2288 - x2339 + x2262 - x2379 * x2434;
  const Real x2385 = sine[11] * x2042 + cosine[11] * x2090 + x2263;
  const Real x2449 = x2385 - x2380 * x2434;
  const Real x2392 = cosine[11] * x2297 + sine[11] * x2300 + x2270;
  const Real x2394 = cosine[11] * x2300 - sine[11] * x2297 + x2272;
  const Real x2450 = 1 / x2440;
  w.x[48] = x2450;
  const Real x2639 = cosine[11] * x2243 - sine[11] * x2138 - x2434 * x2549;
  w.x[47] = x2639;
  const Real x2642 = cosine[11] * x2245 - sine[11] * x2162 - x2434 * x2568;
  w.x[46] = x2642;
  const Real x2645 = cosine[11] * x2247 - sine[11] * x2186 - x2434 * x2587;
  w.x[45] = x2645;
  const Real x2648 = cosine[11] * x2249 - sine[11] * x2210 - x2434 * x2606;
  w.x[44] = x2648;
  const Real x2651 = cosine[11] * x2251 - sine[11] * x2235 - x2434 * x2625;
  w.x[43] = x2651;
  const Real x2514 = x2416 - tau[11] * x2382 - x2427 * x2434;
  w.x[42] = x2514;
  const Real x2451 = x2443 * x2450;
  w.x[41] = x2451;
  const Real x2452 = x2446 * x2450;
  w.x[40] = x2452;
  const Real x2453 = x2449 * x2450;
  w.x[39] = x2453;
  const Real x2459 = x2390 - x2378 * x2435 - x2443 * x2451;
  w.x[38] = x2459;
  const Real x2464 = x2311 - sine[11] * x2369 + x2269 - x2379 * x2435;
  const Real x2465 = x2464 - x2446 * x2451;
  const Real x2471 = x2392 - x2380 * x2435 - x2449 * x2451;
  const Real x2656 = cosine[11] * x2544 + sine[11] * x2546 - x2435 * x2549;
  const Real x2657 = x2656 - x2451 * x2639;
  w.x[11] = x2657;
  const Real x2662 = cosine[11] * x2563 + sine[11] * x2565 - x2435 * x2568;
  const Real x2663 = x2662 - x2451 * x2642;
  w.x[8] = x2663;
  const Real x2668 = cosine[11] * x2582 + sine[11] * x2584 - x2435 * x2587;
  const Real x2669 = x2668 - x2451 * x2645;
  w.x[5] = x2669;
  const Real x2674 = cosine[11] * x2601 + sine[11] * x2603 - x2435 * x2606;
  const Real x2675 = x2674 - x2451 * x2648;
  w.x[2] = x2675;
  const Real x2472 = 1 / x2459;
  w.x[1] = x2472;
  const Real x2680 = cosine[11] * x2620 + sine[11] * x2622 - x2435 * x2625;
  const Real x2681 = x2680 - x2451 * x2651;
  w.x[129] = x2681;
  const Real x2519 = x2418 - tau[11] * x2387 - x2427 * x2435;
  const Real x2520 = x2519 - x2451 * x2514;
  w.x[130] = x2520;
  const Real x2688 = cosine[11] * x2546 - sine[11] * x2544 - x2436 * x2549;
  const Real x2697 = cosine[11] * x2565 - sine[11] * x2563 - x2436 * x2568;
  const Real x2706 = cosine[11] * x2584 - sine[11] * x2582 - x2436 * x2587;
  const Real x2715 = cosine[11] * x2603 - sine[11] * x2601 - x2436 * x2606;
  const Real x2724 = cosine[11] * x2622 - sine[11] * x2620 - x2436 * x2625;
  const Real x2527 = x2419 - tau[11] * x2388 - x2427 * x2436;
  const Real x2792 = x2450 * x2639;
  const Real x2793 = x2450 * x2642;
  const Real x2794 = x2450 * x2645;
  const Real x2795 = x2450 * x2648;
  const Real x2796 = x2450 * x2651;
  const Real x2538 = x2113 - x2279 - tau[11] * x2389 - x2427 * x2437;
  const Real x2473 = x2465 * x2472;
  w.x[131] = x2473;
  const Real x2474 = x2471 * x2472;
  w.x[132] = x2474;
  const Real x2797 = x2472 * x2657;
  const Real x2798 = x2472 * x2663;
  const Real x2799 = x2472 * x2669;
  const Real x2800 = x2472 * x2675;
  const Real x2801 = x2472 * x2681;
  const Real x2482 = x2393 - x2379 * x2436 - x2446 * x2452;
  const Real x2483 = x2482 - x2465 * x2473;
  w.x[133] = x2483;
  const Real x2491 = x2394 - x2380 * x2436 - x2449 * x2452;
  const Real x2492 = x2491 - x2471 * x2473;
  const Real x2504 = x2395 - x2380 * x2437 - x2449 * x2453;
  const Real x2690 = x2688 - x2452 * x2639 - x2473 * x2657;
  w.x[134] = x2690;
  const Real x2699 = x2697 - x2452 * x2642 - x2473 * x2663;
  w.x[135] = x2699;
  const Real x2708 = x2706 - x2452 * x2645 - x2473 * x2669;
  w.x[136] = x2708;
  const Real x2717 = x2715 - x2452 * x2648 - x2473 * x2675;
  w.x[137] = x2717;
  const Real x2726 = x2724 - x2452 * x2651 - x2473 * x2681;
  w.x[138] = x2726;
  const Real x2493 = 1 / x2483;
  w.x[139] = x2493;
  const Real x2529 = x2527 - x2452 * x2514 - x2473 * x2520;
  w.x[140] = x2529;
  const Real x2736 = x2141 - x2437 * x2549 - x2453 * x2639;
  const Real x2748 = x2165 - x2437 * x2568 - x2453 * x2642;
  const Real x2760 = x2189 - x2437 * x2587 - x2453 * x2645;
  const Real x2772 = x2214 - x2437 * x2606 - x2453 * x2648;
  const Real x2784 = x2238 - x2437 * x2625 - x2453 * x2651;
  const Real x2494 = x2492 * x2493;
  w.x[141] = x2494;
  const Real x2802 = x2493 * x2690;
  const Real x2803 = x2493 * x2699;
  const Real x2804 = x2493 * x2708;
  const Real x2805 = x2493 * x2717;
  const Real x2806 = x2493 * x2726;
  const Real x2506 = x2504 - x2471 * x2474 - x2492 * x2494;
  w.x[142] = x2506;
  const Real x2738 = x2736 - x2474 * x2657 - x2494 * x2690;
  w.x[143] = x2738;
  const Real x2750 = x2748 - x2474 * x2663 - x2494 * x2699;
  w.x[144] = x2750;
  const Real x2762 = x2760 - x2474 * x2669 - x2494 * x2708;
  w.x[145] = x2762;
  const Real x2774 = x2772 - x2474 * x2675 - x2494 * x2717;
  w.x[146] = x2774;
  const Real x2786 = x2784 - x2474 * x2681 - x2494 * x2726;
  w.x[147] = x2786;
  const Real x2540 = x2538 - x2453 * x2514 - x2474 * x2520;
  const Real x2541 = x2540 - x2494 * x2529;
  w.x[148] = x2541;
  const Real x2507 = 1 / x2506;
  w.x[149] = x2507;
  const Real x2807 = x2507 * x2738;
  const Real x2808 = x2507 * x2750;
  const Real x2809 = x2507 * x2762;
  const Real x2810 = x2507 * x2774;
  const Real x2811 = x2507 * x2786;
  const Real x3063 = x2427 * x2787 + x2514 * x2792 + x2520 * x2797;
  const Real x3072 = x2427 * x2788 + x2514 * x2793 + x2520 * x2798;
  const Real x3081 = x2427 * x2789 + x2514 * x2794 + x2520 * x2799;
  const Real x3090 = x2427 * x2790 + x2514 * x2795 + x2520 * x2800;
  const Real x3099 = x2427 * x2791 + x2514 * x2796 + x2520 * x2801;
  const Real x2823 = x1295 - x2549 * x2787 - x2639 * x2792;
  const Real x2838 = x1303 - x2549 * x2788 - x2639 * x2793;
  const Real x2853 = x1308 - x2549 * x2789 - x2639 * x2794;
  const Real x2868 = x1311 - x2549 * x2790 - x2639 * x2795;
  const Real x2883 = x1282 - x2549 * x2791 - x2639 * x2796;
  const Real x2898 = x1318 - x2568 * x2788 - x2642 * x2793;
  const Real x2913 = x1324 - x2568 * x2789 - x2642 * x2794;
  const Real x2928 = x1327 - x2568 * x2790 - x2642 * x2795;
  const Real x2943 = x1283 - x2568 * x2791 - x2642 * x2796;
  const Real x2958 = x1332 - x2587 * x2789 - x2645 * x2794;
  const Real x2974 = x1335 + x2587 * x2790 + x2645 * x2795;
  const Real x2993 = x1284 - x2587 * x2791 - x2645 * x2796;
  const Real x3008 = x1339 - x2606 * x2790 - x2648 * x2795;
  const Real x3024 = x1285 + x2606 * x2791 + x2648 * x2796;
  const Real x3043 = x1227 - x2625 * x2791 - x2651 * x2796;
  const Real x3065 = x2529 * x2802 + x3063 + x2541 * x2807;
  const Real x3074 = x2529 * x2803 + x3072 + x2541 * x2808;
  const Real x3083 = x2529 * x2804 + x3081 + x2541 * x2809;
  const Real x3092 = x2529 * x2805 + x3090 + x2541 * x2810;
  const Real x3101 = x2529 * x2806 + x3099 + x2541 * x2811;
  const Real x2825 = x2823 - x2657 * x2797 - x2690 * x2802;
  const Real x2826 = x2825 - x2738 * x2807;
  w.to[1][0] = x2826;
  const Real x2840 = x2838 - x2657 * x2798 - x2690 * x2803;
  const Real x2841 = x2840 - x2738 * x2808;
  w.to[1][1] = x2841;
  const Real x2855 = x2853 - x2657 * x2799 - x2690 * x2804;
  const Real x2856 = x2855 - x2738 * x2809;
  w.to[1][2] = x2856;
  const Real x2870 = x2868 - x2657 * x2800 - x2690 * x2805;
  const Real x2871 = x2870 - x2738 * x2810;
  w.to[1][3] = x2871;
  const Real x2885 = x2883 - x2657 * x2801 - x2690 * x2806;
  const Real x2886 = x2885 - x2738 * x2811;
  w.to[1][4] = x2886;
  const Real x2900 = x2898 - x2663 * x2798 - x2699 * x2803;
  const Real x2901 = x2900 - x2750 * x2808;
  w.to[1][5] = x2901;
  const Real x2915 = x2913 - x2663 * x2799 - x2699 * x2804;
  const Real x2916 = x2915 - x2750 * x2809;
  w.to[1][6] = x2916;
  const Real x2930 = x2928 - x2663 * x2800 - x2699 * x2805;
  const Real x2931 = x2930 - x2750 * x2810;
  w.to[1][7] = x2931;
  const Real x2945 = x2943 - x2663 * x2801 - x2699 * x2806;
  const Real x2946 = x2945 - x2750 * x2811;
  w.to[1][8] = x2946;
  const Real x2960 = x2958 - x2669 * x2799 - x2708 * x2804;
  const Real x2961 = x2960 - x2762 * x2809;
  w.to[1][9] = x2961;
  const Real x2978 = x2669 * x2800 + x2974 + x2708 * x2805;
  const Real x2995 = x2993 - x2669 * x2801 - x2708 * x2806;
  const Real x2996 = x2995 - x2762 * x2811;
  w.to[1][11] = x2996;
  const Real x3010 = x3008 - x2675 * x2800 - x2717 * x2805;
  const Real x3011 = x3010 - x2774 * x2810;
  w.to[1][12] = x3011;
  const Real x3028 = x2675 * x2801 + x3024 + x2717 * x2806;
  const Real x3045 = x3043 - x2681 * x2801 - x2726 * x2806;
  const Real x3046 = x3045 - x2786 * x2811;
  w.to[1][14] = x3046;
  const Real x2981 = -(x2762 * x2810 + x2978);
  w.to[1][10] = x2981;
  const Real x3031 = -(x2774 * x2811 + x3028);
  w.to[1][13] = x3031;
  const Real x3108 = -(x3065 - x2132 * tau[11] + x1349);
  w.to[1][16] = x3108;
  const Real x3110 = -(x3074 - x2156 * tau[11] + x1358);
  w.to[1][17] = x3110;
  const Real x3112 = -(x3083 - x2180 * tau[11] + x1368);
  w.to[1][18] = x3112;
  const Real x3114 = -(x3092 - x2204 * tau[11] + x1379);
  w.to[1][19] = x3114;
  const Real x3116 = -(x3101 - x2229 * tau[11] + x1389);
  w.to[1][20] = x3116;
}

ADAGEN_NOINLINE void part_1_3(Workspace& w) {
  ADAGEN_INPUTS
  const Real x2065 = w.x[80];
  const Real x2106 = w.x[94];
  const Real x2264 = w.x[71];
  const Real x2276 = w.x[70];
  const Real x2381 = w.x[58];
  const Real x2390 = w.x[55];
  const Real x2393 = w.x[51];
  const Real x2395 = w.x[64];
  const Real x2440 = w.x[49];
  const Real x2459 = w.x[38];
  const Real x2483 = w.x[133];
  const Real x2506 = w.x[142];
  // joint 11 "joint12": assembly: its two sides become one chain
  const Real x2511 = 1.7763568394002505e-15 * x2395;
  require_more(w, x2506, x2511, kFactorization, 11);
  const Real x2429 = x2106 - x2276 - tau[11] * (x2065 + x2264);
  w.x[128] = x2429;
  const Real x2508 = 1.7763568394002505e-15 * x2381;
  require_more(w, x2440, x2508, kFactorization, 11);
  const Real x2509 = 1.7763568394002505e-15 * x2390;
  require_more(w, x2459, x2509, kFactorization, 11);
  const Real x2510 = 1.7763568394002505e-15 * x2393;
  require_more(w, x2483, x2510, kFactorization, 11);
}

ADAGEN_NOINLINE void part_1_4(Workspace& w) {
  ADAGEN_INPUTS
  const Real x2427 = w.x[59];
  const Real x2433 = w.x[56];
  const Real x2434 = w.x[54];
  const Real x2435 = w.x[53];
  const Real x2436 = w.x[52];
  const Real x2437 = w.x[50];
  const Real x2450 = w.x[48];
  const Real x2451 = w.x[41];
  const Real x2452 = w.x[40];
  const Real x2453 = w.x[39];
  const Real x2472 = w.x[1];
  const Real x2473 = w.x[131];
  const Real x2474 = w.x[132];
  const Real x2493 = w.x[139];
  const Real x2494 = w.x[141];
  const Real x2507 = w.x[149];
  const Real x2514 = w.x[42];
  const Real x2520 = w.x[130];
  const Real x2529 = w.x[140];
  const Real x2541 = w.x[148];
  const Real x2549 = w.x[69];
  const Real x2568 = w.x[68];
  const Real x2587 = w.x[67];
  const Real x2606 = w.x[66];
  const Real x2625 = w.x[65];
  const Real x2639 = w.x[47];
  const Real x2642 = w.x[46];
  const Real x2645 = w.x[45];
  const Real x2648 = w.x[44];
  const Real x2651 = w.x[43];
  const Real x2657 = w.x[11];
  const Real x2663 = w.x[8];
  const Real x2669 = w.x[5];
  const Real x2675 = w.x[2];
  const Real x2681 = w.x[129];
  const Real x2690 = w.x[134];
  const Real x2699 = w.x[135];
  const Real x2708 = w.x[136];
  const Real x2717 = w.x[137];
  const Real x2726 = w.x[138];
  const Real x2738 = w.x[143];
  const Real x2750 = w.x[144];
  const Real x2762 = w.x[145];
  const Real x2774 = w.x[146];
  const Real x2786 = w.x[147];
  // message received
  const Real x3118 = w.from[2][1];
  w.x[142] = x3118;
  const Real x3119 = w.from[2][2];
  w.x[133] = x3119;
  const Real x3120 = w.from[2][3];
  w.x[38] = x3120;
  const Real x3121 = w.from[2][4];
  w.x[49] = x3121;
  const Real x3122 = w.from[2][5];
  w.x[64] = x3122;
  const Real x3117 = w.from[2][0];
  w.x[51] = x3117;
  // joint 11 "joint12": disassembly: its acceleration and force
  const Real x3130 = x2549 * x3118 + x2625 * x3122 + x2568 * x3119;
  const Real x3169 = x2587 * x3120 + x3130 + x2606 * x3121 + x2427;
  const Real x3139 = x2639 * x3118 + x2642 * x3119 + x2645 * x3120;
  const Real x3170 = x2648 * x3121 + x3139 + x2651 * x3122 + x2514;
  const Real x3148 = x2657 * x3118 + x2663 * x3119 + x2669 * x3120;
  const Real x3171 = x2675 * x3121 + x3148 + x2681 * x3122 + x2520;
  const Real x3157 = x2690 * x3118 + x2699 * x3119 + x2708 * x3120;
  const Real x3172 = x2717 * x3121 + x3157 + x2726 * x3122 + x2529;
  const Real x3166 = x2738 * x3118 + x2750 * x3119 + x2762 * x3120;
  const Real x3173 = x2774 * x3121 + x3166 + x2786 * x3122 + x2541;
  const Real x3197 = x2507 * x3173;
  w.x[55] = x3197;
  w.to[3][5] = x3197;
  const Real x3200 = x2493 * x3172 - x2494 * x3197;
  w.x[58] = x3200;
  w.to[3][4] = x3200;
  const Real x3206 = x2472 * x3171 - x2474 * x3197 - x2473 * x3200;
  w.x[70] = x3206;
  w.to[3][3] = x3206;
  const Real x3214 = x2450 * x3170 - x2453 * x3197 - x2452 * x3200;
  const Real x3215 = x3214 - x2451 * x3206;
  w.x[71] = x3215;
  w.to[3][1] = x3215;
  const Real x3225 = x2433 * x3169 - x2437 * x3197 - x2436 * x3200;
  const Real x3227 = x3225 - x2435 * x3206 - x2434 * x3215;
  w.x[94] = x3227;
  w.to[3][0] = x3227;
}

ADAGEN_NOINLINE void part_1_5(Workspace& w) {
  ADAGEN_INPUTS
  const Real x765 = w.x[0];
  const Real x844 = w.x[3];
  const Real x845 = w.x[4];
  const Real x847 = w.x[6];
  const Real x849 = w.x[7];
  const Real x963 = w.x[9];
  const Real x964 = w.x[10];
  const Real x966 = w.x[12];
  const Real x967 = w.x[13];
  const Real x968 = w.x[14];
  const Real x969 = w.x[15];
  const Real x970 = w.x[16];
  const Real x1227 = w.x[17];
  const Real x1282 = w.x[18];
  const Real x1283 = w.x[19];
  const Real x1284 = w.x[20];
  const Real x1285 = w.x[21];
  const Real x1295 = w.x[22];
  const Real x1303 = w.x[23];
  const Real x1308 = w.x[24];
  const Real x1311 = w.x[25];
  const Real x1318 = w.x[26];
  const Real x1324 = w.x[27];
  const Real x1327 = w.x[28];
  const Real x1332 = w.x[29];
  const Real x1335 = w.x[30];
  const Real x1339 = w.x[31];
  const Real x1340 = w.x[32];
  const Real x1349 = w.x[33];
  const Real x1358 = w.x[34];
  const Real x1368 = w.x[35];
  const Real x1379 = w.x[36];
  const Real x1389 = w.x[37];
  const Real x2132 = w.x[100];
  const Real x2156 = w.x[105];
  const Real x2180 = w.x[110];
  const Real x2204 = w.x[115];
  const Real x2229 = w.x[120];
  const Real x2377 = w.x[62];
  const Real x2382 = w.x[61];
  const Real x2387 = w.x[60];
  const Real x2388 = w.x[57];
  const Real x2389 = w.x[63];
  const Real x2429 = w.x[128];
  const Real x3117 = w.x[51];
  const Real x3118 = w.x[142];
  const Real x3119 = w.x[133];
  const Real x3120 = w.x[38];
  const Real x3121 = w.x[49];
  const Real x3122 = w.x[64];
  const Real x3197 = w.x[55];
  const Real x3200 = w.x[58];
  const Real x3206 = w.x[70];
  const Real x3215 = w.x[71];
  const Real x3227 = w.x[94];
  // joint 11 "joint12": disassembly: its acceleration and force
  const Real x3186 = x2132 * x3118 + x2229 * x3122 + x2156 * x3119;
  const Real x3248 = cosine[11] * x3206 - sine[11] * x3200;
  const Real x3251 = sine[11] * x3206 + cosine[11] * x3200;
  const Real x3252 = 0.4 * x3251;
  const Real x3234 = x2388 * x3200 + x2389 * x3197 + x2387 * x3206;
  const Real x3254 = cosine[11] * x3227 - sine[11] * x3215 + x3252;
  const Real x3257 = sine[11] * x3227 + cosine[11] * x3215 - 0.4 * x3248;
  const Real x3192 = x2180 * x3120 + x3186 + x2204 * x3121 - x2429;
  const Real x3237 = x2382 * x3215 + x3234 + x2377 * x3227 + x3192;
  w.result[11] = x3237;
  // joint 10 "joint11": handle forces through it
  const Real x3268 = x3248 + 3.742984243907825 * x3257;
  const Real x3294 = sine[10] * tau[11] + cosine[10] * x3254 + x3252;
  const Real x3290 = sine[10] * x3197 + cosine[10] * x3268;
  const Real x3285 = sine[10] * x3268 - cosine[10] * x3197;
  const Real x3292 = 0.4 * x3290;
  // joint 9 "joint10": handle forces through it
  const Real x3300 = sine[10] * x3254 - cosine[10] * tau[11] - x847 * x3294;
  const Real x3303 = x849 * x3294 - x3251;
  const Real x3310 = sine[9] * x3292 + cosine[9] * x3300;
  const Real x3314 = cosine[9] * x3303 - sine[9] * x3285;
  // joint 8 "joint09": handle forces through it
  const Real x3331 = x3290 + x968 * x3310;
  const Real x3335 = x3314 - x969 * x3310;
  const Real x3325 = 0.4 * x3314 - x966 * x3310;
  // joint 9 "joint10": handle forces through it
  const Real x3320 = cosine[9] * x3292 - sine[9] * x3300 + x3292;
  // joint 8 "joint09": handle forces through it
  const Real x3328 = x3320 - x967 * x3310;
  const Real x3338 = sine[9] * x3303 + cosine[9] * x3285 - x970 * x3310;
  const Real x3364 = x3120 + x3338;
  const Real x3350 = cosine[8] * x3331 + sine[8] * x3335;
  const Real x3355 = cosine[8] * x3335 - sine[8] * x3331;
  const Real x3365 = x3121 - x3350;
  const Real x3366 = x3122 + x3355;
  const Real x3358 = cosine[8] * x3325 - sine[8] * x3328 + 0.4 * x3355;
  const Real x3362 = x3118 + x3358;
  const Real x3361 = sine[8] * x3325 + cosine[8] * x3328 + 0.4 * x3350;
  const Real x3363 = x3119 + x3361;
  // link 8 "rod08": acceleration under the handle forces
  const Real x3374 = x1308 * x3364 + x1311 * x3365 + x1282 * x3366;
  const Real x3383 = x1324 * x3364 + x1327 * x3365 + x1283 * x3366;
  const Real x3393 = x1332 * x3364 - x1335 * x3365 + x1284 * x3366;
  const Real x3404 = x1339 * x3365 - x1335 * x3364 - x1285 * x3366;
  const Real x3414 = x1284 * x3364 - x1285 * x3365 + x1227 * x3366;
  const Real x3418 = x1295 * x3362 + x3374 + x1303 * x3363 - x1349;
  const Real x3419 = x1303 * x3362 + x3383 + x1318 * x3363 - x1358;
  const Real x3420 = x1308 * x3362 + x3393 + x1324 * x3363 - x1368;
  const Real x3422 = x1282 * x3362 + x3414 + x1283 * x3363 - x1389;
  // joint 8 "joint09": its acceleration, and that of the link beyond
  const Real x3427 = x3422 + 0.4 * x3418;
  // link 8 "rod08": acceleration under the handle forces
  const Real x3421 = x1311 * x3362 + x3404 + x1327 * x3363 - x1379;
  // joint 8 "joint09": its acceleration, and that of the link beyond
  const Real x3425 = x3421 - 0.4 * x3419;
  const Real x3430 = cosine[8] * x3418 + sine[8] * x3419;
  const Real x3434 = cosine[8] * x3419 - sine[8] * x3418;
  const Real x3437 = cosine[8] * x3425 + sine[8] * x3427;
  const Real x3452 = x963 * (x964 + x3310) - x970 * x3420;
  const Real x3441 = cosine[8] * x3427 - sine[8] * x3425;
  const Real x3454 = x3452 - x966 * x3430 - x967 * x3434;
  const Real x3456 = x3454 - x968 * x3437 - x969 * x3441;
  // joint 9 "joint10": its acceleration, and that of the link beyond
  const Real x3462 = x3441 + 0.4 * x3430;
  // joint 8 "joint09": its acceleration, and that of the link beyond
  const Real x3457 = x3456 - (5000.0 * x3117 - x1340);
  w.result[8] = x3457;
  // joint 9 "joint10": its acceleration, and that of the link beyond
  const Real x3465 = cosine[9] * x3434 + sine[9] * x3456;
  const Real x3479 = x849 * (cosine[9] * x3462 + sine[9] * x3420);
  const Real x3477 = x847 * (cosine[9] * x3456 - sine[9] * x3434);
  const Real x3483 = x844 * (x845 - x3294) - x3479 + x3477 - x3430;
  w.result[9] = x3483;
  // joint 10 "joint11": its acceleration, and that of the link beyond
  const Real x3501 = cosine[10] * (x3437 - 0.4 * x3434 - 0.4 * x3465);
  const Real x3502 = x3501 - sine[10] * (cosine[9] * x3420 - sine[9] * x3462);
  const Real x3506 = 18.714921219539125 * (x765 - x3257) + 3.742984243907825 * x3502 - x3465;
  w.result[10] = x3506;
}

// =================================================================================================
// Process 2: 790 products, 635 sums, 9 quotients
// =================================================================================================

ADAGEN_NOINLINE void part_2_0(Workspace& w) {
  ADAGEN_INPUTS
  // joint 1 "joint02": placement, velocity and reference acceleration of its link
  const Real x18 = v[0] * sine[1];
  const Real x19 = v[0] * cosine[1];
  const Real x20 = v[1] * x19;
  const Real x21 = v[1] * x18;
  const Real x26 = cosine[0] * 9.81 + v[0] * v[0] * 0.4;
  // joint 2 "joint03": placement, velocity and reference acceleration of its link
  const Real x52 = x19 * cosine[2] + v[1] * sine[2];
  const Real x56 = v[1] * cosine[2] - x19 * sine[2];
  const Real x57 = x18 + v[2];
  const Real x63 = v[2] * x56 - x21 * cosine[2];
  const Real x66 = x21 * sine[2] - v[2] * x52;
  const Real x67 = 0.4 * (x19 * x19 + v[1] * v[1]);
  const Real x72 = sine[1] * x26 + 0.4 * (x18 * x19);
  const Real x76 = sine[0] * 9.81 - 0.4 * (x21 * 2.0);
  // joint 3 "joint04": placement, velocity and reference acceleration of its link
  const Real x112 = x56 * cosine[3] + x57 * sine[3];
  const Real x116 = x57 * cosine[3] - x56 * sine[3];
  const Real x117 = x52 + v[3];
  const Real x126 = x66 * cosine[3] + x20 * sine[3] + v[3] * x116;
  const Real x129 = x20 * cosine[3] - x66 * sine[3] - v[3] * x112;
  // joint 2 "joint03": placement, velocity and reference acceleration of its link
  const Real x80 = sine[2] * x76 - cosine[2] * x72;
  const Real x84 = sine[2] * x72 + cosine[2] * x76;
  // joint 3 "joint04": placement, velocity and reference acceleration of its link
  const Real x135 = x84 - 0.4 * (x56 * x57 - x63);
  const Real x136 = 0.4 * (x52 * x52 + x56 * x56);
  const Real x138 = cosine[1] * x26 + x67 + x136;
  // joint 4 "joint05": placement, velocity and reference acceleration of its link
  const Real x173 = x116 * cosine[4] + x117 * sine[4];
  const Real x177 = x117 * cosine[4] - x116 * sine[4];
  const Real x178 = x112 + v[4];
  const Real x187 = x129 * cosine[4] + x63 * sine[4] + v[4] * x177;
  const Real x190 = x63 * cosine[4] - x129 * sine[4] - v[4] * x173;
  // joint 3 "joint04": placement, velocity and reference acceleration of its link
  const Real x141 = cosine[3] * x135 + sine[3] * x138;
  // joint 4 "joint05": placement, velocity and reference acceleration of its link
  const Real x194 = 0.4 * (x112 * x112 + x117 * x117);
  const Real x196 = cosine[3] * x138 - sine[3] * x135 + x194;
  // joint 3 "joint04": placement, velocity and reference acceleration of its link
  const Real x132 = x80 - 0.4 * (x66 + x52 * x57);
  // joint 4 "joint05": placement, velocity and reference acceleration of its link
  const Real x199 = x132 - 0.4 * (x126 + x116 * x117);
  // joint 5 "joint06": placement, velocity and reference acceleration of its link
  const Real x234 = x177 * cosine[5] + x178 * sine[5];
  const Real x238 = x178 * cosine[5] - x177 * sine[5];
  const Real x239 = x173 + v[5];
  const Real x248 = x190 * cosine[5] + x126 * sine[5] + v[5] * x238;
  const Real x251 = x126 * cosine[5] - x190 * sine[5] - v[5] * x234;
  const Real x252 = 0.4 * (x177 * x177 + x178 * x178);
  // joint 4 "joint05": placement, velocity and reference acceleration of its link
  const Real x206 = cosine[4] * x199 - sine[4] * x196;
  // joint 5 "joint06": placement, velocity and reference acceleration of its link
  const Real x257 = x206 - 0.4 * (x126 + x173 * x177);
  // joint 4 "joint05": placement, velocity and reference acceleration of its link
  const Real x193 = x141 - 0.4 * (x112 * x116 - x63);
  // joint 5 "joint06": placement, velocity and reference acceleration of its link
  const Real x260 = x193 - 0.4 * (x173 * x178 - x190);
  // joint 6 "joint07": placement, velocity and reference acceleration of its link
  const Real x295 = x238 * cosine[6] + x239 * sine[6];
  const Real x299 = x239 * cosine[6] - x238 * sine[6];
  const Real x300 = x234 + v[6];
  const Real x309 = x251 * cosine[6] + x187 * sine[6] + v[6] * x299;
  const Real x312 = x187 * cosine[6] - x251 * sine[6] - v[6] * x295;
  // joint 5 "joint06": placement, velocity and reference acceleration of its link
  const Real x263 = cosine[5] * x257 + sine[5] * x260;
  const Real x267 = cosine[5] * x260 - sine[5] * x257;
  // joint 6 "joint07": placement, velocity and reference acceleration of its link
  const Real x318 = x267 - 0.4 * (x238 * x239 - x248);
  // joint 5 "joint06": placement, velocity and reference acceleration of its link
  const Real x254 = cosine[4] * x196 + sine[4] * x199 + x252;
  // joint 6 "joint07": placement, velocity and reference acceleration of its link
  const Real x321 = x254 + 0.4 * (x234 * x234 + x238 * x238);
  // joint 7 "joint08": placement, velocity and reference acceleration of its link
  const Real x356 = x299 * cosine[7] + x300 * sine[7];
  const Real x360 = x300 * cosine[7] - x299 * sine[7];
  const Real x361 = x295 + v[7];
  const Real x370 = x312 * cosine[7] + x248 * sine[7] + v[7] * x360;
  const Real x373 = x248 * cosine[7] - x312 * sine[7] - v[7] * x356;
  // joint 6 "joint07": placement, velocity and reference acceleration of its link
  const Real x324 = cosine[6] * x318 + sine[6] * x321;
  // joint 7 "joint08": placement, velocity and reference acceleration of its link
  const Real x377 = 0.4 * (x295 * x295 + x300 * x300);
  const Real x379 = cosine[6] * x321 - sine[6] * x318 + x377;
  // joint 6 "joint07": placement, velocity and reference acceleration of its link
  const Real x315 = x263 - 0.4 * (x251 + x234 * x239);
  // joint 7 "joint08": placement, velocity and reference acceleration of its link
  const Real x382 = x315 - 0.4 * (x309 + x299 * x300);
  // joint 8 "joint09": placement, velocity and reference acceleration of its link
  const Real x417 = x360 * cosine[8] + x361 * sine[8];
  const Real x421 = x361 * cosine[8] - x360 * sine[8];
  const Real x422 = x356 + v[8];
  const Real x431 = x373 * cosine[8] + x309 * sine[8] + v[8] * x421;
  const Real x434 = x309 * cosine[8] - x373 * sine[8] - v[8] * x417;
  const Real x435 = 0.4 * (x360 * x360 + x361 * x361);
  // joint 7 "joint08": placement, velocity and reference acceleration of its link
  const Real x389 = cosine[7] * x382 - sine[7] * x379;
  // joint 8 "joint09": placement, velocity and reference acceleration of its link
  const Real x440 = x389 - 0.4 * (x309 + x356 * x360);
  // joint 7 "joint08": placement, velocity and reference acceleration of its link
  const Real x376 = x324 - 0.4 * (x295 * x299 - x248);
  // joint 8 "joint09": placement, velocity and reference acceleration of its link
  const Real x443 = x376 - 0.4 * (x356 * x361 - x373);
  // joint 9 "joint10": placement, velocity and reference acceleration of its link
  const Real x478 = x421 * cosine[9] + x422 * sine[9];
  const Real x482 = x422 * cosine[9] - x421 * sine[9];
  const Real x483 = x417 + v[9];
  const Real x492 = x434 * cosine[9] + x370 * sine[9] + v[9] * x482;
  const Real x495 = x370 * cosine[9] - x434 * sine[9] - v[9] * x478;
  // joint 8 "joint09": placement, velocity and reference acceleration of its link
  const Real x446 = cosine[8] * x440 + sine[8] * x443;
  const Real x450 = cosine[8] * x443 - sine[8] * x440;
  // joint 9 "joint10": placement, velocity and reference acceleration of its link
  const Real x501 = x450 - 0.4 * (x421 * x422 - x431);
  // joint 8 "joint09": placement, velocity and reference acceleration of its link
  const Real x437 = cosine[7] * x379 + sine[7] * x382 + x435;
  // joint 9 "joint10": placement, velocity and reference acceleration of its link
  const Real x504 = x437 + 0.4 * (x417 * x417 + x421 * x421);
  // joint 10 "joint11": placement, velocity and reference acceleration of its link
  const Real x539 = x482 * cosine[10] + x483 * sine[10];
  const Real x543 = x483 * cosine[10] - x482 * sine[10];
  const Real x544 = x478 + v[10];
  const Real x553 = x495 * cosine[10] + x431 * sine[10] + v[10] * x543;
  const Real x556 = x431 * cosine[10] - x495 * sine[10] - v[10] * x539;
  // joint 9 "joint10": placement, velocity and reference acceleration of its link
  const Real x507 = cosine[9] * x501 + sine[9] * x504;
  // joint 10 "joint11": placement, velocity and reference acceleration of its link
  const Real x560 = 0.4 * (x478 * x478 + x483 * x483);
  const Real x562 = cosine[9] * x504 - sine[9] * x501 + x560;
  // joint 9 "joint10": placement, velocity and reference acceleration of its link
  const Real x498 = x446 - 0.4 * (x434 + x417 * x422);
  // joint 10 "joint11": placement, velocity and reference acceleration of its link
  const Real x565 = x498 - 0.4 * (x492 + x482 * x483);
  // joint 11 "joint12": placement, velocity and reference acceleration of its link
  const Real x600 = x543 * cosine[11] + x544 * sine[11];
  const Real x604 = x544 * cosine[11] - x543 * sine[11];
  const Real x605 = x539 + v[11];
  const Real x614 = x556 * cosine[11] + x492 * sine[11] + v[11] * x604;
  const Real x617 = x492 * cosine[11] - x556 * sine[11] - v[11] * x600;
  const Real x618 = 0.4 * (x543 * x543 + x544 * x544);
  const Real x620 = cosine[10] * x562 + sine[10] * x565 + x618;
  // joint 10 "joint11": placement, velocity and reference acceleration of its link
  const Real x572 = cosine[10] * x565 - sine[10] * x562;
  // joint 11 "joint12": placement, velocity and reference acceleration of its link
  const Real x623 = x572 - 0.4 * (x492 + x539 * x543);
  // joint 10 "joint11": placement, velocity and reference acceleration of its link
  const Real x559 = x507 - 0.4 * (x478 * x482 - x431);
  // joint 11 "joint12": placement, velocity and reference acceleration of its link
  const Real x626 = x559 - 0.4 * (x539 * x544 - x556);
  const Real x629 = cosine[11] * x623 + sine[11] * x626;
  const Real x633 = cosine[11] * x626 - sine[11] * x623;
  const Real x646 = x604 * x605;
  const Real x647 = x646 - x614;
  const Real x649 = x600 * x600 + x604 * x604;
  const Real x651 = x600 * x605;
  const Real x653 = x617 + x651;
  // link 12 "rod12": force that the reference field takes
  const Real x904 = x614 * 0.0534333;
  // joint 12 "joint13": placement, velocity and reference acceleration of its link
  const Real x661 = x604 * cosine[12] + x605 * sine[12];
  const Real x665 = x605 * cosine[12] - x604 * sine[12];
  const Real x666 = x600 + v[12];
  const Real x675 = x617 * cosine[12] + x553 * sine[12] + v[12] * x665;
  const Real x678 = x553 * cosine[12] - x617 * sine[12] - v[12] * x661;
  const Real x681 = x629 - 0.4 * x653;
  const Real x684 = x633 - 0.4 * x647;
  const Real x687 = x620 + 0.4 * x649;
  const Real x690 = cosine[12] * x684 + sine[12] * x687;
  const Real x694 = cosine[12] * x687 - sine[12] * x684;
  const Real x702 = x661 * x665;
  const Real x703 = x702 - x614;
  const Real x705 = x661 * x661 + x666 * x666;
  const Real x707 = x665 * x666;
  const Real x709 = x675 + x707;
  // link 13 "rod13": force that the reference field takes
  const Real x932 = x675 * 0.0534333;
  // joint 13 "joint14": placement, velocity and reference acceleration of its link
  const Real x722 = x665 * cosine[13] + x666 * sine[13];
  const Real x726 = x666 * cosine[13] - x665 * sine[13];
  const Real x727 = x661 + v[13];
  const Real x736 = x678 * cosine[13] + x614 * sine[13] + v[13] * x726;
  const Real x739 = x614 * cosine[13] - x678 * sine[13] - v[13] * x722;
  const Real x742 = x690 - 0.4 * x703;
  const Real x745 = x694 + 0.4 * x705;
  const Real x748 = x681 - 0.4 * x709;
  const Real x751 = cosine[13] * x745 + sine[13] * x748;
  const Real x755 = cosine[13] * x748 - sine[13] * x745;
  const Real x761 = x726 * x726 + x727 * x727;
  const Real x763 = x722 * x726;
  const Real x765 = x675 + x763;
  const Real x773 = x722 * x727;
  const Real x774 = x773 - x739;
  // link 14 "rod14": force that the reference field takes
  const Real x957 = x736 * 0.0002;
  // joint 14 "joint15": placement, velocity and reference acceleration of its link
  const Real x783 = x726 * cosine[14] + x727 * sine[14];
  const Real x787 = x727 * cosine[14] - x726 * sine[14];
  const Real x788 = x722 + v[14];
  const Real x797 = x739 * cosine[14] + x675 * sine[14] + v[14] * x787;
  const Real x800 = x675 * cosine[14] - x739 * sine[14] - v[14] * x783;
  const Real x803 = x751 + 0.4 * x761;
  const Real x806 = x755 - 0.4 * x765;
  const Real x809 = x742 - 0.4 * x774;
  const Real x812 = cosine[14] * x806 + sine[14] * x809;
  const Real x816 = cosine[14] * x809 - sine[14] * x806;
  const Real x829 = x787 * x788;
  const Real x830 = x829 - x797;
  const Real x832 = x783 * x783 + x787 * x787;
  const Real x834 = x783 * x788;
  const Real x836 = x800 + x834;
  // link 15 "rod15": force that the reference field takes
  const Real x982 = x797 * 0.0534333;
  // joint 15 "joint16": placement, velocity and reference acceleration of its link
  const Real x844 = x787 * cosine[15] + x788 * sine[15];
  const Real x848 = x788 * cosine[15] - x787 * sine[15];
  const Real x849 = x783 + v[15];
  const Real x858 = x800 * cosine[15] + x736 * sine[15] + v[15] * x848;
  const Real x864 = x812 - 0.4 * x836;
  const Real x867 = x816 - 0.4 * x830;
  const Real x870 = x803 + 0.4 * x832;
  const Real x873 = cosine[15] * x867 + sine[15] * x870;
  const Real x885 = x844 * x848;
  const Real x890 = x848 * x849;
  const Real x861 = x736 * cosine[15] - x800 * sine[15] - v[15] * x844;
  // link 16 "rod16": force that the reference field takes
  const Real x1011 = x861 * 0.0002;
  const Real x1019 = x858 * 0.0534333 + x890 * 0.053233300000000004 - x864 * 0.2;
  const Real x1026 = (x844 * x844 + x849 * x849) * 0.2;
  const Real x1028 = cosine[15] * x870 - sine[15] * x867 + x1026;
  const Real x1031 = x864 - (x858 + x890) * 0.2;
  // joint 15 "joint16": articulated-body inertia and bias force through it
  const Real x1034 = tau[15] - (x982 - x885 * 0.053233300000000004 + x873 * 0.2);
  const Real x1035 = 18.714921219539125 * x1034;
  w.x[0] = x1035;
  const Real x1041 = x873 - (x885 - x797) * 0.2 + 0.2 * x1035;
  const Real x1042 = cosine[15] * 0.2;
  const Real x1044 = sine[15] * 0.2;
  const Real x1048 = cosine[15] * 0.053233300000000004;
  const Real x1051 = cosine[15] * x1048;
  const Real x1054 = cosine[15] * 0.7485968487815651;
  const Real x1056 = sine[15] * x1054;
  const Real x1058 = cosine[15] * x1054;
  const Real x1060 = 1.0 - x1058;
  const Real x1062 = -0.4 - x1042;
  const Real x1063 = 0.4 * x1060;
  const Real x1065 = 0.4 * x1056;
  const Real x1077 = sine[15] * x1048 + 0.4 * x1044;
  const Real x1088 = cosine[15] * x1041 - sine[15] * x1028;
  const Real x1098 = 0.0534333 + 0.4 * x1063;
  const Real x1099 = 0.2 + x1063;
  const Real x1074 = 0.0002 + x1051 + 0.4 * x1042 - 0.4 * x1062;
  const Real x1102 = 0.0534333 - x1051 + 0.0002;
  require_more(w, x1102, 0.0, kFactorization, 14);
  const Real x1103 = 1.0 + x1060;
  // link 15 "rod15": force that the reference field takes
  const Real x994 = x982 - x829 * 0.053233300000000004 + x816 * 0.2;
  // joint 15 "joint16": articulated-body inertia and bias force through it
  const Real x1105 = tau[15] + 0.4 * x1088 + x994;
  // link 15 "rod15": force that the reference field takes
  const Real x997 = x800 * 0.0534333 + x834 * 0.053233300000000004 - x812 * 0.2;
  // joint 15 "joint16": articulated-body inertia and bias force through it
  const Real x1097 = cosine[15] * x1019 - sine[15] * x1011 - 0.4 * x1031;
  const Real x1109 = x816 - x830 * 0.2 + x1088;
  const Real x1091 = sine[15] * x1041 + cosine[15] * x1028;
  // joint 14 "joint15": articulated-body inertia and bias force through it
  const Real x1112 = 1 / x1102;
  const Real x1113 = tau[14] - (sine[15] * x1019 + cosine[15] * x1011 + x957);
  const Real x1114 = x1112 * x1113;
  w.x[1] = x1114;
  const Real x1115 = x1077 * x1112;
  w.x[2] = x1115;
  const Real x1116 = x1044 * x1112;
  w.x[3] = x1116;
  const Real x1120 = 0.0534333 + x1074 - x1077 * x1115;
  const Real x1123 = -0.2 + x1062 + x1077 * x1116;
  const Real x1126 = 2.0 - x1044 * x1116;
  const Real x1128 = x997 + x1097 + x1077 * x1114;
  const Real x1131 = x812 - x836 * 0.2 + x1031 - x1044 * x1114;
  const Real x1137 = sine[14] * (x1099 + x1123);
  const Real x1139 = sine[14] * x1137;
  const Real x1141 = x1099 - x1139;
  const Real x1142 = x1123 - x1139;
  const Real x1143 = cosine[14] * x1137;
  const Real x1146 = cosine[14] * (x1098 - x1120);
  const Real x1151 = cosine[14] * x1146;
  const Real x1154 = sine[14] * x1056;
  const Real x1156 = cosine[14] * x1056;
  const Real x1159 = cosine[14] * (x1126 - x1103);
  const Real x1160 = sine[14] * x1159;
  const Real x1162 = cosine[14] * x1159;
  const Real x1163 = x1103 + x1162;
  const Real x1164 = x1126 - x1162;
  const Real x1171 = sine[14] * x1065 + 0.4 * x1154;
  const Real x1175 = 0.4 * x1160 - x1143;
  const Real x1178 = x1142 - 0.4 * x1163;
  const Real x1181 = x1141 + 0.4 * x1164;
  const Real x1194 = sine[14] * x1146 + 0.4 * x1143 - 0.4 * x1175;
  const Real x1211 = cosine[14] * x1131 - sine[14] * x1109;
  const Real x1214 = sine[14] * x1131 + cosine[14] * x1109;
  const Real x1188 = x1120 + x1151 + 0.4 * x1141 + 0.4 * x1181;
  const Real x1200 = x1098 - x1151 - 0.4 * x1142 - 0.4 * x1178;
  const Real x1223 = 0.0534333 + x1200;
  require_more(w, x1223, 0.0, kFactorization, 13);
  const Real x1224 = -0.2 + x1178;
  const Real x1228 = x957 + tau[14];
  // link 14 "rod14": force that the reference field takes
  const Real x969 = x739 * 0.0534333 - x773 * 0.053233300000000004 + x742 * 0.2;
  // joint 14 "joint15": articulated-body inertia and bias force through it
  const Real x1217 = cosine[14] * x1105 - sine[14] * x1128 + 0.4 * x1214;
  const Real x1220 = sine[14] * x1105 + cosine[14] * x1128 - 0.4 * x1211;
  // joint 15 "joint16": articulated-body inertia and bias force through it
  const Real x1110 = x803 + x832 * 0.2 + x1091;
  // joint 13 "joint14": articulated-body inertia and bias force through it
  const Real x1235 = 1 / x1223;
  // joint 14 "joint15": articulated-body inertia and bias force through it
  const Real x1230 = x932 + x763 * 0.053233300000000004 - x755 * 0.2 + x1220;
  // joint 13 "joint14": articulated-body inertia and bias force through it
  const Real x1237 = x1235 * (tau[13] - x1230);
  w.x[4] = x1237;
  const Real x1238 = x1194 * x1235;
  w.x[5] = x1238;
  const Real x1239 = x1171 * x1235;
  w.x[6] = x1239;
  const Real x1241 = x1224 * x1235;
  w.x[7] = x1241;
  const Real x1242 = x1175 * x1235;
  w.x[8] = x1242;
  const Real x1246 = 0.0534333 + x1188 - x1194 * x1238;
  const Real x1249 = x1194 * x1239 - (cosine[14] * x1065 + 0.4 * x1156);
  const Real x1252 = x1175 - x1194 * x1241;
  const Real x1255 = 0.2 + x1181 + x1194 * x1242;
  const Real x1258 = 0.25140315121843493 + x1058 + 1.0 + 1.0 - x1171 * x1239;
  const Real x1261 = x1154 + x1171 * x1241;
  const Real x1264 = x1156 + x1171 * x1242;
  const Real x1268 = 1.0 + x1163 - x1224 * x1241;
  const Real x1271 = x1160 + x1224 * x1242;
  const Real x1274 = 1.0 + x1164 - x1175 * x1242;
  const Real x1276 = x969 + x1217 + x1194 * x1237;
  const Real x1279 = x751 + x761 * 0.2 + x1110 - x1171 * x1237;
  const Real x1281 = x755 - x765 * 0.2 + x1211 + x1224 * x1237;
  const Real x1284 = x742 - x774 * 0.2 + x1214 - x1175 * x1237;
  const Real x1285 = sine[13] * x1255;
  const Real x1287 = cosine[13] * x1255;
  const Real x1293 = cosine[13] * x1252 + sine[13] * x1249;
  const Real x1295 = sine[13] * x1293;
  const Real x1298 = cosine[13] * x1293;
  const Real x1302 = cosine[13] * (0.0002 - x1246);
  const Real x1307 = cosine[13] * x1302;
  const Real x1314 = cosine[13] * x1264 + sine[13] * x1271;
  const Real x1319 = cosine[13] * x1271 - sine[13] * x1264;
  const Real x1324 = cosine[13] * (x1258 - x1268) - x1261 * (2.0 * sine[13]);
  const Real x1327 = x1261 + sine[13] * x1324;
  const Real x1328 = cosine[13] * x1324;
  const Real x1330 = x1258 - x1328;
  const Real x1331 = 0.4 * x1319;
  const Real x1335 = x1287 + 0.4 * x1274;
  const Real x1340 = x1249 - x1295 - 0.4 * x1314;
  const Real x1341 = 0.4 * x1330;
  const Real x1343 = x1298 + x1331;
  const Real x1352 = 0.4 * x1298 + 0.4 * x1331;
  const Real x1356 = sine[13] * x1302 - 0.4 * x1285;
  const Real x1376 = sine[13] * x1279 + cosine[13] * x1281;
  const Real x1362 = 0.0002 - x1307 + (0.4 * x1287 + 0.4 * x1335);
  const Real x1386 = 0.0534333 + x1362;
  require_more(w, x1386, 0.0, kFactorization, 12);
  const Real x1387 = 0.2 + x1335;
  // link 13 "rod13": force that the reference field takes
  const Real x944 = x932 + x707 * 0.053233300000000004 - x681 * 0.2;
  // joint 13 "joint14": articulated-body inertia and bias force through it
  const Real x1382 = sine[13] * x1228 + cosine[13] * x1276 + 0.4 * x1284;
  const Real x1373 = cosine[13] * x1279 - sine[13] * x1281;
  // joint 12 "joint13": articulated-body inertia and bias force through it
  const Real x1398 = 1 / x1386;
  // joint 13 "joint14": articulated-body inertia and bias force through it
  const Real x1393 = x904 - x702 * 0.053233300000000004 + x690 * 0.2 + x1382;
  // joint 12 "joint13": articulated-body inertia and bias force through it
  const Real x1400 = x1398 * (tau[12] - x1393);
  w.x[9] = x1400;
  const Real x1401 = x1352 * x1398;
  w.x[10] = x1401;
  const Real x1403 = x1356 * x1398;
  w.x[11] = x1403;
  const Real x1404 = x1387 * x1398;
  w.x[12] = x1404;
  const Real x1405 = x1340 * x1398;
  w.x[13] = x1405;
  const Real x1406 = x1343 * x1398;
  w.x[14] = x1406;
  const Real x1409 = 0.0534333 + 0.4 * x1341 - x1352 * x1401;
  const Real x1412 = 0.4 * x1295 + x1352 * x1403;
  const Real x1415 = x1352 * x1404 - x1331;
  const Real x1418 = x1352 * x1405 - 0.4 * x1327;
  const Real x1421 = -0.2 - x1341 + x1352 * x1406;
  const Real x1424 = x1246 + x1307 + 0.0002 - x1356 * x1403;
  const Real x1427 = x1285 + x1356 * x1404;
  const Real x1431 = x1252 - x1298 - x1356 * x1405;
  const Real x1434 = x1295 + x1356 * x1406;
  const Real x1438 = 1.0 + x1274 - x1387 * x1404;
  const Real x1441 = x1314 + x1387 * x1405;
  const Real x1445 = x1319 - x1387 * x1406;
  const Real x1448 = x1268 + x1328 + 1.0 - x1340 * x1405;
  const Real x1451 = x1327 - x1340 * x1406;
  const Real x1454 = 1.0 + x1330 - x1343 * x1406;
  const Real x1457 = tau[13] - 0.4 * x1376 + x944 - x1352 * x1400;
  // joint 13 "joint14": articulated-body inertia and bias force through it
  const Real x1392 = cosine[13] * x1228 - sine[13] * x1276 + x678 * 0.0002;
  // joint 12 "joint13": articulated-body inertia and bias force through it
  const Real x1459 = x1392 + x1356 * x1400;
  const Real x1461 = x690 - x703 * 0.2 + x1284 + x1387 * x1400;
  const Real x1463 = x694 + x705 * 0.2 + x1373 + x1340 * x1400;
  const Real x1465 = x681 - x709 * 0.2 + x1376 + x1343 * x1400;
  const Real x1469 = cosine[12] * x1421 + sine[12] * x1434;
  const Real x1473 = sine[12] * x1421 - cosine[12] * x1434;
  w.x[15] = x1473;
  const Real x1479 = cosine[12] * (x1415 - x1431) - sine[12] * (x1418 - x1427);
  const Real x1480 = sine[12] * x1479;
  const Real x1483 = x1480 - x1427;
  w.x[16] = x1483;
  const Real x1484 = cosine[12] * x1479;
  const Real x1485 = x1431 + x1484;
  const Real x1486 = x1415 - x1484;
  w.x[17] = x1486;
  const Real x1489 = 2.0 * sine[12];
  const Real x1493 = cosine[12] * (x1409 - x1424) - x1412 * x1489;
  const Real x1497 = cosine[12] * x1493;
  const Real x1503 = cosine[12] * x1445 - sine[12] * x1451;
  w.x[18] = x1503;
  const Real x1506 = sine[12] * x1445 + cosine[12] * x1451;
  w.x[19] = x1506;
  const Real x1511 = cosine[12] * (x1438 - x1448) + x1441 * x1489;
  const Real x1514 = sine[12] * x1511 - x1441;
  w.x[20] = x1514;
  const Real x1515 = cosine[12] * x1511;
  const Real x1516 = x1448 + x1515;
  const Real x1518 = 0.4 * x1503;
  w.x[21] = x1518;
  const Real x1522 = x1469 - 0.4 * x1454;
  const Real x1523 = 0.4 * x1516;
  const Real x1525 = x1485 - x1518;
  w.x[22] = x1525;
  const Real x1526 = 0.4 * x1514;
  w.x[23] = x1526;
  const Real x1530 = x1418 + x1480 - 0.4 * x1506;
  w.x[24] = x1530;
  const Real x1537 = 0.4 * x1485 - 0.4 * x1518;
  w.x[25] = x1537;
  const Real x1538 = 0.4 * x1483;
  w.x[26] = x1538;
  const Real x1549 = x1412 + sine[12] * x1493 - 0.4 * x1473;
  w.x[27] = x1549;
  const Real x1560 = cosine[12] * x1461 - sine[12] * x1463;
  const Real x1570 = 0.0534333 + 0.4 * x1523;
  require_more(w, x1570, 0.0, kFactorization, 11);
  const Real x1571 = 0.2 + x1523;
  w.x[28] = x1571;
  const Real x1546 = x1424 + x1497 - (0.4 * x1469 + 0.4 * x1522);
  const Real x1572 = 0.0534333 + x1546;
  w.x[29] = x1572;
  const Real x1573 = -0.2 + x1522;
  w.x[30] = x1573;
  const Real x1574 = x1409 - x1497 + 0.0002;
  w.x[31] = x1574;
  const Real x1575 = 1.0 + x1454;
  w.x[32] = x1575;
  const Real x1576 = 1.0 + x1516;
  w.x[33] = x1576;
  const Real x1577 = x1438 - x1515 + 1.0;
  w.x[34] = x1577;
  // link 12 "rod12": force that the reference field takes
  const Real x919 = x904 - x646 * 0.053233300000000004 + x633 * 0.2;
  // joint 12 "joint13": articulated-body inertia and bias force through it
  const Real x1578 = tau[12] + 0.4 * x1560 + x919;
  w.x[35] = x1578;
  // link 12 "rod12": force that the reference field takes
  const Real x922 = x617 * 0.0534333 + x651 * 0.053233300000000004 - x629 * 0.2;
  // joint 12 "joint13": articulated-body inertia and bias force through it
  const Real x1569 = cosine[12] * x1457 - sine[12] * x1459 - 0.4 * x1465;
  const Real x1579 = x922 + x1569;
  w.x[36] = x1579;
  const Real x1580 = sine[12] * x1457 + cosine[12] * x1459 + x553 * 0.0002;
  w.x[37] = x1580;
  const Real x1581 = x629 - x653 * 0.2 + x1465;
  w.x[38] = x1581;
  const Real x1582 = x633 - x647 * 0.2 + x1560;
  w.x[39] = x1582;
  const Real x1563 = sine[12] * x1461 + cosine[12] * x1463;
  const Real x1583 = x620 + x649 * 0.2 + x1563;
  w.x[40] = x1583;
  // link 12 "rod12": mobility from its articulated-body inertia
  const Real x1584 = 1 / x1570;
  w.x[41] = x1584;
  const Real x1585 = x1537 * x1584;
  w.x[42] = x1585;
  const Real x1586 = x1538 * x1584;
  w.x[43] = x1586;
  const Real x1587 = x1518 * x1584;
  w.x[44] = x1587;
  const Real x1588 = x1571 * x1584;
  w.x[45] = x1588;
  const Real x1589 = x1526 * x1584;
  w.x[46] = x1589;
}

ADAGEN_NOINLINE void part_2_1(Workspace& w) {
  ADAGEN_INPUTS
  const Real x1473 = w.x[15];
  const Real x1483 = w.x[16];
  const Real x1486 = w.x[17];
  const Real x1503 = w.x[18];
  const Real x1506 = w.x[19];
  const Real x1514 = w.x[20];
  const Real x1518 = w.x[21];
  const Real x1525 = w.x[22];
  const Real x1526 = w.x[23];
  const Real x1530 = w.x[24];
  const Real x1537 = w.x[25];
  const Real x1538 = w.x[26];
  const Real x1549 = w.x[27];
  const Real x1571 = w.x[28];
  const Real x1572 = w.x[29];
  const Real x1573 = w.x[30];
  const Real x1574 = w.x[31];
  const Real x1575 = w.x[32];
  const Real x1576 = w.x[33];
  const Real x1577 = w.x[34];
  const Real x1578 = w.x[35];
  const Real x1579 = w.x[36];
  const Real x1580 = w.x[37];
  const Real x1581 = w.x[38];
  const Real x1582 = w.x[39];
  const Real x1583 = w.x[40];
  const Real x1584 = w.x[41];
  const Real x1585 = w.x[42];
  const Real x1586 = w.x[43];
  const Real x1587 = w.x[44];
  const Real x1588 = w.x[45];
  const Real x1589 = w.x[46];
  // link 12 "rod12": mobility from its articulated-body inertia
  const Real x1592 = x1572 - x1537 * x1585;
  w.x[47] = x1592;
  const Real x1595 = x1549 - x1538 * x1585;
  const Real x1598 = x1573 - x1518 * x1585;
  const Real x1601 = x1525 - x1571 * x1585;
  const Real x1604 = x1530 - x1526 * x1585;
  const Real x1605 = 1 / x1592;
  const Real x1606 = x1595 * x1605;
  const Real x1607 = x1598 * x1605;
  const Real x1608 = x1601 * x1605;
  const Real x1609 = x1604 * x1605;
  const Real x1615 = x1574 - x1538 * x1586 - x1595 * x1606;
  w.x[48] = x1615;
  const Real x1621 = x1473 - x1518 * x1586 - x1598 * x1606;
  const Real x1627 = x1483 - x1571 * x1586 - x1601 * x1606;
  const Real x1633 = x1486 - x1526 * x1586 - x1604 * x1606;
  const Real x1634 = 1 / x1615;
  const Real x1635 = x1621 * x1634;
  const Real x1636 = x1627 * x1634;
  const Real x1637 = x1633 * x1634;
  const Real x1645 = x1575 - x1518 * x1587 - x1598 * x1607;
  const Real x1646 = x1645 - x1621 * x1635;
  w.x[49] = x1646;
  const Real x1654 = x1503 - x1571 * x1587 - x1601 * x1607;
  const Real x1655 = x1654 - x1627 * x1635;
  const Real x1663 = x1506 - x1526 * x1587 - x1604 * x1607;
  const Real x1664 = x1663 - x1633 * x1635;
  const Real x1665 = 1 / x1646;
  const Real x1666 = x1655 * x1665;
  const Real x1667 = x1664 * x1665;
  const Real x1677 = x1576 - x1571 * x1588 - x1601 * x1608;
  const Real x1679 = x1677 - x1627 * x1636 - x1655 * x1666;
  w.x[50] = x1679;
  const Real x1689 = x1514 - x1526 * x1588 - x1604 * x1608;
  const Real x1691 = x1689 - x1633 * x1636 - x1664 * x1666;
  const Real x1692 = 1 / x1679;
  const Real x1693 = x1691 * x1692;
  const Real x1705 = x1577 - x1526 * x1589 - x1604 * x1609;
  const Real x1707 = x1705 - x1633 * x1637 - x1664 * x1667;
  const Real x1708 = x1707 - x1691 * x1693;
  w.x[51] = x1708;
  const Real x1709 = 1 / x1708;
  w.x[52] = x1709;
  w.to[0][20] = x1709;
  const Real x1720 = x1585 * x1606 - x1586;
  const Real x1728 = x1585 * x1607 - x1587 - x1635 * x1720;
  const Real x1732 = x1606 * x1635 - x1607;
  const Real x1742 = x1585 * x1608 - x1588 - x1636 * x1720;
  const Real x1743 = x1742 - x1666 * x1728;
  const Real x1750 = x1606 * x1636 - x1608 - x1666 * x1732;
  const Real x1754 = x1635 * x1666 - x1636;
  const Real x1766 = x1585 * x1609 - x1589 - x1637 * x1720;
  const Real x1768 = x1766 - x1667 * x1728 - x1693 * x1743;
  const Real x1777 = x1606 * x1637 - x1609 - x1667 * x1732;
  const Real x1778 = x1777 - x1693 * x1750;
  const Real x1785 = x1635 * x1667 - x1637 - x1693 * x1754;
  const Real x1789 = x1666 * x1693 - x1667;
  const Real x1791 = x1585 * x1605;
  const Real x1793 = x1634 * x1720;
  const Real x1794 = x1606 * x1634;
  const Real x1796 = x1665 * x1728;
  const Real x1797 = x1665 * x1732;
  const Real x1798 = x1635 * x1665;
  const Real x1800 = x1692 * x1743;
  const Real x1801 = x1692 * x1750;
  const Real x1802 = x1692 * x1754;
  const Real x1803 = x1666 * x1692;
  const Real x1805 = x1709 * x1768;
  w.x[53] = x1805;
  w.to[0][5] = x1805;
  const Real x1806 = x1709 * x1778;
  w.x[54] = x1806;
  w.to[0][10] = x1806;
  const Real x1807 = x1709 * x1785;
  w.x[55] = x1807;
  w.to[0][14] = x1807;
  const Real x1808 = x1709 * x1789;
  w.x[56] = x1808;
  w.to[0][17] = x1808;
  const Real x1809 = x1693 * x1709;
  w.x[57] = x1809;
  const Real x1810 = -x1809;
  w.to[0][19] = x1810;
  const Real x1818 = x1584 + x1585 * x1791 + x1720 * x1793;
  const Real x1820 = x1728 * x1796 + x1818 + x1743 * x1800;
  const Real x1821 = x1768 * x1805 + x1820;
  w.x[58] = x1821;
  w.to[0][0] = x1821;
  const Real x1829 = x1728 * x1797 - (x1791 + x1720 * x1794);
  const Real x1831 = x1743 * x1801 + x1829 + x1768 * x1806;
  w.x[59] = x1831;
  w.to[0][1] = x1831;
  const Real x1837 = x1793 - x1728 * x1798 + x1743 * x1802;
  const Real x1838 = x1768 * x1807 + x1837;
  w.x[60] = x1838;
  w.to[0][2] = x1838;
  const Real x1843 = x1796 - x1743 * x1803 + x1768 * x1808;
  w.x[61] = x1843;
  w.to[0][3] = x1843;
  const Real x1846 = x1800 - x1768 * x1809;
  w.x[62] = x1846;
  w.to[0][4] = x1846;
  const Real x1853 = x1605 + x1606 * x1794 + x1732 * x1797;
  const Real x1855 = x1750 * x1801 + x1853 + x1778 * x1806;
  w.x[63] = x1855;
  w.to[0][6] = x1855;
  const Real x1862 = x1750 * x1802 - (x1794 + x1732 * x1798);
  const Real x1863 = x1778 * x1807 + x1862;
  w.x[64] = x1863;
  w.to[0][7] = x1863;
  const Real x1868 = x1797 - x1750 * x1803 + x1778 * x1808;
  w.x[65] = x1868;
  w.to[0][8] = x1868;
  const Real x1871 = x1801 - x1778 * x1809;
  w.x[66] = x1871;
  w.to[0][9] = x1871;
  const Real x1877 = x1634 + x1635 * x1798 + x1754 * x1802;
  const Real x1878 = x1785 * x1807 + x1877;
  w.x[67] = x1878;
  w.to[0][11] = x1878;
  const Real x1884 = x1785 * x1808 - (x1798 + x1754 * x1803);
  w.x[68] = x1884;
  w.to[0][12] = x1884;
  const Real x1887 = x1802 - x1785 * x1809;
  w.x[69] = x1887;
  w.to[0][13] = x1887;
  const Real x1892 = x1665 + x1666 * x1803 + x1789 * x1808;
  w.x[70] = x1892;
  w.to[0][15] = x1892;
  const Real x1895 = x1803 + x1789 * x1809;
  w.x[71] = x1895;
  const Real x1896 = -x1895;
  w.to[0][16] = x1896;
  const Real x1899 = x1692 + x1693 * x1809;
  w.x[72] = x1899;
  w.to[0][18] = x1899;
  const Real x1907 = x1578 * x1821 + x1583 * x1805 + x1579 * x1831;
  const Real x1909 = x1580 * x1838 + x1907 + x1581 * x1843;
  const Real x1910 = x1582 * x1846 + x1909;
  w.x[73] = x1910;
  const Real x1918 = x1578 * x1831 + x1583 * x1806 + x1579 * x1855;
  const Real x1920 = x1580 * x1863 + x1918 + x1581 * x1868;
  const Real x1921 = x1582 * x1871 + x1920;
  w.x[74] = x1921;
  const Real x1929 = x1578 * x1838 + x1583 * x1807 + x1579 * x1863;
  const Real x1931 = x1580 * x1878 + x1929 + x1581 * x1884;
  const Real x1932 = x1582 * x1887 + x1931;
  w.x[75] = x1932;
  const Real x1941 = x1578 * x1843 + x1583 * x1808 + x1579 * x1868;
  const Real x1943 = x1580 * x1884 + x1941 + x1581 * x1892;
  const Real x1944 = x1943 - x1582 * x1895;
  w.x[76] = x1944;
  const Real x1954 = x1578 * x1846 - x1583 * x1809 + x1579 * x1871;
  const Real x1956 = x1580 * x1887 + x1954 - x1581 * x1895;
  const Real x1957 = x1582 * x1899 + x1956;
  w.x[77] = x1957;
  const Real x1966 = x1578 * x1805 + x1583 * x1709 + x1579 * x1806;
  const Real x1968 = x1580 * x1807 + x1966 + x1581 * x1808;
  const Real x1969 = x1968 - x1582 * x1809;
  w.x[78] = x1969;
  const Real x1970 = -x1910;
  w.to[0][21] = x1970;
  const Real x1971 = -x1921;
  w.to[0][22] = x1971;
  const Real x1972 = -x1932;
  w.to[0][23] = x1972;
  const Real x1973 = -x1944;
  w.to[0][24] = x1973;
  const Real x1974 = -x1957;
  w.to[0][25] = x1974;
  const Real x1975 = -x1969;
  w.to[0][26] = x1975;
}

ADAGEN_NOINLINE void part_2_2(Workspace& w) {
  ADAGEN_INPUTS
  const Real x1572 = w.x[29];
  const Real x1574 = w.x[31];
  const Real x1575 = w.x[32];
  const Real x1576 = w.x[33];
  const Real x1577 = w.x[34];
  const Real x1592 = w.x[47];
  const Real x1615 = w.x[48];
  const Real x1646 = w.x[49];
  const Real x1679 = w.x[50];
  const Real x1708 = w.x[51];
  // link 12 "rod12": mobility from its articulated-body inertia
  const Real x1713 = x1575 * 1.7763568394002505e-15;
  require_more(w, x1646, x1713, kFactorization, 11);
  const Real x1712 = x1574 * 1.7763568394002505e-15;
  require_more(w, x1615, x1712, kFactorization, 11);
  const Real x1714 = x1576 * 1.7763568394002505e-15;
  require_more(w, x1679, x1714, kFactorization, 11);
  const Real x1715 = x1577 * 1.7763568394002505e-15;
  require_more(w, x1708, x1715, kFactorization, 11);
  const Real x1711 = x1572 * 1.7763568394002505e-15;
  require_more(w, x1592, x1711, kFactorization, 11);
}

ADAGEN_NOINLINE void part_2_3(Workspace& w) {
  ADAGEN_INPUTS
  const Real x1035 = w.x[0];
  const Real x1114 = w.x[1];
  const Real x1115 = w.x[2];
  const Real x1116 = w.x[3];
  const Real x1237 = w.x[4];
  const Real x1238 = w.x[5];
  const Real x1239 = w.x[6];
  const Real x1241 = w.x[7];
  const Real x1242 = w.x[8];
  const Real x1400 = w.x[9];
  const Real x1401 = w.x[10];
  const Real x1403 = w.x[11];
  const Real x1404 = w.x[12];
  const Real x1405 = w.x[13];
  const Real x1406 = w.x[14];
  const Real x1709 = w.x[52];
  const Real x1805 = w.x[53];
  const Real x1806 = w.x[54];
  const Real x1807 = w.x[55];
  const Real x1808 = w.x[56];
  const Real x1809 = w.x[57];
  const Real x1821 = w.x[58];
  const Real x1831 = w.x[59];
  const Real x1838 = w.x[60];
  const Real x1843 = w.x[61];
  const Real x1846 = w.x[62];
  const Real x1855 = w.x[63];
  const Real x1863 = w.x[64];
  const Real x1868 = w.x[65];
  const Real x1871 = w.x[66];
  const Real x1878 = w.x[67];
  const Real x1884 = w.x[68];
  const Real x1887 = w.x[69];
  const Real x1892 = w.x[70];
  const Real x1895 = w.x[71];
  const Real x1899 = w.x[72];
  const Real x1910 = w.x[73];
  const Real x1921 = w.x[74];
  const Real x1932 = w.x[75];
  const Real x1944 = w.x[76];
  const Real x1957 = w.x[77];
  const Real x1969 = w.x[78];
  // message received
  const Real x1976 = w.from[3][0];
  const Real x1981 = w.from[3][5];
  const Real x1977 = w.from[3][1];
  const Real x1978 = w.from[3][2];
  const Real x1979 = w.from[3][3];
  const Real x1980 = w.from[3][4];
  // link 12 "rod12": acceleration under the handle forces
  const Real x2000 = x1831 * x1976 + x1806 * x1981 + x1855 * x1977;
  const Real x2011 = x1838 * x1976 + x1807 * x1981 + x1863 * x1977;
  const Real x1989 = x1821 * x1976 + x1805 * x1981 + x1831 * x1977;
  const Real x2036 = x1846 * x1976 - x1809 * x1981 + x1871 * x1977;
  const Real x2048 = x1805 * x1976 + x1709 * x1981 + x1806 * x1977;
  const Real x2023 = x1843 * x1976 + x1808 * x1981 + x1868 * x1977;
  const Real x2002 = x1863 * x1978 + x2000 + x1868 * x1979;
  const Real x2013 = x1878 * x1978 + x2011 + x1884 * x1979;
  const Real x1991 = x1838 * x1978 + x1989 + x1843 * x1979;
  const Real x2038 = x1887 * x1978 + x2036 - x1895 * x1979;
  const Real x2050 = x1807 * x1978 + x2048 + x1808 * x1979;
  const Real x2053 = x1871 * x1980 + x2002 - x1921;
  const Real x2054 = x1887 * x1980 + x2013 - x1932;
  const Real x2052 = x1846 * x1980 + x1991 - x1910;
  const Real x2025 = x1884 * x1978 + x2023 + x1892 * x1979;
  const Real x2057 = x2050 - x1809 * x1980 - x1969;
  // joint 12 "joint13": its acceleration, and that of the link beyond
  const Real x2065 = cosine[12] * x2053 + sine[12] * x2054;
  const Real x2062 = x1899 * x1980 + x2038 - x1957 + 0.4 * x2052;
  const Real x2069 = cosine[12] * x2054 - sine[12] * x2053;
  const Real x2060 = x2025 - x1895 * x1980 - x1944 - 0.4 * x2053;
  const Real x2072 = cosine[12] * x2062 + sine[12] * x2057;
  const Real x2076 = cosine[12] * x2057 - sine[12] * x2062;
  const Real x2088 = x1400 + x1401 * x2065 - x1403 * x2069;
  const Real x2090 = x2088 - x1406 * x2060 - x1404 * x2072;
  const Real x2091 = x2090 - x1405 * x2076;
  const Real x2092 = x2091 - x2052;
  w.result[12] = x2092;
  // joint 13 "joint14": its acceleration, and that of the link beyond
  const Real x2097 = x2060 - 0.4 * x2065;
  const Real x2107 = cosine[13] * x2076 + sine[13] * x2097;
  const Real x2111 = cosine[13] * x2097 - sine[13] * x2076;
  const Real x2104 = cosine[13] * x2091 - sine[13] * x2069;
  const Real x2094 = x2072 + 0.4 * x2091;
  const Real x2121 = x1237 + x1239 * x2107 - x1241 * x2111;
  const Real x2123 = x2121 - x1238 * x2104 + x1242 * x2094;
  const Real x2124 = x2123 - x2065;
  w.result[13] = x2124;
  // joint 14 "joint15": its acceleration, and that of the link beyond
  const Real x2129 = x2094 + 0.4 * x2104;
  const Real x2127 = x2111 - 0.4 * x2123;
  const Real x2132 = cosine[14] * x2104 + sine[14] * x2123;
  const Real x2148 = x1114 - x1115 * (cosine[14] * x2123 - sine[14] * x2104);
  const Real x2149 = x1116 * (cosine[14] * x2127 + sine[14] * x2129) + x2148;
  const Real x2150 = x2149 - (cosine[13] * x2069 + sine[13] * x2091);
  w.result[14] = x2150;
  // joint 15 "joint16": its acceleration, and that of the link beyond
  const Real x2155 = cosine[14] * x2129 - sine[14] * x2127 + 0.4 * x2132;
  const Real x2172 = x1035 - 3.742984243907825 * (cosine[15] * x2155 + sine[15] * x2107);
  const Real x2173 = x2172 - x2132;
  w.result[15] = x2173;
}

// ---- 5. processes -------------------------------------------------------------------------------

// Process 0: 8 of 16 joints: "joint01", "joint02", "joint03", "joint04", "joint05", "joint06", ...
constexpr std::array<int, 8> kRead_0{0, 1, 2, 3, 4, 5, 6, 7};
constexpr std::array<int, 8> kOwned_0{0, 1, 2, 3, 4, 5, 6, 7};

void run_0([[maybe_unused]] Workspace& w, [[maybe_unused]] Channel& channel) {
  ADAGEN_INPUTS
  stamp(0);
  if (!all(unlike_zero(q + 0, 8) + unlike_zero(v + 0, 8) + unlike_zero(tau + 0, 8) == 0))
    name_what_is_not_finite(w, kRead_0, kOwned_0);
  w.to[2] = channel.outgoing(2, w.status);
  take_sines_and_cosines<8>(q + 0, w.sine.data(), w.cosine.data());
  w.to[2][2] = tau[7];
  part_0_0(w);
  part_0_1(w);
  stamp(1);
  stamp(2);
  w.from[1] = channel.receive(1, w.status);  // from process 1: assembled: chain of "joint12"
  stamp(3);
  part_0_2(w);
  stamp(4);
  stamp(5);
  channel.send(2, w.status);  // to process 1: forces on: chain of "joint12"
  stamp(6);
  part_0_3(w);
  stamp(7);
  if (!all(unlike_zero(w.result.data() + 0, 8) == 0)) name_what_overflows(w, kOwned_0);
  if (w.status != kFine) return;
  std::copy_n(w.result.data() + 0, 8, w.qdd + 0);
}

// Process 1: 4 of 16 joints: "joint09", "joint10", "joint11", "joint12"; kinematics of 8 more on the way to the ground
constexpr std::array<int, 12> kRead_1{0, 1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11};
constexpr std::array<int, 4> kOwned_1{8, 9, 10, 11};

void run_1([[maybe_unused]] Workspace& w, [[maybe_unused]] Channel& channel) {
  ADAGEN_INPUTS
  stamp(0);
  if (!all(unlike_zero(q + 0, 12) + unlike_zero(v + 0, 12) + unlike_zero(tau + 8, 4) == 0))
    name_what_is_not_finite(w, kRead_1, kOwned_1);
  w.to[1] = channel.outgoing(1, w.status);
  w.to[3] = channel.outgoing(3, w.status);
  take_sines_and_cosines<12>(q + 0, w.sine.data(), w.cosine.data());
  w.to[3][2] = tau[11];
  part_1_0(w);
  part_1_1(w);
  stamp(1);
  stamp(2);
  w.from[0] = channel.receive(0, w.status);  // from process 2: assembled: chain of "joint14"
  stamp(3);
  part_1_2(w);
  stamp(4);
  channel.send(1, w.status);  // to process 0: assembled: chain of "joint12"
  stamp(5);
  part_1_3(w);
  w.from[2] = channel.receive(2, w.status);  // from process 0: forces on: chain of "joint12"
  stamp(6);
  part_1_4(w);
  stamp(7);
  channel.send(3, w.status);  // to process 2: forces on: chain of "joint14"
  stamp(8);
  part_1_5(w);
  stamp(9);
  if (!all(unlike_zero(w.result.data() + 8, 4) == 0)) name_what_overflows(w, kOwned_1);
  if (w.status != kFine) return;
  std::copy_n(w.result.data() + 8, 4, w.qdd + 8);
}

// Process 2: 4 of 16 joints: "joint13", "joint14", "joint15", "joint16"; kinematics of 12 more on the way to the ground
constexpr std::array<int, 16> kRead_2{0, 1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12, 13, 14, 15};
constexpr std::array<int, 4> kOwned_2{12, 13, 14, 15};

void run_2([[maybe_unused]] Workspace& w, [[maybe_unused]] Channel& channel) {
  ADAGEN_INPUTS
  stamp(0);
  if (!all(unlike_zero(q + 0, 16) + unlike_zero(v + 0, 16) + unlike_zero(tau + 12, 4) == 0))
    name_what_is_not_finite(w, kRead_2, kOwned_2);
  w.to[0] = channel.outgoing(0, w.status);
  take_sines_and_cosines<16>(q + 0, w.sine.data(), w.cosine.data());
  part_2_0(w);
  part_2_1(w);
  stamp(1);
  stamp(2);
  channel.send(0, w.status);  // to process 1: assembled: chain of "joint14"
  stamp(3);
  part_2_2(w);
  w.from[3] = channel.receive(3, w.status);  // from process 1: forces on: chain of "joint14"
  stamp(4);
  part_2_3(w);
  stamp(5);
  if (!all(unlike_zero(w.result.data() + 12, 4) == 0)) name_what_overflows(w, kOwned_2);
  if (w.status != kFine) return;
  std::copy_n(w.result.data() + 12, 4, w.qdd + 12);
}

[[maybe_unused]] constexpr std::array<void (*)(Workspace&, Channel&), kProcesses> kRun{run_0, run_1, run_2};

// What each process reads of q and v, the velocity entries whose qdd is its own, and whose tau it
// reads.
constexpr std::array<Range, 1> kReadQ_0{ {{0, 8}} };
constexpr std::array<Range, 1> kReadV_0{ {{0, 8}} };
constexpr std::array<Range, 1> kOwn_0{ {{0, 8}} };
constexpr std::array<Range, 1> kTorque_0{ {{0, 8}} };
constexpr std::array<Range, 1> kReadQ_1{ {{0, 12}} };
constexpr std::array<Range, 1> kReadV_1{ {{0, 12}} };
constexpr std::array<Range, 1> kOwn_1{ {{8, 4}} };
constexpr std::array<Range, 1> kTorque_1{ {{8, 4}} };
constexpr std::array<Range, 1> kReadQ_2{ {{0, 16}} };
constexpr std::array<Range, 1> kReadV_2{ {{0, 16}} };
constexpr std::array<Range, 1> kOwn_2{ {{12, 4}} };
constexpr std::array<Range, 1> kTorque_2{ {{12, 4}} };
[[maybe_unused]] constexpr std::array<ProcessInfo, kProcesses> kProcess{ {
    {{1, kReadQ_0.data()}, {1, kReadV_0.data()}, {1, kOwn_0.data()}, {1, kTorque_0.data()}},
    {{1, kReadQ_1.data()}, {1, kReadV_1.data()}, {1, kOwn_1.data()}, {1, kTorque_1.data()}},
    {{1, kReadQ_2.data()}, {1, kReadV_2.data()}, {1, kOwn_2.data()}, {1, kTorque_2.data()}},
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

struct chain16_p3_solver : Solver {};

extern "C" {

int chain16_p3_joint(int k, const char** name, int* q, int* nq, int* v, int* nv) {
  if (k < 0 || k >= kJointCount) return 0;
  const JointConstants& joint = kJoints[k];
  *name = joint.name, *q = joint.q, *nq = joint.nq, *v = joint.v, *nv = joint.nv;
  return 1;
}

chain16_p3_solver* chain16_p3_open(MPI_Comm comm, const char* channel, double time_limit) {
  int size = 0;
  MPI_Comm_size(comm, &size);
  const std::string kind = channel;
  if (size != kProcesses || (kind != "auto" && kind != "window" && kind != "message")) return nullptr;
  auto* const solver = new chain16_p3_solver;
  const ChannelMode mode = kind == "window"    ? ChannelMode::kWindow
                           : kind == "message" ? ChannelMode::kMessage
                                               : ChannelMode::kAuto;
  if (solver->channel.open(comm, mode, time_limit).empty()) return solver;
  chain16_p3_close(solver);
  return nullptr;
}

int chain16_p3_solve(chain16_p3_solver* solver, const double* q, const double* v, const double* tau, double* qdd) {
  return solver->solve(q, v, tau, qdd);
}

int chain16_p3_solve_at_root(chain16_p3_solver* solver, const double* q, const double* v, const double* tau, double* qdd) {
  return solver->solve_at_root(q, v, tau, qdd);
}

const char* chain16_p3_failure(const chain16_p3_solver* solver) { return solver->text.c_str(); }

void chain16_p3_close(chain16_p3_solver* solver) {
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
constexpr std::array<Stage, 7> kStages_0{ {
    {"kinematics", 7, -1},
    {"assembly", 6, -1},
    {"receive", -1, 1},
    {"assembly", 7, -1},
    {"disassembly", 7, -1},
    {"send", -1, 2},
    {"disassembly", 6, -1},
} };
constexpr std::array<Stage, 9> kStages_1{ {
    {"kinematics", 11, -1},
    {"assembly", 10, -1},
    {"receive", -1, 0},
    {"assembly", 11, -1},
    {"send", -1, 1},
    {"receive", -1, 2},
    {"disassembly", 11, -1},
    {"send", -1, 3},
    {"disassembly", 10, -1},
} };
constexpr std::array<Stage, 5> kStages_2{ {
    {"kinematics", 15, -1},
    {"assembly", 12, -1},
    {"send", -1, 0},
    {"receive", -1, 3},
    {"disassembly", 12, -1},
} };
constexpr std::array<const Stage*, kProcesses> kStages{kStages_0.data(), kStages_1.data(), kStages_2.data()};
constexpr std::array<int, kProcesses> kStageCount{7, 9, 5};

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
