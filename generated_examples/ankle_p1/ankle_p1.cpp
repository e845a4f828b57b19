// Forward dynamics of "ankle" on 1 process, emitted by adagen 0.1.0 (solver.cpp.j2). Do not edit: emit anew.
//
// robot     "ankle", 8 joints, 12 degrees of freedom, description sha256 ddb900f3e284309ae668afcdcf39b2b2f8b0b30c7e4b7984814bb0e23c113d8c
// command   adagen ../models/ankle.urdf --scene=../models/ankle.toml --procs 1
// options   form segment, shape unrolled, scalar double, channel auto, fixed base, gravity 0.0, 0.0, -9.81
// links     adagen_program.cpp
// program   1 process; 0.269 us predicted (default profile)
//           process 0: hip .. right_ball
// licence   yours to choose: what adagen emits belongs to whoever emits it
//
// The articulated-body algorithm: I^A and p^A (IA, pA), a link's inertia and bias force with all that
// hangs on it, are swept to the base, and the accelerations come back. Where loops are closed,
// accelerations of their joints and the constraint forces are held back as unknowns, and eliminated at
// the last link that the joints have in common (docs/explanation/loops.md). Spatial vectors are [angular;
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
// To use it from a program of yours: compile this file with -DADAGEN_NO_MAIN and link it; ankle_p1.h
// beside it is this part.
// C interface of the solver ankle_p1: forward dynamics of "ankle" on 1 process,
// emitted by adagen 0.1.0 (interface.h.j2). Do not edit: emit anew.
#ifndef ADAGEN_ANKLE_P1_H
#define ADAGEN_ANKLE_P1_H

enum {
  ANKLE_P1_PROCESSES = 1,
  ANKLE_P1_JOINTS = 8,
  ANKLE_P1_NQ = 14,  // numbers in q
  ANKLE_P1_NV = 12,  // in v and qdd
  ANKLE_P1_NTAU = 12  // in tau
};

// Where each joint begins in q, and in v, tau and qdd.
enum {
  ANKLE_P1_Q_hip = 0,
  ANKLE_P1_V_hip = 0,  // joint 0, "hip": revolute, 1 in q, 1 in v
  ANKLE_P1_Q_knee = 1,
  ANKLE_P1_V_knee = 1,  // joint 1, "knee": revolute, 1 in q, 1 in v
  ANKLE_P1_Q_ankle_pitch = 2,
  ANKLE_P1_V_ankle_pitch = 2,  // joint 2, "ankle_pitch": revolute, 1 in q, 1 in v
  ANKLE_P1_Q_ankle_roll = 3,
  ANKLE_P1_V_ankle_roll = 3,  // joint 3, "ankle_roll": revolute, 1 in q, 1 in v
  ANKLE_P1_Q_left_motor = 4,
  ANKLE_P1_V_left_motor = 4,  // joint 4, "left_motor": revolute, 1 in q, 1 in v
  ANKLE_P1_Q_left_ball = 5,
  ANKLE_P1_V_left_ball = 5,  // joint 5, "left_ball": spherical, 4 in q, 3 in v
  ANKLE_P1_Q_right_motor = 9,
  ANKLE_P1_V_right_motor = 8,  // joint 6, "right_motor": revolute, 1 in q, 1 in v
  ANKLE_P1_Q_right_ball = 10,
  ANKLE_P1_V_right_ball = 9  // joint 7, "right_ball": spherical, 4 in q, 3 in v
};

// Why a call failed, as ankle_p1_reason tells of the status that it returned.
enum {
  ANKLE_P1_FINE = 0,  // none
  ANKLE_P1_NOT_FINITE = 1,  // q, v or tau of a joint is not a finite number
  ANKLE_P1_ZERO_QUATERNION = 2,  // a joint's quaternion cannot be normalised
  ANKLE_P1_FACTORIZATION = 3,  // inertias beside a joint differ too much for the scalar
  ANKLE_P1_OVERFLOW = 4,  // a joint's acceleration is not a finite number
  ANKLE_P1_NO_ANSWER = 5,  // a process did not answer within the time limit
  ANKLE_P1_ENDED = 6,  // process 0 has ended the evaluations
  ANKLE_P1_NOT_REFINED = 7,  // refinement does not converge
  ANKLE_P1_GIMBAL_LOCK = 8,  // joints that are joined as one do not move in as many directions
  ANKLE_P1_GROWTH = 9,  // a link beside a joint is too light for its neighbours
  ANKLE_P1_NOT_SET = 16,  // what is to be set at run time is not finite, or is no mass
  ANKLE_P1_TOO_FEW_STEPS = 11,  // refinement converges too slowly
  ANKLE_P1_LOOP_OPEN = 12,  // a loop or coupling is not closed in this configuration
  ANKLE_P1_LOOP_TORN = 13,  // this velocity tears a loop or coupling open
  ANKLE_P1_LOOP_SINGULAR = 14,  // what a loop holds changes in this pose
  ANKLE_P1_LOOP_FREE = 15  // loops leave a joint a motion that no inertia resists
};

#ifdef __cplusplus
extern "C" {
#endif
typedef struct ankle_p1_solver ankle_p1_solver;

// Joints in order, each with its place in the state: gives name, start and size in q and v of joint
// k, or returns 0 where there is none.
int ankle_p1_joint(int k, const char** name, int* q, int* nq, int* v, int* nv);

// A solver, with all the memory that it will ever need: no other call allocates, waits or takes a
// lock. One solver is for one thread at a time. Returns null where there is no memory;
// ankle_p1_failure(NULL) says so.
ankle_p1_solver* ankle_p1_open(void);

// One evaluation. q: 14 numbers, v and tau: 12 each, qdd: 12; joints in order, quaternions
// x y z w (normalised here), floating joints [linear; angular] in the body's frame.
// Returns 0, or a status that ankle_p1_failure puts into words; no acceleration is written then.
int ankle_p1_solve(ankle_p1_solver* solver, const double* q, const double* v, const double* tau, double* qdd);

// What a status says: its reason, and which joint it is about, -1 for none.
int ankle_p1_reason(int status);
int ankle_p1_failed_joint(int status);

// The last failure of a solver in words, valid until the next call; of null, why the last open of this
// thread returned null.
const char* ankle_p1_failure(const ankle_p1_solver* solver);

void ankle_p1_close(ankle_p1_solver* solver);
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

// ---- 2. model -----------------------------------------------------------------------------------

// What the headers of the runtime (adagen/) are to take from here, and what they are to do.
#define ADAGEN_SOLVER
#define ADAGEN_LOOPS
#define ADAGEN_RECOVERS
#include "adagen/version.hpp"
#if ADAGEN_VERSION != 100
#error "the headers in adagen/ are not those of adagen 0.1.0, which this file was emitted by"
#endif

namespace {

using Number = double;  // of states, answers and messages
using Real = double;    // of all between
constexpr int kProcesses = 1;
[[maybe_unused]] constexpr bool kAlone = true;  // whether process 0 does all, and no other takes part
constexpr int kJointCount = 8, kLinkCount = kJointCount + 1;
constexpr int kNq = 14, kNv = 12;
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
[[maybe_unused]] constexpr int kPlanMessages = 0;
[[maybe_unused]] constexpr double kTolerance = 1e-09;

}  // namespace

#include "adagen/constants.hpp"

namespace {

[[maybe_unused]] constexpr std::array<double, 3> kGravity{0.0, 0.0, -9.81};  // m/s^2
// What can be set at run time, and what it is until then.
[[maybe_unused]] constexpr int kParameterCount = 0;

constexpr std::array<LinkConstants, kLinkCount> kLinks{ {
    {"pelvis", 0.0, {0.0, 0.0, 0.0},
     {0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0},
     {}},
    {"thigh", 6.0, {-0.2, 0.0, 0.0},
     {0.0147, 0.0, 0.0, 0.0, 0.08735, 0.0, 0.0, 0.0, 0.08735},
     {}},
    {"shank", 3.5, {-0.2, 0.0, 0.0},
     {0.004375, 0.0, 0.0, 0.0, 0.0488542, 0.0, 0.0, 0.0, 0.0488542},
     {}},
    {"ankle_cross", 0.15, {0.0, 0.0, 0.0},
     {2.4e-05, 0.0, 0.0, 0.0, 2.4e-05, 0.0, 0.0, 0.0, 2.4e-05},
     {}},
    {"foot", 1.0, {0.0, -0.05, 0.04},
     {0.00416667, 0.0, 0.0, 0.0, 0.00470833, 0.0, 0.0, 0.0, 0.000808333},
     {}},
    {"left_crank", 0.2, {0.0, -0.03, 0.0},
     {6.16667e-05, 0.0, 0.0, 0.0, 8.33333e-06, 0.0, 0.0, 0.0, 6.66667e-05},
     {}},
    {"left_rod", 0.15, {0.0, 0.0, -0.075},
     {0.0002826, 0.0, 0.0, 0.0, 0.0002826, 0.0, 0.0, 0.0, 2.7e-06},
     {}},
    {"right_crank", 0.2, {0.0, -0.03, 0.0},
     {6.16667e-05, 0.0, 0.0, 0.0, 8.33333e-06, 0.0, 0.0, 0.0, 6.66667e-05},
     {}},
    {"right_rod", 0.15, {0.0, 0.0, -0.115},
     {0.0006626, 0.0, 0.0, 0.0, 0.0006626, 0.0, 0.0, 0.0, 2.7e-06},
     {}},
} };

constexpr std::array<JointConstants, kJointCount> kJoints{ {
    {"hip", JointKind::kRevolute, 0, 0, 1, 0, 1,
     {0.0, 1.0, 0.0, 0.0, 0.0, 1.0, 1.0, 0.0, 0.0},
     {0.0, 0.0, 0.0}, -1, 0.0, 0.0},
    {"knee", JointKind::kRevolute, 1, 1, 1, 1, 1,
     {1.0, 0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 1.0},
     {-0.4, 0.0, 0.0}, -1, 0.0, 0.0},
    {"ankle_pitch", JointKind::kRevolute, 2, 2, 1, 2, 1,
     {1.0, 0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 1.0},
     {-0.4, 0.0, 0.0}, -1, 0.0, 0.0},
    {"ankle_roll", JointKind::kRevolute, 3, 3, 1, 3, 1,
     {0.0, 1.0, 0.0, 0.0, 0.0, 1.0, 1.0, 0.0, 0.0},
     {0.0, 0.0, 0.0}, -1, 0.0, 0.0},
    {"left_motor", JointKind::kRevolute, 2, 4, 1, 4, 1,
     {1.0, 0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 1.0},
     {-0.25, 0.0, 0.05}, -1, 0.0, 0.0},
    {"left_ball", JointKind::kSpherical, 5, 5, 4, 5, 3,
     {0.0, 0.0, 1.0, 1.0, 0.0, 0.0, 0.0, 1.0, 0.0},
     {0.0, -0.06, 0.0}, -1, 0.0, 0.0},
    {"right_motor", JointKind::kRevolute, 2, 9, 1, 8, 1,
     {1.0, 0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 1.0},
     {-0.17, 0.0, -0.05}, -1, 0.0, 0.0},
    {"right_ball", JointKind::kSpherical, 7, 10, 4, 9, 3,
     {0.0, 0.0, 1.0, 1.0, 0.0, 0.0, 0.0, 1.0, 0.0},
     {0.0, -0.06, 0.0}, -1, 0.0, 0.0},
} };

[[maybe_unused]] constexpr std::array<OuterForce, kOuterCount> kOuterForces{};

// Loops, then couplings: what statuses name them by.
constexpr int kLoopCount = 2;
constexpr std::array<const char*, 2> kLoopNames{ {
    "left_heel",
    "right_heel",
} };

}  // namespace

// ---- 3. runtime ---------------------------------------------------------------------------------

#include "adagen/status.hpp"
#include "adagen/failures.hpp"

namespace {

constexpr std::array<MessageInfo, 0> kMessages{ {
} };

}  // namespace

#include "adagen/no_channel.hpp"
#include "adagen/stamp.hpp"

// ---- 4. joints ----------------------------------------------------------------------------------

namespace {

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
  alignas(kCacheLine) std::array<Value, 6> angle{}, sine{}, cosine{};
  std::array<Value, kNqdd> result{};
  std::array<Real*, kPlanMessages> to{};          // messages to be sent
  std::array<const Real*, kPlanMessages> from{};  // messages received
  alignas(kCacheLine) std::array<Value, 269> x{};
};

}  // namespace

#include "adagen/unrolled_numbers.hpp"
#include "adagen/unrolled_sines.hpp"
#include "adagen/unrolled.hpp"
#include "adagen/tanh_library.hpp"
#include "adagen/unrolled_functions.hpp"

