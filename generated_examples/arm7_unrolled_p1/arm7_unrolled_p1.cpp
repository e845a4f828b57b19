// Forward dynamics of "arm7" on 1 process, emitted by adagen 0.1.0 (solver.cpp.j2). Do not edit: generate again. Licence: yours to choose.
// robot     "arm7", 9 joints, 9 degrees of freedom, description sha256 35a799ae72b600eeca178cc12eccff22927d06b6ca76bda0ede3ef5832ebda29
// command   adagen ../models/arm7.urdf --procs 1 --shape=unrolled --name=arm7_unrolled
// input     profile default, sha256 fe36af9ff4727e4941af0e7182db7f87cd64c54109bc287302f720e9ad83c3a8
// options   form segment (articulated-body algorithm), shape unrolled (spatial vectors [angular; linear] in link frames whose joint axes are z), scalar double, channel auto, fixed base, gravity 0.0, 0.0, -9.81
// links     adagen_program.cpp; or, compiled with -DADAGEN_NO_MAIN, a program of yours that includes arm7_unrolled_p1.h
// program   1 process; 0.218 us predicted (default profile)
//           process 0: left_finger_slide | right_finger_slide in 2 lanes, base_yaw .. flange_roll

#include "arm7_unrolled_p1.h"
#define ADAGEN_CALL(word) arm7_unrolled_p1_##word
#define ADAGEN_NAMED(WORD) ARM7_UNROLLED_P1_##WORD
#include "adagen/settings.hpp"

namespace { struct arm7_unrolled_p1_settings : PlainSettings {
  static constexpr int kVersion = 100, kJointCount = 9, kNq = 9, kNv = 9;
  [[maybe_unused]] static constexpr const char* kRobot = "arm7";
}; }  // namespace: a program may load several solvers of one name

#include "adagen/constants.hpp"

constexpr std::array<LinkConstants, kLinkCount> kLinks{ {
    {"pedestal", 0.0, {0.0, 0.0, 0.0}},
    {"turret", 3.6, {0.0, 0.0, 0.1},
     {0.01641, 0.0, 0.0, 0.0, 0.01641, 0.0, 0.0, 0.0, 0.00882}},
    {"upper_arm", 3.1, {0.0, -0.1, 0.0},
     {0.01767, 0.0, 0.0, 0.0, 0.00558, 0.0, 0.0, 0.0, 0.01767}},
    {"elbow_housing", 2.6, {0.0, 0.0, -0.03},
     {0.00898625, 0.0, 0.0, 0.0, 0.00898625, 0.0, 0.0, 0.0, 0.0039325}},
    {"forearm", 2.2, {-0.05, 0.1, 0.0},
     {0.0102483, 0.0, 0.0, 0.0, 0.00275, 0.0, 0.0, 0.0, 0.0102483}},
    {"wrist_housing", 1.7, {0.0, 0.01, -0.08},
     {0.00448729, 0.0, 0.0, 0.0, 0.00448729, 0.0, 0.0, 0.0, 0.00172125}},
    {"wrist", 1.3, {0.04, 0.01, 0.0},
     {0.0013, 0.0, 0.0, 0.0, 0.0013, 0.0, 0.0, 0.0, 0.0013}},
    {"hand", 0.85, {0.008470588235294117, 0.0, 0.08870588235294118},
     {0.0034019064705882356, 0.0, 0.0004946823529411765, 0.0, 0.0014865882352941176, 0.0, 0.0004946823529411765, 0.0, 0.0031133417647058823}},
    {"left_finger", 0.05, {0.03, 0.0, 0.01},
     {3.33333e-06, 0.0, 0.0, 0.0, 1.66667e-05, 0.0, 0.0, 0.0, 1.66667e-05}},
    {"right_finger", 0.05, {0.03, 0.0, 0.01},
     {3.33333e-06, 0.0, 0.0, 0.0, 1.66667e-05, 0.0, 0.0, 0.0, 1.66667e-05}}}};

constexpr std::array<JointConstants, kJointCount> kJoints{ {
    {"base_yaw", JointKind::kRevolute, 0, 0, 1, 0, 1,
     {1.0, 0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 1.0}, {0.0, 0.0, 0.16}},
    {"shoulder_pitch", JointKind::kRevolute, 1, 1, 1, 1, 1,
     {1.0, 0.0, 0.0, 0.0, -3.673205103346574e-06, 0.9999999999932537, 0.0, -0.9999999999932537, -3.673205103346574e-06}, {0.0, 0.0, 0.18}},
    {"upper_arm_roll", JointKind::kRevolute, 2, 2, 1, 2, 1,
     {1.0, 0.0, 0.0, 0.0, -3.673205103346574e-06, -0.9999999999932537, 0.0, 0.9999999999932537, -3.673205103346574e-06}, {0.0, -0.3, 0.0}},
    {"elbow_pitch", JointKind::kRevolute, 3, 3, 1, 3, 1,
     {1.0, 0.0, 0.0, 0.0, -3.673205103346574e-06, -0.9999999999932537, 0.0, 0.9999999999932537, -3.673205103346574e-06}, {0.08, 0.0, 0.0}},
    {"forearm_roll", JointKind::kRevolute, 4, 4, 1, 4, 1,
     {1.0, 0.0, 0.0, 0.0, -3.673205103346574e-06, 0.9999999999932537, 0.0, -0.9999999999932537, -3.673205103346574e-06}, {-0.08, 0.38, 0.0}},
    {"wrist_pitch", JointKind::kRevolute, 5, 5, 1, 5, 1,
     {1.0, 0.0, 0.0, 0.0, -3.673205103346574e-06, -0.9999999999932537, 0.0, 0.9999999999932537, -3.673205103346574e-06}, {0.0, 0.0, 0.0}},
    {"flange_roll", JointKind::kRevolute, 6, 6, 1, 6, 1,
     {1.0, 0.0, 0.0, 0.0, -3.673205103346574e-06, -0.9999999999932537, 0.0, 0.9999999999932537, -3.673205103346574e-06}, {0.09, 0.0, 0.0}},
    {"left_finger_slide", JointKind::kPrismatic, 7, 7, 1, 7, 1,
     {0.0, 1.0, 0.0, 0.0, 0.0, 1.0, 1.0, 0.0, 0.0}, {0.0, 0.0, 0.13}},
    {"right_finger_slide", JointKind::kPrismatic, 7, 8, 1, 8, 1,
     {0.0, -0.9999999999964793, -2.65358979335273e-06, 0.0, 2.65358979335273e-06, -0.9999999999964793, 1.0, 0.0, 0.0}, {0.0, 0.0, 0.13}}}};

// ---- functions ----------------------------------------------------------------------------------

#include "adagen/far_angles.hpp"
#include "adagen/no_channel.hpp"
#include "adagen/unrolled_memory.hpp"

namespace {

struct Workspace : StraightMemory<8, 2, 0> {};

}  // namespace

#include "adagen/unrolled_numbers.hpp"
#include "adagen/unrolled_sines.hpp"
#include "adagen/unrolled.hpp"
#include "adagen/unrolled_wide.hpp"

