// Forward dynamics of "humanoid" on 3 processes, emitted by adagen 0.1.0 (solver.cpp.j2). Do not edit: generate again. Licence: yours to choose.
// robot     "humanoid", 30 joints, 35 degrees of freedom, description sha256 d573a89307ddd4ee9018ee9a0a94422a3db0c5f61f2798648f53f0e1b57ee437
// command   adagen ../models/humanoid.urdf --floating --procs 3 --form=ada
// input     profile default, sha256 fe36af9ff4727e4941af0e7182db7f87cd64c54109bc287302f720e9ad83c3a8
// options   form ada (assembly-disassembly algorithm), shape joints (spatial vectors [angular; linear] in link frames whose joint axes are z), scalar double, channel auto, floating base, gravity 0.0, 0.0, -9.81
// needs     Eigen's headers
// links     adagen_program.cpp -DADAGEN_MPI; or, compiled with -DADAGEN_NO_MAIN, a program of yours that includes humanoid_p3.h
// program   3 processes, joined at cuts; 3.02 us predicted (default profile)
//           process 0: __base__ .. waist_yaw
//           process 1: waist_roll .. left_shoulder_pitch, neck_yaw .. right_wrist_pitch
//           process 2: left_shoulder_roll .. left_wrist_pitch
// schedule  waist_yaw@0-2(__base__@0(|left_hip_pitch(right_hip_pitch(|right_hip_roll(|right_hip_yaw(|right_knee(|right_ankle_pitch(|right_ankle_roll))))) | left_hip_roll(|left_hip_yaw(|left_knee(|left_ankle_pitch(|left_ankle_roll)))))) | waist_roll@1-2(|waist_pitch(|left_shoulder_pitch(neck_yaw@1(right_shoulder_pitch(|right_shoulder_roll(|right_shoulder_yaw(|right_elbow(|right_wrist_roll(|right_wrist_pitch))))) | neck_pitch) | left_shoulder_roll@2(|left_shoulder_yaw(|left_elbow(|left_wrist_roll(|left_wrist_pitch))))))))
//
// Assembly-disassembly algorithm of Yamane and Nakamura. Phi are inverse articulated-body inertias, b
// bias accelerations. Joint i joins chain A (its parent link's side) and chain B (its child link's side)
// to chain C: assembly, Eq. (3)-(7), goes up the schedule, disassembly, Eq. (8)-(10), comes down.

#include "humanoid_p3.h"
#define ADAGEN_CALL(word) humanoid_p3_##word
#define ADAGEN_NAMED(WORD) HUMANOID_P3_##WORD
#define ADAGEN_MPI
#include "adagen/settings.hpp"

namespace { struct humanoid_p3_settings : PlainSettings {
  static constexpr int kVersion = 100, kJointCount = 30, kNq = 36, kNv = 35;
  [[maybe_unused]] static constexpr const char* kRobot = "humanoid";
  [[maybe_unused]] static constexpr bool kFloating = true;
  static constexpr int kProcesses = 3;
  static constexpr bool kAlone = false;
  static constexpr int kPlanMessages = 4;
  [[maybe_unused]] static constexpr Hops kHops = {{0, 152, 0.404}, {20.9, 192, 0.602}};
}; }  // namespace: a program may load several solvers of one name

#include "adagen/constants.hpp"

constexpr std::array<LinkConstants, kLinkCount> kLinks{ {
    {"__world__", 0.0, {0.0, 0.0, 0.0}},
    {"pelvis", 6.2, {0.0, 0.0, 0.02},
     {0.0324467, 0.0, 0.0, 0.0, 0.0175667, 0.0, 0.0, 0.0, 0.0351333},
     {30.819775200559686, 0.0, 0.0, 0.0, 56.92588818617042, 0.0, 0.0, 0.0, 28.463025107234447}},
    {"left_hip", 1.4, {0.0, 0.0, 0.03},
     {0.00182, 0.0, 0.0, 0.0, 0.00182, 0.0, 0.0, 0.0, 0.00175},
     {549.4505494505495, 0.0, 0.0, 0.0, 549.4505494505495, 0.0, 0.0, 0.0, 571.4285714285714}},
    {"left_groin", 1.2, {0.0, -0.04, 0.02},
     {0.00139, 0.0, 0.0, 0.0, 0.00139, 0.0, 0.0, 0.0, 0.0015},
     {719.4244604316547, 0.0, 0.0, 0.0, 719.4244604316547, 0.0, 0.0, 0.0, 666.6666666666666}},
    {"left_thigh", 2.6, {0.0, 0.0, -0.1},
     {0.0169867, 0.0, 0.0, 0.0, 0.0169867, 0.0, 0.0, 0.0, 0.00468},
     {58.86958620567856, 0.0, 0.0, 0.0, 58.86958620567856, 0.0, 0.0, 0.0, 213.67521367521366}},
    {"left_shank", 1.8, {-0.13, 0.01, 0.0},
     {0.0018225, 0.0, 0.0, 0.0, 0.0126713, 0.0, 0.0, 0.0, 0.0126713},
     {548.6968449931413, 0.0, 0.0, 0.0, 78.91850086415758, 0.0, 0.0, 0.0, 78.91850086415758}},
    {"left_ankle", 0.2, {0.0, 0.0, 0.0},
     {7.2e-05, 0.0, 0.0, 0.0, 7.2e-05, 0.0, 0.0, 0.0, 7.2e-05},
     {13888.888888888889, 0.0, 0.0, 0.0, 13888.888888888889, 0.0, 0.0, 0.0, 13888.888888888889}},
    {"left_foot", 0.8, {0.0, -0.03, 0.03},
     {0.00272667, 0.0, 0.0, 0.0, 0.00309333, 0.0, 0.0, 0.0, 0.000486667},
     {366.7477179123253, 0.0, 0.0, 0.0, 323.2762104269509, 0.0, 0.0, 0.0, 2054.793113155402}},
    {"right_hip", 1.4, {0.0, 0.0, -0.03},
     {0.00182, 0.0, 0.0, 0.0, 0.00182, 0.0, 0.0, 0.0, 0.00175},
     {549.4505494505495, 0.0, 0.0, 0.0, 549.4505494505495, 0.0, 0.0, 0.0, 571.4285714285714}},
    {"right_groin", 1.2, {0.0, -0.04, 0.02},
     {0.00139, 0.0, 0.0, 0.0, 0.00139, 0.0, 0.0, 0.0, 0.0015},
     {719.4244604316547, 0.0, 0.0, 0.0, 719.4244604316547, 0.0, 0.0, 0.0, 666.6666666666666}},
    {"right_thigh", 2.6, {0.0, 0.0, -0.1},
     {0.0169867, 0.0, 0.0, 0.0, 0.0169867, 0.0, 0.0, 0.0, 0.00468},
     {58.86958620567856, 0.0, 0.0, 0.0, 58.86958620567856, 0.0, 0.0, 0.0, 213.67521367521366}},
    {"right_shank", 1.8, {-0.13, 0.01, 0.0},
     {0.0018225, 0.0, 0.0, 0.0, 0.0126713, 0.0, 0.0, 0.0, 0.0126713},
     {548.6968449931413, 0.0, 0.0, 0.0, 78.91850086415758, 0.0, 0.0, 0.0, 78.91850086415758}},
    {"right_ankle", 0.2, {0.0, 0.0, 0.0},
     {7.2e-05, 0.0, 0.0, 0.0, 7.2e-05, 0.0, 0.0, 0.0, 7.2e-05},
     {13888.888888888889, 0.0, 0.0, 0.0, 13888.888888888889, 0.0, 0.0, 0.0, 13888.888888888889}},
    {"right_foot", 0.8, {0.0, -0.03, 0.03},
     {0.00272667, 0.0, 0.0, 0.0, 0.00309333, 0.0, 0.0, 0.0, 0.000486667},
     {366.7477179123253, 0.0, 0.0, 0.0, 323.2762104269509, 0.0, 0.0, 0.0, 2054.793113155402}},
    {"waist_link", 0.8, {0.0, 0.0, 0.02},
     {0.00074, 0.0, 0.0, 0.0, 0.00074, 0.0, 0.0, 0.0, 0.001},
     {1351.3513513513515, 0.0, 0.0, 0.0, 1351.3513513513515, 0.0, 0.0, 0.0, 1000.0}},
    {"abdomen", 0.9, {0.0, 0.02, 0.0},
     {0.0010425, 0.0, 0.0, 0.0, 0.001125, 0.0, 0.0, 0.0, 0.0010425},
     {959.2326139088728, 0.0, 0.0, 0.0, 888.8888888888889, 0.0, 0.0, 0.0, 959.2326139088728}},
    {"torso", 9.5, {0.17, 0.01, 0.0},
     {0.0823333, 0.0, 0.0, 0.0, 0.153583, 0.0, 0.0, 0.0, 0.111783},
     {12.145753905163525, 0.0, 0.0, 0.0, 6.511137300352253, 0.0, 0.0, 0.0, 8.945904117799666}},
    {"left_shoulder", 0.8, {0.0, 0.0, 0.03},
     {0.000646667, 0.0, 0.0, 0.0, 0.000646667, 0.0, 0.0, 0.0, 0.00064},
     {1546.3909554685797, 0.0, 0.0, 0.0, 1546.3909554685797, 0.0, 0.0, 0.0, 1562.4999999999998}},
    {"left_shoulder_cap", 0.7, {0.01, -0.03, 0.0},
     {0.0007, 0.0, 0.0, 0.0, 0.0007, 0.0, 0.0, 0.0, 0.0007},
     {1428.5714285714287, 0.0, 0.0, 0.0, 1428.5714285714287, 0.0, 0.0, 0.0, 1428.5714285714287}},
    {"left_upper_arm", 0.8, {0.0, 0.0, -0.05},
     {0.00162667, 0.0, 0.0, 0.0, 0.00162667, 0.0, 0.0, 0.0, 0.00064},
     {614.7528386212323, 0.0, 0.0, 0.0, 614.7528386212323, 0.0, 0.0, 0.0, 1562.4999999999998}},
    {"left_forearm", 0.7, {-0.07, 0.02, 0.0},
     {0.00042875, 0.0, 0.0, 0.0, 0.00170771, 0.0, 0.0, 0.0, 0.00170771},
     {2332.3615160349855, 0.0, 0.0, 0.0, 585.5795187707514, 0.0, 0.0, 0.0, 585.5795187707514}},
    {"left_wrist", 0.2, {0.0, 0.0, -0.01},
     {8.66667e-05, 0.0, 0.0, 0.0, 8.66667e-05, 0.0, 0.0, 0.0, 9e-05},
     {11538.457100593423, 0.0, 0.0, 0.0, 11538.457100593423, 0.0, 0.0, 0.0, 11111.111111111111}},
    {"left_hand", 0.4, {-0.06, 0.0, 0.0},
     {0.000296667, 0.0, 0.0, 0.0, 0.000693333, 0.0, 0.0, 0.0, 0.000563333},
     {3370.7827294576073, 0.0, 0.0, 0.0, 1442.3083857251854, 0.0, 0.0, 0.0, 1775.1489793780945}},
    {"neck", 0.4, {0.0, 0.0, 0.02},
     {0.00021, 0.0, 0.0, 0.0, 0.00021, 0.0, 0.0, 0.0, 0.00018},
     {4761.9047619047615, 0.0, 0.0, 0.0, 4761.9047619047615, 0.0, 0.0, 0.0, 5555.555555555556}},
    {"head", 2.4, {0.09, 0.02, 0.0},
     {0.007776, 0.0, 0.0, 0.0, 0.007776, 0.0, 0.0, 0.0, 0.007776},
     {128.6008230452675, 0.0, 0.0, 0.0, 128.6008230452675, 0.0, 0.0, 0.0, 128.6008230452675}},
    {"right_shoulder", 0.8, {0.0, 0.0, -0.03},
     {0.000646667, 0.0, 0.0, 0.0, 0.000646667, 0.0, 0.0, 0.0, 0.00064},
     {1546.3909554685797, 0.0, 0.0, 0.0, 1546.3909554685797, 0.0, 0.0, 0.0, 1562.4999999999998}},
    {"right_shoulder_cap", 0.7, {-0.01, -0.03, 0.0},
     {0.0007, 0.0, 0.0, 0.0, 0.0007, 0.0, 0.0, 0.0, 0.0007},
     {1428.5714285714287, 0.0, 0.0, 0.0, 1428.5714285714287, 0.0, 0.0, 0.0, 1428.5714285714287}},
    {"right_upper_arm", 0.8, {0.0, 0.0, -0.05},
     {0.00162667, 0.0, 0.0, 0.0, 0.00162667, 0.0, 0.0, 0.0, 0.00064},
     {614.7528386212323, 0.0, 0.0, 0.0, 614.7528386212323, 0.0, 0.0, 0.0, 1562.4999999999998}},
    {"right_forearm", 0.7, {-0.07, 0.02, 0.0},
     {0.00042875, 0.0, 0.0, 0.0, 0.00170771, 0.0, 0.0, 0.0, 0.00170771},
     {2332.3615160349855, 0.0, 0.0, 0.0, 585.5795187707514, 0.0, 0.0, 0.0, 585.5795187707514}},
    {"right_wrist", 0.2, {0.0, 0.0, -0.01},
     {8.66667e-05, 0.0, 0.0, 0.0, 8.66667e-05, 0.0, 0.0, 0.0, 9e-05},
     {11538.457100593423, 0.0, 0.0, 0.0, 11538.457100593423, 0.0, 0.0, 0.0, 11111.111111111111}},
    {"right_hand", 0.4, {-0.06, 0.0, 0.0},
     {0.000296667, 0.0, 0.0, 0.0, 0.000693333, 0.0, 0.0, 0.0, 0.000563333},
     {3370.7827294576073, 0.0, 0.0, 0.0, 1442.3083857251854, 0.0, 0.0, 0.0, 1775.1489793780945}}}};

constexpr std::array<JointConstants, kJointCount> kJoints{ {
    {"__base__", JointKind::kFloating, 0, 0, 7, 0, 6,
     {1.0, 0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 1.0}, {0.0, 0.0, 0.0}},
    {"left_hip_pitch", JointKind::kRevolute, 1, 7, 1, 6, 1,
     {0.0, 1.0, 0.0, 0.0, 0.0, 1.0, 1.0, 0.0, 0.0}, {0.0, 0.09, -0.05}},
    {"left_hip_roll", JointKind::kRevolute, 2, 8, 1, 7, 1,
     {0.0, 1.0, 0.0, 0.0, 0.0, 1.0, 1.0, 0.0, 0.0}, {0.0, 0.0, 0.04}},
    {"left_hip_yaw", JointKind::kRevolute, 3, 9, 1, 8, 1,
     {0.0, 1.0, 0.0, 0.0, 0.0, 1.0, 1.0, 0.0, 0.0}, {0.0, -0.12, 0.0}},
    {"left_knee", JointKind::kRevolute, 4, 10, 1, 9, 1,
     {0.0, 1.0, 0.0, 0.0, 0.0, 1.0, 1.0, 0.0, 0.0}, {0.0, 0.0, -0.24}},
    {"left_ankle_pitch", JointKind::kRevolute, 5, 11, 1, 10, 1,
     {1.0, 0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 1.0}, {-0.3, 0.0, 0.0}},
    {"left_ankle_roll", JointKind::kRevolute, 6, 12, 1, 11, 1,
     {0.0, 1.0, 0.0, 0.0, 0.0, 1.0, 1.0, 0.0, 0.0}, {-0.02, 0.0, 0.0}},
    {"right_hip_pitch", JointKind::kRevolute, 1, 13, 1, 12, 1,
     {0.0, 1.0, 0.0, 0.0, 0.0, 1.0, 1.0, 0.0, 0.0}, {0.0, -0.09, -0.05}},
    {"right_hip_roll", JointKind::kRevolute, 8, 14, 1, 13, 1,
     {0.0, 1.0, 0.0, 0.0, 0.0, 1.0, 1.0, 0.0, 0.0}, {0.0, 0.0, -0.04}},
    {"right_hip_yaw", JointKind::kRevolute, 9, 15, 1, 14, 1,
     {0.0, 1.0, 0.0, 0.0, 0.0, 1.0, 1.0, 0.0, 0.0}, {0.0, -0.12, 0.0}},
    {"right_knee", JointKind::kRevolute, 10, 16, 1, 15, 1,
     {0.0, 1.0, 0.0, 0.0, 0.0, 1.0, 1.0, 0.0, 0.0}, {0.0, 0.0, -0.24}},
    {"right_ankle_pitch", JointKind::kRevolute, 11, 17, 1, 16, 1,
     {1.0, 0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 1.0}, {-0.3, 0.0, 0.0}},
    {"right_ankle_roll", JointKind::kRevolute, 12, 18, 1, 17, 1,
     {0.0, 1.0, 0.0, 0.0, 0.0, 1.0, 1.0, 0.0, 0.0}, {-0.02, 0.0, 0.0}},
    {"waist_yaw", JointKind::kRevolute, 1, 19, 1, 18, 1,
     {1.0, 0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 1.0}, {0.0, 0.0, 0.09}},
    {"waist_roll", JointKind::kRevolute, 14, 20, 1, 19, 1,
     {0.0, 0.0, 1.0, 1.0, 0.0, 0.0, 0.0, 1.0, 0.0}, {0.0, 0.0, 0.05}},
    {"waist_pitch", JointKind::kRevolute, 15, 21, 1, 20, 1,
     {0.0, 0.0, 1.0, 1.0, 0.0, 0.0, 0.0, 1.0, 0.0}, {0.0, 0.04, 0.0}},
    {"left_shoulder_pitch", JointKind::kRevolute, 16, 22, 1, 21, 1,
     {1.0, 0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 1.0}, {0.29, 0.0, 0.15}},
    {"left_shoulder_roll", JointKind::kRevolute, 17, 23, 1, 22, 1,
     {0.0, 1.0, 0.0, 0.0, 0.0, 1.0, 1.0, 0.0, 0.0}, {0.0, 0.0, 0.05}},
    {"left_shoulder_yaw", JointKind::kRevolute, 18, 24, 1, 23, 1,
     {0.0, 1.0, 0.0, 0.0, 0.0, 1.0, 1.0, 0.0, 0.0}, {0.0, -0.1, 0.0}},
    {"left_elbow", JointKind::kRevolute, 19, 25, 1, 24, 1,
     {0.0, 1.0, 0.0, 0.0, 0.0, 1.0, 1.0, 0.0, 0.0}, {0.0, 0.0, -0.11}},
    {"left_wrist_roll", JointKind::kRevolute, 20, 26, 1, 25, 1,
     {0.0, 0.0, 1.0, 1.0, 0.0, 0.0, 0.0, 1.0, 0.0}, {-0.16, 0.01, 0.0}},
    {"left_wrist_pitch", JointKind::kRevolute, 21, 27, 1, 26, 1,
     {0.0, 1.0, 0.0, 0.0, 0.0, 1.0, 1.0, 0.0, 0.0}, {0.0, 0.0, -0.04}},
    {"neck_yaw", JointKind::kRevolute, 16, 28, 1, 27, 1,
     {0.0, 0.0, 1.0, 1.0, 0.0, 0.0, 0.0, 1.0, 0.0}, {0.38, 0.0, 0.0}},
    {"neck_pitch", JointKind::kRevolute, 23, 29, 1, 28, 1,
     {0.0, 1.0, 0.0, 0.0, 0.0, 1.0, 1.0, 0.0, 0.0}, {0.0, 0.0, 0.06}},
    {"right_shoulder_pitch", JointKind::kRevolute, 16, 30, 1, 29, 1,
     {1.0, 0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 1.0}, {0.29, 0.0, -0.15}},
    {"right_shoulder_roll", JointKind::kRevolute, 25, 31, 1, 30, 1,
     {0.0, 1.0, 0.0, 0.0, 0.0, 1.0, 1.0, 0.0, 0.0}, {0.0, 0.0, -0.05}},
    {"right_shoulder_yaw", JointKind::kRevolute, 26, 32, 1, 31, 1,
     {0.0, 1.0, 0.0, 0.0, 0.0, 1.0, 1.0, 0.0, 0.0}, {0.0, -0.1, 0.0}},
    {"right_elbow", JointKind::kRevolute, 27, 33, 1, 32, 1,
     {0.0, 1.0, 0.0, 0.0, 0.0, 1.0, 1.0, 0.0, 0.0}, {0.0, 0.0, -0.11}},
    {"right_wrist_roll", JointKind::kRevolute, 28, 34, 1, 33, 1,
     {0.0, 0.0, 1.0, 1.0, 0.0, 0.0, 0.0, 1.0, 0.0}, {-0.16, 0.01, 0.0}},
    {"right_wrist_pitch", JointKind::kRevolute, 29, 35, 1, 34, 1,
     {0.0, 1.0, 0.0, 0.0, 0.0, 1.0, 1.0, 0.0, 0.0}, {0.0, 0.0, -0.04}}}};

