// Forward dynamics of "arm7" on 2 processes, emitted by adagen 0.1.0 (solver.cpp.j2). Do not edit: generate again.
//
// robot     "arm7", 9 joints, 9 degrees of freedom, description sha256 35a799ae72b600eeca178cc12eccff22927d06b6ca76bda0ede3ef5832ebda29
// command   adagen ../models/arm7.urdf --procs 2 --schedule=balanced --shape=kernels --scalar=float --name=arm7_float
// options   form segment, shape kernels, scalar float, channel auto, fixed base, gravity 0.0, 0.0, -9.81
// links     adagen_program.cpp -DADAGEN_MPI -DADAGEN_FLOAT
// program   2 processes, joined at cuts; 0.953 us predicted (default profile)
//           process 0: base_yaw .. forearm_roll
//           process 1: wrist_pitch .. right_finger_slide
// schedule  forearm_roll@0-1(shoulder_pitch@0(base_yaw | upper_arm_roll(|elbow_pitch)) | flange_roll@1(wrist_pitch | left_finger_slide(right_finger_slide|)))
// licence   yours to choose: generated code belongs to its user
//
// Each process solves a segment of the robot with the articulated-body algorithm: the articulated-body
// inertias I^A and bias forces p^A (IA, pA) are computed from the ends to the segment's root, then the
// accelerations from there outwards. Where segments meet, the assembly-disassembly algorithm of Yamane
// and Nakamura joins them: Phi = (I^A)^-1 and b are a segment's inverse inertia and bias acceleration at
// a cut; joint i joins chain A (on its parent link's side) and chain B (on its child link's side), Eq.
// (3)-(7), and its force follows from Eq. (8)-(10). Spatial vectors are [angular; linear], in the axes of
// the base, about each link's origin.
//
// Contents:
//   1. interface   the C functions for a program that links this file
//   2. model       the robot's constants
//   3. runtime     spatial algebra, joints, exchange between processes
//   4. joints      memory of each joint, and the functions that compute its steps
//   5. processes   the work of each process, in order
//   6. program     description for the program around it (adagen_program.cpp), and main

// ---- 1. interface -------------------------------------------------------------------------------
// To call it from your program, compile this file with -DADAGEN_NO_MAIN and link it. This part is also in
// arm7_float_p2.h.
// C interface of the solver arm7_float_p2: forward dynamics of "arm7" on 2 processes,
// emitted by adagen 0.1.0 (interface.h.j2). Do not edit: generate again.
#ifndef ADAGEN_ARM7_FLOAT_P2_H
#define ADAGEN_ARM7_FLOAT_P2_H

#include <mpi.h>

enum {
  ARM7_FLOAT_P2_PROCESSES = 2,
  ARM7_FLOAT_P2_JOINTS = 9,
  ARM7_FLOAT_P2_NQ = 9,  // numbers in q
  ARM7_FLOAT_P2_NV = 9,  // in v and qdd
  ARM7_FLOAT_P2_NTAU = 9  // in tau
};

// Index of each joint's first number in q, and in v, tau and qdd.
enum {
  ARM7_FLOAT_P2_Q_base_yaw = 0,
  ARM7_FLOAT_P2_V_base_yaw = 0,  // joint 0, "base_yaw": revolute, 1 in q, 1 in v
  ARM7_FLOAT_P2_Q_shoulder_pitch = 1,
  ARM7_FLOAT_P2_V_shoulder_pitch = 1,  // joint 1, "shoulder_pitch": revolute, 1 in q, 1 in v
  ARM7_FLOAT_P2_Q_upper_arm_roll = 2,
  ARM7_FLOAT_P2_V_upper_arm_roll = 2,  // joint 2, "upper_arm_roll": revolute, 1 in q, 1 in v
  ARM7_FLOAT_P2_Q_elbow_pitch = 3,
  ARM7_FLOAT_P2_V_elbow_pitch = 3,  // joint 3, "elbow_pitch": revolute, 1 in q, 1 in v
  ARM7_FLOAT_P2_Q_forearm_roll = 4,
  ARM7_FLOAT_P2_V_forearm_roll = 4,  // joint 4, "forearm_roll": revolute, 1 in q, 1 in v
  ARM7_FLOAT_P2_Q_wrist_pitch = 5,
  ARM7_FLOAT_P2_V_wrist_pitch = 5,  // joint 5, "wrist_pitch": revolute, 1 in q, 1 in v
  ARM7_FLOAT_P2_Q_flange_roll = 6,
  ARM7_FLOAT_P2_V_flange_roll = 6,  // joint 6, "flange_roll": revolute, 1 in q, 1 in v
  ARM7_FLOAT_P2_Q_left_finger_slide = 7,
  ARM7_FLOAT_P2_V_left_finger_slide = 7,  // joint 7, "left_finger_slide": prismatic, 1 in q, 1 in v
  ARM7_FLOAT_P2_Q_right_finger_slide = 8,
  ARM7_FLOAT_P2_V_right_finger_slide = 8  // joint 8, "right_finger_slide": prismatic, 1 in q, 1 in v
};

