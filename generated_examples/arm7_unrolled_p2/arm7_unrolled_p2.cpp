// Forward dynamics of "arm7" on 2 processes, emitted by adagen 0.1.0 (solver.cpp.j2). Do not edit: emit anew.
//
// robot     "arm7", 9 joints, 9 degrees of freedom, description sha256 35a799ae72b600eeca178cc12eccff22927d06b6ca76bda0ede3ef5832ebda29
// options   form ada, shape unrolled, scalar double, channel auto, fixed base, gravity 0.0, 0.0, -9.81
// program   2 processes, joined at cuts; 0.661 us predicted (default profile)
//           process 0: base_yaw .. forearm_roll
//           process 1: wrist_pitch .. right_finger_slide
// schedule  forearm_roll@0-1(elbow_pitch@0(upper_arm_roll(shoulder_pitch(base_yaw|)|)|) | wrist_pitch@1(|flange_roll(|left_finger_slide(right_finger_slide|))))
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
typedef struct arm7_unrolled_p2_solver arm7_unrolled_p2_solver;

// Joints in order, each with its place in the state: arm7_unrolled_p2_joint gives name, start and size in q
// and v of joint k, or returns 0 where there is none.
int arm7_unrolled_p2_joint(int k, const char** name, int* q, int* nq, int* v, int* nv);

// Collective over a communicator of 2 processes. channel: "auto", "window" or "message";
// time_limit: seconds that a process waits for another. Returns null where it cannot be done.
arm7_unrolled_p2_solver* arm7_unrolled_p2_open(MPI_Comm comm, const char* channel, double time_limit);

// One evaluation, collective. q: 9 numbers, v and tau: 9 each, qdd: 9; joints in order,
// quaternions x y z w (normalised here), floating joints [linear; angular] in the body's frame.
// solve: every process passes the state and gets its own joints' accelerations (others untouched);
// solve_at_root: process 0 passes the state and gets them all, the others may pass null.
// Returns 0, or what arm7_unrolled_p2_failure puts into words; no acceleration is written then.
int arm7_unrolled_p2_solve(arm7_unrolled_p2_solver* solver, const double* q, const double* v, const double* tau, double* qdd);
int arm7_unrolled_p2_solve_at_root(arm7_unrolled_p2_solver* solver, const double* q, const double* v, const double* tau, double* qdd);

// The last failure in words; valid until the next call.
const char* arm7_unrolled_p2_failure(const arm7_unrolled_p2_solver* solver);

// Collective.
void arm7_unrolled_p2_close(arm7_unrolled_p2_solver* solver);
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
constexpr int kJointCount = 9, kLinkCount = kJointCount + 1;
constexpr int kNq = 9, kNv = 9;
constexpr int kOuterCount = 0, kNtau = kNv + 6 * kOuterCount;
[[maybe_unused]] constexpr int kColumns = 1;  // right-hand sides: the motion, and one per slaved joint
[[maybe_unused]] constexpr bool kBatch = false;  // whether many states are solved at once
[[maybe_unused]] constexpr int kRefine = 0;  // steps of iterative refinement
[[maybe_unused]] constexpr int kPlanMessages = 2;
constexpr std::size_t kCacheLine = 64;
[[maybe_unused]] constexpr bool kFloatingBase = false;
[[maybe_unused]] constexpr double kTolerance = 1e-09;
[[maybe_unused]] constexpr int kRandomStates = 64;
[[maybe_unused]] constexpr const char* kRobot = "arm7";
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
     {60.93845216331505, 0.0, 0.0, 0.0, 60.93845216331505, 0.0, 0.0, 0.0, 113.37868480725623}},
    {"upper_arm", 3.1, {0.0, -0.1, 0.0},
     {0.01767, 0.0, 0.0, 0.0, 0.00558, 0.0, 0.0, 0.0, 0.01767},
     {56.59309564233163, 0.0, 0.0, 0.0, 179.2114695340502, 0.0, 0.0, 0.0, 56.59309564233163}},
    {"elbow_housing", 2.6, {0.0, 0.0, -0.03},
     {0.00898625, 0.0, 0.0, 0.0, 0.00898625, 0.0, 0.0, 0.0, 0.0039325},
     {111.2811239393518, 0.0, 0.0, 0.0, 111.2811239393518, 0.0, 0.0, 0.0, 254.29116338207245}},
    {"forearm", 2.2, {-0.05, 0.1, 0.0},
     {0.0102483, 0.0, 0.0, 0.0, 0.00275, 0.0, 0.0, 0.0, 0.0102483},
     {97.57715913858884, 0.0, 0.0, 0.0, 363.6363636363637, 0.0, 0.0, 0.0, 97.57715913858884}},
    {"wrist_housing", 1.7, {0.0, 0.01, -0.08},
     {0.00448729, 0.0, 0.0, 0.0, 0.00448729, 0.0, 0.0, 0.0, 0.00172125},
     {222.85165433925602, 0.0, 0.0, 0.0, 222.85165433925602, 0.0, 0.0, 0.0, 580.9731299927379}},
    {"wrist", 1.3, {0.04, 0.01, 0.0},
     {0.0013, 0.0, 0.0, 0.0, 0.0013, 0.0, 0.0, 0.0, 0.0013},
     {769.2307692307693, 0.0, 0.0, 0.0, 769.2307692307693, 0.0, 0.0, 0.0, 769.2307692307693}},
    {"hand", 0.85, {0.008470588235294117, 0.0, 0.08870588235294118},
     {0.0034019064705882356, 0.0, 0.0004946823529411765, 0.0, 0.0014865882352941176, 0.0, 0.0004946823529411765, 0.0, 0.0031133417647058823},
     {300.9051975855012, 0.0, -47.81116318204386, 0.0, 672.6812282367838, 0.0, -47.81116318204386, 0.0, 328.7950427750268}},
    {"left_finger", 0.05, {0.03, 0.0, 0.01},
     {3.33333e-06, 0.0, 0.0, 0.0, 1.66667e-05, 0.0, 0.0, 0.0, 1.66667e-05},
     {300000.3000003, 0.0, 0.0, 0.0, 59999.880000239995, 0.0, 0.0, 0.0, 59999.880000239995}},
    {"right_finger", 0.05, {0.03, 0.0, 0.01},
     {3.33333e-06, 0.0, 0.0, 0.0, 1.66667e-05, 0.0, 0.0, 0.0, 1.66667e-05},
     {300000.3000003, 0.0, 0.0, 0.0, 59999.880000239995, 0.0, 0.0, 0.0, 59999.880000239995}},
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
    {1, 0, 42},  // 0: assembled: chain of "wrist_pitch"
    {0, 1, 6},  // 1: forces on: chain of "wrist_pitch"
    {0, 1, 22},  // 2: state
    {1, 0, 4},  // 3: accelerations
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
  alignas(kCacheLine) std::array<Value, 7> angle{}, sine{}, cosine{};
  std::array<Value, kNv> result{};
  std::array<Real*, kPlanMessages> to{};          // messages to be sent
  std::array<const Real*, kPlanMessages> from{};  // messages received
  alignas(kCacheLine) std::array<Value, 294> x{};
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
// Process 0: 1061 products, 824 sums, 18 quotients
// =================================================================================================

ADAGEN_NOINLINE void part_0_0(Workspace& w) {
  ADAGEN_INPUTS
  // joint 1 "shoulder_pitch": placement, velocity and reference acceleration of its link
  const Real x20 = v[0] * 0.9999999999932537;
  const Real x29 = v[1] - v[0] * 3.673205103346574e-06;
  const Real x27 = cosine[1] * x20;
  const Real x25 = sine[1] * x20;
  const Real x37 = sine[1] * 9.809999999933819;
  const Real x30 = v[1] * x27;
  const Real x59 = x27 * x29;
  const Real x32 = v[1] * x25;
  const Real x55 = x25 * x27;
  const Real x62 = x30 + x59;
  // joint 2 "upper_arm_roll": placement, velocity and reference acceleration of its link
  const Real x95 = 3.673205103346574e-06 * x32;
  const Real x80 = 3.673205103346574e-06 * x27 + 0.9999999999932537 * x29;
  const Real x120 = (x25 * x25 + x29 * x29) * 0.3;
  const Real x122 = x120 - cosine[1] * 9.809999999933819;
  const Real x125 = -3.603414206382989e-05 + x62 * 0.3;
  const Real x93 = x25 * sine[2] + cosine[2] * x80;
  const Real x89 = sine[2] * x80 - x25 * cosine[2];
  const Real x94 = 0.9999999999932537 * x27 - 3.673205103346574e-06 * x29 + v[2];
  const Real x118 = x37 + x55 * 0.3;
  const Real x129 = 0.9999999999932537 * x125 - 3.673205103346574e-06 * x122;
  // joint 0 "base_yaw": assembly: its two sides become one chain
  const Real x399 = 113.37868480725623 * tau[0];
  w.x[0] = x399;
  // link 2 "upper_arm": acceleration where nothing acts on it
  const Real x469 = x32 * 0.00558 * 179.2114695340502;
  const Real x443 = x55 * 0.04309 + x37 * 0.31000000000000005;
  const Real x449 = x37 * 3.1 + x55 * 0.31000000000000005;
  const Real x459 = -0.00011170584039787267 + x62 * 0.31000000000000005;
  const Real x440 = 1.1170584039787268e-05 - (x30 * 0.048670000000000005 + x59 * 0.04309);
  const Real x479 = x443 * 5.659309564233164 - x449 * 0.8885116015846066;
  const Real x468 = x440 * 56.59309564233163 + x459 * 5.659309564233164;
  const Real x483 = x440 * 5.659309564233164 + x459 * 0.8885116015846066;
  // joint 1 "shoulder_pitch": assembly: its two sides become one chain
  const Real x528 = 5.659309564233164 * tau[1];
  const Real x527 = tau[1] * 56.59309564386139;
  w.x[1] = x527;
  const Real x514 = 0.9999999999932537 * x399;
  const Real x516 = 3.673205103346574e-06 * x399;
  w.x[2] = x516;
  const Real x504 = cosine[1] * 113.37868480572648;
  const Real x501 = sine[1] * 0.0004164631636419267;
  w.x[3] = x501;
  const Real x502 = cosine[1] * 0.0004164631636419267;
  w.x[4] = x502;
  const Real x508 = cosine[1] * x504;
  const Real x506 = sine[1] * x504;
  const Real x512 = 179.2114695340502 + x508;
  w.x[5] = x512;
  require_more(w, x512, 2.8880270885273612e-12, kGrowth, 1);
  const Real x511 = 113.37868480572648 - x508 + 56.59309564233163;
  require_more(w, x511, 1.1455151917378305e-12, kGrowth, 1);
  require_more(w, x511, 0.0, kFactorization, 1);
  const Real x538 = 1 / x511;
  w.x[6] = x538;
  const Real x533 = x479 + x528;
  w.x[7] = x533;
  const Real x539 = x506 * x538;
  w.x[8] = x539;
  const Real x540 = 5.659309564233164 * x538;
  w.x[9] = x540;
  const Real x579 = 56.59309564233163 * x538;
  // joint 3 "elbow_pitch": assembly: its two sides become one chain
  const Real x2111 = 97.57715913858884 * tau[3];
  w.x[10] = x2111;
  const Real x2112 = 9.757715913858885 * tau[3];
  w.x[11] = x2112;
  const Real x2113 = 4.878857956929442 * tau[3];
  w.x[12] = x2113;
  const Real x1533 = 2.0 * sine[3];
  // joint 2 "upper_arm_roll": placement, velocity and reference acceleration of its link
  const Real x111 = v[2] * x93 - (x30 * cosine[2] + sine[2] * x95);
  const Real x157 = x93 * x94;
  const Real x114 = x30 * sine[2] - cosine[2] * x95 - v[2] * x89;
  const Real x143 = sine[2] * x118 + cosine[2] * x129;
  const Real x162 = x89 * x94;
  const Real x139 = sine[2] * x129 - cosine[2] * x118;
  const Real x148 = x93 * x93;
  const Real x134 = 0.9999999999932537 * x122 + 3.673205103346574e-06 * x125;
  const Real x97 = 0.9999999999932537 * x32;
  // link 2 "upper_arm": acceleration where nothing acts on it
  const Real x474 = x449 * 5.659309564233164 - x443 * 56.59309564233163;
  w.x[13] = x474;
  // joint 1 "shoulder_pitch": assembly: its two sides become one chain
  const Real x544 = 5.659309564233164 * x539;
  w.x[14] = x544;
  const Real x569 = 56.59309564233163 * x539;
  w.x[15] = x569;
  const Real x530 = x468 - sine[1] * x514 - tau[1] * x501;
  w.x[16] = x530;
  const Real x543 = x512 - x506 * x539;
  w.x[17] = x543;
  const Real x563 = x530 * x540;
  const Real x546 = 1 / x543;
  w.x[18] = x546;
  const Real x531 = x469 - cosine[1] * x514 - tau[1] * x502;
  const Real x562 = x531 - x530 * x539;
  w.x[19] = x562;
  const Real x641 = 56.59309564233163 * tau[1] - x533 * 6.369426751592357 - x474;
  w.x[20] = x641;
  const Real x547 = x544 * x546;
  w.x[21] = x547;
  const Real x582 = 179.2114695340502 * x546;
  const Real x580 = x546 * x569;
  const Real x577 = 179.2114695340502 * x547;
  w.x[22] = x577;
  const Real x565 = x547 * x562;
  const Real x556 = 0.8885116015846066 - 5.659309564233164 * x540 - x544 * x547;
  w.x[23] = x556;
  require_more(w, x556, 1.5783136603612864e-15, kFactorization, 1);
  const Real x576 = 5.659309564233164 - 56.59309564233163 * x540 - x547 * x569;
  w.x[24] = x576;
  const Real x568 = x483 - x563 + x565;
  w.x[25] = x568;
  const Real x557 = 1 / x556;
  w.x[26] = x557;
  // link 3 "elbow_housing": acceleration where nothing acts on it
  const Real x679 = x143 * 2.6 - (x157 - x111) * 0.078;
  const Real x668 = x111 * 0.01132625 - x157 * 0.007393749999999999 + x143 * 0.078;
  const Real x671 = x114 * 0.01132625 + x162 * 0.007393749999999999 - x139 * 0.078;
  const Real x675 = x139 * 2.6 - (x114 + x162) * 0.078;
  const Real x694 = x668 * 111.2811239393518 - x679 * 3.338433718180554;
  const Real x697 = x671 * 111.2811239393518 + x675 * 3.338433718180554;
  // joint 2 "upper_arm_roll": assembly: its two sides become one chain
  const Real x831 = x533 - x528 - x479 + 0.3 * x641;
  // joint 3 "elbow_pitch": placement, velocity and reference acceleration of its link
  const Real x174 = 0.9999999999932537 * x94 - 3.673205103346574e-06 * x93;
  const Real x193 = 3.673205103346574e-06 * x114 + 0.9999999999932537 * x97;
  const Real x188 = v[3] - (0.9999999999932537 * x93 + 3.673205103346574e-06 * x94);
  const Real x183 = x89 * cosine[3] + sine[3] * x174;
  const Real x187 = cosine[3] * x174 - x89 * sine[3];
  const Real x220 = x143 + (x89 * x93 - x97) * 0.08;
  // joint 1 "shoulder_pitch": assembly: its two sides become one chain
  const Real x585 = x557 * x577;
  const Real x584 = x557 * x576;
  const Real x586 = x556 * x557;
  const Real x609 = 179.2114695340502 - 179.2114695340502 * x582 - x577 * x585;
  w.x[27] = x609;
  const Real x594 = 56.59309564233163 - 56.59309564233163 * x579 - x569 * x580;
  const Real x595 = x594 - x576 * x584;
  const Real x600 = x569 * x582 - x576 * x585;
  const Real x603 = x576 - x576 * x586;
  const Real x640 = x562 * x582 + x568 * x585 - x469;
  w.x[28] = x640;
  const Real x627 = x530 * x579 - x562 * x580 + x568 * x584;
  const Real x639 = x627 - x468;
  // link 3 "elbow_housing": acceleration where nothing acts on it
  const Real x702 = x671 * 3.338433718180554 + x675 * 0.4847683961608012;
  const Real x706 = x679 * 0.4847683961608012 - x668 * 3.338433718180554;
  const Real x684 = (x89 * x89 + x148) * 0.078 - x134 * 2.6;
  const Real x707 = x684 * 0.3846153846153846;
  // joint 2 "upper_arm_roll": assembly: its two sides become one chain
  const Real x769 = 3.673205103346574e-06 * x600;
  const Real x771 = 0.9999999999932537 * x600;
  const Real x774 = 3.673205103346574e-06 * (x609 - 20.546537908362435);
  const Real x716 = x603 - 0.3 * x595;
  const Real x719 = x577 - x577 * x586 - 0.3 * x600;
  const Real x779 = 3.673205103346574e-06 * x774;
  w.x[29] = x779;
  const Real x730 = 0.9999999999932537 * x716;
  const Real x733 = 0.9999999999932537 * x719;
  const Real x731 = 3.673205103346574e-06 * x716;
  const Real x777 = 0.9999999999932537 * x774;
  const Real x838 = 0.9999999999932537 * x641 - 3.673205103346574e-06 * x640;
  // joint 1 "shoulder_pitch": assembly: its two sides become one chain
  const Real x643 = x563 - x565 + x568 * x586 - x483;
  // joint 2 "upper_arm_roll": assembly: its two sides become one chain
  const Real x834 = x643 - 0.3 * x639;
  const Real x781 = 20.546537908362435 + x779;
  const Real x726 = x556 - x556 * x586 - 0.3 * x603;
  const Real x727 = x726 - 0.3 * x716;
  const Real x737 = 3.673205103346574e-06 * x733;
  w.x[30] = x737;
  const Real x734 = 0.9999999999932537 * x733;
  const Real x804 = 3.673205103346574e-06 * x727;
  const Real x735 = x719 - x734;
  // joint 3 "elbow_pitch": placement, velocity and reference acceleration of its link
  const Real x222 = (x162 - x114) * 0.08 - x134;
  const Real x211 = x111 * cosine[3] - sine[3] * x193 + v[3] * x187;
  const Real x214 = x111 * sine[3] + cosine[3] * x193 + v[3] * x183;
  const Real x246 = x188 * x188;
  const Real x254 = x187 * x188;
  const Real x259 = x183 * x188;
  const Real x199 = 3.673205103346574e-06 * x97 - 0.9999999999932537 * x114;
  const Real x218 = x139 - (x148 + x94 * x94) * 0.08;
  const Real x226 = 0.9999999999932537 * x222 - 3.673205103346574e-06 * x220;
  const Real x231 = 0.9999999999932537 * x220 + 3.673205103346574e-06 * x222;
  const Real x249 = x183 * x187;
  const Real x247 = x187 * x187 + x246;
  const Real x252 = x183 * x183 + x246;
  const Real x260 = x214 + x259;
  // link 3 "elbow_housing": acceleration where nothing acts on it
  const Real x698 = x97 * 0.0039325 * 254.29116338207245;
  w.x[31] = x698;
  // joint 2 "upper_arm_roll": assembly: its two sides become one chain
  const Real x852 = 0.9999999999932537 * x834;
  const Real x786 = sine[2] * x777 - cosine[2] * x771;
  w.x[32] = x786;
  const Real x808 = 3.673205103346574e-06 * x804;
  const Real x806 = 0.9999999999932537 * x804;
  const Real x762 = cosine[2] * x737 + sine[2] * (6.1639613724671465 + x730);
  const Real x790 = sine[2] * x771 + cosine[2] * x777;
  w.x[33] = x790;
  const Real x796 = cosine[2] * (x595 - x781) - x769 * (2.0 * sine[2]);
  const Real x810 = x727 - x808;
  const Real x763 = sine[2] * x762;
  const Real x766 = cosine[2] * x762;
  const Real x742 = sine[2] * x735 - cosine[2] * x731;
  const Real x829 = 0.3846153846153846 + x808;
  w.x[34] = x829;
  require_more(w, x829, 1.0049860034323996e-14, kGrowth, 2);
  const Real x800 = cosine[2] * x796;
  const Real x767 = x766 - x737;
  const Real x752 = cosine[2] * 2.264149437033022e-05 + sine[2] * x734;
  w.x[35] = x752;
  const Real x798 = x769 + sine[2] * x796;
  const Real x816 = cosine[2] * (1.849188411752619 - x810);
  const Real x823 = x730 - x763 + -3.338433718180554;
  const Real x862 = cosine[2] * x639 + sine[2] * x838 + x694;
  const Real x876 = x862 - tau[2] * x786;
  w.x[36] = x876;
  const Real x758 = sine[2] * 2.264149437033022e-05 - cosine[2] * x734;
  w.x[37] = x758;
  const Real x822 = x781 + x800 + 111.2811239393518;
  require_more(w, x822, 1.9286837244164575e-12, kGrowth, 2);
  require_more(w, x822, 0.0, kFactorization, 2);
  const Real x824 = x595 - x800 + 111.2811239393518;
  w.x[38] = x824;
  require_more(w, x824, 1.9286837244164575e-12, kGrowth, 2);
  const Real x819 = cosine[2] * x816;
  const Real x863 = cosine[2] * x838 - sine[2] * x639 + x697;
  const Real x886 = 1 / x822;
  w.x[39] = x886;
  const Real x866 = cosine[2] * x831 + sine[2] * x852 + x702;
  const Real x867 = cosine[2] * x852 - sine[2] * x831 + x706;
  const Real x827 = x810 + x819 + 0.4847683961608012;
  w.x[40] = x827;
  require_more(w, x827, 1.1473119930685861e-14, kGrowth, 2);
  const Real x828 = 1.849188411752619 - x819 + 0.4847683961608012;
  w.x[41] = x828;
  require_more(w, x828, 1.1473119930685861e-14, kGrowth, 2);
  const Real x887 = x798 * x886;
  w.x[42] = x887;
  const Real x889 = x767 * x886;
  w.x[43] = x889;
  const Real x890 = x823 * x886;
  w.x[44] = x890;
  const Real x891 = x742 * x886;
  w.x[45] = x891;
  const Real x1095 = 111.2811239393518 * x886;
  const Real x1096 = 3.338433718180554 * x886;
  // joint 3 "elbow_pitch": placement, velocity and reference acceleration of its link
  const Real x256 = x211 + x254;
  // joint 2 "upper_arm_roll": assembly: its two sides become one chain
  const Real x894 = x824 - x798 * x887;
  w.x[46] = x894;
  const Real x897 = 6.1639613724671465 - x763 + 3.338433718180554 + x767 * x887;
  const Real x900 = x823 * x887 - x766;
  const Real x903 = sine[2] * x731 + cosine[2] * x735 + x742 * x887;
  const Real x904 = 1 / x894;
  w.x[47] = x904;
  const Real x1006 = 111.2811239393518 * x887;
  w.x[48] = x1006;
  const Real x1008 = 3.338433718180554 * x887;
  w.x[49] = x1008;
  const Real x978 = x863 - tau[2] * x790 + x876 * x887;
  w.x[50] = x978;
  const Real x882 = x707 - 3.673205103346574e-06 * x834 - tau[2] * x737;
  const Real x1293 = x698 + 254.29116338207245 * tau[2];
  w.x[51] = x1293;
  const Real x905 = x897 * x904;
  w.x[52] = x905;
  const Real x906 = x900 * x904;
  w.x[53] = x906;
  const Real x907 = x903 * x904;
  w.x[54] = x907;
  const Real x1099 = 111.2811239393518 * x904;
  const Real x1098 = x904 * x1006;
  const Real x1101 = x904 * x1008;
  const Real x1100 = 3.338433718180554 * x904;
  const Real x913 = x827 - x767 * x889 - x897 * x905;
  w.x[55] = x913;
  const Real x920 = sine[2] * x816 + x823 * x889 + x900 * x905;
  const Real x928 = sine[2] * x806 + x742 * x889 + x903 * x905;
  const Real x1018 = 3.338433718180554 - 111.2811239393518 * x905;
  w.x[56] = x1018;
  const Real x1014 = 111.2811239393518 * x889 + x905 * x1006;
  w.x[57] = x1014;
  const Real x930 = 1 / x913;
  w.x[58] = x930;
  const Real x1026 = 3.338433718180554 * x889 + x905 * x1008;
  w.x[59] = x1026;
  // joint 3 "elbow_pitch": placement, velocity and reference acceleration of its link
  const Real x235 = cosine[3] * x218 + sine[3] * x226;
  // joint 2 "upper_arm_roll": assembly: its two sides become one chain
  const Real x1021 = 0.4847683961608012 - 3.338433718180554 * x905;
  w.x[60] = x1021;
  const Real x931 = x920 * x930;
  w.x[61] = x931;
  const Real x933 = x928 * x930;
  w.x[62] = x933;
  const Real x1105 = x930 * x1018;
  const Real x1103 = x930 * x1014;
  const Real x1107 = x930 * x1026;
  const Real x1106 = x930 * x1021;
  const Real x983 = x866 + tau[2] * x752 - x876 * x889;
  const Real x984 = x983 - x905 * x978;
  w.x[63] = x984;
  const Real x991 = x867 - tau[2] * x758 - x876 * x890;
  const Real x942 = x828 - x823 * x890 - x900 * x906;
  const Real x943 = x942 - x920 * x931;
  w.x[64] = x943;
  const Real x952 = cosine[2] * x806 + x742 * x890 + x903 * x906;
  const Real x954 = x928 * x931 + x952;
  const Real x968 = x829 - x742 * x891 - x903 * x907;
  const Real x1040 = x931 * x1018 - 111.2811239393518 * x906;
  w.x[65] = x1040;
  const Real x1034 = -3.338433718180554 - 111.2811239393518 * x890 - x906 * x1006;
  const Real x1035 = x1034 - x931 * x1014;
  w.x[66] = x1035;
  const Real x1128 = 111.2811239393518 - 111.2811239393518 * x1095 - x1006 * x1098;
  const Real x956 = 1 / x943;
  w.x[67] = x956;
  const Real x1053 = 0.4847683961608012 + 3.338433718180554 * x890 + x906 * x1008;
  const Real x1054 = x931 * x1026 + x1053;
  w.x[68] = x1054;
  const Real x1045 = x931 * x1021 - 3.338433718180554 * x906;
  w.x[69] = x1045;
  const Real x1244 = 0.4847683961608012 - 3.338433718180554 * x1096 - x1008 * x1101;
  const Real x1165 = -3.338433718180554 + 111.2811239393518 * x1096 + x1006 * x1101;
  const Real x993 = x991 - x906 * x978 + x931 * x984;
  w.x[70] = x993;
  const Real x1003 = x882 - x876 * x891 - x907 * x978;
  const Real x957 = x954 * x956;
  w.x[71] = x957;
  const Real x1109 = x956 * x1040;
  const Real x1108 = x956 * x1035;
  const Real x1111 = x956 * x1054;
  const Real x1110 = x956 * x1045;
  // joint 3 "elbow_pitch": placement, velocity and reference acceleration of its link
  const Real x239 = cosine[3] * x226 - sine[3] * x218;
  // joint 2 "upper_arm_roll": assembly: its two sides become one chain
  const Real x970 = x968 - x928 * x933 - x954 * x957;
  w.x[72] = x970;
  const Real x1075 = x933 * x1018 - 111.2811239393518 * x907 + x957 * x1040;
  w.x[73] = x1075;
  const Real x1180 = 111.2811239393518 - 111.2811239393518 * x1099 - x1018 * x1105;
  const Real x1065 = 111.2811239393518 * x891 + x907 * x1006 + x933 * x1014;
  const Real x1067 = x957 * x1035 - x1065;
  w.x[74] = x1067;
  const Real x1093 = 3.338433718180554 * x891 + x907 * x1008 + x933 * x1026;
  const Real x1094 = x957 * x1054 + x1093;
  w.x[75] = x1094;
  const Real x1083 = x933 * x1021 - 3.338433718180554 * x907 + x957 * x1045;
  w.x[76] = x1083;
  const Real x971 = 1 / x970;
  w.x[77] = x971;
  const Real x1192 = 3.338433718180554 - 111.2811239393518 * x1100 - x1018 * x1106;
  const Real x1217 = 0.4847683961608012 - 3.338433718180554 * x1100 - x1021 * x1106;
  const Real x1005 = x933 * x984 + x1003 + x957 * x993;
  w.x[78] = x1005;
  const Real x1287 = x984 * x1107 - (x876 * x1096 + x978 * x1101);
  const Real x1261 = x876 * x1095 + x978 * x1098 - x984 * x1103;
  const Real x1113 = x971 * x1075;
  const Real x1112 = x971 * x1067;
  const Real x1116 = 0.3846153846153846 * x971;
  const Real x1115 = x971 * x1094;
  const Real x1114 = x971 * x1083;
  const Real x1206 = x1075 * x1116;
  const Real x1182 = x1180 - x1040 * x1109 - x1075 * x1113;
  w.x[79] = x1182;
  const Real x1130 = x1128 - x1014 * x1103 - x1035 * x1108;
  const Real x1131 = x1130 - x1067 * x1112;
  const Real x1141 = x1014 * x1105 - x1006 * x1099 - x1035 * x1109;
  const Real x1142 = x1141 - x1067 * x1113;
  const Real x1204 = 111.2811239393518 * x1101 - x1018 * x1107 - x1040 * x1111;
  const Real x1205 = x1204 - x1075 * x1115;
  const Real x1246 = x1244 - x1026 * x1107 - x1054 * x1111;
  const Real x1167 = x1014 * x1107 + x1165 - x1035 * x1111;
  const Real x1168 = x1167 - x1067 * x1115;
  const Real x1194 = x1192 - x1040 * x1110 - x1075 * x1114;
  const Real x1152 = x1014 * x1106 - x1006 * x1100 - x1035 * x1110;
  const Real x1153 = x1152 - x1067 * x1114;
  // link 4 "forearm": acceleration where nothing acts on it
  const Real x1338 = x199 * 0.037748300000000005 - x249 * 0.023998300000000004;
  const Real x1320 = x211 * 0.03224830000000001 + x254 * 0.029498300000000005 - x260 * 0.011000000000000003;
  const Real x1342 = x1320 - x231 * 0.22000000000000003;
  // joint 3 "elbow_pitch": assembly: its two sides become one chain
  const Real x1510 = 3.673205103346574e-06 * x1142;
  const Real x1439 = x1246 - x1094 * x1115 + 1.6274634456452637;
  const Real x1515 = 3.673205103346574e-06 * (x1182 - 254.29116338207245);
  // joint 2 "upper_arm_roll": assembly: its two sides become one chain
  const Real x1229 = 3.338433718180554 * x1101 - x1021 * x1107 - x1045 * x1111;
  const Real x1230 = x1229 - x1083 * x1115;
  const Real x1219 = x1217 - x1045 * x1110 - x1083 * x1114;
  const Real x1269 = x978 * x1099 + x984 * x1105 + x993 * x1109;
  const Real x1292 = x1005 * x1113 + x1269 - x697;
  w.x[80] = x1292;
  const Real x1291 = x993 * x1108 + x1261 + x1005 * x1112 - x694;
  const Real x1276 = x978 * x1100 + x984 * x1106 + x993 * x1110;
  // link 4 "forearm": acceleration where nothing acts on it
  const Real x1373 = x256 * 0.22000000000000003 - (x231 * 2.2 + x260 * 0.11000000000000001);
  const Real x1330 = x256 * 0.011000000000000003 - (x214 * 0.00825 + x259 * 0.005500000000000001);
  const Real x1345 = x1330 - x231 * 0.11000000000000001;
  const Real x1356 = x247 * 0.11000000000000001 + (x249 - x199) * 0.22000000000000003;
  const Real x1357 = x235 * 2.2 + x1356;
  w.x[81] = x1357;
  const Real x1363 = (x199 + x249) * 0.11000000000000001 + x252 * 0.22000000000000003;
  const Real x1365 = x239 * 2.2 - x1363;
  w.x[82] = x1365;
  // joint 3 "elbow_pitch": assembly: its two sides become one chain
  const Real x1429 = x1206 + 0.08 * x1182;
  const Real x1425 = x1067 * x1116 + 0.08 * x1142;
  const Real x1442 = x1094 * x1116 + 0.08 * x1205;
  const Real x1450 = 3.673205103346574e-06 * x1194;
  const Real x1519 = 3.673205103346574e-06 * x1515;
  w.x[83] = x1519;
  const Real x1435 = x1083 * x1116 + 0.08 * x1194;
  const Real x1521 = 254.29116338207245 + x1519;
  const Real x1448 = 0.3846153846153846 - 0.3846153846153846 * x1116 + 0.08 * x1206;
  const Real x1449 = 0.08 * x1429 + x1448;
  const Real x1458 = 3.673205103346574e-06 * x1168 + 0.9999999999932537 * x1425;
  const Real x1464 = 3.673205103346574e-06 * x1425 - 0.9999999999932537 * x1168;
  const Real x1469 = 0.9999999999932537 * (20.343293070565796 - x1429) - 3.673205103346574e-06 * x1205;
  const Real x1547 = 3.673205103346574e-06 * x1230 + 0.9999999999932537 * x1435;
  const Real x1553 = 3.673205103346574e-06 * x1435 - 0.9999999999932537 * x1230;
  const Real x1474 = 3.673205103346574e-06 * x1469;
  const Real x1470 = 0.9999999999932537 * x1469;
  const Real x1536 = cosine[3] * (x1131 - x1521) - x1510 * x1533;
  const Real x1559 = 3.673205103346574e-06 * (x1439 - x1449) + 1.9999999999865075 * x1442;
  const Real x1471 = x1429 + x1470;
  const Real x1512 = 0.9999999999932537 * x1142;
  const Real x1517 = 0.9999999999932537 * x1515;
  // joint 2 "upper_arm_roll": assembly: its two sides become one chain
  const Real x1295 = x993 * x1111 + x1287 + x1005 * x1115 - x706;
  // joint 3 "elbow_pitch": assembly: its two sides become one chain
  const Real x1599 = x1295 + 0.08 * x1293;
  const Real x1540 = cosine[3] * x1536;
  const Real x1564 = 3.673205103346574e-06 * x1559;
  const Real x1602 = x1005 * x1116 - x707 - 0.08 * x1292;
  const Real x1606 = 0.9999999999932537 * x1293 - 3.673205103346574e-06 * x1292;
  const Real x1538 = x1510 + sine[3] * x1536;
  const Real x1566 = x1449 + x1564;
  const Real x1501 = cosine[3] * (x1153 + x1474) - sine[3] * (x1450 + x1458);
  const Real x1563 = 0.9999999999932537 * x1559 - x1442;
  const Real x1586 = x1521 + x1540 + 97.57715913858884;
  require_more(w, x1586, 2.0354041913285566e-12, kGrowth, 3);
  require_more(w, x1586, 0.0, kFactorization, 3);
  const Real x1588 = x1131 - x1540 + 363.6363636363637;
  w.x[84] = x1588;
  require_more(w, x1588, 5.816332892088654e-12, kGrowth, 3);
  const Real x1507 = cosine[3] * x1501;
  const Real x1502 = sine[3] * x1501;
  const Real x1587 = cosine[3] * x1464 - sine[3] * x1471 + -9.757715913858885;
  const Real x1660 = 1 / x1586;
  w.x[85] = x1660;
  // joint 2 "upper_arm_roll": assembly: its two sides become one chain
  const Real x1294 = x1005 * x1114 + x1276 - x702;
  // link 4 "forearm": acceleration where nothing acts on it
  const Real x1350 = 0.011000000000000003 * (x252 - x247) + x1338 - x239 * 0.11000000000000001;
  const Real x1351 = x1350 - x235 * 0.22000000000000003;
  w.x[86] = x1351;
  const Real x1387 = x1342 * 97.57715913858884 - x1373 * 9.757715913858885;
  w.x[87] = x1387;
  const Real x1392 = x1345 * 363.6363636363637 - x1373 * 18.181818181818183;
  w.x[88] = x1392;
  const Real x1402 = x1357 * 1.430317045931343 + x1365 * 0.48788579569294427 + x1351 * 9.757715913858885;
  w.x[89] = x1402;
  const Real x1407 = x1357 * 0.48788579569294427 + x1365 * 0.6984883523919266 + x1351 * 4.878857956929442;
  w.x[90] = x1407;
  // joint 3 "elbow_pitch": assembly: its two sides become one chain
  const Real x1508 = x1507 - x1474;
  const Real x1503 = x1458 + x1502;
  const Real x1452 = 0.9999999999932537 * x1194;
  const Real x1473 = 20.343293070565796 - x1470;
  const Real x1579 = cosine[3] * (x1219 - x1566) - x1533 * x1547;
  const Real x1583 = cosine[3] * x1579;
  const Real x1526 = sine[3] * x1517 - cosine[3] * x1512;
  w.x[91] = x1526;
  const Real x1661 = x1538 * x1660;
  w.x[92] = x1661;
  const Real x1663 = x1508 * x1660;
  w.x[93] = x1663;
  const Real x1664 = x1503 * x1660;
  w.x[94] = x1664;
  const Real x1623 = 0.9999999999932537 * x1602 - 3.673205103346574e-06 * x1599;
  const Real x1666 = x1587 * x1660;
  w.x[95] = x1666;
  const Real x1593 = x1566 + x1583 + 1.430317045931343;
  w.x[96] = x1593;
  require_more(w, x1593, 2.5791741088407997e-14, kGrowth, 3);
  const Real x1595 = x1219 - x1583 + 0.6984883523919266;
  w.x[97] = x1595;
  require_more(w, x1595, 1.5391829848103258e-14, kGrowth, 3);
  const Real x1669 = x1588 - x1538 * x1661;
  w.x[98] = x1669;
  const Real x1672 = x1508 * x1661 - (x1450 + x1502);
  const Real x1675 = x1153 - x1507 - x1503 * x1661;
  const Real x1589 = -18.181818181818183 - (sine[3] * x1464 + cosine[3] * x1471);
  const Real x1678 = x1589 + x1587 * x1661;
  const Real x1679 = 1 / x1669;
  w.x[99] = x1679;
  const Real x1530 = sine[3] * x1512 + cosine[3] * x1517;
  w.x[100] = x1530;
  const Real x1596 = x1439 - x1564 + 2.3394079550222524;
  w.x[101] = x1596;
  require_more(w, x1596, 3.871069992040982e-14, kGrowth, 3);
  const Real x1591 = sine[3] * x1473 - cosine[3] * x1452 + 9.757715913858885;
  w.x[102] = x1591;
  const Real x1637 = cosine[3] * x1291 + sine[3] * x1606 + x1387;
  const Real x1649 = x1637 - tau[3] * x1526;
  w.x[103] = x1649;
  const Real x1592 = sine[3] * x1452 + cosine[3] * x1473 + 4.878857956929442;
  w.x[104] = x1592;
  // link 4 "forearm": acceleration where nothing acts on it
  const Real x1415 = x1373 * 2.3394079550222524 - (x1342 * 9.757715913858885 + x1345 * 18.181818181818183);
  w.x[105] = x1415;
  // joint 3 "elbow_pitch": assembly: its two sides become one chain
  const Real x1680 = x1672 * x1679;
  w.x[106] = x1680;
  const Real x1681 = x1675 * x1679;
  w.x[107] = x1681;
  const Real x1682 = x1678 * x1679;
  w.x[108] = x1682;
  const Real x1638 = cosine[3] * x1606 - sine[3] * x1291 + x1392;
  const Real x1476 = x1205 + x1474;
  w.x[109] = x1476;
  const Real x1640 = cosine[3] * x1294 + sine[3] * x1623 + x1402;
  const Real x1743 = x1638 - tau[3] * x1530 + x1649 * x1661;
  w.x[110] = x1743;
  const Real x1771 = 97.57715913858884 * x1661;
  w.x[111] = x1771;
  const Real x1688 = x1593 - x1508 * x1663 - x1672 * x1680;
  w.x[112] = x1688;
  const Real x1693 = 0.48788579569294427 - (x1547 + sine[3] * x1579) + x1503 * x1663;
  const Real x1694 = x1693 - x1675 * x1680;
  const Real x1699 = cosine[3] * x1553 + sine[3] * x1563 - x1587 * x1663;
  const Real x1700 = x1699 - x1678 * x1680;
  const Real x1719 = cosine[3] * x1563 - sine[3] * x1553 + x1587 * x1664;
  const Real x1775 = -18.181818181818183 - 9.757715913858885 * x1661;
  w.x[113] = x1775;
  const Real x1641 = cosine[3] * x1623 - sine[3] * x1294 + x1407;
  const Real x1701 = 1 / x1688;
  w.x[114] = x1701;
  const Real x1642 = x1415 - (0.9999999999932537 * x1599 + 3.673205103346574e-06 * x1602);
  const Real x1782 = 363.6363636363637 * x1680;
  w.x[115] = x1782;
  const Real x1748 = x1640 - tau[3] * x1591 - x1649 * x1663;
  const Real x1749 = x1748 - x1680 * x1743;
  w.x[116] = x1749;
  const Real x1780 = 97.57715913858884 * x1663 + x1680 * x1771;
  w.x[117] = x1780;
  const Real x1788 = 9.757715913858885 * x1663 - x1680 * x1775;
  w.x[118] = x1788;
  const Real x1797 = 363.6363636363637 * x1681;
  w.x[119] = x1797;
  const Real x1756 = x1641 - tau[3] * x1592 + x1649 * x1664;
  const Real x1757 = x1756 - x1681 * x1743;
  w.x[120] = x1757;
  const Real x1795 = 97.57715913858884 * x1664 - x1681 * x1771;
  w.x[121] = x1795;
  const Real x1817 = 9.757715913858885 * x1664 + x1681 * x1775;
  w.x[122] = x1817;
  const Real x1872 = 97.57715913858884 * x1660;
  w.x[123] = x1872;
  const Real x1767 = x1642 - tau[3] * x1476 - x1649 * x1666;
  const Real x1768 = x1767 - x1682 * x1743;
  w.x[124] = x1768;
  const Real x1873 = 9.757715913858885 * x1660;
  w.x[125] = x1873;
  const Real x1875 = x1679 * x1771;
  w.x[126] = x1875;
  const Real x1702 = x1694 * x1701;
  w.x[127] = x1702;
  const Real x1703 = x1700 * x1701;
  w.x[128] = x1703;
  const Real x1839 = -18.181818181818183 - 363.6363636363637 * x1682;
  w.x[129] = x1839;
  const Real x1877 = x1679 * x1775;
  w.x[130] = x1877;
  const Real x1876 = 363.6363636363637 * x1679;
  w.x[131] = x1876;
  const Real x1830 = -9.757715913858885 - 97.57715913858884 * x1666 - x1682 * x1771;
  w.x[132] = x1830;
  const Real x1869 = 2.3394079550222524 + 9.757715913858885 * x1666 - x1682 * x1775;
  w.x[133] = x1869;
  const Real x1878 = x1701 * x1780;
  w.x[134] = x1878;
  const Real x1880 = x1701 * x1782;
  w.x[135] = x1880;
  const Real x1882 = 9.757715913858885 * x1701;
  w.x[136] = x1882;
  const Real x1883 = 1.430317045931343 * x1701;
  w.x[137] = x1883;
  const Real x1754 = x1702 * x1749;
  w.x[138] = x1754;
  const Real x1793 = x1702 * x1780;
  w.x[139] = x1793;
  const Real x1799 = x1702 * x1782;
  w.x[140] = x1799;
  const Real x1815 = x1702 * x1788;
  w.x[141] = x1815;
  const Real x1763 = x1703 * x1749;
  w.x[142] = x1763;
  const Real x1711 = x1595 - x1503 * x1664 - x1675 * x1681;
  const Real x1712 = x1711 - x1694 * x1702;
  w.x[143] = x1712;
  const Real x1721 = x1719 - x1678 * x1681 - x1700 * x1702;
  w.x[144] = x1721;
  const Real x1733 = x1596 - x1587 * x1666 - x1678 * x1682;
  const Real x1734 = x1733 - x1700 * x1703;
  w.x[145] = x1734;
  const Real x1804 = 4.878857956929442 - 9.757715913858885 * x1702;
  w.x[146] = x1804;
  const Real x1807 = 0.48788579569294427 - 1.430317045931343 * x1702;
  w.x[147] = x1807;
  const Real x1810 = 0.6984883523919266 - 0.48788579569294427 * x1702;
  w.x[148] = x1810;
}

