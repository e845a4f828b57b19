// Forward dynamics of "ankle" on 1 process, emitted by adagen 0.1.0 (solver.cpp.j2). Do not edit: generate again.
// robot     "ankle", 8 joints, 12 degrees of freedom, description sha256 ddb900f3e284309ae668afcdcf39b2b2f8b0b30c7e4b7984814bb0e23c113d8c
// command   adagen ../models/ankle.urdf --scene=../models/ankle.toml --procs 1
// input     scene, sha256 11c8028c5b54b9020d35bd5ac03db5bc865ea05a389c3bc7c7df6b476153c181
// input     profile default, sha256 8872469473a16616fb35eb0cbe19e7438b62853be4a16ebc93dcd28eb93898a1
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
// Process 0 in a singular pose: 1147 products, 818 sums, 19 quotients, 400 of them in lanes
// =================================================================================================

ADAGEN_NOINLINE ADAGEN_AS_IT_STANDS void part_1_0(Workspace& w) {
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
  const Real x75 = v[3] * x70;
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
  const Two x144 = Two{v[7], v[11]};
  const Two x143 = Two{v[6], v[10]};
  const Two x150 = x132 * x132 + x133 * x133 + x134 * x134;
  const Two x151 = x135 * x135 + x150;
  require_length(w, x151, {5, 7});
  const Two x153 = 2.0 * (1 / x151);
  const Two x155 = x133 * x153;
  const Two x156 = x134 * x153;
  const Two x154 = x132 * x153;
  const Two x157 = x133 * x155;
  const Two x158 = x134 * x156;
  const Two x164 = x134 * x154;
  const Two x165 = x135 * x155;
  const Two x161 = x133 * x154;
  const Two x162 = x135 * x156;
  const Two x168 = x132 * x154;
  const Two x171 = x134 * x155;
  const Two x172 = x135 * x154;
  const Two x174 = x164 - x165;
  const Two x166 = x164 + x165;
  const Two x167 = x161 + x162;
  const Two x163 = x161 - x162;
  const Two x175 = x171 + x172;
  const Two x173 = x171 - x172;
  const Two x160 = 1.0 - (x157 + x158);
  const Two x170 = 1.0 - (x158 + x168);
  const Two x177 = 1.0 - (x157 + x168);
  // directions in which a loop holds its two links
  const Two x443 = x85 + v[2] * v[2] + x99 * x99;
  const Two x445 = x142 * x142 + x443 + x143 * x143;
  const Two x530 = load<Two>(cosine + 0) * x175 - load<Two>(sine + 0) * x163;
  const Two x456 = load<Two>(cosine + 0) * x174 - load<Two>(sine + 0) * x160;
  const Two x459 = load<Two>(sine + 0) * x174 + load<Two>(cosine + 0) * x160;
  const Two x533 = load<Two>(sine + 0) * x175 + load<Two>(cosine + 0) * x163;
  const Two x582 = load<Two>(cosine + 0) * x177 - load<Two>(sine + 0) * x166;
  const Two x462 = cosine[4] * x456 + sine[4] * x459;
  const Two x466 = cosine[4] * x459 - sine[4] * x456;
  const Two x536 = cosine[4] * x530 + sine[4] * x533;
  const Two x540 = cosine[4] * x533 - sine[4] * x530;
  const Two x585 = load<Two>(sine + 0) * x177 + load<Two>(cosine + 0) * x166;
  const Two x469 = cosine[5] * x167 + sine[5] * x462;
  const Two x473 = cosine[5] * x462 - sine[5] * x167;
  const Two x543 = cosine[5] * x170 + sine[5] * x536;
  const Two x547 = cosine[5] * x536 - sine[5] * x170;
  const Two x588 = cosine[4] * x582 + sine[4] * x585;
  const Two x592 = cosine[4] * x585 - sine[4] * x582;
  const Two x502 = 0.06 * x473;
  const Two x509 = Two{0.05, -0.05} * x473;
  const Two x554 = 0.06 * x547;
  const Two x561 = Two{0.05, -0.05} * x547;
  const Two x507 = 0.06 * x469 + Two{0.05, -0.05} * x466;
  const Two x559 = 0.06 * x543 + Two{0.05, -0.05} * x540;
  const Two x595 = cosine[5] * x173 + sine[5] * x588;
  const Two x599 = cosine[5] * x588 - sine[5] * x173;
  const Two x606 = 0.06 * x599;
  const Two x613 = Two{0.05, -0.05} * x599;
  const Two x611 = 0.06 * x595 + Two{0.05, -0.05} * x592;
  // joints 5 "left_ball", 7 "right_ball": inertia and bias force of what is beyond, their motion left open
  const Two x761 = x167 * Two{0.15, 0.23} + x175 * 0.06;
  const Two x728 = x170 * Two{0.15, 0.23} - x174 * 0.06;
  const Two x790 = x177 * 0.06;
  // joint 3 "ankle_roll": inertia and bias force of what is beyond, its own motion left open
  const Real x1425 = cosine[5] * x502[0] + sine[5] * x507[0];
  const Real x1455 = cosine[5] * x554[0] + sine[5] * x559[0];
  // link 2 "shank": accelerations and constraint forces of loops below it are eliminated
  const Real x1847 = x728[0] * 8.0;
  const Real x1851 = x761[0] * 8.0;
  const Real x1860 = x728[1] * 4.0;
  const Real x1856 = x790[0] * 16.0;
  const Real x1846 = x509[0] * 8.0;
  const Real x1850 = x561[0] * 8.0;
  const Real x1859 = x509[1] * 4.0;
  const Real x1877 = x1847 * x1847 + 1.44 + x1846 * x1846;
  // joint 1 "knee": placement, velocity and reference acceleration of its link
  const Real x32 = cosine[3] * x28 - x14 * sine[3];
  const Real x37 = sine[3] * x28 + x14 * cosine[3];
  // joint 2 "ankle_pitch": placement, velocity and reference acceleration of its link
  const Real x51 = x32 + 0.4 * x41;
  const Real x55 = cosine[4] * x51 - x37 * sine[4];
  const Real x60 = sine[4] * x51 + x37 * cosine[4];
  // joint 3 "ankle_roll": placement, velocity and reference acceleration of its link
  const Real x82 = x70 * x70;
  const Real x83 = x71 * x71;
  const Real x94 = x82 + x83;
  const Real x88 = x70 * x71;
  const Real x77 = x55 * sine[5];
  const Real x78 = x55 * cosine[5];
  // joints 4 "left_motor", 6 "right_motor": placement, velocity and reference acceleration of their links
  const Two x111 = x32 + x41 * Two{0.25, 0.17};
  const Two x120 = load<Two>(sine + 0) * x111 + load<Two>(cosine + 0) * x37;
  const Two x115 = load<Two>(cosine + 0) * x111 - load<Two>(sine + 0) * x37;
  // joints 5 "left_ball", 7 "right_ball": placement, velocity and reference acceleration of their links
  const Two x179 = x107 * x167;
  const Two x181 = x107 * x173;
  const Two x182 = x142 + x179;
  const Two x184 = x144 + x181;
  const Two x180 = x107 * x170;
  const Two x228 = x182 * x184;
  const Two x192 = x142 * x181 - x144 * x179;
  const Two x200 = x122 * 0.06 - x120;
  const Two x183 = x143 + x180;
  const Two x230 = x192 + x228;
  const Two x223 = x183 * x184;
  const Two x188 = x144 * x180 - x143 * x181;
  // directions in which a loop holds its two links
  const Two x496 = 2.0 * x75 * Two{0.05, -0.05} + x94 * 0.06 - x60;
  const Two x488 = x77 - (x83 + x85) * Two{0.05, -0.05};
  const Two x491 = x78 - x88 * Two{0.05, -0.05};
  // joint 3 "ankle_roll": inertia and bias force of what is beyond, its own motion left open
  const Real x1440 = cosine[5] * x502[1] + sine[5] * x507[1];
  const Real x1485 = cosine[5] * x606[0] + sine[5] * x611[0];
  const Real x1470 = cosine[5] * x554[1] + sine[5] * x559[1];
  const Real x1500 = cosine[5] * x606[1] + sine[5] * x611[1];
  // link 2 "shank": accelerations and constraint forces of loops below it are eliminated
  const Real x1845 = x1425 * 8.0;
  const Real x1849 = x1455 * 8.0;
  const Real x1855 = x613[0] * 16.0;
  const Real x1858 = x1440 * 4.0;
  const Real x2101 = x1860 * x1860 + 0.8464;
  const Real x1863 = x561[1] * 4.0;
  const Real x1864 = x761[1] * 4.0;
  const Real x1854 = x1485 * 16.0;
  const Real x1868 = x613[1] * 16.0;
  const Real x1869 = x790[1] * 16.0;
  const Real x1862 = x1470 * 4.0;
  const Real x1867 = x1500 * 16.0;
  const Real x1880 = sign_of(x1845) * sqrt_of(x1845 * x1845 + x1877);
  const Real x1881 = x1845 + x1880;
  // joints 5 "left_ball", 7 "right_ball": placement, velocity and reference acceleration of their links
  const Two x203 = x115 * x174 + x160 * x200;
  const Two x224 = x223 - x188;
  const Two x206 = x115 * x175 + x163 * x200;
  const Two x226 = x182 * x182 + x183 * x183;
  const Two x209 = x115 * x177 + x166 * x200;
  // directions in which a loop holds its two links
  const Two x501 = x469 * x488 + x466 * x496 + x473 * x491;
  const Two x510 = x501 - (x203 - x230 * Two{0.15, 0.23});
  const Two x553 = x488 * x543 + x496 * x540 + x491 * x547;
  const Two x562 = x553 - (x206 - x224 * Two{0.15, 0.23});
  const Two x605 = x488 * x595 + x496 * x592 + x491 * x599;
  const Two x614 = x605 - (x209 + x226 * Two{0.15, 0.23});
  // joints 5 "left_ball", 7 "right_ball": inertia and bias force of what is beyond, their motion left open
  const Two x879 = x174 * 0.15;
  const Two x880 = x175 * 0.15;
  const Two x881 = x177 * 0.15;
  const Two x653 = x167 * Two{0.00112635, 0.00264635};
  const Two x656 = x170 * Two{0.01125, 0.01725};
  const Two x682 = x167 * Two{0.01125, 0.01725};
  const Two x710 = x173 * 2.7e-06;
  const Two x677 = x170 * Two{0.00112635, 0.00264635};
  // link 2 "shank": accelerations and constraint forces of loops below it are eliminated
  const Real x1883 = x1877 + x1881 * x1881;
  const Real x1885 = 2.0 * (1 / x1883);
  const Real x2218 = x510[0] * 8.0 * (1 / x1880);
  const Real x1891 = x1846 * x1850 - x1847 * x1851 + x1849 * x1881;
  const Real x1892 = x1885 * x1891;
  const Real x1907 = x1846 * x1855 - x1847 * x1856 + x1854 * x1881;
  const Real x1908 = x1885 * x1907;
  const Real x1921 = x1885 * (x1858 * x1881 + x1846 * x1859);
  const Real x1933 = x1885 * (x1862 * x1881 + x1846 * x1863);
  const Real x1945 = x1885 * (x1867 * x1881 + x1846 * x1868);
  const Real x1896 = 1.2 * x1892;
  const Real x1912 = 1.2 * x1908;
  const Real x1924 = x1847 * x1921;
  const Real x1925 = 1.2 * x1921;
  const Real x1898 = x1850 - x1846 * x1892;
  const Real x1899 = x1851 + x1847 * x1892;
  const Real x1915 = x1856 + x1847 * x1908;
  const Real x1914 = x1855 - x1846 * x1908;
  const Real x1927 = x1859 - x1846 * x1921;
  const Real x1936 = x1847 * x1933;
  const Real x1937 = 1.2 * x1933;
  const Real x1961 = 1.44 + x1896 * x1896;
  const Real x1957 = x1899 * x1899;
  const Real x1939 = x1863 - x1846 * x1933;
  // joints 5 "left_ball", 7 "right_ball": inertia and bias force of what is beyond, their motion left open
  const Two x892 = x174 * x879 + x175 * x880 + x177 * x881;
  const Two x840 = x175 * x682 - x174 * x656;
  const Two x654 = x175 * Two{0.01125, 0.01725};
  const Two x678 = x174 * Two{0.01125, 0.01725};
  const Two x923 = x840 + 0.06 * x892;
  const Real x713 = x710[0];
  const Two x878 = x167 * x653 + x173 * x710 + x170 * x677;
  const Two x662 = x653 + 0.06 * x654;
  const Two x689 = x677 - 0.06 * x678;
  const Two x655 = x163 * Two{0.01125, 0.01725};
  const Two x998 = 0.006 + x923;
  const Real x671 = x662[1];
  const Real x665 = x662[0];
  const Real x701 = x689[1];
  const Real x692 = x689[0];
  const Two x897 = x160 * x879 + x163 * x880 + x166 * x881;
  const Two x680 = x160 * Two{0.01125, 0.01725};
  const Two x997 = x878 + 0.06 * x840 + 0.06 * x923 + 0.0002466667;
  const Two x929 = x163 * x682 - x160 * x656 + 0.06 * x897;
  // joints 4 "left_motor", 6 "right_motor": inertia and bias force of what is beyond, their motion left open
  const Real x1012 = x997[1];
  const Real x1011 = x997[0];
  const Two x1063 = load<Two>(sine + 0) * x654 + load<Two>(cosine + 0) * x655;
  // joint 3 "ankle_roll": inertia and bias force of what is beyond, its own motion left open
  const Real x1417 = sine[5] * 0.002;
  const Real x1538 = 0.00630833 + cosine[5] * (cosine[5] * 0.0019583400000000003) + 2.4e-05;
  // link 2 "shank": accelerations and constraint forces of loops below it are eliminated
  const Real x1948 = x1847 * x1945;
  const Real x1949 = 1.2 * x1945;
  const Real x1951 = x1868 - x1846 * x1945;
  const Real x1965 = sign_of(x1898) * sqrt_of(x1898 * x1898 + x1961 + x1957);
  const Real x1966 = x1898 + x1965;
  const Real x1969 = x1957 + x1961 + x1966 * x1966;
  // joint 3 "ankle_roll": placement, velocity and reference acceleration of its link
  const Real x73 = v[3] * x71;
  const Real x90 = x82 + x85;
  // links 6 "left_rod", 8 "right_rod": force that the reference field takes
  const Two x385 = x203 * 0.15 - x230 * Two{0.01125, 0.01725};
  const Two x389 = x206 * 0.15 - x224 * Two{0.01125, 0.01725};
  const Two x374 = (x143 * x179 - x142 * x180) * 2.7e-06;
  const Two x378 = x188 * Two{0.00112635, 0.00264635} - x223 * Two{0.00112365, 0.00264365} + x206 * Two{0.01125, 0.01725};
  const Two x393 = x209 * 0.15 + x226 * Two{0.01125, 0.01725};
  const Two x381 = x192 * Two{0.00112635, 0.00264635} + x228 * Two{0.00112365, 0.00264365} - x203 * Two{0.01125, 0.01725};
  // joints 5 "left_ball", 7 "right_ball": inertia and bias force of what is beyond, their motion left open
  const Two x977 = x174 * x385 + x175 * x389 + x177 * x393;
  // joints 4 "left_motor", 6 "right_motor": inertia and bias force of what is beyond, their motion left open
  const Two x1101 = load<Two>(sine + 0) * x678 + load<Two>(cosine + 0) * x680;
  const Two x1074 = x662 - Two{0.25, 0.17} * x1063;
  const Two x1026 = load<Two>(sine + 0) * x998 + load<Two>(cosine + 0) * x929;
  const Real x1082 = x1074[1];
  const Two x1037 = x997 - Two{0.25, 0.17} * x1026;
  const Two x1113 = x689 + Two{0.25, 0.17} * x1101;
  const Real x1046 = x1037[1];
  const Real x1122 = x1113[1];
  const Real x1077 = x1074[0];
  // joint 3 "ankle_roll": inertia and bias force of what is beyond, its own motion left open
  const Real x1420 = cosine[5] * 0.05;
  const Real x1421 = sine[5] * 0.05;
  // joint 2 "ankle_pitch": inertia and bias force of what is beyond, its own motion left open
  const Real x1561 = sine[4] * 0.04 + cosine[4] * x1420;
  const Real x1574 = sine[4] * x1421;
  // link 2 "shank": accelerations and constraint forces of loops below it are eliminated
  const Real x2224 = x562[0] * 8.0 + (x1849 - x1881 * x1892) * x2218;
  const Real x2226 = 1 / x1965 * x2224;
  const Real x1971 = 2.0 * (1 / x1969);
  const Real x1978 = x1899 * x1915 + x1896 * x1912 + x1914 * x1966;
  const Real x1979 = x1971 * x1978;
  const Real x1996 = x1899 * x1924 + x1896 * x1925 + x1927 * x1966;
  const Real x1997 = x1971 * x1996;
  const Real x2014 = x1899 * x1936 + x1896 * x1937 + x1939 * x1966;
  const Real x2015 = x1971 * x2014;
  const Real x2032 = x1899 * x1948 + x1896 * x1949 + x1951 * x1966;
  const Real x2033 = x1971 * x2032;
  const Real x1983 = 1.2 * x1979;
  const Real x2001 = 1.2 * x1997;
  const Real x2019 = 1.2 * x2015;
  const Real x1988 = x1899 * x1979 - x1915;
  const Real x2047 = x1983 * x1983;
  const Real x1989 = x1896 * x1979 - x1912;
  const Real x2007 = x1896 * x1997 - x1925;
  const Real x2006 = x1899 * x1997 - x1924;
  const Real x2025 = x1896 * x2015 - x1937;
  const Real x2024 = x1899 * x2015 - x1936;
  const Real x2048 = x1989 * x1989;
  const Real x2037 = 1.2 * x2033;
  const Real x2043 = x1896 * x2033 - x1949;
  const Real x2042 = x1899 * x2033 - x1948;
  // link 4 "foot": force that the reference field takes
  const Real x292 = x73 * 0.002999997 - x73 * 0.00826667;
  const Real x302 = x75 * 0.004958337 - x75 * 0.00630833 + x88 * 0.002;
  const Real x312 = 0.002 * (x94 - x90) + x292 + x60 * 0.05;
  // joints 5 "left_ball", 7 "right_ball": inertia and bias force of what is beyond, their motion left open
  const Real x716 = x710[1];
  const Two x972 = x167 * x378 + x173 * x374 + x170 * x381;
  const Two x640 = x378 - Two{tau[5], tau[9]};
  const Two x648 = x374 - Two{tau[7], tau[11]};
  const Two x1002 = x972 + 0.06 * x977 + x115 * 0.006;
  const Real x642 = x640[1];
  const Real x649 = x648[0];
  const Two x645 = x381 - Two{tau[6], tau[10]};
  const Real x647 = x645[1];
  const Real x641 = x640[0];
  const Two x906 = x163 * (x163 * 0.15) + x166 * (x166 * 0.15);
  // joints 4 "left_motor", 6 "right_motor": inertia and bias force of what is beyond, their motion left open
  const Two x1023 = load<Two>(cosine + 0) * x998 - load<Two>(sine + 0) * x929;
  const Real x1048 = x1026[1];
  const Two x1060 = load<Two>(cosine + 0) * x654 - load<Two>(sine + 0) * x655;
  const Real x1084 = x1063[1];
  const Real x1047 = x1023[1];
  const Real x1083 = x1060[1];
  const Two x1096 = load<Two>(sine + 0) * x680 - load<Two>(cosine + 0) * x678;
  const Real x1124 = x1101[1];
  const Real x1040 = x1037[0];
  const Real x1079 = x1063[0];
  const Real x1123 = x1096[1];
  const Two x1008 = x1002 - Two{tau[4], tau[8]};
  const Real x1116 = x1113[0];
  const Real x1078 = x1060[0];
  const Real x1010 = x1008[1];
  const Real x1042 = x1026[0];
  const Real x1041 = x1023[0];
  // joint 3 "ankle_roll": inertia and bias force of what is beyond, its own motion left open
  const Real x1522 = cosine[5] * (x312 - x78 * 0.04);
  const Real x1525 = x1522 - sine[5] * (x302 + x77 * 0.04);
  // joint 2 "ankle_pitch": inertia and bias force of what is beyond, its own motion left open
  const Real x1565 = x1538 + 0.4 * x1561;
  const Real x1580 = x1417 + 0.4 * x1574;
  const Real x1556 = sine[4] * x1420 - cosine[4] * 0.04;
  const Real x1573 = cosine[4] * x1421;
  // link 2 "shank": accelerations and constraint forces of loops below it are eliminated
  const Real x2234 = x614[0] * 16.0 + (x1854 - x1881 * x1908) * x2218;
  const Real x2248 = x510[1] * 4.0 + (x1858 - x1881 * x1921) * x2218;
  const Real x2266 = x562[1] * 4.0 + (x1862 - x1881 * x1933) * x2218;
  const Real x2288 = x614[1] * 16.0 + (x1867 - x1881 * x1945) * x2218;
  const Real x2052 = sign_of(x1988) * sqrt_of(x1988 * x1988 + x2047 + x2048);
  const Real x2053 = x1988 + x2052;
  const Real x2056 = x2047 + x2048 + x2053 * x2053;
  // joints 5 "left_ball", 7 "right_ball": inertia and bias force of what is beyond, their motion left open
  const Two x999 = 0.2 + x892;
  const Two x1000 = x160 * (x160 * 0.15) + x906 + 0.2;
  const Real x646 = x645[0];
  const Two x1003 = x115 * 0.2 + x977;
  const Two x982 = x160 * x385 + x163 * x389 + x166 * x393;
  const Two x1004 = x122 * 0.006 - x120 * 0.2 + x982;
  // joints 4 "left_motor", 6 "right_motor": inertia and bias force of what is beyond, their motion left open
  const Real x1118 = x1101[0];
  const Real x1117 = x1096[0];
  const Real x1009 = x1008[0];
  const Two x1292 = load<Two>(cosine + 0) * (x999 - x1000) - x897 * (load<Two>(sine + 0) * 2.0);
  const Two x1296 = load<Two>(cosine + 0) * x1292;
  const Two x1298 = x999 - x1296;
  const Two x1295 = x897 + load<Two>(sine + 0) * x1292;
  const Two x1376 = load<Two>(sine + 0) * x1003 + load<Two>(cosine + 0) * x1004;
  const Two x1319 = x1026 - Two{0.25, 0.17} * x1298;
  const Two x1309 = x1023 - Two{0.25, 0.17} * x1295;
  const Two x1297 = x1000 + x1296;
  // joint 3 "ankle_roll": inertia and bias force of what is beyond, its own motion left open
  const Real x1416 = x88 * 0.0019583400000000003 + x77 * 0.05 - tau[3];
  const Real x1533 = sine[5] * (x77 + x88 * 0.05);
  // joint 2 "ankle_pitch": inertia and bias force of what is beyond, its own motion left open
  const Real x1543 = x1525 - tau[2];
  const Real x1753 = -0.46 - x1561;
  // link 2 "shank": accelerations and constraint forces of loops below it are eliminated
  const Real x2238 = 1 / x2052 * ((x1914 - x1966 * x1979) * x2226 + x2234);
  const Real x2058 = 2.0 * (1 / x2056);
  const Real x2063 = x1983 * x2001 + x1989 * x2007 + x2006 * x2053;
  const Real x2064 = x2058 * x2063;
  const Real x2075 = x1983 * x2019 + x1989 * x2025 + x2024 * x2053;
  const Real x2076 = x2058 * x2075;
  const Real x2087 = x1983 * x2037 + x1989 * x2043 + x2042 * x2053;
  const Real x2088 = x2058 * x2087;
  const Real x2069 = x2001 - x1983 * x2064;
  const Real x2070 = x2007 - x1989 * x2064;
  const Real x2082 = x2025 - x1989 * x2076;
  const Real x2081 = x2019 - x1983 * x2076;
  const Real x2094 = x2043 - x1989 * x2088;
  const Real x2093 = x2037 - x1983 * x2088;
  const Real x2098 = x2070 * x2070;
  // directions in which a loop holds its two links
  const Two x399 = sine[5] * Two{0.05, -0.05};
  const Two x410 = x177 * Two{0.15, 0.23};
  const Two x416 = -0.06 - x166 * Two{0.15, 0.23};
  const Two x407 = sine[4] * x399 - cosine[4] * 0.06;
  const Two x430 = x407 - (load<Two>(cosine + 0) * x416 - load<Two>(sine + 0) * x410);
  const Two x431 = cosine[5] * Two{0.05, -0.05} - (Two{0.05, -0.05} - x173 * Two{0.15, 0.23});
  const Two x408 = cosine[4] * x399 + sine[4] * 0.06 + -0.4;
  const Two x429 = x408 - (Two{-0.25, -0.17} - (load<Two>(cosine + 0) * x410 + load<Two>(sine + 0) * x416));
  // joints 4 "left_motor", 6 "right_motor": inertia and bias force of what is beyond, their motion left open
  const Two x1387 = x1002 - Two{0.25, 0.17} * x1376;
  const Two x1373 = load<Two>(cosine + 0) * x1003 - load<Two>(sine + 0) * x1004;
  const Two x1362 = x1037 - Two{0.25, 0.17} * x1319;
  // joint 3 "ankle_roll": inertia and bias force of what is beyond, its own motion left open
  const Real x1535 = x1533 + cosine[5] * (x78 + x90 * 0.05);
  const Real x1540 = x55 * 0.15 + x1535;
  // link 4 "foot": force that the reference field takes
  const Real x330 = 2.0 * x73 * 0.05 - x94 * 0.04 - x60;
  // joint 3 "ankle_roll": inertia and bias force of what is beyond, its own motion left open
  const Real x1541 = x330 - x60 * 0.15;
  // joint 2 "ankle_pitch": inertia and bias force of what is beyond, its own motion left open
  const Real x1782 = sine[4] * x1540 + cosine[4] * x1541;
  // link 2 "shank": accelerations and constraint forces of loops below it are eliminated
  const Real x2250 = (x1927 - x1966 * x1997) * x2226 + x2248;
  const Real x2268 = (x1939 - x1966 * x2015) * x2226 + x2266;
  const Real x2290 = (x1951 - x1966 * x2033) * x2226 + x2288;
  const Real x2105 = sign_of(x2069) * sqrt_of(x2069 * x2069 + x2101 + x2098);
  const Real x2106 = x2069 + x2105;
  const Two x1816 = x99 * x728 + x143 * Two{0.15, 0.23} + v[3] * x509;
  const Two x1817 = v[2] * Two{x1425, x1440} + x1816;
  const Two x1827 = v[3] * x561 - (x99 * x761 + x142 * Two{0.15, 0.23});
  const Two x1828 = v[2] * Two{x1455, x1470} + x1827;
  const Real x2192 = x1880 * x1880;
  require_more(w, x2192, 9.999999999999998e-15, kLoopSingular, 8);
  const Real x2194 = x1965 * x1965;
  require_more(w, x2194, 9.999999999999998e-15, kLoopSingular, 8);
  const Two x1835 = v[3] * x613 - x99 * x790 + v[2] * Two{x1485, x1500};
  const Real x2196 = x2052 * x2052;
  require_more(w, x2196, 9.999999999999998e-15, kLoopSingular, 8);
  const Real x2198 = x2105 * x2105;
  require_more(w, x2198, 9.999999999999998e-15, kLoopSingular, 9);
  const Real x2109 = x2098 + x2101 + x2106 * x2106;
  // directions in which a loop holds its two links
  const Two x436 = x430 * x430 + x431 * x431 + x429 * x429;
  const Two x448 = 1e-08 - x436;
  require_more(w, x448, 0.0, kLoopOpen, {8, 9});
  // link 2 "shank": accelerations and constraint forces of loops below it are eliminated
  const Real x2254 = 1 / x2105 * ((x2006 - x2053 * x2064) * x2238 + x2250);
  const Two x1840 = x1817 * x1817 + x1828 * x1828 + x1835 * x1835;
  const Two x1841 = (x144 * x144 + x445 + 1.0) * 1.0000000000000002e-06 - x1840;
  require_more(w, x1841, 0.0, kLoopTorn, {8, 9});
  const Real x2111 = 2.0 * (1 / x2109);
  const Real x2117 = x2070 * x2082 - x1860 * x1864 + x2081 * x2106;
  const Real x2118 = x2111 * x2117;
  const Real x2133 = x2070 * x2094 - x1860 * x1869 + x2093 * x2106;
  const Real x2134 = x2111 * x2133;
  const Real x2122 = 0.92 * x2118;
  const Real x2138 = 0.92 * x2134;
  const Real x2124 = x2082 - x2070 * x2118;
  const Real x2125 = x1864 + x1860 * x2118;
  const Real x2141 = x1869 + x1860 * x2134;
  const Real x2140 = x2094 - x2070 * x2134;
  const Real x2151 = 0.8464 + x2122 * x2122;
  const Real x2147 = x2125 * x2125;
  const Real x2270 = (x2024 - x2053 * x2076) * x2238 + x2268;
  const Real x2292 = (x2042 - x2053 * x2088) * x2238 + x2290;
  const Real x2155 = sign_of(x2124) * sqrt_of(x2124 * x2124 + x2151 + x2147);
  const Real x2156 = x2124 + x2155;
  const Real x2200 = x2155 * x2155;
  require_more(w, x2200, 9.999999999999998e-15, kLoopSingular, 9);
  const Real x2159 = x2147 + x2151 + x2156 * x2156;
  const Real x2274 = 1 / x2155 * ((x2081 - x2106 * x2118) * x2254 + x2270);
  const Real x2161 = 2.0 * (1 / x2159);
  const Real x2168 = x2125 * x2141 + x2122 * x2138 + x2140 * x2156;
  const Real x2169 = x2161 * x2168;
  const Real x2173 = 0.92 * x2169;
  const Real x2178 = x2125 * x2169 - x2141;
  const Real x2179 = x2122 * x2169 - x2138;
  const Real x2294 = (x2093 - x2106 * x2134) * x2254 + x2292;
  const Real x2185 = x2178 * x2178 + x2173 * x2173 + x2179 * x2179;
  const Real x2186 = sqrt_of(x2185);
  const Real x2187 = x2186 * x2186;
  require_more(w, x2187, 9.999999999999998e-15, kLoopSingular, 9);
  const Real x2188 = x2185 + x2187;
  const Real x2298 = 1 / x2186 * ((x2140 - x2156 * x2169) * x2274 + x2294);
  const Real x2190 = 2.0 * (1 / x2188);
  const Real x2300 = x2178 * x2190;
  const Real x2309 = x2173 * x2190;
  const Real x2318 = x2179 * x2190;
  const Real x2328 = x2190 * (x2186 * x2298);
  const Real x2303 = x2173 * x2300;
  const Real x2304 = x2179 * x2300;
  const Real x2311 = x2178 * x2309;
  const Real x2313 = x2179 * x2309;
  const Real x2320 = x2178 * x2318;
  const Real x2321 = x2173 * x2318;
  const Real x2330 = x2178 * x2328;
  const Real x2331 = x2173 * x2328;
  const Real x2306 = 1.0 - x2178 * x2300;
  const Real x2316 = 1.0 - x2173 * x2309;
  const Real x2326 = 1.0 - x2179 * x2318;
  const Real x2332 = x2179 * x2328;
  const Real x2301 = x2186 * x2300;
  const Real x2310 = x2186 * x2309;
  const Real x2319 = x2186 * x2318;
  const Real x2725 = x713 * x2301;
  const Real x2733 = x713 * x2310;
  const Real x2741 = x713 * x2319;
  const Real x2344 = 0.92 * x2303 + x2122 * x2304 - x2125 * x2306;
  const Real x2345 = x2161 * x2344;
  const Real x2333 = x2298 - x2186 * x2328;
  const Real x2364 = x2125 * x2311 + x2122 * x2313 - 0.92 * x2316;
  const Real x2365 = x2161 * x2364;
  const Real x2384 = x2125 * x2320 + 0.92 * x2321 - x2122 * x2326;
  const Real x2385 = x2161 * x2384;
  const Real x2405 = x2156 * x2274 + x2125 * x2330 + 0.92 * x2331;
  const Real x2346 = x2156 * x2345;
  const Real x2366 = x2156 * x2365;
  const Real x2386 = x2156 * x2385;
  const Real x2407 = x2161 * (x2122 * x2332 + x2405);
  const Real x2354 = x2306 + x2125 * x2345;
  const Real x2356 = x2122 * x2345 - x2304;
  const Real x2374 = x2125 * x2365 - x2311;
  const Real x2376 = x2122 * x2365 - x2313;
  const Real x2394 = x2125 * x2385 - x2320;
  const Real x2396 = x2326 + x2122 * x2385;
  const Real x2355 = 0.92 * x2345 - x2303;
  const Real x2415 = x2274 - x2156 * x2407;
  const Real x2375 = x2316 + 0.92 * x2365;
  const Real x2416 = x2125 * x2407 - x2330;
  const Real x2418 = x2122 * x2407 - x2332;
  const Real x2395 = 0.92 * x2385 - x2321;
  const Real x2424 = x1860 * x2354 - x2070 * x2346 + 0.92 * x2356;
  const Real x2425 = x2111 * x2424;
  const Real x2440 = x1860 * x2374 - x2070 * x2366 + 0.92 * x2376;
  const Real x2441 = x2111 * x2440;
  const Real x2417 = 0.92 * x2407 - x2331;
  const Real x2456 = x1860 * x2394 - x2070 * x2386 + 0.92 * x2396;
  const Real x2457 = x2111 * x2456;
  const Real x2426 = x2106 * x2425;
  const Real x2442 = x2106 * x2441;
  const Real x2458 = x2106 * x2457;
  const Real x2431 = x2346 + x2070 * x2425;
  const Real x2433 = x2354 - x1860 * x2425;
  const Real x2447 = x2366 + x2070 * x2441;
  const Real x2434 = x2356 - 0.92 * x2425;
  const Real x2463 = x2386 + x2070 * x2457;
  const Real x2449 = x2374 - x1860 * x2441;
  const Real x2450 = x2376 - 0.92 * x2441;
  const Real x2793 = x671 * x2433 + 0.00264635 * x2355;
  const Real x2802 = x701 * x2433 + 0.00264635 * x2434;
  const Real x2796 = x671 * x2449 + 0.00264635 * x2375;
  const Real x2489 = x2058 * (x1983 * x2426 + x1989 * x2431);
  const Real x2472 = x2106 * x2254 + x2070 * x2415 + x1860 * x2416;
  const Real x2780 = x1012 * x2433 + x671 * x2355 + x701 * x2434;
  const Real x2505 = x2058 * (x1983 * x2442 + x1989 * x2447);
  const Real x2805 = x701 * x2449 + 0.00264635 * x2450;
  const Real x2521 = x2058 * (x1983 * x2458 + x1989 * x2463);
  const Real x2465 = x2394 - x1860 * x2457;
  const Real x2785 = x1012 * x2449 + x671 * x2375 + x701 * x2450;
  const Real x2491 = x2053 * x2489;
  const Real x2507 = x2053 * x2505;
  const Real x2523 = x2053 * x2521;
  const Real x2497 = x1983 * x2489 - x2426;
  const Real x2498 = x1989 * x2489 - x2431;
  const Real x2513 = x1983 * x2505 - x2442;
  const Real x2514 = x1989 * x2505 - x2447;
  const Real x2529 = x1983 * x2521 - x2458;
  const Real x2530 = x1989 * x2521 - x2463;
  const Real x2466 = x2396 - 0.92 * x2457;
  const Real x2474 = x2111 * (0.92 * x2418 + x2472);
  const Real x2479 = x2254 - x2106 * x2474;
  const Real x2799 = x671 * x2465 + 0.00264635 * x2395;
  const Real x2808 = x701 * x2465 + 0.00264635 * x2466;
  const Real x2551 = x1899 * x2491 + 1.2 * x2497 + x1896 * x2498;
  const Real x2553 = x1971 * x2551;
  const Real x2480 = x2415 - x2070 * x2474;
  const Real x2574 = x1899 * x2507 + 1.2 * x2513 + x1896 * x2514;
  const Real x2576 = x1971 * x2574;
  const Real x2790 = x1012 * x2465 + x671 * x2395 + x701 * x2466;
  const Real x2597 = x1899 * x2523 + 1.2 * x2529 + x1896 * x2530;
  const Real x2599 = x1971 * x2597;
  const Real x2555 = x1966 * x2553;
  const Real x2578 = x1966 * x2576;
  const Real x2601 = x1966 * x2599;
  const Real x2563 = x2491 - x1899 * x2553;
  const Real x2565 = x2498 - x1896 * x2553;
  const Real x2586 = x2507 - x1899 * x2576;
  const Real x2588 = x2514 - x1896 * x2576;
  const Real x2564 = x2497 - 1.2 * x2553;
  const Real x2609 = x2523 - x1899 * x2599;
  const Real x2611 = x2530 - x1896 * x2599;
  const Real x2587 = x2513 - 1.2 * x2576;
  const Real x2610 = x2529 - 1.2 * x2599;
  const Real x2638 = x1846 * x2555 + x1847 * x2563 + 1.2 * x2565;
  const Real x2639 = x1885 * x2638;
  const Real x2535 = x2053 * x2238 + x1983 * x2479 + x1989 * x2480;
  const Real x2536 = x2058 * x2535;
  const Real x2652 = x1846 * x2578 + x1847 * x2586 + 1.2 * x2588;
  const Real x2653 = x1885 * x2652;
  const Real x2666 = x1846 * x2601 + x1847 * x2609 + 1.2 * x2611;
  const Real x2667 = x1885 * x2666;
  const Real x2640 = x1881 * x2639;
  const Real x2654 = x1881 * x2653;
  const Real x2668 = x1881 * x2667;
  const Real x2645 = x2555 - x1846 * x2639;
  const Real x2646 = x2563 - x1847 * x2639;
  const Real x2647 = x2565 - 1.2 * x2639;
  const Real x2659 = x2578 - x1846 * x2653;
  const Real x2660 = x2586 - x1847 * x2653;
  const Real x2661 = x2588 - 1.2 * x2653;
  const Real x2673 = x2601 - x1846 * x2667;
  const Real x2696 = x1538 * x2640 + x1417 * x2645;
  const Real x2713 = x1417 * x2640 + 0.003308333 * x2645;
  const Real x2748 = x665 * x2646 + 0.00112635 * x2564;
  const Real x2757 = x692 * x2646 + 0.00112635 * x2647;
  const Real x2702 = x1538 * x2654 + x1417 * x2659;
  const Real x2767 = x713 * x2646 - 2.7e-06 * x2301;
  const Real x2717 = x1417 * x2654 + 0.003308333 * x2659;
  const Real x2751 = x665 * x2660 + 0.00112635 * x2587;
  const Real x2728 = x665 * x2564 - x2725 + x1011 * x2646;
  const Real x2729 = x692 * x2647 + x2728;
  const Real x2760 = x692 * x2660 + 0.00112635 * x2661;
  const Real x3046 = x2355 * x2793 + x2434 * x2802 + x2433 * x2780;
  const Real x3065 = x2355 * x2796 + x2434 * x2805 + x2433 * x2785;
  const Real x2771 = x713 * x2660 - 2.7e-06 * x2310;
  const Real x3122 = x2375 * x2796 + x2450 * x2805 + x2449 * x2785;
  const Real x2674 = x2609 - x1847 * x2667;
  const Real x2708 = x1538 * x2668 + x1417 * x2673;
  const Real x2736 = x665 * x2587 - x2733 + x1011 * x2660;
  const Real x2737 = x692 * x2661 + x2736;
  const Real x3048 = x2640 * x2696 + x3046 + x2645 * x2713;
  const Real x2675 = x2611 - 1.2 * x2667;
  const Real x3067 = x2640 * x2702 + x3065 + x2645 * x2717;
  const Real x2721 = x1417 * x2668 + 0.003308333 * x2673;
  const Real x3124 = x2654 * x2702 + x3122 + x2659 * x2717;
  const Real x2754 = x665 * x2674 + 0.00112635 * x2610;
  const Real x3084 = x2355 * x2799 + x2434 * x2808 + x2433 * x2790;
  const Real x3050 = x2564 * x2748 + x3048 + x2647 * x2757;
  const Real x2763 = x692 * x2674 + 0.00112635 * x2675;
  const Real x3069 = x2564 * x2751 + x3067 + x2647 * x2760;
  const Real x3141 = x2375 * x2799 + x2450 * x2808 + x2449 * x2790;
  const Real x3052 = x3050 - x2301 * x2767 + x2646 * x2729;
  require_more(w, x3052, 0.0, kLoopFree, 2);
  const Real x2540 = x2238 - x2053 * x2536;
  const Real x3126 = x2587 * x2751 + x3124 + x2661 * x2760;
  const Real x3071 = x3069 - x2301 * x2771 + x2646 * x2737;
  const Real x2775 = x713 * x2674 - 2.7e-06 * x2319;
  const Real x3086 = x2640 * x2708 + x3084 + x2645 * x2721;
  const Real x3520 = 1 / x3052;
  const Real x3128 = x3126 - x2310 * x2771 + x2660 * x2737;
  const Real x2541 = x2479 - x1983 * x2536;
  const Real x2744 = x665 * x2610 - x2741 + x1011 * x2674;
  const Real x2745 = x692 * x2675 + x2744;
  const Real x3143 = x2654 * x2708 + x3141 + x2659 * x2721;
  const Real x3198 = x2395 * x2799 + x2466 * x2808 + x2465 * x2790;
  const Real x2542 = x2480 - x1989 * x2536;
  const Real x3088 = x2564 * x2754 + x3086 + x2647 * x2763;
  const Real x3330 = x1082 * x2355 - x2725 + x1046 * x2433;
  const Real x3090 = x3088 - x2301 * x2775 + x2646 * x2745;
  const Real x3145 = x2587 * x2754 + x3143 + x2661 * x2763;
  const Real x3200 = x2668 * x2708 + x3198 + x2673 * x2721;
  const Real x3521 = x3071 * x3520;
  const Real x2620 = x1966 * x2226 - x1899 * x2540 - 1.2 * x2541;
  const Real x2809 = x716 * x2433;
  const Real x3522 = x3090 * x3520;
  const Real x3348 = x1082 * x2375 - x2733 + x1046 * x2449;
  const Real x2622 = x1971 * (x2620 - x1896 * x2542);
  const Real x3202 = x2610 * x2754 + x3200 + x2675 * x2763;
  const Real x3526 = x3128 - x3071 * x3521;
  const Real x3147 = x3145 - x2310 * x2775 + x2660 * x2745;
  const Real x3529 = x3147 - x3090 * x3521;
  const Real x3332 = x1122 * x2434 + x3330 + x1077 * x2564;
  const Real x3204 = x3202 - x2319 * x2775 + x2674 * x2745;
  const Real x3533 = 1 / x3526;
  const Real x3366 = x1082 * x2395 - x2741 + x1046 * x2465;
  const Real x2630 = x2226 - x1966 * x2622;
  const Real x2631 = x2540 + x1899 * x2622;
  const Real x2633 = x2542 + x1896 * x2622;
  const Real x3532 = x716 * x2449 - x2809 * x3521;
  const Real x2482 = x2418 - 0.92 * x2474;
  const Real x3350 = x1122 * x2450 + x3348 + x1077 * x2587;
  const Real x3523 = x2809 * x3520;
  const Real x3534 = x3529 * x3533;
  const Real x2481 = x2416 - x1860 * x2474;
  const Real x3334 = x3332 - x1565 * x2640 - x1580 * x2645;
  const Real x2681 = x1881 * x2218 + x1846 * x2630 + x1847 * x2631;
  const Real x3368 = x1122 * x2466 + x3366 + x1077 * x2610;
  const Real x3541 = x3204 - x3090 * x3522 - x3529 * x3534;
  const Real x3433 = x1048 * x2433 + x1084 * x2355 - x1124 * x2434;
  const Real x3535 = x3532 * x3533;
  const Real x3547 = x716 * x2465 - x2809 * x3522 - x3532 * x3534;
  const Real x3548 = 1 / x3541;
  const Real x2632 = x2541 + 1.2 * x2622;
  const Real x2683 = x1885 * (1.2 * x2633 + x2681);
  const Real x3336 = x1040 * x2646 + x3334 + x1116 * x2647;
  const Real x3352 = x3350 - x1565 * x2654 - x1580 * x2659;
  const Real x3383 = x1047 * x2433 + x1083 * x2355 + x1123 * x2434;
  const Real x3451 = x1048 * x2449 + x1084 * x2375 - x1124 * x2450;
  const Real x3549 = x3547 * x3548;
  const Real x3354 = x1040 * x2660 + x3352 + x1116 * x2661;
  const Real x3370 = x3368 - x1565 * x2668 - x1580 * x2673;
  const Real x3399 = x1047 * x2449 + x1083 * x2375 + x1123 * x2450;
  const Real x3435 = x1079 * x2564 + x3433 + x1561 * x2640;
  const Real x3469 = x1048 * x2465 + x1084 * x2395 - x1124 * x2466;
  const Real x2688 = x2218 - x1881 * x2683;
  const Real x2824 = x642 * x2355 - x649 * x2301 + x1010 * x2433;
  const Real x2880 = x2417 * x2793 + x2482 * x2802 + x2481 * x2780;
  const Real x3372 = x1040 * x2674 + x3370 + x1116 * x2675;
  const Real x3572 = x3354 - x3336 * x3521;
  const Real x3385 = x1078 * x2564 + x3383 - x1556 * x2640;
  const Real x3415 = x1047 * x2465 + x1083 * x2395 + x1123 * x2466;
  const Real x3453 = x1079 * x2587 + x3451 + x1561 * x2654;
  const Real x3557 = 2.7e-06 - x2809 * x3523 - x3532 * x3535;
  const Real x3558 = x3557 - x3547 * x3549;
  require_more(w, x3558, 4.796163466380676e-21, kLoopFree, 5);
  const Real x2689 = x2630 - x1846 * x2683;
  const Real x2843 = x642 * x2375 - x649 * x2310 + x1010 * x2449;
  const Real x2898 = x2417 * x2796 + x2482 * x2805 + x2481 * x2785;
  const Real x3401 = x1078 * x2587 + x3399 - x1556 * x2654;
  const Real x3437 = x1574 * x2645 + x3435 + x1042 * x2646;
  const Real x3438 = x3437 - x1118 * x2647;
  const Real x3471 = x1079 * x2610 + x3469 + x1561 * x2668;
  const Real x3559 = 1 / x3558;
  const Real x2690 = x2631 - x1847 * x2683;
  const Real x2826 = x647 * x2434 + x2824 + x641 * x2564;
  const Real x2862 = x642 * x2395 - x649 * x2319 + x1010 * x2465;
  const Real x2882 = x2632 * x2748 + x2880 + x2333 * x2767;
  const Real x2916 = x2417 * x2799 + x2482 * x2808 + x2481 * x2790;
  const Real x3602 = x3372 - x3336 * x3522 - x3534 * x3572;
  const Real x3387 = x1573 * x2645 + x3385 + x1041 * x2646;
  const Real x3388 = x1117 * x2647 + x3387;
  const Real x3417 = x1078 * x2610 + x3415 - x1556 * x2668;
  const Real x3455 = x1574 * x2659 + x3453 + x1042 * x2660;
  const Real x3456 = x3455 - x1118 * x2661;
  const Real x2691 = x2633 - 1.2 * x2683;
  const Real x2845 = x647 * x2450 + x2843 + x641 * x2587;
  const Real x2900 = x2632 * x2751 + x2898 + x2333 * x2771;
  const Real x3403 = x1573 * x2659 + x3401 + x1041 * x2660;
  const Real x3404 = x1117 * x2661 + x3403;
  const Real x3473 = x1574 * x2673 + x3471 + x1042 * x2674;
  const Real x3474 = x3473 - x1118 * x2675;
  const Real x3578 = x3456 - x3438 * x3521;
  const Real x2828 = x2826 - x1543 * x2640 + x1416 * x2645;
  const Real x2864 = x647 * x2466 + x2862 + x641 * x2610;
  const Real x2884 = x2882 - x2688 * x2696 + x2689 * x2713;
  const Real x2918 = x2632 * x2754 + x2916 + x2333 * x2775;
  const Real x3652 = x716 - x3336 * x3523 - x3535 * x3572;
  const Real x3419 = x1573 * x2673 + x3417 + x1041 * x2674;
  const Real x3420 = x1117 * x2675 + x3419;
  const Real x3575 = x3404 - x3388 * x3521;
  const Real x2847 = x2845 - x1543 * x2654 + x1416 * x2659;
  const Real x2902 = x2900 - x2688 * x2702 + x2689 * x2717;
  const Real x3716 = x3559 * (x3652 - x3549 * x3602);
  const Real x3614 = x3474 - x3438 * x3522 - x3534 * x3578;
  const Real x2866 = x2864 - x1543 * x2668 + x1416 * x2673;
  const Real x2920 = x2918 - x2688 * x2708 + x2689 * x2721;
  const Real x2830 = x1009 * x2646 + x2828 + x646 * x2647;
  const Real x2924 = x2690 * x2729 + x2884 + x2691 * x2757 + x2830;
  const Real x3608 = x3420 - x3388 * x3522 - x3534 * x3575;
  const Real x2849 = x1009 * x2660 + x2847 + x646 * x2661;
  const Real x3732 = x3548 * x3602 - x3549 * x3716;
  const Real x2868 = x1009 * x2674 + x2866 + x646 * x2675;
  const Real x2925 = x2690 * x2737 + x2902 + x2691 * x2760 + x2849;
  const Real x3584 = x2925 - x2924 * x3521;
  const Real x3672 = x3438 * x3523 + x3535 * x3578 + x3549 * x3614;
  const Real x3719 = x3559 * x3672;
  const Real x2926 = x2690 * x2745 + x2920 + x2691 * x2763 + x2868;
  const Real x3762 = x3533 * x3572 - x3535 * x3716 - x3534 * x3732;
  const Real x3662 = x3388 * x3523 + x3535 * x3575 + x3549 * x3608;
  const Real x3717 = x3559 * x3662;
  const Real x3626 = x2926 - x2924 * x3522 - x3534 * x3584;
  const Real x3690 = x648[1] + x716 * x2481 - x2924 * x3523;
  const Real x3738 = x3548 * x3614 + x3549 * x3719;
  const Real x3812 = x3336 * x3520 - x3523 * x3716 - x3522 * x3732;
  const Real x3813 = x3812 - x3521 * x3762;
  const Real x3735 = x3548 * x3608 + x3549 * x3717;
  const Real x3774 = x3533 * x3578 + x3535 * x3719 - x3534 * x3738;
  const Real x3723 = x3559 * (x3690 - x3535 * x3584 - x3549 * x3626);
  const Real x3974 = x3372 * x3732 + x716 * x3716 + x3354 * x3762;
  const Real x3768 = x3533 * x3575 + x3535 * x3717 - x3534 * x3735;
  // joint 2 "ankle_pitch": inertia and bias force of what is beyond, its own motion left open
  const Real x1798 = x1565 - 0.4 * x1753 + across<2>(x1362);
  // link 2 "shank": accelerations and constraint forces of loops below it are eliminated
  const Real x3830 = x3438 * x3520 + x3523 * x3719 - x3522 * x3738;
  const Real x3831 = x3830 - x3521 * x3774;
  const Real x2973 = x713 * x2333 + x1082 * x2417 + x1046 * x2481;
  const Real x3744 = x3548 * x3626 - x3549 * x3723;
  const Real x4112 = x1798 - (x3336 * x3813 + x3974) + 0.18885420000000003;
  require_more(w, x4112, 0.0, kFactorization, 1);
  const Real x3821 = x3388 * x3520 + x3523 * x3717 - x3522 * x3735;
  const Real x3822 = x3821 - x3521 * x3768;
  const Real x3992 = x3372 * x3738 - x716 * x3719 + x3354 * x3774;
  const Real x2975 = x1122 * x2482 + x2973 + x1077 * x2632;
  const Real x3786 = x3533 * x3584 - x3535 * x3723 - x3534 * x3744;
  const Real x3983 = x3372 * x3735 - x716 * x3717 + x3354 * x3768;
  // joint 1 "knee": articulated-body inertia and bias force through it
  const Real x4121 = 1 / x4112;
  // link 2 "shank": accelerations and constraint forces of loops below it are eliminated
  const Real x4052 = across<2>(x1309) + x1556 - (x3336 * x3822 + x3983);
  const Real x4113 = across<2>(x1319) + x1753 - (x3336 * x3831 + x3992) + -0.7000000000000001;
  const Real x2977 = x1565 * x2688 + x2975 - x1580 * x2689;
  const Real x2989 = x1047 * x2481 + x1083 * x2417 + x1123 * x2482;
  const Real x3007 = x1048 * x2481 + x1084 * x2417 - x1124 * x2482;
  const Real x3848 = x2924 * x3520 - x3523 * x3723 - x3522 * x3744;
  const Real x3849 = x3848 - x3521 * x3786;
  const Real x4008 = x3404 * x3768 + x3420 * x3735 + x3388 * x3822;
  const Real x4026 = x3456 * x3774 + x3474 * x3738 + x3438 * x3831;
  const Real x2991 = x1078 * x2632 + x2989 + x1556 * x2688;
  const Real x3009 = x1079 * x2632 + x3007 - x1561 * x2688;
  const Real x2979 = x1040 * x2690 + x2977 + x1116 * x2691;
  const Real x4080 = x3372 * x3744 + x716 * x3723 + x3354 * x3786;
  const Real x4014 = x3404 * x3774 + x3420 * x3738 + x3388 * x3831;
  const Real x3030 = x1525 - 0.4 * x1782 + across<2>(x1387) + x2979;
  const Real x2993 = x1573 * x2689 + x2991 + x1041 * x2690;
  const Real x3561 = x3128 * 1.7763568394002505e-15;
  require_more(w, x3526, x3561, kLoopFree, 3);
  const Real x3011 = x1574 * x2689 + x3009 + x1042 * x2690;
  const Real x3562 = x3204 * 1.7763568394002505e-15;
  require_more(w, x3541, x3562, kLoopFree, 4);
  // joint 2 "ankle_pitch": inertia and bias force of what is beyond, its own motion left open
  const Real x1807 = cosine[4] * x1540 - sine[4] * x1541 + across<2>(x1373);
  // link 2 "shank": accelerations and constraint forces of loops below it are eliminated
  const Real x4086 = x3404 * x3786 + x3420 * x3744 + x3388 * x3849;
  const Real x4091 = x3456 * x3786 + x3474 * x3744 + x3438 * x3849;
  const Real x4106 = x1117 * x2691 + x2993 + x1807 - x4086;
  const Real x4107 = across<2>(x1376) + x1782 + (x3011 - x1118 * x2691) - x4091;
  // joint 1 "knee": articulated-body inertia and bias force through it
  const Real x4126 = x4052 * x4121;
  const Real x4127 = x4113 * x4121;
  const Real x4158 = across<2>(x1297) + 1.15 - x4008 + 3.5 - x4052 * x4126;
  const Real x4167 = across<2>(x1298) + 1.15 - x4026 + 3.5 - x4113 * x4127;
  // link 2 "shank": accelerations and constraint forces of loops below it are eliminated
  const Real x4117 = x3030 - (x3336 * x3849 + x4080) + x37 * 0.7000000000000001;
  // joint 1 "knee": articulated-body inertia and bias force through it
  const Real x4226 = (across<2>(x1295) - x4014 - x4052 * x4127) * (sine[3] * 2.0);
  const Real x4123 = x4121 * (tau[1] - x4117);
  // link 2 "shank": accelerations and constraint forces of loops below it are eliminated
  const Real x4118 = x32 * 3.5 + x41 * 0.7000000000000001 + x4106;
  // joint 1 "knee": articulated-body inertia and bias force through it
  const Real x4234 = x4158 - cosine[3] * (cosine[3] * (x4158 - x4167) - x4226);
  const Real x4275 = cosine[3] * (x4107 - x37 * 3.5 + x4113 * x4123);
  const Real x4286 = 0.32735000000000003 + 0.4 * (0.4 * x4234);
  require_more(w, x4286, 0.0, kFactorization, 0);
  const Real x4280 = 0.4 * (sine[3] * (x4118 + x4052 * x4123) + x4275);
  // joint 0 "hip": articulated-body inertia and bias force through it
  const Real x4297 = 1 / x4286 * (tau[0] - (tau[1] - x4280 + x14 * 1.2000000000000002));
  w.result[0] = x4297;
  // joint 1 "knee": its acceleration, and that of the link beyond
  const Real x4307 = 0.4 * x4297;
  const Real x4309 = sine[3] * x4307;
  const Real x4311 = cosine[3] * x4307;
  const Real x4318 = x4123 + x4126 * x4309 + x4127 * x4311;
  const Real x4319 = x4318 - x4297;
  w.result[1] = x4319;
  // link 2 "shank": accelerations and constraint forces of loops below it
  const Real x4327 = x3822 * x4309 + x3831 * x4311 - x3813 * x4318;
  const Real x4354 = x4327 - x3849;
  const Real x4335 = x3768 * x4309 + x3774 * x4311 - x3762 * x4318;
  const Real x4355 = x4335 - x3786;
  const Real x4343 = x3735 * x4309 + x3738 * x4311 - x3732 * x4318;
  const Real x4356 = x4343 - x3744;
  const Real x4352 = x3717 * x4309 + x3719 * x4311 + x3716 * x4318;
  const Real x4358 = -(x3723 + x4352);
  const Real x4378 = x2646 * x4354 + x2660 * x4355 + x2674 * x4356;
  const Real x4416 = x2690 + x4378;
  const Real x4383 = x2564 * x4354 + x2587 * x4355 + x2610 * x4356;
  const Real x4417 = x2632 + x4383;
  const Real x4388 = x2647 * x4354 + x2661 * x4355 + x2675 * x4356;
  const Real x4418 = x2691 + x4388;
  const Real x4397 = x2301 * x4354 + x2310 * x4355 + x2319 * x4356;
  const Real x4419 = x2333 - x4397;
  const Real x4403 = x2433 * x4354 + x2449 * x4355 + x2465 * x4356;
  const Real x4420 = x2481 + x4403;
  const Real x4408 = x2355 * x4354 + x2375 * x4355 + x2395 * x4356;
  const Real x4421 = x2417 + x4408;
  const Real x4413 = x2434 * x4354 + x2450 * x4355 + x2466 * x4356;
  const Real x4422 = x2482 + x4413;
  const Real x4367 = x2640 * x4354 + x2654 * x4355 + x2668 * x4356;
  const Real x4414 = x2688 - x4367;
  w.result[2] = x4414;
  const Real x4373 = x2645 * x4354 + x2659 * x4355 + x2673 * x4356;
  const Real x4415 = x2689 + x4373;
  w.result[3] = x4415;
  // joints 4 "left_motor", 6 "right_motor": accelerations of the links beyond them
  const Two x4462 = Two{x4416, x4420};
  put(x4462, w.lanes.data() + 0);
  // joints 5 "left_ball", 7 "right_ball": accelerations of the links beyond them
  const Two x4480 = Two{x4419, x4358};
  put(x4480, w.lanes.data() + 6);
  const Two x4478 = Two{x4417, x4421};
  put(x4478, w.lanes.data() + 2);
  const Two x4479 = Two{x4418, x4422};
  put(x4479, w.lanes.data() + 4);
}

// ---- 5. processes -------------------------------------------------------------------------------

// Process 0: 8 of 8 joints: "hip", "knee", "ankle_pitch", "ankle_roll", "left_motor", "left_ball", ...
constexpr std::array<int, 8> kRead_0{0, 1, 2, 3, 4, 5, 6, 7};
constexpr std::array<int, 8> kOwned_0{0, 1, 2, 3, 4, 5, 6, 7};
constexpr std::array<int, 6> kAngles_0{4, 9, 0, 1, 2, 3};

void run_0([[maybe_unused]] Workspace& w, [[maybe_unused]] Channel& channel) {
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
constexpr std::array<int, 6> kAngles_1{4, 9, 0, 1, 2, 3};
void recover_0([[maybe_unused]] Workspace& w, [[maybe_unused]] Channel& channel) {
  ADAGEN_INPUTS
  stamp(0);
  take_sines_and_cosines(q, kAngles_1, w.sine.data(), w.cosine.data());
  part_1_0(w);
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