namespace {

// Each function is a straight line. A value is called x and its number in the expression graph; zeros
// and constants are folded in, common subexpressions are shared, and dead code is left out.
// Frames are the links' own; accelerations are deviations from the field that the links would have
// with all joint accelerations zero.

// =================================================================================================
// Process 0: 1005 products, 831 sums, 7 quotients, 167 of them in lanes
// =================================================================================================

ADAGEN_NOINLINE ADAGEN_AS_IT_STANDS void part_0_0(Workspace& w) {
  ADAGEN_INPUTS
  // joint 1 "shoulder_pitch": placement, velocity and reference acceleration of its link
  const Real x20 = v[0] * 0.9999999999932537;
  const Real x29 = v[1] - v[0] * 3.673205103346574e-06;
  const Real x27 = cosine[1] * x20;
  const Real x25 = sine[1] * x20;
  const Real x30 = v[1] * x27;
  const Real x32 = v[1] * x25;
  const Real x59 = x27 * x29;
  // joint 2 "upper_arm_roll": placement, velocity and reference acceleration of its link
  const Real x80 = 3.673205103346574e-06 * x27 + 0.9999999999932537 * x29;
  const Real x95 = 3.673205103346574e-06 * x32;
  // joints 7 "left_finger_slide", 8 "right_finger_slide": placement, velocity and reference acceleration of their links
  const Two x558 = Two{q[7], q[8]};
  const Two x561 = Two{v[7], v[8]};
  const Two x569 = x558 * Two{0.0, 2.65358979335273e-06};
  const Two x571 = x558 * Two{1.0, -0.9999999999964793};
  // joints 7 "left_finger_slide", 8 "right_finger_slide": articulated-body inertia and bias force through them
  const Two x1111 = Two{tau[7], tau[8]};
  const Two x1203 = x569 * Two{0.0, 1.3267948966763652e-09};
  const Two x1172 = x571 * Two{0.0005, -0.0004999999999982397};
  const Two x1168 = Two{0.0005, -0.0004999999999982397} + x571 * 0.05;
  const Two x1166 = Two{0.0, -1.3267948966763652e-09} - x569 * Two{0.0, 3.5207693956928924e-13} + x571 * Two{0.0, 1.3267948966716939e-07};
  const Two x1156 = Two{-0.0005, 0.0004999999999982397} + x569 * Two{0.0, 1.3267948966716939e-07} - x571 * Two{0.05, 0.04999999999964792};
  const Two x1171 = Two{0.0, 1.3267948966763652e-09} + x569 * 0.05;
  const Two x1201 = x569 * Two{0.0, 5.6332219911062896e-14} + Two{0.0, 2.122871834682184e-10} - x571 * Two{0.0, 2.1228718346747102e-08};
  const Real x1271 = across<2>(x1156);
  const Two x1219 = x569 * Two{0.0, 2.1228718346747102e-08} + Two{-8e-05, 7.999999999971834e-05} - x571 * Two{0.008, 0.007999999999943668};
  const Two x1181 = x1172 + Two{2.16667e-05, 2.166670000897794e-05} + x571 * x1168;
  const Two x1211 = x1203 + Two{0.0012966667000000002, 0.001296666699991022} + x569 * x1171;
  const Real x1266 = across<2>(x1219);
  const Two x1227 = 8.33333e-06 + x1203 + x1172 - x569 * x1166;
  const Two x1228 = x1227 - x571 * x1156;
  const Real x1264 = across<2>(x1168);
  const Real x1283 = 0.007199999999999999 + across<2>(x1166);
  const Two x1191 = x571 * Two{0.0, 1.3267948966763652e-09} + Two{0.0, 3.3833269865128193e-09} + x569 * x1168;
  const Real x1277 = -0.00014399999999999992 + across<2>(x1201);
  const Real x1281 = -0.007199999999999999 + across<2>(x1171);
  const Real x1282 = 0.00317433 + across<2>(x1228);
  require_more(w, x1282, 0.0, kFactorization, 6);
  // joint 6 "flange_roll": articulated-body inertia and bias force through it
  const Real x1392 = 2.0 * sine[6];
  const Real x1300 = 1 / x1282;
  const Real x1351 = sine[6] * x1264 + cosine[6] * x1281;
  // joint 1 "shoulder_pitch": placement, velocity and reference acceleration of its link
  const Real x55 = x25 * x27;
  const Real x37 = sine[1] * 9.809999999933819;
  // joint 2 "upper_arm_roll": placement, velocity and reference acceleration of its link
  const Real x94 = 0.9999999999932537 * x27 - 3.673205103346574e-06 * x29 + v[2];
  const Real x89 = sine[2] * x80 - x25 * cosine[2];
  const Real x93 = x25 * sine[2] + cosine[2] * x80;
  const Real x120 = (x25 * x25 + x29 * x29) * 0.3;
  const Real x122 = x120 - cosine[1] * 9.809999999933819;
  const Real x125 = -3.603414206382989e-05 + (x30 + x59) * 0.3;
  const Real x97 = 0.9999999999932537 * x32;
  const Real x114 = x30 * sine[2] - cosine[2] * x95 - v[2] * x89;
  const Real x118 = x37 + x55 * 0.3;
  const Real x129 = 0.9999999999932537 * x125 - 3.673205103346574e-06 * x122;
  const Real x162 = x89 * x94;
  const Real x111 = v[2] * x93 - (x30 * cosine[2] + sine[2] * x95);
  const Real x134 = 0.9999999999932537 * x122 + 3.673205103346574e-06 * x125;
  const Real x143 = sine[2] * x118 + cosine[2] * x129;
  const Real x148 = x93 * x93;
  // joint 3 "elbow_pitch": placement, velocity and reference acceleration of its link
  const Real x174 = 0.9999999999932537 * x94 - 3.673205103346574e-06 * x93;
  const Real x193 = 3.673205103346574e-06 * x114 + 0.9999999999932537 * x97;
  // joint 6 "flange_roll": articulated-body inertia and bias force through it
  const Real x1305 = x1271 * x1300;
  const Real x1306 = x1283 * x1300;
  const Real x1303 = x1277 * x1300;
  const Real x1304 = x1266 * x1300;
  const Real x1330 = 0.9499999999996479 - x1271 * x1305;
  const Real x1336 = 0.850000000000352 - x1283 * x1306;
  const Real x1333 = -1.3267948966716939e-07 - x1271 * x1306;
  const Real x1315 = 2.1228718346747102e-08 - x1277 * x1305;
  const Real x1318 = -0.07540000000005632 - x1277 * x1306;
  const Real x1324 = 0.09139999999994367 - x1266 * x1305;
  const Real x1327 = -2.1228718346747102e-08 - x1266 * x1306;
  const Real x1309 = 0.01009033 + across<2>(x1181) - x1277 * x1303;
  const Real x1321 = 0.008236 + across<2>(x1211) - x1266 * x1304;
  const Real x1312 = across<2>(x1191) - x1277 * x1304;
  const Real x1418 = cosine[6] * (x1330 - x1336) - x1333 * x1392;
  const Real x1357 = cosine[6] * (x1315 - x1327) - sine[6] * (x1318 + x1324);
  const Real x1422 = cosine[6] * x1418;
  const Real x1396 = cosine[6] * (x1309 - x1321) - x1312 * x1392;
  const Real x1362 = cosine[6] * x1357;
  const Real x1424 = x1330 - x1422;
  const Real x1400 = cosine[6] * x1396;
  const Real x1364 = x1315 - x1362;
  const Real x1402 = x1309 - x1400;
  const Real x1429 = 3.673205103346574e-06 * (x1424 - 0.95);
  const Real x1358 = sine[6] * x1357;
  const Real x1406 = 3.673205103346574e-06 * x1402;
  const Real x1382 = 3.673205103346574e-06 * x1364 + 0.9999999999932537 * x1351;
  const Real x1433 = 3.673205103346574e-06 * x1429;
  // joint 2 "upper_arm_roll": placement, velocity and reference acceleration of its link
  const Real x139 = sine[2] * x129 - cosine[2] * x118;
  // joint 3 "elbow_pitch": placement, velocity and reference acceleration of its link
  const Real x183 = x89 * cosine[3] + sine[3] * x174;
  const Real x187 = cosine[3] * x174 - x89 * sine[3];
  const Real x188 = v[3] - (0.9999999999932537 * x93 + 3.673205103346574e-06 * x94);
  const Real x220 = x143 + (x89 * x93 - x97) * 0.08;
  const Real x222 = (x162 - x114) * 0.08 - x134;
  const Real x199 = 3.673205103346574e-06 * x97 - 0.9999999999932537 * x114;
  const Real x214 = x111 * sine[3] + cosine[3] * x193 + v[3] * x183;
  const Real x246 = x188 * x188;
  const Real x249 = x183 * x187;
  const Real x259 = x183 * x188;
  const Real x211 = x111 * cosine[3] - sine[3] * x193 + v[3] * x187;
  const Real x218 = x139 - (x148 + x94 * x94) * 0.08;
  const Real x226 = 0.9999999999932537 * x222 - 3.673205103346574e-06 * x220;
  const Real x251 = x199 + x249;
  const Real x252 = x183 * x183 + x246;
  const Real x254 = x187 * x188;
  const Real x260 = x214 + x259;
  const Real x231 = 0.9999999999932537 * x220 + 3.673205103346574e-06 * x222;
  const Real x256 = x211 + x254;
  // joint 4 "forearm_roll": placement, velocity and reference acceleration of its link
  const Real x273 = 3.673205103346574e-06 * x187 + 0.9999999999932537 * x188;
  const Real x294 = 3.673205103346574e-06 * x214 - 0.9999999999932537 * x199;
  // joint 6 "flange_roll": articulated-body inertia and bias force through it
  const Real x1411 = 3.673205103346574e-06 * x1406;
  const Real x1384 = 0.9999999999932537 * x1382;
  const Real x1435 = 0.95 + x1433;
  const Real x1348 = cosine[6] * x1264 - sine[6] * x1281;
  const Real x1360 = x1318 + x1358;
  const Real x1387 = 3.673205103346574e-06 * x1382;
  const Real x1431 = 0.9999999999932537 * x1429;
  const Real x1448 = 0.09 * x1435 - x1384;
  const Real x1389 = x1364 - x1387;
  const Real x1436 = x1424 - x1433;
  const Real x1444 = 0.09 * x1431;
  const Real x1476 = x1402 - x1411 - 0.09 * x1384 + 0.09 * x1448;
  const Real x1523 = 0.00351 + x1476;
  require_more(w, x1523, 0.0, kFactorization, 5);
  const Real x1372 = 3.673205103346574e-06 * x1360 + 0.9999999999932537 * x1348;
  const Real x1386 = x1351 - x1384;
  const Real x1399 = x1312 + sine[6] * x1396;
  const Real x1446 = x1387 + x1444;
  const Real x1451 = x1386 - 0.09 * x1436;
  const Real x1421 = x1333 + sine[6] * x1418;
  // joint 5 "wrist_pitch": articulated-body inertia and bias force through it
  const Real x1537 = 1 / x1523;
  // joint 3 "elbow_pitch": placement, velocity and reference acceleration of its link
  const Real x239 = cosine[3] * x226 - sine[3] * x218;
  const Real x247 = x187 * x187 + x246;
  const Real x250 = x249 - x199;
  const Real x235 = cosine[3] * x218 + sine[3] * x226;
  // joint 4 "forearm_roll": placement, velocity and reference acceleration of its link
  const Real x282 = x183 * cosine[4] - sine[4] * x273;
  const Real x287 = x183 * sine[4] + cosine[4] * x273;
  const Real x289 = 0.9999999999932537 * x187 - 3.673205103346574e-06 * x188 + v[4];
  const Real x325 = x239 - (0.08 * x251 + x252 * 0.38);
  const Real x331 = x256 * 0.38 - (x231 + 0.08 * x260);
  const Real x299 = 0.9999999999932537 * x214 + 3.673205103346574e-06 * x199;
  const Real x313 = cosine[4] * x294 - x211 * sine[4] - v[4] * x282;
  const Real x318 = 0.08 * x247 + x250 * 0.38 + x235;
  const Real x336 = 3.673205103346574e-06 * x325 + 0.9999999999932537 * x331;
  const Real x310 = x211 * cosine[4] + sine[4] * x294 - v[4] * x287;
  const Real x341 = 0.9999999999932537 * x325 - 3.673205103346574e-06 * x331;
  const Real x350 = sine[4] * x318 + cosine[4] * x336;
  // joint 5 "wrist_pitch": placement, velocity and reference acceleration of its link
  const Real x387 = 3.673205103346574e-06 * x287 + 0.9999999999932537 * x289;
  const Real x405 = 3.673205103346574e-06 * x313 + 0.9999999999932537 * x299;
  const Real x395 = x282 * cosine[5] + sine[5] * x387;
  // joint 6 "flange_roll": articulated-body inertia and bias force through it
  const Real x1377 = 0.9999999999932537 * x1360 - 3.673205103346574e-06 * x1348;
  const Real x1459 = 0.9999999999932537 * x1399 - 0.09 * x1372;
  const Real x1471 = 0.09 * x1446 - (0.9999999999932537 * x1406 + 0.09 * x1389);
  const Real x1361 = x1324 + x1358;
  const Real x1425 = 3.673205103346574e-06 * x1421;
  const Real x1524 = 0.9999999999932537 * x1361 - 0.09 * x1425 + -0.013000000000000001;
  const Real x1525 = 0.052000000000000005 + x1448;
  const Real x1427 = 0.9999999999932537 * x1421;
  // joint 5 "wrist_pitch": articulated-body inertia and bias force through it
  const Real x1540 = x1459 * x1537;
  const Real x1541 = x1471 * x1537;
  const Real x1547 = x1321 + x1400 + 0.0014299999999999998 - x1459 * x1540;
  // joint 6 "flange_roll": articulated-body inertia and bias force through it
  const Real x1521 = x1411 - 0.09 * x1386 - 0.09 * x1451 + 0.00338;
  // joint 5 "wrist_pitch": articulated-body inertia and bias force through it
  const Real x1563 = x1521 - x1471 * x1541;
  // joint 6 "flange_roll": articulated-body inertia and bias force through it
  const Real x1519 = -0.0005200000000000001 - (3.673205103346574e-06 * x1399 + 0.09 * x1377);
  // joint 5 "wrist_pitch": articulated-body inertia and bias force through it
  const Real x1550 = x1519 - x1459 * x1541;
  const Real x1652 = 2.0 * sine[5];
  const Real x1542 = x1524 * x1537;
  const Real x1543 = x1525 * x1537;
  // joint 4 "forearm_roll": placement, velocity and reference acceleration of its link
  const Real x345 = cosine[4] * x318 - sine[4] * x336;
  // joint 5 "wrist_pitch": placement, velocity and reference acceleration of its link
  const Real x399 = cosine[5] * x387 - x282 * sine[5];
  const Real x400 = 0.9999999999932537 * x287 - 3.673205103346574e-06 * x289 + v[5];
  const Real x411 = 3.673205103346574e-06 * x299 - 0.9999999999932537 * x313;
  const Real x426 = x310 * sine[5] + cosine[5] * x405 + v[5] * x395;
  const Real x431 = 3.673205103346574e-06 * x350 + 0.9999999999932537 * x341;
  const Real x452 = x395 * x399;
  const Real x462 = x395 * x400;
  const Real x454 = x411 + x452;
  const Real x463 = x426 + x462;
  const Real x436 = 0.9999999999932537 * x350 - 3.673205103346574e-06 * x341;
  const Real x443 = cosine[5] * x431 - x345 * sine[5];
  const Real x449 = x400 * x400;
  const Real x423 = x310 * cosine[5] - sine[5] * x405 + v[5] * x399;
  const Real x450 = x399 * x399 + x449;
  // joint 6 "flange_roll": placement, velocity and reference acceleration of its link
  const Real x474 = 0.9999999999932537 * x400 - 3.673205103346574e-06 * x399;
  const Real x483 = x395 * cosine[6] + sine[6] * x474;
  const Real x487 = cosine[6] * x474 - x395 * sine[6];
  const Real x488 = v[6] - (0.9999999999932537 * x399 + 3.673205103346574e-06 * x400);
  const Real x492 = 3.673205103346574e-06 * x426 + 0.9999999999932537 * x411;
  const Real x514 = x443 + x454 * 0.09;
  const Real x516 = x436 + x463 * 0.09;
  // joint 6 "flange_roll": articulated-body inertia and bias force through it
  const Real x1452 = x1389 - x1444;
  // joint 5 "wrist_pitch": articulated-body inertia and bias force through it
  const Real x1656 = cosine[5] * (x1547 - x1563) - x1550 * x1652;
  const Real x1576 = x1336 + x1422 + 1.3 - x1524 * x1542;
  const Real x1586 = 1.3 + x1435 - x1525 * x1543;
  const Real x1660 = cosine[5] * x1656;
  const Real x1553 = x1327 + x1362 - x1459 * x1542;
  const Real x1556 = x1372 + x1459 * x1543;
  const Real x1566 = 3.673205103346574e-06 * x1361 + 0.09 * x1427 + x1471 * x1542;
  const Real x1570 = x1446 - x1471 * x1543;
  const Real x1579 = x1425 + x1524 * x1543;
  const Real x1662 = x1547 - x1660;
  const Real x1544 = x1452 * x1537;
  const Real x1666 = 3.673205103346574e-06 * x1662;
  const Real x1685 = cosine[5] * (x1576 - x1586) + x1579 * x1652;
  const Real x1670 = 3.673205103346574e-06 * x1666;
  const Real x1560 = 0.013000000000000001 + x1377 - x1459 * x1544;
  const Real x1573 = -0.052000000000000005 + x1451 - x1471 * x1544;
  const Real x1583 = x1427 - x1524 * x1544;
  const Real x1589 = x1431 + x1525 * x1544;
  const Real x1617 = cosine[5] * (x1553 - x1570) + sine[5] * (x1556 + x1566);
  const Real x1689 = cosine[5] * x1685;
  // joint 5 "wrist_pitch": placement, velocity and reference acceleration of its link
  const Real x439 = x345 * cosine[5] + sine[5] * x431;
  // joint 6 "flange_roll": placement, velocity and reference acceleration of its link
  const Real x497 = 0.9999999999932537 * x426 - 3.673205103346574e-06 * x411;
  const Real x538 = x483 * x483;
  const Real x539 = x487 * x487;
  const Real x540 = x488 * x488;
  const Real x543 = x483 * x487;
  const Real x512 = x439 - x450 * 0.09;
  const Real x520 = 0.9999999999932537 * x516 - 3.673205103346574e-06 * x514;
  const Real x541 = x539 + x540;
  const Real x545 = x497 + x543;
  const Real x506 = x423 * cosine[6] + sine[6] * x492 + v[6] * x487;
  const Real x509 = cosine[6] * x492 - x423 * sine[6] - v[6] * x483;
  const Real x548 = x487 * x488;
  const Real x553 = x483 * x488;
  const Real x529 = cosine[6] * x512 + sine[6] * x520;
  const Real x533 = cosine[6] * x520 - sine[6] * x512;
  const Real x549 = x548 - x506;
  const Real x555 = x509 + x553;
  // joints 7 "left_finger_slide", 8 "right_finger_slide": placement, velocity and reference acceleration of their links
  const Two x574 = x483 * Two{1.0, -0.9999999999964793} + x487 * Two{0.0, 2.65358979335273e-06};
  const Two x578 = x487 * Two{1.0, -0.9999999999964793} - x483 * Two{0.0, 2.65358979335273e-06};
  const Two x591 = x541 * x569 + (x543 - x497) * x571 + x529;
  const Two x592 = x555 * 0.13 + x591;
  const Two x600 = x533 - (x545 * x569 + (x538 + x540) * x571);
  const Two x601 = x549 * 0.13 + x600;
  const Two x585 = x509 * Two{1.0, -0.9999999999964793} - x506 * Two{0.0, 2.65358979335273e-06};
  // joint 5 "wrist_pitch": articulated-body inertia and bias force through it
  const Real x1593 = 1.3 + x1436 - x1452 * x1544;
  const Real x1622 = cosine[5] * x1617;
  const Real x1691 = x1576 - x1689;
  const Real x1757 = x1662 - x1670 + 0.00189125;
  require_more(w, x1757, 0.0, kFactorization, 4);
  const Real x1610 = sine[5] * x1560 + cosine[5] * x1573;
  const Real x1618 = sine[5] * x1617;
  const Real x1624 = x1553 - x1622;
  const Real x1680 = sine[5] * x1583 - cosine[5] * x1589;
  const Real x1621 = x1618 - x1566;
  const Real x1642 = 3.673205103346574e-06 * x1624 + 0.9999999999932537 * x1610;
  const Real x1708 = 3.673205103346574e-06 * (x1691 - x1593) + x1680 * 1.9999999999865075;
  const Real x1644 = 0.9999999999932537 * x1642;
  const Real x1713 = 3.673205103346574e-06 * x1708;
  const Real x1758 = -0.017 + 0.9999999999932537 * x1621;
  const Real x1607 = cosine[5] * x1560 - sine[5] * x1573;
  const Real x1620 = x1618 - x1556;
  const Real x1659 = x1550 + sine[5] * x1656;
  const Real x1676 = cosine[5] * x1583 + sine[5] * x1589;
  const Real x1688 = sine[5] * x1685 - x1579;
  // joint 4 "forearm_roll": articulated-body inertia and bias force through it
  const Real x1769 = 1 / x1757;
  const Real x1774 = x1758 * x1769;
  const Real x1775 = x1644 * x1769;
  // joint 6 "flange_roll": placement, velocity and reference acceleration of its link
  const Real x551 = x538 + x539;
  const Real x525 = 0.9999999999932537 * x514 + 3.673205103346574e-06 * x516;
  const Real x554 = x553 - x509;
  // joints 7 "left_finger_slide", 8 "right_finger_slide": placement, velocity and reference acceleration of their links
  const Two x631 = x488 * x574;
  const Two x636 = x574 * x578;
  const Two x633 = x585 + x631;
  const Two x637 = x636 - x497;
  const Two x581 = x506 * Two{1.0, -0.9999999999964793} + x509 * Two{0.0, 2.65358979335273e-06};
  const Two x614 = Two{1.0, -0.9999999999964793} * x592 + Two{0.0, 2.65358979335273e-06} * x601;
  const Two x626 = x614 - x561 * (2.0 * x488);
  const Two x627 = x574 * x574;
  const Two x641 = x488 * x578;
  const Two x629 = x627 + x578 * x578;
  const Two x639 = x540 + x627;
  const Two x618 = Two{1.0, -0.9999999999964793} * x601 - Two{0.0, 2.65358979335273e-06} * x592;
  // links 8 "left_finger", 9 "right_finger": bias force in the reference field
  const Two x1102 = x633 * 0.0015 + x637 * 0.0005 + x626 * 0.05;
  // joint 5 "wrist_pitch": articulated-body inertia and bias force through it
  const Real x1665 = 0.9999999999932537 * x1659;
  const Real x1755 = 0.00136 - 0.9999999999932537 * x1666;
  const Real x1647 = 3.673205103346574e-06 * x1642;
  const Real x1649 = x1624 - x1647;
  // joint 4 "forearm_roll": articulated-body inertia and bias force through it
  const Real x1772 = x1665 * x1769;
  const Real x1773 = x1755 * x1769;
  const Real x1808 = x1586 + x1689 + 1.7 - x1758 * x1774;
  const Real x1817 = x1593 + x1713 + 1.7 - x1644 * x1775;
  const Real x1811 = x1758 * x1775 - (3.673205103346574e-06 * x1688 + 0.9999999999932537 * x1676);
  const Real x1881 = 2.0 * sine[4];
  const Real x1777 = x1649 * x1769;
  const Real x1780 = x1563 + x1660 + 0.01553729 - x1665 * x1772;
  const Real x1787 = x1570 + x1622 - x1665 * x1774;
  // joint 5 "wrist_pitch": articulated-body inertia and bias force through it
  const Real x1752 = 0.136 - (3.673205103346574e-06 * x1620 + 0.9999999999932537 * x1607);
  // joint 4 "forearm_roll": articulated-body inertia and bias force through it
  const Real x1790 = x1752 + x1665 * x1775;
  const Real x1796 = 0.01536729 + x1670 - x1755 * x1773;
  const Real x1799 = -0.136 - 3.673205103346574e-06 * x1621 - x1755 * x1774;
  const Real x1802 = x1647 + x1755 * x1775;
  const Real x1783 = 3.673205103346574e-06 * x1659 + x1665 * x1773;
  // joints 7 "left_finger_slide", 8 "right_finger_slide": placement, velocity and reference acceleration of their links
  const Two x609 = x525 + x551 * 0.13 + x554 * x569;
  const Two x611 = (x506 + x548) * x571 - x609;
  const Two x623 = x611 + x561 * (2.0 * x574);
  // links 8 "left_finger", 9 "right_finger": bias force in the reference field
  const Two x1107 = (x641 - x581) * 0.0015 - x639 * 0.0005;
  const Two x1071 = x641 * 5.333337e-05 + 1.5e-05 * (x629 - x639);
  const Two x1062 = x497 * 8.33333e-06 - x636 * 5e-06 - x633 * 1.5e-05;
  const Two x1088 = x581 * 6.66667e-05 - x1071 + x623 * 0.0005;
  const Two x1081 = x631 * 5.833337e-05 + x637 * 1.5e-05 + x585 * 6.16667e-05;
  const Two x1091 = x1081 + x626 * 0.0015;
  const Two x1096 = (x581 + x641) * 0.0005 - x629 * 0.0015;
  const Two x1097 = x623 * 0.05 + x1096;
  // joints 7 "left_finger_slide", 8 "right_finger_slide": articulated-body inertia and bias force through them
  const Two x1242 = Two{0.0, 2.65358979335273e-06} * x1102 + Two{1.0, -0.9999999999964793} * x1111;
  const Two x1239 = Two{1.0, -0.9999999999964793} * x1102 - Two{0.0, 2.65358979335273e-06} * x1111;
  const Two x1114 = 20.0 * (x1111 - (x618 * 0.05 + x1107));
  const Two x1257 = x1062 - x626 * 0.0005 - x569 * x1242;
  const Two x1258 = x1257 - x571 * x1239;
  const Two x1119 = x1088 - x618 * 0.0015 - 0.0015 * x1114;
  // joint 4 "forearm_roll": articulated-body inertia and bias force through it
  const Real x1914 = cosine[4] * (x1808 - x1817) - x1811 * x1881;
  const Real x1814 = 0.9999999999932537 * x1688 - 3.673205103346574e-06 * x1676 - x1758 * x1777;
  const Real x1820 = x1680 - 0.9999999999932537 * x1708 + x1644 * x1777;
  const Real x1918 = cosine[4] * x1914;
  // joint 5 "wrist_pitch": articulated-body inertia and bias force through it
  const Real x1753 = 0.9999999999932537 * x1620 - 3.673205103346574e-06 * x1607 + 0.017;
  // joint 4 "forearm_roll": articulated-body inertia and bias force through it
  const Real x1793 = x1753 - x1665 * x1777;
  const Real x1805 = x1610 - x1644 - x1755 * x1777;
  const Real x1823 = x1691 - x1713 + 1.7 - x1649 * x1777;
  const Real x1847 = cosine[4] * (x1787 - x1802) - sine[4] * (x1790 + x1799);
  const Real x1885 = cosine[4] * (x1780 - x1796) + x1783 * x1881;
  const Real x1920 = x1808 - x1918;
  const Real x1852 = cosine[4] * x1847;
  const Real x1889 = cosine[4] * x1885;
  const Real x1909 = sine[4] * x1814 + cosine[4] * x1820;
  const Real x1841 = sine[4] * x1793 + cosine[4] * x1805;
  const Real x1848 = sine[4] * x1847;
  const Real x1854 = x1787 - x1852;
  const Real x1891 = x1780 - x1889;
  const Real x1906 = cosine[4] * x1814 - sine[4] * x1820;
  const Real x1917 = x1811 + sine[4] * x1914;
  const Real x1851 = x1799 + x1848;
  const Real x1896 = 3.673205103346574e-06 * x1891;
  const Real x1919 = x1817 + x1918;
  const Real x1935 = 1.9999999999865075 * x1909 - 3.673205103346574e-06 * (x1920 - x1823);
  // joint 5 "wrist_pitch": placement, velocity and reference acceleration of its link
  const Real x455 = x395 * x395 + x449;
  // link 7 "hand": bias force in the reference field
  const Real x1008 = x497 * 0.00317433 - x543 * 0.0018543300000000004 + x549 * 0.00014399999999999992;
  const Real x997 = x553 * 0.006916 - 0.00014399999999999992 * (x541 - x551);
  const Real x990 = x506 * 0.01009033 - (x548 * 0.00506167 + x545 * 0.00014399999999999992);
  const Real x1015 = x509 * 0.008236 + x997 + x525 * 0.007199999999999999;
  // joints 7 "left_finger_slide", 8 "right_finger_slide": articulated-body inertia and bias force through them
  const Two x1232 = Two{1.0, -0.9999999999964793} * x1119 - Two{0.0, 2.65358979335273e-06} * x1091;
  const Two x1247 = x571 * x1097 - 0.13 * x1242 + x1232;
  const Two x1235 = Two{0.0, 2.65358979335273e-06} * x1119 + Two{1.0, -0.9999999999964793} * x1091;
  const Two x1252 = 0.13 * x1239 + x569 * x1097 + x1235;
  // link 7 "hand": bias force in the reference field
  const Real x1024 = x555 * 0.0754 - x541 * 0.007199999999999999 + x529 * 0.85;
  const Real x1029 = x545 * 0.007199999999999999 + x549 * 0.0754 + x533 * 0.85;
  // joint 6 "flange_roll": articulated-body inertia and bias force through it
  const Real x1302 = x1300 * (tau[6] - (x1008 + x533 * 0.007199999999999999 + across<2>(x1258)));
  const Real x1342 = x1024 + across<2>(x1239) + x1271 * x1302;
  const Real x1344 = x1029 + across<2>(x1242) + x1283 * x1302;
  const Real x1338 = x990 - x533 * 0.0754 + across<2>(x1247) + x1277 * x1302;
  // joint 4 "forearm_roll": articulated-body inertia and bias force through it
  const Real x1857 = 0.9999999999932537 * x1851;
  const Real x1872 = 0.9999999999932537 * x1841 - 3.673205103346574e-06 * x1854;
  const Real x1900 = 3.673205103346574e-06 * x1896;
  const Real x1924 = 0.9999999999932537 * x1906 - 3.673205103346574e-06 * x1917;
  const Real x1938 = 3.673205103346574e-06 * x1935;
  const Real x1873 = 0.9999999999932537 * x1872;
  const Real x1940 = x1823 - x1938;
  const Real x1955 = x1857 + 0.38 * x1919 + 0.08 * x1924;
  const Real x1968 = x1873 + 0.38 * x1924 + 0.08 * x1940;
  const Real x2019 = x1891 - x1900 + 0.38 * x1857 + 0.08 * x1873;
  const Real x2075 = 0.38 * x1955 + x2019 + 0.08 * x1968 + 0.037748300000000005;
  require_more(w, x2075, 0.0, kFactorization, 3);
  // joint 3 "elbow_pitch": articulated-body inertia and bias force through it
  const Real x2088 = 1 / x2075;
  // joint 5 "wrist_pitch": placement, velocity and reference acceleration of its link
  const Real x457 = x399 * x400;
  const Real x459 = x423 + x457;
  // link 6 "wrist": bias force in the reference field
  const Real x929 = x411 * 0.00351 + x452 * 0.0019500000000000001;
  const Real x940 = x929 - 0.0005200000000000001 * (x455 - x450) + x443 * 0.052000000000000005;
  // link 7 "hand": bias force in the reference field
  const Real x1037 = x554 * 0.007199999999999999 - (x525 * 0.85 + x551 * 0.0754);
  // joints 7 "left_finger_slide", 8 "right_finger_slide": articulated-body inertia and bias force through them
  const Real x1298 = x1037 + across<2>(x1097);
  // joint 6 "flange_roll": articulated-body inertia and bias force through it
  const Real x1340 = x529 * 0.0754 + x1015 + across<2>(x1252) + x1266 * x1302;
  const Real x1500 = sine[6] * x1342 + cosine[6] * x1344;
  const Real x1483 = sine[6] * x1338 + cosine[6] * x1340;
  const Real x1505 = 3.673205103346574e-06 * x1500 + 0.9999999999932537 * x1298;
  // joint 4 "forearm_roll": articulated-body inertia and bias force through it
  const Real x1838 = cosine[4] * x1793 - sine[4] * x1805;
  const Real x1850 = x1790 + x1848;
  const Real x1876 = 3.673205103346574e-06 * x1872;
  const Real x1929 = 0.9999999999932537 * x1917 + 3.673205103346574e-06 * x1906;
  const Real x1878 = x1854 + x1876;
  const Real x1888 = sine[4] * x1885 - x1783;
  const Real x1937 = x1909 - 0.9999999999932537 * x1935;
  const Real x1942 = 0.38 * x1929;
  const Real x2076 = -0.22000000000000003 - x1955;
  const Real x2077 = -0.11000000000000001 - x1968;
  const Real x1941 = x1920 + x1938;
  const Real x1944 = x1802 + x1852 - x1942;
  const Real x1947 = 3.673205103346574e-06 * x1851 + 0.08 * x1929;
  const Real x1959 = 0.08 * x1937;
  const Real x1867 = 0.9999999999932537 * x1850 + 3.673205103346574e-06 * x1838;
  const Real x1874 = x1841 - x1873;
  const Real x1958 = 0.9999999999932537 * x1838 - 3.673205103346574e-06 * x1850 + 0.38 * x1937;
  const Real x1961 = x1959 - x1876;
  const Real x1971 = 0.38 * x1941 - x1867;
  const Real x1974 = x1874 + 0.08 * x1941;
  const Real x1976 = x1878 + x1942 - x1959;
  const Real x1993 = 0.38 * x1878 - 0.9999999999932537 * x1888 - 0.38 * x1944;
  const Real x1994 = x1993 - 0.08 * x1958;
  const Real x2008 = 0.9999999999932537 * x1896 + 0.08 * x1878 + 0.38 * x1947;
  const Real x2009 = x2008 - 0.08 * x1961;
  // joint 3 "elbow_pitch": articulated-body inertia and bias force through it
  const Real x2093 = x2076 * x2088;
  const Real x2094 = x2077 * x2088;
  const Real x2126 = 2.2 + x1919 - x2076 * x2093;
  const Real x2136 = 2.2 + x1940 - x2077 * x2094;
  // joint 4 "forearm_roll": placement, velocity and reference acceleration of its link
  const Real x356 = x282 * x282;
  const Real x362 = x282 * x287;
  const Real x376 = x282 * x289;
  // link 6 "wrist": bias force in the reference field
  const Real x910 = x423 * 0.0014299999999999998 + x457 * 0.00013000000000000002 + x463 * 0.0005200000000000001;
  const Real x921 = x426 * 0.00338 + x462 * 0.0020800000000000003 + x459 * 0.0005200000000000001;
  // joint 6 "flange_roll": articulated-body inertia and bias force through it
  const Real x1510 = 0.9999999999932537 * x1500 - 3.673205103346574e-06 * x1298;
  const Real x1517 = 0.9999999999932537 * x1483 - 3.673205103346574e-06 * tau[6] - 0.09 * x1505;
  const Real x1480 = cosine[6] * x1338 - sine[6] * x1340;
  const Real x1513 = 3.673205103346574e-06 * x1483 + 0.9999999999932537 * tau[6] + 0.09 * x1510;
  // joint 5 "wrist_pitch": articulated-body inertia and bias force through it
  const Real x1539 = x1537 * (tau[5] - (x940 - x439 * 0.013000000000000001 + x1517));
  const Real x1595 = x910 + x436 * 0.013000000000000001 + x1480 + x1459 * x1539;
  const Real x1597 = x1471 * x1539 - (x921 + x436 * 0.052000000000000005 + x1513);
  // joint 4 "forearm_roll": articulated-body inertia and bias force through it
  const Real x1981 = x1796 + x1889 - 0.38 * x1867 + 0.38 * x1971;
  const Real x1986 = 0.38 * x1874 - 3.673205103346574e-06 * x1888 + 0.08 * x1971;
  // joint 3 "elbow_pitch": articulated-body inertia and bias force through it
  const Real x2129 = x1924 - x2076 * x2094;
  const Real x2200 = 2.0 * sine[3];
  const Real x2091 = x1994 * x2088;
  const Real x2092 = x2009 * x2088;
  const Real x2095 = x1976 * x2088;
  const Real x2104 = x1944 - x1994 * x2093;
  const Real x2107 = x1958 - x1994 * x2094;
  const Real x2116 = x1947 + x2009 * x2093;
  const Real x2120 = x1961 - x2009 * x2094;
  const Real x2235 = cosine[3] * (x2126 - x2136) - x2129 * x2200;
  const Real x2098 = 0.03224830000000001 + x1981 - x1994 * x2091;
  // joint 4 "forearm_roll": articulated-body inertia and bias force through it
  const Real x2073 = x1900 + 0.08 * x1874 + 0.08 * x1974 + 0.00825;
  // joint 3 "elbow_pitch": articulated-body inertia and bias force through it
  const Real x2113 = x2073 - x2009 * x2092;
  const Real x2132 = x1929 + x2076 * x2095;
  const Real x2139 = x1937 - x2077 * x2095;
  const Real x2239 = cosine[3] * x2235;
  const Real x2101 = 0.011000000000000003 + x1986 - x1994 * x2092;
  const Real x2142 = 2.2 + x1941 - x1976 * x2095;
  const Real x2241 = x2126 - x2239;
  const Real x2110 = 0.22000000000000003 + x1971 - x1994 * x2095;
  const Real x2123 = 0.11000000000000001 + x1974 - x2009 * x2095;
  const Real x2165 = cosine[3] * (x2104 - x2120) - sine[3] * (x2107 - x2116);
  const Real x2230 = cosine[3] * x2139 - sine[3] * x2132;
  // joint 4 "forearm_roll": placement, velocity and reference acceleration of its link
  const Real x367 = x356 + x289 * x289;
  const Real x374 = x356 + x287 * x287;
  const Real x378 = x313 + x376;
  const Real x369 = x287 * x289;
  const Real x364 = x299 - x362;
  // link 5 "wrist_housing": bias force in the reference field
  const Real x857 = x362 * 0.00017 - x299 * 0.00189125 + x378 * 0.00136;
  const Real x839 = x369 * 0.01347604 + 0.00136 * (x374 - x367);
  const Real x861 = x310 * 0.01553729 + x839 + x341 * 0.017;
  const Real x848 = x376 * 0.01364604 - x364 * 0.00136 + x313 * 0.01536729;
  const Real x881 = (x310 + x369) * 0.136 - x367 * 0.017;
  // link 6 "wrist": bias force in the reference field
  const Real x946 = (x452 - x411) * 0.013000000000000001 - x450 * 0.052000000000000005;
  // joint 6 "flange_roll": articulated-body inertia and bias force through it
  const Real x1497 = cosine[6] * x1342 - sine[6] * x1344;
  // link 6 "wrist": bias force in the reference field
  const Real x953 = x454 * 0.052000000000000005 - x455 * 0.013000000000000001 + x443 * 1.3;
  const Real x958 = x436 * 1.3 + x463 * 0.052000000000000005 + x459 * 0.013000000000000001;
  // joint 5 "wrist_pitch": articulated-body inertia and bias force through it
  const Real x1723 = sine[5] * x1595 + cosine[5] * x1597;
  const Real x1599 = x439 * 1.3 + x946 + x1497 + x1524 * x1539;
  const Real x1601 = x953 - x1505 + x1525 * x1539;
  const Real x1603 = x958 + x1510 + x1452 * x1539;
  const Real x1740 = sine[5] * x1599 + cosine[5] * x1601;
  const Real x1733 = 0.9999999999932537 * x1723 - 3.673205103346574e-06 * tau[5];
  // joint 3 "elbow_pitch": articulated-body inertia and bias force through it
  const Real x2170 = cosine[3] * x2165;
  const Real x2204 = cosine[3] * (x2098 - x2113) - x2101 * x2200;
  const Real x2159 = sine[3] * x2110 + cosine[3] * x2123;
  const Real x2172 = x2104 - x2170;
  const Real x2208 = cosine[3] * x2204;
  const Real x2256 = 3.673205103346574e-06 * (x2241 - x2142) + 1.9999999999865075 * x2230;
  const Real x2210 = x2098 - x2208;
  const Real x2261 = 3.673205103346574e-06 * x2256;
  const Real x2190 = 3.673205103346574e-06 * x2172 + 0.9999999999932537 * x2159;
  const Real x2214 = 3.673205103346574e-06 * x2210;
  const Real x2263 = x2142 + x2261;
  const Real x2192 = 0.9999999999932537 * x2190;
  const Real x2218 = 3.673205103346574e-06 * x2214;
  const Real x2275 = 0.08 * x2263 - x2192;
  // link 4 "forearm": bias force in the reference field
  const Real x780 = x199 * 0.037748300000000005 - x249 * 0.023998300000000004;
  // link 5 "wrist_housing": bias force in the reference field
  const Real x887 = x341 * 1.7 + x374 * 0.136;
  // joint 5 "wrist_pitch": articulated-body inertia and bias force through it
  const Real x1720 = cosine[5] * x1595 - sine[5] * x1597;
  const Real x1728 = 3.673205103346574e-06 * x1723 + 0.9999999999932537 * tau[5];
  // link 5 "wrist_housing": bias force in the reference field
  const Real x874 = x364 * 0.017 - x378 * 0.136 + x345 * 1.7;
  // joint 5 "wrist_pitch": articulated-body inertia and bias force through it
  const Real x1745 = 3.673205103346574e-06 * x1740 + 0.9999999999932537 * x1603;
  // link 5 "wrist_housing": bias force in the reference field
  const Real x888 = (x310 - x369) * 0.017 + x887;
  // joint 4 "forearm_roll": articulated-body inertia and bias force through it
  const Real x1771 = x1769 * (tau[4] - (x857 - x345 * 0.017 + x1733));
  const Real x1825 = x861 - x350 * 0.136 + x1720 + x1665 * x1771;
  const Real x1827 = x848 - x345 * 0.136 - x1728 + x1755 * x1771;
  // joint 5 "wrist_pitch": articulated-body inertia and bias force through it
  const Real x1765 = cosine[5] * x1599 - sine[5] * x1601 + x874;
  // joint 4 "forearm_roll": articulated-body inertia and bias force through it
  const Real x1829 = x1765 + x1758 * x1771;
  const Real x1832 = x881 - x350 * 1.7 - x1745 - x1644 * x1771;
  // joint 5 "wrist_pitch": articulated-body inertia and bias force through it
  const Real x1767 = 0.9999999999932537 * x1740 - 3.673205103346574e-06 * x1603 + x888;
  // joint 4 "forearm_roll": articulated-body inertia and bias force through it
  const Real x1834 = x1767 + x1649 * x1771;
  const Real x2028 = sine[4] * x1825 + cosine[4] * x1827;
  const Real x2045 = sine[4] * x1829 + cosine[4] * x1832;
  const Real x2042 = cosine[4] * x1829 - sine[4] * x1832;
  const Real x2049 = 0.9999999999932537 * x1834 - 3.673205103346574e-06 * x2045;
  // joint 3 "elbow_pitch": articulated-body inertia and bias force through it
  const Real x2166 = sine[3] * x2165;
  const Real x2156 = cosine[3] * x2110 - sine[3] * x2123;
  const Real x2168 = x2107 + x2166;
  const Real x2195 = 3.673205103346574e-06 * x2190;
  const Real x2260 = x2230 - 0.9999999999932537 * x2256;
  const Real x2303 = x2210 - x2218 - 0.08 * x2192 + 0.08 * x2275;
  const Real x2349 = 0.0039325 + x2303;
  require_more(w, x2349, 0.0, kFactorization, 2);
  const Real x2197 = x2172 - x2195;
  const Real x2225 = cosine[3] * x2132 + sine[3] * x2139;
  const Real x2238 = x2129 + sine[3] * x2235;
  const Real x2264 = x2241 - x2261;
  const Real x2271 = 0.08 * x2260;
  const Real x2180 = 3.673205103346574e-06 * x2168 + 0.9999999999932537 * x2156;
  const Real x2194 = x2159 - x2192;
  const Real x2207 = x2101 + sine[3] * x2204;
  const Real x2273 = x2195 - x2271;
  const Real x2169 = x2166 - x2116;
  const Real x2246 = 0.9999999999932537 * x2225 - 3.673205103346574e-06 * x2238;
  const Real x2278 = x2194 - 0.08 * x2264;
  const Real x2250 = 0.9999999999932537 * x2238 + 3.673205103346574e-06 * x2225;
  const Real x2286 = 0.9999999999932537 * x2207 - 0.08 * x2180;
  // joint 2 "upper_arm_roll": articulated-body inertia and bias force through it
  const Real x2360 = 1 / x2349;
  // link 4 "forearm": bias force in the reference field
  const Real x792 = 0.011000000000000003 * (x252 - x247) + x780 - x239 * 0.11000000000000001;
  const Real x762 = x211 * 0.03224830000000001 + x254 * 0.029498300000000005 - x260 * 0.011000000000000003;
  const Real x772 = x256 * 0.011000000000000003 - (x214 * 0.00825 + x259 * 0.005500000000000001);
  // joint 4 "forearm_roll": articulated-body inertia and bias force through it
  const Real x2066 = 0.9999999999932537 * x2028 + 3.673205103346574e-06 * tau[4] + 0.38 * x2042;
  const Real x2054 = 0.9999999999932537 * x2045 + 3.673205103346574e-06 * x1834;
  // joint 3 "elbow_pitch": articulated-body inertia and bias force through it
  const Real x2298 = 0.08 * x2273 - (0.9999999999932537 * x2214 + 0.08 * x2197);
  const Real x2185 = 0.9999999999932537 * x2168 - 3.673205103346574e-06 * x2156;
  const Real x2270 = 0.9999999999932537 * x2169 + 0.08 * x2246;
  // joint 4 "forearm_roll": articulated-body inertia and bias force through it
  const Real x2083 = x792 - x235 * 0.22000000000000003 - (0.08 * x2049 + x2066);
  // joint 3 "elbow_pitch": articulated-body inertia and bias force through it
  const Real x2090 = x2088 * (tau[3] - x2083);
  const Real x2279 = x2197 + x2271;
  // joint 2 "upper_arm_roll": articulated-body inertia and bias force through it
  const Real x2363 = x2286 * x2360;
  const Real x2364 = x2298 * x2360;
  const Real x2365 = x2270 * x2360;
  const Real x2366 = x2275 * x2360;
  const Real x2370 = x2113 + x2208 + 0.01132625 - x2286 * x2363;
  // joint 3 "elbow_pitch": articulated-body inertia and bias force through it
  const Real x2347 = x2218 - 0.08 * x2194 - 0.08 * x2278 + 0.01132625;
  // joint 2 "upper_arm_roll": articulated-body inertia and bias force through it
  const Real x2386 = x2347 - x2298 * x2364;
  const Real x2373 = 3.673205103346574e-06 * x2207 + 0.08 * x2185 + x2286 * x2364;
  const Real x2377 = x2120 + x2170 - x2286 * x2365;
  const Real x2380 = 0.078 - x2180 - x2286 * x2366;
  // joint 3 "elbow_pitch": articulated-body inertia and bias force through it
  const Real x2348 = -0.078 - (3.673205103346574e-06 * x2169 + 0.08 * x2250);
  // joint 2 "upper_arm_roll": articulated-body inertia and bias force through it
  const Real x2389 = x2348 - x2298 * x2365;
  const Real x2392 = x2273 - x2298 * x2366;
  const Real x2398 = x2136 + x2239 + 2.6 - x2270 * x2365;
  const Real x2407 = 2.6 + x2263 - x2275 * x2366;
  const Real x2471 = 2.0 * sine[2];
  const Real x2401 = x2246 - x2270 * x2366;
  // joint 2 "upper_arm_roll": placement, velocity and reference acceleration of its link
  const Real x157 = x93 * x94;
  // link 4 "forearm": bias force in the reference field
  const Real x799 = x247 * 0.11000000000000001 + x250 * 0.22000000000000003 + x235 * 2.2;
  const Real x807 = x239 * 2.2 - (x251 * 0.11000000000000001 + x252 * 0.22000000000000003);
  // joint 4 "forearm_roll": articulated-body inertia and bias force through it
  const Real x2058 = cosine[4] * x1825 - sine[4] * x1827 - 0.38 * x2054;
  const Real x2061 = 0.9999999999932537 * tau[4] - 3.673205103346574e-06 * x2028 - 0.08 * x2054;
  // link 4 "forearm": bias force in the reference field
  const Real x815 = x256 * 0.22000000000000003 - (x231 * 2.2 + x260 * 0.11000000000000001);
  // joint 3 "elbow_pitch": articulated-body inertia and bias force through it
  const Real x2148 = x799 + x2042 + x2076 * x2090;
  const Real x2150 = x807 + x2049 + x2077 * x2090;
  const Real x2144 = x762 - x231 * 0.22000000000000003 + x2058 + x1994 * x2090;
  const Real x2146 = x772 - x231 * 0.11000000000000001 + x2061 + x2009 * x2090;
  const Real x2152 = x815 - x2054 + x1976 * x2090;
  const Real x2327 = sine[3] * x2148 + cosine[3] * x2150;
  const Real x2310 = sine[3] * x2144 + cosine[3] * x2146;
  const Real x2332 = 3.673205103346574e-06 * x2327 + 0.9999999999932537 * x2152;
  // joint 2 "upper_arm_roll": articulated-body inertia and bias force through it
  const Real x2475 = cosine[2] * (x2370 - x2386) + x2373 * x2471;
  const Real x2367 = x2279 * x2360;
  const Real x2436 = cosine[2] * (x2377 - x2392) - sine[2] * (x2380 + x2389);
  const Real x2479 = cosine[2] * x2475;
  const Real x2503 = cosine[2] * (x2398 - x2407) - x2401 * x2471;
  const Real x2437 = sine[2] * x2436;
  const Real x2481 = x2370 - x2479;
  const Real x2507 = cosine[2] * x2503;
  const Real x2383 = x2185 - x2286 * x2367;
  const Real x2395 = x2278 - x2298 * x2367;
  const Real x2404 = x2250 - x2270 * x2367;
  const Real x2410 = x2260 - x2275 * x2367;
  const Real x2440 = x2389 + x2437;
  const Real x2485 = 3.673205103346574e-06 * x2481;
  const Real x2441 = cosine[2] * x2436;
  const Real x2509 = x2398 - x2507;
  const Real x2446 = 0.9999999999932537 * x2440;
  const Real x2489 = 3.673205103346574e-06 * x2485;
  const Real x2430 = sine[2] * x2383 + cosine[2] * x2395;
  const Real x2443 = x2377 - x2441;
  const Real x2461 = 3.673205103346574e-06 * x2443 + 0.9999999999932537 * x2430;
  const Real x2521 = 3.673205103346574e-06 * (x2509 - (2.6 + x2264 - x2279 * x2367));
  const Real x2574 = 0.3 * (x2446 + 0.3 * (x2407 + x2507));
  const Real x2517 = 3.673205103346574e-06 * (cosine[2] * x2404 - sine[2] * x2410);
  const Real x2525 = x2521 + 1.9999999999865075 * (sine[2] * x2404 + cosine[2] * x2410);
  // joint 3 "elbow_pitch": articulated-body inertia and bias force through it
  const Real x2337 = 0.9999999999932537 * x2327 - 3.673205103346574e-06 * x2152;
  const Real x2344 = 0.9999999999932537 * x2310 - 3.673205103346574e-06 * tau[3] - 0.08 * x2332;
  // link 3 "elbow_housing": bias force in the reference field
  const Real x722 = x111 * 0.01132625 - x157 * 0.007393749999999999 + x143 * 0.078;
  const Real x725 = x114 * 0.01132625 + x162 * 0.007393749999999999 - x139 * 0.078;
  // joint 3 "elbow_pitch": articulated-body inertia and bias force through it
  const Real x2340 = 3.673205103346574e-06 * x2310 + 0.9999999999932537 * tau[3] + 0.08 * x2337;
  // link 3 "elbow_housing": bias force in the reference field
  const Real x729 = x139 * 2.6 - (x114 + x162) * 0.078;
  const Real x738 = (x89 * x89 + x148) * 0.078 - x134 * 2.6;
  // joint 2 "upper_arm_roll": articulated-body inertia and bias force through it
  const Real x2621 = x2481 - x2489 + 0.3 * x2446 + x2574 + 0.048670000000000005;
  require_more(w, x2621, 0.0, kFactorization, 1);
  const Real x2478 = sine[2] * x2475 - x2373;
  const Real x2454 = 3.673205103346574e-06 * (cosine[2] * x2383 - sine[2] * x2395);
  const Real x2456 = 0.9999999999932537 * (x2380 + x2437) - x2454;
  const Real x2534 = 0.3 * (0.9999999999932537 * (x2401 + sine[2] * x2503) - x2517);
  const Real x2362 = x2360 * (tau[2] - (x2344 - x97 * 0.0039325));
  const Real x2566 = 0.9999999999932537 * x2478 - 0.3 * (x2443 - 3.673205103346574e-06 * x2461);
  const Real x2567 = 0.3 * (x2392 + x2441 - x2534) + x2566;
  const Real x2570 = 0.9999999999932537 * x2485 + 0.3 * (3.673205103346574e-06 * x2440);
  // joint 3 "elbow_pitch": articulated-body inertia and bias force through it
  const Real x2353 = cosine[3] * x2144 - sine[3] * x2146 + x722;
  // joint 2 "upper_arm_roll": articulated-body inertia and bias force through it
  const Real x2415 = x2353 + x2286 * x2362;
  const Real x2417 = x725 - x2340 + x2298 * x2362;
  const Real x2554 = 0.3 * (x2456 - 0.3 * (x2509 - 3.673205103346574e-06 * x2525));
  // joint 3 "elbow_pitch": articulated-body inertia and bias force through it
  const Real x2356 = cosine[3] * x2148 - sine[3] * x2150 + x729;
  // joint 2 "upper_arm_roll": articulated-body inertia and bias force through it
  const Real x2419 = x2356 + x2270 * x2362;
  // joint 3 "elbow_pitch": articulated-body inertia and bias force through it
  const Real x2357 = x143 * 2.6 - (x157 - x111) * 0.078 - x2332;
  // joint 2 "upper_arm_roll": articulated-body inertia and bias force through it
  const Real x2421 = x2357 + x2275 * x2362;
  const Real x2584 = sine[2] * x2415 + cosine[2] * x2417;
  // joint 1 "shoulder_pitch": articulated-body inertia and bias force through it
  const Real x2633 = 1 / x2621;
  const Real x2636 = x2567 * x2633;
  const Real x2637 = x2570 * x2633;
  // joint 2 "upper_arm_roll": articulated-body inertia and bias force through it
  const Real x2618 = x2386 + x2479 - 0.3 * x2456 - x2554 + 0.048670000000000005;
  // joint 1 "shoulder_pitch": articulated-body inertia and bias force through it
  const Real x2645 = x2618 - x2567 * x2636;
  // joint 2 "upper_arm_roll": articulated-body inertia and bias force through it
  const Real x2615 = 0.3 * (cosine[2] * x2419 - sine[2] * x2421);
  const Real x2608 = 0.9999999999932537 * (sine[2] * x2419 + cosine[2] * x2421);
  const Real x2617 = 0.9999999999932537 * x2584 - 3.673205103346574e-06 * tau[2] + x2615;
  const Real x2611 = x2608 - 3.673205103346574e-06 * (x738 + x2337 + x2279 * x2362);
  const Real x2614 = cosine[2] * x2415 - sine[2] * x2417 - 0.3 * x2611;
  const Real x2560 = 3.673205103346574e-06 * x2478 + 0.3 * (x2430 - 0.9999999999932537 * x2461);
  // joint 1 "shoulder_pitch": articulated-body inertia and bias force through it
  const Real x2745 = cosine[1] * (x2645 - (0.00558 + x2489 - x2570 * x2637));
  const Real x2750 = x2745 - (x2567 * x2637 - x2560) * (sine[1] * 2.0);
  const Real x2756 = x2645 - cosine[1] * x2750;
  const Real x2634 = tau[1] - (x2617 - (x55 * 0.04309 + x37 * 0.31000000000000005));
  const Real x2635 = x2633 * x2634;
  // joint 2 "upper_arm_roll": articulated-body inertia and bias force through it
  const Real x2626 = 1.1170584039787268e-05 - (x30 * 0.048670000000000005 + x59 * 0.04309) + x2614;
  const Real x2627 = x32 * 0.00558 - (3.673205103346574e-06 * x2584 + 0.9999999999932537 * tau[2]);
  // joint 1 "shoulder_pitch": articulated-body inertia and bias force through it
  const Real x2888 = x2756 - 3.673205103346574e-06 * (3.673205103346574e-06 * x2756) + 0.00882;
  require_more(w, x2888, 0.0, kFactorization, 0);
  const Real x2849 = sine[1] * (x2626 + x2567 * x2635);
  const Real x2856 = 0.9999999999932537 * (x2849 + cosine[1] * (x2627 - x2570 * x2635));
  // joint 0 "base_yaw": articulated-body inertia and bias force through it
  const Real x2896 = 1 / x2888 * (x2856 + 3.673205103346574e-06 * tau[1] + tau[0]);
  w.result[0] = x2896;
  // joint 1 "shoulder_pitch": its acceleration, and that of the link beyond
  const Real x2905 = 0.9999999999932537 * x2896;
  const Real x2909 = sine[1] * x2905;
  const Real x2911 = cosine[1] * x2905;
  const Real x2918 = x2635 + x2636 * x2909 - x2637 * x2911;
  const Real x2919 = 3.673205103346574e-06 * x2896 + x2918;
  w.result[1] = x2919;
  // joint 2 "upper_arm_roll": its acceleration, and that of the link beyond
  const Real x2921 = 0.3 * x2909;
  const Real x2940 = 0.9999999999932537 * x2921;
  const Real x2941 = 3.673205103346574e-06 * x2921;
  const Real x2920 = 0.3 * x2918;
  const Real x2926 = 3.673205103346574e-06 * x2911 + 0.9999999999932537 * x2918;
  const Real x2945 = cosine[2] * x2920 + sine[2] * x2940;
  const Real x2949 = cosine[2] * x2940 - sine[2] * x2920;
  const Real x2935 = sine[2] * x2926 - cosine[2] * x2909;
  const Real x2939 = sine[2] * x2909 + cosine[2] * x2926;
  const Real x2961 = x2362 + x2367 * x2941 - x2365 * x2945;
  // joint 3 "elbow_pitch": its acceleration, and that of the link beyond
  const Real x2971 = x2941 + 0.08 * x2939;
  // joint 2 "upper_arm_roll": its acceleration, and that of the link beyond
  const Real x2963 = x2961 - x2366 * x2949 - x2363 * x2935;
  const Real x2964 = x2963 - x2364 * x2939;
  const Real x2965 = x2964 - (0.9999999999932537 * x2911 - 3.673205103346574e-06 * x2918);
  w.result[2] = x2965;
  // joint 3 "elbow_pitch": its acceleration, and that of the link beyond
  const Real x2976 = 0.9999999999932537 * x2964 - 3.673205103346574e-06 * x2939;
  const Real x2968 = x2949 + 0.08 * x2964;
  const Real x2985 = cosine[3] * x2935 + sine[3] * x2976;
  const Real x2989 = cosine[3] * x2976 - sine[3] * x2935;
  const Real x2994 = 3.673205103346574e-06 * x2968 + 0.9999999999932537 * x2971;
  const Real x3000 = 3.673205103346574e-06 * x2971 - 0.9999999999932537 * x2968;
  const Real x3004 = cosine[3] * x2945 - sine[3] * x2994;
  const Real x3009 = sine[3] * x2945 + cosine[3] * x2994;
  const Real x3022 = x2090 - x2091 * x2985 - x2092 * x2989;
  const Real x3024 = x3022 - x2095 * x3000 - x2093 * x3004;
  const Real x3025 = x2094 * x3009 + x3024;
  const Real x3026 = 0.9999999999932537 * x2939 + 3.673205103346574e-06 * x2964 + x3025;
  w.result[3] = x3026;
  // joint 4 "forearm_roll": its acceleration, and that of the link beyond
  const Real x3039 = x3000 + 0.08 * x2989 + 0.38 * x2985;
  const Real x3044 = 3.673205103346574e-06 * x2989 + 0.9999999999932537 * x3025;
  const Real x3033 = x3009 + 0.08 * x3025;
  const Real x3030 = x3004 - 0.38 * x3025;
  const Real x3053 = cosine[4] * x2985 - sine[4] * x3044;
  const Real x3058 = sine[4] * x2985 + cosine[4] * x3044;
  const Real x3064 = 3.673205103346574e-06 * x3033 - 0.9999999999932537 * x3039;
  const Real x3069 = 0.9999999999932537 * x3033 + 3.673205103346574e-06 * x3039;
  const Real x3073 = cosine[4] * x3030 + sine[4] * x3064;
  const Real x3077 = cosine[4] * x3064 - sine[4] * x3030;
  const Real x3089 = x1771 - x1772 * x3053 + x1773 * x3058;
  const Real x3091 = x1777 * x3069 + x3089 - x1774 * x3073;
  const Real x3092 = x1775 * x3077 + x3091;
  const Real x3093 = x3092 - (0.9999999999932537 * x2989 - 3.673205103346574e-06 * x3025);
  w.result[4] = x3093;
  // joint 5 "wrist_pitch": its acceleration, and that of the link beyond
  const Real x3114 = 3.673205103346574e-06 * x3077 + 0.9999999999932537 * x3069;
  const Real x3120 = 3.673205103346574e-06 * x3069 - 0.9999999999932537 * x3077;
  const Real x3124 = cosine[5] * x3073 - sine[5] * x3114;
  const Real x3129 = sine[5] * x3073 + cosine[5] * x3114;
  const Real x3097 = 3.673205103346574e-06 * x3058 + 0.9999999999932537 * x3092;
  const Real x3142 = x1539 - x1544 * x3120 - x1542 * x3124;
  const Real x3105 = cosine[5] * x3053 + sine[5] * x3097;
  const Real x3109 = cosine[5] * x3097 - sine[5] * x3053;
  const Real x3144 = x1543 * x3129 + x3142 - x1540 * x3105;
  const Real x3145 = x3144 - x1541 * x3109;
  const Real x3146 = x3145 - (0.9999999999932537 * x3058 - 3.673205103346574e-06 * x3092);
  w.result[5] = x3146;
  // joint 6 "flange_roll": its acceleration, and that of the link beyond
  const Real x3157 = 0.9999999999932537 * x3145 - 3.673205103346574e-06 * x3109;
  const Real x3173 = 0.9999999999932537 * (x3120 - 0.09 * x3109);
  const Real x3174 = x3173 - 3.673205103346574e-06 * (0.09 * x3145 - x3129);
  const Real x3166 = cosine[6] * x3105 + sine[6] * x3157;
  const Real x3170 = cosine[6] * x3157 - sine[6] * x3105;
  const Real x3183 = cosine[6] * x3124 + sine[6] * x3174;
  const Real x3187 = cosine[6] * x3174 - sine[6] * x3124;
  const Real x3197 = x1302 - x1303 * x3166 - x1304 * x3170;
  const Real x3199 = x3197 - x1305 * x3183 - x1306 * x3187;
  const Real x3200 = 0.9999999999932537 * x3109 + 3.673205103346574e-06 * x3145 + x3199;
  w.result[6] = x3200;
  // joints 7 "left_finger_slide", 8 "right_finger_slide": their accelerations, and those of the links beyond
  const Two x3232 = Two{1.0, -0.9999999999964793} * (x3187 - 0.13 * x3166 - x569 * x3199);
  const Two x3230 = Two{0.0, 2.65358979335273e-06} * (x3183 + 0.13 * x3170 - x571 * x3199);
  const Two x3236 = x1114 + 0.03 * (Two{1.0, -0.9999999999964793} * x3166 + Two{0.0, 2.65358979335273e-06} * x3170);
  const Two x3237 = x3236 - (x3232 - x3230);
  put(x3237, w.lanes.data() + 0);
}

// ---- processes ----------------------------------------------------------------------------------

// Process 0: 9 of 9 joints: "base_yaw", "shoulder_pitch", "upper_arm_roll", "elbow_pitch", "forearm_roll", "wrist_pitch", ...
constexpr std::array<int, 9> kRead_0{0, 1, 2, 3, 4, 5, 6, 7, 8};
constexpr std::array<int, 9> kOwned_0{0, 1, 2, 3, 4, 5, 6, 7, 8};
constexpr std::array<int, 7> kAngles_0{0, 1, 2, 3, 4, 5, 6};

ADAGEN_AS_IT_STANDS void run_0([[maybe_unused]] Workspace& w, [[maybe_unused]] Channel& channel) {
  ADAGEN_INPUTS
  if (!all(unlike_zero(q + 0, 1) == 0))
    name_what_is_not_finite(w, kRead_0, kOwned_0);
  take_sines_and_cosines(q, kAngles_0, w.sine.data(), w.cosine.data());
  part_0_0(w);
  stamp(1);
  stamp(2);
  stamp(3);
  if (__builtin_expect(w.status != kFine || !all(unlike_zero(w.result.data() + 0, 7) + unlike_zero<Two, 1>(w.lanes.data() + 0) == 0), 0)) {
    w.result[7] = w.lanes[0];
    w.result[8] = w.lanes[1];
    find_fault(w, kRead_0, kOwned_0);
  }
  if (w.status != kFine) return;
  std::copy_n(w.result.data() + 0, 7, w.qdd + 0);
  w.qdd[7] = w.lanes[0];
  w.qdd[8] = w.lanes[1];
}


}  // namespace

[[maybe_unused]] constexpr std::array<StageInfo, 3> kStages_0{ {{"kinematics", 8, -1}, {"assembly", 0, -1}, {"disassembly", 0, -1}} };

#include "adagen/whole_alone.hpp"
