// Forward dynamics of "arm7" on 1 process, emitted by adagen 0.1.0 (solver.cpp.j2). Do not edit: generate again. Licence: yours to choose.
// robot     "arm7", 9 joints, 9 degrees of freedom, description sha256 35a799ae72b600eeca178cc12eccff22927d06b6ca76bda0ede3ef5832ebda29
// command   adagen ../models/arm7.urdf --procs 1 --shape=joints
// input     profile default, sha256 977543643db91de59ea535554dcb3c9c2a18e003ca628ebbded456825d6fd4eb
// options   form segment (articulated-body algorithm), shape joints (spatial vectors [angular; linear] in link frames whose joint axes are z), scalar double, channel auto, fixed base, gravity 0.0, 0.0, -9.81
// needs     Eigen's headers
// links     adagen_program.cpp; or, compiled with -DADAGEN_NO_MAIN, a program of yours that includes arm7_p1.h
// program   1 process; 0.4 us predicted (default profile)
//           process 0: base_yaw .. right_finger_slide

#include "arm7_p1.h"
#define ADAGEN_CALL(word) arm7_p1_##word
#define ADAGEN_NAMED(WORD) ARM7_P1_##WORD
#include "adagen/settings.hpp"

namespace { struct arm7_p1_settings : PlainSettings {
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

#include "adagen/joints_alone.hpp"

namespace {

struct Workspace : JointsMemory {
  ArticulatedJoint<Articulated<Revolute>> j_base_yaw;  // and of link "turret"
  ArticulatedJoint<Articulated<Revolute>> j_shoulder_pitch;  // and of link "upper_arm"
  ArticulatedJoint<Articulated<Revolute>> j_upper_arm_roll;  // and of link "elbow_housing"
  ArticulatedJoint<Articulated<Revolute>> j_elbow_pitch;  // and of link "forearm"
  ArticulatedJoint<Articulated<Revolute>> j_forearm_roll;  // and of link "wrist_housing"
  ArticulatedJoint<Articulated<Revolute>> j_wrist_pitch;  // and of link "wrist"
  ArticulatedJoint<Articulated<Revolute>> j_flange_roll;  // and of link "hand"
  ArticulatedJoint<Articulated<Prismatic>> j_left_finger_slide;  // and of link "left_finger"
  ArticulatedJoint<Articulated<Prismatic>> j_right_finger_slide;  // and of link "right_finger"
};

}  // namespace

#include "adagen/hand_on.hpp"

const Inertia kInertia_turret = spatial_inertia(kLinks[1]);
const Inertia kInertia_upper_arm = spatial_inertia(kLinks[2]);
const Inertia kInertia_elbow_housing = spatial_inertia(kLinks[3]);
const Inertia kInertia_forearm = spatial_inertia(kLinks[4]);
const Inertia kInertia_wrist_housing = spatial_inertia(kLinks[5]);
const Inertia kInertia_wrist = spatial_inertia(kLinks[6]);
const Inertia kInertia_hand = spatial_inertia(kLinks[7]);
const Inertia kInertia_left_finger = spatial_inertia(kLinks[8]);
const Inertia kInertia_right_finger = spatial_inertia(kLinks[9]);

// ---- joint 0 "base_yaw": revolute, between links "pedestal" and "turret"

static void kinematics_base_yaw(Workspace& w) {
  auto& i = w.j_base_yaw;
  require_finite(w, w.q + 0, 1, 0);
  require_finite(w, w.v + 0, 1, 0);
  const Real q = Real(w.q[0]), c = std::cos(q), s = std::sin(q);
  i.X.E << c, s, 0.0,  -s, c, 0.0,  0.0, 0.0, 1.0;  // row by row
  i.X.r << 0.0, 0.0, 0.16;
  i.v = joint_velocity<Revolute>(w.v + 0);
}

static void articulate_base_yaw(Workspace& w) {
  auto& i = w.j_base_yaw;
  load_torque(w, 0, 0, i.body.tau);
  i.body.c = Columns6::Zero();
  hand_on(w, 0, i.body, 1, i.IA, i.pA);
}

static void accelerate_base_yaw(Workspace& w) {
  auto& i = w.j_base_yaw;
  i.a = i.X * w.ground;
  store_acceleration(w, 0, 0, accelerate(i.body, i.a));
}

// ---- joint 1 "shoulder_pitch": revolute, between links "turret" and "upper_arm"

static void kinematics_shoulder_pitch(Workspace& w) {
  auto& i = w.j_shoulder_pitch;
  require_finite(w, w.q + 1, 1, 1);
  require_finite(w, w.v + 1, 1, 1);
  const Real q = Real(w.q[1]), c = std::cos(q), s = std::sin(q);
  i.X.E << c, -3.673205103346574e-06 * s, -0.9999999999932537 * s,  -s, -3.673205103346574e-06 * c, -0.9999999999932537 * c,  0.0, 0.9999999999932537, -3.673205103346574e-06;  // row by row
  i.X.r << 0.0, 0.0, 0.18;
  i.v = i.X * w.j_base_yaw.v + joint_velocity<Revolute>(w.v + 1);
}

static void articulate_shoulder_pitch(Workspace& w) {
  auto& i = w.j_shoulder_pitch;
  load_torque(w, 1, 1, i.body.tau);
  i.body.c = velocity_product<Revolute>(i.v, w.v + 1);
  add_in_parent(i.X, hand_on(w, 1, i.body, 1, i.IA, i.pA), w.j_base_yaw.IA, w.j_base_yaw.pA);
}

static void accelerate_shoulder_pitch(Workspace& w) {
  auto& i = w.j_shoulder_pitch;
  i.a = i.X * w.j_base_yaw.a;
  store_acceleration(w, 1, 1, accelerate(i.body, i.a));
}

// ---- joint 2 "upper_arm_roll": revolute, between links "upper_arm" and "elbow_housing"

static void kinematics_upper_arm_roll(Workspace& w) {
  auto& i = w.j_upper_arm_roll;
  require_finite(w, w.q + 2, 1, 2);
  require_finite(w, w.v + 2, 1, 2);
  const Real q = Real(w.q[2]), c = std::cos(q), s = std::sin(q);
  i.X.E << c, -3.673205103346574e-06 * s, 0.9999999999932537 * s,  -s, -3.673205103346574e-06 * c, 0.9999999999932537 * c,  0.0, -0.9999999999932537, -3.673205103346574e-06;  // row by row
  i.X.r << 0.0, -0.3, 0.0;
  i.v = i.X * w.j_shoulder_pitch.v + joint_velocity<Revolute>(w.v + 2);
}

static void articulate_upper_arm_roll(Workspace& w) {
  auto& i = w.j_upper_arm_roll;
  load_torque(w, 2, 2, i.body.tau);
  i.body.c = velocity_product<Revolute>(i.v, w.v + 2);
  add_in_parent(i.X, hand_on(w, 2, i.body, 1, i.IA, i.pA), w.j_shoulder_pitch.IA, w.j_shoulder_pitch.pA);
}

static void accelerate_upper_arm_roll(Workspace& w) {
  auto& i = w.j_upper_arm_roll;
  i.a = i.X * w.j_shoulder_pitch.a;
  store_acceleration(w, 2, 2, accelerate(i.body, i.a));
}

// ---- joint 3 "elbow_pitch": revolute, between links "elbow_housing" and "forearm"

static void kinematics_elbow_pitch(Workspace& w) {
  auto& i = w.j_elbow_pitch;
  require_finite(w, w.q + 3, 1, 3);
  require_finite(w, w.v + 3, 1, 3);
  const Real q = Real(w.q[3]), c = std::cos(q), s = std::sin(q);
  i.X.E << c, -3.673205103346574e-06 * s, 0.9999999999932537 * s,  -s, -3.673205103346574e-06 * c, 0.9999999999932537 * c,  0.0, -0.9999999999932537, -3.673205103346574e-06;  // row by row
  i.X.r << 0.08, 0.0, 0.0;
  i.v = i.X * w.j_upper_arm_roll.v + joint_velocity<Revolute>(w.v + 3);
}

static void articulate_elbow_pitch(Workspace& w) {
  auto& i = w.j_elbow_pitch;
  load_torque(w, 3, 3, i.body.tau);
  i.body.c = velocity_product<Revolute>(i.v, w.v + 3);
  add_in_parent(i.X, hand_on(w, 3, i.body, 1, i.IA, i.pA), w.j_upper_arm_roll.IA, w.j_upper_arm_roll.pA);
}

static void accelerate_elbow_pitch(Workspace& w) {
  auto& i = w.j_elbow_pitch;
  i.a = i.X * w.j_upper_arm_roll.a;
  store_acceleration(w, 3, 3, accelerate(i.body, i.a));
}

// ---- joint 4 "forearm_roll": revolute, between links "forearm" and "wrist_housing"

static void kinematics_forearm_roll(Workspace& w) {
  auto& i = w.j_forearm_roll;
  require_finite(w, w.q + 4, 1, 4);
  require_finite(w, w.v + 4, 1, 4);
  const Real q = Real(w.q[4]), c = std::cos(q), s = std::sin(q);
  i.X.E << c, -3.673205103346574e-06 * s, -0.9999999999932537 * s,  -s, -3.673205103346574e-06 * c, -0.9999999999932537 * c,  0.0, 0.9999999999932537, -3.673205103346574e-06;  // row by row
  i.X.r << -0.08, 0.38, 0.0;
  i.v = i.X * w.j_elbow_pitch.v + joint_velocity<Revolute>(w.v + 4);
}

static void articulate_forearm_roll(Workspace& w) {
  auto& i = w.j_forearm_roll;
  load_torque(w, 4, 4, i.body.tau);
  i.body.c = velocity_product<Revolute>(i.v, w.v + 4);
  add_in_parent(i.X, hand_on(w, 4, i.body, 1, i.IA, i.pA), w.j_elbow_pitch.IA, w.j_elbow_pitch.pA);
}

static void accelerate_forearm_roll(Workspace& w) {
  auto& i = w.j_forearm_roll;
  i.a = i.X * w.j_elbow_pitch.a;
  store_acceleration(w, 4, 4, accelerate(i.body, i.a));
}

// ---- joint 5 "wrist_pitch": revolute, between links "wrist_housing" and "wrist"

static void kinematics_wrist_pitch(Workspace& w) {
  auto& i = w.j_wrist_pitch;
  require_finite(w, w.q + 5, 1, 5);
  require_finite(w, w.v + 5, 1, 5);
  const Real q = Real(w.q[5]), c = std::cos(q), s = std::sin(q);
  i.X.E << c, -3.673205103346574e-06 * s, 0.9999999999932537 * s,  -s, -3.673205103346574e-06 * c, 0.9999999999932537 * c,  0.0, -0.9999999999932537, -3.673205103346574e-06;  // row by row
  i.X.r << 0.0, 0.0, 0.0;
  i.v = i.X * w.j_forearm_roll.v + joint_velocity<Revolute>(w.v + 5);
}

static void articulate_wrist_pitch(Workspace& w) {
  auto& i = w.j_wrist_pitch;
  load_torque(w, 5, 5, i.body.tau);
  i.body.c = velocity_product<Revolute>(i.v, w.v + 5);
  add_in_parent(i.X, hand_on(w, 5, i.body, 1, i.IA, i.pA), w.j_forearm_roll.IA, w.j_forearm_roll.pA);
}

static void accelerate_wrist_pitch(Workspace& w) {
  auto& i = w.j_wrist_pitch;
  i.a = i.X * w.j_forearm_roll.a;
  store_acceleration(w, 5, 5, accelerate(i.body, i.a));
}

// ---- joint 6 "flange_roll": revolute, between links "wrist" and "hand"

static void kinematics_flange_roll(Workspace& w) {
  auto& i = w.j_flange_roll;
  require_finite(w, w.q + 6, 1, 6);
  require_finite(w, w.v + 6, 1, 6);
  const Real q = Real(w.q[6]), c = std::cos(q), s = std::sin(q);
  i.X.E << c, -3.673205103346574e-06 * s, 0.9999999999932537 * s,  -s, -3.673205103346574e-06 * c, 0.9999999999932537 * c,  0.0, -0.9999999999932537, -3.673205103346574e-06;  // row by row
  i.X.r << 0.09, 0.0, 0.0;
  i.v = i.X * w.j_wrist_pitch.v + joint_velocity<Revolute>(w.v + 6);
}

static void articulate_flange_roll(Workspace& w) {
  auto& i = w.j_flange_roll;
  load_torque(w, 6, 6, i.body.tau);
  i.body.c = velocity_product<Revolute>(i.v, w.v + 6);
  add_in_parent(i.X, hand_on(w, 6, i.body, 1, i.IA, i.pA), w.j_wrist_pitch.IA, w.j_wrist_pitch.pA);
}

static void accelerate_flange_roll(Workspace& w) {
  auto& i = w.j_flange_roll;
  i.a = i.X * w.j_wrist_pitch.a;
  store_acceleration(w, 6, 6, accelerate(i.body, i.a));
}

// ---- joint 7 "left_finger_slide": prismatic, between links "hand" and "left_finger"

static void kinematics_left_finger_slide(Workspace& w) {
  auto& i = w.j_left_finger_slide;
  require_finite(w, w.q + 7, 1, 7);
  require_finite(w, w.v + 7, 1, 7);
  const Real q = Real(w.q[7]);
  i.X.E << 0.0, 0.0, 1.0,  1.0, 0.0, 0.0,  0.0, 1.0, 0.0;  // row by row
  i.X.r << 0.0, q, 0.13;
  i.v = i.X * w.j_flange_roll.v + joint_velocity<Prismatic>(w.v + 7);
}

static void articulate_left_finger_slide(Workspace& w) {
  auto& i = w.j_left_finger_slide;
  load_torque(w, 7, 7, i.body.tau);
  i.body.c = velocity_product<Prismatic>(i.v, w.v + 7);
  add_in_parent(i.X, hand_on(w, 7, i.body, 1, i.IA, i.pA), w.j_flange_roll.IA, w.j_flange_roll.pA);
}

static void accelerate_left_finger_slide(Workspace& w) {
  auto& i = w.j_left_finger_slide;
  i.a = i.X * w.j_flange_roll.a;
  store_acceleration(w, 7, 7, accelerate(i.body, i.a));
}

// ---- joint 8 "right_finger_slide": prismatic, between links "hand" and "right_finger"

static void kinematics_right_finger_slide(Workspace& w) {
  auto& i = w.j_right_finger_slide;
  require_finite(w, w.q + 8, 1, 8);
  require_finite(w, w.v + 8, 1, 8);
  const Real q = Real(w.q[8]);
  i.X.E << 0.0, 0.0, 1.0,  -0.9999999999964793, 2.65358979335273e-06, 0.0,  -2.65358979335273e-06, -0.9999999999964793, 0.0;  // row by row
  i.X.r << -2.65358979335273e-06 * q, -0.9999999999964793 * q, 0.13;
  i.v = i.X * w.j_flange_roll.v + joint_velocity<Prismatic>(w.v + 8);
}

static void articulate_right_finger_slide(Workspace& w) {
  auto& i = w.j_right_finger_slide;
  load_torque(w, 8, 8, i.body.tau);
  i.body.c = velocity_product<Prismatic>(i.v, w.v + 8);
  add_in_parent(i.X, hand_on(w, 8, i.body, 1, i.IA, i.pA), w.j_flange_roll.IA, w.j_flange_roll.pA);
}

static void accelerate_right_finger_slide(Workspace& w) {
  auto& i = w.j_right_finger_slide;
  i.a = i.X * w.j_flange_roll.a;
  store_acceleration(w, 8, 8, accelerate(i.body, i.a));
}

// ---- processes ----------------------------------------------------------------------------------

// Process 0: 9 of 9 joints: "base_yaw", "shoulder_pitch", "upper_arm_roll", "elbow_pitch", "forearm_roll", "wrist_pitch", ...
static void run_0([[maybe_unused]] Workspace& w, [[maybe_unused]] Channel& channel) {
  w.ground = ground(w);
  kinematics_base_yaw(w);
  kinematics_shoulder_pitch(w);
  kinematics_upper_arm_roll(w);
  kinematics_elbow_pitch(w);
  kinematics_forearm_roll(w);
  kinematics_wrist_pitch(w);
  kinematics_flange_roll(w);
  kinematics_left_finger_slide(w);
  kinematics_right_finger_slide(w);
  stamp(1);
  start_link(kInertia_turret, w.j_base_yaw.v, w.j_base_yaw.IA, w.j_base_yaw.pA);
  start_link(kInertia_upper_arm, w.j_shoulder_pitch.v, w.j_shoulder_pitch.IA, w.j_shoulder_pitch.pA);
  start_link(kInertia_elbow_housing, w.j_upper_arm_roll.v, w.j_upper_arm_roll.IA, w.j_upper_arm_roll.pA);
  start_link(kInertia_forearm, w.j_elbow_pitch.v, w.j_elbow_pitch.IA, w.j_elbow_pitch.pA);
  start_link(kInertia_wrist_housing, w.j_forearm_roll.v, w.j_forearm_roll.IA, w.j_forearm_roll.pA);
  start_link(kInertia_wrist, w.j_wrist_pitch.v, w.j_wrist_pitch.IA, w.j_wrist_pitch.pA);
  start_link(kInertia_hand, w.j_flange_roll.v, w.j_flange_roll.IA, w.j_flange_roll.pA);
  start_link(kInertia_left_finger, w.j_left_finger_slide.v, w.j_left_finger_slide.IA, w.j_left_finger_slide.pA);
  start_link(kInertia_right_finger, w.j_right_finger_slide.v, w.j_right_finger_slide.IA, w.j_right_finger_slide.pA);
  articulate_right_finger_slide(w);
  articulate_left_finger_slide(w);
  articulate_flange_roll(w);
  articulate_wrist_pitch(w);
  articulate_forearm_roll(w);
  articulate_elbow_pitch(w);
  articulate_upper_arm_roll(w);
  articulate_shoulder_pitch(w);
  articulate_base_yaw(w);
  stamp(2);
  accelerate_base_yaw(w);
  accelerate_shoulder_pitch(w);
  accelerate_upper_arm_roll(w);
  accelerate_elbow_pitch(w);
  accelerate_forearm_roll(w);
  accelerate_wrist_pitch(w);
  accelerate_flange_roll(w);
  accelerate_left_finger_slide(w);
  accelerate_right_finger_slide(w);
  stamp(3);
}

[[maybe_unused]] constexpr std::array<StageInfo, 3> kStages_0{ {{"kinematics", 8, -1}, {"assembly", 0, -1}, {"disassembly", 0, -1}} };

#include "adagen/whole_alone.hpp"
