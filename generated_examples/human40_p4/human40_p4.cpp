// Forward dynamics of "human40" on 4 processes, emitted by adagen 0.1.0 (solver.cpp.j2). Do not edit: generate again. Licence: yours to choose.
// robot     "human40", 15 joints, 40 degrees of freedom, description sha256 bdc16488e5ef4610f46ad114b2f2b09a8601d7b212cf0d9aa1794a195cd4ce35
// command   adagen ../models/human40.urdf --procs 4 --schedule=balanced --shape=kernels
// input     profile default, sha256 fe36af9ff4727e4941af0e7182db7f87cd64c54109bc287302f720e9ad83c3a8
// options   form segment (articulated-body algorithm), shape kernels (spatial vectors [angular; linear] in the axes of the base, about each link's origin), scalar double, channel auto, fixed base, gravity 0.0, 0.0, -9.81
// needs     Eigen's headers
// links     adagen_program.cpp -DADAGEN_MPI; or, compiled with -DADAGEN_NO_MAIN, a program of yours that includes human40_p4.h
// program   4 processes, joined at cuts; 1.09 us predicted (default profile)
//           process 0: root .. left_hip, right_hip .. spine
//           process 1: left_knee .. left_ankle
//           process 2: neck | right_wrist in 2 lanes, left_shoulder, right_shoulder .. right_elbow
//           process 3: left_elbow .. left_wrist
// schedule  spine@0-3(left_hip@0-1(right_hip@0(root | right_knee(|right_ankle)) | left_knee@1(|left_ankle)) | left_shoulder@2-3(right_shoulder@2(neck | right_elbow(|right_wrist)) | left_elbow@3(|left_wrist)))
//
// Each process solves a segment of the robot with the articulated-body algorithm: the articulated-body
// inertias I^A and bias forces p^A (IA, pA) are computed from the ends to the segment's root, then the
// accelerations from there outwards. Where segments meet, the assembly-disassembly algorithm of Yamane
// and Nakamura joins them: Phi = (I^A)^-1 and b are a segment's inverse inertia and bias acceleration at
// a cut; joint i joins chain A (on its parent link's side) and chain B (on its child link's side), Eq.
// (3)-(7), and its force follows from Eq. (8)-(10).

#include "human40_p4.h"
#define ADAGEN_CALL(word) human40_p4_##word
#define ADAGEN_NAMED(WORD) HUMAN40_P4_##WORD
#define ADAGEN_MPI
#include "adagen/kernels/plain_loops.hpp"

namespace { struct human40_p4_settings : PlainLoops<15> {
  static constexpr int kVersion = 100, kJointCount = 15, kNq = 51, kNv = 40;
  [[maybe_unused]] static constexpr const char* kRobot = "human40";
  static constexpr int kProcesses = 4;
  static constexpr bool kAlone = false;
  static constexpr int kPlanMessages = 6;
  [[maybe_unused]] static constexpr Hops kHops = {{0, 152, 0.404}, {20.9, 192, 0.602}};
  static constexpr int kSlotCount = 26;
  static constexpr bool kReordered = true;
  static constexpr int kSlots[kJointCount] = {0, 1, 8, 9, 2, 3, 4, 5, 18, 24, 25, 16, 19, 20, 17};
  static constexpr bool kInLanes = true;
}; }  // namespace: a program may load several solvers of one name

#include "adagen/kernels/model.hpp"

