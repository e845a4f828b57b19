// Forward dynamics of "ankle" on 1 process, emitted by adagen 0.1.0 (solver.cpp.j2). Do not edit: generate again. Licence: yours to choose.
// robot     "ankle", 8 joints, 12 degrees of freedom, description sha256 ddb900f3e284309ae668afcdcf39b2b2f8b0b30c7e4b7984814bb0e23c113d8c
// command   adagen ../models/ankle.urdf --scene=../models/ankle.toml --procs 1
// input     scene, sha256 11c8028c5b54b9020d35bd5ac03db5bc865ea05a389c3bc7c7df6b476153c181
// input     profile default, sha256 fe36af9ff4727e4941af0e7182db7f87cd64c54109bc287302f720e9ad83c3a8
// options   form segment (articulated-body algorithm), shape unrolled (spatial vectors [angular; linear] in link frames whose joint axes are z), scalar double, channel auto, fixed base, gravity 0.0, 0.0, -9.81
// links     adagen_program.cpp; or, compiled with -DADAGEN_NO_MAIN, a program of yours that includes ankle_p1.h
// program   1 process; 0.119 us predicted (default profile)
//           process 0: left_motor .. left_ball | right_motor .. right_ball in 2 lanes, hip .. ankle_roll
//
// Closed loops: accelerations of their joints and constraint forces stay unknown until the last link that
// these joints have in common, where they are eliminated (docs/explanation/loops.md).

#include "ankle_p1.h"
#define ADAGEN_CALL(word) ankle_p1_##word
#define ADAGEN_NAMED(WORD) ANKLE_P1_##WORD
#define ADAGEN_LOOPS
#define ADAGEN_RECOVERS
#include "adagen/settings.hpp"

namespace { struct ankle_p1_settings : PlainSettings {
  static constexpr int kVersion = 100, kJointCount = 8, kNq = 14, kNv = 12;
  [[maybe_unused]] static constexpr const char* kRobot = "ankle";
}; }  // namespace: a program may load several solvers of one name

#include "adagen/constants.hpp"

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
     {0.0006626, 0.0, 0.0, 0.0, 0.0006626, 0.0, 0.0, 0.0, 2.7e-06}}}};

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
     {0.0, 0.0, 1.0, 1.0, 0.0, 0.0, 0.0, 1.0, 0.0}, {0.0, -0.06, 0.0}}}};

// Loops, then couplings: what statuses name them by.
constexpr int kLoopCount = 2;
constexpr std::array<const char*, 2> kLoopNames{ {
    "left_heel",
    "right_heel"}};

// ---- functions ----------------------------------------------------------------------------------

#include "adagen/far_angles.hpp"
#include "adagen/no_channel.hpp"
#include "adagen/unrolled_memory.hpp"

namespace {

struct Workspace : StraightMemory<8, 8, 0> {};

}  // namespace

#include "adagen/unrolled_numbers.hpp"
#include "adagen/unrolled_sines.hpp"
#include "adagen/unrolled.hpp"
#include "adagen/unrolled_functions.hpp"
#include "adagen/unrolled_wide.hpp"
#include "adagen/unrolled_wide_functions.hpp"