namespace {

// Each function is a straight line. A value is called x and its number in the expression graph; zeros
// and constants are folded in, nothing is computed twice, and what nobody needs is not there.
// Frames are the links' own; accelerations are deviations from the field that the links would have
// with all joint accelerations zero.

// =================================================================================================
// Process 0: 1069 products, 760 sums, 18 quotients
// =================================================================================================

ADAGEN_NOINLINE void part_0_0(Workspace& w) {
  ADAGEN_INPUTS
  // joint 0 "hip": placement, velocity and reference acceleration of its link
  const Real x9 = sine[0] * 9.81;
  // link 1 "thigh": force that the reference field takes
  const Real x334 = x9 * 1.2000000000000002;
  w.x[0] = x334;
  // joint 1 "knee": placement, velocity and reference acceleration of its link
  const Real x19 = v[0] + v[1];
  const Real x23 = cosine[0] * 9.81 + v[0] * v[0] * 0.4;
  const Real x27 = cosine[1] * x23 - x9 * sine[1];
  const Real x32 = sine[1] * x23 + x9 * cosine[1];
  const Real x36 = x19 * x19;
  // joint 2 "ankle_pitch": placement, velocity and reference acceleration of its link
  const Real x43 = x19 + v[2];
  const Real x46 = x27 + 0.4 * x36;
  const Real x50 = cosine[2] * x46 - x32 * sine[2];
  const Real x55 = sine[2] * x46 + x32 * cosine[2];
  // joint 3 "ankle_roll": placement, velocity and reference acceleration of its link
  const Real x65 = x43 * cosine[3];
  const Real x66 = x43 * sine[3];
  const Real x68 = v[3] * x66;
  const Real x70 = v[3] * x65;
  const Real x72 = x50 * sine[3];
  const Real x73 = x50 * cosine[3];
  const Real x77 = x65 * x65;
  const Real x78 = x66 * x66;
  const Real x80 = v[3] * v[3];
  const Real x83 = x65 * x66;
  const Real x85 = x77 + x80;
  const Real x89 = x77 + x78;
  // link 4 "foot": force that the reference field takes
  const Real x385 = x68 * 0.002999997 - x68 * 0.00826667;
  const Real x405 = 0.002 * (x89 - x85) + x385 + x55 * 0.05;
  const Real x395 = x70 * 0.004958337 - x70 * 0.00630833 + x83 * 0.002;
  const Real x412 = x83 * 0.05;
  // joint 4 "left_motor": placement, velocity and reference acceleration of its link
  const Real x99 = x19 + v[4];
  const Real x103 = x27 + x36 * 0.25;
  const Real x107 = cosine[4] * x103 - x32 * sine[4];
  const Real x112 = sine[4] * x103 + x32 * cosine[4];
  const Real x114 = x99 * x99;
  // joint 5 "left_ball": placement, velocity and reference acceleration of its link
  const Real x128 = q[5] * q[5] + q[6] * q[6] + q[7] * q[7];
  const Real x129 = q[8] * q[8] + x128;
  require_length(w, x129, 5);
  const Real x131 = 2.0 * (1 / x129);
  const Real x132 = q[5] * x131;
  const Real x133 = q[6] * x131;
  const Real x134 = q[7] * x131;
  const Real x135 = q[6] * x133;
  const Real x136 = q[7] * x134;
  const Real x138 = 1.0 - (x135 + x136);
  const Real x139 = q[6] * x132;
  const Real x140 = q[8] * x134;
  const Real x141 = x139 - x140;
  const Real x142 = q[7] * x132;
  const Real x143 = q[8] * x133;
  const Real x144 = x142 + x143;
  const Real x145 = x139 + x140;
  const Real x146 = q[5] * x132;
  const Real x148 = 1.0 - (x136 + x146);
  const Real x149 = q[7] * x133;
  const Real x150 = q[8] * x132;
  const Real x151 = x149 - x150;
  const Real x152 = x142 - x143;
  const Real x153 = x149 + x150;
  const Real x155 = 1.0 - (x135 + x146);
  const Real x157 = x99 * x145;
  const Real x158 = x99 * x148;
  const Real x159 = x99 * x151;
  const Real x160 = v[5] + x157;
  const Real x161 = v[6] + x158;
  const Real x162 = v[7] + x159;
  const Real x166 = v[7] * x158 - v[6] * x159;
  const Real x170 = v[5] * x159 - v[7] * x157;
  const Real x178 = x114 * 0.06 - x112;
  const Real x181 = x107 * x152 + x138 * x178;
  const Real x184 = x107 * x153 + x141 * x178;
  const Real x187 = x107 * x155 + x144 * x178;
  const Real x201 = x161 * x162;
  const Real x202 = x201 - x166;
  const Real x204 = x160 * x160 + x161 * x161;
  const Real x206 = x160 * x162;
  const Real x208 = x170 + x206;
  // link 6 "left_rod": force that the reference field takes
  const Real x463 = (v[6] * x157 - v[5] * x158) * 2.7e-06;
  const Real x467 = x166 * 0.00112635 - x201 * 0.00112365 + x184 * 0.01125;
  const Real x470 = x170 * 0.00112635 + x206 * 0.00112365 - x181 * 0.01125;
  const Real x474 = x181 * 0.15 - x208 * 0.01125;
  const Real x478 = x184 * 0.15 - x202 * 0.01125;
  const Real x482 = x187 * 0.15 + x204 * 0.01125;
  // joint 6 "right_motor": placement, velocity and reference acceleration of its link
  const Real x216 = x19 + v[8];
  const Real x220 = x27 + x36 * 0.17;
  const Real x224 = cosine[5] * x220 - x32 * sine[5];
  const Real x229 = sine[5] * x220 + x32 * cosine[5];
  const Real x231 = x216 * x216;
  // joint 7 "right_ball": placement, velocity and reference acceleration of its link
  const Real x245 = q[10] * q[10] + q[11] * q[11] + q[12] * q[12];
  const Real x246 = q[13] * q[13] + x245;
  require_length(w, x246, 7);
  const Real x248 = 2.0 * (1 / x246);
  const Real x249 = q[10] * x248;
  const Real x250 = q[11] * x248;
  const Real x251 = q[12] * x248;
  const Real x252 = q[11] * x250;
  const Real x253 = q[12] * x251;
  const Real x255 = 1.0 - (x252 + x253);
  const Real x256 = q[11] * x249;
  const Real x257 = q[13] * x251;
  const Real x258 = x256 - x257;
  const Real x259 = q[12] * x249;
  const Real x260 = q[13] * x250;
  const Real x261 = x259 + x260;
  const Real x262 = x256 + x257;
  const Real x263 = q[10] * x249;
  const Real x265 = 1.0 - (x253 + x263);
  const Real x266 = q[12] * x250;
  const Real x267 = q[13] * x249;
  const Real x268 = x266 - x267;
  const Real x269 = x259 - x260;
  const Real x270 = x266 + x267;
  const Real x272 = 1.0 - (x252 + x263);
  const Real x273 = x216 * x262;
  const Real x274 = x216 * x265;
  const Real x275 = x216 * x268;
  const Real x276 = v[9] + x273;
  const Real x277 = v[10] + x274;
  const Real x278 = v[11] + x275;
  const Real x282 = v[11] * x274 - v[10] * x275;
  const Real x286 = v[9] * x275 - v[11] * x273;
  const Real x293 = 0.06 * x231 - x229;
  const Real x296 = x224 * x269 + x255 * x293;
  const Real x299 = x224 * x270 + x258 * x293;
  const Real x302 = x224 * x272 + x261 * x293;
  const Real x316 = x277 * x278;
  const Real x317 = x316 - x282;
  const Real x319 = x276 * x276 + x277 * x277;
  const Real x321 = x276 * x278;
  const Real x323 = x286 + x321;
  // link 8 "right_rod": force that the reference field takes
  const Real x508 = (v[10] * x273 - v[9] * x274) * 2.7e-06;
  const Real x512 = x282 * 0.00264635 - x316 * 0.00264365 + x299 * 0.01725;
  const Real x515 = x286 * 0.00264635 + x321 * 0.00264365 - x296 * 0.01725;
  const Real x519 = x296 * 0.15 - x323 * 0.01725;
  const Real x523 = x299 * 0.15 - x317 * 0.01725;
  const Real x527 = x302 * 0.15 + x319 * 0.01725;
  // what a loop holds its two links by
  const Real x529 = cosine[3] * 0.05;
  const Real x530 = sine[3] * 0.05;
  const Real x531 = cosine[2] * x530;
  w.x[1] = x531;
  const Real x532 = sine[2] * 0.06;
  const Real x535 = sine[2] * x530;
  w.x[2] = x535;
  const Real x536 = cosine[2] * 0.06;
  const Real x540 = x155 * 0.15;
  const Real x542 = x144 * 0.15;
  const Real x546 = -0.06 - x542;
  const Real x557 = -0.25 - (cosine[4] * x540 + sine[4] * x546);
  const Real x559 = x531 + x532 + -0.4 - x557;
  const Real x560 = x535 - x536 - (cosine[4] * x546 - sine[4] * x540);
  const Real x561 = x529 - (0.05 - x151 * 0.15);
  const Real x568 = v[2] * sine[3];
  const Real x570 = 0.06 * x568;
  const Real x572 = v[3] * 0.05;
  const Real x573 = 0.06 * (v[2] * cosine[3]);
  const Real x575 = x572 + x573;
  const Real x576 = 0.05 * x568;
  const Real x578 = cosine[3] * x570;
  const Real x582 = sine[3] * x570;
  const Real x584 = x582 + cosine[3] * x575;
  const Real x586 = sine[2] * x576;
  const Real x590 = cosine[2] * x576;
  const Real x592 = v[4] * 0.06;
  const Real x596 = x155 * x592;
  const Real x605 = x152 * x592 - 0.15 * (v[6] + v[4] * x148);
  const Real x608 = x153 * x592 + 0.15 * (v[5] + v[4] * x145);
  const Real x613 = x153 * x608 + x155 * x596 + x152 * x605;
  const Real x618 = x141 * x608 + x144 * x596 + x138 * x605;
  const Real x627 = cosine[4] * x613 - sine[4] * x618;
  const Real x631 = cosine[2] * x584 - x586 - x627;
  const Real x630 = sine[4] * x613 + cosine[4] * x618;
  const Real x632 = sine[2] * x584 + x590 - x630;
  const Real x623 = x148 * x608 + x151 * x596 + x145 * x605;
  const Real x633 = x578 - sine[3] * x575 - x623;
  const Real x643 = v[2] * v[2];
  const Real x645 = v[4] * v[4] + v[5] * v[5] + v[6] * v[6];
  const Real x649 = v[7] * v[7] + x645 + x643 + x80 + 1.0;
  const Real x566 = x560 * x560 + x561 * x561 + x559 * x559;
  const Real x653 = 1e-08 - x566;
  require_more(w, x653, 0.0, kLoopOpen, 8);
  const Real x638 = x631 * x631 + x633 * x633 + x632 * x632;
  const Real x654 = x649 * 1e-06 - x638;
  require_more(w, x654, 0.0, kLoopTorn, 8);
  const Real x658 = cosine[4] * x152 - sine[4] * x138;
  const Real x661 = sine[4] * x152 + cosine[4] * x138;
  const Real x664 = cosine[2] * x658 + sine[2] * x661;
  const Real x668 = cosine[2] * x661 - sine[2] * x658;
  const Real x671 = cosine[3] * x145 + sine[3] * x664;
  const Real x675 = cosine[3] * x664 - sine[3] * x145;
  const Real x687 = (x78 + x80) * 0.05;
  const Real x689 = x72 - x687;
  const Real x690 = x73 - x412;
  const Real x691 = 2.0 * x70 * 0.05;
  const Real x692 = x89 * 0.06;
  const Real x695 = x691 + x692 - x55;
  const Real x708 = 0.05 * x675;
  w.x[3] = x708;
  const Real x700 = x671 * x689 + x668 * x695 + x675 * x690;
  const Real x709 = x700 - (x181 - x208 * 0.15);
  w.x[4] = x709;
  const Real x713 = cosine[4] * x153 - sine[4] * x141;
  const Real x716 = sine[4] * x153 + cosine[4] * x141;
  const Real x719 = cosine[2] * x713 + sine[2] * x716;
  const Real x723 = cosine[2] * x716 - sine[2] * x713;
  const Real x726 = cosine[3] * x148 + sine[3] * x719;
  const Real x730 = cosine[3] * x719 - sine[3] * x148;
  const Real x744 = 0.05 * x730;
  w.x[5] = x744;
  const Real x736 = x689 * x726 + x695 * x723 + x690 * x730;
  const Real x745 = x736 - (x184 - x202 * 0.15);
  w.x[6] = x745;
  const Real x749 = cosine[4] * x155 - sine[4] * x144;
  const Real x752 = sine[4] * x155 + cosine[4] * x144;
  const Real x755 = cosine[2] * x749 + sine[2] * x752;
  const Real x759 = cosine[2] * x752 - sine[2] * x749;
  const Real x762 = cosine[3] * x151 + sine[3] * x755;
  const Real x766 = cosine[3] * x755 - sine[3] * x151;
  const Real x780 = 0.05 * x766;
  w.x[7] = x780;
  const Real x772 = x689 * x762 + x695 * x759 + x690 * x766;
  const Real x781 = x772 - (x187 + x204 * 0.15);
  w.x[8] = x781;
  // what a loop holds its two links by
  const Real x792 = x272 * 0.23;
  const Real x798 = -0.06 - x261 * 0.23;
  const Real x809 = -0.17 - (cosine[5] * x792 + sine[5] * x798);
  const Real x811 = x532 - x531 + -0.4 - x809;
  const Real x812 = x535 + x536 + (cosine[5] * x798 - sine[5] * x792);
  const Real x814 = -0.05 - x268 * 0.23 + x529;
  const Real x824 = x573 - x572;
  const Real x829 = x582 + cosine[3] * x824;
  const Real x835 = 0.06 * v[8];
  const Real x839 = x272 * x835;
  const Real x848 = x269 * x835 - 0.23 * (v[10] + v[8] * x265);
  const Real x851 = x270 * x835 + 0.23 * (v[9] + v[8] * x262);
  const Real x856 = x270 * x851 + x272 * x839 + x269 * x848;
  const Real x861 = x258 * x851 + x261 * x839 + x255 * x848;
  const Real x870 = cosine[5] * x856 - sine[5] * x861;
  const Real x874 = x586 + cosine[2] * x829 - x870;
  const Real x873 = sine[5] * x856 + cosine[5] * x861;
  const Real x875 = sine[2] * x829 - x590 - x873;
  const Real x866 = x265 * x851 + x268 * x839 + x262 * x848;
  const Real x876 = x578 - sine[3] * x824 - x866;
  const Real x887 = v[8] * v[8] + v[9] * v[9] + v[10] * v[10];
  const Real x891 = v[11] * v[11] + x887 + x643 + x80 + 1.0;
  const Real x822 = x812 * x812 + x814 * x814 + x811 * x811;
  const Real x893 = 1e-08 - x822;
  require_more(w, x893, 0.0, kLoopOpen, 9);
  const Real x881 = x874 * x874 + x876 * x876 + x875 * x875;
  const Real x894 = 1e-06 * x891 - x881;
  require_more(w, x894, 0.0, kLoopTorn, 9);
  const Real x898 = cosine[5] * x269 - sine[5] * x255;
  const Real x901 = sine[5] * x269 + cosine[5] * x255;
  const Real x904 = cosine[2] * x898 + sine[2] * x901;
  const Real x908 = cosine[2] * x901 - sine[2] * x898;
  const Real x911 = cosine[3] * x262 + sine[3] * x904;
  const Real x915 = cosine[3] * x904 - sine[3] * x262;
  const Real x926 = x72 + x687;
  const Real x927 = x73 + x412;
  const Real x930 = x692 - x691 - x55;
  const Real x943 = 0.05 * x915;
  w.x[9] = x943;
  const Real x935 = x911 * x926 + x908 * x930 + x915 * x927;
  const Real x945 = x935 - (x296 - x323 * 0.23);
  w.x[10] = x945;
  const Real x949 = cosine[5] * x270 - sine[5] * x258;
  const Real x952 = sine[5] * x270 + cosine[5] * x258;
  const Real x955 = cosine[2] * x949 + sine[2] * x952;
  const Real x959 = cosine[2] * x952 - sine[2] * x949;
  const Real x962 = cosine[3] * x265 + sine[3] * x955;
  const Real x966 = cosine[3] * x955 - sine[3] * x265;
  const Real x980 = 0.05 * x966;
  w.x[11] = x980;
  const Real x972 = x926 * x962 + x930 * x959 + x927 * x966;
  const Real x982 = x972 - (x299 - x317 * 0.23);
  w.x[12] = x982;
  const Real x986 = cosine[5] * x272 - sine[5] * x261;
  const Real x989 = sine[5] * x272 + cosine[5] * x261;
  const Real x992 = cosine[2] * x986 + sine[2] * x989;
  const Real x996 = cosine[2] * x989 - sine[2] * x986;
  const Real x999 = cosine[3] * x268 + sine[3] * x992;
  const Real x1003 = cosine[3] * x992 - sine[3] * x268;
  const Real x1017 = 0.05 * x1003;
  w.x[13] = x1017;
  const Real x1009 = x926 * x999 + x930 * x996 + x927 * x1003;
  const Real x1019 = x1009 - (x302 + x319 * 0.23);
  w.x[14] = x1019;
  // joint 7 "right_ball": inertia and bias force of what is beyond, its own motion left open
  const Real x1023 = x512 - tau[9];
  w.x[15] = x1023;
  const Real x1024 = x515 - tau[10];
  w.x[16] = x1024;
  const Real x1025 = x508 - tau[11];
  w.x[17] = x1025;
  const Real x1028 = x262 * 0.00264635;
  const Real x1029 = x270 * 0.01725;
  const Real x1030 = x258 * 0.01725;
  const Real x1031 = x265 * 0.01725;
  const Real x1037 = x1028 + 0.06 * x1029;
  w.x[18] = x1037;
  const Real x1040 = x265 * 0.00264635;
  const Real x1041 = x269 * 0.01725;
  const Real x1043 = x255 * 0.01725;
  const Real x1045 = x262 * 0.01725;
  const Real x1052 = x1040 - 0.06 * x1041;
  w.x[19] = x1052;
  const Real x1055 = x268 * 2.7e-06;
  w.x[20] = x1055;
  const Real x1067 = x265 * 0.23 - 0.06 * x269;
  w.x[21] = x1067;
  const Real x1082 = x262 * 0.23 + 0.06 * x270;
  w.x[22] = x1082;
  const Real x1089 = 0.06 * x272;
  w.x[23] = x1089;
  const Real x1121 = x270 * x1045 - x269 * x1031;
  const Real x1160 = x269 * 0.15;
  const Real x1161 = x270 * 0.15;
  const Real x1162 = x272 * 0.15;
  const Real x1173 = x269 * x1160 + x270 * x1161 + x272 * x1162;
  const Real x1178 = x255 * x1160 + x258 * x1161 + x261 * x1162;
  const Real x1187 = x258 * (x258 * 0.15) + x261 * (x261 * 0.15);
  const Real x1204 = x1121 + 0.06 * x1173;
  const Real x1210 = x258 * x1045 - x255 * x1031 + 0.06 * x1178;
  const Real x1159 = x262 * x1028 + x268 * x1055 + x265 * x1040;
  const Real x1242 = x1159 + 0.06 * x1121 + 0.06 * x1204 + 0.0002466667;
  w.x[24] = x1242;
  const Real x1243 = 0.006 + x1204;
  const Real x1244 = 0.2 + x1173;
  const Real x1245 = x255 * (x255 * 0.15) + x1187 + 0.2;
  const Real x1266 = x269 * x519 + x270 * x523 + x272 * x527;
  const Real x1261 = x262 * x512 + x268 * x508 + x265 * x515;
  const Real x1283 = x1261 + 0.06 * x1266 + x224 * 0.006;
  const Real x1284 = x224 * 0.2 + x1266;
  const Real x1271 = x255 * x519 + x258 * x523 + x261 * x527;
  const Real x1285 = x231 * 0.006 - x229 * 0.2 + x1271;
  // joint 6 "right_motor": inertia and bias force of what is beyond, its own motion left open
  const Real x1287 = x1283 - tau[8];
  w.x[25] = x1287;
  const Real x1298 = cosine[5] * x1243 - sine[5] * x1210;
  w.x[26] = x1298;
  const Real x1301 = sine[5] * x1243 + cosine[5] * x1210;
  w.x[27] = x1301;
  const Real x1313 = x1242 - 0.17 * x1301;
  w.x[28] = x1313;
  const Real x1324 = cosine[5] * x1029 - sine[5] * x1030;
  w.x[29] = x1324;
  const Real x1327 = sine[5] * x1029 + cosine[5] * x1030;
  w.x[30] = x1327;
  const Real x1339 = x1037 - 0.17 * x1327;
  w.x[31] = x1339;
  const Real x1351 = sine[5] * x1043 - cosine[5] * x1041;
  w.x[32] = x1351;
  const Real x1356 = sine[5] * x1041 + cosine[5] * x1043;
  w.x[33] = x1356;
  const Real x1369 = x1052 + 0.17 * x1356;
  w.x[34] = x1369;
  const Real x1489 = cosine[5] * (x1244 - x1245) - x1178 * (2.0 * sine[5]);
  const Real x1492 = x1178 + sine[5] * x1489;
  const Real x1493 = cosine[5] * x1489;
  const Real x1495 = x1244 - x1493;
  const Real x1517 = x1301 - 0.17 * x1495;
  const Real x1585 = sine[5] * x1284 + cosine[5] * x1285;
  // link 2 "shank": force that the reference field takes
  const Real x356 = x27 * 3.5 + x36 * 0.7000000000000001;
  // joint 5 "left_ball": inertia and bias force of what is beyond, its own motion left open
  const Real x1604 = x467 - tau[5];
  w.x[35] = x1604;
  const Real x1605 = x470 - tau[6];
  w.x[36] = x1605;
  const Real x1606 = x463 - tau[7];
  w.x[37] = x1606;
  const Real x1609 = x145 * 0.00112635;
  const Real x1610 = x153 * 0.01125;
  const Real x1611 = x141 * 0.01125;
  const Real x1612 = x148 * 0.01125;
  const Real x1618 = x1609 + 0.06 * x1610;
  w.x[38] = x1618;
  const Real x1621 = x148 * 0.00112635;
  const Real x1622 = x152 * 0.01125;
  const Real x1624 = x138 * 0.01125;
  const Real x1626 = x145 * 0.01125;
  const Real x1633 = x1621 - 0.06 * x1622;
  w.x[39] = x1633;
  const Real x1636 = x151 * 2.7e-06;
  w.x[40] = x1636;
  const Real x1637 = x153 * 0.15;
  const Real x1648 = x148 * 0.15 - x152 * 0.06;
  w.x[41] = x1648;
  const Real x1649 = x152 * 0.15;
  const Real x1663 = x145 * 0.15 + x153 * 0.06;
  w.x[42] = x1663;
  const Real x1670 = x155 * 0.06;
  w.x[43] = x1670;
  const Real x1702 = x153 * x1626 - x152 * x1612;
  const Real x1745 = x152 * x1649 + x153 * x1637 + x155 * x540;
  const Real x1750 = x138 * x1649 + x141 * x1637 + x144 * x540;
  const Real x1759 = x141 * (x141 * 0.15) + x144 * x542;
  const Real x1776 = x1702 + 0.06 * x1745;
  const Real x1782 = x141 * x1626 - x138 * x1612 + 0.06 * x1750;
  const Real x1740 = x145 * x1609 + x151 * x1636 + x148 * x1621;
  const Real x1814 = x1740 + 0.06 * x1702 + 0.06 * x1776 + 0.0002466667;
  w.x[44] = x1814;
  const Real x1815 = 0.006 + x1776;
  const Real x1816 = 0.2 + x1745;
  const Real x1817 = x138 * (x138 * 0.15) + x1759 + 0.2;
  const Real x1838 = x152 * x474 + x153 * x478 + x155 * x482;
  const Real x1833 = x145 * x467 + x151 * x463 + x148 * x470;
  const Real x1855 = x1833 + 0.06 * x1838 + x107 * 0.006;
  const Real x1856 = x107 * 0.2 + x1838;
  const Real x1843 = x138 * x474 + x141 * x478 + x144 * x482;
  const Real x1857 = x114 * 0.006 - x112 * 0.2 + x1843;
  // joint 4 "left_motor": inertia and bias force of what is beyond, its own motion left open
  const Real x1859 = x1855 - tau[4];
  w.x[45] = x1859;
  const Real x1870 = cosine[4] * x1815 - sine[4] * x1782;
  w.x[46] = x1870;
  const Real x1873 = sine[4] * x1815 + cosine[4] * x1782;
  w.x[47] = x1873;
  const Real x1884 = x1814 - 0.25 * x1873;
  w.x[48] = x1884;
  const Real x1895 = cosine[4] * x1610 - sine[4] * x1611;
  w.x[49] = x1895;
  const Real x1898 = sine[4] * x1610 + cosine[4] * x1611;
  w.x[50] = x1898;
  const Real x1909 = x1618 - 0.25 * x1898;
  w.x[51] = x1909;
  const Real x1921 = sine[4] * x1624 - cosine[4] * x1622;
  w.x[52] = x1921;
  const Real x1926 = sine[4] * x1622 + cosine[4] * x1624;
  w.x[53] = x1926;
  const Real x1938 = x1633 + 0.25 * x1926;
  w.x[54] = x1938;
  const Real x2059 = cosine[4] * (x1816 - x1817) - x1750 * (2.0 * sine[4]);
  const Real x2062 = x1750 + sine[4] * x2059;
  const Real x2063 = cosine[4] * x2059;
  const Real x2065 = x1816 - x2063;
  const Real x2086 = x1873 - 0.25 * x2065;
  // joint 6 "right_motor": inertia and bias force of what is beyond, its own motion left open
  const Real x1567 = x1313 - 0.17 * x1517 + 0.18885420000000003;
  // joint 4 "left_motor": inertia and bias force of what is beyond, its own motion left open
  const Real x2146 = x1492 + x2062;
  w.x[55] = x2146;
  const Real x2164 = sine[4] * x1856 + cosine[4] * x1857;
  // joint 6 "right_motor": inertia and bias force of what is beyond, its own motion left open
  const Real x1598 = x1283 - 0.17 * x1585 + x32 * 0.7000000000000001;
  // joint 4 "left_motor": inertia and bias force of what is beyond, its own motion left open
  const Real x2178 = x1855 - 0.25 * x2164 + x1598;
  w.x[56] = x2178;
  // joint 6 "right_motor": inertia and bias force of what is beyond, its own motion left open
  const Real x1599 = cosine[5] * x1284 - sine[5] * x1285 + x356;
  // joint 4 "left_motor": inertia and bias force of what is beyond, its own motion left open
  const Real x2179 = cosine[4] * x1856 - sine[4] * x1857 + x1599;
  w.x[57] = x2179;
  const Real x2180 = x1585 - x32 * 3.5 + x2164;
  w.x[58] = x2180;
  // joint 3 "ankle_roll": inertia and bias force of what is beyond, its own motion left open
  const Real x2183 = x83 * 0.0019583400000000003 + x72 * 0.05 - tau[3];
  w.x[59] = x2183;
  const Real x2184 = sine[3] * 0.002;
  w.x[60] = x2184;
  const Real x2188 = sine[3] * (0.06 * x671 + 0.05 * x668);
  const Real x2190 = cosine[3] * (0.06 * x675) + x2188;
  w.x[61] = x2190;
  const Real x2203 = sine[3] * (0.06 * x726 + 0.05 * x723);
  const Real x2205 = cosine[3] * (0.06 * x730) + x2203;
  w.x[62] = x2205;
  const Real x2218 = sine[3] * (0.06 * x762 + 0.05 * x759);
  const Real x2220 = cosine[3] * (0.06 * x766) + x2218;
  w.x[63] = x2220;
  const Real x2233 = sine[3] * (0.05 * x908 - 0.06 * x911);
  const Real x2235 = cosine[3] * (0.06 * x915) - x2233;
  w.x[64] = x2235;
  const Real x2247 = sine[3] * (0.05 * x959 - 0.06 * x962);
  const Real x2249 = cosine[3] * (0.06 * x966) - x2247;
  w.x[65] = x2249;
  const Real x2261 = sine[3] * (0.05 * x996 - 0.06 * x999);
  const Real x2263 = cosine[3] * (0.06 * x1003) - x2261;
  w.x[66] = x2263;
  const Real x2284 = 0.00630833 + cosine[3] * (cosine[3] * 0.0019583400000000003) + 2.4e-05;
  w.x[67] = x2284;
  const Real x2286 = cosine[3] * (x405 - x73 * 0.04);
  const Real x2289 = x2286 - sine[3] * (x395 + x72 * 0.04);
  w.x[68] = x2289;
  const Real x2298 = cosine[3] * (x73 + x85 * 0.05);
  const Real x2300 = sine[3] * (x72 + x412) + x2298 + x50 * 0.15;
  w.x[69] = x2300;
  // link 4 "foot": force that the reference field takes
  const Real x423 = 2.0 * x68 * 0.05 - x89 * 0.04 - x55;
  // joint 3 "ankle_roll": inertia and bias force of what is beyond, its own motion left open
  const Real x2301 = x423 - x55 * 0.15;
  w.x[70] = x2301;
  // joint 2 "ankle_pitch": inertia and bias force of what is beyond, its own motion left open
  const Real x2303 = x2289 - tau[2];
  w.x[71] = x2303;
  const Real x2316 = sine[2] * x529 - cosine[2] * 0.04;
  w.x[72] = x2316;
  const Real x2321 = sine[2] * 0.04 + cosine[2] * x529;
  w.x[73] = x2321;
  const Real x2325 = x2284 + 0.4 * x2321;
  w.x[74] = x2325;
  const Real x2338 = x2184 + 0.4 * x535;
  w.x[75] = x2338;
  const Real x2514 = -0.46 - x2321;
  // joint 4 "left_motor": inertia and bias force of what is beyond, its own motion left open
  const Real x2141 = x1884 - 0.25 * x2086 + x1567;
  // joint 2 "ankle_pitch": inertia and bias force of what is beyond, its own motion left open
  const Real x2539 = x2325 - 0.4 * x2514 + x2141;
  w.x[76] = x2539;
  // joint 4 "left_motor": inertia and bias force of what is beyond, its own motion left open
  const Real x2142 = x1298 - 0.17 * x1492 + (x1870 - 0.25 * x2062);
  // joint 2 "ankle_pitch": inertia and bias force of what is beyond, its own motion left open
  const Real x2540 = x2142 + x2316;
  w.x[77] = x2540;
  const Real x2541 = -0.7000000000000001 + x1517 + x2086 + x2514;
  w.x[78] = x2541;
  const Real x2542 = x1245 + x1493 + 3.5 + (x1817 + x2063) + 1.15;
  w.x[79] = x2542;
  const Real x2543 = 3.5 + x1495 + x2065 + 1.15;
  w.x[80] = x2543;
  const Real x2552 = cosine[2] * x2300;
  w.x[81] = x2552;
  const Real x2553 = sine[2] * x2301;
  w.x[82] = x2553;
}

ADAGEN_NOINLINE void part_0_1(Workspace& w) {
  ADAGEN_INPUTS
  const Real x334 = w.x[0];
  const Real x531 = w.x[1];
  const Real x535 = w.x[2];
  const Real x708 = w.x[3];
  const Real x709 = w.x[4];
  const Real x744 = w.x[5];
  const Real x745 = w.x[6];
  const Real x780 = w.x[7];
  const Real x781 = w.x[8];
  const Real x943 = w.x[9];
  const Real x945 = w.x[10];
  const Real x980 = w.x[11];
  const Real x982 = w.x[12];
  const Real x1017 = w.x[13];
  const Real x1019 = w.x[14];
  const Real x1023 = w.x[15];
  const Real x1024 = w.x[16];
  const Real x1025 = w.x[17];
  const Real x1037 = w.x[18];
  const Real x1052 = w.x[19];
  const Real x1055 = w.x[20];
  const Real x1067 = w.x[21];
  const Real x1082 = w.x[22];
  const Real x1089 = w.x[23];
  const Real x1242 = w.x[24];
  const Real x1287 = w.x[25];
  const Real x1298 = w.x[26];
  const Real x1301 = w.x[27];
  const Real x1313 = w.x[28];
  const Real x1324 = w.x[29];
  const Real x1327 = w.x[30];
  const Real x1339 = w.x[31];
  const Real x1351 = w.x[32];
  const Real x1356 = w.x[33];
  const Real x1369 = w.x[34];
  const Real x1604 = w.x[35];
  const Real x1605 = w.x[36];
  const Real x1606 = w.x[37];
  const Real x1618 = w.x[38];
  const Real x1633 = w.x[39];
  const Real x1636 = w.x[40];
  const Real x1648 = w.x[41];
  const Real x1663 = w.x[42];
  const Real x1670 = w.x[43];
  const Real x1814 = w.x[44];
  const Real x1859 = w.x[45];
  const Real x1870 = w.x[46];
  const Real x1873 = w.x[47];
  const Real x1884 = w.x[48];
  const Real x1895 = w.x[49];
  const Real x1898 = w.x[50];
  const Real x1909 = w.x[51];
  const Real x1921 = w.x[52];
  const Real x1926 = w.x[53];
  const Real x1938 = w.x[54];
  const Real x2146 = w.x[55];
  const Real x2178 = w.x[56];
  const Real x2179 = w.x[57];
  const Real x2180 = w.x[58];
  const Real x2183 = w.x[59];
  const Real x2184 = w.x[60];
  const Real x2190 = w.x[61];
  const Real x2205 = w.x[62];
  const Real x2220 = w.x[63];
  const Real x2235 = w.x[64];
  const Real x2249 = w.x[65];
  const Real x2263 = w.x[66];
  const Real x2284 = w.x[67];
  const Real x2289 = w.x[68];
  const Real x2300 = w.x[69];
  const Real x2301 = w.x[70];
  const Real x2303 = w.x[71];
  const Real x2316 = w.x[72];
  const Real x2321 = w.x[73];
  const Real x2325 = w.x[74];
  const Real x2338 = w.x[75];
  const Real x2539 = w.x[76];
  const Real x2540 = w.x[77];
  const Real x2541 = w.x[78];
  const Real x2542 = w.x[79];
  const Real x2543 = w.x[80];
  const Real x2552 = w.x[81];
  const Real x2553 = w.x[82];
  // joint 2 "ankle_pitch": inertia and bias force of what is beyond, its own motion left open
  const Real x2558 = sine[2] * x2300 + cosine[2] * x2301;
  // link 2 "shank": accelerations and constraint forces of loops below it are eliminated
  const Real x2574 = x1648 * 8.0;
  const Real x2576 = x1663 * 8.0;
  const Real x2579 = x1670 * 16.0;
  const Real x2581 = x1067 * 4.0;
  const Real x2583 = x1082 * 4.0;
  const Real x2586 = x1089 * 16.0;
  const Real x2588 = x2190 * 8.0;
  const Real x2589 = x708 * 8.0;
  const Real x2590 = x709 * 8.0;
  const Real x2591 = x2205 * 8.0;
  const Real x2592 = x744 * 8.0;
  const Real x2593 = x745 * 8.0;
  const Real x2594 = x2220 * 16.0;
  const Real x2595 = x780 * 16.0;
  const Real x2596 = x781 * 16.0;
  const Real x2597 = x2235 * 4.0;
  const Real x2598 = x943 * 4.0;
  const Real x2600 = x945 * 4.0;
  const Real x2601 = x2249 * 4.0;
  const Real x2602 = x980 * 4.0;
  const Real x2604 = x982 * 4.0;
  const Real x2605 = x2263 * 16.0;
  const Real x2606 = x1017 * 16.0;
  const Real x2608 = x1019 * 16.0;
  const Real x2615 = x2576 * x2576 + x2579 * x2579;
  const Real x2618 = sign_of(x2574) * sqrt_of(x2574 * x2574 + x2615);
  const Real x2619 = x2574 + x2618;
  const Real x2621 = x2615 + x2619 * x2619;
  const Real x2623 = 2.0 * (1 / x2621);
  const Real x2626 = x2623 * (1.2 * x2576);
  const Real x2627 = x2619 * x2626;
  const Real x2630 = x2579 * x2626;
  const Real x2633 = -1.2 + x2576 * x2626;
  const Real x2635 = x2623 * (1.2 * x2619);
  const Real x2637 = x2576 * x2635;
  const Real x2639 = x2579 * x2635;
  const Real x2641 = 1.2 - x2619 * x2635;
  const Real x2649 = x2588 * x2619 - (x2576 * x2591 + x2579 * x2594);
  const Real x2650 = x2623 * x2649;
  const Real x2657 = x2591 + x2576 * x2650;
  const Real x2658 = x2594 + x2579 * x2650;
  const Real x2666 = x2589 * x2619 - (x2576 * x2592 + x2579 * x2595);
  const Real x2667 = x2623 * x2666;
  const Real x2674 = x2592 + x2576 * x2667;
  const Real x2675 = x2595 + x2579 * x2667;
  const Real x2682 = x2590 * x2619 - x2576 * x2593 - x2579 * x2596;
  const Real x2683 = x2623 * x2682;
  const Real x2690 = x2593 + x2576 * x2683;
  const Real x2691 = x2596 + x2579 * x2683;
  const Real x2695 = x2630 * x2630;
  const Real x2698 = sign_of(x2633) * sqrt_of(x2633 * x2633 + x2695);
  const Real x2699 = x2633 + x2698;
  const Real x2701 = x2695 + x2699 * x2699;
  const Real x2703 = 2.0 * (1 / x2701);
  const Real x2707 = x2703 * (x2637 * x2699 + x2630 * x2639);
  const Real x2710 = x2637 - x2699 * x2707;
  const Real x2711 = x2639 - x2630 * x2707;
  const Real x2715 = x2703 * (x2657 * x2699 + x2630 * x2658);
  const Real x2723 = x2703 * (x2674 * x2699 + x2630 * x2675);
  const Real x2731 = x2703 * (x2690 * x2699 + x2630 * x2691);
  const Real x2743 = x2583 * x2583 + x2586 * x2586;
  const Real x2746 = sign_of(x2581) * sqrt_of(x2581 * x2581 + x2743);
  const Real x2747 = x2581 + x2746;
  const Real x2749 = x2743 + x2747 * x2747;
  const Real x2751 = 2.0 * (1 / x2749);
  const Real x2754 = x2751 * (0.92 * x2583);
  const Real x2755 = x2747 * x2754;
  const Real x2758 = x2586 * x2754;
  const Real x2761 = -0.92 + x2583 * x2754;
  const Real x2763 = x2751 * (0.92 * x2747);
  const Real x2765 = x2583 * x2763;
  const Real x2767 = x2586 * x2763;
  const Real x2769 = 0.92 - x2747 * x2763;
  const Real x2777 = x2597 * x2747 - (x2583 * x2601 + x2586 * x2605);
  const Real x2778 = x2751 * x2777;
  const Real x2785 = x2601 + x2583 * x2778;
  const Real x2786 = x2605 + x2586 * x2778;
  const Real x2794 = x2583 * x2602 + x2586 * x2606 - x2598 * x2747;
  const Real x2795 = x2751 * x2794;
  const Real x2803 = x2583 * x2795 - x2602;
  const Real x2804 = x2586 * x2795 - x2606;
  const Real x2811 = x2600 * x2747 - x2583 * x2604 - x2586 * x2608;
  const Real x2812 = x2751 * x2811;
  const Real x2819 = x2604 + x2583 * x2812;
  const Real x2820 = x2608 + x2586 * x2812;
  const Real x2824 = x2758 * x2758;
  const Real x2827 = sign_of(x2761) * sqrt_of(x2761 * x2761 + x2824);
  const Real x2828 = x2761 + x2827;
  const Real x2830 = x2824 + x2828 * x2828;
  const Real x2832 = 2.0 * (1 / x2830);
  const Real x2836 = x2832 * (x2765 * x2828 + x2758 * x2767);
  const Real x2839 = x2765 - x2828 * x2836;
  const Real x2840 = x2767 - x2758 * x2836;
  const Real x2844 = x2832 * (x2785 * x2828 + x2758 * x2786);
  const Real x2852 = x2832 * (x2803 * x2828 + x2758 * x2804);
  const Real x2860 = x2832 * (x2819 * x2828 + x2758 * x2820);
  const Real x2866 = 1 / x2840;
  const Real x2867 = (x2786 - x2758 * x2844) * x2866;
  const Real x2868 = (x2804 - x2758 * x2852) * x2866;
  const Real x2869 = (x2820 - x2758 * x2860) * x2866;
  const Real x2870 = 1 / x2827;
  const Real x2875 = x2870 * (x2785 - x2828 * x2844 - x2839 * x2867);
  const Real x2880 = x2870 * (x2803 - x2828 * x2852 - x2839 * x2868);
  const Real x2885 = x2870 * (x2819 - x2828 * x2860 - x2839 * x2869);
  const Real x2887 = 1 / x2746;
  const Real x2893 = x2597 - x2747 * x2778 - x2769 * x2867;
  const Real x2895 = x2887 * (x2893 - x2755 * x2875);
  const Real x2901 = x2598 + x2747 * x2795 + x2769 * x2868;
  const Real x2905 = x2887 * (x2755 * x2880 + x2901);
  const Real x2911 = x2600 - x2747 * x2812 - x2769 * x2869;
  const Real x2913 = x2887 * (x2911 - x2755 * x2885);
  const Real x2915 = 1 / x2711;
  const Real x2916 = (x2658 - x2630 * x2715) * x2915;
  const Real x2917 = (x2675 - x2630 * x2723) * x2915;
  const Real x2918 = (x2691 - x2630 * x2731) * x2915;
  const Real x2919 = 1 / x2698;
  const Real x2924 = x2919 * (x2657 - x2699 * x2715 - x2710 * x2916);
  const Real x2929 = x2919 * (x2674 - x2699 * x2723 - x2710 * x2917);
  const Real x2934 = x2919 * (x2690 - x2699 * x2731 - x2710 * x2918);
  const Real x2936 = 1 / x2618;
  const Real x2942 = x2588 - x2619 * x2650 - x2641 * x2916;
  const Real x2944 = x2936 * (x2942 - x2627 * x2924);
  const Real x2950 = x2589 - x2619 * x2667 - x2641 * x2917;
  const Real x2952 = x2936 * (x2950 - x2627 * x2929);
  const Real x2958 = x2590 - x2619 * x2683 - x2641 * x2918;
  const Real x2960 = x2936 * (x2958 - x2627 * x2934);
  const Real x2968 = x2618 * x2618;
  require_more(w, x2968, 9.999999999999998e-15, kSingularPose, 8);
  const Real x2971 = x2698 * x2698;
  require_more(w, x2971, 9.999999999999998e-15, kSingularPose, 8);
  const Real x2973 = x2711 * x2711;
  require_more(w, x2973, 9.999999999999998e-15, kSingularPose, 8);
  const Real x2974 = x2746 * x2746;
  require_more(w, x2974, 9.999999999999998e-15, kSingularPose, 9);
  const Real x2976 = x2827 * x2827;
  require_more(w, x2976, 9.999999999999998e-15, kSingularPose, 9);
  const Real x2978 = x2840 * x2840;
  require_more(w, x2978, 9.999999999999998e-15, kSingularPose, 9);
  const Real x2997 = x2916 * x2916 + x2917 * x2917 + x2867 * x2867;
  const Real x2999 = x2868 * x2868 + x2997 + x2924 * x2924;
  const Real x3001 = x2929 * x2929 + x2999 + x2875 * x2875;
  const Real x3003 = x2880 * x2880 + x3001 + x2944 * x2944;
  const Real x3005 = x2952 * x2952 + x3003 + x2895 * x2895;
  const Real x3008 = 40000.0 - (x2905 * x2905 + x3005);
  require_more(w, x3008, 0.0, kSingularPose, 8);
  const Real x3014 = x1618 * x2924 - x1633 * x2916 + x1814 * x2944;
  const Real x3020 = x1618 * x2929 - x1633 * x2917 + x1814 * x2952;
  const Real x3023 = x1618 * x2944 + 0.00112635 * x2924;
  const Real x3026 = x1618 * x2952 + 0.00112635 * x2929;
  const Real x3030 = x1633 * x2944 - 0.00112635 * x2916;
  const Real x3034 = x1633 * x2952 - 0.00112635 * x2917;
  const Real x3040 = x1037 * x2875 - x1052 * x2867 + x1242 * x2895;
  const Real x3047 = x1037 * x2880 - x1052 * x2868 - x1242 * x2905;
  const Real x3050 = x1037 * x2895 + 0.00264635 * x2875;
  const Real x3054 = 0.00264635 * x2880 - x1037 * x2905;
  const Real x3058 = x1052 * x2895 - 0.00264635 * x2867;
  const Real x3063 = x1052 * x2905 + 0.00264635 * x2868;
  const Real x3074 = x2944 * x3014 + x2924 * x3023 - x2916 * x3030;
  const Real x3076 = x2895 * x3040 + x3074 + x2875 * x3050;
  const Real x3087 = x2944 * x3020 + x2924 * x3026 - x2916 * x3034;
  const Real x3089 = x2895 * x3047 + x3087 + x2875 * x3054;
  const Real x3091 = x1636 * x2944;
  const Real x3092 = x1055 * x2895;
  const Real x3117 = x2952 * x3020 + x2929 * x3026 - x2917 * x3034;
  const Real x3119 = x3117 - x2905 * x3047 + x2880 * x3054;
  const Real x3124 = x3076 - x2867 * x3058 + x2284;
  require_more(w, x3124, 0.0, kLoopFree, 2);
  const Real x3126 = x2867 * x3063 + x3089 - x2184;
  const Real x3127 = x2868 * x3063 + x3119 + 0.003308333;
  const Real x3196 = x1909 * x2924 - (x1938 * x2916 + x1369 * x2867);
  const Real x3198 = x1339 * x2875 + x3196 + x1884 * x2944;
  const Real x3211 = x1909 * x2929 - (x1938 * x2917 + x1369 * x2868);
  const Real x3213 = x1339 * x2880 + x3211 + x1884 * x2952;
  const Real x3225 = x1895 * x2924 - (x1921 * x2916 + x1351 * x2867);
  const Real x3227 = x1324 * x2875 + x3225 + x1870 * x2944;
  const Real x3240 = x1895 * x2929 - (x1921 * x2917 + x1351 * x2868);
  const Real x3242 = x1324 * x2880 + x3240 + x1870 * x2952;
  const Real x3253 = x1926 * x2916 + x1356 * x2867 + x1898 * x2924;
  const Real x3255 = x1327 * x2875 + x3253 + x1873 * x2944;
  const Real x3267 = x1926 * x2917 + x1356 * x2868 + x1898 * x2929;
  const Real x3269 = x1327 * x2880 + x3267 + x1873 * x2952;
  const Real x3300 = x1313 * x2895 + x3198 + x2325;
  const Real x3301 = x1298 * x2895 + x3227 + x2316;
  const Real x3302 = x1301 * x2895 + x3255 - x2321;
  const Real x3305 = x3213 - x1313 * x2905 - x2338;
  const Real x3306 = x3242 - x1298 * x2905 + x531;
  const Real x3307 = x3269 - x1301 * x2905 + x535;
  const Real x3319 = x1604 * x2924 - (x1605 * x2916 + x1024 * x2867);
  const Real x3321 = x1023 * x2875 + x3319 + x1859 * x2944;
  const Real x3334 = x1604 * x2929 - (x1605 * x2917 + x1024 * x2868);
  const Real x3336 = x1023 * x2880 + x3334 + x1859 * x2952;
  const Real x3349 = x2960 * x3014 + x2934 * x3023 - x2918 * x3030;
  const Real x3351 = x2913 * x3040 + x3349 + x2885 * x3050;
  const Real x3362 = x2960 * x3020 + x2934 * x3026 - x2918 * x3034;
  const Real x3364 = x2913 * x3047 + x3362 + x2885 * x3054;
  const Real x3338 = x1287 * x2895 + x3321 + x2303;
  const Real x3368 = x3351 - x2869 * x3058 + x3338;
  const Real x3339 = x3336 - x1287 * x2905 + x2183;
  const Real x3410 = x1909 * x2934 - (x1938 * x2918 + x1369 * x2869);
  const Real x3412 = x1339 * x2885 + x3410 + x1884 * x2960;
  const Real x3424 = x1895 * x2934 - (x1921 * x2918 + x1351 * x2869);
  const Real x3426 = x1324 * x2885 + x3424 + x1870 * x2960;
  const Real x3437 = x1926 * x2918 + x1356 * x2869 + x1898 * x2934;
  const Real x3439 = x1327 * x2885 + x3437 + x1873 * x2960;
  // joint 2 "ankle_pitch": inertia and bias force of what is beyond, its own motion left open
  const Real x2567 = x2289 - 0.4 * x2558 + x2178;
  // link 2 "shank": accelerations and constraint forces of loops below it are eliminated
  const Real x3460 = 1 / x3124;
  const Real x3461 = x3126 * x3460;
  const Real x3462 = x3091 * x3460;
  const Real x3463 = x3092 * x3460;
  const Real x3466 = x3127 - x3126 * x3461;
  const Real x3469 = x1636 * x2952 - x3091 * x3461;
  const Real x3472 = x1055 * x2905 + x3092 * x3461;
  const Real x3474 = 1 / x3466;
  const Real x3475 = x3469 * x3474;
  const Real x3476 = x3472 * x3474;
  const Real x3483 = 2.7e-06 - x3091 * x3462 - x3469 * x3475;
  require_more(w, x3483, 4.796163466380676e-21, kLoopFree, 5);
  const Real x3488 = x3472 * x3475 - x3092 * x3462;
  const Real x3489 = 1 / x3483;
  const Real x3490 = x3488 * x3489;
  const Real x3498 = 2.7e-06 - x3092 * x3463 - x3472 * x3476;
  const Real x3499 = x3498 - x3488 * x3490;
  require_more(w, x3499, 4.796163466380676e-21, kLoopFree, 7);
  const Real x3500 = 1 / x3499;
  const Real x3502 = x3127 * 1.7763568394002505e-15;
  require_more(w, x3466, x3502, kLoopFree, 3);
  const Real x3512 = x3305 - x3300 * x3461;
  const Real x3515 = x3306 - x3301 * x3461;
  const Real x3518 = x3307 - x3302 * x3461;
  const Real x3524 = x2869 * x3063 + x3364 + x3339 - x3368 * x3461;
  const Real x3542 = x1636 - x3300 * x3462 - x3475 * x3512;
  const Real x3547 = x3301 * x3462 + x3475 * x3515;
  const Real x3553 = x3302 * x3462 + x3475 * x3518;
  const Real x3565 = x1606 + x1636 * x2960 - x3368 * x3462;
  const Real x3566 = x3565 - x3475 * x3524;
  const Real x3592 = x1055 - x3300 * x3463 + x3476 * x3512;
  const Real x3624 = x1025 + x1055 * x2913 - x3368 * x3463;
  const Real x3653 = x3500 * (x3592 - x3490 * x3542);
  const Real x3601 = x3476 * x3515 - x3301 * x3463 + x3490 * x3547;
  const Real x3654 = x3500 * x3601;
  const Real x3609 = x3476 * x3518 - x3302 * x3463 + x3490 * x3553;
  const Real x3655 = x3500 * x3609;
  const Real x3657 = x3500 * (x3476 * x3524 + x3624 - x3490 * x3566);
  const Real x3666 = x3489 * x3542 - x3490 * x3653;
  const Real x3669 = x3489 * x3547 + x3490 * x3654;
  const Real x3673 = x3489 * x3553 + x3490 * x3655;
  const Real x3681 = x3489 * x3566 - x3490 * x3657;
  const Real x3699 = x3474 * x3512 + x3476 * x3653 - x3475 * x3666;
  const Real x3705 = x3474 * x3515 + x3476 * x3654 + x3475 * x3669;
  const Real x3711 = x3474 * x3518 + x3476 * x3655 + x3475 * x3673;
  const Real x3723 = x3474 * x3524 + x3476 * x3657 - x3475 * x3681;
  const Real x3749 = x3300 * x3460 - x3463 * x3653 - x3462 * x3666;
  const Real x3750 = x3749 - x3461 * x3699;
  const Real x3758 = x3301 * x3460 - x3463 * x3654 + x3462 * x3669;
  const Real x3759 = x3758 - x3461 * x3705;
  const Real x3767 = x3302 * x3460 - x3463 * x3655 + x3462 * x3673;
  const Real x3768 = x3767 - x3461 * x3711;
  const Real x3785 = x3368 * x3460 - x3463 * x3657 - x3462 * x3681;
  const Real x3786 = x3785 - x3461 * x3723;
  const Real x3911 = x1636 * x3666 + x1055 * x3653 + x3305 * x3699;
  const Real x3913 = x2539 - (x3300 * x3750 + x3911);
  require_more(w, x3913, 0.0, kFactorization, 1);
  const Real x3920 = x1055 * x3654 - x1636 * x3669 + x3305 * x3705;
  const Real x3922 = x2540 - (x3300 * x3759 + x3920);
  const Real x3929 = x1055 * x3655 - x1636 * x3673 + x3305 * x3711;
  const Real x3931 = x2541 - (x3300 * x3768 + x3929);
  const Real x3984 = x1636 * x3681 + x1055 * x3657 + x3305 * x3723;
  const Real x3456 = x1313 * x2913 + x3412 + x2567;
  const Real x3457 = x2552 - x2553 + x2179 + (x1298 * x2913 + x3426);
  const Real x3458 = x2180 + x2558 + (x1301 * x2913 + x3439);
  // joint 1 "knee": articulated-body inertia and bias force through it
  const Real x4002 = 1 / x3913;
  const Real x4004 = x4002 * (tau[1] - (x3456 - (x3300 * x3786 + x3984)));
  const Real x4007 = x3922 * x4002;
  const Real x4008 = x3931 * x4002;
  // link 2 "shank": accelerations and constraint forces of loops below it are eliminated
  const Real x3944 = x2542 - (x3301 * x3759 + x3306 * x3705);
  // joint 1 "knee": articulated-body inertia and bias force through it
  const Real x4039 = x3944 - x3922 * x4007;
  // link 2 "shank": accelerations and constraint forces of loops below it are eliminated
  const Real x3948 = x2146 - (x3301 * x3768 + x3306 * x3711);
  const Real x3956 = x2543 - (x3302 * x3768 + x3307 * x3711);
  const Real x3998 = x3457 - (x3301 * x3786 + x3306 * x3723);
  const Real x3999 = x3458 - (x3302 * x3786 + x3307 * x3723);
  // joint 1 "knee": articulated-body inertia and bias force through it
  const Real x4106 = cosine[1] * (x4039 - (x3956 - x3931 * x4008));
  const Real x4109 = x4106 - (x3948 - x3922 * x4008) * (sine[1] * 2.0);
  const Real x4155 = sine[1] * (x3998 + x3922 * x4004);
  const Real x4161 = 0.4 * (x4155 + cosine[1] * (x3999 + x3931 * x4004));
  const Real x4167 = 0.32735000000000003 + 0.4 * (0.4 * (x4039 - cosine[1] * x4109));
  require_more(w, x4167, 0.0, kFactorization, 0);
  // joint 0 "hip": articulated-body inertia and bias force through it
  const Real x4178 = 1 / x4167 * (tau[0] - (tau[1] - x4161 + x334));
  w.result[0] = x4178;
  // joint 1 "knee": its acceleration, and that of the link beyond
  const Real x4188 = 0.4 * x4178;
  const Real x4190 = sine[1] * x4188;
  const Real x4192 = cosine[1] * x4188;
  const Real x4199 = x4004 + x4007 * x4190 + x4008 * x4192;
  const Real x4200 = x4199 - x4178;
  w.result[1] = x4200;
  // link 2 "shank": accelerations and constraint forces of loops below it
  const Real x4208 = x3759 * x4190 + x3768 * x4192 - x3750 * x4199;
  const Real x4235 = x4208 - x3786;
  w.result[2] = x4235;
  const Real x4216 = x3705 * x4190 + x3711 * x4192 - x3699 * x4199;
  const Real x4236 = x4216 - x3723;
  w.result[3] = x4236;
  const Real x4225 = x3669 * x4190 + x3673 * x4192 + x3666 * x4199;
  const Real x4238 = -(x3681 + x4225);
  w.result[7] = x4238;
  const Real x4234 = x3654 * x4190 + x3655 * x4192 - x3653 * x4199;
  const Real x4239 = x4234 - x3657;
  w.result[11] = x4239;
  const Real x4265 = x2944 * x4235 + x2952 * x4236 + x2960;
  w.result[4] = x4265;
  const Real x4266 = x2924 * x4235 + x2929 * x4236 + x2934;
  w.result[5] = x4266;
  const Real x4268 = -(x2916 * x4235 + x2917 * x4236 + x2918);
  w.result[6] = x4268;
  const Real x4269 = x2895 * x4235 - x2905 * x4236 + x2913;
  w.result[8] = x4269;
  const Real x4270 = x2875 * x4235 + x2880 * x4236 + x2885;
  w.result[9] = x4270;
  const Real x4272 = -(x2867 * x4235 + x2868 * x4236 + x2869);
  w.result[10] = x4272;
}

// =================================================================================================
// Process 0 in a singular pose: 1407 products, 1015 sums, 20 quotients
// =================================================================================================

ADAGEN_NOINLINE void part_1_0(Workspace& w) {
  ADAGEN_INPUTS
  // joint 1 "knee": placement, velocity and reference acceleration of its link
  const Real x19 = v[0] + v[1];
  const Real x36 = x19 * x19;
  // joint 2 "ankle_pitch": placement, velocity and reference acceleration of its link
  const Real x43 = x19 + v[2];
  // joint 3 "ankle_roll": placement, velocity and reference acceleration of its link
  const Real x80 = v[3] * v[3];
  // joint 4 "left_motor": placement, velocity and reference acceleration of its link
  const Real x99 = x19 + v[4];
  const Real x114 = x99 * x99;
  // joint 5 "left_ball": placement, velocity and reference acceleration of its link
  const Real x128 = q[5] * q[5] + q[6] * q[6] + q[7] * q[7];
  const Real x129 = q[8] * q[8] + x128;
  require_length(w, x129, 5);
  const Real x131 = 2.0 * (1 / x129);
  const Real x133 = q[6] * x131;
  const Real x134 = q[7] * x131;
  const Real x132 = q[5] * x131;
  const Real x135 = q[6] * x133;
  const Real x136 = q[7] * x134;
  const Real x142 = q[7] * x132;
  const Real x143 = q[8] * x133;
  const Real x139 = q[6] * x132;
  const Real x140 = q[8] * x134;
  const Real x146 = q[5] * x132;
  const Real x149 = q[7] * x133;
  const Real x150 = q[8] * x132;
  const Real x152 = x142 - x143;
  w.x[0] = x152;
  const Real x144 = x142 + x143;
  w.x[1] = x144;
  const Real x145 = x139 + x140;
  w.x[2] = x145;
  const Real x141 = x139 - x140;
  w.x[3] = x141;
  const Real x153 = x149 + x150;
  w.x[4] = x153;
  const Real x151 = x149 - x150;
  w.x[5] = x151;
  const Real x138 = 1.0 - (x135 + x136);
  w.x[6] = x138;
  const Real x148 = 1.0 - (x136 + x146);
  w.x[7] = x148;
  // joint 6 "right_motor": placement, velocity and reference acceleration of its link
  const Real x216 = x19 + v[8];
  const Real x231 = x216 * x216;
  // joint 7 "right_ball": placement, velocity and reference acceleration of its link
  const Real x245 = q[10] * q[10] + q[11] * q[11] + q[12] * q[12];
  const Real x246 = q[13] * q[13] + x245;
  require_length(w, x246, 7);
  const Real x248 = 2.0 * (1 / x246);
  const Real x250 = q[11] * x248;
  const Real x251 = q[12] * x248;
  const Real x249 = q[10] * x248;
  const Real x252 = q[11] * x250;
  const Real x253 = q[12] * x251;
  const Real x259 = q[12] * x249;
  const Real x260 = q[13] * x250;
  const Real x269 = x259 - x260;
  w.x[8] = x269;
  // link 2 "shank": force that the reference field takes
  const Real x354 = x36 * 0.7000000000000001;
  w.x[9] = x354;
  // link 5 "left_crank": force that the reference field takes
  const Real x442 = x114 * 0.006;
  w.x[10] = x442;
  // link 7 "right_crank": force that the reference field takes
  const Real x488 = x231 * 0.006;
  w.x[11] = x488;
  // what a loop holds its two links by
  const Real x592 = v[4] * 0.06;
  w.x[12] = x592;
  const Real x572 = v[3] * 0.05;
  w.x[13] = x572;
  const Real x643 = v[2] * v[2];
  const Real x645 = v[4] * v[4] + v[5] * v[5] + v[6] * v[6];
  const Real x649 = v[7] * v[7] + x645 + x643 + x80 + 1.0;
  const Real x651 = x649 * 1e-06;
  w.x[14] = x651;
  // what a loop holds its two links by
  const Real x835 = 0.06 * v[8];
  w.x[15] = x835;
  const Real x887 = v[8] * v[8] + v[9] * v[9] + v[10] * v[10];
  const Real x891 = v[11] * v[11] + x887 + x643 + x80 + 1.0;
  w.x[16] = x891;
  // joint 5 "left_ball": placement, velocity and reference acceleration of its link
  const Real x155 = 1.0 - (x135 + x146);
  w.x[17] = x155;
  // joint 7 "right_ball": placement, velocity and reference acceleration of its link
  const Real x255 = 1.0 - (x252 + x253);
  w.x[18] = x255;
  const Real x256 = q[11] * x249;
  const Real x257 = q[13] * x251;
  const Real x262 = x256 + x257;
  w.x[19] = x262;
  // what a loop holds its two links by
  const Real x713 = cosine[4] * x153 - sine[4] * x141;
  const Real x658 = cosine[4] * x152 - sine[4] * x138;
  const Real x661 = sine[4] * x152 + cosine[4] * x138;
  const Real x716 = sine[4] * x153 + cosine[4] * x141;
  const Real x749 = cosine[4] * x155 - sine[4] * x144;
  const Real x664 = cosine[2] * x658 + sine[2] * x661;
  const Real x668 = cosine[2] * x661 - sine[2] * x658;
  const Real x719 = cosine[2] * x713 + sine[2] * x716;
  const Real x723 = cosine[2] * x716 - sine[2] * x713;
  const Real x752 = sine[4] * x155 + cosine[4] * x144;
  const Real x671 = cosine[3] * x145 + sine[3] * x664;
  const Real x675 = cosine[3] * x664 - sine[3] * x145;
  const Real x726 = cosine[3] * x148 + sine[3] * x719;
  const Real x730 = cosine[3] * x719 - sine[3] * x148;
  const Real x755 = cosine[2] * x749 + sine[2] * x752;
  const Real x759 = cosine[2] * x752 - sine[2] * x749;
  const Real x762 = cosine[3] * x151 + sine[3] * x755;
  const Real x766 = cosine[3] * x755 - sine[3] * x151;
  // what a loop holds its two links by
  const Real x898 = cosine[5] * x269 - sine[5] * x255;
  const Real x901 = sine[5] * x269 + cosine[5] * x255;
  // joint 3 "ankle_roll": inertia and bias force of what is beyond, its own motion left open
  const Real x2188 = sine[3] * (0.06 * x671 + 0.05 * x668);
  const Real x2203 = sine[3] * (0.06 * x726 + 0.05 * x723);
  // link 2 "shank": accelerations and constraint forces of loops below it are eliminated
  const Real x2576 = (x148 * 0.15 - x152 * 0.06) * 8.0;
  w.x[20] = x2576;
  const Real x2580 = (x145 * 0.15 + x153 * 0.06) * 8.0;
  const Real x2585 = x155 * 0.06 * 16.0;
  const Real x2575 = 0.05 * x675 * 8.0;
  w.x[21] = x2575;
  const Real x2579 = 0.05 * x730 * 8.0;
  const Real x2609 = x2576 * x2576 + 1.44 + x2575 * x2575;
  // joint 0 "hip": placement, velocity and reference acceleration of its link
  const Real x9 = sine[0] * 9.81;
  w.x[22] = x9;
  // joint 7 "right_ball": placement, velocity and reference acceleration of its link
  const Real x266 = q[12] * x250;
  const Real x267 = q[13] * x249;
  const Real x258 = x256 - x257;
  w.x[23] = x258;
  const Real x263 = q[10] * x249;
  const Real x270 = x266 + x267;
  w.x[24] = x270;
  const Real x261 = x259 + x260;
  w.x[25] = x261;
  const Real x268 = x266 - x267;
  w.x[26] = x268;
  const Real x265 = 1.0 - (x253 + x263);
  w.x[27] = x265;
  const Real x272 = 1.0 - (x252 + x263);
  w.x[28] = x272;
  // what a loop holds its two links by
  const Real x904 = cosine[2] * x898 + sine[2] * x901;
  const Real x908 = cosine[2] * x901 - sine[2] * x898;
  const Real x911 = cosine[3] * x262 + sine[3] * x904;
  const Real x915 = cosine[3] * x904 - sine[3] * x262;
  const Real x949 = cosine[5] * x270 - sine[5] * x258;
  const Real x952 = sine[5] * x270 + cosine[5] * x258;
  const Real x955 = cosine[2] * x949 + sine[2] * x952;
  const Real x959 = cosine[2] * x952 - sine[2] * x949;
  const Real x986 = cosine[5] * x272 - sine[5] * x261;
  const Real x989 = sine[5] * x272 + cosine[5] * x261;
  const Real x962 = cosine[3] * x265 + sine[3] * x955;
  const Real x966 = cosine[3] * x955 - sine[3] * x265;
  const Real x992 = cosine[2] * x986 + sine[2] * x989;
  const Real x996 = cosine[2] * x989 - sine[2] * x986;
  // joint 3 "ankle_roll": inertia and bias force of what is beyond, its own motion left open
  const Real x2218 = sine[3] * (0.06 * x762 + 0.05 * x759);
  const Real x2233 = sine[3] * (0.05 * x908 - 0.06 * x911);
  // link 2 "shank": accelerations and constraint forces of loops below it are eliminated
  const Real x2584 = 0.05 * x766 * 16.0;
  const Real x2574 = (cosine[3] * (0.06 * x675) + x2188) * 8.0;
  const Real x2578 = (cosine[3] * (0.06 * x730) + x2203) * 8.0;
  const Real x2583 = (cosine[3] * (0.06 * x766) + x2218) * 16.0;
  const Real x2588 = 0.05 * x915 * 4.0;
  const Real x2587 = (cosine[3] * (0.06 * x915) - x2233) * 4.0;
  const Real x2612 = sign_of(x2574) * sqrt_of(x2574 * x2574 + x2609);
  w.x[29] = x2612;
  const Real x2590 = (x265 * 0.23 - 0.06 * x269) * 4.0;
  w.x[30] = x2590;
  const Real x2601 = 0.06 * x272 * 16.0;
  const Real x2595 = (x262 * 0.23 + 0.06 * x270) * 4.0;
  const Real x2613 = x2574 + x2612;
  w.x[31] = x2613;
  // joint 1 "knee": placement, velocity and reference acceleration of its link
  const Real x23 = cosine[0] * 9.81 + v[0] * v[0] * 0.4;
  const Real x27 = cosine[1] * x23 - x9 * sine[1];
  w.x[32] = x27;
  const Real x32 = sine[1] * x23 + x9 * cosine[1];
  w.x[33] = x32;
  // joint 2 "ankle_pitch": placement, velocity and reference acceleration of its link
  const Real x46 = x27 + 0.4 * x36;
  const Real x50 = cosine[2] * x46 - x32 * sine[2];
  w.x[34] = x50;
  const Real x55 = sine[2] * x46 + x32 * cosine[2];
  w.x[35] = x55;
  // joint 3 "ankle_roll": placement, velocity and reference acceleration of its link
  const Real x65 = x43 * cosine[3];
  const Real x66 = x43 * sine[3];
  const Real x70 = v[3] * x65;
  const Real x77 = x65 * x65;
  const Real x78 = x66 * x66;
  const Real x83 = x65 * x66;
  const Real x89 = x77 + x78;
  w.x[36] = x89;
  // joint 4 "left_motor": placement, velocity and reference acceleration of its link
  const Real x103 = x27 + x36 * 0.25;
  const Real x112 = sine[4] * x103 + x32 * cosine[4];
  w.x[37] = x112;
  // joint 5 "left_ball": placement, velocity and reference acceleration of its link
  const Real x157 = x99 * x145;
  const Real x159 = x99 * x151;
  const Real x160 = v[5] + x157;
  const Real x162 = v[7] + x159;
  // what a loop holds its two links by
  const Real x691 = 2.0 * x70 * 0.05;
  const Real x692 = x89 * 0.06;
  // what a loop holds its two links by
  const Real x999 = cosine[3] * x268 + sine[3] * x992;
  const Real x1003 = cosine[3] * x992 - sine[3] * x268;
  // joint 3 "ankle_roll": inertia and bias force of what is beyond, its own motion left open
  const Real x2247 = sine[3] * (0.05 * x959 - 0.06 * x962);
  const Real x2261 = sine[3] * (0.05 * x996 - 0.06 * x999);
  // link 2 "shank": accelerations and constraint forces of loops below it are eliminated
  const Real x2593 = 0.05 * x966 * 4.0;
  const Real x2845 = x2590 * x2590 + 0.8464;
  const Real x2615 = x2609 + x2613 * x2613;
  const Real x2592 = (cosine[3] * (0.06 * x966) - x2247) * 4.0;
  const Real x2599 = 0.05 * x1003 * 16.0;
  const Real x2617 = 2.0 * (1 / x2615);
  w.x[38] = x2617;
  const Real x2623 = x2575 * x2579 - x2576 * x2580 + x2578 * x2613;
  const Real x2624 = x2617 * x2623;
  const Real x2639 = x2575 * x2584 - x2576 * x2585 + x2583 * x2613;
  const Real x2640 = x2617 * x2639;
  const Real x2654 = x2617 * (x2587 * x2613 - x2575 * x2588);
  const Real x2668 = x2617 * (x2592 * x2613 - x2575 * x2593);
  const Real x2598 = (cosine[3] * (0.06 * x1003) - x2261) * 16.0;
  const Real x2628 = 1.2 * x2624;
  w.x[39] = x2628;
  const Real x2644 = 1.2 * x2640;
  const Real x2657 = x2576 * x2654;
  const Real x2658 = 1.2 * x2654;
  const Real x2630 = x2579 - x2575 * x2624;
  const Real x2631 = x2580 + x2576 * x2624;
  w.x[40] = x2631;
  const Real x2647 = x2585 + x2576 * x2640;
  const Real x2646 = x2584 - x2575 * x2640;
  const Real x2660 = x2588 + x2575 * x2654;
  const Real x2671 = x2576 * x2668;
  const Real x2672 = 1.2 * x2668;
  const Real x2699 = 1.44 + x2628 * x2628;
  const Real x2695 = x2631 * x2631;
  // joint 3 "ankle_roll": placement, velocity and reference acceleration of its link
  const Real x72 = x50 * sine[3];
  w.x[41] = x72;
  const Real x73 = x50 * cosine[3];
  w.x[42] = x73;
  // joint 4 "left_motor": placement, velocity and reference acceleration of its link
  const Real x107 = cosine[4] * x103 - x32 * sine[4];
  w.x[43] = x107;
  // joint 5 "left_ball": placement, velocity and reference acceleration of its link
  const Real x158 = x99 * x148;
  const Real x170 = v[5] * x159 - v[7] * x157;
  const Real x178 = x114 * 0.06 - x112;
  const Real x206 = x160 * x162;
  const Real x161 = v[6] + x158;
  const Real x208 = x170 + x206;
  const Real x166 = v[7] * x158 - v[6] * x159;
  const Real x201 = x161 * x162;
  const Real x181 = x107 * x152 + x138 * x178;
  const Real x202 = x201 - x166;
  const Real x184 = x107 * x153 + x141 * x178;
  const Real x204 = x160 * x160 + x161 * x161;
  const Real x187 = x107 * x155 + x144 * x178;
  // joint 6 "right_motor": placement, velocity and reference acceleration of its link
  const Real x220 = x27 + x36 * 0.17;
  const Real x229 = sine[5] * x220 + x32 * cosine[5];
  w.x[44] = x229;
  const Real x224 = cosine[5] * x220 - x32 * sine[5];
  w.x[45] = x224;
  // joint 7 "right_ball": placement, velocity and reference acceleration of its link
  const Real x273 = x216 * x262;
  const Real x275 = x216 * x268;
  const Real x276 = v[9] + x273;
  const Real x278 = v[11] + x275;
  const Real x274 = x216 * x265;
  const Real x286 = v[9] * x275 - v[11] * x273;
  const Real x293 = 0.06 * x231 - x229;
  const Real x321 = x276 * x278;
  // link 4 "foot": force that the reference field takes
  const Real x412 = x83 * 0.05;
  w.x[46] = x412;
  // what a loop holds its two links by
  const Real x687 = (x78 + x80) * 0.05;
  const Real x689 = x72 - x687;
  const Real x695 = x691 + x692 - x55;
  const Real x690 = x73 - x412;
  const Real x700 = x671 * x689 + x668 * x695 + x675 * x690;
  // link 2 "shank": accelerations and constraint forces of loops below it are eliminated
  const Real x2674 = x2593 + x2575 * x2668;
  const Real x2682 = x2617 * (x2598 * x2613 - x2575 * x2599);
  const Real x2685 = x2576 * x2682;
  const Real x2686 = 1.2 * x2682;
  const Real x2688 = x2599 + x2575 * x2682;
  const Real x2703 = sign_of(x2630) * sqrt_of(x2630 * x2630 + x2699 + x2695);
  w.x[47] = x2703;
  const Real x2704 = x2630 + x2703;
  w.x[48] = x2704;
  // joint 7 "right_ball": placement, velocity and reference acceleration of its link
  const Real x277 = v[10] + x274;
  const Real x323 = x286 + x321;
  const Real x282 = v[11] * x274 - v[10] * x275;
  const Real x296 = x224 * x269 + x255 * x293;
  const Real x316 = x277 * x278;
  const Real x317 = x316 - x282;
  const Real x299 = x224 * x270 + x258 * x293;
  const Real x319 = x276 * x276 + x277 * x277;
  // what a loop holds its two links by
  const Real x736 = x689 * x726 + x695 * x723 + x690 * x730;
  const Real x772 = x689 * x762 + x695 * x759 + x690 * x766;
  // what a loop holds its two links by
  const Real x926 = x72 + x687;
  const Real x930 = x692 - x691 - x55;
  const Real x927 = x73 + x412;
  const Real x935 = x911 * x926 + x908 * x930 + x915 * x927;
  // link 2 "shank": accelerations and constraint forces of loops below it are eliminated
  const Real x2707 = x2695 + x2699 + x2704 * x2704;
  const Real x2962 = (x700 - (x181 - x208 * 0.15)) * 8.0 * (1 / x2612);
  w.x[49] = x2962;
  const Real x2949 = (x736 - (x184 - x202 * 0.15)) * 8.0;
  const Real x2709 = 2.0 * (1 / x2707);
  w.x[50] = x2709;
  const Real x2970 = 1 / x2703 * (x2949 + (x2578 - x2613 * x2624) * x2962);
  w.x[51] = x2970;
  const Real x2716 = x2631 * x2647 + x2628 * x2644 + x2646 * x2704;
  const Real x2717 = x2709 * x2716;
  const Real x2735 = x2631 * x2657 + x2628 * x2658 - x2660 * x2704;
  const Real x2736 = x2709 * x2735;
  const Real x2755 = x2631 * x2671 + x2628 * x2672 - x2674 * x2704;
  const Real x2756 = x2709 * x2755;
  const Real x2775 = x2631 * x2685 + x2628 * x2686 - x2688 * x2704;
  const Real x2776 = x2709 * x2775;
  const Real x2950 = (x772 - (x187 + x204 * 0.15)) * 16.0;
  const Real x2721 = 1.2 * x2717;
  w.x[52] = x2721;
  const Real x2740 = 1.2 * x2736;
  const Real x2760 = 1.2 * x2756;
  const Real x2726 = x2631 * x2717 - x2647;
  const Real x2791 = x2721 * x2721;
  const Real x2727 = x2628 * x2717 - x2644;
  w.x[53] = x2727;
  const Real x2747 = x2628 * x2736 - x2658;
  const Real x2746 = x2631 * x2736 - x2657;
  const Real x2767 = x2628 * x2756 - x2672;
  const Real x2766 = x2631 * x2756 - x2671;
  const Real x2792 = x2727 * x2727;
  const Real x2780 = 1.2 * x2776;
  const Real x2787 = x2628 * x2776 - x2686;
  const Real x2786 = x2631 * x2776 - x2685;
  // joint 7 "right_ball": placement, velocity and reference acceleration of its link
  const Real x302 = x224 * x272 + x261 * x293;
  // what a loop holds its two links by
  const Real x540 = x155 * 0.15;
  w.x[54] = x540;
  // what a loop holds its two links by
  const Real x972 = x926 * x962 + x930 * x959 + x927 * x966;
  const Real x1009 = x926 * x999 + x930 * x996 + x927 * x1003;
  // joint 7 "right_ball": inertia and bias force of what is beyond, its own motion left open
  const Real x1160 = x269 * 0.15;
  const Real x1161 = x270 * 0.15;
  const Real x1162 = x272 * 0.15;
  const Real x1028 = x262 * 0.00264635;
  const Real x1031 = x265 * 0.01725;
  const Real x1045 = x262 * 0.01725;
  const Real x1055 = x268 * 2.7e-06;
  w.x[55] = x1055;
  const Real x1040 = x265 * 0.00264635;
  const Real x1029 = x270 * 0.01725;
  const Real x1041 = x269 * 0.01725;
  const Real x1173 = x269 * x1160 + x270 * x1161 + x272 * x1162;
  w.x[56] = x1173;
  const Real x1121 = x270 * x1045 - x269 * x1031;
  const Real x1037 = x1028 + 0.06 * x1029;
  w.x[57] = x1037;
  const Real x1052 = x1040 - 0.06 * x1041;
  w.x[58] = x1052;
  const Real x1204 = x1121 + 0.06 * x1173;
  const Real x1159 = x262 * x1028 + x268 * x1055 + x265 * x1040;
  // joint 5 "left_ball": inertia and bias force of what is beyond, its own motion left open
  const Real x1637 = x153 * 0.15;
  const Real x1649 = x152 * 0.15;
  const Real x1609 = x145 * 0.00112635;
  const Real x1612 = x148 * 0.01125;
  const Real x1626 = x145 * 0.01125;
  const Real x1636 = x151 * 2.7e-06;
  w.x[59] = x1636;
  const Real x1621 = x148 * 0.00112635;
  // link 2 "shank": accelerations and constraint forces of loops below it are eliminated
  const Real x2951 = (x935 - (x296 - x323 * 0.23)) * 4.0;
  const Real x2978 = x2950 + (x2583 - x2613 * x2640) * x2962;
  const Real x2992 = x2951 + (x2587 - x2613 * x2654) * x2962;
  const Real x2952 = (x972 - (x299 - x317 * 0.23)) * 4.0;
  const Real x3008 = x2952 + (x2592 - x2613 * x2668) * x2962;
  const Real x2953 = (x1009 - (x302 + x319 * 0.23)) * 16.0;
  const Real x2796 = sign_of(x2726) * sqrt_of(x2726 * x2726 + x2791 + x2792);
  w.x[60] = x2796;
  const Real x3027 = x2953 + (x2598 - x2613 * x2682) * x2962;
  const Real x2797 = x2726 + x2796;
  w.x[61] = x2797;
  const Real x2800 = x2791 + x2792 + x2797 * x2797;
  // what a loop holds its two links by
  const Real x529 = cosine[3] * 0.05;
  w.x[62] = x529;
  // joint 7 "right_ball": inertia and bias force of what is beyond, its own motion left open
  const Real x1242 = x1159 + 0.06 * x1121 + 0.06 * x1204 + 0.0002466667;
  w.x[63] = x1242;
  const Real x1030 = x258 * 0.01725;
  const Real x1243 = 0.006 + x1204;
  const Real x1043 = x255 * 0.01725;
  const Real x1178 = x255 * x1160 + x258 * x1161 + x261 * x1162;
  w.x[64] = x1178;
  const Real x1210 = x258 * x1045 - x255 * x1031 + 0.06 * x1178;
  // joint 6 "right_motor": inertia and bias force of what is beyond, its own motion left open
  const Real x1327 = sine[5] * x1029 + cosine[5] * x1030;
  w.x[65] = x1327;
  const Real x1301 = sine[5] * x1243 + cosine[5] * x1210;
  w.x[66] = x1301;
  const Real x1339 = x1037 - 0.17 * x1327;
  w.x[67] = x1339;
  // joint 5 "left_ball": inertia and bias force of what is beyond, its own motion left open
  const Real x1745 = x152 * x1649 + x153 * x1637 + x155 * x540;
  w.x[68] = x1745;
  const Real x1610 = x153 * 0.01125;
  const Real x1622 = x152 * 0.01125;
  const Real x1702 = x153 * x1626 - x152 * x1612;
  const Real x1776 = x1702 + 0.06 * x1745;
  const Real x1618 = x1609 + 0.06 * x1610;
  w.x[69] = x1618;
  const Real x1633 = x1621 - 0.06 * x1622;
  w.x[70] = x1633;
  const Real x1740 = x145 * x1609 + x151 * x1636 + x148 * x1621;
  const Real x1611 = x141 * 0.01125;
  const Real x1814 = x1740 + 0.06 * x1702 + 0.06 * x1776 + 0.0002466667;
  w.x[71] = x1814;
  // joint 3 "ankle_roll": inertia and bias force of what is beyond, its own motion left open
  const Real x2184 = sine[3] * 0.002;
  w.x[72] = x2184;
  const Real x2284 = 0.00630833 + cosine[3] * (cosine[3] * 0.0019583400000000003) + 2.4e-05;
  w.x[73] = x2284;
  // link 2 "shank": accelerations and constraint forces of loops below it are eliminated
  const Real x2982 = 1 / x2796 * ((x2646 - x2704 * x2717) * x2970 + x2978);
  w.x[74] = x2982;
  const Real x3277 = x2797 * x2982;
  w.x[75] = x3277;
  const Real x2802 = 2.0 * (1 / x2800);
  w.x[76] = x2802;
  const Real x3360 = x2704 * x2970;
  w.x[77] = x3360;
  const Real x2807 = x2721 * x2740 + x2727 * x2747 + x2746 * x2797;
  const Real x2808 = x2802 * x2807;
  const Real x2819 = x2721 * x2760 + x2727 * x2767 + x2766 * x2797;
  const Real x2820 = x2802 * x2819;
  const Real x2831 = x2721 * x2780 + x2727 * x2787 + x2786 * x2797;
  const Real x2832 = x2802 * x2831;
  const Real x2813 = x2740 - x2721 * x2808;
  const Real x2814 = x2747 - x2727 * x2808;
  w.x[78] = x2814;
  const Real x2826 = x2767 - x2727 * x2820;
  const Real x2825 = x2760 - x2721 * x2820;
  const Real x2838 = x2787 - x2727 * x2832;
  const Real x2837 = x2780 - x2721 * x2832;
  const Real x2842 = x2814 * x2814;
  // joint 3 "ankle_roll": placement, velocity and reference acceleration of its link
  const Real x68 = v[3] * x66;
  w.x[79] = x68;
  const Real x85 = x77 + x80;
  w.x[80] = x85;
  // link 8 "right_rod": force that the reference field takes
  const Real x519 = x296 * 0.15 - x323 * 0.01725;
  w.x[81] = x519;
  const Real x523 = x299 * 0.15 - x317 * 0.01725;
  w.x[82] = x523;
  const Real x508 = (v[10] * x273 - v[9] * x274) * 2.7e-06;
  w.x[83] = x508;
  const Real x512 = x282 * 0.00264635 - x316 * 0.00264365 + x299 * 0.01725;
  const Real x527 = x302 * 0.15 + x319 * 0.01725;
  w.x[84] = x527;
  const Real x515 = x286 * 0.00264635 + x321 * 0.00264365 - x296 * 0.01725;
  // what a loop holds its two links by
  const Real x530 = sine[3] * 0.05;
  const Real x535 = sine[2] * x530;
  w.x[85] = x535;
  // joint 7 "right_ball": inertia and bias force of what is beyond, its own motion left open
  const Real x1266 = x269 * x519 + x270 * x523 + x272 * x527;
  w.x[86] = x1266;
  // joint 6 "right_motor": inertia and bias force of what is beyond, its own motion left open
  const Real x1356 = sine[5] * x1041 + cosine[5] * x1043;
  w.x[87] = x1356;
  const Real x1313 = x1242 - 0.17 * x1301;
  w.x[88] = x1313;
  const Real x1369 = x1052 + 0.17 * x1356;
  w.x[89] = x1369;
  const Real x1298 = cosine[5] * x1243 - sine[5] * x1210;
  w.x[90] = x1298;
  const Real x1324 = cosine[5] * x1029 - sine[5] * x1030;
  w.x[91] = x1324;
  // joint 5 "left_ball": inertia and bias force of what is beyond, its own motion left open
  const Real x1750 = x138 * x1649 + x141 * x1637 + x144 * x540;
  w.x[92] = x1750;
  const Real x1782 = x141 * x1626 - x138 * x1612 + 0.06 * x1750;
  const Real x1815 = 0.006 + x1776;
  const Real x1624 = x138 * 0.01125;
  // joint 4 "left_motor": inertia and bias force of what is beyond, its own motion left open
  const Real x1898 = sine[4] * x1610 + cosine[4] * x1611;
  w.x[93] = x1898;
  const Real x1909 = x1618 - 0.25 * x1898;
  w.x[94] = x1909;
  const Real x1873 = sine[4] * x1815 + cosine[4] * x1782;
  w.x[95] = x1873;
  const Real x1926 = sine[4] * x1622 + cosine[4] * x1624;
  w.x[96] = x1926;
  // joint 2 "ankle_pitch": inertia and bias force of what is beyond, its own motion left open
  const Real x2321 = sine[2] * 0.04 + cosine[2] * x529;
  w.x[97] = x2321;
  const Real x2325 = x2284 + 0.4 * x2321;
  w.x[98] = x2325;
  const Real x2338 = x2184 + 0.4 * x535;
  w.x[99] = x2338;
  // link 2 "shank": accelerations and constraint forces of loops below it are eliminated
  const Real x2994 = (x2660 + x2704 * x2736) * x2970 - x2992;
  const Real x3010 = (x2674 + x2704 * x2756) * x2970 - x3008;
  const Real x3011 = x3010 - (x2766 - x2797 * x2820) * x2982;
  w.x[100] = x3011;
  const Real x3029 = (x2688 + x2704 * x2776) * x2970 - x3027;
  const Real x3030 = x3029 - (x2786 - x2797 * x2832) * x2982;
  w.x[101] = x3030;
  const Real x2849 = sign_of(x2813) * sqrt_of(x2813 * x2813 + x2845 + x2842);
  w.x[102] = x2849;
  const Real x2850 = x2813 + x2849;
  w.x[103] = x2850;
  const Real x2853 = x2842 + x2845 + x2850 * x2850;
  // link 4 "foot": force that the reference field takes
  const Real x385 = x68 * 0.002999997 - x68 * 0.00826667;
  const Real x405 = 0.002 * (x89 - x85) + x385 + x55 * 0.05;
  const Real x395 = x70 * 0.004958337 - x70 * 0.00630833 + x83 * 0.002;
  const Real x398 = x83 * 0.0019583400000000003;
  w.x[104] = x398;
  const Real x409 = x72 * 0.05;
  w.x[105] = x409;
  // link 6 "left_rod": force that the reference field takes
  const Real x463 = (v[6] * x157 - v[5] * x158) * 2.7e-06;
  const Real x474 = x181 * 0.15 - x208 * 0.01125;
  w.x[106] = x474;
  const Real x478 = x184 * 0.15 - x202 * 0.01125;
  w.x[107] = x478;
  const Real x467 = x166 * 0.00112635 - x201 * 0.00112365 + x184 * 0.01125;
  w.x[108] = x467;
  const Real x482 = x187 * 0.15 + x204 * 0.01125;
  w.x[109] = x482;
  const Real x470 = x170 * 0.00112635 + x206 * 0.00112365 - x181 * 0.01125;
  w.x[110] = x470;
  // what a loop holds its two links by
  const Real x531 = cosine[2] * x530;
  w.x[111] = x531;
  const Real x542 = x144 * 0.15;
  w.x[112] = x542;
  // joint 7 "right_ball": inertia and bias force of what is beyond, its own motion left open
  const Real x1261 = x262 * x512 + x268 * x508 + x265 * x515;
  const Real x1023 = x512 - tau[9];
  w.x[113] = x1023;
  const Real x1283 = x1261 + 0.06 * x1266 + x224 * 0.006;
  w.x[114] = x1283;
  const Real x1024 = x515 - tau[10];
  w.x[115] = x1024;
  const Real x1184 = x255 * (x255 * 0.15);
  w.x[116] = x1184;
  const Real x1187 = x258 * (x258 * 0.15) + x261 * (x261 * 0.15);
  w.x[117] = x1187;
  // joint 6 "right_motor": inertia and bias force of what is beyond, its own motion left open
  const Real x1351 = sine[5] * x1043 - cosine[5] * x1041;
  w.x[118] = x1351;
  const Real x1287 = x1283 - tau[8];
  w.x[119] = x1287;
  // joint 5 "left_ball": inertia and bias force of what is beyond, its own motion left open
  const Real x1606 = x463 - tau[7];
  w.x[120] = x1606;
  const Real x1638 = x141 * 0.15;
  w.x[121] = x1638;
  const Real x1830 = x148 * x470;
  w.x[122] = x1830;
  const Real x1832 = x145 * x467 + x151 * x463;
  w.x[123] = x1832;
  const Real x1838 = x152 * x474 + x153 * x478 + x155 * x482;
  w.x[124] = x1838;
  // joint 4 "left_motor": inertia and bias force of what is beyond, its own motion left open
  const Real x1884 = x1814 - 0.25 * x1873;
  w.x[125] = x1884;
  const Real x1895 = cosine[4] * x1610 - sine[4] * x1611;
  w.x[126] = x1895;
  const Real x1938 = x1633 + 0.25 * x1926;
  w.x[127] = x1938;
  const Real x1870 = cosine[4] * x1815 - sine[4] * x1782;
  w.x[128] = x1870;
  const Real x1917 = cosine[4] * x1622;
  w.x[129] = x1917;
  const Real x1919 = sine[4] * x1624;
  w.x[130] = x1919;
  // joint 3 "ankle_roll": inertia and bias force of what is beyond, its own motion left open
  const Real x2286 = cosine[3] * (x405 - x73 * 0.04);
  w.x[131] = x2286;
  const Real x2287 = sine[3] * (x395 + x72 * 0.04);
  w.x[132] = x2287;
  // joint 2 "ankle_pitch": inertia and bias force of what is beyond, its own motion left open
  const Real x2316 = sine[2] * x529 - cosine[2] * 0.04;
  w.x[133] = x2316;
  // link 2 "shank": accelerations and constraint forces of loops below it are eliminated
  const Real x3424 = x2613 * x2962;
  w.x[134] = x3424;
  const Real x2996 = 1 / x2849 * (x2994 - (x2746 - x2797 * x2808) * x2982);
  w.x[135] = x2996;
  const Real x3211 = x2850 * x2996;
  w.x[136] = x3211;
  const Real x2855 = 2.0 * (1 / x2853);
  w.x[137] = x2855;
  const Real x2861 = x2814 * x2826 - x2590 * x2595 + x2825 * x2850;
  const Real x2862 = x2855 * x2861;
  const Real x2877 = x2814 * x2838 - x2590 * x2601 + x2837 * x2850;
  const Real x2878 = x2855 * x2877;
  const Real x2866 = 0.92 * x2862;
  w.x[138] = x2866;
  const Real x2882 = 0.92 * x2878;
  w.x[139] = x2882;
  const Real x2868 = x2826 - x2814 * x2862;
  w.x[140] = x2868;
  const Real x2869 = x2595 + x2590 * x2862;
  w.x[141] = x2869;
  const Real x2885 = x2601 + x2590 * x2878;
  w.x[142] = x2885;
  const Real x2884 = x2838 - x2814 * x2878;
  w.x[143] = x2884;
  const Real x2909 = x2866 * x2882;
  w.x[144] = x2909;
  const Real x2890 = x2868 * x2868;
  w.x[145] = x2890;
  const Real x2895 = 0.8464 + x2866 * x2866;
  w.x[146] = x2895;
  const Real x2891 = x2869 * x2869;
  w.x[147] = x2891;
  const Real x2889 = sign_of(x2868);
  w.x[148] = x2889;
  const Real x2907 = x2869 * x2885;
  w.x[149] = x2907;
  const Real x3006 = (x2825 - x2850 * x2862) * x2996;
  w.x[150] = x3006;
  const Real x3023 = (x2837 - x2850 * x2878) * x2996;
  w.x[151] = x3023;
}

ADAGEN_NOINLINE void part_1_1(Workspace& w) {
  ADAGEN_INPUTS
  const Real x9 = w.x[22];
  const Real x27 = w.x[32];
  const Real x32 = w.x[33];
  const Real x50 = w.x[34];
  const Real x55 = w.x[35];
  const Real x68 = w.x[79];
  const Real x72 = w.x[41];
  const Real x73 = w.x[42];
  const Real x85 = w.x[80];
  const Real x89 = w.x[36];
  const Real x107 = w.x[43];
  const Real x112 = w.x[37];
  const Real x138 = w.x[6];
  const Real x141 = w.x[3];
  const Real x144 = w.x[1];
  const Real x145 = w.x[2];
  const Real x148 = w.x[7];
  const Real x151 = w.x[5];
  const Real x152 = w.x[0];
  const Real x153 = w.x[4];
  const Real x155 = w.x[17];
  const Real x224 = w.x[45];
  const Real x229 = w.x[44];
  const Real x255 = w.x[18];
  const Real x258 = w.x[23];
  const Real x261 = w.x[25];
  const Real x262 = w.x[19];
  const Real x265 = w.x[27];
  const Real x268 = w.x[26];
  const Real x269 = w.x[8];
  const Real x270 = w.x[24];
  const Real x272 = w.x[28];
  const Real x354 = w.x[9];
  const Real x398 = w.x[104];
  const Real x409 = w.x[105];
  const Real x412 = w.x[46];
  const Real x442 = w.x[10];
  const Real x467 = w.x[108];
  const Real x470 = w.x[110];
  const Real x474 = w.x[106];
  const Real x478 = w.x[107];
  const Real x482 = w.x[109];
  const Real x488 = w.x[11];
  const Real x508 = w.x[83];
  const Real x519 = w.x[81];
  const Real x523 = w.x[82];
  const Real x527 = w.x[84];
  const Real x529 = w.x[62];
  const Real x531 = w.x[111];
  const Real x535 = w.x[85];
  const Real x540 = w.x[54];
  const Real x542 = w.x[112];
  const Real x572 = w.x[13];
  const Real x592 = w.x[12];
  const Real x651 = w.x[14];
  const Real x835 = w.x[15];
  const Real x891 = w.x[16];
  const Real x1023 = w.x[113];
  const Real x1024 = w.x[115];
  const Real x1037 = w.x[57];
  const Real x1052 = w.x[58];
  const Real x1055 = w.x[55];
  const Real x1173 = w.x[56];
  const Real x1178 = w.x[64];
  const Real x1184 = w.x[116];
  const Real x1187 = w.x[117];
  const Real x1242 = w.x[63];
  const Real x1266 = w.x[86];
  const Real x1283 = w.x[114];
  const Real x1287 = w.x[119];
  const Real x1298 = w.x[90];
  const Real x1301 = w.x[66];
  const Real x1313 = w.x[88];
  const Real x1324 = w.x[91];
  const Real x1327 = w.x[65];
  const Real x1339 = w.x[67];
  const Real x1351 = w.x[118];
  const Real x1356 = w.x[87];
  const Real x1369 = w.x[89];
  const Real x1606 = w.x[120];
  const Real x1618 = w.x[69];
  const Real x1633 = w.x[70];
  const Real x1636 = w.x[59];
  const Real x1638 = w.x[121];
  const Real x1745 = w.x[68];
  const Real x1750 = w.x[92];
  const Real x1814 = w.x[71];
  const Real x1830 = w.x[122];
  const Real x1832 = w.x[123];
  const Real x1838 = w.x[124];
  const Real x1870 = w.x[128];
  const Real x1873 = w.x[95];
  const Real x1884 = w.x[125];
  const Real x1895 = w.x[126];
  const Real x1898 = w.x[93];
  const Real x1909 = w.x[94];
  const Real x1917 = w.x[129];
  const Real x1919 = w.x[130];
  const Real x1938 = w.x[127];
  const Real x2184 = w.x[72];
  const Real x2284 = w.x[73];
  const Real x2286 = w.x[131];
  const Real x2287 = w.x[132];
  const Real x2316 = w.x[133];
  const Real x2321 = w.x[97];
  const Real x2325 = w.x[98];
  const Real x2338 = w.x[99];
  const Real x2575 = w.x[21];
  const Real x2576 = w.x[20];
  const Real x2590 = w.x[30];
  const Real x2612 = w.x[29];
  const Real x2613 = w.x[31];
  const Real x2617 = w.x[38];
  const Real x2628 = w.x[39];
  const Real x2631 = w.x[40];
  const Real x2703 = w.x[47];
  const Real x2704 = w.x[48];
  const Real x2709 = w.x[50];
  const Real x2721 = w.x[52];
  const Real x2727 = w.x[53];
  const Real x2796 = w.x[60];
  const Real x2797 = w.x[61];
  const Real x2802 = w.x[76];
  const Real x2814 = w.x[78];
  const Real x2849 = w.x[102];
  const Real x2850 = w.x[103];
  const Real x2855 = w.x[137];
  const Real x2866 = w.x[138];
  const Real x2868 = w.x[140];
  const Real x2869 = w.x[141];
  const Real x2882 = w.x[139];
  const Real x2884 = w.x[143];
  const Real x2885 = w.x[142];
  const Real x2889 = w.x[148];
  const Real x2890 = w.x[145];
  const Real x2891 = w.x[147];
  const Real x2895 = w.x[146];
  const Real x2907 = w.x[149];
  const Real x2909 = w.x[144];
  const Real x2962 = w.x[49];
  const Real x2970 = w.x[51];
  const Real x2982 = w.x[74];
  const Real x2996 = w.x[135];
  const Real x3006 = w.x[150];
  const Real x3011 = w.x[100];
  const Real x3023 = w.x[151];
  const Real x3030 = w.x[101];
  const Real x3211 = w.x[136];
  const Real x3277 = w.x[75];
  const Real x3360 = w.x[77];
  const Real x3424 = w.x[134];
  // joint 7 "right_ball": inertia and bias force of what is beyond, its own motion left open
  const Real x1244 = 0.2 + x1173;
  const Real x1245 = x1184 + x1187 + 0.2;
  const Real x1025 = x508 - tau[11];
  w.x[152] = x1025;
  const Real x1284 = x224 * 0.2 + x1266;
  const Real x1271 = x255 * x519 + x258 * x523 + x261 * x527;
  const Real x1285 = x488 - x229 * 0.2 + x1271;
  // joint 6 "right_motor": inertia and bias force of what is beyond, its own motion left open
  const Real x1489 = cosine[5] * (x1244 - x1245) - x1178 * (2.0 * sine[5]);
  const Real x1493 = cosine[5] * x1489;
  const Real x1495 = x1244 - x1493;
  const Real x1492 = x1178 + sine[5] * x1489;
  const Real x1585 = sine[5] * x1284 + cosine[5] * x1285;
  // joint 5 "left_ball": inertia and bias force of what is beyond, its own motion left open
  const Real x1604 = x467 - tau[5];
  w.x[153] = x1604;
  const Real x1816 = 0.2 + x1745;
  const Real x1605 = x470 - tau[6];
  w.x[154] = x1605;
  const Real x1759 = x141 * x1638 + x144 * x542;
  const Real x1855 = x1830 + x1832 + 0.06 * x1838 + x107 * 0.006;
  const Real x1817 = x138 * (x138 * 0.15) + x1759 + 0.2;
  const Real x1856 = x107 * 0.2 + x1838;
  const Real x1843 = x138 * x474 + x141 * x478 + x144 * x482;
  const Real x1857 = x442 - x112 * 0.2 + x1843;
  // joint 4 "left_motor": inertia and bias force of what is beyond, its own motion left open
  const Real x1921 = x1919 - x1917;
  w.x[155] = x1921;
  const Real x1859 = x1855 - tau[4];
  w.x[156] = x1859;
  const Real x2059 = cosine[4] * (x1816 - x1817) - x1750 * (2.0 * sine[4]);
  const Real x2063 = cosine[4] * x2059;
  const Real x2065 = x1816 - x2063;
  const Real x2062 = x1750 + sine[4] * x2059;
  // joint 3 "ankle_roll": inertia and bias force of what is beyond, its own motion left open
  const Real x2289 = x2286 - x2287;
  const Real x2183 = x398 + x409 - tau[3];
  w.x[157] = x2183;
  const Real x2298 = cosine[3] * (x73 + x85 * 0.05);
  // link 4 "foot": force that the reference field takes
  const Real x423 = 2.0 * x68 * 0.05 - x89 * 0.04 - x55;
  // joint 3 "ankle_roll": inertia and bias force of what is beyond, its own motion left open
  const Real x2301 = x423 - x55 * 0.15;
  const Real x2300 = sine[3] * (x72 + x412) + x2298 + x50 * 0.15;
  // joint 2 "ankle_pitch": inertia and bias force of what is beyond, its own motion left open
  const Real x2303 = x2289 - tau[2];
  w.x[158] = x2303;
  const Real x2514 = -0.46 - x2321;
  // link 2 "shank": accelerations and constraint forces of loops below it are eliminated
  const Real x2899 = x2889 * sqrt_of(x2890 + x2895 + x2891);
  w.x[159] = x2899;
  const Real x2900 = x2868 + x2899;
  // link 1 "thigh": force that the reference field takes
  const Real x334 = x9 * 1.2000000000000002;
  w.x[160] = x334;
  // what a loop holds its two links by
  const Real x568 = v[2] * sine[3];
  const Real x573 = 0.06 * (v[2] * cosine[3]);
  const Real x596 = x155 * x592;
  const Real x608 = x153 * x592 + 0.15 * (v[5] + v[4] * x145);
  // what a loop holds its two links by
  const Real x839 = x272 * x835;
  // joint 6 "right_motor": inertia and bias force of what is beyond, its own motion left open
  const Real x1517 = x1301 - 0.17 * x1495;
  const Real x1582 = cosine[5] * x1284 - sine[5] * x1285;
  // joint 4 "left_motor": inertia and bias force of what is beyond, its own motion left open
  const Real x2164 = sine[4] * x1856 + cosine[4] * x1857;
  const Real x2086 = x1873 - 0.25 * x2065;
  const Real x2146 = x1492 + x2062;
  w.x[161] = x2146;
  // joint 6 "right_motor": inertia and bias force of what is beyond, its own motion left open
  const Real x1598 = x1283 - 0.17 * x1585 + x32 * 0.7000000000000001;
  const Real x1567 = x1313 - 0.17 * x1517 + 0.18885420000000003;
  const Real x1599 = x27 * 3.5 + x354 + x1582;
  // joint 2 "ankle_pitch": inertia and bias force of what is beyond, its own motion left open
  const Real x2558 = sine[2] * x2300 + cosine[2] * x2301;
  const Real x2543 = 3.5 + x1495 + x2065 + 1.15;
  w.x[162] = x2543;
  const Real x2542 = x1245 + x1493 + 3.5 + (x1817 + x2063) + 1.15;
  w.x[163] = x2542;
  // joint 4 "left_motor": inertia and bias force of what is beyond, its own motion left open
  const Real x2142 = x1298 - 0.17 * x1492 + (x1870 - 0.25 * x2062);
  // joint 2 "ankle_pitch": inertia and bias force of what is beyond, its own motion left open
  const Real x2540 = x2142 + x2316;
  w.x[164] = x2540;
  const Real x2541 = -0.7000000000000001 + x1517 + x2086 + x2514;
  w.x[165] = x2541;
  // joint 4 "left_motor": inertia and bias force of what is beyond, its own motion left open
  const Real x2178 = x1855 - 0.25 * x2164 + x1598;
  // joint 2 "ankle_pitch": inertia and bias force of what is beyond, its own motion left open
  const Real x2567 = x2289 - 0.4 * x2558 + x2178;
  w.x[166] = x2567;
  // joint 4 "left_motor": inertia and bias force of what is beyond, its own motion left open
  const Real x2141 = x1884 - 0.25 * x2086 + x1567;
  // joint 2 "ankle_pitch": inertia and bias force of what is beyond, its own motion left open
  const Real x2539 = x2325 - 0.4 * x2514 + x2141;
  w.x[167] = x2539;
  const Real x2569 = x1585 - x32 * 3.5 + x2164 + x2558;
  w.x[168] = x2569;
  // joint 4 "left_motor": inertia and bias force of what is beyond, its own motion left open
  const Real x2179 = cosine[4] * x1856 - sine[4] * x1857 + x1599;
  // joint 2 "ankle_pitch": inertia and bias force of what is beyond, its own motion left open
  const Real x2568 = cosine[2] * x2300 - sine[2] * x2301 + x2179;
  w.x[169] = x2568;
  // link 2 "shank": accelerations and constraint forces of loops below it are eliminated
  const Real x2903 = x2891 + x2895 + x2900 * x2900;
  const Real x3013 = 1 / x2899 * (x3006 + x3011);
  const Real x2905 = 2.0 * (1 / x2903);
  const Real x2913 = x2905 * (x2907 + x2909 + x2884 * x2900);
  const Real x2917 = 0.92 * x2913;
  const Real x2922 = x2869 * x2913 - x2885;
  const Real x2923 = x2866 * x2913 - x2882;
  // joint 1 "knee": articulated-body inertia and bias force through it
  const Real x4916 = sine[1] * 2.0;
  w.x[170] = x4916;
  // what a loop holds its two links by
  const Real x570 = 0.06 * x568;
  const Real x575 = x572 + x573;
  const Real x605 = x152 * x592 - 0.15 * (v[6] + v[4] * x148);
  const Real x582 = sine[3] * x570;
  const Real x546 = -0.06 - x542;
  const Real x576 = 0.05 * x568;
  const Real x584 = x582 + cosine[3] * x575;
  const Real x613 = x153 * x608 + x155 * x596 + x152 * x605;
  const Real x618 = x141 * x608 + x144 * x596 + x138 * x605;
  const Real x532 = sine[2] * 0.06;
  const Real x536 = cosine[2] * 0.06;
  const Real x578 = cosine[3] * x570;
  const Real x586 = sine[2] * x576;
  const Real x590 = cosine[2] * x576;
  // what a loop holds its two links by
  const Real x851 = x270 * x835 + 0.23 * (v[9] + v[8] * x262);
  const Real x824 = x573 - x572;
  const Real x848 = x269 * x835 - 0.23 * (v[10] + v[8] * x265);
  const Real x792 = x272 * 0.23;
  const Real x798 = -0.06 - x261 * 0.23;
  const Real x829 = x582 + cosine[3] * x824;
  const Real x856 = x270 * x851 + x272 * x839 + x269 * x848;
  const Real x861 = x258 * x851 + x261 * x839 + x255 * x848;
  // link 2 "shank": accelerations and constraint forces of loops below it are eliminated
  const Real x2929 = x2922 * x2922 + x2917 * x2917 + x2923 * x2923;
  const Real x2930 = sqrt_of(x2929);
  const Real x2931 = x2930 * x2930;
  require_more(w, x2931, 9.999999999999998e-15, kLoopSingular, 9);
  const Real x2932 = x2929 + x2931;
  // what a loop holds its two links by
  const Real x560 = x535 - x536 - (cosine[4] * x546 - sine[4] * x540);
  const Real x561 = x529 - (0.05 - x151 * 0.15);
  const Real x627 = cosine[4] * x613 - sine[4] * x618;
  const Real x631 = cosine[2] * x584 - x586 - x627;
  const Real x623 = x148 * x608 + x151 * x596 + x145 * x605;
  const Real x633 = x578 - sine[3] * x575 - x623;
  const Real x557 = -0.25 - (cosine[4] * x540 + sine[4] * x546);
  const Real x559 = x531 + x532 + -0.4 - x557;
  const Real x630 = sine[4] * x613 + cosine[4] * x618;
  const Real x632 = sine[2] * x584 + x590 - x630;
  // what a loop holds its two links by
  const Real x812 = x535 + x536 + (cosine[5] * x798 - sine[5] * x792);
  const Real x814 = -0.05 - x268 * 0.23 + x529;
  const Real x870 = cosine[5] * x856 - sine[5] * x861;
  const Real x874 = x586 + cosine[2] * x829 - x870;
  const Real x866 = x265 * x851 + x268 * x839 + x262 * x848;
  const Real x876 = x578 - sine[3] * x824 - x866;
  const Real x809 = -0.17 - (cosine[5] * x792 + sine[5] * x798);
  const Real x811 = x532 - x531 + -0.4 - x809;
  const Real x873 = sine[5] * x856 + cosine[5] * x861;
  const Real x875 = sine[2] * x829 - x590 - x873;
  // link 2 "shank": accelerations and constraint forces of loops below it are eliminated
  const Real x3032 = x3023 + x3030 + (x2884 - x2900 * x2913) * x3013;
  const Real x3033 = 1 / x2930 * x3032;
  const Real x2934 = 2.0 * (1 / x2932);
  const Real x2936 = x2612 * x2612;
  require_more(w, x2936, 9.999999999999998e-15, kLoopSingular, 8);
  const Real x3035 = x2922 * x2934;
  const Real x3044 = x2917 * x2934;
  const Real x3053 = x2923 * x2934;
  const Real x3064 = x2934 * (x2930 * x3033);
  const Real x2939 = x2703 * x2703;
  require_more(w, x2939, 9.999999999999998e-15, kLoopSingular, 8);
  const Real x2941 = x2796 * x2796;
  require_more(w, x2941, 9.999999999999998e-15, kLoopSingular, 8);
  const Real x2943 = x2849 * x2849;
  require_more(w, x2943, 9.999999999999998e-15, kLoopSingular, 9);
  const Real x3038 = x2917 * x3035;
  const Real x3039 = x2923 * x3035;
  const Real x3046 = x2922 * x3044;
  const Real x3048 = x2923 * x3044;
  const Real x3055 = x2922 * x3053;
  const Real x3056 = x2917 * x3053;
  const Real x3068 = x2922 * x3064;
  const Real x3070 = x2917 * x3064;
  const Real x3041 = 1.0 - x2922 * x3035;
  const Real x3051 = 1.0 - x2917 * x3044;
  const Real x3061 = 1.0 - x2923 * x3053;
  const Real x3072 = x2923 * x3064;
  const Real x3036 = x2930 * x3035;
  w.x[171] = x3036;
  const Real x3045 = x2930 * x3044;
  w.x[172] = x3045;
  const Real x3054 = x2930 * x3053;
  w.x[173] = x3054;
  const Real x3473 = x1636 * x3036;
  const Real x3481 = x1636 * x3045;
  const Real x3489 = x1636 * x3054;
  const Real x3082 = 0.92 * x3038 + x2866 * x3039 - x2869 * x3041;
  const Real x3083 = x2905 * x3082;
  // what a loop holds its two links by
  const Real x566 = x560 * x560 + x561 * x561 + x559 * x559;
  const Real x653 = 1e-08 - x566;
  require_more(w, x653, 0.0, kLoopOpen, 8);
  const Real x638 = x631 * x631 + x633 * x633 + x632 * x632;
  const Real x654 = x651 - x638;
  require_more(w, x654, 0.0, kLoopTorn, 8);
  // what a loop holds its two links by
  const Real x822 = x812 * x812 + x814 * x814 + x811 * x811;
  const Real x893 = 1e-08 - x822;
  require_more(w, x893, 0.0, kLoopOpen, 9);
  const Real x881 = x874 * x874 + x876 * x876 + x875 * x875;
  const Real x894 = 1e-06 * x891 - x881;
  require_more(w, x894, 0.0, kLoopTorn, 9);
  // link 2 "shank": accelerations and constraint forces of loops below it are eliminated
  const Real x3074 = x2930 * x3064 - x3033;
  w.x[174] = x3074;
  const Real x3102 = x2869 * x3046 + x2866 * x3048 - 0.92 * x3051;
  const Real x3103 = x2905 * x3102;
  const Real x3122 = x2869 * x3055 + 0.92 * x3056 - x2866 * x3061;
  const Real x3123 = x2905 * x3122;
  const Real x3145 = x2900 * x3013 + x2869 * x3068 + 0.92 * x3070;
  const Real x3084 = x2900 * x3083;
  const Real x3104 = x2900 * x3103;
  const Real x3124 = x2900 * x3123;
  const Real x3149 = x2905 * (x2866 * x3072 + x3145);
  const Real x3092 = x3041 + x2869 * x3083;
  const Real x3094 = x2866 * x3083 - x3039;
  const Real x3112 = x2869 * x3103 - x3046;
  const Real x3114 = x2866 * x3103 - x3048;
  const Real x3132 = x2869 * x3123 - x3055;
  const Real x3134 = x3061 + x2866 * x3123;
  const Real x3093 = 0.92 * x3083 - x3038;
  w.x[175] = x3093;
  const Real x3159 = x2900 * x3149 - x3013;
  const Real x3113 = x3051 + 0.92 * x3103;
  w.x[176] = x3113;
  const Real x3160 = x3068 - x2869 * x3149;
  const Real x3162 = x3072 - x2866 * x3149;
  const Real x3133 = 0.92 * x3123 - x3056;
  w.x[177] = x3133;
  const Real x3168 = x2590 * x3092 - x2814 * x3084 + 0.92 * x3094;
  const Real x3169 = x2855 * x3168;
  const Real x3184 = x2590 * x3112 - x2814 * x3104 + 0.92 * x3114;
  const Real x3185 = x2855 * x3184;
  const Real x3200 = x2590 * x3132 - x2814 * x3124 + 0.92 * x3134;
  const Real x3201 = x2855 * x3200;
  const Real x3170 = x2850 * x3169;
  const Real x3186 = x2850 * x3185;
  const Real x3202 = x2850 * x3201;
  const Real x3175 = x3084 + x2814 * x3169;
  const Real x3177 = x3092 - x2590 * x3169;
  w.x[178] = x3177;
  const Real x3191 = x3104 + x2814 * x3185;
  const Real x3178 = x3094 - 0.92 * x3169;
  w.x[179] = x3178;
  const Real x3207 = x3124 + x2814 * x3201;
  const Real x3193 = x3112 - x2590 * x3185;
  w.x[180] = x3193;
  const Real x3194 = x3114 - 0.92 * x3185;
  w.x[181] = x3194;
  const Real x3541 = x1037 * x3177 + 0.00264635 * x3093;
  const Real x3550 = x1052 * x3177 + 0.00264635 * x3178;
  const Real x3544 = x1037 * x3193 + 0.00264635 * x3113;
  const Real x3235 = x2802 * (x2721 * x3170 + x2727 * x3175);
  const Real x3217 = x2814 * x3159 - x3211 + x2590 * x3160;
  const Real x3528 = x1242 * x3177 + x1037 * x3093 + x1052 * x3178;
  const Real x3251 = x2802 * (x2721 * x3186 + x2727 * x3191);
  const Real x3553 = x1052 * x3193 + 0.00264635 * x3194;
  const Real x3267 = x2802 * (x2721 * x3202 + x2727 * x3207);
  const Real x3209 = x3132 - x2590 * x3201;
  w.x[182] = x3209;
  const Real x3533 = x1242 * x3193 + x1037 * x3113 + x1052 * x3194;
  const Real x3237 = x2797 * x3235;
  const Real x3253 = x2797 * x3251;
  const Real x3269 = x2797 * x3267;
  const Real x3243 = x2721 * x3235 - x3170;
  const Real x3244 = x2727 * x3235 - x3175;
  const Real x3259 = x2721 * x3251 - x3186;
  const Real x3260 = x2727 * x3251 - x3191;
  const Real x3275 = x2721 * x3267 - x3202;
  const Real x3276 = x2727 * x3267 - x3207;
  const Real x3210 = x3134 - 0.92 * x3201;
  w.x[183] = x3210;
  const Real x3219 = x2855 * (0.92 * x3162 + x3217);
  const Real x3224 = x2996 + x2850 * x3219;
  const Real x3547 = x1037 * x3209 + 0.00264635 * x3133;
  const Real x3556 = x1052 * x3209 + 0.00264635 * x3210;
  const Real x3299 = x2631 * x3237 + 1.2 * x3243 + x2628 * x3244;
  const Real x3301 = x2709 * x3299;
  const Real x3226 = x3159 - x2814 * x3219;
  const Real x3322 = x2631 * x3253 + 1.2 * x3259 + x2628 * x3260;
  const Real x3324 = x2709 * x3322;
  const Real x3538 = x1242 * x3209 + x1037 * x3133 + x1052 * x3210;
  const Real x3345 = x2631 * x3269 + 1.2 * x3275 + x2628 * x3276;
  const Real x3347 = x2709 * x3345;
  const Real x3303 = x2704 * x3301;
  const Real x3326 = x2704 * x3324;
  const Real x3349 = x2704 * x3347;
  const Real x3311 = x3237 - x2631 * x3301;
  const Real x3313 = x3244 - x2628 * x3301;
  const Real x3334 = x3253 - x2631 * x3324;
  const Real x3336 = x3260 - x2628 * x3324;
  const Real x3312 = x3243 - 1.2 * x3301;
  w.x[184] = x3312;
  const Real x3357 = x3269 - x2631 * x3347;
  const Real x3359 = x3276 - x2628 * x3347;
  const Real x3335 = x3259 - 1.2 * x3324;
  w.x[185] = x3335;
  const Real x3358 = x3275 - 1.2 * x3347;
  w.x[186] = x3358;
  const Real x3386 = x2575 * x3303 + x2576 * x3311 + 1.2 * x3313;
  const Real x3387 = x2617 * x3386;
  const Real x3283 = x2802 * (x3277 - x2721 * x3224 + x2727 * x3226);
  const Real x3400 = x2575 * x3326 + x2576 * x3334 + 1.2 * x3336;
  const Real x3401 = x2617 * x3400;
  const Real x3414 = x2575 * x3349 + x2576 * x3357 + 1.2 * x3359;
  const Real x3415 = x2617 * x3414;
  const Real x3388 = x2613 * x3387;
  w.x[187] = x3388;
  const Real x3402 = x2613 * x3401;
  w.x[188] = x3402;
  const Real x3416 = x2613 * x3415;
  w.x[189] = x3416;
  const Real x3393 = x3303 - x2575 * x3387;
  w.x[190] = x3393;
  const Real x3394 = x3311 - x2576 * x3387;
  w.x[191] = x3394;
  const Real x3395 = x3313 - 1.2 * x3387;
  w.x[192] = x3395;
  const Real x3407 = x3326 - x2575 * x3401;
  w.x[193] = x3407;
  const Real x3408 = x3334 - x2576 * x3401;
  w.x[194] = x3408;
  const Real x3409 = x3336 - 1.2 * x3401;
  w.x[195] = x3409;
  const Real x3421 = x3349 - x2575 * x3415;
  w.x[196] = x3421;
  const Real x3444 = x2284 * x3388 + x2184 * x3393;
  w.x[197] = x3444;
  const Real x3461 = x2184 * x3388 + 0.003308333 * x3393;
  w.x[198] = x3461;
  const Real x3496 = x1618 * x3394 + 0.00112635 * x3312;
  const Real x3505 = x1633 * x3394 + 0.00112635 * x3395;
  w.x[199] = x3505;
  const Real x3450 = x2284 * x3402 + x2184 * x3407;
  w.x[200] = x3450;
  const Real x3515 = x1636 * x3394 - 2.7e-06 * x3036;
  const Real x3465 = x2184 * x3402 + 0.003308333 * x3407;
  w.x[201] = x3465;
  const Real x3499 = x1618 * x3408 + 0.00112635 * x3335;
  const Real x3476 = x1618 * x3312 - x3473 + x1814 * x3394;
  const Real x3477 = x1633 * x3395 + x3476;
  w.x[202] = x3477;
  const Real x3508 = x1633 * x3408 + 0.00112635 * x3409;
  w.x[203] = x3508;
  const Real x3794 = x3093 * x3541 + x3178 * x3550 + x3177 * x3528;
  const Real x3813 = x3093 * x3544 + x3178 * x3553 + x3177 * x3533;
  const Real x3519 = x1636 * x3408 - 2.7e-06 * x3045;
  w.x[204] = x3519;
  const Real x3870 = x3113 * x3544 + x3194 * x3553 + x3193 * x3533;
  const Real x3422 = x3357 - x2576 * x3415;
  w.x[205] = x3422;
  const Real x3456 = x2284 * x3416 + x2184 * x3421;
  w.x[206] = x3456;
  const Real x3484 = x1618 * x3335 - x3481 + x1814 * x3408;
  const Real x3485 = x1633 * x3409 + x3484;
  w.x[207] = x3485;
  const Real x3796 = x3388 * x3444 + x3794 + x3393 * x3461;
  const Real x3423 = x3359 - 1.2 * x3415;
  w.x[208] = x3423;
  const Real x3815 = x3388 * x3450 + x3813 + x3393 * x3465;
  const Real x3469 = x2184 * x3416 + 0.003308333 * x3421;
  w.x[209] = x3469;
  const Real x3872 = x3402 * x3450 + x3870 + x3407 * x3465;
  const Real x3502 = x1618 * x3422 + 0.00112635 * x3358;
  w.x[210] = x3502;
  const Real x3832 = x3093 * x3547 + x3178 * x3556 + x3177 * x3538;
  const Real x3798 = x3312 * x3496 + x3796 + x3395 * x3505;
  const Real x3511 = x1633 * x3422 + 0.00112635 * x3423;
  w.x[211] = x3511;
  const Real x3817 = x3312 * x3499 + x3815 + x3395 * x3508;
  const Real x3889 = x3113 * x3547 + x3194 * x3556 + x3193 * x3538;
  const Real x3800 = x3798 - x3036 * x3515 + x3394 * x3477;
  require_more(w, x3800, 0.0, kLoopFree, 2);
  const Real x3287 = x2982 - x2797 * x3283;
  const Real x3874 = x3335 * x3499 + x3872 + x3409 * x3508;
  const Real x3819 = x3817 - x3036 * x3519 + x3394 * x3485;
  const Real x3523 = x1636 * x3422 - 2.7e-06 * x3054;
  w.x[212] = x3523;
  const Real x3834 = x3388 * x3456 + x3832 + x3393 * x3469;
  const Real x4268 = 1 / x3800;
  w.x[213] = x4268;
  const Real x3876 = x3874 - x3045 * x3519 + x3408 * x3485;
  w.x[214] = x3876;
  const Real x3288 = x3224 + x2721 * x3283;
  const Real x3492 = x1618 * x3358 - x3489 + x1814 * x3422;
  const Real x3493 = x1633 * x3423 + x3492;
  w.x[215] = x3493;
  const Real x3891 = x3402 * x3456 + x3889 + x3407 * x3469;
  const Real x3946 = x3133 * x3547 + x3210 * x3556 + x3209 * x3538;
  const Real x3290 = x3226 - x2727 * x3283;
  const Real x3836 = x3312 * x3502 + x3834 + x3395 * x3511;
  const Real x4078 = x1339 * x3093 - x3473 + x1313 * x3177;
  const Real x3838 = x3836 - x3036 * x3523 + x3394 * x3493;
  const Real x3893 = x3335 * x3502 + x3891 + x3409 * x3511;
  const Real x3948 = x3416 * x3456 + x3946 + x3421 * x3469;
  const Real x4269 = x3819 * x4268;
  w.x[216] = x4269;
  const Real x3368 = x3360 - x2631 * x3287 + 1.2 * x3288;
  const Real x3557 = x1055 * x3177;
  const Real x4270 = x3838 * x4268;
  w.x[217] = x4270;
  const Real x4096 = x1339 * x3113 - x3481 + x1313 * x3193;
  const Real x3370 = x2709 * (x3368 - x2628 * x3290);
  const Real x3950 = x3358 * x3502 + x3948 + x3423 * x3511;
  const Real x4274 = x3876 - x3819 * x4269;
  w.x[218] = x4274;
  const Real x3895 = x3893 - x3045 * x3523 + x3408 * x3493;
  const Real x4277 = x3895 - x3838 * x4269;
  const Real x4080 = x1369 * x3178 + x4078 + x1909 * x3312;
  const Real x3952 = x3950 - x3054 * x3523 + x3422 * x3493;
  w.x[219] = x3952;
  const Real x4281 = 1 / x4274;
  w.x[220] = x4281;
  const Real x3378 = x2970 - x2704 * x3370;
  w.x[221] = x3378;
  const Real x3379 = x3287 + x2631 * x3370;
  w.x[222] = x3379;
  const Real x3381 = x3290 + x2628 * x3370;
  w.x[223] = x3381;
  const Real x4114 = x1339 * x3133 - x3489 + x1313 * x3209;
  const Real x4280 = x1055 * x3193 - x3557 * x4269;
  const Real x3161 = x3070 - 0.92 * x3149;
  w.x[224] = x3161;
  const Real x3228 = x3162 - 0.92 * x3219;
  w.x[225] = x3228;
  const Real x4098 = x1369 * x3194 + x4096 + x1909 * x3335;
  const Real x4282 = x4277 * x4281;
  w.x[226] = x4282;
  const Real x4271 = x3557 * x4268;
  w.x[227] = x4271;
  const Real x3227 = x3160 - x2590 * x3219;
  w.x[228] = x3227;
  const Real x3429 = x3424 + x2575 * x3378 + x2576 * x3379;
  const Real x4082 = x4080 - x2325 * x3388 - x2338 * x3393;
  const Real x4289 = x3952 - x3838 * x4270 - x4277 * x4282;
  w.x[229] = x4289;
  const Real x4116 = x1369 * x3210 + x4114 + x1909 * x3358;
  const Real x4131 = x1298 * x3177 + x1324 * x3093 + x1351 * x3178;
  const Real x4181 = x1301 * x3177 + x1327 * x3093 - x1356 * x3178;
  const Real x4296 = 1 / x4289;
  w.x[230] = x4296;
  const Real x4283 = x4280 * x4281;
  w.x[231] = x4283;
  const Real x4295 = x1055 * x3209 - x3557 * x4270 - x4280 * x4282;
  const Real x3380 = 1.2 * x3370 - x3288;
  w.x[232] = x3380;
  const Real x3431 = x2617 * (1.2 * x3381 + x3429);
  w.x[233] = x3431;
  const Real x4084 = x1884 * x3394 + x4082 + x1938 * x3395;
  w.x[234] = x4084;
  const Real x4100 = x4098 - x2325 * x3402 - x2338 * x3407;
  const Real x4147 = x1298 * x3193 + x1324 * x3113 + x1351 * x3194;
  const Real x4199 = x1301 * x3193 + x1327 * x3113 - x1356 * x3194;
  const Real x4297 = x4295 * x4296;
  w.x[235] = x4297;
  const Real x3661 = x3161 * x3547;
  w.x[236] = x3661;
  const Real x3662 = x3228 * x3556;
  w.x[237] = x3662;
  const Real x4102 = x1884 * x3408 + x4100 + x1938 * x3409;
  w.x[238] = x4102;
  const Real x4109 = x1938 * x3423;
  w.x[239] = x4109;
  const Real x4118 = x4116 - x2325 * x3416 - x2338 * x3421;
  const Real x4119 = x1884 * x3422 + x4118;
  w.x[240] = x4119;
  const Real x4318 = x4084 * x4269;
  w.x[241] = x4318;
  const Real x4124 = x1870 * x3394;
  w.x[242] = x4124;
  const Real x4133 = x1895 * x3312 + x4131 - x2316 * x3388;
  const Real x4134 = x531 * x3393 + x4133;
  w.x[243] = x4134;
  const Real x4139 = x531 * x3407;
  w.x[244] = x4139;
  const Real x4149 = x1895 * x3335 + x4147 - x2316 * x3402;
  w.x[245] = x4149;
  const Real x4153 = x2316 * x3416;
  w.x[246] = x4153;
  const Real x4163 = x1298 * x3209 + x1324 * x3133 + x1351 * x3210;
  const Real x4164 = x1895 * x3358 + x4163;
  w.x[247] = x4164;
  const Real x4172 = x1873 * x3394;
  w.x[248] = x4172;
  const Real x4183 = x1898 * x3312 + x4181 + x2321 * x3388;
  const Real x4184 = x535 * x3393 + x4183;
  w.x[249] = x4184;
  const Real x4189 = x535 * x3407;
  w.x[250] = x4189;
  const Real x4201 = x1898 * x3335 + x4199 + x2321 * x3402;
  w.x[251] = x4201;
  const Real x4205 = x2321 * x3416;
  w.x[252] = x4205;
  const Real x4217 = x1301 * x3209 + x1327 * x3133 - x1356 * x3210;
  const Real x4218 = x1898 * x3358 + x4217;
  w.x[253] = x4218;
  const Real x4302 = x4295 * x4297;
  w.x[254] = x4302;
  const Real x4305 = 2.7e-06 - x3557 * x4271 - x4280 * x4283;
  w.x[255] = x4305;
  const Real x3433 = x2575 * x3431;
  w.x[256] = x3433;
  const Real x3436 = x2962 - x2613 * x3431;
  w.x[257] = x3436;
  const Real x3564 = x1604 * x3312;
  w.x[258] = x3564;
  const Real x3572 = x1023 * x3093 - x1606 * x3036 + x1287 * x3177;
  const Real x3573 = x1024 * x3178 + x3572;
  w.x[259] = x3573;
  const Real x3589 = x1024 * x3194;
  w.x[260] = x3589;
  const Real x3591 = x1023 * x3113 - x1606 * x3045 + x1287 * x3193;
  w.x[261] = x3591;
  const Real x3606 = x1287 * x3209;
  w.x[262] = x3606;
  const Real x3609 = x1023 * x3133 - x1606 * x3054;
  w.x[263] = x3609;
  const Real x3623 = x3074 * x3515;
  w.x[264] = x3623;
  const Real x3628 = x3161 * x3541 + x3228 * x3550 + x3227 * x3528;
  const Real x3629 = x3380 * x3496 + x3628;
  w.x[265] = x3629;
  const Real x3639 = x3380 * x3499;
  w.x[266] = x3639;
  const Real x3646 = x3161 * x3544 + x3228 * x3553 + x3227 * x3533;
  w.x[267] = x3646;
  const Real x3660 = x3227 * x3538;
  w.x[268] = x3660;
}

ADAGEN_NOINLINE void part_1_2(Workspace& w) {
  ADAGEN_INPUTS
  const Real x334 = w.x[160];
  const Real x531 = w.x[111];
  const Real x535 = w.x[85];
  const Real x1024 = w.x[115];
  const Real x1025 = w.x[152];
  const Real x1055 = w.x[55];
  const Real x1298 = w.x[90];
  const Real x1301 = w.x[66];
  const Real x1313 = w.x[88];
  const Real x1324 = w.x[91];
  const Real x1327 = w.x[65];
  const Real x1339 = w.x[67];
  const Real x1351 = w.x[118];
  const Real x1356 = w.x[87];
  const Real x1369 = w.x[89];
  const Real x1604 = w.x[153];
  const Real x1605 = w.x[154];
  const Real x1636 = w.x[59];
  const Real x1859 = w.x[156];
  const Real x1870 = w.x[128];
  const Real x1873 = w.x[95];
  const Real x1884 = w.x[125];
  const Real x1895 = w.x[126];
  const Real x1898 = w.x[93];
  const Real x1909 = w.x[94];
  const Real x1921 = w.x[155];
  const Real x1926 = w.x[96];
  const Real x1938 = w.x[127];
  const Real x2146 = w.x[161];
  const Real x2183 = w.x[157];
  const Real x2303 = w.x[158];
  const Real x2316 = w.x[133];
  const Real x2321 = w.x[97];
  const Real x2325 = w.x[98];
  const Real x2338 = w.x[99];
  const Real x2539 = w.x[167];
  const Real x2540 = w.x[164];
  const Real x2541 = w.x[165];
  const Real x2542 = w.x[163];
  const Real x2543 = w.x[162];
  const Real x2567 = w.x[166];
  const Real x2568 = w.x[169];
  const Real x2569 = w.x[168];
  const Real x2576 = w.x[20];
  const Real x2899 = w.x[159];
  const Real x3036 = w.x[171];
  const Real x3045 = w.x[172];
  const Real x3054 = w.x[173];
  const Real x3074 = w.x[174];
  const Real x3093 = w.x[175];
  const Real x3113 = w.x[176];
  const Real x3133 = w.x[177];
  const Real x3161 = w.x[224];
  const Real x3177 = w.x[178];
  const Real x3178 = w.x[179];
  const Real x3193 = w.x[180];
  const Real x3194 = w.x[181];
  const Real x3209 = w.x[182];
  const Real x3210 = w.x[183];
  const Real x3227 = w.x[228];
  const Real x3228 = w.x[225];
  const Real x3312 = w.x[184];
  const Real x3335 = w.x[185];
  const Real x3358 = w.x[186];
  const Real x3378 = w.x[221];
  const Real x3379 = w.x[222];
  const Real x3380 = w.x[232];
  const Real x3381 = w.x[223];
  const Real x3388 = w.x[187];
  const Real x3393 = w.x[190];
  const Real x3394 = w.x[191];
  const Real x3395 = w.x[192];
  const Real x3402 = w.x[188];
  const Real x3407 = w.x[193];
  const Real x3408 = w.x[194];
  const Real x3409 = w.x[195];
  const Real x3416 = w.x[189];
  const Real x3421 = w.x[196];
  const Real x3422 = w.x[205];
  const Real x3423 = w.x[208];
  const Real x3431 = w.x[233];
  const Real x3433 = w.x[256];
  const Real x3436 = w.x[257];
  const Real x3444 = w.x[197];
  const Real x3450 = w.x[200];
  const Real x3456 = w.x[206];
  const Real x3461 = w.x[198];
  const Real x3465 = w.x[201];
  const Real x3469 = w.x[209];
  const Real x3477 = w.x[202];
  const Real x3485 = w.x[207];
  const Real x3493 = w.x[215];
  const Real x3502 = w.x[210];
  const Real x3505 = w.x[199];
  const Real x3508 = w.x[203];
  const Real x3511 = w.x[211];
  const Real x3519 = w.x[204];
  const Real x3523 = w.x[212];
  const Real x3564 = w.x[258];
  const Real x3573 = w.x[259];
  const Real x3589 = w.x[260];
  const Real x3591 = w.x[261];
  const Real x3606 = w.x[262];
  const Real x3609 = w.x[263];
  const Real x3623 = w.x[264];
  const Real x3629 = w.x[265];
  const Real x3639 = w.x[266];
  const Real x3646 = w.x[267];
  const Real x3660 = w.x[268];
  const Real x3661 = w.x[236];
  const Real x3662 = w.x[237];
  const Real x3876 = w.x[214];
  const Real x3952 = w.x[219];
  const Real x4084 = w.x[234];
  const Real x4102 = w.x[238];
  const Real x4109 = w.x[239];
  const Real x4119 = w.x[240];
  const Real x4124 = w.x[242];
  const Real x4134 = w.x[243];
  const Real x4139 = w.x[244];
  const Real x4149 = w.x[245];
  const Real x4153 = w.x[246];
  const Real x4164 = w.x[247];
  const Real x4172 = w.x[248];
  const Real x4184 = w.x[249];
  const Real x4189 = w.x[250];
  const Real x4201 = w.x[251];
  const Real x4205 = w.x[252];
  const Real x4218 = w.x[253];
  const Real x4268 = w.x[213];
  const Real x4269 = w.x[216];
  const Real x4270 = w.x[217];
  const Real x4271 = w.x[227];
  const Real x4274 = w.x[218];
  const Real x4281 = w.x[220];
  const Real x4282 = w.x[226];
  const Real x4283 = w.x[231];
  const Real x4289 = w.x[229];
  const Real x4296 = w.x[230];
  const Real x4297 = w.x[235];
  const Real x4302 = w.x[254];
  const Real x4305 = w.x[255];
  const Real x4318 = w.x[241];
  const Real x4916 = w.x[170];
  // link 2 "shank": accelerations and constraint forces of loops below it are eliminated
  const Real x4120 = x4109 + x4119;
  const Real x4320 = x4102 - x4318;
  const Real x4306 = x4305 - x4302;
  require_more(w, x4306, 4.796163466380676e-21, kLoopFree, 5);
  const Real x3437 = x3378 - x3433;
  const Real x4136 = x4124 + x4134 + x1921 * x3395;
  const Real x4186 = x4172 + x4184 - x1926 * x3395;
  const Real x4307 = 1 / x4306;
  const Real x3438 = x3379 - x2576 * x3431;
  const Real x4350 = x4120 - x4084 * x4270 - x4282 * x4320;
  const Real x4152 = x4139 + x4149 + x1870 * x3408 + x1921 * x3409;
  const Real x4204 = x4189 + x4201 + x1873 * x3408 - x1926 * x3409;
  const Real x3439 = x3381 - 1.2 * x3431;
  const Real x3665 = x3661 + x3662 + x3660 + x3380 * x3502;
  const Real x4167 = x4164 - x4153 + x531 * x3421 + x1870 * x3422;
  const Real x4168 = x1921 * x3423 + x4167;
  const Real x4221 = x4205 + x4218 + x535 * x3421 + x1873 * x3422;
  const Real x4222 = x4221 - x1926 * x3423;
  const Real x4323 = x4152 - x4136 * x4269;
  const Real x4326 = x4204 - x4186 * x4269;
  const Real x3576 = x3564 + x3573 - x2303 * x3388 + x2183 * x3393;
  const Real x3594 = x3589 + x3591 + x1604 * x3335 - x2303 * x3402;
  const Real x3612 = x3606 + x3609 + x1024 * x3210 + x1604 * x3358;
  const Real x3632 = x3623 + x3629 - x3436 * x3444 + x3437 * x3461;
  const Real x3649 = x3639 + x3646 + x3074 * x3519 - x3436 * x3450;
  const Real x4400 = x1055 - x4084 * x4271 - x4283 * x4320;
  const Real x3667 = x3074 * x3523 + x3665 - x3436 * x3456;
  const Real x4464 = x4307 * (x4400 - x4297 * x4350);
  const Real x4356 = x4168 - x4136 * x4270 - x4282 * x4323;
  const Real x4362 = x4222 - x4186 * x4270 - x4282 * x4326;
  const Real x3596 = x2183 * x3407 + x3594 + x1859 * x3408;
  const Real x3614 = x3612 - x2303 * x3416 + x2183 * x3421;
  const Real x3651 = x3437 * x3465 + x3649 + x3438 * x3485;
  const Real x3578 = x1859 * x3394 + x3576 + x1605 * x3395;
  const Real x3672 = x3438 * x3477 + x3632 + x3439 * x3505 + x3578;
  const Real x3669 = x3437 * x3469 + x3667 + x3438 * x3493;
  const Real x4480 = x4296 * x4350 - x4297 * x4464;
  const Real x3616 = x1859 * x3422 + x3614 + x1605 * x3423;
  const Real x3673 = x1605 * x3409 + x3596 + (x3439 * x3508 + x3651);
  const Real x4332 = x3673 - x3672 * x4269;
  const Real x4410 = x4136 * x4271 + x4283 * x4323 + x4297 * x4356;
  const Real x4465 = x4307 * x4410;
  const Real x4420 = x4186 * x4271 + x4283 * x4326 + x4297 * x4362;
  const Real x4467 = x4307 * x4420;
  const Real x4510 = x4281 * x4320 - x4283 * x4464 - x4282 * x4480;
  const Real x4373 = x3439 * x3511 + x3669 + x3616 - x3672 * x4270;
  const Real x4374 = x4373 - x4282 * x4332;
  const Real x4483 = x4296 * x4356 + x4297 * x4465;
  const Real x4438 = x1025 + x1055 * x3227 - x3672 * x4271;
  const Real x4486 = x4296 * x4362 + x4297 * x4467;
  const Real x4560 = x4084 * x4268 - x4271 * x4464 - x4270 * x4480;
  const Real x4561 = x4560 - x4269 * x4510;
  const Real x4516 = x4281 * x4323 + x4283 * x4465 - x4282 * x4483;
  const Real x4522 = x4281 * x4326 + x4283 * x4467 - x4282 * x4486;
  const Real x4471 = x4307 * (x4438 - x4283 * x4332 - x4297 * x4374);
  const Real x4722 = x4120 * x4480 + x1055 * x4464 + x4102 * x4510;
  const Real x4724 = x2539 - (x4084 * x4561 + x4722);
  require_more(w, x4724, 0.0, kFactorization, 1);
  const Real x4569 = x4136 * x4268 + x4271 * x4465 - x4270 * x4483;
  const Real x4570 = x4569 - x4269 * x4516;
  const Real x4578 = x4186 * x4268 + x4271 * x4467 - x4270 * x4486;
  const Real x4579 = x4578 - x4269 * x4522;
  const Real x3721 = x1636 * x3074 + x1339 * x3161 + x1313 * x3227;
  const Real x4492 = x4296 * x4374 - x4297 * x4471;
  const Real x4731 = x4120 * x4483 - x1055 * x4465 + x4102 * x4516;
  const Real x4740 = x4120 * x4486 - x1055 * x4467 + x4102 * x4522;
  const Real x3723 = x1369 * x3228 + x3721 + x1909 * x3380;
  const Real x4534 = x4281 * x4332 - x4283 * x4471 - x4282 * x4492;
  const Real x4733 = x2540 - (x4084 * x4570 + x4731);
  const Real x4742 = x2541 - (x4084 * x4579 + x4740);
  const Real x3725 = x2325 * x3436 + x3723 - x2338 * x3437;
  const Real x3737 = x1298 * x3227 + x1324 * x3161 + x1351 * x3228;
  const Real x3755 = x1301 * x3227 + x1327 * x3161 - x1356 * x3228;
  const Real x4596 = x3672 * x4268 - x4271 * x4471 - x4270 * x4492;
  const Real x4597 = x4596 - x4269 * x4534;
  const Real x4756 = x4152 * x4516 + x4168 * x4483 + x4136 * x4570;
  const Real x4774 = x4204 * x4522 + x4222 * x4486 + x4186 * x4579;
  // joint 1 "knee": articulated-body inertia and bias force through it
  const Real x4831 = 1 / x4724;
  const Real x4836 = x4733 * x4831;
  const Real x4837 = x4742 * x4831;
  // link 2 "shank": accelerations and constraint forces of loops below it are eliminated
  const Real x4762 = x4152 * x4522 + x4168 * x4486 + x4136 * x4579;
  const Real x3739 = x1895 * x3380 + x3737 + x2316 * x3436;
  const Real x3757 = x1898 * x3380 + x3755 - x2321 * x3436;
  const Real x4807 = x4120 * x4492 + x1055 * x4471 + x4102 * x4534;
  const Real x3778 = x1884 * x3438 + x3725 + x1938 * x3439 + x2567;
  const Real x2945 = x2899 * x2899;
  require_more(w, x2945, 9.999999999999998e-15, kLoopSingular, 9);
  const Real x4309 = x3876 * 1.7763568394002505e-15;
  require_more(w, x4274, x4309, kLoopFree, 3);
  const Real x3741 = x531 * x3437 + x3739 + x1870 * x3438;
  const Real x3759 = x535 * x3437 + x3757 + x1873 * x3438;
  const Real x4310 = x3952 * 1.7763568394002505e-15;
  require_more(w, x4289, x4310, kLoopFree, 4);
  const Real x4813 = x4152 * x4534 + x4168 * x4492 + x4136 * x4597;
  const Real x4818 = x4204 * x4534 + x4222 * x4492 + x4186 * x4597;
  // joint 1 "knee": articulated-body inertia and bias force through it
  const Real x4868 = x2542 - x4756 - x4733 * x4836;
  const Real x4935 = cosine[1] * (x4868 - (x2543 - x4774 - x4742 * x4837));
  const Real x4833 = x4831 * (tau[1] - (x3778 - (x4084 * x4597 + x4807)));
  const Real x4938 = x4935 - (x2146 - x4762 - x4733 * x4837) * x4916;
  // link 2 "shank": accelerations and constraint forces of loops below it are eliminated
  const Real x4827 = x1921 * x3439 + x3741 + x2568 - x4813;
  const Real x4828 = x3759 - x1926 * x3439 + x2569 - x4818;
  // joint 1 "knee": articulated-body inertia and bias force through it
  const Real x4984 = sine[1] * (x4827 + x4733 * x4833);
  const Real x4996 = 0.32735000000000003 + 0.4 * (0.4 * (x4868 - cosine[1] * x4938));
  require_more(w, x4996, 0.0, kFactorization, 0);
  const Real x4990 = 0.4 * (x4984 + cosine[1] * (x4828 + x4742 * x4833));
  // joint 0 "hip": articulated-body inertia and bias force through it
  const Real x5007 = 1 / x4996 * (tau[0] - (tau[1] - x4990 + x334));
  w.result[0] = x5007;
  // joint 1 "knee": its acceleration, and that of the link beyond
  const Real x5017 = 0.4 * x5007;
  const Real x5019 = sine[1] * x5017;
  const Real x5021 = cosine[1] * x5017;
  const Real x5028 = x4833 + x4836 * x5019 + x4837 * x5021;
  const Real x5029 = x5028 - x5007;
  w.result[1] = x5029;
  // link 2 "shank": accelerations and constraint forces of loops below it
  const Real x5037 = x4570 * x5019 + x4579 * x5021 - x4561 * x5028;
  const Real x5064 = x5037 - x4597;
  const Real x5045 = x4516 * x5019 + x4522 * x5021 - x4510 * x5028;
  const Real x5065 = x5045 - x4534;
  const Real x5053 = x4483 * x5019 + x4486 * x5021 - x4480 * x5028;
  const Real x5066 = x5053 - x4492;
  const Real x5062 = x4465 * x5019 + x4467 * x5021 + x4464 * x5028;
  const Real x5068 = -(x4471 + x5062);
  w.result[11] = x5068;
  const Real x5077 = x3388 * x5064 + x3402 * x5065 + x3416 * x5066;
  const Real x5124 = x3436 - x5077;
  w.result[2] = x5124;
  const Real x5083 = x3393 * x5064 + x3407 * x5065 + x3421 * x5066;
  const Real x5125 = x3437 + x5083;
  w.result[3] = x5125;
  const Real x5088 = x3394 * x5064 + x3408 * x5065 + x3422 * x5066;
  const Real x5126 = x3438 + x5088;
  w.result[4] = x5126;
  const Real x5093 = x3312 * x5064 + x3335 * x5065 + x3358 * x5066;
  const Real x5127 = x3380 + x5093;
  w.result[5] = x5127;
  const Real x5098 = x3395 * x5064 + x3409 * x5065 + x3423 * x5066;
  const Real x5128 = x3439 + x5098;
  w.result[6] = x5128;
  const Real x5107 = x3036 * x5064 + x3045 * x5065 + x3054 * x5066;
  const Real x5129 = x3074 - x5107;
  w.result[7] = x5129;
  const Real x5113 = x3177 * x5064 + x3193 * x5065 + x3209 * x5066;
  const Real x5130 = x3227 + x5113;
  w.result[8] = x5130;
  const Real x5118 = x3093 * x5064 + x3113 * x5065 + x3133 * x5066;
  const Real x5131 = x3161 + x5118;
  w.result[9] = x5131;
  const Real x5123 = x3178 * x5064 + x3194 * x5065 + x3210 * x5066;
  const Real x5132 = x3228 + x5123;
  w.result[10] = x5132;
}

// ---- 5. processes -------------------------------------------------------------------------------

// Process 0: 8 of 8 joints: "hip", "knee", "ankle_pitch", "ankle_roll", "left_motor", "left_ball", ...
constexpr std::array<int, 8> kRead_0{0, 1, 2, 3, 4, 5, 6, 7};
constexpr std::array<int, 8> kOwned_0{0, 1, 2, 3, 4, 5, 6, 7};

void run_0([[maybe_unused]] Workspace& w, [[maybe_unused]] Channel& channel) {
  ADAGEN_INPUTS
  stamp(0);
  w.angle[0] = q[0];
  w.angle[1] = q[1];
  w.angle[2] = q[2];
  w.angle[3] = q[3];
  w.angle[4] = q[4];
  w.angle[5] = q[9];
  take_sines_and_cosines<6>(w.angle.data(), w.sine.data(), w.cosine.data());
  part_0_0(w);
  part_0_1(w);
  stamp(1);
  stamp(2);
  stamp(3);
  if (__builtin_expect(w.status != kFine || !all(unlike_zero(w.result.data() + 0, 12) == 0), 0)) {
    // The state's own faults are named before all others.
    const int found = std::exchange(w.status, kFine);
    name_what_is_not_finite(w, kRead_0, kOwned_0);
    Channel::fail(w.status, found);
    name_what_overflows(w, kOwned_0);
  }
  if (w.status != kFine) return;
  std::copy_n(w.result.data() + 0, 12, w.qdd + 0);
}


// What is done instead in a pose in which a mobility cannot be taken for an inertia.
void recover_0([[maybe_unused]] Workspace& w, [[maybe_unused]] Channel& channel) {
  ADAGEN_INPUTS
  stamp(0);
  w.angle[0] = q[0];
  w.angle[1] = q[1];
  w.angle[2] = q[2];
  w.angle[3] = q[3];
  w.angle[4] = q[4];
  w.angle[5] = q[9];
  take_sines_and_cosines<6>(w.angle.data(), w.sine.data(), w.cosine.data());
  part_1_0(w);
  part_1_1(w);
  part_1_2(w);
  stamp(1);
  stamp(2);
  stamp(3);
  if (__builtin_expect(w.status != kFine || !all(unlike_zero(w.result.data() + 0, 12) == 0), 0)) {
    // The state's own faults are named before all others.
    const int found = std::exchange(w.status, kFine);
    name_what_is_not_finite(w, kRead_0, kOwned_0);
    Channel::fail(w.status, found);
    name_what_overflows(w, kOwned_0);
  }
  if (w.status != kFine) return;
  std::copy_n(w.result.data() + 0, 12, w.qdd + 0);
}

[[maybe_unused]] constexpr std::array<void (*)(Workspace&, Channel&), kProcesses> kRun{run_0};
constexpr std::array<void (*)(Workspace&, Channel&), 1> kRecover{recover_0};

// What each process reads of q and v, the velocity entries whose qdd is its own, and whose tau it
// reads.
constexpr std::array<Range, 1> kReadQ_0{ {{0, 14}} };
constexpr std::array<Range, 1> kReadV_0{ {{0, 12}} };
constexpr std::array<Range, 1> kOwn_0{ {{0, 12}} };
constexpr std::array<Range, 1> kTorque_0{ {{0, 12}} };
[[maybe_unused]] constexpr std::array<ProcessInfo, kProcesses> kProcess{ {
    {{1, kReadQ_0.data()}, {1, kReadV_0.data()}, {1, kOwn_0.data()}, {1, kTorque_0.data()}},
} };

}  // namespace

