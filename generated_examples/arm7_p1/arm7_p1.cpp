// Forward dynamics of "arm7" on 1 process, emitted by adagen 0.1.0 (solver.cpp.j2). Do not edit: generate again.
//
// robot     "arm7", 9 joints, 9 degrees of freedom, description sha256 35a799ae72b600eeca178cc12eccff22927d06b6ca76bda0ede3ef5832ebda29
// command   adagen ../models/arm7.urdf --procs 1 --shape=joints
// options   form segment, shape joints, scalar double, channel auto, fixed base, gravity 0.0, 0.0, -9.81
// links     adagen_program.cpp
// program   1 process; 0.324 us predicted (default profile)
//           process 0: base_yaw .. right_finger_slide
// licence   yours to choose: generated code belongs to its user
//
// Articulated-body algorithm: the articulated-body inertias I^A and bias forces p^A (IA, pA) are computed
// from the ends to the base, then the accelerations from the base outwards. Spatial vectors are [angular;
// linear], in link frames turned so that every joint axis is z.

// ---- 1. interface -------------------------------------------------------------------------------
// arm7_p1.h declares it. To link this file with a program of your own, compile it with -DADAGEN_NO_MAIN.

#if __has_include("arm7_p1.h")
#include "arm7_p1.h"
#define ADAGEN_HEADER
#endif
#define ADAGEN_CALL(word) arm7_p1_##word
#define ADAGEN_NAMED(WORD) ARM7_P1_##WORD


#include <Eigen/Core>

// ---- 2. model -----------------------------------------------------------------------------------

#define ADAGEN_SOLVER 100  // version of adagen that wrote this file
#include "adagen/settings.hpp"

namespace {

struct Settings : PlainSettings {
  static constexpr int kJointCount = 9, kNq = 9, kNv = 9;
};

}  // namespace

#include "adagen/constants.hpp"

namespace {


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
     {3.33333e-06, 0.0, 0.0, 0.0, 1.66667e-05, 0.0, 0.0, 0.0, 1.66667e-05}},
} };

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
     {0.0, -0.9999999999964793, -2.65358979335273e-06, 0.0, 2.65358979335273e-06, -0.9999999999964793, 1.0, 0.0, 0.0}, {0.0, 0.0, 0.13}},
} };

}  // namespace

// ---- 3. runtime ---------------------------------------------------------------------------------

#include "adagen/spatial.hpp"
#include "adagen/joins.hpp"
#include "adagen/inertia.hpp"
#include "adagen/articulated.hpp"

#include "adagen/no_channel.hpp"
#include "adagen/stamp.hpp"

// ---- 4. joints ----------------------------------------------------------------------------------

