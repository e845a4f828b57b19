// Forward dynamics of "chain16" on 3 processes, emitted by adagen 0.1.0 (solver.cpp.j2). Do not edit: generate again. Licence: yours to choose.
// robot     "chain16", 16 joints, 16 degrees of freedom, description sha256 b739552da6e27ec438b5eb7d6da98218430542949a453e8cd1010513e6e26b8a
// command   adagen ../models/chain16.urdf --procs 3 --schedule=balanced --shape=kernels
// input     profile default, sha256 fe36af9ff4727e4941af0e7182db7f87cd64c54109bc287302f720e9ad83c3a8
// options   form segment (articulated-body algorithm), shape kernels (spatial vectors [angular; linear] in the axes of the base, about each link's origin), scalar double, channel auto, fixed base, gravity 0.0, 0.0, -9.81
// needs     Eigen's headers
// links     adagen_program.cpp -DADAGEN_MPI; or, compiled with -DADAGEN_NO_MAIN, a program of yours that includes chain16_p3.h
// program   3 processes, joined at cuts; 1.34 us predicted (default profile)
//           process 0: joint01 .. joint08
//           process 1: joint09 .. joint12
//           process 2: joint13 .. joint16
// schedule  joint08@0-2(joint04@0(joint02(joint01 | joint03) | joint06(joint05 | joint07)) | joint12@1-2(joint10@1(joint09 | joint11) | joint14@2(joint13 | joint15(|joint16))))
//
// Each process solves a segment of the robot with the articulated-body algorithm: the articulated-body
// inertias I^A and bias forces p^A (IA, pA) are computed from the ends to the segment's root, then the
// accelerations from there outwards. Where segments meet, the assembly-disassembly algorithm of Yamane
// and Nakamura joins them: Phi = (I^A)^-1 and b are a segment's inverse inertia and bias acceleration at
// a cut; joint i joins chain A (on its parent link's side) and chain B (on its child link's side), Eq.
// (3)-(7), and its force follows from Eq. (8)-(10).

#include "chain16_p3.h"
#define ADAGEN_CALL(word) chain16_p3_##word
#define ADAGEN_NAMED(WORD) CHAIN16_P3_##WORD
#define ADAGEN_MPI
#include "adagen/kernels/plain_loops.hpp"

namespace { struct chain16_p3_settings : PlainLoops<16> {
  static constexpr int kVersion = 100, kJointCount = 16, kNq = 16, kNv = 16;
  [[maybe_unused]] static constexpr const char* kRobot = "chain16";
  static constexpr int kProcesses = 3;
  static constexpr bool kAlone = false;
  static constexpr int kPlanMessages = 4;
  [[maybe_unused]] static constexpr Hops kHops = {{0, 152, 0.404}, {20.9, 192, 0.602}};
  static constexpr bool kByColumns = true;
  static constexpr bool kCarriesAlong = true;
}; }  // namespace: a program may load several solvers of one name

#include "adagen/kernels/model.hpp"

