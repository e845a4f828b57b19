// Forward dynamics of "arm7" on 2 processes, emitted by adagen 0.1.0 (solver.cpp.j2). Do not edit: emit anew.
//
// robot     "arm7", 9 joints, 9 degrees of freedom, description sha256 35a799ae72b600eeca178cc12eccff22927d06b6ca76bda0ede3ef5832ebda29
// options   form ada, shape unrolled, scalar double, channel auto, fixed base, gravity 0.0, 0.0, -9.81
// schedule  forearm_roll@0-1(elbow_pitch@0(upper_arm_roll(shoulder_pitch(base_yaw|)|)|) | wrist_pitch@1(|flange_roll(|left_finger_slide(right_finger_slide|))))
// licence   yours to choose: what adagen emits belongs to whoever emits it
//
// The assembly-disassembly algorithm of Yamane and Nakamura. Phi are inverse articulated-body inertias,
// b bias accelerations, [angular; linear], in link frames turned so that every joint axis is z. Joint i
// joins chain A (its parent link's side) and chain B (its child link's side) to chain C: assembly,
// Eq. (3)-(7), goes up the schedule, disassembly, Eq. (8)-(10), comes down.
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

using Real = double;
constexpr int kProcesses = 2;
constexpr int kJointCount = 9, kLinkCount = kJointCount + 1;
constexpr int kNq = 9, kNv = 9;
constexpr int kOuterCount = 0, kNtau = kNv + 6 * kOuterCount;
constexpr int kColumns = 1;  // right-hand sides: the motion, and one per slaved joint
constexpr bool kBatch = false;  // whether many states are solved at once
constexpr int kRefine = 0;  // steps of iterative refinement
constexpr int kPlanMessages = 2;
constexpr std::size_t kCacheLine = 64;
constexpr bool kFloatingBase = false;
constexpr double kTolerance = 1e-09;
constexpr int kRandomStates = 64;
constexpr const char* kRobot = "arm7";
const MPI_Datatype kMpiReal = MPI_DOUBLE;

// ---- 2. model -----------------------------------------------------------------------------------

enum class JointKind { kRevolute, kPrismatic, kSpherical, kPlanar, kFloating };

// What a joint does by itself: of its torque, damping qd + friction tanh(qd / friction_speed)
// + stiffness (q - rest) + rotor qdd do not reach the links. Where its acceleration is prescribed,
// tau holds that.
struct Passive {
  Real damping = 0, friction = 0, friction_speed = 1, stiffness = 0, rest = 0, rotor = 0;
  bool prescribed = false;
};

// A joint's frame is turned so that its axis is z (a planar joint's normal, too); the child link
// has the joint's frame at q = 0.
struct JointConstants {
  const char* name;
  JointKind kind;
  int parent;           // parent link; the child link has the joint's number plus one
  int q, nq, v, nv;     // where its configuration and velocity are
  Real rotation[9];     // joint frame to parent link's frame, row by row
  Real translation[3];  // origin of the joint frame in the parent link's frame, m
  int source;           // joint that it is slaved to, or -1: q = multiplier q_source + offset
  double multiplier, offset;
  Passive passive{};
};

// An outer force that is an input, told in the frame of the link that has its name.
struct OuterForce {
  const char* name;
  int link;             // that feels it
  Real rotation[9];     // from that frame to the link's, row by row
  Real translation[3];  // its origin in the link's frame, m
};

struct LinkConstants {
  const char* name;
  Real mass;               // kg
  Real com[3];             // centre of mass, m
  Real tensor[9];          // rotational inertia about it, kg m^2
  Real tensor_inverse[9];  // J, its inverse
};

// What a process reads and owns of the state.
struct ProcessInfo {
  int q_count;
  const int* q;
  int v_read_count;
  const int* v_read;
  int v_count;
  const int* v;
  int tau_count;
  const int* tau;  // entries of tau that it reads
};

// What goes from one process to another once in an evaluation.
struct MessageInfo {
  int source, target, size;  // size in Real, the status not counted
};

constexpr std::array<double, 3> kGravity{0.0, 0.0, -9.81};  // m/s^2

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

