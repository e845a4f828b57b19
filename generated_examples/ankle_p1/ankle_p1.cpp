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
[[maybe_unused]] constexpr bool kCertified = false;  // whether the error of each answer is bounded
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
  alignas(kCacheLine) std::array<Value, 273> x{};
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
  // link 2 "shank": force that the reference field takes
  const Real x351 = x32 * 0.7000000000000001;
  w.x[1] = x351;
  const Real x356 = x27 * 3.5 + x36 * 0.7000000000000001;
  w.x[2] = x356;
  const Real x357 = x32 * 3.5;
  w.x[3] = x357;
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
  const Real x530 = cosine[3] * 0.05;
  const Real x531 = sine[3] * 0.05;
  const Real x532 = cosine[2] * x531;
  w.x[4] = x532;
  const Real x533 = sine[2] * 0.06;
  const Real x536 = sine[2] * x531;
  w.x[5] = x536;
  const Real x537 = cosine[2] * 0.06;
  const Real x541 = x155 * 0.15;
  const Real x543 = x144 * 0.15;
  const Real x547 = -0.06 - x543;
  const Real x558 = -0.25 - (cosine[4] * x541 + sine[4] * x547);
  const Real x560 = x532 + x533 + -0.4 - x558;
  const Real x561 = x536 - x537 - (cosine[4] * x547 - sine[4] * x541);
  const Real x562 = x530 - (0.05 - x151 * 0.15);
  const Real x569 = v[2] * sine[3];
  const Real x571 = 0.06 * x569;
  const Real x573 = v[3] * 0.05;
  const Real x574 = 0.06 * (v[2] * cosine[3]);
  const Real x576 = x573 + x574;
  const Real x577 = 0.05 * x569;
  const Real x579 = cosine[3] * x571;
  const Real x583 = sine[3] * x571;
  const Real x585 = x583 + cosine[3] * x576;
  const Real x587 = sine[2] * x577;
  const Real x591 = cosine[2] * x577;
  const Real x593 = v[4] * 0.06;
  const Real x597 = x155 * x593;
  const Real x606 = x152 * x593 - 0.15 * (v[6] + v[4] * x148);
  const Real x609 = x153 * x593 + 0.15 * (v[5] + v[4] * x145);
  const Real x614 = x153 * x609 + x155 * x597 + x152 * x606;
  const Real x619 = x141 * x609 + x144 * x597 + x138 * x606;
  const Real x628 = cosine[4] * x614 - sine[4] * x619;
  const Real x632 = cosine[2] * x585 - x587 - x628;
  const Real x631 = sine[4] * x614 + cosine[4] * x619;
  const Real x633 = sine[2] * x585 + x591 - x631;
  const Real x624 = x148 * x609 + x151 * x597 + x145 * x606;
  const Real x634 = x579 - sine[3] * x576 - x624;
  const Real x644 = v[2] * v[2];
  const Real x646 = v[4] * v[4] + v[5] * v[5] + v[6] * v[6];
  const Real x651 = v[7] * v[7] + x646 + x644 + x80 + 1.0;
  const Real x567 = x561 * x561 + x562 * x562 + x560 * x560;
  const Real x655 = 1e-08 - x567;
  require_more(w, x655, 0.0, kLoopOpen, 8);
  const Real x639 = x632 * x632 + x634 * x634 + x633 * x633;
  const Real x656 = x651 * 1.0000000000000002e-06 - x639;
  require_more(w, x656, 0.0, kLoopTorn, 8);
  const Real x660 = cosine[4] * x152 - sine[4] * x138;
  const Real x663 = sine[4] * x152 + cosine[4] * x138;
  const Real x666 = cosine[2] * x660 + sine[2] * x663;
  const Real x670 = cosine[2] * x663 - sine[2] * x660;
  const Real x673 = cosine[3] * x145 + sine[3] * x666;
  const Real x677 = cosine[3] * x666 - sine[3] * x145;
  const Real x689 = (x78 + x80) * 0.05;
  const Real x691 = x72 - x689;
  const Real x692 = x73 - x412;
  const Real x693 = 2.0 * x70 * 0.05;
  const Real x694 = x89 * 0.06;
  const Real x697 = x693 + x694 - x55;
  const Real x710 = 0.05 * x677;
  w.x[6] = x710;
  const Real x702 = x673 * x691 + x670 * x697 + x677 * x692;
  const Real x711 = x702 - (x181 - x208 * 0.15);
  w.x[7] = x711;
  const Real x715 = cosine[4] * x153 - sine[4] * x141;
  const Real x718 = sine[4] * x153 + cosine[4] * x141;
  const Real x721 = cosine[2] * x715 + sine[2] * x718;
  const Real x725 = cosine[2] * x718 - sine[2] * x715;
  const Real x728 = cosine[3] * x148 + sine[3] * x721;
  const Real x732 = cosine[3] * x721 - sine[3] * x148;
  const Real x746 = 0.05 * x732;
  w.x[8] = x746;
  const Real x738 = x691 * x728 + x697 * x725 + x692 * x732;
  const Real x747 = x738 - (x184 - x202 * 0.15);
  w.x[9] = x747;
  const Real x751 = cosine[4] * x155 - sine[4] * x144;
  const Real x754 = sine[4] * x155 + cosine[4] * x144;
  const Real x757 = cosine[2] * x751 + sine[2] * x754;
  const Real x761 = cosine[2] * x754 - sine[2] * x751;
  const Real x764 = cosine[3] * x151 + sine[3] * x757;
  const Real x768 = cosine[3] * x757 - sine[3] * x151;
  const Real x782 = 0.05 * x768;
  w.x[10] = x782;
  const Real x774 = x691 * x764 + x697 * x761 + x692 * x768;
  const Real x783 = x774 - (x187 + x204 * 0.15);
  w.x[11] = x783;
  // what a loop holds its two links by
  const Real x794 = x272 * 0.23;
  const Real x800 = -0.06 - x261 * 0.23;
  const Real x811 = -0.17 - (cosine[5] * x794 + sine[5] * x800);
  const Real x813 = x533 - x532 + -0.4 - x811;
  const Real x814 = x536 + x537 + (cosine[5] * x800 - sine[5] * x794);
  const Real x816 = -0.05 - x268 * 0.23 + x530;
  const Real x826 = x574 - x573;
  const Real x831 = x583 + cosine[3] * x826;
  const Real x837 = 0.06 * v[8];
  const Real x841 = x272 * x837;
  const Real x850 = x269 * x837 - 0.23 * (v[10] + v[8] * x265);
  const Real x853 = x270 * x837 + 0.23 * (v[9] + v[8] * x262);
  const Real x858 = x270 * x853 + x272 * x841 + x269 * x850;
  const Real x863 = x258 * x853 + x261 * x841 + x255 * x850;
  const Real x872 = cosine[5] * x858 - sine[5] * x863;
  const Real x876 = x587 + cosine[2] * x831 - x872;
  const Real x875 = sine[5] * x858 + cosine[5] * x863;
  const Real x877 = sine[2] * x831 - x591 - x875;
  const Real x868 = x265 * x853 + x268 * x841 + x262 * x850;
  const Real x878 = x579 - sine[3] * x826 - x868;
  const Real x889 = v[8] * v[8] + v[9] * v[9] + v[10] * v[10];
  const Real x893 = v[11] * v[11] + x889 + x644 + x80 + 1.0;
  const Real x824 = x814 * x814 + x816 * x816 + x813 * x813;
  const Real x895 = 1e-08 - x824;
  require_more(w, x895, 0.0, kLoopOpen, 9);
  const Real x883 = x876 * x876 + x878 * x878 + x877 * x877;
  const Real x896 = 1.0000000000000002e-06 * x893 - x883;
  require_more(w, x896, 0.0, kLoopTorn, 9);
  const Real x900 = cosine[5] * x269 - sine[5] * x255;
  const Real x903 = sine[5] * x269 + cosine[5] * x255;
  const Real x906 = cosine[2] * x900 + sine[2] * x903;
  const Real x910 = cosine[2] * x903 - sine[2] * x900;
  const Real x913 = cosine[3] * x262 + sine[3] * x906;
  const Real x917 = cosine[3] * x906 - sine[3] * x262;
  const Real x928 = x72 + x689;
  const Real x929 = x73 + x412;
  const Real x932 = x694 - x693 - x55;
  const Real x945 = 0.05 * x917;
  w.x[12] = x945;
  const Real x937 = x913 * x928 + x910 * x932 + x917 * x929;
  const Real x947 = x937 - (x296 - x323 * 0.23);
  w.x[13] = x947;
  const Real x951 = cosine[5] * x270 - sine[5] * x258;
  const Real x954 = sine[5] * x270 + cosine[5] * x258;
  const Real x957 = cosine[2] * x951 + sine[2] * x954;
  const Real x961 = cosine[2] * x954 - sine[2] * x951;
  const Real x964 = cosine[3] * x265 + sine[3] * x957;
  const Real x968 = cosine[3] * x957 - sine[3] * x265;
  const Real x982 = 0.05 * x968;
  w.x[14] = x982;
  const Real x974 = x928 * x964 + x932 * x961 + x929 * x968;
  const Real x984 = x974 - (x299 - x317 * 0.23);
  w.x[15] = x984;
  const Real x988 = cosine[5] * x272 - sine[5] * x261;
  const Real x991 = sine[5] * x272 + cosine[5] * x261;
  const Real x994 = cosine[2] * x988 + sine[2] * x991;
  const Real x998 = cosine[2] * x991 - sine[2] * x988;
  const Real x1001 = cosine[3] * x268 + sine[3] * x994;
  const Real x1005 = cosine[3] * x994 - sine[3] * x268;
  const Real x1019 = 0.05 * x1005;
  w.x[16] = x1019;
  const Real x1011 = x928 * x1001 + x932 * x998 + x929 * x1005;
  const Real x1021 = x1011 - (x302 + x319 * 0.23);
  w.x[17] = x1021;
  // joint 7 "right_ball": inertia and bias force of what is beyond, its own motion left open
  const Real x1025 = x512 - tau[9];
  w.x[18] = x1025;
  const Real x1026 = x515 - tau[10];
  w.x[19] = x1026;
  const Real x1027 = x508 - tau[11];
  w.x[20] = x1027;
  const Real x1030 = x262 * 0.00264635;
  const Real x1031 = x270 * 0.01725;
  const Real x1032 = x258 * 0.01725;
  const Real x1033 = x265 * 0.01725;
  const Real x1039 = x1030 + 0.06 * x1031;
  w.x[21] = x1039;
  const Real x1042 = x265 * 0.00264635;
  const Real x1043 = x269 * 0.01725;
  const Real x1045 = x255 * 0.01725;
  const Real x1047 = x262 * 0.01725;
  const Real x1054 = x1042 - 0.06 * x1043;
  w.x[22] = x1054;
  const Real x1057 = x268 * 2.7e-06;
  w.x[23] = x1057;
  const Real x1069 = x265 * 0.23 - 0.06 * x269;
  w.x[24] = x1069;
  const Real x1084 = x262 * 0.23 + 0.06 * x270;
  w.x[25] = x1084;
  const Real x1091 = 0.06 * x272;
  w.x[26] = x1091;
  const Real x1123 = x270 * x1047 - x269 * x1033;
  const Real x1162 = x269 * 0.15;
  const Real x1163 = x270 * 0.15;
  const Real x1164 = x272 * 0.15;
  const Real x1175 = x269 * x1162 + x270 * x1163 + x272 * x1164;
  const Real x1180 = x255 * x1162 + x258 * x1163 + x261 * x1164;
  const Real x1189 = x258 * (x258 * 0.15) + x261 * (x261 * 0.15);
  const Real x1206 = x1123 + 0.06 * x1175;
  const Real x1212 = x258 * x1047 - x255 * x1033 + 0.06 * x1180;
  const Real x1161 = x262 * x1030 + x268 * x1057 + x265 * x1042;
  const Real x1260 = x269 * x519 + x270 * x523 + x272 * x527;
  const Real x1255 = x262 * x512 + x268 * x508 + x265 * x515;
  const Real x1280 = x1161 + 0.06 * x1123 + 0.06 * x1206 + 0.0002466667;
  w.x[27] = x1280;
  const Real x1281 = 0.006 + x1206;
  const Real x1282 = 0.2 + x1175;
  const Real x1283 = x255 * (x255 * 0.15) + x1189 + 0.2;
  const Real x1285 = x1255 + 0.06 * x1260 + x224 * 0.006;
  const Real x1286 = x224 * 0.2 + x1260;
  const Real x1265 = x255 * x519 + x258 * x523 + x261 * x527;
  const Real x1287 = x231 * 0.006 - x229 * 0.2 + x1265;
  // joint 6 "right_motor": inertia and bias force of what is beyond, its own motion left open
  const Real x1289 = x1285 - tau[8];
  w.x[28] = x1289;
  const Real x1300 = cosine[5] * x1281 - sine[5] * x1212;
  w.x[29] = x1300;
  const Real x1303 = sine[5] * x1281 + cosine[5] * x1212;
  w.x[30] = x1303;
  const Real x1315 = x1280 - 0.17 * x1303;
  w.x[31] = x1315;
  const Real x1326 = cosine[5] * x1031 - sine[5] * x1032;
  w.x[32] = x1326;
  const Real x1329 = sine[5] * x1031 + cosine[5] * x1032;
  w.x[33] = x1329;
  const Real x1341 = x1039 - 0.17 * x1329;
  w.x[34] = x1341;
  const Real x1353 = sine[5] * x1045 - cosine[5] * x1043;
  w.x[35] = x1353;
  const Real x1358 = sine[5] * x1043 + cosine[5] * x1045;
  w.x[36] = x1358;
  const Real x1371 = x1054 + 0.17 * x1358;
  w.x[37] = x1371;
  const Real x1491 = cosine[5] * (x1282 - x1283) - x1180 * (2.0 * sine[5]);
  const Real x1494 = x1180 + sine[5] * x1491;
  const Real x1495 = cosine[5] * x1491;
  const Real x1497 = x1282 - x1495;
  const Real x1519 = x1303 - 0.17 * x1497;
  const Real x1579 = sine[5] * x1286 + cosine[5] * x1287;
  // joint 5 "left_ball": inertia and bias force of what is beyond, its own motion left open
  const Real x1595 = x467 - tau[5];
  w.x[38] = x1595;
  const Real x1596 = x470 - tau[6];
  w.x[39] = x1596;
  const Real x1597 = x463 - tau[7];
  w.x[40] = x1597;
  const Real x1600 = x145 * 0.00112635;
  const Real x1601 = x153 * 0.01125;
  const Real x1602 = x141 * 0.01125;
  const Real x1603 = x148 * 0.01125;
  const Real x1609 = x1600 + 0.06 * x1601;
  w.x[41] = x1609;
  const Real x1612 = x148 * 0.00112635;
  const Real x1613 = x152 * 0.01125;
  const Real x1615 = x138 * 0.01125;
  const Real x1617 = x145 * 0.01125;
  const Real x1624 = x1612 - 0.06 * x1613;
  w.x[42] = x1624;
  const Real x1627 = x151 * 2.7e-06;
  w.x[43] = x1627;
  const Real x1628 = x153 * 0.15;
  const Real x1639 = x148 * 0.15 - x152 * 0.06;
  w.x[44] = x1639;
  const Real x1640 = x152 * 0.15;
  const Real x1654 = x145 * 0.15 + x153 * 0.06;
  w.x[45] = x1654;
  const Real x1661 = x155 * 0.06;
  w.x[46] = x1661;
  const Real x1693 = x153 * x1617 - x152 * x1603;
  const Real x1736 = x152 * x1640 + x153 * x1628 + x155 * x541;
  const Real x1741 = x138 * x1640 + x141 * x1628 + x144 * x541;
  const Real x1750 = x141 * (x141 * 0.15) + x144 * x543;
  const Real x1767 = x1693 + 0.06 * x1736;
  const Real x1773 = x141 * x1617 - x138 * x1603 + 0.06 * x1741;
  const Real x1731 = x145 * x1600 + x151 * x1627 + x148 * x1612;
  const Real x1821 = x152 * x474 + x153 * x478 + x155 * x482;
  const Real x1816 = x145 * x467 + x151 * x463 + x148 * x470;
  const Real x1841 = x1731 + 0.06 * x1693 + 0.06 * x1767 + 0.0002466667;
  w.x[47] = x1841;
  const Real x1842 = 0.006 + x1767;
  const Real x1843 = 0.2 + x1736;
  const Real x1844 = x138 * (x138 * 0.15) + x1750 + 0.2;
  const Real x1846 = x1816 + 0.06 * x1821 + x107 * 0.006;
  const Real x1847 = x107 * 0.2 + x1821;
  const Real x1826 = x138 * x474 + x141 * x478 + x144 * x482;
  const Real x1848 = x114 * 0.006 - x112 * 0.2 + x1826;
  // joint 4 "left_motor": inertia and bias force of what is beyond, its own motion left open
  const Real x1850 = x1846 - tau[4];
  w.x[48] = x1850;
  const Real x1861 = cosine[4] * x1842 - sine[4] * x1773;
  w.x[49] = x1861;
  const Real x1864 = sine[4] * x1842 + cosine[4] * x1773;
  w.x[50] = x1864;
  const Real x1875 = x1841 - 0.25 * x1864;
  w.x[51] = x1875;
  const Real x1886 = cosine[4] * x1601 - sine[4] * x1602;
  w.x[52] = x1886;
  const Real x1889 = sine[4] * x1601 + cosine[4] * x1602;
  w.x[53] = x1889;
  const Real x1900 = x1609 - 0.25 * x1889;
  w.x[54] = x1900;
  const Real x1912 = sine[4] * x1615 - cosine[4] * x1613;
  w.x[55] = x1912;
  const Real x1917 = sine[4] * x1613 + cosine[4] * x1615;
  w.x[56] = x1917;
  const Real x1929 = x1624 + 0.25 * x1917;
  w.x[57] = x1929;
  const Real x2050 = cosine[4] * (x1843 - x1844) - x1741 * (2.0 * sine[4]);
  const Real x2053 = x1741 + sine[4] * x2050;
  const Real x2054 = cosine[4] * x2050;
  const Real x2056 = x1843 - x2054;
  const Real x2077 = x1864 - 0.25 * x2056;
  const Real x2134 = sine[4] * x1847 + cosine[4] * x1848;
  const Real x2162 = x1494 + x2053;
  w.x[58] = x2162;
  // joint 6 "right_motor": inertia and bias force of what is beyond, its own motion left open
  const Real x1576 = cosine[5] * x1286 - sine[5] * x1287;
  // joint 4 "left_motor": inertia and bias force of what is beyond, its own motion left open
  const Real x2170 = cosine[4] * x1847 - sine[4] * x1848 + x1576;
  w.x[59] = x2170;
  const Real x2171 = x1579 + x2134;
  w.x[60] = x2171;
  // joint 3 "ankle_roll": inertia and bias force of what is beyond, its own motion left open
  const Real x2174 = x83 * 0.0019583400000000003 + x72 * 0.05 - tau[3];
  w.x[61] = x2174;
  const Real x2175 = sine[3] * 0.002;
  w.x[62] = x2175;
  const Real x2179 = sine[3] * (0.06 * x673 + 0.05 * x670);
  const Real x2181 = cosine[3] * (0.06 * x677) + x2179;
  w.x[63] = x2181;
  const Real x2194 = sine[3] * (0.06 * x728 + 0.05 * x725);
  const Real x2196 = cosine[3] * (0.06 * x732) + x2194;
  w.x[64] = x2196;
  const Real x2209 = sine[3] * (0.06 * x764 + 0.05 * x761);
  const Real x2211 = cosine[3] * (0.06 * x768) + x2209;
  w.x[65] = x2211;
  const Real x2224 = sine[3] * (0.05 * x910 - 0.06 * x913);
  const Real x2226 = cosine[3] * (0.06 * x917) - x2224;
  w.x[66] = x2226;
  const Real x2238 = sine[3] * (0.05 * x961 - 0.06 * x964);
  const Real x2240 = cosine[3] * (0.06 * x968) - x2238;
  w.x[67] = x2240;
  const Real x2252 = sine[3] * (0.05 * x998 - 0.06 * x1001);
  const Real x2254 = cosine[3] * (0.06 * x1005) - x2252;
  w.x[68] = x2254;
  const Real x2273 = cosine[3] * (x405 - x73 * 0.04);
  const Real x2276 = x2273 - sine[3] * (x395 + x72 * 0.04);
  const Real x2285 = cosine[3] * (x73 + x85 * 0.05);
  const Real x2289 = 0.00630833 + cosine[3] * (cosine[3] * 0.0019583400000000003) + 2.4e-05;
  w.x[69] = x2289;
  const Real x2291 = sine[3] * (x72 + x412) + x2285 + x50 * 0.15;
  // link 4 "foot": force that the reference field takes
  const Real x423 = 2.0 * x68 * 0.05 - x89 * 0.04 - x55;
  // joint 3 "ankle_roll": inertia and bias force of what is beyond, its own motion left open
  const Real x2292 = x423 - x55 * 0.15;
  // joint 2 "ankle_pitch": inertia and bias force of what is beyond, its own motion left open
  const Real x2294 = x2276 - tau[2];
  w.x[70] = x2294;
  const Real x2307 = sine[2] * x530 - cosine[2] * 0.04;
  w.x[71] = x2307;
  const Real x2312 = sine[2] * 0.04 + cosine[2] * x530;
  w.x[72] = x2312;
  const Real x2316 = x2289 + 0.4 * x2312;
  w.x[73] = x2316;
  const Real x2329 = x2175 + 0.4 * x536;
  w.x[74] = x2329;
  const Real x2505 = -0.46 - x2312;
  const Real x2531 = cosine[2] * x2291 - sine[2] * x2292;
  w.x[75] = x2531;
  const Real x2534 = sine[2] * x2291 + cosine[2] * x2292;
  w.x[76] = x2534;
  // joint 4 "left_motor": inertia and bias force of what is beyond, its own motion left open
  const Real x2157 = x1315 - 0.17 * x1519 + (x1875 - 0.25 * x2077);
  // joint 2 "ankle_pitch": inertia and bias force of what is beyond, its own motion left open
  const Real x2550 = x2316 - 0.4 * x2505 + x2157;
  w.x[77] = x2550;
  // joint 4 "left_motor": inertia and bias force of what is beyond, its own motion left open
  const Real x2158 = x1300 - 0.17 * x1494 + (x1861 - 0.25 * x2053);
  // joint 2 "ankle_pitch": inertia and bias force of what is beyond, its own motion left open
  const Real x2551 = x2158 + x2307;
  w.x[78] = x2551;
  const Real x2552 = x1519 + x2077 + x2505;
  w.x[79] = x2552;
  const Real x2553 = x1283 + x1495 + (x1844 + x2054) + 1.15;
  w.x[80] = x2553;
  const Real x2554 = x1497 + x2056 + 1.15;
  w.x[81] = x2554;
  // joint 4 "left_motor": inertia and bias force of what is beyond, its own motion left open
  const Real x2169 = x1285 - 0.17 * x1579 + (x1846 - 0.25 * x2134);
  // joint 2 "ankle_pitch": inertia and bias force of what is beyond, its own motion left open
  const Real x2558 = x2276 - 0.4 * x2534 + x2169;
  w.x[82] = x2558;
}