ADAGEN_NOINLINE void part_0_1(Workspace& w) {
  ADAGEN_INPUTS
  const Real x474 = w.x[13];
  const Real x512 = w.x[5];
  const Real x516 = w.x[2];
  const Real x527 = w.x[1];
  const Real x543 = w.x[17];
  const Real x609 = w.x[27];
  const Real x640 = w.x[28];
  const Real x641 = w.x[20];
  const Real x698 = w.x[31];
  const Real x779 = w.x[29];
  const Real x824 = w.x[38];
  const Real x827 = w.x[40];
  const Real x828 = w.x[41];
  const Real x829 = w.x[34];
  const Real x894 = w.x[46];
  const Real x913 = w.x[55];
  const Real x943 = w.x[64];
  const Real x970 = w.x[72];
  const Real x1182 = w.x[79];
  const Real x1292 = w.x[80];
  const Real x1293 = w.x[51];
  const Real x1351 = w.x[86];
  const Real x1357 = w.x[81];
  const Real x1365 = w.x[82];
  const Real x1387 = w.x[87];
  const Real x1392 = w.x[88];
  const Real x1402 = w.x[89];
  const Real x1407 = w.x[90];
  const Real x1415 = w.x[105];
  const Real x1519 = w.x[83];
  const Real x1588 = w.x[84];
  const Real x1593 = w.x[96];
  const Real x1595 = w.x[97];
  const Real x1596 = w.x[101];
  const Real x1649 = w.x[103];
  const Real x1669 = w.x[98];
  const Real x1688 = w.x[112];
  const Real x1701 = w.x[114];
  const Real x1703 = w.x[128];
  const Real x1712 = w.x[143];
  const Real x1721 = w.x[144];
  const Real x1734 = w.x[145];
  const Real x1743 = w.x[110];
  const Real x1749 = w.x[116];
  const Real x1754 = w.x[138];
  const Real x1757 = w.x[120];
  const Real x1763 = w.x[142];
  const Real x1768 = w.x[124];
  const Real x1771 = w.x[111];
  const Real x1775 = w.x[113];
  const Real x1780 = w.x[117];
  const Real x1782 = w.x[115];
  const Real x1788 = w.x[118];
  const Real x1793 = w.x[139];
  const Real x1795 = w.x[121];
  const Real x1797 = w.x[119];
  const Real x1799 = w.x[140];
  const Real x1804 = w.x[146];
  const Real x1807 = w.x[147];
  const Real x1810 = w.x[148];
  const Real x1815 = w.x[141];
  const Real x1817 = w.x[122];
  const Real x1830 = w.x[132];
  const Real x1839 = w.x[129];
  const Real x1869 = w.x[133];
  const Real x1872 = w.x[123];
  const Real x1873 = w.x[125];
  const Real x1875 = w.x[126];
  const Real x1876 = w.x[131];
  const Real x1877 = w.x[130];
  const Real x1878 = w.x[134];
  const Real x1880 = w.x[135];
  const Real x1882 = w.x[136];
  const Real x1883 = w.x[137];
  const Real x2111 = w.x[10];
  const Real x2112 = w.x[11];
  const Real x2113 = w.x[12];
  // joint 3 "elbow_pitch": assembly: its two sides become one chain
  const Real x1758 = x1757 - x1754;
  w.x[149] = x1758;
  const Real x1796 = x1793 + x1795;
  w.x[150] = x1796;
  const Real x1801 = x1799 - x1797;
  w.x[151] = x1801;
  const Real x1819 = x1815 + x1817;
  w.x[152] = x1819;
  const Real x1722 = 1 / x1712;
  w.x[153] = x1722;
  const Real x1884 = 0.48788579569294427 * x1701;
  const Real x1885 = x1701 * x1788;
  const Real x1723 = x1721 * x1722;
  w.x[154] = x1723;
  const Real x1888 = x1722 * x1804;
  const Real x1889 = x1722 * x1807;
  const Real x1890 = x1722 * x1810;
  const Real x1886 = x1722 * x1796;
  const Real x1887 = x1722 * x1801;
  const Real x1891 = x1722 * x1819;
  const Real x1735 = x1734 - x1721 * x1723;
  const Real x1846 = 9.757715913858885 * x1703 + x1723 * x1804;
  w.x[155] = x1846;
  const Real x1852 = 1.430317045931343 * x1703 + x1723 * x1807;
  w.x[156] = x1852;
  const Real x1858 = 0.48788579569294427 * x1703 + x1723 * x1810;
  w.x[157] = x1858;
  const Real x1770 = x1768 - x1763 - x1723 * x1758;
  w.x[158] = x1770;
  const Real x1832 = x1703 * x1780 + x1830 - x1723 * x1796;
  w.x[159] = x1832;
  const Real x1841 = x1703 * x1782 + x1839 - x1723 * x1801;
  w.x[160] = x1841;
  const Real x1871 = x1869 - x1703 * x1788 + x1723 * x1819;
  w.x[161] = x1871;
  const Real x1736 = 1 / x1735;
  w.x[162] = x1736;
  // link 4 "forearm": acceleration where nothing acts on it
  const Real x1397 = x1357 * 9.757715913858885 + x1365 * 4.878857956929442 + x1351 * 97.57715913858884;
  // joint 3 "elbow_pitch": assembly: its two sides become one chain
  const Real x1895 = x1736 * x1846;
  const Real x1897 = x1736 * x1852;
  const Real x1899 = x1736 * x1858;
  const Real x1893 = x1736 * x1832;
  const Real x1894 = x1736 * x1841;
  const Real x1901 = x1736 * x1871;
  const Real x1913 = 97.57715913858884 - 97.57715913858884 * x1872 - x1771 * x1875;
  const Real x1966 = -9.757715913858885 + 97.57715913858884 * x1873 - x1771 * x1877;
  const Real x2107 = 2.3394079550222524 - 9.757715913858885 * x1873 - x1775 * x1877;
  const Real x2121 = x1649 * x1872 + x1743 * x1875 - x1749 * x1878;
  const Real x2158 = x1743 * x1877 - x1649 * x1873 + x1749 * x1885;
  const Real x1979 = 363.6363636363637 - 363.6363636363637 * x1876 - x1782 * x1880;
  const Real x2015 = -18.181818181818183 - 363.6363636363637 * x1877 + x1782 * x1885;
  // joint 1 "shoulder_pitch": assembly: its two sides become one chain
  const Real x532 = x474 - x516 - x527;
  w.x[163] = x532;
  const Real x558 = 1.7763568394002505e-15 * x512;
  require_more(w, x543, x558, kFactorization, 1);
  // joint 2 "upper_arm_roll": assembly: its two sides become one chain
  const Real x864 = 0.9999999999932537 * x640 + 3.673205103346574e-06 * x641 + x698;
  const Real x878 = x864 + tau[2] * (x609 - x779 + 254.29116338207245);
  w.x[164] = x878;
  const Real x972 = 1.7763568394002505e-15 * x824;
  require_more(w, x894, x972, kFactorization, 2);
  const Real x973 = 1.7763568394002505e-15 * x827;
  require_more(w, x913, x973, kFactorization, 2);
  const Real x974 = 1.7763568394002505e-15 * x828;
  require_more(w, x943, x974, kFactorization, 2);
  const Real x975 = 1.7763568394002505e-15 * x829;
  require_more(w, x970, x975, kFactorization, 2);
  // joint 3 "elbow_pitch": assembly: its two sides become one chain
  const Real x2130 = x1743 * x1876 - x1749 * x1880 + x1758 * x1887;
  const Real x2137 = x1749 * x1882 + x1758 * x1888 - x1770 * x1895;
  const Real x2143 = x1749 * x1883 + x1758 * x1889 - x1770 * x1897;
  const Real x2149 = x1749 * x1884 + x1758 * x1890 - x1770 * x1899;
  const Real x1639 = x1397 - (0.9999999999932537 * x1292 + 3.673205103346574e-06 * x1293);
  const Real x1651 = x1639 - tau[3] * (x1182 - x1519 + 97.57715913858884);
  w.x[165] = x1651;
  const Real x1737 = 1.7763568394002505e-15 * x1588;
  require_more(w, x1669, x1737, kFactorization, 3);
  const Real x1738 = 1.7763568394002505e-15 * x1593;
  require_more(w, x1688, x1738, kFactorization, 3);
  const Real x1739 = 1.7763568394002505e-15 * x1595;
  require_more(w, x1712, x1739, kFactorization, 3);
  const Real x1740 = 1.7763568394002505e-15 * x1596;
  require_more(w, x1735, x1740, kFactorization, 3);
  const Real x1915 = x1913 - x1780 * x1878 - x1796 * x1886;
  const Real x1916 = x1915 - x1832 * x1893;
  w.x[166] = x1916;
  const Real x1927 = x1771 * x1876 + x1780 * x1880 + x1796 * x1887;
  const Real x1929 = x1832 * x1894 + x1927;
  w.x[167] = x1929;
  const Real x1938 = x1780 * x1882 - x1796 * x1888 + x1832 * x1895;
  w.x[168] = x1938;
  const Real x1946 = x1780 * x1883 - x1796 * x1889 + x1832 * x1897;
  w.x[169] = x1946;
  const Real x1954 = x1780 * x1884 - x1796 * x1890 + x1832 * x1899;
  w.x[170] = x1954;
  const Real x1968 = x1780 * x1885 + x1966 + x1796 * x1891;
  const Real x1969 = x1968 - x1832 * x1901;
  w.x[171] = x1969;
  const Real x1981 = x1979 - x1801 * x1887 - x1841 * x1894;
  w.x[172] = x1981;
  const Real x1989 = x1782 * x1882 - x1801 * x1888 + x1841 * x1895;
  w.x[173] = x1989;
  const Real x1997 = x1782 * x1883 - x1801 * x1889 + x1841 * x1897;
  w.x[174] = x1997;
  const Real x2005 = x1782 * x1884 - x1801 * x1890 + x1841 * x1899;
  w.x[175] = x2005;
  const Real x2017 = x1801 * x1891 + x2015 - x1841 * x1901;
  w.x[176] = x2017;
  const Real x2025 = 97.57715913858884 - 9.757715913858885 * x1882 - x1804 * x1888;
  const Real x2026 = x2025 - x1846 * x1895;
  w.x[177] = x2026;
  const Real x2034 = 9.757715913858885 - 9.757715913858885 * x1883 - x1804 * x1889;
  const Real x2035 = x2034 - x1846 * x1897;
  w.x[178] = x2035;
  const Real x2043 = 4.878857956929442 - 9.757715913858885 * x1884 - x1804 * x1890;
  const Real x2044 = x2043 - x1846 * x1899;
  w.x[179] = x2044;
  const Real x2052 = x1804 * x1891 - 9.757715913858885 * x1885 + x1846 * x1901;
  w.x[180] = x2052;
  const Real x2060 = 1.430317045931343 - 1.430317045931343 * x1883 - x1807 * x1889;
  const Real x2061 = x2060 - x1852 * x1897;
  w.x[181] = x2061;
  const Real x2069 = 0.48788579569294427 - 1.430317045931343 * x1884 - x1807 * x1890;
  const Real x2070 = x2069 - x1852 * x1899;
  w.x[182] = x2070;
  const Real x2078 = x1807 * x1891 - 1.430317045931343 * x1885 + x1852 * x1901;
  w.x[183] = x2078;
  const Real x2086 = 0.6984883523919266 - 0.48788579569294427 * x1884 - x1810 * x1890;
  const Real x2087 = x2086 - x1858 * x1899;
  w.x[184] = x2087;
  const Real x2095 = x1810 * x1891 - 0.48788579569294427 * x1885 + x1858 * x1901;
  w.x[185] = x2095;
  const Real x2109 = x2107 - x1788 * x1885 - x1819 * x1891;
  const Real x2110 = x2109 - x1871 * x1901;
  w.x[186] = x2110;
  const Real x2164 = x1758 * x1886 + x2121 + x1770 * x1893 - x1387;
  w.x[187] = x2164;
  const Real x2165 = x1770 * x1894 + x2130 - x1392;
  w.x[188] = x2165;
  const Real x2166 = x2111 + x2137 - x1397;
  w.x[189] = x2166;
  const Real x2167 = x2112 + x2143 - x1402;
  w.x[190] = x2167;
  const Real x2168 = x2113 + x2149 - x1407;
  w.x[191] = x2168;
  const Real x2169 = x2158 - x1758 * x1891 + x1770 * x1901 - x1415;
  w.x[192] = x2169;
}