[[maybe_unused]] constexpr std::array<MessageInfo, 8> kMessages{ {
    {2, 1, 27},  // 0: assembled: chain of "left_shoulder_roll"
    {1, 0, 27},  // 1: assembled: chain of "waist_roll"
    {0, 1, 6},  // 2: forces on: chain of "waist_roll"
    {1, 2, 6},  // 3: forces on: chain of "left_shoulder_roll"
    {0, 1, 48},  // 4: state
    {1, 0, 11},  // 5: accelerations
    {0, 2, 36},  // 6: state
    {2, 0, 5}}};  // 7: accelerations

// ---- functions ----------------------------------------------------------------------------------

#include "adagen/joins.hpp"
#include "adagen/channel.hpp"
#include "adagen/joints_memory.hpp"

namespace {

struct Joint_base {
  Transform X;  // frame of "__world__" to that of "pelvis"
  Vec6 v;  // velocity of link "pelvis"
  Columns6 b;  // bias of the bare link "pelvis"
  Mat6 Phi_pelvis;  // of the chain it completes
  Columns6 b_pelvis;
  Joined<Floating> joined;
  Coupled<Floating> at_pelvis;
  Columns6 F_on_pelvis;  // outer wrench on that chain
};

struct Joint_left_hip_pitch {
  Transform X;  // frame of "pelvis" to that of "left_hip"
  Vec6 v;  // velocity of link "left_hip"
  Columns6 b;  // bias of the bare link "left_hip"
  Mat6 Phi_pelvis;  // of the chain it completes
  Columns6 b_pelvis;
  Joined<Revolute> joined;
  Coupled<Revolute> at_pelvis;
  Columns6 F_on_pelvis;  // outer wrench on that chain
};

struct Joint_left_hip_roll {
  Transform X;  // frame of "left_hip" to that of "left_groin"
  Vec6 v;  // velocity of link "left_groin"
  Columns6 b;  // bias of the bare link "left_groin"
  Mat6 Phi_left_hip;  // of the chain it completes
  Columns6 b_left_hip;
  Joined<Revolute> joined;
  Coupled<Revolute> at_left_hip;
  Columns6 F_on_left_hip;  // outer wrench on that chain
};

struct Joint_left_hip_yaw {
  Transform X;  // frame of "left_groin" to that of "left_thigh"
  Vec6 v;  // velocity of link "left_thigh"
  Columns6 b;  // bias of the bare link "left_thigh"
  Mat6 Phi_left_groin;  // of the chain it completes
  Columns6 b_left_groin;
  Joined<Revolute> joined;
  Coupled<Revolute> at_left_groin;
  Columns6 F_on_left_groin;  // outer wrench on that chain
};

struct Joint_left_knee {
  Transform X;  // frame of "left_thigh" to that of "left_shank"
  Vec6 v;  // velocity of link "left_shank"
  Columns6 b;  // bias of the bare link "left_shank"
  Mat6 Phi_left_thigh;  // of the chain it completes
  Columns6 b_left_thigh;
  Joined<Revolute> joined;
  Coupled<Revolute> at_left_thigh;
  Columns6 F_on_left_thigh;  // outer wrench on that chain
};

struct Joint_left_ankle_pitch {
  Transform X;  // frame of "left_shank" to that of "left_ankle"
  Vec6 v;  // velocity of link "left_ankle"
  Columns6 b;  // bias of the bare link "left_ankle"
  Mat6 Phi_left_shank;  // of the chain it completes
  Columns6 b_left_shank;
  Joined<Revolute> joined;
  Coupled<Revolute> at_left_shank;
  Columns6 F_on_left_shank;  // outer wrench on that chain
};

struct Joint_left_ankle_roll {
  Transform X;  // frame of "left_ankle" to that of "left_foot"
  Vec6 v;  // velocity of link "left_foot"
  Columns6 b;  // bias of the bare link "left_foot"
  Mat6 Phi_left_ankle;  // of the chain it completes
  Columns6 b_left_ankle;
  Joined<Revolute> joined;
  Coupled<Revolute> at_left_ankle;
  Columns6 F_on_left_ankle;  // outer wrench on that chain
};

struct Joint_right_hip_pitch {
  Transform X;  // frame of "pelvis" to that of "right_hip"
  Vec6 v;  // velocity of link "right_hip"
  Columns6 b;  // bias of the bare link "right_hip"
  Mat6 Phi_pelvis;  // of the chain it completes
  Columns6 b_pelvis;
  Joined<Revolute> joined;
  Coupled<Revolute> at_pelvis;
  Columns6 F_on_pelvis;  // outer wrench on that chain
};

struct Joint_right_hip_roll {
  Transform X;  // frame of "right_hip" to that of "right_groin"
  Vec6 v;  // velocity of link "right_groin"
  Columns6 b;  // bias of the bare link "right_groin"
  Mat6 Phi_right_hip;  // of the chain it completes
  Columns6 b_right_hip;
  Joined<Revolute> joined;
  Coupled<Revolute> at_right_hip;
  Columns6 F_on_right_hip;  // outer wrench on that chain
};

struct Joint_right_hip_yaw {
  Transform X;  // frame of "right_groin" to that of "right_thigh"
  Vec6 v;  // velocity of link "right_thigh"
  Columns6 b;  // bias of the bare link "right_thigh"
  Mat6 Phi_right_groin;  // of the chain it completes
  Columns6 b_right_groin;
  Joined<Revolute> joined;
  Coupled<Revolute> at_right_groin;
  Columns6 F_on_right_groin;  // outer wrench on that chain
};

struct Joint_right_knee {
  Transform X;  // frame of "right_thigh" to that of "right_shank"
  Vec6 v;  // velocity of link "right_shank"
  Columns6 b;  // bias of the bare link "right_shank"
  Mat6 Phi_right_thigh;  // of the chain it completes
  Columns6 b_right_thigh;
  Joined<Revolute> joined;
  Coupled<Revolute> at_right_thigh;
  Columns6 F_on_right_thigh;  // outer wrench on that chain
};

struct Joint_right_ankle_pitch {
  Transform X;  // frame of "right_shank" to that of "right_ankle"
  Vec6 v;  // velocity of link "right_ankle"
  Columns6 b;  // bias of the bare link "right_ankle"
  Mat6 Phi_right_shank;  // of the chain it completes
  Columns6 b_right_shank;
  Joined<Revolute> joined;
  Coupled<Revolute> at_right_shank;
  Columns6 F_on_right_shank;  // outer wrench on that chain
};

struct Joint_right_ankle_roll {
  Transform X;  // frame of "right_ankle" to that of "right_foot"
  Vec6 v;  // velocity of link "right_foot"
  Columns6 b;  // bias of the bare link "right_foot"
  Mat6 Phi_right_ankle;  // of the chain it completes
  Columns6 b_right_ankle;
  Joined<Revolute> joined;
  Coupled<Revolute> at_right_ankle;
  Columns6 F_on_right_ankle;  // outer wrench on that chain
};

struct Joint_waist_yaw {
  Transform X;  // frame of "pelvis" to that of "waist_link"
  Vec6 v;  // velocity of link "waist_link"
  Joined<Revolute> joined;
  Columns6 b;  // bias of the bare link "waist_link"
};

struct Joint_waist_roll {
  Transform X;  // frame of "waist_link" to that of "abdomen"
  Vec6 v;  // velocity of link "abdomen"
  Columns6 b;  // bias of the bare link "abdomen"
  Mat6 Phi_waist_link;  // of the chain it completes
  Columns6 b_waist_link;
  Joined<Revolute> joined;
  Coupled<Revolute> at_waist_link;
  Columns6 F_on_waist_link;  // outer wrench on that chain
};

struct Joint_waist_pitch {
  Transform X;  // frame of "abdomen" to that of "torso"
  Vec6 v;  // velocity of link "torso"
  Columns6 b;  // bias of the bare link "torso"
  Mat6 Phi_abdomen;  // of the chain it completes
  Columns6 b_abdomen;
  Joined<Revolute> joined;
  Coupled<Revolute> at_abdomen;
  Columns6 F_on_abdomen;  // outer wrench on that chain
};

struct Joint_left_shoulder_pitch {
  Transform X;  // frame of "torso" to that of "left_shoulder"
  Vec6 v;  // velocity of link "left_shoulder"
  Mat6 Phi_torso;  // of the chain it completes
  Columns6 b_torso;
  Joined<Revolute> joined;
  Coupled<Revolute> at_torso;
  Columns6 b;  // bias of the bare link "left_shoulder"
  Columns6 F_on_torso;  // outer wrench on that chain
};

struct Joint_left_shoulder_roll {
  Transform X;  // frame of "left_shoulder" to that of "left_shoulder_cap"
  Vec6 v;  // velocity of link "left_shoulder_cap"
  Columns6 b;  // bias of the bare link "left_shoulder_cap"
  Mat6 Phi_left_shoulder;  // of the chain it completes
  Columns6 b_left_shoulder;
  Joined<Revolute> joined;
  Coupled<Revolute> at_left_shoulder;
  Columns6 F_on_left_shoulder;  // outer wrench on that chain
};

struct Joint_left_shoulder_yaw {
  Transform X;  // frame of "left_shoulder_cap" to that of "left_upper_arm"
  Vec6 v;  // velocity of link "left_upper_arm"
  Columns6 b;  // bias of the bare link "left_upper_arm"
  Mat6 Phi_left_shoulder_cap;  // of the chain it completes
  Columns6 b_left_shoulder_cap;
  Joined<Revolute> joined;
  Coupled<Revolute> at_left_shoulder_cap;
  Columns6 F_on_left_shoulder_cap;  // outer wrench on that chain
};

struct Joint_left_elbow {
  Transform X;  // frame of "left_upper_arm" to that of "left_forearm"
  Vec6 v;  // velocity of link "left_forearm"
  Columns6 b;  // bias of the bare link "left_forearm"
  Mat6 Phi_left_upper_arm;  // of the chain it completes
  Columns6 b_left_upper_arm;
  Joined<Revolute> joined;
  Coupled<Revolute> at_left_upper_arm;
  Columns6 F_on_left_upper_arm;  // outer wrench on that chain
};

struct Joint_left_wrist_roll {
  Transform X;  // frame of "left_forearm" to that of "left_wrist"
  Vec6 v;  // velocity of link "left_wrist"
  Columns6 b;  // bias of the bare link "left_wrist"
  Mat6 Phi_left_forearm;  // of the chain it completes
  Columns6 b_left_forearm;
  Joined<Revolute> joined;
  Coupled<Revolute> at_left_forearm;
  Columns6 F_on_left_forearm;  // outer wrench on that chain
};

struct Joint_left_wrist_pitch {
  Transform X;  // frame of "left_wrist" to that of "left_hand"
  Vec6 v;  // velocity of link "left_hand"
  Columns6 b;  // bias of the bare link "left_hand"
  Mat6 Phi_left_wrist;  // of the chain it completes
  Columns6 b_left_wrist;
  Joined<Revolute> joined;
  Coupled<Revolute> at_left_wrist;
  Columns6 F_on_left_wrist;  // outer wrench on that chain
};

struct Joint_neck_yaw {
  Transform X;  // frame of "torso" to that of "neck"
  Vec6 v;  // velocity of link "neck"
  Columns6 b;  // bias of the bare link "neck"
  Mat6 Phi_torso;  // of the chain it completes
  Columns6 b_torso;
  Joined<Revolute> joined;
  Coupled<Revolute> at_torso;
  Columns6 F_on_torso;  // outer wrench on that chain
};

struct Joint_neck_pitch {
  Transform X;  // frame of "neck" to that of "head"
  Vec6 v;  // velocity of link "head"
  Columns6 b;  // bias of the bare link "head"
  Mat6 Phi_neck;  // of the chain it completes
  Columns6 b_neck;
  Joined<Revolute> joined;
  Coupled<Revolute> at_neck;
  Columns6 F_on_neck;  // outer wrench on that chain
};

struct Joint_right_shoulder_pitch {
  Transform X;  // frame of "torso" to that of "right_shoulder"
  Vec6 v;  // velocity of link "right_shoulder"
  Columns6 b;  // bias of the bare link "right_shoulder"
  Mat6 Phi_torso;  // of the chain it completes
  Columns6 b_torso;
  Joined<Revolute> joined;
  Coupled<Revolute> at_torso;
  Columns6 F_on_torso;  // outer wrench on that chain
};

struct Joint_right_shoulder_roll {
  Transform X;  // frame of "right_shoulder" to that of "right_shoulder_cap"
  Vec6 v;  // velocity of link "right_shoulder_cap"
  Columns6 b;  // bias of the bare link "right_shoulder_cap"
  Mat6 Phi_right_shoulder;  // of the chain it completes
  Columns6 b_right_shoulder;
  Joined<Revolute> joined;
  Coupled<Revolute> at_right_shoulder;
  Columns6 F_on_right_shoulder;  // outer wrench on that chain
};

struct Joint_right_shoulder_yaw {
  Transform X;  // frame of "right_shoulder_cap" to that of "right_upper_arm"
  Vec6 v;  // velocity of link "right_upper_arm"
  Columns6 b;  // bias of the bare link "right_upper_arm"
  Mat6 Phi_right_shoulder_cap;  // of the chain it completes
  Columns6 b_right_shoulder_cap;
  Joined<Revolute> joined;
  Coupled<Revolute> at_right_shoulder_cap;
  Columns6 F_on_right_shoulder_cap;  // outer wrench on that chain
};

struct Joint_right_elbow {
  Transform X;  // frame of "right_upper_arm" to that of "right_forearm"
  Vec6 v;  // velocity of link "right_forearm"
  Columns6 b;  // bias of the bare link "right_forearm"
  Mat6 Phi_right_upper_arm;  // of the chain it completes
  Columns6 b_right_upper_arm;
  Joined<Revolute> joined;
  Coupled<Revolute> at_right_upper_arm;
  Columns6 F_on_right_upper_arm;  // outer wrench on that chain
};

struct Joint_right_wrist_roll {
  Transform X;  // frame of "right_forearm" to that of "right_wrist"
  Vec6 v;  // velocity of link "right_wrist"
  Columns6 b;  // bias of the bare link "right_wrist"
  Mat6 Phi_right_forearm;  // of the chain it completes
  Columns6 b_right_forearm;
  Joined<Revolute> joined;
  Coupled<Revolute> at_right_forearm;
  Columns6 F_on_right_forearm;  // outer wrench on that chain
};

struct Joint_right_wrist_pitch {
  Transform X;  // frame of "right_wrist" to that of "right_hand"
  Vec6 v;  // velocity of link "right_hand"
  Columns6 b;  // bias of the bare link "right_hand"
  Mat6 Phi_right_wrist;  // of the chain it completes
  Columns6 b_right_wrist;
  Joined<Revolute> joined;
  Coupled<Revolute> at_right_wrist;
  Columns6 F_on_right_wrist;  // outer wrench on that chain
};

struct Workspace : JointsMemory {
  Joint_base j_base;  // and of link "pelvis"
  Joint_left_hip_pitch j_left_hip_pitch;  // and of link "left_hip"
  Joint_left_hip_roll j_left_hip_roll;  // and of link "left_groin"
  Joint_left_hip_yaw j_left_hip_yaw;  // and of link "left_thigh"
  Joint_left_knee j_left_knee;  // and of link "left_shank"
  Joint_left_ankle_pitch j_left_ankle_pitch;  // and of link "left_ankle"
  Joint_left_ankle_roll j_left_ankle_roll;  // and of link "left_foot"
  Joint_right_hip_pitch j_right_hip_pitch;  // and of link "right_hip"
  Joint_right_hip_roll j_right_hip_roll;  // and of link "right_groin"
  Joint_right_hip_yaw j_right_hip_yaw;  // and of link "right_thigh"
  Joint_right_knee j_right_knee;  // and of link "right_shank"
  Joint_right_ankle_pitch j_right_ankle_pitch;  // and of link "right_ankle"
  Joint_right_ankle_roll j_right_ankle_roll;  // and of link "right_foot"
  Joint_waist_yaw j_waist_yaw;  // and of link "waist_link"
  Joint_waist_roll j_waist_roll;  // and of link "abdomen"
  Joint_waist_pitch j_waist_pitch;  // and of link "torso"
  Joint_left_shoulder_pitch j_left_shoulder_pitch;  // and of link "left_shoulder"
  Joint_left_shoulder_roll j_left_shoulder_roll;  // and of link "left_shoulder_cap"
  Joint_left_shoulder_yaw j_left_shoulder_yaw;  // and of link "left_upper_arm"
  Joint_left_elbow j_left_elbow;  // and of link "left_forearm"
  Joint_left_wrist_roll j_left_wrist_roll;  // and of link "left_wrist"
  Joint_left_wrist_pitch j_left_wrist_pitch;  // and of link "left_hand"
  Joint_neck_yaw j_neck_yaw;  // and of link "neck"
  Joint_neck_pitch j_neck_pitch;  // and of link "head"
  Joint_right_shoulder_pitch j_right_shoulder_pitch;  // and of link "right_shoulder"
  Joint_right_shoulder_roll j_right_shoulder_roll;  // and of link "right_shoulder_cap"
  Joint_right_shoulder_yaw j_right_shoulder_yaw;  // and of link "right_upper_arm"
  Joint_right_elbow j_right_elbow;  // and of link "right_forearm"
  Joint_right_wrist_roll j_right_wrist_roll;  // and of link "right_wrist"
  Joint_right_wrist_pitch j_right_wrist_pitch;  // and of link "right_hand"
};

}  // namespace

