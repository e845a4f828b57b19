// Forward dynamics of "arm7" on 1 process, emitted by adagen 0.1.0 (solver.cpp.j2). Do not edit: emit anew.
//
// robot     "arm7", 9 joints, 9 degrees of freedom, description sha256 35a799ae72b600eeca178cc12eccff22927d06b6ca76bda0ede3ef5832ebda29
// command   adagen ../models/arm7.urdf --procs 1 --shape=joints
// options   form segment, shape joints, scalar double, channel auto, fixed base, gravity 0.0, 0.0, -9.81
// program   1 process; 0.324 us predicted (default profile)
//           process 0: base_yaw .. right_finger_slide
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
// To use it from a program of yours: compile this file with -DADAGEN_NO_MAIN and link it; arm7_p1.h
// beside it is this part.
// C interface of the solver arm7_p1: forward dynamics of "arm7" on 1 process,
// emitted by adagen 0.1.0 (interface.h.j2). Do not edit: emit anew.
#ifndef ADAGEN_ARM7_P1_H
#define ADAGEN_ARM7_P1_H

enum {
  ARM7_P1_PROCESSES = 1,
  ARM7_P1_JOINTS = 9,
  ARM7_P1_NQ = 9,  // numbers in q
  ARM7_P1_NV = 9,  // in v and qdd
  ARM7_P1_NTAU = 9  // in tau
};

// Where each joint begins in q, and in v, tau and qdd.
enum {
  ARM7_P1_Q_base_yaw = 0,
  ARM7_P1_V_base_yaw = 0,  // joint 0, "base_yaw": revolute, 1 in q, 1 in v
  ARM7_P1_Q_shoulder_pitch = 1,
  ARM7_P1_V_shoulder_pitch = 1,  // joint 1, "shoulder_pitch": revolute, 1 in q, 1 in v
  ARM7_P1_Q_upper_arm_roll = 2,
  ARM7_P1_V_upper_arm_roll = 2,  // joint 2, "upper_arm_roll": revolute, 1 in q, 1 in v
  ARM7_P1_Q_elbow_pitch = 3,
  ARM7_P1_V_elbow_pitch = 3,  // joint 3, "elbow_pitch": revolute, 1 in q, 1 in v
  ARM7_P1_Q_forearm_roll = 4,
  ARM7_P1_V_forearm_roll = 4,  // joint 4, "forearm_roll": revolute, 1 in q, 1 in v
  ARM7_P1_Q_wrist_pitch = 5,
  ARM7_P1_V_wrist_pitch = 5,  // joint 5, "wrist_pitch": revolute, 1 in q, 1 in v
  ARM7_P1_Q_flange_roll = 6,
  ARM7_P1_V_flange_roll = 6,  // joint 6, "flange_roll": revolute, 1 in q, 1 in v
  ARM7_P1_Q_left_finger_slide = 7,
  ARM7_P1_V_left_finger_slide = 7,  // joint 7, "left_finger_slide": prismatic, 1 in q, 1 in v
  ARM7_P1_Q_right_finger_slide = 8,
  ARM7_P1_V_right_finger_slide = 8  // joint 8, "right_finger_slide": prismatic, 1 in q, 1 in v
};

// Why a call failed, as arm7_p1_reason tells of the status that it returned.
enum {
  ARM7_P1_FINE = 0,  // none
  ARM7_P1_NOT_FINITE = 1,  // q, v or tau of a joint is not a finite number
  ARM7_P1_ZERO_QUATERNION = 2,  // a joint's quaternion cannot be normalised
  ARM7_P1_FACTORIZATION = 3,  // inertias beside a joint differ too much for the scalar
  ARM7_P1_OVERFLOW = 4,  // a joint's acceleration is not a finite number
  ARM7_P1_NO_ANSWER = 5,  // a process did not answer within the time limit
  ARM7_P1_ENDED = 6,  // process 0 has ended the evaluations
  ARM7_P1_NOT_REFINED = 7,  // refinement does not converge
  ARM7_P1_GIMBAL_LOCK = 8,  // joints that are joined as one do not move in as many directions
  ARM7_P1_GROWTH = 9,  // a link beside a joint is too light for its neighbours
  ARM7_P1_TOO_FEW_STEPS = 11  // refinement converges too slowly
};

