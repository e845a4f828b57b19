// Forward dynamics of "mobile" on 3 processes, emitted by adagen 0.1.0 (solver.cpp.j2). Do not edit: generate again. Licence: yours to choose.
// robot     "mobile", 6 joints, 13 degrees of freedom, description sha256 421e40d13e3d94e0ea25fa3a829795267d134cdc98cb6abe58b7ec78cf6d9704
// command   adagen ../models/mobile.urdf --procs 3 --form=ada
// input     profile default, sha256 fe36af9ff4727e4941af0e7182db7f87cd64c54109bc287302f720e9ad83c3a8
// options   form ada (assembly-disassembly algorithm), shape joints (spatial vectors [angular; linear] in link frames whose joint axes are z), scalar double, channel auto, fixed base, gravity 0.0, 0.0, -9.81
// needs     Eigen's headers
// links     adagen_program.cpp -DADAGEN_MPI; or, compiled with -DADAGEN_NO_MAIN, a program of yours that includes mobile_p3.h
// program   3 processes, joined at cuts; 0.935 us predicted (default profile)
//           process 0: drive .. shoulder
//           process 1: wrist .. loose
//           process 2: nothing
// schedule  shoulder@0-2(lift@0(drive(|laser_spin)|) | wrist@1-2(|loose))
//
// Assembly-disassembly algorithm of Yamane and Nakamura. Phi are inverse articulated-body inertias, b
// bias accelerations. Joint i joins chain A (its parent link's side) and chain B (its child link's side)
// to chain C: assembly, Eq. (3)-(7), goes up the schedule, disassembly, Eq. (8)-(10), comes down.

#include "mobile_p3.h"
#define ADAGEN_CALL(word) mobile_p3_##word
#define ADAGEN_NAMED(WORD) MOBILE_P3_##WORD
#define ADAGEN_MPI
#include "adagen/settings.hpp"

namespace { struct mobile_p3_settings : PlainSettings {
  static constexpr int kVersion = 100, kJointCount = 6, kNq = 14, kNv = 13;
  [[maybe_unused]] static constexpr const char* kRobot = "mobile";
  static constexpr int kProcesses = 3;
  static constexpr bool kAlone = false;
  static constexpr int kPlanMessages = 2;
  [[maybe_unused]] static constexpr Hops kHops = {{0, 152, 0.404}, {20.9, 192, 0.602}};
}; }  // namespace: a program may load several solvers of one name

#include "adagen/constants.hpp"

constexpr std::array<LinkConstants, kLinkCount> kLinks{ {
    {"floor", 0.0, {0.0, 0.0, 0.0}},
    {"cart", 35.5, {-0.02799449804688646, 0.0, 0.21497801221230384},
     {2.082900209661478, 0.0, 0.33755007267889864, 0.0, 2.5480080181799307, 0.0, 0.33755007267889864, 0.0, 1.442107808518453},
     {0.49902918256322004, 0.0, -0.11680634127913112, 0.0, 0.3924634431544335, 0.0, -0.11680634127913112, 0.0, 0.7207699610585852}},
    {"laser", 0.35, {0.0, 0.0, -0.04},
     {0.000245, 0.0, 0.0, 0.0, 0.000245, 0.0, 0.0, 0.0, 0.00028},
     {4081.6326530612246, 0.0, 0.0, 0.0, 4081.6326530612246, 0.0, 0.0, 0.0, 3571.4285714285716}},
    {"carriage", 4.2, {0.08, 0.0, 0.0},
     {0.02086, 0.0, 0.0, 0.0, 0.01372, 0.0, 0.0, 0.0, 0.02086},
     {47.93863854266539, 0.0, 0.0, 0.0, 72.8862973760933, 0.0, 0.0, 0.0, 47.93863854266539}},
    {"boom", 2.4, {0.17560487334233152, 0.02197563328834232, 0.03286335345030997},
     {0.0031240337753782573, -0.002972881060907817, -0.0044457804600413296, -0.002972881060907817, 0.026507966224621746, -0.0005563560920082658, -0.0044457804600413296, -0.0005563560920082658, 0.026048},
     {497.5036858379399, 57.60325716354742, 86.14250953391092, 57.60325716354742, 44.41099670174264, 10.780089208369485, 86.14250953391092, 10.780089208369485, 53.323412698412696}},
    {"bowl", 0.9, {0.0, 0.0, 0.1},
     {0.0021075, 0.0, 0.0, 0.0, 0.00384, 0.0, 0.0, 0.0, 0.0021075},
     {474.4958481613286, 0.0, 0.0, 0.0, 260.4166666666667, 0.0, 0.0, 0.0, 474.4958481613286}},
    {"load", 0.6, {0.01, -0.02, 0.015},
     {0.0006, 0.0, 0.0, 0.0, 0.0006, 0.0, 0.0, 0.0, 0.0006},
     {1666.6666666666667, 0.0, 0.0, 0.0, 1666.6666666666667, 0.0, 0.0, 0.0, 1666.6666666666667}}}};