constexpr std::array<LinkConstants, kLinkCount> kLinks{ {
    {"ceiling", 0.0, {0.0, 0.0, 0.0}},
    {"rod01", 1.0, {0.0, -0.2, 0.0},
     {0.0134333, 0.0, 0.0, 0.0, 0.0002, 0.0, 0.0, 0.0, 0.0134333}},
    {"rod02", 1.0, {-0.2, 0.0, 0.0},
     {0.0002, 0.0, 0.0, 0.0, 0.0134333, 0.0, 0.0, 0.0, 0.0134333}},
    {"rod03", 1.0, {0.0, 0.0, -0.2},
     {0.0134333, 0.0, 0.0, 0.0, 0.0134333, 0.0, 0.0, 0.0, 0.0002}},
    {"rod04", 1.0, {0.0, -0.2, 0.0},
     {0.0134333, 0.0, 0.0, 0.0, 0.0002, 0.0, 0.0, 0.0, 0.0134333}},
    {"rod05", 1.0, {-0.2, 0.0, 0.0},
     {0.0002, 0.0, 0.0, 0.0, 0.0134333, 0.0, 0.0, 0.0, 0.0134333}},
    {"rod06", 1.0, {0.0, 0.0, -0.2},
     {0.0134333, 0.0, 0.0, 0.0, 0.0134333, 0.0, 0.0, 0.0, 0.0002}},
    {"rod07", 1.0, {0.0, -0.2, 0.0},
     {0.0134333, 0.0, 0.0, 0.0, 0.0002, 0.0, 0.0, 0.0, 0.0134333}},
    {"rod08", 1.0, {-0.2, 0.0, 0.0},
     {0.0002, 0.0, 0.0, 0.0, 0.0134333, 0.0, 0.0, 0.0, 0.0134333}},
    {"rod09", 1.0, {0.0, 0.0, -0.2},
     {0.0134333, 0.0, 0.0, 0.0, 0.0134333, 0.0, 0.0, 0.0, 0.0002}},
    {"rod10", 1.0, {0.0, -0.2, 0.0},
     {0.0134333, 0.0, 0.0, 0.0, 0.0002, 0.0, 0.0, 0.0, 0.0134333}},
    {"rod11", 1.0, {-0.2, 0.0, 0.0},
     {0.0002, 0.0, 0.0, 0.0, 0.0134333, 0.0, 0.0, 0.0, 0.0134333}},
    {"rod12", 1.0, {0.0, 0.0, -0.2},
     {0.0134333, 0.0, 0.0, 0.0, 0.0134333, 0.0, 0.0, 0.0, 0.0002}},
    {"rod13", 1.0, {0.0, -0.2, 0.0},
     {0.0134333, 0.0, 0.0, 0.0, 0.0002, 0.0, 0.0, 0.0, 0.0134333}},
    {"rod14", 1.0, {-0.2, 0.0, 0.0},
     {0.0002, 0.0, 0.0, 0.0, 0.0134333, 0.0, 0.0, 0.0, 0.0134333}},
    {"rod15", 1.0, {0.0, 0.0, -0.2},
     {0.0134333, 0.0, 0.0, 0.0, 0.0134333, 0.0, 0.0, 0.0, 0.0002}},
    {"rod16", 1.0, {0.0, -0.2, 0.0},
     {0.0134333, 0.0, 0.0, 0.0, 0.0002, 0.0, 0.0, 0.0, 0.0134333}}}};

constexpr std::array<JointConstants, kJointCount> kJoints{ {
    {"joint01", JointKind::kRevolute, 0, 0, 1, 0, 1,
     {0.0, 0.0, 1.0, 1.0, 0.0, 0.0, 0.0, 1.0, 0.0}, {0.0, 0.0, 0.0}},
    {"joint02", JointKind::kRevolute, 1, 1, 1, 1, 1,
     {0.0, 0.0, 1.0, 1.0, 0.0, 0.0, 0.0, 1.0, 0.0}, {0.0, -0.4, 0.0}},
    {"joint03", JointKind::kRevolute, 2, 2, 1, 2, 1,
     {0.0, 0.0, 1.0, 1.0, 0.0, 0.0, 0.0, 1.0, 0.0}, {-0.4, 0.0, 0.0}},
    {"joint04", JointKind::kRevolute, 3, 3, 1, 3, 1,
     {0.0, 0.0, 1.0, 1.0, 0.0, 0.0, 0.0, 1.0, 0.0}, {0.0, 0.0, -0.4}},
    {"joint05", JointKind::kRevolute, 4, 4, 1, 4, 1,
     {0.0, 0.0, 1.0, 1.0, 0.0, 0.0, 0.0, 1.0, 0.0}, {0.0, -0.4, 0.0}},
    {"joint06", JointKind::kRevolute, 5, 5, 1, 5, 1,
     {0.0, 0.0, 1.0, 1.0, 0.0, 0.0, 0.0, 1.0, 0.0}, {-0.4, 0.0, 0.0}},
    {"joint07", JointKind::kRevolute, 6, 6, 1, 6, 1,
     {0.0, 0.0, 1.0, 1.0, 0.0, 0.0, 0.0, 1.0, 0.0}, {0.0, 0.0, -0.4}},
    {"joint08", JointKind::kRevolute, 7, 7, 1, 7, 1,
     {0.0, 0.0, 1.0, 1.0, 0.0, 0.0, 0.0, 1.0, 0.0}, {0.0, -0.4, 0.0}},
    {"joint09", JointKind::kRevolute, 8, 8, 1, 8, 1,
     {0.0, 0.0, 1.0, 1.0, 0.0, 0.0, 0.0, 1.0, 0.0}, {-0.4, 0.0, 0.0}},
    {"joint10", JointKind::kRevolute, 9, 9, 1, 9, 1,
     {0.0, 0.0, 1.0, 1.0, 0.0, 0.0, 0.0, 1.0, 0.0}, {0.0, 0.0, -0.4}},
    {"joint11", JointKind::kRevolute, 10, 10, 1, 10, 1,
     {0.0, 0.0, 1.0, 1.0, 0.0, 0.0, 0.0, 1.0, 0.0}, {0.0, -0.4, 0.0}},
    {"joint12", JointKind::kRevolute, 11, 11, 1, 11, 1,
     {0.0, 0.0, 1.0, 1.0, 0.0, 0.0, 0.0, 1.0, 0.0}, {-0.4, 0.0, 0.0}},
    {"joint13", JointKind::kRevolute, 12, 12, 1, 12, 1,
     {0.0, 0.0, 1.0, 1.0, 0.0, 0.0, 0.0, 1.0, 0.0}, {0.0, 0.0, -0.4}},
    {"joint14", JointKind::kRevolute, 13, 13, 1, 13, 1,
     {0.0, 0.0, 1.0, 1.0, 0.0, 0.0, 0.0, 1.0, 0.0}, {0.0, -0.4, 0.0}},
    {"joint15", JointKind::kRevolute, 14, 14, 1, 14, 1,
     {0.0, 0.0, 1.0, 1.0, 0.0, 0.0, 0.0, 1.0, 0.0}, {-0.4, 0.0, 0.0}},
    {"joint16", JointKind::kRevolute, 15, 15, 1, 15, 1,
     {0.0, 0.0, 1.0, 1.0, 0.0, 0.0, 0.0, 1.0, 0.0}, {0.0, 0.0, -0.4}}}};

