// Forward dynamics of "fourbar" on 1 process, emitted by adagen 0.1.0 (solver.cpp.j2). Do not edit: emit anew.
//
// robot     "fourbar", 3 joints, 3 degrees of freedom, description sha256 4800d9bbec7e9c8eaf1d028c5dcc2b2c9b4ac7410509da822ae29051a7391834
// command   adagen ../models/fourbar.urdf --scene=../models/fourbar.toml --procs 1
// options   form segment, shape unrolled, scalar double, channel auto, fixed base, gravity 0.0, 0.0, -9.81
// links     adagen_program.cpp
// program   1 process; 0.0807 us predicted (default profile)
//           process 0: crank_pin .. rocker_pin
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
// To use it from a program of yours: compile this file with -DADAGEN_NO_MAIN and link it; fourbar_p1.h
// beside it is this part.
// C interface of the solver fourbar_p1: forward dynamics of "fourbar" on 1 process,
// emitted by adagen 0.1.0 (interface.h.j2). Do not edit: emit anew.
#ifndef ADAGEN_FOURBAR_P1_H
#define ADAGEN_FOURBAR_P1_H

enum {
  FOURBAR_P1_PROCESSES = 1,
  FOURBAR_P1_JOINTS = 3,
  FOURBAR_P1_NQ = 3,  // numbers in q
  FOURBAR_P1_NV = 3,  // in v and qdd
  FOURBAR_P1_NTAU = 3  // in tau
};

// Where each joint begins in q, and in v, tau and qdd.
enum {
  FOURBAR_P1_Q_crank_pin = 0,
  FOURBAR_P1_V_crank_pin = 0,  // joint 0, "crank_pin": revolute, 1 in q, 1 in v
  FOURBAR_P1_Q_coupler_pin = 1,
  FOURBAR_P1_V_coupler_pin = 1,  // joint 1, "coupler_pin": revolute, 1 in q, 1 in v
  FOURBAR_P1_Q_rocker_pin = 2,
  FOURBAR_P1_V_rocker_pin = 2  // joint 2, "rocker_pin": revolute, 1 in q, 1 in v
};

// Why a call failed, as fourbar_p1_reason tells of the status that it returned.
enum {
  FOURBAR_P1_FINE = 0,  // none
  FOURBAR_P1_NOT_FINITE = 1,  // q, v or tau of a joint is not a finite number
  FOURBAR_P1_ZERO_QUATERNION = 2,  // a joint's quaternion cannot be normalised
  FOURBAR_P1_FACTORIZATION = 3,  // inertias beside a joint differ too much for the scalar
  FOURBAR_P1_OVERFLOW = 4,  // a joint's acceleration is not a finite number
  FOURBAR_P1_NO_ANSWER = 5,  // a process did not answer within the time limit
  FOURBAR_P1_ENDED = 6,  // process 0 has ended the evaluations
  FOURBAR_P1_NOT_REFINED = 7,  // refinement does not converge
  FOURBAR_P1_GIMBAL_LOCK = 8,  // joints that are joined as one do not move in as many directions
  FOURBAR_P1_GROWTH = 9,  // a link beside a joint is too light for its neighbours
  FOURBAR_P1_NOT_SET = 16,  // what is to be set at run time is not finite, or is no mass
  FOURBAR_P1_TOO_FEW_STEPS = 11,  // refinement converges too slowly
  FOURBAR_P1_LOOP_OPEN = 12,  // a loop or coupling is not closed in this configuration
  FOURBAR_P1_LOOP_TORN = 13,  // this velocity tears a loop or coupling open
  FOURBAR_P1_LOOP_SINGULAR = 14,  // what a loop holds changes in this pose
  FOURBAR_P1_LOOP_FREE = 15  // loops leave a joint a motion that no inertia resists
};