namespace {

// Each function is a straight line. A value is called x and its number in the expression graph; zeros
// and constants are folded in, common subexpressions are shared, and dead code is left out.
// Frames are the links' own; accelerations are deviations from the field that the links would have
// with all joint accelerations zero.

// =================================================================================================
// Process 0: 476 products, 353 sums, 6 quotients, 522 of them in lanes
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
  const Two x164 = x134 * x154;
  const Two x165 = x135 * x155;
  const Two x158 = x134 * x156;
  const Two x161 = x133 * x154;
  const Two x162 = x135 * x156;
  const Two x171 = x134 * x155;
  const Two x172 = x135 * x154;
  const Two x166 = x164 + x165;
  const Two x174 = x164 - x165;
  const Two x163 = x161 - x162;
  const Two x175 = x171 + x172;
  const Two x177 = 1.0 - (x157 + x168);
  const Two x173 = x171 - x172;
  const Two x160 = 1.0 - (x157 + x158);
  const Two x167 = x161 + x162;
  const Two x170 = 1.0 - (x158 + x168);
  // constraint rows of a loop at its two links
  const Two x443 = x85 + v[2] * v[2] + x99 * x99;
  const Two x445 = x142 * x142 + x443 + x143 * x143;
  const Two x582 = load<Two>(cosine + 0) * x177 - load<Two>(sine + 0) * x166;
  const Two x585 = load<Two>(sine + 0) * x177 + load<Two>(cosine + 0) * x166;
  const Two x530 = load<Two>(cosine + 0) * x175 - load<Two>(sine + 0) * x163;
  const Two x456 = load<Two>(cosine + 0) * x174 - load<Two>(sine + 0) * x160;
  const Two x459 = load<Two>(sine + 0) * x174 + load<Two>(cosine + 0) * x160;
  const Two x533 = load<Two>(sine + 0) * x175 + load<Two>(cosine + 0) * x163;
  // joint 3 "ankle_roll": inertia and bias force of what is beyond; its acceleration is an unknown
  const Real x1292 = sine[5] * 0.05;
  // constraint rows of a loop at its two links
  const Two x588 = cosine[4] * x582 + sine[4] * x585;
  const Two x462 = cosine[4] * x456 + sine[4] * x459;
  const Two x536 = cosine[4] * x530 + sine[4] * x533;
  const Two x595 = cosine[5] * x173 + sine[5] * x588;
  const Two x599 = cosine[5] * x588 - sine[5] * x173;
  const Two x592 = cosine[4] * x585 - sine[4] * x582;
  const Two x469 = cosine[5] * x167 + sine[5] * x462;
  const Two x473 = cosine[5] * x462 - sine[5] * x167;
  const Two x543 = cosine[5] * x170 + sine[5] * x536;
  const Two x547 = cosine[5] * x536 - sine[5] * x170;
  const Two x466 = cosine[4] * x459 - sine[4] * x456;
  const Two x540 = cosine[4] * x533 - sine[4] * x530;
  // joints 5 "left_ball", 7 "right_ball": inertia and bias force of what is beyond; their accelerations are unknowns
  const Two x800 = x177 * 0.06;
  const Two x653 = x167 * Two{0.00112635, 0.00264635};
  const Two x710 = x173 * 2.7e-06;
  const Two x822 = x166 * Two{0.01125, 0.01725};
  const Two x677 = x170 * Two{0.00112635, 0.00264635};
  const Two x857 = -0.009 - x822;
  const Two x728 = x170 * Two{0.15, 0.23} - x174 * 0.06;
  const Two x771 = x167 * Two{0.15, 0.23} + x175 * 0.06;
  // joint 3 "ankle_roll": inertia and bias force of what is beyond; its acceleration is an unknown
  const Real x1433 = 0.06 * (sine[5] * x595[0] + cosine[5] * x599[0]);
  const Real x1435 = x592[0] * x1292 + x1433;
  const Real x1463 = 0.06 * (sine[5] * x595[1] + cosine[5] * x599[1]);
  const Real x1465 = x1463 - x592[1] * x1292;
  // link 2 "shank": accelerations and constraint forces of loops below it are eliminated
  const Two x1886 = 1 / x800;
  const Two x1870 = Two{x1435, x1465};
  const Two x1888 = x1870 * x1886;
  // joint 1 "knee": placement, velocity and reference acceleration of its link
  const Real x32 = cosine[3] * x28 - x14 * sine[3];
  const Real x37 = sine[3] * x28 + x14 * cosine[3];
  // joint 2 "ankle_pitch": placement, velocity and reference acceleration of its link
  const Real x51 = x32 + 0.4 * x41;
  // joint 3 "ankle_roll": placement, velocity and reference acceleration of its link
  const Real x71 = x48 * sine[5];
  const Real x75 = v[3] * x70;
  const Real x82 = x70 * x70;
  const Real x83 = x71 * x71;
  const Real x94 = x82 + x83;
  // joints 4 "left_motor", 6 "right_motor": placement, velocity and reference acceleration of their links
  const Two x111 = x32 + x41 * Two{0.25, 0.17};
  const Two x120 = load<Two>(sine + 0) * x111 + load<Two>(cosine + 0) * x37;
  const Two x115 = load<Two>(cosine + 0) * x111 - load<Two>(sine + 0) * x37;
  // joints 5 "left_ball", 7 "right_ball": placement, velocity and reference acceleration of their links
  const Two x179 = x107 * x167;
  const Two x180 = x107 * x170;
  const Two x181 = x107 * x173;
  const Two x182 = x142 + x179;
  const Two x183 = x143 + x180;
  const Two x184 = x144 + x181;
  // constraint rows of a loop at its two links
  const Two x613 = Two{0.05, -0.05} * x599;
  const Two x561 = Two{0.05, -0.05} * x547;
  const Two x509 = Two{0.05, -0.05} * x473;
  // joints 5 "left_ball", 7 "right_ball": inertia and bias force of what is beyond; their accelerations are unknowns
  const Two x654 = x175 * Two{0.01125, 0.01725};
  const Two x678 = x174 * Two{0.01125, 0.01725};
  const Two x855 = x167 * x653 + x173 * x710 + x170 * x677;
  const Two x662 = x653 + 0.06 * x654;
  const Two x689 = x677 - 0.06 * x678;
  const Two x913 = x855 - 0.06 * (x857 - x822) + 0.0002466667;
  const Two x655 = x163 * Two{0.01125, 0.01725};
  const Two x820 = x177 * Two{0.01125, 0.01725};
  const Two x914 = 0.006 - x857;
  // joint 3 "ankle_roll": inertia and bias force of what is beyond; its acceleration is an unknown
  const Real x1317 = 0.06 * (sine[5] * x469[0] + cosine[5] * x473[0]);
  const Real x1319 = x466[0] * x1292 + x1317;
  const Real x1349 = 0.06 * (sine[5] * x469[1] + cosine[5] * x473[1]);
  const Real x1351 = x1349 - x466[1] * x1292;
  const Real x1376 = 0.06 * (sine[5] * x543[0] + cosine[5] * x547[0]);
  const Real x1378 = x540[0] * x1292 + x1376;
  const Real x1406 = 0.06 * (sine[5] * x543[1] + cosine[5] * x547[1]);
  const Real x1408 = x1406 - x540[1] * x1292;
  // link 2 "shank": accelerations and constraint forces of loops below it are eliminated
  const Two x1851 = Two{x1319, x1351};
  const Two x1859 = Two{x1378, x1408};
  const Two x1890 = x613 * x1886;
  const Two x1908 = (x1851 + x728 * x1888) * Two{6.666666666666667, 4.3478260869565215};
  const Two x1924 = Two{6.666666666666667, 4.3478260869565215} * (x1859 - x771 * x1888);
  const Two x1971 = x689 * x1888 - Two{0.00112635, 0.00264635} * x1908;
  const Two x1964 = x662 * x1888 + Two{0.00112635, 0.00264635} * x1924;
  const Two x1926 = Two{6.666666666666667, 4.3478260869565215} * (x561 - x771 * x1890);
  const Two x1955 = x913 * x1888 + x662 * x1924 - x689 * x1908;
  const Two x1909 = (x509 + x728 * x1890) * Two{6.666666666666667, 4.3478260869565215};
  const Two x1976 = x710 * x1888;
  const Two x2188 = x1976 * 370370.3703703704;
  const Two x1982 = x1924 * x1964 - x1908 * x1971 + x1888 * x1955;
  const Two x1967 = x662 * x1890 + Two{0.00112635, 0.00264635} * x1926;
  const Two x1961 = x913 * x1890 + x662 * x1926 - x689 * x1909;
  const Two x2200 = x1976 * x2188;
  const Two x1975 = x689 * x1890 - Two{0.00112635, 0.00264635} * x1909;
  // joint 2 "ankle_pitch": placement, velocity and reference acceleration of its link
  const Real x55 = cosine[4] * x51 - x37 * sine[4];
  const Real x60 = sine[4] * x51 + x37 * cosine[4];
  // joint 3 "ankle_roll": placement, velocity and reference acceleration of its link
  const Real x77 = x55 * sine[5];
  const Real x88 = x70 * x71;
  const Real x78 = x55 * cosine[5];
  // joints 5 "left_ball", 7 "right_ball": placement, velocity and reference acceleration of their links
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
  // links 6 "left_rod", 8 "right_rod": bias force in the reference field
  const Two x385 = x203 * 0.15 - x230 * Two{0.01125, 0.01725};
  const Two x389 = x206 * 0.15 - x224 * Two{0.01125, 0.01725};
  const Two x374 = (x143 * x179 - x142 * x180) * 2.7e-06;
  const Two x378 = x188 * Two{0.00112635, 0.00264635} - x223 * Two{0.00112365, 0.00264365} + x206 * Two{0.01125, 0.01725};
  // constraint rows of a loop at its two links
  const Two x488 = x77 - (x83 + x85) * Two{0.05, -0.05};
  const Two x496 = 2.0 * x75 * Two{0.05, -0.05} + x94 * 0.06 - x60;
  const Two x491 = x78 - x88 * Two{0.05, -0.05};
  // joints 5 "left_ball", 7 "right_ball": inertia and bias force of what is beyond; their accelerations are unknowns
  const Two x680 = x160 * Two{0.01125, 0.01725};
  // joints 4 "left_motor", 6 "right_motor": inertia and bias force of what is beyond; their accelerations are unknowns
  const Two x939 = load<Two>(cosine + 0) * x820;
  const Two x941 = load<Two>(sine + 0) * x914 - x939;
  const Two x973 = load<Two>(sine + 0) * x654 + load<Two>(cosine + 0) * x655;
  const Two x1011 = load<Two>(sine + 0) * x678 + load<Two>(cosine + 0) * x680;
  const Two x949 = x913 - Two{0.25, 0.17} * x941;
  const Two x984 = x662 - Two{0.25, 0.17} * x973;
  const Two x1023 = x689 + Two{0.25, 0.17} * x1011;
  // joint 3 "ankle_roll": inertia and bias force of what is beyond; its acceleration is an unknown
  const Real x1494 = 0.00630833 + cosine[5] * (cosine[5] * 0.0019583400000000003) + 2.4e-05;
  const Real x1288 = sine[5] * 0.002;
  // link 2 "shank": accelerations and constraint forces of loops below it are eliminated
  const Two x1988 = x1888 * x1961 + x1924 * x1967 - x1908 * x1975;
  const Two x1989 = x710 * x1890;
  const Two x2201 = x1989 * x2188;
  const Real x2272 = x1494 + across<2>(x1982) - across<2>(x2200);
  const Two x2001 = x1926 * x1967 - x1909 * x1975 + x1890 * x1961;
  const Two x2189 = x1989 * 370370.3703703704;
  const Real x2306 = 1 / x2272;
  const Two x2207 = x1989 * x2189;
  // joint 3 "ankle_roll": placement, velocity and reference acceleration of its link
  const Real x73 = v[3] * x71;
  const Real x90 = x82 + x85;
  // links 6 "left_rod", 8 "right_rod": bias force in the reference field
  const Two x393 = x209 * 0.15 + x226 * Two{0.01125, 0.01725};
  const Two x381 = x192 * Two{0.00112635, 0.00264635} + x228 * Two{0.00112365, 0.00264365} - x203 * Two{0.01125, 0.01725};
  // constraint rows of a loop at its two links
  const Two x605 = x488 * x595 + x496 * x592 + x491 * x599;
  const Two x501 = x469 * x488 + x466 * x496 + x473 * x491;
  const Two x553 = x488 * x543 + x496 * x540 + x491 * x547;
  // joints 5 "left_ball", 7 "right_ball": inertia and bias force of what is beyond; their accelerations are unknowns
  const Two x893 = x174 * x385 + x175 * x389 + x177 * x393;
  const Two x911 = -0.006 + x857;
  const Two x888 = x167 * x378 + x173 * x374 + x170 * x381;
  // joints 4 "left_motor", 6 "right_motor": inertia and bias force of what is beyond; their accelerations are unknowns
  const Two x935 = load<Two>(sine + 0) * x820;
  const Two x937 = load<Two>(cosine + 0) * x914 + x935;
  const Two x970 = load<Two>(cosine + 0) * x654 - load<Two>(sine + 0) * x655;
  const Two x1196 = x939 + load<Two>(sine + 0) * x911;
  const Two x1006 = load<Two>(sine + 0) * x680 - load<Two>(cosine + 0) * x678;
  // joint 3 "ankle_roll": inertia and bias force of what is beyond; its acceleration is an unknown
  const Real x1291 = cosine[5] * 0.05;
  // joint 2 "ankle_pitch": inertia and bias force of what is beyond; its acceleration is an unknown
  const Real x1517 = sine[4] * 0.04 + cosine[4] * x1291;
  const Real x1530 = sine[4] * x1292;
  // link 2 "shank": accelerations and constraint forces of loops below it are eliminated
  const Two x2043 = x949 * x1888 + x984 * x1924 - x1023 * x1908;
  const Two x2192 = x710 * 370370.3703703704;
  const Real x2274 = across<2>(x1988) - x1288 - across<2>(x2201);
  const Two x2049 = x949 * x1890 + x984 * x1926 - x1023 * x1909;
  const Two x2224 = x1976 * x2192;
  const Real x2307 = x2274 * x2306;
  const Two x1892 = (x605 - (x209 + x226 * Two{0.15, 0.23})) * x1886;
  const Two x2225 = x1989 * x2192;
  const Real x2275 = 0.003308333 + across<2>(x2001) - across<2>(x2207);
  const Real x2310 = x2275 - x2274 * x2307;
  // link 4 "foot": bias force in the reference field
  const Real x292 = x73 * 0.002999997 - x73 * 0.00826667;
  const Real x312 = 0.002 * (x94 - x90) + x292 + x60 * 0.05;
  const Real x302 = x75 * 0.004958337 - x75 * 0.00630833 + x88 * 0.002;
  // joints 5 "left_ball", 7 "right_ball": inertia and bias force of what is beyond; their accelerations are unknowns
  const Two x640 = x378 - Two{tau[5], tau[9]};
  const Two x645 = x381 - Two{tau[6], tau[10]};
  const Two x916 = x888 + 0.06 * x893 + x115 * 0.006;
  // joints 4 "left_motor", 6 "right_motor": inertia and bias force of what is beyond; their accelerations are unknowns
  const Two x1214 = Two{-0.0875, -0.059500000000000004} - x1196;
  const Two x922 = x916 - Two{tau[4], tau[8]};
  const Two x1234 = x913 - Two{0.25, 0.17} * (x1214 - x1196);
  // joint 3 "ankle_roll": inertia and bias force of what is beyond; its acceleration is an unknown
  const Real x1478 = cosine[5] * (x312 - x78 * 0.04);
  const Real x1481 = x1478 - sine[5] * (x302 + x77 * 0.04);
  // joint 2 "ankle_pitch": inertia and bias force of what is beyond; its acceleration is an unknown
  const Real x1796 = -0.46 - x1517;
  const Real x1512 = sine[4] * x1291 - cosine[4] * 0.04;
  // link 2 "shank": accelerations and constraint forces of loops below it are eliminated
  const Two x2067 = x941 * x1888 + x973 * x1924 + x1011 * x1908;
  const Real x2311 = 1 / x2310;
  const Two x1906 = x501 - (x203 - x230 * Two{0.15, 0.23}) + x728 * x1892;
  const Two x1910 = x1906 * Two{6.666666666666667, 4.3478260869565215};
  const Two x1922 = x553 - (x206 - x224 * Two{0.15, 0.23}) - x771 * x1892;
  const Two x1928 = Two{6.666666666666667, 4.3478260869565215} * x1922;
  const Real x2278 = x1494 + 0.4 * x1517 + across<2>(x2043) - across<2>(x2224);
  const Two x2055 = x937 * x1888 + x970 * x1924 - x1006 * x1908;
  const Two x2073 = x941 * x1890 + x973 * x1926 + x1011 * x1909;
  const Real x2281 = across<2>(x2049) - (x1288 + 0.4 * x1530) - across<2>(x2225);
  const Two x2061 = x937 * x1890 + x970 * x1926 - x1006 * x1909;
  const Two x2110 = x640 * x1924 - x645 * x1908 + x922 * x1888;
  const Two x2116 = x640 * x1926 - x645 * x1909 + x922 * x1890;
  const Two x2123 = x1928 * x1964 - x1910 * x1971 + x1892 * x1955;
  const Two x2193 = (x374 - Two{tau[7], tau[11]} + x710 * x1892) * 370370.3703703704;
  const Two x2228 = x710 * x2192;
  const Real x2345 = x2311 * (x2281 - x2278 * x2307);
  const Real x2092 = across<2>(x2067) - x1517;
  const Two x2129 = x1892 * x1961 + x1928 * x1967 - x1910 * x1975;
  const Two x2230 = x1976 * x2193;
  // joints 5 "left_ball", 7 "right_ball": inertia and bias force of what is beyond; their accelerations are unknowns
  const Two x917 = x115 * 0.2 + x893;
  const Two x898 = x160 * x385 + x163 * x389 + x166 * x393;
  const Two x918 = x122 * 0.006 - x120 * 0.2 + x898;
  // joints 4 "left_motor", 6 "right_motor": inertia and bias force of what is beyond; their accelerations are unknowns
  const Two x1255 = load<Two>(sine + 0) * x917 + load<Two>(cosine + 0) * x918;
  const Two x1199 = load<Two>(cosine + 0) * x911 - x935;
  const Two x1266 = x916 - Two{0.25, 0.17} * x1255;
  // joint 3 "ankle_roll": inertia and bias force of what is beyond; its acceleration is an unknown
  const Real x1489 = sine[5] * (x77 + x88 * 0.05);
  const Real x1491 = x1489 + cosine[5] * (x78 + x90 * 0.05);
  const Real x1496 = x55 * 0.15 + x1491;
  // link 4 "foot": bias force in the reference field
  const Real x330 = 2.0 * x73 * 0.05 - x94 * 0.04 - x60;
  // joint 3 "ankle_roll": inertia and bias force of what is beyond; its acceleration is an unknown
  const Real x1497 = x330 - x60 * 0.15;
  // joint 2 "ankle_pitch": inertia and bias force of what is beyond; its acceleration is an unknown
  const Real x1824 = sine[4] * x1496 + cosine[4] * x1497;
  // link 2 "shank": accelerations and constraint forces of loops below it are eliminated
  const Real x2091 = x1512 + across<2>(x2055);
  const Real x2103 = x1530 + across<2>(x2073);
  const Two x2231 = x1989 * x2193;
  const Real x2358 = x2278 * x2306 - x2307 * x2345;
  const Real x2102 = cosine[4] * x1292 + across<2>(x2061);
  const Real x2347 = x2311 * (x2103 - x2092 * x2307);
  const Real x2346 = x2311 * (x2102 - x2091 * x2307);
  const Real x2133 = x88 * 0.0019583400000000003 + x77 * 0.05 - tau[3] + across<2>(x2116);
  const Real x2282 = x1481 - tau[2] + across<2>(x2110) + across<2>(x2123) - across<2>(x2230);
  const Real x2299 = x1494 - 0.4 * (x1796 - x1517) + across<2>(x1234) - across<2>(x2228);
  const Real x2364 = x2092 * x2306 - x2307 * x2347;
  const Real x2520 = x2299 - (x2278 * x2358 + x2281 * x2345) + 0.18885420000000003;
  require_more(w, x2520, 0.0, kFactorization, 1);
  const Real x2361 = x2091 * x2306 - x2307 * x2346;
  const Two x2158 = x949 * x1892 + x984 * x1928 - x1023 * x1910;
  const Two x2234 = x710 * x2193;
  const Real x2349 = x2311 * (x2133 + across<2>(x2129) - across<2>(x2231) - x2282 * x2307);
  // joint 1 "knee": articulated-body inertia and bias force through it
  const Real x2529 = 1 / x2520;
  // constraint rows of a loop at its two links
  const Two x399 = sine[5] * Two{0.05, -0.05};
  const Two x410 = x177 * Two{0.15, 0.23};
  const Two x416 = -0.06 - x166 * Two{0.15, 0.23};
  // joints 4 "left_motor", 6 "right_motor": inertia and bias force of what is beyond; their accelerations are unknowns
  const Two x1252 = load<Two>(cosine + 0) * x917 - load<Two>(sine + 0) * x918;
  // link 2 "shank": accelerations and constraint forces of loops below it are eliminated
  const Real x2481 = across<2>(x1199) - x1512 + (x2278 * x2361 + x2281 * x2346);
  const Real x2483 = across<2>(x1214) + x1796 - (x2278 * x2364 + x2281 * x2347);
  const Real x2521 = -0.7000000000000001 + x2483;
  const Real x2370 = x2282 * x2306 - x2307 * x2349;
  const Two x2164 = x937 * x1892 + x970 * x1928 - x1006 * x1910;
  const Two x2170 = x941 * x1892 + x973 * x1928 + x1011 * x1910;
  const Real x2305 = x1481 - 0.4 * x1824 + across<2>(x1266) + across<2>(x2158) - across<2>(x2234);
  const Real x2513 = x2305 - (x2278 * x2370 + x2281 * x2349);
  const Real x2184 = cosine[4] * x1496 - sine[4] * x1497 + across<2>(x1252) + across<2>(x2164);
  const Real x2501 = x2092 * x2370 + x2103 * x2349;
  const Real x2514 = x2184 - (x2091 * x2370 + x2102 * x2349);
  // joint 1 "knee": articulated-body inertia and bias force through it
  const Real x2534 = x2481 * x2529;
  const Real x2536 = x2521 * x2529;
  // link 2 "shank": accelerations and constraint forces of loops below it are eliminated
  const Real x2522 = 1.85 - (x2091 * x2361 + x2102 * x2346) + 3.5;
  // joint 1 "knee": articulated-body inertia and bias force through it
  const Real x2570 = x2522 - x2481 * x2534;
  // link 2 "shank": accelerations and constraint forces of loops below it are eliminated
  const Real x2523 = 1.85 - (x2092 * x2364 + x2103 * x2347) + 3.5;
  // joint 1 "knee": articulated-body inertia and bias force through it
  const Real x2573 = x2481 * x2536 - (x2091 * x2364 + x2102 * x2347);
  const Real x2643 = cosine[3] * (x2570 - (x2523 - x2521 * x2536));
  const Real x2531 = x2529 * (tau[1] - (x37 * 0.7000000000000001 + x2513));
  // link 2 "shank": accelerations and constraint forces of loops below it are eliminated
  const Real x2526 = x32 * 3.5 + x41 * 0.7000000000000001 + x2514;
  const Real x2527 = across<2>(x1255) + x1824 + across<2>(x2170) - x2501 - x37 * 3.5;
  // joint 1 "knee": articulated-body inertia and bias force through it
  const Real x2652 = x2570 - cosine[3] * (x2643 - x2573 * (sine[3] * 2.0));
  // constraint rows of a loop at its two links
  const Two x407 = sine[4] * x399 - cosine[4] * 0.06;
  const Two x430 = x407 - (load<Two>(cosine + 0) * x416 - load<Two>(sine + 0) * x410);
  const Two x431 = cosine[5] * Two{0.05, -0.05} - (Two{0.05, -0.05} - x173 * Two{0.15, 0.23});
  const Two x408 = cosine[4] * x399 + sine[4] * 0.06 + -0.4;
  const Two x429 = x408 - (Two{-0.25, -0.17} - (load<Two>(cosine + 0) * x410 + load<Two>(sine + 0) * x416));
  const Two x436 = x430 * x430 + x431 * x431 + x429 * x429;
  const Two x448 = 1e-08 - x436;
  require_more(w, x448, 0.0, kLoopOpen, {8, 9});
  // link 2 "shank": accelerations and constraint forces of loops below it are eliminated
  const Two x1943 = x1890 * x1890 + x1926 * x1926 + x1909 * x1909;
  const Two x1856 = x99 * x728 + x143 * Two{0.15, 0.23} + v[3] * x509;
  const Two x1857 = v[2] * x1851 + x1856;
  const Two x1867 = v[3] * x561 - (x99 * x771 + x142 * Two{0.15, 0.23});
  const Two x1868 = v[2] * x1859 + x1867;
  const Two x1945 = x1888 * x1888 + x1943 + x1924 * x1924;
  const Two x1946 = x1908 * x1908 + x1945;
  const Two x1875 = v[3] * x613 - x99 * x800 + v[2] * x1870;
  const Real x2312 = x1494 * 1e-08;
  require_more(w, x2272, x2312, kSingularPose, 2);
  const Two x1897 = x800 * x800 * 256.0;
  require_more(w, x1897, 9.999999999999998e-15, kSingularPose, {8, 9});
  const Real x2314 = 1e-08 * (0.003308333 + x2275);
  require_more(w, x2310, x2314, kSingularPose, 3);
  const Two x1880 = x1857 * x1857 + x1868 * x1868 + x1875 * x1875;
  const Two x1881 = (x144 * x144 + x445 + 1.0) * 1.0000000000000002e-06 - x1880;
  require_more(w, x1881, 0.0, kLoopTorn, {8, 9});
  const Real x1949 = 40000.0 - across<2>(x1946);
  require_more(w, x1949, 0.0, kSingularPose, 8);
  // joint 1 "knee": articulated-body inertia and bias force through it
  const Real x2692 = sine[3] * (x2526 - x2481 * x2531);
  const Real x2704 = 0.32735000000000003 + 0.4 * (0.4 * x2652);
  require_more(w, x2704, 0.0, kFactorization, 0);
  const Real x2698 = 0.4 * (x2692 + cosine[3] * (x2527 + x2521 * x2531));
  // joint 0 "hip": articulated-body inertia and bias force through it
  const Real x2715 = 1 / x2704 * (tau[0] - (tau[1] - x2698 + x14 * 1.2000000000000002));
  w.result[0] = x2715;
  // joint 1 "knee": its acceleration, and that of the link beyond
  const Real x2725 = 0.4 * x2715;
  const Real x2727 = sine[3] * x2725;
  const Real x2729 = cosine[3] * x2725;
  const Real x2736 = x2531 - x2534 * x2727 + x2536 * x2729;
  const Real x2737 = x2736 - x2715;
  w.result[1] = x2737;
  // link 2 "shank": accelerations and constraint forces of loops below it
  const Real x2745 = x2361 * x2727 + x2364 * x2729 - x2358 * x2736;
  const Real x2754 = x2745 - x2370;
  w.result[2] = x2754;
  const Real x2753 = x2346 * x2727 + x2347 * x2729 - x2345 * x2736;
  const Real x2755 = x2753 - x2349;
  w.result[3] = x2755;
  const Two x2764 = x2188 * x2754 + x2189 * x2755;
  const Two x2784 = x1888 * x2754 + x1890 * x2755 + x1892;
  put(x2784, w.lanes.data() + 0);
  const Two x2785 = x1924 * x2754 + x1926 * x2755 + x1928;
  put(x2785, w.lanes.data() + 2);
  const Two x2767 = -(x2193 + x2192 * x2736 + x2764);
  put(x2767, w.lanes.data() + 6);
  const Two x2787 = -(x1908 * x2754 + x1909 * x2755 + x1910);
  put(x2787, w.lanes.data() + 4);
}

