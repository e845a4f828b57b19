// Forward dynamics of "ankle" on 1 process, emitted by adagen 0.1.0 (solver.cpp.j2). Do not edit: generate again. Licence: yours to choose.
// robot     "ankle", 8 joints, 12 degrees of freedom, description sha256 ddb900f3e284309ae668afcdcf39b2b2f8b0b30c7e4b7984814bb0e23c113d8c
// command   adagen ../models/ankle.urdf --scene=../models/ankle.toml --procs 1
// input     scene, sha256 11c8028c5b54b9020d35bd5ac03db5bc865ea05a389c3bc7c7df6b476153c181
// input     profile default, sha256 b2cd3054184b2c2aeb17237ba40764c79d3d6210c1ef616ed164227e724cf326
// options   form segment (articulated-body algorithm), shape unrolled (spatial vectors [angular; linear] in link frames whose joint axes are z), scalar double, channel auto, fixed base, gravity 0.0, 0.0, -9.81
// links     adagen_program.cpp; or, compiled with -DADAGEN_NO_MAIN, a program of yours that includes ankle_p1.h
// program   1 process; 0.117 us predicted (default profile)
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
#include "adagen/kernels/lanes.hpp"
#include "adagen/no_channel.hpp"
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
// Process 0: 473 products, 350 sums, 6 quotients, 534 of them in lanes
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
  const Two x173 = x171 - x172;
  const Two x177 = 1.0 - (x157 + x168);
  const Two x167 = x161 + x162;
  const Two x160 = 1.0 - (x157 + x158);
  const Two x170 = 1.0 - (x158 + x168);
  // directions in which a loop holds its two links
  const Two x443 = x85 + v[2] * v[2] + x99 * x99;
  const Two x445 = x142 * x142 + x443 + x143 * x143;
  const Two x530 = load<Two>(cosine + 0) * x175 - load<Two>(sine + 0) * x163;
  const Two x582 = load<Two>(cosine + 0) * x177 - load<Two>(sine + 0) * x166;
  const Two x585 = load<Two>(sine + 0) * x177 + load<Two>(cosine + 0) * x166;
  const Two x533 = load<Two>(sine + 0) * x175 + load<Two>(cosine + 0) * x163;
  const Two x456 = load<Two>(cosine + 0) * x174 - load<Two>(sine + 0) * x160;
  const Two x459 = load<Two>(sine + 0) * x174 + load<Two>(cosine + 0) * x160;
  // joint 3 "ankle_roll": inertia and bias force of what is beyond, its own motion left open
  const Real x1242 = sine[5] * 0.002;
  // directions in which a loop holds its two links
  const Two x588 = cosine[4] * x582 + sine[4] * x585;
  const Two x536 = cosine[4] * x530 + sine[4] * x533;
  const Two x462 = cosine[4] * x456 + sine[4] * x459;
  const Two x592 = cosine[4] * x585 - sine[4] * x582;
  const Two x466 = cosine[4] * x459 - sine[4] * x456;
  const Two x540 = cosine[4] * x533 - sine[4] * x530;
  const Two x595 = cosine[5] * x173 + sine[5] * x588;
  const Two x599 = cosine[5] * x588 - sine[5] * x173;
  const Two x543 = cosine[5] * x170 + sine[5] * x536;
  const Two x469 = cosine[5] * x167 + sine[5] * x462;
  const Two x473 = cosine[5] * x462 - sine[5] * x167;
  const Two x547 = cosine[5] * x536 - sine[5] * x170;
  const Two x606 = 0.06 * x599;
  const Two x502 = 0.06 * x473;
  const Two x554 = 0.06 * x547;
  const Two x611 = 0.06 * x595 + Two{0.05, -0.05} * x592;
  const Two x559 = 0.06 * x543 + Two{0.05, -0.05} * x540;
  const Two x507 = 0.06 * x469 + Two{0.05, -0.05} * x466;
  const Two x613 = Two{0.05, -0.05} * x599;
  // joints 5 "left_ball", 7 "right_ball": inertia and bias force of what is beyond, their motion left open
  const Two x790 = x177 * 0.06;
  const Two x653 = x167 * Two{0.00112635, 0.00264635};
  const Two x710 = x173 * 2.7e-06;
  const Two x812 = x166 * Two{0.01125, 0.01725};
  const Two x677 = x170 * Two{0.00112635, 0.00264635};
  const Two x847 = -0.009 - x812;
  const Two x728 = x170 * Two{0.15, 0.23} - x174 * 0.06;
  const Two x761 = x167 * Two{0.15, 0.23} + x175 * 0.06;
  const Two x654 = x175 * Two{0.01125, 0.01725};
  const Two x678 = x174 * Two{0.01125, 0.01725};
  // joint 3 "ankle_roll": inertia and bias force of what is beyond, its own motion left open
  const Real x1310 = cosine[5] * x606[0] + sine[5] * x611[0];
  const Real x1325 = cosine[5] * x606[1] + sine[5] * x611[1];
  const Real x1250 = cosine[5] * x502[0] + sine[5] * x507[0];
  const Real x1265 = cosine[5] * x502[1] + sine[5] * x507[1];
  const Real x1280 = cosine[5] * x554[0] + sine[5] * x559[0];
  const Real x1295 = cosine[5] * x554[1] + sine[5] * x559[1];
  // link 2 "shank": accelerations and constraint forces of loops below it are eliminated
  const Two x1672 = 1 / x790;
  const Two x1656 = Two{x1310, x1325};
  const Two x1674 = x1656 * x1672;
  // joint 1 "knee": placement, velocity and reference acceleration of its link
  const Real x32 = cosine[3] * x28 - x14 * sine[3];
  const Real x37 = sine[3] * x28 + x14 * cosine[3];
  // joint 2 "ankle_pitch": placement, velocity and reference acceleration of its link
  const Real x51 = x32 + 0.4 * x41;
  // joint 3 "ankle_roll": placement, velocity and reference acceleration of its link
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
  const Two x200 = x122 * 0.06 - x120;
  // directions in which a loop holds its two links
  const Two x561 = Two{0.05, -0.05} * x547;
  const Two x509 = Two{0.05, -0.05} * x473;
  // joints 5 "left_ball", 7 "right_ball": inertia and bias force of what is beyond, their motion left open
  const Two x845 = x167 * x653 + x173 * x710 + x170 * x677;
  const Two x662 = x653 + 0.06 * x654;
  const Two x689 = x677 - 0.06 * x678;
  const Two x903 = x845 - 0.06 * (x847 - x812) + 0.0002466667;
  const Two x655 = x163 * Two{0.01125, 0.01725};
  const Two x810 = x177 * Two{0.01125, 0.01725};
  const Two x904 = 0.006 - x847;
  const Two x680 = x160 * Two{0.01125, 0.01725};
  // joints 4 "left_motor", 6 "right_motor": inertia and bias force of what is beyond, their motion left open
  const Two x929 = load<Two>(cosine + 0) * x810;
  // link 2 "shank": accelerations and constraint forces of loops below it are eliminated
  const Two x1637 = Two{x1250, x1265};
  const Two x1645 = Two{x1280, x1295};
  const Two x1676 = x613 * x1672;
  const Two x1694 = (x1637 + x728 * x1674) * Two{6.666666666666667, 4.3478260869565215};
  const Two x1710 = Two{6.666666666666667, 4.3478260869565215} * (x1645 - x761 * x1674);
  const Two x1712 = Two{6.666666666666667, 4.3478260869565215} * (x561 - x761 * x1676);
  const Two x1757 = x689 * x1674 - Two{0.00112635, 0.00264635} * x1694;
  const Two x1750 = x662 * x1674 + Two{0.00112635, 0.00264635} * x1710;
  const Two x1762 = x710 * x1674;
  const Two x1695 = (x509 + x728 * x1676) * Two{6.666666666666667, 4.3478260869565215};
  const Two x1741 = x903 * x1674 + x662 * x1710 - x689 * x1694;
  const Two x1974 = x1762 * 370370.3703703704;
  const Two x1753 = x662 * x1676 + Two{0.00112635, 0.00264635} * x1712;
  const Two x1747 = x903 * x1676 + x662 * x1712 - x689 * x1695;
  const Two x1768 = x1710 * x1750 - x1694 * x1757 + x1674 * x1741;
  const Two x1986 = x1762 * x1974;
  const Two x1761 = x689 * x1676 - Two{0.00112635, 0.00264635} * x1695;
  // joint 2 "ankle_pitch": placement, velocity and reference acceleration of its link
  const Real x55 = cosine[4] * x51 - x37 * sine[4];
  const Real x60 = sine[4] * x51 + x37 * cosine[4];
  // joint 3 "ankle_roll": placement, velocity and reference acceleration of its link
  const Real x77 = x55 * sine[5];
  const Real x88 = x70 * x71;
  const Real x78 = x55 * cosine[5];
  // joints 5 "left_ball", 7 "right_ball": placement, velocity and reference acceleration of their links
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
  // links 6 "left_rod", 8 "right_rod": force that the reference field takes
  const Two x385 = x203 * 0.15 - x230 * Two{0.01125, 0.01725};
  const Two x389 = x206 * 0.15 - x224 * Two{0.01125, 0.01725};
  const Two x374 = (x143 * x179 - x142 * x180) * 2.7e-06;
  const Two x378 = x188 * Two{0.00112635, 0.00264635} - x223 * Two{0.00112365, 0.00264365} + x206 * Two{0.01125, 0.01725};
  const Two x393 = x209 * 0.15 + x226 * Two{0.01125, 0.01725};
  // directions in which a loop holds its two links
  const Two x488 = x77 - (x83 + x85) * Two{0.05, -0.05};
  const Two x496 = 2.0 * x75 * Two{0.05, -0.05} + x94 * 0.06 - x60;
  const Two x491 = x78 - x88 * Two{0.05, -0.05};
  // joints 4 "left_motor", 6 "right_motor": inertia and bias force of what is beyond, their motion left open
  const Two x931 = load<Two>(sine + 0) * x904 - x929;
  const Two x963 = load<Two>(sine + 0) * x654 + load<Two>(cosine + 0) * x655;
  const Two x1001 = load<Two>(sine + 0) * x678 + load<Two>(cosine + 0) * x680;
  const Two x939 = x903 - Two{0.25, 0.17} * x931;
  const Two x974 = x662 - Two{0.25, 0.17} * x963;
  const Two x1013 = x689 + Two{0.25, 0.17} * x1001;
  // joint 3 "ankle_roll": inertia and bias force of what is beyond, its own motion left open
  const Real x1367 = 0.00630833 + cosine[5] * (cosine[5] * 0.0019583400000000003) + 2.4e-05;
  const Real x1245 = cosine[5] * 0.05;
  // link 2 "shank": accelerations and constraint forces of loops below it are eliminated
  const Two x1774 = x1674 * x1747 + x1710 * x1753 - x1694 * x1761;
  const Two x1775 = x710 * x1676;
  const Two x1987 = x1775 * x1974;
  const Real x2058 = x1367 + across<2>(x1768) - across<2>(x1986);
  const Two x1787 = x1712 * x1753 - x1695 * x1761 + x1676 * x1747;
  const Two x1975 = x1775 * 370370.3703703704;
  const Real x2092 = 1 / x2058;
  const Two x1993 = x1775 * x1975;
  // joint 3 "ankle_roll": placement, velocity and reference acceleration of its link
  const Real x73 = v[3] * x71;
  const Real x90 = x82 + x85;
  // links 6 "left_rod", 8 "right_rod": force that the reference field takes
  const Two x381 = x192 * Two{0.00112635, 0.00264635} + x228 * Two{0.00112365, 0.00264365} - x203 * Two{0.01125, 0.01725};
  // directions in which a loop holds its two links
  const Two x605 = x488 * x595 + x496 * x592 + x491 * x599;
  const Two x501 = x469 * x488 + x466 * x496 + x473 * x491;
  const Two x553 = x488 * x543 + x496 * x540 + x491 * x547;
  // joints 5 "left_ball", 7 "right_ball": inertia and bias force of what is beyond, their motion left open
  const Two x883 = x174 * x385 + x175 * x389 + x177 * x393;
  const Two x901 = -0.006 + x847;
  const Two x878 = x167 * x378 + x173 * x374 + x170 * x381;
  const Two x640 = x378 - Two{tau[5], tau[9]};
  const Two x645 = x381 - Two{tau[6], tau[10]};
  const Two x906 = x878 + 0.06 * x883 + x115 * 0.006;
  // joints 4 "left_motor", 6 "right_motor": inertia and bias force of what is beyond, their motion left open
  const Two x925 = load<Two>(sine + 0) * x810;
  const Two x927 = load<Two>(cosine + 0) * x904 + x925;
  const Two x960 = load<Two>(cosine + 0) * x654 - load<Two>(sine + 0) * x655;
  const Two x1150 = x929 + load<Two>(sine + 0) * x901;
  const Two x996 = load<Two>(sine + 0) * x680 - load<Two>(cosine + 0) * x678;
  const Two x1168 = Two{-0.0875, -0.059500000000000004} - x1150;
  // joint 3 "ankle_roll": inertia and bias force of what is beyond, its own motion left open
  const Real x1246 = sine[5] * 0.05;
  // joint 2 "ankle_pitch": inertia and bias force of what is beyond, its own motion left open
  const Real x1390 = sine[4] * 0.04 + cosine[4] * x1245;
  const Real x1403 = sine[4] * x1246;
  // link 2 "shank": accelerations and constraint forces of loops below it are eliminated
  const Two x1829 = x939 * x1674 + x974 * x1710 - x1013 * x1694;
  const Two x1978 = x710 * 370370.3703703704;
  const Real x2060 = across<2>(x1774) - x1242 - across<2>(x1987);
  const Two x1835 = x939 * x1676 + x974 * x1712 - x1013 * x1695;
  const Two x2010 = x1762 * x1978;
  const Real x2093 = x2060 * x2092;
  const Two x1678 = (x605 - (x209 + x226 * Two{0.15, 0.23})) * x1672;
  const Two x2011 = x1775 * x1978;
  const Real x2061 = 0.003308333 + across<2>(x1787) - across<2>(x1993);
  const Real x2096 = x2061 - x2060 * x2093;
  // link 4 "foot": force that the reference field takes
  const Real x292 = x73 * 0.002999997 - x73 * 0.00826667;
  const Real x312 = 0.002 * (x94 - x90) + x292 + x60 * 0.05;
  const Real x302 = x75 * 0.004958337 - x75 * 0.00630833 + x88 * 0.002;
  // joints 4 "left_motor", 6 "right_motor": inertia and bias force of what is beyond, their motion left open
  const Two x912 = x906 - Two{tau[4], tau[8]};
  const Two x1188 = x903 - Two{0.25, 0.17} * (x1168 - x1150);
  // joint 3 "ankle_roll": inertia and bias force of what is beyond, its own motion left open
  const Real x1351 = cosine[5] * (x312 - x78 * 0.04);
  const Real x1354 = x1351 - sine[5] * (x302 + x77 * 0.04);
  // joint 2 "ankle_pitch": inertia and bias force of what is beyond, its own motion left open
  const Real x1582 = -0.46 - x1390;
  const Real x1385 = sine[4] * x1245 - cosine[4] * 0.04;
  // link 2 "shank": accelerations and constraint forces of loops below it are eliminated
  const Two x1853 = x931 * x1674 + x963 * x1710 + x1001 * x1694;
  const Real x2097 = 1 / x2096;
  const Two x1692 = x501 - (x203 - x230 * Two{0.15, 0.23}) + x728 * x1678;
  const Two x1696 = x1692 * Two{6.666666666666667, 4.3478260869565215};
  const Two x1708 = x553 - (x206 - x224 * Two{0.15, 0.23}) - x761 * x1678;
  const Two x1714 = Two{6.666666666666667, 4.3478260869565215} * x1708;
  const Real x2064 = x1367 + 0.4 * x1390 + across<2>(x1829) - across<2>(x2010);
  const Two x1841 = x927 * x1674 + x960 * x1710 - x996 * x1694;
  const Two x1859 = x931 * x1676 + x963 * x1712 + x1001 * x1695;
  const Real x2067 = across<2>(x1835) - (x1242 + 0.4 * x1403) - across<2>(x2011);
  const Two x1847 = x927 * x1676 + x960 * x1712 - x996 * x1695;
  const Two x1896 = x640 * x1710 - x645 * x1694 + x912 * x1674;
  const Two x1902 = x640 * x1712 - x645 * x1695 + x912 * x1676;
  const Two x1909 = x1714 * x1750 - x1696 * x1757 + x1678 * x1741;
  const Two x1979 = (x374 - Two{tau[7], tau[11]} + x710 * x1678) * 370370.3703703704;
  const Two x2014 = x710 * x1978;
  const Real x2131 = x2097 * (x2067 - x2064 * x2093);
  const Real x1878 = across<2>(x1853) - x1390;
  const Two x1915 = x1678 * x1747 + x1714 * x1753 - x1696 * x1761;
  const Two x2016 = x1762 * x1979;
  const Real x1877 = x1385 + across<2>(x1841);
  const Real x1889 = x1403 + across<2>(x1859);
  // joints 5 "left_ball", 7 "right_ball": inertia and bias force of what is beyond, their motion left open
  const Two x907 = x115 * 0.2 + x883;
  const Two x888 = x160 * x385 + x163 * x389 + x166 * x393;
  const Two x908 = x122 * 0.006 - x120 * 0.2 + x888;
  // joints 4 "left_motor", 6 "right_motor": inertia and bias force of what is beyond, their motion left open
  const Two x1209 = load<Two>(sine + 0) * x907 + load<Two>(cosine + 0) * x908;
  const Two x1153 = load<Two>(cosine + 0) * x901 - x925;
  const Two x1220 = x906 - Two{0.25, 0.17} * x1209;
  const Two x1206 = load<Two>(cosine + 0) * x907 - load<Two>(sine + 0) * x908;
  // joint 3 "ankle_roll": inertia and bias force of what is beyond, its own motion left open
  const Real x1362 = sine[5] * (x77 + x88 * 0.05);
  const Real x1364 = x1362 + cosine[5] * (x78 + x90 * 0.05);
  const Real x1369 = x55 * 0.15 + x1364;
  // link 4 "foot": force that the reference field takes
  const Real x330 = 2.0 * x73 * 0.05 - x94 * 0.04 - x60;
  // joint 3 "ankle_roll": inertia and bias force of what is beyond, its own motion left open
  const Real x1370 = x330 - x60 * 0.15;
  // joint 2 "ankle_pitch": inertia and bias force of what is beyond, its own motion left open
  const Real x1610 = sine[4] * x1369 + cosine[4] * x1370;
  // link 2 "shank": accelerations and constraint forces of loops below it are eliminated
  const Two x2017 = x1775 * x1979;
  const Real x2144 = x2064 * x2092 - x2093 * x2131;
  const Real x1888 = cosine[4] * x1246 + across<2>(x1847);
  const Real x2133 = x2097 * (x1889 - x1878 * x2093);
  const Real x2132 = x2097 * (x1888 - x1877 * x2093);
  const Real x1919 = x88 * 0.0019583400000000003 + x77 * 0.05 - tau[3] + across<2>(x1902);
  const Real x2068 = x1354 - tau[2] + across<2>(x1896) + across<2>(x1909) - across<2>(x2016);
  const Real x2085 = x1367 - 0.4 * (x1582 - x1390) + across<2>(x1188) - across<2>(x2014);
  const Real x2150 = x1878 * x2092 - x2093 * x2133;
  const Real x2306 = x2085 - (x2064 * x2144 + x2067 * x2131) + 0.18885420000000003;
  require_more(w, x2306, 0.0, kFactorization, 1);
  const Real x2147 = x1877 * x2092 - x2093 * x2132;
  const Two x1944 = x939 * x1678 + x974 * x1714 - x1013 * x1696;
  const Two x2020 = x710 * x1979;
  const Real x2135 = x2097 * (x1919 + across<2>(x1915) - across<2>(x2017) - x2068 * x2093);
  const Real x2267 = across<2>(x1153) - x1385 + (x2064 * x2147 + x2067 * x2132);
  const Real x2269 = across<2>(x1168) + x1582 - (x2064 * x2150 + x2067 * x2133);
  const Real x2307 = -0.7000000000000001 + x2269;
  // joint 1 "knee": articulated-body inertia and bias force through it
  const Real x2315 = 1 / x2306;
  // directions in which a loop holds its two links
  const Two x399 = sine[5] * Two{0.05, -0.05};
  const Two x410 = x177 * Two{0.15, 0.23};
  const Two x416 = -0.06 - x166 * Two{0.15, 0.23};
  // link 2 "shank": accelerations and constraint forces of loops below it are eliminated
  const Real x2156 = x2068 * x2092 - x2093 * x2135;
  const Two x1950 = x927 * x1678 + x960 * x1714 - x996 * x1696;
  const Two x1956 = x931 * x1678 + x963 * x1714 + x1001 * x1696;
  const Real x2091 = x1354 - 0.4 * x1610 + across<2>(x1220) + across<2>(x1944) - across<2>(x2020);
  const Real x2299 = x2091 - (x2064 * x2156 + x2067 * x2135);
  const Real x1970 = cosine[4] * x1369 - sine[4] * x1370 + across<2>(x1206) + across<2>(x1950);
  const Real x2287 = x1878 * x2156 + x1889 * x2135;
  const Real x2300 = x1970 - (x1877 * x2156 + x1888 * x2135);
  const Two x1729 = x1676 * x1676 + x1712 * x1712 + x1695 * x1695;
  // joint 1 "knee": articulated-body inertia and bias force through it
  const Real x2320 = x2267 * x2315;
  const Real x2322 = x2307 * x2315;
  // link 2 "shank": accelerations and constraint forces of loops below it are eliminated
  const Real x2308 = 1.85 - (x1877 * x2147 + x1888 * x2132) + 3.5;
  // joint 1 "knee": articulated-body inertia and bias force through it
  const Real x2356 = x2308 - x2267 * x2320;
  // link 2 "shank": accelerations and constraint forces of loops below it are eliminated
  const Real x2309 = 1.85 - (x1878 * x2150 + x1889 * x2133) + 3.5;
  // joint 1 "knee": articulated-body inertia and bias force through it
  const Real x2359 = x2267 * x2322 - (x1877 * x2150 + x1888 * x2133);
  const Real x2429 = cosine[3] * (x2356 - (x2309 - x2307 * x2322));
  const Real x2317 = x2315 * (tau[1] - (x37 * 0.7000000000000001 + x2299));
  // link 2 "shank": accelerations and constraint forces of loops below it are eliminated
  const Real x2312 = x32 * 3.5 + x41 * 0.7000000000000001 + x2300;
  const Real x2313 = across<2>(x1209) + x1610 + across<2>(x1956) - x2287 - x37 * 3.5;
  // joint 1 "knee": articulated-body inertia and bias force through it
  const Real x2438 = x2356 - cosine[3] * (x2429 - x2359 * (sine[3] * 2.0));
  const Real x2478 = sine[3] * (x2312 - x2267 * x2317);
  // directions in which a loop holds its two links
  const Two x407 = sine[4] * x399 - cosine[4] * 0.06;
  const Two x430 = x407 - (load<Two>(cosine + 0) * x416 - load<Two>(sine + 0) * x410);
  const Two x431 = cosine[5] * Two{0.05, -0.05} - (Two{0.05, -0.05} - x173 * Two{0.15, 0.23});
  const Two x408 = cosine[4] * x399 + sine[4] * 0.06 + -0.4;
  const Two x429 = x408 - (Two{-0.25, -0.17} - (load<Two>(cosine + 0) * x410 + load<Two>(sine + 0) * x416));
  const Two x436 = x430 * x430 + x431 * x431 + x429 * x429;
  const Two x448 = 1e-08 - x436;
  require_more(w, x448, 0.0, kLoopOpen, {8, 9});
  // link 2 "shank": accelerations and constraint forces of loops below it are eliminated
  const Two x1642 = x99 * x728 + x143 * Two{0.15, 0.23} + v[3] * x509;
  const Two x1643 = v[2] * x1637 + x1642;
  const Two x1653 = v[3] * x561 - (x99 * x761 + x142 * Two{0.15, 0.23});
  const Two x1654 = v[2] * x1645 + x1653;
  const Two x1731 = x1674 * x1674 + x1729 + x1710 * x1710;
  const Two x1732 = x1694 * x1694 + x1731;
  const Two x1661 = v[3] * x613 - x99 * x790 + v[2] * x1656;
  const Real x2098 = x1367 * 1e-08;
  require_more(w, x2058, x2098, kSingularPose, 2);
  const Two x1683 = x790 * x790 * 256.0;
  require_more(w, x1683, 9.999999999999998e-15, kSingularPose, {8, 9});
  const Real x2100 = 1e-08 * (0.003308333 + x2061);
  require_more(w, x2096, x2100, kSingularPose, 3);
  const Two x1666 = x1643 * x1643 + x1654 * x1654 + x1661 * x1661;
  const Two x1667 = (x144 * x144 + x445 + 1.0) * 1.0000000000000002e-06 - x1666;
  require_more(w, x1667, 0.0, kLoopTorn, {8, 9});
  const Real x1735 = 40000.0 - across<2>(x1732);
  require_more(w, x1735, 0.0, kSingularPose, 8);
  // joint 1 "knee": articulated-body inertia and bias force through it
  const Real x2490 = 0.32735000000000003 + 0.4 * (0.4 * x2438);
  require_more(w, x2490, 0.0, kFactorization, 0);
  const Real x2484 = 0.4 * (x2478 + cosine[3] * (x2313 + x2307 * x2317));
  // joint 0 "hip": articulated-body inertia and bias force through it
  const Real x2501 = 1 / x2490 * (tau[0] - (tau[1] - x2484 + x14 * 1.2000000000000002));
  w.result[0] = x2501;
  // joint 1 "knee": its acceleration, and that of the link beyond
  const Real x2511 = 0.4 * x2501;
  const Real x2513 = sine[3] * x2511;
  const Real x2515 = cosine[3] * x2511;
  const Real x2522 = x2317 - x2320 * x2513 + x2322 * x2515;
  const Real x2523 = x2522 - x2501;
  w.result[1] = x2523;
  // link 2 "shank": accelerations and constraint forces of loops below it
  const Real x2531 = x2147 * x2513 + x2150 * x2515 - x2144 * x2522;
  const Real x2540 = x2531 - x2156;
  w.result[2] = x2540;
  const Real x2539 = x2132 * x2513 + x2133 * x2515 - x2131 * x2522;
  const Real x2541 = x2539 - x2135;
  w.result[3] = x2541;
  const Two x2550 = x1974 * x2540 + x1975 * x2541;
  const Two x2570 = x1674 * x2540 + x1676 * x2541 + x1678;
  put(x2570, w.lanes.data() + 0);
  const Two x2571 = x1710 * x2540 + x1712 * x2541 + x1714;
  put(x2571, w.lanes.data() + 2);
  const Two x2553 = -(x1979 + x1978 * x2522 + x2550);
  put(x2553, w.lanes.data() + 6);
  const Two x2573 = -(x1694 * x2540 + x1695 * x2541 + x1696);
  put(x2573, w.lanes.data() + 4);
}

