// Forward dynamics of "arm7" on 2 processes, emitted by adagen 0.1.0 (solver.cpp.j2). Do not edit: generate again. Licence: yours to choose.
// robot     "arm7", 9 joints, 9 degrees of freedom, description sha256 35a799ae72b600eeca178cc12eccff22927d06b6ca76bda0ede3ef5832ebda29
// command   adagen ../models/arm7.urdf --procs 2 --schedule=balanced --shape=kernels --refine=1 --name=arm7_refined
// input     profile default, sha256 fe36af9ff4727e4941af0e7182db7f87cd64c54109bc287302f720e9ad83c3a8
// options   form segment (articulated-body algorithm), shape kernels (spatial vectors [angular; linear] in the axes of the base, about each link's origin), scalar double, refine 1 (wide residual), channel auto, fixed base, gravity 0.0, 0.0, -9.81
// needs     Eigen's headers
// links     adagen_program.cpp -DADAGEN_MPI; or, compiled with -DADAGEN_NO_MAIN, a program of yours that includes arm7_refined_p2.h
// program   2 processes, joined at cuts; 0.765 us predicted (default profile)
//           process 0: base_yaw .. forearm_roll
//           process 1: left_finger_slide | right_finger_slide in 2 lanes, wrist_pitch .. flange_roll
// schedule  forearm_roll@0-1(shoulder_pitch@0(base_yaw | upper_arm_roll(|elbow_pitch)) | flange_roll@1(wrist_pitch | left_finger_slide(right_finger_slide|)))
//
// Each process solves a segment of the robot with the articulated-body algorithm: the articulated-body
// inertias I^A and bias forces p^A (IA, pA) are computed from the ends to the segment's root, then the
// accelerations from there outwards. Where segments meet, the assembly-disassembly algorithm of Yamane
// and Nakamura joins them: Phi = (I^A)^-1 and b are a segment's inverse inertia and bias acceleration at
// a cut; joint i joins chain A (on its parent link's side) and chain B (on its child link's side), Eq.
// (3)-(7), and its force follows from Eq. (8)-(10).

#include "arm7_refined_p2.h"
#define ADAGEN_CALL(word) arm7_refined_p2_##word
#define ADAGEN_NAMED(WORD) ARM7_REFINED_P2_##WORD
#define ADAGEN_MPI
#define ADAGEN_REFINES
#include "adagen/kernels/plain_loops.hpp"