constexpr std::array<LinkConstants, kLinkCount> kLinks{ {
    {"world", 0.0, {0.0, 0.0, 0.0}},
    {"pelvis", 9.6, {0.0, 0.0, 0.03},
     {0.104, 0.0, 0.0, 0.0, 0.05248, 0.0, 0.0, 0.0, 0.09248}},
    {"left_thigh", 8.4, {0.0, 0.0, -0.19},
     {0.12544, 0.0, 0.0, 0.0, 0.12544, 0.0, 0.0, 0.0, 0.02688}},
    {"left_shank", 3.2, {-0.18, 0.0, 0.0},
     {0.004, 0.0, 0.0, 0.0, 0.0446667, 0.0, 0.0, 0.0, 0.0446667}},
    {"left_foot", 1.0, {0.06, 0.0, -0.04},
     {0.00108333, 0.0, 0.0, 0.0, 0.00561667, 0.0, 0.0, 0.0, 0.00588333}},
    {"right_thigh", 8.4, {0.0, 0.0, -0.19},
     {0.12544, 0.0, 0.0, 0.0, 0.12544, 0.0, 0.0, 0.0, 0.02688}},
    {"right_shank", 3.2, {-0.18, 0.0, 0.0},
     {0.004, 0.0, 0.0, 0.0, 0.0446667, 0.0, 0.0, 0.0, 0.0446667}},
    {"right_foot", 1.0, {0.06, 0.0, -0.04},
     {0.00108333, 0.0, 0.0, 0.0, 0.00561667, 0.0, 0.0, 0.0, 0.00588333}},
    {"trunk", 23.0, {0.0, 0.0, 0.23},
     {0.601833, 0.0, 0.0, 0.0, 0.467667, 0.0, 0.0, 0.0, 0.258367}},
    {"left_upper_arm", 1.9, {0.0, 0.0, -0.14},
     {0.0133752, 0.0, 0.0, 0.0, 0.0133752, 0.0, 0.0, 0.0, 0.00192375}},
    {"left_forearm", 1.1, {-0.12, 0.0, 0.0},
     {0.00067375, 0.0, 0.0, 0.0, 0.00606604, 0.0, 0.0, 0.0, 0.00606604}},
    {"left_hand", 0.42, {0.0, 0.0, -0.08},
     {0.0012355, 0.0, 0.0, 0.0, 0.001043, 0.0, 0.0, 0.0, 0.0002555}},
    {"head", 4.9, {0.01, 0.0, 0.14},
     {0.0196, 0.0, 0.0, 0.0, 0.0196, 0.0, 0.0, 0.0, 0.0196}},
    {"right_upper_arm", 1.9, {0.0, 0.0, -0.14},
     {0.0133752, 0.0, 0.0, 0.0, 0.0133752, 0.0, 0.0, 0.0, 0.00192375}},
    {"right_forearm", 1.1, {-0.12, 0.0, 0.0},
     {0.00067375, 0.0, 0.0, 0.0, 0.00606604, 0.0, 0.0, 0.0, 0.00606604}},
    {"right_hand", 0.42, {0.0, 0.0, -0.08},
     {0.0012355, 0.0, 0.0, 0.0, 0.001043, 0.0, 0.0, 0.0, 0.0002555}}}};

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

[[maybe_unused]] constexpr std::array<MessageInfo, 12> kMessages{ {
    {1, 0, 27},  // 0: assembled: chain of "left_knee"
    {3, 2, 27},  // 1: assembled: chain of "left_elbow"
    {2, 0, 27},  // 2: assembled: chain of "left_shoulder"
    {0, 2, 6},  // 3: forces on: chain of "left_shoulder"
    {0, 1, 6},  // 4: forces on: chain of "left_knee"
    {2, 3, 6},  // 5: forces on: chain of "left_elbow"
    {0, 1, 33},  // 6: state
    {1, 0, 4},  // 7: accelerations
    {0, 2, 63},  // 8: state
    {2, 0, 13},  // 9: accelerations
    {0, 3, 40},  // 10: state
    {3, 0, 4}}};  // 11: accelerations