#include "adagen/memory.hpp"
#include "adagen/exchange.hpp"

const Mat6 kPhi_pelvis = symmetric({30.819775200559686, 0.0, 0.0, 0.0, 0.6163955040111937, 0.0, 56.92588818617042, 0.0, -1.1385177637234085, 0.0, 0.0, 28.463025107234447, 0.0, 0.0, 0.0, 0.18406067785511332, 0.0, 0.0, 0.17361823266086904, 0.0, 0.16129032258064516});
const Mat6 kPhi_left_hip = symmetric({549.4505494505495, 0.0, 0.0, 0.0, 16.483516483516482, 0.0, 549.4505494505495, 0.0, -16.483516483516482, 0.0, 0.0, 571.4285714285714, 0.0, 0.0, 0.0, 1.2087912087912087, 0.0, 0.0, 1.2087912087912087, 0.0, 0.7142857142857143});
const Mat6 kPhi_left_groin = symmetric({719.4244604316547, 0.0, 0.0, 0.0, 14.388489208633095, 28.77697841726619, 719.4244604316547, 0.0, -14.388489208633095, 0.0, 0.0, 666.6666666666666, -26.666666666666668, 0.0, 0.0, 2.1877697841726618, 0.0, 0.0, 1.1211031175059953, 0.5755395683453238, 1.984412470023981});
const Mat6 kPhi_left_thigh = symmetric({58.86958620567856, 0.0, 0.0, 0.0, -5.886958620567857, 0.0, 58.86958620567856, 0.0, 5.886958620567857, 0.0, 0.0, 213.67521367521366, 0.0, 0.0, 0.0, 0.9733112466721703, 0.0, 0.0, 0.9733112466721703, 0.0, 0.3846153846153846});
const Mat6 kPhi_left_shank = symmetric({548.6968449931413, 0.0, 0.0, 0.0, 0.0, -5.486968449931413, 78.91850086415758, 0.0, 0.0, 0.0, -10.259405112340486, 78.91850086415758, 0.7891850086415758, 10.259405112340486, 0.0, 0.5634474056419713, 0.10259405112340486, 0.0, 1.8892782201598188, 0.0, 1.944147904659133});
const Mat6 kPhi_left_ankle = symmetric({13888.888888888889, 0.0, 0.0, 0.0, 0.0, 0.0, 13888.888888888889, 0.0, 0.0, 0.0, 0.0, 13888.888888888889, 0.0, 0.0, 0.0, 5.0, 0.0, 0.0, 5.0, 0.0, 5.0});
const Mat6 kPhi_left_foot = symmetric({366.7477179123253, 0.0, 0.0, 0.0, 11.002431537369759, 11.002431537369759, 323.2762104269509, 0.0, -9.698286312808527, 0.0, 0.0, 2054.793113155402, -61.64379339466206, 0.0, 0.0, 3.3902623912241174, 0.0, 0.0, 1.5800729461210927, 0.3300729461210927, 1.5800729461210927});
const Mat6 kPhi_right_hip = symmetric({549.4505494505495, 0.0, 0.0, 0.0, -16.483516483516482, 0.0, 549.4505494505495, 0.0, 16.483516483516482, 0.0, 0.0, 571.4285714285714, 0.0, 0.0, 0.0, 1.2087912087912087, 0.0, 0.0, 1.2087912087912087, 0.0, 0.7142857142857143});
const Mat6 kPhi_right_groin = symmetric({719.4244604316547, 0.0, 0.0, 0.0, 14.388489208633095, 28.77697841726619, 719.4244604316547, 0.0, -14.388489208633095, 0.0, 0.0, 666.6666666666666, -26.666666666666668, 0.0, 0.0, 2.1877697841726618, 0.0, 0.0, 1.1211031175059953, 0.5755395683453238, 1.984412470023981});
const Mat6 kPhi_right_thigh = symmetric({58.86958620567856, 0.0, 0.0, 0.0, -5.886958620567857, 0.0, 58.86958620567856, 0.0, 5.886958620567857, 0.0, 0.0, 213.67521367521366, 0.0, 0.0, 0.0, 0.9733112466721703, 0.0, 0.0, 0.9733112466721703, 0.0, 0.3846153846153846});
const Mat6 kPhi_right_shank = symmetric({548.6968449931413, 0.0, 0.0, 0.0, 0.0, -5.486968449931413, 78.91850086415758, 0.0, 0.0, 0.0, -10.259405112340486, 78.91850086415758, 0.7891850086415758, 10.259405112340486, 0.0, 0.5634474056419713, 0.10259405112340486, 0.0, 1.8892782201598188, 0.0, 1.944147904659133});
const Mat6 kPhi_right_ankle = symmetric({13888.888888888889, 0.0, 0.0, 0.0, 0.0, 0.0, 13888.888888888889, 0.0, 0.0, 0.0, 0.0, 13888.888888888889, 0.0, 0.0, 0.0, 5.0, 0.0, 0.0, 5.0, 0.0, 5.0});
const Mat6 kPhi_right_foot = symmetric({366.7477179123253, 0.0, 0.0, 0.0, 11.002431537369759, 11.002431537369759, 323.2762104269509, 0.0, -9.698286312808527, 0.0, 0.0, 2054.793113155402, -61.64379339466206, 0.0, 0.0, 3.3902623912241174, 0.0, 0.0, 1.5800729461210927, 0.3300729461210927, 1.5800729461210927});
const Mat6 kPhi_waist_link = symmetric({1351.3513513513515, 0.0, 0.0, 0.0, 27.027027027027028, 0.0, 1351.3513513513515, 0.0, -27.027027027027028, 0.0, 0.0, 1000.0, 0.0, 0.0, 0.0, 1.7905405405405406, 0.0, 0.0, 1.7905405405405406, 0.0, 1.25});
const Mat6 kPhi_abdomen = symmetric({959.2326139088728, 0.0, 0.0, 0.0, 0.0, -19.18465227817746, 888.8888888888889, 0.0, 0.0, 0.0, 0.0, 959.2326139088728, 19.18465227817746, 0.0, 0.0, 1.4948041566746602, 0.0, 0.0, 1.1111111111111112, 0.0, 1.4948041566746602});
const Mat6 kPhi_torso = symmetric({12.145753905163525, 0.0, 0.0, 0.0, 0.0, -0.12145753905163525, 6.511137300352253, 0.0, 0.0, 0.0, 1.1068933410598831, 8.945904117799666, 0.08945904117799666, -1.5208037000259433, 0.0, 0.10615774830651681, -0.015208037000259434, 0.0, 0.3637997868991472, 0.0, 0.2946496012654333});
const Mat6 kPhi_left_shoulder = symmetric({1546.3909554685797, 0.0, 0.0, 0.0, 46.39172866405739, 0.0, 1546.3909554685797, 0.0, -46.39172866405739, 0.0, 0.0, 1562.4999999999998, 0.0, 0.0, 0.0, 2.6417518599217216, 0.0, 0.0, 2.6417518599217216, 0.0, 1.25});
const Mat6 kPhi_left_shoulder_cap = symmetric({1428.5714285714287, 0.0, 0.0, 0.0, 0.0, 42.857142857142854, 1428.5714285714287, 0.0, 0.0, 0.0, 14.285714285714286, 1428.5714285714287, -42.857142857142854, -14.285714285714286, 0.0, 2.7142857142857144, 0.42857142857142855, 0.0, 1.5714285714285716, 0.0, 2.857142857142857});
const Mat6 kPhi_left_upper_arm = symmetric({614.7528386212323, 0.0, 0.0, 0.0, -30.737641931061617, 0.0, 614.7528386212323, 0.0, 30.737641931061617, 0.0, 0.0, 1562.4999999999998, 0.0, 0.0, 0.0, 2.786882096553081, 0.0, 0.0, 2.786882096553081, 0.0, 1.25});
const Mat6 kPhi_left_forearm = symmetric({2332.3615160349855, 0.0, 0.0, 0.0, 0.0, -46.64723032069971, 585.5795187707514, 0.0, 0.0, 0.0, -40.990566313952606, 585.5795187707514, 11.71159037541503, 40.990566313952606, 0.0, 1.6628032360797294, 0.8198113262790521, 0.0, 4.297911070548111, 0.0, 5.230855676962106});
const Mat6 kPhi_left_wrist = symmetric({11538.457100593423, 0.0, 0.0, 0.0, -115.38457100593423, 0.0, 11538.457100593423, 0.0, 115.38457100593423, 0.0, 0.0, 11111.111111111111, 0.0, 0.0, 0.0, 6.1538457100593424, 0.0, 0.0, 6.1538457100593424, 0.0, 5.0});
const Mat6 kPhi_left_hand = symmetric({3370.7827294576073, 0.0, 0.0, 0.0, 0.0, 0.0, 1442.3083857251854, 0.0, 0.0, 0.0, -86.53850314351112, 1775.1489793780945, 0.0, 106.50893876268566, 0.0, 2.5, 0.0, 0.0, 8.89053632576114, 0.0, 7.6923101886106675});
const Mat6 kPhi_neck = symmetric({4761.9047619047615, 0.0, 0.0, 0.0, 95.23809523809524, 0.0, 4761.9047619047615, 0.0, -95.23809523809524, 0.0, 0.0, 5555.555555555556, 0.0, 0.0, 0.0, 4.404761904761904, 0.0, 0.0, 4.404761904761904, 0.0, 2.5});
const Mat6 kPhi_head = symmetric({128.6008230452675, 0.0, 0.0, 0.0, 0.0, -2.57201646090535, 128.6008230452675, 0.0, 0.0, 0.0, 11.574074074074074, 128.6008230452675, 2.57201646090535, -11.574074074074074, 0.0, 0.46810699588477367, -0.23148148148148148, 0.0, 1.4583333333333333, 0.0, 1.5097736625514402});
const Mat6 kPhi_right_shoulder = symmetric({1546.3909554685797, 0.0, 0.0, 0.0, -46.39172866405739, 0.0, 1546.3909554685797, 0.0, 46.39172866405739, 0.0, 0.0, 1562.4999999999998, 0.0, 0.0, 0.0, 2.6417518599217216, 0.0, 0.0, 2.6417518599217216, 0.0, 1.25});
const Mat6 kPhi_right_shoulder_cap = symmetric({1428.5714285714287, 0.0, 0.0, 0.0, 0.0, 42.857142857142854, 1428.5714285714287, 0.0, 0.0, 0.0, -14.285714285714286, 1428.5714285714287, -42.857142857142854, 14.285714285714286, 0.0, 2.7142857142857144, -0.42857142857142855, 0.0, 1.5714285714285716, 0.0, 2.857142857142857});
const Mat6 kPhi_right_upper_arm = symmetric({614.7528386212323, 0.0, 0.0, 0.0, -30.737641931061617, 0.0, 614.7528386212323, 0.0, 30.737641931061617, 0.0, 0.0, 1562.4999999999998, 0.0, 0.0, 0.0, 2.786882096553081, 0.0, 0.0, 2.786882096553081, 0.0, 1.25});
const Mat6 kPhi_right_forearm = symmetric({2332.3615160349855, 0.0, 0.0, 0.0, 0.0, -46.64723032069971, 585.5795187707514, 0.0, 0.0, 0.0, -40.990566313952606, 585.5795187707514, 11.71159037541503, 40.990566313952606, 0.0, 1.6628032360797294, 0.8198113262790521, 0.0, 4.297911070548111, 0.0, 5.230855676962106});
const Mat6 kPhi_right_wrist = symmetric({11538.457100593423, 0.0, 0.0, 0.0, -115.38457100593423, 0.0, 11538.457100593423, 0.0, 115.38457100593423, 0.0, 0.0, 11111.111111111111, 0.0, 0.0, 0.0, 6.1538457100593424, 0.0, 0.0, 6.1538457100593424, 0.0, 5.0});
const Mat6 kPhi_right_hand = symmetric({3370.7827294576073, 0.0, 0.0, 0.0, 0.0, 0.0, 1442.3083857251854, 0.0, 0.0, 0.0, -86.53850314351112, 1775.1489793780945, 0.0, 106.50893876268566, 0.0, 2.5, 0.0, 0.0, 8.89053632576114, 0.0, 7.6923101886106675});

// ---- joint 0 "__base__": floating, between links "__world__" and "pelvis"

static void kinematics_base(Workspace& w) {
  auto& i = w.j_base;
  require_finite(w, w.q + 0, 7, 0);
  require_finite(w, w.v + 0, 6, 0);
  const Number* const q = w.q + 0;
  require_length(w, conjugate_rotation(q + 3, i.X.E), 0);
  i.X.r << q[0], q[1], q[2];
  i.v = joint_velocity<Floating>(w.v + 0);
}

// A: the ground "__world__"; B: the chain of "left_hip_pitch"; C feels the joint at "pelvis"
static void assemble_base(Workspace& w) {
  auto& i = w.j_base;
  load_torque(w, 0, 0, i.joined.tau);
  const Columns6 c = Columns6::Zero();
  constexpr std::array<Real, 6> least{4.379753477303394e-13, 8.089655265475019e-13, 4.0448391455405566e-13, 2.615659551780614e-15, 2.4672634802537493e-15, 2.2920733411616134e-15};
  if (!keeps_digits<Floating>(kZero, w.j_left_hip_pitch.Phi_pelvis, least))
    fail(w, kGrowth, 0);
  if (!join(i.joined, kZero, w.j_left_hip_pitch.Phi_pelvis, i.X * w.ground, w.j_left_hip_pitch.b_pelvis, c))
    fail(w, kFactorization, 0);
  couple(i.joined, w.j_left_hip_pitch.Phi_pelvis, i.at_pelvis);
  i.Phi_pelvis = w.j_left_hip_pitch.Phi_pelvis - product(i.at_pelvis, i.at_pelvis);  // Eq. (4)
  i.b_pelvis = w.j_left_hip_pitch.b_pelvis + bias_change(i.joined, i.at_pelvis);  // Eq. (7)
}

static void disassemble_base(Workspace& w) {
  auto& i = w.j_base;
  Release<Floating> release(i.joined);
  release.feel_B(i.at_pelvis, w.j_base.F_on_pelvis);
  const Columns6 f = release.force();  // Eq. (8), (10)
  store_acceleration(w, 0, 0, release.qdd());  // Eq. (9)
  w.j_left_hip_pitch.F_on_pelvis = w.j_base.F_on_pelvis + f;
}

