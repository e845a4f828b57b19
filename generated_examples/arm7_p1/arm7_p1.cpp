// Forward dynamics of "arm7" on 1 process, emitted by adagen 0.1.0 (solver.cpp.j2). Do not edit: generate again. Licence: yours to choose.
// robot     "arm7", 9 joints, 9 degrees of freedom, description sha256 35a799ae72b600eeca178cc12eccff22927d06b6ca76bda0ede3ef5832ebda29
// command   adagen ../models/arm7.urdf --procs 1 --shape=kernels
// input     profile default, sha256 fe36af9ff4727e4941af0e7182db7f87cd64c54109bc287302f720e9ad83c3a8
// options   form segment (articulated-body algorithm), shape kernels (spatial vectors [angular; linear] in the axes of the base, about each link's origin), scalar double, channel auto, fixed base, gravity 0.0, 0.0, -9.81
// links     adagen_program.cpp; or, compiled with -DADAGEN_NO_MAIN, a program of yours that includes arm7_p1.h
// program   1 process; 0.292 us predicted (default profile)
//           process 0: left_finger_slide | right_finger_slide in 2 lanes, base_yaw .. flange_roll

#include "arm7_p1.h"
#define ADAGEN_CALL(word) arm7_p1_##word
#define ADAGEN_NAMED(WORD) ARM7_P1_##WORD
#include "adagen/kernels/plain_loops.hpp"

namespace { struct arm7_p1_settings : PlainLoops<9> {
  static constexpr int kVersion = 100, kJointCount = 9, kNq = 9, kNv = 9;
  [[maybe_unused]] static constexpr const char* kRobot = "arm7";
  static constexpr bool kReordered = true;
  static constexpr int kSlots[kJointCount] = {2, 3, 4, 5, 6, 7, 8, 0, 1};
  static constexpr bool kInLanes = true;
  static constexpr bool kByColumns = true;
}; }  // namespace: a program may load several solvers of one name

#include "adagen/kernels/model.hpp"

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

constexpr std::array<LinkInertia, kJointCount> kInertias{ {
    {3.6, {0.0, 0.0, 0.36000000000000004},
     {0.00441, 0.0, 0.0, 0.00441, 0.0, 0.04800000000000001}},
    {3.1, {0.0, -0.31000000000000005, 0.0},
     {0.00279, 0.0, 0.0, 0.045880000000000004, 0.0, 0.00279}},
    {2.6, {0.0, 0.0, -0.078},
     {0.00196625, 0.0, 0.0, 0.00196625, 0.0, 0.009359999999999999}},
    {2.2, {-0.11000000000000001, 0.22000000000000003, 0.0},
     {0.006875000000000001, -0.011000000000000003, 0.0, 0.030873300000000003, 0.0, 0.001375}},
    {1.7, {0.0, 0.017, -0.136},
     {0.000860625, 0.0, 0.0, 0.0010306249999999999, -0.00136, 0.014506665}},
    {1.3, {0.052000000000000005, 0.013000000000000001, 0.0},
     {0.0027300000000000002, 0.0005200000000000001, 0.0, 0.00078, 0.0, 0.00065}},
    {0.85, {0.007199999999999999, 0.0, 0.0754},
     {0.0006599999999999998, 0.0, 0.00014399999999999992, 0.0025143300000000004, 0.0, 0.007576}},
    {0.05, {0.0015, 0.0, 0.0005},
     {6.0000035e-05, 0.0, 1.5e-05, 1.666665e-06, 0.0, 6.666665e-06}},
    {0.05, {0.0015, 0.0, 0.0005},
     {6.0000035e-05, 0.0, 1.5e-05, 1.666665e-06, 0.0, 6.666665e-06}}}};

constexpr LinkRole kRoles[1][kLinkCount]{{{1, 0, 1, 0}, {0, 1, 0, 0}, {0, 1, 0, 0}, {0, 1, 0, 0}, {0, 1, 0, 0}, {0, 1, 0, 0}, {0, 1, 0, 0}, {1, 1, 1, 0}, {0, 1, 0, 0}, {0, 1, 0, 0}}};

#include "adagen/kernels/loops_alone.hpp"
#include "adagen/kernels/inward_columns.hpp"
#include "adagen/kernels/groups.hpp"

// "left_finger_slide", "right_finger_slide"
constexpr Limbs<2, 1> kLimbs0{0, {{7, 8}}};

// ---- processes ----------------------------------------------------------------------------------

// Process 0: 9 of 9 joints: "base_yaw", "shoulder_pitch", "upper_arm_roll", "elbow_pitch", "forearm_roll", "wrist_pitch", ...
static void run_0([[maybe_unused]] Workspace& w, [[maybe_unused]] Channel& channel) {
  take_angles<0, 8>(w);
  turn<block(0), block(8) + 1>(w);
  outward<0, 6>(w);  // "base_yaw" .. "flange_roll"
  outward_group<kLimbs0>(w);
  stamp(1);
  set_up_links<block(0), block(8) + 1>(w);
  set_up_columns<block(2), block(8) + 1>(w);
  {
    const auto X = inward_group<0, kLimbs0>(w);
    leave<true>(w, 7, lane(X, 0));
    leave<false>(w, 7, lane(X, 1));
  }
  inward_in_columns<0, 0, 6, true>(w);  // "base_yaw" .. "flange_roll"
  stamp(2);
  accelerate<0, 0, 6>(w);  // "base_yaw" .. "flange_roll"
  accelerate_group<0, kLimbs0>(w);
  stamp(3);
  if (!went_well(w, 0, 9)) find_fault(w, {{0, 9}}, {{0, 9}}, {{0, 9}}, {{0, 9}});
  give(w, 0, 9);
}

[[maybe_unused]] constexpr std::array<StageInfo, 3> kStages_0{ {{"kinematics", 8, -1}, {"assembly", 0, -1}, {"disassembly", 0, -1}} };

#include "adagen/whole_alone.hpp"