// Reasons of failures: arm7_float_p2_reason gives that of a status.
enum {
  ARM7_FLOAT_P2_FINE = 0,  // none
  ARM7_FLOAT_P2_NOT_FINITE = 1,  // q, v or tau of a joint is not a finite number
  ARM7_FLOAT_P2_ZERO_QUATERNION = 2,  // a joint's quaternion cannot be normalised
  ARM7_FLOAT_P2_FACTORIZATION = 3,  // inertias beside a joint differ too much for the scalar
  ARM7_FLOAT_P2_OVERFLOW = 4,  // a joint's acceleration is not a finite number
  ARM7_FLOAT_P2_NO_ANSWER = 5,  // a process did not answer within the time limit
  ARM7_FLOAT_P2_ENDED = 6,  // process 0 has ended the evaluations
  ARM7_FLOAT_P2_NOT_REFINED = 7,  // refinement does not converge
  ARM7_FLOAT_P2_GIMBAL_LOCK = 8,  // gimbal lock of joints that are joined as one
  ARM7_FLOAT_P2_GROWTH = 9,  // a link beside a joint is too light for its neighbours
  ARM7_FLOAT_P2_NOT_SET = 16,  // a run-time constant is not finite, or a mass is not positive
  ARM7_FLOAT_P2_TOO_FEW_STEPS = 11,  // refinement converges too slowly
  ARM7_FLOAT_P2_LOOP_OPEN = 12,  // a loop or coupling is not closed in this configuration
  ARM7_FLOAT_P2_LOOP_TORN = 13,  // the velocity violates a loop or coupling
  ARM7_FLOAT_P2_LOOP_SINGULAR = 14,  // the rank of the loop constraints changes in this pose
  ARM7_FLOAT_P2_LOOP_FREE = 15  // the loops allow a motion of a joint that has no inertia
};

#ifdef __cplusplus
extern "C" {
#endif
typedef struct arm7_float_p2_solver arm7_float_p2_solver;

// Gives name, first index and size in q and v of joint k; returns 0 if there is no joint k.
int arm7_float_p2_joint(int k, const char** name, int* q, int* nq, int* v, int* nv);

// Collective over a communicator of 2 processes. channel: "auto", "window" (shared memory) or
// "message"; time_limit: seconds that a process waits for another. Returns null on failure;
// arm7_float_p2_failure(NULL) gives the reason.
arm7_float_p2_solver* arm7_float_p2_open(MPI_Comm comm, const char* channel, double time_limit);

// One evaluation, collective. q: 9 numbers, v and tau: 9 each, qdd: 9; joints in order, quaternions
// x y z w (normalised here), floating joints [linear; angular] in the body's frame.
// solve: every process passes the state and gets its own joints' accelerations (others untouched);
// solve_at_root: process 0 passes the state and gets all; the others may pass null, or call serve.
// Returns 0, or a status that arm7_float_p2_failure explains; then no acceleration is written.
int arm7_float_p2_solve(arm7_float_p2_solver* solver, const float* q, const float* v, const float* tau, float* qdd);
int arm7_float_p2_solve_at_root(arm7_float_p2_solver* solver, const float* q, const float* v, const float* tau, float* qdd);

// For all processes but 0: joins every solve_at_root of process 0, and waits between them without a
// time limit, until process 0 calls end. Returns 0 then, or the status of a failure.
int arm7_float_p2_serve(arm7_float_p2_solver* solver);

// At process 0: makes serve return at the others, which may serve again, or all close.
int arm7_float_p2_end(arm7_float_p2_solver* solver);

// Reason of a status, and the joint that it is about, -1 for none.
int arm7_float_p2_reason(int status);
int arm7_float_p2_failed_joint(int status);

// Text of a solver's last failure, valid until its next call; for null, the reason why the last open
// of this thread failed.
const char* arm7_float_p2_failure(const arm7_float_p2_solver* solver);

// Collective.
void arm7_float_p2_close(arm7_float_p2_solver* solver);
#ifdef __cplusplus
}
#endif
#endif

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <utility>

#include <Eigen/Core>

// ---- 2. model -----------------------------------------------------------------------------------