// ---- joint 1 "left_hip_pitch": revolute, between links "pelvis" and "left_hip"

static void kinematics_left_hip_pitch(Workspace& w) {
  auto& i = w.j_left_hip_pitch;
  require_finite(w, w.q + 7, 1, 1);
  require_finite(w, w.v + 6, 1, 1);
  const Real q = Real(w.q[7]), c = std::cos(q), s = std::sin(q);
  i.X.E << s, 0.0, c,  c, 0.0, -s,  0.0, 1.0, 0.0;  // row by row
  i.X.r << 0.0, 0.09, -0.05;
  i.v = i.X * w.j_base.v + joint_velocity<Revolute>(w.v + 6);
}

// A: the chain of "right_hip_pitch"; B: the chain of "left_hip_roll"; C feels the joint at "pelvis"
static void assemble_left_hip_pitch(Workspace& w) {
  auto& i = w.j_left_hip_pitch;
  load_torque(w, 1, 6, i.joined.tau);
  const Mat6 X_Phi_A = i.X * w.j_right_hip_pitch.Phi_pelvis;
  const Mat6 Phi_A = from_right(X_Phi_A, i.X);
  const Columns6 c = velocity_product<Revolute>(i.v, w.v + 6);
  constexpr std::array<Real, 6> least{7.97506041035137e-12, 7.97506041035137e-12, 8.287386887608555e-12, 1.9470029590306893e-14, 1.9470029590306893e-14, 1.2442683852020187e-14};
  if (!keeps_digits<Revolute>(Phi_A, w.j_left_hip_roll.Phi_left_hip, least))
    fail(w, kGrowth, 1);
  if (!join(i.joined, Phi_A, w.j_left_hip_roll.Phi_left_hip, i.X * w.j_right_hip_pitch.b_pelvis, w.j_left_hip_roll.b_left_hip, c))
    fail(w, kFactorization, 1);
  couple(i.joined, X_Phi_A, i.at_pelvis);
  i.Phi_pelvis = w.j_right_hip_pitch.Phi_pelvis - product(i.at_pelvis, i.at_pelvis);  // Eq. (3)
  i.b_pelvis = w.j_right_hip_pitch.b_pelvis - bias_change(i.joined, i.at_pelvis);  // Eq. (6)
}

static void disassemble_left_hip_pitch(Workspace& w) {
  auto& i = w.j_left_hip_pitch;
  Release<Revolute> release(i.joined);
  release.feel_A(i.at_pelvis, w.j_left_hip_pitch.F_on_pelvis);
  const Columns6 f = release.force();  // Eq. (8), (10)
  store_acceleration(w, 1, 6, release.qdd());  // Eq. (9)
  w.j_right_hip_pitch.F_on_pelvis = w.j_left_hip_pitch.F_on_pelvis - i.X.transposed_times(f);
  w.j_left_hip_roll.F_on_left_hip = f;
}

// ---- joint 2 "left_hip_roll": revolute, between links "left_hip" and "left_groin"

static void kinematics_left_hip_roll(Workspace& w) {
  auto& i = w.j_left_hip_roll;
  require_finite(w, w.q + 8, 1, 2);
  require_finite(w, w.v + 7, 1, 2);
  const Real q = Real(w.q[8]), c = std::cos(q), s = std::sin(q);
  i.X.E << s, 0.0, c,  c, 0.0, -s,  0.0, 1.0, 0.0;  // row by row
  i.X.r << 0.0, 0.0, 0.04;
  i.v = i.X * w.j_left_hip_pitch.v + joint_velocity<Revolute>(w.v + 7);
}

// A: link "left_hip"; B: the chain of "left_hip_yaw"; C feels the joint at "left_hip"
static void assemble_left_hip_roll(Workspace& w) {
  auto& i = w.j_left_hip_roll;
  load_torque(w, 2, 7, i.joined.tau);
  const Mat6 X_Phi_A = i.X * kPhi_left_hip;
  const Mat6 Phi_A = from_right(X_Phi_A, i.X);
  const Columns6 c = velocity_product<Revolute>(i.v, w.v + 7);
  constexpr std::array<Real, 6> least{1.2860158696369453e-11, 1.2860158696369453e-11, 1.2110425354080618e-11, 4.1240689064045116e-14, 2.6082444034496316e-14, 3.835080781740452e-14};
  if (!keeps_digits<Revolute>(Phi_A, w.j_left_hip_yaw.Phi_left_groin, least))
    fail(w, kGrowth, 2);
  if (!join(i.joined, Phi_A, w.j_left_hip_yaw.Phi_left_groin, i.X * w.j_left_hip_pitch.b, w.j_left_hip_yaw.b_left_groin, c))
    fail(w, kFactorization, 2);
  couple(i.joined, X_Phi_A, i.at_left_hip);
  i.Phi_left_hip = kPhi_left_hip - product(i.at_left_hip, i.at_left_hip);  // Eq. (3)
  i.b_left_hip = w.j_left_hip_pitch.b - bias_change(i.joined, i.at_left_hip);  // Eq. (6)
}

static void disassemble_left_hip_roll(Workspace& w) {
  auto& i = w.j_left_hip_roll;
  Release<Revolute> release(i.joined);
  release.feel_A(i.at_left_hip, w.j_left_hip_roll.F_on_left_hip);
  const Columns6 f = release.force();  // Eq. (8), (10)
  store_acceleration(w, 2, 7, release.qdd());  // Eq. (9)
  w.j_left_hip_yaw.F_on_left_groin = f;
}

// ---- joint 3 "left_hip_yaw": revolute, between links "left_groin" and "left_thigh"

static void kinematics_left_hip_yaw(Workspace& w) {
  auto& i = w.j_left_hip_yaw;
  require_finite(w, w.q + 9, 1, 3);
  require_finite(w, w.v + 8, 1, 3);
  const Real q = Real(w.q[9]), c = std::cos(q), s = std::sin(q);
  i.X.E << s, 0.0, c,  c, 0.0, -s,  0.0, 1.0, 0.0;  // row by row
  i.X.r << 0.0, -0.12, 0.0;
  i.v = i.X * w.j_left_hip_roll.v + joint_velocity<Revolute>(w.v + 8);
}

// A: link "left_groin"; B: the chain of "left_knee"; C feels the joint at "left_groin"
static void assemble_left_hip_yaw(Workspace& w) {
  auto& i = w.j_left_hip_yaw;
  load_torque(w, 3, 8, i.joined.tau);
  const Mat6 X_Phi_A = i.X * kPhi_left_groin;
  const Mat6 Phi_A = from_right(X_Phi_A, i.X);
  const Columns6 c = velocity_product<Revolute>(i.v, w.v + 8);
  constexpr std::array<Real, 6> least{4.1568802944704355e-12, 4.1568802944704355e-12, 6.3568005755356835e-12, 2.5673963648465354e-14, 2.5673963648465354e-14, 1.7308092281335775e-14};
  if (!keeps_digits<Revolute>(Phi_A, w.j_left_knee.Phi_left_thigh, least))
    fail(w, kGrowth, 3);
  if (!join(i.joined, Phi_A, w.j_left_knee.Phi_left_thigh, i.X * w.j_left_hip_roll.b, w.j_left_knee.b_left_thigh, c))
    fail(w, kFactorization, 3);
  couple(i.joined, X_Phi_A, i.at_left_groin);
  i.Phi_left_groin = kPhi_left_groin - product(i.at_left_groin, i.at_left_groin);  // Eq. (3)
  i.b_left_groin = w.j_left_hip_roll.b - bias_change(i.joined, i.at_left_groin);  // Eq. (6)
}

static void disassemble_left_hip_yaw(Workspace& w) {
  auto& i = w.j_left_hip_yaw;
  Release<Revolute> release(i.joined);
  release.feel_A(i.at_left_groin, w.j_left_hip_yaw.F_on_left_groin);
  const Columns6 f = release.force();  // Eq. (8), (10)
  store_acceleration(w, 3, 8, release.qdd());  // Eq. (9)
  w.j_left_knee.F_on_left_thigh = f;
}

// ---- joint 4 "left_knee": revolute, between links "left_thigh" and "left_shank"

static void kinematics_left_knee(Workspace& w) {
  auto& i = w.j_left_knee;
  require_finite(w, w.q + 10, 1, 4);
  require_finite(w, w.v + 9, 1, 4);
  const Real q = Real(w.q[10]), c = std::cos(q), s = std::sin(q);
  i.X.E << s, 0.0, c,  c, 0.0, -s,  0.0, 1.0, 0.0;  // row by row
  i.X.r << 0.0, 0.0, -0.24;
  i.v = i.X * w.j_left_hip_yaw.v + joint_velocity<Revolute>(w.v + 9);
}

// A: link "left_thigh"; B: the chain of "left_ankle_pitch"; C feels the joint at "left_thigh"
static void assemble_left_knee(Workspace& w) {
  auto& i = w.j_left_knee;
  load_torque(w, 4, 9, i.joined.tau);
  const Mat6 X_Phi_A = i.X * kPhi_left_thigh;
  const Mat6 Phi_A = from_right(X_Phi_A, i.X);
  const Columns6 c = velocity_product<Revolute>(i.v, w.v + 9);
  constexpr std::array<Real, 6> least{8.16509939297173e-12, 1.4891475962065713e-12, 1.4891475962065713e-12, 1.3472782573236314e-14, 3.231397165528738e-14, 3.3093716769976106e-14};
  if (!keeps_digits<Revolute>(Phi_A, w.j_left_ankle_pitch.Phi_left_shank, least))
    fail(w, kGrowth, 4);
  if (!join(i.joined, Phi_A, w.j_left_ankle_pitch.Phi_left_shank, i.X * w.j_left_hip_yaw.b, w.j_left_ankle_pitch.b_left_shank, c))
    fail(w, kFactorization, 4);
  couple(i.joined, X_Phi_A, i.at_left_thigh);
  i.Phi_left_thigh = kPhi_left_thigh - product(i.at_left_thigh, i.at_left_thigh);  // Eq. (3)
  i.b_left_thigh = w.j_left_hip_yaw.b - bias_change(i.joined, i.at_left_thigh);  // Eq. (6)
}

static void disassemble_left_knee(Workspace& w) {
  auto& i = w.j_left_knee;
  Release<Revolute> release(i.joined);
  release.feel_A(i.at_left_thigh, w.j_left_knee.F_on_left_thigh);
  const Columns6 f = release.force();  // Eq. (8), (10)
  store_acceleration(w, 4, 9, release.qdd());  // Eq. (9)
  w.j_left_ankle_pitch.F_on_left_shank = f;
}

// ---- joint 5 "left_ankle_pitch": revolute, between links "left_shank" and "left_ankle"

static void kinematics_left_ankle_pitch(Workspace& w) {
  auto& i = w.j_left_ankle_pitch;
  require_finite(w, w.q + 11, 1, 5);
  require_finite(w, w.v + 10, 1, 5);
  const Real q = Real(w.q[11]), c = std::cos(q), s = std::sin(q);
  i.X.E << c, s, 0.0,  -s, c, 0.0,  0.0, 0.0, 1.0;  // row by row
  i.X.r << -0.3, 0.0, 0.0;
  i.v = i.X * w.j_left_knee.v + joint_velocity<Revolute>(w.v + 10);
}

// A: link "left_shank"; B: the chain of "left_ankle_roll"; C feels the joint at "left_shank"
static void assemble_left_ankle_pitch(Workspace& w) {
  auto& i = w.j_left_ankle_pitch;
  load_torque(w, 5, 10, i.joined.tau);
  const Mat6 X_Phi_A = i.X * kPhi_left_shank;
  const Mat6 Phi_A = from_right(X_Phi_A, i.X);
  const Columns6 c = velocity_product<Revolute>(i.v, w.v + 10);
  constexpr std::array<Real, 6> least{1.978961112703373e-10, 1.978961112703373e-10, 1.978961112703373e-10, 7.894919286223335e-14, 7.894919286223335e-14, 7.894919286223335e-14};
  if (!keeps_digits<Revolute>(Phi_A, w.j_left_ankle_roll.Phi_left_ankle, least))
    fail(w, kGrowth, 5);
  if (!join(i.joined, Phi_A, w.j_left_ankle_roll.Phi_left_ankle, i.X * w.j_left_knee.b, w.j_left_ankle_roll.b_left_ankle, c))
    fail(w, kFactorization, 5);
  couple(i.joined, X_Phi_A, i.at_left_shank);
  i.Phi_left_shank = kPhi_left_shank - product(i.at_left_shank, i.at_left_shank);  // Eq. (3)
  i.b_left_shank = w.j_left_knee.b - bias_change(i.joined, i.at_left_shank);  // Eq. (6)
}

static void disassemble_left_ankle_pitch(Workspace& w) {
  auto& i = w.j_left_ankle_pitch;
  Release<Revolute> release(i.joined);
  release.feel_A(i.at_left_shank, w.j_left_ankle_pitch.F_on_left_shank);
  const Columns6 f = release.force();  // Eq. (8), (10)
  store_acceleration(w, 5, 10, release.qdd());  // Eq. (9)
  w.j_left_ankle_roll.F_on_left_ankle = f;
}

// ---- joint 6 "left_ankle_roll": revolute, between links "left_ankle" and "left_foot"

static void kinematics_left_ankle_roll(Workspace& w) {
  auto& i = w.j_left_ankle_roll;
  require_finite(w, w.q + 12, 1, 6);
  require_finite(w, w.v + 11, 1, 6);
  const Real q = Real(w.q[12]), c = std::cos(q), s = std::sin(q);
  i.X.E << s, 0.0, c,  c, 0.0, -s,  0.0, 1.0, 0.0;  // row by row
  i.X.r << -0.02, 0.0, 0.0;
  i.v = i.X * w.j_left_ankle_pitch.v + joint_velocity<Revolute>(w.v + 11);
}

// A: link "left_ankle"; B: link "left_foot"; C feels the joint at "left_ankle"
static void assemble_left_ankle_roll(Workspace& w) {
  auto& i = w.j_left_ankle_roll;
  load_torque(w, 6, 11, i.joined.tau);
  const Mat6 X_Phi_A = i.X * kPhi_left_ankle;
  const Mat6 Phi_A = from_right(X_Phi_A, i.X);
  const Columns6 c = velocity_product<Revolute>(i.v, w.v + 11);
  constexpr std::array<Real, 6> least{7.100279258824507e-11, 7.03850253111196e-11, 9.499136045271017e-11, 1.192327998641093e-13, 9.350846065275807e-14, 9.350846065275807e-14};
  if (!keeps_digits<Revolute>(Phi_A, kPhi_left_foot, least))
    fail(w, kGrowth, 6);
  if (!join(i.joined, Phi_A, kPhi_left_foot, i.X * w.j_left_ankle_pitch.b, w.j_left_ankle_roll.b, c))
    fail(w, kFactorization, 6);
  couple(i.joined, X_Phi_A, i.at_left_ankle);
  i.Phi_left_ankle = kPhi_left_ankle - product(i.at_left_ankle, i.at_left_ankle);  // Eq. (3)
  i.b_left_ankle = w.j_left_ankle_pitch.b - bias_change(i.joined, i.at_left_ankle);  // Eq. (6)
}

static void disassemble_left_ankle_roll(Workspace& w) {
  auto& i = w.j_left_ankle_roll;
  Release<Revolute> release(i.joined);
  release.feel_A(i.at_left_ankle, w.j_left_ankle_roll.F_on_left_ankle);
  release.force();  // Eq. (8)
  store_acceleration(w, 6, 11, release.qdd());  // Eq. (9)
}

// ---- joint 7 "right_hip_pitch": revolute, between links "pelvis" and "right_hip"

static void kinematics_right_hip_pitch(Workspace& w) {
  auto& i = w.j_right_hip_pitch;
  require_finite(w, w.q + 13, 1, 7);
  require_finite(w, w.v + 12, 1, 7);
  const Real q = Real(w.q[13]), c = std::cos(q), s = std::sin(q);
  i.X.E << s, 0.0, c,  c, 0.0, -s,  0.0, 1.0, 0.0;  // row by row
  i.X.r << 0.0, -0.09, -0.05;
  i.v = i.X * w.j_base.v + joint_velocity<Revolute>(w.v + 12);
}

// A: link "pelvis"; B: the chain of "right_hip_roll"; C feels the joint at "pelvis"
static void assemble_right_hip_pitch(Workspace& w) {
  auto& i = w.j_right_hip_pitch;
  load_torque(w, 7, 12, i.joined.tau);
  const Mat6 X_Phi_A = i.X * kPhi_pelvis;
  const Mat6 Phi_A = from_right(X_Phi_A, i.X);
  const Columns6 c = velocity_product<Revolute>(i.v, w.v + 12);
  constexpr std::array<Real, 6> least{7.97506041035137e-12, 7.97506041035137e-12, 8.287386887608555e-12, 1.9470029590306893e-14, 1.9470029590306893e-14, 1.2442683852020187e-14};
  if (!keeps_digits<Revolute>(Phi_A, w.j_right_hip_roll.Phi_right_hip, least))
    fail(w, kGrowth, 7);
  if (!join(i.joined, Phi_A, w.j_right_hip_roll.Phi_right_hip, i.X * w.j_base.b, w.j_right_hip_roll.b_right_hip, c))
    fail(w, kFactorization, 7);
  couple(i.joined, X_Phi_A, i.at_pelvis);
  i.Phi_pelvis = kPhi_pelvis - product(i.at_pelvis, i.at_pelvis);  // Eq. (3)
  i.b_pelvis = w.j_base.b - bias_change(i.joined, i.at_pelvis);  // Eq. (6)
}