#include "adagen/no_parameters.hpp"
#include "adagen/solver_alone.hpp"
#include "adagen/open_alone.hpp"

static_assert(ANKLE_P1_NQ == kNq && ANKLE_P1_NV == kNv && ANKLE_P1_NTAU == kNtau);
static_assert(int(ANKLE_P1_FINE) == int(kFine));
static_assert(int(ANKLE_P1_NOT_FINITE) == int(kNotFinite));
static_assert(int(ANKLE_P1_ZERO_QUATERNION) == int(kZeroQuaternion));
static_assert(int(ANKLE_P1_FACTORIZATION) == int(kFactorization));
static_assert(int(ANKLE_P1_OVERFLOW) == int(kOverflow));
static_assert(int(ANKLE_P1_NO_ANSWER) == int(kNoAnswer));
static_assert(int(ANKLE_P1_ENDED) == int(kEnded));
static_assert(int(ANKLE_P1_NOT_REFINED) == int(kNotRefined));
static_assert(int(ANKLE_P1_GIMBAL_LOCK) == int(kGimbalLock));
static_assert(int(ANKLE_P1_GROWTH) == int(kGrowth));
static_assert(int(ANKLE_P1_NOT_SET) == int(kNotSet));
static_assert(int(ANKLE_P1_TOO_FEW_STEPS) == int(kTooFewSteps));
static_assert(int(ANKLE_P1_LOOP_OPEN) == int(kLoopOpen));
static_assert(int(ANKLE_P1_LOOP_TORN) == int(kLoopTorn));
static_assert(int(ANKLE_P1_LOOP_SINGULAR) == int(kLoopSingular));
static_assert(int(ANKLE_P1_LOOP_FREE) == int(kLoopFree));

