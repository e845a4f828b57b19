// Forward dynamics of "humanoid" on 1 process, emitted by adagen 0.1.0 (solver.cpp.j2). Do not edit: generate again. Licence: yours to choose.
// robot     "humanoid", 30 joints, 35 degrees of freedom, description sha256 d573a89307ddd4ee9018ee9a0a94422a3db0c5f61f2798648f53f0e1b57ee437
// command   adagen ../models/humanoid.urdf --floating --procs 1 --shape=unrolled --name=humanoid_lanes
// input     profile default, sha256 fe36af9ff4727e4941af0e7182db7f87cd64c54109bc287302f720e9ad83c3a8
// options   form segment (articulated-body algorithm), shape unrolled (spatial vectors [angular; linear] in link frames whose joint axes are z), scalar double, channel auto, floating base, gravity 0.0, 0.0, -9.81
// links     adagen_program.cpp; or, compiled with -DADAGEN_NO_MAIN, a program of yours that includes humanoid_lanes_p1.h
// program   1 process; 0.367 us predicted (default profile)
//           process 0: left_hip_pitch .. left_ankle_roll | right_hip_pitch .. right_ankle_roll |
//           left_shoulder_pitch .. left_wrist_pitch | right_shoulder_pitch .. right_wrist_pitch in 4
//           lanes, __base__, waist_yaw .. waist_pitch, neck_yaw .. neck_pitch

#include "humanoid_lanes_p1.h"
#define ADAGEN_CALL(word) humanoid_lanes_p1_##word
#define ADAGEN_NAMED(WORD) HUMANOID_LANES_P1_##WORD
#include "adagen/settings.hpp"

namespace { struct humanoid_lanes_p1_settings : PlainSettings {
  static constexpr int kVersion = 100, kJointCount = 30, kNq = 36, kNv = 35;
  [[maybe_unused]] static constexpr const char* kRobot = "humanoid";
  [[maybe_unused]] static constexpr bool kFloating = true;
}; }  // namespace: a program may load several solvers of one name

#include "adagen/constants.hpp"

constexpr std::array<LinkConstants, kLinkCount> kLinks{ {
    {"__world__", 0.0, {0.0, 0.0, 0.0}},
    {"pelvis", 6.2, {0.0, 0.0, 0.02},
     {0.0324467, 0.0, 0.0, 0.0, 0.0175667, 0.0, 0.0, 0.0, 0.0351333}},
    {"left_hip", 1.4, {0.0, 0.0, 0.03},
     {0.00182, 0.0, 0.0, 0.0, 0.00182, 0.0, 0.0, 0.0, 0.00175}},
    {"left_groin", 1.2, {0.0, -0.04, 0.02},
     {0.00139, 0.0, 0.0, 0.0, 0.00139, 0.0, 0.0, 0.0, 0.0015}},
    {"left_thigh", 2.6, {0.0, 0.0, -0.1},
     {0.0169867, 0.0, 0.0, 0.0, 0.0169867, 0.0, 0.0, 0.0, 0.00468}},
    {"left_shank", 1.8, {-0.13, 0.01, 0.0},
     {0.0018225, 0.0, 0.0, 0.0, 0.0126713, 0.0, 0.0, 0.0, 0.0126713}},
    {"left_ankle", 0.2, {0.0, 0.0, 0.0},
     {7.2e-05, 0.0, 0.0, 0.0, 7.2e-05, 0.0, 0.0, 0.0, 7.2e-05}},
    {"left_foot", 0.8, {0.0, -0.03, 0.03},
     {0.00272667, 0.0, 0.0, 0.0, 0.00309333, 0.0, 0.0, 0.0, 0.000486667}},
    {"right_hip", 1.4, {0.0, 0.0, -0.03},
     {0.00182, 0.0, 0.0, 0.0, 0.00182, 0.0, 0.0, 0.0, 0.00175}},
    {"right_groin", 1.2, {0.0, -0.04, 0.02},
     {0.00139, 0.0, 0.0, 0.0, 0.00139, 0.0, 0.0, 0.0, 0.0015}},
    {"right_thigh", 2.6, {0.0, 0.0, -0.1},
     {0.0169867, 0.0, 0.0, 0.0, 0.0169867, 0.0, 0.0, 0.0, 0.00468}},
    {"right_shank", 1.8, {-0.13, 0.01, 0.0},
     {0.0018225, 0.0, 0.0, 0.0, 0.0126713, 0.0, 0.0, 0.0, 0.0126713}},
    {"right_ankle", 0.2, {0.0, 0.0, 0.0},
     {7.2e-05, 0.0, 0.0, 0.0, 7.2e-05, 0.0, 0.0, 0.0, 7.2e-05}},
    {"right_foot", 0.8, {0.0, -0.03, 0.03},
     {0.00272667, 0.0, 0.0, 0.0, 0.00309333, 0.0, 0.0, 0.0, 0.000486667}},
    {"waist_link", 0.8, {0.0, 0.0, 0.02},
     {0.00074, 0.0, 0.0, 0.0, 0.00074, 0.0, 0.0, 0.0, 0.001}},
    {"abdomen", 0.9, {0.0, 0.02, 0.0},
     {0.0010425, 0.0, 0.0, 0.0, 0.001125, 0.0, 0.0, 0.0, 0.0010425}},
    {"torso", 9.5, {0.17, 0.01, 0.0},
     {0.0823333, 0.0, 0.0, 0.0, 0.153583, 0.0, 0.0, 0.0, 0.111783}},
    {"left_shoulder", 0.8, {0.0, 0.0, 0.03},
     {0.000646667, 0.0, 0.0, 0.0, 0.000646667, 0.0, 0.0, 0.0, 0.00064}},
    {"left_shoulder_cap", 0.7, {0.01, -0.03, 0.0},
     {0.0007, 0.0, 0.0, 0.0, 0.0007, 0.0, 0.0, 0.0, 0.0007}},
    {"left_upper_arm", 0.8, {0.0, 0.0, -0.05},
     {0.00162667, 0.0, 0.0, 0.0, 0.00162667, 0.0, 0.0, 0.0, 0.00064}},
    {"left_forearm", 0.7, {-0.07, 0.02, 0.0},
     {0.00042875, 0.0, 0.0, 0.0, 0.00170771, 0.0, 0.0, 0.0, 0.00170771}},
    {"left_wrist", 0.2, {0.0, 0.0, -0.01},
     {8.66667e-05, 0.0, 0.0, 0.0, 8.66667e-05, 0.0, 0.0, 0.0, 9e-05}},
    {"left_hand", 0.4, {-0.06, 0.0, 0.0},
     {0.000296667, 0.0, 0.0, 0.0, 0.000693333, 0.0, 0.0, 0.0, 0.000563333}},
    {"neck", 0.4, {0.0, 0.0, 0.02},
     {0.00021, 0.0, 0.0, 0.0, 0.00021, 0.0, 0.0, 0.0, 0.00018}},
    {"head", 2.4, {0.09, 0.02, 0.0},
     {0.007776, 0.0, 0.0, 0.0, 0.007776, 0.0, 0.0, 0.0, 0.007776}},
    {"right_shoulder", 0.8, {0.0, 0.0, -0.03},
     {0.000646667, 0.0, 0.0, 0.0, 0.000646667, 0.0, 0.0, 0.0, 0.00064}},
    {"right_shoulder_cap", 0.7, {-0.01, -0.03, 0.0},
     {0.0007, 0.0, 0.0, 0.0, 0.0007, 0.0, 0.0, 0.0, 0.0007}},
    {"right_upper_arm", 0.8, {0.0, 0.0, -0.05},
     {0.00162667, 0.0, 0.0, 0.0, 0.00162667, 0.0, 0.0, 0.0, 0.00064}},
    {"right_forearm", 0.7, {-0.07, 0.02, 0.0},
     {0.00042875, 0.0, 0.0, 0.0, 0.00170771, 0.0, 0.0, 0.0, 0.00170771}},
    {"right_wrist", 0.2, {0.0, 0.0, -0.01},
     {8.66667e-05, 0.0, 0.0, 0.0, 8.66667e-05, 0.0, 0.0, 0.0, 9e-05}},
    {"right_hand", 0.4, {-0.06, 0.0, 0.0},
     {0.000296667, 0.0, 0.0, 0.0, 0.000693333, 0.0, 0.0, 0.0, 0.000563333}}}};

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

// ---- functions ----------------------------------------------------------------------------------

#include "adagen/far_angles.hpp"
#include "adagen/no_channel.hpp"
#include "adagen/unrolled_memory.hpp"