static void disassemble_right_hip_pitch(Workspace& w) {
  auto& i = w.j_right_hip_pitch;
  Release<Revolute> release(i.joined);
  release.feel_A(i.at_pelvis, w.j_right_hip_pitch.F_on_pelvis);
  const Columns6 f = release.force();  // Eq. (8), (10)
  store_acceleration(w, 7, 12, release.qdd());  // Eq. (9)
  w.j_right_hip_roll.F_on_right_hip = f;
}

// ---- joint 8 "right_hip_roll": revolute, between links "right_hip" and "right_groin"

static void kinematics_right_hip_roll(Workspace& w) {
  auto& i = w.j_right_hip_roll;
  require_finite(w, w.q + 14, 1, 8);
  require_finite(w, w.v + 13, 1, 8);
  const Real q = Real(w.q[14]), c = std::cos(q), s = std::sin(q);
  i.X.E << s, 0.0, c,  c, 0.0, -s,  0.0, 1.0, 0.0;  // row by row
  i.X.r << 0.0, 0.0, -0.04;
  i.v = i.X * w.j_right_hip_pitch.v + joint_velocity<Revolute>(w.v + 13);
}

// A: link "right_hip"; B: the chain of "right_hip_yaw"; C feels the joint at "right_hip"
static void assemble_right_hip_roll(Workspace& w) {
  auto& i = w.j_right_hip_roll;
  load_torque(w, 8, 13, i.joined.tau);
  const Mat6 X_Phi_A = i.X * kPhi_right_hip;
  const Mat6 Phi_A = from_right(X_Phi_A, i.X);
  const Columns6 c = velocity_product<Revolute>(i.v, w.v + 13);
  constexpr std::array<Real, 6> least{1.2860158696369453e-11, 1.2860158696369453e-11, 1.2110425354080618e-11, 4.1240689064045116e-14, 2.6082444034496316e-14, 3.835080781740452e-14};
  if (!keeps_digits<Revolute>(Phi_A, w.j_right_hip_yaw.Phi_right_groin, least))
    fail(w, kGrowth, 8);
  if (!join(i.joined, Phi_A, w.j_right_hip_yaw.Phi_right_groin, i.X * w.j_right_hip_pitch.b, w.j_right_hip_yaw.b_right_groin, c))
    fail(w, kFactorization, 8);
  couple(i.joined, X_Phi_A, i.at_right_hip);
  i.Phi_right_hip = kPhi_right_hip - product(i.at_right_hip, i.at_right_hip);  // Eq. (3)
  i.b_right_hip = w.j_right_hip_pitch.b - bias_change(i.joined, i.at_right_hip);  // Eq. (6)
}

static void disassemble_right_hip_roll(Workspace& w) {
  auto& i = w.j_right_hip_roll;
  Release<Revolute> release(i.joined);
  release.feel_A(i.at_right_hip, w.j_right_hip_roll.F_on_right_hip);
  const Columns6 f = release.force();  // Eq. (8), (10)
  store_acceleration(w, 8, 13, release.qdd());  // Eq. (9)
  w.j_right_hip_yaw.F_on_right_groin = f;
}

// ---- joint 9 "right_hip_yaw": revolute, between links "right_groin" and "right_thigh"

static void kinematics_right_hip_yaw(Workspace& w) {
  auto& i = w.j_right_hip_yaw;
  require_finite(w, w.q + 15, 1, 9);
  require_finite(w, w.v + 14, 1, 9);
  const Real q = Real(w.q[15]), c = std::cos(q), s = std::sin(q);
  i.X.E << s, 0.0, c,  c, 0.0, -s,  0.0, 1.0, 0.0;  // row by row
  i.X.r << 0.0, -0.12, 0.0;
  i.v = i.X * w.j_right_hip_roll.v + joint_velocity<Revolute>(w.v + 14);
}

// A: link "right_groin"; B: the chain of "right_knee"; C feels the joint at "right_groin"
static void assemble_right_hip_yaw(Workspace& w) {
  auto& i = w.j_right_hip_yaw;
  load_torque(w, 9, 14, i.joined.tau);
  const Mat6 X_Phi_A = i.X * kPhi_right_groin;
  const Mat6 Phi_A = from_right(X_Phi_A, i.X);
  const Columns6 c = velocity_product<Revolute>(i.v, w.v + 14);
  constexpr std::array<Real, 6> least{4.1568802944704355e-12, 4.1568802944704355e-12, 6.3568005755356835e-12, 2.5673963648465354e-14, 2.5673963648465354e-14, 1.7308092281335775e-14};
  if (!keeps_digits<Revolute>(Phi_A, w.j_right_knee.Phi_right_thigh, least))
    fail(w, kGrowth, 9);
  if (!join(i.joined, Phi_A, w.j_right_knee.Phi_right_thigh, i.X * w.j_right_hip_roll.b, w.j_right_knee.b_right_thigh, c))
    fail(w, kFactorization, 9);
  couple(i.joined, X_Phi_A, i.at_right_groin);
  i.Phi_right_groin = kPhi_right_groin - product(i.at_right_groin, i.at_right_groin);  // Eq. (3)
  i.b_right_groin = w.j_right_hip_roll.b - bias_change(i.joined, i.at_right_groin);  // Eq. (6)
}

static void disassemble_right_hip_yaw(Workspace& w) {
  auto& i = w.j_right_hip_yaw;
  Release<Revolute> release(i.joined);
  release.feel_A(i.at_right_groin, w.j_right_hip_yaw.F_on_right_groin);
  const Columns6 f = release.force();  // Eq. (8), (10)
  store_acceleration(w, 9, 14, release.qdd());  // Eq. (9)
  w.j_right_knee.F_on_right_thigh = f;
}

// ---- joint 10 "right_knee": revolute, between links "right_thigh" and "right_shank"

static void kinematics_right_knee(Workspace& w) {
  auto& i = w.j_right_knee;
  require_finite(w, w.q + 16, 1, 10);
  require_finite(w, w.v + 15, 1, 10);
  const Real q = Real(w.q[16]), c = std::cos(q), s = std::sin(q);
  i.X.E << s, 0.0, c,  c, 0.0, -s,  0.0, 1.0, 0.0;  // row by row
  i.X.r << 0.0, 0.0, -0.24;
  i.v = i.X * w.j_right_hip_yaw.v + joint_velocity<Revolute>(w.v + 15);
}

// A: link "right_thigh"; B: the chain of "right_ankle_pitch"; C feels the joint at "right_thigh"
static void assemble_right_knee(Workspace& w) {
  auto& i = w.j_right_knee;
  load_torque(w, 10, 15, i.joined.tau);
  const Mat6 X_Phi_A = i.X * kPhi_right_thigh;
  const Mat6 Phi_A = from_right(X_Phi_A, i.X);
  const Columns6 c = velocity_product<Revolute>(i.v, w.v + 15);
  constexpr std::array<Real, 6> least{8.16509939297173e-12, 1.4891475962065713e-12, 1.4891475962065713e-12, 1.3472782573236314e-14, 3.231397165528738e-14, 3.3093716769976106e-14};
  if (!keeps_digits<Revolute>(Phi_A, w.j_right_ankle_pitch.Phi_right_shank, least))
    fail(w, kGrowth, 10);
  if (!join(i.joined, Phi_A, w.j_right_ankle_pitch.Phi_right_shank, i.X * w.j_right_hip_yaw.b, w.j_right_ankle_pitch.b_right_shank, c))
    fail(w, kFactorization, 10);
  couple(i.joined, X_Phi_A, i.at_right_thigh);
  i.Phi_right_thigh = kPhi_right_thigh - product(i.at_right_thigh, i.at_right_thigh);  // Eq. (3)
  i.b_right_thigh = w.j_right_hip_yaw.b - bias_change(i.joined, i.at_right_thigh);  // Eq. (6)
}

static void disassemble_right_knee(Workspace& w) {
  auto& i = w.j_right_knee;
  Release<Revolute> release(i.joined);
  release.feel_A(i.at_right_thigh, w.j_right_knee.F_on_right_thigh);
  const Columns6 f = release.force();  // Eq. (8), (10)
  store_acceleration(w, 10, 15, release.qdd());  // Eq. (9)
  w.j_right_ankle_pitch.F_on_right_shank = f;
}

// ---- joint 11 "right_ankle_pitch": revolute, between links "right_shank" and "right_ankle"

static void kinematics_right_ankle_pitch(Workspace& w) {
  auto& i = w.j_right_ankle_pitch;
  require_finite(w, w.q + 17, 1, 11);
  require_finite(w, w.v + 16, 1, 11);
  const Real q = Real(w.q[17]), c = std::cos(q), s = std::sin(q);
  i.X.E << c, s, 0.0,  -s, c, 0.0,  0.0, 0.0, 1.0;  // row by row
  i.X.r << -0.3, 0.0, 0.0;
  i.v = i.X * w.j_right_knee.v + joint_velocity<Revolute>(w.v + 16);
}

// A: link "right_shank"; B: the chain of "right_ankle_roll"; C feels the joint at "right_shank"
static void assemble_right_ankle_pitch(Workspace& w) {
  auto& i = w.j_right_ankle_pitch;
  load_torque(w, 11, 16, i.joined.tau);
  const Mat6 X_Phi_A = i.X * kPhi_right_shank;
  const Mat6 Phi_A = from_right(X_Phi_A, i.X);
  const Columns6 c = velocity_product<Revolute>(i.v, w.v + 16);
  constexpr std::array<Real, 6> least{1.978961112703373e-10, 1.978961112703373e-10, 1.978961112703373e-10, 7.894919286223335e-14, 7.894919286223335e-14, 7.894919286223335e-14};
  if (!keeps_digits<Revolute>(Phi_A, w.j_right_ankle_roll.Phi_right_ankle, least))
    fail(w, kGrowth, 11);
  if (!join(i.joined, Phi_A, w.j_right_ankle_roll.Phi_right_ankle, i.X * w.j_right_knee.b, w.j_right_ankle_roll.b_right_ankle, c))
    fail(w, kFactorization, 11);
  couple(i.joined, X_Phi_A, i.at_right_shank);
  i.Phi_right_shank = kPhi_right_shank - product(i.at_right_shank, i.at_right_shank);  // Eq. (3)
  i.b_right_shank = w.j_right_knee.b - bias_change(i.joined, i.at_right_shank);  // Eq. (6)
}

static void disassemble_right_ankle_pitch(Workspace& w) {
  auto& i = w.j_right_ankle_pitch;
  Release<Revolute> release(i.joined);
  release.feel_A(i.at_right_shank, w.j_right_ankle_pitch.F_on_right_shank);
  const Columns6 f = release.force();  // Eq. (8), (10)
  store_acceleration(w, 11, 16, release.qdd());  // Eq. (9)
  w.j_right_ankle_roll.F_on_right_ankle = f;
}

// ---- joint 12 "right_ankle_roll": revolute, between links "right_ankle" and "right_foot"

static void kinematics_right_ankle_roll(Workspace& w) {
  auto& i = w.j_right_ankle_roll;
  require_finite(w, w.q + 18, 1, 12);
  require_finite(w, w.v + 17, 1, 12);
  const Real q = Real(w.q[18]), c = std::cos(q), s = std::sin(q);
  i.X.E << s, 0.0, c,  c, 0.0, -s,  0.0, 1.0, 0.0;  // row by row
  i.X.r << -0.02, 0.0, 0.0;
  i.v = i.X * w.j_right_ankle_pitch.v + joint_velocity<Revolute>(w.v + 17);
}

// A: link "right_ankle"; B: link "right_foot"; C feels the joint at "right_ankle"
static void assemble_right_ankle_roll(Workspace& w) {
  auto& i = w.j_right_ankle_roll;
  load_torque(w, 12, 17, i.joined.tau);
  const Mat6 X_Phi_A = i.X * kPhi_right_ankle;
  const Mat6 Phi_A = from_right(X_Phi_A, i.X);
  const Columns6 c = velocity_product<Revolute>(i.v, w.v + 17);
  constexpr std::array<Real, 6> least{7.100279258824507e-11, 7.03850253111196e-11, 9.499136045271017e-11, 1.192327998641093e-13, 9.350846065275807e-14, 9.350846065275807e-14};
  if (!keeps_digits<Revolute>(Phi_A, kPhi_right_foot, least))
    fail(w, kGrowth, 12);
  if (!join(i.joined, Phi_A, kPhi_right_foot, i.X * w.j_right_ankle_pitch.b, w.j_right_ankle_roll.b, c))
    fail(w, kFactorization, 12);
  couple(i.joined, X_Phi_A, i.at_right_ankle);
  i.Phi_right_ankle = kPhi_right_ankle - product(i.at_right_ankle, i.at_right_ankle);  // Eq. (3)
  i.b_right_ankle = w.j_right_ankle_pitch.b - bias_change(i.joined, i.at_right_ankle);  // Eq. (6)
}

static void disassemble_right_ankle_roll(Workspace& w) {
  auto& i = w.j_right_ankle_roll;
  Release<Revolute> release(i.joined);
  release.feel_A(i.at_right_ankle, w.j_right_ankle_roll.F_on_right_ankle);
  release.force();  // Eq. (8)
  store_acceleration(w, 12, 17, release.qdd());  // Eq. (9)
}

// ---- joint 13 "waist_yaw": revolute, between links "pelvis" and "waist_link"

static void kinematics_waist_yaw(Workspace& w) {
  auto& i = w.j_waist_yaw;
  require_finite(w, w.q + 19, 1, 13);
  require_finite(w, w.v + 18, 1, 13);
  const Real q = Real(w.q[19]), c = std::cos(q), s = std::sin(q);
  i.X.E << c, s, 0.0,  -s, c, 0.0,  0.0, 0.0, 1.0;  // row by row
  i.X.r << 0.0, 0.0, 0.09;
  i.v = i.X * w.j_base.v + joint_velocity<Revolute>(w.v + 18);
}

// A: the chain of "__base__"; B: the chain of "waist_roll"; C feels the joint at no link
static void assemble_waist_yaw(Workspace& w) {
  auto& i = w.j_waist_yaw;
  load_torque(w, 13, 18, i.joined.tau);
  const Mat6 X_Phi_A = i.X * w.j_base.Phi_pelvis;
  const Mat6 Phi_A = from_right(X_Phi_A, i.X);
  const Columns6 c = velocity_product<Revolute>(i.v, w.v + 18);
  constexpr std::array<Real, 6> least{1.937075620216765e-11, 1.937075620216765e-11, 1.4377753194123701e-11, 2.77371848244625e-14, 2.77371848244625e-14, 2.005564173516412e-14};
  if (!keeps_digits<Revolute>(Phi_A, w.j_waist_roll.Phi_waist_link, least))
    fail(w, kGrowth, 13);
  if (!join(i.joined, Phi_A, w.j_waist_roll.Phi_waist_link, i.X * w.j_base.b_pelvis, w.j_waist_roll.b_waist_link, c))
    fail(w, kFactorization, 13);
}

static void disassemble_waist_yaw(Workspace& w) {
  auto& i = w.j_waist_yaw;
  Release<Revolute> release(i.joined);
  const Columns6 f = release.force();  // Eq. (8), (10)
  store_acceleration(w, 13, 18, release.qdd());  // Eq. (9)
  w.j_base.F_on_pelvis = -i.X.transposed_times(f);
  w.j_waist_roll.F_on_waist_link = f;
}

// ---- joint 14 "waist_roll": revolute, between links "waist_link" and "abdomen"

static void kinematics_waist_roll(Workspace& w) {
  auto& i = w.j_waist_roll;
  require_finite(w, w.q + 20, 1, 14);
  require_finite(w, w.v + 19, 1, 14);
  const Real q = Real(w.q[20]), c = std::cos(q), s = std::sin(q);
  i.X.E << 0.0, c, s,  0.0, -s, c,  1.0, 0.0, 0.0;  // row by row
  i.X.r << 0.0, 0.0, 0.05;
  i.v = i.X * w.j_waist_yaw.v + joint_velocity<Revolute>(w.v + 19);
}

// A: link "waist_link"; B: the chain of "waist_pitch"; C feels the joint at "waist_link"
static void assemble_waist_roll(Workspace& w) {
  auto& i = w.j_waist_roll;
  load_torque(w, 14, 19, i.joined.tau);
  const Mat6 X_Phi_A = i.X * kPhi_waist_link;
  const Mat6 Phi_A = from_right(X_Phi_A, i.X);
  const Columns6 c = velocity_product<Revolute>(i.v, w.v + 19);
  constexpr std::array<Real, 6> least{1.9361698667246485e-11, 1.836205421086137e-11, 1.9361698667246485e-11, 3.9006013092186154e-14, 3.3553406966449176e-14, 3.9006013092186154e-14};
  if (!keeps_digits<Revolute>(Phi_A, w.j_waist_pitch.Phi_abdomen, least))
    fail(w, kGrowth, 14);
  if (!join(i.joined, Phi_A, w.j_waist_pitch.Phi_abdomen, i.X * w.j_waist_yaw.b, w.j_waist_pitch.b_abdomen, c))
    fail(w, kFactorization, 14);
  couple(i.joined, X_Phi_A, i.at_waist_link);
  i.Phi_waist_link = kPhi_waist_link - product(i.at_waist_link, i.at_waist_link);  // Eq. (3)
  i.b_waist_link = w.j_waist_yaw.b - bias_change(i.joined, i.at_waist_link);  // Eq. (6)
}

