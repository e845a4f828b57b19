// Forward dynamics of "arm7" on 1 process, emitted by adagen 0.1.0 (solver.cpp.j2). Do not edit: emit anew.
//
// robot     "arm7", 9 joints, 9 degrees of freedom, description sha256 35a799ae72b600eeca178cc12eccff22927d06b6ca76bda0ede3ef5832ebda29
// command   adagen ../models/arm7.urdf --procs 1 --shape=joints
// options   form segment, shape joints, scalar double, channel auto, fixed base, gravity 0.0, 0.0, -9.81
// links     adagen_program.cpp
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
//   6. program     what the program around it, adagen_program.cpp, is told; main

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
  ARM7_P1_NOT_SET = 16,  // what is to be set at run time is not finite, or is no mass
  ARM7_P1_TOO_FEW_STEPS = 11,  // refinement converges too slowly
  ARM7_P1_LOOP_OPEN = 12,  // a loop or coupling is not closed in this configuration
  ARM7_P1_LOOP_TORN = 13,  // this velocity tears a loop or coupling open
  ARM7_P1_LOOP_SINGULAR = 14,  // what a loop holds changes in this pose
  ARM7_P1_LOOP_FREE = 15  // loops leave a joint a motion that no inertia resists
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
constexpr int kNqdd = 9;
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
  Columns6 ground;  // its acceleration
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

inline double gravity(const Workspace&, int k) { return kGravity[static_cast<std::size_t>(k)]; }

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
[[maybe_unused]] inline Columns6 ground(const Workspace& w) {
  Columns6 result = Columns6::Zero();
  for (int k = 0; k < 3; ++k) result(3 + k, 0) = -Real(gravity(w, k));
  return result;
}

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
  Columns6 a = i.X * w.ground;
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
  w.ground = ground(w);
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
static_assert(int(ARM7_P1_NOT_SET) == int(kNotSet));
static_assert(int(ARM7_P1_TOO_FEW_STEPS) == int(kTooFewSteps));
static_assert(int(ARM7_P1_LOOP_OPEN) == int(kLoopOpen));
static_assert(int(ARM7_P1_LOOP_TORN) == int(kLoopTorn));
static_assert(int(ARM7_P1_LOOP_SINGULAR) == int(kLoopSingular));
static_assert(int(ARM7_P1_LOOP_FREE) == int(kLoopFree));

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
    {"kinematics", 8, -1},
    {"assembly", 0, -1},
    {"disassembly", 0, -1},
} };
constexpr std::array<adagen::Table<adagen::Stage>, kProcesses> kStages{ {
    {kStages_0.data(), 3},
} };

// As the cost profile default has them.
constexpr adagen::Hop kWindowHop{0, 159, 0.437};
constexpr adagen::Hop kMessageHop{26, 228, 0.644};

}  // namespace

// Compiled for size: it runs once.
[[gnu::cold]] int main(int count, char** words) {
  const adagen::Description<Number> description{
      "arm7", "auto", kProcesses, 1, kNq, kNv, kNtau, kNqdd, kRefine,
      false, kAlone, kBatch, false, kTolerance, kGravity.data(),
      table(kJoints), table(kLinks), table(kOuterForces), {}, {}, table(kMessages), kStages.data(), kWindowHop,
      kMessageHop};
  auto* const solver = new ThisSolver;
  const int status = adagen::program(description, *solver, count, words);
  delete solver;
  return status;
}
#endif  // ADAGEN_NO_MAIN
