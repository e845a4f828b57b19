// Forward dynamics of "fourbar" on 1 process, emitted by adagen 0.1.0 (solver.cpp.j2). Do not edit: generate again. Licence: yours to choose.
// robot     "fourbar", 3 joints, 3 degrees of freedom, description sha256 4800d9bbec7e9c8eaf1d028c5dcc2b2c9b4ac7410509da822ae29051a7391834
// command   adagen ../models/fourbar.urdf --scene=../models/fourbar.toml --procs 1
// input     scene, sha256 0325233a36e76e4c778daddeedd8a5bf9b6954f1680ed02dfb94e4ffe29019ee
// input     profile default, sha256 fe36af9ff4727e4941af0e7182db7f87cd64c54109bc287302f720e9ad83c3a8
// options   form segment (articulated-body algorithm), shape unrolled (spatial vectors [angular; linear] in link frames whose joint axes are z), scalar double, channel auto, fixed base, gravity 0.0, 0.0, -9.81
// links     adagen_program.cpp; or, compiled with -DADAGEN_NO_MAIN, a program of yours that includes fourbar_p1.h
// program   1 process; 0.0538 us predicted (default profile)
//           process 0: crank_pin .. rocker_pin
//
// Closed loops: accelerations of their joints and constraint forces stay unknown until the last link that
// these joints have in common, where they are eliminated (docs/explanation/loops.md).

#include "fourbar_p1.h"
#define ADAGEN_CALL(word) fourbar_p1_##word
#define ADAGEN_NAMED(WORD) FOURBAR_P1_##WORD
#define ADAGEN_LOOPS
#define ADAGEN_RECOVERS
#include "adagen/settings.hpp"

namespace { struct fourbar_p1_settings : PlainSettings {
  static constexpr int kVersion = 100, kJointCount = 3, kNq = 3, kNv = 3;
  [[maybe_unused]] static constexpr const char* kRobot = "fourbar";
}; }  // namespace: a program may load several solvers of one name

#include "adagen/constants.hpp"

constexpr std::array<LinkConstants, kLinkCount> kLinks{ {
    {"ground", 0.0, {0.0, 0.0, 0.0}},
    {"crank", 0.4, {0.0, 0.1, 0.0},
     {0.00136333, 0.0, 0.0, 0.0, 6e-05, 0.0, 0.0, 0.0, 0.00136333}},
    {"coupler", 1.0, {0.0, 0.25, 0.0},
     {0.0209083, 0.0, 0.0, 0.0, 0.00015, 0.0, 0.0, 0.0, 0.0209083}},
    {"rocker", 0.8, {0.0, 0.2, 0.0},
     {0.0107267, 0.0, 0.0, 0.0, 0.00012, 0.0, 0.0, 0.0, 0.0107267}}}};

constexpr std::array<JointConstants, kJointCount> kJoints{ {
    {"crank_pin", JointKind::kRevolute, 0, 0, 1, 0, 1,
     {0.0, 1.0, 0.0, 0.0, 0.0, 1.0, 1.0, 0.0, 0.0}, {0.0, 0.0, 0.0}},
    {"coupler_pin", JointKind::kRevolute, 1, 1, 1, 1, 1,
     {1.0, 0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 1.0}, {0.0, 0.2, 0.0}},
    {"rocker_pin", JointKind::kRevolute, 0, 2, 1, 2, 1,
     {0.0, 1.0, 0.0, 0.0, 0.0, 1.0, 1.0, 0.0, 0.0}, {0.45, 0.0, 0.0}}}};

// Loops, then couplings: what statuses name them by.
constexpr int kLoopCount = 1;
constexpr std::array<const char*, 1> kLoopNames{ {
    "pin"}};

// ---- functions ----------------------------------------------------------------------------------

#include "adagen/far_angles.hpp"
#include "adagen/no_channel.hpp"
#include "adagen/unrolled_memory.hpp"

namespace {

struct Workspace : StraightMemory<8, 0, 0> {};

}  // namespace

#include "adagen/unrolled_numbers.hpp"
#include "adagen/unrolled_sines.hpp"
#include "adagen/unrolled.hpp"
#include "adagen/unrolled_functions.hpp"