static void disassemble_waist_roll(Workspace& w) {
  auto& i = w.j_waist_roll;
  Release<Revolute> release(i.joined);
  release.feel_A(i.at_waist_link, w.j_waist_roll.F_on_waist_link);
  const Columns6 f = release.force();  // Eq. (8), (10)
  store_acceleration(w, 14, 19, release.qdd());  // Eq. (9)
  w.j_waist_pitch.F_on_abdomen = f;
}

// ---- joint 15 "waist_pitch": revolute, between links "abdomen" and "torso"

static void kinematics_waist_pitch(Workspace& w) {
  auto& i = w.j_waist_pitch;
  require_finite(w, w.q + 21, 1, 15);
  require_finite(w, w.v + 20, 1, 15);
  const Real q = Real(w.q[21]), c = std::cos(q), s = std::sin(q);
  i.X.E << 0.0, c, s,  0.0, -s, c,  1.0, 0.0, 0.0;  // row by row
  i.X.r << 0.0, 0.04, 0.0;
  i.v = i.X * w.j_waist_roll.v + joint_velocity<Revolute>(w.v + 20);
}

// A: link "abdomen"; B: the chain of "left_shoulder_pitch"; C feels the joint at "abdomen"
static void assemble_waist_pitch(Workspace& w) {
  auto& i = w.j_waist_pitch;
  load_torque(w, 15, 20, i.joined.tau);
  const Mat6 X_Phi_A = i.X * kPhi_abdomen;
  const Mat6 Phi_A = from_right(X_Phi_A, i.X);
  const Columns6 c = velocity_product<Revolute>(i.v, w.v + 20);
  constexpr std::array<Real, 6> least{4.5996590878295124e-12, 4.519586369882674e-12, 4.5541864873908146e-12, 1.7298430910523563e-14, 2.09597444894919e-14, 1.9977061247921946e-14};
  if (!keeps_digits<Revolute>(Phi_A, w.j_left_shoulder_pitch.Phi_torso, least))
    fail(w, kGrowth, 15);
  if (!join(i.joined, Phi_A, w.j_left_shoulder_pitch.Phi_torso, i.X * w.j_waist_roll.b, w.j_left_shoulder_pitch.b_torso, c))
    fail(w, kFactorization, 15);
  couple(i.joined, X_Phi_A, i.at_abdomen);
  i.Phi_abdomen = kPhi_abdomen - product(i.at_abdomen, i.at_abdomen);  // Eq. (3)
  i.b_abdomen = w.j_waist_roll.b - bias_change(i.joined, i.at_abdomen);  // Eq. (6)
}

static void disassemble_waist_pitch(Workspace& w) {
  auto& i = w.j_waist_pitch;
  Release<Revolute> release(i.joined);
  release.feel_A(i.at_abdomen, w.j_waist_pitch.F_on_abdomen);
  const Columns6 f = release.force();  // Eq. (8), (10)
  store_acceleration(w, 15, 20, release.qdd());  // Eq. (9)
  w.j_left_shoulder_pitch.F_on_torso = f;
}

// ---- joint 16 "left_shoulder_pitch": revolute, between links "torso" and "left_shoulder"

static void kinematics_left_shoulder_pitch(Workspace& w) {
  auto& i = w.j_left_shoulder_pitch;
  require_finite(w, w.q + 22, 1, 16);
  require_finite(w, w.v + 21, 1, 16);
  const Real q = Real(w.q[22]), c = std::cos(q), s = std::sin(q);
  i.X.E << c, s, 0.0,  -s, c, 0.0,  0.0, 0.0, 1.0;  // row by row
  i.X.r << 0.29, 0.0, 0.15;
  i.v = i.X * w.j_waist_pitch.v + joint_velocity<Revolute>(w.v + 21);
}

// A: the chain of "neck_yaw"; B: the chain of "left_shoulder_roll"; C feels the joint at "torso"
static void assemble_left_shoulder_pitch(Workspace& w) {
  auto& i = w.j_left_shoulder_pitch;
  load_torque(w, 16, 21, i.joined.tau);
  const Mat6 X_Phi_A = i.X * w.j_neck_yaw.Phi_torso;
  const Mat6 Phi_A = from_right(X_Phi_A, i.X);
  const Columns6 c = velocity_product<Revolute>(i.v, w.v + 21);
  constexpr std::array<Real, 6> least{2.2016408306401386e-11, 2.2016408306401386e-11, 2.2245331597838116e-11, 3.903743131866773e-14, 3.903743131866773e-14, 1.9259447837707977e-14};
  if (!keeps_digits<Revolute>(Phi_A, w.j_left_shoulder_roll.Phi_left_shoulder, least))
    fail(w, kGrowth, 16);
  if (!join(i.joined, Phi_A, w.j_left_shoulder_roll.Phi_left_shoulder, i.X * w.j_neck_yaw.b_torso, w.j_left_shoulder_roll.b_left_shoulder, c))
    fail(w, kFactorization, 16);
  couple(i.joined, X_Phi_A, i.at_torso);
  i.Phi_torso = w.j_neck_yaw.Phi_torso - product(i.at_torso, i.at_torso);  // Eq. (3)
  i.b_torso = w.j_neck_yaw.b_torso - bias_change(i.joined, i.at_torso);  // Eq. (6)
}

static void disassemble_left_shoulder_pitch(Workspace& w) {
  auto& i = w.j_left_shoulder_pitch;
  Release<Revolute> release(i.joined);
  release.feel_A(i.at_torso, w.j_left_shoulder_pitch.F_on_torso);
  const Columns6 f = release.force();  // Eq. (8), (10)
  store_acceleration(w, 16, 21, release.qdd());  // Eq. (9)
  w.j_neck_yaw.F_on_torso = w.j_left_shoulder_pitch.F_on_torso - i.X.transposed_times(f);
  w.j_left_shoulder_roll.F_on_left_shoulder = f;
}

// ---- joint 17 "left_shoulder_roll": revolute, between links "left_shoulder" and "left_shoulder_cap"

static void kinematics_left_shoulder_roll(Workspace& w) {
  auto& i = w.j_left_shoulder_roll;
  require_finite(w, w.q + 23, 1, 17);
  require_finite(w, w.v + 22, 1, 17);
  const Real q = Real(w.q[23]), c = std::cos(q), s = std::sin(q);
  i.X.E << s, 0.0, c,  c, 0.0, -s,  0.0, 1.0, 0.0;  // row by row
  i.X.r << 0.0, 0.0, 0.05;
  i.v = i.X * w.j_left_shoulder_pitch.v + joint_velocity<Revolute>(w.v + 22);
}

// A: link "left_shoulder"; B: the chain of "left_shoulder_yaw"; C feels the joint at "left_shoulder"
static void assemble_left_shoulder_roll(Workspace& w) {
  auto& i = w.j_left_shoulder_roll;
  load_torque(w, 17, 22, i.joined.tau);
  const Mat6 X_Phi_A = i.X * kPhi_left_shoulder;
  const Mat6 Phi_A = from_right(X_Phi_A, i.X);
  const Columns6 c = velocity_product<Revolute>(i.v, w.v + 22);
  constexpr std::array<Real, 6> least{2.765166058115282e-11, 2.765166058115282e-11, 2.765166058115282e-11, 5.633588833526509e-14, 4.009491151789137e-14, 5.836601043743681e-14};
  if (!keeps_digits<Revolute>(Phi_A, w.j_left_shoulder_yaw.Phi_left_shoulder_cap, least))
    fail(w, kGrowth, 17);
  if (!join(i.joined, Phi_A, w.j_left_shoulder_yaw.Phi_left_shoulder_cap, i.X * w.j_left_shoulder_pitch.b, w.j_left_shoulder_yaw.b_left_shoulder_cap, c))
    fail(w, kFactorization, 17);
  couple(i.joined, X_Phi_A, i.at_left_shoulder);
  i.Phi_left_shoulder = kPhi_left_shoulder - product(i.at_left_shoulder, i.at_left_shoulder);  // Eq. (3)
  i.b_left_shoulder = w.j_left_shoulder_pitch.b - bias_change(i.joined, i.at_left_shoulder);  // Eq. (6)
}

static void disassemble_left_shoulder_roll(Workspace& w) {
  auto& i = w.j_left_shoulder_roll;
  Release<Revolute> release(i.joined);
  release.feel_A(i.at_left_shoulder, w.j_left_shoulder_roll.F_on_left_shoulder);
  const Columns6 f = release.force();  // Eq. (8), (10)
  store_acceleration(w, 17, 22, release.qdd());  // Eq. (9)
  w.j_left_shoulder_yaw.F_on_left_shoulder_cap = f;
}

// ---- joint 18 "left_shoulder_yaw": revolute, between links "left_shoulder_cap" and "left_upper_arm"

static void kinematics_left_shoulder_yaw(Workspace& w) {
  auto& i = w.j_left_shoulder_yaw;
  require_finite(w, w.q + 24, 1, 18);
  require_finite(w, w.v + 23, 1, 18);
  const Real q = Real(w.q[24]), c = std::cos(q), s = std::sin(q);
  i.X.E << s, 0.0, c,  c, 0.0, -s,  0.0, 1.0, 0.0;  // row by row
  i.X.r << 0.0, -0.1, 0.0;
  i.v = i.X * w.j_left_shoulder_roll.v + joint_velocity<Revolute>(w.v + 23);
}

// A: link "left_shoulder_cap"; B: the chain of "left_elbow"; C feels the joint at "left_shoulder_cap"
static void assemble_left_shoulder_yaw(Workspace& w) {
  auto& i = w.j_left_shoulder_yaw;
  load_torque(w, 18, 23, i.joined.tau);
  const Mat6 X_Phi_A = i.X * kPhi_left_shoulder_cap;
  const Mat6 Phi_A = from_right(X_Phi_A, i.X);
  const Columns6 c = velocity_product<Revolute>(i.v, w.v + 23);
  constexpr std::array<Real, 6> least{1.550323694931007e-11, 1.550323694931007e-11, 2.8971534166408843e-11, 5.990519760423054e-14, 5.990519760423054e-14, 3.8064789415719656e-14};
  if (!keeps_digits<Revolute>(Phi_A, w.j_left_elbow.Phi_left_upper_arm, least))
    fail(w, kGrowth, 18);
  if (!join(i.joined, Phi_A, w.j_left_elbow.Phi_left_upper_arm, i.X * w.j_left_shoulder_roll.b, w.j_left_elbow.b_left_upper_arm, c))
    fail(w, kFactorization, 18);
  couple(i.joined, X_Phi_A, i.at_left_shoulder_cap);
  i.Phi_left_shoulder_cap = kPhi_left_shoulder_cap - product(i.at_left_shoulder_cap, i.at_left_shoulder_cap);  // Eq. (3)
  i.b_left_shoulder_cap = w.j_left_shoulder_roll.b - bias_change(i.joined, i.at_left_shoulder_cap);  // Eq. (6)
}

static void disassemble_left_shoulder_yaw(Workspace& w) {
  auto& i = w.j_left_shoulder_yaw;
  Release<Revolute> release(i.joined);
  release.feel_A(i.at_left_shoulder_cap, w.j_left_shoulder_yaw.F_on_left_shoulder_cap);
  const Columns6 f = release.force();  // Eq. (8), (10)
  store_acceleration(w, 18, 23, release.qdd());  // Eq. (9)
  w.j_left_elbow.F_on_left_upper_arm = f;
}

// ---- joint 19 "left_elbow": revolute, between links "left_upper_arm" and "left_forearm"

static void kinematics_left_elbow(Workspace& w) {
  auto& i = w.j_left_elbow;
  require_finite(w, w.q + 25, 1, 19);
  require_finite(w, w.v + 24, 1, 19);
  const Real q = Real(w.q[25]), c = std::cos(q), s = std::sin(q);
  i.X.E << s, 0.0, c,  c, 0.0, -s,  0.0, 1.0, 0.0;  // row by row
  i.X.r << 0.0, 0.0, -0.11;
  i.v = i.X * w.j_left_shoulder_yaw.v + joint_velocity<Revolute>(w.v + 24);
}

// A: link "left_upper_arm"; B: the chain of "left_wrist_roll"; C feels the joint at "left_upper_arm"
static void assemble_left_elbow(Workspace& w) {
  auto& i = w.j_left_elbow;
  load_torque(w, 19, 24, i.joined.tau);
  const Mat6 X_Phi_A = i.X * kPhi_left_upper_arm;
  const Mat6 Phi_A = from_right(X_Phi_A, i.X);
  const Columns6 c = velocity_product<Revolute>(i.v, w.v + 24);
  constexpr std::array<Real, 6> least{3.679489269776697e-11, 1.197162751551455e-11, 1.197162751551455e-11, 4.139342360189928e-14, 7.884055819642003e-14, 9.209849845550062e-14};
  if (!keeps_digits<Revolute>(Phi_A, w.j_left_wrist_roll.Phi_left_forearm, least))
    fail(w, kGrowth, 19);
  if (!join(i.joined, Phi_A, w.j_left_wrist_roll.Phi_left_forearm, i.X * w.j_left_shoulder_yaw.b, w.j_left_wrist_roll.b_left_forearm, c))
    fail(w, kFactorization, 19);
  couple(i.joined, X_Phi_A, i.at_left_upper_arm);
  i.Phi_left_upper_arm = kPhi_left_upper_arm - product(i.at_left_upper_arm, i.at_left_upper_arm);  // Eq. (3)
  i.b_left_upper_arm = w.j_left_shoulder_yaw.b - bias_change(i.joined, i.at_left_upper_arm);  // Eq. (6)
}

static void disassemble_left_elbow(Workspace& w) {
  auto& i = w.j_left_elbow;
  Release<Revolute> release(i.joined);
  release.feel_A(i.at_left_upper_arm, w.j_left_elbow.F_on_left_upper_arm);
  const Columns6 f = release.force();  // Eq. (8), (10)
  store_acceleration(w, 19, 24, release.qdd());  // Eq. (9)
  w.j_left_wrist_roll.F_on_left_forearm = f;
}

// ---- joint 20 "left_wrist_roll": revolute, between links "left_forearm" and "left_wrist"

static void kinematics_left_wrist_roll(Workspace& w) {
  auto& i = w.j_left_wrist_roll;
  require_finite(w, w.q + 26, 1, 20);
  require_finite(w, w.v + 25, 1, 20);
  const Real q = Real(w.q[26]), c = std::cos(q), s = std::sin(q);
  i.X.E << 0.0, c, s,  0.0, -s, c,  1.0, 0.0, 0.0;  // row by row
  i.X.r << -0.16, 0.01, 0.0;
  i.v = i.X * w.j_left_elbow.v + joint_velocity<Revolute>(w.v + 25);
}

// A: link "left_forearm"; B: the chain of "left_wrist_pitch"; C feels the joint at "left_forearm"
static void assemble_left_wrist_roll(Workspace& w) {
  auto& i = w.j_left_wrist_roll;
  load_torque(w, 20, 25, i.joined.tau);
  const Mat6 X_Phi_A = i.X * kPhi_left_forearm;
  const Mat6 Phi_A = from_right(X_Phi_A, i.X);
  const Columns6 c = velocity_product<Revolute>(i.v, w.v + 25);
  constexpr std::array<Real, 6> least{1.6766806649289416e-10, 1.6766806649289416e-10, 1.6159511472323679e-10, 1.0775262834713958e-13, 1.0775262834713958e-13, 9.135549459772717e-14};
  if (!keeps_digits<Revolute>(Phi_A, w.j_left_wrist_pitch.Phi_left_wrist, least))
    fail(w, kGrowth, 20);
  if (!join(i.joined, Phi_A, w.j_left_wrist_pitch.Phi_left_wrist, i.X * w.j_left_elbow.b, w.j_left_wrist_pitch.b_left_wrist, c))
    fail(w, kFactorization, 20);
  couple(i.joined, X_Phi_A, i.at_left_forearm);
  i.Phi_left_forearm = kPhi_left_forearm - product(i.at_left_forearm, i.at_left_forearm);  // Eq. (3)
  i.b_left_forearm = w.j_left_elbow.b - bias_change(i.joined, i.at_left_forearm);  // Eq. (6)
}

static void disassemble_left_wrist_roll(Workspace& w) {
  auto& i = w.j_left_wrist_roll;
  Release<Revolute> release(i.joined);
  release.feel_A(i.at_left_forearm, w.j_left_wrist_roll.F_on_left_forearm);
  const Columns6 f = release.force();  // Eq. (8), (10)
  store_acceleration(w, 20, 25, release.qdd());  // Eq. (9)
  w.j_left_wrist_pitch.F_on_left_wrist = f;
}

// ---- joint 21 "left_wrist_pitch": revolute, between links "left_wrist" and "left_hand"

static void kinematics_left_wrist_pitch(Workspace& w) {
  auto& i = w.j_left_wrist_pitch;
  require_finite(w, w.q + 27, 1, 21);
  require_finite(w, w.v + 26, 1, 21);
  const Real q = Real(w.q[27]), c = std::cos(q), s = std::sin(q);
  i.X.E << s, 0.0, c,  c, 0.0, -s,  0.0, 1.0, 0.0;  // row by row
  i.X.r << 0.0, 0.0, -0.04;
  i.v = i.X * w.j_left_wrist_roll.v + joint_velocity<Revolute>(w.v + 26);
}

