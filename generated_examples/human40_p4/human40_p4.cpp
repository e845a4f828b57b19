// Forward dynamics of "human40" on 4 processes, emitted by adagen 0.1.0 (solver.cpp.j2). Do not edit: emit anew.
//
// robot     "human40", 15 joints, 40 degrees of freedom, description sha256 bdc16488e5ef4610f46ad114b2f2b09a8601d7b212cf0d9aa1794a195cd4ce35
// options   form segment, shape unrolled, scalar double, channel auto, fixed base, gravity 0.0, 0.0, -9.81
// program   4 processes, joined at cuts; 0.817 us predicted (default profile)
//           process 0: root .. left_hip, right_hip .. spine
//           process 1: left_knee .. left_ankle
//           process 2: left_shoulder, neck .. right_wrist
//           process 3: left_elbow .. left_wrist
// schedule  spine@0-3(left_hip@0-1(right_hip@0(root | right_knee(|right_ankle)) | left_knee@1(|left_ankle)) | left_shoulder@2-3(right_shoulder@2(neck | right_elbow(|right_wrist)) | left_elbow@3(|left_wrist)))
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
typedef struct human40_p4_solver human40_p4_solver;

// Joints in order, each with its place in the state: human40_p4_joint gives name, start and size in q
// and v of joint k, or returns 0 where there is none.
int human40_p4_joint(int k, const char** name, int* q, int* nq, int* v, int* nv);

// Collective over a communicator of 4 processes. channel: "auto", "window" or "message";
// time_limit: seconds that a process waits for another. Returns null where it cannot be done.
human40_p4_solver* human40_p4_open(MPI_Comm comm, const char* channel, double time_limit);

// One evaluation, collective. q: 51 numbers, v and tau: 40 each, qdd: 40; joints in order,
// quaternions x y z w (normalised here), floating joints [linear; angular] in the body's frame.
// solve: every process passes the state and gets its own joints' accelerations (others untouched);
// solve_at_root: process 0 passes the state and gets them all, the others may pass null.
// Returns 0, or what human40_p4_failure puts into words; no acceleration is written then.
int human40_p4_solve(human40_p4_solver* solver, const double* q, const double* v, const double* tau, double* qdd);
int human40_p4_solve_at_root(human40_p4_solver* solver, const double* q, const double* v, const double* tau, double* qdd);

// The last failure in words; valid until the next call.
const char* human40_p4_failure(const human40_p4_solver* solver);

// Collective.
void human40_p4_close(human40_p4_solver* solver);
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
constexpr int kProcesses = 4;
constexpr int kJointCount = 15, kLinkCount = kJointCount + 1;
constexpr int kNq = 51, kNv = 40;
constexpr int kOuterCount = 0, kNtau = kNv + 6 * kOuterCount;
[[maybe_unused]] constexpr int kColumns = 1;  // right-hand sides: the motion, and one per slaved joint
[[maybe_unused]] constexpr bool kBatch = false;  // whether many states are solved at once
[[maybe_unused]] constexpr int kRefine = 0;  // steps of iterative refinement
[[maybe_unused]] constexpr int kPlanMessages = 6;
constexpr std::size_t kCacheLine = 64;
[[maybe_unused]] constexpr bool kFloatingBase = false;
[[maybe_unused]] constexpr double kTolerance = 1e-09;
[[maybe_unused]] constexpr int kRandomStates = 64;
[[maybe_unused]] constexpr const char* kRobot = "human40";
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
    {"world", 0.0, {0.0, 0.0, 0.0},
     {0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0},
     {}},
    {"pelvis", 9.6, {0.0, 0.0, 0.03},
     {0.104, 0.0, 0.0, 0.0, 0.05248, 0.0, 0.0, 0.0, 0.09248},
     {}},
    {"left_thigh", 8.4, {0.0, 0.0, -0.19},
     {0.12544, 0.0, 0.0, 0.0, 0.12544, 0.0, 0.0, 0.0, 0.02688},
     {}},
    {"left_shank", 3.2, {-0.18, 0.0, 0.0},
     {0.004, 0.0, 0.0, 0.0, 0.0446667, 0.0, 0.0, 0.0, 0.0446667},
     {}},
    {"left_foot", 1.0, {0.06, 0.0, -0.04},
     {0.00108333, 0.0, 0.0, 0.0, 0.00561667, 0.0, 0.0, 0.0, 0.00588333},
     {}},
    {"right_thigh", 8.4, {0.0, 0.0, -0.19},
     {0.12544, 0.0, 0.0, 0.0, 0.12544, 0.0, 0.0, 0.0, 0.02688},
     {}},
    {"right_shank", 3.2, {-0.18, 0.0, 0.0},
     {0.004, 0.0, 0.0, 0.0, 0.0446667, 0.0, 0.0, 0.0, 0.0446667},
     {}},
    {"right_foot", 1.0, {0.06, 0.0, -0.04},
     {0.00108333, 0.0, 0.0, 0.0, 0.00561667, 0.0, 0.0, 0.0, 0.00588333},
     {}},
    {"trunk", 23.0, {0.0, 0.0, 0.23},
     {0.601833, 0.0, 0.0, 0.0, 0.467667, 0.0, 0.0, 0.0, 0.258367},
     {}},
    {"left_upper_arm", 1.9, {0.0, 0.0, -0.14},
     {0.0133752, 0.0, 0.0, 0.0, 0.0133752, 0.0, 0.0, 0.0, 0.00192375},
     {}},
    {"left_forearm", 1.1, {-0.12, 0.0, 0.0},
     {0.00067375, 0.0, 0.0, 0.0, 0.00606604, 0.0, 0.0, 0.0, 0.00606604},
     {}},
    {"left_hand", 0.42, {0.0, 0.0, -0.08},
     {0.0012355, 0.0, 0.0, 0.0, 0.001043, 0.0, 0.0, 0.0, 0.0002555},
     {}},
    {"head", 4.9, {0.01, 0.0, 0.14},
     {0.0196, 0.0, 0.0, 0.0, 0.0196, 0.0, 0.0, 0.0, 0.0196},
     {}},
    {"right_upper_arm", 1.9, {0.0, 0.0, -0.14},
     {0.0133752, 0.0, 0.0, 0.0, 0.0133752, 0.0, 0.0, 0.0, 0.00192375},
     {}},
    {"right_forearm", 1.1, {-0.12, 0.0, 0.0},
     {0.00067375, 0.0, 0.0, 0.0, 0.00606604, 0.0, 0.0, 0.0, 0.00606604},
     {}},
    {"right_hand", 0.42, {0.0, 0.0, -0.08},
     {0.0012355, 0.0, 0.0, 0.0, 0.001043, 0.0, 0.0, 0.0, 0.0002555},
     {}},
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

