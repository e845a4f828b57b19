// Forward dynamics of "arm7" on 2 processes, emitted by adagen 0.1.0 (solver.cpp.j2). Do not edit: emit anew.
//
// robot     "arm7", 9 joints, 9 degrees of freedom, description sha256 35a799ae72b600eeca178cc12eccff22927d06b6ca76bda0ede3ef5832ebda29
// command   adagen ../models/arm7.urdf --procs 2 --schedule=balanced --shape=kernels --scalar=float --name=arm7_float
// options   form segment, shape kernels, scalar float, channel auto, fixed base, gravity 0.0, 0.0, -9.81
// links     adagen_program.cpp -DADAGEN_MPI -DADAGEN_FLOAT
// program   2 processes, joined at cuts; 1.39 us predicted (default profile)
//           process 0: base_yaw .. forearm_roll
//           process 1: wrist_pitch .. right_finger_slide
// schedule  forearm_roll@0-1(shoulder_pitch@0(base_yaw | upper_arm_roll(|elbow_pitch)) | flange_roll@1(wrist_pitch | left_finger_slide(right_finger_slide|)))
// licence   yours to choose: what adagen emits belongs to whoever emits it
//
// Each process treats a segment of the robot by the articulated-body algorithm: I^A and p^A (IA, pA), a
// link's inertia and bias force with all that hangs on it, are swept to the segment's root, and the
// accelerations come back. Where segments meet, the assembly-disassembly algorithm of Yamane and Nakamura
// joins them: Phi = (I^A)^-1 and b are what a segment shows at a cut; joint i joins chain A (its parent
// link's side) and chain B (its child link's side), Eq. (3)-(7), and gives back its force, Eq. (8)-(10).
// Spatial vectors are [angular; linear], in the axes of the base, about each link's origin.
//
// How to read on:
//   1. interface   what a program that links this file calls
//   2. model       the robot's constants
//   3. runtime     spatial algebra, joints, exchange between processes
//   4. joints      for each joint its memory, then what is done with it, step by step
//   5. processes   who does what, in order
//   6. program     what the program around it, adagen_program.cpp, is told; main

// ---- 1. interface -------------------------------------------------------------------------------
// To use it from a program of yours: compile this file with -DADAGEN_NO_MAIN and link it; arm7_float_p2.h
// beside it is this part.
// C interface of the solver arm7_float_p2: forward dynamics of "arm7" on 2 processes,
// emitted by adagen 0.1.0 (interface.h.j2). Do not edit: emit anew.
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

// Where each joint begins in q, and in v, tau and qdd.
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

// Why a call failed, as arm7_float_p2_reason tells of the status that it returned.
enum {
  ARM7_FLOAT_P2_FINE = 0,  // none
  ARM7_FLOAT_P2_NOT_FINITE = 1,  // q, v or tau of a joint is not a finite number
  ARM7_FLOAT_P2_ZERO_QUATERNION = 2,  // a joint's quaternion cannot be normalised
  ARM7_FLOAT_P2_FACTORIZATION = 3,  // inertias beside a joint differ too much for the scalar
  ARM7_FLOAT_P2_OVERFLOW = 4,  // a joint's acceleration is not a finite number
  ARM7_FLOAT_P2_NO_ANSWER = 5,  // a process did not answer within the time limit
  ARM7_FLOAT_P2_ENDED = 6,  // process 0 has ended the evaluations
  ARM7_FLOAT_P2_NOT_REFINED = 7,  // refinement does not converge
  ARM7_FLOAT_P2_GIMBAL_LOCK = 8,  // joints that are joined as one do not move in as many directions
  ARM7_FLOAT_P2_GROWTH = 9,  // a link beside a joint is too light for its neighbours
  ARM7_FLOAT_P2_NOT_SET = 16,  // what is to be set at run time is not finite, or is no mass
  ARM7_FLOAT_P2_TOO_FEW_STEPS = 11,  // refinement converges too slowly
  ARM7_FLOAT_P2_LOOP_OPEN = 12,  // a loop or coupling is not closed in this configuration
  ARM7_FLOAT_P2_LOOP_TORN = 13,  // this velocity tears a loop or coupling open
  ARM7_FLOAT_P2_LOOP_SINGULAR = 14,  // what a loop holds changes in this pose
  ARM7_FLOAT_P2_LOOP_FREE = 15  // loops leave a joint a motion that no inertia resists
};