constexpr std::array<JointConstants, kJointCount> kJoints{ {
    {"drive", JointKind::kPlanar, 0, 0, 3, 0, 3,
     {1.0, 0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 1.0}, {0.0, 0.0, 0.0}},
    {"laser_spin", JointKind::kRevolute, 1, 3, 1, 3, 1,
     {1.0, 0.0, 0.0, 0.0, -1.0, 0.0, 0.0, 0.0, -1.0}, {0.22, 0.0, 0.23}},
    {"lift", JointKind::kPrismatic, 1, 4, 1, 4, 1,
     {0.9987502603949663, 0.0, 0.04997916927067833, 0.0, 1.0, 0.0, -0.04997916927067833, 0.0, 0.9987502603949663}, {-0.08507706744923418, 0.0, 0.31687627588325595}},
    {"shoulder", JointKind::kRevolute, 3, 5, 1, 5, 1,
     {0.9755826296796196, 0.12208685160190179, 0.18257418583505539, -0.12208685160190179, -0.3895657419904911, 0.9128709291752769, 0.18257418583505539, -0.9128709291752769, -0.36514837167011077}, {0.15, 0.0, 0.02}},
    {"wrist", JointKind::kRevolute, 4, 6, 1, 6, 1,
     {-0.4028214625008311, 0.04136261787763011, 0.9143434820629502, -0.4955543024180784, -0.8497464879390758, -0.17988007001927067, 0.7695198520529689, -0.5255663993041366, 0.3627935462750979}, {0.3707213992782555, 0.04639300360872268, 0.06937819061732105}},
    {"loose", JointKind::kFloating, 5, 7, 7, 7, 6,
     {-0.19866933079506122, 0.9362933635841992, -0.28962947762551555, 0.0, 0.29552020666133955, 0.955336489125606, 0.9800665778412416, 0.18979606097868743, -0.058710801693826524}, {0.0, 0.08, 0.1}}}};

[[maybe_unused]] constexpr std::array<MessageInfo, 6> kMessages{ {
    {1, 0, 27},  // 0: assembled: chain of "wrist"
    {0, 1, 6},  // 1: forces on: chain of "wrist"
    {0, 1, 32},  // 2: state
    {1, 0, 7},  // 3: accelerations
    {0, 2, 0},  // 4: state
    {2, 0, 0}}};  // 5: accelerations

// ---- functions ----------------------------------------------------------------------------------

#include "adagen/joins.hpp"
#include "adagen/channel.hpp"
#include "adagen/joints_memory.hpp"

