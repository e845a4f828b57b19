// Forward dynamics of "humanoid" on 2 processes, emitted by adagen 0.1.0 (solver.cpp.j2). Do not edit: generate again. Licence: yours to choose.
// robot     "humanoid", 30 joints, 35 degrees of freedom, description sha256 d573a89307ddd4ee9018ee9a0a94422a3db0c5f61f2798648f53f0e1b57ee437
// command   adagen ../models/humanoid.urdf --floating --procs 2 --shape=kernels --batch --name=humanoid_batch
// input     profile default, sha256 fe36af9ff4727e4941af0e7182db7f87cd64c54109bc287302f720e9ad83c3a8
// options   form segment (articulated-body algorithm), shape kernels (spatial vectors [angular; linear] in the axes of the base, about each link's origin), scalar double, channel auto, floating base, gravity 0.0, 0.0, -9.81
// links     adagen_program.cpp -DADAGEN_MPI; or, compiled with -DADAGEN_NO_MAIN, a program of yours that includes humanoid_batch_p2.h
// program   1 process; 0.266 us a state predicted (default profile)
//           process 0: __base__ .. right_wrist_pitch
//
// Each SIMD lane holds a state; the processes share the states of a batch, not the robot.

#include "humanoid_batch_p2.h"
#define ADAGEN_CALL(word) humanoid_batch_p2_##word
#define ADAGEN_NAMED(WORD) HUMANOID_BATCH_P2_##WORD
#define ADAGEN_MPI
#define ADAGEN_BATCH
#include "adagen/kernels/plain_loops.hpp"

namespace { struct humanoid_batch_p2_settings : PlainLoops<30> {
  static constexpr int kVersion = 100, kJointCount = 30, kNq = 36, kNv = 35;
  [[maybe_unused]] static constexpr const char* kRobot = "humanoid";
  [[maybe_unused]] static constexpr bool kFloating = true;
  static constexpr int kProcesses = 2;
  static constexpr bool kAlone = false;
  static constexpr bool kBatch = true;
  static constexpr std::size_t kCache = 1048576;
  [[maybe_unused]] static constexpr Hops kHops = {{0, 152, 0.404}, {20.9, 192, 0.602}};
}; }  // namespace: a program may load several solvers of one name

#include "adagen/kernels/model.hpp"

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

[[maybe_unused]] constexpr std::array<MessageInfo, 0> kMessages{};

constexpr std::array<LinkInertia, kJointCount> kInertias{ {
    {6.2, {0.0, 0.0, 0.12400000000000001},
     {0.01012665, 0.0, 0.0, 0.02500665, 0.0, 0.009920050000000001}},
    {1.4, {0.0, 0.0, 0.041999999999999996},
     {0.000875, 0.0, 0.0, 0.000875, 0.0, 0.002205}},
    {1.2, {0.0, -0.048, 0.024},
     {0.00075, 0.0, 0.0, 0.00267, -0.00096, 0.00112}},
    {2.6, {0.0, 0.0, -0.26},
     {0.00234, 0.0, 0.0, 0.00234, 0.0, 0.0406467}},
    {1.8, {-0.234, 0.018000000000000002, 0.0},
     {0.042180050000000004, -0.00234, 0.0, 0.00109125, 0.0, 0.00091125}},
    {0.2, {0.0, 0.0, 0.0},
     {3.6e-05, 0.0, 0.0, 3.6e-05, 0.0, 3.6e-05}},
    {0.8, {0.0, -0.024, 0.024},
     {0.0004266635, 0.0, 0.0, 0.0007800035, -0.0007199999999999999, 0.0033866665}},
    {1.4, {0.0, 0.0, -0.041999999999999996},
     {0.000875, 0.0, 0.0, 0.000875, 0.0, 0.002205}},
    {1.2, {0.0, -0.048, 0.024},
     {0.00075, 0.0, 0.0, 0.00267, -0.00096, 0.00112}},
    {2.6, {0.0, 0.0, -0.26},
     {0.00234, 0.0, 0.0, 0.00234, 0.0, 0.0406467}},
    {1.8, {-0.234, 0.018000000000000002, 0.0},
     {0.042180050000000004, -0.00234, 0.0, 0.00109125, 0.0, 0.00091125}},
    {0.2, {0.0, 0.0, 0.0},
     {3.6e-05, 0.0, 0.0, 3.6e-05, 0.0, 3.6e-05}},
    {0.8, {0.0, -0.024, 0.024},
     {0.0004266635, 0.0, 0.0, 0.0007800035, -0.0007199999999999999, 0.0033866665}},
    {0.8, {0.0, 0.0, 0.016},
     {0.0005, 0.0, 0.0, 0.0005, 0.0, 0.0005600000000000001}},
    {0.9, {0.0, 0.018000000000000002, 0.0},
     {0.0005625, 0.0, 0.0, 0.0008400000000000001, 0.0, 0.0005625}},
    {9.5, {1.6150000000000002, 0.095, 0.0},
     {0.36606635000000004, 0.01615, 0.0, 0.021216649999999997, 0.0, 0.06206665}},
    {0.8, {0.0, 0.0, 0.024},
     {0.00032, 0.0, 0.0, 0.00032, 0.0, 0.0010466669999999998}},
    {0.7, {0.006999999999999999, -0.020999999999999998, 0.0},
     {0.00042, -0.00020999999999999998, 0.0, 0.00098, 0.0, 0.00035}},
    {0.8, {0.0, 0.0, -0.04000000000000001},
     {0.00032, 0.0, 0.0, 0.00032, 0.0, 0.0033066700000000003}},
    {0.7, {-0.049, 0.013999999999999999, 0.0},
     {0.004923335000000001, -0.00098, 0.0, 0.000494375, 0.0, 0.000214375}},
    {0.2, {0.0, 0.0, -0.002},
     {4.5e-05, 0.0, 0.0, 4.5e-05, 0.0, 6.16667e-05}},
    {0.4, {-0.024, 0.0, 0.0},
     {0.0019199994999999999, 0.0, 0.0, 8.33335e-05, 0.0, 0.00021333350000000002}},
    {0.4, {0.0, 0.0, 0.008},
     {9e-05, 0.0, 0.0, 9e-05, 0.0, 0.00028000000000000003}},
    {2.4, {0.216, 0.048, 0.0},
     {0.023327999999999998, 0.00432, 0.0, 0.004848, 0.0, 0.003888}},
    {0.8, {0.0, 0.0, -0.024},
     {0.00032, 0.0, 0.0, 0.00032, 0.0, 0.0010466669999999998}},
    {0.7, {-0.006999999999999999, -0.020999999999999998, 0.0},
     {0.00042, 0.00020999999999999998, 0.0, 0.00098, 0.0, 0.00035}},
    {0.8, {0.0, 0.0, -0.04000000000000001},
     {0.00032, 0.0, 0.0, 0.00032, 0.0, 0.0033066700000000003}},
    {0.7, {-0.049, 0.013999999999999999, 0.0},
     {0.004923335000000001, -0.00098, 0.0, 0.000494375, 0.0, 0.000214375}},
    {0.2, {0.0, 0.0, -0.002},
     {4.5e-05, 0.0, 0.0, 4.5e-05, 0.0, 6.16667e-05}},
    {0.4, {-0.024, 0.0, 0.0},
     {0.0019199994999999999, 0.0, 0.0, 8.33335e-05, 0.0, 0.00021333350000000002}}}};