constexpr std::array<LinkInertia, kJointCount> kInertias{ {
    {9.6, {0.0, 0.0, 0.288},
     {0.020480000000000005, 0.0, 0.0, 0.07200000000000001, 0.0, 0.040639999999999996}},
    {8.4, {0.0, 0.0, -1.596},
     {0.01344, 0.0, 0.0, 0.01344, 0.0, 0.41524}},
    {3.2, {-0.576, 0.0, 0.0},
     {0.1463467, 0.0, 0.0, 0.002, 0.0, 0.002}},
    {1.0, {0.06, 0.0, -0.04},
     {0.008808335, 0.0, -0.0024, 0.0006749950000000001, 0.0, 0.002008335}},
    {8.4, {0.0, 0.0, -1.596},
     {0.01344, 0.0, 0.0, 0.01344, 0.0, 0.41524}},
    {3.2, {-0.576, 0.0, 0.0},
     {0.1463467, 0.0, 0.0, 0.002, 0.0, 0.002}},
    {1.0, {0.06, 0.0, -0.04},
     {0.008808335, 0.0, -0.0024, 0.0006749950000000001, 0.0, 0.002008335}},
    {23.0, {0.0, 0.0, 5.29},
     {0.06210050000000003, 0.0, 0.0, 0.19626649999999998, 0.0, 1.6222665}},
    {1.9, {0.0, 0.0, -0.266},
     {0.000961875, 0.0, 0.0, 0.000961875, 0.0, 0.049653325000000005}},
    {1.1, {-0.132, 0.0, 0.0},
     {0.021569165, 0.0, 0.0, 0.000336875, 0.0, 0.000336875}},
    {0.42, {0.0, 0.0, -0.0336},
     {3.150000000000001e-05, 0.0, 0.0, 0.00022399999999999997, 0.0, 0.0036995}},
    {4.9, {0.049, 0.0, 0.6860000000000002},
     {0.01029, 0.0, 0.0068600000000000015, 0.0098, 0.0, 0.10584000000000003}},
    {1.9, {0.0, 0.0, -0.266},
     {0.000961875, 0.0, 0.0, 0.000961875, 0.0, 0.049653325000000005}},
    {1.1, {-0.132, 0.0, 0.0},
     {0.021569165, 0.0, 0.0, 0.000336875, 0.0, 0.000336875}},
    {0.42, {0.0, 0.0, -0.0336},
     {3.150000000000001e-05, 0.0, 0.0, 0.00022399999999999997, 0.0, 0.0036995}}}};

constexpr LinkRole kRoles[4][kLinkCount]{
    {{0, 0, 0, 0}, {1, 1, 1, 0}, {0, 0, 0, 1}, {0, 0, 0, 0}, {0, 0, 0, 0}, {0, 1, 0, 1}, {0, 1, 0, 0}, {0, 1, 0, 1}, {0, 0, 0, 1}, {0, 0, 0, 0}, {0, 0, 0, 0}, {0, 0, 0, 0}, {0, 0, 0, 0}, {0, 0, 0, 0}, {0, 0, 0, 0}, {0, 0, 0, 0}},
    {{0, 0, 0, 0}, {0, 0, 0, 0}, {1, 1, 1, 1}, {0, 1, 0, 0}, {0, 1, 0, 1}, {0, 0, 0, 0}, {0, 0, 0, 0}, {0, 0, 0, 0}, {0, 0, 0, 0}, {0, 0, 0, 0}, {0, 0, 0, 0}, {0, 0, 0, 0}, {0, 0, 0, 0}, {0, 0, 0, 0}, {0, 0, 0, 0}, {0, 0, 0, 0}},
    {{0, 0, 0, 0}, {0, 0, 0, 0}, {0, 0, 0, 0}, {0, 0, 0, 0}, {0, 0, 0, 0}, {0, 0, 0, 0}, {0, 0, 0, 0}, {0, 0, 0, 0}, {1, 1, 1, 1}, {0, 0, 0, 1}, {0, 0, 0, 0}, {0, 0, 0, 0}, {0, 1, 0, 1}, {0, 1, 0, 1}, {1, 1, 1, 0}, {0, 1, 0, 1}},
    {{0, 0, 0, 0}, {0, 0, 0, 0}, {0, 0, 0, 0}, {0, 0, 0, 0}, {0, 0, 0, 0}, {0, 0, 0, 0}, {0, 0, 0, 0}, {0, 0, 0, 0}, {0, 0, 0, 1}, {1, 1, 1, 1}, {0, 1, 0, 0}, {0, 1, 0, 1}, {0, 0, 0, 0}, {0, 0, 0, 0}, {0, 0, 0, 0}, {0, 0, 0, 0}}};

// ---- functions ----------------------------------------------------------------------------------

#include "adagen/spatial.hpp"
#include "adagen/joins.hpp"
#include "adagen/channel.hpp"
#include "adagen/kernels/state.hpp"