namespace {

struct Joint_drive {
  Transform X;  // frame of "floor" to that of "cart"
  Vec6 v;  // velocity of link "cart"
  Columns6 b;  // bias of the bare link "cart"
  Mat6 Phi_cart;  // of the chain it completes
  Columns6 b_cart;
  Joined<Planar> joined;
  Coupled<Planar> at_cart;
  Columns6 F_on_cart;  // outer wrench on that chain
};

struct Joint_laser_spin {
  Transform X;  // frame of "cart" to that of "laser"
  Vec6 v;  // velocity of link "laser"
  Columns6 b;  // bias of the bare link "laser"
  Mat6 Phi_cart;  // of the chain it completes
  Columns6 b_cart;
  Joined<Revolute> joined;
  Coupled<Revolute> at_cart;
  Columns6 F_on_cart;  // outer wrench on that chain
};

struct Joint_lift {
  Transform X;  // frame of "cart" to that of "carriage"
  Vec6 v;  // velocity of link "carriage"
  Columns6 b;  // bias of the bare link "carriage"
  Mat6 Phi_carriage;  // of the chain it completes
  Columns6 b_carriage;
  Joined<Prismatic> joined;
  Coupled<Prismatic> at_carriage;
  Columns6 F_on_carriage;  // outer wrench on that chain
};

struct Joint_shoulder {
  Transform X;  // frame of "carriage" to that of "boom"
  Vec6 v;  // velocity of link "boom"
  Joined<Revolute> joined;
  Columns6 b;  // bias of the bare link "boom"
};

struct Joint_wrist {
  Transform X;  // frame of "boom" to that of "bowl"
  Vec6 v;  // velocity of link "bowl"
  Columns6 b;  // bias of the bare link "bowl"
  Mat6 Phi_boom;  // of the chain it completes
  Columns6 b_boom;
  Joined<Revolute> joined;
  Coupled<Revolute> at_boom;
  Columns6 F_on_boom;  // outer wrench on that chain
};

struct Joint_loose {
  Transform X;  // frame of "bowl" to that of "load"
  Vec6 v;  // velocity of link "load"
  Columns6 b;  // bias of the bare link "load"
  Mat6 Phi_bowl;  // of the chain it completes
  Columns6 b_bowl;
  Joined<Floating> joined;
  Coupled<Floating> at_bowl;
  Columns6 F_on_bowl;  // outer wrench on that chain
};

struct Workspace : JointsMemory {
  Joint_drive j_drive;  // and of link "cart"
  Joint_laser_spin j_laser_spin;  // and of link "laser"
  Joint_lift j_lift;  // and of link "carriage"
  Joint_shoulder j_shoulder;  // and of link "boom"
  Joint_wrist j_wrist;  // and of link "bowl"
  Joint_loose j_loose;  // and of link "load"
};

}  // namespace

#include "adagen/memory.hpp"
#include "adagen/exchange.hpp"

const Mat6 kPhi_cart = symmetric({0.49902918256322004, 0.0, -0.11680634127913112, 0.0, 0.10401036681056933, 0.0, 0.3924634431544335, 0.0, -0.08437101087533662, 0.0, -0.010986817092861124, 0.7207699610585852, 0.0, -0.0049332017948705885, 0.0, 0.04630692629082958, 0.0, 0.002361924099163447, 0.05039085348290442, 0.0, 0.02847658451415464});
const Mat6 kPhi_laser = symmetric({4081.6326530612246, 0.0, 0.0, 0.0, -163.26530612244898, 0.0, 4081.6326530612246, 0.0, 163.26530612244898, 0.0, 0.0, 3571.4285714285716, 0.0, 0.0, 0.0, 9.387755102040817, 0.0, 0.0, 9.387755102040817, 0.0, 2.857142857142857});
const Mat6 kPhi_carriage = symmetric({47.93863854266539, 0.0, 0.0, 0.0, 0.0, 0.0, 72.8862973760933, 0.0, 0.0, 0.0, 5.830903790087464, 47.93863854266539, 0.0, -3.8350910834132312, 0.0, 0.23809523809523808, 0.0, 0.0, 0.5449025247682966, 0.0, 0.7045675413022352});
const Mat6 kPhi_boom = symmetric({497.5036858379399, 57.60325716354742, 86.14250953391092, 1.8787996137760882e-16, 1.2225949944311751, -0.8175458812627366, 44.41099670174264, 10.780089208369485, -1.2225949944311743, 9.967199563138802e-17, 6.532919395176023, 53.323412698412696, 0.8175458812627351, -6.532919395176023, -2.8755195700899685e-16, 0.47481132657826264, -0.1435650409306874, -0.21469363914605485, 1.6040577210407847, -0.026867299257782407, 1.5818452380952377});
const Mat6 kPhi_bowl = symmetric({474.4958481613286, 0.0, 0.0, 0.0, 47.44958481613286, 0.0, 260.4166666666667, 0.0, -26.041666666666668, 0.0, 0.0, 474.4958481613286, 0.0, 0.0, 0.0, 3.715277777777778, 0.0, 0.0, 5.856069592724397, 0.0, 1.1111111111111112});
const Mat6 kPhi_load = symmetric({1666.6666666666667, 0.0, 0.0, 0.0, 25.0, 33.333333333333336, 1666.6666666666667, 0.0, -25.0, 0.0, 16.666666666666668, 1666.6666666666667, -33.333333333333336, -16.666666666666668, 0.0, 2.7083333333333335, 0.33333333333333337, -0.25, 2.2083333333333335, 0.5, 2.5});