ADAGEN_NOINLINE void part_0_1(Workspace& w) {
  ADAGEN_INPUTS
  const Real x334 = w.x[0];
  const Real x351 = w.x[1];
  const Real x356 = w.x[2];
  const Real x357 = w.x[3];
  const Real x532 = w.x[4];
  const Real x536 = w.x[5];
  const Real x710 = w.x[6];
  const Real x711 = w.x[7];
  const Real x746 = w.x[8];
  const Real x747 = w.x[9];
  const Real x782 = w.x[10];
  const Real x783 = w.x[11];
  const Real x945 = w.x[12];
  const Real x947 = w.x[13];
  const Real x982 = w.x[14];
  const Real x984 = w.x[15];
  const Real x1019 = w.x[16];
  const Real x1021 = w.x[17];
  const Real x1025 = w.x[18];
  const Real x1026 = w.x[19];
  const Real x1027 = w.x[20];
  const Real x1039 = w.x[21];
  const Real x1054 = w.x[22];
  const Real x1057 = w.x[23];
  const Real x1069 = w.x[24];
  const Real x1084 = w.x[25];
  const Real x1091 = w.x[26];
  const Real x1280 = w.x[27];
  const Real x1289 = w.x[28];
  const Real x1300 = w.x[29];
  const Real x1303 = w.x[30];
  const Real x1315 = w.x[31];
  const Real x1326 = w.x[32];
  const Real x1329 = w.x[33];
  const Real x1341 = w.x[34];
  const Real x1353 = w.x[35];
  const Real x1358 = w.x[36];
  const Real x1371 = w.x[37];
  const Real x1595 = w.x[38];
  const Real x1596 = w.x[39];
  const Real x1597 = w.x[40];
  const Real x1609 = w.x[41];
  const Real x1624 = w.x[42];
  const Real x1627 = w.x[43];
  const Real x1639 = w.x[44];
  const Real x1654 = w.x[45];
  const Real x1661 = w.x[46];
  const Real x1841 = w.x[47];
  const Real x1850 = w.x[48];
  const Real x1861 = w.x[49];
  const Real x1864 = w.x[50];
  const Real x1875 = w.x[51];
  const Real x1886 = w.x[52];
  const Real x1889 = w.x[53];
  const Real x1900 = w.x[54];
  const Real x1912 = w.x[55];
  const Real x1917 = w.x[56];
  const Real x1929 = w.x[57];
  const Real x2162 = w.x[58];
  const Real x2170 = w.x[59];
  const Real x2171 = w.x[60];
  const Real x2174 = w.x[61];
  const Real x2175 = w.x[62];
  const Real x2181 = w.x[63];
  const Real x2196 = w.x[64];
  const Real x2211 = w.x[65];
  const Real x2226 = w.x[66];
  const Real x2240 = w.x[67];
  const Real x2254 = w.x[68];
  const Real x2289 = w.x[69];
  const Real x2294 = w.x[70];
  const Real x2307 = w.x[71];
  const Real x2312 = w.x[72];
  const Real x2316 = w.x[73];
  const Real x2329 = w.x[74];
  const Real x2531 = w.x[75];
  const Real x2534 = w.x[76];
  const Real x2550 = w.x[77];
  const Real x2551 = w.x[78];
  const Real x2552 = w.x[79];
  const Real x2553 = w.x[80];
  const Real x2554 = w.x[81];
  const Real x2558 = w.x[82];
  // link 2 "shank": accelerations and constraint forces of loops below it are eliminated
  const Real x2565 = x1639 * 8.0;
  const Real x2567 = x1654 * 8.0;
  const Real x2570 = x1661 * 16.0;
  const Real x2572 = x1069 * 4.0;
  const Real x2574 = x1084 * 4.0;
  const Real x2577 = x1091 * 16.0;
  const Real x2579 = x2181 * 8.0;
  const Real x2580 = x710 * 8.0;
  const Real x2581 = x711 * 8.0;
  const Real x2582 = x2196 * 8.0;
  const Real x2583 = x746 * 8.0;
  const Real x2584 = x747 * 8.0;
  const Real x2585 = x2211 * 16.0;
  const Real x2586 = x782 * 16.0;
  const Real x2587 = x783 * 16.0;
  const Real x2588 = x2226 * 4.0;
  const Real x2589 = x945 * 4.0;
  const Real x2591 = x947 * 4.0;
  const Real x2592 = x2240 * 4.0;
  const Real x2593 = x982 * 4.0;
  const Real x2595 = x984 * 4.0;
  const Real x2596 = x2254 * 16.0;
  const Real x2597 = x1019 * 16.0;
  const Real x2599 = x1021 * 16.0;
  const Real x2606 = x2567 * x2567 + x2570 * x2570;
  const Real x2609 = sign_of(x2565) * sqrt_of(x2565 * x2565 + x2606);
  const Real x2610 = x2565 + x2609;
  const Real x2612 = x2606 + x2610 * x2610;
  const Real x2614 = 2.0 * (1 / x2612);
  const Real x2617 = x2614 * (1.2 * x2567);
  const Real x2618 = x2610 * x2617;
  const Real x2621 = x2570 * x2617;
  const Real x2624 = -1.2 + x2567 * x2617;
  const Real x2626 = x2614 * (1.2 * x2610);
  const Real x2628 = x2567 * x2626;
  const Real x2630 = x2570 * x2626;
  const Real x2632 = 1.2 - x2610 * x2626;
  const Real x2640 = x2579 * x2610 - (x2567 * x2582 + x2570 * x2585);
  const Real x2641 = x2614 * x2640;
  const Real x2648 = x2582 + x2567 * x2641;
  const Real x2649 = x2585 + x2570 * x2641;
  const Real x2657 = x2580 * x2610 - (x2567 * x2583 + x2570 * x2586);
  const Real x2658 = x2614 * x2657;
  const Real x2665 = x2583 + x2567 * x2658;
  const Real x2666 = x2586 + x2570 * x2658;
  const Real x2673 = x2581 * x2610 - x2567 * x2584 - x2570 * x2587;
  const Real x2674 = x2614 * x2673;
  const Real x2681 = x2584 + x2567 * x2674;
  const Real x2682 = x2587 + x2570 * x2674;
  const Real x2686 = x2621 * x2621;
  const Real x2689 = sign_of(x2624) * sqrt_of(x2624 * x2624 + x2686);
  const Real x2690 = x2624 + x2689;
  const Real x2692 = x2686 + x2690 * x2690;
  const Real x2694 = 2.0 * (1 / x2692);
  const Real x2698 = x2694 * (x2628 * x2690 + x2621 * x2630);
  const Real x2701 = x2628 - x2690 * x2698;
  const Real x2702 = x2630 - x2621 * x2698;
  const Real x2706 = x2694 * (x2648 * x2690 + x2621 * x2649);
  const Real x2714 = x2694 * (x2665 * x2690 + x2621 * x2666);
  const Real x2722 = x2694 * (x2681 * x2690 + x2621 * x2682);
  const Real x2734 = x2574 * x2574 + x2577 * x2577;
  const Real x2737 = sign_of(x2572) * sqrt_of(x2572 * x2572 + x2734);
  const Real x2738 = x2572 + x2737;
  const Real x2740 = x2734 + x2738 * x2738;
  const Real x2742 = 2.0 * (1 / x2740);
  const Real x2745 = x2742 * (0.92 * x2574);
  const Real x2746 = x2738 * x2745;
  const Real x2749 = x2577 * x2745;
  const Real x2752 = -0.92 + x2574 * x2745;
  const Real x2754 = x2742 * (0.92 * x2738);
  const Real x2756 = x2574 * x2754;
  const Real x2758 = x2577 * x2754;
  const Real x2760 = 0.92 - x2738 * x2754;
  const Real x2768 = x2588 * x2738 - (x2574 * x2592 + x2577 * x2596);
  const Real x2769 = x2742 * x2768;
  const Real x2776 = x2592 + x2574 * x2769;
  const Real x2777 = x2596 + x2577 * x2769;
  const Real x2785 = x2574 * x2593 + x2577 * x2597 - x2589 * x2738;
  const Real x2786 = x2742 * x2785;
  const Real x2794 = x2574 * x2786 - x2593;
  const Real x2795 = x2577 * x2786 - x2597;
  const Real x2802 = x2591 * x2738 - x2574 * x2595 - x2577 * x2599;
  const Real x2803 = x2742 * x2802;
  const Real x2810 = x2595 + x2574 * x2803;
  const Real x2811 = x2599 + x2577 * x2803;
  const Real x2815 = x2749 * x2749;
  const Real x2818 = sign_of(x2752) * sqrt_of(x2752 * x2752 + x2815);
  const Real x2819 = x2752 + x2818;
  const Real x2821 = x2815 + x2819 * x2819;
  const Real x2823 = 2.0 * (1 / x2821);
  const Real x2827 = x2823 * (x2756 * x2819 + x2749 * x2758);
  const Real x2830 = x2756 - x2819 * x2827;
  const Real x2831 = x2758 - x2749 * x2827;
  const Real x2835 = x2823 * (x2776 * x2819 + x2749 * x2777);
  const Real x2843 = x2823 * (x2794 * x2819 + x2749 * x2795);
  const Real x2851 = x2823 * (x2810 * x2819 + x2749 * x2811);
  const Real x2857 = 1 / x2831;
  const Real x2858 = (x2777 - x2749 * x2835) * x2857;
  const Real x2859 = (x2795 - x2749 * x2843) * x2857;
  const Real x2860 = (x2811 - x2749 * x2851) * x2857;
  const Real x2861 = 1 / x2818;
  const Real x2866 = x2861 * (x2776 - x2819 * x2835 - x2830 * x2858);
  const Real x2871 = x2861 * (x2794 - x2819 * x2843 - x2830 * x2859);
  const Real x2876 = x2861 * (x2810 - x2819 * x2851 - x2830 * x2860);
  const Real x2878 = 1 / x2737;
  const Real x2884 = x2588 - x2738 * x2769 - x2760 * x2858;
  const Real x2886 = x2878 * (x2884 - x2746 * x2866);
  const Real x2892 = x2589 + x2738 * x2786 + x2760 * x2859;
  const Real x2896 = x2878 * (x2746 * x2871 + x2892);
  const Real x2902 = x2591 - x2738 * x2803 - x2760 * x2860;
  const Real x2904 = x2878 * (x2902 - x2746 * x2876);
  const Real x2906 = 1 / x2702;
  const Real x2907 = (x2649 - x2621 * x2706) * x2906;
  const Real x2908 = (x2666 - x2621 * x2714) * x2906;
  const Real x2909 = (x2682 - x2621 * x2722) * x2906;
  const Real x2910 = 1 / x2689;
  const Real x2915 = x2910 * (x2648 - x2690 * x2706 - x2701 * x2907);
  const Real x2920 = x2910 * (x2665 - x2690 * x2714 - x2701 * x2908);
  const Real x2925 = x2910 * (x2681 - x2690 * x2722 - x2701 * x2909);
  const Real x2927 = 1 / x2609;
  const Real x2933 = x2579 - x2610 * x2641 - x2632 * x2907;
  const Real x2935 = x2927 * (x2933 - x2618 * x2915);
  const Real x2941 = x2580 - x2610 * x2658 - x2632 * x2908;
  const Real x2943 = x2927 * (x2941 - x2618 * x2920);
  const Real x2949 = x2581 - x2610 * x2674 - x2632 * x2909;
  const Real x2951 = x2927 * (x2949 - x2618 * x2925);
  const Real x2959 = x2609 * x2609;
  require_more(w, x2959, 9.999999999999998e-15, kSingularPose, 8);
  const Real x2962 = x2689 * x2689;
  require_more(w, x2962, 9.999999999999998e-15, kSingularPose, 8);
  const Real x2964 = x2702 * x2702;
  require_more(w, x2964, 9.999999999999998e-15, kSingularPose, 8);
  const Real x2965 = x2737 * x2737;
  require_more(w, x2965, 9.999999999999998e-15, kSingularPose, 9);
  const Real x2967 = x2818 * x2818;
  require_more(w, x2967, 9.999999999999998e-15, kSingularPose, 9);
  const Real x2969 = x2831 * x2831;
  require_more(w, x2969, 9.999999999999998e-15, kSingularPose, 9);
  const Real x2988 = x2907 * x2907 + x2908 * x2908 + x2858 * x2858;
  const Real x2990 = x2859 * x2859 + x2988 + x2915 * x2915;
  const Real x2992 = x2920 * x2920 + x2990 + x2866 * x2866;
  const Real x2994 = x2871 * x2871 + x2992 + x2935 * x2935;
  const Real x2996 = x2943 * x2943 + x2994 + x2886 * x2886;
  const Real x2999 = 40000.0 - (x2896 * x2896 + x2996);
  require_more(w, x2999, 0.0, kSingularPose, 8);
  const Real x3005 = x1609 * x2915 - x1624 * x2907 + x1841 * x2935;
  const Real x3011 = x1609 * x2920 - x1624 * x2908 + x1841 * x2943;
  const Real x3014 = x1609 * x2935 + 0.00112635 * x2915;
  const Real x3017 = x1609 * x2943 + 0.00112635 * x2920;
  const Real x3021 = x1624 * x2935 - 0.00112635 * x2907;
  const Real x3025 = x1624 * x2943 - 0.00112635 * x2908;
  const Real x3031 = x1039 * x2866 - x1054 * x2858 + x1280 * x2886;
  const Real x3038 = x1039 * x2871 - x1054 * x2859 - x1280 * x2896;
  const Real x3041 = x1039 * x2886 + 0.00264635 * x2866;
  const Real x3045 = 0.00264635 * x2871 - x1039 * x2896;
  const Real x3049 = x1054 * x2886 - 0.00264635 * x2858;
  const Real x3054 = x1054 * x2896 + 0.00264635 * x2859;
  const Real x3065 = x2935 * x3005 + x2915 * x3014 - x2907 * x3021;
  const Real x3067 = x2886 * x3031 + x3065 + x2866 * x3041;
  const Real x3078 = x2935 * x3011 + x2915 * x3017 - x2907 * x3025;
  const Real x3080 = x2886 * x3038 + x3078 + x2866 * x3045;
  const Real x3082 = x1627 * x2935;
  const Real x3083 = x1057 * x2886;
  const Real x3108 = x2943 * x3011 + x2920 * x3017 - x2908 * x3025;
  const Real x3110 = x3108 - x2896 * x3038 + x2871 * x3045;
  const Real x3115 = x3067 - x2858 * x3049 + x2289;
  require_more(w, x3115, 0.0, kLoopFree, 2);
  const Real x3117 = x2858 * x3054 + x3080 - x2175;
  const Real x3118 = x2859 * x3054 + x3110 + 0.003308333;
  const Real x3187 = x1900 * x2915 - (x1929 * x2907 + x1371 * x2858);
  const Real x3189 = x1341 * x2866 + x3187 + x1875 * x2935;
  const Real x3202 = x1900 * x2920 - (x1929 * x2908 + x1371 * x2859);
  const Real x3204 = x1341 * x2871 + x3202 + x1875 * x2943;
  const Real x3216 = x1886 * x2915 - (x1912 * x2907 + x1353 * x2858);
  const Real x3218 = x1326 * x2866 + x3216 + x1861 * x2935;
  const Real x3231 = x1886 * x2920 - (x1912 * x2908 + x1353 * x2859);
  const Real x3233 = x1326 * x2871 + x3231 + x1861 * x2943;
  const Real x3244 = x1917 * x2907 + x1358 * x2858 + x1889 * x2915;
  const Real x3246 = x1329 * x2866 + x3244 + x1864 * x2935;
  const Real x3258 = x1917 * x2908 + x1358 * x2859 + x1889 * x2920;
  const Real x3260 = x1329 * x2871 + x3258 + x1864 * x2943;
  const Real x3291 = x1315 * x2886 + x3189 + x2316;
  const Real x3292 = x1300 * x2886 + x3218 + x2307;
  const Real x3293 = x1303 * x2886 + x3246 - x2312;
  const Real x3296 = x3204 - x1315 * x2896 - x2329;
  const Real x3297 = x3233 - x1300 * x2896 + x532;
  const Real x3298 = x3260 - x1303 * x2896 + x536;
  const Real x3310 = x1595 * x2915 - (x1596 * x2907 + x1026 * x2858);
  const Real x3312 = x1025 * x2866 + x3310 + x1850 * x2935;
  const Real x3325 = x1595 * x2920 - (x1596 * x2908 + x1026 * x2859);
  const Real x3327 = x1025 * x2871 + x3325 + x1850 * x2943;
  const Real x3340 = x2951 * x3005 + x2925 * x3014 - x2909 * x3021;
  const Real x3342 = x2904 * x3031 + x3340 + x2876 * x3041;
  const Real x3353 = x2951 * x3011 + x2925 * x3017 - x2909 * x3025;
  const Real x3355 = x2904 * x3038 + x3353 + x2876 * x3045;
  const Real x3329 = x1289 * x2886 + x3312 + x2294;
  const Real x3359 = x3342 - x2860 * x3049 + x3329;
  const Real x3330 = x3327 - x1289 * x2896 + x2174;
  const Real x3401 = x1900 * x2925 - (x1929 * x2909 + x1371 * x2860);
  const Real x3403 = x1341 * x2876 + x3401 + x1875 * x2951;
  const Real x3415 = x1886 * x2925 - (x1912 * x2909 + x1353 * x2860);
  const Real x3417 = x1326 * x2876 + x3415 + x1861 * x2951;
  const Real x3428 = x1917 * x2909 + x1358 * x2860 + x1889 * x2925;
  const Real x3430 = x1329 * x2876 + x3428 + x1864 * x2951;
  const Real x3451 = 1 / x3115;
  const Real x3452 = x3117 * x3451;
  const Real x3453 = x3082 * x3451;
  const Real x3454 = x3083 * x3451;
  const Real x3457 = x3118 - x3117 * x3452;
  const Real x3460 = x1627 * x2943 - x3082 * x3452;
  const Real x3463 = x1057 * x2896 + x3083 * x3452;
  const Real x3465 = 1 / x3457;
  const Real x3466 = x3460 * x3465;
  const Real x3467 = x3463 * x3465;
  const Real x3474 = 2.7e-06 - x3082 * x3453 - x3460 * x3466;
  require_more(w, x3474, 4.796163466380676e-21, kLoopFree, 5);
  const Real x3479 = x3463 * x3466 - x3083 * x3453;
  const Real x3480 = 1 / x3474;
  const Real x3481 = x3479 * x3480;
  const Real x3489 = 2.7e-06 - x3083 * x3454 - x3463 * x3467;
  const Real x3490 = x3489 - x3479 * x3481;
  require_more(w, x3490, 4.796163466380676e-21, kLoopFree, 7);
  const Real x3491 = 1 / x3490;
  const Real x3493 = x3118 * 1.7763568394002505e-15;
  require_more(w, x3457, x3493, kLoopFree, 3);
  const Real x3503 = x3296 - x3291 * x3452;
  const Real x3506 = x3297 - x3292 * x3452;
  const Real x3509 = x3298 - x3293 * x3452;
  const Real x3515 = x2860 * x3054 + x3355 + x3330 - x3359 * x3452;
  const Real x3533 = x1627 - x3291 * x3453 - x3466 * x3503;
  const Real x3538 = x3292 * x3453 + x3466 * x3506;
  const Real x3544 = x3293 * x3453 + x3466 * x3509;
  const Real x3556 = x1597 + x1627 * x2951 - x3359 * x3453;
  const Real x3557 = x3556 - x3466 * x3515;
  const Real x3583 = x1057 - x3291 * x3454 + x3467 * x3503;
  const Real x3615 = x1027 + x1057 * x2904 - x3359 * x3454;
  const Real x3644 = x3491 * (x3583 - x3481 * x3533);
  const Real x3592 = x3467 * x3506 - x3292 * x3454 + x3481 * x3538;
  const Real x3645 = x3491 * x3592;
  const Real x3600 = x3467 * x3509 - x3293 * x3454 + x3481 * x3544;
  const Real x3646 = x3491 * x3600;
  const Real x3648 = x3491 * (x3467 * x3515 + x3615 - x3481 * x3557);
  const Real x3657 = x3480 * x3533 - x3481 * x3644;
  const Real x3660 = x3480 * x3538 + x3481 * x3645;
  const Real x3664 = x3480 * x3544 + x3481 * x3646;
  const Real x3672 = x3480 * x3557 - x3481 * x3648;
  const Real x3690 = x3465 * x3503 + x3467 * x3644 - x3466 * x3657;
  const Real x3696 = x3465 * x3506 + x3467 * x3645 + x3466 * x3660;
  const Real x3702 = x3465 * x3509 + x3467 * x3646 + x3466 * x3664;
  const Real x3714 = x3465 * x3515 + x3467 * x3648 - x3466 * x3672;
  const Real x3740 = x3291 * x3451 - x3454 * x3644 - x3453 * x3657;
  const Real x3741 = x3740 - x3452 * x3690;
  const Real x3749 = x3292 * x3451 - x3454 * x3645 + x3453 * x3660;
  const Real x3750 = x3749 - x3452 * x3696;
  const Real x3758 = x3293 * x3451 - x3454 * x3646 + x3453 * x3664;
  const Real x3759 = x3758 - x3452 * x3702;
  const Real x3776 = x3359 * x3451 - x3454 * x3648 - x3453 * x3672;
  const Real x3777 = x3776 - x3452 * x3714;
  const Real x3902 = x1627 * x3657 + x1057 * x3644 + x3296 * x3690;
  const Real x3911 = x1057 * x3645 - x1627 * x3660 + x3296 * x3696;
  const Real x3920 = x1057 * x3646 - x1627 * x3664 + x3296 * x3702;
  const Real x3968 = x2551 - (x3291 * x3750 + x3911);
  const Real x3996 = x1627 * x3672 + x1057 * x3648 + x3296 * x3714;
  const Real x3447 = x1315 * x2904 + x3403 + x2558;
  const Real x3448 = x2170 + x2531 + (x1300 * x2904 + x3417);
  const Real x3449 = x2171 + x2534 + (x1303 * x2904 + x3430);
  const Real x4022 = x2550 - (x3291 * x3741 + x3902) + 0.18885420000000003;
  require_more(w, x4022, 0.0, kFactorization, 1);
  const Real x4023 = x2552 - (x3291 * x3759 + x3920) + -0.7000000000000001;
  // joint 1 "knee": articulated-body inertia and bias force through it
  const Real x4031 = 1 / x4022;
  const Real x4032 = tau[1] - (x3447 - (x3291 * x3777 + x3996) + x351);
  const Real x4033 = x4031 * x4032;
  const Real x4036 = x3968 * x4031;
  const Real x4037 = x4023 * x4031;
  // link 2 "shank": accelerations and constraint forces of loops below it are eliminated
  const Real x4024 = x2553 - (x3292 * x3750 + x3297 * x3696) + 3.5;
  // joint 1 "knee": articulated-body inertia and bias force through it
  const Real x4068 = x4024 - x3968 * x4036;
  // link 2 "shank": accelerations and constraint forces of loops below it are eliminated
  const Real x3972 = x2162 - (x3292 * x3759 + x3297 * x3702);
  const Real x4025 = x2554 - (x3293 * x3759 + x3298 * x3702) + 3.5;
  const Real x4028 = x3448 - (x3292 * x3777 + x3297 * x3714) + x356;
  const Real x4029 = x3449 - (x3293 * x3777 + x3298 * x3714) - x357;
  // joint 1 "knee": articulated-body inertia and bias force through it
  const Real x4135 = cosine[1] * (x4068 - (x4025 - x4023 * x4037));
  const Real x4138 = x4135 - (x3972 - x3968 * x4037) * (sine[1] * 2.0);
  const Real x4184 = sine[1] * (x4028 + x3968 * x4033);
  const Real x4190 = 0.4 * (x4184 + cosine[1] * (x4029 + x4023 * x4033));
  const Real x4196 = 0.32735000000000003 + 0.4 * (0.4 * (x4068 - cosine[1] * x4138));
  require_more(w, x4196, 0.0, kFactorization, 0);
  // joint 0 "hip": articulated-body inertia and bias force through it
  const Real x4207 = 1 / x4196 * (tau[0] - (tau[1] - x4190 + x334));
  w.result[0] = x4207;
  // joint 1 "knee": its acceleration, and that of the link beyond
  const Real x4217 = 0.4 * x4207;
  const Real x4219 = sine[1] * x4217;
  const Real x4221 = cosine[1] * x4217;
  const Real x4228 = x4033 + x4036 * x4219 + x4037 * x4221;
  const Real x4229 = x4228 - x4207;
  w.result[1] = x4229;
  // link 2 "shank": accelerations and constraint forces of loops below it
  const Real x4237 = x3750 * x4219 + x3759 * x4221 - x3741 * x4228;
  const Real x4264 = x4237 - x3777;
  w.result[2] = x4264;
  const Real x4245 = x3696 * x4219 + x3702 * x4221 - x3690 * x4228;
  const Real x4265 = x4245 - x3714;
  w.result[3] = x4265;
  const Real x4254 = x3660 * x4219 + x3664 * x4221 + x3657 * x4228;
  const Real x4267 = -(x3672 + x4254);
  w.result[7] = x4267;
  const Real x4263 = x3645 * x4219 + x3646 * x4221 - x3644 * x4228;
  const Real x4268 = x4263 - x3648;
  w.result[11] = x4268;
  const Real x4294 = x2935 * x4264 + x2943 * x4265 + x2951;
  w.result[4] = x4294;
  const Real x4295 = x2915 * x4264 + x2920 * x4265 + x2925;
  w.result[5] = x4295;
  const Real x4297 = -(x2907 * x4264 + x2908 * x4265 + x2909);
  w.result[6] = x4297;
  const Real x4298 = x2886 * x4264 - x2896 * x4265 + x2904;
  w.result[8] = x4298;
  const Real x4299 = x2866 * x4264 + x2871 * x4265 + x2876;
  w.result[9] = x4299;
  const Real x4301 = -(x2858 * x4264 + x2859 * x4265 + x2860);
  w.result[10] = x4301;
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
  const Real x593 = v[4] * 0.06;
  w.x[12] = x593;
  const Real x573 = v[3] * 0.05;
  w.x[13] = x573;
  const Real x644 = v[2] * v[2];
  const Real x646 = v[4] * v[4] + v[5] * v[5] + v[6] * v[6];
  const Real x651 = v[7] * v[7] + x646 + x644 + x80 + 1.0;
  const Real x654 = x651 * 1.0000000000000002e-06;
  w.x[14] = x654;
  // what a loop holds its two links by
  const Real x837 = 0.06 * v[8];
  w.x[15] = x837;
  const Real x889 = v[8] * v[8] + v[9] * v[9] + v[10] * v[10];
  const Real x893 = v[11] * v[11] + x889 + x644 + x80 + 1.0;
  w.x[16] = x893;
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
  const Real x715 = cosine[4] * x153 - sine[4] * x141;
  const Real x660 = cosine[4] * x152 - sine[4] * x138;
  const Real x663 = sine[4] * x152 + cosine[4] * x138;
  const Real x718 = sine[4] * x153 + cosine[4] * x141;
  const Real x751 = cosine[4] * x155 - sine[4] * x144;
  const Real x666 = cosine[2] * x660 + sine[2] * x663;
  const Real x670 = cosine[2] * x663 - sine[2] * x660;
  const Real x721 = cosine[2] * x715 + sine[2] * x718;
  const Real x725 = cosine[2] * x718 - sine[2] * x715;
  const Real x754 = sine[4] * x155 + cosine[4] * x144;
  const Real x673 = cosine[3] * x145 + sine[3] * x666;
  const Real x677 = cosine[3] * x666 - sine[3] * x145;
  const Real x728 = cosine[3] * x148 + sine[3] * x721;
  const Real x732 = cosine[3] * x721 - sine[3] * x148;
  const Real x757 = cosine[2] * x751 + sine[2] * x754;
  const Real x761 = cosine[2] * x754 - sine[2] * x751;
  const Real x764 = cosine[3] * x151 + sine[3] * x757;
  const Real x768 = cosine[3] * x757 - sine[3] * x151;
  // what a loop holds its two links by
  const Real x900 = cosine[5] * x269 - sine[5] * x255;
  const Real x903 = sine[5] * x269 + cosine[5] * x255;
  // joint 3 "ankle_roll": inertia and bias force of what is beyond, its own motion left open
  const Real x2179 = sine[3] * (0.06 * x673 + 0.05 * x670);
  const Real x2194 = sine[3] * (0.06 * x728 + 0.05 * x725);
  // link 2 "shank": accelerations and constraint forces of loops below it are eliminated
  const Real x2567 = (x148 * 0.15 - x152 * 0.06) * 8.0;
  w.x[20] = x2567;
  const Real x2571 = (x145 * 0.15 + x153 * 0.06) * 8.0;
  const Real x2576 = x155 * 0.06 * 16.0;
  const Real x2566 = 0.05 * x677 * 8.0;
  w.x[21] = x2566;
  const Real x2570 = 0.05 * x732 * 8.0;
  const Real x2600 = x2567 * x2567 + 1.44 + x2566 * x2566;
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
  const Real x906 = cosine[2] * x900 + sine[2] * x903;
  const Real x910 = cosine[2] * x903 - sine[2] * x900;
  const Real x913 = cosine[3] * x262 + sine[3] * x906;
  const Real x917 = cosine[3] * x906 - sine[3] * x262;
  const Real x951 = cosine[5] * x270 - sine[5] * x258;
  const Real x954 = sine[5] * x270 + cosine[5] * x258;
  const Real x957 = cosine[2] * x951 + sine[2] * x954;
  const Real x961 = cosine[2] * x954 - sine[2] * x951;
  const Real x988 = cosine[5] * x272 - sine[5] * x261;
  const Real x991 = sine[5] * x272 + cosine[5] * x261;
  const Real x964 = cosine[3] * x265 + sine[3] * x957;
  const Real x968 = cosine[3] * x957 - sine[3] * x265;
  const Real x994 = cosine[2] * x988 + sine[2] * x991;
  const Real x998 = cosine[2] * x991 - sine[2] * x988;
  // joint 3 "ankle_roll": inertia and bias force of what is beyond, its own motion left open
  const Real x2209 = sine[3] * (0.06 * x764 + 0.05 * x761);
  const Real x2224 = sine[3] * (0.05 * x910 - 0.06 * x913);
  // link 2 "shank": accelerations and constraint forces of loops below it are eliminated
  const Real x2575 = 0.05 * x768 * 16.0;
  const Real x2565 = (cosine[3] * (0.06 * x677) + x2179) * 8.0;
  const Real x2569 = (cosine[3] * (0.06 * x732) + x2194) * 8.0;
  const Real x2574 = (cosine[3] * (0.06 * x768) + x2209) * 16.0;
  const Real x2579 = 0.05 * x917 * 4.0;
  const Real x2578 = (cosine[3] * (0.06 * x917) - x2224) * 4.0;
  const Real x2603 = sign_of(x2565) * sqrt_of(x2565 * x2565 + x2600);
  w.x[29] = x2603;
  const Real x2581 = (x265 * 0.23 - 0.06 * x269) * 4.0;
  w.x[30] = x2581;
  const Real x2592 = 0.06 * x272 * 16.0;
  const Real x2586 = (x262 * 0.23 + 0.06 * x270) * 4.0;
  const Real x2604 = x2565 + x2603;
  w.x[31] = x2604;
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
  const Real x693 = 2.0 * x70 * 0.05;
  const Real x694 = x89 * 0.06;
  // what a loop holds its two links by
  const Real x1001 = cosine[3] * x268 + sine[3] * x994;
  const Real x1005 = cosine[3] * x994 - sine[3] * x268;
  // joint 3 "ankle_roll": inertia and bias force of what is beyond, its own motion left open
  const Real x2238 = sine[3] * (0.05 * x961 - 0.06 * x964);
  const Real x2252 = sine[3] * (0.05 * x998 - 0.06 * x1001);
  // link 2 "shank": accelerations and constraint forces of loops below it are eliminated
  const Real x2584 = 0.05 * x968 * 4.0;
  const Real x2836 = x2581 * x2581 + 0.8464;
  const Real x2606 = x2600 + x2604 * x2604;
  const Real x2583 = (cosine[3] * (0.06 * x968) - x2238) * 4.0;
  const Real x2590 = 0.05 * x1005 * 16.0;
  const Real x2608 = 2.0 * (1 / x2606);
  w.x[38] = x2608;
  const Real x2614 = x2566 * x2570 - x2567 * x2571 + x2569 * x2604;
  const Real x2615 = x2608 * x2614;
  const Real x2630 = x2566 * x2575 - x2567 * x2576 + x2574 * x2604;
  const Real x2631 = x2608 * x2630;
  const Real x2645 = x2608 * (x2578 * x2604 - x2566 * x2579);
  const Real x2659 = x2608 * (x2583 * x2604 - x2566 * x2584);
  const Real x2589 = (cosine[3] * (0.06 * x1005) - x2252) * 16.0;
  const Real x2619 = 1.2 * x2615;
  w.x[39] = x2619;
  const Real x2635 = 1.2 * x2631;
  const Real x2648 = x2567 * x2645;
  const Real x2649 = 1.2 * x2645;
  const Real x2621 = x2570 - x2566 * x2615;
  const Real x2622 = x2571 + x2567 * x2615;
  w.x[40] = x2622;
  const Real x2638 = x2576 + x2567 * x2631;
  const Real x2637 = x2575 - x2566 * x2631;
  const Real x2651 = x2579 + x2566 * x2645;
  const Real x2662 = x2567 * x2659;
  const Real x2663 = 1.2 * x2659;
  const Real x2690 = 1.44 + x2619 * x2619;
  const Real x2686 = x2622 * x2622;
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
  const Real x689 = (x78 + x80) * 0.05;
  const Real x691 = x72 - x689;
  const Real x697 = x693 + x694 - x55;
  const Real x692 = x73 - x412;
  const Real x702 = x673 * x691 + x670 * x697 + x677 * x692;
  // link 2 "shank": accelerations and constraint forces of loops below it are eliminated
  const Real x2665 = x2584 + x2566 * x2659;
  const Real x2673 = x2608 * (x2589 * x2604 - x2566 * x2590);
  const Real x2676 = x2567 * x2673;
  const Real x2677 = 1.2 * x2673;
  const Real x2679 = x2590 + x2566 * x2673;
  const Real x2694 = sign_of(x2621) * sqrt_of(x2621 * x2621 + x2690 + x2686);
  w.x[47] = x2694;
  const Real x2695 = x2621 + x2694;
  w.x[48] = x2695;
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
  const Real x738 = x691 * x728 + x697 * x725 + x692 * x732;
  const Real x774 = x691 * x764 + x697 * x761 + x692 * x768;
  // what a loop holds its two links by
  const Real x928 = x72 + x689;
  const Real x932 = x694 - x693 - x55;
  const Real x929 = x73 + x412;
  const Real x937 = x913 * x928 + x910 * x932 + x917 * x929;
  // link 2 "shank": accelerations and constraint forces of loops below it are eliminated
  const Real x2698 = x2686 + x2690 + x2695 * x2695;
  const Real x2953 = (x702 - (x181 - x208 * 0.15)) * 8.0 * (1 / x2603);
  w.x[49] = x2953;
  const Real x2940 = (x738 - (x184 - x202 * 0.15)) * 8.0;
  const Real x2700 = 2.0 * (1 / x2698);
  w.x[50] = x2700;
  const Real x2961 = 1 / x2694 * (x2940 + (x2569 - x2604 * x2615) * x2953);
  w.x[51] = x2961;
  const Real x2707 = x2622 * x2638 + x2619 * x2635 + x2637 * x2695;
  const Real x2708 = x2700 * x2707;
  const Real x2726 = x2622 * x2648 + x2619 * x2649 - x2651 * x2695;
  const Real x2727 = x2700 * x2726;
  const Real x2746 = x2622 * x2662 + x2619 * x2663 - x2665 * x2695;
  const Real x2747 = x2700 * x2746;
  const Real x2766 = x2622 * x2676 + x2619 * x2677 - x2679 * x2695;
  const Real x2767 = x2700 * x2766;
  const Real x2941 = (x774 - (x187 + x204 * 0.15)) * 16.0;
  const Real x2712 = 1.2 * x2708;
  w.x[52] = x2712;
  const Real x2731 = 1.2 * x2727;
  const Real x2751 = 1.2 * x2747;
  const Real x2717 = x2622 * x2708 - x2638;
  const Real x2782 = x2712 * x2712;
  const Real x2718 = x2619 * x2708 - x2635;
  w.x[53] = x2718;
  const Real x2738 = x2619 * x2727 - x2649;
  const Real x2737 = x2622 * x2727 - x2648;
  const Real x2758 = x2619 * x2747 - x2663;
  const Real x2757 = x2622 * x2747 - x2662;
  const Real x2783 = x2718 * x2718;
  const Real x2771 = 1.2 * x2767;
  const Real x2778 = x2619 * x2767 - x2677;
  const Real x2777 = x2622 * x2767 - x2676;
  // joint 7 "right_ball": placement, velocity and reference acceleration of its link
  const Real x302 = x224 * x272 + x261 * x293;
  // what a loop holds its two links by
  const Real x541 = x155 * 0.15;
  w.x[54] = x541;
  // what a loop holds its two links by
  const Real x974 = x928 * x964 + x932 * x961 + x929 * x968;
  const Real x1011 = x928 * x1001 + x932 * x998 + x929 * x1005;
  // joint 7 "right_ball": inertia and bias force of what is beyond, its own motion left open
  const Real x1162 = x269 * 0.15;
  const Real x1163 = x270 * 0.15;
  const Real x1164 = x272 * 0.15;
  const Real x1030 = x262 * 0.00264635;
  const Real x1033 = x265 * 0.01725;
  const Real x1047 = x262 * 0.01725;
  const Real x1057 = x268 * 2.7e-06;
  w.x[55] = x1057;
  const Real x1042 = x265 * 0.00264635;
  const Real x1031 = x270 * 0.01725;
  const Real x1043 = x269 * 0.01725;
  const Real x1175 = x269 * x1162 + x270 * x1163 + x272 * x1164;
  w.x[56] = x1175;
  const Real x1123 = x270 * x1047 - x269 * x1033;
  const Real x1039 = x1030 + 0.06 * x1031;
  w.x[57] = x1039;
  const Real x1054 = x1042 - 0.06 * x1043;
  w.x[58] = x1054;
  const Real x1206 = x1123 + 0.06 * x1175;
  const Real x1161 = x262 * x1030 + x268 * x1057 + x265 * x1042;
  // joint 5 "left_ball": inertia and bias force of what is beyond, its own motion left open
  const Real x1628 = x153 * 0.15;
  const Real x1640 = x152 * 0.15;
  const Real x1600 = x145 * 0.00112635;
  const Real x1603 = x148 * 0.01125;
  const Real x1617 = x145 * 0.01125;
  const Real x1627 = x151 * 2.7e-06;
  w.x[59] = x1627;
  const Real x1612 = x148 * 0.00112635;
  // link 2 "shank": accelerations and constraint forces of loops below it are eliminated
  const Real x2942 = (x937 - (x296 - x323 * 0.23)) * 4.0;
  const Real x2969 = x2941 + (x2574 - x2604 * x2631) * x2953;
  const Real x2983 = x2942 + (x2578 - x2604 * x2645) * x2953;
  const Real x2943 = (x974 - (x299 - x317 * 0.23)) * 4.0;
  const Real x2999 = x2943 + (x2583 - x2604 * x2659) * x2953;
  const Real x2944 = (x1011 - (x302 + x319 * 0.23)) * 16.0;
  const Real x2787 = sign_of(x2717) * sqrt_of(x2717 * x2717 + x2782 + x2783);
  w.x[60] = x2787;
  const Real x3018 = x2944 + (x2589 - x2604 * x2673) * x2953;
  const Real x2788 = x2717 + x2787;
  w.x[61] = x2788;
  const Real x2791 = x2782 + x2783 + x2788 * x2788;
  // what a loop holds its two links by
  const Real x530 = cosine[3] * 0.05;
  w.x[62] = x530;
  // joint 7 "right_ball": inertia and bias force of what is beyond, its own motion left open
  const Real x1280 = x1161 + 0.06 * x1123 + 0.06 * x1206 + 0.0002466667;
  w.x[63] = x1280;
  const Real x1032 = x258 * 0.01725;
  const Real x1281 = 0.006 + x1206;
  const Real x1045 = x255 * 0.01725;
  const Real x1180 = x255 * x1162 + x258 * x1163 + x261 * x1164;
  w.x[64] = x1180;
  const Real x1212 = x258 * x1047 - x255 * x1033 + 0.06 * x1180;
  // joint 6 "right_motor": inertia and bias force of what is beyond, its own motion left open
  const Real x1329 = sine[5] * x1031 + cosine[5] * x1032;
  w.x[65] = x1329;
  const Real x1303 = sine[5] * x1281 + cosine[5] * x1212;
  w.x[66] = x1303;
  const Real x1341 = x1039 - 0.17 * x1329;
  w.x[67] = x1341;
  // joint 5 "left_ball": inertia and bias force of what is beyond, its own motion left open
  const Real x1736 = x152 * x1640 + x153 * x1628 + x155 * x541;
  w.x[68] = x1736;
  const Real x1601 = x153 * 0.01125;
  const Real x1613 = x152 * 0.01125;
  w.x[69] = x1613;
  const Real x1693 = x153 * x1617 - x152 * x1603;
  const Real x1767 = x1693 + 0.06 * x1736;
  const Real x1609 = x1600 + 0.06 * x1601;
  w.x[70] = x1609;
  const Real x1624 = x1612 - 0.06 * x1613;
  w.x[71] = x1624;
  const Real x1731 = x145 * x1600 + x151 * x1627 + x148 * x1612;
  const Real x1602 = x141 * 0.01125;
  const Real x1841 = x1731 + 0.06 * x1693 + 0.06 * x1767 + 0.0002466667;
  w.x[72] = x1841;
  // joint 3 "ankle_roll": inertia and bias force of what is beyond, its own motion left open
  const Real x2175 = sine[3] * 0.002;
  w.x[73] = x2175;
  const Real x2289 = 0.00630833 + cosine[3] * (cosine[3] * 0.0019583400000000003) + 2.4e-05;
  w.x[74] = x2289;
  // link 2 "shank": accelerations and constraint forces of loops below it are eliminated
  const Real x2973 = 1 / x2787 * ((x2637 - x2695 * x2708) * x2961 + x2969);
  w.x[75] = x2973;
  const Real x3268 = x2788 * x2973;
  w.x[76] = x3268;
  const Real x2793 = 2.0 * (1 / x2791);
  w.x[77] = x2793;
  const Real x3351 = x2695 * x2961;
  w.x[78] = x3351;
  const Real x2798 = x2712 * x2731 + x2718 * x2738 + x2737 * x2788;
  const Real x2799 = x2793 * x2798;
  const Real x2810 = x2712 * x2751 + x2718 * x2758 + x2757 * x2788;
  const Real x2811 = x2793 * x2810;
  const Real x2822 = x2712 * x2771 + x2718 * x2778 + x2777 * x2788;
  const Real x2823 = x2793 * x2822;
  const Real x2804 = x2731 - x2712 * x2799;
  const Real x2805 = x2738 - x2718 * x2799;
  w.x[79] = x2805;
  const Real x2817 = x2758 - x2718 * x2811;
  const Real x2816 = x2751 - x2712 * x2811;
  const Real x2829 = x2778 - x2718 * x2823;
  const Real x2828 = x2771 - x2712 * x2823;
  const Real x2833 = x2805 * x2805;
  // joint 3 "ankle_roll": placement, velocity and reference acceleration of its link
  const Real x68 = v[3] * x66;
  w.x[80] = x68;
  const Real x85 = x77 + x80;
  w.x[81] = x85;
  // link 8 "right_rod": force that the reference field takes
  const Real x519 = x296 * 0.15 - x323 * 0.01725;
  w.x[82] = x519;
  const Real x523 = x299 * 0.15 - x317 * 0.01725;
  w.x[83] = x523;
  const Real x508 = (v[10] * x273 - v[9] * x274) * 2.7e-06;
  w.x[84] = x508;
  const Real x512 = x282 * 0.00264635 - x316 * 0.00264365 + x299 * 0.01725;
  const Real x527 = x302 * 0.15 + x319 * 0.01725;
  w.x[85] = x527;
  const Real x515 = x286 * 0.00264635 + x321 * 0.00264365 - x296 * 0.01725;
  // what a loop holds its two links by
  const Real x531 = sine[3] * 0.05;
  const Real x536 = sine[2] * x531;
  w.x[86] = x536;
  // joint 7 "right_ball": inertia and bias force of what is beyond, its own motion left open
  const Real x1260 = x269 * x519 + x270 * x523 + x272 * x527;
  w.x[87] = x1260;
  // joint 6 "right_motor": inertia and bias force of what is beyond, its own motion left open
  const Real x1358 = sine[5] * x1043 + cosine[5] * x1045;
  w.x[88] = x1358;
  const Real x1315 = x1280 - 0.17 * x1303;
  w.x[89] = x1315;
  const Real x1371 = x1054 + 0.17 * x1358;
  w.x[90] = x1371;
  const Real x1300 = cosine[5] * x1281 - sine[5] * x1212;
  w.x[91] = x1300;
  const Real x1326 = cosine[5] * x1031 - sine[5] * x1032;
  w.x[92] = x1326;
  // joint 5 "left_ball": inertia and bias force of what is beyond, its own motion left open
  const Real x1741 = x138 * x1640 + x141 * x1628 + x144 * x541;
  w.x[93] = x1741;
  const Real x1773 = x141 * x1617 - x138 * x1603 + 0.06 * x1741;
  const Real x1842 = 0.006 + x1767;
  const Real x1615 = x138 * 0.01125;
  w.x[94] = x1615;
  // joint 4 "left_motor": inertia and bias force of what is beyond, its own motion left open
  const Real x1889 = sine[4] * x1601 + cosine[4] * x1602;
  w.x[95] = x1889;
  const Real x1900 = x1609 - 0.25 * x1889;
  w.x[96] = x1900;
  const Real x1864 = sine[4] * x1842 + cosine[4] * x1773;
  w.x[97] = x1864;
  const Real x1917 = sine[4] * x1613 + cosine[4] * x1615;
  w.x[98] = x1917;
  // joint 2 "ankle_pitch": inertia and bias force of what is beyond, its own motion left open
  const Real x2312 = sine[2] * 0.04 + cosine[2] * x530;
  w.x[99] = x2312;
  const Real x2316 = x2289 + 0.4 * x2312;
  w.x[100] = x2316;
  const Real x2329 = x2175 + 0.4 * x536;
  w.x[101] = x2329;
  // link 2 "shank": accelerations and constraint forces of loops below it are eliminated
  const Real x2985 = (x2651 + x2695 * x2727) * x2961 - x2983;
  const Real x3001 = (x2665 + x2695 * x2747) * x2961 - x2999;
  const Real x3002 = x3001 - (x2757 - x2788 * x2811) * x2973;
  w.x[102] = x3002;
  const Real x3020 = (x2679 + x2695 * x2767) * x2961 - x3018;
  const Real x3021 = x3020 - (x2777 - x2788 * x2823) * x2973;
  w.x[103] = x3021;
  const Real x2840 = sign_of(x2804) * sqrt_of(x2804 * x2804 + x2836 + x2833);
  w.x[104] = x2840;
  const Real x2841 = x2804 + x2840;
  w.x[105] = x2841;
  const Real x3415 = x2604 * x2953;
  w.x[106] = x3415;
  const Real x2844 = x2833 + x2836 + x2841 * x2841;
  // link 4 "foot": force that the reference field takes
  const Real x385 = x68 * 0.002999997 - x68 * 0.00826667;
  const Real x405 = 0.002 * (x89 - x85) + x385 + x55 * 0.05;
  const Real x395 = x70 * 0.004958337 - x70 * 0.00630833 + x83 * 0.002;
  const Real x398 = x83 * 0.0019583400000000003;
  w.x[107] = x398;
  const Real x409 = x72 * 0.05;
  w.x[108] = x409;
  // link 6 "left_rod": force that the reference field takes
  const Real x463 = (v[6] * x157 - v[5] * x158) * 2.7e-06;
  const Real x474 = x181 * 0.15 - x208 * 0.01125;
  w.x[109] = x474;
  const Real x478 = x184 * 0.15 - x202 * 0.01125;
  w.x[110] = x478;
  const Real x467 = x166 * 0.00112635 - x201 * 0.00112365 + x184 * 0.01125;
  const Real x482 = x187 * 0.15 + x204 * 0.01125;
  w.x[111] = x482;
  const Real x470 = x170 * 0.00112635 + x206 * 0.00112365 - x181 * 0.01125;
  w.x[112] = x470;
  // what a loop holds its two links by
  const Real x543 = x144 * 0.15;
  w.x[113] = x543;
  const Real x532 = cosine[2] * x531;
  w.x[114] = x532;
  // joint 7 "right_ball": inertia and bias force of what is beyond, its own motion left open
  const Real x1255 = x262 * x512 + x268 * x508 + x265 * x515;
  const Real x1025 = x512 - tau[9];
  w.x[115] = x1025;
  const Real x1285 = x1255 + 0.06 * x1260 + x224 * 0.006;
  w.x[116] = x1285;
  const Real x1026 = x515 - tau[10];
  w.x[117] = x1026;
  const Real x1165 = x255 * 0.15;
  w.x[118] = x1165;
  const Real x1187 = x258 * (x258 * 0.15);
  w.x[119] = x1187;
  const Real x1188 = x261 * (x261 * 0.15);
  w.x[120] = x1188;
  // joint 6 "right_motor": inertia and bias force of what is beyond, its own motion left open
  const Real x1353 = sine[5] * x1045 - cosine[5] * x1043;
  w.x[121] = x1353;
  const Real x1289 = x1285 - tau[8];
  w.x[122] = x1289;
  // joint 5 "left_ball": inertia and bias force of what is beyond, its own motion left open
  const Real x1597 = x463 - tau[7];
  w.x[123] = x1597;
  const Real x1821 = x152 * x474 + x153 * x478 + x155 * x482;
  w.x[124] = x1821;
  const Real x1595 = x467 - tau[5];
  w.x[125] = x1595;
  const Real x1642 = x138 * 0.15;
  w.x[126] = x1642;
  const Real x1748 = x141 * (x141 * 0.15);
  w.x[127] = x1748;
  const Real x1749 = x144 * x543;
  w.x[128] = x1749;
  const Real x1816 = x145 * x467 + x151 * x463 + x148 * x470;
  w.x[129] = x1816;
  // joint 4 "left_motor": inertia and bias force of what is beyond, its own motion left open
  const Real x1875 = x1841 - 0.25 * x1864;
  w.x[130] = x1875;
  const Real x1929 = x1624 + 0.25 * x1917;
  w.x[131] = x1929;
  const Real x1886 = cosine[4] * x1601 - sine[4] * x1602;
  w.x[132] = x1886;
  const Real x1858 = cosine[4] * x1842;
  w.x[133] = x1858;
  const Real x1859 = sine[4] * x1773;
  w.x[134] = x1859;
  // joint 3 "ankle_roll": inertia and bias force of what is beyond, its own motion left open
  const Real x2273 = cosine[3] * (x405 - x73 * 0.04);
  w.x[135] = x2273;
  const Real x2274 = sine[3] * (x395 + x72 * 0.04);
  w.x[136] = x2274;
  // joint 2 "ankle_pitch": inertia and bias force of what is beyond, its own motion left open
  const Real x2307 = sine[2] * x530 - cosine[2] * 0.04;
  w.x[137] = x2307;
  // link 2 "shank": accelerations and constraint forces of loops below it are eliminated
  const Real x2987 = 1 / x2840 * (x2985 - (x2737 - x2788 * x2799) * x2973);
  w.x[138] = x2987;
  const Real x3202 = x2841 * x2987;
  w.x[139] = x3202;
  const Real x2846 = 2.0 * (1 / x2844);
  w.x[140] = x2846;
  const Real x2852 = x2805 * x2817 - x2581 * x2586 + x2816 * x2841;
  const Real x2853 = x2846 * x2852;
  const Real x2868 = x2805 * x2829 - x2581 * x2592 + x2828 * x2841;
  const Real x2869 = x2846 * x2868;
  const Real x2857 = 0.92 * x2853;
  w.x[141] = x2857;
  const Real x2873 = 0.92 * x2869;
  w.x[142] = x2873;
  const Real x2859 = x2817 - x2805 * x2853;
  w.x[143] = x2859;
  const Real x2860 = x2586 + x2581 * x2853;
  w.x[144] = x2860;
  const Real x2876 = x2592 + x2581 * x2869;
  w.x[145] = x2876;
  const Real x2875 = x2829 - x2805 * x2869;
  w.x[146] = x2875;
  const Real x2900 = x2857 * x2873;
  w.x[147] = x2900;
  const Real x2881 = x2859 * x2859;
  w.x[148] = x2881;
  const Real x2886 = 0.8464 + x2857 * x2857;
  w.x[149] = x2886;
  const Real x2882 = x2860 * x2860;
  w.x[150] = x2882;
  const Real x2880 = sign_of(x2859);
  w.x[151] = x2880;
  const Real x2898 = x2860 * x2876;
  w.x[152] = x2898;
  const Real x2997 = (x2816 - x2841 * x2853) * x2987;
  w.x[153] = x2997;
  const Real x3014 = (x2828 - x2841 * x2869) * x2987;
  w.x[154] = x3014;
}