ADAGEN_NOINLINE void part_0_2(Workspace& w) {
  ADAGEN_INPUTS
  const Real x1916 = w.x[166];
  const Real x1929 = w.x[167];
  const Real x1938 = w.x[168];
  const Real x1946 = w.x[169];
  const Real x1954 = w.x[170];
  const Real x1969 = w.x[171];
  const Real x1981 = w.x[172];
  const Real x1989 = w.x[173];
  const Real x1997 = w.x[174];
  const Real x2005 = w.x[175];
  const Real x2017 = w.x[176];
  const Real x2026 = w.x[177];
  const Real x2035 = w.x[178];
  const Real x2044 = w.x[179];
  const Real x2052 = w.x[180];
  const Real x2061 = w.x[181];
  const Real x2070 = w.x[182];
  const Real x2078 = w.x[183];
  const Real x2087 = w.x[184];
  const Real x2095 = w.x[185];
  const Real x2110 = w.x[186];
  const Real x2164 = w.x[187];
  const Real x2165 = w.x[188];
  const Real x2166 = w.x[189];
  const Real x2167 = w.x[190];
  const Real x2168 = w.x[191];
  const Real x2169 = w.x[192];
  // message received
  const Real x2170 = w.from[0][0];
  const Real x2171 = w.from[0][1];
  const Real x2176 = w.from[0][6];
  const Real x2173 = w.from[0][3];
  const Real x2178 = w.from[0][8];
  const Real x2185 = w.from[0][15];
  const Real x2174 = w.from[0][4];
  const Real x2179 = w.from[0][9];
  const Real x2186 = w.from[0][16];
  const Real x2188 = w.from[0][18];
  const Real x2175 = w.from[0][5];
  const Real x2180 = w.from[0][10];
  const Real x2187 = w.from[0][17];
  const Real x2172 = w.from[0][2];
  const Real x2189 = w.from[0][19];
  const Real x2177 = w.from[0][7];
  const Real x2191 = w.from[0][21];
  const Real x2182 = w.from[0][12];
  const Real x2192 = w.from[0][22];
  const Real x2190 = w.from[0][20];
  const Real x2183 = w.from[0][13];
  const Real x2194 = w.from[0][24];
  const Real x2184 = w.from[0][14];
  const Real x2195 = w.from[0][25];
  const Real x2196 = w.from[0][26];
  const Real x2181 = w.from[0][11];
  w.x[12] = x2181;
  const Real x2193 = w.from[0][23];
  w.x[11] = x2193;
  // joint 4 "forearm_roll": assembly: its two sides become one chain
  const Real x2374 = 2.0 * sine[4];
  const Real x2214 = 0.08 * x1989;
  const Real x2199 = 0.38 * x1938;
  const Real x2343 = 3.673205103346574e-06 * x1929 - 0.9999999999932537 * x1938;
  const Real x2216 = x2005 - x2214;
  const Real x2227 = x2044 - 0.08 * x2026;
  const Real x2355 = 3.673205103346574e-06 * (x1981 - x2026) + 1.9999999999865075 * x1989;
  const Real x2229 = x2052 + x2214 + x2199;
  const Real x2221 = x2017 + 0.08 * x1981 - 0.38 * x1929;
  const Real x2210 = x1969 - 0.08 * x1929 + 0.38 * x1916;
  const Real x2204 = x1954 - 0.08 * x1938;
  const Real x2360 = 3.673205103346574e-06 * x2355;
  w.x[10] = x2360;
  const Real x2213 = x1997 - 0.38 * x1989;
  const Real x2224 = x2035 - 0.38 * x2026;
  const Real x2362 = x2026 + x2360;
  const Real x2255 = x2087 - 0.08 * x2044 - 0.08 * x2227;
  const Real x2271 = x2110 + 0.08 * x2017 + 0.38 * x1969;
  const Real x2201 = x1946 - x2199;
  const Real x2273 = 0.08 * x2221 + x2271 + 0.38 * x2210;
  const Real x2300 = 3.673205103346574e-06 * (x2216 - x2229) + 0.9999999999932537 * (x2221 + x2227);
  const Real x2262 = x2095 - 0.08 * x2052 + 0.08 * x2216;
  const Real x2263 = 0.38 * x2204 + x2262;
  const Real x2278 = 3.673205103346574e-06 * x2213 + 0.9999999999932537 * x2224;
  const Real x2288 = 3.673205103346574e-06 * x2204 + 0.9999999999932537 * x2210;
  const Real x2306 = 3.673205103346574e-06 * x2300;
  const Real x2376 = cosine[4] * (x1916 - x2362) + x2343 * x2374;
  const Real x2241 = x2070 - 0.38 * x2044 - 0.08 * x2224;
  const Real x2308 = x2229 + x2306;
  const Real x2302 = 0.9999999999932537 * x2300;
  const Real x2248 = x2078 - 0.38 * x2052 + 0.08 * x2213;
  const Real x2249 = 0.38 * x2201 + x2248;
  const Real x2235 = x2061 - 0.38 * x2035 - 0.38 * x2224;
  const Real x2379 = cosine[4] * x2376;
  const Real x2293 = 0.9999999999932537 * x2204 - 3.673205103346574e-06 * x2210;
  const Real x2397 = 3.673205103346574e-06 * (x2255 - x2273) + 1.9999999999865075 * x2263;
  const Real x2304 = x2221 - x2302;
  const Real x2402 = 3.673205103346574e-06 * x2397;
  const Real x2386 = 3.673205103346574e-06 * x2241 + 0.9999999999932537 * x2249;
  const Real x2424 = x2362 + x2379 + x2170;
  require_more(w, x2424, 3.7782214362185915e-12, kGrowth, 4);
  require_more(w, x2424, 0.0, kFactorization, 4);
  const Real x2425 = x2343 - sine[4] * x2376 + x2171;
  const Real x2430 = x1916 - x2379 + x2176;
  w.x[137] = x2430;
  require_more(w, x2430, 3.7782214362185915e-12, kGrowth, 4);
  const Real x2404 = x2273 + x2402;
  const Real x2330 = cosine[4] * (x2201 - x2308) - sine[4] * (x2278 + x2288);
  const Real x2391 = 0.9999999999932537 * x2241 - 3.673205103346574e-06 * x2249;
  const Real x2522 = 1 / x2424;
  const Real x2401 = x2263 - 0.9999999999932537 * x2397;
  const Real x2348 = 0.9999999999932537 * x1929 + 3.673205103346574e-06 * x1938;
  const Real x2359 = x1989 - 0.9999999999932537 * x2355;
  const Real x2336 = cosine[4] * x2330;
  const Real x2331 = sine[4] * x2330;
  const Real x2429 = cosine[4] * x2293 + sine[4] * x2304 + x2175;
  const Real x2450 = x2168 - 0.08 * x2166;
  const Real x2455 = x2169 + 0.08 * x2165 + 0.38 * x2164;
  const Real x2417 = cosine[4] * (x2235 - x2404) - x2374 * x2386;
  const Real x2427 = x2308 + x2336 + x2173;
  const Real x2428 = x2174 - (x2288 + x2331);
  const Real x2460 = 3.673205103346574e-06 * x2165 + 0.9999999999932537 * x2166;
  const Real x2523 = x2425 * x2522;
  const Real x2421 = cosine[4] * x2417;
  const Real x2524 = x2427 * x2522;
  const Real x2525 = x2428 * x2522;
  const Real x2283 = 0.9999999999932537 * x2213 - 3.673205103346574e-06 * x2224;
  const Real x2305 = x2227 - x2302;
  const Real x2529 = x2430 - x2425 * x2523;
  w.x[136] = x2529;
  const Real x2532 = x2178 - (x2278 + x2331) - x2427 * x2523;
  const Real x2439 = x2404 + x2421 + x2185;
  w.x[135] = x2439;
  require_more(w, x2439, 3.591265808372574e-14, kGrowth, 4);
  const Real x2535 = x2201 - x2336 + x2179 - x2428 * x2523;
  const Real x2442 = x2235 - x2421 + x2188;
  w.x[134] = x2442;
  require_more(w, x2442, 3.508704560934945e-14, kGrowth, 4);
  const Real x2539 = 1 / x2529;
  const Real x2434 = cosine[4] * x2304 - sine[4] * x2293 + x2180;
  const Real x2538 = x2434 - x2429 * x2523;
  const Real x2426 = sine[4] * x2359 - cosine[4] * x2348 + x2172;
  w.x[130] = x2426;
  const Real x2447 = x2167 - 0.38 * x2166;
  const Real x2480 = 3.673205103346574e-06 * x2450 + 0.9999999999932537 * x2455;
  const Real x2441 = cosine[4] * x2391 + sine[4] * x2401 + x2187;
  const Real x2431 = sine[4] * x2348 + cosine[4] * x2359 + x2177;
  w.x[131] = x2431;
  const Real x2526 = x2429 * x2522;
  const Real x2443 = cosine[4] * x2401 - sine[4] * x2391 + x2189;
  const Real x2436 = cosine[4] * x2283 + sine[4] * x2305 + x2182;
  w.x[126] = x2436;
  const Real x2540 = x2532 * x2539;
  const Real x2541 = x2535 * x2539;
  const Real x2496 = cosine[4] * x2164 - sine[4] * x2460 - x2191;
  const Real x2510 = x2496 - tau[4] * x2426;
  const Real x2444 = x2255 - x2402 + x2190;
  w.x[125] = x2444;
  require_more(w, x2444, 1.513549696734667e-14, kGrowth, 4);
  const Real x2542 = x2538 * x2539;
  const Real x2437 = cosine[4] * x2305 - sine[4] * x2283 + x2183;
  w.x[123] = x2437;
  const Real x2497 = sine[4] * x2164 + cosine[4] * x2460 + x2192;
  const Real x2548 = x2439 - x2427 * x2524 - x2532 * x2540;
  w.x[133] = x2548;
  const Real x2553 = x2186 - (x2386 + sine[4] * x2417) - x2428 * x2524;
  const Real x2554 = x2553 - x2535 * x2540;
  const Real x2560 = x2441 - x2429 * x2524 - x2538 * x2540;
  const Real x2438 = x2216 - x2306 + x2184;
  w.x[129] = x2438;
  const Real x2561 = 1 / x2548;
  const Real x2500 = cosine[4] * x2447 - sine[4] * x2480 - x2194;
  const Real x2603 = x2497 + tau[4] * x2431 + x2510 * x2523;
  const Real x2501 = sine[4] * x2447 + cosine[4] * x2480 + x2195;
  const Real x2503 = 0.9999999999932537 * x2450 - 3.673205103346574e-06 * x2455 - x2196;
  const Real x2609 = x2500 - tau[4] * x2436 - x2510 * x2524;
  const Real x2610 = x2540 * x2603 + x2609;
  const Real x2617 = x2501 + tau[4] * x2437 + x2510 * x2525;
  const Real x2562 = x2554 * x2561;
  const Real x2563 = x2560 * x2561;
  const Real x2629 = x2503 - tau[4] * x2438 - x2510 * x2526;
  const Real x2571 = x2442 - x2428 * x2525 - x2535 * x2541;
  const Real x2572 = x2571 - x2554 * x2562;
  w.x[132] = x2572;
  const Real x2580 = x2443 - x2429 * x2525 - x2538 * x2541;
  const Real x2581 = x2580 - x2560 * x2562;
  const Real x2593 = x2444 - x2429 * x2526 - x2538 * x2542;
  const Real x2620 = x2541 * x2603 - x2617 - x2562 * x2610;
  const Real x2582 = 1 / x2572;
  const Real x2583 = x2581 * x2582;
  const Real x2595 = x2593 - x2560 * x2563 - x2581 * x2583;
  w.x[122] = x2595;
  const Real x2631 = x2542 * x2603 + x2629 - x2563 * x2610;
  // joint 4 "forearm_roll": disassembly: its acceleration and force
  const Real x2639 = 1 / x2595 * (x2631 - x2583 * x2620);
  w.x[141] = x2639;
  w.to[1][5] = x2639;
  const Real x2642 = x2582 * x2620 - x2583 * x2639;
  w.x[140] = x2642;
  w.to[1][4] = x2642;
  const Real x2648 = x2561 * x2610 - x2563 * x2639 - x2562 * x2642;
  w.x[119] = x2648;
  w.to[1][3] = x2648;
  const Real x2657 = x2539 * x2603 + x2542 * x2639 + x2541 * x2642;
  const Real x2659 = x2540 * x2648 + x2657;
  w.x[121] = x2659;
  const Real x2670 = x2510 * x2522 - x2526 * x2639 - x2525 * x2642;
  const Real x2660 = -x2659;
  w.to[1][1] = x2660;
  const Real x2672 = x2670 - x2524 * x2648 + x2523 * x2659;
  w.x[139] = x2672;
  w.to[1][0] = x2672;
}

ADAGEN_NOINLINE void part_0_3(Workspace& w) {
  ADAGEN_INPUTS
  const Real x399 = w.x[0];
  const Real x501 = w.x[3];
  const Real x502 = w.x[4];
  const Real x530 = w.x[16];
  const Real x532 = w.x[163];
  const Real x533 = w.x[7];
  const Real x538 = w.x[6];
  const Real x539 = w.x[8];
  const Real x540 = w.x[9];
  const Real x544 = w.x[14];
  const Real x546 = w.x[18];
  const Real x547 = w.x[21];
  const Real x556 = w.x[23];
  const Real x557 = w.x[26];
  const Real x562 = w.x[19];
  const Real x568 = w.x[25];
  const Real x569 = w.x[15];
  const Real x576 = w.x[24];
  const Real x577 = w.x[22];
  const Real x737 = w.x[30];
  const Real x752 = w.x[35];
  const Real x758 = w.x[37];
  const Real x786 = w.x[32];
  const Real x790 = w.x[33];
  const Real x876 = w.x[36];
  const Real x878 = w.x[164];
  const Real x886 = w.x[39];
  const Real x887 = w.x[42];
  const Real x889 = w.x[43];
  const Real x890 = w.x[44];
  const Real x891 = w.x[45];
  const Real x904 = w.x[47];
  const Real x905 = w.x[52];
  const Real x906 = w.x[53];
  const Real x907 = w.x[54];
  const Real x930 = w.x[58];
  const Real x931 = w.x[61];
  const Real x933 = w.x[62];
  const Real x956 = w.x[67];
  const Real x957 = w.x[71];
  const Real x971 = w.x[77];
  const Real x978 = w.x[50];
  const Real x984 = w.x[63];
  const Real x993 = w.x[70];
  const Real x1005 = w.x[78];
  const Real x1006 = w.x[48];
  const Real x1008 = w.x[49];
  const Real x1014 = w.x[57];
  const Real x1018 = w.x[56];
  const Real x1021 = w.x[60];
  const Real x1026 = w.x[59];
  const Real x1035 = w.x[66];
  const Real x1040 = w.x[65];
  const Real x1045 = w.x[69];
  const Real x1054 = w.x[68];
  const Real x1067 = w.x[74];
  const Real x1075 = w.x[73];
  const Real x1083 = w.x[76];
  const Real x1094 = w.x[75];
  const Real x1476 = w.x[109];
  const Real x1526 = w.x[91];
  const Real x1530 = w.x[100];
  const Real x1591 = w.x[102];
  const Real x1592 = w.x[104];
  const Real x1649 = w.x[103];
  const Real x1651 = w.x[165];
  const Real x1660 = w.x[85];
  const Real x1661 = w.x[92];
  const Real x1663 = w.x[93];
  const Real x1664 = w.x[94];
  const Real x1666 = w.x[95];
  const Real x1679 = w.x[99];
  const Real x1680 = w.x[106];
  const Real x1681 = w.x[107];
  const Real x1682 = w.x[108];
  const Real x1701 = w.x[114];
  const Real x1702 = w.x[127];
  const Real x1703 = w.x[128];
  const Real x1722 = w.x[153];
  const Real x1723 = w.x[154];
  const Real x1736 = w.x[162];
  const Real x1743 = w.x[110];
  const Real x1749 = w.x[116];
  const Real x1758 = w.x[149];
  const Real x1770 = w.x[158];
  const Real x1771 = w.x[111];
  const Real x1775 = w.x[113];
  const Real x1780 = w.x[117];
  const Real x1782 = w.x[115];
  const Real x1788 = w.x[118];
  const Real x1796 = w.x[150];
  const Real x1801 = w.x[151];
  const Real x1804 = w.x[146];
  const Real x1807 = w.x[147];
  const Real x1810 = w.x[148];
  const Real x1819 = w.x[152];
  const Real x1832 = w.x[159];
  const Real x1841 = w.x[160];
  const Real x1846 = w.x[155];
  const Real x1852 = w.x[156];
  const Real x1858 = w.x[157];
  const Real x1871 = w.x[161];
  const Real x1981 = w.x[172];
  const Real x2165 = w.x[188];
  const Real x2166 = w.x[189];
  const Real x2181 = w.x[12];
  const Real x2193 = w.x[11];
  const Real x2360 = w.x[10];
  const Real x2426 = w.x[130];
  const Real x2430 = w.x[137];
  const Real x2431 = w.x[131];
  const Real x2436 = w.x[126];
  const Real x2437 = w.x[123];
  const Real x2438 = w.x[129];
  const Real x2439 = w.x[135];
  const Real x2442 = w.x[134];
  const Real x2444 = w.x[125];
  const Real x2529 = w.x[136];
  const Real x2548 = w.x[133];
  const Real x2572 = w.x[132];
  const Real x2595 = w.x[122];
  const Real x2639 = w.x[141];
  const Real x2642 = w.x[140];
  const Real x2648 = w.x[119];
  const Real x2659 = w.x[121];
  const Real x2672 = w.x[139];
  // joint 4 "forearm_roll": assembly: its two sides become one chain
  const Real x2499 = 0.9999999999932537 * x2165 - 3.673205103346574e-06 * x2166 - x2193;
  const Real x2597 = 1.7763568394002505e-15 * x2430;
  require_more(w, x2529, x2597, kFactorization, 4);
  const Real x2600 = 1.7763568394002505e-15 * x2444;
  require_more(w, x2595, x2600, kFactorization, 4);
  const Real x2598 = 1.7763568394002505e-15 * x2439;
  require_more(w, x2548, x2598, kFactorization, 4);
  const Real x2599 = 1.7763568394002505e-15 * x2442;
  require_more(w, x2572, x2599, kFactorization, 4);
  // joint 4 "forearm_roll": disassembly: its acceleration and force
  const Real x2708 = sine[4] * x2648 + cosine[4] * x2642;
  const Real x2705 = cosine[4] * x2648 - sine[4] * x2642;
  const Real x2712 = 0.9999999999932537 * x2639 - 3.673205103346574e-06 * x2708;
  const Real x2717 = 0.9999999999932537 * x2708 + 3.673205103346574e-06 * x2639;
  const Real x2680 = x2437 * x2642 + x2438 * x2639 + x2436 * x2648;
  const Real x2691 = sine[4] * x2672 - cosine[4] * x2659;
  const Real x2721 = cosine[4] * x2672 + sine[4] * x2659 - 0.38 * x2717;
  const Real x2682 = x2680 - x2431 * x2659 + x2426 * x2672;
  const Real x2683 = x2682 - (x2499 - tau[4] * (x1981 - x2360 + x2181));
  w.result[4] = x2683;
  const Real x2724 = 0.9999999999932537 * tau[4] - 3.673205103346574e-06 * x2691 - 0.08 * x2717;
  const Real x2700 = 0.9999999999932537 * x2691 + 3.673205103346574e-06 * tau[4];
  const Real x2731 = 0.08 * x2712 + 0.38 * x2705 + x2700;
  // joint 3 "elbow_pitch": disassembly: its acceleration and force
  const Real x2799 = x1852 * x2705 + x1858 * x2712 + x1871 * x2717;
  const Real x2780 = x1807 * x2705 + x1810 * x2712 + x1819 * x2717;
  const Real x2763 = x1788 * x2717 - (1.430317045931343 * x2705 + 0.48788579569294427 * x2712);
  const Real x2801 = x2799 - x1832 * x2721 - x1841 * x2724;
  const Real x2784 = x1796 * x2721 + x2780 + x1801 * x2724;
  const Real x2765 = x1780 * x2721 + x2763 + x1782 * x2724;
  const Real x2750 = x1775 * x2717 - x1771 * x2721 - 363.6363636363637 * x2724;
  const Real x2815 = 97.57715913858884 * x2731 - (9.757715913858885 * x2705 + 4.878857956929442 * x2712);
  const Real x2821 = x1736 * (x1770 - (x2801 - x1846 * x2731));
  const Real x2820 = x1722 * (x1758 - (x1804 * x2731 - x2784));
  const Real x2824 = x2820 - x1723 * x2821;
  const Real x2819 = x1701 * (x1749 - (9.757715913858885 * x2731 + x2765));
  const Real x2817 = x1660 * (97.57715913858884 * x2721 + 9.757715913858885 * x2717 + x1649);
  const Real x2830 = x2819 - x1703 * x2821 - x1702 * x2824;
  const Real x2837 = x1679 * (x1743 - x2750) - x1682 * x2821;
  const Real x2839 = x2837 - x1681 * x2824 - x1680 * x2830;
  const Real x2849 = x2817 - x1666 * x2821 + x1664 * x2824;
  const Real x2885 = sine[3] * x2830 + cosine[3] * x2824;
  const Real x2882 = cosine[3] * x2830 - sine[3] * x2824;
  const Real x2851 = x2849 - x1663 * x2830 + x1661 * x2839;
  const Real x2890 = 3.673205103346574e-06 * x2885 + 0.9999999999932537 * x2821;
  const Real x2895 = 0.9999999999932537 * x2885 - 3.673205103346574e-06 * x2821;
  const Real x2858 = x1592 * x2824 + x1476 * x2821 + x1591 * x2830;
  const Real x2868 = sine[3] * x2851 + cosine[3] * x2839;
  const Real x2865 = cosine[3] * x2851 - sine[3] * x2839;
  const Real x2860 = x1530 * x2839 + x2858 + x1526 * x2851;
  const Real x2861 = x2815 - x1651 + x2860;
  w.result[3] = x2861;
  const Real x2898 = 3.673205103346574e-06 * x2868 + 0.9999999999932537 * tau[3] + 0.08 * x2895;
  // joint 2 "upper_arm_roll": disassembly: its acceleration and force
  const Real x2952 = x1094 * x2890 - x1083 * x2882 - 0.3846153846153846 * x2895;
  // joint 3 "elbow_pitch": disassembly: its acceleration and force
  const Real x2902 = 0.9999999999932537 * x2868 - 3.673205103346574e-06 * tau[3] - 0.08 * x2890;
  // joint 2 "upper_arm_roll": disassembly: its acceleration and force
  const Real x2941 = x1054 * x2890 - x1045 * x2882 - x1035 * x2865;
  const Real x2932 = x1026 * x2890 - x1021 * x2882 + x1014 * x2865;
  const Real x2922 = 3.338433718180554 * x2882 + x1008 * x2890 + x1006 * x2865;
  const Real x2959 = x1005 - (x2952 - x1067 * x2865 + x1075 * x2898);
  const Real x2967 = x971 * x2959;
  const Real x2966 = x956 * (x993 - (x1040 * x2898 + x2941));
  const Real x2970 = x2966 + x957 * x2967;
  const Real x2965 = x930 * (x984 - (x1018 * x2898 + x2932));
  const Real x2964 = x904 * (x978 - (111.2811239393518 * x2898 - x2922));
  const Real x2963 = x886 * (111.2811239393518 * x2865 + 3.338433718180554 * x2890 + x876);
  const Real x2976 = x2965 + x933 * x2967 + x931 * x2970;
  const Real x2984 = x2964 - x907 * x2967 - x906 * x2970;
  const Real x2985 = x2984 - x905 * x2976;
  const Real x2995 = x2963 - x891 * x2967 - x890 * x2970;
  const Real x3029 = cosine[2] * x2976 - sine[2] * x2970;
  const Real x2997 = x2995 - x889 * x2976 + x887 * x2985;
  const Real x3039 = 0.9999999999932537 * (sine[2] * x2976 + cosine[2] * x2970);
  const Real x3042 = x3039 - 3.673205103346574e-06 * x2967;
  const Real x3005 = x758 * x2970 + x737 * x2967 - x752 * x2976;
  const Real x3015 = sine[2] * x2997 + cosine[2] * x2985;
  const Real x3045 = cosine[2] * x2997 - sine[2] * x2985 - 0.3 * x3042;
  const Real x3007 = x790 * x2985 + x3005 + x786 * x2997;
  const Real x3008 = x878 - 254.29116338207245 * x2902 + x3007;
  w.result[2] = x3008;
  const Real x3020 = 3.673205103346574e-06 * x3015 + 0.9999999999932537 * tau[2];
  const Real x3048 = 0.9999999999932537 * x3015 - 3.673205103346574e-06 * tau[2] + 0.3 * x3029;
  // joint 1 "shoulder_pitch": disassembly: its acceleration and force
  const Real x3080 = x577 * x3020 - (x576 * x3045 + x556 * x3042);
  const Real x3066 = x569 * x3045 + x544 * x3042 + 179.2114695340502 * x3020;
  const Real x3096 = x557 * (x568 - x3080);
  const Real x3099 = x546 * (x562 - x3066) + x547 * x3096;
  const Real x3092 = x538 * (56.59309564233163 * x3045 + 5.659309564233164 * x3042 + x530);
  const Real x3094 = 1.1254777070063695 * (x533 - (5.659309564233164 * x3048 - 0.8885116015846066 * x3029));
  const Real x3105 = x3092 - x540 * x3096 - x539 * x3099;
  const Real x3111 = x502 * x3099 - 5.659309564233164 * x3094 + x501 * x3105;
  const Real x3112 = 5.659309564233164 * x3029 - 56.59309564233163 * x3048 - x532 + x3111;
  w.result[1] = x3112;
  const Real x3124 = 0.9999999999932537 * (sine[1] * x3105 + cosine[1] * x3099);
  // joint 0 "base_yaw": disassembly: its acceleration and force
  const Real x3175 = x399 + 113.37868480725623 * (x3124 + 3.673205103346574e-06 * tau[1]);
  w.result[0] = x3175;
}