// Configuration of the runtime headers (adagen/).
#define ADAGEN_SOLVER
#define ADAGEN_MPI
#include "adagen/version.hpp"
#if ADAGEN_VERSION != 100
#error "the headers in adagen/ are of another version than adagen 0.1.0, which wrote this file"
#endif

namespace {

using Number = float;  // type of states, results and messages
using Real = float;    // type of all other values
constexpr int kProcesses = 2;
[[maybe_unused]] constexpr bool kAlone = false;  // whether process 0 does all the work
constexpr int kJointCount = 9, kLinkCount = kJointCount + 1;
constexpr int kNq = 9, kNv = 9;
[[maybe_unused]] constexpr int kNqdd = kNv;  // numbers in qdd
constexpr int kOuterCount = 0, kNtau = kNv + 6 * kOuterCount;
[[maybe_unused]] constexpr int kColumns = 1;  // right-hand sides: the motion, and one per slaved joint
[[maybe_unused]] constexpr std::size_t kSlavedCount = 0;  // joints that follow others
[[maybe_unused]] constexpr bool kGivesAll = true;  // whether accelerations of all joints are found
[[maybe_unused]] constexpr bool kBatch = false;  // whether many states are solved at once
[[maybe_unused]] constexpr int kRefine = 0;  // steps of iterative refinement
[[maybe_unused]] constexpr bool kWide = false;  // whether their residuals are found in wider numbers
[[maybe_unused]] constexpr bool kCertified = false;  // whether the error of each answer is bounded
[[maybe_unused]] constexpr bool kWeighed = kCertified || (kRefine > 0 && !kWide);  // whether residuals are swept inwards
[[maybe_unused]] constexpr int kPlanMessages = 2;
[[maybe_unused]] constexpr double kTolerance = 0.001;

}  // namespace

#include "adagen/constants.hpp"