// =================================================================================================
// Process 0 in a singular pose: 1369 products, 986 sums, 20 quotients
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
  const Real x138 = 1.0 - (x135 + x136);
  const Real x151 = x149 - x150;
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
  // constraint rows of a loop at its two links
  const Real x572 = v[2] * v[2];
  const Real x574 = v[4] * v[4] + v[5] * v[5] + v[6] * v[6];
  const Real x531 = sine[3] * 0.05;
  // constraint rows of a loop at its two links
  const Real x757 = v[8] * v[8] + v[9] * v[9] + v[10] * v[10];
  // joint 5 "left_ball": placement, velocity and reference acceleration of its link
  const Real x155 = 1.0 - (x135 + x146);
  // joint 7 "right_ball": placement, velocity and reference acceleration of its link
  const Real x253 = q[12] * x251;
  const Real x259 = q[12] * x249;
  const Real x260 = q[13] * x250;
  const Real x255 = 1.0 - (x252 + x253);
  const Real x256 = q[11] * x249;
  const Real x269 = x259 - x260;
  const Real x257 = q[13] * x251;
  const Real x266 = q[12] * x250;
  // constraint rows of a loop at its two links
  const Real x587 = cosine[4] * x152 - sine[4] * x138;
  const Real x590 = sine[4] * x152 + cosine[4] * x138;
  const Real x642 = cosine[4] * x153 - sine[4] * x141;
  const Real x645 = sine[4] * x153 + cosine[4] * x141;
  const Real x593 = cosine[2] * x587 + sine[2] * x590;
  const Real x597 = cosine[2] * x590 - sine[2] * x587;
  const Real x648 = cosine[2] * x642 + sine[2] * x645;
  const Real x652 = cosine[2] * x645 - sine[2] * x642;
  const Real x678 = cosine[4] * x155 - sine[4] * x144;
  const Real x600 = cosine[3] * x145 + sine[3] * x593;
  const Real x604 = cosine[3] * x593 - sine[3] * x145;
  const Real x681 = sine[4] * x155 + cosine[4] * x144;
  const Real x655 = cosine[3] * x148 + sine[3] * x648;
  const Real x659 = cosine[3] * x648 - sine[3] * x148;
  const Real x637 = 0.05 * x604;
  const Real x673 = 0.05 * x659;
  const Real x684 = cosine[2] * x678 + sine[2] * x681;
  const Real x688 = cosine[2] * x681 - sine[2] * x678;
  const Real x691 = cosine[3] * x151 + sine[3] * x684;
  const Real x695 = cosine[3] * x684 - sine[3] * x151;
  const Real x709 = 0.05 * x695;
  // joint 5 "left_ball": inertia and bias force of what is beyond; its acceleration is an unknown
  const Real x1369 = x148 * 0.15 - x152 * 0.06;
  const Real x1384 = x145 * 0.15 + x153 * 0.06;
  const Real x1391 = x155 * 0.06;
  // joint 3 "ankle_roll": inertia and bias force of what is beyond; its acceleration is an unknown
  const Real x1796 = 0.06 * (sine[3] * x600 + cosine[3] * x604);
  const Real x1798 = x531 * x597 + x1796;
  const Real x1823 = 0.06 * (sine[3] * x655 + cosine[3] * x659);
  const Real x1825 = x531 * x652 + x1823;
  // link 2 "shank": accelerations and constraint forces of loops below it are eliminated
  const Real x2381 = x1369 * 8.0;
  const Real x2385 = x1384 * 8.0;
  const Real x2390 = x1391 * 16.0;
  const Real x2380 = x637 * 8.0;
  const Real x2384 = x673 * 8.0;
  const Real x2414 = x2381 * x2381 + 1.44 + x2380 * x2380;
  const Real x2379 = x1798 * 8.0;
  const Real x2383 = x1825 * 8.0;
  // joint 7 "right_ball": placement, velocity and reference acceleration of its link
  const Real x267 = q[13] * x249;
  const Real x262 = x256 + x257;
  const Real x258 = x256 - x257;
  const Real x263 = q[10] * x249;
  const Real x270 = x266 + x267;
  const Real x265 = 1.0 - (x253 + x263);
  const Real x261 = x259 + x260;
  const Real x268 = x266 - x267;
  const Real x272 = 1.0 - (x252 + x263);
  // constraint rows of a loop at its two links
  const Real x767 = cosine[5] * x269 - sine[5] * x255;
  const Real x770 = sine[5] * x269 + cosine[5] * x255;
  const Real x773 = cosine[2] * x767 + sine[2] * x770;
  const Real x777 = cosine[2] * x770 - sine[2] * x767;
  const Real x818 = cosine[5] * x270 - sine[5] * x258;
  const Real x821 = sine[5] * x270 + cosine[5] * x258;
  const Real x780 = cosine[3] * x262 + sine[3] * x773;
  const Real x784 = cosine[3] * x773 - sine[3] * x262;
  const Real x812 = 0.05 * x784;
  const Real x824 = cosine[2] * x818 + sine[2] * x821;
  const Real x828 = cosine[2] * x821 - sine[2] * x818;
  const Real x855 = cosine[5] * x272 - sine[5] * x261;
  const Real x858 = sine[5] * x272 + cosine[5] * x261;
  const Real x831 = cosine[3] * x265 + sine[3] * x824;
  const Real x835 = cosine[3] * x824 - sine[3] * x265;
  const Real x849 = 0.05 * x835;
  const Real x861 = cosine[2] * x855 + sine[2] * x858;
  // joint 7 "right_ball": inertia and bias force of what is beyond; its acceleration is an unknown
  const Real x936 = x265 * 0.23 - 0.06 * x269;
  // joint 3 "ankle_roll": inertia and bias force of what is beyond; its acceleration is an unknown
  const Real x1850 = 0.06 * (sine[3] * x691 + cosine[3] * x695);
  const Real x1852 = x531 * x688 + x1850;
  const Real x1879 = 0.06 * (sine[3] * x780 + cosine[3] * x784);
  const Real x1881 = x1879 - x531 * x777;
  // link 2 "shank": accelerations and constraint forces of loops below it are eliminated
  const Real x2389 = x709 * 16.0;
  const Real x2388 = x1852 * 16.0;
  const Real x2417 = sign_of(x2379) * sqrt_of(x2379 * x2379 + x2414);
  const Real x2393 = x812 * 4.0;
  const Real x2418 = x2379 + x2417;
  const Real x2395 = x936 * 4.0;
  const Real x2420 = x2414 + x2418 * x2418;
  const Real x2650 = x2395 * x2395 + 0.8464;
  const Real x2392 = x1881 * 4.0;
  const Real x2398 = x849 * 4.0;
  // joint 0 "hip": placement, velocity and reference acceleration of its link
  const Real x9 = sine[0] * 9.81;
  // joint 1 "knee": placement, velocity and reference acceleration of its link
  const Real x23 = cosine[0] * 9.81 + v[0] * v[0] * 0.4;
  const Real x27 = cosine[1] * x23 - x9 * sine[1];
  const Real x32 = sine[1] * x23 + x9 * cosine[1];
  // joint 2 "ankle_pitch": placement, velocity and reference acceleration of its link
  const Real x46 = x27 + 0.4 * x36;
  const Real x50 = cosine[2] * x46 - x32 * sine[2];
  // joint 3 "ankle_roll": placement, velocity and reference acceleration of its link
  const Real x65 = x43 * cosine[3];
  const Real x66 = x43 * sine[3];
  const Real x70 = v[3] * x65;
  const Real x77 = x65 * x65;
  const Real x78 = x66 * x66;
  const Real x89 = x77 + x78;
  // joint 4 "left_motor": placement, velocity and reference acceleration of its link
  const Real x103 = x27 + x36 * 0.25;
  // joint 5 "left_ball": placement, velocity and reference acceleration of its link
  const Real x157 = x99 * x145;
  const Real x159 = x99 * x151;
  // constraint rows of a loop at its two links
  const Real x620 = 2.0 * x70 * 0.05;
  const Real x621 = x89 * 0.06;
  // constraint rows of a loop at its two links
  const Real x865 = cosine[2] * x858 - sine[2] * x855;
  const Real x868 = cosine[3] * x268 + sine[3] * x861;
  const Real x872 = cosine[3] * x861 - sine[3] * x268;
  const Real x886 = 0.05 * x872;
  // joint 7 "right_ball": inertia and bias force of what is beyond; its acceleration is an unknown
  const Real x958 = 0.06 * x272;
  const Real x951 = x262 * 0.23 + 0.06 * x270;
  // joint 3 "ankle_roll": inertia and bias force of what is beyond; its acceleration is an unknown
  const Real x1908 = 0.06 * (sine[3] * x831 + cosine[3] * x835);
  const Real x1910 = x1908 - x531 * x828;
  const Real x1937 = 0.06 * (sine[3] * x868 + cosine[3] * x872);
  const Real x1939 = x1937 - x531 * x865;
  // link 2 "shank": accelerations and constraint forces of loops below it are eliminated
  const Real x2406 = x958 * 16.0;
  const Real x2400 = x951 * 4.0;
  const Real x2422 = 2.0 * (1 / x2420);
  const Real x2397 = x1910 * 4.0;
  const Real x2404 = x886 * 16.0;
  const Real x2428 = x2380 * x2384 - x2381 * x2385 + x2383 * x2418;
  const Real x2429 = x2422 * x2428;
  const Real x2444 = x2380 * x2389 - x2381 * x2390 + x2388 * x2418;
  const Real x2445 = x2422 * x2444;
  const Real x2459 = x2422 * (x2392 * x2418 - x2380 * x2393);
  const Real x2433 = 1.2 * x2429;
  const Real x2449 = 1.2 * x2445;
  const Real x2462 = x2381 * x2459;
  const Real x2463 = 1.2 * x2459;
  const Real x2435 = x2384 - x2380 * x2429;
  const Real x2436 = x2385 + x2381 * x2429;
  const Real x2452 = x2390 + x2381 * x2445;
  const Real x2451 = x2389 - x2380 * x2445;
  const Real x2465 = x2393 + x2380 * x2459;
  const Real x2504 = 1.44 + x2433 * x2433;
  const Real x2500 = x2436 * x2436;
  const Real x2473 = x2422 * (x2397 * x2418 - x2380 * x2398);
  const Real x2403 = x1939 * 16.0;
  const Real x2476 = x2381 * x2473;
  const Real x2477 = 1.2 * x2473;
  const Real x2479 = x2398 + x2380 * x2473;
  const Real x2487 = x2422 * (x2403 * x2418 - x2380 * x2404);
  // joint 2 "ankle_pitch": placement, velocity and reference acceleration of its link
  const Real x55 = sine[2] * x46 + x32 * cosine[2];
  // joint 3 "ankle_roll": placement, velocity and reference acceleration of its link
  const Real x72 = x50 * sine[3];
  const Real x83 = x65 * x66;
  const Real x73 = x50 * cosine[3];
  // joint 4 "left_motor": placement, velocity and reference acceleration of its link
  const Real x112 = sine[4] * x103 + x32 * cosine[4];
  const Real x107 = cosine[4] * x103 - x32 * sine[4];
  // joint 5 "left_ball": placement, velocity and reference acceleration of its link
  const Real x160 = v[5] + x157;
  const Real x162 = v[7] + x159;
  const Real x158 = x99 * x148;
  const Real x170 = v[5] * x159 - v[7] * x157;
  const Real x178 = x114 * 0.06 - x112;
  const Real x206 = x160 * x162;
  const Real x161 = v[6] + x158;
  const Real x208 = x170 + x206;
  const Real x166 = v[7] * x158 - v[6] * x159;
  const Real x181 = x107 * x152 + x138 * x178;
  const Real x201 = x161 * x162;
  const Real x202 = x201 - x166;
  const Real x184 = x107 * x153 + x141 * x178;
  const Real x204 = x160 * x160 + x161 * x161;
  const Real x187 = x107 * x155 + x144 * x178;
  // joint 6 "right_motor": placement, velocity and reference acceleration of its link
  const Real x220 = x27 + x36 * 0.17;
  const Real x229 = sine[5] * x220 + x32 * cosine[5];
  // joint 7 "right_ball": placement, velocity and reference acceleration of its link
  const Real x273 = x216 * x262;
  const Real x275 = x216 * x268;
  const Real x276 = v[9] + x273;
  const Real x278 = v[11] + x275;
  // link 4 "foot": bias force in the reference field
  const Real x412 = x83 * 0.05;
  // constraint rows of a loop at its two links
  const Real x616 = (x78 + x80) * 0.05;
  const Real x618 = x72 - x616;
  const Real x624 = x620 + x621 - x55;
  const Real x619 = x73 - x412;
  const Real x629 = x600 * x618 + x597 * x624 + x604 * x619;
  // link 2 "shank": accelerations and constraint forces of loops below it are eliminated
  const Real x2490 = x2381 * x2487;
  const Real x2491 = 1.2 * x2487;
  const Real x2493 = x2404 + x2380 * x2487;
  const Real x2508 = sign_of(x2435) * sqrt_of(x2435 * x2435 + x2504 + x2500);
  const Real x2509 = x2435 + x2508;
  const Real x2512 = x2500 + x2504 + x2509 * x2509;
  const Real x2514 = 2.0 * (1 / x2512);
  const Real x2521 = x2436 * x2452 + x2433 * x2449 + x2451 * x2509;
  const Real x2522 = x2514 * x2521;
  const Real x2540 = x2436 * x2462 + x2433 * x2463 - x2465 * x2509;
  const Real x2541 = x2514 * x2540;
  const Real x2560 = x2436 * x2476 + x2433 * x2477 - x2479 * x2509;
  const Real x2561 = x2514 * x2560;
  const Real x2580 = x2436 * x2490 + x2433 * x2491 - x2493 * x2509;
  const Real x2581 = x2514 * x2580;
  // joint 6 "right_motor": placement, velocity and reference acceleration of its link
  const Real x224 = cosine[5] * x220 - x32 * sine[5];
  // joint 7 "right_ball": placement, velocity and reference acceleration of its link
  const Real x274 = x216 * x265;
  const Real x286 = v[9] * x275 - v[11] * x273;
  const Real x293 = 0.06 * x231 - x229;
  const Real x321 = x276 * x278;
  const Real x277 = v[10] + x274;
  const Real x323 = x286 + x321;
  const Real x282 = v[11] * x274 - v[10] * x275;
  const Real x296 = x224 * x269 + x255 * x293;
  const Real x316 = x277 * x278;
  const Real x317 = x316 - x282;
  const Real x299 = x224 * x270 + x258 * x293;
  // constraint rows of a loop at its two links
  const Real x665 = x618 * x655 + x624 * x652 + x619 * x659;
  const Real x701 = x618 * x691 + x624 * x688 + x619 * x695;
  // constraint rows of a loop at its two links
  const Real x795 = x72 + x616;
  const Real x799 = x621 - x620 - x55;
  const Real x796 = x73 + x412;
  const Real x804 = x780 * x795 + x777 * x799 + x784 * x796;
  // link 2 "shank": accelerations and constraint forces of loops below it are eliminated
  const Real x2526 = 1.2 * x2522;
  const Real x2545 = 1.2 * x2541;
  const Real x2565 = 1.2 * x2561;
  const Real x2531 = x2436 * x2522 - x2452;
  const Real x2596 = x2526 * x2526;
  const Real x2532 = x2433 * x2522 - x2449;
  const Real x2552 = x2433 * x2541 - x2463;
  const Real x2551 = x2436 * x2541 - x2462;
  const Real x2572 = x2433 * x2561 - x2477;
  const Real x2571 = x2436 * x2561 - x2476;
  const Real x2597 = x2532 * x2532;
  const Real x2585 = 1.2 * x2581;
  const Real x2592 = x2433 * x2581 - x2491;
  const Real x2591 = x2436 * x2581 - x2490;
  const Real x2767 = (x629 - (x181 - x208 * 0.15)) * 8.0 * (1 / x2417);
  const Real x2754 = (x665 - (x184 - x202 * 0.15)) * 8.0;
  const Real x2775 = 1 / x2508 * (x2754 + (x2383 - x2418 * x2429) * x2767);
  const Real x2601 = sign_of(x2531) * sqrt_of(x2531 * x2531 + x2596 + x2597);
  const Real x2602 = x2531 + x2601;
  const Real x2755 = (x701 - (x187 + x204 * 0.15)) * 16.0;
  // joint 7 "right_ball": placement, velocity and reference acceleration of its link
  const Real x319 = x276 * x276 + x277 * x277;
  const Real x302 = x224 * x272 + x261 * x293;
  // constraint rows of a loop at its two links
  const Real x841 = x795 * x831 + x799 * x828 + x796 * x835;
  const Real x878 = x795 * x868 + x799 * x865 + x796 * x872;
  // joint 7 "right_ball": inertia and bias force of what is beyond; its acceleration is an unknown
  const Real x897 = x262 * 0.00264635;
  const Real x924 = x268 * 2.7e-06;
  const Real x962 = x261 * 0.01725;
  const Real x909 = x265 * 0.00264635;
  const Real x997 = -0.009 - x962;
  const Real x898 = x270 * 0.01725;
  const Real x910 = x269 * 0.01725;
  const Real x995 = x262 * x897 + x268 * x924 + x265 * x909;
  // link 2 "shank": accelerations and constraint forces of loops below it are eliminated
  const Real x2605 = x2596 + x2597 + x2602 * x2602;
  const Real x2783 = x2755 + (x2388 - x2418 * x2445) * x2767;
  const Real x2787 = 1 / x2601 * ((x2451 - x2509 * x2522) * x2775 + x2783);
  const Real x2756 = (x804 - (x296 - x323 * 0.23)) * 4.0;
  const Real x2797 = x2756 + (x2392 - x2418 * x2459) * x2767;
  const Real x2757 = (x841 - (x299 - x317 * 0.23)) * 4.0;
  const Real x2607 = 2.0 * (1 / x2605);
  const Real x2813 = x2757 + (x2397 - x2418 * x2473) * x2767;
  const Real x2758 = (x878 - (x302 + x319 * 0.23)) * 16.0;
  const Real x2612 = x2526 * x2545 + x2532 * x2552 + x2551 * x2602;
  const Real x2613 = x2607 * x2612;
  const Real x2624 = x2526 * x2565 + x2532 * x2572 + x2571 * x2602;
  const Real x2625 = x2607 * x2624;
  const Real x2636 = x2526 * x2585 + x2532 * x2592 + x2591 * x2602;
  const Real x2637 = x2607 * x2636;
  const Real x2832 = x2758 + (x2403 - x2418 * x2487) * x2767;
  const Real x2618 = x2545 - x2526 * x2613;
  const Real x2619 = x2552 - x2532 * x2613;
  const Real x2631 = x2572 - x2532 * x2625;
  const Real x2630 = x2565 - x2526 * x2625;
  const Real x2643 = x2592 - x2532 * x2637;
  const Real x2642 = x2585 - x2526 * x2637;
  const Real x2647 = x2619 * x2619;
  // link 8 "right_rod": bias force in the reference field
  const Real x519 = x296 * 0.15 - x323 * 0.01725;
  const Real x523 = x299 * 0.15 - x317 * 0.01725;
  const Real x508 = (v[10] * x273 - v[9] * x274) * 2.7e-06;
  const Real x512 = x282 * 0.00264635 - x316 * 0.00264365 + x299 * 0.01725;
  const Real x527 = x302 * 0.15 + x319 * 0.01725;
  // constraint rows of a loop at its two links
  const Real x530 = cosine[3] * 0.05;
  // joint 7 "right_ball": inertia and bias force of what is beyond; its acceleration is an unknown
  const Real x906 = x897 + 0.06 * x898;
  const Real x921 = x909 - 0.06 * x910;
  const Real x1053 = x995 - 0.06 * (x997 - x962) + 0.0002466667;
  const Real x899 = x258 * 0.01725;
  const Real x960 = x272 * 0.01725;
  const Real x1054 = 0.006 - x997;
  const Real x912 = x255 * 0.01725;
  // joint 6 "right_motor": inertia and bias force of what is beyond; its acceleration is an unknown
  const Real x1073 = cosine[5] * x960;
  const Real x1098 = sine[5] * x898 + cosine[5] * x899;
  const Real x1075 = sine[5] * x1054 - x1073;
  const Real x1110 = x906 - 0.17 * x1098;
  const Real x1127 = sine[5] * x910 + cosine[5] * x912;
  const Real x1084 = x1053 - 0.17 * x1075;
  const Real x1140 = x921 + 0.17 * x1127;
  // joint 5 "left_ball": inertia and bias force of what is beyond; its acceleration is an unknown
  const Real x1330 = x145 * 0.00112635;
  const Real x1357 = x151 * 2.7e-06;
  const Real x1395 = x144 * 0.01125;
  const Real x1331 = x153 * 0.01125;
  const Real x1342 = x148 * 0.00112635;
  const Real x1343 = x152 * 0.01125;
  const Real x1429 = -0.009 - x1395;
  const Real x1339 = x1330 + 0.06 * x1331;
  const Real x1354 = x1342 - 0.06 * x1343;
  const Real x1332 = x141 * 0.01125;
  const Real x1428 = x145 * x1330 + x151 * x1357 + x148 * x1342;
  const Real x1485 = x1428 - 0.06 * (x1429 - x1395) + 0.0002466667;
  const Real x1393 = x155 * 0.01125;
  const Real x1486 = 0.006 - x1429;
  // joint 4 "left_motor": inertia and bias force of what is beyond; its acceleration is an unknown
  const Real x1528 = sine[4] * x1331 + cosine[4] * x1332;
  // joint 3 "ankle_roll": inertia and bias force of what is beyond; its acceleration is an unknown
  const Real x1769 = sine[3] * 0.002;
  const Real x1968 = 0.00630833 + cosine[3] * (cosine[3] * 0.0019583400000000003) + 2.4e-05;
  // link 2 "shank": accelerations and constraint forces of loops below it are eliminated
  const Real x2799 = (x2465 + x2509 * x2541) * x2775 - x2797;
  const Real x2815 = (x2479 + x2509 * x2561) * x2775 - x2813;
  const Real x2834 = (x2493 + x2509 * x2581) * x2775 - x2832;
  const Real x2654 = sign_of(x2618) * sqrt_of(x2618 * x2618 + x2650 + x2647);
  const Real x2655 = x2618 + x2654;
  const Real x2658 = x2647 + x2650 + x2655 * x2655;
  const Real x2801 = 1 / x2654 * (x2799 - (x2551 - x2602 * x2613) * x2787);
  // joint 3 "ankle_roll": placement, velocity and reference acceleration of its link
  const Real x68 = v[3] * x66;
  const Real x85 = x77 + x80;
  // link 4 "foot": bias force in the reference field
  const Real x385 = x68 * 0.002999997 - x68 * 0.00826667;
  // link 6 "left_rod": bias force in the reference field
  const Real x463 = (v[6] * x157 - v[5] * x158) * 2.7e-06;
  const Real x474 = x181 * 0.15 - x208 * 0.01125;
  const Real x478 = x184 * 0.15 - x202 * 0.01125;
  // link 8 "right_rod": bias force in the reference field
  const Real x515 = x286 * 0.00264635 + x321 * 0.00264365 - x296 * 0.01725;
  // constraint rows of a loop at its two links
  const Real x536 = sine[2] * x531;
  // joint 7 "right_ball": inertia and bias force of what is beyond; its acceleration is an unknown
  const Real x1033 = x269 * x519 + x270 * x523 + x272 * x527;
  // joint 6 "right_motor": inertia and bias force of what is beyond; its acceleration is an unknown
  const Real x1069 = sine[5] * x960;
  const Real x1071 = cosine[5] * x1054 + x1069;
  const Real x1095 = cosine[5] * x898 - sine[5] * x899;
  // joint 5 "left_ball": inertia and bias force of what is beyond; its acceleration is an unknown
  const Real x1345 = x138 * 0.01125;
  // joint 4 "left_motor": inertia and bias force of what is beyond; its acceleration is an unknown
  const Real x1504 = cosine[4] * x1393;
  const Real x1539 = x1339 - 0.25 * x1528;
  const Real x1506 = sine[4] * x1486 - x1504;
  const Real x1556 = sine[4] * x1343 + cosine[4] * x1345;
  // joint 2 "ankle_pitch": inertia and bias force of what is beyond; its acceleration is an unknown
  const Real x1991 = sine[2] * 0.04 + cosine[2] * x530;
  const Real x1995 = x1968 + 0.4 * x1991;
  const Real x2008 = x1769 + 0.4 * x536;
  // link 2 "shank": accelerations and constraint forces of loops below it are eliminated
  const Real x2660 = 2.0 * (1 / x2658);
  const Real x2666 = x2619 * x2631 - x2395 * x2400 + x2630 * x2655;
  const Real x2667 = x2660 * x2666;
  const Real x2682 = x2619 * x2643 - x2395 * x2406 + x2642 * x2655;
  const Real x2683 = x2660 * x2682;
  const Real x2671 = 0.92 * x2667;
  const Real x2687 = 0.92 * x2683;
  const Real x2673 = x2631 - x2619 * x2667;
  const Real x2674 = x2400 + x2395 * x2667;
  const Real x2690 = x2406 + x2395 * x2683;
  const Real x2689 = x2643 - x2619 * x2683;
  const Real x2700 = 0.8464 + x2671 * x2671;
  const Real x2696 = x2674 * x2674;
  const Real x2816 = x2815 - (x2571 - x2602 * x2625) * x2787;
  const Real x2835 = x2834 - (x2591 - x2602 * x2637) * x2787;
  // link 4 "foot": bias force in the reference field
  const Real x405 = 0.002 * (x89 - x85) + x385 + x55 * 0.05;
  const Real x395 = x70 * 0.004958337 - x70 * 0.00630833 + x83 * 0.002;
  // link 6 "left_rod": bias force in the reference field
  const Real x467 = x166 * 0.00112635 - x201 * 0.00112365 + x184 * 0.01125;
  const Real x482 = x187 * 0.15 + x204 * 0.01125;
  const Real x470 = x170 * 0.00112635 + x206 * 0.00112365 - x181 * 0.01125;
  // constraint rows of a loop at its two links
  const Real x532 = cosine[2] * x531;
  // joint 7 "right_ball": inertia and bias force of what is beyond; its acceleration is an unknown
  const Real x1028 = x262 * x512 + x268 * x508 + x265 * x515;
  const Real x892 = x512 - tau[9];
  const Real x1056 = x1028 + 0.06 * x1033 + x224 * 0.006;
  const Real x893 = x515 - tau[10];
  const Real x1051 = -0.006 + x997;
  // joint 6 "right_motor": inertia and bias force of what is beyond; its acceleration is an unknown
  const Real x1122 = sine[5] * x912 - cosine[5] * x910;
  const Real x1060 = x1056 - tau[8];
  const Real x1248 = x1073 + sine[5] * x1051;
  const Real x1266 = -0.059500000000000004 - x1248;
  // joint 5 "left_ball": inertia and bias force of what is beyond; its acceleration is an unknown
  const Real x1327 = x463 - tau[7];
  const Real x1465 = x152 * x474 + x153 * x478 + x155 * x482;
  const Real x1325 = x467 - tau[5];
  const Real x1326 = x470 - tau[6];
  const Real x1460 = x145 * x467 + x151 * x463 + x148 * x470;
  const Real x1483 = -0.006 + x1429;
  const Real x1487 = x1460 + 0.06 * x1465 + x107 * 0.006;
  // joint 4 "left_motor": inertia and bias force of what is beyond; its acceleration is an unknown
  const Real x1514 = x1485 - 0.25 * x1506;
  const Real x1568 = x1354 + 0.25 * x1556;
  const Real x1525 = cosine[4] * x1331 - sine[4] * x1332;
  const Real x1500 = sine[4] * x1393;
  const Real x1502 = cosine[4] * x1486 + x1500;
  const Real x1551 = sine[4] * x1345 - cosine[4] * x1343;
  const Real x1491 = x1487 - tau[4];
  const Real x1677 = x1504 + sine[4] * x1483;
  const Real x1695 = -0.0875 - x1677;
  // joint 3 "ankle_roll": inertia and bias force of what is beyond; its acceleration is an unknown
  const Real x1952 = cosine[3] * (x405 - x73 * 0.04);
  const Real x1955 = x1952 - sine[3] * (x395 + x72 * 0.04);
  const Real x1768 = x83 * 0.0019583400000000003 + x72 * 0.05 - tau[3];
  // joint 2 "ankle_pitch": inertia and bias force of what is beyond; its acceleration is an unknown
  const Real x1986 = sine[2] * x530 - cosine[2] * 0.04;
  const Real x1973 = x1955 - tau[2];
  const Real x2259 = -0.46 - x1991;
  // link 2 "shank": accelerations and constraint forces of loops below it are eliminated
  const Real x2704 = sign_of(x2673) * sqrt_of(x2673 * x2673 + x2700 + x2696);
  const Real x2705 = x2673 + x2704;
  const Real x2708 = x2696 + x2700 + x2705 * x2705;
  const Real x2818 = 1 / x2704 * ((x2630 - x2655 * x2667) * x2801 + x2816);
  const Real x2710 = 2.0 * (1 / x2708);
  const Real x2717 = x2674 * x2690 + x2671 * x2687 + x2689 * x2705;
  const Real x2718 = x2710 * x2717;
  // constraint rows of a loop at its two links
  const Real x541 = x155 * 0.15;
  const Real x547 = -0.06 - x144 * 0.15;
  const Real x533 = sine[2] * 0.06;
  const Real x537 = cosine[2] * 0.06;
  // constraint rows of a loop at its two links
  const Real x721 = x272 * 0.23;
  const Real x727 = -0.06 - x261 * 0.23;
  // joint 7 "right_ball": inertia and bias force of what is beyond; its acceleration is an unknown
  const Real x1057 = x224 * 0.2 + x1033;
  const Real x1038 = x255 * x519 + x258 * x523 + x261 * x527;
  const Real x1058 = x231 * 0.006 - x229 * 0.2 + x1038;
  // joint 6 "right_motor": inertia and bias force of what is beyond; its acceleration is an unknown
  const Real x1309 = sine[5] * x1057 + cosine[5] * x1058;
  // joint 5 "left_ball": inertia and bias force of what is beyond; its acceleration is an unknown
  const Real x1488 = x107 * 0.2 + x1465;
  const Real x1470 = x138 * x474 + x141 * x478 + x144 * x482;
  const Real x1489 = x114 * 0.006 - x112 * 0.2 + x1470;
  // joint 6 "right_motor": inertia and bias force of what is beyond; its acceleration is an unknown
  const Real x1288 = x1053 - 0.17 * (x1266 - x1248);
  // joint 4 "left_motor": inertia and bias force of what is beyond; its acceleration is an unknown
  const Real x1736 = sine[4] * x1488 + cosine[4] * x1489;
  // joint 6 "right_motor": inertia and bias force of what is beyond; its acceleration is an unknown
  const Real x1306 = cosine[5] * x1057 - sine[5] * x1058;
  // joint 3 "ankle_roll": inertia and bias force of what is beyond; its acceleration is an unknown
  const Real x1964 = cosine[3] * (x73 + x85 * 0.05);
  const Real x1970 = sine[3] * (x72 + x412) + x1964 + x50 * 0.15;
  // link 4 "foot": bias force in the reference field
  const Real x423 = 2.0 * x68 * 0.05 - x89 * 0.04 - x55;
  // joint 3 "ankle_roll": inertia and bias force of what is beyond; its acceleration is an unknown
  const Real x1971 = x423 - x55 * 0.15;
  // joint 4 "left_motor": inertia and bias force of what is beyond; its acceleration is an unknown
  const Real x1758 = x1485 - 0.25 * (x1695 - x1677) + x1288;
  // joint 2 "ankle_pitch": inertia and bias force of what is beyond; its acceleration is an unknown
  const Real x2287 = sine[2] * x1970 + cosine[2] * x1971;
  // joint 4 "left_motor": inertia and bias force of what is beyond; its acceleration is an unknown
  const Real x1753 = cosine[5] * x1051 - x1069 + (cosine[4] * x1483 - x1500);
  const Real x1764 = cosine[4] * x1488 - sine[4] * x1489 + x1306;
  const Real x1763 = x1056 - 0.17 * x1309 + (x1487 - 0.25 * x1736);
  // link 2 "shank": accelerations and constraint forces of loops below it are eliminated
  const Real x2722 = 0.92 * x2718;
  const Real x2727 = x2674 * x2718 - x2690;
  const Real x2728 = x2671 * x2718 - x2687;
  const Real x2836 = (x2642 - x2655 * x2683) * x2801 + x2835;
  const Real x2734 = x2727 * x2727 + x2722 * x2722 + x2728 * x2728;
  const Real x2735 = sqrt_of(x2734);
  const Real x2736 = x2735 * x2735;
  require_more(w, x2736, 9.999999999999998e-15, kLoopSingular, 9);
  const Real x2737 = x2734 + x2736;
  // constraint rows of a loop at its two links
  const Real x561 = x536 - x537 - (cosine[4] * x547 - sine[4] * x541);
  const Real x562 = x530 - (0.05 - x151 * 0.15);
  // link 2 "shank": accelerations and constraint forces of loops below it are eliminated
  const Real x2838 = 1 / x2735 * ((x2689 - x2705 * x2718) * x2818 + x2836);
  const Real x2739 = 2.0 * (1 / x2737);
  const Real x2840 = x2727 * x2739;
  const Real x2849 = x2722 * x2739;
  const Real x2858 = x2728 * x2739;
  const Real x2869 = x2739 * (x2735 * x2838);
  const Real x2843 = x2722 * x2840;
  const Real x2844 = x2728 * x2840;
  const Real x2851 = x2727 * x2849;
  const Real x2853 = x2728 * x2849;
  const Real x2860 = x2727 * x2858;
  const Real x2861 = x2722 * x2858;
  const Real x2846 = 1.0 - x2727 * x2840;
  const Real x2856 = 1.0 - x2722 * x2849;
  const Real x2866 = 1.0 - x2728 * x2858;
  const Real x2873 = x2727 * x2869;
  const Real x2875 = x2722 * x2869;
  const Real x2877 = x2728 * x2869;
  const Real x2841 = x2735 * x2840;
  const Real x2850 = x2735 * x2849;
  const Real x2859 = x2735 * x2858;
  const Real x3278 = x1357 * x2841;
  const Real x2887 = 0.92 * x2843 + x2671 * x2844 - x2674 * x2846;
  const Real x2888 = x2710 * x2887;
  const Real x3286 = x1357 * x2850;
  const Real x2907 = x2674 * x2851 + x2671 * x2853 - 0.92 * x2856;
  const Real x2908 = x2710 * x2907;
  const Real x3294 = x1357 * x2859;
  const Real x2927 = x2674 * x2860 + 0.92 * x2861 - x2671 * x2866;
  const Real x2928 = x2710 * x2927;
  const Real x2889 = x2705 * x2888;
  const Real x2909 = x2705 * x2908;
  const Real x2929 = x2705 * x2928;
  const Real x2897 = x2846 + x2674 * x2888;
  const Real x2899 = x2671 * x2888 - x2844;
  const Real x2917 = x2674 * x2908 - x2851;
  const Real x2919 = x2671 * x2908 - x2853;
  const Real x2937 = x2674 * x2928 - x2860;
  const Real x2939 = x2866 + x2671 * x2928;
  const Real x2950 = x2705 * x2818 + x2674 * x2873 + 0.92 * x2875;
  const Real x2898 = 0.92 * x2888 - x2843;
  const Real x2954 = x2710 * (x2671 * x2877 + x2950);
  const Real x2918 = x2856 + 0.92 * x2908;
  const Real x2973 = x2395 * x2897 - x2619 * x2889 + 0.92 * x2899;
  const Real x2974 = x2660 * x2973;
  const Real x2938 = 0.92 * x2928 - x2861;
  const Real x2989 = x2395 * x2917 - x2619 * x2909 + 0.92 * x2919;
  const Real x2990 = x2660 * x2989;
  const Real x2964 = x2705 * x2954 - x2818;
  const Real x2965 = x2873 - x2674 * x2954;
  const Real x3005 = x2395 * x2937 - x2619 * x2929 + 0.92 * x2939;
  const Real x3006 = x2660 * x3005;
  const Real x2967 = x2877 - x2671 * x2954;
  const Real x2975 = x2655 * x2974;
  const Real x2991 = x2655 * x2990;
  const Real x3007 = x2655 * x3006;
  const Real x2980 = x2889 + x2619 * x2974;
  const Real x2982 = x2897 - x2395 * x2974;
  const Real x2996 = x2909 + x2619 * x2990;
  const Real x2983 = x2899 - 0.92 * x2974;
  const Real x3012 = x2929 + x2619 * x3006;
  const Real x2998 = x2917 - x2395 * x2990;
  const Real x2999 = x2919 - 0.92 * x2990;
  const Real x3346 = x906 * x2982 + 0.00264635 * x2898;
  const Real x3355 = x921 * x2982 + 0.00264635 * x2983;
  const Real x3040 = x2607 * (x2526 * x2975 + x2532 * x2980);
  const Real x3333 = x1053 * x2982 + x906 * x2898 + x921 * x2983;
  const Real x3056 = x2607 * (x2526 * x2991 + x2532 * x2996);
  const Real x3072 = x2607 * (x2526 * x3007 + x2532 * x3012);
  const Real x3042 = x2602 * x3040;
  const Real x3058 = x2602 * x3056;
  const Real x3074 = x2602 * x3072;
  const Real x3048 = x2526 * x3040 - x2975;
  const Real x3049 = x2532 * x3040 - x2980;
  const Real x3064 = x2526 * x3056 - x2991;
  const Real x3065 = x2532 * x3056 - x2996;
  const Real x3080 = x2526 * x3072 - x3007;
  const Real x3081 = x2532 * x3072 - x3012;
  const Real x3349 = x906 * x2998 + 0.00264635 * x2918;
  const Real x3358 = x921 * x2998 + 0.00264635 * x2999;
  const Real x3338 = x1053 * x2998 + x906 * x2918 + x921 * x2999;
  const Real x3104 = x2436 * x3042 + 1.2 * x3048 + x2433 * x3049;
  const Real x3106 = x2514 * x3104;
  const Real x3022 = x2619 * x2964 - x2655 * x2801 + x2395 * x2965;
  const Real x3127 = x2436 * x3058 + 1.2 * x3064 + x2433 * x3065;
  const Real x3129 = x2514 * x3127;
  const Real x3014 = x2937 - x2395 * x3006;
  const Real x3150 = x2436 * x3074 + 1.2 * x3080 + x2433 * x3081;
  const Real x3152 = x2514 * x3150;
  const Real x3108 = x2509 * x3106;
  const Real x3131 = x2509 * x3129;
  const Real x3154 = x2509 * x3152;
  const Real x3116 = x3042 - x2436 * x3106;
  const Real x3118 = x3049 - x2433 * x3106;
  const Real x3139 = x3058 - x2436 * x3129;
  const Real x3141 = x3065 - x2433 * x3129;
  const Real x3117 = x3048 - 1.2 * x3106;
  const Real x3162 = x3074 - x2436 * x3152;
  const Real x3164 = x3081 - x2433 * x3152;
  const Real x3015 = x2939 - 0.92 * x3006;
  const Real x3140 = x3064 - 1.2 * x3129;
  const Real x3024 = x2660 * (0.92 * x2967 + x3022);
  const Real x3191 = x2380 * x3108 + x2381 * x3116 + 1.2 * x3118;
  const Real x3192 = x2422 * x3191;
  const Real x3205 = x2380 * x3131 + x2381 * x3139 + 1.2 * x3141;
  const Real x3206 = x2422 * x3205;
  const Real x3219 = x2380 * x3154 + x2381 * x3162 + 1.2 * x3164;
  const Real x3220 = x2422 * x3219;
  const Real x3193 = x2418 * x3192;
  const Real x3207 = x2418 * x3206;
  const Real x3198 = x3108 - x2380 * x3192;
  const Real x3199 = x3116 - x2381 * x3192;
  const Real x3200 = x3118 - 1.2 * x3192;
  const Real x3212 = x3131 - x2380 * x3206;
  const Real x3213 = x3139 - x2381 * x3206;
  const Real x3249 = x1968 * x3193 + x1769 * x3198;
  const Real x3266 = x1769 * x3193 + 0.003308333 * x3198;
  const Real x3301 = x1339 * x3199 + 0.00112635 * x3117;
  const Real x3310 = x1354 * x3199 + 0.00112635 * x3200;
  const Real x3255 = x1968 * x3207 + x1769 * x3212;
  const Real x3320 = x1357 * x3199 - 2.7e-06 * x2841;
  const Real x3214 = x3141 - 1.2 * x3206;
  const Real x3270 = x1769 * x3207 + 0.003308333 * x3212;
  const Real x3281 = x1339 * x3117 - x3278 + x1485 * x3199;
  const Real x3282 = x1354 * x3200 + x3281;
  const Real x3595 = x2898 * x3346 + x2983 * x3355 + x2982 * x3333;
  const Real x3304 = x1339 * x3213 + 0.00112635 * x3140;
  const Real x3614 = x2898 * x3349 + x2983 * x3358 + x2982 * x3338;
  const Real x3029 = x2801 + x2655 * x3024;
  const Real x3221 = x2418 * x3220;
  const Real x3226 = x3154 - x2380 * x3220;
  const Real x3352 = x906 * x3014 + 0.00264635 * x2938;
  const Real x3361 = x921 * x3014 + 0.00264635 * x3015;
  const Real x3597 = x3193 * x3249 + x3595 + x3198 * x3266;
  const Real x3313 = x1354 * x3213 + 0.00112635 * x3214;
  const Real x3031 = x2964 - x2619 * x3024;
  const Real x3343 = x1053 * x3014 + x906 * x2938 + x921 * x3015;
  const Real x3599 = x3117 * x3301 + x3597 + x3200 * x3310;
  const Real x3324 = x1357 * x3213 - 2.7e-06 * x2850;
  const Real x3616 = x3193 * x3255 + x3614 + x3198 * x3270;
  const Real x3671 = x2918 * x3349 + x2999 * x3358 + x2998 * x3338;
  const Real x3601 = x3599 - x2841 * x3320 + x3199 * x3282;
  const Real x3163 = x3080 - 1.2 * x3152;
  const Real x3227 = x3162 - x2381 * x3220;
  const Real x3261 = x1968 * x3221 + x1769 * x3226;
  const Real x4141 = 1 / x3601;
  const Real x3289 = x1339 * x3140 - x3286 + x1485 * x3213;
  const Real x3290 = x1354 * x3214 + x3289;
  const Real x3228 = x3164 - 1.2 * x3220;
  const Real x3274 = x1769 * x3221 + 0.003308333 * x3226;
  const Real x3618 = x3117 * x3304 + x3616 + x3200 * x3313;
  const Real x3673 = x3207 * x3255 + x3671 + x3212 * x3270;
  const Real x3087 = x2602 * x2787 - x2526 * x3029 + x2532 * x3031;
  const Real x3088 = x2607 * x3087;
  const Real x3307 = x1339 * x3227 + 0.00112635 * x3163;
  const Real x3633 = x2898 * x3352 + x2983 * x3361 + x2982 * x3343;
  const Real x3620 = x3618 - x2841 * x3324 + x3199 * x3290;
  const Real x3316 = x1354 * x3227 + 0.00112635 * x3228;
  const Real x3690 = x2918 * x3352 + x2999 * x3361 + x2998 * x3343;
  const Real x3675 = x3140 * x3304 + x3673 + x3214 * x3313;
  const Real x4142 = x3620 * x4141;
  const Real x3092 = x2787 - x2602 * x3088;
  const Real x3328 = x1357 * x3227 - 2.7e-06 * x2859;
  const Real x3635 = x3193 * x3261 + x3633 + x3198 * x3274;
  const Real x3677 = x3675 - x2850 * x3324 + x3213 * x3290;
  const Real x3093 = x3029 + x2526 * x3088;
  const Real x3297 = x1339 * x3163 - x3294 + x1485 * x3227;
  const Real x3298 = x1354 * x3228 + x3297;
  const Real x3692 = x3207 * x3261 + x3690 + x3212 * x3274;
  const Real x3747 = x2938 * x3352 + x3015 * x3361 + x3014 * x3343;
  const Real x4147 = x3677 - x3620 * x4142;
  const Real x3095 = x3031 - x2532 * x3088;
  const Real x3637 = x3117 * x3307 + x3635 + x3200 * x3316;
  const Real x4154 = 1 / x4147;
  const Real x3639 = x3637 - x2841 * x3328 + x3199 * x3298;
  const Real x3694 = x3140 * x3307 + x3692 + x3214 * x3316;
  const Real x3749 = x3221 * x3261 + x3747 + x3226 * x3274;
  const Real x3173 = x2509 * x2775 - x2436 * x3092 + 1.2 * x3093;
  const Real x4143 = x3639 * x4141;
  const Real x3175 = x2514 * (x3173 - x2433 * x3095);
  const Real x3696 = x3694 - x2850 * x3328 + x3213 * x3298;
  const Real x4150 = x3696 - x3639 * x4142;
  const Real x3751 = x3163 * x3307 + x3749 + x3228 * x3316;
  const Real x3963 = x1110 * x2898 - x3278 + x1084 * x2982;
  const Real x4155 = x4150 * x4154;
  const Real x3753 = x3751 - x2859 * x3328 + x3227 * x3298;
  const Real x3362 = x924 * x2982;
  const Real x3183 = x2775 - x2509 * x3175;
  const Real x3184 = x3092 + x2436 * x3175;
  const Real x3981 = x1110 * x2918 - x3286 + x1084 * x2998;
  const Real x4162 = x3753 - x3639 * x4143 - x4150 * x4155;
  const Real x3186 = x3095 + x2433 * x3175;
  const Real x3965 = x1140 * x2983 + x3963 + x1539 * x3117;
  const Real x3999 = x1110 * x2938 - x3294 + x1084 * x3014;
  const Real x4169 = 1 / x4162;
  const Real x4153 = x924 * x2998 - x3362 * x4142;
  const Real x2966 = x2875 - 0.92 * x2954;
  const Real x3033 = x2967 - 0.92 * x3024;
  const Real x3983 = x1140 * x2999 + x3981 + x1539 * x3140;
  const Real x4144 = x3362 * x4141;
  const Real x3032 = x2965 - x2395 * x3024;
  const Real x3234 = x2418 * x2767 + x2380 * x3183 + x2381 * x3184;
  const Real x3967 = x3965 - x1995 * x3193 - x2008 * x3198;
  const Real x4001 = x1140 * x3015 + x3999 + x1539 * x3163;
  const Real x4066 = x1075 * x2982 + x1098 * x2898 - x1127 * x2983;
  const Real x4156 = x4153 * x4154;
  const Real x4168 = x924 * x3014 - x3362 * x4143 - x4153 * x4155;
  const Real x3185 = 1.2 * x3175 - x3093;
  const Real x3236 = x2422 * (1.2 * x3186 + x3234);
  const Real x3969 = x1514 * x3199 + x3967 + x1568 * x3200;
  const Real x3985 = x3983 - x1995 * x3207 - x2008 * x3212;
  const Real x4016 = x1071 * x2982 + x1095 * x2898 + x1122 * x2983;
  const Real x4084 = x1075 * x2998 + x1098 * x2918 - x1127 * x2999;
  const Real x4170 = x4168 * x4169;
  const Real x2879 = x2735 * x2869 - x2838;
  const Real x3987 = x1514 * x3213 + x3985 + x1568 * x3214;
  const Real x4003 = x4001 - x1995 * x3221 - x2008 * x3226;
  const Real x4032 = x1071 * x2998 + x1095 * x2918 + x1122 * x2999;
  const Real x4068 = x1528 * x3117 + x4066 + x1991 * x3193;
  const Real x4102 = x1075 * x3014 + x1098 * x2938 - x1127 * x3015;
  const Real x3241 = x2767 - x2418 * x3236;
  const Real x3377 = x892 * x2898 - x1327 * x2841 + x1060 * x2982;
  const Real x3433 = x2966 * x3346 + x3033 * x3355 + x3032 * x3333;
  const Real x4005 = x1514 * x3227 + x4003 + x1568 * x3228;
  const Real x4201 = x3987 - x3969 * x4142;
  const Real x4018 = x1525 * x3117 + x4016 - x1986 * x3193;
  const Real x4048 = x1071 * x3014 + x1095 * x2938 + x1122 * x3015;
  const Real x4086 = x1528 * x3140 + x4084 + x1991 * x3207;
  const Real x4178 = 2.7e-06 - x3362 * x4144 - x4153 * x4156;
  const Real x4179 = x4178 - x4168 * x4170;
  require_more(w, x4179, 4.796163466380676e-21, kLoopFree, 5);
  require_more(w, x4179, 2.7000000000000002e-14, kLoopSingular, 5);
  const Real x3242 = x3183 - x2380 * x3236;
  const Real x3396 = x892 * x2918 - x1327 * x2850 + x1060 * x2998;
  const Real x3451 = x2966 * x3349 + x3033 * x3358 + x3032 * x3338;
  const Real x4034 = x1525 * x3140 + x4032 - x1986 * x3207;
  const Real x4070 = x536 * x3198 + x4068 + x1506 * x3199;
  const Real x4071 = x4070 - x1556 * x3200;
  const Real x4104 = x1528 * x3163 + x4102 + x1991 * x3221;
  const Real x4180 = 1 / x4179;
  const Real x3243 = x3184 - x2381 * x3236;
  const Real x3379 = x893 * x2983 + x3377 + x1325 * x3117;
  const Real x3415 = x892 * x2938 - x1327 * x2859 + x1060 * x3014;
  const Real x3435 = x3185 * x3301 + x3433 + x2879 * x3320;
  const Real x3469 = x2966 * x3352 + x3033 * x3361 + x3032 * x3343;
  const Real x4231 = x4005 - x3969 * x4143 - x4155 * x4201;
  const Real x4020 = x532 * x3198 + x4018 + x1502 * x3199;
  const Real x4021 = x1551 * x3200 + x4020;
  const Real x4050 = x1525 * x3163 + x4048 - x1986 * x3221;
  const Real x4088 = x536 * x3212 + x4086 + x1506 * x3213;
  const Real x4089 = x4088 - x1556 * x3214;
  const Real x3244 = x3186 - 1.2 * x3236;
  const Real x3398 = x893 * x2999 + x3396 + x1325 * x3140;
  const Real x3453 = x3185 * x3304 + x3451 + x2879 * x3324;
  const Real x4036 = x532 * x3212 + x4034 + x1502 * x3213;
  const Real x4037 = x1551 * x3214 + x4036;
  const Real x4106 = x536 * x3226 + x4104 + x1506 * x3227;
  const Real x4107 = x4106 - x1556 * x3228;
  const Real x4207 = x4089 - x4071 * x4142;
  const Real x3381 = x3379 - x1973 * x3193 + x1768 * x3198;
  const Real x3417 = x893 * x3015 + x3415 + x1325 * x3163;
  const Real x3437 = x3435 - x3241 * x3249 + x3242 * x3266;
  const Real x3471 = x3185 * x3307 + x3469 + x2879 * x3328;
  const Real x4281 = x924 - x3969 * x4144 - x4156 * x4201;
  const Real x4052 = x532 * x3226 + x4050 + x1502 * x3227;
  const Real x4053 = x1551 * x3228 + x4052;
  const Real x4204 = x4037 - x4021 * x4142;
  const Real x3400 = x3398 - x1973 * x3207 + x1768 * x3212;
  const Real x3455 = x3453 - x3241 * x3255 + x3242 * x3270;
  const Real x4345 = x4180 * (x4281 - x4170 * x4231);
  const Real x4243 = x4107 - x4071 * x4143 - x4155 * x4207;
  const Real x3419 = x3417 - x1973 * x3221 + x1768 * x3226;
  const Real x3473 = x3471 - x3241 * x3261 + x3242 * x3274;
  const Real x3383 = x1491 * x3199 + x3381 + x1326 * x3200;
  const Real x3477 = x3243 * x3282 + x3437 + x3244 * x3310 + x3383;
  const Real x4237 = x4053 - x4021 * x4143 - x4155 * x4204;
  const Real x3402 = x1491 * x3213 + x3400 + x1326 * x3214;
  const Real x4361 = x4169 * x4231 - x4170 * x4345;
  const Real x3421 = x1491 * x3227 + x3419 + x1326 * x3228;
  const Real x3478 = x3243 * x3290 + x3455 + x3244 * x3313 + x3402;
  const Real x4213 = x3478 - x3477 * x4142;
  const Real x4301 = x4071 * x4144 + x4156 * x4207 + x4170 * x4243;
  const Real x4348 = x4180 * x4301;
  const Real x3479 = x3243 * x3298 + x3473 + x3244 * x3316 + x3421;
  const Real x4391 = x4154 * x4201 - x4156 * x4345 - x4155 * x4361;
  const Real x4291 = x4021 * x4144 + x4156 * x4204 + x4170 * x4237;
  const Real x4346 = x4180 * x4291;
  const Real x4255 = x3479 - x3477 * x4143 - x4155 * x4213;
  const Real x4367 = x4169 * x4243 + x4170 * x4348;
  const Real x4319 = x508 - tau[11] + x924 * x3032 - x3477 * x4144;
  const Real x4441 = x3969 * x4141 - x4144 * x4345 - x4143 * x4361;
  const Real x4442 = x4441 - x4142 * x4391;
  const Real x4364 = x4169 * x4237 + x4170 * x4346;
  const Real x4403 = x4154 * x4207 + x4156 * x4348 - x4155 * x4367;
  const Real x4352 = x4180 * (x4319 - x4156 * x4213 - x4170 * x4255);
  const Real x4603 = x4005 * x4361 + x924 * x4345 + x3987 * x4391;
  const Real x4397 = x4154 * x4204 + x4156 * x4346 - x4155 * x4364;
  // joint 2 "ankle_pitch": inertia and bias force of what is beyond; its acceleration is an unknown
  const Real x2304 = x1968 - 0.4 * (x2259 - x1991) + x1758;
  // link 2 "shank": accelerations and constraint forces of loops below it are eliminated
  const Real x4459 = x4071 * x4141 + x4144 * x4348 - x4143 * x4367;
  const Real x4460 = x4459 - x4142 * x4403;
  const Real x3526 = x1357 * x2879 + x1110 * x2966 + x1084 * x3032;
  const Real x4373 = x4169 * x4255 - x4170 * x4352;
  const Real x4738 = x2304 - (x3969 * x4442 + x4603) + 0.18885420000000003;
  require_more(w, x4738, 0.0, kFactorization, 1);
  const Real x4450 = x4021 * x4141 + x4144 * x4346 - x4143 * x4364;
  const Real x4451 = x4450 - x4142 * x4397;
  const Real x4621 = x4005 * x4367 - x924 * x4348 + x3987 * x4403;
  const Real x3528 = x1140 * x3033 + x3526 + x1539 * x3185;
  const Real x4415 = x4154 * x4213 - x4156 * x4352 - x4155 * x4373;
  const Real x4612 = x4005 * x4364 - x924 * x4346 + x3987 * x4397;
  const Real x4681 = x1753 - x1986 + (x3969 * x4451 + x4612);
  const Real x4683 = x1266 + x1695 + x2259 - (x3969 * x4460 + x4621);
  const Real x4739 = -0.7000000000000001 + x4683;
  const Real x3530 = x1995 * x3241 + x3528 - x2008 * x3242;
  const Real x3542 = x1071 * x3032 + x1095 * x2966 + x1122 * x3033;
  const Real x3560 = x1075 * x3032 + x1098 * x2966 - x1127 * x3033;
  const Real x4477 = x3477 * x4141 - x4144 * x4352 - x4143 * x4373;
  const Real x4478 = x4477 - x4142 * x4415;
  const Real x4637 = x4037 * x4397 + x4053 * x4364 + x4021 * x4451;
  const Real x4655 = x4089 * x4403 + x4107 * x4367 + x4071 * x4460;
  // joint 1 "knee": articulated-body inertia and bias force through it
  const Real x4747 = 1 / x4738;
  const Real x4752 = x4681 * x4747;
  const Real x4754 = x4739 * x4747;
  // link 2 "shank": accelerations and constraint forces of loops below it are eliminated
  const Real x3544 = x1525 * x3185 + x3542 + x1986 * x3241;
  const Real x3562 = x1528 * x3185 + x3560 - x1991 * x3241;
  const Real x3532 = x1514 * x3243 + x3530 + x1568 * x3244;
  const Real x4706 = x4005 * x4373 + x924 * x4352 + x3987 * x4415;
  const Real x3579 = x1955 - 0.4 * x2287 + x1763 + x3532;
  const Real x3546 = x532 * x3242 + x3544 + x1502 * x3243;
  const Real x3564 = x536 * x3242 + x3562 + x1506 * x3243;
  // joint 2 "ankle_pitch": inertia and bias force of what is beyond; its acceleration is an unknown
  const Real x2310 = cosine[2] * x1970 - sine[2] * x1971 + x1764;
  // link 2 "shank": accelerations and constraint forces of loops below it are eliminated
  const Real x4712 = x4037 * x4415 + x4053 * x4373 + x4021 * x4478;
  const Real x3581 = x1309 + x1736 + x2287 + (x3564 - x1556 * x3244);
  const Real x4717 = x4089 * x4415 + x4107 * x4373 + x4071 * x4478;
  const Real x4732 = x1551 * x3244 + x3546 + x2310 - x4712;
  const Real x3813 = 2.7e-06 * (x2850 * x2850) + 0.00264635 * (x2918 * x2918);
  const Real x3830 = 2.7e-06 * (x2859 * x2859) + 0.00264635 * (x2938 * x2938);
  const Real x3796 = 2.7e-06 * (x2841 * x2841) + 0.00264635 * (x2898 * x2898);
  const Real x3814 = x1053 * (x2998 * x2998) + x3813;
  // joint 1 "knee": articulated-body inertia and bias force through it
  const Real x4788 = 1.85 - x4637 + 3.5 - x4681 * x4752;
  // link 2 "shank": accelerations and constraint forces of loops below it are eliminated
  const Real x4643 = x4037 * x4403 + x4053 * x4367 + x4021 * x4460;
  // joint 1 "knee": articulated-body inertia and bias force through it
  const Real x4860 = x4788 - (1.85 - x4655 + 3.5 - x4739 * x4754);
  // link 2 "shank": accelerations and constraint forces of loops below it are eliminated
  const Real x4743 = x3579 - (x3969 * x4478 + x4706) + x32 * 0.7000000000000001;
  // joint 1 "knee": articulated-body inertia and bias force through it
  const Real x4862 = (x4681 * x4754 - x4643) * (sine[1] * 2.0);
  const Real x4749 = x4747 * (tau[1] - x4743);
  // link 2 "shank": accelerations and constraint forces of loops below it are eliminated
  const Real x4744 = x27 * 3.5 + x36 * 0.7000000000000001 + x4732;
  // joint 1 "knee": articulated-body inertia and bias force through it
  const Real x4813 = x3581 - x4717 - x32 * 3.5 + x4739 * x4749;
  const Real x4879 = 0.4 * (x4788 - cosine[1] * (cosine[1] * x4860 - x4862));
  const Real x4922 = 0.32735000000000003 + 0.4 * x4879;
  require_more(w, x4922, 0.0, kFactorization, 0);
  // constraint rows of a loop at its two links
  const Real x558 = -0.25 - (cosine[4] * x541 + sine[4] * x547);
  const Real x560 = x532 + x533 + -0.4 - x558;
  const Real x580 = v[7] * v[7] + x574 + x572 + x80 + 1.0;
  const Real x567 = x561 * x561 + x562 * x562 + x560 * x560;
  const Real x579 = 1e-08 - x567;
  require_more(w, x579, 0.0, kLoopOpen, 8);
  // constraint rows of a loop at its two links
  const Real x741 = x536 + x537 + (cosine[5] * x727 - sine[5] * x721);
  const Real x743 = -0.05 - x268 * 0.23 + x530;
  const Real x738 = -0.17 - (cosine[5] * x721 + sine[5] * x727);
  const Real x740 = x533 - x532 + -0.4 - x738;
  const Real x762 = v[11] * v[11] + x757 + x572 + x80 + 1.0;
  const Real x751 = x741 * x741 + x743 * x743 + x740 * x740;
  const Real x761 = 1e-08 - x751;
  require_more(w, x761, 0.0, kLoopOpen, 9);
  // link 2 "shank": accelerations and constraint forces of loops below it are eliminated
  const Real x3831 = x1053 * (x3014 * x3014) + x3830;
  const Real x3797 = x1053 * (x2982 * x2982) + x3796;
  const Real x3815 = 0.00264635 * (x2999 * x2999) + x3814;
  const Real x3832 = 0.00264635 * (x3015 * x3015) + x3831;
  const Real x3798 = 0.00264635 * (x2983 * x2983) + x3797;
  const Real x3816 = 0.00112635 * (x3140 * x3140) + x3815;
  const Real x3833 = 0.00112635 * (x3163 * x3163) + x3832;
  const Real x2318 = v[6] * 0.15 + v[4] * x1369 + v[3] * x637;
  const Real x2319 = v[2] * x1798 + x2318;
  const Real x2328 = v[3] * x673 - (v[5] * 0.15 + v[4] * x1384);
  const Real x2329 = v[2] * x1825 + x2328;
  const Real x2348 = v[10] * 0.23 + v[8] * x936 - v[3] * x812;
  const Real x2349 = v[2] * x1881 + x2348;
  const Real x2359 = v[9] * 0.23 + v[8] * x951 + v[3] * x849;
  const Real x2361 = v[2] * x1910 - x2359;
  const Real x3799 = 0.00112635 * (x3117 * x3117) + x3798;
  const Real x3817 = x1968 * (x3207 * x3207) + x3816;
  const Real x3834 = x1968 * (x3221 * x3221) + x3833;
  const Real x2335 = v[3] * x709 - v[4] * x1391 + v[2] * x1852;
  const Real x2369 = v[2] * x1939 - (v[8] * x958 + v[3] * x886);
  const Real x3800 = x1968 * (x3193 * x3193) + x3799;
  const Real x3818 = 0.003308333 * (x3212 * x3212) + x3817;
  const Real x3835 = 0.003308333 * (x3226 * x3226) + x3834;
  const Real x3801 = 0.003308333 * (x3198 * x3198) + x3800;
  const Real x3819 = x1485 * (x3213 * x3213) + x3818;
  const Real x3836 = x1485 * (x3227 * x3227) + x3835;
  const Real x3802 = x1485 * (x3199 * x3199) + x3801;
  const Real x3803 = 0.00112635 * (x3200 * x3200) + x3802;
  const Real x4185 = 0.00112635 * (x3214 * x3214) + x3819 + x3677;
  const Real x4188 = 0.00112635 * (x3228 * x3228) + x3836 + x3753;
  const Real x2741 = x2417 * x2417;
  require_more(w, x2741, 9.999999999999998e-15, kLoopSingular, 8);
  const Real x2340 = x2319 * x2319 + x2329 * x2329 + x2335 * x2335;
  const Real x2341 = x580 * 1.0000000000000002e-06 - x2340;
  require_more(w, x2341, 0.0, kLoopTorn, 8);
  const Real x2374 = x2349 * x2349 + x2361 * x2361 + x2369 * x2369;
  const Real x2375 = 1.0000000000000002e-06 * x762 - x2374;
  require_more(w, x2375, 0.0, kLoopTorn, 9);
  const Real x2743 = x2508 * x2508;
  require_more(w, x2743, 9.999999999999998e-15, kLoopSingular, 8);
  const Real x2745 = x2601 * x2601;
  require_more(w, x2745, 9.999999999999998e-15, kLoopSingular, 8);
  const Real x2747 = x2654 * x2654;
  require_more(w, x2747, 9.999999999999998e-15, kLoopSingular, 9);
  const Real x2749 = x2704 * x2704;
  require_more(w, x2749, 9.999999999999998e-15, kLoopSingular, 9);
  const Real x4182 = x3803 * 1.7763568394002505e-15;
  require_more(w, x3601, x4182, kLoopFree, 2);
  const Real x4184 = x3803 * 1e-08;
  require_more(w, x3601, x4184, kLoopSingular, 2);
  // joint 1 "knee": articulated-body inertia and bias force through it
  const Real x4912 = sine[1] * (x4744 - x4681 * x4749) + cosine[1] * x4813;
  // joint 0 "hip": articulated-body inertia and bias force through it
  const Real x4932 = tau[0] - (tau[1] - 0.4 * x4912 + x9 * 1.2000000000000002);
  const Real x4933 = 1 / x4922 * x4932;
  w.result[0] = x4933;
  // joint 1 "knee": its acceleration, and that of the link beyond
  const Real x4943 = 0.4 * x4933;
  const Real x4945 = sine[1] * x4943;
  const Real x4947 = cosine[1] * x4943;
  // link 2 "shank": accelerations and constraint forces of loops below it are eliminated
  const Real x4186 = 1.7763568394002505e-15 * x4185;
  require_more(w, x4147, x4186, kLoopFree, 3);
  const Real x4187 = 1e-08 * x4185;
  require_more(w, x4147, x4187, kLoopSingular, 3);
  const Real x4189 = 1.7763568394002505e-15 * x4188;
  require_more(w, x4162, x4189, kLoopFree, 4);
  const Real x4190 = 1e-08 * x4188;
  require_more(w, x4162, x4190, kLoopSingular, 4);
  // joint 1 "knee": its acceleration, and that of the link beyond
  const Real x4954 = x4749 - x4752 * x4945 + x4754 * x4947;
  const Real x4955 = x4954 - x4933;
  w.result[1] = x4955;
  // link 2 "shank": accelerations and constraint forces of loops below it
  const Real x4963 = x4451 * x4945 + x4460 * x4947 - x4442 * x4954;
  const Real x4990 = x4963 - x4478;
  const Real x4971 = x4397 * x4945 + x4403 * x4947 - x4391 * x4954;
  const Real x4991 = x4971 - x4415;
  const Real x4979 = x4364 * x4945 + x4367 * x4947 - x4361 * x4954;
  const Real x4992 = x4979 - x4373;
  const Real x4988 = x4346 * x4945 + x4348 * x4947 + x4345 * x4954;
  const Real x5003 = x3193 * x4990 + x3207 * x4991 + x3221 * x4992;
  const Real x5050 = x3241 - x5003;
  w.result[2] = x5050;
  const Real x5009 = x3198 * x4990 + x3212 * x4991 + x3226 * x4992;
  const Real x5051 = x3242 + x5009;
  w.result[3] = x5051;
  const Real x5014 = x3199 * x4990 + x3213 * x4991 + x3227 * x4992;
  const Real x5052 = x3243 + x5014;
  w.result[4] = x5052;
  const Real x5019 = x3117 * x4990 + x3140 * x4991 + x3163 * x4992;
  const Real x5053 = x3185 + x5019;
  w.result[5] = x5053;
  const Real x5024 = x3200 * x4990 + x3214 * x4991 + x3228 * x4992;
  const Real x5054 = x3244 + x5024;
  w.result[6] = x5054;
  const Real x5033 = x2841 * x4990 + x2850 * x4991 + x2859 * x4992;
  const Real x5055 = x2879 - x5033;
  w.result[7] = x5055;
  const Real x5039 = x2982 * x4990 + x2998 * x4991 + x3014 * x4992;
  const Real x5056 = x3032 + x5039;
  w.result[8] = x5056;
  const Real x5044 = x2898 * x4990 + x2918 * x4991 + x2938 * x4992;
  const Real x5057 = x2966 + x5044;
  w.result[9] = x5057;
  const Real x5049 = x2983 * x4990 + x2999 * x4991 + x3015 * x4992;
  const Real x5058 = x3033 + x5049;
  w.result[10] = x5058;
  const Real x4994 = -(x4352 + x4988);
  w.result[11] = x4994;
}