[[maybe_unused]] constexpr std::array<MessageInfo, 8> kMessages{ {
    {2, 1, 27},  // 0: assembled: chain of "joint14"
    {1, 0, 27},  // 1: assembled: chain of "joint12"
    {0, 1, 6},  // 2: forces on: chain of "joint12"
    {1, 2, 6},  // 3: forces on: chain of "joint14"
    {0, 1, 28},  // 4: state
    {1, 0, 4},  // 5: accelerations
    {0, 2, 36},  // 6: state
    {2, 0, 4}}};  // 7: accelerations

constexpr std::array<LinkInertia, kJointCount> kInertias{ {
    {1.0, {0.0, -0.2, 0.0},
     {0.0001, 0.0, 0.0, 0.05333330000000001, 0.0, 0.0001}},
    {1.0, {-0.2, 0.0, 0.0},
     {0.05333330000000001, 0.0, 0.0, 0.0001, 0.0, 0.0001}},
    {1.0, {0.0, 0.0, -0.2},
     {0.0001, 0.0, 0.0, 0.0001, 0.0, 0.05333330000000001}},
    {1.0, {0.0, -0.2, 0.0},
     {0.0001, 0.0, 0.0, 0.05333330000000001, 0.0, 0.0001}},
    {1.0, {-0.2, 0.0, 0.0},
     {0.05333330000000001, 0.0, 0.0, 0.0001, 0.0, 0.0001}},
    {1.0, {0.0, 0.0, -0.2},
     {0.0001, 0.0, 0.0, 0.0001, 0.0, 0.05333330000000001}},
    {1.0, {0.0, -0.2, 0.0},
     {0.0001, 0.0, 0.0, 0.05333330000000001, 0.0, 0.0001}},
    {1.0, {-0.2, 0.0, 0.0},
     {0.05333330000000001, 0.0, 0.0, 0.0001, 0.0, 0.0001}},
    {1.0, {0.0, 0.0, -0.2},
     {0.0001, 0.0, 0.0, 0.0001, 0.0, 0.05333330000000001}},
    {1.0, {0.0, -0.2, 0.0},
     {0.0001, 0.0, 0.0, 0.05333330000000001, 0.0, 0.0001}},
    {1.0, {-0.2, 0.0, 0.0},
     {0.05333330000000001, 0.0, 0.0, 0.0001, 0.0, 0.0001}},
    {1.0, {0.0, 0.0, -0.2},
     {0.0001, 0.0, 0.0, 0.0001, 0.0, 0.05333330000000001}},
    {1.0, {0.0, -0.2, 0.0},
     {0.0001, 0.0, 0.0, 0.05333330000000001, 0.0, 0.0001}},
    {1.0, {-0.2, 0.0, 0.0},
     {0.05333330000000001, 0.0, 0.0, 0.0001, 0.0, 0.0001}},
    {1.0, {0.0, 0.0, -0.2},
     {0.0001, 0.0, 0.0, 0.0001, 0.0, 0.05333330000000001}},
    {1.0, {0.0, -0.2, 0.0},
     {0.0001, 0.0, 0.0, 0.05333330000000001, 0.0, 0.0001}}}};