namespace {

// Memory where segments meet, by joint.
struct Joint_left_hip {
  Mat6 Phi_pelvis;
  Columns6 b_pelvis;
  Transform X, Y;  // to the joint's frame, about its two links' origins
  Joined<Spherical> joined;
  Coupled<Spherical> at_pelvis;
  Columns6 F_on_pelvis;
};
struct Joint_left_knee {
  Mat6 Phi_left_thigh;
  Columns6 b_left_thigh;
  Columns6 F_on_left_thigh;
};
struct Joint_right_hip {
  Mat6 Phi_pelvis;
  Columns6 b_pelvis;
  Columns6 F_on_pelvis;
};
struct Joint_spine {
  Transform X, Y;  // to the joint's frame, about its two links' origins
  Joined<Spherical> joined;
};
struct Joint_left_shoulder {
  Mat6 Phi_trunk;
  Columns6 b_trunk;
  Transform X, Y;  // to the joint's frame, about its two links' origins
  Joined<Spherical> joined;
  Coupled<Spherical> at_trunk;
  Columns6 F_on_trunk;
};
struct Joint_left_elbow {
  Mat6 Phi_left_upper_arm;
  Columns6 b_left_upper_arm;
  Columns6 F_on_left_upper_arm;
};
struct Joint_right_shoulder {
  Mat6 Phi_trunk;
  Columns6 b_trunk;
  Columns6 F_on_trunk;
};
struct Cuts {
  Joint_left_hip j_left_hip;
  Joint_left_knee j_left_knee;
  Joint_right_hip j_right_hip;
  Joint_spine j_spine;
  Joint_left_shoulder j_left_shoulder;
  Joint_left_elbow j_left_elbow;
  Joint_right_shoulder j_right_shoulder;
  std::array<Columns6, kLinkCount> loads;  // wrenches on links, from handle forces
  EIGEN_MAKE_ALIGNED_OPERATOR_NEW
};

}  // namespace

#include "adagen/kernels/inertias.hpp"
#include "adagen/kernels/keep_nothing.hpp"
#include "adagen/kernels/reach_nothing.hpp"
#include "adagen/kernels/sweeps.hpp"
#include "adagen/kernels/quaternions.hpp"
#include "adagen/kernels/groups.hpp"
#include "adagen/kernels/mobility.hpp"
#include "adagen/kernels/wrenches.hpp"
#include "adagen/exchange.hpp"

// "neck", "right_wrist"
constexpr Limbs<2, 1> kLimbs0{16, {{11, 14}}};

// ---- processes ----------------------------------------------------------------------------------