namespace {

struct Workspace : StraightMemory<32, 24, 0> {};

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
// Process 0: 1607 products, 1481 sums, 16 quotients, 1782 of them in lanes
// =================================================================================================

ADAGEN_NOINLINE ADAGEN_AS_IT_STANDS void part_0_0(Workspace& w) {
  ADAGEN_INPUTS
  // joint 0 "__base__": placement, velocity and reference acceleration of its link
  const Real x62 = q[3] * q[3] + q[4] * q[4] + q[5] * q[5];
  const Real x63 = q[6] * q[6] + x62;
  require_length(w, x63, 0);
  const Real x66 = 1 / x63 * 2.0;
  const Real x67 = q[3] * x66;
  const Real x68 = q[4] * x66;
  const Real x92 = (q[5] * x67 - q[6] * x68) * 9.81;
  const Real x93 = (q[5] * x68 + q[6] * x67) * 9.81;
  const Real x94 = (1.0 - (q[4] * x68 + q[3] * x67)) * 9.81;
  const Real x118 = v[4] * v[5];
  const Real x119 = v[3] * v[3] + v[4] * v[4];
  const Real x121 = v[3] * v[5];
  // joints 1 "left_hip_pitch", 7 "right_hip_pitch", 16 "left_shoulder_pitch", 24 "right_shoulder_pitch": placement, velocity and reference acceleration of their links
  const Four x296 = Four{v[6], v[12], v[21], v[29]};
  // joint 13 "waist_yaw": placement, velocity and reference acceleration of its link
  const Real x135 = v[5] + v[18];
  const Real x134 = v[4] * cosine[24] - v[3] * sine[24];
  // joint 14 "waist_roll": placement, velocity and reference acceleration of its link
  const Real x181 = x135 * cosine[25] - x134 * sine[25];
  // joint 13 "waist_yaw": placement, velocity and reference acceleration of its link
  const Real x130 = v[3] * cosine[24] + v[4] * sine[24];
  // joint 14 "waist_roll": placement, velocity and reference acceleration of its link
  const Real x182 = x130 + v[19];
  // joint 15 "waist_pitch": placement, velocity and reference acceleration of its link
  const Real x238 = x181 * cosine[26] + x182 * sine[26];
  // joints 1 "left_hip_pitch", 7 "right_hip_pitch", 16 "left_shoulder_pitch", 24 "right_shoulder_pitch": placement, velocity and reference acceleration of their links
  const Four x310 = Four{v[3], v[3], x238, x238};
  // joint 15 "waist_pitch": placement, velocity and reference acceleration of its link
  const Real x242 = x182 * cosine[26] - x181 * sine[26];
  // joints 1 "left_hip_pitch", 7 "right_hip_pitch", 16 "left_shoulder_pitch", 24 "right_shoulder_pitch": placement, velocity and reference acceleration of their links
  const Four x311 = Four{v[4], v[4], x242, x242};
  // joint 14 "waist_roll": placement, velocity and reference acceleration of its link
  const Real x177 = x134 * cosine[25] + x135 * sine[25];
  // joint 15 "waist_pitch": placement, velocity and reference acceleration of its link
  const Real x243 = x177 + v[20];
  // joints 1 "left_hip_pitch", 7 "right_hip_pitch", 16 "left_shoulder_pitch", 24 "right_shoulder_pitch": placement, velocity and reference acceleration of their links
  const Four x312 = Four{v[5], v[5], x243, x243};
  // joint 13 "waist_yaw": placement, velocity and reference acceleration of its link
  const Real x137 = v[18] * x130;
  // joint 14 "waist_roll": placement, velocity and reference acceleration of its link
  const Real x191 = x137 * sine[25] - v[19] * x177;
  // joint 13 "waist_yaw": placement, velocity and reference acceleration of its link
  const Real x136 = v[18] * x134;
  // joint 15 "waist_pitch": placement, velocity and reference acceleration of its link
  const Real x252 = x191 * cosine[26] + x136 * sine[26] + v[20] * x242;
  // joints 1 "left_hip_pitch", 7 "right_hip_pitch", 16 "left_shoulder_pitch", 24 "right_shoulder_pitch": placement, velocity and reference acceleration of their links
  const Four x313 = Four{0.0, 0.0, x252, x252};
  // joint 15 "waist_pitch": placement, velocity and reference acceleration of its link
  const Real x255 = x136 * cosine[26] - x191 * sine[26] - v[20] * x238;
  // joints 1 "left_hip_pitch", 7 "right_hip_pitch", 16 "left_shoulder_pitch", 24 "right_shoulder_pitch": placement, velocity and reference acceleration of their links
  const Four x314 = Four{0.0, 0.0, x255, x255};
  // joint 14 "waist_roll": placement, velocity and reference acceleration of its link
  const Real x188 = v[19] * x181 - x137 * cosine[25];
  // joints 1 "left_hip_pitch", 7 "right_hip_pitch", 16 "left_shoulder_pitch", 24 "right_shoulder_pitch": placement, velocity and reference acceleration of their links
  const Four x315 = Four{0.0, 0.0, x188, x188};
  // joint 13 "waist_yaw": placement, velocity and reference acceleration of its link
  const Real x139 = x121 * 0.09;
  const Real x140 = x118 * 0.09;
  const Real x145 = cosine[24] * x139 + sine[24] * x140;
  const Real x166 = x130 * x135;
  const Real x168 = x166 - x137;
  // joint 14 "waist_roll": placement, velocity and reference acceleration of its link
  const Real x193 = x145 + x168 * 0.05;
  const Real x222 = x181 * x182;
  const Real x224 = x188 + x222;
  // joint 15 "waist_pitch": placement, velocity and reference acceleration of its link
  const Real x263 = x193 + x224 * 0.04;
  // joint 13 "waist_yaw": placement, velocity and reference acceleration of its link
  const Real x149 = cosine[24] * x140 - sine[24] * x139;
  const Real x161 = x134 * x135;
  const Real x162 = x161 - x136;
  // joint 14 "waist_roll": placement, velocity and reference acceleration of its link
  const Real x195 = x149 + x162 * 0.05;
  // joint 13 "waist_yaw": placement, velocity and reference acceleration of its link
  const Real x141 = x119 * 0.09;
  const Real x164 = x130 * x130 + x134 * x134;
  // joint 14 "waist_roll": placement, velocity and reference acceleration of its link
  const Real x198 = x141 + x164 * 0.05;
  const Real x208 = sine[25] * x195 + cosine[25] * x198;
  const Real x220 = x177 * x177 + x182 * x182;
  // joint 15 "waist_pitch": placement, velocity and reference acceleration of its link
  const Real x260 = x208 + x220 * 0.04;
  const Real x267 = sine[26] * x263 - cosine[26] * x260;
  const Real x271 = sine[26] * x260 + cosine[26] * x263;
  // joint 14 "waist_roll": placement, velocity and reference acceleration of its link
  const Real x203 = cosine[25] * x195 - sine[25] * x198;
  const Real x217 = x177 * x181;
  const Real x218 = x217 - x136;
  // joint 15 "waist_pitch": placement, velocity and reference acceleration of its link
  const Real x257 = x203 + x218 * 0.04;
  // joints 1 "left_hip_pitch", 7 "right_hip_pitch", 16 "left_shoulder_pitch", 24 "right_shoulder_pitch": placement, velocity and reference acceleration of their links
  const Four x319 = x310 * x310;
  const Four x320 = x311 * x311;
  const Four x321 = x312 * x312;
  const Four x324 = x310 * x311;
  const Four x329 = x311 * x312;
  const Four x334 = x310 * x312;
  const Four x343 = Four{1.0, 1.0, 0.0, 0.0} * x312 - Four{0.0, 0.0, 1.0, 1.0} * x311;
  const Four x346 = load<Four>(cosine + 0) * x343 + load<Four>(sine + 0) * x310;
  const Four x350 = load<Four>(cosine + 0) * x310 - load<Four>(sine + 0) * x343;
  const Four x351 = Four{1.0, 1.0, 0.0, 0.0} * x311 + Four{0.0, 0.0, 1.0, 1.0} * x312 + x296;
  const Four x354 = Four{1.0, 1.0, 0.0, 0.0} * x314 + Four{0.0, 0.0, 1.0, 1.0} * x315;
  const Four x358 = Four{1.0, 1.0, 0.0, 0.0} * x315 - Four{0.0, 0.0, 1.0, 1.0} * x314;
  const Four x367 = load<Four>(cosine + 0) * x358 + load<Four>(sine + 0) * x313 + x296 * x350;
  const Four x370 = load<Four>(cosine + 0) * x313 - load<Four>(sine + 0) * x358 - x296 * x346;
  const Four x377 = Four{0.09, -0.09, 0.0, 0.0} * (x324 - x315) - Four{0.0, 0.0, 0.29, 0.29} * (x320 + x321);
  const Four x379 = Four{0.0, 0.0, x267, x267} + x377 - (x314 + x334) * Four{0.05, 0.05, -0.15, 0.15};
  const Four x385 = Four{0.0, 0.0, 0.29, 0.29} * (x315 + x324) - Four{0.09, -0.09, 0.0, 0.0} * (x319 + x321);
  const Four x387 = Four{0.0, 0.0, x271, x271} + x385 - (x329 - x313) * Four{0.05, 0.05, -0.15, 0.15};
  const Four x392 = Four{0.0, 0.0, x257, x257} + (x319 + x320) * Four{0.05, 0.05, -0.15, 0.15};
  const Four x393 = Four{0.0, 0.0, 0.29, 0.29} * (x334 - x314) + x392;
  const Four x394 = Four{0.09, -0.09, 0.0, 0.0} * (x313 + x329) + x393;
  const Four x397 = Four{1.0, 1.0, 0.0, 0.0} * x387 + Four{0.0, 0.0, 1.0, 1.0} * x394;
  const Four x401 = Four{1.0, 1.0, 0.0, 0.0} * x394 - Four{0.0, 0.0, 1.0, 1.0} * x387;
  const Four x404 = load<Four>(cosine + 0) * x401 + load<Four>(sine + 0) * x379;
  const Four x408 = load<Four>(cosine + 0) * x379 - load<Four>(sine + 0) * x401;
  const Four x422 = x350 * x351;
  const Four x423 = x422 - x367;
  const Four x425 = x346 * x346 + x350 * x350;
  const Four x427 = x346 * x351;
  const Four x429 = x370 + x427;
  // joints 2 "left_hip_roll", 8 "right_hip_roll", 17 "left_shoulder_roll", 25 "right_shoulder_roll": placement, velocity and reference acceleration of their links
  const Four x434 = Four{v[7], v[13], v[22], v[30]};
  const Four x440 = Four{1.0, 1.0, 0.0, 0.0} * x346 + Four{0.0, 0.0, 1.0, 1.0} * x350;
  const Four x447 = load<Four>(cosine + 4) * x351 + load<Four>(sine + 4) * x440;
  const Four x451 = load<Four>(cosine + 4) * x440 - load<Four>(sine + 4) * x351;
  const Four x452 = Four{1.0, 1.0, 0.0, 0.0} * x350 - Four{0.0, 0.0, 1.0, 1.0} * x346 + x434;
  const Four x455 = Four{1.0, 1.0, 0.0, 0.0} * x367 + Four{0.0, 0.0, 1.0, 1.0} * x370;
  const Four x459 = Four{1.0, 1.0, 0.0, 0.0} * x370 - Four{0.0, 0.0, 1.0, 1.0} * x367;
  const Four x468 = load<Four>(cosine + 4) * x354 + load<Four>(sine + 4) * x455 + x434 * x451;
  const Four x471 = load<Four>(cosine + 4) * x455 - load<Four>(sine + 4) * x354 - x434 * x447;
  const Four x473 = x404 + x429 * Four{0.04, -0.04, 0.05, -0.05};
  const Four x475 = x408 + x423 * Four{0.04, -0.04, 0.05, -0.05};
  const Four x478 = x397 - x425 * Four{0.04, -0.04, 0.05, -0.05};
  const Four x481 = Four{1.0, 1.0, 0.0, 0.0} * x473 + Four{0.0, 0.0, 1.0, 1.0} * x475;
  const Four x485 = Four{1.0, 1.0, 0.0, 0.0} * x475 - Four{0.0, 0.0, 1.0, 1.0} * x473;
  const Four x488 = load<Four>(cosine + 4) * x478 + load<Four>(sine + 4) * x481;
  const Four x492 = load<Four>(cosine + 4) * x481 - load<Four>(sine + 4) * x478;
  const Four x496 = x447 * x447;
  const Four x497 = x451 * x451;
  const Four x498 = x452 * x452;
  const Four x499 = x497 + x498;
  const Four x501 = x447 * x451;
  const Four x502 = x501 - x459;
  const Four x504 = x496 + x498;
  const Four x506 = x451 * x452;
  const Four x508 = x468 + x506;
  const Four x509 = x496 + x497;
  const Four x511 = x447 * x452;
  const Four x512 = x511 - x471;
  const Four x513 = x471 + x511;
  // links 3 "left_groin", 9 "right_groin", 18 "left_shoulder_cap", 26 "right_shoulder_cap": bias force in the reference field
  const Four x1060 = x506 * Four{0.0015500000000000002, 0.0015500000000000002, 0.0006299999999999999, 0.0006299999999999999} + Four{0.00096, 0.00096, 0.0, 0.0} * (x509 - x504);
  const Four x1071 = x511 * Four{0.00036999999999999994, 0.00036999999999999994, -7e-05, -7e-05} - x502 * Four{0.00096, 0.00096, 0.0, 0.0} + x471 * Four{0.00187, 0.00187, 0.00077, 0.00077};
  const Four x1081 = x459 * Four{0.00342, 0.00342, 0.0014, 0.0014} - x501 * Four{0.00192, 0.00192, 0.00056, 0.00056};
  const Four x1062 = x468 * Four{0.00379, 0.00379, 0.0013299999999999998, 0.0013299999999999998} + x1060 - x512 * Four{0.0, 0.0, 0.00020999999999999998, -0.00020999999999999998};
  const Four x1093 = x508 * Four{0.0, 0.0, 0.00020999999999999998, -0.00020999999999999998} + x1071 - x485 * Four{0.0, 0.0, 0.006999999999999999, -0.006999999999999999};
  const Four x1083 = Four{0.0, 0.0, 0.00020999999999999998, -0.00020999999999999998} * (x504 - x499) + x1081 + x513 * Four{0.00096, 0.00096, 0.0, 0.0};
  const Four x1108 = x513 * Four{0.024, 0.024, 0.0, 0.0} - (x499 * Four{0.0, 0.0, 0.006999999999999999, -0.006999999999999999} + x502 * Four{0.048, 0.048, 0.020999999999999998, 0.020999999999999998});
  const Four x1115 = (x459 + x501) * Four{0.0, 0.0, 0.006999999999999999, -0.006999999999999999} + x504 * Four{0.048, 0.048, 0.020999999999999998, 0.020999999999999998};
  const Four x1125 = x485 * Four{1.2, 1.2, 0.7, 0.7} - x509 * Four{0.024, 0.024, 0.0, 0.0} + x512 * Four{0.0, 0.0, 0.006999999999999999, -0.006999999999999999};
  // joints 3 "left_hip_yaw", 9 "right_hip_yaw", 18 "left_shoulder_yaw", 26 "right_shoulder_yaw": placement, velocity and reference acceleration of their links
  const Four x518 = Four{v[8], v[14], v[23], v[31]};
  const Four x525 = load<Four>(cosine + 8) * x452 + load<Four>(sine + 8) * x447;
  const Four x529 = load<Four>(cosine + 8) * x447 - load<Four>(sine + 8) * x452;
  const Four x530 = x451 + x518;
  const Four x539 = load<Four>(cosine + 8) * x459 + load<Four>(sine + 8) * x468 + x518 * x529;
  const Four x542 = load<Four>(cosine + 8) * x468 - load<Four>(sine + 8) * x459 - x518 * x525;
  const Four x546 = x488 - x502 * Four{0.12, 0.12, 0.1, 0.1};
  const Four x549 = x492 + x504 * Four{0.12, 0.12, 0.1, 0.1};
  const Four x552 = x485 - x508 * Four{0.12, 0.12, 0.1, 0.1};
  const Four x555 = load<Four>(cosine + 8) * x552 + load<Four>(sine + 8) * x546;
  const Four x559 = load<Four>(cosine + 8) * x546 - load<Four>(sine + 8) * x552;
  const Four x572 = x529 * x530;
  const Four x573 = x572 - x539;
  const Four x575 = x525 * x525 + x529 * x529;
  const Four x577 = x525 * x530;
  const Four x579 = x542 + x577;
  // joints 4 "left_knee", 10 "right_knee", 19 "left_elbow", 27 "right_elbow": placement, velocity and reference acceleration of their links
  const Four x584 = Four{v[9], v[15], v[24], v[32]};
  const Four x592 = load<Four>(cosine + 12) * Four{1.0, 1.0, 0.0, 0.0} - load<Four>(sine + 12) * Four{0.0, 0.0, 1.0, 1.0};
  const Four x597 = load<Four>(sine + 12) * Four{1.0, 1.0, 0.0, 0.0} + load<Four>(cosine + 12) * Four{0.0, 0.0, 1.0, 1.0};
  const Four x601 = x530 * x592 + x525 * x597;
  const Four x605 = x525 * x592 - x530 * x597;
  const Four x606 = x529 + x584;
  const Four x615 = x471 * x592 + x539 * x597 + x584 * x605;
  const Four x618 = x539 * x592 - x471 * x597 - x584 * x601;
  const Four x622 = x555 - x579 * Four{0.24, 0.24, 0.11, 0.11};
  const Four x625 = x559 - x573 * Four{0.24, 0.24, 0.11, 0.11};
  const Four x628 = x549 + x575 * Four{0.24, 0.24, 0.11, 0.11};
  const Four x631 = x592 * x628 + x597 * x622;
  const Four x635 = x592 * x622 - x597 * x628;
  const Four x640 = x606 * x606;
  const Four x641 = x605 * x605 + x640;
  const Four x643 = x601 * x605;
  const Four x644 = x643 - x542;
  const Four x645 = x542 + x643;
  const Four x646 = x601 * x601 + x640;
  const Four x648 = x605 * x606;
  const Four x650 = x615 + x648;
  const Four x653 = x601 * x606;
  const Four x654 = x653 - x618;
  // links 5 "left_shank", 11 "right_shank", 20 "left_forearm", 28 "right_forearm": bias force in the reference field
  const Four x1217 = x643 * Four{0.0410888, 0.0410888, -0.004428960000000001, -0.004428960000000001} + Four{0.00234, 0.00234, -0.00098, -0.00098} * (x646 - x641);
  const Four x1202 = x615 * Four{0.0020025, 0.0020025, 0.00513771, 0.00513771} + x648 * Four{0.00018, 0.00018, 0.004708960000000001, 0.004708960000000001} - x654 * Four{0.00234, 0.00234, -0.00098, -0.00098};
  const Four x1211 = x618 * Four{0.043091300000000006, 0.043091300000000006, 0.00070875, 0.00070875} - x653 * Four{0.0412688, 0.0412688, 0.00028, 0.00028} + x650 * Four{0.00234, 0.00234, -0.00098, -0.00098};
  const Four x1228 = x542 * Four{0.043271300000000006, 0.043271300000000006, 0.005417710000000001, 0.005417710000000001} + x1217 - x635 * Four{0.234, 0.234, -0.013999999999999999, -0.013999999999999999};
  // joints 5 "left_ankle_pitch", 11 "right_ankle_pitch", 20 "left_wrist_roll", 28 "right_wrist_roll": placement, velocity and reference acceleration of their links
  const Four x660 = Four{v[10], v[16], v[25], v[33]};
  const Four x669 = Four{1.0, 1.0, 0.0, 0.0} * x605 + Four{0.0, 0.0, 1.0, 1.0} * x606;
  const Four x676 = load<Four>(cosine + 16) * x601 + load<Four>(sine + 16) * x669;
  const Four x680 = load<Four>(cosine + 16) * x669 - load<Four>(sine + 16) * x601;
  const Four x681 = Four{1.0, 1.0, 0.0, 0.0} * x606 - Four{0.0, 0.0, 1.0, 1.0} * x605 + x660;
  const Four x684 = Four{1.0, 1.0, 0.0, 0.0} * x618 + Four{0.0, 0.0, 1.0, 1.0} * x542;
  const Four x688 = Four{1.0, 1.0, 0.0, 0.0} * x542 - Four{0.0, 0.0, 1.0, 1.0} * x618;
  const Four x697 = load<Four>(cosine + 16) * x615 + load<Four>(sine + 16) * x684 + x660 * x680;
  const Four x700 = load<Four>(cosine + 16) * x684 - load<Four>(sine + 16) * x615 - x660 * x676;
  const Four x706 = x641 * Four{0.3, 0.3, -0.01, -0.01} + x644 * Four{0.0, 0.0, 0.16, 0.16} + x631;
  const Four x713 = x635 - (x645 * Four{0.3, 0.3, -0.01, -0.01} + x646 * Four{0.0, 0.0, 0.16, 0.16});
  const Four x718 = x625 - x654 * Four{0.3, 0.3, -0.01, -0.01} + x650 * Four{0.0, 0.0, 0.16, 0.16};
  const Four x721 = Four{1.0, 1.0, 0.0, 0.0} * x713 + Four{0.0, 0.0, 1.0, 1.0} * x718;
  const Four x725 = Four{1.0, 1.0, 0.0, 0.0} * x718 - Four{0.0, 0.0, 1.0, 1.0} * x713;
  const Four x728 = load<Four>(cosine + 16) * x706 + load<Four>(sine + 16) * x721;
  const Four x732 = load<Four>(cosine + 16) * x721 - load<Four>(sine + 16) * x706;
  const Four x737 = x680 * x680;
  const Four x746 = x680 * x681;
  const Four x747 = x746 - x697;
  const Four x749 = x676 * x676 + x737;
  const Four x751 = x676 * x681;
  const Four x753 = x700 + x751;
  // joints 6 "left_ankle_roll", 12 "right_ankle_roll", 21 "left_wrist_pitch", 29 "right_wrist_pitch": placement, velocity and reference acceleration of their links
  const Four x758 = Four{v[11], v[17], v[26], v[34]};
  const Four x765 = load<Four>(cosine + 20) * x681 + load<Four>(sine + 20) * x676;
  const Four x769 = load<Four>(cosine + 20) * x676 - load<Four>(sine + 20) * x681;
  const Four x770 = x680 + x758;
  const Four x779 = load<Four>(cosine + 20) * x688 + load<Four>(sine + 20) * x697 + x758 * x769;
  const Four x782 = load<Four>(cosine + 20) * x697 - load<Four>(sine + 20) * x688 - x758 * x765;
  const Four x789 = (x737 + x681 * x681) * Four{0.02, 0.02, 0.0, 0.0} - x753 * Four{0.0, 0.0, 0.04, 0.04};
  const Four x790 = x728 + x789;
  const Four x795 = (x688 + x676 * x680) * Four{0.02, 0.02, 0.0, 0.0} + x747 * Four{0.0, 0.0, 0.04, 0.04};
  const Four x797 = x732 - x795;
  const Four x803 = x725 + x749 * Four{0.0, 0.0, 0.04, 0.04} - (x751 - x700) * Four{0.02, 0.02, 0.0, 0.0};
  const Four x806 = load<Four>(cosine + 20) * x803 + load<Four>(sine + 20) * x790;
  const Four x810 = load<Four>(cosine + 20) * x790 - load<Four>(sine + 20) * x803;
  const Four x813 = x765 * x765;
  const Four x814 = x769 * x769;
  const Four x815 = x770 * x770;
  const Four x818 = x765 * x769;
  const Four x819 = x818 - x700;
  const Four x821 = x813 + x815;
  const Four x823 = x769 * x770;
  const Four x826 = x813 + x814;
  const Four x828 = x765 * x770;
  const Four x830 = x782 + x828;
  // links 7 "left_foot", 13 "right_foot", 22 "left_hand", 30 "right_hand": bias force in the reference field
  const Four x1327 = Four{0.0007199999999999999, 0.0007199999999999999, 0.0, 0.0} * (x826 - x821) - x823 * Four{0.002606663, 0.002606663, 0.00013000000000000002, 0.00013000000000000002};
  const Four x1350 = x779 * Four{0.00416667, 0.00416667, 0.000296667, 0.000296667} + x1327 - x797 * Four{0.024, 0.024, 0.0, 0.0};
  const Four x1351 = x1350 - x810 * Four{0.024, 0.024, 0.0, 0.0};
  const Four x1352 = x806 * Four{0.024, 0.024, 0.0, 0.0};
  const Four x1336 = x828 * Four{0.002960003, 0.002960003, -0.001706666, -0.001706666} - x819 * Four{0.0007199999999999999, 0.0007199999999999999, 0.0, 0.0} + x782 * Four{0.00381333, 0.00381333, 0.002133333, 0.002133333};
  const Four x1345 = x700 * Four{0.001206667, 0.001206667, 0.002003333, 0.002003333} - x818 * Four{0.00035334, 0.00035334, -0.0018366659999999998, -0.0018366659999999998} + x830 * Four{0.0007199999999999999, 0.0007199999999999999, 0.0, 0.0};
  const Four x1368 = (x814 + x815) * Four{0.0, 0.0, 0.024, 0.024} - x819 * Four{0.024, 0.024, 0.0, 0.0};
  const Four x1377 = x821 * Four{0.024, 0.024, 0.0, 0.0} - (x700 + x818) * Four{0.0, 0.0, 0.024, 0.024};
  const Four x1387 = x797 * Four{0.8, 0.8, 0.4, 0.4} - x826 * Four{0.024, 0.024, 0.0, 0.0};
  const Four x1388 = x1387 - (x828 - x782) * Four{0.0, 0.0, 0.024, 0.024};
  const Four x1389 = x1388 - (x779 + x823) * Four{0.024, 0.024, 0.0, 0.0};
  // joint 15 "waist_pitch": placement, velocity and reference acceleration of its link
  const Real x276 = x243 * x243;
  const Real x277 = x242 * x242 + x276;
  const Real x279 = x238 * x242;
  const Real x281 = x188 + x279;
  const Real x282 = x238 * x238 + x276;
  const Real x284 = x242 * x243;
  const Real x286 = x252 + x284;
  const Real x289 = x238 * x243;
  const Real x290 = x289 - x255;
  // link 16 "torso": bias force in the reference field
  const Real x1506 = x188 * 0.38728300000000004 + x279 * 0.34484970000000004;
  const Real x1489 = x252 * 0.0832833 - x284 * 0.040850000000000004 + x290 * 0.01615;
  const Real x1499 = x255 * 0.42813300000000004 - x289 * 0.30399970000000004 - x286 * 0.01615;
  const Real x1516 = x1506 - 0.01615 * (x282 - x277) + x271 * 1.6150000000000002;
  const Real x1522 = (x279 - x188) * 0.095 - x277 * 1.6150000000000002;
  // joint 22 "neck_yaw": placement, velocity and reference acceleration of its link
  const Real x839 = x242 * cosine[27] + x243 * sine[27];
  const Real x843 = x243 * cosine[27] - x242 * sine[27];
  const Real x844 = x238 + v[27];
  const Real x853 = x255 * cosine[27] + x188 * sine[27] + v[27] * x843;
  const Real x856 = x188 * cosine[27] - x255 * sine[27] - v[27] * x839;
  const Real x859 = x267 - x277 * 0.38;
  const Real x861 = x271 + x281 * 0.38;
  const Real x863 = x257 + x290 * 0.38;
  const Real x866 = cosine[27] * x861 + sine[27] * x863;
  const Real x870 = cosine[27] * x863 - sine[27] * x861;
  const Real x883 = x843 * x844;
  const Real x884 = x883 - x853;
  const Real x886 = x839 * x839 + x843 * x843;
  const Real x888 = x839 * x844;
  const Real x890 = x856 + x888;
  // joint 23 "neck_pitch": placement, velocity and reference acceleration of its link
  const Real x899 = x844 * cosine[28] + x839 * sine[28];
  const Real x903 = x839 * cosine[28] - x844 * sine[28];
  const Real x904 = x843 + v[28];
  const Real x913 = x252 * cosine[28] + x853 * sine[28] + v[28] * x903;
  const Real x916 = x853 * cosine[28] - x252 * sine[28] - v[28] * x899;
  const Real x918 = x866 + x890 * 0.06;
  const Real x920 = x870 + x884 * 0.06;
  const Real x923 = x859 - x886 * 0.06;
  const Real x926 = cosine[28] * x923 + sine[28] * x918;
  const Real x930 = cosine[28] * x918 - sine[28] * x923;
  const Real x935 = x904 * x904;
  const Real x936 = x903 * x903 + x935;
  const Real x938 = x899 * x903;
  const Real x941 = x899 * x899 + x935;
  const Real x943 = x903 * x904;
  const Real x945 = x913 + x943;
  const Real x948 = x899 * x904;
  const Real x949 = x948 - x916;
  // link 24 "head": bias force in the reference field
  const Real x1605 = x856 * 0.028175999999999996 + x938 * 0.018479999999999996;
  const Real x1589 = x913 * 0.008736 + x943 * 0.00096 + x949 * 0.00432;
  const Real x1608 = x1589 + x920 * 0.048;
  const Real x1598 = x916 * 0.027215999999999997 - x948 * 0.01944 - x945 * 0.00432;
  const Real x1611 = x1598 - x920 * 0.216;
  const Real x1615 = x1605 - 0.00432 * (x941 - x936) + x930 * 0.216;
  const Real x1621 = (x938 - x856) * 0.048 - x936 * 0.216;
  const Real x1627 = (x856 + x938) * 0.216 - x941 * 0.048;
  const Real x1633 = x920 * 2.4 + x949 * 0.216 + x945 * 0.048;
  // joint 23 "neck_pitch": articulated-body inertia and bias force through it
  const Real x3277 = 35.49119818285065 * (tau[28] - (x1615 - x926 * 0.048));
  const Real x3290 = x926 * 2.4 + x1621 - 0.048 * x3277;
  const Real x3292 = x930 * 2.4 + x1627 + 0.216 * x3277;
  const Real x3296 = cosine[28] * 0.048 + sine[28] * 0.216;
  const Real x3300 = sine[28] * 0.048 - cosine[28] * 0.216;
  const Real x3301 = 2.0 * sine[28];
  const Real x3308 = 0.00432 * x3301 - cosine[28] * 0.018479999999999996;
  const Real x3312 = cosine[28] * x3308;
  const Real x3319 = cosine[28] * 1.574105621805792 - 0.3679727427597956 * x3301;
  const Real x3322 = 0.3679727427597956 + sine[28] * x3319;
  const Real x3323 = cosine[28] * x3319;
  const Real x3325 = 2.318228279386712 - x3323;
  const Real x3326 = 0.06 * x3325;
  const Real x3329 = x3300 + -0.144;
  const Real x3330 = 0.06 * x3322;
  const Real x3340 = -0.00432 + sine[28] * x3308 - 0.06 * x3296;
  const Real x3355 = sine[28] * x3290 + cosine[28] * x3292;
  const Real x3337 = 0.008736 - x3312 - (0.06 * x3300 + 0.06 * x3329);
  const Real x3363 = 0.00037000000000000005 + 0.06 * x3326;
  const Real x3364 = 0.008 + x3326;
  const Real x3365 = 0.027215999999999997 + x3312 + 0.00018;
  require_more(w, x3365, 0.0, kFactorization, 22);
  const Real x3366 = 0.4 + x3325;
  // link 23 "neck": bias force in the reference field
  const Real x1556 = x853 * 0.00037000000000000005 - x883 * 0.00019 - x870 * 0.008;
  // joint 23 "neck_pitch": articulated-body inertia and bias force through it
  const Real x3358 = sine[28] * x1608 + cosine[28] * x1611 - 0.06 * x1633;
  // link 23 "neck": bias force in the reference field
  const Real x1558 = x856 * 0.00037000000000000005 + x888 * 0.00019 + x866 * 0.008;
  // joint 23 "neck_pitch": articulated-body inertia and bias force through it
  const Real x3370 = tau[28] + 0.06 * x3355 + x1558;
  const Real x3372 = x866 * 0.4 + x890 * 0.008 + x3355;
  // link 23 "neck": bias force in the reference field
  const Real x1568 = x859 * 0.4 - x886 * 0.008;
  // joint 22 "neck_yaw": articulated-body inertia and bias force through it
  const Real x3376 = 1 / x3365;
  // joint 23 "neck_pitch": articulated-body inertia and bias force through it
  const Real x3371 = cosine[28] * x1608 - sine[28] * x1611 + x252 * 0.00018;
  // joint 22 "neck_yaw": articulated-body inertia and bias force through it
  const Real x3378 = x3376 * (tau[27] - x3371);
  const Real x3379 = x3340 * x3376;
  const Real x3380 = x3296 * x3376;
  const Real x3383 = 0.00037000000000000005 + x3337 - x3340 * x3379;
  const Real x3386 = -0.008 + x3329 - x3340 * x3380;
  const Real x3389 = 2.8 - x3296 * x3380;
  const Real x3391 = x1556 + x3358 + x3340 * x3378;
  // joint 23 "neck_pitch": articulated-body inertia and bias force through it
  const Real x3373 = x870 * 0.4 + x884 * 0.008 + x1633;
  // joint 22 "neck_yaw": articulated-body inertia and bias force through it
  const Real x3393 = x3373 + x3296 * x3378;
  const Real x3398 = sine[27] * (x3364 + x3386);
  const Real x3400 = sine[27] * x3398;
  const Real x3402 = x3386 - x3400;
  const Real x3403 = x3364 - x3400;
  const Real x3404 = cosine[27] * x3398;
  const Real x3407 = cosine[27] * (x3383 - x3363);
  const Real x3412 = cosine[27] * x3407;
  const Real x3415 = cosine[27] * x3322;
  const Real x3416 = sine[27] * x3322;
  const Real x3418 = cosine[27] * (x3366 - x3389);
  const Real x3419 = sine[27] * x3418;
  const Real x3421 = cosine[27] * x3418;
  const Real x3422 = x3389 + x3421;
  const Real x3423 = x3366 - x3421;
  const Real x3432 = x3404 + 0.38 * x3419;
  const Real x3435 = x3403 + 0.38 * x3422;
  const Real x3438 = x3402 - 0.38 * x3423;
  const Real x3465 = cosine[27] * x3372 - sine[27] * x3393;
  const Real x3468 = sine[27] * x3372 + cosine[27] * x3393;
  // joints 6 "left_ankle_roll", 12 "right_ankle_roll", 21 "left_wrist_pitch", 29 "right_wrist_pitch": articulated-body inertia and bias force through them
  const Four x1708 = load<Four>(cosine + 20) * Four{0.47734793443427226, 0.47734793443427226, -0.28752084650929227, -0.28752084650929227};
  const Four x1712 = load<Four>(cosine + 20) * x1708;
  const Four x1714 = Four{0.8, 0.8, 0.11247915349070774, 0.11247915349070774} - x1712;
  const Four x1689 = load<Four>(sine + 20) * Four{0.014320438033028168, 0.014320438033028168, 0.0, 0.0};
  const Four x1695 = load<Four>(cosine + 20) * x1689;
  const Four x1698 = load<Four>(cosine + 20) * Four{0.000782953140990845, 0.000782953140990845, -0.0018366659999999998, -0.0018366659999999998};
  const Four x1703 = load<Four>(cosine + 20) * x1698;
  const Four x1683 = load<Four>(cosine + 20) * Four{0.024, 0.024, 0.0, 0.0} + load<Four>(sine + 20) * Four{0.0, 0.0, 0.024, 0.024};
  const Four x1726 = Four{-0.016, -0.016, 0.0, 0.0} - x1683;
  const Four x1764 = Four{0.003383716859009155, 0.003383716859009155, 0.002133333, 0.002133333} + x1703 + Four{0.02, 0.02, 0.0, 0.0} * x1683 - Four{0.02, 0.02, 0.0, 0.0} * x1726;
  const Four x1795 = Four{7.2e-05, 7.2e-05, 9e-05, 9e-05} + x1764;
  require_more(w, x1795, 0.0, kFactorization, {5, 11, 20, 28});
  // joints 5 "left_ankle_pitch", 11 "right_ankle_pitch", 20 "left_wrist_roll", 28 "right_wrist_roll": articulated-body inertia and bias force through them
  const Four x1810 = 1 / x1795;
  const Four x1817 = x1695 * x1810;
  const Four x1861 = 0.2 + x1714 - x1695 * x1817;
  // joints 6 "left_ankle_roll", 12 "right_ankle_roll", 21 "left_wrist_pitch", 29 "right_wrist_pitch": articulated-body inertia and bias force through them
  const Four x1710 = load<Four>(sine + 20) * x1708;
  const Four x1691 = load<Four>(sine + 20) * x1689;
  const Four x1693 = Four{-0.024, -0.024, 0.0, 0.0} + x1691;
  // joints 5 "left_ankle_pitch", 11 "right_ankle_pitch", 20 "left_wrist_roll", 28 "right_wrist_roll": articulated-body inertia and bias force through them
  const Four x1852 = x1710 + x1693 * x1817;
  const Four x1857 = x1726 * x1817;
  const Four x1945 = load<Four>(sine + 16) * x1852 + load<Four>(cosine + 16) * x1857;
  // joints 6 "left_ankle_roll", 12 "right_ankle_roll", 21 "left_wrist_pitch", 29 "right_wrist_pitch": articulated-body inertia and bias force through them
  const Four x1715 = Four{0.3226520655657278, 0.3226520655657278, 0.4, 0.4} + x1712;
  // joints 5 "left_ankle_pitch", 11 "right_ankle_pitch", 20 "left_wrist_roll", 28 "right_wrist_roll": articulated-body inertia and bias force through them
  const Four x1815 = x1693 * x1810;
  const Four x1847 = 0.2 + x1715 - x1693 * x1815;
  const Four x1816 = x1726 * x1810;
  const Four x1856 = Four{1.0, 1.0, 0.6000000000000001, 0.6000000000000001} - x1726 * x1816;
  const Four x1848 = x1693 * x1816;
  const Four x1915 = load<Four>(sine + 16) * 2.0;
  const Four x1951 = load<Four>(cosine + 16) * (x1847 - x1856) + x1848 * x1915;
  const Four x1955 = load<Four>(cosine + 16) * x1951;
  const Four x1957 = x1847 - x1955;
  const Four x1970 = Four{2.0, 2.0, 0.0, 0.0} * x1945 - Four{0.0, 0.0, 1.0, 1.0} * (x1957 - x1861);
  const Four x1974 = Four{0.0, 0.0, 1.0, 1.0} * x1970;
  const Four x1977 = x1861 - x1974;
  const Four x1973 = x1945 - Four{1.0, 1.0, 0.0, 0.0} * x1970;
  const Four x1991 = Four{0.3, 0.3, -0.01, -0.01} * x1973;
  // joints 6 "left_ankle_roll", 12 "right_ankle_roll", 21 "left_wrist_pitch", 29 "right_wrist_pitch": articulated-body inertia and bias force through them
  const Four x1688 = load<Four>(cosine + 20) * Four{0.0, 0.0, 0.024, 0.024} - load<Four>(sine + 20) * Four{0.024, 0.024, 0.0, 0.0};
  const Four x1724 = x1688 + Four{0.0, 0.0, 0.016, 0.016};
  const Four x1748 = load<Four>(sine + 20) * x1698 - Four{0.0, 0.0, 0.04, 0.04} * x1683 - Four{0.02, 0.02, 0.0, 0.0} * x1724;
  // joints 5 "left_ankle_pitch", 11 "right_ankle_pitch", 20 "left_wrist_roll", 28 "right_wrist_roll": articulated-body inertia and bias force through them
  const Four x1826 = x1695 + x1748 * x1815;
  // joints 6 "left_ankle_roll", 12 "right_ankle_roll", 21 "left_wrist_pitch", 29 "right_wrist_pitch": articulated-body inertia and bias force through them
  const Four x1758 = Four{0.02, 0.02, 0.0, 0.0} * x1695 - Four{0.0, 0.0, 0.04, 0.04} * x1693;
  // joints 5 "left_ankle_pitch", 11 "right_ankle_pitch", 20 "left_wrist_roll", 28 "right_wrist_roll": articulated-body inertia and bias force through them
  const Four x1840 = x1758 * x1816;
  const Four x1830 = Four{0.0, 0.0, 0.002, 0.002} + x1724 - x1748 * x1816;
  // joints 6 "left_ankle_roll", 12 "right_ankle_roll", 21 "left_wrist_pitch", 29 "right_wrist_pitch": articulated-body inertia and bias force through them
  const Four x1720 = Four{0.0, 0.0, 0.04, 0.04} * x1715 + Four{0.02, 0.02, 0.0, 0.0} * x1710;
  // joints 5 "left_ankle_pitch", 11 "right_ankle_pitch", 20 "left_wrist_roll", 28 "right_wrist_roll": articulated-body inertia and bias force through them
  const Four x1839 = Four{0.0, 0.0, -0.002, -0.002} - x1720 - x1758 * x1815;
  const Four x1884 = load<Four>(cosine + 16) * (x1840 - x1826) - load<Four>(sine + 16) * (x1830 + x1839);
  const Four x1889 = load<Four>(cosine + 16) * x1884;
  const Four x1891 = x1826 + x1889;
  // joints 6 "left_ankle_roll", 12 "right_ankle_roll", 21 "left_wrist_pitch", 29 "right_wrist_pitch": articulated-body inertia and bias force through them
  const Four x1694 = Four{0.009679561966971832, 0.009679561966971832, 0.0, 0.0} + x1691;
  // joints 5 "left_ankle_pitch", 11 "right_ankle_pitch", 20 "left_wrist_roll", 28 "right_wrist_roll": articulated-body inertia and bias force through them
  const Four x1833 = x1694 - x1748 * x1817;
  // joints 6 "left_ankle_roll", 12 "right_ankle_roll", 21 "left_wrist_pitch", 29 "right_wrist_pitch": articulated-body inertia and bias force through them
  const Four x1731 = Four{0.0, 0.0, 0.04, 0.04} * x1710 + Four{0.02, 0.02, 0.0, 0.0} * x1714;
  // joints 5 "left_ankle_pitch", 11 "right_ankle_pitch", 20 "left_wrist_roll", 28 "right_wrist_roll": articulated-body inertia and bias force through them
  const Four x1844 = x1731 - x1758 * x1817;
  const Four x1878 = load<Four>(sine + 16) * x1833 + load<Four>(cosine + 16) * x1844;
  const Four x1905 = Four{0.0, 0.0, 1.0, 1.0} * x1891 - Four{1.0, 1.0, 0.0, 0.0} * x1878;
  const Four x1910 = Four{0.0, 0.0, 1.0, 1.0} * x1905;
  const Four x1954 = load<Four>(sine + 16) * x1951 - x1848;
  const Four x1940 = load<Four>(sine + 16) * x1857 - load<Four>(cosine + 16) * x1852;
  const Four x1964 = Four{0.0, 0.0, 1.0, 1.0} * x1954 + Four{1.0, 1.0, 0.0, 0.0} * x1940;
  const Four x1978 = Four{0.0, 0.0, 0.16, 0.16} * x1964;
  const Four x2010 = x1910 + x1978 + x1991;
  const Four x1976 = x1957 + x1974;
  const Four x1906 = Four{1.0, 1.0, 0.0, 0.0} * x1905;
  const Four x1908 = x1878 + x1906;
  const Four x1961 = Four{1.0, 1.0, 0.0, 0.0} * x1954 - Four{0.0, 0.0, 1.0, 1.0} * x1940;
  const Four x2000 = x1908 + Four{0.0, 0.0, 0.16, 0.16} * x1961 + Four{0.3, 0.3, -0.01, -0.01} * x1976;
  // joints 6 "left_ankle_roll", 12 "right_ankle_roll", 21 "left_wrist_pitch", 29 "right_wrist_pitch": articulated-body inertia and bias force through them
  const Four x1737 = Four{0.00416667, 0.00416667, 0.000296667, 0.000296667} - x1703 + Four{0.0, 0.0, 0.04, 0.04} * x1688 + Four{0.0, 0.0, 0.04, 0.04} * x1724;
  // joints 5 "left_ankle_pitch", 11 "right_ankle_pitch", 20 "left_wrist_roll", 28 "right_wrist_roll": articulated-body inertia and bias force through them
  const Four x1813 = x1748 * x1810;
  const Four x1820 = Four{7.2e-05, 7.2e-05, 0.00010666669999999999, 0.00010666669999999999} + x1737 - x1748 * x1813;
  const Four x1814 = x1758 * x1810;
  // joints 6 "left_ankle_roll", 12 "right_ankle_roll", 21 "left_wrist_pitch", 29 "right_wrist_pitch": articulated-body inertia and bias force through them
  const Four x1793 = Four{0.0, 0.0, 0.04, 0.04} * x1720 + Four{0.02, 0.02, 0.0, 0.0} * x1731 + Four{7.2e-05, 7.2e-05, 0.00010666669999999999, 0.00010666669999999999};
  // joints 5 "left_ankle_pitch", 11 "right_ankle_pitch", 20 "left_wrist_roll", 28 "right_wrist_roll": articulated-body inertia and bias force through them
  const Four x1836 = x1793 - x1758 * x1814;
  const Four x1823 = Four{0.0, 0.0, 0.04, 0.04} * x1695 + Four{0.02, 0.02, 0.0, 0.0} * x1694 - x1748 * x1814;
  const Four x1919 = load<Four>(cosine + 16) * (x1820 - x1836) - x1823 * x1915;
  const Four x1923 = load<Four>(cosine + 16) * x1919;
  const Four x1925 = x1820 - x1923;
  const Four x1928 = Four{0.0, 0.0, 1.0, 1.0} * x1925;
  const Four x1933 = Four{0.0, 0.0, 1.0, 1.0} * x1928;
  const Four x1885 = load<Four>(sine + 16) * x1884;
  const Four x1888 = x1839 + x1885;
  const Four x1894 = Four{0.0, 0.0, 1.0, 1.0} * x1888;
  const Four x1956 = x1856 + x1955;
  const Four x1988 = x1894 - Four{0.0, 0.0, 0.16, 0.16} * x1956 - Four{0.3, 0.3, -0.01, -0.01} * x1961;
  const Four x2055 = x1933 - Four{0.0, 0.0, 0.16, 0.16} * x1894 + Four{0.3, 0.3, -0.01, -0.01} * x1908;
  const Four x2102 = x2055 - Four{0.0, 0.0, 0.16, 0.16} * x1988 + Four{0.3, 0.3, -0.01, -0.01} * x2000 + Four{0.043271300000000006, 0.043271300000000006, 0.005417710000000001, 0.005417710000000001};
  require_more(w, x2102, 0.0, kFactorization, {4, 10, 19, 27});
  // joints 4 "left_knee", 10 "right_knee", 19 "left_elbow", 27 "right_elbow": articulated-body inertia and bias force through them
  const Four x2119 = 1 / x2102;
  const Four x2126 = x2010 * x2119;
  const Four x2172 = Four{1.8, 1.8, 0.7, 0.7} + x1977 - x2010 * x2126;
  // joints 5 "left_ankle_pitch", 11 "right_ankle_pitch", 20 "left_wrist_roll", 28 "right_wrist_roll": articulated-body inertia and bias force through them
  const Four x1887 = x1830 + x1885;
  const Four x1875 = load<Four>(cosine + 16) * x1833 - load<Four>(sine + 16) * x1844;
  const Four x1901 = Four{0.0, 0.0, 1.0, 1.0} * x1887 + Four{1.0, 1.0, 0.0, 0.0} * x1875;
  const Four x2003 = x1901 + Four{0.0, 0.0, 0.16, 0.16} * x1977;
  const Four x1922 = x1823 + load<Four>(sine + 16) * x1919;
  const Four x1979 = x1889 - x1840 + x1978;
  const Four x1990 = Four{1.0, 1.0, 0.0, 0.0} * x1887 - Four{0.0, 0.0, 1.0, 1.0} * x1875 + Four{0.0, 0.0, 0.16, 0.16} * x1973;
  const Four x2029 = Four{0.0, 0.0, 1.0, 1.0} * x1922 - Four{0.0, 0.0, 0.16, 0.16} * x1910 - Four{0.0, 0.0, 0.16, 0.16} * x1979;
  const Four x2030 = x2029 - Four{0.3, 0.3, -0.01, -0.01} * x1990;
  // joints 4 "left_knee", 10 "right_knee", 19 "left_elbow", 27 "right_elbow": articulated-body inertia and bias force through them
  const Four x2142 = Four{0.018000000000000002, 0.018000000000000002, 0.049, 0.049} + x2003 + x2030 * x2126;
  // joints 5 "left_ankle_pitch", 11 "right_ankle_pitch", 20 "left_wrist_roll", 28 "right_wrist_roll": articulated-body inertia and bias force through them
  const Four x2006 = Four{0.3, 0.3, -0.01, -0.01} * x1977 - x1906;
  const Four x1982 = Four{1.0, 1.0, 0.0, 0.0} * x1888 + Four{0.3, 0.3, -0.01, -0.01} * x1964;
  const Four x1993 = x1910 - x1891 + x1991;
  const Four x2044 = Four{1.0, 1.0, 0.0, 0.0} * x1928 - Four{0.3, 0.3, -0.01, -0.01} * x1910 - Four{0.0, 0.0, 0.16, 0.16} * x1982;
  const Four x2045 = x2044 - Four{0.3, 0.3, -0.01, -0.01} * x1993;
  // joints 4 "left_knee", 10 "right_knee", 19 "left_elbow", 27 "right_elbow": articulated-body inertia and bias force through them
  const Four x2154 = Four{0.234, 0.234, -0.013999999999999999, -0.013999999999999999} + x2006 + x2045 * x2126;
  const Four x2187 = x592 * x2142 - x597 * x2154;
  // joints 5 "left_ankle_pitch", 11 "right_ankle_pitch", 20 "left_wrist_roll", 28 "right_wrist_roll": articulated-body inertia and bias force through them
  const Four x2036 = x1925 - x1933 - Four{0.3, 0.3, -0.01, -0.01} * x1906 + Four{0.3, 0.3, -0.01, -0.01} * x2006;
  // joints 4 "left_knee", 10 "right_knee", 19 "left_elbow", 27 "right_elbow": articulated-body inertia and bias force through them
  const Four x2123 = x2045 * x2119;
  const Four x2145 = Four{0.043091300000000006, 0.043091300000000006, 0.00070875, 0.00070875} + x2036 - x2045 * x2123;
  // joints 5 "left_ankle_pitch", 11 "right_ankle_pitch", 20 "left_wrist_roll", 28 "right_wrist_roll": articulated-body inertia and bias force through them
  const Four x2015 = x1836 + x1923 + Four{0.0, 0.0, 0.16, 0.16} * x1901 + Four{0.0, 0.0, 0.16, 0.16} * x2003;
  // joints 4 "left_knee", 10 "right_knee", 19 "left_elbow", 27 "right_elbow": articulated-body inertia and bias force through them
  const Four x2122 = x2030 * x2119;
  const Four x2130 = Four{0.0020025, 0.0020025, 0.00513771, 0.00513771} + x2015 - x2030 * x2122;
  // joints 5 "left_ankle_pitch", 11 "right_ankle_pitch", 20 "left_wrist_roll", 28 "right_wrist_roll": articulated-body inertia and bias force through them
  const Four x2021 = Four{1.0, 1.0, 0.0, 0.0} * x1922 - Four{0.0, 0.0, 0.16, 0.16} * x1906 + Four{0.3, 0.3, -0.01, -0.01} * x2003;
  // joints 4 "left_knee", 10 "right_knee", 19 "left_elbow", 27 "right_elbow": articulated-body inertia and bias force through them
  const Four x2133 = Four{0.00234, 0.00234, -0.00098, -0.00098} + x2021 - x2030 * x2123;
  const Four x2206 = 2.0 * x597;
  const Four x2210 = x592 * (x2130 - x2145) - x2133 * x2206;
  const Four x2214 = x592 * x2210;
  const Four x2287 = x2145 + x2214 + Four{0.00468, 0.00468, 0.00064, 0.00064};
  require_more(w, x2287, 0.0, kFactorization, {3, 9, 18, 26});
  // joints 3 "left_hip_yaw", 9 "right_hip_yaw", 18 "left_shoulder_yaw", 26 "right_shoulder_yaw": articulated-body inertia and bias force through them
  const Four x2302 = 1 / x2287;
  const Four x2309 = x2187 * x2302;
  const Four x2349 = Four{2.6, 2.6, 0.8, 0.8} + x2172 - x2187 * x2309;
  // joints 5 "left_ankle_pitch", 11 "right_ankle_pitch", 20 "left_wrist_roll", 28 "right_wrist_roll": articulated-body inertia and bias force through them
  const Four x2103 = Four{-0.018000000000000002, -0.018000000000000002, -0.049, -0.049} + x1988;
  // joints 4 "left_knee", 10 "right_knee", 19 "left_elbow", 27 "right_elbow": articulated-body inertia and bias force through them
  const Four x2124 = x2103 * x2119;
  const Four x2157 = Four{1.8, 1.8, 0.7, 0.7} + x1956 - x2103 * x2124;
  // joints 5 "left_ankle_pitch", 11 "right_ankle_pitch", 20 "left_wrist_roll", 28 "right_wrist_roll": articulated-body inertia and bias force through them
  const Four x2104 = Four{-0.234, -0.234, 0.013999999999999999, 0.013999999999999999} - x2000;
  // joints 4 "left_knee", 10 "right_knee", 19 "left_elbow", 27 "right_elbow": articulated-body inertia and bias force through them
  const Four x2125 = x2104 * x2119;
  const Four x2166 = Four{1.8, 1.8, 0.7, 0.7} + x1976 - x2104 * x2125;
  const Four x2160 = x1961 - x2103 * x2125;
  const Four x2228 = x592 * (x2157 - x2166) - x2160 * x2206;
  const Four x2232 = x592 * x2228;
  const Four x2234 = x2157 - x2232;
  const Four x2139 = x1990 - x2030 * x2125;
  const Four x2136 = x1979 - x2030 * x2124;
  const Four x2151 = x1993 - x2045 * x2125;
  const Four x2148 = x1982 - x2045 * x2124;
  const Four x2196 = x592 * (x2136 - x2151) - x597 * (x2139 + x2148);
  const Four x2197 = x597 * x2196;
  const Four x2199 = x2139 + x2197;
  // joints 3 "left_hip_yaw", 9 "right_hip_yaw", 18 "left_shoulder_yaw", 26 "right_shoulder_yaw": articulated-body inertia and bias force through them
  const Four x2308 = x2199 * x2302;
  const Four x2340 = Four{2.6, 2.6, 0.8, 0.8} + x2234 - x2199 * x2308;
  // joints 4 "left_knee", 10 "right_knee", 19 "left_elbow", 27 "right_elbow": articulated-body inertia and bias force through them
  const Four x2163 = x1964 + x2103 * x2126;
  const Four x2169 = x1973 + x2104 * x2126;
  const Four x2223 = x597 * x2163 + x592 * x2169;
  // joints 3 "left_hip_yaw", 9 "right_hip_yaw", 18 "left_shoulder_yaw", 26 "right_shoulder_yaw": articulated-body inertia and bias force through them
  const Four x2343 = x2223 - x2199 * x2309;
  const Four x2389 = load<Four>(sine + 8) * 2.0;
  const Four x2411 = load<Four>(cosine + 8) * (x2340 - x2349) - x2343 * x2389;
  const Four x2415 = load<Four>(cosine + 8) * x2411;
  const Four x2416 = x2349 + x2415;
  // joints 4 "left_knee", 10 "right_knee", 19 "left_elbow", 27 "right_elbow": articulated-body inertia and bias force through them
  const Four x2261 = Four{0.24, 0.24, 0.11, 0.11} * x2199;
  const Four x2235 = Four{0.24, 0.24, 0.11, 0.11} * x2223;
  // joints 3 "left_hip_yaw", 9 "right_hip_yaw", 18 "left_shoulder_yaw", 26 "right_shoulder_yaw": articulated-body inertia and bias force through them
  const Four x2334 = x2261 * x2309 - x2235;
  // joints 4 "left_knee", 10 "right_knee", 19 "left_elbow", 27 "right_elbow": articulated-body inertia and bias force through them
  const Four x2201 = x592 * x2196;
  const Four x2237 = x2136 - x2201 + x2235;
  const Four x2258 = x2133 + x597 * x2210 + Four{0.24, 0.24, 0.11, 0.11} * x2187;
  // joints 3 "left_hip_yaw", 9 "right_hip_yaw", 18 "left_shoulder_yaw", 26 "right_shoulder_yaw": articulated-body inertia and bias force through them
  const Four x2319 = x2237 - x2258 * x2308;
  // joints 4 "left_knee", 10 "right_knee", 19 "left_elbow", 27 "right_elbow": articulated-body inertia and bias force through them
  const Four x2190 = x597 * x2142 + x592 * x2154;
  const Four x2242 = x2190 + Four{0.24, 0.24, 0.11, 0.11} * x2172;
  // joints 3 "left_hip_yaw", 9 "right_hip_yaw", 18 "left_shoulder_yaw", 26 "right_shoulder_yaw": articulated-body inertia and bias force through them
  const Four x2322 = Four{0.26, 0.26, 0.04000000000000001, 0.04000000000000001} + x2242 - x2258 * x2309;
  // joints 4 "left_knee", 10 "right_knee", 19 "left_elbow", 27 "right_elbow": articulated-body inertia and bias force through them
  const Four x2238 = Four{0.24, 0.24, 0.11, 0.11} * x2234;
  // joints 3 "left_hip_yaw", 9 "right_hip_yaw", 18 "left_shoulder_yaw", 26 "right_shoulder_yaw": articulated-body inertia and bias force through them
  const Four x2331 = Four{-0.26, -0.26, -0.04000000000000001, -0.04000000000000001} - x2238 + x2261 * x2308;
  const Four x2379 = load<Four>(cosine + 8) * (x2319 - x2334) - load<Four>(sine + 8) * (x2322 + x2331);
  const Four x2384 = load<Four>(cosine + 8) * x2379;
  const Four x2385 = x2334 + x2384;
  const Four x2414 = x2343 + load<Four>(sine + 8) * x2411;
  const Four x2418 = Four{0.12, 0.12, 0.1, 0.1} * x2414;
  const Four x2433 = x2385 + x2418;
  const Four x2380 = load<Four>(sine + 8) * x2379;
  const Four x2382 = x2322 + x2380;
  const Four x2417 = x2340 - x2415;
  const Four x2423 = x2382 + Four{0.12, 0.12, 0.1, 0.1} * x2417;
  const Four x2306 = x2261 * x2302;
  const Four x2328 = Four{0.0429867, 0.0429867, 0.0036266700000000002, 0.0036266700000000002} + Four{0.24, 0.24, 0.11, 0.11} * x2238 - x2261 * x2306;
  // joints 4 "left_knee", 10 "right_knee", 19 "left_elbow", 27 "right_elbow": articulated-body inertia and bias force through them
  const Four x2253 = x2130 - x2214 + (Four{0.24, 0.24, 0.11, 0.11} * x2190 + Four{0.24, 0.24, 0.11, 0.11} * x2242);
  // joints 3 "left_hip_yaw", 9 "right_hip_yaw", 18 "left_shoulder_yaw", 26 "right_shoulder_yaw": articulated-body inertia and bias force through them
  const Four x2305 = x2258 * x2302;
  const Four x2313 = Four{0.0429867, 0.0429867, 0.0036266700000000002, 0.0036266700000000002} + x2253 - x2258 * x2305;
  const Four x2316 = x2258 * x2306 - Four{0.24, 0.24, 0.11, 0.11} * x2237;
  const Four x2393 = load<Four>(cosine + 8) * (x2313 - x2328) - x2316 * x2389;
  const Four x2397 = load<Four>(cosine + 8) * x2393;
  const Four x2451 = x2328 + x2397 + Four{0.12, 0.12, 0.1, 0.1} * x2382 + Four{0.12, 0.12, 0.1, 0.1} * x2423;
  const Four x2475 = Four{0.00342, 0.00342, 0.0014, 0.0014} + x2451;
  require_more(w, x2475, 0.0, kFactorization, {2, 8, 17, 25});
  // joints 2 "left_hip_roll", 8 "right_hip_roll", 17 "left_shoulder_roll", 25 "right_shoulder_roll": articulated-body inertia and bias force through them
  const Four x2492 = 1 / x2475;
  const Four x2499 = x2433 * x2492;
  const Four x2543 = Four{1.2, 1.2, 0.7, 0.7} + x2416 - x2433 * x2499;
  // joints 3 "left_hip_yaw", 9 "right_hip_yaw", 18 "left_shoulder_yaw", 26 "right_shoulder_yaw": articulated-body inertia and bias force through them
  const Four x2476 = Four{0.048, 0.048, 0.020999999999999998, 0.020999999999999998} + x2423;
  // joints 2 "left_hip_roll", 8 "right_hip_roll", 17 "left_shoulder_roll", 25 "right_shoulder_roll": articulated-body inertia and bias force through them
  const Four x2497 = x2476 * x2492;
  const Four x2528 = Four{1.2, 1.2, 0.7, 0.7} + x2417 - x2476 * x2497;
  // joints 4 "left_knee", 10 "right_knee", 19 "left_elbow", 27 "right_elbow": articulated-body inertia and bias force through them
  const Four x2202 = x2151 + x2201;
  // joints 3 "left_hip_yaw", 9 "right_hip_yaw", 18 "left_shoulder_yaw", 26 "right_shoulder_yaw": articulated-body inertia and bias force through them
  const Four x2310 = x2202 * x2302;
  // joints 4 "left_knee", 10 "right_knee", 19 "left_elbow", 27 "right_elbow": articulated-body inertia and bias force through them
  const Four x2220 = x592 * x2163 - x597 * x2169;
  // joints 3 "left_hip_yaw", 9 "right_hip_yaw", 18 "left_shoulder_yaw", 26 "right_shoulder_yaw": articulated-body inertia and bias force through them
  const Four x2325 = x2148 + x2197 + Four{0.24, 0.24, 0.11, 0.11} * x2220 - x2258 * x2310;
  // joints 4 "left_knee", 10 "right_knee", 19 "left_elbow", 27 "right_elbow": articulated-body inertia and bias force through them
  const Four x2231 = x2160 + x597 * x2228;
  // joints 3 "left_hip_yaw", 9 "right_hip_yaw", 18 "left_shoulder_yaw", 26 "right_shoulder_yaw": articulated-body inertia and bias force through them
  const Four x2337 = x2261 * x2310 - Four{0.24, 0.24, 0.11, 0.11} * x2231;
  const Four x2346 = x2231 - x2199 * x2310;
  const Four x2352 = x2220 - x2187 * x2310;
  const Four x2406 = load<Four>(sine + 8) * x2346 + load<Four>(cosine + 8) * x2352;
  const Four x2429 = load<Four>(cosine + 8) * x2325 - load<Four>(sine + 8) * x2337 + Four{0.12, 0.12, 0.1, 0.1} * x2406;
  const Four x2477 = Four{0.0, 0.0, 0.006999999999999999, -0.006999999999999999} + x2429;
  // joints 2 "left_hip_roll", 8 "right_hip_roll", 17 "left_shoulder_roll", 25 "right_shoulder_roll": articulated-body inertia and bias force through them
  const Four x2498 = x2477 * x2492;
  // joints 3 "left_hip_yaw", 9 "right_hip_yaw", 18 "left_shoulder_yaw", 26 "right_shoulder_yaw": articulated-body inertia and bias force through them
  const Four x2479 = x2166 + x2232 + Four{2.6, 2.6, 0.8, 0.8} - x2202 * x2310 + Four{1.2, 1.2, 0.7, 0.7};
  // joints 2 "left_hip_roll", 8 "right_hip_roll", 17 "left_shoulder_roll", 25 "right_shoulder_roll": articulated-body inertia and bias force through them
  const Four x2537 = x2479 - x2477 * x2498;
  const Four x2531 = x2406 - x2476 * x2498;
  const Four x2596 = load<Four>(sine + 4) * 2.0;
  const Four x2627 = load<Four>(cosine + 4) * (x2528 - x2537) - x2531 * x2596;
  const Four x2631 = load<Four>(cosine + 4) * x2627;
  const Four x2633 = x2528 - x2631;
  const Four x2534 = x2414 - x2476 * x2499;
  // joints 3 "left_hip_yaw", 9 "right_hip_yaw", 18 "left_shoulder_yaw", 26 "right_shoulder_yaw": articulated-body inertia and bias force through them
  const Four x2403 = load<Four>(cosine + 8) * x2346 - load<Four>(sine + 8) * x2352;
  // joints 2 "left_hip_roll", 8 "right_hip_roll", 17 "left_shoulder_roll", 25 "right_shoulder_roll": articulated-body inertia and bias force through them
  const Four x2540 = x2403 - x2477 * x2499;
  const Four x2622 = load<Four>(sine + 4) * x2534 + load<Four>(cosine + 4) * x2540;
  const Four x2645 = Four{0.0, 0.0, 1.0, 1.0} * (x2633 - x2543) + Four{2.0, 2.0, 0.0, 0.0} * x2622;
  const Four x2650 = Four{0.0, 0.0, 1.0, 1.0} * x2645;
  const Four x2653 = x2543 + x2650;
  // joints 3 "left_hip_yaw", 9 "right_hip_yaw", 18 "left_shoulder_yaw", 26 "right_shoulder_yaw": articulated-body inertia and bias force through them
  const Four x2426 = load<Four>(sine + 8) * x2325 + load<Four>(cosine + 8) * x2337 - Four{0.12, 0.12, 0.1, 0.1} * x2403;
  const Four x2420 = x2319 - x2384 - x2418;
  const Four x2444 = x2316 + load<Four>(sine + 8) * x2393 - Four{0.12, 0.12, 0.1, 0.1} * x2385;
  const Four x2445 = Four{0.12, 0.12, 0.1, 0.1} * x2420 + x2444;
  // joints 2 "left_hip_roll", 8 "right_hip_roll", 17 "left_shoulder_roll", 25 "right_shoulder_roll": articulated-body inertia and bias force through them
  const Four x2511 = Four{-0.024, -0.024, 0.0, 0.0} + x2426 - x2445 * x2498;
  const Four x2508 = x2420 - x2445 * x2497;
  const Four x2521 = Four{0.00096, 0.00096, 0.0, 0.0} * x2498;
  const Four x2520 = Four{0.024, 0.024, 0.0, 0.0} - Four{0.00096, 0.00096, 0.0, 0.0} * x2497;
  const Four x2566 = load<Four>(cosine + 4) * (x2508 + x2521) - load<Four>(sine + 4) * (x2511 + x2520);
  const Four x2567 = load<Four>(sine + 4) * x2566;
  const Four x2569 = x2511 + x2567;
  // joints 3 "left_hip_yaw", 9 "right_hip_yaw", 18 "left_shoulder_yaw", 26 "right_shoulder_yaw": articulated-body inertia and bias force through them
  const Four x2383 = x2331 + x2380;
  const Four x2432 = x2383 - Four{0.12, 0.12, 0.1, 0.1} * x2416;
  // joints 2 "left_hip_roll", 8 "right_hip_roll", 17 "left_shoulder_roll", 25 "right_shoulder_roll": articulated-body inertia and bias force through them
  const Four x2514 = Four{-0.048, -0.048, -0.020999999999999998, -0.020999999999999998} + x2432 - x2445 * x2499;
  const Four x2525 = Four{0.0, 0.0, -0.006999999999999999, 0.006999999999999999} - Four{0.00096, 0.00096, 0.0, 0.0} * x2499;
  const Four x2557 = load<Four>(cosine + 4) * x2514 - load<Four>(sine + 4) * x2525;
  const Four x2582 = Four{0.0, 0.0, 1.0, 1.0} * x2569 + Four{1.0, 1.0, 0.0, 0.0} * x2557;
  const Four x2496 = Four{0.00096, 0.00096, 0.0, 0.0} * x2492;
  const Four x2517 = Four{0.00187, 0.00187, 0.00077, 0.00077} - Four{0.00096, 0.00096, 0.0, 0.0} * x2496;
  // joints 3 "left_hip_yaw", 9 "right_hip_yaw", 18 "left_shoulder_yaw", 26 "right_shoulder_yaw": articulated-body inertia and bias force through them
  const Four x2439 = x2313 - x2397 - Four{0.12, 0.12, 0.1, 0.1} * x2383 - Four{0.12, 0.12, 0.1, 0.1} * x2432;
  // joints 2 "left_hip_roll", 8 "right_hip_roll", 17 "left_shoulder_roll", 25 "right_shoulder_roll": articulated-body inertia and bias force through them
  const Four x2495 = x2445 * x2492;
  const Four x2502 = Four{0.00379, 0.00379, 0.0013299999999999998, 0.0013299999999999998} + x2439 - x2445 * x2495;
  const Four x2505 = Four{0.0, 0.0, 0.00020999999999999998, -0.00020999999999999998} - x2445 * x2496;
  const Four x2600 = load<Four>(cosine + 4) * (x2502 - x2517) - x2505 * x2596;
  const Four x2604 = load<Four>(cosine + 4) * x2600;
  const Four x2725 = x2517 + x2604 + Four{0.00175, 0.00175, 0.00064, 0.00064};
  require_more(w, x2725, 0.0, kFactorization, {1, 7, 16, 24});
  // joints 1 "left_hip_pitch", 7 "right_hip_pitch", 16 "left_shoulder_pitch", 24 "right_shoulder_pitch": articulated-body inertia and bias force through them
  const Four x2740 = 1 / x2725;
  const Four x2746 = x2582 * x2740;
  const Four x2786 = Four{1.4, 1.4, 0.8, 0.8} + x2653 - x2582 * x2746;
  // joints 2 "left_hip_roll", 8 "right_hip_roll", 17 "left_shoulder_roll", 25 "right_shoulder_roll": articulated-body inertia and bias force through them
  const Four x2652 = x2633 - x2650;
  const Four x2579 = Four{1.0, 1.0, 0.0, 0.0} * x2569 - Four{0.0, 0.0, 1.0, 1.0} * x2557;
  // joints 1 "left_hip_pitch", 7 "right_hip_pitch", 16 "left_shoulder_pitch", 24 "right_shoulder_pitch": articulated-body inertia and bias force through them
  const Four x2745 = x2579 * x2740;
  const Four x2777 = Four{1.4, 1.4, 0.8, 0.8} + x2652 - x2579 * x2745;
  // joints 2 "left_hip_roll", 8 "right_hip_roll", 17 "left_shoulder_roll", 25 "right_shoulder_roll": articulated-body inertia and bias force through them
  const Four x2649 = Four{1.0, 1.0, 0.0, 0.0} * x2645 - x2622;
  // joints 1 "left_hip_pitch", 7 "right_hip_pitch", 16 "left_shoulder_pitch", 24 "right_shoulder_pitch": articulated-body inertia and bias force through them
  const Four x2780 = x2649 - x2579 * x2746;
  const Four x2847 = load<Four>(sine + 0) * 2.0;
  const Four x2880 = load<Four>(cosine + 0) * (x2777 - x2786) - x2780 * x2847;
  const Four x2884 = load<Four>(cosine + 0) * x2880;
  const Four x2885 = x2786 + x2884;
  // joints 2 "left_hip_roll", 8 "right_hip_roll", 17 "left_shoulder_roll", 25 "right_shoulder_roll": articulated-body inertia and bias force through them
  const Four x2571 = load<Four>(cosine + 4) * x2566;
  const Four x2572 = x2571 - x2521;
  // joints 1 "left_hip_pitch", 7 "right_hip_pitch", 16 "left_shoulder_pitch", 24 "right_shoulder_pitch": articulated-body inertia and bias force through them
  const Four x2747 = x2572 * x2740;
  const Four x2792 = x2537 + x2631 + Four{1.4, 1.4, 0.8, 0.8} - x2572 * x2747;
  // joints 2 "left_hip_roll", 8 "right_hip_roll", 17 "left_shoulder_roll", 25 "right_shoulder_roll": articulated-body inertia and bias force through them
  const Four x2630 = x2531 + load<Four>(sine + 4) * x2627;
  const Four x2619 = load<Four>(cosine + 4) * x2534 - load<Four>(sine + 4) * x2540;
  const Four x2637 = Four{1.0, 1.0, 0.0, 0.0} * x2630 - Four{0.0, 0.0, 1.0, 1.0} * x2619;
  // joints 1 "left_hip_pitch", 7 "right_hip_pitch", 16 "left_shoulder_pitch", 24 "right_shoulder_pitch": articulated-body inertia and bias force through them
  const Four x2783 = x2637 - x2579 * x2747;
  // joints 2 "left_hip_roll", 8 "right_hip_roll", 17 "left_shoulder_roll", 25 "right_shoulder_roll": articulated-body inertia and bias force through them
  const Four x2640 = Four{0.0, 0.0, 1.0, 1.0} * x2630 + Four{1.0, 1.0, 0.0, 0.0} * x2619;
  // joints 1 "left_hip_pitch", 7 "right_hip_pitch", 16 "left_shoulder_pitch", 24 "right_shoulder_pitch": articulated-body inertia and bias force through them
  const Four x2789 = x2640 - x2582 * x2747;
  const Four x2872 = load<Four>(cosine + 0) * x2783 - load<Four>(sine + 0) * x2789;
  const Four x2898 = Four{0.0, 0.0, 1.0, 1.0} * (x2792 - x2885) + Four{2.0, 2.0, 0.0, 0.0} * x2872;
  const Four x2903 = Four{0.0, 0.0, 1.0, 1.0} * x2898;
  const Four x2906 = x2885 + x2903;
  // joints 2 "left_hip_roll", 8 "right_hip_roll", 17 "left_shoulder_roll", 25 "right_shoulder_roll": articulated-body inertia and bias force through them
  const Four x2570 = x2520 + x2567;
  const Four x2603 = x2505 + load<Four>(sine + 4) * x2600;
  const Four x2681 = Four{1.0, 1.0, 0.0, 0.0} * x2603 - Four{0.04, -0.04, 0.05, -0.05} * x2582;
  // joints 1 "left_hip_pitch", 7 "right_hip_pitch", 16 "left_shoulder_pitch", 24 "right_shoulder_pitch": articulated-body inertia and bias force through them
  const Four x2762 = Four{1.0, 1.0, 0.0, 0.0} * x2570 - Four{0.04, -0.04, 0.05, -0.05} * x2640 - x2681 * x2747;
  // joints 2 "left_hip_roll", 8 "right_hip_roll", 17 "left_shoulder_roll", 25 "right_shoulder_roll": articulated-body inertia and bias force through them
  const Four x2687 = Four{0.0, 0.0, 1.0, 1.0} * x2603 + Four{0.04, -0.04, 0.05, -0.05} * x2579;
  // joints 1 "left_hip_pitch", 7 "right_hip_pitch", 16 "left_shoulder_pitch", 24 "right_shoulder_pitch": articulated-body inertia and bias force through them
  const Four x2774 = Four{0.0, 0.0, 1.0, 1.0} * x2570 + Four{0.04, -0.04, 0.05, -0.05} * x2637 - x2687 * x2747;
  const Four x2806 = load<Four>(cosine + 0) * x2762 - load<Four>(sine + 0) * x2774;
  // joints 2 "left_hip_roll", 8 "right_hip_roll", 17 "left_shoulder_roll", 25 "right_shoulder_roll": articulated-body inertia and bias force through them
  const Four x2573 = x2508 - x2571;
  const Four x2560 = load<Four>(sine + 4) * x2514 + load<Four>(cosine + 4) * x2525;
  const Four x2586 = Four{0.0, 0.0, 1.0, 1.0} * x2573 + Four{1.0, 1.0, 0.0, 0.0} * x2560;
  const Four x2591 = Four{0.0, 0.0, 1.0, 1.0} * x2586;
  const Four x2654 = Four{0.04, -0.04, 0.05, -0.05} * x2649;
  // joints 1 "left_hip_pitch", 7 "right_hip_pitch", 16 "left_shoulder_pitch", 24 "right_shoulder_pitch": articulated-body inertia and bias force through them
  const Four x2771 = x2591 + x2654 - x2687 * x2746;
  // joints 2 "left_hip_roll", 8 "right_hip_roll", 17 "left_shoulder_roll", 25 "right_shoulder_roll": articulated-body inertia and bias force through them
  const Four x2656 = x2573 - x2591 - x2654;
  // joints 1 "left_hip_pitch", 7 "right_hip_pitch", 16 "left_shoulder_pitch", 24 "right_shoulder_pitch": articulated-body inertia and bias force through them
  const Four x2756 = x2656 - x2681 * x2745;
  // joints 2 "left_hip_roll", 8 "right_hip_roll", 17 "left_shoulder_roll", 25 "right_shoulder_roll": articulated-body inertia and bias force through them
  const Four x2588 = Four{1.0, 1.0, 0.0, 0.0} * x2586;
  const Four x2661 = x2588 - Four{0.04, -0.04, 0.05, -0.05} * x2653;
  // joints 1 "left_hip_pitch", 7 "right_hip_pitch", 16 "left_shoulder_pitch", 24 "right_shoulder_pitch": articulated-body inertia and bias force through them
  const Four x2759 = Four{-0.041999999999999996, 0.041999999999999996, -0.024, 0.024} + x2661 - x2681 * x2746;
  // joints 2 "left_hip_roll", 8 "right_hip_roll", 17 "left_shoulder_roll", 25 "right_shoulder_roll": articulated-body inertia and bias force through them
  const Four x2590 = x2588 - x2560;
  const Four x2658 = x2590 + Four{0.04, -0.04, 0.05, -0.05} * x2652;
  // joints 1 "left_hip_pitch", 7 "right_hip_pitch", 16 "left_shoulder_pitch", 24 "right_shoulder_pitch": articulated-body inertia and bias force through them
  const Four x2768 = Four{0.041999999999999996, -0.041999999999999996, 0.024, -0.024} + x2658 - x2687 * x2745;
  const Four x2815 = load<Four>(cosine + 0) * (x2756 - x2771) - load<Four>(sine + 0) * (x2759 + x2768);
  const Four x2820 = load<Four>(cosine + 0) * x2815;
  const Four x2821 = x2771 + x2820;
  const Four x2837 = Four{0.0, 0.0, 1.0, 1.0} * x2821 - Four{1.0, 1.0, 0.0, 0.0} * x2806;
  const Four x2838 = Four{1.0, 1.0, 0.0, 0.0} * x2837;
  const Four x2840 = x2806 + x2838;
  const Four x2875 = load<Four>(sine + 0) * x2783 + load<Four>(cosine + 0) * x2789;
  const Four x2883 = x2780 + load<Four>(sine + 0) * x2880;
  const Four x2893 = Four{0.0, 0.0, 1.0, 1.0} * x2875 + Four{1.0, 1.0, 0.0, 0.0} * x2883;
  const Four x2951 = x2840 + Four{0.05, 0.05, -0.15, 0.15} * x2893 + Four{0.0, 0.0, 0.29, 0.29} * x2906;
  const Four x2816 = load<Four>(sine + 0) * x2815;
  const Four x2818 = x2759 + x2816;
  const Four x2823 = Four{0.0, 0.0, 1.0, 1.0} * x2818;
  const Four x2886 = x2777 - x2884;
  const Four x2918 = x2823 + Four{0.05, 0.05, -0.15, 0.15} * x2886 + Four{0.0, 0.0, 0.29, 0.29} * x2893;
  // joints 2 "left_hip_roll", 8 "right_hip_roll", 17 "left_shoulder_roll", 25 "right_shoulder_roll": articulated-body inertia and bias force through them
  const Four x2606 = x2502 - x2604;
  const Four x2609 = Four{0.0, 0.0, 1.0, 1.0} * x2606;
  const Four x2613 = Four{0.0, 0.0, 1.0, 1.0} * x2609;
  // joints 1 "left_hip_pitch", 7 "right_hip_pitch", 16 "left_shoulder_pitch", 24 "right_shoulder_pitch": articulated-body inertia and bias force through them
  const Four x2744 = x2687 * x2740;
  // joints 2 "left_hip_roll", 8 "right_hip_roll", 17 "left_shoulder_roll", 25 "right_shoulder_roll": articulated-body inertia and bias force through them
  const Four x2723 = x2613 + Four{0.04, -0.04, 0.05, -0.05} * x2590 + Four{0.04, -0.04, 0.05, -0.05} * x2658 + Four{0.00308, 0.00308, 0.001366667, 0.001366667};
  // joints 1 "left_hip_pitch", 7 "right_hip_pitch", 16 "left_shoulder_pitch", 24 "right_shoulder_pitch": articulated-body inertia and bias force through them
  const Four x2765 = x2723 - x2687 * x2744;
  // joints 2 "left_hip_roll", 8 "right_hip_roll", 17 "left_shoulder_roll", 25 "right_shoulder_roll": articulated-body inertia and bias force through them
  const Four x2673 = x2606 - x2613 - Four{0.04, -0.04, 0.05, -0.05} * x2588 - Four{0.04, -0.04, 0.05, -0.05} * x2661;
  // joints 1 "left_hip_pitch", 7 "right_hip_pitch", 16 "left_shoulder_pitch", 24 "right_shoulder_pitch": articulated-body inertia and bias force through them
  const Four x2743 = x2681 * x2740;
  const Four x2750 = Four{0.00308, 0.00308, 0.001366667, 0.001366667} + x2673 - x2681 * x2743;
  // joints 2 "left_hip_roll", 8 "right_hip_roll", 17 "left_shoulder_roll", 25 "right_shoulder_roll": articulated-body inertia and bias force through them
  const Four x2678 = Four{1.0, 1.0, 0.0, 0.0} * x2609 - Four{0.04, -0.04, 0.05, -0.05} * x2591 + Four{0.04, -0.04, 0.05, -0.05} * x2656;
  // joints 1 "left_hip_pitch", 7 "right_hip_pitch", 16 "left_shoulder_pitch", 24 "right_shoulder_pitch": articulated-body inertia and bias force through them
  const Four x2753 = x2678 - x2681 * x2744;
  const Four x2851 = load<Four>(cosine + 0) * (x2750 - x2765) - x2753 * x2847;
  const Four x2855 = load<Four>(cosine + 0) * x2851;
  const Four x2856 = x2765 + x2855;
  const Four x2862 = Four{0.0, 0.0, 1.0, 1.0} * x2856;
  const Four x2866 = Four{0.0, 0.0, 1.0, 1.0} * x2862;
  const Four x2997 = x2866 + Four{0.05, 0.05, -0.15, 0.15} * x2823 + Four{0.05, 0.05, -0.15, 0.15} * x2918;
  const Four x2999 = Four{0.0, 0.0, 0.29, 0.29} * x2840 + x2997 + Four{0.0, 0.0, 0.29, 0.29} * x2951;
  // joint 22 "neck_yaw": articulated-body inertia and bias force through it
  const Real x3444 = x3363 + x3412 - 0.38 * x3402 - 0.38 * x3438;
  // joints 1 "left_hip_pitch", 7 "right_hip_pitch", 16 "left_shoulder_pitch", 24 "right_shoulder_pitch": articulated-body inertia and bias force through them
  const Four x2842 = Four{0.0, 0.0, 1.0, 1.0} * x2837;
  const Four x2890 = Four{1.0, 1.0, 0.0, 0.0} * x2875 - Four{0.0, 0.0, 1.0, 1.0} * x2883;
  const Four x2908 = Four{0.05, 0.05, -0.15, 0.15} * x2890;
  const Four x2902 = Four{1.0, 1.0, 0.0, 0.0} * x2898 - x2872;
  const Four x2930 = Four{0.0, 0.0, 0.29, 0.29} * x2902;
  const Four x2933 = x2842 - x2908 - x2930;
  const Four x2825 = Four{1.0, 1.0, 0.0, 0.0} * x2818;
  const Four x2844 = x2821 - x2842;
  const Four x3009 = Four{0.09, -0.09, 0.0, 0.0} * x2918 - (Four{1.0, 1.0, 0.0, 0.0} * x2862 + Four{0.05, 0.05, -0.15, 0.15} * x2825);
  const Four x3011 = x3009 - Four{0.0, 0.0, 0.29, 0.29} * x2844 + Four{0.0, 0.0, 0.29, 0.29} * x2933;
  // joint 22 "neck_yaw": articulated-body inertia and bias force through it
  const Real x3450 = sine[27] * x3407 - 0.38 * x3404 - 0.38 * x3432;
  const Real x3475 = x3011[2] + x3011[3] + x3450;
  // joints 1 "left_hip_pitch", 7 "right_hip_pitch", 16 "left_shoulder_pitch", 24 "right_shoulder_pitch": articulated-body inertia and bias force through them
  const Four x2905 = x2792 - x2903;
  const Four x2939 = Four{0.0, 0.0, 0.29, 0.29} * x2905 - (x2838 + Four{0.09, -0.09, 0.0, 0.0} * x2890);
  const Four x2924 = x2825 - Four{0.09, -0.09, 0.0, 0.0} * x2886 + Four{0.0, 0.0, 0.29, 0.29} * x2890;
  const Four x3021 = Four{0.0, 0.0, 0.29, 0.29} * x2838 + Four{0.09, -0.09, 0.0, 0.0} * x2825 + Four{0.09, -0.09, 0.0, 0.0} * x2924;
  const Four x3024 = x2856 - x2866 - x3021 + Four{0.0, 0.0, 0.29, 0.29} * x2939;
  // joint 22 "neck_yaw": articulated-body inertia and bias force through it
  const Real x3454 = x3383 - x3412 + 0.38 * x3403 + 0.38 * x3435;
  const Real x3480 = x3024[2] + x3024[3] + 0.38728300000000004 + x3454;
  require_more(w, x3480, 0.0, kFactorization, 15);
  const Real x3429 = cosine[27] * x3330 + 0.38 * x3415;
  const Real x3481 = x2924[2] + x2924[3] + -0.095 + x3429;
  const Real x3482 = x2939[2] + x2939[3] + 1.6150000000000002 + x3435;
  // joints 1 "left_hip_pitch", 7 "right_hip_pitch", 16 "left_shoulder_pitch", 24 "right_shoulder_pitch": articulated-body inertia and bias force through them
  const Four x2907 = Four{0.09, -0.09, 0.0, 0.0} * x2893;
  const Four x2955 = x2844 - x2907 + x2930;
  // joint 22 "neck_yaw": articulated-body inertia and bias force through it
  const Real x3483 = x2955[2] + x2955[3] + x3432;
  // joints 6 "left_ankle_roll", 12 "right_ankle_roll", 21 "left_wrist_pitch", 29 "right_wrist_pitch": articulated-body inertia and bias force through them
  const Four x1653 = Four{tau[11], tau[17], tau[26], tau[34]};
  const Four x1656 = Four{828.7290528372782, 828.7290528372782, 499.16813630085466, 499.16813630085466} * (x1653 - (x1345 - x810 * Four{0.0, 0.0, 0.024, 0.024} + x1352));
  // links 7 "left_foot", 13 "right_foot", 22 "left_hand", 30 "right_hand": bias force in the reference field
  const Four x1370 = x830 * Four{0.024, 0.024, 0.0, 0.0} + x1368 + x806 * Four{0.8, 0.8, 0.4, 0.4};
  // joints 6 "left_ankle_roll", 12 "right_ankle_roll", 21 "left_wrist_pitch", 29 "right_wrist_pitch": articulated-body inertia and bias force through them
  const Four x1675 = x1370 + Four{0.024, 0.024, 0.0, 0.0} * x1656;
  // links 7 "left_foot", 13 "right_foot", 22 "left_hand", 30 "right_hand": bias force in the reference field
  const Four x1379 = (x823 - x779) * Four{0.024, 0.024, 0.0, 0.0} + x1377 + x810 * Four{0.8, 0.8, 0.4, 0.4};
  // joints 6 "left_ankle_roll", 12 "right_ankle_roll", 21 "left_wrist_pitch", 29 "right_wrist_pitch": articulated-body inertia and bias force through them
  const Four x1678 = x1379 - Four{0.0, 0.0, 0.024, 0.024} * x1656;
  const Four x1778 = load<Four>(sine + 20) * x1675 + load<Four>(cosine + 20) * x1678;
  // joints 5 "left_ankle_pitch", 11 "right_ankle_pitch", 20 "left_wrist_roll", 28 "right_wrist_roll": articulated-body inertia and bias force through them
  const Four x1809 = Four{tau[10], tau[16], tau[25], tau[33]};
  // joints 6 "left_ankle_roll", 12 "right_ankle_roll", 21 "left_wrist_pitch", 29 "right_wrist_pitch": articulated-body inertia and bias force through them
  const Four x1673 = x1336 + x797 * Four{0.0, 0.0, 0.024, 0.024} + x1352 + Four{0.0007199999999999999, 0.0007199999999999999, 0.0, 0.0} * x1656;
  const Four x1790 = load<Four>(cosine + 20) * x1351 - load<Four>(sine + 20) * x1673 - Four{0.02, 0.02, 0.0, 0.0} * x1389;
  // joints 5 "left_ankle_pitch", 11 "right_ankle_pitch", 20 "left_wrist_roll", 28 "right_wrist_roll": articulated-body inertia and bias force through them
  const Four x1812 = x1810 * (x1809 - (x688 * Four{7.2e-05, 7.2e-05, 9e-05, 9e-05} + x1790));
  // joints 6 "left_ankle_roll", 12 "right_ankle_roll", 21 "left_wrist_pitch", 29 "right_wrist_pitch": articulated-body inertia and bias force through them
  const Four x1802 = x728 * 0.2 - x753 * Four{0.0, 0.0, 0.002, 0.002} + x1778;
  // joints 5 "left_ankle_pitch", 11 "right_ankle_pitch", 20 "left_wrist_roll", 28 "right_wrist_roll": articulated-body inertia and bias force through them
  const Four x1867 = x1802 + x1693 * x1812;
  // joints 6 "left_ankle_roll", 12 "right_ankle_roll", 21 "left_wrist_pitch", 29 "right_wrist_pitch": articulated-body inertia and bias force through them
  const Four x1803 = x732 * 0.2 - x747 * Four{0.0, 0.0, 0.002, 0.002} + x1389;
  // joints 5 "left_ankle_pitch", 11 "right_ankle_pitch", 20 "left_wrist_roll", 28 "right_wrist_roll": articulated-body inertia and bias force through them
  const Four x1869 = x1803 + x1726 * x1812;
  const Four x2075 = load<Four>(cosine + 16) * x1867 - load<Four>(sine + 16) * x1869;
  // links 5 "left_shank", 11 "right_shank", 20 "left_forearm", 28 "right_forearm": bias force in the reference field
  const Four x1235 = x641 * Four{0.234, 0.234, -0.013999999999999999, -0.013999999999999999} + x644 * Four{0.018000000000000002, 0.018000000000000002, 0.049, 0.049} + x631 * Four{1.8, 1.8, 0.7, 0.7};
  // joints 4 "left_knee", 10 "right_knee", 19 "left_elbow", 27 "right_elbow": articulated-body inertia and bias force through them
  const Four x2118 = Four{tau[9], tau[15], tau[24], tau[32]};
  // links 6 "left_ankle", 12 "right_ankle", 21 "left_wrist", 29 "right_wrist": bias force in the reference field
  const Four x1276 = x697 * Four{7.2e-05, 7.2e-05, 0.00010666669999999999, 0.00010666669999999999} - x746 * Four{0.0, 0.0, 1.666669999999999e-05, 1.666669999999999e-05} + x732 * Four{0.0, 0.0, 0.002, 0.002};
  // joints 6 "left_ankle_roll", 12 "right_ankle_roll", 21 "left_wrist_pitch", 29 "right_wrist_pitch": articulated-body inertia and bias force through them
  const Four x1781 = load<Four>(sine + 20) * x1351 + load<Four>(cosine + 20) * x1673 + Four{0.0, 0.0, 0.04, 0.04} * x1389;
  // joints 5 "left_ankle_pitch", 11 "right_ankle_pitch", 20 "left_wrist_roll", 28 "right_wrist_roll": articulated-body inertia and bias force through them
  const Four x1863 = x1276 + x1781 + x1748 * x1812;
  // joints 6 "left_ankle_roll", 12 "right_ankle_roll", 21 "left_wrist_pitch", 29 "right_wrist_pitch": articulated-body inertia and bias force through them
  const Four x1775 = load<Four>(cosine + 20) * x1675 - load<Four>(sine + 20) * x1678;
  // links 6 "left_ankle", 12 "right_ankle", 21 "left_wrist", 29 "right_wrist": bias force in the reference field
  const Four x1279 = x700 * Four{7.2e-05, 7.2e-05, 0.00010666669999999999, 0.00010666669999999999} + x751 * Four{0.0, 0.0, 1.666669999999999e-05, 1.666669999999999e-05} - x728 * Four{0.0, 0.0, 0.002, 0.002};
  // joints 6 "left_ankle_roll", 12 "right_ankle_roll", 21 "left_wrist_pitch", 29 "right_wrist_pitch": articulated-body inertia and bias force through them
  const Four x1800 = x1653 - Four{0.0, 0.0, 0.04, 0.04} * x1778 + Four{0.02, 0.02, 0.0, 0.0} * x1775 + x1279;
  // joints 5 "left_ankle_pitch", 11 "right_ankle_pitch", 20 "left_wrist_roll", 28 "right_wrist_roll": articulated-body inertia and bias force through them
  const Four x1865 = x1800 + x1758 * x1812;
  const Four x2064 = load<Four>(sine + 16) * x1863 + load<Four>(cosine + 16) * x1865;
  const Four x2078 = load<Four>(sine + 16) * x1867 + load<Four>(cosine + 16) * x1869;
  // joints 6 "left_ankle_roll", 12 "right_ankle_roll", 21 "left_wrist_pitch", 29 "right_wrist_pitch": articulated-body inertia and bias force through them
  const Four x1804 = x725 * 0.2 + x749 * Four{0.0, 0.0, 0.002, 0.002} + x1775;
  // joints 5 "left_ankle_pitch", 11 "right_ankle_pitch", 20 "left_wrist_roll", 28 "right_wrist_roll": articulated-body inertia and bias force through them
  const Four x1871 = x1804 + x1695 * x1812;
  const Four x2082 = Four{1.0, 1.0, 0.0, 0.0} * x2078 - Four{0.0, 0.0, 1.0, 1.0} * x1871;
  const Four x2095 = Four{0.0, 0.0, 1.0, 1.0} * x2064 + Four{1.0, 1.0, 0.0, 0.0} * x1809 - Four{0.0, 0.0, 0.16, 0.16} * x2075;
  const Four x2110 = x1228 - x631 * Four{0.018000000000000002, 0.018000000000000002, 0.049, 0.049} + (x2095 - Four{0.3, 0.3, -0.01, -0.01} * x2082);
  // joints 4 "left_knee", 10 "right_knee", 19 "left_elbow", 27 "right_elbow": articulated-body inertia and bias force through them
  const Four x2121 = x2119 * (x2118 - x2110);
  const Four x2178 = x1235 + x2075 + x2103 * x2121;
  // links 5 "left_shank", 11 "right_shank", 20 "left_forearm", 28 "right_forearm": bias force in the reference field
  const Four x1243 = x635 * Four{1.8, 1.8, 0.7, 0.7} - (x645 * Four{0.234, 0.234, -0.013999999999999999, -0.013999999999999999} + x646 * Four{0.018000000000000002, 0.018000000000000002, 0.049, 0.049});
  // joints 4 "left_knee", 10 "right_knee", 19 "left_elbow", 27 "right_elbow": articulated-body inertia and bias force through them
  const Four x2180 = x1243 + x2082 + x2104 * x2121;
  const Four x2276 = x597 * x2178 + x592 * x2180;
  // joints 3 "left_hip_yaw", 9 "right_hip_yaw", 18 "left_shoulder_yaw", 26 "right_shoulder_yaw": articulated-body inertia and bias force through them
  const Four x2301 = Four{tau[8], tau[14], tau[23], tau[31]};
  // joints 5 "left_ankle_pitch", 11 "right_ankle_pitch", 20 "left_wrist_roll", 28 "right_wrist_roll": articulated-body inertia and bias force through them
  const Four x2085 = Four{0.0, 0.0, 1.0, 1.0} * x2078 + Four{1.0, 1.0, 0.0, 0.0} * x1871;
  const Four x2087 = load<Four>(cosine + 16) * x1863 - load<Four>(sine + 16) * x1865 + Four{0.0, 0.0, 0.16, 0.16} * x2085;
  // joints 4 "left_knee", 10 "right_knee", 19 "left_elbow", 27 "right_elbow": articulated-body inertia and bias force through them
  const Four x2174 = x1202 + x625 * Four{0.018000000000000002, 0.018000000000000002, 0.049, 0.049} + x2087 + x2030 * x2121;
  // joints 5 "left_ankle_pitch", 11 "right_ankle_pitch", 20 "left_wrist_roll", 28 "right_wrist_roll": articulated-body inertia and bias force through them
  const Four x2090 = Four{1.0, 1.0, 0.0, 0.0} * x2064 - Four{0.0, 0.0, 1.0, 1.0} * x1809 + Four{0.3, 0.3, -0.01, -0.01} * x2085;
  // joints 4 "left_knee", 10 "right_knee", 19 "left_elbow", 27 "right_elbow": articulated-body inertia and bias force through them
  const Four x2176 = x1211 + x625 * Four{0.234, 0.234, -0.013999999999999999, -0.013999999999999999} + x2090 + x2045 * x2121;
  const Four x2293 = x592 * x2174 - x597 * x2176 + x471 * Four{0.00468, 0.00468, 0.00064, 0.00064};
  // joints 3 "left_hip_yaw", 9 "right_hip_yaw", 18 "left_shoulder_yaw", 26 "right_shoulder_yaw": articulated-body inertia and bias force through them
  const Four x2304 = x2302 * (x2301 - x2293);
  // joints 4 "left_knee", 10 "right_knee", 19 "left_elbow", 27 "right_elbow": articulated-body inertia and bias force through them
  const Four x2294 = x555 * Four{2.6, 2.6, 0.8, 0.8} - x579 * Four{0.26, 0.26, 0.04000000000000001, 0.04000000000000001} + x2276;
  // joints 3 "left_hip_yaw", 9 "right_hip_yaw", 18 "left_shoulder_yaw", 26 "right_shoulder_yaw": articulated-body inertia and bias force through them
  const Four x2362 = x2294 + x2199 * x2304;
  // links 5 "left_shank", 11 "right_shank", 20 "left_forearm", 28 "right_forearm": bias force in the reference field
  const Four x1249 = x625 * Four{1.8, 1.8, 0.7, 0.7} - x654 * Four{0.234, 0.234, -0.013999999999999999, -0.013999999999999999} + x650 * Four{0.018000000000000002, 0.018000000000000002, 0.049, 0.049};
  // joints 4 "left_knee", 10 "right_knee", 19 "left_elbow", 27 "right_elbow": articulated-body inertia and bias force through them
  const Four x2183 = x1249 + x2085 - x2010 * x2121;
  const Four x2295 = x559 * Four{2.6, 2.6, 0.8, 0.8} - x573 * Four{0.26, 0.26, 0.04000000000000001, 0.04000000000000001} + x2183;
  // joints 3 "left_hip_yaw", 9 "right_hip_yaw", 18 "left_shoulder_yaw", 26 "right_shoulder_yaw": articulated-body inertia and bias force through them
  const Four x2364 = x2295 + x2187 * x2304;
  const Four x2465 = load<Four>(sine + 8) * x2362 + load<Four>(cosine + 8) * x2364;
  // joints 2 "left_hip_roll", 8 "right_hip_roll", 17 "left_shoulder_roll", 25 "right_shoulder_roll": articulated-body inertia and bias force through them
  const Four x2491 = Four{tau[7], tau[13], tau[22], tau[30]};
  // links 4 "left_thigh", 10 "right_thigh", 19 "left_upper_arm", 27 "right_upper_arm": bias force in the reference field
  const Four x1154 = x539 * Four{0.0429867, 0.0429867, 0.0036266700000000002, 0.0036266700000000002} - x572 * Four{0.038306700000000006, 0.038306700000000006, 0.0029866700000000003, 0.0029866700000000003} + x559 * Four{0.26, 0.26, 0.04000000000000001, 0.04000000000000001};
  // joints 4 "left_knee", 10 "right_knee", 19 "left_elbow", 27 "right_elbow": articulated-body inertia and bias force through them
  const Four x2279 = x597 * x2174 + x592 * x2176 + Four{0.24, 0.24, 0.11, 0.11} * x2183;
  // joints 3 "left_hip_yaw", 9 "right_hip_yaw", 18 "left_shoulder_yaw", 26 "right_shoulder_yaw": articulated-body inertia and bias force through them
  const Four x2357 = x1154 + x2279 + x2258 * x2304;
  // links 4 "left_thigh", 10 "right_thigh", 19 "left_upper_arm", 27 "right_upper_arm": bias force in the reference field
  const Four x1157 = x542 * Four{0.0429867, 0.0429867, 0.0036266700000000002, 0.0036266700000000002} + x577 * Four{0.038306700000000006, 0.038306700000000006, 0.0029866700000000003, 0.0029866700000000003} - x555 * Four{0.26, 0.26, 0.04000000000000001, 0.04000000000000001};
  // joints 3 "left_hip_yaw", 9 "right_hip_yaw", 18 "left_shoulder_yaw", 26 "right_shoulder_yaw": articulated-body inertia and bias force through them
  const Four x2360 = x2118 - Four{0.24, 0.24, 0.11, 0.11} * x2276 + x1157 - x2261 * x2304;
  const Four x2471 = load<Four>(cosine + 8) * x2357 - load<Four>(sine + 8) * x2360 + Four{0.12, 0.12, 0.1, 0.1} * x2465;
  const Four x2483 = x1083 + x492 * Four{0.0, 0.0, 0.006999999999999999, -0.006999999999999999} + x488 * Four{0.048, 0.048, 0.020999999999999998, 0.020999999999999998} + x2471;
  // joints 2 "left_hip_roll", 8 "right_hip_roll", 17 "left_shoulder_roll", 25 "right_shoulder_roll": articulated-body inertia and bias force through them
  const Four x2494 = x2492 * (x2491 - x2483);
  const Four x2549 = x488 * Four{1.2, 1.2, 0.7, 0.7} + x1108 + x2465 + x2476 * x2494;
  // links 4 "left_thigh", 10 "right_thigh", 19 "left_upper_arm", 27 "right_upper_arm": bias force in the reference field
  const Four x1169 = x549 * Four{2.6, 2.6, 0.8, 0.8} + x575 * Four{0.26, 0.26, 0.04000000000000001, 0.04000000000000001};
  // joints 4 "left_knee", 10 "right_knee", 19 "left_elbow", 27 "right_elbow": articulated-body inertia and bias force through them
  const Four x2296 = x592 * x2178 - x597 * x2180 + x1169;
  // links 3 "left_groin", 9 "right_groin", 18 "left_shoulder_cap", 26 "right_shoulder_cap": bias force in the reference field
  const Four x1117 = (x506 - x468) * Four{0.024, 0.024, 0.0, 0.0} + x1115 + x492 * Four{1.2, 1.2, 0.7, 0.7};
  // joints 2 "left_hip_roll", 8 "right_hip_roll", 17 "left_shoulder_roll", 25 "right_shoulder_roll": articulated-body inertia and bias force through them
  const Four x2551 = x2296 + x2202 * x2304 + x1117 + x2477 * x2494;
  // links 2 "left_hip", 8 "right_hip", 17 "left_shoulder", 25 "right_shoulder": bias force in the reference field
  const Four x1021 = x397 * Four{1.4, 1.4, 0.8, 0.8} - x425 * Four{0.041999999999999996, -0.041999999999999996, 0.024, -0.024};
  // joints 1 "left_hip_pitch", 7 "right_hip_pitch", 16 "left_shoulder_pitch", 24 "right_shoulder_pitch": articulated-body inertia and bias force through them
  const Four x2739 = Four{tau[6], tau[12], tau[21], tau[29]};
  // joints 3 "left_hip_yaw", 9 "right_hip_yaw", 18 "left_shoulder_yaw", 26 "right_shoulder_yaw": articulated-body inertia and bias force through them
  const Four x2462 = load<Four>(cosine + 8) * x2362 - load<Four>(sine + 8) * x2364;
  const Four x2468 = load<Four>(sine + 8) * x2357 + load<Four>(cosine + 8) * x2360 - Four{0.12, 0.12, 0.1, 0.1} * x2462;
  const Four x2481 = x1062 - x485 * Four{0.048, 0.048, 0.020999999999999998, 0.020999999999999998} - x492 * Four{0.024, 0.024, 0.0, 0.0} + x2468;
  // joints 2 "left_hip_roll", 8 "right_hip_roll", 17 "left_shoulder_roll", 25 "right_shoulder_roll": articulated-body inertia and bias force through them
  const Four x2545 = x2481 + x2445 * x2494;
  const Four x2547 = x488 * Four{0.024, 0.024, 0.0, 0.0} + x1093 + x2301 + Four{0.00096, 0.00096, 0.0, 0.0} * x2494;
  const Four x2731 = load<Four>(cosine + 4) * x2545 - load<Four>(sine + 4) * x2547 + x354 * Four{0.00175, 0.00175, 0.00064, 0.00064};
  // joints 1 "left_hip_pitch", 7 "right_hip_pitch", 16 "left_shoulder_pitch", 24 "right_shoulder_pitch": articulated-body inertia and bias force through them
  const Four x2742 = x2740 * (x2739 - x2731);
  // joints 2 "left_hip_roll", 8 "right_hip_roll", 17 "left_shoulder_roll", 25 "right_shoulder_roll": articulated-body inertia and bias force through them
  const Four x2734 = load<Four>(cosine + 4) * x2549 - load<Four>(sine + 4) * x2551 + x1021;
  // joints 1 "left_hip_pitch", 7 "right_hip_pitch", 16 "left_shoulder_pitch", 24 "right_shoulder_pitch": articulated-body inertia and bias force through them
  const Four x2802 = x2734 + x2572 * x2742;
  // joints 2 "left_hip_roll", 8 "right_hip_roll", 17 "left_shoulder_roll", 25 "right_shoulder_roll": articulated-body inertia and bias force through them
  const Four x2708 = load<Four>(sine + 4) * x2549 + load<Four>(cosine + 4) * x2551;
  const Four x2553 = x1125 - x508 * Four{0.048, 0.048, 0.020999999999999998, 0.020999999999999998} + x2462 + x2433 * x2494;
  const Four x2712 = Four{1.0, 1.0, 0.0, 0.0} * x2708 - Four{0.0, 0.0, 1.0, 1.0} * x2553;
  const Four x2732 = x404 * Four{1.4, 1.4, 0.8, 0.8} + x429 * Four{0.041999999999999996, -0.041999999999999996, 0.024, -0.024} + x2712;
  // joints 1 "left_hip_pitch", 7 "right_hip_pitch", 16 "left_shoulder_pitch", 24 "right_shoulder_pitch": articulated-body inertia and bias force through them
  const Four x2798 = x2732 + x2579 * x2742;
  // joints 2 "left_hip_roll", 8 "right_hip_roll", 17 "left_shoulder_roll", 25 "right_shoulder_roll": articulated-body inertia and bias force through them
  const Four x2715 = Four{0.0, 0.0, 1.0, 1.0} * x2708 + Four{1.0, 1.0, 0.0, 0.0} * x2553;
  const Four x2733 = x408 * Four{1.4, 1.4, 0.8, 0.8} + x423 * Four{0.041999999999999996, -0.041999999999999996, 0.024, -0.024} + x2715;
  // joints 1 "left_hip_pitch", 7 "right_hip_pitch", 16 "left_shoulder_pitch", 24 "right_shoulder_pitch": articulated-body inertia and bias force through them
  const Four x2800 = x2733 + x2582 * x2742;
  const Four x3042 = load<Four>(cosine + 0) * x2798 - load<Four>(sine + 0) * x2800;
  const Four x3049 = Four{1.0, 1.0, 0.0, 0.0} * x2802 - Four{0.0, 0.0, 1.0, 1.0} * x3042;
  // joints 2 "left_hip_roll", 8 "right_hip_roll", 17 "left_shoulder_roll", 25 "right_shoulder_roll": articulated-body inertia and bias force through them
  const Four x2694 = load<Four>(sine + 4) * x2545 + load<Four>(cosine + 4) * x2547;
  // links 2 "left_hip", 8 "right_hip", 17 "left_shoulder", 25 "right_shoulder": bias force in the reference field
  const Four x1009 = x367 * Four{0.00308, 0.00308, 0.001366667, 0.001366667} - x422 * Four{0.0013299999999999998, 0.0013299999999999998, 0.0007266669999999999, 0.0007266669999999999} - x408 * Four{0.041999999999999996, -0.041999999999999996, 0.024, -0.024};
  // joints 2 "left_hip_roll", 8 "right_hip_roll", 17 "left_shoulder_roll", 25 "right_shoulder_roll": articulated-body inertia and bias force through them
  const Four x2718 = Four{1.0, 1.0, 0.0, 0.0} * x2694 - Four{0.0, 0.0, 1.0, 1.0} * x2491 - Four{0.04, -0.04, 0.05, -0.05} * x2715;
  // joints 1 "left_hip_pitch", 7 "right_hip_pitch", 16 "left_shoulder_pitch", 24 "right_shoulder_pitch": articulated-body inertia and bias force through them
  const Four x2794 = x1009 + x2718 + x2681 * x2742;
  // links 2 "left_hip", 8 "right_hip", 17 "left_shoulder", 25 "right_shoulder": bias force in the reference field
  const Four x1011 = x370 * Four{0.00308, 0.00308, 0.001366667, 0.001366667} + x427 * Four{0.0013299999999999998, 0.0013299999999999998, 0.0007266669999999999, 0.0007266669999999999} + x404 * Four{0.041999999999999996, -0.041999999999999996, 0.024, -0.024};
  // joints 2 "left_hip_roll", 8 "right_hip_roll", 17 "left_shoulder_roll", 25 "right_shoulder_roll": articulated-body inertia and bias force through them
  const Four x2720 = Four{0.0, 0.0, 1.0, 1.0} * x2694 + Four{1.0, 1.0, 0.0, 0.0} * x2491 + Four{0.04, -0.04, 0.05, -0.05} * x2712;
  // joints 1 "left_hip_pitch", 7 "right_hip_pitch", 16 "left_shoulder_pitch", 24 "right_shoulder_pitch": articulated-body inertia and bias force through them
  const Four x2796 = x1011 + x2720 + x2687 * x2742;
  const Four x3052 = Four{0.0, 0.0, 1.0, 1.0} * x2802 + Four{1.0, 1.0, 0.0, 0.0} * x3042;
  const Four x3056 = load<Four>(sine + 0) * x2794 + load<Four>(cosine + 0) * x2796 + Four{0.09, -0.09, 0.0, 0.0} * x3052;
  const Four x3057 = Four{0.05, 0.05, -0.15, 0.15} * x3049 + x3056;
  const Four x3028 = load<Four>(cosine + 0) * x2794 - load<Four>(sine + 0) * x2796;
  const Four x3045 = load<Four>(sine + 0) * x2798 + load<Four>(cosine + 0) * x2800;
  const Four x3062 = Four{1.0, 1.0, 0.0, 0.0} * x2739 - Four{0.0, 0.0, 1.0, 1.0} * x3028 - Four{0.05, 0.05, -0.15, 0.15} * x3045;
  const Four x3063 = x3062 - Four{0.0, 0.0, 0.29, 0.29} * x3052;
  // joint 22 "neck_yaw": articulated-body inertia and bias force through it
  const Real x3471 = cosine[27] * x3391 - sine[27] * x3370 - 0.38 * x3468;
  // joints 1 "left_hip_pitch", 7 "right_hip_pitch", 16 "left_shoulder_pitch", 24 "right_shoulder_pitch": articulated-body inertia and bias force through them
  const Four x3067 = Four{0.0, 0.0, 1.0, 1.0} * x2739 + Four{1.0, 1.0, 0.0, 0.0} * x3028 - Four{0.09, -0.09, 0.0, 0.0} * x3045;
  const Four x3068 = Four{0.0, 0.0, 0.29, 0.29} * x3049 + x3067;
  // joint 22 "neck_yaw": articulated-body inertia and bias force through it
  const Real x3473 = sine[27] * x3391 + cosine[27] * x3370 + 0.38 * x3465;
  // joints 1 "left_hip_pitch", 7 "right_hip_pitch", 16 "left_shoulder_pitch", 24 "right_shoulder_pitch": articulated-body inertia and bias force through them
  const Real x3271 = x267 * 9.5 + x1522 + (x3045[2] + x3045[3]);
  // link 16 "torso": bias force in the reference field
  const Real x1529 = x281 * 1.6150000000000002 - x282 * 0.095 + x271 * 9.5;
  const Real x1534 = x257 * 9.5 + x290 * 1.6150000000000002 + x286 * 0.095;
  // joint 15 "waist_pitch": articulated-body inertia and bias force through it
  const Real x3497 = 1 / x3480;
  // joint 22 "neck_yaw": articulated-body inertia and bias force through it
  const Real x3492 = x1516 - x267 * 0.095 + (x3068[2] + x3068[3]) + x3473;
  // joint 15 "waist_pitch": articulated-body inertia and bias force through it
  const Real x3499 = x3497 * (tau[20] - x3492);
  // joints 1 "left_hip_pitch", 7 "right_hip_pitch", 16 "left_shoulder_pitch", 24 "right_shoulder_pitch": articulated-body inertia and bias force through them
  const Four x2809 = load<Four>(sine + 0) * x2762 + load<Four>(cosine + 0) * x2774;
  const Four x2819 = x2768 + x2816;
  const Four x2829 = Four{1.0, 1.0, 0.0, 0.0} * x2809 - Four{0.0, 0.0, 1.0, 1.0} * x2819;
  const Four x2929 = x2829 + Four{0.09, -0.09, 0.0, 0.0} * x2902 + Four{0.05, 0.05, -0.15, 0.15} * x2905;
  const Four x2854 = x2753 + load<Four>(sine + 0) * x2851;
  const Four x2911 = x2756 - x2820 + x2907 + x2908;
  const Four x2985 = Four{1.0, 1.0, 0.0, 0.0} * x2854 - Four{0.05, 0.05, -0.15, 0.15} * x2838 - Four{0.09, -0.09, 0.0, 0.0} * x2911;
  const Four x2987 = Four{0.09, -0.09, 0.0, 0.0} * x2844 + x2985 + Four{0.0, 0.0, 0.29, 0.29} * x2929;
  const Real x3194 = x2987[2] + x2987[3];
  // joint 15 "waist_pitch": articulated-body inertia and bias force through it
  const Real x3500 = x3194 * x3497;
  const Real x3501 = x3475 * x3497;
  const Real x3502 = x3481 * x3497;
  const Real x3503 = x3482 * x3497;
  const Real x3504 = x3483 * x3497;
  // joints 1 "left_hip_pitch", 7 "right_hip_pitch", 16 "left_shoulder_pitch", 24 "right_shoulder_pitch": articulated-body inertia and bias force through them
  const Four x2832 = Four{0.0, 0.0, 1.0, 1.0} * x2809 + Four{1.0, 1.0, 0.0, 0.0} * x2819;
  const Four x2944 = x2832 + Four{0.09, -0.09, 0.0, 0.0} * x2906 + Four{0.05, 0.05, -0.15, 0.15} * x2902;
  const Four x2963 = x2750 - x2855 + Four{0.09, -0.09, 0.0, 0.0} * x2832 + Four{0.05, 0.05, -0.15, 0.15} * x2829;
  const Four x2965 = Four{0.09, -0.09, 0.0, 0.0} * x2944 + x2963 + Four{0.05, 0.05, -0.15, 0.15} * x2929;
  // joint 15 "waist_pitch": articulated-body inertia and bias force through it
  const Real x3507 = x2965[2] + x2965[3] + 0.0832833 - x3194 * x3500;
  // joints 1 "left_hip_pitch", 7 "right_hip_pitch", 16 "left_shoulder_pitch", 24 "right_shoulder_pitch": articulated-body inertia and bias force through them
  const Four x2975 = Four{0.05, 0.05, -0.15, 0.15} * x2842 - Four{0.0, 0.0, 1.0, 1.0} * x2854 - Four{0.05, 0.05, -0.15, 0.15} * x2911;
  const Four x2977 = x2975 - Four{0.09, -0.09, 0.0, 0.0} * x2840 - Four{0.0, 0.0, 0.29, 0.29} * x2944;
  // joint 15 "waist_pitch": articulated-body inertia and bias force through it
  const Real x3510 = x2977[2] + x2977[3] + -0.01615 - x3194 * x3501;
  const Real x3513 = x2911[2] + x2911[3] - x3194 * x3502;
  const Real x3516 = x2929[2] + x2929[3] - x3194 * x3503;
  const Real x3519 = x2944[2] + x2944[3] + 0.095 - x3194 * x3504;
  const Real x3522 = x2999[2] + x2999[3] + 0.42813300000000004 + x3444 - x3475 * x3501;
  // joint 22 "neck_yaw": articulated-body inertia and bias force through it
  const Real x3476 = x2918[2] + x2918[3] + (sine[27] * x3330 + 0.38 * x3416);
  // joint 15 "waist_pitch": articulated-body inertia and bias force through it
  const Real x3525 = x3476 + x3475 * x3502;
  const Real x3529 = x2933[2] + x2933[3] - x3432 - x3475 * x3503;
  const Real x3532 = -1.6150000000000002 - (x2951[2] + x2951[3]) + x3438 - x3475 * x3504;
  // joint 22 "neck_yaw": articulated-body inertia and bias force through it
  const Real x3484 = x2886[2] + x2886[3] + 9.5 + (0.74412265758092 + x3323 + 0.4);
  // joint 15 "waist_pitch": articulated-body inertia and bias force through it
  const Real x3535 = x3484 - x3481 * x3502;
  const Real x3538 = x2890[2] + x2890[3] + x3415 - x3481 * x3503;
  const Real x3541 = x2893[2] + x2893[3] + x3416 - x3481 * x3504;
  const Real x3544 = x2905[2] + x2905[3] + 9.5 + x3422 - x3482 * x3503;
  const Real x3547 = x2902[2] + x2902[3] + x3419 - x3482 * x3504;
  const Real x3550 = x2906[2] + x2906[3] + 9.5 + x3423 - x3483 * x3504;
  // joint 22 "neck_yaw": articulated-body inertia and bias force through it
  const Real x3490 = x1489 + x257 * 0.095 + (x3057[2] + x3057[3]) + tau[27];
  // joint 15 "waist_pitch": articulated-body inertia and bias force through it
  const Real x3552 = x3490 + x3194 * x3499;
  // joint 22 "neck_yaw": articulated-body inertia and bias force through it
  const Real x3491 = x1499 - x257 * 1.6150000000000002 + (x3063[2] + x3063[3]) + x3471;
  // joint 15 "waist_pitch": articulated-body inertia and bias force through it
  const Real x3554 = x3491 + x3475 * x3499;
  // joint 22 "neck_yaw": articulated-body inertia and bias force through it
  const Real x3493 = cosine[28] * x3290 - sine[28] * x3292 + x1568 + x3271;
  // joint 15 "waist_pitch": articulated-body inertia and bias force through it
  const Real x3556 = x3493 + x3481 * x3499;
  const Real x3558 = x3049[2] + x3049[3] + x1529 + x3465 + x3482 * x3499;
  const Real x3560 = x3052[2] + x3052[3] + x1534 + x3468 + x3483 * x3499;
  const Real x3564 = cosine[26] * x3519 - sine[26] * x3532;
  const Real x3567 = sine[26] * x3519 + cosine[26] * x3532;
  const Real x3573 = cosine[26] * (x3513 - x3529) - sine[26] * (x3516 - x3525);
  const Real x3574 = sine[26] * x3573;
  const Real x3576 = x3516 + x3574;
  const Real x3578 = cosine[26] * x3573;
  const Real x3580 = x3513 - x3578;
  const Real x3583 = 2.0 * sine[26];
  const Real x3587 = cosine[26] * (x3507 - x3522) - x3510 * x3583;
  const Real x3591 = cosine[26] * x3587;
  const Real x3597 = cosine[26] * x3541 - sine[26] * x3547;
  const Real x3600 = sine[26] * x3541 + cosine[26] * x3547;
  const Real x3605 = cosine[26] * (x3535 - x3544) - x3538 * x3583;
  const Real x3608 = x3538 + sine[26] * x3605;
  const Real x3609 = cosine[26] * x3605;
  const Real x3611 = x3535 - x3609;
  const Real x3612 = 0.04 * x3600;
  const Real x3615 = x3567 - 0.04 * x3550;
  const Real x3619 = x3574 - x3525 - 0.04 * x3597;
  const Real x3620 = 0.04 * x3611;
  const Real x3622 = x3580 - x3612;
  const Real x3628 = 0.04 * x3580 - 0.04 * x3612;
  const Real x3631 = x3510 + sine[26] * x3587 - 0.04 * x3564;
  const Real x3652 = sine[26] * x3556 + cosine[26] * x3558;
  const Real x3638 = x3507 - x3591 - (0.04 * x3567 + 0.04 * x3615);
  const Real x3661 = 0.0014025 + x3638;
  require_more(w, x3661, 0.0, kFactorization, 14);
  const Real x3662 = -0.018000000000000002 + x3615;
  // link 15 "abdomen": bias force in the reference field
  const Real x1447 = x188 * 0.0014025 + x222 * 0.00027750000000000013 + x193 * 0.018000000000000002;
  const Real x1450 = x136 * 0.0014025 - x217 * 0.00027750000000000013 - x203 * 0.018000000000000002;
  // joint 15 "waist_pitch": articulated-body inertia and bias force through it
  const Real x3657 = sine[26] * x3552 + cosine[26] * x3554 - 0.04 * x3560;
  const Real x3649 = cosine[26] * x3556 - sine[26] * x3558;
  // joint 14 "waist_roll": articulated-body inertia and bias force through it
  const Real x3673 = 1 / x3661;
  const Real x3675 = x3673 * (tau[19] - (x1450 + x3657));
  const Real x3676 = x3628 * x3673;
  const Real x3677 = x3631 * x3673;
  const Real x3678 = x3662 * x3673;
  const Real x3679 = x3619 * x3673;
  const Real x3680 = x3622 * x3673;
  const Real x3683 = 0.0014025 + 0.04 * x3620 - x3628 * x3676;
  const Real x3686 = 0.04 * x3576 - x3628 * x3677;
  const Real x3689 = x3612 - x3628 * x3678;
  const Real x3692 = 0.04 * x3608 - x3628 * x3679;
  const Real x3695 = 0.018000000000000002 + x3620 - x3628 * x3680;
  const Real x3698 = x3522 + x3591 + 0.001125 - x3631 * x3677;
  const Real x3701 = x3564 - x3631 * x3678;
  const Real x3704 = x3529 + x3578 - x3631 * x3679;
  const Real x3707 = x3576 - x3631 * x3680;
  const Real x3710 = 0.9 + x3550 - x3662 * x3678;
  const Real x3713 = x3597 - x3662 * x3679;
  const Real x3716 = x3600 - x3662 * x3680;
  const Real x3719 = x3544 + x3609 + 0.9 - x3619 * x3679;
  const Real x3722 = x3608 - x3619 * x3680;
  const Real x3725 = 0.9 + x3611 - x3622 * x3680;
  const Real x3727 = tau[20] + 0.04 * x3652 + x1447 + x3628 * x3675;
  // joint 15 "waist_pitch": articulated-body inertia and bias force through it
  const Real x3667 = cosine[26] * x3552 - sine[26] * x3554 + x191 * 0.001125;
  // joint 14 "waist_roll": articulated-body inertia and bias force through it
  const Real x3729 = x3667 + x3631 * x3675;
  // joint 15 "waist_pitch": articulated-body inertia and bias force through it
  const Real x3669 = x203 * 0.9 + x218 * 0.018000000000000002 + x3560;
  // joint 14 "waist_roll": articulated-body inertia and bias force through it
  const Real x3731 = x3669 + x3662 * x3675;
  // joint 15 "waist_pitch": articulated-body inertia and bias force through it
  const Real x3670 = x3649 - (x208 * 0.9 + x220 * 0.018000000000000002);
  // joint 14 "waist_roll": articulated-body inertia and bias force through it
  const Real x3733 = x3670 + x3619 * x3675;
  // joint 15 "waist_pitch": articulated-body inertia and bias force through it
  const Real x3671 = x193 * 0.9 + x224 * 0.018000000000000002 + x3652;
  // joint 14 "waist_roll": articulated-body inertia and bias force through it
  const Real x3735 = x3671 + x3622 * x3675;
  const Real x3739 = cosine[25] * x3695 - sine[25] * x3707;
  const Real x3742 = sine[25] * x3695 + cosine[25] * x3707;
  const Real x3748 = cosine[25] * (x3689 - x3704) - sine[25] * (x3692 + x3701);
  const Real x3749 = sine[25] * x3748;
  const Real x3752 = x3701 + x3749;
  const Real x3753 = cosine[25] * x3748;
  const Real x3754 = x3704 + x3753;
  const Real x3755 = x3689 - x3753;
  const Real x3758 = 2.0 * sine[25];
  const Real x3762 = cosine[25] * (x3683 - x3698) - x3686 * x3758;
  const Real x3766 = cosine[25] * x3762;
  const Real x3772 = cosine[25] * x3716 - sine[25] * x3722;
  const Real x3775 = sine[25] * x3716 + cosine[25] * x3722;
  const Real x3780 = cosine[25] * (x3710 - x3719) - x3713 * x3758;
  const Real x3783 = x3713 + sine[25] * x3780;
  const Real x3784 = cosine[25] * x3780;
  const Real x3785 = x3719 + x3784;
  const Real x3787 = 0.05 * x3772;
  const Real x3790 = x3739 + 0.05 * x3725;
  const Real x3791 = 0.05 * x3785;
  const Real x3806 = 0.05 * x3752;
  const Real x3813 = x3686 + sine[25] * x3762 + 0.05 * x3742;
  const Real x3824 = cosine[25] * x3731 - sine[25] * x3733;
  const Real x3811 = x3698 + x3766 + (0.05 * x3739 + 0.05 * x3790);
  const Real x3837 = x3683 - x3766 + 0.001;
  require_more(w, x3837, 0.0, kFactorization, 13);
  // link 14 "waist_link": bias force in the reference field
  const Real x1411 = x136 * 0.00106 - x161 * 6e-05 - x149 * 0.016;
  const Real x1413 = x166 * 6e-05 - x137 * 0.00106 + x145 * 0.016;
  // joint 14 "waist_roll": articulated-body inertia and bias force through it
  const Real x3832 = cosine[25] * x3727 - sine[25] * x3729 + 0.05 * x3735;
  const Real x3827 = sine[25] * x3731 + cosine[25] * x3733;
  // joint 13 "waist_yaw": articulated-body inertia and bias force through it
  const Real x3847 = 1 / x3837;
  const Real x3849 = x3847 * (tau[18] - (sine[25] * x3727 + cosine[25] * x3729));
  const Real x3850 = x3806 * x3847;
  const Real x3852 = x3813 * x3847;
  const Real x3853 = x3742 * x3847;
  const Real x3854 = x3752 * x3847;
  const Real x3855 = x3755 * x3847;
  const Real x3858 = 0.00106 + 0.05 * x3791 - x3806 * x3850;
  const Real x3861 = x3806 * x3852 - (0.05 * x3754 + 0.05 * x3787);
  const Real x3864 = x3806 * x3853 - x3787;
  const Real x3867 = -0.016 - x3791 + x3806 * x3854;
  const Real x3870 = x3806 * x3855 - 0.05 * x3783;
  const Real x3873 = 0.00106 + x3811 - x3813 * x3852;
  const Real x3876 = 0.016 + x3790 - x3813 * x3853;
  const Real x3879 = x3754 + x3787 - x3813 * x3854;
  const Real x3882 = x3692 + x3749 + 0.05 * x3775 - x3813 * x3855;
  const Real x3885 = 0.8 + x3725 - x3742 * x3853;
  const Real x3888 = x3772 - x3742 * x3854;
  const Real x3891 = x3775 - x3742 * x3855;
  const Real x3894 = 0.8 + x3785 - x3752 * x3854;
  const Real x3897 = x3783 - x3752 * x3855;
  const Real x3903 = tau[19] - 0.05 * x3824 + x1411 - x3806 * x3849;
  const Real x3905 = x1413 + x3832 + x3813 * x3849;
  // joint 14 "waist_roll": articulated-body inertia and bias force through it
  const Real x3843 = x145 * 0.8 + x168 * 0.016 + x3735;
  // joint 13 "waist_yaw": articulated-body inertia and bias force through it
  const Real x3907 = x3843 + x3742 * x3849;
  // joint 14 "waist_roll": articulated-body inertia and bias force through it
  const Real x3844 = x149 * 0.8 + x162 * 0.016 + x3824;
  // joint 13 "waist_yaw": articulated-body inertia and bias force through it
  const Real x3909 = x3844 + x3752 * x3849;
  // joint 14 "waist_roll": articulated-body inertia and bias force through it
  const Real x3845 = x3827 - (x141 * 0.8 + x164 * 0.016);
  // joint 13 "waist_yaw": articulated-body inertia and bias force through it
  const Real x3924 = cosine[24] * (x3864 - x3879) - sine[24] * (x3867 + x3876);
  const Real x3925 = sine[24] * x3924;
  const Real x3927 = x3867 + x3925;
  const Real x3928 = x3876 + x3925;
  const Real x3929 = cosine[24] * x3924;
  const Real x3931 = x3864 - x3929;
  const Real x3934 = 2.0 * sine[24];
  const Real x3938 = cosine[24] * (x3858 - x3873) - x3861 * x3934;
  const Real x3942 = cosine[24] * x3938;
  const Real x3948 = cosine[24] * x3891 - sine[24] * x3897;
  const Real x3951 = sine[24] * x3891 + cosine[24] * x3897;
  const Real x3956 = cosine[24] * (x3885 - x3894) - x3888 * x3934;
  const Real x3959 = x3888 + sine[24] * x3956;
  const Real x3960 = cosine[24] * x3956;
  const Real x3961 = x3894 + x3960;
  const Real x3962 = x3885 - x3960;
  const Real x3963 = 0.09 * x3959;
  const Real x3965 = x3879 + x3929 - x3963;
  const Real x3967 = x3928 + 0.09 * x3961;
  const Real x3970 = x3927 - 0.09 * x3962;
  const Real x3986 = x3861 + sine[24] * x3938 - 0.09 * x3931;
  const Real x4002 = cosine[24] * x3907 - sine[24] * x3909;
  const Real x4005 = sine[24] * x3907 + cosine[24] * x3909;
  const Real x3982 = x3873 + x3942 - 0.09 * x3927 - 0.09 * x3970;
  const Real x4011 = x2965[0] + x2965[1] + 0.034926700000000005 + x3982;
  require_more(w, x4011, 0.0, kFactorization, 0);
  const Real x4012 = x2977[0] + x2977[1] + (0.09 * x3965 + x3986);
  const Real x4013 = x2911[0] + x2911[1] + x3965;
  const Real x4014 = x2929[0] + x2929[1] + -0.12400000000000001 + x3970;
  const Real x3974 = cosine[24] * x3870 - sine[24] * x3882 - 0.09 * x3951;
  const Real x4015 = x2944[0] + x2944[1] + x3974;
  const Real x3991 = x3858 - x3942 + 0.09 * x3928 + 0.09 * x3967;
  const Real x4016 = x2999[0] + x2999[1] + 0.0200467 + x3991;
  const Real x3976 = sine[24] * x3870 + cosine[24] * x3882 + 0.09 * x3948;
  const Real x4020 = x2886[0] + x2886[1] + 6.2 + x3961;
  const Real x4023 = x2905[0] + x2905[1] + 6.2 + x3962;
  const Real x3900 = x3710 - x3784 + 0.8 - x3755 * x3855;
  const Real x4025 = x2906[0] + x2906[1] + 6.2 + x3900;
  const Real x4008 = cosine[24] * x3903 - sine[24] * x3905 - 0.09 * x4005;
  const Real x4026 = x118 * 0.015086599999999999 - tau[3] + (x3057[0] + x3057[1]) + x4008;
  const Real x4010 = sine[24] * x3903 + cosine[24] * x3905 + 0.09 * x4002;
  // joints 1 "left_hip_pitch", 7 "right_hip_pitch", 16 "left_shoulder_pitch", 24 "right_shoulder_pitch": articulated-body inertia and bias force through them
  const Real x3246 = x3068[0] + x3068[1] - (v[3] * v[4] * 0.01488 + tau[5]);
  const Real x3249 = x3052[0] + x3052[1] - (x119 * 0.12400000000000001 + tau[2]);
  const Real x3117 = x2987[0] + x2987[1];
  const Real x3142 = x3024[0] + x3024[1] + 0.0351333;
  // link 1 "pelvis": acceleration from its articulated-body inertia
  const Real x4032 = 1 / x4011;
  const Real x4033 = x4012 * x4032;
  const Real x4034 = x3117 * x4032;
  const Real x4035 = x4013 * x4032;
  const Real x4036 = x4014 * x4032;
  const Real x4037 = x4015 * x4032;
  const Real x4040 = x4016 - x4012 * x4033;
  const Real x4043 = x3011[0] + x3011[1] - x3117 * x4033;
  const Real x4046 = 0.12400000000000001 - (x2918[0] + x2918[1]) + x3967 - x4013 * x4033;
  const Real x4049 = x2933[0] + x2933[1] + (x3931 + x3963) - x4014 * x4033;
  const Real x4052 = x3976 - (x2951[0] + x2951[1]) - x4015 * x4033;
  const Real x4053 = 1 / x4040;
  const Real x4054 = x4043 * x4053;
  const Real x4055 = x4046 * x4053;
  const Real x4056 = x4049 * x4053;
  const Real x4057 = x4052 * x4053;
  const Real x4063 = x3142 - x3117 * x4034 - x4043 * x4054;
  const Real x4069 = x2924[0] + x2924[1] - x4013 * x4034 - x4046 * x4054;
  const Real x4075 = x2939[0] + x2939[1] - x4014 * x4034 - x4049 * x4054;
  const Real x4081 = x2955[0] + x2955[1] - x4015 * x4034 - x4052 * x4054;
  const Real x4082 = 1 / x4063;
  const Real x4083 = x4069 * x4082;
  const Real x4084 = x4075 * x4082;
  const Real x4085 = x4081 * x4082;
  const Real x4093 = x4020 - x4013 * x4035 - x4046 * x4055;
  const Real x4094 = x4093 - x4069 * x4083;
  const Real x4101 = x2890[0] + x2890[1] + x3959 - x4014 * x4035;
  const Real x4103 = x4101 - x4049 * x4055 - x4075 * x4083;
  const Real x4110 = x2893[0] + x2893[1] + x3948 - x4015 * x4035;
  const Real x4112 = x4110 - x4052 * x4055 - x4081 * x4083;
  const Real x4113 = 1 / x4094;
  const Real x4114 = x4103 * x4113;
  const Real x4115 = x4112 * x4113;
  const Real x4125 = x4023 - x4014 * x4036 - x4049 * x4056;
  const Real x4127 = x4125 - x4075 * x4084 - x4103 * x4114;
  const Real x4136 = x2902[0] + x2902[1] + x3951 - x4015 * x4036;
  const Real x4138 = x4136 - x4052 * x4056 - x4081 * x4084;
  const Real x4139 = x4138 - x4112 * x4114;
  const Real x4140 = 1 / x4127;
  const Real x4141 = x4139 * x4140;
  const Real x4153 = x4025 - x4015 * x4037 - x4052 * x4057;
  const Real x4155 = x4153 - x4081 * x4085 - x4112 * x4115;
  const Real x4156 = x4155 - x4139 * x4141;
  const Real x4159 = x4016 * 1.7763568394002505e-15;
  require_more(w, x4040, x4159, kFactorization, 0);
  const Real x4160 = x3142 * 1.7763568394002505e-15;
  require_more(w, x4063, x4160, kFactorization, 0);
  const Real x4161 = x4020 * 1.7763568394002505e-15;
  require_more(w, x4094, x4161, kFactorization, 0);
  const Real x4162 = x4023 * 1.7763568394002505e-15;
  require_more(w, x4127, x4162, kFactorization, 0);
  const Real x4163 = x4025 * 1.7763568394002505e-15;
  require_more(w, x4156, x4163, kFactorization, 0);
  // joint 13 "waist_yaw": articulated-body inertia and bias force through it
  const Real x4027 = x3063[0] + x3063[1] - (x121 * 0.00020659999999999716 + tau[4]) + x4010;
  // link 1 "pelvis": acceleration from its articulated-body inertia
  const Real x4172 = x4026 * x4033 - x4027;
  const Real x4178 = x4026 * x4034 - (x3246 + tau[18]) - x4054 * x4172;
  // joint 13 "waist_yaw": articulated-body inertia and bias force through it
  const Real x4029 = x121 * 0.12400000000000001 - tau[0] + (x3045[0] + x3045[1]) + x4002;
  // link 1 "pelvis": acceleration from its articulated-body inertia
  const Real x4186 = x4026 * x4035 - x4029 - x4055 * x4172;
  const Real x4187 = x4186 - x4083 * x4178;
  // joint 13 "waist_yaw": articulated-body inertia and bias force through it
  const Real x4030 = x118 * 0.12400000000000001 - tau[1] + (x3049[0] + x3049[1]) + x4005;
  // link 1 "pelvis": acceleration from its articulated-body inertia
  const Real x4197 = x4026 * x4036 - x4030 - x4056 * x4172;
  const Real x4199 = x4197 - x4084 * x4178 - x4114 * x4187;
  const Real x4210 = x4026 * x4037 - (x3845 + x3755 * x3849 + x3249);
  const Real x4212 = x4210 - x4057 * x4172 - x4085 * x4178;
  const Real x4221 = 1 / x4156 * (x4212 - x4115 * x4187 - x4141 * x4199);
  const Real x4224 = x4140 * x4199 - x4141 * x4221;
  const Real x4230 = x4113 * x4187 - x4115 * x4221 - x4114 * x4224;
  const Real x4238 = x4082 * x4178 - x4085 * x4221 - x4084 * x4224;
  const Real x4239 = x4238 - x4083 * x4230;
  w.result[5] = x4239;
  const Real x4249 = x4053 * x4172 - x4057 * x4221 - x4056 * x4224;
  const Real x4251 = x4249 - x4055 * x4230 - x4054 * x4239;
  w.result[4] = x4251;
  const Real x4264 = x4026 * x4032 + x4037 * x4221 + x4036 * x4224;
  const Real x4268 = x4035 * x4230 + x4264 + x4034 * x4239;
  const Real x4270 = x4033 * x4251 + x4268;
  const Real x4271 = -x4270;
  w.result[3] = x4271;
  // joint 13 "waist_yaw": its acceleration, and that of the link beyond
  const Real x4281 = sine[24] * x4251 - cosine[24] * x4270;
  const Real x4285 = sine[24] * x4270 + cosine[24] * x4251;
  const Real x4304 = x3849 - x3855 * x4221 + x3850 * x4281;
  const Real x4274 = x4230 + 0.09 * x4251;
  const Real x4277 = x4224 + 0.09 * x4270;
  const Real x4288 = cosine[24] * x4274 + sine[24] * x4277;
  const Real x4292 = cosine[24] * x4277 - sine[24] * x4274;
  const Real x4306 = x4304 - x3852 * x4285 - x3853 * x4288;
  const Real x4307 = x4306 - x3854 * x4292;
  // joint 14 "waist_roll": its acceleration, and that of the link beyond
  const Real x4321 = cosine[25] * x4307 - sine[25] * x4285;
  const Real x4311 = x4288 + 0.05 * x4285;
  const Real x4314 = x4292 - 0.05 * x4281;
  const Real x4324 = cosine[25] * x4314 + sine[25] * x4221;
  const Real x4328 = cosine[25] * x4221 - sine[25] * x4314;
  const Real x4340 = x3675 - x3680 * x4311 - x3678 * x4324;
  const Real x4317 = cosine[25] * x4285 + sine[25] * x4307;
  const Real x4342 = x4340 - x3679 * x4328 - x3676 * x4317;
  const Real x4343 = x4342 - x3677 * x4321;
  // joint 15 "waist_pitch": its acceleration, and that of the link beyond
  const Real x4353 = cosine[26] * x4321 + sine[26] * x4343;
  // joints 1 "left_hip_pitch", 7 "right_hip_pitch", 16 "left_shoulder_pitch", 24 "right_shoulder_pitch": their accelerations, and those of the links beyond
  const Four x4381 = Four{x4271, x4271, x4353, x4353};
  // joint 15 "waist_pitch": its acceleration, and that of the link beyond
  const Real x4357 = cosine[26] * x4343 - sine[26] * x4321;
  // joints 1 "left_hip_pitch", 7 "right_hip_pitch", 16 "left_shoulder_pitch", 24 "right_shoulder_pitch": their accelerations, and those of the links beyond
  const Four x4382 = Four{x4251, x4251, x4357, x4357};
  // joint 15 "waist_pitch": its acceleration, and that of the link beyond
  const Real x4350 = x4311 + 0.04 * x4317;
  const Real x4360 = cosine[26] * x4328 + sine[26] * x4350;
  const Real x4364 = cosine[26] * x4350 - sine[26] * x4328;
  const Real x4376 = x3499 - x3502 * x4360 - x3503 * x4364;
  const Real x4347 = x4324 - 0.04 * x4343;
  const Real x4378 = x4376 - x3500 * x4353 - x3501 * x4357;
  const Real x4379 = x4378 - x3504 * x4347;
  // joints 1 "left_hip_pitch", 7 "right_hip_pitch", 16 "left_shoulder_pitch", 24 "right_shoulder_pitch": their accelerations, and those of the links beyond
  const Four x4383 = Four{x4239, x4239, x4379, x4379};
  const Four x4394 = Four{x4230, x4230, x4360, x4360} - Four{0.05, 0.05, -0.15, 0.15} * x4382 - Four{0.09, -0.09, 0.0, 0.0} * x4383;
  const Four x4399 = Four{x4224, x4224, x4364, x4364} + Four{0.05, 0.05, -0.15, 0.15} * x4381 + Four{0.0, 0.0, 0.29, 0.29} * x4383;
  const Four x4405 = Four{x4221, x4221, x4347, x4347} - Four{0.0, 0.0, 0.29, 0.29} * x4382 + Four{0.09, -0.09, 0.0, 0.0} * x4381;
  const Four x4412 = Four{1.0, 1.0, 0.0, 0.0} * x4383 - Four{0.0, 0.0, 1.0, 1.0} * x4382;
  const Four x4415 = load<Four>(cosine + 0) * x4412 + load<Four>(sine + 0) * x4381;
  const Four x4419 = load<Four>(cosine + 0) * x4381 - load<Four>(sine + 0) * x4412;
  const Four x4422 = Four{1.0, 1.0, 0.0, 0.0} * x4399 + Four{0.0, 0.0, 1.0, 1.0} * x4405;
  const Four x4426 = Four{1.0, 1.0, 0.0, 0.0} * x4405 - Four{0.0, 0.0, 1.0, 1.0} * x4399;
  const Four x4429 = load<Four>(cosine + 0) * x4426 + load<Four>(sine + 0) * x4394;
  const Four x4433 = load<Four>(cosine + 0) * x4394 - load<Four>(sine + 0) * x4426;
  const Four x4445 = x2742 - x2743 * x4415 - x2744 * x4419;
  const Four x4447 = x4445 - x2747 * x4422 - x2745 * x4429;
  const Four x4448 = x4447 - x2746 * x4433;
  const Four x4449 = x4448 - (Four{1.0, 1.0, 0.0, 0.0} * x4382 + Four{0.0, 0.0, 1.0, 1.0} * x4383);
  put(x4449, w.lanes.data() + 0);
  // joints 2 "left_hip_roll", 8 "right_hip_roll", 17 "left_shoulder_roll", 25 "right_shoulder_roll": their accelerations, and those of the links beyond
  const Four x4457 = x4429 + Four{0.04, -0.04, 0.05, -0.05} * x4419;
  const Four x4460 = x4433 - Four{0.04, -0.04, 0.05, -0.05} * x4415;
  const Four x4463 = Four{1.0, 1.0, 0.0, 0.0} * x4415 + Four{0.0, 0.0, 1.0, 1.0} * x4419;
  const Four x4470 = load<Four>(cosine + 4) * x4448 + load<Four>(sine + 4) * x4463;
  const Four x4474 = load<Four>(cosine + 4) * x4463 - load<Four>(sine + 4) * x4448;
  const Four x4477 = Four{1.0, 1.0, 0.0, 0.0} * x4457 + Four{0.0, 0.0, 1.0, 1.0} * x4460;
  const Four x4481 = Four{1.0, 1.0, 0.0, 0.0} * x4460 - Four{0.0, 0.0, 1.0, 1.0} * x4457;
  const Four x4484 = load<Four>(cosine + 4) * x4422 + load<Four>(sine + 4) * x4477;
  const Four x4488 = load<Four>(cosine + 4) * x4477 - load<Four>(sine + 4) * x4422;
  const Four x4500 = x2494 - x2499 * x4481 - x2497 * x4484;
  const Four x4502 = x4500 - x2498 * x4488 - x2495 * x4470;
  const Four x4503 = x4502 - x2496 * x4474;
  const Four x4504 = x4503 - (Four{1.0, 1.0, 0.0, 0.0} * x4419 - Four{0.0, 0.0, 1.0, 1.0} * x4415);
  put(x4504, w.lanes.data() + 4);
  // joints 3 "left_hip_yaw", 9 "right_hip_yaw", 18 "left_shoulder_yaw", 26 "right_shoulder_yaw": their accelerations, and those of the links beyond
  const Four x4510 = x4484 + Four{0.12, 0.12, 0.1, 0.1} * x4503;
  const Four x4513 = x4481 - Four{0.12, 0.12, 0.1, 0.1} * x4470;
  const Four x4516 = load<Four>(cosine + 8) * x4503 + load<Four>(sine + 8) * x4470;
  const Four x4520 = load<Four>(cosine + 8) * x4470 - load<Four>(sine + 8) * x4503;
  const Four x4523 = load<Four>(cosine + 8) * x4513 + load<Four>(sine + 8) * x4510;
  const Four x4527 = load<Four>(cosine + 8) * x4510 - load<Four>(sine + 8) * x4513;
  const Four x4539 = x2304 - x2310 * x4488 - x2305 * x4516;
  const Four x4541 = x2306 * x4520 + x4539 - x2308 * x4523;
  const Four x4542 = x4541 - x2309 * x4527;
  const Four x4543 = x4542 - x4474;
  put(x4543, w.lanes.data() + 8);
  // joints 4 "left_knee", 10 "right_knee", 19 "left_elbow", 27 "right_elbow": their accelerations, and those of the links beyond
  const Four x4550 = x4523 - Four{0.24, 0.24, 0.11, 0.11} * x4520;
  const Four x4552 = x4527 + Four{0.24, 0.24, 0.11, 0.11} * x4516;
  const Four x4555 = x592 * x4542 + x597 * x4516;
  const Four x4559 = x592 * x4516 - x597 * x4542;
  const Four x4562 = x592 * x4488 + x597 * x4550;
  const Four x4566 = x592 * x4550 - x597 * x4488;
  const Four x4578 = x2121 + x2126 * x4552 - x2124 * x4562;
  const Four x4580 = x4578 - x2125 * x4566 - x2122 * x4555;
  const Four x4581 = x4580 - x2123 * x4559;
  const Four x4582 = x4581 - x4520;
  put(x4582, w.lanes.data() + 12);
  // joints 5 "left_ankle_pitch", 11 "right_ankle_pitch", 20 "left_wrist_roll", 28 "right_wrist_roll": their accelerations, and those of the links beyond
  const Four x4590 = x4562 - Four{0.0, 0.0, 0.16, 0.16} * x4581;
  const Four x4593 = x4566 - Four{0.3, 0.3, -0.01, -0.01} * x4581;
  const Four x4598 = x4552 + Four{0.3, 0.3, -0.01, -0.01} * x4559 + Four{0.0, 0.0, 0.16, 0.16} * x4555;
  const Four x4601 = Four{1.0, 1.0, 0.0, 0.0} * x4559 + Four{0.0, 0.0, 1.0, 1.0} * x4581;
  const Four x4608 = load<Four>(cosine + 16) * x4555 + load<Four>(sine + 16) * x4601;
  const Four x4612 = load<Four>(cosine + 16) * x4601 - load<Four>(sine + 16) * x4555;
  const Four x4615 = Four{1.0, 1.0, 0.0, 0.0} * x4593 + Four{0.0, 0.0, 1.0, 1.0} * x4598;
  const Four x4619 = Four{1.0, 1.0, 0.0, 0.0} * x4598 - Four{0.0, 0.0, 1.0, 1.0} * x4593;
  const Four x4622 = load<Four>(cosine + 16) * x4590 + load<Four>(sine + 16) * x4615;
  const Four x4638 = x1812 - x1813 * x4608 - x1814 * x4612;
  const Four x4640 = x4638 - x1817 * x4619 - x1815 * x4622;
  const Four x4641 = x4640 - x1816 * (load<Four>(cosine + 16) * x4615 - load<Four>(sine + 16) * x4590);
  const Four x4642 = x4641 - (Four{1.0, 1.0, 0.0, 0.0} * x4581 - Four{0.0, 0.0, 1.0, 1.0} * x4559);
  put(x4642, w.lanes.data() + 16);
  // joints 6 "left_ankle_roll", 12 "right_ankle_roll", 21 "left_wrist_pitch", 29 "right_wrist_pitch": their accelerations, and those of the links beyond
  const Four x4649 = x4622 - Four{0.0, 0.0, 0.04, 0.04} * x4612;
  const Four x4656 = x4619 + Four{0.02, 0.02, 0.0, 0.0} * x4612;
  const Four x4678 = x1656 - Four{19.88949726809468, 19.88949726809468, 0.0, 0.0} * (load<Four>(cosine + 20) * x4656 + load<Four>(sine + 20) * x4649);
  const Four x4679 = (load<Four>(cosine + 20) * x4649 - load<Four>(sine + 20) * x4656) * Four{0.0, 0.0, 11.980035271220512, 11.980035271220512} + x4678;
  const Four x4680 = x4679 - Four{0.5966849180428403, 0.5966849180428403, 0.0, 0.0} * (load<Four>(cosine + 20) * x4608 - load<Four>(sine + 20) * x4641);
  const Four x4681 = x4680 - x4612;
  put(x4681, w.lanes.data() + 20);
  // joint 13 "waist_yaw": its acceleration, and that of the link beyond
  const Real x4308 = x4307 - x4239;
  w.result[18] = x4308;
  // joint 14 "waist_roll": its acceleration, and that of the link beyond
  const Real x4344 = x4343 - x4281;
  w.result[19] = x4344;
  // joint 15 "waist_pitch": its acceleration, and that of the link beyond
  const Real x4380 = x4379 - x4317;
  w.result[20] = x4380;
  // joint 22 "neck_yaw": its acceleration, and that of the link beyond
  const Real x4689 = x4364 + 0.38 * x4379;
  const Real x4692 = x4347 - 0.38 * x4357;
  const Real x4699 = cosine[27] * x4379 - sine[27] * x4357;
  const Real x4711 = x3378 - x3379 * (cosine[27] * x4357 + sine[27] * x4379);
  const Real x4712 = x4711 - x3380 * (cosine[27] * x4692 - sine[27] * x4689);
  const Real x4713 = x4712 - x4353;
  w.result[27] = x4713;
  // joint 23 "neck_pitch": its acceleration, and that of the link beyond
  const Real x4716 = cosine[27] * x4689 + sine[27] * x4692 + 0.06 * x4699;
  const Real x4739 = x3277 + (cosine[28] * x4360 + sine[28] * x4716) * 1.7035775127768316;
  const Real x4740 = x4739 - 7.666098807495741 * (cosine[28] * x4716 - sine[28] * x4360);
  const Real x4741 = x4740 - x4699;
  w.result[28] = x4741;
  // joint 0 "__base__": acceleration of the base
  const Real x4742 = x4230 - (v[2] * v[4] - v[1] * v[5] + x92);
  w.result[0] = x4742;
  const Real x4743 = x4224 - (v[0] * v[5] - v[2] * v[3] + x93);
  w.result[1] = x4743;
  const Real x4744 = x4221 - (v[1] * v[3] - v[0] * v[4] + x94);
  w.result[2] = x4744;
}

// ---- processes ----------------------------------------------------------------------------------

// Process 0: 30 of 30 joints: "__base__", "left_hip_pitch", "left_hip_roll", "left_hip_yaw", "left_knee", "left_ankle_pitch", ...
constexpr std::array<int, 30> kRead_0{0, 1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12, 13, 14, 15, 16, 17, 18, 19, 20, 21, 22, 23, 24, 25, 26, 27, 28, 29};
constexpr std::array<int, 30> kOwned_0{0, 1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12, 13, 14, 15, 16, 17, 18, 19, 20, 21, 22, 23, 24, 25, 26, 27, 28, 29};
constexpr std::array<int, 29> kAngles_0{7, 13, 22, 30, 8, 14, 23, 31, 9, 15, 24, 32, 10, 16, 25, 33, 11, 17, 26, 34, 12, 18, 27, 35, 19, 20, 21, 28, 29};

ADAGEN_AS_IT_STANDS void run_0([[maybe_unused]] Workspace& w, [[maybe_unused]] Channel& channel) {
  ADAGEN_INPUTS
  if (!all(unlike_zero(q + 0, 3) == 0))
    name_what_is_not_finite(w, kRead_0, kOwned_0);
  take_sines_and_cosines(q, kAngles_0, w.sine.data(), w.cosine.data());
  part_0_0(w);
  stamp(1);
  stamp(2);
  stamp(3);
  if (__builtin_expect(w.status != kFine || !all(unlike_zero(w.result.data() + 0, 6) + unlike_zero(w.result.data() + 18, 3) + unlike_zero(w.result.data() + 27, 2) + unlike_zero<Four, 6>(w.lanes.data() + 0) == 0), 0)) {
    w.result[6] = w.lanes[0];
    w.result[7] = w.lanes[4];
    w.result[8] = w.lanes[8];
    w.result[9] = w.lanes[12];
    w.result[10] = w.lanes[16];
    w.result[11] = w.lanes[20];
    w.result[12] = w.lanes[1];
    w.result[13] = w.lanes[5];
    w.result[14] = w.lanes[9];
    w.result[15] = w.lanes[13];
    w.result[16] = w.lanes[17];
    w.result[17] = w.lanes[21];
    w.result[21] = w.lanes[2];
    w.result[22] = w.lanes[6];
    w.result[23] = w.lanes[10];
    w.result[24] = w.lanes[14];
    w.result[25] = w.lanes[18];
    w.result[26] = w.lanes[22];
    w.result[29] = w.lanes[3];
    w.result[30] = w.lanes[7];
    w.result[31] = w.lanes[11];
    w.result[32] = w.lanes[15];
    w.result[33] = w.lanes[19];
    w.result[34] = w.lanes[23];
    find_fault(w, kRead_0, kOwned_0);
  }
  if (w.status != kFine) return;
  std::copy_n(w.result.data() + 0, 6, w.qdd + 0);
  std::copy_n(w.result.data() + 18, 3, w.qdd + 18);
  std::copy_n(w.result.data() + 27, 2, w.qdd + 27);
  w.qdd[6] = w.lanes[0];
  w.qdd[7] = w.lanes[4];
  w.qdd[8] = w.lanes[8];
  w.qdd[9] = w.lanes[12];
  w.qdd[10] = w.lanes[16];
  w.qdd[11] = w.lanes[20];
  w.qdd[12] = w.lanes[1];
  w.qdd[13] = w.lanes[5];
  w.qdd[14] = w.lanes[9];
  w.qdd[15] = w.lanes[13];
  w.qdd[16] = w.lanes[17];
  w.qdd[17] = w.lanes[21];
  w.qdd[21] = w.lanes[2];
  w.qdd[22] = w.lanes[6];
  w.qdd[23] = w.lanes[10];
  w.qdd[24] = w.lanes[14];
  w.qdd[25] = w.lanes[18];
  w.qdd[26] = w.lanes[22];
  w.qdd[29] = w.lanes[3];
  w.qdd[30] = w.lanes[7];
  w.qdd[31] = w.lanes[11];
  w.qdd[32] = w.lanes[15];
  w.qdd[33] = w.lanes[19];
  w.qdd[34] = w.lanes[23];
}


}  // namespace

[[maybe_unused]] constexpr std::array<StageInfo, 3> kStages_0{ {{"kinematics", 29, -1}, {"assembly", 1, -1}, {"disassembly", 1, -1}} };

#include "adagen/whole_alone.hpp"