ADAGEN_NOINLINE void part_1_1(Workspace& w) {
  ADAGEN_INPUTS
  const Real x9 = w.x[22];
  const Real x27 = w.x[32];
  const Real x32 = w.x[33];
  const Real x50 = w.x[34];
  const Real x55 = w.x[35];
  const Real x68 = w.x[80];
  const Real x72 = w.x[41];
  const Real x73 = w.x[42];
  const Real x85 = w.x[81];
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
  const Real x398 = w.x[107];
  const Real x409 = w.x[108];
  const Real x412 = w.x[46];
  const Real x442 = w.x[10];
  const Real x470 = w.x[112];
  const Real x474 = w.x[109];
  const Real x478 = w.x[110];
  const Real x482 = w.x[111];
  const Real x488 = w.x[11];
  const Real x508 = w.x[84];
  const Real x519 = w.x[82];
  const Real x523 = w.x[83];
  const Real x527 = w.x[85];
  const Real x530 = w.x[62];
  const Real x532 = w.x[114];
  const Real x536 = w.x[86];
  const Real x541 = w.x[54];
  const Real x543 = w.x[113];
  const Real x573 = w.x[13];
  const Real x593 = w.x[12];
  const Real x654 = w.x[14];
  const Real x837 = w.x[15];
  const Real x893 = w.x[16];
  const Real x1025 = w.x[115];
  const Real x1026 = w.x[117];
  const Real x1039 = w.x[57];
  const Real x1054 = w.x[58];
  const Real x1057 = w.x[55];
  const Real x1165 = w.x[118];
  const Real x1175 = w.x[56];
  const Real x1180 = w.x[64];
  const Real x1187 = w.x[119];
  const Real x1188 = w.x[120];
  const Real x1260 = w.x[87];
  const Real x1280 = w.x[63];
  const Real x1285 = w.x[116];
  const Real x1289 = w.x[122];
  const Real x1300 = w.x[91];
  const Real x1303 = w.x[66];
  const Real x1315 = w.x[89];
  const Real x1326 = w.x[92];
  const Real x1329 = w.x[65];
  const Real x1341 = w.x[67];
  const Real x1353 = w.x[121];
  const Real x1358 = w.x[88];
  const Real x1371 = w.x[90];
  const Real x1595 = w.x[125];
  const Real x1597 = w.x[123];
  const Real x1609 = w.x[70];
  const Real x1613 = w.x[69];
  const Real x1615 = w.x[94];
  const Real x1624 = w.x[71];
  const Real x1627 = w.x[59];
  const Real x1642 = w.x[126];
  const Real x1736 = w.x[68];
  const Real x1741 = w.x[93];
  const Real x1748 = w.x[127];
  const Real x1749 = w.x[128];
  const Real x1816 = w.x[129];
  const Real x1821 = w.x[124];
  const Real x1841 = w.x[72];
  const Real x1858 = w.x[133];
  const Real x1859 = w.x[134];
  const Real x1864 = w.x[97];
  const Real x1875 = w.x[130];
  const Real x1886 = w.x[132];
  const Real x1889 = w.x[95];
  const Real x1900 = w.x[96];
  const Real x1917 = w.x[98];
  const Real x1929 = w.x[131];
  const Real x2175 = w.x[73];
  const Real x2273 = w.x[135];
  const Real x2274 = w.x[136];
  const Real x2289 = w.x[74];
  const Real x2307 = w.x[137];
  const Real x2312 = w.x[99];
  const Real x2316 = w.x[100];
  const Real x2329 = w.x[101];
  const Real x2566 = w.x[21];
  const Real x2567 = w.x[20];
  const Real x2581 = w.x[30];
  const Real x2603 = w.x[29];
  const Real x2604 = w.x[31];
  const Real x2608 = w.x[38];
  const Real x2619 = w.x[39];
  const Real x2622 = w.x[40];
  const Real x2694 = w.x[47];
  const Real x2695 = w.x[48];
  const Real x2700 = w.x[50];
  const Real x2712 = w.x[52];
  const Real x2718 = w.x[53];
  const Real x2787 = w.x[60];
  const Real x2788 = w.x[61];
  const Real x2793 = w.x[77];
  const Real x2805 = w.x[79];
  const Real x2840 = w.x[104];
  const Real x2841 = w.x[105];
  const Real x2846 = w.x[140];
  const Real x2857 = w.x[141];
  const Real x2859 = w.x[143];
  const Real x2860 = w.x[144];
  const Real x2873 = w.x[142];
  const Real x2875 = w.x[146];
  const Real x2876 = w.x[145];
  const Real x2880 = w.x[151];
  const Real x2881 = w.x[148];
  const Real x2882 = w.x[150];
  const Real x2886 = w.x[149];
  const Real x2898 = w.x[152];
  const Real x2900 = w.x[147];
  const Real x2953 = w.x[49];
  const Real x2961 = w.x[51];
  const Real x2973 = w.x[75];
  const Real x2987 = w.x[138];
  const Real x2997 = w.x[153];
  const Real x3002 = w.x[102];
  const Real x3014 = w.x[154];
  const Real x3021 = w.x[103];
  const Real x3202 = w.x[139];
  const Real x3268 = w.x[76];
  const Real x3351 = w.x[78];
  const Real x3415 = w.x[106];
  // link 2 "shank": force that the reference field takes
  const Real x351 = x32 * 0.7000000000000001;
  w.x[155] = x351;
  // joint 7 "right_ball": inertia and bias force of what is beyond, its own motion left open
  const Real x1282 = 0.2 + x1175;
  const Real x1027 = x508 - tau[11];
  w.x[156] = x1027;
  const Real x1283 = x1187 + x1188 + x255 * x1165 + 0.2;
  const Real x1286 = x224 * 0.2 + x1260;
  const Real x1265 = x255 * x519 + x258 * x523 + x261 * x527;
  const Real x1287 = x488 - x229 * 0.2 + x1265;
  // joint 6 "right_motor": inertia and bias force of what is beyond, its own motion left open
  const Real x1491 = cosine[5] * (x1282 - x1283) - x1180 * (2.0 * sine[5]);
  const Real x1495 = cosine[5] * x1491;
  const Real x1497 = x1282 - x1495;
  const Real x1494 = x1180 + sine[5] * x1491;
  const Real x1579 = sine[5] * x1286 + cosine[5] * x1287;
  // joint 5 "left_ball": inertia and bias force of what is beyond, its own motion left open
  const Real x1843 = 0.2 + x1736;
  const Real x1596 = x470 - tau[6];
  w.x[157] = x1596;
  const Real x1846 = x1816 + 0.06 * x1821 + x107 * 0.006;
  const Real x1844 = x1748 + x1749 + x138 * x1642 + 0.2;
  const Real x1847 = x107 * 0.2 + x1821;
  const Real x1826 = x138 * x474 + x141 * x478 + x144 * x482;
  const Real x1848 = x442 - x112 * 0.2 + x1826;
  // joint 4 "left_motor": inertia and bias force of what is beyond, its own motion left open
  const Real x1861 = x1858 - x1859;
  w.x[158] = x1861;
  const Real x1912 = sine[4] * x1615 - cosine[4] * x1613;
  w.x[159] = x1912;
  const Real x1850 = x1846 - tau[4];
  w.x[160] = x1850;
  const Real x2050 = cosine[4] * (x1843 - x1844) - x1741 * (2.0 * sine[4]);
  const Real x2054 = cosine[4] * x2050;
  const Real x2056 = x1843 - x2054;
  const Real x2053 = x1741 + sine[4] * x2050;
  // joint 3 "ankle_roll": inertia and bias force of what is beyond, its own motion left open
  const Real x2276 = x2273 - x2274;
  const Real x2174 = x398 + x409 - tau[3];
  w.x[161] = x2174;
  const Real x2285 = cosine[3] * (x73 + x85 * 0.05);
  const Real x2291 = sine[3] * (x72 + x412) + x2285 + x50 * 0.15;
  // link 4 "foot": force that the reference field takes
  const Real x423 = 2.0 * x68 * 0.05 - x89 * 0.04 - x55;
  // joint 3 "ankle_roll": inertia and bias force of what is beyond, its own motion left open
  const Real x2292 = x423 - x55 * 0.15;
  // joint 2 "ankle_pitch": inertia and bias force of what is beyond, its own motion left open
  const Real x2294 = x2276 - tau[2];
  w.x[162] = x2294;
  const Real x2505 = -0.46 - x2312;
  // link 2 "shank": accelerations and constraint forces of loops below it are eliminated
  const Real x2890 = x2880 * sqrt_of(x2881 + x2886 + x2882);
  const Real x2891 = x2859 + x2890;
  // link 1 "thigh": force that the reference field takes
  const Real x334 = x9 * 1.2000000000000002;
  w.x[163] = x334;
  // link 2 "shank": force that the reference field takes
  const Real x357 = x32 * 3.5;
  w.x[164] = x357;
  const Real x356 = x27 * 3.5 + x354;
  w.x[165] = x356;
  // what a loop holds its two links by
  const Real x569 = v[2] * sine[3];
  const Real x574 = 0.06 * (v[2] * cosine[3]);
  const Real x597 = x155 * x593;
  const Real x609 = x153 * x593 + 0.15 * (v[5] + v[4] * x145);
  const Real x571 = 0.06 * x569;
  const Real x576 = x573 + x574;
  const Real x606 = x152 * x593 - 0.15 * (v[6] + v[4] * x148);
  // what a loop holds its two links by
  const Real x841 = x272 * x837;
  const Real x853 = x270 * x837 + 0.23 * (v[9] + v[8] * x262);
  // joint 6 "right_motor": inertia and bias force of what is beyond, its own motion left open
  const Real x1519 = x1303 - 0.17 * x1497;
  // joint 4 "left_motor": inertia and bias force of what is beyond, its own motion left open
  const Real x2134 = sine[4] * x1847 + cosine[4] * x1848;
  const Real x2077 = x1864 - 0.25 * x2056;
  const Real x2162 = x1494 + x2053;
  w.x[166] = x2162;
  // joint 6 "right_motor": inertia and bias force of what is beyond, its own motion left open
  const Real x1576 = cosine[5] * x1286 - sine[5] * x1287;
  // joint 2 "ankle_pitch": inertia and bias force of what is beyond, its own motion left open
  const Real x2534 = sine[2] * x2291 + cosine[2] * x2292;
  const Real x2554 = x1497 + x2056 + 1.15;
  w.x[167] = x2554;
  const Real x2553 = x1283 + x1495 + (x1844 + x2054) + 1.15;
  w.x[168] = x2553;
  const Real x2552 = x1519 + x2077 + x2505;
  w.x[169] = x2552;
  // joint 4 "left_motor": inertia and bias force of what is beyond, its own motion left open
  const Real x2158 = x1300 - 0.17 * x1494 + (x1861 - 0.25 * x2053);
  // joint 2 "ankle_pitch": inertia and bias force of what is beyond, its own motion left open
  const Real x2551 = x2158 + x2307;
  w.x[170] = x2551;
  // joint 4 "left_motor": inertia and bias force of what is beyond, its own motion left open
  const Real x2169 = x1285 - 0.17 * x1579 + (x1846 - 0.25 * x2134);
  // joint 2 "ankle_pitch": inertia and bias force of what is beyond, its own motion left open
  const Real x2558 = x2276 - 0.4 * x2534 + x2169;
  w.x[171] = x2558;
  const Real x2560 = x1579 + x2134 + x2534;
  w.x[172] = x2560;
  // joint 4 "left_motor": inertia and bias force of what is beyond, its own motion left open
  const Real x2157 = x1315 - 0.17 * x1519 + (x1875 - 0.25 * x2077);
  // joint 2 "ankle_pitch": inertia and bias force of what is beyond, its own motion left open
  const Real x2550 = x2316 - 0.4 * x2505 + x2157;
  w.x[173] = x2550;
  // joint 4 "left_motor": inertia and bias force of what is beyond, its own motion left open
  const Real x2170 = cosine[4] * x1847 - sine[4] * x1848 + x1576;
  // joint 2 "ankle_pitch": inertia and bias force of what is beyond, its own motion left open
  const Real x2559 = cosine[2] * x2291 - sine[2] * x2292 + x2170;
  w.x[174] = x2559;
  // link 2 "shank": accelerations and constraint forces of loops below it are eliminated
  const Real x2894 = x2882 + x2886 + x2891 * x2891;
  const Real x3004 = 1 / x2890 * (x2997 + x3002);
  const Real x2896 = 2.0 * (1 / x2894);
  const Real x2904 = x2896 * (x2898 + x2900 + x2875 * x2891);
  const Real x2908 = 0.92 * x2904;
  const Real x2913 = x2860 * x2904 - x2876;
  const Real x2914 = x2857 * x2904 - x2873;
  // joint 1 "knee": articulated-body inertia and bias force through it
  const Real x4945 = sine[1] * 2.0;
  w.x[175] = x4945;
  // what a loop holds its two links by
  const Real x583 = sine[3] * x571;
  const Real x547 = -0.06 - x543;
  const Real x577 = 0.05 * x569;
  const Real x585 = x583 + cosine[3] * x576;
  const Real x614 = x153 * x609 + x155 * x597 + x152 * x606;
  const Real x619 = x141 * x609 + x144 * x597 + x138 * x606;
  const Real x533 = sine[2] * 0.06;
  const Real x537 = cosine[2] * 0.06;
  const Real x579 = cosine[3] * x571;
  const Real x587 = sine[2] * x577;
  const Real x591 = cosine[2] * x577;
  const Real x561 = x536 - x537 - (cosine[4] * x547 - sine[4] * x541);
  const Real x562 = x530 - (0.05 - x151 * 0.15);
  const Real x628 = cosine[4] * x614 - sine[4] * x619;
  const Real x632 = cosine[2] * x585 - x587 - x628;
  // what a loop holds its two links by
  const Real x826 = x574 - x573;
  const Real x850 = x269 * x837 - 0.23 * (v[10] + v[8] * x265);
  const Real x794 = x272 * 0.23;
  const Real x800 = -0.06 - x261 * 0.23;
  const Real x831 = x583 + cosine[3] * x826;
  const Real x858 = x270 * x853 + x272 * x841 + x269 * x850;
  const Real x863 = x258 * x853 + x261 * x841 + x255 * x850;
  // link 2 "shank": accelerations and constraint forces of loops below it are eliminated
  const Real x2920 = x2913 * x2913 + x2908 * x2908 + x2914 * x2914;
  const Real x2921 = sqrt_of(x2920);
  const Real x2922 = x2921 * x2921;
  require_more(w, x2922, 9.999999999999998e-15, kLoopSingular, 9);
  const Real x2923 = x2920 + x2922;
  // what a loop holds its two links by
  const Real x624 = x148 * x609 + x151 * x597 + x145 * x606;
  const Real x634 = x579 - sine[3] * x576 - x624;
  const Real x558 = -0.25 - (cosine[4] * x541 + sine[4] * x547);
  const Real x560 = x532 + x533 + -0.4 - x558;
  const Real x631 = sine[4] * x614 + cosine[4] * x619;
  const Real x633 = sine[2] * x585 + x591 - x631;
  const Real x567 = x561 * x561 + x562 * x562 + x560 * x560;
  const Real x655 = 1e-08 - x567;
  require_more(w, x655, 0.0, kLoopOpen, 8);
  const Real x639 = x632 * x632 + x634 * x634 + x633 * x633;
  const Real x656 = x654 - x639;
  require_more(w, x656, 0.0, kLoopTorn, 8);
  // what a loop holds its two links by
  const Real x814 = x536 + x537 + (cosine[5] * x800 - sine[5] * x794);
  const Real x816 = -0.05 - x268 * 0.23 + x530;
  const Real x872 = cosine[5] * x858 - sine[5] * x863;
  const Real x876 = x587 + cosine[2] * x831 - x872;
  const Real x868 = x265 * x853 + x268 * x841 + x262 * x850;
  const Real x878 = x579 - sine[3] * x826 - x868;
  const Real x811 = -0.17 - (cosine[5] * x794 + sine[5] * x800);
  const Real x813 = x533 - x532 + -0.4 - x811;
  const Real x875 = sine[5] * x858 + cosine[5] * x863;
  const Real x877 = sine[2] * x831 - x591 - x875;
  const Real x824 = x814 * x814 + x816 * x816 + x813 * x813;
  const Real x895 = 1e-08 - x824;
  require_more(w, x895, 0.0, kLoopOpen, 9);
  // link 2 "shank": accelerations and constraint forces of loops below it are eliminated
  const Real x3023 = x3014 + x3021 + (x2875 - x2891 * x2904) * x3004;
  const Real x3024 = 1 / x2921 * x3023;
  const Real x2925 = 2.0 * (1 / x2923);
  const Real x2927 = x2603 * x2603;
  require_more(w, x2927, 9.999999999999998e-15, kLoopSingular, 8);
  const Real x2930 = x2694 * x2694;
  require_more(w, x2930, 9.999999999999998e-15, kLoopSingular, 8);
  const Real x2932 = x2787 * x2787;
  require_more(w, x2932, 9.999999999999998e-15, kLoopSingular, 8);
  const Real x2934 = x2840 * x2840;
  require_more(w, x2934, 9.999999999999998e-15, kLoopSingular, 9);
  const Real x2936 = x2890 * x2890;
  require_more(w, x2936, 9.999999999999998e-15, kLoopSingular, 9);
  const Real x3026 = x2913 * x2925;
  const Real x3035 = x2908 * x2925;
  const Real x3044 = x2914 * x2925;
  const Real x3055 = x2925 * (x2921 * x3024);
  const Real x3029 = x2908 * x3026;
  const Real x3030 = x2914 * x3026;
  const Real x3037 = x2913 * x3035;
  const Real x3039 = x2914 * x3035;
  const Real x3046 = x2913 * x3044;
  const Real x3047 = x2908 * x3044;
  const Real x3059 = x2913 * x3055;
  const Real x3061 = x2908 * x3055;
  const Real x3032 = 1.0 - x2913 * x3026;
  const Real x3042 = 1.0 - x2908 * x3035;
  const Real x3052 = 1.0 - x2914 * x3044;
  const Real x3063 = x2914 * x3055;
  const Real x3027 = x2921 * x3026;
  w.x[176] = x3027;
  const Real x3036 = x2921 * x3035;
  w.x[177] = x3036;
  const Real x3045 = x2921 * x3044;
  w.x[178] = x3045;
  const Real x3464 = x1627 * x3027;
  const Real x3472 = x1627 * x3036;
  const Real x3480 = x1627 * x3045;
  const Real x3073 = 0.92 * x3029 + x2857 * x3030 - x2860 * x3032;
  const Real x3074 = x2896 * x3073;
  const Real x3065 = x2921 * x3055 - x3024;
  w.x[179] = x3065;
  const Real x3093 = x2860 * x3037 + x2857 * x3039 - 0.92 * x3042;
  const Real x3094 = x2896 * x3093;
  // what a loop holds its two links by
  const Real x883 = x876 * x876 + x878 * x878 + x877 * x877;
  const Real x896 = 1.0000000000000002e-06 * x893 - x883;
  require_more(w, x896, 0.0, kLoopTorn, 9);
  // link 2 "shank": accelerations and constraint forces of loops below it are eliminated
  const Real x3113 = x2860 * x3046 + 0.92 * x3047 - x2857 * x3052;
  const Real x3114 = x2896 * x3113;
  const Real x3136 = x2891 * x3004 + x2860 * x3059 + 0.92 * x3061;
  const Real x3075 = x2891 * x3074;
  const Real x3095 = x2891 * x3094;
  const Real x3115 = x2891 * x3114;
  const Real x3140 = x2896 * (x2857 * x3063 + x3136);
  const Real x3083 = x3032 + x2860 * x3074;
  const Real x3085 = x2857 * x3074 - x3030;
  const Real x3103 = x2860 * x3094 - x3037;
  const Real x3105 = x2857 * x3094 - x3039;
  const Real x3123 = x2860 * x3114 - x3046;
  const Real x3125 = x3052 + x2857 * x3114;
  const Real x3084 = 0.92 * x3074 - x3029;
  w.x[180] = x3084;
  const Real x3150 = x2891 * x3140 - x3004;
  const Real x3104 = x3042 + 0.92 * x3094;
  w.x[181] = x3104;
  const Real x3151 = x3059 - x2860 * x3140;
  const Real x3153 = x3063 - x2857 * x3140;
  const Real x3124 = 0.92 * x3114 - x3047;
  w.x[182] = x3124;
  const Real x3159 = x2581 * x3083 - x2805 * x3075 + 0.92 * x3085;
  const Real x3160 = x2846 * x3159;
  const Real x3175 = x2581 * x3103 - x2805 * x3095 + 0.92 * x3105;
  const Real x3176 = x2846 * x3175;
  const Real x3152 = x3061 - 0.92 * x3140;
  w.x[183] = x3152;
  const Real x3191 = x2581 * x3123 - x2805 * x3115 + 0.92 * x3125;
  const Real x3192 = x2846 * x3191;
  const Real x3161 = x2841 * x3160;
  const Real x3177 = x2841 * x3176;
  const Real x3193 = x2841 * x3192;
  const Real x3166 = x3075 + x2805 * x3160;
  const Real x3168 = x3083 - x2581 * x3160;
  w.x[184] = x3168;
  const Real x3182 = x3095 + x2805 * x3176;
  const Real x3169 = x3085 - 0.92 * x3160;
  w.x[185] = x3169;
  const Real x3198 = x3115 + x2805 * x3192;
  const Real x3184 = x3103 - x2581 * x3176;
  w.x[186] = x3184;
  const Real x3185 = x3105 - 0.92 * x3176;
  w.x[187] = x3185;
  const Real x3532 = x1039 * x3168 + 0.00264635 * x3084;
  const Real x3541 = x1054 * x3168 + 0.00264635 * x3169;
  const Real x3535 = x1039 * x3184 + 0.00264635 * x3104;
  const Real x3226 = x2793 * (x2712 * x3161 + x2718 * x3166);
  const Real x3208 = x2805 * x3150 - x3202 + x2581 * x3151;
  const Real x3519 = x1280 * x3168 + x1039 * x3084 + x1054 * x3169;
  const Real x3242 = x2793 * (x2712 * x3177 + x2718 * x3182);
  const Real x3544 = x1054 * x3184 + 0.00264635 * x3185;
  const Real x3258 = x2793 * (x2712 * x3193 + x2718 * x3198);
  const Real x3200 = x3123 - x2581 * x3192;
  w.x[188] = x3200;
  const Real x3524 = x1280 * x3184 + x1039 * x3104 + x1054 * x3185;
  const Real x3228 = x2788 * x3226;
  const Real x3244 = x2788 * x3242;
  const Real x3260 = x2788 * x3258;
  const Real x3234 = x2712 * x3226 - x3161;
  const Real x3235 = x2718 * x3226 - x3166;
  const Real x3250 = x2712 * x3242 - x3177;
  const Real x3251 = x2718 * x3242 - x3182;
  const Real x3266 = x2712 * x3258 - x3193;
  const Real x3267 = x2718 * x3258 - x3198;
  const Real x3201 = x3125 - 0.92 * x3192;
  w.x[189] = x3201;
  const Real x3210 = x2846 * (0.92 * x3153 + x3208);
  const Real x3215 = x2987 + x2841 * x3210;
  const Real x3538 = x1039 * x3200 + 0.00264635 * x3124;
  const Real x3547 = x1054 * x3200 + 0.00264635 * x3201;
  const Real x3290 = x2622 * x3228 + 1.2 * x3234 + x2619 * x3235;
  const Real x3292 = x2700 * x3290;
  const Real x3217 = x3150 - x2805 * x3210;
  const Real x3313 = x2622 * x3244 + 1.2 * x3250 + x2619 * x3251;
  const Real x3315 = x2700 * x3313;
  const Real x3529 = x1280 * x3200 + x1039 * x3124 + x1054 * x3201;
  const Real x3336 = x2622 * x3260 + 1.2 * x3266 + x2619 * x3267;
  const Real x3338 = x2700 * x3336;
  const Real x3294 = x2695 * x3292;
  const Real x3317 = x2695 * x3315;
  const Real x3340 = x2695 * x3338;
  const Real x3302 = x3228 - x2622 * x3292;
  const Real x3304 = x3235 - x2619 * x3292;
  const Real x3325 = x3244 - x2622 * x3315;
  const Real x3327 = x3251 - x2619 * x3315;
  const Real x3303 = x3234 - 1.2 * x3292;
  w.x[190] = x3303;
  const Real x3348 = x3260 - x2622 * x3338;
  const Real x3350 = x3267 - x2619 * x3338;
  const Real x3326 = x3250 - 1.2 * x3315;
  w.x[191] = x3326;
  const Real x3349 = x3266 - 1.2 * x3338;
  w.x[192] = x3349;
  const Real x3377 = x2566 * x3294 + x2567 * x3302 + 1.2 * x3304;
  const Real x3378 = x2608 * x3377;
  const Real x3274 = x2793 * (x3268 - x2712 * x3215 + x2718 * x3217);
  const Real x3391 = x2566 * x3317 + x2567 * x3325 + 1.2 * x3327;
  const Real x3392 = x2608 * x3391;
  const Real x3405 = x2566 * x3340 + x2567 * x3348 + 1.2 * x3350;
  const Real x3406 = x2608 * x3405;
  const Real x3379 = x2604 * x3378;
  w.x[193] = x3379;
  const Real x3393 = x2604 * x3392;
  w.x[194] = x3393;
  const Real x3407 = x2604 * x3406;
  w.x[195] = x3407;
  const Real x3384 = x3294 - x2566 * x3378;
  w.x[196] = x3384;
  const Real x3385 = x3302 - x2567 * x3378;
  w.x[197] = x3385;
  const Real x3386 = x3304 - 1.2 * x3378;
  w.x[198] = x3386;
  const Real x3398 = x3317 - x2566 * x3392;
  w.x[199] = x3398;
  const Real x3399 = x3325 - x2567 * x3392;
  w.x[200] = x3399;
  const Real x3400 = x3327 - 1.2 * x3392;
  w.x[201] = x3400;
  const Real x3412 = x3340 - x2566 * x3406;
  w.x[202] = x3412;
  const Real x3435 = x2289 * x3379 + x2175 * x3384;
  w.x[203] = x3435;
  const Real x3452 = x2175 * x3379 + 0.003308333 * x3384;
  w.x[204] = x3452;
  const Real x3487 = x1609 * x3385 + 0.00112635 * x3303;
  const Real x3496 = x1624 * x3385 + 0.00112635 * x3386;
  w.x[205] = x3496;
  const Real x3441 = x2289 * x3393 + x2175 * x3398;
  w.x[206] = x3441;
  const Real x3506 = x1627 * x3385 - 2.7e-06 * x3027;
  const Real x3456 = x2175 * x3393 + 0.003308333 * x3398;
  w.x[207] = x3456;
  const Real x3490 = x1609 * x3399 + 0.00112635 * x3326;
  const Real x3467 = x1609 * x3303 - x3464 + x1841 * x3385;
  const Real x3468 = x1624 * x3386 + x3467;
  w.x[208] = x3468;
  const Real x3499 = x1624 * x3399 + 0.00112635 * x3400;
  w.x[209] = x3499;
  const Real x3785 = x3084 * x3532 + x3169 * x3541 + x3168 * x3519;
  const Real x3804 = x3084 * x3535 + x3169 * x3544 + x3168 * x3524;
  const Real x3510 = x1627 * x3399 - 2.7e-06 * x3036;
  w.x[210] = x3510;
  const Real x3861 = x3104 * x3535 + x3185 * x3544 + x3184 * x3524;
  const Real x3413 = x3348 - x2567 * x3406;
  w.x[211] = x3413;
  const Real x3447 = x2289 * x3407 + x2175 * x3412;
  w.x[212] = x3447;
  const Real x3475 = x1609 * x3326 - x3472 + x1841 * x3399;
  const Real x3476 = x1624 * x3400 + x3475;
  w.x[213] = x3476;
  const Real x3787 = x3379 * x3435 + x3785 + x3384 * x3452;
  const Real x3414 = x3350 - 1.2 * x3406;
  w.x[214] = x3414;
  const Real x3806 = x3379 * x3441 + x3804 + x3384 * x3456;
  const Real x3460 = x2175 * x3407 + 0.003308333 * x3412;
  w.x[215] = x3460;
  const Real x3863 = x3393 * x3441 + x3861 + x3398 * x3456;
  const Real x3493 = x1609 * x3413 + 0.00112635 * x3349;
  w.x[216] = x3493;
  const Real x3823 = x3084 * x3538 + x3169 * x3547 + x3168 * x3529;
  const Real x3789 = x3303 * x3487 + x3787 + x3386 * x3496;
  const Real x3502 = x1624 * x3413 + 0.00112635 * x3414;
  w.x[217] = x3502;
  const Real x3808 = x3303 * x3490 + x3806 + x3386 * x3499;
  const Real x3880 = x3104 * x3538 + x3185 * x3547 + x3184 * x3529;
  const Real x3791 = x3789 - x3027 * x3506 + x3385 * x3468;
  require_more(w, x3791, 0.0, kLoopFree, 2);
  const Real x3278 = x2973 - x2788 * x3274;
  const Real x3865 = x3326 * x3490 + x3863 + x3400 * x3499;
  const Real x3810 = x3808 - x3027 * x3510 + x3385 * x3476;
  const Real x3514 = x1627 * x3413 - 2.7e-06 * x3045;
  w.x[218] = x3514;
  const Real x3825 = x3379 * x3447 + x3823 + x3384 * x3460;
  const Real x4259 = 1 / x3791;
  w.x[219] = x4259;
  const Real x3867 = x3865 - x3036 * x3510 + x3399 * x3476;
  w.x[220] = x3867;
  const Real x3279 = x3215 + x2712 * x3274;
  const Real x3483 = x1609 * x3349 - x3480 + x1841 * x3413;
  const Real x3484 = x1624 * x3414 + x3483;
  w.x[221] = x3484;
  const Real x3882 = x3393 * x3447 + x3880 + x3398 * x3460;
  const Real x3937 = x3124 * x3538 + x3201 * x3547 + x3200 * x3529;
  const Real x3281 = x3217 - x2718 * x3274;
  const Real x3827 = x3303 * x3493 + x3825 + x3386 * x3502;
  const Real x4069 = x1341 * x3084 - x3464 + x1315 * x3168;
  const Real x3829 = x3827 - x3027 * x3514 + x3385 * x3484;
  const Real x3884 = x3326 * x3493 + x3882 + x3400 * x3502;
  const Real x3939 = x3407 * x3447 + x3937 + x3412 * x3460;
  const Real x4260 = x3810 * x4259;
  w.x[222] = x4260;
  const Real x3359 = x3351 - x2622 * x3278 + 1.2 * x3279;
  const Real x3548 = x1057 * x3168;
  const Real x4261 = x3829 * x4259;
  w.x[223] = x4261;
  const Real x4087 = x1341 * x3104 - x3472 + x1315 * x3184;
  const Real x3361 = x2700 * (x3359 - x2619 * x3281);
  const Real x3941 = x3349 * x3493 + x3939 + x3414 * x3502;
  const Real x4265 = x3867 - x3810 * x4260;
  w.x[224] = x4265;
  const Real x3886 = x3884 - x3036 * x3514 + x3399 * x3484;
  const Real x4268 = x3886 - x3829 * x4260;
  const Real x4071 = x1371 * x3169 + x4069 + x1900 * x3303;
  const Real x3943 = x3941 - x3045 * x3514 + x3413 * x3484;
  w.x[225] = x3943;
  const Real x4272 = 1 / x4265;
  w.x[226] = x4272;
  const Real x4105 = x1341 * x3124 - x3480 + x1315 * x3200;
  const Real x3369 = x2961 - x2695 * x3361;
  w.x[227] = x3369;
  const Real x3370 = x3278 + x2622 * x3361;
  w.x[228] = x3370;
  const Real x3372 = x3281 + x2619 * x3361;
  w.x[229] = x3372;
  const Real x4271 = x1057 * x3184 - x3548 * x4260;
  const Real x3219 = x3153 - 0.92 * x3210;
  w.x[230] = x3219;
  const Real x4089 = x1371 * x3185 + x4087 + x1900 * x3326;
  const Real x4262 = x3548 * x4259;
  w.x[231] = x4262;
  const Real x4273 = x4268 * x4272;
  w.x[232] = x4273;
  const Real x3218 = x3151 - x2581 * x3210;
  w.x[233] = x3218;
  const Real x4073 = x4071 - x2316 * x3379 - x2329 * x3384;
  const Real x3420 = x3415 + x2566 * x3369 + x2567 * x3370;
  const Real x4107 = x1371 * x3201 + x4105 + x1900 * x3349;
  const Real x4280 = x3943 - x3829 * x4261 - x4268 * x4273;
  w.x[234] = x4280;
  const Real x4172 = x1303 * x3168 + x1329 * x3084 - x1358 * x3169;
  const Real x4274 = x4271 * x4272;
  w.x[235] = x4274;
  const Real x4286 = x1057 * x3200 - x3548 * x4261 - x4271 * x4273;
  const Real x4287 = 1 / x4280;
  w.x[236] = x4287;
  const Real x3371 = 1.2 * x3361 - x3279;
  w.x[237] = x3371;
  const Real x3422 = x2608 * (1.2 * x3372 + x3420);
  w.x[238] = x3422;
  const Real x4075 = x1875 * x3385 + x4073 + x1929 * x3386;
  w.x[239] = x4075;
  const Real x4091 = x4089 - x2316 * x3393 - x2329 * x3398;
  const Real x4122 = x1300 * x3168 + x1326 * x3084 + x1353 * x3169;
  const Real x4190 = x1303 * x3184 + x1329 * x3104 - x1358 * x3185;
  const Real x4288 = x4286 * x4287;
  w.x[240] = x4288;
  const Real x4093 = x1875 * x3399 + x4091 + x1929 * x3400;
  w.x[241] = x4093;
  const Real x4109 = x4107 - x2316 * x3407 - x2329 * x3412;
  const Real x4138 = x1300 * x3184 + x1326 * x3104 + x1353 * x3185;
  const Real x4174 = x1889 * x3303 + x4172 + x2312 * x3379;
  const Real x4180 = x536 * x3398;
  w.x[242] = x4180;
  const Real x4192 = x1889 * x3326 + x4190 + x2312 * x3393;
  w.x[243] = x4192;
  const Real x4196 = x2312 * x3407;
  w.x[244] = x4196;
  const Real x4208 = x1303 * x3200 + x1329 * x3124 - x1358 * x3201;
  const Real x4209 = x1889 * x3349 + x4208;
  w.x[245] = x4209;
  const Real x4293 = x4286 * x4288;
  w.x[246] = x4293;
  const Real x4296 = 2.7e-06 - x3548 * x4262 - x4271 * x4274;
  w.x[247] = x4296;
  const Real x3424 = x2566 * x3422;
  w.x[248] = x3424;
  const Real x3427 = x2953 - x2604 * x3422;
  w.x[249] = x3427;
  const Real x3555 = x1595 * x3303;
  w.x[250] = x3555;
  const Real x3563 = x1025 * x3084 - x1597 * x3027 + x1289 * x3168;
  const Real x3564 = x1026 * x3169 + x3563;
  w.x[251] = x3564;
  const Real x3580 = x1026 * x3185;
  w.x[252] = x3580;
  const Real x3582 = x1025 * x3104 - x1597 * x3036 + x1289 * x3184;
  w.x[253] = x3582;
  const Real x3597 = x1289 * x3200;
  w.x[254] = x3597;
  const Real x3600 = x1025 * x3124 - x1597 * x3045;
  w.x[255] = x3600;
  const Real x3614 = x3065 * x3506;
  w.x[256] = x3614;
  const Real x3619 = x3152 * x3532 + x3219 * x3541 + x3218 * x3519;
  const Real x3620 = x3371 * x3487 + x3619;
  w.x[257] = x3620;
  const Real x3630 = x3371 * x3490;
  w.x[258] = x3630;
  const Real x3637 = x3152 * x3535 + x3219 * x3544 + x3218 * x3524;
  w.x[259] = x3637;
  const Real x3651 = x3218 * x3529;
  w.x[260] = x3651;
  const Real x3654 = x3152 * x3538 + x3219 * x3547;
  w.x[261] = x3654;
  const Real x4111 = x1875 * x3413 + x4109 + x1929 * x3414;
  w.x[262] = x4111;
  const Real x4311 = x4093 - x4075 * x4260;
  w.x[263] = x4311;
  const Real x4336 = x4075 * x4261;
  w.x[264] = x4336;
  const Real x4115 = x1861 * x3385;
  w.x[265] = x4115;
  const Real x4124 = x1886 * x3303 + x4122 - x2307 * x3379;
  const Real x4125 = x532 * x3384 + x4124;
  w.x[266] = x4125;
  const Real x4130 = x532 * x3398;
  w.x[267] = x4130;
  const Real x4140 = x1886 * x3326 + x4138 - x2307 * x3393;
  w.x[268] = x4140;
  const Real x4144 = x2307 * x3407;
  w.x[269] = x4144;
  const Real x4154 = x1300 * x3200 + x1326 * x3124 + x1353 * x3201;
  const Real x4155 = x1886 * x3349 + x4154;
  w.x[270] = x4155;
  const Real x4165 = x1917 * x3386;
  w.x[271] = x4165;
  const Real x4176 = x536 * x3384 + x4174 + x1864 * x3385;
  w.x[272] = x4176;
}