namespace {

[[maybe_unused]] constexpr std::array<double, 3> kGravity{0.0, 0.0, -9.81};  // m/s^2
// What can be set at run time, and what it is until then.
[[maybe_unused]] constexpr int kParameterCount = 0;

constexpr std::array<LinkConstants, kLinkCount> kLinks{ {
    {"pedestal", 0.0f, {0.0f, 0.0f, 0.0f},
     {0.0f, 0.0f, 0.0f, 0.0f, 0.0f, 0.0f, 0.0f, 0.0f, 0.0f},
     {}},
    {"turret", 3.6f, {0.0f, 0.0f, 0.1f},
     {0.01641f, 0.0f, 0.0f, 0.0f, 0.01641f, 0.0f, 0.0f, 0.0f, 0.00882f},
     {}},
    {"upper_arm", 3.1f, {0.0f, -0.1f, 0.0f},
     {0.01767f, 0.0f, 0.0f, 0.0f, 0.00558f, 0.0f, 0.0f, 0.0f, 0.01767f},
     {}},
    {"elbow_housing", 2.6f, {0.0f, 0.0f, -0.03f},
     {0.00898625f, 0.0f, 0.0f, 0.0f, 0.00898625f, 0.0f, 0.0f, 0.0f, 0.0039325f},
     {}},
    {"forearm", 2.2f, {-0.05f, 0.1f, 0.0f},
     {0.0102483f, 0.0f, 0.0f, 0.0f, 0.00275f, 0.0f, 0.0f, 0.0f, 0.0102483f},
     {}},
    {"wrist_housing", 1.7f, {0.0f, 0.01f, -0.08f},
     {0.00448729f, 0.0f, 0.0f, 0.0f, 0.00448729f, 0.0f, 0.0f, 0.0f, 0.00172125f},
     {}},
    {"wrist", 1.3f, {0.04f, 0.01f, 0.0f},
     {0.0013f, 0.0f, 0.0f, 0.0f, 0.0013f, 0.0f, 0.0f, 0.0f, 0.0013f},
     {}},
    {"hand", 0.85f, {0.008470588235294117f, 0.0f, 0.08870588235294118f},
     {0.0034019064705882356f, 0.0f, 0.0004946823529411765f, 0.0f, 0.0014865882352941176f, 0.0f, 0.0004946823529411765f, 0.0f, 0.0031133417647058823f},
     {}},
    {"left_finger", 0.05f, {0.03f, 0.0f, 0.01f},
     {3.33333e-06f, 0.0f, 0.0f, 0.0f, 1.66667e-05f, 0.0f, 0.0f, 0.0f, 1.66667e-05f},
     {}},
    {"right_finger", 0.05f, {0.03f, 0.0f, 0.01f},
     {3.33333e-06f, 0.0f, 0.0f, 0.0f, 1.66667e-05f, 0.0f, 0.0f, 0.0f, 1.66667e-05f},
     {}},
} };

constexpr std::array<JointConstants, kJointCount> kJoints{ {
    {"base_yaw", JointKind::kRevolute, 0, 0, 1, 0, 1,
     {1.0f, 0.0f, 0.0f, 0.0f, 1.0f, 0.0f, 0.0f, 0.0f, 1.0f},
     {0.0f, 0.0f, 0.16f}, -1, 0.0, 0.0},
    {"shoulder_pitch", JointKind::kRevolute, 1, 1, 1, 1, 1,
     {1.0f, 0.0f, 0.0f, 0.0f, -3.673205103346574e-06f, 0.9999999999932537f, 0.0f, -0.9999999999932537f, -3.673205103346574e-06f},
     {0.0f, 0.0f, 0.18f}, -1, 0.0, 0.0},
    {"upper_arm_roll", JointKind::kRevolute, 2, 2, 1, 2, 1,
     {1.0f, 0.0f, 0.0f, 0.0f, -3.673205103346574e-06f, -0.9999999999932537f, 0.0f, 0.9999999999932537f, -3.673205103346574e-06f},
     {0.0f, -0.3f, 0.0f}, -1, 0.0, 0.0},
    {"elbow_pitch", JointKind::kRevolute, 3, 3, 1, 3, 1,
     {1.0f, 0.0f, 0.0f, 0.0f, -3.673205103346574e-06f, -0.9999999999932537f, 0.0f, 0.9999999999932537f, -3.673205103346574e-06f},
     {0.08f, 0.0f, 0.0f}, -1, 0.0, 0.0},
    {"forearm_roll", JointKind::kRevolute, 4, 4, 1, 4, 1,
     {1.0f, 0.0f, 0.0f, 0.0f, -3.673205103346574e-06f, 0.9999999999932537f, 0.0f, -0.9999999999932537f, -3.673205103346574e-06f},
     {-0.08f, 0.38f, 0.0f}, -1, 0.0, 0.0},
    {"wrist_pitch", JointKind::kRevolute, 5, 5, 1, 5, 1,
     {1.0f, 0.0f, 0.0f, 0.0f, -3.673205103346574e-06f, -0.9999999999932537f, 0.0f, 0.9999999999932537f, -3.673205103346574e-06f},
     {0.0f, 0.0f, 0.0f}, -1, 0.0, 0.0},
    {"flange_roll", JointKind::kRevolute, 6, 6, 1, 6, 1,
     {1.0f, 0.0f, 0.0f, 0.0f, -3.673205103346574e-06f, -0.9999999999932537f, 0.0f, 0.9999999999932537f, -3.673205103346574e-06f},
     {0.09f, 0.0f, 0.0f}, -1, 0.0, 0.0},
    {"left_finger_slide", JointKind::kPrismatic, 7, 7, 1, 7, 1,
     {0.0f, 1.0f, 0.0f, 0.0f, 0.0f, 1.0f, 1.0f, 0.0f, 0.0f},
     {0.0f, 0.0f, 0.13f}, -1, 0.0, 0.0},
    {"right_finger_slide", JointKind::kPrismatic, 7, 8, 1, 8, 1,
     {0.0f, -0.9999999999964793f, -2.65358979335273e-06f, 0.0f, 2.65358979335273e-06f, -0.9999999999964793f, 1.0f, 0.0f, 0.0f},
     {0.0f, 0.0f, 0.13f}, -1, 0.0, 0.0},
} };

[[maybe_unused]] constexpr std::array<OuterForce, kOuterCount> kOuterForces{};

}  // namespace

// ---- 3. runtime ---------------------------------------------------------------------------------

#include "adagen/status.hpp"
#include "adagen/failures.hpp"
#include "adagen/far_angles.hpp"
#include "adagen/kernels/lanes.hpp"
#include "adagen/kernels/algebra.hpp"
#include "adagen/spatial.hpp"
#include "adagen/joins.hpp"

namespace {

constexpr std::array<MessageInfo, 4> kMessages{ {
    {1, 0, 42},  // 0: assembled: chain of "flange_roll"
    {0, 1, 6},  // 1: forces on: chain of "flange_roll"
    {0, 1, 22},  // 2: state
    {1, 0, 4},  // 3: accelerations
} };

}  // namespace

#include "adagen/channel.hpp"
#include "adagen/stamp.hpp"

// ---- 4. kernels ---------------------------------------------------------------------------------
// Vectors are expressed in the axes of the base (of the ground, or of a floating base's link), about
// each link's own origin. omega, alpha, a: motion of links for zero joint accelerations; the joint
// accelerations that are solved for come on top.