// =================================================================================================
// Process 1: 1827 products, 1514 sums, 17 quotients
// =================================================================================================

ADAGEN_NOINLINE void part_1_0(Workspace& w) {
  ADAGEN_INPUTS
  // joint 1 "shoulder_pitch": placement, velocity and reference acceleration of its link
  const Real x20 = v[0] * 0.9999999999932537;
  const Real x25 = sine[1] * x20;
  const Real x27 = cosine[1] * x20;
  const Real x29 = v[1] - v[0] * 3.673205103346574e-06;
  const Real x30 = v[1] * x27;
  const Real x32 = v[1] * x25;
  // joint 2 "upper_arm_roll": placement, velocity and reference acceleration of its link
  const Real x80 = 3.673205103346574e-06 * x27 + 0.9999999999932537 * x29;
  const Real x89 = sine[2] * x80 - x25 * cosine[2];
  const Real x93 = x25 * sine[2] + cosine[2] * x80;
  const Real x94 = 0.9999999999932537 * x27 - 3.673205103346574e-06 * x29 + v[2];
  const Real x95 = 3.673205103346574e-06 * x32;
  const Real x97 = 0.9999999999932537 * x32;
  const Real x111 = v[2] * x93 - (x30 * cosine[2] + sine[2] * x95);
  const Real x114 = x30 * sine[2] - cosine[2] * x95 - v[2] * x89;
  const Real x118 = sine[1] * 9.809999999933819 + x25 * x27 * 0.3;
  const Real x120 = (x25 * x25 + x29 * x29) * 0.3;
  const Real x122 = x120 - cosine[1] * 9.809999999933819;
  const Real x125 = -3.603414206382989e-05 + (x30 + x27 * x29) * 0.3;
  const Real x129 = 0.9999999999932537 * x125 - 3.673205103346574e-06 * x122;
  // joint 3 "elbow_pitch": placement, velocity and reference acceleration of its link
  const Real x174 = 0.9999999999932537 * x94 - 3.673205103346574e-06 * x93;
  const Real x183 = x89 * cosine[3] + sine[3] * x174;
  const Real x187 = cosine[3] * x174 - x89 * sine[3];
  const Real x188 = v[3] - (0.9999999999932537 * x93 + 3.673205103346574e-06 * x94);
  const Real x193 = 3.673205103346574e-06 * x114 + 0.9999999999932537 * x97;
  const Real x199 = 3.673205103346574e-06 * x97 - 0.9999999999932537 * x114;
  const Real x211 = x111 * cosine[3] - sine[3] * x193 + v[3] * x187;
  const Real x214 = x111 * sine[3] + cosine[3] * x193 + v[3] * x183;
  const Real x216 = (x93 * x93 + x94 * x94) * 0.08;
  const Real x218 = sine[2] * x129 - cosine[2] * x118 - x216;
  // joint 2 "upper_arm_roll": placement, velocity and reference acceleration of its link
  const Real x143 = sine[2] * x118 + cosine[2] * x129;
  // joint 3 "elbow_pitch": placement, velocity and reference acceleration of its link
  const Real x220 = x143 + (x89 * x93 - x97) * 0.08;
  const Real x221 = (x89 * x94 - x114) * 0.08;
  const Real x222 = x221 - (0.9999999999932537 * x122 + 3.673205103346574e-06 * x125);
  const Real x226 = 0.9999999999932537 * x222 - 3.673205103346574e-06 * x220;
  const Real x246 = x188 * x188;
  const Real x249 = x183 * x187;
  // joint 4 "forearm_roll": placement, velocity and reference acceleration of its link
  const Real x273 = 3.673205103346574e-06 * x187 + 0.9999999999932537 * x188;
  const Real x282 = x183 * cosine[4] - sine[4] * x273;
  const Real x287 = x183 * sine[4] + cosine[4] * x273;
  const Real x289 = 0.9999999999932537 * x187 - 3.673205103346574e-06 * x188 + v[4];
  const Real x294 = 3.673205103346574e-06 * x214 - 0.9999999999932537 * x199;
  const Real x299 = 0.9999999999932537 * x214 + 3.673205103346574e-06 * x199;
  const Real x310 = x211 * cosine[4] + sine[4] * x294 - v[4] * x287;
  const Real x313 = cosine[4] * x294 - x211 * sine[4] - v[4] * x282;
  const Real x314 = 0.08 * (x187 * x187 + x246);
  // joint 3 "elbow_pitch": placement, velocity and reference acceleration of its link
  const Real x235 = cosine[3] * x218 + sine[3] * x226;
  // joint 4 "forearm_roll": placement, velocity and reference acceleration of its link
  const Real x318 = x314 + (x249 - x199) * 0.38 + x235;
  const Real x321 = (x183 * x183 + x246) * 0.38;
  // joint 3 "elbow_pitch": placement, velocity and reference acceleration of its link
  const Real x239 = cosine[3] * x226 - sine[3] * x218;
  // joint 4 "forearm_roll": placement, velocity and reference acceleration of its link
  const Real x325 = x239 - (0.08 * (x199 + x249) + x321);
  // joint 3 "elbow_pitch": placement, velocity and reference acceleration of its link
  const Real x231 = 0.9999999999932537 * x220 + 3.673205103346574e-06 * x222;
  // joint 4 "forearm_roll": placement, velocity and reference acceleration of its link
  const Real x329 = x231 + 0.08 * (x214 + x183 * x188);
  const Real x331 = (x211 + x187 * x188) * 0.38 - x329;
  const Real x336 = 3.673205103346574e-06 * x325 + 0.9999999999932537 * x331;
  const Real x341 = 0.9999999999932537 * x325 - 3.673205103346574e-06 * x331;
  const Real x345 = cosine[4] * x318 - sine[4] * x336;
  const Real x350 = sine[4] * x318 + cosine[4] * x336;
  const Real x356 = x282 * x282;
  const Real x362 = x282 * x287;
  const Real x364 = x299 - x362;
  const Real x367 = x356 + x289 * x289;
  const Real x369 = x287 * x289;
  const Real x374 = x356 + x287 * x287;
  const Real x376 = x282 * x289;
  const Real x378 = x313 + x376;
  // link 5 "wrist_housing": acceleration where nothing acts on it
  const Real x3837 = x369 * 0.01347604 + 0.00136 * (x374 - x367);
  const Real x3859 = x310 * 0.01553729 + x3837 + x341 * 0.017;
  const Real x3860 = x3859 - x350 * 0.136;
  const Real x3846 = x376 * 0.01364604 - x364 * 0.00136 + x313 * 0.01536729;
  const Real x3863 = x3846 - x345 * 0.136;
  const Real x3855 = x362 * 0.00017 - x299 * 0.00189125 + x378 * 0.00136;
  const Real x3866 = x3855 - x345 * 0.017;
  const Real x3872 = x364 * 0.017 - x378 * 0.136 + x345 * 1.7;
  const Real x3879 = (x310 + x369) * 0.136 - x367 * 0.017;
  const Real x3880 = x3879 - x350 * 1.7;
  const Real x3885 = x341 * 1.7 + x374 * 0.136;
  const Real x3886 = (x310 - x369) * 0.017 + x3885;
  const Real x3904 = x3860 * 222.85165433925602 - x3886 * 2.2285165433925602 - x3880 * 17.828132347140482;
  w.x[0] = x3904;
  const Real x3907 = x3863 * 222.85165433925602 + x3872 * 17.828132347140482;
  w.x[1] = x3907;
  const Real x3910 = x3866 * 580.9731299927379 + x3872 * 5.809731299927379;
  w.x[2] = x3910;
  const Real x3915 = x3863 * 17.828132347140482 + x3866 * 5.809731299927379 + x3872 * 2.0725831948881592;
  w.x[3] = x3915;
  const Real x3921 = x3886 * 0.17828132347140482 - x3860 * 17.828132347140482 + x3880 * 2.0144858818888856;
  w.x[4] = x3921;
  const Real x3927 = x3886 * 0.6105204595515726 - x3860 * 2.2285165433925602 + x3880 * 0.17828132347140482;
  w.x[5] = x3927;
  // joint 5 "wrist_pitch": placement, velocity and reference acceleration of its link
  const Real x387 = 3.673205103346574e-06 * x287 + 0.9999999999932537 * x289;
  const Real x395 = x282 * cosine[5] + sine[5] * x387;
  const Real x399 = cosine[5] * x387 - x282 * sine[5];
  const Real x400 = 0.9999999999932537 * x287 - 3.673205103346574e-06 * x289 + v[5];
  const Real x405 = 3.673205103346574e-06 * x313 + 0.9999999999932537 * x299;
  const Real x411 = 3.673205103346574e-06 * x299 - 0.9999999999932537 * x313;
  const Real x423 = x310 * cosine[5] - sine[5] * x405 + v[5] * x399;
  const Real x426 = x310 * sine[5] + cosine[5] * x405 + v[5] * x395;
  const Real x431 = 3.673205103346574e-06 * x350 + 0.9999999999932537 * x341;
  const Real x436 = 0.9999999999932537 * x350 - 3.673205103346574e-06 * x341;
  const Real x439 = x345 * cosine[5] + sine[5] * x431;
  const Real x443 = cosine[5] * x431 - x345 * sine[5];
  const Real x449 = x400 * x400;
  const Real x450 = x399 * x399 + x449;
  const Real x452 = x395 * x399;
  const Real x454 = x411 + x452;
  const Real x455 = x395 * x395 + x449;
  const Real x457 = x399 * x400;
  const Real x459 = x423 + x457;
  const Real x462 = x395 * x400;
  const Real x463 = x426 + x462;
  // link 6 "wrist": acceleration where nothing acts on it
  const Real x2772 = x411 * 0.00351 + x452 * 0.0019500000000000001;
  const Real x2753 = x423 * 0.0014299999999999998 + x457 * 0.00013000000000000002 + x463 * 0.0005200000000000001;
  const Real x2775 = x2753 + x436 * 0.013000000000000001;
  const Real x2764 = x426 * 0.00338 + x462 * 0.0020800000000000003 + x459 * 0.0005200000000000001;
  const Real x2778 = x2764 + x436 * 0.052000000000000005;
  const Real x2783 = x2772 - 0.0005200000000000001 * (x455 - x450) + x443 * 0.052000000000000005;
  const Real x2784 = x2783 - x439 * 0.013000000000000001;
  const Real x2789 = (x452 - x411) * 0.013000000000000001 - x450 * 0.052000000000000005;
  const Real x2790 = x439 * 1.3 + x2789;
  const Real x2796 = x454 * 0.052000000000000005 - x455 * 0.013000000000000001 + x443 * 1.3;
  const Real x2801 = x436 * 1.3 + x463 * 0.052000000000000005 + x459 * 0.013000000000000001;
  const Real x2813 = x2775 * 769.2307692307693 - x2801 * 7.6923076923076925;
  w.x[6] = x2813;
  const Real x2817 = x2801 * 30.76923076923077 - x2778 * 769.2307692307693;
  w.x[7] = x2817;
  const Real x2823 = x2790 * 7.6923076923076925 - x2796 * 30.76923076923077 + x2784 * 769.2307692307693;
  w.x[8] = x2823;
  const Real x2830 = x2790 * 0.8461538461538461 - x2796 * 0.3076923076923077 + x2784 * 7.6923076923076925;
  w.x[9] = x2830;
  const Real x2837 = 2.0 * x2796 - x2790 * 0.3076923076923077 - x2784 * 30.76923076923077;
  w.x[10] = x2837;
  const Real x2845 = x2801 * 2.076923076923077 - (x2775 * 7.6923076923076925 + x2778 * 30.76923076923077);
  w.x[11] = x2845;
  // joint 6 "flange_roll": placement, velocity and reference acceleration of its link
  const Real x474 = 0.9999999999932537 * x400 - 3.673205103346574e-06 * x399;
  const Real x483 = x395 * cosine[6] + sine[6] * x474;
  const Real x487 = cosine[6] * x474 - x395 * sine[6];
  const Real x488 = v[6] - (0.9999999999932537 * x399 + 3.673205103346574e-06 * x400);
  const Real x492 = 3.673205103346574e-06 * x426 + 0.9999999999932537 * x411;
  const Real x497 = 0.9999999999932537 * x426 - 3.673205103346574e-06 * x411;
  const Real x506 = x423 * cosine[6] + sine[6] * x492 + v[6] * x487;
  const Real x509 = cosine[6] * x492 - x423 * sine[6] - v[6] * x483;
  const Real x512 = x439 - x450 * 0.09;
  const Real x514 = x443 + x454 * 0.09;
  const Real x516 = x436 + x463 * 0.09;
  const Real x520 = 0.9999999999932537 * x516 - 3.673205103346574e-06 * x514;
  const Real x525 = 0.9999999999932537 * x514 + 3.673205103346574e-06 * x516;
  const Real x529 = cosine[6] * x512 + sine[6] * x520;
  const Real x533 = cosine[6] * x520 - sine[6] * x512;
  const Real x538 = x483 * x483;
  const Real x539 = x487 * x487;
  const Real x540 = x488 * x488;
  const Real x541 = x539 + x540;
  const Real x543 = x483 * x487;
  const Real x544 = x543 - x497;
  const Real x545 = x497 + x543;
  const Real x546 = x538 + x540;
  const Real x548 = x487 * x488;
  const Real x549 = x548 - x506;
  const Real x550 = x506 + x548;
  const Real x551 = x538 + x539;
  const Real x553 = x483 * x488;
  const Real x554 = x553 - x509;
  const Real x555 = x509 + x553;
  // link 7 "hand": acceleration where nothing acts on it
  const Real x710 = x553 * 0.006916 - 0.00014399999999999992 * (x541 - x551);
  const Real x703 = x506 * 0.01009033 - (x548 * 0.00506167 + x545 * 0.00014399999999999992);
  const Real x724 = x703 - x533 * 0.0754;
  const Real x728 = x509 * 0.008236 + x710 + x525 * 0.007199999999999999;
  const Real x729 = x529 * 0.0754 + x728;
  const Real x721 = x497 * 0.00317433 - x543 * 0.0018543300000000004 + x549 * 0.00014399999999999992;
  const Real x731 = x721 + x533 * 0.007199999999999999;
  const Real x737 = x555 * 0.0754 - x541 * 0.007199999999999999 + x529 * 0.85;
  const Real x742 = x545 * 0.007199999999999999 + x549 * 0.0754 + x533 * 0.85;
  const Real x750 = x554 * 0.007199999999999999 - (x525 * 0.85 + x551 * 0.0754);
  const Real x769 = x724 * 300.9051975855012 - x731 * 47.81116318204386 + x742 * 27.097049732773534;
  w.x[12] = x769;
  const Real x776 = x729 * 672.6812282367838 + x750 * 5.698005698005698 - x737 * 59.67078189300412;
  w.x[13] = x776;
  const Real x784 = x731 * 328.7950427750268 - x724 * 47.81116318204386 - x742 * 7.026218837536823;
  w.x[14] = x784;
  const Real x793 = x737 * 6.46961994674413 - (x729 * 59.67078189300412 + x750 * 0.5054466230936819);
  w.x[15] = x793;
  const Real x799 = x724 * 27.097049732773534 - x731 * 7.026218837536823 + x742 * 3.639654500566341;
  w.x[16] = x799;
  const Real x805 = x729 * 5.698005698005698 + x750 * 1.2247360482654601 - x737 * 0.5054466230936819;
  w.x[17] = x805;
  // joint 7 "left_finger_slide": placement, velocity and reference acceleration of its link
  const Real x560 = x555 * 0.13;
  const Real x565 = x549 * 0.13;
  const Real x567 = x533 - x546 * q[7] + x565;
  const Real x571 = x525 + x551 * 0.13;
  const Real x574 = 2.0 * x488;
  const Real x576 = x550 * q[7] - x571 + 2.0 * x483 * v[7];
  const Real x579 = x529 + x544 * q[7] + x560 - v[7] * x574;
  // link 9 "right_finger": acceleration where nothing acts on it
  const Real x829 = x497 * 8.33333e-06;
  // link 8 "left_finger": acceleration where nothing acts on it
  const Real x1845 = x548 * 5.333337e-05 + (x551 - x546) * 1.5e-05;
  const Real x1839 = x829 - x543 * 5e-06 - x555 * 1.5e-05;
  const Real x1856 = x1839 - x579 * 0.0005;
  const Real x1860 = x506 * 6.66667e-05 - x1845 + x576 * 0.0005;
  const Real x1861 = x1860 - x567 * 0.0015;
  w.x[18] = x1861;
  const Real x1853 = x553 * 5.833337e-05 + x544 * 1.5e-05 + x509 * 6.16667e-05;
  const Real x1863 = x1853 + x579 * 0.0015;
  const Real x1869 = x550 * 0.0005 - x551 * 0.0015 + x576 * 0.05;
  w.x[19] = x1869;
  const Real x1874 = x555 * 0.0015 + x544 * 0.0005 + x579 * 0.05;
  const Real x1880 = x549 * 0.0015 - x546 * 0.0005 + x567 * 0.05;
  w.x[20] = x1880;
  const Real x1883 = 300000.3000003 * x1856 + 3000.003000003 * x1874;
  w.x[21] = x1883;
  const Real x1889 = 1799.9964000071998 * x1880 - 599.9988000024 * x1869 + 59999.880000239995 * x1861;
  w.x[22] = x1889;
  const Real x1893 = 59999.880000239995 * x1863 - 1799.9964000071998 * x1874;
  w.x[23] = x1893;
  const Real x1900 = 25.999988000024 * x1869 - 17.999964000071998 * x1880 - 599.9988000024 * x1861;
  w.x[24] = x1900;
  const Real x1906 = 3000.003000003 * x1856 - 1799.9964000071998 * x1863 + 103.99992200024599 * x1874;
  w.x[25] = x1906;
  // joint 8 "right_finger_slide": placement, velocity and reference acceleration of its link
  const Real x585 = q[8] * 2.65358979335273e-06;
  const Real x588 = q[8] * 0.9999999999964793;
  const Real x593 = x487 * 2.65358979335273e-06 - x483 * 0.9999999999964793;
  const Real x598 = x483 * 2.65358979335273e-06 + x487 * 0.9999999999964793;
  const Real x603 = x509 * 2.65358979335273e-06 - x506 * 0.9999999999964793;
  const Real x608 = x506 * 2.65358979335273e-06 + x509 * 0.9999999999964793;
  const Real x616 = x541 * x585 - x544 * x588 + x529 + x560;
  const Real x623 = x546 * x588 - x545 * x585 + x533 + x565;
  const Real x640 = 2.65358979335273e-06 * x616 + 0.9999999999964793 * x623;
  const Real x630 = x571 + x554 * x585 + x550 * x588;
  const Real x646 = v[8] * (2.0 * x593) - x630;
  const Real x649 = 2.65358979335273e-06 * x623 - 0.9999999999964793 * x616 - x574 * v[8];
  const Real x650 = x593 * x593;
  const Real x653 = x650 + x598 * x598;
  const Real x655 = x488 * x593;
  const Real x657 = x655 - x608;
  const Real x660 = x593 * x598;
  const Real x662 = x497 + x660;
  const Real x665 = x540 + x650;
  const Real x667 = x488 * x598;
  // link 9 "right_finger": acceleration where nothing acts on it
  const Real x846 = x667 * 5.333337e-05 - 1.5e-05 * (x653 - x665);
  const Real x837 = x829 + x660 * 5e-06 - x657 * 1.5e-05;
  const Real x859 = x837 - x649 * 0.0005;
  const Real x863 = x603 * 6.66667e-05 + x846 + x646 * 0.0005;
  const Real x864 = x640 * 0.0015 + x863;
  w.x[26] = x864;
  const Real x856 = x655 * 5.833337e-05 - x662 * 1.5e-05 - x608 * 6.16667e-05;
  const Real x866 = x856 + x649 * 0.0015;
  const Real x871 = (x603 - x667) * 0.0005 - x653 * 0.0015;
  const Real x872 = x646 * 0.05 + x871;
  w.x[27] = x872;
  const Real x878 = x657 * 0.0015 - x662 * 0.0005 + x649 * 0.05;
  const Real x885 = (x603 + x667) * 0.0015 + x665 * 0.0005;
  const Real x887 = x640 * 0.05 + x885;
  w.x[28] = x887;
  // joint 8 "right_finger_slide": assembly: its two sides become one chain
  const Real x943 = x588 * 47.81116318204386;
  const Real x949 = x585 * 47.81116318204386 + -12.020625953341622;
  const Real x950 = x588 * 300.9051975855012;
  const Real x956 = 5.698005698005698 + x585 * 672.6812282367838;
  const Real x957 = x588 * 328.7950427750268;
  const Real x962 = -0.8107676238711207 - x585 * 328.7950427750268;
  const Real x970 = x588 * x957 + 2.3235294117647056;
  const Real x971 = x588 * 7.026218837536823;
  const Real x978 = 0.13 * x943 - x971 - x585 * x957;
  const Real x986 = x585 * 27.77777777777778 + 0.23529411764705882 + x588 * x943;
  const Real x995 = x585 * 7.026218837536823 + 0.11703803530578138;
  const Real x997 = x995 - 0.13 * x949 - x585 * x962;
  w.x[29] = x997;
  const Real x998 = x588 * x949;
  const Real x1004 = 1.2247360482654601 + x585 * 5.698005698005698;
  const Real x1019 = 2.65358979335273e-06 * x962 - 0.9999999999964793 * x957;
  const Real x1024 = 2.65358979335273e-06 * x957 + 0.9999999999964793 * x962;
  w.x[30] = x1024;
  const Real x1026 = 2.65358979335273e-06 * x943;
  const Real x1031 = 0.9999999999964793 * (x949 + 27.77777777777778) - x1026;
  const Real x1032 = 0.9999999999964793 * x1031;
  const Real x1036 = 2.65358979335273e-06 * x1031;
  w.x[31] = x1036;
  const Real x1065 = 2.65358979335273e-06 * (x970 - x997) + x978 * 1.9999999999929585;
  const Real x1068 = 0.9999999999964793 * x1065 - x978;
  w.x[32] = x1068;
  const Real x1069 = 2.65358979335273e-06 * x1065;
  w.x[33] = x1069;
  const Real x1073 = 3000.003000003 + x1019;
  const Real x1076 = x1032 - 27.77777777777778 + 1799.9964000071998;
  w.x[34] = x1076;
  const Real x1079 = x588 * x950 + x1004 + x585 * x956 + 25.999988000024;
  w.x[35] = x1079;
  require_more(w, x1079, 3.862007046714566e-13, kGrowth, 8);
  const Real x1080 = 0.9999999999964793 * x998 - 2.65358979335273e-06 * x986 + -17.999964000071998;
  w.x[36] = x1080;
  const Real x1081 = x970 - x1069 + 103.99992200024599;
  w.x[37] = x1081;
  require_more(w, x1081, 1.4946464345439562e-12, kGrowth, 8);
  const Real x1089 = x793 + x588 * x784 + 0.13 * x776;
  w.x[38] = x1089;
  const Real x1096 = 0.13 * x769 - x799 + x585 * x784;
  w.x[39] = x1096;
  // link 9 "right_finger": acceleration where nothing acts on it
  const Real x909 = x864 * 59999.880000239995 - x872 * 599.9988000024 - x887 * 1799.9964000071998;
  const Real x913 = x866 * 59999.880000239995 - x878 * 1799.9964000071998;
  const Real x921 = x872 * 25.999988000024 - x864 * 599.9988000024 + x887 * 17.999964000071998;
  const Real x927 = x859 * 3000.003000003 - x866 * 1799.9964000071998 + x878 * 103.99992200024599;
  // joint 8 "right_finger_slide": assembly: its two sides become one chain
  const Real x1129 = tau[8] * x1024;
  w.x[40] = x1129;
  const Real x1136 = x859 * 300000.3000003 + x878 * 3000.003000003 - x784 + x1129;
  w.x[41] = x1136;
  const Real x1124 = 0.9999999999964793 * x769 - 2.65358979335273e-06 * x776 + x909;
  const Real x1125 = 2.65358979335273e-06 * x769 + 0.9999999999964793 * x776 + x913;
  const Real x1126 = x588 * x769 - (x805 + x585 * x776) + x921;
  const Real x1127 = 0.9999999999964793 * x1089 + 2.65358979335273e-06 * x1096 + x927;
  const Real x1149 = x943 * 3.3296807285906615e-06;
  w.x[42] = x1149;
  const Real x1150 = x1073 * 3.3296807285906615e-06;
  w.x[43] = x1150;
  const Real x1075 = 0.9999999999964793 * x950 + 2.65358979335273e-06 * x956 + -599.9988000024;
  const Real x1159 = x1075 - x943 * 0.00015919590865819434;
  const Real x1162 = x943 + x1036 + x1073 * 0.00015919590865819434;
  const Real x1166 = x1159 * 1.658353407741297e-05;
  w.x[44] = x1166;
  const Real x1167 = x1162 * 1.658353407741297e-05;
  w.x[45] = x1167;
  const Real x1180 = 2.65358979335273e-06 * x950 - 0.9999999999964793 * x956 - x943 * 4.2244063836038523e-10;
  const Real x1181 = x1159 * 1.63606725685963e-08 + x1180;
  const Real x1186 = x1032 - x949 + -1799.9964000071998 - x1073 * 4.2244063836038523e-10;
  const Real x1187 = x1186 - x1162 * 1.63606725685963e-08;
  const Real x1189 = x1181 * 1.648191504944564e-05;
  w.x[46] = x1189;
  const Real x1190 = x1187 * 1.648191504944564e-05;
  w.x[47] = x1190;
  const Real x1198 = x1079 - x943 * x1149 - x1159 * x1166;
  const Real x1199 = x1198 - x1181 * x1189;
  w.x[48] = x1199;
  const Real x1206 = 0.9999999999964793 * x986 + 2.65358979335273e-06 * x998 + x1073 * x1149;
  const Real x1209 = x1162 * x1166 - x1206 - x1187 * x1189;
  const Real x1210 = 1 / x1199;
  w.x[49] = x1210;
  const Real x1211 = x1209 * x1210;
  w.x[50] = x1211;
  const Real x1222 = x1081 - (x1073 * x1150 + x1162 * x1167);
  const Real x1224 = x1222 - x1187 * x1190 - x1209 * x1211;
  w.x[51] = x1224;
  const Real x1225 = 1 / x1224;
  w.x[52] = x1225;
  const Real x1233 = x1124 - tau[8] * x1076 - x1136 * 0.00015919590865819434;
  w.x[53] = x1233;
  const Real x1238 = x1125 - tau[8] * x1036 - x1136 * 4.2244063836038523e-10;
  const Real x1239 = 1.63606725685963e-08 * x1233 + x1238;
  w.x[54] = x1239;
  const Real x1246 = x1126 - tau[8] * x1080 - x1136 * x1149;
  const Real x1248 = x1246 - x1166 * x1233 - x1189 * x1239;
  w.x[55] = x1248;
  const Real x1257 = x1127 - tau[8] * x1068 - x1136 * x1150;
  const Real x1259 = x1167 * x1233 + x1257 - x1190 * x1239;
  const Real x1260 = x1259 - x1211 * x1248;
  w.x[56] = x1260;
  const Real x1269 = x1026 - 0.9999999999964793 * x949;
  w.x[57] = x1269;
  const Real x1293 = 2.65358979335273e-06 * x971 - 0.9999999999964793 * x995;
  w.x[58] = x1293;
  const Real x1343 = 47.81116318204386 * x1149 - x950 + x1166 * 300.897586242875;
  const Real x1344 = x1189 * 0.0008033816505865777 + x1343;
  w.x[59] = x1344;
  const Real x1351 = x956 - x1166 * 0.0017850200414291078 + x1189 * 672.6812282343863;
  w.x[60] = x1351;
  const Real x1359 = x943 - 328.7950427750268 * x1149 - x1166 * 47.758820356278655;
  const Real x1360 = x1359 - x1189 * 0.0001275136846625453;
  w.x[61] = x1360;
  const Real x1366 = -0.5054466230936819 - x585 * 59.67078189300412 + x1166 * 0.00015834177779265263;
  const Real x1367 = x1366 - x1189 * 59.670781892791446;
  w.x[62] = x1367;
  const Real x1377 = 7.026218837536823 * x1149 - x588 * 27.097049732773534 + x1166 * 27.095931187385858;
  const Real x1378 = x1189 * 7.234479409858621e-05 + x1377;
  w.x[63] = x1378;
  const Real x1385 = x1004 - x1166 * 1.5120169762693617e-05 + x1189 * 5.69800569798539;
  w.x[64] = x1385;
  const Real x1394 = 0.9999999999964793 * x943 + 2.65358979335273e-06 * x949 + 47.81116318204386 * x1150;
  const Real x1396 = x1394 - x1167 * 300.897586242875 + x1190 * 0.0008033816505865777;
  const Real x1397 = x1396 - x1211 * x1344;
  w.x[65] = x1397;
  const Real x1405 = -27.77777777767998 + x1167 * 0.0017850200414291078 + x1190 * 672.6812282343863;
  const Real x1406 = x1405 - x1211 * x1351;
  w.x[66] = x1406;
  const Real x1416 = x1019 - 328.7950427750268 * x1150 + x1167 * 47.758820356278655;
  const Real x1418 = x1416 - x1190 * 0.0001275136846625453 - x1211 * x1360;
  w.x[67] = x1418;
  const Real x1426 = 1.2875816993418725 - x1167 * 0.00015834177779265263 - x1190 * 59.670781892791446;
  const Real x1427 = x1426 - x1211 * x1367;
  w.x[68] = x1427;
  const Real x1436 = 0.9999999999964793 * x971 + 2.65358979335273e-06 * x995 + 7.026218837536823 * x1150;
  const Real x1438 = x1436 - x1167 * 27.095931187385858 + x1190 * 7.234479409858621e-05;
  const Real x1439 = x1438 - x1211 * x1378;
  w.x[69] = x1439;
  const Real x1447 = -0.2352941176462304 + x1167 * 1.5120169762693617e-05 + x1190 * 5.69800569798539;
  const Real x1448 = x1447 - x1211 * x1385;
  w.x[70] = x1448;
  const Real x1464 = x1210 * x1344;
  w.x[71] = x1464;
  const Real x1465 = x1210 * x1351;
  w.x[72] = x1465;
  const Real x1466 = x1210 * x1360;
  w.x[73] = x1466;
  const Real x1467 = x1210 * x1367;
  w.x[74] = x1467;
  const Real x1468 = x1210 * x1378;
  w.x[75] = x1468;
  const Real x1469 = x1210 * x1385;
  w.x[76] = x1469;
  const Real x1470 = x1225 * x1397;
  w.x[77] = x1470;
  const Real x1471 = x1225 * x1406;
  w.x[78] = x1471;
  const Real x1472 = x1225 * x1418;
  w.x[79] = x1472;
  const Real x1473 = x1225 * x1427;
  w.x[80] = x1473;
  const Real x1474 = x1225 * x1439;
  w.x[81] = x1474;
  const Real x1475 = x1225 * x1448;
  w.x[82] = x1475;
  const Real x1490 = 299.3961237250212 - x1344 * x1464 - x1397 * x1470;
  w.x[83] = x1490;
  const Real x1501 = -3.290040935476213e-24 - x1344 * x1465 - x1397 * x1471;
  w.x[84] = x1501;
  const Real x1516 = -47.52050645167994 - x1344 * x1466 - x1397 * x1472;
  w.x[85] = x1516;
  const Real x1527 = 2.918459841587135e-25 - x1344 * x1467 - x1397 * x1473;
  w.x[86] = x1527;
  const Real x1542 = 26.96072397096317 - x1344 * x1468 - x1397 * x1474;
  w.x[87] = x1542;
  const Real x1553 = -2.786858204168086e-26 - x1344 * x1469 - x1397 * x1475;
  w.x[88] = x1553;
  const Real x1565 = 665.2231611029742 - x1351 * x1465 - x1406 * x1471;
  w.x[89] = x1565;
  const Real x1576 = 5.221991839953887e-25 - x1351 * x1466 - x1406 * x1472;
  w.x[90] = x1576;
  const Real x1588 = -59.009207467252075 - x1351 * x1467 - x1406 * x1473;
  w.x[91] = x1588;
  const Real x1599 = -2.96269318423145e-25 - x1351 * x1468 - x1406 * x1474;
  w.x[92] = x1599;
}