namespace {

// Memory of a process, joint by joint.
struct Workspace;

struct Joint_base_yaw {
  Transform X;  // parent link's to child link's frame
  Vec6 v;  // velocity of link "turret"
  Inertia IA;  // articulated-body inertia of link "turret"
  Columns6 pA;  // and its bias force
  Columns6 a;  // acceleration of the link, relative to free fall
  Articulated<Revolute> body;
};

struct Joint_shoulder_pitch {
  Transform X;  // parent link's to child link's frame
  Vec6 v;  // velocity of link "upper_arm"
  Inertia IA;  // articulated-body inertia of link "upper_arm"
  Columns6 pA;  // and its bias force
  Columns6 a;  // acceleration of the link, relative to free fall
  Articulated<Revolute> body;
};

struct Joint_upper_arm_roll {
  Transform X;  // parent link's to child link's frame
  Vec6 v;  // velocity of link "elbow_housing"
  Inertia IA;  // articulated-body inertia of link "elbow_housing"
  Columns6 pA;  // and its bias force
  Columns6 a;  // acceleration of the link, relative to free fall
  Articulated<Revolute> body;
};

struct Joint_elbow_pitch {
  Transform X;  // parent link's to child link's frame
  Vec6 v;  // velocity of link "forearm"
  Inertia IA;  // articulated-body inertia of link "forearm"
  Columns6 pA;  // and its bias force
  Columns6 a;  // acceleration of the link, relative to free fall
  Articulated<Revolute> body;
};

struct Joint_forearm_roll {
  Transform X;  // parent link's to child link's frame
  Vec6 v;  // velocity of link "wrist_housing"
  Inertia IA;  // articulated-body inertia of link "wrist_housing"
  Columns6 pA;  // and its bias force
  Columns6 a;  // acceleration of the link, relative to free fall
  Articulated<Revolute> body;
};

struct Joint_wrist_pitch {
  Transform X;  // parent link's to child link's frame
  Vec6 v;  // velocity of link "wrist"
  Inertia IA;  // articulated-body inertia of link "wrist"
  Columns6 pA;  // and its bias force
  Columns6 a;  // acceleration of the link, relative to free fall
  Articulated<Revolute> body;
};

struct Joint_flange_roll {
  Transform X;  // parent link's to child link's frame
  Vec6 v;  // velocity of link "hand"
  Inertia IA;  // articulated-body inertia of link "hand"
  Columns6 pA;  // and its bias force
  Columns6 a;  // acceleration of the link, relative to free fall
  Articulated<Revolute> body;
};

struct Joint_left_finger_slide {
  Transform X;  // parent link's to child link's frame
  Vec6 v;  // velocity of link "left_finger"
  Inertia IA;  // articulated-body inertia of link "left_finger"
  Columns6 pA;  // and its bias force
  Columns6 a;  // acceleration of the link, relative to free fall
  Articulated<Prismatic> body;
};

struct Joint_right_finger_slide {
  Transform X;  // parent link's to child link's frame
  Vec6 v;  // velocity of link "right_finger"
  Inertia IA;  // articulated-body inertia of link "right_finger"
  Columns6 pA;  // and its bias force
  Columns6 a;  // acceleration of the link, relative to free fall
  Articulated<Prismatic> body;
};

struct Workspace {
  const Number* q = nullptr;
  const Number* v = nullptr;
  const Number* tau = nullptr;
  Number* qdd = nullptr;
  int status = kFine;
  int near_lock = 0;  // 1 + the last joint of a run that has been near gimbal lock; 0: none
  Columns6 ground;  // its acceleration
  Joint_base_yaw j_base_yaw;
  Joint_shoulder_pitch j_shoulder_pitch;
  Joint_upper_arm_roll j_upper_arm_roll;
  Joint_elbow_pitch j_elbow_pitch;
  Joint_forearm_roll j_forearm_roll;
  Joint_wrist_pitch j_wrist_pitch;
  Joint_flange_roll j_flange_roll;
  Joint_left_finger_slide j_left_finger_slide;
  Joint_right_finger_slide j_right_finger_slide;

  EIGEN_MAKE_ALIGNED_OPERATOR_NEW
};

}  // namespace

#include "adagen/gravity.hpp"
#include "adagen/memory.hpp"
#include "adagen/exchange.hpp"

