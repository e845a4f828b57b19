// Forward dynamics of "arm7" on 2 processes, emitted by adagen 0.1.0 (solver.cpp.j2). Do not edit: generate again. Licence: yours to choose.
// robot     "arm7", 9 joints, 9 degrees of freedom, description sha256 35a799ae72b600eeca178cc12eccff22927d06b6ca76bda0ede3ef5832ebda29
// command   adagen ../models/arm7.urdf --mimic --procs 2 --form=ada --name=arm7_slaved
// input     profile default, sha256 fe36af9ff4727e4941af0e7182db7f87cd64c54109bc287302f720e9ad83c3a8
// options   form ada (assembly-disassembly algorithm), shape joints (spatial vectors [angular; linear] in link frames whose joint axes are z), scalar double, channel auto, fixed base, gravity 0.0, 0.0, -9.81
// needs     Eigen's headers
// links     adagen_program.cpp -DADAGEN_MPI; or, compiled with -DADAGEN_NO_MAIN, a program of yours that includes arm7_slaved_p2.h
// program   2 processes, joined at cuts; 1.7 us predicted (default profile)
//           process 0: base_yaw .. wrist_pitch
//           process 1: flange_roll .. right_finger_slide
// schedule  wrist_pitch@0-1(forearm_roll@0(elbow_pitch(upper_arm_roll(shoulder_pitch(base_yaw|)|)|)|) | flange_roll@1(|left_finger_slide(right_finger_slide|)))
//
// Assembly-disassembly algorithm of Yamane and Nakamura. Phi are inverse articulated-body inertias, b
// bias accelerations. Joint i joins chain A (its parent link's side) and chain B (its child link's side)
// to chain C: assembly, Eq. (3)-(7), goes up the schedule, disassembly, Eq. (8)-(10), comes down.

#include "arm7_slaved_p2.h"
#define ADAGEN_CALL(word) arm7_slaved_p2_##word
#define ADAGEN_NAMED(WORD) ARM7_SLAVED_P2_##WORD
#define ADAGEN_MPI
#include "adagen/settings.hpp"

namespace { struct arm7_slaved_p2_settings : PlainSettings {
  static constexpr int kVersion = 100, kJointCount = 9, kNq = 9, kNv = 9;
  [[maybe_unused]] static constexpr const char* kRobot = "arm7";
  static constexpr int kProcesses = 2;
  static constexpr bool kAlone = false;
  static constexpr int kColumns = 2;
  static constexpr std::size_t kSlavedCount = 1;
  static constexpr int kPlanMessages = 4;
  [[maybe_unused]] static constexpr Hops kHops = {{0, 152, 0.404}, {20.9, 192, 0.602}};
}; }  // namespace: a program may load several solvers of one name

#include "adagen/constants.hpp"

constexpr std::array<LinkConstants, kLinkCount> kLinks{ {
    {"pedestal", 0.0, {0.0, 0.0, 0.0}},
    {"turret", 3.6, {0.0, 0.0, 0.1},
     {0.01641, 0.0, 0.0, 0.0, 0.01641, 0.0, 0.0, 0.0, 0.00882},
     {60.93845216331505, 0.0, 0.0, 0.0, 60.93845216331505, 0.0, 0.0, 0.0, 113.37868480725623}},
    {"upper_arm", 3.1, {0.0, -0.1, 0.0},
     {0.01767, 0.0, 0.0, 0.0, 0.00558, 0.0, 0.0, 0.0, 0.01767},
     {56.59309564233163, 0.0, 0.0, 0.0, 179.2114695340502, 0.0, 0.0, 0.0, 56.59309564233163}},
    {"elbow_housing", 2.6, {0.0, 0.0, -0.03},
     {0.00898625, 0.0, 0.0, 0.0, 0.00898625, 0.0, 0.0, 0.0, 0.0039325},
     {111.2811239393518, 0.0, 0.0, 0.0, 111.2811239393518, 0.0, 0.0, 0.0, 254.29116338207245}},
    {"forearm", 2.2, {-0.05, 0.1, 0.0},
     {0.0102483, 0.0, 0.0, 0.0, 0.00275, 0.0, 0.0, 0.0, 0.0102483},
     {97.57715913858884, 0.0, 0.0, 0.0, 363.6363636363637, 0.0, 0.0, 0.0, 97.57715913858884}},
    {"wrist_housing", 1.7, {0.0, 0.01, -0.08},
     {0.00448729, 0.0, 0.0, 0.0, 0.00448729, 0.0, 0.0, 0.0, 0.00172125},
     {222.85165433925602, 0.0, 0.0, 0.0, 222.85165433925602, 0.0, 0.0, 0.0, 580.9731299927379}},
    {"wrist", 1.3, {0.04, 0.01, 0.0},
     {0.0013, 0.0, 0.0, 0.0, 0.0013, 0.0, 0.0, 0.0, 0.0013},
     {769.2307692307693, 0.0, 0.0, 0.0, 769.2307692307693, 0.0, 0.0, 0.0, 769.2307692307693}},
    {"hand", 0.85, {0.008470588235294117, 0.0, 0.08870588235294118},
     {0.0034019064705882356, 0.0, 0.0004946823529411765, 0.0, 0.0014865882352941176, 0.0, 0.0004946823529411765, 0.0, 0.0031133417647058823},
     {300.9051975855012, 0.0, -47.81116318204386, 0.0, 672.6812282367838, 0.0, -47.81116318204386, 0.0, 328.7950427750268}},
    {"left_finger", 0.05, {0.03, 0.0, 0.01},
     {3.33333e-06, 0.0, 0.0, 0.0, 1.66667e-05, 0.0, 0.0, 0.0, 1.66667e-05},
     {300000.3000003, 0.0, 0.0, 0.0, 59999.880000239995, 0.0, 0.0, 0.0, 59999.880000239995}},
    {"right_finger", 0.05, {0.03, 0.0, 0.01},
     {3.33333e-06, 0.0, 0.0, 0.0, 1.66667e-05, 0.0, 0.0, 0.0, 1.66667e-05},
     {300000.3000003, 0.0, 0.0, 0.0, 59999.880000239995, 0.0, 0.0, 0.0, 59999.880000239995}}}};

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
     {0.0, -0.9999999999964793, -2.65358979335273e-06, 0.0, 2.65358979335273e-06, -0.9999999999964793, 1.0, 0.0, 0.0}, {0.0, 0.0, 0.13}, 7, 1.0, 0.0}}};