ADAGEN_NOINLINE void part_1_1(Workspace& w) {
  ADAGEN_INPUTS
  const Real x769 = w.x[12];
  const Real x776 = w.x[13];
  const Real x784 = w.x[14];
  const Real x793 = w.x[15];
  const Real x799 = w.x[16];
  const Real x805 = w.x[17];
  const Real x1129 = w.x[40];
  const Real x1136 = w.x[41];
  const Real x1233 = w.x[53];
  const Real x1239 = w.x[54];
  const Real x1248 = w.x[55];
  const Real x1260 = w.x[56];
  const Real x1269 = w.x[57];
  const Real x1293 = w.x[58];
  const Real x1351 = w.x[60];
  const Real x1360 = w.x[61];
  const Real x1367 = w.x[62];
  const Real x1378 = w.x[63];
  const Real x1385 = w.x[64];
  const Real x1406 = w.x[66];
  const Real x1418 = w.x[67];
  const Real x1427 = w.x[68];
  const Real x1439 = w.x[69];
  const Real x1448 = w.x[70];
  const Real x1464 = w.x[71];
  const Real x1465 = w.x[72];
  const Real x1466 = w.x[73];
  const Real x1467 = w.x[74];
  const Real x1468 = w.x[75];
  const Real x1469 = w.x[76];
  const Real x1470 = w.x[77];
  const Real x1471 = w.x[78];
  const Real x1472 = w.x[79];
  const Real x1473 = w.x[80];
  const Real x1474 = w.x[81];
  const Real x1475 = w.x[82];
  const Real x1490 = w.x[83];
  const Real x1501 = w.x[84];
  const Real x1516 = w.x[85];
  const Real x1527 = w.x[86];
  const Real x1542 = w.x[87];
  const Real x1553 = w.x[88];
  const Real x1565 = w.x[89];
  const Real x1576 = w.x[90];
  const Real x1588 = w.x[91];
  const Real x1599 = w.x[92];
  const Real x1883 = w.x[21];
  const Real x1889 = w.x[22];
  const Real x1893 = w.x[23];
  const Real x1900 = w.x[24];
  const Real x1906 = w.x[25];
  const Real x2813 = w.x[6];
  const Real x2817 = w.x[7];
  const Real x2823 = w.x[8];
  const Real x2830 = w.x[9];
  const Real x2837 = w.x[10];
  const Real x2845 = w.x[11];
  // joint 8 "right_finger_slide": assembly: its two sides become one chain
  const Real x1611 = 5.634831482284017 - x1351 * x1469 - x1406 * x1475;
  const Real x1626 = 328.3972582458297 - x1360 * x1466 - x1418 * x1472;
  w.x[93] = x1626;
  const Real x1637 = -4.632213938029683e-26 - x1360 * x1467 - x1418 * x1473;
  w.x[94] = x1637;
  const Real x1652 = -6.997066406854872 - x1360 * x1468 - x1418 * x1474;
  w.x[95] = x1652;
  const Real x1663 = 4.423334264431528e-27 - x1360 * x1469 - x1418 * x1475;
  w.x[96] = x1663;
  const Real x1675 = 6.410934403565655 - x1367 * x1467 - x1427 * x1473;
  const Real x1686 = 2.628083130482957e-26 - x1367 * x1468 - x1427 * x1474;
  const Real x1698 = -0.4998426985461352 - x1367 * x1469 - x1427 * x1475;
  const Real x1713 = 3.6273146653411508 - x1378 * x1468 - x1439 * x1474;
  const Real x1724 = -2.5095754031136986e-27 - x1378 * x1469 - x1439 * x1475;
  const Real x1736 = 1.224200925496994 - x1385 * x1469 - x1448 * x1475;
  const Real x1759 = x1136 * 0.00015919590865875482 + x1233 * 0.004989945375270026 + x1239 * 1.3241268117251393e-08;
  const Real x1770 = x1233 * 2.9601940685904722e-08 - x1239 * 0.011087074859115907 + x1248 * x1465;
  const Real x1778 = x1136 * 0.0010947825175841488 + x1233 * 0.0007920100248753914 + x1239 * 2.101669718249871e-09;
  const Real x1788 = x1239 * 0.0009834887580909876 - x1233 * 2.6258662679026073e-09 + x1248 * x1467;
  const Real x1803 = x1136 * 2.339506545820704e-05 + x1233 * 0.00044934629820525036 + x1239 * 1.1923807506025343e-09;
  const Real x1814 = x1233 * 2.507458505158988e-10 - x1239 * 9.39140458654524e-05 + x1248 * x1469;
  const Real x1762 = x1248 * x1464 - x1759 + x1260 * x1470;
  const Real x1806 = x1248 * x1468 - x1803 + x1260 * x1474;
  const Real x1822 = tau[8] * x1269 + x1762 + x769;
  w.x[97] = x1822;
  const Real x1824 = x1260 * x1471 + x1770 - tau[8] * 7.371082759313139e-05 + x776;
  const Real x1818 = x1248 * x1466 + x1778 + x1260 * x1472 - x1129;
  const Real x1826 = x784 + x1818;
  w.x[98] = x1826;
  const Real x1828 = x1260 * x1473 + x1788 + tau[8] * 3.4167136554933856e-06 + x793;
  const Real x1830 = tau[8] * x1293 + x1806 + x799;
  w.x[99] = x1830;
  const Real x1832 = x1260 * x1475 + x1814 - tau[8] * 6.243740690241717e-07 + x805;
  // joint 7 "left_finger_slide": assembly: its two sides become one chain
  const Real x1921 = q[7] * x1516;
  const Real x1923 = 0.13 * x1501;
  const Real x1926 = x1527 - x1921 + x1923;
  const Real x1929 = x1542 - 0.13 * x1490;
  w.x[100] = x1929;
  const Real x1932 = x1553 + q[7] * x1490;
  const Real x1938 = x1588 - q[7] * x1576 + 0.13 * x1565;
  const Real x1939 = x1599 - x1923;
  w.x[101] = x1939;
  const Real x1942 = x1611 + q[7] * x1501;
  const Real x1948 = x1637 - q[7] * x1626 + 0.13 * x1576;
  const Real x1951 = x1652 - 0.13 * x1516;
  w.x[102] = x1951;
  const Real x1952 = x1663 + x1921;
  const Real x1962 = x1675 - q[7] * x1637 + 0.13 * x1588;
  const Real x1972 = x1686 - q[7] * x1652 + 0.13 * x1599;
  const Real x1973 = x1972 - 0.13 * x1926;
  w.x[103] = x1973;
  const Real x1981 = x1698 - q[7] * x1663 + 0.13 * x1611;
  const Real x1987 = x1713 - 0.13 * x1542;
  w.x[104] = x1987;
  const Real x1993 = x1724 - 0.13 * x1553;
  w.x[105] = x1993;
  const Real x1999 = x1736 + q[7] * x1553;
  const Real x2001 = 300000.3000003 + x1626;
  require_more(w, x2001, 4.265036626975881e-09, kGrowth, 7);
  require_more(w, x2001, 0.0, kFactorization, 7);
  const Real x2002 = 3000.003000003 + x1948;
  const Real x2003 = 59999.880000239995 + x1490;
  w.x[106] = x2003;
  require_more(w, x2003, 8.544255267675666e-10, kGrowth, 7);
  const Real x2005 = 1799.9964000071998 + x1929;
  w.x[107] = x2005;
  const Real x2006 = 59999.880000239995 + x1565;
  w.x[108] = x2006;
  require_more(w, x2006, 8.544255267675666e-10, kGrowth, 7);
  const Real x2008 = q[7] * x1932 + x1999 + 25.999988000024;
  w.x[109] = x2008;
  require_more(w, x2008, 3.862007046714566e-13, kGrowth, 7);
  const Real x2009 = q[7] * x1929 + x1993 + -17.999964000071998;
  w.x[110] = x2009;
  const Real x2010 = x1962 - q[7] * x1948 + 0.13 * x1938 + 103.99992200024599;
  w.x[111] = x2010;
  require_more(w, x2010, 1.4946464345439562e-12, kGrowth, 7);
  const Real x2031 = tau[7] * x1951;
  w.x[112] = x2031;
  const Real x2033 = tau[7] * x1939;
  const Real x2037 = x1883 - x1826 - x2031;
  w.x[113] = x2037;
  const Real x2029 = q[7] * x1826 - x1828 - 0.13 * x1824 + x1906;
  const Real x2043 = 1 / x2001;
  w.x[114] = x2043;
  const Real x2044 = x1516 * x2043;
  w.x[115] = x2044;
  const Real x2045 = x1576 * x2043;
  w.x[116] = x2045;
  const Real x2046 = x1952 * x2043;
  w.x[117] = x2046;
  const Real x2047 = x2002 * x2043;
  w.x[118] = x2047;
  const Real x2048 = x1516 * x2044;
  const Real x2050 = x2003 - x2048;
  w.x[119] = x2050;
  const Real x2053 = x1501 - x1576 * x2044;
  w.x[120] = x2053;
  const Real x2056 = -599.9988000024 + x1932 - x1952 * x2044;
  const Real x2059 = x1926 - x2002 * x2044;
  const Real x2060 = 1 / x2050;
  w.x[121] = x2060;
  const Real x2061 = x2053 * x2060;
  w.x[122] = x2061;
  const Real x2062 = x2056 * x2060;
  w.x[123] = x2062;
  const Real x2063 = x2059 * x2060;
  w.x[124] = x2063;
  const Real x2064 = x1576 * x2045;
  const Real x2066 = x2053 * x2061;
  const Real x2069 = x2006 - x2064 - x2066;
  w.x[125] = x2069;
  const Real x2075 = x1942 - x1952 * x2045 - x2056 * x2061;
  const Real x2081 = -1799.9964000071998 + x1938 - x2002 * x2045 - x2059 * x2061;
  const Real x2082 = 1 / x2069;
  w.x[126] = x2082;
  const Real x2083 = x2075 * x2082;
  w.x[127] = x2083;
  const Real x2084 = x2081 * x2082;
  w.x[128] = x2084;
  const Real x2092 = x2008 - x1952 * x2046 - x2056 * x2062;
  const Real x2093 = x2092 - x2075 * x2083;
  w.x[129] = x2093;
  const Real x2100 = q[7] * x1926 + x1981 - x2002 * x2046;
  const Real x2102 = x2100 - x2059 * x2062 - x2081 * x2083;
  const Real x2103 = 1 / x2093;
  w.x[130] = x2103;
  const Real x2104 = x2102 * x2103;
  w.x[131] = x2104;
  const Real x2114 = x2010 - x2002 * x2047 - x2059 * x2063;
  const Real x2116 = x2114 - x2081 * x2084 - x2102 * x2104;
  w.x[132] = x2116;
  const Real x2117 = 1 / x2116;
  w.x[133] = x2117;
  const Real x2122 = x2037 * x2044;
  const Real x2124 = x1889 - x1822 - tau[7] * x2005 - x2122;
  w.x[134] = x2124;
  const Real x2125 = x2037 * x2045;
  const Real x2127 = x2061 * x2124;
  const Real x2130 = x1893 - x1824 - x2033 - x2125 - x2127;
  w.x[135] = x2130;
  const Real x2040 = x1900 - (x1832 + q[7] * x1822) - tau[7] * x2009;
  const Real x2138 = x2040 - x2037 * x2046 - x2062 * x2124;
  const Real x2139 = x2138 - x2083 * x2130;
  w.x[136] = x2139;
  const Real x2148 = x2029 - tau[7] * x1973 - x2037 * x2047;
  const Real x2150 = x2148 - x2063 * x2124 - x2084 * x2130;
  const Real x2151 = x2150 - x2104 * x2139;
  w.x[137] = x2151;
  const Real x2154 = x1686 - 0.13 * x1527;
  w.x[138] = x2154;
  const Real x2161 = x1490 - x2048;
  w.x[139] = x2161;
  const Real x2164 = x1516 - x1626 * x2044;
  w.x[140] = x2164;
  const Real x2167 = x1527 - x1637 * x2044;
  w.x[141] = x2167;
  const Real x2170 = x1542 - x1652 * x2044;
  w.x[142] = x2170;
  const Real x2173 = x1553 - x1663 * x2044;
  w.x[143] = x2173;
  const Real x2179 = x1501 - x1516 * x2045 - x2061 * x2161;
  w.x[144] = x2179;
  const Real x2181 = x1565 - x2064 - x2066;
  w.x[145] = x2181;
  const Real x2187 = x1576 - x1626 * x2045 - x2061 * x2164;
  w.x[146] = x2187;
  const Real x2193 = x1588 - x1637 * x2045 - x2061 * x2167;
  w.x[147] = x2193;
  const Real x2199 = x1599 - x1652 * x2045 - x2061 * x2170;
  w.x[148] = x2199;
  const Real x2205 = x1611 - x1663 * x2045 - x2061 * x2173;
  w.x[149] = x2205;
  const Real x2213 = x1932 - x1516 * x2046 - x2062 * x2161;
  const Real x2214 = x2213 - x2083 * x2179;
  w.x[150] = x2214;
  const Real x2222 = x1942 - x1576 * x2046 - x2053 * x2062;
  const Real x2223 = x2222 - x2083 * x2181;
  w.x[151] = x2223;
  const Real x2231 = x1952 - x1626 * x2046 - x2062 * x2164;
  const Real x2232 = x2231 - x2083 * x2187;
  w.x[152] = x2232;
  const Real x2239 = x1698 + q[7] * x1527 - x1637 * x2046;
  const Real x2241 = x2239 - x2062 * x2167 - x2083 * x2193;
  w.x[153] = x2241;
  const Real x2248 = x1724 + q[7] * x1542 - x1652 * x2046;
  const Real x2250 = x2248 - x2062 * x2170 - x2083 * x2199;
  w.x[154] = x2250;
  const Real x2258 = x1999 - x1663 * x2046 - x2062 * x2173;
  const Real x2259 = x2258 - x2083 * x2205;
  w.x[155] = x2259;
  const Real x2269 = x1926 - x1516 * x2047 - x2063 * x2161;
  const Real x2271 = x2269 - x2084 * x2179 - x2104 * x2214;
  w.x[156] = x2271;
  const Real x2281 = x1938 - x1576 * x2047 - x2053 * x2063;
  const Real x2283 = x2281 - x2084 * x2181 - x2104 * x2223;
  w.x[157] = x2283;
  const Real x2293 = x1948 - x1626 * x2047 - x2063 * x2164;
  const Real x2295 = x2293 - x2084 * x2187 - x2104 * x2232;
  w.x[158] = x2295;
  const Real x2305 = x1962 - x1637 * x2047 - x2063 * x2167;
  const Real x2307 = x2305 - x2084 * x2193 - x2104 * x2241;
  w.x[159] = x2307;
  const Real x2317 = x1972 - x1652 * x2047 - x2063 * x2170;
  const Real x2319 = x2317 - x2084 * x2199 - x2104 * x2250;
  w.x[160] = x2319;
  const Real x2329 = x1981 - x1663 * x2047 - x2063 * x2173;
  const Real x2331 = x2329 - x2084 * x2205 - x2104 * x2259;
  w.x[161] = x2331;
  const Real x2332 = x1626 * x2043;
  w.x[162] = x2332;
  const Real x2333 = x1637 * x2043;
  const Real x2334 = x1652 * x2043;
  const Real x2335 = x1663 * x2043;
  const Real x2336 = x2060 * x2161;
  const Real x2337 = x2060 * x2164;
  w.x[163] = x2337;
  const Real x2338 = x2060 * x2167;
  const Real x2339 = x2060 * x2170;
  const Real x2340 = x2060 * x2173;
  const Real x2341 = x2082 * x2179;
  const Real x2342 = x2082 * x2181;
  const Real x2343 = x2082 * x2187;
  w.x[164] = x2343;
  const Real x2344 = x2082 * x2193;
  const Real x2345 = x2082 * x2199;
  const Real x2346 = x2082 * x2205;
  const Real x2347 = x2103 * x2214;
  const Real x2348 = x2103 * x2223;
  const Real x2349 = x2103 * x2232;
  w.x[165] = x2349;
  const Real x2350 = x2103 * x2241;
  const Real x2351 = x2103 * x2250;
  const Real x2352 = x2103 * x2259;
  const Real x2353 = x2117 * x2271;
  const Real x2354 = x2117 * x2283;
  const Real x2355 = x2117 * x2295;
  w.x[166] = x2355;
  const Real x2356 = x2117 * x2307;
  const Real x2357 = x2117 * x2319;
  const Real x2358 = x2117 * x2331;
  const Real x2368 = x2161 - x2161 * x2336 - x2179 * x2341;
  const Real x2378 = x2179 - x2179 * x2342 - x2214 * x2348;
  const Real x2379 = x2378 - x2271 * x2354;
  const Real x2391 = x1516 - x1516 * x2332 - x2161 * x2337;
  const Real x2393 = x2391 - x2179 * x2343 - x2214 * x2349;
  const Real x2394 = x2393 - x2271 * x2355;
  w.x[167] = x2394;
  const Real x2406 = x1527 - x1516 * x2333 - x2161 * x2338;
  const Real x2408 = x2406 - x2179 * x2344 - x2214 * x2350;
  const Real x2409 = x2408 - x2271 * x2356;
  const Real x2421 = x1542 - x1516 * x2334 - x2161 * x2339;
  const Real x2423 = x2421 - x2179 * x2345 - x2214 * x2351;
  const Real x2436 = x1553 - x1516 * x2335 - x2161 * x2340;
  const Real x2438 = x2436 - x2179 * x2346 - x2214 * x2352;
  const Real x2447 = x2181 - x2181 * x2342 - x2223 * x2348;
  const Real x2460 = x1576 - x1576 * x2332 - x2053 * x2337;
  const Real x2462 = x2460 - x2181 * x2343 - x2223 * x2349;
  const Real x2463 = x2462 - x2283 * x2355;
  w.x[168] = x2463;
  const Real x2475 = x1588 - x1576 * x2333 - x2053 * x2338;
  const Real x2477 = x2475 - x2181 * x2344 - x2223 * x2350;
  const Real x2490 = x1599 - x1576 * x2334 - x2053 * x2339;
  const Real x2492 = x2490 - x2181 * x2345 - x2223 * x2351;
  const Real x2505 = x1611 - x1576 * x2335 - x2053 * x2340;
  const Real x2507 = x2505 - x2181 * x2346 - x2223 * x2352;
  const Real x2535 = x1637 - x1626 * x2333 - x2164 * x2338;
  const Real x2537 = x2535 - x2187 * x2344 - x2232 * x2350;
  const Real x2550 = x1652 - x1626 * x2334 - x2164 * x2339;
  const Real x2552 = x2550 - x2187 * x2345 - x2232 * x2351;
  const Real x2565 = x1663 - x1626 * x2335 - x2164 * x2340;
  const Real x2567 = x2565 - x2187 * x2346 - x2232 * x2352;
  const Real x2568 = x2567 - x2295 * x2358;
  w.x[169] = x2568;
  const Real x2580 = x1675 - x1637 * x2333 - x2167 * x2338;
  const Real x2582 = x2580 - x2193 * x2344 - x2241 * x2350;
  const Real x2595 = x1686 - x1637 * x2334 - x2167 * x2339;
  const Real x2597 = x2595 - x2193 * x2345 - x2241 * x2351;
  const Real x2610 = x1698 - x1637 * x2335 - x2167 * x2340;
  const Real x2612 = x2610 - x2193 * x2346 - x2241 * x2352;
  const Real x2625 = x1713 - x1652 * x2334 - x2170 * x2339;
  const Real x2627 = x2625 - x2199 * x2345 - x2250 * x2351;
  const Real x2640 = x1724 - x1652 * x2335 - x2170 * x2340;
  const Real x2642 = x2640 - x2199 * x2346 - x2250 * x2352;
  const Real x2655 = x1736 - x1663 * x2335 - x2173 * x2340;
  const Real x2657 = x2655 - x2205 * x2346 - x2259 * x2352;
  const Real x2668 = x2122 + x2124 * x2336 + x2130 * x2341;
  const Real x2676 = x2125 + x2127 + x2130 * x2342 + x2139 * x2348;
  const Real x2693 = x2037 * x2333 + x2124 * x2338 + x2130 * x2344;
  const Real x2702 = x2037 * x2334 + x2124 * x2339 + x2130 * x2345;
  const Real x2711 = x2037 * x2335 + x2124 * x2340 + x2130 * x2346;
  const Real x2670 = x2139 * x2347 + x2668 + x2151 * x2353;
  const Real x2695 = x2139 * x2350 + x2693 + x2151 * x2356;
  const Real x2704 = x2139 * x2351 + x2702 + x2151 * x2357;
  const Real x2713 = x2139 * x2352 + x2711 + x2151 * x2358;
  // joint 6 "flange_roll": assembly: its two sides become one chain
  const Real x2876 = cosine[6] * 2.8255423871896722e-05 - sine[6] * 38.46153846153846;
  const Real x2881 = sine[6] * 2.8255423871896722e-05 + cosine[6] * 38.46153846153846;
  const Real x2915 = cosine[6] * 1.9230769230758853 + 2.0 * sine[6] * 1.4127711935948361e-06;
  const Real x2920 = cosine[6] * x2915;
  const Real x2924 = x2368 - x2214 * x2347 - x2271 * x2353 + 769.2307692307693;
  require_more(w, x2924, 7.919928947270557e-12, kGrowth, 6);
  require_more(w, x2924, 0.0, kFactorization, 6);
  const Real x2925 = x2423 - x2271 * x2357 + -7.692307692255798;
  const Real x2926 = x2438 - x2271 * x2358 + x2876;
  const Real x2927 = x2447 - x2283 * x2354 + 769.2307692307693;
  w.x[170] = x2927;
  require_more(w, x2927, 1.3203184105450422e-11, kGrowth, 6);
  const Real x2931 = x2537 - x2295 * x2356 - x2876;
  w.x[171] = x2931;
  const Real x2932 = x2552 - x2295 * x2357 + x2881;
  w.x[172] = x2932;
  const Real x2933 = x2582 - x2307 * x2356 + (2.7692307692297313 - x2920);
  w.x[173] = x2933;
  require_more(w, x2933, 1.028702558297553e-13, kGrowth, 6);
  const Real x2901 = cosine[6] * 0.3846153846127899 + sine[6] * 2.825542387170617e-07;
  const Real x2936 = x2627 - x2319 * x2357 + (0.8461538461538461 + x2920);
  w.x[174] = x2936;
  require_more(w, x2936, 6.265402802508093e-14, kGrowth, 6);
  const Real x2907 = sine[6] * 0.3846153846127899 - cosine[6] * 2.825542387170617e-07;
  const Real x2938 = x2657 - x2331 * x2358 + 2.6923076923087303;
  w.x[175] = x2938;
  require_more(w, x2938, 2.8335972750372623e-14, kGrowth, 6);
  const Real x2941 = x2837 + 0.09 * x2823;
  const Real x2945 = 0.09 * x2817 - x2845;
  const Real x2950 = 3.673205103346574e-06 * x2817 - 0.9999999999932537 * x2823;
  const Real x2967 = 3.673205103346574e-06 * x2941 + 0.9999999999932537 * x2945;
  // joint 7 "left_finger_slide": assembly: its two sides become one chain
  const Real x2720 = tau[7] * x1929 + x2670 + x1822;
  const Real x2722 = x2151 * x2354 + x2676 + x2033 + x1824;
  const Real x2726 = tau[7] * x2154 + x2695 + x1828;
  const Real x2728 = tau[7] * x1987 + x2704 + x1830;
  const Real x2730 = tau[7] * x1993 + x2713 + x1832;
  // joint 6 "flange_roll": assembly: its two sides become one chain
  const Real x2981 = sine[6] * x2950 - cosine[6] * x2813 + x2720;
  const Real x2993 = x2981 - x2394 * tau[6];
  w.x[176] = x2993;
  const Real x2982 = sine[6] * x2813 + cosine[6] * x2950 + x2722;
  const Real x2984 = sine[6] * x2967 - cosine[6] * x2830 + x2726;
  const Real x2985 = sine[6] * x2830 + cosine[6] * x2967 + x2728;
  const Real x2986 = 0.9999999999932537 * x2941 - 3.673205103346574e-06 * x2945 + x2730;
  const Real x3004 = 1 / x2924;
  w.x[177] = x3004;
  const Real x3005 = x2379 * x3004;
  w.x[178] = x3005;
  const Real x3006 = x2409 * x3004;
  w.x[179] = x3006;
  const Real x3007 = x2925 * x3004;
  w.x[180] = x3007;
  const Real x3008 = x2926 * x3004;
  w.x[181] = x3008;
  const Real x3011 = x2927 - x2379 * x3005;
  w.x[182] = x3011;
  const Real x3014 = x2477 - x2283 * x2356 + 7.692307692255798 - x2409 * x3005;
  const Real x3017 = x2492 - x2283 * x2357 - x2925 * x3005;
  const Real x3020 = x2507 - x2283 * x2358 - x2881 - x2926 * x3005;
  const Real x3021 = 1 / x3011;
  w.x[183] = x3021;
  const Real x3022 = x3014 * x3021;
  w.x[184] = x3022;
  const Real x3023 = x3017 * x3021;
  w.x[185] = x3023;
  const Real x3024 = x3020 * x3021;
  w.x[186] = x3024;
  const Real x3030 = x2933 - x2409 * x3006 - x3014 * x3022;
  w.x[187] = x3030;
  const Real x2934 = x2597 - x2307 * x2357 + (-1.4127711935948361e-06 + sine[6] * x2915);
  const Real x3036 = x2934 - x2925 * x3006 - x3017 * x3022;
  const Real x3041 = x2612 - x2307 * x2358 - x2901 - x2926 * x3006;
  const Real x3042 = x3041 - x3020 * x3022;
  const Real x3043 = 1 / x3030;
  w.x[188] = x3043;
  const Real x3044 = x3036 * x3043;
  w.x[189] = x3044;
  const Real x3045 = x3042 * x3043;
  w.x[190] = x3045;
  const Real x3053 = x2936 - x2925 * x3007 - x3017 * x3023;
  const Real x3054 = x3053 - x3036 * x3044;
  w.x[191] = x3054;
  const Real x3061 = x2642 - x2319 * x2358 + x2907 - x2926 * x3007;
  const Real x3063 = x3061 - x3020 * x3023 - x3042 * x3044;
  const Real x3064 = 1 / x3054;
  w.x[192] = x3064;
  const Real x3065 = x3063 * x3064;
  w.x[193] = x3065;
  const Real x3075 = x2938 - x2926 * x3008 - x3020 * x3024;
  const Real x3077 = x3075 - x3042 * x3045 - x3063 * x3065;
  w.x[194] = x3077;
  const Real x3078 = 1 / x3077;
  w.x[195] = x3078;
  const Real x3085 = x2982 - x2463 * tau[6] - x2993 * x3005;
  w.x[196] = x3085;
  const Real x3090 = x2984 - tau[6] * x2931 - x2993 * x3006;
  const Real x3091 = x3090 - x3022 * x3085;
  w.x[197] = x3091;
  const Real x3098 = x2985 - tau[6] * x2932 - x2993 * x3007;
  const Real x3100 = x3098 - x3023 * x3085 - x3044 * x3091;
  w.x[198] = x3100;
  const Real x3109 = x2986 - x2568 * tau[6] - x2993 * x3008;
  const Real x3111 = x3109 - x3024 * x3085 - x3045 * x3091;
  const Real x3112 = x3111 - x3065 * x3100;
  w.x[199] = x3112;
  const Real x3113 = cosine[6] * 769.2307692307693;
  w.x[200] = x3113;
  const Real x3116 = sine[6] * 7.692307692255798;
  w.x[201] = x3116;
  const Real x3118 = cosine[6] * 7.692307692255798;
  const Real x3123 = sine[6] * 0.0028255423871896726;
  w.x[202] = x3123;
  const Real x3135 = sine[6] * 769.2307692255798;
  w.x[203] = x3135;
  const Real x3138 = cosine[6] * 7.6923076923076925;
  const Real x3142 = sine[6] * 7.6923076923076925;
  const Real x3161 = sine[6] * 30.769230769023192;
  w.x[204] = x3161;
  const Real x3179 = x3138 + sine[6] * 0.00011302169548758689;
  w.x[205] = x3179;
  const Real x3193 = sine[6] * 769.2307692307693 + x3005 * x3113;
  w.x[206] = x3193;
  const Real x3197 = x3005 * x3123 - cosine[6] * 0.0028255423871896726;
  w.x[207] = x3197;
  const Real x3200 = cosine[6] * 769.2307692255798 - x3005 * x3135;
  w.x[208] = x3200;
  const Real x3203 = x3118 - x3005 * x3116;
  w.x[209] = x3203;
  const Real x3206 = x3005 * x3161 - cosine[6] * 30.769230769023192;
  w.x[210] = x3206;
  const Real x3209 = x3142 - cosine[6] * 0.00011302169548758689 + x3005 * x3179;
  w.x[211] = x3209;
  const Real x3216 = x3022 * x3193 - (x3116 + x3006 * x3113);
  w.x[212] = x3216;
  const Real x3222 = x3006 * x3123 - sine[6] * 38.46153846127899 - x3022 * x3197;
  w.x[213] = x3222;
  const Real x3227 = x3138 - sine[6] * 0.00014127711935948362 - x3006 * x3135;
  const Real x3228 = x3227 - x3022 * x3200;
  w.x[214] = x3228;
  const Real x3233 = cosine[6] * 0.8461538461538461 - sine[6] * 1.4127711935948361e-06 - x3006 * x3116;
  const Real x3234 = x3233 - x3022 * x3203;
  w.x[215] = x3234;
  const Real x3239 = sine[6] * 2.8255423871896723e-06 - cosine[6] * 0.3076923076923077 + x3006 * x3161;
  const Real x3240 = x3239 - x3022 * x3206;
  w.x[216] = x3240;
  const Real x3246 = x3006 * x3179 - sine[6] * 0.6923076923030216 - x3022 * x3209;
  w.x[217] = x3246;
  const Real x3255 = x3023 * x3193 - (x3118 + x3007 * x3113);
  const Real x3256 = x3255 - x3044 * x3216;
  w.x[218] = x3256;
  const Real x3264 = x3007 * x3123 - cosine[6] * 38.46153846127899 - x3023 * x3197;
  const Real x3265 = x3264 - x3044 * x3222;
  w.x[219] = x3265;
  const Real x3272 = x3142 + cosine[6] * 0.00014127711935948362 + x3007 * x3135;
  const Real x3276 = x3023 * x3200 + x3272 + x3044 * x3228;
  w.x[220] = x3276;
  const Real x3284 = sine[6] * 0.8461538461538461 + cosine[6] * 1.4127711935948361e-06 + x3007 * x3116;
  const Real x3288 = x3023 * x3203 + x3284 + x3044 * x3234;
  w.x[221] = x3288;
  const Real x3296 = sine[6] * 0.3076923076923077 + cosine[6] * 2.8255423871896723e-06 + x3007 * x3161;
  const Real x3298 = x3296 - x3023 * x3206 - x3044 * x3240;
  w.x[222] = x3298;
  const Real x3306 = x3007 * x3179 - cosine[6] * 0.6923076923030216 - x3023 * x3209;
  const Real x3307 = x3306 - x3044 * x3246;
  w.x[223] = x3307;
  const Real x3317 = 2.8255423871896722e-05 - x3008 * x3113 + x3024 * x3193;
  const Real x3319 = x3317 - x3045 * x3216 - x3065 * x3256;
  w.x[224] = x3319;
  const Real x3329 = 0.00014127711935948362 + x3008 * x3123 - x3024 * x3197;
  const Real x3331 = x3329 - x3045 * x3222 - x3065 * x3265;
  w.x[225] = x3331;
  const Real x3341 = -38.46153846127899 - x3008 * x3135 - x3024 * x3200;
  const Real x3343 = x3341 - x3045 * x3228 + x3065 * x3276;
  w.x[226] = x3343;
  const Real x3353 = -0.3846153846127899 - x3008 * x3116 - x3024 * x3203;
  const Real x3355 = x3353 - x3045 * x3234 + x3065 * x3288;
  w.x[227] = x3355;
  const Real x3365 = 0.7692307692255798 + x3008 * x3161 - x3024 * x3206;
  const Real x3367 = x3365 - x3045 * x3240 - x3065 * x3298;
  w.x[228] = x3367;
  const Real x3377 = 2.5429881484707045e-06 + x3008 * x3179 - x3024 * x3209;
  const Real x3379 = x3377 - x3045 * x3246 - x3065 * x3307;
  w.x[229] = x3379;
  const Real x3380 = x3004 * x3113;
  w.x[230] = x3380;
  const Real x3381 = x3004 * x3123;
  w.x[231] = x3381;
  const Real x3383 = x3004 * x3135;
  w.x[232] = x3383;
  const Real x3384 = x3004 * x3116;
  w.x[233] = x3384;
  const Real x3385 = x3004 * x3161;
  w.x[234] = x3385;
  const Real x3387 = x3004 * x3179;
  w.x[235] = x3387;
  const Real x3389 = x3021 * x3193;
  w.x[236] = x3389;
  const Real x3391 = x3021 * x3197;
  w.x[237] = x3391;
  const Real x3392 = x3021 * x3200;
  w.x[238] = x3392;
  const Real x3393 = x3021 * x3203;
  w.x[239] = x3393;
  const Real x3394 = x3021 * x3206;
  w.x[240] = x3394;
  const Real x3395 = x3021 * x3209;
  w.x[241] = x3395;
  const Real x3396 = x3043 * x3216;
  w.x[242] = x3396;
  const Real x3397 = x3043 * x3222;
  w.x[243] = x3397;
  const Real x3398 = x3043 * x3228;
  w.x[244] = x3398;
  const Real x3399 = x3043 * x3234;
  w.x[245] = x3399;
  const Real x3400 = x3043 * x3240;
  w.x[246] = x3400;
  const Real x3401 = x3043 * x3246;
  w.x[247] = x3401;
  const Real x3402 = x3064 * x3256;
  w.x[248] = x3402;
  const Real x3403 = x3064 * x3265;
  w.x[249] = x3403;
  const Real x3404 = x3064 * x3276;
  w.x[250] = x3404;
  const Real x3406 = x3064 * x3288;
  w.x[251] = x3406;
  const Real x3408 = x3064 * x3298;
  w.x[252] = x3408;
  const Real x3409 = x3064 * x3307;
  w.x[253] = x3409;
  const Real x3410 = x3078 * x3319;
  w.x[254] = x3410;
  const Real x3411 = x3078 * x3331;
  w.x[255] = x3411;
  const Real x3412 = x3078 * x3343;
  w.x[256] = x3412;
  const Real x3413 = x3078 * x3355;
  w.x[257] = x3413;
  const Real x3414 = x3078 * x3367;
  w.x[258] = x3414;
  const Real x3415 = x3078 * x3379;
  w.x[259] = x3415;
  const Real x3416 = x3113 * x3380;
  w.x[260] = x3416;
  const Real x3417 = x3193 * x3389;
  w.x[261] = x3417;
  const Real x3419 = x3216 * x3396;
  w.x[262] = x3419;
}

