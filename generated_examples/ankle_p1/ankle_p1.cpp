// Forward dynamics of "ankle" on 1 process, emitted by adagen 0.1.0 (solver.cpp.j2). Do not edit: generate again.
// robot     "ankle", 8 joints, 12 degrees of freedom, description sha256 ddb900f3e284309ae668afcdcf39b2b2f8b0b30c7e4b7984814bb0e23c113d8c
// command   adagen ../models/ankle.urdf --scene=../models/ankle.toml --procs 1
// input     scene, sha256 11c8028c5b54b9020d35bd5ac03db5bc865ea05a389c3bc7c7df6b476153c181
// input     profile default, sha256 b2cd3054184b2c2aeb17237ba40764c79d3d6210c1ef616ed164227e724cf326
// options   form segment, shape unrolled, scalar double, channel auto, fixed base, gravity 0.0, 0.0, -9.81
// links     adagen_program.cpp
// program   1 process; 0.121 us predicted (default profile)
//           process 0: left_motor .. left_ball | right_motor .. right_ball in 2 lanes, hip .. ankle_roll
// licence   yours to choose: generated code belongs to its user
//
// Articulated-body algorithm: the articulated-body inertias I^A and bias forces p^A (IA, pA) are computed
// from the ends to the base, then the accelerations from the base outwards. Closed loops: accelerations
// of their joints and constraint forces stay unknown until the last link that these joints have in
// common, where they are eliminated (docs/explanation/loops.md). Spatial vectors are [angular; linear],
// in link frames turned so that every joint axis is z.

// ---- 1. interface -------------------------------------------------------------------------------
// ankle_p1.h declares it. To link this file with a program of your own, compile it with -DADAGEN_NO_MAIN.

#if __has_include("ankle_p1.h")
#include "ankle_p1.h"
#define ADAGEN_HEADER
#endif
#define ADAGEN_CALL(word) ankle_p1_##word
#define ADAGEN_NAMED(WORD) ANKLE_P1_##WORD


// ---- 2. model -----------------------------------------------------------------------------------

#define ADAGEN_SOLVER 100  // version of adagen that wrote this file
#define ADAGEN_LOOPS
#define ADAGEN_RECOVERS
#include "adagen/settings.hpp"

namespace {

struct Settings : PlainSettings {
  static constexpr int kJointCount = 8, kNq = 14, kNv = 12;
  [[maybe_unused]] static constexpr const char* kRobot = "ankle";
};

}  // namespace

#include "adagen/constants.hpp"

namespace {


constexpr std::array<LinkConstants, kLinkCount> kLinks{ {
    {"pelvis", 0.0, {0.0, 0.0, 0.0}},
    {"thigh", 6.0, {-0.2, 0.0, 0.0},
     {0.0147, 0.0, 0.0, 0.0, 0.08735, 0.0, 0.0, 0.0, 0.08735}},
    {"shank", 3.5, {-0.2, 0.0, 0.0},
     {0.004375, 0.0, 0.0, 0.0, 0.0488542, 0.0, 0.0, 0.0, 0.0488542}},
    {"ankle_cross", 0.15, {0.0, 0.0, 0.0},
     {2.4e-05, 0.0, 0.0, 0.0, 2.4e-05, 0.0, 0.0, 0.0, 2.4e-05}},
    {"foot", 1.0, {0.0, -0.05, 0.04},
     {0.00416667, 0.0, 0.0, 0.0, 0.00470833, 0.0, 0.0, 0.0, 0.000808333}},
    {"left_crank", 0.2, {0.0, -0.03, 0.0},
     {6.16667e-05, 0.0, 0.0, 0.0, 8.33333e-06, 0.0, 0.0, 0.0, 6.66667e-05}},
    {"left_rod", 0.15, {0.0, 0.0, -0.075},
     {0.0002826, 0.0, 0.0, 0.0, 0.0002826, 0.0, 0.0, 0.0, 2.7e-06}},
    {"right_crank", 0.2, {0.0, -0.03, 0.0},
     {6.16667e-05, 0.0, 0.0, 0.0, 8.33333e-06, 0.0, 0.0, 0.0, 6.66667e-05}},
    {"right_rod", 0.15, {0.0, 0.0, -0.115},
     {0.0006626, 0.0, 0.0, 0.0, 0.0006626, 0.0, 0.0, 0.0, 2.7e-06}},
} };

constexpr std::array<JointConstants, kJointCount> kJoints{ {
    {"hip", JointKind::kRevolute, 0, 0, 1, 0, 1,
     {0.0, 1.0, 0.0, 0.0, 0.0, 1.0, 1.0, 0.0, 0.0}, {0.0, 0.0, 0.0}},
    {"knee", JointKind::kRevolute, 1, 1, 1, 1, 1,
     {1.0, 0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 1.0}, {-0.4, 0.0, 0.0}},
    {"ankle_pitch", JointKind::kRevolute, 2, 2, 1, 2, 1,
     {1.0, 0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 1.0}, {-0.4, 0.0, 0.0}},
    {"ankle_roll", JointKind::kRevolute, 3, 3, 1, 3, 1,
     {0.0, 1.0, 0.0, 0.0, 0.0, 1.0, 1.0, 0.0, 0.0}, {0.0, 0.0, 0.0}},
    {"left_motor", JointKind::kRevolute, 2, 4, 1, 4, 1,
     {1.0, 0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 1.0}, {-0.25, 0.0, 0.05}},
    {"left_ball", JointKind::kSpherical, 5, 5, 4, 5, 3,
     {0.0, 0.0, 1.0, 1.0, 0.0, 0.0, 0.0, 1.0, 0.0}, {0.0, -0.06, 0.0}},
    {"right_motor", JointKind::kRevolute, 2, 9, 1, 8, 1,
     {1.0, 0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 1.0}, {-0.17, 0.0, -0.05}},
    {"right_ball", JointKind::kSpherical, 7, 10, 4, 9, 3,
     {0.0, 0.0, 1.0, 1.0, 0.0, 0.0, 0.0, 1.0, 0.0}, {0.0, -0.06, 0.0}},
} };

// Loops, then couplings: what statuses name them by.
constexpr int kLoopCount = 2;
constexpr std::array<const char*, 2> kLoopNames{ {
    "left_heel",
    "right_heel",
} };

}  // namespace

// ---- 3. runtime ---------------------------------------------------------------------------------

#include "adagen/far_angles.hpp"
#include "adagen/kernels/lanes.hpp"

#include "adagen/no_channel.hpp"

// ---- 4. joints ----------------------------------------------------------------------------------

#include "adagen/unrolled_memory.hpp"

namespace {

struct Workspace : StraightMemory<16, 8, 0> {};

}  // namespace

#include "adagen/unrolled_numbers.hpp"
#include "adagen/unrolled.hpp"
#include "adagen/tanh_library.hpp"
#include "adagen/unrolled_functions.hpp"
#include "adagen/unrolled_wide.hpp"
#include "adagen/unrolled_wide_functions.hpp"