// ---- joint 0 "drive": planar, between links "floor" and "cart"

static void kinematics_drive(Workspace& w) {
  auto& i = w.j_drive;
  require_finite(w, w.q + 0, 3, 0);
  require_finite(w, w.v + 0, 3, 0);
  const Number* const q = w.q + 0;
  const Real c = std::cos(q[2]), s = std::sin(q[2]);
  i.X.E << c, s, 0.0,  -s, c, 0.0,  0.0, 0.0, 1.0;  // row by row
  i.X.r << q[0], q[1], 0.0;
  i.v = joint_velocity<Planar>(w.v + 0);
}

// A: the ground "floor"; B: the chain of "laser_spin"; C feels the joint at "cart"
static void assemble_drive(Workspace& w) {
  auto& i = w.j_drive;
  load_torque(w, 0, 0, i.joined.tau);
  const Columns6 c = Columns6::Zero();
  constexpr std::array<Real, 6> least{7.091631212051937e-15, 5.577240971695595e-15, 1.024275719968536e-14, 6.580610018265472e-16, 7.160970978205855e-16, 4.0467660531582285e-16};
  if (!keeps_digits<Planar>(kZero, w.j_laser_spin.Phi_cart, least))
    fail(w, kGrowth, 0);
  if (!join(i.joined, kZero, w.j_laser_spin.Phi_cart, i.X * w.ground, w.j_laser_spin.b_cart, c))
    fail(w, kFactorization, 0);
  couple(i.joined, w.j_laser_spin.Phi_cart, i.at_cart);
  i.Phi_cart = w.j_laser_spin.Phi_cart - product(i.at_cart, i.at_cart);  // Eq. (4)
  i.b_cart = w.j_laser_spin.b_cart + bias_change(i.joined, i.at_cart);  // Eq. (7)
}

static void disassemble_drive(Workspace& w) {
  auto& i = w.j_drive;
  Release<Planar> release(i.joined);
  release.feel_B(i.at_cart, w.j_drive.F_on_cart);
  const Columns6 f = release.force();  // Eq. (8), (10)
  store_acceleration(w, 0, 0, release.qdd());  // Eq. (9)
  w.j_laser_spin.F_on_cart = w.j_drive.F_on_cart + f;
}

// ---- joint 1 "laser_spin": revolute, between links "cart" and "laser"

static void kinematics_laser_spin(Workspace& w) {
  auto& i = w.j_laser_spin;
  require_finite(w, w.q + 3, 1, 1);
  require_finite(w, w.v + 3, 1, 1);
  const Real q = Real(w.q[3]), c = std::cos(q), s = std::sin(q);
  i.X.E << c, -s, 0.0,  -s, -c, 0.0,  0.0, 0.0, -1.0;  // row by row
  i.X.r << 0.22, 0.0, 0.23;
  i.v = i.X * w.j_drive.v + joint_velocity<Revolute>(w.v + 3);
}

// A: link "cart"; B: link "laser"; C feels the joint at "cart"
static void assemble_laser_spin(Workspace& w) {
  auto& i = w.j_laser_spin;
  load_torque(w, 1, 3, i.joined.tau);
  const Mat6 X_Phi_A = i.X * kPhi_cart;
  const Mat6 Phi_A = from_right(X_Phi_A, i.X);
  const Columns6 c = velocity_product<Revolute>(i.v, w.v + 3);
  constexpr std::array<Real, 6> least{5.800582863301488e-11, 5.800582863301488e-11, 5.075539255383019e-11, 1.3380832962362383e-13, 1.3380832962362383e-13, 4.1002747810059705e-14};
  if (!keeps_digits<Revolute>(Phi_A, kPhi_laser, least))
    fail(w, kGrowth, 1);
  if (!join(i.joined, Phi_A, kPhi_laser, i.X * w.j_drive.b, w.j_laser_spin.b, c))
    fail(w, kFactorization, 1);
  couple(i.joined, X_Phi_A, i.at_cart);
  i.Phi_cart = kPhi_cart - product(i.at_cart, i.at_cart);  // Eq. (3)
  i.b_cart = w.j_drive.b - bias_change(i.joined, i.at_cart);  // Eq. (6)
}