ADAGEN_NOINLINE void part_1_2(Workspace& w) {
  ADAGEN_INPUTS
  const Real x2813 = w.x[6];
  const Real x2817 = w.x[7];
  const Real x2830 = w.x[9];
  const Real x2837 = w.x[10];
  const Real x2845 = w.x[11];
  const Real x2993 = w.x[176];
  const Real x3085 = w.x[196];
  const Real x3091 = w.x[197];
  const Real x3100 = w.x[198];
  const Real x3112 = w.x[199];
  const Real x3113 = w.x[200];
  const Real x3116 = w.x[201];
  const Real x3123 = w.x[202];
  const Real x3135 = w.x[203];
  const Real x3161 = w.x[204];
  const Real x3179 = w.x[205];
  const Real x3193 = w.x[206];
  const Real x3197 = w.x[207];
  const Real x3200 = w.x[208];
  const Real x3203 = w.x[209];
  const Real x3206 = w.x[210];
  const Real x3209 = w.x[211];
  const Real x3216 = w.x[212];
  const Real x3222 = w.x[213];
  const Real x3228 = w.x[214];
  const Real x3234 = w.x[215];
  const Real x3240 = w.x[216];
  const Real x3246 = w.x[217];
  const Real x3256 = w.x[218];
  const Real x3265 = w.x[219];
  const Real x3276 = w.x[220];
  const Real x3288 = w.x[221];
  const Real x3298 = w.x[222];
  const Real x3307 = w.x[223];
  const Real x3319 = w.x[224];
  const Real x3331 = w.x[225];
  const Real x3343 = w.x[226];
  const Real x3355 = w.x[227];
  const Real x3367 = w.x[228];
  const Real x3379 = w.x[229];
  const Real x3380 = w.x[230];
  const Real x3381 = w.x[231];
  const Real x3383 = w.x[232];
  const Real x3384 = w.x[233];
  const Real x3385 = w.x[234];
  const Real x3387 = w.x[235];
  const Real x3389 = w.x[236];
  const Real x3391 = w.x[237];
  const Real x3392 = w.x[238];
  const Real x3393 = w.x[239];
  const Real x3394 = w.x[240];
  const Real x3395 = w.x[241];
  const Real x3396 = w.x[242];
  const Real x3397 = w.x[243];
  const Real x3398 = w.x[244];
  const Real x3399 = w.x[245];
  const Real x3400 = w.x[246];
  const Real x3401 = w.x[247];
  const Real x3402 = w.x[248];
  const Real x3403 = w.x[249];
  const Real x3404 = w.x[250];
  const Real x3406 = w.x[251];
  const Real x3408 = w.x[252];
  const Real x3409 = w.x[253];
  const Real x3410 = w.x[254];
  const Real x3411 = w.x[255];
  const Real x3412 = w.x[256];
  const Real x3413 = w.x[257];
  const Real x3414 = w.x[258];
  const Real x3415 = w.x[259];
  const Real x3416 = w.x[260];
  const Real x3417 = w.x[261];
  const Real x3419 = w.x[262];
  const Real x3904 = w.x[0];
  const Real x3907 = w.x[1];
  const Real x3910 = w.x[2];
  const Real x3915 = w.x[3];
  const Real x3921 = w.x[4];
  const Real x3927 = w.x[5];
  // joint 6 "flange_roll": assembly: its two sides become one chain
  const Real x3429 = 769.2307692307693 - x3416 - x3417 - x3419 - x3256 * x3402;
  const Real x3442 = x3113 * x3381 + x3193 * x3391 - x3216 * x3397;
  const Real x3456 = x3193 * x3392 - x3113 * x3383 - x3216 * x3398;
  const Real x3470 = x3193 * x3393 - x3113 * x3384 - x3216 * x3399;
  const Real x3484 = x3113 * x3385 + x3193 * x3394 - x3216 * x3400;
  const Real x3498 = -7.6923076923076925 + x3113 * x3387 + x3193 * x3395;
  const Real x3500 = x3498 - x3216 * x3401 - x3256 * x3409;
  const Real x3513 = 769.2307692307693 - x3123 * x3381 - x3197 * x3391;
  const Real x3515 = x3513 - x3222 * x3397 - x3265 * x3403;
  const Real x3528 = x3123 * x3383 - x3197 * x3392 - x3222 * x3398;
  const Real x3542 = x3123 * x3384 - x3197 * x3393 - x3222 * x3399;
  const Real x3557 = x3123 * x3385 + x3197 * x3394 + x3222 * x3400;
  const Real x3574 = 30.76923076923077 - x3123 * x3387 - x3197 * x3395;
  const Real x3576 = x3574 - x3222 * x3401 - x3265 * x3409;
  const Real x3604 = 7.6923076923076925 - x3135 * x3384 - x3200 * x3393;
  const Real x3606 = x3604 - x3228 * x3399 - x3276 * x3406;
  const Real x3619 = -30.76923076923077 + x3135 * x3385 - x3200 * x3394;
  const Real x3621 = x3619 - x3228 * x3400 + x3276 * x3408;
  const Real x3634 = x3135 * x3387 - x3200 * x3395 - x3228 * x3401;
  const Real x3636 = x3276 * x3409 + x3634 - x3343 * x3415;
  w.x[25] = x3636;
  const Real x3648 = 0.8461538461538461 - x3116 * x3384 - x3203 * x3393;
  const Real x3650 = x3648 - x3234 * x3399 - x3288 * x3406;
  const Real x3663 = -0.3076923076923077 + x3116 * x3385 - x3203 * x3394;
  const Real x3665 = x3663 - x3234 * x3400 + x3288 * x3408;
  const Real x3678 = x3116 * x3387 - x3203 * x3395 - x3234 * x3401;
  const Real x3692 = 2.0 - x3161 * x3385 - x3206 * x3394;
  const Real x3694 = x3692 - x3240 * x3400 - x3298 * x3408;
  const Real x3708 = x3161 * x3387 + x3206 * x3395 + x3240 * x3401;
  const Real x3725 = 2.076923076923077 - x3179 * x3387 - x3209 * x3395;
  const Real x3727 = x3725 - x3246 * x3401 - x3307 * x3409;
  const Real x3745 = x2993 * x3380 - x3085 * x3389 + x3091 * x3396;
  const Real x3755 = x3085 * x3391 - x2993 * x3381 + x3091 * x3397;
  const Real x3775 = x2993 * x3384 + x3085 * x3393 + x3091 * x3399;
  const Real x3785 = x3085 * x3394 - x2993 * x3385 + x3091 * x3400;
  const Real x3795 = x3085 * x3395 - x2993 * x3387 + x3091 * x3401;
  const Real x3757 = x3100 * x3403 + x3755 + x3112 * x3411;
  const Real x3777 = x3775 - x3100 * x3406 + x3112 * x3413;
  const Real x3787 = x3100 * x3408 + x3785 + x3112 * x3414;
  const Real x3797 = x3100 * x3409 + x3795 + x3112 * x3415;
  // joint 5 "wrist_pitch": assembly: its two sides become one chain
  const Real x3956 = sine[5] * 3.581214756510659;
  const Real x3957 = sine[5] * x3956;
  const Real x3960 = cosine[5] * x3956;
  const Real x3975 = cosine[5] * 358.12147564864995;
  const Real x3980 = cosine[5] * x3975;
  const Real x3999 = cosine[5] * 1.4620640450453781;
  const Real x4002 = cosine[5] * x3999;
  const Real x4005 = x3429 - x3319 * x3410 + (580.973129987906 - x3980);
  require_more(w, x4005, 1.2260061762262752e-11, kGrowth, 5);
  require_more(w, x4005, 0.0, kFactorization, 5);
  // joint 6 "flange_roll": assembly: its two sides become one chain
  const Real x3444 = x3442 - x3256 * x3403 - x3319 * x3411;
  // joint 5 "wrist_pitch": assembly: its two sides become one chain
  const Real x4006 = x3444 + sine[5] * x3975;
  // joint 6 "flange_roll": assembly: its two sides become one chain
  const Real x3458 = x3256 * x3404 + x3456 - x3319 * x3412;
  // joint 5 "wrist_pitch": assembly: its two sides become one chain
  const Real x4007 = x3458 - sine[5] * 0.001315453631979501;
  w.x[24] = x4007;
  const Real x4008 = x3256 * x3406 + x3470 - x3319 * x3413 + x3960;
  // joint 6 "flange_roll": assembly: its two sides become one chain
  const Real x3486 = x3484 - x3256 * x3408 - x3319 * x3414;
  // joint 5 "wrist_pitch": assembly: its two sides become one chain
  const Real x4009 = -2.2284510569908056 - x3957 + x3486;
  const Real x4010 = x3500 - x3319 * x3415 + cosine[5] * 17.828140532818548;
  const Real x4011 = x3515 - x3331 * x3411 + (222.85165433925602 + x3980);
  w.x[23] = x4011;
  require_more(w, x4011, 1.2260061762262752e-11, kGrowth, 5);
  // joint 6 "flange_roll": assembly: its two sides become one chain
  const Real x3530 = x3265 * x3404 + x3528 - x3331 * x3412;
  // joint 5 "wrist_pitch": assembly: its two sides become one chain
  const Real x4012 = x3530 - cosine[5] * 0.001315453631979501;
  w.x[22] = x4012;
  // joint 6 "flange_roll": assembly: its two sides become one chain
  const Real x3544 = x3265 * x3406 + x3542 - x3331 * x3413;
  // joint 5 "wrist_pitch": assembly: its two sides become one chain
  const Real x4018 = x3606 - x3343 * x3413 - cosine[5] * 17.828153687354867;
  w.x[21] = x4018;
  const Real x4019 = x3621 - x3343 * x3414 + sine[5] * 17.828153687354867;
  w.x[92] = x4019;
  const Real x4020 = x3650 - x3355 * x3413 + (0.6105191498427811 + x4002);
  w.x[91] = x4020;
  require_more(w, x4020, 2.0383895677461698e-14, kGrowth, 5);
  // joint 6 "flange_roll": assembly: its two sides become one chain
  const Real x3680 = x3288 * x3409 + x3678 - x3355 * x3415;
  // joint 5 "wrist_pitch": assembly: its two sides become one chain
  const Real x4023 = x3694 - x3367 * x3414 + (2.0725831948881592 - x4002);
  w.x[89] = x4023;
  require_more(w, x4023, 3.678103573346401e-14, kGrowth, 5);
  // joint 6 "flange_roll": assembly: its two sides become one chain
  const Real x3712 = x3298 * x3409 + x3708 + x3367 * x3415;
  // joint 5 "wrist_pitch": assembly: its two sides become one chain
  const Real x4026 = x3727 - x3379 * x3415 + 2.014487191597677;
  w.x[88] = x4026;
  require_more(w, x4026, 3.787417840386417e-14, kGrowth, 5);
  const Real x4031 = 3.673205103346574e-06 * x3907 - 0.9999999999932537 * x3910;
  const Real x4049 = 3.673205103346574e-06 * x3921 - 0.9999999999932537 * x3927;
  // joint 6 "flange_roll": assembly: its two sides become one chain
  const Real x3803 = x3100 * x3402 + x3745 + x3112 * x3410 + x2813;
  const Real x3805 = x3757 - tau[6] * 769.2307692255798 + x2817;
  const Real x3809 = x3777 - tau[6] * 2.8255423871896722e-05 + x2830;
  const Real x3811 = tau[6] * 0.00011302169548758689 + x3787 + x2837;
  const Real x3813 = x3797 - tau[6] * 30.769230769023192 + x2845;
  // joint 5 "wrist_pitch": assembly: its two sides become one chain
  const Real x4063 = sine[5] * x4031 - cosine[5] * x3904 + x3803;
  const Real x4075 = x4063 - tau[5] * x4007;
  w.x[87] = x4075;
  const Real x4064 = sine[5] * x3904 + cosine[5] * x4031 + x3805;
  const Real x4066 = sine[5] * x4049 - cosine[5] * x3915 + x3809;
  const Real x4067 = sine[5] * x3915 + cosine[5] * x4049 + x3811;
  const Real x4068 = 0.9999999999932537 * x3921 + 3.673205103346574e-06 * x3927 + x3813;
  const Real x4085 = 1 / x4005;
  w.x[86] = x4085;
  const Real x4086 = x4006 * x4085;
  w.x[84] = x4086;
  const Real x4087 = x4008 * x4085;
  w.x[83] = x4087;
  const Real x4088 = x4009 * x4085;
  w.x[82] = x4088;
  const Real x4089 = x4010 * x4085;
  w.x[81] = x4089;
  const Real x4092 = x4011 - x4006 * x4086;
  w.x[80] = x4092;
  const Real x4095 = 5.809665813501464 - x3957 + x3544 - x4008 * x4086;
  const Real x4014 = x3265 * x3408 + x3557 + x3331 * x3414 + x3960;
  const Real x4098 = x4014 + x4009 * x4086;
  const Real x4016 = x3576 - x3331 * x3415 - sine[5] * 17.828140532818548;
  const Real x4102 = x4016 - x4010 * x4086;
  const Real x4103 = 1 / x4092;
  w.x[79] = x4103;
  const Real x4104 = x4095 * x4103;
  w.x[78] = x4104;
  const Real x4105 = x4098 * x4103;
  w.x[77] = x4105;
  const Real x4107 = x4102 * x4103;
  w.x[76] = x4107;
  const Real x4113 = x4020 - x4008 * x4087 - x4095 * x4104;
  w.x[75] = x4113;
  const Real x4021 = x3665 - x3355 * x3414 - sine[5] * x3999;
  const Real x4119 = x4021 - x4009 * x4087 + x4098 * x4104;
  const Real x4124 = x3680 - sine[5] * 0.17827616641363966 - x4010 * x4087;
  const Real x4125 = x4124 - x4102 * x4104;
  const Real x4126 = 1 / x4113;
  w.x[74] = x4126;
  const Real x4127 = x4119 * x4126;
  w.x[73] = x4127;
  const Real x4128 = x4125 * x4126;
  w.x[72] = x4128;
  const Real x4136 = x4023 - x4009 * x4088 - x4098 * x4105;
  const Real x4137 = x4136 - x4119 * x4127;
  w.x[71] = x4137;
  const Real x4144 = x3712 + cosine[5] * 0.17827616641363966 + x4010 * x4088;
  const Real x4147 = x4102 * x4105 - x4144 - x4125 * x4127;
  const Real x4148 = 1 / x4137;
  w.x[40] = x4148;
  const Real x4149 = x4147 * x4148;
  w.x[17] = x4149;
  const Real x4159 = x4026 - x4010 * x4089 - x4102 * x4107;
  const Real x4161 = x4159 - x4125 * x4128 - x4147 * x4149;
  w.x[16] = x4161;
  const Real x4162 = 1 / x4161;
  w.x[15] = x4162;
  const Real x4169 = x4064 - tau[5] * x4012 - x4075 * x4086;
  w.x[14] = x4169;
  const Real x4174 = x4066 - tau[5] * x4018 - x4075 * x4087;
  const Real x4175 = x4174 - x4104 * x4169;
  w.x[13] = x4175;
  const Real x4182 = x4067 - tau[5] * x4019 - x4075 * x4088;
  const Real x4184 = x4105 * x4169 + x4182 - x4127 * x4175;
  w.x[12] = x4184;
  const Real x4193 = x4068 - x3636 * tau[5] - x4075 * x4089;
  const Real x4195 = x4193 - x4107 * x4169 - x4128 * x4175;
  const Real x4196 = x4195 - x4149 * x4184;
  w.x[263] = x4196;
  const Real x4197 = cosine[5] * 222.85165433925602;
  w.x[264] = x4197;
  const Real x4208 = sine[5] * 0.0008185798340081819;
  w.x[265] = x4208;
  const Real x4212 = cosine[5] * 17.828132347140482;
  w.x[266] = x4212;
  const Real x4213 = sine[5] * 17.828132347140482;
  const Real x4217 = sine[5] * 580.9731299888185;
  w.x[267] = x4217;
  const Real x4222 = sine[5] * 5.809665813501464;
  w.x[268] = x4222;
  const Real x4236 = cosine[5] * 2.2285165433925602;
  w.x[269] = x4236;
  const Real x4249 = sine[5] * 222.85165433925602 + x4086 * x4197;
  w.x[270] = x4249;
  const Real x4253 = x4086 * x4208 - cosine[5] * 0.0008185798340081819;
  w.x[271] = x4253;
  const Real x4256 = cosine[5] * 580.9731299888185 - x4086 * x4217;
  w.x[272] = x4256;
  const Real x4259 = cosine[5] * 5.809665813501464 - x4086 * x4222;
  w.x[273] = x4259;
  const Real x4262 = x4213 + x4086 * x4212;
  w.x[274] = x4262;
  const Real x4265 = sine[5] * 2.2285165433925602 + x4086 * x4236;
  w.x[275] = x4265;
  const Real x4272 = x4104 * x4249 - (sine[5] * 2.2284510569908056 + x4087 * x4197);
  w.x[276] = x4272;
  const Real x4278 = x4212 + x4087 * x4208 - x4104 * x4253;
  w.x[277] = x4278;
  const Real x4284 = cosine[5] * 5.809731299927379 - x4087 * x4217 - x4104 * x4256;
  w.x[278] = x4284;
  const Real x4290 = cosine[5] * 2.0725831948881592 - x4087 * x4222 - x4104 * x4259;
  w.x[279] = x4290;
  const Real x4296 = sine[5] * 0.17827392385038013 + x4087 * x4212 - x4104 * x4262;
  w.x[280] = x4296;
  const Real x4302 = sine[5] * 0.6105198046835867 + x4087 * x4236 - x4104 * x4265;
  w.x[281] = x4302;
  const Real x4311 = cosine[5] * 2.2284510569908056 + x4088 * x4197 + x4105 * x4249;
  const Real x4313 = x4127 * x4272 + x4311;
  w.x[282] = x4313;
  const Real x4322 = x4088 * x4208 - x4213 + x4105 * x4253;
  const Real x4323 = x4322 - x4127 * x4278;
  w.x[283] = x4323;
  const Real x4332 = x4105 * x4256 - (sine[5] * 5.809731299927379 + x4088 * x4217);
  const Real x4333 = x4332 - x4127 * x4284;
  w.x[284] = x4333;
  const Real x4342 = x4105 * x4259 - (sine[5] * 2.0725831948881592 + x4088 * x4222);
  const Real x4343 = x4342 - x4127 * x4290;
  w.x[285] = x4343;
  const Real x4351 = cosine[5] * 0.17827392385038013 + x4088 * x4212 + x4105 * x4262;
  const Real x4352 = x4351 - x4127 * x4296;
  w.x[286] = x4352;
  const Real x4360 = cosine[5] * 0.6105198046835867 + x4088 * x4236 + x4105 * x4265;
  const Real x4361 = x4360 - x4127 * x4302;
  w.x[287] = x4361;
  const Real x4371 = 17.828140532818548 - x4089 * x4197 + x4107 * x4249;
  const Real x4373 = x4371 - x4128 * x4272 + x4149 * x4313;
  w.x[288] = x4373;
  const Real x4383 = x4089 * x4208 - x4107 * x4253 - x4128 * x4278;
  const Real x4384 = x4383 - x4149 * x4323;
  w.x[289] = x4384;
  const Real x4395 = x4089 * x4217 + x4107 * x4256 + x4128 * x4284;
  const Real x4397 = x4149 * x4333 + x4395;
  w.x[290] = x4397;
  const Real x4409 = x4089 * x4222 + x4107 * x4259 + x4128 * x4290;
  const Real x4411 = x4149 * x4343 + x4409;
  w.x[291] = x4411;
  const Real x4422 = -2.0144865367391627 + x4089 * x4212 - x4107 * x4262;
  const Real x4424 = x4422 - x4128 * x4296 - x4149 * x4352;
  w.x[292] = x4424;
  const Real x4434 = -0.17828356603706982 + x4089 * x4236 - x4107 * x4265;
  const Real x4436 = x4434 - x4128 * x4302 - x4149 * x4361;
  w.x[293] = x4436;
  const Real x4437 = x4085 * x4197;
  const Real x4438 = x4085 * x4208;
  const Real x4440 = x4085 * x4217;
  const Real x4441 = x4085 * x4222;
  const Real x4442 = x4085 * x4212;
  const Real x4444 = x4085 * x4236;
  const Real x4446 = x4103 * x4249;
  const Real x4448 = x4103 * x4253;
  const Real x4449 = x4103 * x4256;
  const Real x4450 = x4103 * x4259;
  const Real x4451 = x4103 * x4262;
  const Real x4452 = x4103 * x4265;
  const Real x4453 = x4126 * x4272;
  const Real x4454 = x4126 * x4278;
  const Real x4455 = x4126 * x4284;
  const Real x4456 = x4126 * x4290;
  const Real x4457 = x4126 * x4296;
  const Real x4458 = x4126 * x4302;
  const Real x4459 = x4148 * x4313;
  const Real x4461 = x4148 * x4323;
  const Real x4462 = x4148 * x4333;
  const Real x4463 = x4148 * x4343;
  const Real x4464 = x4148 * x4352;
  const Real x4465 = x4148 * x4361;
  const Real x4466 = x4162 * x4373;
  const Real x4467 = x4162 * x4384;
  const Real x4468 = x4162 * x4397;
  const Real x4470 = x4162 * x4411;
  const Real x4472 = x4162 * x4424;
  const Real x4473 = x4162 * x4436;
  const Real x4485 = 222.85165433925602 - x4197 * x4437 - x4249 * x4446;
  const Real x4487 = x4485 - x4272 * x4453 - x4313 * x4459;
  const Real x4488 = x4487 - x4373 * x4466;
  w.to[0][0] = x4488;
  const Real x4500 = x4197 * x4438 + x4249 * x4448 - x4272 * x4454;
  const Real x4502 = x4313 * x4461 + x4500 - x4373 * x4467;
  w.to[0][1] = x4502;
  const Real x4514 = x4249 * x4449 - x4197 * x4440 - x4272 * x4455;
  const Real x4516 = x4313 * x4462 + x4514 + x4373 * x4468;
  w.to[0][2] = x4516;
  const Real x4528 = x4249 * x4450 - x4197 * x4441 - x4272 * x4456;
  const Real x4530 = x4313 * x4463 + x4528 + x4373 * x4470;
  w.to[0][3] = x4530;
  const Real x4542 = -17.828132347140482 + x4197 * x4442 + x4249 * x4451;
  const Real x4544 = x4542 - x4272 * x4457 + x4313 * x4464;
  const Real x4545 = x4544 - x4373 * x4472;
  w.to[0][4] = x4545;
  const Real x4557 = -2.2285165433925602 + x4197 * x4444 + x4249 * x4452;
  const Real x4559 = x4557 - x4272 * x4458 + x4313 * x4465;
  const Real x4560 = x4559 - x4373 * x4473;
  w.to[0][5] = x4560;
  const Real x4572 = 222.85165433925602 - x4208 * x4438 - x4253 * x4448;
  const Real x4574 = x4572 - x4278 * x4454 - x4323 * x4461;
  const Real x4575 = x4574 - x4384 * x4467;
  w.to[0][6] = x4575;
  const Real x4587 = x4208 * x4440 - x4253 * x4449 - x4278 * x4455;
  const Real x4589 = x4587 - x4323 * x4462 + x4384 * x4468;
  w.to[0][7] = x4589;
  const Real x4601 = 17.828132347140482 + x4208 * x4441 - x4253 * x4450;
  const Real x4603 = x4601 - x4278 * x4456 - x4323 * x4463;
  const Real x4604 = x4384 * x4470 + x4603;
  w.to[0][8] = x4604;
  const Real x4617 = x4208 * x4442 + x4253 * x4451 + x4278 * x4457;
  const Real x4622 = -(x4323 * x4464 + x4617 + x4384 * x4472);
  w.to[0][9] = x4622;
  const Real x4635 = x4208 * x4444 + x4253 * x4452 + x4278 * x4458;
  const Real x4640 = -(x4323 * x4465 + x4635 + x4384 * x4473);
  w.to[0][10] = x4640;
  const Real x4652 = 580.9731299927379 - x4217 * x4440 - x4256 * x4449;
  const Real x4654 = x4652 - x4284 * x4455 - x4333 * x4462;
  const Real x4655 = x4654 - x4397 * x4468;
  w.to[0][11] = x4655;
  const Real x4667 = 5.809731299927379 - x4217 * x4441 - x4256 * x4450;
  const Real x4669 = x4667 - x4284 * x4456 - x4333 * x4463;
  const Real x4670 = x4669 - x4397 * x4470;
  w.to[0][12] = x4670;
  const Real x4682 = x4217 * x4442 - x4256 * x4451 - x4284 * x4457;
  const Real x4684 = x4682 - x4333 * x4464 + x4397 * x4472;
  w.to[0][13] = x4684;
  const Real x4696 = x4217 * x4444 - x4256 * x4452 - x4284 * x4458;
  const Real x4698 = x4696 - x4333 * x4465 + x4397 * x4473;
  w.to[0][14] = x4698;
  const Real x4710 = 2.0725831948881592 - x4222 * x4441 - x4259 * x4450;
  const Real x4712 = x4710 - x4290 * x4456 - x4343 * x4463;
  const Real x4713 = x4712 - x4411 * x4470;
  w.to[0][15] = x4713;
  const Real x4725 = x4222 * x4442 - x4259 * x4451 - x4290 * x4457;
  const Real x4727 = x4725 - x4343 * x4464 + x4411 * x4472;
  w.to[0][16] = x4727;
  const Real x4739 = x4222 * x4444 - x4259 * x4452 - x4290 * x4458;
  const Real x4741 = x4739 - x4343 * x4465 + x4411 * x4473;
  w.to[0][17] = x4741;
  const Real x4753 = 2.0144858818888856 - x4212 * x4442 - x4262 * x4451;
  const Real x4755 = x4753 - x4296 * x4457 - x4352 * x4464;
  const Real x4756 = x4755 - x4424 * x4472;
  w.to[0][18] = x4756;
  const Real x4768 = 0.17828132347140482 - x4212 * x4444 - x4262 * x4452;
  const Real x4770 = x4768 - x4296 * x4458 - x4352 * x4465;
  const Real x4771 = x4770 - x4424 * x4473;
  w.to[0][19] = x4771;
  const Real x4783 = 0.6105204595515726 - x4236 * x4444 - x4265 * x4452;
  const Real x4785 = x4783 - x4302 * x4458 - x4361 * x4465;
  const Real x4786 = x4785 - x4436 * x4473;
  w.to[0][20] = x4786;
  const Real x4803 = x4075 * x4437 - x4169 * x4446 + x4175 * x4453;
  const Real x4813 = x4169 * x4448 - x4075 * x4438 + x4175 * x4454;
  const Real x4823 = x4075 * x4440 + x4169 * x4449 + x4175 * x4455;
  const Real x4833 = x4075 * x4441 + x4169 * x4450 + x4175 * x4456;
  const Real x4843 = x4169 * x4451 - x4075 * x4442 + x4175 * x4457;
  const Real x4853 = x4169 * x4452 - x4075 * x4444 + x4175 * x4458;
  const Real x4815 = x4184 * x4461 + x4813 + x4196 * x4467;
  const Real x4825 = x4184 * x4462 + x4823 - x4196 * x4468;
  const Real x4835 = x4184 * x4463 + x4833 - x4196 * x4470;
  const Real x4860 = -(x4803 - x4184 * x4459 + x4196 * x4466 + x3904);
  w.to[0][21] = x4860;
  const Real x4862 = -(x4815 - tau[5] * 222.8516543377526 + x3907);
  w.to[0][22] = x4862;
  const Real x4864 = -(x4825 - tau[5] * 0.0021340334659965573 + x3910);
  w.to[0][23] = x4864;
  const Real x4866 = -(x4835 - tau[5] * 17.828153687354867 + x3915);
  w.to[0][24] = x4866;
  const Real x4868 = -(x4184 * x4464 + x4843 + x4196 * x4472 + x3921);
  w.to[0][25] = x4868;
  const Real x4870 = -(x4184 * x4465 + x4853 + x4196 * x4473 + x3927);
  w.to[0][26] = x4870;
}