#ifdef __cplusplus
extern "C" {
#endif
typedef struct fourbar_p1_solver fourbar_p1_solver;

// Joints in order, each with its place in the state: gives name, start and size in q and v of joint
// k, or returns 0 where there is none.
int fourbar_p1_joint(int k, const char** name, int* q, int* nq, int* v, int* nv);

// A solver, with all the memory that it will ever need: no other call allocates, waits or takes a
// lock. One solver is for one thread at a time. Returns null where there is no memory;
// fourbar_p1_failure(NULL) says so.
fourbar_p1_solver* fourbar_p1_open(void);

// One evaluation. q: 3 numbers, v and tau: 3 each, qdd: 3; joints in order, quaternions
// x y z w (normalised here), floating joints [linear; angular] in the body's frame.
// Returns 0, or a status that fourbar_p1_failure puts into words; no acceleration is written then.
int fourbar_p1_solve(fourbar_p1_solver* solver, const double* q, const double* v, const double* tau, double* qdd);

// What a status says: its reason, and which joint it is about, -1 for none.
int fourbar_p1_reason(int status);
int fourbar_p1_failed_joint(int status);

// The last failure of a solver in words, valid until the next call; of null, why the last open of this
// thread returned null.
const char* fourbar_p1_failure(const fourbar_p1_solver* solver);

void fourbar_p1_close(fourbar_p1_solver* solver);
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
constexpr int kJointCount = 3, kLinkCount = kJointCount + 1;
constexpr int kNq = 3, kNv = 3;
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
    {"ground", 0.0, {0.0, 0.0, 0.0},
     {0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0},
     {}},
    {"crank", 0.4, {0.0, 0.1, 0.0},
     {0.00136333, 0.0, 0.0, 0.0, 6e-05, 0.0, 0.0, 0.0, 0.00136333},
     {}},
    {"coupler", 1.0, {0.0, 0.25, 0.0},
     {0.0209083, 0.0, 0.0, 0.0, 0.00015, 0.0, 0.0, 0.0, 0.0209083},
     {}},
    {"rocker", 0.8, {0.0, 0.2, 0.0},
     {0.0107267, 0.0, 0.0, 0.0, 0.00012, 0.0, 0.0, 0.0, 0.0107267},
     {}},
} };

constexpr std::array<JointConstants, kJointCount> kJoints{ {
    {"crank_pin", JointKind::kRevolute, 0, 0, 1, 0, 1,
     {0.0, 1.0, 0.0, 0.0, 0.0, 1.0, 1.0, 0.0, 0.0},
     {0.0, 0.0, 0.0}, -1, 0.0, 0.0},
    {"coupler_pin", JointKind::kRevolute, 1, 1, 1, 1, 1,
     {1.0, 0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 1.0},
     {0.0, 0.2, 0.0}, -1, 0.0, 0.0},
    {"rocker_pin", JointKind::kRevolute, 0, 2, 1, 2, 1,
     {0.0, 1.0, 0.0, 0.0, 0.0, 1.0, 1.0, 0.0, 0.0},
     {0.45, 0.0, 0.0}, -1, 0.0, 0.0},
} };

[[maybe_unused]] constexpr std::array<OuterForce, kOuterCount> kOuterForces{};