[[maybe_unused]] constexpr std::array<MessageInfo, 6> kMessages{ {
    {1, 0, 33},  // 0: assembled: chain of "flange_roll"
    {0, 1, 12},  // 1: forces on: chain of "flange_roll"
    {1, 0, 4},  // 2: accelerations of slaved joints
    {0, 1, 1},  // 3: torques of slaved joints
    {0, 1, 19},  // 4: state
    {1, 0, 3}}};  // 5: accelerations

// ---- functions ----------------------------------------------------------------------------------

#include "adagen/joins.hpp"
#include "adagen/channel.hpp"
#include "adagen/joints_memory.hpp"

namespace {

struct Joint_base_yaw {
  Transform X;  // frame of "pedestal" to that of "turret"
  Vec6 v;  // velocity of link "turret"
  Columns6 b;  // bias of the bare link "turret"
  Mat6 Phi_turret;  // of the chain it completes
  Columns6 b_turret;
  Joined<Revolute> joined;
  Coupled<Revolute> at_turret;
  Columns6 F_on_turret;  // outer wrench on that chain
  std::array<std::array<Real, kColumns>, kFree<Revolute>> qdd;
};

struct Joint_shoulder_pitch {
  Transform X;  // frame of "turret" to that of "upper_arm"
  Vec6 v;  // velocity of link "upper_arm"
  Columns6 b;  // bias of the bare link "upper_arm"
  Mat6 Phi_upper_arm;  // of the chain it completes
  Columns6 b_upper_arm;
  Joined<Revolute> joined;
  Coupled<Revolute> at_upper_arm;
  Columns6 F_on_upper_arm;  // outer wrench on that chain
  std::array<std::array<Real, kColumns>, kFree<Revolute>> qdd;
};

struct Joint_upper_arm_roll {
  Transform X;  // frame of "upper_arm" to that of "elbow_housing"
  Vec6 v;  // velocity of link "elbow_housing"
  Columns6 b;  // bias of the bare link "elbow_housing"
  Mat6 Phi_elbow_housing;  // of the chain it completes
  Columns6 b_elbow_housing;
  Joined<Revolute> joined;
  Coupled<Revolute> at_elbow_housing;
  Columns6 F_on_elbow_housing;  // outer wrench on that chain
  std::array<std::array<Real, kColumns>, kFree<Revolute>> qdd;
};

struct Joint_elbow_pitch {
  Transform X;  // frame of "elbow_housing" to that of "forearm"
  Vec6 v;  // velocity of link "forearm"
  Columns6 b;  // bias of the bare link "forearm"
  Mat6 Phi_forearm;  // of the chain it completes
  Columns6 b_forearm;
  Joined<Revolute> joined;
  Coupled<Revolute> at_forearm;
  Columns6 F_on_forearm;  // outer wrench on that chain
  std::array<std::array<Real, kColumns>, kFree<Revolute>> qdd;
};

struct Joint_forearm_roll {
  Transform X;  // frame of "forearm" to that of "wrist_housing"
  Vec6 v;  // velocity of link "wrist_housing"
  Columns6 b;  // bias of the bare link "wrist_housing"
  Mat6 Phi_wrist_housing;  // of the chain it completes
  Columns6 b_wrist_housing;
  Joined<Revolute> joined;
  Coupled<Revolute> at_wrist_housing;
  Columns6 F_on_wrist_housing;  // outer wrench on that chain
  std::array<std::array<Real, kColumns>, kFree<Revolute>> qdd;
};

struct Joint_wrist_pitch {
  Transform X;  // frame of "wrist_housing" to that of "wrist"
  Vec6 v;  // velocity of link "wrist"
  Joined<Revolute> joined;
  Columns6 b;  // bias of the bare link "wrist"
  std::array<std::array<Real, kColumns>, kFree<Revolute>> qdd;
};

struct Joint_flange_roll {
  Transform X;  // frame of "wrist" to that of "hand"
  Vec6 v;  // velocity of link "hand"
  Columns6 b;  // bias of the bare link "hand"
  Mat6 Phi_wrist;  // of the chain it completes
  Columns6 b_wrist;
  Joined<Revolute> joined;
  Coupled<Revolute> at_wrist;
  Columns6 F_on_wrist;  // outer wrench on that chain
  std::array<std::array<Real, kColumns>, kFree<Revolute>> qdd;
};

struct Joint_left_finger_slide {
  Transform X;  // frame of "hand" to that of "left_finger"
  Vec6 v;  // velocity of link "left_finger"
  Columns6 b;  // bias of the bare link "left_finger"
  Mat6 Phi_hand;  // of the chain it completes
  Columns6 b_hand;
  Joined<Prismatic> joined;
  Coupled<Prismatic> at_hand;
  Columns6 F_on_hand;  // outer wrench on that chain
  std::array<std::array<Real, kColumns>, kFree<Prismatic>> qdd;
};

struct Joint_right_finger_slide {
  Transform X;  // frame of "hand" to that of "right_finger"
  Vec6 v;  // velocity of link "right_finger"
  Columns6 b;  // bias of the bare link "right_finger"
  Mat6 Phi_hand;  // of the chain it completes
  Columns6 b_hand;
  Joined<Prismatic> joined;
  Coupled<Prismatic> at_hand;
  Columns6 F_on_hand;  // outer wrench on that chain
  std::array<std::array<Real, kColumns>, kFree<Prismatic>> qdd;
};

struct Workspace : JointsMemory {
  std::array<Real, kColumns - 1> coupling{};  // coupling torques of slaved joints
  Joint_base_yaw j_base_yaw;  // and of link "turret"
  Joint_shoulder_pitch j_shoulder_pitch;  // and of link "upper_arm"
  Joint_upper_arm_roll j_upper_arm_roll;  // and of link "elbow_housing"
  Joint_elbow_pitch j_elbow_pitch;  // and of link "forearm"
  Joint_forearm_roll j_forearm_roll;  // and of link "wrist_housing"
  Joint_wrist_pitch j_wrist_pitch;  // and of link "wrist"
  Joint_flange_roll j_flange_roll;  // and of link "hand"
  Joint_left_finger_slide j_left_finger_slide;  // and of link "left_finger"
  Joint_right_finger_slide j_right_finger_slide;  // and of link "right_finger"
};

}  // namespace