constexpr LinkRole kRoles[3][kLinkCount]{
    {{1, 0, 1, 0}, {0, 1, 0, 0}, {0, 1, 0, 0}, {0, 1, 0, 0}, {0, 1, 0, 0}, {0, 1, 0, 0}, {0, 1, 0, 0}, {0, 1, 0, 0}, {0, 0, 0, 0}, {0, 0, 0, 0}, {0, 0, 0, 0}, {0, 0, 0, 0}, {0, 0, 0, 0}, {0, 0, 0, 0}, {0, 0, 0, 0}, {0, 0, 0, 0}, {0, 0, 0, 0}},
    {{0, 0, 0, 0}, {0, 0, 0, 0}, {0, 0, 0, 0}, {0, 0, 0, 0}, {0, 0, 0, 0}, {0, 0, 0, 0}, {0, 0, 0, 0}, {0, 0, 0, 0}, {1, 1, 1, 0}, {0, 1, 0, 0}, {0, 1, 0, 0}, {0, 1, 0, 0}, {0, 0, 0, 0}, {0, 0, 0, 0}, {0, 0, 0, 0}, {0, 0, 0, 0}, {0, 0, 0, 0}},
    {{0, 0, 0, 0}, {0, 0, 0, 0}, {0, 0, 0, 0}, {0, 0, 0, 0}, {0, 0, 0, 0}, {0, 0, 0, 0}, {0, 0, 0, 0}, {0, 0, 0, 0}, {0, 0, 0, 0}, {0, 0, 0, 0}, {0, 0, 0, 0}, {0, 0, 0, 0}, {1, 1, 1, 0}, {0, 1, 0, 0}, {0, 1, 0, 0}, {0, 1, 0, 0}, {0, 1, 0, 0}}};

// ---- functions ----------------------------------------------------------------------------------

#include "adagen/spatial.hpp"
#include "adagen/joins.hpp"
#include "adagen/channel.hpp"
#include "adagen/kernels/state.hpp"

namespace {

// Memory where segments meet, by joint.
struct Joint_joint04 {
  Mat6 Phi_rod07;
  Columns6 b_rod07;
  Columns6 F_on_rod07;
};
struct Joint_joint08 {
  Transform X, Y;  // to the joint's frame, about its two links' origins
  Joined<Revolute> joined;
};
struct Joint_joint10 {
  Mat6 Phi_rod08;
  Columns6 b_rod08;
  Mat6 Phi_rod11;
  Mat6 Phi_rod08_rod11;
  Columns6 b_rod11;
  Columns6 F_on_rod11;
};
struct Joint_joint12 {
  Mat6 Phi_rod08;
  Columns6 b_rod08;
  Transform X, Y;  // to the joint's frame, about its two links' origins
  Joined<Revolute> joined;
  Coupled<Revolute> at_rod08;
  Columns6 F_on_rod08;
};
struct Joint_joint14 {
  Mat6 Phi_rod12;
  Columns6 b_rod12;
  Columns6 F_on_rod12;
};
struct Cuts {
  Joint_joint04 j_joint04;
  Joint_joint08 j_joint08;
  Joint_joint10 j_joint10;
  Joint_joint12 j_joint12;
  Joint_joint14 j_joint14;
  std::array<Columns6, kLinkCount> loads;  // wrenches on links, from handle forces
  EIGEN_MAKE_ALIGNED_OPERATOR_NEW
};

}  // namespace