constexpr LinkRole kRoles[1][kLinkCount]{{{0, 0, 0, 0}, {1, 1, 1, 0}, {0, 1, 0, 0}, {0, 1, 0, 0}, {0, 1, 0, 0}, {0, 1, 0, 0}, {0, 1, 0, 0}, {0, 1, 0, 0}, {0, 1, 0, 0}, {0, 1, 0, 0}, {0, 1, 0, 0}, {0, 1, 0, 0}, {0, 1, 0, 0}, {0, 1, 0, 0}, {0, 1, 0, 0}, {0, 1, 0, 0}, {1, 1, 1, 0}, {0, 1, 0, 0}, {0, 1, 0, 0}, {0, 1, 0, 0}, {0, 1, 0, 0}, {0, 1, 0, 0}, {0, 1, 0, 0}, {0, 1, 0, 0}, {0, 1, 0, 0}, {0, 1, 0, 0}, {0, 1, 0, 0}, {0, 1, 0, 0}, {0, 1, 0, 0}, {0, 1, 0, 0}, {0, 1, 0, 0}}};

// ---- functions ----------------------------------------------------------------------------------

#include "adagen/channel.hpp"
#include "adagen/kernels/plain_sweeps.hpp"

// ---- processes ----------------------------------------------------------------------------------

// Each process: 30 of 30 joints: "__base__", "left_hip_pitch", "left_hip_roll", "left_hip_yaw", "left_knee", "left_ankle_pitch", ...
static void run_0([[maybe_unused]] Workspace& w) {
  require_finite(w, w.q, 0, 3, &JointConstants::q, kNotFinite);
  std::copy_n(w.q + 7, 29, w.angle.data() + 1);
  turn<block(1), block(29) + 1>(w);
  free_base_frame<0>(w);
  outward<1, 6>(w);  // "left_hip_pitch" .. "left_ankle_roll"
  outward<7, 12>(w);  // "right_hip_pitch" .. "right_ankle_roll"
  outward<13, 21>(w);  // "waist_yaw" .. "left_wrist_pitch"
  outward<22, 23>(w);  // "neck_yaw" .. "neck_pitch"
  outward<24, 29>(w);  // "right_shoulder_pitch" .. "right_wrist_pitch"
  stamp(1);
  set_up_links<block(0), block(29) + 1>(w);
  free_base<0, true>(w);
  inward<0, 24, 29, true>(w);  // "right_shoulder_pitch" .. "right_wrist_pitch"
  inward<0, 22, 23, false>(w);  // "neck_yaw" .. "neck_pitch"
  inward<0, 13, 21, false>(w);  // "waist_yaw" .. "left_wrist_pitch"
  inward<0, 7, 12, false>(w);  // "right_hip_pitch" .. "right_ankle_roll"
  inward<0, 1, 6, false>(w);  // "left_hip_pitch" .. "left_ankle_roll"
  solve_root<0, 1>(w);
  stamp(2);
  accelerate<0, 1, 6>(w);  // "left_hip_pitch" .. "left_ankle_roll"
  accelerate<0, 7, 12>(w);  // "right_hip_pitch" .. "right_ankle_roll"
  accelerate<0, 13, 21>(w);  // "waist_yaw" .. "left_wrist_pitch"
  accelerate<0, 22, 23>(w);  // "neck_yaw" .. "neck_pitch"
  accelerate<0, 24, 29>(w);  // "right_shoulder_pitch" .. "right_wrist_pitch"
  free_acceleration<0>(w);
  stamp(3);
  if (!went_well(w, 0, 35)) find_fault(w, {{0, 36}}, {{0, 35}}, {{0, 35}}, {{0, 35}});
  give(w, 0, 35);
}

constexpr std::array kParts{run_0};  // what is done for a group of states, in order
[[maybe_unused]] constexpr std::array<StageInfo, 3> kStages_0{ {{"kinematics", 29, -1}, {"assembly", 1, -1}, {"disassembly", 1, -1}} };

constexpr std::array<Range, 4> kRanges_0{ {{0, 36}, {0, 35}, {0, 35}, {0, 35}} };
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