// Process 0: 6 of 15 joints: "root", "left_hip", "right_hip", "right_knee", "right_ankle", "spine"
static void run_0([[maybe_unused]] Workspace& w, [[maybe_unused]] Channel& channel) {
  require_finite(w, w.q, 0, 11, &JointConstants::q, kNotFinite);
  require_finite(w, w.q, 16, 13, &JointConstants::q, kNotFinite);
  require_finite(w, w.v, 0, 9, &JointConstants::v, kNotFinite);
  require_finite(w, w.v, 13, 10, &JointConstants::v, kNotFinite);
  require_finite(w, w.tau, 0, 9, &JointConstants::v, kNotFinite);
  require_finite(w, w.tau, 13, 10, &JointConstants::v, kNotFinite);
  take_angles<0, 1>(w);
  take_angles<4, 7>(w);
  turn<block(3), block(3) + 1>(w);
  orient<0, block(1), block(5) + 1>(w);
  free_base_frame<0>(w);
  outward<1, 1>(w);  // "left_hip"
  outward<4, 6>(w);  // "right_hip" .. "right_ankle"
  outward<7, 7>(w);  // "spine"
  stamp(1);
  set_up_links<block(0), block(4) + 1>(w);
  free_base<0, true>(w);
  inward<0, 4, 6, false>(w);  // "right_hip" .. "right_ankle"
  invert_root<0, 1>(w, w.j_right_hip.Phi_pelvis, w.j_right_hip.b_pelvis);
  stamp(2);
  {  // from process 1: assembled: chain of "left_knee"
    const Number* from = channel.receive(0, w.status);
    from = get_symmetric(from, w.j_left_knee.Phi_left_thigh);
    get(from, w.j_left_knee.b_left_thigh);
  }
  stamp(3);
  {
    auto& i = w.j_left_hip;
    set_transforms(w, 1, i.X, i.Y);
    load_torque(w, 1, 6, i.joined.tau);
    const Mat6 X_Phi_A = i.X * w.j_right_hip.Phi_pelvis;
    const Mat6 Phi_A = from_right(X_Phi_A, i.X);
    const Mat6 Phi_B = from_right(i.Y * w.j_left_knee.Phi_left_thigh, i.Y);
    const Columns6 c = Columns6::Zero();
    if (!join(i.joined, Phi_A, Phi_B, i.X * w.j_right_hip.b_pelvis, i.Y * w.j_left_knee.b_left_thigh, c))
      fail(w, kFactorization, 1);
    couple(i.joined, X_Phi_A, i.at_pelvis);
    i.Phi_pelvis = w.j_right_hip.Phi_pelvis - product(i.at_pelvis, i.at_pelvis);  // Eq. (3)
    i.b_pelvis = w.j_right_hip.b_pelvis - bias_change(i.joined, i.at_pelvis);  // Eq. (6)
  }
  stamp(4);
  {  // from process 2: assembled: chain of "left_shoulder"
    const Number* from = channel.receive(2, w.status);
    from = get_symmetric(from, w.j_left_shoulder.Phi_trunk);
    get(from, w.j_left_shoulder.b_trunk);
  }
  stamp(5);
  {
    auto& i = w.j_spine;
    set_transforms(w, 7, i.X, i.Y);
    load_torque(w, 7, 20, i.joined.tau);
    const Mat6 X_Phi_A = i.X * w.j_left_hip.Phi_pelvis;
    const Mat6 Phi_A = from_right(X_Phi_A, i.X);
    const Mat6 Phi_B = from_right(i.Y * w.j_left_shoulder.Phi_trunk, i.Y);
    const Columns6 c = Columns6::Zero();
    if (!join(i.joined, Phi_A, Phi_B, i.X * w.j_left_hip.b_pelvis, i.Y * w.j_left_shoulder.b_trunk, c))
      fail(w, kFactorization, 7);
  }
  stamp(6);
  {
    auto& i = w.j_spine;
    Release<Spherical> release(i.joined);
    const Columns6 f = release.force();  // Eq. (8), (10)
    store_acceleration(w, 7, 20, release.qdd());  // Eq. (9)
    w.j_left_hip.F_on_pelvis = -i.X.transposed_times(f);
    w.j_left_shoulder.F_on_trunk = i.Y.transposed_times(f);
  }
  stamp(7);
  {  // to process 2: forces on: chain of "left_shoulder"
    Number* to = channel.outgoing(3, w.status);
    put(to, w.j_left_shoulder.F_on_trunk);
    channel.send(3, w.status);
  }
  stamp(8);
  {
    auto& i = w.j_left_hip;
    Release<Spherical> release(i.joined);
    release.feel_A(i.at_pelvis, w.j_left_hip.F_on_pelvis);
    const Columns6 f = release.force();  // Eq. (8), (10)
    store_acceleration(w, 1, 6, release.qdd());  // Eq. (9)
    w.j_right_hip.F_on_pelvis = w.j_left_hip.F_on_pelvis - i.X.transposed_times(f);
    w.j_left_knee.F_on_left_thigh = i.Y.transposed_times(f);
  }
  stamp(9);
  {  // to process 1: forces on: chain of "left_knee"
    Number* to = channel.outgoing(4, w.status);
    put(to, w.j_left_knee.F_on_left_thigh);
    channel.send(4, w.status);
  }
  stamp(10);
  w.loads[1] = in_base(w, 1, w.j_right_hip.F_on_pelvis);
  accelerate_root<1>(w, w.j_right_hip.Phi_pelvis, w.j_right_hip.b_pelvis);
  accelerate<0, 4, 6>(w);  // "right_hip" .. "right_ankle"
  free_acceleration<0>(w);
  stamp(11);
  require_finite(w, w.answer.data(), 0, 9, &JointConstants::v, kOverflow);
  require_finite(w, w.answer.data(), 13, 10, &JointConstants::v, kOverflow);
  give(w, 0, 9);
  give(w, 13, 10);
}