#include "adagen/kernels/tables.hpp"

namespace {

// Type of values.
using Value = Real;

// Mass, mass times centre of mass, and pseudo-inertia of each link.
constexpr std::array<LinkInertia, kJointCount> kInertias{ {
    {3.6f, {0.0f, 0.0f, 0.36000000000000004f},
     {0.00441f, 0.0f, 0.0f, 0.00441f, 0.0f, 0.04800000000000001f}},
    {3.1f, {0.0f, -0.31000000000000005f, 0.0f},
     {0.00279f, 0.0f, 0.0f, 0.045880000000000004f, 0.0f, 0.00279f}},
    {2.6f, {0.0f, 0.0f, -0.078f},
     {0.00196625f, 0.0f, 0.0f, 0.00196625f, 0.0f, 0.009359999999999999f}},
    {2.2f, {-0.11000000000000001f, 0.22000000000000003f, 0.0f},
     {0.006875000000000001f, -0.011000000000000003f, 0.0f, 0.030873300000000003f, 0.0f, 0.001375f}},
    {1.7f, {0.0f, 0.017f, -0.136f},
     {0.000860625f, 0.0f, 0.0f, 0.0010306249999999999f, -0.00136f, 0.014506665f}},
    {1.3f, {0.052000000000000005f, 0.013000000000000001f, 0.0f},
     {0.0027300000000000002f, 0.0005200000000000001f, 0.0f, 0.00078f, 0.0f, 0.00065f}},
    {0.85f, {0.007199999999999999f, 0.0f, 0.0754f},
     {0.0006599999999999998f, 0.0f, 0.00014399999999999992f, 0.0025143300000000004f, 0.0f, 0.007576f}},
    {0.05f, {0.0015f, 0.0f, 0.0005f},
     {6.0000035e-05f, 0.0f, 1.5e-05f, 1.666665e-06f, 0.0f, 6.666665e-06f}},
    {0.05f, {0.0015f, 0.0f, 0.0005f},
     {6.0000035e-05f, 0.0f, 1.5e-05f, 1.666665e-06f, 0.0f, 6.666665e-06f}},
} };

// Memory slot of each joint and its child link; limbs that share lanes, and segments of long runs,
// are interleaved.
constexpr int kSlotCount = 9;
constexpr int kTile = 0;  // joints whose memory is in use at the same time; 0: all
constexpr bool kInLanes = false;  // whether limbs share lanes
constexpr bool kPrescribedInLanes = false;  // with prescribed motions
constexpr bool kReordered = false;  // whether slots are in another order than joints
constexpr int kSlots[kJointCount]{ 0, 1, 2, 3, 4, 5, 6, 7, 8 };
// Blocks of slots with equal constants: number of kinds (0: not compared), kind of each block, and
// first block of each kind.
constexpr int kBlockKindCount = 0;
[[maybe_unused]] constexpr int kBlockKinds[]{ 0 };
[[maybe_unused]] constexpr int kFirstOfKind[]{ 0 };
constexpr bool kByColumns = true;  // whether runs are computed by columns
// Joints that are eliminated in their own axes: always, or only if the axes of the base lose digits.
constexpr bool kAnyTurned = false;
constexpr bool kTurned[kJointCount]{ 0, 0, 0, 0, 0, 0, 0, 0, 0 };
constexpr bool kAnyTurnedIfLost = false;
constexpr bool kTurnedIfLost[kJointCount]{ 0, 0, 0, 0, 0, 0, 0, 0, 0 };
constexpr double kLosing = 256.0;  // they do if trace > kLosing * D
// Whether sweeps are repeated with other forces.
constexpr bool kPassesFree = false;  // whether mobilities pass floating joints
constexpr bool kAgain = kWide || kSlavedCount > 0;

// Role of each process at each link: gathers, adds_own, parts, oriented.
constexpr LinkRole kRoles[2][kLinkCount]{
    {{1, 0, 1, 0}, {0, 1, 0, 0}, {0, 1, 0, 0}, {0, 1, 0, 0}, {0, 1, 0, 0}, {0, 0, 0, 0}, {0, 0, 0, 0}, {0, 0, 0, 0}, {0, 0, 0, 0}, {0, 0, 0, 0}},
    {{0, 0, 0, 0}, {0, 0, 0, 0}, {0, 0, 0, 0}, {0, 0, 0, 0}, {0, 0, 0, 0}, {1, 1, 1, 0}, {0, 1, 0, 0}, {1, 1, 1, 0}, {0, 1, 0, 0}, {0, 1, 0, 0}},
};


}  // namespace