// A: link "left_wrist"; B: link "left_hand"; C feels the joint at "left_wrist"
static void assemble_left_wrist_pitch(Workspace& w) {
  auto& i = w.j_left_wrist_pitch;
  load_torque(w, 21, 26, i.joined.tau);
  const Mat6 X_Phi_A = i.X * kPhi_left_wrist;
  const Mat6 Phi_A = from_right(X_Phi_A, i.X);
  const Columns6 c = velocity_product<Revolute>(i.v, w.v + 26);
  constexpr std::array<Real, 6> least{1.0186696105313099e-10, 7.446169233235501e-11, 7.919164165207809e-11, 1.0658141036401503e-13, 1.973963936416274e-13, 1.8036857609062434e-13};
  if (!keeps_digits<Revolute>(Phi_A, kPhi_left_hand, least))
    fail(w, kGrowth, 21);
  if (!join(i.joined, Phi_A, kPhi_left_hand, i.X * w.j_left_wrist_roll.b, w.j_left_wrist_pitch.b, c))
    fail(w, kFactorization, 21);
  couple(i.joined, X_Phi_A, i.at_left_wrist);
  i.Phi_left_wrist = kPhi_left_wrist - product(i.at_left_wrist, i.at_left_wrist);  // Eq. (3)
  i.b_left_wrist = w.j_left_wrist_roll.b - bias_change(i.joined, i.at_left_wrist);  // Eq. (6)
}

static void disassemble_left_wrist_pitch(Workspace& w) {
  auto& i = w.j_left_wrist_pitch;
  Release<Revolute> release(i.joined);
  release.feel_A(i.at_left_wrist, w.j_left_wrist_pitch.F_on_left_wrist);
  release.force();  // Eq. (8)
  store_acceleration(w, 21, 26, release.qdd());  // Eq. (9)
}

// ---- joint 22 "neck_yaw": revolute, between links "torso" and "neck"

static void kinematics_neck_yaw(Workspace& w) {
  auto& i = w.j_neck_yaw;
  require_finite(w, w.q + 28, 1, 22);
  require_finite(w, w.v + 27, 1, 22);
  const Real q = Real(w.q[28]), c = std::cos(q), s = std::sin(q);
  i.X.E << 0.0, c, s,  0.0, -s, c,  1.0, 0.0, 0.0;  // row by row
  i.X.r << 0.38, 0.0, 0.0;
  i.v = i.X * w.j_waist_pitch.v + joint_velocity<Revolute>(w.v + 27);
}

// A: the chain of "right_shoulder_pitch"; B: the chain of "neck_pitch"; C feels the joint at "torso"
static void assemble_neck_yaw(Workspace& w) {
  auto& i = w.j_neck_yaw;
  load_torque(w, 22, 27, i.joined.tau);
  const Mat6 X_Phi_A = i.X * w.j_right_shoulder_pitch.Phi_torso;
  const Mat6 Phi_A = from_right(X_Phi_A, i.X);
  const Columns6 c = velocity_product<Revolute>(i.v, w.v + 27);
  constexpr std::array<Real, 6> least{6.771160784439214e-11, 6.771160784439214e-11, 7.899006396756834e-11, 6.409131092733334e-14, 6.409131092733334e-14, 3.702301623171048e-14};
  if (!keeps_digits<Revolute>(Phi_A, w.j_neck_pitch.Phi_neck, least))
    fail(w, kGrowth, 22);
  if (!join(i.joined, Phi_A, w.j_neck_pitch.Phi_neck, i.X * w.j_right_shoulder_pitch.b_torso, w.j_neck_pitch.b_neck, c))
    fail(w, kFactorization, 22);
  couple(i.joined, X_Phi_A, i.at_torso);
  i.Phi_torso = w.j_right_shoulder_pitch.Phi_torso - product(i.at_torso, i.at_torso);  // Eq. (3)
  i.b_torso = w.j_right_shoulder_pitch.b_torso - bias_change(i.joined, i.at_torso);  // Eq. (6)
}

static void disassemble_neck_yaw(Workspace& w) {
  auto& i = w.j_neck_yaw;
  Release<Revolute> release(i.joined);
  release.feel_A(i.at_torso, w.j_neck_yaw.F_on_torso);
  const Columns6 f = release.force();  // Eq. (8), (10)
  store_acceleration(w, 22, 27, release.qdd());  // Eq. (9)
  w.j_right_shoulder_pitch.F_on_torso = w.j_neck_yaw.F_on_torso - i.X.transposed_times(f);
  w.j_neck_pitch.F_on_neck = f;
}

// ---- joint 23 "neck_pitch": revolute, between links "neck" and "head"

static void kinematics_neck_pitch(Workspace& w) {
  auto& i = w.j_neck_pitch;
  require_finite(w, w.q + 29, 1, 23);
  require_finite(w, w.v + 28, 1, 23);
  const Real q = Real(w.q[29]), c = std::cos(q), s = std::sin(q);
  i.X.E << s, 0.0, c,  c, 0.0, -s,  0.0, 1.0, 0.0;  // row by row
  i.X.r << 0.0, 0.0, 0.06;
  i.v = i.X * w.j_neck_yaw.v + joint_velocity<Revolute>(w.v + 28);
}

// A: link "neck"; B: link "head"; C feels the joint at "neck"
static void assemble_neck_pitch(Workspace& w) {
  auto& i = w.j_neck_pitch;
  load_torque(w, 23, 28, i.joined.tau);
  const Mat6 X_Phi_A = i.X * kPhi_neck;
  const Mat6 Phi_A = from_right(X_Phi_A, i.X);
  const Columns6 c = velocity_product<Revolute>(i.v, w.v + 28);
  constexpr std::array<Real, 6> least{2.5512285471221703e-11, 2.5512285471221703e-11, 2.5512285471221703e-11, 4.217933729769319e-14, 5.625129991434126e-14, 5.698231095936195e-14};
  if (!keeps_digits<Revolute>(Phi_A, kPhi_head, least))
    fail(w, kGrowth, 23);
  if (!join(i.joined, Phi_A, kPhi_head, i.X * w.j_neck_yaw.b, w.j_neck_pitch.b, c))
    fail(w, kFactorization, 23);
  couple(i.joined, X_Phi_A, i.at_neck);
  i.Phi_neck = kPhi_neck - product(i.at_neck, i.at_neck);  // Eq. (3)
  i.b_neck = w.j_neck_yaw.b - bias_change(i.joined, i.at_neck);  // Eq. (6)
}

static void disassemble_neck_pitch(Workspace& w) {
  auto& i = w.j_neck_pitch;
  Release<Revolute> release(i.joined);
  release.feel_A(i.at_neck, w.j_neck_pitch.F_on_neck);
  release.force();  // Eq. (8)
  store_acceleration(w, 23, 28, release.qdd());  // Eq. (9)
}

// ---- joint 24 "right_shoulder_pitch": revolute, between links "torso" and "right_shoulder"

static void kinematics_right_shoulder_pitch(Workspace& w) {
  auto& i = w.j_right_shoulder_pitch;
  require_finite(w, w.q + 30, 1, 24);
  require_finite(w, w.v + 29, 1, 24);
  const Real q = Real(w.q[30]), c = std::cos(q), s = std::sin(q);
  i.X.E << c, s, 0.0,  -s, c, 0.0,  0.0, 0.0, 1.0;  // row by row
  i.X.r << 0.29, 0.0, -0.15;
  i.v = i.X * w.j_waist_pitch.v + joint_velocity<Revolute>(w.v + 29);
}

// A: link "torso"; B: the chain of "right_shoulder_roll"; C feels the joint at "torso"
static void assemble_right_shoulder_pitch(Workspace& w) {
  auto& i = w.j_right_shoulder_pitch;
  load_torque(w, 24, 29, i.joined.tau);
  const Mat6 X_Phi_A = i.X * kPhi_torso;
  const Mat6 Phi_A = from_right(X_Phi_A, i.X);
  const Columns6 c = velocity_product<Revolute>(i.v, w.v + 29);
  constexpr std::array<Real, 6> least{2.2016408306401386e-11, 2.2016408306401386e-11, 2.2245331597838116e-11, 3.903743131866773e-14, 3.903743131866773e-14, 1.9259447837707977e-14};
  if (!keeps_digits<Revolute>(Phi_A, w.j_right_shoulder_roll.Phi_right_shoulder, least))
    fail(w, kGrowth, 24);
  if (!join(i.joined, Phi_A, w.j_right_shoulder_roll.Phi_right_shoulder, i.X * w.j_waist_pitch.b, w.j_right_shoulder_roll.b_right_shoulder, c))
    fail(w, kFactorization, 24);
  couple(i.joined, X_Phi_A, i.at_torso);
  i.Phi_torso = kPhi_torso - product(i.at_torso, i.at_torso);  // Eq. (3)
  i.b_torso = w.j_waist_pitch.b - bias_change(i.joined, i.at_torso);  // Eq. (6)
}

static void disassemble_right_shoulder_pitch(Workspace& w) {
  auto& i = w.j_right_shoulder_pitch;
  Release<Revolute> release(i.joined);
  release.feel_A(i.at_torso, w.j_right_shoulder_pitch.F_on_torso);
  const Columns6 f = release.force();  // Eq. (8), (10)
  store_acceleration(w, 24, 29, release.qdd());  // Eq. (9)
  w.j_right_shoulder_roll.F_on_right_shoulder = f;
}

// ---- joint 25 "right_shoulder_roll": revolute, between links "right_shoulder" and "right_shoulder_cap"

static void kinematics_right_shoulder_roll(Workspace& w) {
  auto& i = w.j_right_shoulder_roll;
  require_finite(w, w.q + 31, 1, 25);
  require_finite(w, w.v + 30, 1, 25);
  const Real q = Real(w.q[31]), c = std::cos(q), s = std::sin(q);
  i.X.E << s, 0.0, c,  c, 0.0, -s,  0.0, 1.0, 0.0;  // row by row
  i.X.r << 0.0, 0.0, -0.05;
  i.v = i.X * w.j_right_shoulder_pitch.v + joint_velocity<Revolute>(w.v + 30);
}

// A: link "right_shoulder"; B: the chain of "right_shoulder_yaw"; C feels the joint at "right_shoulder"
static void assemble_right_shoulder_roll(Workspace& w) {
  auto& i = w.j_right_shoulder_roll;
  load_torque(w, 25, 30, i.joined.tau);
  const Mat6 X_Phi_A = i.X * kPhi_right_shoulder;
  const Mat6 Phi_A = from_right(X_Phi_A, i.X);
  const Columns6 c = velocity_product<Revolute>(i.v, w.v + 30);
  constexpr std::array<Real, 6> least{2.765166058115282e-11, 2.765166058115282e-11, 2.765166058115282e-11, 5.633588833526509e-14, 4.009491151789137e-14, 5.836601043743681e-14};
  if (!keeps_digits<Revolute>(Phi_A, w.j_right_shoulder_yaw.Phi_right_shoulder_cap, least))
    fail(w, kGrowth, 25);
  if (!join(i.joined, Phi_A, w.j_right_shoulder_yaw.Phi_right_shoulder_cap, i.X * w.j_right_shoulder_pitch.b, w.j_right_shoulder_yaw.b_right_shoulder_cap, c))
    fail(w, kFactorization, 25);
  couple(i.joined, X_Phi_A, i.at_right_shoulder);
  i.Phi_right_shoulder = kPhi_right_shoulder - product(i.at_right_shoulder, i.at_right_shoulder);  // Eq. (3)
  i.b_right_shoulder = w.j_right_shoulder_pitch.b - bias_change(i.joined, i.at_right_shoulder);  // Eq. (6)
}

static void disassemble_right_shoulder_roll(Workspace& w) {
  auto& i = w.j_right_shoulder_roll;
  Release<Revolute> release(i.joined);
  release.feel_A(i.at_right_shoulder, w.j_right_shoulder_roll.F_on_right_shoulder);
  const Columns6 f = release.force();  // Eq. (8), (10)
  store_acceleration(w, 25, 30, release.qdd());  // Eq. (9)
  w.j_right_shoulder_yaw.F_on_right_shoulder_cap = f;
}

// ---- joint 26 "right_shoulder_yaw": revolute, between links "right_shoulder_cap" and "right_upper_arm"

static void kinematics_right_shoulder_yaw(Workspace& w) {
  auto& i = w.j_right_shoulder_yaw;
  require_finite(w, w.q + 32, 1, 26);
  require_finite(w, w.v + 31, 1, 26);
  const Real q = Real(w.q[32]), c = std::cos(q), s = std::sin(q);
  i.X.E << s, 0.0, c,  c, 0.0, -s,  0.0, 1.0, 0.0;  // row by row
  i.X.r << 0.0, -0.1, 0.0;
  i.v = i.X * w.j_right_shoulder_roll.v + joint_velocity<Revolute>(w.v + 31);
}

// A: link "right_shoulder_cap"; B: the chain of "right_elbow"; C feels the joint at "right_shoulder_cap"
static void assemble_right_shoulder_yaw(Workspace& w) {
  auto& i = w.j_right_shoulder_yaw;
  load_torque(w, 26, 31, i.joined.tau);
  const Mat6 X_Phi_A = i.X * kPhi_right_shoulder_cap;
  const Mat6 Phi_A = from_right(X_Phi_A, i.X);
  const Columns6 c = velocity_product<Revolute>(i.v, w.v + 31);
  constexpr std::array<Real, 6> least{1.550323694931007e-11, 1.550323694931007e-11, 2.8971534166408843e-11, 5.990519760423054e-14, 5.990519760423054e-14, 3.8064789415719656e-14};
  if (!keeps_digits<Revolute>(Phi_A, w.j_right_elbow.Phi_right_upper_arm, least))
    fail(w, kGrowth, 26);
  if (!join(i.joined, Phi_A, w.j_right_elbow.Phi_right_upper_arm, i.X * w.j_right_shoulder_roll.b, w.j_right_elbow.b_right_upper_arm, c))
    fail(w, kFactorization, 26);
  couple(i.joined, X_Phi_A, i.at_right_shoulder_cap);
  i.Phi_right_shoulder_cap = kPhi_right_shoulder_cap - product(i.at_right_shoulder_cap, i.at_right_shoulder_cap);  // Eq. (3)
  i.b_right_shoulder_cap = w.j_right_shoulder_roll.b - bias_change(i.joined, i.at_right_shoulder_cap);  // Eq. (6)
}

static void disassemble_right_shoulder_yaw(Workspace& w) {
  auto& i = w.j_right_shoulder_yaw;
  Release<Revolute> release(i.joined);
  release.feel_A(i.at_right_shoulder_cap, w.j_right_shoulder_yaw.F_on_right_shoulder_cap);
  const Columns6 f = release.force();  // Eq. (8), (10)
  store_acceleration(w, 26, 31, release.qdd());  // Eq. (9)
  w.j_right_elbow.F_on_right_upper_arm = f;
}

// ---- joint 27 "right_elbow": revolute, between links "right_upper_arm" and "right_forearm"

static void kinematics_right_elbow(Workspace& w) {
  auto& i = w.j_right_elbow;
  require_finite(w, w.q + 33, 1, 27);
  require_finite(w, w.v + 32, 1, 27);
  const Real q = Real(w.q[33]), c = std::cos(q), s = std::sin(q);
  i.X.E << s, 0.0, c,  c, 0.0, -s,  0.0, 1.0, 0.0;  // row by row
  i.X.r << 0.0, 0.0, -0.11;
  i.v = i.X * w.j_right_shoulder_yaw.v + joint_velocity<Revolute>(w.v + 32);
}

// A: link "right_upper_arm"; B: the chain of "right_wrist_roll"; C feels the joint at "right_upper_arm"
static void assemble_right_elbow(Workspace& w) {
  auto& i = w.j_right_elbow;
  load_torque(w, 27, 32, i.joined.tau);
  const Mat6 X_Phi_A = i.X * kPhi_right_upper_arm;
  const Mat6 Phi_A = from_right(X_Phi_A, i.X);
  const Columns6 c = velocity_product<Revolute>(i.v, w.v + 32);
  constexpr std::array<Real, 6> least{3.679489269776697e-11, 1.197162751551455e-11, 1.197162751551455e-11, 4.139342360189928e-14, 7.884055819642003e-14, 9.209849845550062e-14};
  if (!keeps_digits<Revolute>(Phi_A, w.j_right_wrist_roll.Phi_right_forearm, least))
    fail(w, kGrowth, 27);
  if (!join(i.joined, Phi_A, w.j_right_wrist_roll.Phi_right_forearm, i.X * w.j_right_shoulder_yaw.b, w.j_right_wrist_roll.b_right_forearm, c))
    fail(w, kFactorization, 27);
  couple(i.joined, X_Phi_A, i.at_right_upper_arm);
  i.Phi_right_upper_arm = kPhi_right_upper_arm - product(i.at_right_upper_arm, i.at_right_upper_arm);  // Eq. (3)
  i.b_right_upper_arm = w.j_right_shoulder_yaw.b - bias_change(i.joined, i.at_right_upper_arm);  // Eq. (6)
}

static void disassemble_right_elbow(Workspace& w) {
  auto& i = w.j_right_elbow;
  Release<Revolute> release(i.joined);
  release.feel_A(i.at_right_upper_arm, w.j_right_elbow.F_on_right_upper_arm);
  const Columns6 f = release.force();  // Eq. (8), (10)
  store_acceleration(w, 27, 32, release.qdd());  // Eq. (9)
  w.j_right_wrist_roll.F_on_right_forearm = f;
}

// ---- joint 28 "right_wrist_roll": revolute, between links "right_forearm" and "right_wrist"

static void kinematics_right_wrist_roll(Workspace& w) {
  auto& i = w.j_right_wrist_roll;
  require_finite(w, w.q + 34, 1, 28);
  require_finite(w, w.v + 33, 1, 28);
  const Real q = Real(w.q[34]), c = std::cos(q), s = std::sin(q);
  i.X.E << 0.0, c, s,  0.0, -s, c,  1.0, 0.0, 0.0;  // row by row
  i.X.r << -0.16, 0.01, 0.0;
  i.v = i.X * w.j_right_elbow.v + joint_velocity<Revolute>(w.v + 33);
}