ADAGEN_NOINLINE void part_1_3(Workspace& w) {
  ADAGEN_INPUTS
  const Real x864 = w.x[26];
  const Real x872 = w.x[27];
  const Real x887 = w.x[28];
  const Real x997 = w.x[29];
  const Real x1069 = w.x[33];
  const Real x1079 = w.x[35];
  const Real x1081 = w.x[37];
  const Real x1089 = w.x[38];
  const Real x1096 = w.x[39];
  const Real x1199 = w.x[48];
  const Real x1224 = w.x[51];
  const Real x1626 = w.x[93];
  const Real x1822 = w.x[97];
  const Real x1826 = w.x[98];
  const Real x1830 = w.x[99];
  const Real x1861 = w.x[18];
  const Real x1869 = w.x[19];
  const Real x1880 = w.x[20];
  const Real x1929 = w.x[100];
  const Real x1987 = w.x[104];
  const Real x2003 = w.x[106];
  const Real x2006 = w.x[108];
  const Real x2008 = w.x[109];
  const Real x2010 = w.x[111];
  const Real x2031 = w.x[112];
  const Real x2037 = w.x[113];
  const Real x2050 = w.x[119];
  const Real x2069 = w.x[125];
  const Real x2093 = w.x[129];
  const Real x2116 = w.x[132];
  const Real x2124 = w.x[134];
  const Real x2130 = w.x[135];
  const Real x2139 = w.x[136];
  const Real x2151 = w.x[137];
  const Real x2164 = w.x[140];
  const Real x2187 = w.x[146];
  const Real x2232 = w.x[152];
  const Real x2295 = w.x[158];
  const Real x2332 = w.x[162];
  const Real x2337 = w.x[163];
  const Real x2343 = w.x[164];
  const Real x2349 = w.x[165];
  const Real x2355 = w.x[166];
  const Real x2817 = w.x[7];
  const Real x2823 = w.x[8];
  const Real x2927 = w.x[170];
  const Real x2933 = w.x[173];
  const Real x2936 = w.x[174];
  const Real x2938 = w.x[175];
  const Real x2993 = w.x[176];
  const Real x3011 = w.x[182];
  const Real x3030 = w.x[187];
  const Real x3054 = w.x[191];
  const Real x3077 = w.x[194];
  const Real x3085 = w.x[196];
  const Real x3091 = w.x[197];
  const Real x3100 = w.x[198];
  const Real x3112 = w.x[199];
  const Real x3135 = w.x[203];
  const Real x3200 = w.x[208];
  const Real x3228 = w.x[214];
  const Real x3276 = w.x[220];
  const Real x3343 = w.x[226];
  const Real x3383 = w.x[232];
  const Real x3392 = w.x[238];
  const Real x3398 = w.x[244];
  const Real x3404 = w.x[250];
  const Real x3412 = w.x[256];
  const Real x3907 = w.x[1];
  const Real x3910 = w.x[2];
  const Real x4011 = w.x[23];
  const Real x4020 = w.x[91];
  const Real x4023 = w.x[89];
  const Real x4026 = w.x[88];
  const Real x4092 = w.x[80];
  const Real x4113 = w.x[75];
  const Real x4137 = w.x[71];
  const Real x4161 = w.x[16];
  // joint 8 "right_finger_slide": assembly: its two sides become one chain
  const Real x1229 = x1079 * 1.7763568394002505e-15;
  require_more(w, x1199, x1229, kFactorization, 8);
  const Real x1230 = x1081 * 1.7763568394002505e-15;
  require_more(w, x1224, x1230, kFactorization, 8);
  // link 9 "right_finger": acceleration where nothing acts on it
  const Real x934 = x864 * 1799.9964000071998 - x872 * 17.999964000071998 - x887 * 73.999892000216;
  // joint 8 "right_finger_slide": assembly: its two sides become one chain
  const Real x1128 = 2.65358979335273e-06 * x1089 - 0.9999999999964793 * x1096 + x934;
  const Real x1141 = x1128 - tau[8] * (x997 + x1069 + 73.999892000216);
  w.x[5] = x1141;
  // joint 7 "left_finger_slide": assembly: its two sides become one chain
  const Real x2118 = 1.7763568394002505e-15 * x2003;
  require_more(w, x2050, x2118, kFactorization, 7);
  const Real x2119 = 1.7763568394002505e-15 * x2006;
  require_more(w, x2069, x2119, kFactorization, 7);
  const Real x2120 = 1.7763568394002505e-15 * x2008;
  require_more(w, x2093, x2120, kFactorization, 7);
  const Real x2121 = 1.7763568394002505e-15 * x2010;
  require_more(w, x2116, x2121, kFactorization, 7);
  const Real x2520 = x1626 - x1626 * x2332 - x2164 * x2337;
  const Real x2522 = x2520 - x2187 * x2343 - x2232 * x2349;
  // link 8 "left_finger": acceleration where nothing acts on it
  const Real x1912 = 73.999892000216 * x1880 - 17.999964000071998 * x1869 + 1799.9964000071998 * x1861;
  // joint 7 "left_finger_slide": assembly: its two sides become one chain
  const Real x2036 = tau[7] * (x1987 - 0.13 * x1929 + 73.999892000216);
  const Real x2042 = 0.13 * x1822 - x1830 + x1912 - x2036;
  w.x[4] = x2042;
  const Real x2684 = x2037 * x2332 + x2124 * x2337 + x2130 * x2343;
  const Real x2716 = x2139 * x2349 + x2684 + x2151 * x2355 + x2031;
  // joint 6 "flange_roll": assembly: its two sides become one chain
  const Real x3079 = 1.7763568394002505e-15 * x2927;
  require_more(w, x3011, x3079, kFactorization, 6);
  const Real x3080 = 1.7763568394002505e-15 * x2933;
  require_more(w, x3030, x3080, kFactorization, 6);
  const Real x3081 = 1.7763568394002505e-15 * x2936;
  require_more(w, x3054, x3081, kFactorization, 6);
  const Real x3082 = 1.7763568394002505e-15 * x2938;
  require_more(w, x3077, x3082, kFactorization, 6);
  const Real x2983 = x1826 + x2716 + (0.9999999999932537 * x2817 + 3.673205103346574e-06 * x2823);
  const Real x2995 = x2983 - tau[6] * (x2522 - x2295 * x2355 + 769.2307692307693);
  w.x[3] = x2995;
  const Real x3589 = 769.2307692307693 - x3135 * x3383 - x3200 * x3392;
  const Real x3765 = x2993 * x3383 + x3085 * x3392 + x3091 * x3398;
  const Real x3591 = x3589 - x3228 * x3398 - x3276 * x3404;
  const Real x3767 = x3765 - x3100 * x3404 + x3112 * x3412;
  // joint 5 "wrist_pitch": assembly: its two sides become one chain
  const Real x4163 = 1.7763568394002505e-15 * x4011;
  require_more(w, x4092, x4163, kFactorization, 5);
  const Real x4164 = 1.7763568394002505e-15 * x4020;
  require_more(w, x4113, x4164, kFactorization, 5);
  const Real x4165 = 1.7763568394002505e-15 * x4023;
  require_more(w, x4137, x4165, kFactorization, 5);
  const Real x4166 = 1.7763568394002505e-15 * x4026;
  require_more(w, x4161, x4166, kFactorization, 5);
  // joint 6 "flange_roll": assembly: its two sides become one chain
  const Real x3807 = x3767 - tau[6] * 0.0028255423871896726 + x2823;
  // joint 5 "wrist_pitch": assembly: its two sides become one chain
  const Real x4065 = 0.9999999999932537 * x3907 + 3.673205103346574e-06 * x3910 + x3807;
  const Real x4077 = x4065 - tau[5] * (x3591 - x3343 * x3412 + 222.85165434408793);
  w.x[0] = x4077;
}