#include "adagen/kernels/state.hpp"

namespace {

// Memory where segments meet, by joint.
struct Joint_shoulder_pitch {
  Mat6 Phi_forearm;
  Columns6 b_forearm;
  Columns6 F_on_forearm;
};
struct Joint_forearm_roll {
  Transform X, Y;  // to the joint's frame, about its two links' origins
  Joined<Revolute> joined;
};
struct Joint_flange_roll {
  Mat6 Phi_wrist_housing;
  Columns6 b_wrist_housing;
  Columns6 F_on_wrist_housing;
};
struct Cuts {
  Joint_shoulder_pitch j_shoulder_pitch;
  Joint_forearm_roll j_forearm_roll;
  Joint_flange_roll j_flange_roll;
  std::array<Columns6, kLinkCount> loads;  // wrenches on links, from handle forces
  EIGEN_MAKE_ALIGNED_OPERATOR_NEW
};

}  // namespace

#include "adagen/kernels/blocks.hpp"
#include "adagen/kernels/inertias.hpp"
#include "adagen/kernels/memory.hpp"
#include "adagen/gravity.hpp"
#include "adagen/kernels/guards.hpp"
#include "adagen/kernels/kinds.hpp"
#include "adagen/kernels/links.hpp"
#include "adagen/kernels/outward.hpp"
#include "adagen/kernels/keep_nothing.hpp"
#include "adagen/kernels/factors.hpp"
#include "adagen/kernels/spherical.hpp"
#include "adagen/kernels/turned.hpp"
#include "adagen/kernels/inward.hpp"
#include "adagen/kernels/shuffles.hpp"
#include "adagen/kernels/columns.hpp"
#include "adagen/kernels/inward_columns.hpp"
#include "adagen/kernels/reach_nothing.hpp"
#include "adagen/kernels/accelerate.hpp"
#include "adagen/kernels/mobility.hpp"
#include "adagen/kernels/wrenches.hpp"
#include "adagen/kernels/carry.hpp"
#include "adagen/exchange.hpp"

