// Forward dynamics of "arm7" on 2 processes, emitted by adagen 0.1.0 (solver.cpp.j2). Do not edit: generate again. Licence: yours to choose.
// robot     "arm7", 9 joints, 9 degrees of freedom, description sha256 35a799ae72b600eeca178cc12eccff22927d06b6ca76bda0ede3ef5832ebda29
// command   adagen ../models/arm7.urdf --procs 2 --batch --name=arm7_batch
// input     profile default, sha256 fe36af9ff4727e4941af0e7182db7f87cd64c54109bc287302f720e9ad83c3a8
// options   form segment (articulated-body algorithm), shape unrolled (spatial vectors [angular; linear] in link frames whose joint axes are z), scalar double, channel auto, fixed base, gravity 0.0, 0.0, -9.81
// links     adagen_program.cpp -DADAGEN_MPI; or, compiled with -DADAGEN_NO_MAIN, a program of yours that includes arm7_batch_p2.h
// program   1 process; 0.0317 us a state predicted (default profile)
//           process 0: base_yaw .. right_finger_slide
//
// Each SIMD lane holds a state; the processes share the states of a batch, not the robot.

#include "arm7_batch_p2.h"
#define ADAGEN_CALL(word) arm7_batch_p2_##word
#define ADAGEN_NAMED(WORD) ARM7_BATCH_P2_##WORD
#define ADAGEN_MPI
#define ADAGEN_BATCH
#include "adagen/settings.hpp"