struct ankle_p1_solver : Solver {};

extern "C" {

int ankle_p1_joint(int k, const char** name, int* q, int* nq, int* v, int* nv) {
  if (k < 0 || k >= kJointCount) return 0;
  const JointConstants& joint = kJoints[k];
  *name = joint.name, *q = joint.q, *nq = joint.nq, *v = joint.v, *nv = joint.nv;
  return 1;
}

ankle_p1_solver* ankle_p1_open(void) { return opened<ankle_p1_solver>(); }

int ankle_p1_solve(ankle_p1_solver* solver, const double* q, const double* v, const double* tau, double* qdd) {
  return solver->solve(q, v, tau, qdd);
}

int ankle_p1_reason(int status) { return failure_kind(status); }

int ankle_p1_failed_joint(int status) { return is_of_joint(failure_kind(status)) ? failure_place(status) : -1; }

const char* ankle_p1_failure(const ankle_p1_solver* solver) {
  return solver == nullptr ? open_failure.c_str() : solver->text.c_str();
}

void ankle_p1_close(ankle_p1_solver* solver) {
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
#include "adagen/measured_alone.hpp"
#include "adagen/this_solver.hpp"

namespace {

// The stages of each process's work, for --trace.
constexpr std::array<adagen::Stage, 3> kStages_0{ {
    {"kinematics", 7, -1},
    {"assembly", 0, -1},
    {"disassembly", 0, -1},
} };
constexpr std::array<adagen::Table<adagen::Stage>, kProcesses> kStages{ {
    {kStages_0.data(), 3},
} };

// Joints that close loops, each between a frame of its first link and one of its second; z is its
// axis. Then joints whose coordinates are coupled.
constexpr Number kLoop_0[]{1.0, 0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 1.0, 0.0, 0.0, -0.15,
    0.0, 1.0, 0.0, 0.0, 0.0, 1.0, 1.0, 0.0, 0.0, 0.05, 0.0, -0.06};
constexpr Number kLoop_1[]{1.0, 0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 1.0, 0.0, 0.0, -0.23,
    0.0, 1.0, 0.0, 0.0, 0.0, 1.0, 1.0, 0.0, 0.0, -0.05, 0.0, -0.06};
constexpr std::array<adagen::Loop<Number>, 2> kLoops{ {
    {kLoopNames[0], 6, 4, kLoop_0, kLoop_0 + 9, kLoop_0 + 12, kLoop_0 + 21, 7u, 0u, false},
    {kLoopNames[1], 8, 4, kLoop_1, kLoop_1 + 9, kLoop_1 + 12, kLoop_1 + 21, 7u, 0u, false},
} };

// As the cost profile default has them.
constexpr adagen::Hop kWindowHop{0, 159, 0.437};
constexpr adagen::Hop kMessageHop{26, 228, 0.644};

}  // namespace

// Compiled for size: it runs once.
[[gnu::cold]] int main(int count, char** words) {
  const adagen::Description<Number> description{
      "ankle", "auto", kProcesses, 1, kNq, kNv, kNtau, kNqdd, kRefine,
      false, kAlone, kBatch, kCertified, false, false, kTolerance, kGravity.data(),
      table(kJoints), table(kLinks), table(kOuterForces), {kLoops.data(), kLoopCount}, {}, {}, table(kMessages), kStages.data(), kWindowHop,
      kMessageHop};
  auto* const solver = new ThisSolver;
  const int status = adagen::program(description, *solver, count, words);
  delete solver;
  return status;
}
#endif  // ADAGEN_NO_MAIN