static void disassemble_laser_spin(Workspace& w) {
  auto& i = w.j_laser_spin;
  Release<Revolute> release(i.joined);
  release.feel_A(i.at_cart, w.j_laser_spin.F_on_cart);
  release.force();  // Eq. (8)
  store_acceleration(w, 1, 3, release.qdd());  // Eq. (9)
}

// ---- joint 2 "lift": prismatic, between links "cart" and "carriage"

static void kinematics_lift(Workspace& w) {
  auto& i = w.j_lift;
  require_finite(w, w.q + 4, 1, 2);
  require_finite(w, w.v + 4, 1, 2);
  const Real q = Real(w.q[4]);
  i.X.E << 0.9987502603949663, 0.0, -0.04997916927067833,  0.0, 1.0, 0.0,  0.04997916927067833, 0.0, 0.9987502603949663;  // row by row
  i.X.r << -0.08507706744923418 + 0.04997916927067833 * q, 0.0, 0.31687627588325595 + 0.9987502603949663 * q;
  i.v = i.X * w.j_drive.v + joint_velocity<Prismatic>(w.v + 4);
}

// A: the chain of "drive"; B: link "carriage"; C feels the joint at "carriage"
static void assemble_lift(Workspace& w) {
  auto& i = w.j_lift;
  load_torque(w, 2, 4, i.joined.tau);
  const Mat6 X_Phi_A = i.X * w.j_drive.Phi_cart;
  const Mat6 Phi_A = from_right(X_Phi_A, i.X);
  const Columns6 c = velocity_product<Prismatic>(i.v, w.v + 4);
  constexpr std::array<Real, 6> least{6.835890271117182e-13, 1.038116582277988e-12, 6.835890271117182e-13, 3.783842603578267e-15, 8.143836380054432e-15, 1.041281273311856e-14};
  if (!keeps_digits<Prismatic>(Phi_A, kPhi_carriage, least))
    fail(w, kGrowth, 2);
  if (!join(i.joined, Phi_A, kPhi_carriage, i.X * w.j_drive.b_cart, w.j_lift.b, c))
    fail(w, kFactorization, 2);
  couple(i.joined, kPhi_carriage, i.at_carriage);
  i.Phi_carriage = kPhi_carriage - product(i.at_carriage, i.at_carriage);  // Eq. (4)
  i.b_carriage = w.j_lift.b + bias_change(i.joined, i.at_carriage);  // Eq. (7)
}

static void disassemble_lift(Workspace& w) {
  auto& i = w.j_lift;
  Release<Prismatic> release(i.joined);
  release.feel_B(i.at_carriage, w.j_lift.F_on_carriage);
  const Columns6 f = release.force();  // Eq. (8), (10)
  store_acceleration(w, 2, 4, release.qdd());  // Eq. (9)
  w.j_drive.F_on_cart = -i.X.transposed_times(f);
}

// ---- joint 3 "shoulder": revolute, between links "carriage" and "boom"

static void kinematics_shoulder(Workspace& w) {
  auto& i = w.j_shoulder;
  require_finite(w, w.q + 5, 1, 3);
  require_finite(w, w.v + 5, 1, 3);
  const Real q = Real(w.q[5]), c = std::cos(q), s = std::sin(q);
  i.X.E << 0.9755826296796196 * c + 0.12208685160190179 * s, -0.12208685160190179 * c - 0.3895657419904911 * s, 0.18257418583505539 * c - 0.9128709291752769 * s,  0.12208685160190179 * c - 0.9755826296796196 * s, -0.3895657419904911 * c + 0.12208685160190179 * s, -0.9128709291752769 * c - 0.18257418583505539 * s,  0.18257418583505539, 0.9128709291752769, -0.36514837167011077;  // row by row
  i.X.r << 0.15, 0.0, 0.02;
  i.v = i.X * w.j_lift.v + joint_velocity<Revolute>(w.v + 5);
}