#include "adagen/kernels/inertias.hpp"
#include "adagen/kernels/keep_nothing.hpp"
#include "adagen/kernels/reach_nothing.hpp"
#include "adagen/kernels/sweeps.hpp"
#include "adagen/kernels/inward_columns.hpp"
#include "adagen/kernels/mobility.hpp"
#include "adagen/kernels/wrenches.hpp"
#include "adagen/kernels/carry.hpp"
#include "adagen/kernels/inward_carrying.hpp"
#include "adagen/exchange.hpp"

// ---- processes ----------------------------------------------------------------------------------

// Process 0: 8 of 16 joints: "joint01", "joint02", "joint03", "joint04", "joint05", "joint06", ...
static void run_0([[maybe_unused]] Workspace& w, [[maybe_unused]] Channel& channel) {
  require_finite(w, w.q, 0, 8, &JointConstants::q, kNotFinite);
  require_finite(w, w.v, 0, 8, &JointConstants::v, kNotFinite);
  require_finite(w, w.tau, 0, 8, &JointConstants::v, kNotFinite);
  std::copy_n(w.q + 0, 8, w.angle.data() + 0);
  turn<block(0), block(7) + 1>(w);
  outward<0, 7>(w);  // "joint01" .. "joint08"
  stamp(1);
  set_up_links<block(0), block(6) + 1>(w);
  set_up_columns<block(0), block(6) + 1>(w);
  const Way way_0 = inward_and_carry<0, 0, 6, true>(w);  // "joint01" .. "joint07"
  show<7>(w, way_0, w.j_joint04.Phi_rod07, w.j_joint04.b_rod07);
  stamp(2);
  {  // from process 1: assembled: chain of "joint12"
    const Number* from = channel.receive(1, w.status);
    from = get_symmetric(from, w.j_joint12.Phi_rod08);
    get(from, w.j_joint12.b_rod08);
  }
  stamp(3);
  {
    auto& i = w.j_joint08;
    set_transforms(w, 7, i.X, i.Y);
    load_torque(w, 7, 7, i.joined.tau);
    const Mat6 X_Phi_A = i.X * w.j_joint04.Phi_rod07;
    const Mat6 Phi_A = from_right(X_Phi_A, i.X);
    const Mat6 Phi_B = from_right(i.Y * w.j_joint12.Phi_rod08, i.Y);
    const Columns6 c = Columns6::Zero();
    if (!join(i.joined, Phi_A, Phi_B, i.X * w.j_joint04.b_rod07, i.Y * w.j_joint12.b_rod08, c))
      fail(w, kFactorization, 7);
  }
  stamp(4);
  {
    auto& i = w.j_joint08;
    Release<Revolute> release(i.joined);
    const Columns6 f = release.force();  // Eq. (8), (10)
    store_acceleration(w, 7, 7, release.qdd());  // Eq. (9)
    w.j_joint04.F_on_rod07 = -i.X.transposed_times(f);
    w.j_joint12.F_on_rod08 = i.Y.transposed_times(f);
  }
  stamp(5);
  {  // to process 1: forces on: chain of "joint12"
    Number* to = channel.outgoing(2, w.status);
    put(to, w.j_joint12.F_on_rod08);
    channel.send(2, w.status);
  }
  stamp(6);
  w.loads[7] = in_base(w, 7, w.j_joint04.F_on_rod07);
  deliver_along<0, 6>(w, way_0.moved);  // "joint01" .. "joint07"
  accelerate_along<0, 0, 6>(w);  // "joint01" .. "joint07"
  stamp(7);
  require_finite(w, w.answer.data(), 0, 8, &JointConstants::v, kOverflow);
  give(w, 0, 8);
}