#include "adagen/memory.hpp"
#include "adagen/coupling.hpp"
#include "adagen/exchange.hpp"

const Mat6 kPhi_turret = symmetric({60.93845216331505, 0.0, 0.0, 0.0, 6.0938452163315056, 0.0, 60.93845216331505, 0.0, -6.0938452163315056, 0.0, 0.0, 113.37868480725623, 0.0, 0.0, 0.0, 0.8871622994109283, 0.0, 0.0, 0.8871622994109283, 0.0, 0.2777777777777778});
const Mat6 kPhi_upper_arm = symmetric({56.59309564233163, 0.0, 0.0, 0.0, 0.0, 5.659309564233164, 179.2114695340502, 0.0, 0.0, 0.0, 0.0, 56.59309564233163, -5.659309564233164, 0.0, 0.0, 0.8885116015846066, 0.0, 0.0, 0.3225806451612903, 0.0, 0.8885116015846066});
const Mat6 kPhi_elbow_housing = symmetric({111.2811239393518, 0.0, 0.0, 0.0, -3.338433718180554, 0.0, 111.2811239393518, 0.0, 3.338433718180554, 0.0, 0.0, 254.29116338207245, 0.0, 0.0, 0.0, 0.4847683961608012, 0.0, 0.0, 0.4847683961608012, 0.0, 0.3846153846153846});
const Mat6 kPhi_forearm = symmetric({97.57715913858884, 0.0, 0.0, 0.0, 0.0, -9.757715913858885, 363.6363636363637, 0.0, 0.0, 0.0, -18.181818181818183, 97.57715913858884, 9.757715913858885, 4.878857956929442, 0.0, 1.430317045931343, 0.48788579569294427, 0.0, 0.6984883523919266, 0.0, 2.3394079550222524});
const Mat6 kPhi_wrist_housing = symmetric({222.85165433925602, 0.0, 0.0, 0.0, -17.828132347140482, -2.2285165433925602, 222.85165433925602, 0.0, 17.828132347140482, 0.0, 0.0, 580.9731299927379, 5.809731299927379, 0.0, 0.0, 2.0725831948881592, 0.0, 0.0, 2.0144858818888856, 0.17828132347140482, 0.6105204595515726});
const Mat6 kPhi_wrist = symmetric({769.2307692307693, 0.0, 0.0, 0.0, 0.0, -7.6923076923076925, 769.2307692307693, 0.0, 0.0, 0.0, 30.76923076923077, 769.2307692307693, 7.6923076923076925, -30.76923076923077, 0.0, 0.8461538461538461, -0.3076923076923077, 0.0, 2.0, 0.0, 2.076923076923077});
const Mat6 kPhi_hand = symmetric({300.9051975855012, 0.0, -47.81116318204386, 0.0, 27.097049732773534, 0.0, 672.6812282367838, 0.0, -59.67078189300412, 0.0, 5.698005698005698, 328.7950427750268, 0.0, -7.026218837536823, 0.0, 6.46961994674413, 0.0, -0.5054466230936819, 3.639654500566341, 0.0, 1.2247360482654601});
const Mat6 kPhi_left_finger = symmetric({300000.3000003, 0.0, 0.0, 0.0, 3000.003000003, 0.0, 59999.880000239995, 0.0, -599.9988000024, 0.0, 1799.9964000071998, 59999.880000239995, 0.0, -1799.9964000071998, 0.0, 25.999988000024, 0.0, -17.999964000071998, 103.99992200024599, 0.0, 73.999892000216});
const Mat6 kPhi_right_finger = symmetric({300000.3000003, 0.0, 0.0, 0.0, 3000.003000003, 0.0, 59999.880000239995, 0.0, -599.9988000024, 0.0, 1799.9964000071998, 59999.880000239995, 0.0, -1799.9964000071998, 0.0, 25.999988000024, 0.0, -17.999964000071998, 103.99992200024599, 0.0, 73.999892000216});

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