// Process 1: 2 of 15 joints: "left_knee", "left_ankle"; kinematics of 2 more on the way to the ground
static void run_1([[maybe_unused]] Workspace& w, [[maybe_unused]] Channel& channel) {
  require_finite(w, w.q, 0, 16, &JointConstants::q, kNotFinite);
  require_finite(w, w.v, 0, 13, &JointConstants::v, kNotFinite);
  require_finite(w, w.tau, 9, 4, &JointConstants::v, kNotFinite);
  take_angles<0, 3>(w);
  turn<block(8), block(8) + 1>(w);
  orient<1, block(1), block(9) + 1>(w);
  free_base_frame<0>(w);
  pass_outward<1, 1>(w);  // "left_hip"
  outward<2, 3>(w);  // "left_knee" .. "left_ankle"
  stamp(1);
  set_up_links<block(1), block(9) + 1>(w);
  inward<1, 2, 3, true>(w);  // "left_knee" .. "left_ankle"
  invert_root<1, 2>(w, w.j_left_knee.Phi_left_thigh, w.j_left_knee.b_left_thigh);
  stamp(2);
  {  // to process 0: assembled: chain of "left_knee"
    Number* to = channel.outgoing(0, w.status);
    to = put_symmetric(to, w.j_left_knee.Phi_left_thigh);
    put(to, w.j_left_knee.b_left_thigh);
    channel.send(0, w.status);
  }
  stamp(3);
  {  // from process 0: forces on: chain of "left_knee"
    const Number* from = channel.receive(4, w.status);
    get(from, w.j_left_knee.F_on_left_thigh);
  }
  stamp(4);
  w.loads[2] = in_base(w, 2, w.j_left_knee.F_on_left_thigh);
  accelerate_root<2>(w, w.j_left_knee.Phi_left_thigh, w.j_left_knee.b_left_thigh);
  accelerate<1, 2, 3>(w);  // "left_knee" .. "left_ankle"
  stamp(5);
  require_finite(w, w.answer.data(), 9, 4, &JointConstants::v, kOverflow);
  give(w, 9, 4);
}