// Process 1: 4 of 16 joints: "joint09", "joint10", "joint11", "joint12"; kinematics of 8 more on the way to the ground
static void run_1([[maybe_unused]] Workspace& w, [[maybe_unused]] Channel& channel) {
  require_finite(w, w.q, 0, 12, &JointConstants::q, kNotFinite);
  require_finite(w, w.v, 0, 12, &JointConstants::v, kNotFinite);
  require_finite(w, w.tau, 8, 4, &JointConstants::v, kNotFinite);
  std::copy_n(w.q + 0, 12, w.angle.data() + 0);
  turn<block(0), block(11) + 1>(w);
  pass_outward<0, 7>(w);  // "joint01" .. "joint08"
  outward<8, 11>(w);  // "joint09" .. "joint12"
  stamp(1);
  set_up_links<block(7), block(10) + 1>(w);
  set_up_columns<block(8), block(10) + 1>(w);
  const Way way_8 = inward_and_carry<1, 8, 10, true>(w);  // "joint09" .. "joint11"
  invert_root<1, 8>(w, w.j_joint10.Phi_rod08, w.j_joint10.b_rod08);
  show(way_8, w.j_joint10.Phi_rod08, w.j_joint10.b_rod08, w.j_joint10.Phi_rod11, w.j_joint10.b_rod11);
  w.j_joint10.Phi_rod08_rod11 = (way_8.moved * w.j_joint10.Phi_rod08).transpose();  // with link "rod08"
  stamp(2);
  {  // from process 2: assembled: chain of "joint14"
    const Number* from = channel.receive(0, w.status);
    from = get_symmetric(from, w.j_joint14.Phi_rod12);
    get(from, w.j_joint14.b_rod12);
  }
  stamp(3);
  {
    auto& i = w.j_joint12;
    set_transforms(w, 11, i.X, i.Y);
    load_torque(w, 11, 11, i.joined.tau);
    const Mat6 X_Phi_A = i.X * w.j_joint10.Phi_rod11;
    const Mat6 Phi_A = from_right(X_Phi_A, i.X);
    const Mat6 Phi_B = from_right(i.Y * w.j_joint14.Phi_rod12, i.Y);
    const Columns6 c = Columns6::Zero();
    if (!join(i.joined, Phi_A, Phi_B, i.X * w.j_joint10.b_rod11, i.Y * w.j_joint14.b_rod12, c))
      fail(w, kFactorization, 11);
    couple(i.joined, times_transposed(i.X, w.j_joint10.Phi_rod08_rod11), i.at_rod08);
    i.Phi_rod08 = w.j_joint10.Phi_rod08 - product(i.at_rod08, i.at_rod08);  // Eq. (3)
    i.b_rod08 = w.j_joint10.b_rod08 - bias_change(i.joined, i.at_rod08);  // Eq. (6)
  }
  stamp(4);
  {  // to process 0: assembled: chain of "joint12"
    Number* to = channel.outgoing(1, w.status);
    to = put_symmetric(to, w.j_joint12.Phi_rod08);
    put(to, w.j_joint12.b_rod08);
    channel.send(1, w.status);
  }
  stamp(5);
  {  // from process 0: forces on: chain of "joint12"
    const Number* from = channel.receive(2, w.status);
    get(from, w.j_joint12.F_on_rod08);
  }
  stamp(6);
  {
    auto& i = w.j_joint12;
    Release<Revolute> release(i.joined);
    release.feel_A(i.at_rod08, w.j_joint12.F_on_rod08);
    const Columns6 f = release.force();  // Eq. (8), (10)
    store_acceleration(w, 11, 11, release.qdd());  // Eq. (9)
    w.j_joint10.F_on_rod11 = -i.X.transposed_times(f);
    w.j_joint14.F_on_rod12 = i.Y.transposed_times(f);
  }
  stamp(7);
  {  // to process 2: forces on: chain of "joint14"
    Number* to = channel.outgoing(3, w.status);
    put(to, w.j_joint14.F_on_rod12);
    channel.send(3, w.status);
  }
  stamp(8);
  w.loads[8] = in_base(w, 8, w.j_joint12.F_on_rod08);
  w.loads[11] = in_base(w, 11, w.j_joint10.F_on_rod11);
  deliver_along<8, 10>(w, way_8.moved);  // "joint09" .. "joint11"
  accelerate_root<8>(w, w.j_joint10.Phi_rod08, w.j_joint10.b_rod08);
  accelerate_along<1, 8, 10>(w);  // "joint09" .. "joint11"
  stamp(9);
  require_finite(w, w.answer.data(), 8, 4, &JointConstants::v, kOverflow);
  give(w, 8, 4);
}