// A: the ground "pedestal"; B: link "turret"; C feels the joint at "turret"
static void assemble_base_yaw(Workspace& w) {
  auto& i = w.j_base_yaw;
  load_torque(w, 0, 0, i.joined.tau);
  const Columns6 c = Columns6::Zero();
  constexpr std::array<Real, 6> least{8.659874902621574e-13, 8.659874902621574e-13, 1.611208017596599e-12, 1.2607334545733242e-14, 1.2607334545733242e-14, 3.947459643111668e-15};
  if (!keeps_digits<Revolute>(kZero, kPhi_turret, least))
    fail(w, kGrowth, 0);
  if (!join(i.joined, kZero, kPhi_turret, i.X * w.ground, w.j_base_yaw.b, c))
    fail(w, kFactorization, 0);
  couple(i.joined, kPhi_turret, i.at_turret);
  i.Phi_turret = kPhi_turret - product(i.at_turret, i.at_turret);  // Eq. (4)
  i.b_turret = w.j_base_yaw.b + bias_change(i.joined, i.at_turret);  // Eq. (7)
}

static void disassemble_base_yaw(Workspace& w) {
  auto& i = w.j_base_yaw;
  Release<Revolute> release(i.joined);
  release.feel_B(i.at_turret, w.j_base_yaw.F_on_turret);
  release.force();  // Eq. (8)
  i.qdd = release.qdd();  // Eq. (9)
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

// A: the chain of "base_yaw"; B: link "upper_arm"; C feels the joint at "upper_arm"
static void assemble_shoulder_pitch(Workspace& w) {
  auto& i = w.j_shoulder_pitch;
  load_torque(w, 1, 1, i.joined.tau);
  const Mat6 X_Phi_A = i.X * w.j_base_yaw.Phi_turret;
  const Mat6 Phi_A = from_right(X_Phi_A, i.X);
  const Columns6 c = velocity_product<Revolute>(i.v, w.v + 1);
  constexpr std::array<Real, 6> least{1.1455151917378305e-12, 2.8880270885273612e-12, 1.1455151917378305e-12, 1.657396892600196e-14, 8.531606325434896e-15, 1.657396892600196e-14};
  if (!keeps_digits<Revolute>(Phi_A, kPhi_upper_arm, least))
    fail(w, kGrowth, 1);
  if (!join(i.joined, Phi_A, kPhi_upper_arm, i.X * w.j_base_yaw.b_turret, w.j_shoulder_pitch.b, c))
    fail(w, kFactorization, 1);
  couple(i.joined, kPhi_upper_arm, i.at_upper_arm);
  i.Phi_upper_arm = kPhi_upper_arm - product(i.at_upper_arm, i.at_upper_arm);  // Eq. (4)
  i.b_upper_arm = w.j_shoulder_pitch.b + bias_change(i.joined, i.at_upper_arm);  // Eq. (7)
}

static void disassemble_shoulder_pitch(Workspace& w) {
  auto& i = w.j_shoulder_pitch;
  Release<Revolute> release(i.joined);
  release.feel_B(i.at_upper_arm, w.j_shoulder_pitch.F_on_upper_arm);
  const Columns6 f = release.force();  // Eq. (8), (10)
  i.qdd = release.qdd();  // Eq. (9)
  w.j_base_yaw.F_on_turret = -i.X.transposed_times(f);
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

// A: the chain of "shoulder_pitch"; B: link "elbow_housing"; C feels the joint at "elbow_housing"
static void assemble_upper_arm_roll(Workspace& w) {
  auto& i = w.j_upper_arm_roll;
  load_torque(w, 2, 2, i.joined.tau);
  const Mat6 X_Phi_A = i.X * w.j_shoulder_pitch.Phi_upper_arm;
  const Mat6 Phi_A = from_right(X_Phi_A, i.X);
  const Columns6 c = velocity_product<Revolute>(i.v, w.v + 2);
  constexpr std::array<Real, 6> least{1.9286837244164575e-12, 1.9286837244164575e-12, 3.960978617752269e-12, 1.1473119930685861e-14, 1.1473119930685861e-14, 1.0049860034323996e-14};
  if (!keeps_digits<Revolute>(Phi_A, kPhi_elbow_housing, least))
    fail(w, kGrowth, 2);
  if (!join(i.joined, Phi_A, kPhi_elbow_housing, i.X * w.j_shoulder_pitch.b_upper_arm, w.j_upper_arm_roll.b, c))
    fail(w, kFactorization, 2);
  couple(i.joined, kPhi_elbow_housing, i.at_elbow_housing);
  i.Phi_elbow_housing = kPhi_elbow_housing - product(i.at_elbow_housing, i.at_elbow_housing);  // Eq. (4)
  i.b_elbow_housing = w.j_upper_arm_roll.b + bias_change(i.joined, i.at_elbow_housing);  // Eq. (7)
}

static void disassemble_upper_arm_roll(Workspace& w) {
  auto& i = w.j_upper_arm_roll;
  Release<Revolute> release(i.joined);
  release.feel_B(i.at_elbow_housing, w.j_upper_arm_roll.F_on_elbow_housing);
  const Columns6 f = release.force();  // Eq. (8), (10)
  i.qdd = release.qdd();  // Eq. (9)
  w.j_shoulder_pitch.F_on_upper_arm = -i.X.transposed_times(f);
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

// A: the chain of "upper_arm_roll"; B: link "forearm"; C feels the joint at "forearm"
static void assemble_elbow_pitch(Workspace& w) {
  auto& i = w.j_elbow_pitch;
  load_torque(w, 3, 3, i.joined.tau);
  const Mat6 X_Phi_A = i.X * w.j_upper_arm_roll.Phi_elbow_housing;
  const Mat6 Phi_A = from_right(X_Phi_A, i.X);
  const Columns6 c = velocity_product<Revolute>(i.v, w.v + 3);
  constexpr std::array<Real, 6> least{2.0354041913285566e-12, 5.816332892088654e-12, 2.0354041913285566e-12, 2.5791741088407997e-14, 1.5391829848103258e-14, 3.871069992040982e-14};
  if (!keeps_digits<Revolute>(Phi_A, kPhi_forearm, least))
    fail(w, kGrowth, 3);
  if (!join(i.joined, Phi_A, kPhi_forearm, i.X * w.j_upper_arm_roll.b_elbow_housing, w.j_elbow_pitch.b, c))
    fail(w, kFactorization, 3);
  couple(i.joined, kPhi_forearm, i.at_forearm);
  i.Phi_forearm = kPhi_forearm - product(i.at_forearm, i.at_forearm);  // Eq. (4)
  i.b_forearm = w.j_elbow_pitch.b + bias_change(i.joined, i.at_forearm);  // Eq. (7)
}

static void disassemble_elbow_pitch(Workspace& w) {
  auto& i = w.j_elbow_pitch;
  Release<Revolute> release(i.joined);
  release.feel_B(i.at_forearm, w.j_elbow_pitch.F_on_forearm);
  const Columns6 f = release.force();  // Eq. (8), (10)
  i.qdd = release.qdd();  // Eq. (9)
  w.j_upper_arm_roll.F_on_elbow_housing = -i.X.transposed_times(f);
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

// A: the chain of "elbow_pitch"; B: link "wrist_housing"; C feels the joint at "wrist_housing"
static void assemble_forearm_roll(Workspace& w) {
  auto& i = w.j_forearm_roll;
  load_torque(w, 4, 4, i.joined.tau);
  const Mat6 X_Phi_A = i.X * w.j_elbow_pitch.Phi_forearm;
  const Mat6 Phi_A = from_right(X_Phi_A, i.X);
  const Columns6 c = velocity_product<Revolute>(i.v, w.v + 4);
  constexpr std::array<Real, 6> least{3.7782214362185915e-12, 3.7782214362185915e-12, 8.867433697123973e-12, 3.591265808372574e-14, 3.508704560934945e-14, 1.513549696734667e-14};
  if (!keeps_digits<Revolute>(Phi_A, kPhi_wrist_housing, least))
    fail(w, kGrowth, 4);
  if (!join(i.joined, Phi_A, kPhi_wrist_housing, i.X * w.j_elbow_pitch.b_forearm, w.j_forearm_roll.b, c))
    fail(w, kFactorization, 4);
  couple(i.joined, kPhi_wrist_housing, i.at_wrist_housing);
  i.Phi_wrist_housing = kPhi_wrist_housing - product(i.at_wrist_housing, i.at_wrist_housing);  // Eq. (4)
  i.b_wrist_housing = w.j_forearm_roll.b + bias_change(i.joined, i.at_wrist_housing);  // Eq. (7)
}

static void disassemble_forearm_roll(Workspace& w) {
  auto& i = w.j_forearm_roll;
  Release<Revolute> release(i.joined);
  release.feel_B(i.at_wrist_housing, w.j_forearm_roll.F_on_wrist_housing);
  const Columns6 f = release.force();  // Eq. (8), (10)
  i.qdd = release.qdd();  // Eq. (9)
  w.j_elbow_pitch.F_on_forearm = -i.X.transposed_times(f);
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

// A: the chain of "forearm_roll"; B: the chain of "flange_roll"; C feels the joint at no link
static void assemble_wrist_pitch(Workspace& w) {
  auto& i = w.j_wrist_pitch;
  load_torque(w, 5, 5, i.joined.tau);
  const Mat6 X_Phi_A = i.X * w.j_forearm_roll.Phi_wrist_housing;
  const Mat6 Phi_A = from_right(X_Phi_A, i.X);
  const Columns6 c = velocity_product<Revolute>(i.v, w.v + 5);
  constexpr std::array<Real, 6> least{1.2260061762262752e-11, 1.2260061762262752e-11, 1.2260061762262752e-11, 2.0383895677461698e-14, 3.678103573346401e-14, 3.787417840386417e-14};
  if (!keeps_digits<Revolute>(Phi_A, w.j_flange_roll.Phi_wrist, least))
    fail(w, kGrowth, 5);
  if (!join(i.joined, Phi_A, w.j_flange_roll.Phi_wrist, i.X * w.j_forearm_roll.b_wrist_housing, w.j_flange_roll.b_wrist, c))
    fail(w, kFactorization, 5);
}

static void disassemble_wrist_pitch(Workspace& w) {
  auto& i = w.j_wrist_pitch;
  Release<Revolute> release(i.joined);
  const Columns6 f = release.force();  // Eq. (8), (10)
  i.qdd = release.qdd();  // Eq. (9)
  w.j_forearm_roll.F_on_wrist_housing = -i.X.transposed_times(f);
  w.j_flange_roll.F_on_wrist = f;
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

// A: link "wrist"; B: the chain of "left_finger_slide"; C feels the joint at "wrist"
static void assemble_flange_roll(Workspace& w) {
  auto& i = w.j_flange_roll;
  load_torque(w, 6, 6, i.joined.tau);
  const Mat6 X_Phi_A = i.X * kPhi_wrist;
  const Mat6 Phi_A = from_right(X_Phi_A, i.X);
  const Columns6 c = velocity_product<Revolute>(i.v, w.v + 6);
  constexpr std::array<Real, 6> least{7.919928947270557e-12, 1.3203184105450422e-11, 8.31626748528838e-12, 1.028702558297553e-13, 6.265402802508093e-14, 2.8335972750372623e-14};
  if (!keeps_digits<Revolute>(Phi_A, w.j_left_finger_slide.Phi_hand, least))
    fail(w, kGrowth, 6);
  if (!join(i.joined, Phi_A, w.j_left_finger_slide.Phi_hand, i.X * w.j_wrist_pitch.b, w.j_left_finger_slide.b_hand, c))
    fail(w, kFactorization, 6);
  couple(i.joined, X_Phi_A, i.at_wrist);
  i.Phi_wrist = kPhi_wrist - product(i.at_wrist, i.at_wrist);  // Eq. (3)
  i.b_wrist = w.j_wrist_pitch.b - bias_change(i.joined, i.at_wrist);  // Eq. (6)
}

static void disassemble_flange_roll(Workspace& w) {
  auto& i = w.j_flange_roll;
  Release<Revolute> release(i.joined);
  release.feel_A(i.at_wrist, w.j_flange_roll.F_on_wrist);
  const Columns6 f = release.force();  // Eq. (8), (10)
  i.qdd = release.qdd();  // Eq. (9)
  w.j_left_finger_slide.F_on_hand = f;
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

// A: the chain of "right_finger_slide"; B: link "left_finger"; C feels the joint at "hand"
static void assemble_left_finger_slide(Workspace& w) {
  auto& i = w.j_left_finger_slide;
  load_torque(w, 7, 7, i.joined.tau);
  i.joined.tau[0][1] = -1.0;
  const Mat6 X_Phi_A = i.X * w.j_right_finger_slide.Phi_hand;
  const Mat6 Phi_A = from_right(X_Phi_A, i.X);
  const Columns6 c = velocity_product<Prismatic>(i.v, w.v + 7);
  constexpr std::array<Real, 6> least{4.265036626975881e-09, 8.544255267675666e-10, 8.544255267675666e-10, 3.862007046714566e-13, 1.4946464345439562e-12, 1.0683203667618284e-12};
  if (!keeps_digits<Prismatic>(Phi_A, kPhi_left_finger, least))
    fail(w, kGrowth, 7);
  if (!join(i.joined, Phi_A, kPhi_left_finger, i.X * w.j_right_finger_slide.b_hand, w.j_left_finger_slide.b, c))
    fail(w, kFactorization, 7);
  couple(i.joined, X_Phi_A, i.at_hand);
  i.Phi_hand = w.j_right_finger_slide.Phi_hand - product(i.at_hand, i.at_hand);  // Eq. (3)
  i.b_hand = w.j_right_finger_slide.b_hand - bias_change(i.joined, i.at_hand);  // Eq. (6)
}

static void disassemble_left_finger_slide(Workspace& w) {
  auto& i = w.j_left_finger_slide;
  Release<Prismatic> release(i.joined);
  release.feel_A(i.at_hand, w.j_left_finger_slide.F_on_hand);
  const Columns6 f = release.force();  // Eq. (8), (10)
  i.qdd = release.qdd();  // Eq. (9)
  w.j_right_finger_slide.F_on_hand = w.j_left_finger_slide.F_on_hand - i.X.transposed_times(f);
}

// ---- joint 8 "right_finger_slide": prismatic, between links "hand" and "right_finger"

static void kinematics_right_finger_slide(Workspace& w) {
  auto& i = w.j_right_finger_slide;
  require_finite(w, w.q + 7, 1, 7);
  require_finite(w, w.v + 7, 1, 7);
  const Real q = w.q[7];  // slaved to "left_finger_slide"
  const Number qd = w.v[7];
  i.X.E << 0.0, 0.0, 1.0,  -0.9999999999964793, 2.65358979335273e-06, 0.0,  -2.65358979335273e-06, -0.9999999999964793, 0.0;  // row by row
  i.X.r << -2.65358979335273e-06 * q, -0.9999999999964793 * q, 0.13;
  i.v = i.X * w.j_flange_roll.v + joint_velocity<Prismatic>(&qd);
}

// A: link "hand"; B: link "right_finger"; C feels the joint at "hand"
static void assemble_right_finger_slide(Workspace& w) {
  auto& i = w.j_right_finger_slide;
  load_torque(w, 8, 8, i.joined.tau);
  i.joined.tau[0][1] = 1;
  const Mat6 X_Phi_A = i.X * kPhi_hand;
  const Mat6 Phi_A = from_right(X_Phi_A, i.X);
  const Number qd = w.v[7];
  const Columns6 c = velocity_product<Prismatic>(i.v, &qd);
  constexpr std::array<Real, 6> least{4.265036626975881e-09, 8.544255267675666e-10, 8.544255267675666e-10, 3.862007046714566e-13, 1.4946464345439562e-12, 1.0683203667618284e-12};
  if (!keeps_digits<Prismatic>(Phi_A, kPhi_right_finger, least))
    fail(w, kGrowth, 8);
  if (!join(i.joined, Phi_A, kPhi_right_finger, i.X * w.j_flange_roll.b, w.j_right_finger_slide.b, c))
    fail(w, kFactorization, 8);
  couple(i.joined, X_Phi_A, i.at_hand);
  i.Phi_hand = kPhi_hand - product(i.at_hand, i.at_hand);  // Eq. (3)
  i.b_hand = w.j_flange_roll.b - bias_change(i.joined, i.at_hand);  // Eq. (6)
}

static void disassemble_right_finger_slide(Workspace& w) {
  auto& i = w.j_right_finger_slide;
  Release<Prismatic> release(i.joined);
  release.feel_A(i.at_hand, w.j_right_finger_slide.F_on_hand);
  release.force();  // Eq. (8)
  i.qdd = release.qdd();  // Eq. (9)
}

// ---- processes ----------------------------------------------------------------------------------

// Process 0: 6 of 9 joints: "base_yaw", "shoulder_pitch", "upper_arm_roll", "elbow_pitch", "forearm_roll", "wrist_pitch"
static void run_0([[maybe_unused]] Workspace& w, [[maybe_unused]] Channel& channel) {
  w.ground = ground(w);
  kinematics_base_yaw(w);
  kinematics_shoulder_pitch(w);
  kinematics_upper_arm_roll(w);
  kinematics_elbow_pitch(w);
  kinematics_forearm_roll(w);
  kinematics_wrist_pitch(w);
  stamp(1);
  link_bias(kLinks[1], w.j_base_yaw.v, w.j_base_yaw.b);
  assemble_base_yaw(w);
  link_bias(kLinks[2], w.j_shoulder_pitch.v, w.j_shoulder_pitch.b);
  assemble_shoulder_pitch(w);
  link_bias(kLinks[3], w.j_upper_arm_roll.v, w.j_upper_arm_roll.b);
  assemble_upper_arm_roll(w);
  link_bias(kLinks[4], w.j_elbow_pitch.v, w.j_elbow_pitch.b);
  assemble_elbow_pitch(w);
  link_bias(kLinks[5], w.j_forearm_roll.v, w.j_forearm_roll.b);
  assemble_forearm_roll(w);
  stamp(2);
  {  // from process 1: assembled: chain of "flange_roll"
    const Number* from = channel.receive(0, w.status);
    from = get_symmetric(from, w.j_flange_roll.Phi_wrist);
    get(from, w.j_flange_roll.b_wrist);
  }
  stamp(3);
  assemble_wrist_pitch(w);
  stamp(4);
  disassemble_wrist_pitch(w);
  stamp(5);
  {  // to process 1: forces on: chain of "flange_roll"
    Number* to = channel.outgoing(1, w.status);
    put(to, w.j_flange_roll.F_on_wrist);
    channel.send(1, w.status);
  }
  stamp(6);
  disassemble_forearm_roll(w);
  disassemble_elbow_pitch(w);
  disassemble_upper_arm_roll(w);
  disassemble_shoulder_pitch(w);
  disassemble_base_yaw(w);
  stamp(7);
  {  // from process 1: accelerations of slaved joints
    const Number* from = channel.receive(2, w.status);
    from = get(from, w.j_left_finger_slide.qdd[0]);
    get(from, w.j_right_finger_slide.qdd[0]);
  }
  stamp(8);
  {
    std::array<std::array<Real, kColumns>, kColumns - 1> rows;
    coupling_row(rows[0], w.j_right_finger_slide.qdd[0], w.j_left_finger_slide.qdd[0], 1.0);
    solve_coupling(w, 8, rows, w.coupling);
  }
  stamp(9);
  {  // to process 1: torques of slaved joints
    Number* to = channel.outgoing(3, w.status);
    put(to, w.coupling);
    channel.send(3, w.status);
  }
  stamp(10);
  store_coupled(w, 0, 0, w.j_base_yaw.qdd, w.coupling);
  store_coupled(w, 1, 1, w.j_shoulder_pitch.qdd, w.coupling);
  store_coupled(w, 2, 2, w.j_upper_arm_roll.qdd, w.coupling);
  store_coupled(w, 3, 3, w.j_elbow_pitch.qdd, w.coupling);
  store_coupled(w, 4, 4, w.j_forearm_roll.qdd, w.coupling);
  store_coupled(w, 5, 5, w.j_wrist_pitch.qdd, w.coupling);
  stamp(11);
}

// Process 1: 3 of 9 joints: "flange_roll", "left_finger_slide", "right_finger_slide"; kinematics of 6 more on the way to the ground
static void run_1([[maybe_unused]] Workspace& w, [[maybe_unused]] Channel& channel) {
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
  link_bias(kLinks[7], w.j_flange_roll.v, w.j_flange_roll.b);
  link_bias(kLinks[9], w.j_right_finger_slide.v, w.j_right_finger_slide.b);
  assemble_right_finger_slide(w);
  link_bias(kLinks[8], w.j_left_finger_slide.v, w.j_left_finger_slide.b);
  assemble_left_finger_slide(w);
  link_bias(kLinks[6], w.j_wrist_pitch.v, w.j_wrist_pitch.b);
  assemble_flange_roll(w);
  stamp(2);
  {  // to process 0: assembled: chain of "flange_roll"
    Number* to = channel.outgoing(0, w.status);
    to = put_symmetric(to, w.j_flange_roll.Phi_wrist);
    put(to, w.j_flange_roll.b_wrist);
    channel.send(0, w.status);
  }
  stamp(3);
  {  // from process 0: forces on: chain of "flange_roll"
    const Number* from = channel.receive(1, w.status);
    get(from, w.j_flange_roll.F_on_wrist);
  }
  stamp(4);
  disassemble_flange_roll(w);
  disassemble_left_finger_slide(w);
  disassemble_right_finger_slide(w);
  stamp(5);
  {  // to process 0: accelerations of slaved joints
    Number* to = channel.outgoing(2, w.status);
    to = put(to, w.j_left_finger_slide.qdd[0]);
    put(to, w.j_right_finger_slide.qdd[0]);
    channel.send(2, w.status);
  }
  stamp(6);
  {  // from process 0: torques of slaved joints
    const Number* from = channel.receive(3, w.status);
    get(from, w.coupling);
  }
  stamp(7);
  store_coupled(w, 6, 6, w.j_flange_roll.qdd, w.coupling);
  store_coupled(w, 7, 7, w.j_left_finger_slide.qdd, w.coupling);
  store_coupled(w, 8, 8, w.j_right_finger_slide.qdd, w.coupling);
  stamp(8);
}

[[maybe_unused]] constexpr std::array<StageInfo, 11> kStages_0{ {
    {"kinematics", 5, -1}, {"assembly", 4, -1}, {"receive", -1, 0}, {"assembly", 5, -1},
    {"disassembly", 5, -1}, {"send", -1, 1}, {"disassembly", 4, -1}, {"receive", -1, 2},
    {"slaved", -1, -1}, {"send", -1, 3}, {"slaved", -1, -1}
} };
[[maybe_unused]] constexpr std::array<StageInfo, 8> kStages_1{ {
    {"kinematics", 8, -1}, {"assembly", 6, -1}, {"send", -1, 0}, {"receive", -1, 1},
    {"disassembly", 6, -1}, {"send", -1, 2}, {"receive", -1, 3}, {"slaved", -1, -1}
} };
[[maybe_unused]] constexpr std::array<void (*)(Workspace&, Channel&), kProcesses> kRun{run_0, run_1};

constexpr std::array<Range, 4> kRanges_0{ {{0, 6}, {0, 6}, {0, 6}, {0, 6}} };
constexpr std::array<Range, 4> kRanges_1{ {{0, 8}, {0, 8}, {6, 3}, {6, 3}} };
[[maybe_unused]] constexpr std::array<ProcessInfo, kProcesses> kProcess{ {
    {{1, kRanges_0.data()}, {1, kRanges_0.data() + 1}, {1, kRanges_0.data() + 2}, {1, kRanges_0.data() + 3}, {11, kStages_0.data()}},
    {{1, kRanges_1.data()}, {1, kRanges_1.data() + 1}, {1, kRanges_1.data() + 2}, {1, kRanges_1.data() + 3}, {8, kStages_1.data()}}}};

#include "adagen/whole_mpi.hpp"