// A: the chain of "lift"; B: the chain of "wrist"; C feels the joint at no link
static void assemble_shoulder(Workspace& w) {
  auto& i = w.j_shoulder;
  load_torque(w, 3, 5, i.joined.tau);
  const Mat6 X_Phi_A = i.X * w.j_lift.Phi_carriage;
  const Mat6 Phi_A = from_right(X_Phi_A, i.X);
  const Columns6 c = velocity_product<Revolute>(i.v, w.v + 5);
  constexpr std::array<Real, 6> least{7.326281147974468e-12, 8.874467701397844e-13, 1.014099819029905e-12, 1.0131011616088879e-14, 2.6178568065461474e-14, 2.5862909697458403e-14};
  if (!keeps_digits<Revolute>(Phi_A, w.j_wrist.Phi_boom, least))
    fail(w, kGrowth, 3);
  if (!join(i.joined, Phi_A, w.j_wrist.Phi_boom, i.X * w.j_lift.b_carriage, w.j_wrist.b_boom, c))
    fail(w, kFactorization, 3);
}

static void disassemble_shoulder(Workspace& w) {
  auto& i = w.j_shoulder;
  Release<Revolute> release(i.joined);
  const Columns6 f = release.force();  // Eq. (8), (10)
  store_acceleration(w, 3, 5, release.qdd());  // Eq. (9)
  w.j_lift.F_on_carriage = -i.X.transposed_times(f);
  w.j_wrist.F_on_boom = f;
}

// ---- joint 4 "wrist": revolute, between links "boom" and "bowl"

static void kinematics_wrist(Workspace& w) {
  auto& i = w.j_wrist;
  require_finite(w, w.q + 6, 1, 4);
  require_finite(w, w.v + 6, 1, 4);
  const Real q = Real(w.q[6]), c = std::cos(q), s = std::sin(q);
  i.X.E << -0.4028214625008311 * c + 0.04136261787763011 * s, -0.4955543024180784 * c - 0.8497464879390758 * s, 0.7695198520529689 * c - 0.5255663993041366 * s,  0.04136261787763011 * c + 0.4028214625008311 * s, -0.8497464879390758 * c + 0.4955543024180784 * s, -0.5255663993041366 * c - 0.7695198520529689 * s,  0.9143434820629502, -0.17988007001927067, 0.3627935462750979;  // row by row
  i.X.r << 0.3707213992782555, 0.04639300360872268, 0.06937819061732105;
  i.v = i.X * w.j_shoulder.v + joint_velocity<Revolute>(w.v + 6);
}

// A: link "boom"; B: the chain of "loose"; C feels the joint at "boom"
static void assemble_wrist(Workspace& w) {
  auto& i = w.j_wrist;
  load_torque(w, 4, 6, i.joined.tau);
  const Mat6 X_Phi_A = i.X * kPhi_boom;
  const Mat6 Phi_A = from_right(X_Phi_A, i.X);
  const Columns6 c = velocity_product<Revolute>(i.v, w.v + 6);
  constexpr std::array<Real, 6> least{6.998215245009065e-12, 3.9559670992390634e-12, 6.998215245009065e-12, 5.871846219128606e-14, 8.914094364898608e-14, 2.1711028037114174e-14};
  if (!keeps_digits<Revolute>(Phi_A, w.j_loose.Phi_bowl, least))
    fail(w, kGrowth, 4);
  if (!join(i.joined, Phi_A, w.j_loose.Phi_bowl, i.X * w.j_shoulder.b, w.j_loose.b_bowl, c))
    fail(w, kFactorization, 4);
  couple(i.joined, X_Phi_A, i.at_boom);
  i.Phi_boom = kPhi_boom - product(i.at_boom, i.at_boom);  // Eq. (3)
  i.b_boom = w.j_shoulder.b - bias_change(i.joined, i.at_boom);  // Eq. (6)
}