// ---- processes ----------------------------------------------------------------------------------

// Process 0: 8 of 8 joints: "hip", "knee", "ankle_pitch", "ankle_roll", "left_motor", "left_ball", ...
constexpr std::array<int, 8> kRead_0{0, 1, 2, 3, 4, 5, 6, 7};
constexpr std::array<int, 8> kOwned_0{0, 1, 2, 3, 4, 5, 6, 7};
constexpr std::array<int, 6> kAngles_0{4, 9, 0, 1, 2, 3};

ADAGEN_AS_IT_STANDS void run_0([[maybe_unused]] Workspace& w, [[maybe_unused]] Channel& channel) {
  ADAGEN_INPUTS
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


}  // namespace

[[maybe_unused]] constexpr std::array<StageInfo, 3> kStages_0{ {{"kinematics", 7, -1}, {"assembly", 0, -1}, {"disassembly", 0, -1}} };
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
constexpr Number kLoop_0[]{1.0, 0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 1.0, 0.0, 0.0, -0.15,
    0.0, 1.0, 0.0, 0.0, 0.0, 1.0, 1.0, 0.0, 0.0, 0.05, 0.0, -0.06};
constexpr Number kLoop_1[]{1.0, 0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 1.0, 0.0, 0.0, -0.23,
    0.0, 1.0, 0.0, 0.0, 0.0, 1.0, 1.0, 0.0, 0.0, -0.05, 0.0, -0.06};
constexpr std::array<adagen::Loop<Number>, 2> kLoops{ {
    {kLoopNames[0], 6, 4, kLoop_0, kLoop_0 + 9, kLoop_0 + 12, kLoop_0 + 21, 7u, 0u, false},
    {kLoopNames[1], 8, 4, kLoop_1, kLoop_1 + 9, kLoop_1 + 12, kLoop_1 + 21, 7u, 0u, false},
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