// Process 2: 5 of 15 joints: "left_shoulder", "neck", "right_shoulder", "right_elbow", "right_wrist"; kinematics of 2 more on the way to the ground
static void run_2([[maybe_unused]] Workspace& w, [[maybe_unused]] Channel& channel) {
  require_finite(w, w.q, 0, 7, &JointConstants::q, kNotFinite);
  require_finite(w, w.q, 25, 8, &JointConstants::q, kNotFinite);
  require_finite(w, w.q, 38, 13, &JointConstants::q, kNotFinite);
  require_finite(w, w.v, 0, 6, &JointConstants::v, kNotFinite);
  require_finite(w, w.v, 20, 6, &JointConstants::v, kNotFinite);
  require_finite(w, w.v, 30, 10, &JointConstants::v, kNotFinite);
  require_finite(w, w.tau, 23, 3, &JointConstants::v, kNotFinite);
  require_finite(w, w.tau, 30, 10, &JointConstants::v, kNotFinite);
  take_angles<0, 0>(w);
  take_angles<7, 8>(w);
  take_angles<11, 14>(w);
  turn<block(20), block(20) + 1>(w);
  orient<2, block(5), block(19) + 1>(w);
  free_base_frame<0>(w);
  pass_outward<7, 7>(w);  // "spine"
  outward<8, 8>(w);  // "left_shoulder"
  outward<12, 13>(w);  // "right_shoulder" .. "right_elbow"
  outward_group<kLimbs0>(w);
  stamp(1);
  set_up_links<block(5), block(20) + 1>(w);
  {
    const auto X = inward_group<2, kLimbs0>(w);
    leave<true>(w, 8, lane(X, 0));
    leave<true>(w, 14, lane(X, 1));
  }
  inward<2, 12, 13, false>(w);  // "right_shoulder" .. "right_elbow"
  invert_root<2, 8>(w, w.j_right_shoulder.Phi_trunk, w.j_right_shoulder.b_trunk);
  stamp(2);
  {  // from process 3: assembled: chain of "left_elbow"
    const Number* from = channel.receive(1, w.status);
    from = get_symmetric(from, w.j_left_elbow.Phi_left_upper_arm);
    get(from, w.j_left_elbow.b_left_upper_arm);
  }
  stamp(3);
  {
    auto& i = w.j_left_shoulder;
    set_transforms(w, 8, i.X, i.Y);
    load_torque(w, 8, 23, i.joined.tau);
    const Mat6 X_Phi_A = i.X * w.j_right_shoulder.Phi_trunk;
    const Mat6 Phi_A = from_right(X_Phi_A, i.X);
    const Mat6 Phi_B = from_right(i.Y * w.j_left_elbow.Phi_left_upper_arm, i.Y);
    const Columns6 c = Columns6::Zero();
    if (!join(i.joined, Phi_A, Phi_B, i.X * w.j_right_shoulder.b_trunk, i.Y * w.j_left_elbow.b_left_upper_arm, c))
      fail(w, kFactorization, 8);
    couple(i.joined, X_Phi_A, i.at_trunk);
    i.Phi_trunk = w.j_right_shoulder.Phi_trunk - product(i.at_trunk, i.at_trunk);  // Eq. (3)
    i.b_trunk = w.j_right_shoulder.b_trunk - bias_change(i.joined, i.at_trunk);  // Eq. (6)
  }
  stamp(4);
  {  // to process 0: assembled: chain of "left_shoulder"
    Number* to = channel.outgoing(2, w.status);
    to = put_symmetric(to, w.j_left_shoulder.Phi_trunk);
    put(to, w.j_left_shoulder.b_trunk);
    channel.send(2, w.status);
  }
  stamp(5);
  {  // from process 0: forces on: chain of "left_shoulder"
    const Number* from = channel.receive(3, w.status);
    get(from, w.j_left_shoulder.F_on_trunk);
  }
  stamp(6);
  {
    auto& i = w.j_left_shoulder;
    Release<Spherical> release(i.joined);
    release.feel_A(i.at_trunk, w.j_left_shoulder.F_on_trunk);
    const Columns6 f = release.force();  // Eq. (8), (10)
    store_acceleration(w, 8, 23, release.qdd());  // Eq. (9)
    w.j_right_shoulder.F_on_trunk = w.j_left_shoulder.F_on_trunk - i.X.transposed_times(f);
    w.j_left_elbow.F_on_left_upper_arm = i.Y.transposed_times(f);
  }
  stamp(7);
  {  // to process 3: forces on: chain of "left_elbow"
    Number* to = channel.outgoing(5, w.status);
    put(to, w.j_left_elbow.F_on_left_upper_arm);
    channel.send(5, w.status);
  }
  stamp(8);
  w.loads[8] = in_base(w, 8, w.j_right_shoulder.F_on_trunk);
  accelerate_root<8>(w, w.j_right_shoulder.Phi_trunk, w.j_right_shoulder.b_trunk);
  accelerate<2, 12, 13>(w);  // "right_shoulder" .. "right_elbow"
  accelerate_group<2, kLimbs0>(w);
  stamp(9);
  require_finite(w, w.answer.data(), 23, 3, &JointConstants::v, kOverflow);
  require_finite(w, w.answer.data(), 30, 10, &JointConstants::v, kOverflow);
  give(w, 23, 3);
  give(w, 30, 10);
}

// Process 3: 2 of 15 joints: "left_elbow", "left_wrist"; kinematics of 3 more on the way to the ground
static void run_3([[maybe_unused]] Workspace& w, [[maybe_unused]] Channel& channel) {
  require_finite(w, w.q, 0, 7, &JointConstants::q, kNotFinite);
  require_finite(w, w.q, 25, 13, &JointConstants::q, kNotFinite);
  require_finite(w, w.v, 0, 6, &JointConstants::v, kNotFinite);
  require_finite(w, w.v, 20, 10, &JointConstants::v, kNotFinite);
  require_finite(w, w.tau, 26, 4, &JointConstants::v, kNotFinite);
  take_angles<0, 0>(w);
  take_angles<7, 10>(w);
  turn<block(24), block(24) + 1>(w);
  orient<3, block(5), block(25) + 1>(w);
  free_base_frame<0>(w);
  pass_outward<7, 8>(w);  // "spine" .. "left_shoulder"
  outward<9, 10>(w);  // "left_elbow" .. "left_wrist"
  stamp(1);
  set_up_links<block(18), block(25) + 1>(w);
  inward<3, 9, 10, true>(w);  // "left_elbow" .. "left_wrist"
  invert_root<3, 9>(w, w.j_left_elbow.Phi_left_upper_arm, w.j_left_elbow.b_left_upper_arm);
  stamp(2);
  {  // to process 2: assembled: chain of "left_elbow"
    Number* to = channel.outgoing(1, w.status);
    to = put_symmetric(to, w.j_left_elbow.Phi_left_upper_arm);
    put(to, w.j_left_elbow.b_left_upper_arm);
    channel.send(1, w.status);
  }
  stamp(3);
  {  // from process 2: forces on: chain of "left_elbow"
    const Number* from = channel.receive(5, w.status);
    get(from, w.j_left_elbow.F_on_left_upper_arm);
  }
  stamp(4);
  w.loads[9] = in_base(w, 9, w.j_left_elbow.F_on_left_upper_arm);
  accelerate_root<9>(w, w.j_left_elbow.Phi_left_upper_arm, w.j_left_elbow.b_left_upper_arm);
  accelerate<3, 9, 10>(w);  // "left_elbow" .. "left_wrist"
  stamp(5);
  require_finite(w, w.answer.data(), 26, 4, &JointConstants::v, kOverflow);
  give(w, 26, 4);
}