#ifdef __cplusplus
extern "C" {
#endif
typedef struct arm7_p1_solver arm7_p1_solver;

// Joints in order, each with its place in the state: gives name, start and size in q and v of joint
// k, or returns 0 where there is none.
int arm7_p1_joint(int k, const char** name, int* q, int* nq, int* v, int* nv);

// A solver, with all the memory that it will ever need: no other call allocates, waits or takes a
// lock. One solver is for one thread at a time. Returns null where there is no memory;
// arm7_p1_failure(NULL) says so.
arm7_p1_solver* arm7_p1_open(void);

// One evaluation. q: 9 numbers, v and tau: 9 each, qdd: 9; joints in order, quaternions
// x y z w (normalised here), floating joints [linear; angular] in the body's frame.
// Returns 0, or a status that arm7_p1_failure puts into words; no acceleration is written then.
int arm7_p1_solve(arm7_p1_solver* solver, const double* q, const double* v, const double* tau, double* qdd);

// What a status says: its reason, and which joint it is about, -1 for none.
int arm7_p1_reason(int status);
int arm7_p1_failed_joint(int status);

// The last failure of a solver in words, valid until the next call; of null, why the last open of this
// thread returned null.
const char* arm7_p1_failure(const arm7_p1_solver* solver);

void arm7_p1_close(arm7_p1_solver* solver);
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

#include <Eigen/Core>
#include <Eigen/Geometry>
#include <Eigen/LU>

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

// Spatial inertias, and how they, wrenches and motions are told in another frame.

// A spatial inertia [[A, B], [B^T, C]]: A and C symmetric, their upper triangles row by row; B row
// by row. 21 numbers, and half the work of a 6x6 matrix.
struct Inertia {
  std::array<Real, 6> A, C;
  std::array<Real, 9> B;

  static constexpr int symmetric(int i, int k) {
    return i <= k ? i * (5 - i) / 2 + k : symmetric(k, i);
  }

  constexpr Real operator()(int i, int k) const {
    if (i < 3 && k < 3) return A[symmetric(i, k)];
    if (i >= 3 && k >= 3) return C[symmetric(i - 3, k - 3)];
    return i < 3 ? B[3 * i + k - 3] : B[3 * k + i - 3];
  }

  // Sets the entries (i, k) and (k, i), which are one.
  constexpr void set(int i, int k, Real value) {
    if (i < 3 && k < 3)
      A[symmetric(i, k)] = value;
    else if (i >= 3 && k >= 3)
      C[symmetric(i - 3, k - 3)] = value;
    else if (i < 3)
      B[3 * i + k - 3] = value;
    else
      B[3 * k + i - 3] = value;
  }

  Inertia& operator+=(const Inertia& other) {
    ADAGEN_FOR (k, 0, 6) A[k] += other.A[k], C[k] += other.C[k];
    ADAGEN_FOR (k, 0, 9) B[k] += other.B[k];
    return *this;
  }
};

// T^T m T for a symmetric m, T being E or, transposed, E^T; both row by row.
template <bool transposed>
std::array<Real, 6> rotated(const Mat3& E, const std::array<Real, 6>& m) {
  const auto T = [&E](int i, int k) { return transposed ? E(k, i) : E(i, k); };
  std::array<Real, 9> half;  // m T
  ADAGEN_FOR (i, 0, 3)
    ADAGEN_FOR (k, 0, 3)
      half[3 * i + k] = m[Inertia::symmetric(i, 0)] * T(0, k) +
                        m[Inertia::symmetric(i, 1)] * T(1, k) +
                        m[Inertia::symmetric(i, 2)] * T(2, k);
  std::array<Real, 6> result;
  ADAGEN_FOR (i, 0, 3)
    ADAGEN_FOR (k, i, 3)
      result[Inertia::symmetric(i, k)] =
          T(0, i) * half[k] + T(1, i) * half[3 + k] + T(2, i) * half[6 + k];
  return result;
}

template <bool transposed>
std::array<Real, 9> rotated(const Mat3& E, const std::array<Real, 9>& m) {
  const auto T = [&E](int i, int k) { return transposed ? E(k, i) : E(i, k); };
  std::array<Real, 9> half, result;
  ADAGEN_FOR (i, 0, 3)
    ADAGEN_FOR (k, 0, 3)
      half[3 * i + k] = m[3 * i] * T(0, k) + m[3 * i + 1] * T(1, k) + m[3 * i + 2] * T(2, k);
  ADAGEN_FOR (i, 0, 3)
    ADAGEN_FOR (k, 0, 3)
      result[3 * i + k] = T(0, i) * half[k] + T(1, i) * half[3 + k] + T(2, i) * half[6 + k];
  return result;
}

// The inertia m told at a point whose origin is at -r from the one it is told at:
// B + rx C, and A + rx (B + rx C)^T - B rx.
inline void shift(const Vec3& r, Inertia& m) {
  const auto& C = m.C;
  auto& A = m.A;
  const std::array<Real, 9> B = m.B;
  auto& S = m.B;
  const auto c = [&C](int i, int k) { return C[Inertia::symmetric(i, k)]; };
  ADAGEN_FOR (k, 0, 3) {
    S[k] += r[1] * c(2, k) - r[2] * c(1, k);
    S[3 + k] += r[2] * c(0, k) - r[0] * c(2, k);
    S[6 + k] += r[0] * c(1, k) - r[1] * c(0, k);
  }
  A[0] += r[1] * S[2] - r[2] * S[1] - (B[1] * r[2] - B[2] * r[1]);
  A[1] += r[1] * S[5] - r[2] * S[4] - (B[2] * r[0] - B[0] * r[2]);
  A[2] += r[1] * S[8] - r[2] * S[7] - (B[0] * r[1] - B[1] * r[0]);
  A[3] += r[2] * S[3] - r[0] * S[5] - (B[5] * r[0] - B[3] * r[2]);
  A[4] += r[2] * S[6] - r[0] * S[8] - (B[3] * r[1] - B[4] * r[0]);
  A[5] += r[0] * S[7] - r[1] * S[6] - (B[6] * r[1] - B[7] * r[0]);
}

// target += X^T m X: an inertia in the child's frame, felt in the parent's.
ADAGEN_NOINLINE void add_in_parent(const Transform& X, const Inertia& m, Inertia& target) {
  Inertia turned{rotated<false>(X.E, m.A), rotated<false>(X.E, m.C), rotated<false>(X.E, m.B)};
  shift(X.r, turned);
  target += turned;
}

// X^-T m X^-1: an inertia in the parent's frame, felt in the child's.
ADAGEN_NOINLINE Inertia in_child(const Transform& X, const Inertia& m) {
  Inertia moved = m;
  shift(-X.r, moved);
  return {rotated<true>(X.E, moved.A), rotated<true>(X.E, moved.C), rotated<true>(X.E, moved.B)};
}

// X^-T f: a wrench on the parent, felt in the child's frame.
[[maybe_unused]] Columns6 wrench_in_child(const Transform& X, const Columns6& f) {
  Columns6 result;
  ADAGEN_FOR (k, 0, kColumns) {
    const Vec3 moment = f.col(k).template head<3>(), force = f.col(k).template tail<3>();
    result.col(k).template head<3>() = X.E * (moment - X.r.cross(force));
    result.col(k).template tail<3>() = X.E * force;
  }
  return result;
}

// X^-1 m: motions in the child's frame, told in the parent's.
template <int columns>
Eigen::Matrix<Real, 6, columns> motion_in_parent(const Transform& X,
                                                 const Eigen::Matrix<Real, 6, columns>& m) {
  Eigen::Matrix<Real, 6, columns> result;
  ADAGEN_FOR (k, 0, columns) {
    const Vec3 angular = X.E.transpose() * m.col(k).template head<3>();
    result.col(k).template head<3>() = angular;
    result.col(k).template tail<3>() =
        X.E.transpose() * m.col(k).template tail<3>() + X.r.cross(angular);
  }
  return result;
}

// X^-1 m X^-T: a mobility in the child's frame, told in the parent's.
ADAGEN_NOINLINE Mat6 congruent_in_parent(const Transform& X, const Mat6& m) {
  const Mat6 half = motion_in_parent(X, m).transpose();
  return motion_in_parent(X, half);
}

// Spatial inertia of a link at its origin.
Inertia spatial_inertia(const LinkConstants& link) {
  const Real x = Real(link.com[0]), y = Real(link.com[1]), z = Real(link.com[2]);
  const Real m = Real(link.mass);
  std::array<Real, 9> t;
  std::transform(link.tensor, link.tensor + 9, t.begin(), [](Number value) { return Real(value); });
  return {{t[0] + m * (y * y + z * z), t[1] - m * x * y, t[2] - m * x * z,
           t[4] + m * (x * x + z * z), t[5] - m * y * z, t[8] + m * (x * x + y * y)},
          {m, 0, 0, m, 0, m},
          {0, -m * z, m * y, m * z, 0, -m * x, -m * y, m * x, 0}};
}

// Articulated bodies: what one process does alone between its cuts. A joint is treated in its own
// frame, the child link's. Seen from the segment's root, a_far = a_near + sigma (S qdd + c) and
// sigma tau = S^T f_far; sigma is -1 where the far link is the parent.

template <std::size_t n>
std::array<std::array<Real, kColumns>, n> negated(std::array<std::array<Real, kColumns>, n> x) {
  for (auto& row : x)
    for (Real& value : row) value = -value;
  return x;
}

// I^A and p^A of a link start as its own inertia and v x* I v.
ADAGEN_NOINLINE void start_link(const Inertia& inertia, const Vec6& velocity, Inertia& IA,
                                Columns6& pA) {
  IA = inertia;
  const auto& A = inertia.A;
  const Vec3 w = velocity.head<3>(), v = velocity.tail<3>();
  const Real mass = inertia.C[0];
  const Vec3 mc(inertia.B[7], inertia.B[2], inertia.B[3]);  // mass times centre of mass
  const Vec3 angular =
      Vec3(A[0] * w[0] + A[1] * w[1] + A[2] * w[2], A[1] * w[0] + A[3] * w[1] + A[4] * w[2],
           A[2] * w[0] + A[4] * w[1] + A[5] * w[2]) +
      mc.cross(v);
  const Vec3 linear = mass * v + w.cross(mc);
  if constexpr (kColumns > 1) pA.setZero();
  pA.col(0).template head<3>() = w.cross(angular) + v.cross(linear);
  pA.col(0).template tail<3>() = w.cross(linear);
}

template <class Kind>
struct Articulated {
  static constexpr int n = kFree<Kind>;
  std::array<std::array<Real, n>, n> D;         // for n = 1 the inverse of D = S^T I^A S, else its
                                                // Cholesky factor, the diagonal inverted
  std::array<std::array<Real, 6>, n> E;         // D^-1 S^T I^A at the constrained rows, else zero
  std::array<std::array<Real, kColumns>, n> u;  // sigma tau - S^T p^A
  std::array<std::array<Real, kColumns>, n> tau;
  Columns6 c;  // sigma c

  template <std::size_t k>
  void solve(std::array<std::array<Real, k>, n>& x) const {
    if constexpr (n == 1) {
      for (Real& value : x[0]) value *= D[0][0];
    } else {
      forward_substitute(D, x);
      backward_substitute(D, x);
    }
  }
};

// The joint's share of the articulated body with inertia I and bias p on its far side: what it
// hands on to its near side, by exact projection: nothing along S but the torque. Returns false
// where D cannot be factorized.
template <class Kind>
ADAGEN_NOINLINE bool articulate(Articulated<Kind>& i, Real sigma, const Inertia& I,
                                const Columns6& p, Inertia& handed, Columns6& force) {
  constexpr int n = kFree<Kind>, m = kConstrained<Kind>;
  constexpr auto& free = Kind::Free::row;
  [[maybe_unused]] constexpr auto& constrained = Kind::Constrained::row;
  bool good = true;
  ADAGEN_FOR (k, 0, n) {
    ADAGEN_FOR (l, 0, n) i.D[k][l] = I(free[k], free[l]);
    i.E[k] = {};
    ADAGEN_FOR (l, 0, m) i.E[k][constrained[l]] = I(free[k], constrained[l]);
    ADAGEN_FOR (c, 0, kColumns) i.u[k][c] = sigma * i.tau[k][c] - p(free[k], c);
  }
  if constexpr (n == 1) {
    // Beside the inertia about other axes (in other directions), D must be more than rounding.
    constexpr int row = free[0] < 3 ? 0 : 3;
    const Real whole = I(row, row) + I(row + 1, row + 1) + I(row + 2, row + 2);
    good = i.D[0][0] > 8 * std::numeric_limits<Real>::epsilon() * whole &&
           i.D[0][0] <= std::numeric_limits<Real>::max();
    i.D[0][0] = 1 / i.D[0][0];
  } else {
    good = factorize(i.D);
  }
  i.solve(i.E);
  auto moved = i.u;
  i.solve(moved);
  ADAGEN_FOR (k, 0, n)
    ADAGEN_FOR (l, 0, 6) handed.set(free[k], l, 0);
  if constexpr (m > 0) {
    ADAGEN_FOR (r, 0, m)
      ADAGEN_FOR (s, r, m) {
        Real x = I(constrained[r], constrained[s]);
        ADAGEN_FOR (k, 0, n) x -= I(constrained[r], free[k]) * i.E[k][constrained[s]];
        handed.set(constrained[r], constrained[s], x);
      }
    ADAGEN_FOR (c, 0, kColumns)
      ADAGEN_FOR (r, 0, m) {
        Real x = p(constrained[r], c);
        ADAGEN_FOR (k, 0, n) x += I(constrained[r], free[k]) * moved[k][c];
        ADAGEN_FOR (s, 0, m) x += handed(constrained[r], constrained[s]) * i.c(constrained[s], c);
        force(constrained[r], c) = x;
      }
  }
  ADAGEN_FOR (k, 0, n)
    ADAGEN_FOR (c, 0, kColumns) force(free[k], c) = sigma * i.tau[k][c];
  return good;
}

// a becomes the far link's acceleration (joint frame) from the near link's; returns sigma qdd.
template <class Kind>
std::array<std::array<Real, kColumns>, kFree<Kind>> accelerate(const Articulated<Kind>& i,
                                                               Columns6& a) {
  a += i.c;
  auto moved = i.u;
  i.solve(moved);
  ADAGEN_FOR (k, 0, (kFree<Kind>))
    ADAGEN_FOR (c, 0, kColumns) {
      const int row = Kind::Free::row[k];
      Real x = moved[k][c];
      for (int l : Kind::Constrained::row) x -= i.E[k][l] * a(l, c);
      moved[k][c] = x - a(row, c);
    }
  ADAGEN_FOR (k, 0, (kFree<Kind>))
    ADAGEN_FOR (c, 0, kColumns) a(Kind::Free::row[k], c) += moved[k][c];
  return moved;
}

// K m with K = 1 - S D^-1 S^T I^A, what of a motion of the near side the far side shares.
template <class Kind>
ADAGEN_NOINLINE void share(const Articulated<Kind>& i, Mat6& m) {
  ADAGEN_FOR (k, 0, (kFree<Kind>)) m.row(Kind::Free::row[k]).setZero();
  ADAGEN_FOR (k, 0, (kFree<Kind>))
    for (int l : Kind::Constrained::row) m.row(Kind::Free::row[k]) -= i.E[k][l] * m.row(l);
}

// Omega of the far side: K m K^T + S D^-1 S^T, m being the near side's (zero: the ground's).
template <class Kind>
ADAGEN_NOINLINE void carry(const Articulated<Kind>& i, Mat6& m) {
  constexpr int n = kFree<Kind>;
  share(i, m);
  m.transposeInPlace();
  share(i, m);
  std::array<std::array<Real, n>, n> inverse{};
  ADAGEN_FOR (k, 0, n) inverse[k][k] = 1;
  i.solve(inverse);
  ADAGEN_FOR (k, 0, n)
    ADAGEN_FOR (l, 0, n) m(Kind::Free::row[k], Kind::Free::row[l]) += inverse[k][l];
}

// A load on the far side (joint frame) moves the joint; what is left of it, K^T load, goes on.
template <class Kind>
void deliver(Articulated<Kind>& i, Columns6& load) {
  ADAGEN_FOR (k, 0, (kFree<Kind>))
    ADAGEN_FOR (c, 0, kColumns) {
      Real& along = load(Kind::Free::row[k], c);
      i.u[k][c] += along;
      for (int l : Kind::Constrained::row) load(l, c) -= i.E[k][l] * along;
      along = 0;
    }
}

// Phi = (I^A)^-1 and b = -Phi p^A, by Cholesky's factorization.
ADAGEN_NOINLINE bool invert(const Inertia& I, const Columns6& p, Mat6& Phi, Columns6& b) {
  std::array<std::array<Real, 6>, 6> L, x{};
  ADAGEN_FOR (i, 0, 6) {
    ADAGEN_FOR (k, 0, 6) L[i][k] = I(i, k);
    x[i][i] = 1;
  }
  const bool good = factorize(L);
  forward_substitute(L, x);
  ADAGEN_FOR (i, 0, 6)
    ADAGEN_FOR (k, i, 6) {
      Real sum = 0;
      ADAGEN_FOR (row, 0, 6) sum += x[row][i] * x[row][k];
      Phi(i, k) = Phi(k, i) = sum;
    }
  b.noalias() = -Phi * p;
  return good;
}

// a with I^A a = -p^A: nothing else acts on the link.
ADAGEN_NOINLINE bool solve_root(const Inertia& I, const Columns6& p, Columns6& a) {
  std::array<std::array<Real, 6>, 6> L;
  std::array<std::array<Real, kColumns>, 6> x;
  ADAGEN_FOR (i, 0, 6) {
    ADAGEN_FOR (k, 0, 6) L[i][k] = I(i, k);
    ADAGEN_FOR (c, 0, kColumns) x[i][c] = -p(i, c);
  }
  const bool good = factorize(L);
  forward_substitute(L, x);
  backward_substitute(L, x);
  ADAGEN_FOR (i, 0, 6)
    ADAGEN_FOR (c, 0, kColumns) a(i, c) = x[i][c];
  return good;
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

// The memory of a process. Whatever belongs to a joint is kept with it.
struct Workspace;

struct Joint_base_yaw {
  Transform X;  // parent link's to child link's frame
  Vec6 v;  // velocity of link "turret"
  Inertia IA;  // articulated-body inertia of link "turret"
  Columns6 pA;  // and its bias force
  Columns6 a;  // acceleration of the link, relative to free fall
  Articulated<Revolute> body;
};

struct Joint_shoulder_pitch {
  Transform X;  // parent link's to child link's frame
  Vec6 v;  // velocity of link "upper_arm"
  Inertia IA;  // articulated-body inertia of link "upper_arm"
  Columns6 pA;  // and its bias force
  Columns6 a;  // acceleration of the link, relative to free fall
  Articulated<Revolute> body;
};

struct Joint_upper_arm_roll {
  Transform X;  // parent link's to child link's frame
  Vec6 v;  // velocity of link "elbow_housing"
  Inertia IA;  // articulated-body inertia of link "elbow_housing"
  Columns6 pA;  // and its bias force
  Columns6 a;  // acceleration of the link, relative to free fall
  Articulated<Revolute> body;
};

struct Joint_elbow_pitch {
  Transform X;  // parent link's to child link's frame
  Vec6 v;  // velocity of link "forearm"
  Inertia IA;  // articulated-body inertia of link "forearm"
  Columns6 pA;  // and its bias force
  Columns6 a;  // acceleration of the link, relative to free fall
  Articulated<Revolute> body;
};

struct Joint_forearm_roll {
  Transform X;  // parent link's to child link's frame
  Vec6 v;  // velocity of link "wrist_housing"
  Inertia IA;  // articulated-body inertia of link "wrist_housing"
  Columns6 pA;  // and its bias force
  Columns6 a;  // acceleration of the link, relative to free fall
  Articulated<Revolute> body;
};

struct Joint_wrist_pitch {
  Transform X;  // parent link's to child link's frame
  Vec6 v;  // velocity of link "wrist"
  Inertia IA;  // articulated-body inertia of link "wrist"
  Columns6 pA;  // and its bias force
  Columns6 a;  // acceleration of the link, relative to free fall
  Articulated<Revolute> body;
};

struct Joint_flange_roll {
  Transform X;  // parent link's to child link's frame
  Vec6 v;  // velocity of link "hand"
  Inertia IA;  // articulated-body inertia of link "hand"
  Columns6 pA;  // and its bias force
  Columns6 a;  // acceleration of the link, relative to free fall
  Articulated<Revolute> body;
};

struct Joint_left_finger_slide {
  Transform X;  // parent link's to child link's frame
  Vec6 v;  // velocity of link "left_finger"
  Inertia IA;  // articulated-body inertia of link "left_finger"
  Columns6 pA;  // and its bias force
  Columns6 a;  // acceleration of the link, relative to free fall
  Articulated<Prismatic> body;
};

struct Joint_right_finger_slide {
  Transform X;  // parent link's to child link's frame
  Vec6 v;  // velocity of link "right_finger"
  Inertia IA;  // articulated-body inertia of link "right_finger"
  Columns6 pA;  // and its bias force
  Columns6 a;  // acceleration of the link, relative to free fall
  Articulated<Prismatic> body;
};

struct Workspace {
  const Number* q = nullptr;
  const Number* v = nullptr;
  const Number* tau = nullptr;
  Number* qdd = nullptr;
  int status = kFine;
  int near_lock = 0;  // 1 + the last joint of a run that has been near gimbal lock; 0: none
  Joint_base_yaw j_base_yaw;
  Joint_shoulder_pitch j_shoulder_pitch;
  Joint_upper_arm_roll j_upper_arm_roll;
  Joint_elbow_pitch j_elbow_pitch;
  Joint_forearm_roll j_forearm_roll;
  Joint_wrist_pitch j_wrist_pitch;
  Joint_flange_roll j_flange_roll;
  Joint_left_finger_slide j_left_finger_slide;
  Joint_right_finger_slide j_right_finger_slide;

  EIGEN_MAKE_ALIGNED_OPERATOR_NEW
};

inline void fail(Workspace& w, Failure kind, int joint) {
  Channel::fail(w.status, failure(kind, joint));
}

// x - x is zero for finite x only.
inline void require_finite(Workspace& w, const Number* x, int count, int joint) {
  Number sum = 0;
  for (int k = 0; k < count; ++k) sum += x[k] - x[k];
  if (!(sum == 0)) fail(w, kNotFinite, joint);
}

[[maybe_unused]] inline void require_length(Workspace& w, Real squared, int joint) {
  if (!(squared >= std::numeric_limits<Real>::min() && squared <= std::numeric_limits<Real>::max()))
    fail(w, kZeroQuaternion, joint);
}

template <std::size_t n>
void load_torque(Workspace& w, int joint, int v, std::array<std::array<Real, kColumns>, n>& tau) {
  require_finite(w, w.tau + v, static_cast<int>(n), joint);
  for (std::size_t k = 0; k < n; ++k) {
    tau[k] = {};
    tau[k][0] = Real(w.tau[v + static_cast<int>(k)]);
  }
}

// An acceleration is given only where all went well.
template <std::size_t n>
void store_acceleration(Workspace& w, int joint, int v,
                        const std::array<std::array<Real, kColumns>, n>& qdd) {
  Real sum = 0;
  for (std::size_t k = 0; k < n; ++k) sum += qdd[k][0] - qdd[k][0];
  if (!(sum == 0)) fail(w, kOverflow, joint);
  if (w.status != kFine) return;
  for (std::size_t k = 0; k < n; ++k) w.qdd[v + static_cast<int>(k)] = qdd[k][0];
}

const Mat6 kZero = Mat6::Zero();

// The ground accelerates against gravity: all accelerations are relative to free fall.
const Columns6 kGround = [] {
  Columns6 result = Columns6::Zero();
  for (int k = 0; k < 3; ++k) result(3 + k, 0) = -Real(kGravity[static_cast<std::size_t>(k)]);
  return result;
}();

// Accelerations of all right-hand sides, added up with the coupling torques.
template <std::size_t n, std::size_t m>
void store_coupled(Workspace& w, int joint, int v,
                   const std::array<std::array<Real, kColumns>, n>& qdd,
                   const std::array<Real, m>& torques) {
  std::array<std::array<Real, kColumns>, n> sum{};
  for (std::size_t k = 0; k < n; ++k) {
    sum[k][0] = qdd[k][0];
    for (std::size_t c = 0; c < m; ++c) sum[k][0] += qdd[k][c + 1] * torques[c];
  }
  store_acceleration(w, joint, v, sum);
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

const Inertia kInertia_turret = spatial_inertia(kLinks[1]);
const Inertia kInertia_upper_arm = spatial_inertia(kLinks[2]);
const Inertia kInertia_elbow_housing = spatial_inertia(kLinks[3]);
const Inertia kInertia_forearm = spatial_inertia(kLinks[4]);
const Inertia kInertia_wrist_housing = spatial_inertia(kLinks[5]);
const Inertia kInertia_wrist = spatial_inertia(kLinks[6]);
const Inertia kInertia_hand = spatial_inertia(kLinks[7]);
const Inertia kInertia_left_finger = spatial_inertia(kLinks[8]);
const Inertia kInertia_right_finger = spatial_inertia(kLinks[9]);

// =================================================================================================
// Joint 0 "base_yaw": revolute, between links "pedestal" and "turret"
// =================================================================================================

void kinematics_base_yaw(Workspace& w) {
  auto& i = w.j_base_yaw;
  require_finite(w, w.q + 0, 1, 0);
  require_finite(w, w.v + 0, 1, 0);
  const Real q = Real(w.q[0]);
  const Real c = std::cos(q), s = std::sin(q);
  i.X.E << c, s, 0.0,  //
      -s, c, 0.0,  //
      0.0, 0.0, 1.0;
  i.X.r << 0.0, 0.0, 0.16;
  i.v = joint_velocity<Revolute>(w.v + 0);
}

void articulate_base_yaw(Workspace& w) {
  auto& i = w.j_base_yaw;
  load_torque(w, 0, 0, i.body.tau);
  i.body.c = Columns6::Zero();
  Inertia handed;
  Columns6 force;
  if (!articulate(i.body, 1, i.IA, i.pA, handed, force))
    fail(w, kFactorization, 0);
}

void accelerate_base_yaw(Workspace& w) {
  auto& i = w.j_base_yaw;
  Columns6 a = i.X * kGround;
  const auto qdd = accelerate(i.body, a);
  i.a = a;
  store_acceleration(w, 0, 0, qdd);
}

// =================================================================================================
// Joint 1 "shoulder_pitch": revolute, between links "turret" and "upper_arm"
// =================================================================================================

void kinematics_shoulder_pitch(Workspace& w) {
  auto& i = w.j_shoulder_pitch;
  require_finite(w, w.q + 1, 1, 1);
  require_finite(w, w.v + 1, 1, 1);
  const Real q = Real(w.q[1]);
  const Real c = std::cos(q), s = std::sin(q);
  i.X.E << c, -3.673205103346574e-06 * s, -0.9999999999932537 * s,  //
      -s, -3.673205103346574e-06 * c, -0.9999999999932537 * c,  //
      0.0, 0.9999999999932537, -3.673205103346574e-06;
  i.X.r << 0.0, 0.0, 0.18;
  i.v = i.X * w.j_base_yaw.v + joint_velocity<Revolute>(w.v + 1);
}

void articulate_shoulder_pitch(Workspace& w) {
  auto& i = w.j_shoulder_pitch;
  load_torque(w, 1, 1, i.body.tau);
  i.body.c = velocity_product<Revolute>(i.v, w.v + 1);
  Inertia handed;
  Columns6 force;
  if (!articulate(i.body, 1, i.IA, i.pA, handed, force))
    fail(w, kFactorization, 1);
  add_in_parent(i.X, handed, w.j_base_yaw.IA);
  w.j_base_yaw.pA += i.X.transposed_times(force);
}

void accelerate_shoulder_pitch(Workspace& w) {
  auto& i = w.j_shoulder_pitch;
  Columns6 a = i.X * w.j_base_yaw.a;
  const auto qdd = accelerate(i.body, a);
  i.a = a;
  store_acceleration(w, 1, 1, qdd);
}

// =================================================================================================
// Joint 2 "upper_arm_roll": revolute, between links "upper_arm" and "elbow_housing"
// =================================================================================================

void kinematics_upper_arm_roll(Workspace& w) {
  auto& i = w.j_upper_arm_roll;
  require_finite(w, w.q + 2, 1, 2);
  require_finite(w, w.v + 2, 1, 2);
  const Real q = Real(w.q[2]);
  const Real c = std::cos(q), s = std::sin(q);
  i.X.E << c, -3.673205103346574e-06 * s, 0.9999999999932537 * s,  //
      -s, -3.673205103346574e-06 * c, 0.9999999999932537 * c,  //
      0.0, -0.9999999999932537, -3.673205103346574e-06;
  i.X.r << 0.0, -0.3, 0.0;
  i.v = i.X * w.j_shoulder_pitch.v + joint_velocity<Revolute>(w.v + 2);
}

void articulate_upper_arm_roll(Workspace& w) {
  auto& i = w.j_upper_arm_roll;
  load_torque(w, 2, 2, i.body.tau);
  i.body.c = velocity_product<Revolute>(i.v, w.v + 2);
  Inertia handed;
  Columns6 force;
  if (!articulate(i.body, 1, i.IA, i.pA, handed, force))
    fail(w, kFactorization, 2);
  add_in_parent(i.X, handed, w.j_shoulder_pitch.IA);
  w.j_shoulder_pitch.pA += i.X.transposed_times(force);
}

void accelerate_upper_arm_roll(Workspace& w) {
  auto& i = w.j_upper_arm_roll;
  Columns6 a = i.X * w.j_shoulder_pitch.a;
  const auto qdd = accelerate(i.body, a);
  i.a = a;
  store_acceleration(w, 2, 2, qdd);
}

// =================================================================================================
// Joint 3 "elbow_pitch": revolute, between links "elbow_housing" and "forearm"
// =================================================================================================

void kinematics_elbow_pitch(Workspace& w) {
  auto& i = w.j_elbow_pitch;
  require_finite(w, w.q + 3, 1, 3);
  require_finite(w, w.v + 3, 1, 3);
  const Real q = Real(w.q[3]);
  const Real c = std::cos(q), s = std::sin(q);
  i.X.E << c, -3.673205103346574e-06 * s, 0.9999999999932537 * s,  //
      -s, -3.673205103346574e-06 * c, 0.9999999999932537 * c,  //
      0.0, -0.9999999999932537, -3.673205103346574e-06;
  i.X.r << 0.08, 0.0, 0.0;
  i.v = i.X * w.j_upper_arm_roll.v + joint_velocity<Revolute>(w.v + 3);
}

void articulate_elbow_pitch(Workspace& w) {
  auto& i = w.j_elbow_pitch;
  load_torque(w, 3, 3, i.body.tau);
  i.body.c = velocity_product<Revolute>(i.v, w.v + 3);
  Inertia handed;
  Columns6 force;
  if (!articulate(i.body, 1, i.IA, i.pA, handed, force))
    fail(w, kFactorization, 3);
  add_in_parent(i.X, handed, w.j_upper_arm_roll.IA);
  w.j_upper_arm_roll.pA += i.X.transposed_times(force);
}

void accelerate_elbow_pitch(Workspace& w) {
  auto& i = w.j_elbow_pitch;
  Columns6 a = i.X * w.j_upper_arm_roll.a;
  const auto qdd = accelerate(i.body, a);
  i.a = a;
  store_acceleration(w, 3, 3, qdd);
}

// =================================================================================================
// Joint 4 "forearm_roll": revolute, between links "forearm" and "wrist_housing"
// =================================================================================================

void kinematics_forearm_roll(Workspace& w) {
  auto& i = w.j_forearm_roll;
  require_finite(w, w.q + 4, 1, 4);
  require_finite(w, w.v + 4, 1, 4);
  const Real q = Real(w.q[4]);
  const Real c = std::cos(q), s = std::sin(q);
  i.X.E << c, -3.673205103346574e-06 * s, -0.9999999999932537 * s,  //
      -s, -3.673205103346574e-06 * c, -0.9999999999932537 * c,  //
      0.0, 0.9999999999932537, -3.673205103346574e-06;
  i.X.r << -0.08, 0.38, 0.0;
  i.v = i.X * w.j_elbow_pitch.v + joint_velocity<Revolute>(w.v + 4);
}

void articulate_forearm_roll(Workspace& w) {
  auto& i = w.j_forearm_roll;
  load_torque(w, 4, 4, i.body.tau);
  i.body.c = velocity_product<Revolute>(i.v, w.v + 4);
  Inertia handed;
  Columns6 force;
  if (!articulate(i.body, 1, i.IA, i.pA, handed, force))
    fail(w, kFactorization, 4);
  add_in_parent(i.X, handed, w.j_elbow_pitch.IA);
  w.j_elbow_pitch.pA += i.X.transposed_times(force);
}

void accelerate_forearm_roll(Workspace& w) {
  auto& i = w.j_forearm_roll;
  Columns6 a = i.X * w.j_elbow_pitch.a;
  const auto qdd = accelerate(i.body, a);
  i.a = a;
  store_acceleration(w, 4, 4, qdd);
}

// =================================================================================================
// Joint 5 "wrist_pitch": revolute, between links "wrist_housing" and "wrist"
// =================================================================================================

void kinematics_wrist_pitch(Workspace& w) {
  auto& i = w.j_wrist_pitch;
  require_finite(w, w.q + 5, 1, 5);
  require_finite(w, w.v + 5, 1, 5);
  const Real q = Real(w.q[5]);
  const Real c = std::cos(q), s = std::sin(q);
  i.X.E << c, -3.673205103346574e-06 * s, 0.9999999999932537 * s,  //
      -s, -3.673205103346574e-06 * c, 0.9999999999932537 * c,  //
      0.0, -0.9999999999932537, -3.673205103346574e-06;
  i.X.r << 0.0, 0.0, 0.0;
  i.v = i.X * w.j_forearm_roll.v + joint_velocity<Revolute>(w.v + 5);
}

void articulate_wrist_pitch(Workspace& w) {
  auto& i = w.j_wrist_pitch;
  load_torque(w, 5, 5, i.body.tau);
  i.body.c = velocity_product<Revolute>(i.v, w.v + 5);
  Inertia handed;
  Columns6 force;
  if (!articulate(i.body, 1, i.IA, i.pA, handed, force))
    fail(w, kFactorization, 5);
  add_in_parent(i.X, handed, w.j_forearm_roll.IA);
  w.j_forearm_roll.pA += i.X.transposed_times(force);
}

void accelerate_wrist_pitch(Workspace& w) {
  auto& i = w.j_wrist_pitch;
  Columns6 a = i.X * w.j_forearm_roll.a;
  const auto qdd = accelerate(i.body, a);
  i.a = a;
  store_acceleration(w, 5, 5, qdd);
}

// =================================================================================================
// Joint 6 "flange_roll": revolute, between links "wrist" and "hand"
// =================================================================================================

void kinematics_flange_roll(Workspace& w) {
  auto& i = w.j_flange_roll;
  require_finite(w, w.q + 6, 1, 6);
  require_finite(w, w.v + 6, 1, 6);
  const Real q = Real(w.q[6]);
  const Real c = std::cos(q), s = std::sin(q);
  i.X.E << c, -3.673205103346574e-06 * s, 0.9999999999932537 * s,  //
      -s, -3.673205103346574e-06 * c, 0.9999999999932537 * c,  //
      0.0, -0.9999999999932537, -3.673205103346574e-06;
  i.X.r << 0.09, 0.0, 0.0;
  i.v = i.X * w.j_wrist_pitch.v + joint_velocity<Revolute>(w.v + 6);
}

void articulate_flange_roll(Workspace& w) {
  auto& i = w.j_flange_roll;
  load_torque(w, 6, 6, i.body.tau);
  i.body.c = velocity_product<Revolute>(i.v, w.v + 6);
  Inertia handed;
  Columns6 force;
  if (!articulate(i.body, 1, i.IA, i.pA, handed, force))
    fail(w, kFactorization, 6);
  add_in_parent(i.X, handed, w.j_wrist_pitch.IA);
  w.j_wrist_pitch.pA += i.X.transposed_times(force);
}

void accelerate_flange_roll(Workspace& w) {
  auto& i = w.j_flange_roll;
  Columns6 a = i.X * w.j_wrist_pitch.a;
  const auto qdd = accelerate(i.body, a);
  i.a = a;
  store_acceleration(w, 6, 6, qdd);
}

// =================================================================================================
// Joint 7 "left_finger_slide": prismatic, between links "hand" and "left_finger"
// =================================================================================================

void kinematics_left_finger_slide(Workspace& w) {
  auto& i = w.j_left_finger_slide;
  require_finite(w, w.q + 7, 1, 7);
  require_finite(w, w.v + 7, 1, 7);
  const Real q = Real(w.q[7]);
  i.X.E << 0.0, 0.0, 1.0,  //
      1.0, 0.0, 0.0,  //
      0.0, 1.0, 0.0;
  i.X.r << 0.0, q, 0.13;
  i.v = i.X * w.j_flange_roll.v + joint_velocity<Prismatic>(w.v + 7);
}

void articulate_left_finger_slide(Workspace& w) {
  auto& i = w.j_left_finger_slide;
  load_torque(w, 7, 7, i.body.tau);
  i.body.c = velocity_product<Prismatic>(i.v, w.v + 7);
  Inertia handed;
  Columns6 force;
  if (!articulate(i.body, 1, i.IA, i.pA, handed, force))
    fail(w, kFactorization, 7);
  add_in_parent(i.X, handed, w.j_flange_roll.IA);
  w.j_flange_roll.pA += i.X.transposed_times(force);
}

void accelerate_left_finger_slide(Workspace& w) {
  auto& i = w.j_left_finger_slide;
  Columns6 a = i.X * w.j_flange_roll.a;
  const auto qdd = accelerate(i.body, a);
  i.a = a;
  store_acceleration(w, 7, 7, qdd);
}

// =================================================================================================
// Joint 8 "right_finger_slide": prismatic, between links "hand" and "right_finger"
// =================================================================================================

void kinematics_right_finger_slide(Workspace& w) {
  auto& i = w.j_right_finger_slide;
  require_finite(w, w.q + 8, 1, 8);
  require_finite(w, w.v + 8, 1, 8);
  const Real q = Real(w.q[8]);
  i.X.E << 0.0, 0.0, 1.0,  //
      -0.9999999999964793, 2.65358979335273e-06, 0.0,  //
      -2.65358979335273e-06, -0.9999999999964793, 0.0;
  i.X.r << -2.65358979335273e-06 * q, -0.9999999999964793 * q, 0.13;
  i.v = i.X * w.j_flange_roll.v + joint_velocity<Prismatic>(w.v + 8);
}

void articulate_right_finger_slide(Workspace& w) {
  auto& i = w.j_right_finger_slide;
  load_torque(w, 8, 8, i.body.tau);
  i.body.c = velocity_product<Prismatic>(i.v, w.v + 8);
  Inertia handed;
  Columns6 force;
  if (!articulate(i.body, 1, i.IA, i.pA, handed, force))
    fail(w, kFactorization, 8);
  add_in_parent(i.X, handed, w.j_flange_roll.IA);
  w.j_flange_roll.pA += i.X.transposed_times(force);
}

void accelerate_right_finger_slide(Workspace& w) {
  auto& i = w.j_right_finger_slide;
  Columns6 a = i.X * w.j_flange_roll.a;
  const auto qdd = accelerate(i.body, a);
  i.a = a;
  store_acceleration(w, 8, 8, qdd);
}


// ---- 5. processes -------------------------------------------------------------------------------

// Process 0: 9 of 9 joints: "base_yaw", "shoulder_pitch", "upper_arm_roll", "elbow_pitch", "forearm_roll", "wrist_pitch", ...
void run_0([[maybe_unused]] Workspace& w, [[maybe_unused]] Channel& channel) {
  stamp(0);
  kinematics_base_yaw(w);
  kinematics_shoulder_pitch(w);
  kinematics_upper_arm_roll(w);
  kinematics_elbow_pitch(w);
  kinematics_forearm_roll(w);
  kinematics_wrist_pitch(w);
  kinematics_flange_roll(w);
  kinematics_left_finger_slide(w);
  kinematics_right_finger_slide(w);
  stamp(1);
  start_link(kInertia_turret, w.j_base_yaw.v, w.j_base_yaw.IA, w.j_base_yaw.pA);
  start_link(kInertia_upper_arm, w.j_shoulder_pitch.v, w.j_shoulder_pitch.IA, w.j_shoulder_pitch.pA);
  start_link(kInertia_elbow_housing, w.j_upper_arm_roll.v, w.j_upper_arm_roll.IA, w.j_upper_arm_roll.pA);
  start_link(kInertia_forearm, w.j_elbow_pitch.v, w.j_elbow_pitch.IA, w.j_elbow_pitch.pA);
  start_link(kInertia_wrist_housing, w.j_forearm_roll.v, w.j_forearm_roll.IA, w.j_forearm_roll.pA);
  start_link(kInertia_wrist, w.j_wrist_pitch.v, w.j_wrist_pitch.IA, w.j_wrist_pitch.pA);
  start_link(kInertia_hand, w.j_flange_roll.v, w.j_flange_roll.IA, w.j_flange_roll.pA);
  start_link(kInertia_left_finger, w.j_left_finger_slide.v, w.j_left_finger_slide.IA, w.j_left_finger_slide.pA);
  start_link(kInertia_right_finger, w.j_right_finger_slide.v, w.j_right_finger_slide.IA, w.j_right_finger_slide.pA);
  articulate_right_finger_slide(w);
  articulate_left_finger_slide(w);
  articulate_flange_roll(w);
  articulate_wrist_pitch(w);
  articulate_forearm_roll(w);
  articulate_elbow_pitch(w);
  articulate_upper_arm_roll(w);
  articulate_shoulder_pitch(w);
  articulate_base_yaw(w);
  stamp(2);
  accelerate_base_yaw(w);
  accelerate_shoulder_pitch(w);
  accelerate_upper_arm_roll(w);
  accelerate_elbow_pitch(w);
  accelerate_forearm_roll(w);
  accelerate_wrist_pitch(w);
  accelerate_flange_roll(w);
  accelerate_left_finger_slide(w);
  accelerate_right_finger_slide(w);
  stamp(3);
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

static_assert(ARM7_P1_NQ == kNq && ARM7_P1_NV == kNv && ARM7_P1_NTAU == kNtau);
static_assert(int(ARM7_P1_FINE) == int(kFine));
static_assert(int(ARM7_P1_NOT_FINITE) == int(kNotFinite));
static_assert(int(ARM7_P1_ZERO_QUATERNION) == int(kZeroQuaternion));
static_assert(int(ARM7_P1_FACTORIZATION) == int(kFactorization));
static_assert(int(ARM7_P1_OVERFLOW) == int(kOverflow));
static_assert(int(ARM7_P1_NO_ANSWER) == int(kNoAnswer));
static_assert(int(ARM7_P1_ENDED) == int(kEnded));
static_assert(int(ARM7_P1_NOT_REFINED) == int(kNotRefined));
static_assert(int(ARM7_P1_GIMBAL_LOCK) == int(kGimbalLock));
static_assert(int(ARM7_P1_GROWTH) == int(kGrowth));
static_assert(int(ARM7_P1_TOO_FEW_STEPS) == int(kTooFewSteps));

struct arm7_p1_solver : Solver {};

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

int arm7_p1_joint(int k, const char** name, int* q, int* nq, int* v, int* nv) {
  if (k < 0 || k >= kJointCount) return 0;
  const JointConstants& joint = kJoints[k];
  *name = joint.name, *q = joint.q, *nq = joint.nq, *v = joint.v, *nv = joint.nv;
  return 1;
}

arm7_p1_solver* arm7_p1_open(void) { return opened<arm7_p1_solver>(); }

int arm7_p1_solve(arm7_p1_solver* solver, const double* q, const double* v, const double* tau, double* qdd) {
  return solver->solve(q, v, tau, qdd);
}

int arm7_p1_reason(int status) { return failure_kind(status); }

int arm7_p1_failed_joint(int status) { return is_of_joint(failure_kind(status)) ? failure_place(status) : -1; }

const char* arm7_p1_failure(const arm7_p1_solver* solver) {
  return solver == nullptr ? open_failure.c_str() : solver->text.c_str();
}

void arm7_p1_close(arm7_p1_solver* solver) {
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