static void disassemble_wrist(Workspace& w) {
  auto& i = w.j_wrist;
  Release<Revolute> release(i.joined);
  release.feel_A(i.at_boom, w.j_wrist.F_on_boom);
  const Columns6 f = release.force();  // Eq. (8), (10)
  store_acceleration(w, 4, 6, release.qdd());  // Eq. (9)
  w.j_loose.F_on_bowl = f;
}

// ---- joint 5 "loose": floating, between links "bowl" and "load"

static void kinematics_loose(Workspace& w) {
  auto& i = w.j_loose;
  require_finite(w, w.q + 7, 7, 5);
  require_finite(w, w.v + 7, 6, 5);
  const Number* const q = w.q + 7;
  Mat3 Q;
  require_length(w, conjugate_rotation(q + 3, Q), 5);
  i.X.E << -0.19866933079506122 * Q(0, 0) + 0.9362933635841992 * Q(0, 1) - 0.28962947762551555 * Q(0, 2), 0.29552020666133955 * Q(0, 1) + 0.955336489125606 * Q(0, 2), 0.9800665778412416 * Q(0, 0) + 0.18979606097868743 * Q(0, 1) - 0.058710801693826524 * Q(0, 2),  -0.19866933079506122 * Q(1, 0) + 0.9362933635841992 * Q(1, 1) - 0.28962947762551555 * Q(1, 2), 0.29552020666133955 * Q(1, 1) + 0.955336489125606 * Q(1, 2), 0.9800665778412416 * Q(1, 0) + 0.18979606097868743 * Q(1, 1) - 0.058710801693826524 * Q(1, 2),  -0.19866933079506122 * Q(2, 0) + 0.9362933635841992 * Q(2, 1) - 0.28962947762551555 * Q(2, 2), 0.29552020666133955 * Q(2, 1) + 0.955336489125606 * Q(2, 2), 0.9800665778412416 * Q(2, 0) + 0.18979606097868743 * Q(2, 1) - 0.058710801693826524 * Q(2, 2);  // row by row
  i.X.r << -0.19866933079506122 * q[0] + 0.9362933635841992 * q[1] - 0.28962947762551555 * q[2], 0.08 + 0.29552020666133955 * q[1] + 0.955336489125606 * q[2], 0.1 + 0.9800665778412416 * q[0] + 0.18979606097868743 * q[1] - 0.058710801693826524 * q[2];
  i.v = i.X * w.j_wrist.v + joint_velocity<Floating>(w.v + 7);
}

// A: link "bowl"; B: link "load"; C feels the joint at "bowl"
static void assemble_loose(Workspace& w) {
  auto& i = w.j_loose;
  load_torque(w, 5, 7, i.joined.tau);
  const Mat6 X_Phi_A = i.X * kPhi_bowl;
  const Mat6 Phi_A = from_right(X_Phi_A, i.X);
  const Columns6 c = velocity_product<Floating>(i.v, w.v + 7);
  constexpr std::array<Real, 6> least{2.5448985632127736e-11, 2.5448985632127736e-11, 2.5448985632127736e-11, 5.4277570092785434e-14, 4.717214273518443e-14, 5.131697536045168e-14};
  if (!keeps_digits<Floating>(Phi_A, kPhi_load, least))
    fail(w, kGrowth, 5);
  if (!join(i.joined, Phi_A, kPhi_load, i.X * w.j_wrist.b, w.j_loose.b, c))
    fail(w, kFactorization, 5);
  couple(i.joined, X_Phi_A, i.at_bowl);
  i.Phi_bowl = kPhi_bowl - product(i.at_bowl, i.at_bowl);  // Eq. (3)
  i.b_bowl = w.j_wrist.b - bias_change(i.joined, i.at_bowl);  // Eq. (6)
}

static void disassemble_loose(Workspace& w) {
  auto& i = w.j_loose;
  Release<Floating> release(i.joined);
  release.feel_A(i.at_bowl, w.j_loose.F_on_bowl);
  release.force();  // Eq. (8)
  store_acceleration(w, 5, 7, release.qdd());  // Eq. (9)
}

// ---- processes ----------------------------------------------------------------------------------

