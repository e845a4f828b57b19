// Forward dynamics of "human40" on 1 process, emitted by adagen 0.1.0 (solver.cpp.j2). Do not edit: generate again. Licence: yours to choose.
// robot     "human40", 15 joints, 40 degrees of freedom, description sha256 bdc16488e5ef4610f46ad114b2f2b09a8601d7b212cf0d9aa1794a195cd4ce35
// command   adagen ../models/human40.urdf --procs 1 --shape=joints --form=ada
// input     profile default, sha256 fe36af9ff4727e4941af0e7182db7f87cd64c54109bc287302f720e9ad83c3a8
// options   form ada (assembly-disassembly algorithm), shape joints (spatial vectors [angular; linear] in link frames whose joint axes are z), scalar double, channel auto, fixed base, gravity 0.0, 0.0, -9.81
// needs     Eigen's headers
// links     adagen_program.cpp; or, compiled with -DADAGEN_NO_MAIN, a program of yours that includes human40_p1.h
// program   1 process; 2.45 us predicted (default profile)
//           process 0: root .. right_wrist
//
// Assembly-disassembly algorithm of Yamane and Nakamura. Phi are inverse articulated-body inertias, b
// bias accelerations. Joint i joins chain A (its parent link's side) and chain B (its child link's side)
// to chain C: assembly, Eq. (3)-(7), goes up the schedule, disassembly, Eq. (8)-(10), comes down.

#include "human40_p1.h"
#define ADAGEN_CALL(word) human40_p1_##word
#define ADAGEN_NAMED(WORD) HUMAN40_P1_##WORD
#include "adagen/settings.hpp"

namespace { struct human40_p1_settings : PlainSettings {
  static constexpr int kVersion = 100, kJointCount = 15, kNq = 51, kNv = 40;
  [[maybe_unused]] static constexpr const char* kRobot = "human40";
}; }  // namespace: a program may load several solvers of one name

#include "adagen/constants.hpp"

constexpr std::array<LinkConstants, kLinkCount> kLinks{ {
    {"world", 0.0, {0.0, 0.0, 0.0}},
    {"pelvis", 9.6, {0.0, 0.0, 0.03},
     {0.104, 0.0, 0.0, 0.0, 0.05248, 0.0, 0.0, 0.0, 0.09248},
     {9.615384615384615, 0.0, 0.0, 0.0, 19.054878048780488, 0.0, 0.0, 0.0, 10.813148788927334}},
    {"left_thigh", 8.4, {0.0, 0.0, -0.19},
     {0.12544, 0.0, 0.0, 0.0, 0.12544, 0.0, 0.0, 0.0, 0.02688},
     {7.971938775510204, 0.0, 0.0, 0.0, 7.971938775510204, 0.0, 0.0, 0.0, 37.20238095238095}},
    {"left_shank", 3.2, {-0.18, 0.0, 0.0},
     {0.004, 0.0, 0.0, 0.0, 0.0446667, 0.0, 0.0, 0.0, 0.0446667},
     {250.0, 0.0, 0.0, 0.0, 22.388042993997768, 0.0, 0.0, 0.0, 22.388042993997768}},
    {"left_foot", 1.0, {0.06, 0.0, -0.04},
     {0.00108333, 0.0, 0.0, 0.0, 0.00561667, 0.0, 0.0, 0.0, 0.00588333},
     {923.0797633223488, 0.0, 0.0, 0.0, 178.04143736413212, 0.0, 0.0, 0.0, 169.97176768938678}},
    {"right_thigh", 8.4, {0.0, 0.0, -0.19},
     {0.12544, 0.0, 0.0, 0.0, 0.12544, 0.0, 0.0, 0.0, 0.02688},
     {7.971938775510204, 0.0, 0.0, 0.0, 7.971938775510204, 0.0, 0.0, 0.0, 37.20238095238095}},
    {"right_shank", 3.2, {-0.18, 0.0, 0.0},
     {0.004, 0.0, 0.0, 0.0, 0.0446667, 0.0, 0.0, 0.0, 0.0446667},
     {250.0, 0.0, 0.0, 0.0, 22.388042993997768, 0.0, 0.0, 0.0, 22.388042993997768}},
    {"right_foot", 1.0, {0.06, 0.0, -0.04},
     {0.00108333, 0.0, 0.0, 0.0, 0.00561667, 0.0, 0.0, 0.0, 0.00588333},
     {923.0797633223488, 0.0, 0.0, 0.0, 178.04143736413212, 0.0, 0.0, 0.0, 169.97176768938678}},
    {"trunk", 23.0, {0.0, 0.0, 0.23},
     {0.601833, 0.0, 0.0, 0.0, 0.467667, 0.0, 0.0, 0.0, 0.258367},
     {1.661590507665748, 0.0, 0.0, 0.0, 2.1382736006602987, 0.0, 0.0, 0.0, 3.870463333165613}},
    {"left_upper_arm", 1.9, {0.0, 0.0, -0.14},
     {0.0133752, 0.0, 0.0, 0.0, 0.0133752, 0.0, 0.0, 0.0, 0.00192375},
     {74.76523715533226, 0.0, 0.0, 0.0, 74.76523715533226, 0.0, 0.0, 0.0, 519.8180636777129}},
    {"left_forearm", 1.1, {-0.12, 0.0, 0.0},
     {0.00067375, 0.0, 0.0, 0.0, 0.00606604, 0.0, 0.0, 0.0, 0.00606604},
     {1484.2300556586272, 0.0, 0.0, 0.0, 164.852193523287, 0.0, 0.0, 0.0, 164.852193523287}},
    {"left_hand", 0.42, {0.0, 0.0, -0.08},
     {0.0012355, 0.0, 0.0, 0.0, 0.001043, 0.0, 0.0, 0.0, 0.0002555},
     {809.3889113719142, 0.0, 0.0, 0.0, 958.7727708533076, 0.0, 0.0, 0.0, 3913.894324853229}},
    {"head", 4.9, {0.01, 0.0, 0.14},
     {0.0196, 0.0, 0.0, 0.0, 0.0196, 0.0, 0.0, 0.0, 0.0196},
     {51.02040816326531, 0.0, 0.0, 0.0, 51.02040816326531, 0.0, 0.0, 0.0, 51.02040816326531}},
    {"right_upper_arm", 1.9, {0.0, 0.0, -0.14},
     {0.0133752, 0.0, 0.0, 0.0, 0.0133752, 0.0, 0.0, 0.0, 0.00192375},
     {74.76523715533226, 0.0, 0.0, 0.0, 74.76523715533226, 0.0, 0.0, 0.0, 519.8180636777129}},
    {"right_forearm", 1.1, {-0.12, 0.0, 0.0},
     {0.00067375, 0.0, 0.0, 0.0, 0.00606604, 0.0, 0.0, 0.0, 0.00606604},
     {1484.2300556586272, 0.0, 0.0, 0.0, 164.852193523287, 0.0, 0.0, 0.0, 164.852193523287}},
    {"right_hand", 0.42, {0.0, 0.0, -0.08},
     {0.0012355, 0.0, 0.0, 0.0, 0.001043, 0.0, 0.0, 0.0, 0.0002555},
     {809.3889113719142, 0.0, 0.0, 0.0, 958.7727708533076, 0.0, 0.0, 0.0, 3913.894324853229}}}};