// =================================================================================================
// Process 0 in a singular pose: 1375 products, 986 sums, 20 quotients
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
  const Real x253 = q[12] * x251;
  // directions in which a loop holds its two links
  const Real x572 = v[2] * v[2];
  const Real x574 = v[4] * v[4] + v[5] * v[5] + v[6] * v[6];
  // directions in which a loop holds its two links
  const Real x757 = v[8] * v[8] + v[9] * v[9] + v[10] * v[10];
  // joint 5 "left_ball": placement, velocity and reference acceleration of its link
  const Real x155 = 1.0 - (x135 + x146);
  // joint 7 "right_ball": placement, velocity and reference acceleration of its link
  const Real x259 = q[12] * x249;
  const Real x260 = q[13] * x250;
  const Real x255 = 1.0 - (x252 + x253);
  const Real x256 = q[11] * x249;
  const Real x269 = x259 - x260;
  const Real x257 = q[13] * x251;
  // directions in which a loop holds its two links
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
  // joint 5 "left_ball": inertia and bias force of what is beyond, its own motion left open
  const Real x1339 = x148 * 0.15 - x152 * 0.06;
  const Real x1354 = x145 * 0.15 + x153 * 0.06;
  const Real x1361 = x155 * 0.06;
  // joint 3 "ankle_roll": inertia and bias force of what is beyond, its own motion left open
  const Real x1713 = sine[3] * (0.06 * x600 + 0.05 * x597);
  const Real x1715 = cosine[3] * (0.06 * x604) + x1713;
  const Real x1728 = sine[3] * (0.06 * x655 + 0.05 * x652);
  const Real x1730 = cosine[3] * (0.06 * x659) + x1728;
  // link 2 "shank": accelerations and constraint forces of loops below it are eliminated
  const Real x2165 = x1339 * 8.0;
  const Real x2169 = x1354 * 8.0;
  const Real x2174 = x1361 * 16.0;
  const Real x2164 = x637 * 8.0;
  const Real x2168 = x673 * 8.0;
  const Real x2198 = x2165 * x2165 + 1.44 + x2164 * x2164;
  const Real x2163 = x1715 * 8.0;
  const Real x2167 = x1730 * 8.0;
  // joint 7 "right_ball": placement, velocity and reference acceleration of its link
  const Real x262 = x256 + x257;
  const Real x266 = q[12] * x250;
  const Real x267 = q[13] * x249;
  const Real x258 = x256 - x257;
  const Real x270 = x266 + x267;
  const Real x263 = q[10] * x249;
  const Real x261 = x259 + x260;
  const Real x268 = x266 - x267;
  const Real x265 = 1.0 - (x253 + x263);
  const Real x272 = 1.0 - (x252 + x263);
  // directions in which a loop holds its two links
  const Real x767 = cosine[5] * x269 - sine[5] * x255;
  const Real x770 = sine[5] * x269 + cosine[5] * x255;
  const Real x773 = cosine[2] * x767 + sine[2] * x770;
  const Real x777 = cosine[2] * x770 - sine[2] * x767;
  const Real x818 = cosine[5] * x270 - sine[5] * x258;
  const Real x821 = sine[5] * x270 + cosine[5] * x258;
  const Real x780 = cosine[3] * x262 + sine[3] * x773;
  const Real x784 = cosine[3] * x773 - sine[3] * x262;
  const Real x824 = cosine[2] * x818 + sine[2] * x821;
  const Real x812 = 0.05 * x784;
  const Real x828 = cosine[2] * x821 - sine[2] * x818;
  const Real x831 = cosine[3] * x265 + sine[3] * x824;
  const Real x835 = cosine[3] * x824 - sine[3] * x265;
  const Real x855 = cosine[5] * x272 - sine[5] * x261;
  const Real x849 = 0.05 * x835;
  const Real x858 = sine[5] * x272 + cosine[5] * x261;
  // joint 7 "right_ball": inertia and bias force of what is beyond, its own motion left open
  const Real x936 = x265 * 0.23 - 0.06 * x269;
  // joint 3 "ankle_roll": inertia and bias force of what is beyond, its own motion left open
  const Real x1743 = sine[3] * (0.06 * x691 + 0.05 * x688);
  const Real x1745 = cosine[3] * (0.06 * x695) + x1743;
  const Real x1758 = sine[3] * (0.05 * x777 - 0.06 * x780);
  const Real x1760 = cosine[3] * (0.06 * x784) - x1758;
  // link 2 "shank": accelerations and constraint forces of loops below it are eliminated
  const Real x2173 = x709 * 16.0;
  const Real x2172 = x1745 * 16.0;
  const Real x2201 = sign_of(x2163) * sqrt_of(x2163 * x2163 + x2198);
  const Real x2202 = x2163 + x2201;
  const Real x2177 = x812 * 4.0;
  const Real x2179 = x936 * 4.0;
  const Real x2204 = x2198 + x2202 * x2202;
  const Real x2176 = x1760 * 4.0;
  const Real x2182 = x849 * 4.0;
  const Real x2434 = x2179 * x2179 + 0.8464;
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
  // directions in which a loop holds its two links
  const Real x861 = cosine[2] * x855 + sine[2] * x858;
  const Real x865 = cosine[2] * x858 - sine[2] * x855;
  const Real x868 = cosine[3] * x268 + sine[3] * x861;
  const Real x872 = cosine[3] * x861 - sine[3] * x268;
  const Real x886 = 0.05 * x872;
  // joint 7 "right_ball": inertia and bias force of what is beyond, its own motion left open
  const Real x958 = 0.06 * x272;
  const Real x951 = x262 * 0.23 + 0.06 * x270;
  // joint 3 "ankle_roll": inertia and bias force of what is beyond, its own motion left open
  const Real x1772 = sine[3] * (0.05 * x828 - 0.06 * x831);
  const Real x1774 = cosine[3] * (0.06 * x835) - x1772;
  const Real x1786 = sine[3] * (0.05 * x865 - 0.06 * x868);
  const Real x1788 = cosine[3] * (0.06 * x872) - x1786;
  // link 2 "shank": accelerations and constraint forces of loops below it are eliminated
  const Real x2190 = x958 * 16.0;
  const Real x2181 = x1774 * 4.0;
  const Real x2206 = 2.0 * (1 / x2204);
  const Real x2184 = x951 * 4.0;
  const Real x2212 = x2164 * x2168 - x2165 * x2169 + x2167 * x2202;
  const Real x2213 = x2206 * x2212;
  const Real x2228 = x2164 * x2173 - x2165 * x2174 + x2172 * x2202;
  const Real x2229 = x2206 * x2228;
  const Real x2243 = x2206 * (x2176 * x2202 - x2164 * x2177);
  const Real x2217 = 1.2 * x2213;
  const Real x2233 = 1.2 * x2229;
  const Real x2246 = x2165 * x2243;
  const Real x2247 = 1.2 * x2243;
  const Real x2219 = x2168 - x2164 * x2213;
  const Real x2220 = x2169 + x2165 * x2213;
  const Real x2236 = x2174 + x2165 * x2229;
  const Real x2235 = x2173 - x2164 * x2229;
  const Real x2249 = x2177 + x2164 * x2243;
  const Real x2257 = x2206 * (x2181 * x2202 - x2164 * x2182);
  const Real x2288 = 1.44 + x2217 * x2217;
  const Real x2284 = x2220 * x2220;
  const Real x2260 = x2165 * x2257;
  const Real x2261 = 1.2 * x2257;
  const Real x2263 = x2182 + x2164 * x2257;
  const Real x2188 = x886 * 16.0;
  const Real x2187 = x1788 * 16.0;
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
  const Real x159 = x99 * x151;
  const Real x160 = v[5] + x157;
  const Real x162 = v[7] + x159;
  const Real x158 = x99 * x148;
  const Real x178 = x114 * 0.06 - x112;
  const Real x170 = v[5] * x159 - v[7] * x157;
  const Real x206 = x160 * x162;
  const Real x161 = v[6] + x158;
  const Real x208 = x170 + x206;
  const Real x166 = v[7] * x158 - v[6] * x159;
  const Real x181 = x107 * x152 + x138 * x178;
  const Real x201 = x161 * x162;
  const Real x202 = x201 - x166;
  const Real x184 = x107 * x153 + x141 * x178;
  const Real x204 = x160 * x160 + x161 * x161;
  // joint 6 "right_motor": placement, velocity and reference acceleration of its link
  const Real x220 = x27 + x36 * 0.17;
  const Real x229 = sine[5] * x220 + x32 * cosine[5];
  // joint 7 "right_ball": placement, velocity and reference acceleration of its link
  const Real x273 = x216 * x262;
  const Real x275 = x216 * x268;
  const Real x276 = v[9] + x273;
  const Real x278 = v[11] + x275;
  // link 4 "foot": force that the reference field takes
  const Real x412 = x83 * 0.05;
  // directions in which a loop holds its two links
  const Real x620 = 2.0 * x70 * 0.05;
  const Real x621 = x89 * 0.06;
  const Real x616 = (x78 + x80) * 0.05;
  const Real x618 = x72 - x616;
  const Real x624 = x620 + x621 - x55;
  const Real x619 = x73 - x412;
  const Real x629 = x600 * x618 + x597 * x624 + x604 * x619;
  // link 2 "shank": accelerations and constraint forces of loops below it are eliminated
  const Real x2271 = x2206 * (x2187 * x2202 - x2164 * x2188);
  const Real x2292 = sign_of(x2219) * sqrt_of(x2219 * x2219 + x2288 + x2284);
  const Real x2274 = x2165 * x2271;
  const Real x2275 = 1.2 * x2271;
  const Real x2293 = x2219 + x2292;
  const Real x2277 = x2188 + x2164 * x2271;
  const Real x2296 = x2284 + x2288 + x2293 * x2293;
  const Real x2298 = 2.0 * (1 / x2296);
  const Real x2305 = x2220 * x2236 + x2217 * x2233 + x2235 * x2293;
  const Real x2306 = x2298 * x2305;
  const Real x2324 = x2220 * x2246 + x2217 * x2247 - x2249 * x2293;
  const Real x2325 = x2298 * x2324;
  const Real x2344 = x2220 * x2260 + x2217 * x2261 - x2263 * x2293;
  const Real x2345 = x2298 * x2344;
  const Real x2364 = x2220 * x2274 + x2217 * x2275 - x2277 * x2293;
  const Real x2365 = x2298 * x2364;
  // joint 5 "left_ball": placement, velocity and reference acceleration of its link
  const Real x187 = x107 * x155 + x144 * x178;
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
  // directions in which a loop holds its two links
  const Real x665 = x618 * x655 + x624 * x652 + x619 * x659;
  const Real x701 = x618 * x691 + x624 * x688 + x619 * x695;
  // directions in which a loop holds its two links
  const Real x795 = x72 + x616;
  const Real x799 = x621 - x620 - x55;
  const Real x796 = x73 + x412;
  const Real x804 = x780 * x795 + x777 * x799 + x784 * x796;
  // link 2 "shank": accelerations and constraint forces of loops below it are eliminated
  const Real x2310 = 1.2 * x2306;
  const Real x2329 = 1.2 * x2325;
  const Real x2349 = 1.2 * x2345;
  const Real x2315 = x2220 * x2306 - x2236;
  const Real x2380 = x2310 * x2310;
  const Real x2316 = x2217 * x2306 - x2233;
  const Real x2336 = x2217 * x2325 - x2247;
  const Real x2335 = x2220 * x2325 - x2246;
  const Real x2356 = x2217 * x2345 - x2261;
  const Real x2355 = x2220 * x2345 - x2260;
  const Real x2381 = x2316 * x2316;
  const Real x2369 = 1.2 * x2365;
  const Real x2376 = x2217 * x2365 - x2275;
  const Real x2375 = x2220 * x2365 - x2274;
  const Real x2551 = (x629 - (x181 - x208 * 0.15)) * 8.0 * (1 / x2201);
  const Real x2538 = (x665 - (x184 - x202 * 0.15)) * 8.0;
  const Real x2385 = sign_of(x2315) * sqrt_of(x2315 * x2315 + x2380 + x2381);
  const Real x2559 = 1 / x2292 * (x2538 + (x2167 - x2202 * x2213) * x2551);
  const Real x2386 = x2315 + x2385;
  // joint 7 "right_ball": placement, velocity and reference acceleration of its link
  const Real x319 = x276 * x276 + x277 * x277;
  const Real x302 = x224 * x272 + x261 * x293;
  // directions in which a loop holds its two links
  const Real x841 = x795 * x831 + x799 * x828 + x796 * x835;
  const Real x878 = x795 * x868 + x799 * x865 + x796 * x872;
  // joint 7 "right_ball": inertia and bias force of what is beyond, its own motion left open
  const Real x897 = x262 * 0.00264635;
  const Real x924 = x268 * 2.7e-06;
  const Real x962 = x261 * 0.01725;
  const Real x909 = x265 * 0.00264635;
  const Real x997 = -0.009 - x962;
  const Real x898 = x270 * 0.01725;
  const Real x910 = x269 * 0.01725;
  // link 2 "shank": accelerations and constraint forces of loops below it are eliminated
  const Real x2539 = (x701 - (x187 + x204 * 0.15)) * 16.0;
  const Real x2389 = x2380 + x2381 + x2386 * x2386;
  const Real x2567 = x2539 + (x2172 - x2202 * x2229) * x2551;
  const Real x2571 = 1 / x2385 * ((x2235 - x2293 * x2306) * x2559 + x2567);
  const Real x2540 = (x804 - (x296 - x323 * 0.23)) * 4.0;
  const Real x2581 = x2540 + (x2176 - x2202 * x2243) * x2551;
  const Real x2541 = (x841 - (x299 - x317 * 0.23)) * 4.0;
  const Real x2391 = 2.0 * (1 / x2389);
  const Real x2597 = x2541 + (x2181 - x2202 * x2257) * x2551;
  const Real x2396 = x2310 * x2329 + x2316 * x2336 + x2335 * x2386;
  const Real x2397 = x2391 * x2396;
  const Real x2408 = x2310 * x2349 + x2316 * x2356 + x2355 * x2386;
  const Real x2409 = x2391 * x2408;
  const Real x2420 = x2310 * x2369 + x2316 * x2376 + x2375 * x2386;
  const Real x2421 = x2391 * x2420;
  const Real x2542 = (x878 - (x302 + x319 * 0.23)) * 16.0;
  const Real x2402 = x2329 - x2310 * x2397;
  const Real x2403 = x2336 - x2316 * x2397;
  const Real x2415 = x2356 - x2316 * x2409;
  const Real x2414 = x2349 - x2310 * x2409;
  const Real x2427 = x2376 - x2316 * x2421;
  const Real x2426 = x2369 - x2310 * x2421;
  const Real x2431 = x2403 * x2403;
  const Real x2616 = x2542 + (x2187 - x2202 * x2271) * x2551;
  // link 8 "right_rod": force that the reference field takes
  const Real x519 = x296 * 0.15 - x323 * 0.01725;
  const Real x523 = x299 * 0.15 - x317 * 0.01725;
  const Real x508 = (v[10] * x273 - v[9] * x274) * 2.7e-06;
  const Real x512 = x282 * 0.00264635 - x316 * 0.00264365 + x299 * 0.01725;
  const Real x527 = x302 * 0.15 + x319 * 0.01725;
  // directions in which a loop holds its two links
  const Real x530 = cosine[3] * 0.05;
  const Real x531 = sine[3] * 0.05;
  // joint 7 "right_ball": inertia and bias force of what is beyond, its own motion left open
  const Real x906 = x897 + 0.06 * x898;
  const Real x995 = x262 * x897 + x268 * x924 + x265 * x909;
  const Real x921 = x909 - 0.06 * x910;
  const Real x1053 = x995 - 0.06 * (x997 - x962) + 0.0002466667;
  const Real x899 = x258 * 0.01725;
  const Real x960 = x272 * 0.01725;
  const Real x1054 = 0.006 - x997;
  const Real x912 = x255 * 0.01725;
  // joint 6 "right_motor": inertia and bias force of what is beyond, its own motion left open
  const Real x1073 = cosine[5] * x960;
  const Real x1098 = sine[5] * x898 + cosine[5] * x899;
  const Real x1075 = sine[5] * x1054 - x1073;
  const Real x1110 = x906 - 0.17 * x1098;
  const Real x1127 = sine[5] * x910 + cosine[5] * x912;
  const Real x1084 = x1053 - 0.17 * x1075;
  // joint 5 "left_ball": inertia and bias force of what is beyond, its own motion left open
  const Real x1300 = x145 * 0.00112635;
  const Real x1327 = x151 * 2.7e-06;
  const Real x1365 = x144 * 0.01125;
  const Real x1301 = x153 * 0.01125;
  const Real x1312 = x148 * 0.00112635;
  const Real x1399 = -0.009 - x1365;
  const Real x1313 = x152 * 0.01125;
  const Real x1309 = x1300 + 0.06 * x1301;
  const Real x1324 = x1312 - 0.06 * x1313;
  const Real x1302 = x141 * 0.01125;
  const Real x1398 = x145 * x1300 + x151 * x1327 + x148 * x1312;
  const Real x1455 = x1398 - 0.06 * (x1399 - x1365) + 0.0002466667;
  // joint 4 "left_motor": inertia and bias force of what is beyond, its own motion left open
  const Real x1498 = sine[4] * x1301 + cosine[4] * x1302;
  // joint 3 "ankle_roll": inertia and bias force of what is beyond, its own motion left open
  const Real x1709 = sine[3] * 0.002;
  const Real x1827 = 0.00630833 + cosine[3] * (cosine[3] * 0.0019583400000000003) + 2.4e-05;
  // link 2 "shank": accelerations and constraint forces of loops below it are eliminated
  const Real x2583 = (x2249 + x2293 * x2325) * x2559 - x2581;
  const Real x2599 = (x2263 + x2293 * x2345) * x2559 - x2597;
  const Real x2618 = (x2277 + x2293 * x2365) * x2559 - x2616;
  const Real x2438 = sign_of(x2402) * sqrt_of(x2402 * x2402 + x2434 + x2431);
  const Real x2439 = x2402 + x2438;
  const Real x2442 = x2431 + x2434 + x2439 * x2439;
  const Real x2585 = 1 / x2438 * (x2583 - (x2335 - x2386 * x2397) * x2571);
  // joint 3 "ankle_roll": placement, velocity and reference acceleration of its link
  const Real x68 = v[3] * x66;
  const Real x85 = x77 + x80;
  // link 4 "foot": force that the reference field takes
  const Real x385 = x68 * 0.002999997 - x68 * 0.00826667;
  // link 6 "left_rod": force that the reference field takes
  const Real x463 = (v[6] * x157 - v[5] * x158) * 2.7e-06;
  // link 8 "right_rod": force that the reference field takes
  const Real x515 = x286 * 0.00264635 + x321 * 0.00264365 - x296 * 0.01725;
  // directions in which a loop holds its two links
  const Real x536 = sine[2] * x531;
  // joint 7 "right_ball": inertia and bias force of what is beyond, its own motion left open
  const Real x1033 = x269 * x519 + x270 * x523 + x272 * x527;
  // joint 6 "right_motor": inertia and bias force of what is beyond, its own motion left open
  const Real x1140 = x921 + 0.17 * x1127;
  const Real x1069 = sine[5] * x960;
  const Real x1071 = cosine[5] * x1054 + x1069;
  const Real x1095 = cosine[5] * x898 - sine[5] * x899;
  // joint 5 "left_ball": inertia and bias force of what is beyond, its own motion left open
  const Real x1363 = x155 * 0.01125;
  const Real x1456 = 0.006 - x1399;
  const Real x1315 = x138 * 0.01125;
  // joint 4 "left_motor": inertia and bias force of what is beyond, its own motion left open
  const Real x1474 = cosine[4] * x1363;
  const Real x1509 = x1309 - 0.25 * x1498;
  const Real x1476 = sine[4] * x1456 - x1474;
  const Real x1526 = sine[4] * x1313 + cosine[4] * x1315;
  // joint 2 "ankle_pitch": inertia and bias force of what is beyond, its own motion left open
  const Real x1850 = sine[2] * 0.04 + cosine[2] * x530;
  const Real x1854 = x1827 + 0.4 * x1850;
  const Real x1867 = x1709 + 0.4 * x536;
  // link 2 "shank": accelerations and constraint forces of loops below it are eliminated
  const Real x2444 = 2.0 * (1 / x2442);
  const Real x2450 = x2403 * x2415 - x2179 * x2184 + x2414 * x2439;
  const Real x2451 = x2444 * x2450;
  const Real x2466 = x2403 * x2427 - x2179 * x2190 + x2426 * x2439;
  const Real x2467 = x2444 * x2466;
  const Real x2455 = 0.92 * x2451;
  const Real x2471 = 0.92 * x2467;
  const Real x2457 = x2415 - x2403 * x2451;
  const Real x2458 = x2184 + x2179 * x2451;
  const Real x2474 = x2190 + x2179 * x2467;
  const Real x2473 = x2427 - x2403 * x2467;
  const Real x2484 = 0.8464 + x2455 * x2455;
  const Real x2480 = x2458 * x2458;
  const Real x2600 = x2599 - (x2355 - x2386 * x2409) * x2571;
  const Real x2619 = x2618 - (x2375 - x2386 * x2421) * x2571;
  // link 4 "foot": force that the reference field takes
  const Real x405 = 0.002 * (x89 - x85) + x385 + x55 * 0.05;
  const Real x395 = x70 * 0.004958337 - x70 * 0.00630833 + x83 * 0.002;
  // link 6 "left_rod": force that the reference field takes
  const Real x474 = x181 * 0.15 - x208 * 0.01125;
  const Real x478 = x184 * 0.15 - x202 * 0.01125;
  const Real x467 = x166 * 0.00112635 - x201 * 0.00112365 + x184 * 0.01125;
  const Real x482 = x187 * 0.15 + x204 * 0.01125;
  const Real x470 = x170 * 0.00112635 + x206 * 0.00112365 - x181 * 0.01125;
  // directions in which a loop holds its two links
  const Real x532 = cosine[2] * x531;
  // joint 7 "right_ball": inertia and bias force of what is beyond, its own motion left open
  const Real x1028 = x262 * x512 + x268 * x508 + x265 * x515;
  const Real x892 = x512 - tau[9];
  const Real x1056 = x1028 + 0.06 * x1033 + x224 * 0.006;
  const Real x893 = x515 - tau[10];
  const Real x1051 = -0.006 + x997;
  // joint 6 "right_motor": inertia and bias force of what is beyond, its own motion left open
  const Real x1122 = sine[5] * x912 - cosine[5] * x910;
  const Real x1060 = x1056 - tau[8];
  const Real x1218 = x1073 + sine[5] * x1051;
  const Real x1236 = -0.059500000000000004 - x1218;
  // joint 5 "left_ball": inertia and bias force of what is beyond, its own motion left open
  const Real x1297 = x463 - tau[7];
  const Real x1435 = x152 * x474 + x153 * x478 + x155 * x482;
  const Real x1295 = x467 - tau[5];
  const Real x1430 = x145 * x467 + x151 * x463 + x148 * x470;
  const Real x1296 = x470 - tau[6];
  const Real x1453 = -0.006 + x1399;
  const Real x1457 = x1430 + 0.06 * x1435 + x107 * 0.006;
  // joint 4 "left_motor": inertia and bias force of what is beyond, its own motion left open
  const Real x1484 = x1455 - 0.25 * x1476;
  const Real x1538 = x1324 + 0.25 * x1526;
  const Real x1495 = cosine[4] * x1301 - sine[4] * x1302;
  const Real x1470 = sine[4] * x1363;
  const Real x1472 = cosine[4] * x1456 + x1470;
  const Real x1521 = sine[4] * x1315 - cosine[4] * x1313;
  const Real x1461 = x1457 - tau[4];
  const Real x1617 = x1474 + sine[4] * x1453;
  const Real x1635 = -0.0875 - x1617;
  // joint 3 "ankle_roll": inertia and bias force of what is beyond, its own motion left open
  const Real x1811 = cosine[3] * (x405 - x73 * 0.04);
  const Real x1814 = x1811 - sine[3] * (x395 + x72 * 0.04);
  const Real x1708 = x83 * 0.0019583400000000003 + x72 * 0.05 - tau[3];
  // joint 2 "ankle_pitch": inertia and bias force of what is beyond, its own motion left open
  const Real x1845 = sine[2] * x530 - cosine[2] * 0.04;
  const Real x1832 = x1814 - tau[2];
  const Real x2043 = -0.46 - x1850;
  // link 2 "shank": accelerations and constraint forces of loops below it are eliminated
  const Real x2488 = sign_of(x2457) * sqrt_of(x2457 * x2457 + x2484 + x2480);
  const Real x2489 = x2457 + x2488;
  const Real x2492 = x2480 + x2484 + x2489 * x2489;
  const Real x2602 = 1 / x2488 * ((x2414 - x2439 * x2451) * x2585 + x2600);
  const Real x2494 = 2.0 * (1 / x2492);
  // directions in which a loop holds its two links
  const Real x541 = x155 * 0.15;
  const Real x547 = -0.06 - x144 * 0.15;
  // directions in which a loop holds its two links
  const Real x721 = x272 * 0.23;
  // joint 7 "right_ball": inertia and bias force of what is beyond, its own motion left open
  const Real x1057 = x224 * 0.2 + x1033;
  const Real x1038 = x255 * x519 + x258 * x523 + x261 * x527;
  const Real x1058 = x231 * 0.006 - x229 * 0.2 + x1038;
  // joint 6 "right_motor": inertia and bias force of what is beyond, its own motion left open
  const Real x1279 = sine[5] * x1057 + cosine[5] * x1058;
  // joint 5 "left_ball": inertia and bias force of what is beyond, its own motion left open
  const Real x1458 = x107 * 0.2 + x1435;
  const Real x1440 = x138 * x474 + x141 * x478 + x144 * x482;
  const Real x1459 = x114 * 0.006 - x112 * 0.2 + x1440;
  // joint 6 "right_motor": inertia and bias force of what is beyond, its own motion left open
  const Real x1258 = x1053 - 0.17 * (x1236 - x1218);
  // joint 4 "left_motor": inertia and bias force of what is beyond, its own motion left open
  const Real x1676 = sine[4] * x1458 + cosine[4] * x1459;
  // joint 6 "right_motor": inertia and bias force of what is beyond, its own motion left open
  const Real x1276 = cosine[5] * x1057 - sine[5] * x1058;
  // joint 3 "ankle_roll": inertia and bias force of what is beyond, its own motion left open
  const Real x1823 = cosine[3] * (x73 + x85 * 0.05);
  const Real x1829 = sine[3] * (x72 + x412) + x1823 + x50 * 0.15;
  // link 4 "foot": force that the reference field takes
  const Real x423 = 2.0 * x68 * 0.05 - x89 * 0.04 - x55;
  // joint 3 "ankle_roll": inertia and bias force of what is beyond, its own motion left open
  const Real x1830 = x423 - x55 * 0.15;
  // joint 4 "left_motor": inertia and bias force of what is beyond, its own motion left open
  const Real x1698 = x1455 - 0.25 * (x1635 - x1617) + x1258;
  // joint 2 "ankle_pitch": inertia and bias force of what is beyond, its own motion left open
  const Real x2071 = sine[2] * x1829 + cosine[2] * x1830;
  // joint 4 "left_motor": inertia and bias force of what is beyond, its own motion left open
  const Real x1693 = cosine[5] * x1051 - x1069 + (cosine[4] * x1453 - x1470);
  const Real x1704 = cosine[4] * x1458 - sine[4] * x1459 + x1276;
  const Real x1703 = x1056 - 0.17 * x1279 + (x1457 - 0.25 * x1676);
  // link 2 "shank": accelerations and constraint forces of loops below it are eliminated
  const Real x2501 = x2458 * x2474 + x2455 * x2471 + x2473 * x2489;
  const Real x2502 = x2494 * x2501;
  const Real x2506 = 0.92 * x2502;
  const Real x2511 = x2458 * x2502 - x2474;
  const Real x2512 = x2455 * x2502 - x2471;
  const Real x2620 = (x2426 - x2439 * x2467) * x2585 + x2619;
  const Real x2518 = x2511 * x2511 + x2506 * x2506 + x2512 * x2512;
  const Real x2519 = sqrt_of(x2518);
  const Real x2520 = x2519 * x2519;
  require_more(w, x2520, 9.999999999999998e-15, kLoopSingular, 9);
  // directions in which a loop holds its two links
  const Real x533 = sine[2] * 0.06;
  const Real x537 = cosine[2] * 0.06;
  const Real x561 = x536 - x537 - (cosine[4] * x547 - sine[4] * x541);
  const Real x562 = x530 - (0.05 - x151 * 0.15);
  // directions in which a loop holds its two links
  const Real x727 = -0.06 - x261 * 0.23;
  // link 2 "shank": accelerations and constraint forces of loops below it are eliminated
  const Real x2521 = x2518 + x2520;
  const Real x2622 = 1 / x2519 * ((x2473 - x2489 * x2502) * x2602 + x2620);
  const Real x2523 = 2.0 * (1 / x2521);
  const Real x2624 = x2511 * x2523;
  const Real x2633 = x2506 * x2523;
  const Real x2642 = x2512 * x2523;
  const Real x2653 = x2523 * (x2519 * x2622);
  const Real x2627 = x2506 * x2624;
  const Real x2628 = x2512 * x2624;
  const Real x2635 = x2511 * x2633;
  const Real x2637 = x2512 * x2633;
  const Real x2644 = x2511 * x2642;
  const Real x2645 = x2506 * x2642;
  const Real x2630 = 1.0 - x2511 * x2624;
  const Real x2640 = 1.0 - x2506 * x2633;
  const Real x2650 = 1.0 - x2512 * x2642;
  const Real x2657 = x2511 * x2653;
  const Real x2659 = x2506 * x2653;
  const Real x2661 = x2512 * x2653;
  const Real x2625 = x2519 * x2624;
  const Real x2634 = x2519 * x2633;
  const Real x2643 = x2519 * x2642;
  const Real x3062 = x1327 * x2625;
  const Real x2671 = 0.92 * x2627 + x2455 * x2628 - x2458 * x2630;
  const Real x2672 = x2494 * x2671;
  const Real x3070 = x1327 * x2634;
  const Real x2691 = x2458 * x2635 + x2455 * x2637 - 0.92 * x2640;
  const Real x2692 = x2494 * x2691;
  const Real x3078 = x1327 * x2643;
  const Real x2711 = x2458 * x2644 + 0.92 * x2645 - x2455 * x2650;
  const Real x2712 = x2494 * x2711;
  const Real x2673 = x2489 * x2672;
  const Real x2693 = x2489 * x2692;
  const Real x2713 = x2489 * x2712;
  const Real x2681 = x2630 + x2458 * x2672;
  const Real x2683 = x2455 * x2672 - x2628;
  const Real x2701 = x2458 * x2692 - x2635;
  const Real x2703 = x2455 * x2692 - x2637;
  const Real x2721 = x2458 * x2712 - x2644;
  const Real x2723 = x2650 + x2455 * x2712;
  const Real x2734 = x2489 * x2602 + x2458 * x2657 + 0.92 * x2659;
  const Real x2682 = 0.92 * x2672 - x2627;
  const Real x2738 = x2494 * (x2455 * x2661 + x2734);
  const Real x2702 = x2640 + 0.92 * x2692;
  const Real x2757 = x2179 * x2681 - x2403 * x2673 + 0.92 * x2683;
  const Real x2758 = x2444 * x2757;
  const Real x2722 = 0.92 * x2712 - x2645;
  const Real x2773 = x2179 * x2701 - x2403 * x2693 + 0.92 * x2703;
  const Real x2774 = x2444 * x2773;
  const Real x2748 = x2489 * x2738 - x2602;
  const Real x2749 = x2657 - x2458 * x2738;
  const Real x2789 = x2179 * x2721 - x2403 * x2713 + 0.92 * x2723;
  const Real x2790 = x2444 * x2789;
  const Real x2751 = x2661 - x2455 * x2738;
  const Real x2759 = x2439 * x2758;
  const Real x2775 = x2439 * x2774;
  const Real x2791 = x2439 * x2790;
  const Real x2764 = x2673 + x2403 * x2758;
  const Real x2766 = x2681 - x2179 * x2758;
  const Real x2780 = x2693 + x2403 * x2774;
  const Real x2767 = x2683 - 0.92 * x2758;
  const Real x2796 = x2713 + x2403 * x2790;
  const Real x2782 = x2701 - x2179 * x2774;
  const Real x2783 = x2703 - 0.92 * x2774;
  const Real x3130 = x906 * x2766 + 0.00264635 * x2682;
  const Real x3139 = x921 * x2766 + 0.00264635 * x2767;
  const Real x2824 = x2391 * (x2310 * x2759 + x2316 * x2764);
  const Real x3117 = x1053 * x2766 + x906 * x2682 + x921 * x2767;
  const Real x2840 = x2391 * (x2310 * x2775 + x2316 * x2780);
  const Real x2856 = x2391 * (x2310 * x2791 + x2316 * x2796);
  const Real x2826 = x2386 * x2824;
  const Real x2842 = x2386 * x2840;
  const Real x2858 = x2386 * x2856;
  const Real x2832 = x2310 * x2824 - x2759;
  const Real x2833 = x2316 * x2824 - x2764;
  const Real x2848 = x2310 * x2840 - x2775;
  const Real x2849 = x2316 * x2840 - x2780;
  const Real x2864 = x2310 * x2856 - x2791;
  const Real x2865 = x2316 * x2856 - x2796;
  const Real x3133 = x906 * x2782 + 0.00264635 * x2702;
  const Real x3142 = x921 * x2782 + 0.00264635 * x2783;
  const Real x3122 = x1053 * x2782 + x906 * x2702 + x921 * x2783;
  const Real x2888 = x2220 * x2826 + 1.2 * x2832 + x2217 * x2833;
  const Real x2890 = x2298 * x2888;
  const Real x2806 = x2403 * x2748 - x2439 * x2585 + x2179 * x2749;
  const Real x2911 = x2220 * x2842 + 1.2 * x2848 + x2217 * x2849;
  const Real x2913 = x2298 * x2911;
  const Real x2798 = x2721 - x2179 * x2790;
  const Real x2934 = x2220 * x2858 + 1.2 * x2864 + x2217 * x2865;
  const Real x2936 = x2298 * x2934;
  const Real x2892 = x2293 * x2890;
  const Real x2915 = x2293 * x2913;
  const Real x2938 = x2293 * x2936;
  const Real x2900 = x2826 - x2220 * x2890;
  const Real x2902 = x2833 - x2217 * x2890;
  const Real x2923 = x2842 - x2220 * x2913;
  const Real x2925 = x2849 - x2217 * x2913;
  const Real x2901 = x2832 - 1.2 * x2890;
  const Real x2946 = x2858 - x2220 * x2936;
  const Real x2948 = x2865 - x2217 * x2936;
  const Real x2799 = x2723 - 0.92 * x2790;
  const Real x2924 = x2848 - 1.2 * x2913;
  const Real x2808 = x2444 * (0.92 * x2751 + x2806);
  const Real x2975 = x2164 * x2892 + x2165 * x2900 + 1.2 * x2902;
  const Real x2976 = x2206 * x2975;
  const Real x2989 = x2164 * x2915 + x2165 * x2923 + 1.2 * x2925;
  const Real x2990 = x2206 * x2989;
  const Real x3003 = x2164 * x2938 + x2165 * x2946 + 1.2 * x2948;
  const Real x3004 = x2206 * x3003;
  const Real x2977 = x2202 * x2976;
  const Real x2991 = x2202 * x2990;
  const Real x2982 = x2892 - x2164 * x2976;
  const Real x2983 = x2900 - x2165 * x2976;
  const Real x2984 = x2902 - 1.2 * x2976;
  const Real x2996 = x2915 - x2164 * x2990;
  const Real x2997 = x2923 - x2165 * x2990;
  const Real x3033 = x1827 * x2977 + x1709 * x2982;
  const Real x3050 = x1709 * x2977 + 0.003308333 * x2982;
  const Real x3085 = x1309 * x2983 + 0.00112635 * x2901;
  const Real x3094 = x1324 * x2983 + 0.00112635 * x2984;
  const Real x3039 = x1827 * x2991 + x1709 * x2996;
  const Real x3104 = x1327 * x2983 - 2.7e-06 * x2625;
  const Real x2998 = x2925 - 1.2 * x2990;
  const Real x3054 = x1709 * x2991 + 0.003308333 * x2996;
  const Real x3065 = x1309 * x2901 - x3062 + x1455 * x2983;
  const Real x3066 = x1324 * x2984 + x3065;
  const Real x3379 = x2682 * x3130 + x2767 * x3139 + x2766 * x3117;
  const Real x3088 = x1309 * x2997 + 0.00112635 * x2924;
  const Real x3398 = x2682 * x3133 + x2767 * x3142 + x2766 * x3122;
  const Real x2813 = x2585 + x2439 * x2808;
  const Real x3005 = x2202 * x3004;
  const Real x3010 = x2938 - x2164 * x3004;
  const Real x3136 = x906 * x2798 + 0.00264635 * x2722;
  const Real x3145 = x921 * x2798 + 0.00264635 * x2799;
  const Real x3381 = x2977 * x3033 + x3379 + x2982 * x3050;
  const Real x3097 = x1324 * x2997 + 0.00112635 * x2998;
  const Real x2815 = x2748 - x2403 * x2808;
  const Real x3127 = x1053 * x2798 + x906 * x2722 + x921 * x2799;
  const Real x3383 = x2901 * x3085 + x3381 + x2984 * x3094;
  const Real x3108 = x1327 * x2997 - 2.7e-06 * x2634;
  const Real x3400 = x2977 * x3039 + x3398 + x2982 * x3054;
  const Real x3455 = x2702 * x3133 + x2783 * x3142 + x2782 * x3122;
  const Real x3385 = x3383 - x2625 * x3104 + x2983 * x3066;
  const Real x2947 = x2864 - 1.2 * x2936;
  const Real x3011 = x2946 - x2165 * x3004;
  const Real x3045 = x1827 * x3005 + x1709 * x3010;
  const Real x3925 = 1 / x3385;
  const Real x3073 = x1309 * x2924 - x3070 + x1455 * x2997;
  const Real x3074 = x1324 * x2998 + x3073;
  const Real x3012 = x2948 - 1.2 * x3004;
  const Real x3058 = x1709 * x3005 + 0.003308333 * x3010;
  const Real x3402 = x2901 * x3088 + x3400 + x2984 * x3097;
  const Real x3457 = x2991 * x3039 + x3455 + x2996 * x3054;
  const Real x2871 = x2386 * x2571 - x2310 * x2813 + x2316 * x2815;
  const Real x2872 = x2391 * x2871;
  const Real x3091 = x1309 * x3011 + 0.00112635 * x2947;
  const Real x3417 = x2682 * x3136 + x2767 * x3145 + x2766 * x3127;
  const Real x3404 = x3402 - x2625 * x3108 + x2983 * x3074;
  const Real x3100 = x1324 * x3011 + 0.00112635 * x3012;
  const Real x3474 = x2702 * x3136 + x2783 * x3145 + x2782 * x3127;
  const Real x3459 = x2924 * x3088 + x3457 + x2998 * x3097;
  const Real x3926 = x3404 * x3925;
  const Real x2876 = x2571 - x2386 * x2872;
  const Real x3112 = x1327 * x3011 - 2.7e-06 * x2643;
  const Real x3419 = x2977 * x3045 + x3417 + x2982 * x3058;
  const Real x3461 = x3459 - x2634 * x3108 + x2997 * x3074;
  const Real x2877 = x2813 + x2310 * x2872;
  const Real x3081 = x1309 * x2947 - x3078 + x1455 * x3011;
  const Real x3082 = x1324 * x3012 + x3081;
  const Real x3476 = x2991 * x3045 + x3474 + x2996 * x3058;
  const Real x3531 = x2722 * x3136 + x2799 * x3145 + x2798 * x3127;
  const Real x3931 = x3461 - x3404 * x3926;
  const Real x2879 = x2815 - x2316 * x2872;
  const Real x3421 = x2901 * x3091 + x3419 + x2984 * x3100;
  const Real x3938 = 1 / x3931;
  const Real x3423 = x3421 - x2625 * x3112 + x2983 * x3082;
  const Real x3478 = x2924 * x3091 + x3476 + x2998 * x3100;
  const Real x3533 = x3005 * x3045 + x3531 + x3010 * x3058;
  const Real x2957 = x2293 * x2559 - x2220 * x2876 + 1.2 * x2877;
  const Real x3927 = x3423 * x3925;
  const Real x2959 = x2298 * (x2957 - x2217 * x2879);
  const Real x3480 = x3478 - x2634 * x3112 + x2997 * x3082;
  const Real x3934 = x3480 - x3423 * x3926;
  const Real x3535 = x2947 * x3091 + x3533 + x3012 * x3100;
  const Real x3747 = x1110 * x2682 - x3062 + x1084 * x2766;
  const Real x3939 = x3934 * x3938;
  const Real x3537 = x3535 - x2643 * x3112 + x3011 * x3082;
  const Real x3146 = x924 * x2766;
  const Real x2967 = x2559 - x2293 * x2959;
  const Real x2968 = x2876 + x2220 * x2959;
  const Real x3765 = x1110 * x2702 - x3070 + x1084 * x2782;
  const Real x3946 = x3537 - x3423 * x3927 - x3934 * x3939;
  const Real x2970 = x2879 + x2217 * x2959;
  const Real x3749 = x1140 * x2767 + x3747 + x1509 * x2901;
  const Real x3783 = x1110 * x2722 - x3078 + x1084 * x2798;
  const Real x3953 = 1 / x3946;
  const Real x3937 = x924 * x2782 - x3146 * x3926;
  const Real x2750 = x2659 - 0.92 * x2738;
  const Real x2817 = x2751 - 0.92 * x2808;
  const Real x3767 = x1140 * x2783 + x3765 + x1509 * x2924;
  const Real x3928 = x3146 * x3925;
  const Real x2816 = x2749 - x2179 * x2808;
  const Real x3018 = x2202 * x2551 + x2164 * x2967 + x2165 * x2968;
  const Real x3751 = x3749 - x1854 * x2977 - x1867 * x2982;
  const Real x3785 = x1140 * x2799 + x3783 + x1509 * x2947;
  const Real x3850 = x1075 * x2766 + x1098 * x2682 - x1127 * x2767;
  const Real x3940 = x3937 * x3938;
  const Real x3952 = x924 * x2798 - x3146 * x3927 - x3937 * x3939;
  const Real x2969 = 1.2 * x2959 - x2877;
  const Real x3020 = x2206 * (1.2 * x2970 + x3018);
  const Real x3753 = x1484 * x2983 + x3751 + x1538 * x2984;
  const Real x3769 = x3767 - x1854 * x2991 - x1867 * x2996;
  const Real x3800 = x1071 * x2766 + x1095 * x2682 + x1122 * x2767;
  const Real x3868 = x1075 * x2782 + x1098 * x2702 - x1127 * x2783;
  const Real x3954 = x3952 * x3953;
  const Real x2663 = x2519 * x2653 - x2622;
  const Real x3771 = x1484 * x2997 + x3769 + x1538 * x2998;
  const Real x3787 = x3785 - x1854 * x3005 - x1867 * x3010;
  const Real x3816 = x1071 * x2782 + x1095 * x2702 + x1122 * x2783;
  const Real x3852 = x1498 * x2901 + x3850 + x1850 * x2977;
  const Real x3886 = x1075 * x2798 + x1098 * x2722 - x1127 * x2799;
  const Real x3025 = x2551 - x2202 * x3020;
  const Real x3161 = x892 * x2682 - x1297 * x2625 + x1060 * x2766;
  const Real x3217 = x2750 * x3130 + x2817 * x3139 + x2816 * x3117;
  const Real x3789 = x1484 * x3011 + x3787 + x1538 * x3012;
  const Real x3985 = x3771 - x3753 * x3926;
  const Real x3802 = x1495 * x2901 + x3800 - x1845 * x2977;
  const Real x3832 = x1071 * x2798 + x1095 * x2722 + x1122 * x2799;
  const Real x3870 = x1498 * x2924 + x3868 + x1850 * x2991;
  const Real x3962 = 2.7e-06 - x3146 * x3928 - x3937 * x3940;
  const Real x3963 = x3962 - x3952 * x3954;
  require_more(w, x3963, 4.796163466380676e-21, kLoopFree, 5);
  require_more(w, x3963, 2.7000000000000002e-14, kLoopSingular, 5);
  const Real x3026 = x2967 - x2164 * x3020;
  const Real x3180 = x892 * x2702 - x1297 * x2634 + x1060 * x2782;
  const Real x3235 = x2750 * x3133 + x2817 * x3142 + x2816 * x3122;
  const Real x3818 = x1495 * x2924 + x3816 - x1845 * x2991;
  const Real x3854 = x536 * x2982 + x3852 + x1476 * x2983;
  const Real x3855 = x3854 - x1526 * x2984;
  const Real x3888 = x1498 * x2947 + x3886 + x1850 * x3005;
  const Real x3964 = 1 / x3963;
  const Real x3027 = x2968 - x2165 * x3020;
  const Real x3163 = x893 * x2767 + x3161 + x1295 * x2901;
  const Real x3199 = x892 * x2722 - x1297 * x2643 + x1060 * x2798;
  const Real x3219 = x2969 * x3085 + x3217 + x2663 * x3104;
  const Real x3253 = x2750 * x3136 + x2817 * x3145 + x2816 * x3127;
  const Real x4015 = x3789 - x3753 * x3927 - x3939 * x3985;
  const Real x3804 = x532 * x2982 + x3802 + x1472 * x2983;
  const Real x3805 = x1521 * x2984 + x3804;
  const Real x3834 = x1495 * x2947 + x3832 - x1845 * x3005;
  const Real x3872 = x536 * x2996 + x3870 + x1476 * x2997;
  const Real x3873 = x3872 - x1526 * x2998;
  const Real x3028 = x2970 - 1.2 * x3020;
  const Real x3182 = x893 * x2783 + x3180 + x1295 * x2924;
  const Real x3237 = x2969 * x3088 + x3235 + x2663 * x3108;
  const Real x3820 = x532 * x2996 + x3818 + x1472 * x2997;
  const Real x3821 = x1521 * x2998 + x3820;
  const Real x3890 = x536 * x3010 + x3888 + x1476 * x3011;
  const Real x3891 = x3890 - x1526 * x3012;
  const Real x3991 = x3873 - x3855 * x3926;
  const Real x3165 = x3163 - x1832 * x2977 + x1708 * x2982;
  const Real x3201 = x893 * x2799 + x3199 + x1295 * x2947;
  const Real x3221 = x3219 - x3025 * x3033 + x3026 * x3050;
  const Real x3255 = x2969 * x3091 + x3253 + x2663 * x3112;
  const Real x4065 = x924 - x3753 * x3928 - x3940 * x3985;
  const Real x3836 = x532 * x3010 + x3834 + x1472 * x3011;
  const Real x3837 = x1521 * x3012 + x3836;
  const Real x3988 = x3821 - x3805 * x3926;
  const Real x3184 = x3182 - x1832 * x2991 + x1708 * x2996;
  const Real x3239 = x3237 - x3025 * x3039 + x3026 * x3054;
  const Real x4129 = x3964 * (x4065 - x3954 * x4015);
  const Real x4027 = x3891 - x3855 * x3927 - x3939 * x3991;
  const Real x3203 = x3201 - x1832 * x3005 + x1708 * x3010;
  const Real x3257 = x3255 - x3025 * x3045 + x3026 * x3058;
  const Real x3167 = x1461 * x2983 + x3165 + x1296 * x2984;
  const Real x3261 = x3027 * x3066 + x3221 + x3028 * x3094 + x3167;
  const Real x4021 = x3837 - x3805 * x3927 - x3939 * x3988;
  const Real x3186 = x1461 * x2997 + x3184 + x1296 * x2998;
  const Real x4145 = x3953 * x4015 - x3954 * x4129;
  const Real x3205 = x1461 * x3011 + x3203 + x1296 * x3012;
  const Real x3262 = x3027 * x3074 + x3239 + x3028 * x3097 + x3186;
  const Real x3997 = x3262 - x3261 * x3926;
  const Real x4085 = x3855 * x3928 + x3940 * x3991 + x3954 * x4027;
  const Real x4132 = x3964 * x4085;
  const Real x3263 = x3027 * x3082 + x3257 + x3028 * x3100 + x3205;
  const Real x4175 = x3938 * x3985 - x3940 * x4129 - x3939 * x4145;
  const Real x4075 = x3805 * x3928 + x3940 * x3988 + x3954 * x4021;
  const Real x4130 = x3964 * x4075;
  const Real x4039 = x3263 - x3261 * x3927 - x3939 * x3997;
  const Real x4151 = x3953 * x4027 + x3954 * x4132;
  const Real x4103 = x508 - tau[11] + x924 * x2816 - x3261 * x3928;
  const Real x4225 = x3753 * x3925 - x3928 * x4129 - x3927 * x4145;
  const Real x4226 = x4225 - x3926 * x4175;
  const Real x4148 = x3953 * x4021 + x3954 * x4130;
  const Real x4187 = x3938 * x3991 + x3940 * x4132 - x3939 * x4151;
  const Real x4136 = x3964 * (x4103 - x3940 * x3997 - x3954 * x4039);
  const Real x4387 = x3789 * x4145 + x924 * x4129 + x3771 * x4175;
  const Real x4181 = x3938 * x3988 + x3940 * x4130 - x3939 * x4148;
  // joint 2 "ankle_pitch": inertia and bias force of what is beyond, its own motion left open
  const Real x2088 = x1827 - 0.4 * (x2043 - x1850) + x1698;
  // link 2 "shank": accelerations and constraint forces of loops below it are eliminated
  const Real x4243 = x3855 * x3925 + x3928 * x4132 - x3927 * x4151;
  const Real x4244 = x4243 - x3926 * x4187;
  const Real x3310 = x1327 * x2663 + x1110 * x2750 + x1084 * x2816;
  const Real x4157 = x3953 * x4039 - x3954 * x4136;
  const Real x4522 = x2088 - (x3753 * x4226 + x4387) + 0.18885420000000003;
  require_more(w, x4522, 0.0, kFactorization, 1);
  const Real x4234 = x3805 * x3925 + x3928 * x4130 - x3927 * x4148;
  const Real x4235 = x4234 - x3926 * x4181;
  const Real x4405 = x3789 * x4151 - x924 * x4132 + x3771 * x4187;
  const Real x3312 = x1140 * x2817 + x3310 + x1509 * x2969;
  const Real x4199 = x3938 * x3997 - x3940 * x4136 - x3939 * x4157;
  const Real x4396 = x3789 * x4148 - x924 * x4130 + x3771 * x4181;
  const Real x4465 = x1693 - x1845 + (x3753 * x4235 + x4396);
  const Real x4467 = x1236 + x1635 + x2043 - (x3753 * x4244 + x4405);
  const Real x4523 = -0.7000000000000001 + x4467;
  const Real x3314 = x1854 * x3025 + x3312 - x1867 * x3026;
  const Real x3326 = x1071 * x2816 + x1095 * x2750 + x1122 * x2817;
  const Real x3344 = x1075 * x2816 + x1098 * x2750 - x1127 * x2817;
  const Real x4261 = x3261 * x3925 - x3928 * x4136 - x3927 * x4157;
  const Real x4262 = x4261 - x3926 * x4199;
  const Real x4421 = x3821 * x4181 + x3837 * x4148 + x3805 * x4235;
  const Real x4439 = x3873 * x4187 + x3891 * x4151 + x3855 * x4244;
  // joint 1 "knee": articulated-body inertia and bias force through it
  const Real x4531 = 1 / x4522;
  // link 2 "shank": accelerations and constraint forces of loops below it are eliminated
  const Real x3328 = x1495 * x2969 + x3326 + x1845 * x3025;
  const Real x3346 = x1498 * x2969 + x3344 - x1850 * x3025;
  const Real x3316 = x1484 * x3027 + x3314 + x1538 * x3028;
  const Real x4490 = x3789 * x4157 + x924 * x4136 + x3771 * x4199;
  const Real x3363 = x1814 - 0.4 * x2071 + x1703 + x3316;
  const Real x3330 = x532 * x3026 + x3328 + x1472 * x3027;
  const Real x3348 = x536 * x3026 + x3346 + x1476 * x3027;
  // joint 2 "ankle_pitch": inertia and bias force of what is beyond, its own motion left open
  const Real x2094 = cosine[2] * x1829 - sine[2] * x1830 + x1704;
  // link 2 "shank": accelerations and constraint forces of loops below it are eliminated
  const Real x4496 = x3821 * x4199 + x3837 * x4157 + x3805 * x4262;
  const Real x3365 = x1279 + x1676 + x2071 + (x3348 - x1526 * x3028);
  const Real x4501 = x3873 * x4199 + x3891 * x4157 + x3855 * x4262;
  const Real x4516 = x1521 * x3028 + x3330 + x2094 - x4496;
  const Real x3597 = 2.7e-06 * (x2634 * x2634) + 0.00264635 * (x2702 * x2702);
  const Real x3614 = 2.7e-06 * (x2643 * x2643) + 0.00264635 * (x2722 * x2722);
  // joint 1 "knee": articulated-body inertia and bias force through it
  const Real x4536 = x4465 * x4531;
  const Real x4538 = x4523 * x4531;
  const Real x4572 = 1.85 - x4421 + 3.5 - x4465 * x4536;
  // link 2 "shank": accelerations and constraint forces of loops below it are eliminated
  const Real x4427 = x3821 * x4187 + x3837 * x4151 + x3805 * x4244;
  // joint 1 "knee": articulated-body inertia and bias force through it
  const Real x4644 = x4572 - (1.85 - x4439 + 3.5 - x4523 * x4538);
  // link 2 "shank": accelerations and constraint forces of loops below it are eliminated
  const Real x4527 = x3363 - (x3753 * x4262 + x4490) + x32 * 0.7000000000000001;
  // joint 1 "knee": articulated-body inertia and bias force through it
  const Real x4646 = (x4465 * x4538 - x4427) * (sine[1] * 2.0);
  const Real x4533 = x4531 * (tau[1] - x4527);
  // link 2 "shank": accelerations and constraint forces of loops below it are eliminated
  const Real x4528 = x27 * 3.5 + x36 * 0.7000000000000001 + x4516;
  // joint 1 "knee": articulated-body inertia and bias force through it
  const Real x4597 = x3365 - x4501 - x32 * 3.5 + x4523 * x4533;
  const Real x4663 = 0.4 * (x4572 - cosine[1] * (cosine[1] * x4644 - x4646));
  const Real x4706 = 0.32735000000000003 + 0.4 * x4663;
  require_more(w, x4706, 0.0, kFactorization, 0);
  // directions in which a loop holds its two links
  const Real x558 = -0.25 - (cosine[4] * x541 + sine[4] * x547);
  const Real x560 = x532 + x533 + -0.4 - x558;
  // directions in which a loop holds its two links
  const Real x741 = x536 + x537 + (cosine[5] * x727 - sine[5] * x721);
  const Real x743 = -0.05 - x268 * 0.23 + x530;
  const Real x738 = -0.17 - (cosine[5] * x721 + sine[5] * x727);
  const Real x740 = x533 - x532 + -0.4 - x738;
  // link 2 "shank": accelerations and constraint forces of loops below it are eliminated
  const Real x3580 = 2.7e-06 * (x2625 * x2625) + 0.00264635 * (x2682 * x2682);
  const Real x3598 = x1053 * (x2782 * x2782) + x3597;
  const Real x3615 = x1053 * (x2798 * x2798) + x3614;
  const Real x3581 = x1053 * (x2766 * x2766) + x3580;
  const Real x3599 = 0.00264635 * (x2783 * x2783) + x3598;
  const Real x3616 = 0.00264635 * (x2799 * x2799) + x3615;
  const Real x3582 = 0.00264635 * (x2767 * x2767) + x3581;
  const Real x3600 = 0.00112635 * (x2924 * x2924) + x3599;
  const Real x3617 = 0.00112635 * (x2947 * x2947) + x3616;
  const Real x2102 = v[6] * 0.15 + v[4] * x1339 + v[3] * x637;
  const Real x2103 = v[2] * x1715 + x2102;
  const Real x2112 = v[3] * x673 - (v[5] * 0.15 + v[4] * x1354);
  const Real x2113 = v[2] * x1730 + x2112;
  const Real x2132 = v[10] * 0.23 + v[8] * x936 - v[3] * x812;
  const Real x2133 = v[2] * x1760 + x2132;
  const Real x2143 = v[9] * 0.23 + v[8] * x951 + v[3] * x849;
  const Real x2145 = v[2] * x1774 - x2143;
  const Real x3583 = 0.00112635 * (x2901 * x2901) + x3582;
  const Real x3601 = x1827 * (x2991 * x2991) + x3600;
  const Real x3618 = x1827 * (x3005 * x3005) + x3617;
  const Real x2119 = v[3] * x709 - v[4] * x1361 + v[2] * x1745;
  const Real x2153 = v[2] * x1788 - (v[8] * x958 + v[3] * x886);
  const Real x3584 = x1827 * (x2977 * x2977) + x3583;
  const Real x3602 = 0.003308333 * (x2996 * x2996) + x3601;
  const Real x3619 = 0.003308333 * (x3010 * x3010) + x3618;
  // joint 1 "knee": articulated-body inertia and bias force through it
  const Real x4696 = sine[1] * (x4528 - x4465 * x4533) + cosine[1] * x4597;
  // joint 0 "hip": articulated-body inertia and bias force through it
  const Real x4716 = tau[0] - (tau[1] - 0.4 * x4696 + x9 * 1.2000000000000002);
  const Real x4717 = 1 / x4706 * x4716;
  w.result[0] = x4717;
  // joint 1 "knee": its acceleration, and that of the link beyond
  const Real x4727 = 0.4 * x4717;
  const Real x4729 = sine[1] * x4727;
  const Real x4731 = cosine[1] * x4727;
  const Real x4738 = x4533 - x4536 * x4729 + x4538 * x4731;
  // directions in which a loop holds its two links
  const Real x580 = v[7] * v[7] + x574 + x572 + x80 + 1.0;
  const Real x567 = x561 * x561 + x562 * x562 + x560 * x560;
  const Real x579 = 1e-08 - x567;
  require_more(w, x579, 0.0, kLoopOpen, 8);
  // directions in which a loop holds its two links
  const Real x762 = v[11] * v[11] + x757 + x572 + x80 + 1.0;
  const Real x751 = x741 * x741 + x743 * x743 + x740 * x740;
  const Real x761 = 1e-08 - x751;
  require_more(w, x761, 0.0, kLoopOpen, 9);
  // link 2 "shank": accelerations and constraint forces of loops below it are eliminated
  const Real x3585 = 0.003308333 * (x2982 * x2982) + x3584;
  const Real x3603 = x1455 * (x2997 * x2997) + x3602;
  const Real x3620 = x1455 * (x3011 * x3011) + x3619;
  const Real x3586 = x1455 * (x2983 * x2983) + x3585;
  const Real x3587 = 0.00112635 * (x2984 * x2984) + x3586;
  const Real x3969 = 0.00112635 * (x2998 * x2998) + x3603 + x3461;
  const Real x3972 = 0.00112635 * (x3012 * x3012) + x3620 + x3537;
  const Real x2124 = x2103 * x2103 + x2113 * x2113 + x2119 * x2119;
  const Real x2125 = x580 * 1.0000000000000002e-06 - x2124;
  require_more(w, x2125, 0.0, kLoopTorn, 8);
  const Real x2158 = x2133 * x2133 + x2145 * x2145 + x2153 * x2153;
  const Real x2159 = 1.0000000000000002e-06 * x762 - x2158;
  require_more(w, x2159, 0.0, kLoopTorn, 9);
  const Real x2525 = x2201 * x2201;
  require_more(w, x2525, 9.999999999999998e-15, kLoopSingular, 8);
  const Real x2527 = x2292 * x2292;
  require_more(w, x2527, 9.999999999999998e-15, kLoopSingular, 8);
  const Real x2529 = x2385 * x2385;
  require_more(w, x2529, 9.999999999999998e-15, kLoopSingular, 8);
  const Real x2531 = x2438 * x2438;
  require_more(w, x2531, 9.999999999999998e-15, kLoopSingular, 9);
  const Real x2533 = x2488 * x2488;
  require_more(w, x2533, 9.999999999999998e-15, kLoopSingular, 9);
  const Real x3966 = x3587 * 1.7763568394002505e-15;
  require_more(w, x3385, x3966, kLoopFree, 2);
  const Real x3968 = x3587 * 1e-08;
  require_more(w, x3385, x3968, kLoopSingular, 2);
  const Real x3970 = 1.7763568394002505e-15 * x3969;
  require_more(w, x3931, x3970, kLoopFree, 3);
  const Real x3971 = 1e-08 * x3969;
  require_more(w, x3931, x3971, kLoopSingular, 3);
  const Real x3973 = 1.7763568394002505e-15 * x3972;
  require_more(w, x3946, x3973, kLoopFree, 4);
  const Real x3974 = 1e-08 * x3972;
  require_more(w, x3946, x3974, kLoopSingular, 4);
  // joint 1 "knee": its acceleration, and that of the link beyond
  const Real x4739 = x4738 - x4717;
  w.result[1] = x4739;
  // link 2 "shank": accelerations and constraint forces of loops below it
  const Real x4747 = x4235 * x4729 + x4244 * x4731 - x4226 * x4738;
  const Real x4774 = x4747 - x4262;
  const Real x4755 = x4181 * x4729 + x4187 * x4731 - x4175 * x4738;
  const Real x4775 = x4755 - x4199;
  const Real x4763 = x4148 * x4729 + x4151 * x4731 - x4145 * x4738;
  const Real x4776 = x4763 - x4157;
  const Real x4772 = x4130 * x4729 + x4132 * x4731 + x4129 * x4738;
  const Real x4787 = x2977 * x4774 + x2991 * x4775 + x3005 * x4776;
  const Real x4834 = x3025 - x4787;
  w.result[2] = x4834;
  const Real x4793 = x2982 * x4774 + x2996 * x4775 + x3010 * x4776;
  const Real x4835 = x3026 + x4793;
  w.result[3] = x4835;
  const Real x4798 = x2983 * x4774 + x2997 * x4775 + x3011 * x4776;
  const Real x4836 = x3027 + x4798;
  w.result[4] = x4836;
  const Real x4803 = x2901 * x4774 + x2924 * x4775 + x2947 * x4776;
  const Real x4837 = x2969 + x4803;
  w.result[5] = x4837;
  const Real x4808 = x2984 * x4774 + x2998 * x4775 + x3012 * x4776;
  const Real x4838 = x3028 + x4808;
  w.result[6] = x4838;
  const Real x4817 = x2625 * x4774 + x2634 * x4775 + x2643 * x4776;
  const Real x4839 = x2663 - x4817;
  w.result[7] = x4839;
  const Real x4823 = x2766 * x4774 + x2782 * x4775 + x2798 * x4776;
  const Real x4840 = x2816 + x4823;
  w.result[8] = x4840;
  const Real x4828 = x2682 * x4774 + x2702 * x4775 + x2722 * x4776;
  const Real x4841 = x2750 + x4828;
  w.result[9] = x4841;
  const Real x4833 = x2767 * x4774 + x2783 * x4775 + x2799 * x4776;
  const Real x4842 = x2817 + x4833;
  w.result[10] = x4842;
  const Real x4778 = -(x4136 + x4772);
  w.result[11] = x4778;
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