// Process 2: 4 of 16 joints: "joint13", "joint14", "joint15", "joint16"; kinematics of 12 more on the way to the ground
static void run_2([[maybe_unused]] Workspace& w, [[maybe_unused]] Channel& channel) {
  require_finite(w, w.q, 0, 16, &JointConstants::q, kNotFinite);
  require_finite(w, w.v, 0, 16, &JointConstants::v, kNotFinite);
  require_finite(w, w.tau, 12, 4, &JointConstants::v, kNotFinite);
  std::copy_n(w.q + 0, 16, w.angle.data() + 0);
  turn<block(0), block(15) + 1>(w);
  pass_outward<0, 11>(w);  // "joint01" .. "joint12"
  outward<12, 15>(w);  // "joint13" .. "joint16"
  stamp(1);
  set_up_links<block(11), block(15) + 1>(w);
  set_up_columns<block(12), block(15) + 1>(w);
  inward_in_columns<2, 12, 15, true>(w);  // "joint13" .. "joint16"
  invert_root<2, 12>(w, w.j_joint14.Phi_rod12, w.j_joint14.b_rod12);
  stamp(2);
  {  // to process 1: assembled: chain of "joint14"
    Number* to = channel.outgoing(0, w.status);
    to = put_symmetric(to, w.j_joint14.Phi_rod12);
    put(to, w.j_joint14.b_rod12);
    channel.send(0, w.status);
  }
  stamp(3);
  {  // from process 1: forces on: chain of "joint14"
    const Number* from = channel.receive(3, w.status);
    get(from, w.j_joint14.F_on_rod12);
  }
  stamp(4);
  w.loads[12] = in_base(w, 12, w.j_joint14.F_on_rod12);
  accelerate_root<12>(w, w.j_joint14.Phi_rod12, w.j_joint14.b_rod12);
  accelerate<2, 12, 15>(w);  // "joint13" .. "joint16"
  stamp(5);
  require_finite(w, w.answer.data(), 12, 4, &JointConstants::v, kOverflow);
  give(w, 12, 4);
}

[[maybe_unused]] constexpr std::array<StageInfo, 7> kStages_0{ {
    {"kinematics", 7, -1}, {"assembly", 6, -1}, {"receive", -1, 1}, {"assembly", 7, -1},
    {"disassembly", 7, -1}, {"send", -1, 2}, {"disassembly", 6, -1}
} };
[[maybe_unused]] constexpr std::array<StageInfo, 9> kStages_1{ {
    {"kinematics", 11, -1}, {"assembly", 10, -1}, {"receive", -1, 0}, {"assembly", 11, -1},
    {"send", -1, 1}, {"receive", -1, 2}, {"disassembly", 11, -1}, {"send", -1, 3},
    {"disassembly", 10, -1}
} };
[[maybe_unused]] constexpr std::array<StageInfo, 5> kStages_2{ {
    {"kinematics", 15, -1}, {"assembly", 12, -1}, {"send", -1, 0}, {"receive", -1, 3},
    {"disassembly", 12, -1}
} };
[[maybe_unused]] constexpr std::array<void (*)(Workspace&, Channel&), kProcesses> kRun{run_0, run_1, run_2};

constexpr std::array<Range, 4> kRanges_0{ {{0, 8}, {0, 8}, {0, 8}, {0, 8}} };
constexpr std::array<Range, 4> kRanges_1{ {{0, 12}, {0, 12}, {8, 4}, {8, 4}} };
constexpr std::array<Range, 4> kRanges_2{ {{0, 16}, {0, 16}, {12, 4}, {12, 4}} };
[[maybe_unused]] constexpr std::array<ProcessInfo, kProcesses> kProcess{ {
    {{1, kRanges_0.data()}, {1, kRanges_0.data() + 1}, {1, kRanges_0.data() + 2}, {1, kRanges_0.data() + 3}, {7, kStages_0.data()}},
    {{1, kRanges_1.data()}, {1, kRanges_1.data() + 1}, {1, kRanges_1.data() + 2}, {1, kRanges_1.data() + 3}, {9, kStages_1.data()}},
    {{1, kRanges_2.data()}, {1, kRanges_2.data() + 1}, {1, kRanges_2.data() + 2}, {1, kRanges_2.data() + 3}, {5, kStages_2.data()}}}};

#include "adagen/whole_mpi.hpp"