constexpr std::array<JointConstants, kJointCount> kJoints{ {
    {"root", JointKind::kFloating, 0, 0, 7, 0, 6,
     {1.0, 0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 1.0}, {0.0, 0.0, 0.95}},
    {"left_hip", JointKind::kSpherical, 1, 7, 4, 6, 3,
     {1.0, 0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 1.0}, {0.0, 0.09, -0.04}},
    {"left_knee", JointKind::kRevolute, 2, 11, 1, 9, 1,
     {0.0, 1.0, 0.0, 0.0, 0.0, 1.0, 1.0, 0.0, 0.0}, {0.0, 0.0, -0.41}},
    {"left_ankle", JointKind::kSpherical, 3, 12, 4, 10, 3,
     {0.0, 0.0, 1.0, 1.0, 0.0, 0.0, 0.0, 1.0, 0.0}, {-0.41, 0.0, 0.0}},
    {"right_hip", JointKind::kSpherical, 1, 16, 4, 13, 3,
     {1.0, 0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 1.0}, {0.0, -0.09, -0.04}},
    {"right_knee", JointKind::kRevolute, 5, 20, 1, 16, 1,
     {0.0, 1.0, 0.0, 0.0, 0.0, 1.0, 1.0, 0.0, 0.0}, {0.0, 0.0, -0.41}},
    {"right_ankle", JointKind::kSpherical, 6, 21, 4, 17, 3,
     {0.0, 0.0, 1.0, 1.0, 0.0, 0.0, 0.0, 1.0, 0.0}, {-0.41, 0.0, 0.0}},
    {"spine", JointKind::kSpherical, 1, 25, 4, 20, 3,
     {1.0, 0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 1.0}, {0.0, 0.0, 0.13}},
    {"left_shoulder", JointKind::kSpherical, 8, 29, 4, 23, 3,
     {1.0, 0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 1.0}, {0.0, 0.2, 0.42}},
    {"left_elbow", JointKind::kRevolute, 9, 33, 1, 26, 1,
     {0.0, 1.0, 0.0, 0.0, 0.0, 1.0, 1.0, 0.0, 0.0}, {0.0, 0.0, -0.29}},
    {"left_wrist", JointKind::kSpherical, 10, 34, 4, 27, 3,
     {0.0, 0.0, 1.0, 1.0, 0.0, 0.0, 0.0, 1.0, 0.0}, {-0.26, 0.0, 0.0}},
    {"neck", JointKind::kSpherical, 8, 38, 4, 30, 3,
     {1.0, 0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 1.0}, {0.0, 0.0, 0.48}},
    {"right_shoulder", JointKind::kSpherical, 8, 42, 4, 33, 3,
     {1.0, 0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 1.0}, {0.0, -0.2, 0.42}},
    {"right_elbow", JointKind::kRevolute, 13, 46, 1, 36, 1,
     {0.0, 1.0, 0.0, 0.0, 0.0, 1.0, 1.0, 0.0, 0.0}, {0.0, 0.0, -0.29}},
    {"right_wrist", JointKind::kSpherical, 14, 47, 4, 37, 3,
     {0.0, 0.0, 1.0, 1.0, 0.0, 0.0, 0.0, 1.0, 0.0}, {-0.26, 0.0, 0.0}}}};

// ---- functions ----------------------------------------------------------------------------------

#include "adagen/joins.hpp"
#include "adagen/no_channel.hpp"
#include "adagen/joints_memory.hpp"