ADAGEN_NOINLINE void part_1_4(Workspace& w) {
  ADAGEN_INPUTS
  const Real x1024 = w.x[30];
  const Real x1036 = w.x[31];
  const Real x1068 = w.x[32];
  const Real x1076 = w.x[34];
  const Real x1080 = w.x[36];
  const Real x1136 = w.x[41];
  const Real x1141 = w.x[5];
  const Real x1149 = w.x[42];
  const Real x1150 = w.x[43];
  const Real x1166 = w.x[44];
  const Real x1167 = w.x[45];
  const Real x1189 = w.x[46];
  const Real x1190 = w.x[47];
  const Real x1210 = w.x[49];
  const Real x1211 = w.x[50];
  const Real x1225 = w.x[52];
  const Real x1233 = w.x[53];
  const Real x1239 = w.x[54];
  const Real x1248 = w.x[55];
  const Real x1260 = w.x[56];
  const Real x1269 = w.x[57];
  const Real x1293 = w.x[58];
  const Real x1344 = w.x[59];
  const Real x1351 = w.x[60];
  const Real x1360 = w.x[61];
  const Real x1367 = w.x[62];
  const Real x1378 = w.x[63];
  const Real x1385 = w.x[64];
  const Real x1397 = w.x[65];
  const Real x1406 = w.x[66];
  const Real x1418 = w.x[67];
  const Real x1427 = w.x[68];
  const Real x1439 = w.x[69];
  const Real x1448 = w.x[70];
  const Real x1516 = w.x[85];
  const Real x1576 = w.x[90];
  const Real x1626 = w.x[93];
  const Real x1637 = w.x[94];
  const Real x1652 = w.x[95];
  const Real x1663 = w.x[96];
  const Real x1929 = w.x[100];
  const Real x1939 = w.x[101];
  const Real x1951 = w.x[102];
  const Real x1973 = w.x[103];
  const Real x1987 = w.x[104];
  const Real x1993 = w.x[105];
  const Real x2005 = w.x[107];
  const Real x2009 = w.x[110];
  const Real x2037 = w.x[113];
  const Real x2042 = w.x[4];
  const Real x2043 = w.x[114];
  const Real x2044 = w.x[115];
  const Real x2045 = w.x[116];
  const Real x2046 = w.x[117];
  const Real x2047 = w.x[118];
  const Real x2053 = w.x[120];
  const Real x2060 = w.x[121];
  const Real x2061 = w.x[122];
  const Real x2062 = w.x[123];
  const Real x2063 = w.x[124];
  const Real x2082 = w.x[126];
  const Real x2083 = w.x[127];
  const Real x2084 = w.x[128];
  const Real x2103 = w.x[130];
  const Real x2104 = w.x[131];
  const Real x2117 = w.x[133];
  const Real x2124 = w.x[134];
  const Real x2130 = w.x[135];
  const Real x2139 = w.x[136];
  const Real x2151 = w.x[137];
  const Real x2154 = w.x[138];
  const Real x2161 = w.x[139];
  const Real x2164 = w.x[140];
  const Real x2167 = w.x[141];
  const Real x2170 = w.x[142];
  const Real x2173 = w.x[143];
  const Real x2179 = w.x[144];
  const Real x2181 = w.x[145];
  const Real x2187 = w.x[146];
  const Real x2193 = w.x[147];
  const Real x2199 = w.x[148];
  const Real x2205 = w.x[149];
  const Real x2214 = w.x[150];
  const Real x2223 = w.x[151];
  const Real x2232 = w.x[152];
  const Real x2241 = w.x[153];
  const Real x2250 = w.x[154];
  const Real x2259 = w.x[155];
  const Real x2271 = w.x[156];
  const Real x2283 = w.x[157];
  const Real x2295 = w.x[158];
  const Real x2307 = w.x[159];
  const Real x2319 = w.x[160];
  const Real x2331 = w.x[161];
  const Real x2394 = w.x[167];
  const Real x2463 = w.x[168];
  const Real x2568 = w.x[169];
  const Real x2931 = w.x[171];
  const Real x2932 = w.x[172];
  const Real x2993 = w.x[176];
  const Real x2995 = w.x[3];
  const Real x3004 = w.x[177];
  const Real x3005 = w.x[178];
  const Real x3006 = w.x[179];
  const Real x3007 = w.x[180];
  const Real x3008 = w.x[181];
  const Real x3021 = w.x[183];
  const Real x3022 = w.x[184];
  const Real x3023 = w.x[185];
  const Real x3024 = w.x[186];
  const Real x3043 = w.x[188];
  const Real x3044 = w.x[189];
  const Real x3045 = w.x[190];
  const Real x3064 = w.x[192];
  const Real x3065 = w.x[193];
  const Real x3078 = w.x[195];
  const Real x3085 = w.x[196];
  const Real x3091 = w.x[197];
  const Real x3100 = w.x[198];
  const Real x3112 = w.x[199];
  const Real x3113 = w.x[200];
  const Real x3116 = w.x[201];
  const Real x3123 = w.x[202];
  const Real x3135 = w.x[203];
  const Real x3161 = w.x[204];
  const Real x3179 = w.x[205];
  const Real x3193 = w.x[206];
  const Real x3197 = w.x[207];
  const Real x3200 = w.x[208];
  const Real x3203 = w.x[209];
  const Real x3206 = w.x[210];
  const Real x3209 = w.x[211];
  const Real x3216 = w.x[212];
  const Real x3222 = w.x[213];
  const Real x3228 = w.x[214];
  const Real x3234 = w.x[215];
  const Real x3240 = w.x[216];
  const Real x3246 = w.x[217];
  const Real x3256 = w.x[218];
  const Real x3265 = w.x[219];
  const Real x3276 = w.x[220];
  const Real x3288 = w.x[221];
  const Real x3298 = w.x[222];
  const Real x3307 = w.x[223];
  const Real x3319 = w.x[224];
  const Real x3331 = w.x[225];
  const Real x3343 = w.x[226];
  const Real x3355 = w.x[227];
  const Real x3367 = w.x[228];
  const Real x3379 = w.x[229];
  const Real x3636 = w.x[25];
  const Real x4007 = w.x[24];
  const Real x4012 = w.x[22];
  const Real x4018 = w.x[21];
  const Real x4019 = w.x[92];
  const Real x4075 = w.x[87];
  const Real x4077 = w.x[0];
  const Real x4085 = w.x[86];
  const Real x4086 = w.x[84];
  const Real x4087 = w.x[83];
  const Real x4088 = w.x[82];
  const Real x4089 = w.x[81];
  const Real x4103 = w.x[79];
  const Real x4104 = w.x[78];
  const Real x4105 = w.x[77];
  const Real x4107 = w.x[76];
  const Real x4126 = w.x[74];
  const Real x4127 = w.x[73];
  const Real x4128 = w.x[72];
  const Real x4148 = w.x[40];
  const Real x4149 = w.x[17];
  const Real x4162 = w.x[15];
  const Real x4169 = w.x[14];
  const Real x4175 = w.x[13];
  const Real x4184 = w.x[12];
  const Real x4196 = w.x[263];
  const Real x4197 = w.x[264];
  const Real x4208 = w.x[265];
  const Real x4212 = w.x[266];
  const Real x4217 = w.x[267];
  const Real x4222 = w.x[268];
  const Real x4236 = w.x[269];
  const Real x4249 = w.x[270];
  const Real x4253 = w.x[271];
  const Real x4256 = w.x[272];
  const Real x4259 = w.x[273];
  const Real x4262 = w.x[274];
  const Real x4265 = w.x[275];
  const Real x4272 = w.x[276];
  const Real x4278 = w.x[277];
  const Real x4284 = w.x[278];
  const Real x4290 = w.x[279];
  const Real x4296 = w.x[280];
  const Real x4302 = w.x[281];
  const Real x4313 = w.x[282];
  const Real x4323 = w.x[283];
  const Real x4333 = w.x[284];
  const Real x4343 = w.x[285];
  const Real x4352 = w.x[286];
  const Real x4361 = w.x[287];
  const Real x4373 = w.x[288];
  const Real x4384 = w.x[289];
  const Real x4397 = w.x[290];
  const Real x4411 = w.x[291];
  const Real x4424 = w.x[292];
  const Real x4436 = w.x[293];
  // message received
  const Real x4871 = w.from[1][0];
  const Real x4872 = w.from[1][1];
  const Real x4873 = w.from[1][2];
  const Real x4874 = w.from[1][3];
  const Real x4875 = w.from[1][4];
  const Real x4876 = w.from[1][5];
  // joint 5 "wrist_pitch": disassembly: its acceleration and force
  const Real x4888 = x4197 * x4871 - x4208 * x4872 + x4217 * x4873;
  const Real x4890 = x4222 * x4874 + x4888 - x4212 * x4875;
  const Real x4953 = 222.8516543377526 * x4872 + 0.0021340334659965573 * x4873 + 17.828153687354867 * x4874;
  const Real x4900 = x4253 * x4872 - x4249 * x4871 + x4256 * x4873;
  const Real x4902 = x4259 * x4874 + x4900 + x4262 * x4875;
  const Real x4911 = x4272 * x4871 + x4278 * x4872 + x4284 * x4873;
  const Real x4913 = x4290 * x4874 + x4911 + x4296 * x4875;
  const Real x4923 = x4323 * x4872 - x4313 * x4871 + x4333 * x4873;
  const Real x4925 = x4343 * x4874 + x4923 + x4352 * x4875;
  const Real x4936 = x4373 * x4871 + x4384 * x4872 - x4397 * x4873;
  const Real x4938 = x4936 - x4411 * x4874 + x4424 * x4875;
  const Real x4960 = x4162 * (x4436 * x4876 + x4938 + x4196);
  const Real x4959 = x4148 * (x4361 * x4876 + x4925 + x4184);
  const Real x4963 = x4959 - x4149 * x4960;
  const Real x4958 = x4126 * (x4302 * x4876 + x4913 + x4175);
  const Real x4957 = x4103 * (x4265 * x4876 + x4902 + x4169);
  const Real x4956 = x4085 * (x4890 - x4236 * x4876 + x4075);
  const Real x4969 = x4958 - x4128 * x4960 - x4127 * x4963;
  const Real x4977 = x4957 - x4107 * x4960 + x4105 * x4963;
  const Real x4978 = x4977 - x4104 * x4969;
  const Real x4988 = x4956 - x4089 * x4960 - x4088 * x4963;
  const Real x4990 = x4988 - x4087 * x4969 - x4086 * x4978;
  const Real x4997 = x4019 * x4963 + x3636 * x4960 + x4018 * x4969;
  const Real x4999 = x4012 * x4978 + x4997 + x4007 * x4990;
  const Real x5000 = x4953 - x4077 + x4999;
  w.result[5] = x5000;
  // joint 6 "flange_roll": disassembly: its acceleration and force
  const Real x5059 = x3343 * tau[5] + x3379 * x4960 + x3367 * x4963;
  const Real x5048 = x3307 * x4960 - x3276 * tau[5] + x3298 * x4963;
  const Real x5035 = x3228 * tau[5] + x3246 * x4960 + x3240 * x4963;
  const Real x5024 = x3200 * tau[5] + x3209 * x4960 + x3206 * x4963;
  const Real x5012 = x3135 * tau[5] - x3179 * x4960 - x3161 * x4963;
  const Real x5079 = 0.00011302169548758689 * x4963 - (0.0028255423871896726 * tau[5] + 30.769230769023192 * x4960);
  const Real x5061 = x3355 * x4969 + x5059 + x3331 * x4978;
  const Real x5050 = x5048 - x3288 * x4969 + x3265 * x4978;
  const Real x5037 = x3234 * x4969 + x5035 + x3222 * x4978;
  const Real x5026 = x3203 * x4969 + x5024 + x3197 * x4978;
  const Real x5014 = x3116 * x4969 + x5012 - x3123 * x4978;
  const Real x5088 = x3078 * (x3319 * x4990 + x5061 + x3112);
  const Real x5087 = x3064 * (x3256 * x4990 + x5050 + x3100);
  const Real x5091 = x5087 - x3065 * x5088;
  const Real x5086 = x3043 * (x3216 * x4990 + x5037 + x3091);
  const Real x5085 = x3021 * (x5026 - x3193 * x4990 + x3085);
  const Real x5084 = x3004 * (x3113 * x4990 + x5014 + x2993);
  const Real x5097 = x5086 - x3045 * x5088 - x3044 * x5091;
  const Real x5105 = x5085 - x3024 * x5088 - x3023 * x5091;
  const Real x5106 = x5105 - x3022 * x5097;
  const Real x5116 = x5084 - x3008 * x5088 - x3007 * x5091;
  const Real x5118 = x5116 - x3006 * x5097 - x3005 * x5106;
  const Real x5125 = x2932 * x5091 + x2568 * x5088 + x2931 * x5097;
  const Real x5082 = x5079 - 2.8255423871896722e-05 * x4969 - 769.2307692255798 * x4978 + x2995;
  const Real x5128 = x2463 * x5106 + x5125 + x2394 * x5118 - x5082;
  w.result[6] = x5128;
  // joint 7 "left_finger_slide": disassembly: its acceleration and force
  const Real x5268 = x5091 - tau[7];
  const Real x5181 = x2295 * tau[6] + x2331 * x5088 + x2319 * x5091;
  const Real x5170 = x2232 * tau[6] + x2259 * x5088 + x2250 * x5091;
  const Real x5159 = x2187 * tau[6] + x2205 * x5088 + x2199 * x5091;
  const Real x5148 = x2164 * tau[6] + x2173 * x5088 + x2170 * x5091;
  const Real x5137 = x1626 * tau[6] + x1663 * x5088 + x1652 * x5091;
  const Real x5197 = x1951 * tau[6] + x1993 * x5088 + x1987 * x5091;
  const Real x5183 = x2307 * x5097 + x5181 + x2283 * x5106;
  const Real x5172 = x2241 * x5097 + x5170 + x2223 * x5106;
  const Real x5161 = x2193 * x5097 + x5159 + x2181 * x5106;
  const Real x5150 = x2167 * x5097 + x5148 + x2053 * x5106;
  const Real x5139 = x1637 * x5097 + x5137 + x1576 * x5106;
  const Real x5199 = x2154 * x5097 + x5197 + x1939 * x5106;
  const Real x5207 = x2117 * (x2271 * x5118 + x5183 + x2151);
  const Real x5267 = x5097 - x5207;
  const Real x5206 = x2103 * (x2214 * x5118 + x5172 + x2139);
  const Real x5210 = x5206 - x2104 * x5207;
  const Real x5205 = x2082 * (x2179 * x5118 + x5161 + x2130);
  const Real x5204 = x2060 * (x2161 * x5118 + x5150 + x2124);
  const Real x5203 = x2043 * (x1516 * x5118 + x5139 + x2037);
  const Real x5269 = x5088 - x5210;
  const Real x5216 = x5205 - x2084 * x5207 - x2083 * x5210;
  const Real x5224 = x5204 - x2063 * x5207 - x2062 * x5210;
  const Real x5225 = x5224 - x2061 * x5216;
  const Real x5235 = x5203 - x2047 * x5207 - x2046 * x5210;
  const Real x5265 = x5106 - (x5216 + 0.13 * x5207);
  const Real x5237 = x5235 - x2045 * x5216 - x2044 * x5225;
  const Real x5264 = x5118 - (q[7] * x5210 - 0.13 * tau[7] + x5225);
  const Real x5244 = x2009 * x5210 + x1973 * x5207 + x1939 * x5216;
  const Real x5266 = tau[6] - (x5237 - q[7] * x5207);
  const Real x5246 = x2005 * x5225 + x5244 + x1951 * x5237;
  const Real x5247 = x5246 - (x1929 * x5118 + x5199 + x2042);
  w.result[7] = x5247;
  // joint 8 "right_finger_slide": disassembly: its acceleration and force
  const Real x5327 = x1427 * x5267 + x1439 * x5268 + x1448 * x5269;
  const Real x5316 = x1367 * x5267 + x1378 * x5268 + x1385 * x5269;
  const Real x5305 = 59.670781892791446 * x5267 - 7.234479409858621e-05 * x5268 - 5.69800569798539 * x5269;
  const Real x5290 = 1.5120169762693617e-05 * x5269 - (0.00015834177779265263 * x5267 + 27.095931187385858 * x5268);
  const Real x5346 = 3.4167136554933856e-06 * x5267 + x1293 * x5268 - 6.243740690241717e-07 * x5269;
  const Real x5329 = x1406 * x5265 + x5327 + x1397 * x5264;
  const Real x5318 = x1351 * x5265 + x5316 + x1344 * x5264;
  const Real x5307 = x5305 - 672.6812282343863 * x5265 - 0.0008033816505865777 * x5264;
  const Real x5292 = 0.0017850200414291078 * x5265 + x5290 - 300.897586242875 * x5264;
  const Real x5348 = x5346 - 7.371082759313139e-05 * x5265 + x1269 * x5264;
  const Real x5278 = 328.7950427750268 * x5266 - (47.81116318204386 * x5264 + 7.026218837536823 * x5268);
  const Real x5356 = x1225 * (x1418 * x5266 + x5329 + x1260);
  const Real x5355 = x1210 * (x1360 * x5266 + x5318 + x1248);
  const Real x5359 = x5355 - x1211 * x5356;
  const Real x5354 = 1.648191504944564e-05 * (0.0001275136846625453 * x5266 + x5307 + x1239);
  const Real x5353 = 1.658353407741297e-05 * (47.758820356278655 * x5266 + x5292 + x1233);
  const Real x5365 = x5354 - x1190 * x5356 - x1189 * x5359;
  const Real x5383 = 3.3296807285906615e-06 * (x1136 + x5278) - x1150 * x5356;
  const Real x5373 = x5353 + x1167 * x5356 - x1166 * x5359;
  const Real x5374 = 1.63606725685963e-08 * x5365 + x5373;
  const Real x5385 = x5383 - x1149 * x5359 - 4.2244063836038523e-10 * x5365;
  const Real x5394 = x1080 * x5359 + x1068 * x5356 + x1036 * x5365;
  const Real x5387 = x1024 * (x5385 - 0.00015919590865819434 * x5374);
  const Real x5396 = x1076 * x5374 + x5394 - x5387;
  const Real x5397 = x5396 - (x5348 - x1024 * x5266 + x1141);
  w.result[8] = x5397;
}

// ---- 5. processes -------------------------------------------------------------------------------

// Process 0: 5 of 9 joints: "base_yaw", "shoulder_pitch", "upper_arm_roll", "elbow_pitch", "forearm_roll"
constexpr std::array<int, 5> kRead_0{0, 1, 2, 3, 4};
constexpr std::array<int, 5> kOwned_0{0, 1, 2, 3, 4};

void run_0([[maybe_unused]] Workspace& w, [[maybe_unused]] Channel& channel) {
  ADAGEN_INPUTS
  stamp(0);
  if (!all(unlike_zero(q + 0, 5) + unlike_zero(v + 0, 5) + unlike_zero(tau + 0, 5) == 0))
    name_what_is_not_finite(w, kRead_0, kOwned_0);
  w.to[1] = channel.outgoing(1, w.status);
  take_sines_and_cosines<5>(q + 0, w.sine.data(), w.cosine.data());
  w.to[1][2] = tau[4];
  part_0_0(w);
  part_0_1(w);
  stamp(1);
  stamp(2);
  w.from[0] = channel.receive(0, w.status);  // from process 1: assembled: chain of "wrist_pitch"
  stamp(3);
  part_0_2(w);
  stamp(4);
  stamp(5);
  channel.send(1, w.status);  // to process 1: forces on: chain of "wrist_pitch"
  stamp(6);
  part_0_3(w);
  stamp(7);
  if (!all(unlike_zero(w.result.data() + 0, 5) == 0)) name_what_overflows(w, kOwned_0);
  if (w.status != kFine) return;
  std::copy_n(w.result.data() + 0, 5, w.qdd + 0);
}

// Process 1: 4 of 9 joints: "wrist_pitch", "flange_roll", "left_finger_slide", "right_finger_slide"; kinematics of 5 more on the way to the ground
constexpr std::array<int, 9> kRead_1{0, 1, 2, 3, 4, 5, 6, 7, 8};
constexpr std::array<int, 4> kOwned_1{5, 6, 7, 8};

void run_1([[maybe_unused]] Workspace& w, [[maybe_unused]] Channel& channel) {
  ADAGEN_INPUTS
  stamp(0);
  if (!all(unlike_zero(q + 0, 9) + unlike_zero(v + 0, 9) + unlike_zero(tau + 5, 4) == 0))
    name_what_is_not_finite(w, kRead_1, kOwned_1);
  w.to[0] = channel.outgoing(0, w.status);
  take_sines_and_cosines<7>(q + 0, w.sine.data(), w.cosine.data());
  part_1_0(w);
  part_1_1(w);
  part_1_2(w);
  stamp(1);
  stamp(2);
  channel.send(0, w.status);  // to process 0: assembled: chain of "wrist_pitch"
  stamp(3);
  part_1_3(w);
  w.from[1] = channel.receive(1, w.status);  // from process 0: forces on: chain of "wrist_pitch"
  stamp(4);
  part_1_4(w);
  stamp(5);
  if (!all(unlike_zero(w.result.data() + 5, 4) == 0)) name_what_overflows(w, kOwned_1);
  if (w.status != kFine) return;
  std::copy_n(w.result.data() + 5, 4, w.qdd + 5);
}

[[maybe_unused]] constexpr std::array<void (*)(Workspace&, Channel&), kProcesses> kRun{run_0, run_1};

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

struct arm7_unrolled_p2_solver : Solver {};

extern "C" {

int arm7_unrolled_p2_joint(int k, const char** name, int* q, int* nq, int* v, int* nv) {
  if (k < 0 || k >= kJointCount) return 0;
  const JointConstants& joint = kJoints[k];
  *name = joint.name, *q = joint.q, *nq = joint.nq, *v = joint.v, *nv = joint.nv;
  return 1;
}

arm7_unrolled_p2_solver* arm7_unrolled_p2_open(MPI_Comm comm, const char* channel, double time_limit) {
  int size = 0;
  MPI_Comm_size(comm, &size);
  const std::string kind = channel;
  if (size != kProcesses || (kind != "auto" && kind != "window" && kind != "message")) return nullptr;
  auto* const solver = new arm7_unrolled_p2_solver;
  const ChannelMode mode = kind == "window"    ? ChannelMode::kWindow
                           : kind == "message" ? ChannelMode::kMessage
                                               : ChannelMode::kAuto;
  if (solver->channel.open(comm, mode, time_limit).empty()) return solver;
  arm7_unrolled_p2_close(solver);
  return nullptr;
}

int arm7_unrolled_p2_solve(arm7_unrolled_p2_solver* solver, const double* q, const double* v, const double* tau, double* qdd) {
  return solver->solve(q, v, tau, qdd);
}

int arm7_unrolled_p2_solve_at_root(arm7_unrolled_p2_solver* solver, const double* q, const double* v, const double* tau, double* qdd) {
  return solver->solve_at_root(q, v, tau, qdd);
}

const char* arm7_unrolled_p2_failure(const arm7_unrolled_p2_solver* solver) { return solver->text.c_str(); }

void arm7_unrolled_p2_close(arm7_unrolled_p2_solver* solver) {
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
    {"kinematics", 4, -1},
    {"assembly", 3, -1},
    {"receive", -1, 0},
    {"assembly", 4, -1},
    {"disassembly", 4, -1},
    {"send", -1, 1},
    {"disassembly", 3, -1},
} };
constexpr std::array<Stage, 5> kStages_1{ {
    {"kinematics", 8, -1},
    {"assembly", 5, -1},
    {"send", -1, 0},
    {"receive", -1, 1},
    {"disassembly", 5, -1},
} };
constexpr std::array<const Stage*, kProcesses> kStages{kStages_0.data(), kStages_1.data()};
constexpr std::array<int, kProcesses> kStageCount{7, 5};

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