#ifdef __cplusplus
extern "C" {
#endif
typedef struct arm7_float_p2_solver arm7_float_p2_solver;

// Joints in order, each with its place in the state: gives name, start and size in q and v of joint
// k, or returns 0 where there is none.
int arm7_float_p2_joint(int k, const char** name, int* q, int* nq, int* v, int* nv);

// Collective over a communicator of 2 processes. channel: "auto", "window" (shared memory) or
// "message"; time_limit: seconds that a process waits for another. Returns null where it cannot be
// done; arm7_float_p2_failure(NULL) says why.
arm7_float_p2_solver* arm7_float_p2_open(MPI_Comm comm, const char* channel, double time_limit);

// One evaluation, collective. q: 9 numbers, v and tau: 9 each, qdd: 9; joints in order, quaternions
// x y z w (normalised here), floating joints [linear; angular] in the body's frame.
// solve: every process passes the state and gets its own joints' accelerations (others untouched);
// solve_at_root: process 0 passes the state and gets them all, the others may pass null, or serve.
// Returns 0, or a status that arm7_float_p2_failure puts into words; no acceleration is written then.
int arm7_float_p2_solve(arm7_float_p2_solver* solver, const float* q, const float* v, const float* tau, float* qdd);
int arm7_float_p2_solve_at_root(arm7_float_p2_solver* solver, const float* q, const float* v, const float* tau, float* qdd);

// What every process but 0 can do all the time: takes part in each solve_at_root of process 0, however
// long that lets it wait, until process 0 ends it. Returns 0, or why it cannot go on.
int arm7_float_p2_serve(arm7_float_p2_solver* solver);

// At process 0: the others' serve returns. They may serve again, or all close.
int arm7_float_p2_end(arm7_float_p2_solver* solver);

// What a status says: its reason, and which joint it is about, -1 for none.
int arm7_float_p2_reason(int status);
int arm7_float_p2_failed_joint(int status);

// The last failure of a solver in words, valid until the next call; of null, why the last open of this
// thread returned null.
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

// What the headers of the runtime (adagen/) are to take from here, and what they are to do.
#define ADAGEN_SOLVER
#define ADAGEN_MPI
#include "adagen/version.hpp"
#if ADAGEN_VERSION != 100
#error "the headers in adagen/ are not those of adagen 0.1.0, which this file was emitted by"
#endif

namespace {

using Number = float;  // of states, answers and messages
using Real = float;    // of all between
constexpr int kProcesses = 2;
[[maybe_unused]] constexpr bool kAlone = false;  // whether process 0 does all, and no other takes part
constexpr int kJointCount = 9, kLinkCount = kJointCount + 1;
constexpr int kNq = 9, kNv = 9;
constexpr int kOuterCount = 0, kNtau = kNv + 6 * kOuterCount;
[[maybe_unused]] constexpr int kColumns = 1;  // right-hand sides: the motion, and one per slaved joint
[[maybe_unused]] constexpr std::size_t kSlavedCount = 0;  // joints that follow others
[[maybe_unused]] constexpr bool kBatch = false;  // whether many states are solved at once
[[maybe_unused]] constexpr int kRefine = 0;  // steps of iterative refinement
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
// Vectors are in the axes of the base, which all its links share (of the ground, or of a floating
// base's link), about each link's own origin. Links move as they would were all joint accelerations
// zero (omega, alpha, a); joint accelerations are solved for as what comes on top.

#include "adagen/kernels/tables.hpp"

namespace {

// What is computed with.
using Value = Real;

// Of each link its mass, that times its centre of mass, and its pseudo-inertia.
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

// Where a joint, and the link beyond it, lie in memory: limbs side by side take turns, and so do
// segments of long runs.
constexpr int kSlotCount = 9;
constexpr bool kAbreast = false;  // whether there are such
constexpr bool kPrescribedAbreast = false;  // with motions that are prescribed
constexpr bool kReordered = false;  // whether joints lie in another order than they have
constexpr int kSlots[kJointCount]{ 0, 1, 2, 3, 4, 5, 6, 7, 8 };
constexpr bool kByColumns = true;  // whether runs are taken by columns
// Joints that are eliminated in their own axes; others that are where those of the base lose digits.
constexpr bool kAnyTurned = false;
constexpr bool kTurned[kJointCount]{ 0, 0, 0, 0, 0, 0, 0, 0, 0 };
constexpr bool kAnyTurnedIfLost = false;
constexpr bool kTurnedIfLost[kJointCount]{ 0, 0, 0, 0, 0, 0, 0, 0, 0 };
constexpr double kLosing = 256.0;  // times D: a trace from which on they do
// Whether sweeps are done again for other forces on links than their motion takes.
constexpr bool kPassesFree = false;  // whether mobilities pass floating joints
constexpr bool kAgain = kRefine > 0 || kSlavedCount > 0;

// What each process does at each link: gathers, adds_own, parts, oriented.
constexpr LinkRole kRoles[2][kLinkCount]{
    {{1, 0, 1, 0}, {0, 1, 0, 0}, {0, 1, 0, 0}, {0, 1, 0, 0}, {0, 1, 0, 0}, {0, 0, 0, 0}, {0, 0, 0, 0}, {0, 0, 0, 0}, {0, 0, 0, 0}, {0, 0, 0, 0}},
    {{0, 0, 0, 0}, {0, 0, 0, 0}, {0, 0, 0, 0}, {0, 0, 0, 0}, {0, 0, 0, 0}, {1, 1, 1, 0}, {0, 1, 0, 0}, {1, 1, 1, 0}, {0, 1, 0, 0}, {0, 1, 0, 0}},
};

}  // namespace

#include "adagen/kernels/state.hpp"

namespace {

// What is kept where segments meet, with the joint that it belongs to.
struct Joint_shoulder_pitch {
  Mat6 Phi_turret;
  Columns6 b_turret;
  Mat6 Phi_upper_arm;
  Columns6 b_upper_arm;
  Mat6 Phi_elbow_housing;
  Columns6 b_elbow_housing;
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

<<<<<<< HEAD
// Constants of the model. What is set up for many links at once lies in blocks, side by side.
constexpr int kPerBlock = static_cast<int>(sizeof(Lanes) / sizeof(Value));  // links in a block
constexpr int kBlockCount = (kSlotCount + kPerBlock - 1) / kPerBlock;

constexpr int slot_of(int j) { return kReordered ? kSlots[j] : j; }

// A number of each joint of a block, as constants of the model are kept.
using PerJoint = std::array<Real, sizeof(Value) == sizeof(Real) ? kPerBlock : 1>;

struct alignas(64) BlockConstants {
  PerJoint rotation[6];  // joint frame to parent link's axes, columns x and y
  PerJoint x, y, z;      // of the joint's origin in the parent link's frame
  PerJoint mass, moments[3], tensor[6];
};

constexpr void fill(PerJoint& numbers, Real x) {
  for (Real& number : numbers) number = x;
}
constexpr std::array<BlockConstants, kBlockCount> kBlockConstants = [] {
  std::array<BlockConstants, kBlockCount> result{};
  for (BlockConstants& block : result) {  // slots that are not filled do not turn, but weigh
    for (const int k : {0, 4}) fill(block.rotation[k], 1);
    fill(block.mass, 1);
    for (const int k : {0, 3, 5}) fill(block.tensor[k], 1);
  }
  for (int j = 0; j < kJointCount; ++j) {
    BlockConstants& block = result[static_cast<std::size_t>(slot_of(j) / kPerBlock)];
    const std::size_t lane = static_cast<std::size_t>(slot_of(j) % kPerBlock);
    const LinkInertia& link = kInertias[static_cast<std::size_t>(j)];
    const JointConstants& joint = kJoints[static_cast<std::size_t>(j)];
    for (int k = 0; k < 6; ++k) block.rotation[k][lane] = joint.rotation[k % 3 * 3 + k / 3];
    block.x[lane] = joint.translation[0];
    block.y[lane] = joint.translation[1];
    block.z[lane] = joint.translation[2];
    block.mass[lane] = link.mass;
    for (int k = 0; k < 3; ++k) block.moments[k][lane] = link.moments[k];
    for (int k = 0; k < 6; ++k) block.tensor[k][lane] = link.tensor[k];
  }
  return result;
}();

// Inertias of links are constants.
struct Inertias {
  static const LinkInertia& inertia_of(int joint) {
    return kInertias[static_cast<std::size_t>(joint)];
  }
  static const BlockConstants& constants_of(int block) {
    return kBlockConstants[static_cast<std::size_t>(block)];
  }
};

// The memory of a process.

// Joints that are treated together, one in each lane of T; their slots follow each other.
template <class T>
[[maybe_unused]] constexpr int kWidth = static_cast<int>(sizeof(T) / sizeof(Value));
template <class T>
struct Joints {
  int slot;  // of the first one
  int joint[kWidth<T>];

  constexpr const JointConstants& any() const {
    return kJoints[static_cast<std::size_t>(joint[0])];
  }
};
ADAGEN_INLINE Joints<Value> single(int j) { return {slot_of(j), {j}}; }

// The lanes of limbs side by side.
typedef Real Two __attribute__((vector_size(2 * sizeof(Real))));
typedef Real Four __attribute__((vector_size(4 * sizeof(Real))));

// A number of each of the joints.
template <class T, class Number, std::size_t... lane>
ADAGEN_INLINE T each_of(const Joints<T>& joints, const Number& number,
                        std::index_sequence<lane...>) {
  return T{Real(number(kJoints[static_cast<std::size_t>(joints.joint[lane])]))...};
}
template <class T, class Number>
ADAGEN_INLINE T each(const Joints<T>& joints, const Number& number) {
  if constexpr (kWidth<T> == 1) {
    const auto one = number(kJoints[static_cast<std::size_t>(joints.joint[0])]);
    if constexpr (std::is_same_v<decltype(one), const T>)
      return one;
    else
      return T{} + one;
  } else {
    return each_of(joints, number, std::make_index_sequence<kWidth<T>>{});
  }
}

// What a block holds of each link j + 1, joint j being the one above it; in the axes of its base.
enum Entry : int {
  kTurn = 0,           // rotation from the child's to the parent link's axes, row by row
  kAxes = 9,           // the link's orientation R, row by row: its z is the joint's axis
  kOmega = 18,         // angular velocity
  kAlpha = 21,         // angular acceleration and
  kAcceleration = 24,  // acceleration of its origin less gravity, were all joint accelerations zero
  kRotational = 27,    // A of the bare link
  kMoments = 33,       // mass times centre of mass: B of the bare link is its cross product
  kTorque = 36,        // bias force n
  kForce = 39,         // and f of the bare link
  kEntries = 42
};

struct alignas(64) Block {
  Value entries[kEntries][kPerBlock];
};

// Three numbers of each of the joints, that follow each other in x.
template <class T>
ADAGEN_INLINE Vector<T> each_vector(const Joints<T>& joints, const Value* x,
                                    int JointConstants::* place) {
  const auto number = [&](int k) {
    return each(joints, [&](const JointConstants& own) { return x[own.*place + k]; });
  };
  return {number(0), number(1), number(2)};
}

// Whether a joint between moving links is of a kind; one on the ground that floats needs nothing.
[[maybe_unused]] constexpr bool any_of(JointKind kind) {
  for (const JointConstants& joint : kJoints)
    if (joint.kind == kind && (joint.parent > 0 || kind != JointKind::kFloating)) return true;
  return false;
}
// Asked once each, not where templates use it: g++ takes time quadratic in the joints there.
[[maybe_unused]] constexpr bool kAnyPrismatic = any_of(JointKind::kPrismatic);
[[maybe_unused]] constexpr bool kAnySpherical = any_of(JointKind::kSpherical);
[[maybe_unused]] constexpr bool kAnyPlanar = any_of(JointKind::kPlanar);
[[maybe_unused]] constexpr bool kAnyFloating = any_of(JointKind::kFloating);
[[maybe_unused]] constexpr bool any_passive() {
  for (const JointConstants& joint : kJoints) {
    const Passive& own = joint.passive;
    if (own.damping != 0 || own.friction != 0 || own.stiffness != 0 || own.rotor != 0) return true;
  }
  return false;
}
[[maybe_unused]] constexpr bool kAnyPassive = any_passive();

// Whether a joint's axis lies beside what it is treated with, and not with those of its block.
template <class T>
constexpr bool kWithAxis = kByColumns && kWidth<T> == 1;
// Of a joint with one freedom: U / D (6), u / D, 1 / D; of others see inward.hpp.
constexpr int kMostFactors = kAnyPlanar ? 24 : kAnySpherical ? 18 : 8;

// What is kept of a joint from the inward to the outward sweep.
template <class T, bool with_axis = kWithAxis<T>>
struct Eliminated {
  Vector<T> r;  // from the parent link's origin to the child link's
  T e[kMostFactors];
};
template <class T>
struct alignas(64) Eliminated<T, true> {
  Vector<T> axis;
  T none;  // so that axis and r lie as the halves of a column
  Vector<T> r;
  T nothing;
  T e[kMostFactors];
};
using Memory = Eliminated<Value>;

// A bare link as it is added to columns (see inward_columns.hpp).
struct alignas(64) LinkColumns {
  Real tensor[8], moments[8], force[8];
};

// A link's orientation and how it moves, were all joint accelerations zero.
template <class T>
struct Frame {
  Matrix<T> R;
  Vector<T> omega, alpha, a;
};

struct Workspace : State, Cuts, Inertias {
  int status = kFine;
  bool lost = false;   // whether a sweep in axes of the base found too few digits left
  bool again = false;  // whether links feel the forces in their blocks, and no motion's
  alignas(64) std::array<Value, kBlockCount * kPerBlock> angle{};  // of each joint that turns
  std::array<Block, kBlockCount> blocks{};
  std::array<Memory, kJointCount> joints{};
  std::array<Eliminated<Two>, kAbreast ? kSlotCount / 2 : 0> twos{};  // of joints in lanes, by slot
  std::array<Eliminated<Four>, kAbreast ? kSlotCount / 4 : 0> fours{};
  // Of the link beyond each joint, and one for slots that are not filled.
  std::array<LinkColumns, kByColumns ? kJointCount + 1 : 0> columns{};
  std::array<Body<Value>, kLinkCount> bodies{};     // what hangs on a link, where paths meet
  std::array<Motion<Value>, kLinkCount> motions{};  // accelerations beyond those of a Frame
  std::array<Value, kNv> answer{};
  std::array<Body<Value>, kPassesFree ? kJointCount : 0> free{};  // beyond floating joints
  std::array<Body<Value>, kRefine ? kJointCount : 0> whole{};  // beyond each joint, to be refined

  Workspace() {
    for (Block& block : blocks)  // slots that are not filled do not turn
      for (const int k : {0, 4, 8}) std::fill_n(block.entries[kTurn + k], kPerBlock, Value{} + 1);
    for (int j = 0; j < kJointCount; ++j)  // what an angle does not change stays as it is
      for (int k = 0; k < 9; ++k)
        of(j, kTurn)[k * kPerBlock] = Value{} + kJoints[static_cast<std::size_t>(j)].rotation[k];
  }

  Value* of(int joint, Entry entry) { return at(slot_of(joint), entry); }
  Value* at(int slot, Entry entry) {
    return &blocks[static_cast<std::size_t>(slot / kPerBlock)].entries[entry][slot % kPerBlock];
  }

  template <class T>
  Eliminated<T>& memory(const Joints<T>& of) {
    if constexpr (kWidth<T> == 1)
      return joints[static_cast<std::size_t>(of.joint[0])];
    else if constexpr (kWidth<T> == 2)
      return twos[static_cast<std::size_t>(of.slot / 2)];
    else
      return fours[static_cast<std::size_t>(of.slot / 4)];
  }
};

template <class T = Value>
ADAGEN_INLINE T number_at(const Value* x) {
  T result;
  std::memcpy(&result, x, sizeof result);
  return result;
}
template <class T>
ADAGEN_INLINE void put_at(Value* x, const T& number) {
  std::memcpy(x, &number, sizeof number);
}
template <class T = Value>
ADAGEN_INLINE Vector<T> vector_at(const Value* x, int stride = kPerBlock) {
  return {number_at<T>(x), number_at<T>(x + stride), number_at<T>(x + 2 * stride)};
}
template <class T>
ADAGEN_INLINE void put_at(Value* x, const Vector<T>& a) {
  put_at(x, a.x), put_at(x + kPerBlock, a.y), put_at(x + 2 * kPerBlock, a.z);
}
template <class T = Value>
ADAGEN_INLINE Matrix<T> matrix_at(const Value* x) {
  return {vector_at<T>(x), vector_at<T>(x + 3 * kPerBlock), vector_at<T>(x + 6 * kPerBlock)};
}
template <class T>
ADAGEN_INLINE void put_at(Value* x, const Matrix<T>& m) {
  put_at(x, m.x), put_at(x + 3 * kPerBlock, m.y), put_at(x + 6 * kPerBlock, m.z);
}
template <class T = Value>
ADAGEN_INLINE Vector<T> axis_at(const Value* R) {
  return vector_at<T>(R + 2 * kPerBlock, 3 * kPerBlock);
}
template <class T>
ADAGEN_INLINE Vector<T> axis_of(Workspace& w, const Joints<T>& joints) {
  if constexpr (kWithAxis<T>)
    return w.memory(joints).axis;
  else
    return axis_at<T>(w.at(joints.slot, kAxes));
}

// A body in a message.
[[maybe_unused]] constexpr int kBodyNumbers = 27;
template <class T>
ADAGEN_INLINE Number* put(Number* to, const Body<T>& X) {
  static_assert(sizeof X == kBodyNumbers * sizeof(Real));
  Real numbers[kBodyNumbers];
  std::memcpy(numbers, &X, sizeof X);
  return std::copy_n(numbers, kBodyNumbers, to);
}
template <class T>
ADAGEN_INLINE const Number* get(const Number* from, Body<T>& X) {
  Real numbers[kBodyNumbers];
  std::copy_n(from, kBodyNumbers, numbers);
  std::memcpy(&X, numbers, sizeof X);
  return from + kBodyNumbers;
}
template <class T>
ADAGEN_INLINE const Number* add(const Number* from, Body<T>& X) {
  Body<T> other;
  from = get(from, other);
  X += other;
  return from;
}

ADAGEN_INLINE Lanes wide(const Value* x) {
  Lanes result;
  std::memcpy(&result, x, sizeof result);
  return result;
}

// The torque along one of a joint's freedoms that reaches the links: less damping, spring and
// friction.
ADAGEN_INLINE Value torque(const Workspace& w, const JointConstants& joint, int freedom = 0) {
  Value tau = w.tau[joint.v + freedom];
  if constexpr (kAnyPassive) {
    const Passive& own = joint.passive;
    const Value& qd = w.v[joint.v + freedom];
    if (own.damping != 0) tau -= own.damping * qd;
    if (own.stiffness != 0 && !(kAgain && w.again))
      tau -= own.stiffness * (w.q[joint.q] - own.rest);
    if (own.friction != 0) tau -= own.friction * hyperbolic_tangent(qd / own.friction_speed);
  }
  return tau;
}

// A joint of prescribed motion among limbs side by side gives way to nothing and moves as told.
ADAGEN_INLINE Real immovable(const JointConstants& joint) {
  return joint.passive.prescribed ? std::numeric_limits<Real>::infinity() : 0;
}
ADAGEN_INLINE Value prescribed(const Workspace& w, const JointConstants& joint) {
  return joint.passive.prescribed ? w.tau[joint.v] : Value{};
}

// Accelerations are given only where all went well.
inline void give(Workspace& w, int first, int count) {
  if (w.status == kFine)
    std::copy_n(&w.answer[static_cast<std::size_t>(first)], count, w.qdd + first);
}

[[maybe_unused]] constexpr int block(int joint) { return joint / kPerBlock; }
[[maybe_unused]] constexpr bool is_identity(const Number (&R)[9]) {
  for (int k = 0; k < 9; ++k)
    if (R[k] != (k % 4 == 0 ? 1 : 0)) return false;
  return true;
}

inline double gravity(const Workspace&, int k) { return kGravity[static_cast<std::size_t>(k)]; }

// What cannot be solved is refused, with the joint at fault.

// D beside the trace of what it is found in: less than this is rounding and nothing else.
constexpr Real kLeast = 16 * std::numeric_limits<Real>::epsilon();

// Less than this calls for the joint's own axes, where there is a way to take them: a sweep in axes
// of the base loses as many digits as D is smaller than the trace.
constexpr Real kEnough = kAnyTurnedIfLost ? Real(1 / kLosing) : kLeast;

ADAGEN_COLD inline void fail(Workspace& w, Failure kind, int joint) {
  Channel::fail(w.status, failure(kind, joint));
}

// x - x is zero, in all bits, for finite x only.
ADAGEN_INLINE LaneBits unlike_zero(const Value* x) {
  return reinterpret_cast<LaneBits>(wide(x) - wide(x));
}
ADAGEN_INLINE bool finite(const Value* x, int count) {
  LaneBits found{};
  int k = 0;
  for (; k + kPerBlock <= count; k += kPerBlock) found |= unlike_zero(x + k);
  if (k > 0 && k < count)
    found |= unlike_zero(x + count - kPerBlock);  // some of them once more
  else
    for (; k < count; ++k)
      if (!all_zero(x[k] - x[k])) return false;
  return !any_of(found);
}

// Tells which of entries first .. is the first that is not finite; place says where a joint's
// entries start.
ADAGEN_COLD inline void refuse(Workspace& w, const Value* x, int first, int JointConstants::* place,
                               Failure kind) {
  while (finite(x + first, 1)) ++first;
  int joint = 0;
  for (int j = 0; j < kJointCount; ++j)
    if (kJoints[static_cast<std::size_t>(j)].*place <= first) joint = j;
  fail(w, kind, joint);
}

// Refuses entries first .. first + count - 1 of the state, or of the answer, if one is not finite.
inline void require_finite(Workspace& w, const Value* x, int first, int count,
                           int JointConstants::* place, Failure kind) {
  if (__builtin_expect(!finite(x + first, count), 0)) refuse(w, x, first, place, kind);
}

// Whether nothing failed, and entries first .. first + count - 1 of the answer are finite.
ADAGEN_INLINE bool went_well(const Workspace& w, int first, int count) {
  return __builtin_expect(
      w.status == kFine && finite(&w.answer[static_cast<std::size_t>(first)], count), 1);
}

template <class T>
ADAGEN_INLINE bool has_length(const T& squared) {
  return all_positive(squared - std::numeric_limits<Real>::min()) &&
         all_positive(std::numeric_limits<Real>::max() - squared);
}
template <class T>
void require_length(Workspace& w, const T& squared, int joint) {
  if (!has_length(squared)) fail(w, kZeroQuaternion, joint);
}

// An elimination failed for one of the joints: for that whose number is not positive.
template <class T>
ADAGEN_COLD void fail_one(Workspace& w, const Joints<T>& joints, [[maybe_unused]] const T& x) {
  int lane = 0;
  if constexpr (kWidth < T >> 1)
    while (lane + 1 < kWidth<T> && x[lane] > 0) ++lane;
  fail(w, kFactorization, joints.joint[lane]);
}

// D is less than enough beside the trace of what it is found in, for one of the joints at least:
// its sweep is repeated in other axes, or fails where that is no way and nothing but rounding is
// left.
template <class T>
ADAGEN_COLD void lose(Workspace& w, const Joints<T>& joints, const T& D, const T& trace) {
  for (std::size_t lane = 0; lane < kWidth<T>; ++lane) {
    Value own = Value{}, whole = Value{};
    if constexpr (kWidth<T> == 1)
      own = D, whole = trace;
    else
      own = D[lane], whole = trace[lane];
    const int j = joints.joint[lane];
    if (kAnyTurnedIfLost && kTurnedIfLost[j])
      w.lost |= !all_positive(own - kEnough * whole);
    else if (!all_positive(own - kLeast * whole))
      fail(w, kFactorization, j);
  }
}

// Loops over rows of joints: a run's joints, or those of limbs side by side, of one kind each.
// Where few stretches of one kind follow each other, each is a loop of its own that knows its kind.
template <int first, int last>
struct RunRows {
  static constexpr int kCount = last - first + 1;
  static constexpr JointKind kind(int k) {
    return kJoints[static_cast<std::size_t>(first + k)].kind;
  }
};

constexpr int kMostStretches = 8;

// Where the stretch ends that begins with the k-th row of an order.
template <class Rows, bool backwards>
constexpr int end_of_stretch(int k) {
  const auto kind = [](int i) { return Rows::kind(backwards ? Rows::kCount - 1 - i : i); };
  int end = k + 1;
  while (end < Rows::kCount && kind(end) == kind(k)) ++end;
  return end;
}
template <class Rows>
constexpr bool few_stretches() {
  int count = 0;
  for (int k = 0; k < Rows::kCount; ++count) k = end_of_stretch<Rows, false>(k);
  return count <= kMostStretches;
}

// Calls step(row, kind) for each row, the last one first if backwards.
template <class Rows, bool backwards, int begin = 0, class Step>
ADAGEN_INLINE void each_row(const Step& step) {
  constexpr auto row = [](int k) { return backwards ? Rows::kCount - 1 - k : k; };
  if constexpr (few_stretches<Rows>()) {
    constexpr int end = end_of_stretch<Rows, backwards>(begin);
    constexpr std::integral_constant<JointKind, Rows::kind(row(begin))> kind;
    for (int k = begin; k < end; ++k) step(row(k), kind);
    if constexpr (end < Rows::kCount) each_row<Rows, backwards, end>(step);
  } else {
    for (int k = 0; k < Rows::kCount; ++k) step(row(k), Rows::kind(row(k)));
  }
}

// What needs no recursion, for as many links at once as a register holds.

// Constants of each of the joints.
template <class T>
ADAGEN_INLINE T constant(const Joints<T>& joints, PerJoint BlockConstants::* member) {
  const auto& block = kBlockConstants[static_cast<std::size_t>(joints.slot / kPerBlock)];
  return number_at<T>(&(block.*member)[static_cast<std::size_t>(joints.slot % kPerBlock)]);
}
template <class T>
ADAGEN_INLINE auto mass_of(const Workspace& w, const Joints<T>& joints) {
  if constexpr (kWidth<T> == 1)
    return w.inertia_of(joints.joint[0]).mass;
  else
    return number_at<T>(&w.constants_of(joints.slot / kPerBlock)
                             .mass[static_cast<std::size_t>(joints.slot % kPerBlock)]);
}
template <class T>
ADAGEN_INLINE auto origin_of(const Joints<T>& joints) {
  if constexpr (kWidth<T> == 1) {
    const Number* const x = joints.any().translation;
    return Vector<Real>{Real(x[0]), Real(x[1]), Real(x[2])};
  } else {
    return Vector<T>{constant(joints, &BlockConstants::x), constant(joints, &BlockConstants::y),
                     constant(joints, &BlockConstants::z)};
  }
}

ADAGEN_INLINE Lanes wide(const PerJoint& x) {
  Lanes result;
  if constexpr (sizeof(PerJoint) == sizeof(Lanes))
    std::memcpy(&result, x.data(), sizeof result);
  else
    result = x[0] + Lanes{};
  return result;
}
ADAGEN_INLINE void narrow(const Lanes& x, Value* to) { std::memcpy(to, &x, sizeof x); }
ADAGEN_INLINE Vector<Lanes> wide_vector(const Value (*x)[kPerBlock]) {
  return {wide(x[0]), wide(x[1]), wide(x[2])};
}
ADAGEN_INLINE Vector<Lanes> wide_vector(const PerJoint* x) {
  return {wide(x[0]), wide(x[1]), wide(x[2])};
}
ADAGEN_INLINE void narrow(const Vector<Lanes>& a, Value (*x)[kPerBlock]) {
  narrow(a.x, x[0]), narrow(a.y, x[1]), narrow(a.z, x[2]);
}

// Copies the angles of those of joints first .. last that turn.
template <int first, int last>
void take_angles(Workspace& w) {
  ADAGEN_FOR (j, first, last + 1) {
    const JointConstants& joint = kJoints[static_cast<std::size_t>(j)];
    const int place = joint.q + (joint.kind == JointKind::kPlanar ? 2 : 0);
    if (joint.kind == JointKind::kRevolute || joint.kind == JointKind::kPlanar)
      w.angle[static_cast<std::size_t>(slot_of(j))] = w.q[place];
  }
}

// Turns the joints of blocks first .. last - 1 by their angles: columns x and y of the rotation.
template <int first, int last>
void turn(Workspace& w) {
  for (int b = first; b < last; ++b) {
    Block& block = w.blocks[static_cast<std::size_t>(b)];
    const BlockConstants& constants = kBlockConstants[static_cast<std::size_t>(b)];
    Lanes s, c;
    sine_and_cosine(wide(&w.angle[static_cast<std::size_t>(b * kPerBlock)]), s, c);
    ADAGEN_FOR (k, 0, 3) {
      const Lanes x = wide(constants.rotation[k]), y = wide(constants.rotation[3 + k]);
      narrow(x * c + y * s, block.entries[kTurn + 3 * k]);
      narrow(y * c - x * s, block.entries[kTurn + 3 * k + 1]);
    }
  }
}

// The bias force of a bare link of pseudo-inertia J and moments c about its origin: that of the
// acceleration field a + H x, H = alpha x + omega x omega x. All in the same axes.
template <class T>
ADAGEN_INLINE void bias_force(const Symmetric<T>& J, const Vector<T>& c, const T& mass,
                              const Vector<T>& w, const Vector<T>& al, const Vector<T>& a,
                              Vector<T>& n, Vector<T>& f) {
  const T xx = w.x * w.x, yy = w.y * w.y, zz = w.z * w.z;
  const T xy = w.x * w.y, xz = w.x * w.z, yz = w.y * w.z;
  const Matrix<T> H{{-(yy + zz), xy - al.z, xz + al.y},
                    {xy + al.z, -(xx + zz), yz - al.x},
                    {xz - al.y, yz + al.x, -(xx + yy)}};
  const Vector<T> Jx{J.xx, J.xy, J.xz}, Jy{J.xy, J.yy, J.yz}, Jz{J.xz, J.yz, J.zz};
  n = cross(c, a);
  n += Vector<T>{dot(H.z, Jy) - dot(H.y, Jz), dot(H.x, Jz) - dot(H.z, Jx),
                 dot(H.y, Jx) - dot(H.x, Jy)};
  f = a * mass + H * c;
}

// Inertia and bias force of the bare links of blocks first .. last - 1 in the axes of their base.
// With the pseudo-inertia J = sum of m x x^T about the link's origin, A = tr(J) 1 - J.
template <int first, int last>
void set_up_links(Workspace& w) {
  for (int b = first; b < last; ++b) {
    Block& block = w.blocks[static_cast<std::size_t>(b)];
    const BlockConstants& constants = w.constants_of(b);
    const auto& entries = block.entries;
    const Matrix<Lanes> R{wide_vector(entries + kAxes), wide_vector(entries + kAxes + 3),
                          wide_vector(entries + kAxes + 6)};
    const Symmetric<Lanes> T{wide(constants.tensor[0]), wide(constants.tensor[1]),
                             wide(constants.tensor[2]), wide(constants.tensor[3]),
                             wide(constants.tensor[4]), wide(constants.tensor[5])};
    const Matrix<Lanes> RT{T * R.x, T * R.y, T * R.z};  // rows of R T
    const Symmetric<Lanes> J{dot(RT.x, R.x), dot(RT.x, R.y), dot(RT.x, R.z),
                             dot(RT.y, R.y), dot(RT.y, R.z), dot(RT.z, R.z)};
    narrow(J.yy + J.zz, block.entries[kRotational]);
    narrow(-J.xy, block.entries[kRotational + 1]);
    narrow(-J.xz, block.entries[kRotational + 2]);
    narrow(J.xx + J.zz, block.entries[kRotational + 3]);
    narrow(-J.yz, block.entries[kRotational + 4]);
    narrow(J.xx + J.yy, block.entries[kRotational + 5]);
    const Vector<Lanes> c = R * wide_vector(constants.moments);
    narrow(c, block.entries + kMoments);

    Vector<Lanes> n, f;
    bias_force(J, c, wide(constants.mass), wide_vector(entries + kOmega),
               wide_vector(entries + kAlpha), wide_vector(entries + kAcceleration), n, f);
    narrow(n, block.entries + kTorque);
    narrow(f, block.entries + kForce);
  }
}

// From the base outwards: where links are and how they would move without joint accelerations.

ADAGEN_INLINE Frame<Value> frame_of(Workspace& w, int joint) {
  const Value* R = w.of(joint, kAxes);
  return {matrix_at(R), vector_at(w.of(joint, kOmega)), vector_at(w.of(joint, kAlpha)),
          vector_at(w.of(joint, kAcceleration))};
}

template <class T>
ADAGEN_INLINE void keep(Workspace& w, int slot, const Frame<T>& frame) {
  put_at(w.at(slot, kAxes), frame.R);
  put_at(w.at(slot, kOmega), frame.omega);
  put_at(w.at(slot, kAlpha), frame.alpha);
  put_at(w.at(slot, kAcceleration), frame.a);
}

// The ground accelerates against gravity: accelerations are relative to free fall.
ADAGEN_INLINE Frame<Value> ground(const Workspace& w) {
  const Value one = Value{} + 1, none{};
  return {{{one, none, none}, {none, one, none}, {none, none, one}},
          {none, none, none},
          {none, none, none},
          {none - Real(gravity(w, 0)), none - Real(gravity(w, 1)), none - Real(gravity(w, 2))}};
}

// The axes of a floating base are the link's own: only gravity is turned.
template <int j>
void free_base_frame(Workspace& w) {
  constexpr const JointConstants& joint = kJoints[j];
  const Value* q = w.q + joint.q + 3;
  Matrix<Value> turn;
  require_length(w, rotation(q[0], q[1], q[2], q[3], turn), j);
  Frame<Value> frame = ground(w);
  const Vector<Real> down{Real(gravity(w, 0)), Real(gravity(w, 1)), Real(gravity(w, 2))};
  const Number* const P = joint.rotation;
  const auto along = [&](int k) {
    return Real(P[k] * down.x + P[3 + k] * down.y + P[6 + k] * down.z);
  };
  const Vector<Real> fixed{along(0), along(1), along(2)};
  const Value none{};
  frame.a = -transposed_times(turn, Vector<Value>{none + fixed.x, none + fixed.y, none + fixed.z});
  const Value* v = w.v + joint.v + 3;
  frame.omega = {v[0], v[1], v[2]};
  keep(w, slot_of(j), frame);
}

ADAGEN_INLINE Matrix<Real> placement(const JointConstants& joint) {
  const auto row = [P = joint.rotation](int k) {
    return Vector<Real>{Real(P[k]), Real(P[k + 1]), Real(P[k + 2])};
  };
  return {row(0), row(3), row(6)};
}

// One joint, or one in each lane, outwards from the parent link's frame; what a joint is treated
// with later is kept.
template <bool kept, class T>
ADAGEN_INLINE void step_outward(Workspace& w, const Joints<T>& joints, JointKind kind,
                                Frame<T>& at) {
  const JointConstants& joint = joints.any();
  const auto moved = [&](const Value* x, int JointConstants::* place) {
    return each(joints, [&](const JointConstants& own) { return x[own.*place]; });
  };
  const Matrix<T> R = at.R * matrix_at<T>(w.at(joints.slot, kTurn));
  const Vector<T> axis{R.x.z, R.y.z, R.z.z};
  Vector<T> r = at.R * origin_of(joints);
  const Vector<T> omega = at.omega;
  const auto turn_with = [&](const Vector<T>& relative) {
    at.omega += relative;
    return cross(omega, relative);
  };
  const auto ride_along = [&] {
    at.a += cross(omega, cross(omega, r));
    at.a += cross(at.alpha, r);
  };
  const auto slide_and_spin = [&](const Vector<T>& q, const Vector<T>& slide,
                                  const Vector<T>& spin) {
    const Matrix<Real> P = placement(joint);
    r += at.R * Vector<T>{dot(q, P.x), dot(q, P.y), dot(q, P.z)};
    ride_along();
    at.a += cross(omega + omega + spin, slide);
    at.alpha += turn_with(spin);
  };
  switch (kind) {
    case JointKind::kRevolute:
      ride_along();
      at.alpha += turn_with(axis * moved(w.v, &JointConstants::v));
      break;
    case JointKind::kPrismatic: {
      r += axis * moved(w.q, &JointConstants::q);
      ride_along();
      const T v = moved(w.v, &JointConstants::v);
      at.a += cross(omega, axis * (v + v));
      break;
    }
    case JointKind::kSpherical:
      ride_along();
      if constexpr (kAnySpherical)
        at.alpha += turn_with(R * each_vector(joints, w.v, &JointConstants::v));
      break;
    case JointKind::kPlanar:
      if constexpr (kAnyPlanar && kWidth<T> == 1) {
        const Value *q = w.q + joint.q, *v = w.v + joint.v;
        const Vector<T> x{R.x.x, R.y.x, R.z.x}, y{R.x.y, R.y.y, R.z.y};
        slide_and_spin(Vector<T>{q[0], q[1], T{}}, x * v[0] + y * v[1], axis * v[2]);
      }
      break;
    case JointKind::kFloating:
      if constexpr (kAnyFloating && kWidth<T> == 1) {
        const Value *q = w.q + joint.q, *v = w.v + joint.v;
        slide_and_spin(Vector<T>{q[0], q[1], q[2]}, R * Vector<T>{v[0], v[1], v[2]},
                       R * Vector<T>{v[3], v[4], v[5]});
      }
      break;
  }
  at.R = R;
  if constexpr (!kept) return;
  w.memory(joints).r = r;
  if constexpr (kWithAxis<T>) w.memory(joints).axis = axis;
  keep(w, joints.slot, at);
}

// The frame of the link that a joint is on.
template <int j>
ADAGEN_INLINE Frame<Value> frame_near(Workspace& w) {
  constexpr int parent = kJoints[j].parent - 1;
  return parent < 0 ? ground(w) : frame_of(w, parent < 0 ? 0 : parent);
}

// Joints first .. last, each on the link of the one before.
template <int first, int last>
void outward(Workspace& w) {
  Frame<Value> at = frame_near<first>(w);
  each_row<RunRows<first, last>, false>(
      [&](int k, auto kind) ADAGEN_ALWAYS { step_outward<true>(w, single(first + k), kind, at); });
}

// The same on the way to joints that are treated: only the last link's frame is kept.
template <int first, int last>
void pass_outward(Workspace& w) {
  Frame<Value> at = frame_near<first>(w);
  each_row<RunRows<first, last>, false>(
      [&](int k, auto kind) ADAGEN_ALWAYS { step_outward<false>(w, single(first + k), kind, at); });
  keep(w, slot_of(last), at);
}

// Without refinement nothing is kept of joints' forces.
template <class T, class X>
ADAGEN_INLINE void keep_body(Workspace&, const Joints<T>&, const X&) {}
template <bool reversed, class T>
ADAGEN_INLINE void keep_force(Workspace&, const Joints<T>&, const Motion<T>&) {}
template <class T>
ADAGEN_INLINE void keep_load(Workspace&, int, const T&, const T&) {}
[[maybe_unused]] inline void keep_side(Workspace&, std::size_t) {}

// Symmetric matrices of three rows, eliminated.

// The factors 1 / D and L of A = L D L^T: 0 1 2, 10 20 21. Without fractions (Bareiss) the three
// divisions need not wait for each other: with m = xx yy - xy^2 and so on the pivots are xx, m / xx
// and (m m' - t^2) / (xx m), as exact as by turns while fourth powers of A keep their digits: in
// float they would not. All numbers that checks gets are positive if A could be factorized.
template <class T>
ADAGEN_INLINE void factorize(const Symmetric<T>& A, T* factors, T (&checks)[4]) {
  using Limits = std::numeric_limits<Real>;
  T* const l = factors + 3;
  const T d0 = 1 / A.xx;
  l[0] = A.xy * d0, l[1] = A.xz * d0;
  T p1, p2;
  if constexpr (Limits::min_exponent10 < -300) {
    const T m = A.xx * A.yy - A.xy * A.xy, t = A.xx * A.yz - A.xy * A.xz;
    p1 = m, p2 = m * (A.xx * A.zz - A.xz * A.xz) - t * t;
    const T inverse = 1 / m;
    factors[1] = A.xx * inverse, factors[2] = A.xx * m / p2;
    l[2] = t * inverse;
    checks[2] = p2 - Limits::min() / Limits::epsilon();
  } else {
    const T t = A.yz - l[1] * A.xy;
    p1 = A.yy - l[0] * A.xy;
    factors[1] = 1 / p1, l[2] = t * factors[1];
    p2 = A.zz - l[1] * A.xz - l[2] * t;
    factors[2] = 1 / p2;
    checks[2] = p2;
  }
  factors[0] = d0;
  checks[0] = A.xx, checks[1] = p1, checks[3] = Limits::max() - p2;
}

// A^-1 b, by the factors of A.
template <class F, class T>
ADAGEN_INLINE Vector<T> solved(const F* factors, const Vector<T>& b) {
  const F *d = factors, *l = factors + 3;
  const T y1 = b.y - l[0] * b.x, y2 = b.z - l[1] * b.x - l[2] * y1;
  const T z = y2 * d[2], y = y1 * d[1] - l[2] * z;
  return {b.x * d[0] - l[0] * y - l[1] * z, y, z};
}

// C becomes C - B^T A^-1 B, by the factors of A; returns A^-1 B. With L Y = B what is subtracted is
// Y^T D^-1 Y, which waits for no more than the last division.
template <class T>
ADAGEN_INLINE Matrix<T> complement(Symmetric<T>& C, const Matrix<T>& B, const T* factors) {
  const T *d = factors, *l = factors + 3;
  const Vector<T> Yx = B.x, Yy = B.y - B.x * l[0], Yz = (B.z - B.x * l[1]) - Yy * l[2];
  const Vector<T> Zx = Yx * d[0], Zy = Yy * d[1], Zz = Yz * d[2];
  using V = Vector<T>;
  const auto subtract = [&](T& c, T V::* i, T V::* k) ADAGEN_ALWAYS {
    c = ((c - Yx.*i * Zx.*k) - Yy.*i * Zy.*k) - Yz.*i * Zz.*k;
  };
  subtract(C.xx, &V::x, &V::x), subtract(C.xy, &V::x, &V::y), subtract(C.xz, &V::x, &V::z);
  subtract(C.yy, &V::y, &V::y), subtract(C.yz, &V::y, &V::z), subtract(C.zz, &V::z, &V::z);
  const Vector<T> Ky = Zy - Zz * l[2];
  return {(Zx - Zz * l[1]) - Ky * l[0], Ky, Zz};
}

// Spherical joints: three rotations at once. Damping and a rotor are the same about all axes.
[[maybe_unused]] constexpr bool any_spherical_rotor() {
  for (const JointConstants& joint : kJoints)
    if (joint.kind == JointKind::kSpherical && joint.passive.rotor != 0) return true;
  return false;
}
[[maybe_unused]] constexpr bool kSphericalRotors = any_spherical_rotor();

// The torque that reaches the links, in the child link's axes: less damping.
template <class T>
ADAGEN_INLINE Vector<T> spherical_torque(const Workspace& w, const Joints<T>& joints) {
  const Vector<T> tau = each_vector(joints, w.tau, &JointConstants::v);
  if constexpr (!kAnyPassive) return tau;
  const T damping = each(joints, [](const JointConstants& own) { return own.passive.damping; });
  return tau - each_vector(joints, w.v, &JointConstants::v) * damping;
}

template <class T>
ADAGEN_INLINE T rotor_of(const Joints<T>& joints) {
  return each(joints, [](const JointConstants& own) { return own.passive.rotor; });
}

template <class T>
ADAGEN_INLINE Symmetric<T> with_rotor(Symmetric<T> A, const T& rotor) {
  A.xx += rotor, A.yy += rotor, A.zz += rotor;
  return A;
}

// Takes the three rotations out of the body at the joint's origin: what is left of it is C and f,
// and the torque, so that no rounding stays behind. e gets K = A^-1 B, y = A^-1 (torque - n) and
// the factors of A. With a rotor J, which is the same about all axes, A + J is in the place of A
// there, and J K, J (A + J)^-1 A and torque - J y are left, too.
template <bool reversed, class T>
ADAGEN_INLINE void take_out_rotations(Workspace& w, const Joints<T>& joints, Body<T>& X) {
  T* const e = w.memory(joints).e;
  Vector<T> torque = matrix_at<T>(w.at(joints.slot, kAxes)) * spherical_torque(w, joints);
  if constexpr (reversed) torque = -torque;
  T* const factors = e + 12;
  T checks[4];
  const T rotor = rotor_of(joints);
  factorize(kSphericalRotors ? with_rotor(X.A, rotor) : X.A, factors, checks);
  for (const T& check : checks)
    if (__builtin_expect(!all_positive(check), 0)) fail_one(w, joints, check);
  const Matrix<T>& B = X.B;
  const Matrix<T> K = complement(X.C, B, factors);
  const Vector<T> y = solved(factors, torque - X.n);
  e[0] = K.x.x, e[1] = K.x.y, e[2] = K.x.z, e[3] = K.y.x, e[4] = K.y.y, e[5] = K.y.z;
  e[6] = K.z.x, e[7] = K.z.y, e[8] = K.z.z, e[9] = y.x, e[10] = y.y, e[11] = y.z;
  X.f += transposed_times(B, y);
  X.n = torque;
  if constexpr (kSphericalRotors) {
    const Symmetric<T>& A = X.A;
    const Vector<T> x = solved(factors, Vector<T>{A.xx, A.xy, A.xz});
    const Vector<T> z = solved(factors, Vector<T>{A.xz, A.yz, A.zz});
    const T yy = solved(factors, Vector<T>{A.xy, A.yy, A.yz}).y;
    X.A = {x.x * rotor, x.y * rotor, x.z * rotor, yy * rotor, z.y * rotor, z.z * rotor};
    X.B = {K.x * rotor, K.y * rotor, K.z * rotor};
    X.n += -(y * rotor);
  } else {
    X.A = Symmetric<T>{}, X.B = Matrix<T>{};
  }
}

// The same, from the far link's side to the near link's origin.
template <bool reversed, class T>
ADAGEN_INLINE void eliminate_rotations(Workspace& w, const Joints<T>& joints, Body<T>& X) {
  const Vector<T>& r = w.memory(joints).r;
  if constexpr (reversed) shift(X, -r);
  take_out_rotations<reversed>(w, joints, X);
  if constexpr (!reversed && kSphericalRotors) shift(X, r);
  if constexpr (!reversed && !kSphericalRotors) shift_mass(X, r);
}

// Whether joints first .. last leave of a body no more than its mass.
[[maybe_unused]] constexpr bool leave_mass_alone(int first, int last) {
  for (int j = first; j <= last; ++j)
    if (kJoints[j].kind != JointKind::kSpherical) return false;
  return !kSphericalRotors;
}

// Inwards in the links' own axes, where axes of the base would cost digits: S is a coordinate axis
// there, D an entry of the body, and what is left along S exactly zero. Links beyond joints of
// kTurned have their bodies told so, each about its own origin as all are. Joints of kTurnedIfLost
// are so only where a sweep found too few digits left and is repeated: lost is true then.
template <bool lost = false>
ADAGEN_INLINE constexpr bool turned(int j) {
  return (kAnyTurned && kTurned[j]) || (lost && kTurnedIfLost[j]);
}
template <bool lost = false>
ADAGEN_INLINE constexpr bool turned_link(int link) {
  return link > 0 && turned<lost>(link - 1);
}

// R M R^T.
template <class T, class S>
ADAGEN_INLINE Symmetric<T> congruent(const Matrix<S>& R, const Symmetric<T>& M) {
  const Vector<T> x = M * R.x, y = M * R.y, z = M * R.z;
  return {dot(x, R.x), dot(x, R.y), dot(x, R.z), dot(y, R.y), dot(y, R.z), dot(z, R.z)};
}
template <class T>
ADAGEN_INLINE Matrix<T> transposed(const Matrix<T>& m) {
  return {{m.x.x, m.y.x, m.z.x}, {m.x.y, m.y.y, m.z.y}, {m.x.z, m.y.z, m.z.z}};
}
// A body in the axes that R takes it to.
template <class T>
ADAGEN_INLINE void turn_body(Body<T>& X, const Matrix<T>& R) {
  X.A = congruent(R, X.A), X.C = congruent(R, X.C);
  X.B = R * X.B * transposed(R);
  X.n = R * X.n, X.f = R * X.f;
}

// From the axes that a link's body is told in to those of the base, and back.
template <bool lost = false>
ADAGEN_INLINE void to_base(Workspace& w, int link, Body<Value>& X) {
  if (turned_link<lost>(link)) turn_body(X, matrix_at(w.of(link - 1, kAxes)));
}
template <bool lost = false>
ADAGEN_INLINE void from_base(Workspace& w, int link, Body<Value>& X) {
  if (turned_link<lost>(link)) turn_body(X, transposed(matrix_at(w.of(link - 1, kAxes))));
}

// Mass, its moments and the pseudo-inertia of the links beyond joints.
template <class T>
ADAGEN_INLINE void own_inertia(const Workspace& w, const Joints<T>& joints, T& mass, Vector<T>& c,
                               Symmetric<T>& J) {
  if constexpr (kWidth<T> == 1) {
    const LinkInertia& link = w.inertia_of(joints.joint[0]);
    const auto x = [](Real number) { return T{} + number; };
    mass = x(link.mass);
    c = {x(link.moments[0]), x(link.moments[1]), x(link.moments[2])};
    J = {x(link.tensor[0]), x(link.tensor[1]), x(link.tensor[2]),
         x(link.tensor[3]), x(link.tensor[4]), x(link.tensor[5])};
  } else {
    const auto& block = w.constants_of(joints.slot / kPerBlock);
    const auto x = [&](const PerJoint& numbers) {
      return number_at<T>(&numbers[static_cast<std::size_t>(joints.slot % kPerBlock)]);
    };
    mass = x(block.mass);
    c = {x(block.moments[0]), x(block.moments[1]), x(block.moments[2])};
    J = {x(block.tensor[0]), x(block.tensor[1]), x(block.tensor[2]),
         x(block.tensor[3]), x(block.tensor[4]), x(block.tensor[5])};
  }
}

// Adds a bare link in its own axes: its inertia is constant, and nothing of its bias force is lost.
template <class T>
ADAGEN_INLINE void add_own_link(Workspace& w, const Joints<T>& joints, Body<T>& X) {
  const Matrix<T> back = transposed(matrix_at<T>(w.at(joints.slot, kAxes)));
  const auto told = [&](Entry entry) { return back * vector_at<T>(w.at(joints.slot, entry)); };
  T mass;
  Vector<T> c;
  Symmetric<T> J;
  own_inertia(w, joints, mass, c, J);
  Vector<T> n, f;
  if (kAgain && w.again) {
    n = told(kTorque), f = told(kForce);
  } else {
    bias_force(J, c, mass, told(kOmega), told(kAlpha), told(kAcceleration), n, f);
    if constexpr (kOuterCount > 0) push_own(w, joints, n, f);
  }
  X.A += Symmetric<T>{J.yy + J.zz, -J.xy, -J.xz, J.xx + J.zz, -J.yz, J.xx + J.yy};
  X.B.x.y -= c.z, X.B.x.z += c.y, X.B.y.x += c.z;
  X.B.y.z -= c.x, X.B.z.x -= c.y, X.B.z.y += c.x;
  X.C.xx += mass, X.C.yy += mass, X.C.zz += mass;
  X.n += n, X.f += f;
}

// What is known of D, less what may be lost of it. What the bare link and the rotor bring is exact;
// what joints beyond bring is known to a few units in the last place of its trace, and is nothing
// but noise where links without inertia come near gimbal lock. Of a reversed joint the whole body
// was turned and shifted.
template <bool along, bool reversed, class T>
ADAGEN_INLINE T left_of(const Workspace& w, const Joints<T>& joints, const Body<T>& X, const T& D) {
  const Symmetric<T>& whole = along ? X.C : X.A;
  T brought = whole.xx + whole.yy + whole.zz;
  if constexpr (!reversed) {
    T mass;
    Vector<T> c;
    Symmetric<T> J;
    own_inertia(w, joints, mass, c, J);
    brought -= along ? 3 * mass : 2 * (J.xx + J.yy + J.zz);
  }
  return D - kLeast * brought;
}

// Takes the freedom along z out of the body, at the joint's origin and in its axes. With a rotor J
// a part J / D of what is taken along z stays: there, too, nothing is subtracted.
template <bool along, bool reversed, class T>
ADAGEN_INLINE void eliminate_own(Workspace& w, const Joints<T>& joints, Body<T>& X) {
  const Symmetric<T>&A = X.A, &C = X.C;
  const Matrix<T>& B = X.B;
  const Vector<T> n = along ? Vector<T>{B.x.z, B.y.z, B.z.z} : Vector<T>{A.xz, A.yz, A.zz};
  const Vector<T> f = along ? Vector<T>{C.xz, C.yz, C.zz} : B.z;
  T tau = each(joints, [&w](const JointConstants& own) { return torque(w, own); });
  if constexpr (reversed) tau = -tau;
  T D = along ? C.zz : A.zz, rotor{};
  if constexpr (kAnyPassive) {
    rotor = each(joints, [](const JointConstants& joint) { return joint.passive.rotor; });
    D += rotor;
  }
  const T left = left_of<along, reversed>(w, joints, X, D);
  if (__builtin_expect(!all_positive(left), 0)) fail_one(w, joints, left);
  const T inverse = 1 / D, u = (tau - (along ? X.f.z : X.n.z)) * inverse, kept = rotor * inverse;
  const Vector<T> e_n = n * inverse, e_f = f * inverse;
  subtract(X, n, f, e_n, e_f);
  X.n += n * u;
  X.f += f * u;
  if constexpr (along) {
    X.B.x.z = n.x * kept, X.B.y.z = n.y * kept, X.B.z.z = n.z * kept;
    X.C.xz = f.x * kept, X.C.yz = f.y * kept, X.C.zz = f.z * kept;
    X.f.z = tau - u * rotor;
  } else {
    X.A.xz = n.x * kept, X.A.yz = n.y * kept, X.A.zz = n.z * kept;
    X.B.z = f * kept;
    X.n.z = tau - u * rotor;
  }
  auto& memory = w.memory(joints);
  const Matrix<T> R = matrix_at<T>(w.at(joints.slot, kAxes));
  Vector<T> k_n = R * e_n;
  const Vector<T> k_f = R * e_f;
  if constexpr (!reversed) k_n += cross(memory.r, k_f);
  T* const e = memory.e;
  e[0] = k_n.x, e[1] = k_n.y, e[2] = k_n.z, e[3] = k_f.x, e[4] = k_f.y, e[5] = k_f.z;
  e[6] = u, e[7] = inverse;
}

// Inwards: articulated bodies. A joint is treated at its own origin, the child link's, and the body
// is handed on about the near link's origin. Seen from the sweep's root, the child link may be the
// near one (the joint is reversed): then sigma = -1, and -qdd takes the place of qdd.

template <class T>
ADAGEN_INLINE void add_bare_link(Workspace& w, const Joints<T>& joints, Body<T>& X) {
  const Value* const A = w.at(joints.slot, kRotational);
  const auto mass = mass_of(w, joints);
  const Vector<T> c = vector_at<T>(w.at(joints.slot, kMoments));
  const Vector<T> Ax = vector_at<T>(A), Ay = vector_at<T>(A + 3 * kPerBlock);
  X.A += Symmetric<T>{Ax.x, Ax.y, Ax.z, Ay.x, Ay.y, Ay.z};  // xx xy xz yy yz zz
  X.B.x.y -= c.z, X.B.x.z += c.y, X.B.y.x += c.z;
  X.B.y.z -= c.x, X.B.z.x -= c.y, X.B.z.y += c.x;
  X.C.xx += mass, X.C.yy += mass, X.C.zz += mass;
  X.n += vector_at<T>(w.at(joints.slot, kTorque));
  X.f += vector_at<T>(w.at(joints.slot, kForce));
}

// A bare link told about the point at -r from its origin: A - (rx dx + dx rx), d = c + m r / 2.
template <class T>
ADAGEN_INLINE Body<T> bare_link_from(Workspace& w, const Joints<T>& joints, const Vector<T>& r) {
  Body<T> X{};
  add_bare_link(w, joints, X);
  const Vector<T> c{X.B.z.y, X.B.x.z, X.B.y.x};
  const T m = X.C.xx;
  const Vector<T> d = c + r * (m / 2), moved = c + r * m;
  const T xx = 2 * d.x * r.x, yy = 2 * d.y * r.y, zz = 2 * d.z * r.z;
  X.A += Symmetric<T>{yy + zz, -(d.x * r.y + d.y * r.x), -(d.x * r.z + d.z * r.x),
                      xx + zz, -(d.y * r.z + d.z * r.y), xx + yy};
  const T none{};
  X.B = {{none, -moved.z, moved.y}, {moved.z, none, -moved.x}, {-moved.y, moved.x, none}};
  X.n += cross(r, X.f);
  return X;
}

// Takes one freedom out of the body, which is shifted by r, and added to by arrive, before the
// subtraction, so that the division has time. e gets U / D, u / D and 1 / D, told at the near
// link's origin: outwards the joint has the acceleration u / D - (U / D) a, a being the near
// link's.
template <bool along, bool reversed, class T, class Arrive>
ADAGEN_INLINE void eliminate(Workspace& w, const Joints<T>& joints, Body<T>& X, const Vector<T>& s,
                             const Vector<T>& r, const T& tau, T* e, const Arrive& arrive) {
  if constexpr (reversed) shift(X, -r);
  Vector<T> n = along ? X.B * s : X.A * s;
  const Vector<T> f = along ? X.C * s : transposed_times(X.B, s);
  T D = dot(s, along ? f : n);
  if constexpr (kAnyPassive)
    D += each(joints, [](const JointConstants& joint) { return joint.passive.rotor; });
  if constexpr (kPrescribedAbreast && kWidth < T >> 1) D += each(joints, immovable);
  const T inverse = 1 / D;
  T u = ((reversed ? -tau : tau) - dot(s, along ? X.f : X.n)) * inverse;
  if constexpr (kPrescribedAbreast && kWidth < T >> 1)
    u += each(joints, [&w](const JointConstants& joint) { return prescribed(w, joint); });
  const Symmetric<T>& whole = along ? X.C : X.A;  // D beside it tells what digits are left
  const T trace = whole.xx + whole.yy + whole.zz;
  if (__builtin_expect(!all_positive(D - kEnough * trace), 0)) lose(w, joints, D, trace);
  if constexpr (!reversed) {
    shift(X, r);
    n += cross(r, f);
  }
  arrive(X);
  const Vector<T> e_n = n * inverse, e_f = f * inverse;
  e[0] = e_n.x, e[1] = e_n.y, e[2] = e_n.z, e[3] = e_f.x, e[4] = e_f.y, e[5] = e_f.z, e[6] = u;
  e[7] = inverse;
  subtract(X, n, f, e_n, e_f);
  X.n += n * u;
  X.f += f * u;
}

// Acceleration of a body that nothing holds: (A, B; B^T, C) a = -(n; f), A and what it leaves of C
// by their factors. Whether that could be done.
ADAGEN_INLINE bool solve_free(const Body<Value>& X, Motion<Value>& a) {
  Value turning[6], sliding[6], checks[2][4];
  factorize(X.A, turning, checks[0]);
  Symmetric<Value> C = X.C;
  const Matrix<Value> K = complement(C, X.B, turning);
  factorize(C, sliding, checks[1]);
  const Vector<Value> y = solved(turning, -X.n);
  a.linear = solved(sliding, -(X.f + transposed_times(X.B, y)));
  a.angular = y - K * a.linear;
  bool fine = true;
  for (const auto& of : checks)
    for (const Value& check : of) fine &= all_positive(check);
  return fine;
}

// A joint with all freedoms hands on its force alone; e gets the acceleration of the body beyond.
template <bool reversed>
ADAGEN_INLINE void set_free(Workspace& w, int j, Body<Value>& X, const Vector<Value>& r,
                            const Value* tau, Value* e) {
  if constexpr (reversed) shift(X, -r);
  const Matrix<Value> R = matrix_at(w.of(j, kAxes));
  Vector<Value> n = R * Vector<Value>{tau[3], tau[4], tau[5]};
  Vector<Value> f = R * Vector<Value>{tau[0], tau[1], tau[2]};
  if constexpr (reversed) n = -n, f = -f;
  X.n += -n, X.f += -f;
  Motion<Value> a;
  if (!solve_free(X, a)) fail(w, kFactorization, j);
  if constexpr (kPassesFree) w.free[static_cast<std::size_t>(j)] = X;
  e[0] = a.angular.x, e[1] = a.angular.y, e[2] = a.angular.z;
  e[3] = a.linear.x, e[4] = a.linear.y, e[5] = a.linear.z;
  X = Body<Value>{};
  X.n = n, X.f = f;
  if constexpr (!reversed) shift(X, r);
}

// A planar joint: along x and y, then about z.
template <bool reversed>
ADAGEN_INLINE void eliminate_planar(Workspace& w, const Joints<Value>& joints, Body<Value>& X) {
  Memory& memory = w.memory(joints);
  const Value* tau = w.tau + joints.any().v;
  const Matrix<Value> R = matrix_at(w.at(joints.slot, kAxes));
  const Vector<Value> x{R.x.x, R.y.x, R.z.x}, y{R.x.y, R.y.y, R.z.y}, z{R.x.z, R.y.z, R.z.z};
  const Vector<Value> none{};
  const auto told = [](const Value& torque) { return reversed ? -torque : torque; };
  if constexpr (reversed) shift(X, -memory.r);
  const auto nothing = [](const Body<Value>&) {};
  eliminate<true, false>(w, joints, X, x, none, told(tau[0]), memory.e, nothing);
  eliminate<true, false>(w, joints, X, y, none, told(tau[1]), memory.e + 8, nothing);
  eliminate<false, false>(w, joints, X, z, none, told(tau[2]), memory.e + 16, nothing);
  if constexpr (!reversed) shift(X, memory.r);
}

// One joint, or one in each lane, all of a kind; arrive adds what is found at the near link.
template <bool reversed, class T, class Arrive>
ADAGEN_INLINE void step_inward(Workspace& w, const Joints<T>& joints, JointKind kind, Body<T>& X,
                               const Arrive& arrive) {
  const JointConstants& joint = joints.any();
  Eliminated<T>& memory = w.memory(joints);
  const Value* R = w.at(joints.slot, kAxes);
  const auto freedom = [&] {
    return each(joints, [&w](const JointConstants& own) { return torque(w, own); });
  };
  switch (kind) {
    case JointKind::kRevolute:
      eliminate<false, reversed>(w, joints, X, axis_at<T>(R), memory.r, freedom(), memory.e,
                                 arrive);
      return;
    case JointKind::kPrismatic:
      eliminate<true, reversed>(w, joints, X, axis_at<T>(R), memory.r, freedom(), memory.e, arrive);
      return;
    case JointKind::kSpherical:
      if constexpr (kAnySpherical) eliminate_rotations<reversed>(w, joints, X);
      break;
    case JointKind::kPlanar:
      if constexpr (kAnyPlanar && kWidth<T> == 1) eliminate_planar<reversed>(w, joints, X);
      break;
    case JointKind::kFloating:
      if constexpr (kAnyFloating && kWidth<T> == 1)
        set_free<reversed>(w, joints.joint[0], X, memory.r, w.tau + joint.v, memory.e);
      break;
  }
  arrive(X);
}

// Adds a bare link in the axes in which what is found at it is told.
template <bool lost = false>
ADAGEN_INLINE void add_link(Workspace& w, int link, Body<Value>& X) {
  if (turned_link<lost>(link))
    add_own_link(w, single(link - 1), X);
  else
    add_bare_link(w, single(link - 1), X);
}

// Adds to a body what the sweep finds at a link.
template <int p, bool lost = false>
ADAGEN_INLINE void meet(Workspace& w, int link, Body<Value>& X) {
  const LinkRole role = kRoles[p][static_cast<std::size_t>(link)];
  if (role.gathers) {
    Body<Value> gathered = w.bodies[static_cast<std::size_t>(link)];
    if (lost && !turned_link(link)) from_base<true>(w, link, gathered);
    X += gathered;
  }
  if (role.adds_own) add_link<lost>(w, link, X);
}

// What is found at a link, in axes of the base.
template <int p>
ADAGEN_INLINE Body<Value> whole(Workspace& w, int link) {
  Body<Value> X{};
  meet<p>(w, link, X);
  to_base(w, link, X);
  return X;
}

// Leaves a body at a link, in the axes in which that is told.
template <bool starts>
ADAGEN_INLINE void add_to(Workspace& w, int link, const Body<Value>& X) {
  Body<Value>& body = w.bodies[static_cast<std::size_t>(link)];
  if constexpr (starts)
    body = X;
  else
    body += X;
}
// The same of one in axes of the base.
template <bool starts>
ADAGEN_INLINE void leave(Workspace& w, int link, Body<Value> X) {
  from_base(w, link, X);
  add_to<starts>(w, link, X);
}

// Whether nothing but the links themselves is found at links first .. last.
template <int p>
constexpr bool bare(int first, int last) {
  for (int link = first; link <= last; ++link) {
    const LinkRole role = kRoles[p][static_cast<std::size_t>(link)];
    if (role.gathers || !role.adds_own) return false;
  }
  return true;
}

// Whether a sweep of joints first .. last may lose digits and be repeated in their own axes.
constexpr bool may_lose(int first, int last) {
  for (int j = first; j <= last; ++j)
    if (kAnyTurnedIfLost && kTurnedIfLost[j]) return true;
  return false;
}
template <int p, int first, int last, bool starts, bool reversed>
void inward_again(Workspace& w);

// Process p takes joints last .. first inwards, each on the link of the one before.
template <int p, int first, int last, bool starts>
void inward(Workspace& w) {
  Body<Value> X{};
  constexpr bool quick = bare<p>(first + 1, last);
  if constexpr (quick) meet<p>(w, last + 1, X);
  each_row<RunRows<first, last>, true>([&](int k, auto kind) ADAGEN_ALWAYS {
    const int j = first + k;
    if constexpr (!quick) meet<p>(w, j + 1, X);
    if constexpr (kRefine > 0) keep_body(w, single(j), X);
    step_inward<false>(w, single(j), kind, X, [&](Body<Value>& near) ADAGEN_ALWAYS {
      if (quick && j > first) add_bare_link(w, single(j - 1), near);
    });
  });
  if constexpr (may_lose(first, last))
    if (__builtin_expect(w.lost, 0)) return inward_again<p, first, last, starts, false>(w);
  constexpr int near = kJoints[first].parent;
  if constexpr (near > 0) leave<starts>(w, near, X);
}

// The next for spherical joints with bare links between them: a link is told at the next joint's
// origin before what is left of the body gets there.
template <int p, int first, int last>
ADAGEN_INLINE Body<Value> turn_inward_reversed(Workspace& w) {
  Body<Value> X{};
  meet<p>(w, kJoints[first].parent, X);
  shift(X, -w.joints[first].r);
  take_out_rotations<true>(w, single(first), X);
  for (int j = first + 1; j <= last; ++j) {
    const Vector<Value> r = -w.joints[static_cast<std::size_t>(j)].r;
    shift_mass(X, r);
    X += bare_link_from(w, single(j - 1), r);
    take_out_rotations<true>(w, single(j), X);
  }
  return X;
}

// The same for a root beyond joint last: from the parent link of joint first to the child of last.
template <int p, int first, int last, bool starts>
void inward_reversed(Workspace& w) {
  constexpr bool quick = bare<p>(first + 1, last);
  if constexpr (quick && leave_mass_alone(first, last) && kRefine == 0)
    return leave<starts>(w, last + 1, turn_inward_reversed<p, first, last>(w));
  Body<Value> X{};
  if constexpr (quick) meet<p>(w, kJoints[first].parent, X);
  each_row<RunRows<first, last>, false>([&](int k, auto kind) ADAGEN_ALWAYS {
    const int j = first + k;
    if constexpr (!quick) meet<p>(w, kJoints[static_cast<std::size_t>(j)].parent, X);
    if constexpr (kRefine > 0) keep_body(w, single(j), X);
    step_inward<true>(w, single(j), kind, X, [&](Body<Value>& near) ADAGEN_ALWAYS {
      if (quick && j < last) add_bare_link(w, single(j), near);
    });
  });
  if constexpr (may_lose(first, last))
    if (__builtin_expect(w.lost, 0)) return inward_again<p, first, last, starts, true>(w);
  leave<starts>(w, last + 1, X);
}

// Adds a link itself to what was found at it.
template <int link, bool starts>
void place(Workspace& w) {
  Body<Value> X{};
  add_link(w, link, X);
  add_to<starts>(w, link, X);
}

// A floating joint on the ground only adds its torque to the link.
template <int j, bool starts>
void free_base(Workspace& w) {
  const Value* tau = w.tau + kJoints[j].v;
  Body<Value> X{};
  X.n = {-tau[3], -tau[4], -tau[5]};
  X.f = {-tau[0], -tau[1], -tau[2]};
  leave<starts>(w, j + 1, X);
}

// Acceleration of a root that nothing holds.
template <int p, int link>
void solve_root(Workspace& w) {
  if (!solve_free(whole<p>(w, link), w.motions[link])) fail(w, kFactorization, link - 1);
}


// Numbers of x, or beyond its last one of y.
template <int... k, class V>
ADAGEN_INLINE V shuffled(const V& x, const V& y) {
#if defined(__clang__)
  return __builtin_shufflevector(x, y, k...);
#else
  return __builtin_shuffle(x, y, decltype(x < y){k...});
#endif
}

// Rows x and y of a square: what lies in columns apart by a distance changes places.
template <int distance, class V, std::size_t... column>
ADAGEN_INLINE void exchange(V& x, V& y, std::index_sequence<column...>) {
  constexpr int n = sizeof...(column);
  const V row = shuffled<(column & distance ? n + column - distance : column)...>(x, y);
  y = shuffled<(column & distance ? n + column : column + distance)...>(x, y);
  x = row;
}

// A square of as many rows as each has numbers becomes its transpose: blocks of one number, then of
// two by two, and so on.
template <int distance = 1, class V, std::size_t n>
ADAGEN_INLINE void transpose(V (&rows)[n]) {
  if constexpr (distance < static_cast<int>(n)) {
    ADAGEN_FOR (k, 0, static_cast<int>(n))
      if ((k & distance) == 0)
        exchange<distance>(rows[k], rows[k + distance], std::make_index_sequence<n>{});
    transpose<2 * distance>(rows);
  }
}

// A body by columns of eight lanes, for what takes one joint at a time: each column a register.
typedef Real Column __attribute__((vector_size(8 * sizeof(Real))));  // [angular, -, linear, -]

#if defined(__AVX512F__)
constexpr bool kInColumns = sizeof(Column) <= 64;
#elif defined(__AVX2__)
constexpr bool kInColumns = sizeof(Column) <= 32;
#else
constexpr bool kInColumns = false;
#endif

// An articulated body about a point: the columns of its inertia along three rotations and three
// translations, and its bias force.
struct Columns {
  Column angular[3]{}, linear[3]{}, force{};
};

ADAGEN_INLINE void operator+=(Columns& a, const Columns& b) {
  ADAGEN_FOR (k, 0, 3) {
    a.angular[k] += b.angular[k];
    a.linear[k] += b.linear[k];
  }
  a.force += b.force;
}

ADAGEN_INLINE Column column(const Vector<Real>& angular, const Vector<Real>& linear) {
  return Column{angular.x, angular.y, angular.z, 0, linear.x, linear.y, linear.z, 0};
}
ADAGEN_INLINE Columns columns(const Body<Real>& X) {
  const auto& [A, B, C, n, f] = X;
  return {{column({A.xx, A.xy, A.xz}, B.x), column({A.xy, A.yy, A.yz}, B.y),
           column({A.xz, A.yz, A.zz}, B.z)},
          {column({B.x.x, B.y.x, B.z.x}, {C.xx, C.xy, C.xz}),
           column({B.x.y, B.y.y, B.z.y}, {C.xy, C.yy, C.yz}),
           column({B.x.z, B.y.z, B.z.z}, {C.xz, C.yz, C.zz})},
          column(n, f)};
}
ADAGEN_INLINE Body<Real> body(const Columns& X) {
  const Column &x = X.angular[0], &y = X.angular[1], &z = X.angular[2];
  const Column &u = X.linear[0], &v = X.linear[1], &w = X.linear[2], &p = X.force;
  return {{x[0], x[1], x[2], y[1], y[2], z[2]},
          {{x[4], x[5], x[6]}, {y[4], y[5], y[6]}, {z[4], z[5], z[6]}},
          {u[4], u[5], u[6], v[5], v[6], w[6]},
          {p[0], p[1], p[2]},
          {p[4], p[5], p[6]}};
}

// Eight lanes of a register that may hold more.
template <int first>
ADAGEN_INLINE Column eight(const Lanes& x) {
  Real numbers[kLanes];
  std::memcpy(numbers, &x, sizeof x);
  Column result;
  std::memcpy(&result, numbers + first, sizeof result);
  return result;
}

// One number of a column in all lanes.
template <int k>
ADAGEN_INLINE Column spread(const Column& x) {
  return shuffled<k, k, k, k, k, k, k, k>(x, x);
}

// The lever arm r of a force: [n; f] becomes [n + r x f; f].
struct Arm {
  Column ahead, behind;  // y z x and z x y of r in the angular lanes
  Vector<Real> r;
};
ADAGEN_INLINE Arm arm(const Vector<Real>& r) {
  return {Column{r.y, r.z, r.x}, Column{r.z, r.x, r.y}, r};
}
// The same where x, too, has r as its linear half.
ADAGEN_INLINE Arm arm(const Column& x, const Vector<Real>& r) {
  return {shuffled<5, 6, 4, 7, 7, 7, 7, 7>(x, x), shuffled<6, 4, 5, 7, 7, 7, 7, 7>(x, x), r};
}
ADAGEN_INLINE Column carried(const Arm& arm, const Column& x) {
  return x + arm.ahead * shuffled<6, 4, 5, 7, 7, 7, 7, 7>(x, x) -
         arm.behind * shuffled<5, 6, 4, 7, 7, 7, 7, 7>(x, x);
}

// Gives A below its diagonal what it has above. What is left of a heavy body's inertia along axes
// that joints have taken out falls off from joint to joint while the inertia stays symmetric, and
// grows where it does not.
ADAGEN_INLINE void mirror(Columns& X) {
  X.angular[1] = shuffled<0, 1, 9, 3, 4, 5, 6, 7>(X.angular[1], X.angular[2]);
  const Column xy = shuffled<0, 8, 2, 3, 4, 5, 6, 7>(X.angular[0], X.angular[1]);
  X.angular[0] = shuffled<0, 1, 8, 3, 4, 5, 6, 7>(xy, X.angular[2]);
}

// The body told about the point at -r from the one that it is told about: what forces become, then
// what motions were, term by term in the same order.
ADAGEN_INLINE void shift(Columns& X, const Arm& arm) {
  ADAGEN_FOR (k, 0, 3) {
    X.angular[k] = carried(arm, X.angular[k]);
    X.linear[k] = carried(arm, X.linear[k]);
  }
  const auto& [x, y, z] = arm.r;
  X.angular[0] = X.angular[0] + X.linear[2] * y - X.linear[1] * z;
  X.angular[1] = X.angular[1] + X.linear[0] * z - X.linear[2] * x;
  X.angular[2] = X.angular[2] + X.linear[1] * x - X.linear[0] * y;
  X.force = carried(arm, X.force);
}

// U and 1 / D of the joint before: what is still to be subtracted from the body. So the next D need
// not wait for that.
struct Due {
  Column U{};
  Real inverse = 0, root = 0;  // root: of the inverse
};

// The inertia less U U^T / D, as g g^T: as symmetric to the last bit as it was.
ADAGEN_INLINE void subtract(Columns& X, const Due& due) {
  const Column g = due.U * due.root;
  X.angular[0] -= g * spread<0>(g);
  X.angular[1] -= g * spread<1>(g);
  X.angular[2] -= g * spread<2>(g);
  X.linear[0] -= g * spread<4>(g);
  X.linear[1] -= g * spread<5>(g);
  X.linear[2] -= g * spread<6>(g);
}
ADAGEN_INLINE void settle(Columns& X, Due& due) {
  subtract(X, due);
  due = {};
}
ADAGEN_INLINE Body<Real> settled(Columns X, Due due) {
  settle(X, due);
  return body(X);
}

// Inwards by columns: a joint takes a few instructions for each. For runs of joints that nothing
// lies beside; where no register holds a column, such runs are taken number by number.

// The joint that fills a slot.
constexpr std::array<std::size_t, kBlockCount * kPerBlock> kJointAt = [] {
  std::array<std::size_t, kBlockCount * kPerBlock> result{};
  for (std::size_t& joint : result) joint = kJointCount;
  for (int j = 0; j < kJointCount; ++j)
    result[static_cast<std::size_t>(slot_of(j))] = static_cast<std::size_t>(j);
  return result;
}();

// What set_up_links found of the links of blocks first .. last - 1, as it is added to columns.
template <int first, int last>
void set_up_columns(Workspace& w) {
  if constexpr (!kInColumns) return;
  for (int slot = first * kPerBlock; slot < last * kPerBlock; slot += 8) {
    const auto row = [&](int entry) {
      return number_at<Column>(w.at(slot, static_cast<Entry>(entry)));
    };
    const auto put = [&](Real(LinkColumns::* place)[8], const Column(&found)[8]) {
      ADAGEN_FOR (k, 0, 8) {
        LinkColumns& link = w.columns[kJointAt[static_cast<std::size_t>(slot + k)]];
        std::memcpy(link.*place, &found[k], sizeof found[k]);
      }
    };
    const auto& all = w.constants_of(slot / kPerBlock);
    const Column mass = number_at<Column>(&all.mass[static_cast<std::size_t>(slot % kPerBlock)]);
    const Column x = row(kMoments), y = row(kMoments + 1), z = row(kMoments + 2);
    const Column none = mass - mass;  // a zero unknown to gcc 12, which errs in shuffles with it
    constexpr int A = kRotational, n = kTorque, f = kForce;
    Column tensor[]{row(A), row(A + 1), row(A + 2), row(A + 3), row(A + 4), row(A + 5), mass, none};
    transpose(tensor);
    put(&LinkColumns::tensor, tensor);
    Column moments[]{x, y, z, -x, -y, -z, none, none};
    transpose(moments);
    put(&LinkColumns::moments, moments);
    Column force[]{row(n), row(n + 1), row(n + 2), none, row(f), row(f + 1), row(f + 2), none};
    transpose(force);
    put(&LinkColumns::force, force);
  }
}

ADAGEN_INLINE void add_bare_link(Workspace& w, int link, Columns& X) {
  const LinkColumns& own = w.columns[static_cast<std::size_t>(link - 1)];
  const Column a = number_at<Column>(own.tensor);   // xx xy xz yy yz zz m 0
  const Column b = number_at<Column>(own.moments);  // x y z -x -y -z 0 0
  X.angular[0] += shuffled<0, 1, 2, 7, 7, 13, 9, 7>(a, b);
  X.angular[1] += shuffled<1, 3, 4, 7, 10, 7, 11, 7>(a, b);
  X.angular[2] += shuffled<2, 4, 5, 7, 12, 8, 7, 7>(a, b);
  X.linear[0] += shuffled<7, 10, 12, 7, 6, 7, 7, 7>(a, b);
  X.linear[1] += shuffled<13, 7, 8, 7, 7, 6, 7, 7>(a, b);
  X.linear[2] += shuffled<9, 11, 7, 7, 7, 7, 6, 7>(a, b);
  X.force += number_at<Column>(own.force);
}

template <int p>
ADAGEN_INLINE void meet(Workspace& w, int link, Columns& X) {
  const LinkRole role = kRoles[p][static_cast<std::size_t>(link)];
  if (role.gathers) X += columns(w.bodies[static_cast<std::size_t>(link)]);
  if (role.adds_own) add_bare_link(w, link, X);
}

// S^T x with S = [s; 0] or [0; s].
template <bool along>
ADAGEN_INLINE Real component(const Column& s, const Column& x) {
  constexpr int first = along ? 4 : 0;
  const Column part = s * x;
  return (part[first] + part[first + 1]) + part[first + 2];
}

// See eliminate in inward.hpp. With X less U U^T / D due, S^T X S is less (S^T U)^2 / D.
template <bool along, bool reversed, class Arrive>
ADAGEN_INLINE void eliminate(Workspace& w, int j, Columns& X, Due& due, const Arrive& arrive) {
  const JointConstants& joint = kJoints[static_cast<std::size_t>(j)];
  Memory& memory = w.joints[static_cast<std::size_t>(j)];
  const Vector<Real>& axis = memory.axis;
  Column both;  // [axis, -, r, -]
  std::memcpy(&both, &memory, sizeof both);
  const Column s = shuffled<0, 1, 2, 3, 0, 1, 2, 3>(both, both);
  if constexpr (reversed) both = -both;
  const Arm lever = arm(both, reversed ? -memory.r : memory.r);
  if constexpr (reversed) {
    shift(X, lever);
    due.U = carried(lever, due.U);
  }
  const Column(&side)[3] = along ? X.linear : X.angular;
  const Column V = side[0] * axis.x + side[1] * axis.y + side[2] * axis.z;
  mirror(X);  // no sooner, so that V need not wait
  const Real q = component<along>(s, due.U);
  Real D = component<along>(s, V) - q * q * due.inverse;
  if constexpr (kAnyPassive) D += joint.passive.rotor;
  const Real inverse = 1 / D;
  const Column before = due.U * due.inverse;
  subtract(X, due);
  Column U = V - before * q;
  const Real tau = torque(w, joint);
  const Real u = ((reversed ? -tau : tau) - component<along>(s, X.force)) * inverse;
  constexpr int first = along ? 4 : 0;  // D beside the trace tells what digits are left
  const Real trace = side[0][first] + side[1][first + 1] + side[2][first + 2];
  if (__builtin_expect(!all_positive(D - kEnough * trace), 0)) lose(w, single(j), D, trace);
  if constexpr (!reversed) {
    shift(X, lever);
    U = carried(lever, U);
  }
  arrive(X);
  const Column e = U * inverse;
  Column kept = shuffled<0, 1, 2, 4, 5, 6, 3, 7>(e, e);
  kept[6] = u, kept[7] = inverse;
  std::memcpy(memory.e, &kept, sizeof kept);
  due = {U, inverse, std::sqrt(D) * inverse};  // the root need not wait for the division
  X.force += U * u;
}

template <bool reversed, class Arrive>
ADAGEN_INLINE void step_inward(Workspace& w, int j, JointKind kind, Columns& X, Due& due,
                               const Arrive& arrive) {
  [[maybe_unused]] const auto number_by_number = [&] {
    settle(X, due);
    Body<Real> whole = body(X);
    step_inward<reversed>(w, single(j), kind, whole, [](const Body<Real>&) {});
    X = columns(whole);
  };
  switch (kind) {
    case JointKind::kRevolute:
      eliminate<false, reversed>(w, j, X, due, arrive);
      return;
    case JointKind::kPrismatic:
      if constexpr (kAnyPrismatic) eliminate<true, reversed>(w, j, X, due, arrive);
      return;
    default:
      if constexpr (kAnySpherical || kAnyPlanar || kAnyFloating) number_by_number();
  }
  arrive(X);
}

// See inward in inward.hpp.
template <int p, int first, int last, bool starts>
void inward_in_columns(Workspace& w) {
  if constexpr (!kInColumns) return inward<p, first, last, starts>(w);
  constexpr bool quick = bare<p>(first + 1, last);
  Columns X;
  Due due;
  if constexpr (quick) meet<p>(w, last + 1, X);
  each_row<RunRows<first, last>, true>([&](int k, auto kind) ADAGEN_ALWAYS {
    const int j = first + k;
    if constexpr (!quick) meet<p>(w, j + 1, X);
    if constexpr (kRefine > 0) keep_body(w, single(j), settled(X, due));
    step_inward<false>(w, j, kind, X, due, [&](Columns& near) ADAGEN_ALWAYS {
      if (quick && j > first) add_bare_link(w, j, near);
    });
  });
  settle(X, due);
  if constexpr (may_lose(first, last))
    if (__builtin_expect(w.lost, 0)) return inward_again<p, first, last, starts, false>(w);
  constexpr int near = kJoints[first].parent;
  if constexpr (near > 0) leave<starts>(w, near, body(X));
}

// See inward_reversed in inward.hpp.
template <int p, int first, int last, bool starts>
void inward_in_columns_reversed(Workspace& w) {
  if constexpr (!kInColumns) return inward_reversed<p, first, last, starts>(w);
  constexpr bool quick = bare<p>(first + 1, last);
  Columns X;
  Due due;
  if constexpr (quick) meet<p>(w, kJoints[first].parent, X);
  each_row<RunRows<first, last>, false>([&](int k, auto kind) ADAGEN_ALWAYS {
    const int j = first + k;
    if constexpr (!quick) meet<p>(w, kJoints[static_cast<std::size_t>(j)].parent, X);
    if constexpr (kRefine > 0) keep_body(w, single(j), settled(X, due));
    step_inward<true>(w, j, kind, X, due, [&](Columns& near) ADAGEN_ALWAYS {
      if (quick && j < last) add_bare_link(w, j + 1, near);
    });
  });
  settle(X, due);
  if constexpr (may_lose(first, last))
    if (__builtin_expect(w.lost, 0)) return inward_again<p, first, last, starts, true>(w);
  leave<starts>(w, last + 1, body(X));
}

// Outwards again: the joints' accelerations.

template <class T>
ADAGEN_INLINE T freedom(const T* e, const Motion<T>& a) {
  return (e[6] - (e[0] * a.angular.x + e[1] * a.angular.y)) -
         ((e[2] * a.angular.z + e[3] * a.linear.x) + (e[4] * a.linear.y + e[5] * a.linear.z));
}

// Gives the k-th acceleration of each of the joints.
template <class T>
ADAGEN_INLINE void answer(Workspace& w, const Joints<T>& joints, int k, const T& x) {
  const auto place = [&](int lane) -> Value& {
    const int v = kJoints[static_cast<std::size_t>(joints.joint[lane])].v;
    return w.answer[static_cast<std::size_t>(v + k)];
  };
  if constexpr (kWidth<T> == 1)
    place(0) = x;
  else
    ADAGEN_FOR (lane, 0, kWidth<T>) place(lane) = x[lane];
}

// The same for joints with several freedoms, told at the joint's origin throughout.
template <bool reversed>
ADAGEN_INLINE void move_at_joint(Workspace& w, const Joints<Value>& joints, Motion<Value>& a) {
  const JointConstants& joint = joints.any();
  [[maybe_unused]] const Value* const e = w.memory(joints).e;
  [[maybe_unused]] const Matrix<Value> R = matrix_at(w.at(joints.slot, kAxes));
  [[maybe_unused]] Value* qdd = &w.answer[static_cast<std::size_t>(joint.v)];
  if constexpr (kAnyPlanar) {
    if (joint.kind == JointKind::kPlanar) {
      const Value spin = freedom(e + 16, a);
      a.angular += Vector<Value>{R.x.z, R.y.z, R.z.z} * spin;
      const Value y = freedom(e + 8, a);
      a.linear += Vector<Value>{R.x.y, R.y.y, R.z.y} * y;
      const Value x = freedom(e, a);
      a.linear += Vector<Value>{R.x.x, R.y.x, R.z.x} * x;
      qdd[0] = reversed ? -x : x, qdd[1] = reversed ? -y : y, qdd[2] = reversed ? -spin : spin;
    }
  }
  if constexpr (kAnyFloating) {
    if (joint.kind == JointKind::kFloating) {
      const Motion<Value> far{{e[0], e[1], e[2]}, {e[3], e[4], e[5]}};
      const Vector<Value> slide = transposed_times(R, far.linear - a.linear);
      const Vector<Value> spin = transposed_times(R, far.angular - a.angular);
      const Value x[6] = {slide.x, slide.y, slide.z, spin.x, spin.y, spin.z};
      ADAGEN_FOR (k, 0, 6) qdd[k] = reversed ? -x[k] : x[k];
      a = far;
    }
  }
}

// The same for spherical joints.
template <bool reversed, class T>
ADAGEN_INLINE void turn_at_joint(Workspace& w, const Joints<T>& joints, Motion<T>& a) {
  const T* const e = w.memory(joints).e;
  const Matrix<T> K{{e[0], e[1], e[2]}, {e[3], e[4], e[5]}, {e[6], e[7], e[8]}};
  Vector<T> far = Vector<T>{e[9], e[10], e[11]} - K * a.linear;
  if constexpr (kSphericalRotors) far += solved(e + 12, a.angular) * rotor_of(joints);
  const Matrix<T> R = matrix_at<T>(w.at(joints.slot, kAxes));
  const Vector<T> x = transposed_times(R, far - a.angular);
  answer(w, joints, 0, reversed ? -x.x : x.x);
  answer(w, joints, 1, reversed ? -x.y : x.y);
  answer(w, joints, 2, reversed ? -x.z : x.z);
  a.angular = far;
}

// A joint's acceleration from the near link's, which becomes the far link's; each is told at its
// own origin. Where the joint is reversed, the far link's acceleration differs by -S qdd.
template <bool reversed, class T>
ADAGEN_INLINE void move(Workspace& w, const Joints<T>& joints, JointKind kind, Motion<T>& a) {
  const T* const e = w.memory(joints).e;
  const Vector<T>& r = w.memory(joints).r;
  switch (kind) {
    case JointKind::kRevolute: {
      const Vector<T> axis = axis_of(w, joints);
      const T x = freedom(e, a);
      answer(w, joints, 0, reversed ? -x : x);
      carry(a, reversed ? -r : r);
      a.angular += axis * x;
      if constexpr (reversed) a.linear += cross(r, axis) * x;
      break;
    }
    case JointKind::kPrismatic: {
      const T x = freedom(e, a);
      answer(w, joints, 0, reversed ? -x : x);
      carry(a, reversed ? -r : r);
      a.linear += axis_of(w, joints) * x;
      break;
    }
    case JointKind::kSpherical:
      if constexpr (kAnySpherical) {
        if constexpr (!reversed) carry(a, r);
        turn_at_joint<reversed>(w, joints, a);
        if constexpr (reversed) carry(a, -r);
      }
      break;
    default:
      if constexpr (kWidth<T> == 1) {
        if constexpr (!reversed) carry(a, r);
        move_at_joint<reversed>(w, joints, a);
        if constexpr (reversed) carry(a, -r);
      }
  }
}

// Joints first .. last outwards; what moves along with a link is kept where other paths start.
template <int p, int first, int last>
void accelerate(Workspace& w) {
  Motion<Value> a = w.motions[static_cast<std::size_t>(kJoints[first].parent)];
  each_row<RunRows<first, last>, false>([&](int k, auto kind) ADAGEN_ALWAYS {
    move<false>(w, single(first + k), kind, a);
    if constexpr (kRefine > 0) keep_force<false>(w, single(first + k), a);
    const std::size_t far = static_cast<std::size_t>(first + k + 1);
    if (kRoles[p][far].parts) w.motions[far] = a;
  });
}

// Six numbers that follow from each other are no work for lanes: g++ takes a fifth longer with
// them.
#if defined(__clang__)
#define ADAGEN_ONE_BY_ONE
#else
#define ADAGEN_ONE_BY_ONE __attribute__((optimize("no-tree-slp-vectorize")))
#endif
template <int p, int first, int last>
ADAGEN_ONE_BY_ONE void accelerate_reversed(Workspace& w) {
  Motion<Value> a = w.motions[last + 1];
  each_row<RunRows<first, last>, true>([&](int k, auto kind) ADAGEN_ALWAYS {
    const int j = first + k;
    move<true>(w, single(j), kind, a);
    if constexpr (kRefine > 0) keep_force<true>(w, single(j), a);
    const std::size_t far = static_cast<std::size_t>(kJoints[static_cast<std::size_t>(j)].parent);
    if (kRoles[p][far].parts) w.motions[far] = a;
  });
}

// The Frame of a floating base knows nothing of its linear velocity, whose axes turn with the base.
template <int j>
void as_joint_acceleration(Workspace& w) {
  const Value* v = w.v + kJoints[j].v;
  Value* qdd = &w.answer[kJoints[j].v];
  const Vector<Value> turned =
      cross(Vector<Value>{v[3], v[4], v[5]}, Vector<Value>{v[0], v[1], v[2]});
  qdd[0] -= turned.x, qdd[1] -= turned.y, qdd[2] -= turned.z;
}

// A floating base's joint acceleration, [linear; angular] in its own axes.
template <int j>
void free_acceleration(Workspace& w) {
  const Motion<Value>& a = w.motions[j + 1];
  Value* qdd = &w.answer[kJoints[j].v];
  qdd[0] = a.linear.x, qdd[1] = a.linear.y, qdd[2] = a.linear.z;
  qdd[3] = a.angular.x, qdd[4] = a.angular.y, qdd[5] = a.angular.z;
  as_joint_acceleration<j>(w);
}


// Nothing on the ground moves beyond its Frame, and the ground does not yield.
const Mat6 kZero = Mat6::Zero();
const Columns6 kGround = Columns6::Zero();

// Mobility: what a segment shows at its handles, and what forces there do inside it. Phi and b are
// about the handles' origins, in the axes that their bodies are told in (turned.hpp), and so are
// forces at handles; b are accelerations beyond those of a Frame.
inline Mat3 mat3_of(const Matrix<Value>& R) {
  Mat3 result;
  result << R.x.x, R.x.y, R.x.z, R.y.x, R.y.y, R.y.z, R.z.x, R.z.y, R.z.z;
  return result;
}
template <class M>
M rotated(const Mat3& R, const M& m) {
  M result;
  result.template topRows<3>().noalias() = R * m.template topRows<3>();
  result.template bottomRows<3>().noalias() = R * m.template bottomRows<3>();
  return result;
}
// Columns at a link from the axes that they are told in there to those of the base, and back.
template <class M>
M in_base(Workspace& w, int link, const M& m) {
  return turned_link(link) ? rotated(mat3_of(matrix_at(w.of(link - 1, kAxes))), m) : m;
}
template <class M>
M as_told(Workspace& w, int link, const M& m) {
  return turned_link(link) ? rotated(mat3_of(matrix_at(w.of(link - 1, kAxes))).transpose(), m) : m;
}
[[maybe_unused]] inline Mat6 mobility_as_told(Workspace& w, int link, const Mat6& Phi) {
  if (!turned_link(link)) return Phi;
  const Mat6 half = as_told(w, link, Phi);
  return as_told(w, link, Mat6(half.transpose()));
}

ADAGEN_INLINE Motion<Value> motion_of(const Columns6& a) {
  return {{a[0], a[1], a[2]}, {a[3], a[4], a[5]}};
}
ADAGEN_INLINE Columns6 columns_of(const Motion<Value>& a) {
  Columns6 result;
  result << a.angular.x, a.angular.y, a.angular.z, a.linear.x, a.linear.y, a.linear.z;
  return result;
}

inline Mat6 inertia_of(const Body<Value>& X) {
  Mat6 I;
  I << X.A.xx, X.A.xy, X.A.xz, X.B.x.x, X.B.x.y, X.B.x.z,  //
      X.A.xy, X.A.yy, X.A.yz, X.B.y.x, X.B.y.y, X.B.y.z,   //
      X.A.xz, X.A.yz, X.A.zz, X.B.z.x, X.B.z.y, X.B.z.z,   //
      X.B.x.x, X.B.y.x, X.B.z.x, X.C.xx, X.C.xy, X.C.xz,   //
      X.B.x.y, X.B.y.y, X.B.z.y, X.C.xy, X.C.yy, X.C.yz,   //
      X.B.x.z, X.B.y.z, X.B.z.z, X.C.xz, X.C.yz, X.C.zz;
  return I;
}
inline Columns6 force_of(const Body<Value>& X) { return columns_of({X.n, X.f}); }

// The inverse of a symmetric matrix of six rows, and as symmetric: L^-T D^-1 L^-1, L^-1 by
// elimination of all six unit vectors at once. Where masses differ much, subtracting on the way
// back instead would cost digits. Whether each pivot exceeds what it must at least.
ADAGEN_INLINE bool invert(const Mat6& m, const Real (&least)[6], Mat6& inverse) {
  Lanes rows[6]{}, X[6]{};
  Real over[6];
  bool good = true;
  ADAGEN_FOR (i, 0, 6) {
    std::memcpy(&rows[i], m.data() + 6 * i, 6 * sizeof(Real));
    X[i][i] = 1;
  }
  ADAGEN_FOR (c, 0, 6) {
    const Real pivot = rows[c][c];
    good = good && pivot > least[c] && pivot <= std::numeric_limits<Real>::max();
    over[c] = 1 / pivot;
    ADAGEN_FOR (i, c + 1, 6) {
      const Real l = rows[i][c] * over[c];
      rows[i] -= rows[c] * l;
      X[i] -= X[c] * l;
    }
  }
  ADAGEN_FOR (i, 0, 6) {
    Lanes sum{};
    ADAGEN_FOR (k, i, 6) sum += X[k] * (X[k][i] * over[k]);
    std::memcpy(inverse.data() + 6 * i, &sum, 6 * sizeof(Real));
  }
  ADAGEN_FOR (i, 0, 6)
    ADAGEN_FOR (k, 0, i) inverse(k, i) = inverse(i, k);
  return good;
}

// Phi = (I^A)^-1 and b = -Phi p^A of a segment's root.
[[maybe_unused]] inline bool invert(const Body<Value>& X, Mat6& Phi, Columns6& b) {
  constexpr Real kRounding = 8 * std::numeric_limits<Real>::epsilon();
  const Mat6 I = inertia_of(X);
  Real least[6];
  ADAGEN_FOR (k, 0, 6) least[k] = kRounding * I(k, k);
  const bool good = invert(I, least, Phi);
  b.noalias() = -Phi * force_of(X);
  return good;
}

template <int p, int link>
void invert_root(Workspace& w, Mat6& Phi, Columns6& b) {
  Body<Value> X{};
  meet<p>(w, link, X);
  if (!invert(X, Phi, b)) fail(w, kFactorization, link - 1);
}

// b = -Phi p of a bare link.
template <int link>
void bare_link(Workspace& w, const Mat6& Phi, Columns6& b) {
  static_assert(turned_link(link));
  Body<Value> X{};
  add_own_link(w, single(link - 1), X);
  b.noalias() = -Phi * force_of(X);
}

// A planar joint's freedoms one after the other, the last one to be eliminated first, at its
// origin.
ADAGEN_INLINE void slide_and_turn(Workspace& w, int j, Motion<Lanes>& a,
                                  const Vector<Lanes>& drive) {
  const Value* const e = w.joints[static_cast<std::size_t>(j)].e;
  const Matrix<Value> R = matrix_at(w.of(j, kAxes));
  const auto moved = [&a](const Value* of, const Lanes& driven) {
    return driven -
           ((of[0] * a.angular.x + of[1] * a.angular.y) +
            (of[2] * a.angular.z + of[3] * a.linear.x) + (of[4] * a.linear.y + of[5] * a.linear.z));
  };
  const auto along = [](const Value& x, const Value& y, const Value& z, const Lanes& by) {
    return Vector<Lanes>{x * by, y * by, z * by};
  };
  a.angular += along(R.x.z, R.y.z, R.z.z, moved(e + 16, drive.z));
  a.linear += along(R.x.y, R.y.y, R.z.y, moved(e + 8, drive.y));
  a.linear += along(R.x.x, R.y.x, R.z.x, moved(e, drive.x));
}

// Motions of a link, side by side: what the far link does, with what drives the joint beyond L a
// (of a joint with one freedom x).
template <bool reversed>
ADAGEN_INLINE void pass(Workspace& w, int j, Motion<Lanes>& a,
                        const Vector<Lanes>& drive = Vector<Lanes>{}) {
  const JointKind kind = kJoints[static_cast<std::size_t>(j)].kind;
  const Memory& memory = w.joints[static_cast<std::size_t>(j)];
  const Value* const e = memory.e;
  const Vector<Value> axis = axis_at(w.of(j, kAxes));
  if (kind == JointKind::kSpherical) {
    if constexpr (kAnySpherical) {
      if constexpr (!reversed) carry(a, memory.r);
      const Vector<Lanes> v = a.linear, spin = a.angular;
      a.angular = {drive.x - (e[0] * v.x + e[1] * v.y + e[2] * v.z),
                   drive.y - (e[3] * v.x + e[4] * v.y + e[5] * v.z),
                   drive.z - (e[6] * v.x + e[7] * v.y + e[8] * v.z)};
      if constexpr (kSphericalRotors) a.angular += solved(e + 12, spin) * rotor_of(single(j));
      if constexpr (reversed) carry(a, -memory.r);
    }
    return;
  }
  if (kind == JointKind::kPlanar) {
    if constexpr (kAnyPlanar) {
      if constexpr (!reversed) carry(a, memory.r);
      slide_and_turn(w, j, a, drive);
      if constexpr (reversed) carry(a, -memory.r);
    }
    return;
  }
  if (kind == JointKind::kFloating) {  // the far link moves as if there were no near one
    a = Motion<Lanes>{};
    return;
  }
  const Lanes x = drive.x - ((e[0] * a.angular.x + e[1] * a.angular.y) +
                             (e[2] * a.angular.z + e[3] * a.linear.x) +
                             (e[4] * a.linear.y + e[5] * a.linear.z));
  const Vector<Lanes> moved{axis.x * x, axis.y * x, axis.z * x};
  if constexpr (!reversed) carry(a, memory.r);
  if (kind == JointKind::kPrismatic)
    a.linear += moved;
  else
    a.angular += moved;
  if constexpr (reversed) carry(a, -memory.r);
}

ADAGEN_INLINE Motion<Lanes> rows_of(const Mat6& transposed) {
  const auto row = [&transposed](int k) {
    Lanes result{};
    std::memcpy(&result, transposed.data() + 6 * k, 6 * sizeof(Real));
    return result;
  };
  return {{row(0), row(1), row(2)}, {row(3), row(4), row(5)}};
}
ADAGEN_INLINE Mat6 from_rows(const Motion<Lanes>& a) {  // transposed
  Mat6 result;
  const Lanes* rows[6] = {&a.angular.x, &a.angular.y, &a.angular.z,
                          &a.linear.x,  &a.linear.y,  &a.linear.z};
  for (int k = 0; k < 6; ++k) std::memcpy(result.data() + 6 * k, rows[k], 6 * sizeof(Real));
  return result;
}

template <bool reversed>
ADAGEN_INLINE constexpr int near_link(int j) {
  return reversed ? j + 1 : kJoints[static_cast<std::size_t>(j)].parent;
}

// L m, m being told with the near link in its rows.
template <bool reversed>
Mat6 passed(Workspace& w, int j, const Mat6& m) {
  const Mat6 near = in_base(w, near_link<reversed>(j), m);
  Motion<Lanes> rows = rows_of(near.transpose());
  pass<reversed>(w, j, rows);
  const Mat6 far = from_rows(rows).transpose();
  return as_told(w, near_link<!reversed>(j), far);
}

// What joints with several freedoms do at the child link's origin is told at the far link's.
template <bool reversed>
Mat6 at_far_link(Workspace& w, int j, const Mat6& Phi) {
  if constexpr (!reversed) return mobility_as_told(w, j + 1, Phi);
  const Vector<Value> r = -w.joints[static_cast<std::size_t>(j)].r;
  Mat6 shifted = Mat6::Identity();  // linear += angular x r
  shifted(3, 1) = r.z, shifted(3, 2) = -r.y, shifted(4, 0) = -r.z;
  shifted(4, 2) = r.x, shifted(5, 0) = r.y, shifted(5, 1) = -r.x;
  return mobility_as_told(w, near_link<false>(j), shifted * Phi * shifted.transpose());
}

// S D^-1 S^T at the far link's origin.
template <bool reversed>
Mat6 own_mobility(Workspace& w, int j) {
  const JointKind kind = kJoints[static_cast<std::size_t>(j)].kind;
  const Memory& memory = w.joints[static_cast<std::size_t>(j)];
  Mat6 result = Mat6::Zero();
  if (kind == JointKind::kPlanar) {
    if constexpr (kAnyPlanar) {
      Motion<Lanes> a{};
      Vector<Lanes> unit{};
      unit.x[0] = 1, unit.y[1] = 1, unit.z[2] = 1;
      slide_and_turn(w, j, a, unit);
      const Mat6 moved = from_rows(a);  // transposed: what a freedom does is a column of lanes
      for (int k = 0; k < 3; ++k) {
        const Columns6 s = moved.row(k).transpose();
        result += s * memory.e[8 * k + 7] * s.transpose();
      }
    }
    return at_far_link<reversed>(w, j, result);
  }
  if (kind == JointKind::kFloating) {
    if constexpr (kPassesFree) {
      Columns6 still;
      if (!invert(w.free[static_cast<std::size_t>(j)], result, still)) fail(w, kFactorization, j);
    }
    return at_far_link<reversed>(w, j, result);
  }
  if (kind == JointKind::kSpherical) {
    if constexpr (kAnySpherical) {
      for (int k = 0; k < 3; ++k) {
        const Vector<Value> unit{Value(k == 0), Value(k == 1), Value(k == 2)};
        const Vector<Value> x = solved(memory.e + 12, unit);
        result(0, k) = x.x, result(1, k) = x.y, result(2, k) = x.z;
      }
    }
    return at_far_link<reversed>(w, j, result);
  }
  Motion<Value> S{};
  Vector<Value>& along = kind == JointKind::kPrismatic ? S.linear : S.angular;
  if (!reversed && turned(j)) {
    along.z = 1;
  } else {
    along = axis_at(w.of(j, kAxes));
    if constexpr (reversed) carry(S, -memory.r);
  }
  const Columns6 s = reversed ? as_told(w, near_link<false>(j), columns_of(S)) : columns_of(S);
  return s * memory.e[7] * s.transpose();
}

// Omega and b outwards across a joint: L Omega L^T + S D^-1 S^T. Nothing is subtracted.
template <bool reversed>
void propagate(Workspace& w, int j, const Mat6& near, const Columns6& near_bias, Mat6& far,
               Columns6& far_bias) {
  const Mat6 half = passed<reversed>(w, j, near);
  far = passed<reversed>(w, j, half.transpose()) + own_mobility<reversed>(w, j);
  Motion<Value> a = motion_of(in_base(w, near_link<reversed>(j), near_bias));
  move<reversed>(w, single(j), kJoints[static_cast<std::size_t>(j)].kind, a);
  far_bias = as_told(w, near_link<!reversed>(j), columns_of(a));
}

// A link whose other side shows Phi and b: (1 + Phi I^A) a = b - Phi p^A.
template <int link>
void solve_mobility(Workspace& w, const Mat6& Phi, const Columns6& b) {
  const Body<Value>& X = w.bodies[link];
  const Mat6 M = Mat6::Identity() + Phi * inertia_of(X);
  const Columns6 a = M.partialPivLu().solve(b - Phi * force_of(X));
  w.motions[link] = motion_of(in_base(w, link, a));
}

// A root's acceleration under the forces at handles.
template <int link>
void accelerate_root(Workspace& w, const Mat6& Phi, const Columns6& b) {
  const Columns6 a = b + Phi * as_told(w, link, w.loads[link]);
  w.motions[link] = motion_of(in_base(w, link, a));
}

// The force that what was left at a link needs to move as the link does.
template <int link>
Columns6 force_on(Workspace& w) {
  Body<Value> X = w.bodies[link];
  to_base(w, link, X);
  return inertia_of(X) * columns_of(w.motions[link]) + force_of(X);
}

// --- joins: adapters to the joints' own frames ---------------------------------------------------

// From what is told about the parent's (X) and the child link's origin (Y) to the joint's frame.
[[maybe_unused]] inline void set_transforms(Workspace& w, int j, Transform& X, Transform& Y) {
  const int parent = kJoints[static_cast<std::size_t>(j)].parent;
  const Mat3 back = mat3_of(matrix_at(w.of(j, kAxes))).transpose();
  const Vector<Value>& r = w.joints[static_cast<std::size_t>(j)].r;
  X.E = back;
  X.r << r.x, r.y, r.z;
  if (turned_link(parent)) {
    const Mat3 R = mat3_of(matrix_at(w.of(parent - 1, kAxes)));
    X.E = mat3_of(matrix_at(w.of(j, kTurn))).transpose();
    X.r = (R.transpose() * X.r).eval();
  }
  Y.E = turned_link(j + 1) ? Mat3(Mat3::Identity()) : back;
  Y.r.setZero();
}

// The torques of a joint that reach the links, or its prescribed accelerations.
template <std::size_t n>
void load_torque(Workspace& w, int j, int, std::array<std::array<Real, kColumns>, n>& tau) {
  const JointConstants& joint = kJoints[static_cast<std::size_t>(j)];
  for (std::size_t k = 0; k < n; ++k) {
    const int entry = static_cast<int>(k);
    tau[k][0] = joint.passive.prescribed ? w.tau[joint.v + entry] : torque(w, joint, entry);
  }
}

template <std::size_t n>
void store_acceleration(Workspace& w, int, int v,
                        const std::array<std::array<Real, kColumns>, n>& qdd) {
  for (std::size_t k = 0; k < n; ++k) w.answer[static_cast<std::size_t>(v) + k] = qdd[k][0];
}

// Forces at handles: what they do inside a run.

// A wrench on the far link becomes what the near link feels of it, L^T times it; what it drives the
// joint with, D^-1 S^T times it, is returned.
template <bool reversed, class T>
ADAGEN_INLINE Vector<T> hand_on(Workspace& w, int j, Vector<T>& n, Vector<T>& f) {
  const JointKind kind = kJoints[static_cast<std::size_t>(j)].kind;
  const Memory& memory = w.joints[static_cast<std::size_t>(j)];
  const Value* const e = memory.e;
  const Vector<Value>& r = memory.r;
  if constexpr (reversed) n += cross(f, r);
  Vector<T> driven{};
  if (kind == JointKind::kSpherical) {
    if constexpr (kAnySpherical) {
      driven = solved(e + 12, n);
      f.x -= e[0] * n.x + e[3] * n.y + e[6] * n.z;
      f.y -= e[1] * n.x + e[4] * n.y + e[7] * n.z;
      f.z -= e[2] * n.x + e[5] * n.y + e[8] * n.z;
      n = kSphericalRotors ? driven * rotor_of(single(j)) : Vector<T>{};
      if constexpr (!reversed) n += -cross(f, r);
    }
    return driven;
  }
  if (kind == JointKind::kPlanar) {
    if constexpr (kAnyPlanar) {
      const Matrix<Value> R = matrix_at(w.of(j, kAxes));
      const auto taken = [&n, &f](const Value* of, const T& x) {
        n.x -= of[0] * x, n.y -= of[1] * x, n.z -= of[2] * x;
        f.x -= of[3] * x, f.y -= of[4] * x, f.z -= of[5] * x;
        return x * of[7];
      };
      driven.x = taken(e, dot(f, Vector<Value>{R.x.x, R.y.x, R.z.x}));
      driven.y = taken(e + 8, dot(f, Vector<Value>{R.x.y, R.y.y, R.z.y}));
      driven.z = taken(e + 16, dot(n, Vector<Value>{R.x.z, R.y.z, R.z.z}));
    }
    if constexpr (!reversed) n += -cross(f, r);
    return driven;
  }
  const T x = dot(kind == JointKind::kPrismatic ? f : n, axis_at(w.of(j, kAxes)));
  driven.x = x * e[7];
  if constexpr (!reversed) n += -cross(f, r);
  n.x -= e[0] * x, n.y -= e[1] * x, n.z -= e[2] * x;
  f.x -= e[3] * x, f.y -= e[4] * x, f.z -= e[5] * x;
  return driven;
}

// What a link is loaded with is added to what is handed on to it.
ADAGEN_INLINE void take_load(const Workspace& w, int link, Vector<Value>& n, Vector<Value>& f) {
  const Columns6& load = w.loads[static_cast<std::size_t>(link)];
  n += Vector<Value>{load[0], load[1], load[2]};
  f += Vector<Value>{load[3], load[4], load[5]};
}

// A wrench on a link beyond a floating joint moves that link and nothing else.
template <bool reversed>
ADAGEN_INLINE void push_free(Workspace& w, int j, Vector<Value>& n, Vector<Value>& f) {
  if constexpr (reversed) n += cross(f, w.joints[static_cast<std::size_t>(j)].r);
  Body<Value> X = w.free[static_cast<std::size_t>(j)];
  X.n = -n, X.f = -f;
  Motion<Value> a;
  if (!solve_free(X, a)) fail(w, kFactorization, j);
  Value* const e = w.joints[static_cast<std::size_t>(j)].e;
  e[0] += a.angular.x, e[1] += a.angular.y, e[2] += a.angular.z;
  e[3] += a.linear.x, e[4] += a.linear.y, e[5] += a.linear.z;
  n = f = Vector<Value>{};
}

// A wrench on the far link: the joint is told, and what the near link feels is left.
template <bool reversed>
ADAGEN_INLINE void deliver(Workspace& w, int j, Vector<Value>& n, Vector<Value>& f) {
  Value* const e = w.joints[static_cast<std::size_t>(j)].e;
  if constexpr (kPassesFree) {
    if (kJoints[static_cast<std::size_t>(j)].kind == JointKind::kFloating)
      return push_free<reversed>(w, j, n, f);
  }
  const Vector<Value> driven = hand_on<reversed>(w, j, n, f);
  if (kJoints[static_cast<std::size_t>(j)].kind == JointKind::kPlanar) {
    if constexpr (kAnyPlanar) e[6] += driven.x, e[14] += driven.y, e[22] += driven.z;
    return;
  }
  if (kJoints[static_cast<std::size_t>(j)].kind == JointKind::kSpherical) {
    if constexpr (kAnySpherical) e[9] += driven.x, e[10] += driven.y, e[11] += driven.z;
  } else {
    e[6] += driven.x;
  }
}

// The loads of links beyond joints first .. last, each on the link of the one before, from the last
// link to the one that the first joint is on.
template <int first, int last>
void deliver(Workspace& w) {
  Vector<Value> n{}, f{};
  for (int j = last; j >= first; --j) {
    take_load(w, j + 1, n, f);
    if constexpr (kRefine > 0) keep_load(w, j, n, f);
    deliver<false>(w, j, n, f);
  }
  w.loads[kJoints[first].parent] += columns_of({n, f});
}
// The same where the ground's side lies beyond: from the first joint's link to the last one's.
template <int first, int last>
void deliver_reversed(Workspace& w) {
  Vector<Value> n{}, f{};
  for (int j = first; j <= last; ++j) {
    take_load(w, kJoints[static_cast<std::size_t>(j)].parent, n, f);
    if constexpr (kRefine > 0) keep_load(w, j, n, f);
    deliver<true>(w, j, n, f);
  }
  w.loads[last + 1] += columns_of({n, f});
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
=======
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
#include "adagen/kernels/accelerate.hpp"
#include "adagen/kernels/mobility.hpp"
#include "adagen/kernels/wrenches.hpp"
#include "adagen/exchange.hpp"

namespace {
>>>>>>> refs/heads/headers

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
  propagate<false>(w, 0, kZero, kGround, w.j_shoulder_pitch.Phi_turret, w.j_shoulder_pitch.b_turret);
  propagate<false>(w, 1, w.j_shoulder_pitch.Phi_turret, w.j_shoulder_pitch.b_turret, w.j_shoulder_pitch.Phi_upper_arm, w.j_shoulder_pitch.b_upper_arm);
  propagate<false>(w, 2, w.j_shoulder_pitch.Phi_upper_arm, w.j_shoulder_pitch.b_upper_arm, w.j_shoulder_pitch.Phi_elbow_housing, w.j_shoulder_pitch.b_elbow_housing);
  propagate<false>(w, 3, w.j_shoulder_pitch.Phi_elbow_housing, w.j_shoulder_pitch.b_elbow_housing, w.j_shoulder_pitch.Phi_forearm, w.j_shoulder_pitch.b_forearm);
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
  w.loads[1] = Columns6::Zero();
  w.loads[2] = Columns6::Zero();
  w.loads[3] = Columns6::Zero();
  w.loads[4] = in_base(w, 4, w.j_shoulder_pitch.F_on_forearm);
  deliver<0, 3>(w);  // "base_yaw" .. "elbow_pitch"
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
// What this solver tells the program around it, which is the same for all robots: states in,
// accelerations out; check; time; trace; simulate.

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

// As the cost profile default has them.
constexpr adagen::Hop kWindowHop{0, 159, 0.437};
constexpr adagen::Hop kMessageHop{26, 228, 0.644};

}  // namespace

// Compiled for size: it runs once.
[[gnu::cold]] int main(int count, char** words) {
  const adagen::Description<Number> description{
      "arm7", "auto", kProcesses, 1, kNq, kNv, kNtau, kRefine,
      false, kAlone, kBatch, false, kTolerance, kGravity.data(),
      table(kJoints), table(kLinks), table(kOuterForces), {}, {}, table(kMessages), kStages.data(), kWindowHop,
      kMessageHop};
  auto* const solver = new ThisSolver;
  const int status = adagen::program(description, *solver, count, words);
  delete solver;
  return status;
}
#endif  // ADAGEN_NO_MAIN