constexpr std::array<MessageInfo, 12> kMessages{ {
    {1, 0, 42},  // 0: assembled: chain of "left_knee"
    {3, 2, 42},  // 1: assembled: chain of "left_elbow"
    {2, 0, 42},  // 2: assembled: chain of "left_shoulder"
    {0, 2, 6},  // 3: forces on: chain of "left_shoulder"
    {0, 1, 6},  // 4: forces on: chain of "left_knee"
    {2, 3, 6},  // 5: forces on: chain of "left_elbow"
    {0, 1, 33},  // 6: state
    {1, 0, 4},  // 7: accelerations
    {0, 2, 63},  // 8: state
    {2, 0, 13},  // 9: accelerations
    {0, 3, 40},  // 10: state
    {3, 0, 4},  // 11: accelerations
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
  alignas(kCacheLine) std::array<Value, 1> angle{}, sine{}, cosine{};
  std::array<Value, kNv> result{};
  std::array<Real*, kPlanMessages> to{};          // messages to be sent
  std::array<const Real*, kPlanMessages> from{};  // messages received
  alignas(kCacheLine) std::array<Value, 195> x{};
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
// Process 0: 1541 products, 1274 sums, 21 quotients
// =================================================================================================

ADAGEN_NOINLINE void part_0_0(Workspace& w) {
  ADAGEN_INPUTS
  // joint 0 "root": placement, velocity and reference acceleration of its link
  const Real x70 = v[3] * v[3];
  const Real x75 = v[3] * v[4];
  const Real x78 = v[4] * v[5];
  const Real x81 = v[3] * v[5];
  const Real x79 = x70 + v[4] * v[4];
  const Real x20 = q[3] * q[3] + q[4] * q[4] + q[5] * q[5];
  const Real x21 = q[6] * q[6] + x20;
  require_length(w, x21, 0);
  const Real x58 = v[2] * v[4] - v[1] * v[5];
  w.x[0] = x58;
  const Real x63 = v[0] * v[5] - v[2] * v[3];
  w.x[1] = x63;
  const Real x68 = v[1] * v[3] - v[0] * v[4];
  w.x[2] = x68;
  const Real x24 = 1 / x21 * 2.0;
  w.x[3] = x24;
  // joint 1 "left_hip": placement, velocity and reference acceleration of its link
  const Real x94 = q[7] * q[7] + q[8] * q[8] + q[9] * q[9];
  const Real x95 = q[10] * q[10] + x94;
  require_length(w, x95, 1);
  const Real x96 = 1 / x95;
  w.x[4] = x96;
  // joint 4 "right_hip": placement, velocity and reference acceleration of its link
  const Real x280 = x75 * 0.09 + x81 * 0.04;
  const Real x220 = q[16] * q[16] + q[17] * q[17] + q[18] * q[18];
  const Real x221 = q[19] * q[19] + x220;
  require_length(w, x221, 4);
  const Real x284 = x79 * 0.04 - x78 * 0.09;
  const Real x282 = (x70 + v[5] * v[5]) * 0.09 - x78 * 0.04;
  const Real x223 = 2.0 * (1 / x221);
  const Real x224 = q[16] * x223;
  const Real x225 = q[17] * x223;
  const Real x226 = q[18] * x223;
  const Real x227 = q[17] * x225;
  const Real x228 = q[18] * x226;
  // joint 6 "right_ankle": placement, velocity and reference acceleration of its link
  const Real x400 = q[21] * q[21] + q[22] * q[22] + q[23] * q[23];
  const Real x401 = q[24] * q[24] + x400;
  require_length(w, x401, 6);
  const Real x403 = 2.0 * (1 / x401);
  const Real x405 = q[22] * x403;
  const Real x406 = q[23] * x403;
  const Real x404 = q[21] * x403;
  const Real x407 = q[22] * x405;
  const Real x408 = q[23] * x406;
  const Real x414 = q[23] * x404;
  const Real x415 = q[24] * x405;
  const Real x411 = q[22] * x404;
  const Real x412 = q[24] * x406;
  const Real x418 = q[21] * x404;
  const Real x421 = q[23] * x405;
  const Real x422 = q[24] * x404;
  // joint 7 "spine": placement, velocity and reference acceleration of its link
  const Real x533 = q[25] * q[25] + q[26] * q[26] + q[27] * q[27];
  const Real x534 = q[28] * q[28] + x533;
  require_length(w, x534, 7);
  const Real x535 = 1 / x534;
  w.x[5] = x535;
  // joint 0 "root": its torque on the base
  const Real x814 = x78 * 0.031360000000000006 - tau[3];
  w.x[6] = x814;
  const Real x812 = x79 * 0.288 + tau[2];
  w.x[7] = x812;
  const Real x815 = x81 * 0.020159999999999987 - tau[4];
  w.x[8] = x815;
  const Real x816 = x75 * 0.051519999999999996 + tau[5];
  w.x[9] = x816;
  const Real x810 = x81 * 0.288 - tau[0];
  w.x[10] = x810;
  const Real x811 = x78 * 0.288 - tau[1];
  w.x[11] = x811;
  // joint 4 "right_hip": placement, velocity and reference acceleration of its link
  const Real x231 = q[17] * x224;
  const Real x232 = q[19] * x226;
  const Real x234 = q[18] * x224;
  const Real x235 = q[19] * x225;
  const Real x238 = q[16] * x224;
  const Real x241 = q[18] * x225;
  const Real x242 = q[19] * x224;
  const Real x233 = x231 - x232;
  w.x[12] = x233;
  const Real x236 = x234 + x235;
  w.x[13] = x236;
  const Real x237 = x231 + x232;
  w.x[14] = x237;
  const Real x243 = x241 - x242;
  w.x[15] = x243;
  const Real x244 = x234 - x235;
  w.x[16] = x244;
  const Real x245 = x241 + x242;
  w.x[17] = x245;
  const Real x230 = 1.0 - (x227 + x228);
  w.x[18] = x230;
  const Real x240 = 1.0 - (x228 + x238);
  w.x[19] = x240;
  // joint 6 "right_ankle": placement, velocity and reference acceleration of its link
  const Real x416 = x414 + x415;
  w.x[20] = x416;
  const Real x424 = x414 - x415;
  w.x[21] = x424;
  const Real x413 = x411 - x412;
  w.x[22] = x413;
  const Real x417 = x411 + x412;
  w.x[23] = x417;
  const Real x423 = x421 - x422;
  w.x[24] = x423;
  const Real x425 = x421 + x422;
  w.x[25] = x425;
  const Real x410 = 1.0 - (x407 + x408);
  w.x[26] = x410;
  const Real x420 = 1.0 - (x408 + x418);
  w.x[27] = x420;
  const Real x427 = 1.0 - (x407 + x418);
  w.x[28] = x427;
  // joint 6 "right_ankle": articulated-body inertia and bias force through it
  const Real x889 = x413 * 0.3237476001746317;
  const Real x880 = x425 * 0.3237476001746317;
  const Real x888 = x410 * 0.8520801688504872 - x416 * 0.2218797467242691;
  const Real x893 = x416 * 0.6671803799135964 - x410 * 0.2218797467242691;
  const Real x879 = x424 * 0.8520801688504872 - x427 * 0.2218797467242691;
  const Real x884 = x427 * 0.6671803799135964 - x424 * 0.2218797467242691;
  const Real x928 = x417 * (x417 * 0.8520801688504872 - x423 * 0.2218797467242691);
  const Real x930 = x423 * (x423 * 0.6671803799135964 - x417 * 0.2218797467242691);
  const Real x932 = x928 + x420 * (x420 * 0.3237476001746317) + x930;
  const Real x922 = x410 * x888 + x413 * x889 + x416 * x893;
  const Real x927 = x417 * x888 + x420 * x889 + x423 * x893;
  const Real x941 = 0.41 * x932;
  const Real x912 = x410 * x879 + x413 * x880 + x416 * x884;
  const Real x939 = 0.41 * x922;
  const Real x937 = 0.41 * x927;
  const Real x917 = x417 * x879 + x420 * x880 + x423 * x884;
  const Real x935 = 0.41 * x912;
  const Real x988 = -0.576 - x939;
  const Real x945 = 0.41 * x937;
  const Real x907 = x424 * x879 + x425 * x880 + x427 * x884;
  const Real x987 = 0.1483467 + 0.41 * x939;
  require_more(w, x987, 0.0, kFactorization, 5);
  // joint 4 "right_hip": placement, velocity and reference acceleration of its link
  const Real x247 = 1.0 - (x227 + x238);
  w.x[29] = x247;
  const Real x253 = v[4] * x237 + v[5] * x244 + v[3] * x230;
  const Real x258 = v[3] * x233 + v[5] * x245 + v[4] * x240;
  const Real x263 = v[3] * x236 + v[4] * x243 + v[5] * x247;
  const Real x290 = x237 * x282 + x244 * x284 - x230 * x280;
  const Real x264 = v[13] + x253;
  const Real x265 = v[14] + x258;
  const Real x266 = v[15] + x263;
  const Real x302 = x243 * x282 - x236 * x280 + x247 * x284;
  const Real x270 = v[15] * x258 - v[14] * x263;
  const Real x274 = v[13] * x263 - v[15] * x253;
  const Real x278 = v[14] * x253 - v[13] * x258;
  const Real x321 = x264 * x266;
  // joint 5 "right_knee": articulated-body inertia and bias force through it
  const Real x999 = 1 / x987;
  const Real x1002 = x945 * x999;
  w.x[30] = x1002;
  const Real x1007 = x937 * x999;
  w.x[31] = x1007;
  const Real x1004 = x935 * x999;
  w.x[32] = x1004;
  const Real x1006 = x988 * x999;
  w.x[33] = x1006;
  const Real x1011 = 0.1483467 + 0.41 * x941 - x945 * x1002;
  const Real x1020 = 0.576 + x941 - x945 * x1007;
  const Real x1038 = 3.2 + x932 - x937 * x1007;
  const Real x1023 = 3.2 + x907 - x935 * x1004;
  const Real x1032 = 3.2 + x922 - x988 * x1006;
  const Real x1014 = 0.41 * x917 - x945 * x1004;
  const Real x1017 = x937 + x945 * x1006;
  const Real x1026 = x912 + x935 * x1006;
  const Real x1029 = x917 - x935 * x1007;
  const Real x1035 = x927 + x988 * x1007;
  const Real x1052 = cosine[0] * x1020;
  const Real x1050 = sine[0] * x1020;
  const Real x1067 = cosine[0] * (0.004 - x1011);
  const Real x1100 = x1052 + 0.41 * x1038;
  const Real x1058 = cosine[0] * x1017 + sine[0] * x1014;
  const Real x1081 = sine[0] * x1029 + cosine[0] * x1035;
  const Real x1072 = cosine[0] * x1067;
  const Real x1142 = 1.596 + x1100;
  const Real x1086 = cosine[0] * (x1023 - x1032) - x1026 * (2.0 * sine[0]);
  const Real x1063 = cosine[0] * x1058;
  const Real x1060 = sine[0] * x1058;
  const Real x1078 = cosine[0] * x1029 - sine[0] * x1035;
  const Real x1093 = 0.41 * x1081;
  const Real x1116 = sine[0] * x1067 - 0.41 * x1050;
  // joint 4 "right_hip": placement, velocity and reference acceleration of its link
  const Real x319 = x264 * x264 + x265 * x265;
  const Real x323 = x274 + x321;
  const Real x316 = x265 * x266;
  const Real x317 = x316 - x270;
  // joint 5 "right_knee": placement, velocity and reference acceleration of its link
  const Real x332 = x266 * cosine[0] + x264 * sine[0];
  const Real x336 = x264 * cosine[0] - x266 * sine[0];
  const Real x337 = x265 + v[16];
  const Real x353 = x290 - x323 * 0.41;
  const Real x346 = x278 * cosine[0] + x270 * sine[0] + v[16] * x336;
  const Real x359 = x302 + x319 * 0.41;
  const Real x375 = x332 * x336;
  const Real x349 = x270 * cosine[0] - x278 * sine[0] - v[16] * x332;
  const Real x373 = x336 * x336 + x337 * x337;
  const Real x377 = x274 + x375;
  // joint 5 "right_knee": articulated-body inertia and bias force through it
  const Real x1090 = cosine[0] * x1086;
  const Real x1065 = x1017 - x1063;
  const Real x1095 = x1063 + x1093;
  const Real x1145 = x1011 + x1072 + 0.02688;
  w.x[34] = x1145;
  const Real x1092 = x1023 - x1090;
  const Real x1089 = x1026 + sine[0] * x1086;
  const Real x1112 = 0.41 * x1095;
  const Real x1103 = x1014 - x1060 + 0.41 * x1078;
  const Real x1111 = 0.004 - x1072 + (0.41 * x1052 + 0.41 * x1100);
  const Real x1141 = 0.42868 + x1111;
  require_more(w, x1141, 0.0, kFactorization, 4);
  const Real x1096 = 0.41 * x1092;
  const Real x1104 = 0.41 * x1089;
  const Real x1144 = -1.596 - x1096;
  const Real x1143 = 0.42868 + 0.41 * x1096;
  w.x[35] = x1143;
  // joint 4 "right_hip": articulated-body inertia and bias force through it
  const Real x1158 = 1 / x1141;
  const Real x1159 = x1112 * x1158;
  w.x[36] = x1159;
  const Real x1161 = x1116 * x1158;
  w.x[37] = x1161;
  const Real x1234 = x1095 * x1158;
  w.x[38] = x1234;
  const Real x1235 = x1142 * x1158;
  w.x[39] = x1235;
  const Real x1236 = x1103 * x1158;
  w.x[40] = x1236;
  const Real x1164 = x1143 - x1112 * x1159;
  w.x[41] = x1164;
  const Real x1167 = 0.41 * x1060 + x1116 * x1159;
  const Real x1205 = x1144 + x1095 * x1159;
  const Real x1208 = x1142 * x1159 - x1093;
  const Real x1211 = x1103 * x1159 - x1104;
  const Real x1168 = 1 / x1164;
  // joint 4 "right_hip": placement, velocity and reference acceleration of its link
  const Real x296 = x245 * x284 - x233 * x280 + x240 * x282;
  // joint 5 "right_knee": placement, velocity and reference acceleration of its link
  const Real x385 = x332 * x337;
  const Real x362 = cosine[0] * x359 + sine[0] * x353;
  const Real x366 = cosine[0] * x353 - sine[0] * x359;
  const Real x386 = x385 - x349;
  const Real x356 = x296 - x317 * 0.41;
  // joint 6 "right_ankle": placement, velocity and reference acceleration of its link
  const Real x432 = x332 * x424 + x337 * x417 + x336 * x410;
  const Real x437 = x332 * x425 + x337 * x420 + x336 * x413;
  const Real x442 = x332 * x427 + x337 * x423 + x336 * x416;
  const Real x443 = v[17] + x432;
  const Real x444 = v[18] + x437;
  const Real x445 = v[19] + x442;
  const Real x478 = x362 + 0.41 * x373;
  const Real x481 = x366 - 0.41 * x377;
  const Real x508 = x443 * x444;
  const Real x450 = x346 * x424 + x274 * x417 + x349 * x410;
  const Real x465 = v[19] * x437 - v[18] * x442 + x450;
  const Real x460 = x346 * x427 + x274 * x423 + x349 * x416;
  const Real x475 = v[18] * x432 - v[17] * x437 + x460;
  const Real x484 = x356 - 0.41 * x386;
  const Real x513 = x444 * x445;
  const Real x504 = x444 * x444;
  const Real x510 = x475 + x508;
  const Real x455 = x346 * x425 + x274 * x420 + x349 * x413;
  const Real x470 = v[17] * x442 - v[19] * x432 + x455;
  const Real x514 = x513 - x465;
  const Real x506 = x504 + x445 * x445;
  const Real x516 = x443 * x443 + x504;
  const Real x518 = x443 * x445;
  const Real x494 = x425 * x478 + x413 * x481 + x420 * x484;
  // joint 4 "right_hip": articulated-body inertia and bias force through it
  const Real x1169 = x1167 * x1168;
  w.x[42] = x1169;
  const Real x1237 = x1168 * x1205;
  w.x[43] = x1237;
  const Real x1238 = x1168 * x1208;
  w.x[44] = x1238;
  const Real x1239 = x1168 * x1211;
  w.x[45] = x1239;
  const Real x1175 = x1145 - x1116 * x1161 - x1167 * x1169;
  w.x[46] = x1175;
  const Real x1218 = x1060 + x1095 * x1161 + x1169 * x1205;
  const Real x1226 = x1050 + x1142 * x1161 + x1169 * x1208;
  const Real x1233 = x1065 - x1103 * x1161 - x1169 * x1211;
  const Real x1323 = x1032 + x1090 + 8.4 - x1103 * x1236;
  const Real x1176 = 1 / x1175;
  const Real x1240 = x1176 * x1218;
  w.x[47] = x1240;
  const Real x1242 = x1176 * x1226;
  w.x[48] = x1242;
  const Real x1244 = x1176 * x1233;
  w.x[49] = x1244;
  // joint 6 "right_ankle": placement, velocity and reference acceleration of its link
  const Real x489 = x424 * x478 + x410 * x481 + x417 * x484;
  // joint 4 "right_hip": articulated-body inertia and bias force through it
  const Real x1279 = 8.4 + x1092 - x1095 * x1234 - x1205 * x1237;
  const Real x1280 = x1279 - x1218 * x1240;
  const Real x1288 = x1081 - x1095 * x1235 - x1205 * x1238;
  const Real x1289 = x1288 - x1218 * x1242;
  const Real x1306 = 8.4 + x1038 - x1142 * x1235 - x1208 * x1238;
  const Real x1307 = x1306 - x1226 * x1242;
  const Real x1297 = x1089 - x1095 * x1236 - x1205 * x1239;
  const Real x1298 = x1218 * x1244 + x1297;
  const Real x1315 = x1078 - x1142 * x1236 - x1208 * x1239;
  const Real x1316 = x1226 * x1244 + x1315;
  const Real x1325 = x1323 - x1211 * x1239 - x1233 * x1244;
  const Real x1367 = x237 * x1280 + x240 * x1289 + x243 * x1298;
  const Real x1372 = x237 * x1289 + x240 * x1307 + x243 * x1316;
  const Real x1377 = x237 * x1298 + x240 * x1316 + x243 * x1325;
  const Real x1382 = x244 * x1280 + x245 * x1289 + x247 * x1298;
  const Real x1387 = x244 * x1289 + x245 * x1307 + x247 * x1316;
  const Real x1392 = x244 * x1298 + x245 * x1316 + x247 * x1325;
  const Real x1352 = x230 * x1280 + x233 * x1289 + x236 * x1298;
  const Real x1412 = x237 * x1367 + x240 * x1372 + x243 * x1377;
  const Real x1417 = x244 * x1367 + x245 * x1372 + x247 * x1377;
  const Real x1357 = x230 * x1289 + x233 * x1307 + x236 * x1316;
  const Real x1422 = x244 * x1382 + x245 * x1387 + x247 * x1392;
  const Real x1362 = x230 * x1298 + x233 * x1316 + x236 * x1325;
  // joint 6 "right_ankle": placement, velocity and reference acceleration of its link
  const Real x499 = x427 * x478 + x416 * x481 + x423 * x484;
  // link 7 "right_foot": force that the reference field takes
  const Real x759 = x465 * 0.00268333 - x513 * 0.00133334 + x510 * 0.0024;
  const Real x767 = x470 * 0.01081667 - x518 * 0.0068;
  const Real x776 = x475 * 0.00948333 + x508 * 0.00813334 - x514 * 0.0024;
  const Real x784 = 0.0024 * (x506 - x516) + x767 - 0.04 * x489;
  // joint 6 "right_ankle": articulated-body inertia and bias force through it
  const Real x830 = tau[17] - (x759 + 0.04 * x494);
  const Real x835 = tau[19] - (x776 + x494 * 0.06) - 0.8944110489578248 * x830;
  const Real x838 = 136.30025397304513 * x835;
  w.x[50] = x838;
  const Real x837 = 92.44989446844546 * (tau[18] - (x784 - x499 * 0.06));
  w.x[51] = x837;
  const Real x841 = 372.67127039909366 * x830 - 0.8944110489578248 * x838;
  w.x[52] = x841;
  // link 7 "right_foot": force that the reference field takes
  const Real x798 = x494 + x510 * 0.06 - 0.04 * x514;
  const Real x793 = x489 - x506 * 0.06 - 0.04 * (x470 + x518);
  // joint 6 "right_ankle": articulated-body inertia and bias force through it
  const Real x868 = x793 - 0.04 * x837;
  // link 7 "right_foot": force that the reference field takes
  const Real x803 = x499 + 0.04 * x516 + (x518 - x470) * 0.06;
  // joint 6 "right_ankle": articulated-body inertia and bias force through it
  const Real x875 = x803 - 0.06 * x837;
  const Real x872 = x798 + 0.06 * x838 + 0.04 * x841;
  // joint 4 "right_hip": articulated-body inertia and bias force through it
  const Real x1436 = 0.04 * x1412 - 0.09 * x1417;
  const Real x1443 = 0.04 * x1417 - 0.09 * x1422;
  const Real x1402 = x237 * x1352 + x240 * x1357 + x243 * x1362;
  const Real x1407 = x244 * x1352 + x245 * x1357 + x247 * x1362;
  const Real x1425 = 0.04 * x1402;
  const Real x1423 = 0.09 * x1407;
  const Real x1503 = 0.04 * x1436 - 0.09 * x1443 + 0.11263999999999999;
  require_more(w, x1503, 0.0, kFactorization, 0);
  const Real x1397 = x230 * x1352 + x233 * x1357 + x236 * x1362;
  const Real x1427 = x1425 - x1423;
  const Real x1428 = 0.04 * x1397;
  const Real x1451 = 0.04 * x1427;
  const Real x1453 = 0.09 * x1427;
  const Real x1430 = 0.09 * x1397;
  const Real x1505 = 0.06112 + 0.04 * x1428;
  w.x[53] = x1505;
  const Real x1507 = 0.09248 + 0.09 * x1430;
  w.x[54] = x1507;
  // link 1 "pelvis": mobility from its articulated-body inertia
  const Real x1517 = 1 / x1503;
  const Real x1518 = x1451 * x1517;
  const Real x1520 = x1453 * x1517;
  // joint 6 "right_ankle": articulated-body inertia and bias force through it
  const Real x973 = x410 * x868 + x416 * x875 + x413 * x872;
  const Real x978 = x417 * x868 + x423 * x875 + x420 * x872;
  const Real x963 = x417 * tau[17] + x423 * tau[19] + x420 * tau[18];
  const Real x958 = x413 * tau[18] + x416 * tau[19] + x410 * tau[17];
  const Real x968 = x424 * x868 + x427 * x875 + x425 * x872;
  // link 6 "right_shank": force that the reference field takes
  const Real x725 = x274 * 0.1483467 + x375 * 0.1443467 - x366 * 0.576;
  const Real x722 = x349 * 0.1483467 - x385 * 0.1443467 + x356 * 0.576;
  // joint 6 "right_ankle": articulated-body inertia and bias force through it
  const Real x953 = x424 * tau[17] + x425 * tau[18] + x427 * tau[19];
  const Real x992 = x346 * 0.004 + x953;
  // joint 5 "right_knee": articulated-body inertia and bias force through it
  const Real x1001 = x999 * (tau[16] - (x963 - 0.41 * x973 + x725));
  w.x[55] = x1001;
  const Real x1041 = x958 + 0.41 * x978 + x722 - x945 * x1001;
  // joint 6 "right_ankle": articulated-body inertia and bias force through it
  const Real x995 = x362 * 3.2 + x373 * 0.576 + x968;
  // joint 5 "right_knee": articulated-body inertia and bias force through it
  const Real x1044 = x995 - x935 * x1001;
  // joint 6 "right_ankle": articulated-body inertia and bias force through it
  const Real x996 = x366 * 3.2 - x377 * 0.576 + x973;
  // joint 5 "right_knee": articulated-body inertia and bias force through it
  const Real x1046 = x996 + x988 * x1001;
  // joint 6 "right_ankle": articulated-body inertia and bias force through it
  const Real x997 = x356 * 3.2 - x386 * 0.576 + x978;
  // joint 5 "right_knee": articulated-body inertia and bias force through it
  const Real x1049 = x997 - x937 * x1001;
  // joint 4 "right_hip": articulated-body inertia and bias force through it
  const Real x1508 = 9.6 + x1397;
  w.x[56] = x1508;
  const Real x1504 = -0.288 + x1436;
  const Real x1509 = 9.6 + x1412;
  w.x[57] = x1509;
  // link 1 "pelvis": mobility from its articulated-body inertia
  const Real x1526 = x1505 - x1451 * x1518;
  w.x[58] = x1526;
  const Real x1529 = x1453 * x1518 - 0.09 * x1428;
  const Real x1539 = 1 / x1526;
  w.x[59] = x1539;
  const Real x1532 = 0.288 - x1428 + x1427 * x1518;
  const Real x1521 = x1427 * x1517;
  const Real x1540 = x1529 * x1539;
  const Real x1541 = x1532 * x1539;
  const Real x1535 = x1504 * x1518 - x1425;
  const Real x1549 = x1507 - x1453 * x1520 - x1529 * x1540;
  w.x[60] = x1549;
  const Real x1555 = x1430 - x1427 * x1520 - x1532 * x1540;
  const Real x1522 = x1504 * x1517;
  const Real x1568 = 1 / x1549;
  w.x[61] = x1568;
  const Real x1542 = x1535 * x1539;
  const Real x1561 = 0.09 * x1402 - x1504 * x1520 - x1535 * x1540;
  // joint 5 "right_knee": articulated-body inertia and bias force through it
  const Real x1134 = sine[0] * x1044 + cosine[0] * x1046;
  // link 5 "right_thigh": force that the reference field takes
  const Real x683 = x270 * 0.42868 - x316 * 0.4018 + x296 * 1.596;
  // joint 5 "right_knee": articulated-body inertia and bias force through it
  const Real x1137 = sine[0] * x992 + cosine[0] * x1041 + 0.41 * x1049;
  // link 5 "right_thigh": force that the reference field takes
  const Real x686 = x274 * 0.42868 + x321 * 0.4018 - x290 * 1.596;
  const Real x698 = x302 * 8.4 + x319 * 1.596;
  // joint 4 "right_hip": articulated-body inertia and bias force through it
  const Real x1510 = 9.6 + x1422;
  w.x[62] = x1510;
  // joint 5 "right_knee": articulated-body inertia and bias force through it
  const Real x1151 = cosine[0] * x992 - sine[0] * x1041 + x278 * 0.02688;
  // joint 4 "right_hip": articulated-body inertia and bias force through it
  const Real x1179 = tau[13] - (x683 + x1137);
  const Real x1180 = tau[14] - (tau[16] - 0.41 * x1134 + x686);
  const Real x1184 = x1180 + x1159 * x1179;
  // link 1 "pelvis": mobility from its articulated-body inertia
  const Real x1538 = x1443 * x1518 - 0.04 * x1407;
  const Real x1523 = x1443 * x1517;
  const Real x1569 = x1555 * x1568;
  w.x[63] = x1569;
  const Real x1570 = x1561 * x1568;
  const Real x1567 = x1423 - x1443 * x1520 - x1538 * x1540;
  const Real x1543 = x1538 * x1539;
  const Real x1579 = x1508 - x1427 * x1521 - x1532 * x1541;
  const Real x1580 = x1579 - x1555 * x1569;
  w.x[64] = x1580;
  const Real x1588 = x1402 - x1504 * x1521 - x1535 * x1541;
  const Real x1589 = x1588 - x1561 * x1569;
  const Real x1611 = x1509 - x1504 * x1522 - x1535 * x1542;
  const Real x1597 = x1407 - x1443 * x1521 - x1538 * x1541;
  const Real x1598 = x1597 - x1567 * x1569;
  const Real x1599 = 1 / x1580;
  w.x[65] = x1599;
  const Real x1571 = x1567 * x1568;
  const Real x1623 = x1417 - x1443 * x1522 - x1538 * x1542;
  const Real x1652 = x1520 + x1518 * x1540;
  const Real x1666 = x1540 * x1569 - x1541;
  w.x[66] = x1666;
  const Real x1639 = x1510 - x1443 * x1523 - x1538 * x1543;
  const Real x1727 = x1518 * x1539;
  const Real x1600 = x1589 * x1599;
  w.x[67] = x1600;
  const Real x1601 = x1598 * x1599;
  const Real x1728 = x1568 * x1652;
  w.x[68] = x1728;
  const Real x1730 = x1540 * x1568;
  w.x[69] = x1730;
  // joint 4 "right_hip": articulated-body inertia and bias force through it
  const Real x1190 = tau[15] - x1151 - x1161 * x1179 - x1169 * x1184;
  const Real x1193 = x1176 * x1190;
  w.x[70] = x1193;
  const Real x1196 = x1168 * x1184 - x1169 * x1193;
  w.x[71] = x1196;
  // joint 5 "right_knee": articulated-body inertia and bias force through it
  const Real x1152 = x290 * 8.4 - x323 * 1.596 + x1134;
  const Real x1153 = x296 * 8.4 - x317 * 1.596 + x1049;
  const Real x1154 = cosine[0] * x1044 - sine[0] * x1046 + x698;
  // joint 4 "right_hip": articulated-body inertia and bias force through it
  const Real x1202 = x1158 * x1179 - x1161 * x1193 + x1159 * x1196;
  w.x[72] = x1202;
  const Real x1465 = x233 * tau[14] + x236 * tau[15] + x230 * tau[13];
  w.x[73] = x1465;
  const Real x1467 = x240 * tau[14];
  w.x[74] = x1467;
  const Real x1331 = x1152 - x1060 * x1193 + x1144 * x1196;
  const Real x1332 = x1095 * x1202 + x1331;
  const Real x1339 = x1153 - x1050 * x1193 - x1093 * x1196;
  const Real x1340 = x1142 * x1202 + x1339;
  const Real x1346 = x1154 + x1065 * x1193 - x1104 * x1196;
  const Real x1347 = x1103 * x1202 + x1346;
  const Real x1469 = x237 * tau[13] + x243 * tau[15];
  w.x[75] = x1469;
  const Real x1471 = x244 * tau[13];
  w.x[76] = x1471;
  const Real x1472 = x245 * tau[14];
  w.x[77] = x1472;
  const Real x1488 = x247 * x1347;
  w.x[78] = x1488;
  const Real x1483 = x243 * x1347;
  w.x[79] = x1483;
  const Real x1478 = x236 * x1347;
  w.x[80] = x1478;
  const Real x1489 = x244 * x1332 + x245 * x1340;
  w.x[81] = x1489;
  const Real x1484 = x237 * x1332 + x240 * x1340;
  w.x[82] = x1484;
  const Real x1479 = x230 * x1332 + x233 * x1340;
  w.x[83] = x1479;
  // link 1 "pelvis": mobility from its articulated-body inertia
  const Real x1662 = x1569 * x1652 - (x1521 + x1518 * x1541);
  const Real x1613 = x1611 - x1561 * x1570 - x1589 * x1600;
  w.x[84] = x1613;
  const Real x1625 = x1623 - x1567 * x1570 - x1598 * x1600;
  const Real x1685 = x1540 * x1570 - x1542 - x1600 * x1666;
  w.x[85] = x1685;
  const Real x1689 = x1569 * x1600 - x1570;
  w.x[86] = x1689;
  const Real x1626 = 1 / x1613;
  w.x[87] = x1626;
  const Real x1677 = x1570 * x1652 - (x1522 + x1518 * x1542);
  const Real x1678 = x1677 - x1600 * x1662;
  w.x[88] = x1678;
  const Real x1702 = x1571 * x1652 - (x1523 + x1518 * x1543);
  const Real x1732 = x1599 * x1662;
  w.x[89] = x1732;
  const Real x1733 = x1599 * x1666;
  w.x[90] = x1733;
  const Real x1734 = x1569 * x1599;
  w.x[91] = x1734;
  const Real x1627 = x1625 * x1626;
  w.x[92] = x1627;
  const Real x1736 = x1626 * x1678;
  w.x[93] = x1736;
  const Real x1737 = x1626 * x1685;
  w.x[94] = x1737;
  const Real x1738 = x1626 * x1689;
  w.x[95] = x1738;
  const Real x1739 = x1600 * x1626;
  w.x[96] = x1739;
  const Real x1767 = x1662 * x1734;
  w.x[97] = x1767;
  const Real x1783 = x1540 * x1730;
  w.x[98] = x1783;
  const Real x1641 = x1639 - x1567 * x1571 - x1598 * x1601;
  const Real x1642 = x1641 - x1625 * x1627;
  w.x[99] = x1642;
  const Real x1704 = x1702 - x1601 * x1662 - x1627 * x1678;
  w.x[100] = x1704;
  const Real x1713 = x1540 * x1571 - x1543 - x1601 * x1666;
  const Real x1714 = x1713 - x1627 * x1685;
  w.x[101] = x1714;
  const Real x1643 = 1 / x1642;
  w.x[102] = x1643;
  const Real x1721 = x1569 * x1601 - x1571 - x1627 * x1689;
  w.x[103] = x1721;
  const Real x1725 = x1600 * x1627 - x1601;
  w.x[104] = x1725;
  const Real x1751 = x1678 * x1736;
  w.x[105] = x1751;
  const Real x1754 = x1517 + x1518 * x1727 + x1652 * x1728;
  const Real x1755 = x1662 * x1732 + x1754;
  w.x[106] = x1755;
  const Real x1761 = x1678 * x1737;
  w.x[107] = x1761;
  const Real x1764 = x1727 + x1652 * x1730 + x1662 * x1733;
  w.x[108] = x1764;
}

ADAGEN_NOINLINE void part_0_1(Workspace& w) {
  ADAGEN_INPUTS
  const Real x24 = w.x[3];
  const Real x58 = w.x[0];
  const Real x63 = w.x[1];
  const Real x68 = w.x[2];
  const Real x96 = w.x[4];
  const Real x247 = w.x[29];
  const Real x535 = w.x[5];
  const Real x810 = w.x[10];
  const Real x811 = w.x[11];
  const Real x812 = w.x[7];
  const Real x814 = w.x[6];
  const Real x815 = w.x[8];
  const Real x816 = w.x[9];
  const Real x1143 = w.x[35];
  const Real x1145 = w.x[34];
  const Real x1159 = w.x[36];
  const Real x1161 = w.x[37];
  const Real x1164 = w.x[41];
  const Real x1169 = w.x[42];
  const Real x1175 = w.x[46];
  const Real x1234 = w.x[38];
  const Real x1235 = w.x[39];
  const Real x1236 = w.x[40];
  const Real x1237 = w.x[43];
  const Real x1238 = w.x[44];
  const Real x1239 = w.x[45];
  const Real x1240 = w.x[47];
  const Real x1242 = w.x[48];
  const Real x1244 = w.x[49];
  const Real x1465 = w.x[73];
  const Real x1467 = w.x[74];
  const Real x1469 = w.x[75];
  const Real x1471 = w.x[76];
  const Real x1472 = w.x[77];
  const Real x1478 = w.x[80];
  const Real x1479 = w.x[83];
  const Real x1483 = w.x[79];
  const Real x1484 = w.x[82];
  const Real x1488 = w.x[78];
  const Real x1489 = w.x[81];
  const Real x1505 = w.x[53];
  const Real x1507 = w.x[54];
  const Real x1508 = w.x[56];
  const Real x1509 = w.x[57];
  const Real x1510 = w.x[62];
  const Real x1526 = w.x[58];
  const Real x1539 = w.x[59];
  const Real x1549 = w.x[60];
  const Real x1568 = w.x[61];
  const Real x1569 = w.x[63];
  const Real x1580 = w.x[64];
  const Real x1599 = w.x[65];
  const Real x1600 = w.x[67];
  const Real x1613 = w.x[84];
  const Real x1626 = w.x[87];
  const Real x1627 = w.x[92];
  const Real x1642 = w.x[99];
  const Real x1643 = w.x[102];
  const Real x1666 = w.x[66];
  const Real x1678 = w.x[88];
  const Real x1685 = w.x[85];
  const Real x1689 = w.x[86];
  const Real x1704 = w.x[100];
  const Real x1714 = w.x[101];
  const Real x1721 = w.x[103];
  const Real x1725 = w.x[104];
  const Real x1728 = w.x[68];
  const Real x1730 = w.x[69];
  const Real x1732 = w.x[89];
  const Real x1733 = w.x[90];
  const Real x1734 = w.x[91];
  const Real x1736 = w.x[93];
  const Real x1737 = w.x[94];
  const Real x1738 = w.x[95];
  const Real x1739 = w.x[96];
  const Real x1751 = w.x[105];
  const Real x1755 = w.x[106];
  const Real x1761 = w.x[107];
  const Real x1764 = w.x[108];
  const Real x1767 = w.x[97];
  const Real x1783 = w.x[98];
  // joint 0 "root": placement, velocity and reference acceleration of its link
  const Real x25 = q[3] * x24;
  const Real x26 = q[4] * x24;
  // joint 1 "left_hip": placement, velocity and reference acceleration of its link
  const Real x97 = 2.0 * x96;
  // joint 7 "spine": placement, velocity and reference acceleration of its link
  const Real x536 = 2.0 * x535;
  // joint 4 "right_hip": articulated-body inertia and bias force through it
  const Real x1490 = x1488 + x1489;
  const Real x1485 = x1483 + x1484;
  const Real x1480 = x1478 + x1479;
  const Real x1516 = x1490 - x812;
  const Real x1511 = x1465 - 0.09 * x1490 + 0.04 * x1485 + x814;
  const Real x1512 = x1467 + x1469 - 0.04 * x1480 + x815;
  const Real x1502 = x1471 + x1472 + x247 * tau[15] + 0.09 * x1480;
  const Real x1513 = x1502 - x816;
  // link 1 "pelvis": mobility from its articulated-body inertia
  const Real x1741 = x1643 * x1704;
  w.x[109] = x1741;
  const Real x1742 = x1643 * x1714;
  w.x[110] = x1742;
  const Real x1743 = x1643 * x1721;
  w.x[111] = x1743;
  const Real x1744 = x1643 * x1725;
  w.x[112] = x1744;
  const Real x1745 = x1627 * x1643;
  w.x[113] = x1745;
  const Real x1757 = x1751 + x1755 + x1704 * x1741;
  w.x[114] = x1757;
  const Real x1766 = x1761 + x1764 + x1704 * x1742;
  w.x[115] = x1766;
  const Real x1774 = x1678 * x1738 - (x1728 + x1767) + x1704 * x1743;
  w.x[116] = x1774;
  const Real x1779 = x1732 - x1678 * x1739 + x1704 * x1744;
  w.x[117] = x1779;
  const Real x1782 = x1736 - x1704 * x1745;
  w.x[118] = x1782;
  const Real x1790 = x1539 + x1783 + x1666 * x1733 + x1685 * x1737;
  const Real x1791 = x1714 * x1742 + x1790;
  w.x[119] = x1791;
  const Real x1798 = x1685 * x1738 - (x1730 + x1666 * x1734);
  const Real x1799 = x1714 * x1743 + x1798;
  w.x[120] = x1799;
  const Real x1804 = x1733 - x1685 * x1739 + x1714 * x1744;
  w.x[121] = x1804;
  const Real x1807 = x1737 - x1714 * x1745;
  w.x[122] = x1807;
  const Real x1813 = x1568 + x1569 * x1734 + x1689 * x1738;
  const Real x1814 = x1721 * x1743 + x1813;
  w.x[123] = x1814;
  const Real x1820 = x1721 * x1744 - (x1734 + x1689 * x1739);
  w.x[124] = x1820;
  const Real x1823 = x1738 - x1721 * x1745;
  w.x[125] = x1823;
  // joint 1 "left_hip": placement, velocity and reference acceleration of its link
  const Real x98 = q[7] * x97;
  const Real x99 = q[8] * x97;
  const Real x100 = q[9] * x97;
  const Real x101 = q[8] * x99;
  const Real x102 = q[9] * x100;
  const Real x112 = q[7] * x98;
  const Real x105 = q[8] * x98;
  const Real x106 = q[10] * x100;
  const Real x108 = q[9] * x98;
  const Real x109 = q[10] * x99;
  const Real x115 = q[9] * x99;
  const Real x116 = q[10] * x98;
  // joint 7 "spine": placement, velocity and reference acceleration of its link
  const Real x537 = q[25] * x536;
  const Real x538 = q[26] * x536;
  const Real x539 = q[27] * x536;
  const Real x540 = q[26] * x538;
  const Real x541 = q[27] * x539;
  const Real x551 = q[25] * x537;
  const Real x544 = q[26] * x537;
  const Real x545 = q[28] * x539;
  const Real x547 = q[27] * x537;
  const Real x548 = q[28] * x538;
  const Real x554 = q[27] * x538;
  const Real x555 = q[28] * x537;
  // joint 4 "right_hip": articulated-body inertia and bias force through it
  const Real x1514 = x810 + x1480;
  const Real x1247 = x1237 + x1169 * x1240;
  w.x[126] = x1247;
  const Real x1250 = x1238 + x1169 * x1242;
  w.x[127] = x1250;
  const Real x1253 = x1239 - x1169 * x1244;
  w.x[128] = x1253;
  const Real x1515 = x811 + x1485;
  // link 1 "pelvis": mobility from its articulated-body inertia
  const Real x1828 = x1599 + x1600 * x1739 + x1725 * x1744;
  w.x[129] = x1828;
  const Real x1831 = x1739 + x1725 * x1745;
  w.x[130] = x1831;
  const Real x1835 = x1626 + x1627 * x1745;
  w.x[131] = x1835;
  const Real x1843 = x1511 * x1757 + x1516 * x1741 + x1512 * x1766;
  const Real x1854 = x1511 * x1766 + x1516 * x1742 + x1512 * x1791;
  const Real x1865 = x1511 * x1774 + x1516 * x1743 + x1512 * x1799;
  const Real x1877 = x1511 * x1779 + x1516 * x1744 + x1512 * x1804;
  const Real x1890 = x1511 * x1782 - x1516 * x1745 + x1512 * x1807;
  const Real x1902 = x1511 * x1741 + x1516 * x1643 + x1512 * x1742;
  // joint 0 "root": placement, velocity and reference acceleration of its link
  const Real x59 = (q[5] * x25 - q[6] * x26) * 9.81 + x58;
  w.x[132] = x59;
  const Real x64 = (q[5] * x26 + q[6] * x25) * 9.81 + x63;
  w.x[133] = x64;
  const Real x54 = (1.0 - (q[4] * x26 + q[3] * x25)) * 9.81;
  const Real x69 = x54 + x68;
  w.x[134] = x69;
  // joint 1 "left_hip": placement, velocity and reference acceleration of its link
  const Real x104 = 1.0 - (x101 + x102);
  w.x[135] = x104;
  const Real x107 = x105 - x106;
  w.x[136] = x107;
  const Real x110 = x108 + x109;
  w.x[137] = x110;
  const Real x111 = x105 + x106;
  w.x[138] = x111;
  const Real x114 = 1.0 - (x102 + x112);
  w.x[139] = x114;
  const Real x117 = x115 - x116;
  w.x[140] = x117;
  const Real x118 = x108 - x109;
  w.x[141] = x118;
  const Real x119 = x115 + x116;
  w.x[142] = x119;
  const Real x121 = 1.0 - (x101 + x112);
  w.x[143] = x121;
  // joint 7 "spine": placement, velocity and reference acceleration of its link
  const Real x543 = 1.0 - (x540 + x541);
  w.x[144] = x543;
  const Real x546 = x544 - x545;
  w.x[145] = x546;
  const Real x549 = x547 + x548;
  w.x[146] = x549;
  const Real x550 = x544 + x545;
  w.x[147] = x550;
  const Real x553 = 1.0 - (x541 + x551);
  w.x[148] = x553;
  const Real x556 = x554 - x555;
  w.x[149] = x556;
  const Real x557 = x547 - x548;
  w.x[150] = x557;
  const Real x558 = x554 + x555;
  w.x[151] = x558;
  const Real x560 = 1.0 - (x540 + x551);
  w.x[152] = x560;
  // joint 4 "right_hip": articulated-body inertia and bias force through it
  const Real x1177 = 1.7763568394002505e-15 * x1143;
  require_more(w, x1164, x1177, kFactorization, 4);
  const Real x1178 = 1.7763568394002505e-15 * x1145;
  require_more(w, x1175, x1178, kFactorization, 4);
  const Real x1259 = x1234 + x1161 * x1240 + x1159 * x1247;
  w.x[153] = x1259;
  const Real x1265 = x1235 + x1161 * x1242 + x1159 * x1250;
  w.x[154] = x1265;
  const Real x1271 = x1236 - x1161 * x1244 + x1159 * x1253;
  w.x[155] = x1271;
  // link 1 "pelvis": mobility from its articulated-body inertia
  const Real x1644 = 1.7763568394002505e-15 * x1505;
  require_more(w, x1526, x1644, kFactorization, 0);
  const Real x1645 = 1.7763568394002505e-15 * x1507;
  require_more(w, x1549, x1645, kFactorization, 0);
  const Real x1646 = 1.7763568394002505e-15 * x1508;
  require_more(w, x1580, x1646, kFactorization, 0);
  const Real x1647 = 1.7763568394002505e-15 * x1509;
  require_more(w, x1613, x1647, kFactorization, 0);
  const Real x1648 = 1.7763568394002505e-15 * x1510;
  require_more(w, x1642, x1648, kFactorization, 0);
  const Real x1845 = x1513 * x1774 + x1843 + x1514 * x1779;
  const Real x1846 = x1515 * x1782 + x1845;
  w.x[156] = x1846;
  const Real x1856 = x1513 * x1799 + x1854 + x1514 * x1804;
  const Real x1857 = x1515 * x1807 + x1856;
  w.x[157] = x1857;
  const Real x1867 = x1513 * x1814 + x1865 + x1514 * x1820;
  const Real x1868 = x1515 * x1823 + x1867;
  w.x[158] = x1868;
  const Real x1879 = x1513 * x1820 + x1877 + x1514 * x1828;
  const Real x1880 = x1879 - x1515 * x1831;
  w.x[159] = x1880;
  const Real x1892 = x1513 * x1823 + x1890 - x1514 * x1831;
  const Real x1893 = x1515 * x1835 + x1892;
  w.x[160] = x1893;
  const Real x1904 = x1513 * x1743 + x1902 + x1514 * x1744;
  const Real x1905 = x1904 - x1515 * x1745;
  w.x[161] = x1905;
}

ADAGEN_NOINLINE void part_0_2(Workspace& w) {
  ADAGEN_INPUTS
  const Real x104 = w.x[135];
  const Real x107 = w.x[136];
  const Real x110 = w.x[137];
  const Real x111 = w.x[138];
  const Real x114 = w.x[139];
  const Real x117 = w.x[140];
  const Real x118 = w.x[141];
  const Real x119 = w.x[142];
  const Real x121 = w.x[143];
  const Real x1643 = w.x[102];
  const Real x1741 = w.x[109];
  const Real x1742 = w.x[110];
  const Real x1743 = w.x[111];
  const Real x1744 = w.x[112];
  const Real x1745 = w.x[113];
  const Real x1757 = w.x[114];
  const Real x1766 = w.x[115];
  const Real x1774 = w.x[116];
  const Real x1779 = w.x[117];
  const Real x1782 = w.x[118];
  const Real x1791 = w.x[119];
  const Real x1799 = w.x[120];
  const Real x1804 = w.x[121];
  const Real x1807 = w.x[122];
  const Real x1814 = w.x[123];
  const Real x1820 = w.x[124];
  const Real x1823 = w.x[125];
  const Real x1828 = w.x[129];
  const Real x1831 = w.x[130];
  const Real x1835 = w.x[131];
  const Real x1846 = w.x[156];
  const Real x1857 = w.x[157];
  const Real x1868 = w.x[158];
  const Real x1880 = w.x[159];
  const Real x1893 = w.x[160];
  const Real x1905 = w.x[161];
  // message received
  const Real x1927 = w.from[0][15];
  const Real x1928 = w.from[0][16];
  const Real x1930 = w.from[0][18];
  const Real x1929 = w.from[0][17];
  const Real x1931 = w.from[0][19];
  const Real x1915 = w.from[0][3];
  const Real x1920 = w.from[0][8];
  const Real x1916 = w.from[0][4];
  const Real x1921 = w.from[0][9];
  const Real x1924 = w.from[0][12];
  const Real x1932 = w.from[0][20];
  const Real x1917 = w.from[0][5];
  const Real x1922 = w.from[0][10];
  const Real x1925 = w.from[0][13];
  const Real x1926 = w.from[0][14];
  const Real x1936 = w.from[0][24];
  const Real x1937 = w.from[0][25];
  const Real x1938 = w.from[0][26];
  const Real x1912 = w.from[0][0];
  const Real x1913 = w.from[0][1];
  const Real x1914 = w.from[0][2];
  const Real x1918 = w.from[0][6];
  const Real x1919 = w.from[0][7];
  const Real x1923 = w.from[0][11];
  const Real x1933 = w.from[0][21];
  const Real x1934 = w.from[0][22];
  const Real x1935 = w.from[0][23];
  // joint 1 "left_hip": assembly: its two sides become one chain
  const Real x2010 = 0.04 * x1741 - x1745;
  const Real x2016 = x1643 + 0.09 * x1741;
  const Real x1942 = 0.09 * x1774;
  const Real x1944 = 0.04 * x1766;
  const Real x1949 = x1782 + 0.04 * x1757;
  const Real x1952 = x1741 + 0.09 * x1757;
  const Real x2005 = x1835 + 0.04 * x1782;
  const Real x2001 = x1744 - 0.09 * x1743 - 0.04 * x1742;
  const Real x1947 = x1779 - x1942 - x1944;
  const Real x1968 = x1820 - 0.09 * x1814 - 0.04 * x1799;
  const Real x1958 = x1804 - 0.09 * x1799 - 0.04 * x1791;
  const Real x1981 = x1828 - 0.09 * x1820 - 0.04 * x1804;
  const Real x1991 = x1831 + 0.09 * x1823 + 0.04 * x1807;
  const Real x1959 = x1807 + x1944;
  const Real x2006 = 0.04 * x1949 + x2005;
  const Real x2011 = 0.09 * x1949 + x2010;
  const Real x2017 = 0.09 * x1952 + x2016;
  const Real x1962 = x1742 + 0.09 * x1766;
  const Real x1971 = x1743 + x1942;
  const Real x1970 = x1823 + 0.04 * x1774;
  const Real x1993 = 0.04 * x1947 - x1991;
  const Real x2002 = 0.09 * x1947 + x2001;
  const Real x1983 = x1981 - 0.09 * x1968 - 0.04 * x1958;
  const Real x2192 = x111 * x2006 + x118 * x2011 + x104 * x1993;
  const Real x2197 = x111 * x2011 + x118 * x2017 + x104 * x2002;
  const Real x2024 = x111 * x1959;
  const Real x2207 = x114 * x2006 + x119 * x2011 + x107 * x1993;
  const Real x2212 = x114 * x2011 + x119 * x2017 + x107 * x2002;
  const Real x2187 = x111 * x1993 + x118 * x2002 + x104 * x1983;
  const Real x2202 = x114 * x1993 + x119 * x2002 + x107 * x1983;
  const Real x2039 = x114 * x1959;
  const Real x2018 = x104 * x1947;
  const Real x2030 = x118 * x1971;
  const Real x2033 = x107 * x1947;
  const Real x2045 = x119 * x1971;
  const Real x2054 = x117 * x1959;
  const Real x2232 = x111 * x2192 + x118 * x2197 + x104 * x2187;
  const Real x2273 = x1927 + x2232;
  require_more(w, x2273, 0.0, kFactorization, 1);
  const Real x2237 = x114 * x2192 + x119 * x2197 + x107 * x2187;
  const Real x2274 = x1928 + x2237;
  const Real x2027 = x104 * x1949 + x2024 + x118 * x1970;
  const Real x2395 = 1 / x2273;
  w.x[98] = x2395;
  const Real x2032 = x104 * x1952 + x111 * x1962 + x2030;
  const Real x2042 = x107 * x1949 + x2039 + x119 * x1970;
  const Real x2047 = x107 * x1952 + x114 * x1962 + x2045;
  const Real x2048 = x110 * x1947;
  const Real x2060 = x121 * x1971;
  const Real x2247 = x114 * x2207 + x119 * x2212 + x107 * x2202;
  const Real x2276 = x1930 + x2247;
  const Real x2022 = x2018 + x111 * x1958 + x118 * x1968;
  const Real x2037 = x2033 + x114 * x1958 + x119 * x1968;
  const Real x2057 = x110 * x1949 + x2054 + x121 * x1970;
  const Real x2062 = x110 * x1952 + x117 * x1962 + x2060;
  const Real x2396 = x2274 * x2395;
  w.x[97] = x2396;
  const Real x2052 = x2048 + x117 * x1958 + x121 * x1968;
  const Real x2400 = x2276 - x2274 * x2396;
  const Real x2222 = x117 * x2006 + x121 * x2011 + x110 * x1993;
  const Real x2227 = x117 * x2011 + x121 * x2017 + x110 * x2002;
  const Real x2242 = x117 * x2192 + x121 * x2197 + x110 * x2187;
  const Real x2275 = x1929 + x2242;
  const Real x2404 = 1 / x2400;
  w.x[108] = x2404;
  const Real x2287 = x1893 + 0.04 * x1846;
  const Real x2291 = x1905 + 0.09 * x1846;
  const Real x2217 = x117 * x1993 + x121 * x2002 + x110 * x1983;
  const Real x2252 = x117 * x2207 + x121 * x2212 + x110 * x2202;
  const Real x2067 = x111 * x2027 + x118 * x2032 + x104 * x2022;
  const Real x2261 = x1915 + x2067;
  w.x[107] = x2261;
  const Real x2082 = x111 * x2042 + x118 * x2047 + x104 * x2037;
  const Real x2266 = x1920 + x2082;
  w.x[106] = x2266;
  const Real x2284 = 0.09 * x1868 - x1880 + 0.04 * x1857;
  const Real x2461 = 0.04 * x1779 - x1831;
  const Real x2464 = x1744 + 0.09 * x1779;
  const Real x2497 = 0.09 * x1782 - x1745;
  const Real x2397 = x2275 * x2395;
  w.x[105] = x2397;
  const Real x2403 = x1931 + x2252 - x2275 * x2396;
  const Real x2072 = x114 * x2027 + x119 * x2032 + x107 * x2022;
  const Real x2262 = x1916 + x2072;
  w.x[96] = x2262;
  const Real x2087 = x114 * x2042 + x119 * x2047 + x107 * x2037;
  const Real x2267 = x1921 + x2087;
  w.x[95] = x2267;
  const Real x2097 = x111 * x2057 + x118 * x2062 + x104 * x2052;
  const Real x2270 = x1924 + x2097;
  w.x[94] = x2270;
  const Real x2257 = x117 * x2222 + x121 * x2227 + x110 * x2217;
  const Real x2278 = x1932 + x2257;
  const Real x2405 = x2403 * x2404;
  w.x[93] = x2405;
  const Real x2077 = x117 * x2027 + x121 * x2032 + x110 * x2022;
  const Real x2263 = x1917 + x2077;
  w.x[91] = x2263;
  const Real x2092 = x117 * x2042 + x121 * x2047 + x110 * x2037;
  const Real x2268 = x1922 + x2092;
  w.x[90] = x2268;
  const Real x2102 = x114 * x2057 + x119 * x2062 + x107 * x2052;
  const Real x2271 = x1925 + x2102;
  w.x[89] = x2271;
  const Real x2107 = x117 * x2057 + x121 * x2062 + x110 * x2052;
  const Real x2272 = x1926 + x2107;
  w.x[69] = x2272;
  const Real x2330 = x104 * x2284 - (x111 * x2287 + x118 * x2291);
  const Real x2427 = x111 * x1949 + x118 * x1952 + x2018;
  w.x[68] = x2427;
  const Real x2439 = x2024 + x118 * x1962 + x104 * x1958;
  w.x[104] = x2439;
  const Real x2451 = x2030 + x111 * x1970 + x104 * x1968;
  w.x[103] = x2451;
  const Real x2484 = x111 * x2461 + x118 * x2464 + x104 * x1981;
  w.x[101] = x2484;
  const Real x2518 = x111 * x2005 + x118 * x2497 - x104 * x1991;
  w.x[100] = x2518;
  const Real x2550 = x111 * x2010 + x118 * x2016 + x104 * x2001;
  w.x[86] = x2550;
  const Real x2411 = x2278 - x2275 * x2397 - x2403 * x2405;
  const Real x2112 = x104 * x1757 + x111 * x1766 + x118 * x1774;
  w.x[85] = x2112;
  const Real x2117 = x104 * x1766 + x111 * x1791 + x118 * x1799;
  w.x[88] = x2117;
  const Real x2127 = x107 * x1757 + x114 * x1766 + x119 * x1774;
  w.x[66] = x2127;
  const Real x2132 = x107 * x1766 + x114 * x1791 + x119 * x1799;
  w.x[99] = x2132;
  const Real x2338 = x107 * x2284 - (x114 * x2287 + x119 * x2291);
  const Real x2375 = tau[6] * x2261 + tau[7] * x2266 + tau[8] * x2270;
  const Real x2392 = x2330 - x1936 - x2375;
  w.x[92] = x2392;
  const Real x2412 = 1 / x2411;
  w.x[87] = x2412;
  const Real x2122 = x104 * x1774 + x111 * x1799 + x118 * x1814;
  w.x[84] = x2122;
  const Real x2137 = x107 * x1774 + x114 * x1799 + x119 * x1814;
  w.x[67] = x2137;
  const Real x2142 = x110 * x1757 + x117 * x1766 + x121 * x1774;
  w.x[65] = x2142;
  const Real x2147 = x110 * x1766 + x117 * x1791 + x121 * x1799;
  w.x[64] = x2147;
  const Real x2346 = x110 * x2284 - (x117 * x2287 + x121 * x2291);
  const Real x2380 = tau[6] * x2262 + tau[7] * x2267 + tau[8] * x2271;
  const Real x2431 = x114 * x1949 + x119 * x1952 + x2033;
  const Real x2563 = x2431 - x2396 * x2427;
  w.x[63] = x2563;
  const Real x2443 = x2039 + x119 * x1962 + x107 * x1958;
  const Real x2566 = x2443 - x2396 * x2439;
  w.x[61] = x2566;
  const Real x2455 = x2045 + x114 * x1970 + x107 * x1968;
  const Real x2569 = x2455 - x2396 * x2451;
  w.x[60] = x2569;
  const Real x2489 = x114 * x2461 + x119 * x2464 + x107 * x1981;
  const Real x2572 = x2489 - x2396 * x2484;
  w.x[59] = x2572;
  const Real x2524 = x114 * x2005 + x119 * x2497 - x107 * x1991;
  const Real x2575 = x2524 - x2396 * x2518;
  w.x[58] = x2575;
  const Real x2555 = x114 * x2010 + x119 * x2016 + x107 * x2001;
  const Real x2578 = x2555 - x2396 * x2550;
  w.x[62] = x2578;
  const Real x2152 = x110 * x1774 + x117 * x1799 + x121 * x1814;
  w.x[57] = x2152;
  const Real x2385 = tau[6] * x2263 + tau[7] * x2268 + tau[8] * x2272;
  const Real x2417 = x2338 - x1937 - x2380 - x2392 * x2396;
  w.x[56] = x2417;
  const Real x2435 = x117 * x1949 + x121 * x1952 + x2048;
  const Real x2447 = x2054 + x121 * x1962 + x110 * x1958;
  const Real x2459 = x2060 + x117 * x1970 + x110 * x1968;
  const Real x2494 = x117 * x2461 + x121 * x2464 + x110 * x1981;
  const Real x2530 = x117 * x2005 + x121 * x2497 - x110 * x1991;
  const Real x2560 = x117 * x2010 + x121 * x2016 + x110 * x2001;
  const Real x2469 = x104 * x1779 + x111 * x1804 + x118 * x1820;
  w.x[54] = x2469;
  const Real x2474 = x107 * x1779 + x114 * x1804 + x119 * x1820;
  w.x[53] = x2474;
  const Real x2502 = x104 * x1782 + x111 * x1807 + x118 * x1823;
  w.x[81] = x2502;
  const Real x2507 = x107 * x1782 + x114 * x1807 + x119 * x1823;
  w.x[78] = x2507;
  const Real x2535 = x104 * x1741 + x111 * x1742 + x118 * x1743;
  w.x[82] = x2535;
  const Real x2540 = x107 * x1741 + x114 * x1742 + x119 * x1743;
  w.x[79] = x2540;
  const Real x2584 = x2435 - x2397 * x2427 - x2405 * x2563;
  w.x[83] = x2584;
  const Real x2590 = x2447 - x2397 * x2439 - x2405 * x2566;
  w.x[80] = x2590;
  const Real x2596 = x2459 - x2397 * x2451 - x2405 * x2569;
  w.x[77] = x2596;
  const Real x2602 = x2494 - x2397 * x2484 - x2405 * x2572;
  w.x[76] = x2602;
  const Real x2608 = x2530 - x2397 * x2518 - x2405 * x2575;
  w.x[75] = x2608;
  const Real x2614 = x2560 - x2397 * x2550 - x2405 * x2578;
  w.x[74] = x2614;
  const Real x2615 = x2395 * x2427;
  const Real x2616 = x2395 * x2439;
  const Real x2617 = x2395 * x2451;
  const Real x2618 = x2395 * x2484;
  const Real x2619 = x2395 * x2518;
  const Real x2620 = x2395 * x2550;
  const Real x2621 = x2404 * x2563;
  const Real x2622 = x2404 * x2566;
  const Real x2623 = x2404 * x2569;
  const Real x2624 = x2404 * x2572;
  const Real x2625 = x2404 * x2575;
  const Real x2626 = x2404 * x2578;
  const Real x2157 = x104 * x2112 + x111 * x2117 + x118 * x2122;
  const Real x2162 = x107 * x2112 + x114 * x2117 + x119 * x2122;
  const Real x2259 = x1913 + x2162;
  const Real x2167 = x110 * x2112 + x117 * x2117 + x121 * x2122;
  const Real x2260 = x1914 + x2167;
  const Real x2172 = x107 * x2127 + x114 * x2132 + x119 * x2137;
  const Real x2177 = x110 * x2127 + x117 * x2132 + x121 * x2137;
  const Real x2265 = x1919 + x2177;
  const Real x2422 = x2346 - x1938 - x2385 - x2392 * x2397;
  const Real x2423 = x2422 - x2405 * x2417;
  w.x[73] = x2423;
  const Real x2479 = x110 * x1779 + x117 * x1804 + x121 * x1820;
  w.x[45] = x2479;
  const Real x2512 = x110 * x1782 + x117 * x1807 + x121 * x1823;
  w.x[44] = x2512;
  const Real x2545 = x110 * x1741 + x117 * x1742 + x121 * x1743;
  w.x[43] = x2545;
  const Real x2627 = x2412 * x2584;
  const Real x2628 = x2412 * x2590;
  const Real x2629 = x2412 * x2596;
  const Real x2630 = x2412 * x2602;
  const Real x2631 = x2412 * x2608;
  const Real x2632 = x2412 * x2614;
  const Real x2182 = x110 * x2142 + x117 * x2147 + x121 * x2152;
  const Real x2301 = x104 * x1846 + x111 * x1857 + x118 * x1868;
  const Real x2311 = x107 * x1846 + x114 * x1857 + x119 * x1868;
  const Real x2321 = x110 * x1846 + x117 * x1857 + x121 * x1868;
  const Real x2359 = tau[6] * (x1912 + x2157) + tau[7] * x2259;
  const Real x2364 = tau[6] * x2259 + tau[7] * (x1918 + x2172);
  const Real x2369 = tau[6] * x2260 + tau[7] * x2265;
  const Real x2832 = tau[6] * x2112 + tau[7] * x2127 + tau[8] * x2142;
  const Real x2862 = x2392 * x2615 + x2417 * x2621 + x2423 * x2627;
  const Real x2837 = tau[6] * x2117 + tau[7] * x2132 + tau[8] * x2147;
  const Real x2867 = x2392 * x2616 + x2417 * x2622 + x2423 * x2628;
  const Real x2842 = tau[6] * x2122 + tau[7] * x2137 + tau[8] * x2152;
  const Real x2872 = x2392 * x2617 + x2417 * x2623 + x2423 * x2629;
  const Real x2847 = tau[6] * x2469 + tau[7] * x2474 + tau[8] * x2479;
  const Real x2877 = x2392 * x2618 + x2417 * x2624 + x2423 * x2630;
  const Real x2852 = tau[6] * x2502 + tau[7] * x2507 + tau[8] * x2512;
  const Real x2882 = x2392 * x2619 + x2417 * x2625 + x2423 * x2631;
  const Real x2857 = tau[6] * x2535 + tau[7] * x2540 + tau[8] * x2545;
  const Real x2887 = x2392 * x2620 + x2417 * x2626 + x2423 * x2632;
  const Real x2386 = x1933 + x2301 + (tau[8] * x2260 + x2359);
  w.x[40] = x2386;
  const Real x2388 = x1934 + x2311 + (tau[8] * x2265 + x2364);
  w.x[39] = x2388;
  const Real x2390 = x1935 + x2321 + (tau[8] * (x1923 + x2182) + x2369);
  w.x[38] = x2390;
  const Real x2413 = 1.7763568394002505e-15 * x2276;
  require_more(w, x2400, x2413, kFactorization, 1);
  const Real x2414 = 1.7763568394002505e-15 * x2278;
  require_more(w, x2411, x2414, kFactorization, 1);
  const Real x2640 = x1757 - x2427 * x2615 - x2563 * x2621;
  const Real x2641 = x2640 - x2584 * x2627;
  w.x[46] = x2641;
  const Real x2649 = x1766 - x2427 * x2616 - x2563 * x2622;
  const Real x2650 = x2649 - x2584 * x2628;
  w.x[42] = x2650;
  const Real x2658 = x1774 - x2427 * x2617 - x2563 * x2623;
  const Real x2659 = x2658 - x2584 * x2629;
  w.x[41] = x2659;
  const Real x2667 = x1779 - x2427 * x2618 - x2563 * x2624;
  const Real x2668 = x2667 - x2584 * x2630;
  w.x[37] = x2668;
  const Real x2676 = x1782 - x2427 * x2619 - x2563 * x2625;
  const Real x2677 = x2676 - x2584 * x2631;
  w.x[36] = x2677;
  const Real x2685 = x1741 - x2427 * x2620 - x2563 * x2626;
  const Real x2686 = x2685 - x2584 * x2632;
  w.x[34] = x2686;
  const Real x2694 = x1791 - x2439 * x2616 - x2566 * x2622;
  const Real x2695 = x2694 - x2590 * x2628;
  w.x[35] = x2695;
  const Real x2703 = x1799 - x2439 * x2617 - x2566 * x2623;
  const Real x2704 = x2703 - x2590 * x2629;
  w.x[9] = x2704;
  const Real x2712 = x1804 - x2439 * x2618 - x2566 * x2624;
  const Real x2713 = x2712 - x2590 * x2630;
  w.x[8] = x2713;
  const Real x2721 = x1807 - x2439 * x2619 - x2566 * x2625;
  const Real x2722 = x2721 - x2590 * x2631;
  w.x[6] = x2722;
  const Real x2730 = x1742 - x2439 * x2620 - x2566 * x2626;
  const Real x2731 = x2730 - x2590 * x2632;
  w.x[7] = x2731;
  const Real x2739 = x1814 - x2451 * x2617 - x2569 * x2623;
  const Real x2740 = x2739 - x2596 * x2629;
  w.x[11] = x2740;
  const Real x2748 = x1820 - x2451 * x2618 - x2569 * x2624;
  const Real x2749 = x2748 - x2596 * x2630;
  w.x[10] = x2749;
  const Real x2757 = x1823 - x2451 * x2619 - x2569 * x2625;
  const Real x2758 = x2757 - x2596 * x2631;
  w.x[5] = x2758;
  const Real x2766 = x1743 - x2451 * x2620 - x2569 * x2626;
  const Real x2767 = x2766 - x2596 * x2632;
  w.x[4] = x2767;
  const Real x2775 = x1828 - x2484 * x2618 - x2572 * x2624;
  const Real x2776 = x2775 - x2602 * x2630;
  w.x[2] = x2776;
  const Real x2785 = x1831 + x2484 * x2619 + x2572 * x2625;
  const Real x2787 = x2602 * x2631 + x2785;
  w.x[1] = x2787;
  const Real x2796 = x1744 - x2484 * x2620 - x2572 * x2626;
  const Real x2797 = x2796 - x2602 * x2632;
  w.x[0] = x2797;
  const Real x2805 = x1835 - x2518 * x2619 - x2575 * x2625;
  const Real x2806 = x2805 - x2608 * x2631;
  w.x[3] = x2806;
  const Real x2815 = x1745 + x2518 * x2620 + x2575 * x2626;
  const Real x2817 = x2608 * x2632 + x2815;
  w.x[162] = x2817;
  const Real x2826 = x1643 - x2550 * x2620 - x2578 * x2626;
  const Real x2827 = x2826 - x2614 * x2632;
  w.x[163] = x2827;
  const Real x2894 = x2832 + x2862 + x1846;
  w.x[164] = x2894;
  const Real x2896 = x2837 + x2867 + x1857;
  w.x[165] = x2896;
  const Real x2898 = x2842 + x2872 + x1868;
  w.x[166] = x2898;
  const Real x2900 = x2847 + x2877 + x1880;
  w.x[167] = x2900;
  const Real x2902 = x2852 + x2882 + x1893;
  w.x[168] = x2902;
  const Real x2904 = x2857 + x2887 + x1905;
  w.x[169] = x2904;
}

ADAGEN_NOINLINE void part_0_3(Workspace& w) {
  ADAGEN_INPUTS
  const Real x543 = w.x[144];
  const Real x546 = w.x[145];
  const Real x549 = w.x[146];
  const Real x550 = w.x[147];
  const Real x553 = w.x[148];
  const Real x556 = w.x[149];
  const Real x557 = w.x[150];
  const Real x558 = w.x[151];
  const Real x560 = w.x[152];
  const Real x2641 = w.x[46];
  const Real x2650 = w.x[42];
  const Real x2659 = w.x[41];
  const Real x2668 = w.x[37];
  const Real x2677 = w.x[36];
  const Real x2686 = w.x[34];
  const Real x2695 = w.x[35];
  const Real x2704 = w.x[9];
  const Real x2713 = w.x[8];
  const Real x2722 = w.x[6];
  const Real x2731 = w.x[7];
  const Real x2749 = w.x[10];
  const Real x2758 = w.x[5];
  const Real x2767 = w.x[4];
  const Real x2776 = w.x[2];
  const Real x2787 = w.x[1];
  const Real x2797 = w.x[0];
  const Real x2806 = w.x[3];
  const Real x2817 = w.x[162];
  const Real x2827 = w.x[163];
  const Real x2894 = w.x[164];
  const Real x2896 = w.x[165];
  const Real x2900 = w.x[167];
  const Real x2902 = w.x[168];
  const Real x2904 = w.x[169];
  // message received
  const Real x2921 = w.from[2][15];
  const Real x2922 = w.from[2][16];
  const Real x2924 = w.from[2][18];
  const Real x2923 = w.from[2][17];
  const Real x2909 = w.from[2][3];
  const Real x2914 = w.from[2][8];
  const Real x2925 = w.from[2][19];
  const Real x2910 = w.from[2][4];
  const Real x2915 = w.from[2][9];
  const Real x2918 = w.from[2][12];
  const Real x2911 = w.from[2][5];
  const Real x2916 = w.from[2][10];
  const Real x2919 = w.from[2][13];
  const Real x2926 = w.from[2][20];
  const Real x2920 = w.from[2][14];
  const Real x2930 = w.from[2][24];
  const Real x2931 = w.from[2][25];
  const Real x2932 = w.from[2][26];
  const Real x2906 = w.from[2][0];
  w.x[170] = x2906;
  const Real x2907 = w.from[2][1];
  w.x[171] = x2907;
  const Real x2908 = w.from[2][2];
  w.x[172] = x2908;
  const Real x2912 = w.from[2][6];
  w.x[173] = x2912;
  const Real x2913 = w.from[2][7];
  w.x[174] = x2913;
  const Real x2917 = w.from[2][11];
  w.x[175] = x2917;
  const Real x2927 = w.from[2][21];
  w.x[176] = x2927;
  const Real x2928 = w.from[2][22];
  w.x[177] = x2928;
  const Real x2929 = w.from[2][23];
  w.x[178] = x2929;
  // joint 7 "spine": assembly: its two sides become one chain
  const Real x2937 = 0.13 * x2650;
  const Real x2945 = x2713 + 0.13 * x2695;
  const Real x2939 = x2668 + x2937;
  const Real x2942 = x2677 - 0.13 * x2641;
  const Real x2967 = x2797 + 0.13 * x2731;
  const Real x2976 = x2817 + 0.13 * x2686;
  const Real x2946 = x2722 - x2937;
  const Real x2949 = x2749 + 0.13 * x2704;
  const Real x2958 = x2776 + 0.13 * x2713 + 0.13 * x2945;
  const Real x2964 = 0.13 * x2722 - x2787 - 0.13 * x2939;
  const Real x2973 = x2806 - 0.13 * x2677 - 0.13 * x2942;
  const Real x3159 = x543 * x2967 + x557 * x2827 - x550 * x2976;
  const Real x3176 = x546 * x2967 + x558 * x2827 - x553 * x2976;
  const Real x2952 = x2758 - 0.13 * x2659;
  const Real x3147 = x543 * x2958 + x557 * x2967 + x550 * x2964;
  const Real x3153 = x543 * x2964 - x557 * x2976 + x550 * x2973;
  const Real x3164 = x546 * x2958 + x558 * x2967 + x553 * x2964;
  const Real x3170 = x546 * x2964 - x558 * x2976 + x553 * x2973;
  const Real x2982 = x543 * x2939 + x550 * x2945 + x557 * x2949;
  const Real x2992 = x543 * x2686 + x550 * x2731 + x557 * x2767;
  const Real x2997 = x546 * x2939 + x553 * x2945 + x558 * x2949;
  const Real x3007 = x546 * x2686 + x553 * x2731 + x558 * x2767;
  const Real x3198 = x543 * x3147 + x557 * x3159 + x550 * x3153;
  const Real x3239 = x2921 + x3198;
  require_more(w, x3239, 0.0, kFactorization, 7);
  const Real x3203 = x546 * x3147 + x558 * x3159 + x553 * x3153;
  const Real x3240 = x2922 + x3203;
  const Real x2987 = x543 * x2942 + x550 * x2946 + x557 * x2952;
  const Real x3002 = x546 * x2942 + x553 * x2946 + x558 * x2952;
  const Real x3012 = x549 * x2939 + x556 * x2945 + x560 * x2949;
  const Real x3354 = 1 / x3239;
  const Real x3022 = x549 * x2686 + x556 * x2731 + x560 * x2767;
  const Real x3213 = x546 * x3164 + x558 * x3176 + x553 * x3170;
  const Real x3242 = x2924 + x3213;
  w.x[179] = x3242;
  const Real x3017 = x549 * x2942 + x556 * x2946 + x560 * x2952;
  const Real x3355 = x3240 * x3354;
  const Real x3247 = x2900 + 0.13 * x2896;
  const Real x3359 = x3242 - x3240 * x3355;
  w.x[180] = x3359;
  const Real x3181 = x549 * x2958 + x560 * x2967 + x556 * x2964;
  const Real x3193 = x549 * x2967 + x560 * x2827 - x556 * x2976;
  const Real x3208 = x549 * x3147 + x560 * x3159 + x556 * x3153;
  const Real x3241 = x2923 + x3208;
  const Real x3363 = 1 / x3359;
  const Real x3027 = x543 * x2982 + x557 * x2992 + x550 * x2987;
  const Real x3227 = x2909 + x3027;
  w.x[181] = x3227;
  const Real x3042 = x543 * x2997 + x557 * x3007 + x550 * x3002;
  const Real x3232 = x2914 + x3042;
  w.x[182] = x3232;
  const Real x3251 = 0.13 * x2894 - x2902;
  const Real x3187 = x549 * x2964 - x560 * x2976 + x556 * x2973;
  const Real x3218 = x549 * x3164 + x560 * x3176 + x556 * x3170;
  const Real x3032 = x546 * x2982 + x558 * x2992 + x553 * x2987;
  const Real x3228 = x2910 + x3032;
  w.x[183] = x3228;
  const Real x3047 = x546 * x2997 + x558 * x3007 + x553 * x3002;
  const Real x3233 = x2915 + x3047;
  w.x[184] = x3233;
  const Real x3057 = x543 * x3012 + x557 * x3022 + x550 * x3017;
  const Real x3236 = x2918 + x3057;
  w.x[185] = x3236;
  const Real x3356 = x3241 * x3354;
  const Real x3362 = x2925 + x3218 - x3241 * x3355;
  const Real x3037 = x549 * x2982 + x560 * x2992 + x556 * x2987;
  const Real x3229 = x2911 + x3037;
  w.x[186] = x3229;
  const Real x3052 = x549 * x2997 + x560 * x3007 + x556 * x3002;
  const Real x3234 = x2916 + x3052;
  w.x[187] = x3234;
  const Real x3062 = x546 * x3012 + x558 * x3022 + x553 * x3017;
  const Real x3237 = x2919 + x3062;
  w.x[188] = x3237;
  const Real x3223 = x549 * x3181 + x560 * x3193 + x556 * x3187;
  const Real x3244 = x2926 + x3223;
  w.x[189] = x3244;
  const Real x3364 = x3362 * x3363;
  const Real x3067 = x549 * x3012 + x560 * x3022 + x556 * x3017;
  const Real x3238 = x2920 + x3067;
  w.x[190] = x3238;
  const Real x3289 = x550 * x3251 - (x543 * x3247 + x557 * x2904);
  const Real x3297 = x553 * x3251 - (x546 * x3247 + x558 * x2904);
  const Real x3334 = tau[20] * x3227 + tau[21] * x3232 + tau[22] * x3236;
  const Real x3351 = x3289 - x2930 - x3334;
  const Real x3370 = x3244 - x3241 * x3356 - x3362 * x3364;
  w.x[191] = x3370;
  const Real x3305 = x556 * x3251 - (x549 * x3247 + x560 * x2904);
  const Real x3339 = tau[20] * x3228 + tau[21] * x3233 + tau[22] * x3237;
  const Real x3376 = x3297 - x2931 - x3339 - x3351 * x3355;
  const Real x3344 = tau[20] * x3229 + tau[21] * x3234 + tau[22] * x3238;
  const Real x3381 = x3305 - x2932 - x3344 - x3351 * x3356;
  // joint 7 "spine": disassembly: its acceleration and force
  const Real x3385 = 1 / x3370 * (x3381 - x3364 * x3376);
  w.x[192] = x3385;
  w.to[3][5] = x3385;
  const Real x3388 = x3363 * x3376 - x3364 * x3385;
  w.x[193] = x3388;
  w.to[3][4] = x3388;
  const Real x3394 = x3351 * x3354 - x3356 * x3385 - x3355 * x3388;
  w.x[194] = x3394;
  w.to[3][3] = x3394;
}

ADAGEN_NOINLINE void part_0_4(Workspace& w) {
  ADAGEN_INPUTS
  const Real x543 = w.x[144];
  const Real x546 = w.x[145];
  const Real x549 = w.x[146];
  const Real x550 = w.x[147];
  const Real x553 = w.x[148];
  const Real x556 = w.x[149];
  const Real x557 = w.x[150];
  const Real x558 = w.x[151];
  const Real x560 = w.x[152];
  const Real x2392 = w.x[92];
  const Real x2395 = w.x[98];
  const Real x2396 = w.x[97];
  const Real x2397 = w.x[105];
  const Real x2404 = w.x[108];
  const Real x2405 = w.x[93];
  const Real x2412 = w.x[87];
  const Real x2417 = w.x[56];
  const Real x2423 = w.x[73];
  const Real x2427 = w.x[68];
  const Real x2439 = w.x[104];
  const Real x2451 = w.x[103];
  const Real x2484 = w.x[101];
  const Real x2518 = w.x[100];
  const Real x2550 = w.x[86];
  const Real x2563 = w.x[63];
  const Real x2566 = w.x[61];
  const Real x2569 = w.x[60];
  const Real x2572 = w.x[59];
  const Real x2575 = w.x[58];
  const Real x2578 = w.x[62];
  const Real x2584 = w.x[83];
  const Real x2590 = w.x[80];
  const Real x2596 = w.x[77];
  const Real x2602 = w.x[76];
  const Real x2608 = w.x[75];
  const Real x2614 = w.x[74];
  const Real x3385 = w.x[192];
  const Real x3388 = w.x[193];
  const Real x3394 = w.x[194];
  // joint 7 "spine": disassembly: its acceleration and force
  const Real x3427 = x557 * tau[20] + x558 * tau[21] + x560 * tau[22];
  w.x[169] = x3427;
  const Real x3432 = x546 * x3388 + x549 * x3385 + x543 * x3394;
  w.x[168] = x3432;
  const Real x3437 = x553 * x3388 + x556 * x3385 + x550 * x3394;
  w.x[167] = x3437;
  const Real x3442 = x558 * x3388 + x560 * x3385 + x557 * x3394;
  w.x[163] = x3442;
  const Real x3417 = x546 * tau[21] + x549 * tau[22] + x543 * tau[20];
  const Real x3445 = x3417 - 0.13 * x3437;
  w.x[162] = x3445;
  const Real x3422 = x550 * tau[20] + x556 * tau[22] + x553 * tau[21];
  const Real x3447 = x3422 + 0.13 * x3432;
  w.x[3] = x3447;
  // joint 1 "left_hip": disassembly: its acceleration and force
  const Real x3512 = x2596 * x3427 + x2602 * x3432 + x2608 * x3437;
  const Real x3490 = x2569 * x3427 + x2572 * x3432 + x2575 * x3437;
  const Real x3468 = x2451 * x3427 + x2484 * x3432 + x2518 * x3437;
  const Real x3516 = x2614 * x3442 + x3512 + x2584 * x3445;
  const Real x3494 = x2578 * x3442 + x3490 + x2563 * x3445;
  const Real x3472 = x2550 * x3442 + x3468 + x2427 * x3445;
  const Real x3594 = x2412 * (x2423 - (x2590 * x3447 + x3516));
  w.x[0] = x3594;
  w.to[4][5] = x3594;
  const Real x3593 = x2404 * (x2417 - (x2566 * x3447 + x3494));
  const Real x3597 = x3593 - x2405 * x3594;
  w.x[1] = x3597;
  w.to[4][4] = x3597;
  const Real x3592 = x2395 * (x2392 - (x2439 * x3447 + x3472));
  const Real x3603 = x3592 - x2397 * x3594 - x2396 * x3597;
  w.x[2] = x3603;
  w.to[4][3] = x3603;
}

ADAGEN_NOINLINE void part_0_5(Workspace& w) {
  ADAGEN_INPUTS
  const Real x59 = w.x[132];
  const Real x64 = w.x[133];
  const Real x69 = w.x[134];
  const Real x104 = w.x[135];
  const Real x107 = w.x[136];
  const Real x110 = w.x[137];
  const Real x111 = w.x[138];
  const Real x114 = w.x[139];
  const Real x117 = w.x[140];
  const Real x118 = w.x[141];
  const Real x119 = w.x[142];
  const Real x121 = w.x[143];
  const Real x230 = w.x[18];
  const Real x233 = w.x[12];
  const Real x236 = w.x[13];
  const Real x237 = w.x[14];
  const Real x240 = w.x[19];
  const Real x243 = w.x[15];
  const Real x244 = w.x[16];
  const Real x245 = w.x[17];
  const Real x247 = w.x[29];
  const Real x410 = w.x[26];
  const Real x413 = w.x[22];
  const Real x416 = w.x[20];
  const Real x417 = w.x[23];
  const Real x420 = w.x[27];
  const Real x423 = w.x[24];
  const Real x424 = w.x[21];
  const Real x425 = w.x[25];
  const Real x427 = w.x[28];
  const Real x543 = w.x[144];
  const Real x546 = w.x[145];
  const Real x549 = w.x[146];
  const Real x550 = w.x[147];
  const Real x553 = w.x[148];
  const Real x556 = w.x[149];
  const Real x557 = w.x[150];
  const Real x558 = w.x[151];
  const Real x560 = w.x[152];
  const Real x837 = w.x[51];
  const Real x838 = w.x[50];
  const Real x841 = w.x[52];
  const Real x1001 = w.x[55];
  const Real x1002 = w.x[30];
  const Real x1004 = w.x[32];
  const Real x1006 = w.x[33];
  const Real x1007 = w.x[31];
  const Real x1193 = w.x[70];
  const Real x1196 = w.x[71];
  const Real x1202 = w.x[72];
  const Real x1240 = w.x[47];
  const Real x1242 = w.x[48];
  const Real x1244 = w.x[49];
  const Real x1247 = w.x[126];
  const Real x1250 = w.x[127];
  const Real x1253 = w.x[128];
  const Real x1259 = w.x[153];
  const Real x1265 = w.x[154];
  const Real x1271 = w.x[155];
  const Real x1643 = w.x[102];
  const Real x1741 = w.x[109];
  const Real x1742 = w.x[110];
  const Real x1743 = w.x[111];
  const Real x1744 = w.x[112];
  const Real x1745 = w.x[113];
  const Real x1757 = w.x[114];
  const Real x1766 = w.x[115];
  const Real x1774 = w.x[116];
  const Real x1779 = w.x[117];
  const Real x1782 = w.x[118];
  const Real x1791 = w.x[119];
  const Real x1799 = w.x[120];
  const Real x1804 = w.x[121];
  const Real x1807 = w.x[122];
  const Real x1814 = w.x[123];
  const Real x1820 = w.x[124];
  const Real x1823 = w.x[125];
  const Real x1828 = w.x[129];
  const Real x1831 = w.x[130];
  const Real x1835 = w.x[131];
  const Real x1846 = w.x[156];
  const Real x1857 = w.x[157];
  const Real x1868 = w.x[158];
  const Real x1880 = w.x[159];
  const Real x1893 = w.x[160];
  const Real x1905 = w.x[161];
  const Real x2112 = w.x[85];
  const Real x2117 = w.x[88];
  const Real x2122 = w.x[84];
  const Real x2127 = w.x[66];
  const Real x2132 = w.x[99];
  const Real x2137 = w.x[67];
  const Real x2142 = w.x[65];
  const Real x2147 = w.x[64];
  const Real x2152 = w.x[57];
  const Real x2261 = w.x[107];
  const Real x2262 = w.x[96];
  const Real x2263 = w.x[91];
  const Real x2266 = w.x[106];
  const Real x2267 = w.x[95];
  const Real x2268 = w.x[90];
  const Real x2270 = w.x[94];
  const Real x2271 = w.x[89];
  const Real x2272 = w.x[69];
  const Real x2386 = w.x[40];
  const Real x2388 = w.x[39];
  const Real x2390 = w.x[38];
  const Real x2469 = w.x[54];
  const Real x2474 = w.x[53];
  const Real x2479 = w.x[45];
  const Real x2502 = w.x[81];
  const Real x2507 = w.x[78];
  const Real x2512 = w.x[44];
  const Real x2535 = w.x[82];
  const Real x2540 = w.x[79];
  const Real x2545 = w.x[43];
  const Real x2641 = w.x[46];
  const Real x2650 = w.x[42];
  const Real x2659 = w.x[41];
  const Real x2695 = w.x[35];
  const Real x2704 = w.x[9];
  const Real x2740 = w.x[11];
  const Real x2894 = w.x[164];
  const Real x2896 = w.x[165];
  const Real x2898 = w.x[166];
  const Real x2906 = w.x[170];
  const Real x2907 = w.x[171];
  const Real x2908 = w.x[172];
  const Real x2912 = w.x[173];
  const Real x2913 = w.x[174];
  const Real x2917 = w.x[175];
  const Real x2927 = w.x[176];
  const Real x2928 = w.x[177];
  const Real x2929 = w.x[178];
  const Real x3227 = w.x[181];
  const Real x3228 = w.x[183];
  const Real x3229 = w.x[186];
  const Real x3232 = w.x[182];
  const Real x3233 = w.x[184];
  const Real x3234 = w.x[187];
  const Real x3236 = w.x[185];
  const Real x3237 = w.x[188];
  const Real x3238 = w.x[190];
  const Real x3242 = w.x[179];
  const Real x3244 = w.x[189];
  const Real x3359 = w.x[180];
  const Real x3370 = w.x[191];
  const Real x3385 = w.x[192];
  const Real x3388 = w.x[193];
  const Real x3394 = w.x[194];
  const Real x3427 = w.x[169];
  const Real x3432 = w.x[168];
  const Real x3437 = w.x[167];
  const Real x3442 = w.x[163];
  const Real x3445 = w.x[162];
  const Real x3447 = w.x[3];
  const Real x3594 = w.x[0];
  const Real x3597 = w.x[1];
  const Real x3603 = w.x[2];
  // joint 7 "spine": assembly: its two sides become one chain
  const Real x3072 = x543 * x2641 + x550 * x2650 + x557 * x2659;
  const Real x3077 = x543 * x2650 + x550 * x2695 + x557 * x2704;
  const Real x3087 = x546 * x2641 + x553 * x2650 + x558 * x2659;
  const Real x3092 = x546 * x2650 + x553 * x2695 + x558 * x2704;
  const Real x3082 = x543 * x2659 + x550 * x2704 + x557 * x2740;
  const Real x3097 = x546 * x2659 + x553 * x2704 + x558 * x2740;
  const Real x3102 = x549 * x2641 + x556 * x2650 + x560 * x2659;
  const Real x3107 = x549 * x2650 + x556 * x2695 + x560 * x2704;
  const Real x3112 = x549 * x2659 + x556 * x2704 + x560 * x2740;
  const Real x3117 = x543 * x3072 + x550 * x3077 + x557 * x3082;
  const Real x3122 = x546 * x3072 + x553 * x3077 + x558 * x3082;
  const Real x3225 = x2907 + x3122;
  const Real x3127 = x549 * x3072 + x556 * x3077 + x560 * x3082;
  const Real x3226 = x2908 + x3127;
  const Real x3132 = x546 * x3087 + x553 * x3092 + x558 * x3097;
  const Real x3137 = x549 * x3087 + x556 * x3092 + x560 * x3097;
  const Real x3231 = x2913 + x3137;
  const Real x3142 = x549 * x3102 + x556 * x3107 + x560 * x3112;
  const Real x3260 = x543 * x2894 + x550 * x2896 + x557 * x2898;
  const Real x3270 = x546 * x2894 + x553 * x2896 + x558 * x2898;
  const Real x3372 = 1.7763568394002505e-15 * x3242;
  require_more(w, x3359, x3372, kFactorization, 7);
  const Real x3373 = 1.7763568394002505e-15 * x3244;
  require_more(w, x3370, x3373, kFactorization, 7);
  const Real x3280 = x549 * x2894 + x556 * x2896 + x560 * x2898;
  const Real x3318 = tau[20] * (x2906 + x3117) + tau[21] * x3225;
  const Real x3323 = tau[20] * x3225 + tau[21] * (x2912 + x3132);
  const Real x3328 = tau[20] * x3226 + tau[21] * x3231;
  // joint 7 "spine": disassembly: its acceleration and force
  const Real x3399 = x3228 * x3388 + x3229 * x3385 + x3227 * x3394;
  const Real x3410 = x2927 + x3260 + (tau[22] * x3226 + x3318) + x3399;
  w.result[20] = x3410;
  const Real x3404 = x3233 * x3388 + x3234 * x3385 + x3232 * x3394;
  const Real x3411 = x2928 + x3270 + (tau[22] * x3231 + x3323) + x3404;
  w.result[21] = x3411;
  // joint 7 "spine": assembly: its two sides become one chain
  const Real x3349 = x2929 + x3280 + (tau[22] * (x2917 + x3142) + x3328);
  // joint 7 "spine": disassembly: its acceleration and force
  const Real x3409 = x3237 * x3388 + x3238 * x3385 + x3236 * x3394;
  const Real x3412 = x3349 + x3409;
  w.result[22] = x3412;
  // joint 1 "left_hip": disassembly: its acceleration and force
  const Real x3537 = x2122 * x3427 + x2469 * x3432 + x2502 * x3437;
  const Real x3559 = x2137 * x3427 + x2474 * x3432 + x2507 * x3437;
  const Real x3581 = x2152 * x3427 + x2479 * x3432 + x2512 * x3437;
  const Real x3541 = x2535 * x3442 + x3537 + x2112 * x3445;
  const Real x3563 = x2540 * x3442 + x3559 + x2127 * x3445;
  const Real x3585 = x2545 * x3442 + x3581 + x2142 * x3445;
  const Real x3641 = x107 * x3597 + x110 * x3594 + x104 * x3603;
  const Real x3646 = x114 * x3597 + x117 * x3594 + x111 * x3603;
  const Real x3651 = x119 * x3597 + x121 * x3594 + x118 * x3603;
  const Real x3675 = x3432 + x3641;
  const Real x3677 = x3437 + x3646;
  const Real x3679 = x3442 + x3651;
  const Real x3608 = x2262 * x3597 + x2263 * x3594 + x2261 * x3603;
  const Real x3619 = x2117 * x3447 + x3541 + x2386 + x3608;
  w.result[6] = x3619;
  const Real x3613 = x2267 * x3597 + x2268 * x3594 + x2266 * x3603;
  const Real x3620 = x2132 * x3447 + x3563 + x2388 + x3613;
  w.result[7] = x3620;
  const Real x3618 = x2271 * x3597 + x2272 * x3594 + x2270 * x3603;
  const Real x3621 = x2147 * x3447 + x3585 + x2390 + x3618;
  w.result[8] = x3621;
  const Real x3631 = x111 * tau[6] + x117 * tau[8] + x114 * tau[7];
  const Real x3626 = x107 * tau[7] + x110 * tau[8] + x104 * tau[6];
  const Real x3636 = x118 * tau[6] + x119 * tau[7] + x121 * tau[8];
  const Real x3671 = x3631 - 0.04 * x3641 + x3447;
  const Real x3673 = x3636 - 0.09 * x3641 + x3427;
  const Real x3669 = x3626 + 0.09 * x3651 + 0.04 * x3646 + x3445;
  // link 1 "pelvis": acceleration under the handle forces
  const Real x3695 = x1779 * x3675 + x1782 * x3677 + x1741 * x3679;
  const Real x3739 = x1820 * x3675 + x1823 * x3677 + x1743 * x3679;
  const Real x3717 = x1804 * x3675 + x1807 * x3677 + x1742 * x3679;
  const Real x3760 = x1831 * x3677 - x1828 * x3675 - x1744 * x3679;
  const Real x3777 = x1831 * x3675 - x1835 * x3677 + x1745 * x3679;
  const Real x3794 = x1745 * x3677 - x1744 * x3675 - x1643 * x3679;
  const Real x3699 = x1766 * x3671 + x3695 + x1774 * x3673;
  const Real x3743 = x1799 * x3671 + x3739 + x1814 * x3673;
  const Real x3798 = x1757 * x3669 + x3699 + x1846;
  const Real x3721 = x1791 * x3671 + x3717 + x1799 * x3673;
  const Real x3802 = x1774 * x3669 + x3743 + x1868;
  const Real x3762 = x3760 - x1804 * x3671 - x1820 * x3673;
  const Real x3779 = x3777 - x1807 * x3671 - x1823 * x3673;
  const Real x3796 = x3794 - x1742 * x3671 - x1743 * x3673;
  const Real x3800 = x1766 * x3669 + x3721 + x1857;
  const Real x3804 = x3762 - x1779 * x3669 - x1880;
  const Real x3805 = x3779 - x1782 * x3669 - x1893;
  const Real x3806 = x3796 - x1741 * x3669 - x1905;
  const Real x3799 = -x3798;
  w.result[3] = x3799;
  const Real x3801 = -x3800;
  w.result[4] = x3801;
  const Real x3803 = -x3802;
  w.result[5] = x3803;
  // joint 4 "right_hip": its acceleration, and that of the link beyond
  const Real x3815 = x3805 - 0.04 * x3798;
  const Real x3818 = x3806 + 0.09 * x3798;
  const Real x3812 = x3804 - 0.09 * x3802 + 0.04 * x3800;
  const Real x3853 = x237 * x3815 + x244 * x3818 + x230 * x3812;
  const Real x3858 = x240 * x3815 + x245 * x3818 + x233 * x3812;
  const Real x3863 = x243 * x3815 + x247 * x3818 + x236 * x3812;
  const Real x3871 = x1202 - x1259 * x3853 - x1265 * x3858;
  const Real x3872 = x3871 - x1271 * x3863;
  const Real x3880 = x1196 - x1247 * x3853 - x1250 * x3858;
  const Real x3881 = x3880 - x1253 * x3863;
  const Real x3889 = x1193 + x1240 * x3853 + x1242 * x3858;
  const Real x3890 = x3889 - x1244 * x3863;
  const Real x3827 = x230 * x3798 + x237 * x3800 + x244 * x3802;
  const Real x3891 = x3827 + x3872;
  w.result[13] = x3891;
  const Real x3837 = x233 * x3798 + x240 * x3800 + x245 * x3802;
  const Real x3892 = x3837 + x3881;
  w.result[14] = x3892;
  const Real x3847 = x236 * x3798 + x243 * x3800 + x247 * x3802;
  const Real x3893 = x3847 + x3890;
  w.result[15] = x3893;
  // joint 5 "right_knee": its acceleration, and that of the link beyond
  const Real x3896 = x3853 - 0.41 * x3881;
  const Real x3905 = cosine[0] * x3872 - sine[0] * x3890;
  const Real x3898 = x3858 + 0.41 * x3872;
  const Real x3901 = cosine[0] * x3890 + sine[0] * x3872;
  const Real x3908 = cosine[0] * x3863 + sine[0] * x3896;
  const Real x3912 = cosine[0] * x3896 - sine[0] * x3863;
  // joint 6 "right_ankle": its acceleration, and that of the link beyond
  const Real x3930 = x3898 + 0.41 * x3905;
  // joint 0 "root": acceleration of the base
  const Real x3978 = x3804 - x59;
  w.result[0] = x3978;
  const Real x3979 = x3805 - x64;
  w.result[1] = x3979;
  const Real x3980 = x3806 - x69;
  w.result[2] = x3980;
  // joint 5 "right_knee": its acceleration, and that of the link beyond
  const Real x3922 = x1001 + x1002 * x3905 + x1007 * x3898;
  const Real x3924 = x1004 * x3908 + x3922 - x1006 * x3912;
  const Real x3925 = x3924 - x3881;
  w.result[16] = x3925;
  // joint 6 "right_ankle": its acceleration, and that of the link beyond
  const Real x3928 = x3912 - 0.41 * x3924;
  const Real x3955 = x425 * x3908 + x420 * x3930 + x413 * x3928;
  const Real x3950 = x424 * x3908 + x417 * x3930 + x410 * x3928;
  const Real x3960 = x427 * x3908 + x423 * x3930 + x416 * x3928;
  const Real x3935 = x424 * x3901 + x410 * x3905 + x417 * x3924;
  const Real x3975 = x841 - 11.953794325815098 * x3955 - x3935;
  w.result[17] = x3975;
  const Real x3945 = x427 * x3901 + x416 * x3905 + x423 * x3924;
  const Real x3977 = x838 - 3.301677113212739 * x3955 - x3945;
  w.result[19] = x3977;
  const Real x3940 = x425 * x3901 + x413 * x3905 + x420 * x3924;
  const Real x3976 = x837 + x3950 * 3.697995778737819 + x3960 * 5.546993668106728 - x3940;
  w.result[18] = x3976;
}

// =================================================================================================
// Process 1: 549 products, 437 sums, 9 quotients
// =================================================================================================

ADAGEN_NOINLINE void part_1_0(Workspace& w) {
  ADAGEN_INPUTS
  // joint 0 "root": placement, velocity and reference acceleration of its link
  const Real x70 = v[3] * v[3];
  const Real x78 = v[4] * v[5];
  // joint 1 "left_hip": placement, velocity and reference acceleration of its link
  const Real x158 = v[3] * v[4] * 0.09 - v[3] * v[5] * 0.04;
  const Real x94 = q[7] * q[7] + q[8] * q[8] + q[9] * q[9];
  const Real x95 = q[10] * q[10] + x94;
  require_length(w, x95, 1);
  const Real x168 = x78 * 0.09 + (x70 + v[4] * v[4]) * 0.04;
  const Real x163 = (x70 + v[5] * v[5]) * 0.09 + x78 * 0.04;
  const Real x97 = 2.0 * (1 / x95);
  const Real x98 = q[7] * x97;
  const Real x99 = q[8] * x97;
  const Real x100 = q[9] * x97;
  const Real x101 = q[8] * x99;
  const Real x102 = q[9] * x100;
  const Real x105 = q[8] * x98;
  const Real x106 = q[10] * x100;
  const Real x108 = q[9] * x98;
  const Real x109 = q[10] * x99;
  // joint 3 "left_ankle": placement, velocity and reference acceleration of its link
  const Real x284 = q[12] * q[12] + q[13] * q[13] + q[14] * q[14];
  const Real x285 = q[15] * q[15] + x284;
  require_length(w, x285, 3);
  const Real x287 = 2.0 * (1 / x285);
  const Real x289 = q[13] * x287;
  const Real x290 = q[14] * x287;
  const Real x288 = q[12] * x287;
  const Real x291 = q[13] * x289;
  const Real x292 = q[14] * x290;
  const Real x298 = q[14] * x288;
  const Real x299 = q[15] * x289;
  const Real x295 = q[13] * x288;
  const Real x296 = q[15] * x290;
  const Real x302 = q[12] * x288;
  const Real x305 = q[14] * x289;
  const Real x306 = q[15] * x288;
  const Real x300 = x298 + x299;
  w.x[0] = x300;
  const Real x308 = x298 - x299;
  w.x[1] = x308;
  const Real x297 = x295 - x296;
  w.x[2] = x297;
  const Real x301 = x295 + x296;
  w.x[3] = x301;
  const Real x307 = x305 - x306;
  w.x[4] = x307;
  const Real x309 = x305 + x306;
  w.x[5] = x309;
  const Real x294 = 1.0 - (x291 + x292);
  w.x[6] = x294;
  const Real x304 = 1.0 - (x292 + x302);
  w.x[7] = x304;
  const Real x311 = 1.0 - (x291 + x302);
  w.x[8] = x311;
  // joint 3 "left_ankle": articulated-body inertia and bias force through it
  const Real x620 = x297 * 0.3237476001746317;
  const Real x611 = x309 * 0.3237476001746317;
  const Real x619 = x294 * 0.8520801688504872 - x300 * 0.2218797467242691;
  const Real x624 = x300 * 0.6671803799135964 - x294 * 0.2218797467242691;
  const Real x610 = x308 * 0.8520801688504872 - x311 * 0.2218797467242691;
  // joint 1 "left_hip": placement, velocity and reference acceleration of its link
  const Real x112 = q[7] * x98;
  const Real x115 = q[9] * x99;
  const Real x116 = q[10] * x98;
  const Real x107 = x105 - x106;
  const Real x110 = x108 + x109;
  const Real x111 = x105 + x106;
  const Real x117 = x115 - x116;
  const Real x118 = x108 - x109;
  const Real x119 = x115 + x116;
  const Real x104 = 1.0 - (x101 + x102);
  const Real x114 = 1.0 - (x102 + x112);
  const Real x121 = 1.0 - (x101 + x112);
  const Real x128 = v[4] * x111 + v[5] * x118 + v[3] * x104;
  const Real x133 = v[3] * x107 + v[5] * x119 + v[4] * x114;
  const Real x138 = v[3] * x110 + v[4] * x117 + v[5] * x121;
  const Real x139 = v[6] + x128;
  const Real x140 = v[7] + x133;
  const Real x141 = v[8] + x138;
  const Real x174 = x118 * x168 - x111 * x163 + x104 * x158;
  const Real x145 = v[8] * x133 - v[7] * x138;
  const Real x149 = v[6] * x138 - v[8] * x128;
  const Real x153 = v[7] * x128 - v[6] * x133;
  // joint 3 "left_ankle": articulated-body inertia and bias force through it
  const Real x615 = x311 * 0.6671803799135964 - x308 * 0.2218797467242691;
  const Real x659 = x301 * (x301 * 0.8520801688504872 - x307 * 0.2218797467242691);
  const Real x661 = x307 * (x307 * 0.6671803799135964 - x301 * 0.2218797467242691);
  const Real x663 = x659 + x304 * (x304 * 0.3237476001746317) + x661;
  const Real x653 = x294 * x619 + x297 * x620 + x300 * x624;
  const Real x658 = x301 * x619 + x304 * x620 + x307 * x624;
  const Real x672 = 0.41 * x663;
  const Real x670 = 0.41 * x653;
  const Real x643 = x294 * x610 + x297 * x611 + x300 * x615;
  const Real x668 = 0.41 * x658;
  const Real x648 = x301 * x610 + x304 * x611 + x307 * x615;
  const Real x666 = 0.41 * x643;
  const Real x676 = 0.41 * x668;
  const Real x719 = -0.576 - x670;
  const Real x638 = x308 * x610 + x309 * x611 + x311 * x615;
  const Real x718 = 0.1483467 + 0.41 * x670;
  require_more(w, x718, 0.0, kFactorization, 2);
  // joint 2 "left_knee": articulated-body inertia and bias force through it
  const Real x730 = 1 / x718;
  const Real x733 = x676 * x730;
  w.x[9] = x733;
  const Real x738 = x668 * x730;
  w.x[10] = x738;
  const Real x735 = x666 * x730;
  w.x[11] = x735;
  const Real x737 = x719 * x730;
  w.x[12] = x737;
  // joint 1 "left_hip": placement, velocity and reference acceleration of its link
  const Real x205 = x139 * x141;
  const Real x203 = x139 * x139 + x140 * x140;
  const Real x207 = x149 + x205;
  const Real x186 = x110 * x158 - x117 * x163 + x121 * x168;
  const Real x200 = x140 * x141;
  const Real x201 = x200 - x145;
  // joint 2 "left_knee": placement, velocity and reference acceleration of its link
  const Real x216 = x141 * cosine[0] + x139 * sine[0];
  const Real x220 = x139 * cosine[0] - x141 * sine[0];
  const Real x221 = x140 + v[9];
  const Real x230 = x153 * cosine[0] + x145 * sine[0] + v[9] * x220;
  const Real x237 = x174 - x207 * 0.41;
  const Real x243 = x186 + x203 * 0.41;
  const Real x259 = x216 * x220;
  // joint 2 "left_knee": articulated-body inertia and bias force through it
  const Real x742 = 0.1483467 + 0.41 * x672 - x676 * x733;
  const Real x751 = 0.576 + x672 - x676 * x738;
  const Real x769 = 3.2 + x663 - x668 * x738;
  const Real x754 = 3.2 + x638 - x666 * x735;
  const Real x763 = 3.2 + x653 - x719 * x737;
  const Real x745 = 0.41 * x648 - x676 * x735;
  const Real x748 = x668 + x676 * x737;
  const Real x757 = x643 + x666 * x737;
  const Real x760 = x648 - x666 * x738;
  const Real x766 = x658 + x719 * x738;
  const Real x783 = cosine[0] * x751;
  const Real x781 = sine[0] * x751;
  const Real x798 = cosine[0] * (0.004 - x742);
  const Real x831 = x783 + 0.41 * x769;
  const Real x789 = cosine[0] * x748 + sine[0] * x745;
  const Real x812 = sine[0] * x760 + cosine[0] * x766;
  const Real x803 = cosine[0] * x798;
  const Real x817 = cosine[0] * (x754 - x763) - x757 * (2.0 * sine[0]);
  const Real x794 = cosine[0] * x789;
  const Real x824 = 0.41 * x812;
  const Real x821 = cosine[0] * x817;
  const Real x791 = sine[0] * x789;
  const Real x847 = sine[0] * x798 - 0.41 * x781;
  const Real x826 = x794 + x824;
  const Real x823 = x754 - x821;
  const Real x843 = 0.41 * x826;
  const Real x842 = 0.004 - x803 + (0.41 * x783 + 0.41 * x831);
  const Real x872 = 0.42868 + x842;
  require_more(w, x872, 0.0, kFactorization, 1);
  const Real x827 = 0.41 * x823;
  const Real x874 = 0.42868 + 0.41 * x827;
  w.x[13] = x874;
  // link 2 "left_thigh": mobility from its articulated-body inertia
  const Real x886 = 1 / x872;
  // joint 1 "left_hip": placement, velocity and reference acceleration of its link
  const Real x180 = x107 * x158 + x119 * x168 - x114 * x163;
  // joint 2 "left_knee": placement, velocity and reference acceleration of its link
  const Real x233 = x145 * cosine[0] - x153 * sine[0] - v[9] * x216;
  const Real x257 = x220 * x220 + x221 * x221;
  const Real x261 = x149 + x259;
  const Real x269 = x216 * x221;
  const Real x246 = cosine[0] * x243 + sine[0] * x237;
  const Real x250 = cosine[0] * x237 - sine[0] * x243;
  const Real x270 = x269 - x233;
  const Real x240 = x180 - x201 * 0.41;
  // joint 3 "left_ankle": placement, velocity and reference acceleration of its link
  const Real x316 = x216 * x308 + x221 * x301 + x220 * x294;
  const Real x321 = x216 * x309 + x221 * x304 + x220 * x297;
  const Real x326 = x216 * x311 + x221 * x307 + x220 * x300;
  const Real x327 = v[10] + x316;
  const Real x328 = v[11] + x321;
  const Real x329 = v[12] + x326;
  const Real x362 = x246 + 0.41 * x257;
  const Real x365 = x250 - 0.41 * x261;
  const Real x334 = x230 * x308 + x149 * x301 + x233 * x294;
  const Real x349 = v[12] * x321 - v[11] * x326 + x334;
  const Real x344 = x230 * x311 + x149 * x307 + x233 * x300;
  const Real x359 = v[11] * x316 - v[10] * x321 + x344;
  const Real x368 = x240 - 0.41 * x270;
  const Real x392 = x327 * x328;
  const Real x397 = x328 * x329;
  const Real x388 = x328 * x328;
  const Real x394 = x359 + x392;
  const Real x339 = x230 * x309 + x149 * x304 + x233 * x297;
  const Real x354 = v[10] * x326 - v[12] * x316 + x339;
  const Real x378 = x309 * x362 + x297 * x365 + x304 * x368;
  const Real x390 = x388 + x329 * x329;
  const Real x398 = x397 - x349;
  const Real x400 = x327 * x327 + x388;
  const Real x402 = x327 * x329;
  // joint 2 "left_knee": articulated-body inertia and bias force through it
  const Real x876 = x742 + x803 + 0.02688;
  w.x[14] = x876;
  const Real x877 = 8.4 + x823;
  w.x[15] = x877;
  // link 2 "left_thigh": mobility from its articulated-body inertia
  const Real x887 = x843 * x886;
  const Real x889 = x847 * x886;
  const Real x895 = x874 - x843 * x887;
  w.x[16] = x895;
  const Real x898 = 0.41 * x791 + x847 * x887;
  const Real x908 = 1 / x895;
  const Real x901 = -1.596 - x827 + x826 * x887;
  const Real x890 = x826 * x886;
  const Real x909 = x898 * x908;
  const Real x910 = x901 * x908;
  // joint 3 "left_ankle": placement, velocity and reference acceleration of its link
  const Real x373 = x308 * x362 + x294 * x365 + x301 * x368;
  const Real x383 = x311 * x362 + x300 * x365 + x307 * x368;
  // link 4 "left_foot": force that the reference field takes
  const Real x504 = x349 * 0.00268333 - x397 * 0.00133334 + x394 * 0.0024;
  const Real x512 = x354 * 0.01081667 - x402 * 0.0068;
  const Real x521 = x359 * 0.00948333 + x392 * 0.00813334 - x398 * 0.0024;
  const Real x529 = 0.0024 * (x390 - x400) + x512 - 0.04 * x373;
  // joint 3 "left_ankle": articulated-body inertia and bias force through it
  const Real x561 = tau[10] - (x504 + 0.04 * x378);
  const Real x566 = tau[12] - (x521 + x378 * 0.06) - 0.8944110489578248 * x561;
  const Real x569 = 136.30025397304513 * x566;
  w.x[17] = x569;
  const Real x568 = 92.44989446844546 * (tau[11] - (x529 - x383 * 0.06));
  w.x[18] = x568;
  const Real x572 = 372.67127039909366 * x561 - 0.8944110489578248 * x569;
  w.x[19] = x572;
  // joint 2 "left_knee": articulated-body inertia and bias force through it
  const Real x873 = 1.596 + x831;
  const Real x809 = cosine[0] * x760 - sine[0] * x766;
  const Real x820 = x757 + sine[0] * x817;
  const Real x834 = x745 - x791 + 0.41 * x809;
  const Real x878 = 8.4 + x769;
  w.x[20] = x878;
  // link 2 "left_thigh": mobility from its articulated-body inertia
  const Real x918 = x876 - x847 * x889 - x898 * x909;
  w.x[21] = x918;
  const Real x925 = x791 + x826 * x889 + x901 * x909;
  const Real x941 = 1 / x918;
  const Real x904 = x873 * x887 - x824;
  const Real x891 = x873 * x886;
  const Real x942 = x925 * x941;
  const Real x933 = x781 + x873 * x889 + x904 * x909;
  const Real x911 = x904 * x908;
  const Real x954 = x877 - x826 * x890 - x901 * x910;
  const Real x955 = x954 - x925 * x942;
  w.x[22] = x955;
  const Real x974 = 1 / x955;
  const Real x944 = x933 * x941;
  const Real x963 = x812 - x873 * x890 - x904 * x910;
  const Real x964 = x963 - x933 * x942;
  const Real x907 = x834 * x887 - 0.41 * x820;
  // link 4 "left_foot": force that the reference field takes
  const Real x538 = x373 - x390 * 0.06 - 0.04 * (x354 + x402);
  // joint 3 "left_ankle": articulated-body inertia and bias force through it
  const Real x599 = x538 - 0.04 * x568;
  // link 4 "left_foot": force that the reference field takes
  const Real x543 = x378 + x394 * 0.06 - 0.04 * x398;
  const Real x548 = x383 + 0.04 * x400 + (x402 - x354) * 0.06;
  // joint 3 "left_ankle": articulated-body inertia and bias force through it
  const Real x606 = x548 - 0.06 * x568;
  const Real x603 = x543 + 0.06 * x569 + 0.04 * x572;
  const Real x704 = x294 * x599 + x300 * x606 + x297 * x603;
  const Real x694 = x301 * tau[10] + x307 * tau[12] + x304 * tau[11];
  const Real x709 = x301 * x599 + x307 * x606 + x304 * x603;
  // link 3 "left_shank": force that the reference field takes
  const Real x470 = x149 * 0.1483467 + x259 * 0.1443467 - x250 * 0.576;
  // joint 2 "left_knee": articulated-body inertia and bias force through it
  const Real x879 = x763 + x821 + 8.4;
  w.x[23] = x879;
  // link 2 "left_thigh": mobility from its articulated-body inertia
  const Real x986 = x878 - x873 * x891 - x904 * x911;
  const Real x940 = x748 - x794 - x834 * x889 - x907 * x909;
  const Real x892 = x834 * x886;
  const Real x975 = x964 * x974;
  const Real x912 = x907 * x908;
  const Real x972 = x820 - x834 * x890 - x907 * x910;
  const Real x973 = x940 * x942 + x972;
  const Real x946 = x940 * x941;
  const Real x988 = x986 - x933 * x944 - x964 * x975;
  w.x[24] = x988;
  const Real x998 = x809 - x834 * x891 - x907 * x911;
  const Real x1001 = 1 / x988;
  const Real x976 = x973 * x974;
  const Real x1000 = x940 * x944 + x998 - x973 * x975;
  const Real x1027 = x889 + x887 * x909;
  const Real x1014 = x879 - x834 * x892 - x907 * x912;
  const Real x1002 = x1000 * x1001;
  const Real x1037 = x890 + x887 * x910 + x942 * x1027;
  const Real x1042 = x910 + x909 * x942;
  // joint 3 "left_ankle": articulated-body inertia and bias force through it
  const Real x689 = x297 * tau[11] + x300 * tau[12] + x294 * tau[10];
  // link 3 "left_shank": force that the reference field takes
  const Real x467 = x233 * 0.1483467 - x269 * 0.1443467 + x240 * 0.576;
  // joint 3 "left_ankle": articulated-body inertia and bias force through it
  const Real x699 = x308 * x599 + x311 * x606 + x309 * x603;
  const Real x684 = x308 * tau[10] + x309 * tau[11] + x311 * tau[12];
  const Real x723 = x230 * 0.004 + x684;
  // joint 2 "left_knee": articulated-body inertia and bias force through it
  const Real x732 = x730 * (tau[9] - (x694 - 0.41 * x704 + x470));
  w.x[25] = x732;
  const Real x772 = x689 + 0.41 * x709 + x467 - x676 * x732;
  // joint 3 "left_ankle": articulated-body inertia and bias force through it
  const Real x726 = x246 * 3.2 + x257 * 0.576 + x699;
  // joint 2 "left_knee": articulated-body inertia and bias force through it
  const Real x775 = x726 - x666 * x732;
  // joint 3 "left_ankle": articulated-body inertia and bias force through it
  const Real x727 = x250 * 3.2 - x261 * 0.576 + x704;
  // joint 2 "left_knee": articulated-body inertia and bias force through it
  const Real x777 = x727 + x719 * x732;
  // joint 3 "left_ankle": articulated-body inertia and bias force through it
  const Real x728 = x240 * 3.2 - x270 * 0.576 + x709;
  // joint 2 "left_knee": articulated-body inertia and bias force through it
  const Real x780 = x728 - x668 * x732;
  const Real x865 = sine[0] * x775 + cosine[0] * x777;
  // link 2 "left_thigh": mobility from its articulated-body inertia
  const Real x1016 = x1014 - x940 * x946 - x973 * x976;
  const Real x1017 = x1016 - x1000 * x1002;
  w.x[26] = x1017;
  const Real x1106 = x887 * x908;
  const Real x1018 = 1 / x1017;
  w.x[27] = x1018;
  w.to[0][20] = x1018;
  const Real x1053 = x891 + x887 * x911 + x944 * x1027;
  const Real x1055 = x975 * x1037 - x1053;
  const Real x1063 = x975 * x1042 - (x911 + x909 * x944);
  const Real x1066 = x944 - x942 * x975;
  const Real x1107 = x941 * x1027;
  const Real x1109 = x909 * x941;
  const Real x1079 = x946 * x1027 - (x892 + x887 * x912);
  const Real x1111 = x974 * x1037;
  const Real x1113 = x974 * x1042;
  const Real x1115 = x942 * x974;
  const Real x1081 = x976 * x1037 + x1079 - x1002 * x1055;
  const Real x1090 = x909 * x946 - x912 + x976 * x1042;
  const Real x1091 = x1090 - x1002 * x1063;
  const Real x1099 = x946 + x942 * x976 + x1002 * x1066;
  const Real x1104 = x975 * x1002 - x976;
  const Real x1116 = x1001 * x1055;
  const Real x1117 = x1001 * x1063;
  const Real x1118 = x1001 * x1066;
  const Real x1119 = x975 * x1001;
  const Real x1121 = x1018 * x1081;
  w.x[28] = x1121;
  w.to[0][5] = x1121;
  const Real x1122 = x1018 * x1091;
  w.x[29] = x1122;
  w.to[0][10] = x1122;
  const Real x1123 = x1018 * x1099;
  w.x[30] = x1123;
  const Real x1125 = x1018 * x1104;
  w.x[31] = x1125;
  w.to[0][17] = x1125;
  const Real x1126 = x1002 * x1018;
  w.x[32] = x1126;
  const Real x1136 = x886 + x887 * x1106 + x1027 * x1107;
  // link 2 "left_thigh": force that the reference field takes
  const Real x428 = x145 * 0.42868 - x200 * 0.4018 + x180 * 1.596;
  // joint 2 "left_knee": articulated-body inertia and bias force through it
  const Real x868 = sine[0] * x723 + cosine[0] * x772 + 0.41 * x780;
  const Real x880 = x428 + x868;
  // link 2 "left_thigh": force that the reference field takes
  const Real x443 = x186 * 8.4 + x203 * 1.596;
  // joint 2 "left_knee": articulated-body inertia and bias force through it
  const Real x885 = cosine[0] * x775 - sine[0] * x777 + x443;
  // link 2 "left_thigh": force that the reference field takes
  const Real x431 = x149 * 0.42868 + x205 * 0.4018 - x174 * 1.596;
  // joint 2 "left_knee": articulated-body inertia and bias force through it
  const Real x881 = tau[9] - 0.41 * x865 + x431;
  const Real x882 = cosine[0] * x723 - sine[0] * x772 + x153 * 0.02688;
  const Real x883 = x174 * 8.4 - x207 * 1.596 + x865;
  // link 2 "left_thigh": mobility from its articulated-body inertia
  const Real x1147 = x1106 + x1027 * x1109 + x1037 * x1113;
  const Real x1138 = x1037 * x1111 + x1136 + x1055 * x1116;
  const Real x1139 = x1081 * x1121 + x1138;
  w.x[33] = x1139;
  w.to[0][0] = x1139;
  const Real x1149 = x1055 * x1117 + x1147 + x1081 * x1122;
  w.x[34] = x1149;
  w.to[0][1] = x1149;
  const Real x1157 = x1055 * x1118 - (x1107 + x1037 * x1115);
  const Real x1158 = x1157 - x1081 * x1123;
  w.x[35] = x1158;
  w.to[0][2] = x1158;
  const Real x1164 = x1081 * x1125 - (x1111 + x1055 * x1119);
  w.x[36] = x1164;
  w.to[0][3] = x1164;
  const Real x1167 = x1116 - x1081 * x1126;
  w.x[37] = x1167;
  w.to[0][4] = x1167;
  const Real x1175 = x908 + x909 * x1109 + x1042 * x1113;
  const Real x1177 = x1063 * x1117 + x1175 + x1091 * x1122;
  w.x[38] = x1177;
  w.to[0][6] = x1177;
  const Real x1185 = x1063 * x1118 - (x1109 + x1042 * x1115);
  const Real x1186 = x1185 - x1091 * x1123;
  w.x[39] = x1186;
  w.to[0][7] = x1186;
  const Real x1192 = x1091 * x1125 - (x1113 + x1063 * x1119);
  w.x[40] = x1192;
  w.to[0][8] = x1192;
  const Real x1195 = x1117 - x1091 * x1126;
  w.x[41] = x1195;
  w.to[0][9] = x1195;
  const Real x1201 = x941 + x942 * x1115 + x1066 * x1118;
  const Real x1202 = x1099 * x1123 + x1201;
  w.x[42] = x1202;
  w.to[0][11] = x1202;
  const Real x1208 = x1115 - x1066 * x1119 - x1099 * x1125;
  w.x[43] = x1208;
  w.to[0][12] = x1208;
  const Real x1211 = x1118 + x1099 * x1126;
  w.x[44] = x1211;
  w.to[0][13] = x1211;
  const Real x1216 = x974 + x975 * x1119 + x1104 * x1125;
  w.x[45] = x1216;
  w.to[0][15] = x1216;
  const Real x1219 = x1119 + x1104 * x1126;
  w.x[46] = x1219;
  // joint 2 "left_knee": articulated-body inertia and bias force through it
  const Real x884 = x180 * 8.4 - x201 * 1.596 + x780;
  // link 2 "left_thigh": mobility from its articulated-body inertia
  const Real x1223 = x1001 + x1002 * x1126;
  w.x[47] = x1223;
  w.to[0][18] = x1223;
  const Real x1231 = x880 * x1139 + x885 * x1121 + x881 * x1149;
  const Real x1242 = x880 * x1149 + x885 * x1122 + x881 * x1177;
  const Real x1254 = x880 * x1158 - x885 * x1123 + x881 * x1186;
  const Real x1266 = x880 * x1164 + x885 * x1125 + x881 * x1192;
  const Real x1279 = x880 * x1167 - x885 * x1126 + x881 * x1195;
  const Real x1292 = x880 * x1121 + x885 * x1018 + x881 * x1122;
  const Real x1233 = x882 * x1158 + x1231 + x883 * x1164;
  const Real x1234 = x884 * x1167 + x1233;
  w.x[48] = x1234;
  const Real x1124 = -x1123;
  w.to[0][14] = x1124;
  const Real x1244 = x882 * x1186 + x1242 + x883 * x1192;
  const Real x1245 = x884 * x1195 + x1244;
  w.x[49] = x1245;
  const Real x1127 = -x1126;
  w.to[0][19] = x1127;
  const Real x1256 = x882 * x1202 + x1254 + x883 * x1208;
  const Real x1257 = x884 * x1211 + x1256;
  w.x[50] = x1257;
  const Real x1220 = -x1219;
  w.to[0][16] = x1220;
  const Real x1268 = x882 * x1208 + x1266 + x883 * x1216;
  const Real x1269 = x1268 - x884 * x1219;
  w.x[51] = x1269;
  const Real x1281 = x882 * x1211 + x1279 - x883 * x1219;
  const Real x1282 = x884 * x1223 + x1281;
  w.x[52] = x1282;
  const Real x1294 = x1292 - x882 * x1123 + x883 * x1125;
  const Real x1295 = x1294 - x884 * x1126;
  w.x[53] = x1295;
  const Real x1296 = -x1234;
  w.to[0][21] = x1296;
  const Real x1297 = -x1245;
  w.to[0][22] = x1297;
  const Real x1298 = -x1257;
  w.to[0][23] = x1298;
  const Real x1299 = -x1269;
  w.to[0][24] = x1299;
  const Real x1300 = -x1282;
  w.to[0][25] = x1300;
  const Real x1301 = -x1295;
  w.to[0][26] = x1301;
}

ADAGEN_NOINLINE void part_1_1(Workspace& w) {
  ADAGEN_INPUTS
  const Real x874 = w.x[13];
  const Real x876 = w.x[14];
  const Real x877 = w.x[15];
  const Real x878 = w.x[20];
  const Real x879 = w.x[23];
  const Real x895 = w.x[16];
  const Real x918 = w.x[21];
  const Real x955 = w.x[22];
  const Real x988 = w.x[24];
  const Real x1017 = w.x[26];
  // joint 0 "root": placement, velocity and reference acceleration of its link
  const Real x20 = q[3] * q[3] + q[4] * q[4] + q[5] * q[5];
  const Real x21 = q[6] * q[6] + x20;
  require_length(w, x21, 0);
  // link 2 "left_thigh": mobility from its articulated-body inertia
  const Real x1022 = 1.7763568394002505e-15 * x878;
  require_more(w, x988, x1022, kFactorization, 1);
  const Real x1020 = 1.7763568394002505e-15 * x876;
  require_more(w, x918, x1020, kFactorization, 1);
  const Real x1021 = 1.7763568394002505e-15 * x877;
  require_more(w, x955, x1021, kFactorization, 1);
  const Real x1023 = 1.7763568394002505e-15 * x879;
  require_more(w, x1017, x1023, kFactorization, 1);
  const Real x1019 = 1.7763568394002505e-15 * x874;
  require_more(w, x895, x1019, kFactorization, 1);
}

ADAGEN_NOINLINE void part_1_2(Workspace& w) {
  ADAGEN_INPUTS
  const Real x294 = w.x[6];
  const Real x297 = w.x[2];
  const Real x300 = w.x[0];
  const Real x301 = w.x[3];
  const Real x304 = w.x[7];
  const Real x307 = w.x[4];
  const Real x308 = w.x[1];
  const Real x309 = w.x[5];
  const Real x311 = w.x[8];
  const Real x568 = w.x[18];
  const Real x569 = w.x[17];
  const Real x572 = w.x[19];
  const Real x732 = w.x[25];
  const Real x733 = w.x[9];
  const Real x735 = w.x[11];
  const Real x737 = w.x[12];
  const Real x738 = w.x[10];
  const Real x1018 = w.x[27];
  const Real x1121 = w.x[28];
  const Real x1122 = w.x[29];
  const Real x1123 = w.x[30];
  const Real x1125 = w.x[31];
  const Real x1126 = w.x[32];
  const Real x1139 = w.x[33];
  const Real x1149 = w.x[34];
  const Real x1158 = w.x[35];
  const Real x1164 = w.x[36];
  const Real x1167 = w.x[37];
  const Real x1177 = w.x[38];
  const Real x1186 = w.x[39];
  const Real x1192 = w.x[40];
  const Real x1195 = w.x[41];
  const Real x1202 = w.x[42];
  const Real x1208 = w.x[43];
  const Real x1211 = w.x[44];
  const Real x1216 = w.x[45];
  const Real x1219 = w.x[46];
  const Real x1223 = w.x[47];
  const Real x1234 = w.x[48];
  const Real x1245 = w.x[49];
  const Real x1257 = w.x[50];
  const Real x1269 = w.x[51];
  const Real x1282 = w.x[52];
  const Real x1295 = w.x[53];
  // message received
  const Real x1302 = w.from[4][0];
  const Real x1307 = w.from[4][5];
  const Real x1303 = w.from[4][1];
  const Real x1304 = w.from[4][2];
  const Real x1305 = w.from[4][3];
  const Real x1306 = w.from[4][4];
  // link 2 "left_thigh": acceleration under the handle forces
  const Real x1315 = x1139 * x1302 + x1121 * x1307 + x1149 * x1303;
  const Real x1326 = x1149 * x1302 + x1122 * x1307 + x1177 * x1303;
  const Real x1338 = x1158 * x1302 - x1123 * x1307 + x1186 * x1303;
  const Real x1350 = x1164 * x1302 + x1125 * x1307 + x1192 * x1303;
  const Real x1376 = x1121 * x1302 + x1018 * x1307 + x1122 * x1303;
  const Real x1363 = x1167 * x1302 - x1126 * x1307 + x1195 * x1303;
  const Real x1317 = x1158 * x1304 + x1315 + x1164 * x1305;
  const Real x1328 = x1186 * x1304 + x1326 + x1192 * x1305;
  const Real x1340 = x1202 * x1304 + x1338 + x1208 * x1305;
  const Real x1352 = x1208 * x1304 + x1350 + x1216 * x1305;
  const Real x1378 = x1376 - x1123 * x1304 + x1125 * x1305;
  const Real x1380 = x1167 * x1306 + x1317 - x1234;
  const Real x1381 = x1195 * x1306 + x1328 - x1245;
  const Real x1382 = x1211 * x1306 + x1340 - x1257;
  const Real x1365 = x1211 * x1304 + x1363 - x1219 * x1305;
  const Real x1385 = x1378 - x1126 * x1306 - x1295;
  // joint 2 "left_knee": its acceleration, and that of the link beyond
  const Real x1388 = x1352 - x1219 * x1306 - x1269 - 0.41 * x1381;
  const Real x1397 = cosine[0] * x1380 - sine[0] * x1382;
  const Real x1390 = x1223 * x1306 + x1365 - x1282 + 0.41 * x1380;
  const Real x1393 = cosine[0] * x1382 + sine[0] * x1380;
  const Real x1400 = cosine[0] * x1385 + sine[0] * x1388;
  const Real x1404 = cosine[0] * x1388 - sine[0] * x1385;
  const Real x1414 = x732 + x733 * x1397 + x738 * x1390;
  const Real x1416 = x735 * x1400 + x1414 - x737 * x1404;
  const Real x1417 = x1416 - x1381;
  w.result[9] = x1417;
  // joint 3 "left_ankle": its acceleration, and that of the link beyond
  const Real x1422 = x1390 + 0.41 * x1397;
  const Real x1420 = x1404 - 0.41 * x1416;
  const Real x1447 = x309 * x1400 + x304 * x1422 + x297 * x1420;
  const Real x1442 = x308 * x1400 + x301 * x1422 + x294 * x1420;
  const Real x1452 = x311 * x1400 + x307 * x1422 + x300 * x1420;
  const Real x1427 = x308 * x1393 + x294 * x1397 + x301 * x1416;
  const Real x1467 = x572 - 11.953794325815098 * x1447 - x1427;
  w.result[10] = x1467;
  const Real x1437 = x311 * x1393 + x300 * x1397 + x307 * x1416;
  const Real x1469 = x569 - 3.301677113212739 * x1447 - x1437;
  w.result[12] = x1469;
  const Real x1432 = x309 * x1393 + x297 * x1397 + x304 * x1416;
  const Real x1468 = x568 + x1442 * 3.697995778737819 + x1452 * 5.546993668106728 - x1432;
  w.result[11] = x1468;
}

// =================================================================================================
// Process 2: 1483 products, 1221 sums, 18 quotients
// =================================================================================================

ADAGEN_NOINLINE void part_2_0(Workspace& w) {
  ADAGEN_INPUTS
  // joint 0 "root": placement, velocity and reference acceleration of its link
  const Real x20 = q[3] * q[3] + q[4] * q[4] + q[5] * q[5];
  const Real x21 = q[6] * q[6] + x20;
  require_length(w, x21, 0);
  // joint 7 "spine": placement, velocity and reference acceleration of its link
  const Real x94 = q[25] * q[25] + q[26] * q[26] + q[27] * q[27];
  const Real x95 = q[28] * q[28] + x94;
  require_length(w, x95, 7);
  const Real x97 = 2.0 * (1 / x95);
  const Real x98 = q[25] * x97;
  const Real x99 = q[26] * x97;
  const Real x100 = q[27] * x97;
  const Real x101 = q[26] * x99;
  const Real x102 = q[27] * x100;
  const Real x104 = 1.0 - (x101 + x102);
  const Real x105 = q[26] * x98;
  const Real x106 = q[28] * x100;
  const Real x107 = x105 - x106;
  const Real x108 = q[27] * x98;
  const Real x109 = q[28] * x99;
  const Real x110 = x108 + x109;
  const Real x111 = x105 + x106;
  const Real x112 = q[25] * x98;
  const Real x114 = 1.0 - (x102 + x112);
  const Real x115 = q[27] * x99;
  const Real x116 = q[28] * x98;
  const Real x117 = x115 - x116;
  const Real x118 = x108 - x109;
  const Real x119 = x115 + x116;
  const Real x121 = 1.0 - (x101 + x112);
  const Real x127 = v[4] * x111 + v[5] * x118 + v[3] * x104;
  const Real x132 = v[3] * x107 + v[5] * x119 + v[4] * x114;
  const Real x137 = v[3] * x110 + v[4] * x117 + v[5] * x121;
  const Real x138 = v[20] + x127;
  const Real x139 = v[21] + x132;
  const Real x140 = v[22] + x137;
  const Real x144 = v[22] * x132 - v[21] * x137;
  const Real x148 = v[20] * x137 - v[22] * x127;
  const Real x152 = v[21] * x127 - v[20] * x132;
  const Real x153 = v[3] * v[5] * 0.13;
  const Real x154 = v[4] * v[5] * 0.13;
  const Real x155 = (v[3] * v[3] + v[4] * v[4]) * 0.13;
  const Real x162 = x111 * x154 - x118 * x155 + x104 * x153;
  const Real x168 = x107 * x153 - x119 * x155 + x114 * x154;
  const Real x174 = x110 * x153 + x117 * x154 - x121 * x155;
  const Real x178 = x138 * x138;
  const Real x183 = x138 * x139;
  const Real x188 = x139 * x140;
  const Real x189 = x188 - x144;
  const Real x191 = x178 + x139 * x139;
  const Real x193 = x138 * x140;
  const Real x195 = x148 + x193;
  // link 8 "trunk": force that the reference field takes
  const Real x828 = x152 * 0.258367 - x183 * 0.13416599999999995;
  w.x[0] = x828;
  const Real x831 = x144 * 1.818533 - x188 * 1.4260000000000002 - x168 * 5.29;
  w.x[1] = x831;
  const Real x833 = x148 * 1.6843670000000002 + x193 * 1.560166 + x162 * 5.29;
  w.x[2] = x833;
  const Real x836 = x162 * 23.0 + x195 * 5.29;
  w.x[3] = x836;
  const Real x839 = x168 * 23.0 + x189 * 5.29;
  w.x[4] = x839;
  const Real x843 = x174 * 23.0 - x191 * 5.29;
  w.x[5] = x843;
  // joint 8 "left_shoulder": placement, velocity and reference acceleration of its link
  const Real x208 = q[29] * q[29] + q[30] * q[30] + q[31] * q[31];
  const Real x209 = q[32] * q[32] + x208;
  require_length(w, x209, 8);
  const Real x211 = 2.0 * (1 / x209);
  const Real x212 = q[29] * x211;
  const Real x213 = q[30] * x211;
  const Real x214 = q[31] * x211;
  const Real x215 = q[30] * x213;
  const Real x216 = q[31] * x214;
  const Real x218 = 1.0 - (x215 + x216);
  w.x[6] = x218;
  const Real x219 = q[30] * x212;
  const Real x220 = q[32] * x214;
  const Real x221 = x219 - x220;
  w.x[7] = x221;
  const Real x222 = q[31] * x212;
  const Real x223 = q[32] * x213;
  const Real x224 = x222 + x223;
  w.x[8] = x224;
  const Real x225 = x219 + x220;
  w.x[9] = x225;
  const Real x226 = q[29] * x212;
  const Real x228 = 1.0 - (x216 + x226);
  w.x[10] = x228;
  const Real x229 = q[31] * x213;
  const Real x230 = q[32] * x212;
  const Real x231 = x229 - x230;
  w.x[11] = x231;
  const Real x232 = x222 - x223;
  w.x[12] = x232;
  const Real x233 = x229 + x230;
  w.x[13] = x233;
  const Real x235 = 1.0 - (x215 + x226);
  w.x[14] = x235;
  // joint 11 "neck": placement, velocity and reference acceleration of its link
  const Real x348 = q[38] * q[38] + q[39] * q[39] + q[40] * q[40];
  const Real x349 = q[41] * q[41] + x348;
  require_length(w, x349, 11);
  const Real x351 = 2.0 * (1 / x349);
  const Real x352 = q[38] * x351;
  const Real x353 = q[39] * x351;
  const Real x354 = q[40] * x351;
  const Real x355 = q[39] * x353;
  const Real x356 = q[40] * x354;
  const Real x358 = 1.0 - (x355 + x356);
  w.x[15] = x358;
  const Real x359 = q[39] * x352;
  const Real x360 = q[41] * x354;
  const Real x361 = x359 - x360;
  w.x[16] = x361;
  const Real x362 = q[40] * x352;
  const Real x363 = q[41] * x353;
  const Real x364 = x362 + x363;
  w.x[17] = x364;
  const Real x365 = x359 + x360;
  w.x[18] = x365;
  const Real x366 = q[38] * x352;
  const Real x368 = 1.0 - (x356 + x366);
  w.x[19] = x368;
  const Real x369 = q[40] * x353;
  const Real x370 = q[41] * x352;
  const Real x371 = x369 - x370;
  w.x[20] = x371;
  const Real x372 = x362 - x363;
  w.x[21] = x372;
  const Real x373 = x369 + x370;
  w.x[22] = x373;
  const Real x375 = 1.0 - (x355 + x366);
  w.x[23] = x375;
  const Real x381 = x138 * x358 + x139 * x365 + x140 * x372;
  const Real x386 = x138 * x361 + x139 * x368 + x140 * x373;
  const Real x391 = x138 * x364 + x139 * x371 + x140 * x375;
  const Real x392 = v[30] + x381;
  const Real x393 = v[31] + x386;
  const Real x394 = v[32] + x391;
  const Real x399 = x144 * x358 + x148 * x365 + x152 * x372;
  const Real x414 = x399 + v[32] * x386 - v[31] * x391;
  const Real x404 = x144 * x361 + x148 * x368 + x152 * x373;
  const Real x419 = x404 + v[30] * x391 - v[32] * x381;
  const Real x409 = x144 * x364 + x148 * x371 + x152 * x375;
  const Real x424 = x409 + v[31] * x381 - v[30] * x386;
  const Real x426 = x162 + x195 * 0.48;
  const Real x428 = x168 + x189 * 0.48;
  const Real x431 = x174 - x191 * 0.48;
  const Real x436 = x358 * x426 + x365 * x428 + x372 * x431;
  const Real x441 = x361 * x426 + x368 * x428 + x373 * x431;
  const Real x446 = x364 * x426 + x371 * x428 + x375 * x431;
  const Real x451 = x393 * x393;
  const Real x453 = x451 + x394 * x394;
  const Real x455 = x392 * x393;
  const Real x457 = x424 + x455;
  const Real x460 = x393 * x394;
  const Real x461 = x460 - x414;
  const Real x463 = x392 * x392 + x451;
  const Real x465 = x392 * x394;
  // link 12 "head": force that the reference field takes
  const Real x875 = x419 * 0.11613000000000002 + x465 * 0.09555000000000002;
  const Real x868 = x414 * 0.11564000000000002 - x460 * 0.09604000000000003 - x457 * 0.0068600000000000015;
  const Real x886 = x868 - x441 * 0.6860000000000002;
  w.x[24] = x886;
  const Real x876 = x875 - 0.0068600000000000015 * (x453 - x463);
  const Real x891 = x436 * 0.6860000000000002 - x446 * 0.049 + x876;
  w.x[25] = x891;
  const Real x883 = x424 * 0.02009 + x455 * 0.0004900000000000001 + x461 * 0.0068600000000000015;
  const Real x893 = x883 + x441 * 0.049;
  w.x[26] = x893;
  const Real x898 = x436 * 4.9 - x453 * 0.049;
  const Real x899 = (x419 + x465) * 0.6860000000000002 + x898;
  w.x[27] = x899;
  const Real x904 = x441 * 4.9 + x457 * 0.049 + x461 * 0.6860000000000002;
  w.x[28] = x904;
  const Real x909 = x446 * 4.9 - x463 * 0.6860000000000002;
  const Real x910 = (x465 - x419) * 0.049 + x909;
  w.x[29] = x910;
  // joint 12 "right_shoulder": placement, velocity and reference acceleration of its link
  const Real x480 = q[42] * q[42] + q[43] * q[43] + q[44] * q[44];
  const Real x481 = q[45] * q[45] + x480;
  require_length(w, x481, 12);
  const Real x483 = 2.0 * (1 / x481);
  const Real x484 = q[42] * x483;
  const Real x485 = q[43] * x483;
  const Real x486 = q[44] * x483;
  const Real x487 = q[43] * x485;
  const Real x488 = q[44] * x486;
  const Real x490 = 1.0 - (x487 + x488);
  w.x[30] = x490;
  const Real x491 = q[43] * x484;
  const Real x492 = q[45] * x486;
  const Real x493 = x491 - x492;
  w.x[31] = x493;
  const Real x494 = q[44] * x484;
  const Real x495 = q[45] * x485;
  const Real x496 = x494 + x495;
  w.x[32] = x496;
  const Real x497 = x491 + x492;
  w.x[33] = x497;
  const Real x498 = q[42] * x484;
  const Real x500 = 1.0 - (x488 + x498);
  w.x[34] = x500;
  const Real x501 = q[44] * x485;
  const Real x502 = q[45] * x484;
  const Real x503 = x501 - x502;
  w.x[35] = x503;
  const Real x504 = x494 - x495;
  w.x[36] = x504;
  const Real x505 = x501 + x502;
  w.x[37] = x505;
  const Real x507 = 1.0 - (x487 + x498);
  w.x[38] = x507;
  const Real x513 = x138 * x490 + x139 * x497 + x140 * x504;
  const Real x518 = x138 * x493 + x139 * x500 + x140 * x505;
  const Real x523 = x138 * x496 + x139 * x503 + x140 * x507;
  const Real x524 = v[33] + x513;
  const Real x525 = v[34] + x518;
  const Real x526 = v[35] + x523;
  const Real x531 = x144 * x490 + x148 * x497 + x152 * x504;
  const Real x546 = x531 + v[35] * x518 - v[34] * x523;
  const Real x536 = x144 * x493 + x148 * x500 + x152 * x505;
  const Real x551 = x536 + v[33] * x523 - v[35] * x513;
  const Real x541 = x144 * x496 + x148 * x503 + x152 * x507;
  const Real x556 = x541 + v[34] * x513 - v[33] * x518;
  const Real x559 = x162 - (x183 - x152) * 0.2 + x195 * 0.42;
  const Real x560 = x168 + (x178 + x140 * x140) * 0.2;
  const Real x561 = x189 * 0.42 + x560;
  const Real x564 = x174 - (x144 + x188) * 0.2 - x191 * 0.42;
  const Real x569 = x490 * x559 + x497 * x561 + x504 * x564;
  const Real x574 = x493 * x559 + x500 * x561 + x505 * x564;
  const Real x579 = x496 * x559 + x503 * x561 + x507 * x564;
  const Real x593 = x525 * x526;
  const Real x594 = x593 - x546;
  const Real x596 = x524 * x524 + x525 * x525;
  const Real x598 = x524 * x526;
  const Real x600 = x551 + x598;
  // joint 13 "right_elbow": placement, velocity and reference acceleration of its link
  const Real x609 = x526 * cosine[0] + x524 * sine[0];
  const Real x613 = x524 * cosine[0] - x526 * sine[0];
  const Real x614 = x525 + v[36];
  const Real x623 = x556 * cosine[0] + x546 * sine[0] + v[36] * x613;
  const Real x626 = x546 * cosine[0] - x556 * sine[0] - v[36] * x609;
  const Real x630 = x569 - x600 * 0.29;
  const Real x633 = x574 - x594 * 0.29;
  const Real x636 = x579 + x596 * 0.29;
  const Real x639 = cosine[0] * x636 + sine[0] * x630;
  const Real x643 = cosine[0] * x630 - sine[0] * x636;
  const Real x650 = x613 * x613 + x614 * x614;
  const Real x652 = x609 * x613;
  const Real x654 = x551 + x652;
  const Real x662 = x609 * x614;
  const Real x663 = x662 - x626;
  // joint 14 "right_wrist": placement, velocity and reference acceleration of its link
  const Real x677 = q[47] * q[47] + q[48] * q[48] + q[49] * q[49];
  const Real x678 = q[50] * q[50] + x677;
  require_length(w, x678, 14);
  const Real x680 = 2.0 * (1 / x678);
  const Real x681 = q[47] * x680;
  const Real x682 = q[48] * x680;
  const Real x683 = q[49] * x680;
  const Real x684 = q[48] * x682;
  const Real x685 = q[49] * x683;
  const Real x687 = 1.0 - (x684 + x685);
  w.x[39] = x687;
  const Real x688 = q[48] * x681;
  const Real x689 = q[50] * x683;
  const Real x690 = x688 - x689;
  w.x[40] = x690;
  const Real x691 = q[49] * x681;
  const Real x692 = q[50] * x682;
  const Real x693 = x691 + x692;
  w.x[41] = x693;
  const Real x694 = x688 + x689;
  w.x[42] = x694;
  const Real x695 = q[47] * x681;
  const Real x697 = 1.0 - (x685 + x695);
  w.x[43] = x697;
  const Real x698 = q[49] * x682;
  const Real x699 = q[50] * x681;
  const Real x700 = x698 - x699;
  w.x[44] = x700;
  const Real x701 = x691 - x692;
  w.x[45] = x701;
  const Real x702 = x698 + x699;
  w.x[46] = x702;
  const Real x704 = 1.0 - (x684 + x695);
  w.x[47] = x704;
  const Real x710 = x609 * x701 + x614 * x694 + x613 * x687;
  const Real x715 = x609 * x702 + x614 * x697 + x613 * x690;
  const Real x720 = x609 * x704 + x614 * x700 + x613 * x693;
  const Real x721 = v[37] + x710;
  const Real x722 = v[38] + x715;
  const Real x723 = v[39] + x720;
  const Real x728 = x623 * x701 + x551 * x694 + x626 * x687;
  const Real x743 = v[39] * x715 - v[38] * x720 + x728;
  const Real x733 = x623 * x702 + x551 * x697 + x626 * x690;
  const Real x748 = v[37] * x720 - v[39] * x710 + x733;
  const Real x738 = x623 * x704 + x551 * x700 + x626 * x693;
  const Real x757 = x639 + x650 * 0.26;
  const Real x760 = x643 - x654 * 0.26;
  const Real x763 = x633 - x663 * 0.26;
  const Real x768 = x701 * x757 + x687 * x760 + x694 * x763;
  const Real x773 = x702 * x757 + x690 * x760 + x697 * x763;
  const Real x792 = x722 * x723;
  const Real x797 = x721 * x723;
  // link 15 "right_hand": force that the reference field takes
  const Real x1010 = (v[38] * x710 - v[37] * x715 + x738) * 0.0002555;
  // joint 14 "right_wrist": placement, velocity and reference acceleration of its link
  const Real x778 = x704 * x757 + x693 * x760 + x700 * x763;
  // link 15 "right_hand": force that the reference field takes
  const Real x1032 = (x721 * x721 + x722 * x722) * 0.0336;
  const Real x1034 = 0.42 * x778 + x1032;
  const Real x1019 = x743 * 0.0039235 - x792 * 0.0034755000000000003 + x773 * 0.0336;
  const Real x1022 = x748 * 0.003731 + x797 * 0.0036680000000000003 - x768 * 0.0336;
  // joint 14 "right_wrist": articulated-body inertia and bias force through it
  const Real x1044 = 254.87447432139672 * (tau[37] - x1019);
  w.x[48] = x1044;
  const Real x1045 = 268.0246582685607 * (tau[38] - x1022);
  w.x[49] = x1045;
  const Real x1046 = 3913.894324853229 * (tau[39] - (x1010 - x721 * x722 * 0.00019249999999999996));
  w.x[50] = x1046;
  // link 15 "right_hand": force that the reference field takes
  const Real x1026 = 0.42 * x768 - (x748 + x797) * 0.0336;
  // joint 14 "right_wrist": articulated-body inertia and bias force through it
  const Real x1057 = x1026 - 0.0336 * x1045;
  // link 15 "right_hand": force that the reference field takes
  const Real x1030 = 0.42 * x773 - (x792 - x743) * 0.0336;
  // joint 14 "right_wrist": articulated-body inertia and bias force through it
  const Real x1059 = x1030 + 0.0336 * x1044;
  const Real x1060 = x701 * 0.1174108818011257;
  const Real x1061 = x702 * 0.13225691347011598;
  const Real x1062 = 0.42 * x704;
  const Real x1063 = x687 * 0.1174108818011257;
  const Real x1064 = x690 * 0.13225691347011598;
  const Real x1065 = 0.42 * x693;
  const Real x1078 = x687 * x1060 + x690 * x1061 + x693 * x1062;
  const Real x1083 = x694 * x1060 + x697 * x1061 + x700 * x1062;
  const Real x1088 = x690 * x1064 + x693 * x1065 + x687 * x1063;
  const Real x1093 = x697 * x1064 + x700 * x1065 + x694 * x1063;
  const Real x1097 = x694 * (x694 * 0.1174108818011257) + x700 * (0.42 * x700);
  const Real x1098 = x697 * (x697 * 0.13225691347011598) + x1097;
  const Real x1101 = 0.26 * x1078;
  const Real x1103 = 0.26 * x1093;
  const Real x1105 = 0.26 * x1088;
  const Real x1107 = 0.26 * x1098;
  const Real x1111 = 0.26 * x1103;
  const Real x1139 = x687 * x1057 + x693 * x1034 + x690 * x1059;
  const Real x1144 = x694 * x1057 + x700 * x1034 + x697 * x1059;
  const Real x1124 = x690 * tau[38] + x693 * tau[39] + x687 * tau[37];
  const Real x1129 = x694 * tau[37] + x700 * tau[39] + x697 * tau[38];
  const Real x1153 = 0.02190604 + 0.26 * x1105;
  require_more(w, x1153, 0.0, kFactorization, 13);
  const Real x1154 = -0.132 - x1105;
  const Real x1073 = x701 * x1060 + x702 * x1061 + x704 * x1062;
  const Real x1119 = x701 * tau[37] + x702 * tau[38] + x704 * tau[39];
  const Real x1158 = x623 * 0.00067375 + x1119;
  // link 14 "right_forearm": force that the reference field takes
  const Real x973 = x626 * 0.02190604 - x662 * 0.02123229 + x633 * 0.132;
  const Real x976 = x551 * 0.02190604 + x652 * 0.02123229 - x643 * 0.132;
  // joint 14 "right_wrist": articulated-body inertia and bias force through it
  const Real x1134 = x701 * x1057 + x704 * x1034 + x702 * x1059;
  // joint 13 "right_elbow": articulated-body inertia and bias force through it
  const Real x1165 = 1 / x1153;
  const Real x1167 = x1165 * (tau[36] - (x1129 - 0.26 * x1139 + x976));
  w.x[51] = x1167;
  const Real x1168 = x1111 * x1165;
  w.x[52] = x1168;
  const Real x1170 = x1101 * x1165;
  w.x[53] = x1170;
  const Real x1172 = x1154 * x1165;
  w.x[54] = x1172;
  const Real x1173 = x1103 * x1165;
  w.x[55] = x1173;
  const Real x1177 = 0.02190604 + 0.26 * x1107 - x1111 * x1168;
  const Real x1180 = 0.26 * x1083 - x1111 * x1170;
  const Real x1183 = x1103 + x1111 * x1172;
  const Real x1186 = 0.132 + x1107 - x1111 * x1173;
  const Real x1189 = 1.1 + x1073 - x1101 * x1170;
  const Real x1192 = x1078 + x1101 * x1172;
  const Real x1195 = x1083 - x1101 * x1173;
  const Real x1198 = 1.1 + x1088 - x1154 * x1172;
  const Real x1201 = x1093 + x1154 * x1173;
  const Real x1204 = 1.1 + x1098 - x1103 * x1173;
  const Real x1207 = x1124 + 0.26 * x1144 + x973 - x1111 * x1167;
  // joint 14 "right_wrist": articulated-body inertia and bias force through it
  const Real x1161 = x639 * 1.1 + x650 * 0.132 + x1134;
  // joint 13 "right_elbow": articulated-body inertia and bias force through it
  const Real x1210 = x1161 - x1101 * x1167;
  // joint 14 "right_wrist": articulated-body inertia and bias force through it
  const Real x1162 = x643 * 1.1 - x654 * 0.132 + x1139;
  // joint 13 "right_elbow": articulated-body inertia and bias force through it
  const Real x1212 = x1162 + x1154 * x1167;
  // joint 14 "right_wrist": articulated-body inertia and bias force through it
  const Real x1163 = x633 * 1.1 - x663 * 0.132 + x1144;
  // joint 13 "right_elbow": articulated-body inertia and bias force through it
  const Real x1215 = x1163 - x1103 * x1167;
  const Real x1216 = sine[0] * x1186;
  const Real x1218 = cosine[0] * x1186;
  const Real x1224 = cosine[0] * x1183 + sine[0] * x1180;
  const Real x1226 = sine[0] * x1224;
  const Real x1229 = cosine[0] * x1224;
  const Real x1231 = x1183 - x1229;
  const Real x1233 = cosine[0] * (0.00067375 - x1177);
  const Real x1238 = cosine[0] * x1233;
  const Real x1244 = cosine[0] * x1195 - sine[0] * x1201;
  const Real x1247 = sine[0] * x1195 + cosine[0] * x1201;
  const Real x1252 = cosine[0] * (x1189 - x1198) - x1192 * (2.0 * sine[0]);
  const Real x1255 = x1192 + sine[0] * x1252;
  const Real x1256 = cosine[0] * x1252;
  const Real x1258 = x1189 - x1256;
  const Real x1259 = 0.29 * x1247;
  const Real x1261 = x1229 + x1259;
  const Real x1262 = 0.29 * x1258;
  const Real x1266 = x1218 + 0.29 * x1204;
  const Real x1269 = x1180 - x1226 + 0.29 * x1244;
  const Real x1270 = 0.29 * x1255;
  const Real x1278 = 0.29 * x1261;
  const Real x1282 = sine[0] * x1233 - 0.29 * x1216;
  const Real x1300 = sine[0] * x1210 + cosine[0] * x1212;
  const Real x1277 = 0.00067375 - x1238 + (0.29 * x1218 + 0.29 * x1266);
  const Real x1307 = 0.050615200000000006 + x1277;
  require_more(w, x1307, 0.0, kFactorization, 12);
  const Real x1308 = 0.266 + x1266;
  const Real x1309 = 0.050615200000000006 + 0.29 * x1262;
  const Real x1310 = -0.266 - x1262;
  const Real x1311 = x1177 + x1238 + 0.00192375;
  // link 13 "right_upper_arm": force that the reference field takes
  const Real x934 = x546 * 0.050615200000000006 - x593 * 0.048691450000000004 + x574 * 0.266;
  // joint 13 "right_elbow": articulated-body inertia and bias force through it
  const Real x1303 = sine[0] * x1158 + cosine[0] * x1207 + 0.29 * x1215;
  // link 13 "right_upper_arm": force that the reference field takes
  const Real x937 = x551 * 0.050615200000000006 + x598 * 0.048691450000000004 - x569 * 0.266;
  const Real x949 = x579 * 1.9 + x596 * 0.266;
  // joint 12 "right_shoulder": articulated-body inertia and bias force through it
  const Real x1324 = 1 / x1307;
  const Real x1325 = x1278 * x1324;
  const Real x1327 = x1282 * x1324;
  const Real x1330 = x1309 - x1278 * x1325;
  const Real x1333 = 0.29 * x1226 + x1282 * x1325;
  const Real x1334 = 1 / x1330;
  const Real x1335 = x1333 * x1334;
  const Real x1341 = x1311 - x1282 * x1327 - x1333 * x1335;
  const Real x1342 = 1 / x1341;
  const Real x1344 = x1309 * 1.7763568394002505e-15;
  require_more(w, x1330, x1344, kFactorization, 12);
  const Real x1345 = x1311 * 1.7763568394002505e-15;
  require_more(w, x1341, x1345, kFactorization, 12);
  const Real x1346 = tau[33] - (x934 + x1303);
  // joint 13 "right_elbow": articulated-body inertia and bias force through it
  const Real x1317 = cosine[0] * x1158 - sine[0] * x1207 + x556 * 0.00192375;
  // joint 12 "right_shoulder": articulated-body inertia and bias force through it
  const Real x1347 = tau[34] - (tau[36] - 0.29 * x1300 + x937);
  const Real x1351 = x1347 + x1325 * x1346;
  const Real x1357 = tau[35] - x1317 - x1327 * x1346 - x1335 * x1351;
  const Real x1360 = x1342 * x1357;
  w.x[56] = x1360;
  const Real x1363 = x1334 * x1351 - x1335 * x1360;
  w.x[57] = x1363;
  const Real x1369 = x1324 * x1346 - x1327 * x1360 + x1325 * x1363;
  w.x[58] = x1369;
  const Real x1372 = x1310 + x1261 * x1325;
  const Real x1375 = x1308 * x1325 - x1259;
  const Real x1378 = x1269 * x1325 - x1270;
  const Real x1385 = x1226 + x1261 * x1327 + x1335 * x1372;
  const Real x1393 = x1216 + x1308 * x1327 + x1335 * x1375;
  const Real x1400 = x1231 - x1269 * x1327 - x1335 * x1378;
  const Real x1401 = x1261 * x1324;
  const Real x1402 = x1308 * x1324;
  const Real x1403 = x1269 * x1324;
  const Real x1404 = x1334 * x1372;
  const Real x1405 = x1334 * x1375;
  const Real x1406 = x1334 * x1378;
  const Real x1407 = x1342 * x1385;
  w.x[59] = x1407;
  const Real x1409 = x1342 * x1393;
  w.x[60] = x1409;
  const Real x1411 = x1342 * x1400;
  w.x[61] = x1411;
  const Real x1414 = x1404 + x1335 * x1407;
  w.x[62] = x1414;
  const Real x1417 = x1405 + x1335 * x1409;
  w.x[63] = x1417;
  const Real x1420 = x1406 - x1335 * x1411;
  w.x[64] = x1420;
  const Real x1426 = x1401 + x1327 * x1407 + x1325 * x1414;
  w.x[65] = x1426;
  const Real x1432 = x1402 + x1327 * x1409 + x1325 * x1417;
  w.x[66] = x1432;
  const Real x1438 = x1403 - x1327 * x1411 + x1325 * x1420;
  w.x[67] = x1438;
  const Real x1446 = 1.9 + x1258 - x1261 * x1401 - x1372 * x1404;
  const Real x1447 = x1446 - x1385 * x1407;
  w.x[68] = x1447;
  const Real x1455 = x1247 - x1261 * x1402 - x1372 * x1405;
  const Real x1456 = x1455 - x1385 * x1409;
  w.x[69] = x1456;
  const Real x1464 = x1255 - x1261 * x1403 - x1372 * x1406;
  const Real x1465 = x1385 * x1411 + x1464;
  w.x[70] = x1465;
  const Real x1473 = 1.9 + x1204 - x1308 * x1402 - x1375 * x1405;
  const Real x1474 = x1473 - x1393 * x1409;
  w.x[71] = x1474;
  const Real x1482 = x1244 - x1308 * x1403 - x1375 * x1406;
  const Real x1483 = x1393 * x1411 + x1482;
  w.x[72] = x1483;
  const Real x1490 = x1198 + x1256 + 1.9 - x1269 * x1403;
  const Real x1492 = x1490 - x1378 * x1406 - x1400 * x1411;
  w.x[73] = x1492;
  // joint 13 "right_elbow": articulated-body inertia and bias force through it
  const Real x1318 = x569 * 1.9 - x600 * 0.266 + x1300;
  // joint 12 "right_shoulder": articulated-body inertia and bias force through it
  const Real x1498 = x1318 - x1226 * x1360 + x1310 * x1363;
  const Real x1499 = x1261 * x1369 + x1498;
  w.x[74] = x1499;
  // joint 13 "right_elbow": articulated-body inertia and bias force through it
  const Real x1319 = x574 * 1.9 - x594 * 0.266 + x1215;
  // joint 12 "right_shoulder": articulated-body inertia and bias force through it
  const Real x1506 = x1319 - x1216 * x1360 - x1259 * x1363;
  const Real x1507 = x1308 * x1369 + x1506;
  w.x[75] = x1507;
  // joint 13 "right_elbow": articulated-body inertia and bias force through it
  const Real x1320 = cosine[0] * x1210 - sine[0] * x1212 + x949;
  // joint 12 "right_shoulder": articulated-body inertia and bias force through it
  const Real x1513 = x1320 + x1231 * x1360 - x1270 * x1363;
  const Real x1514 = x1269 * x1369 + x1513;
  w.x[76] = x1514;
  const Real x1519 = x490 * x1447 + x493 * x1456 + x496 * x1465;
  w.x[77] = x1519;
  const Real x1524 = x490 * x1456 + x493 * x1474 + x496 * x1483;
  w.x[78] = x1524;
  const Real x1529 = x490 * x1465 + x493 * x1483 + x496 * x1492;
  w.x[79] = x1529;
  const Real x1534 = x497 * x1447 + x500 * x1456 + x503 * x1465;
  w.x[80] = x1534;
  const Real x1539 = x497 * x1456 + x500 * x1474 + x503 * x1483;
  w.x[81] = x1539;
  const Real x1540 = x497 * x1465;
  w.x[82] = x1540;
}

ADAGEN_NOINLINE void part_2_1(Workspace& w) {
  ADAGEN_INPUTS
  const Real x358 = w.x[15];
  const Real x361 = w.x[16];
  const Real x364 = w.x[17];
  const Real x365 = w.x[18];
  const Real x368 = w.x[19];
  const Real x371 = w.x[20];
  const Real x372 = w.x[21];
  const Real x373 = w.x[22];
  const Real x375 = w.x[23];
  const Real x490 = w.x[30];
  const Real x493 = w.x[31];
  const Real x496 = w.x[32];
  const Real x497 = w.x[33];
  const Real x500 = w.x[34];
  const Real x503 = w.x[35];
  const Real x504 = w.x[36];
  const Real x505 = w.x[37];
  const Real x507 = w.x[38];
  const Real x828 = w.x[0];
  const Real x831 = w.x[1];
  const Real x833 = w.x[2];
  const Real x836 = w.x[3];
  const Real x839 = w.x[4];
  const Real x843 = w.x[5];
  const Real x886 = w.x[24];
  const Real x891 = w.x[25];
  const Real x893 = w.x[26];
  const Real x899 = w.x[27];
  const Real x904 = w.x[28];
  const Real x910 = w.x[29];
  const Real x1447 = w.x[68];
  const Real x1456 = w.x[69];
  const Real x1465 = w.x[70];
  const Real x1474 = w.x[71];
  const Real x1483 = w.x[72];
  const Real x1492 = w.x[73];
  const Real x1499 = w.x[74];
  const Real x1507 = w.x[75];
  const Real x1514 = w.x[76];
  const Real x1519 = w.x[77];
  const Real x1524 = w.x[78];
  const Real x1529 = w.x[79];
  const Real x1534 = w.x[80];
  const Real x1539 = w.x[81];
  const Real x1540 = w.x[82];
  // joint 12 "right_shoulder": articulated-body inertia and bias force through it
  const Real x1544 = x1540 + x500 * x1483 + x503 * x1492;
  const Real x1564 = x490 * x1519 + x493 * x1524 + x496 * x1529;
  const Real x1569 = x497 * x1519 + x500 * x1524 + x503 * x1529;
  const Real x1574 = x504 * x1519 + x505 * x1524 + x507 * x1529;
  const Real x1579 = x497 * x1534 + x500 * x1539 + x503 * x1544;
  const Real x1584 = x504 * x1534 + x505 * x1539 + x507 * x1544;
  const Real x1549 = x504 * x1447 + x505 * x1456 + x507 * x1465;
  const Real x1554 = x504 * x1456 + x505 * x1474 + x507 * x1483;
  const Real x1559 = x504 * x1465 + x505 * x1483 + x507 * x1492;
  const Real x1589 = x504 * x1549 + x505 * x1554 + x507 * x1559;
  const Real x1590 = 0.2 * x1574;
  const Real x1592 = 0.42 * x1569;
  const Real x1594 = x1590 + x1592;
  const Real x1596 = 0.42 * x1564;
  const Real x1597 = 0.2 * x1564;
  const Real x1603 = 0.2 * x1584 + 0.42 * x1579;
  const Real x1611 = 0.2 * x1589 + 0.42 * x1584;
  const Real x1621 = 0.2 * x1594;
  const Real x1647 = x490 * x1499 + x493 * x1507 + x496 * x1514;
  const Real x1652 = x497 * x1499 + x500 * x1507 + x503 * x1514;
  const Real x1657 = x504 * x1499 + x505 * x1507 + x507 * x1514;
  const Real x1632 = x493 * tau[34] + x496 * tau[35] + x490 * tau[33];
  const Real x1637 = x497 * tau[33] + x503 * tau[35] + x500 * tau[34];
  const Real x1642 = x504 * tau[33] + x505 * tau[34] + x507 * tau[35];
  const Real x1673 = 0.258367 + 0.2 * x1597;
  // joint 11 "neck": articulated-body inertia and bias force through it
  const Real x1694 = tau[30] - x886;
  const Real x1702 = 8.611039352449838 * (tau[31] - x891);
  w.x[83] = x1702;
  const Real x1703 = 50.80513217945406 * (tau[32] - x893 + x1694 * 0.059322033898305086);
  w.x[84] = x1703;
  const Real x1706 = 8.6475268073331 * x1694 + 0.059322033898305086 * x1703;
  w.x[85] = x1706;
  const Real x1732 = x899 + 0.6860000000000002 * x1702;
  const Real x1737 = x904 + 0.049 * x1703 - 0.6860000000000002 * x1706;
  const Real x1740 = x910 - 0.049 * x1702;
  const Real x1743 = x358 * 0.8476793248945146 + x364 * 0.28945147679324895;
  const Real x1744 = x361 * 0.8270042194092826;
  const Real x1747 = x358 * 0.28945147679324895 + x364 * 4.8793248945147685;
  const Real x1750 = x365 * 0.8476793248945146 + x371 * 0.28945147679324895;
  const Real x1751 = x368 * 0.8270042194092826;
  const Real x1754 = x365 * 0.28945147679324895 + x371 * 4.8793248945147685;
  const Real x1766 = x358 * x1743 + x361 * x1744 + x364 * x1747;
  const Real x1771 = x365 * x1743 + x368 * x1744 + x371 * x1747;
  const Real x1776 = x372 * x1743 + x373 * x1744 + x375 * x1747;
  const Real x1781 = x365 * x1750 + x368 * x1751 + x371 * x1754;
  const Real x1786 = x372 * x1750 + x373 * x1751 + x375 * x1754;
  const Real x1787 = x372 * (x372 * 0.8476793248945146 + x375 * 0.28945147679324895);
  const Real x1789 = x375 * (x372 * 0.28945147679324895 + x375 * 4.8793248945147685);
  const Real x1792 = 0.48 * x1771;
  const Real x1794 = 0.48 * x1766;
  const Real x1795 = 0.48 * x1781;
  const Real x1824 = x358 * x1732 + x364 * x1740 + x361 * x1737;
  const Real x1829 = x365 * x1732 + x371 * x1740 + x368 * x1737;
  const Real x1809 = x361 * tau[31] + x364 * tau[32] + x358 * tau[30];
  const Real x1814 = x365 * tau[30] + x371 * tau[32] + x368 * tau[31];
  // joint 12 "right_shoulder": articulated-body inertia and bias force through it
  const Real x1669 = 0.2 * x1611 + 0.42 * x1603 + 1.818533;
  // joint 11 "neck": articulated-body inertia and bias force through it
  const Real x1840 = x1669 + 0.48 * x1795;
  require_more(w, x1840, 0.0, kFactorization, 7);
  const Real x1841 = 0.42 * x1594 + 0.48 * x1792;
  const Real x1843 = x1594 + x1792;
  const Real x1845 = -5.29 - x1603 - x1795;
  const Real x1846 = x1611 + 0.48 * x1786;
  const Real x1848 = 1.6843670000000002 + 0.42 * x1596 + 0.48 * x1794;
  const Real x1852 = 23.0 + x1564 + x1766;
  const Real x1855 = 23.0 + x1579 + x1781;
  const Real x1791 = x1787 + x373 * (x373 * 0.8270042194092826) + x1789;
  const Real x1857 = 23.0 + x1589 + x1791;
  // joint 12 "right_shoulder": articulated-body inertia and bias force through it
  const Real x1677 = x1632 - 0.2 * x1657 - 0.42 * x1652 + x831;
  // joint 11 "neck": articulated-body inertia and bias force through it
  const Real x1858 = x1809 - 0.48 * x1829 + x1677;
  // joint 12 "right_shoulder": articulated-body inertia and bias force through it
  const Real x1678 = x1637 + 0.42 * x1647 + x833;
  // joint 11 "neck": articulated-body inertia and bias force through it
  const Real x1859 = x1814 + 0.48 * x1824 + x1678;
  const Real x1819 = x372 * tau[30] + x373 * tau[31] + x375 * tau[32];
  const Real x1860 = x1642 + 0.2 * x1647 + x828 + x1819;
  const Real x1861 = x836 + x1647 + x1824;
  const Real x1862 = x839 + x1652 + x1829;
  const Real x1834 = x372 * x1732 + x375 * x1740 + x373 * x1737;
  const Real x1863 = x843 + x1657 + x1834;
  // link 8 "trunk": mobility from its articulated-body inertia
  const Real x1864 = 1 / x1840;
  const Real x1865 = x1841 * x1864;
  const Real x1867 = x1621 * x1864;
  const Real x1869 = x1843 * x1864;
  const Real x1871 = x1845 * x1864;
  const Real x1872 = x1846 * x1864;
  const Real x1876 = x1848 - x1841 * x1865;
  const Real x1879 = 0.2 * x1596 - x1621 * x1865;
  const Real x1882 = 5.29 + x1596 + x1794 - x1843 * x1865;
  const Real x1885 = x1592 + x1792 + x1845 * x1865;
  const Real x1888 = 0.42 * x1574 + 0.48 * x1776 - x1846 * x1865;
  const Real x1889 = 1 / x1876;
  const Real x1890 = x1879 * x1889;
  const Real x1891 = x1882 * x1889;
  const Real x1892 = x1885 * x1889;
  const Real x1893 = x1888 * x1889;
  const Real x1899 = x1673 - x1621 * x1867 - x1879 * x1890;
  const Real x1905 = x1597 - x1843 * x1867 - x1882 * x1890;
  const Real x1911 = 0.2 * x1569 + x1845 * x1867 - x1885 * x1890;
  const Real x1917 = x1590 - x1846 * x1867 - x1888 * x1890;
  const Real x1918 = 1 / x1899;
  const Real x1919 = x1905 * x1918;
  const Real x1920 = x1911 * x1918;
  const Real x1921 = x1917 * x1918;
  const Real x1929 = x1852 - x1843 * x1869 - x1882 * x1891;
  const Real x1930 = x1929 - x1905 * x1919;
  const Real x1938 = x1569 + x1771 + x1845 * x1869 - x1885 * x1891;
  const Real x1939 = x1938 - x1911 * x1919;
  const Real x1947 = x1574 + x1776 - x1846 * x1869 - x1888 * x1891;
  const Real x1948 = x1947 - x1917 * x1919;
  const Real x1949 = 1 / x1930;
  const Real x1950 = x1939 * x1949;
  const Real x1951 = x1948 * x1949;
  const Real x1961 = x1855 - x1845 * x1871 - x1885 * x1892;
  const Real x1963 = x1961 - x1911 * x1920 - x1939 * x1950;
  const Real x1973 = x1584 + x1786 + x1846 * x1871 - x1888 * x1892;
  const Real x1975 = x1973 - x1917 * x1920 - x1948 * x1950;
  const Real x1976 = 1 / x1963;
  const Real x1977 = x1975 * x1976;
  const Real x1989 = x1857 - x1846 * x1872 - x1888 * x1893;
  const Real x1991 = x1989 - x1917 * x1921 - x1948 * x1951;
  const Real x1992 = x1991 - x1975 * x1977;
  const Real x1993 = 1 / x1992;
  w.x[86] = x1993;
  const Real x1994 = 1.7763568394002505e-15 * x1848;
  require_more(w, x1876, x1994, kFactorization, 7);
  const Real x1995 = 1.7763568394002505e-15 * x1673;
  require_more(w, x1899, x1995, kFactorization, 7);
  const Real x1996 = 1.7763568394002505e-15 * x1852;
  require_more(w, x1930, x1996, kFactorization, 7);
  const Real x1997 = 1.7763568394002505e-15 * x1855;
  require_more(w, x1963, x1997, kFactorization, 7);
  const Real x1998 = 1.7763568394002505e-15 * x1857;
  require_more(w, x1992, x1998, kFactorization, 7);
  const Real x2001 = x1867 - x1865 * x1890;
  const Real x2008 = x1869 - x1865 * x1891 - x1919 * x2001;
  const Real x2012 = x1890 * x1919 - x1891;
  const Real x2023 = x1871 + x1865 * x1892 + x1920 * x2001;
  const Real x2025 = x1950 * x2008 + x2023;
  const Real x2033 = x1890 * x1920 - x1892 - x1950 * x2012;
  const Real x2037 = x1919 * x1950 - x1920;
  const Real x2048 = x1872 - x1865 * x1893 - x1921 * x2001;
  const Real x2050 = x2048 - x1951 * x2008 + x1977 * x2025;
  const Real x2059 = x1890 * x1921 - x1893 - x1951 * x2012;
  const Real x2060 = x2059 - x1977 * x2033;
  const Real x2067 = x1919 * x1951 - x1921 - x1977 * x2037;
  const Real x2071 = x1950 * x1977 - x1951;
  const Real x2073 = x1865 * x1889;
  const Real x2074 = x1918 * x2001;
  const Real x2075 = x1890 * x1918;
  const Real x2077 = x1949 * x2008;
  const Real x2078 = x1949 * x2012;
  const Real x2079 = x1919 * x1949;
  const Real x2081 = x1976 * x2025;
  const Real x2083 = x1976 * x2033;
  const Real x2084 = x1976 * x2037;
  const Real x2085 = x1950 * x1976;
  const Real x2087 = x1993 * x2050;
  w.x[87] = x2087;
  const Real x2088 = x1993 * x2060;
  w.x[88] = x2088;
  const Real x2089 = x1993 * x2067;
  w.x[89] = x2089;
  const Real x2090 = x1993 * x2071;
  w.x[90] = x2090;
  const Real x2091 = x1977 * x1993;
  w.x[91] = x2091;
  const Real x2100 = x1864 + x1865 * x2073 + x2001 * x2074;
  const Real x2102 = x2008 * x2077 + x2100 + x2025 * x2081;
  const Real x2103 = x2050 * x2087 + x2102;
  w.x[92] = x2103;
  const Real x2111 = x2073 - x2001 * x2075 + x2008 * x2078;
  const Real x2113 = x2111 - x2025 * x2083 + x2050 * x2088;
  w.x[93] = x2113;
  const Real x2120 = x2074 - x2008 * x2079 - x2025 * x2084;
  const Real x2121 = x2050 * x2089 + x2120;
  w.x[94] = x2121;
  const Real x2126 = x2077 + x2025 * x2085 + x2050 * x2090;
  w.x[95] = x2126;
  const Real x2129 = x2081 + x2050 * x2091;
  w.x[96] = x2129;
  const Real x2137 = x1889 + x1890 * x2075 + x2012 * x2078;
  const Real x2139 = x2033 * x2083 + x2137 + x2060 * x2088;
  w.x[97] = x2139;
  const Real x2146 = x2033 * x2084 - (x2075 + x2012 * x2079);
  const Real x2147 = x2060 * x2089 + x2146;
  w.x[98] = x2147;
  const Real x2152 = x2078 - x2033 * x2085 + x2060 * x2090;
  w.x[99] = x2152;
  const Real x2155 = x2083 - x2060 * x2091;
  w.x[100] = x2155;
  const Real x2161 = x1918 + x1919 * x2079 + x2037 * x2084;
  const Real x2162 = x2067 * x2089 + x2161;
  w.x[101] = x2162;
  const Real x2168 = x2067 * x2090 - (x2079 + x2037 * x2085);
  w.x[102] = x2168;
  const Real x2171 = x2084 - x2067 * x2091;
  w.x[103] = x2171;
  const Real x2176 = x1949 + x1950 * x2085 + x2071 * x2090;
  w.x[104] = x2176;
  const Real x2179 = x2085 + x2071 * x2091;
  w.x[105] = x2179;
  const Real x2183 = x1976 + x1977 * x2091;
  w.x[106] = x2183;
  const Real x2192 = x1858 * x2103 + x1863 * x2087 + x1859 * x2113;
  const Real x2194 = x1860 * x2121 + x2192 + x1861 * x2126;
  const Real x2195 = x2194 - x1862 * x2129;
  w.x[107] = x2195;
  const Real x2203 = x1858 * x2113 + x1863 * x2088 + x1859 * x2139;
  const Real x2205 = x1860 * x2147 + x2203 + x1861 * x2152;
  const Real x2206 = x1862 * x2155 + x2205;
  w.x[108] = x2206;
  const Real x2214 = x1858 * x2121 + x1863 * x2089 + x1859 * x2147;
  const Real x2216 = x1860 * x2162 + x2214 + x1861 * x2168;
  const Real x2217 = x1862 * x2171 + x2216;
  w.x[109] = x2217;
  const Real x2226 = x1858 * x2126 + x1863 * x2090 + x1859 * x2152;
  const Real x2228 = x1860 * x2168 + x2226 + x1861 * x2176;
  const Real x2229 = x2228 - x1862 * x2179;
  w.x[110] = x2229;
  const Real x2241 = x1859 * x2155 - (x1858 * x2129 + x1863 * x2091);
  const Real x2243 = x1860 * x2171 + x2241 - x1861 * x2179;
  const Real x2244 = x1862 * x2183 + x2243;
  w.x[111] = x2244;
  const Real x2253 = x1858 * x2087 + x1863 * x1993 + x1859 * x2088;
  const Real x2255 = x1860 * x2089 + x2253 + x1861 * x2090;
  const Real x2256 = x2255 - x1862 * x2091;
  w.x[112] = x2256;
}

ADAGEN_NOINLINE void part_2_2(Workspace& w) {
  ADAGEN_INPUTS
  const Real x218 = w.x[6];
  const Real x221 = w.x[7];
  const Real x224 = w.x[8];
  const Real x225 = w.x[9];
  const Real x228 = w.x[10];
  const Real x231 = w.x[11];
  const Real x232 = w.x[12];
  const Real x233 = w.x[13];
  const Real x235 = w.x[14];
  const Real x1993 = w.x[86];
  const Real x2087 = w.x[87];
  const Real x2088 = w.x[88];
  const Real x2089 = w.x[89];
  const Real x2090 = w.x[90];
  const Real x2091 = w.x[91];
  const Real x2103 = w.x[92];
  const Real x2113 = w.x[93];
  const Real x2121 = w.x[94];
  const Real x2126 = w.x[95];
  const Real x2129 = w.x[96];
  const Real x2139 = w.x[97];
  const Real x2147 = w.x[98];
  const Real x2152 = w.x[99];
  const Real x2155 = w.x[100];
  const Real x2162 = w.x[101];
  const Real x2168 = w.x[102];
  const Real x2171 = w.x[103];
  const Real x2176 = w.x[104];
  const Real x2179 = w.x[105];
  const Real x2183 = w.x[106];
  const Real x2195 = w.x[107];
  const Real x2206 = w.x[108];
  const Real x2217 = w.x[109];
  const Real x2229 = w.x[110];
  const Real x2244 = w.x[111];
  const Real x2256 = w.x[112];
  // message received
  const Real x2278 = w.from[1][15];
  const Real x2279 = w.from[1][16];
  const Real x2281 = w.from[1][18];
  const Real x2280 = w.from[1][17];
  const Real x2282 = w.from[1][19];
  const Real x2266 = w.from[1][3];
  const Real x2271 = w.from[1][8];
  const Real x2267 = w.from[1][4];
  const Real x2272 = w.from[1][9];
  const Real x2275 = w.from[1][12];
  const Real x2283 = w.from[1][20];
  const Real x2268 = w.from[1][5];
  const Real x2273 = w.from[1][10];
  const Real x2276 = w.from[1][13];
  const Real x2277 = w.from[1][14];
  const Real x2287 = w.from[1][24];
  const Real x2288 = w.from[1][25];
  const Real x2289 = w.from[1][26];
  const Real x2263 = w.from[1][0];
  w.x[82] = x2263;
  const Real x2264 = w.from[1][1];
  w.x[81] = x2264;
  const Real x2265 = w.from[1][2];
  w.x[80] = x2265;
  const Real x2269 = w.from[1][6];
  w.x[79] = x2269;
  const Real x2270 = w.from[1][7];
  w.x[78] = x2270;
  const Real x2274 = w.from[1][11];
  w.x[77] = x2274;
  const Real x2284 = w.from[1][21];
  w.x[76] = x2284;
  const Real x2285 = w.from[1][22];
  w.x[75] = x2285;
  const Real x2286 = w.from[1][23];
  w.x[74] = x2286;
  // joint 8 "left_shoulder": assembly: its two sides become one chain
  const Real x2368 = x2091 + 0.42 * x2087;
  const Real x2376 = x1993 + 0.2 * x2087;
  const Real x2294 = 0.2 * x2121;
  const Real x2296 = 0.42 * x2113;
  const Real x2302 = x2129 + 0.42 * x2103;
  const Real x2306 = x2087 + 0.2 * x2103;
  const Real x2362 = x2183 + 0.42 * x2129;
  const Real x2356 = x2090 - 0.2 * x2089 + 0.42 * x2088;
  const Real x2299 = x2126 - x2294 + x2296;
  const Real x2322 = x2168 - 0.2 * x2162 + 0.42 * x2147;
  const Real x2312 = x2152 - 0.2 * x2147 + 0.42 * x2139;
  const Real x2336 = x2176 - 0.2 * x2168 + 0.42 * x2152;
  const Real x2347 = 0.42 * x2155 - (x2179 + 0.2 * x2171);
  const Real x2313 = x2155 - x2296;
  const Real x2363 = 0.42 * x2302 + x2362;
  const Real x2370 = 0.2 * x2302 + x2368;
  const Real x2377 = 0.2 * x2306 + x2376;
  const Real x2316 = x2088 + 0.2 * x2113;
  const Real x2326 = x2089 + x2294;
  const Real x2325 = x2171 - 0.42 * x2121;
  const Real x2348 = x2347 - 0.42 * x2299;
  const Real x2357 = 0.2 * x2299 + x2356;
  const Real x2338 = x2336 - 0.2 * x2322 + 0.42 * x2312;
  const Real x2556 = x225 * x2363 - x232 * x2370 + x218 * x2348;
  const Real x2562 = x232 * x2377 - x225 * x2370 + x218 * x2357;
  const Real x2385 = x225 * x2313;
  const Real x2573 = x228 * x2363 - x233 * x2370 + x221 * x2348;
  const Real x2579 = x233 * x2377 - x228 * x2370 + x221 * x2357;
  const Real x2550 = x225 * x2348 + x232 * x2357 + x218 * x2338;
  const Real x2567 = x228 * x2348 + x233 * x2357 + x221 * x2338;
  const Real x2401 = x228 * x2313;
  const Real x2378 = x218 * x2299;
  const Real x2391 = x232 * x2326;
  const Real x2394 = x221 * x2299;
  const Real x2407 = x233 * x2326;
  const Real x2417 = x231 * x2313;
  const Real x2601 = x225 * x2556 + x232 * x2562 + x218 * x2550;
  const Real x2642 = x2278 + x2601;
  require_more(w, x2642, 0.0, kFactorization, 8);
  const Real x2606 = x228 * x2556 + x233 * x2562 + x221 * x2550;
  const Real x2643 = x2279 + x2606;
  const Real x2388 = x2385 - x218 * x2302 + x232 * x2325;
  const Real x2757 = 1 / x2642;
  w.x[73] = x2757;
  const Real x2393 = x218 * x2306 + x225 * x2316 + x2391;
  const Real x2404 = x2401 - x221 * x2302 + x233 * x2325;
  const Real x2409 = x221 * x2306 + x228 * x2316 + x2407;
  const Real x2410 = x224 * x2299;
  const Real x2423 = x235 * x2326;
  const Real x2616 = x228 * x2573 + x233 * x2579 + x221 * x2567;
  const Real x2645 = x2281 + x2616;
  w.x[72] = x2645;
  const Real x2382 = x2378 + x225 * x2312 + x232 * x2322;
  const Real x2398 = x2394 + x228 * x2312 + x233 * x2322;
  const Real x2420 = x2417 - x224 * x2302 + x235 * x2325;
  const Real x2425 = x224 * x2306 + x231 * x2316 + x2423;
  const Real x2758 = x2643 * x2757;
  w.x[71] = x2758;
  const Real x2414 = x2410 + x231 * x2312 + x235 * x2322;
  const Real x2762 = x2645 - x2643 * x2758;
  w.x[70] = x2762;
  const Real x2590 = x231 * x2363 - x235 * x2370 + x224 * x2348;
  const Real x2596 = x235 * x2377 - x231 * x2370 + x224 * x2357;
  const Real x2611 = x231 * x2556 + x235 * x2562 + x224 * x2550;
  const Real x2644 = x2280 + x2611;
  const Real x2766 = 1 / x2762;
  w.x[69] = x2766;
  const Real x2656 = 0.42 * x2195 - x2244;
  const Real x2659 = x2256 + 0.2 * x2195;
  const Real x2584 = x231 * x2348 + x235 * x2357 + x224 * x2338;
  const Real x2621 = x231 * x2573 + x235 * x2579 + x224 * x2567;
  const Real x2430 = x225 * x2388 + x232 * x2393 + x218 * x2382;
  const Real x2630 = x2266 + x2430;
  w.x[68] = x2630;
  const Real x2445 = x225 * x2404 + x232 * x2409 + x218 * x2398;
  const Real x2635 = x2271 + x2445;
  w.x[29] = x2635;
  const Real x2653 = 0.2 * x2217 - x2229 - 0.42 * x2206;
  const Real x2827 = x2179 + 0.42 * x2126;
  const Real x2831 = x2090 + 0.2 * x2126;
  const Real x2867 = x2091 + 0.2 * x2129;
  const Real x2759 = x2644 * x2757;
  w.x[28] = x2759;
  const Real x2765 = x2282 + x2621 - x2644 * x2758;
  const Real x2435 = x228 * x2388 + x233 * x2393 + x221 * x2382;
  const Real x2631 = x2267 + x2435;
  w.x[27] = x2631;
  const Real x2450 = x228 * x2404 + x233 * x2409 + x221 * x2398;
  const Real x2636 = x2272 + x2450;
  w.x[26] = x2636;
  const Real x2460 = x225 * x2420 + x232 * x2425 + x218 * x2414;
  const Real x2639 = x2275 + x2460;
  w.x[25] = x2639;
  const Real x2626 = x231 * x2590 + x235 * x2596 + x224 * x2584;
  const Real x2647 = x2283 + x2626;
  w.x[24] = x2647;
  const Real x2767 = x2765 * x2766;
  w.x[5] = x2767;
  const Real x2440 = x231 * x2388 + x235 * x2393 + x224 * x2382;
  const Real x2632 = x2268 + x2440;
  w.x[4] = x2632;
  const Real x2455 = x231 * x2404 + x235 * x2409 + x224 * x2398;
  const Real x2637 = x2273 + x2455;
  w.x[3] = x2637;
  const Real x2465 = x228 * x2420 + x233 * x2425 + x221 * x2414;
  const Real x2640 = x2276 + x2465;
  w.x[2] = x2640;
  const Real x2470 = x231 * x2420 + x235 * x2425 + x224 * x2414;
  const Real x2641 = x2277 + x2470;
  w.x[1] = x2641;
  const Real x2696 = x225 * x2656 - x232 * x2659 + x218 * x2653;
  const Real x2790 = x232 * x2306 - x225 * x2302 + x2378;
  w.x[0] = x2790;
  const Real x2804 = x2385 + x232 * x2316 + x218 * x2312;
  w.x[113] = x2804;
  const Real x2816 = x2391 + x225 * x2325 + x218 * x2322;
  w.x[114] = x2816;
  const Real x2852 = x232 * x2831 - x225 * x2827 + x218 * x2336;
  w.x[115] = x2852;
  const Real x2892 = x225 * x2362 - x232 * x2867 + x218 * x2347;
  w.x[116] = x2892;
  const Real x2925 = x232 * x2376 - x225 * x2368 + x218 * x2356;
  w.x[117] = x2925;
  const Real x2773 = x2647 - x2644 * x2759 - x2765 * x2767;
  w.x[118] = x2773;
  const Real x2702 = x228 * x2656 - x233 * x2659 + x221 * x2653;
  const Real x2737 = tau[23] * x2630 + tau[24] * x2635 + tau[25] * x2639;
  const Real x2754 = x2696 - x2287 - x2737;
  w.x[119] = x2754;
  const Real x2774 = 1 / x2773;
  w.x[120] = x2774;
  const Real x2708 = x231 * x2656 - x235 * x2659 + x224 * x2653;
  const Real x2742 = tau[23] * x2631 + tau[24] * x2636 + tau[25] * x2640;
  const Real x2795 = x233 * x2306 - x228 * x2302 + x2394;
  const Real x2940 = x2795 - x2758 * x2790;
  w.x[121] = x2940;
  const Real x2808 = x2401 + x233 * x2316 + x221 * x2312;
  const Real x2943 = x2808 - x2758 * x2804;
  w.x[122] = x2943;
  const Real x2820 = x2407 + x228 * x2325 + x221 * x2322;
  const Real x2946 = x2820 - x2758 * x2816;
  w.x[123] = x2946;
  const Real x2858 = x233 * x2831 - x228 * x2827 + x221 * x2336;
  const Real x2949 = x2858 - x2758 * x2852;
  w.x[124] = x2949;
  const Real x2898 = x228 * x2362 - x233 * x2867 + x221 * x2347;
  const Real x2952 = x2898 - x2758 * x2892;
  w.x[125] = x2952;
  const Real x2931 = x233 * x2376 - x228 * x2368 + x221 * x2356;
  const Real x2955 = x2931 - x2758 * x2925;
  w.x[126] = x2955;
  const Real x2747 = tau[23] * x2632 + tau[24] * x2637 + tau[25] * x2641;
  const Real x2779 = x2702 - x2288 - x2742 - x2754 * x2758;
  w.x[127] = x2779;
  const Real x2800 = x235 * x2306 - x231 * x2302 + x2410;
  const Real x2812 = x2417 + x235 * x2316 + x224 * x2312;
  const Real x2824 = x2423 + x231 * x2325 + x224 * x2322;
  const Real x2864 = x235 * x2831 - x231 * x2827 + x224 * x2336;
  const Real x2904 = x231 * x2362 - x235 * x2867 + x224 * x2347;
  const Real x2937 = x235 * x2376 - x231 * x2368 + x224 * x2356;
  const Real x2475 = x218 * x2103 + x225 * x2113 + x232 * x2121;
  w.x[128] = x2475;
  const Real x2480 = x218 * x2113 + x225 * x2139 + x232 * x2147;
  w.x[129] = x2480;
  const Real x2485 = x218 * x2121 + x225 * x2147 + x232 * x2162;
  w.x[130] = x2485;
  const Real x2490 = x221 * x2103 + x228 * x2113 + x233 * x2121;
  w.x[131] = x2490;
  const Real x2495 = x221 * x2113 + x228 * x2139 + x233 * x2147;
  w.x[132] = x2495;
  const Real x2500 = x221 * x2121 + x228 * x2147 + x233 * x2162;
  w.x[133] = x2500;
  const Real x2836 = x218 * x2126 + x225 * x2152 + x232 * x2168;
  w.x[134] = x2836;
  const Real x2841 = x221 * x2126 + x228 * x2152 + x233 * x2168;
  w.x[135] = x2841;
  const Real x2874 = x225 * x2155 - x218 * x2129 + x232 * x2171;
  w.x[136] = x2874;
  const Real x2880 = x228 * x2155 - x221 * x2129 + x233 * x2171;
  w.x[137] = x2880;
  const Real x2909 = x218 * x2087 + x225 * x2088 + x232 * x2089;
  w.x[138] = x2909;
  const Real x2914 = x221 * x2087 + x228 * x2088 + x233 * x2089;
  w.x[139] = x2914;
  const Real x2961 = x2800 - x2759 * x2790 - x2767 * x2940;
  w.x[140] = x2961;
  const Real x2967 = x2812 - x2759 * x2804 - x2767 * x2943;
  w.x[141] = x2967;
  const Real x2973 = x2824 - x2759 * x2816 - x2767 * x2946;
  w.x[142] = x2973;
  const Real x2979 = x2864 - x2759 * x2852 - x2767 * x2949;
  w.x[143] = x2979;
  const Real x2985 = x2904 - x2759 * x2892 - x2767 * x2952;
  w.x[144] = x2985;
  const Real x2991 = x2937 - x2759 * x2925 - x2767 * x2955;
  w.x[145] = x2991;
  const Real x2992 = x2757 * x2790;
  const Real x2993 = x2757 * x2804;
  const Real x2994 = x2757 * x2816;
  const Real x2995 = x2757 * x2852;
  const Real x2996 = x2757 * x2892;
  const Real x2997 = x2757 * x2925;
  const Real x2998 = x2766 * x2940;
  const Real x2999 = x2766 * x2943;
  const Real x3000 = x2766 * x2946;
  const Real x3001 = x2766 * x2949;
  const Real x3002 = x2766 * x2952;
  const Real x3003 = x2766 * x2955;
  const Real x2505 = x224 * x2103 + x231 * x2113 + x235 * x2121;
  w.x[146] = x2505;
  const Real x2510 = x224 * x2113 + x231 * x2139 + x235 * x2147;
  w.x[147] = x2510;
  const Real x2515 = x224 * x2121 + x231 * x2147 + x235 * x2162;
  w.x[148] = x2515;
  const Real x2784 = x2708 - x2289 - x2747 - x2754 * x2759;
  const Real x2785 = x2784 - x2767 * x2779;
  w.x[149] = x2785;
  const Real x2846 = x224 * x2126 + x231 * x2152 + x235 * x2168;
  w.x[150] = x2846;
  const Real x2886 = x231 * x2155 - x224 * x2129 + x235 * x2171;
  w.x[151] = x2886;
  const Real x2919 = x224 * x2087 + x231 * x2088 + x235 * x2089;
  w.x[152] = x2919;
  const Real x3004 = x2774 * x2961;
  const Real x3005 = x2774 * x2967;
  const Real x3006 = x2774 * x2973;
  const Real x3007 = x2774 * x2979;
  const Real x3008 = x2774 * x2985;
  const Real x3009 = x2774 * x2991;
  const Real x3212 = tau[23] * x2475 + tau[24] * x2490 + tau[25] * x2505;
  const Real x3242 = x2754 * x2992 + x2779 * x2998 + x2785 * x3004;
  const Real x3217 = tau[23] * x2480 + tau[24] * x2495 + tau[25] * x2510;
  const Real x3247 = x2754 * x2993 + x2779 * x2999 + x2785 * x3005;
  const Real x3222 = tau[23] * x2485 + tau[24] * x2500 + tau[25] * x2515;
  const Real x3252 = x2754 * x2994 + x2779 * x3000 + x2785 * x3006;
  const Real x3227 = tau[23] * x2836 + tau[24] * x2841 + tau[25] * x2846;
  const Real x3257 = x2754 * x2995 + x2779 * x3001 + x2785 * x3007;
  const Real x3232 = tau[23] * x2874 + tau[24] * x2880 + tau[25] * x2886;
  const Real x3262 = x2754 * x2996 + x2779 * x3002 + x2785 * x3008;
  const Real x3237 = tau[23] * x2909 + tau[24] * x2914 + tau[25] * x2919;
  const Real x3267 = x2754 * x2997 + x2779 * x3003 + x2785 * x3009;
  const Real x3017 = x2103 - x2790 * x2992 - x2940 * x2998;
  const Real x3018 = x3017 - x2961 * x3004;
  w.to[2][0] = x3018;
  const Real x3026 = x2113 - x2790 * x2993 - x2940 * x2999;
  const Real x3027 = x3026 - x2961 * x3005;
  w.to[2][1] = x3027;
  const Real x3035 = x2121 - x2790 * x2994 - x2940 * x3000;
  const Real x3036 = x3035 - x2961 * x3006;
  w.to[2][2] = x3036;
  const Real x3044 = x2126 - x2790 * x2995 - x2940 * x3001;
  const Real x3045 = x3044 - x2961 * x3007;
  w.to[2][3] = x3045;
  const Real x3054 = x2129 + x2790 * x2996 + x2940 * x3002;
  const Real x3065 = x2087 - x2790 * x2997 - x2940 * x3003;
  const Real x3066 = x3065 - x2961 * x3009;
  w.to[2][5] = x3066;
  const Real x3074 = x2139 - x2804 * x2993 - x2943 * x2999;
  const Real x3075 = x3074 - x2967 * x3005;
  w.to[2][6] = x3075;
  const Real x3083 = x2147 - x2804 * x2994 - x2943 * x3000;
  const Real x3084 = x3083 - x2967 * x3006;
  w.to[2][7] = x3084;
  const Real x3092 = x2152 - x2804 * x2995 - x2943 * x3001;
  const Real x3093 = x3092 - x2967 * x3007;
  w.to[2][8] = x3093;
  const Real x3101 = x2155 - x2804 * x2996 - x2943 * x3002;
  const Real x3102 = x3101 - x2967 * x3008;
  w.to[2][9] = x3102;
  const Real x3110 = x2088 - x2804 * x2997 - x2943 * x3003;
  const Real x3111 = x3110 - x2967 * x3009;
  w.to[2][10] = x3111;
  const Real x3119 = x2162 - x2816 * x2994 - x2946 * x3000;
  const Real x3120 = x3119 - x2973 * x3006;
  w.to[2][11] = x3120;
  const Real x3128 = x2168 - x2816 * x2995 - x2946 * x3001;
  const Real x3129 = x3128 - x2973 * x3007;
  w.to[2][12] = x3129;
  const Real x3137 = x2171 - x2816 * x2996 - x2946 * x3002;
  const Real x3138 = x3137 - x2973 * x3008;
  w.to[2][13] = x3138;
  const Real x3146 = x2089 - x2816 * x2997 - x2946 * x3003;
  const Real x3147 = x3146 - x2973 * x3009;
  w.to[2][14] = x3147;
  const Real x3155 = x2176 - x2852 * x2995 - x2949 * x3001;
  const Real x3156 = x3155 - x2979 * x3007;
  w.to[2][15] = x3156;
  const Real x3165 = x2179 + x2852 * x2996 + x2949 * x3002;
  const Real x3176 = x2090 - x2852 * x2997 - x2949 * x3003;
  const Real x3177 = x3176 - x2979 * x3009;
  w.to[2][17] = x3177;
  const Real x3185 = x2183 - x2892 * x2996 - x2952 * x3002;
  const Real x3186 = x3185 - x2985 * x3008;
  w.to[2][18] = x3186;
  const Real x3195 = x2091 + x2892 * x2997 + x2952 * x3003;
  const Real x3206 = x1993 - x2925 * x2997 - x2955 * x3003;
  const Real x3207 = x3206 - x2991 * x3009;
  w.to[2][20] = x3207;
  const Real x3057 = -(x2961 * x3008 + x3054);
  w.to[2][4] = x3057;
  const Real x3168 = -(x2979 * x3008 + x3165);
  w.to[2][16] = x3168;
  const Real x3198 = -(x2985 * x3009 + x3195);
  w.to[2][19] = x3198;
  const Real x3275 = -(x3212 + x3242 + x2195);
  w.to[2][21] = x3275;
  const Real x3277 = -(x3217 + x3247 + x2206);
  w.to[2][22] = x3277;
  const Real x3279 = -(x3222 + x3252 + x2217);
  w.to[2][23] = x3279;
  const Real x3281 = -(x3227 + x3257 + x2229);
  w.to[2][24] = x3281;
  const Real x3283 = -(x3232 + x3262 + x2244);
  w.to[2][25] = x3283;
  const Real x3285 = -(x3237 + x3267 + x2256);
  w.to[2][26] = x3285;
}

ADAGEN_NOINLINE void part_2_3(Workspace& w) {
  ADAGEN_INPUTS
  const Real x218 = w.x[6];
  const Real x221 = w.x[7];
  const Real x224 = w.x[8];
  const Real x225 = w.x[9];
  const Real x228 = w.x[10];
  const Real x231 = w.x[11];
  const Real x232 = w.x[12];
  const Real x233 = w.x[13];
  const Real x235 = w.x[14];
  const Real x2195 = w.x[107];
  const Real x2206 = w.x[108];
  const Real x2217 = w.x[109];
  const Real x2263 = w.x[82];
  const Real x2264 = w.x[81];
  const Real x2265 = w.x[80];
  const Real x2269 = w.x[79];
  const Real x2270 = w.x[78];
  const Real x2274 = w.x[77];
  const Real x2284 = w.x[76];
  const Real x2285 = w.x[75];
  const Real x2286 = w.x[74];
  const Real x2475 = w.x[128];
  const Real x2480 = w.x[129];
  const Real x2485 = w.x[130];
  const Real x2490 = w.x[131];
  const Real x2495 = w.x[132];
  const Real x2500 = w.x[133];
  const Real x2505 = w.x[146];
  const Real x2510 = w.x[147];
  const Real x2515 = w.x[148];
  const Real x2645 = w.x[72];
  const Real x2647 = w.x[24];
  const Real x2762 = w.x[70];
  const Real x2773 = w.x[118];
  // joint 8 "left_shoulder": assembly: its two sides become one chain
  const Real x2520 = x218 * x2475 + x225 * x2480 + x232 * x2485;
  const Real x2525 = x221 * x2475 + x228 * x2480 + x233 * x2485;
  const Real x2628 = x2264 + x2525;
  const Real x2530 = x224 * x2475 + x231 * x2480 + x235 * x2485;
  const Real x2629 = x2265 + x2530;
  const Real x2535 = x221 * x2490 + x228 * x2495 + x233 * x2500;
  const Real x2540 = x224 * x2490 + x231 * x2495 + x235 * x2500;
  const Real x2634 = x2270 + x2540;
  const Real x2545 = x224 * x2505 + x231 * x2510 + x235 * x2515;
  const Real x2669 = x218 * x2195 + x225 * x2206 + x232 * x2217;
  const Real x2679 = x221 * x2195 + x228 * x2206 + x233 * x2217;
  const Real x2721 = tau[23] * (x2263 + x2520) + tau[24] * x2628;
  const Real x2726 = tau[23] * x2628 + tau[24] * (x2269 + x2535);
  const Real x2689 = x224 * x2195 + x231 * x2206 + x235 * x2217;
  const Real x2731 = tau[23] * x2629 + tau[24] * x2634;
  const Real x2775 = 1.7763568394002505e-15 * x2645;
  require_more(w, x2762, x2775, kFactorization, 8);
  const Real x2748 = x2284 + x2669 + (tau[25] * x2629 + x2721);
  w.x[153] = x2748;
  const Real x2750 = x2285 + x2679 + (tau[25] * x2634 + x2726);
  w.x[154] = x2750;
  const Real x2776 = 1.7763568394002505e-15 * x2647;
  require_more(w, x2773, x2776, kFactorization, 8);
  const Real x2752 = x2286 + x2689 + (tau[25] * (x2274 + x2545) + x2731);
  w.x[155] = x2752;
}

ADAGEN_NOINLINE void part_2_4(Workspace& w) {
  ADAGEN_INPUTS
  const Real x2754 = w.x[119];
  const Real x2757 = w.x[73];
  const Real x2758 = w.x[71];
  const Real x2759 = w.x[28];
  const Real x2766 = w.x[69];
  const Real x2767 = w.x[5];
  const Real x2774 = w.x[120];
  const Real x2779 = w.x[127];
  const Real x2785 = w.x[149];
  const Real x2790 = w.x[0];
  const Real x2804 = w.x[113];
  const Real x2816 = w.x[114];
  const Real x2852 = w.x[115];
  const Real x2892 = w.x[116];
  const Real x2925 = w.x[117];
  const Real x2940 = w.x[121];
  const Real x2943 = w.x[122];
  const Real x2946 = w.x[123];
  const Real x2949 = w.x[124];
  const Real x2952 = w.x[125];
  const Real x2955 = w.x[126];
  const Real x2961 = w.x[140];
  const Real x2967 = w.x[141];
  const Real x2973 = w.x[142];
  const Real x2979 = w.x[143];
  const Real x2985 = w.x[144];
  const Real x2991 = w.x[145];
  // message received
  const Real x3286 = w.from[3][0];
  w.x[118] = x3286;
  const Real x3287 = w.from[3][1];
  w.x[70] = x3287;
  const Real x3288 = w.from[3][2];
  w.x[24] = x3288;
  const Real x3289 = w.from[3][3];
  w.x[72] = x3289;
  const Real x3291 = w.from[3][5];
  w.x[74] = x3291;
  const Real x3290 = w.from[3][4];
  w.x[75] = x3290;
  // joint 8 "left_shoulder": disassembly: its acceleration and force
  const Real x3299 = x2790 * x3286 + x2925 * x3291 + x2804 * x3287;
  const Real x3301 = x2816 * x3288 + x3299 + x2852 * x3289;
  const Real x3310 = x2940 * x3286 + x2943 * x3287 + x2946 * x3288;
  const Real x3312 = x2949 * x3289 + x3310 + x2952 * x3290;
  const Real x3321 = x2961 * x3286 + x2967 * x3287 + x2973 * x3288;
  const Real x3323 = x2979 * x3289 + x3321 + x2985 * x3290;
  const Real x3366 = x2774 * (x2991 * x3291 + x3323 + x2785);
  w.x[76] = x3366;
  w.to[5][5] = x3366;
  const Real x3365 = x2766 * (x2955 * x3291 + x3312 + x2779);
  const Real x3369 = x3365 - x2767 * x3366;
  w.x[77] = x3369;
  w.to[5][4] = x3369;
  const Real x3364 = x2757 * (x2892 * x3290 + x3301 + x2754);
  const Real x3375 = x3364 - x2759 * x3366 - x2758 * x3369;
  w.x[78] = x3375;
  w.to[5][3] = x3375;
}

ADAGEN_NOINLINE void part_2_5(Workspace& w) {
  ADAGEN_INPUTS
  const Real x218 = w.x[6];
  const Real x221 = w.x[7];
  const Real x224 = w.x[8];
  const Real x225 = w.x[9];
  const Real x228 = w.x[10];
  const Real x231 = w.x[11];
  const Real x232 = w.x[12];
  const Real x233 = w.x[13];
  const Real x235 = w.x[14];
  const Real x358 = w.x[15];
  const Real x361 = w.x[16];
  const Real x364 = w.x[17];
  const Real x365 = w.x[18];
  const Real x368 = w.x[19];
  const Real x371 = w.x[20];
  const Real x372 = w.x[21];
  const Real x373 = w.x[22];
  const Real x375 = w.x[23];
  const Real x490 = w.x[30];
  const Real x493 = w.x[31];
  const Real x496 = w.x[32];
  const Real x497 = w.x[33];
  const Real x500 = w.x[34];
  const Real x503 = w.x[35];
  const Real x504 = w.x[36];
  const Real x505 = w.x[37];
  const Real x507 = w.x[38];
  const Real x687 = w.x[39];
  const Real x690 = w.x[40];
  const Real x693 = w.x[41];
  const Real x694 = w.x[42];
  const Real x697 = w.x[43];
  const Real x700 = w.x[44];
  const Real x701 = w.x[45];
  const Real x702 = w.x[46];
  const Real x704 = w.x[47];
  const Real x1044 = w.x[48];
  const Real x1045 = w.x[49];
  const Real x1046 = w.x[50];
  const Real x1167 = w.x[51];
  const Real x1168 = w.x[52];
  const Real x1170 = w.x[53];
  const Real x1172 = w.x[54];
  const Real x1173 = w.x[55];
  const Real x1360 = w.x[56];
  const Real x1363 = w.x[57];
  const Real x1369 = w.x[58];
  const Real x1407 = w.x[59];
  const Real x1409 = w.x[60];
  const Real x1411 = w.x[61];
  const Real x1414 = w.x[62];
  const Real x1417 = w.x[63];
  const Real x1420 = w.x[64];
  const Real x1426 = w.x[65];
  const Real x1432 = w.x[66];
  const Real x1438 = w.x[67];
  const Real x1702 = w.x[83];
  const Real x1703 = w.x[84];
  const Real x1706 = w.x[85];
  const Real x1993 = w.x[86];
  const Real x2087 = w.x[87];
  const Real x2088 = w.x[88];
  const Real x2089 = w.x[89];
  const Real x2090 = w.x[90];
  const Real x2091 = w.x[91];
  const Real x2103 = w.x[92];
  const Real x2113 = w.x[93];
  const Real x2121 = w.x[94];
  const Real x2126 = w.x[95];
  const Real x2129 = w.x[96];
  const Real x2139 = w.x[97];
  const Real x2147 = w.x[98];
  const Real x2152 = w.x[99];
  const Real x2155 = w.x[100];
  const Real x2162 = w.x[101];
  const Real x2168 = w.x[102];
  const Real x2171 = w.x[103];
  const Real x2176 = w.x[104];
  const Real x2179 = w.x[105];
  const Real x2183 = w.x[106];
  const Real x2195 = w.x[107];
  const Real x2206 = w.x[108];
  const Real x2217 = w.x[109];
  const Real x2229 = w.x[110];
  const Real x2244 = w.x[111];
  const Real x2256 = w.x[112];
  const Real x2475 = w.x[128];
  const Real x2480 = w.x[129];
  const Real x2485 = w.x[130];
  const Real x2490 = w.x[131];
  const Real x2495 = w.x[132];
  const Real x2500 = w.x[133];
  const Real x2505 = w.x[146];
  const Real x2510 = w.x[147];
  const Real x2515 = w.x[148];
  const Real x2630 = w.x[68];
  const Real x2631 = w.x[27];
  const Real x2632 = w.x[4];
  const Real x2635 = w.x[29];
  const Real x2636 = w.x[26];
  const Real x2637 = w.x[3];
  const Real x2639 = w.x[25];
  const Real x2640 = w.x[2];
  const Real x2641 = w.x[1];
  const Real x2748 = w.x[153];
  const Real x2750 = w.x[154];
  const Real x2752 = w.x[155];
  const Real x2836 = w.x[134];
  const Real x2841 = w.x[135];
  const Real x2846 = w.x[150];
  const Real x2874 = w.x[136];
  const Real x2880 = w.x[137];
  const Real x2886 = w.x[151];
  const Real x2909 = w.x[138];
  const Real x2914 = w.x[139];
  const Real x2919 = w.x[152];
  const Real x3286 = w.x[118];
  const Real x3287 = w.x[70];
  const Real x3288 = w.x[24];
  const Real x3289 = w.x[72];
  const Real x3290 = w.x[75];
  const Real x3291 = w.x[74];
  const Real x3366 = w.x[76];
  const Real x3369 = w.x[77];
  const Real x3375 = w.x[78];
  // joint 8 "left_shoulder": disassembly: its acceleration and force
  const Real x3335 = x2475 * x3286 + x2909 * x3291 + x2480 * x3287;
  const Real x3346 = x2490 * x3286 + x2914 * x3291 + x2495 * x3287;
  const Real x3357 = x2505 * x3286 + x2919 * x3291 + x2510 * x3287;
  const Real x3337 = x2485 * x3288 + x3335 + x2836 * x3289;
  const Real x3348 = x2500 * x3288 + x3346 + x2841 * x3289;
  const Real x3359 = x2515 * x3288 + x3357 + x2846 * x3289;
  const Real x3413 = x221 * x3369 + x224 * x3366 + x218 * x3375;
  const Real x3418 = x228 * x3369 + x231 * x3366 + x225 * x3375;
  const Real x3423 = x233 * x3369 + x235 * x3366 + x232 * x3375;
  const Real x3443 = x3289 - x3413;
  const Real x3444 = x3290 - x3418;
  const Real x3445 = x3291 - x3423;
  const Real x3380 = x2631 * x3369 + x2632 * x3366 + x2630 * x3375;
  const Real x3391 = x2748 - (x2874 * x3290 + x3337) + x3380;
  w.result[23] = x3391;
  const Real x3385 = x2636 * x3369 + x2637 * x3366 + x2635 * x3375;
  const Real x3392 = x2750 - (x2880 * x3290 + x3348) + x3385;
  w.result[24] = x3392;
  const Real x3390 = x2640 * x3369 + x2641 * x3366 + x2639 * x3375;
  const Real x3393 = x2752 - (x2886 * x3290 + x3359) + x3390;
  w.result[25] = x3393;
  const Real x3403 = x225 * tau[23] + x231 * tau[25] + x228 * tau[24];
  const Real x3398 = x221 * tau[24] + x224 * tau[25] + x218 * tau[23];
  const Real x3408 = x232 * tau[23] + x233 * tau[24] + x235 * tau[25];
  const Real x3441 = x3287 - (x3403 + 0.42 * x3413);
  const Real x3442 = x3288 - (x3408 - 0.2 * x3413);
  const Real x3440 = x3286 - (x3398 + 0.2 * x3423 - 0.42 * x3418);
  // link 8 "trunk": acceleration under the handle forces
  const Real x3454 = x2126 * x3443 - x2129 * x3444 + x2087 * x3445;
  const Real x3476 = x2168 * x3443 + x2171 * x3444 + x2089 * x3445;
  const Real x3465 = x2152 * x3443 + x2155 * x3444 + x2088 * x3445;
  const Real x3488 = x2176 * x3443 - x2179 * x3444 + x2090 * x3445;
  const Real x3502 = x2183 * x3444 - x2179 * x3443 - x2091 * x3445;
  const Real x3514 = x2090 * x3443 - x2091 * x3444 + x1993 * x3445;
  const Real x3456 = x2113 * x3441 + x3454 + x2121 * x3442;
  const Real x3478 = x2147 * x3441 + x3476 + x2162 * x3442;
  const Real x3518 = x2103 * x3440 + x3456 - x2195;
  const Real x3467 = x2139 * x3441 + x3465 + x2147 * x3442;
  const Real x3520 = x2121 * x3440 + x3478 - x2217;
  const Real x3490 = x2152 * x3441 + x3488 + x2168 * x3442;
  const Real x3504 = x2155 * x3441 + x3502 + x2171 * x3442;
  const Real x3516 = x2088 * x3441 + x3514 + x2089 * x3442;
  const Real x3519 = x2113 * x3440 + x3467 - x2206;
  const Real x3521 = x2126 * x3440 + x3490 - x2229;
  const Real x3522 = x3504 - x2129 * x3440 - x2244;
  const Real x3523 = x2087 * x3440 + x3516 - x2256;
  // joint 11 "neck": its acceleration, and that of the link beyond
  const Real x3530 = x3522 - 0.48 * x3518;
  const Real x3527 = x3521 + 0.48 * x3519;
  // joint 12 "right_shoulder": its acceleration, and that of the link beyond
  const Real x3583 = x3522 - 0.42 * x3518;
  const Real x3586 = x3523 - 0.2 * x3518;
  const Real x3580 = x3521 + 0.2 * x3520 + 0.42 * x3519;
  // joint 11 "neck": its acceleration, and that of the link beyond
  const Real x3555 = x361 * x3527 + x373 * x3523 + x368 * x3530;
  const Real x3550 = x358 * x3527 + x372 * x3523 + x365 * x3530;
  const Real x3560 = x364 * x3527 + x375 * x3523 + x371 * x3530;
  const Real x3535 = x358 * x3518 + x365 * x3519 + x372 * x3520;
  const Real x3573 = x1706 + 5.9071729957805905 * x3555 - x3535;
  w.result[30] = x3573;
  const Real x3545 = x364 * x3518 + x371 * x3519 + x375 * x3520;
  const Real x3575 = x1703 - 0.42194092827004215 * x3555 - x3545;
  w.result[32] = x3575;
  const Real x3540 = x361 * x3518 + x368 * x3519 + x373 * x3520;
  const Real x3574 = x1702 - 5.9071729957805905 * x3550 + 0.42194092827004215 * x3560 - x3540;
  w.result[31] = x3574;
  // joint 12 "right_shoulder": its acceleration, and that of the link beyond
  const Real x3606 = x497 * x3583 + x504 * x3586 + x490 * x3580;
  const Real x3611 = x500 * x3583 + x505 * x3586 + x493 * x3580;
  const Real x3616 = x503 * x3583 + x507 * x3586 + x496 * x3580;
  const Real x3624 = x1369 - x1426 * x3606 - x1432 * x3611;
  const Real x3625 = x3624 - x1438 * x3616;
  const Real x3633 = x1363 - x1414 * x3606 - x1417 * x3611;
  const Real x3634 = x3633 - x1420 * x3616;
  const Real x3642 = x1360 + x1407 * x3606 + x1409 * x3611;
  const Real x3643 = x3642 - x1411 * x3616;
  const Real x3591 = x490 * x3518 + x497 * x3519 + x504 * x3520;
  const Real x3644 = x3625 - x3591;
  w.result[33] = x3644;
  const Real x3596 = x493 * x3518 + x500 * x3519 + x505 * x3520;
  const Real x3645 = x3634 - x3596;
  w.result[34] = x3645;
  const Real x3601 = x496 * x3518 + x503 * x3519 + x507 * x3520;
  const Real x3646 = x3643 - x3601;
  w.result[35] = x3646;
  // joint 13 "right_elbow": its acceleration, and that of the link beyond
  const Real x3649 = x3606 - 0.29 * x3634;
  const Real x3658 = cosine[0] * x3625 - sine[0] * x3643;
  const Real x3651 = x3611 + 0.29 * x3625;
  const Real x3654 = cosine[0] * x3643 + sine[0] * x3625;
  const Real x3661 = cosine[0] * x3616 + sine[0] * x3649;
  const Real x3665 = cosine[0] * x3649 - sine[0] * x3616;
  const Real x3675 = x1167 + x1168 * x3658 + x1173 * x3651;
  const Real x3677 = x1170 * x3661 + x3675 - x1172 * x3665;
  const Real x3678 = x3677 - x3634;
  w.result[36] = x3678;
  // joint 14 "right_wrist": its acceleration, and that of the link beyond
  const Real x3683 = x3651 + 0.26 * x3658;
  const Real x3681 = x3665 - 0.26 * x3677;
  const Real x3698 = x704 * x3654 + x693 * x3658 + x700 * x3677;
  const Real x3723 = x1046 - x3698;
  w.result[39] = x3723;
  const Real x3703 = x701 * x3661 + x694 * x3683 + x687 * x3681;
  const Real x3708 = x702 * x3661 + x697 * x3683 + x690 * x3681;
  const Real x3693 = x702 * x3654 + x690 * x3658 + x697 * x3677;
  const Real x3722 = x1045 + x3703 * 9.00562851782364 - x3693;
  w.result[38] = x3722;
  const Real x3688 = x701 * x3654 + x687 * x3658 + x694 * x3677;
  const Real x3721 = x1044 - 8.56378233719893 * x3708 - x3688;
  w.result[37] = x3721;
}

// =================================================================================================
// Process 3: 585 products, 461 sums, 10 quotients
// =================================================================================================

ADAGEN_NOINLINE void part_3_0(Workspace& w) {
  ADAGEN_INPUTS
  // joint 7 "spine": placement, velocity and reference acceleration of its link
  const Real x154 = v[4] * v[5] * 0.13;
  const Real x153 = v[3] * v[5] * 0.13;
  const Real x155 = (v[3] * v[3] + v[4] * v[4]) * 0.13;
  const Real x94 = q[25] * q[25] + q[26] * q[26] + q[27] * q[27];
  const Real x95 = q[28] * q[28] + x94;
  require_length(w, x95, 7);
  const Real x97 = 2.0 * (1 / x95);
  const Real x98 = q[25] * x97;
  const Real x99 = q[26] * x97;
  const Real x100 = q[27] * x97;
  const Real x101 = q[26] * x99;
  const Real x102 = q[27] * x100;
  const Real x105 = q[26] * x98;
  const Real x106 = q[28] * x100;
  const Real x108 = q[27] * x98;
  const Real x109 = q[28] * x99;
  const Real x112 = q[25] * x98;
  // joint 8 "left_shoulder": placement, velocity and reference acceleration of its link
  const Real x208 = q[29] * q[29] + q[30] * q[30] + q[31] * q[31];
  const Real x209 = q[32] * q[32] + x208;
  require_length(w, x209, 8);
  const Real x211 = 2.0 * (1 / x209);
  const Real x212 = q[29] * x211;
  const Real x213 = q[30] * x211;
  const Real x214 = q[31] * x211;
  // joint 10 "left_wrist": placement, velocity and reference acceleration of its link
  const Real x412 = q[34] * q[34] + q[35] * q[35] + q[36] * q[36];
  const Real x413 = q[37] * q[37] + x412;
  require_length(w, x413, 10);
  const Real x415 = 2.0 * (1 / x413);
  const Real x416 = q[34] * x415;
  const Real x417 = q[35] * x415;
  const Real x418 = q[36] * x415;
  const Real x423 = q[35] * x416;
  const Real x419 = q[35] * x417;
  const Real x420 = q[36] * x418;
  const Real x424 = q[37] * x418;
  const Real x426 = q[36] * x416;
  const Real x427 = q[37] * x417;
  const Real x430 = q[34] * x416;
  const Real x433 = q[36] * x417;
  const Real x434 = q[37] * x416;
  const Real x425 = x423 - x424;
  w.x[0] = x425;
  const Real x429 = x423 + x424;
  w.x[1] = x429;
  const Real x428 = x426 + x427;
  w.x[2] = x428;
  const Real x436 = x426 - x427;
  w.x[3] = x436;
  const Real x435 = x433 - x434;
  w.x[4] = x435;
  const Real x437 = x433 + x434;
  w.x[5] = x437;
  const Real x422 = 1.0 - (x419 + x420);
  w.x[6] = x422;
  const Real x432 = 1.0 - (x420 + x430);
  w.x[7] = x432;
  const Real x439 = 1.0 - (x419 + x430);
  w.x[8] = x439;
  // joint 10 "left_wrist": articulated-body inertia and bias force through it
  const Real x688 = x425 * 0.13225691347011598;
  const Real x689 = 0.42 * x428;
  const Real x684 = x436 * 0.1174108818011257;
  const Real x685 = x437 * 0.13225691347011598;
  const Real x687 = x422 * 0.1174108818011257;
  const Real x686 = 0.42 * x439;
  // joint 7 "spine": placement, velocity and reference acceleration of its link
  const Real x115 = q[27] * x99;
  const Real x116 = q[28] * x98;
  const Real x107 = x105 - x106;
  const Real x110 = x108 + x109;
  const Real x111 = x105 + x106;
  const Real x117 = x115 - x116;
  const Real x118 = x108 - x109;
  const Real x119 = x115 + x116;
  const Real x104 = 1.0 - (x101 + x102);
  const Real x114 = 1.0 - (x102 + x112);
  const Real x121 = 1.0 - (x101 + x112);
  const Real x127 = v[4] * x111 + v[5] * x118 + v[3] * x104;
  const Real x132 = v[3] * x107 + v[5] * x119 + v[4] * x114;
  const Real x137 = v[3] * x110 + v[4] * x117 + v[5] * x121;
  const Real x138 = v[20] + x127;
  const Real x139 = v[21] + x132;
  const Real x140 = v[22] + x137;
  const Real x144 = v[22] * x132 - v[21] * x137;
  // joint 8 "left_shoulder": placement, velocity and reference acceleration of its link
  const Real x215 = q[30] * x213;
  const Real x216 = q[31] * x214;
  const Real x222 = q[31] * x212;
  const Real x223 = q[32] * x213;
  const Real x226 = q[29] * x212;
  const Real x229 = q[31] * x213;
  const Real x230 = q[32] * x212;
  const Real x219 = q[30] * x212;
  const Real x220 = q[32] * x214;
  const Real x224 = x222 + x223;
  const Real x231 = x229 - x230;
  // joint 10 "left_wrist": articulated-body inertia and bias force through it
  const Real x712 = x425 * x688 + x428 * x689 + x422 * x687;
  const Real x717 = x432 * x688 + x435 * x689 + x429 * x687;
  const Real x721 = x429 * (x429 * 0.1174108818011257) + x435 * (0.42 * x435);
  const Real x722 = x432 * (x432 * 0.13225691347011598) + x721;
  const Real x702 = x422 * x684 + x425 * x685 + x428 * x686;
  const Real x729 = 0.26 * x712;
  const Real x727 = 0.26 * x717;
  const Real x731 = 0.26 * x722;
  const Real x725 = 0.26 * x702;
  const Real x707 = x429 * x684 + x432 * x685 + x435 * x686;
  const Real x778 = -0.132 - x729;
  const Real x735 = 0.26 * x727;
  const Real x697 = x436 * x684 + x437 * x685 + x439 * x686;
  const Real x777 = 0.02190604 + 0.26 * x729;
  require_more(w, x777, 0.0, kFactorization, 9);
  // joint 9 "left_elbow": articulated-body inertia and bias force through it
  const Real x789 = 1 / x777;
  const Real x792 = x735 * x789;
  w.x[9] = x792;
  const Real x797 = x727 * x789;
  w.x[10] = x797;
  const Real x794 = x725 * x789;
  w.x[11] = x794;
  const Real x796 = x778 * x789;
  w.x[12] = x796;
  const Real x801 = 0.02190604 + 0.26 * x731 - x735 * x792;
  // joint 7 "spine": placement, velocity and reference acceleration of its link
  const Real x148 = v[20] * x137 - v[22] * x127;
  const Real x152 = v[21] * x127 - v[20] * x132;
  const Real x178 = x138 * x138;
  const Real x188 = x139 * x140;
  // joint 8 "left_shoulder": placement, velocity and reference acceleration of its link
  const Real x218 = 1.0 - (x215 + x216);
  const Real x221 = x219 - x220;
  const Real x225 = x219 + x220;
  const Real x228 = 1.0 - (x216 + x226);
  const Real x235 = 1.0 - (x215 + x226);
  const Real x232 = x222 - x223;
  const Real x233 = x229 + x230;
  const Real x252 = x138 * x224 + x139 * x231 + x140 * x235;
  const Real x242 = x138 * x218 + x139 * x225 + x140 * x232;
  // joint 9 "left_elbow": articulated-body inertia and bias force through it
  const Real x810 = 0.132 + x731 - x735 * x797;
  const Real x828 = 1.1 + x722 - x727 * x797;
  const Real x813 = 1.1 + x697 - x725 * x794;
  const Real x822 = 1.1 + x712 - x778 * x796;
  const Real x804 = 0.26 * x707 - x735 * x794;
  const Real x807 = x727 + x735 * x796;
  const Real x816 = x702 + x725 * x796;
  const Real x819 = x707 - x725 * x797;
  const Real x825 = x717 + x778 * x797;
  const Real x842 = cosine[0] * x810;
  const Real x857 = cosine[0] * (0.00067375 - x801);
  const Real x890 = x842 + 0.29 * x828;
  const Real x848 = cosine[0] * x807 + sine[0] * x804;
  const Real x871 = sine[0] * x819 + cosine[0] * x825;
  const Real x862 = cosine[0] * x857;
  const Real x876 = cosine[0] * (x813 - x822) - x816 * (2.0 * sine[0]);
  const Real x853 = cosine[0] * x848;
  const Real x883 = 0.29 * x871;
  const Real x880 = cosine[0] * x876;
  const Real x885 = x853 + x883;
  const Real x882 = x813 - x880;
  const Real x902 = 0.29 * x885;
  const Real x901 = 0.00067375 - x862 + (0.29 * x842 + 0.29 * x890);
  const Real x931 = 0.050615200000000006 + x901;
  require_more(w, x931, 0.0, kFactorization, 8);
  const Real x886 = 0.29 * x882;
  const Real x840 = sine[0] * x810;
  const Real x933 = 0.050615200000000006 + 0.29 * x886;
  w.x[13] = x933;
  // link 9 "left_upper_arm": mobility from its articulated-body inertia
  const Real x945 = 1 / x931;
  // joint 8 "left_shoulder": placement, velocity and reference acceleration of its link
  const Real x247 = x138 * x221 + x139 * x228 + x140 * x233;
  // joint 7 "spine": placement, velocity and reference acceleration of its link
  const Real x162 = x111 * x154 - x118 * x155 + x104 * x153;
  const Real x168 = x107 * x153 - x119 * x155 + x114 * x154;
  // joint 8 "left_shoulder": placement, velocity and reference acceleration of its link
  const Real x253 = v[23] + x242;
  const Real x254 = v[24] + x247;
  const Real x255 = v[25] + x252;
  const Real x265 = x144 * x221 + x148 * x228 + x152 * x233;
  const Real x288 = x162 + (x138 * x139 - x152) * 0.2;
  const Real x289 = (x148 + x138 * x140) * 0.42 + x288;
  const Real x293 = x168 - (x178 + x140 * x140) * 0.2;
  const Real x294 = (x188 - x144) * 0.42 + x293;
  // joint 7 "spine": placement, velocity and reference acceleration of its link
  const Real x174 = x110 * x153 + x117 * x154 - x121 * x155;
  // joint 8 "left_shoulder": placement, velocity and reference acceleration of its link
  const Real x260 = x144 * x218 + x148 * x225 + x152 * x232;
  const Real x280 = x265 + v[23] * x252 - v[25] * x242;
  w.x[14] = x280;
  const Real x270 = x144 * x224 + x148 * x231 + x152 * x235;
  const Real x298 = x174 + (x144 + x188) * 0.2;
  const Real x299 = x298 - (x178 + x139 * x139) * 0.42;
  const Real x333 = x253 * x255;
  const Real x275 = x260 + v[25] * x247 - v[24] * x252;
  const Real x285 = x270 + v[24] * x242 - v[23] * x247;
  const Real x331 = x253 * x253 + x254 * x254;
  const Real x335 = x280 + x333;
  const Real x304 = x218 * x289 + x225 * x294 + x232 * x299;
  const Real x314 = x224 * x289 + x231 * x294 + x235 * x299;
  const Real x328 = x254 * x255;
  const Real x329 = x328 - x275;
  // joint 9 "left_elbow": placement, velocity and reference acceleration of its link
  const Real x349 = x254 + v[26];
  const Real x344 = x255 * cosine[0] + x253 * sine[0];
  const Real x348 = x253 * cosine[0] - x255 * sine[0];
  const Real x365 = x304 - x335 * 0.29;
  const Real x371 = x314 + x331 * 0.29;
  const Real x387 = x344 * x348;
  const Real x358 = x285 * cosine[0] + x275 * sine[0] + v[26] * x348;
  w.x[15] = x358;
  // joint 9 "left_elbow": articulated-body inertia and bias force through it
  const Real x850 = sine[0] * x848;
  const Real x906 = sine[0] * x857 - 0.29 * x840;
  const Real x935 = x801 + x862 + 0.00192375;
  w.x[16] = x935;
  // link 9 "left_upper_arm": mobility from its articulated-body inertia
  const Real x946 = x902 * x945;
  const Real x954 = x933 - x902 * x946;
  w.x[17] = x954;
  const Real x967 = 1 / x954;
  const Real x948 = x906 * x945;
  const Real x957 = 0.29 * x850 + x906 * x946;
  const Real x968 = x957 * x967;
  const Real x977 = x935 - x906 * x948 - x957 * x968;
  w.x[18] = x977;
  // joint 8 "left_shoulder": placement, velocity and reference acceleration of its link
  const Real x309 = x221 * x289 + x228 * x294 + x233 * x299;
  // joint 9 "left_elbow": placement, velocity and reference acceleration of its link
  const Real x361 = x275 * cosine[0] - x285 * sine[0] - v[26] * x344;
  w.x[19] = x361;
  const Real x385 = x348 * x348 + x349 * x349;
  const Real x389 = x280 + x387;
  const Real x397 = x344 * x349;
  const Real x374 = cosine[0] * x371 + sine[0] * x365;
  const Real x378 = cosine[0] * x365 - sine[0] * x371;
  const Real x398 = x397 - x361;
  const Real x368 = x309 - x329 * 0.29;
  // joint 10 "left_wrist": placement, velocity and reference acceleration of its link
  const Real x445 = x344 * x436 + x349 * x429 + x348 * x422;
  w.x[20] = x445;
  const Real x455 = x344 * x439 + x349 * x435 + x348 * x428;
  const Real x450 = x344 * x437 + x349 * x432 + x348 * x425;
  w.x[21] = x450;
  const Real x492 = x374 + x385 * 0.26;
  const Real x495 = x378 - x389 * 0.26;
  const Real x456 = v[27] + x445;
  w.x[22] = x456;
  const Real x458 = v[29] + x455;
  const Real x498 = x368 - x398 * 0.26;
  const Real x457 = v[28] + x450;
  w.x[23] = x457;
  const Real x468 = x358 * x437 + x280 * x432 + x361 * x425;
  const Real x483 = v[27] * x455 - v[29] * x445 + x468;
  const Real x532 = x456 * x458;
  const Real x463 = x358 * x436 + x280 * x429 + x361 * x422;
  const Real x478 = v[29] * x450 - v[28] * x455 + x463;
  const Real x503 = x436 * x492 + x422 * x495 + x429 * x498;
  const Real x527 = x457 * x458;
  const Real x508 = x437 * x492 + x425 * x495 + x432 * x498;
  // joint 9 "left_elbow": articulated-body inertia and bias force through it
  const Real x936 = 1.9 + x882;
  w.x[24] = x936;
  const Real x932 = 0.266 + x890;
  const Real x868 = cosine[0] * x819 - sine[0] * x825;
  // link 9 "left_upper_arm": mobility from its articulated-body inertia
  const Real x1000 = 1 / x977;
  const Real x960 = -0.266 - x886 + x885 * x946;
  const Real x949 = x885 * x945;
  const Real x969 = x960 * x967;
  const Real x984 = x850 + x885 * x948 + x960 * x968;
  const Real x1001 = x984 * x1000;
  const Real x963 = x932 * x946 - x883;
  const Real x1013 = x936 - x885 * x949 - x960 * x969;
  const Real x1014 = x1013 - x984 * x1001;
  w.x[25] = x1014;
  const Real x1033 = 1 / x1014;
  // joint 10 "left_wrist": placement, velocity and reference acceleration of its link
  const Real x513 = x439 * x492 + x428 * x495 + x435 * x498;
  // link 11 "left_hand": force that the reference field takes
  const Real x656 = (x456 * x456 + x457 * x457) * 0.0336;
  const Real x658 = 0.42 * x513 + x656;
  const Real x646 = x483 * 0.003731 + x532 * 0.0036680000000000003 - x503 * 0.0336;
  const Real x643 = x478 * 0.0039235 - x527 * 0.0034755000000000003 + x508 * 0.0336;
  // joint 10 "left_wrist": articulated-body inertia and bias force through it
  const Real x669 = 268.0246582685607 * (tau[28] - x646);
  w.x[26] = x669;
  const Real x668 = 254.87447432139672 * (tau[27] - x643);
  w.x[27] = x668;
  // link 11 "left_hand": force that the reference field takes
  const Real x650 = 0.42 * x503 - (x483 + x532) * 0.0336;
  // joint 10 "left_wrist": articulated-body inertia and bias force through it
  const Real x681 = x650 - 0.0336 * x669;
  // link 11 "left_hand": force that the reference field takes
  const Real x654 = 0.42 * x508 - (x527 - x478) * 0.0336;
  // joint 10 "left_wrist": articulated-body inertia and bias force through it
  const Real x683 = x654 + 0.0336 * x668;
  const Real x763 = x422 * x681 + x428 * x658 + x425 * x683;
  // joint 9 "left_elbow": articulated-body inertia and bias force through it
  const Real x879 = x816 + sine[0] * x876;
  const Real x893 = x804 - x850 + 0.29 * x868;
  const Real x937 = 1.9 + x828;
  w.x[28] = x937;
  const Real x938 = x822 + x880 + 1.9;
  w.x[29] = x938;
  // link 9 "left_upper_arm": mobility from its articulated-body inertia
  const Real x950 = x932 * x945;
  const Real x992 = x840 + x932 * x948 + x963 * x968;
  const Real x970 = x963 * x967;
  const Real x1003 = x992 * x1000;
  const Real x1022 = x871 - x932 * x949 - x963 * x969;
  const Real x1023 = x1022 - x992 * x1001;
  const Real x966 = x893 * x946 - 0.29 * x879;
  const Real x1034 = x1023 * x1033;
  const Real x1045 = x937 - x932 * x950 - x963 * x970;
  const Real x999 = x807 - x853 - x893 * x948 - x966 * x968;
  const Real x951 = x893 * x945;
  const Real x1047 = x1045 - x992 * x1003 - x1023 * x1034;
  w.x[30] = x1047;
  const Real x971 = x966 * x967;
  const Real x1060 = 1 / x1047;
  const Real x1031 = x879 - x893 * x949 - x966 * x969;
  const Real x1032 = x999 * x1001 + x1031;
  const Real x1005 = x999 * x1000;
  const Real x1057 = x868 - x893 * x950 - x966 * x970;
  // joint 10 "left_wrist": articulated-body inertia and bias force through it
  const Real x753 = x429 * tau[27] + x435 * tau[29] + x432 * tau[28];
  const Real x768 = x429 * x681 + x435 * x658 + x432 * x683;
  // link 10 "left_forearm": force that the reference field takes
  const Real x600 = x280 * 0.02190604 + x387 * 0.02123229 - x378 * 0.132;
  // joint 10 "left_wrist": articulated-body inertia and bias force through it
  const Real x748 = x425 * tau[28] + x428 * tau[29] + x422 * tau[27];
  // link 10 "left_forearm": force that the reference field takes
  const Real x597 = x361 * 0.02190604 - x397 * 0.02123229 + x368 * 0.132;
  // joint 10 "left_wrist": articulated-body inertia and bias force through it
  const Real x758 = x436 * x681 + x439 * x658 + x437 * x683;
  const Real x743 = x436 * tau[27] + x437 * tau[28] + x439 * tau[29];
  const Real x782 = x358 * 0.00067375 + x743;
  // joint 9 "left_elbow": articulated-body inertia and bias force through it
  const Real x791 = x789 * (tau[26] - (x753 - 0.26 * x763 + x600));
  w.x[31] = x791;
  const Real x831 = x748 + 0.26 * x768 + x597 - x735 * x791;
  // joint 10 "left_wrist": articulated-body inertia and bias force through it
  const Real x785 = x374 * 1.1 + x385 * 0.132 + x758;
  // joint 9 "left_elbow": articulated-body inertia and bias force through it
  const Real x834 = x785 - x725 * x791;
  // joint 10 "left_wrist": articulated-body inertia and bias force through it
  const Real x786 = x378 * 1.1 - x389 * 0.132 + x763;
  // joint 9 "left_elbow": articulated-body inertia and bias force through it
  const Real x836 = x786 + x778 * x791;
  // link 9 "left_upper_arm": mobility from its articulated-body inertia
  const Real x1035 = x1032 * x1033;
  const Real x1059 = x999 * x1003 + x1057 - x1032 * x1034;
  const Real x1087 = x948 + x946 * x968;
  const Real x1061 = x1059 * x1060;
  const Real x1073 = x938 - x893 * x951 - x966 * x971;
  const Real x1097 = x949 + x946 * x969 + x1001 * x1087;
  const Real x1102 = x969 + x968 * x1001;
  const Real x1075 = x1073 - x999 * x1005 - x1032 * x1035;
  const Real x1076 = x1075 - x1059 * x1061;
  w.x[32] = x1076;
  const Real x1166 = x946 * x967;
  const Real x1077 = 1 / x1076;
  w.x[33] = x1077;
  w.to[1][20] = x1077;
  const Real x1113 = x950 + x946 * x970 + x1003 * x1087;
  const Real x1115 = x1034 * x1097 - x1113;
  const Real x1123 = x1034 * x1102 - (x970 + x968 * x1003);
  const Real x1126 = x1003 - x1001 * x1034;
  const Real x1167 = x1000 * x1087;
  const Real x1169 = x968 * x1000;
  const Real x1139 = x1005 * x1087 - (x951 + x946 * x971);
  // joint 10 "left_wrist": articulated-body inertia and bias force through it
  const Real x787 = x368 * 1.1 - x398 * 0.132 + x768;
  // joint 9 "left_elbow": articulated-body inertia and bias force through it
  const Real x839 = x787 - x727 * x791;
  const Real x924 = sine[0] * x834 + cosine[0] * x836;
  // link 9 "left_upper_arm": force that the reference field takes
  const Real x558 = x275 * 0.050615200000000006 - x328 * 0.048691450000000004 + x309 * 0.266;
  // joint 9 "left_elbow": articulated-body inertia and bias force through it
  const Real x927 = sine[0] * x782 + cosine[0] * x831 + 0.29 * x839;
  const Real x939 = x558 + x927;
  // link 9 "left_upper_arm": force that the reference field takes
  const Real x573 = x314 * 1.9 + x331 * 0.266;
  // joint 9 "left_elbow": articulated-body inertia and bias force through it
  const Real x944 = cosine[0] * x834 - sine[0] * x836 + x573;
  // link 9 "left_upper_arm": mobility from its articulated-body inertia
  const Real x1171 = x1033 * x1097;
  const Real x1173 = x1033 * x1102;
  const Real x1175 = x1001 * x1033;
  const Real x1141 = x1035 * x1097 + x1139 - x1061 * x1115;
  const Real x1150 = x968 * x1005 - x971 + x1035 * x1102;
  const Real x1151 = x1150 - x1061 * x1123;
  const Real x1159 = x1005 + x1001 * x1035 + x1061 * x1126;
  const Real x1164 = x1034 * x1061 - x1035;
  const Real x1176 = x1060 * x1115;
  const Real x1177 = x1060 * x1123;
  const Real x1178 = x1060 * x1126;
  const Real x1179 = x1034 * x1060;
  const Real x1181 = x1077 * x1141;
  w.x[34] = x1181;
  w.to[1][5] = x1181;
  const Real x1182 = x1077 * x1151;
  w.x[35] = x1182;
  w.to[1][10] = x1182;
  const Real x1183 = x1077 * x1159;
  w.x[36] = x1183;
  const Real x1185 = x1077 * x1164;
  w.x[37] = x1185;
  w.to[1][17] = x1185;
  const Real x1186 = x1061 * x1077;
  w.x[38] = x1186;
  const Real x1196 = x945 + x946 * x1166 + x1087 * x1167;
  const Real x1207 = x1166 + x1087 * x1169 + x1097 * x1173;
  const Real x1198 = x1097 * x1171 + x1196 + x1115 * x1176;
  const Real x1199 = x1141 * x1181 + x1198;
  w.x[39] = x1199;
  w.to[1][0] = x1199;
  const Real x1209 = x1115 * x1177 + x1207 + x1141 * x1182;
  w.x[40] = x1209;
  w.to[1][1] = x1209;
  const Real x1217 = x1115 * x1178 - (x1167 + x1097 * x1175);
  const Real x1218 = x1217 - x1141 * x1183;
  w.x[41] = x1218;
  w.to[1][2] = x1218;
  const Real x1224 = x1141 * x1185 - (x1171 + x1115 * x1179);
  w.x[42] = x1224;
  w.to[1][3] = x1224;
  const Real x1227 = x1176 - x1141 * x1186;
  w.x[43] = x1227;
  w.to[1][4] = x1227;
  const Real x1235 = x967 + x968 * x1169 + x1102 * x1173;
  // link 9 "left_upper_arm": force that the reference field takes
  const Real x561 = x280 * 0.050615200000000006 + x333 * 0.048691450000000004 - x304 * 0.266;
  // joint 9 "left_elbow": articulated-body inertia and bias force through it
  const Real x940 = tau[26] - 0.29 * x924 + x561;
  const Real x941 = cosine[0] * x782 - sine[0] * x831 + x285 * 0.00192375;
  const Real x942 = x304 * 1.9 - x335 * 0.266 + x924;
  const Real x943 = x309 * 1.9 - x329 * 0.266 + x839;
  // link 9 "left_upper_arm": mobility from its articulated-body inertia
  const Real x1237 = x1123 * x1177 + x1235 + x1151 * x1182;
  w.x[44] = x1237;
  w.to[1][6] = x1237;
  const Real x1245 = x1123 * x1178 - (x1169 + x1102 * x1175);
  const Real x1246 = x1245 - x1151 * x1183;
  w.x[45] = x1246;
  w.to[1][7] = x1246;
  const Real x1252 = x1151 * x1185 - (x1173 + x1123 * x1179);
  w.x[46] = x1252;
  w.to[1][8] = x1252;
  const Real x1255 = x1177 - x1151 * x1186;
  w.x[47] = x1255;
  w.to[1][9] = x1255;
  const Real x1261 = x1000 + x1001 * x1175 + x1126 * x1178;
  const Real x1262 = x1159 * x1183 + x1261;
  w.x[48] = x1262;
  w.to[1][11] = x1262;
  const Real x1268 = x1175 - x1126 * x1179 - x1159 * x1185;
  w.x[49] = x1268;
  w.to[1][12] = x1268;
  const Real x1271 = x1178 + x1159 * x1186;
  w.x[50] = x1271;
  w.to[1][13] = x1271;
  const Real x1276 = x1033 + x1034 * x1179 + x1164 * x1185;
  w.x[51] = x1276;
  w.to[1][15] = x1276;
  const Real x1279 = x1179 + x1164 * x1186;
  w.x[52] = x1279;
  const Real x1283 = x1060 + x1061 * x1186;
  w.x[53] = x1283;
  w.to[1][18] = x1283;
  const Real x1291 = x939 * x1199 + x944 * x1181 + x940 * x1209;
  const Real x1302 = x939 * x1209 + x944 * x1182 + x940 * x1237;
  const Real x1314 = x939 * x1218 - x944 * x1183 + x940 * x1246;
  const Real x1326 = x939 * x1224 + x944 * x1185 + x940 * x1252;
  const Real x1339 = x939 * x1227 - x944 * x1186 + x940 * x1255;
  const Real x1352 = x939 * x1181 + x944 * x1077 + x940 * x1182;
  const Real x1293 = x941 * x1218 + x1291 + x942 * x1224;
  const Real x1294 = x943 * x1227 + x1293;
  w.x[54] = x1294;
  const Real x1184 = -x1183;
  w.to[1][14] = x1184;
  const Real x1304 = x941 * x1246 + x1302 + x942 * x1252;
  const Real x1305 = x943 * x1255 + x1304;
  w.x[55] = x1305;
  const Real x1187 = -x1186;
  w.to[1][19] = x1187;
  const Real x1316 = x941 * x1262 + x1314 + x942 * x1268;
  const Real x1317 = x943 * x1271 + x1316;
  w.x[56] = x1317;
  const Real x1280 = -x1279;
  w.to[1][16] = x1280;
  const Real x1328 = x941 * x1268 + x1326 + x942 * x1276;
  const Real x1329 = x1328 - x943 * x1279;
  w.x[57] = x1329;
  const Real x1341 = x941 * x1271 + x1339 - x942 * x1279;
  const Real x1342 = x943 * x1283 + x1341;
  w.x[58] = x1342;
  const Real x1354 = x1352 - x941 * x1183 + x942 * x1185;
  const Real x1355 = x1354 - x943 * x1186;
  w.x[59] = x1355;
  const Real x1356 = -x1294;
  w.to[1][21] = x1356;
  const Real x1357 = -x1305;
  w.to[1][22] = x1357;
  const Real x1358 = -x1317;
  w.to[1][23] = x1358;
  const Real x1359 = -x1329;
  w.to[1][24] = x1359;
  const Real x1360 = -x1342;
  w.to[1][25] = x1360;
  const Real x1361 = -x1355;
  w.to[1][26] = x1361;
}

ADAGEN_NOINLINE void part_3_1(Workspace& w) {
  ADAGEN_INPUTS
  const Real x280 = w.x[14];
  const Real x358 = w.x[15];
  const Real x361 = w.x[19];
  const Real x428 = w.x[2];
  const Real x435 = w.x[4];
  const Real x439 = w.x[8];
  const Real x445 = w.x[20];
  const Real x450 = w.x[21];
  const Real x456 = w.x[22];
  const Real x457 = w.x[23];
  const Real x933 = w.x[13];
  const Real x935 = w.x[16];
  const Real x936 = w.x[24];
  const Real x937 = w.x[28];
  const Real x938 = w.x[29];
  const Real x954 = w.x[17];
  const Real x977 = w.x[18];
  const Real x1014 = w.x[25];
  const Real x1047 = w.x[30];
  const Real x1076 = w.x[32];
  // joint 0 "root": placement, velocity and reference acceleration of its link
  const Real x20 = q[3] * q[3] + q[4] * q[4] + q[5] * q[5];
  const Real x21 = q[6] * q[6] + x20;
  require_length(w, x21, 0);
  // joint 10 "left_wrist": placement, velocity and reference acceleration of its link
  const Real x473 = x358 * x439 + x280 * x435 + x361 * x428;
  // link 11 "left_hand": force that the reference field takes
  const Real x634 = (v[28] * x445 - v[27] * x450 + x473) * 0.0002555;
  // joint 10 "left_wrist": articulated-body inertia and bias force through it
  const Real x670 = 3913.894324853229 * (tau[29] - (x634 - x456 * x457 * 0.00019249999999999996));
  w.x[60] = x670;
  // link 9 "left_upper_arm": mobility from its articulated-body inertia
  const Real x1082 = x937 * 1.7763568394002505e-15;
  require_more(w, x1047, x1082, kFactorization, 8);
  const Real x1080 = x935 * 1.7763568394002505e-15;
  require_more(w, x977, x1080, kFactorization, 8);
  const Real x1081 = x936 * 1.7763568394002505e-15;
  require_more(w, x1014, x1081, kFactorization, 8);
  const Real x1083 = x938 * 1.7763568394002505e-15;
  require_more(w, x1076, x1083, kFactorization, 8);
  const Real x1079 = x933 * 1.7763568394002505e-15;
  require_more(w, x954, x1079, kFactorization, 8);
}

ADAGEN_NOINLINE void part_3_2(Workspace& w) {
  ADAGEN_INPUTS
  const Real x422 = w.x[6];
  const Real x425 = w.x[0];
  const Real x428 = w.x[2];
  const Real x429 = w.x[1];
  const Real x432 = w.x[7];
  const Real x435 = w.x[4];
  const Real x436 = w.x[3];
  const Real x437 = w.x[5];
  const Real x439 = w.x[8];
  const Real x668 = w.x[27];
  const Real x669 = w.x[26];
  const Real x670 = w.x[60];
  const Real x791 = w.x[31];
  const Real x792 = w.x[9];
  const Real x794 = w.x[11];
  const Real x796 = w.x[12];
  const Real x797 = w.x[10];
  const Real x1077 = w.x[33];
  const Real x1181 = w.x[34];
  const Real x1182 = w.x[35];
  const Real x1183 = w.x[36];
  const Real x1185 = w.x[37];
  const Real x1186 = w.x[38];
  const Real x1199 = w.x[39];
  const Real x1209 = w.x[40];
  const Real x1218 = w.x[41];
  const Real x1224 = w.x[42];
  const Real x1227 = w.x[43];
  const Real x1237 = w.x[44];
  const Real x1246 = w.x[45];
  const Real x1252 = w.x[46];
  const Real x1255 = w.x[47];
  const Real x1262 = w.x[48];
  const Real x1268 = w.x[49];
  const Real x1271 = w.x[50];
  const Real x1276 = w.x[51];
  const Real x1279 = w.x[52];
  const Real x1283 = w.x[53];
  const Real x1294 = w.x[54];
  const Real x1305 = w.x[55];
  const Real x1317 = w.x[56];
  const Real x1329 = w.x[57];
  const Real x1342 = w.x[58];
  const Real x1355 = w.x[59];
  // message received
  const Real x1362 = w.from[5][0];
  const Real x1367 = w.from[5][5];
  const Real x1363 = w.from[5][1];
  const Real x1364 = w.from[5][2];
  const Real x1365 = w.from[5][3];
  const Real x1366 = w.from[5][4];
  // link 9 "left_upper_arm": acceleration under the handle forces
  const Real x1375 = x1199 * x1362 + x1181 * x1367 + x1209 * x1363;
  const Real x1386 = x1209 * x1362 + x1182 * x1367 + x1237 * x1363;
  const Real x1398 = x1218 * x1362 - x1183 * x1367 + x1246 * x1363;
  const Real x1410 = x1224 * x1362 + x1185 * x1367 + x1252 * x1363;
  const Real x1436 = x1181 * x1362 + x1077 * x1367 + x1182 * x1363;
  const Real x1423 = x1227 * x1362 - x1186 * x1367 + x1255 * x1363;
  const Real x1377 = x1218 * x1364 + x1375 + x1224 * x1365;
  const Real x1388 = x1246 * x1364 + x1386 + x1252 * x1365;
  const Real x1400 = x1262 * x1364 + x1398 + x1268 * x1365;
  const Real x1412 = x1268 * x1364 + x1410 + x1276 * x1365;
  const Real x1438 = x1436 - x1183 * x1364 + x1185 * x1365;
  const Real x1440 = x1227 * x1366 + x1377 - x1294;
  const Real x1441 = x1255 * x1366 + x1388 - x1305;
  const Real x1442 = x1271 * x1366 + x1400 - x1317;
  const Real x1425 = x1271 * x1364 + x1423 - x1279 * x1365;
  const Real x1445 = x1438 - x1186 * x1366 - x1355;
  // joint 9 "left_elbow": its acceleration, and that of the link beyond
  const Real x1448 = x1412 - x1279 * x1366 - x1329 - 0.29 * x1441;
  const Real x1457 = cosine[0] * x1440 - sine[0] * x1442;
  const Real x1450 = x1283 * x1366 + x1425 - x1342 + 0.29 * x1440;
  const Real x1453 = cosine[0] * x1442 + sine[0] * x1440;
  const Real x1460 = cosine[0] * x1445 + sine[0] * x1448;
  const Real x1464 = cosine[0] * x1448 - sine[0] * x1445;
  const Real x1474 = x791 + x792 * x1457 + x797 * x1450;
  const Real x1476 = x794 * x1460 + x1474 - x796 * x1464;
  const Real x1477 = x1476 - x1441;
  w.result[26] = x1477;
  // joint 10 "left_wrist": its acceleration, and that of the link beyond
  const Real x1482 = x1450 + 0.26 * x1457;
  const Real x1480 = x1464 - 0.26 * x1476;
  const Real x1497 = x439 * x1453 + x428 * x1457 + x435 * x1476;
  const Real x1522 = x670 - x1497;
  w.result[29] = x1522;
  const Real x1502 = x436 * x1460 + x429 * x1482 + x422 * x1480;
  const Real x1507 = x437 * x1460 + x432 * x1482 + x425 * x1480;
  const Real x1492 = x437 * x1453 + x425 * x1457 + x432 * x1476;
  const Real x1521 = x669 + x1502 * 9.00562851782364 - x1492;
  w.result[28] = x1521;
  const Real x1487 = x436 * x1453 + x422 * x1457 + x429 * x1476;
  const Real x1520 = x668 - 8.56378233719893 * x1507 - x1487;
  w.result[27] = x1520;
}

// ---- 5. processes -------------------------------------------------------------------------------

// Process 0: 6 of 15 joints: "root", "left_hip", "right_hip", "right_knee", "right_ankle", "spine"
constexpr std::array<int, 6> kRead_0{0, 1, 4, 5, 6, 7};
constexpr std::array<int, 6> kOwned_0{0, 1, 4, 5, 6, 7};

void run_0([[maybe_unused]] Workspace& w, [[maybe_unused]] Channel& channel) {
  ADAGEN_INPUTS
  stamp(0);
  if (!all(unlike_zero(q + 0, 11) + unlike_zero(q + 16, 13) + unlike_zero(v + 0, 9) + unlike_zero(v + 13, 10) + unlike_zero(tau + 0, 9) + unlike_zero(tau + 13, 10) == 0))
    name_what_is_not_finite(w, kRead_0, kOwned_0);
  w.to[3] = channel.outgoing(3, w.status);
  w.to[4] = channel.outgoing(4, w.status);
  w.angle[0] = q[20];
  take_sines_and_cosines<1>(w.angle.data(), w.sine.data(), w.cosine.data());
  w.to[3][0] = tau[20];
  w.to[3][1] = tau[21];
  w.to[3][2] = tau[22];
  w.to[4][0] = tau[6];
  w.to[4][1] = tau[7];
  w.to[4][2] = tau[8];
  part_0_0(w);
  part_0_1(w);
  stamp(1);
  stamp(2);
  w.from[0] = channel.receive(0, w.status);  // from process 1: assembled: chain of "left_knee"
  stamp(3);
  part_0_2(w);
  stamp(4);
  w.from[2] = channel.receive(2, w.status);  // from process 2: assembled: chain of "left_shoulder"
  stamp(5);
  part_0_3(w);
  stamp(6);
  stamp(7);
  channel.send(3, w.status);  // to process 2: forces on: chain of "left_shoulder"
  stamp(8);
  part_0_4(w);
  stamp(9);
  channel.send(4, w.status);  // to process 1: forces on: chain of "left_knee"
  stamp(10);
  part_0_5(w);
  stamp(11);
  if (!all(unlike_zero(w.result.data() + 0, 9) + unlike_zero(w.result.data() + 13, 10) == 0)) name_what_overflows(w, kOwned_0);
  if (w.status != kFine) return;
  std::copy_n(w.result.data() + 0, 9, w.qdd + 0);
  std::copy_n(w.result.data() + 13, 10, w.qdd + 13);
}

// Process 1: 2 of 15 joints: "left_knee", "left_ankle"; kinematics of 2 more on the way to the ground
constexpr std::array<int, 4> kRead_1{0, 1, 2, 3};
constexpr std::array<int, 2> kOwned_1{2, 3};

void run_1([[maybe_unused]] Workspace& w, [[maybe_unused]] Channel& channel) {
  ADAGEN_INPUTS
  stamp(0);
  if (!all(unlike_zero(q + 0, 16) + unlike_zero(v + 0, 13) + unlike_zero(tau + 9, 4) == 0))
    name_what_is_not_finite(w, kRead_1, kOwned_1);
  w.to[0] = channel.outgoing(0, w.status);
  w.angle[0] = q[11];
  take_sines_and_cosines<1>(w.angle.data(), w.sine.data(), w.cosine.data());
  part_1_0(w);
  stamp(1);
  stamp(2);
  channel.send(0, w.status);  // to process 0: assembled: chain of "left_knee"
  stamp(3);
  part_1_1(w);
  w.from[4] = channel.receive(4, w.status);  // from process 0: forces on: chain of "left_knee"
  stamp(4);
  part_1_2(w);
  stamp(5);
  if (!all(unlike_zero(w.result.data() + 9, 4) == 0)) name_what_overflows(w, kOwned_1);
  if (w.status != kFine) return;
  std::copy_n(w.result.data() + 9, 4, w.qdd + 9);
}

// Process 2: 5 of 15 joints: "left_shoulder", "neck", "right_shoulder", "right_elbow", "right_wrist"; kinematics of 2 more on the way to the ground
constexpr std::array<int, 7> kRead_2{0, 7, 8, 11, 12, 13, 14};
constexpr std::array<int, 5> kOwned_2{8, 11, 12, 13, 14};

void run_2([[maybe_unused]] Workspace& w, [[maybe_unused]] Channel& channel) {
  ADAGEN_INPUTS
  stamp(0);
  if (!all(unlike_zero(q + 0, 7) + unlike_zero(q + 25, 8) + unlike_zero(q + 38, 13) + unlike_zero(v + 0, 6) + unlike_zero(v + 20, 6) + unlike_zero(v + 30, 10) + unlike_zero(tau + 23, 3) + unlike_zero(tau + 30, 10) == 0))
    name_what_is_not_finite(w, kRead_2, kOwned_2);
  w.to[2] = channel.outgoing(2, w.status);
  w.to[5] = channel.outgoing(5, w.status);
  w.angle[0] = q[46];
  take_sines_and_cosines<1>(w.angle.data(), w.sine.data(), w.cosine.data());
  w.to[5][0] = tau[23];
  w.to[5][1] = tau[24];
  w.to[5][2] = tau[25];
  part_2_0(w);
  part_2_1(w);
  stamp(1);
  stamp(2);
  w.from[1] = channel.receive(1, w.status);  // from process 3: assembled: chain of "left_elbow"
  stamp(3);
  part_2_2(w);
  stamp(4);
  channel.send(2, w.status);  // to process 0: assembled: chain of "left_shoulder"
  stamp(5);
  part_2_3(w);
  w.from[3] = channel.receive(3, w.status);  // from process 0: forces on: chain of "left_shoulder"
  stamp(6);
  part_2_4(w);
  stamp(7);
  channel.send(5, w.status);  // to process 3: forces on: chain of "left_elbow"
  stamp(8);
  part_2_5(w);
  stamp(9);
  if (!all(unlike_zero(w.result.data() + 23, 3) + unlike_zero(w.result.data() + 30, 10) == 0)) name_what_overflows(w, kOwned_2);
  if (w.status != kFine) return;
  std::copy_n(w.result.data() + 23, 3, w.qdd + 23);
  std::copy_n(w.result.data() + 30, 10, w.qdd + 30);
}

// Process 3: 2 of 15 joints: "left_elbow", "left_wrist"; kinematics of 3 more on the way to the ground
constexpr std::array<int, 5> kRead_3{0, 7, 8, 9, 10};
constexpr std::array<int, 2> kOwned_3{9, 10};

void run_3([[maybe_unused]] Workspace& w, [[maybe_unused]] Channel& channel) {
  ADAGEN_INPUTS
  stamp(0);
  if (!all(unlike_zero(q + 0, 7) + unlike_zero(q + 25, 13) + unlike_zero(v + 0, 6) + unlike_zero(v + 20, 10) + unlike_zero(tau + 26, 4) == 0))
    name_what_is_not_finite(w, kRead_3, kOwned_3);
  w.to[1] = channel.outgoing(1, w.status);
  w.angle[0] = q[33];
  take_sines_and_cosines<1>(w.angle.data(), w.sine.data(), w.cosine.data());
  part_3_0(w);
  stamp(1);
  stamp(2);
  channel.send(1, w.status);  // to process 2: assembled: chain of "left_elbow"
  stamp(3);
  part_3_1(w);
  w.from[5] = channel.receive(5, w.status);  // from process 2: forces on: chain of "left_elbow"
  stamp(4);
  part_3_2(w);
  stamp(5);
  if (!all(unlike_zero(w.result.data() + 26, 4) == 0)) name_what_overflows(w, kOwned_3);
  if (w.status != kFine) return;
  std::copy_n(w.result.data() + 26, 4, w.qdd + 26);
}

[[maybe_unused]] constexpr std::array<void (*)(Workspace&, Channel&), kProcesses> kRun{run_0, run_1, run_2, run_3};

// What each process reads of q and v, the velocity entries whose qdd is its own, and whose tau it
// reads.
constexpr std::array<Range, 2> kReadQ_0{ {{0, 11}, {16, 13}} };
constexpr std::array<Range, 2> kReadV_0{ {{0, 9}, {13, 10}} };
constexpr std::array<Range, 2> kOwn_0{ {{0, 9}, {13, 10}} };
constexpr std::array<Range, 2> kTorque_0{ {{0, 9}, {13, 10}} };
constexpr std::array<Range, 1> kReadQ_1{ {{0, 16}} };
constexpr std::array<Range, 1> kReadV_1{ {{0, 13}} };
constexpr std::array<Range, 1> kOwn_1{ {{9, 4}} };
constexpr std::array<Range, 1> kTorque_1{ {{9, 4}} };
constexpr std::array<Range, 3> kReadQ_2{ {{0, 7}, {25, 8}, {38, 13}} };
constexpr std::array<Range, 3> kReadV_2{ {{0, 6}, {20, 6}, {30, 10}} };
constexpr std::array<Range, 2> kOwn_2{ {{23, 3}, {30, 10}} };
constexpr std::array<Range, 2> kTorque_2{ {{23, 3}, {30, 10}} };
constexpr std::array<Range, 2> kReadQ_3{ {{0, 7}, {25, 13}} };
constexpr std::array<Range, 2> kReadV_3{ {{0, 6}, {20, 10}} };
constexpr std::array<Range, 1> kOwn_3{ {{26, 4}} };
constexpr std::array<Range, 1> kTorque_3{ {{26, 4}} };
[[maybe_unused]] constexpr std::array<ProcessInfo, kProcesses> kProcess{ {
    {{2, kReadQ_0.data()}, {2, kReadV_0.data()}, {2, kOwn_0.data()}, {2, kTorque_0.data()}},
    {{1, kReadQ_1.data()}, {1, kReadV_1.data()}, {1, kOwn_1.data()}, {1, kTorque_1.data()}},
    {{3, kReadQ_2.data()}, {3, kReadV_2.data()}, {2, kOwn_2.data()}, {2, kTorque_2.data()}},
    {{2, kReadQ_3.data()}, {2, kReadV_3.data()}, {1, kOwn_3.data()}, {1, kTorque_3.data()}},
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

struct human40_p4_solver : Solver {};

extern "C" {

int human40_p4_joint(int k, const char** name, int* q, int* nq, int* v, int* nv) {
  if (k < 0 || k >= kJointCount) return 0;
  const JointConstants& joint = kJoints[k];
  *name = joint.name, *q = joint.q, *nq = joint.nq, *v = joint.v, *nv = joint.nv;
  return 1;
}

human40_p4_solver* human40_p4_open(MPI_Comm comm, const char* channel, double time_limit) {
  int size = 0;
  MPI_Comm_size(comm, &size);
  const std::string kind = channel;
  if (size != kProcesses || (kind != "auto" && kind != "window" && kind != "message")) return nullptr;
  auto* const solver = new human40_p4_solver;
  const ChannelMode mode = kind == "window"    ? ChannelMode::kWindow
                           : kind == "message" ? ChannelMode::kMessage
                                               : ChannelMode::kAuto;
  if (solver->channel.open(comm, mode, time_limit).empty()) return solver;
  human40_p4_close(solver);
  return nullptr;
}

int human40_p4_solve(human40_p4_solver* solver, const double* q, const double* v, const double* tau, double* qdd) {
  return solver->solve(q, v, tau, qdd);
}

int human40_p4_solve_at_root(human40_p4_solver* solver, const double* q, const double* v, const double* tau, double* qdd) {
  return solver->solve_at_root(q, v, tau, qdd);
}

const char* human40_p4_failure(const human40_p4_solver* solver) { return solver->text.c_str(); }

void human40_p4_close(human40_p4_solver* solver) {
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
constexpr std::array<Stage, 11> kStages_0{ {
    {"kinematics", 7, -1},
    {"assembly", 4, -1},
    {"receive", -1, 0},
    {"assembly", 1, -1},
    {"receive", -1, 2},
    {"assembly", 7, -1},
    {"disassembly", 7, -1},
    {"send", -1, 3},
    {"disassembly", 1, -1},
    {"send", -1, 4},
    {"disassembly", 4, -1},
} };
constexpr std::array<Stage, 5> kStages_1{ {
    {"kinematics", 3, -1},
    {"assembly", 2, -1},
    {"send", -1, 0},
    {"receive", -1, 4},
    {"disassembly", 2, -1},
} };
constexpr std::array<Stage, 9> kStages_2{ {
    {"kinematics", 14, -1},
    {"assembly", 11, -1},
    {"receive", -1, 1},
    {"assembly", 8, -1},
    {"send", -1, 2},
    {"receive", -1, 3},
    {"disassembly", 8, -1},
    {"send", -1, 5},
    {"disassembly", 11, -1},
} };
constexpr std::array<Stage, 5> kStages_3{ {
    {"kinematics", 10, -1},
    {"assembly", 9, -1},
    {"send", -1, 1},
    {"receive", -1, 5},
    {"disassembly", 9, -1},
} };
constexpr std::array<const Stage*, kProcesses> kStages{kStages_0.data(), kStages_1.data(), kStages_2.data(), kStages_3.data()};
constexpr std::array<int, kProcesses> kStageCount{11, 5, 9, 5};

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