namespace {

const Inertia kInertia_turret = spatial_inertia(kLinks[1]);
const Inertia kInertia_upper_arm = spatial_inertia(kLinks[2]);
const Inertia kInertia_elbow_housing = spatial_inertia(kLinks[3]);
const Inertia kInertia_forearm = spatial_inertia(kLinks[4]);
const Inertia kInertia_wrist_housing = spatial_inertia(kLinks[5]);
const Inertia kInertia_wrist = spatial_inertia(kLinks[6]);
const Inertia kInertia_hand = spatial_inertia(kLinks[7]);
const Inertia kInertia_left_finger = spatial_inertia(kLinks[8]);
const Inertia kInertia_right_finger = spatial_inertia(kLinks[9]);

// =================================================================================================
// Joint 0 "base_yaw": revolute, between links "pedestal" and "turret"
// =================================================================================================

void kinematics_base_yaw(Workspace& w) {
  auto& i = w.j_base_yaw;
  require_finite(w, w.q + 0, 1, 0);
  require_finite(w, w.v + 0, 1, 0);
  const Real q = Real(w.q[0]);
  const Real c = std::cos(q), s = std::sin(q);
  i.X.E << c, s, 0.0,  //
      -s, c, 0.0,  //
      0.0, 0.0, 1.0;
  i.X.r << 0.0, 0.0, 0.16;
  i.v = joint_velocity<Revolute>(w.v + 0);
}

void articulate_base_yaw(Workspace& w) {
  auto& i = w.j_base_yaw;
  load_torque(w, 0, 0, i.body.tau);
  i.body.c = Columns6::Zero();
  Inertia handed;
  Columns6 force;
  if (!articulate(i.body, 1, i.IA, i.pA, handed, force))
    fail(w, kFactorization, 0);
}

void accelerate_base_yaw(Workspace& w) {
  auto& i = w.j_base_yaw;
  Columns6 a = i.X * w.ground;
  const auto qdd = accelerate(i.body, a);
  i.a = a;
  store_acceleration(w, 0, 0, qdd);
}

// =================================================================================================
// Joint 1 "shoulder_pitch": revolute, between links "turret" and "upper_arm"
// =================================================================================================

void kinematics_shoulder_pitch(Workspace& w) {
  auto& i = w.j_shoulder_pitch;
  require_finite(w, w.q + 1, 1, 1);
  require_finite(w, w.v + 1, 1, 1);
  const Real q = Real(w.q[1]);
  const Real c = std::cos(q), s = std::sin(q);
  i.X.E << c, -3.673205103346574e-06 * s, -0.9999999999932537 * s,  //
      -s, -3.673205103346574e-06 * c, -0.9999999999932537 * c,  //
      0.0, 0.9999999999932537, -3.673205103346574e-06;
  i.X.r << 0.0, 0.0, 0.18;
  i.v = i.X * w.j_base_yaw.v + joint_velocity<Revolute>(w.v + 1);
}

void articulate_shoulder_pitch(Workspace& w) {
  auto& i = w.j_shoulder_pitch;
  load_torque(w, 1, 1, i.body.tau);
  i.body.c = velocity_product<Revolute>(i.v, w.v + 1);
  Inertia handed;
  Columns6 force;
  if (!articulate(i.body, 1, i.IA, i.pA, handed, force))
    fail(w, kFactorization, 1);
  add_in_parent(i.X, handed, w.j_base_yaw.IA);
  w.j_base_yaw.pA += i.X.transposed_times(force);
}

void accelerate_shoulder_pitch(Workspace& w) {
  auto& i = w.j_shoulder_pitch;
  Columns6 a = i.X * w.j_base_yaw.a;
  const auto qdd = accelerate(i.body, a);
  i.a = a;
  store_acceleration(w, 1, 1, qdd);
}

// =================================================================================================
// Joint 2 "upper_arm_roll": revolute, between links "upper_arm" and "elbow_housing"
// =================================================================================================

void kinematics_upper_arm_roll(Workspace& w) {
  auto& i = w.j_upper_arm_roll;
  require_finite(w, w.q + 2, 1, 2);
  require_finite(w, w.v + 2, 1, 2);
  const Real q = Real(w.q[2]);
  const Real c = std::cos(q), s = std::sin(q);
  i.X.E << c, -3.673205103346574e-06 * s, 0.9999999999932537 * s,  //
      -s, -3.673205103346574e-06 * c, 0.9999999999932537 * c,  //
      0.0, -0.9999999999932537, -3.673205103346574e-06;
  i.X.r << 0.0, -0.3, 0.0;
  i.v = i.X * w.j_shoulder_pitch.v + joint_velocity<Revolute>(w.v + 2);
}

void articulate_upper_arm_roll(Workspace& w) {
  auto& i = w.j_upper_arm_roll;
  load_torque(w, 2, 2, i.body.tau);
  i.body.c = velocity_product<Revolute>(i.v, w.v + 2);
  Inertia handed;
  Columns6 force;
  if (!articulate(i.body, 1, i.IA, i.pA, handed, force))
    fail(w, kFactorization, 2);
  add_in_parent(i.X, handed, w.j_shoulder_pitch.IA);
  w.j_shoulder_pitch.pA += i.X.transposed_times(force);
}

void accelerate_upper_arm_roll(Workspace& w) {
  auto& i = w.j_upper_arm_roll;
  Columns6 a = i.X * w.j_shoulder_pitch.a;
  const auto qdd = accelerate(i.body, a);
  i.a = a;
  store_acceleration(w, 2, 2, qdd);
}

// =================================================================================================
// Joint 3 "elbow_pitch": revolute, between links "elbow_housing" and "forearm"
// =================================================================================================

void kinematics_elbow_pitch(Workspace& w) {
  auto& i = w.j_elbow_pitch;
  require_finite(w, w.q + 3, 1, 3);
  require_finite(w, w.v + 3, 1, 3);
  const Real q = Real(w.q[3]);
  const Real c = std::cos(q), s = std::sin(q);
  i.X.E << c, -3.673205103346574e-06 * s, 0.9999999999932537 * s,  //
      -s, -3.673205103346574e-06 * c, 0.9999999999932537 * c,  //
      0.0, -0.9999999999932537, -3.673205103346574e-06;
  i.X.r << 0.08, 0.0, 0.0;
  i.v = i.X * w.j_upper_arm_roll.v + joint_velocity<Revolute>(w.v + 3);
}

void articulate_elbow_pitch(Workspace& w) {
  auto& i = w.j_elbow_pitch;
  load_torque(w, 3, 3, i.body.tau);
  i.body.c = velocity_product<Revolute>(i.v, w.v + 3);
  Inertia handed;
  Columns6 force;
  if (!articulate(i.body, 1, i.IA, i.pA, handed, force))
    fail(w, kFactorization, 3);
  add_in_parent(i.X, handed, w.j_upper_arm_roll.IA);
  w.j_upper_arm_roll.pA += i.X.transposed_times(force);
}

void accelerate_elbow_pitch(Workspace& w) {
  auto& i = w.j_elbow_pitch;
  Columns6 a = i.X * w.j_upper_arm_roll.a;
  const auto qdd = accelerate(i.body, a);
  i.a = a;
  store_acceleration(w, 3, 3, qdd);
}

// =================================================================================================
// Joint 4 "forearm_roll": revolute, between links "forearm" and "wrist_housing"
// =================================================================================================

void kinematics_forearm_roll(Workspace& w) {
  auto& i = w.j_forearm_roll;
  require_finite(w, w.q + 4, 1, 4);
  require_finite(w, w.v + 4, 1, 4);
  const Real q = Real(w.q[4]);
  const Real c = std::cos(q), s = std::sin(q);
  i.X.E << c, -3.673205103346574e-06 * s, -0.9999999999932537 * s,  //
      -s, -3.673205103346574e-06 * c, -0.9999999999932537 * c,  //
      0.0, 0.9999999999932537, -3.673205103346574e-06;
  i.X.r << -0.08, 0.38, 0.0;
  i.v = i.X * w.j_elbow_pitch.v + joint_velocity<Revolute>(w.v + 4);
}

void articulate_forearm_roll(Workspace& w) {
  auto& i = w.j_forearm_roll;
  load_torque(w, 4, 4, i.body.tau);
  i.body.c = velocity_product<Revolute>(i.v, w.v + 4);
  Inertia handed;
  Columns6 force;
  if (!articulate(i.body, 1, i.IA, i.pA, handed, force))
    fail(w, kFactorization, 4);
  add_in_parent(i.X, handed, w.j_elbow_pitch.IA);
  w.j_elbow_pitch.pA += i.X.transposed_times(force);
}

void accelerate_forearm_roll(Workspace& w) {
  auto& i = w.j_forearm_roll;
  Columns6 a = i.X * w.j_elbow_pitch.a;
  const auto qdd = accelerate(i.body, a);
  i.a = a;
  store_acceleration(w, 4, 4, qdd);
}

// =================================================================================================
// Joint 5 "wrist_pitch": revolute, between links "wrist_housing" and "wrist"
// =================================================================================================

void kinematics_wrist_pitch(Workspace& w) {
  auto& i = w.j_wrist_pitch;
  require_finite(w, w.q + 5, 1, 5);
  require_finite(w, w.v + 5, 1, 5);
  const Real q = Real(w.q[5]);
  const Real c = std::cos(q), s = std::sin(q);
  i.X.E << c, -3.673205103346574e-06 * s, 0.9999999999932537 * s,  //
      -s, -3.673205103346574e-06 * c, 0.9999999999932537 * c,  //
      0.0, -0.9999999999932537, -3.673205103346574e-06;
  i.X.r << 0.0, 0.0, 0.0;
  i.v = i.X * w.j_forearm_roll.v + joint_velocity<Revolute>(w.v + 5);
}

void articulate_wrist_pitch(Workspace& w) {
  auto& i = w.j_wrist_pitch;
  load_torque(w, 5, 5, i.body.tau);
  i.body.c = velocity_product<Revolute>(i.v, w.v + 5);
  Inertia handed;
  Columns6 force;
  if (!articulate(i.body, 1, i.IA, i.pA, handed, force))
    fail(w, kFactorization, 5);
  add_in_parent(i.X, handed, w.j_forearm_roll.IA);
  w.j_forearm_roll.pA += i.X.transposed_times(force);
}

void accelerate_wrist_pitch(Workspace& w) {
  auto& i = w.j_wrist_pitch;
  Columns6 a = i.X * w.j_forearm_roll.a;
  const auto qdd = accelerate(i.body, a);
  i.a = a;
  store_acceleration(w, 5, 5, qdd);
}

// =================================================================================================
// Joint 6 "flange_roll": revolute, between links "wrist" and "hand"
// =================================================================================================

void kinematics_flange_roll(Workspace& w) {
  auto& i = w.j_flange_roll;
  require_finite(w, w.q + 6, 1, 6);
  require_finite(w, w.v + 6, 1, 6);
  const Real q = Real(w.q[6]);
  const Real c = std::cos(q), s = std::sin(q);
  i.X.E << c, -3.673205103346574e-06 * s, 0.9999999999932537 * s,  //
      -s, -3.673205103346574e-06 * c, 0.9999999999932537 * c,  //
      0.0, -0.9999999999932537, -3.673205103346574e-06;
  i.X.r << 0.09, 0.0, 0.0;
  i.v = i.X * w.j_wrist_pitch.v + joint_velocity<Revolute>(w.v + 6);
}

void articulate_flange_roll(Workspace& w) {
  auto& i = w.j_flange_roll;
  load_torque(w, 6, 6, i.body.tau);
  i.body.c = velocity_product<Revolute>(i.v, w.v + 6);
  Inertia handed;
  Columns6 force;
  if (!articulate(i.body, 1, i.IA, i.pA, handed, force))
    fail(w, kFactorization, 6);
  add_in_parent(i.X, handed, w.j_wrist_pitch.IA);
  w.j_wrist_pitch.pA += i.X.transposed_times(force);
}

void accelerate_flange_roll(Workspace& w) {
  auto& i = w.j_flange_roll;
  Columns6 a = i.X * w.j_wrist_pitch.a;
  const auto qdd = accelerate(i.body, a);
  i.a = a;
  store_acceleration(w, 6, 6, qdd);
}

// =================================================================================================
// Joint 7 "left_finger_slide": prismatic, between links "hand" and "left_finger"
// =================================================================================================

void kinematics_left_finger_slide(Workspace& w) {
  auto& i = w.j_left_finger_slide;
  require_finite(w, w.q + 7, 1, 7);
  require_finite(w, w.v + 7, 1, 7);
  const Real q = Real(w.q[7]);
  i.X.E << 0.0, 0.0, 1.0,  //
      1.0, 0.0, 0.0,  //
      0.0, 1.0, 0.0;
  i.X.r << 0.0, q, 0.13;
  i.v = i.X * w.j_flange_roll.v + joint_velocity<Prismatic>(w.v + 7);
}

void articulate_left_finger_slide(Workspace& w) {
  auto& i = w.j_left_finger_slide;
  load_torque(w, 7, 7, i.body.tau);
  i.body.c = velocity_product<Prismatic>(i.v, w.v + 7);
  Inertia handed;
  Columns6 force;
  if (!articulate(i.body, 1, i.IA, i.pA, handed, force))
    fail(w, kFactorization, 7);
  add_in_parent(i.X, handed, w.j_flange_roll.IA);
  w.j_flange_roll.pA += i.X.transposed_times(force);
}

void accelerate_left_finger_slide(Workspace& w) {
  auto& i = w.j_left_finger_slide;
  Columns6 a = i.X * w.j_flange_roll.a;
  const auto qdd = accelerate(i.body, a);
  i.a = a;
  store_acceleration(w, 7, 7, qdd);
}

// =================================================================================================
// Joint 8 "right_finger_slide": prismatic, between links "hand" and "right_finger"
// =================================================================================================

void kinematics_right_finger_slide(Workspace& w) {
  auto& i = w.j_right_finger_slide;
  require_finite(w, w.q + 8, 1, 8);
  require_finite(w, w.v + 8, 1, 8);
  const Real q = Real(w.q[8]);
  i.X.E << 0.0, 0.0, 1.0,  //
      -0.9999999999964793, 2.65358979335273e-06, 0.0,  //
      -2.65358979335273e-06, -0.9999999999964793, 0.0;
  i.X.r << -2.65358979335273e-06 * q, -0.9999999999964793 * q, 0.13;
  i.v = i.X * w.j_flange_roll.v + joint_velocity<Prismatic>(w.v + 8);
}

void articulate_right_finger_slide(Workspace& w) {
  auto& i = w.j_right_finger_slide;
  load_torque(w, 8, 8, i.body.tau);
  i.body.c = velocity_product<Prismatic>(i.v, w.v + 8);
  Inertia handed;
  Columns6 force;
  if (!articulate(i.body, 1, i.IA, i.pA, handed, force))
    fail(w, kFactorization, 8);
  add_in_parent(i.X, handed, w.j_flange_roll.IA);
  w.j_flange_roll.pA += i.X.transposed_times(force);
}

void accelerate_right_finger_slide(Workspace& w) {
  auto& i = w.j_right_finger_slide;
  Columns6 a = i.X * w.j_flange_roll.a;
  const auto qdd = accelerate(i.body, a);
  i.a = a;
  store_acceleration(w, 8, 8, qdd);
}


// ---- 5. processes -------------------------------------------------------------------------------

// Process 0: 9 of 9 joints: "base_yaw", "shoulder_pitch", "upper_arm_roll", "elbow_pitch", "forearm_roll", "wrist_pitch", ...
void run_0([[maybe_unused]] Workspace& w, [[maybe_unused]] Channel& channel) {
  w.ground = ground(w);
  stamp(0);
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

[[maybe_unused]] constexpr std::array<void (*)(Workspace&, Channel&), kProcesses> kRun{run_0};

}  // namespace

#include "adagen/alone.hpp"
struct arm7_p1_solver : Solver {};
#include "adagen/c_interface.hpp"

// ---- 6. program ---------------------------------------------------------------------------------
// Description of this solver for the program around it (adagen_program.cpp), the same for all robots.

#ifndef ADAGEN_NO_MAIN
#include "adagen/measured_alone.hpp"
#include "adagen/tell.hpp"

namespace {

constexpr std::array<adagen::Stage, 3> kStages_0{ {
    {"kinematics", 8, -1}, {"assembly", 0, -1}, {"disassembly", 0, -1},
} };
constexpr std::array<adagen::Table<adagen::Stage>, kProcesses> kStages{ {{kStages_0.data(), 3}} };

adagen::Description<Number> description() {
  return plain_description("arm7", kStages.data());
}

}  // namespace

#include "adagen/entry.hpp"
#endif  // ADAGEN_NO_MAIN