[[maybe_unused]] constexpr std::array<StageInfo, 11> kStages_0{ {
    {"kinematics", 7, -1}, {"assembly", 4, -1}, {"receive", -1, 0}, {"assembly", 1, -1},
    {"receive", -1, 2}, {"assembly", 7, -1}, {"disassembly", 7, -1}, {"send", -1, 3},
    {"disassembly", 1, -1}, {"send", -1, 4}, {"disassembly", 4, -1}
} };
[[maybe_unused]] constexpr std::array<StageInfo, 5> kStages_1{ {
    {"kinematics", 3, -1}, {"assembly", 2, -1}, {"send", -1, 0}, {"receive", -1, 4},
    {"disassembly", 2, -1}
} };
[[maybe_unused]] constexpr std::array<StageInfo, 9> kStages_2{ {
    {"kinematics", 14, -1}, {"assembly", 11, -1}, {"receive", -1, 1}, {"assembly", 8, -1},
    {"send", -1, 2}, {"receive", -1, 3}, {"disassembly", 8, -1}, {"send", -1, 5},
    {"disassembly", 11, -1}
} };
[[maybe_unused]] constexpr std::array<StageInfo, 5> kStages_3{ {
    {"kinematics", 10, -1}, {"assembly", 9, -1}, {"send", -1, 1}, {"receive", -1, 5},
    {"disassembly", 9, -1}
} };
[[maybe_unused]] constexpr std::array<void (*)(Workspace&, Channel&), kProcesses> kRun{run_0, run_1, run_2, run_3};

constexpr std::array<Range, 8> kRanges_0{ {{0, 11}, {16, 13}, {0, 9}, {13, 10}, {0, 9}, {13, 10}, {0, 9}, {13, 10}} };
constexpr std::array<Range, 4> kRanges_1{ {{0, 16}, {0, 13}, {9, 4}, {9, 4}} };
constexpr std::array<Range, 10> kRanges_2{ {{0, 7}, {25, 8}, {38, 13}, {0, 6}, {20, 6}, {30, 10}, {23, 3}, {30, 10}, {23, 3}, {30, 10}} };
constexpr std::array<Range, 6> kRanges_3{ {{0, 7}, {25, 13}, {0, 6}, {20, 10}, {26, 4}, {26, 4}} };
[[maybe_unused]] constexpr std::array<ProcessInfo, kProcesses> kProcess{ {
    {{2, kRanges_0.data()}, {2, kRanges_0.data() + 2}, {2, kRanges_0.data() + 4}, {2, kRanges_0.data() + 6}, {11, kStages_0.data()}},
    {{1, kRanges_1.data()}, {1, kRanges_1.data() + 1}, {1, kRanges_1.data() + 2}, {1, kRanges_1.data() + 3}, {5, kStages_1.data()}},
    {{3, kRanges_2.data()}, {3, kRanges_2.data() + 3}, {2, kRanges_2.data() + 6}, {2, kRanges_2.data() + 8}, {9, kStages_2.data()}},
    {{2, kRanges_3.data()}, {2, kRanges_3.data() + 2}, {1, kRanges_3.data() + 4}, {1, kRanges_3.data() + 5}, {5, kStages_3.data()}}}};

#include "adagen/whole_mpi.hpp"