namespace {

// Each function is a straight line. A value is called x and its number in the expression graph; zeros
// and constants are folded in, common subexpressions are shared, and dead code is left out.
// Frames are the links' own; accelerations are deviations from the field that the links would have
// with all joint accelerations zero.

// =================================================================================================
// Process 0: 515 products, 366 sums, 6 quotients, 593 of them in lanes
// =================================================================================================

ADAGEN_NOINLINE ADAGEN_AS_IT_STANDS void part_0_0(Workspace& w) {
  ADAGEN_INPUTS
  // joint 0 "hip": placement, velocity and reference acceleration of its link
  const Real x14 = sine[2] * 9.81;
  // joint 1 "knee": placement, velocity and reference acceleration of its link
  const Real x24 = v[0] + v[1];
  const Real x41 = x24 * x24;
  const Real x28 = cosine[2] * 9.81 + v[0] * v[0] * 0.4;
  // joint 2 "ankle_pitch": placement, velocity and reference acceleration of its link
  const Real x48 = x24 + v[2];
  // joint 3 "ankle_roll": placement, velocity and reference acceleration of its link
  const Real x85 = v[3] * v[3];
  const Real x70 = x48 * cosine[5];
  const Real x71 = x48 * sine[5];
  // joints 4 "left_motor", 6 "right_motor": placement, velocity and reference acceleration of their links
  const Two x99 = Two{v[4], v[8]};
  const Two x107 = x24 + x99;
  const Two x122 = x107 * x107;
  // joints 5 "left_ball", 7 "right_ball": placement, velocity and reference acceleration of their links
  const Two x132 = Two{q[5], q[10]};
  const Two x133 = Two{q[6], q[11]};
  const Two x134 = Two{q[7], q[12]};
  const Two x135 = Two{q[8], q[13]};
  const Two x142 = Two{v[5], v[9]};
  const Two x143 = Two{v[6], v[10]};
  const Two x144 = Two{v[7], v[11]};
  const Two x150 = x132 * x132 + x133 * x133 + x134 * x134;
  const Two x151 = x135 * x135 + x150;
  require_length(w, x151, {5, 7});
  const Two x153 = 2.0 * (1 / x151);
  const Two x154 = x132 * x153;
  const Two x155 = x133 * x153;
  const Two x156 = x134 * x153;
  const Two x168 = x132 * x154;
  const Two x157 = x133 * x155;
  const Two x158 = x134 * x156;
  const Two x161 = x133 * x154;
  const Two x162 = x135 * x156;
  const Two x164 = x134 * x154;
  const Two x165 = x135 * x155;
  const Two x171 = x134 * x155;
  const Two x172 = x135 * x154;
  const Two x163 = x161 - x162;
  const Two x167 = x161 + x162;
  const Two x166 = x164 + x165;
  const Two x174 = x164 - x165;
  const Two x175 = x171 + x172;
  const Two x173 = x171 - x172;
  const Two x177 = 1.0 - (x157 + x168);
  const Two x160 = 1.0 - (x157 + x158);
  const Two x170 = 1.0 - (x158 + x168);
  // directions in which a loop holds its two links
  const Two x443 = x85 + v[2] * v[2] + x99 * x99;
  const Two x445 = x142 * x142 + x443 + x143 * x143;
  const Two x530 = load<Two>(cosine + 0) * x175 - load<Two>(sine + 0) * x163;
  const Two x533 = load<Two>(sine + 0) * x175 + load<Two>(cosine + 0) * x163;
  // joints 5 "left_ball", 7 "right_ball": inertia and bias force of what is beyond, their motion left open
  const Two x879 = x174 * 0.15;
  // directions in which a loop holds its two links
  const Two x582 = load<Two>(cosine + 0) * x177 - load<Two>(sine + 0) * x166;
  const Two x456 = load<Two>(cosine + 0) * x174 - load<Two>(sine + 0) * x160;
  const Two x459 = load<Two>(sine + 0) * x174 + load<Two>(cosine + 0) * x160;
  const Two x585 = load<Two>(sine + 0) * x177 + load<Two>(cosine + 0) * x166;
  const Two x536 = cosine[4] * x530 + sine[4] * x533;
  const Two x462 = cosine[4] * x456 + sine[4] * x459;
  const Two x588 = cosine[4] * x582 + sine[4] * x585;
  const Two x466 = cosine[4] * x459 - sine[4] * x456;
  const Two x540 = cosine[4] * x533 - sine[4] * x530;
  const Two x592 = cosine[4] * x585 - sine[4] * x582;
  const Two x543 = cosine[5] * x170 + sine[5] * x536;
  const Two x547 = cosine[5] * x536 - sine[5] * x170;
  const Two x469 = cosine[5] * x167 + sine[5] * x462;
  const Two x473 = cosine[5] * x462 - sine[5] * x167;
  const Two x595 = cosine[5] * x173 + sine[5] * x588;
  const Two x599 = cosine[5] * x588 - sine[5] * x173;
  const Two x502 = 0.06 * x473;
  const Two x554 = 0.06 * x547;
  const Two x606 = 0.06 * x599;
  const Two x559 = 0.06 * x543 + Two{0.05, -0.05} * x540;
  const Two x507 = 0.06 * x469 + Two{0.05, -0.05} * x466;
  const Two x611 = 0.06 * x595 + Two{0.05, -0.05} * x592;
  // joints 5 "left_ball", 7 "right_ball": inertia and bias force of what is beyond, their motion left open
  const Two x880 = x175 * 0.15;
  const Two x790 = x177 * 0.06;
  const Two x881 = x177 * 0.15;
  const Two x653 = x167 * Two{0.00112635, 0.00264635};
  const Two x656 = x170 * Two{0.01125, 0.01725};
  const Two x682 = x167 * Two{0.01125, 0.01725};
  const Two x710 = x173 * 2.7e-06;
  const Two x677 = x170 * Two{0.00112635, 0.00264635};
  const Two x892 = x174 * x879 + x175 * x880 + x177 * x881;
  const Two x728 = x170 * Two{0.15, 0.23} - x174 * 0.06;
  const Two x761 = x167 * Two{0.15, 0.23} + x175 * 0.06;
  const Two x840 = x175 * x682 - x174 * x656;
  // link 2 "shank": accelerations and constraint forces of loops below it are eliminated
  const Two x1854 = x790 * Two{0.0225, 0.0529};
  const Two x1856 = 1 / x1854;
  // joint 1 "knee": placement, velocity and reference acceleration of its link
  const Real x32 = cosine[3] * x28 - x14 * sine[3];
  const Real x37 = sine[3] * x28 + x14 * cosine[3];
  // joints 4 "left_motor", 6 "right_motor": placement, velocity and reference acceleration of their links
  const Two x111 = x32 + x41 * Two{0.25, 0.17};
  const Two x120 = load<Two>(sine + 0) * x111 + load<Two>(cosine + 0) * x37;
  // joints 5 "left_ball", 7 "right_ball": placement, velocity and reference acceleration of their links
  const Two x179 = x107 * x167;
  const Two x180 = x107 * x170;
  const Two x181 = x107 * x173;
  // directions in which a loop holds its two links
  const Two x561 = Two{0.05, -0.05} * x547;
  const Two x613 = Two{0.05, -0.05} * x599;
  const Two x509 = Two{0.05, -0.05} * x473;
  // joints 5 "left_ball", 7 "right_ball": inertia and bias force of what is beyond, their motion left open
  const Two x923 = x840 + 0.06 * x892;
  const Two x654 = x175 * Two{0.01125, 0.01725};
  const Two x678 = x174 * Two{0.01125, 0.01725};
  const Two x878 = x167 * x653 + x173 * x710 + x170 * x677;
  const Two x662 = x653 + 0.06 * x654;
  const Two x689 = x677 - 0.06 * x678;
  const Two x997 = x878 + 0.06 * x840 + 0.06 * x923 + 0.0002466667;
  const Two x897 = x160 * x879 + x163 * x880 + x166 * x881;
  const Two x655 = x163 * Two{0.01125, 0.01725};
  const Two x929 = x163 * x682 - x160 * x656 + 0.06 * x897;
  const Two x998 = 0.006 + x923;
  // joint 3 "ankle_roll": inertia and bias force of what is beyond, its own motion left open
  const Real x1425 = cosine[5] * x502[0] + sine[5] * x507[0];
  const Real x1440 = cosine[5] * x502[1] + sine[5] * x507[1];
  const Real x1455 = cosine[5] * x554[0] + sine[5] * x559[0];
  const Real x1470 = cosine[5] * x554[1] + sine[5] * x559[1];
  const Real x1485 = cosine[5] * x606[0] + sine[5] * x611[0];
  const Real x1500 = cosine[5] * x606[1] + sine[5] * x611[1];
  // link 2 "shank": accelerations and constraint forces of loops below it are eliminated
  const Two x1860 = Two{0.15, 0.23} * x790 * x1856;
  const Two x1862 = Two{0.15, 0.23} * x761 * x1856;
  const Two x1864 = Two{0.15, 0.23} * x728 * x1856;
  const Two x1811 = Two{x1425, x1440};
  const Two x1819 = Two{x1455, x1470};
  const Two x1830 = Two{x1485, x1500};
  const Two x1858 = Two{0.0225, 0.0529} * x1856;
  const Two x1866 = x1830 * x1858;
  const Two x1875 = x1830 * x1862 - x1819 * x1860;
  const Two x1886 = x1811 * x1860 + x1830 * x1864;
  const Two x1868 = x613 * x1858;
  const Two x1879 = x613 * x1862 - x561 * x1860;
  const Two x1889 = x509 * x1860 + x613 * x1864;
  const Two x1952 = x662 * x1866 - Two{0.00112635, 0.00264635} * x1875;
  const Two x1960 = x689 * x1866 - Two{0.00112635, 0.00264635} * x1886;
  const Two x1965 = x710 * x1866;
  const Two x1941 = x997 * x1866 - x662 * x1875 - x689 * x1886;
  const Two x2218 = x1965 * 370370.3703703704;
  const Two x1948 = x997 * x1868 - x662 * x1879 - x689 * x1889;
  const Two x1956 = x662 * x1868 - Two{0.00112635, 0.00264635} * x1879;
  const Two x1973 = x1866 * x1941 - (x1875 * x1952 + x1886 * x1960);
  // joint 2 "ankle_pitch": placement, velocity and reference acceleration of its link
  const Real x51 = x32 + 0.4 * x41;
  const Real x55 = cosine[4] * x51 - x37 * sine[4];
  const Real x60 = sine[4] * x51 + x37 * cosine[4];
  // joint 3 "ankle_roll": placement, velocity and reference acceleration of its link
  const Real x75 = v[3] * x70;
  const Real x82 = x70 * x70;
  const Real x83 = x71 * x71;
  const Real x94 = x82 + x83;
  const Real x77 = x55 * sine[5];
  const Real x88 = x70 * x71;
  // joints 4 "left_motor", 6 "right_motor": placement, velocity and reference acceleration of their links
  const Two x115 = load<Two>(cosine + 0) * x111 - load<Two>(sine + 0) * x37;
  // joints 5 "left_ball", 7 "right_ball": placement, velocity and reference acceleration of their links
  const Two x182 = x142 + x179;
  const Two x183 = x143 + x180;
  const Two x184 = x144 + x181;
  const Two x200 = x122 * 0.06 - x120;
  const Two x188 = x144 * x180 - x143 * x181;
  const Two x192 = x142 * x181 - x144 * x179;
  const Two x223 = x183 * x184;
  const Two x228 = x182 * x184;
  const Two x203 = x115 * x174 + x160 * x200;
  const Two x206 = x115 * x175 + x163 * x200;
  const Two x224 = x223 - x188;
  const Two x230 = x192 + x228;
  const Two x209 = x115 * x177 + x166 * x200;
  const Two x226 = x182 * x182 + x183 * x183;
  // joints 5 "left_ball", 7 "right_ball": inertia and bias force of what is beyond, their motion left open
  const Two x680 = x160 * Two{0.01125, 0.01725};
  const Two x906 = x163 * (x163 * 0.15) + x166 * (x166 * 0.15);
  // joints 4 "left_motor", 6 "right_motor": inertia and bias force of what is beyond, their motion left open
  const Two x1026 = load<Two>(sine + 0) * x998 + load<Two>(cosine + 0) * x929;
  const Two x1063 = load<Two>(sine + 0) * x654 + load<Two>(cosine + 0) * x655;
  const Two x1101 = load<Two>(sine + 0) * x678 + load<Two>(cosine + 0) * x680;
  const Two x1037 = x997 - Two{0.25, 0.17} * x1026;
  const Two x1074 = x662 - Two{0.25, 0.17} * x1063;
  // joint 3 "ankle_roll": inertia and bias force of what is beyond, its own motion left open
  const Real x1538 = 0.00630833 + cosine[5] * (cosine[5] * 0.0019583400000000003) + 2.4e-05;
  // link 2 "shank": accelerations and constraint forces of loops below it are eliminated
  const Two x2230 = x1965 * x2218;
  const Two x1964 = x689 * x1868 - Two{0.00112635, 0.00264635} * x1889;
  const Two x1980 = x1866 * x1948 - x1875 * x1956 - x1886 * x1964;
  const Two x1981 = x710 * x1868;
  const Two x2231 = x1981 * x2218;
  const Real x2302 = x1538 + across<2>(x1973) - across<2>(x2230);
  require_more(w, x2302, 0.0, kLoopFree, 2);
  const Two x1997 = x1868 * x1948 - (x1879 * x1956 + x1889 * x1964);
  const Two x2219 = x1981 * 370370.3703703704;
  // joint 3 "ankle_roll": placement, velocity and reference acceleration of its link
  const Real x78 = x55 * cosine[5];
  const Real x73 = v[3] * x71;
  const Real x90 = x82 + x85;
  // links 6 "left_rod", 8 "right_rod": force that the reference field takes
  const Two x385 = x203 * 0.15 - x230 * Two{0.01125, 0.01725};
  const Two x389 = x206 * 0.15 - x224 * Two{0.01125, 0.01725};
  const Two x374 = (x143 * x179 - x142 * x180) * 2.7e-06;
  const Two x378 = x188 * Two{0.00112635, 0.00264635} - x223 * Two{0.00112365, 0.00264365} + x206 * Two{0.01125, 0.01725};
  const Two x393 = x209 * 0.15 + x226 * Two{0.01125, 0.01725};
  const Two x381 = x192 * Two{0.00112635, 0.00264635} + x228 * Two{0.00112365, 0.00264365} - x203 * Two{0.01125, 0.01725};
  // directions in which a loop holds its two links
  const Two x488 = x77 - (x83 + x85) * Two{0.05, -0.05};
  const Two x496 = 2.0 * x75 * Two{0.05, -0.05} + x94 * 0.06 - x60;
  const Two x491 = x78 - x88 * Two{0.05, -0.05};
  // joints 5 "left_ball", 7 "right_ball": inertia and bias force of what is beyond, their motion left open
  const Two x999 = 0.2 + x892;
  const Two x1000 = x160 * (x160 * 0.15) + x906 + 0.2;
  const Two x977 = x174 * x385 + x175 * x389 + x177 * x393;
  // joints 4 "left_motor", 6 "right_motor": inertia and bias force of what is beyond, their motion left open
  const Two x1113 = x689 + Two{0.25, 0.17} * x1101;
  const Two x1292 = load<Two>(cosine + 0) * (x999 - x1000) - x897 * (load<Two>(sine + 0) * 2.0);
  const Two x1296 = load<Two>(cosine + 0) * x1292;
  const Two x1023 = load<Two>(cosine + 0) * x998 - load<Two>(sine + 0) * x929;
  // joint 3 "ankle_roll": inertia and bias force of what is beyond, its own motion left open
  const Real x1417 = sine[5] * 0.002;
  const Real x1420 = cosine[5] * 0.05;
  const Real x1421 = sine[5] * 0.05;
  // joint 2 "ankle_pitch": inertia and bias force of what is beyond, its own motion left open
  const Real x1561 = sine[4] * 0.04 + cosine[4] * x1420;
  const Real x1574 = sine[4] * x1421;
  // link 2 "shank": accelerations and constraint forces of loops below it are eliminated
  const Real x2335 = 1 / x2302;
  const Two x2237 = x1981 * x2219;
  const Two x2046 = x1037 * x1866 - x1074 * x1875 - x1113 * x1886;
  const Two x2222 = x710 * 370370.3703703704;
  const Real x2304 = across<2>(x1980) - x1417 - across<2>(x2231);
  const Two x2054 = x1037 * x1868 - (x1074 * x1879 + x1113 * x1889);
  const Two x2254 = x1965 * x2222;
  const Real x2336 = x2304 * x2335;
  const Two x2255 = x1981 * x2222;
  // link 4 "foot": force that the reference field takes
  const Real x292 = x73 * 0.002999997 - x73 * 0.00826667;
  const Real x312 = 0.002 * (x94 - x90) + x292 + x60 * 0.05;
  const Real x302 = x75 * 0.004958337 - x75 * 0.00630833 + x88 * 0.002;
  // directions in which a loop holds its two links
  const Two x501 = x469 * x488 + x466 * x496 + x473 * x491;
  const Two x553 = x488 * x543 + x496 * x540 + x491 * x547;
  const Two x605 = x488 * x595 + x496 * x592 + x491 * x599;
  const Two x614 = x605 - (x209 + x226 * Two{0.15, 0.23});
  // joints 5 "left_ball", 7 "right_ball": inertia and bias force of what is beyond, their motion left open
  const Two x972 = x167 * x378 + x173 * x374 + x170 * x381;
  const Two x640 = x378 - Two{tau[5], tau[9]};
  const Two x645 = x381 - Two{tau[6], tau[10]};
  const Two x1002 = x972 + 0.06 * x977 + x115 * 0.006;
  // joints 4 "left_motor", 6 "right_motor": inertia and bias force of what is beyond, their motion left open
  const Two x1060 = load<Two>(cosine + 0) * x654 - load<Two>(sine + 0) * x655;
  const Two x1298 = x999 - x1296;
  const Two x1096 = load<Two>(sine + 0) * x680 - load<Two>(cosine + 0) * x678;
  const Two x1008 = x1002 - Two{tau[4], tau[8]};
  const Two x1319 = x1026 - Two{0.25, 0.17} * x1298;
  const Two x1362 = x1037 - Two{0.25, 0.17} * x1319;
  // joint 2 "ankle_pitch": inertia and bias force of what is beyond, its own motion left open
  const Real x1565 = x1538 + 0.4 * x1561;
  // link 2 "shank": accelerations and constraint forces of loops below it are eliminated
  const Real x2305 = 0.003308333 + across<2>(x1997) - across<2>(x2237);
  const Real x2339 = x2305 - x2304 * x2336;
  const Two x2075 = x1026 * x1866 - x1063 * x1875 + x1101 * x1886;
  const Real x2340 = 1 / x2339;
  const Two x1870 = x614 * x1858;
  const Two x1880 = (x553 - (x206 - x224 * Two{0.15, 0.23})) * x1860;
  const Two x1883 = x614 * x1862 - x1880;
  const Two x1890 = (x501 - (x203 - x230 * Two{0.15, 0.23})) * x1860;
  const Two x1892 = x1890 + x614 * x1864;
  const Real x2308 = x1565 + across<2>(x2046) - across<2>(x2254);
  const Two x2061 = x1023 * x1866 - x1060 * x1875 - x1096 * x1886;
  const Two x2082 = x1026 * x1868 - x1063 * x1879 + x1101 * x1889;
  const Real x2311 = across<2>(x2054) - (x1417 + 0.4 * x1574) - across<2>(x2255);
  const Two x2068 = x1023 * x1868 - x1060 * x1879 - x1096 * x1889;
  const Two x2127 = x1008 * x1866 - (x640 * x1875 + x645 * x1886);
  // joints 5 "left_ball", 7 "right_ball": inertia and bias force of what is beyond, their motion left open
  const Two x1003 = x115 * 0.2 + x977;
  const Two x982 = x160 * x385 + x163 * x389 + x166 * x393;
  const Two x1004 = x122 * 0.006 - x120 * 0.2 + x982;
  // joints 4 "left_motor", 6 "right_motor": inertia and bias force of what is beyond, their motion left open
  const Two x1295 = x897 + load<Two>(sine + 0) * x1292;
  const Two x1376 = load<Two>(sine + 0) * x1003 + load<Two>(cosine + 0) * x1004;
  const Two x1309 = x1023 - Two{0.25, 0.17} * x1295;
  const Two x1297 = x1000 + x1296;
  const Two x1387 = x1002 - Two{0.25, 0.17} * x1376;
  // joint 3 "ankle_roll": inertia and bias force of what is beyond, its own motion left open
  const Real x1522 = cosine[5] * (x312 - x78 * 0.04);
  const Real x1525 = x1522 - sine[5] * (x302 + x77 * 0.04);
  const Real x1533 = sine[5] * (x77 + x88 * 0.05);
  const Real x1535 = x1533 + cosine[5] * (x78 + x90 * 0.05);
  const Real x1540 = x55 * 0.15 + x1535;
  // link 4 "foot": force that the reference field takes
  const Real x330 = 2.0 * x73 * 0.05 - x94 * 0.04 - x60;
  // joint 3 "ankle_roll": inertia and bias force of what is beyond, its own motion left open
  const Real x1541 = x330 - x60 * 0.15;
  // joint 2 "ankle_pitch": inertia and bias force of what is beyond, its own motion left open
  const Real x1753 = -0.46 - x1561;
  const Real x1556 = sine[4] * x1420 - cosine[4] * 0.04;
  // link 2 "shank": accelerations and constraint forces of loops below it are eliminated
  const Two x2135 = x1008 * x1868 - (x640 * x1879 + x645 * x1889);
  const Two x2144 = x1870 * x1941 - (x1883 * x1952 + x1892 * x1960);
  const Two x2223 = (x374 - Two{tau[7], tau[11]} + x710 * x1870) * 370370.3703703704;
  const Two x2258 = x710 * x2222;
  const Real x2373 = x2340 * (x2311 - x2308 * x2336);
  const Real x2107 = across<2>(x2075) - x1561;
  const Two x2151 = x1870 * x1948 - x1883 * x1956 - x1892 * x1964;
  const Two x2260 = x1965 * x2223;
  const Real x2106 = x1556 + across<2>(x2061);
  const Real x2118 = x1574 + across<2>(x2082);
  const Two x2261 = x1981 * x2223;
  const Real x2386 = x2308 * x2335 - x2336 * x2373;
  const Real x2117 = cosine[4] * x1421 + across<2>(x2068);
  const Real x2375 = x2340 * (x2118 - x2107 * x2336);
  const Real x2374 = x2340 * (x2117 - x2106 * x2336);
  const Real x2155 = x88 * 0.0019583400000000003 + x77 * 0.05 - tau[3] + across<2>(x2135);
  const Real x2312 = x1525 - tau[2] + across<2>(x2127) + across<2>(x2144) - across<2>(x2260);
  const Real x2328 = x1565 - 0.4 * x1753 + across<2>(x1362) - across<2>(x2258);
  const Real x2392 = x2107 * x2335 - x2336 * x2375;
  // joints 4 "left_motor", 6 "right_motor": inertia and bias force of what is beyond, their motion left open
  const Two x1373 = load<Two>(cosine + 0) * x1003 - load<Two>(sine + 0) * x1004;
  // joint 2 "ankle_pitch": inertia and bias force of what is beyond, its own motion left open
  const Real x1782 = sine[4] * x1540 + cosine[4] * x1541;
  // link 2 "shank": accelerations and constraint forces of loops below it are eliminated
  const Real x2551 = x2328 - (x2308 * x2386 + x2311 * x2373) + 0.18885420000000003;
  require_more(w, x2551, 0.0, kFactorization, 1);
  const Real x2389 = x2106 * x2335 - x2336 * x2374;
  const Two x2183 = x1037 * x1870 - x1074 * x1883 - x1113 * x1892;
  const Two x2264 = x710 * x2223;
  const Real x2377 = x2340 * (x2155 + across<2>(x2151) - across<2>(x2261) - x2312 * x2336);
  const Real x2509 = across<2>(x1309) + x1556 - (x2308 * x2389 + x2311 * x2374);
  const Real x2510 = across<2>(x1319) + x1753 - (x2308 * x2392 + x2311 * x2375);
  const Real x2552 = -0.7000000000000001 + x2510;
  const Real x2398 = x2312 * x2335 - x2336 * x2377;
  const Two x2190 = x1023 * x1870 - x1060 * x1883 - x1096 * x1892;
  const Two x2197 = x1026 * x1870 - x1063 * x1883 + x1101 * x1892;
  const Real x2512 = across<2>(x1297) + 1.15 - (x2106 * x2389 + x2117 * x2374);
  const Real x2515 = across<2>(x1298) + 1.15 - (x2107 * x2392 + x2118 * x2375);
  const Real x2334 = x1525 - 0.4 * x1782 + across<2>(x1387) + across<2>(x2183) - across<2>(x2264);
  // joint 1 "knee": articulated-body inertia and bias force through it
  const Real x2560 = 1 / x2551;
  const Real x2565 = x2509 * x2560;
  const Real x2566 = x2552 * x2560;
  const Real x2597 = 3.5 + x2512 - x2509 * x2565;
  // link 2 "shank": accelerations and constraint forces of loops below it are eliminated
  const Real x2513 = across<2>(x1295) - (x2106 * x2392 + x2117 * x2375);
  // directions in which a loop holds its two links
  const Two x399 = sine[5] * Two{0.05, -0.05};
  const Two x410 = x177 * Two{0.15, 0.23};
  const Two x416 = -0.06 - x166 * Two{0.15, 0.23};
  const Two x407 = sine[4] * x399 - cosine[4] * 0.06;
  const Two x430 = x407 - (load<Two>(cosine + 0) * x416 - load<Two>(sine + 0) * x410);
  const Two x431 = cosine[5] * Two{0.05, -0.05} - (Two{0.05, -0.05} - x173 * Two{0.15, 0.23});
  const Two x408 = cosine[4] * x399 + sine[4] * 0.06 + -0.4;
  const Two x429 = x408 - (Two{-0.25, -0.17} - (load<Two>(cosine + 0) * x410 + load<Two>(sine + 0) * x416));
  // link 2 "shank": accelerations and constraint forces of loops below it are eliminated
  const Real x2544 = x2334 - (x2308 * x2398 + x2311 * x2377);
  const Real x2214 = cosine[4] * x1540 - sine[4] * x1541 + across<2>(x1373) + across<2>(x2190);
  const Real x2532 = x2107 * x2398 + x2118 * x2377;
  const Real x2545 = x2214 - (x2106 * x2398 + x2117 * x2377);
  const Two x1928 = x1868 * x1868 + x1879 * x1879 + x1889 * x1889;
  const Two x1816 = x99 * x728 + x143 * Two{0.15, 0.23} + v[3] * x509;
  const Two x1817 = v[2] * x1811 + x1816;
  const Two x1827 = v[3] * x561 - (x99 * x761 + x142 * Two{0.15, 0.23});
  const Two x1828 = v[2] * x1819 + x1827;
  const Two x1930 = x1866 * x1866 + x1928 + x1875 * x1875;
  const Two x1931 = x1886 * x1886 + x1930;
  const Two x1835 = v[3] * x613 - x99 * x790 + v[2] * x1830;
  const Two x1894 = Two{0.0225, 0.0529} + x728 * x728;
  const Two x1897 = Two{0.0225, 0.0529} + x761 * x761;
  const Two x1898 = x790 * x790;
  const Two x1907 = x1854 * x1854;
  const Real x2342 = x2305 * 1.7763568394002505e-15;
  require_more(w, x2339, x2342, kLoopFree, 3);
  const Two x1901 = x1894 * Two{64.0, 16.0};
  require_more(w, x1901, 9.999999999999998e-15, kSingularPose, {8, 9});
  const Two x1902 = x1897 * Two{64.0, 16.0};
  require_more(w, x1902, 9.999999999999998e-15, kSingularPose, {8, 9});
  // joint 1 "knee": articulated-body inertia and bias force through it
  const Real x2664 = cosine[3] * (x2597 - (3.5 + x2515 - x2552 * x2566));
  const Real x2562 = x2560 * (tau[1] - (x37 * 0.7000000000000001 + x2544));
  const Real x2667 = x2664 - (x2513 - x2509 * x2566) * (sine[3] * 2.0);
  // link 2 "shank": accelerations and constraint forces of loops below it are eliminated
  const Real x2557 = x32 * 3.5 + x41 * 0.7000000000000001 + x2545;
  const Real x2558 = across<2>(x1376) + x1782 + across<2>(x2197) - x2532 - x37 * 3.5;
  // joint 1 "knee": articulated-body inertia and bias force through it
  const Real x2713 = sine[3] * (x2557 + x2509 * x2562);
  const Real x2725 = 0.32735000000000003 + 0.4 * (0.4 * (x2597 - cosine[3] * x2667));
  require_more(w, x2725, 0.0, kFactorization, 0);
  const Real x2719 = 0.4 * (x2713 + cosine[3] * (x2558 + x2552 * x2562));
  // directions in which a loop holds its two links
  const Two x436 = x430 * x430 + x431 * x431 + x429 * x429;
  const Two x448 = 1e-08 - x436;
  require_more(w, x448, 0.0, kLoopOpen, {8, 9});
  // link 2 "shank": accelerations and constraint forces of loops below it are eliminated
  const Two x1904 = x1898 * 256.0;
  require_more(w, x1904, 9.999999999999998e-15, kSingularPose, {8, 9});
  const Two x1840 = x1817 * x1817 + x1828 * x1828 + x1835 * x1835;
  const Two x1841 = (x144 * x144 + x445 + 1.0) * 1.0000000000000002e-06 - x1840;
  require_more(w, x1841, 0.0, kLoopTorn, {8, 9});
  const Two x1910 = x1898 * (x1894 * x1897) * 9.999999999999998e-15;
  require_more(w, x1907, x1910, kSingularPose, {8, 9});
  const Real x1934 = 40000.0 - across<2>(x1931);
  require_more(w, x1934, 0.0, kSingularPose, 8);
  // joint 0 "hip": articulated-body inertia and bias force through it
  const Real x2736 = 1 / x2725 * (tau[0] - (tau[1] - x2719 + x14 * 1.2000000000000002));
  w.result[0] = x2736;
  // joint 1 "knee": its acceleration, and that of the link beyond
  const Real x2746 = 0.4 * x2736;
  const Real x2748 = sine[3] * x2746;
  const Real x2750 = cosine[3] * x2746;
  const Real x2757 = x2562 + x2565 * x2748 + x2566 * x2750;
  const Real x2758 = x2757 - x2736;
  w.result[1] = x2758;
  // link 2 "shank": accelerations and constraint forces of loops below it
  const Real x2766 = x2389 * x2748 + x2392 * x2750 - x2386 * x2757;
  const Real x2775 = x2766 - x2398;
  w.result[2] = x2775;
  const Real x2774 = x2374 * x2748 + x2375 * x2750 - x2373 * x2757;
  const Real x2776 = x2774 - x2377;
  w.result[3] = x2776;
  const Two x2785 = x2218 * x2775 + x2219 * x2776;
  const Two x2808 = x1866 * x2775 + x1868 * x2776 + x1870;
  put(x2808, w.lanes.data() + 0);
  const Two x2788 = -(x2223 + x2222 * x2757 + x2785);
  put(x2788, w.lanes.data() + 6);
  const Two x2810 = -(x1875 * x2775 + x1879 * x2776 + x1883);
  put(x2810, w.lanes.data() + 2);
  const Two x2812 = -(x1886 * x2775 + x1889 * x2776 + x1892);
  put(x2812, w.lanes.data() + 4);
}

// =================================================================================================
// Process 0 in a singular pose: 1369 products, 991 sums, 20 quotients
// =================================================================================================

ADAGEN_NOINLINE ADAGEN_AS_IT_STANDS void part_1_0(Workspace& w) {
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
  const Real x144 = x142 + x143;
  const Real x145 = x139 + x140;
  const Real x141 = x139 - x140;
  const Real x153 = x149 + x150;
  const Real x151 = x149 - x150;
  const Real x138 = 1.0 - (x135 + x136);
  const Real x148 = 1.0 - (x136 + x146);
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
  // directions in which a loop holds its two links
  const Real x572 = v[2] * v[2];
  const Real x574 = v[4] * v[4] + v[5] * v[5] + v[6] * v[6];
  const Real x580 = v[7] * v[7] + x574 + x572 + x80 + 1.0;
  // directions in which a loop holds its two links
  const Real x757 = v[8] * v[8] + v[9] * v[9] + v[10] * v[10];
  // joint 5 "left_ball": placement, velocity and reference acceleration of its link
  const Real x155 = 1.0 - (x135 + x146);
  // joint 7 "right_ball": placement, velocity and reference acceleration of its link
  const Real x255 = 1.0 - (x252 + x253);
  const Real x256 = q[11] * x249;
  const Real x257 = q[13] * x251;
  const Real x262 = x256 + x257;
  // directions in which a loop holds its two links
  const Real x642 = cosine[4] * x153 - sine[4] * x141;
  const Real x587 = cosine[4] * x152 - sine[4] * x138;
  const Real x590 = sine[4] * x152 + cosine[4] * x138;
  const Real x645 = sine[4] * x153 + cosine[4] * x141;
  const Real x678 = cosine[4] * x155 - sine[4] * x144;
  const Real x593 = cosine[2] * x587 + sine[2] * x590;
  const Real x597 = cosine[2] * x590 - sine[2] * x587;
  const Real x648 = cosine[2] * x642 + sine[2] * x645;
  const Real x652 = cosine[2] * x645 - sine[2] * x642;
  const Real x681 = sine[4] * x155 + cosine[4] * x144;
  const Real x600 = cosine[3] * x145 + sine[3] * x593;
  const Real x604 = cosine[3] * x593 - sine[3] * x145;
  const Real x655 = cosine[3] * x148 + sine[3] * x648;
  const Real x659 = cosine[3] * x648 - sine[3] * x148;
  const Real x684 = cosine[2] * x678 + sine[2] * x681;
  const Real x688 = cosine[2] * x681 - sine[2] * x678;
  const Real x637 = 0.05 * x604;
  const Real x673 = 0.05 * x659;
  const Real x691 = cosine[3] * x151 + sine[3] * x684;
  const Real x695 = cosine[3] * x684 - sine[3] * x151;
  const Real x709 = 0.05 * x695;
  // directions in which a loop holds its two links
  const Real x767 = cosine[5] * x269 - sine[5] * x255;
  const Real x770 = sine[5] * x269 + cosine[5] * x255;
  // joint 5 "left_ball": inertia and bias force of what is beyond, its own motion left open
  const Real x1521 = x145 * 0.15 + x153 * 0.06;
  const Real x1506 = x148 * 0.15 - x152 * 0.06;
  const Real x1528 = x155 * 0.06;
  // joint 3 "ankle_roll": inertia and bias force of what is beyond, its own motion left open
  const Real x2046 = sine[3] * (0.06 * x600 + 0.05 * x597);
  const Real x2048 = cosine[3] * (0.06 * x604) + x2046;
  const Real x2061 = sine[3] * (0.06 * x655 + 0.05 * x652);
  const Real x2063 = cosine[3] * (0.06 * x659) + x2061;
  // link 2 "shank": accelerations and constraint forces of loops below it are eliminated
  const Real x2497 = x1506 * 8.0;
  const Real x2501 = x1521 * 8.0;
  const Real x2506 = x1528 * 16.0;
  const Real x2496 = x637 * 8.0;
  const Real x2500 = x673 * 8.0;
  const Real x2530 = x2497 * x2497 + 1.44 + x2496 * x2496;
  // joint 0 "hip": placement, velocity and reference acceleration of its link
  const Real x9 = sine[0] * 9.81;
  // joint 7 "right_ball": placement, velocity and reference acceleration of its link
  const Real x266 = q[12] * x250;
  const Real x267 = q[13] * x249;
  const Real x258 = x256 - x257;
  const Real x263 = q[10] * x249;
  const Real x270 = x266 + x267;
  const Real x261 = x259 + x260;
  const Real x268 = x266 - x267;
  const Real x265 = 1.0 - (x253 + x263);
  const Real x272 = 1.0 - (x252 + x263);
  // directions in which a loop holds its two links
  const Real x773 = cosine[2] * x767 + sine[2] * x770;
  const Real x777 = cosine[2] * x770 - sine[2] * x767;
  const Real x780 = cosine[3] * x262 + sine[3] * x773;
  const Real x784 = cosine[3] * x773 - sine[3] * x262;
  const Real x812 = 0.05 * x784;
  const Real x818 = cosine[5] * x270 - sine[5] * x258;
  const Real x821 = sine[5] * x270 + cosine[5] * x258;
  const Real x824 = cosine[2] * x818 + sine[2] * x821;
  const Real x828 = cosine[2] * x821 - sine[2] * x818;
  const Real x855 = cosine[5] * x272 - sine[5] * x261;
  const Real x858 = sine[5] * x272 + cosine[5] * x261;
  const Real x831 = cosine[3] * x265 + sine[3] * x824;
  const Real x835 = cosine[3] * x824 - sine[3] * x265;
  const Real x861 = cosine[2] * x855 + sine[2] * x858;
  const Real x849 = 0.05 * x835;
  const Real x865 = cosine[2] * x858 - sine[2] * x855;
  // joint 7 "right_ball": inertia and bias force of what is beyond, its own motion left open
  const Real x958 = 0.06 * x272;
  const Real x936 = x265 * 0.23 - 0.06 * x269;
  const Real x951 = x262 * 0.23 + 0.06 * x270;
  // joint 3 "ankle_roll": inertia and bias force of what is beyond, its own motion left open
  const Real x2076 = sine[3] * (0.06 * x691 + 0.05 * x688);
  const Real x2078 = cosine[3] * (0.06 * x695) + x2076;
  const Real x2091 = sine[3] * (0.05 * x777 - 0.06 * x780);
  const Real x2093 = cosine[3] * (0.06 * x784) - x2091;
  // link 2 "shank": accelerations and constraint forces of loops below it are eliminated
  const Real x2505 = x709 * 16.0;
  const Real x2495 = x2048 * 8.0;
  const Real x2499 = x2063 * 8.0;
  const Real x2504 = x2078 * 16.0;
  const Real x2509 = x812 * 4.0;
  const Real x2508 = x2093 * 4.0;
  const Real x2533 = sign_of(x2495) * sqrt_of(x2495 * x2495 + x2530);
  const Real x2511 = x936 * 4.0;
  const Real x2522 = x958 * 16.0;
  const Real x2516 = x951 * 4.0;
  const Real x2534 = x2495 + x2533;
  // joint 1 "knee": placement, velocity and reference acceleration of its link
  const Real x23 = cosine[0] * 9.81 + v[0] * v[0] * 0.4;
  const Real x27 = cosine[1] * x23 - x9 * sine[1];
  const Real x32 = sine[1] * x23 + x9 * cosine[1];
  // joint 2 "ankle_pitch": placement, velocity and reference acceleration of its link
  const Real x46 = x27 + 0.4 * x36;
  const Real x50 = cosine[2] * x46 - x32 * sine[2];
  const Real x55 = sine[2] * x46 + x32 * cosine[2];
  // joint 3 "ankle_roll": placement, velocity and reference acceleration of its link
  const Real x65 = x43 * cosine[3];
  const Real x66 = x43 * sine[3];
  const Real x70 = v[3] * x65;
  const Real x77 = x65 * x65;
  const Real x78 = x66 * x66;
  const Real x83 = x65 * x66;
  const Real x89 = x77 + x78;
  // joint 4 "left_motor": placement, velocity and reference acceleration of its link
  const Real x103 = x27 + x36 * 0.25;
  const Real x112 = sine[4] * x103 + x32 * cosine[4];
  // joint 5 "left_ball": placement, velocity and reference acceleration of its link
  const Real x157 = x99 * x145;
  const Real x159 = x99 * x151;
  const Real x160 = v[5] + x157;
  const Real x162 = v[7] + x159;
  // directions in which a loop holds its two links
  const Real x620 = 2.0 * x70 * 0.05;
  const Real x621 = x89 * 0.06;
  // directions in which a loop holds its two links
  const Real x868 = cosine[3] * x268 + sine[3] * x861;
  const Real x872 = cosine[3] * x861 - sine[3] * x268;
  const Real x886 = 0.05 * x872;
  // joint 3 "ankle_roll": inertia and bias force of what is beyond, its own motion left open
  const Real x2105 = sine[3] * (0.05 * x828 - 0.06 * x831);
  const Real x2107 = cosine[3] * (0.06 * x835) - x2105;
  const Real x2119 = sine[3] * (0.05 * x865 - 0.06 * x868);
  const Real x2121 = cosine[3] * (0.06 * x872) - x2119;
  // link 2 "shank": accelerations and constraint forces of loops below it are eliminated
  const Real x2514 = x849 * 4.0;
  const Real x2766 = x2511 * x2511 + 0.8464;
  const Real x2536 = x2530 + x2534 * x2534;
  const Real x2513 = x2107 * 4.0;
  const Real x2520 = x886 * 16.0;
  const Real x2538 = 2.0 * (1 / x2536);
  const Real x2544 = x2496 * x2500 - x2497 * x2501 + x2499 * x2534;
  const Real x2545 = x2538 * x2544;
  const Real x2560 = x2496 * x2505 - x2497 * x2506 + x2504 * x2534;
  const Real x2561 = x2538 * x2560;
  const Real x2575 = x2538 * (x2508 * x2534 - x2496 * x2509);
  const Real x2589 = x2538 * (x2513 * x2534 - x2496 * x2514);
  const Real x2519 = x2121 * 16.0;
  const Real x2549 = 1.2 * x2545;
  const Real x2565 = 1.2 * x2561;
  const Real x2578 = x2497 * x2575;
  const Real x2579 = 1.2 * x2575;
  const Real x2551 = x2500 - x2496 * x2545;
  const Real x2552 = x2501 + x2497 * x2545;
  const Real x2568 = x2506 + x2497 * x2561;
  const Real x2567 = x2505 - x2496 * x2561;
  const Real x2581 = x2509 + x2496 * x2575;
  const Real x2592 = x2497 * x2589;
  const Real x2593 = 1.2 * x2589;
  const Real x2620 = 1.44 + x2549 * x2549;
  const Real x2616 = x2552 * x2552;
  // joint 3 "ankle_roll": placement, velocity and reference acceleration of its link
  const Real x72 = x50 * sine[3];
  const Real x73 = x50 * cosine[3];
  // joint 4 "left_motor": placement, velocity and reference acceleration of its link
  const Real x107 = cosine[4] * x103 - x32 * sine[4];
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
  const Real x224 = cosine[5] * x220 - x32 * sine[5];
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
  // directions in which a loop holds its two links
  const Real x616 = (x78 + x80) * 0.05;
  const Real x618 = x72 - x616;
  const Real x624 = x620 + x621 - x55;
  const Real x619 = x73 - x412;
  const Real x629 = x600 * x618 + x597 * x624 + x604 * x619;
  // link 2 "shank": accelerations and constraint forces of loops below it are eliminated
  const Real x2595 = x2514 + x2496 * x2589;
  const Real x2603 = x2538 * (x2519 * x2534 - x2496 * x2520);
  const Real x2606 = x2497 * x2603;
  const Real x2607 = 1.2 * x2603;
  const Real x2609 = x2520 + x2496 * x2603;
  const Real x2624 = sign_of(x2551) * sqrt_of(x2551 * x2551 + x2620 + x2616);
  const Real x2625 = x2551 + x2624;
  // joint 7 "right_ball": placement, velocity and reference acceleration of its link
  const Real x277 = v[10] + x274;
  const Real x323 = x286 + x321;
  const Real x282 = v[11] * x274 - v[10] * x275;
  const Real x296 = x224 * x269 + x255 * x293;
  const Real x316 = x277 * x278;
  const Real x317 = x316 - x282;
  const Real x299 = x224 * x270 + x258 * x293;
  const Real x319 = x276 * x276 + x277 * x277;
  // directions in which a loop holds its two links
  const Real x665 = x618 * x655 + x624 * x652 + x619 * x659;
  const Real x701 = x618 * x691 + x624 * x688 + x619 * x695;
  // directions in which a loop holds its two links
  const Real x795 = x72 + x616;
  const Real x799 = x621 - x620 - x55;
  const Real x796 = x73 + x412;
  const Real x804 = x780 * x795 + x777 * x799 + x784 * x796;
  // link 2 "shank": accelerations and constraint forces of loops below it are eliminated
  const Real x2628 = x2616 + x2620 + x2625 * x2625;
  const Real x2883 = (x629 - (x181 - x208 * 0.15)) * 8.0 * (1 / x2533);
  const Real x2870 = (x665 - (x184 - x202 * 0.15)) * 8.0;
  const Real x2630 = 2.0 * (1 / x2628);
  const Real x2891 = 1 / x2624 * (x2870 + (x2499 - x2534 * x2545) * x2883);
  const Real x2637 = x2552 * x2568 + x2549 * x2565 + x2567 * x2625;
  const Real x2638 = x2630 * x2637;
  const Real x2656 = x2552 * x2578 + x2549 * x2579 - x2581 * x2625;
  const Real x2657 = x2630 * x2656;
  const Real x2676 = x2552 * x2592 + x2549 * x2593 - x2595 * x2625;
  const Real x2677 = x2630 * x2676;
  const Real x2696 = x2552 * x2606 + x2549 * x2607 - x2609 * x2625;
  const Real x2697 = x2630 * x2696;
  const Real x2871 = (x701 - (x187 + x204 * 0.15)) * 16.0;
  const Real x2642 = 1.2 * x2638;
  const Real x2661 = 1.2 * x2657;
  const Real x2681 = 1.2 * x2677;
  const Real x2647 = x2552 * x2638 - x2568;
  const Real x2712 = x2642 * x2642;
  const Real x2648 = x2549 * x2638 - x2565;
  const Real x2668 = x2549 * x2657 - x2579;
  const Real x2667 = x2552 * x2657 - x2578;
  const Real x2688 = x2549 * x2677 - x2593;
  const Real x2687 = x2552 * x2677 - x2592;
  const Real x2713 = x2648 * x2648;
  const Real x2701 = 1.2 * x2697;
  const Real x2708 = x2549 * x2697 - x2607;
  const Real x2707 = x2552 * x2697 - x2606;
  // joint 7 "right_ball": placement, velocity and reference acceleration of its link
  const Real x302 = x224 * x272 + x261 * x293;
  // directions in which a loop holds its two links
  const Real x541 = x155 * 0.15;
  // directions in which a loop holds its two links
  const Real x841 = x795 * x831 + x799 * x828 + x796 * x835;
  const Real x878 = x795 * x868 + x799 * x865 + x796 * x872;
  // joint 7 "right_ball": inertia and bias force of what is beyond, its own motion left open
  const Real x1029 = x269 * 0.15;
  const Real x1030 = x270 * 0.15;
  const Real x1031 = x272 * 0.15;
  const Real x897 = x262 * 0.00264635;
  const Real x900 = x265 * 0.01725;
  const Real x914 = x262 * 0.01725;
  const Real x924 = x268 * 2.7e-06;
  const Real x909 = x265 * 0.00264635;
  const Real x898 = x270 * 0.01725;
  const Real x910 = x269 * 0.01725;
  const Real x1042 = x269 * x1029 + x270 * x1030 + x272 * x1031;
  const Real x990 = x270 * x914 - x269 * x900;
  const Real x906 = x897 + 0.06 * x898;
  const Real x921 = x909 - 0.06 * x910;
  const Real x1073 = x990 + 0.06 * x1042;
  const Real x1028 = x262 * x897 + x268 * x924 + x265 * x909;
  // joint 5 "left_ball": inertia and bias force of what is beyond, its own motion left open
  const Real x1495 = x153 * 0.15;
  const Real x1507 = x152 * 0.15;
  const Real x1467 = x145 * 0.00112635;
  const Real x1470 = x148 * 0.01125;
  const Real x1484 = x145 * 0.01125;
  const Real x1494 = x151 * 2.7e-06;
  const Real x1479 = x148 * 0.00112635;
  // link 2 "shank": accelerations and constraint forces of loops below it are eliminated
  const Real x2872 = (x804 - (x296 - x323 * 0.23)) * 4.0;
  const Real x2899 = x2871 + (x2504 - x2534 * x2561) * x2883;
  const Real x2913 = x2872 + (x2508 - x2534 * x2575) * x2883;
  const Real x2873 = (x841 - (x299 - x317 * 0.23)) * 4.0;
  const Real x2929 = x2873 + (x2513 - x2534 * x2589) * x2883;
  const Real x2874 = (x878 - (x302 + x319 * 0.23)) * 16.0;
  const Real x2717 = sign_of(x2647) * sqrt_of(x2647 * x2647 + x2712 + x2713);
  const Real x2948 = x2874 + (x2519 - x2534 * x2603) * x2883;
  const Real x2718 = x2647 + x2717;
  const Real x2721 = x2712 + x2713 + x2718 * x2718;
  // directions in which a loop holds its two links
  const Real x530 = cosine[3] * 0.05;
  // joint 7 "right_ball": inertia and bias force of what is beyond, its own motion left open
  const Real x1147 = x1028 + 0.06 * x990 + 0.06 * x1073 + 0.0002466667;
  const Real x899 = x258 * 0.01725;
  const Real x1148 = 0.006 + x1073;
  const Real x912 = x255 * 0.01725;
  const Real x1047 = x255 * x1029 + x258 * x1030 + x261 * x1031;
  const Real x1079 = x258 * x914 - x255 * x900 + 0.06 * x1047;
  // joint 6 "right_motor": inertia and bias force of what is beyond, its own motion left open
  const Real x1196 = sine[5] * x898 + cosine[5] * x899;
  const Real x1170 = sine[5] * x1148 + cosine[5] * x1079;
  // joint 5 "left_ball": inertia and bias force of what is beyond, its own motion left open
  const Real x1603 = x152 * x1507 + x153 * x1495 + x155 * x541;
  const Real x1468 = x153 * 0.01125;
  const Real x1480 = x152 * 0.01125;
  const Real x1560 = x153 * x1484 - x152 * x1470;
  const Real x1634 = x1560 + 0.06 * x1603;
  const Real x1476 = x1467 + 0.06 * x1468;
  const Real x1491 = x1479 - 0.06 * x1480;
  const Real x1598 = x145 * x1467 + x151 * x1494 + x148 * x1479;
  const Real x1469 = x141 * 0.01125;
  const Real x1708 = x1598 + 0.06 * x1560 + 0.06 * x1634 + 0.0002466667;
  // joint 3 "ankle_roll": inertia and bias force of what is beyond, its own motion left open
  const Real x2042 = sine[3] * 0.002;
  const Real x2156 = 0.00630833 + cosine[3] * (cosine[3] * 0.0019583400000000003) + 2.4e-05;
  // link 2 "shank": accelerations and constraint forces of loops below it are eliminated
  const Real x2903 = 1 / x2717 * ((x2567 - x2625 * x2638) * x2891 + x2899);
  const Real x2723 = 2.0 * (1 / x2721);
  const Real x2728 = x2642 * x2661 + x2648 * x2668 + x2667 * x2718;
  const Real x2729 = x2723 * x2728;
  const Real x2740 = x2642 * x2681 + x2648 * x2688 + x2687 * x2718;
  const Real x2741 = x2723 * x2740;
  const Real x2752 = x2642 * x2701 + x2648 * x2708 + x2707 * x2718;
  const Real x2753 = x2723 * x2752;
  const Real x2734 = x2661 - x2642 * x2729;
  const Real x2735 = x2668 - x2648 * x2729;
  const Real x2747 = x2688 - x2648 * x2741;
  const Real x2746 = x2681 - x2642 * x2741;
  const Real x2759 = x2708 - x2648 * x2753;
  const Real x2758 = x2701 - x2642 * x2753;
  const Real x2763 = x2735 * x2735;
  // joint 3 "ankle_roll": placement, velocity and reference acceleration of its link
  const Real x68 = v[3] * x66;
  const Real x85 = x77 + x80;
  // link 8 "right_rod": force that the reference field takes
  const Real x519 = x296 * 0.15 - x323 * 0.01725;
  const Real x523 = x299 * 0.15 - x317 * 0.01725;
  const Real x508 = (v[10] * x273 - v[9] * x274) * 2.7e-06;
  const Real x512 = x282 * 0.00264635 - x316 * 0.00264365 + x299 * 0.01725;
  const Real x527 = x302 * 0.15 + x319 * 0.01725;
  const Real x515 = x286 * 0.00264635 + x321 * 0.00264365 - x296 * 0.01725;
  // directions in which a loop holds its two links
  const Real x531 = sine[3] * 0.05;
  const Real x536 = sine[2] * x531;
  // joint 7 "right_ball": inertia and bias force of what is beyond, its own motion left open
  const Real x1127 = x269 * x519 + x270 * x523 + x272 * x527;
  // joint 6 "right_motor": inertia and bias force of what is beyond, its own motion left open
  const Real x1208 = x906 - 0.17 * x1196;
  const Real x1225 = sine[5] * x910 + cosine[5] * x912;
  const Real x1182 = x1147 - 0.17 * x1170;
  const Real x1238 = x921 + 0.17 * x1225;
  const Real x1167 = cosine[5] * x1148 - sine[5] * x1079;
  const Real x1193 = cosine[5] * x898 - sine[5] * x899;
  // joint 5 "left_ball": inertia and bias force of what is beyond, its own motion left open
  const Real x1608 = x138 * x1507 + x141 * x1495 + x144 * x541;
  const Real x1640 = x141 * x1484 - x138 * x1470 + 0.06 * x1608;
  const Real x1709 = 0.006 + x1634;
  const Real x1482 = x138 * 0.01125;
  // joint 4 "left_motor": inertia and bias force of what is beyond, its own motion left open
  const Real x1756 = sine[4] * x1468 + cosine[4] * x1469;
  const Real x1767 = x1476 - 0.25 * x1756;
  const Real x1731 = sine[4] * x1709 + cosine[4] * x1640;
  const Real x1784 = sine[4] * x1480 + cosine[4] * x1482;
  // joint 2 "ankle_pitch": inertia and bias force of what is beyond, its own motion left open
  const Real x2179 = sine[2] * 0.04 + cosine[2] * x530;
  const Real x2183 = x2156 + 0.4 * x2179;
  const Real x2196 = x2042 + 0.4 * x536;
  // link 2 "shank": accelerations and constraint forces of loops below it are eliminated
  const Real x2915 = (x2581 + x2625 * x2657) * x2891 - x2913;
  const Real x2931 = (x2595 + x2625 * x2677) * x2891 - x2929;
  const Real x2950 = (x2609 + x2625 * x2697) * x2891 - x2948;
  const Real x2770 = sign_of(x2734) * sqrt_of(x2734 * x2734 + x2766 + x2763);
  const Real x2771 = x2734 + x2770;
  const Real x2774 = x2763 + x2766 + x2771 * x2771;
  // link 4 "foot": force that the reference field takes
  const Real x385 = x68 * 0.002999997 - x68 * 0.00826667;
  const Real x405 = 0.002 * (x89 - x85) + x385 + x55 * 0.05;
  const Real x395 = x70 * 0.004958337 - x70 * 0.00630833 + x83 * 0.002;
  // link 6 "left_rod": force that the reference field takes
  const Real x463 = (v[6] * x157 - v[5] * x158) * 2.7e-06;
  const Real x474 = x181 * 0.15 - x208 * 0.01125;
  const Real x478 = x184 * 0.15 - x202 * 0.01125;
  const Real x467 = x166 * 0.00112635 - x201 * 0.00112365 + x184 * 0.01125;
  const Real x482 = x187 * 0.15 + x204 * 0.01125;
  const Real x470 = x170 * 0.00112635 + x206 * 0.00112365 - x181 * 0.01125;
  // directions in which a loop holds its two links
  const Real x543 = x144 * 0.15;
  const Real x532 = cosine[2] * x531;
  // joint 7 "right_ball": inertia and bias force of what is beyond, its own motion left open
  const Real x1122 = x262 * x512 + x268 * x508 + x265 * x515;
  const Real x892 = x512 - tau[9];
  const Real x1152 = x1122 + 0.06 * x1127 + x224 * 0.006;
  const Real x893 = x515 - tau[10];
  // joint 6 "right_motor": inertia and bias force of what is beyond, its own motion left open
  const Real x1220 = sine[5] * x912 - cosine[5] * x910;
  const Real x1156 = x1152 - tau[8];
  // joint 5 "left_ball": inertia and bias force of what is beyond, its own motion left open
  const Real x1464 = x463 - tau[7];
  const Real x1688 = x152 * x474 + x153 * x478 + x155 * x482;
  const Real x1462 = x467 - tau[5];
  // joint 4 "left_motor": inertia and bias force of what is beyond, its own motion left open
  const Real x1742 = x1708 - 0.25 * x1731;
  const Real x1796 = x1491 + 0.25 * x1784;
  const Real x1753 = cosine[4] * x1468 - sine[4] * x1469;
  // joint 2 "ankle_pitch": inertia and bias force of what is beyond, its own motion left open
  const Real x2174 = sine[2] * x530 - cosine[2] * 0.04;
  // link 2 "shank": accelerations and constraint forces of loops below it are eliminated
  const Real x2917 = 1 / x2770 * (x2915 - (x2667 - x2718 * x2729) * x2903);
  const Real x2776 = 2.0 * (1 / x2774);
  const Real x2782 = x2735 * x2747 - x2511 * x2516 + x2746 * x2771;
  const Real x2783 = x2776 * x2782;
  const Real x2798 = x2735 * x2759 - x2511 * x2522 + x2758 * x2771;
  const Real x2799 = x2776 * x2798;
  const Real x2787 = 0.92 * x2783;
  const Real x2803 = 0.92 * x2799;
  const Real x2789 = x2747 - x2735 * x2783;
  const Real x2790 = x2516 + x2511 * x2783;
  const Real x2806 = x2522 + x2511 * x2799;
  const Real x2805 = x2759 - x2735 * x2799;
  const Real x2816 = 0.8464 + x2787 * x2787;
  const Real x2812 = x2790 * x2790;
  // joint 7 "right_ball": inertia and bias force of what is beyond, its own motion left open
  const Real x1149 = 0.2 + x1042;
  const Real x1056 = x258 * (x258 * 0.15) + x261 * (x261 * 0.15);
  const Real x1150 = x255 * (x255 * 0.15) + x1056 + 0.2;
  const Real x1153 = x224 * 0.2 + x1127;
  const Real x1132 = x255 * x519 + x258 * x523 + x261 * x527;
  const Real x1154 = x231 * 0.006 - x229 * 0.2 + x1132;
  // joint 6 "right_motor": inertia and bias force of what is beyond, its own motion left open
  const Real x1358 = cosine[5] * (x1149 - x1150) - x1047 * (2.0 * sine[5]);
  const Real x1362 = cosine[5] * x1358;
  const Real x1364 = x1149 - x1362;
  const Real x1361 = x1047 + sine[5] * x1358;
  const Real x1446 = sine[5] * x1153 + cosine[5] * x1154;
  // joint 5 "left_ball": inertia and bias force of what is beyond, its own motion left open
  const Real x1683 = x145 * x467 + x151 * x463 + x148 * x470;
  const Real x1710 = 0.2 + x1603;
  const Real x1463 = x470 - tau[6];
  const Real x1617 = x141 * (x141 * 0.15) + x144 * x543;
  const Real x1713 = x1683 + 0.06 * x1688 + x107 * 0.006;
  const Real x1711 = x138 * (x138 * 0.15) + x1617 + 0.2;
  const Real x1714 = x107 * 0.2 + x1688;
  const Real x1693 = x138 * x474 + x141 * x478 + x144 * x482;
  const Real x1715 = x114 * 0.006 - x112 * 0.2 + x1693;
  // joint 4 "left_motor": inertia and bias force of what is beyond, its own motion left open
  const Real x1728 = cosine[4] * x1709 - sine[4] * x1640;
  const Real x1779 = sine[4] * x1482 - cosine[4] * x1480;
  const Real x1717 = x1713 - tau[4];
  const Real x1917 = cosine[4] * (x1710 - x1711) - x1608 * (2.0 * sine[4]);
  const Real x1921 = cosine[4] * x1917;
  const Real x1923 = x1710 - x1921;
  const Real x1920 = x1608 + sine[4] * x1917;
  // joint 3 "ankle_roll": inertia and bias force of what is beyond, its own motion left open
  const Real x2140 = cosine[3] * (x405 - x73 * 0.04);
  const Real x2143 = x2140 - sine[3] * (x395 + x72 * 0.04);
  const Real x2041 = x83 * 0.0019583400000000003 + x72 * 0.05 - tau[3];
  const Real x2152 = cosine[3] * (x73 + x85 * 0.05);
  const Real x2158 = sine[3] * (x72 + x412) + x2152 + x50 * 0.15;
  // link 4 "foot": force that the reference field takes
  const Real x423 = 2.0 * x68 * 0.05 - x89 * 0.04 - x55;
  // joint 3 "ankle_roll": inertia and bias force of what is beyond, its own motion left open
  const Real x2159 = x423 - x55 * 0.15;
  // joint 2 "ankle_pitch": inertia and bias force of what is beyond, its own motion left open
  const Real x2161 = x2143 - tau[2];
  const Real x2372 = -0.46 - x2179;
  // link 2 "shank": accelerations and constraint forces of loops below it are eliminated
  const Real x2932 = x2931 - (x2687 - x2718 * x2741) * x2903;
  const Real x2951 = x2950 - (x2707 - x2718 * x2753) * x2903;
  const Real x2820 = sign_of(x2789) * sqrt_of(x2789 * x2789 + x2816 + x2812);
  const Real x2821 = x2789 + x2820;
  // directions in which a loop holds its two links
  const Real x547 = -0.06 - x543;
  const Real x533 = sine[2] * 0.06;
  const Real x537 = cosine[2] * 0.06;
  // directions in which a loop holds its two links
  const Real x721 = x272 * 0.23;
  const Real x727 = -0.06 - x261 * 0.23;
  // joint 6 "right_motor": inertia and bias force of what is beyond, its own motion left open
  const Real x1386 = x1170 - 0.17 * x1364;
  // joint 4 "left_motor": inertia and bias force of what is beyond, its own motion left open
  const Real x2001 = sine[4] * x1714 + cosine[4] * x1715;
  const Real x1944 = x1731 - 0.25 * x1923;
  // joint 6 "right_motor": inertia and bias force of what is beyond, its own motion left open
  const Real x1443 = cosine[5] * x1153 - sine[5] * x1154;
  // joint 2 "ankle_pitch": inertia and bias force of what is beyond, its own motion left open
  const Real x2401 = sine[2] * x2158 + cosine[2] * x2159;
  // joint 4 "left_motor": inertia and bias force of what is beyond, its own motion left open
  const Real x2025 = x1167 - 0.17 * x1361 + (x1728 - 0.25 * x1920);
  const Real x2036 = x1152 - 0.17 * x1446 + (x1713 - 0.25 * x2001);
  const Real x2024 = x1182 - 0.17 * x1386 + (x1742 - 0.25 * x1944);
  const Real x2037 = cosine[4] * x1714 - sine[4] * x1715 + x1443;
  // link 2 "shank": accelerations and constraint forces of loops below it are eliminated
  const Real x2824 = x2812 + x2816 + x2821 * x2821;
  const Real x2934 = 1 / x2820 * ((x2746 - x2771 * x2783) * x2917 + x2932);
  const Real x2826 = 2.0 * (1 / x2824);
  const Real x2833 = x2790 * x2806 + x2787 * x2803 + x2805 * x2821;
  const Real x2834 = x2826 * x2833;
  const Real x2838 = 0.92 * x2834;
  const Real x2843 = x2790 * x2834 - x2806;
  const Real x2844 = x2787 * x2834 - x2803;
  // directions in which a loop holds its two links
  const Real x561 = x536 - x537 - (cosine[4] * x547 - sine[4] * x541);
  const Real x562 = x530 - (0.05 - x151 * 0.15);
  const Real x558 = -0.25 - (cosine[4] * x541 + sine[4] * x547);
  const Real x560 = x532 + x533 + -0.4 - x558;
  const Real x567 = x561 * x561 + x562 * x562 + x560 * x560;
  const Real x579 = 1e-08 - x567;
  require_more(w, x579, 0.0, kLoopOpen, 8);
  // directions in which a loop holds its two links
  const Real x741 = x536 + x537 + (cosine[5] * x727 - sine[5] * x721);
  const Real x743 = -0.05 - x268 * 0.23 + x530;
  const Real x738 = -0.17 - (cosine[5] * x721 + sine[5] * x727);
  const Real x740 = x533 - x532 + -0.4 - x738;
  const Real x762 = v[11] * v[11] + x757 + x572 + x80 + 1.0;
  const Real x751 = x741 * x741 + x743 * x743 + x740 * x740;
  const Real x761 = 1e-08 - x751;
  require_more(w, x761, 0.0, kLoopOpen, 9);
  // link 2 "shank": accelerations and constraint forces of loops below it are eliminated
  const Real x2952 = (x2758 - x2771 * x2799) * x2917 + x2951;
  const Real x2850 = x2843 * x2843 + x2838 * x2838 + x2844 * x2844;
  const Real x2851 = sqrt_of(x2850);
  const Real x2434 = v[6] * 0.15 + v[4] * x1506 + v[3] * x637;
  const Real x2435 = v[2] * x2048 + x2434;
  const Real x2444 = v[3] * x673 - (v[5] * 0.15 + v[4] * x1521);
  const Real x2445 = v[2] * x2063 + x2444;
  const Real x2464 = v[10] * 0.23 + v[8] * x936 - v[3] * x812;
  const Real x2465 = v[2] * x2093 + x2464;
  const Real x2475 = v[9] * 0.23 + v[8] * x951 + v[3] * x849;
  const Real x2477 = v[2] * x2107 - x2475;
  const Real x2451 = v[3] * x709 - v[4] * x1528 + v[2] * x2078;
  const Real x2485 = v[2] * x2121 - (v[8] * x958 + v[3] * x886);
  const Real x2857 = x2533 * x2533;
  require_more(w, x2857, 9.999999999999998e-15, kLoopSingular, 8);
  const Real x2859 = x2624 * x2624;
  require_more(w, x2859, 9.999999999999998e-15, kLoopSingular, 8);
  const Real x2861 = x2717 * x2717;
  require_more(w, x2861, 9.999999999999998e-15, kLoopSingular, 8);
  const Real x2863 = x2770 * x2770;
  require_more(w, x2863, 9.999999999999998e-15, kLoopSingular, 9);
  const Real x2865 = x2820 * x2820;
  require_more(w, x2865, 9.999999999999998e-15, kLoopSingular, 9);
  const Real x2852 = x2851 * x2851;
  require_more(w, x2852, 9.999999999999998e-15, kLoopSingular, 9);
  const Real x2456 = x2435 * x2435 + x2445 * x2445 + x2451 * x2451;
  const Real x2457 = x580 * 1.0000000000000002e-06 - x2456;
  require_more(w, x2457, 0.0, kLoopTorn, 8);
  const Real x2853 = x2850 + x2852;
  const Real x2490 = x2465 * x2465 + x2477 * x2477 + x2485 * x2485;
  const Real x2491 = 1.0000000000000002e-06 * x762 - x2490;
  require_more(w, x2491, 0.0, kLoopTorn, 9);
  const Real x2954 = 1 / x2851 * ((x2805 - x2821 * x2834) * x2934 + x2952);
  const Real x2855 = 2.0 * (1 / x2853);
  const Real x2956 = x2843 * x2855;
  const Real x2965 = x2838 * x2855;
  const Real x2974 = x2844 * x2855;
  const Real x2985 = x2855 * (x2851 * x2954);
  const Real x2959 = x2838 * x2956;
  const Real x2960 = x2844 * x2956;
  const Real x2967 = x2843 * x2965;
  const Real x2969 = x2844 * x2965;
  const Real x2976 = x2843 * x2974;
  const Real x2977 = x2838 * x2974;
  const Real x2989 = x2843 * x2985;
  const Real x2991 = x2838 * x2985;
  const Real x2962 = 1.0 - x2843 * x2956;
  const Real x2972 = 1.0 - x2838 * x2965;
  const Real x2982 = 1.0 - x2844 * x2974;
  const Real x2993 = x2844 * x2985;
  const Real x2957 = x2851 * x2956;
  const Real x2966 = x2851 * x2965;
  const Real x2975 = x2851 * x2974;
  const Real x3394 = x1494 * x2957;
  const Real x3402 = x1494 * x2966;
  const Real x3410 = x1494 * x2975;
  const Real x3003 = 0.92 * x2959 + x2787 * x2960 - x2790 * x2962;
  const Real x3004 = x2826 * x3003;
  const Real x2995 = x2851 * x2985 - x2954;
  const Real x3023 = x2790 * x2967 + x2787 * x2969 - 0.92 * x2972;
  const Real x3024 = x2826 * x3023;
  const Real x3043 = x2790 * x2976 + 0.92 * x2977 - x2787 * x2982;
  const Real x3044 = x2826 * x3043;
  const Real x3066 = x2821 * x2934 + x2790 * x2989 + 0.92 * x2991;
  const Real x3005 = x2821 * x3004;
  const Real x3025 = x2821 * x3024;
  const Real x3045 = x2821 * x3044;
  const Real x3070 = x2826 * (x2787 * x2993 + x3066);
  const Real x3013 = x2962 + x2790 * x3004;
  const Real x3015 = x2787 * x3004 - x2960;
  const Real x3033 = x2790 * x3024 - x2967;
  const Real x3035 = x2787 * x3024 - x2969;
  const Real x3053 = x2790 * x3044 - x2976;
  const Real x3055 = x2982 + x2787 * x3044;
  const Real x3014 = 0.92 * x3004 - x2959;
  const Real x3080 = x2821 * x3070 - x2934;
  const Real x3034 = x2972 + 0.92 * x3024;
  const Real x3081 = x2989 - x2790 * x3070;
  const Real x3083 = x2993 - x2787 * x3070;
  const Real x3054 = 0.92 * x3044 - x2977;
  const Real x3089 = x2511 * x3013 - x2735 * x3005 + 0.92 * x3015;
  const Real x3090 = x2776 * x3089;
  const Real x3105 = x2511 * x3033 - x2735 * x3025 + 0.92 * x3035;
  const Real x3106 = x2776 * x3105;
  const Real x3082 = x2991 - 0.92 * x3070;
  const Real x3121 = x2511 * x3053 - x2735 * x3045 + 0.92 * x3055;
  const Real x3122 = x2776 * x3121;
  const Real x3091 = x2771 * x3090;
  const Real x3107 = x2771 * x3106;
  const Real x3123 = x2771 * x3122;
  const Real x3096 = x3005 + x2735 * x3090;
  const Real x3098 = x3013 - x2511 * x3090;
  const Real x3112 = x3025 + x2735 * x3106;
  const Real x3099 = x3015 - 0.92 * x3090;
  const Real x3128 = x3045 + x2735 * x3122;
  const Real x3114 = x3033 - x2511 * x3106;
  const Real x3115 = x3035 - 0.92 * x3106;
  const Real x3462 = x906 * x3098 + 0.00264635 * x3014;
  const Real x3471 = x921 * x3098 + 0.00264635 * x3099;
  const Real x3465 = x906 * x3114 + 0.00264635 * x3034;
  const Real x3156 = x2723 * (x2642 * x3091 + x2648 * x3096);
  const Real x3138 = x2735 * x3080 - x2771 * x2917 + x2511 * x3081;
  const Real x3449 = x1147 * x3098 + x906 * x3014 + x921 * x3099;
  const Real x3172 = x2723 * (x2642 * x3107 + x2648 * x3112);
  const Real x3474 = x921 * x3114 + 0.00264635 * x3115;
  const Real x3188 = x2723 * (x2642 * x3123 + x2648 * x3128);
  const Real x3130 = x3053 - x2511 * x3122;
  const Real x3454 = x1147 * x3114 + x906 * x3034 + x921 * x3115;
  const Real x3158 = x2718 * x3156;
  const Real x3174 = x2718 * x3172;
  const Real x3190 = x2718 * x3188;
  const Real x3164 = x2642 * x3156 - x3091;
  const Real x3165 = x2648 * x3156 - x3096;
  const Real x3180 = x2642 * x3172 - x3107;
  const Real x3181 = x2648 * x3172 - x3112;
  const Real x3196 = x2642 * x3188 - x3123;
  const Real x3197 = x2648 * x3188 - x3128;
  const Real x3131 = x3055 - 0.92 * x3122;
  const Real x3140 = x2776 * (0.92 * x3083 + x3138);
  const Real x3145 = x2917 + x2771 * x3140;
  const Real x3468 = x906 * x3130 + 0.00264635 * x3054;
  const Real x3477 = x921 * x3130 + 0.00264635 * x3131;
  const Real x3220 = x2552 * x3158 + 1.2 * x3164 + x2549 * x3165;
  const Real x3222 = x2630 * x3220;
  const Real x3147 = x3080 - x2735 * x3140;
  const Real x3243 = x2552 * x3174 + 1.2 * x3180 + x2549 * x3181;
  const Real x3245 = x2630 * x3243;
  const Real x3459 = x1147 * x3130 + x906 * x3054 + x921 * x3131;
  const Real x3266 = x2552 * x3190 + 1.2 * x3196 + x2549 * x3197;
  const Real x3268 = x2630 * x3266;
  const Real x3224 = x2625 * x3222;
  const Real x3247 = x2625 * x3245;
  const Real x3270 = x2625 * x3268;
  const Real x3232 = x3158 - x2552 * x3222;
  const Real x3234 = x3165 - x2549 * x3222;
  const Real x3255 = x3174 - x2552 * x3245;
  const Real x3257 = x3181 - x2549 * x3245;
  const Real x3233 = x3164 - 1.2 * x3222;
  const Real x3278 = x3190 - x2552 * x3268;
  const Real x3280 = x3197 - x2549 * x3268;
  const Real x3256 = x3180 - 1.2 * x3245;
  const Real x3279 = x3196 - 1.2 * x3268;
  const Real x3307 = x2496 * x3224 + x2497 * x3232 + 1.2 * x3234;
  const Real x3308 = x2538 * x3307;
  const Real x3203 = x2718 * x2903 - x2642 * x3145 + x2648 * x3147;
  const Real x3204 = x2723 * x3203;
  const Real x3321 = x2496 * x3247 + x2497 * x3255 + 1.2 * x3257;
  const Real x3322 = x2538 * x3321;
  const Real x3335 = x2496 * x3270 + x2497 * x3278 + 1.2 * x3280;
  const Real x3336 = x2538 * x3335;
  const Real x3309 = x2534 * x3308;
  const Real x3323 = x2534 * x3322;
  const Real x3337 = x2534 * x3336;
  const Real x3314 = x3224 - x2496 * x3308;
  const Real x3315 = x3232 - x2497 * x3308;
  const Real x3316 = x3234 - 1.2 * x3308;
  const Real x3328 = x3247 - x2496 * x3322;
  const Real x3329 = x3255 - x2497 * x3322;
  const Real x3330 = x3257 - 1.2 * x3322;
  const Real x3342 = x3270 - x2496 * x3336;
  const Real x3365 = x2156 * x3309 + x2042 * x3314;
  const Real x3382 = x2042 * x3309 + 0.003308333 * x3314;
  const Real x3417 = x1476 * x3315 + 0.00112635 * x3233;
  const Real x3426 = x1491 * x3315 + 0.00112635 * x3316;
  const Real x3371 = x2156 * x3323 + x2042 * x3328;
  const Real x3436 = x1494 * x3315 - 2.7e-06 * x2957;
  const Real x3386 = x2042 * x3323 + 0.003308333 * x3328;
  const Real x3420 = x1476 * x3329 + 0.00112635 * x3256;
  const Real x3397 = x1476 * x3233 - x3394 + x1708 * x3315;
  const Real x3398 = x1491 * x3316 + x3397;
  const Real x3429 = x1491 * x3329 + 0.00112635 * x3330;
  const Real x3715 = x3014 * x3462 + x3099 * x3471 + x3098 * x3449;
  const Real x3734 = x3014 * x3465 + x3099 * x3474 + x3098 * x3454;
  const Real x3440 = x1494 * x3329 - 2.7e-06 * x2966;
  const Real x3791 = x3034 * x3465 + x3115 * x3474 + x3114 * x3454;
  const Real x3343 = x3278 - x2497 * x3336;
  const Real x3377 = x2156 * x3337 + x2042 * x3342;
  const Real x3405 = x1476 * x3256 - x3402 + x1708 * x3329;
  const Real x3406 = x1491 * x3330 + x3405;
  const Real x3717 = x3309 * x3365 + x3715 + x3314 * x3382;
  const Real x3344 = x3280 - 1.2 * x3336;
  const Real x3736 = x3309 * x3371 + x3734 + x3314 * x3386;
  const Real x3390 = x2042 * x3337 + 0.003308333 * x3342;
  const Real x3793 = x3323 * x3371 + x3791 + x3328 * x3386;
  const Real x3423 = x1476 * x3343 + 0.00112635 * x3279;
  const Real x3753 = x3014 * x3468 + x3099 * x3477 + x3098 * x3459;
  const Real x3719 = x3233 * x3417 + x3717 + x3316 * x3426;
  const Real x3432 = x1491 * x3343 + 0.00112635 * x3344;
  const Real x3738 = x3233 * x3420 + x3736 + x3316 * x3429;
  const Real x3810 = x3034 * x3468 + x3115 * x3477 + x3114 * x3459;
  const Real x3721 = x3719 - x2957 * x3436 + x3315 * x3398;
  require_more(w, x3721, 0.0, kLoopFree, 2);
  const Real x3208 = x2903 - x2718 * x3204;
  const Real x3795 = x3256 * x3420 + x3793 + x3330 * x3429;
  const Real x3740 = x3738 - x2957 * x3440 + x3315 * x3406;
  const Real x3444 = x1494 * x3343 - 2.7e-06 * x2975;
  const Real x3755 = x3309 * x3377 + x3753 + x3314 * x3390;
  const Real x4189 = 1 / x3721;
  const Real x3797 = x3795 - x2966 * x3440 + x3329 * x3406;
  const Real x3209 = x3145 + x2642 * x3204;
  const Real x3413 = x1476 * x3279 - x3410 + x1708 * x3343;
  const Real x3414 = x1491 * x3344 + x3413;
  const Real x3812 = x3323 * x3377 + x3810 + x3328 * x3390;
  const Real x3867 = x3054 * x3468 + x3131 * x3477 + x3130 * x3459;
  const Real x3211 = x3147 - x2648 * x3204;
  const Real x3757 = x3233 * x3423 + x3755 + x3316 * x3432;
  const Real x3999 = x1208 * x3014 - x3394 + x1182 * x3098;
  const Real x3759 = x3757 - x2957 * x3444 + x3315 * x3414;
  const Real x3814 = x3256 * x3423 + x3812 + x3330 * x3432;
  const Real x3869 = x3337 * x3377 + x3867 + x3342 * x3390;
  const Real x4190 = x3740 * x4189;
  const Real x3289 = x2625 * x2891 - x2552 * x3208 + 1.2 * x3209;
  const Real x3478 = x924 * x3098;
  const Real x4191 = x3759 * x4189;
  const Real x4017 = x1208 * x3034 - x3402 + x1182 * x3114;
  const Real x3291 = x2630 * (x3289 - x2549 * x3211);
  const Real x3871 = x3279 * x3423 + x3869 + x3344 * x3432;
  const Real x4195 = x3797 - x3740 * x4190;
  const Real x3816 = x3814 - x2966 * x3444 + x3329 * x3414;
  const Real x4198 = x3816 - x3759 * x4190;
  const Real x4001 = x1238 * x3099 + x3999 + x1767 * x3233;
  const Real x3873 = x3871 - x2975 * x3444 + x3343 * x3414;
  const Real x4202 = 1 / x4195;
  const Real x4035 = x1208 * x3054 - x3410 + x1182 * x3130;
  const Real x3299 = x2891 - x2625 * x3291;
  const Real x3300 = x3208 + x2552 * x3291;
  const Real x3302 = x3211 + x2549 * x3291;
  const Real x4201 = x924 * x3114 - x3478 * x4190;
  const Real x3149 = x3083 - 0.92 * x3140;
  const Real x4019 = x1238 * x3115 + x4017 + x1767 * x3256;
  const Real x4192 = x3478 * x4189;
  const Real x4203 = x4198 * x4202;
  const Real x3148 = x3081 - x2511 * x3140;
  const Real x4003 = x4001 - x2183 * x3309 - x2196 * x3314;
  const Real x3350 = x2534 * x2883 + x2496 * x3299 + x2497 * x3300;
  const Real x4037 = x1238 * x3131 + x4035 + x1767 * x3279;
  const Real x4210 = x3873 - x3759 * x4191 - x4198 * x4203;
  const Real x4102 = x1170 * x3098 + x1196 * x3014 - x1225 * x3099;
  const Real x4204 = x4201 * x4202;
  const Real x4216 = x924 * x3130 - x3478 * x4191 - x4201 * x4203;
  const Real x4217 = 1 / x4210;
  const Real x3301 = 1.2 * x3291 - x3209;
  const Real x3352 = x2538 * (1.2 * x3302 + x3350);
  const Real x4005 = x1742 * x3315 + x4003 + x1796 * x3316;
  const Real x4021 = x4019 - x2183 * x3323 - x2196 * x3328;
  const Real x4052 = x1167 * x3098 + x1193 * x3014 + x1220 * x3099;
  const Real x4120 = x1170 * x3114 + x1196 * x3034 - x1225 * x3115;
  const Real x4218 = x4216 * x4217;
  const Real x4023 = x1742 * x3329 + x4021 + x1796 * x3330;
  const Real x4039 = x4037 - x2183 * x3337 - x2196 * x3342;
  const Real x4068 = x1167 * x3114 + x1193 * x3034 + x1220 * x3115;
  const Real x4104 = x1756 * x3233 + x4102 + x2179 * x3309;
  const Real x4138 = x1170 * x3130 + x1196 * x3054 - x1225 * x3131;
  const Real x3357 = x2883 - x2534 * x3352;
  const Real x3493 = x892 * x3014 - x1464 * x2957 + x1156 * x3098;
  const Real x3549 = x3082 * x3462 + x3149 * x3471 + x3148 * x3449;
  const Real x4041 = x1742 * x3343 + x4039 + x1796 * x3344;
  const Real x4241 = x4023 - x4005 * x4190;
  const Real x4054 = x1753 * x3233 + x4052 - x2174 * x3309;
  const Real x4084 = x1167 * x3130 + x1193 * x3054 + x1220 * x3131;
  const Real x4122 = x1756 * x3256 + x4120 + x2179 * x3323;
  const Real x4226 = 2.7e-06 - x3478 * x4192 - x4201 * x4204;
  const Real x4227 = x4226 - x4216 * x4218;
  require_more(w, x4227, 4.796163466380676e-21, kLoopFree, 5);
  const Real x3358 = x3299 - x2496 * x3352;
  const Real x3512 = x892 * x3034 - x1464 * x2966 + x1156 * x3114;
  const Real x3567 = x3082 * x3465 + x3149 * x3474 + x3148 * x3454;
  const Real x4070 = x1753 * x3256 + x4068 - x2174 * x3323;
  const Real x4106 = x536 * x3314 + x4104 + x1731 * x3315;
  const Real x4107 = x4106 - x1784 * x3316;
  const Real x4140 = x1756 * x3279 + x4138 + x2179 * x3337;
  const Real x4228 = 1 / x4227;
  const Real x3359 = x3300 - x2497 * x3352;
  const Real x3495 = x893 * x3099 + x3493 + x1462 * x3233;
  const Real x3531 = x892 * x3054 - x1464 * x2975 + x1156 * x3130;
  const Real x3551 = x3301 * x3417 + x3549 + x2995 * x3436;
  const Real x3585 = x3082 * x3468 + x3149 * x3477 + x3148 * x3459;
  const Real x4271 = x4041 - x4005 * x4191 - x4203 * x4241;
  const Real x4056 = x532 * x3314 + x4054 + x1728 * x3315;
  const Real x4057 = x1779 * x3316 + x4056;
  const Real x4086 = x1753 * x3279 + x4084 - x2174 * x3337;
  const Real x4124 = x536 * x3328 + x4122 + x1731 * x3329;
  const Real x4125 = x4124 - x1784 * x3330;
  const Real x3360 = x3302 - 1.2 * x3352;
  const Real x3514 = x893 * x3115 + x3512 + x1462 * x3256;
  const Real x3569 = x3301 * x3420 + x3567 + x2995 * x3440;
  const Real x4072 = x532 * x3328 + x4070 + x1728 * x3329;
  const Real x4073 = x1779 * x3330 + x4072;
  const Real x4142 = x536 * x3342 + x4140 + x1731 * x3343;
  const Real x4143 = x4142 - x1784 * x3344;
  const Real x4247 = x4125 - x4107 * x4190;
  const Real x3497 = x3495 - x2161 * x3309 + x2041 * x3314;
  const Real x3533 = x893 * x3131 + x3531 + x1462 * x3279;
  const Real x3553 = x3551 - x3357 * x3365 + x3358 * x3382;
  const Real x3587 = x3301 * x3423 + x3585 + x2995 * x3444;
  const Real x4321 = x924 - x4005 * x4192 - x4204 * x4241;
  const Real x4088 = x532 * x3342 + x4086 + x1728 * x3343;
  const Real x4089 = x1779 * x3344 + x4088;
  const Real x4244 = x4073 - x4057 * x4190;
  const Real x3516 = x3514 - x2161 * x3323 + x2041 * x3328;
  const Real x3571 = x3569 - x3357 * x3371 + x3358 * x3386;
  const Real x4385 = x4228 * (x4321 - x4218 * x4271);
  const Real x4283 = x4143 - x4107 * x4191 - x4203 * x4247;
  const Real x3535 = x3533 - x2161 * x3337 + x2041 * x3342;
  const Real x3589 = x3587 - x3357 * x3377 + x3358 * x3390;
  const Real x3499 = x1717 * x3315 + x3497 + x1463 * x3316;
  const Real x3593 = x3359 * x3398 + x3553 + x3360 * x3426 + x3499;
  const Real x4277 = x4089 - x4057 * x4191 - x4203 * x4244;
  const Real x3518 = x1717 * x3329 + x3516 + x1463 * x3330;
  const Real x4401 = x4217 * x4271 - x4218 * x4385;
  const Real x3537 = x1717 * x3343 + x3535 + x1463 * x3344;
  const Real x3594 = x3359 * x3406 + x3571 + x3360 * x3429 + x3518;
  const Real x4253 = x3594 - x3593 * x4190;
  const Real x4341 = x4107 * x4192 + x4204 * x4247 + x4218 * x4283;
  const Real x4388 = x4228 * x4341;
  const Real x3595 = x3359 * x3414 + x3589 + x3360 * x3432 + x3537;
  const Real x4431 = x4202 * x4241 - x4204 * x4385 - x4203 * x4401;
  const Real x4331 = x4057 * x4192 + x4204 * x4244 + x4218 * x4277;
  const Real x4386 = x4228 * x4331;
  const Real x4295 = x3595 - x3593 * x4191 - x4203 * x4253;
  const Real x4359 = x508 - tau[11] + x924 * x3148 - x3593 * x4192;
  const Real x4407 = x4217 * x4283 + x4218 * x4388;
  const Real x4481 = x4005 * x4189 - x4192 * x4385 - x4191 * x4401;
  const Real x4482 = x4481 - x4190 * x4431;
  const Real x4404 = x4217 * x4277 + x4218 * x4386;
  const Real x4443 = x4202 * x4247 + x4204 * x4388 - x4203 * x4407;
  const Real x4392 = x4228 * (x4359 - x4204 * x4253 - x4218 * x4295);
  const Real x4643 = x4041 * x4401 + x924 * x4385 + x4023 * x4431;
  const Real x4437 = x4202 * x4244 + x4204 * x4386 - x4203 * x4404;
  // joint 2 "ankle_pitch": inertia and bias force of what is beyond, its own motion left open
  const Real x2417 = x2183 - 0.4 * x2372 + x2024;
  // link 2 "shank": accelerations and constraint forces of loops below it are eliminated
  const Real x4499 = x4107 * x4189 + x4192 * x4388 - x4191 * x4407;
  const Real x4500 = x4499 - x4190 * x4443;
  const Real x3642 = x1494 * x2995 + x1208 * x3082 + x1182 * x3148;
  const Real x4413 = x4217 * x4295 - x4218 * x4392;
  const Real x4781 = x2417 - (x4005 * x4482 + x4643) + 0.18885420000000003;
  require_more(w, x4781, 0.0, kFactorization, 1);
  const Real x4490 = x4057 * x4189 + x4192 * x4386 - x4191 * x4404;
  const Real x4491 = x4490 - x4190 * x4437;
  const Real x4661 = x4041 * x4407 - x924 * x4388 + x4023 * x4443;
  const Real x3644 = x1238 * x3149 + x3642 + x1767 * x3301;
  const Real x4455 = x4202 * x4253 - x4204 * x4392 - x4203 * x4413;
  const Real x4652 = x4041 * x4404 - x924 * x4386 + x4023 * x4437;
  // joint 1 "knee": articulated-body inertia and bias force through it
  const Real x4790 = 1 / x4781;
  // link 2 "shank": accelerations and constraint forces of loops below it are eliminated
  const Real x4721 = x2025 + x2174 - (x4005 * x4491 + x4652);
  const Real x4722 = x1386 + x1944 + x2372 - (x4005 * x4500 + x4661);
  const Real x4782 = -0.7000000000000001 + x4722;
  const Real x3646 = x2183 * x3357 + x3644 - x2196 * x3358;
  const Real x3658 = x1167 * x3148 + x1193 * x3082 + x1220 * x3149;
  const Real x3676 = x1170 * x3148 + x1196 * x3082 - x1225 * x3149;
  const Real x4517 = x3593 * x4189 - x4192 * x4392 - x4191 * x4413;
  const Real x4518 = x4517 - x4190 * x4455;
  const Real x4677 = x4073 * x4437 + x4089 * x4404 + x4057 * x4491;
  const Real x4695 = x4125 * x4443 + x4143 * x4407 + x4107 * x4500;
  const Real x4724 = x1150 + x1362 + (x1711 + x1921) + 1.15 - x4677;
  const Real x3660 = x1753 * x3301 + x3658 + x2174 * x3357;
  const Real x3678 = x1756 * x3301 + x3676 - x2179 * x3357;
  const Real x3648 = x1742 * x3359 + x3646 + x1796 * x3360;
  const Real x4749 = x4041 * x4413 + x924 * x4392 + x4023 * x4455;
  const Real x4683 = x4073 * x4443 + x4089 * x4407 + x4057 * x4500;
  const Real x3699 = x2143 - 0.4 * x2401 + x2036 + x3648;
  const Real x3662 = x532 * x3358 + x3660 + x1728 * x3359;
  const Real x4230 = x3797 * 1.7763568394002505e-15;
  require_more(w, x4195, x4230, kLoopFree, 3);
  const Real x3680 = x536 * x3358 + x3678 + x1731 * x3359;
  const Real x4231 = x3873 * 1.7763568394002505e-15;
  require_more(w, x4210, x4231, kLoopFree, 4);
  // joint 2 "ankle_pitch": inertia and bias force of what is beyond, its own motion left open
  const Real x2426 = cosine[2] * x2158 - sine[2] * x2159 + x2037;
  // link 2 "shank": accelerations and constraint forces of loops below it are eliminated
  const Real x4755 = x4073 * x4455 + x4089 * x4413 + x4057 * x4518;
  const Real x3701 = x1446 + x2001 + x2401 + (x3680 - x1784 * x3360);
  const Real x4760 = x4125 * x4455 + x4143 * x4413 + x4107 * x4518;
  const Real x4775 = x1779 * x3360 + x3662 + x2426 - x4755;
  // joint 1 "knee": articulated-body inertia and bias force through it
  const Real x4795 = x4721 * x4790;
  const Real x4796 = x4782 * x4790;
  const Real x4827 = 3.5 + x4724 - x4721 * x4795;
  // link 2 "shank": accelerations and constraint forces of loops below it are eliminated
  const Real x4784 = x1364 + x1923 + 1.15 - x4695 + 3.5;
  // joint 1 "knee": articulated-body inertia and bias force through it
  const Real x4830 = x1361 + x1920 - x4683 - x4721 * x4796;
  // link 2 "shank": accelerations and constraint forces of loops below it are eliminated
  const Real x4786 = x3699 - (x4005 * x4518 + x4749) + x32 * 0.7000000000000001;
  // joint 1 "knee": articulated-body inertia and bias force through it
  const Real x4894 = cosine[1] * (x4827 - (x4784 - x4782 * x4796));
  const Real x4792 = x4790 * (tau[1] - x4786);
  // link 2 "shank": accelerations and constraint forces of loops below it are eliminated
  const Real x4787 = x27 * 3.5 + x36 * 0.7000000000000001 + x4775;
  // joint 1 "knee": articulated-body inertia and bias force through it
  const Real x4903 = x4827 - cosine[1] * (x4894 - x4830 * (sine[1] * 2.0));
  const Real x4850 = x3701 - x4760 - x32 * 3.5 + x4782 * x4792;
  const Real x4955 = 0.32735000000000003 + 0.4 * (0.4 * x4903);
  require_more(w, x4955, 0.0, kFactorization, 0);
  const Real x4945 = sine[1] * (x4787 + x4721 * x4792) + cosine[1] * x4850;
  // joint 0 "hip": articulated-body inertia and bias force through it
  const Real x4965 = tau[0] - (tau[1] - 0.4 * x4945 + x9 * 1.2000000000000002);
  const Real x4966 = 1 / x4955 * x4965;
  w.result[0] = x4966;
  // joint 1 "knee": its acceleration, and that of the link beyond
  const Real x4976 = 0.4 * x4966;
  const Real x4978 = sine[1] * x4976;
  const Real x4980 = cosine[1] * x4976;
  const Real x4987 = x4792 + x4795 * x4978 + x4796 * x4980;
  const Real x4988 = x4987 - x4966;
  w.result[1] = x4988;
  // link 2 "shank": accelerations and constraint forces of loops below it
  const Real x4996 = x4491 * x4978 + x4500 * x4980 - x4482 * x4987;
  const Real x5023 = x4996 - x4518;
  const Real x5004 = x4437 * x4978 + x4443 * x4980 - x4431 * x4987;
  const Real x5024 = x5004 - x4455;
  const Real x5012 = x4404 * x4978 + x4407 * x4980 - x4401 * x4987;
  const Real x5025 = x5012 - x4413;
  const Real x5021 = x4386 * x4978 + x4388 * x4980 + x4385 * x4987;
  const Real x5027 = -(x4392 + x5021);
  w.result[11] = x5027;
  const Real x5036 = x3309 * x5023 + x3323 * x5024 + x3337 * x5025;
  const Real x5083 = x3357 - x5036;
  w.result[2] = x5083;
  const Real x5042 = x3314 * x5023 + x3328 * x5024 + x3342 * x5025;
  const Real x5084 = x3358 + x5042;
  w.result[3] = x5084;
  const Real x5047 = x3315 * x5023 + x3329 * x5024 + x3343 * x5025;
  const Real x5085 = x3359 + x5047;
  w.result[4] = x5085;
  const Real x5052 = x3233 * x5023 + x3256 * x5024 + x3279 * x5025;
  const Real x5086 = x3301 + x5052;
  w.result[5] = x5086;
  const Real x5057 = x3316 * x5023 + x3330 * x5024 + x3344 * x5025;
  const Real x5087 = x3360 + x5057;
  w.result[6] = x5087;
  const Real x5066 = x2957 * x5023 + x2966 * x5024 + x2975 * x5025;
  const Real x5088 = x2995 - x5066;
  w.result[7] = x5088;
  const Real x5072 = x3098 * x5023 + x3114 * x5024 + x3130 * x5025;
  const Real x5089 = x3148 + x5072;
  w.result[8] = x5089;
  const Real x5077 = x3014 * x5023 + x3034 * x5024 + x3054 * x5025;
  const Real x5090 = x3082 + x5077;
  w.result[9] = x5090;
  const Real x5082 = x3099 * x5023 + x3115 * x5024 + x3131 * x5025;
  const Real x5091 = x3149 + x5082;
  w.result[10] = x5091;
}

// ---- 5. processes -------------------------------------------------------------------------------

// Process 0: 8 of 8 joints: "hip", "knee", "ankle_pitch", "ankle_roll", "left_motor", "left_ball", ...
constexpr std::array<int, 8> kRead_0{0, 1, 2, 3, 4, 5, 6, 7};
constexpr std::array<int, 8> kOwned_0{0, 1, 2, 3, 4, 5, 6, 7};
constexpr std::array<int, 6> kAngles_0{4, 9, 0, 1, 2, 3};

ADAGEN_AS_IT_STANDS void run_0([[maybe_unused]] Workspace& w, [[maybe_unused]] Channel& channel) {
  ADAGEN_INPUTS
  stamp(0);
  take_sines_and_cosines(q, kAngles_0, w.sine.data(), w.cosine.data());
  part_0_0(w);
  stamp(1);
  stamp(2);
  stamp(3);
  if (__builtin_expect(w.status != kFine || !all(unlike_zero(w.result.data() + 0, 4) + unlike_zero<Two, 4>(w.lanes.data() + 0) == 0), 0)) {
    w.result[4] = w.lanes[0];
    w.result[5] = w.lanes[2];
    w.result[6] = w.lanes[4];
    w.result[7] = w.lanes[6];
    w.result[8] = w.lanes[1];
    w.result[9] = w.lanes[3];
    w.result[10] = w.lanes[5];
    w.result[11] = w.lanes[7];
    find_fault(w, kRead_0, kOwned_0);
  }
  if (w.status != kFine) return;
  std::copy_n(w.result.data() + 0, 4, w.qdd + 0);
  w.qdd[4] = w.lanes[0];
  w.qdd[5] = w.lanes[2];
  w.qdd[6] = w.lanes[4];
  w.qdd[7] = w.lanes[6];
  w.qdd[8] = w.lanes[1];
  w.qdd[9] = w.lanes[3];
  w.qdd[10] = w.lanes[5];
  w.qdd[11] = w.lanes[7];
}


// Alternative for poses in which a mobility is singular.
constexpr std::array<int, 6> kAngles_1{0, 1, 2, 3, 4, 9};
ADAGEN_AS_IT_STANDS void recover_0([[maybe_unused]] Workspace& w, [[maybe_unused]] Channel& channel) {
  ADAGEN_INPUTS
  stamp(0);
  take_sines_and_cosines(q, kAngles_1, w.sine.data(), w.cosine.data());
  part_1_0(w);
  stamp(1);
  stamp(2);
  stamp(3);
  if (__builtin_expect(w.status != kFine || !all(unlike_zero(w.result.data() + 0, 12) == 0), 0)) {
    find_fault(w, kRead_0, kOwned_0);
  }
  if (w.status != kFine) return;
  std::copy_n(w.result.data() + 0, 12, w.qdd + 0);
}

[[maybe_unused]] constexpr std::array<StageInfo, 3> kStages_0{ {{"kinematics", 7, -1}, {"assembly", 0, -1}, {"disassembly", 0, -1}} };
[[maybe_unused]] constexpr std::array<void (*)(Workspace&, Channel&), kProcesses> kRun{run_0};
constexpr std::array<void (*)(Workspace&, Channel&), 1> kRecover{recover_0};

}  // namespace