namespace {

// Each function is a straight line. A value is called x and its number in the expression graph; zeros
// and constants are folded in, common subexpressions are shared, and dead code is left out.
// Frames are the links' own; accelerations are deviations from the field that the links would have
// with all joint accelerations zero.

// =================================================================================================
// Process 0: 82 products, 57 sums, 2 quotients
// =================================================================================================

ADAGEN_NOINLINE ADAGEN_AS_IT_STANDS void part_0_0(Workspace& w) {
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
  // link 2 "coupler": bias force in the reference field
  const Real x76 = x27 * 0.25;
  // constraint rows of a loop at its two links
  const Real x137 = cosine[0] * cosine[1] - sine[0] * sine[1];
  const Real x140 = sine[0] * cosine[1] + cosine[0] * sine[1];
  const Real x157 = 9.81 * sine[2] + x47 * 0.4;
  const Real x147 = cosine[2] * x140 - sine[2] * x137;
  const Real x143 = cosine[2] * x137 + sine[2] * x140;
  const Real x178 = 0.4 * x147;
  const Real x163 = 0.4 * x143;
  const Real x106 = sine[1] * 0.5;
  const Real x109 = 0.2 + cosine[1] * 0.5;
  const Real x176 = x44 * x147 + x143 * x157;
  const Real x121 = cosine[0] * x106 + sine[0] * x109 - sine[2] * 0.4;
  const Real x119 = cosine[0] * x109 - sine[0] * x106;
  const Real x120 = 0.45 + cosine[2] * 0.4 - x119;
  // joint 1 "coupler_pin": inertia and bias force of what is beyond; its acceleration is an unknown
  const Real x198 = sine[1] * 0.2;
  const Real x187 = cosine[1] * 0.25;
  const Real x197 = 0.5 + cosine[1] * 0.2;
  const Real x193 = 0.0834083 + 0.2 * x187;
  const Real x234 = 0.0834083 + 0.2 * (0.2 + x187 + x187) + 0.00536333;
  const Real x222 = cosine[1] * x27 + sine[1] * (x32 + x36 * 0.25);
  // link 0 "ground": accelerations and constraint forces of loops below it are eliminated
  const Real x259 = 1 / x178;
  const Real x260 = x198 * x259;
  const Real x262 = (x32 + x36 * 0.5 - x176) * x259;
  const Real x286 = 0.042726700000000006 * x260;
  const Real x249 = v[1] * 0.5 + v[0] * x197 - v[2] * x163;
  // constraint rows of a loop at its two links
  const Real x129 = 1e-08 - (x120 * x120 + x121 * x121);
  require_more(w, x129, 0.0, kLoopOpen, 3);
  // link 0 "ground": accelerations and constraint forces of loops below it are eliminated
  const Real x253 = v[2] * x178 - v[0] * x198;
  // constraint rows of a loop at its two links
  const Real x165 = x44 * x143 - x147 * x157 - x27;
  // link 0 "ground": accelerations and constraint forces of loops below it are eliminated
  const Real x272 = 2.0 * (x197 - x163 * x260);
  const Real x273 = 2.0 * (x165 + x163 * x262);
  const Real x265 = x178 * x178 * 16.0;
  require_more(w, x265, 9.999999999999998e-15, kSingularPose, 3);
  const Real x311 = x234 * 1e-08;
  const Real x287 = x193 - 0.0834083 * x272;
  const Real x298 = (x44 * 0.16000000000000003 + tau[2]) * x260;
  // constraint rows of a loop at its two links
  const Real x133 = (x11 + v[1] * v[1] + x47 + 1.0) * 1.0000000000000002e-06;
  // link 0 "ground": accelerations and constraint forces of loops below it are eliminated
  const Real x257 = x133 - (x249 * x249 + x253 * x253);
  require_more(w, x257, 0.0, kLoopTorn, 3);
  // joint 0 "crank_pin": inertia and bias force of what is beyond; its acceleration is an unknown
  const Real x242 = x76 + 0.2 * x222 + x8 * 0.04000000000000001 + tau[0];
  // link 0 "ground": accelerations and constraint forces of loops below it are eliminated
  const Real x283 = 40000.0 - (x272 * x272 + x260 * x260);
  require_more(w, x283, 0.0, kSingularPose, 3);
  const Real x307 = (x76 + tau[1]) * x272 - x298 - x242;
  const Real x294 = x260 * x286 - x272 * x287 + x234;
  const Real x295 = x294 - x193 * x272;
  require_more(w, x295, x311, kSingularPose, 0);
  const Real x312 = (x307 - (x273 * x287 + x262 * x286)) * (1 / x295);
  const Real x313 = -x312;
  w.result[0] = x313;
  // link 0 "ground": accelerations and constraint forces of loops below it
  const Real x318 = x272 * x312 - x273;
  w.result[1] = x318;
  const Real x320 = -(x262 + x260 * x312);
  w.result[2] = x320;
}

// =================================================================================================
// Process 0 in a singular pose: 127 products, 79 sums, 5 quotients
// =================================================================================================

ADAGEN_NOINLINE ADAGEN_AS_IT_STANDS void part_1_0(Workspace& w) {
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
  // link 2 "coupler": bias force in the reference field
  const Real x76 = x27 * 0.25;
  // constraint rows of a loop at its two links
  const Real x137 = cosine[0] * cosine[1] - sine[0] * sine[1];
  const Real x140 = sine[0] * cosine[1] + cosine[0] * sine[1];
  const Real x157 = 9.81 * sine[2] + x47 * 0.4;
  const Real x143 = cosine[2] * x137 + sine[2] * x140;
  const Real x147 = cosine[2] * x140 - sine[2] * x137;
  const Real x163 = 0.4 * x143;
  const Real x178 = 0.4 * x147;
  const Real x176 = x44 * x147 + x143 * x157;
  const Real x106 = sine[1] * 0.5;
  const Real x109 = 0.2 + cosine[1] * 0.5;
  // joint 1 "coupler_pin": inertia and bias force of what is beyond; its acceleration is an unknown
  const Real x198 = sine[1] * 0.2;
  const Real x197 = 0.5 + cosine[1] * 0.2;
  const Real x187 = cosine[1] * 0.25;
  const Real x193 = 0.0834083 + 0.2 * x187;
  const Real x234 = 0.0834083 + 0.2 * (0.2 + x187 + x187) + 0.00536333;
  const Real x222 = cosine[1] * x27 + sine[1] * (x32 + x36 * 0.25);
  // link 0 "ground": accelerations and constraint forces of loops below it are eliminated
  const Real x262 = x198 * 4.0;
  const Real x259 = 2.0 * x197;
  const Real x260 = 2.0 * x163;
  const Real x264 = x178 * 4.0;
  const Real x267 = x260 * x260;
  // constraint rows of a loop at its two links
  const Real x121 = cosine[0] * x106 + sine[0] * x109 - sine[2] * 0.4;
  const Real x119 = cosine[0] * x109 - sine[0] * x106;
  const Real x120 = 0.45 + cosine[2] * 0.4 - x119;
  const Real x129 = 1e-08 - (x120 * x120 + x121 * x121);
  require_more(w, x129, 0.0, kLoopOpen, 3);
  // link 0 "ground": accelerations and constraint forces of loops below it are eliminated
  const Real x249 = v[1] * 0.5 + v[0] * x197 - v[2] * x163;
  const Real x253 = v[2] * x178 - v[0] * x198;
  const Real x272 = sign_of(x259) * sqrt_of(1.0 + x259 * x259 + x267);
  const Real x273 = x259 + x272;
  const Real x306 = x272 * x272;
  require_more(w, x306, 9.999999999999998e-15, kLoopSingular, 3);
  // constraint rows of a loop at its two links
  const Real x133 = (x11 + v[1] * v[1] + x47 + 1.0) * 1.0000000000000002e-06;
  // link 0 "ground": accelerations and constraint forces of loops below it are eliminated
  const Real x257 = x133 - (x249 * x249 + x253 * x253);
  require_more(w, x257, 0.0, kLoopTorn, 3);
  const Real x276 = 1.0 + x267 + x273 * x273;
  const Real x311 = 2.0 * (x44 * x143 - x147 * x157 - x27);
  const Real x317 = x311 * (1 / x272);
  const Real x278 = 2.0 * (1 / x276);
  const Real x285 = x278 * (x262 * x273 + x260 * x264);
  const Real x292 = x264 - x260 * x285;
  const Real x296 = x292 * x292;
  const Real x312 = (x32 + x36 * 0.5 - x176) * 4.0;
  const Real x299 = sign_of(x285) * sqrt_of(x285 * x285 + x296);
  const Real x300 = x285 + x299;
  const Real x308 = x299 * x299;
  require_more(w, x308, 9.999999999999998e-15, kLoopSingular, 3);
  const Real x302 = x296 + x300 * x300;
  const Real x325 = 1 / x299 * (x312 + (x273 * x285 - x262) * x317);
  const Real x304 = 2.0 * (1 / x302);
  const Real x327 = x292 * x304;
  const Real x333 = x304 * (x300 * x325);
  const Real x328 = x300 * x327;
  const Real x335 = x292 * x333;
  const Real x331 = 1.0 - x292 * x327;
  const Real x336 = x325 - x300 * x333;
  const Real x342 = x278 * (x328 + x260 * x331);
  const Real x355 = x278 * (x336 + x273 * x317 + x260 * x335);
  const Real x344 = x273 * x342;
  const Real x348 = x342 - x328;
  const Real x360 = x336 - x355;
  const Real x349 = x331 - x260 * x342;
  const Real x359 = x317 - x273 * x355;
  const Real x361 = x260 * x355 - x335;
  // joint 0 "crank_pin": inertia and bias force of what is beyond; its acceleration is an unknown
  const Real x242 = x76 + 0.2 * x222 + x8 * 0.04000000000000001 + tau[0];
  // link 0 "ground": accelerations and constraint forces of loops below it are eliminated
  const Real x364 = x234 * x344 + x193 * x348;
  const Real x367 = x193 * x344 + 0.0834083 * x348;
  const Real x368 = 0.042726700000000006 * x349;
  const Real x375 = x242 * x344 + (x76 + tau[1]) * x348;
  const Real x389 = x344 * x364 + x348 * x367 + x349 * x368;
  const Real x396 = x234 * (x344 * x344) + 0.0834083 * (x348 * x348);
  const Real x397 = 0.042726700000000006 * (x349 * x349) + x396;
  const Real x383 = x359 * x364 + x360 * x367 + x361 * x368;
  const Real x400 = x397 * 1.7763568394002505e-15;
  require_more(w, x389, x400, kLoopFree, 0);
  const Real x402 = x397 * 1e-08;
  require_more(w, x389, x402, kLoopSingular, 0);
  const Real x384 = x383 - ((x44 * 0.16000000000000003 + tau[2]) * x349 + x375);
  const Real x403 = x384 * (1 / x389);
  // link 0 "ground": accelerations and constraint forces of loops below it
  const Real x411 = x359 - x344 * x403;
  w.result[0] = x411;
  const Real x412 = x360 - x348 * x403;
  w.result[1] = x412;
  const Real x413 = x361 - x349 * x403;
  w.result[2] = x413;
}

// ---- processes ----------------------------------------------------------------------------------

// Process 0: 3 of 3 joints: "crank_pin", "coupler_pin", "rocker_pin"
constexpr std::array<int, 3> kRead_0{0, 1, 2};
constexpr std::array<int, 3> kOwned_0{0, 1, 2};
constexpr std::array<int, 3> kAngles_0{0, 1, 2};

ADAGEN_AS_IT_STANDS void run_0([[maybe_unused]] Workspace& w, [[maybe_unused]] Channel& channel) {
  ADAGEN_INPUTS
  take_sines_and_cosines(q, kAngles_0, w.sine.data(), w.cosine.data());
  part_0_0(w);
  stamp(1);
  stamp(2);
  stamp(3);
  if (__builtin_expect(w.status != kFine || !all(unlike_zero(w.result.data() + 0, 3) == 0), 0)) {
    find_fault(w, kRead_0, kOwned_0);
  }
  if (w.status != kFine) return;
  std::copy_n(w.result.data() + 0, 3, w.qdd + 0);
}


// Alternative for poses in which a mobility is singular.
constexpr std::array<int, 3> kAngles_1{0, 1, 2};
ADAGEN_AS_IT_STANDS void recover_0([[maybe_unused]] Workspace& w, [[maybe_unused]] Channel& channel) {
  ADAGEN_INPUTS
  take_sines_and_cosines(q, kAngles_1, w.sine.data(), w.cosine.data());
  part_1_0(w);
  stamp(1);
  stamp(2);
  stamp(3);
  if (__builtin_expect(w.status != kFine || !all(unlike_zero(w.result.data() + 0, 3) == 0), 0)) {
    find_fault(w, kRead_0, kOwned_0);
  }
  if (w.status != kFine) return;
  std::copy_n(w.result.data() + 0, 3, w.qdd + 0);
}


}  // namespace

