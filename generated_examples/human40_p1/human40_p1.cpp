// Forward dynamics of "human40" on 1 process, emitted by adagen 0.1.0 (solver.cpp.j2). Do not edit: emit anew.
//
// robot     "human40", 15 joints, 40 degrees of freedom, description sha256 bdc16488e5ef4610f46ad114b2f2b09a8601d7b212cf0d9aa1794a195cd4ce35
// options   form ada, shape unrolled, scalar double, channel auto, fixed base, gravity 0.0, 0.0, -9.81
// program   1 process; 1.25 us predicted (default profile)
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
//   6. program     states in, accelerations out; check; time

#include <mpi.h>

// ---- 1. interface -------------------------------------------------------------------------------
// To use it from a program of yours: compile this file with -DADAGEN_NO_MAIN, link it, and get these
// declarations by including it with ADAGEN_DECLARATIONS defined.
#ifdef __cplusplus
extern "C" {
#endif
typedef struct human40_p1_solver human40_p1_solver;

// Joints in order, each with its place in the state: human40_p1_joint gives name, start and size in q
// and v of joint k, or returns 0 where there is none.
int human40_p1_joint(int k, const char** name, int* q, int* nq, int* v, int* nv);

// Collective over a communicator of 1 process. channel: "auto", "window" or "message";
// time_limit: seconds that a process waits for another. Returns null where it cannot be done.
human40_p1_solver* human40_p1_open(MPI_Comm comm, const char* channel, double time_limit);

// One evaluation, collective. q: 51 numbers, v and tau: 40 each, qdd: 40; joints in order,
// quaternions x y z w (normalised here), floating joints [linear; angular] in the body's frame.
// solve: every process passes the state and gets its own joints' accelerations (others untouched);
// solve_at_root: process 0 passes the state and gets them all, the others may pass null.
// Returns 0, or what human40_p1_failure puts into words; no acceleration is written then.
int human40_p1_solve(human40_p1_solver* solver, const double* q, const double* v, const double* tau, double* qdd);
int human40_p1_solve_at_root(human40_p1_solver* solver, const double* q, const double* v, const double* tau, double* qdd);

// The last failure in words; valid until the next call.
const char* human40_p1_failure(const human40_p1_solver* solver);

// Collective.
void human40_p1_close(human40_p1_solver* solver);
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
constexpr int kProcesses = 1;
constexpr int kJointCount = 15, kLinkCount = kJointCount + 1;
constexpr int kNq = 51, kNv = 40;
constexpr int kOuterCount = 0, kNtau = kNv + 6 * kOuterCount;
[[maybe_unused]] constexpr int kColumns = 1;  // right-hand sides: the motion, and one per slaved joint
[[maybe_unused]] constexpr bool kBatch = false;  // whether many states are solved at once
[[maybe_unused]] constexpr int kRefine = 0;  // steps of iterative refinement
[[maybe_unused]] constexpr int kPlanMessages = 0;
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

constexpr std::array<MessageInfo, 0> kMessages{ {
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
  alignas(kCacheLine) std::array<Value, 4> angle{}, sine{}, cosine{};
  std::array<Value, kNv> result{};
  std::array<Real*, kPlanMessages> to{};          // messages to be sent
  std::array<const Real*, kPlanMessages> from{};  // messages received
  alignas(kCacheLine) std::array<Value, 843> x{};
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
// Process 0: 5910 products, 4591 sums, 61 quotients
// =================================================================================================

ADAGEN_NOINLINE void part_0_0(Workspace& w) {
  ADAGEN_INPUTS
  // joint 0 "root": placement, velocity and reference acceleration of its link
  const Real x20 = q[3] * q[3] + q[4] * q[4] + q[5] * q[5];
  const Real x21 = q[6] * q[6] + x20;
  require_length(w, x21, 0);
  const Real x24 = 1 / x21 * 2.0;
  const Real x25 = q[3] * x24;
  const Real x26 = q[4] * x24;
  const Real x52 = (q[5] * x25 - q[6] * x26) * 9.81;
  const Real x59 = v[2] * v[4] - v[1] * v[5] + x52;
  w.x[0] = x59;
  const Real x53 = (q[5] * x26 + q[6] * x25) * 9.81;
  const Real x64 = v[0] * v[5] - v[2] * v[3] + x53;
  w.x[1] = x64;
  const Real x54 = (1.0 - (q[4] * x26 + q[3] * x25)) * 9.81;
  const Real x69 = v[1] * v[3] - v[0] * v[4] + x54;
  w.x[2] = x69;
  const Real x70 = v[3] * v[3];
  const Real x75 = v[3] * v[4];
  const Real x78 = v[4] * v[5];
  const Real x79 = x70 + v[4] * v[4];
  const Real x81 = v[3] * v[5];
  // link 1 "pelvis": acceleration where nothing acts on it
  const Real x7198 = x78 * 0.031360000000000006;
  const Real x7201 = x81 * 0.020159999999999987;
  const Real x7208 = x81 * 0.288;
  const Real x7209 = x78 * 0.288;
  const Real x7222 = x7198 * 9.615384615384615 + x7209 * 0.2884615384615385;
  w.x[3] = x7222;
  const Real x7227 = x7201 * 19.054878048780488 - x7208 * 0.5716463414634146;
  w.x[4] = x7227;
  const Real x7228 = x75 * 0.051519999999999996 * 10.813148788927334;
  w.x[5] = x7228;
  const Real x7233 = x7208 * 0.12131605691056911 - x7201 * 0.5716463414634146;
  w.x[6] = x7233;
  const Real x7236 = x7198 * 0.2884615384615385 + x7209 * 0.11282051282051282;
  w.x[7] = x7236;
  const Real x7237 = x79 * 0.288 * 0.10416666666666667;
  w.x[8] = x7237;
  // joint 1 "left_hip": placement, velocity and reference acceleration of its link
  const Real x94 = q[7] * q[7] + q[8] * q[8] + q[9] * q[9];
  const Real x95 = q[10] * q[10] + x94;
  require_length(w, x95, 1);
  const Real x97 = 2.0 * (1 / x95);
  const Real x98 = q[7] * x97;
  const Real x99 = q[8] * x97;
  const Real x100 = q[9] * x97;
  const Real x101 = q[8] * x99;
  const Real x102 = q[9] * x100;
  const Real x104 = 1.0 - (x101 + x102);
  w.x[9] = x104;
  const Real x105 = q[8] * x98;
  const Real x106 = q[10] * x100;
  const Real x107 = x105 - x106;
  w.x[10] = x107;
  const Real x108 = q[9] * x98;
  const Real x109 = q[10] * x99;
  const Real x110 = x108 + x109;
  w.x[11] = x110;
  const Real x111 = x105 + x106;
  w.x[12] = x111;
  const Real x112 = q[7] * x98;
  const Real x114 = 1.0 - (x102 + x112);
  w.x[13] = x114;
  const Real x115 = q[9] * x99;
  const Real x116 = q[10] * x98;
  const Real x117 = x115 - x116;
  w.x[14] = x117;
  const Real x118 = x108 - x109;
  w.x[15] = x118;
  const Real x119 = x115 + x116;
  w.x[16] = x119;
  const Real x121 = 1.0 - (x101 + x112);
  w.x[17] = x121;
  const Real x128 = v[4] * x111 + v[5] * x118 + v[3] * x104;
  const Real x133 = v[3] * x107 + v[5] * x119 + v[4] * x114;
  const Real x138 = v[3] * x110 + v[4] * x117 + v[5] * x121;
  const Real x139 = v[6] + x128;
  const Real x140 = v[7] + x133;
  const Real x141 = v[8] + x138;
  const Real x145 = v[8] * x133 - v[7] * x138;
  const Real x149 = v[6] * x138 - v[8] * x128;
  const Real x153 = v[7] * x128 - v[6] * x133;
  const Real x154 = x75 * 0.09;
  const Real x156 = x81 * 0.04;
  const Real x158 = x154 - x156;
  const Real x159 = (x70 + v[5] * v[5]) * 0.09;
  const Real x161 = x78 * 0.04;
  const Real x163 = x159 + x161;
  const Real x165 = x78 * 0.09;
  const Real x166 = x79 * 0.04;
  const Real x168 = x165 + x166;
  const Real x174 = x118 * x168 - x111 * x163 + x104 * x158;
  const Real x180 = x107 * x158 + x119 * x168 - x114 * x163;
  const Real x186 = x110 * x158 - x117 * x163 + x121 * x168;
  const Real x200 = x140 * x141;
  const Real x201 = x200 - x145;
  const Real x203 = x139 * x139 + x140 * x140;
  const Real x205 = x139 * x141;
  const Real x207 = x149 + x205;
  // link 2 "left_thigh": acceleration where nothing acts on it
  const Real x10862 = x145 * 0.42868 - x200 * 0.4018 + x180 * 1.596;
  const Real x10865 = x149 * 0.42868 + x205 * 0.4018 - x174 * 1.596;
  const Real x10869 = x174 * 8.4 - x207 * 1.596;
  const Real x10873 = x180 * 8.4 - x201 * 1.596;
  const Real x10881 = 7.971938775510204 * x10862 - 1.5146683673469388 * x10873;
  w.x[18] = x10881;
  const Real x10884 = 7.971938775510204 * x10865 + 1.5146683673469388 * x10869;
  w.x[19] = x10884;
  const Real x10885 = 37.20238095238095 * (x153 * 0.02688);
  w.x[20] = x10885;
  const Real x10888 = 1.5146683673469388 * x10865 + 0.40683460884353745 * x10869;
  w.x[21] = x10888;
  const Real x10892 = 0.40683460884353745 * x10873 - 1.5146683673469388 * x10862;
  w.x[22] = x10892;
  const Real x10893 = 0.11904761904761904 * (x186 * 8.4 + x203 * 1.596);
  w.x[23] = x10893;
  // joint 2 "left_knee": placement, velocity and reference acceleration of its link
  const Real x216 = x141 * cosine[0] + x139 * sine[0];
  const Real x220 = x139 * cosine[0] - x141 * sine[0];
  const Real x221 = x140 + v[9];
  const Real x230 = x153 * cosine[0] + x145 * sine[0] + v[9] * x220;
  const Real x233 = x145 * cosine[0] - x153 * sine[0] - v[9] * x216;
  const Real x237 = x174 - x207 * 0.41;
  const Real x240 = x180 - x201 * 0.41;
  const Real x243 = x186 + x203 * 0.41;
  const Real x246 = cosine[0] * x243 + sine[0] * x237;
  const Real x250 = cosine[0] * x237 - sine[0] * x243;
  const Real x257 = x220 * x220 + x221 * x221;
  const Real x259 = x216 * x220;
  const Real x261 = x149 + x259;
  const Real x269 = x216 * x221;
  const Real x270 = x269 - x233;
  // link 3 "left_shank": acceleration where nothing acts on it
  const Real x10163 = x233 * 0.1483467 - x269 * 0.1443467 + x240 * 0.576;
  const Real x10166 = x149 * 0.1483467 + x259 * 0.1443467 - x250 * 0.576;
  const Real x10174 = x250 * 3.2 - x261 * 0.576;
  const Real x10178 = x240 * 3.2 - x270 * 0.576;
  const Real x10179 = 250.0 * (x230 * 0.004);
  w.x[24] = x10179;
  const Real x10183 = 22.388042993997768 * x10163 - 4.029847738919598 * x10178;
  w.x[25] = x10183;
  const Real x10186 = 22.388042993997768 * x10166 + 4.029847738919598 * x10174;
  w.x[26] = x10186;
  const Real x10187 = 0.3125 * (x246 * 3.2 + x257 * 0.576);
  w.x[27] = x10187;
  const Real x10190 = 4.029847738919598 * x10166 + 1.0378725930055277 * x10174;
  w.x[28] = x10190;
  const Real x10194 = 1.0378725930055277 * x10178 - 4.029847738919598 * x10163;
  w.x[29] = x10194;
  // joint 3 "left_ankle": placement, velocity and reference acceleration of its link
  const Real x284 = q[12] * q[12] + q[13] * q[13] + q[14] * q[14];
  const Real x285 = q[15] * q[15] + x284;
  require_length(w, x285, 3);
  const Real x287 = 2.0 * (1 / x285);
  const Real x288 = q[12] * x287;
  const Real x289 = q[13] * x287;
  const Real x290 = q[14] * x287;
  const Real x291 = q[13] * x289;
  const Real x292 = q[14] * x290;
  const Real x294 = 1.0 - (x291 + x292);
  w.x[30] = x294;
  const Real x295 = q[13] * x288;
  const Real x296 = q[15] * x290;
  const Real x297 = x295 - x296;
  w.x[31] = x297;
  const Real x298 = q[14] * x288;
  const Real x299 = q[15] * x289;
  const Real x300 = x298 + x299;
  w.x[32] = x300;
  const Real x301 = x295 + x296;
  w.x[33] = x301;
  const Real x302 = q[12] * x288;
  const Real x304 = 1.0 - (x292 + x302);
  w.x[34] = x304;
  const Real x305 = q[14] * x289;
  const Real x306 = q[15] * x288;
  const Real x307 = x305 - x306;
  w.x[35] = x307;
  const Real x308 = x298 - x299;
  w.x[36] = x308;
  const Real x309 = x305 + x306;
  w.x[37] = x309;
  const Real x311 = 1.0 - (x291 + x302);
  w.x[38] = x311;
  const Real x316 = x216 * x308 + x221 * x301 + x220 * x294;
  const Real x321 = x216 * x309 + x221 * x304 + x220 * x297;
  const Real x326 = x216 * x311 + x221 * x307 + x220 * x300;
  const Real x327 = v[10] + x316;
  const Real x328 = v[11] + x321;
  const Real x329 = v[12] + x326;
  const Real x334 = x230 * x308 + x149 * x301 + x233 * x294;
  const Real x349 = v[12] * x321 - v[11] * x326 + x334;
  const Real x339 = x230 * x309 + x149 * x304 + x233 * x297;
  const Real x354 = v[10] * x326 - v[12] * x316 + x339;
  const Real x344 = x230 * x311 + x149 * x307 + x233 * x300;
  const Real x359 = v[11] * x316 - v[10] * x321 + x344;
  const Real x362 = x246 + 0.41 * x257;
  const Real x365 = x250 - 0.41 * x261;
  const Real x368 = x240 - 0.41 * x270;
  const Real x373 = x308 * x362 + x294 * x365 + x301 * x368;
  const Real x378 = x309 * x362 + x297 * x365 + x304 * x368;
  const Real x383 = x311 * x362 + x300 * x365 + x307 * x368;
  const Real x388 = x328 * x328;
  const Real x390 = x388 + x329 * x329;
  const Real x392 = x327 * x328;
  const Real x394 = x359 + x392;
  const Real x397 = x328 * x329;
  const Real x398 = x397 - x349;
  const Real x400 = x327 * x327 + x388;
  const Real x402 = x327 * x329;
  // link 4 "left_foot": acceleration where nothing acts on it
  const Real x10213 = x354 * 0.01081667 - x402 * 0.0068;
  const Real x10207 = x349 * 0.00268333 - x397 * 0.00133334 + x394 * 0.0024;
  const Real x10224 = x10207 + 0.04 * x378;
  const Real x10229 = 0.0024 * (x390 - x400) + x10213 - 0.04 * x373;
  const Real x10230 = x10229 - x383 * 0.06;
  const Real x10221 = x359 * 0.00948333 + x392 * 0.00813334 - x398 * 0.0024;
  const Real x10232 = x10221 + x378 * 0.06;
  const Real x10238 = x373 - x390 * 0.06 - 0.04 * (x354 + x402);
  const Real x10243 = x378 + x394 * 0.06 - 0.04 * x398;
  const Real x10248 = x383 + 0.04 * x400 + (x402 - x354) * 0.06;
  const Real x10252 = 923.0797633223488 * x10224 - 36.92319053289395 * x10243;
  w.x[39] = x10252;
  const Real x10257 = 7.1216574945652855 * x10238 + 10.682486241847927 * x10248 + 178.04143736413212 * x10230;
  w.x[40] = x10257;
  const Real x10261 = 169.97176768938678 * x10232 - 10.198306061363207 * x10243;
  w.x[41] = x10261;
  const Real x10266 = 1.2848662997826115 * x10238 + 0.4272994496739171 * x10248 + 7.1216574945652855 * x10230;
  w.x[42] = x10266;
  const Real x10274 = 3.0888259849975506 * x10243 - (36.92319053289395 * x10224 + 10.198306061363207 * x10232);
  w.x[43] = x10274;
  const Real x10279 = 0.4272994496739171 * x10238 + 1.6409491745108757 * x10248 + 10.682486241847927 * x10230;
  w.x[44] = x10279;
  // joint 4 "right_hip": placement, velocity and reference acceleration of its link
  const Real x417 = q[16] * q[16] + q[17] * q[17] + q[18] * q[18];
  const Real x418 = q[19] * q[19] + x417;
  require_length(w, x418, 4);
  const Real x420 = 2.0 * (1 / x418);
  const Real x421 = q[16] * x420;
  const Real x422 = q[17] * x420;
  const Real x423 = q[18] * x420;
  const Real x424 = q[17] * x422;
  const Real x425 = q[18] * x423;
  const Real x427 = 1.0 - (x424 + x425);
  w.x[45] = x427;
  const Real x428 = q[17] * x421;
  const Real x429 = q[19] * x423;
  const Real x430 = x428 - x429;
  w.x[46] = x430;
  const Real x431 = q[18] * x421;
  const Real x432 = q[19] * x422;
  const Real x433 = x431 + x432;
  w.x[47] = x433;
  const Real x434 = x428 + x429;
  w.x[48] = x434;
  const Real x435 = q[16] * x421;
  const Real x437 = 1.0 - (x425 + x435);
  w.x[49] = x437;
  const Real x438 = q[18] * x422;
  const Real x439 = q[19] * x421;
  const Real x440 = x438 - x439;
  w.x[50] = x440;
  const Real x441 = x431 - x432;
  w.x[51] = x441;
  const Real x442 = x438 + x439;
  w.x[52] = x442;
  const Real x444 = 1.0 - (x424 + x435);
  w.x[53] = x444;
  const Real x450 = v[4] * x434 + v[5] * x441 + v[3] * x427;
  const Real x455 = v[3] * x430 + v[5] * x442 + v[4] * x437;
  const Real x460 = v[3] * x433 + v[4] * x440 + v[5] * x444;
  const Real x461 = v[13] + x450;
  const Real x462 = v[14] + x455;
  const Real x463 = v[15] + x460;
  const Real x467 = v[15] * x455 - v[14] * x460;
  const Real x471 = v[13] * x460 - v[15] * x450;
  const Real x475 = v[14] * x450 - v[13] * x455;
  const Real x477 = x154 + x156;
  const Real x479 = x159 - x161;
  const Real x481 = x166 - x165;
  const Real x487 = x434 * x479 + x441 * x481 - x427 * x477;
  const Real x493 = x442 * x481 - x430 * x477 + x437 * x479;
  const Real x499 = x440 * x479 - x433 * x477 + x444 * x481;
  const Real x513 = x462 * x463;
  const Real x514 = x513 - x467;
  const Real x516 = x461 * x461 + x462 * x462;
  const Real x518 = x461 * x463;
  const Real x520 = x471 + x518;
  // link 5 "right_thigh": acceleration where nothing acts on it
  const Real x8603 = x467 * 0.42868 - x513 * 0.4018 + x493 * 1.596;
  const Real x8606 = x471 * 0.42868 + x518 * 0.4018 - x487 * 1.596;
  const Real x8610 = x487 * 8.4 - x520 * 1.596;
  const Real x8614 = x493 * 8.4 - x514 * 1.596;
  const Real x8628 = x8603 * 7.971938775510204 - x8614 * 1.5146683673469388;
  w.x[54] = x8628;
  const Real x8631 = x8606 * 7.971938775510204 + x8610 * 1.5146683673469388;
  w.x[55] = x8631;
  const Real x8632 = x475 * 0.02688 * 37.20238095238095;
  w.x[56] = x8632;
  const Real x8635 = x8606 * 1.5146683673469388 + x8610 * 0.40683460884353745;
  w.x[57] = x8635;
  const Real x8639 = x8614 * 0.40683460884353745 - x8603 * 1.5146683673469388;
  w.x[58] = x8639;
  const Real x8640 = (x499 * 8.4 + x516 * 1.596) * 0.11904761904761904;
  w.x[59] = x8640;
  // joint 5 "right_knee": placement, velocity and reference acceleration of its link
  const Real x528 = x463 * cosine[1] + x461 * sine[1];
  const Real x532 = x461 * cosine[1] - x463 * sine[1];
  const Real x533 = x462 + v[16];
  const Real x542 = x475 * cosine[1] + x467 * sine[1] + v[16] * x532;
  const Real x545 = x467 * cosine[1] - x475 * sine[1] - v[16] * x528;
  const Real x548 = x487 - 0.41 * x520;
  const Real x551 = x493 - 0.41 * x514;
  const Real x554 = x499 + 0.41 * x516;
  const Real x557 = cosine[1] * x554 + sine[1] * x548;
  const Real x561 = cosine[1] * x548 - sine[1] * x554;
  const Real x568 = x532 * x532 + x533 * x533;
  const Real x570 = x528 * x532;
  const Real x572 = x471 + x570;
  const Real x580 = x528 * x533;
  const Real x581 = x580 - x545;
  // link 6 "right_shank": acceleration where nothing acts on it
  const Real x7843 = x545 * 0.1483467 - x580 * 0.1443467 + x551 * 0.576;
  const Real x7846 = x471 * 0.1483467 + x570 * 0.1443467 - x561 * 0.576;
  const Real x7854 = x561 * 3.2 - x572 * 0.576;
  const Real x7858 = x551 * 3.2 - x581 * 0.576;
  const Real x7865 = x542 * 0.004 * 250.0;
  w.x[60] = x7865;
  const Real x7869 = x7843 * 22.388042993997768 - x7858 * 4.029847738919598;
  w.x[61] = x7869;
  const Real x7872 = x7846 * 22.388042993997768 + x7854 * 4.029847738919598;
  w.x[62] = x7872;
  const Real x7873 = (x557 * 3.2 + x568 * 0.576) * 0.3125;
  w.x[63] = x7873;
  const Real x7876 = x7846 * 4.029847738919598 + x7854 * 1.0378725930055277;
  w.x[64] = x7876;
  const Real x7880 = x7858 * 1.0378725930055277 - x7843 * 4.029847738919598;
  w.x[65] = x7880;
  // joint 6 "right_ankle": placement, velocity and reference acceleration of its link
  const Real x595 = q[21] * q[21] + q[22] * q[22] + q[23] * q[23];
  const Real x596 = q[24] * q[24] + x595;
  require_length(w, x596, 6);
  const Real x598 = 2.0 * (1 / x596);
  const Real x599 = q[21] * x598;
  const Real x600 = q[22] * x598;
  const Real x601 = q[23] * x598;
  const Real x602 = q[22] * x600;
  const Real x603 = q[23] * x601;
  const Real x605 = 1.0 - (x602 + x603);
  w.x[66] = x605;
  const Real x606 = q[22] * x599;
  const Real x607 = q[24] * x601;
  const Real x608 = x606 - x607;
  w.x[67] = x608;
  const Real x609 = q[23] * x599;
  const Real x610 = q[24] * x600;
  const Real x611 = x609 + x610;
  w.x[68] = x611;
  const Real x612 = x606 + x607;
  w.x[69] = x612;
  const Real x613 = q[21] * x599;
  const Real x615 = 1.0 - (x603 + x613);
  w.x[70] = x615;
  const Real x616 = q[23] * x600;
  const Real x617 = q[24] * x599;
  const Real x618 = x616 - x617;
  w.x[71] = x618;
  const Real x619 = x609 - x610;
  w.x[72] = x619;
  const Real x620 = x616 + x617;
  w.x[73] = x620;
  const Real x622 = 1.0 - (x602 + x613);
  w.x[74] = x622;
  const Real x627 = x528 * x619 + x533 * x612 + x532 * x605;
  const Real x632 = x528 * x620 + x533 * x615 + x532 * x608;
  const Real x637 = x528 * x622 + x533 * x618 + x532 * x611;
  const Real x638 = v[17] + x627;
  const Real x639 = v[18] + x632;
  const Real x640 = v[19] + x637;
  const Real x645 = x542 * x619 + x471 * x612 + x545 * x605;
  const Real x660 = v[19] * x632 - v[18] * x637 + x645;
  const Real x650 = x542 * x620 + x471 * x615 + x545 * x608;
  const Real x665 = v[17] * x637 - v[19] * x627 + x650;
  const Real x655 = x542 * x622 + x471 * x618 + x545 * x611;
  const Real x670 = v[18] * x627 - v[17] * x632 + x655;
  const Real x673 = x557 + 0.41 * x568;
  const Real x676 = x561 - 0.41 * x572;
  const Real x679 = x551 - 0.41 * x581;
  const Real x684 = x619 * x673 + x605 * x676 + x612 * x679;
  const Real x689 = x620 * x673 + x608 * x676 + x615 * x679;
  const Real x694 = x622 * x673 + x611 * x676 + x618 * x679;
  const Real x699 = x639 * x639;
  const Real x701 = x699 + x640 * x640;
  const Real x703 = x638 * x639;
  const Real x705 = x670 + x703;
  const Real x708 = x639 * x640;
  const Real x709 = x708 - x660;
  const Real x711 = x638 * x638 + x699;
  const Real x713 = x638 * x640;
  // link 7 "right_foot": acceleration where nothing acts on it
  const Real x7916 = x665 * 0.01081667 - x713 * 0.0068;
  const Real x7908 = x660 * 0.00268333 - x708 * 0.00133334 + x705 * 0.0024;
  const Real x7928 = x7908 + 0.04 * x689;
  const Real x7933 = 0.0024 * (x701 - x711) + x7916 - 0.04 * x684;
  const Real x7934 = x7933 - x694 * 0.06;
  const Real x7925 = x670 * 0.00948333 + x703 * 0.00813334 - x709 * 0.0024;
  const Real x7936 = x7925 + x689 * 0.06;
  const Real x7942 = x684 - x701 * 0.06 - 0.04 * (x665 + x713);
  const Real x7947 = x689 + x705 * 0.06 - 0.04 * x709;
  const Real x7952 = x694 + 0.04 * x711 + (x713 - x665) * 0.06;
  const Real x7968 = x7928 * 923.0797633223488 - x7947 * 36.92319053289395;
  w.x[75] = x7968;
  const Real x7973 = x7942 * 7.1216574945652855 + x7952 * 10.682486241847927 + x7934 * 178.04143736413212;
  w.x[76] = x7973;
  const Real x7978 = x7936 * 169.97176768938678 - x7947 * 10.198306061363207;
  w.x[77] = x7978;
  const Real x7983 = x7942 * 1.2848662997826115 + x7952 * 0.4272994496739171 + x7934 * 7.1216574945652855;
  w.x[78] = x7983;
  const Real x7991 = x7947 * 3.0888259849975506 - (x7928 * 36.92319053289395 + x7936 * 10.198306061363207);
  w.x[79] = x7991;
  const Real x7996 = x7942 * 0.4272994496739171 + x7952 * 1.6409491745108757 + x7934 * 10.682486241847927;
  w.x[80] = x7996;
  // joint 7 "spine": placement, velocity and reference acceleration of its link
  const Real x728 = q[25] * q[25] + q[26] * q[26] + q[27] * q[27];
  const Real x729 = q[28] * q[28] + x728;
  require_length(w, x729, 7);
  const Real x731 = 2.0 * (1 / x729);
  const Real x732 = q[25] * x731;
  const Real x733 = q[26] * x731;
  const Real x734 = q[27] * x731;
  const Real x735 = q[26] * x733;
  const Real x736 = q[27] * x734;
  const Real x738 = 1.0 - (x735 + x736);
  w.x[81] = x738;
  const Real x739 = q[26] * x732;
  const Real x740 = q[28] * x734;
  const Real x741 = x739 - x740;
  w.x[82] = x741;
  const Real x742 = q[27] * x732;
  const Real x743 = q[28] * x733;
  const Real x744 = x742 + x743;
  w.x[83] = x744;
  const Real x745 = x739 + x740;
  w.x[84] = x745;
  const Real x746 = q[25] * x732;
  const Real x748 = 1.0 - (x736 + x746);
  w.x[85] = x748;
  const Real x749 = q[27] * x733;
  const Real x750 = q[28] * x732;
  const Real x751 = x749 - x750;
  w.x[86] = x751;
  const Real x752 = x742 - x743;
  w.x[87] = x752;
  const Real x753 = x749 + x750;
  w.x[88] = x753;
  const Real x755 = 1.0 - (x735 + x746);
  w.x[89] = x755;
  const Real x761 = v[4] * x745 + v[5] * x752 + v[3] * x738;
  const Real x766 = v[3] * x741 + v[5] * x753 + v[4] * x748;
  const Real x771 = v[3] * x744 + v[4] * x751 + v[5] * x755;
  const Real x772 = v[20] + x761;
  w.x[90] = x772;
  const Real x773 = v[21] + x766;
  w.x[91] = x773;
  const Real x774 = v[22] + x771;
  w.x[92] = x774;
  const Real x778 = v[22] * x766 - v[21] * x771;
  w.x[93] = x778;
  const Real x782 = v[20] * x771 - v[22] * x761;
  w.x[94] = x782;
  const Real x786 = v[21] * x761 - v[20] * x766;
  w.x[95] = x786;
  const Real x787 = x81 * 0.13;
  const Real x788 = x78 * 0.13;
  const Real x789 = x79 * 0.13;
  const Real x796 = x745 * x788 - x752 * x789 + x738 * x787;
  w.x[96] = x796;
  const Real x802 = x741 * x787 - x753 * x789 + x748 * x788;
  w.x[97] = x802;
  const Real x808 = x744 * x787 + x751 * x788 - x755 * x789;
  w.x[98] = x808;
  const Real x812 = x772 * x772;
  const Real x817 = x772 * x773;
  const Real x820 = x812 + x774 * x774;
  w.x[99] = x820;
  const Real x822 = x773 * x774;
  const Real x823 = x822 - x778;
  w.x[100] = x823;
  const Real x824 = x778 + x822;
  w.x[101] = x824;
  const Real x825 = x812 + x773 * x773;
  w.x[102] = x825;
  const Real x827 = x772 * x774;
  const Real x829 = x782 + x827;
  w.x[103] = x829;
  // link 8 "trunk": acceleration where nothing acts on it
  const Real x3061 = x778 * 1.818533 - x822 * 1.4260000000000002 - x802 * 5.29;
  const Real x3063 = x782 * 1.6843670000000002 + x827 * 1.560166 + x796 * 5.29;
  const Real x3066 = x796 * 23.0 + x829 * 5.29;
  const Real x3069 = x802 * 23.0 + x823 * 5.29;
  const Real x3084 = x3061 * 1.661590507665748 + x3069 * 0.38216581676312206;
  w.x[104] = x3084;
  const Real x3089 = x3063 * 2.1382736006602987 - x3066 * 0.49180292815186877;
  w.x[105] = x3089;
  const Real x3090 = (x786 * 0.258367 - x817 * 0.13416599999999995) * 3.870463333165613;
  w.x[106] = x3090;
  const Real x3094 = x3066 * 0.15659293434449503 - x3063 * 0.49180292815186877;
  w.x[107] = x3094;
  const Real x3097 = x3061 * 0.38216581676312206 + x3069 * 0.1313763987250833;
  w.x[108] = x3097;
  const Real x3098 = (x808 * 23.0 - x825 * 5.29) * 0.043478260869565216;
  w.x[109] = x3098;
  // joint 8 "left_shoulder": placement, velocity and reference acceleration of its link
  const Real x842 = q[29] * q[29] + q[30] * q[30] + q[31] * q[31];
  const Real x843 = q[32] * q[32] + x842;
  require_length(w, x843, 8);
  const Real x845 = 2.0 * (1 / x843);
  const Real x846 = q[29] * x845;
  const Real x847 = q[30] * x845;
  const Real x848 = q[31] * x845;
  const Real x849 = q[30] * x847;
  const Real x850 = q[31] * x848;
  const Real x852 = 1.0 - (x849 + x850);
  w.x[110] = x852;
  const Real x853 = q[30] * x846;
  const Real x854 = q[32] * x848;
  const Real x855 = x853 - x854;
  w.x[111] = x855;
  const Real x856 = q[31] * x846;
  const Real x857 = q[32] * x847;
  const Real x858 = x856 + x857;
  w.x[112] = x858;
  const Real x859 = x853 + x854;
  w.x[113] = x859;
  const Real x860 = q[29] * x846;
  const Real x862 = 1.0 - (x850 + x860);
  w.x[114] = x862;
  const Real x863 = q[31] * x847;
  const Real x864 = q[32] * x846;
  const Real x865 = x863 - x864;
  w.x[115] = x865;
  const Real x866 = x856 - x857;
  w.x[116] = x866;
  const Real x867 = x863 + x864;
  w.x[117] = x867;
  const Real x869 = 1.0 - (x849 + x860);
  w.x[118] = x869;
  const Real x876 = x772 * x852 + x773 * x859 + x774 * x866;
  const Real x881 = x772 * x855 + x773 * x862 + x774 * x867;
  const Real x886 = x772 * x858 + x773 * x865 + x774 * x869;
  const Real x887 = v[23] + x876;
  w.x[119] = x887;
  const Real x888 = v[24] + x881;
  w.x[120] = x888;
  const Real x889 = v[25] + x886;
  w.x[121] = x889;
  const Real x894 = x778 * x852 + x782 * x859 + x786 * x866;
  const Real x909 = x894 + v[25] * x881 - v[24] * x886;
  w.x[122] = x909;
  const Real x899 = x778 * x855 + x782 * x862 + x786 * x867;
  const Real x914 = x899 + v[23] * x886 - v[25] * x876;
  w.x[123] = x914;
  const Real x904 = x778 * x858 + x782 * x865 + x786 * x869;
  const Real x919 = x904 + v[24] * x876 - v[23] * x881;
  w.x[124] = x919;
  const Real x920 = (x817 - x786) * 0.2;
  w.x[125] = x920;
  const Real x921 = x829 * 0.42;
  w.x[126] = x921;
}

ADAGEN_NOINLINE void part_0_1(Workspace& w) {
  ADAGEN_INPUTS
  const Real x772 = w.x[90];
  const Real x773 = w.x[91];
  const Real x774 = w.x[92];
  const Real x778 = w.x[93];
  const Real x782 = w.x[94];
  const Real x786 = w.x[95];
  const Real x796 = w.x[96];
  const Real x802 = w.x[97];
  const Real x808 = w.x[98];
  const Real x820 = w.x[99];
  const Real x823 = w.x[100];
  const Real x824 = w.x[101];
  const Real x825 = w.x[102];
  const Real x829 = w.x[103];
  const Real x852 = w.x[110];
  const Real x855 = w.x[111];
  const Real x858 = w.x[112];
  const Real x859 = w.x[113];
  const Real x862 = w.x[114];
  const Real x865 = w.x[115];
  const Real x866 = w.x[116];
  const Real x867 = w.x[117];
  const Real x869 = w.x[118];
  const Real x887 = w.x[119];
  const Real x888 = w.x[120];
  const Real x889 = w.x[121];
  const Real x909 = w.x[122];
  const Real x914 = w.x[123];
  const Real x919 = w.x[124];
  const Real x920 = w.x[125];
  const Real x921 = w.x[126];
  // joint 8 "left_shoulder": placement, velocity and reference acceleration of its link
  const Real x923 = x796 + x920 + x921;
  const Real x924 = x820 * 0.2;
  const Real x926 = x823 * 0.42;
  const Real x928 = x802 - x924 + x926;
  const Real x929 = x824 * 0.2;
  const Real x930 = x825 * 0.42;
  const Real x933 = x808 + x929 - x930;
  const Real x938 = x852 * x923 + x859 * x928 + x866 * x933;
  const Real x943 = x855 * x923 + x862 * x928 + x867 * x933;
  const Real x948 = x858 * x923 + x865 * x928 + x869 * x933;
  const Real x962 = x888 * x889;
  const Real x963 = x962 - x909;
  const Real x965 = x887 * x887 + x888 * x888;
  const Real x967 = x887 * x889;
  const Real x969 = x914 + x967;
  // link 9 "left_upper_arm": acceleration where nothing acts on it
  const Real x5570 = x909 * 0.050615200000000006 - x962 * 0.048691450000000004 + x943 * 0.266;
  const Real x5573 = x914 * 0.050615200000000006 + x967 * 0.048691450000000004 - x938 * 0.266;
  const Real x5577 = x938 * 1.9 - x969 * 0.266;
  const Real x5581 = x943 * 1.9 - x963 * 0.266;
  const Real x5589 = 74.76523715533226 * x5570 - 10.467133201746517 * x5581;
  w.x[127] = x5589;
  const Real x5592 = 74.76523715533226 * x5573 + 10.467133201746517 * x5577;
  w.x[128] = x5592;
  const Real x5593 = 519.8180636777129 * (x919 * 0.00192375);
  w.x[129] = x5593;
  const Real x5596 = 10.467133201746517 * x5573 + 1.9917144377181968 * x5577;
  w.x[130] = x5596;
  const Real x5600 = 1.9917144377181968 * x5581 - 10.467133201746517 * x5570;
  w.x[131] = x5600;
  const Real x5601 = 0.5263157894736842 * (x948 * 1.9 + x965 * 0.266);
  w.x[132] = x5601;
  // joint 9 "left_elbow": placement, velocity and reference acceleration of its link
  const Real x978 = x889 * cosine[2] + x887 * sine[2];
  const Real x982 = x887 * cosine[2] - x889 * sine[2];
  const Real x983 = x888 + v[26];
  const Real x992 = x919 * cosine[2] + x909 * sine[2] + v[26] * x982;
  const Real x995 = x909 * cosine[2] - x919 * sine[2] - v[26] * x978;
  const Real x999 = x938 - x969 * 0.29;
  const Real x1002 = x943 - x963 * 0.29;
  const Real x1005 = x948 + x965 * 0.29;
  const Real x1008 = cosine[2] * x1005 + sine[2] * x999;
  const Real x1012 = cosine[2] * x999 - sine[2] * x1005;
  const Real x1019 = x982 * x982 + x983 * x983;
  const Real x1021 = x978 * x982;
  const Real x1023 = x914 + x1021;
  const Real x1031 = x978 * x983;
  const Real x1032 = x1031 - x995;
  // link 10 "left_forearm": acceleration where nothing acts on it
  const Real x4905 = x995 * 0.02190604 - x1031 * 0.02123229 + x1002 * 0.132;
  const Real x4908 = x914 * 0.02190604 + x1021 * 0.02123229 - x1012 * 0.132;
  const Real x4916 = x1012 * 1.1 - x1023 * 0.132;
  const Real x4920 = x1002 * 1.1 - x1032 * 0.132;
  const Real x4921 = 1484.2300556586272 * (x992 * 0.00067375);
  w.x[133] = x4921;
  const Real x4925 = 164.852193523287 * x4905 - 19.78226322279444 * x4920;
  w.x[134] = x4925;
  const Real x4928 = 164.852193523287 * x4908 + 19.78226322279444 * x4916;
  w.x[135] = x4928;
  const Real x4929 = 0.9090909090909091 * (x1008 * 1.1 + x1019 * 0.132);
  w.x[136] = x4929;
  const Real x4932 = 19.78226322279444 * x4908 + 3.2829624958262418 * x4916;
  w.x[137] = x4932;
  const Real x4936 = 3.2829624958262418 * x4920 - 19.78226322279444 * x4905;
  w.x[138] = x4936;
  // joint 10 "left_wrist": placement, velocity and reference acceleration of its link
  const Real x1046 = q[34] * q[34] + q[35] * q[35] + q[36] * q[36];
  const Real x1047 = q[37] * q[37] + x1046;
  require_length(w, x1047, 10);
  const Real x1049 = 2.0 * (1 / x1047);
  const Real x1050 = q[34] * x1049;
  const Real x1051 = q[35] * x1049;
  const Real x1052 = q[36] * x1049;
  const Real x1053 = q[35] * x1051;
  const Real x1054 = q[36] * x1052;
  const Real x1056 = 1.0 - (x1053 + x1054);
  w.x[139] = x1056;
  const Real x1057 = q[35] * x1050;
  const Real x1058 = q[37] * x1052;
  const Real x1059 = x1057 - x1058;
  w.x[140] = x1059;
  const Real x1060 = q[36] * x1050;
  const Real x1061 = q[37] * x1051;
  const Real x1062 = x1060 + x1061;
  w.x[141] = x1062;
  const Real x1063 = x1057 + x1058;
  w.x[142] = x1063;
  const Real x1064 = q[34] * x1050;
  const Real x1066 = 1.0 - (x1054 + x1064);
  w.x[143] = x1066;
  const Real x1067 = q[36] * x1051;
  const Real x1068 = q[37] * x1050;
  const Real x1069 = x1067 - x1068;
  w.x[144] = x1069;
  const Real x1070 = x1060 - x1061;
  w.x[145] = x1070;
  const Real x1071 = x1067 + x1068;
  w.x[146] = x1071;
  const Real x1073 = 1.0 - (x1053 + x1064);
  w.x[147] = x1073;
  const Real x1079 = x978 * x1070 + x983 * x1063 + x982 * x1056;
  const Real x1084 = x978 * x1071 + x983 * x1066 + x982 * x1059;
  const Real x1089 = x978 * x1073 + x983 * x1069 + x982 * x1062;
  const Real x1090 = v[27] + x1079;
  const Real x1091 = v[28] + x1084;
  const Real x1092 = v[29] + x1089;
  const Real x1097 = x992 * x1070 + x914 * x1063 + x995 * x1056;
  const Real x1112 = v[29] * x1084 - v[28] * x1089 + x1097;
  const Real x1102 = x992 * x1071 + x914 * x1066 + x995 * x1059;
  const Real x1117 = v[27] * x1089 - v[29] * x1079 + x1102;
  const Real x1107 = x992 * x1073 + x914 * x1069 + x995 * x1062;
  const Real x1126 = x1008 + x1019 * 0.26;
  const Real x1129 = x1012 - x1023 * 0.26;
  const Real x1132 = x1002 - x1032 * 0.26;
  const Real x1137 = x1070 * x1126 + x1056 * x1129 + x1063 * x1132;
  const Real x1142 = x1071 * x1126 + x1059 * x1129 + x1066 * x1132;
  const Real x1161 = x1091 * x1092;
  const Real x1166 = x1090 * x1092;
  // link 11 "left_hand": acceleration where nothing acts on it
  const Real x4952 = (v[28] * x1079 - v[27] * x1084 + x1107) * 0.0002555;
  const Real x4959 = x1112 * 0.0039235 - x1161 * 0.0034755000000000003 + x1142 * 0.0336;
  const Real x4962 = x1117 * 0.003731 + x1166 * 0.0036680000000000003 - x1137 * 0.0336;
  const Real x4966 = 0.42 * x1137 - (x1117 + x1166) * 0.0336;
  const Real x4970 = 0.42 * x1142 - (x1161 - x1112) * 0.0336;
  // joint 10 "left_wrist": placement, velocity and reference acceleration of its link
  const Real x1147 = x1073 * x1126 + x1062 * x1129 + x1069 * x1132;
  // link 11 "left_hand": acceleration where nothing acts on it
  const Real x4972 = (x1090 * x1090 + x1091 * x1091) * 0.0336;
  const Real x4978 = 809.3889113719142 * x4959 - 64.75111290975313 * x4970;
  w.x[148] = x4978;
  const Real x4981 = 958.7727708533076 * x4962 + 76.70182166826461 * x4966;
  w.x[149] = x4981;
  const Real x4982 = 3913.894324853229 * (x4952 - x1090 * x1091 * 0.00019249999999999996);
  w.x[150] = x4982;
  const Real x4985 = 76.70182166826461 * x4962 + 8.51709811441355 * x4966;
  w.x[151] = x4985;
  const Real x4989 = 7.561041413732632 * x4970 - 64.75111290975313 * x4959;
  w.x[152] = x4989;
  const Real x4990 = 2.380952380952381 * (0.42 * x1147 + x4972);
  w.x[153] = x4990;
  // joint 11 "neck": placement, velocity and reference acceleration of its link
  const Real x1181 = q[38] * q[38] + q[39] * q[39] + q[40] * q[40];
  const Real x1182 = q[41] * q[41] + x1181;
  require_length(w, x1182, 11);
  const Real x1184 = 2.0 * (1 / x1182);
  const Real x1185 = q[38] * x1184;
  const Real x1186 = q[39] * x1184;
  const Real x1187 = q[40] * x1184;
  const Real x1188 = q[39] * x1186;
  const Real x1189 = q[40] * x1187;
  const Real x1191 = 1.0 - (x1188 + x1189);
  w.x[154] = x1191;
  const Real x1192 = q[39] * x1185;
  const Real x1193 = q[41] * x1187;
  const Real x1194 = x1192 - x1193;
  w.x[155] = x1194;
  const Real x1195 = q[40] * x1185;
  const Real x1196 = q[41] * x1186;
  const Real x1197 = x1195 + x1196;
  w.x[156] = x1197;
  const Real x1198 = x1192 + x1193;
  w.x[157] = x1198;
  const Real x1199 = q[38] * x1185;
  const Real x1201 = 1.0 - (x1189 + x1199);
  w.x[158] = x1201;
  const Real x1202 = q[40] * x1186;
  const Real x1203 = q[41] * x1185;
  const Real x1204 = x1202 - x1203;
  w.x[159] = x1204;
  const Real x1205 = x1195 - x1196;
  w.x[160] = x1205;
  const Real x1206 = x1202 + x1203;
  w.x[161] = x1206;
  const Real x1208 = 1.0 - (x1188 + x1199);
  w.x[162] = x1208;
  const Real x1214 = x772 * x1191 + x773 * x1198 + x774 * x1205;
  const Real x1219 = x772 * x1194 + x773 * x1201 + x774 * x1206;
  const Real x1224 = x772 * x1197 + x773 * x1204 + x774 * x1208;
  const Real x1225 = v[30] + x1214;
  const Real x1226 = v[31] + x1219;
  const Real x1227 = v[32] + x1224;
  const Real x1232 = x778 * x1191 + x782 * x1198 + x786 * x1205;
  const Real x1247 = x1232 + v[32] * x1219 - v[31] * x1224;
  const Real x1237 = x778 * x1194 + x782 * x1201 + x786 * x1206;
  const Real x1252 = x1237 + v[30] * x1224 - v[32] * x1214;
  const Real x1242 = x778 * x1197 + x782 * x1204 + x786 * x1208;
  const Real x1257 = x1242 + v[31] * x1214 - v[30] * x1219;
  const Real x1259 = x796 + x829 * 0.48;
  const Real x1261 = x802 + x823 * 0.48;
  const Real x1264 = x808 - x825 * 0.48;
  const Real x1269 = x1191 * x1259 + x1198 * x1261 + x1205 * x1264;
  const Real x1274 = x1194 * x1259 + x1201 * x1261 + x1206 * x1264;
  const Real x1279 = x1197 * x1259 + x1204 * x1261 + x1208 * x1264;
  const Real x1284 = x1226 * x1226;
  const Real x1286 = x1284 + x1227 * x1227;
  const Real x1288 = x1225 * x1226;
  const Real x1290 = x1257 + x1288;
  const Real x1293 = x1226 * x1227;
  const Real x1294 = x1293 - x1247;
  const Real x1296 = x1225 * x1225 + x1284;
  const Real x1298 = x1225 * x1227;
  // link 12 "head": acceleration where nothing acts on it
  const Real x3907 = x1252 * 0.11613000000000002 + x1298 * 0.09555000000000002;
  const Real x3900 = x1247 * 0.11564000000000002 - x1293 * 0.09604000000000003 - x1290 * 0.0068600000000000015;
  const Real x3918 = x3900 - x1274 * 0.6860000000000002;
  const Real x3908 = x3907 - 0.0068600000000000015 * (x1286 - x1296);
  const Real x3923 = x1269 * 0.6860000000000002 - x1279 * 0.049 + x3908;
  const Real x3915 = x1257 * 0.02009 + x1288 * 0.0004900000000000001 + x1294 * 0.0068600000000000015;
  const Real x3925 = x3915 + x1274 * 0.049;
  const Real x3930 = x1269 * 4.9 - x1286 * 0.049;
  const Real x3931 = (x1252 + x1298) * 0.6860000000000002 + x3930;
  const Real x3936 = x1274 * 4.9 + x1290 * 0.049 + x1294 * 0.6860000000000002;
  const Real x3941 = x1279 * 4.9 - x1296 * 0.6860000000000002;
  const Real x3942 = (x1298 - x1252) * 0.049 + x3941;
  const Real x3954 = x3918 * 51.02040816326531 + x3936 * 7.142857142857144;
  w.x[163] = x3954;
  const Real x3960 = x3923 * 51.02040816326531 - x3931 * 7.142857142857144 + x3942 * 0.5102040816326531;
  w.x[164] = x3960;
  const Real x3964 = x3925 * 51.02040816326531 - x3936 * 0.5102040816326531;
  w.x[165] = x3964;
  const Real x3972 = x3931 * 1.2040816326530615 - x3923 * 7.142857142857144 - x3942 * 0.07142857142857144;
  w.x[166] = x3972;
  const Real x3978 = x3918 * 7.142857142857144 - x3925 * 0.5102040816326531 + x3936 * 1.209183673469388;
  w.x[167] = x3978;
  const Real x3984 = x3923 * 0.5102040816326531 - x3931 * 0.07142857142857144 + x3942 * 0.20918367346938774;
  w.x[168] = x3984;
  // joint 12 "right_shoulder": placement, velocity and reference acceleration of its link
  const Real x1313 = q[42] * q[42] + q[43] * q[43] + q[44] * q[44];
  const Real x1314 = q[45] * q[45] + x1313;
  require_length(w, x1314, 12);
  const Real x1316 = 2.0 * (1 / x1314);
  const Real x1317 = q[42] * x1316;
  const Real x1318 = q[43] * x1316;
  const Real x1319 = q[44] * x1316;
  const Real x1320 = q[43] * x1318;
  const Real x1321 = q[44] * x1319;
  const Real x1323 = 1.0 - (x1320 + x1321);
  w.x[169] = x1323;
  const Real x1324 = q[43] * x1317;
  const Real x1325 = q[45] * x1319;
  const Real x1326 = x1324 - x1325;
  w.x[170] = x1326;
  const Real x1327 = q[44] * x1317;
  const Real x1328 = q[45] * x1318;
  const Real x1329 = x1327 + x1328;
  w.x[171] = x1329;
  const Real x1330 = x1324 + x1325;
  w.x[172] = x1330;
  const Real x1331 = q[42] * x1317;
  const Real x1333 = 1.0 - (x1321 + x1331);
  w.x[173] = x1333;
  const Real x1334 = q[44] * x1318;
  const Real x1335 = q[45] * x1317;
  const Real x1336 = x1334 - x1335;
  w.x[174] = x1336;
  const Real x1337 = x1327 - x1328;
  w.x[175] = x1337;
  const Real x1338 = x1334 + x1335;
  w.x[176] = x1338;
  const Real x1340 = 1.0 - (x1320 + x1331);
  w.x[177] = x1340;
  const Real x1346 = x772 * x1323 + x773 * x1330 + x774 * x1337;
  const Real x1351 = x772 * x1326 + x773 * x1333 + x774 * x1338;
  const Real x1356 = x772 * x1329 + x773 * x1336 + x774 * x1340;
  const Real x1357 = v[33] + x1346;
  const Real x1358 = v[34] + x1351;
  const Real x1359 = v[35] + x1356;
  const Real x1364 = x778 * x1323 + x782 * x1330 + x786 * x1337;
  const Real x1379 = x1364 + v[35] * x1351 - v[34] * x1356;
  const Real x1369 = x778 * x1326 + x782 * x1333 + x786 * x1338;
  const Real x1384 = x1369 + v[33] * x1356 - v[35] * x1346;
  const Real x1374 = x778 * x1329 + x782 * x1336 + x786 * x1340;
  const Real x1389 = x1374 + v[34] * x1346 - v[33] * x1351;
  const Real x1392 = x796 - x920 + x921;
  const Real x1394 = x802 + x924 + x926;
  const Real x1397 = x808 - x929 - x930;
  const Real x1402 = x1323 * x1392 + x1330 * x1394 + x1337 * x1397;
  const Real x1407 = x1326 * x1392 + x1333 * x1394 + x1338 * x1397;
  const Real x1412 = x1329 * x1392 + x1336 * x1394 + x1340 * x1397;
  const Real x1426 = x1358 * x1359;
  const Real x1427 = x1426 - x1379;
  const Real x1429 = x1357 * x1357 + x1358 * x1358;
  const Real x1431 = x1357 * x1359;
  const Real x1433 = x1384 + x1431;
  // link 13 "right_upper_arm": acceleration where nothing acts on it
  const Real x2371 = x1379 * 0.050615200000000006 - x1426 * 0.048691450000000004 + x1407 * 0.266;
  const Real x2374 = x1384 * 0.050615200000000006 + x1431 * 0.048691450000000004 - x1402 * 0.266;
  const Real x2378 = x1402 * 1.9 - x1433 * 0.266;
  const Real x2382 = x1407 * 1.9 - x1427 * 0.266;
  const Real x2396 = x2371 * 74.76523715533226 - x2382 * 10.467133201746517;
  w.x[178] = x2396;
  const Real x2399 = x2374 * 74.76523715533226 + x2378 * 10.467133201746517;
  w.x[179] = x2399;
  const Real x2400 = x1389 * 0.00192375 * 519.8180636777129;
  w.x[180] = x2400;
  const Real x2403 = x2374 * 10.467133201746517 + x2378 * 1.9917144377181968;
  w.x[181] = x2403;
  const Real x2407 = x2382 * 1.9917144377181968 - x2371 * 10.467133201746517;
  w.x[182] = x2407;
  const Real x2408 = (x1412 * 1.9 + x1429 * 0.266) * 0.5263157894736842;
  w.x[183] = x2408;
  // joint 13 "right_elbow": placement, velocity and reference acceleration of its link
  const Real x1441 = x1359 * cosine[3] + x1357 * sine[3];
  const Real x1445 = x1357 * cosine[3] - x1359 * sine[3];
  const Real x1446 = x1358 + v[36];
  const Real x1455 = x1389 * cosine[3] + x1379 * sine[3] + v[36] * x1445;
  const Real x1458 = x1379 * cosine[3] - x1389 * sine[3] - v[36] * x1441;
  const Real x1461 = x1402 - 0.29 * x1433;
  const Real x1464 = x1407 - 0.29 * x1427;
  const Real x1467 = x1412 + 0.29 * x1429;
  const Real x1470 = cosine[3] * x1467 + sine[3] * x1461;
  const Real x1474 = cosine[3] * x1461 - sine[3] * x1467;
  const Real x1481 = x1445 * x1445 + x1446 * x1446;
  const Real x1483 = x1441 * x1445;
  const Real x1485 = x1384 + x1483;
  const Real x1493 = x1441 * x1446;
  const Real x1494 = x1493 - x1458;
  // link 14 "right_forearm": acceleration where nothing acts on it
  const Real x1652 = x1458 * 0.02190604 - x1493 * 0.02123229 + x1464 * 0.132;
  const Real x1655 = x1384 * 0.02190604 + x1483 * 0.02123229 - x1474 * 0.132;
  const Real x1663 = x1474 * 1.1 - x1485 * 0.132;
  const Real x1667 = x1464 * 1.1 - x1494 * 0.132;
  const Real x1674 = x1455 * 0.00067375 * 1484.2300556586272;
  w.x[184] = x1674;
  const Real x1678 = x1652 * 164.852193523287 - x1667 * 19.78226322279444;
  w.x[185] = x1678;
  const Real x1681 = x1655 * 164.852193523287 + x1663 * 19.78226322279444;
  w.x[186] = x1681;
  const Real x1682 = (x1470 * 1.1 + x1481 * 0.132) * 0.9090909090909091;
  w.x[187] = x1682;
  const Real x1685 = x1655 * 19.78226322279444 + x1663 * 3.2829624958262418;
  w.x[188] = x1685;
  const Real x1689 = x1667 * 3.2829624958262418 - x1652 * 19.78226322279444;
  w.x[189] = x1689;
  // joint 14 "right_wrist": placement, velocity and reference acceleration of its link
  const Real x1508 = q[47] * q[47] + q[48] * q[48] + q[49] * q[49];
  const Real x1509 = q[50] * q[50] + x1508;
  require_length(w, x1509, 14);
  const Real x1511 = 2.0 * (1 / x1509);
  const Real x1512 = q[47] * x1511;
  const Real x1513 = q[48] * x1511;
  const Real x1514 = q[49] * x1511;
  const Real x1515 = q[48] * x1513;
  const Real x1516 = q[49] * x1514;
  const Real x1518 = 1.0 - (x1515 + x1516);
  w.x[190] = x1518;
  const Real x1519 = q[48] * x1512;
  const Real x1520 = q[50] * x1514;
  const Real x1521 = x1519 - x1520;
  w.x[191] = x1521;
  const Real x1522 = q[49] * x1512;
  const Real x1523 = q[50] * x1513;
  const Real x1524 = x1522 + x1523;
  w.x[192] = x1524;
  const Real x1525 = x1519 + x1520;
  w.x[193] = x1525;
  const Real x1526 = q[47] * x1512;
  const Real x1528 = 1.0 - (x1516 + x1526);
  w.x[194] = x1528;
  const Real x1529 = q[49] * x1513;
  const Real x1530 = q[50] * x1512;
  const Real x1531 = x1529 - x1530;
  w.x[195] = x1531;
  const Real x1532 = x1522 - x1523;
  const Real x1533 = x1529 + x1530;
  const Real x1535 = 1.0 - (x1515 + x1526);
  const Real x1540 = x1441 * x1532 + x1446 * x1525 + x1445 * x1518;
  const Real x1545 = x1441 * x1533 + x1446 * x1528 + x1445 * x1521;
  const Real x1550 = x1441 * x1535 + x1446 * x1531 + x1445 * x1524;
  const Real x1551 = v[37] + x1540;
  const Real x1552 = v[38] + x1545;
  const Real x1553 = v[39] + x1550;
  const Real x1558 = x1455 * x1532 + x1384 * x1525 + x1458 * x1518;
  const Real x1573 = v[39] * x1545 - v[38] * x1550 + x1558;
  const Real x1563 = x1455 * x1533 + x1384 * x1528 + x1458 * x1521;
  const Real x1578 = v[37] * x1550 - v[39] * x1540 + x1563;
  const Real x1568 = x1455 * x1535 + x1384 * x1531 + x1458 * x1524;
  const Real x1586 = x1470 + 0.26 * x1481;
  const Real x1589 = x1474 - 0.26 * x1485;
  const Real x1592 = x1464 - 0.26 * x1494;
  const Real x1597 = x1532 * x1586 + x1518 * x1589 + x1525 * x1592;
  const Real x1602 = x1533 * x1586 + x1521 * x1589 + x1528 * x1592;
  const Real x1621 = x1552 * x1553;
  const Real x1626 = x1551 * x1553;
  // link 15 "right_hand": acceleration where nothing acts on it
  const Real x1717 = (v[38] * x1540 - v[37] * x1545 + x1568) * 0.0002555;
  const Real x1726 = x1573 * 0.0039235 - x1621 * 0.0034755000000000003 + x1602 * 0.0336;
  const Real x1729 = x1578 * 0.003731 + x1626 * 0.0036680000000000003 - x1597 * 0.0336;
  const Real x1733 = 0.42 * x1597 - (x1578 + x1626) * 0.0336;
  const Real x1737 = 0.42 * x1602 - (x1621 - x1573) * 0.0336;
  // joint 14 "right_wrist": placement, velocity and reference acceleration of its link
  const Real x1607 = x1535 * x1586 + x1524 * x1589 + x1531 * x1592;
  // link 15 "right_hand": acceleration where nothing acts on it
  const Real x1739 = (x1551 * x1551 + x1552 * x1552) * 0.0336;
  // joint 14 "right_wrist": assembly: its two sides become one chain
  const Real x1786 = x1525 * 23.079307093260184;
  w.x[196] = x1786;
  const Real x1788 = x1518 * 23.079307093260184;
  w.x[197] = x1788;
  const Real x1789 = x1528 * 23.079307093260184;
  w.x[198] = x1789;
  const Real x1791 = x1521 * 23.079307093260184;
  w.x[199] = x1791;
  const Real x1792 = x1531 * 23.079307093260184;
  w.x[200] = x1792;
  const Real x1794 = x1524 * 23.079307093260184;
  w.x[201] = x1794;
  const Real x1798 = x1525 * x1788 - x1518 * x1786;
  w.x[202] = x1798;
  const Real x1806 = x1531 * x1788 - x1524 * x1786;
  w.x[203] = x1806;
  const Real x1814 = x1528 * x1791 - x1521 * x1789;
  w.x[204] = x1814;
  const Real x1818 = x1531 * x1791 - x1524 * x1789;
  w.x[205] = x1818;
  const Real x1822 = x1525 * x1794 - x1518 * x1792;
  w.x[206] = x1822;
  const Real x1826 = x1528 * x1794 - x1521 * x1792;
  w.x[207] = x1826;
  const Real x1830 = x1531 * x1794 - x1524 * x1792;
  w.x[208] = x1830;
  const Real x1831 = x1532 * 1484.2300556586272;
  w.x[209] = x1831;
  const Real x1832 = x1518 * 164.852193523287;
  w.x[210] = x1832;
  const Real x1833 = x1525 * 164.852193523287;
  w.x[211] = x1833;
  const Real x1834 = x1533 * 1484.2300556586272;
  w.x[212] = x1834;
  const Real x1835 = x1521 * 164.852193523287;
  w.x[213] = x1835;
  const Real x1836 = x1528 * 164.852193523287;
  w.x[214] = x1836;
  const Real x1837 = x1535 * 1484.2300556586272;
  w.x[215] = x1837;
  const Real x1838 = x1524 * 164.852193523287;
  w.x[216] = x1838;
  const Real x1839 = x1531 * 164.852193523287;
  w.x[217] = x1839;
  const Real x1849 = x1533 * x1831 + x1528 * x1833 + x1521 * x1832;
  const Real x1854 = x1535 * x1831 + x1531 * x1833 + x1524 * x1832;
  const Real x1864 = x1535 * x1834 + x1524 * x1835 + x1531 * x1836;
  const Real x1870 = x1532 * 0.9090909090909091;
  w.x[218] = x1870;
  const Real x1871 = x1518 * 4.140193902147335;
  const Real x1872 = x1525 * 4.140193902147335;
  const Real x1873 = x1533 * 0.9090909090909091;
  w.x[219] = x1873;
  const Real x1874 = x1521 * 4.140193902147335;
  const Real x1875 = x1528 * 4.140193902147335;
  const Real x1876 = x1535 * 0.9090909090909091;
  w.x[220] = x1876;
  const Real x1888 = x1533 * x1870 + x1528 * x1872 + x1521 * x1871;
  w.x[221] = x1888;
  const Real x1893 = x1535 * x1870 + x1531 * x1872 + x1524 * x1871;
  w.x[222] = x1893;
  const Real x1903 = x1535 * x1873 + x1524 * x1874 + x1531 * x1875;
  w.x[223] = x1903;
  const Real x1907 = x1524 * (x1524 * 4.140193902147335) + x1531 * (x1531 * 4.140193902147335);
  const Real x1844 = x1532 * x1831 + x1525 * x1833 + x1518 * x1832;
  const Real x1910 = x1528 * x1788 - x1521 * x1786 + -64.75111290975313;
  w.x[224] = x1910;
  const Real x1859 = x1533 * x1834 + x1521 * x1835 + x1528 * x1836;
  const Real x1912 = x1525 * x1791 - x1518 * x1789 + 76.70182166826461;
  w.x[225] = x1912;
  const Real x1869 = x1524 * x1838 + x1531 * x1839 + x1535 * x1837;
  const Real x1883 = x1532 * x1870 + x1525 * x1872 + x1518 * x1871;
  const Real x1914 = 8.51709811441355 + x1883;
  w.x[226] = x1914;
  require_more(w, x1914, 1.339542027310537e-13, kGrowth, 14);
  require_more(w, x1914, 0.0, kFactorization, 14);
  const Real x1898 = x1533 * x1873 + x1521 * x1874 + x1528 * x1875;
  const Real x1915 = 7.561041413732632 + x1898;
  w.x[227] = x1915;
  require_more(w, x1915, 1.203678198581818e-13, kGrowth, 14);
  const Real x1916 = x1535 * x1876 + x1907 + 2.380952380952381;
  w.x[228] = x1916;
  require_more(w, x1916, 4.67543272015304e-14, kGrowth, 14);
  const Real x1919 = 0.26 * x1681 - x1685;
  const Real x1922 = x1689 + 0.26 * x1678;
  const Real x1932 = x1532 * x1674 + x1518 * x1678 + x1525 * x1681;
  const Real x1942 = x1533 * x1674 + x1521 * x1678 + x1528 * x1681;
  const Real x1952 = x1535 * x1674 + x1524 * x1678 + x1531 * x1681;
  const Real x1961 = x1518 * x1919 - (x1532 * x1682 + x1525 * x1922);
  const Real x1981 = x1729 * 76.70182166826461 + x1733 * 8.51709811441355 + x1961;
  w.x[229] = x1981;
  const Real x1969 = x1521 * x1919 - (x1533 * x1682 + x1528 * x1922);
  const Real x1982 = x1737 * 7.561041413732632 - x1726 * 64.75111290975313 + x1969;
  w.x[230] = x1982;
  const Real x1977 = x1524 * x1919 - (x1535 * x1682 + x1531 * x1922);
  const Real x1983 = (0.42 * x1607 + x1739) * 2.380952380952381 + x1977;
  w.x[231] = x1983;
  const Real x1987 = tau[38] * x1849 + tau[39] * x1854;
  const Real x1992 = tau[37] * x1849 + tau[39] * x1864;
  const Real x1997 = tau[37] * x1854 + tau[38] * x1864;
  const Real x2003 = tau[37] * x1798 + tau[39] * x1822 + tau[38] * x1912;
  w.x[232] = x2003;
  const Real x2008 = tau[38] * x1814 + tau[39] * x1826 + tau[37] * x1910;
  w.x[233] = x2008;
  const Real x2013 = tau[37] * x1806 + tau[39] * x1830 + tau[38] * x1818;
  w.x[234] = x2013;
  const Real x1978 = x1726 * 809.3889113719142 - x1737 * 64.75111290975313 - x1932;
  const Real x2014 = x1978 - (tau[37] * (809.3889113719142 + x1844) + x1987);
  w.x[235] = x2014;
  const Real x1979 = x1729 * 958.7727708533076 + x1733 * 76.70182166826461 - x1942;
  const Real x2015 = x1979 - (tau[38] * (958.7727708533076 + x1859) + x1992);
  w.x[236] = x2015;
  const Real x1980 = (x1717 - x1551 * x1552 * 0.00019249999999999996) * 3913.894324853229 - x1952;
  const Real x2016 = x1980 - (tau[39] * (3913.894324853229 + x1869) + x1997);
  w.x[237] = x2016;
}

ADAGEN_NOINLINE void part_0_2(Workspace& w) {
  ADAGEN_INPUTS
  const Real x1323 = w.x[169];
  const Real x1326 = w.x[170];
  const Real x1329 = w.x[171];
  const Real x1330 = w.x[172];
  const Real x1333 = w.x[173];
  const Real x1336 = w.x[174];
  const Real x1337 = w.x[175];
  const Real x1338 = w.x[176];
  const Real x1340 = w.x[177];
  const Real x1518 = w.x[190];
  const Real x1521 = w.x[191];
  const Real x1524 = w.x[192];
  const Real x1525 = w.x[193];
  const Real x1528 = w.x[194];
  const Real x1531 = w.x[195];
  const Real x1674 = w.x[184];
  const Real x1678 = w.x[185];
  const Real x1681 = w.x[186];
  const Real x1682 = w.x[187];
  const Real x1685 = w.x[188];
  const Real x1689 = w.x[189];
  const Real x1786 = w.x[196];
  const Real x1788 = w.x[197];
  const Real x1789 = w.x[198];
  const Real x1791 = w.x[199];
  const Real x1792 = w.x[200];
  const Real x1794 = w.x[201];
  const Real x1831 = w.x[209];
  const Real x1832 = w.x[210];
  const Real x1833 = w.x[211];
  const Real x1834 = w.x[212];
  const Real x1835 = w.x[213];
  const Real x1836 = w.x[214];
  const Real x1837 = w.x[215];
  const Real x1838 = w.x[216];
  const Real x1839 = w.x[217];
  const Real x1870 = w.x[218];
  const Real x1873 = w.x[219];
  const Real x1876 = w.x[220];
  const Real x1888 = w.x[221];
  const Real x1893 = w.x[222];
  const Real x1903 = w.x[223];
  const Real x1914 = w.x[226];
  const Real x1915 = w.x[227];
  const Real x1916 = w.x[228];
  const Real x1981 = w.x[229];
  const Real x1982 = w.x[230];
  const Real x1983 = w.x[231];
  const Real x2003 = w.x[232];
  const Real x2008 = w.x[233];
  const Real x2013 = w.x[234];
  const Real x2396 = w.x[178];
  const Real x2399 = w.x[179];
  const Real x2400 = w.x[180];
  const Real x2403 = w.x[181];
  const Real x2407 = w.x[182];
  const Real x2408 = w.x[183];
  const Real x3084 = w.x[104];
  const Real x3089 = w.x[105];
  const Real x3090 = w.x[106];
  const Real x3094 = w.x[107];
  const Real x3097 = w.x[108];
  const Real x3098 = w.x[109];
  // joint 14 "right_wrist": assembly: its two sides become one chain
  const Real x2017 = x1981 - x2003;
  w.x[126] = x2017;
  const Real x2023 = 1 / x1914;
  w.x[125] = x2023;
  const Real x2024 = x1888 * x2023;
  w.x[124] = x2024;
  const Real x2025 = x1893 * x2023;
  w.x[123] = x2025;
  const Real x2028 = x1915 - x1888 * x2024;
  const Real x2031 = x1903 - x1893 * x2024;
  const Real x2032 = 1 / x2028;
  w.x[122] = x2032;
  const Real x2033 = x2031 * x2032;
  w.x[121] = x2033;
  const Real x2039 = x1916 - x1893 * x2025 - x2031 * x2033;
  const Real x2040 = 1 / x2039;
  w.x[120] = x2040;
  const Real x2042 = x1915 * 1.7763568394002505e-15;
  require_more(w, x2028, x2042, kFactorization, 14);
  const Real x2043 = x1916 * 1.7763568394002505e-15;
  require_more(w, x2039, x2043, kFactorization, 14);
  const Real x2046 = x1982 - x2008 - x2017 * x2024;
  w.x[119] = x2046;
  const Real x2052 = x1983 - x2013 - x2017 * x2025 - x2033 * x2046;
  w.x[103] = x2052;
  const Real x2056 = x1525 * 19.78226322279444;
  w.x[102] = x2056;
  const Real x2057 = x1528 * 19.78226322279444;
  w.x[101] = x2057;
  const Real x2058 = x1531 * 19.78226322279444;
  w.x[100] = x2058;
  const Real x2060 = x1518 * 1.860425942100313;
  w.x[99] = x2060;
  const Real x2066 = x1518 * 19.78226322279444;
  w.x[98] = x2066;
  const Real x2068 = x1521 * 19.78226322279444;
  w.x[97] = x2068;
  const Real x2070 = x1524 * 19.78226322279444;
  w.x[96] = x2070;
  const Real x2072 = x1525 * 1.860425942100313;
  w.x[95] = x2072;
  const Real x2080 = x1789 - x1786 * x2024;
  w.x[94] = x2080;
  const Real x2083 = x1788 * x2024 - x1791;
  w.x[93] = x2083;
  const Real x2086 = x1873 - x1870 * x2024;
  w.x[92] = x2086;
  const Real x2089 = x2024 * x2060 - x1521 * 1.860425942100313;
  w.x[91] = x2089;
  const Real x2092 = x2024 * x2072 - x1528 * 1.860425942100313;
  w.x[90] = x2092;
  const Real x2098 = x1792 - x1786 * x2025 - x2033 * x2080;
  w.x[238] = x2098;
  const Real x2104 = x1788 * x2025 - x1794 - x2033 * x2083;
  w.x[239] = x2104;
  const Real x2110 = x1876 - x1870 * x2025 - x2033 * x2086;
  w.x[240] = x2110;
  const Real x2116 = x2025 * x2060 - x1524 * 1.860425942100313 - x2033 * x2089;
  w.x[241] = x2116;
  const Real x2122 = x2025 * x2072 - x1531 * 1.860425942100313 - x2033 * x2092;
  w.x[242] = x2122;
  const Real x2123 = x1786 * x2023;
  const Real x2124 = x1788 * x2023;
  const Real x2126 = x1870 * x2023;
  const Real x2127 = x2023 * x2060;
  const Real x2129 = x2023 * x2072;
  const Real x2131 = x2032 * x2080;
  const Real x2132 = x2032 * x2083;
  const Real x2133 = x2032 * x2086;
  const Real x2134 = x2032 * x2089;
  const Real x2135 = x2032 * x2092;
  const Real x2136 = x2040 * x2098;
  const Real x2137 = x2040 * x2104;
  const Real x2138 = x2040 * x2110;
  const Real x2139 = x2040 * x2116;
  const Real x2140 = x2040 * x2122;
  const Real x2148 = 164.852193523287 - x1786 * x2123 - x2080 * x2131;
  const Real x2157 = x1786 * x2124 - x2080 * x2132 - x2098 * x2137;
  w.x[243] = x2157;
  const Real x2166 = x1786 * x2126 + x2080 * x2133 + x2098 * x2138;
  const Real x2175 = x1786 * x2127 - x2080 * x2134 - x2098 * x2139;
  const Real x2183 = -19.78226322279444 + x1786 * x2129 - x2080 * x2135;
  const Real x2192 = 164.852193523287 - x1788 * x2124 - x2083 * x2132;
  const Real x2209 = 19.78226322279444 - x1788 * x2127 - x2083 * x2134;
  const Real x2219 = x1788 * x2129 + x2083 * x2135 + x2104 * x2140;
  w.x[244] = x2219;
  const Real x2228 = 0.9090909090909091 - x1870 * x2126 - x2086 * x2133;
  const Real x2253 = 3.2829624958262418 - x2060 * x2127 - x2089 * x2134;
  const Real x2272 = 3.2829624958262418 - x2072 * x2129 - x2092 * x2135;
  const Real x2283 = tau[38] * x1835 + tau[39] * x1838 + tau[37] * x1832;
  const Real x2308 = x2017 * x2123 + x2046 * x2131 + x2052 * x2136;
  const Real x2288 = tau[37] * x1833 + tau[39] * x1839 + tau[38] * x1836;
  const Real x2314 = x2046 * x2132 - x2017 * x2124 + x2052 * x2137;
  const Real x2293 = tau[37] * x2056 + tau[39] * x2058 + tau[38] * x2057;
  const Real x2325 = x2046 * x2134 - x2017 * x2127 + x2052 * x2139;
  const Real x2331 = x2046 * x2135 - x2017 * x2129 + x2052 * x2140;
  const Real x2302 = tau[38] * x2068 + tau[39] * x2070 + tau[37] * x2066;
  const Real x2278 = tau[37] * x1831 + tau[38] * x1834 + tau[39] * x1837;
  const Real x2319 = x2017 * x2126 + x2046 * x2133 + x2052 * x2138;
  // joint 13 "right_elbow": assembly: its two sides become one chain
  const Real x2426 = sine[3] * 11.214785573299837;
  w.x[245] = x2426;
  const Real x2427 = cosine[3] * 11.214785573299837;
  const Real x2432 = cosine[3] * 445.0528265223806;
  const Real x2433 = sine[3] * x2432;
  const Real x2435 = cosine[3] * x2432;
  const Real x2440 = cosine[3] * 1.6822178359949753;
  const Real x2444 = cosine[3] * x2440;
  const Real x2448 = 74.76523715533226 + x2435 + 1484.2300556586272;
  require_more(w, x2448, 2.1587775800806794e-11, kGrowth, 13);
  require_more(w, x2448, 0.0, kFactorization, 13);
  const Real x2449 = x2148 - x2098 * x2136 + (519.8180636777129 - x2435);
  require_more(w, x2449, 2.8382886875476563e-12, kGrowth, 13);
  // joint 14 "right_wrist": assembly: its two sides become one chain
  const Real x2201 = x1788 * x2126 - x2083 * x2133 - x2104 * x2138;
  // joint 13 "right_elbow": assembly: its two sides become one chain
  const Real x2452 = x2201 - x2426;
  w.x[246] = x2452;
  const Real x2453 = x2209 - x2104 * x2139 - x2427;
  w.x[247] = x2453;
  const Real x2454 = x2228 - x2110 * x2138 + (2.2085336254686596 - x2444);
  require_more(w, x2454, 2.039835605052919e-14, kGrowth, 13);
  // joint 14 "right_wrist": assembly: its two sides become one chain
  const Real x2237 = x1870 * x2127 - x2086 * x2134 - x2110 * x2139;
  // joint 13 "right_elbow": assembly: its two sides become one chain
  const Real x2456 = x2253 - x2116 * x2139 + (0.5263157894736842 + x2444);
  require_more(w, x2456, 5.4133100282171055e-14, kGrowth, 13);
  const Real x2457 = x2272 - x2122 * x2140 + 2.2085336254686596;
  require_more(w, x2457, 5.4133100282171055e-14, kGrowth, 13);
  const Real x2460 = 0.29 * x2399 - x2403;
  const Real x2484 = x1674 + x2278 - (cosine[3] * x2400 + sine[3] * x2396);
  w.x[248] = x2484;
  const Real x2475 = sine[3] * x2400 - cosine[3] * x2396;
  const Real x2483 = sine[3] * x2408 + cosine[3] * x2460;
  const Real x2491 = tau[36] * (x2192 - x2104 * x2137 + 74.76523715533226);
  const Real x2497 = x2288 + x2314 + x1681 - x2399 - x2491;
  w.x[249] = x2497;
  const Real x2487 = x1682 + x2319 + (sine[3] * x2460 - cosine[3] * x2408);
  const Real x2489 = x2331 - x2302 + x1689 - (x2407 + 0.29 * x2396);
  const Real x2505 = 1 / x2448;
  w.x[250] = x2505;
  const Real x2506 = x2433 * x2505;
  w.x[251] = x2506;
  const Real x2508 = x2426 * x2505;
  w.x[252] = x2508;
  const Real x2511 = x2449 - x2433 * x2506;
  const Real x2514 = x2183 - x2098 * x2140 + x2427 + x2426 * x2506;
  const Real x2515 = 1 / x2511;
  w.x[253] = x2515;
  const Real x2516 = x2166 * x2515;
  w.x[254] = x2516;
  const Real x2518 = x2175 * x2515;
  w.x[255] = x2518;
  const Real x2519 = x2514 * x2515;
  w.x[256] = x2519;
  const Real x2522 = x2454 - x2166 * x2516;
  const Real x2525 = x2237 + sine[3] * x2440 + x2175 * x2516;
  // joint 14 "right_wrist": assembly: its two sides become one chain
  const Real x2245 = x1870 * x2129 - x2086 * x2135 - x2110 * x2140;
  // joint 13 "right_elbow": assembly: its two sides become one chain
  const Real x2528 = x2245 + x2514 * x2516;
  const Real x2529 = 1 / x2522;
  w.x[257] = x2529;
  const Real x2530 = x2525 * x2529;
  w.x[258] = x2530;
  const Real x2531 = x2528 * x2529;
  w.x[259] = x2531;
  const Real x2537 = x2456 - x2175 * x2518 - x2525 * x2530;
  // joint 14 "right_wrist": assembly: its two sides become one chain
  const Real x2263 = x2060 * x2129 + x2089 * x2135 + x2116 * x2140;
  // joint 13 "right_elbow": assembly: its two sides become one chain
  const Real x2544 = x2263 + x2514 * x2518 + x2528 * x2530;
  const Real x2546 = 1 / x2537;
  w.x[260] = x2546;
  const Real x2547 = x2544 * x2546;
  w.x[261] = x2547;
  const Real x2558 = x2457 - x2426 * x2508 - x2514 * x2519;
  const Real x2560 = x2558 - x2528 * x2531 - x2544 * x2547;
  const Real x2561 = 1 / x2560;
  w.x[262] = x2561;
  const Real x2562 = 1.7763568394002505e-15 * x2449;
  require_more(w, x2511, x2562, kFactorization, 13);
  const Real x2563 = 1.7763568394002505e-15 * x2454;
  require_more(w, x2522, x2563, kFactorization, 13);
  const Real x2564 = 1.7763568394002505e-15 * x2456;
  require_more(w, x2537, x2564, kFactorization, 13);
  const Real x2565 = 1.7763568394002505e-15 * x2457;
  require_more(w, x2560, x2565, kFactorization, 13);
  const Real x2496 = x2283 + x2308 + x1678 + x2475 - x2157 * tau[36];
  const Real x2568 = x2496 + x2484 * x2506;
  w.x[263] = x2568;
  const Real x2571 = x2487 - tau[36] * x2452 + x2516 * x2568;
  w.x[264] = x2571;
  const Real x2499 = x2293 + x2325 + x1685 + x2483 - tau[36] * x2453;
  const Real x2577 = x2499 - x2518 * x2568 - x2530 * x2571;
  w.x[265] = x2577;
  const Real x2586 = x2489 + x2219 * tau[36] - x2484 * x2508;
  const Real x2588 = x2586 - x2519 * x2568 - x2531 * x2571;
  const Real x2589 = x2547 * x2577 + x2588;
  w.x[266] = x2589;
  const Real x2590 = sine[3] * 74.76523715533226;
  w.x[267] = x2590;
  const Real x2592 = cosine[3] * 519.8180636777129;
  w.x[268] = x2592;
  const Real x2596 = sine[3] * 1.0437541907882928;
  w.x[269] = x2596;
  const Real x2600 = sine[3] * 10.467133201746517;
  w.x[270] = x2600;
  const Real x2604 = cosine[3] * 0.5263157894736842;
  w.x[271] = x2604;
  const Real x2609 = cosine[3] * 74.76523715533226 + x2506 * x2590;
  w.x[272] = x2609;
  const Real x2612 = x2506 * x2592 - sine[3] * 519.8180636777129;
  w.x[273] = x2612;
  const Real x2615 = cosine[3] * 10.467133201746517 + x2506 * x2600;
  w.x[274] = x2615;
  const Real x2617 = x2516 * x2609;
  w.x[275] = x2617;
  const Real x2619 = x2516 * x2612;
  w.x[276] = x2619;
  const Real x2621 = x2516 * x2615;
  w.x[277] = x2621;
  const Real x2627 = x2518 * x2609 + x2530 * x2617;
  w.x[278] = x2627;
  const Real x2631 = x2426 * x2530 - x2427;
  w.x[279] = x2631;
  const Real x2636 = x2518 * x2612 + x2530 * x2619;
  w.x[280] = x2636;
  const Real x2640 = x2530 * x2596 - cosine[3] * 1.0437541907882928;
  w.x[281] = x2640;
  const Real x2645 = x2518 * x2615 + x2530 * x2621;
  w.x[282] = x2645;
  const Real x2648 = sine[3] * 0.5263157894736842 + x2530 * x2604;
  w.x[283] = x2648;
  const Real x2659 = 11.214785573299837 - x2508 * x2590 - x2519 * x2609;
  const Real x2661 = x2659 - x2531 * x2617 - x2547 * x2627;
  w.x[284] = x2661;
  const Real x2666 = x2426 * x2531 + x2547 * x2631;
  w.x[285] = x2666;
  const Real x2677 = x2508 * x2592 + x2519 * x2612 + x2531 * x2619;
  const Real x2679 = x2547 * x2636 + x2677;
  w.x[286] = x2679;
  const Real x2685 = x2531 * x2596 + x2547 * x2640;
  w.x[287] = x2685;
  const Real x2695 = -1.0437541907882928 + x2508 * x2600 + x2519 * x2615;
  const Real x2697 = x2531 * x2621 + x2695 + x2547 * x2645;
  w.x[288] = x2697;
  const Real x2702 = x2531 * x2604 + x2547 * x2648;
  w.x[289] = x2702;
  const Real x2704 = x2505 * x2590;
  const Real x2705 = x2505 * x2592;
  const Real x2706 = x2505 * x2600;
  const Real x2708 = x2515 * x2609;
  const Real x2709 = x2515 * x2612;
  const Real x2710 = x2515 * x2615;
  const Real x2712 = x2529 * x2617;
  const Real x2713 = x2426 * x2529;
  const Real x2715 = x2529 * x2619;
  const Real x2716 = x2529 * x2596;
  const Real x2718 = x2529 * x2621;
  const Real x2720 = x2529 * x2604;
  const Real x2721 = x2546 * x2627;
  const Real x2723 = x2546 * x2631;
  const Real x2724 = x2546 * x2636;
  const Real x2726 = x2546 * x2640;
  const Real x2727 = x2546 * x2645;
  const Real x2728 = x2546 * x2648;
  const Real x2730 = x2561 * x2661;
  const Real x2731 = x2561 * x2666;
  const Real x2732 = x2561 * x2679;
  const Real x2734 = x2561 * x2685;
  const Real x2735 = x2561 * x2697;
  const Real x2736 = x2561 * x2702;
  const Real x2749 = 74.76523715533226 - x2590 * x2704 - x2609 * x2708;
  const Real x2751 = x2749 - x2617 * x2712 - x2627 * x2721;
  const Real x2773 = x2590 * x2705 + x2609 * x2709 + x2617 * x2715;
  const Real x2797 = -10.467133201746517 + x2590 * x2706 + x2609 * x2710;
  const Real x2799 = x2617 * x2718 + x2797 + x2627 * x2727;
  const Real x2817 = 74.76523715533226 - x2426 * x2713 - x2631 * x2723;
  const Real x2834 = 10.467133201746517 - x2426 * x2716 - x2631 * x2726;
  const Real x2865 = 519.8180636777129 - x2592 * x2705 - x2612 * x2709;
  const Real x2867 = x2865 - x2619 * x2715 - x2636 * x2724;
  const Real x2888 = x2592 * x2706 + x2612 * x2710 + x2619 * x2718;
  const Real x2908 = 1.9917144377181968 - x2596 * x2716 - x2640 * x2726;
  const Real x2939 = 1.9917144377181968 - x2600 * x2706 - x2615 * x2710;
  const Real x2941 = x2939 - x2621 * x2718 - x2645 * x2727;
  const Real x2958 = 0.5263157894736842 - x2604 * x2720 - x2648 * x2728;
  const Real x2969 = x2484 * x2704 + x2568 * x2708 + x2571 * x2712;
  const Real x2986 = x2484 * x2705 + x2568 * x2709 + x2571 * x2715;
  const Real x3005 = x2484 * x2706 + x2568 * x2710 + x2571 * x2718;
  const Real x2977 = x2577 * x2723 - x2571 * x2713 + x2589 * x2731;
  const Real x2994 = x2577 * x2726 - x2571 * x2716 + x2589 * x2734;
  const Real x3015 = x2571 * x2720 - x2577 * x2728 - x2589 * x2736;
  // joint 12 "right_shoulder": assembly: its two sides become one chain
  const Real x3136 = x1330 * 0.4062719841254567 + x1337 * 0.7740926666331226;
  const Real x3138 = x1323 * 0.31570219645649206;
  const Real x3140 = x1323 * 0.3323181015331496;
  const Real x3144 = x1333 * 0.4062719841254567 + x1338 * 0.7740926666331226;
  const Real x3145 = x1326 * 0.31570219645649206;
  const Real x3147 = x1326 * 0.3323181015331496;
  const Real x3151 = x1336 * 0.4062719841254567 + x1340 * 0.7740926666331226;
  const Real x3152 = x1329 * 0.31570219645649206;
  const Real x3154 = x1329 * 0.3323181015331496;
  const Real x3225 = x1323 * 1.661590507665748;
  w.x[290] = x3225;
  const Real x3226 = x1330 * 2.1382736006602987;
  w.x[291] = x3226;
  const Real x3227 = x1337 * 3.870463333165613;
  w.x[292] = x3227;
  const Real x3228 = x1326 * 1.661590507665748;
  w.x[293] = x3228;
  const Real x3229 = x1333 * 2.1382736006602987;
  w.x[294] = x3229;
  const Real x3230 = x1338 * 3.870463333165613;
  w.x[295] = x3230;
  const Real x3231 = x1329 * 1.661590507665748;
  w.x[296] = x3231;
  const Real x3232 = x1336 * 2.1382736006602987;
  w.x[297] = x3232;
  const Real x3233 = x1340 * 3.870463333165613;
  w.x[298] = x3233;
  const Real x3264 = x1323 * 0.27548847118002645;
  const Real x3267 = x1330 * 0.10346167819629871 + x1337 * 0.06314043929129842;
  const Real x3270 = x1330 * 0.06314043929129842 + x1337 * 0.10994188117619515;
  const Real x3271 = x1326 * 0.27548847118002645;
  const Real x3274 = x1333 * 0.10346167819629871 + x1338 * 0.06314043929129842;
  const Real x3277 = x1333 * 0.06314043929129842 + x1338 * 0.10994188117619515;
  const Real x3311 = x1336 * (x1336 * 0.10346167819629871 + x1340 * 0.06314043929129842);
  const Real x3312 = x1340 * (x1336 * 0.06314043929129842 + x1340 * 0.10994188117619515);
  const Real x3238 = x1330 * x3226 + x1337 * x3227 + x1323 * x3225;
  // joint 13 "right_elbow": assembly: its two sides become one chain
  const Real x2760 = x2617 * x2713 + x2627 * x2723 - x2661 * x2731;
  // joint 12 "right_shoulder": assembly: its two sides become one chain
  const Real x3243 = x1333 * x3226 + x1338 * x3227 + x1326 * x3225;
  const Real x3316 = x2760 + x3243;
  const Real x3248 = x1336 * x3226 + x1340 * x3227 + x1329 * x3225;
  const Real x3317 = x2661 * x2732 - (x2627 * x2724 + x2773) + x3248;
  // joint 13 "right_elbow": assembly: its two sides become one chain
  const Real x2785 = x2617 * x2716 + x2627 * x2726 - x2661 * x2734;
  // joint 12 "right_shoulder": assembly: its two sides become one chain
  const Real x3162 = x1323 * x3136 - x1330 * x3138 - x1337 * x3140;
  const Real x3318 = x2785 + x3162;
  w.x[299] = x3318;
  const Real x3169 = x1326 * x3136 - x1333 * x3138 - x1338 * x3140;
  const Real x3319 = x2799 - x2661 * x2735 + x3169;
  w.x[300] = x3319;
  // joint 13 "right_elbow": assembly: its two sides become one chain
  const Real x2809 = x2661 * x2736 - (x2617 * x2720 + x2627 * x2728);
  // joint 12 "right_shoulder": assembly: its two sides become one chain
  const Real x3176 = x1329 * x3136 - x1336 * x3138 - x1340 * x3140;
  const Real x3320 = x2809 + x3176;
  w.x[301] = x3320;
  const Real x3253 = x1326 * x3228 + x1338 * x3230 + x1333 * x3229;
  // joint 13 "right_elbow": assembly: its two sides become one chain
  const Real x2826 = x2426 * x2715 + x2631 * x2724 + x2666 * x2732;
  // joint 12 "right_shoulder": assembly: its two sides become one chain
  const Real x3258 = x1329 * x3228 + x1340 * x3230 + x1336 * x3229;
  const Real x3322 = x2826 + x3258;
  const Real x3184 = x1323 * x3144 - (x1330 * x3145 + x1337 * x3147);
  const Real x3323 = x2834 - x2666 * x2734 + x3184;
  w.x[302] = x3323;
  const Real x3192 = x1326 * x3144 - (x1333 * x3145 + x1338 * x3147);
  // joint 13 "right_elbow": assembly: its two sides become one chain
  const Real x2844 = x2426 * x2718 + x2631 * x2727 + x2666 * x2735;
  // joint 12 "right_shoulder": assembly: its two sides become one chain
  const Real x3324 = x3192 - x2844;
  w.x[303] = x3324;
  // joint 13 "right_elbow": assembly: its two sides become one chain
  const Real x2853 = x2426 * x2720 + x2631 * x2728 + x2666 * x2736;
  // joint 12 "right_shoulder": assembly: its two sides become one chain
  const Real x3200 = x1329 * x3144 - (x1336 * x3145 + x1340 * x3147);
  const Real x3325 = x2853 + x3200;
  w.x[304] = x3325;
  const Real x3263 = x1329 * x3231 + x1336 * x3232 + x1340 * x3233;
  // joint 13 "right_elbow": assembly: its two sides become one chain
  const Real x2876 = x2619 * x2716 + x2636 * x2726 + x2679 * x2734;
  // joint 12 "right_shoulder": assembly: its two sides become one chain
  const Real x3208 = x1323 * x3151 - (x1330 * x3152 + x1337 * x3154);
  const Real x3327 = x2876 + x3208;
  w.x[305] = x3327;
  const Real x3216 = x1326 * x3151 - (x1333 * x3152 + x1338 * x3154);
  const Real x3328 = x2636 * x2727 + x2888 + x2679 * x2735 + x3216;
  w.x[306] = x3328;
  const Real x3224 = x1329 * x3151 - (x1336 * x3152 + x1340 * x3154);
  // joint 13 "right_elbow": assembly: its two sides become one chain
  const Real x2899 = x2619 * x2720 + x2636 * x2728 + x2679 * x2736;
  // joint 12 "right_shoulder": assembly: its two sides become one chain
  const Real x3329 = x3224 - x2899;
  w.x[307] = x3329;
  const Real x3289 = x1323 * x3264 + x1330 * x3267 + x1337 * x3270;
  const Real x3330 = x2908 - x2685 * x2734 + x3289;
  require_more(w, x3330, 2.892182775707059e-14, kGrowth, 12);
  require_more(w, x3330, 0.0, kFactorization, 12);
  const Real x3294 = x1326 * x3264 + x1333 * x3267 + x1338 * x3270;
  // joint 13 "right_elbow": assembly: its two sides become one chain
  const Real x2918 = x2596 * x2718 + x2640 * x2727 + x2685 * x2735;
  // joint 12 "right_shoulder": assembly: its two sides become one chain
  const Real x3331 = x3294 - x2918;
  // joint 13 "right_elbow": assembly: its two sides become one chain
  const Real x2927 = x2596 * x2720 + x2640 * x2728 + x2685 * x2736;
  // joint 12 "right_shoulder": assembly: its two sides become one chain
  const Real x3299 = x1329 * x3264 + x1336 * x3267 + x1340 * x3270;
  const Real x3332 = x2927 + x3299;
  const Real x3304 = x1326 * x3271 + x1333 * x3274 + x1338 * x3277;
  const Real x3333 = x2941 - x2697 * x2735 + x3304;
  require_more(w, x3333, 2.892182775707059e-14, kGrowth, 12);
  // joint 13 "right_elbow": assembly: its two sides become one chain
  const Real x2950 = x2621 * x2720 + x2645 * x2728 + x2697 * x2736;
  // joint 12 "right_shoulder": assembly: its two sides become one chain
  const Real x3309 = x1329 * x3271 + x1336 * x3274 + x1340 * x3277;
  const Real x3314 = x1329 * (x1329 * 0.27548847118002645) + x3311 + x3312;
  const Real x3335 = x2958 - x2702 * x2736 + x3314;
  require_more(w, x3335, 8.097260467014413e-15, kGrowth, 12);
  const Real x3342 = x3094 + 0.2 * x3090 + 0.42 * x3089;
  const Real x3346 = 0.42 * x3084 - x3097;
  const Real x3349 = 0.2 * x3084 - x3098;
  // joint 13 "right_elbow": assembly: its two sides become one chain
  const Real x3018 = x2969 - x2577 * x2721 + x2589 * x2730 + x2396;
  // joint 12 "right_shoulder": assembly: its two sides become one chain
  const Real x3358 = x1323 * x3084 + x1337 * x3090 + x1330 * x3089;
  const Real x3368 = x1326 * x3084 + x1338 * x3090 + x1333 * x3089;
  // joint 13 "right_elbow": assembly: its two sides become one chain
  const Real x3022 = x2986 - x2577 * x2724 - x2589 * x2732 + x2400;
  // joint 12 "right_shoulder": assembly: its two sides become one chain
  const Real x3378 = x1329 * x3084 + x1340 * x3090 + x1336 * x3089;
  const Real x3385 = x1330 * x3346 - x1323 * x3342 + x1337 * x3349;
  // joint 13 "right_elbow": assembly: its two sides become one chain
  const Real x3026 = x2577 * x2727 - x3005 + x2589 * x2735 + x2407;
  // joint 12 "right_shoulder": assembly: its two sides become one chain
  const Real x3391 = x1333 * x3346 - x1326 * x3342 + x1338 * x3349;
  const Real x3397 = x1336 * x3346 - x1329 * x3342 + x1340 * x3349;
  const Real x3404 = tau[33] * (x2751 - x2661 * x2730 + x3238);
  const Real x3410 = tau[34] * (x2817 - x2666 * x2731 + x3253);
  const Real x3416 = tau[35] * (x2867 - x2679 * x2732 + x3263);
  const Real x3408 = x3404 + tau[34] * x3316 + tau[35] * x3317;
  const Real x3434 = x3018 - x3358 - x3408;
  w.x[308] = x3434;
  const Real x3399 = 74.76523715533226 * tau[36] + x2977 + x2399 - x3368;
  const Real x3435 = x3399 - (tau[33] * x3316 + x3410 + tau[35] * x3322);
  w.x[309] = x3435;
  const Real x3418 = tau[33] * x3317 + tau[34] * x3322 + x3416;
  const Real x3436 = x3022 - x3378 - x3418;
  w.x[310] = x3436;
  const Real x3423 = tau[33] * x3318 + tau[34] * x3323 + tau[35] * x3327;
  const Real x3437 = 10.467133201746517 * tau[36] + x2994 + x2403 + x3385 - x3423;
  w.x[311] = x3437;
  const Real x3428 = tau[33] * x3319 + tau[34] * x3324 + tau[35] * x3328;
  const Real x3433 = tau[33] * x3320 + tau[34] * x3325 + tau[35] * x3329;
  const Real x3442 = 1 / x3330;
  w.x[312] = x3442;
  const Real x3443 = x3331 * x3442;
  w.x[313] = x3443;
  const Real x3444 = x3332 * x3442;
  w.x[314] = x3444;
  const Real x3447 = x3333 - x3331 * x3443;
  const Real x3450 = x2950 + x3309 - x3332 * x3443;
  const Real x3451 = 1 / x3447;
  w.x[315] = x3451;
  const Real x3452 = x3450 * x3451;
  w.x[316] = x3452;
  const Real x3458 = x3335 - x3332 * x3444 - x3450 * x3452;
  const Real x3459 = 1 / x3458;
  w.x[317] = x3459;
  const Real x3460 = 1.7763568394002505e-15 * x3333;
  require_more(w, x3447, x3460, kFactorization, 12);
  const Real x3461 = 1.7763568394002505e-15 * x3335;
  require_more(w, x3458, x3461, kFactorization, 12);
  const Real x3464 = x3026 + x3391 - x3428 - x3437 * x3443;
  w.x[318] = x3464;
  const Real x3469 = x2408 + x3015 + x3397 - x3433 - x3437 * x3444;
  const Real x3470 = x3469 - x3452 * x3464;
  w.x[319] = x3470;
  const Real x3475 = x1330 * 0.31570219645649206 + x1337 * 0.3323181015331496;
  w.x[320] = x3475;
  const Real x3489 = x1323 * 0.4062719841254567;
  w.x[321] = x3489;
  const Real x3492 = x1323 * 0.7740926666331226;
  w.x[322] = x3492;
  const Real x3495 = x1330 * 0.49180292815186877;
  w.x[323] = x3495;
  const Real x3497 = x1333 * 0.49180292815186877;
  w.x[324] = x3497;
  const Real x3499 = x1336 * 0.49180292815186877;
  w.x[325] = x3499;
  const Real x3502 = x1323 * 0.04996429547928984;
  w.x[326] = x3502;
  const Real x3510 = x1323 * 0.38216581676312206;
  w.x[327] = x3510;
  const Real x3511 = x1326 * 0.38216581676312206;
  w.x[328] = x3511;
  const Real x3512 = x1329 * 0.38216581676312206;
  w.x[329] = x3512;
  const Real x3518 = x1330 * 0.029133244315427954 + x1337 * 0.07643316335262441;
  w.x[330] = x3518;
  const Real x3532 = x1337 * 0.043478260869565216;
  w.x[331] = x3532;
  const Real x3537 = x3443 * x3475 - (x1333 * 0.31570219645649206 + x1338 * 0.3323181015331496);
  w.x[332] = x3537;
  const Real x3540 = x1326 * 0.4062719841254567 - x3443 * x3489;
  w.x[333] = x3540;
  const Real x3543 = x1326 * 0.7740926666331226 - x3443 * x3492;
  w.x[334] = x3543;
  const Real x3546 = x3443 * x3502 - x1326 * 0.04996429547928984;
  w.x[335] = x3546;
  const Real x3549 = x3443 * x3518 - (x1333 * 0.029133244315427954 + x1338 * 0.07643316335262441);
  w.x[336] = x3549;
  const Real x3552 = x1338 * 0.043478260869565216 - x3443 * x3532;
  w.x[337] = x3552;
  const Real x3557 = x3444 * x3475 - (x1336 * 0.31570219645649206 + x1340 * 0.3323181015331496);
  const Real x3558 = x3557 - x3452 * x3537;
  w.x[338] = x3558;
  const Real x3564 = x1329 * 0.4062719841254567 - x3444 * x3489 - x3452 * x3540;
  w.x[339] = x3564;
  const Real x3570 = x1329 * 0.7740926666331226 - x3444 * x3492 - x3452 * x3543;
  w.x[340] = x3570;
  const Real x3576 = x3444 * x3502 - x1329 * 0.04996429547928984 - x3452 * x3546;
  w.x[341] = x3576;
  const Real x3581 = x3444 * x3518 - (x1336 * 0.029133244315427954 + x1340 * 0.07643316335262441);
  const Real x3582 = x3581 - x3452 * x3549;
  w.x[342] = x3582;
  const Real x3588 = x1340 * 0.043478260869565216 - x3444 * x3532 - x3452 * x3552;
  w.x[343] = x3588;
  const Real x3589 = x3442 * x3475;
  w.x[344] = x3589;
  const Real x3591 = x3442 * x3489;
  w.x[345] = x3591;
  const Real x3592 = x3442 * x3492;
  w.x[346] = x3592;
  const Real x3593 = x3442 * x3502;
  w.x[347] = x3593;
  const Real x3595 = x3442 * x3518;
  w.x[348] = x3595;
  const Real x3597 = x3442 * x3532;
  w.x[349] = x3597;
  const Real x3598 = x3451 * x3537;
  w.x[350] = x3598;
  const Real x3599 = x3451 * x3540;
  w.x[351] = x3599;
  const Real x3600 = x3451 * x3543;
  w.x[352] = x3600;
  const Real x3601 = x3451 * x3546;
  w.x[353] = x3601;
  const Real x3602 = x3451 * x3549;
  w.x[354] = x3602;
  const Real x3603 = x3451 * x3552;
  w.x[355] = x3603;
  const Real x3604 = x3459 * x3558;
  w.x[356] = x3604;
  const Real x3605 = x3459 * x3564;
  w.x[357] = x3605;
  const Real x3606 = x3459 * x3570;
  w.x[358] = x3606;
  const Real x3607 = x3459 * x3576;
  w.x[359] = x3607;
  const Real x3608 = x3459 * x3582;
  w.x[360] = x3608;
  const Real x3609 = x3459 * x3588;
  w.x[361] = x3609;
  const Real x3617 = 1.661590507665748 - x3475 * x3589 - x3537 * x3598;
  const Real x3618 = x3617 - x3558 * x3604;
  w.x[362] = x3618;
  const Real x3626 = x3475 * x3591 - x3537 * x3599 - x3558 * x3605;
  w.x[363] = x3626;
  const Real x3634 = x3475 * x3592 - x3537 * x3600 - x3558 * x3606;
  w.x[364] = x3634;
  const Real x3643 = x3475 * x3593 + x3537 * x3601 + x3558 * x3607;
  w.x[365] = x3643;
}

ADAGEN_NOINLINE void part_0_3(Workspace& w) {
  ADAGEN_INPUTS
  const Real x1056 = w.x[139];
  const Real x1059 = w.x[140];
  const Real x1062 = w.x[141];
  const Real x1063 = w.x[142];
  const Real x1066 = w.x[143];
  const Real x1069 = w.x[144];
  const Real x1070 = w.x[145];
  const Real x1071 = w.x[146];
  const Real x1073 = w.x[147];
  const Real x1191 = w.x[154];
  const Real x1194 = w.x[155];
  const Real x1197 = w.x[156];
  const Real x1198 = w.x[157];
  const Real x1201 = w.x[158];
  const Real x1204 = w.x[159];
  const Real x1205 = w.x[160];
  const Real x1206 = w.x[161];
  const Real x1208 = w.x[162];
  const Real x3084 = w.x[104];
  const Real x3089 = w.x[105];
  const Real x3090 = w.x[106];
  const Real x3094 = w.x[107];
  const Real x3097 = w.x[108];
  const Real x3098 = w.x[109];
  const Real x3225 = w.x[290];
  const Real x3226 = w.x[291];
  const Real x3227 = w.x[292];
  const Real x3228 = w.x[293];
  const Real x3229 = w.x[294];
  const Real x3230 = w.x[295];
  const Real x3231 = w.x[296];
  const Real x3232 = w.x[297];
  const Real x3233 = w.x[298];
  const Real x3437 = w.x[311];
  const Real x3464 = w.x[318];
  const Real x3470 = w.x[319];
  const Real x3475 = w.x[320];
  const Real x3489 = w.x[321];
  const Real x3492 = w.x[322];
  const Real x3495 = w.x[323];
  const Real x3497 = w.x[324];
  const Real x3499 = w.x[325];
  const Real x3502 = w.x[326];
  const Real x3510 = w.x[327];
  const Real x3511 = w.x[328];
  const Real x3512 = w.x[329];
  const Real x3518 = w.x[330];
  const Real x3532 = w.x[331];
  const Real x3537 = w.x[332];
  const Real x3540 = w.x[333];
  const Real x3543 = w.x[334];
  const Real x3546 = w.x[335];
  const Real x3549 = w.x[336];
  const Real x3552 = w.x[337];
  const Real x3558 = w.x[338];
  const Real x3564 = w.x[339];
  const Real x3570 = w.x[340];
  const Real x3576 = w.x[341];
  const Real x3582 = w.x[342];
  const Real x3588 = w.x[343];
  const Real x3589 = w.x[344];
  const Real x3591 = w.x[345];
  const Real x3592 = w.x[346];
  const Real x3593 = w.x[347];
  const Real x3595 = w.x[348];
  const Real x3597 = w.x[349];
  const Real x3598 = w.x[350];
  const Real x3599 = w.x[351];
  const Real x3600 = w.x[352];
  const Real x3601 = w.x[353];
  const Real x3602 = w.x[354];
  const Real x3603 = w.x[355];
  const Real x3604 = w.x[356];
  const Real x3605 = w.x[357];
  const Real x3606 = w.x[358];
  const Real x3607 = w.x[359];
  const Real x3608 = w.x[360];
  const Real x3609 = w.x[361];
  const Real x3618 = w.x[362];
  const Real x3626 = w.x[363];
  const Real x3634 = w.x[364];
  const Real x3643 = w.x[365];
  const Real x3954 = w.x[163];
  const Real x3960 = w.x[164];
  const Real x3964 = w.x[165];
  const Real x3972 = w.x[166];
  const Real x3978 = w.x[167];
  const Real x3984 = w.x[168];
  // joint 12 "right_shoulder": assembly: its two sides become one chain
  const Real x3652 = 0.38216581676312206 - x3475 * x3595 - x3537 * x3602;
  const Real x3653 = x3652 - x3558 * x3608;
  const Real x3661 = x3475 * x3597 - x3537 * x3603 - x3558 * x3609;
  const Real x3669 = 2.1382736006602987 - x3489 * x3591 - x3540 * x3599;
  const Real x3670 = x3669 - x3564 * x3605;
  const Real x3679 = x3489 * x3592 + x3540 * x3600 + x3564 * x3606;
  const Real x3688 = -0.49180292815186877 + x3489 * x3593 - x3540 * x3601;
  const Real x3689 = x3688 - x3564 * x3607;
  const Real x3697 = x3489 * x3595 - x3540 * x3602 - x3564 * x3608;
  const Real x3706 = x3489 * x3597 + x3540 * x3603 + x3564 * x3609;
  const Real x3715 = 3.870463333165613 - x3492 * x3592 - x3543 * x3600;
  const Real x3716 = x3715 - x3570 * x3606;
  const Real x3724 = x3492 * x3593 - x3543 * x3601 - x3570 * x3607;
  const Real x3732 = x3492 * x3595 - x3543 * x3602 - x3570 * x3608;
  const Real x3741 = x3492 * x3597 + x3543 * x3603 + x3570 * x3609;
  const Real x3750 = 0.15659293434449503 - x3502 * x3593 - x3546 * x3601;
  const Real x3751 = x3750 - x3576 * x3607;
  const Real x3760 = x3502 * x3595 + x3546 * x3602 + x3576 * x3608;
  const Real x3769 = x3502 * x3597 - x3546 * x3603 - x3576 * x3609;
  const Real x3777 = 0.1313763987250833 - x3518 * x3595 - x3549 * x3602;
  const Real x3778 = x3777 - x3582 * x3608;
  const Real x3786 = x3518 * x3597 - x3549 * x3603 - x3582 * x3609;
  const Real x3794 = 0.043478260869565216 - x3532 * x3597 - x3552 * x3603;
  const Real x3795 = x3794 - x3588 * x3609;
  const Real x3800 = tau[34] * x3228 + tau[35] * x3231 + tau[33] * x3225;
  const Real x3831 = x3464 * x3598 - x3437 * x3589 + x3470 * x3604;
  const Real x3805 = tau[33] * x3226 + tau[35] * x3232 + tau[34] * x3229;
  const Real x3836 = x3437 * x3591 + x3464 * x3599 + x3470 * x3605;
  const Real x3810 = tau[33] * x3227 + tau[34] * x3230 + tau[35] * x3233;
  const Real x3841 = x3437 * x3592 + x3464 * x3600 + x3470 * x3606;
  const Real x3847 = x3464 * x3601 - x3437 * x3593 + x3470 * x3607;
  const Real x3819 = tau[33] * x3495 + tau[35] * x3499 + tau[34] * x3497;
  const Real x3825 = tau[34] * x3511 + tau[35] * x3512 + tau[33] * x3510;
  const Real x3853 = x3464 * x3602 - x3437 * x3595 + x3470 * x3608;
  const Real x3864 = x3800 + x3831 + x3084;
  const Real x3866 = x3805 + x3836 + x3089;
  const Real x3868 = x3810 + x3841 + x3090;
  const Real x3870 = x3847 - x3819 + x3094;
  const Real x3872 = x3825 + x3853 + x3097;
  const Real x3858 = x3437 * x3597 + x3464 * x3603 + x3470 * x3609;
  const Real x3874 = x3098 + x3858;
  // joint 11 "neck": assembly: its two sides become one chain
  const Real x3995 = 0.48 * x3626;
  const Real x3997 = x3995 - x3643;
  const Real x4000 = x3653 - 0.48 * x3618;
  const Real x4003 = x3689 + 0.48 * x3670;
  const Real x4004 = x3697 - x3995;
  const Real x4007 = x3724 - 0.48 * x3679;
  const Real x4010 = x3732 - 0.48 * x3634;
  const Real x4015 = x3751 + 0.48 * x3689;
  const Real x4016 = 0.48 * x4003 + x4015;
  const Real x4021 = 0.48 * x3697 - x3760;
  const Real x4022 = x4021 - 0.48 * x3997;
  const Real x4025 = x3769 - 0.48 * x3706;
  const Real x4030 = x3778 - 0.48 * x3653;
  const Real x4031 = x4030 - 0.48 * x4000;
  const Real x4034 = x3786 - 0.48 * x3661;
  const Real x4035 = x1191 * x3997;
  const Real x4039 = x4035 + x1198 * x4003 + x1205 * x4007;
  const Real x4041 = x1198 * x4004;
  const Real x4044 = x1191 * x4000 + x4041 + x1205 * x4010;
  const Real x4048 = x1205 * x3741;
  const Real x4051 = x1191 * x3661 - x1198 * x3706 - x4048;
  w.x[183] = x4051;
  const Real x4052 = x1194 * x3997;
  const Real x4056 = x4052 + x1201 * x4003 + x1206 * x4007;
  const Real x4058 = x1201 * x4004;
  const Real x4061 = x1194 * x4000 + x4058 + x1206 * x4010;
  const Real x4065 = x1206 * x3741;
  const Real x4068 = x1194 * x3661 - x1201 * x3706 - x4065;
  w.x[182] = x4068;
  const Real x4069 = x1197 * x3997;
  const Real x4073 = x4069 + x1204 * x4003 + x1208 * x4007;
  const Real x4075 = x1204 * x4004;
  const Real x4078 = x1197 * x4000 + x4075 + x1208 * x4010;
  const Real x4082 = x1208 * x3741;
  const Real x4085 = x1197 * x3661 - x1204 * x3706 - x4082;
  w.x[181] = x4085;
  const Real x4090 = x1191 * x4039 + x1205 * x4051 + x1198 * x4044;
  w.x[180] = x4090;
  const Real x4100 = x1197 * x4039 + x1208 * x4051 + x1204 * x4044;
  w.x[179] = x4100;
  const Real x4110 = x1194 * x4056 + x1206 * x4068 + x1201 * x4061;
  w.x[178] = x4110;
  const Real x4120 = x1191 * x4073 + x1205 * x4085 + x1198 * x4078;
  w.x[234] = x4120;
  const Real x4130 = x1197 * x4073 + x1208 * x4085 + x1204 * x4078;
  w.x[233] = x4130;
  const Real x4135 = x1191 * x3618 + x1198 * x3626 + x1205 * x3634;
  w.x[232] = x4135;
  const Real x4141 = x1191 * x3626 + x1198 * x3670 - x1205 * x3679;
  w.x[231] = x4141;
  const Real x4147 = x1191 * x3634 - x1198 * x3679 + x1205 * x3716;
  w.x[230] = x4147;
  const Real x4152 = x1194 * x3618 + x1201 * x3626 + x1206 * x3634;
  w.x[229] = x4152;
  const Real x4158 = x1194 * x3626 + x1201 * x3670 - x1206 * x3679;
  w.x[228] = x4158;
  const Real x4164 = x1194 * x3634 - x1201 * x3679 + x1206 * x3716;
  w.x[227] = x4164;
  const Real x4169 = x1197 * x3618 + x1204 * x3626 + x1208 * x3634;
  w.x[226] = x4169;
  const Real x4175 = x1197 * x3626 + x1204 * x3670 - x1208 * x3679;
  w.x[223] = x4175;
  const Real x4181 = x1197 * x3634 - x1204 * x3679 + x1208 * x3716;
  w.x[222] = x4181;
  const Real x4191 = x1194 * x4135 + x1201 * x4141 + x1206 * x4147;
  const Real x4196 = x1197 * x4135 + x1204 * x4141 + x1208 * x4147;
  const Real x4206 = x1197 * x4152 + x1204 * x4158 + x1208 * x4164;
  const Real x4216 = x1191 * x4016 + x1205 * x4025 + x1198 * x4022;
  const Real x4221 = x1191 * x4022 + x1205 * x4034 + x1198 * x4031;
  const Real x4226 = x1191 * x4025 + x1205 * x3795 + x1198 * x4034;
  w.x[221] = x4226;
  const Real x4231 = x1194 * x4016 + x1206 * x4025 + x1201 * x4022;
  const Real x4236 = x1194 * x4022 + x1206 * x4034 + x1201 * x4031;
  const Real x4241 = x1194 * x4025 + x1206 * x3795 + x1201 * x4034;
  const Real x4256 = x1197 * x4025 + x1208 * x3795 + x1204 * x4034;
  const Real x4266 = x1194 * x4216 + x1206 * x4226 + x1201 * x4221;
  const Real x4246 = x1197 * x4016 + x1208 * x4025 + x1204 * x4022;
  const Real x4251 = x1197 * x4022 + x1208 * x4034 + x1204 * x4031;
  const Real x4186 = x1191 * x4135 + x1198 * x4141 + x1205 * x4147;
  const Real x4095 = x1194 * x4039 + x1206 * x4051 + x1201 * x4044;
  const Real x4288 = 7.142857142857144 + x4095;
  w.x[220] = x4288;
  const Real x4201 = x1194 * x4152 + x1201 * x4158 + x1206 * x4164;
  const Real x4105 = x1191 * x4056 + x1205 * x4068 + x1198 * x4061;
  const Real x4290 = -7.142857142857144 + x4105;
  w.x[219] = x4290;
  const Real x4115 = x1197 * x4056 + x1208 * x4068 + x1204 * x4061;
  const Real x4291 = 0.5102040816326531 + x4115;
  w.x[201] = x4291;
  const Real x4211 = x1197 * x4169 + x1204 * x4175 + x1208 * x4181;
  const Real x4125 = x1194 * x4073 + x1206 * x4085 + x1201 * x4078;
  const Real x4293 = -0.5102040816326531 + x4125;
  w.x[200] = x4293;
  const Real x4261 = x1191 * x4216 + x1205 * x4226 + x1198 * x4221;
  const Real x4294 = 1.2040816326530615 + x4261;
  require_more(w, x4294, 1.772889239536293e-14, kGrowth, 11);
  require_more(w, x4294, 0.0, kFactorization, 11);
  const Real x4271 = x1197 * x4216 + x1208 * x4226 + x1204 * x4221;
  const Real x4295 = -0.07142857142857144 + x4271;
  const Real x4276 = x1194 * x4231 + x1206 * x4241 + x1201 * x4236;
  const Real x4296 = 1.209183673469388 + x4276;
  require_more(w, x4296, 1.7801396756154775e-14, kGrowth, 11);
  const Real x4286 = x1197 * x4246 + x1208 * x4256 + x1204 * x4251;
  const Real x4297 = 0.20918367346938774 + x4286;
  require_more(w, x4297, 3.590542040952769e-15, kGrowth, 11);
  const Real x4300 = x3870 + 0.48 * x3866;
  const Real x4304 = 0.48 * x3864 - x3872;
  const Real x4313 = x1191 * x3864 + x1198 * x3866 + x1205 * x3868;
  const Real x4323 = x1194 * x3864 + x1201 * x3866 + x1206 * x3868;
  const Real x4333 = x1197 * x3864 + x1204 * x3866 + x1208 * x3868;
  const Real x4342 = x1198 * x4304 - (x1191 * x4300 + x1205 * x3874);
  const Real x4350 = x1201 * x4304 - (x1194 * x4300 + x1206 * x3874);
  const Real x4358 = x1204 * x4304 - (x1197 * x4300 + x1208 * x3874);
  const Real x4368 = tau[31] * x4191 + tau[32] * x4196;
  const Real x4373 = tau[30] * x4191 + tau[32] * x4206;
  const Real x4378 = tau[30] * x4196 + tau[31] * x4206;
  const Real x4395 = x3954 - x4313 - (tau[30] * (51.02040816326531 + x4186) + x4368);
  w.x[199] = x4395;
  const Real x4396 = x3960 - x4323 - (tau[31] * (51.02040816326531 + x4201) + x4373);
  w.x[198] = x4396;
  const Real x4397 = x3964 - x4333 - (tau[32] * (51.02040816326531 + x4211) + x4378);
  w.x[189] = x4397;
  const Real x4384 = tau[30] * x4090 + tau[32] * x4120 + tau[31] * x4290;
  const Real x4398 = x3972 + x4342 - x4384;
  w.x[188] = x4398;
  const Real x4389 = tau[30] * x4288 + tau[31] * x4110 + tau[32] * x4293;
  const Real x4394 = tau[30] * x4100 + tau[32] * x4130 + tau[31] * x4291;
  const Real x4404 = 1 / x4294;
  w.x[187] = x4404;
  const Real x4405 = x4266 * x4404;
  w.x[186] = x4405;
  const Real x4406 = x4295 * x4404;
  w.x[185] = x4406;
  const Real x4409 = x4296 - x4266 * x4405;
  const Real x4281 = x1197 * x4231 + x1208 * x4241 + x1204 * x4236;
  const Real x4412 = x4281 - x4295 * x4405;
  const Real x4413 = 1 / x4409;
  w.x[184] = x4413;
  const Real x4414 = x4412 * x4413;
  w.x[195] = x4414;
  const Real x4420 = x4297 - x4295 * x4406 - x4412 * x4414;
  const Real x4421 = 1 / x4420;
  w.x[194] = x4421;
  const Real x4422 = 1.7763568394002505e-15 * x4296;
  require_more(w, x4409, x4422, kFactorization, 11);
  const Real x4423 = 1.7763568394002505e-15 * x4297;
  require_more(w, x4420, x4423, kFactorization, 11);
  const Real x4426 = x3978 + x4350 - x4389 - x4398 * x4405;
  w.x[193] = x4426;
  const Real x4431 = x3984 + x4358 - x4394 - x4398 * x4406;
  const Real x4432 = x4431 - x4414 * x4426;
  w.x[192] = x4432;
  const Real x4436 = x4035 + x1205 * x3661 + x1198 * x4000;
  w.x[191] = x4436;
  const Real x4449 = x1191 * x4003 - x1205 * x3706 + x4041;
  w.x[190] = x4449;
  const Real x4463 = x1191 * x4007 - x4048 + x1198 * x4010;
  w.x[177] = x4463;
  const Real x4474 = 0.48 * x3643 - x3760;
  const Real x4480 = x1198 * x3689 - x1191 * x3643 + x1205 * x3724;
  w.x[176] = x4480;
  const Real x4486 = x1201 * x3689 - x1194 * x3643 + x1206 * x3724;
  w.x[175] = x4486;
  const Real x4492 = x1204 * x3689 - x1197 * x3643 + x1208 * x3724;
  w.x[174] = x4492;
  const Real x4497 = x1191 * x4015 + x1205 * x3769 + x1198 * x4474;
  w.x[173] = x4497;
  const Real x4512 = x1191 * x3653 + x1198 * x3697 + x1205 * x3732;
  w.x[172] = x4512;
  const Real x4517 = x1194 * x3653 + x1201 * x3697 + x1206 * x3732;
  w.x[171] = x4517;
  const Real x4522 = x1197 * x3653 + x1204 * x3697 + x1208 * x3732;
  w.x[170] = x4522;
  const Real x4527 = x1191 * x4021 + x1205 * x3786 + x1198 * x4030;
  w.x[169] = x4527;
  const Real x4440 = x4052 + x1206 * x3661 + x1201 * x4000;
  const Real x4540 = x4440 - x4405 * x4436;
  w.x[366] = x4540;
  const Real x4454 = x1194 * x4003 - x1206 * x3706 + x4058;
  const Real x4543 = x4454 - x4405 * x4449;
  w.x[367] = x4543;
  const Real x4467 = x1194 * x4007 - x4065 + x1201 * x4010;
  const Real x4546 = x4467 - x4405 * x4463;
  w.x[368] = x4546;
  const Real x4502 = x1194 * x4015 + x1206 * x3769 + x1201 * x4474;
  const Real x4549 = x4502 - x4405 * x4497;
  w.x[369] = x4549;
  const Real x4532 = x1194 * x4021 + x1206 * x3786 + x1201 * x4030;
  const Real x4552 = x4532 - x4405 * x4527;
  w.x[370] = x4552;
  const Real x4555 = x4241 - x4226 * x4405;
  w.x[371] = x4555;
  const Real x4444 = x4069 + x1208 * x3661 + x1204 * x4000;
  const Real x4561 = x4444 - x4406 * x4436 - x4414 * x4540;
  w.x[372] = x4561;
  const Real x4459 = x1197 * x4003 - x1208 * x3706 + x4075;
  const Real x4567 = x4459 - x4406 * x4449 - x4414 * x4543;
  w.x[373] = x4567;
  const Real x4471 = x1197 * x4007 - x4082 + x1204 * x4010;
  const Real x4573 = x4471 - x4406 * x4463 - x4414 * x4546;
  w.x[374] = x4573;
  const Real x4507 = x1197 * x4015 + x1208 * x3769 + x1204 * x4474;
  const Real x4579 = x4507 - x4406 * x4497 - x4414 * x4549;
  w.x[375] = x4579;
  const Real x4537 = x1197 * x4021 + x1208 * x3786 + x1204 * x4030;
  const Real x4585 = x4537 - x4406 * x4527 - x4414 * x4552;
  w.x[376] = x4585;
  const Real x4591 = x4256 - x4226 * x4406 - x4414 * x4555;
  w.x[377] = x4591;
  const Real x4592 = x4404 * x4436;
  const Real x4593 = x4404 * x4449;
  const Real x4594 = x4404 * x4463;
  const Real x4595 = x4404 * x4497;
  const Real x4596 = x4404 * x4527;
  const Real x4597 = x4226 * x4404;
  const Real x4598 = x4413 * x4540;
  const Real x4599 = x4413 * x4543;
  const Real x4600 = x4413 * x4546;
  const Real x4601 = x4413 * x4549;
  const Real x4602 = x4413 * x4552;
  const Real x4603 = x4413 * x4555;
  const Real x4604 = x4421 * x4561;
  const Real x4605 = x4421 * x4567;
  const Real x4606 = x4421 * x4573;
  const Real x4607 = x4421 * x4579;
  const Real x4608 = x4421 * x4585;
  const Real x4609 = x4421 * x4591;
  const Real x4617 = x3618 - x4436 * x4592 - x4540 * x4598;
  const Real x4618 = x4617 - x4561 * x4604;
  w.x[378] = x4618;
  const Real x4626 = x3626 - x4436 * x4593 - x4540 * x4599;
  const Real x4627 = x4626 - x4561 * x4605;
  w.x[379] = x4627;
  const Real x4635 = x3634 - x4436 * x4594 - x4540 * x4600;
  const Real x4636 = x4635 - x4561 * x4606;
  w.x[380] = x4636;
  const Real x4645 = x3643 + x4436 * x4595 + x4540 * x4601;
  const Real x4647 = x4561 * x4607 + x4645;
  w.x[381] = x4647;
  const Real x4656 = x3653 - x4436 * x4596 - x4540 * x4602;
  const Real x4657 = x4656 - x4561 * x4608;
  w.x[382] = x4657;
  const Real x4665 = x3661 - x4436 * x4597 - x4540 * x4603;
  const Real x4666 = x4665 - x4561 * x4609;
  w.x[383] = x4666;
  const Real x4674 = x3670 - x4449 * x4593 - x4543 * x4599;
  const Real x4675 = x4674 - x4567 * x4605;
  w.x[384] = x4675;
  const Real x4684 = x3679 + x4449 * x4594 + x4543 * x4600;
  const Real x4686 = x4567 * x4606 + x4684;
  w.x[385] = x4686;
  const Real x4695 = x3689 - x4449 * x4595 - x4543 * x4601;
  const Real x4696 = x4695 - x4567 * x4607;
  w.x[386] = x4696;
  const Real x4704 = x3697 - x4449 * x4596 - x4543 * x4602;
  const Real x4705 = x4704 - x4567 * x4608;
  w.x[387] = x4705;
  const Real x4714 = x3706 + x4449 * x4597 + x4543 * x4603;
  const Real x4716 = x4567 * x4609 + x4714;
  w.x[388] = x4716;
  const Real x4725 = x3716 - x4463 * x4594 - x4546 * x4600;
  const Real x4726 = x4725 - x4573 * x4606;
  w.x[389] = x4726;
  const Real x4734 = x3724 - x4463 * x4595 - x4546 * x4601;
  const Real x4735 = x4734 - x4573 * x4607;
  w.x[390] = x4735;
  const Real x4743 = x3732 - x4463 * x4596 - x4546 * x4602;
  const Real x4744 = x4743 - x4573 * x4608;
  w.x[391] = x4744;
  const Real x4753 = x3741 + x4463 * x4597 + x4546 * x4603;
  const Real x4755 = x4573 * x4609 + x4753;
  w.x[392] = x4755;
  const Real x4764 = x3751 - x4497 * x4595 - x4549 * x4601;
  const Real x4765 = x4764 - x4579 * x4607;
  w.x[393] = x4765;
  const Real x4774 = x3760 + x4497 * x4596 + x4549 * x4602;
  const Real x4776 = x4579 * x4608 + x4774;
  w.x[394] = x4776;
  const Real x4785 = x3769 - x4497 * x4597 - x4549 * x4603;
  const Real x4786 = x4785 - x4579 * x4609;
  w.x[395] = x4786;
  const Real x4794 = x3778 - x4527 * x4596 - x4552 * x4602;
  const Real x4795 = x4794 - x4585 * x4608;
  w.x[396] = x4795;
  const Real x4803 = x3786 - x4527 * x4597 - x4552 * x4603;
  const Real x4804 = x4803 - x4585 * x4609;
  w.x[397] = x4804;
  const Real x4812 = x3795 - x4226 * x4597 - x4555 * x4603;
  const Real x4813 = x4812 - x4591 * x4609;
  w.x[398] = x4813;
  const Real x4818 = tau[30] * x4135 + tau[31] * x4152 + tau[32] * x4169;
  const Real x4848 = x4398 * x4592 + x4426 * x4598 + x4432 * x4604;
  const Real x4823 = tau[30] * x4141 + tau[31] * x4158 + tau[32] * x4175;
  const Real x4853 = x4398 * x4593 + x4426 * x4599 + x4432 * x4605;
  const Real x4828 = tau[30] * x4147 + tau[31] * x4164 + tau[32] * x4181;
  const Real x4858 = x4398 * x4594 + x4426 * x4600 + x4432 * x4606;
  const Real x4833 = tau[30] * x4480 + tau[31] * x4486 + tau[32] * x4492;
  const Real x4863 = x4398 * x4595 + x4426 * x4601 + x4432 * x4607;
  const Real x4838 = tau[30] * x4512 + tau[31] * x4517 + tau[32] * x4522;
  const Real x4868 = x4398 * x4596 + x4426 * x4602 + x4432 * x4608;
  const Real x4843 = tau[30] * x4051 + tau[31] * x4068 + tau[32] * x4085;
  const Real x4873 = x4398 * x4597 + x4426 * x4603 + x4432 * x4609;
  const Real x4880 = x4818 + x4848 + x3864;
  w.x[399] = x4880;
  const Real x4882 = x4823 + x4853 + x3866;
  w.x[400] = x4882;
  const Real x4884 = x4828 + x4858 + x3868;
  w.x[401] = x4884;
  const Real x4886 = x4833 + x4863 + x3870;
  w.x[402] = x4886;
  const Real x4888 = x4838 + x4868 + x3872;
  w.x[403] = x4888;
  const Real x4890 = x4843 + x4873 + x3874;
  w.x[404] = x4890;
  // joint 10 "left_wrist": assembly: its two sides become one chain
  const Real x5000 = x1063 * 23.079307093260184;
  w.x[405] = x5000;
  const Real x5002 = x1056 * 23.079307093260184;
  w.x[406] = x5002;
  const Real x5003 = x1066 * 23.079307093260184;
  w.x[407] = x5003;
  const Real x5005 = x1059 * 23.079307093260184;
  w.x[408] = x5005;
  const Real x5006 = x1069 * 23.079307093260184;
  w.x[409] = x5006;
  const Real x5008 = x1062 * 23.079307093260184;
  w.x[410] = x5008;
  const Real x5012 = x1063 * x5002 - x1056 * x5000;
  w.x[411] = x5012;
  const Real x5020 = x1069 * x5002 - x1062 * x5000;
  w.x[412] = x5020;
  const Real x5028 = x1066 * x5005 - x1059 * x5003;
  w.x[413] = x5028;
  const Real x5032 = x1069 * x5005 - x1062 * x5003;
  w.x[414] = x5032;
  const Real x5036 = x1063 * x5008 - x1056 * x5006;
  w.x[415] = x5036;
  const Real x5040 = x1066 * x5008 - x1059 * x5006;
  w.x[416] = x5040;
  const Real x5044 = x1069 * x5008 - x1062 * x5006;
  w.x[417] = x5044;
  const Real x5045 = x1070 * 1484.2300556586272;
  w.x[418] = x5045;
  const Real x5046 = x1056 * 164.852193523287;
  w.x[419] = x5046;
  const Real x5047 = x1063 * 164.852193523287;
  w.x[420] = x5047;
  const Real x5048 = x1071 * 1484.2300556586272;
  w.x[421] = x5048;
  const Real x5049 = x1059 * 164.852193523287;
  w.x[422] = x5049;
  const Real x5050 = x1066 * 164.852193523287;
  w.x[423] = x5050;
  const Real x5051 = x1073 * 1484.2300556586272;
  w.x[424] = x5051;
  const Real x5052 = x1062 * 164.852193523287;
  w.x[425] = x5052;
  const Real x5053 = x1069 * 164.852193523287;
  w.x[426] = x5053;
  const Real x5063 = x1071 * x5045 + x1066 * x5047 + x1059 * x5046;
  w.x[427] = x5063;
  const Real x5068 = x1073 * x5045 + x1069 * x5047 + x1062 * x5046;
  w.x[428] = x5068;
  const Real x5078 = x1073 * x5048 + x1062 * x5049 + x1069 * x5050;
  w.x[429] = x5078;
  const Real x5084 = x1070 * 0.9090909090909091;
  w.x[430] = x5084;
  const Real x5085 = x1056 * 4.140193902147335;
  const Real x5086 = x1063 * 4.140193902147335;
  const Real x5087 = x1071 * 0.9090909090909091;
  w.x[431] = x5087;
  const Real x5088 = x1059 * 4.140193902147335;
  const Real x5089 = x1066 * 4.140193902147335;
  const Real x5090 = x1073 * 0.9090909090909091;
  w.x[432] = x5090;
  const Real x5097 = x1070 * x5084 + x1063 * x5086 + x1056 * x5085;
  w.x[433] = x5097;
  const Real x5102 = x1071 * x5084 + x1066 * x5086 + x1059 * x5085;
  w.x[434] = x5102;
  const Real x5107 = x1073 * x5084 + x1069 * x5086 + x1062 * x5085;
  w.x[435] = x5107;
  const Real x5112 = x1071 * x5087 + x1059 * x5088 + x1066 * x5089;
  w.x[436] = x5112;
  const Real x5117 = x1073 * x5087 + x1062 * x5088 + x1069 * x5089;
  w.x[437] = x5117;
  const Real x5121 = x1062 * (x1062 * 4.140193902147335) + x1069 * (x1069 * 4.140193902147335);
  const Real x5122 = x1073 * x5090 + x5121;
  w.x[438] = x5122;
  const Real x5058 = x1070 * x5045 + x1063 * x5047 + x1056 * x5046;
  const Real x5123 = 809.3889113719142 + x5058;
  w.x[439] = x5123;
  const Real x5124 = x1066 * x5002 - x1059 * x5000 + -64.75111290975313;
  w.x[440] = x5124;
  const Real x5073 = x1071 * x5048 + x1059 * x5049 + x1066 * x5050;
  const Real x5125 = 958.7727708533076 + x5073;
  w.x[441] = x5125;
  const Real x5126 = x1063 * x5005 - x1056 * x5003 + 76.70182166826461;
  w.x[442] = x5126;
  const Real x5083 = x1062 * x5052 + x1069 * x5053 + x1073 * x5051;
  const Real x5127 = 3913.894324853229 + x5083;
  w.x[443] = x5127;
}

ADAGEN_NOINLINE void part_0_4(Workspace& w) {
  ADAGEN_INPUTS
  const Real x852 = w.x[110];
  const Real x855 = w.x[111];
  const Real x858 = w.x[112];
  const Real x859 = w.x[113];
  const Real x862 = w.x[114];
  const Real x865 = w.x[115];
  const Real x866 = w.x[116];
  const Real x867 = w.x[117];
  const Real x869 = w.x[118];
  const Real x1056 = w.x[139];
  const Real x1059 = w.x[140];
  const Real x1062 = w.x[141];
  const Real x1063 = w.x[142];
  const Real x1066 = w.x[143];
  const Real x1069 = w.x[144];
  const Real x1070 = w.x[145];
  const Real x1071 = w.x[146];
  const Real x1073 = w.x[147];
  const Real x4618 = w.x[378];
  const Real x4627 = w.x[379];
  const Real x4636 = w.x[380];
  const Real x4647 = w.x[381];
  const Real x4657 = w.x[382];
  const Real x4666 = w.x[383];
  const Real x4675 = w.x[384];
  const Real x4686 = w.x[385];
  const Real x4696 = w.x[386];
  const Real x4705 = w.x[387];
  const Real x4716 = w.x[388];
  const Real x4726 = w.x[389];
  const Real x4735 = w.x[390];
  const Real x4744 = w.x[391];
  const Real x4755 = w.x[392];
  const Real x4765 = w.x[393];
  const Real x4776 = w.x[394];
  const Real x4786 = w.x[395];
  const Real x4795 = w.x[396];
  const Real x4804 = w.x[397];
  const Real x4813 = w.x[398];
  const Real x4921 = w.x[133];
  const Real x4925 = w.x[134];
  const Real x4928 = w.x[135];
  const Real x4929 = w.x[136];
  const Real x4932 = w.x[137];
  const Real x4936 = w.x[138];
  const Real x4978 = w.x[148];
  const Real x4981 = w.x[149];
  const Real x4982 = w.x[150];
  const Real x4985 = w.x[151];
  const Real x4989 = w.x[152];
  const Real x4990 = w.x[153];
  const Real x5000 = w.x[405];
  const Real x5002 = w.x[406];
  const Real x5003 = w.x[407];
  const Real x5005 = w.x[408];
  const Real x5006 = w.x[409];
  const Real x5008 = w.x[410];
  const Real x5012 = w.x[411];
  const Real x5020 = w.x[412];
  const Real x5028 = w.x[413];
  const Real x5032 = w.x[414];
  const Real x5036 = w.x[415];
  const Real x5040 = w.x[416];
  const Real x5044 = w.x[417];
  const Real x5045 = w.x[418];
  const Real x5046 = w.x[419];
  const Real x5047 = w.x[420];
  const Real x5048 = w.x[421];
  const Real x5049 = w.x[422];
  const Real x5050 = w.x[423];
  const Real x5051 = w.x[424];
  const Real x5052 = w.x[425];
  const Real x5053 = w.x[426];
  const Real x5063 = w.x[427];
  const Real x5068 = w.x[428];
  const Real x5078 = w.x[429];
  const Real x5084 = w.x[430];
  const Real x5087 = w.x[431];
  const Real x5090 = w.x[432];
  const Real x5097 = w.x[433];
  const Real x5102 = w.x[434];
  const Real x5107 = w.x[435];
  const Real x5112 = w.x[436];
  const Real x5117 = w.x[437];
  const Real x5122 = w.x[438];
  const Real x5123 = w.x[439];
  const Real x5124 = w.x[440];
  const Real x5125 = w.x[441];
  const Real x5126 = w.x[442];
  const Real x5127 = w.x[443];
  const Real x5589 = w.x[127];
  const Real x5592 = w.x[128];
  const Real x5593 = w.x[129];
  const Real x5596 = w.x[130];
  const Real x5600 = w.x[131];
  const Real x5601 = w.x[132];
  // joint 10 "left_wrist": assembly: its two sides become one chain
  const Real x5128 = 8.51709811441355 + x5097;
  require_more(w, x5128, 1.339542027310537e-13, kGrowth, 10);
  require_more(w, x5128, 0.0, kFactorization, 10);
  const Real x5129 = 7.561041413732632 + x5112;
  require_more(w, x5129, 1.203678198581818e-13, kGrowth, 10);
  const Real x5130 = 2.380952380952381 + x5122;
  require_more(w, x5130, 4.67543272015304e-14, kGrowth, 10);
  const Real x5133 = 0.26 * x4928 - x4932;
  const Real x5136 = x4936 + 0.26 * x4925;
  const Real x5146 = x1070 * x4921 + x1056 * x4925 + x1063 * x4928;
  const Real x5156 = x1071 * x4921 + x1059 * x4925 + x1066 * x4928;
  const Real x5166 = x1073 * x4921 + x1062 * x4925 + x1069 * x4928;
  const Real x5175 = x1056 * x5133 - (x1070 * x4929 + x1063 * x5136);
  const Real x5183 = x1059 * x5133 - (x1071 * x4929 + x1066 * x5136);
  const Real x5191 = x1062 * x5133 - (x1073 * x4929 + x1069 * x5136);
  const Real x5202 = tau[28] * x5063 + tau[29] * x5068 + tau[27] * x5123;
  const Real x5228 = x4978 - x5146 - x5202;
  w.x[168] = x5228;
  const Real x5207 = tau[27] * x5063 + tau[29] * x5078 + tau[28] * x5125;
  const Real x5229 = x4981 - x5156 - x5207;
  w.x[167] = x5229;
  const Real x5212 = tau[27] * x5068 + tau[28] * x5078 + tau[29] * x5127;
  const Real x5230 = x4982 - x5166 - x5212;
  w.x[166] = x5230;
  const Real x5217 = tau[27] * x5012 + tau[29] * x5036 + tau[28] * x5126;
  const Real x5231 = x4985 + x5175 - x5217;
  w.x[165] = x5231;
  const Real x5222 = tau[28] * x5028 + tau[29] * x5040 + tau[27] * x5124;
  const Real x5227 = tau[27] * x5020 + tau[29] * x5044 + tau[28] * x5032;
  const Real x5234 = 1 / x5128;
  w.x[164] = x5234;
  const Real x5235 = x5102 * x5234;
  w.x[163] = x5235;
  const Real x5236 = x5107 * x5234;
  w.x[365] = x5236;
  const Real x5239 = x5129 - x5102 * x5235;
  const Real x5242 = x5117 - x5107 * x5235;
  const Real x5243 = 1 / x5239;
  w.x[364] = x5243;
  const Real x5244 = x5242 * x5243;
  w.x[363] = x5244;
  const Real x5250 = x5130 - x5107 * x5236 - x5242 * x5244;
  const Real x5251 = 1 / x5250;
  w.x[362] = x5251;
  const Real x5252 = 1.7763568394002505e-15 * x5129;
  require_more(w, x5239, x5252, kFactorization, 10);
  const Real x5253 = 1.7763568394002505e-15 * x5130;
  require_more(w, x5250, x5253, kFactorization, 10);
  const Real x5256 = x4989 + x5183 - x5222 - x5231 * x5235;
  w.x[361] = x5256;
  const Real x5261 = x4990 + x5191 - x5227 - x5231 * x5236;
  const Real x5262 = x5261 - x5244 * x5256;
  w.x[360] = x5262;
  const Real x5266 = x1063 * 19.78226322279444;
  w.x[359] = x5266;
  const Real x5267 = x1066 * 19.78226322279444;
  w.x[358] = x5267;
  const Real x5268 = x1069 * 19.78226322279444;
  w.x[357] = x5268;
  const Real x5269 = x1056 * 1.860425942100313;
  w.x[356] = x5269;
  const Real x5275 = x1056 * 19.78226322279444;
  w.x[355] = x5275;
  const Real x5277 = x1059 * 19.78226322279444;
  w.x[354] = x5277;
  const Real x5279 = x1062 * 19.78226322279444;
  w.x[353] = x5279;
  const Real x5281 = x1063 * 1.860425942100313;
  w.x[352] = x5281;
  const Real x5289 = x5003 - x5000 * x5235;
  w.x[351] = x5289;
  const Real x5292 = x5002 * x5235 - x5005;
  w.x[350] = x5292;
  const Real x5295 = x5087 - x5084 * x5235;
  w.x[349] = x5295;
  const Real x5298 = x5235 * x5269 - x1059 * 1.860425942100313;
  w.x[348] = x5298;
  const Real x5301 = x5235 * x5281 - x1066 * 1.860425942100313;
  w.x[347] = x5301;
  const Real x5307 = x5006 - x5000 * x5236 - x5244 * x5289;
  w.x[346] = x5307;
  const Real x5313 = x5002 * x5236 - x5008 - x5244 * x5292;
  w.x[345] = x5313;
  const Real x5319 = x5090 - x5084 * x5236 - x5244 * x5295;
  w.x[344] = x5319;
  const Real x5325 = x5236 * x5269 - x1062 * 1.860425942100313 - x5244 * x5298;
  w.x[109] = x5325;
  const Real x5331 = x5236 * x5281 - x1069 * 1.860425942100313 - x5244 * x5301;
  w.x[108] = x5331;
  const Real x5332 = x5000 * x5234;
  const Real x5333 = x5002 * x5234;
  const Real x5335 = x5084 * x5234;
  const Real x5336 = x5234 * x5269;
  const Real x5338 = x5234 * x5281;
  const Real x5340 = x5243 * x5289;
  const Real x5341 = x5243 * x5292;
  const Real x5342 = x5243 * x5295;
  const Real x5343 = x5243 * x5298;
  const Real x5344 = x5243 * x5301;
  const Real x5345 = x5251 * x5307;
  const Real x5346 = x5251 * x5313;
  const Real x5347 = x5251 * x5319;
  const Real x5348 = x5251 * x5325;
  const Real x5349 = x5251 * x5331;
  const Real x5357 = 164.852193523287 - x5000 * x5332 - x5289 * x5340;
  const Real x5366 = x5000 * x5333 - x5289 * x5341 - x5307 * x5346;
  w.x[107] = x5366;
  const Real x5375 = x5000 * x5335 + x5289 * x5342 + x5307 * x5347;
  const Real x5384 = x5000 * x5336 - x5289 * x5343 - x5307 * x5348;
  const Real x5392 = -19.78226322279444 + x5000 * x5338 - x5289 * x5344;
  const Real x5401 = 164.852193523287 - x5002 * x5333 - x5292 * x5341;
  const Real x5418 = 19.78226322279444 - x5002 * x5336 - x5292 * x5343;
  const Real x5428 = x5002 * x5338 + x5292 * x5344 + x5313 * x5349;
  w.x[106] = x5428;
  const Real x5437 = 0.9090909090909091 - x5084 * x5335 - x5295 * x5342;
  const Real x5462 = 3.2829624958262418 - x5269 * x5336 - x5298 * x5343;
  const Real x5481 = 3.2829624958262418 - x5281 * x5338 - x5301 * x5344;
  const Real x5492 = tau[28] * x5049 + tau[29] * x5052 + tau[27] * x5046;
  const Real x5517 = x5231 * x5332 + x5256 * x5340 + x5262 * x5345;
  const Real x5497 = tau[27] * x5047 + tau[29] * x5053 + tau[28] * x5050;
  const Real x5523 = x5256 * x5341 - x5231 * x5333 + x5262 * x5346;
  const Real x5502 = tau[27] * x5266 + tau[29] * x5268 + tau[28] * x5267;
  const Real x5534 = x5256 * x5343 - x5231 * x5336 + x5262 * x5348;
  const Real x5540 = x5256 * x5344 - x5231 * x5338 + x5262 * x5349;
  const Real x5511 = tau[28] * x5277 + tau[29] * x5279 + tau[27] * x5275;
  const Real x5487 = tau[27] * x5045 + tau[28] * x5048 + tau[29] * x5051;
  const Real x5528 = x5231 * x5335 + x5256 * x5342 + x5262 * x5347;
  // joint 9 "left_elbow": assembly: its two sides become one chain
  const Real x5609 = sine[2] * 11.214785573299837;
  w.x[105] = x5609;
  const Real x5610 = cosine[2] * 11.214785573299837;
  const Real x5614 = cosine[2] * 445.0528265223806;
  const Real x5615 = sine[2] * x5614;
  const Real x5617 = cosine[2] * x5614;
  const Real x5620 = cosine[2] * 1.6822178359949753;
  const Real x5624 = cosine[2] * x5620;
  const Real x5628 = 74.76523715533226 + x5617 + 1484.2300556586272;
  require_more(w, x5628, 2.1587775800806794e-11, kGrowth, 9);
  require_more(w, x5628, 0.0, kFactorization, 9);
  const Real x5629 = x5357 - x5307 * x5345 + (519.8180636777129 - x5617);
  require_more(w, x5629, 2.8382886875476563e-12, kGrowth, 9);
  // joint 10 "left_wrist": assembly: its two sides become one chain
  const Real x5410 = x5002 * x5335 - x5292 * x5342 - x5313 * x5347;
  // joint 9 "left_elbow": assembly: its two sides become one chain
  const Real x5632 = x5410 - x5609;
  w.x[104] = x5632;
  const Real x5633 = x5418 - x5313 * x5348 - x5610;
  w.x[444] = x5633;
  const Real x5634 = x5437 - x5319 * x5347 + (2.2085336254686596 - x5624);
  require_more(w, x5634, 2.039835605052919e-14, kGrowth, 9);
  // joint 10 "left_wrist": assembly: its two sides become one chain
  const Real x5446 = x5084 * x5336 - x5295 * x5343 - x5319 * x5348;
  // joint 9 "left_elbow": assembly: its two sides become one chain
  const Real x5636 = x5462 - x5325 * x5348 + (0.5263157894736842 + x5624);
  require_more(w, x5636, 5.4133100282171055e-14, kGrowth, 9);
  const Real x5637 = x5481 - x5331 * x5349 + 2.2085336254686596;
  require_more(w, x5637, 5.4133100282171055e-14, kGrowth, 9);
  const Real x5640 = 0.29 * x5592 - x5596;
  const Real x5664 = x4921 + x5487 - (cosine[2] * x5593 + sine[2] * x5589);
  w.x[445] = x5664;
  const Real x5655 = sine[2] * x5593 - cosine[2] * x5589;
  const Real x5663 = sine[2] * x5601 + cosine[2] * x5640;
  const Real x5671 = tau[26] * (x5401 - x5313 * x5346 + 74.76523715533226);
  const Real x5677 = x5497 + x5523 + x4928 - x5592 - x5671;
  w.x[446] = x5677;
  const Real x5667 = x4929 + x5528 + (sine[2] * x5640 - cosine[2] * x5601);
  const Real x5669 = x5540 - x5511 + x4936 - (x5600 + 0.29 * x5589);
  const Real x5681 = 1 / x5628;
  w.x[447] = x5681;
  const Real x5682 = x5615 * x5681;
  w.x[448] = x5682;
  const Real x5684 = x5609 * x5681;
  w.x[449] = x5684;
  const Real x5687 = x5629 - x5615 * x5682;
  const Real x5690 = x5392 - x5307 * x5349 + x5610 + x5609 * x5682;
  const Real x5691 = 1 / x5687;
  w.x[450] = x5691;
  const Real x5692 = x5375 * x5691;
  w.x[451] = x5692;
  const Real x5694 = x5384 * x5691;
  w.x[452] = x5694;
  const Real x5695 = x5690 * x5691;
  w.x[453] = x5695;
  const Real x5698 = x5634 - x5375 * x5692;
  const Real x5701 = x5446 + sine[2] * x5620 + x5384 * x5692;
  // joint 10 "left_wrist": assembly: its two sides become one chain
  const Real x5454 = x5084 * x5338 - x5295 * x5344 - x5319 * x5349;
  // joint 9 "left_elbow": assembly: its two sides become one chain
  const Real x5704 = x5454 + x5690 * x5692;
  const Real x5705 = 1 / x5698;
  w.x[454] = x5705;
  const Real x5706 = x5701 * x5705;
  w.x[455] = x5706;
  const Real x5707 = x5704 * x5705;
  w.x[456] = x5707;
  const Real x5713 = x5636 - x5384 * x5694 - x5701 * x5706;
  // joint 10 "left_wrist": assembly: its two sides become one chain
  const Real x5472 = x5269 * x5338 + x5298 * x5344 + x5325 * x5349;
  // joint 9 "left_elbow": assembly: its two sides become one chain
  const Real x5720 = x5472 + x5690 * x5694 + x5704 * x5706;
  const Real x5722 = 1 / x5713;
  w.x[457] = x5722;
  const Real x5723 = x5720 * x5722;
  w.x[458] = x5723;
  const Real x5734 = x5637 - x5609 * x5684 - x5690 * x5695;
  const Real x5736 = x5734 - x5704 * x5707 - x5720 * x5723;
  const Real x5737 = 1 / x5736;
  w.x[459] = x5737;
  const Real x5738 = 1.7763568394002505e-15 * x5629;
  require_more(w, x5687, x5738, kFactorization, 9);
  const Real x5739 = 1.7763568394002505e-15 * x5634;
  require_more(w, x5698, x5739, kFactorization, 9);
  const Real x5740 = 1.7763568394002505e-15 * x5636;
  require_more(w, x5713, x5740, kFactorization, 9);
  const Real x5741 = 1.7763568394002505e-15 * x5637;
  require_more(w, x5736, x5741, kFactorization, 9);
  const Real x5676 = x5492 + x5517 + x4925 + x5655 - x5366 * tau[26];
  const Real x5744 = x5676 + x5664 * x5682;
  w.x[460] = x5744;
  const Real x5747 = x5667 - tau[26] * x5632 + x5692 * x5744;
  w.x[461] = x5747;
  const Real x5679 = x5502 + x5534 + x4932 + x5663 - tau[26] * x5633;
  const Real x5753 = x5679 - x5694 * x5744 - x5706 * x5747;
  w.x[462] = x5753;
  const Real x5762 = x5669 + x5428 * tau[26] - x5664 * x5684;
  const Real x5764 = x5762 - x5695 * x5744 - x5707 * x5747;
  const Real x5765 = x5723 * x5753 + x5764;
  w.x[463] = x5765;
  const Real x5766 = sine[2] * 74.76523715533226;
  w.x[464] = x5766;
  const Real x5768 = cosine[2] * 519.8180636777129;
  w.x[465] = x5768;
  const Real x5771 = sine[2] * 1.0437541907882928;
  w.x[466] = x5771;
  const Real x5775 = sine[2] * 10.467133201746517;
  w.x[467] = x5775;
  const Real x5779 = cosine[2] * 0.5263157894736842;
  w.x[468] = x5779;
  const Real x5784 = cosine[2] * 74.76523715533226 + x5682 * x5766;
  w.x[469] = x5784;
  const Real x5787 = x5682 * x5768 - sine[2] * 519.8180636777129;
  w.x[470] = x5787;
  const Real x5790 = cosine[2] * 10.467133201746517 + x5682 * x5775;
  w.x[471] = x5790;
  const Real x5792 = x5692 * x5784;
  w.x[472] = x5792;
  const Real x5794 = x5692 * x5787;
  w.x[473] = x5794;
  const Real x5796 = x5692 * x5790;
  w.x[474] = x5796;
  const Real x5802 = x5694 * x5784 + x5706 * x5792;
  w.x[475] = x5802;
  const Real x5806 = x5609 * x5706 - x5610;
  w.x[476] = x5806;
  const Real x5811 = x5694 * x5787 + x5706 * x5794;
  w.x[477] = x5811;
  const Real x5815 = x5706 * x5771 - cosine[2] * 1.0437541907882928;
  w.x[478] = x5815;
  const Real x5820 = x5694 * x5790 + x5706 * x5796;
  w.x[479] = x5820;
  const Real x5823 = sine[2] * 0.5263157894736842 + x5706 * x5779;
  w.x[480] = x5823;
  const Real x5834 = 11.214785573299837 - x5684 * x5766 - x5695 * x5784;
  const Real x5836 = x5834 - x5707 * x5792 - x5723 * x5802;
  w.x[481] = x5836;
  const Real x5841 = x5609 * x5707 + x5723 * x5806;
  w.x[482] = x5841;
  const Real x5852 = x5684 * x5768 + x5695 * x5787 + x5707 * x5794;
  const Real x5854 = x5723 * x5811 + x5852;
  w.x[483] = x5854;
  const Real x5860 = x5707 * x5771 + x5723 * x5815;
  w.x[484] = x5860;
  const Real x5870 = -1.0437541907882928 + x5684 * x5775 + x5695 * x5790;
  const Real x5872 = x5707 * x5796 + x5870 + x5723 * x5820;
  w.x[485] = x5872;
  const Real x5877 = x5707 * x5779 + x5723 * x5823;
  w.x[486] = x5877;
  const Real x5879 = x5681 * x5766;
  const Real x5880 = x5681 * x5768;
  const Real x5881 = x5681 * x5775;
  const Real x5883 = x5691 * x5784;
  const Real x5884 = x5691 * x5787;
  const Real x5885 = x5691 * x5790;
  const Real x5887 = x5705 * x5792;
  const Real x5888 = x5609 * x5705;
  const Real x5890 = x5705 * x5794;
  const Real x5891 = x5705 * x5771;
  const Real x5893 = x5705 * x5796;
  const Real x5895 = x5705 * x5779;
  const Real x5896 = x5722 * x5802;
  const Real x5898 = x5722 * x5806;
  const Real x5899 = x5722 * x5811;
  const Real x5901 = x5722 * x5815;
  const Real x5902 = x5722 * x5820;
  const Real x5903 = x5722 * x5823;
  const Real x5905 = x5737 * x5836;
  const Real x5906 = x5737 * x5841;
  const Real x5907 = x5737 * x5854;
  const Real x5909 = x5737 * x5860;
  const Real x5910 = x5737 * x5872;
  const Real x5911 = x5737 * x5877;
  const Real x5924 = 74.76523715533226 - x5766 * x5879 - x5784 * x5883;
  const Real x5926 = x5924 - x5792 * x5887 - x5802 * x5896;
  const Real x5948 = x5766 * x5880 + x5784 * x5884 + x5792 * x5890;
  const Real x5972 = -10.467133201746517 + x5766 * x5881 + x5784 * x5885;
  const Real x5974 = x5792 * x5893 + x5972 + x5802 * x5902;
  const Real x5992 = 74.76523715533226 - x5609 * x5888 - x5806 * x5898;
  const Real x6009 = 10.467133201746517 - x5609 * x5891 - x5806 * x5901;
  const Real x6040 = 519.8180636777129 - x5768 * x5880 - x5787 * x5884;
  const Real x6042 = x6040 - x5794 * x5890 - x5811 * x5899;
  const Real x6063 = x5768 * x5881 + x5787 * x5885 + x5794 * x5893;
  const Real x6074 = x5794 * x5895 + x5811 * x5903 + x5854 * x5911;
  w.x[487] = x6074;
  const Real x6083 = 1.9917144377181968 - x5771 * x5891 - x5815 * x5901;
  const Real x6084 = x6083 - x5860 * x5909;
  w.x[488] = x6084;
  const Real x6093 = x5771 * x5893 + x5815 * x5902 + x5860 * x5910;
  w.x[489] = x6093;
  const Real x6102 = x5771 * x5895 + x5815 * x5903 + x5860 * x5911;
  w.x[490] = x6102;
  const Real x6114 = 1.9917144377181968 - x5775 * x5881 - x5790 * x5885;
  const Real x6116 = x6114 - x5796 * x5893 - x5820 * x5902;
  const Real x6117 = x6116 - x5872 * x5910;
  w.x[491] = x6117;
  const Real x6125 = x5796 * x5895 + x5820 * x5903 + x5872 * x5911;
  w.x[492] = x6125;
  const Real x6133 = 0.5263157894736842 - x5779 * x5895 - x5823 * x5903;
  const Real x6134 = x6133 - x5877 * x5911;
  w.x[493] = x6134;
  const Real x6144 = x5664 * x5879 + x5744 * x5883 + x5747 * x5887;
  const Real x6161 = x5664 * x5880 + x5744 * x5884 + x5747 * x5890;
  const Real x6180 = x5664 * x5881 + x5744 * x5885 + x5747 * x5893;
  const Real x6152 = x5753 * x5898 - x5747 * x5888 + x5765 * x5906;
  const Real x6169 = x5753 * x5901 - x5747 * x5891 + x5765 * x5909;
  const Real x6193 = x6144 - x5753 * x5896 + x5765 * x5905 + x5589;
  w.x[494] = x6193;
  const Real x6195 = 74.76523715533226 * tau[26] + x6152 + x5592;
  w.x[495] = x6195;
  const Real x6197 = x6161 - x5753 * x5899 - x5765 * x5907 + x5593;
  w.x[496] = x6197;
  const Real x6199 = 10.467133201746517 * tau[26] + x6169 + x5596;
  w.x[497] = x6199;
  const Real x6201 = x5753 * x5902 - x6180 + x5765 * x5910 + x5600;
  w.x[498] = x6201;
  const Real x6190 = x5747 * x5895 - x5753 * x5903 - x5765 * x5911;
  const Real x6203 = x5601 + x6190;
  w.x[499] = x6203;
  // joint 8 "left_shoulder": assembly: its two sides become one chain
  const Real x6208 = 0.2 * x4636;
  const Real x6210 = 0.42 * x4627;
  const Real x6214 = x6210 - (x4647 + x6208);
  const Real x6217 = x4657 - 0.42 * x4618;
  w.x[500] = x6217;
  const Real x6220 = x4666 + 0.2 * x4618;
  w.x[501] = x6220;
  const Real x6226 = x4696 + 0.2 * x4686 + 0.42 * x4675;
  w.x[502] = x6226;
  const Real x6227 = x4705 - x6210;
  const Real x6230 = 0.2 * x4627 - x4716;
  w.x[503] = x6230;
  const Real x6236 = x4735 - 0.2 * x4726 - 0.42 * x4686;
  w.x[504] = x6236;
  const Real x6239 = x4744 - 0.42 * x4636;
  w.x[505] = x6239;
  const Real x6240 = x6208 - x4755;
  const Real x6250 = x4765 - 0.2 * x4735 + 0.42 * x4696;
  w.x[506] = x6250;
  const Real x6252 = x6250 - 0.2 * x6236 + 0.42 * x6226;
  const Real x6261 = 0.42 * x4705 - (x4776 + 0.2 * x4744);
  w.x[507] = x6261;
  const Real x6262 = x6261 - 0.42 * x6214;
  const Real x6270 = x4786 + 0.2 * x4755 - 0.42 * x4716;
  w.x[508] = x6270;
  const Real x6271 = 0.2 * x6214 + x6270;
  const Real x6276 = x4795 - 0.42 * x4657;
  w.x[509] = x6276;
  const Real x6277 = x6276 - 0.42 * x6217;
  const Real x6282 = x4804 - 0.42 * x4666;
  w.x[510] = x6282;
  const Real x6283 = 0.2 * x6217 + x6282;
  const Real x6288 = x4813 + 0.2 * x4666;
  w.x[511] = x6288;
  const Real x6289 = 0.2 * x6220 + x6288;
  const Real x6290 = x852 * x6214;
  w.x[512] = x6290;
  const Real x6294 = x6290 + x859 * x6226 + x866 * x6236;
  const Real x6296 = x859 * x6227;
  w.x[513] = x6296;
  const Real x6299 = x852 * x6217 + x6296 + x866 * x6239;
  const Real x6302 = x866 * x6240;
  w.x[514] = x6302;
  const Real x6304 = x852 * x6220 + x859 * x6230 + x6302;
  const Real x6305 = x855 * x6214;
  w.x[515] = x6305;
  const Real x6309 = x6305 + x862 * x6226 + x867 * x6236;
  const Real x6311 = x862 * x6227;
  w.x[516] = x6311;
  const Real x6314 = x855 * x6217 + x6311 + x867 * x6239;
  const Real x6317 = x867 * x6240;
  w.x[517] = x6317;
  const Real x6319 = x855 * x6220 + x862 * x6230 + x6317;
  const Real x6320 = x858 * x6214;
  w.x[518] = x6320;
  const Real x6324 = x6320 + x865 * x6226 + x869 * x6236;
  const Real x6326 = x865 * x6227;
  w.x[519] = x6326;
  const Real x6329 = x858 * x6217 + x6326 + x869 * x6239;
  const Real x6332 = x869 * x6240;
  w.x[520] = x6332;
  const Real x6334 = x858 * x6220 + x865 * x6230 + x6332;
  const Real x6379 = x865 * x6329 + x869 * x6334 + x858 * x6324;
  w.x[521] = x6379;
  const Real x6384 = x852 * x4618 + x859 * x4627 + x866 * x4636;
  w.x[522] = x6384;
  const Real x6390 = x852 * x4627 + x859 * x4675 - x866 * x4686;
  w.x[523] = x6390;
  const Real x6396 = x852 * x4636 - x859 * x4686 + x866 * x4726;
  w.x[524] = x6396;
  const Real x6401 = x855 * x4618 + x862 * x4627 + x867 * x4636;
  w.x[525] = x6401;
  const Real x6407 = x855 * x4627 + x862 * x4675 - x867 * x4686;
  w.x[526] = x6407;
  const Real x6413 = x855 * x4636 - x862 * x4686 + x867 * x4726;
  w.x[527] = x6413;
  const Real x6418 = x858 * x4618 + x865 * x4627 + x869 * x4636;
  w.x[528] = x6418;
  const Real x6424 = x858 * x4627 + x865 * x4675 - x869 * x4686;
  w.x[529] = x6424;
  const Real x6430 = x858 * x4636 - x865 * x4686 + x869 * x4726;
  w.x[530] = x6430;
  const Real x6465 = x859 * x6262 + x866 * x6271 + x852 * x6252;
  const Real x6470 = x859 * x6277 + x866 * x6283 + x852 * x6262;
  const Real x6475 = x859 * x6283 + x866 * x6289 + x852 * x6271;
  const Real x6480 = x862 * x6262 + x867 * x6271 + x855 * x6252;
  const Real x6485 = x862 * x6277 + x867 * x6283 + x855 * x6262;
  const Real x6490 = x862 * x6283 + x867 * x6289 + x855 * x6271;
  const Real x6510 = x859 * x6470 + x866 * x6475 + x852 * x6465;
  w.x[531] = x6510;
  const Real x6515 = x862 * x6470 + x867 * x6475 + x855 * x6465;
  w.x[532] = x6515;
  const Real x6520 = x865 * x6470 + x869 * x6475 + x858 * x6465;
  w.x[533] = x6520;
  const Real x6525 = x862 * x6485 + x867 * x6490 + x855 * x6480;
  w.x[534] = x6525;
  const Real x6530 = x865 * x6485 + x869 * x6490 + x858 * x6480;
  w.x[535] = x6530;
  const Real x6495 = x865 * x6262 + x869 * x6271 + x858 * x6252;
  const Real x6500 = x865 * x6277 + x869 * x6283 + x858 * x6262;
  const Real x6505 = x865 * x6283 + x869 * x6289 + x858 * x6271;
  const Real x6535 = x865 * x6500 + x869 * x6505 + x858 * x6495;
  w.x[536] = x6535;
  const Real x6435 = x852 * x6384 + x859 * x6390 + x866 * x6396;
  const Real x6536 = x5926 - x5836 * x5905 + x6435;
  w.x[537] = x6536;
  // joint 9 "left_elbow": assembly: its two sides become one chain
  const Real x5935 = x5792 * x5888 + x5802 * x5898 - x5836 * x5906;
  // joint 8 "left_shoulder": assembly: its two sides become one chain
  const Real x6440 = x855 * x6384 + x862 * x6390 + x867 * x6396;
  const Real x6537 = x5935 + x6440;
  w.x[538] = x6537;
  const Real x6445 = x858 * x6384 + x865 * x6390 + x869 * x6396;
  const Real x6538 = x5836 * x5907 - (x5802 * x5899 + x5948) + x6445;
  w.x[539] = x6538;
  // joint 9 "left_elbow": assembly: its two sides become one chain
  const Real x5960 = x5792 * x5891 + x5802 * x5901 - x5836 * x5909;
  // joint 8 "left_shoulder": assembly: its two sides become one chain
  const Real x6339 = x859 * x6299 + x866 * x6304 + x852 * x6294;
  const Real x6539 = x5960 + x6339;
  w.x[540] = x6539;
  const Real x6344 = x862 * x6299 + x867 * x6304 + x855 * x6294;
  const Real x6540 = x5974 - x5836 * x5910 + x6344;
  w.x[541] = x6540;
  // joint 9 "left_elbow": assembly: its two sides become one chain
  const Real x5984 = x5836 * x5911 - (x5792 * x5895 + x5802 * x5903);
  // joint 8 "left_shoulder": assembly: its two sides become one chain
  const Real x6349 = x865 * x6299 + x869 * x6304 + x858 * x6294;
  const Real x6541 = x5984 + x6349;
  w.x[542] = x6541;
  const Real x6450 = x855 * x6401 + x862 * x6407 + x867 * x6413;
  const Real x6542 = x5992 - x5841 * x5906 + x6450;
  w.x[543] = x6542;
  // joint 9 "left_elbow": assembly: its two sides become one chain
  const Real x6001 = x5609 * x5890 + x5806 * x5899 + x5841 * x5907;
  // joint 8 "left_shoulder": assembly: its two sides become one chain
  const Real x6455 = x858 * x6401 + x865 * x6407 + x869 * x6413;
  const Real x6543 = x6001 + x6455;
  w.x[544] = x6543;
  const Real x6354 = x859 * x6314 + x866 * x6319 + x852 * x6309;
  const Real x6544 = x6009 - x5841 * x5909 + x6354;
  w.x[545] = x6544;
  const Real x6359 = x862 * x6314 + x867 * x6319 + x855 * x6309;
  // joint 9 "left_elbow": assembly: its two sides become one chain
  const Real x6019 = x5609 * x5893 + x5806 * x5902 + x5841 * x5910;
  // joint 8 "left_shoulder": assembly: its two sides become one chain
  const Real x6545 = x6359 - x6019;
  w.x[546] = x6545;
  // joint 9 "left_elbow": assembly: its two sides become one chain
  const Real x6028 = x5609 * x5895 + x5806 * x5903 + x5841 * x5911;
  // joint 8 "left_shoulder": assembly: its two sides become one chain
  const Real x6364 = x865 * x6314 + x869 * x6319 + x858 * x6309;
  const Real x6546 = x6028 + x6364;
  w.x[547] = x6546;
  const Real x6460 = x858 * x6418 + x865 * x6424 + x869 * x6430;
  const Real x6547 = x6042 - x5854 * x5907 + x6460;
  w.x[548] = x6547;
  // joint 9 "left_elbow": assembly: its two sides become one chain
  const Real x6051 = x5794 * x5891 + x5811 * x5901 + x5854 * x5909;
  // joint 8 "left_shoulder": assembly: its two sides become one chain
  const Real x6369 = x859 * x6329 + x866 * x6334 + x852 * x6324;
  const Real x6548 = x6051 + x6369;
  w.x[549] = x6548;
  const Real x6374 = x862 * x6329 + x867 * x6334 + x855 * x6324;
  const Real x6549 = x5811 * x5902 + x6063 + x5854 * x5910 + x6374;
  w.x[550] = x6549;
}

ADAGEN_NOINLINE void part_0_5(Workspace& w) {
  ADAGEN_INPUTS
  const Real x605 = w.x[66];
  const Real x608 = w.x[67];
  const Real x611 = w.x[68];
  const Real x612 = w.x[69];
  const Real x615 = w.x[70];
  const Real x618 = w.x[71];
  const Real x619 = w.x[72];
  const Real x620 = w.x[73];
  const Real x622 = w.x[74];
  const Real x738 = w.x[81];
  const Real x741 = w.x[82];
  const Real x744 = w.x[83];
  const Real x745 = w.x[84];
  const Real x748 = w.x[85];
  const Real x751 = w.x[86];
  const Real x752 = w.x[87];
  const Real x753 = w.x[88];
  const Real x755 = w.x[89];
  const Real x852 = w.x[110];
  const Real x855 = w.x[111];
  const Real x858 = w.x[112];
  const Real x859 = w.x[113];
  const Real x862 = w.x[114];
  const Real x865 = w.x[115];
  const Real x866 = w.x[116];
  const Real x867 = w.x[117];
  const Real x869 = w.x[118];
  const Real x4618 = w.x[378];
  const Real x4627 = w.x[379];
  const Real x4636 = w.x[380];
  const Real x4647 = w.x[381];
  const Real x4657 = w.x[382];
  const Real x4666 = w.x[383];
  const Real x4675 = w.x[384];
  const Real x4686 = w.x[385];
  const Real x4696 = w.x[386];
  const Real x4705 = w.x[387];
  const Real x4716 = w.x[388];
  const Real x4726 = w.x[389];
  const Real x4735 = w.x[390];
  const Real x4744 = w.x[391];
  const Real x4755 = w.x[392];
  const Real x4765 = w.x[393];
  const Real x4776 = w.x[394];
  const Real x4786 = w.x[395];
  const Real x4795 = w.x[396];
  const Real x4804 = w.x[397];
  const Real x4813 = w.x[398];
  const Real x4880 = w.x[399];
  const Real x4882 = w.x[400];
  const Real x4884 = w.x[401];
  const Real x4886 = w.x[402];
  const Real x4888 = w.x[403];
  const Real x4890 = w.x[404];
  const Real x6074 = w.x[487];
  const Real x6084 = w.x[488];
  const Real x6093 = w.x[489];
  const Real x6102 = w.x[490];
  const Real x6117 = w.x[491];
  const Real x6125 = w.x[492];
  const Real x6134 = w.x[493];
  const Real x6193 = w.x[494];
  const Real x6195 = w.x[495];
  const Real x6197 = w.x[496];
  const Real x6199 = w.x[497];
  const Real x6201 = w.x[498];
  const Real x6203 = w.x[499];
  const Real x6217 = w.x[500];
  const Real x6220 = w.x[501];
  const Real x6226 = w.x[502];
  const Real x6230 = w.x[503];
  const Real x6236 = w.x[504];
  const Real x6239 = w.x[505];
  const Real x6250 = w.x[506];
  const Real x6261 = w.x[507];
  const Real x6270 = w.x[508];
  const Real x6276 = w.x[509];
  const Real x6282 = w.x[510];
  const Real x6288 = w.x[511];
  const Real x6290 = w.x[512];
  const Real x6296 = w.x[513];
  const Real x6302 = w.x[514];
  const Real x6305 = w.x[515];
  const Real x6311 = w.x[516];
  const Real x6317 = w.x[517];
  const Real x6320 = w.x[518];
  const Real x6326 = w.x[519];
  const Real x6332 = w.x[520];
  const Real x6379 = w.x[521];
  const Real x6384 = w.x[522];
  const Real x6390 = w.x[523];
  const Real x6396 = w.x[524];
  const Real x6401 = w.x[525];
  const Real x6407 = w.x[526];
  const Real x6413 = w.x[527];
  const Real x6418 = w.x[528];
  const Real x6424 = w.x[529];
  const Real x6430 = w.x[530];
  const Real x6510 = w.x[531];
  const Real x6515 = w.x[532];
  const Real x6520 = w.x[533];
  const Real x6525 = w.x[534];
  const Real x6530 = w.x[535];
  const Real x6535 = w.x[536];
  const Real x6536 = w.x[537];
  const Real x6537 = w.x[538];
  const Real x6538 = w.x[539];
  const Real x6539 = w.x[540];
  const Real x6540 = w.x[541];
  const Real x6541 = w.x[542];
  const Real x6542 = w.x[543];
  const Real x6543 = w.x[544];
  const Real x6544 = w.x[545];
  const Real x6545 = w.x[546];
  const Real x6546 = w.x[547];
  const Real x6547 = w.x[548];
  const Real x6548 = w.x[549];
  const Real x6549 = w.x[550];
  const Real x7222 = w.x[3];
  const Real x7227 = w.x[4];
  const Real x7228 = w.x[5];
  const Real x7233 = w.x[6];
  const Real x7236 = w.x[7];
  const Real x7237 = w.x[8];
  // joint 8 "left_shoulder": assembly: its two sides become one chain
  const Real x6550 = x6379 - x6074;
  w.x[132] = x6550;
  const Real x6551 = x6084 + x6510;
  require_more(w, x6551, 2.892182775707059e-14, kGrowth, 8);
  require_more(w, x6551, 0.0, kFactorization, 8);
  const Real x6552 = x6515 - x6093;
  const Real x6553 = x6102 + x6520;
  const Real x6554 = x6117 + x6525;
  require_more(w, x6554, 2.892182775707059e-14, kGrowth, 8);
  const Real x6556 = x6134 + x6535;
  require_more(w, x6556, 8.097260467014413e-15, kGrowth, 8);
  const Real x6562 = 0.2 * x4884 - x4886 - 0.42 * x4882;
  const Real x6565 = 0.42 * x4880 - x4888;
  const Real x6568 = x4890 + 0.2 * x4880;
  const Real x6578 = x852 * x4880 + x859 * x4882 + x866 * x4884;
  const Real x6588 = x855 * x4880 + x862 * x4882 + x867 * x4884;
  const Real x6598 = x858 * x4880 + x865 * x4882 + x869 * x4884;
  const Real x6605 = x859 * x6565 - x866 * x6568 + x852 * x6562;
  const Real x6611 = x862 * x6565 - x867 * x6568 + x855 * x6562;
  const Real x6617 = x865 * x6565 - x869 * x6568 + x858 * x6562;
  const Real x6628 = tau[23] * x6536 + tau[24] * x6537 + tau[25] * x6538;
  const Real x6654 = x6193 - x6578 - x6628;
  w.x[131] = x6654;
  const Real x6633 = tau[23] * x6537 + tau[24] * x6542 + tau[25] * x6543;
  const Real x6655 = x6195 - x6588 - x6633;
  w.x[130] = x6655;
  const Real x6638 = tau[23] * x6538 + tau[24] * x6543 + tau[25] * x6547;
  const Real x6656 = x6197 - x6598 - x6638;
  w.x[129] = x6656;
  const Real x6643 = tau[23] * x6539 + tau[24] * x6544 + tau[25] * x6548;
  const Real x6657 = x6199 + x6605 - x6643;
  w.x[128] = x6657;
  const Real x6648 = tau[23] * x6540 + tau[24] * x6545 + tau[25] * x6549;
  const Real x6653 = tau[23] * x6541 + tau[24] * x6546 + tau[25] * x6550;
  const Real x6660 = 1 / x6551;
  w.x[127] = x6660;
  const Real x6661 = x6552 * x6660;
  w.x[443] = x6661;
  const Real x6662 = x6553 * x6660;
  w.x[441] = x6662;
  const Real x6665 = x6554 - x6552 * x6661;
  const Real x6668 = x6125 + x6530 - x6553 * x6661;
  const Real x6669 = 1 / x6665;
  w.x[439] = x6669;
  const Real x6670 = x6668 * x6669;
  w.x[438] = x6670;
  const Real x6676 = x6556 - x6553 * x6662 - x6668 * x6670;
  const Real x6677 = 1 / x6676;
  w.x[437] = x6677;
  const Real x6678 = 1.7763568394002505e-15 * x6554;
  require_more(w, x6665, x6678, kFactorization, 8);
  const Real x6679 = 1.7763568394002505e-15 * x6556;
  require_more(w, x6676, x6679, kFactorization, 8);
  const Real x6682 = x6201 + x6611 - x6648 - x6657 * x6661;
  w.x[436] = x6682;
  const Real x6687 = x6203 + x6617 - x6653 - x6657 * x6662;
  const Real x6688 = x6687 - x6670 * x6682;
  w.x[435] = x6688;
  const Real x6692 = x859 * x6217 + x866 * x6220 + x6290;
  w.x[434] = x6692;
  const Real x6704 = x6296 + x866 * x6230 + x852 * x6226;
  w.x[433] = x6704;
  const Real x6716 = x6302 + x859 * x6239 + x852 * x6236;
  w.x[432] = x6716;
  const Real x6727 = 0.42 * x4647 - x4776;
  const Real x6730 = x4786 - 0.2 * x4647;
  const Real x6736 = x859 * x4696 - x852 * x4647 + x866 * x4735;
  w.x[431] = x6736;
  const Real x6742 = x862 * x4696 - x855 * x4647 + x867 * x4735;
  w.x[429] = x6742;
  const Real x6748 = x865 * x4696 - x858 * x4647 + x869 * x4735;
  w.x[428] = x6748;
  const Real x6753 = x859 * x6727 + x866 * x6730 + x852 * x6250;
  w.x[427] = x6753;
  const Real x6766 = x4804 + 0.2 * x4657;
  const Real x6771 = x852 * x4657 + x859 * x4705 + x866 * x4744;
  w.x[410] = x6771;
  const Real x6776 = x855 * x4657 + x862 * x4705 + x867 * x4744;
  w.x[409] = x6776;
  const Real x6781 = x858 * x4657 + x865 * x4705 + x869 * x4744;
  w.x[408] = x6781;
  const Real x6786 = x859 * x6276 + x866 * x6766 + x852 * x6261;
  w.x[407] = x6786;
  const Real x6803 = x852 * x4666 - x859 * x4716 - x866 * x4755;
  w.x[153] = x6803;
  const Real x6810 = x855 * x4666 - x862 * x4716 - x867 * x4755;
  w.x[152] = x6810;
  const Real x6817 = x858 * x4666 - x865 * x4716 - x869 * x4755;
  w.x[151] = x6817;
  const Real x6822 = x859 * x6282 + x866 * x6288 + x852 * x6270;
  w.x[150] = x6822;
  const Real x6696 = x862 * x6217 + x867 * x6220 + x6305;
  const Real x6835 = x6696 - x6661 * x6692;
  w.x[149] = x6835;
  const Real x6708 = x6311 + x867 * x6230 + x855 * x6226;
  const Real x6838 = x6708 - x6661 * x6704;
  w.x[148] = x6838;
  const Real x6720 = x6317 + x862 * x6239 + x855 * x6236;
  const Real x6841 = x6720 - x6661 * x6716;
  w.x[138] = x6841;
  const Real x6758 = x862 * x6727 + x867 * x6730 + x855 * x6250;
  const Real x6844 = x6758 - x6661 * x6753;
  w.x[137] = x6844;
  const Real x6791 = x862 * x6276 + x867 * x6766 + x855 * x6261;
  const Real x6847 = x6791 - x6661 * x6786;
  w.x[136] = x6847;
  const Real x6827 = x862 * x6282 + x867 * x6288 + x855 * x6270;
  const Real x6850 = x6827 - x6661 * x6822;
  w.x[135] = x6850;
  const Real x6700 = x865 * x6217 + x869 * x6220 + x6320;
  const Real x6856 = x6700 - x6662 * x6692 - x6670 * x6835;
  w.x[134] = x6856;
  const Real x6712 = x6326 + x869 * x6230 + x858 * x6226;
  const Real x6862 = x6712 - x6662 * x6704 - x6670 * x6838;
  w.x[133] = x6862;
  const Real x6724 = x6332 + x865 * x6239 + x858 * x6236;
  const Real x6868 = x6724 - x6662 * x6716 - x6670 * x6841;
  w.x[147] = x6868;
  const Real x6763 = x865 * x6727 + x869 * x6730 + x858 * x6250;
  const Real x6874 = x6763 - x6662 * x6753 - x6670 * x6844;
  w.x[146] = x6874;
  const Real x6796 = x865 * x6276 + x869 * x6766 + x858 * x6261;
  const Real x6880 = x6796 - x6662 * x6786 - x6670 * x6847;
  w.x[145] = x6880;
  const Real x6832 = x865 * x6282 + x869 * x6288 + x858 * x6270;
  const Real x6886 = x6832 - x6662 * x6822 - x6670 * x6850;
  w.x[144] = x6886;
  const Real x6887 = x6660 * x6692;
  const Real x6888 = x6660 * x6704;
  const Real x6889 = x6660 * x6716;
  const Real x6890 = x6660 * x6753;
  const Real x6891 = x6660 * x6786;
  const Real x6892 = x6660 * x6822;
  const Real x6893 = x6669 * x6835;
  const Real x6894 = x6669 * x6838;
  const Real x6895 = x6669 * x6841;
  const Real x6896 = x6669 * x6844;
  const Real x6897 = x6669 * x6847;
  const Real x6898 = x6669 * x6850;
  const Real x6899 = x6677 * x6856;
  const Real x6900 = x6677 * x6862;
  const Real x6901 = x6677 * x6868;
  const Real x6902 = x6677 * x6874;
  const Real x6903 = x6677 * x6880;
  const Real x6904 = x6677 * x6886;
  const Real x6912 = x4618 - x6692 * x6887 - x6835 * x6893;
  const Real x6921 = x4627 - x6692 * x6888 - x6835 * x6894;
  const Real x6930 = x4636 - x6692 * x6889 - x6835 * x6895;
  const Real x6940 = x4647 + x6692 * x6890 + x6835 * x6896;
  const Real x6951 = x4657 - x6692 * x6891 - x6835 * x6897;
  const Real x6960 = x4666 - x6692 * x6892 - x6835 * x6898;
  const Real x6969 = x4675 - x6704 * x6888 - x6838 * x6894;
  const Real x6979 = x4686 + x6704 * x6889 + x6838 * x6895;
  const Real x6990 = x4696 - x6704 * x6890 - x6838 * x6896;
  const Real x6999 = x4705 - x6704 * x6891 - x6838 * x6897;
  const Real x7009 = x4716 + x6704 * x6892 + x6838 * x6898;
  const Real x7020 = x4726 - x6716 * x6889 - x6841 * x6895;
  const Real x7029 = x4735 - x6716 * x6890 - x6841 * x6896;
  const Real x7038 = x4744 - x6716 * x6891 - x6841 * x6897;
  const Real x7048 = x4755 + x6716 * x6892 + x6841 * x6898;
  const Real x7059 = x4765 - x6753 * x6890 - x6844 * x6896;
  const Real x7069 = x4776 + x6753 * x6891 + x6844 * x6897;
  const Real x7080 = x4786 - x6753 * x6892 - x6844 * x6898;
  const Real x7089 = x4795 - x6786 * x6891 - x6847 * x6897;
  const Real x7098 = x4804 - x6786 * x6892 - x6847 * x6898;
  const Real x7107 = x4813 - x6822 * x6892 - x6850 * x6898;
  const Real x7113 = tau[23] * x6384 + tau[24] * x6401 + tau[25] * x6418;
  const Real x7143 = x6657 * x6887 + x6682 * x6893 + x6688 * x6899;
  const Real x7118 = tau[23] * x6390 + tau[24] * x6407 + tau[25] * x6424;
  const Real x7148 = x6657 * x6888 + x6682 * x6894 + x6688 * x6900;
  const Real x7123 = tau[23] * x6396 + tau[24] * x6413 + tau[25] * x6430;
  const Real x7153 = x6657 * x6889 + x6682 * x6895 + x6688 * x6901;
  const Real x7128 = tau[23] * x6736 + tau[24] * x6742 + tau[25] * x6748;
  const Real x7158 = x6657 * x6890 + x6682 * x6896 + x6688 * x6902;
  const Real x7133 = tau[23] * x6771 + tau[24] * x6776 + tau[25] * x6781;
  const Real x7163 = x6657 * x6891 + x6682 * x6897 + x6688 * x6903;
  const Real x7138 = tau[23] * x6803 + tau[24] * x6810 + tau[25] * x6817;
  const Real x7168 = x6657 * x6892 + x6682 * x6898 + x6688 * x6904;
  // joint 7 "spine": assembly: its two sides become one chain
  const Real x7262 = x745 * 1.9054878048780488;
  const Real x7264 = x738 * 0.9615384615384615;
  const Real x7266 = x748 * 1.9054878048780488;
  const Real x7267 = x741 * 0.9615384615384615;
  const Real x7269 = x751 * 1.9054878048780488;
  const Real x7270 = x744 * 0.9615384615384615;
  const Real x7308 = x738 * 9.615384615384615;
  w.x[143] = x7308;
  const Real x7309 = x745 * 19.054878048780488;
  w.x[142] = x7309;
  const Real x7310 = x752 * 10.813148788927334;
  w.x[141] = x7310;
  const Real x7311 = x741 * 9.615384615384615;
  w.x[140] = x7311;
  const Real x7312 = x748 * 19.054878048780488;
  w.x[139] = x7312;
  const Real x7313 = x753 * 10.813148788927334;
  w.x[551] = x7313;
  const Real x7314 = x744 * 9.615384615384615;
  w.x[552] = x7314;
  const Real x7315 = x751 * 19.054878048780488;
  w.x[553] = x7315;
  const Real x7316 = x755 * 10.813148788927334;
  w.x[554] = x7316;
  const Real x7347 = x738 * 0.29471544715447157;
  const Real x7348 = x745 * 0.2003205128205128;
  const Real x7349 = x752 * 0.10416666666666667;
  w.x[555] = x7349;
  const Real x7350 = x741 * 0.29471544715447157;
  const Real x7351 = x748 * 0.2003205128205128;
  const Real x7352 = x753 * 0.10416666666666667;
  const Real x7355 = x755 * 0.10416666666666667;
  const Real x7384 = x744 * (x744 * 0.29471544715447157) + x751 * (x751 * 0.2003205128205128);
  const Real x7321 = x745 * x7309 + x752 * x7310 + x738 * x7308;
  const Real x7326 = x748 * x7309 + x753 * x7310 + x741 * x7308;
  const Real x7387 = x6921 - x6856 * x6900 + x7326;
  const Real x7331 = x751 * x7309 + x755 * x7310 + x744 * x7308;
  const Real x7388 = x6930 - x6856 * x6901 + x7331;
  const Real x7275 = x738 * x7262 - x745 * x7264;
  const Real x7389 = x7275 - (x6856 * x6902 + x6940);
  w.x[556] = x7389;
  const Real x7279 = x741 * x7262 - x748 * x7264;
  const Real x7390 = x6951 - x6856 * x6903 + x7279;
  w.x[557] = x7390;
  const Real x7283 = x744 * x7262 - x751 * x7264;
  const Real x7391 = x6960 - x6856 * x6904 + x7283;
  w.x[558] = x7391;
  const Real x7336 = x741 * x7311 + x753 * x7313 + x748 * x7312;
  const Real x7341 = x744 * x7311 + x755 * x7313 + x751 * x7312;
  const Real x7393 = x7341 - (x6862 * x6901 + x6979);
  const Real x7287 = x738 * x7266 - x745 * x7267;
  const Real x7394 = x6990 - x6862 * x6902 + x7287;
  w.x[559] = x7394;
  const Real x7291 = x741 * x7266 - x748 * x7267;
  const Real x7395 = x6999 - x6862 * x6903 + x7291;
  w.x[560] = x7395;
  const Real x7295 = x744 * x7266 - x751 * x7267;
  const Real x7396 = x7295 - (x6862 * x6904 + x7009);
  w.x[561] = x7396;
  const Real x7346 = x744 * x7314 + x751 * x7315 + x755 * x7316;
  const Real x7299 = x738 * x7269 - x745 * x7270;
  const Real x7398 = x7029 - x6868 * x6902 + x7299;
  w.x[562] = x7398;
  const Real x7303 = x741 * x7269 - x748 * x7270;
  const Real x7399 = x7038 - x6868 * x6903 + x7303;
  w.x[563] = x7399;
  const Real x7307 = x744 * x7269 - x751 * x7270;
  const Real x7400 = x7307 - (x6868 * x6904 + x7048);
  w.x[564] = x7400;
  const Real x7360 = x745 * x7348 + x752 * x7349 + x738 * x7347;
  const Real x7401 = x7059 - x6874 * x6902 + x7360;
  require_more(w, x7401, 3.70561680556366e-15, kGrowth, 7);
  require_more(w, x7401, 0.0, kFactorization, 7);
  const Real x7365 = x748 * x7348 + x753 * x7349 + x741 * x7347;
  const Real x7402 = x7365 - (x6874 * x6903 + x7069);
  const Real x7370 = x751 * x7348 + x755 * x7349 + x744 * x7347;
  const Real x7403 = x7080 - x6874 * x6904 + x7370;
  const Real x7375 = x741 * x7350 + x753 * x7352 + x748 * x7351;
  const Real x7404 = x7089 - x6880 * x6903 + x7375;
  require_more(w, x7404, 3.347268281455484e-15, kGrowth, 7);
  const Real x7380 = x744 * x7350 + x755 * x7352 + x751 * x7351;
  const Real x7406 = x7107 - x6886 * x6904 + (x755 * x7355 + x7384);
  require_more(w, x7406, 2.098160614653919e-15, kGrowth, 7);
  const Real x7409 = x7233 + 0.13 * x7227;
  const Real x7413 = 0.13 * x7222 - x7236;
  const Real x7420 = x752 * x7228 - x745 * x7227 - x738 * x7222;
  const Real x7427 = x753 * x7228 - x741 * x7222 - x748 * x7227;
  const Real x7435 = x755 * x7228 - (x744 * x7222 + x751 * x7227);
  const Real x7441 = x745 * x7413 + x752 * x7237 - x738 * x7409;
  const Real x7447 = x753 * x7237 - x741 * x7409 + x748 * x7413;
  const Real x7453 = x751 * x7413 - x744 * x7409 + x755 * x7237;
  const Real x7460 = tau[20] * (x6912 - x6856 * x6899 + x7321);
  const Real x7466 = tau[21] * (x6969 - x6862 * x6900 + x7336);
  const Real x7472 = tau[22] * (x7020 - x6868 * x6901 + x7346);
  const Real x7464 = x7460 + tau[21] * x7387 + tau[22] * x7388;
  const Real x7490 = x7113 + x7143 + x4880 + x7420 - x7464;
  w.x[565] = x7490;
  const Real x7469 = tau[20] * x7387 + x7466 + tau[22] * x7393;
  const Real x7491 = x7118 + x7148 + x4882 + x7427 - x7469;
  w.x[566] = x7491;
  const Real x7474 = tau[20] * x7388 + tau[21] * x7393 + x7472;
  const Real x7492 = x7123 + x7153 + x4884 + x7435 - x7474;
  w.x[567] = x7492;
  const Real x7479 = tau[20] * x7389 + tau[21] * x7394 + tau[22] * x7398;
  const Real x7493 = x7128 + x7158 + x4886 + x7441 - x7479;
  w.x[568] = x7493;
  const Real x7484 = tau[20] * x7390 + tau[21] * x7395 + tau[22] * x7399;
  const Real x7489 = tau[20] * x7391 + tau[21] * x7396 + tau[22] * x7400;
  const Real x7499 = 1 / x7401;
  w.x[569] = x7499;
  const Real x7500 = x7402 * x7499;
  w.x[570] = x7500;
  const Real x7501 = x7403 * x7499;
  w.x[571] = x7501;
  const Real x7504 = x7404 - x7402 * x7500;
  const Real x7507 = x7098 - x6880 * x6904 + x7380 - x7403 * x7500;
  const Real x7508 = 1 / x7504;
  w.x[572] = x7508;
  const Real x7509 = x7507 * x7508;
  w.x[573] = x7509;
  const Real x7515 = x7406 - x7403 * x7501 - x7507 * x7509;
  const Real x7516 = 1 / x7515;
  w.x[574] = x7516;
  const Real x7517 = 1.7763568394002505e-15 * x7404;
  require_more(w, x7504, x7517, kFactorization, 7);
  const Real x7518 = 1.7763568394002505e-15 * x7406;
  require_more(w, x7515, x7518, kFactorization, 7);
  const Real x7494 = x7133 + x7163 + x4888 + x7447 - x7484;
  const Real x7521 = x7494 - x7493 * x7500;
  w.x[575] = x7521;
  const Real x7495 = x7138 + x7168 + x4890 + x7453 - x7489;
  const Real x7527 = x7495 - x7493 * x7501 - x7509 * x7521;
  w.x[576] = x7527;
  const Real x7528 = x745 * 0.9615384615384615;
  w.x[577] = x7528;
  const Real x7534 = x738 * 1.9054878048780488;
  w.x[578] = x7534;
  const Real x7537 = x745 * 0.5716463414634146;
  w.x[579] = x7537;
  const Real x7539 = x748 * 0.5716463414634146;
  w.x[580] = x7539;
  const Real x7541 = x751 * 0.5716463414634146;
  w.x[581] = x7541;
  const Real x7543 = x738 * 0.047002032520325206;
  w.x[582] = x7543;
  const Real x7546 = x738 * 0.2884615384615385;
  w.x[583] = x7546;
  const Real x7547 = x741 * 0.2884615384615385;
  w.x[584] = x7547;
  const Real x7548 = x744 * 0.2884615384615385;
  w.x[585] = x7548;
  const Real x7549 = x745 * 0.07532051282051282;
  w.x[586] = x7549;
  const Real x7554 = x7500 * x7528 - x748 * 0.9615384615384615;
  w.x[587] = x7554;
  const Real x7557 = x741 * 1.9054878048780488 - x7500 * x7534;
  w.x[588] = x7557;
  const Real x7560 = x741 * 0.047002032520325206 - x7500 * x7543;
  w.x[589] = x7560;
  const Real x7563 = x748 * 0.07532051282051282 - x7500 * x7549;
  w.x[590] = x7563;
  const Real x7566 = x7352 - x7349 * x7500;
  w.x[591] = x7566;
  const Real x7572 = x7501 * x7528 - x751 * 0.9615384615384615 - x7509 * x7554;
  w.x[592] = x7572;
  const Real x7578 = x744 * 1.9054878048780488 - x7501 * x7534 - x7509 * x7557;
  w.x[593] = x7578;
  const Real x7584 = x744 * 0.047002032520325206 - x7501 * x7543 - x7509 * x7560;
  w.x[594] = x7584;
  const Real x7590 = x751 * 0.07532051282051282 - x7501 * x7549 - x7509 * x7563;
  w.x[595] = x7590;
  const Real x7596 = x7355 - x7349 * x7501 - x7509 * x7566;
  w.x[596] = x7596;
  const Real x7597 = x7499 * x7528;
  const Real x7599 = x7499 * x7534;
  const Real x7600 = x7499 * x7543;
  const Real x7601 = x7499 * x7549;
  const Real x7602 = x7349 * x7499;
  const Real x7603 = x7508 * x7554;
  const Real x7604 = x7508 * x7557;
  const Real x7605 = x7508 * x7560;
  const Real x7606 = x7508 * x7563;
  const Real x7607 = x7508 * x7566;
  const Real x7608 = x7516 * x7572;
  const Real x7609 = x7516 * x7578;
  const Real x7610 = x7516 * x7584;
  const Real x7611 = x7516 * x7590;
  const Real x7612 = x7516 * x7596;
  const Real x7620 = 9.615384615384615 - x7528 * x7597 - x7554 * x7603;
  const Real x7621 = x7620 - x7572 * x7608;
  w.x[597] = x7621;
  const Real x7629 = x7528 * x7599 - x7554 * x7604 - x7572 * x7609;
  w.x[598] = x7629;
  const Real x7637 = x7528 * x7600 - x7554 * x7605 - x7572 * x7610;
  w.x[599] = x7637;
  const Real x7645 = 0.2884615384615385 + x7528 * x7601 - x7554 * x7606;
  const Real x7646 = x7645 - x7572 * x7611;
  w.x[600] = x7646;
  const Real x7654 = x7528 * x7602 - x7554 * x7607 - x7572 * x7612;
  w.x[601] = x7654;
  const Real x7662 = 19.054878048780488 - x7534 * x7599 - x7557 * x7604;
  const Real x7663 = x7662 - x7578 * x7609;
  w.x[602] = x7663;
  const Real x7671 = -0.5716463414634146 - x7534 * x7600 - x7557 * x7605;
  const Real x7672 = x7671 - x7578 * x7610;
  w.x[603] = x7672;
  const Real x7681 = x7534 * x7601 + x7557 * x7606 + x7578 * x7611;
  w.x[604] = x7681;
  const Real x7691 = x7534 * x7602 + x7557 * x7607 + x7578 * x7612;
  w.x[605] = x7691;
  const Real x7700 = 0.12131605691056911 - x7543 * x7600 - x7560 * x7605;
  const Real x7701 = x7700 - x7584 * x7610;
  w.x[606] = x7701;
  const Real x7710 = x7543 * x7601 + x7560 * x7606 + x7584 * x7611;
  w.x[607] = x7710;
  const Real x7720 = x7543 * x7602 + x7560 * x7607 + x7584 * x7612;
  w.x[608] = x7720;
  const Real x7729 = 0.11282051282051282 - x7549 * x7601 - x7563 * x7606;
  const Real x7730 = x7729 - x7590 * x7611;
  w.x[609] = x7730;
  const Real x7739 = x7549 * x7602 + x7563 * x7607 + x7590 * x7612;
  w.x[610] = x7739;
  const Real x7748 = 0.10416666666666667 - x7349 * x7602 - x7566 * x7607;
  const Real x7749 = x7748 - x7596 * x7612;
  w.x[611] = x7749;
  const Real x7754 = tau[21] * x7311 + tau[22] * x7314 + tau[20] * x7308;
  const Real x7785 = x7521 * x7603 - x7493 * x7597 + x7527 * x7608;
  const Real x7759 = tau[20] * x7309 + tau[22] * x7315 + tau[21] * x7312;
  const Real x7790 = x7493 * x7599 + x7521 * x7604 + x7527 * x7609;
  const Real x7795 = x7493 * x7600 + x7521 * x7605 + x7527 * x7610;
  const Real x7773 = tau[20] * x7537 + tau[22] * x7541 + tau[21] * x7539;
  const Real x7779 = tau[21] * x7547 + tau[22] * x7548 + tau[20] * x7546;
  const Real x7800 = x7493 * x7601 + x7521 * x7606 + x7527 * x7611;
  const Real x7810 = x7754 + x7785 + x7222;
  w.x[612] = x7810;
  const Real x7812 = x7759 + x7790 + x7227;
  w.x[613] = x7812;
  const Real x7764 = tau[20] * x7310 + tau[21] * x7313 + tau[22] * x7316;
  const Real x7814 = x7228 - x7764;
  w.x[614] = x7814;
  const Real x7815 = x7795 - x7773 + x7233;
  w.x[615] = x7815;
  const Real x7817 = x7779 + x7800 + x7236;
  w.x[616] = x7817;
  const Real x7805 = x7493 * x7602 + x7521 * x7607 + x7527 * x7612;
  const Real x7819 = x7237 - x7805;
  w.x[617] = x7819;
  // joint 6 "right_ankle": assembly: its two sides become one chain
  const Real x8016 = x612 * 5.149249888619487;
  w.x[618] = x8016;
  const Real x8018 = x605 * 5.149249888619487;
  w.x[619] = x8018;
  const Real x8019 = x615 * 5.149249888619487;
  w.x[620] = x8019;
  const Real x8021 = x608 * 5.149249888619487;
  w.x[621] = x8021;
  const Real x8022 = x618 * 5.149249888619487;
  w.x[622] = x8022;
  const Real x8024 = x611 * 5.149249888619487;
  w.x[623] = x8024;
  const Real x8028 = x612 * x8018 - x605 * x8016;
  w.x[624] = x8028;
  const Real x8032 = x615 * x8018 - x608 * x8016;
  w.x[625] = x8032;
  const Real x8036 = x618 * x8018 - x611 * x8016;
  w.x[626] = x8036;
  const Real x8040 = x612 * x8021 - x605 * x8019;
  w.x[627] = x8040;
  const Real x8044 = x615 * x8021 - x608 * x8019;
  w.x[628] = x8044;
  const Real x8048 = x618 * x8021 - x611 * x8019;
  w.x[629] = x8048;
  const Real x8052 = x612 * x8024 - x605 * x8022;
  w.x[630] = x8052;
  const Real x8056 = x615 * x8024 - x608 * x8022;
  w.x[631] = x8056;
  const Real x8060 = x618 * x8024 - x611 * x8022;
  w.x[632] = x8060;
  const Real x8061 = x619 * 250.0;
  w.x[633] = x8061;
  const Real x8062 = x605 * 22.388042993997768;
  w.x[634] = x8062;
  const Real x8063 = x612 * 22.388042993997768;
  w.x[635] = x8063;
  const Real x8064 = x620 * 250.0;
  w.x[636] = x8064;
  const Real x8065 = x608 * 22.388042993997768;
  w.x[637] = x8065;
  const Real x8066 = x615 * 22.388042993997768;
  w.x[638] = x8066;
  const Real x8067 = x622 * 250.0;
  w.x[639] = x8067;
  const Real x8068 = x611 * 22.388042993997768;
  w.x[640] = x8068;
  const Real x8069 = x618 * 22.388042993997768;
  w.x[641] = x8069;
  const Real x8074 = x619 * x8061 + x612 * x8063 + x605 * x8062;
  w.x[642] = x8074;
  const Real x8079 = x620 * x8061 + x615 * x8063 + x608 * x8062;
  w.x[643] = x8079;
  const Real x8084 = x622 * x8061 + x618 * x8063 + x611 * x8062;
  w.x[644] = x8084;
  const Real x8089 = x620 * x8064 + x608 * x8065 + x615 * x8066;
  w.x[645] = x8089;
  const Real x8094 = x622 * x8064 + x611 * x8065 + x618 * x8066;
  w.x[646] = x8094;
  const Real x8099 = x611 * x8068 + x618 * x8069 + x622 * x8067;
  w.x[647] = x8099;
}

ADAGEN_NOINLINE void part_0_6(Workspace& w) {
  ADAGEN_INPUTS
  const Real x427 = w.x[45];
  const Real x430 = w.x[46];
  const Real x433 = w.x[47];
  const Real x434 = w.x[48];
  const Real x437 = w.x[49];
  const Real x440 = w.x[50];
  const Real x441 = w.x[51];
  const Real x442 = w.x[52];
  const Real x444 = w.x[53];
  const Real x605 = w.x[66];
  const Real x608 = w.x[67];
  const Real x611 = w.x[68];
  const Real x612 = w.x[69];
  const Real x615 = w.x[70];
  const Real x618 = w.x[71];
  const Real x619 = w.x[72];
  const Real x620 = w.x[73];
  const Real x622 = w.x[74];
  const Real x7621 = w.x[597];
  const Real x7629 = w.x[598];
  const Real x7637 = w.x[599];
  const Real x7646 = w.x[600];
  const Real x7654 = w.x[601];
  const Real x7663 = w.x[602];
  const Real x7672 = w.x[603];
  const Real x7681 = w.x[604];
  const Real x7691 = w.x[605];
  const Real x7701 = w.x[606];
  const Real x7710 = w.x[607];
  const Real x7720 = w.x[608];
  const Real x7730 = w.x[609];
  const Real x7739 = w.x[610];
  const Real x7749 = w.x[611];
  const Real x7865 = w.x[60];
  const Real x7869 = w.x[61];
  const Real x7872 = w.x[62];
  const Real x7873 = w.x[63];
  const Real x7876 = w.x[64];
  const Real x7880 = w.x[65];
  const Real x7968 = w.x[75];
  const Real x7973 = w.x[76];
  const Real x7978 = w.x[77];
  const Real x7983 = w.x[78];
  const Real x7991 = w.x[79];
  const Real x7996 = w.x[80];
  const Real x8016 = w.x[618];
  const Real x8018 = w.x[619];
  const Real x8019 = w.x[620];
  const Real x8021 = w.x[621];
  const Real x8022 = w.x[622];
  const Real x8024 = w.x[623];
  const Real x8028 = w.x[624];
  const Real x8032 = w.x[625];
  const Real x8036 = w.x[626];
  const Real x8040 = w.x[627];
  const Real x8044 = w.x[628];
  const Real x8048 = w.x[629];
  const Real x8052 = w.x[630];
  const Real x8056 = w.x[631];
  const Real x8060 = w.x[632];
  const Real x8061 = w.x[633];
  const Real x8062 = w.x[634];
  const Real x8063 = w.x[635];
  const Real x8064 = w.x[636];
  const Real x8065 = w.x[637];
  const Real x8066 = w.x[638];
  const Real x8067 = w.x[639];
  const Real x8068 = w.x[640];
  const Real x8069 = w.x[641];
  const Real x8074 = w.x[642];
  const Real x8079 = w.x[643];
  const Real x8084 = w.x[644];
  const Real x8089 = w.x[645];
  const Real x8094 = w.x[646];
  const Real x8099 = w.x[647];
  const Real x8628 = w.x[54];
  const Real x8631 = w.x[55];
  const Real x8632 = w.x[56];
  const Real x8635 = w.x[57];
  const Real x8639 = w.x[58];
  const Real x8640 = w.x[59];
  // joint 6 "right_ankle": assembly: its two sides become one chain
  const Real x8100 = x619 * 0.3125;
  w.x[8] = x8100;
  const Real x8101 = x605 * 1.496827474382482;
  const Real x8102 = x612 * 1.496827474382482;
  const Real x8103 = x620 * 0.3125;
  const Real x8104 = x608 * 1.496827474382482;
  const Real x8105 = x615 * 1.496827474382482;
  const Real x8106 = x622 * 0.3125;
  const Real x8118 = x620 * x8100 + x615 * x8102 + x608 * x8101;
  const Real x8137 = x611 * (x611 * 1.496827474382482) + x618 * (x618 * 1.496827474382482);
  const Real x8140 = -36.92319053289395 + x8032;
  w.x[7] = x8140;
  const Real x8142 = 7.1216574945652855 + x8040;
  w.x[6] = x8142;
  const Real x8143 = 10.682486241847927 + x8048;
  w.x[5] = x8143;
  const Real x8145 = -10.198306061363207 + x8056;
  w.x[4] = x8145;
  const Real x8113 = x619 * x8100 + x612 * x8102 + x605 * x8101;
  const Real x8146 = 1.2848662997826115 + x8113;
  require_more(w, x8146, 2.26999404131705e-14, kGrowth, 6);
  require_more(w, x8146, 0.0, kFactorization, 6);
  const Real x8123 = x622 * x8100 + x618 * x8102 + x611 * x8101;
  const Real x8147 = 0.4272994496739171 + x8123;
  const Real x8128 = x620 * x8103 + x608 * x8104 + x615 * x8105;
  const Real x8148 = 3.0888259849975506 + x8128;
  require_more(w, x8148, 4.833574941184154e-14, kGrowth, 6);
  const Real x8149 = x622 * x8106 + x8137 + 1.6409491745108757;
  require_more(w, x8149, 2.776018241250534e-14, kGrowth, 6);
  const Real x8152 = 0.41 * x7872 - x7876;
  const Real x8155 = x7880 + 0.41 * x7869;
  const Real x8165 = x619 * x7865 + x605 * x7869 + x612 * x7872;
  const Real x8175 = x620 * x7865 + x608 * x7869 + x615 * x7872;
  const Real x8185 = x622 * x7865 + x611 * x7869 + x618 * x7872;
  const Real x8194 = x605 * x8152 - (x619 * x7873 + x612 * x8155);
  const Real x8202 = x608 * x8152 - (x620 * x7873 + x615 * x8155);
  const Real x8210 = x611 * x8152 - (x622 * x7873 + x618 * x8155);
  const Real x8220 = tau[18] * x8079 + tau[19] * x8084;
  const Real x8225 = tau[17] * x8079 + tau[19] * x8094;
  const Real x8230 = tau[17] * x8084 + tau[18] * x8094;
  const Real x8247 = x7968 - x8165 - (tau[17] * (923.0797633223488 + x8074) + x8220);
  w.x[3] = x8247;
  const Real x8248 = x7973 - x8175 - (tau[18] * (178.04143736413212 + x8089) + x8225);
  w.x[548] = x8248;
  const Real x8249 = x7978 - x8185 - (tau[19] * (169.97176768938678 + x8099) + x8230);
  w.x[544] = x8249;
  const Real x8236 = tau[17] * x8028 + tau[19] * x8052 + tau[18] * x8142;
  const Real x8250 = x7983 + x8194 - x8236;
  w.x[543] = x8250;
  const Real x8241 = tau[18] * x8044 + tau[19] * x8145 + tau[17] * x8140;
  const Real x8246 = tau[17] * x8036 + tau[19] * x8060 + tau[18] * x8143;
  const Real x8256 = 1 / x8146;
  w.x[539] = x8256;
  const Real x8257 = x8118 * x8256;
  w.x[538] = x8257;
  const Real x8258 = x8147 * x8256;
  w.x[537] = x8258;
  const Real x8261 = x8148 - x8118 * x8257;
  const Real x8133 = x622 * x8103 + x611 * x8104 + x618 * x8105;
  const Real x8264 = x8133 - x8147 * x8257;
  const Real x8265 = 1 / x8261;
  w.x[536] = x8265;
  const Real x8266 = x8264 * x8265;
  w.x[535] = x8266;
  const Real x8272 = x8149 - x8147 * x8258 - x8264 * x8266;
  const Real x8273 = 1 / x8272;
  w.x[534] = x8273;
  const Real x8274 = 1.7763568394002505e-15 * x8148;
  require_more(w, x8261, x8274, kFactorization, 6);
  const Real x8275 = 1.7763568394002505e-15 * x8149;
  require_more(w, x8272, x8275, kFactorization, 6);
  const Real x8278 = x7991 + x8202 - x8241 - x8250 * x8257;
  w.x[533] = x8278;
  const Real x8283 = x7996 + x8210 - x8246 - x8250 * x8258;
  const Real x8284 = x8283 - x8266 * x8278;
  w.x[532] = x8284;
  const Real x8288 = x612 * 4.029847738919598;
  w.x[531] = x8288;
  const Real x8289 = x615 * 4.029847738919598;
  w.x[521] = x8289;
  const Real x8290 = x618 * 4.029847738919598;
  w.x[520] = x8290;
  const Real x8292 = x605 * 0.6143649799515073;
  w.x[519] = x8292;
  const Real x8298 = x605 * 4.029847738919598;
  w.x[518] = x8298;
  const Real x8300 = x608 * 4.029847738919598;
  w.x[517] = x8300;
  const Real x8302 = x611 * 4.029847738919598;
  w.x[516] = x8302;
  const Real x8304 = x612 * 0.6143649799515073;
  w.x[515] = x8304;
  const Real x8312 = x8019 - x8016 * x8257;
  w.x[514] = x8312;
  const Real x8315 = x8018 * x8257 - x8021;
  w.x[513] = x8315;
  const Real x8318 = x8103 - x8100 * x8257;
  w.x[512] = x8318;
  const Real x8321 = x8257 * x8292 - x608 * 0.6143649799515073;
  w.x[511] = x8321;
  const Real x8324 = x8257 * x8304 - x615 * 0.6143649799515073;
  w.x[510] = x8324;
  const Real x8330 = x8022 - x8016 * x8258 - x8266 * x8312;
  w.x[509] = x8330;
  const Real x8336 = x8018 * x8258 - x8024 - x8266 * x8315;
  w.x[508] = x8336;
  const Real x8342 = x8106 - x8100 * x8258 - x8266 * x8318;
  w.x[507] = x8342;
  const Real x8348 = x8258 * x8292 - x611 * 0.6143649799515073 - x8266 * x8321;
  w.x[506] = x8348;
  const Real x8354 = x8258 * x8304 - x618 * 0.6143649799515073 - x8266 * x8324;
  w.x[505] = x8354;
  const Real x8355 = x8016 * x8256;
  const Real x8356 = x8018 * x8256;
  const Real x8358 = x8100 * x8256;
  const Real x8359 = x8256 * x8292;
  const Real x8361 = x8256 * x8304;
  const Real x8363 = x8265 * x8312;
  const Real x8364 = x8265 * x8315;
  const Real x8365 = x8265 * x8318;
  const Real x8366 = x8265 * x8321;
  const Real x8367 = x8265 * x8324;
  const Real x8368 = x8273 * x8330;
  const Real x8369 = x8273 * x8336;
  const Real x8370 = x8273 * x8342;
  const Real x8371 = x8273 * x8348;
  const Real x8372 = x8273 * x8354;
  const Real x8380 = 22.388042993997768 - x8016 * x8355 - x8312 * x8363;
  const Real x8389 = x8016 * x8356 - x8312 * x8364 - x8330 * x8369;
  w.x[504] = x8389;
  const Real x8398 = x8016 * x8358 + x8312 * x8365 + x8330 * x8370;
  const Real x8407 = x8016 * x8359 - x8312 * x8366 - x8330 * x8371;
  const Real x8415 = -4.029847738919598 + x8016 * x8361 - x8312 * x8367;
  const Real x8424 = 22.388042993997768 - x8018 * x8356 - x8315 * x8364;
  const Real x8441 = 4.029847738919598 - x8018 * x8359 - x8315 * x8366;
  const Real x8451 = x8018 * x8361 + x8315 * x8367 + x8336 * x8372;
  w.x[503] = x8451;
  const Real x8460 = 0.3125 - x8100 * x8358 - x8318 * x8365;
  const Real x8485 = 1.0378725930055277 - x8292 * x8359 - x8321 * x8366;
  const Real x8504 = 1.0378725930055277 - x8304 * x8361 - x8324 * x8367;
  const Real x8515 = tau[18] * x8065 + tau[19] * x8068 + tau[17] * x8062;
  const Real x8540 = x8250 * x8355 + x8278 * x8363 + x8284 * x8368;
  const Real x8520 = tau[17] * x8063 + tau[19] * x8069 + tau[18] * x8066;
  const Real x8546 = x8278 * x8364 - x8250 * x8356 + x8284 * x8369;
  const Real x8525 = tau[17] * x8288 + tau[19] * x8290 + tau[18] * x8289;
  const Real x8557 = x8278 * x8366 - x8250 * x8359 + x8284 * x8371;
  const Real x8563 = x8278 * x8367 - x8250 * x8361 + x8284 * x8372;
  const Real x8534 = tau[18] * x8300 + tau[19] * x8302 + tau[17] * x8298;
  const Real x8510 = tau[17] * x8061 + tau[18] * x8064 + tau[19] * x8067;
  const Real x8551 = x8250 * x8358 + x8278 * x8365 + x8284 * x8370;
  // joint 5 "right_knee": assembly: its two sides become one chain
  const Real x8658 = sine[1] * 1.7538265306122447;
  w.x[502] = x8658;
  const Real x8659 = cosine[1] * 1.7538265306122447;
  const Real x8664 = cosine[1] * 29.230442176870746;
  const Real x8665 = sine[1] * x8664;
  const Real x8667 = cosine[1] * x8664;
  const Real x8672 = cosine[1] * 0.38584183673469385;
  const Real x8676 = cosine[1] * x8672;
  const Real x8680 = 7.971938775510204 + x8667 + 250.0;
  require_more(w, x8680, 3.6038760301657154e-12, kGrowth, 5);
  require_more(w, x8680, 0.0, kFactorization, 5);
  const Real x8681 = x8380 - x8330 * x8368 + (37.20238095238095 - x8667);
  require_more(w, x8681, 3.6931557771061296e-13, kGrowth, 5);
  // joint 6 "right_ankle": assembly: its two sides become one chain
  const Real x8433 = x8018 * x8358 - x8315 * x8365 - x8336 * x8370;
  // joint 5 "right_knee": assembly: its two sides become one chain
  const Real x8684 = x8433 - x8658;
  w.x[501] = x8684;
  const Real x8685 = x8441 - x8336 * x8371 - x8659;
  w.x[500] = x8685;
  const Real x8686 = x8460 - x8342 * x8370 + (0.5048894557823129 - x8676);
  require_more(w, x8686, 6.1326605169770555e-15, kGrowth, 5);
  // joint 6 "right_ankle": assembly: its two sides become one chain
  const Real x8469 = x8100 * x8359 - x8318 * x8366 - x8342 * x8371;
  // joint 5 "right_knee": assembly: its two sides become one chain
  const Real x8688 = x8485 - x8348 * x8371 + (0.11904761904761904 + x8676);
  require_more(w, x8688, 1.6440825050567963e-14, kGrowth, 5);
  const Real x8689 = x8504 - x8354 * x8372 + 0.5048894557823129;
  require_more(w, x8689, 1.6440825050567963e-14, kGrowth, 5);
  const Real x8692 = 0.41 * x8631 - x8635;
  const Real x8716 = x7865 + x8510 - (cosine[1] * x8632 + sine[1] * x8628);
  w.x[499] = x8716;
  const Real x8707 = sine[1] * x8632 - cosine[1] * x8628;
  const Real x8715 = sine[1] * x8640 + cosine[1] * x8692;
  const Real x8723 = tau[16] * (x8424 - x8336 * x8369 + 7.971938775510204);
  const Real x8729 = x8520 + x8546 + x7872 - x8631 - x8723;
  w.x[498] = x8729;
  const Real x8719 = x7873 + x8551 + (sine[1] * x8692 - cosine[1] * x8640);
  const Real x8721 = x8563 - x8534 + x7880 - (x8639 + 0.41 * x8628);
  const Real x8737 = 1 / x8680;
  w.x[497] = x8737;
  const Real x8738 = x8665 * x8737;
  w.x[496] = x8738;
  const Real x8740 = x8658 * x8737;
  w.x[495] = x8740;
  const Real x8743 = x8681 - x8665 * x8738;
  const Real x8746 = x8415 - x8330 * x8372 + x8659 + x8658 * x8738;
  const Real x8747 = 1 / x8743;
  w.x[494] = x8747;
  const Real x8748 = x8398 * x8747;
  w.x[493] = x8748;
  const Real x8750 = x8407 * x8747;
  w.x[492] = x8750;
  const Real x8751 = x8746 * x8747;
  w.x[491] = x8751;
  const Real x8754 = x8686 - x8398 * x8748;
  const Real x8757 = x8469 + sine[1] * x8672 + x8407 * x8748;
  // joint 6 "right_ankle": assembly: its two sides become one chain
  const Real x8477 = x8100 * x8361 - x8318 * x8367 - x8342 * x8372;
  // joint 5 "right_knee": assembly: its two sides become one chain
  const Real x8760 = x8477 + x8746 * x8748;
  const Real x8761 = 1 / x8754;
  w.x[490] = x8761;
  const Real x8762 = x8757 * x8761;
  w.x[489] = x8762;
  const Real x8763 = x8760 * x8761;
  w.x[488] = x8763;
  const Real x8769 = x8688 - x8407 * x8750 - x8757 * x8762;
  // joint 6 "right_ankle": assembly: its two sides become one chain
  const Real x8495 = x8292 * x8361 + x8321 * x8367 + x8348 * x8372;
  // joint 5 "right_knee": assembly: its two sides become one chain
  const Real x8776 = x8495 + x8746 * x8750 + x8760 * x8762;
  const Real x8778 = 1 / x8769;
  w.x[487] = x8778;
  const Real x8779 = x8776 * x8778;
  w.x[404] = x8779;
  const Real x8790 = x8689 - x8658 * x8740 - x8746 * x8751;
  const Real x8792 = x8790 - x8760 * x8763 - x8776 * x8779;
  const Real x8793 = 1 / x8792;
  w.x[403] = x8793;
  const Real x8794 = 1.7763568394002505e-15 * x8681;
  require_more(w, x8743, x8794, kFactorization, 5);
  const Real x8795 = 1.7763568394002505e-15 * x8686;
  require_more(w, x8754, x8795, kFactorization, 5);
  const Real x8796 = 1.7763568394002505e-15 * x8688;
  require_more(w, x8769, x8796, kFactorization, 5);
  const Real x8797 = 1.7763568394002505e-15 * x8689;
  require_more(w, x8792, x8797, kFactorization, 5);
  const Real x8728 = x8515 + x8540 + x7869 + x8707 - x8389 * tau[16];
  const Real x8800 = x8728 + x8716 * x8738;
  w.x[402] = x8800;
  const Real x8803 = x8719 - tau[16] * x8684 + x8748 * x8800;
  w.x[401] = x8803;
  const Real x8731 = x8525 + x8557 + x7876 + x8715 - tau[16] * x8685;
  const Real x8809 = x8731 - x8750 * x8800 - x8762 * x8803;
  w.x[400] = x8809;
  const Real x8818 = x8721 + x8451 * tau[16] - x8716 * x8740;
  const Real x8820 = x8818 - x8751 * x8800 - x8763 * x8803;
  const Real x8821 = x8779 * x8809 + x8820;
  w.x[399] = x8821;
  const Real x8822 = sine[1] * 7.971938775510204;
  w.x[89] = x8822;
  const Real x8824 = cosine[1] * 37.20238095238095;
  w.x[88] = x8824;
  const Real x8828 = sine[1] * 0.2141794217687074;
  w.x[87] = x8828;
  const Real x8832 = sine[1] * 1.5146683673469388;
  w.x[86] = x8832;
  const Real x8836 = cosine[1] * 0.11904761904761904;
  w.x[85] = x8836;
  const Real x8841 = cosine[1] * 7.971938775510204 + x8738 * x8822;
  w.x[84] = x8841;
  const Real x8844 = x8738 * x8824 - sine[1] * 37.20238095238095;
  w.x[83] = x8844;
  const Real x8847 = cosine[1] * 1.5146683673469388 + x8738 * x8832;
  w.x[82] = x8847;
  const Real x8849 = x8748 * x8841;
  w.x[81] = x8849;
  const Real x8851 = x8748 * x8844;
  w.x[398] = x8851;
  const Real x8853 = x8748 * x8847;
  w.x[397] = x8853;
  const Real x8859 = x8750 * x8841 + x8762 * x8849;
  w.x[396] = x8859;
  const Real x8863 = x8658 * x8762 - x8659;
  w.x[395] = x8863;
  const Real x8868 = x8750 * x8844 + x8762 * x8851;
  w.x[394] = x8868;
  const Real x8872 = x8762 * x8828 - cosine[1] * 0.2141794217687074;
  w.x[393] = x8872;
  const Real x8877 = x8750 * x8847 + x8762 * x8853;
  w.x[392] = x8877;
  const Real x8880 = sine[1] * 0.11904761904761904 + x8762 * x8836;
  w.x[391] = x8880;
  const Real x8891 = 1.7538265306122447 - x8740 * x8822 - x8751 * x8841;
  const Real x8893 = x8891 - x8763 * x8849 - x8779 * x8859;
  w.x[390] = x8893;
  const Real x8898 = x8658 * x8763 + x8779 * x8863;
  w.x[389] = x8898;
  const Real x8909 = x8740 * x8824 + x8751 * x8844 + x8763 * x8851;
  const Real x8911 = x8779 * x8868 + x8909;
  w.x[388] = x8911;
  const Real x8917 = x8763 * x8828 + x8779 * x8872;
  w.x[387] = x8917;
  const Real x8927 = -0.2141794217687074 + x8740 * x8832 + x8751 * x8847;
  const Real x8929 = x8763 * x8853 + x8927 + x8779 * x8877;
  w.x[386] = x8929;
  const Real x8934 = x8763 * x8836 + x8779 * x8880;
  w.x[385] = x8934;
  const Real x8936 = x8737 * x8822;
  const Real x8937 = x8737 * x8824;
  const Real x8938 = x8737 * x8832;
  const Real x8940 = x8747 * x8841;
  const Real x8941 = x8747 * x8844;
  const Real x8942 = x8747 * x8847;
  const Real x8944 = x8761 * x8849;
  const Real x8945 = x8658 * x8761;
  const Real x8947 = x8761 * x8851;
  const Real x8948 = x8761 * x8828;
  const Real x8950 = x8761 * x8853;
  const Real x8952 = x8761 * x8836;
  const Real x8953 = x8778 * x8859;
  const Real x8955 = x8778 * x8863;
  const Real x8956 = x8778 * x8868;
  const Real x8958 = x8778 * x8872;
  const Real x8959 = x8778 * x8877;
  const Real x8960 = x8778 * x8880;
  const Real x8962 = x8793 * x8893;
  const Real x8963 = x8793 * x8898;
  const Real x8964 = x8793 * x8911;
  const Real x8966 = x8793 * x8917;
  const Real x8967 = x8793 * x8929;
  const Real x8968 = x8793 * x8934;
  const Real x8981 = 7.971938775510204 - x8822 * x8936 - x8841 * x8940;
  const Real x8983 = x8981 - x8849 * x8944 - x8859 * x8953;
  const Real x9005 = x8822 * x8937 + x8841 * x8941 + x8849 * x8947;
  const Real x9029 = -1.5146683673469388 + x8822 * x8938 + x8841 * x8942;
  const Real x9031 = x8849 * x8950 + x9029 + x8859 * x8959;
  const Real x9049 = 7.971938775510204 - x8658 * x8945 - x8863 * x8955;
  const Real x9066 = 1.5146683673469388 - x8658 * x8948 - x8863 * x8958;
  const Real x9097 = 37.20238095238095 - x8824 * x8937 - x8844 * x8941;
  const Real x9099 = x9097 - x8851 * x8947 - x8868 * x8956;
  const Real x9120 = x8824 * x8938 + x8844 * x8942 + x8851 * x8950;
  const Real x9140 = 0.40683460884353745 - x8828 * x8948 - x8872 * x8958;
  const Real x9171 = 0.40683460884353745 - x8832 * x8938 - x8847 * x8942;
  const Real x9173 = x9171 - x8853 * x8950 - x8877 * x8959;
  const Real x9190 = 0.11904761904761904 - x8836 * x8952 - x8880 * x8960;
  const Real x9201 = x8716 * x8936 + x8800 * x8940 + x8803 * x8944;
  const Real x9218 = x8716 * x8937 + x8800 * x8941 + x8803 * x8947;
  const Real x9237 = x8716 * x8938 + x8800 * x8942 + x8803 * x8950;
  const Real x9209 = x8809 * x8955 - x8803 * x8945 + x8821 * x8963;
  const Real x9226 = x8809 * x8958 - x8803 * x8948 + x8821 * x8966;
  const Real x9250 = x9201 - x8809 * x8953 + x8821 * x8962 + x8628;
  w.x[384] = x9250;
  const Real x9252 = 7.971938775510204 * tau[16] + x9209 + x8631;
  w.x[383] = x9252;
  const Real x9254 = x9218 - x8809 * x8956 - x8821 * x8964 + x8632;
  w.x[382] = x9254;
  const Real x9256 = 1.5146683673469388 * tau[16] + x9226 + x8635;
  w.x[381] = x9256;
  const Real x9258 = x8809 * x8959 - x9237 + x8821 * x8967 + x8639;
  w.x[380] = x9258;
  const Real x9247 = x8803 * x8952 - x8809 * x8960 - x8821 * x8968;
  const Real x9260 = x8640 + x9247;
  w.x[379] = x9260;
  // joint 4 "right_hip": assembly: its two sides become one chain
  const Real x9265 = 0.04 * x7629;
  const Real x9267 = x7637 - x9265;
  const Real x9269 = x7646 + 0.04 * x7621;
  w.x[378] = x9269;
  const Real x9272 = x7654 - 0.09 * x7621;
  w.x[648] = x9272;
  const Real x9275 = x7672 - 0.04 * x7663;
  w.x[649] = x9275;
  const Real x9276 = x9265 - x7681;
  const Real x9279 = x7691 + 0.09 * x7629;
  w.x[650] = x9279;
  const Real x9282 = 0.04 * x7672;
  w.x[651] = x9282;
  const Real x9289 = x7701 + 0.0875865051903114 - x9282 - 0.04 * x9275;
  const Real x9293 = 0.04 * x7681 - x7710;
  w.x[652] = x9293;
  const Real x9294 = 0.04 * x9267 + x9293;
  const Real x9299 = 0.04 * x7691 - x7720;
  w.x[653] = x9299;
  const Real x9300 = x9299 - 0.09 * x9267;
  const Real x9303 = x7730 + 0.04 * x7646;
  w.x[654] = x9303;
  const Real x9304 = 0.04 * x9269 + x9303;
  const Real x9308 = 0.04 * x7654 - x7739;
  w.x[655] = x9308;
  const Real x9309 = x9308 - 0.09 * x9269;
  const Real x9314 = x7749 - 0.09 * x7654;
  w.x[656] = x9314;
  const Real x9315 = x9314 - 0.09 * x9272;
  const Real x9316 = x427 * x9267;
  w.x[657] = x9316;
  const Real x9320 = x9316 + x441 * 0.9731833910034601 + x434 * x9275;
  const Real x9322 = x434 * x9276;
  w.x[658] = x9322;
  const Real x9323 = x427 * x9269 + x9322;
  const Real x9327 = x427 * x9272 - x434 * x9279;
  const Real x9328 = x430 * x9267;
  w.x[659] = x9328;
  const Real x9332 = x9328 + x442 * 0.9731833910034601 + x437 * x9275;
  const Real x9334 = x437 * x9276;
  w.x[660] = x9334;
  const Real x9335 = x430 * x9269 + x9334;
  const Real x9339 = x430 * x9272 - x437 * x9279;
  const Real x9340 = x433 * x9267;
  w.x[661] = x9340;
  const Real x9344 = x9340 + x444 * 0.9731833910034601 + x440 * x9275;
  const Real x9346 = x440 * x9276;
  w.x[662] = x9346;
  const Real x9347 = x433 * x9269 + x9346;
  const Real x9351 = x433 * x9272 - x440 * x9279;
  const Real x9399 = x427 * x7621 + x434 * x7629;
  w.x[663] = x9399;
  const Real x9402 = x427 * x7629 + x434 * x7663;
  w.x[664] = x9402;
  const Real x9403 = x441 * 10.813148788927334;
  w.x[665] = x9403;
  const Real x9406 = x430 * x7621 + x437 * x7629;
  w.x[666] = x9406;
  const Real x9409 = x430 * x7629 + x437 * x7663;
  w.x[667] = x9409;
  const Real x9410 = x442 * 10.813148788927334;
  w.x[668] = x9410;
  const Real x9413 = x433 * x7621 + x440 * x7629;
  w.x[669] = x9413;
  const Real x9416 = x433 * x7629 + x440 * x7663;
  w.x[670] = x9416;
  const Real x9417 = x444 * 10.813148788927334;
  w.x[671] = x9417;
  const Real x9452 = x427 * x9289 + x434 * x9294 + x441 * x9300;
  const Real x9457 = x427 * x9294 + x434 * x9304 + x441 * x9309;
  const Real x9462 = x427 * x9300 + x434 * x9309 + x441 * x9315;
  const Real x9467 = x430 * x9289 + x437 * x9294 + x442 * x9300;
  const Real x9472 = x430 * x9294 + x437 * x9304 + x442 * x9309;
  const Real x9477 = x430 * x9300 + x437 * x9309 + x442 * x9315;
  const Real x9482 = x433 * x9289 + x440 * x9294 + x444 * x9300;
  const Real x9487 = x433 * x9294 + x440 * x9304 + x444 * x9309;
  const Real x9492 = x433 * x9300 + x440 * x9309 + x444 * x9315;
  const Real x9422 = x427 * x9399 + x441 * x9403 + x434 * x9402;
  const Real x9523 = x8983 - x8893 * x8962 + x9422;
  w.x[672] = x9523;
  // joint 5 "right_knee": assembly: its two sides become one chain
  const Real x8992 = x8849 * x8945 + x8859 * x8955 - x8893 * x8963;
  // joint 4 "right_hip": assembly: its two sides become one chain
  const Real x9427 = x430 * x9399 + x442 * x9403 + x437 * x9402;
  const Real x9524 = x8992 + x9427;
  w.x[673] = x9524;
  const Real x9432 = x433 * x9399 + x444 * x9403 + x440 * x9402;
  const Real x9525 = x8893 * x8964 - (x8859 * x8956 + x9005) + x9432;
  w.x[674] = x9525;
  // joint 5 "right_knee": assembly: its two sides become one chain
  const Real x9017 = x8849 * x8948 + x8859 * x8958 - x8893 * x8966;
  // joint 4 "right_hip": assembly: its two sides become one chain
  const Real x9356 = x434 * x9323 + x441 * x9327 + x427 * x9320;
  const Real x9526 = x9017 + x9356;
  w.x[675] = x9526;
  const Real x9361 = x437 * x9323 + x442 * x9327 + x430 * x9320;
  const Real x9527 = x9031 - x8893 * x8967 + x9361;
  w.x[676] = x9527;
  // joint 5 "right_knee": assembly: its two sides become one chain
  const Real x9041 = x8893 * x8968 - (x8849 * x8952 + x8859 * x8960);
  // joint 4 "right_hip": assembly: its two sides become one chain
  const Real x9366 = x440 * x9323 + x444 * x9327 + x433 * x9320;
  const Real x9528 = x9041 + x9366;
  w.x[677] = x9528;
  const Real x9437 = x430 * x9406 + x442 * x9410 + x437 * x9409;
  const Real x9529 = x9049 - x8898 * x8963 + x9437;
  w.x[678] = x9529;
  // joint 5 "right_knee": assembly: its two sides become one chain
  const Real x9058 = x8658 * x8947 + x8863 * x8956 + x8898 * x8964;
  // joint 4 "right_hip": assembly: its two sides become one chain
  const Real x9442 = x433 * x9406 + x444 * x9410 + x440 * x9409;
  const Real x9530 = x9058 + x9442;
  w.x[679] = x9530;
  const Real x9371 = x434 * x9335 + x441 * x9339 + x427 * x9332;
  const Real x9531 = x9066 - x8898 * x8966 + x9371;
  w.x[680] = x9531;
  const Real x9376 = x437 * x9335 + x442 * x9339 + x430 * x9332;
  // joint 5 "right_knee": assembly: its two sides become one chain
  const Real x9076 = x8658 * x8950 + x8863 * x8959 + x8898 * x8967;
  // joint 4 "right_hip": assembly: its two sides become one chain
  const Real x9532 = x9376 - x9076;
  w.x[681] = x9532;
  // joint 5 "right_knee": assembly: its two sides become one chain
  const Real x9085 = x8658 * x8952 + x8863 * x8960 + x8898 * x8968;
  // joint 4 "right_hip": assembly: its two sides become one chain
  const Real x9381 = x440 * x9335 + x444 * x9339 + x433 * x9332;
  const Real x9533 = x9085 + x9381;
  w.x[682] = x9533;
  const Real x9447 = x433 * x9413 + x444 * x9417 + x440 * x9416;
  const Real x9534 = x9099 - x8911 * x8964 + x9447;
  w.x[683] = x9534;
  // joint 5 "right_knee": assembly: its two sides become one chain
  const Real x9108 = x8851 * x8948 + x8868 * x8958 + x8911 * x8966;
  // joint 4 "right_hip": assembly: its two sides become one chain
  const Real x9386 = x434 * x9347 + x441 * x9351 + x427 * x9344;
  const Real x9535 = x9108 + x9386;
  w.x[684] = x9535;
  const Real x9391 = x437 * x9347 + x442 * x9351 + x430 * x9344;
  const Real x9536 = x8868 * x8959 + x9120 + x8911 * x8967 + x9391;
  w.x[685] = x9536;
  const Real x9396 = x440 * x9347 + x444 * x9351 + x433 * x9344;
  // joint 5 "right_knee": assembly: its two sides become one chain
  const Real x9131 = x8851 * x8952 + x8868 * x8960 + x8911 * x8968;
  // joint 4 "right_hip": assembly: its two sides become one chain
  const Real x9537 = x9396 - x9131;
  w.x[686] = x9537;
  const Real x9497 = x427 * x9452 + x434 * x9457 + x441 * x9462;
  const Real x9538 = x9140 - x8917 * x8966 + x9497;
  w.x[687] = x9538;
  require_more(w, x9538, 7.261764885558423e-15, kGrowth, 4);
  require_more(w, x9538, 0.0, kFactorization, 4);
  const Real x9502 = x430 * x9452 + x437 * x9457 + x442 * x9462;
  // joint 5 "right_knee": assembly: its two sides become one chain
  const Real x9150 = x8828 * x8950 + x8872 * x8959 + x8917 * x8967;
  // joint 4 "right_hip": assembly: its two sides become one chain
  const Real x9539 = x9502 - x9150;
  w.x[688] = x9539;
  // joint 5 "right_knee": assembly: its two sides become one chain
  const Real x9159 = x8828 * x8952 + x8872 * x8960 + x8917 * x8968;
  // joint 4 "right_hip": assembly: its two sides become one chain
  const Real x9507 = x433 * x9452 + x440 * x9457 + x444 * x9462;
  const Real x9540 = x9159 + x9507;
  w.x[689] = x9540;
  const Real x9512 = x430 * x9467 + x437 * x9472 + x442 * x9477;
  const Real x9541 = x9173 - x8929 * x8967 + x9512;
  w.x[690] = x9541;
  require_more(w, x9541, 7.261764885558423e-15, kGrowth, 4);
  // joint 5 "right_knee": assembly: its two sides become one chain
  const Real x9182 = x8853 * x8952 + x8877 * x8960 + x8929 * x8968;
  // joint 4 "right_hip": assembly: its two sides become one chain
  const Real x9517 = x433 * x9467 + x440 * x9472 + x444 * x9477;
  const Real x9542 = x9182 + x9517;
  w.x[691] = x9542;
  const Real x9522 = x433 * x9482 + x440 * x9487 + x444 * x9492;
  const Real x9543 = x9190 - x8934 * x8968 + x9522;
  w.x[692] = x9543;
  require_more(w, x9543, 3.172065784643304e-15, kGrowth, 4);
}

ADAGEN_NOINLINE void part_0_7(Workspace& w) {
  ADAGEN_INPUTS
  const Real x294 = w.x[30];
  const Real x297 = w.x[31];
  const Real x300 = w.x[32];
  const Real x301 = w.x[33];
  const Real x304 = w.x[34];
  const Real x307 = w.x[35];
  const Real x308 = w.x[36];
  const Real x309 = w.x[37];
  const Real x311 = w.x[38];
  const Real x427 = w.x[45];
  const Real x430 = w.x[46];
  const Real x433 = w.x[47];
  const Real x434 = w.x[48];
  const Real x437 = w.x[49];
  const Real x440 = w.x[50];
  const Real x441 = w.x[51];
  const Real x442 = w.x[52];
  const Real x444 = w.x[53];
  const Real x7621 = w.x[597];
  const Real x7629 = w.x[598];
  const Real x7637 = w.x[599];
  const Real x7646 = w.x[600];
  const Real x7654 = w.x[601];
  const Real x7663 = w.x[602];
  const Real x7672 = w.x[603];
  const Real x7681 = w.x[604];
  const Real x7691 = w.x[605];
  const Real x7701 = w.x[606];
  const Real x7710 = w.x[607];
  const Real x7720 = w.x[608];
  const Real x7730 = w.x[609];
  const Real x7739 = w.x[610];
  const Real x7749 = w.x[611];
  const Real x7810 = w.x[612];
  const Real x7812 = w.x[613];
  const Real x7814 = w.x[614];
  const Real x7815 = w.x[615];
  const Real x7817 = w.x[616];
  const Real x7819 = w.x[617];
  const Real x9250 = w.x[384];
  const Real x9252 = w.x[383];
  const Real x9254 = w.x[382];
  const Real x9256 = w.x[381];
  const Real x9258 = w.x[380];
  const Real x9260 = w.x[379];
  const Real x9269 = w.x[378];
  const Real x9272 = w.x[648];
  const Real x9275 = w.x[649];
  const Real x9279 = w.x[650];
  const Real x9282 = w.x[651];
  const Real x9293 = w.x[652];
  const Real x9299 = w.x[653];
  const Real x9303 = w.x[654];
  const Real x9308 = w.x[655];
  const Real x9314 = w.x[656];
  const Real x9316 = w.x[657];
  const Real x9322 = w.x[658];
  const Real x9328 = w.x[659];
  const Real x9334 = w.x[660];
  const Real x9340 = w.x[661];
  const Real x9346 = w.x[662];
  const Real x9399 = w.x[663];
  const Real x9402 = w.x[664];
  const Real x9403 = w.x[665];
  const Real x9406 = w.x[666];
  const Real x9409 = w.x[667];
  const Real x9410 = w.x[668];
  const Real x9413 = w.x[669];
  const Real x9416 = w.x[670];
  const Real x9417 = w.x[671];
  const Real x9523 = w.x[672];
  const Real x9524 = w.x[673];
  const Real x9525 = w.x[674];
  const Real x9526 = w.x[675];
  const Real x9527 = w.x[676];
  const Real x9528 = w.x[677];
  const Real x9529 = w.x[678];
  const Real x9530 = w.x[679];
  const Real x9531 = w.x[680];
  const Real x9532 = w.x[681];
  const Real x9533 = w.x[682];
  const Real x9534 = w.x[683];
  const Real x9535 = w.x[684];
  const Real x9536 = w.x[685];
  const Real x9537 = w.x[686];
  const Real x9538 = w.x[687];
  const Real x9539 = w.x[688];
  const Real x9540 = w.x[689];
  const Real x9541 = w.x[690];
  const Real x9542 = w.x[691];
  const Real x9543 = w.x[692];
  const Real x10179 = w.x[24];
  const Real x10183 = w.x[25];
  const Real x10186 = w.x[26];
  const Real x10187 = w.x[27];
  const Real x10190 = w.x[28];
  const Real x10194 = w.x[29];
  const Real x10252 = w.x[39];
  const Real x10257 = w.x[40];
  const Real x10261 = w.x[41];
  const Real x10266 = w.x[42];
  const Real x10274 = w.x[43];
  const Real x10279 = w.x[44];
  const Real x10881 = w.x[18];
  const Real x10884 = w.x[19];
  const Real x10885 = w.x[20];
  const Real x10888 = w.x[21];
  const Real x10892 = w.x[22];
  const Real x10893 = w.x[23];
  // joint 4 "right_hip": assembly: its two sides become one chain
  const Real x9548 = 0.09 * x7814 - x7815 + 0.04 * x7812;
  const Real x9551 = x7817 + 0.04 * x7810;
  const Real x9555 = x7819 + 0.09 * x7810;
  const Real x9562 = x441 * x7814 - x427 * x7810 - x434 * x7812;
  const Real x9569 = x442 * x7814 - x430 * x7810 - x437 * x7812;
  const Real x9576 = x444 * x7814 - x433 * x7810 - x440 * x7812;
  const Real x9582 = x427 * x9548 - x434 * x9551 + x441 * x9555;
  const Real x9588 = x430 * x9548 - x437 * x9551 + x442 * x9555;
  const Real x9594 = x433 * x9548 - x440 * x9551 + x444 * x9555;
  const Real x9605 = tau[13] * x9523 + tau[14] * x9524 + tau[15] * x9525;
  const Real x9631 = x9250 + x9562 - x9605;
  w.x[59] = x9631;
  const Real x9610 = tau[13] * x9524 + tau[14] * x9529 + tau[15] * x9530;
  const Real x9632 = x9252 + x9569 - x9610;
  w.x[58] = x9632;
  const Real x9615 = tau[13] * x9525 + tau[14] * x9530 + tau[15] * x9534;
  const Real x9633 = x9254 + x9576 - x9615;
  w.x[57] = x9633;
  const Real x9620 = tau[13] * x9526 + tau[14] * x9531 + tau[15] * x9535;
  const Real x9634 = x9256 + x9582 - x9620;
  w.x[56] = x9634;
  const Real x9625 = tau[13] * x9527 + tau[14] * x9532 + tau[15] * x9536;
  const Real x9630 = tau[13] * x9528 + tau[14] * x9533 + tau[15] * x9537;
  const Real x9639 = 1 / x9538;
  w.x[55] = x9639;
  const Real x9640 = x9539 * x9639;
  w.x[54] = x9640;
  const Real x9641 = x9540 * x9639;
  w.x[647] = x9641;
  const Real x9644 = x9541 - x9539 * x9640;
  const Real x9647 = x9542 - x9540 * x9640;
  const Real x9648 = 1 / x9644;
  w.x[646] = x9648;
  const Real x9649 = x9647 * x9648;
  w.x[645] = x9649;
  const Real x9655 = x9543 - x9540 * x9641 - x9647 * x9649;
  const Real x9656 = 1 / x9655;
  w.x[644] = x9656;
  const Real x9657 = 1.7763568394002505e-15 * x9541;
  require_more(w, x9644, x9657, kFactorization, 4);
  const Real x9658 = 1.7763568394002505e-15 * x9543;
  require_more(w, x9655, x9658, kFactorization, 4);
  const Real x9661 = x9258 + x9588 - x9625 - x9634 * x9640;
  w.x[643] = x9661;
  const Real x9666 = x9260 + x9594 - x9630 - x9634 * x9641;
  const Real x9667 = x9666 - x9649 * x9661;
  w.x[642] = x9667;
  const Real x9671 = x9316 + x434 * x9269 + x441 * x9272;
  w.x[631] = x9671;
  const Real x9684 = x9322 + x427 * x9275 - x441 * x9279;
  w.x[629] = x9684;
  const Real x9695 = x427 * 0.9731833910034601;
  w.x[627] = x9695;
  const Real x9698 = x7701 - x9282;
  const Real x9700 = 0.04 * x7637 - x7710;
  const Real x9703 = x7720 + 0.09 * x7637;
  const Real x9707 = x427 * x7637 + x434 * x7672;
  w.x[625] = x9707;
  const Real x9710 = x430 * x7637 + x437 * x7672;
  w.x[623] = x9710;
  const Real x9713 = x433 * x7637 + x440 * x7672;
  w.x[622] = x9713;
  const Real x9719 = x427 * x9698 + x434 * x9700 - x441 * x9703;
  w.x[621] = x9719;
  const Real x9734 = x7739 + 0.09 * x7646;
  const Real x9739 = x427 * x7646 - x434 * x7681;
  w.x[620] = x9739;
  const Real x9743 = x430 * x7646 - x437 * x7681;
  w.x[80] = x9743;
  const Real x9747 = x433 * x7646 - x440 * x7681;
  w.x[79] = x9747;
  const Real x9753 = x427 * x9293 + x434 * x9303 - x441 * x9734;
  w.x[78] = x9753;
  const Real x9769 = x427 * x7654 - x434 * x7691;
  w.x[77] = x9769;
  const Real x9773 = x430 * x7654 - x437 * x7691;
  w.x[76] = x9773;
  const Real x9777 = x433 * x7654 - x440 * x7691;
  w.x[75] = x9777;
  const Real x9782 = x427 * x9299 + x434 * x9308 + x441 * x9314;
  w.x[65] = x9782;
  const Real x9675 = x9328 + x437 * x9269 + x442 * x9272;
  const Real x9795 = x9675 - x9640 * x9671;
  w.x[64] = x9795;
  const Real x9689 = x9334 + x430 * x9275 - x442 * x9279;
  const Real x9798 = x9689 - x9640 * x9684;
  w.x[63] = x9798;
  const Real x9801 = x430 * 0.9731833910034601 - x9640 * x9695;
  w.x[62] = x9801;
  const Real x9725 = x430 * x9698 + x437 * x9700 - x442 * x9703;
  const Real x9804 = x9725 - x9640 * x9719;
  w.x[61] = x9804;
  const Real x9759 = x430 * x9293 + x437 * x9303 - x442 * x9734;
  const Real x9807 = x9759 - x9640 * x9753;
  w.x[60] = x9807;
  const Real x9787 = x430 * x9299 + x437 * x9308 + x442 * x9314;
  const Real x9810 = x9787 - x9640 * x9782;
  w.x[74] = x9810;
  const Real x9679 = x9340 + x440 * x9269 + x444 * x9272;
  const Real x9816 = x9679 - x9641 * x9671 - x9649 * x9795;
  w.x[73] = x9816;
  const Real x9694 = x9346 + x433 * x9275 - x444 * x9279;
  const Real x9822 = x9694 - x9641 * x9684 - x9649 * x9798;
  w.x[72] = x9822;
  const Real x9828 = x433 * 0.9731833910034601 - x9641 * x9695 - x9649 * x9801;
  w.x[71] = x9828;
  const Real x9731 = x433 * x9698 + x440 * x9700 - x444 * x9703;
  const Real x9834 = x9731 - x9641 * x9719 - x9649 * x9804;
  w.x[70] = x9834;
  const Real x9765 = x433 * x9293 + x440 * x9303 - x444 * x9734;
  const Real x9840 = x9765 - x9641 * x9753 - x9649 * x9807;
  w.x[69] = x9840;
  const Real x9792 = x433 * x9299 + x440 * x9308 + x444 * x9314;
  const Real x9846 = x9792 - x9641 * x9782 - x9649 * x9810;
  w.x[68] = x9846;
  const Real x9847 = x9639 * x9671;
  const Real x9848 = x9639 * x9684;
  const Real x9849 = x9639 * x9695;
  const Real x9850 = x9639 * x9719;
  const Real x9851 = x9639 * x9753;
  const Real x9852 = x9639 * x9782;
  const Real x9853 = x9648 * x9795;
  const Real x9854 = x9648 * x9798;
  const Real x9855 = x9648 * x9801;
  const Real x9856 = x9648 * x9804;
  const Real x9857 = x9648 * x9807;
  const Real x9858 = x9648 * x9810;
  const Real x9859 = x9656 * x9816;
  const Real x9860 = x9656 * x9822;
  const Real x9861 = x9656 * x9828;
  const Real x9862 = x9656 * x9834;
  const Real x9863 = x9656 * x9840;
  const Real x9864 = x9656 * x9846;
  const Real x9872 = x7621 - x9671 * x9847 - x9795 * x9853;
  const Real x9873 = x9872 - x9816 * x9859;
  w.x[67] = x9873;
  const Real x9881 = x7629 - x9671 * x9848 - x9795 * x9854;
  const Real x9882 = x9881 - x9816 * x9860;
  w.x[66] = x9882;
  const Real x9891 = x9671 * x9849 + x9795 * x9855 + x9816 * x9861;
  w.x[693] = x9891;
  const Real x9900 = x7637 - x9671 * x9850 - x9795 * x9856;
  const Real x9901 = x9900 - x9816 * x9862;
  w.x[694] = x9901;
  const Real x9909 = x7646 - x9671 * x9851 - x9795 * x9857;
  const Real x9910 = x9909 - x9816 * x9863;
  w.x[695] = x9910;
  const Real x9918 = x7654 - x9671 * x9852 - x9795 * x9858;
  const Real x9919 = x9918 - x9816 * x9864;
  w.x[696] = x9919;
  const Real x9927 = x7663 - x9684 * x9848 - x9798 * x9854;
  const Real x9928 = x9927 - x9822 * x9860;
  w.x[697] = x9928;
  const Real x9937 = x9684 * x9849 + x9798 * x9855 + x9822 * x9861;
  w.x[698] = x9937;
  const Real x9946 = x7672 - x9684 * x9850 - x9798 * x9856;
  const Real x9947 = x9946 - x9822 * x9862;
  w.x[699] = x9947;
  const Real x9956 = x7681 + x9684 * x9851 + x9798 * x9857;
  const Real x9958 = x9822 * x9863 + x9956;
  w.x[700] = x9958;
  const Real x9968 = x7691 + x9684 * x9852 + x9798 * x9858;
  const Real x9970 = x9822 * x9864 + x9968;
  w.x[701] = x9970;
  const Real x9979 = 10.813148788927334 - x9695 * x9849 - x9801 * x9855;
  const Real x9980 = x9979 - x9828 * x9861;
  w.x[702] = x9980;
  const Real x9989 = x9695 * x9850 + x9801 * x9856 + x9828 * x9862;
  w.x[703] = x9989;
  const Real x9999 = x9695 * x9851 + x9801 * x9857 + x9828 * x9863;
  w.x[704] = x9999;
  const Real x10009 = x9695 * x9852 + x9801 * x9858 + x9828 * x9864;
  w.x[705] = x10009;
  const Real x10018 = x7701 - x9719 * x9850 - x9804 * x9856;
  const Real x10019 = x10018 - x9834 * x9862;
  w.x[706] = x10019;
  const Real x10028 = x7710 + x9719 * x9851 + x9804 * x9857;
  const Real x10030 = x9834 * x9863 + x10028;
  w.x[707] = x10030;
  const Real x10040 = x7720 + x9719 * x9852 + x9804 * x9858;
  const Real x10042 = x9834 * x9864 + x10040;
  w.x[708] = x10042;
  const Real x10051 = x7730 - x9753 * x9851 - x9807 * x9857;
  const Real x10052 = x10051 - x9840 * x9863;
  w.x[709] = x10052;
  const Real x10061 = x7739 + x9753 * x9852 + x9807 * x9858;
  const Real x10063 = x9840 * x9864 + x10061;
  w.x[710] = x10063;
  const Real x10072 = x7749 - x9782 * x9852 - x9810 * x9858;
  const Real x10073 = x10072 - x9846 * x9864;
  w.x[711] = x10073;
  const Real x10078 = tau[13] * x9399 + tau[14] * x9406 + tau[15] * x9413;
  const Real x10108 = x9634 * x9847 + x9661 * x9853 + x9667 * x9859;
  const Real x10083 = tau[13] * x9402 + tau[14] * x9409 + tau[15] * x9416;
  const Real x10113 = x9634 * x9848 + x9661 * x9854 + x9667 * x9860;
  const Real x10088 = tau[13] * x9403 + tau[14] * x9410 + tau[15] * x9417;
  const Real x10118 = x9634 * x9849 + x9661 * x9855 + x9667 * x9861;
  const Real x10093 = tau[13] * x9707 + tau[14] * x9710 + tau[15] * x9713;
  const Real x10123 = x9634 * x9850 + x9661 * x9856 + x9667 * x9862;
  const Real x10098 = tau[13] * x9739 + tau[14] * x9743 + tau[15] * x9747;
  const Real x10128 = x9634 * x9851 + x9661 * x9857 + x9667 * x9863;
  const Real x10103 = tau[13] * x9769 + tau[14] * x9773 + tau[15] * x9777;
  const Real x10133 = x9634 * x9852 + x9661 * x9858 + x9667 * x9864;
  const Real x10140 = x10078 + x10108 + x7810;
  w.x[712] = x10140;
  const Real x10142 = x10083 + x10113 + x7812;
  w.x[713] = x10142;
  const Real x10144 = x7814 - (x10088 + x10118);
  w.x[714] = x10144;
  const Real x10145 = x10093 + x10123 + x7815;
  w.x[715] = x10145;
  const Real x10147 = x10098 + x10128 + x7817;
  w.x[716] = x10147;
  const Real x10149 = x7819 - (x10103 + x10133);
  w.x[717] = x10149;
  // joint 3 "left_ankle": assembly: its two sides become one chain
  const Real x10289 = x301 * 5.149249888619487;
  w.x[718] = x10289;
  const Real x10291 = x294 * 5.149249888619487;
  w.x[719] = x10291;
  const Real x10292 = x304 * 5.149249888619487;
  const Real x10294 = x297 * 5.149249888619487;
  const Real x10295 = x307 * 5.149249888619487;
  const Real x10297 = x300 * 5.149249888619487;
  const Real x10301 = x301 * x10291 - x294 * x10289;
  w.x[720] = x10301;
  const Real x10309 = x307 * x10291 - x300 * x10289;
  w.x[721] = x10309;
  const Real x10317 = x304 * x10294 - x297 * x10292;
  w.x[722] = x10317;
  const Real x10325 = x301 * x10297 - x294 * x10295;
  w.x[723] = x10325;
  const Real x10333 = x307 * x10297 - x300 * x10295;
  w.x[724] = x10333;
  const Real x10334 = x308 * 250.0;
  w.x[725] = x10334;
  const Real x10335 = x294 * 22.388042993997768;
  w.x[726] = x10335;
  const Real x10336 = x301 * 22.388042993997768;
  w.x[727] = x10336;
  const Real x10337 = x309 * 250.0;
  w.x[728] = x10337;
  const Real x10338 = x297 * 22.388042993997768;
  w.x[729] = x10338;
  const Real x10339 = x304 * 22.388042993997768;
  w.x[730] = x10339;
  const Real x10340 = x311 * 250.0;
  w.x[731] = x10340;
  const Real x10341 = x300 * 22.388042993997768;
  w.x[732] = x10341;
  const Real x10342 = x307 * 22.388042993997768;
  w.x[733] = x10342;
  const Real x10352 = x309 * x10334 + x304 * x10336 + x297 * x10335;
  const Real x10357 = x311 * x10334 + x307 * x10336 + x300 * x10335;
  const Real x10367 = x311 * x10337 + x300 * x10338 + x307 * x10339;
  const Real x10373 = x308 * 0.3125;
  w.x[734] = x10373;
  const Real x10374 = x294 * 1.496827474382482;
  const Real x10375 = x301 * 1.496827474382482;
  const Real x10376 = x309 * 0.3125;
  const Real x10377 = x297 * 1.496827474382482;
  const Real x10378 = x304 * 1.496827474382482;
  const Real x10379 = x311 * 0.3125;
  const Real x10391 = x309 * x10373 + x304 * x10375 + x297 * x10374;
  const Real x10410 = x300 * (x300 * 1.496827474382482) + x307 * (x307 * 1.496827474382482);
  const Real x10347 = x308 * x10334 + x301 * x10336 + x294 * x10335;
  const Real x10413 = x304 * x10291 - x297 * x10289 + -36.92319053289395;
  w.x[735] = x10413;
  const Real x10362 = x309 * x10337 + x297 * x10338 + x304 * x10339;
  const Real x10415 = x301 * x10294 - x294 * x10292 + 7.1216574945652855;
  w.x[736] = x10415;
  const Real x10416 = x307 * x10294 - x300 * x10292 + 10.682486241847927;
  w.x[737] = x10416;
  const Real x10372 = x300 * x10341 + x307 * x10342 + x311 * x10340;
  const Real x10418 = x304 * x10297 - x297 * x10295 + -10.198306061363207;
  w.x[738] = x10418;
  const Real x10386 = x308 * x10373 + x301 * x10375 + x294 * x10374;
  const Real x10419 = 1.2848662997826115 + x10386;
  require_more(w, x10419, 2.26999404131705e-14, kGrowth, 3);
  require_more(w, x10419, 0.0, kFactorization, 3);
  const Real x10396 = x311 * x10373 + x307 * x10375 + x300 * x10374;
  const Real x10420 = 0.4272994496739171 + x10396;
  const Real x10401 = x309 * x10376 + x297 * x10377 + x304 * x10378;
  const Real x10421 = 3.0888259849975506 + x10401;
  require_more(w, x10421, 4.833574941184154e-14, kGrowth, 3);
  const Real x10422 = x311 * x10379 + x10410 + 1.6409491745108757;
  require_more(w, x10422, 2.776018241250534e-14, kGrowth, 3);
  const Real x10425 = 0.41 * x10186 - x10190;
  const Real x10428 = x10194 + 0.41 * x10183;
  const Real x10438 = x308 * x10179 + x294 * x10183 + x301 * x10186;
  const Real x10448 = x309 * x10179 + x297 * x10183 + x304 * x10186;
  const Real x10458 = x311 * x10179 + x300 * x10183 + x307 * x10186;
  const Real x10467 = x294 * x10425 - (x308 * x10187 + x301 * x10428);
  const Real x10475 = x297 * x10425 - (x309 * x10187 + x304 * x10428);
  const Real x10483 = x300 * x10425 - (x311 * x10187 + x307 * x10428);
  const Real x10493 = tau[11] * x10352 + tau[12] * x10357;
  const Real x10498 = tau[10] * x10352 + tau[12] * x10367;
  const Real x10503 = tau[10] * x10357 + tau[11] * x10367;
  const Real x10520 = x10252 - x10438 - (tau[10] * (923.0797633223488 + x10347) + x10493);
  w.x[739] = x10520;
  const Real x10521 = x10257 - x10448 - (tau[11] * (178.04143736413212 + x10362) + x10498);
  w.x[740] = x10521;
  const Real x10522 = x10261 - x10458 - (tau[12] * (169.97176768938678 + x10372) + x10503);
  w.x[741] = x10522;
  const Real x10509 = tau[10] * x10301 + tau[12] * x10325 + tau[11] * x10415;
  const Real x10523 = x10266 + x10467 - x10509;
  w.x[742] = x10523;
  const Real x10514 = tau[11] * x10317 + tau[12] * x10418 + tau[10] * x10413;
  const Real x10519 = tau[10] * x10309 + tau[12] * x10333 + tau[11] * x10416;
  const Real x10526 = 1 / x10419;
  w.x[743] = x10526;
  const Real x10527 = x10391 * x10526;
  w.x[744] = x10527;
  const Real x10528 = x10420 * x10526;
  w.x[745] = x10528;
  const Real x10531 = x10421 - x10391 * x10527;
  const Real x10406 = x311 * x10376 + x300 * x10377 + x307 * x10378;
  const Real x10534 = x10406 - x10420 * x10527;
  const Real x10535 = 1 / x10531;
  w.x[746] = x10535;
  const Real x10536 = x10534 * x10535;
  w.x[747] = x10536;
  const Real x10542 = x10422 - x10420 * x10528 - x10534 * x10536;
  const Real x10543 = 1 / x10542;
  w.x[748] = x10543;
  const Real x10544 = 1.7763568394002505e-15 * x10421;
  require_more(w, x10531, x10544, kFactorization, 3);
  const Real x10545 = 1.7763568394002505e-15 * x10422;
  require_more(w, x10542, x10545, kFactorization, 3);
  const Real x10548 = x10274 + x10475 - x10514 - x10523 * x10527;
  w.x[749] = x10548;
  const Real x10553 = x10279 + x10483 - x10519 - x10523 * x10528;
  const Real x10554 = x10553 - x10536 * x10548;
  w.x[750] = x10554;
  const Real x10558 = x301 * 4.029847738919598;
  w.x[751] = x10558;
  const Real x10559 = x304 * 4.029847738919598;
  w.x[752] = x10559;
  const Real x10560 = x307 * 4.029847738919598;
  w.x[753] = x10560;
  const Real x10561 = x294 * 0.6143649799515073;
  w.x[754] = x10561;
  const Real x10567 = x294 * 4.029847738919598;
  w.x[755] = x10567;
  const Real x10569 = x297 * 4.029847738919598;
  w.x[756] = x10569;
  const Real x10571 = x300 * 4.029847738919598;
  w.x[757] = x10571;
  const Real x10573 = x301 * 0.6143649799515073;
  w.x[758] = x10573;
  const Real x10581 = x10292 - x10289 * x10527;
  w.x[759] = x10581;
  const Real x10584 = x10291 * x10527 - x10294;
  w.x[760] = x10584;
  const Real x10587 = x10376 - x10373 * x10527;
  w.x[761] = x10587;
  const Real x10590 = x10527 * x10561 - x297 * 0.6143649799515073;
  w.x[762] = x10590;
  const Real x10593 = x10527 * x10573 - x304 * 0.6143649799515073;
  w.x[763] = x10593;
  const Real x10599 = x10295 - x10289 * x10528 - x10536 * x10581;
  w.x[764] = x10599;
  const Real x10605 = x10291 * x10528 - x10297 - x10536 * x10584;
  w.x[765] = x10605;
  const Real x10611 = x10379 - x10373 * x10528 - x10536 * x10587;
  w.x[766] = x10611;
  const Real x10617 = x10528 * x10561 - x300 * 0.6143649799515073 - x10536 * x10590;
  w.x[767] = x10617;
  const Real x10623 = x10528 * x10573 - x307 * 0.6143649799515073 - x10536 * x10593;
  w.x[768] = x10623;
  const Real x10624 = x10289 * x10526;
  const Real x10625 = x10291 * x10526;
  const Real x10627 = x10373 * x10526;
  const Real x10628 = x10526 * x10561;
  const Real x10630 = x10526 * x10573;
  const Real x10632 = x10535 * x10581;
  const Real x10633 = x10535 * x10584;
  const Real x10634 = x10535 * x10587;
  const Real x10635 = x10535 * x10590;
  const Real x10636 = x10535 * x10593;
  const Real x10637 = x10543 * x10599;
  const Real x10638 = x10543 * x10605;
  const Real x10639 = x10543 * x10611;
  const Real x10640 = x10543 * x10617;
  const Real x10641 = x10543 * x10623;
  const Real x10649 = 22.388042993997768 - x10289 * x10624 - x10581 * x10632;
  const Real x10658 = x10289 * x10625 - x10581 * x10633 - x10599 * x10638;
  w.x[769] = x10658;
  const Real x10667 = x10289 * x10627 + x10581 * x10634 + x10599 * x10639;
  const Real x10676 = x10289 * x10628 - x10581 * x10635 - x10599 * x10640;
  const Real x10684 = -4.029847738919598 + x10289 * x10630 - x10581 * x10636;
  const Real x10693 = 22.388042993997768 - x10291 * x10625 - x10584 * x10633;
  const Real x10710 = 4.029847738919598 - x10291 * x10628 - x10584 * x10635;
  const Real x10720 = x10291 * x10630 + x10584 * x10636 + x10605 * x10641;
  w.x[770] = x10720;
  const Real x10729 = 0.3125 - x10373 * x10627 - x10587 * x10634;
  const Real x10754 = 1.0378725930055277 - x10561 * x10628 - x10590 * x10635;
  const Real x10773 = 1.0378725930055277 - x10573 * x10630 - x10593 * x10636;
  const Real x10784 = tau[11] * x10338 + tau[12] * x10341 + tau[10] * x10335;
  const Real x10809 = x10523 * x10624 + x10548 * x10632 + x10554 * x10637;
  const Real x10789 = tau[10] * x10336 + tau[12] * x10342 + tau[11] * x10339;
  const Real x10815 = x10548 * x10633 - x10523 * x10625 + x10554 * x10638;
  const Real x10794 = tau[10] * x10558 + tau[12] * x10560 + tau[11] * x10559;
  const Real x10826 = x10548 * x10635 - x10523 * x10628 + x10554 * x10640;
  const Real x10832 = x10548 * x10636 - x10523 * x10630 + x10554 * x10641;
  const Real x10803 = tau[11] * x10569 + tau[12] * x10571 + tau[10] * x10567;
  const Real x10779 = tau[10] * x10334 + tau[11] * x10337 + tau[12] * x10340;
  const Real x10820 = x10523 * x10627 + x10548 * x10634 + x10554 * x10639;
  // joint 2 "left_knee": assembly: its two sides become one chain
  const Real x10901 = sine[0] * 1.7538265306122447;
  w.x[771] = x10901;
  const Real x10902 = cosine[0] * 1.7538265306122447;
  w.x[772] = x10902;
  const Real x10906 = cosine[0] * 29.230442176870746;
  const Real x10907 = sine[0] * x10906;
  const Real x10909 = cosine[0] * x10906;
  const Real x10912 = cosine[0] * 0.38584183673469385;
  const Real x10916 = cosine[0] * x10912;
  const Real x10920 = 7.971938775510204 + x10909 + 250.0;
  require_more(w, x10920, 3.6038760301657154e-12, kGrowth, 2);
  require_more(w, x10920, 0.0, kFactorization, 2);
  const Real x10921 = x10649 - x10599 * x10637 + (37.20238095238095 - x10909);
  require_more(w, x10921, 3.6931557771061296e-13, kGrowth, 2);
  // joint 3 "left_ankle": assembly: its two sides become one chain
  const Real x10702 = x10291 * x10627 - x10584 * x10634 - x10605 * x10639;
  // joint 2 "left_knee": assembly: its two sides become one chain
  const Real x10924 = x10702 - x10901;
  w.x[773] = x10924;
  const Real x10925 = x10710 - x10605 * x10640 - x10902;
  w.x[774] = x10925;
  const Real x10926 = x10729 - x10611 * x10639 + (0.5048894557823129 - x10916);
  require_more(w, x10926, 6.1326605169770555e-15, kGrowth, 2);
  // joint 3 "left_ankle": assembly: its two sides become one chain
  const Real x10738 = x10373 * x10628 - x10587 * x10635 - x10611 * x10640;
  // joint 2 "left_knee": assembly: its two sides become one chain
  const Real x10928 = x10754 - x10617 * x10640 + (0.11904761904761904 + x10916);
  require_more(w, x10928, 1.6440825050567963e-14, kGrowth, 2);
  const Real x10929 = x10773 - x10623 * x10641 + 0.5048894557823129;
  require_more(w, x10929, 1.6440825050567963e-14, kGrowth, 2);
  const Real x10932 = 0.41 * x10884 - x10888;
  const Real x10956 = x10179 + x10779 - (cosine[0] * x10885 + sine[0] * x10881);
  w.x[775] = x10956;
  const Real x10947 = sine[0] * x10885 - cosine[0] * x10881;
  const Real x10955 = sine[0] * x10893 + cosine[0] * x10932;
  const Real x10963 = tau[9] * (x10693 - x10605 * x10638 + 7.971938775510204);
  const Real x10969 = x10789 + x10815 + x10186 - x10884 - x10963;
  w.x[776] = x10969;
  const Real x10959 = x10187 + x10820 + (sine[0] * x10932 - cosine[0] * x10893);
  const Real x10961 = x10832 - x10803 + x10194 - (x10892 + 0.41 * x10881);
  const Real x10973 = 1 / x10920;
  w.x[777] = x10973;
  const Real x10974 = x10907 * x10973;
  w.x[778] = x10974;
  const Real x10976 = x10901 * x10973;
  w.x[779] = x10976;
  const Real x10979 = x10921 - x10907 * x10974;
  const Real x10982 = x10684 - x10599 * x10641 + x10902 + x10901 * x10974;
  const Real x10983 = 1 / x10979;
  w.x[780] = x10983;
  const Real x10984 = x10667 * x10983;
  w.x[781] = x10984;
  const Real x10986 = x10676 * x10983;
  w.x[782] = x10986;
  const Real x10987 = x10982 * x10983;
  w.x[783] = x10987;
  const Real x10990 = x10926 - x10667 * x10984;
  const Real x10993 = x10738 + sine[0] * x10912 + x10676 * x10984;
  // joint 3 "left_ankle": assembly: its two sides become one chain
  const Real x10746 = x10373 * x10630 - x10587 * x10636 - x10611 * x10641;
  // joint 2 "left_knee": assembly: its two sides become one chain
  const Real x10996 = x10746 + x10982 * x10984;
  const Real x10997 = 1 / x10990;
  w.x[784] = x10997;
  const Real x10998 = x10993 * x10997;
  w.x[785] = x10998;
  const Real x10999 = x10996 * x10997;
  w.x[786] = x10999;
  const Real x11005 = x10928 - x10676 * x10986 - x10993 * x10998;
  // joint 3 "left_ankle": assembly: its two sides become one chain
  const Real x10764 = x10561 * x10630 + x10590 * x10636 + x10617 * x10641;
  // joint 2 "left_knee": assembly: its two sides become one chain
  const Real x11012 = x10764 + x10982 * x10986 + x10996 * x10998;
  const Real x11014 = 1 / x11005;
  w.x[787] = x11014;
  const Real x11015 = x11012 * x11014;
  w.x[788] = x11015;
  const Real x11026 = x10929 - x10901 * x10976 - x10982 * x10987;
  const Real x11028 = x11026 - x10996 * x10999 - x11012 * x11015;
  const Real x11029 = 1 / x11028;
  w.x[789] = x11029;
  const Real x11030 = 1.7763568394002505e-15 * x10921;
  require_more(w, x10979, x11030, kFactorization, 2);
  const Real x11031 = 1.7763568394002505e-15 * x10926;
  require_more(w, x10990, x11031, kFactorization, 2);
  const Real x11032 = 1.7763568394002505e-15 * x10928;
  require_more(w, x11005, x11032, kFactorization, 2);
  const Real x11033 = 1.7763568394002505e-15 * x10929;
  require_more(w, x11028, x11033, kFactorization, 2);
  const Real x10968 = x10784 + x10809 + x10183 + x10947 - x10658 * tau[9];
  const Real x11036 = x10968 + x10956 * x10974;
  w.x[790] = x11036;
  const Real x11039 = x10959 - tau[9] * x10924 + x10984 * x11036;
  w.x[791] = x11039;
  const Real x10971 = x10794 + x10826 + x10190 + x10955 - tau[9] * x10925;
  const Real x11045 = x10971 - x10986 * x11036 - x10998 * x11039;
  w.x[792] = x11045;
  const Real x11054 = x10961 + x10720 * tau[9] - x10956 * x10976;
  const Real x11056 = x11054 - x10987 * x11036 - x10999 * x11039;
  const Real x11057 = x11015 * x11045 + x11056;
  w.x[793] = x11057;
  const Real x11058 = sine[0] * 7.971938775510204;
  w.x[794] = x11058;
  const Real x11060 = cosine[0] * 37.20238095238095;
  w.x[795] = x11060;
  const Real x11061 = sine[0] * 37.20238095238095;
  w.x[796] = x11061;
  const Real x11063 = sine[0] * 0.2141794217687074;
  w.x[797] = x11063;
  const Real x11065 = cosine[0] * 0.2141794217687074;
  w.x[798] = x11065;
  const Real x11067 = sine[0] * 1.5146683673469388;
  w.x[799] = x11067;
  const Real x11069 = cosine[0] * 1.5146683673469388;
  w.x[800] = x11069;
  const Real x11071 = cosine[0] * 0.11904761904761904;
  w.x[801] = x11071;
  const Real x11072 = sine[0] * 0.11904761904761904;
  w.x[802] = x11072;
  const Real x11076 = cosine[0] * 7.971938775510204 + x10974 * x11058;
  w.x[803] = x11076;
  const Real x11077 = x10974 * x11060;
  w.x[804] = x11077;
}

ADAGEN_NOINLINE void part_0_8(Workspace& w) {
  ADAGEN_INPUTS
  const Real x104 = w.x[9];
  const Real x107 = w.x[10];
  const Real x110 = w.x[11];
  const Real x111 = w.x[12];
  const Real x114 = w.x[13];
  const Real x117 = w.x[14];
  const Real x118 = w.x[15];
  const Real x119 = w.x[16];
  const Real x121 = w.x[17];
  const Real x9873 = w.x[67];
  const Real x9882 = w.x[66];
  const Real x9891 = w.x[693];
  const Real x9901 = w.x[694];
  const Real x9910 = w.x[695];
  const Real x9919 = w.x[696];
  const Real x9928 = w.x[697];
  const Real x9937 = w.x[698];
  const Real x9947 = w.x[699];
  const Real x9958 = w.x[700];
  const Real x9970 = w.x[701];
  const Real x9980 = w.x[702];
  const Real x9989 = w.x[703];
  const Real x9999 = w.x[704];
  const Real x10009 = w.x[705];
  const Real x10019 = w.x[706];
  const Real x10030 = w.x[707];
  const Real x10042 = w.x[708];
  const Real x10052 = w.x[709];
  const Real x10063 = w.x[710];
  const Real x10073 = w.x[711];
  const Real x10140 = w.x[712];
  const Real x10142 = w.x[713];
  const Real x10144 = w.x[714];
  const Real x10145 = w.x[715];
  const Real x10147 = w.x[716];
  const Real x10149 = w.x[717];
  const Real x10881 = w.x[18];
  const Real x10884 = w.x[19];
  const Real x10885 = w.x[20];
  const Real x10888 = w.x[21];
  const Real x10892 = w.x[22];
  const Real x10893 = w.x[23];
  const Real x10901 = w.x[771];
  const Real x10902 = w.x[772];
  const Real x10956 = w.x[775];
  const Real x10973 = w.x[777];
  const Real x10974 = w.x[778];
  const Real x10976 = w.x[779];
  const Real x10983 = w.x[780];
  const Real x10984 = w.x[781];
  const Real x10986 = w.x[782];
  const Real x10987 = w.x[783];
  const Real x10997 = w.x[784];
  const Real x10998 = w.x[785];
  const Real x10999 = w.x[786];
  const Real x11014 = w.x[787];
  const Real x11015 = w.x[788];
  const Real x11029 = w.x[789];
  const Real x11036 = w.x[790];
  const Real x11039 = w.x[791];
  const Real x11045 = w.x[792];
  const Real x11057 = w.x[793];
  const Real x11058 = w.x[794];
  const Real x11060 = w.x[795];
  const Real x11061 = w.x[796];
  const Real x11063 = w.x[797];
  const Real x11065 = w.x[798];
  const Real x11067 = w.x[799];
  const Real x11069 = w.x[800];
  const Real x11071 = w.x[801];
  const Real x11072 = w.x[802];
  const Real x11076 = w.x[803];
  const Real x11077 = w.x[804];
  // joint 2 "left_knee": assembly: its two sides become one chain
  const Real x11079 = x11077 - x11061;
  w.x[44] = x11079;
  const Real x11082 = x11069 + x10974 * x11067;
  w.x[43] = x11082;
  const Real x11084 = x10984 * x11076;
  w.x[42] = x11084;
  const Real x11086 = x10984 * x11079;
  w.x[41] = x11086;
  const Real x11088 = x10984 * x11082;
  w.x[40] = x11088;
  const Real x11094 = x10986 * x11076 + x10998 * x11084;
  w.x[39] = x11094;
  const Real x11098 = x10901 * x10998 - x10902;
  w.x[29] = x11098;
  const Real x11103 = x10986 * x11079 + x10998 * x11086;
  w.x[28] = x11103;
  const Real x11107 = x10998 * x11063 - x11065;
  w.x[27] = x11107;
  const Real x11112 = x10986 * x11082 + x10998 * x11088;
  w.x[26] = x11112;
  const Real x11115 = x11072 + x10998 * x11071;
  w.x[25] = x11115;
  const Real x11126 = 1.7538265306122447 - x10976 * x11058 - x10987 * x11076;
  const Real x11128 = x11126 - x10999 * x11084 - x11015 * x11094;
  w.x[24] = x11128;
  const Real x11133 = x10901 * x10999 + x11015 * x11098;
  w.x[692] = x11133;
  const Real x11144 = x10976 * x11060 + x10987 * x11079 + x10999 * x11086;
  const Real x11146 = x11015 * x11103 + x11144;
  w.x[691] = x11146;
  const Real x11152 = x10999 * x11063 + x11015 * x11107;
  w.x[690] = x11152;
  const Real x11162 = -0.2141794217687074 + x10976 * x11067 + x10987 * x11082;
  const Real x11164 = x10999 * x11088 + x11162 + x11015 * x11112;
  w.x[689] = x11164;
  const Real x11169 = x10999 * x11071 + x11015 * x11115;
  w.x[688] = x11169;
  const Real x11171 = x10973 * x11058;
  const Real x11172 = x10973 * x11060;
  const Real x11173 = x10973 * x11067;
  const Real x11175 = x10983 * x11076;
  const Real x11176 = x10983 * x11079;
  const Real x11177 = x10983 * x11082;
  const Real x11179 = x10997 * x11084;
  const Real x11180 = x10901 * x10997;
  const Real x11182 = x10997 * x11086;
  const Real x11183 = x10997 * x11063;
  const Real x11185 = x10997 * x11088;
  const Real x11187 = x10997 * x11071;
  const Real x11188 = x11014 * x11094;
  const Real x11190 = x11014 * x11098;
  const Real x11191 = x11014 * x11103;
  const Real x11193 = x11014 * x11107;
  const Real x11194 = x11014 * x11112;
  const Real x11195 = x11014 * x11115;
  const Real x11197 = x11029 * x11128;
  const Real x11198 = x11029 * x11133;
  const Real x11199 = x11029 * x11146;
  const Real x11201 = x11029 * x11152;
  const Real x11202 = x11029 * x11164;
  const Real x11203 = x11029 * x11169;
  const Real x11216 = 7.971938775510204 - x11058 * x11171 - x11076 * x11175;
  const Real x11218 = x11216 - x11084 * x11179 - x11094 * x11188;
  const Real x11240 = x11058 * x11172 + x11076 * x11176 + x11084 * x11182;
  const Real x11264 = -1.5146683673469388 + x11058 * x11173 + x11076 * x11177;
  const Real x11266 = x11084 * x11185 + x11264 + x11094 * x11194;
  const Real x11284 = 7.971938775510204 - x10901 * x11180 - x11098 * x11190;
  const Real x11301 = 1.5146683673469388 - x10901 * x11183 - x11098 * x11193;
  const Real x11332 = 37.20238095238095 - x11060 * x11172 - x11079 * x11176;
  const Real x11334 = x11332 - x11086 * x11182 - x11103 * x11191;
  const Real x11355 = x11060 * x11173 + x11079 * x11177 + x11086 * x11185;
  const Real x11375 = 0.40683460884353745 - x11063 * x11183 - x11107 * x11193;
  const Real x11406 = 0.40683460884353745 - x11067 * x11173 - x11082 * x11177;
  const Real x11408 = x11406 - x11088 * x11185 - x11112 * x11194;
  const Real x11425 = 0.11904761904761904 - x11071 * x11187 - x11115 * x11195;
  const Real x11436 = x10956 * x11171 + x11036 * x11175 + x11039 * x11179;
  const Real x11453 = x10956 * x11172 + x11036 * x11176 + x11039 * x11182;
  const Real x11472 = x10956 * x11173 + x11036 * x11177 + x11039 * x11185;
  const Real x11444 = x11045 * x11190 - x11039 * x11180 + x11057 * x11198;
  const Real x11461 = x11045 * x11193 - x11039 * x11183 + x11057 * x11201;
  const Real x11482 = x11039 * x11187 - x11045 * x11195 - x11057 * x11203;
  // joint 1 "left_hip": assembly: its two sides become one chain
  const Real x11500 = 0.09 * x9891;
  const Real x11502 = 0.04 * x9882;
  const Real x11505 = x9901 + x11500 - x11502;
  const Real x11507 = x9910 + 0.04 * x9873;
  const Real x11510 = x9919 + 0.09 * x9873;
  const Real x11516 = x9947 + 0.09 * x9937 - 0.04 * x9928;
  const Real x11517 = x11502 - x9958;
  const Real x11520 = 0.09 * x9882 - x9970;
  const Real x11527 = 0.04 * x9937 - (x9989 + 0.09 * x9980);
  const Real x11530 = x9999 + 0.04 * x9891;
  const Real x11532 = x10009 + x11500;
  const Real x11543 = x10019 + 0.09 * x9989 - 0.04 * x9947;
  const Real x11545 = x11543 - 0.09 * x11527 - 0.04 * x11516;
  const Real x11552 = 0.09 * x9999 - x10030 + 0.04 * x9958;
  const Real x11553 = 0.04 * x11505 + x11552;
  const Real x11561 = 0.09 * x10009 - x10042 + 0.04 * x9970;
  const Real x11562 = 0.09 * x11505 + x11561;
  const Real x11565 = x10052 + 0.04 * x9910;
  const Real x11566 = 0.04 * x11507 + x11565;
  const Real x11570 = 0.04 * x9919 - x10063;
  const Real x11571 = 0.09 * x11507 + x11570;
  const Real x11576 = x10073 + 0.09 * x9919;
  const Real x11577 = 0.09 * x11510 + x11576;
  const Real x11578 = x104 * x11505;
  const Real x11582 = x11578 + x111 * x11516 + x118 * x11527;
  const Real x11584 = x111 * x11517;
  const Real x11588 = x104 * x11507 + x11584 - x118 * x11530;
  const Real x11591 = x118 * x11532;
  const Real x11594 = x104 * x11510 + x111 * x11520 - x11591;
  const Real x11595 = x107 * x11505;
  const Real x11599 = x11595 + x114 * x11516 + x119 * x11527;
  const Real x11601 = x114 * x11517;
  const Real x11605 = x107 * x11507 + x11601 - x119 * x11530;
  const Real x11608 = x119 * x11532;
  const Real x11611 = x107 * x11510 + x114 * x11520 - x11608;
  const Real x11612 = x110 * x11505;
  const Real x11616 = x11612 + x117 * x11516 + x121 * x11527;
  const Real x11618 = x117 * x11517;
  const Real x11622 = x110 * x11507 + x11618 - x121 * x11530;
  const Real x11625 = x121 * x11532;
  const Real x11628 = x110 * x11510 + x117 * x11520 - x11625;
  const Real x11679 = x104 * x9873 + x111 * x9882 - x118 * x9891;
  w.x[687] = x11679;
  const Real x11685 = x104 * x9882 + x111 * x9928 - x118 * x9937;
  w.x[683] = x11685;
  const Real x11693 = x118 * x9980 - (x104 * x9891 + x111 * x9937);
  w.x[679] = x11693;
  const Real x11699 = x107 * x9873 + x114 * x9882 - x119 * x9891;
  w.x[678] = x11699;
  const Real x11705 = x107 * x9882 + x114 * x9928 - x119 * x9937;
  w.x[674] = x11705;
  const Real x11713 = x119 * x9980 - (x107 * x9891 + x114 * x9937);
  w.x[673] = x11713;
  const Real x11719 = x110 * x9873 + x117 * x9882 - x121 * x9891;
  w.x[672] = x11719;
  const Real x11725 = x110 * x9882 + x117 * x9928 - x121 * x9937;
  w.x[662] = x11725;
  const Real x11733 = x121 * x9980 - (x110 * x9891 + x117 * x9937);
  w.x[661] = x11733;
  const Real x11768 = x111 * x11553 + x118 * x11562 + x104 * x11545;
  const Real x11773 = x111 * x11566 + x118 * x11571 + x104 * x11553;
  const Real x11778 = x111 * x11571 + x118 * x11577 + x104 * x11562;
  const Real x11783 = x114 * x11553 + x119 * x11562 + x107 * x11545;
  const Real x11788 = x114 * x11566 + x119 * x11571 + x107 * x11553;
  const Real x11793 = x114 * x11571 + x119 * x11577 + x107 * x11562;
  const Real x11798 = x117 * x11553 + x121 * x11562 + x110 * x11545;
  const Real x11803 = x117 * x11566 + x121 * x11571 + x110 * x11553;
  const Real x11808 = x117 * x11571 + x121 * x11577 + x110 * x11562;
  const Real x11738 = x104 * x11679 + x111 * x11685 + x118 * x11693;
  // joint 2 "left_knee": assembly: its two sides become one chain
  const Real x11227 = x11084 * x11180 + x11094 * x11190 - x11128 * x11198;
  // joint 1 "left_hip": assembly: its two sides become one chain
  const Real x11743 = x107 * x11679 + x114 * x11685 + x119 * x11693;
  const Real x11840 = x11227 + x11743;
  const Real x11748 = x110 * x11679 + x117 * x11685 + x121 * x11693;
  const Real x11841 = x11128 * x11199 - (x11094 * x11191 + x11240) + x11748;
  // joint 2 "left_knee": assembly: its two sides become one chain
  const Real x11252 = x11084 * x11183 + x11094 * x11193 - x11128 * x11201;
  // joint 1 "left_hip": assembly: its two sides become one chain
  const Real x11633 = x111 * x11588 + x118 * x11594 + x104 * x11582;
  const Real x11842 = x11252 + x11633;
  w.x[660] = x11842;
  const Real x11638 = x114 * x11588 + x119 * x11594 + x107 * x11582;
  const Real x11843 = x11266 - x11128 * x11202 + x11638;
  w.x[659] = x11843;
  // joint 2 "left_knee": assembly: its two sides become one chain
  const Real x11276 = x11128 * x11203 - (x11084 * x11187 + x11094 * x11195);
  // joint 1 "left_hip": assembly: its two sides become one chain
  const Real x11643 = x117 * x11588 + x121 * x11594 + x110 * x11582;
  const Real x11844 = x11276 + x11643;
  w.x[658] = x11844;
  const Real x11753 = x107 * x11699 + x114 * x11705 + x119 * x11713;
  // joint 2 "left_knee": assembly: its two sides become one chain
  const Real x11293 = x10901 * x11182 + x11098 * x11191 + x11133 * x11199;
  // joint 1 "left_hip": assembly: its two sides become one chain
  const Real x11758 = x110 * x11699 + x117 * x11705 + x121 * x11713;
  const Real x11846 = x11293 + x11758;
  const Real x11648 = x111 * x11605 + x118 * x11611 + x104 * x11599;
  const Real x11847 = x11301 - x11133 * x11201 + x11648;
  w.x[657] = x11847;
  const Real x11653 = x114 * x11605 + x119 * x11611 + x107 * x11599;
  // joint 2 "left_knee": assembly: its two sides become one chain
  const Real x11311 = x10901 * x11185 + x11098 * x11194 + x11133 * x11202;
  // joint 1 "left_hip": assembly: its two sides become one chain
  const Real x11848 = x11653 - x11311;
  w.x[656] = x11848;
  // joint 2 "left_knee": assembly: its two sides become one chain
  const Real x11320 = x10901 * x11187 + x11098 * x11195 + x11133 * x11203;
  // joint 1 "left_hip": assembly: its two sides become one chain
  const Real x11658 = x117 * x11605 + x121 * x11611 + x110 * x11599;
  const Real x11849 = x11320 + x11658;
  w.x[655] = x11849;
  const Real x11763 = x110 * x11719 + x117 * x11725 + x121 * x11733;
  // joint 2 "left_knee": assembly: its two sides become one chain
  const Real x11343 = x11086 * x11183 + x11103 * x11193 + x11146 * x11201;
  // joint 1 "left_hip": assembly: its two sides become one chain
  const Real x11663 = x111 * x11622 + x118 * x11628 + x104 * x11616;
  const Real x11851 = x11343 + x11663;
  w.x[654] = x11851;
  const Real x11668 = x114 * x11622 + x119 * x11628 + x107 * x11616;
  const Real x11852 = x11103 * x11194 + x11355 + x11146 * x11202 + x11668;
  w.x[653] = x11852;
  const Real x11673 = x117 * x11622 + x121 * x11628 + x110 * x11616;
  // joint 2 "left_knee": assembly: its two sides become one chain
  const Real x11366 = x11086 * x11187 + x11103 * x11195 + x11146 * x11203;
  // joint 1 "left_hip": assembly: its two sides become one chain
  const Real x11853 = x11673 - x11366;
  w.x[652] = x11853;
  const Real x11813 = x111 * x11773 + x118 * x11778 + x104 * x11768;
  const Real x11854 = x11375 - x11152 * x11201 + x11813;
  require_more(w, x11854, 7.261764885558423e-15, kGrowth, 1);
  require_more(w, x11854, 0.0, kFactorization, 1);
  const Real x11818 = x114 * x11773 + x119 * x11778 + x107 * x11768;
  // joint 2 "left_knee": assembly: its two sides become one chain
  const Real x11385 = x11063 * x11185 + x11107 * x11194 + x11152 * x11202;
  // joint 1 "left_hip": assembly: its two sides become one chain
  const Real x11855 = x11818 - x11385;
  // joint 2 "left_knee": assembly: its two sides become one chain
  const Real x11394 = x11063 * x11187 + x11107 * x11195 + x11152 * x11203;
  // joint 1 "left_hip": assembly: its two sides become one chain
  const Real x11823 = x117 * x11773 + x121 * x11778 + x110 * x11768;
  const Real x11856 = x11394 + x11823;
  const Real x11828 = x114 * x11788 + x119 * x11793 + x107 * x11783;
  const Real x11857 = x11408 - x11164 * x11202 + x11828;
  require_more(w, x11857, 7.261764885558423e-15, kGrowth, 1);
  // joint 2 "left_knee": assembly: its two sides become one chain
  const Real x11417 = x11088 * x11187 + x11112 * x11195 + x11164 * x11203;
  // joint 1 "left_hip": assembly: its two sides become one chain
  const Real x11833 = x117 * x11788 + x121 * x11793 + x110 * x11783;
  const Real x11838 = x117 * x11803 + x121 * x11808 + x110 * x11798;
  const Real x11859 = x11425 - x11169 * x11203 + x11838;
  require_more(w, x11859, 3.172065784643304e-15, kGrowth, 1);
  const Real x11866 = 0.04 * x10142 - (x10145 + 0.09 * x10144);
  const Real x11869 = x10147 + 0.04 * x10140;
  const Real x11873 = x10149 - 0.09 * x10140;
  // joint 2 "left_knee": assembly: its two sides become one chain
  const Real x11485 = x11436 - x11045 * x11188 + x11057 * x11197 + x10881;
  // joint 1 "left_hip": assembly: its two sides become one chain
  const Real x11881 = x118 * x10144 - (x104 * x10140 + x111 * x10142);
  const Real x11889 = x119 * x10144 - (x107 * x10140 + x114 * x10142);
  // joint 2 "left_knee": assembly: its two sides become one chain
  const Real x11489 = x11453 - x11045 * x11191 - x11057 * x11199 + x10885;
  // joint 1 "left_hip": assembly: its two sides become one chain
  const Real x11897 = x121 * x10144 - (x110 * x10140 + x117 * x10142);
  const Real x11903 = x118 * x11873 - x111 * x11869 + x104 * x11866;
  // joint 2 "left_knee": assembly: its two sides become one chain
  const Real x11493 = x11045 * x11194 - x11472 + x11057 * x11202 + x10892;
  // joint 1 "left_hip": assembly: its two sides become one chain
  const Real x11909 = x119 * x11873 - x114 * x11869 + x107 * x11866;
  const Real x11915 = x121 * x11873 - x117 * x11869 + x110 * x11866;
  const Real x11922 = tau[6] * (x11218 - x11128 * x11197 + x11738);
  const Real x11928 = tau[7] * (x11284 - x11133 * x11198 + x11753);
  const Real x11934 = tau[8] * (x11334 - x11146 * x11199 + x11763);
  const Real x11926 = x11922 + tau[7] * x11840 + tau[8] * x11841;
  const Real x11952 = x11485 + x11881 - x11926;
  w.x[651] = x11952;
  const Real x11917 = 7.971938775510204 * tau[9] + x11444 + x10884 + x11889;
  const Real x11953 = x11917 - (tau[6] * x11840 + x11928 + tau[8] * x11846);
  w.x[650] = x11953;
  const Real x11936 = tau[6] * x11841 + tau[7] * x11846 + x11934;
  const Real x11954 = x11489 + x11897 - x11936;
  w.x[649] = x11954;
  const Real x11941 = tau[6] * x11842 + tau[7] * x11847 + tau[8] * x11851;
  const Real x11955 = 1.5146683673469388 * tau[9] + x11461 + x10888 + x11903 - x11941;
  w.x[648] = x11955;
  const Real x11946 = tau[6] * x11843 + tau[7] * x11848 + tau[8] * x11852;
  const Real x11951 = tau[6] * x11844 + tau[7] * x11849 + tau[8] * x11853;
  const Real x11958 = 1 / x11854;
  w.x[378] = x11958;
  const Real x11959 = x11855 * x11958;
  w.x[379] = x11959;
  const Real x11960 = x11856 * x11958;
  w.x[380] = x11960;
  const Real x11963 = x11857 - x11855 * x11959;
  const Real x11966 = x11417 + x11833 - x11856 * x11959;
  const Real x11967 = 1 / x11963;
  w.x[381] = x11967;
  const Real x11968 = x11966 * x11967;
  w.x[382] = x11968;
  const Real x11974 = x11859 - x11856 * x11960 - x11966 * x11968;
  const Real x11975 = 1 / x11974;
  w.x[383] = x11975;
  const Real x11976 = 1.7763568394002505e-15 * x11857;
  require_more(w, x11963, x11976, kFactorization, 1);
  const Real x11977 = 1.7763568394002505e-15 * x11859;
  require_more(w, x11974, x11977, kFactorization, 1);
  const Real x11980 = x11493 + x11909 - x11946 - x11955 * x11959;
  w.x[384] = x11980;
  const Real x11985 = x10893 + x11482 + x11915 - x11951 - x11955 * x11960;
  const Real x11986 = x11985 - x11968 * x11980;
  w.x[617] = x11986;
  const Real x11990 = x111 * x11507 + x118 * x11510 + x11578;
  w.x[616] = x11990;
  const Real x12002 = x11584 + x118 * x11520 + x104 * x11516;
  w.x[615] = x12002;
  const Real x12016 = x104 * x11527 - (x11591 + x111 * x11530);
  w.x[614] = x12016;
  const Real x12030 = 0.04 * x9901 - x10030;
  const Real x12033 = 0.09 * x9901 - x10042;
  const Real x12039 = x104 * x9901 + x111 * x9947 - x118 * x9989;
  w.x[613] = x12039;
  const Real x12045 = x107 * x9901 + x114 * x9947 - x119 * x9989;
  w.x[612] = x12045;
  const Real x12051 = x110 * x9901 + x117 * x9947 - x121 * x9989;
  w.x[38] = x12051;
  const Real x12056 = x111 * x12030 + x118 * x12033 + x104 * x11543;
  w.x[37] = x12056;
  const Real x12069 = 0.09 * x9910 - x10063;
  const Real x12076 = x104 * x9910 - x111 * x9958 - x118 * x9999;
  w.x[36] = x12076;
  const Real x12083 = x107 * x9910 - x114 * x9958 - x119 * x9999;
  w.x[35] = x12083;
  const Real x12090 = x110 * x9910 - x117 * x9958 - x121 * x9999;
  w.x[34] = x12090;
  const Real x12095 = x111 * x11565 + x118 * x12069 + x104 * x11552;
  w.x[33] = x12095;
  const Real x12112 = x104 * x9919 - x111 * x9970 - x118 * x10009;
  w.x[32] = x12112;
  const Real x12119 = x107 * x9919 - x114 * x9970 - x119 * x10009;
  w.x[31] = x12119;
  const Real x12126 = x110 * x9919 - x117 * x9970 - x121 * x10009;
  w.x[30] = x12126;
  const Real x12131 = x111 * x11570 + x118 * x11576 + x104 * x11561;
  w.x[611] = x12131;
  const Real x11994 = x114 * x11507 + x119 * x11510 + x11595;
  const Real x12144 = x11994 - x11959 * x11990;
  w.x[610] = x12144;
  const Real x12006 = x11601 + x119 * x11520 + x107 * x11516;
  const Real x12147 = x12006 - x11959 * x12002;
  w.x[609] = x12147;
  const Real x12022 = x107 * x11527 - (x11608 + x114 * x11530);
  const Real x12150 = x12022 - x11959 * x12016;
  w.x[608] = x12150;
  const Real x12061 = x114 * x12030 + x119 * x12033 + x107 * x11543;
  const Real x12153 = x12061 - x11959 * x12056;
  w.x[607] = x12153;
  const Real x12100 = x114 * x11565 + x119 * x12069 + x107 * x11552;
  const Real x12156 = x12100 - x11959 * x12095;
  w.x[606] = x12156;
  const Real x12136 = x114 * x11570 + x119 * x11576 + x107 * x11561;
  const Real x12159 = x12136 - x11959 * x12131;
  w.x[605] = x12159;
  const Real x11998 = x117 * x11507 + x121 * x11510 + x11612;
  const Real x12165 = x11998 - x11960 * x11990 - x11968 * x12144;
  w.x[604] = x12165;
  const Real x12010 = x11618 + x121 * x11520 + x110 * x11516;
  const Real x12171 = x12010 - x11960 * x12002 - x11968 * x12147;
  w.x[603] = x12171;
  const Real x12028 = x110 * x11527 - (x11625 + x117 * x11530);
  const Real x12177 = x12028 - x11960 * x12016 - x11968 * x12150;
  w.x[602] = x12177;
  const Real x12066 = x117 * x12030 + x121 * x12033 + x110 * x11543;
  const Real x12183 = x12066 - x11960 * x12056 - x11968 * x12153;
  w.x[601] = x12183;
  const Real x12105 = x117 * x11565 + x121 * x12069 + x110 * x11552;
  const Real x12189 = x12105 - x11960 * x12095 - x11968 * x12156;
  w.x[600] = x12189;
  const Real x12141 = x117 * x11570 + x121 * x11576 + x110 * x11561;
  const Real x12195 = x12141 - x11960 * x12131 - x11968 * x12159;
  w.x[599] = x12195;
  const Real x12196 = x11958 * x11990;
  w.x[598] = x12196;
  const Real x12197 = x11958 * x12002;
  w.x[597] = x12197;
  const Real x12198 = x11958 * x12016;
  w.x[805] = x12198;
  const Real x12199 = x11958 * x12056;
  w.x[806] = x12199;
  const Real x12200 = x11958 * x12095;
  w.x[807] = x12200;
  const Real x12201 = x11958 * x12131;
  w.x[808] = x12201;
  const Real x12202 = x11967 * x12144;
  w.x[809] = x12202;
  const Real x12203 = x11967 * x12147;
  w.x[810] = x12203;
  const Real x12204 = x11967 * x12150;
  w.x[811] = x12204;
  const Real x12205 = x11967 * x12153;
  w.x[812] = x12205;
  const Real x12206 = x11967 * x12156;
  w.x[813] = x12206;
  const Real x12207 = x11967 * x12159;
  w.x[814] = x12207;
  const Real x12208 = x11975 * x12165;
  w.x[815] = x12208;
  const Real x12209 = x11975 * x12171;
  w.x[816] = x12209;
  const Real x12210 = x11975 * x12177;
  w.x[817] = x12210;
  const Real x12211 = x11975 * x12183;
  w.x[818] = x12211;
  const Real x12212 = x11975 * x12189;
  w.x[819] = x12212;
  const Real x12213 = x11975 * x12195;
  w.x[820] = x12213;
  const Real x12221 = x9873 - x11990 * x12196 - x12144 * x12202;
  const Real x12222 = x12221 - x12165 * x12208;
  w.x[821] = x12222;
  const Real x12230 = x9882 - x11990 * x12197 - x12144 * x12203;
  const Real x12231 = x12230 - x12165 * x12209;
  w.x[822] = x12231;
  const Real x12240 = x9891 + x11990 * x12198 + x12144 * x12204;
  const Real x12242 = x12165 * x12210 + x12240;
  w.x[823] = x12242;
  const Real x12251 = x9901 - x11990 * x12199 - x12144 * x12205;
  const Real x12252 = x12251 - x12165 * x12211;
  w.x[824] = x12252;
  const Real x12260 = x9910 - x11990 * x12200 - x12144 * x12206;
  const Real x12261 = x12260 - x12165 * x12212;
  w.x[825] = x12261;
  const Real x12269 = x9919 - x11990 * x12201 - x12144 * x12207;
  const Real x12270 = x12269 - x12165 * x12213;
  w.x[826] = x12270;
  const Real x12278 = x9928 - x12002 * x12197 - x12147 * x12203;
  const Real x12279 = x12278 - x12171 * x12209;
  w.x[827] = x12279;
  const Real x12288 = x9937 + x12002 * x12198 + x12147 * x12204;
  const Real x12290 = x12171 * x12210 + x12288;
  w.x[828] = x12290;
  const Real x12299 = x9947 - x12002 * x12199 - x12147 * x12205;
  const Real x12300 = x12299 - x12171 * x12211;
  w.x[829] = x12300;
  const Real x12309 = x9958 + x12002 * x12200 + x12147 * x12206;
  const Real x12311 = x12171 * x12212 + x12309;
  w.x[830] = x12311;
  const Real x12321 = x9970 + x12002 * x12201 + x12147 * x12207;
  const Real x12323 = x12171 * x12213 + x12321;
  w.x[831] = x12323;
  const Real x12332 = x9980 - x12016 * x12198 - x12150 * x12204;
  const Real x12333 = x12332 - x12177 * x12210;
  w.x[832] = x12333;
  const Real x12342 = x9989 + x12016 * x12199 + x12150 * x12205;
  const Real x12344 = x12177 * x12211 + x12342;
  w.x[833] = x12344;
  const Real x12354 = x9999 + x12016 * x12200 + x12150 * x12206;
  const Real x12356 = x12177 * x12212 + x12354;
  w.x[834] = x12356;
  const Real x12366 = x10009 + x12016 * x12201 + x12150 * x12207;
  const Real x12368 = x12177 * x12213 + x12366;
  w.x[835] = x12368;
  const Real x12377 = x10019 - x12056 * x12199 - x12153 * x12205;
  const Real x12378 = x12377 - x12183 * x12211;
  w.x[836] = x12378;
  const Real x12387 = x10030 + x12056 * x12200 + x12153 * x12206;
  const Real x12389 = x12183 * x12212 + x12387;
  w.x[837] = x12389;
  const Real x12399 = x10042 + x12056 * x12201 + x12153 * x12207;
  const Real x12401 = x12183 * x12213 + x12399;
  w.x[838] = x12401;
  const Real x12410 = x10052 - x12095 * x12200 - x12156 * x12206;
  const Real x12411 = x12410 - x12189 * x12212;
  w.x[839] = x12411;
  const Real x12420 = x10063 + x12095 * x12201 + x12156 * x12207;
  const Real x12422 = x12189 * x12213 + x12420;
  w.x[840] = x12422;
  const Real x12431 = x10073 - x12131 * x12201 - x12159 * x12207;
  const Real x12432 = x12431 - x12195 * x12213;
  w.x[841] = x12432;
  const Real x12437 = tau[6] * x11679 + tau[7] * x11699 + tau[8] * x11719;
  w.x[842] = x12437;
}

ADAGEN_NOINLINE void part_0_9(Workspace& w) {
  ADAGEN_INPUTS
  const Real x59 = w.x[0];
  const Real x64 = w.x[1];
  const Real x69 = w.x[2];
  const Real x104 = w.x[9];
  const Real x107 = w.x[10];
  const Real x110 = w.x[11];
  const Real x111 = w.x[12];
  const Real x114 = w.x[13];
  const Real x117 = w.x[14];
  const Real x118 = w.x[15];
  const Real x119 = w.x[16];
  const Real x121 = w.x[17];
  const Real x427 = w.x[45];
  const Real x430 = w.x[46];
  const Real x433 = w.x[47];
  const Real x434 = w.x[48];
  const Real x437 = w.x[49];
  const Real x440 = w.x[50];
  const Real x441 = w.x[51];
  const Real x442 = w.x[52];
  const Real x444 = w.x[53];
  const Real x852 = w.x[110];
  const Real x855 = w.x[111];
  const Real x858 = w.x[112];
  const Real x859 = w.x[113];
  const Real x862 = w.x[114];
  const Real x865 = w.x[115];
  const Real x866 = w.x[116];
  const Real x867 = w.x[117];
  const Real x869 = w.x[118];
  const Real x1191 = w.x[154];
  const Real x1194 = w.x[155];
  const Real x1197 = w.x[156];
  const Real x1198 = w.x[157];
  const Real x1201 = w.x[158];
  const Real x1204 = w.x[159];
  const Real x1205 = w.x[160];
  const Real x1206 = w.x[161];
  const Real x1208 = w.x[162];
  const Real x1786 = w.x[196];
  const Real x1788 = w.x[197];
  const Real x1870 = w.x[218];
  const Real x2060 = w.x[99];
  const Real x2072 = w.x[95];
  const Real x2080 = w.x[94];
  const Real x2083 = w.x[93];
  const Real x2086 = w.x[92];
  const Real x2089 = w.x[91];
  const Real x2092 = w.x[90];
  const Real x2098 = w.x[238];
  const Real x2104 = w.x[239];
  const Real x2110 = w.x[240];
  const Real x2116 = w.x[241];
  const Real x2122 = w.x[242];
  const Real x2157 = w.x[243];
  const Real x2219 = w.x[244];
  const Real x2426 = w.x[245];
  const Real x2452 = w.x[246];
  const Real x2453 = w.x[247];
  const Real x2484 = w.x[248];
  const Real x2497 = w.x[249];
  const Real x2505 = w.x[250];
  const Real x2506 = w.x[251];
  const Real x2508 = w.x[252];
  const Real x2515 = w.x[253];
  const Real x2516 = w.x[254];
  const Real x2518 = w.x[255];
  const Real x2519 = w.x[256];
  const Real x2529 = w.x[257];
  const Real x2530 = w.x[258];
  const Real x2531 = w.x[259];
  const Real x2546 = w.x[260];
  const Real x2547 = w.x[261];
  const Real x2561 = w.x[262];
  const Real x2568 = w.x[263];
  const Real x2571 = w.x[264];
  const Real x2577 = w.x[265];
  const Real x2589 = w.x[266];
  const Real x2590 = w.x[267];
  const Real x2592 = w.x[268];
  const Real x2596 = w.x[269];
  const Real x2600 = w.x[270];
  const Real x2604 = w.x[271];
  const Real x2609 = w.x[272];
  const Real x2612 = w.x[273];
  const Real x2615 = w.x[274];
  const Real x2617 = w.x[275];
  const Real x2619 = w.x[276];
  const Real x2621 = w.x[277];
  const Real x2627 = w.x[278];
  const Real x2631 = w.x[279];
  const Real x2636 = w.x[280];
  const Real x2640 = w.x[281];
  const Real x2645 = w.x[282];
  const Real x2648 = w.x[283];
  const Real x2661 = w.x[284];
  const Real x2666 = w.x[285];
  const Real x2679 = w.x[286];
  const Real x2685 = w.x[287];
  const Real x2697 = w.x[288];
  const Real x2702 = w.x[289];
  const Real x3225 = w.x[290];
  const Real x3226 = w.x[291];
  const Real x3227 = w.x[292];
  const Real x3228 = w.x[293];
  const Real x3229 = w.x[294];
  const Real x3230 = w.x[295];
  const Real x3231 = w.x[296];
  const Real x3232 = w.x[297];
  const Real x3233 = w.x[298];
  const Real x3318 = w.x[299];
  const Real x3319 = w.x[300];
  const Real x3320 = w.x[301];
  const Real x3323 = w.x[302];
  const Real x3324 = w.x[303];
  const Real x3325 = w.x[304];
  const Real x3327 = w.x[305];
  const Real x3328 = w.x[306];
  const Real x3329 = w.x[307];
  const Real x3434 = w.x[308];
  const Real x3435 = w.x[309];
  const Real x3436 = w.x[310];
  const Real x3437 = w.x[311];
  const Real x3442 = w.x[312];
  const Real x3443 = w.x[313];
  const Real x3444 = w.x[314];
  const Real x3451 = w.x[315];
  const Real x3452 = w.x[316];
  const Real x3459 = w.x[317];
  const Real x3464 = w.x[318];
  const Real x3470 = w.x[319];
  const Real x3475 = w.x[320];
  const Real x3489 = w.x[321];
  const Real x3492 = w.x[322];
  const Real x3495 = w.x[323];
  const Real x3497 = w.x[324];
  const Real x3499 = w.x[325];
  const Real x3502 = w.x[326];
  const Real x3510 = w.x[327];
  const Real x3511 = w.x[328];
  const Real x3512 = w.x[329];
  const Real x3518 = w.x[330];
  const Real x3532 = w.x[331];
  const Real x3537 = w.x[332];
  const Real x3540 = w.x[333];
  const Real x3543 = w.x[334];
  const Real x3546 = w.x[335];
  const Real x3549 = w.x[336];
  const Real x3552 = w.x[337];
  const Real x3558 = w.x[338];
  const Real x3564 = w.x[339];
  const Real x3570 = w.x[340];
  const Real x3576 = w.x[341];
  const Real x3582 = w.x[342];
  const Real x3588 = w.x[343];
  const Real x4051 = w.x[183];
  const Real x4068 = w.x[182];
  const Real x4085 = w.x[181];
  const Real x4090 = w.x[180];
  const Real x4100 = w.x[179];
  const Real x4110 = w.x[178];
  const Real x4120 = w.x[234];
  const Real x4130 = w.x[233];
  const Real x4135 = w.x[232];
  const Real x4141 = w.x[231];
  const Real x4147 = w.x[230];
  const Real x4152 = w.x[229];
  const Real x4158 = w.x[228];
  const Real x4164 = w.x[227];
  const Real x4169 = w.x[226];
  const Real x4175 = w.x[223];
  const Real x4181 = w.x[222];
  const Real x4226 = w.x[221];
  const Real x4288 = w.x[220];
  const Real x4290 = w.x[219];
  const Real x4291 = w.x[201];
  const Real x4293 = w.x[200];
  const Real x4395 = w.x[199];
  const Real x4396 = w.x[198];
  const Real x4397 = w.x[189];
  const Real x4398 = w.x[188];
  const Real x4404 = w.x[187];
  const Real x4405 = w.x[186];
  const Real x4406 = w.x[185];
  const Real x4413 = w.x[184];
  const Real x4414 = w.x[195];
  const Real x4421 = w.x[194];
  const Real x4426 = w.x[193];
  const Real x4432 = w.x[192];
  const Real x4436 = w.x[191];
  const Real x4449 = w.x[190];
  const Real x4463 = w.x[177];
  const Real x4480 = w.x[176];
  const Real x4486 = w.x[175];
  const Real x4492 = w.x[174];
  const Real x4497 = w.x[173];
  const Real x4512 = w.x[172];
  const Real x4517 = w.x[171];
  const Real x4522 = w.x[170];
  const Real x4527 = w.x[169];
  const Real x4540 = w.x[366];
  const Real x4543 = w.x[367];
  const Real x4546 = w.x[368];
  const Real x4549 = w.x[369];
  const Real x4552 = w.x[370];
  const Real x4555 = w.x[371];
  const Real x4561 = w.x[372];
  const Real x4567 = w.x[373];
  const Real x4573 = w.x[374];
  const Real x4579 = w.x[375];
  const Real x4585 = w.x[376];
  const Real x4591 = w.x[377];
  const Real x6384 = w.x[522];
  const Real x6390 = w.x[523];
  const Real x6396 = w.x[524];
  const Real x6401 = w.x[525];
  const Real x6407 = w.x[526];
  const Real x6413 = w.x[527];
  const Real x6418 = w.x[528];
  const Real x6424 = w.x[529];
  const Real x6430 = w.x[530];
  const Real x6539 = w.x[540];
  const Real x6540 = w.x[541];
  const Real x6541 = w.x[542];
  const Real x6544 = w.x[545];
  const Real x6545 = w.x[546];
  const Real x6546 = w.x[547];
  const Real x6548 = w.x[549];
  const Real x6549 = w.x[550];
  const Real x6550 = w.x[132];
  const Real x6654 = w.x[131];
  const Real x6655 = w.x[130];
  const Real x6656 = w.x[129];
  const Real x6657 = w.x[128];
  const Real x6660 = w.x[127];
  const Real x6661 = w.x[443];
  const Real x6662 = w.x[441];
  const Real x6669 = w.x[439];
  const Real x6670 = w.x[438];
  const Real x6677 = w.x[437];
  const Real x6682 = w.x[436];
  const Real x6688 = w.x[435];
  const Real x6692 = w.x[434];
  const Real x6704 = w.x[433];
  const Real x6716 = w.x[432];
  const Real x6736 = w.x[431];
  const Real x6742 = w.x[429];
  const Real x6748 = w.x[428];
  const Real x6753 = w.x[427];
  const Real x6771 = w.x[410];
  const Real x6776 = w.x[409];
  const Real x6781 = w.x[408];
  const Real x6786 = w.x[407];
  const Real x6803 = w.x[153];
  const Real x6810 = w.x[152];
  const Real x6817 = w.x[151];
  const Real x6822 = w.x[150];
  const Real x6835 = w.x[149];
  const Real x6838 = w.x[148];
  const Real x6841 = w.x[138];
  const Real x6844 = w.x[137];
  const Real x6847 = w.x[136];
  const Real x6850 = w.x[135];
  const Real x6856 = w.x[134];
  const Real x6862 = w.x[133];
  const Real x6868 = w.x[147];
  const Real x6874 = w.x[146];
  const Real x6880 = w.x[145];
  const Real x6886 = w.x[144];
  const Real x7308 = w.x[143];
  const Real x7309 = w.x[142];
  const Real x7310 = w.x[141];
  const Real x7311 = w.x[140];
  const Real x7312 = w.x[139];
  const Real x7313 = w.x[551];
  const Real x7314 = w.x[552];
  const Real x7315 = w.x[553];
  const Real x7316 = w.x[554];
  const Real x7349 = w.x[555];
  const Real x7389 = w.x[556];
  const Real x7390 = w.x[557];
  const Real x7391 = w.x[558];
  const Real x7394 = w.x[559];
  const Real x7395 = w.x[560];
  const Real x7396 = w.x[561];
  const Real x7398 = w.x[562];
  const Real x7399 = w.x[563];
  const Real x7400 = w.x[564];
  const Real x7490 = w.x[565];
  const Real x7491 = w.x[566];
  const Real x7492 = w.x[567];
  const Real x7493 = w.x[568];
  const Real x7499 = w.x[569];
  const Real x7500 = w.x[570];
  const Real x7501 = w.x[571];
  const Real x7508 = w.x[572];
  const Real x7509 = w.x[573];
  const Real x7516 = w.x[574];
  const Real x7521 = w.x[575];
  const Real x7527 = w.x[576];
  const Real x7528 = w.x[577];
  const Real x7534 = w.x[578];
  const Real x7537 = w.x[579];
  const Real x7539 = w.x[580];
  const Real x7541 = w.x[581];
  const Real x7543 = w.x[582];
  const Real x7546 = w.x[583];
  const Real x7547 = w.x[584];
  const Real x7548 = w.x[585];
  const Real x7549 = w.x[586];
  const Real x7554 = w.x[587];
  const Real x7557 = w.x[588];
  const Real x7560 = w.x[589];
  const Real x7563 = w.x[590];
  const Real x7566 = w.x[591];
  const Real x7572 = w.x[592];
  const Real x7578 = w.x[593];
  const Real x7584 = w.x[594];
  const Real x7590 = w.x[595];
  const Real x7596 = w.x[596];
  const Real x9399 = w.x[663];
  const Real x9402 = w.x[664];
  const Real x9403 = w.x[665];
  const Real x9406 = w.x[666];
  const Real x9409 = w.x[667];
  const Real x9410 = w.x[668];
  const Real x9413 = w.x[669];
  const Real x9416 = w.x[670];
  const Real x9417 = w.x[671];
  const Real x9526 = w.x[675];
  const Real x9527 = w.x[676];
  const Real x9528 = w.x[677];
  const Real x9531 = w.x[680];
  const Real x9532 = w.x[681];
  const Real x9533 = w.x[682];
  const Real x9535 = w.x[684];
  const Real x9536 = w.x[685];
  const Real x9537 = w.x[686];
  const Real x9631 = w.x[59];
  const Real x9632 = w.x[58];
  const Real x9633 = w.x[57];
  const Real x9634 = w.x[56];
  const Real x9639 = w.x[55];
  const Real x9640 = w.x[54];
  const Real x9641 = w.x[647];
  const Real x9648 = w.x[646];
  const Real x9649 = w.x[645];
  const Real x9656 = w.x[644];
  const Real x9661 = w.x[643];
  const Real x9667 = w.x[642];
  const Real x9671 = w.x[631];
  const Real x9684 = w.x[629];
  const Real x9695 = w.x[627];
  const Real x9707 = w.x[625];
  const Real x9710 = w.x[623];
  const Real x9713 = w.x[622];
  const Real x9719 = w.x[621];
  const Real x9739 = w.x[620];
  const Real x9743 = w.x[80];
  const Real x9747 = w.x[79];
  const Real x9753 = w.x[78];
  const Real x9769 = w.x[77];
  const Real x9773 = w.x[76];
  const Real x9777 = w.x[75];
  const Real x9782 = w.x[65];
  const Real x9795 = w.x[64];
  const Real x9798 = w.x[63];
  const Real x9801 = w.x[62];
  const Real x9804 = w.x[61];
  const Real x9807 = w.x[60];
  const Real x9810 = w.x[74];
  const Real x9816 = w.x[73];
  const Real x9822 = w.x[72];
  const Real x9828 = w.x[71];
  const Real x9834 = w.x[70];
  const Real x9840 = w.x[69];
  const Real x9846 = w.x[68];
  const Real x10140 = w.x[712];
  const Real x10142 = w.x[713];
  const Real x10144 = w.x[714];
  const Real x10145 = w.x[715];
  const Real x10147 = w.x[716];
  const Real x10149 = w.x[717];
  const Real x11679 = w.x[687];
  const Real x11685 = w.x[683];
  const Real x11693 = w.x[679];
  const Real x11699 = w.x[678];
  const Real x11705 = w.x[674];
  const Real x11713 = w.x[673];
  const Real x11719 = w.x[672];
  const Real x11725 = w.x[662];
  const Real x11733 = w.x[661];
  const Real x11842 = w.x[660];
  const Real x11843 = w.x[659];
  const Real x11844 = w.x[658];
  const Real x11847 = w.x[657];
  const Real x11848 = w.x[656];
  const Real x11849 = w.x[655];
  const Real x11851 = w.x[654];
  const Real x11852 = w.x[653];
  const Real x11853 = w.x[652];
  const Real x11952 = w.x[651];
  const Real x11953 = w.x[650];
  const Real x11954 = w.x[649];
  const Real x11955 = w.x[648];
  const Real x11958 = w.x[378];
  const Real x11959 = w.x[379];
  const Real x11960 = w.x[380];
  const Real x11967 = w.x[381];
  const Real x11968 = w.x[382];
  const Real x11975 = w.x[383];
  const Real x11980 = w.x[384];
  const Real x11986 = w.x[617];
  const Real x11990 = w.x[616];
  const Real x12002 = w.x[615];
  const Real x12016 = w.x[614];
  const Real x12039 = w.x[613];
  const Real x12045 = w.x[612];
  const Real x12051 = w.x[38];
  const Real x12056 = w.x[37];
  const Real x12076 = w.x[36];
  const Real x12083 = w.x[35];
  const Real x12090 = w.x[34];
  const Real x12095 = w.x[33];
  const Real x12112 = w.x[32];
  const Real x12119 = w.x[31];
  const Real x12126 = w.x[30];
  const Real x12131 = w.x[611];
  const Real x12144 = w.x[610];
  const Real x12147 = w.x[609];
  const Real x12150 = w.x[608];
  const Real x12153 = w.x[607];
  const Real x12156 = w.x[606];
  const Real x12159 = w.x[605];
  const Real x12165 = w.x[604];
  const Real x12171 = w.x[603];
  const Real x12177 = w.x[602];
  const Real x12183 = w.x[601];
  const Real x12189 = w.x[600];
  const Real x12195 = w.x[599];
  const Real x12196 = w.x[598];
  const Real x12197 = w.x[597];
  const Real x12198 = w.x[805];
  const Real x12199 = w.x[806];
  const Real x12200 = w.x[807];
  const Real x12201 = w.x[808];
  const Real x12202 = w.x[809];
  const Real x12203 = w.x[810];
  const Real x12204 = w.x[811];
  const Real x12205 = w.x[812];
  const Real x12206 = w.x[813];
  const Real x12207 = w.x[814];
  const Real x12208 = w.x[815];
  const Real x12209 = w.x[816];
  const Real x12210 = w.x[817];
  const Real x12211 = w.x[818];
  const Real x12212 = w.x[819];
  const Real x12213 = w.x[820];
  const Real x12222 = w.x[821];
  const Real x12231 = w.x[822];
  const Real x12242 = w.x[823];
  const Real x12252 = w.x[824];
  const Real x12261 = w.x[825];
  const Real x12270 = w.x[826];
  const Real x12279 = w.x[827];
  const Real x12290 = w.x[828];
  const Real x12300 = w.x[829];
  const Real x12311 = w.x[830];
  const Real x12323 = w.x[831];
  const Real x12333 = w.x[832];
  const Real x12344 = w.x[833];
  const Real x12356 = w.x[834];
  const Real x12368 = w.x[835];
  const Real x12378 = w.x[836];
  const Real x12389 = w.x[837];
  const Real x12401 = w.x[838];
  const Real x12411 = w.x[839];
  const Real x12422 = w.x[840];
  const Real x12432 = w.x[841];
  const Real x12437 = w.x[842];
  // joint 1 "left_hip": assembly: its two sides become one chain
  const Real x12467 = x11955 * x12196 + x11980 * x12202 + x11986 * x12208;
  const Real x12442 = tau[6] * x11685 + tau[7] * x11705 + tau[8] * x11725;
  const Real x12472 = x11955 * x12197 + x11980 * x12203 + x11986 * x12209;
  const Real x12447 = tau[6] * x11693 + tau[7] * x11713 + tau[8] * x11733;
  const Real x12477 = x11955 * x12198 + x11980 * x12204 + x11986 * x12210;
  const Real x12452 = tau[6] * x12039 + tau[7] * x12045 + tau[8] * x12051;
  const Real x12482 = x11955 * x12199 + x11980 * x12205 + x11986 * x12211;
  const Real x12457 = tau[6] * x12076 + tau[7] * x12083 + tau[8] * x12090;
  const Real x12487 = x11955 * x12200 + x11980 * x12206 + x11986 * x12212;
  const Real x12462 = tau[6] * x12112 + tau[7] * x12119 + tau[8] * x12126;
  const Real x12492 = x11955 * x12201 + x11980 * x12207 + x11986 * x12213;
  // joint 0 "root": assembly: its two sides become one chain
  const Real x12528 = x12252 * tau[0] + x12261 * tau[1] + x12270 * tau[2];
  const Real x12530 = x12222 * tau[3] + x12528 + x12231 * tau[4];
  const Real x12542 = x12300 * tau[0] - x12311 * tau[1] - x12323 * tau[2];
  const Real x12544 = x12231 * tau[3] + x12542 + x12279 * tau[4];
  const Real x12559 = x12344 * tau[0] + x12356 * tau[1] + x12368 * tau[2];
  const Real x12563 = x12242 * tau[3] + x12559 + x12290 * tau[4];
  const Real x12576 = x12378 * tau[0] - x12389 * tau[1] - x12401 * tau[2];
  const Real x12578 = x12252 * tau[3] + x12576 + x12300 * tau[4];
  const Real x12591 = x12411 * tau[1] - x12389 * tau[0] - x12422 * tau[2];
  const Real x12593 = x12261 * tau[3] + x12591 - x12311 * tau[4];
  const Real x12607 = x12432 * tau[2] - (x12401 * tau[0] + x12422 * tau[1]);
  const Real x12609 = x12270 * tau[3] + x12607 - x12323 * tau[4];
  const Real x12613 = x10144 - (x12447 + x12477) + (x12333 * tau[5] - x12563);
  w.result[5] = x12613;
  const Real x12517 = x12452 + x12482 + x10145 + x59;
  const Real x12518 = x12457 + x12487 + x10147 + x64;
  const Real x12519 = x69 - (x10149 - (x12462 + x12492));
  // joint 0 "root": disassembly: its acceleration and force
  const Real x12618 = -(x12517 - (x12578 - x12344 * tau[5]));
  w.result[0] = x12618;
  const Real x12619 = -(x12518 - (x12593 - x12356 * tau[5]));
  w.result[1] = x12619;
  const Real x12620 = -(x12519 - (x12609 - x12368 * tau[5]));
  w.result[2] = x12620;
  const Real x12621 = -(x12437 + x12467 + x10140 - (x12530 - x12242 * tau[5]));
  w.result[3] = x12621;
  const Real x12622 = -(x12442 + x12472 + x10142 - (x12544 - x12290 * tau[5]));
  w.result[4] = x12622;
  // joint 1 "left_hip": disassembly: its acceleration and force
  const Real x12633 = x11990 * tau[3] + x12002 * tau[4] + x12016 * tau[5];
  const Real x12635 = x12056 * tau[0] + x12633 + x12095 * tau[1];
  const Real x12644 = x12144 * tau[3] + x12147 * tau[4] + x12150 * tau[5];
  const Real x12646 = x12153 * tau[0] + x12644 + x12156 * tau[1];
  const Real x12655 = x12165 * tau[3] + x12171 * tau[4] + x12177 * tau[5];
  const Real x12657 = x12183 * tau[0] + x12655 + x12189 * tau[1];
  const Real x12669 = x11679 * tau[3] + x11685 * tau[4] + x11693 * tau[5];
  const Real x12671 = x12039 * tau[0] + x12669 + x12076 * tau[1];
  const Real x12680 = x11699 * tau[3] + x11705 * tau[4] + x11713 * tau[5];
  const Real x12682 = x12045 * tau[0] + x12680 + x12083 * tau[1];
  const Real x12691 = x11719 * tau[3] + x11725 * tau[4] + x11733 * tau[5];
  const Real x12693 = x12051 * tau[0] + x12691 + x12090 * tau[1];
  const Real x12703 = x11975 * (x12195 * tau[2] + x12657 + x11986);
  w.x[804] = x12703;
  const Real x12702 = x11967 * (x12159 * tau[2] + x12646 + x11980);
  const Real x12706 = x12702 - x11968 * x12703;
  w.x[802] = x12706;
  const Real x12701 = x11958 * (x12131 * tau[2] + x12635 + x11955);
  const Real x12712 = x12701 - x11960 * x12703 - x11959 * x12706;
  w.x[800] = x12712;
  const Real x12717 = x11843 * x12706 + x11844 * x12703 + x11842 * x12712;
  const Real x12728 = x12717 - (x12112 * tau[2] + x12671 + x11952);
  w.result[6] = x12728;
  const Real x12722 = x11848 * x12706 + x11849 * x12703 + x11847 * x12712;
  const Real x12729 = x12722 - (x12119 * tau[2] + x12682 + x11953);
  w.result[7] = x12729;
  const Real x12727 = x11852 * x12706 + x11853 * x12703 + x11851 * x12712;
  const Real x12730 = x12727 - (x12126 * tau[2] + x12693 + x11954);
  w.result[8] = x12730;
  const Real x12750 = x107 * x12706 + x110 * x12703 + x104 * x12712;
  const Real x12755 = x114 * x12706 + x117 * x12703 + x111 * x12712;
  const Real x12760 = x119 * x12706 + x121 * x12703 + x118 * x12712;
  const Real x12735 = x107 * tau[7] + x110 * tau[8] + x104 * tau[6];
  const Real x12740 = x111 * tau[6] + x117 * tau[8] + x114 * tau[7];
  const Real x12745 = x118 * tau[6] + x119 * tau[7] + x121 * tau[8];
  const Real x12778 = tau[3] - (x12735 + 0.09 * x12760 + 0.04 * x12755);
  const Real x12779 = tau[4] - (x12740 - 0.04 * x12750);
  const Real x12780 = tau[5] - (x12745 - 0.09 * x12750);
  const Real x12781 = tau[0] - x12750;
  const Real x12782 = tau[1] - x12755;
  const Real x12783 = tau[2] - x12760;
  // joint 4 "right_hip": disassembly: its acceleration and force
  const Real x12794 = x9719 * x12781 + x9753 * x12782 + x9782 * x12783;
  const Real x12796 = x9684 * x12779 + x12794 + x9695 * x12780;
  const Real x12805 = x9804 * x12781 + x9807 * x12782 + x9810 * x12783;
  const Real x12807 = x9798 * x12779 + x12805 + x9801 * x12780;
  const Real x12816 = x9834 * x12781 + x9840 * x12782 + x9846 * x12783;
  const Real x12818 = x9822 * x12779 + x12816 + x9828 * x12780;
  const Real x12830 = x9707 * x12781 + x9739 * x12782 + x9769 * x12783;
  const Real x12832 = x9402 * x12779 + x12830 + x9403 * x12780;
  const Real x12841 = x9710 * x12781 + x9743 * x12782 + x9773 * x12783;
  const Real x12843 = x9409 * x12779 + x12841 + x9410 * x12780;
  const Real x12852 = x9713 * x12781 + x9747 * x12782 + x9777 * x12783;
  const Real x12854 = x9416 * x12779 + x12852 + x9417 * x12780;
  const Real x12864 = x9656 * (x9816 * x12778 + x12818 + x9667);
  w.x[798] = x12864;
  const Real x12863 = x9648 * (x9795 * x12778 + x12807 + x9661);
  const Real x12867 = x12863 - x9649 * x12864;
  w.x[796] = x12867;
  const Real x12862 = x9639 * (x9671 * x12778 + x12796 + x9634);
  const Real x12873 = x12862 - x9641 * x12864 - x9640 * x12867;
  w.x[772] = x12873;
  const Real x12878 = x9527 * x12867 + x9528 * x12864 + x9526 * x12873;
  const Real x12889 = x12878 - (x9399 * x12778 + x12832 + x9631);
  w.result[13] = x12889;
  const Real x12883 = x9532 * x12867 + x9533 * x12864 + x9531 * x12873;
  const Real x12890 = x12883 - (x9406 * x12778 + x12843 + x9632);
  w.result[14] = x12890;
  const Real x12888 = x9536 * x12867 + x9537 * x12864 + x9535 * x12873;
  const Real x12891 = x12888 - (x9413 * x12778 + x12854 + x9633);
  w.result[15] = x12891;
  const Real x12911 = x430 * x12867 + x433 * x12864 + x427 * x12873;
  const Real x12916 = x437 * x12867 + x440 * x12864 + x434 * x12873;
  const Real x12921 = x442 * x12867 + x444 * x12864 + x441 * x12873;
  const Real x12896 = x430 * tau[14] + x433 * tau[15] + x427 * tau[13];
  const Real x12901 = x434 * tau[13] + x440 * tau[15] + x437 * tau[14];
  const Real x12906 = x441 * tau[13] + x442 * tau[14] + x444 * tau[15];
  const Real x12940 = x12778 - (x12896 - 0.09 * x12921 + 0.04 * x12916);
  const Real x12941 = x12779 - (x12901 - 0.04 * x12911);
  const Real x12942 = x12780 - (x12906 + 0.09 * x12911);
  const Real x12943 = x12781 - x12911;
  const Real x12944 = x12782 - x12916;
  const Real x12945 = x12783 - x12921;
  // joint 7 "spine": disassembly: its acceleration and force
  const Real x12956 = x7543 * x12943 + x7549 * x12944 + x7349 * x12945;
  const Real x12965 = x7560 * x12943 + x7563 * x12944 + x7566 * x12945;
  const Real x12974 = x7584 * x12943 + x7590 * x12944 + x7596 * x12945;
  const Real x12987 = x7546 * x12944 - x7537 * x12943 + x7309 * x12941;
  const Real x12997 = x7547 * x12944 - x7539 * x12943 + x7312 * x12941;
  const Real x13007 = x7548 * x12944 - x7541 * x12943 + x7315 * x12941;
  const Real x12977 = x7534 * x12941 + x12956 - x7528 * x12940 + x7493;
  const Real x12978 = x7557 * x12941 + x12965 + x7554 * x12940 + x7521;
  const Real x12979 = x7578 * x12941 + x12974 + x7572 * x12940 + x7527;
  const Real x13018 = x7516 * x12979;
  const Real x13021 = x7508 * x12978 - x7509 * x13018;
  const Real x13027 = x7499 * x12977 - x7501 * x13018 - x7500 * x13021;
  const Real x13032 = x7390 * x13021 + x7391 * x13018 + x7389 * x13027;
  const Real x13010 = x7310 * x12942 + x12987 + x7308 * x12940 + x7490;
  const Real x13043 = x13032 - x13010;
  w.result[20] = x13043;
  const Real x13037 = x7395 * x13021 + x7396 * x13018 + x7394 * x13027;
  const Real x13012 = x7313 * x12942 + x12997 + x7311 * x12940 + x7491;
  const Real x13044 = x13037 - x13012;
  w.result[21] = x13044;
  const Real x13042 = x7399 * x13021 + x7400 * x13018 + x7398 * x13027;
  const Real x13014 = x7316 * x12942 + x13007 + x7314 * x12940 + x7492;
  const Real x13045 = x13042 - x13014;
  w.result[22] = x13045;
  // joint 8 "left_shoulder": disassembly: its acceleration and force
  const Real x13056 = x6692 * tau[20] + x6704 * tau[21] + x6716 * tau[22];
  const Real x13058 = x6822 * x13018 + x13056 + x6786 * x13021;
  const Real x13067 = x6835 * tau[20] + x6838 * tau[21] + x6841 * tau[22];
  const Real x13069 = x6850 * x13018 + x13067 + x6847 * x13021;
  const Real x13078 = x6856 * tau[20] + x6862 * tau[21] + x6868 * tau[22];
  const Real x13080 = x6886 * x13018 + x13078 + x6880 * x13021;
  const Real x13092 = x6384 * tau[20] + x6390 * tau[21] + x6396 * tau[22];
  const Real x13094 = x6803 * x13018 + x13092 + x6771 * x13021;
  const Real x13103 = x6401 * tau[20] + x6407 * tau[21] + x6413 * tau[22];
  const Real x13105 = x6810 * x13018 + x13103 + x6776 * x13021;
  const Real x13114 = x6418 * tau[20] + x6424 * tau[21] + x6430 * tau[22];
  const Real x13116 = x6817 * x13018 + x13114 + x6781 * x13021;
  const Real x13126 = x6677 * (x6874 * x13027 + x13080 + x6688);
  w.x[711] = x13126;
  const Real x13125 = x6669 * (x6844 * x13027 + x13069 + x6682);
  const Real x13129 = x13125 - x6670 * x13126;
  w.x[710] = x13129;
  const Real x13124 = x6660 * (x6753 * x13027 + x13058 + x6657);
  const Real x13135 = x13124 - x6662 * x13126 - x6661 * x13129;
  w.x[709] = x13135;
  const Real x13140 = x6540 * x13129 + x6541 * x13126 + x6539 * x13135;
  const Real x13151 = x13140 - (x6736 * x13027 + x13094 + x6654);
  w.result[23] = x13151;
  const Real x13145 = x6545 * x13129 + x6546 * x13126 + x6544 * x13135;
  const Real x13152 = x13145 - (x6742 * x13027 + x13105 + x6655);
  w.result[24] = x13152;
  const Real x13150 = x6549 * x13129 + x6550 * x13126 + x6548 * x13135;
  const Real x13153 = x13150 - (x6748 * x13027 + x13116 + x6656);
  w.result[25] = x13153;
  const Real x13173 = x855 * x13129 + x858 * x13126 + x852 * x13135;
  const Real x13178 = x862 * x13129 + x865 * x13126 + x859 * x13135;
  const Real x13183 = x867 * x13129 + x869 * x13126 + x866 * x13135;
  const Real x13158 = x855 * tau[24] + x858 * tau[25] + x852 * tau[23];
  const Real x13163 = x859 * tau[23] + x865 * tau[25] + x862 * tau[24];
  const Real x13168 = x866 * tau[23] + x867 * tau[24] + x869 * tau[25];
  const Real x13200 = tau[20] - (x13158 + 0.2 * x13183 - 0.42 * x13178);
  const Real x13201 = tau[21] - (x13163 + 0.42 * x13173);
  const Real x13202 = tau[22] - (x13168 - 0.2 * x13173);
  const Real x13203 = x13027 - x13173;
  const Real x13204 = x13021 - x13178;
  const Real x13205 = x13018 - x13183;
  // joint 11 "neck": disassembly: its acceleration and force
  const Real x13216 = x4497 * x13203 + x4527 * x13204 + x4226 * x13205;
  const Real x13218 = x4449 * x13201 + x13216 + x4463 * x13202;
  const Real x13227 = x4549 * x13203 + x4552 * x13204 + x4555 * x13205;
  const Real x13229 = x4543 * x13201 + x13227 + x4546 * x13202;
  const Real x13238 = x4579 * x13203 + x4585 * x13204 + x4591 * x13205;
  const Real x13240 = x4567 * x13201 + x13238 + x4573 * x13202;
  const Real x13252 = x4480 * x13203 + x4512 * x13204 + x4051 * x13205;
  const Real x13254 = x4141 * x13201 + x13252 + x4147 * x13202;
  const Real x13263 = x4486 * x13203 + x4517 * x13204 + x4068 * x13205;
  const Real x13265 = x4158 * x13201 + x13263 + x4164 * x13202;
  const Real x13274 = x4492 * x13203 + x4522 * x13204 + x4085 * x13205;
  const Real x13276 = x4175 * x13201 + x13274 + x4181 * x13202;
  const Real x13286 = x4421 * (x4561 * x13200 + x13240 + x4432);
  const Real x13285 = x4413 * (x4540 * x13200 + x13229 + x4426);
  const Real x13289 = x13285 - x4414 * x13286;
  const Real x13284 = x4404 * (x4436 * x13200 + x13218 + x4398);
  const Real x13295 = x13284 - x4406 * x13286 - x4405 * x13289;
  const Real x13300 = x4288 * x13289 + x4100 * x13286 + x4090 * x13295;
  const Real x13311 = x13300 - (x4135 * x13200 + x13254 + x4395);
  w.result[30] = x13311;
  const Real x13305 = x4110 * x13289 + x4291 * x13286 + x4290 * x13295;
  const Real x13312 = x13305 - (x4152 * x13200 + x13265 + x4396);
  w.result[31] = x13312;
  const Real x13310 = x4293 * x13289 + x4130 * x13286 + x4120 * x13295;
  const Real x13313 = x13310 - (x4169 * x13200 + x13276 + x4397);
  w.result[32] = x13313;
  const Real x13333 = x1194 * x13289 + x1197 * x13286 + x1191 * x13295;
  const Real x13338 = x1201 * x13289 + x1204 * x13286 + x1198 * x13295;
  const Real x13318 = x1194 * tau[31] + x1197 * tau[32] + x1191 * tau[30];
  const Real x13323 = x1198 * tau[30] + x1204 * tau[32] + x1201 * tau[31];
  const Real x13355 = x13200 - (x13318 - 0.48 * x13338);
  const Real x13356 = x13201 - (x13323 + 0.48 * x13333);
  const Real x13328 = x1205 * tau[30] + x1206 * tau[31] + x1208 * tau[32];
  const Real x13357 = x13202 - x13328;
  const Real x13358 = x13203 - x13333;
  const Real x13359 = x13204 - x13338;
  const Real x13343 = x1206 * x13289 + x1208 * x13286 + x1205 * x13295;
  const Real x13360 = x13205 - x13343;
  // joint 12 "right_shoulder": disassembly: its acceleration and force
  const Real x13374 = x3492 * x13357 - x3502 * x13358 - x3518 * x13359;
  const Real x13376 = x3532 * x13360 + x13374 - x3475 * x13355;
  const Real x13385 = x3543 * x13357 + x3546 * x13358 + x3549 * x13359;
  const Real x13387 = x3552 * x13360 + x13385 + x3537 * x13355;
  const Real x13396 = x3570 * x13357 + x3576 * x13358 + x3582 * x13359;
  const Real x13398 = x3588 * x13360 + x13396 + x3558 * x13355;
  const Real x13410 = x3227 * x13357 - x3495 * x13358 + x3510 * x13359;
  const Real x13420 = x3230 * x13357 - x3497 * x13358 + x3511 * x13359;
  const Real x13430 = x3233 * x13357 - x3499 * x13358 + x3512 * x13359;
  const Real x13441 = x3459 * (x3564 * x13356 + x13398 + x3470);
  const Real x13440 = x3451 * (x3540 * x13356 + x13387 + x3464);
  const Real x13444 = x13440 - x3452 * x13441;
  const Real x13439 = x3442 * (x3489 * x13356 + x13376 + x3437);
  const Real x13450 = x13439 - x3444 * x13441 - x3443 * x13444;
  const Real x13455 = x3319 * x13444 + x3320 * x13441 + x3318 * x13450;
  const Real x13433 = x3225 * x13355 + x13410 + x3226 * x13356 + x3434;
  const Real x13466 = x13455 - x13433;
  w.result[33] = x13466;
  const Real x13460 = x3324 * x13444 + x3325 * x13441 + x3323 * x13450;
  const Real x13435 = x3228 * x13355 + x13420 + x3229 * x13356 + x3435;
  const Real x13467 = x13460 - x13435;
  w.result[34] = x13467;
  const Real x13465 = x3328 * x13444 + x3329 * x13441 + x3327 * x13450;
  const Real x13437 = x3231 * x13355 + x13430 + x3232 * x13356 + x3436;
  const Real x13468 = x13465 - x13437;
  w.result[35] = x13468;
  // joint 13 "right_elbow": disassembly: its acceleration and force
  const Real x13492 = x2617 * tau[33] - x2426 * tau[34] + x2619 * tau[35];
  const Real x13494 = x2604 * x13441 + x13492 - x2621 * x13444;
  const Real x13506 = x2631 * tau[34] - x2627 * tau[33] - x2636 * tau[35];
  const Real x13508 = x13506 - x2648 * x13441 + x2645 * x13444;
  const Real x13519 = x2661 * tau[33] + x2666 * tau[34] - x2679 * tau[35];
  const Real x13521 = x13519 - x2702 * x13441 + x2697 * x13444;
  const Real x13475 = x2590 * tau[33] + x2592 * tau[35] - x2600 * x13444;
  const Real x13481 = x2609 * tau[33] + x2612 * tau[35] - x2615 * x13444;
  const Real x13537 = x2561 * (x2685 * x13450 + x13521 + x2589);
  w.x[708] = x13537;
  const Real x13536 = x2546 * (x2640 * x13450 + x13508 + x2577);
  const Real x13540 = x13536 + x2547 * x13537;
  w.x[707] = x13540;
  const Real x13535 = x2529 * (x13494 - x2596 * x13450 + x2571);
  const Real x13546 = x13535 - x2531 * x13537 - x2530 * x13540;
  const Real x13553 = x2515 * (x2568 + x13481) - x2519 * x13537;
  const Real x13555 = x13553 - x2518 * x13540 + x2516 * x13546;
  w.x[706] = x13555;
  const Real x13560 = x2505 * (x2484 + x13475) - x2508 * x13537;
  const Real x13561 = x2506 * x13555 + x13560;
  w.x[705] = x13561;
  const Real x13568 = x2453 * x13540 - x2219 * x13537 + x2452 * x13546;
  const Real x13531 = 74.76523715533226 * tau[34] + 10.467133201746517 * x13450 + x2497;
  const Real x13570 = x2157 * x13555 + x13568 - x13531;
  w.result[36] = x13570;
  // joint 14 "right_wrist": disassembly: its acceleration and force
  const Real x13584 = x1788 * tau[36] + x2072 * x13537 + x2060 * x13540;
  const Real x13587 = x1870 * x13546 - x13584 + x1786 * x13555;
  w.x[704] = x13587;
  const Real x13594 = x2083 * tau[36] + x2092 * x13537 + x2089 * x13540;
  const Real x13596 = x2086 * x13546 + x13594 + x2080 * x13555;
  w.x[703] = x13596;
  const Real x13597 = x2098 * x13555;
  w.x[702] = x13597;
  const Real x13599 = x2110 * x13546;
  w.x[701] = x13599;
  const Real x13600 = x2116 * x13540;
  w.x[700] = x13600;
  const Real x13602 = x2104 * tau[36] + x2122 * x13537;
  w.x[699] = x13602;
}

ADAGEN_NOINLINE void part_0_10(Workspace& w) {
  ADAGEN_INPUTS
  const Real x1798 = w.x[202];
  const Real x1806 = w.x[203];
  const Real x1814 = w.x[204];
  const Real x1818 = w.x[205];
  const Real x1822 = w.x[206];
  const Real x1826 = w.x[207];
  const Real x1830 = w.x[208];
  const Real x1831 = w.x[209];
  const Real x1832 = w.x[210];
  const Real x1833 = w.x[211];
  const Real x1834 = w.x[212];
  const Real x1835 = w.x[213];
  const Real x1836 = w.x[214];
  const Real x1837 = w.x[215];
  const Real x1838 = w.x[216];
  const Real x1839 = w.x[217];
  const Real x1910 = w.x[224];
  const Real x1912 = w.x[225];
  const Real x2014 = w.x[235];
  const Real x2015 = w.x[236];
  const Real x2016 = w.x[237];
  const Real x2017 = w.x[126];
  const Real x2023 = w.x[125];
  const Real x2024 = w.x[124];
  const Real x2025 = w.x[123];
  const Real x2032 = w.x[122];
  const Real x2033 = w.x[121];
  const Real x2040 = w.x[120];
  const Real x2046 = w.x[119];
  const Real x2052 = w.x[103];
  const Real x2056 = w.x[102];
  const Real x2057 = w.x[101];
  const Real x2058 = w.x[100];
  const Real x2066 = w.x[98];
  const Real x2068 = w.x[97];
  const Real x2070 = w.x[96];
  const Real x5000 = w.x[405];
  const Real x5002 = w.x[406];
  const Real x5012 = w.x[411];
  const Real x5020 = w.x[412];
  const Real x5028 = w.x[413];
  const Real x5032 = w.x[414];
  const Real x5036 = w.x[415];
  const Real x5040 = w.x[416];
  const Real x5044 = w.x[417];
  const Real x5045 = w.x[418];
  const Real x5046 = w.x[419];
  const Real x5047 = w.x[420];
  const Real x5048 = w.x[421];
  const Real x5049 = w.x[422];
  const Real x5050 = w.x[423];
  const Real x5051 = w.x[424];
  const Real x5052 = w.x[425];
  const Real x5053 = w.x[426];
  const Real x5084 = w.x[430];
  const Real x5124 = w.x[440];
  const Real x5126 = w.x[442];
  const Real x5228 = w.x[168];
  const Real x5229 = w.x[167];
  const Real x5230 = w.x[166];
  const Real x5231 = w.x[165];
  const Real x5234 = w.x[164];
  const Real x5235 = w.x[163];
  const Real x5236 = w.x[365];
  const Real x5243 = w.x[364];
  const Real x5244 = w.x[363];
  const Real x5251 = w.x[362];
  const Real x5256 = w.x[361];
  const Real x5262 = w.x[360];
  const Real x5266 = w.x[359];
  const Real x5267 = w.x[358];
  const Real x5268 = w.x[357];
  const Real x5269 = w.x[356];
  const Real x5275 = w.x[355];
  const Real x5277 = w.x[354];
  const Real x5279 = w.x[353];
  const Real x5281 = w.x[352];
  const Real x5289 = w.x[351];
  const Real x5292 = w.x[350];
  const Real x5295 = w.x[349];
  const Real x5298 = w.x[348];
  const Real x5301 = w.x[347];
  const Real x5307 = w.x[346];
  const Real x5313 = w.x[345];
  const Real x5319 = w.x[344];
  const Real x5325 = w.x[109];
  const Real x5331 = w.x[108];
  const Real x5366 = w.x[107];
  const Real x5428 = w.x[106];
  const Real x5609 = w.x[105];
  const Real x5632 = w.x[104];
  const Real x5633 = w.x[444];
  const Real x5664 = w.x[445];
  const Real x5677 = w.x[446];
  const Real x5681 = w.x[447];
  const Real x5682 = w.x[448];
  const Real x5684 = w.x[449];
  const Real x5691 = w.x[450];
  const Real x5692 = w.x[451];
  const Real x5694 = w.x[452];
  const Real x5695 = w.x[453];
  const Real x5705 = w.x[454];
  const Real x5706 = w.x[455];
  const Real x5707 = w.x[456];
  const Real x5722 = w.x[457];
  const Real x5723 = w.x[458];
  const Real x5737 = w.x[459];
  const Real x5744 = w.x[460];
  const Real x5747 = w.x[461];
  const Real x5753 = w.x[462];
  const Real x5765 = w.x[463];
  const Real x5766 = w.x[464];
  const Real x5768 = w.x[465];
  const Real x5771 = w.x[466];
  const Real x5775 = w.x[467];
  const Real x5779 = w.x[468];
  const Real x5784 = w.x[469];
  const Real x5787 = w.x[470];
  const Real x5790 = w.x[471];
  const Real x5792 = w.x[472];
  const Real x5794 = w.x[473];
  const Real x5796 = w.x[474];
  const Real x5802 = w.x[475];
  const Real x5806 = w.x[476];
  const Real x5811 = w.x[477];
  const Real x5815 = w.x[478];
  const Real x5820 = w.x[479];
  const Real x5823 = w.x[480];
  const Real x5836 = w.x[481];
  const Real x5841 = w.x[482];
  const Real x5854 = w.x[483];
  const Real x5860 = w.x[484];
  const Real x5872 = w.x[485];
  const Real x5877 = w.x[486];
  const Real x8016 = w.x[618];
  const Real x8018 = w.x[619];
  const Real x8028 = w.x[624];
  const Real x8036 = w.x[626];
  const Real x8044 = w.x[628];
  const Real x8052 = w.x[630];
  const Real x8060 = w.x[632];
  const Real x8061 = w.x[633];
  const Real x8062 = w.x[634];
  const Real x8063 = w.x[635];
  const Real x8064 = w.x[636];
  const Real x8065 = w.x[637];
  const Real x8066 = w.x[638];
  const Real x8067 = w.x[639];
  const Real x8068 = w.x[640];
  const Real x8069 = w.x[641];
  const Real x8100 = w.x[8];
  const Real x8140 = w.x[7];
  const Real x8142 = w.x[6];
  const Real x8143 = w.x[5];
  const Real x8145 = w.x[4];
  const Real x8247 = w.x[3];
  const Real x8248 = w.x[548];
  const Real x8249 = w.x[544];
  const Real x8250 = w.x[543];
  const Real x8256 = w.x[539];
  const Real x8257 = w.x[538];
  const Real x8258 = w.x[537];
  const Real x8265 = w.x[536];
  const Real x8266 = w.x[535];
  const Real x8273 = w.x[534];
  const Real x8278 = w.x[533];
  const Real x8284 = w.x[532];
  const Real x8288 = w.x[531];
  const Real x8289 = w.x[521];
  const Real x8290 = w.x[520];
  const Real x8292 = w.x[519];
  const Real x8298 = w.x[518];
  const Real x8300 = w.x[517];
  const Real x8302 = w.x[516];
  const Real x8304 = w.x[515];
  const Real x8312 = w.x[514];
  const Real x8315 = w.x[513];
  const Real x8318 = w.x[512];
  const Real x8321 = w.x[511];
  const Real x8324 = w.x[510];
  const Real x8330 = w.x[509];
  const Real x8336 = w.x[508];
  const Real x8342 = w.x[507];
  const Real x8348 = w.x[506];
  const Real x8354 = w.x[505];
  const Real x8389 = w.x[504];
  const Real x8451 = w.x[503];
  const Real x8658 = w.x[502];
  const Real x8684 = w.x[501];
  const Real x8685 = w.x[500];
  const Real x8716 = w.x[499];
  const Real x8729 = w.x[498];
  const Real x8737 = w.x[497];
  const Real x8738 = w.x[496];
  const Real x8740 = w.x[495];
  const Real x8747 = w.x[494];
  const Real x8748 = w.x[493];
  const Real x8750 = w.x[492];
  const Real x8751 = w.x[491];
  const Real x8761 = w.x[490];
  const Real x8762 = w.x[489];
  const Real x8763 = w.x[488];
  const Real x8778 = w.x[487];
  const Real x8779 = w.x[404];
  const Real x8793 = w.x[403];
  const Real x8800 = w.x[402];
  const Real x8803 = w.x[401];
  const Real x8809 = w.x[400];
  const Real x8821 = w.x[399];
  const Real x8822 = w.x[89];
  const Real x8824 = w.x[88];
  const Real x8828 = w.x[87];
  const Real x8832 = w.x[86];
  const Real x8836 = w.x[85];
  const Real x8841 = w.x[84];
  const Real x8844 = w.x[83];
  const Real x8847 = w.x[82];
  const Real x8849 = w.x[81];
  const Real x8851 = w.x[398];
  const Real x8853 = w.x[397];
  const Real x8859 = w.x[396];
  const Real x8863 = w.x[395];
  const Real x8868 = w.x[394];
  const Real x8872 = w.x[393];
  const Real x8877 = w.x[392];
  const Real x8880 = w.x[391];
  const Real x8893 = w.x[390];
  const Real x8898 = w.x[389];
  const Real x8911 = w.x[388];
  const Real x8917 = w.x[387];
  const Real x8929 = w.x[386];
  const Real x8934 = w.x[385];
  const Real x10289 = w.x[718];
  const Real x10291 = w.x[719];
  const Real x10301 = w.x[720];
  const Real x10309 = w.x[721];
  const Real x10317 = w.x[722];
  const Real x10325 = w.x[723];
  const Real x10333 = w.x[724];
  const Real x10334 = w.x[725];
  const Real x10335 = w.x[726];
  const Real x10336 = w.x[727];
  const Real x10337 = w.x[728];
  const Real x10338 = w.x[729];
  const Real x10339 = w.x[730];
  const Real x10340 = w.x[731];
  const Real x10341 = w.x[732];
  const Real x10342 = w.x[733];
  const Real x10373 = w.x[734];
  const Real x10413 = w.x[735];
  const Real x10415 = w.x[736];
  const Real x10416 = w.x[737];
  const Real x10418 = w.x[738];
  const Real x10520 = w.x[739];
  const Real x10521 = w.x[740];
  const Real x10522 = w.x[741];
  const Real x10523 = w.x[742];
  const Real x10526 = w.x[743];
  const Real x10527 = w.x[744];
  const Real x10528 = w.x[745];
  const Real x10535 = w.x[746];
  const Real x10536 = w.x[747];
  const Real x10543 = w.x[748];
  const Real x10548 = w.x[749];
  const Real x10554 = w.x[750];
  const Real x10558 = w.x[751];
  const Real x10559 = w.x[752];
  const Real x10560 = w.x[753];
  const Real x10561 = w.x[754];
  const Real x10567 = w.x[755];
  const Real x10569 = w.x[756];
  const Real x10571 = w.x[757];
  const Real x10573 = w.x[758];
  const Real x10581 = w.x[759];
  const Real x10584 = w.x[760];
  const Real x10587 = w.x[761];
  const Real x10590 = w.x[762];
  const Real x10593 = w.x[763];
  const Real x10599 = w.x[764];
  const Real x10605 = w.x[765];
  const Real x10611 = w.x[766];
  const Real x10617 = w.x[767];
  const Real x10623 = w.x[768];
  const Real x10658 = w.x[769];
  const Real x10720 = w.x[770];
  const Real x10901 = w.x[771];
  const Real x10924 = w.x[773];
  const Real x10925 = w.x[774];
  const Real x10956 = w.x[775];
  const Real x10969 = w.x[776];
  const Real x10973 = w.x[777];
  const Real x10974 = w.x[778];
  const Real x10976 = w.x[779];
  const Real x10983 = w.x[780];
  const Real x10984 = w.x[781];
  const Real x10986 = w.x[782];
  const Real x10987 = w.x[783];
  const Real x10997 = w.x[784];
  const Real x10998 = w.x[785];
  const Real x10999 = w.x[786];
  const Real x11014 = w.x[787];
  const Real x11015 = w.x[788];
  const Real x11029 = w.x[789];
  const Real x11036 = w.x[790];
  const Real x11039 = w.x[791];
  const Real x11045 = w.x[792];
  const Real x11057 = w.x[793];
  const Real x11058 = w.x[794];
  const Real x11060 = w.x[795];
  const Real x11063 = w.x[797];
  const Real x11067 = w.x[799];
  const Real x11071 = w.x[801];
  const Real x11076 = w.x[803];
  const Real x11079 = w.x[44];
  const Real x11082 = w.x[43];
  const Real x11084 = w.x[42];
  const Real x11086 = w.x[41];
  const Real x11088 = w.x[40];
  const Real x11094 = w.x[39];
  const Real x11098 = w.x[29];
  const Real x11103 = w.x[28];
  const Real x11107 = w.x[27];
  const Real x11112 = w.x[26];
  const Real x11115 = w.x[25];
  const Real x11128 = w.x[24];
  const Real x11133 = w.x[692];
  const Real x11146 = w.x[691];
  const Real x11152 = w.x[690];
  const Real x11164 = w.x[689];
  const Real x11169 = w.x[688];
  const Real x12703 = w.x[804];
  const Real x12706 = w.x[802];
  const Real x12712 = w.x[800];
  const Real x12864 = w.x[798];
  const Real x12867 = w.x[796];
  const Real x12873 = w.x[772];
  const Real x13126 = w.x[711];
  const Real x13129 = w.x[710];
  const Real x13135 = w.x[709];
  const Real x13537 = w.x[708];
  const Real x13540 = w.x[707];
  const Real x13555 = w.x[706];
  const Real x13561 = w.x[705];
  const Real x13587 = w.x[704];
  const Real x13596 = w.x[703];
  const Real x13597 = w.x[702];
  const Real x13599 = w.x[701];
  const Real x13600 = w.x[700];
  const Real x13602 = w.x[699];
  // joint 14 "right_wrist": disassembly: its acceleration and force
  const Real x13616 = x1833 * tau[36] - x2066 * x13537 + x2056 * x13540;
  const Real x13626 = x1836 * tau[36] - x2068 * x13537 + x2057 * x13540;
  const Real x13636 = x1839 * tau[36] - x2070 * x13537 + x2058 * x13540;
  const Real x13647 = x2040 * (x13600 + x13602 + x13599 + x13597 + x2052);
  const Real x13650 = x2032 * (x2046 + x13596) - x2033 * x13647;
  const Real x13655 = x2023 * (x2017 + x13587) - x2025 * x13647;
  const Real x13656 = x13655 - x2024 * x13650;
  const Real x13661 = x1910 * x13650 + x1806 * x13647 + x1798 * x13656;
  const Real x13639 = x1832 * x13555 + x13616 + x1831 * x13561 + x2014;
  const Real x13672 = x13661 - x13639;
  w.result[37] = x13672;
  const Real x13666 = x1814 * x13650 + x1818 * x13647 + x1912 * x13656;
  const Real x13641 = x1835 * x13555 + x13626 + x1834 * x13561 + x2015;
  const Real x13673 = x13666 - x13641;
  w.result[38] = x13673;
  const Real x13671 = x1826 * x13650 + x1830 * x13647 + x1822 * x13656;
  const Real x13643 = x1838 * x13555 + x13636 + x1837 * x13561 + x2016;
  const Real x13674 = x13671 - x13643;
  w.result[39] = x13674;
  // joint 9 "left_elbow": disassembly: its acceleration and force
  const Real x13698 = x5792 * tau[23] - x5609 * tau[24] + x5794 * tau[25];
  const Real x13700 = x5779 * x13126 + x13698 - x5796 * x13129;
  const Real x13712 = x5806 * tau[24] - x5802 * tau[23] - x5811 * tau[25];
  const Real x13714 = x13712 - x5823 * x13126 + x5820 * x13129;
  const Real x13725 = x5836 * tau[23] + x5841 * tau[24] - x5854 * tau[25];
  const Real x13727 = x13725 - x5877 * x13126 + x5872 * x13129;
  const Real x13681 = x5766 * tau[23] + x5768 * tau[25] - x5775 * x13129;
  const Real x13687 = x5784 * tau[23] + x5787 * tau[25] - x5790 * x13129;
  const Real x13743 = x5737 * (x5860 * x13135 + x13727 + x5765);
  const Real x13742 = x5722 * (x5815 * x13135 + x13714 + x5753);
  const Real x13746 = x13742 + x5723 * x13743;
  const Real x13741 = x5705 * (x13700 - x5771 * x13135 + x5747);
  const Real x13752 = x13741 - x5707 * x13743 - x5706 * x13746;
  const Real x13759 = x5691 * (x5744 + x13687) - x5695 * x13743;
  const Real x13761 = x13759 - x5694 * x13746 + x5692 * x13752;
  const Real x13766 = x5681 * (x5664 + x13681) - x5684 * x13743;
  const Real x13767 = x5682 * x13761 + x13766;
  const Real x13774 = x5633 * x13746 - x5428 * x13743 + x5632 * x13752;
  const Real x13737 = 74.76523715533226 * tau[24] + 10.467133201746517 * x13135 + x5677;
  const Real x13776 = x5366 * x13761 + x13774 - x13737;
  w.result[26] = x13776;
  // joint 10 "left_wrist": disassembly: its acceleration and force
  const Real x13790 = x5002 * tau[26] + x5281 * x13743 + x5269 * x13746;
  const Real x13800 = x5292 * tau[26] + x5301 * x13743 + x5298 * x13746;
  const Real x13809 = x5313 * tau[26] + x5331 * x13743 + x5325 * x13746;
  const Real x13822 = x5047 * tau[26] - x5275 * x13743 + x5266 * x13746;
  const Real x13832 = x5050 * tau[26] - x5277 * x13743 + x5267 * x13746;
  const Real x13842 = x5053 * tau[26] - x5279 * x13743 + x5268 * x13746;
  const Real x13812 = x5084 * x13752 - x13790 + x5000 * x13761 + x5231;
  const Real x13813 = x5295 * x13752 + x13800 + x5289 * x13761 + x5256;
  const Real x13814 = x5319 * x13752 + x13809 + x5307 * x13761 + x5262;
  const Real x13853 = x5251 * x13814;
  const Real x13856 = x5243 * x13813 - x5244 * x13853;
  const Real x13862 = x5234 * x13812 - x5236 * x13853 - x5235 * x13856;
  const Real x13867 = x5124 * x13856 + x5020 * x13853 + x5012 * x13862;
  const Real x13845 = x5046 * x13761 + x13822 + x5045 * x13767 + x5228;
  const Real x13878 = x13867 - x13845;
  w.result[27] = x13878;
  const Real x13872 = x5028 * x13856 + x5032 * x13853 + x5126 * x13862;
  const Real x13847 = x5049 * x13761 + x13832 + x5048 * x13767 + x5229;
  const Real x13879 = x13872 - x13847;
  w.result[28] = x13879;
  const Real x13877 = x5040 * x13856 + x5044 * x13853 + x5036 * x13862;
  const Real x13849 = x5052 * x13761 + x13842 + x5051 * x13767 + x5230;
  const Real x13880 = x13877 - x13849;
  w.result[29] = x13880;
  // joint 5 "right_knee": disassembly: its acceleration and force
  const Real x13904 = x8849 * tau[13] - x8658 * tau[14] + x8851 * tau[15];
  const Real x13906 = x8836 * x12864 + x13904 - x8853 * x12867;
  const Real x13918 = x8863 * tau[14] - x8859 * tau[13] - x8868 * tau[15];
  const Real x13920 = x13918 - x8880 * x12864 + x8877 * x12867;
  const Real x13931 = x8893 * tau[13] + x8898 * tau[14] - x8911 * tau[15];
  const Real x13933 = x13931 - x8934 * x12864 + x8929 * x12867;
  const Real x13887 = x8822 * tau[13] + x8824 * tau[15] - x8832 * x12867;
  const Real x13893 = x8841 * tau[13] + x8844 * tau[15] - x8847 * x12867;
  const Real x13949 = x8793 * (x8917 * x12873 + x13933 + x8821);
  const Real x13948 = x8778 * (x8872 * x12873 + x13920 + x8809);
  const Real x13952 = x13948 + x8779 * x13949;
  const Real x13947 = x8761 * (x13906 - x8828 * x12873 + x8803);
  const Real x13958 = x13947 - x8763 * x13949 - x8762 * x13952;
  const Real x13965 = x8747 * (x8800 + x13893) - x8751 * x13949;
  const Real x13967 = x13965 - x8750 * x13952 + x8748 * x13958;
  const Real x13972 = x8737 * (x8716 + x13887) - x8740 * x13949;
  const Real x13973 = x8738 * x13967 + x13972;
  const Real x13980 = x8685 * x13952 - x8451 * x13949 + x8684 * x13958;
  const Real x13943 = 7.971938775510204 * tau[14] + 1.5146683673469388 * x12873 + x8729;
  const Real x13982 = x8389 * x13967 + x13980 - x13943;
  w.result[16] = x13982;
  // joint 6 "right_ankle": disassembly: its acceleration and force
  const Real x13996 = x8018 * tau[16] + x8304 * x13949 + x8292 * x13952;
  const Real x14006 = x8315 * tau[16] + x8324 * x13949 + x8321 * x13952;
  const Real x14015 = x8336 * tau[16] + x8354 * x13949 + x8348 * x13952;
  const Real x14028 = x8063 * tau[16] - x8298 * x13949 + x8288 * x13952;
  const Real x14038 = x8066 * tau[16] - x8300 * x13949 + x8289 * x13952;
  const Real x14048 = x8069 * tau[16] - x8302 * x13949 + x8290 * x13952;
  const Real x14018 = x8100 * x13958 - x13996 + x8016 * x13967 + x8250;
  const Real x14019 = x8318 * x13958 + x14006 + x8312 * x13967 + x8278;
  const Real x14020 = x8342 * x13958 + x14015 + x8330 * x13967 + x8284;
  const Real x14059 = x8273 * x14020;
  const Real x14062 = x8265 * x14019 - x8266 * x14059;
  const Real x14068 = x8256 * x14018 - x8258 * x14059 - x8257 * x14062;
  const Real x14073 = x8140 * x14062 + x8036 * x14059 + x8028 * x14068;
  const Real x14051 = x8062 * x13967 + x14028 + x8061 * x13973 + x8247;
  const Real x14084 = x14073 - x14051;
  w.result[17] = x14084;
  const Real x14078 = x8044 * x14062 + x8143 * x14059 + x8142 * x14068;
  const Real x14053 = x8065 * x13967 + x14038 + x8064 * x13973 + x8248;
  const Real x14085 = x14078 - x14053;
  w.result[18] = x14085;
  const Real x14083 = x8145 * x14062 + x8060 * x14059 + x8052 * x14068;
  const Real x14055 = x8068 * x13967 + x14048 + x8067 * x13973 + x8249;
  const Real x14086 = x14083 - x14055;
  w.result[19] = x14086;
  // joint 2 "left_knee": disassembly: its acceleration and force
  const Real x14110 = x11084 * tau[6] - x10901 * tau[7] + x11086 * tau[8];
  const Real x14112 = x11071 * x12703 + x14110 - x11088 * x12706;
  const Real x14124 = x11098 * tau[7] - x11094 * tau[6] - x11103 * tau[8];
  const Real x14126 = x14124 - x11115 * x12703 + x11112 * x12706;
  const Real x14137 = x11128 * tau[6] + x11133 * tau[7] - x11146 * tau[8];
  const Real x14139 = x14137 - x11169 * x12703 + x11164 * x12706;
  const Real x14093 = x11058 * tau[6] + x11060 * tau[8] - x11067 * x12706;
  const Real x14099 = x11076 * tau[6] + x11079 * tau[8] - x11082 * x12706;
  const Real x14155 = x11029 * (x11152 * x12712 + x14139 + x11057);
  const Real x14154 = x11014 * (x11107 * x12712 + x14126 + x11045);
  const Real x14158 = x14154 + x11015 * x14155;
  const Real x14153 = x10997 * (x14112 - x11063 * x12712 + x11039);
  const Real x14164 = x14153 - x10999 * x14155 - x10998 * x14158;
  const Real x14171 = x10983 * (x11036 + x14099) - x10987 * x14155;
  const Real x14173 = x14171 - x10986 * x14158 + x10984 * x14164;
  const Real x14178 = x10973 * (x10956 + x14093) - x10976 * x14155;
  const Real x14179 = x10974 * x14173 + x14178;
  const Real x14186 = x10925 * x14158 - x10720 * x14155 + x10924 * x14164;
  const Real x14149 = 7.971938775510204 * tau[7] + 1.5146683673469388 * x12712 + x10969;
  const Real x14188 = x10658 * x14173 + x14186 - x14149;
  w.result[9] = x14188;
  // joint 3 "left_ankle": disassembly: its acceleration and force
  const Real x14202 = x10291 * tau[9] + x10573 * x14155 + x10561 * x14158;
  const Real x14212 = x10584 * tau[9] + x10593 * x14155 + x10590 * x14158;
  const Real x14221 = x10605 * tau[9] + x10623 * x14155 + x10617 * x14158;
  const Real x14234 = x10336 * tau[9] - x10567 * x14155 + x10558 * x14158;
  const Real x14244 = x10339 * tau[9] - x10569 * x14155 + x10559 * x14158;
  const Real x14254 = x10342 * tau[9] - x10571 * x14155 + x10560 * x14158;
  const Real x14224 = x10373 * x14164 - x14202 + x10289 * x14173 + x10523;
  const Real x14225 = x10587 * x14164 + x14212 + x10581 * x14173 + x10548;
  const Real x14226 = x10611 * x14164 + x14221 + x10599 * x14173 + x10554;
  const Real x14265 = x10543 * x14226;
  const Real x14268 = x10535 * x14225 - x10536 * x14265;
  const Real x14274 = x10526 * x14224 - x10528 * x14265 - x10527 * x14268;
  const Real x14279 = x10413 * x14268 + x10309 * x14265 + x10301 * x14274;
  const Real x14257 = x10335 * x14173 + x14234 + x10334 * x14179 + x10520;
  const Real x14290 = x14279 - x14257;
  w.result[10] = x14290;
  const Real x14284 = x10317 * x14268 + x10416 * x14265 + x10415 * x14274;
  const Real x14259 = x10338 * x14173 + x14244 + x10337 * x14179 + x10521;
  const Real x14291 = x14284 - x14259;
  w.result[11] = x14291;
  const Real x14289 = x10418 * x14268 + x10333 * x14265 + x10325 * x14274;
  const Real x14261 = x10341 * x14173 + x14254 + x10340 * x14179 + x10522;
  const Real x14292 = x14289 - x14261;
  w.result[12] = x14292;
}

// ---- 5. processes -------------------------------------------------------------------------------

// Process 0: 15 of 15 joints: "root", "left_hip", "left_knee", "left_ankle", "right_hip", "right_knee", ...
constexpr std::array<int, 15> kRead_0{0, 1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12, 13, 14};
constexpr std::array<int, 15> kOwned_0{0, 1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12, 13, 14};

void run_0([[maybe_unused]] Workspace& w, [[maybe_unused]] Channel& channel) {
  ADAGEN_INPUTS
  stamp(0);
  if (!all(unlike_zero(q + 0, 3) == 0))
    name_what_is_not_finite(w, kRead_0, kOwned_0);
  w.angle[0] = q[11];
  w.angle[1] = q[20];
  w.angle[2] = q[33];
  w.angle[3] = q[46];
  take_sines_and_cosines<4>(w.angle.data(), w.sine.data(), w.cosine.data());
  part_0_0(w);
  part_0_1(w);
  part_0_2(w);
  part_0_3(w);
  part_0_4(w);
  part_0_5(w);
  part_0_6(w);
  part_0_7(w);
  part_0_8(w);
  part_0_9(w);
  part_0_10(w);
  stamp(1);
  stamp(2);
  stamp(3);
  if (__builtin_expect(w.status != kFine || !all(unlike_zero(w.result.data() + 0, 40) == 0), 0)) {
    // The state's own faults are named before all others.
    const int found = std::exchange(w.status, kFine);
    name_what_is_not_finite(w, kRead_0, kOwned_0);
    Channel::fail(w.status, found);
    name_what_overflows(w, kOwned_0);
  }
  if (w.status != kFine) return;
  std::copy_n(w.result.data() + 0, 40, w.qdd + 0);
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

struct human40_p1_solver : Solver {};

extern "C" {

int human40_p1_joint(int k, const char** name, int* q, int* nq, int* v, int* nv) {
  if (k < 0 || k >= kJointCount) return 0;
  const JointConstants& joint = kJoints[k];
  *name = joint.name, *q = joint.q, *nq = joint.nq, *v = joint.v, *nv = joint.nv;
  return 1;
}

human40_p1_solver* human40_p1_open(MPI_Comm comm, const char* channel, double time_limit) {
  int size = 0;
  MPI_Comm_size(comm, &size);
  const std::string kind = channel;
  if (size != kProcesses || (kind != "auto" && kind != "window" && kind != "message")) return nullptr;
  auto* const solver = new human40_p1_solver;
  const ChannelMode mode = kind == "window"    ? ChannelMode::kWindow
                           : kind == "message" ? ChannelMode::kMessage
                                               : ChannelMode::kAuto;
  if (solver->channel.open(comm, mode, time_limit).empty()) return solver;
  human40_p1_close(solver);
  return nullptr;
}

int human40_p1_solve(human40_p1_solver* solver, const double* q, const double* v, const double* tau, double* qdd) {
  return solver->solve(q, v, tau, qdd);
}

int human40_p1_solve_at_root(human40_p1_solver* solver, const double* q, const double* v, const double* tau, double* qdd) {
  return solver->solve_at_root(q, v, tau, qdd);
}

const char* human40_p1_failure(const human40_p1_solver* solver) { return solver->text.c_str(); }

void human40_p1_close(human40_p1_solver* solver) {
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
constexpr std::array<Stage, 3> kStages_0{ {
    {"kinematics", 14, -1},
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