namespace {

struct Joint_root {
  Transform X;  // frame of "world" to that of "pelvis"
  Vec6 v;  // velocity of link "pelvis"
  Columns6 b;  // bias of the bare link "pelvis"
  Joined<Floating> joined;
};

struct Joint_left_hip {
  Transform X;  // frame of "pelvis" to that of "left_thigh"
  Vec6 v;  // velocity of link "left_thigh"
  Columns6 b;  // bias of the bare link "left_thigh"
  Mat6 Phi_pelvis;  // of the chain it completes
  Columns6 b_pelvis;
  Joined<Spherical> joined;
  Coupled<Spherical> at_pelvis;
  Columns6 F_on_pelvis;  // outer wrench on that chain
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

struct Joint_left_ankle {
  Transform X;  // frame of "left_shank" to that of "left_foot"
  Vec6 v;  // velocity of link "left_foot"
  Columns6 b;  // bias of the bare link "left_foot"
  Mat6 Phi_left_shank;  // of the chain it completes
  Columns6 b_left_shank;
  Joined<Spherical> joined;
  Coupled<Spherical> at_left_shank;
  Columns6 F_on_left_shank;  // outer wrench on that chain
};

struct Joint_right_hip {
  Transform X;  // frame of "pelvis" to that of "right_thigh"
  Vec6 v;  // velocity of link "right_thigh"
  Columns6 b;  // bias of the bare link "right_thigh"
  Mat6 Phi_pelvis;  // of the chain it completes
  Columns6 b_pelvis;
  Joined<Spherical> joined;
  Coupled<Spherical> at_pelvis;
  Columns6 F_on_pelvis;  // outer wrench on that chain
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

struct Joint_right_ankle {
  Transform X;  // frame of "right_shank" to that of "right_foot"
  Vec6 v;  // velocity of link "right_foot"
  Columns6 b;  // bias of the bare link "right_foot"
  Mat6 Phi_right_shank;  // of the chain it completes
  Columns6 b_right_shank;
  Joined<Spherical> joined;
  Coupled<Spherical> at_right_shank;
  Columns6 F_on_right_shank;  // outer wrench on that chain
};

struct Joint_spine {
  Transform X;  // frame of "pelvis" to that of "trunk"
  Vec6 v;  // velocity of link "trunk"
  Columns6 b;  // bias of the bare link "trunk"
  Mat6 Phi_pelvis;  // of the chain it completes
  Columns6 b_pelvis;
  Joined<Spherical> joined;
  Coupled<Spherical> at_pelvis;
  Columns6 F_on_pelvis;  // outer wrench on that chain
};

struct Joint_left_shoulder {
  Transform X;  // frame of "trunk" to that of "left_upper_arm"
  Vec6 v;  // velocity of link "left_upper_arm"
  Columns6 b;  // bias of the bare link "left_upper_arm"
  Mat6 Phi_trunk;  // of the chain it completes
  Columns6 b_trunk;
  Joined<Spherical> joined;
  Coupled<Spherical> at_trunk;
  Columns6 F_on_trunk;  // outer wrench on that chain
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

struct Joint_left_wrist {
  Transform X;  // frame of "left_forearm" to that of "left_hand"
  Vec6 v;  // velocity of link "left_hand"
  Columns6 b;  // bias of the bare link "left_hand"
  Mat6 Phi_left_forearm;  // of the chain it completes
  Columns6 b_left_forearm;
  Joined<Spherical> joined;
  Coupled<Spherical> at_left_forearm;
  Columns6 F_on_left_forearm;  // outer wrench on that chain
};

struct Joint_neck {
  Transform X;  // frame of "trunk" to that of "head"
  Vec6 v;  // velocity of link "head"
  Columns6 b;  // bias of the bare link "head"
  Mat6 Phi_trunk;  // of the chain it completes
  Columns6 b_trunk;
  Joined<Spherical> joined;
  Coupled<Spherical> at_trunk;
  Columns6 F_on_trunk;  // outer wrench on that chain
};

struct Joint_right_shoulder {
  Transform X;  // frame of "trunk" to that of "right_upper_arm"
  Vec6 v;  // velocity of link "right_upper_arm"
  Columns6 b;  // bias of the bare link "right_upper_arm"
  Mat6 Phi_trunk;  // of the chain it completes
  Columns6 b_trunk;
  Joined<Spherical> joined;
  Coupled<Spherical> at_trunk;
  Columns6 F_on_trunk;  // outer wrench on that chain
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

struct Joint_right_wrist {
  Transform X;  // frame of "right_forearm" to that of "right_hand"
  Vec6 v;  // velocity of link "right_hand"
  Columns6 b;  // bias of the bare link "right_hand"
  Mat6 Phi_right_forearm;  // of the chain it completes
  Columns6 b_right_forearm;
  Joined<Spherical> joined;
  Coupled<Spherical> at_right_forearm;
  Columns6 F_on_right_forearm;  // outer wrench on that chain
};

struct Workspace : JointsMemory {
  Joint_root j_root;  // and of link "pelvis"
  Joint_left_hip j_left_hip;  // and of link "left_thigh"
  Joint_left_knee j_left_knee;  // and of link "left_shank"
  Joint_left_ankle j_left_ankle;  // and of link "left_foot"
  Joint_right_hip j_right_hip;  // and of link "right_thigh"
  Joint_right_knee j_right_knee;  // and of link "right_shank"
  Joint_right_ankle j_right_ankle;  // and of link "right_foot"
  Joint_spine j_spine;  // and of link "trunk"
  Joint_left_shoulder j_left_shoulder;  // and of link "left_upper_arm"
  Joint_left_elbow j_left_elbow;  // and of link "left_forearm"
  Joint_left_wrist j_left_wrist;  // and of link "left_hand"
  Joint_neck j_neck;  // and of link "head"
  Joint_right_shoulder j_right_shoulder;  // and of link "right_upper_arm"
  Joint_right_elbow j_right_elbow;  // and of link "right_forearm"
  Joint_right_wrist j_right_wrist;  // and of link "right_hand"
};

}  // namespace

#include "adagen/memory.hpp"

const Mat6 kPhi_pelvis = symmetric({9.615384615384615, 0.0, 0.0, 0.0, 0.2884615384615385, 0.0, 19.054878048780488, 0.0, -0.5716463414634146, 0.0, 0.0, 10.813148788927334, 0.0, 0.0, 0.0, 0.12131605691056911, 0.0, 0.0, 0.11282051282051282, 0.0, 0.10416666666666667});
const Mat6 kPhi_left_thigh = symmetric({7.971938775510204, 0.0, 0.0, 0.0, -1.5146683673469388, 0.0, 7.971938775510204, 0.0, 1.5146683673469388, 0.0, 0.0, 37.20238095238095, 0.0, 0.0, 0.0, 0.40683460884353745, 0.0, 0.0, 0.40683460884353745, 0.0, 0.11904761904761904});
const Mat6 kPhi_left_shank = symmetric({250.0, 0.0, 0.0, 0.0, 0.0, 0.0, 22.388042993997768, 0.0, 0.0, 0.0, -4.029847738919598, 22.388042993997768, 0.0, 4.029847738919598, 0.0, 0.3125, 0.0, 0.0, 1.0378725930055277, 0.0, 1.0378725930055277});
const Mat6 kPhi_left_foot = symmetric({923.0797633223488, 0.0, 0.0, 0.0, -36.92319053289395, 0.0, 178.04143736413212, 0.0, 7.1216574945652855, 0.0, 10.682486241847927, 169.97176768938678, 0.0, -10.198306061363207, 0.0, 1.2848662997826115, 0.0, 0.4272994496739171, 3.0888259849975506, 0.0, 1.6409491745108757});
const Mat6 kPhi_right_thigh = symmetric({7.971938775510204, 0.0, 0.0, 0.0, -1.5146683673469388, 0.0, 7.971938775510204, 0.0, 1.5146683673469388, 0.0, 0.0, 37.20238095238095, 0.0, 0.0, 0.0, 0.40683460884353745, 0.0, 0.0, 0.40683460884353745, 0.0, 0.11904761904761904});
const Mat6 kPhi_right_shank = symmetric({250.0, 0.0, 0.0, 0.0, 0.0, 0.0, 22.388042993997768, 0.0, 0.0, 0.0, -4.029847738919598, 22.388042993997768, 0.0, 4.029847738919598, 0.0, 0.3125, 0.0, 0.0, 1.0378725930055277, 0.0, 1.0378725930055277});
const Mat6 kPhi_right_foot = symmetric({923.0797633223488, 0.0, 0.0, 0.0, -36.92319053289395, 0.0, 178.04143736413212, 0.0, 7.1216574945652855, 0.0, 10.682486241847927, 169.97176768938678, 0.0, -10.198306061363207, 0.0, 1.2848662997826115, 0.0, 0.4272994496739171, 3.0888259849975506, 0.0, 1.6409491745108757});
const Mat6 kPhi_trunk = symmetric({1.661590507665748, 0.0, 0.0, 0.0, 0.38216581676312206, 0.0, 2.1382736006602987, 0.0, -0.49180292815186877, 0.0, 0.0, 3.870463333165613, 0.0, 0.0, 0.0, 0.15659293434449503, 0.0, 0.0, 0.1313763987250833, 0.0, 0.043478260869565216});
const Mat6 kPhi_left_upper_arm = symmetric({74.76523715533226, 0.0, 0.0, 0.0, -10.467133201746517, 0.0, 74.76523715533226, 0.0, 10.467133201746517, 0.0, 0.0, 519.8180636777129, 0.0, 0.0, 0.0, 1.9917144377181968, 0.0, 0.0, 1.9917144377181968, 0.0, 0.5263157894736842});
const Mat6 kPhi_left_forearm = symmetric({1484.2300556586272, 0.0, 0.0, 0.0, 0.0, 0.0, 164.852193523287, 0.0, 0.0, 0.0, -19.78226322279444, 164.852193523287, 0.0, 19.78226322279444, 0.0, 0.9090909090909091, 0.0, 0.0, 3.2829624958262418, 0.0, 3.2829624958262418});
const Mat6 kPhi_left_hand = symmetric({809.3889113719142, 0.0, 0.0, 0.0, -64.75111290975313, 0.0, 958.7727708533076, 0.0, 76.70182166826461, 0.0, 0.0, 3913.894324853229, 0.0, 0.0, 0.0, 8.51709811441355, 0.0, 0.0, 7.561041413732632, 0.0, 2.380952380952381});
const Mat6 kPhi_head = symmetric({51.02040816326531, 0.0, 0.0, 0.0, 7.142857142857144, 0.0, 51.02040816326531, 0.0, -7.142857142857144, 0.0, 0.5102040816326531, 51.02040816326531, 0.0, -0.5102040816326531, 0.0, 1.2040816326530615, 0.0, -0.07142857142857144, 1.209183673469388, 0.0, 0.20918367346938774});
const Mat6 kPhi_right_upper_arm = symmetric({74.76523715533226, 0.0, 0.0, 0.0, -10.467133201746517, 0.0, 74.76523715533226, 0.0, 10.467133201746517, 0.0, 0.0, 519.8180636777129, 0.0, 0.0, 0.0, 1.9917144377181968, 0.0, 0.0, 1.9917144377181968, 0.0, 0.5263157894736842});
const Mat6 kPhi_right_forearm = symmetric({1484.2300556586272, 0.0, 0.0, 0.0, 0.0, 0.0, 164.852193523287, 0.0, 0.0, 0.0, -19.78226322279444, 164.852193523287, 0.0, 19.78226322279444, 0.0, 0.9090909090909091, 0.0, 0.0, 3.2829624958262418, 0.0, 3.2829624958262418});
const Mat6 kPhi_right_hand = symmetric({809.3889113719142, 0.0, 0.0, 0.0, -64.75111290975313, 0.0, 958.7727708533076, 0.0, 76.70182166826461, 0.0, 0.0, 3913.894324853229, 0.0, 0.0, 0.0, 8.51709811441355, 0.0, 0.0, 7.561041413732632, 0.0, 2.380952380952381});

// ---- joint 0 "root": floating, between links "world" and "pelvis"

static void kinematics_root(Workspace& w) {
  auto& i = w.j_root;
  require_finite(w, w.q + 0, 7, 0);
  require_finite(w, w.v + 0, 6, 0);
  const Number* const q = w.q + 0;
  require_length(w, conjugate_rotation(q + 3, i.X.E), 0);
  i.X.r << q[0], q[1], 0.95 + q[2];
  i.v = joint_velocity<Floating>(w.v + 0);
}

// A: the ground "world"; B: the chain of "left_hip"; C feels the joint at no link
static void assemble_root(Workspace& w) {
  auto& i = w.j_root;
  load_torque(w, 0, 0, i.joined.tau);
  const Columns6 c = Columns6::Zero();
  constexpr std::array<Real, 6> least{1.3664283380001926e-13, 2.7078610356711135e-13, 1.5366408645330884e-13, 1.7240048593772757e-15, 1.6032759165868928e-15, 1.4802973661668755e-15};
  if (!keeps_digits<Floating>(kZero, w.j_left_hip.Phi_pelvis, least))
    fail(w, kGrowth, 0);
  if (!join(i.joined, kZero, w.j_left_hip.Phi_pelvis, i.X * w.ground, w.j_left_hip.b_pelvis, c))
    fail(w, kFactorization, 0);
}

static void disassemble_root(Workspace& w) {
  auto& i = w.j_root;
  Release<Floating> release(i.joined);
  const Columns6 f = release.force();  // Eq. (8), (10)
  store_acceleration(w, 0, 0, release.qdd());  // Eq. (9)
  w.j_left_hip.F_on_pelvis = f;
}

// ---- joint 1 "left_hip": spherical, between links "pelvis" and "left_thigh"

static void kinematics_left_hip(Workspace& w) {
  auto& i = w.j_left_hip;
  require_finite(w, w.q + 7, 4, 1);
  require_finite(w, w.v + 6, 3, 1);
  const Number* const q = w.q + 7;
  require_length(w, conjugate_rotation(q, i.X.E), 1);
  i.X.r << 0.0, 0.09, -0.04;
  i.v = i.X * w.j_root.v + joint_velocity<Spherical>(w.v + 6);
}

// A: the chain of "right_hip"; B: the chain of "left_knee"; C feels the joint at "pelvis"
static void assemble_left_hip(Workspace& w) {
  auto& i = w.j_left_hip;
  load_torque(w, 1, 6, i.joined.tau);
  const Mat6 X_Phi_A = i.X * w.j_right_hip.Phi_pelvis;
  const Mat6 Phi_A = from_right(X_Phi_A, i.X);
  const Columns6 c = velocity_product<Spherical>(i.v, w.v + 6);
  constexpr std::array<Real, 6> least{1.7036893903932547e-13, 1.7036893903932547e-13, 5.857585060759486e-13, 7.261764885558423e-15, 7.261764885558423e-15, 3.172065784643304e-15};
  if (!keeps_digits<Spherical>(Phi_A, w.j_left_knee.Phi_left_thigh, least))
    fail(w, kGrowth, 1);
  if (!join(i.joined, Phi_A, w.j_left_knee.Phi_left_thigh, i.X * w.j_right_hip.b_pelvis, w.j_left_knee.b_left_thigh, c))
    fail(w, kFactorization, 1);
  couple(i.joined, X_Phi_A, i.at_pelvis);
  i.Phi_pelvis = w.j_right_hip.Phi_pelvis - product(i.at_pelvis, i.at_pelvis);  // Eq. (3)
  i.b_pelvis = w.j_right_hip.b_pelvis - bias_change(i.joined, i.at_pelvis);  // Eq. (6)
}

static void disassemble_left_hip(Workspace& w) {
  auto& i = w.j_left_hip;
  Release<Spherical> release(i.joined);
  release.feel_A(i.at_pelvis, w.j_left_hip.F_on_pelvis);
  const Columns6 f = release.force();  // Eq. (8), (10)
  store_acceleration(w, 1, 6, release.qdd());  // Eq. (9)
  w.j_right_hip.F_on_pelvis = w.j_left_hip.F_on_pelvis - i.X.transposed_times(f);
  w.j_left_knee.F_on_left_thigh = f;
}

// ---- joint 2 "left_knee": revolute, between links "left_thigh" and "left_shank"

static void kinematics_left_knee(Workspace& w) {
  auto& i = w.j_left_knee;
  require_finite(w, w.q + 11, 1, 2);
  require_finite(w, w.v + 9, 1, 2);
  const Real q = Real(w.q[11]), c = std::cos(q), s = std::sin(q);
  i.X.E << s, 0.0, c,  c, 0.0, -s,  0.0, 1.0, 0.0;  // row by row
  i.X.r << 0.0, 0.0, -0.41;
  i.v = i.X * w.j_left_hip.v + joint_velocity<Revolute>(w.v + 9);
}

// A: link "left_thigh"; B: the chain of "left_ankle"; C feels the joint at "left_thigh"
static void assemble_left_knee(Workspace& w) {
  auto& i = w.j_left_knee;
  load_torque(w, 2, 9, i.joined.tau);
  const Mat6 X_Phi_A = i.X * kPhi_left_thigh;
  const Mat6 Phi_A = from_right(X_Phi_A, i.X);
  const Columns6 c = velocity_product<Revolute>(i.v, w.v + 9);
  constexpr std::array<Real, 6> least{3.6038760301657154e-12, 3.6931557771061296e-13, 3.6931557771061296e-13, 6.1326605169770555e-15, 1.6440825050567963e-14, 1.6440825050567963e-14};
  if (!keeps_digits<Revolute>(Phi_A, w.j_left_ankle.Phi_left_shank, least))
    fail(w, kGrowth, 2);
  if (!join(i.joined, Phi_A, w.j_left_ankle.Phi_left_shank, i.X * w.j_left_hip.b, w.j_left_ankle.b_left_shank, c))
    fail(w, kFactorization, 2);
  couple(i.joined, X_Phi_A, i.at_left_thigh);
  i.Phi_left_thigh = kPhi_left_thigh - product(i.at_left_thigh, i.at_left_thigh);  // Eq. (3)
  i.b_left_thigh = w.j_left_hip.b - bias_change(i.joined, i.at_left_thigh);  // Eq. (6)
}

static void disassemble_left_knee(Workspace& w) {
  auto& i = w.j_left_knee;
  Release<Revolute> release(i.joined);
  release.feel_A(i.at_left_thigh, w.j_left_knee.F_on_left_thigh);
  const Columns6 f = release.force();  // Eq. (8), (10)
  store_acceleration(w, 2, 9, release.qdd());  // Eq. (9)
  w.j_left_ankle.F_on_left_shank = f;
}

// ---- joint 3 "left_ankle": spherical, between links "left_shank" and "left_foot"

static void kinematics_left_ankle(Workspace& w) {
  auto& i = w.j_left_ankle;
  require_finite(w, w.q + 12, 4, 3);
  require_finite(w, w.v + 10, 3, 3);
  const Number* const q = w.q + 12;
  Mat3 Q;
  require_length(w, conjugate_rotation(q, Q), 3);
  i.X.E << Q(0, 2), Q(0, 0), Q(0, 1),  Q(1, 2), Q(1, 0), Q(1, 1),  Q(2, 2), Q(2, 0), Q(2, 1);  // row by row
  i.X.r << -0.41, 0.0, 0.0;
  i.v = i.X * w.j_left_knee.v + joint_velocity<Spherical>(w.v + 10);
}

// A: link "left_shank"; B: link "left_foot"; C feels the joint at "left_shank"
static void assemble_left_ankle(Workspace& w) {
  auto& i = w.j_left_ankle;
  load_torque(w, 3, 10, i.joined.tau);
  const Mat6 X_Phi_A = i.X * kPhi_left_shank;
  const Mat6 Phi_A = from_right(X_Phi_A, i.X);
  const Columns6 c = velocity_product<Spherical>(i.v, w.v + 10);
  constexpr std::array<Real, 6> least{1.3270011456023364e-11, 2.682380048573834e-12, 2.5677031452263567e-12, 2.26999404131705e-14, 4.833574941184154e-14, 2.776018241250534e-14};
  if (!keeps_digits<Spherical>(Phi_A, kPhi_left_foot, least))
    fail(w, kGrowth, 3);
  if (!join(i.joined, Phi_A, kPhi_left_foot, i.X * w.j_left_knee.b, w.j_left_ankle.b, c))
    fail(w, kFactorization, 3);
  couple(i.joined, X_Phi_A, i.at_left_shank);
  i.Phi_left_shank = kPhi_left_shank - product(i.at_left_shank, i.at_left_shank);  // Eq. (3)
  i.b_left_shank = w.j_left_knee.b - bias_change(i.joined, i.at_left_shank);  // Eq. (6)
}

static void disassemble_left_ankle(Workspace& w) {
  auto& i = w.j_left_ankle;
  Release<Spherical> release(i.joined);
  release.feel_A(i.at_left_shank, w.j_left_ankle.F_on_left_shank);
  release.force();  // Eq. (8)
  store_acceleration(w, 3, 10, release.qdd());  // Eq. (9)
}

// ---- joint 4 "right_hip": spherical, between links "pelvis" and "right_thigh"

static void kinematics_right_hip(Workspace& w) {
  auto& i = w.j_right_hip;
  require_finite(w, w.q + 16, 4, 4);
  require_finite(w, w.v + 13, 3, 4);
  const Number* const q = w.q + 16;
  require_length(w, conjugate_rotation(q, i.X.E), 4);
  i.X.r << 0.0, -0.09, -0.04;
  i.v = i.X * w.j_root.v + joint_velocity<Spherical>(w.v + 13);
}

// A: the chain of "spine"; B: the chain of "right_knee"; C feels the joint at "pelvis"
static void assemble_right_hip(Workspace& w) {
  auto& i = w.j_right_hip;
  load_torque(w, 4, 13, i.joined.tau);
  const Mat6 X_Phi_A = i.X * w.j_spine.Phi_pelvis;
  const Mat6 Phi_A = from_right(X_Phi_A, i.X);
  const Columns6 c = velocity_product<Spherical>(i.v, w.v + 13);
  constexpr std::array<Real, 6> least{1.7036893903932547e-13, 1.7036893903932547e-13, 5.857585060759486e-13, 7.261764885558423e-15, 7.261764885558423e-15, 3.172065784643304e-15};
  if (!keeps_digits<Spherical>(Phi_A, w.j_right_knee.Phi_right_thigh, least))
    fail(w, kGrowth, 4);
  if (!join(i.joined, Phi_A, w.j_right_knee.Phi_right_thigh, i.X * w.j_spine.b_pelvis, w.j_right_knee.b_right_thigh, c))
    fail(w, kFactorization, 4);
  couple(i.joined, X_Phi_A, i.at_pelvis);
  i.Phi_pelvis = w.j_spine.Phi_pelvis - product(i.at_pelvis, i.at_pelvis);  // Eq. (3)
  i.b_pelvis = w.j_spine.b_pelvis - bias_change(i.joined, i.at_pelvis);  // Eq. (6)
}

static void disassemble_right_hip(Workspace& w) {
  auto& i = w.j_right_hip;
  Release<Spherical> release(i.joined);
  release.feel_A(i.at_pelvis, w.j_right_hip.F_on_pelvis);
  const Columns6 f = release.force();  // Eq. (8), (10)
  store_acceleration(w, 4, 13, release.qdd());  // Eq. (9)
  w.j_spine.F_on_pelvis = w.j_right_hip.F_on_pelvis - i.X.transposed_times(f);
  w.j_right_knee.F_on_right_thigh = f;
}

// ---- joint 5 "right_knee": revolute, between links "right_thigh" and "right_shank"

static void kinematics_right_knee(Workspace& w) {
  auto& i = w.j_right_knee;
  require_finite(w, w.q + 20, 1, 5);
  require_finite(w, w.v + 16, 1, 5);
  const Real q = Real(w.q[20]), c = std::cos(q), s = std::sin(q);
  i.X.E << s, 0.0, c,  c, 0.0, -s,  0.0, 1.0, 0.0;  // row by row
  i.X.r << 0.0, 0.0, -0.41;
  i.v = i.X * w.j_right_hip.v + joint_velocity<Revolute>(w.v + 16);
}

// A: link "right_thigh"; B: the chain of "right_ankle"; C feels the joint at "right_thigh"
static void assemble_right_knee(Workspace& w) {
  auto& i = w.j_right_knee;
  load_torque(w, 5, 16, i.joined.tau);
  const Mat6 X_Phi_A = i.X * kPhi_right_thigh;
  const Mat6 Phi_A = from_right(X_Phi_A, i.X);
  const Columns6 c = velocity_product<Revolute>(i.v, w.v + 16);
  constexpr std::array<Real, 6> least{3.6038760301657154e-12, 3.6931557771061296e-13, 3.6931557771061296e-13, 6.1326605169770555e-15, 1.6440825050567963e-14, 1.6440825050567963e-14};
  if (!keeps_digits<Revolute>(Phi_A, w.j_right_ankle.Phi_right_shank, least))
    fail(w, kGrowth, 5);
  if (!join(i.joined, Phi_A, w.j_right_ankle.Phi_right_shank, i.X * w.j_right_hip.b, w.j_right_ankle.b_right_shank, c))
    fail(w, kFactorization, 5);
  couple(i.joined, X_Phi_A, i.at_right_thigh);
  i.Phi_right_thigh = kPhi_right_thigh - product(i.at_right_thigh, i.at_right_thigh);  // Eq. (3)
  i.b_right_thigh = w.j_right_hip.b - bias_change(i.joined, i.at_right_thigh);  // Eq. (6)
}

static void disassemble_right_knee(Workspace& w) {
  auto& i = w.j_right_knee;
  Release<Revolute> release(i.joined);
  release.feel_A(i.at_right_thigh, w.j_right_knee.F_on_right_thigh);
  const Columns6 f = release.force();  // Eq. (8), (10)
  store_acceleration(w, 5, 16, release.qdd());  // Eq. (9)
  w.j_right_ankle.F_on_right_shank = f;
}

// ---- joint 6 "right_ankle": spherical, between links "right_shank" and "right_foot"

static void kinematics_right_ankle(Workspace& w) {
  auto& i = w.j_right_ankle;
  require_finite(w, w.q + 21, 4, 6);
  require_finite(w, w.v + 17, 3, 6);
  const Number* const q = w.q + 21;
  Mat3 Q;
  require_length(w, conjugate_rotation(q, Q), 6);
  i.X.E << Q(0, 2), Q(0, 0), Q(0, 1),  Q(1, 2), Q(1, 0), Q(1, 1),  Q(2, 2), Q(2, 0), Q(2, 1);  // row by row
  i.X.r << -0.41, 0.0, 0.0;
  i.v = i.X * w.j_right_knee.v + joint_velocity<Spherical>(w.v + 17);
}

// A: link "right_shank"; B: link "right_foot"; C feels the joint at "right_shank"
static void assemble_right_ankle(Workspace& w) {
  auto& i = w.j_right_ankle;
  load_torque(w, 6, 17, i.joined.tau);
  const Mat6 X_Phi_A = i.X * kPhi_right_shank;
  const Mat6 Phi_A = from_right(X_Phi_A, i.X);
  const Columns6 c = velocity_product<Spherical>(i.v, w.v + 17);
  constexpr std::array<Real, 6> least{1.3270011456023364e-11, 2.682380048573834e-12, 2.5677031452263567e-12, 2.26999404131705e-14, 4.833574941184154e-14, 2.776018241250534e-14};
  if (!keeps_digits<Spherical>(Phi_A, kPhi_right_foot, least))
    fail(w, kGrowth, 6);
  if (!join(i.joined, Phi_A, kPhi_right_foot, i.X * w.j_right_knee.b, w.j_right_ankle.b, c))
    fail(w, kFactorization, 6);
  couple(i.joined, X_Phi_A, i.at_right_shank);
  i.Phi_right_shank = kPhi_right_shank - product(i.at_right_shank, i.at_right_shank);  // Eq. (3)
  i.b_right_shank = w.j_right_knee.b - bias_change(i.joined, i.at_right_shank);  // Eq. (6)
}

static void disassemble_right_ankle(Workspace& w) {
  auto& i = w.j_right_ankle;
  Release<Spherical> release(i.joined);
  release.feel_A(i.at_right_shank, w.j_right_ankle.F_on_right_shank);
  release.force();  // Eq. (8)
  store_acceleration(w, 6, 17, release.qdd());  // Eq. (9)
}

// ---- joint 7 "spine": spherical, between links "pelvis" and "trunk"

static void kinematics_spine(Workspace& w) {
  auto& i = w.j_spine;
  require_finite(w, w.q + 25, 4, 7);
  require_finite(w, w.v + 20, 3, 7);
  const Number* const q = w.q + 25;
  require_length(w, conjugate_rotation(q, i.X.E), 7);
  i.X.r << 0.0, 0.0, 0.13;
  i.v = i.X * w.j_root.v + joint_velocity<Spherical>(w.v + 20);
}

// A: link "pelvis"; B: the chain of "left_shoulder"; C feels the joint at "pelvis"
static void assemble_spine(Workspace& w) {
  auto& i = w.j_spine;
  load_torque(w, 7, 20, i.joined.tau);
  const Mat6 X_Phi_A = i.X * kPhi_pelvis;
  const Mat6 Phi_A = from_right(X_Phi_A, i.X);
  const Columns6 c = velocity_product<Spherical>(i.v, w.v + 20);
  constexpr std::array<Real, 6> least{8.069349660266129e-14, 8.746757078239997e-14, 1.1208346741019762e-13, 3.70561680556366e-15, 3.347268281455484e-15, 2.098160614653919e-15};
  if (!keeps_digits<Spherical>(Phi_A, w.j_left_shoulder.Phi_trunk, least))
    fail(w, kGrowth, 7);
  if (!join(i.joined, Phi_A, w.j_left_shoulder.Phi_trunk, i.X * w.j_root.b, w.j_left_shoulder.b_trunk, c))
    fail(w, kFactorization, 7);
  couple(i.joined, X_Phi_A, i.at_pelvis);
  i.Phi_pelvis = kPhi_pelvis - product(i.at_pelvis, i.at_pelvis);  // Eq. (3)
  i.b_pelvis = w.j_root.b - bias_change(i.joined, i.at_pelvis);  // Eq. (6)
}

static void disassemble_spine(Workspace& w) {
  auto& i = w.j_spine;
  Release<Spherical> release(i.joined);
  release.feel_A(i.at_pelvis, w.j_spine.F_on_pelvis);
  const Columns6 f = release.force();  // Eq. (8), (10)
  store_acceleration(w, 7, 20, release.qdd());  // Eq. (9)
  w.j_left_shoulder.F_on_trunk = f;
}

// ---- joint 8 "left_shoulder": spherical, between links "trunk" and "left_upper_arm"

static void kinematics_left_shoulder(Workspace& w) {
  auto& i = w.j_left_shoulder;
  require_finite(w, w.q + 29, 4, 8);
  require_finite(w, w.v + 23, 3, 8);
  const Number* const q = w.q + 29;
  require_length(w, conjugate_rotation(q, i.X.E), 8);
  i.X.r << 0.0, 0.2, 0.42;
  i.v = i.X * w.j_spine.v + joint_velocity<Spherical>(w.v + 23);
}

// A: the chain of "neck"; B: the chain of "left_elbow"; C feels the joint at "trunk"
static void assemble_left_shoulder(Workspace& w) {
  auto& i = w.j_left_shoulder;
  load_torque(w, 8, 23, i.joined.tau);
  const Mat6 X_Phi_A = i.X * w.j_neck.Phi_trunk;
  const Mat6 Phi_A = from_right(X_Phi_A, i.X);
  const Columns6 c = velocity_product<Spherical>(i.v, w.v + 23);
  constexpr std::array<Real, 6> least{1.073179939591126e-12, 1.073179939591126e-12, 7.397760997890678e-12, 2.892182775707059e-14, 2.892182775707059e-14, 8.097260467014413e-15};
  if (!keeps_digits<Spherical>(Phi_A, w.j_left_elbow.Phi_left_upper_arm, least))
    fail(w, kGrowth, 8);
  if (!join(i.joined, Phi_A, w.j_left_elbow.Phi_left_upper_arm, i.X * w.j_neck.b_trunk, w.j_left_elbow.b_left_upper_arm, c))
    fail(w, kFactorization, 8);
  couple(i.joined, X_Phi_A, i.at_trunk);
  i.Phi_trunk = w.j_neck.Phi_trunk - product(i.at_trunk, i.at_trunk);  // Eq. (3)
  i.b_trunk = w.j_neck.b_trunk - bias_change(i.joined, i.at_trunk);  // Eq. (6)
}

static void disassemble_left_shoulder(Workspace& w) {
  auto& i = w.j_left_shoulder;
  Release<Spherical> release(i.joined);
  release.feel_A(i.at_trunk, w.j_left_shoulder.F_on_trunk);
  const Columns6 f = release.force();  // Eq. (8), (10)
  store_acceleration(w, 8, 23, release.qdd());  // Eq. (9)
  w.j_neck.F_on_trunk = w.j_left_shoulder.F_on_trunk - i.X.transposed_times(f);
  w.j_left_elbow.F_on_left_upper_arm = f;
}

// ---- joint 9 "left_elbow": revolute, between links "left_upper_arm" and "left_forearm"

static void kinematics_left_elbow(Workspace& w) {
  auto& i = w.j_left_elbow;
  require_finite(w, w.q + 33, 1, 9);
  require_finite(w, w.v + 26, 1, 9);
  const Real q = Real(w.q[33]), c = std::cos(q), s = std::sin(q);
  i.X.E << s, 0.0, c,  c, 0.0, -s,  0.0, 1.0, 0.0;  // row by row
  i.X.r << 0.0, 0.0, -0.29;
  i.v = i.X * w.j_left_shoulder.v + joint_velocity<Revolute>(w.v + 26);
}

// A: link "left_upper_arm"; B: the chain of "left_wrist"; C feels the joint at "left_upper_arm"
static void assemble_left_elbow(Workspace& w) {
  auto& i = w.j_left_elbow;
  load_torque(w, 9, 26, i.joined.tau);
  const Mat6 X_Phi_A = i.X * kPhi_left_upper_arm;
  const Mat6 Phi_A = from_right(X_Phi_A, i.X);
  const Columns6 c = velocity_product<Revolute>(i.v, w.v + 26);
  constexpr std::array<Real, 6> least{2.1587775800806794e-11, 2.8382886875476563e-12, 2.8382886875476563e-12, 2.039835605052919e-14, 5.4133100282171055e-14, 5.4133100282171055e-14};
  if (!keeps_digits<Revolute>(Phi_A, w.j_left_wrist.Phi_left_forearm, least))
    fail(w, kGrowth, 9);
  if (!join(i.joined, Phi_A, w.j_left_wrist.Phi_left_forearm, i.X * w.j_left_shoulder.b, w.j_left_wrist.b_left_forearm, c))
    fail(w, kFactorization, 9);
  couple(i.joined, X_Phi_A, i.at_left_upper_arm);
  i.Phi_left_upper_arm = kPhi_left_upper_arm - product(i.at_left_upper_arm, i.at_left_upper_arm);  // Eq. (3)
  i.b_left_upper_arm = w.j_left_shoulder.b - bias_change(i.joined, i.at_left_upper_arm);  // Eq. (6)
}

static void disassemble_left_elbow(Workspace& w) {
  auto& i = w.j_left_elbow;
  Release<Revolute> release(i.joined);
  release.feel_A(i.at_left_upper_arm, w.j_left_elbow.F_on_left_upper_arm);
  const Columns6 f = release.force();  // Eq. (8), (10)
  store_acceleration(w, 9, 26, release.qdd());  // Eq. (9)
  w.j_left_wrist.F_on_left_forearm = f;
}

// ---- joint 10 "left_wrist": spherical, between links "left_forearm" and "left_hand"

static void kinematics_left_wrist(Workspace& w) {
  auto& i = w.j_left_wrist;
  require_finite(w, w.q + 34, 4, 10);
  require_finite(w, w.v + 27, 3, 10);
  const Number* const q = w.q + 34;
  Mat3 Q;
  require_length(w, conjugate_rotation(q, Q), 10);
  i.X.E << Q(0, 2), Q(0, 0), Q(0, 1),  Q(1, 2), Q(1, 0), Q(1, 1),  Q(2, 2), Q(2, 0), Q(2, 1);  // row by row
  i.X.r << -0.26, 0.0, 0.0;
  i.v = i.X * w.j_left_elbow.v + joint_velocity<Spherical>(w.v + 27);
}

// A: link "left_forearm"; B: link "left_hand"; C feels the joint at "left_forearm"
static void assemble_left_wrist(Workspace& w) {
  auto& i = w.j_left_wrist;
  load_torque(w, 10, 27, i.joined.tau);
  const Mat6 X_Phi_A = i.X * kPhi_left_forearm;
  const Mat6 Phi_A = from_right(X_Phi_A, i.X);
  const Columns6 c = velocity_product<Spherical>(i.v, w.v + 27);
  constexpr std::array<Real, 6> least{1.2611825810546583e-11, 1.4734698134432816e-11, 5.672950120408767e-11, 1.339542027310537e-13, 1.203678198581818e-13, 4.67543272015304e-14};
  if (!keeps_digits<Spherical>(Phi_A, kPhi_left_hand, least))
    fail(w, kGrowth, 10);
  if (!join(i.joined, Phi_A, kPhi_left_hand, i.X * w.j_left_elbow.b, w.j_left_wrist.b, c))
    fail(w, kFactorization, 10);
  couple(i.joined, X_Phi_A, i.at_left_forearm);
  i.Phi_left_forearm = kPhi_left_forearm - product(i.at_left_forearm, i.at_left_forearm);  // Eq. (3)
  i.b_left_forearm = w.j_left_elbow.b - bias_change(i.joined, i.at_left_forearm);  // Eq. (6)
}

static void disassemble_left_wrist(Workspace& w) {
  auto& i = w.j_left_wrist;
  Release<Spherical> release(i.joined);
  release.feel_A(i.at_left_forearm, w.j_left_wrist.F_on_left_forearm);
  release.force();  // Eq. (8)
  store_acceleration(w, 10, 27, release.qdd());  // Eq. (9)
}

// ---- joint 11 "neck": spherical, between links "trunk" and "head"

static void kinematics_neck(Workspace& w) {
  auto& i = w.j_neck;
  require_finite(w, w.q + 38, 4, 11);
  require_finite(w, w.v + 30, 3, 11);
  const Number* const q = w.q + 38;
  require_length(w, conjugate_rotation(q, i.X.E), 11);
  i.X.r << 0.0, 0.0, 0.48;
  i.v = i.X * w.j_spine.v + joint_velocity<Spherical>(w.v + 30);
}

// A: the chain of "right_shoulder"; B: link "head"; C feels the joint at "trunk"
static void assemble_neck(Workspace& w) {
  auto& i = w.j_neck;
  load_torque(w, 11, 30, i.joined.tau);
  const Mat6 X_Phi_A = i.X * w.j_right_shoulder.Phi_trunk;
  const Mat6 Phi_A = from_right(X_Phi_A, i.X);
  const Columns6 c = velocity_product<Spherical>(i.v, w.v + 30);
  constexpr std::array<Real, 6> least{7.357456245475462e-13, 7.357456245475462e-13, 7.357456245475462e-13, 1.772889239536293e-14, 1.7801396756154775e-14, 3.590542040952769e-15};
  if (!keeps_digits<Spherical>(Phi_A, kPhi_head, least))
    fail(w, kGrowth, 11);
  if (!join(i.joined, Phi_A, kPhi_head, i.X * w.j_right_shoulder.b_trunk, w.j_neck.b, c))
    fail(w, kFactorization, 11);
  couple(i.joined, X_Phi_A, i.at_trunk);
  i.Phi_trunk = w.j_right_shoulder.Phi_trunk - product(i.at_trunk, i.at_trunk);  // Eq. (3)
  i.b_trunk = w.j_right_shoulder.b_trunk - bias_change(i.joined, i.at_trunk);  // Eq. (6)
}

static void disassemble_neck(Workspace& w) {
  auto& i = w.j_neck;
  Release<Spherical> release(i.joined);
  release.feel_A(i.at_trunk, w.j_neck.F_on_trunk);
  const Columns6 f = release.force();  // Eq. (8), (10)
  store_acceleration(w, 11, 30, release.qdd());  // Eq. (9)
  w.j_right_shoulder.F_on_trunk = w.j_neck.F_on_trunk - i.X.transposed_times(f);
}

// ---- joint 12 "right_shoulder": spherical, between links "trunk" and "right_upper_arm"

static void kinematics_right_shoulder(Workspace& w) {
  auto& i = w.j_right_shoulder;
  require_finite(w, w.q + 42, 4, 12);
  require_finite(w, w.v + 33, 3, 12);
  const Number* const q = w.q + 42;
  require_length(w, conjugate_rotation(q, i.X.E), 12);
  i.X.r << 0.0, -0.2, 0.42;
  i.v = i.X * w.j_spine.v + joint_velocity<Spherical>(w.v + 33);
}

// A: link "trunk"; B: the chain of "right_elbow"; C feels the joint at "trunk"
static void assemble_right_shoulder(Workspace& w) {
  auto& i = w.j_right_shoulder;
  load_torque(w, 12, 33, i.joined.tau);
  const Mat6 X_Phi_A = i.X * kPhi_trunk;
  const Mat6 Phi_A = from_right(X_Phi_A, i.X);
  const Columns6 c = velocity_product<Spherical>(i.v, w.v + 33);
  constexpr std::array<Real, 6> least{1.073179939591126e-12, 1.073179939591126e-12, 7.397760997890678e-12, 2.892182775707059e-14, 2.892182775707059e-14, 8.097260467014413e-15};
  if (!keeps_digits<Spherical>(Phi_A, w.j_right_elbow.Phi_right_upper_arm, least))
    fail(w, kGrowth, 12);
  if (!join(i.joined, Phi_A, w.j_right_elbow.Phi_right_upper_arm, i.X * w.j_spine.b, w.j_right_elbow.b_right_upper_arm, c))
    fail(w, kFactorization, 12);
  couple(i.joined, X_Phi_A, i.at_trunk);
  i.Phi_trunk = kPhi_trunk - product(i.at_trunk, i.at_trunk);  // Eq. (3)
  i.b_trunk = w.j_spine.b - bias_change(i.joined, i.at_trunk);  // Eq. (6)
}

static void disassemble_right_shoulder(Workspace& w) {
  auto& i = w.j_right_shoulder;
  Release<Spherical> release(i.joined);
  release.feel_A(i.at_trunk, w.j_right_shoulder.F_on_trunk);
  const Columns6 f = release.force();  // Eq. (8), (10)
  store_acceleration(w, 12, 33, release.qdd());  // Eq. (9)
  w.j_right_elbow.F_on_right_upper_arm = f;
}

// ---- joint 13 "right_elbow": revolute, between links "right_upper_arm" and "right_forearm"

static void kinematics_right_elbow(Workspace& w) {
  auto& i = w.j_right_elbow;
  require_finite(w, w.q + 46, 1, 13);
  require_finite(w, w.v + 36, 1, 13);
  const Real q = Real(w.q[46]), c = std::cos(q), s = std::sin(q);
  i.X.E << s, 0.0, c,  c, 0.0, -s,  0.0, 1.0, 0.0;  // row by row
  i.X.r << 0.0, 0.0, -0.29;
  i.v = i.X * w.j_right_shoulder.v + joint_velocity<Revolute>(w.v + 36);
}

// A: link "right_upper_arm"; B: the chain of "right_wrist"; C feels the joint at "right_upper_arm"
static void assemble_right_elbow(Workspace& w) {
  auto& i = w.j_right_elbow;
  load_torque(w, 13, 36, i.joined.tau);
  const Mat6 X_Phi_A = i.X * kPhi_right_upper_arm;
  const Mat6 Phi_A = from_right(X_Phi_A, i.X);
  const Columns6 c = velocity_product<Revolute>(i.v, w.v + 36);
  constexpr std::array<Real, 6> least{2.1587775800806794e-11, 2.8382886875476563e-12, 2.8382886875476563e-12, 2.039835605052919e-14, 5.4133100282171055e-14, 5.4133100282171055e-14};
  if (!keeps_digits<Revolute>(Phi_A, w.j_right_wrist.Phi_right_forearm, least))
    fail(w, kGrowth, 13);
  if (!join(i.joined, Phi_A, w.j_right_wrist.Phi_right_forearm, i.X * w.j_right_shoulder.b, w.j_right_wrist.b_right_forearm, c))
    fail(w, kFactorization, 13);
  couple(i.joined, X_Phi_A, i.at_right_upper_arm);
  i.Phi_right_upper_arm = kPhi_right_upper_arm - product(i.at_right_upper_arm, i.at_right_upper_arm);  // Eq. (3)
  i.b_right_upper_arm = w.j_right_shoulder.b - bias_change(i.joined, i.at_right_upper_arm);  // Eq. (6)
}

static void disassemble_right_elbow(Workspace& w) {
  auto& i = w.j_right_elbow;
  Release<Revolute> release(i.joined);
  release.feel_A(i.at_right_upper_arm, w.j_right_elbow.F_on_right_upper_arm);
  const Columns6 f = release.force();  // Eq. (8), (10)
  store_acceleration(w, 13, 36, release.qdd());  // Eq. (9)
  w.j_right_wrist.F_on_right_forearm = f;
}

// ---- joint 14 "right_wrist": spherical, between links "right_forearm" and "right_hand"

static void kinematics_right_wrist(Workspace& w) {
  auto& i = w.j_right_wrist;
  require_finite(w, w.q + 47, 4, 14);
  require_finite(w, w.v + 37, 3, 14);
  const Number* const q = w.q + 47;
  Mat3 Q;
  require_length(w, conjugate_rotation(q, Q), 14);
  i.X.E << Q(0, 2), Q(0, 0), Q(0, 1),  Q(1, 2), Q(1, 0), Q(1, 1),  Q(2, 2), Q(2, 0), Q(2, 1);  // row by row
  i.X.r << -0.26, 0.0, 0.0;
  i.v = i.X * w.j_right_elbow.v + joint_velocity<Spherical>(w.v + 37);
}

// A: link "right_forearm"; B: link "right_hand"; C feels the joint at "right_forearm"
static void assemble_right_wrist(Workspace& w) {
  auto& i = w.j_right_wrist;
  load_torque(w, 14, 37, i.joined.tau);
  const Mat6 X_Phi_A = i.X * kPhi_right_forearm;
  const Mat6 Phi_A = from_right(X_Phi_A, i.X);
  const Columns6 c = velocity_product<Spherical>(i.v, w.v + 37);
  constexpr std::array<Real, 6> least{1.2611825810546583e-11, 1.4734698134432816e-11, 5.672950120408767e-11, 1.339542027310537e-13, 1.203678198581818e-13, 4.67543272015304e-14};
  if (!keeps_digits<Spherical>(Phi_A, kPhi_right_hand, least))
    fail(w, kGrowth, 14);
  if (!join(i.joined, Phi_A, kPhi_right_hand, i.X * w.j_right_elbow.b, w.j_right_wrist.b, c))
    fail(w, kFactorization, 14);
  couple(i.joined, X_Phi_A, i.at_right_forearm);
  i.Phi_right_forearm = kPhi_right_forearm - product(i.at_right_forearm, i.at_right_forearm);  // Eq. (3)
  i.b_right_forearm = w.j_right_elbow.b - bias_change(i.joined, i.at_right_forearm);  // Eq. (6)
}

static void disassemble_right_wrist(Workspace& w) {
  auto& i = w.j_right_wrist;
  Release<Spherical> release(i.joined);
  release.feel_A(i.at_right_forearm, w.j_right_wrist.F_on_right_forearm);
  release.force();  // Eq. (8)
  store_acceleration(w, 14, 37, release.qdd());  // Eq. (9)
}

// ---- processes ----------------------------------------------------------------------------------

// Process 0: 15 of 15 joints: "root", "left_hip", "left_knee", "left_ankle", "right_hip", "right_knee", ...
static void run_0([[maybe_unused]] Workspace& w, [[maybe_unused]] Channel& channel) {
  w.ground = ground(w);
  kinematics_root(w);
  kinematics_left_hip(w);
  kinematics_left_knee(w);
  kinematics_left_ankle(w);
  kinematics_right_hip(w);
  kinematics_right_knee(w);
  kinematics_right_ankle(w);
  kinematics_spine(w);
  kinematics_left_shoulder(w);
  kinematics_left_elbow(w);
  kinematics_left_wrist(w);
  kinematics_neck(w);
  kinematics_right_shoulder(w);
  kinematics_right_elbow(w);
  kinematics_right_wrist(w);
  stamp(1);
  link_bias(kLinks[14], w.j_right_elbow.v, w.j_right_elbow.b);
  link_bias(kLinks[15], w.j_right_wrist.v, w.j_right_wrist.b);
  assemble_right_wrist(w);
  link_bias(kLinks[13], w.j_right_shoulder.v, w.j_right_shoulder.b);
  assemble_right_elbow(w);
  link_bias(kLinks[8], w.j_spine.v, w.j_spine.b);
  assemble_right_shoulder(w);
  link_bias(kLinks[12], w.j_neck.v, w.j_neck.b);
  assemble_neck(w);
  link_bias(kLinks[10], w.j_left_elbow.v, w.j_left_elbow.b);
  link_bias(kLinks[11], w.j_left_wrist.v, w.j_left_wrist.b);
  assemble_left_wrist(w);
  link_bias(kLinks[9], w.j_left_shoulder.v, w.j_left_shoulder.b);
  assemble_left_elbow(w);
  assemble_left_shoulder(w);
  link_bias(kLinks[1], w.j_root.v, w.j_root.b);
  assemble_spine(w);
  link_bias(kLinks[6], w.j_right_knee.v, w.j_right_knee.b);
  link_bias(kLinks[7], w.j_right_ankle.v, w.j_right_ankle.b);
  assemble_right_ankle(w);
  link_bias(kLinks[5], w.j_right_hip.v, w.j_right_hip.b);
  assemble_right_knee(w);
  assemble_right_hip(w);
  link_bias(kLinks[3], w.j_left_knee.v, w.j_left_knee.b);
  link_bias(kLinks[4], w.j_left_ankle.v, w.j_left_ankle.b);
  assemble_left_ankle(w);
  link_bias(kLinks[2], w.j_left_hip.v, w.j_left_hip.b);
  assemble_left_knee(w);
  assemble_left_hip(w);
  assemble_root(w);
  stamp(2);
  disassemble_root(w);
  disassemble_left_hip(w);
  disassemble_right_hip(w);
  disassemble_spine(w);
  disassemble_left_shoulder(w);
  disassemble_neck(w);
  disassemble_right_shoulder(w);
  disassemble_right_elbow(w);
  disassemble_right_wrist(w);
  disassemble_left_elbow(w);
  disassemble_left_wrist(w);
  disassemble_right_knee(w);
  disassemble_right_ankle(w);
  disassemble_left_knee(w);
  disassemble_left_ankle(w);
  stamp(3);
}

[[maybe_unused]] constexpr std::array<StageInfo, 3> kStages_0{ {{"kinematics", 14, -1}, {"assembly", 0, -1}, {"disassembly", 0, -1}} };

#include "adagen/whole_alone.hpp"