namespace { struct arm7_refined_p2_settings : PlainLoops<9> {
  static constexpr int kVersion = 100, kJointCount = 9, kNq = 9, kNv = 9;
  [[maybe_unused]] static constexpr const char* kRobot = "arm7";
  static constexpr int kProcesses = 2;
  static constexpr bool kAlone = false;
  static constexpr int kRefine = 1;
  static constexpr bool kWide = true;
  static constexpr int kPlanMessages = 2;
  [[maybe_unused]] static constexpr Hops kHops = {{0, 152, 0.404}, {20.9, 192, 0.602}};
  static constexpr int kSlotCount = 12;
  static constexpr bool kReordered = true;
  static constexpr int kSlots[kJointCount] = {0, 1, 2, 3, 4, 10, 11, 8, 9};
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

[[maybe_unused]] constexpr std::array<MessageInfo, 7> kMessages{ {
    {1, 0, 27},  // 0: assembled: chain of "flange_roll"
    {0, 1, 6},  // 1: forces on: chain of "flange_roll"
    {0, 1, 22},  // 2: state
    {1, 0, 4},  // 3: accelerations
    {0, 1, 11},  // 4: step of refinement
    {1, 0, 3},  // 5: energies
    {0, 1, 2}}};  // 6: size of the correction

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

constexpr LinkRole kRoles[2][kLinkCount]{
    {{1, 0, 1, 0}, {0, 1, 0, 0}, {0, 1, 0, 0}, {0, 1, 0, 0}, {0, 1, 0, 0}, {0, 0, 0, 0}, {0, 0, 0, 0}, {0, 0, 0, 0}, {0, 0, 0, 0}, {0, 0, 0, 0}},
    {{0, 0, 0, 0}, {0, 0, 0, 0}, {0, 0, 0, 0}, {0, 0, 0, 0}, {0, 0, 0, 0}, {1, 1, 1, 0}, {0, 1, 0, 0}, {1, 1, 1, 0}, {0, 1, 0, 0}, {0, 1, 0, 0}}};

// ---- functions ----------------------------------------------------------------------------------

#include "adagen/spatial.hpp"
#include "adagen/joins.hpp"
#include "adagen/wide.hpp"
#include "adagen/refine.hpp"
#include "adagen/channel.hpp"
#include "adagen/kernels/state.hpp"

namespace {

// Memory where segments meet, by joint.
struct Joint_shoulder_pitch {
  Mat6 Phi_forearm;
  Columns6 b_forearm;
  Columns6 F_on_forearm;
};
struct Joint_forearm_roll {
  Transform X, Y;  // to the joint's frame, about its two links' origins
  Joined<Revolute> joined;
};
struct Joint_flange_roll {
  Mat6 Phi_wrist_housing;
  Columns6 b_wrist_housing;
  Columns6 F_on_wrist_housing;
};
struct Cuts {
  Joint_shoulder_pitch j_shoulder_pitch;
  Joint_forearm_roll j_forearm_roll;
  Joint_flange_roll j_flange_roll;
  std::array<Columns6, kLinkCount> loads;  // wrenches on links, from handle forces
  Refinement refinement;
  EIGEN_MAKE_ALIGNED_OPERATOR_NEW
};

}  // namespace

#include "adagen/kernels/inertias.hpp"
#include "adagen/kernels/keep.hpp"
#include "adagen/kernels/reach_nothing.hpp"
#include "adagen/kernels/sweeps.hpp"
#include "adagen/kernels/inward_columns.hpp"
#include "adagen/kernels/groups.hpp"
#include "adagen/kernels/mobility.hpp"
#include "adagen/kernels/wrenches.hpp"
#include "adagen/kernels/carry.hpp"
#include "adagen/exchange.hpp"

// "left_finger_slide", "right_finger_slide"
constexpr Limbs<2, 1> kLimbs0{8, {{7, 8}}};

// ---- processes ----------------------------------------------------------------------------------

// Process 0: 5 of 9 joints: "base_yaw", "shoulder_pitch", "upper_arm_roll", "elbow_pitch", "forearm_roll"
static void run_0([[maybe_unused]] Workspace& w, [[maybe_unused]] Channel& channel) {
  require_finite(w, w.q, 0, 5, &JointConstants::q, kNotFinite);
  require_finite(w, w.v, 0, 5, &JointConstants::v, kNotFinite);
  require_finite(w, w.tau, 0, 5, &JointConstants::v, kNotFinite);
  take_angles<0, 4>(w);
  turn<block(0), block(4) + 1>(w);
  outward<0, 4>(w);  // "base_yaw" .. "forearm_roll"
  stamp(1);
  set_up_links<block(0), block(3) + 1>(w);
  set_up_columns<block(0), block(3) + 1>(w);
  inward_in_columns<0, 0, 3, true>(w);  // "base_yaw" .. "elbow_pitch"
  {  // "base_yaw" .. "elbow_pitch"
    const Way way_0 = carry<false, 0, 3>(w);
    show<4>(w, way_0, w.j_shoulder_pitch.Phi_forearm, w.j_shoulder_pitch.b_forearm);
  }
  stamp(2);
  {  // from process 1: assembled: chain of "flange_roll"
    const Number* from = channel.receive(0, w.status);
    from = get_symmetric(from, w.j_flange_roll.Phi_wrist_housing);
    get(from, w.j_flange_roll.b_wrist_housing);
  }
  stamp(3);
  {
    auto& i = w.j_forearm_roll;
    set_transforms(w, 4, i.X, i.Y);
    load_torque(w, 4, 4, i.joined.tau);
    const Mat6 X_Phi_A = i.X * w.j_shoulder_pitch.Phi_forearm;
    const Mat6 Phi_A = from_right(X_Phi_A, i.X);
    const Mat6 Phi_B = from_right(i.Y * w.j_flange_roll.Phi_wrist_housing, i.Y);
    const Columns6 c = Columns6::Zero();
    if (!join(i.joined, Phi_A, Phi_B, i.X * w.j_shoulder_pitch.b_forearm, i.Y * w.j_flange_roll.b_wrist_housing, c))
      fail(w, kFactorization, 4);
  }
  stamp(4);
  {
    auto& i = w.j_forearm_roll;
    Release<Revolute> release(i.joined);
    const Columns6 f = release.force();  // Eq. (8), (10)
    w.refinement.f[4].col(w.refinement.side) = f;
    store_acceleration(w, 4, 4, release.qdd());  // Eq. (9)
    w.j_shoulder_pitch.F_on_forearm = -i.X.transposed_times(f);
    w.j_flange_roll.F_on_wrist_housing = i.Y.transposed_times(f);
  }
  stamp(5);
  {  // to process 1: forces on: chain of "flange_roll"
    Number* to = channel.outgoing(1, w.status);
    put(to, w.j_flange_roll.F_on_wrist_housing);
    channel.send(1, w.status);
  }
  stamp(6);
  w.loads[4] = in_base(w, 4, w.j_shoulder_pitch.F_on_forearm);
  deliver<0, 3, true>(w);  // "base_yaw" .. "elbow_pitch"
  accelerate<0, 0, 3>(w);  // "base_yaw" .. "elbow_pitch"
  stamp(7);
  require_finite(w, w.answer.data(), 0, 5, &JointConstants::v, kOverflow);
  give(w, 0, 5);
}

// Process 1: 4 of 9 joints: "wrist_pitch", "flange_roll", "left_finger_slide", "right_finger_slide"; kinematics of 5 more on the way to the ground
static void run_1([[maybe_unused]] Workspace& w, [[maybe_unused]] Channel& channel) {
  require_finite(w, w.q, 0, 9, &JointConstants::q, kNotFinite);
  require_finite(w, w.v, 0, 9, &JointConstants::v, kNotFinite);
  require_finite(w, w.tau, 5, 4, &JointConstants::v, kNotFinite);
  take_angles<0, 8>(w);
  turn<block(0), block(11) + 1>(w);
  pass_outward<0, 4>(w);  // "base_yaw" .. "forearm_roll"
  outward<5, 6>(w);  // "wrist_pitch" .. "flange_roll"
  outward_group<kLimbs0>(w);
  stamp(1);
  set_up_links<block(4), block(11) + 1>(w);
  {
    const auto X = inward_group<1, kLimbs0>(w);
    leave<true>(w, 7, lane(X, 0));
    leave<false>(w, 7, lane(X, 1));
  }
  inward<1, 5, 6, true>(w);  // "wrist_pitch" .. "flange_roll"
  invert_root<1, 5>(w, w.j_flange_roll.Phi_wrist_housing, w.j_flange_roll.b_wrist_housing);
  stamp(2);
  {  // to process 0: assembled: chain of "flange_roll"
    Number* to = channel.outgoing(0, w.status);
    to = put_symmetric(to, w.j_flange_roll.Phi_wrist_housing);
    put(to, w.j_flange_roll.b_wrist_housing);
    channel.send(0, w.status);
  }
  stamp(3);
  {  // from process 0: forces on: chain of "flange_roll"
    const Number* from = channel.receive(1, w.status);
    get(from, w.j_flange_roll.F_on_wrist_housing);
  }
  stamp(4);
  w.loads[5] = in_base(w, 5, w.j_flange_roll.F_on_wrist_housing);
  accelerate_root<5>(w, w.j_flange_roll.Phi_wrist_housing, w.j_flange_roll.b_wrist_housing);
  accelerate<1, 5, 6>(w);  // "wrist_pitch" .. "flange_roll"
  accelerate_group<1, kLimbs0>(w);
  stamp(5);
  require_finite(w, w.answer.data(), 5, 4, &JointConstants::v, kOverflow);
  give(w, 5, 4);
}

// ---- refinement ---------------------------------------------------------------------------------

// Process 0, a correction: its steps with the stored factors, for the residual forces at
// the links.
static void correct_0([[maybe_unused]] Workspace& w, [[maybe_unused]] Channel& channel) {
  set_up_columns<block(0), block(3) + 1>(w);
  inward_in_columns<0, 0, 3, true>(w);  // "base_yaw" .. "elbow_pitch"
  {  // "base_yaw" .. "elbow_pitch"
    const Way way_0 = carry<false, 0, 3>(w);
    show<4>(w, way_0, w.j_shoulder_pitch.Phi_forearm, w.j_shoulder_pitch.b_forearm);
  }
  {  // from process 1: assembled: chain of "flange_roll"
    const Number* from = channel.receive(0, w.status);
    from = get_symmetric(from, w.j_flange_roll.Phi_wrist_housing);
    get(from, w.j_flange_roll.b_wrist_housing);
  }
  {
    auto& i = w.j_forearm_roll;
    set_transforms(w, 4, i.X, i.Y);
    load_torque(w, 4, 4, i.joined.tau);
    const Mat6 X_Phi_A = i.X * w.j_shoulder_pitch.Phi_forearm;
    const Mat6 Phi_A = from_right(X_Phi_A, i.X);
    const Mat6 Phi_B = from_right(i.Y * w.j_flange_roll.Phi_wrist_housing, i.Y);
    const Columns6 c = Columns6::Zero();
    if (!join(i.joined, Phi_A, Phi_B, i.X * w.j_shoulder_pitch.b_forearm, i.Y * w.j_flange_roll.b_wrist_housing, c))
      fail(w, kFactorization, 4);
  }
  {
    auto& i = w.j_forearm_roll;
    Release<Revolute> release(i.joined);
    const Columns6 f = release.force();  // Eq. (8), (10)
    w.refinement.f[4].col(w.refinement.side) = f;
    store_acceleration(w, 4, 4, release.qdd());  // Eq. (9)
    w.j_shoulder_pitch.F_on_forearm = -i.X.transposed_times(f);
    w.j_flange_roll.F_on_wrist_housing = i.Y.transposed_times(f);
  }
  {  // to process 1: forces on: chain of "flange_roll"
    Number* to = channel.outgoing(1, w.status);
    put(to, w.j_flange_roll.F_on_wrist_housing);
    channel.send(1, w.status);
  }
  w.loads[4] = in_base(w, 4, w.j_shoulder_pitch.F_on_forearm);
  deliver<0, 3, true>(w);  // "base_yaw" .. "elbow_pitch"
  accelerate<0, 0, 3>(w);  // "base_yaw" .. "elbow_pitch"
  require_finite(w, w.answer.data(), 0, 5, &JointConstants::v, kOverflow);
  give(w, 0, 5);
}

// Process 1, a correction: its steps with the stored factors, for the residual forces at
// the links.
static void correct_1([[maybe_unused]] Workspace& w, [[maybe_unused]] Channel& channel) {
  {
    const auto X = inward_group<1, kLimbs0>(w);
    leave<true>(w, 7, lane(X, 0));
    leave<false>(w, 7, lane(X, 1));
  }
  inward<1, 5, 6, true>(w);  // "wrist_pitch" .. "flange_roll"
  invert_root<1, 5>(w, w.j_flange_roll.Phi_wrist_housing, w.j_flange_roll.b_wrist_housing);
  {  // to process 0: assembled: chain of "flange_roll"
    Number* to = channel.outgoing(0, w.status);
    to = put_symmetric(to, w.j_flange_roll.Phi_wrist_housing);
    put(to, w.j_flange_roll.b_wrist_housing);
    channel.send(0, w.status);
  }
  {  // from process 0: forces on: chain of "flange_roll"
    const Number* from = channel.receive(1, w.status);
    get(from, w.j_flange_roll.F_on_wrist_housing);
  }
  w.loads[5] = in_base(w, 5, w.j_flange_roll.F_on_wrist_housing);
  accelerate_root<5>(w, w.j_flange_roll.Phi_wrist_housing, w.j_flange_roll.b_wrist_housing);
  accelerate<1, 5, 6>(w);  // "wrist_pitch" .. "flange_roll"
  accelerate_group<1, kLimbs0>(w);
  require_finite(w, w.answer.data(), 5, 4, &JointConstants::v, kOverflow);
  give(w, 5, 4);
}

constexpr std::array<void (*)(Workspace&, Channel&), kProcesses> kSolve{run_0, run_1};
constexpr std::array<void (*)(Workspace&, Channel&), kProcesses> kCorrect{correct_0, correct_1};

constexpr std::array<int, 5> kRefined_0_0{0, 1, 2, 3, 4};
constexpr std::array<int, 5> kRefined_0_1{0, 1, 2, 3, 4};
constexpr std::array<int, 5> kRefined_0_2{0, 1, 2, 3, 4};
constexpr std::array<int, 4> kRefined_0_3{0, 1, 2, 3};
constexpr std::array<int, 5> kRefined_0_4{0, 1, 2, 3, 4};
constexpr std::array<int, 4> kRefined_0_5{1, 2, 3, 4};
constexpr std::array<int, 4> kRefined_1_0{5, 6, 7, 8};
constexpr std::array<int, 9> kRefined_1_1{0, 1, 2, 3, 4, 5, 6, 7, 8};
constexpr std::array<int, 4> kRefined_1_2{5, 6, 7, 8};
constexpr std::array<int, 9> kRefined_1_3{0, 1, 2, 3, 4, 5, 6, 7, 8};
constexpr std::array<int, 5> kRefined_1_4{4, 5, 6, 7, 8};
constexpr std::array<int, 5> kRefined_1_5{5, 6, 7, 8, 9};
constexpr std::array<RefinedProcess, kProcesses> kRefined{ {
    {{5, kRefined_0_0.data()}, {5, kRefined_0_1.data()}, {5, kRefined_0_2.data()}, {4, kRefined_0_3.data()}, {5, kRefined_0_4.data()}, {4, kRefined_0_5.data()}, {0, nullptr}, {0, nullptr}, {0, nullptr}},
    {{4, kRefined_1_0.data()}, {9, kRefined_1_1.data()}, {4, kRefined_1_2.data()}, {9, kRefined_1_3.data()}, {5, kRefined_1_4.data()}, {5, kRefined_1_5.data()}, {0, nullptr}, {0, nullptr}, {0, nullptr}},
} };

constexpr std::array<int, 5> kToldEntries_0{0, 1, 2, 3, 4};
constexpr std::array<int, 1> kToldForces_0{4};
constexpr std::array<ExchangeInfo, 1> kExchanges{ {
    {0, 1, {5, kToldEntries_0.data()}, {1, kToldForces_0.data()}},
} };
constexpr std::array<int, 1> kSharing{1};  // processes that send their part to process 0
constexpr int kFirstExchange = kPlanMessages + 2 * (kProcesses - 1);
constexpr int kFirstShare = kFirstExchange + 1;

// Coupling torque of a slaved joint.
static inline Real coupling_torque([[maybe_unused]] const Workspace& w, [[maybe_unused]] int k) {
  return 0;
}

#include "adagen/kernels/correct.hpp"
#include "adagen/refined.hpp"


[[maybe_unused]] constexpr std::array<StageInfo, 7> kStages_0{ {
    {"kinematics", 4, -1}, {"assembly", 3, -1}, {"receive", -1, 0}, {"assembly", 4, -1},
    {"disassembly", 4, -1}, {"send", -1, 1}, {"disassembly", 3, -1}
} };
[[maybe_unused]] constexpr std::array<StageInfo, 5> kStages_1{ {
    {"kinematics", 8, -1}, {"assembly", 5, -1}, {"send", -1, 0}, {"receive", -1, 1},
    {"disassembly", 5, -1}
} };
[[maybe_unused]] constexpr std::array<void (*)(Workspace&, Channel&), kProcesses> kRun{refined, refined};

constexpr std::array<Range, 4> kRanges_0{ {{0, 5}, {0, 5}, {0, 5}, {0, 5}} };
constexpr std::array<Range, 4> kRanges_1{ {{0, 9}, {0, 9}, {5, 4}, {5, 4}} };
[[maybe_unused]] constexpr std::array<ProcessInfo, kProcesses> kProcess{ {
    {{1, kRanges_0.data()}, {1, kRanges_0.data() + 1}, {1, kRanges_0.data() + 2}, {1, kRanges_0.data() + 3}, {7, kStages_0.data()}},
    {{1, kRanges_1.data()}, {1, kRanges_1.data() + 1}, {1, kRanges_1.data() + 2}, {1, kRanges_1.data() + 3}, {5, kStages_1.data()}}}};

#include "adagen/whole_mpi.hpp"