// Process 0: 4 of 6 joints: "drive", "laser_spin", "lift", "shoulder"
static void run_0([[maybe_unused]] Workspace& w, [[maybe_unused]] Channel& channel) {
  w.ground = ground(w);
  kinematics_drive(w);
  kinematics_laser_spin(w);
  kinematics_lift(w);
  kinematics_shoulder(w);
  stamp(1);
  link_bias(kLinks[1], w.j_drive.v, w.j_drive.b);
  link_bias(kLinks[2], w.j_laser_spin.v, w.j_laser_spin.b);
  assemble_laser_spin(w);
  assemble_drive(w);
  link_bias(kLinks[3], w.j_lift.v, w.j_lift.b);
  assemble_lift(w);
  stamp(2);
  {  // from process 1: assembled: chain of "wrist"
    const Number* from = channel.receive(0, w.status);
    from = get_symmetric(from, w.j_wrist.Phi_boom);
    get(from, w.j_wrist.b_boom);
  }
  stamp(3);
  assemble_shoulder(w);
  stamp(4);
  disassemble_shoulder(w);
  stamp(5);
  {  // to process 1: forces on: chain of "wrist"
    Number* to = channel.outgoing(1, w.status);
    put(to, w.j_wrist.F_on_boom);
    channel.send(1, w.status);
  }
  stamp(6);
  disassemble_lift(w);
  disassemble_drive(w);
  disassemble_laser_spin(w);
  stamp(7);
}

// Process 1: 2 of 6 joints: "wrist", "loose"; kinematics of 3 more on the way to the ground
static void run_1([[maybe_unused]] Workspace& w, [[maybe_unused]] Channel& channel) {
  w.ground = ground(w);
  kinematics_drive(w);
  kinematics_lift(w);
  kinematics_shoulder(w);
  kinematics_wrist(w);
  kinematics_loose(w);
  stamp(1);
  link_bias(kLinks[5], w.j_wrist.v, w.j_wrist.b);
  link_bias(kLinks[6], w.j_loose.v, w.j_loose.b);
  assemble_loose(w);
  link_bias(kLinks[4], w.j_shoulder.v, w.j_shoulder.b);
  assemble_wrist(w);
  stamp(2);
  {  // to process 0: assembled: chain of "wrist"
    Number* to = channel.outgoing(0, w.status);
    to = put_symmetric(to, w.j_wrist.Phi_boom);
    put(to, w.j_wrist.b_boom);
    channel.send(0, w.status);
  }
  stamp(3);
  {  // from process 0: forces on: chain of "wrist"
    const Number* from = channel.receive(1, w.status);
    get(from, w.j_wrist.F_on_boom);
  }
  stamp(4);
  disassemble_wrist(w);
  disassemble_loose(w);
  stamp(5);
}

[[maybe_unused]] constexpr std::array<StageInfo, 7> kStages_0{ {
    {"kinematics", 3, -1}, {"assembly", 2, -1}, {"receive", -1, 0}, {"assembly", 3, -1},
    {"disassembly", 3, -1}, {"send", -1, 1}, {"disassembly", 2, -1}
} };
[[maybe_unused]] constexpr std::array<StageInfo, 5> kStages_1{ {
    {"kinematics", 5, -1}, {"assembly", 4, -1}, {"send", -1, 0}, {"receive", -1, 1},
    {"disassembly", 4, -1}
} };
[[maybe_unused]] constexpr std::array<void (*)(Workspace&, Channel&), kProcesses> kRun{run_0, run_1, kNothing};

constexpr std::array<Range, 4> kRanges_0{ {{0, 6}, {0, 6}, {0, 6}, {0, 6}} };
constexpr std::array<Range, 6> kRanges_1{ {{0, 3}, {4, 10}, {0, 3}, {4, 9}, {6, 7}, {6, 7}} };
[[maybe_unused]] constexpr std::array<ProcessInfo, kProcesses> kProcess{ {
    {{1, kRanges_0.data()}, {1, kRanges_0.data() + 1}, {1, kRanges_0.data() + 2}, {1, kRanges_0.data() + 3}, {7, kStages_0.data()}},
    {{2, kRanges_1.data()}, {2, kRanges_1.data() + 2}, {1, kRanges_1.data() + 4}, {1, kRanges_1.data() + 5}, {5, kStages_1.data()}},
    {}}};

#include "adagen/whole_mpi.hpp"