[[maybe_unused]] constexpr std::array<StageInfo, 3> kStages_0{ {{"kinematics", 2, -1}, {"assembly", 0, -1}, {"disassembly", 0, -1}} };
[[maybe_unused]] constexpr std::array<void (*)(Workspace&, Channel&), kProcesses> kRun{run_0};
constexpr std::array<void (*)(Workspace&, Channel&), 1> kRecover{recover_0};

#include "adagen/alone.hpp"
#include "adagen/c_interface.hpp"

// ---- program ------------------------------------------------------------------------------------

#ifndef ADAGEN_NO_MAIN
#include "adagen/measured_alone.hpp"
#include "adagen/tell.hpp"

namespace {

// Loop joints, each between a frame on its first link and a frame on its second one, with axis z;
// then couplings of joint coordinates.
constexpr Number kLoop_0[]{1.0, 0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 1.0, 0.0, 0.5, 0.0,
    1.0, 0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 1.0, 0.0, 0.4, 0.0};
constexpr std::array<adagen::Loop<Number>, 1> kLoops{ {
    {kLoopNames[0], 2, 3, kLoop_0, kLoop_0 + 9, kLoop_0 + 12, kLoop_0 + 21, 7u, 3u, false},
} };

adagen::Description<Number> description() {
  static const adagen::Table<adagen::Stage> stages = table<kStages_0>();
  auto about = plain_description(&stages);
  about.loops = {kLoops.data(), kLoopCount};
  return about;
}

}  // namespace

#include "adagen/entry.hpp"
#endif  // ADAGEN_NO_MAIN