// A: link "right_forearm"; B: the chain of "right_wrist_pitch"; C feels the joint at "right_forearm"
static void assemble_right_wrist_roll(Workspace& w) {
  auto& i = w.j_right_wrist_roll;
  load_torque(w, 28, 33, i.joined.tau);
  const Mat6 X_Phi_A = i.X * kPhi_right_forearm;
  const Mat6 Phi_A = from_right(X_Phi_A, i.X);
  const Columns6 c = velocity_product<Revolute>(i.v, w.v + 33);
  constexpr std::array<Real, 6> least{1.6766806649289416e-10, 1.6766806649289416e-10, 1.6159511472323679e-10, 1.0775262834713958e-13, 1.0775262834713958e-13, 9.135549459772717e-14};
  if (!keeps_digits<Revolute>(Phi_A, w.j_right_wrist_pitch.Phi_right_wrist, least))
    fail(w, kGrowth, 28);
  if (!join(i.joined, Phi_A, w.j_right_wrist_pitch.Phi_right_wrist, i.X * w.j_right_elbow.b, w.j_right_wrist_pitch.b_right_wrist, c))
    fail(w, kFactorization, 28);
  couple(i.joined, X_Phi_A, i.at_right_forearm);
  i.Phi_right_forearm = kPhi_right_forearm - product(i.at_right_forearm, i.at_right_forearm);  // Eq. (3)
  i.b_right_forearm = w.j_right_elbow.b - bias_change(i.joined, i.at_right_forearm);  // Eq. (6)
}

static void disassemble_right_wrist_roll(Workspace& w) {
  auto& i = w.j_right_wrist_roll;
  Release<Revolute> release(i.joined);
  release.feel_A(i.at_right_forearm, w.j_right_wrist_roll.F_on_right_forearm);
  const Columns6 f = release.force();  // Eq. (8), (10)
  store_acceleration(w, 28, 33, release.qdd());  // Eq. (9)
  w.j_right_wrist_pitch.F_on_right_wrist = f;
}

// ---- joint 29 "right_wrist_pitch": revolute, between links "right_wrist" and "right_hand"

static void kinematics_right_wrist_pitch(Workspace& w) {
  auto& i = w.j_right_wrist_pitch;
  require_finite(w, w.q + 35, 1, 29);
  require_finite(w, w.v + 34, 1, 29);
  const Real q = Real(w.q[35]), c = std::cos(q), s = std::sin(q);
  i.X.E << s, 0.0, c,  c, 0.0, -s,  0.0, 1.0, 0.0;  // row by row
  i.X.r << 0.0, 0.0, -0.04;
  i.v = i.X * w.j_right_wrist_roll.v + joint_velocity<Revolute>(w.v + 34);
}

// A: link "right_wrist"; B: link "right_hand"; C feels the joint at "right_wrist"
static void assemble_right_wrist_pitch(Workspace& w) {
  auto& i = w.j_right_wrist_pitch;
  load_torque(w, 29, 34, i.joined.tau);
  const Mat6 X_Phi_A = i.X * kPhi_right_wrist;
  const Mat6 Phi_A = from_right(X_Phi_A, i.X);
  const Columns6 c = velocity_product<Revolute>(i.v, w.v + 34);
  constexpr std::array<Real, 6> least{1.0186696105313099e-10, 7.446169233235501e-11, 7.919164165207809e-11, 1.0658141036401503e-13, 1.973963936416274e-13, 1.8036857609062434e-13};
  if (!keeps_digits<Revolute>(Phi_A, kPhi_right_hand, least))
    fail(w, kGrowth, 29);
  if (!join(i.joined, Phi_A, kPhi_right_hand, i.X * w.j_right_wrist_roll.b, w.j_right_wrist_pitch.b, c))
    fail(w, kFactorization, 29);
  couple(i.joined, X_Phi_A, i.at_right_wrist);
  i.Phi_right_wrist = kPhi_right_wrist - product(i.at_right_wrist, i.at_right_wrist);  // Eq. (3)
  i.b_right_wrist = w.j_right_wrist_roll.b - bias_change(i.joined, i.at_right_wrist);  // Eq. (6)
}

static void disassemble_right_wrist_pitch(Workspace& w) {
  auto& i = w.j_right_wrist_pitch;
  Release<Revolute> release(i.joined);
  release.feel_A(i.at_right_wrist, w.j_right_wrist_pitch.F_on_right_wrist);
  release.force();  // Eq. (8)
  store_acceleration(w, 29, 34, release.qdd());  // Eq. (9)
}

// ---- processes ----------------------------------------------------------------------------------

// Process 0: 14 of 30 joints: "__base__", "left_hip_pitch", "left_hip_roll", "left_hip_yaw", "left_knee", "left_ankle_pitch", ...
static void run_0([[maybe_unused]] Workspace& w, [[maybe_unused]] Channel& channel) {
  w.ground = ground(w);
  kinematics_base(w);
  kinematics_left_hip_pitch(w);
  kinematics_left_hip_roll(w);
  kinematics_left_hip_yaw(w);
  kinematics_left_knee(w);
  kinematics_left_ankle_pitch(w);
  kinematics_left_ankle_roll(w);
  kinematics_right_hip_pitch(w);
  kinematics_right_hip_roll(w);
  kinematics_right_hip_yaw(w);
  kinematics_right_knee(w);
  kinematics_right_ankle_pitch(w);
  kinematics_right_ankle_roll(w);
  kinematics_waist_yaw(w);
  stamp(1);
  link_bias(kLinks[12], w.j_right_ankle_pitch.v, w.j_right_ankle_pitch.b);
  link_bias(kLinks[13], w.j_right_ankle_roll.v, w.j_right_ankle_roll.b);
  assemble_right_ankle_roll(w);
  link_bias(kLinks[11], w.j_right_knee.v, w.j_right_knee.b);
  assemble_right_ankle_pitch(w);
  link_bias(kLinks[10], w.j_right_hip_yaw.v, w.j_right_hip_yaw.b);
  assemble_right_knee(w);
  link_bias(kLinks[9], w.j_right_hip_roll.v, w.j_right_hip_roll.b);
  assemble_right_hip_yaw(w);
  link_bias(kLinks[8], w.j_right_hip_pitch.v, w.j_right_hip_pitch.b);
  assemble_right_hip_roll(w);
  link_bias(kLinks[1], w.j_base.v, w.j_base.b);
  assemble_right_hip_pitch(w);
  link_bias(kLinks[6], w.j_left_ankle_pitch.v, w.j_left_ankle_pitch.b);
  link_bias(kLinks[7], w.j_left_ankle_roll.v, w.j_left_ankle_roll.b);
  assemble_left_ankle_roll(w);
  link_bias(kLinks[5], w.j_left_knee.v, w.j_left_knee.b);
  assemble_left_ankle_pitch(w);
  link_bias(kLinks[4], w.j_left_hip_yaw.v, w.j_left_hip_yaw.b);
  assemble_left_knee(w);
  link_bias(kLinks[3], w.j_left_hip_roll.v, w.j_left_hip_roll.b);
  assemble_left_hip_yaw(w);
  link_bias(kLinks[2], w.j_left_hip_pitch.v, w.j_left_hip_pitch.b);
  assemble_left_hip_roll(w);
  assemble_left_hip_pitch(w);
  assemble_base(w);
  stamp(2);
  {  // from process 1: assembled: chain of "waist_roll"
    const Number* from = channel.receive(1, w.status);
    from = get_symmetric(from, w.j_waist_roll.Phi_waist_link);
    get(from, w.j_waist_roll.b_waist_link);
  }
  stamp(3);
  assemble_waist_yaw(w);
  stamp(4);
  disassemble_waist_yaw(w);
  stamp(5);
  {  // to process 1: forces on: chain of "waist_roll"
    Number* to = channel.outgoing(2, w.status);
    put(to, w.j_waist_roll.F_on_waist_link);
    channel.send(2, w.status);
  }
  stamp(6);
  disassemble_base(w);
  disassemble_left_hip_pitch(w);
  disassemble_right_hip_pitch(w);
  disassemble_right_hip_roll(w);
  disassemble_right_hip_yaw(w);
  disassemble_right_knee(w);
  disassemble_right_ankle_pitch(w);
  disassemble_right_ankle_roll(w);
  disassemble_left_hip_roll(w);
  disassemble_left_hip_yaw(w);
  disassemble_left_knee(w);
  disassemble_left_ankle_pitch(w);
  disassemble_left_ankle_roll(w);
  stamp(7);
}

// Process 1: 11 of 30 joints: "waist_roll", "waist_pitch", "left_shoulder_pitch", "neck_yaw", "neck_pitch", "right_shoulder_pitch", ...; kinematics of 2 more on the way to the ground
static void run_1([[maybe_unused]] Workspace& w, [[maybe_unused]] Channel& channel) {
  w.ground = ground(w);
  kinematics_base(w);
  kinematics_waist_yaw(w);
  kinematics_waist_roll(w);
  kinematics_waist_pitch(w);
  kinematics_left_shoulder_pitch(w);
  kinematics_neck_yaw(w);
  kinematics_neck_pitch(w);
  kinematics_right_shoulder_pitch(w);
  kinematics_right_shoulder_roll(w);
  kinematics_right_shoulder_yaw(w);
  kinematics_right_elbow(w);
  kinematics_right_wrist_roll(w);
  kinematics_right_wrist_pitch(w);
  stamp(1);
  link_bias(kLinks[29], w.j_right_wrist_roll.v, w.j_right_wrist_roll.b);
  link_bias(kLinks[30], w.j_right_wrist_pitch.v, w.j_right_wrist_pitch.b);
  assemble_right_wrist_pitch(w);
  link_bias(kLinks[28], w.j_right_elbow.v, w.j_right_elbow.b);
  assemble_right_wrist_roll(w);
  link_bias(kLinks[27], w.j_right_shoulder_yaw.v, w.j_right_shoulder_yaw.b);
  assemble_right_elbow(w);
  link_bias(kLinks[26], w.j_right_shoulder_roll.v, w.j_right_shoulder_roll.b);
  assemble_right_shoulder_yaw(w);
  link_bias(kLinks[25], w.j_right_shoulder_pitch.v, w.j_right_shoulder_pitch.b);
  assemble_right_shoulder_roll(w);
  link_bias(kLinks[16], w.j_waist_pitch.v, w.j_waist_pitch.b);
  assemble_right_shoulder_pitch(w);
  link_bias(kLinks[23], w.j_neck_yaw.v, w.j_neck_yaw.b);
  link_bias(kLinks[24], w.j_neck_pitch.v, w.j_neck_pitch.b);
  assemble_neck_pitch(w);
  assemble_neck_yaw(w);
  stamp(2);
  {  // from process 2: assembled: chain of "left_shoulder_roll"
    const Number* from = channel.receive(0, w.status);
    from = get_symmetric(from, w.j_left_shoulder_roll.Phi_left_shoulder);
    get(from, w.j_left_shoulder_roll.b_left_shoulder);
  }
  stamp(3);
  assemble_left_shoulder_pitch(w);
  link_bias(kLinks[15], w.j_waist_roll.v, w.j_waist_roll.b);
  assemble_waist_pitch(w);
  link_bias(kLinks[14], w.j_waist_yaw.v, w.j_waist_yaw.b);
  assemble_waist_roll(w);
  stamp(4);
  {  // to process 0: assembled: chain of "waist_roll"
    Number* to = channel.outgoing(1, w.status);
    to = put_symmetric(to, w.j_waist_roll.Phi_waist_link);
    put(to, w.j_waist_roll.b_waist_link);
    channel.send(1, w.status);
  }
  stamp(5);
  {  // from process 0: forces on: chain of "waist_roll"
    const Number* from = channel.receive(2, w.status);
    get(from, w.j_waist_roll.F_on_waist_link);
  }
  stamp(6);
  disassemble_waist_roll(w);
  disassemble_waist_pitch(w);
  disassemble_left_shoulder_pitch(w);
  stamp(7);
  {  // to process 2: forces on: chain of "left_shoulder_roll"
    Number* to = channel.outgoing(3, w.status);
    put(to, w.j_left_shoulder_roll.F_on_left_shoulder);
    channel.send(3, w.status);
  }
  stamp(8);
  disassemble_neck_yaw(w);
  disassemble_right_shoulder_pitch(w);
  disassemble_right_shoulder_roll(w);
  disassemble_right_shoulder_yaw(w);
  disassemble_right_elbow(w);
  disassemble_right_wrist_roll(w);
  disassemble_right_wrist_pitch(w);
  disassemble_neck_pitch(w);
  stamp(9);
}

// Process 2: 5 of 30 joints: "left_shoulder_roll", "left_shoulder_yaw", "left_elbow", "left_wrist_roll", "left_wrist_pitch"; kinematics of 5 more on the way to the ground
static void run_2([[maybe_unused]] Workspace& w, [[maybe_unused]] Channel& channel) {
  w.ground = ground(w);
  kinematics_base(w);
  kinematics_waist_yaw(w);
  kinematics_waist_roll(w);
  kinematics_waist_pitch(w);
  kinematics_left_shoulder_pitch(w);
  kinematics_left_shoulder_roll(w);
  kinematics_left_shoulder_yaw(w);
  kinematics_left_elbow(w);
  kinematics_left_wrist_roll(w);
  kinematics_left_wrist_pitch(w);
  stamp(1);
  link_bias(kLinks[21], w.j_left_wrist_roll.v, w.j_left_wrist_roll.b);
  link_bias(kLinks[22], w.j_left_wrist_pitch.v, w.j_left_wrist_pitch.b);
  assemble_left_wrist_pitch(w);
  link_bias(kLinks[20], w.j_left_elbow.v, w.j_left_elbow.b);
  assemble_left_wrist_roll(w);
  link_bias(kLinks[19], w.j_left_shoulder_yaw.v, w.j_left_shoulder_yaw.b);
  assemble_left_elbow(w);
  link_bias(kLinks[18], w.j_left_shoulder_roll.v, w.j_left_shoulder_roll.b);
  assemble_left_shoulder_yaw(w);
  link_bias(kLinks[17], w.j_left_shoulder_pitch.v, w.j_left_shoulder_pitch.b);
  assemble_left_shoulder_roll(w);
  stamp(2);
  {  // to process 1: assembled: chain of "left_shoulder_roll"
    Number* to = channel.outgoing(0, w.status);
    to = put_symmetric(to, w.j_left_shoulder_roll.Phi_left_shoulder);
    put(to, w.j_left_shoulder_roll.b_left_shoulder);
    channel.send(0, w.status);
  }
  stamp(3);
  {  // from process 1: forces on: chain of "left_shoulder_roll"
    const Number* from = channel.receive(3, w.status);
    get(from, w.j_left_shoulder_roll.F_on_left_shoulder);
  }
  stamp(4);
  disassemble_left_shoulder_roll(w);
  disassemble_left_shoulder_yaw(w);
  disassemble_left_elbow(w);
  disassemble_left_wrist_roll(w);
  disassemble_left_wrist_pitch(w);
  stamp(5);
}

[[maybe_unused]] constexpr std::array<StageInfo, 7> kStages_0{ {
    {"kinematics", 13, -1}, {"assembly", 0, -1}, {"receive", -1, 1}, {"assembly", 13, -1},
    {"disassembly", 13, -1}, {"send", -1, 2}, {"disassembly", 0, -1}
} };
[[maybe_unused]] constexpr std::array<StageInfo, 9> kStages_1{ {
    {"kinematics", 29, -1}, {"assembly", 22, -1}, {"receive", -1, 0}, {"assembly", 14, -1},
    {"send", -1, 1}, {"receive", -1, 2}, {"disassembly", 14, -1}, {"send", -1, 3},
    {"disassembly", 22, -1}
} };
[[maybe_unused]] constexpr std::array<StageInfo, 5> kStages_2{ {
    {"kinematics", 21, -1}, {"assembly", 17, -1}, {"send", -1, 0}, {"receive", -1, 3},
    {"disassembly", 17, -1}
} };
[[maybe_unused]] constexpr std::array<void (*)(Workspace&, Channel&), kProcesses> kRun{run_0, run_1, run_2};

constexpr std::array<Range, 4> kRanges_0{ {{0, 20}, {0, 19}, {0, 19}, {0, 19}} };
constexpr std::array<Range, 10> kRanges_1{ {{0, 7}, {19, 4}, {28, 8}, {0, 6}, {18, 4}, {27, 8}, {19, 3}, {27, 8}, {19, 3}, {27, 8}} };
constexpr std::array<Range, 6> kRanges_2{ {{0, 7}, {19, 9}, {0, 6}, {18, 9}, {22, 5}, {22, 5}} };
[[maybe_unused]] constexpr std::array<ProcessInfo, kProcesses> kProcess{ {
    {{1, kRanges_0.data()}, {1, kRanges_0.data() + 1}, {1, kRanges_0.data() + 2}, {1, kRanges_0.data() + 3}, {7, kStages_0.data()}},
    {{3, kRanges_1.data()}, {3, kRanges_1.data() + 3}, {2, kRanges_1.data() + 6}, {2, kRanges_1.data() + 8}, {9, kStages_1.data()}},
    {{2, kRanges_2.data()}, {2, kRanges_2.data() + 2}, {1, kRanges_2.data() + 4}, {1, kRanges_2.data() + 5}, {5, kStages_2.data()}}}};

#include "adagen/whole_mpi.hpp"