constexpr std::array<OuterForce, kOuterCount> kOuterForces{};

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
  kNoAnswer = 5,        // a process did not answer in time (numbered in place of a joint)
  kEnded = 6,           // no failure: process 0 has no more to evaluate
  kNotRefined = 7,      // a correction is as large as the one before: refinement does not converge
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
    case kEnded:
      return "the evaluations are over";
    case kNotRefined:
      return "refinement does not converge: the inertias differ too much for the scalar";
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

  // Collective. Returns an empty string, or what is wrong.
  std::string open(MPI_Comm comm, ChannelMode mode, double time_limit) {
    MPI_Comm_dup(comm, &comm_);
    MPI_Comm_rank(comm_, &rank_);
    time_limit_ = std::chrono::duration_cast<Clock::duration>(
        std::chrono::duration<double>(std::min(time_limit, 1e8)));
    ports_.resize(kMessages.size());
    if (mode != ChannelMode::kMessage) open_window(mode);
    int missing = 0;
    for (std::size_t k = 0; k < ports_.size(); ++k) {
      const MessageInfo& info = kMessages[k];
      if (ports_[k].slots || (info.source != rank_ && info.target != rank_)) continue;
      if (mode == ChannelMode::kWindow) ++missing;
      ports_[k].buffer.resize(static_cast<std::size_t>(info.size) + 1);
    }
    MPI_Allreduce(MPI_IN_PLACE, &missing, 1, MPI_INT, MPI_SUM, comm_);
    return missing == 0 ? "" : "channel window: not all processes are on one node";
  }

  void close() {
    if (comm_ == MPI_COMM_NULL) return;
    for (Port& port : ports_)
      if (port.request != MPI_REQUEST_NULL)
        MPI_Cancel(&port.request), MPI_Request_free(&port.request);
    if (window_ != MPI_WIN_NULL) {
      MPI_Win_unlock_all(window_);
      MPI_Win_free(&window_);
    }
    if (node_ != MPI_COMM_NULL) MPI_Comm_free(&node_);
    MPI_Comm_free(&comm_);
  }

  // Where to write message k. Waits for an MPI message that is still under way.
  Real* outgoing(int k, int& status) {
    Port& port = ports_[k];
    if (port.slots) return port.slot(port.count + 1, k).content() + 1;
    if (port.request != MPI_REQUEST_NULL) wait_for_request(port, kMessages[k].target, status);
    return port.buffer.data() + 1;
  }

  void send(int k, int& status) {
    Port& port = ports_[k];
    if (port.slots) {
      Slot& slot = port.slot(++port.count, k);
      slot.content()[0] = static_cast<Real>(status);
      slot.number.store(port.count, std::memory_order_release);
      return;
    }
    port.buffer[0] = static_cast<Real>(status);
    MPI_Isend(port.buffer.data(), static_cast<int>(port.buffer.size()), kMpiReal,
              kMessages[k].target, k, comm_, &port.request);
  }

  // Waits for message k and returns its content; what its source knows of failures joins the
  // status.
  const Real* receive(int k, int& status) {
    Port& port = ports_[k];
    const Real* content;
    if (port.slots) {
      const std::uint64_t number = ++port.count;
      Slot& slot = port.slot(number, k);
      if (!wait_until([&] { return slot.number.load(std::memory_order_acquire) >= number; }))
        fail(status, failure(kNoAnswer, kMessages[k].source));
      content = slot.content();
    } else {
      MPI_Irecv(port.buffer.data(), static_cast<int>(port.buffer.size()), kMpiReal,
                kMessages[k].source, k, comm_, &port.request);
      wait_for_request(port, kMessages[k].source, status);
      content = port.buffer.data();
    }
    if (failure_kind(status) != kNoAnswer) fail(status, static_cast<int>(content[0]));
    return content + 1;
  }

  static void fail(int& status, int failure) {
    if (status == kFine) status = failure;
  }

  MPI_Comm comm() const { return comm_; }
  int rank() const { return rank_; }
  bool broken() const { return broken_; }
  bool windowed() const { return window_ != MPI_WIN_NULL; }

 private:
  using Clock = std::chrono::steady_clock;

  struct alignas(kCacheLine) Slot {
    std::atomic<std::uint64_t> number;
    Real* content() { return reinterpret_cast<Real*>(reinterpret_cast<char*>(this) + kCacheLine); }
  };

  struct Port {
    char* slots = nullptr;
    std::uint64_t count = 0;
    Slot& slot(std::uint64_t number, int k) const {
      return *reinterpret_cast<Slot*>(slots + (number & 1) * slot_bytes(kMessages[k]));
    }
    std::vector<Real> buffer;
    MPI_Request request = MPI_REQUEST_NULL;
  };

  static std::size_t slot_bytes(const MessageInfo& info) {
    const std::size_t content = (static_cast<std::size_t>(info.size) + 1) * sizeof(Real);
    return kCacheLine + (content + kCacheLine - 1) / kCacheLine * kCacheLine;
  }

  // Each process holds the slots of the messages that it sends to processes on its node.
  void open_window(ChannelMode mode) {
    MPI_Comm_split_type(comm_, MPI_COMM_TYPE_SHARED, 0, MPI_INFO_NULL, &node_);
    std::vector<int> on_node(kProcesses, MPI_UNDEFINED), all(kProcesses);
    for (int p = 0; p < kProcesses; ++p) all[p] = p;
    MPI_Group whole, near;
    MPI_Comm_group(comm_, &whole);
    MPI_Comm_group(node_, &near);
    MPI_Group_translate_ranks(whole, kProcesses, all.data(), near, on_node.data());
    MPI_Group_free(&whole);
    MPI_Group_free(&near);
    int node_size = 1;
    MPI_Comm_size(node_, &node_size);
    if (node_size == 1 && mode == ChannelMode::kAuto) return;  // nobody to share a window with

    const auto near_pair = [&](const MessageInfo& info) {
      return on_node[info.source] != MPI_UNDEFINED && on_node[info.target] != MPI_UNDEFINED;
    };
    std::size_t own = 0;
    for (const MessageInfo& info : kMessages)
      if (info.source == rank_ && near_pair(info)) own += 2 * slot_bytes(info);
    char* base = nullptr;
    MPI_Info hints;
    MPI_Info_create(&hints);
    MPI_Info_set(hints, "alloc_shared_noncontig",
                 "true");  // every part on pages of its own process
    MPI_Win_allocate_shared(static_cast<MPI_Aint>(own), 1, hints, node_, &base, &window_);
    MPI_Info_free(&hints);
    MPI_Win_lock_all(MPI_MODE_NOCHECK, window_);
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

  void wait_for_request(Port& port, int peer, int& status) {
    const bool done = wait_until([&] {
      int flag = 0;
      MPI_Test(&port.request, &flag, MPI_STATUS_IGNORE);
      return flag != 0;
    });
    if (!done) fail(status, failure(kNoAnswer, peer));
  }

  MPI_Comm comm_ = MPI_COMM_NULL, node_ = MPI_COMM_NULL;
  MPI_Win window_ = MPI_WIN_NULL;
  int rank_ = 0;
  Clock::duration time_limit_{};
  bool broken_ = false;
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

inline void stamp(int k) {
  if (trace_stamps) trace_stamps[k] = std::chrono::steady_clock::now().time_since_epoch().count();
}

// ---- 4. joints ----------------------------------------------------------------------------------

// The memory of a process: the state, angles with sine and cosine, what messages hold, and values
// that one function leaves to another.
struct Workspace {
  const Real* q = nullptr;
  const Real* v = nullptr;
  const Real* tau = nullptr;
  Real* qdd = nullptr;
  int status = kFine;
  alignas(kCacheLine) std::array<Real, 7> angle{}, sine{}, cosine{};
  std::array<Real, kNv> result{};
  std::array<Real*, kPlanMessages> to{};          // messages to be sent
  std::array<const Real*, kPlanMessages> from{};  // messages received
  alignas(kCacheLine) std::array<Real, 283> x{};
};

// What the straight lines are surrounded by: the state looked at, sines and cosines, checks, results.
#define ADAGEN_INPUTS                                                                     \
  [[maybe_unused]] const Real *const q = w.q, *const v = w.v, *const tau = w.tau;         \
  [[maybe_unused]] const Real *const sine = w.sine.data(), *const cosine = w.cosine.data();

constexpr Real kEpsilon = std::numeric_limits<Real>::epsilon();
[[maybe_unused]] constexpr Real kInfinity = std::numeric_limits<Real>::infinity();

inline void fail(Workspace& w, Failure kind, int joint) {
  Channel::fail(w.status, failure(kind, joint));
}

// Zero for finite numbers only: x - x is.
inline Real unlike_zero(const Real* x, int count) {
  Real sum = 0;
  for (int k = 0; k < count; ++k) sum += x[k] - x[k];
  return sum;
}

// A state was found not to be finite: which joint's?
template <std::size_t reads, std::size_t owns>
[[gnu::cold]] ADAGEN_NOINLINE void name_what_is_not_finite(Workspace& w,
                                                           const std::array<int, reads>& read,
                                                           const std::array<int, owns>& owned) {
  for (const int j : read) {
    const JointConstants& joint = kJoints[static_cast<std::size_t>(j)];
    if (!(unlike_zero(w.q + joint.q, joint.nq) + unlike_zero(w.v + joint.v, joint.nv) == 0))
      fail(w, kNotFinite, j);
  }
  for (const int j : owned) {
    const JointConstants& joint = kJoints[static_cast<std::size_t>(j)];
    if (!(unlike_zero(w.tau + joint.v, joint.nv) == 0)) fail(w, kNotFinite, j);
  }
}

[[maybe_unused]] inline void require_length(Workspace& w, Real squared, int joint) {
  if (!(squared >= std::numeric_limits<Real>::min() && squared <= std::numeric_limits<Real>::max()))
    fail(w, kZeroQuaternion, joint);
}

// A pivot has to be positive, and not lost against what it was subtracted from.
inline void require_pivot(Workspace& w, Real pivot, Real least, int joint) {
  if (!(pivot > least && pivot <= std::numeric_limits<Real>::max())) fail(w, kFactorization, joint);
}

// Sine and cosine by the polynomials of fdlibm on [-pi/4, pi/4], after taking multiples of pi/2
// away in three parts. No branch: a loop over it is done in SIMD lanes.
inline void sine_and_cosine(double angle, double& sine, double& cosine) {
  constexpr double kRound = 6755399441055744.0;  // 1.5 * 2^52: adding it rounds to an integer
  const double n = (angle * 0.63661977236758134308 + kRound) - kRound;
  const double r = ((angle - n * 1.57079632673412561417e+00) - n * 6.07710050630396597660e-11) -
                   n * 2.02226624871116645580e-21;
  const double z = r * r, z2 = z * z, z4 = z2 * z2;
  const double s =
      r + r * z *
              ((-1.66666666666666307295e-1 + z * 8.33333333332211858878e-3) +
               z2 * (-1.98412698295895385996e-4 + z * 2.75573136213857245213e-6) +
               z4 * (-2.50507477628578072866e-8 + z * 1.58962301576546568060e-10));
  const double c = (1 - 0.5 * z) +
                   z2 * ((4.16666666666665929218e-2 - z * 1.38888888888730564116e-3) +
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

// A result was found not to be finite: which joint's?
template <std::size_t owns>
[[gnu::cold]] ADAGEN_NOINLINE void name_what_overflows(Workspace& w,
                                                       const std::array<int, owns>& owned) {
  for (const int j : owned) {
    const JointConstants& joint = kJoints[static_cast<std::size_t>(j)];
    if (!(unlike_zero(w.result.data() + joint.v, joint.nv) == 0)) fail(w, kOverflow, j);
  }
}

// Each function is a straight line. A value is called x and its number in the expression graph; zeros
// and constants are folded in, nothing is computed twice, and what nobody needs is not there.
// Frames are the links' own; accelerations are deviations from the field that the links would have
// with all joint accelerations zero.

// =================================================================================================
// Process 0: 1048 products, 824 sums, 18 quotients
// =================================================================================================

ADAGEN_NOINLINE void part_0_0(Workspace& w) {
  ADAGEN_INPUTS
  // joint 1 "shoulder_pitch": placement, velocity and reference acceleration of its link
  const Real x20 = v[0] * 0.9999999999932537;
  const Real x25 = sine[1] * x20;
  const Real x27 = cosine[1] * x20;
  const Real x29 = v[1] - v[0] * 3.673205103346574e-06;
  const Real x30 = v[1] * x27;
  const Real x32 = v[1] * x25;
  const Real x37 = sine[1] * 9.809999999933819;
  const Real x55 = x25 * x27;
  const Real x59 = x27 * x29;
  const Real x62 = x30 + x59;
  // joint 2 "upper_arm_roll": placement, velocity and reference acceleration of its link
  const Real x80 = 3.673205103346574e-06 * x27 + 0.9999999999932537 * x29;
  const Real x89 = sine[2] * x80 - x25 * cosine[2];
  const Real x93 = x25 * sine[2] + cosine[2] * x80;
  const Real x94 = 0.9999999999932537 * x27 - 3.673205103346574e-06 * x29 + v[2];
  const Real x95 = 3.673205103346574e-06 * x32;
  const Real x97 = 0.9999999999932537 * x32;
  const Real x111 = v[2] * x93 - (x30 * cosine[2] + sine[2] * x95);
  const Real x114 = x30 * sine[2] - cosine[2] * x95 - v[2] * x89;
  const Real x118 = x37 + x55 * 0.3;
  const Real x120 = (x25 * x25 + x29 * x29) * 0.3;
  const Real x122 = x120 - cosine[1] * 9.809999999933819;
  const Real x125 = -3.603414206382989e-05 + x62 * 0.3;
  const Real x129 = 0.9999999999932537 * x125 - 3.673205103346574e-06 * x122;
  const Real x134 = 0.9999999999932537 * x122 + 3.673205103346574e-06 * x125;
  const Real x139 = sine[2] * x129 - cosine[2] * x118;
  const Real x143 = sine[2] * x118 + cosine[2] * x129;
  const Real x148 = x93 * x93;
  const Real x157 = x93 * x94;
  const Real x162 = x89 * x94;
  // joint 3 "elbow_pitch": placement, velocity and reference acceleration of its link
  const Real x174 = 0.9999999999932537 * x94 - 3.673205103346574e-06 * x93;
  const Real x183 = x89 * cosine[3] + sine[3] * x174;
  const Real x187 = cosine[3] * x174 - x89 * sine[3];
  const Real x188 = v[3] - (0.9999999999932537 * x93 + 3.673205103346574e-06 * x94);
  const Real x193 = 3.673205103346574e-06 * x114 + 0.9999999999932537 * x97;
  const Real x199 = 3.673205103346574e-06 * x97 - 0.9999999999932537 * x114;
  const Real x211 = x111 * cosine[3] - sine[3] * x193 + v[3] * x187;
  const Real x214 = x111 * sine[3] + cosine[3] * x193 + v[3] * x183;
  const Real x218 = x139 - (x148 + x94 * x94) * 0.08;
  const Real x220 = x143 + (x89 * x93 - x97) * 0.08;
  const Real x222 = (x162 - x114) * 0.08 - x134;
  const Real x226 = 0.9999999999932537 * x222 - 3.673205103346574e-06 * x220;
  const Real x231 = 0.9999999999932537 * x220 + 3.673205103346574e-06 * x222;
  const Real x235 = cosine[3] * x218 + sine[3] * x226;
  const Real x239 = cosine[3] * x226 - sine[3] * x218;
  const Real x246 = x188 * x188;
  const Real x247 = x187 * x187 + x246;
  const Real x249 = x183 * x187;
  const Real x252 = x183 * x183 + x246;
  const Real x254 = x187 * x188;
  const Real x256 = x211 + x254;
  const Real x259 = x183 * x188;
  const Real x260 = x214 + x259;
  // joint 0 "base_yaw": assembly: its two sides become one chain
  const Real x399 = 113.37868480725623 * tau[0];
  w.x[0] = x399;
  // link 2 "upper_arm": acceleration where nothing acts on it
  const Real x435 = 1.1170584039787268e-05 - (x30 * 0.048670000000000005 + x59 * 0.04309);
  const Real x438 = x55 * 0.04309 + x37 * 0.31000000000000005;
  const Real x444 = x37 * 3.1 + x55 * 0.31000000000000005;
  const Real x454 = -0.00011170584039787267 + x62 * 0.31000000000000005;
  const Real x463 = x435 * 56.59309564233163 + x454 * 5.659309564233164;
  const Real x464 = x32 * 0.00558 * 179.2114695340502;
  const Real x469 = x444 * 5.659309564233164 - x438 * 56.59309564233163;
  const Real x474 = x438 * 5.659309564233164 - x444 * 0.8885116015846066;
  const Real x478 = x435 * 5.659309564233164 + x454 * 0.8885116015846066;
  // joint 1 "shoulder_pitch": assembly: its two sides become one chain
  const Real x496 = sine[1] * 0.0004164631636419267;
  w.x[1] = x496;
  const Real x497 = cosine[1] * 0.0004164631636419267;
  w.x[2] = x497;
  const Real x499 = cosine[1] * 113.37868480572648;
  const Real x501 = sine[1] * x499;
  const Real x503 = cosine[1] * x499;
  const Real x506 = 113.37868480572648 - x503 + 56.59309564233163;
  require_pivot(w, x506, 0, 1);
  const Real x507 = 179.2114695340502 + x503;
  const Real x509 = 0.9999999999932537 * x399;
  const Real x523 = 5.659309564233164 * tau[1];
  const Real x525 = x463 - sine[1] * x509 - tau[1] * x496;
  w.x[3] = x525;
  const Real x527 = x469 - 3.673205103346574e-06 * x399 - tau[1] * 56.59309564386139;
  w.x[4] = x527;
  const Real x528 = x474 + x523;
  w.x[5] = x528;
  const Real x529 = 1 / x506;
  w.x[6] = x529;
  const Real x530 = x501 * x529;
  w.x[7] = x530;
  const Real x531 = 5.659309564233164 * x529;
  w.x[8] = x531;
  const Real x534 = x507 - x501 * x530;
  require_pivot(w, x534, 8 * kEpsilon * x507, 1);
  const Real x535 = 5.659309564233164 * x530;
  w.x[9] = x535;
  const Real x537 = 1 / x534;
  w.x[10] = x537;
  const Real x538 = x535 * x537;
  w.x[11] = x538;
  const Real x547 = 0.8885116015846066 - 5.659309564233164 * x531 - x535 * x538;
  w.x[12] = x547;
  require_pivot(w, x547, 8 * kEpsilon * 0.8885116015846066, 1);
  const Real x548 = 1 / x547;
  w.x[13] = x548;
  const Real x526 = x464 - cosine[1] * x509 - tau[1] * x497;
  const Real x551 = x526 - x525 * x530;
  w.x[14] = x551;
  const Real x552 = x525 * x531;
  const Real x554 = x538 * x551;
  const Real x557 = x478 - x552 + x554;
  w.x[15] = x557;
  const Real x558 = 56.59309564233163 * x530;
  w.x[16] = x558;
  const Real x565 = 5.659309564233164 - 56.59309564233163 * x531 - x538 * x558;
  w.x[17] = x565;
  const Real x566 = 179.2114695340502 * x538;
  w.x[18] = x566;
  const Real x568 = 56.59309564233163 * x529;
  const Real x569 = x537 * x558;
  const Real x571 = 179.2114695340502 * x537;
  const Real x573 = x548 * x565;
  const Real x574 = x548 * x566;
  const Real x575 = x547 * x548;
  const Real x583 = 56.59309564233163 - 56.59309564233163 * x568 - x558 * x569;
  const Real x584 = x583 - x565 * x573;
  const Real x589 = x558 * x571 - x565 * x574;
  const Real x592 = x565 - x565 * x575;
  const Real x598 = 179.2114695340502 - 179.2114695340502 * x571 - x566 * x574;
  const Real x616 = x525 * x568 - x551 * x569 + x557 * x573;
  const Real x628 = x616 - x463;
  const Real x629 = x551 * x571 + x557 * x574 - x464;
  const Real x630 = 56.59309564233163 * tau[1] - x528 * 6.369426751592357 - x469;
  // link 3 "elbow_housing": acceleration where nothing acts on it
  const Real x657 = x111 * 0.01132625 - x157 * 0.007393749999999999 + x143 * 0.078;
  const Real x660 = x114 * 0.01132625 + x162 * 0.007393749999999999 - x139 * 0.078;
  const Real x664 = x139 * 2.6 - (x114 + x162) * 0.078;
  const Real x668 = x143 * 2.6 - (x157 - x111) * 0.078;
  const Real x683 = x657 * 111.2811239393518 - x668 * 3.338433718180554;
  const Real x686 = x660 * 111.2811239393518 + x664 * 3.338433718180554;
  const Real x687 = x97 * 0.0039325 * 254.29116338207245;
  const Real x691 = x660 * 3.338433718180554 + x664 * 0.4847683961608012;
  const Real x695 = x668 * 0.4847683961608012 - x657 * 3.338433718180554;
  const Real x673 = (x89 * x89 + x148) * 0.078 - x134 * 2.6;
  const Real x696 = x673 * 0.3846153846153846;
  // joint 2 "upper_arm_roll": assembly: its two sides become one chain
  const Real x705 = x592 - 0.3 * x584;
  const Real x708 = x566 - x566 * x575 - 0.3 * x589;
  const Real x715 = x547 - x547 * x575 - 0.3 * x592;
  const Real x716 = x715 - 0.3 * x705;
  const Real x719 = 0.9999999999932537 * x705;
  const Real x720 = 3.673205103346574e-06 * x705;
  const Real x722 = 0.9999999999932537 * x708;
  const Real x723 = 0.9999999999932537 * x722;
  const Real x724 = x708 - x723;
  const Real x726 = 3.673205103346574e-06 * x722;
  w.x[19] = x726;
  const Real x731 = sine[2] * x724 - cosine[2] * x720;
  const Real x741 = cosine[2] * 2.264149437033022e-05 + sine[2] * x723;
  w.x[20] = x741;
  const Real x747 = sine[2] * 2.264149437033022e-05 - cosine[2] * x723;
  w.x[21] = x747;
  const Real x751 = cosine[2] * x726 + sine[2] * (6.1639613724671465 + x719);
  const Real x752 = sine[2] * x751;
  const Real x755 = cosine[2] * x751;
  const Real x756 = x755 - x726;
  const Real x758 = 3.673205103346574e-06 * x589;
  const Real x760 = 0.9999999999932537 * x589;
  const Real x763 = 3.673205103346574e-06 * (x598 - 20.546537908362435);
  const Real x766 = 0.9999999999932537 * x763;
  const Real x768 = 3.673205103346574e-06 * x763;
  const Real x770 = 20.546537908362435 + x768;
  const Real x775 = sine[2] * x766 - cosine[2] * x760;
  w.x[22] = x775;
  const Real x779 = sine[2] * x760 + cosine[2] * x766;
  w.x[23] = x779;
  const Real x785 = cosine[2] * (x584 - x770) - x758 * (2.0 * sine[2]);
  const Real x787 = x758 + sine[2] * x785;
  const Real x789 = cosine[2] * x785;
  const Real x793 = 3.673205103346574e-06 * x716;
  const Real x795 = 0.9999999999932537 * x793;
  const Real x797 = 3.673205103346574e-06 * x793;
  const Real x799 = x716 - x797;
  const Real x805 = cosine[2] * (1.849188411752619 - x799);
  const Real x808 = cosine[2] * x805;
  const Real x811 = x770 + x789 + 111.2811239393518;
  require_pivot(w, x811, 0, 2);
  const Real x812 = x719 - x752 + -3.338433718180554;
  const Real x813 = x584 - x789 + 111.2811239393518;
  const Real x816 = x799 + x808 + 0.4847683961608012;
  const Real x817 = 1.849188411752619 - x808 + 0.4847683961608012;
  const Real x818 = 0.3846153846153846 + x797;
  const Real x820 = x528 - x523 - x474 + 0.3 * x630;
  // joint 1 "shoulder_pitch": assembly: its two sides become one chain
  const Real x632 = x552 - x554 + x557 * x575 - x478;
  // joint 2 "upper_arm_roll": assembly: its two sides become one chain
  const Real x823 = x632 - 0.3 * x628;
  const Real x827 = 0.9999999999932537 * x630 - 3.673205103346574e-06 * x629;
  const Real x841 = 0.9999999999932537 * x823;
  const Real x851 = cosine[2] * x628 + sine[2] * x827 + x683;
  const Real x865 = x851 - tau[2] * x775;
  w.x[24] = x865;
  const Real x852 = cosine[2] * x827 - sine[2] * x628 + x686;
  const Real x853 = 0.9999999999932537 * x629 + 3.673205103346574e-06 * x630 + x687;
  const Real x867 = x853 + tau[2] * (x598 - x768 + 254.29116338207245);
  w.x[25] = x867;
  const Real x855 = cosine[2] * x820 + sine[2] * x841 + x691;
  const Real x856 = cosine[2] * x841 - sine[2] * x820 + x695;
  const Real x872 = 1 / x811;
  w.x[26] = x872;
  const Real x873 = x787 * x872;
  w.x[27] = x873;
  const Real x875 = x756 * x872;
  w.x[28] = x875;
  const Real x876 = x812 * x872;
  w.x[29] = x876;
  const Real x877 = x731 * x872;
  w.x[30] = x877;
  const Real x880 = x813 - x787 * x873;
  require_pivot(w, x880, 8 * kEpsilon * x813, 2);
  const Real x883 = 6.1639613724671465 - x752 + 3.338433718180554 + x756 * x873;
  const Real x886 = x812 * x873 - x755;
  const Real x889 = sine[2] * x720 + cosine[2] * x724 + x731 * x873;
  const Real x890 = 1 / x880;
  w.x[31] = x890;
  const Real x891 = x883 * x890;
  w.x[32] = x891;
  const Real x892 = x886 * x890;
  w.x[33] = x892;
  const Real x893 = x889 * x890;
  w.x[34] = x893;
  const Real x899 = x816 - x756 * x875 - x883 * x891;
  require_pivot(w, x899, 8 * kEpsilon * x816, 2);
  const Real x906 = sine[2] * x805 + x812 * x875 + x886 * x891;
  const Real x914 = sine[2] * x795 + x731 * x875 + x889 * x891;
  const Real x916 = 1 / x899;
  w.x[35] = x916;
  const Real x917 = x906 * x916;
  w.x[36] = x917;
  const Real x919 = x914 * x916;
  w.x[37] = x919;
  const Real x928 = x817 - x812 * x876 - x886 * x892;
  const Real x929 = x928 - x906 * x917;
  require_pivot(w, x929, 8 * kEpsilon * x817, 2);
  const Real x938 = cosine[2] * x795 + x731 * x876 + x889 * x892;
  const Real x940 = x914 * x917 + x938;
  const Real x942 = 1 / x929;
  w.x[38] = x942;
  const Real x943 = x940 * x942;
  w.x[39] = x943;
  const Real x954 = x818 - x731 * x877 - x889 * x893;
  const Real x956 = x954 - x914 * x919 - x940 * x943;
  require_pivot(w, x956, 8 * kEpsilon * x818, 2);
  const Real x957 = 1 / x956;
  w.x[40] = x957;
  const Real x960 = x852 - tau[2] * x779 + x865 * x873;
  w.x[41] = x960;
  const Real x965 = x855 + tau[2] * x741 - x865 * x875;
  const Real x966 = x965 - x891 * x960;
  w.x[42] = x966;
  const Real x973 = x856 - tau[2] * x747 - x865 * x876;
  const Real x975 = x973 - x892 * x960 + x917 * x966;
  w.x[43] = x975;
  const Real x871 = x696 - 3.673205103346574e-06 * x823 - tau[2] * x726;
  const Real x985 = x871 - x865 * x877 - x893 * x960;
  const Real x987 = x919 * x966 + x985 + x943 * x975;
  w.x[44] = x987;
  const Real x988 = 111.2811239393518 * x873;
  w.x[45] = x988;
  const Real x990 = 3.338433718180554 * x873;
  w.x[46] = x990;
  const Real x996 = 111.2811239393518 * x875 + x891 * x988;
  w.x[47] = x996;
  const Real x1000 = 3.338433718180554 - 111.2811239393518 * x891;
  w.x[48] = x1000;
  const Real x1003 = 0.4847683961608012 - 3.338433718180554 * x891;
  w.x[49] = x1003;
  const Real x1008 = 3.338433718180554 * x875 + x891 * x990;
  w.x[50] = x1008;
  const Real x1016 = -3.338433718180554 - 111.2811239393518 * x876 - x892 * x988;
  const Real x1017 = x1016 - x917 * x996;
  w.x[51] = x1017;
  const Real x1022 = x917 * x1000 - 111.2811239393518 * x892;
  w.x[52] = x1022;
  const Real x1027 = x917 * x1003 - 3.338433718180554 * x892;
  w.x[53] = x1027;
  const Real x1035 = 0.4847683961608012 + 3.338433718180554 * x876 + x892 * x990;
  const Real x1036 = x917 * x1008 + x1035;
  w.x[54] = x1036;
  const Real x1047 = 111.2811239393518 * x877 + x893 * x988 + x919 * x996;
  const Real x1049 = x943 * x1017 - x1047;
  w.x[55] = x1049;
  const Real x1057 = x919 * x1000 - 111.2811239393518 * x893 + x943 * x1022;
  w.x[56] = x1057;
  const Real x1065 = x919 * x1003 - 3.338433718180554 * x893 + x943 * x1027;
  w.x[57] = x1065;
  const Real x1075 = 3.338433718180554 * x877 + x893 * x990 + x919 * x1008;
  const Real x1076 = x943 * x1036 + x1075;
  w.x[58] = x1076;
  const Real x1077 = 111.2811239393518 * x872;
  const Real x1078 = 3.338433718180554 * x872;
  const Real x1080 = x890 * x988;
  const Real x1081 = 111.2811239393518 * x890;
  const Real x1082 = 3.338433718180554 * x890;
  const Real x1083 = x890 * x990;
  const Real x1085 = x916 * x996;
  const Real x1087 = x916 * x1000;
  const Real x1088 = x916 * x1003;
  const Real x1089 = x916 * x1008;
  const Real x1090 = x942 * x1017;
  const Real x1091 = x942 * x1022;
  const Real x1092 = x942 * x1027;
  const Real x1093 = x942 * x1036;
  const Real x1094 = x957 * x1049;
  const Real x1095 = x957 * x1057;
  const Real x1096 = x957 * x1065;
  const Real x1097 = x957 * x1076;
  const Real x1098 = 0.3846153846153846 * x957;
  const Real x1110 = 111.2811239393518 - 111.2811239393518 * x1077 - x988 * x1080;
  const Real x1112 = x1110 - x996 * x1085 - x1017 * x1090;
  const Real x1113 = x1112 - x1049 * x1094;
  const Real x1123 = x996 * x1087 - x988 * x1081 - x1017 * x1091;
  const Real x1124 = x1123 - x1049 * x1095;
  const Real x1134 = x996 * x1088 - x988 * x1082 - x1017 * x1092;
  const Real x1135 = x1134 - x1049 * x1096;
  const Real x1147 = -3.338433718180554 + 111.2811239393518 * x1078 + x988 * x1083;
  const Real x1149 = x996 * x1089 + x1147 - x1017 * x1093;
  const Real x1150 = x1149 - x1049 * x1097;
  const Real x1162 = 111.2811239393518 - 111.2811239393518 * x1081 - x1000 * x1087;
  const Real x1164 = x1162 - x1022 * x1091 - x1057 * x1095;
  const Real x1174 = 3.338433718180554 - 111.2811239393518 * x1082 - x1000 * x1088;
  const Real x1176 = x1174 - x1022 * x1092 - x1057 * x1096;
  const Real x1186 = 111.2811239393518 * x1083 - x1000 * x1089 - x1022 * x1093;
  const Real x1187 = x1186 - x1057 * x1097;
  const Real x1188 = x1057 * x1098;
  const Real x1199 = 0.4847683961608012 - 3.338433718180554 * x1082 - x1003 * x1088;
  const Real x1201 = x1199 - x1027 * x1092 - x1065 * x1096;
  const Real x1211 = 3.338433718180554 * x1083 - x1003 * x1089 - x1027 * x1093;
  const Real x1212 = x1211 - x1065 * x1097;
  const Real x1226 = 0.4847683961608012 - 3.338433718180554 * x1078 - x990 * x1083;
  const Real x1228 = x1226 - x1008 * x1089 - x1036 * x1093;
  const Real x1243 = x865 * x1077 + x960 * x1080 - x966 * x1085;
  const Real x1251 = x960 * x1081 + x966 * x1087 + x975 * x1091;
  const Real x1258 = x960 * x1082 + x966 * x1088 + x975 * x1092;
  const Real x1269 = x966 * x1089 - (x865 * x1078 + x960 * x1083);
  const Real x1273 = x975 * x1090 + x1243 + x987 * x1094 - x683;
  const Real x1274 = x987 * x1095 + x1251 - x686;
  const Real x1275 = x687 + 254.29116338207245 * tau[2];
  const Real x1276 = x987 * x1096 + x1258 - x691;
  // link 4 "forearm": acceleration where nothing acts on it
  const Real x1320 = x199 * 0.037748300000000005 - x249 * 0.023998300000000004;
  const Real x1302 = x211 * 0.03224830000000001 + x254 * 0.029498300000000005 - x260 * 0.011000000000000003;
  const Real x1324 = x1302 - x231 * 0.22000000000000003;
  const Real x1312 = x256 * 0.011000000000000003 - (x214 * 0.00825 + x259 * 0.005500000000000001);
  const Real x1327 = x1312 - x231 * 0.11000000000000001;
  const Real x1332 = 0.011000000000000003 * (x252 - x247) + x1320 - x239 * 0.11000000000000001;
  const Real x1333 = x1332 - x235 * 0.22000000000000003;
  const Real x1338 = x247 * 0.11000000000000001 + (x249 - x199) * 0.22000000000000003;
  const Real x1339 = x235 * 2.2 + x1338;
  const Real x1345 = (x199 + x249) * 0.11000000000000001 + x252 * 0.22000000000000003;
  const Real x1347 = x239 * 2.2 - x1345;
  const Real x1355 = x256 * 0.22000000000000003 - (x231 * 2.2 + x260 * 0.11000000000000001);
  const Real x1369 = x1324 * 97.57715913858884 - x1355 * 9.757715913858885;
  w.x[59] = x1369;
  const Real x1374 = x1327 * 363.6363636363637 - x1355 * 18.181818181818183;
  w.x[60] = x1374;
  const Real x1379 = x1339 * 9.757715913858885 + x1347 * 4.878857956929442 + x1333 * 97.57715913858884;
  w.x[61] = x1379;
  const Real x1384 = x1339 * 1.430317045931343 + x1347 * 0.48788579569294427 + x1333 * 9.757715913858885;
  w.x[62] = x1384;
  const Real x1389 = x1339 * 0.48788579569294427 + x1347 * 0.6984883523919266 + x1333 * 4.878857956929442;
  w.x[63] = x1389;
  const Real x1397 = x1355 * 2.3394079550222524 - (x1324 * 9.757715913858885 + x1327 * 18.181818181818183);
  w.x[64] = x1397;
  // joint 3 "elbow_pitch": assembly: its two sides become one chain
  const Real x1407 = x1049 * x1098 + 0.08 * x1124;
  const Real x1411 = x1188 + 0.08 * x1164;
  const Real x1417 = x1065 * x1098 + 0.08 * x1176;
  const Real x1421 = x1228 - x1076 * x1097 + 1.6274634456452637;
  const Real x1424 = x1076 * x1098 + 0.08 * x1187;
  const Real x1430 = 0.3846153846153846 - 0.3846153846153846 * x1098 + 0.08 * x1188;
  const Real x1431 = 0.08 * x1411 + x1430;
  const Real x1432 = 3.673205103346574e-06 * x1176;
  const Real x1434 = 0.9999999999932537 * x1176;
  const Real x1440 = 3.673205103346574e-06 * x1150 + 0.9999999999932537 * x1407;
  const Real x1446 = 3.673205103346574e-06 * x1407 - 0.9999999999932537 * x1150;
  const Real x1451 = 0.9999999999932537 * (20.343293070565796 - x1411) - 3.673205103346574e-06 * x1187;
  const Real x1452 = 0.9999999999932537 * x1451;
  const Real x1453 = x1411 + x1452;
  const Real x1455 = 20.343293070565796 - x1452;
  const Real x1456 = 3.673205103346574e-06 * x1451;
  const Real x1458 = x1187 + x1456;
  w.x[65] = x1458;
  const Real x1483 = cosine[3] * (x1135 + x1456) - sine[3] * (x1432 + x1440);
  const Real x1484 = sine[3] * x1483;
  const Real x1485 = x1440 + x1484;
  const Real x1489 = cosine[3] * x1483;
  const Real x1490 = x1489 - x1456;
  const Real x1492 = 3.673205103346574e-06 * x1124;
  const Real x1494 = 0.9999999999932537 * x1124;
  const Real x1497 = 3.673205103346574e-06 * (x1164 - 254.29116338207245);
  const Real x1499 = 0.9999999999932537 * x1497;
  const Real x1501 = 3.673205103346574e-06 * x1497;
  const Real x1503 = 254.29116338207245 + x1501;
  const Real x1508 = sine[3] * x1499 - cosine[3] * x1494;
  w.x[66] = x1508;
  const Real x1512 = sine[3] * x1494 + cosine[3] * x1499;
  w.x[67] = x1512;
  const Real x1515 = 2.0 * sine[3];
  const Real x1518 = cosine[3] * (x1113 - x1503) - x1492 * x1515;
  const Real x1520 = x1492 + sine[3] * x1518;
  const Real x1522 = cosine[3] * x1518;
  const Real x1529 = 3.673205103346574e-06 * x1212 + 0.9999999999932537 * x1417;
  const Real x1535 = 3.673205103346574e-06 * x1417 - 0.9999999999932537 * x1212;
  const Real x1541 = 3.673205103346574e-06 * (x1421 - x1431) + 1.9999999999865075 * x1424;
  const Real x1545 = 0.9999999999932537 * x1541 - x1424;
  const Real x1546 = 3.673205103346574e-06 * x1541;
  const Real x1548 = x1431 + x1546;
  const Real x1561 = cosine[3] * (x1201 - x1548) - x1515 * x1529;
  const Real x1565 = cosine[3] * x1561;
  const Real x1568 = x1503 + x1522 + 97.57715913858884;
  require_pivot(w, x1568, 0, 3);
  const Real x1569 = cosine[3] * x1446 - sine[3] * x1453 + -9.757715913858885;
  const Real x1570 = x1113 - x1522 + 363.6363636363637;
  const Real x1573 = sine[3] * x1455 - cosine[3] * x1434 + 9.757715913858885;
  w.x[68] = x1573;
  const Real x1574 = sine[3] * x1434 + cosine[3] * x1455 + 4.878857956929442;
  w.x[69] = x1574;
  const Real x1575 = x1548 + x1565 + 1.430317045931343;
  const Real x1577 = x1201 - x1565 + 0.6984883523919266;
  const Real x1578 = x1421 - x1546 + 2.3394079550222524;
  // joint 2 "upper_arm_roll": assembly: its two sides become one chain
  const Real x1277 = x975 * x1093 + x1269 + x987 * x1097 - x695;
  // joint 3 "elbow_pitch": assembly: its two sides become one chain
  const Real x1581 = x1277 + 0.08 * x1275;
  const Real x1584 = x987 * x1098 - x696 - 0.08 * x1274;
  const Real x1588 = 0.9999999999932537 * x1275 - 3.673205103346574e-06 * x1274;
  const Real x1605 = 0.9999999999932537 * x1584 - 3.673205103346574e-06 * x1581;
  const Real x1619 = cosine[3] * x1273 + sine[3] * x1588 + x1369;
  const Real x1631 = x1619 - tau[3] * x1508;
  w.x[70] = x1631;
  const Real x1620 = cosine[3] * x1588 - sine[3] * x1273 + x1374;
  const Real x1621 = x1379 - (0.9999999999932537 * x1274 + 3.673205103346574e-06 * x1275);
  const Real x1633 = x1621 - tau[3] * (x1164 - x1501 + 97.57715913858884);
  w.x[71] = x1633;
  const Real x1622 = cosine[3] * x1276 + sine[3] * x1605 + x1384;
  const Real x1623 = cosine[3] * x1605 - sine[3] * x1276 + x1389;
  const Real x1624 = x1397 - (0.9999999999932537 * x1581 + 3.673205103346574e-06 * x1584);
  const Real x1637 = 1 / x1568;
  w.x[72] = x1637;
  const Real x1638 = x1520 * x1637;
  w.x[73] = x1638;
  const Real x1640 = x1490 * x1637;
  w.x[74] = x1640;
  const Real x1641 = x1485 * x1637;
  w.x[75] = x1641;
  const Real x1643 = x1569 * x1637;
  w.x[76] = x1643;
  const Real x1646 = x1570 - x1520 * x1638;
  require_pivot(w, x1646, 8 * kEpsilon * x1570, 3);
  const Real x1649 = x1490 * x1638 - (x1432 + x1484);
  const Real x1652 = x1135 - x1489 - x1485 * x1638;
  const Real x1571 = -18.181818181818183 - (sine[3] * x1446 + cosine[3] * x1453);
  const Real x1655 = x1571 + x1569 * x1638;
  const Real x1656 = 1 / x1646;
  w.x[77] = x1656;
  const Real x1657 = x1649 * x1656;
  w.x[78] = x1657;
  const Real x1658 = x1652 * x1656;
  w.x[79] = x1658;
  const Real x1659 = x1655 * x1656;
  w.x[80] = x1659;
  const Real x1665 = x1575 - x1490 * x1640 - x1649 * x1657;
  require_pivot(w, x1665, 8 * kEpsilon * x1575, 3);
  const Real x1670 = 0.48788579569294427 - (x1529 + sine[3] * x1561) + x1485 * x1640;
  const Real x1671 = x1670 - x1652 * x1657;
  const Real x1676 = cosine[3] * x1535 + sine[3] * x1545 - x1569 * x1640;
  const Real x1677 = x1676 - x1655 * x1657;
  const Real x1678 = 1 / x1665;
  w.x[81] = x1678;
  const Real x1679 = x1671 * x1678;
  w.x[82] = x1679;
  const Real x1680 = x1677 * x1678;
  w.x[83] = x1680;
  const Real x1688 = x1577 - x1485 * x1641 - x1652 * x1658;
  const Real x1689 = x1688 - x1671 * x1679;
  require_pivot(w, x1689, 8 * kEpsilon * x1577, 3);
  const Real x1696 = cosine[3] * x1545 - sine[3] * x1535 + x1569 * x1641;
  const Real x1698 = x1696 - x1655 * x1658 - x1677 * x1679;
  const Real x1699 = 1 / x1689;
  w.x[84] = x1699;
  const Real x1700 = x1698 * x1699;
  w.x[85] = x1700;
  const Real x1710 = x1578 - x1569 * x1643 - x1655 * x1659;
  const Real x1712 = x1710 - x1677 * x1680 - x1698 * x1700;
  require_pivot(w, x1712, 8 * kEpsilon * x1578, 3);
  const Real x1713 = 1 / x1712;
  w.x[86] = x1713;
  const Real x1716 = x1620 - tau[3] * x1512 + x1631 * x1638;
  w.x[87] = x1716;
  const Real x1721 = x1622 - tau[3] * x1573 - x1631 * x1640;
  const Real x1722 = x1721 - x1657 * x1716;
  w.x[88] = x1722;
  const Real x1729 = x1623 - tau[3] * x1574 + x1631 * x1641;
  const Real x1731 = x1729 - x1658 * x1716 - x1679 * x1722;
  w.x[89] = x1731;
  const Real x1740 = x1624 - tau[3] * x1458 - x1631 * x1643;
  const Real x1742 = x1740 - x1659 * x1716 - x1680 * x1722;
  const Real x1743 = x1742 - x1700 * x1731;
  w.x[90] = x1743;
  const Real x1744 = 97.57715913858884 * x1638;
  w.x[91] = x1744;
  const Real x1748 = -18.181818181818183 - 9.757715913858885 * x1638;
  w.x[92] = x1748;
  const Real x1753 = 97.57715913858884 * x1640 + x1657 * x1744;
  w.x[93] = x1753;
  const Real x1755 = 363.6363636363637 * x1657;
  w.x[94] = x1755;
  const Real x1761 = 9.757715913858885 * x1640 - x1657 * x1748;
  w.x[95] = x1761;
  const Real x1769 = 97.57715913858884 * x1641 - x1658 * x1744 + x1679 * x1753;
  w.x[96] = x1769;
  const Real x1770 = 363.6363636363637 * x1658;
  w.x[97] = x1770;
}

ADAGEN_NOINLINE void part_0_1(Workspace& w) {
  ADAGEN_INPUTS
  const Real x1369 = w.x[59];
  const Real x1374 = w.x[60];
  const Real x1379 = w.x[61];
  const Real x1384 = w.x[62];
  const Real x1389 = w.x[63];
  const Real x1397 = w.x[64];
  const Real x1631 = w.x[70];
  const Real x1637 = w.x[72];
  const Real x1641 = w.x[75];
  const Real x1643 = w.x[76];
  const Real x1656 = w.x[77];
  const Real x1658 = w.x[79];
  const Real x1659 = w.x[80];
  const Real x1678 = w.x[81];
  const Real x1679 = w.x[82];
  const Real x1680 = w.x[83];
  const Real x1699 = w.x[84];
  const Real x1700 = w.x[85];
  const Real x1713 = w.x[86];
  const Real x1716 = w.x[87];
  const Real x1722 = w.x[88];
  const Real x1731 = w.x[89];
  const Real x1743 = w.x[90];
  const Real x1744 = w.x[91];
  const Real x1748 = w.x[92];
  const Real x1753 = w.x[93];
  const Real x1755 = w.x[94];
  const Real x1761 = w.x[95];
  const Real x1769 = w.x[96];
  const Real x1770 = w.x[97];
  // joint 3 "elbow_pitch": assembly: its two sides become one chain
  const Real x1774 = x1679 * x1755 - x1770;
  w.x[98] = x1774;
  const Real x1777 = 4.878857956929442 - 9.757715913858885 * x1679;
  w.x[99] = x1777;
  const Real x1780 = 0.48788579569294427 - 1.430317045931343 * x1679;
  w.x[100] = x1780;
  const Real x1783 = 0.6984883523919266 - 0.48788579569294427 * x1679;
  w.x[101] = x1783;
  const Real x1792 = 9.757715913858885 * x1641 + x1658 * x1748 + x1679 * x1761;
  w.x[102] = x1792;
  const Real x1803 = -9.757715913858885 - 97.57715913858884 * x1643 - x1659 * x1744;
  const Real x1805 = x1680 * x1753 + x1803 - x1700 * x1769;
  w.x[103] = x1805;
  const Real x1813 = -18.181818181818183 - 363.6363636363637 * x1659 + x1680 * x1755;
  const Real x1814 = x1813 - x1700 * x1774;
  w.x[104] = x1814;
  const Real x1819 = 9.757715913858885 * x1680 + x1700 * x1777;
  w.x[105] = x1819;
  const Real x1825 = 1.430317045931343 * x1680 + x1700 * x1780;
  w.x[106] = x1825;
  const Real x1831 = 0.48788579569294427 * x1680 + x1700 * x1783;
  w.x[107] = x1831;
  const Real x1842 = 2.3394079550222524 + 9.757715913858885 * x1643 - x1659 * x1748;
  const Real x1844 = x1842 - x1680 * x1761 + x1700 * x1792;
  w.x[108] = x1844;
  const Real x1845 = 97.57715913858884 * x1637;
  const Real x1846 = 9.757715913858885 * x1637;
  const Real x1848 = x1656 * x1744;
  const Real x1849 = 363.6363636363637 * x1656;
  const Real x1850 = x1656 * x1748;
  const Real x1851 = x1678 * x1753;
  const Real x1853 = x1678 * x1755;
  const Real x1855 = 9.757715913858885 * x1678;
  const Real x1856 = 1.430317045931343 * x1678;
  const Real x1857 = 0.48788579569294427 * x1678;
  const Real x1858 = x1678 * x1761;
  const Real x1859 = x1699 * x1769;
  const Real x1860 = x1699 * x1774;
  const Real x1861 = x1699 * x1777;
  const Real x1862 = x1699 * x1780;
  const Real x1863 = x1699 * x1783;
  const Real x1864 = x1699 * x1792;
  const Real x1866 = x1713 * x1805;
  const Real x1867 = x1713 * x1814;
  const Real x1868 = x1713 * x1819;
  const Real x1870 = x1713 * x1825;
  const Real x1872 = x1713 * x1831;
  const Real x1874 = x1713 * x1844;
  const Real x1886 = 97.57715913858884 - 97.57715913858884 * x1845 - x1744 * x1848;
  const Real x1888 = x1886 - x1753 * x1851 - x1769 * x1859;
  const Real x1889 = x1888 - x1805 * x1866;
  w.x[109] = x1889;
  const Real x1900 = x1744 * x1849 + x1753 * x1853 + x1769 * x1860;
  const Real x1902 = x1805 * x1867 + x1900;
  w.x[110] = x1902;
  const Real x1911 = x1753 * x1855 - x1769 * x1861 + x1805 * x1868;
  w.x[111] = x1911;
  const Real x1919 = x1753 * x1856 - x1769 * x1862 + x1805 * x1870;
  w.x[112] = x1919;
  const Real x1927 = x1753 * x1857 - x1769 * x1863 + x1805 * x1872;
  w.x[113] = x1927;
  const Real x1939 = -9.757715913858885 + 97.57715913858884 * x1846 - x1744 * x1850;
  const Real x1941 = x1753 * x1858 + x1939 + x1769 * x1864;
  const Real x1942 = x1941 - x1805 * x1874;
  w.x[114] = x1942;
  const Real x1952 = 363.6363636363637 - 363.6363636363637 * x1849 - x1755 * x1853;
  const Real x1954 = x1952 - x1774 * x1860 - x1814 * x1867;
  w.x[115] = x1954;
  const Real x1962 = x1755 * x1855 - x1774 * x1861 + x1814 * x1868;
  w.x[116] = x1962;
  const Real x1970 = x1755 * x1856 - x1774 * x1862 + x1814 * x1870;
  w.x[117] = x1970;
  const Real x1978 = x1755 * x1857 - x1774 * x1863 + x1814 * x1872;
  w.x[118] = x1978;
  const Real x1988 = -18.181818181818183 - 363.6363636363637 * x1850 + x1755 * x1858;
  const Real x1990 = x1774 * x1864 + x1988 - x1814 * x1874;
  w.x[119] = x1990;
  const Real x1998 = 97.57715913858884 - 9.757715913858885 * x1855 - x1777 * x1861;
  const Real x1999 = x1998 - x1819 * x1868;
  w.x[120] = x1999;
  const Real x2007 = 9.757715913858885 - 9.757715913858885 * x1856 - x1777 * x1862;
  const Real x2008 = x2007 - x1819 * x1870;
  w.x[121] = x2008;
  const Real x2016 = 4.878857956929442 - 9.757715913858885 * x1857 - x1777 * x1863;
  const Real x2017 = x2016 - x1819 * x1872;
  w.x[122] = x2017;
  const Real x2025 = x1777 * x1864 - 9.757715913858885 * x1858 + x1819 * x1874;
  w.x[123] = x2025;
  const Real x2033 = 1.430317045931343 - 1.430317045931343 * x1856 - x1780 * x1862;
  const Real x2034 = x2033 - x1825 * x1870;
  w.x[124] = x2034;
  const Real x2042 = 0.48788579569294427 - 1.430317045931343 * x1857 - x1780 * x1863;
  const Real x2043 = x2042 - x1825 * x1872;
  w.x[125] = x2043;
  const Real x2051 = x1780 * x1864 - 1.430317045931343 * x1858 + x1825 * x1874;
  w.x[126] = x2051;
  const Real x2059 = 0.6984883523919266 - 0.48788579569294427 * x1857 - x1783 * x1863;
  const Real x2060 = x2059 - x1831 * x1872;
  w.x[127] = x2060;
  const Real x2068 = x1783 * x1864 - 0.48788579569294427 * x1858 + x1831 * x1874;
  w.x[128] = x2068;
  const Real x2080 = 2.3394079550222524 - 9.757715913858885 * x1846 - x1748 * x1850;
  const Real x2082 = x2080 - x1761 * x1858 - x1792 * x1864;
  const Real x2083 = x2082 - x1844 * x1874;
  w.x[129] = x2083;
  const Real x2094 = x1631 * x1845 + x1716 * x1848 - x1722 * x1851;
  const Real x2103 = x1716 * x1849 - x1722 * x1853 + x1731 * x1860;
  const Real x2131 = x1716 * x1850 - x1631 * x1846 + x1722 * x1858;
  const Real x2110 = x1722 * x1855 + x1731 * x1861 - x1743 * x1868;
  const Real x2116 = x1722 * x1856 + x1731 * x1862 - x1743 * x1870;
  const Real x2122 = x1722 * x1857 + x1731 * x1863 - x1743 * x1872;
  const Real x2137 = x1731 * x1859 + x2094 + x1743 * x1866 - x1369;
  w.x[130] = x2137;
  const Real x2138 = x1743 * x1867 + x2103 - x1374;
  w.x[131] = x2138;
  const Real x2139 = 97.57715913858884 * tau[3] + x2110 - x1379;
  w.x[132] = x2139;
  const Real x2140 = 9.757715913858885 * tau[3] + x2116 - x1384;
  w.x[133] = x2140;
  const Real x2141 = 4.878857956929442 * tau[3] + x2122 - x1389;
  w.x[134] = x2141;
  const Real x2142 = x2131 - x1731 * x1864 + x1743 * x1874 - x1397;
  w.x[135] = x2142;
}

ADAGEN_NOINLINE void part_0_2(Workspace& w) {
  ADAGEN_INPUTS
  const Real x1889 = w.x[109];
  const Real x1902 = w.x[110];
  const Real x1911 = w.x[111];
  const Real x1919 = w.x[112];
  const Real x1927 = w.x[113];
  const Real x1942 = w.x[114];
  const Real x1954 = w.x[115];
  const Real x1962 = w.x[116];
  const Real x1970 = w.x[117];
  const Real x1978 = w.x[118];
  const Real x1990 = w.x[119];
  const Real x1999 = w.x[120];
  const Real x2008 = w.x[121];
  const Real x2017 = w.x[122];
  const Real x2025 = w.x[123];
  const Real x2034 = w.x[124];
  const Real x2043 = w.x[125];
  const Real x2051 = w.x[126];
  const Real x2060 = w.x[127];
  const Real x2068 = w.x[128];
  const Real x2083 = w.x[129];
  const Real x2137 = w.x[130];
  const Real x2138 = w.x[131];
  const Real x2139 = w.x[132];
  const Real x2140 = w.x[133];
  const Real x2141 = w.x[134];
  const Real x2142 = w.x[135];
  // message received
  const Real x2143 = w.from[0][0];
  const Real x2144 = w.from[0][1];
  const Real x2145 = w.from[0][2];
  const Real x2146 = w.from[0][3];
  const Real x2147 = w.from[0][4];
  const Real x2148 = w.from[0][5];
  const Real x2149 = w.from[0][6];
  const Real x2150 = w.from[0][7];
  const Real x2151 = w.from[0][8];
  const Real x2152 = w.from[0][9];
  const Real x2153 = w.from[0][10];
  const Real x2154 = w.from[0][11];
  w.x[97] = x2154;
  const Real x2155 = w.from[0][12];
  const Real x2156 = w.from[0][13];
  const Real x2157 = w.from[0][14];
  const Real x2158 = w.from[0][15];
  const Real x2159 = w.from[0][16];
  const Real x2160 = w.from[0][17];
  const Real x2161 = w.from[0][18];
  const Real x2162 = w.from[0][19];
  const Real x2163 = w.from[0][20];
  const Real x2164 = w.from[0][21];
  const Real x2165 = w.from[0][22];
  const Real x2166 = w.from[0][23];
  w.x[64] = x2166;
  const Real x2167 = w.from[0][24];
  const Real x2168 = w.from[0][25];
  const Real x2169 = w.from[0][26];
  // joint 4 "forearm_roll": assembly: its two sides become one chain
  const Real x2172 = 0.38 * x1911;
  const Real x2174 = x1919 - x2172;
  const Real x2177 = x1927 - 0.08 * x1911;
  const Real x2183 = x1942 - 0.08 * x1902 + 0.38 * x1889;
  const Real x2186 = x1970 - 0.38 * x1962;
  const Real x2187 = 0.08 * x1962;
  const Real x2189 = x1978 - x2187;
  const Real x2194 = x1990 + 0.08 * x1954 - 0.38 * x1902;
  const Real x2197 = x2008 - 0.38 * x1999;
  const Real x2200 = x2017 - 0.08 * x1999;
  const Real x2202 = x2025 + x2187 + x2172;
  const Real x2208 = x2034 - 0.38 * x2008 - 0.38 * x2197;
  const Real x2214 = x2043 - 0.38 * x2017 - 0.08 * x2197;
  const Real x2221 = x2051 - 0.38 * x2025 + 0.08 * x2186;
  const Real x2222 = 0.38 * x2174 + x2221;
  const Real x2228 = x2060 - 0.08 * x2017 - 0.08 * x2200;
  const Real x2235 = x2068 - 0.08 * x2025 + 0.08 * x2189;
  const Real x2236 = 0.38 * x2177 + x2235;
  const Real x2244 = x2083 + 0.08 * x1990 + 0.38 * x1942;
  const Real x2246 = 0.08 * x2194 + x2244 + 0.38 * x2183;
  const Real x2251 = 3.673205103346574e-06 * x2186 + 0.9999999999932537 * x2197;
  const Real x2256 = 0.9999999999932537 * x2186 - 3.673205103346574e-06 * x2197;
  const Real x2261 = 3.673205103346574e-06 * x2177 + 0.9999999999932537 * x2183;
  const Real x2266 = 0.9999999999932537 * x2177 - 3.673205103346574e-06 * x2183;
  const Real x2273 = 3.673205103346574e-06 * (x2189 - x2202) + 0.9999999999932537 * (x2194 + x2200);
  const Real x2275 = 0.9999999999932537 * x2273;
  const Real x2277 = x2194 - x2275;
  const Real x2278 = x2200 - x2275;
  const Real x2279 = 3.673205103346574e-06 * x2273;
  const Real x2281 = x2202 + x2279;
  const Real x2303 = cosine[4] * (x2174 - x2281) - sine[4] * (x2251 + x2261);
  const Real x2304 = sine[4] * x2303;
  const Real x2309 = cosine[4] * x2303;
  const Real x2316 = 3.673205103346574e-06 * x1902 - 0.9999999999932537 * x1911;
  const Real x2321 = 0.9999999999932537 * x1902 + 3.673205103346574e-06 * x1911;
  const Real x2328 = 3.673205103346574e-06 * (x1954 - x1999) + 1.9999999999865075 * x1962;
  const Real x2332 = x1962 - 0.9999999999932537 * x2328;
  const Real x2333 = 3.673205103346574e-06 * x2328;
  w.x[63] = x2333;
  const Real x2335 = x1999 + x2333;
  const Real x2347 = 2.0 * sine[4];
  const Real x2349 = cosine[4] * (x1889 - x2335) + x2316 * x2347;
  const Real x2352 = cosine[4] * x2349;
  const Real x2359 = 3.673205103346574e-06 * x2214 + 0.9999999999932537 * x2222;
  const Real x2364 = 0.9999999999932537 * x2214 - 3.673205103346574e-06 * x2222;
  const Real x2370 = 3.673205103346574e-06 * (x2228 - x2246) + 1.9999999999865075 * x2236;
  const Real x2374 = x2236 - 0.9999999999932537 * x2370;
  const Real x2375 = 3.673205103346574e-06 * x2370;
  const Real x2377 = x2246 + x2375;
  const Real x2390 = cosine[4] * (x2208 - x2377) - x2347 * x2359;
  const Real x2394 = cosine[4] * x2390;
  const Real x2397 = x2335 + x2352 + x2143;
  require_pivot(w, x2397, 0, 4);
  const Real x2398 = x2316 - sine[4] * x2349 + x2144;
  const Real x2399 = sine[4] * x2332 - cosine[4] * x2321 + x2145;
  w.x[62] = x2399;
  const Real x2400 = x2281 + x2309 + x2146;
  const Real x2401 = x2147 - (x2261 + x2304);
  const Real x2402 = cosine[4] * x2266 + sine[4] * x2277 + x2148;
  const Real x2403 = x1889 - x2352 + x2149;
  const Real x2404 = sine[4] * x2321 + cosine[4] * x2332 + x2150;
  w.x[61] = x2404;
  const Real x2409 = cosine[4] * x2256 + sine[4] * x2278 + x2155;
  w.x[60] = x2409;
  const Real x2410 = cosine[4] * x2278 - sine[4] * x2256 + x2156;
  w.x[59] = x2410;
  const Real x2411 = x2189 - x2279 + x2157;
  w.x[136] = x2411;
  const Real x2412 = x2377 + x2394 + x2158;
  const Real x2415 = x2208 - x2394 + x2161;
  const Real x2417 = x2228 - x2375 + x2163;
  const Real x2420 = x2140 - 0.38 * x2139;
  const Real x2423 = x2141 - 0.08 * x2139;
  const Real x2428 = x2142 + 0.08 * x2138 + 0.38 * x2137;
  const Real x2433 = 3.673205103346574e-06 * x2138 + 0.9999999999932537 * x2139;
  const Real x2453 = 3.673205103346574e-06 * x2423 + 0.9999999999932537 * x2428;
  const Real x2469 = cosine[4] * x2137 - sine[4] * x2433 - x2164;
  const Real x2483 = x2469 - tau[4] * x2399;
  const Real x2470 = sine[4] * x2137 + cosine[4] * x2433 + x2165;
  const Real x2473 = cosine[4] * x2420 - sine[4] * x2453 - x2167;
  const Real x2474 = sine[4] * x2420 + cosine[4] * x2453 + x2168;
  const Real x2476 = 0.9999999999932537 * x2423 - 3.673205103346574e-06 * x2428 - x2169;
  const Real x2491 = 1 / x2397;
  const Real x2492 = x2398 * x2491;
  const Real x2493 = x2400 * x2491;
  const Real x2494 = x2401 * x2491;
  const Real x2495 = x2402 * x2491;
  const Real x2498 = x2403 - x2398 * x2492;
  require_pivot(w, x2498, 8 * kEpsilon * x2403, 4);
  const Real x2501 = x2151 - (x2251 + x2304) - x2400 * x2492;
  const Real x2504 = x2174 - x2309 + x2152 - x2401 * x2492;
  const Real x2407 = cosine[4] * x2277 - sine[4] * x2266 + x2153;
  const Real x2507 = x2407 - x2402 * x2492;
  const Real x2508 = 1 / x2498;
  const Real x2509 = x2501 * x2508;
  const Real x2510 = x2504 * x2508;
  const Real x2511 = x2507 * x2508;
  const Real x2517 = x2412 - x2400 * x2493 - x2501 * x2509;
  require_pivot(w, x2517, 8 * kEpsilon * x2412, 4);
  const Real x2522 = x2159 - (x2359 + sine[4] * x2390) - x2401 * x2493;
  const Real x2523 = x2522 - x2504 * x2509;
  const Real x2414 = cosine[4] * x2364 + sine[4] * x2374 + x2160;
  const Real x2529 = x2414 - x2402 * x2493 - x2507 * x2509;
  const Real x2530 = 1 / x2517;
  const Real x2531 = x2523 * x2530;
  const Real x2532 = x2529 * x2530;
  const Real x2540 = x2415 - x2401 * x2494 - x2504 * x2510;
  const Real x2541 = x2540 - x2523 * x2531;
  require_pivot(w, x2541, 8 * kEpsilon * x2415, 4);
  const Real x2416 = cosine[4] * x2374 - sine[4] * x2364 + x2162;
  const Real x2549 = x2416 - x2402 * x2494 - x2507 * x2510;
  const Real x2550 = x2549 - x2529 * x2531;
  const Real x2551 = 1 / x2541;
  const Real x2552 = x2550 * x2551;
  const Real x2562 = x2417 - x2402 * x2495 - x2507 * x2511;
  const Real x2564 = x2562 - x2529 * x2532 - x2550 * x2552;
  require_pivot(w, x2564, 8 * kEpsilon * x2417, 4);
  const Real x2568 = x2470 + tau[4] * x2404 + x2483 * x2492;
  const Real x2574 = x2473 - tau[4] * x2409 - x2483 * x2493;
  const Real x2575 = x2509 * x2568 + x2574;
  const Real x2582 = x2474 + tau[4] * x2410 + x2483 * x2494;
  const Real x2585 = x2510 * x2568 - x2582 - x2531 * x2575;
  const Real x2594 = x2476 - tau[4] * x2411 - x2483 * x2495;
  const Real x2596 = x2511 * x2568 + x2594 - x2532 * x2575;
  // joint 4 "forearm_roll": disassembly: its acceleration and force
  const Real x2604 = 1 / x2564 * (x2596 - x2552 * x2585);
  w.x[137] = x2604;
  w.to[1][5] = x2604;
  const Real x2607 = x2551 * x2585 - x2552 * x2604;
  w.x[138] = x2607;
  w.to[1][4] = x2607;
  const Real x2613 = x2530 * x2575 - x2532 * x2604 - x2531 * x2607;
  w.x[139] = x2613;
  w.to[1][3] = x2613;
  const Real x2622 = x2508 * x2568 + x2511 * x2604 + x2510 * x2607;
  const Real x2624 = x2509 * x2613 + x2622;
  w.x[140] = x2624;
  const Real x2625 = -x2624;
  w.to[1][1] = x2625;
  const Real x2635 = x2483 * x2491 - x2495 * x2604 - x2494 * x2607;
  const Real x2637 = x2635 - x2493 * x2613 + x2492 * x2624;
  w.x[141] = x2637;
  w.to[1][0] = x2637;
}

ADAGEN_NOINLINE void part_0_3(Workspace& w) {
  ADAGEN_INPUTS
  const Real x399 = w.x[0];
  const Real x496 = w.x[1];
  const Real x497 = w.x[2];
  const Real x525 = w.x[3];
  const Real x527 = w.x[4];
  const Real x528 = w.x[5];
  const Real x529 = w.x[6];
  const Real x530 = w.x[7];
  const Real x531 = w.x[8];
  const Real x535 = w.x[9];
  const Real x537 = w.x[10];
  const Real x538 = w.x[11];
  const Real x547 = w.x[12];
  const Real x548 = w.x[13];
  const Real x551 = w.x[14];
  const Real x557 = w.x[15];
  const Real x558 = w.x[16];
  const Real x565 = w.x[17];
  const Real x566 = w.x[18];
  const Real x726 = w.x[19];
  const Real x741 = w.x[20];
  const Real x747 = w.x[21];
  const Real x775 = w.x[22];
  const Real x779 = w.x[23];
  const Real x865 = w.x[24];
  const Real x867 = w.x[25];
  const Real x872 = w.x[26];
  const Real x873 = w.x[27];
  const Real x875 = w.x[28];
  const Real x876 = w.x[29];
  const Real x877 = w.x[30];
  const Real x890 = w.x[31];
  const Real x891 = w.x[32];
  const Real x892 = w.x[33];
  const Real x893 = w.x[34];
  const Real x916 = w.x[35];
  const Real x917 = w.x[36];
  const Real x919 = w.x[37];
  const Real x942 = w.x[38];
  const Real x943 = w.x[39];
  const Real x957 = w.x[40];
  const Real x960 = w.x[41];
  const Real x966 = w.x[42];
  const Real x975 = w.x[43];
  const Real x987 = w.x[44];
  const Real x988 = w.x[45];
  const Real x990 = w.x[46];
  const Real x996 = w.x[47];
  const Real x1000 = w.x[48];
  const Real x1003 = w.x[49];
  const Real x1008 = w.x[50];
  const Real x1017 = w.x[51];
  const Real x1022 = w.x[52];
  const Real x1027 = w.x[53];
  const Real x1036 = w.x[54];
  const Real x1049 = w.x[55];
  const Real x1057 = w.x[56];
  const Real x1065 = w.x[57];
  const Real x1076 = w.x[58];
  const Real x1458 = w.x[65];
  const Real x1508 = w.x[66];
  const Real x1512 = w.x[67];
  const Real x1573 = w.x[68];
  const Real x1574 = w.x[69];
  const Real x1631 = w.x[70];
  const Real x1633 = w.x[71];
  const Real x1637 = w.x[72];
  const Real x1638 = w.x[73];
  const Real x1640 = w.x[74];
  const Real x1641 = w.x[75];
  const Real x1643 = w.x[76];
  const Real x1656 = w.x[77];
  const Real x1657 = w.x[78];
  const Real x1658 = w.x[79];
  const Real x1659 = w.x[80];
  const Real x1678 = w.x[81];
  const Real x1679 = w.x[82];
  const Real x1680 = w.x[83];
  const Real x1699 = w.x[84];
  const Real x1700 = w.x[85];
  const Real x1713 = w.x[86];
  const Real x1716 = w.x[87];
  const Real x1722 = w.x[88];
  const Real x1731 = w.x[89];
  const Real x1743 = w.x[90];
  const Real x1744 = w.x[91];
  const Real x1748 = w.x[92];
  const Real x1753 = w.x[93];
  const Real x1755 = w.x[94];
  const Real x1761 = w.x[95];
  const Real x1769 = w.x[96];
  const Real x1774 = w.x[98];
  const Real x1777 = w.x[99];
  const Real x1780 = w.x[100];
  const Real x1783 = w.x[101];
  const Real x1792 = w.x[102];
  const Real x1805 = w.x[103];
  const Real x1814 = w.x[104];
  const Real x1819 = w.x[105];
  const Real x1825 = w.x[106];
  const Real x1831 = w.x[107];
  const Real x1844 = w.x[108];
  const Real x1954 = w.x[115];
  const Real x2138 = w.x[131];
  const Real x2139 = w.x[132];
  const Real x2154 = w.x[97];
  const Real x2166 = w.x[64];
  const Real x2333 = w.x[63];
  const Real x2399 = w.x[62];
  const Real x2404 = w.x[61];
  const Real x2409 = w.x[60];
  const Real x2410 = w.x[59];
  const Real x2411 = w.x[136];
  const Real x2604 = w.x[137];
  const Real x2607 = w.x[138];
  const Real x2613 = w.x[139];
  const Real x2624 = w.x[140];
  const Real x2637 = w.x[141];
  // joint 4 "forearm_roll": assembly: its two sides become one chain
  const Real x2472 = 0.9999999999932537 * x2138 - 3.673205103346574e-06 * x2139 - x2166;
  // joint 4 "forearm_roll": disassembly: its acceleration and force
  const Real x2645 = x2410 * x2607 + x2411 * x2604 + x2409 * x2613;
  const Real x2647 = x2645 - x2404 * x2624 + x2399 * x2637;
  const Real x2648 = x2647 - (x2472 - tau[4] * (x1954 - x2333 + x2154));
  w.result[4] = x2648;
  const Real x2656 = sine[4] * x2637 - cosine[4] * x2624;
  const Real x2670 = cosine[4] * x2613 - sine[4] * x2607;
  const Real x2673 = sine[4] * x2613 + cosine[4] * x2607;
  const Real x2677 = 0.9999999999932537 * x2604 - 3.673205103346574e-06 * x2673;
  const Real x2682 = 0.9999999999932537 * x2673 + 3.673205103346574e-06 * x2604;
  const Real x2686 = cosine[4] * x2637 + sine[4] * x2624 - 0.38 * x2682;
  const Real x2689 = 0.9999999999932537 * tau[4] - 3.673205103346574e-06 * x2656 - 0.08 * x2682;
  const Real x2665 = 0.9999999999932537 * x2656 + 3.673205103346574e-06 * tau[4];
  const Real x2696 = 0.08 * x2677 + 0.38 * x2670 + x2665;
  // joint 3 "elbow_pitch": disassembly: its acceleration and force
  const Real x2728 = x1761 * x2682 - (1.430317045931343 * x2670 + 0.48788579569294427 * x2677);
  const Real x2730 = x1753 * x2686 + x2728 + x1755 * x2689;
  const Real x2745 = x1780 * x2670 + x1783 * x2677 + x1792 * x2682;
  const Real x2749 = x1769 * x2686 + x2745 + x1774 * x2689;
  const Real x2764 = x1825 * x2670 + x1831 * x2677 + x1844 * x2682;
  const Real x2766 = x2764 - x1805 * x2686 - x1814 * x2689;
  const Real x2715 = x1748 * x2682 - x1744 * x2686 - 363.6363636363637 * x2689;
  const Real x2780 = 97.57715913858884 * x2696 - (9.757715913858885 * x2670 + 4.878857956929442 * x2677);
  const Real x2786 = x1713 * (x1743 - (x2766 - x1819 * x2696));
  const Real x2785 = x1699 * (x1731 - (x1777 * x2696 - x2749));
  const Real x2789 = x2785 - x1700 * x2786;
  const Real x2784 = x1678 * (x1722 - (9.757715913858885 * x2696 + x2730));
  const Real x2795 = x2784 - x1680 * x2786 - x1679 * x2789;
  const Real x2802 = x1656 * (x1716 - x2715) - x1659 * x2786;
  const Real x2804 = x2802 - x1658 * x2789 - x1657 * x2795;
  const Real x2782 = x1637 * (97.57715913858884 * x2686 + 9.757715913858885 * x2682 + x1631);
  const Real x2814 = x2782 - x1643 * x2786 + x1641 * x2789;
  const Real x2816 = x2814 - x1640 * x2795 + x1638 * x2804;
  const Real x2823 = x1574 * x2789 + x1458 * x2786 + x1573 * x2795;
  const Real x2825 = x1512 * x2804 + x2823 + x1508 * x2816;
  const Real x2826 = x2780 - x1633 + x2825;
  w.result[3] = x2826;
  const Real x2830 = cosine[3] * x2816 - sine[3] * x2804;
  const Real x2833 = sine[3] * x2816 + cosine[3] * x2804;
  const Real x2847 = cosine[3] * x2795 - sine[3] * x2789;
  const Real x2850 = sine[3] * x2795 + cosine[3] * x2789;
  const Real x2855 = 3.673205103346574e-06 * x2850 + 0.9999999999932537 * x2786;
  const Real x2860 = 0.9999999999932537 * x2850 - 3.673205103346574e-06 * x2786;
  const Real x2863 = 3.673205103346574e-06 * x2833 + 0.9999999999932537 * tau[3] + 0.08 * x2860;
  // joint 2 "upper_arm_roll": disassembly: its acceleration and force
  const Real x2887 = 3.338433718180554 * x2847 + x990 * x2855 + x988 * x2830;
  const Real x2897 = x1008 * x2855 - x1003 * x2847 + x996 * x2830;
  const Real x2906 = x1036 * x2855 - x1027 * x2847 - x1017 * x2830;
  const Real x2917 = x1076 * x2855 - x1065 * x2847 - 0.3846153846153846 * x2860;
  // joint 3 "elbow_pitch": disassembly: its acceleration and force
  const Real x2867 = 0.9999999999932537 * x2833 - 3.673205103346574e-06 * tau[3] - 0.08 * x2855;
  // joint 2 "upper_arm_roll": disassembly: its acceleration and force
  const Real x2924 = x987 - (x2917 - x1049 * x2830 + x1057 * x2863);
  const Real x2932 = x957 * x2924;
  const Real x2931 = x942 * (x975 - (x1022 * x2863 + x2906));
  const Real x2935 = x2931 + x943 * x2932;
  const Real x2930 = x916 * (x966 - (x1000 * x2863 + x2897));
  const Real x2941 = x2930 + x919 * x2932 + x917 * x2935;
  const Real x2929 = x890 * (x960 - (111.2811239393518 * x2863 - x2887));
  const Real x2949 = x2929 - x893 * x2932 - x892 * x2935;
  const Real x2950 = x2949 - x891 * x2941;
  const Real x2928 = x872 * (111.2811239393518 * x2830 + 3.338433718180554 * x2855 + x865);
  const Real x2960 = x2928 - x877 * x2932 - x876 * x2935;
  const Real x2962 = x2960 - x875 * x2941 + x873 * x2950;
  const Real x2970 = x747 * x2935 + x726 * x2932 - x741 * x2941;
  const Real x2972 = x779 * x2950 + x2970 + x775 * x2962;
  const Real x2973 = x867 - 254.29116338207245 * x2867 + x2972;
  w.result[2] = x2973;
  const Real x2980 = sine[2] * x2962 + cosine[2] * x2950;
  const Real x2985 = 3.673205103346574e-06 * x2980 + 0.9999999999932537 * tau[2];
  const Real x2994 = cosine[2] * x2941 - sine[2] * x2935;
  const Real x3004 = 0.9999999999932537 * (sine[2] * x2941 + cosine[2] * x2935);
  const Real x3007 = x3004 - 3.673205103346574e-06 * x2932;
  const Real x3010 = cosine[2] * x2962 - sine[2] * x2950 - 0.3 * x3007;
  const Real x3013 = 0.9999999999932537 * x2980 - 3.673205103346574e-06 * tau[2] + 0.3 * x2994;
  // joint 1 "shoulder_pitch": disassembly: its acceleration and force
  const Real x3031 = x558 * x3010 + x535 * x3007 + 179.2114695340502 * x2985;
  const Real x3045 = x566 * x2985 - (x565 * x3010 + x547 * x3007);
  const Real x3061 = x548 * (x557 - x3045);
  const Real x3064 = x537 * (x551 - x3031) + x538 * x3061;
  const Real x3057 = x529 * (56.59309564233163 * x3010 + 5.659309564233164 * x3007 + x525);
  const Real x3070 = x3057 - x531 * x3061 - x530 * x3064;
  const Real x3059 = 1.1254777070063695 * (x528 - (5.659309564233164 * x3013 - 0.8885116015846066 * x2994));
  const Real x3076 = x497 * x3064 - 5.659309564233164 * x3059 + x496 * x3070;
  const Real x3077 = 5.659309564233164 * x2994 - 56.59309564233163 * x3013 - x527 + x3076;
  w.result[1] = x3077;
  const Real x3089 = 0.9999999999932537 * (sine[1] * x3070 + cosine[1] * x3064);
  // joint 0 "base_yaw": disassembly: its acceleration and force
  const Real x3140 = x399 + 113.37868480725623 * (x3089 + 3.673205103346574e-06 * tau[1]);
  w.result[0] = x3140;
}

// =================================================================================================
// Process 1: 1813 products, 1514 sums, 17 quotients
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
  w.x[0] = x299;
  const Real x310 = x211 * cosine[4] + sine[4] * x294 - v[4] * x287;
  w.x[1] = x310;
  const Real x313 = cosine[4] * x294 - x211 * sine[4] - v[4] * x282;
  w.x[2] = x313;
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
  w.x[3] = x341;
  const Real x345 = cosine[4] * x318 - sine[4] * x336;
  w.x[4] = x345;
  const Real x350 = sine[4] * x318 + cosine[4] * x336;
  w.x[5] = x350;
  const Real x356 = x282 * x282;
  const Real x362 = x282 * x287;
  w.x[6] = x362;
  const Real x364 = x299 - x362;
  w.x[7] = x364;
  const Real x367 = x356 + x289 * x289;
  w.x[8] = x367;
  const Real x369 = x287 * x289;
  w.x[9] = x369;
  const Real x371 = x310 + x369;
  w.x[10] = x371;
  const Real x373 = x310 - x369;
  w.x[11] = x373;
  const Real x374 = x356 + x287 * x287;
  w.x[12] = x374;
  const Real x376 = x282 * x289;
  w.x[13] = x376;
  const Real x378 = x313 + x376;
  w.x[14] = x378;
  // joint 5 "wrist_pitch": placement, velocity and reference acceleration of its link
  const Real x387 = 3.673205103346574e-06 * x287 + 0.9999999999932537 * x289;
  const Real x395 = x282 * cosine[5] + sine[5] * x387;
  const Real x399 = cosine[5] * x387 - x282 * sine[5];
  const Real x400 = 0.9999999999932537 * x287 - 3.673205103346574e-06 * x289 + v[5];
  const Real x405 = 3.673205103346574e-06 * x313 + 0.9999999999932537 * x299;
  const Real x411 = 3.673205103346574e-06 * x299 - 0.9999999999932537 * x313;
  w.x[15] = x411;
  const Real x423 = x310 * cosine[5] - sine[5] * x405 + v[5] * x399;
  w.x[16] = x423;
  const Real x426 = x310 * sine[5] + cosine[5] * x405 + v[5] * x395;
  w.x[17] = x426;
  const Real x431 = 3.673205103346574e-06 * x350 + 0.9999999999932537 * x341;
  const Real x436 = 0.9999999999932537 * x350 - 3.673205103346574e-06 * x341;
  w.x[18] = x436;
  const Real x439 = x345 * cosine[5] + sine[5] * x431;
  w.x[19] = x439;
  const Real x443 = cosine[5] * x431 - x345 * sine[5];
  w.x[20] = x443;
  const Real x449 = x400 * x400;
  const Real x450 = x399 * x399 + x449;
  w.x[21] = x450;
  const Real x452 = x395 * x399;
  w.x[22] = x452;
  const Real x453 = x452 - x411;
  w.x[23] = x453;
  const Real x454 = x411 + x452;
  w.x[24] = x454;
  const Real x455 = x395 * x395 + x449;
  w.x[25] = x455;
  const Real x457 = x399 * x400;
  w.x[26] = x457;
  const Real x459 = x423 + x457;
  w.x[27] = x459;
  const Real x462 = x395 * x400;
  w.x[28] = x462;
  const Real x463 = x426 + x462;
  w.x[29] = x463;
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
  // joint 7 "left_finger_slide": placement, velocity and reference acceleration of its link
  const Real x560 = x555 * 0.13;
  const Real x565 = x549 * 0.13;
  const Real x567 = x533 - x546 * q[7] + x565;
  const Real x571 = x525 + x551 * 0.13;
  const Real x574 = 2.0 * x488;
  const Real x576 = x550 * q[7] - x571 + 2.0 * x483 * v[7];
  const Real x579 = x529 + x544 * q[7] + x560 - v[7] * x574;
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
  const Real x776 = x729 * 672.6812282367838 + x750 * 5.698005698005698 - x737 * 59.67078189300412;
  const Real x784 = x731 * 328.7950427750268 - x724 * 47.81116318204386 - x742 * 7.026218837536823;
  const Real x793 = x737 * 6.46961994674413 - (x729 * 59.67078189300412 + x750 * 0.5054466230936819);
  const Real x799 = x724 * 27.097049732773534 - x731 * 7.026218837536823 + x742 * 3.639654500566341;
  const Real x805 = x729 * 5.698005698005698 + x750 * 1.2247360482654601 - x737 * 0.5054466230936819;
  // link 9 "right_finger": acceleration where nothing acts on it
  const Real x829 = x497 * 8.33333e-06;
  const Real x846 = x667 * 5.333337e-05 - 1.5e-05 * (x653 - x665);
  const Real x837 = x829 + x660 * 5e-06 - x657 * 1.5e-05;
  const Real x859 = x837 - x649 * 0.0005;
  const Real x863 = x603 * 6.66667e-05 + x846 + x646 * 0.0005;
  const Real x864 = x640 * 0.0015 + x863;
  w.x[30] = x864;
  const Real x856 = x655 * 5.833337e-05 - x662 * 1.5e-05 - x608 * 6.16667e-05;
  const Real x866 = x856 + x649 * 0.0015;
  const Real x871 = (x603 - x667) * 0.0005 - x653 * 0.0015;
  const Real x872 = x646 * 0.05 + x871;
  w.x[31] = x872;
  const Real x878 = x657 * 0.0015 - x662 * 0.0005 + x649 * 0.05;
  const Real x885 = (x603 + x667) * 0.0015 + x665 * 0.0005;
  const Real x887 = x640 * 0.05 + x885;
  w.x[32] = x887;
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
  w.x[33] = x997;
  const Real x998 = x588 * x949;
  const Real x1004 = 1.2247360482654601 + x585 * 5.698005698005698;
  const Real x1019 = 2.65358979335273e-06 * x962 - 0.9999999999964793 * x957;
  const Real x1024 = 2.65358979335273e-06 * x957 + 0.9999999999964793 * x962;
  w.x[34] = x1024;
  const Real x1026 = 2.65358979335273e-06 * x943;
  const Real x1031 = 0.9999999999964793 * (x949 + 27.77777777777778) - x1026;
  const Real x1032 = 0.9999999999964793 * x1031;
  const Real x1036 = 2.65358979335273e-06 * x1031;
  w.x[35] = x1036;
  const Real x1065 = 2.65358979335273e-06 * (x970 - x997) + x978 * 1.9999999999929585;
  const Real x1068 = 0.9999999999964793 * x1065 - x978;
  w.x[36] = x1068;
  const Real x1069 = 2.65358979335273e-06 * x1065;
  w.x[37] = x1069;
  const Real x1073 = 3000.003000003 + x1019;
  const Real x1076 = x1032 - 27.77777777777778 + 1799.9964000071998;
  w.x[38] = x1076;
  const Real x1079 = x588 * x950 + x1004 + x585 * x956 + 25.999988000024;
  const Real x1080 = 0.9999999999964793 * x998 - 2.65358979335273e-06 * x986 + -17.999964000071998;
  w.x[39] = x1080;
  const Real x1081 = x970 - x1069 + 103.99992200024599;
  const Real x1089 = x793 + x588 * x784 + 0.13 * x776;
  w.x[40] = x1089;
  const Real x1096 = 0.13 * x769 - x799 + x585 * x784;
  w.x[41] = x1096;
  // link 9 "right_finger": acceleration where nothing acts on it
  const Real x909 = x864 * 59999.880000239995 - x872 * 599.9988000024 - x887 * 1799.9964000071998;
  const Real x913 = x866 * 59999.880000239995 - x878 * 1799.9964000071998;
  const Real x921 = x872 * 25.999988000024 - x864 * 599.9988000024 + x887 * 17.999964000071998;
  const Real x927 = x859 * 3000.003000003 - x866 * 1799.9964000071998 + x878 * 103.99992200024599;
  // joint 8 "right_finger_slide": assembly: its two sides become one chain
  const Real x1129 = tau[8] * x1024;
  const Real x1136 = x859 * 300000.3000003 + x878 * 3000.003000003 - x784 + x1129;
  w.x[42] = x1136;
  const Real x1124 = 0.9999999999964793 * x769 - 2.65358979335273e-06 * x776 + x909;
  const Real x1125 = 2.65358979335273e-06 * x769 + 0.9999999999964793 * x776 + x913;
  const Real x1126 = x588 * x769 - (x805 + x585 * x776) + x921;
  const Real x1127 = 0.9999999999964793 * x1089 + 2.65358979335273e-06 * x1096 + x927;
  const Real x1145 = x943 * 3.3296807285906615e-06;
  w.x[43] = x1145;
  const Real x1146 = x1073 * 3.3296807285906615e-06;
  w.x[44] = x1146;
  const Real x1075 = 0.9999999999964793 * x950 + 2.65358979335273e-06 * x956 + -599.9988000024;
  const Real x1155 = x1075 - x943 * 0.00015919590865819434;
  const Real x1158 = x943 + x1036 + x1073 * 0.00015919590865819434;
  const Real x1162 = x1155 * 1.658353407741297e-05;
  w.x[45] = x1162;
  const Real x1163 = x1158 * 1.658353407741297e-05;
  w.x[46] = x1163;
  const Real x1176 = 2.65358979335273e-06 * x950 - 0.9999999999964793 * x956 - x943 * 4.2244063836038523e-10;
  const Real x1177 = x1155 * 1.63606725685963e-08 + x1176;
  const Real x1182 = x1032 - x949 + -1799.9964000071998 - x1073 * 4.2244063836038523e-10;
  const Real x1183 = x1182 - x1158 * 1.63606725685963e-08;
  const Real x1185 = x1177 * 1.648191504944564e-05;
  w.x[47] = x1185;
  const Real x1186 = x1183 * 1.648191504944564e-05;
  w.x[48] = x1186;
  const Real x1194 = x1079 - x943 * x1145 - x1155 * x1162;
  const Real x1195 = x1194 - x1177 * x1185;
  require_pivot(w, x1195, 8 * kEpsilon * x1079, 8);
  const Real x1202 = 0.9999999999964793 * x986 + 2.65358979335273e-06 * x998 + x1073 * x1145;
  const Real x1205 = x1158 * x1162 - x1202 - x1183 * x1185;
  const Real x1206 = 1 / x1195;
  w.x[49] = x1206;
  const Real x1207 = x1205 * x1206;
  w.x[50] = x1207;
  const Real x1218 = x1081 - (x1073 * x1146 + x1158 * x1163);
  const Real x1220 = x1218 - x1183 * x1186 - x1205 * x1207;
  require_pivot(w, x1220, 8 * kEpsilon * x1081, 8);
  const Real x1221 = 1 / x1220;
  w.x[51] = x1221;
  const Real x1224 = x1124 - tau[8] * x1076 - x1136 * 0.00015919590865819434;
  w.x[52] = x1224;
  const Real x1229 = x1125 - tau[8] * x1036 - x1136 * 4.2244063836038523e-10;
  const Real x1230 = 1.63606725685963e-08 * x1224 + x1229;
  w.x[53] = x1230;
  const Real x1237 = x1126 - tau[8] * x1080 - x1136 * x1145;
  const Real x1239 = x1237 - x1162 * x1224 - x1185 * x1230;
  w.x[54] = x1239;
  const Real x1248 = x1127 - tau[8] * x1068 - x1136 * x1146;
  const Real x1250 = x1163 * x1224 + x1248 - x1186 * x1230;
  const Real x1251 = x1250 - x1207 * x1239;
  w.x[55] = x1251;
  const Real x1260 = x1026 - 0.9999999999964793 * x949;
  w.x[56] = x1260;
  const Real x1284 = 2.65358979335273e-06 * x971 - 0.9999999999964793 * x995;
  w.x[57] = x1284;
  const Real x1334 = 47.81116318204386 * x1145 - x950 + x1162 * 300.897586242875;
  const Real x1335 = x1185 * 0.0008033816505865777 + x1334;
  w.x[58] = x1335;
  const Real x1342 = x956 - x1162 * 0.0017850200414291078 + x1185 * 672.6812282343863;
  w.x[59] = x1342;
  const Real x1350 = x943 - 328.7950427750268 * x1145 - x1162 * 47.758820356278655;
  const Real x1351 = x1350 - x1185 * 0.0001275136846625453;
  w.x[60] = x1351;
  const Real x1357 = -0.5054466230936819 - x585 * 59.67078189300412 + x1162 * 0.00015834177779265263;
  const Real x1358 = x1357 - x1185 * 59.670781892791446;
  w.x[61] = x1358;
  const Real x1368 = 7.026218837536823 * x1145 - x588 * 27.097049732773534 + x1162 * 27.095931187385858;
  const Real x1369 = x1185 * 7.234479409858621e-05 + x1368;
  w.x[62] = x1369;
  const Real x1376 = x1004 - x1162 * 1.5120169762693617e-05 + x1185 * 5.69800569798539;
  w.x[63] = x1376;
  const Real x1385 = 0.9999999999964793 * x943 + 2.65358979335273e-06 * x949 + 47.81116318204386 * x1146;
  const Real x1387 = x1385 - x1163 * 300.897586242875 + x1186 * 0.0008033816505865777;
  const Real x1388 = x1387 - x1207 * x1335;
  w.x[64] = x1388;
  const Real x1396 = -27.77777777767998 + x1163 * 0.0017850200414291078 + x1186 * 672.6812282343863;
  const Real x1397 = x1396 - x1207 * x1342;
  w.x[65] = x1397;
  const Real x1407 = x1019 - 328.7950427750268 * x1146 + x1163 * 47.758820356278655;
  const Real x1409 = x1407 - x1186 * 0.0001275136846625453 - x1207 * x1351;
  w.x[66] = x1409;
  const Real x1417 = 1.2875816993418725 - x1163 * 0.00015834177779265263 - x1186 * 59.670781892791446;
  const Real x1418 = x1417 - x1207 * x1358;
  w.x[67] = x1418;
  const Real x1427 = 0.9999999999964793 * x971 + 2.65358979335273e-06 * x995 + 7.026218837536823 * x1146;
  const Real x1429 = x1427 - x1163 * 27.095931187385858 + x1186 * 7.234479409858621e-05;
  const Real x1430 = x1429 - x1207 * x1369;
  w.x[68] = x1430;
  const Real x1438 = -0.2352941176462304 + x1163 * 1.5120169762693617e-05 + x1186 * 5.69800569798539;
  const Real x1439 = x1438 - x1207 * x1376;
  w.x[69] = x1439;
  const Real x1455 = x1206 * x1335;
  const Real x1456 = x1206 * x1342;
  const Real x1457 = x1206 * x1351;
  const Real x1458 = x1206 * x1358;
  const Real x1459 = x1206 * x1369;
  const Real x1460 = x1206 * x1376;
  const Real x1461 = x1221 * x1388;
  const Real x1462 = x1221 * x1397;
  const Real x1463 = x1221 * x1409;
  const Real x1464 = x1221 * x1418;
  const Real x1465 = x1221 * x1430;
  const Real x1466 = x1221 * x1439;
  const Real x1481 = 299.3961237250212 - x1335 * x1455 - x1388 * x1461;
  w.x[70] = x1481;
  const Real x1492 = -3.290040935476213e-24 - x1335 * x1456 - x1388 * x1462;
  w.x[71] = x1492;
  const Real x1507 = -47.52050645167994 - x1335 * x1457 - x1388 * x1463;
  w.x[72] = x1507;
  const Real x1518 = 2.918459841587135e-25 - x1335 * x1458 - x1388 * x1464;
  w.x[73] = x1518;
  const Real x1533 = 26.96072397096317 - x1335 * x1459 - x1388 * x1465;
  w.x[74] = x1533;
  const Real x1544 = -2.786858204168086e-26 - x1335 * x1460 - x1388 * x1466;
  w.x[75] = x1544;
  const Real x1556 = 665.2231611029742 - x1342 * x1456 - x1397 * x1462;
  w.x[76] = x1556;
  const Real x1567 = 5.221991839953887e-25 - x1342 * x1457 - x1397 * x1463;
  w.x[77] = x1567;
  const Real x1579 = -59.009207467252075 - x1342 * x1458 - x1397 * x1464;
  w.x[78] = x1579;
  const Real x1590 = -2.96269318423145e-25 - x1342 * x1459 - x1397 * x1465;
  w.x[79] = x1590;
  const Real x1602 = 5.634831482284017 - x1342 * x1460 - x1397 * x1466;
  w.x[80] = x1602;
  const Real x1617 = 328.3972582458297 - x1351 * x1457 - x1409 * x1463;
  w.x[81] = x1617;
  const Real x1628 = -4.632213938029683e-26 - x1351 * x1458 - x1409 * x1464;
  w.x[82] = x1628;
  const Real x1643 = -6.997066406854872 - x1351 * x1459 - x1409 * x1465;
  w.x[83] = x1643;
  const Real x1654 = 4.423334264431528e-27 - x1351 * x1460 - x1409 * x1466;
  w.x[84] = x1654;
  const Real x1666 = 6.410934403565655 - x1358 * x1458 - x1418 * x1464;
  w.x[85] = x1666;
  const Real x1677 = 2.628083130482957e-26 - x1358 * x1459 - x1418 * x1465;
  w.x[86] = x1677;
  const Real x1689 = -0.4998426985461352 - x1358 * x1460 - x1418 * x1466;
  w.x[87] = x1689;
  const Real x1704 = 3.6273146653411508 - x1369 * x1459 - x1430 * x1465;
  w.x[88] = x1704;
  const Real x1715 = -2.5095754031136986e-27 - x1369 * x1460 - x1430 * x1466;
  w.x[89] = x1715;
  const Real x1727 = 1.224200925496994 - x1376 * x1460 - x1439 * x1466;
  w.x[90] = x1727;
  const Real x1750 = x1136 * 0.00015919590865875482 + x1224 * 0.004989945375270026 + x1230 * 1.3241268117251393e-08;
  const Real x1761 = x1224 * 2.9601940685904722e-08 - x1230 * 0.011087074859115907 + x1239 * x1456;
  const Real x1769 = x1136 * 0.0010947825175841488 + x1224 * 0.0007920100248753914 + x1230 * 2.101669718249871e-09;
  const Real x1779 = x1230 * 0.0009834887580909876 - x1224 * 2.6258662679026073e-09 + x1239 * x1458;
  const Real x1794 = x1136 * 2.339506545820704e-05 + x1224 * 0.00044934629820525036 + x1230 * 1.1923807506025343e-09;
  const Real x1805 = x1224 * 2.507458505158988e-10 - x1230 * 9.39140458654524e-05 + x1239 * x1460;
  const Real x1753 = x1239 * x1455 - x1750 + x1251 * x1461;
  const Real x1797 = x1239 * x1459 - x1794 + x1251 * x1465;
  const Real x1813 = tau[8] * x1260 + x1753 + x769;
  w.x[91] = x1813;
  const Real x1815 = x1251 * x1462 + x1761 - tau[8] * 7.371082759313139e-05 + x776;
  w.x[92] = x1815;
  const Real x1809 = x1239 * x1457 + x1769 + x1251 * x1463 - x1129;
  const Real x1817 = x784 + x1809;
  w.x[93] = x1817;
  const Real x1819 = x1251 * x1464 + x1779 + tau[8] * 3.4167136554933856e-06 + x793;
  w.x[94] = x1819;
  const Real x1821 = tau[8] * x1284 + x1797 + x799;
  w.x[95] = x1821;
  const Real x1823 = x1251 * x1466 + x1805 - tau[8] * 6.243740690241717e-07 + x805;
  w.x[96] = x1823;
  // link 8 "left_finger": acceleration where nothing acts on it
  const Real x1836 = x548 * 5.333337e-05 + (x551 - x546) * 1.5e-05;
  const Real x1830 = x829 - x543 * 5e-06 - x555 * 1.5e-05;
  const Real x1847 = x1830 - x579 * 0.0005;
  const Real x1851 = x506 * 6.66667e-05 - x1836 + x576 * 0.0005;
  const Real x1852 = x1851 - x567 * 0.0015;
  w.x[97] = x1852;
  const Real x1844 = x553 * 5.833337e-05 + x544 * 1.5e-05 + x509 * 6.16667e-05;
  const Real x1854 = x1844 + x579 * 0.0015;
  const Real x1860 = x550 * 0.0005 - x551 * 0.0015 + x576 * 0.05;
  w.x[98] = x1860;
  const Real x1865 = x555 * 0.0015 + x544 * 0.0005 + x579 * 0.05;
  const Real x1871 = x549 * 0.0015 - x546 * 0.0005 + x567 * 0.05;
  w.x[99] = x1871;
  const Real x1874 = 300000.3000003 * x1847 + 3000.003000003 * x1865;
  w.x[100] = x1874;
  const Real x1880 = 1799.9964000071998 * x1871 - 599.9988000024 * x1860 + 59999.880000239995 * x1852;
  w.x[101] = x1880;
  const Real x1884 = 59999.880000239995 * x1854 - 1799.9964000071998 * x1865;
  w.x[102] = x1884;
  const Real x1891 = 25.999988000024 * x1860 - 17.999964000071998 * x1871 - 599.9988000024 * x1852;
  w.x[103] = x1891;
  const Real x1897 = 3000.003000003 * x1847 - 1799.9964000071998 * x1854 + 103.99992200024599 * x1865;
  w.x[104] = x1897;
  // joint 7 "left_finger_slide": assembly: its two sides become one chain
  const Real x1912 = q[7] * x1507;
  w.x[105] = x1912;
  const Real x1914 = 0.13 * x1492;
  const Real x1917 = x1518 - x1912 + x1914;
  w.x[106] = x1917;
  const Real x1920 = x1533 - 0.13 * x1481;
  w.x[107] = x1920;
  const Real x1923 = x1544 + q[7] * x1481;
  w.x[108] = x1923;
  const Real x1929 = x1579 - q[7] * x1567 + 0.13 * x1556;
  w.x[109] = x1929;
  const Real x1930 = x1590 - x1914;
  w.x[110] = x1930;
  const Real x1933 = x1602 + q[7] * x1492;
  w.x[111] = x1933;
  const Real x1939 = x1628 - q[7] * x1617 + 0.13 * x1567;
  w.x[112] = x1939;
  const Real x1942 = x1643 - 0.13 * x1507;
  w.x[113] = x1942;
}

ADAGEN_NOINLINE void part_1_1(Workspace& w) {
  ADAGEN_INPUTS
  const Real x411 = w.x[15];
  const Real x423 = w.x[16];
  const Real x426 = w.x[17];
  const Real x436 = w.x[18];
  const Real x439 = w.x[19];
  const Real x443 = w.x[20];
  const Real x450 = w.x[21];
  const Real x452 = w.x[22];
  const Real x453 = w.x[23];
  const Real x454 = w.x[24];
  const Real x455 = w.x[25];
  const Real x457 = w.x[26];
  const Real x459 = w.x[27];
  const Real x462 = w.x[28];
  const Real x463 = w.x[29];
  const Real x1481 = w.x[70];
  const Real x1492 = w.x[71];
  const Real x1507 = w.x[72];
  const Real x1518 = w.x[73];
  const Real x1533 = w.x[74];
  const Real x1544 = w.x[75];
  const Real x1556 = w.x[76];
  const Real x1567 = w.x[77];
  const Real x1579 = w.x[78];
  const Real x1590 = w.x[79];
  const Real x1602 = w.x[80];
  const Real x1617 = w.x[81];
  const Real x1628 = w.x[82];
  const Real x1643 = w.x[83];
  const Real x1654 = w.x[84];
  const Real x1666 = w.x[85];
  const Real x1677 = w.x[86];
  const Real x1689 = w.x[87];
  const Real x1704 = w.x[88];
  const Real x1715 = w.x[89];
  const Real x1727 = w.x[90];
  const Real x1813 = w.x[91];
  const Real x1815 = w.x[92];
  const Real x1817 = w.x[93];
  const Real x1819 = w.x[94];
  const Real x1821 = w.x[95];
  const Real x1823 = w.x[96];
  const Real x1874 = w.x[100];
  const Real x1880 = w.x[101];
  const Real x1884 = w.x[102];
  const Real x1891 = w.x[103];
  const Real x1897 = w.x[104];
  const Real x1912 = w.x[105];
  const Real x1917 = w.x[106];
  const Real x1920 = w.x[107];
  const Real x1923 = w.x[108];
  const Real x1929 = w.x[109];
  const Real x1930 = w.x[110];
  const Real x1933 = w.x[111];
  const Real x1939 = w.x[112];
  const Real x1942 = w.x[113];
  // joint 7 "left_finger_slide": assembly: its two sides become one chain
  const Real x1943 = x1654 + x1912;
  const Real x1953 = x1666 - q[7] * x1628 + 0.13 * x1579;
  const Real x1963 = x1677 - q[7] * x1643 + 0.13 * x1590;
  const Real x1964 = x1963 - 0.13 * x1917;
  w.x[114] = x1964;
  const Real x1972 = x1689 - q[7] * x1654 + 0.13 * x1602;
  const Real x1978 = x1704 - 0.13 * x1533;
  w.x[115] = x1978;
  const Real x1984 = x1715 - 0.13 * x1544;
  w.x[116] = x1984;
  const Real x1990 = x1727 + q[7] * x1544;
  const Real x1992 = 300000.3000003 + x1617;
  require_pivot(w, x1992, 0, 7);
  const Real x1993 = 3000.003000003 + x1939;
  const Real x1994 = 59999.880000239995 + x1481;
  const Real x1996 = 1799.9964000071998 + x1920;
  w.x[117] = x1996;
  const Real x1997 = 59999.880000239995 + x1556;
  const Real x1999 = q[7] * x1923 + x1990 + 25.999988000024;
  const Real x2000 = q[7] * x1920 + x1984 + -17.999964000071998;
  w.x[118] = x2000;
  const Real x2001 = x1953 - q[7] * x1939 + 0.13 * x1929 + 103.99992200024599;
  const Real x2022 = tau[7] * x1942;
  w.x[119] = x2022;
  const Real x2024 = tau[7] * x1930;
  const Real x2028 = x1874 - x1817 - x2022;
  w.x[120] = x2028;
  const Real x2020 = q[7] * x1817 - x1819 - 0.13 * x1815 + x1897;
  const Real x2034 = 1 / x1992;
  w.x[121] = x2034;
  const Real x2035 = x1507 * x2034;
  w.x[122] = x2035;
  const Real x2036 = x1567 * x2034;
  w.x[123] = x2036;
  const Real x2037 = x1943 * x2034;
  w.x[124] = x2037;
  const Real x2038 = x1993 * x2034;
  w.x[125] = x2038;
  const Real x2039 = x1507 * x2035;
  const Real x2041 = x1994 - x2039;
  require_pivot(w, x2041, 8 * kEpsilon * x1994, 7);
  const Real x2044 = x1492 - x1567 * x2035;
  w.x[126] = x2044;
  const Real x2047 = -599.9988000024 + x1923 - x1943 * x2035;
  const Real x2050 = x1917 - x1993 * x2035;
  const Real x2051 = 1 / x2041;
  w.x[127] = x2051;
  const Real x2052 = x2044 * x2051;
  w.x[128] = x2052;
  const Real x2053 = x2047 * x2051;
  w.x[129] = x2053;
  const Real x2054 = x2050 * x2051;
  w.x[130] = x2054;
  const Real x2055 = x1567 * x2036;
  const Real x2057 = x2044 * x2052;
  const Real x2060 = x1997 - x2055 - x2057;
  require_pivot(w, x2060, 8 * kEpsilon * x1997, 7);
  const Real x2066 = x1933 - x1943 * x2036 - x2047 * x2052;
  const Real x2072 = -1799.9964000071998 + x1929 - x1993 * x2036 - x2050 * x2052;
  const Real x2073 = 1 / x2060;
  w.x[131] = x2073;
  const Real x2074 = x2066 * x2073;
  w.x[132] = x2074;
  const Real x2075 = x2072 * x2073;
  w.x[133] = x2075;
  const Real x2083 = x1999 - x1943 * x2037 - x2047 * x2053;
  const Real x2084 = x2083 - x2066 * x2074;
  require_pivot(w, x2084, 8 * kEpsilon * x1999, 7);
  const Real x2091 = q[7] * x1917 + x1972 - x1993 * x2037;
  const Real x2093 = x2091 - x2050 * x2053 - x2072 * x2074;
  const Real x2094 = 1 / x2084;
  w.x[134] = x2094;
  const Real x2095 = x2093 * x2094;
  w.x[135] = x2095;
  const Real x2105 = x2001 - x1993 * x2038 - x2050 * x2054;
  const Real x2107 = x2105 - x2072 * x2075 - x2093 * x2095;
  require_pivot(w, x2107, 8 * kEpsilon * x2001, 7);
  const Real x2108 = 1 / x2107;
  w.x[136] = x2108;
  const Real x2109 = x2028 * x2035;
  const Real x2111 = x1880 - x1813 - tau[7] * x1996 - x2109;
  w.x[137] = x2111;
  const Real x2112 = x2028 * x2036;
  const Real x2114 = x2052 * x2111;
  const Real x2117 = x1884 - x1815 - x2024 - x2112 - x2114;
  w.x[138] = x2117;
  const Real x2031 = x1891 - (x1823 + q[7] * x1813) - tau[7] * x2000;
  const Real x2125 = x2031 - x2028 * x2037 - x2053 * x2111;
  const Real x2126 = x2125 - x2074 * x2117;
  w.x[139] = x2126;
  const Real x2135 = x2020 - tau[7] * x1964 - x2028 * x2038;
  const Real x2137 = x2135 - x2054 * x2111 - x2075 * x2117;
  const Real x2138 = x2137 - x2095 * x2126;
  w.x[140] = x2138;
  const Real x2141 = x1677 - 0.13 * x1518;
  w.x[141] = x2141;
  const Real x2148 = x1481 - x2039;
  w.x[142] = x2148;
  const Real x2151 = x1507 - x1617 * x2035;
  w.x[143] = x2151;
  const Real x2154 = x1518 - x1628 * x2035;
  w.x[144] = x2154;
  const Real x2157 = x1533 - x1643 * x2035;
  w.x[145] = x2157;
  const Real x2160 = x1544 - x1654 * x2035;
  w.x[146] = x2160;
  const Real x2166 = x1492 - x1507 * x2036 - x2052 * x2148;
  w.x[147] = x2166;
  const Real x2168 = x1556 - x2055 - x2057;
  w.x[148] = x2168;
  const Real x2174 = x1567 - x1617 * x2036 - x2052 * x2151;
  w.x[149] = x2174;
  const Real x2180 = x1579 - x1628 * x2036 - x2052 * x2154;
  w.x[150] = x2180;
  const Real x2186 = x1590 - x1643 * x2036 - x2052 * x2157;
  w.x[151] = x2186;
  const Real x2192 = x1602 - x1654 * x2036 - x2052 * x2160;
  w.x[152] = x2192;
  const Real x2200 = x1923 - x1507 * x2037 - x2053 * x2148;
  const Real x2201 = x2200 - x2074 * x2166;
  w.x[153] = x2201;
  const Real x2209 = x1933 - x1567 * x2037 - x2044 * x2053;
  const Real x2210 = x2209 - x2074 * x2168;
  w.x[154] = x2210;
  const Real x2218 = x1943 - x1617 * x2037 - x2053 * x2151;
  const Real x2219 = x2218 - x2074 * x2174;
  w.x[155] = x2219;
  const Real x2226 = x1689 + q[7] * x1518 - x1628 * x2037;
  const Real x2228 = x2226 - x2053 * x2154 - x2074 * x2180;
  w.x[156] = x2228;
  const Real x2235 = x1715 + q[7] * x1533 - x1643 * x2037;
  const Real x2237 = x2235 - x2053 * x2157 - x2074 * x2186;
  w.x[157] = x2237;
  const Real x2245 = x1990 - x1654 * x2037 - x2053 * x2160;
  const Real x2246 = x2245 - x2074 * x2192;
  w.x[158] = x2246;
  const Real x2256 = x1917 - x1507 * x2038 - x2054 * x2148;
  const Real x2258 = x2256 - x2075 * x2166 - x2095 * x2201;
  w.x[159] = x2258;
  const Real x2268 = x1929 - x1567 * x2038 - x2044 * x2054;
  const Real x2270 = x2268 - x2075 * x2168 - x2095 * x2210;
  w.x[160] = x2270;
  const Real x2280 = x1939 - x1617 * x2038 - x2054 * x2151;
  const Real x2282 = x2280 - x2075 * x2174 - x2095 * x2219;
  w.x[161] = x2282;
  const Real x2292 = x1953 - x1628 * x2038 - x2054 * x2154;
  const Real x2294 = x2292 - x2075 * x2180 - x2095 * x2228;
  w.x[162] = x2294;
  const Real x2304 = x1963 - x1643 * x2038 - x2054 * x2157;
  const Real x2306 = x2304 - x2075 * x2186 - x2095 * x2237;
  w.x[163] = x2306;
  const Real x2316 = x1972 - x1654 * x2038 - x2054 * x2160;
  const Real x2318 = x2316 - x2075 * x2192 - x2095 * x2246;
  w.x[164] = x2318;
  const Real x2319 = x1617 * x2034;
  w.x[165] = x2319;
  const Real x2320 = x1628 * x2034;
  const Real x2321 = x1643 * x2034;
  const Real x2322 = x1654 * x2034;
  const Real x2323 = x2051 * x2148;
  const Real x2324 = x2051 * x2151;
  w.x[166] = x2324;
  const Real x2325 = x2051 * x2154;
  const Real x2326 = x2051 * x2157;
  const Real x2327 = x2051 * x2160;
  const Real x2328 = x2073 * x2166;
  const Real x2329 = x2073 * x2168;
  const Real x2330 = x2073 * x2174;
  w.x[167] = x2330;
  const Real x2331 = x2073 * x2180;
  const Real x2332 = x2073 * x2186;
  const Real x2333 = x2073 * x2192;
  const Real x2334 = x2094 * x2201;
  const Real x2335 = x2094 * x2210;
  const Real x2336 = x2094 * x2219;
  w.x[168] = x2336;
  const Real x2337 = x2094 * x2228;
  const Real x2338 = x2094 * x2237;
  const Real x2339 = x2094 * x2246;
  const Real x2340 = x2108 * x2258;
  const Real x2341 = x2108 * x2270;
  const Real x2342 = x2108 * x2282;
  w.x[169] = x2342;
  const Real x2343 = x2108 * x2294;
  const Real x2344 = x2108 * x2306;
  const Real x2345 = x2108 * x2318;
  const Real x2355 = x2148 - x2148 * x2323 - x2166 * x2328;
  const Real x2365 = x2166 - x2166 * x2329 - x2201 * x2335;
  const Real x2366 = x2365 - x2258 * x2341;
  const Real x2378 = x1507 - x1507 * x2319 - x2148 * x2324;
  const Real x2380 = x2378 - x2166 * x2330 - x2201 * x2336;
  const Real x2381 = x2380 - x2258 * x2342;
  w.x[170] = x2381;
  const Real x2393 = x1518 - x1507 * x2320 - x2148 * x2325;
  const Real x2395 = x2393 - x2166 * x2331 - x2201 * x2337;
  const Real x2396 = x2395 - x2258 * x2343;
  const Real x2408 = x1533 - x1507 * x2321 - x2148 * x2326;
  const Real x2410 = x2408 - x2166 * x2332 - x2201 * x2338;
  const Real x2423 = x1544 - x1507 * x2322 - x2148 * x2327;
  const Real x2425 = x2423 - x2166 * x2333 - x2201 * x2339;
  const Real x2434 = x2168 - x2168 * x2329 - x2210 * x2335;
  const Real x2447 = x1567 - x1567 * x2319 - x2044 * x2324;
  const Real x2449 = x2447 - x2168 * x2330 - x2210 * x2336;
  const Real x2450 = x2449 - x2270 * x2342;
  w.x[171] = x2450;
  const Real x2462 = x1579 - x1567 * x2320 - x2044 * x2325;
  const Real x2464 = x2462 - x2168 * x2331 - x2210 * x2337;
  const Real x2477 = x1590 - x1567 * x2321 - x2044 * x2326;
  const Real x2479 = x2477 - x2168 * x2332 - x2210 * x2338;
  const Real x2492 = x1602 - x1567 * x2322 - x2044 * x2327;
  const Real x2494 = x2492 - x2168 * x2333 - x2210 * x2339;
  const Real x2522 = x1628 - x1617 * x2320 - x2151 * x2325;
  const Real x2524 = x2522 - x2174 * x2331 - x2219 * x2337;
  const Real x2537 = x1643 - x1617 * x2321 - x2151 * x2326;
  const Real x2539 = x2537 - x2174 * x2332 - x2219 * x2338;
  const Real x2552 = x1654 - x1617 * x2322 - x2151 * x2327;
  const Real x2554 = x2552 - x2174 * x2333 - x2219 * x2339;
  const Real x2555 = x2554 - x2282 * x2345;
  w.x[172] = x2555;
  const Real x2567 = x1666 - x1628 * x2320 - x2154 * x2325;
  const Real x2569 = x2567 - x2180 * x2331 - x2228 * x2337;
  const Real x2582 = x1677 - x1628 * x2321 - x2154 * x2326;
  const Real x2584 = x2582 - x2180 * x2332 - x2228 * x2338;
  const Real x2597 = x1689 - x1628 * x2322 - x2154 * x2327;
  const Real x2599 = x2597 - x2180 * x2333 - x2228 * x2339;
  const Real x2612 = x1704 - x1643 * x2321 - x2157 * x2326;
  const Real x2614 = x2612 - x2186 * x2332 - x2237 * x2338;
  const Real x2627 = x1715 - x1643 * x2322 - x2157 * x2327;
  const Real x2629 = x2627 - x2186 * x2333 - x2237 * x2339;
  const Real x2642 = x1727 - x1654 * x2322 - x2160 * x2327;
  const Real x2644 = x2642 - x2192 * x2333 - x2246 * x2339;
  const Real x2655 = x2109 + x2111 * x2323 + x2117 * x2328;
  const Real x2663 = x2112 + x2114 + x2117 * x2329 + x2126 * x2335;
  const Real x2680 = x2028 * x2320 + x2111 * x2325 + x2117 * x2331;
  const Real x2689 = x2028 * x2321 + x2111 * x2326 + x2117 * x2332;
  const Real x2698 = x2028 * x2322 + x2111 * x2327 + x2117 * x2333;
  const Real x2657 = x2126 * x2334 + x2655 + x2138 * x2340;
  const Real x2682 = x2126 * x2337 + x2680 + x2138 * x2343;
  const Real x2691 = x2126 * x2338 + x2689 + x2138 * x2344;
  const Real x2700 = x2126 * x2339 + x2698 + x2138 * x2345;
  // link 6 "wrist": acceleration where nothing acts on it
  const Real x2759 = x411 * 0.00351 + x452 * 0.0019500000000000001;
  const Real x2740 = x423 * 0.0014299999999999998 + x457 * 0.00013000000000000002 + x463 * 0.0005200000000000001;
  const Real x2762 = x2740 + x436 * 0.013000000000000001;
  const Real x2751 = x426 * 0.00338 + x462 * 0.0020800000000000003 + x459 * 0.0005200000000000001;
  const Real x2765 = x2751 + x436 * 0.052000000000000005;
  const Real x2770 = x2759 - 0.0005200000000000001 * (x455 - x450) + x443 * 0.052000000000000005;
  const Real x2771 = x2770 - x439 * 0.013000000000000001;
  const Real x2777 = x453 * 0.013000000000000001 - x450 * 0.052000000000000005 + x439 * 1.3;
  const Real x2783 = x454 * 0.052000000000000005 - x455 * 0.013000000000000001 + x443 * 1.3;
  const Real x2788 = x436 * 1.3 + x463 * 0.052000000000000005 + x459 * 0.013000000000000001;
  const Real x2800 = x2762 * 769.2307692307693 - x2788 * 7.6923076923076925;
  w.x[173] = x2800;
  const Real x2804 = x2788 * 30.76923076923077 - x2765 * 769.2307692307693;
  w.x[174] = x2804;
  const Real x2810 = x2777 * 7.6923076923076925 - x2783 * 30.76923076923077 + x2771 * 769.2307692307693;
  w.x[175] = x2810;
  const Real x2817 = x2777 * 0.8461538461538461 - x2783 * 0.3076923076923077 + x2771 * 7.6923076923076925;
  w.x[176] = x2817;
  const Real x2824 = 2.0 * x2783 - x2777 * 0.3076923076923077 - x2771 * 30.76923076923077;
  w.x[177] = x2824;
  const Real x2832 = x2788 * 2.076923076923077 - (x2762 * 7.6923076923076925 + x2765 * 30.76923076923077);
  w.x[178] = x2832;
  // joint 6 "flange_roll": assembly: its two sides become one chain
  const Real x2863 = cosine[6] * 2.8255423871896722e-05 - sine[6] * 38.46153846153846;
  const Real x2868 = sine[6] * 2.8255423871896722e-05 + cosine[6] * 38.46153846153846;
  const Real x2902 = cosine[6] * 1.9230769230758853 + 2.0 * sine[6] * 1.4127711935948361e-06;
  const Real x2907 = cosine[6] * x2902;
  const Real x2911 = x2355 - x2201 * x2334 - x2258 * x2340 + 769.2307692307693;
  require_pivot(w, x2911, 0, 6);
  const Real x2912 = x2410 - x2258 * x2344 + -7.692307692255798;
  const Real x2913 = x2425 - x2258 * x2345 + x2863;
  const Real x2914 = x2434 - x2270 * x2341 + 769.2307692307693;
  const Real x2918 = x2524 - x2282 * x2343 - x2863;
  w.x[179] = x2918;
  const Real x2919 = x2539 - x2282 * x2344 + x2868;
  w.x[180] = x2919;
  const Real x2920 = x2569 - x2294 * x2343 + (2.7692307692297313 - x2907);
  const Real x2888 = cosine[6] * 0.3846153846127899 + sine[6] * 2.825542387170617e-07;
  const Real x2923 = x2614 - x2306 * x2344 + (0.8461538461538461 + x2907);
  const Real x2894 = sine[6] * 0.3846153846127899 - cosine[6] * 2.825542387170617e-07;
  const Real x2925 = x2644 - x2318 * x2345 + 2.6923076923087303;
  const Real x2928 = x2824 + 0.09 * x2810;
  const Real x2932 = 0.09 * x2804 - x2832;
  const Real x2937 = 3.673205103346574e-06 * x2804 - 0.9999999999932537 * x2810;
  const Real x2954 = 3.673205103346574e-06 * x2928 + 0.9999999999932537 * x2932;
  // joint 7 "left_finger_slide": assembly: its two sides become one chain
  const Real x2707 = tau[7] * x1920 + x2657 + x1813;
  const Real x2709 = x2138 * x2341 + x2663 + x2024 + x1815;
  const Real x2713 = tau[7] * x2141 + x2682 + x1819;
  const Real x2715 = tau[7] * x1978 + x2691 + x1821;
  const Real x2717 = tau[7] * x1984 + x2700 + x1823;
  // joint 6 "flange_roll": assembly: its two sides become one chain
  const Real x2968 = sine[6] * x2937 - cosine[6] * x2800 + x2707;
  const Real x2980 = x2968 - x2381 * tau[6];
  w.x[181] = x2980;
  const Real x2969 = sine[6] * x2800 + cosine[6] * x2937 + x2709;
  const Real x2971 = sine[6] * x2954 - cosine[6] * x2817 + x2713;
  const Real x2972 = sine[6] * x2817 + cosine[6] * x2954 + x2715;
  const Real x2973 = 0.9999999999932537 * x2928 - 3.673205103346574e-06 * x2932 + x2717;
  const Real x2986 = 1 / x2911;
  w.x[182] = x2986;
  const Real x2987 = x2366 * x2986;
  w.x[183] = x2987;
  const Real x2988 = x2396 * x2986;
  w.x[184] = x2988;
  const Real x2989 = x2912 * x2986;
  w.x[185] = x2989;
  const Real x2990 = x2913 * x2986;
  w.x[186] = x2990;
  const Real x2993 = x2914 - x2366 * x2987;
  require_pivot(w, x2993, 8 * kEpsilon * x2914, 6);
  const Real x2996 = x2464 - x2270 * x2343 + 7.692307692255798 - x2396 * x2987;
  const Real x2999 = x2479 - x2270 * x2344 - x2912 * x2987;
  const Real x3002 = x2494 - x2270 * x2345 - x2868 - x2913 * x2987;
  const Real x3003 = 1 / x2993;
  w.x[187] = x3003;
  const Real x3004 = x2996 * x3003;
  w.x[188] = x3004;
  const Real x3005 = x2999 * x3003;
  w.x[189] = x3005;
  const Real x3006 = x3002 * x3003;
  w.x[190] = x3006;
  const Real x3012 = x2920 - x2396 * x2988 - x2996 * x3004;
  require_pivot(w, x3012, 8 * kEpsilon * x2920, 6);
  const Real x2921 = x2584 - x2294 * x2344 + (-1.4127711935948361e-06 + sine[6] * x2902);
  const Real x3018 = x2921 - x2912 * x2988 - x2999 * x3004;
  const Real x3023 = x2599 - x2294 * x2345 - x2888 - x2913 * x2988;
  const Real x3024 = x3023 - x3002 * x3004;
  const Real x3025 = 1 / x3012;
  w.x[191] = x3025;
  const Real x3026 = x3018 * x3025;
  w.x[192] = x3026;
  const Real x3027 = x3024 * x3025;
  w.x[193] = x3027;
  const Real x3035 = x2923 - x2912 * x2989 - x2999 * x3005;
  const Real x3036 = x3035 - x3018 * x3026;
  require_pivot(w, x3036, 8 * kEpsilon * x2923, 6);
  const Real x3043 = x2629 - x2306 * x2345 + x2894 - x2913 * x2989;
  const Real x3045 = x3043 - x3002 * x3005 - x3024 * x3026;
  const Real x3046 = 1 / x3036;
  w.x[194] = x3046;
  const Real x3047 = x3045 * x3046;
  w.x[195] = x3047;
  const Real x3057 = x2925 - x2913 * x2990 - x3002 * x3006;
  const Real x3059 = x3057 - x3024 * x3027 - x3045 * x3047;
  require_pivot(w, x3059, 8 * kEpsilon * x2925, 6);
  const Real x3060 = 1 / x3059;
  w.x[196] = x3060;
  const Real x3063 = x2969 - x2450 * tau[6] - x2980 * x2987;
  w.x[197] = x3063;
  const Real x3068 = x2971 - tau[6] * x2918 - x2980 * x2988;
  const Real x3069 = x3068 - x3004 * x3063;
  w.x[198] = x3069;
  const Real x3076 = x2972 - tau[6] * x2919 - x2980 * x2989;
  const Real x3078 = x3076 - x3005 * x3063 - x3026 * x3069;
  w.x[199] = x3078;
  const Real x3087 = x2973 - x2555 * tau[6] - x2980 * x2990;
  const Real x3089 = x3087 - x3006 * x3063 - x3027 * x3069;
  const Real x3090 = x3089 - x3047 * x3078;
  w.x[200] = x3090;
  const Real x3091 = cosine[6] * 769.2307692307693;
  w.x[201] = x3091;
  const Real x3094 = sine[6] * 7.692307692255798;
  w.x[202] = x3094;
  const Real x3096 = cosine[6] * 7.692307692255798;
  const Real x3101 = sine[6] * 0.0028255423871896726;
  w.x[203] = x3101;
  const Real x3113 = sine[6] * 769.2307692255798;
  w.x[204] = x3113;
  const Real x3116 = cosine[6] * 7.6923076923076925;
  const Real x3120 = sine[6] * 7.6923076923076925;
  const Real x3139 = sine[6] * 30.769230769023192;
  w.x[205] = x3139;
  const Real x3157 = x3116 + sine[6] * 0.00011302169548758689;
  w.x[206] = x3157;
  const Real x3171 = sine[6] * 769.2307692307693 + x2987 * x3091;
  w.x[207] = x3171;
  const Real x3175 = x2987 * x3101 - cosine[6] * 0.0028255423871896726;
  w.x[208] = x3175;
  const Real x3178 = cosine[6] * 769.2307692255798 - x2987 * x3113;
  w.x[209] = x3178;
  const Real x3181 = x3096 - x2987 * x3094;
  w.x[210] = x3181;
  const Real x3184 = x2987 * x3139 - cosine[6] * 30.769230769023192;
  w.x[211] = x3184;
  const Real x3187 = x3120 - cosine[6] * 0.00011302169548758689 + x2987 * x3157;
  w.x[212] = x3187;
  const Real x3194 = x3004 * x3171 - (x3094 + x2988 * x3091);
  w.x[213] = x3194;
  const Real x3200 = x2988 * x3101 - sine[6] * 38.46153846127899 - x3004 * x3175;
  w.x[214] = x3200;
  const Real x3205 = x3116 - sine[6] * 0.00014127711935948362 - x2988 * x3113;
  const Real x3206 = x3205 - x3004 * x3178;
  w.x[215] = x3206;
  const Real x3211 = cosine[6] * 0.8461538461538461 - sine[6] * 1.4127711935948361e-06 - x2988 * x3094;
  const Real x3212 = x3211 - x3004 * x3181;
  w.x[216] = x3212;
  const Real x3217 = sine[6] * 2.8255423871896723e-06 - cosine[6] * 0.3076923076923077 + x2988 * x3139;
  const Real x3218 = x3217 - x3004 * x3184;
  w.x[217] = x3218;
  const Real x3224 = x2988 * x3157 - sine[6] * 0.6923076923030216 - x3004 * x3187;
  w.x[218] = x3224;
  const Real x3233 = x3005 * x3171 - (x3096 + x2989 * x3091);
  const Real x3234 = x3233 - x3026 * x3194;
  w.x[219] = x3234;
  const Real x3242 = x2989 * x3101 - cosine[6] * 38.46153846127899 - x3005 * x3175;
  const Real x3243 = x3242 - x3026 * x3200;
  w.x[220] = x3243;
  const Real x3250 = x3120 + cosine[6] * 0.00014127711935948362 + x2989 * x3113;
  const Real x3254 = x3005 * x3178 + x3250 + x3026 * x3206;
  w.x[221] = x3254;
  const Real x3262 = sine[6] * 0.8461538461538461 + cosine[6] * 1.4127711935948361e-06 + x2989 * x3094;
  const Real x3266 = x3005 * x3181 + x3262 + x3026 * x3212;
  w.x[222] = x3266;
  const Real x3274 = sine[6] * 0.3076923076923077 + cosine[6] * 2.8255423871896723e-06 + x2989 * x3139;
  const Real x3276 = x3274 - x3005 * x3184 - x3026 * x3218;
  w.x[223] = x3276;
  const Real x3284 = x2989 * x3157 - cosine[6] * 0.6923076923030216 - x3005 * x3187;
  const Real x3285 = x3284 - x3026 * x3224;
  w.x[224] = x3285;
  const Real x3295 = 2.8255423871896722e-05 - x2990 * x3091 + x3006 * x3171;
  const Real x3297 = x3295 - x3027 * x3194 - x3047 * x3234;
  w.x[225] = x3297;
  const Real x3307 = 0.00014127711935948362 + x2990 * x3101 - x3006 * x3175;
  const Real x3309 = x3307 - x3027 * x3200 - x3047 * x3243;
  w.x[226] = x3309;
  const Real x3319 = -38.46153846127899 - x2990 * x3113 - x3006 * x3178;
  const Real x3321 = x3319 - x3027 * x3206 + x3047 * x3254;
  w.x[227] = x3321;
  const Real x3331 = -0.3846153846127899 - x2990 * x3094 - x3006 * x3181;
  const Real x3333 = x3331 - x3027 * x3212 + x3047 * x3266;
  w.x[228] = x3333;
  const Real x3343 = 0.7692307692255798 + x2990 * x3139 - x3006 * x3184;
  const Real x3345 = x3343 - x3027 * x3218 - x3047 * x3276;
  w.x[229] = x3345;
  const Real x3355 = 2.5429881484707045e-06 + x2990 * x3157 - x3006 * x3187;
  const Real x3357 = x3355 - x3027 * x3224 - x3047 * x3285;
  w.x[230] = x3357;
  const Real x3358 = x2986 * x3091;
  w.x[231] = x3358;
  const Real x3359 = x2986 * x3101;
  w.x[232] = x3359;
  const Real x3361 = x2986 * x3113;
  w.x[233] = x3361;
  const Real x3362 = x2986 * x3094;
  w.x[234] = x3362;
  const Real x3363 = x2986 * x3139;
  w.x[235] = x3363;
  const Real x3365 = x2986 * x3157;
  w.x[236] = x3365;
  const Real x3367 = x3003 * x3171;
  w.x[237] = x3367;
  const Real x3369 = x3003 * x3175;
  w.x[238] = x3369;
  const Real x3370 = x3003 * x3178;
  w.x[239] = x3370;
  const Real x3371 = x3003 * x3181;
  w.x[240] = x3371;
  const Real x3372 = x3003 * x3184;
  w.x[241] = x3372;
  const Real x3373 = x3003 * x3187;
  w.x[242] = x3373;
  const Real x3374 = x3025 * x3194;
  w.x[243] = x3374;
  const Real x3375 = x3025 * x3200;
  w.x[244] = x3375;
  const Real x3376 = x3025 * x3206;
  w.x[245] = x3376;
  const Real x3377 = x3025 * x3212;
  w.x[246] = x3377;
  const Real x3378 = x3025 * x3218;
  w.x[247] = x3378;
  const Real x3379 = x3025 * x3224;
  w.x[248] = x3379;
  const Real x3380 = x3046 * x3234;
  w.x[249] = x3380;
  const Real x3381 = x3046 * x3243;
  w.x[250] = x3381;
  const Real x3382 = x3046 * x3254;
  w.x[251] = x3382;
  const Real x3384 = x3046 * x3266;
  w.x[252] = x3384;
  const Real x3386 = x3046 * x3276;
  w.x[253] = x3386;
  const Real x3387 = x3046 * x3285;
  w.x[254] = x3387;
  const Real x3388 = x3060 * x3297;
  w.x[255] = x3388;
  const Real x3389 = x3060 * x3309;
  w.x[256] = x3389;
  const Real x3390 = x3060 * x3321;
  w.x[257] = x3390;
  const Real x3391 = x3060 * x3333;
  w.x[258] = x3391;
  const Real x3392 = x3060 * x3345;
  w.x[259] = x3392;
  const Real x3393 = x3060 * x3357;
  w.x[260] = x3393;
  const Real x3405 = 769.2307692307693 - x3091 * x3358 - x3171 * x3367;
  const Real x3407 = x3405 - x3194 * x3374 - x3234 * x3380;
  const Real x3408 = x3407 - x3297 * x3388;
  w.x[261] = x3408;
  const Real x3420 = x3091 * x3359 + x3171 * x3369 - x3194 * x3375;
  const Real x3422 = x3420 - x3234 * x3381 - x3297 * x3389;
  w.x[262] = x3422;
  const Real x3434 = x3171 * x3370 - x3091 * x3361 - x3194 * x3376;
  const Real x3436 = x3234 * x3382 + x3434 - x3297 * x3390;
  w.x[263] = x3436;
  const Real x3448 = x3171 * x3371 - x3091 * x3362 - x3194 * x3377;
  const Real x3450 = x3234 * x3384 + x3448 - x3297 * x3391;
  w.x[264] = x3450;
  const Real x3462 = x3091 * x3363 + x3171 * x3372 - x3194 * x3378;
  const Real x3464 = x3462 - x3234 * x3386 - x3297 * x3392;
  w.x[265] = x3464;
  const Real x3476 = -7.6923076923076925 + x3091 * x3365 + x3171 * x3373;
  const Real x3478 = x3476 - x3194 * x3379 - x3234 * x3387;
  const Real x3479 = x3478 - x3297 * x3393;
  w.x[266] = x3479;
  const Real x3491 = 769.2307692307693 - x3101 * x3359 - x3175 * x3369;
  const Real x3493 = x3491 - x3200 * x3375 - x3243 * x3381;
  const Real x3494 = x3493 - x3309 * x3389;
  w.x[267] = x3494;
  const Real x3495 = x3101 * x3361;
  w.x[268] = x3495;
  const Real x3497 = x3175 * x3370;
  w.x[269] = x3497;
}

ADAGEN_NOINLINE void part_1_2(Workspace& w) {
  ADAGEN_INPUTS
  const Real x299 = w.x[0];
  const Real x310 = w.x[1];
  const Real x313 = w.x[2];
  const Real x341 = w.x[3];
  const Real x345 = w.x[4];
  const Real x350 = w.x[5];
  const Real x362 = w.x[6];
  const Real x364 = w.x[7];
  const Real x367 = w.x[8];
  const Real x369 = w.x[9];
  const Real x371 = w.x[10];
  const Real x373 = w.x[11];
  const Real x374 = w.x[12];
  const Real x376 = w.x[13];
  const Real x378 = w.x[14];
  const Real x2800 = w.x[173];
  const Real x2804 = w.x[174];
  const Real x2817 = w.x[176];
  const Real x2824 = w.x[177];
  const Real x2832 = w.x[178];
  const Real x2980 = w.x[181];
  const Real x3063 = w.x[197];
  const Real x3069 = w.x[198];
  const Real x3078 = w.x[199];
  const Real x3090 = w.x[200];
  const Real x3094 = w.x[202];
  const Real x3101 = w.x[203];
  const Real x3113 = w.x[204];
  const Real x3139 = w.x[205];
  const Real x3157 = w.x[206];
  const Real x3175 = w.x[208];
  const Real x3178 = w.x[209];
  const Real x3181 = w.x[210];
  const Real x3184 = w.x[211];
  const Real x3187 = w.x[212];
  const Real x3200 = w.x[214];
  const Real x3206 = w.x[215];
  const Real x3212 = w.x[216];
  const Real x3218 = w.x[217];
  const Real x3224 = w.x[218];
  const Real x3243 = w.x[220];
  const Real x3254 = w.x[221];
  const Real x3266 = w.x[222];
  const Real x3276 = w.x[223];
  const Real x3285 = w.x[224];
  const Real x3309 = w.x[226];
  const Real x3321 = w.x[227];
  const Real x3333 = w.x[228];
  const Real x3345 = w.x[229];
  const Real x3357 = w.x[230];
  const Real x3358 = w.x[231];
  const Real x3359 = w.x[232];
  const Real x3362 = w.x[234];
  const Real x3363 = w.x[235];
  const Real x3365 = w.x[236];
  const Real x3367 = w.x[237];
  const Real x3369 = w.x[238];
  const Real x3371 = w.x[240];
  const Real x3372 = w.x[241];
  const Real x3373 = w.x[242];
  const Real x3374 = w.x[243];
  const Real x3375 = w.x[244];
  const Real x3376 = w.x[245];
  const Real x3377 = w.x[246];
  const Real x3378 = w.x[247];
  const Real x3379 = w.x[248];
  const Real x3380 = w.x[249];
  const Real x3381 = w.x[250];
  const Real x3382 = w.x[251];
  const Real x3384 = w.x[252];
  const Real x3386 = w.x[253];
  const Real x3387 = w.x[254];
  const Real x3388 = w.x[255];
  const Real x3389 = w.x[256];
  const Real x3390 = w.x[257];
  const Real x3391 = w.x[258];
  const Real x3392 = w.x[259];
  const Real x3393 = w.x[260];
  const Real x3408 = w.x[261];
  const Real x3422 = w.x[262];
  const Real x3436 = w.x[263];
  const Real x3450 = w.x[264];
  const Real x3464 = w.x[265];
  const Real x3479 = w.x[266];
  const Real x3494 = w.x[267];
  const Real x3495 = w.x[268];
  const Real x3497 = w.x[269];
  // joint 6 "flange_roll": assembly: its two sides become one chain
  const Real x3507 = x3495 - x3497 - x3200 * x3376 + x3243 * x3382;
  const Real x3520 = x3101 * x3362 - x3175 * x3371 - x3200 * x3377;
  const Real x3535 = x3101 * x3363 + x3175 * x3372 + x3200 * x3378;
  const Real x3552 = 30.76923076923077 - x3101 * x3365 - x3175 * x3373;
  const Real x3554 = x3552 - x3200 * x3379 - x3243 * x3387;
  const Real x3582 = 7.6923076923076925 - x3113 * x3362 - x3178 * x3371;
  const Real x3584 = x3582 - x3206 * x3377 - x3254 * x3384;
  const Real x3597 = -30.76923076923077 + x3113 * x3363 - x3178 * x3372;
  const Real x3599 = x3597 - x3206 * x3378 + x3254 * x3386;
  const Real x3612 = x3113 * x3365 - x3178 * x3373 - x3206 * x3379;
  const Real x3614 = x3254 * x3387 + x3612 - x3321 * x3393;
  w.x[112] = x3614;
  const Real x3626 = 0.8461538461538461 - x3094 * x3362 - x3181 * x3371;
  const Real x3628 = x3626 - x3212 * x3377 - x3266 * x3384;
  const Real x3641 = -0.3076923076923077 + x3094 * x3363 - x3181 * x3372;
  const Real x3643 = x3641 - x3212 * x3378 + x3266 * x3386;
  const Real x3656 = x3094 * x3365 - x3181 * x3373 - x3212 * x3379;
  const Real x3670 = 2.0 - x3139 * x3363 - x3184 * x3372;
  const Real x3672 = x3670 - x3218 * x3378 - x3276 * x3386;
  const Real x3686 = x3139 * x3365 + x3184 * x3373 + x3218 * x3379;
  const Real x3703 = 2.076923076923077 - x3157 * x3365 - x3187 * x3373;
  const Real x3705 = x3703 - x3224 * x3379 - x3285 * x3387;
  const Real x3723 = x2980 * x3358 - x3063 * x3367 + x3069 * x3374;
  const Real x3733 = x3063 * x3369 - x2980 * x3359 + x3069 * x3375;
  const Real x3753 = x2980 * x3362 + x3063 * x3371 + x3069 * x3377;
  const Real x3763 = x3063 * x3372 - x2980 * x3363 + x3069 * x3378;
  const Real x3773 = x3063 * x3373 - x2980 * x3365 + x3069 * x3379;
  const Real x3735 = x3078 * x3381 + x3733 + x3090 * x3389;
  const Real x3755 = x3753 - x3078 * x3384 + x3090 * x3391;
  const Real x3765 = x3078 * x3386 + x3763 + x3090 * x3392;
  const Real x3775 = x3078 * x3387 + x3773 + x3090 * x3393;
  // link 5 "wrist_housing": acceleration where nothing acts on it
  const Real x3815 = x369 * 0.01347604 + 0.00136 * (x374 - x367);
  const Real x3837 = x310 * 0.01553729 + x3815 + x341 * 0.017;
  const Real x3838 = x3837 - x350 * 0.136;
  const Real x3824 = x376 * 0.01364604 - x364 * 0.00136 + x313 * 0.01536729;
  const Real x3841 = x3824 - x345 * 0.136;
  const Real x3833 = x362 * 0.00017 - x299 * 0.00189125 + x378 * 0.00136;
  const Real x3844 = x3833 - x345 * 0.017;
  const Real x3850 = x364 * 0.017 - x378 * 0.136 + x345 * 1.7;
  const Real x3858 = x371 * 0.136 - x367 * 0.017 - x350 * 1.7;
  const Real x3864 = x341 * 1.7 + x374 * 0.136 + x373 * 0.017;
  const Real x3882 = x3838 * 222.85165433925602 - x3864 * 2.2285165433925602 - x3858 * 17.828132347140482;
  const Real x3885 = x3841 * 222.85165433925602 + x3850 * 17.828132347140482;
  w.x[111] = x3885;
  const Real x3888 = x3844 * 580.9731299927379 + x3850 * 5.809731299927379;
  w.x[109] = x3888;
  const Real x3893 = x3841 * 17.828132347140482 + x3844 * 5.809731299927379 + x3850 * 2.0725831948881592;
  const Real x3899 = x3864 * 0.17828132347140482 - x3838 * 17.828132347140482 + x3858 * 2.0144858818888856;
  const Real x3905 = x3864 * 0.6105204595515726 - x3838 * 2.2285165433925602 + x3858 * 0.17828132347140482;
  // joint 5 "wrist_pitch": assembly: its two sides become one chain
  const Real x3934 = sine[5] * 3.581214756510659;
  const Real x3935 = sine[5] * x3934;
  const Real x3938 = cosine[5] * x3934;
  const Real x3953 = cosine[5] * 358.12147564864995;
  const Real x3958 = cosine[5] * x3953;
  const Real x3977 = cosine[5] * 1.4620640450453781;
  const Real x3980 = cosine[5] * x3977;
  const Real x3983 = 580.973129987906 - x3958 + x3408;
  require_pivot(w, x3983, 0, 5);
  const Real x3984 = x3422 + sine[5] * x3953;
  const Real x3985 = x3436 - sine[5] * 0.001315453631979501;
  w.x[108] = x3985;
  const Real x3986 = x3450 + x3938;
  const Real x3987 = -2.2284510569908056 - x3935 + x3464;
  const Real x3988 = x3479 + cosine[5] * 17.828140532818548;
  const Real x3989 = 222.85165433925602 + x3958 + x3494;
  const Real x3990 = x3507 - x3309 * x3390 - cosine[5] * 0.001315453631979501;
  w.x[106] = x3990;
  // joint 6 "flange_roll": assembly: its two sides become one chain
  const Real x3522 = x3243 * x3384 + x3520 - x3309 * x3391;
  // joint 5 "wrist_pitch": assembly: its two sides become one chain
  const Real x3996 = x3584 - x3321 * x3391 - cosine[5] * 17.828153687354867;
  w.x[105] = x3996;
  const Real x3997 = x3599 - x3321 * x3392 + sine[5] * 17.828153687354867;
  w.x[104] = x3997;
  const Real x3998 = x3628 - x3333 * x3391 + (0.6105191498427811 + x3980);
  // joint 6 "flange_roll": assembly: its two sides become one chain
  const Real x3658 = x3266 * x3387 + x3656 - x3333 * x3393;
  // joint 5 "wrist_pitch": assembly: its two sides become one chain
  const Real x4001 = x3672 - x3345 * x3392 + (2.0725831948881592 - x3980);
  // joint 6 "flange_roll": assembly: its two sides become one chain
  const Real x3690 = x3276 * x3387 + x3686 + x3345 * x3393;
  // joint 5 "wrist_pitch": assembly: its two sides become one chain
  const Real x4004 = x3705 - x3357 * x3393 + 2.014487191597677;
  const Real x4009 = 3.673205103346574e-06 * x3885 - 0.9999999999932537 * x3888;
  const Real x4027 = 3.673205103346574e-06 * x3899 - 0.9999999999932537 * x3905;
  // joint 6 "flange_roll": assembly: its two sides become one chain
  const Real x3781 = x3078 * x3380 + x3723 + x3090 * x3388 + x2800;
  const Real x3783 = x3735 - tau[6] * 769.2307692255798 + x2804;
  const Real x3787 = x3755 - tau[6] * 2.8255423871896722e-05 + x2817;
  const Real x3789 = tau[6] * 0.00011302169548758689 + x3765 + x2824;
  const Real x3791 = x3775 - tau[6] * 30.769230769023192 + x2832;
  // joint 5 "wrist_pitch": assembly: its two sides become one chain
  const Real x4041 = sine[5] * x4009 - cosine[5] * x3882 + x3781;
  const Real x4053 = x4041 - tau[5] * x3985;
  w.x[103] = x4053;
  const Real x4042 = sine[5] * x3882 + cosine[5] * x4009 + x3783;
  const Real x4044 = sine[5] * x4027 - cosine[5] * x3893 + x3787;
  const Real x4045 = sine[5] * x3893 + cosine[5] * x4027 + x3789;
  const Real x4046 = 0.9999999999932537 * x3899 + 3.673205103346574e-06 * x3905 + x3791;
  const Real x4059 = 1 / x3983;
  w.x[102] = x4059;
  const Real x4060 = x3984 * x4059;
  w.x[101] = x4060;
  const Real x4061 = x3986 * x4059;
  w.x[100] = x4061;
  const Real x4062 = x3987 * x4059;
  w.x[96] = x4062;
  const Real x4063 = x3988 * x4059;
  w.x[94] = x4063;
  const Real x4066 = x3989 - x3984 * x4060;
  require_pivot(w, x4066, 8 * kEpsilon * x3989, 5);
  const Real x4069 = 5.809665813501464 - x3935 + x3522 - x3986 * x4060;
  const Real x3992 = x3243 * x3386 + x3535 + x3309 * x3392 + x3938;
  const Real x4072 = x3992 + x3987 * x4060;
  const Real x3994 = x3554 - x3309 * x3393 - sine[5] * 17.828140532818548;
  const Real x4076 = x3994 - x3988 * x4060;
  const Real x4077 = 1 / x4066;
  w.x[92] = x4077;
  const Real x4078 = x4069 * x4077;
  w.x[90] = x4078;
  const Real x4079 = x4072 * x4077;
  w.x[89] = x4079;
  const Real x4081 = x4076 * x4077;
  w.x[88] = x4081;
  const Real x4087 = x3998 - x3986 * x4061 - x4069 * x4078;
  require_pivot(w, x4087, 8 * kEpsilon * x3998, 5);
  const Real x3999 = x3643 - x3333 * x3392 - sine[5] * x3977;
  const Real x4093 = x3999 - x3987 * x4061 + x4072 * x4078;
  const Real x4098 = x3658 - sine[5] * 0.17827616641363966 - x3988 * x4061;
  const Real x4099 = x4098 - x4076 * x4078;
  const Real x4100 = 1 / x4087;
  w.x[87] = x4100;
  const Real x4101 = x4093 * x4100;
  w.x[86] = x4101;
  const Real x4102 = x4099 * x4100;
  w.x[85] = x4102;
  const Real x4110 = x4001 - x3987 * x4062 - x4072 * x4079;
  const Real x4111 = x4110 - x4093 * x4101;
  require_pivot(w, x4111, 8 * kEpsilon * x4001, 5);
  const Real x4118 = x3690 + cosine[5] * 0.17827616641363966 + x3988 * x4062;
  const Real x4121 = x4076 * x4079 - x4118 - x4099 * x4101;
  const Real x4122 = 1 / x4111;
  w.x[80] = x4122;
  const Real x4123 = x4121 * x4122;
  w.x[79] = x4123;
  const Real x4133 = x4004 - x3988 * x4063 - x4076 * x4081;
  const Real x4135 = x4133 - x4099 * x4102 - x4121 * x4123;
  require_pivot(w, x4135, 8 * kEpsilon * x4004, 5);
  const Real x4136 = 1 / x4135;
  w.x[78] = x4136;
  const Real x4139 = x4042 - tau[5] * x3990 - x4053 * x4060;
  w.x[76] = x4139;
  const Real x4144 = x4044 - tau[5] * x3996 - x4053 * x4061;
  const Real x4145 = x4144 - x4078 * x4139;
  w.x[75] = x4145;
  const Real x4152 = x4045 - tau[5] * x3997 - x4053 * x4062;
  const Real x4154 = x4079 * x4139 + x4152 - x4101 * x4145;
  w.x[74] = x4154;
  const Real x4163 = x4046 - x3614 * tau[5] - x4053 * x4063;
  const Real x4165 = x4163 - x4081 * x4139 - x4102 * x4145;
  const Real x4166 = x4165 - x4123 * x4154;
  w.x[73] = x4166;
  const Real x4167 = cosine[5] * 222.85165433925602;
  w.x[71] = x4167;
  const Real x4178 = sine[5] * 0.0008185798340081819;
  w.x[70] = x4178;
  const Real x4182 = cosine[5] * 17.828132347140482;
  w.x[29] = x4182;
  const Real x4183 = sine[5] * 17.828132347140482;
  const Real x4187 = sine[5] * 580.9731299888185;
  w.x[28] = x4187;
  const Real x4192 = sine[5] * 5.809665813501464;
  w.x[27] = x4192;
  const Real x4206 = cosine[5] * 2.2285165433925602;
  w.x[26] = x4206;
  const Real x4219 = sine[5] * 222.85165433925602 + x4060 * x4167;
  w.x[25] = x4219;
  const Real x4223 = x4060 * x4178 - cosine[5] * 0.0008185798340081819;
  w.x[24] = x4223;
  const Real x4226 = cosine[5] * 580.9731299888185 - x4060 * x4187;
  w.x[23] = x4226;
  const Real x4229 = cosine[5] * 5.809665813501464 - x4060 * x4192;
  w.x[22] = x4229;
  const Real x4232 = x4183 + x4060 * x4182;
  w.x[21] = x4232;
  const Real x4235 = sine[5] * 2.2285165433925602 + x4060 * x4206;
  w.x[20] = x4235;
  const Real x4242 = x4078 * x4219 - (sine[5] * 2.2284510569908056 + x4061 * x4167);
  w.x[19] = x4242;
  const Real x4248 = x4182 + x4061 * x4178 - x4078 * x4223;
  w.x[18] = x4248;
  const Real x4254 = cosine[5] * 5.809731299927379 - x4061 * x4187 - x4078 * x4226;
  w.x[17] = x4254;
  const Real x4260 = cosine[5] * 2.0725831948881592 - x4061 * x4192 - x4078 * x4229;
  w.x[16] = x4260;
  const Real x4266 = sine[5] * 0.17827392385038013 + x4061 * x4182 - x4078 * x4232;
  w.x[15] = x4266;
  const Real x4272 = sine[5] * 0.6105198046835867 + x4061 * x4206 - x4078 * x4235;
  w.x[270] = x4272;
  const Real x4281 = cosine[5] * 2.2284510569908056 + x4062 * x4167 + x4079 * x4219;
  const Real x4283 = x4101 * x4242 + x4281;
  w.x[271] = x4283;
  const Real x4292 = x4062 * x4178 - x4183 + x4079 * x4223;
  const Real x4293 = x4292 - x4101 * x4248;
  w.x[272] = x4293;
  const Real x4302 = x4079 * x4226 - (sine[5] * 5.809731299927379 + x4062 * x4187);
  const Real x4303 = x4302 - x4101 * x4254;
  w.x[273] = x4303;
  const Real x4312 = x4079 * x4229 - (sine[5] * 2.0725831948881592 + x4062 * x4192);
  const Real x4313 = x4312 - x4101 * x4260;
  w.x[274] = x4313;
  const Real x4321 = cosine[5] * 0.17827392385038013 + x4062 * x4182 + x4079 * x4232;
  const Real x4322 = x4321 - x4101 * x4266;
  w.x[275] = x4322;
  const Real x4330 = cosine[5] * 0.6105198046835867 + x4062 * x4206 + x4079 * x4235;
  const Real x4331 = x4330 - x4101 * x4272;
  w.x[276] = x4331;
  const Real x4341 = 17.828140532818548 - x4063 * x4167 + x4081 * x4219;
  const Real x4343 = x4341 - x4102 * x4242 + x4123 * x4283;
  w.x[277] = x4343;
  const Real x4353 = x4063 * x4178 - x4081 * x4223 - x4102 * x4248;
  const Real x4354 = x4353 - x4123 * x4293;
  w.x[278] = x4354;
  const Real x4365 = x4063 * x4187 + x4081 * x4226 + x4102 * x4254;
  const Real x4367 = x4123 * x4303 + x4365;
  w.x[279] = x4367;
  const Real x4379 = x4063 * x4192 + x4081 * x4229 + x4102 * x4260;
  const Real x4381 = x4123 * x4313 + x4379;
  w.x[280] = x4381;
  const Real x4392 = -2.0144865367391627 + x4063 * x4182 - x4081 * x4232;
  const Real x4394 = x4392 - x4102 * x4266 - x4123 * x4322;
  w.x[281] = x4394;
  const Real x4404 = -0.17828356603706982 + x4063 * x4206 - x4081 * x4235;
  const Real x4406 = x4404 - x4102 * x4272 - x4123 * x4331;
  w.x[282] = x4406;
  const Real x4407 = x4059 * x4167;
  const Real x4408 = x4059 * x4178;
  const Real x4410 = x4059 * x4187;
  const Real x4411 = x4059 * x4192;
  const Real x4412 = x4059 * x4182;
  const Real x4414 = x4059 * x4206;
  const Real x4416 = x4077 * x4219;
  const Real x4418 = x4077 * x4223;
  const Real x4419 = x4077 * x4226;
  const Real x4420 = x4077 * x4229;
  const Real x4421 = x4077 * x4232;
  const Real x4422 = x4077 * x4235;
  const Real x4423 = x4100 * x4242;
  const Real x4424 = x4100 * x4248;
  const Real x4425 = x4100 * x4254;
  const Real x4426 = x4100 * x4260;
  const Real x4427 = x4100 * x4266;
  const Real x4428 = x4100 * x4272;
  const Real x4429 = x4122 * x4283;
  const Real x4431 = x4122 * x4293;
  const Real x4432 = x4122 * x4303;
  const Real x4433 = x4122 * x4313;
  const Real x4434 = x4122 * x4322;
  const Real x4435 = x4122 * x4331;
  const Real x4436 = x4136 * x4343;
  const Real x4437 = x4136 * x4354;
  const Real x4438 = x4136 * x4367;
  const Real x4440 = x4136 * x4381;
  const Real x4442 = x4136 * x4394;
  const Real x4443 = x4136 * x4406;
  const Real x4455 = 222.85165433925602 - x4167 * x4407 - x4219 * x4416;
  const Real x4457 = x4455 - x4242 * x4423 - x4283 * x4429;
  const Real x4458 = x4457 - x4343 * x4436;
  w.to[0][0] = x4458;
  const Real x4470 = x4167 * x4408 + x4219 * x4418 - x4242 * x4424;
  const Real x4472 = x4283 * x4431 + x4470 - x4343 * x4437;
  w.to[0][1] = x4472;
  const Real x4484 = x4219 * x4419 - x4167 * x4410 - x4242 * x4425;
  const Real x4486 = x4283 * x4432 + x4484 + x4343 * x4438;
  w.to[0][2] = x4486;
  const Real x4498 = x4219 * x4420 - x4167 * x4411 - x4242 * x4426;
  const Real x4500 = x4283 * x4433 + x4498 + x4343 * x4440;
  w.to[0][3] = x4500;
  const Real x4512 = -17.828132347140482 + x4167 * x4412 + x4219 * x4421;
  const Real x4514 = x4512 - x4242 * x4427 + x4283 * x4434;
  const Real x4515 = x4514 - x4343 * x4442;
  w.to[0][4] = x4515;
  const Real x4527 = -2.2285165433925602 + x4167 * x4414 + x4219 * x4422;
  const Real x4529 = x4527 - x4242 * x4428 + x4283 * x4435;
  const Real x4530 = x4529 - x4343 * x4443;
  w.to[0][5] = x4530;
  const Real x4542 = 222.85165433925602 - x4178 * x4408 - x4223 * x4418;
  const Real x4544 = x4542 - x4248 * x4424 - x4293 * x4431;
  const Real x4545 = x4544 - x4354 * x4437;
  w.to[0][6] = x4545;
  const Real x4557 = x4178 * x4410 - x4223 * x4419 - x4248 * x4425;
  const Real x4559 = x4557 - x4293 * x4432 + x4354 * x4438;
  w.to[0][7] = x4559;
  const Real x4571 = 17.828132347140482 + x4178 * x4411 - x4223 * x4420;
  const Real x4573 = x4571 - x4248 * x4426 - x4293 * x4433;
  const Real x4574 = x4354 * x4440 + x4573;
  w.to[0][8] = x4574;
  const Real x4587 = x4178 * x4412 + x4223 * x4421 + x4248 * x4427;
  const Real x4592 = -(x4293 * x4434 + x4587 + x4354 * x4442);
  w.to[0][9] = x4592;
  const Real x4605 = x4178 * x4414 + x4223 * x4422 + x4248 * x4428;
  const Real x4610 = -(x4293 * x4435 + x4605 + x4354 * x4443);
  w.to[0][10] = x4610;
  const Real x4622 = 580.9731299927379 - x4187 * x4410 - x4226 * x4419;
  const Real x4624 = x4622 - x4254 * x4425 - x4303 * x4432;
  const Real x4625 = x4624 - x4367 * x4438;
  w.to[0][11] = x4625;
  const Real x4637 = 5.809731299927379 - x4187 * x4411 - x4226 * x4420;
  const Real x4639 = x4637 - x4254 * x4426 - x4303 * x4433;
  const Real x4640 = x4639 - x4367 * x4440;
  w.to[0][12] = x4640;
  const Real x4652 = x4187 * x4412 - x4226 * x4421 - x4254 * x4427;
  const Real x4654 = x4652 - x4303 * x4434 + x4367 * x4442;
  w.to[0][13] = x4654;
  const Real x4666 = x4187 * x4414 - x4226 * x4422 - x4254 * x4428;
  const Real x4668 = x4666 - x4303 * x4435 + x4367 * x4443;
  w.to[0][14] = x4668;
  const Real x4680 = 2.0725831948881592 - x4192 * x4411 - x4229 * x4420;
  const Real x4682 = x4680 - x4260 * x4426 - x4313 * x4433;
  const Real x4683 = x4682 - x4381 * x4440;
  w.to[0][15] = x4683;
  const Real x4695 = x4192 * x4412 - x4229 * x4421 - x4260 * x4427;
  const Real x4697 = x4695 - x4313 * x4434 + x4381 * x4442;
  w.to[0][16] = x4697;
  const Real x4709 = x4192 * x4414 - x4229 * x4422 - x4260 * x4428;
  const Real x4711 = x4709 - x4313 * x4435 + x4381 * x4443;
  w.to[0][17] = x4711;
  const Real x4723 = 2.0144858818888856 - x4182 * x4412 - x4232 * x4421;
  const Real x4725 = x4723 - x4266 * x4427 - x4322 * x4434;
  const Real x4726 = x4725 - x4394 * x4442;
  w.to[0][18] = x4726;
  const Real x4738 = 0.17828132347140482 - x4182 * x4414 - x4232 * x4422;
  const Real x4740 = x4738 - x4266 * x4428 - x4322 * x4435;
  const Real x4741 = x4740 - x4394 * x4443;
  w.to[0][19] = x4741;
  const Real x4753 = 0.6105204595515726 - x4206 * x4414 - x4235 * x4422;
  const Real x4755 = x4753 - x4272 * x4428 - x4331 * x4435;
  const Real x4756 = x4755 - x4406 * x4443;
  w.to[0][20] = x4756;
  const Real x4773 = x4053 * x4407 - x4139 * x4416 + x4145 * x4423;
  const Real x4783 = x4139 * x4418 - x4053 * x4408 + x4145 * x4424;
  const Real x4793 = x4053 * x4410 + x4139 * x4419 + x4145 * x4425;
  const Real x4803 = x4053 * x4411 + x4139 * x4420 + x4145 * x4426;
  const Real x4813 = x4139 * x4421 - x4053 * x4412 + x4145 * x4427;
  const Real x4823 = x4139 * x4422 - x4053 * x4414 + x4145 * x4428;
  const Real x4785 = x4154 * x4431 + x4783 + x4166 * x4437;
  const Real x4795 = x4154 * x4432 + x4793 - x4166 * x4438;
  const Real x4805 = x4154 * x4433 + x4803 - x4166 * x4440;
  const Real x4830 = -(x4773 - x4154 * x4429 + x4166 * x4436 + x3882);
  w.to[0][21] = x4830;
  const Real x4832 = -(x4785 - tau[5] * 222.8516543377526 + x3885);
  w.to[0][22] = x4832;
  const Real x4834 = -(x4795 - tau[5] * 0.0021340334659965573 + x3888);
  w.to[0][23] = x4834;
  const Real x4836 = -(x4805 - tau[5] * 17.828153687354867 + x3893);
  w.to[0][24] = x4836;
  const Real x4838 = -(x4154 * x4434 + x4813 + x4166 * x4442 + x3899);
  w.to[0][25] = x4838;
  const Real x4840 = -(x4154 * x4435 + x4823 + x4166 * x4443 + x3905);
  w.to[0][26] = x4840;
}

ADAGEN_NOINLINE void part_1_3(Workspace& w) {
  ADAGEN_INPUTS
  const Real x864 = w.x[30];
  const Real x872 = w.x[31];
  const Real x887 = w.x[32];
  const Real x997 = w.x[33];
  const Real x1069 = w.x[37];
  const Real x1089 = w.x[40];
  const Real x1096 = w.x[41];
  const Real x1617 = w.x[81];
  const Real x1813 = w.x[91];
  const Real x1817 = w.x[93];
  const Real x1821 = w.x[95];
  const Real x1852 = w.x[97];
  const Real x1860 = w.x[98];
  const Real x1871 = w.x[99];
  const Real x1920 = w.x[107];
  const Real x1978 = w.x[115];
  const Real x2022 = w.x[119];
  const Real x2028 = w.x[120];
  const Real x2111 = w.x[137];
  const Real x2117 = w.x[138];
  const Real x2126 = w.x[139];
  const Real x2138 = w.x[140];
  const Real x2151 = w.x[143];
  const Real x2174 = w.x[149];
  const Real x2219 = w.x[155];
  const Real x2282 = w.x[161];
  const Real x2319 = w.x[165];
  const Real x2324 = w.x[166];
  const Real x2330 = w.x[167];
  const Real x2336 = w.x[168];
  const Real x2342 = w.x[169];
  const Real x2804 = w.x[174];
  const Real x2810 = w.x[175];
  const Real x2980 = w.x[181];
  const Real x3063 = w.x[197];
  const Real x3069 = w.x[198];
  const Real x3078 = w.x[199];
  const Real x3090 = w.x[200];
  const Real x3113 = w.x[204];
  const Real x3178 = w.x[209];
  const Real x3206 = w.x[215];
  const Real x3254 = w.x[221];
  const Real x3321 = w.x[227];
  const Real x3361 = w.x[233];
  const Real x3370 = w.x[239];
  const Real x3376 = w.x[245];
  const Real x3382 = w.x[251];
  const Real x3390 = w.x[257];
  const Real x3885 = w.x[111];
  const Real x3888 = w.x[109];
  // link 9 "right_finger": acceleration where nothing acts on it
  const Real x934 = x864 * 1799.9964000071998 - x872 * 17.999964000071998 - x887 * 73.999892000216;
  // joint 8 "right_finger_slide": assembly: its two sides become one chain
  const Real x1128 = 2.65358979335273e-06 * x1089 - 0.9999999999964793 * x1096 + x934;
  const Real x1141 = x1128 - tau[8] * (x997 + x1069 + 73.999892000216);
  w.x[269] = x1141;
  // link 8 "left_finger": acceleration where nothing acts on it
  const Real x1903 = 73.999892000216 * x1871 - 17.999964000071998 * x1860 + 1799.9964000071998 * x1852;
  // joint 7 "left_finger_slide": assembly: its two sides become one chain
  const Real x2027 = tau[7] * (x1978 - 0.13 * x1920 + 73.999892000216);
  const Real x2033 = 0.13 * x1813 - x1821 + x1903 - x2027;
  w.x[268] = x2033;
  const Real x2507 = x1617 - x1617 * x2319 - x2151 * x2324;
  const Real x2509 = x2507 - x2174 * x2330 - x2219 * x2336;
  const Real x2671 = x2028 * x2319 + x2111 * x2324 + x2117 * x2330;
  const Real x2703 = x2126 * x2336 + x2671 + x2138 * x2342 + x2022;
  // joint 6 "flange_roll": assembly: its two sides become one chain
  const Real x2970 = x1817 + x2703 + (0.9999999999932537 * x2804 + 3.673205103346574e-06 * x2810);
  const Real x2982 = x2970 - tau[6] * (x2509 - x2282 * x2342 + 769.2307692307693);
  w.x[267] = x2982;
  const Real x3567 = 769.2307692307693 - x3113 * x3361 - x3178 * x3370;
  const Real x3569 = x3567 - x3206 * x3376 - x3254 * x3382;
  const Real x3743 = x2980 * x3361 + x3063 * x3370 + x3069 * x3376;
  const Real x3745 = x3743 - x3078 * x3382 + x3090 * x3390;
  const Real x3785 = x3745 - tau[6] * 0.0028255423871896726 + x2810;
  // joint 5 "wrist_pitch": assembly: its two sides become one chain
  const Real x4043 = 0.9999999999932537 * x3885 + 3.673205103346574e-06 * x3888 + x3785;
  const Real x4055 = x4043 - tau[5] * (x3569 - x3321 * x3390 + 222.85165434408793);
  w.x[266] = x4055;
}

ADAGEN_NOINLINE void part_1_4(Workspace& w) {
  ADAGEN_INPUTS
  const Real x1024 = w.x[34];
  const Real x1036 = w.x[35];
  const Real x1068 = w.x[36];
  const Real x1076 = w.x[38];
  const Real x1080 = w.x[39];
  const Real x1136 = w.x[42];
  const Real x1141 = w.x[269];
  const Real x1145 = w.x[43];
  const Real x1146 = w.x[44];
  const Real x1162 = w.x[45];
  const Real x1163 = w.x[46];
  const Real x1185 = w.x[47];
  const Real x1186 = w.x[48];
  const Real x1206 = w.x[49];
  const Real x1207 = w.x[50];
  const Real x1221 = w.x[51];
  const Real x1224 = w.x[52];
  const Real x1230 = w.x[53];
  const Real x1239 = w.x[54];
  const Real x1251 = w.x[55];
  const Real x1260 = w.x[56];
  const Real x1284 = w.x[57];
  const Real x1335 = w.x[58];
  const Real x1342 = w.x[59];
  const Real x1351 = w.x[60];
  const Real x1358 = w.x[61];
  const Real x1369 = w.x[62];
  const Real x1376 = w.x[63];
  const Real x1388 = w.x[64];
  const Real x1397 = w.x[65];
  const Real x1409 = w.x[66];
  const Real x1418 = w.x[67];
  const Real x1430 = w.x[68];
  const Real x1439 = w.x[69];
  const Real x1507 = w.x[72];
  const Real x1567 = w.x[77];
  const Real x1617 = w.x[81];
  const Real x1628 = w.x[82];
  const Real x1643 = w.x[83];
  const Real x1654 = w.x[84];
  const Real x1920 = w.x[107];
  const Real x1930 = w.x[110];
  const Real x1942 = w.x[113];
  const Real x1964 = w.x[114];
  const Real x1978 = w.x[115];
  const Real x1984 = w.x[116];
  const Real x1996 = w.x[117];
  const Real x2000 = w.x[118];
  const Real x2028 = w.x[120];
  const Real x2033 = w.x[268];
  const Real x2034 = w.x[121];
  const Real x2035 = w.x[122];
  const Real x2036 = w.x[123];
  const Real x2037 = w.x[124];
  const Real x2038 = w.x[125];
  const Real x2044 = w.x[126];
  const Real x2051 = w.x[127];
  const Real x2052 = w.x[128];
  const Real x2053 = w.x[129];
  const Real x2054 = w.x[130];
  const Real x2073 = w.x[131];
  const Real x2074 = w.x[132];
  const Real x2075 = w.x[133];
  const Real x2094 = w.x[134];
  const Real x2095 = w.x[135];
  const Real x2108 = w.x[136];
  const Real x2111 = w.x[137];
  const Real x2117 = w.x[138];
  const Real x2126 = w.x[139];
  const Real x2138 = w.x[140];
  const Real x2141 = w.x[141];
  const Real x2148 = w.x[142];
  const Real x2151 = w.x[143];
  const Real x2154 = w.x[144];
  const Real x2157 = w.x[145];
  const Real x2160 = w.x[146];
  const Real x2166 = w.x[147];
  const Real x2168 = w.x[148];
  const Real x2174 = w.x[149];
  const Real x2180 = w.x[150];
  const Real x2186 = w.x[151];
  const Real x2192 = w.x[152];
  const Real x2201 = w.x[153];
  const Real x2210 = w.x[154];
  const Real x2219 = w.x[155];
  const Real x2228 = w.x[156];
  const Real x2237 = w.x[157];
  const Real x2246 = w.x[158];
  const Real x2258 = w.x[159];
  const Real x2270 = w.x[160];
  const Real x2282 = w.x[161];
  const Real x2294 = w.x[162];
  const Real x2306 = w.x[163];
  const Real x2318 = w.x[164];
  const Real x2381 = w.x[170];
  const Real x2450 = w.x[171];
  const Real x2555 = w.x[172];
  const Real x2918 = w.x[179];
  const Real x2919 = w.x[180];
  const Real x2980 = w.x[181];
  const Real x2982 = w.x[267];
  const Real x2986 = w.x[182];
  const Real x2987 = w.x[183];
  const Real x2988 = w.x[184];
  const Real x2989 = w.x[185];
  const Real x2990 = w.x[186];
  const Real x3003 = w.x[187];
  const Real x3004 = w.x[188];
  const Real x3005 = w.x[189];
  const Real x3006 = w.x[190];
  const Real x3025 = w.x[191];
  const Real x3026 = w.x[192];
  const Real x3027 = w.x[193];
  const Real x3046 = w.x[194];
  const Real x3047 = w.x[195];
  const Real x3060 = w.x[196];
  const Real x3063 = w.x[197];
  const Real x3069 = w.x[198];
  const Real x3078 = w.x[199];
  const Real x3090 = w.x[200];
  const Real x3091 = w.x[201];
  const Real x3094 = w.x[202];
  const Real x3101 = w.x[203];
  const Real x3113 = w.x[204];
  const Real x3139 = w.x[205];
  const Real x3157 = w.x[206];
  const Real x3171 = w.x[207];
  const Real x3175 = w.x[208];
  const Real x3178 = w.x[209];
  const Real x3181 = w.x[210];
  const Real x3184 = w.x[211];
  const Real x3187 = w.x[212];
  const Real x3194 = w.x[213];
  const Real x3200 = w.x[214];
  const Real x3206 = w.x[215];
  const Real x3212 = w.x[216];
  const Real x3218 = w.x[217];
  const Real x3224 = w.x[218];
  const Real x3234 = w.x[219];
  const Real x3243 = w.x[220];
  const Real x3254 = w.x[221];
  const Real x3266 = w.x[222];
  const Real x3276 = w.x[223];
  const Real x3285 = w.x[224];
  const Real x3297 = w.x[225];
  const Real x3309 = w.x[226];
  const Real x3321 = w.x[227];
  const Real x3333 = w.x[228];
  const Real x3345 = w.x[229];
  const Real x3357 = w.x[230];
  const Real x3614 = w.x[112];
  const Real x3985 = w.x[108];
  const Real x3990 = w.x[106];
  const Real x3996 = w.x[105];
  const Real x3997 = w.x[104];
  const Real x4053 = w.x[103];
  const Real x4055 = w.x[266];
  const Real x4059 = w.x[102];
  const Real x4060 = w.x[101];
  const Real x4061 = w.x[100];
  const Real x4062 = w.x[96];
  const Real x4063 = w.x[94];
  const Real x4077 = w.x[92];
  const Real x4078 = w.x[90];
  const Real x4079 = w.x[89];
  const Real x4081 = w.x[88];
  const Real x4100 = w.x[87];
  const Real x4101 = w.x[86];
  const Real x4102 = w.x[85];
  const Real x4122 = w.x[80];
  const Real x4123 = w.x[79];
  const Real x4136 = w.x[78];
  const Real x4139 = w.x[76];
  const Real x4145 = w.x[75];
  const Real x4154 = w.x[74];
  const Real x4166 = w.x[73];
  const Real x4167 = w.x[71];
  const Real x4178 = w.x[70];
  const Real x4182 = w.x[29];
  const Real x4187 = w.x[28];
  const Real x4192 = w.x[27];
  const Real x4206 = w.x[26];
  const Real x4219 = w.x[25];
  const Real x4223 = w.x[24];
  const Real x4226 = w.x[23];
  const Real x4229 = w.x[22];
  const Real x4232 = w.x[21];
  const Real x4235 = w.x[20];
  const Real x4242 = w.x[19];
  const Real x4248 = w.x[18];
  const Real x4254 = w.x[17];
  const Real x4260 = w.x[16];
  const Real x4266 = w.x[15];
  const Real x4272 = w.x[270];
  const Real x4283 = w.x[271];
  const Real x4293 = w.x[272];
  const Real x4303 = w.x[273];
  const Real x4313 = w.x[274];
  const Real x4322 = w.x[275];
  const Real x4331 = w.x[276];
  const Real x4343 = w.x[277];
  const Real x4354 = w.x[278];
  const Real x4367 = w.x[279];
  const Real x4381 = w.x[280];
  const Real x4394 = w.x[281];
  const Real x4406 = w.x[282];
  // message received
  const Real x4841 = w.from[1][0];
  const Real x4842 = w.from[1][1];
  const Real x4843 = w.from[1][2];
  const Real x4844 = w.from[1][3];
  const Real x4845 = w.from[1][4];
  const Real x4846 = w.from[1][5];
  // joint 5 "wrist_pitch": disassembly: its acceleration and force
  const Real x4858 = x4167 * x4841 - x4178 * x4842 + x4187 * x4843;
  const Real x4860 = x4192 * x4844 + x4858 - x4182 * x4845;
  const Real x4870 = x4223 * x4842 - x4219 * x4841 + x4226 * x4843;
  const Real x4872 = x4229 * x4844 + x4870 + x4232 * x4845;
  const Real x4881 = x4242 * x4841 + x4248 * x4842 + x4254 * x4843;
  const Real x4883 = x4260 * x4844 + x4881 + x4266 * x4845;
  const Real x4893 = x4293 * x4842 - x4283 * x4841 + x4303 * x4843;
  const Real x4895 = x4313 * x4844 + x4893 + x4322 * x4845;
  const Real x4906 = x4343 * x4841 + x4354 * x4842 - x4367 * x4843;
  const Real x4908 = x4906 - x4381 * x4844 + x4394 * x4845;
  const Real x4923 = 222.8516543377526 * x4842 + 0.0021340334659965573 * x4843 + 17.828153687354867 * x4844;
  const Real x4930 = x4136 * (x4406 * x4846 + x4908 + x4166);
  const Real x4929 = x4122 * (x4331 * x4846 + x4895 + x4154);
  const Real x4933 = x4929 - x4123 * x4930;
  const Real x4928 = x4100 * (x4272 * x4846 + x4883 + x4145);
  const Real x4939 = x4928 - x4102 * x4930 - x4101 * x4933;
  const Real x4927 = x4077 * (x4235 * x4846 + x4872 + x4139);
  const Real x4947 = x4927 - x4081 * x4930 + x4079 * x4933;
  const Real x4948 = x4947 - x4078 * x4939;
  const Real x4926 = x4059 * (x4860 - x4206 * x4846 + x4053);
  const Real x4958 = x4926 - x4063 * x4930 - x4062 * x4933;
  const Real x4960 = x4958 - x4061 * x4939 - x4060 * x4948;
  const Real x4967 = x3997 * x4933 + x3614 * x4930 + x3996 * x4939;
  const Real x4969 = x3990 * x4948 + x4967 + x3985 * x4960;
  const Real x4970 = x4923 - x4055 + x4969;
  w.result[5] = x4970;
  // joint 6 "flange_roll": disassembly: its acceleration and force
  const Real x4982 = x3113 * tau[5] - x3157 * x4930 - x3139 * x4933;
  const Real x4984 = x3094 * x4939 + x4982 - x3101 * x4948;
  const Real x4994 = x3178 * tau[5] + x3187 * x4930 + x3184 * x4933;
  const Real x4996 = x3181 * x4939 + x4994 + x3175 * x4948;
  const Real x5005 = x3206 * tau[5] + x3224 * x4930 + x3218 * x4933;
  const Real x5007 = x3212 * x4939 + x5005 + x3200 * x4948;
  const Real x5018 = x3285 * x4930 - x3254 * tau[5] + x3276 * x4933;
  const Real x5020 = x5018 - x3266 * x4939 + x3243 * x4948;
  const Real x5029 = x3321 * tau[5] + x3357 * x4930 + x3345 * x4933;
  const Real x5031 = x3333 * x4939 + x5029 + x3309 * x4948;
  const Real x5049 = 0.00011302169548758689 * x4933 - (0.0028255423871896726 * tau[5] + 30.769230769023192 * x4930);
  const Real x5058 = x3060 * (x3297 * x4960 + x5031 + x3090);
  const Real x5057 = x3046 * (x3234 * x4960 + x5020 + x3078);
  const Real x5061 = x5057 - x3047 * x5058;
  const Real x5056 = x3025 * (x3194 * x4960 + x5007 + x3069);
  const Real x5067 = x5056 - x3027 * x5058 - x3026 * x5061;
  const Real x5055 = x3003 * (x4996 - x3171 * x4960 + x3063);
  const Real x5075 = x5055 - x3006 * x5058 - x3005 * x5061;
  const Real x5076 = x5075 - x3004 * x5067;
  const Real x5054 = x2986 * (x3091 * x4960 + x4984 + x2980);
  const Real x5086 = x5054 - x2990 * x5058 - x2989 * x5061;
  const Real x5088 = x5086 - x2988 * x5067 - x2987 * x5076;
  const Real x5095 = x2919 * x5061 + x2555 * x5058 + x2918 * x5067;
  const Real x5052 = x5049 - 2.8255423871896722e-05 * x4939 - 769.2307692255798 * x4948 + x2982;
  const Real x5098 = x2450 * x5076 + x5095 + x2381 * x5088 - x5052;
  w.result[6] = x5098;
  // joint 7 "left_finger_slide": disassembly: its acceleration and force
  const Real x5107 = x1617 * tau[6] + x1654 * x5058 + x1643 * x5061;
  const Real x5109 = x1628 * x5067 + x5107 + x1567 * x5076;
  const Real x5118 = x2151 * tau[6] + x2160 * x5058 + x2157 * x5061;
  const Real x5120 = x2154 * x5067 + x5118 + x2044 * x5076;
  const Real x5129 = x2174 * tau[6] + x2192 * x5058 + x2186 * x5061;
  const Real x5131 = x2180 * x5067 + x5129 + x2168 * x5076;
  const Real x5140 = x2219 * tau[6] + x2246 * x5058 + x2237 * x5061;
  const Real x5142 = x2228 * x5067 + x5140 + x2210 * x5076;
  const Real x5151 = x2282 * tau[6] + x2318 * x5058 + x2306 * x5061;
  const Real x5153 = x2294 * x5067 + x5151 + x2270 * x5076;
  const Real x5167 = x1942 * tau[6] + x1984 * x5058 + x1978 * x5061;
  const Real x5169 = x2141 * x5067 + x5167 + x1930 * x5076;
  const Real x5177 = x2108 * (x2258 * x5088 + x5153 + x2138);
  const Real x5176 = x2094 * (x2201 * x5088 + x5142 + x2126);
  const Real x5180 = x5176 - x2095 * x5177;
  const Real x5175 = x2073 * (x2166 * x5088 + x5131 + x2117);
  const Real x5186 = x5175 - x2075 * x5177 - x2074 * x5180;
  const Real x5174 = x2051 * (x2148 * x5088 + x5120 + x2111);
  const Real x5194 = x5174 - x2054 * x5177 - x2053 * x5180;
  const Real x5195 = x5194 - x2052 * x5186;
  const Real x5173 = x2034 * (x1507 * x5088 + x5109 + x2028);
  const Real x5205 = x5173 - x2038 * x5177 - x2037 * x5180;
  const Real x5207 = x5205 - x2036 * x5186 - x2035 * x5195;
  const Real x5214 = x2000 * x5180 + x1964 * x5177 + x1930 * x5186;
  const Real x5216 = x1996 * x5195 + x5214 + x1942 * x5207;
  const Real x5217 = x5216 - (x1920 * x5088 + x5169 + x2033);
  w.result[7] = x5217;
  const Real x5234 = x5088 - (q[7] * x5180 - 0.13 * tau[7] + x5195);
  const Real x5235 = x5076 - (x5186 + 0.13 * x5177);
  const Real x5236 = tau[6] - (x5207 - q[7] * x5177);
  const Real x5237 = x5067 - x5177;
  const Real x5238 = x5061 - tau[7];
  const Real x5239 = x5058 - x5180;
  // joint 8 "right_finger_slide": disassembly: its acceleration and force
  const Real x5260 = 1.5120169762693617e-05 * x5239 - (0.00015834177779265263 * x5237 + 27.095931187385858 * x5238);
  const Real x5262 = 0.0017850200414291078 * x5235 + x5260 - 300.897586242875 * x5234;
  const Real x5275 = 59.670781892791446 * x5237 - 7.234479409858621e-05 * x5238 - 5.69800569798539 * x5239;
  const Real x5277 = x5275 - 672.6812282343863 * x5235 - 0.0008033816505865777 * x5234;
  const Real x5286 = x1358 * x5237 + x1369 * x5238 + x1376 * x5239;
  const Real x5288 = x1342 * x5235 + x5286 + x1335 * x5234;
  const Real x5297 = x1418 * x5237 + x1430 * x5238 + x1439 * x5239;
  const Real x5299 = x1397 * x5235 + x5297 + x1388 * x5234;
  const Real x5248 = 328.7950427750268 * x5236 - (47.81116318204386 * x5234 + 7.026218837536823 * x5238);
  const Real x5316 = 3.4167136554933856e-06 * x5237 + x1284 * x5238 - 6.243740690241717e-07 * x5239;
  const Real x5318 = x5316 - 7.371082759313139e-05 * x5235 + x1260 * x5234;
  const Real x5326 = x1221 * (x1409 * x5236 + x5299 + x1251);
  const Real x5325 = x1206 * (x1351 * x5236 + x5288 + x1239);
  const Real x5329 = x5325 - x1207 * x5326;
  const Real x5324 = 1.648191504944564e-05 * (0.0001275136846625453 * x5236 + x5277 + x1230);
  const Real x5335 = x5324 - x1186 * x5326 - x1185 * x5329;
  const Real x5323 = 1.658353407741297e-05 * (47.758820356278655 * x5236 + x5262 + x1224);
  const Real x5343 = x5323 + x1163 * x5326 - x1162 * x5329;
  const Real x5344 = 1.63606725685963e-08 * x5335 + x5343;
  const Real x5353 = 3.3296807285906615e-06 * (x1136 + x5248) - x1146 * x5326;
  const Real x5355 = x5353 - x1145 * x5329 - 4.2244063836038523e-10 * x5335;
  const Real x5364 = x1080 * x5329 + x1068 * x5326 + x1036 * x5335;
  const Real x5357 = x1024 * (x5355 - 0.00015919590865819434 * x5344);
  const Real x5366 = x1076 * x5344 + x5364 - x5357;
  const Real x5367 = x5366 - (x5318 - x1024 * x5236 + x1141);
  w.result[8] = x5367;
}

// ---- 5. processes -------------------------------------------------------------------------------

// Process 0: 5 of 9 joints: "base_yaw", "shoulder_pitch", "upper_arm_roll", "elbow_pitch", "forearm_roll"
constexpr std::array<int, 5> kRead_0{0, 1, 2, 3, 4};
constexpr std::array<int, 5> kOwned_0{0, 1, 2, 3, 4};

void run_0([[maybe_unused]] Workspace& w, [[maybe_unused]] Channel& channel) {
  ADAGEN_INPUTS
  stamp(0);
  if (!(unlike_zero(q + 0, 5) + unlike_zero(v + 0, 5) + unlike_zero(tau + 0, 5) == 0))
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
  if (!(unlike_zero(w.result.data() + 0, 5) == 0)) name_what_overflows(w, kOwned_0);
  if (w.status != kFine) return;
  std::copy_n(w.result.data() + 0, 5, w.qdd + 0);
}

// Process 1: 4 of 9 joints: "wrist_pitch", "flange_roll", "left_finger_slide", "right_finger_slide"; kinematics of 5 more on the way to the ground
constexpr std::array<int, 9> kRead_1{0, 1, 2, 3, 4, 5, 6, 7, 8};
constexpr std::array<int, 4> kOwned_1{5, 6, 7, 8};

void run_1([[maybe_unused]] Workspace& w, [[maybe_unused]] Channel& channel) {
  ADAGEN_INPUTS
  stamp(0);
  if (!(unlike_zero(q + 0, 9) + unlike_zero(v + 0, 9) + unlike_zero(tau + 5, 4) == 0))
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
  if (!(unlike_zero(w.result.data() + 5, 4) == 0)) name_what_overflows(w, kOwned_1);
  if (w.status != kFine) return;
  std::copy_n(w.result.data() + 5, 4, w.qdd + 5);
}

constexpr std::array<void (*)(Workspace&, Channel&), kProcesses> kRun{run_0, run_1};

// What each process reads of q and v, the velocity entries whose qdd is its own, and whose tau it
// reads.
constexpr std::array<int, 5> kReadQ_0{0, 1, 2, 3, 4};
constexpr std::array<int, 5> kReadV_0{0, 1, 2, 3, 4};
constexpr std::array<int, 5> kOwn_0{0, 1, 2, 3, 4};
constexpr std::array<int, 5> kTorque_0{0, 1, 2, 3, 4};
constexpr std::array<int, 9> kReadQ_1{0, 1, 2, 3, 4, 5, 6, 7, 8};
constexpr std::array<int, 9> kReadV_1{0, 1, 2, 3, 4, 5, 6, 7, 8};
constexpr std::array<int, 4> kOwn_1{5, 6, 7, 8};
constexpr std::array<int, 4> kTorque_1{5, 6, 7, 8};
constexpr std::array<ProcessInfo, kProcesses> kProcess{ {
    {5, kReadQ_0.data(), 5, kReadV_0.data(), 5, kOwn_0.data(), 5, kTorque_0.data()},
    {9, kReadQ_1.data(), 9, kReadV_1.data(), 4, kOwn_1.data(), 4, kTorque_1.data()},
} };

// Hands states and accelerations between process 0 and the others. Messages behind the plan's own:
// first the state to each process, then the accelerations from each.
class Solver {
 public:
  Workspace w;
  Channel channel;
  std::string text;  // of the last failure

  // State and result in place: reads what this process needs, writes what it owns.
  int solve(const Real* q, const Real* v, const Real* tau, Real* qdd) {
    if (channel.broken()) return finish(failure(kNoAnswer, 0));
    prepare(q, v, tau, qdd);
    kRun[channel.rank()](w, channel);
    return finish(w.status);
  }

  // Everything through process 0: it has the state and gets all accelerations.
  int solve_at_root(const Real* q, const Real* v, const Real* tau, Real* qdd) {
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
  int solve_for_root() {
    const int rank = channel.rank();
    const ProcessInfo& own = kProcess[static_cast<std::size_t>(rank)];
    if (own.v_count == 0) return finish(kFine);
    int status = kFine;
    const Real* content = channel.receive(state_message(rank), status);
    for (int k = 0; k < own.q_count; ++k) q_[own.q[k]] = *content++;
    for (int k = 0; k < own.v_read_count; ++k) v_[own.v_read[k]] = *content++;
    for (int k = 0; k < own.tau_count; ++k) tau_[own.tau[k]] = *content++;
    prepare(q_.data(), v_.data(), tau_.data(), qdd_.data());
    Channel::fail(w.status, status);
    kRun[rank](w, channel);
    Real* result = channel.outgoing(result_message(rank), w.status);
    for (int k = 0; k < own.v_count; ++k) result[k] = qdd_[own.v[k]];
    channel.send(result_message(rank), w.status);
    return finish(w.status);
  }

  int solve_as_root(const Real* q, const Real* v, const Real* tau, Real* qdd, int status = kFine) {
    for (int p = 1; p < kProcesses; ++p) {
      const ProcessInfo& other = kProcess[static_cast<std::size_t>(p)];
      if (other.v_count == 0) continue;
      Real* content = channel.outgoing(state_message(p), status);
      for (int k = 0; k < other.q_count; ++k) *content++ = q[other.q[k]];
      for (int k = 0; k < other.v_read_count; ++k) *content++ = v[other.v_read[k]];
      for (int k = 0; k < other.tau_count; ++k) *content++ = tau[other.tau[k]];
      channel.send(state_message(p), status);
    }
    prepare(q, v, tau, qdd_.data());
    Channel::fail(w.status, status);
    kRun[0](w, channel);
    for (int p = 1; p < kProcesses; ++p) {
      const ProcessInfo& other = kProcess[static_cast<std::size_t>(p)];
      if (other.v_count == 0) continue;
      const Real* result = channel.receive(result_message(p), w.status);
      for (int k = 0; k < other.v_count; ++k) qdd_[other.v[k]] = result[k];
    }
    if (w.status == kFine) std::copy(qdd_.begin(), qdd_.end(), qdd);
    return finish(w.status);
  }

  void prepare(const Real* q, const Real* v, const Real* tau, Real* qdd) {
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

  std::array<Real, kNq> q_{};
  std::array<Real, kNv> v_{}, qdd_{};
  std::array<Real, kNtau> tau_{};
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
Vec vec3(const Real* x) { return {double(x[0]), double(x[1]), double(x[2])}; }
Mat mat3(const Real* x) { return {vec3(x), vec3(x + 3), vec3(x + 6)}; }

struct Body {
  Mat turn;   // child to parent coordinates
  Vec shift;  // child origin in parent coordinates
  Vec w, dw;  // angular velocity and acceleration, in the body's frame
  Vec a;      // acceleration of its origin minus gravity, in the body's frame
  Vec f, n;   // force on it through its joint, and moment about its origin
};

// Rotation and origin of the child frame in the joint frame.
void displace(const JointConstants& joint, const Real* q, Mat& turn, Vec& shift) {
  turn = {Vec{1, 0, 0}, Vec{0, 1, 0}, Vec{0, 0, 1}};
  shift = {};
  const auto about_z = [&turn](double angle) {
    const double c = std::cos(angle), s = std::sin(angle);
    turn = {Vec{c, -s, 0}, Vec{s, c, 0}, Vec{0, 0, 1}};
  };
  const auto orient = [&turn](const Real* p) {
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
void motion(const JointConstants& joint, const Real* x, Vec& angular, Vec& linear) {
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
void add_passive(const JointConstants& joint, const Real* q, const Real* v, const Real* qdd,
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
void push(const Real* outer, std::array<Body, kLinkCount>& body) {
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
void inverse_dynamics(const Real* q, const Real* v, const Real* qdd, const Real* outer,
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
double slip(const Real* tau, const Real* qdd) {
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
double residual(const Real* q, const Real* v, const Real* tau, const Real* qdd) {
  static std::array<double, kNv> needed, at_rest;
  static std::array<Real, kNv> zero{};
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

// Reads a states file (JSON) and writes a result file, joints by name.
struct States {
  int count = 0;
  std::vector<Real> q, v, tau;  // one state after the other
};

class StatesReader {
 public:
  explicit StatesReader(std::string text) : text_(std::move(text)) {}

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
  [[noreturn]] void refuse(const std::string& what) const {
    throw std::runtime_error(where_ + what);
  }

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
    std::vector<Real>& values = is_q ? states.q : key == "v" ? states.v : states.tau;
    int count = 0;
    array([&] {
      const std::vector<double> entry = numbers();
      if (entry.size() != size)
        refuse("state " + std::to_string(count + 1) + " has " + std::to_string(entry.size()) +
               " numbers, not " + std::to_string(size));
      const std::size_t row = stride * static_cast<std::size_t>(count);
      if (values.size() < row + stride) values.resize(row + stride);
      for (std::size_t k = 0; k < size; ++k) values[row + start + k] = static_cast<Real>(entry[k]);
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
      states.tau[i / 6 * kNtau + kNv + 6 * k + i % 6] = static_cast<Real>(given[i]);
  }

  static void fill_slaved(States& states) {
    for (int s = 0; s < states.count; ++s)
      slave(states.q.data() + static_cast<long>(s) * kNq,
            states.v.data() + static_cast<long>(s) * kNv);
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

// more: further members of the file, each after a comma.
bool write_result(const std::string& path, const std::vector<Real>& qdd, int count,
                  const std::string& more) {
  std::FILE* file = std::fopen(path.c_str(), "w");
  if (file == nullptr) return false;
  std::fputs("{\"joints\": {", file);
  for (int j = 0; j < kJointCount; ++j) {
    std::fprintf(file, "%s\n%s: {\"qdd\": [", j == 0 ? "" : ",", quoted(kJoints[j].name).c_str());
    for (int s = 0; s < count; ++s) {
      const Real* x = qdd.data() + static_cast<long>(s) * kNv + kJoints[j].v;
      std::fputs(s == 0 ? "" : ", ", file);
      if (kJoints[j].nv > 1) std::fputs("[", file);
      for (int k = 0; k < kJoints[j].nv; ++k)
        std::fprintf(file, "%s%.17g", k == 0 ? "" : ", ", static_cast<double>(x[k]));
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

inline void normalise(State& q) {
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
inline void rate(const State& q, const State& v, State& result) {
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
inline void local_rate(const State& q, const State& x, const State& v, State& result) {
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
inline void advance(const State& anchor, const State& x, State& q) {
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

// Fixed-step integrators of q' = G(q) v, v' = a(q, v). All but RK4 and the explicit Euler method
// move quaternions by the exponential map, so that these keep their length.
enum class Integrator { kEuler, kSemiImplicit, kRk4, kRkmk4 };

struct IntegratorInfo {
  const char* name;
  Integrator kind;
  int evaluations;  // for a step
};

constexpr std::array<IntegratorInfo, 4> kIntegrators{{
    {"euler", Integrator::kEuler, 1},
    {"semi-implicit", Integrator::kSemiImplicit, 1},
    {"rk4", Integrator::kRk4, 4},
    {"rkmk4", Integrator::kRkmk4, 4},
}};

class Stepper {
 public:
  using State = manifold::State;

  Stepper() {
    for (State* x : {&middle_q_, &q_rate_, &q_sum_}) x->resize(kNq);
    for (State* x : {&middle_v_, &a_, &v_sum_, &x_, &x_rate_, &x_sum_}) x->resize(kNv);
  }

  // One step of length h from (q, v) to (q, v). accelerate(q, v, a) evaluates and returns a status;
  // where that is a failure, the state stays as it was.
  template <class Accelerate>
  int step(Integrator kind, double h, State& q, State& v, Accelerate accelerate) {
    switch (kind) {
      case Integrator::kRk4:
        return runge_kutta(h, q, v, accelerate);
      case Integrator::kRkmk4:
        return munthe_kaas(h, q, v, accelerate);
      default:
        return euler(kind == Integrator::kSemiImplicit, h, q, v, accelerate);
    }
  }

 private:
  static constexpr std::array<double, 4> kNode{0, 0.5, 0.5, 1}, kWeight{1, 2, 2, 1};

  // y + h dy
  static void move(const State& y, double h, const State& dy, State& result) {
    for (std::size_t k = 0; k < y.size(); ++k) result[k] = y[k] + h * dy[k];
  }

  template <class Accelerate>
  int euler(bool semi_implicit, double h, State& q, State& v, Accelerate accelerate) {
    if (const int failed = accelerate(q, v, a_)) return failed;
    manifold::rate(q, v, q_rate_);
    move(v, h, a_, v);
    if (semi_implicit) {
      std::fill(x_.begin(), x_.end(), 0.0);
      manifold::local_rate(q, x_, v, x_rate_);
      move(x_, h, x_rate_, x_);
      manifold::advance(q, x_, middle_q_);
      q.swap(middle_q_);
    } else {
      move(q, h, q_rate_, q);
    }
    manifold::normalise(q);
    return kFine;
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
      if (const int failed = accelerate(middle_q_, middle_v_, a_)) return failed;
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
      if (const int failed = accelerate(middle_q_, middle_v_, a_)) return failed;
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
  const IntegratorInfo* integrator = &kIntegrators[2];
  long long every = 1;  // steps between the rows of the trajectory
  std::string trajectory;
};

// What the program is asked to do.
struct Options {
  std::string states, result, trace;
  bool check = false, time = false, json = false, help = false, pin = true;
  int repeat = 200;
  std::uint64_t seed = 1;
  double time_limit = 30, tolerance = kTolerance;
  ChannelMode channel = kChannelMode;
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
    "  --integrator NAME euler, semi-implicit, rk4 or rkmk4 (rk4)\n"
    "  --trajectory FILE where the motion goes: FILE.csv or FILE.npz\n"
    "  --every N         keep every Nth step of it (1), and the last\n"
    "  --trace FILE      when each process did what, as JSON (medians over random states)\n"
    "  --time            time an evaluation: median, minimum, 99th percentile over random states\n"
    "  --repeat N        evaluations of each random state when timing (200)\n"
    "  --seed N          seed of the random states (1)\n"
    "  --tolerance X     largest residual that --check lets pass\n"
    "  --channel KIND    auto, window (processes share memory) or message (MPI messages)\n"
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
  if (kBatch && (options.simulation.seconds > 0 || !options.trace.empty()))
    return "a batch solver has neither --simulate nor --trace";
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
    else if (flag("--json"))
      options.json = true;
    else if (flag("--help"))
      options.help = true;
    else if (flag("--no-pin"))
      options.pin = false;
    else {
      const char* const known[] = {"--states", "--result",    "--trace",   "--repeat",
                                   "--seed",   "--tolerance", "--channel", "--timeout"};
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
      starts_.push_back(ns(stamps_[k] - first));
      lengths_.push_back(ns(stamps_[k + 1] - stamps_[k]));
    }
    lasts_.push_back(ns(stamps_.back() - first));
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

  static double ns(Clock::rep ticks) {
    return std::chrono::duration<double, std::nano>(Clock::duration(ticks)).count();
  }

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

  // What one look at the clock takes; each stage's length holds one.
  static double clock_cost() {
    double best = 1e9;
    for (int k = 0; k < 64; ++k) {
      const Clock::time_point start = Clock::now();
      for (int i = 0; i < 64; ++i) (void)Clock::now();
      best = std::min(best, ns((Clock::now() - start).count()) / 65);
    }
    return best;
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
    Real* q =
        states.q.data() + size(kNq) / static_cast<std::size_t>(count) * static_cast<std::size_t>(s);
    Real* v =
        states.v.data() + size(kNv) / static_cast<std::size_t>(count) * static_cast<std::size_t>(s);
    Real* tau = states.tau.data() +
                size(kNtau) / static_cast<std::size_t>(count) * static_cast<std::size_t>(s);
    for (const JointConstants& joint : kJoints) {
      const bool turns = joint.kind == JointKind::kRevolute;
      for (int k = 0; k < joint.nq; ++k)
        q[joint.q + k] = static_cast<Real>(turns ? 3.141592653589793 * uniform() : uniform());
      if (joint.nq >= 4) {
        double p[4], squared;
        do {
          squared = 0;
          for (double& x : p) x = uniform(), squared += x * x;
        } while (squared > 1 || squared < 0.01);
        for (int k = 0; k < 4; ++k)
          q[joint.q + joint.nq - 4 + k] = static_cast<Real>(p[k] / std::sqrt(squared));
      }
      for (int k = 0; k < joint.nv; ++k) {
        v[joint.v + k] = static_cast<Real>(uniform());
        tau[joint.v + k] = static_cast<Real>(uniform());
      }
    }
    for (int k = kNv; k < kNtau; ++k) tau[k] = static_cast<Real>(uniform());
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
  const auto share = [&](std::vector<Real>& x, int n) {
    x.resize(static_cast<std::size_t>(states.count) * static_cast<std::size_t>(n));
    MPI_Bcast(x.data(), static_cast<int>(x.size()), kMpiReal, 0, comm);
  };
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
  std::vector<Real> qdd;  // one acceleration after the other
  bool pinned = false;

  Session(Options given, int own_rank) : options(std::move(given)), rank(own_rank) {}

  MPI_Comm comm() const { return solver.channel.comm(); }
  const Real* q(int s) const { return states.q.data() + static_cast<long>(s) * kNq; }
  const Real* v(int s) const { return states.v.data() + static_cast<long>(s) * kNv; }
  const Real* tau(int s) const { return states.tau.data() + static_cast<long>(s) * kNtau; }
  Real* acceleration(int s) { return qdd.data() + static_cast<long>(s) * kNv; }

  void use(States given) {
    states = std::move(given);
    qdd.assign(static_cast<std::size_t>(states.count) * kNv, Real(0));
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
    return solver.channel.windowed() ? "window" : "message";
  }
};

// How long an evaluation takes (--time), and where the time goes (--trace).
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

class Timing {
 public:
  explicit Timing(Session& session) : session_(session) {}

  int time_all() {
    if constexpr (kBatch) return time_batch(session_.solver);
    session_.use(random_states(kRandomStates, session_.options.seed));
    session_.pinned = pin();
    std::vector<double> in_place, at_root;
    int failed = kFine;
    for (int pass = -1; pass < session_.options.repeat && failed == kFine;
         ++pass) {  // the first one warms up
      session_.watch.again();
      for (int s = 0; s < session_.states.count; ++s) {
        Real* const qdd = session_.acceleration(s);
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
    timed_ = true;
    return kDone;
  }

  // A batch of as many random states for each process; nanoseconds for each state and process.
  template <class S>
  int time_batch(S& solver) {
    constexpr int kCount = kRandomStates * kProcesses;
    session_.use(random_states(kCount, session_.options.seed));
    session_.pinned = pin();
    std::vector<double> in_place, at_root;
    int failed = kFine;
    for (int pass = -1; pass < session_.options.repeat && failed == kFine; ++pass) {
      session_.watch.again();
      if constexpr (kBatch) {
        const int first = kRandomStates * session_.rank;
        const Clock::time_point start = start_together();
        failed = solver.solve_batch(kRandomStates, session_.q(first), session_.v(first),
                                    session_.tau(first), session_.acceleration(first));
        const double in_place_ns =
            std::chrono::duration<double, std::nano>(Clock::now() - start).count();
        const Clock::time_point start_root = start_together();
        const int second = solver.solve_batch_at_root(kCount, session_.q(0), session_.v(0),
                                                      session_.tau(0), session_.acceleration(0));
        const double root_ns =
            std::chrono::duration<double, std::nano>(Clock::now() - start_root).count();
        if (failed == kFine) failed = second;
        if (pass < 0) continue;
        in_place.push_back(in_place_ns / kRandomStates);
        at_root.push_back(root_ns / kRandomStates);
      }
      MPI_Allreduce(MPI_IN_PLACE, &failed, 1, MPI_INT, MPI_MAX, session_.comm());
    }
    if (failed != kFine)
      return session_.complain(kInputAtFault, "random states: " + describe(failed));
    for (std::vector<double>* ns : {&in_place, &at_root})  // over when the last process is done
      MPI_Allreduce(MPI_IN_PLACE, ns->data(), static_cast<int>(ns->size()), MPI_DOUBLE, MPI_MAX,
                    session_.comm());
    in_place_ = statistics(std::move(in_place));
    at_root_ = statistics(std::move(at_root));
    timed_ = true;
    return kDone;
  }

  // The same evaluations with time stamps between the stages of each process.
  int trace_all() {
    session_.use(random_states(kRandomStates, session_.options.seed));
    session_.pinned = session_.pinned || pin();
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
    if (!timed_) return "";
    char text[300];
    std::snprintf(text, sizeof text,
                  ", \"time\": {\"evaluations\": %d, \"pinned\": %s, "
                  "\"in_place\": {\"median_ns\": %.0f, \"min_ns\": %.0f, \"p99_ns\": %.0f}, "
                  "\"through_root\": {\"median_ns\": %.0f, \"min_ns\": %.0f, \"p99_ns\": %.0f}}",
                  session_.options.repeat * kRandomStates, session_.pinned ? "true" : "false",
                  in_place_.median, in_place_.least, in_place_.percentile99, at_root_.median,
                  at_root_.least, at_root_.percentile99);
    return text;
  }

  void print(std::FILE* out) const {
    if (!timed_) return;
    std::fprintf(out,
                 "time   %d process%s%s, ns per %s: median, minimum, 99th percentile\n",
                 kProcesses, kProcesses == 1 ? "" : "es", session_.pinned ? ", pinned" : "",
                 kBatch ? "state and process" : "evaluation");
    std::fprintf(out, "       state and result in place       %8.0f %8.0f %8.0f\n",
                 in_place_.median, in_place_.least, in_place_.percentile99);
    std::fprintf(out, "       everything through process 0    %8.0f %8.0f %8.0f\n", at_root_.median,
                 at_root_.least, at_root_.percentile99);
    if (kBatch)
      std::fprintf(out, "       states per second in place      %8.3g (%.3g per process)\n",
                   1e9 * kProcesses / in_place_.median, 1e9 / in_place_.median);
  }

 private:
  using Clock = std::chrono::steady_clock;

  // Each process on a core of its own, where there are enough of them.
  bool pin() {
    int pinned = 0;
#if defined(__linux__)
    MPI_Comm node;
    int place = 0, count = 1;
    MPI_Comm_split_type(session_.comm(), MPI_COMM_TYPE_SHARED, 0, MPI_INFO_NULL, &node);
    MPI_Comm_rank(node, &place);
    MPI_Comm_size(node, &count);
    MPI_Comm_free(&node);
    cpu_set_t allowed, one;
    if (session_.options.pin && sched_getaffinity(0, sizeof allowed, &allowed) == 0 &&
        CPU_COUNT(&allowed) >= count) {
      int cpu = 0;
      for (int k = -1; cpu < CPU_SETSIZE; ++cpu)
        if (CPU_ISSET(cpu, &allowed) && ++k == place) break;
      CPU_ZERO(&one);
      CPU_SET(cpu, &one);
      pinned = sched_setaffinity(0, sizeof one, &one) == 0;
    }
#endif
    MPI_Allreduce(MPI_IN_PLACE, &pinned, 1, MPI_INT, MPI_MIN, session_.comm());
    return pinned != 0;
  }

  // All processes start an evaluation at the same instant of their common clock (on one node).
  Clock::time_point start_together() const {
    if (kProcesses == 1) return Clock::now();
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

  Session& session_;
  bool timed_ = false;
  Statistics in_place_, at_root_;
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
    status = on_.rank == 0 ? integrate() : serve();
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
    if (kProcess[static_cast<std::size_t>(on_.rank)].v_count == 0) return kDone;
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
      const int failed = stepper.step(
          asked().integrator->kind, next - time, q_, v_,
          [this](const auto& q, const auto& v, auto& a) { return accelerate(q, v, a); });
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

  int accelerate(const manifold::State& q, const manifold::State& v, manifold::State& a) {
    std::copy(q.begin(), q.end(), real_q_.begin());
    std::copy(v.begin(), v.end(), real_v_.begin());
    const int status =
        on_.solver.solve_at_root(real_q_.data(), real_v_.data(), on_.tau(0), real_a_.data());
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
  std::array<Real, kNq> real_q_{};
  std::array<Real, kNv> real_v_{}, real_a_{};
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
      for (std::size_t k = 0; k < kRefine; ++k) text += (k == 0 ? "" : ", ") + number(sizes_[s + k]);
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
    const std::string wrong =
        session_.solver.channel.open(MPI_COMM_WORLD, options.channel, options.time_limit);
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
      if (status == kDone) status = solve_all();
      if (status == kDone && session_.rank == 0) {
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
    if constexpr (kBatch) return solve_shares(on.solver);
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

  // As many states at once as there are lanes, each process its share.
  template <class S>
  int solve_shares(S& solver) {
    Session& on = session_;
    int failed = kFine;
    if constexpr (kBatch) {
      const int first = S::share(on.states.count, on.rank);
      const int count = S::share(on.states.count, on.rank + 1) - first;
      failed = solver.solve_batch(count, on.q(first), on.v(first), on.tau(first),
                                  on.acceleration(first));
    }
    if (failed != kFine)
      std::fprintf(stderr, "error: process %d: %s\n", on.rank, solver.text.c_str());
    MPI_Allreduce(MPI_IN_PLACE, &failed, 1, MPI_INT, MPI_MAX, on.comm());
    return failed == kFine ? bring_together() : kInputAtFault;
  }

  int bring_together() {
    Session& on = session_;
    solved_ = on.states.count;
    // Each process wrote its own joints and left the others zero.
    void* const all = on.qdd.data();
    const int size = static_cast<int>(on.qdd.size());
    if (on.rank == 0)
      MPI_Reduce(MPI_IN_PLACE, all, size, kMpiReal, MPI_SUM, 0, on.comm());
    else
      MPI_Reduce(all, nullptr, size, kMpiReal, MPI_SUM, 0, on.comm());
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
    int joint = near_lock(session_.solver.w, 0);
    MPI_Allreduce(MPI_IN_PLACE, &joint, 1, MPI_INT, MPI_MAX, session_.comm());
    if (joint == 0) return;
    warning_ = "joints " + names_of_run(joint - 1) +
               ": near gimbal lock at some state: accelerations lose three digits or more";
    if (session_.rank == 0) std::fprintf(stderr, "warning: %s\n", warning_.c_str());
  }

  // Shapes that join no runs of joints as one have nothing to tell.
  template <class W>
  static auto near_lock(const W& w, int) -> decltype(w.near_lock) {
    return w.near_lock;
  }
  template <class W>
  static int near_lock(const W&, long) {
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

int main(int count, char** words) {
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