namespace { struct arm7_batch_p2_settings : PlainSettings {
  static constexpr int kVersion = 100, kJointCount = 9, kNq = 9, kNv = 9;
  [[maybe_unused]] static constexpr const char* kRobot = "arm7";
  static constexpr int kProcesses = 2;
  static constexpr bool kAlone = false;
  static constexpr bool kBatch = true;
  static constexpr std::size_t kCache = 1048576;
  [[maybe_unused]] static constexpr Hops kHops = {{0, 152, 0.404}, {20.9, 192, 0.602}};
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

[[maybe_unused]] constexpr std::array<MessageInfo, 0> kMessages{};

// ---- functions ----------------------------------------------------------------------------------

#include "adagen/far_angles.hpp"
#include "adagen/channel.hpp"
#include "adagen/unrolled_memory.hpp"

namespace {

struct Workspace : StraightMemory<7, 0, 0> {};

}  // namespace

#include "adagen/unrolled_lanes.hpp"
#include "adagen/unrolled.hpp"

namespace {

// Each function is a straight line. A value is called x and its number in the expression graph; zeros
// and constants are folded in, common subexpressions are shared, and dead code is left out.
// Frames are the links' own; accelerations are deviations from the field that the links would have
// with all joint accelerations zero.

// =================================================================================================
// Each process: 1044 products, 882 sums, 7 quotients
// =================================================================================================

ADAGEN_NOINLINE void part_0_0(Workspace& w) {
  ADAGEN_INPUTS
  // joint 1 "shoulder_pitch": placement, velocity and reference acceleration of its link
  const Lanes x20 = v[0] * 0.9999999999932537;
  const Lanes x25 = sine[1] * x20;
  const Lanes x27 = cosine[1] * x20;
  const Lanes x29 = v[1] - v[0] * 3.673205103346574e-06;
  const Lanes x30 = v[1] * x27;
  const Lanes x32 = v[1] * x25;
  const Lanes x37 = sine[1] * 9.809999999933819;
  const Lanes x55 = x25 * x27;
  const Lanes x59 = x27 * x29;
  // joint 2 "upper_arm_roll": placement, velocity and reference acceleration of its link
  const Lanes x80 = 3.673205103346574e-06 * x27 + 0.9999999999932537 * x29;
  const Lanes x89 = sine[2] * x80 - x25 * cosine[2];
  const Lanes x93 = x25 * sine[2] + cosine[2] * x80;
  const Lanes x94 = 0.9999999999932537 * x27 - 3.673205103346574e-06 * x29 + v[2];
  const Lanes x95 = 3.673205103346574e-06 * x32;
  const Lanes x97 = 0.9999999999932537 * x32;
  const Lanes x111 = v[2] * x93 - (x30 * cosine[2] + sine[2] * x95);
  const Lanes x114 = x30 * sine[2] - cosine[2] * x95 - v[2] * x89;
  const Lanes x118 = x37 + x55 * 0.3;
  const Lanes x120 = (x25 * x25 + x29 * x29) * 0.3;
  const Lanes x122 = x120 - cosine[1] * 9.809999999933819;
  const Lanes x125 = -3.603414206382989e-05 + (x30 + x59) * 0.3;
  const Lanes x129 = 0.9999999999932537 * x125 - 3.673205103346574e-06 * x122;
  const Lanes x134 = 0.9999999999932537 * x122 + 3.673205103346574e-06 * x125;
  const Lanes x139 = sine[2] * x129 - cosine[2] * x118;
  const Lanes x143 = sine[2] * x118 + cosine[2] * x129;
  const Lanes x148 = x93 * x93;
  const Lanes x157 = x93 * x94;
  const Lanes x162 = x89 * x94;
  // joint 3 "elbow_pitch": placement, velocity and reference acceleration of its link
  const Lanes x174 = 0.9999999999932537 * x94 - 3.673205103346574e-06 * x93;
  const Lanes x183 = x89 * cosine[3] + sine[3] * x174;
  const Lanes x187 = cosine[3] * x174 - x89 * sine[3];
  const Lanes x188 = v[3] - (0.9999999999932537 * x93 + 3.673205103346574e-06 * x94);
  const Lanes x193 = 3.673205103346574e-06 * x114 + 0.9999999999932537 * x97;
  const Lanes x199 = 3.673205103346574e-06 * x97 - 0.9999999999932537 * x114;
  const Lanes x211 = x111 * cosine[3] - sine[3] * x193 + v[3] * x187;
  const Lanes x214 = x111 * sine[3] + cosine[3] * x193 + v[3] * x183;
  const Lanes x218 = x139 - (x148 + x94 * x94) * 0.08;
  const Lanes x220 = x143 + (x89 * x93 - x97) * 0.08;
  const Lanes x222 = (x162 - x114) * 0.08 - x134;
  const Lanes x226 = 0.9999999999932537 * x222 - 3.673205103346574e-06 * x220;
  const Lanes x231 = 0.9999999999932537 * x220 + 3.673205103346574e-06 * x222;
  const Lanes x235 = cosine[3] * x218 + sine[3] * x226;
  const Lanes x239 = cosine[3] * x226 - sine[3] * x218;
  const Lanes x246 = x188 * x188;
  const Lanes x247 = x187 * x187 + x246;
  const Lanes x249 = x183 * x187;
  const Lanes x250 = x249 - x199;
  const Lanes x251 = x199 + x249;
  const Lanes x252 = x183 * x183 + x246;
  const Lanes x254 = x187 * x188;
  const Lanes x256 = x211 + x254;
  const Lanes x259 = x183 * x188;
  const Lanes x260 = x214 + x259;
  // link 4 "forearm": bias force in the reference field
  const Lanes x808 = x199 * 0.037748300000000005 - x249 * 0.023998300000000004;
  const Lanes x790 = x211 * 0.03224830000000001 + x254 * 0.029498300000000005 - x260 * 0.011000000000000003;
  const Lanes x800 = x256 * 0.011000000000000003 - (x214 * 0.00825 + x259 * 0.005500000000000001);
  const Lanes x820 = 0.011000000000000003 * (x252 - x247) + x808 - x239 * 0.11000000000000001;
  // joint 4 "forearm_roll": placement, velocity and reference acceleration of its link
  const Lanes x273 = 3.673205103346574e-06 * x187 + 0.9999999999932537 * x188;
  const Lanes x282 = x183 * cosine[4] - sine[4] * x273;
  const Lanes x287 = x183 * sine[4] + cosine[4] * x273;
  const Lanes x289 = 0.9999999999932537 * x187 - 3.673205103346574e-06 * x188 + v[4];
  const Lanes x294 = 3.673205103346574e-06 * x214 - 0.9999999999932537 * x199;
  const Lanes x299 = 0.9999999999932537 * x214 + 3.673205103346574e-06 * x199;
  const Lanes x310 = x211 * cosine[4] + sine[4] * x294 - v[4] * x287;
  const Lanes x313 = cosine[4] * x294 - x211 * sine[4] - v[4] * x282;
  const Lanes x318 = 0.08 * x247 + x250 * 0.38 + x235;
  const Lanes x325 = x239 - (0.08 * x251 + x252 * 0.38);
  const Lanes x331 = x256 * 0.38 - (x231 + 0.08 * x260);
  const Lanes x336 = 3.673205103346574e-06 * x325 + 0.9999999999932537 * x331;
  const Lanes x341 = 0.9999999999932537 * x325 - 3.673205103346574e-06 * x331;
  const Lanes x345 = cosine[4] * x318 - sine[4] * x336;
  const Lanes x350 = sine[4] * x318 + cosine[4] * x336;
  const Lanes x356 = x282 * x282;
  const Lanes x362 = x282 * x287;
  const Lanes x364 = x299 - x362;
  const Lanes x367 = x356 + x289 * x289;
  const Lanes x369 = x287 * x289;
  const Lanes x374 = x356 + x287 * x287;
  const Lanes x376 = x282 * x289;
  const Lanes x378 = x313 + x376;
  // link 5 "wrist_housing": bias force in the reference field
  const Lanes x867 = x369 * 0.01347604 + 0.00136 * (x374 - x367);
  const Lanes x889 = x310 * 0.01553729 + x867 + x341 * 0.017;
  const Lanes x876 = x376 * 0.01364604 - x364 * 0.00136 + x313 * 0.01536729;
  const Lanes x885 = x362 * 0.00017 - x299 * 0.00189125 + x378 * 0.00136;
  const Lanes x909 = (x310 + x369) * 0.136 - x367 * 0.017;
  const Lanes x915 = x341 * 1.7 + x374 * 0.136;
  // joint 5 "wrist_pitch": placement, velocity and reference acceleration of its link
  const Lanes x387 = 3.673205103346574e-06 * x287 + 0.9999999999932537 * x289;
  const Lanes x395 = x282 * cosine[5] + sine[5] * x387;
  const Lanes x399 = cosine[5] * x387 - x282 * sine[5];
  const Lanes x400 = 0.9999999999932537 * x287 - 3.673205103346574e-06 * x289 + v[5];
  const Lanes x405 = 3.673205103346574e-06 * x313 + 0.9999999999932537 * x299;
  const Lanes x411 = 3.673205103346574e-06 * x299 - 0.9999999999932537 * x313;
  const Lanes x423 = x310 * cosine[5] - sine[5] * x405 + v[5] * x399;
  const Lanes x426 = x310 * sine[5] + cosine[5] * x405 + v[5] * x395;
  const Lanes x431 = 3.673205103346574e-06 * x350 + 0.9999999999932537 * x341;
  const Lanes x436 = 0.9999999999932537 * x350 - 3.673205103346574e-06 * x341;
  const Lanes x439 = x345 * cosine[5] + sine[5] * x431;
  const Lanes x443 = cosine[5] * x431 - x345 * sine[5];
  const Lanes x449 = x400 * x400;
  const Lanes x450 = x399 * x399 + x449;
  const Lanes x452 = x395 * x399;
  const Lanes x454 = x411 + x452;
  const Lanes x455 = x395 * x395 + x449;
  const Lanes x457 = x399 * x400;
  const Lanes x459 = x423 + x457;
  const Lanes x462 = x395 * x400;
  const Lanes x463 = x426 + x462;
  // link 6 "wrist": bias force in the reference field
  const Lanes x957 = x411 * 0.00351 + x452 * 0.0019500000000000001;
  const Lanes x938 = x423 * 0.0014299999999999998 + x457 * 0.00013000000000000002 + x463 * 0.0005200000000000001;
  const Lanes x949 = x426 * 0.00338 + x462 * 0.0020800000000000003 + x459 * 0.0005200000000000001;
  const Lanes x968 = x957 - 0.0005200000000000001 * (x455 - x450) + x443 * 0.052000000000000005;
  const Lanes x974 = (x452 - x411) * 0.013000000000000001 - x450 * 0.052000000000000005;
  // joint 6 "flange_roll": placement, velocity and reference acceleration of its link
  const Lanes x474 = 0.9999999999932537 * x400 - 3.673205103346574e-06 * x399;
  const Lanes x483 = x395 * cosine[6] + sine[6] * x474;
  const Lanes x487 = cosine[6] * x474 - x395 * sine[6];
  const Lanes x488 = v[6] - (0.9999999999932537 * x399 + 3.673205103346574e-06 * x400);
  const Lanes x492 = 3.673205103346574e-06 * x426 + 0.9999999999932537 * x411;
  const Lanes x497 = 0.9999999999932537 * x426 - 3.673205103346574e-06 * x411;
  const Lanes x506 = x423 * cosine[6] + sine[6] * x492 + v[6] * x487;
  const Lanes x509 = cosine[6] * x492 - x423 * sine[6] - v[6] * x483;
  const Lanes x512 = x439 - x450 * 0.09;
  const Lanes x514 = x443 + x454 * 0.09;
  const Lanes x516 = x436 + x463 * 0.09;
  const Lanes x520 = 0.9999999999932537 * x516 - 3.673205103346574e-06 * x514;
  const Lanes x525 = 0.9999999999932537 * x514 + 3.673205103346574e-06 * x516;
  const Lanes x529 = cosine[6] * x512 + sine[6] * x520;
  const Lanes x533 = cosine[6] * x520 - sine[6] * x512;
  const Lanes x538 = x483 * x483;
  const Lanes x539 = x487 * x487;
  const Lanes x540 = x488 * x488;
  const Lanes x541 = x539 + x540;
  const Lanes x543 = x483 * x487;
  const Lanes x544 = x543 - x497;
  const Lanes x545 = x497 + x543;
  const Lanes x546 = x538 + x540;
  const Lanes x548 = x487 * x488;
  const Lanes x549 = x548 - x506;
  const Lanes x550 = x506 + x548;
  const Lanes x551 = x538 + x539;
  const Lanes x553 = x483 * x488;
  const Lanes x554 = x553 - x509;
  const Lanes x555 = x509 + x553;
  // link 7 "hand": bias force in the reference field
  const Lanes x1025 = x553 * 0.006916 - 0.00014399999999999992 * (x541 - x551);
  const Lanes x1018 = x506 * 0.01009033 - (x548 * 0.00506167 + x545 * 0.00014399999999999992);
  const Lanes x1043 = x509 * 0.008236 + x1025 + x525 * 0.007199999999999999;
  const Lanes x1036 = x497 * 0.00317433 - x543 * 0.0018543300000000004 + x549 * 0.00014399999999999992;
  // joint 7 "left_finger_slide": placement, velocity and reference acceleration of its link
  const Lanes x560 = x555 * 0.13;
  const Lanes x565 = x549 * 0.13;
  const Lanes x567 = x533 - x546 * q[7] + x565;
  const Lanes x571 = x525 + x551 * 0.13;
  const Lanes x574 = 2.0 * x488;
  const Lanes x576 = x550 * q[7] - x571 + 2.0 * x483 * v[7];
  const Lanes x579 = x529 + x544 * q[7] + x560 - v[7] * x574;
  // link 8 "left_finger": bias force in the reference field
  const Lanes x1082 = x497 * 8.33333e-06;
  const Lanes x1097 = x548 * 5.333337e-05 + (x551 - x546) * 1.5e-05;
  const Lanes x1089 = x1082 - x543 * 5e-06 - x555 * 1.5e-05;
  const Lanes x1113 = x506 * 6.66667e-05 - x1097 + x576 * 0.0005;
  const Lanes x1106 = x553 * 5.833337e-05 + x544 * 1.5e-05 + x509 * 6.16667e-05;
  const Lanes x1122 = x550 * 0.0005 - x551 * 0.0015 + x576 * 0.05;
  const Lanes x1127 = x555 * 0.0015 + x544 * 0.0005 + x579 * 0.05;
  // joint 8 "right_finger_slide": placement, velocity and reference acceleration of its link
  const Lanes x585 = q[8] * 2.65358979335273e-06;
  const Lanes x588 = q[8] * 0.9999999999964793;
  const Lanes x593 = x487 * 2.65358979335273e-06 - x483 * 0.9999999999964793;
  const Lanes x598 = x483 * 2.65358979335273e-06 + x487 * 0.9999999999964793;
  const Lanes x603 = x509 * 2.65358979335273e-06 - x506 * 0.9999999999964793;
  const Lanes x608 = x506 * 2.65358979335273e-06 + x509 * 0.9999999999964793;
  const Lanes x616 = x541 * x585 - x544 * x588 + x529 + x560;
  const Lanes x623 = x546 * x588 - x545 * x585 + x533 + x565;
  const Lanes x640 = 2.65358979335273e-06 * x616 + 0.9999999999964793 * x623;
  const Lanes x630 = x571 + x554 * x585 + x550 * x588;
  const Lanes x646 = v[8] * (2.0 * x593) - x630;
  const Lanes x649 = 2.65358979335273e-06 * x623 - 0.9999999999964793 * x616 - x574 * v[8];
  const Lanes x650 = x593 * x593;
  const Lanes x653 = x650 + x598 * x598;
  const Lanes x655 = x488 * x593;
  const Lanes x657 = x655 - x608;
  const Lanes x660 = x593 * x598;
  const Lanes x662 = x497 + x660;
  const Lanes x665 = x540 + x650;
  const Lanes x667 = x488 * x598;
  // link 9 "right_finger": bias force in the reference field
  const Lanes x1147 = x667 * 5.333337e-05 - 1.5e-05 * (x653 - x665);
  const Lanes x1140 = x1082 + x660 * 5e-06 - x657 * 1.5e-05;
  const Lanes x1163 = x603 * 6.66667e-05 + x1147 + x646 * 0.0005;
  const Lanes x1156 = x655 * 5.833337e-05 - x662 * 1.5e-05 - x608 * 6.16667e-05;
  const Lanes x1166 = x1156 + x649 * 0.0015;
  const Lanes x1171 = (x603 - x667) * 0.0005 - x653 * 0.0015;
  const Lanes x1172 = x646 * 0.05 + x1171;
  const Lanes x1178 = x657 * 0.0015 - x662 * 0.0005 + x649 * 0.05;
  const Lanes x1185 = (x603 + x667) * 0.0015 + x665 * 0.0005;
  // joint 8 "right_finger_slide": articulated-body inertia and bias force through it
  const Lanes x1192 = 20.0 * (x640 * 0.05 + x1185 + tau[8]);
  const Lanes x1197 = x640 * 0.0015 + x1163 - 0.0015 * x1192;
  const Lanes x1234 = 0.0004999999999982397 + x585 * 1.3267948966716939e-07 + x588 * 0.04999999999964792;
  const Lanes x1244 = -1.3267948966763652e-09 - x585 * 3.5207693956928924e-13 - x588 * 1.3267948966716939e-07;
  const Lanes x1247 = -0.0004999999999982397 - x588 * 0.05;
  const Lanes x1250 = 1.3267948966763652e-09 + x585 * 0.05;
  const Lanes x1251 = x588 * 0.0004999999999982397;
  const Lanes x1285 = x585 * 1.3267948966763652e-09;
  const Lanes x1308 = 8.33333e-06 + x1285 + x1251 - x585 * x1244;
  const Lanes x1324 = 0.9999999999964793 * x1178 + 2.65358979335273e-06 * tau[8];
  const Lanes x1329 = 2.65358979335273e-06 * x1178 - 0.9999999999964793 * tau[8];
  const Lanes x1314 = 0.9999999999964793 * x1197 + 2.65358979335273e-06 * x1166;
  const Lanes x1319 = 2.65358979335273e-06 * x1197 - 0.9999999999964793 * x1166;
  const Lanes x1348 = x1140 - x649 * 0.0005 - x585 * x1329;
  const Lanes x1351 = x585 * 5.6332219911062896e-14 + 2.122871834682184e-10 + x588 * 2.1228718346747102e-08 + -0.00014399999999999992;
  const Lanes x1355 = -0.007199999999999999 + x1250;
  const Lanes x1357 = 0.007199999999999999 + x1244;
  const Lanes x1336 = x588 * x1172 + 0.13 * x1329 + x1314;
  const Lanes x1343 = x585 * x1172 - 0.13 * x1324 + x1319;
  // link 7 "hand": bias force in the reference field
  const Lanes x1052 = x555 * 0.0754 - x541 * 0.007199999999999999 + x529 * 0.85;
  const Lanes x1057 = x545 * 0.007199999999999999 + x549 * 0.0754 + x533 * 0.85;
  const Lanes x1065 = x554 * 0.007199999999999999 - (x525 * 0.85 + x551 * 0.0754);
  // link 8 "left_finger": bias force in the reference field
  const Lanes x1133 = x549 * 0.0015 - x546 * 0.0005 + x567 * 0.05;
  // joint 7 "left_finger_slide": articulated-body inertia and bias force through it
  const Lanes x1369 = 20.0 * (tau[7] - x1133);
  const Lanes x1375 = q[7] * 0.05;
  const Lanes x1377 = -0.0005 - x1375;
  const Lanes x1378 = 0.0005 + x1375;
  const Lanes x1379 = q[7] * 0.0005;
  const Lanes x1372 = x1113 - x567 * 0.0015 - 0.0015 * x1369;
  // joint 8 "right_finger_slide": articulated-body inertia and bias force through it
  const Lanes x1350 = x1251 + 2.166670000897794e-05 - x588 * x1247 + 0.01009033;
  // joint 7 "left_finger_slide": articulated-body inertia and bias force through it
  const Lanes x1408 = x1247 + x1378;
  // joint 8 "right_finger_slide": articulated-body inertia and bias force through it
  const Lanes x1301 = x585 * 2.1228718346747102e-08 + 7.999999999971834e-05 + x588 * 0.007999999999943668;
  // joint 7 "left_finger_slide": articulated-body inertia and bias force through it
  const Lanes x1410 = -8e-05 - q[7] * 0.008 + x1301;
  // joint 8 "right_finger_slide": articulated-body inertia and bias force through it
  const Lanes x1356 = x588 * x1234 + x1308 + 0.00317433;
  // joint 7 "left_finger_slide": articulated-body inertia and bias force through it
  const Lanes x1412 = 8.33333e-06 + x1379 - q[7] * x1377 + x1356;
  require_more(w, x1412, 0.0, kFactorization, 6);
  const Lanes x1413 = x1234 + x1377;
  const Lanes x1401 = q[7] * x1122 - 0.13 * tau[7] + x1372;
  const Lanes x1403 = x1106 + x579 * 0.0015 + 0.13 * x1127;
  // joint 8 "right_finger_slide": articulated-body inertia and bias force through it
  const Lanes x1363 = x1036 + x533 * 0.007199999999999999 + (x1348 - x588 * x1324);
  // joint 7 "left_finger_slide": articulated-body inertia and bias force through it
  const Lanes x1421 = x1065 + x1172 + x1122;
  // joint 6 "flange_roll": articulated-body inertia and bias force through it
  const Lanes x1423 = 1 / x1412;
  // joint 7 "left_finger_slide": articulated-body inertia and bias force through it
  const Lanes x1418 = x1089 - x579 * 0.0005 - q[7] * x1127 + x1363;
  // joint 6 "flange_roll": articulated-body inertia and bias force through it
  const Lanes x1425 = x1423 * (tau[6] - x1418);
  const Lanes x1426 = x1351 * x1423;
  const Lanes x1427 = x1410 * x1423;
  const Lanes x1428 = x1413 * x1423;
  const Lanes x1429 = x1357 * x1423;
  // joint 7 "left_finger_slide": articulated-body inertia and bias force through it
  const Lanes x1407 = 2.16667e-05 + x1379 + q[7] * x1378 + x1350;
  // joint 6 "flange_roll": articulated-body inertia and bias force through it
  const Lanes x1432 = x1407 - x1351 * x1426;
  // joint 8 "right_finger_slide": articulated-body inertia and bias force through it
  const Lanes x1273 = 3.3833269865128193e-09 - x588 * 1.3267948966763652e-09 + x585 * x1247;
  // joint 6 "flange_roll": articulated-body inertia and bias force through it
  const Lanes x1435 = x1273 - x1351 * x1427;
  const Lanes x1438 = 2.1228718346747102e-08 - x1351 * x1428;
  const Lanes x1441 = -0.07540000000005632 - x1351 * x1429;
  // joint 7 "left_finger_slide": articulated-body inertia and bias force through it
  const Lanes x1409 = x1285 + 0.001296666699991022 + x585 * x1250 + 0.008236 + 0.0012966667000000002;
  // joint 6 "flange_roll": articulated-body inertia and bias force through it
  const Lanes x1444 = x1409 - x1410 * x1427;
  const Lanes x1447 = 0.09139999999994367 - x1410 * x1428;
  const Lanes x1450 = -2.1228718346747102e-08 - x1410 * x1429;
  const Lanes x1453 = 0.9499999999996479 - x1413 * x1428;
  const Lanes x1456 = -1.3267948966716939e-07 - x1413 * x1429;
  const Lanes x1459 = 0.850000000000352 - x1357 * x1429;
  // joint 7 "left_finger_slide": articulated-body inertia and bias force through it
  const Lanes x1416 = x1018 - x533 * 0.0754 - x1336 + x1401;
  // joint 6 "flange_roll": articulated-body inertia and bias force through it
  const Lanes x1461 = x1416 + x1351 * x1425;
  // joint 7 "left_finger_slide": articulated-body inertia and bias force through it
  const Lanes x1417 = x529 * 0.0754 + x1043 + x1343 + x1403;
  // joint 6 "flange_roll": articulated-body inertia and bias force through it
  const Lanes x1463 = x1417 + x1410 * x1425;
  const Lanes x1465 = x1052 - x1324 + x1127 + x1413 * x1425;
  const Lanes x1467 = x1057 + x1329 + tau[7] + x1357 * x1425;
  const Lanes x1471 = cosine[6] * x1408 - sine[6] * x1355;
  const Lanes x1474 = sine[6] * x1408 + cosine[6] * x1355;
  const Lanes x1480 = cosine[6] * (x1438 - x1450) - sine[6] * (x1441 + x1447);
  const Lanes x1481 = sine[6] * x1480;
  const Lanes x1483 = x1441 + x1481;
  const Lanes x1484 = x1447 + x1481;
  const Lanes x1485 = cosine[6] * x1480;
  const Lanes x1487 = x1438 - x1485;
  const Lanes x1495 = 3.673205103346574e-06 * x1483 + 0.9999999999932537 * x1471;
  const Lanes x1500 = 0.9999999999932537 * x1483 - 3.673205103346574e-06 * x1471;
  const Lanes x1505 = 3.673205103346574e-06 * x1487 + 0.9999999999932537 * x1474;
  const Lanes x1507 = 0.9999999999932537 * x1505;
  const Lanes x1509 = x1474 - x1507;
  const Lanes x1510 = 3.673205103346574e-06 * x1505;
  const Lanes x1512 = x1487 - x1510;
  const Lanes x1515 = 2.0 * sine[6];
  const Lanes x1519 = cosine[6] * (x1432 - x1444) - x1435 * x1515;
  const Lanes x1522 = x1435 + sine[6] * x1519;
  const Lanes x1523 = cosine[6] * x1519;
  const Lanes x1525 = x1432 - x1523;
  const Lanes x1529 = 3.673205103346574e-06 * x1525;
  const Lanes x1534 = 3.673205103346574e-06 * x1529;
  const Lanes x1541 = cosine[6] * (x1453 - x1459) - x1456 * x1515;
  const Lanes x1544 = x1456 + sine[6] * x1541;
  const Lanes x1545 = cosine[6] * x1541;
  const Lanes x1547 = x1453 - x1545;
  const Lanes x1548 = 3.673205103346574e-06 * x1544;
  const Lanes x1550 = 0.9999999999932537 * x1544;
  const Lanes x1552 = 3.673205103346574e-06 * (x1547 - 0.95);
  const Lanes x1554 = 0.9999999999932537 * x1552;
  const Lanes x1556 = 3.673205103346574e-06 * x1552;
  const Lanes x1558 = 0.95 + x1556;
  const Lanes x1559 = x1547 - x1556;
  const Lanes x1567 = 0.09 * x1554;
  const Lanes x1569 = x1510 + x1567;
  const Lanes x1571 = 0.09 * x1558 - x1507;
  const Lanes x1574 = x1509 - 0.09 * x1559;
  const Lanes x1575 = x1512 - x1567;
  const Lanes x1582 = 0.9999999999932537 * x1522 - 0.09 * x1495;
  const Lanes x1594 = 0.09 * x1569 - (0.9999999999932537 * x1529 + 0.09 * x1512);
  const Lanes x1606 = sine[6] * x1461 + cosine[6] * x1463;
  const Lanes x1623 = sine[6] * x1465 + cosine[6] * x1467;
  const Lanes x1628 = 3.673205103346574e-06 * x1623 + 0.9999999999932537 * x1421;
  const Lanes x1633 = 0.9999999999932537 * x1623 - 3.673205103346574e-06 * x1421;
  const Lanes x1599 = x1525 - x1534 - 0.09 * x1507 + 0.09 * x1571;
  const Lanes x1646 = 0.00351 + x1599;
  require_more(w, x1646, 0.0, kFactorization, 5);
  const Lanes x1647 = 0.9999999999932537 * x1484 - 0.09 * x1548 + -0.013000000000000001;
  const Lanes x1648 = 0.052000000000000005 + x1571;
  const Lanes x1603 = cosine[6] * x1461 - sine[6] * x1463;
  const Lanes x1636 = 3.673205103346574e-06 * x1606 + 0.9999999999932537 * tau[6] + 0.09 * x1633;
  const Lanes x1640 = 0.9999999999932537 * x1606 - 3.673205103346574e-06 * tau[6] - 0.09 * x1628;
  const Lanes x1620 = cosine[6] * x1465 - sine[6] * x1467;
  // link 6 "wrist": bias force in the reference field
  const Lanes x981 = x454 * 0.052000000000000005 - x455 * 0.013000000000000001 + x443 * 1.3;
  const Lanes x986 = x436 * 1.3 + x463 * 0.052000000000000005 + x459 * 0.013000000000000001;
  // joint 5 "wrist_pitch": articulated-body inertia and bias force through it
  const Lanes x1660 = 1 / x1646;
  const Lanes x1662 = x1660 * (tau[5] - (x968 - x439 * 0.013000000000000001 + x1640));
  const Lanes x1663 = x1582 * x1660;
  const Lanes x1664 = x1594 * x1660;
  const Lanes x1665 = x1647 * x1660;
  const Lanes x1666 = x1648 * x1660;
  const Lanes x1667 = x1575 * x1660;
  const Lanes x1670 = x1444 + x1523 + 0.0014299999999999998 - x1582 * x1663;
  // joint 6 "flange_roll": articulated-body inertia and bias force through it
  const Lanes x1642 = -0.0005200000000000001 - (3.673205103346574e-06 * x1522 + 0.09 * x1500);
  // joint 5 "wrist_pitch": articulated-body inertia and bias force through it
  const Lanes x1673 = x1642 - x1582 * x1664;
  const Lanes x1676 = x1450 + x1485 - x1582 * x1665;
  const Lanes x1679 = x1495 + x1582 * x1666;
  const Lanes x1683 = 0.013000000000000001 + x1500 - x1582 * x1667;
  // joint 6 "flange_roll": articulated-body inertia and bias force through it
  const Lanes x1644 = x1534 - 0.09 * x1509 - 0.09 * x1574 + 0.00338;
  // joint 5 "wrist_pitch": articulated-body inertia and bias force through it
  const Lanes x1686 = x1644 - x1594 * x1664;
  const Lanes x1689 = 3.673205103346574e-06 * x1484 + 0.09 * x1550 + x1594 * x1665;
  const Lanes x1693 = x1569 - x1594 * x1666;
  const Lanes x1696 = -0.052000000000000005 + x1574 - x1594 * x1667;
  const Lanes x1699 = x1459 + x1545 + 1.3 - x1647 * x1665;
  const Lanes x1702 = x1548 + x1647 * x1666;
  const Lanes x1706 = x1550 - x1647 * x1667;
  const Lanes x1709 = 1.3 + x1558 - x1648 * x1666;
  const Lanes x1712 = x1554 + x1648 * x1667;
  const Lanes x1716 = 1.3 + x1559 - x1575 * x1667;
  const Lanes x1718 = x938 + x436 * 0.013000000000000001 + x1603 + x1582 * x1662;
  const Lanes x1720 = x1594 * x1662 - (x949 + x436 * 0.052000000000000005 + x1636);
  const Lanes x1722 = x439 * 1.3 + x974 + x1620 + x1647 * x1662;
  const Lanes x1724 = x981 - x1628 + x1648 * x1662;
  const Lanes x1726 = x986 + x1633 + x1575 * x1662;
  const Lanes x1730 = cosine[5] * x1683 - sine[5] * x1696;
  const Lanes x1733 = sine[5] * x1683 + cosine[5] * x1696;
  const Lanes x1740 = cosine[5] * (x1676 - x1693) + sine[5] * (x1679 + x1689);
  const Lanes x1741 = sine[5] * x1740;
  const Lanes x1743 = x1741 - x1679;
  const Lanes x1744 = x1741 - x1689;
  const Lanes x1745 = cosine[5] * x1740;
  const Lanes x1747 = x1676 - x1745;
  const Lanes x1765 = 3.673205103346574e-06 * x1747 + 0.9999999999932537 * x1733;
  const Lanes x1767 = 0.9999999999932537 * x1765;
  const Lanes x1770 = 3.673205103346574e-06 * x1765;
  const Lanes x1772 = x1747 - x1770;
  const Lanes x1775 = 2.0 * sine[5];
  const Lanes x1779 = cosine[5] * (x1670 - x1686) - x1673 * x1775;
  const Lanes x1782 = x1673 + sine[5] * x1779;
  const Lanes x1783 = cosine[5] * x1779;
  const Lanes x1785 = x1670 - x1783;
  const Lanes x1788 = 0.9999999999932537 * x1782;
  const Lanes x1789 = 3.673205103346574e-06 * x1785;
  const Lanes x1793 = 3.673205103346574e-06 * x1789;
  const Lanes x1799 = cosine[5] * x1706 + sine[5] * x1712;
  const Lanes x1803 = sine[5] * x1706 - cosine[5] * x1712;
  const Lanes x1808 = cosine[5] * (x1699 - x1709) + x1702 * x1775;
  const Lanes x1811 = sine[5] * x1808 - x1702;
  const Lanes x1812 = cosine[5] * x1808;
  const Lanes x1814 = x1699 - x1812;
  const Lanes x1831 = 3.673205103346574e-06 * (x1814 - x1716) + x1803 * 1.9999999999865075;
  const Lanes x1836 = 3.673205103346574e-06 * x1831;
  const Lanes x1846 = sine[5] * x1718 + cosine[5] * x1720;
  const Lanes x1863 = sine[5] * x1722 + cosine[5] * x1724;
  const Lanes x1878 = 0.00136 - 0.9999999999932537 * x1789;
  const Lanes x1880 = x1785 - x1793 + 0.00189125;
  require_more(w, x1880, 0.0, kFactorization, 4);
  const Lanes x1881 = -0.017 + 0.9999999999932537 * x1744;
  const Lanes x1843 = cosine[5] * x1718 - sine[5] * x1720;
  const Lanes x1851 = 3.673205103346574e-06 * x1846 + 0.9999999999932537 * tau[5];
  const Lanes x1856 = 0.9999999999932537 * x1846 - 3.673205103346574e-06 * tau[5];
  // link 5 "wrist_housing": bias force in the reference field
  const Lanes x902 = x364 * 0.017 - x378 * 0.136 + x345 * 1.7;
  // joint 5 "wrist_pitch": articulated-body inertia and bias force through it
  const Lanes x1868 = 3.673205103346574e-06 * x1863 + 0.9999999999932537 * x1726;
  // link 5 "wrist_housing": bias force in the reference field
  const Lanes x916 = (x310 - x369) * 0.017 + x915;
  // joint 4 "forearm_roll": articulated-body inertia and bias force through it
  const Lanes x1892 = 1 / x1880;
  const Lanes x1894 = x1892 * (tau[4] - (x885 - x345 * 0.017 + x1856));
  const Lanes x1895 = x1788 * x1892;
  const Lanes x1896 = x1878 * x1892;
  const Lanes x1897 = x1881 * x1892;
  const Lanes x1898 = x1767 * x1892;
  const Lanes x1900 = x1772 * x1892;
  const Lanes x1903 = x1686 + x1783 + 0.01553729 - x1788 * x1895;
  const Lanes x1906 = 3.673205103346574e-06 * x1782 + x1788 * x1896;
  const Lanes x1910 = x1693 + x1745 - x1788 * x1897;
  // joint 5 "wrist_pitch": articulated-body inertia and bias force through it
  const Lanes x1875 = 0.136 - (3.673205103346574e-06 * x1743 + 0.9999999999932537 * x1730);
  // joint 4 "forearm_roll": articulated-body inertia and bias force through it
  const Lanes x1913 = x1875 + x1788 * x1898;
  // joint 5 "wrist_pitch": articulated-body inertia and bias force through it
  const Lanes x1876 = 0.9999999999932537 * x1743 - 3.673205103346574e-06 * x1730 + 0.017;
  // joint 4 "forearm_roll": articulated-body inertia and bias force through it
  const Lanes x1916 = x1876 - x1788 * x1900;
  const Lanes x1919 = 0.01536729 + x1793 - x1878 * x1896;
  const Lanes x1922 = -0.136 - 3.673205103346574e-06 * x1744 - x1878 * x1897;
  const Lanes x1925 = x1770 + x1878 * x1898;
  const Lanes x1928 = x1733 - x1767 - x1878 * x1900;
  const Lanes x1931 = x1709 + x1812 + 1.7 - x1881 * x1897;
  const Lanes x1934 = x1881 * x1898 - (3.673205103346574e-06 * x1811 + 0.9999999999932537 * x1799);
  const Lanes x1937 = 0.9999999999932537 * x1811 - 3.673205103346574e-06 * x1799 - x1881 * x1900;
  const Lanes x1940 = x1716 + x1836 + 1.7 - x1767 * x1898;
  const Lanes x1943 = x1803 - 0.9999999999932537 * x1831 + x1767 * x1900;
  const Lanes x1946 = x1814 - x1836 + 1.7 - x1772 * x1900;
  const Lanes x1948 = x889 - x350 * 0.136 + x1843 + x1788 * x1894;
  const Lanes x1950 = x876 - x345 * 0.136 - x1851 + x1878 * x1894;
  // joint 5 "wrist_pitch": articulated-body inertia and bias force through it
  const Lanes x1888 = cosine[5] * x1722 - sine[5] * x1724 + x902;
  // joint 4 "forearm_roll": articulated-body inertia and bias force through it
  const Lanes x1952 = x1888 + x1881 * x1894;
  const Lanes x1955 = x909 - x350 * 1.7 - x1868 - x1767 * x1894;
  // joint 5 "wrist_pitch": articulated-body inertia and bias force through it
  const Lanes x1890 = 0.9999999999932537 * x1863 - 3.673205103346574e-06 * x1726 + x916;
  // joint 4 "forearm_roll": articulated-body inertia and bias force through it
  const Lanes x1957 = x1890 + x1772 * x1894;
  const Lanes x1961 = cosine[4] * x1916 - sine[4] * x1928;
  const Lanes x1964 = sine[4] * x1916 + cosine[4] * x1928;
  const Lanes x1970 = cosine[4] * (x1910 - x1925) - sine[4] * (x1913 + x1922);
  const Lanes x1971 = sine[4] * x1970;
  const Lanes x1973 = x1913 + x1971;
  const Lanes x1974 = x1922 + x1971;
  const Lanes x1975 = cosine[4] * x1970;
  const Lanes x1977 = x1910 - x1975;
  const Lanes x1980 = 0.9999999999932537 * x1974;
  const Lanes x1990 = 0.9999999999932537 * x1973 + 3.673205103346574e-06 * x1961;
  const Lanes x1995 = 0.9999999999932537 * x1964 - 3.673205103346574e-06 * x1977;
  const Lanes x1996 = 0.9999999999932537 * x1995;
  const Lanes x1997 = x1964 - x1996;
  const Lanes x1999 = 3.673205103346574e-06 * x1995;
  const Lanes x2001 = x1977 + x1999;
  const Lanes x2004 = 2.0 * sine[4];
  const Lanes x2008 = cosine[4] * (x1903 - x1919) + x1906 * x2004;
  const Lanes x2011 = sine[4] * x2008 - x1906;
  const Lanes x2012 = cosine[4] * x2008;
  const Lanes x2014 = x1903 - x2012;
  const Lanes x2019 = 3.673205103346574e-06 * x2014;
  const Lanes x2023 = 3.673205103346574e-06 * x2019;
  const Lanes x2029 = cosine[4] * x1937 - sine[4] * x1943;
  const Lanes x2032 = sine[4] * x1937 + cosine[4] * x1943;
  const Lanes x2037 = cosine[4] * (x1931 - x1940) - x1934 * x2004;
  const Lanes x2040 = x1934 + sine[4] * x2037;
  const Lanes x2041 = cosine[4] * x2037;
  const Lanes x2042 = x1940 + x2041;
  const Lanes x2043 = x1931 - x2041;
  const Lanes x2047 = 0.9999999999932537 * x2029 - 3.673205103346574e-06 * x2040;
  const Lanes x2052 = 0.9999999999932537 * x2040 + 3.673205103346574e-06 * x2029;
  const Lanes x2058 = 1.9999999999865075 * x2032 - 3.673205103346574e-06 * (x2043 - x1946);
  const Lanes x2060 = x2032 - 0.9999999999932537 * x2058;
  const Lanes x2061 = 3.673205103346574e-06 * x2058;
  const Lanes x2063 = x1946 - x2061;
  const Lanes x2064 = x2043 + x2061;
  const Lanes x2065 = 0.38 * x2052;
  const Lanes x2067 = x1925 + x1975 - x2065;
  const Lanes x2070 = 3.673205103346574e-06 * x1974 + 0.08 * x2052;
  const Lanes x2078 = x1980 + 0.38 * x2042 + 0.08 * x2047;
  const Lanes x2081 = 0.9999999999932537 * x1961 - 3.673205103346574e-06 * x1973 + 0.38 * x2060;
  const Lanes x2082 = 0.08 * x2060;
  const Lanes x2084 = x2082 - x1999;
  const Lanes x2091 = x1996 + 0.38 * x2047 + 0.08 * x2063;
  const Lanes x2094 = 0.38 * x2064 - x1990;
  const Lanes x2097 = x1997 + 0.08 * x2064;
  const Lanes x2099 = x2001 + x2065 - x2082;
  const Lanes x2116 = 0.38 * x2001 - 0.9999999999932537 * x2011 - 0.38 * x2067;
  const Lanes x2117 = x2116 - 0.08 * x2081;
  const Lanes x2131 = 0.9999999999932537 * x2019 + 0.08 * x2001 + 0.38 * x2070;
  const Lanes x2132 = x2131 - 0.08 * x2084;
  const Lanes x2142 = x2014 - x2023 + 0.38 * x1980 + 0.08 * x1996;
  const Lanes x2151 = sine[4] * x1948 + cosine[4] * x1950;
  const Lanes x2165 = cosine[4] * x1952 - sine[4] * x1955;
  const Lanes x2168 = sine[4] * x1952 + cosine[4] * x1955;
  const Lanes x2172 = 0.9999999999932537 * x1957 - 3.673205103346574e-06 * x2168;
  const Lanes x2177 = 0.9999999999932537 * x2168 + 3.673205103346574e-06 * x1957;
  const Lanes x2189 = 0.9999999999932537 * x2151 + 3.673205103346574e-06 * tau[4] + 0.38 * x2165;
  const Lanes x2104 = x1919 + x2012 - 0.38 * x1990 + 0.38 * x2094;
  const Lanes x2109 = 0.38 * x1997 - 3.673205103346574e-06 * x2011 + 0.08 * x2094;
  const Lanes x2198 = 0.38 * x2078 + x2142 + 0.08 * x2091 + 0.037748300000000005;
  require_more(w, x2198, 0.0, kFactorization, 3);
  const Lanes x2199 = -0.22000000000000003 - x2078;
  const Lanes x2200 = -0.11000000000000001 - x2091;
  const Lanes x2181 = cosine[4] * x1948 - sine[4] * x1950 - 0.38 * x2177;
  const Lanes x2184 = 0.9999999999932537 * tau[4] - 3.673205103346574e-06 * x2151 - 0.08 * x2177;
  // link 4 "forearm": bias force in the reference field
  const Lanes x827 = x247 * 0.11000000000000001 + x250 * 0.22000000000000003 + x235 * 2.2;
  const Lanes x835 = x239 * 2.2 - (x251 * 0.11000000000000001 + x252 * 0.22000000000000003);
  const Lanes x843 = x256 * 0.22000000000000003 - (x231 * 2.2 + x260 * 0.11000000000000001);
  // joint 3 "elbow_pitch": articulated-body inertia and bias force through it
  const Lanes x2211 = 1 / x2198;
  // joint 4 "forearm_roll": articulated-body inertia and bias force through it
  const Lanes x2206 = x820 - x235 * 0.22000000000000003 - (0.08 * x2172 + x2189);
  // joint 3 "elbow_pitch": articulated-body inertia and bias force through it
  const Lanes x2213 = x2211 * (tau[3] - x2206);
  const Lanes x2214 = x2117 * x2211;
  const Lanes x2215 = x2132 * x2211;
  const Lanes x2216 = x2199 * x2211;
  const Lanes x2217 = x2200 * x2211;
  const Lanes x2218 = x2099 * x2211;
  const Lanes x2221 = 0.03224830000000001 + x2104 - x2117 * x2214;
  const Lanes x2224 = 0.011000000000000003 + x2109 - x2117 * x2215;
  const Lanes x2227 = x2067 - x2117 * x2216;
  const Lanes x2230 = x2081 - x2117 * x2217;
  const Lanes x2233 = 0.22000000000000003 + x2094 - x2117 * x2218;
  // joint 4 "forearm_roll": articulated-body inertia and bias force through it
  const Lanes x2196 = x2023 + 0.08 * x1997 + 0.08 * x2097 + 0.00825;
  // joint 3 "elbow_pitch": articulated-body inertia and bias force through it
  const Lanes x2236 = x2196 - x2132 * x2215;
  const Lanes x2239 = x2070 + x2132 * x2216;
  const Lanes x2243 = x2084 - x2132 * x2217;
  const Lanes x2246 = 0.11000000000000001 + x2097 - x2132 * x2218;
  const Lanes x2249 = 2.2 + x2042 - x2199 * x2216;
  const Lanes x2252 = x2047 - x2199 * x2217;
  const Lanes x2255 = x2052 + x2199 * x2218;
  const Lanes x2259 = 2.2 + x2063 - x2200 * x2217;
  const Lanes x2262 = x2060 - x2200 * x2218;
  const Lanes x2265 = 2.2 + x2064 - x2099 * x2218;
  const Lanes x2267 = x790 - x231 * 0.22000000000000003 + x2181 + x2117 * x2213;
  const Lanes x2269 = x800 - x231 * 0.11000000000000001 + x2184 + x2132 * x2213;
  const Lanes x2271 = x827 + x2165 + x2199 * x2213;
  const Lanes x2273 = x835 + x2172 + x2200 * x2213;
  const Lanes x2275 = x843 - x2177 + x2099 * x2213;
  const Lanes x2279 = cosine[3] * x2233 - sine[3] * x2246;
  const Lanes x2282 = sine[3] * x2233 + cosine[3] * x2246;
  const Lanes x2288 = cosine[3] * (x2227 - x2243) - sine[3] * (x2230 - x2239);
  const Lanes x2289 = sine[3] * x2288;
  const Lanes x2291 = x2230 + x2289;
  const Lanes x2292 = x2289 - x2239;
  const Lanes x2293 = cosine[3] * x2288;
  const Lanes x2295 = x2227 - x2293;
  const Lanes x2303 = 3.673205103346574e-06 * x2291 + 0.9999999999932537 * x2279;
  const Lanes x2308 = 0.9999999999932537 * x2291 - 3.673205103346574e-06 * x2279;
  const Lanes x2313 = 3.673205103346574e-06 * x2295 + 0.9999999999932537 * x2282;
  const Lanes x2315 = 0.9999999999932537 * x2313;
  const Lanes x2317 = x2282 - x2315;
  const Lanes x2318 = 3.673205103346574e-06 * x2313;
  const Lanes x2320 = x2295 - x2318;
  const Lanes x2323 = 2.0 * sine[3];
  const Lanes x2327 = cosine[3] * (x2221 - x2236) - x2224 * x2323;
  const Lanes x2330 = x2224 + sine[3] * x2327;
  const Lanes x2331 = cosine[3] * x2327;
  const Lanes x2333 = x2221 - x2331;
  const Lanes x2337 = 3.673205103346574e-06 * x2333;
  const Lanes x2341 = 3.673205103346574e-06 * x2337;
  const Lanes x2348 = cosine[3] * x2255 + sine[3] * x2262;
  const Lanes x2353 = cosine[3] * x2262 - sine[3] * x2255;
  const Lanes x2358 = cosine[3] * (x2249 - x2259) - x2252 * x2323;
  const Lanes x2361 = x2252 + sine[3] * x2358;
  const Lanes x2362 = cosine[3] * x2358;
  const Lanes x2364 = x2249 - x2362;
  const Lanes x2369 = 0.9999999999932537 * x2348 - 3.673205103346574e-06 * x2361;
  const Lanes x2373 = 0.9999999999932537 * x2361 + 3.673205103346574e-06 * x2348;
  const Lanes x2379 = 3.673205103346574e-06 * (x2364 - x2265) + 1.9999999999865075 * x2353;
  const Lanes x2383 = x2353 - 0.9999999999932537 * x2379;
  const Lanes x2384 = 3.673205103346574e-06 * x2379;
  const Lanes x2386 = x2265 + x2384;
  const Lanes x2387 = x2364 - x2384;
  const Lanes x2393 = 0.9999999999932537 * x2292 + 0.08 * x2369;
  const Lanes x2394 = 0.08 * x2383;
  const Lanes x2396 = x2318 - x2394;
  const Lanes x2398 = 0.08 * x2386 - x2315;
  const Lanes x2401 = x2317 - 0.08 * x2387;
  const Lanes x2402 = x2320 + x2394;
  const Lanes x2409 = 0.9999999999932537 * x2330 - 0.08 * x2303;
  const Lanes x2421 = 0.08 * x2396 - (0.9999999999932537 * x2337 + 0.08 * x2320);
  const Lanes x2433 = sine[3] * x2267 + cosine[3] * x2269;
  const Lanes x2450 = sine[3] * x2271 + cosine[3] * x2273;
  const Lanes x2455 = 3.673205103346574e-06 * x2450 + 0.9999999999932537 * x2275;
  const Lanes x2460 = 0.9999999999932537 * x2450 - 3.673205103346574e-06 * x2275;
  const Lanes x2426 = x2333 - x2341 - 0.08 * x2315 + 0.08 * x2398;
  const Lanes x2472 = 0.0039325 + x2426;
  require_more(w, x2472, 0.0, kFactorization, 2);
  // link 3 "elbow_housing": bias force in the reference field
  const Lanes x750 = x111 * 0.01132625 - x157 * 0.007393749999999999 + x143 * 0.078;
  const Lanes x753 = x114 * 0.01132625 + x162 * 0.007393749999999999 - x139 * 0.078;
  // joint 3 "elbow_pitch": articulated-body inertia and bias force through it
  const Lanes x2463 = 3.673205103346574e-06 * x2433 + 0.9999999999932537 * tau[3] + 0.08 * x2460;
  const Lanes x2467 = 0.9999999999932537 * x2433 - 3.673205103346574e-06 * tau[3] - 0.08 * x2455;
  // link 3 "elbow_housing": bias force in the reference field
  const Lanes x757 = x139 * 2.6 - (x114 + x162) * 0.078;
  const Lanes x766 = (x89 * x89 + x148) * 0.078 - x134 * 2.6;
  // joint 2 "upper_arm_roll": articulated-body inertia and bias force through it
  const Lanes x2483 = 1 / x2472;
  const Lanes x2485 = x2483 * (tau[2] - (x2467 - x97 * 0.0039325));
  const Lanes x2486 = x2409 * x2483;
  const Lanes x2487 = x2421 * x2483;
  const Lanes x2488 = x2393 * x2483;
  const Lanes x2489 = x2398 * x2483;
  const Lanes x2490 = x2402 * x2483;
  const Lanes x2493 = x2236 + x2331 + 0.01132625 - x2409 * x2486;
  const Lanes x2496 = 3.673205103346574e-06 * x2330 + 0.08 * x2308 + x2409 * x2487;
  const Lanes x2500 = x2243 + x2293 - x2409 * x2488;
  const Lanes x2503 = 0.078 - x2303 - x2409 * x2489;
  const Lanes x2506 = x2308 - x2409 * x2490;
  // joint 3 "elbow_pitch": articulated-body inertia and bias force through it
  const Lanes x2470 = x2341 - 0.08 * x2317 - 0.08 * x2401 + 0.01132625;
  // joint 2 "upper_arm_roll": articulated-body inertia and bias force through it
  const Lanes x2509 = x2470 - x2421 * x2487;
  // joint 3 "elbow_pitch": articulated-body inertia and bias force through it
  const Lanes x2471 = -0.078 - (3.673205103346574e-06 * x2292 + 0.08 * x2373);
  // joint 2 "upper_arm_roll": articulated-body inertia and bias force through it
  const Lanes x2512 = x2471 - x2421 * x2488;
  const Lanes x2515 = x2396 - x2421 * x2489;
  const Lanes x2518 = x2401 - x2421 * x2490;
  const Lanes x2521 = x2259 + x2362 + 2.6 - x2393 * x2488;
  const Lanes x2524 = x2369 - x2393 * x2489;
  const Lanes x2527 = x2373 - x2393 * x2490;
  const Lanes x2530 = 2.6 + x2386 - x2398 * x2489;
  const Lanes x2533 = x2383 - x2398 * x2490;
  // joint 3 "elbow_pitch": articulated-body inertia and bias force through it
  const Lanes x2476 = cosine[3] * x2267 - sine[3] * x2269 + x750;
  // joint 2 "upper_arm_roll": articulated-body inertia and bias force through it
  const Lanes x2538 = x2476 + x2409 * x2485;
  const Lanes x2540 = x753 - x2463 + x2421 * x2485;
  // joint 3 "elbow_pitch": articulated-body inertia and bias force through it
  const Lanes x2479 = cosine[3] * x2271 - sine[3] * x2273 + x757;
  // joint 2 "upper_arm_roll": articulated-body inertia and bias force through it
  const Lanes x2542 = x2479 + x2393 * x2485;
  // joint 3 "elbow_pitch": articulated-body inertia and bias force through it
  const Lanes x2480 = x143 * 2.6 - (x157 - x111) * 0.078 - x2455;
  // joint 2 "upper_arm_roll": articulated-body inertia and bias force through it
  const Lanes x2544 = x2480 + x2398 * x2485;
  const Lanes x2553 = sine[2] * x2506 + cosine[2] * x2518;
  const Lanes x2559 = cosine[2] * (x2500 - x2515) - sine[2] * (x2503 + x2512);
  const Lanes x2560 = sine[2] * x2559;
  const Lanes x2563 = x2512 + x2560;
  const Lanes x2564 = cosine[2] * x2559;
  const Lanes x2566 = x2500 - x2564;
  const Lanes x2569 = 0.9999999999932537 * x2563;
  const Lanes x2577 = 3.673205103346574e-06 * (cosine[2] * x2506 - sine[2] * x2518);
  const Lanes x2579 = 0.9999999999932537 * (x2503 + x2560) - x2577;
  const Lanes x2584 = 3.673205103346574e-06 * x2566 + 0.9999999999932537 * x2553;
  const Lanes x2594 = 2.0 * sine[2];
  const Lanes x2598 = cosine[2] * (x2493 - x2509) + x2496 * x2594;
  const Lanes x2601 = sine[2] * x2598 - x2496;
  const Lanes x2602 = cosine[2] * x2598;
  const Lanes x2604 = x2493 - x2602;
  const Lanes x2608 = 3.673205103346574e-06 * x2604;
  const Lanes x2612 = 3.673205103346574e-06 * x2608;
  const Lanes x2626 = cosine[2] * (x2521 - x2530) - x2524 * x2594;
  const Lanes x2630 = cosine[2] * x2626;
  const Lanes x2632 = x2521 - x2630;
  const Lanes x2640 = 3.673205103346574e-06 * (cosine[2] * x2527 - sine[2] * x2533);
  const Lanes x2644 = 3.673205103346574e-06 * (x2632 - (2.6 + x2387 - x2402 * x2490));
  const Lanes x2648 = x2644 + 1.9999999999865075 * (sine[2] * x2527 + cosine[2] * x2533);
  const Lanes x2657 = 0.3 * (0.9999999999932537 * (x2524 + sine[2] * x2626) - x2640);
  const Lanes x2677 = 0.3 * (x2579 - 0.3 * (x2632 - 3.673205103346574e-06 * x2648));
  const Lanes x2689 = 0.9999999999932537 * x2601 - 0.3 * (x2566 - 3.673205103346574e-06 * x2584);
  const Lanes x2690 = 0.3 * (x2515 + x2564 - x2657) + x2689;
  const Lanes x2693 = 0.9999999999932537 * x2608 + 0.3 * (3.673205103346574e-06 * x2563);
  const Lanes x2697 = 0.3 * (x2569 + 0.3 * (x2530 + x2630));
  const Lanes x2707 = sine[2] * x2538 + cosine[2] * x2540;
  const Lanes x2731 = 0.9999999999932537 * (sine[2] * x2542 + cosine[2] * x2544);
  const Lanes x2734 = x2731 - 3.673205103346574e-06 * (x766 + x2460 + x2402 * x2485);
  const Lanes x2738 = 0.3 * (cosine[2] * x2542 - sine[2] * x2544);
  const Lanes x2744 = x2604 - x2612 + 0.3 * x2569 + x2697 + 0.048670000000000005;
  require_more(w, x2744, 0.0, kFactorization, 1);
  const Lanes x2737 = cosine[2] * x2538 - sine[2] * x2540 - 0.3 * x2734;
  const Lanes x2740 = 0.9999999999932537 * x2707 - 3.673205103346574e-06 * tau[2] + x2738;
  // joint 1 "shoulder_pitch": articulated-body inertia and bias force through it
  const Lanes x2756 = 1 / x2744;
  const Lanes x2757 = tau[1] - (x2740 - (x55 * 0.04309 + x37 * 0.31000000000000005));
  const Lanes x2758 = x2756 * x2757;
  const Lanes x2759 = x2690 * x2756;
  const Lanes x2760 = x2693 * x2756;
  // joint 2 "upper_arm_roll": articulated-body inertia and bias force through it
  const Lanes x2741 = x2509 + x2602 - 0.3 * x2579 - x2677 + 0.048670000000000005;
  // joint 1 "shoulder_pitch": articulated-body inertia and bias force through it
  const Lanes x2768 = x2741 - x2690 * x2759;
  // joint 2 "upper_arm_roll": articulated-body inertia and bias force through it
  const Lanes x2683 = 3.673205103346574e-06 * x2601 + 0.3 * (x2553 - 0.9999999999932537 * x2584);
  const Lanes x2749 = 1.1170584039787268e-05 - (x30 * 0.048670000000000005 + x59 * 0.04309) + x2737;
  const Lanes x2750 = x32 * 0.00558 - (3.673205103346574e-06 * x2707 + 0.9999999999932537 * tau[2]);
  // joint 1 "shoulder_pitch": articulated-body inertia and bias force through it
  const Lanes x2868 = cosine[1] * (x2768 - (0.00558 + x2612 - x2693 * x2760));
  const Lanes x2873 = x2868 - (x2690 * x2760 - x2683) * (sine[1] * 2.0);
  const Lanes x2879 = x2768 - cosine[1] * x2873;
  const Lanes x2972 = sine[1] * (x2749 + x2690 * x2758);
  const Lanes x2979 = 0.9999999999932537 * (x2972 + cosine[1] * (x2750 - x2693 * x2758));
  const Lanes x3011 = x2879 - 3.673205103346574e-06 * (3.673205103346574e-06 * x2879) + 0.00882;
  require_more(w, x3011, 0.0, kFactorization, 0);
  // joint 0 "base_yaw": articulated-body inertia and bias force through it
  const Lanes x3019 = 1 / x3011 * (x2979 + 3.673205103346574e-06 * tau[1] + tau[0]);
  w.result[0] = x3019;
  // joint 1 "shoulder_pitch": its acceleration, and that of the link beyond
  const Lanes x3028 = 0.9999999999932537 * x3019;
  const Lanes x3032 = sine[1] * x3028;
  const Lanes x3034 = cosine[1] * x3028;
  const Lanes x3041 = x2758 + x2759 * x3032 - x2760 * x3034;
  const Lanes x3042 = 3.673205103346574e-06 * x3019 + x3041;
  w.result[1] = x3042;
  // joint 2 "upper_arm_roll": its acceleration, and that of the link beyond
  const Lanes x3043 = 0.3 * x3041;
  const Lanes x3044 = 0.3 * x3032;
  const Lanes x3049 = 3.673205103346574e-06 * x3034 + 0.9999999999932537 * x3041;
  const Lanes x3058 = sine[2] * x3049 - cosine[2] * x3032;
  const Lanes x3062 = sine[2] * x3032 + cosine[2] * x3049;
  const Lanes x3063 = 0.9999999999932537 * x3044;
  const Lanes x3064 = 3.673205103346574e-06 * x3044;
  const Lanes x3068 = cosine[2] * x3043 + sine[2] * x3063;
  const Lanes x3072 = cosine[2] * x3063 - sine[2] * x3043;
  const Lanes x3084 = x2485 + x2490 * x3064 - x2488 * x3068;
  const Lanes x3086 = x3084 - x2489 * x3072 - x2486 * x3058;
  const Lanes x3087 = x3086 - x2487 * x3062;
  const Lanes x3088 = x3087 - (0.9999999999932537 * x3034 - 3.673205103346574e-06 * x3041);
  w.result[2] = x3088;
  // joint 3 "elbow_pitch": its acceleration, and that of the link beyond
  const Lanes x3091 = x3072 + 0.08 * x3087;
  const Lanes x3094 = x3064 + 0.08 * x3062;
  const Lanes x3099 = 0.9999999999932537 * x3087 - 3.673205103346574e-06 * x3062;
  const Lanes x3108 = cosine[3] * x3058 + sine[3] * x3099;
  const Lanes x3112 = cosine[3] * x3099 - sine[3] * x3058;
  const Lanes x3117 = 3.673205103346574e-06 * x3091 + 0.9999999999932537 * x3094;
  const Lanes x3123 = 3.673205103346574e-06 * x3094 - 0.9999999999932537 * x3091;
  const Lanes x3127 = cosine[3] * x3068 - sine[3] * x3117;
  const Lanes x3132 = sine[3] * x3068 + cosine[3] * x3117;
  const Lanes x3145 = x2213 - x2214 * x3108 - x2215 * x3112;
  const Lanes x3147 = x3145 - x2218 * x3123 - x2216 * x3127;
  const Lanes x3148 = x2217 * x3132 + x3147;
  const Lanes x3149 = 0.9999999999932537 * x3062 + 3.673205103346574e-06 * x3087 + x3148;
  w.result[3] = x3149;
  // joint 4 "forearm_roll": its acceleration, and that of the link beyond
  const Lanes x3153 = x3127 - 0.38 * x3148;
  const Lanes x3156 = x3132 + 0.08 * x3148;
  const Lanes x3162 = x3123 + 0.08 * x3112 + 0.38 * x3108;
  const Lanes x3167 = 3.673205103346574e-06 * x3112 + 0.9999999999932537 * x3148;
  const Lanes x3176 = cosine[4] * x3108 - sine[4] * x3167;
  const Lanes x3181 = sine[4] * x3108 + cosine[4] * x3167;
  const Lanes x3187 = 3.673205103346574e-06 * x3156 - 0.9999999999932537 * x3162;
  const Lanes x3192 = 0.9999999999932537 * x3156 + 3.673205103346574e-06 * x3162;
  const Lanes x3196 = cosine[4] * x3153 + sine[4] * x3187;
  const Lanes x3200 = cosine[4] * x3187 - sine[4] * x3153;
  const Lanes x3212 = x1894 - x1895 * x3176 + x1896 * x3181;
  const Lanes x3214 = x1900 * x3192 + x3212 - x1897 * x3196;
  const Lanes x3215 = x1898 * x3200 + x3214;
  const Lanes x3216 = x3215 - (0.9999999999932537 * x3112 - 3.673205103346574e-06 * x3148);
  w.result[4] = x3216;
  // joint 5 "wrist_pitch": its acceleration, and that of the link beyond
  const Lanes x3220 = 3.673205103346574e-06 * x3181 + 0.9999999999932537 * x3215;
  const Lanes x3228 = cosine[5] * x3176 + sine[5] * x3220;
  const Lanes x3232 = cosine[5] * x3220 - sine[5] * x3176;
  const Lanes x3237 = 3.673205103346574e-06 * x3200 + 0.9999999999932537 * x3192;
  const Lanes x3243 = 3.673205103346574e-06 * x3192 - 0.9999999999932537 * x3200;
  const Lanes x3247 = cosine[5] * x3196 - sine[5] * x3237;
  const Lanes x3252 = sine[5] * x3196 + cosine[5] * x3237;
  const Lanes x3265 = x1662 - x1667 * x3243 - x1665 * x3247;
  const Lanes x3267 = x1666 * x3252 + x3265 - x1663 * x3228;
  const Lanes x3268 = x3267 - x1664 * x3232;
  const Lanes x3269 = x3268 - (0.9999999999932537 * x3181 - 3.673205103346574e-06 * x3215);
  w.result[5] = x3269;
  // joint 6 "flange_roll": its acceleration, and that of the link beyond
  const Lanes x3280 = 0.9999999999932537 * x3268 - 3.673205103346574e-06 * x3232;
  const Lanes x3289 = cosine[6] * x3228 + sine[6] * x3280;
  const Lanes x3293 = cosine[6] * x3280 - sine[6] * x3228;
  const Lanes x3296 = 0.9999999999932537 * (x3243 - 0.09 * x3232);
  const Lanes x3297 = x3296 - 3.673205103346574e-06 * (0.09 * x3268 - x3252);
  const Lanes x3306 = cosine[6] * x3247 + sine[6] * x3297;
  const Lanes x3310 = cosine[6] * x3297 - sine[6] * x3247;
  const Lanes x3320 = x1425 - x1426 * x3289 - x1427 * x3293;
  const Lanes x3322 = x3320 - x1428 * x3306 - x1429 * x3310;
  const Lanes x3323 = 0.9999999999932537 * x3232 + 3.673205103346574e-06 * x3268 + x3322;
  w.result[6] = x3323;
  // joint 7 "left_finger_slide": its acceleration, and that of the link beyond
  const Lanes x3334 = x3310 - 0.13 * x3289;
  const Lanes x3341 = x1369 + 0.03 * x3289 - x3334;
  w.result[7] = x3341;
  // joint 8 "right_finger_slide": its acceleration, and that of the link beyond
  const Lanes x3366 = 2.65358979335273e-06 * (x3306 + 0.13 * x3293 + x588 * x3322);
  const Lanes x3374 = x1192 + 0.03 * (2.65358979335273e-06 * x3293 - 0.9999999999964793 * x3289);
  const Lanes x3375 = x3366 + 0.9999999999964793 * (x3334 - x585 * x3322) + x3374;
  w.result[8] = x3375;
}

// ---- processes ----------------------------------------------------------------------------------

// Each process: 9 of 9 joints: "base_yaw", "shoulder_pitch", "upper_arm_roll", "elbow_pitch", "forearm_roll", "wrist_pitch", ...
constexpr std::array<int, 9> kRead_0{0, 1, 2, 3, 4, 5, 6, 7, 8};
constexpr std::array<int, 9> kOwned_0{0, 1, 2, 3, 4, 5, 6, 7, 8};

void begin_group(Workspace& w) {
  ADAGEN_INPUTS
  if (!all(unlike_zero(q + 0, 1) == 0))
    name_what_is_not_finite(w, kRead_0, kOwned_0);
  take_sines_and_cosines<7>(q + 0, w.sine.data(), w.cosine.data());
}

void end_group(Workspace& w) {
  ADAGEN_INPUTS
  if (__builtin_expect(w.status != kFine || !all(unlike_zero(w.result.data() + 0, 9) == 0), 0)) {
    find_fault(w, kRead_0, kOwned_0);
  }
  if (w.status != kFine) return;
  std::copy_n(w.result.data() + 0, 9, w.qdd + 0);
}

// What is done for a group of states, in order.
constexpr std::array kParts{begin_group, part_0_0, end_group};


}  // namespace

[[maybe_unused]] constexpr std::array<StageInfo, 3> kStages_0{ {{"kinematics", 8, -1}, {"assembly", 0, -1}, {"disassembly", 0, -1}} };

constexpr std::array<Range, 4> kRanges_0{ {{0, 9}, {0, 9}, {0, 9}, {0, 9}} };
[[maybe_unused]] constexpr std::array<ProcessInfo, kProcesses> kProcess{ {
    {{1, kRanges_0.data()}, {1, kRanges_0.data() + 1}, {1, kRanges_0.data() + 2}, {1, kRanges_0.data() + 3}, {3, kStages_0.data()}},
    {{1, kRanges_0.data()}, {1, kRanges_0.data() + 1}, {1, kRanges_0.data() + 2}, {1, kRanges_0.data() + 3}, {3, kStages_0.data()}}}};

#include "adagen/no_parameters.hpp"
#include "adagen/handout.hpp"
#include "adagen/batch.hpp"
#include "adagen/open.hpp"
#include "adagen/c_interface.hpp"

// ---- program ------------------------------------------------------------------------------------

#ifndef ADAGEN_NO_MAIN
#include "adagen/measured.hpp"
#include "adagen/tell_processes.hpp"

namespace {

adagen::Description<Number> description() {
  auto about = plain_description(stages_of_processes());
  return about;
}

}  // namespace

#include "adagen/entry.hpp"
#endif  // ADAGEN_NO_MAIN