// Loops, then couplings: what statuses name them by.
constexpr int kLoopCount = 1;
constexpr std::array<const char*, 1> kLoopNames{ {
    "pin",
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
  alignas(kCacheLine) std::array<Value, 3> angle{}, sine{}, cosine{};
  std::array<Value, kNqdd> result{};
  std::array<Real*, kPlanMessages> to{};          // messages to be sent
  std::array<const Real*, kPlanMessages> from{};  // messages received
  alignas(kCacheLine) std::array<Value, 0> x{};
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
// Process 0: 115 products, 70 sums, 4 quotients
// =================================================================================================

ADAGEN_NOINLINE void part_0_0(Workspace& w) {
  ADAGEN_INPUTS
  // joint 0 "crank_pin": placement, velocity and reference acceleration of its link
  const Real x11 = v[0] * v[0];
  const Real x8 = cosine[0] * 9.81;
  // joint 1 "coupler_pin": placement, velocity and reference acceleration of its link
  const Real x19 = v[0] + v[1];
  const Real x36 = x19 * x19;
  const Real x22 = sine[0] * 9.81 + x11 * 0.2;
  const Real x32 = x8 * sine[1] + cosine[1] * x22;
  const Real x27 = x8 * cosine[1] - sine[1] * x22;
  // joint 2 "rocker_pin": placement, velocity and reference acceleration of its link
  const Real x47 = v[2] * v[2];
  const Real x44 = 9.81 * cosine[2];
  // link 2 "coupler": force that the reference field takes
  const Real x76 = x27 * 0.25;
  // what a loop holds its two links by
  const Real x131 = v[0] * 0.2;
  const Real x125 = v[2] * 0.4;
  const Real x167 = cosine[0] * cosine[1] - sine[0] * sine[1];
  const Real x135 = sine[1] * x131;
  const Real x170 = sine[0] * cosine[1] + cosine[0] * sine[1];
  const Real x205 = 9.81 * sine[2] + x47 * 0.4;
  const Real x139 = cosine[1] * x131 + x19 * 0.5;
  const Real x191 = cosine[2] * x167 + sine[2] * x170;
  const Real x195 = cosine[2] * x170 - sine[2] * x167;
  const Real x106 = sine[1] * 0.5;
  const Real x109 = 0.2 + cosine[1] * 0.5;
  const Real x145 = cosine[1] * x139 + sine[1] * x135;
  const Real x221 = x44 * x195 + x191 * x205;
  const Real x150 = cosine[1] * x135 - sine[1] * x139;
  // joint 1 "coupler_pin": inertia and bias force of what is beyond, its own motion left open
  const Real x232 = cosine[1] * 0.25;
  const Real x238 = 0.0834083 + 0.2 * x232;
  // link 0 "ground": accelerations and constraint forces of loops below it are eliminated
  const Real x293 = sine[1] * 0.2 * 4.0;
  const Real x290 = 2.0 * (0.5 + cosine[1] * 0.2);
  const Real x300 = x293 * x293;
  const Real x291 = 2.0 * (0.4 * x191);
  const Real x295 = 0.4 * x195 * 4.0;
  const Real x296 = 2.0 * (x44 * x191 - x195 * x205 - x27);
  // what a loop holds its two links by
  const Real x121 = cosine[0] * x106 + sine[0] * x109 - sine[2] * 0.4;
  const Real x119 = cosine[0] * x109 - sine[0] * x106;
  const Real x120 = 0.45 + cosine[2] * 0.4 - x119;
  const Real x163 = cosine[0] * x145 + sine[0] * x150 - cosine[2] * x125;
  const Real x161 = cosine[0] * x150 - sine[0] * x145 + sine[2] * x125;
  const Real x187 = 1e-08 - (x120 * x120 + x121 * x121);
  require_more(w, x187, 0.0, kLoopOpen, 3);
  const Real x186 = (x11 + v[1] * v[1] + x47 + 1.0) * 1.0000000000000002e-06;
  const Real x188 = x186 - (x161 * x161 + x163 * x163);
  require_more(w, x188, 0.0, kLoopTorn, 3);
  // joint 1 "coupler_pin": inertia and bias force of what is beyond, its own motion left open
  const Real x267 = cosine[1] * x27 + sine[1] * (x32 + x36 * 0.25);
  // link 0 "ground": accelerations and constraint forces of loops below it are eliminated
  const Real x297 = (x32 + x36 * 0.5 - x221) * 4.0;
  const Real x304 = sign_of(x290) * sqrt_of(x290 * x290 + x300);
  const Real x305 = x290 + x304;
  const Real x343 = 1 / x304;
  const Real x357 = x304 * x304;
  require_more(w, x357, 9.999999999999998e-15, kSingularPose, 3);
  const Real x307 = x300 + x305 * x305;
  const Real x309 = 2.0 * (1 / x307);
  const Real x316 = x309 * (x291 * x305 + x293 * x295);
  const Real x324 = x305 * x309;
  const Real x333 = x309 * (x296 * x305 - x293 * x297);
  const Real x323 = x295 - x293 * x316;
  const Real x322 = x305 * x316 - x291;
  const Real x340 = 1 / x323;
  const Real x360 = x323 * x323;
  require_more(w, x360, 9.999999999999998e-15, kSingularPose, 3);
  const Real x341 = x293 * x324 * x340;
  const Real x342 = (x297 + x293 * x333) * x340;
  const Real x368 = 0.042726700000000006 * x341;
  const Real x348 = x343 * (1.0 - x305 * x324 - x322 * x341);
  const Real x353 = x343 * (x296 - x305 * x333 - x322 * x342);
  // joint 0 "crank_pin": inertia and bias force of what is beyond, its own motion left open
  const Real x287 = x76 + 0.2 * x267 + x8 * 0.04000000000000001 + tau[0];
  // link 0 "ground": accelerations and constraint forces of loops below it are eliminated
  const Real x367 = (x238 - 0.2 * (-0.2 - x232) + 0.00536333) * x348;
  const Real x370 = x238 + x367;
  const Real x382 = (x44 * 0.16000000000000003 + tau[2]) * x341 - x287 * x348;
  const Real x366 = 40000.0 - (x348 * x348 + x341 * x341);
  require_more(w, x366, 0.0, kSingularPose, 3);
  const Real x387 = x353 * x370 + x342 * x368;
  const Real x375 = x348 * x370 + x341 * x368 + 0.0834083;
  const Real x377 = x375 + x238 * x348;
  require_more(w, x377, 0.0, kLoopFree, 1);
  const Real x390 = (x382 - (x76 + tau[1]) + x387) * (1 / x377);
  const Real x391 = -x390;
  w.result[1] = x391;
  // link 0 "ground": accelerations and constraint forces of loops below it
  const Real x396 = x353 - x348 * x390;
  w.result[0] = x396;
  const Real x397 = x341 * x390 - x342;
  w.result[2] = x397;
}

// =================================================================================================
// Process 0 in a singular pose: 129 products, 80 sums, 5 quotients
// =================================================================================================

ADAGEN_NOINLINE void part_1_0(Workspace& w) {
  ADAGEN_INPUTS
  // joint 0 "crank_pin": placement, velocity and reference acceleration of its link
  const Real x11 = v[0] * v[0];
  const Real x8 = cosine[0] * 9.81;
  // joint 1 "coupler_pin": placement, velocity and reference acceleration of its link
  const Real x19 = v[0] + v[1];
  const Real x36 = x19 * x19;
  const Real x22 = sine[0] * 9.81 + x11 * 0.2;
  const Real x27 = x8 * cosine[1] - sine[1] * x22;
  const Real x32 = x8 * sine[1] + cosine[1] * x22;
  // joint 2 "rocker_pin": placement, velocity and reference acceleration of its link
  const Real x47 = v[2] * v[2];
  const Real x44 = 9.81 * cosine[2];
  // link 2 "coupler": force that the reference field takes
  const Real x76 = x27 * 0.25;
  // what a loop holds its two links by
  const Real x131 = v[0] * 0.2;
  const Real x125 = v[2] * 0.4;
  const Real x167 = cosine[0] * cosine[1] - sine[0] * sine[1];
  const Real x135 = sine[1] * x131;
  const Real x170 = sine[0] * cosine[1] + cosine[0] * sine[1];
  const Real x205 = 9.81 * sine[2] + x47 * 0.4;
  const Real x139 = cosine[1] * x131 + x19 * 0.5;
  const Real x191 = cosine[2] * x167 + sine[2] * x170;
  const Real x195 = cosine[2] * x170 - sine[2] * x167;
  const Real x106 = sine[1] * 0.5;
  const Real x109 = 0.2 + cosine[1] * 0.5;
  const Real x145 = cosine[1] * x139 + sine[1] * x135;
  const Real x150 = cosine[1] * x135 - sine[1] * x139;
  const Real x221 = x44 * x195 + x191 * x205;
  // joint 1 "coupler_pin": inertia and bias force of what is beyond, its own motion left open
  const Real x232 = cosine[1] * 0.25;
  const Real x238 = 0.0834083 + 0.2 * x232;
  // link 0 "ground": accelerations and constraint forces of loops below it are eliminated
  const Real x293 = sine[1] * 0.2 * 4.0;
  const Real x290 = 2.0 * (0.5 + cosine[1] * 0.2);
  const Real x291 = 2.0 * (0.4 * x191);
  const Real x295 = 0.4 * x195 * 4.0;
  const Real x298 = x291 * x291;
  // what a loop holds its two links by
  const Real x121 = cosine[0] * x106 + sine[0] * x109 - sine[2] * 0.4;
  const Real x119 = cosine[0] * x109 - sine[0] * x106;
  const Real x120 = 0.45 + cosine[2] * 0.4 - x119;
  const Real x163 = cosine[0] * x145 + sine[0] * x150 - cosine[2] * x125;
  const Real x161 = cosine[0] * x150 - sine[0] * x145 + sine[2] * x125;
  const Real x187 = 1e-08 - (x120 * x120 + x121 * x121);
  require_more(w, x187, 0.0, kLoopOpen, 3);
  const Real x186 = (x11 + v[1] * v[1] + x47 + 1.0) * 1.0000000000000002e-06;
  const Real x188 = x186 - (x161 * x161 + x163 * x163);
  require_more(w, x188, 0.0, kLoopTorn, 3);
  // joint 1 "coupler_pin": inertia and bias force of what is beyond, its own motion left open
  const Real x267 = cosine[1] * x27 + sine[1] * (x32 + x36 * 0.25);
  // link 0 "ground": accelerations and constraint forces of loops below it are eliminated
  const Real x303 = sign_of(x290) * sqrt_of(1.0 + x290 * x290 + x298);
  const Real x304 = x290 + x303;
  const Real x337 = x303 * x303;
  require_more(w, x337, 9.999999999999998e-15, kLoopSingular, 3);
  const Real x307 = 1.0 + x298 + x304 * x304;
  const Real x342 = 2.0 * (x44 * x191 - x195 * x205 - x27);
  const Real x348 = x342 * (1 / x303);
  const Real x309 = 2.0 * (1 / x307);
  const Real x316 = x309 * (x293 * x304 + x291 * x295);
  const Real x323 = x295 - x291 * x316;
  const Real x327 = x323 * x323;
  const Real x343 = (x32 + x36 * 0.5 - x221) * 4.0;
  const Real x330 = sign_of(x316) * sqrt_of(x316 * x316 + x327);
  const Real x331 = x316 + x330;
  const Real x340 = x330 * x330;
  require_more(w, x340, 9.999999999999998e-15, kLoopSingular, 3);
  const Real x333 = x327 + x331 * x331;
  const Real x356 = 1 / x330 * (x343 + (x304 * x316 - x293) * x348);
  const Real x335 = 2.0 * (1 / x333);
  const Real x358 = x323 * x335;
  const Real x364 = x335 * (x331 * x356);
  const Real x359 = x331 * x358;
  const Real x366 = x323 * x364;
  const Real x362 = 1.0 - x323 * x358;
  const Real x367 = x356 - x331 * x364;
  const Real x373 = x309 * (x359 + x291 * x362);
  const Real x386 = x309 * (x367 + x304 * x348 + x291 * x366);
  const Real x375 = x304 * x373;
  const Real x379 = x373 - x359;
  const Real x391 = x367 - x386;
  const Real x380 = x362 - x291 * x373;
  const Real x390 = x348 - x304 * x386;
  const Real x392 = x291 * x386 - x366;
  // joint 0 "crank_pin": inertia and bias force of what is beyond, its own motion left open
  const Real x287 = x76 + 0.2 * x267 + x8 * 0.04000000000000001 + tau[0];
  // link 0 "ground": accelerations and constraint forces of loops below it are eliminated
  const Real x393 = (x238 - 0.2 * (-0.2 - x232) + 0.00536333) * x375;
  const Real x395 = x393 + x238 * x379;
  const Real x398 = x238 * x375 + 0.0834083 * x379;
  const Real x399 = 0.042726700000000006 * x380;
  const Real x406 = x287 * x375 + (x76 + tau[1]) * x379;
  const Real x420 = x375 * x395 + x379 * x398 + x380 * x399;
  require_more(w, x420, 0.0, kLoopFree, 0);
  const Real x414 = x390 * x395 + x391 * x398 + x392 * x399;
  const Real x415 = x414 - ((x44 * 0.16000000000000003 + tau[2]) * x380 + x406);
  const Real x422 = x415 * (1 / x420);
  // link 0 "ground": accelerations and constraint forces of loops below it
  const Real x430 = x390 - x375 * x422;
  w.result[0] = x430;
  const Real x431 = x391 - x379 * x422;
  w.result[1] = x431;
  const Real x432 = x392 - x380 * x422;
  w.result[2] = x432;
}

// ---- 5. processes -------------------------------------------------------------------------------

// Process 0: 3 of 3 joints: "crank_pin", "coupler_pin", "rocker_pin"
constexpr std::array<int, 3> kRead_0{0, 1, 2};
constexpr std::array<int, 3> kOwned_0{0, 1, 2};

void run_0([[maybe_unused]] Workspace& w, [[maybe_unused]] Channel& channel) {
  ADAGEN_INPUTS
  stamp(0);
  take_sines_and_cosines<3>(q + 0, w.sine.data(), w.cosine.data());
  part_0_0(w);
  stamp(1);
  stamp(2);
  stamp(3);
  if (__builtin_expect(w.status != kFine || !all(unlike_zero(w.result.data() + 0, 3) == 0), 0)) {
    // The state's own faults are named before all others.
    const int found = std::exchange(w.status, kFine);
    name_what_is_not_finite(w, kRead_0, kOwned_0);
    Channel::fail(w.status, found);
    name_what_overflows(w, kOwned_0);
  }
  if (w.status != kFine) return;
  std::copy_n(w.result.data() + 0, 3, w.qdd + 0);
}


// What is done instead in a pose in which a mobility cannot be taken for an inertia.
void recover_0([[maybe_unused]] Workspace& w, [[maybe_unused]] Channel& channel) {
  ADAGEN_INPUTS
  stamp(0);
  take_sines_and_cosines<3>(q + 0, w.sine.data(), w.cosine.data());
  part_1_0(w);
  stamp(1);
  stamp(2);
  stamp(3);
  if (__builtin_expect(w.status != kFine || !all(unlike_zero(w.result.data() + 0, 3) == 0), 0)) {
    // The state's own faults are named before all others.
    const int found = std::exchange(w.status, kFine);
    name_what_is_not_finite(w, kRead_0, kOwned_0);
    Channel::fail(w.status, found);
    name_what_overflows(w, kOwned_0);
  }
  if (w.status != kFine) return;
  std::copy_n(w.result.data() + 0, 3, w.qdd + 0);
}

[[maybe_unused]] constexpr std::array<void (*)(Workspace&, Channel&), kProcesses> kRun{run_0};
constexpr std::array<void (*)(Workspace&, Channel&), 1> kRecover{recover_0};

// What each process reads of q and v, the velocity entries whose qdd is its own, and whose tau it
// reads.
constexpr std::array<Range, 1> kReadQ_0{ {{0, 3}} };
constexpr std::array<Range, 1> kReadV_0{ {{0, 3}} };
constexpr std::array<Range, 1> kOwn_0{ {{0, 3}} };
constexpr std::array<Range, 1> kTorque_0{ {{0, 3}} };
[[maybe_unused]] constexpr std::array<ProcessInfo, kProcesses> kProcess{ {
    {{1, kReadQ_0.data()}, {1, kReadV_0.data()}, {1, kOwn_0.data()}, {1, kTorque_0.data()}},
} };

}  // namespace

#include "adagen/no_parameters.hpp"
#include "adagen/solver_alone.hpp"
#include "adagen/open_alone.hpp"

static_assert(FOURBAR_P1_NQ == kNq && FOURBAR_P1_NV == kNv && FOURBAR_P1_NTAU == kNtau);
static_assert(int(FOURBAR_P1_FINE) == int(kFine));
static_assert(int(FOURBAR_P1_NOT_FINITE) == int(kNotFinite));
static_assert(int(FOURBAR_P1_ZERO_QUATERNION) == int(kZeroQuaternion));
static_assert(int(FOURBAR_P1_FACTORIZATION) == int(kFactorization));
static_assert(int(FOURBAR_P1_OVERFLOW) == int(kOverflow));
static_assert(int(FOURBAR_P1_NO_ANSWER) == int(kNoAnswer));
static_assert(int(FOURBAR_P1_ENDED) == int(kEnded));
static_assert(int(FOURBAR_P1_NOT_REFINED) == int(kNotRefined));
static_assert(int(FOURBAR_P1_GIMBAL_LOCK) == int(kGimbalLock));
static_assert(int(FOURBAR_P1_GROWTH) == int(kGrowth));
static_assert(int(FOURBAR_P1_NOT_SET) == int(kNotSet));
static_assert(int(FOURBAR_P1_TOO_FEW_STEPS) == int(kTooFewSteps));
static_assert(int(FOURBAR_P1_LOOP_OPEN) == int(kLoopOpen));
static_assert(int(FOURBAR_P1_LOOP_TORN) == int(kLoopTorn));
static_assert(int(FOURBAR_P1_LOOP_SINGULAR) == int(kLoopSingular));
static_assert(int(FOURBAR_P1_LOOP_FREE) == int(kLoopFree));

struct fourbar_p1_solver : Solver {};

extern "C" {

int fourbar_p1_joint(int k, const char** name, int* q, int* nq, int* v, int* nv) {
  if (k < 0 || k >= kJointCount) return 0;
  const JointConstants& joint = kJoints[k];
  *name = joint.name, *q = joint.q, *nq = joint.nq, *v = joint.v, *nv = joint.nv;
  return 1;
}

fourbar_p1_solver* fourbar_p1_open(void) { return opened<fourbar_p1_solver>(); }

int fourbar_p1_solve(fourbar_p1_solver* solver, const double* q, const double* v, const double* tau, double* qdd) {
  return solver->solve(q, v, tau, qdd);
}

int fourbar_p1_reason(int status) { return failure_kind(status); }

int fourbar_p1_failed_joint(int status) { return is_of_joint(failure_kind(status)) ? failure_place(status) : -1; }

const char* fourbar_p1_failure(const fourbar_p1_solver* solver) {
  return solver == nullptr ? open_failure.c_str() : solver->text.c_str();
}

void fourbar_p1_close(fourbar_p1_solver* solver) {
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
    {"kinematics", 2, -1},
    {"assembly", 0, -1},
    {"disassembly", 0, -1},
} };
constexpr std::array<adagen::Table<adagen::Stage>, kProcesses> kStages{ {
    {kStages_0.data(), 3},
} };

// Joints that close loops, each between a frame of its first link and one of its second; z is its
// axis. Then joints whose coordinates are coupled.
constexpr Number kLoop_0[]{1.0, 0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 1.0, 0.0, 0.5, 0.0,
    1.0, 0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 1.0, 0.0, 0.4, 0.0};
constexpr std::array<adagen::Loop<Number>, 1> kLoops{ {
    {kLoopNames[0], 2, 3, kLoop_0, kLoop_0 + 9, kLoop_0 + 12, kLoop_0 + 21, 7u, 3u, false},
} };

// As the cost profile default has them.
constexpr adagen::Hop kWindowHop{0, 159, 0.437};
constexpr adagen::Hop kMessageHop{26, 228, 0.644};

}  // namespace

// Compiled for size: it runs once.
[[gnu::cold]] int main(int count, char** words) {
  const adagen::Description<Number> description{
      "fourbar", "auto", kProcesses, 1, kNq, kNv, kNtau, kNqdd, kRefine,
      false, kAlone, kBatch, kCertified, false, false, kTolerance, kGravity.data(),
      table(kJoints), table(kLinks), table(kOuterForces), {kLoops.data(), kLoopCount}, {}, {}, table(kMessages), kStages.data(), kWindowHop,
      kMessageHop};
  auto* const solver = new ThisSolver;
  const int status = adagen::program(description, *solver, count, words);
  delete solver;
  return status;
}
#endif  // ADAGEN_NO_MAIN