namespace {

// ---- 5. processes -------------------------------------------------------------------------------

// Process 0: 5 of 9 joints: "base_yaw", "shoulder_pitch", "upper_arm_roll", "elbow_pitch", "forearm_roll"
void run_0([[maybe_unused]] Workspace& w, [[maybe_unused]] Channel& channel) {
  require_finite(w, w.q, 0, 5, &JointConstants::q, kNotFinite);
  require_finite(w, w.v, 0, 5, &JointConstants::v, kNotFinite);
  require_finite(w, w.tau, 0, 5, &JointConstants::v, kNotFinite);
  stamp(0);
  std::copy_n(w.q + 0, 5, w.angle.data() + 0);
  turn<block(0), block(4) + 1>(w);
  outward<0, 4>(w);  // "base_yaw" .. "forearm_roll"
  stamp(1);
  set_up_links<block(0), block(3) + 1>(w);
  set_up_columns<block(0), block(3) + 1>(w);
  inward_in_columns<0, 0, 3, true>(w);  // "base_yaw" .. "elbow_pitch"
  {  // "base_yaw" .. "elbow_pitch"
    const Way way = carry<false, 0, 3>(w);
    show<4>(w, way, w.j_shoulder_pitch.Phi_forearm, w.j_shoulder_pitch.b_forearm);
  }
  stamp(2);
  {  // from process 1: assembled: chain of "flange_roll"
    const Number* from = channel.receive(0, w.status);
    from = get(from, w.j_flange_roll.Phi_wrist_housing);
    from = get(from, w.j_flange_roll.b_wrist_housing);
  }
  stamp(3);
  {
    auto& i = w.j_forearm_roll;
    set_transforms(w, 4, i.X, i.Y);
    load_torque(w, 4, 4, i.joined.tau);
    const Mat6 X_Phi_A = i.X * w.j_shoulder_pitch.Phi_forearm;
    const Mat6 Phi_A = from_right(X_Phi_A, i.X);
    const Mat6 Phi_B = from_right(i.Y * w.j_flange_roll.Phi_wrist_housing, i.Y);
    const Columns6 c = Columns6::Zero();
    if (!join(i.joined, Phi_A, Phi_B, i.X * w.j_shoulder_pitch.b_forearm, i.Y * w.j_flange_roll.b_wrist_housing, c))
      fail(w, kFactorization, 4);
  }
  stamp(4);
  {
    auto& i = w.j_forearm_roll;
    Release<Revolute> release(i.joined);
    const Columns6 f = release.force();  // Eq. (8), (10)
    store_acceleration(w, 4, 4, release.qdd());  // Eq. (9)
    w.j_shoulder_pitch.F_on_forearm = -i.X.transposed_times(f);
    w.j_flange_roll.F_on_wrist_housing = i.Y.transposed_times(f);
  }
  stamp(5);
  {  // to process 1: forces on: chain of "flange_roll"
    Number* to = channel.outgoing(1, w.status);
    to = put(to, w.j_flange_roll.F_on_wrist_housing);
    channel.send(1, w.status);
  }
  stamp(6);
  w.loads[4] = in_base(w, 4, w.j_shoulder_pitch.F_on_forearm);
  deliver<0, 3, true>(w);  // "base_yaw" .. "elbow_pitch"
  accelerate<0, 0, 3>(w);  // "base_yaw" .. "elbow_pitch"
  stamp(7);
  require_finite(w, w.answer.data(), 0, 5, &JointConstants::v, kOverflow);
  give(w, 0, 5);
}

// Process 1: 4 of 9 joints: "wrist_pitch", "flange_roll", "left_finger_slide", "right_finger_slide"; kinematics of 5 more on the way to the ground
void run_1([[maybe_unused]] Workspace& w, [[maybe_unused]] Channel& channel) {
  require_finite(w, w.q, 0, 9, &JointConstants::q, kNotFinite);
  require_finite(w, w.v, 0, 9, &JointConstants::v, kNotFinite);
  require_finite(w, w.tau, 5, 4, &JointConstants::v, kNotFinite);
  stamp(0);
  std::copy_n(w.q + 0, 7, w.angle.data() + 0);
  turn<block(0), block(8) + 1>(w);
  pass_outward<0, 4>(w);  // "base_yaw" .. "forearm_roll"
  outward<5, 7>(w);  // "wrist_pitch" .. "left_finger_slide"
  outward<8, 8>(w);  // "right_finger_slide"
  stamp(1);
  set_up_links<block(4), block(8) + 1>(w);
  set_up_columns<block(5), block(8) + 1>(w);
  inward_in_columns<1, 8, 8, true>(w);  // "right_finger_slide"
  inward_in_columns<1, 5, 7, true>(w);  // "wrist_pitch" .. "left_finger_slide"
  invert_root<1, 5>(w, w.j_flange_roll.Phi_wrist_housing, w.j_flange_roll.b_wrist_housing);
  stamp(2);
  {  // to process 0: assembled: chain of "flange_roll"
    Number* to = channel.outgoing(0, w.status);
    to = put(to, w.j_flange_roll.Phi_wrist_housing);
    to = put(to, w.j_flange_roll.b_wrist_housing);
    channel.send(0, w.status);
  }
  stamp(3);
  {  // from process 0: forces on: chain of "flange_roll"
    const Number* from = channel.receive(1, w.status);
    from = get(from, w.j_flange_roll.F_on_wrist_housing);
  }
  stamp(4);
  w.loads[5] = in_base(w, 5, w.j_flange_roll.F_on_wrist_housing);
  accelerate_root<5>(w, w.j_flange_roll.Phi_wrist_housing, w.j_flange_roll.b_wrist_housing);
  accelerate<1, 5, 7>(w);  // "wrist_pitch" .. "left_finger_slide"
  accelerate<1, 8, 8>(w);  // "right_finger_slide"
  stamp(5);
  require_finite(w, w.answer.data(), 5, 4, &JointConstants::v, kOverflow);
  give(w, 5, 4);
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

}  // namespace

#include "adagen/no_parameters.hpp"
#include "adagen/solver.hpp"
#include "adagen/open.hpp"

static_assert(ARM7_FLOAT_P2_NQ == kNq && ARM7_FLOAT_P2_NV == kNv && ARM7_FLOAT_P2_NTAU == kNtau);
static_assert(int(ARM7_FLOAT_P2_FINE) == int(kFine));
static_assert(int(ARM7_FLOAT_P2_NOT_FINITE) == int(kNotFinite));
static_assert(int(ARM7_FLOAT_P2_ZERO_QUATERNION) == int(kZeroQuaternion));
static_assert(int(ARM7_FLOAT_P2_FACTORIZATION) == int(kFactorization));
static_assert(int(ARM7_FLOAT_P2_OVERFLOW) == int(kOverflow));
static_assert(int(ARM7_FLOAT_P2_NO_ANSWER) == int(kNoAnswer));
static_assert(int(ARM7_FLOAT_P2_ENDED) == int(kEnded));
static_assert(int(ARM7_FLOAT_P2_NOT_REFINED) == int(kNotRefined));
static_assert(int(ARM7_FLOAT_P2_GIMBAL_LOCK) == int(kGimbalLock));
static_assert(int(ARM7_FLOAT_P2_GROWTH) == int(kGrowth));
static_assert(int(ARM7_FLOAT_P2_NOT_SET) == int(kNotSet));
static_assert(int(ARM7_FLOAT_P2_TOO_FEW_STEPS) == int(kTooFewSteps));
static_assert(int(ARM7_FLOAT_P2_LOOP_OPEN) == int(kLoopOpen));
static_assert(int(ARM7_FLOAT_P2_LOOP_TORN) == int(kLoopTorn));
static_assert(int(ARM7_FLOAT_P2_LOOP_SINGULAR) == int(kLoopSingular));
static_assert(int(ARM7_FLOAT_P2_LOOP_FREE) == int(kLoopFree));

struct arm7_float_p2_solver : Solver {};

extern "C" {

int arm7_float_p2_joint(int k, const char** name, int* q, int* nq, int* v, int* nv) {
  if (k < 0 || k >= kJointCount) return 0;
  const JointConstants& joint = kJoints[k];
  *name = joint.name, *q = joint.q, *nq = joint.nq, *v = joint.v, *nv = joint.nv;
  return 1;
}

arm7_float_p2_solver* arm7_float_p2_open(MPI_Comm comm, const char* channel, double time_limit) {
  return opened<arm7_float_p2_solver>(comm, channel, time_limit);
}

int arm7_float_p2_solve(arm7_float_p2_solver* solver, const float* q, const float* v, const float* tau, float* qdd) {
  return solver->solve(q, v, tau, qdd);
}

int arm7_float_p2_solve_at_root(arm7_float_p2_solver* solver, const float* q, const float* v, const float* tau, float* qdd) {
  return solver->solve_at_root(q, v, tau, qdd);
}

int arm7_float_p2_serve(arm7_float_p2_solver* solver) { return solver->serve(); }

int arm7_float_p2_end(arm7_float_p2_solver* solver) { return solver->end(); }

int arm7_float_p2_reason(int status) { return failure_kind(status); }

int arm7_float_p2_failed_joint(int status) { return is_of_joint(failure_kind(status)) ? failure_place(status) : -1; }

const char* arm7_float_p2_failure(const arm7_float_p2_solver* solver) {
  return solver == nullptr ? open_failure.c_str() : solver->text.c_str();
}

void arm7_float_p2_close(arm7_float_p2_solver* solver) {
  if (solver == nullptr) return;
  solver->close();
  delete solver;
}

}  // extern "C"

// ---- 6. program ---------------------------------------------------------------------------------
// Description of this solver for the program around it, which is the same for all robots: it reads
// states, writes accelerations, checks, times, traces and simulates.

#ifndef ADAGEN_NO_MAIN
#include "adagen/description.hpp"
#include "adagen/measured.hpp"
#include "adagen/this_solver.hpp"

namespace {

// The stages of each process's work, for --trace.
constexpr std::array<adagen::Stage, 7> kStages_0{ {
    {"kinematics", 4, -1},
    {"assembly", 3, -1},
    {"receive", -1, 0},
    {"assembly", 4, -1},
    {"disassembly", 4, -1},
    {"send", -1, 1},
    {"disassembly", 3, -1},
} };
constexpr std::array<adagen::Stage, 5> kStages_1{ {
    {"kinematics", 8, -1},
    {"assembly", 5, -1},
    {"send", -1, 0},
    {"receive", -1, 1},
    {"disassembly", 5, -1},
} };
constexpr std::array<adagen::Table<adagen::Stage>, kProcesses> kStages{ {
    {kStages_0.data(), 7},
    {kStages_1.data(), 5},
} };

// From the cost profile default.
constexpr adagen::Hop kWindowHop{0, 159, 0.437};
constexpr adagen::Hop kMessageHop{26, 228, 0.644};

}  // namespace

// Compiled for size: it runs once.
[[gnu::cold]] int main(int count, char** words) {
  const adagen::Description<Number> description{
      "arm7", "auto", kProcesses, 1, kNq, kNv, kNtau, kNqdd, kRefine,
      false, kAlone, kBatch, kCertified, false, false, kTolerance, kGravity.data(),
      table(kJoints), table(kLinks), table(kOuterForces), {}, {}, {}, table(kMessages), kStages.data(), kWindowHop,
      kMessageHop};
  auto* const solver = new ThisSolver;
  const int status = adagen::program(description, *solver, count, words);
  delete solver;
  return status;
}
#endif  // ADAGEN_NO_MAIN