ADAGEN_NOINLINE void part_1_2(Workspace& w) {
  ADAGEN_INPUTS
  const Real x334 = w.x[163];
  const Real x351 = w.x[155];
  const Real x356 = w.x[165];
  const Real x357 = w.x[164];
  const Real x532 = w.x[114];
  const Real x536 = w.x[86];
  const Real x1026 = w.x[117];
  const Real x1027 = w.x[156];
  const Real x1057 = w.x[55];
  const Real x1300 = w.x[91];
  const Real x1303 = w.x[66];
  const Real x1315 = w.x[89];
  const Real x1326 = w.x[92];
  const Real x1329 = w.x[65];
  const Real x1341 = w.x[67];
  const Real x1353 = w.x[121];
  const Real x1358 = w.x[88];
  const Real x1371 = w.x[90];
  const Real x1595 = w.x[125];
  const Real x1596 = w.x[157];
  const Real x1627 = w.x[59];
  const Real x1850 = w.x[160];
  const Real x1861 = w.x[158];
  const Real x1864 = w.x[97];
  const Real x1875 = w.x[130];
  const Real x1886 = w.x[132];
  const Real x1889 = w.x[95];
  const Real x1900 = w.x[96];
  const Real x1912 = w.x[159];
  const Real x1917 = w.x[98];
  const Real x1929 = w.x[131];
  const Real x2162 = w.x[166];
  const Real x2174 = w.x[161];
  const Real x2294 = w.x[162];
  const Real x2307 = w.x[137];
  const Real x2312 = w.x[99];
  const Real x2316 = w.x[100];
  const Real x2329 = w.x[101];
  const Real x2550 = w.x[173];
  const Real x2551 = w.x[170];
  const Real x2552 = w.x[169];
  const Real x2553 = w.x[168];
  const Real x2554 = w.x[167];
  const Real x2558 = w.x[171];
  const Real x2559 = w.x[174];
  const Real x2560 = w.x[172];
  const Real x2567 = w.x[20];
  const Real x3027 = w.x[176];
  const Real x3036 = w.x[177];
  const Real x3045 = w.x[178];
  const Real x3065 = w.x[179];
  const Real x3084 = w.x[180];
  const Real x3104 = w.x[181];
  const Real x3124 = w.x[182];
  const Real x3152 = w.x[183];
  const Real x3168 = w.x[184];
  const Real x3169 = w.x[185];
  const Real x3184 = w.x[186];
  const Real x3185 = w.x[187];
  const Real x3200 = w.x[188];
  const Real x3201 = w.x[189];
  const Real x3218 = w.x[233];
  const Real x3219 = w.x[230];
  const Real x3303 = w.x[190];
  const Real x3326 = w.x[191];
  const Real x3349 = w.x[192];
  const Real x3369 = w.x[227];
  const Real x3370 = w.x[228];
  const Real x3371 = w.x[237];
  const Real x3372 = w.x[229];
  const Real x3379 = w.x[193];
  const Real x3384 = w.x[196];
  const Real x3385 = w.x[197];
  const Real x3386 = w.x[198];
  const Real x3393 = w.x[194];
  const Real x3398 = w.x[199];
  const Real x3399 = w.x[200];
  const Real x3400 = w.x[201];
  const Real x3407 = w.x[195];
  const Real x3412 = w.x[202];
  const Real x3413 = w.x[211];
  const Real x3414 = w.x[214];
  const Real x3422 = w.x[238];
  const Real x3424 = w.x[248];
  const Real x3427 = w.x[249];
  const Real x3435 = w.x[203];
  const Real x3441 = w.x[206];
  const Real x3447 = w.x[212];
  const Real x3452 = w.x[204];
  const Real x3456 = w.x[207];
  const Real x3460 = w.x[215];
  const Real x3468 = w.x[208];
  const Real x3476 = w.x[213];
  const Real x3484 = w.x[221];
  const Real x3493 = w.x[216];
  const Real x3496 = w.x[205];
  const Real x3499 = w.x[209];
  const Real x3502 = w.x[217];
  const Real x3510 = w.x[210];
  const Real x3514 = w.x[218];
  const Real x3555 = w.x[250];
  const Real x3564 = w.x[251];
  const Real x3580 = w.x[252];
  const Real x3582 = w.x[253];
  const Real x3597 = w.x[254];
  const Real x3600 = w.x[255];
  const Real x3614 = w.x[256];
  const Real x3620 = w.x[257];
  const Real x3630 = w.x[258];
  const Real x3637 = w.x[259];
  const Real x3651 = w.x[260];
  const Real x3654 = w.x[261];
  const Real x3867 = w.x[220];
  const Real x3943 = w.x[225];
  const Real x4075 = w.x[239];
  const Real x4093 = w.x[241];
  const Real x4111 = w.x[262];
  const Real x4115 = w.x[265];
  const Real x4125 = w.x[266];
  const Real x4130 = w.x[267];
  const Real x4140 = w.x[268];
  const Real x4144 = w.x[269];
  const Real x4155 = w.x[270];
  const Real x4165 = w.x[271];
  const Real x4176 = w.x[272];
  const Real x4180 = w.x[242];
  const Real x4192 = w.x[243];
  const Real x4196 = w.x[244];
  const Real x4209 = w.x[245];
  const Real x4259 = w.x[219];
  const Real x4260 = w.x[222];
  const Real x4261 = w.x[223];
  const Real x4262 = w.x[231];
  const Real x4265 = w.x[224];
  const Real x4272 = w.x[226];
  const Real x4273 = w.x[232];
  const Real x4274 = w.x[235];
  const Real x4280 = w.x[234];
  const Real x4287 = w.x[236];
  const Real x4288 = w.x[240];
  const Real x4293 = w.x[246];
  const Real x4296 = w.x[247];
  const Real x4311 = w.x[263];
  const Real x4336 = w.x[264];
  const Real x4945 = w.x[175];
  // link 2 "shank": accelerations and constraint forces of loops below it are eliminated
  const Real x4297 = x4296 - x4293;
  require_more(w, x4297, 4.796163466380676e-21, kLoopFree, 5);
  const Real x3428 = x3369 - x3424;
  const Real x4177 = x4176 - x4165;
  const Real x4298 = 1 / x4297;
  const Real x3429 = x3370 - x2567 * x3422;
  const Real x4341 = x4111 - x4336 - x4273 * x4311;
  const Real x4127 = x4115 + x4125 + x1912 * x3386;
  const Real x4195 = x4180 + x4192 + x1864 * x3399 - x1917 * x3400;
  const Real x3430 = x3372 - 1.2 * x3422;
  const Real x4143 = x4130 + x4140 + x1861 * x3399 + x1912 * x3400;
  const Real x4212 = x4196 + x4209 + x536 * x3412 + x1864 * x3413;
  const Real x4213 = x4212 - x1917 * x3414;
  const Real x4317 = x4195 - x4177 * x4260;
  const Real x3567 = x3555 + x3564 - x2294 * x3379 + x2174 * x3384;
  const Real x3585 = x3580 + x3582 + x1595 * x3326 - x2294 * x3393;
  const Real x3603 = x3597 + x3600 + x1026 * x3201 + x1595 * x3349;
  const Real x3623 = x3614 + x3620 - x3427 * x3435 + x3428 * x3452;
  const Real x3640 = x3630 + x3637 + x3065 * x3510 - x3427 * x3441;
  const Real x3657 = x3651 + x3654 + x3371 * x3493 + x3065 * x3514;
  const Real x4391 = x1057 - x4075 * x4262 - x4274 * x4311;
  const Real x4158 = x4155 - x4144 + x532 * x3412 + x1861 * x3413;
  const Real x4159 = x1912 * x3414 + x4158;
  const Real x4314 = x4143 - x4127 * x4260;
  const Real x4455 = x4298 * (x4391 - x4288 * x4341);
  const Real x4353 = x4213 - x4177 * x4261 - x4273 * x4317;
  const Real x3587 = x2174 * x3398 + x3585 + x1850 * x3399;
  const Real x3605 = x3603 - x2294 * x3407 + x2174 * x3412;
  const Real x3642 = x3428 * x3456 + x3640 + x3429 * x3476;
  const Real x3659 = x3657 - x3427 * x3447 + x3428 * x3460;
  const Real x3569 = x1850 * x3385 + x3567 + x1596 * x3386;
  const Real x3663 = x3429 * x3468 + x3623 + x3430 * x3496 + x3569;
  const Real x4347 = x4159 - x4127 * x4261 - x4273 * x4314;
  const Real x4471 = x4287 * x4341 - x4288 * x4455;
  const Real x3607 = x1850 * x3413 + x3605 + x1596 * x3414;
  const Real x3664 = x1596 * x3400 + x3587 + (x3430 * x3499 + x3642);
  const Real x4323 = x3664 - x3663 * x4260;
  const Real x4411 = x4177 * x4262 + x4274 * x4317 + x4288 * x4353;
  const Real x4458 = x4298 * x4411;
  const Real x3665 = x3429 * x3484 + x3659 + x3430 * x3502 + x3607;
  const Real x4501 = x4272 * x4311 - x4274 * x4455 - x4273 * x4471;
  const Real x4401 = x4127 * x4262 + x4274 * x4314 + x4288 * x4347;
  const Real x4456 = x4298 * x4401;
  const Real x4365 = x3665 - x3663 * x4261 - x4273 * x4323;
  const Real x4429 = x1027 + x1057 * x3218 - x3663 * x4262;
  const Real x4477 = x4287 * x4353 + x4288 * x4458;
  const Real x4551 = x4075 * x4259 - x4262 * x4455 - x4261 * x4471;
  const Real x4552 = x4551 - x4260 * x4501;
  const Real x4474 = x4287 * x4347 + x4288 * x4456;
  const Real x4513 = x4272 * x4317 + x4274 * x4458 - x4273 * x4477;
  const Real x4462 = x4298 * (x4429 - x4274 * x4323 - x4288 * x4365);
  const Real x4713 = x4111 * x4471 + x1057 * x4455 + x4093 * x4501;
  const Real x4507 = x4272 * x4314 + x4274 * x4456 - x4273 * x4474;
  const Real x4569 = x4177 * x4259 + x4262 * x4458 - x4261 * x4477;
  const Real x4570 = x4569 - x4260 * x4513;
  const Real x3712 = x1627 * x3065 + x1341 * x3152 + x1315 * x3218;
  const Real x4483 = x4287 * x4365 - x4288 * x4462;
  const Real x4851 = x2550 - (x4075 * x4552 + x4713) + 0.18885420000000003;
  require_more(w, x4851, 0.0, kFactorization, 1);
  const Real x4560 = x4127 * x4259 + x4262 * x4456 - x4261 * x4474;
  const Real x4561 = x4560 - x4260 * x4507;
  const Real x4731 = x4111 * x4477 - x1057 * x4458 + x4093 * x4513;
  const Real x3714 = x1371 * x3219 + x3712 + x1900 * x3371;
  const Real x4525 = x4272 * x4323 - x4274 * x4462 - x4273 * x4483;
  const Real x4722 = x4111 * x4474 - x1057 * x4456 + x4093 * x4507;
  const Real x4791 = x2551 - (x4075 * x4561 + x4722);
  const Real x4852 = x2552 - (x4075 * x4570 + x4731) + -0.7000000000000001;
  const Real x3716 = x2316 * x3427 + x3714 - x2329 * x3428;
  const Real x3728 = x1300 * x3218 + x1326 * x3152 + x1353 * x3219;
  const Real x3746 = x1303 * x3218 + x1329 * x3152 - x1358 * x3219;
  const Real x4587 = x3663 * x4259 - x4262 * x4462 - x4261 * x4483;
  const Real x4588 = x4587 - x4260 * x4525;
  const Real x4747 = x4143 * x4507 + x4159 * x4474 + x4127 * x4561;
  const Real x4765 = x4195 * x4513 + x4213 * x4477 + x4177 * x4570;
  // joint 1 "knee": articulated-body inertia and bias force through it
  const Real x4860 = 1 / x4851;
  const Real x4865 = x4791 * x4860;
  const Real x4866 = x4852 * x4860;
  // link 2 "shank": accelerations and constraint forces of loops below it are eliminated
  const Real x3730 = x1886 * x3371 + x3728 + x2307 * x3427;
  const Real x3748 = x1889 * x3371 + x3746 - x2312 * x3427;
  const Real x4819 = x4111 * x4483 + x1057 * x4462 + x4093 * x4525;
  const Real x4753 = x4143 * x4513 + x4159 * x4477 + x4127 * x4570;
  const Real x3769 = x1875 * x3429 + x3716 + x1929 * x3430 + x2558;
  const Real x3732 = x532 * x3428 + x3730 + x1861 * x3429;
  const Real x4300 = x3867 * 1.7763568394002505e-15;
  require_more(w, x4265, x4300, kLoopFree, 3);
  const Real x3750 = x536 * x3428 + x3748 + x1864 * x3429;
  const Real x4301 = x3943 * 1.7763568394002505e-15;
  require_more(w, x4280, x4301, kLoopFree, 4);
  const Real x4825 = x4143 * x4525 + x4159 * x4483 + x4127 * x4588;
  const Real x4830 = x4195 * x4525 + x4213 * x4483 + x4177 * x4588;
  // joint 1 "knee": articulated-body inertia and bias force through it
  const Real x4897 = x2553 - x4747 + 3.5 - x4791 * x4865;
  const Real x4963 = x4897 - (x2554 - x4765 + 3.5 - x4852 * x4866);
  const Real x4965 = (x2162 - x4753 - x4791 * x4866) * x4945;
  const Real x4861 = tau[1] - (x3769 - (x4075 * x4588 + x4819) + x351);
  const Real x4862 = x4860 * x4861;
  // link 2 "shank": accelerations and constraint forces of loops below it are eliminated
  const Real x4857 = x1912 * x3430 + x3732 + x2559 - x4825 + x356;
  const Real x4858 = x3750 - x1917 * x3430 + x2560 - x4830 - x357;
  // joint 1 "knee": articulated-body inertia and bias force through it
  const Real x4982 = 0.4 * (x4897 - cosine[1] * (cosine[1] * x4963 - x4965));
  const Real x5013 = sine[1] * (x4857 + x4791 * x4862);
  const Real x5025 = 0.32735000000000003 + 0.4 * x4982;
  require_more(w, x5025, 0.0, kFactorization, 0);
  const Real x5019 = 0.4 * (x5013 + cosine[1] * (x4858 + x4852 * x4862));
  // joint 0 "hip": articulated-body inertia and bias force through it
  const Real x5036 = 1 / x5025 * (tau[0] - (tau[1] - x5019 + x334));
  w.result[0] = x5036;
  // joint 1 "knee": its acceleration, and that of the link beyond
  const Real x5046 = 0.4 * x5036;
  const Real x5048 = sine[1] * x5046;
  const Real x5050 = cosine[1] * x5046;
  const Real x5057 = x4862 + x4865 * x5048 + x4866 * x5050;
  const Real x5058 = x5057 - x5036;
  w.result[1] = x5058;
  // link 2 "shank": accelerations and constraint forces of loops below it
  const Real x5066 = x4561 * x5048 + x4570 * x5050 - x4552 * x5057;
  const Real x5093 = x5066 - x4588;
  const Real x5074 = x4507 * x5048 + x4513 * x5050 - x4501 * x5057;
  const Real x5094 = x5074 - x4525;
  const Real x5082 = x4474 * x5048 + x4477 * x5050 - x4471 * x5057;
  const Real x5095 = x5082 - x4483;
  const Real x5091 = x4456 * x5048 + x4458 * x5050 + x4455 * x5057;
  const Real x5097 = -(x4462 + x5091);
  w.result[11] = x5097;
  const Real x5106 = x3379 * x5093 + x3393 * x5094 + x3407 * x5095;
  const Real x5153 = x3427 - x5106;
  w.result[2] = x5153;
  const Real x5112 = x3384 * x5093 + x3398 * x5094 + x3412 * x5095;
  const Real x5154 = x3428 + x5112;
  w.result[3] = x5154;
  const Real x5117 = x3385 * x5093 + x3399 * x5094 + x3413 * x5095;
  const Real x5155 = x3429 + x5117;
  w.result[4] = x5155;
  const Real x5122 = x3303 * x5093 + x3326 * x5094 + x3349 * x5095;
  const Real x5156 = x3371 + x5122;
  w.result[5] = x5156;
  const Real x5127 = x3386 * x5093 + x3400 * x5094 + x3414 * x5095;
  const Real x5157 = x3430 + x5127;
  w.result[6] = x5157;
  const Real x5136 = x3027 * x5093 + x3036 * x5094 + x3045 * x5095;
  const Real x5158 = x3065 - x5136;
  w.result[7] = x5158;
  const Real x5142 = x3168 * x5093 + x3184 * x5094 + x3200 * x5095;
  const Real x5159 = x3218 + x5142;
  w.result[8] = x5159;
  const Real x5147 = x3084 * x5093 + x3104 * x5094 + x3124 * x5095;
  const Real x5160 = x3152 + x5147;
  w.result[9] = x5160;
  const Real x5152 = x3169 * x5093 + x3185 * x5094 + x3201 * x5095;
  const Real x5161 = x3219 + x5152;
  w.result[10] = x5161;
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