#include "adagen/alone.hpp"
struct ankle_p1_solver : Solver {};
#include "adagen/c_interface.hpp"

// ---- 6. program ---------------------------------------------------------------------------------

#ifndef ADAGEN_NO_MAIN
#include "adagen/measured_alone.hpp"
#include "adagen/tell.hpp"

namespace {

// Loop joints, each between a frame on its first link and a frame on its second one, with axis z;
// then couplings of joint coordinates.
constexpr Number kLoop_0[]{1.0, 0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 1.0, 0.0, 0.0, -0.15,
    0.0, 1.0, 0.0, 0.0, 0.0, 1.0, 1.0, 0.0, 0.0, 0.05, 0.0, -0.06};
constexpr Number kLoop_1[]{1.0, 0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 1.0, 0.0, 0.0, -0.23,
    0.0, 1.0, 0.0, 0.0, 0.0, 1.0, 1.0, 0.0, 0.0, -0.05, 0.0, -0.06};
constexpr std::array<adagen::Loop<Number>, 2> kLoops{ {
    {kLoopNames[0], 6, 4, kLoop_0, kLoop_0 + 9, kLoop_0 + 12, kLoop_0 + 21, 7u, 0u, false},
    {kLoopNames[1], 8, 4, kLoop_1, kLoop_1 + 9, kLoop_1 + 12, kLoop_1 + 21, 7u, 0u, false},
} };

adagen::Description<Number> description() {
  static const std::array<adagen::Table<adagen::Stage>, kProcesses> stages{ {table<kStages_0>()} };
  auto about = plain_description(stages.data());
  about.loops = {kLoops.data(), kLoopCount};
  return about;
}

}  // namespace

#include "adagen/entry.hpp"
#endif  // ADAGEN_NO_MAIN
