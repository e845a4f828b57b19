// Forward dynamics of "chain16" on 4 processes, emitted by adagen 0.1.0 (solver.cpp.j2). Do not edit: generate again. Licence: yours to choose.
// robot     "chain16", 16 joints, 16 degrees of freedom, description sha256 b739552da6e27ec438b5eb7d6da98218430542949a453e8cd1010513e6e26b8a
// command   adagen ../models/chain16.urdf --procs 4 --form=ada --channel=message
// input     profile default, sha256 fe36af9ff4727e4941af0e7182db7f87cd64c54109bc287302f720e9ad83c3a8
// options   form ada (assembly-disassembly algorithm), shape joints (spatial vectors [angular; linear] in link frames whose joint axes are z), scalar double, channel message, fixed base, gravity 0.0, 0.0, -9.81
// needs     Eigen's headers
// links     adagen_program.cpp -DADAGEN_MPI; or, compiled with -DADAGEN_NO_MAIN, a program of yours that includes chain16_p4.h
// program   4 processes, joined at cuts; 2.18 us predicted (default profile)
//           process 0: joint01 .. joint06, joint10
//           process 1: joint07 .. joint09
//           process 2: joint11 .. joint13
//           process 3: joint14 .. joint16
// schedule  joint10@0-3(joint06@0-1(joint05@0(joint04(joint03(joint02(joint01|)|)|)|) | joint07@1(|joint08(|joint09))) | joint13@2-3(joint11@2(|joint12) | joint14@3(|joint15(|joint16))))
//
// Assembly-disassembly algorithm of Yamane and Nakamura. Phi are inverse articulated-body inertias, b
// bias accelerations. Joint i joins chain A (its parent link's side) and chain B (its child link's side)
// to chain C: assembly, Eq. (3)-(7), goes up the schedule, disassembly, Eq. (8)-(10), comes down.

#include "chain16_p4.h"
#define ADAGEN_CALL(word) chain16_p4_##word
#define ADAGEN_NAMED(WORD) CHAIN16_P4_##WORD
#define ADAGEN_MPI
#include "adagen/settings.hpp"

namespace { struct chain16_p4_settings : PlainSettings {
  static constexpr int kVersion = 100, kJointCount = 16, kNq = 16, kNv = 16;
  [[maybe_unused]] static constexpr const char* kRobot = "chain16";
  [[maybe_unused]] static constexpr const char* kChannel = "message";
  static constexpr int kProcesses = 4;
  static constexpr bool kAlone = false;
  static constexpr int kPlanMessages = 6;
  [[maybe_unused]] static constexpr Hops kHops = {{0, 152, 0.404}, {20.9, 192, 0.602}};
}; }  // namespace: a program may load several solvers of one name

#include "adagen/constants.hpp"

constexpr std::array<LinkConstants, kLinkCount> kLinks{ {
    {"ceiling", 0.0, {0.0, 0.0, 0.0}},
    {"rod01", 1.0, {0.0, -0.2, 0.0},
     {0.0134333, 0.0, 0.0, 0.0, 0.0002, 0.0, 0.0, 0.0, 0.0134333},
     {74.44187206419866, 0.0, 0.0, 0.0, 5000.0, 0.0, 0.0, 0.0, 74.44187206419866}},
    {"rod02", 1.0, {-0.2, 0.0, 0.0},
     {0.0002, 0.0, 0.0, 0.0, 0.0134333, 0.0, 0.0, 0.0, 0.0134333},
     {5000.0, 0.0, 0.0, 0.0, 74.44187206419866, 0.0, 0.0, 0.0, 74.44187206419866}},
    {"rod03", 1.0, {0.0, 0.0, -0.2},
     {0.0134333, 0.0, 0.0, 0.0, 0.0134333, 0.0, 0.0, 0.0, 0.0002},
     {74.44187206419866, 0.0, 0.0, 0.0, 74.44187206419866, 0.0, 0.0, 0.0, 5000.0}},
    {"rod04", 1.0, {0.0, -0.2, 0.0},
     {0.0134333, 0.0, 0.0, 0.0, 0.0002, 0.0, 0.0, 0.0, 0.0134333},
     {74.44187206419866, 0.0, 0.0, 0.0, 5000.0, 0.0, 0.0, 0.0, 74.44187206419866}},
    {"rod05", 1.0, {-0.2, 0.0, 0.0},
     {0.0002, 0.0, 0.0, 0.0, 0.0134333, 0.0, 0.0, 0.0, 0.0134333},
     {5000.0, 0.0, 0.0, 0.0, 74.44187206419866, 0.0, 0.0, 0.0, 74.44187206419866}},
    {"rod06", 1.0, {0.0, 0.0, -0.2},
     {0.0134333, 0.0, 0.0, 0.0, 0.0134333, 0.0, 0.0, 0.0, 0.0002},
     {74.44187206419866, 0.0, 0.0, 0.0, 74.44187206419866, 0.0, 0.0, 0.0, 5000.0}},
    {"rod07", 1.0, {0.0, -0.2, 0.0},
     {0.0134333, 0.0, 0.0, 0.0, 0.0002, 0.0, 0.0, 0.0, 0.0134333},
     {74.44187206419866, 0.0, 0.0, 0.0, 5000.0, 0.0, 0.0, 0.0, 74.44187206419866}},
    {"rod08", 1.0, {-0.2, 0.0, 0.0},
     {0.0002, 0.0, 0.0, 0.0, 0.0134333, 0.0, 0.0, 0.0, 0.0134333},
     {5000.0, 0.0, 0.0, 0.0, 74.44187206419866, 0.0, 0.0, 0.0, 74.44187206419866}},
    {"rod09", 1.0, {0.0, 0.0, -0.2},
     {0.0134333, 0.0, 0.0, 0.0, 0.0134333, 0.0, 0.0, 0.0, 0.0002},
     {74.44187206419866, 0.0, 0.0, 0.0, 74.44187206419866, 0.0, 0.0, 0.0, 5000.0}},
    {"rod10", 1.0, {0.0, -0.2, 0.0},
     {0.0134333, 0.0, 0.0, 0.0, 0.0002, 0.0, 0.0, 0.0, 0.0134333},
     {74.44187206419866, 0.0, 0.0, 0.0, 5000.0, 0.0, 0.0, 0.0, 74.44187206419866}},
    {"rod11", 1.0, {-0.2, 0.0, 0.0},
     {0.0002, 0.0, 0.0, 0.0, 0.0134333, 0.0, 0.0, 0.0, 0.0134333},
     {5000.0, 0.0, 0.0, 0.0, 74.44187206419866, 0.0, 0.0, 0.0, 74.44187206419866}},
    {"rod12", 1.0, {0.0, 0.0, -0.2},
     {0.0134333, 0.0, 0.0, 0.0, 0.0134333, 0.0, 0.0, 0.0, 0.0002},
     {74.44187206419866, 0.0, 0.0, 0.0, 74.44187206419866, 0.0, 0.0, 0.0, 5000.0}},
    {"rod13", 1.0, {0.0, -0.2, 0.0},
     {0.0134333, 0.0, 0.0, 0.0, 0.0002, 0.0, 0.0, 0.0, 0.0134333},
     {74.44187206419866, 0.0, 0.0, 0.0, 5000.0, 0.0, 0.0, 0.0, 74.44187206419866}},
    {"rod14", 1.0, {-0.2, 0.0, 0.0},
     {0.0002, 0.0, 0.0, 0.0, 0.0134333, 0.0, 0.0, 0.0, 0.0134333},
     {5000.0, 0.0, 0.0, 0.0, 74.44187206419866, 0.0, 0.0, 0.0, 74.44187206419866}},
    {"rod15", 1.0, {0.0, 0.0, -0.2},
     {0.0134333, 0.0, 0.0, 0.0, 0.0134333, 0.0, 0.0, 0.0, 0.0002},
     {74.44187206419866, 0.0, 0.0, 0.0, 74.44187206419866, 0.0, 0.0, 0.0, 5000.0}},
    {"rod16", 1.0, {0.0, -0.2, 0.0},
     {0.0134333, 0.0, 0.0, 0.0, 0.0002, 0.0, 0.0, 0.0, 0.0134333},
     {74.44187206419866, 0.0, 0.0, 0.0, 5000.0, 0.0, 0.0, 0.0, 74.44187206419866}}}};

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

[[maybe_unused]] constexpr std::array<MessageInfo, 12> kMessages{ {
    {1, 0, 90},  // 0: assembled: chain of "joint07"
    {3, 2, 27},  // 1: assembled: chain of "joint14"
    {2, 0, 27},  // 2: assembled: chain of "joint13"
    {0, 2, 6},  // 3: forces on: chain of "joint13"
    {0, 1, 12},  // 4: forces on: chain of "joint07"
    {2, 3, 6},  // 5: forces on: chain of "joint14"
    {0, 1, 21},  // 6: state
    {1, 0, 3},  // 7: accelerations
    {0, 2, 29},  // 8: state
    {2, 0, 3},  // 9: accelerations
    {0, 3, 35},  // 10: state
    {3, 0, 3}}};  // 11: accelerations

// ---- functions ----------------------------------------------------------------------------------

#include "adagen/joins.hpp"
#include "adagen/channel.hpp"
#include "adagen/joints_memory.hpp"

namespace {

struct Joint_joint01 {
  Transform X;  // frame of "ceiling" to that of "rod01"
  Vec6 v;  // velocity of link "rod01"
  Columns6 b;  // bias of the bare link "rod01"
  Mat6 Phi_rod01;  // of the chain it completes
  Columns6 b_rod01;
  Joined<Revolute> joined;
  Coupled<Revolute> at_rod01;
  Columns6 F_on_rod01;  // outer wrench on that chain
};

struct Joint_joint02 {
  Transform X;  // frame of "rod01" to that of "rod02"
  Vec6 v;  // velocity of link "rod02"
  Columns6 b;  // bias of the bare link "rod02"
  Mat6 Phi_rod02;  // of the chain it completes
  Columns6 b_rod02;
  Joined<Revolute> joined;
  Coupled<Revolute> at_rod02;
  Columns6 F_on_rod02;  // outer wrench on that chain
};

struct Joint_joint03 {
  Transform X;  // frame of "rod02" to that of "rod03"
  Vec6 v;  // velocity of link "rod03"
  Columns6 b;  // bias of the bare link "rod03"
  Mat6 Phi_rod03;  // of the chain it completes
  Columns6 b_rod03;
  Joined<Revolute> joined;
  Coupled<Revolute> at_rod03;
  Columns6 F_on_rod03;  // outer wrench on that chain
};

struct Joint_joint04 {
  Transform X;  // frame of "rod03" to that of "rod04"
  Vec6 v;  // velocity of link "rod04"
  Columns6 b;  // bias of the bare link "rod04"
  Mat6 Phi_rod04;  // of the chain it completes
  Columns6 b_rod04;
  Joined<Revolute> joined;
  Coupled<Revolute> at_rod04;
  Columns6 F_on_rod04;  // outer wrench on that chain
};

struct Joint_joint05 {
  Transform X;  // frame of "rod04" to that of "rod05"
  Vec6 v;  // velocity of link "rod05"
  Columns6 b;  // bias of the bare link "rod05"
  Mat6 Phi_rod05;  // of the chain it completes
  Columns6 b_rod05;
  Joined<Revolute> joined;
  Coupled<Revolute> at_rod05;
  Columns6 F_on_rod05;  // outer wrench on that chain
};

struct Joint_joint06 {
  Transform X;  // frame of "rod05" to that of "rod06"
  Vec6 v;  // velocity of link "rod06"
  Mat6 Phi_rod09;  // of the chain it completes
  Columns6 b_rod09;
  Joined<Revolute> joined;
  Coupled<Revolute> at_rod09;
  Columns6 b;  // bias of the bare link "rod06"
  Columns6 F_on_rod09;  // outer wrench on that chain
};

struct Joint_joint07 {
  Transform X;  // frame of "rod06" to that of "rod07"
  Vec6 v;  // velocity of link "rod07"
  Columns6 b;  // bias of the bare link "rod07"
  Mat6 Phi_rod06;  // of the chain it completes
  Mat6 Phi_rod06_rod09;  // of the chain it completes
  Mat6 Phi_rod09;  // of the chain it completes
  Columns6 b_rod06;
  Columns6 b_rod09;
  Joined<Revolute> joined;
  Coupled<Revolute> at_rod06;
  Coupled<Revolute> at_rod09;
  Columns6 F_on_rod06;  // outer wrench on that chain
};

struct Joint_joint08 {
  Transform X;  // frame of "rod07" to that of "rod08"
  Vec6 v;  // velocity of link "rod08"
  Columns6 b;  // bias of the bare link "rod08"
  Mat6 Phi_rod07;  // of the chain it completes
  Mat6 Phi_rod07_rod09;  // of the chain it completes
  Mat6 Phi_rod09;  // of the chain it completes
  Columns6 b_rod07;
  Columns6 b_rod09;
  Joined<Revolute> joined;
  Coupled<Revolute> at_rod07;
  Coupled<Revolute> at_rod09;
  Columns6 F_on_rod07;  // outer wrench on that chain
};

struct Joint_joint09 {
  Transform X;  // frame of "rod08" to that of "rod09"
  Vec6 v;  // velocity of link "rod09"
  Columns6 b;  // bias of the bare link "rod09"
  Mat6 Phi_rod08;  // of the chain it completes
  Mat6 Phi_rod08_rod09;  // of the chain it completes
  Mat6 Phi_rod09;  // of the chain it completes
  Columns6 b_rod08;
  Columns6 b_rod09;
  Joined<Revolute> joined;
  Coupled<Revolute> at_rod08;
  Coupled<Revolute> at_rod09;
  Columns6 F_on_rod08;  // outer wrench on that chain
};

struct Joint_joint10 {
  Transform X;  // frame of "rod09" to that of "rod10"
  Vec6 v;  // velocity of link "rod10"
  Joined<Revolute> joined;
  Columns6 b;  // bias of the bare link "rod10"
};

struct Joint_joint11 {
  Transform X;  // frame of "rod10" to that of "rod11"
  Vec6 v;  // velocity of link "rod11"
  Columns6 b;  // bias of the bare link "rod11"
  Mat6 Phi_rod10;  // of the chain it completes
  Mat6 Phi_rod10_rod12;  // of the chain it completes
  Mat6 Phi_rod12;  // of the chain it completes
  Columns6 b_rod10;
  Columns6 b_rod12;
  Joined<Revolute> joined;
  Coupled<Revolute> at_rod10;
  Coupled<Revolute> at_rod12;
  Columns6 F_on_rod12;  // outer wrench on that chain
};

struct Joint_joint12 {
  Transform X;  // frame of "rod11" to that of "rod12"
  Vec6 v;  // velocity of link "rod12"
  Columns6 b;  // bias of the bare link "rod12"
  Mat6 Phi_rod11;  // of the chain it completes
  Mat6 Phi_rod11_rod12;  // of the chain it completes
  Mat6 Phi_rod12;  // of the chain it completes
  Columns6 b_rod11;
  Columns6 b_rod12;
  Joined<Revolute> joined;
  Coupled<Revolute> at_rod11;
  Coupled<Revolute> at_rod12;
  Columns6 F_on_rod11;  // outer wrench on that chain
};

struct Joint_joint13 {
  Transform X;  // frame of "rod12" to that of "rod13"
  Vec6 v;  // velocity of link "rod13"
  Mat6 Phi_rod10;  // of the chain it completes
  Columns6 b_rod10;
  Joined<Revolute> joined;
  Coupled<Revolute> at_rod10;
  Columns6 b;  // bias of the bare link "rod13"
  Columns6 F_on_rod10;  // outer wrench on that chain
};

struct Joint_joint14 {
  Transform X;  // frame of "rod13" to that of "rod14"
  Vec6 v;  // velocity of link "rod14"
  Columns6 b;  // bias of the bare link "rod14"
  Mat6 Phi_rod13;  // of the chain it completes
  Columns6 b_rod13;
  Joined<Revolute> joined;
  Coupled<Revolute> at_rod13;
  Columns6 F_on_rod13;  // outer wrench on that chain
};

struct Joint_joint15 {
  Transform X;  // frame of "rod14" to that of "rod15"
  Vec6 v;  // velocity of link "rod15"
  Columns6 b;  // bias of the bare link "rod15"
  Mat6 Phi_rod14;  // of the chain it completes
  Columns6 b_rod14;
  Joined<Revolute> joined;
  Coupled<Revolute> at_rod14;
  Columns6 F_on_rod14;  // outer wrench on that chain
};

struct Joint_joint16 {
  Transform X;  // frame of "rod15" to that of "rod16"
  Vec6 v;  // velocity of link "rod16"
  Columns6 b;  // bias of the bare link "rod16"
  Mat6 Phi_rod15;  // of the chain it completes
  Columns6 b_rod15;
  Joined<Revolute> joined;
  Coupled<Revolute> at_rod15;
  Columns6 F_on_rod15;  // outer wrench on that chain
};

struct Workspace : JointsMemory {
  Joint_joint01 j_joint01;  // and of link "rod01"
  Joint_joint02 j_joint02;  // and of link "rod02"
  Joint_joint03 j_joint03;  // and of link "rod03"
  Joint_joint04 j_joint04;  // and of link "rod04"
  Joint_joint05 j_joint05;  // and of link "rod05"
  Joint_joint06 j_joint06;  // and of link "rod06"
  Joint_joint07 j_joint07;  // and of link "rod07"
  Joint_joint08 j_joint08;  // and of link "rod08"
  Joint_joint09 j_joint09;  // and of link "rod09"
  Joint_joint10 j_joint10;  // and of link "rod10"
  Joint_joint11 j_joint11;  // and of link "rod11"
  Joint_joint12 j_joint12;  // and of link "rod12"
  Joint_joint13 j_joint13;  // and of link "rod13"
  Joint_joint14 j_joint14;  // and of link "rod14"
  Joint_joint15 j_joint15;  // and of link "rod15"
  Joint_joint16 j_joint16;  // and of link "rod16"
};

}  // namespace

#include "adagen/memory.hpp"
#include "adagen/exchange.hpp"

const Mat6 kPhi_rod01 = symmetric({74.44187206419866, 0.0, 0.0, 0.0, 0.0, 14.888374412839735, 5000.0, 0.0, 0.0, 0.0, 0.0, 74.44187206419866, -14.888374412839735, 0.0, 0.0, 3.977674882567947, 0.0, 0.0, 1.0, 0.0, 3.977674882567947});
const Mat6 kPhi_rod02 = symmetric({5000.0, 0.0, 0.0, 0.0, 0.0, 0.0, 74.44187206419866, 0.0, 0.0, 0.0, -14.888374412839735, 74.44187206419866, 0.0, 14.888374412839735, 0.0, 1.0, 0.0, 0.0, 3.977674882567947, 0.0, 3.977674882567947});
const Mat6 kPhi_rod03 = symmetric({74.44187206419866, 0.0, 0.0, 0.0, -14.888374412839735, 0.0, 74.44187206419866, 0.0, 14.888374412839735, 0.0, 0.0, 5000.0, 0.0, 0.0, 0.0, 3.977674882567947, 0.0, 0.0, 3.977674882567947, 0.0, 1.0});
const Mat6 kPhi_rod04 = symmetric({74.44187206419866, 0.0, 0.0, 0.0, 0.0, 14.888374412839735, 5000.0, 0.0, 0.0, 0.0, 0.0, 74.44187206419866, -14.888374412839735, 0.0, 0.0, 3.977674882567947, 0.0, 0.0, 1.0, 0.0, 3.977674882567947});
const Mat6 kPhi_rod05 = symmetric({5000.0, 0.0, 0.0, 0.0, 0.0, 0.0, 74.44187206419866, 0.0, 0.0, 0.0, -14.888374412839735, 74.44187206419866, 0.0, 14.888374412839735, 0.0, 1.0, 0.0, 0.0, 3.977674882567947, 0.0, 3.977674882567947});
const Mat6 kPhi_rod06 = symmetric({74.44187206419866, 0.0, 0.0, 0.0, -14.888374412839735, 0.0, 74.44187206419866, 0.0, 14.888374412839735, 0.0, 0.0, 5000.0, 0.0, 0.0, 0.0, 3.977674882567947, 0.0, 0.0, 3.977674882567947, 0.0, 1.0});
const Mat6 kPhi_rod07 = symmetric({74.44187206419866, 0.0, 0.0, 0.0, 0.0, 14.888374412839735, 5000.0, 0.0, 0.0, 0.0, 0.0, 74.44187206419866, -14.888374412839735, 0.0, 0.0, 3.977674882567947, 0.0, 0.0, 1.0, 0.0, 3.977674882567947});
const Mat6 kPhi_rod08 = symmetric({5000.0, 0.0, 0.0, 0.0, 0.0, 0.0, 74.44187206419866, 0.0, 0.0, 0.0, -14.888374412839735, 74.44187206419866, 0.0, 14.888374412839735, 0.0, 1.0, 0.0, 0.0, 3.977674882567947, 0.0, 3.977674882567947});
const Mat6 kPhi_rod09 = symmetric({74.44187206419866, 0.0, 0.0, 0.0, -14.888374412839735, 0.0, 74.44187206419866, 0.0, 14.888374412839735, 0.0, 0.0, 5000.0, 0.0, 0.0, 0.0, 3.977674882567947, 0.0, 0.0, 3.977674882567947, 0.0, 1.0});
const Mat6 kPhi_rod10 = symmetric({74.44187206419866, 0.0, 0.0, 0.0, 0.0, 14.888374412839735, 5000.0, 0.0, 0.0, 0.0, 0.0, 74.44187206419866, -14.888374412839735, 0.0, 0.0, 3.977674882567947, 0.0, 0.0, 1.0, 0.0, 3.977674882567947});
const Mat6 kPhi_rod11 = symmetric({5000.0, 0.0, 0.0, 0.0, 0.0, 0.0, 74.44187206419866, 0.0, 0.0, 0.0, -14.888374412839735, 74.44187206419866, 0.0, 14.888374412839735, 0.0, 1.0, 0.0, 0.0, 3.977674882567947, 0.0, 3.977674882567947});
const Mat6 kPhi_rod12 = symmetric({74.44187206419866, 0.0, 0.0, 0.0, -14.888374412839735, 0.0, 74.44187206419866, 0.0, 14.888374412839735, 0.0, 0.0, 5000.0, 0.0, 0.0, 0.0, 3.977674882567947, 0.0, 0.0, 3.977674882567947, 0.0, 1.0});
const Mat6 kPhi_rod13 = symmetric({74.44187206419866, 0.0, 0.0, 0.0, 0.0, 14.888374412839735, 5000.0, 0.0, 0.0, 0.0, 0.0, 74.44187206419866, -14.888374412839735, 0.0, 0.0, 3.977674882567947, 0.0, 0.0, 1.0, 0.0, 3.977674882567947});
const Mat6 kPhi_rod14 = symmetric({5000.0, 0.0, 0.0, 0.0, 0.0, 0.0, 74.44187206419866, 0.0, 0.0, 0.0, -14.888374412839735, 74.44187206419866, 0.0, 14.888374412839735, 0.0, 1.0, 0.0, 0.0, 3.977674882567947, 0.0, 3.977674882567947});
const Mat6 kPhi_rod15 = symmetric({74.44187206419866, 0.0, 0.0, 0.0, -14.888374412839735, 0.0, 74.44187206419866, 0.0, 14.888374412839735, 0.0, 0.0, 5000.0, 0.0, 0.0, 0.0, 3.977674882567947, 0.0, 0.0, 3.977674882567947, 0.0, 1.0});
const Mat6 kPhi_rod16 = symmetric({74.44187206419866, 0.0, 0.0, 0.0, 0.0, 14.888374412839735, 5000.0, 0.0, 0.0, 0.0, 0.0, 74.44187206419866, -14.888374412839735, 0.0, 0.0, 3.977674882567947, 0.0, 0.0, 1.0, 0.0, 3.977674882567947});

// ---- joint 0 "joint01": revolute, between links "ceiling" and "rod01"

static void kinematics_joint01(Workspace& w) {
  auto& i = w.j_joint01;
  require_finite(w, w.q + 0, 1, 0);
  require_finite(w, w.v + 0, 1, 0);
  const Real q = Real(w.q[0]), c = std::cos(q), s = std::sin(q);
  i.X.E << 0.0, c, s,  0.0, -s, c,  1.0, 0.0, 0.0;  // row by row
  i.X.r << 0.0, 0.0, 0.0;
  i.v = joint_velocity<Revolute>(w.v + 0);
}

// A: the ground "ceiling"; B: link "rod01"; C feels the joint at "rod01"
static void assemble_joint01(Workspace& w) {
  auto& i = w.j_joint01;
  load_torque(w, 0, 0, i.joined.tau);
  const Columns6 c = Columns6::Zero();
  constexpr std::array<Real, 6> least{1.0578826286319819e-12, 7.105427357601002e-11, 1.0578826286319819e-12, 5.652615986048129e-14, 1.4210854715202004e-14, 5.652615986048129e-14};
  if (!keeps_digits<Revolute>(kZero, kPhi_rod01, least))
    fail(w, kGrowth, 0);
  if (!join(i.joined, kZero, kPhi_rod01, i.X * w.ground, w.j_joint01.b, c))
    fail(w, kFactorization, 0);
  couple(i.joined, kPhi_rod01, i.at_rod01);
  i.Phi_rod01 = kPhi_rod01 - product(i.at_rod01, i.at_rod01);  // Eq. (4)
  i.b_rod01 = w.j_joint01.b + bias_change(i.joined, i.at_rod01);  // Eq. (7)
}

static void disassemble_joint01(Workspace& w) {
  auto& i = w.j_joint01;
  Release<Revolute> release(i.joined);
  release.feel_B(i.at_rod01, w.j_joint01.F_on_rod01);
  release.force();  // Eq. (8)
  store_acceleration(w, 0, 0, release.qdd());  // Eq. (9)
}

// ---- joint 1 "joint02": revolute, between links "rod01" and "rod02"

static void kinematics_joint02(Workspace& w) {
  auto& i = w.j_joint02;
  require_finite(w, w.q + 1, 1, 1);
  require_finite(w, w.v + 1, 1, 1);
  const Real q = Real(w.q[1]), c = std::cos(q), s = std::sin(q);
  i.X.E << 0.0, c, s,  0.0, -s, c,  1.0, 0.0, 0.0;  // row by row
  i.X.r << 0.0, -0.4, 0.0;
  i.v = i.X * w.j_joint01.v + joint_velocity<Revolute>(w.v + 1);
}

// A: the chain of "joint01"; B: link "rod02"; C feels the joint at "rod02"
static void assemble_joint02(Workspace& w) {
  auto& i = w.j_joint02;
  load_torque(w, 1, 1, i.joined.tau);
  const Mat6 X_Phi_A = i.X * w.j_joint01.Phi_rod01;
  const Mat6 Phi_A = from_right(X_Phi_A, i.X);
  const Columns6 c = velocity_product<Revolute>(i.v, w.v + 1);
  constexpr std::array<Real, 6> least{7.157930644734229e-11, 1.5829154999642512e-12, 1.5829154999642512e-12, 2.842170943040401e-14, 7.073701457568329e-14, 7.073701457568329e-14};
  if (!keeps_digits<Revolute>(Phi_A, kPhi_rod02, least))
    fail(w, kGrowth, 1);
  if (!join(i.joined, Phi_A, kPhi_rod02, i.X * w.j_joint01.b_rod01, w.j_joint02.b, c))
    fail(w, kFactorization, 1);
  couple(i.joined, kPhi_rod02, i.at_rod02);
  i.Phi_rod02 = kPhi_rod02 - product(i.at_rod02, i.at_rod02);  // Eq. (4)
  i.b_rod02 = w.j_joint02.b + bias_change(i.joined, i.at_rod02);  // Eq. (7)
}

static void disassemble_joint02(Workspace& w) {
  auto& i = w.j_joint02;
  Release<Revolute> release(i.joined);
  release.feel_B(i.at_rod02, w.j_joint02.F_on_rod02);
  const Columns6 f = release.force();  // Eq. (8), (10)
  store_acceleration(w, 1, 1, release.qdd());  // Eq. (9)
  w.j_joint01.F_on_rod01 = -i.X.transposed_times(f);
}

// ---- joint 2 "joint03": revolute, between links "rod02" and "rod03"

static void kinematics_joint03(Workspace& w) {
  auto& i = w.j_joint03;
  require_finite(w, w.q + 2, 1, 2);
  require_finite(w, w.v + 2, 1, 2);
  const Real q = Real(w.q[2]), c = std::cos(q), s = std::sin(q);
  i.X.E << 0.0, c, s,  0.0, -s, c,  1.0, 0.0, 0.0;  // row by row
  i.X.r << -0.4, 0.0, 0.0;
  i.v = i.X * w.j_joint02.v + joint_velocity<Revolute>(w.v + 2);
}

// A: the chain of "joint02"; B: link "rod03"; C feels the joint at "rod03"
static void assemble_joint03(Workspace& w) {
  auto& i = w.j_joint03;
  load_torque(w, 2, 2, i.joined.tau);
  const Mat6 X_Phi_A = i.X * w.j_joint02.Phi_rod02;
  const Mat6 Phi_A = from_right(X_Phi_A, i.X);
  const Columns6 c = velocity_product<Revolute>(i.v, w.v + 2);
  constexpr std::array<Real, 6> least{1.5829154999642512e-12, 1.5829154999642512e-12, 7.157930644734229e-11, 7.073701457568329e-14, 7.073701457568329e-14, 2.842170943040401e-14};
  if (!keeps_digits<Revolute>(Phi_A, kPhi_rod03, least))
    fail(w, kGrowth, 2);
  if (!join(i.joined, Phi_A, kPhi_rod03, i.X * w.j_joint02.b_rod02, w.j_joint03.b, c))
    fail(w, kFactorization, 2);
  couple(i.joined, kPhi_rod03, i.at_rod03);
  i.Phi_rod03 = kPhi_rod03 - product(i.at_rod03, i.at_rod03);  // Eq. (4)
  i.b_rod03 = w.j_joint03.b + bias_change(i.joined, i.at_rod03);  // Eq. (7)
}

static void disassemble_joint03(Workspace& w) {
  auto& i = w.j_joint03;
  Release<Revolute> release(i.joined);
  release.feel_B(i.at_rod03, w.j_joint03.F_on_rod03);
  const Columns6 f = release.force();  // Eq. (8), (10)
  store_acceleration(w, 2, 2, release.qdd());  // Eq. (9)
  w.j_joint02.F_on_rod02 = -i.X.transposed_times(f);
}

// ---- joint 3 "joint04": revolute, between links "rod03" and "rod04"

static void kinematics_joint04(Workspace& w) {
  auto& i = w.j_joint04;
  require_finite(w, w.q + 3, 1, 3);
  require_finite(w, w.v + 3, 1, 3);
  const Real q = Real(w.q[3]), c = std::cos(q), s = std::sin(q);
  i.X.E << 0.0, c, s,  0.0, -s, c,  1.0, 0.0, 0.0;  // row by row
  i.X.r << 0.0, 0.0, -0.4;
  i.v = i.X * w.j_joint03.v + joint_velocity<Revolute>(w.v + 3);
}

// A: the chain of "joint03"; B: link "rod04"; C feels the joint at "rod04"
static void assemble_joint04(Workspace& w) {
  auto& i = w.j_joint04;
  load_torque(w, 3, 3, i.joined.tau);
  const Mat6 X_Phi_A = i.X * w.j_joint03.Phi_rod03;
  const Mat6 Phi_A = from_right(X_Phi_A, i.X);
  const Columns6 c = velocity_product<Revolute>(i.v, w.v + 3);
  constexpr std::array<Real, 6> least{1.5829154999642512e-12, 7.157930644734229e-11, 1.5829154999642512e-12, 7.073701457568329e-14, 2.842170943040401e-14, 7.073701457568329e-14};
  if (!keeps_digits<Revolute>(Phi_A, kPhi_rod04, least))
    fail(w, kGrowth, 3);
  if (!join(i.joined, Phi_A, kPhi_rod04, i.X * w.j_joint03.b_rod03, w.j_joint04.b, c))
    fail(w, kFactorization, 3);
  couple(i.joined, kPhi_rod04, i.at_rod04);
  i.Phi_rod04 = kPhi_rod04 - product(i.at_rod04, i.at_rod04);  // Eq. (4)
  i.b_rod04 = w.j_joint04.b + bias_change(i.joined, i.at_rod04);  // Eq. (7)
}

static void disassemble_joint04(Workspace& w) {
  auto& i = w.j_joint04;
  Release<Revolute> release(i.joined);
  release.feel_B(i.at_rod04, w.j_joint04.F_on_rod04);
  const Columns6 f = release.force();  // Eq. (8), (10)
  store_acceleration(w, 3, 3, release.qdd());  // Eq. (9)
  w.j_joint03.F_on_rod03 = -i.X.transposed_times(f);
}

// ---- joint 4 "joint05": revolute, between links "rod04" and "rod05"

static void kinematics_joint05(Workspace& w) {
  auto& i = w.j_joint05;
  require_finite(w, w.q + 4, 1, 4);
  require_finite(w, w.v + 4, 1, 4);
  const Real q = Real(w.q[4]), c = std::cos(q), s = std::sin(q);
  i.X.E << 0.0, c, s,  0.0, -s, c,  1.0, 0.0, 0.0;  // row by row
  i.X.r << 0.0, -0.4, 0.0;
  i.v = i.X * w.j_joint04.v + joint_velocity<Revolute>(w.v + 4);
}

// A: the chain of "joint04"; B: link "rod05"; C feels the joint at "rod05"
static void assemble_joint05(Workspace& w) {
  auto& i = w.j_joint05;
  load_torque(w, 4, 4, i.joined.tau);
  const Mat6 X_Phi_A = i.X * w.j_joint04.Phi_rod04;
  const Mat6 Phi_A = from_right(X_Phi_A, i.X);
  const Columns6 c = velocity_product<Revolute>(i.v, w.v + 4);
  constexpr std::array<Real, 6> least{7.157930644734229e-11, 1.5829154999642512e-12, 1.5829154999642512e-12, 2.842170943040401e-14, 7.073701457568329e-14, 7.073701457568329e-14};
  if (!keeps_digits<Revolute>(Phi_A, kPhi_rod05, least))
    fail(w, kGrowth, 4);
  if (!join(i.joined, Phi_A, kPhi_rod05, i.X * w.j_joint04.b_rod04, w.j_joint05.b, c))
    fail(w, kFactorization, 4);
  couple(i.joined, kPhi_rod05, i.at_rod05);
  i.Phi_rod05 = kPhi_rod05 - product(i.at_rod05, i.at_rod05);  // Eq. (4)
  i.b_rod05 = w.j_joint05.b + bias_change(i.joined, i.at_rod05);  // Eq. (7)
}

static void disassemble_joint05(Workspace& w) {
  auto& i = w.j_joint05;
  Release<Revolute> release(i.joined);
  release.feel_B(i.at_rod05, w.j_joint05.F_on_rod05);
  const Columns6 f = release.force();  // Eq. (8), (10)
  store_acceleration(w, 4, 4, release.qdd());  // Eq. (9)
  w.j_joint04.F_on_rod04 = -i.X.transposed_times(f);
}

// ---- joint 5 "joint06": revolute, between links "rod05" and "rod06"

static void kinematics_joint06(Workspace& w) {
  auto& i = w.j_joint06;
  require_finite(w, w.q + 5, 1, 5);
  require_finite(w, w.v + 5, 1, 5);
  const Real q = Real(w.q[5]), c = std::cos(q), s = std::sin(q);
  i.X.E << 0.0, c, s,  0.0, -s, c,  1.0, 0.0, 0.0;  // row by row
  i.X.r << -0.4, 0.0, 0.0;
  i.v = i.X * w.j_joint05.v + joint_velocity<Revolute>(w.v + 5);
}

// A: the chain of "joint05"; B: the chain of "joint07"; C feels the joint at "rod09"
static void assemble_joint06(Workspace& w) {
  auto& i = w.j_joint06;
  load_torque(w, 5, 5, i.joined.tau);
  const Mat6 X_Phi_A = i.X * w.j_joint05.Phi_rod05;
  const Mat6 Phi_A = from_right(X_Phi_A, i.X);
  const Columns6 c = velocity_product<Revolute>(i.v, w.v + 5);
  constexpr std::array<Real, 6> least{1.5829154999642512e-12, 1.5829154999642512e-12, 7.157930644734229e-11, 7.073701457568329e-14, 7.073701457568329e-14, 2.842170943040401e-14};
  if (!keeps_digits<Revolute>(Phi_A, w.j_joint07.Phi_rod06, least))
    fail(w, kGrowth, 5);
  if (!join(i.joined, Phi_A, w.j_joint07.Phi_rod06, i.X * w.j_joint05.b_rod05, w.j_joint07.b_rod06, c))
    fail(w, kFactorization, 5);
  couple(i.joined, w.j_joint07.Phi_rod06_rod09, i.at_rod09);
  i.Phi_rod09 = w.j_joint07.Phi_rod09 - product(i.at_rod09, i.at_rod09);  // Eq. (4)
  i.b_rod09 = w.j_joint07.b_rod09 + bias_change(i.joined, i.at_rod09);  // Eq. (7)
}

static void disassemble_joint06(Workspace& w) {
  auto& i = w.j_joint06;
  Release<Revolute> release(i.joined);
  release.feel_B(i.at_rod09, w.j_joint06.F_on_rod09);
  const Columns6 f = release.force();  // Eq. (8), (10)
  store_acceleration(w, 5, 5, release.qdd());  // Eq. (9)
  w.j_joint05.F_on_rod05 = -i.X.transposed_times(f);
  w.j_joint07.F_on_rod06 = f;
}

// ---- joint 6 "joint07": revolute, between links "rod06" and "rod07"

static void kinematics_joint07(Workspace& w) {
  auto& i = w.j_joint07;
  require_finite(w, w.q + 6, 1, 6);
  require_finite(w, w.v + 6, 1, 6);
  const Real q = Real(w.q[6]), c = std::cos(q), s = std::sin(q);
  i.X.E << 0.0, c, s,  0.0, -s, c,  1.0, 0.0, 0.0;  // row by row
  i.X.r << 0.0, 0.0, -0.4;
  i.v = i.X * w.j_joint06.v + joint_velocity<Revolute>(w.v + 6);
}

// A: link "rod06"; B: the chain of "joint08"; C feels the joint at "rod06", "rod09"
static void assemble_joint07(Workspace& w) {
  auto& i = w.j_joint07;
  load_torque(w, 6, 6, i.joined.tau);
  const Mat6 X_Phi_A = i.X * kPhi_rod06;
  const Mat6 Phi_A = from_right(X_Phi_A, i.X);
  const Columns6 c = velocity_product<Revolute>(i.v, w.v + 6);
  constexpr std::array<Real, 6> least{1.5829154999642512e-12, 7.157930644734229e-11, 1.5829154999642512e-12, 7.073701457568329e-14, 2.842170943040401e-14, 7.073701457568329e-14};
  if (!keeps_digits<Revolute>(Phi_A, w.j_joint08.Phi_rod07, least))
    fail(w, kGrowth, 6);
  if (!join(i.joined, Phi_A, w.j_joint08.Phi_rod07, i.X * w.j_joint06.b, w.j_joint08.b_rod07, c))
    fail(w, kFactorization, 6);
  couple(i.joined, X_Phi_A, i.at_rod06);
  couple(i.joined, w.j_joint08.Phi_rod07_rod09, i.at_rod09);
  i.Phi_rod06 = kPhi_rod06 - product(i.at_rod06, i.at_rod06);  // Eq. (3)
  i.Phi_rod06_rod09 = product(i.at_rod06, i.at_rod09);  // Eq. (5)
  i.Phi_rod09 = w.j_joint08.Phi_rod09 - product(i.at_rod09, i.at_rod09);  // Eq. (4)
  i.b_rod06 = w.j_joint06.b - bias_change(i.joined, i.at_rod06);  // Eq. (6)
  i.b_rod09 = w.j_joint08.b_rod09 + bias_change(i.joined, i.at_rod09);  // Eq. (7)
}

static void disassemble_joint07(Workspace& w) {
  auto& i = w.j_joint07;
  Release<Revolute> release(i.joined);
  release.feel_A(i.at_rod06, w.j_joint07.F_on_rod06);
  release.feel_B(i.at_rod09, w.j_joint06.F_on_rod09);
  const Columns6 f = release.force();  // Eq. (8), (10)
  store_acceleration(w, 6, 6, release.qdd());  // Eq. (9)
  w.j_joint08.F_on_rod07 = f;
}

// ---- joint 7 "joint08": revolute, between links "rod07" and "rod08"

static void kinematics_joint08(Workspace& w) {
  auto& i = w.j_joint08;
  require_finite(w, w.q + 7, 1, 7);
  require_finite(w, w.v + 7, 1, 7);
  const Real q = Real(w.q[7]), c = std::cos(q), s = std::sin(q);
  i.X.E << 0.0, c, s,  0.0, -s, c,  1.0, 0.0, 0.0;  // row by row
  i.X.r << 0.0, -0.4, 0.0;
  i.v = i.X * w.j_joint07.v + joint_velocity<Revolute>(w.v + 7);
}

// A: link "rod07"; B: the chain of "joint09"; C feels the joint at "rod07", "rod09"
static void assemble_joint08(Workspace& w) {
  auto& i = w.j_joint08;
  load_torque(w, 7, 7, i.joined.tau);
  const Mat6 X_Phi_A = i.X * kPhi_rod07;
  const Mat6 Phi_A = from_right(X_Phi_A, i.X);
  const Columns6 c = velocity_product<Revolute>(i.v, w.v + 7);
  constexpr std::array<Real, 6> least{7.157930644734229e-11, 1.5829154999642512e-12, 1.5829154999642512e-12, 2.842170943040401e-14, 7.073701457568329e-14, 7.073701457568329e-14};
  if (!keeps_digits<Revolute>(Phi_A, w.j_joint09.Phi_rod08, least))
    fail(w, kGrowth, 7);
  if (!join(i.joined, Phi_A, w.j_joint09.Phi_rod08, i.X * w.j_joint07.b, w.j_joint09.b_rod08, c))
    fail(w, kFactorization, 7);
  couple(i.joined, X_Phi_A, i.at_rod07);
  couple(i.joined, w.j_joint09.Phi_rod08_rod09, i.at_rod09);
  i.Phi_rod07 = kPhi_rod07 - product(i.at_rod07, i.at_rod07);  // Eq. (3)
  i.Phi_rod07_rod09 = product(i.at_rod07, i.at_rod09);  // Eq. (5)
  i.Phi_rod09 = w.j_joint09.Phi_rod09 - product(i.at_rod09, i.at_rod09);  // Eq. (4)
  i.b_rod07 = w.j_joint07.b - bias_change(i.joined, i.at_rod07);  // Eq. (6)
  i.b_rod09 = w.j_joint09.b_rod09 + bias_change(i.joined, i.at_rod09);  // Eq. (7)
}

static void disassemble_joint08(Workspace& w) {
  auto& i = w.j_joint08;
  Release<Revolute> release(i.joined);
  release.feel_A(i.at_rod07, w.j_joint08.F_on_rod07);
  release.feel_B(i.at_rod09, w.j_joint06.F_on_rod09);
  const Columns6 f = release.force();  // Eq. (8), (10)
  store_acceleration(w, 7, 7, release.qdd());  // Eq. (9)
  w.j_joint09.F_on_rod08 = f;
}

// ---- joint 8 "joint09": revolute, between links "rod08" and "rod09"

static void kinematics_joint09(Workspace& w) {
  auto& i = w.j_joint09;
  require_finite(w, w.q + 8, 1, 8);
  require_finite(w, w.v + 8, 1, 8);
  const Real q = Real(w.q[8]), c = std::cos(q), s = std::sin(q);
  i.X.E << 0.0, c, s,  0.0, -s, c,  1.0, 0.0, 0.0;  // row by row
  i.X.r << -0.4, 0.0, 0.0;
  i.v = i.X * w.j_joint08.v + joint_velocity<Revolute>(w.v + 8);
}

// A: link "rod08"; B: link "rod09"; C feels the joint at "rod08", "rod09"
static void assemble_joint09(Workspace& w) {
  auto& i = w.j_joint09;
  load_torque(w, 8, 8, i.joined.tau);
  const Mat6 X_Phi_A = i.X * kPhi_rod08;
  const Mat6 Phi_A = from_right(X_Phi_A, i.X);
  const Columns6 c = velocity_product<Revolute>(i.v, w.v + 8);
  constexpr std::array<Real, 6> least{1.5829154999642512e-12, 1.5829154999642512e-12, 7.157930644734229e-11, 7.073701457568329e-14, 7.073701457568329e-14, 2.842170943040401e-14};
  if (!keeps_digits<Revolute>(Phi_A, kPhi_rod09, least))
    fail(w, kGrowth, 8);
  if (!join(i.joined, Phi_A, kPhi_rod09, i.X * w.j_joint08.b, w.j_joint09.b, c))
    fail(w, kFactorization, 8);
  couple(i.joined, X_Phi_A, i.at_rod08);
  couple(i.joined, kPhi_rod09, i.at_rod09);
  i.Phi_rod08 = kPhi_rod08 - product(i.at_rod08, i.at_rod08);  // Eq. (3)
  i.Phi_rod08_rod09 = product(i.at_rod08, i.at_rod09);  // Eq. (5)
  i.Phi_rod09 = kPhi_rod09 - product(i.at_rod09, i.at_rod09);  // Eq. (4)
  i.b_rod08 = w.j_joint08.b - bias_change(i.joined, i.at_rod08);  // Eq. (6)
  i.b_rod09 = w.j_joint09.b + bias_change(i.joined, i.at_rod09);  // Eq. (7)
}

static void disassemble_joint09(Workspace& w) {
  auto& i = w.j_joint09;
  Release<Revolute> release(i.joined);
  release.feel_A(i.at_rod08, w.j_joint09.F_on_rod08);
  release.feel_B(i.at_rod09, w.j_joint06.F_on_rod09);
  release.force();  // Eq. (8)
  store_acceleration(w, 8, 8, release.qdd());  // Eq. (9)
}

// ---- joint 9 "joint10": revolute, between links "rod09" and "rod10"

static void kinematics_joint10(Workspace& w) {
  auto& i = w.j_joint10;
  require_finite(w, w.q + 9, 1, 9);
  require_finite(w, w.v + 9, 1, 9);
  const Real q = Real(w.q[9]), c = std::cos(q), s = std::sin(q);
  i.X.E << 0.0, c, s,  0.0, -s, c,  1.0, 0.0, 0.0;  // row by row
  i.X.r << 0.0, 0.0, -0.4;
  i.v = i.X * w.j_joint09.v + joint_velocity<Revolute>(w.v + 9);
}

// A: the chain of "joint06"; B: the chain of "joint13"; C feels the joint at no link
static void assemble_joint10(Workspace& w) {
  auto& i = w.j_joint10;
  load_torque(w, 9, 9, i.joined.tau);
  const Mat6 X_Phi_A = i.X * w.j_joint06.Phi_rod09;
  const Mat6 Phi_A = from_right(X_Phi_A, i.X);
  const Columns6 c = velocity_product<Revolute>(i.v, w.v + 9);
  constexpr std::array<Real, 6> least{1.5829154999642512e-12, 7.157930644734229e-11, 1.5829154999642512e-12, 7.073701457568329e-14, 2.842170943040401e-14, 7.073701457568329e-14};
  if (!keeps_digits<Revolute>(Phi_A, w.j_joint13.Phi_rod10, least))
    fail(w, kGrowth, 9);
  if (!join(i.joined, Phi_A, w.j_joint13.Phi_rod10, i.X * w.j_joint06.b_rod09, w.j_joint13.b_rod10, c))
    fail(w, kFactorization, 9);
}

static void disassemble_joint10(Workspace& w) {
  auto& i = w.j_joint10;
  Release<Revolute> release(i.joined);
  const Columns6 f = release.force();  // Eq. (8), (10)
  store_acceleration(w, 9, 9, release.qdd());  // Eq. (9)
  w.j_joint06.F_on_rod09 = -i.X.transposed_times(f);
  w.j_joint13.F_on_rod10 = f;
}

// ---- joint 10 "joint11": revolute, between links "rod10" and "rod11"

static void kinematics_joint11(Workspace& w) {
  auto& i = w.j_joint11;
  require_finite(w, w.q + 10, 1, 10);
  require_finite(w, w.v + 10, 1, 10);
  const Real q = Real(w.q[10]), c = std::cos(q), s = std::sin(q);
  i.X.E << 0.0, c, s,  0.0, -s, c,  1.0, 0.0, 0.0;  // row by row
  i.X.r << 0.0, -0.4, 0.0;
  i.v = i.X * w.j_joint10.v + joint_velocity<Revolute>(w.v + 10);
}

// A: link "rod10"; B: the chain of "joint12"; C feels the joint at "rod10", "rod12"
static void assemble_joint11(Workspace& w) {
  auto& i = w.j_joint11;
  load_torque(w, 10, 10, i.joined.tau);
  const Mat6 X_Phi_A = i.X * kPhi_rod10;
  const Mat6 Phi_A = from_right(X_Phi_A, i.X);
  const Columns6 c = velocity_product<Revolute>(i.v, w.v + 10);
  constexpr std::array<Real, 6> least{7.157930644734229e-11, 1.5829154999642512e-12, 1.5829154999642512e-12, 2.842170943040401e-14, 7.073701457568329e-14, 7.073701457568329e-14};
  if (!keeps_digits<Revolute>(Phi_A, w.j_joint12.Phi_rod11, least))
    fail(w, kGrowth, 10);
  if (!join(i.joined, Phi_A, w.j_joint12.Phi_rod11, i.X * w.j_joint10.b, w.j_joint12.b_rod11, c))
    fail(w, kFactorization, 10);
  couple(i.joined, X_Phi_A, i.at_rod10);
  couple(i.joined, w.j_joint12.Phi_rod11_rod12, i.at_rod12);
  i.Phi_rod10 = kPhi_rod10 - product(i.at_rod10, i.at_rod10);  // Eq. (3)
  i.Phi_rod10_rod12 = product(i.at_rod10, i.at_rod12);  // Eq. (5)
  i.Phi_rod12 = w.j_joint12.Phi_rod12 - product(i.at_rod12, i.at_rod12);  // Eq. (4)
  i.b_rod10 = w.j_joint10.b - bias_change(i.joined, i.at_rod10);  // Eq. (6)
  i.b_rod12 = w.j_joint12.b_rod12 + bias_change(i.joined, i.at_rod12);  // Eq. (7)
}

static void disassemble_joint11(Workspace& w) {
  auto& i = w.j_joint11;
  Release<Revolute> release(i.joined);
  release.feel_A(i.at_rod10, w.j_joint13.F_on_rod10);
  release.feel_B(i.at_rod12, w.j_joint11.F_on_rod12);
  const Columns6 f = release.force();  // Eq. (8), (10)
  store_acceleration(w, 10, 10, release.qdd());  // Eq. (9)
  w.j_joint12.F_on_rod11 = f;
}

// ---- joint 11 "joint12": revolute, between links "rod11" and "rod12"

static void kinematics_joint12(Workspace& w) {
  auto& i = w.j_joint12;
  require_finite(w, w.q + 11, 1, 11);
  require_finite(w, w.v + 11, 1, 11);
  const Real q = Real(w.q[11]), c = std::cos(q), s = std::sin(q);
  i.X.E << 0.0, c, s,  0.0, -s, c,  1.0, 0.0, 0.0;  // row by row
  i.X.r << -0.4, 0.0, 0.0;
  i.v = i.X * w.j_joint11.v + joint_velocity<Revolute>(w.v + 11);
}

// A: link "rod11"; B: link "rod12"; C feels the joint at "rod11", "rod12"
static void assemble_joint12(Workspace& w) {
  auto& i = w.j_joint12;
  load_torque(w, 11, 11, i.joined.tau);
  const Mat6 X_Phi_A = i.X * kPhi_rod11;
  const Mat6 Phi_A = from_right(X_Phi_A, i.X);
  const Columns6 c = velocity_product<Revolute>(i.v, w.v + 11);
  constexpr std::array<Real, 6> least{1.5829154999642512e-12, 1.5829154999642512e-12, 7.157930644734229e-11, 7.073701457568329e-14, 7.073701457568329e-14, 2.842170943040401e-14};
  if (!keeps_digits<Revolute>(Phi_A, kPhi_rod12, least))
    fail(w, kGrowth, 11);
  if (!join(i.joined, Phi_A, kPhi_rod12, i.X * w.j_joint11.b, w.j_joint12.b, c))
    fail(w, kFactorization, 11);
  couple(i.joined, X_Phi_A, i.at_rod11);
  couple(i.joined, kPhi_rod12, i.at_rod12);
  i.Phi_rod11 = kPhi_rod11 - product(i.at_rod11, i.at_rod11);  // Eq. (3)
  i.Phi_rod11_rod12 = product(i.at_rod11, i.at_rod12);  // Eq. (5)
  i.Phi_rod12 = kPhi_rod12 - product(i.at_rod12, i.at_rod12);  // Eq. (4)
  i.b_rod11 = w.j_joint11.b - bias_change(i.joined, i.at_rod11);  // Eq. (6)
  i.b_rod12 = w.j_joint12.b + bias_change(i.joined, i.at_rod12);  // Eq. (7)
}

static void disassemble_joint12(Workspace& w) {
  auto& i = w.j_joint12;
  Release<Revolute> release(i.joined);
  release.feel_A(i.at_rod11, w.j_joint12.F_on_rod11);
  release.feel_B(i.at_rod12, w.j_joint11.F_on_rod12);
  release.force();  // Eq. (8)
  store_acceleration(w, 11, 11, release.qdd());  // Eq. (9)
}

// ---- joint 12 "joint13": revolute, between links "rod12" and "rod13"

static void kinematics_joint13(Workspace& w) {
  auto& i = w.j_joint13;
  require_finite(w, w.q + 12, 1, 12);
  require_finite(w, w.v + 12, 1, 12);
  const Real q = Real(w.q[12]), c = std::cos(q), s = std::sin(q);
  i.X.E << 0.0, c, s,  0.0, -s, c,  1.0, 0.0, 0.0;  // row by row
  i.X.r << 0.0, 0.0, -0.4;
  i.v = i.X * w.j_joint12.v + joint_velocity<Revolute>(w.v + 12);
}

// A: the chain of "joint11"; B: the chain of "joint14"; C feels the joint at "rod10"
static void assemble_joint13(Workspace& w) {
  auto& i = w.j_joint13;
  load_torque(w, 12, 12, i.joined.tau);
  const Mat6 X_Phi_A = i.X * w.j_joint11.Phi_rod12;
  const Mat6 Phi_A = from_right(X_Phi_A, i.X);
  const Columns6 c = velocity_product<Revolute>(i.v, w.v + 12);
  constexpr std::array<Real, 6> least{1.5829154999642512e-12, 7.157930644734229e-11, 1.5829154999642512e-12, 7.073701457568329e-14, 2.842170943040401e-14, 7.073701457568329e-14};
  if (!keeps_digits<Revolute>(Phi_A, w.j_joint14.Phi_rod13, least))
    fail(w, kGrowth, 12);
  if (!join(i.joined, Phi_A, w.j_joint14.Phi_rod13, i.X * w.j_joint11.b_rod12, w.j_joint14.b_rod13, c))
    fail(w, kFactorization, 12);
  couple(i.joined, times_transposed(i.X, w.j_joint11.Phi_rod10_rod12), i.at_rod10);
  i.Phi_rod10 = w.j_joint11.Phi_rod10 - product(i.at_rod10, i.at_rod10);  // Eq. (3)
  i.b_rod10 = w.j_joint11.b_rod10 - bias_change(i.joined, i.at_rod10);  // Eq. (6)
}

static void disassemble_joint13(Workspace& w) {
  auto& i = w.j_joint13;
  Release<Revolute> release(i.joined);
  release.feel_A(i.at_rod10, w.j_joint13.F_on_rod10);
  const Columns6 f = release.force();  // Eq. (8), (10)
  store_acceleration(w, 12, 12, release.qdd());  // Eq. (9)
  w.j_joint11.F_on_rod12 = -i.X.transposed_times(f);
  w.j_joint14.F_on_rod13 = f;
}

// ---- joint 13 "joint14": revolute, between links "rod13" and "rod14"

static void kinematics_joint14(Workspace& w) {
  auto& i = w.j_joint14;
  require_finite(w, w.q + 13, 1, 13);
  require_finite(w, w.v + 13, 1, 13);
  const Real q = Real(w.q[13]), c = std::cos(q), s = std::sin(q);
  i.X.E << 0.0, c, s,  0.0, -s, c,  1.0, 0.0, 0.0;  // row by row
  i.X.r << 0.0, -0.4, 0.0;
  i.v = i.X * w.j_joint13.v + joint_velocity<Revolute>(w.v + 13);
}

// A: link "rod13"; B: the chain of "joint15"; C feels the joint at "rod13"
static void assemble_joint14(Workspace& w) {
  auto& i = w.j_joint14;
  load_torque(w, 13, 13, i.joined.tau);
  const Mat6 X_Phi_A = i.X * kPhi_rod13;
  const Mat6 Phi_A = from_right(X_Phi_A, i.X);
  const Columns6 c = velocity_product<Revolute>(i.v, w.v + 13);
  constexpr std::array<Real, 6> least{7.157930644734229e-11, 1.5829154999642512e-12, 1.5829154999642512e-12, 2.842170943040401e-14, 7.073701457568329e-14, 7.073701457568329e-14};
  if (!keeps_digits<Revolute>(Phi_A, w.j_joint15.Phi_rod14, least))
    fail(w, kGrowth, 13);
  if (!join(i.joined, Phi_A, w.j_joint15.Phi_rod14, i.X * w.j_joint13.b, w.j_joint15.b_rod14, c))
    fail(w, kFactorization, 13);
  couple(i.joined, X_Phi_A, i.at_rod13);
  i.Phi_rod13 = kPhi_rod13 - product(i.at_rod13, i.at_rod13);  // Eq. (3)
  i.b_rod13 = w.j_joint13.b - bias_change(i.joined, i.at_rod13);  // Eq. (6)
}

static void disassemble_joint14(Workspace& w) {
  auto& i = w.j_joint14;
  Release<Revolute> release(i.joined);
  release.feel_A(i.at_rod13, w.j_joint14.F_on_rod13);
  const Columns6 f = release.force();  // Eq. (8), (10)
  store_acceleration(w, 13, 13, release.qdd());  // Eq. (9)
  w.j_joint15.F_on_rod14 = f;
}

// ---- joint 14 "joint15": revolute, between links "rod14" and "rod15"

static void kinematics_joint15(Workspace& w) {
  auto& i = w.j_joint15;
  require_finite(w, w.q + 14, 1, 14);
  require_finite(w, w.v + 14, 1, 14);
  const Real q = Real(w.q[14]), c = std::cos(q), s = std::sin(q);
  i.X.E << 0.0, c, s,  0.0, -s, c,  1.0, 0.0, 0.0;  // row by row
  i.X.r << -0.4, 0.0, 0.0;
  i.v = i.X * w.j_joint14.v + joint_velocity<Revolute>(w.v + 14);
}

// A: link "rod14"; B: the chain of "joint16"; C feels the joint at "rod14"
static void assemble_joint15(Workspace& w) {
  auto& i = w.j_joint15;
  load_torque(w, 14, 14, i.joined.tau);
  const Mat6 X_Phi_A = i.X * kPhi_rod14;
  const Mat6 Phi_A = from_right(X_Phi_A, i.X);
  const Columns6 c = velocity_product<Revolute>(i.v, w.v + 14);
  constexpr std::array<Real, 6> least{1.5829154999642512e-12, 1.5829154999642512e-12, 7.157930644734229e-11, 7.073701457568329e-14, 7.073701457568329e-14, 2.842170943040401e-14};
  if (!keeps_digits<Revolute>(Phi_A, w.j_joint16.Phi_rod15, least))
    fail(w, kGrowth, 14);
  if (!join(i.joined, Phi_A, w.j_joint16.Phi_rod15, i.X * w.j_joint14.b, w.j_joint16.b_rod15, c))
    fail(w, kFactorization, 14);
  couple(i.joined, X_Phi_A, i.at_rod14);
  i.Phi_rod14 = kPhi_rod14 - product(i.at_rod14, i.at_rod14);  // Eq. (3)
  i.b_rod14 = w.j_joint14.b - bias_change(i.joined, i.at_rod14);  // Eq. (6)
}

static void disassemble_joint15(Workspace& w) {
  auto& i = w.j_joint15;
  Release<Revolute> release(i.joined);
  release.feel_A(i.at_rod14, w.j_joint15.F_on_rod14);
  const Columns6 f = release.force();  // Eq. (8), (10)
  store_acceleration(w, 14, 14, release.qdd());  // Eq. (9)
  w.j_joint16.F_on_rod15 = f;
}

// ---- joint 15 "joint16": revolute, between links "rod15" and "rod16"

static void kinematics_joint16(Workspace& w) {
  auto& i = w.j_joint16;
  require_finite(w, w.q + 15, 1, 15);
  require_finite(w, w.v + 15, 1, 15);
  const Real q = Real(w.q[15]), c = std::cos(q), s = std::sin(q);
  i.X.E << 0.0, c, s,  0.0, -s, c,  1.0, 0.0, 0.0;  // row by row
  i.X.r << 0.0, 0.0, -0.4;
  i.v = i.X * w.j_joint15.v + joint_velocity<Revolute>(w.v + 15);
}

// A: link "rod15"; B: link "rod16"; C feels the joint at "rod15"
static void assemble_joint16(Workspace& w) {
  auto& i = w.j_joint16;
  load_torque(w, 15, 15, i.joined.tau);
  const Mat6 X_Phi_A = i.X * kPhi_rod15;
  const Mat6 Phi_A = from_right(X_Phi_A, i.X);
  const Columns6 c = velocity_product<Revolute>(i.v, w.v + 15);
  constexpr std::array<Real, 6> least{1.5829154999642512e-12, 7.157930644734229e-11, 1.5829154999642512e-12, 7.073701457568329e-14, 2.842170943040401e-14, 7.073701457568329e-14};
  if (!keeps_digits<Revolute>(Phi_A, kPhi_rod16, least))
    fail(w, kGrowth, 15);
  if (!join(i.joined, Phi_A, kPhi_rod16, i.X * w.j_joint15.b, w.j_joint16.b, c))
    fail(w, kFactorization, 15);
  couple(i.joined, X_Phi_A, i.at_rod15);
  i.Phi_rod15 = kPhi_rod15 - product(i.at_rod15, i.at_rod15);  // Eq. (3)
  i.b_rod15 = w.j_joint15.b - bias_change(i.joined, i.at_rod15);  // Eq. (6)
}

static void disassemble_joint16(Workspace& w) {
  auto& i = w.j_joint16;
  Release<Revolute> release(i.joined);
  release.feel_A(i.at_rod15, w.j_joint16.F_on_rod15);
  release.force();  // Eq. (8)
  store_acceleration(w, 15, 15, release.qdd());  // Eq. (9)
}

// ---- processes ----------------------------------------------------------------------------------

// Process 0: 7 of 16 joints: "joint01", "joint02", "joint03", "joint04", "joint05", "joint06", ...; kinematics of 3 more on the way to the ground
static void run_0([[maybe_unused]] Workspace& w, [[maybe_unused]] Channel& channel) {
  w.ground = ground(w);
  kinematics_joint01(w);
  kinematics_joint02(w);
  kinematics_joint03(w);
  kinematics_joint04(w);
  kinematics_joint05(w);
  kinematics_joint06(w);
  kinematics_joint07(w);
  kinematics_joint08(w);
  kinematics_joint09(w);
  kinematics_joint10(w);
  stamp(1);
  link_bias(kLinks[1], w.j_joint01.v, w.j_joint01.b);
  assemble_joint01(w);
  link_bias(kLinks[2], w.j_joint02.v, w.j_joint02.b);
  assemble_joint02(w);
  link_bias(kLinks[3], w.j_joint03.v, w.j_joint03.b);
  assemble_joint03(w);
  link_bias(kLinks[4], w.j_joint04.v, w.j_joint04.b);
  assemble_joint04(w);
  link_bias(kLinks[5], w.j_joint05.v, w.j_joint05.b);
  assemble_joint05(w);
  stamp(2);
  {  // from process 1: assembled: chain of "joint07"
    const Number* from = channel.receive(0, w.status);
    from = get_symmetric(from, w.j_joint07.Phi_rod06);
    from = get(from, w.j_joint07.Phi_rod06_rod09);
    from = get_symmetric(from, w.j_joint07.Phi_rod09);
    from = get(from, w.j_joint07.b_rod06);
    get(from, w.j_joint07.b_rod09);
  }
  stamp(3);
  assemble_joint06(w);
  stamp(4);
  {  // from process 2: assembled: chain of "joint13"
    const Number* from = channel.receive(2, w.status);
    from = get_symmetric(from, w.j_joint13.Phi_rod10);
    get(from, w.j_joint13.b_rod10);
  }
  stamp(5);
  assemble_joint10(w);
  stamp(6);
  disassemble_joint10(w);
  stamp(7);
  {  // to process 2: forces on: chain of "joint13"
    Number* to = channel.outgoing(3, w.status);
    put(to, w.j_joint13.F_on_rod10);
    channel.send(3, w.status);
  }
  stamp(8);
  disassemble_joint06(w);
  stamp(9);
  {  // to process 1: forces on: chain of "joint07"
    Number* to = channel.outgoing(4, w.status);
    to = put(to, w.j_joint07.F_on_rod06);
    put(to, w.j_joint06.F_on_rod09);
    channel.send(4, w.status);
  }
  stamp(10);
  disassemble_joint05(w);
  disassemble_joint04(w);
  disassemble_joint03(w);
  disassemble_joint02(w);
  disassemble_joint01(w);
  stamp(11);
}

// Process 1: 3 of 16 joints: "joint07", "joint08", "joint09"; kinematics of 6 more on the way to the ground
static void run_1([[maybe_unused]] Workspace& w, [[maybe_unused]] Channel& channel) {
  w.ground = ground(w);
  kinematics_joint01(w);
  kinematics_joint02(w);
  kinematics_joint03(w);
  kinematics_joint04(w);
  kinematics_joint05(w);
  kinematics_joint06(w);
  kinematics_joint07(w);
  kinematics_joint08(w);
  kinematics_joint09(w);
  stamp(1);
  link_bias(kLinks[8], w.j_joint08.v, w.j_joint08.b);
  link_bias(kLinks[9], w.j_joint09.v, w.j_joint09.b);
  assemble_joint09(w);
  link_bias(kLinks[7], w.j_joint07.v, w.j_joint07.b);
  assemble_joint08(w);
  link_bias(kLinks[6], w.j_joint06.v, w.j_joint06.b);
  assemble_joint07(w);
  stamp(2);
  {  // to process 0: assembled: chain of "joint07"
    Number* to = channel.outgoing(0, w.status);
    to = put_symmetric(to, w.j_joint07.Phi_rod06);
    to = put(to, w.j_joint07.Phi_rod06_rod09);
    to = put_symmetric(to, w.j_joint07.Phi_rod09);
    to = put(to, w.j_joint07.b_rod06);
    put(to, w.j_joint07.b_rod09);
    channel.send(0, w.status);
  }
  stamp(3);
  {  // from process 0: forces on: chain of "joint07"
    const Number* from = channel.receive(4, w.status);
    from = get(from, w.j_joint07.F_on_rod06);
    get(from, w.j_joint06.F_on_rod09);
  }
  stamp(4);
  disassemble_joint07(w);
  disassemble_joint08(w);
  disassemble_joint09(w);
  stamp(5);
}

// Process 2: 3 of 16 joints: "joint11", "joint12", "joint13"; kinematics of 10 more on the way to the ground
static void run_2([[maybe_unused]] Workspace& w, [[maybe_unused]] Channel& channel) {
  w.ground = ground(w);
  kinematics_joint01(w);
  kinematics_joint02(w);
  kinematics_joint03(w);
  kinematics_joint04(w);
  kinematics_joint05(w);
  kinematics_joint06(w);
  kinematics_joint07(w);
  kinematics_joint08(w);
  kinematics_joint09(w);
  kinematics_joint10(w);
  kinematics_joint11(w);
  kinematics_joint12(w);
  kinematics_joint13(w);
  stamp(1);
  link_bias(kLinks[11], w.j_joint11.v, w.j_joint11.b);
  link_bias(kLinks[12], w.j_joint12.v, w.j_joint12.b);
  assemble_joint12(w);
  link_bias(kLinks[10], w.j_joint10.v, w.j_joint10.b);
  assemble_joint11(w);
  stamp(2);
  {  // from process 3: assembled: chain of "joint14"
    const Number* from = channel.receive(1, w.status);
    from = get_symmetric(from, w.j_joint14.Phi_rod13);
    get(from, w.j_joint14.b_rod13);
  }
  stamp(3);
  assemble_joint13(w);
  stamp(4);
  {  // to process 0: assembled: chain of "joint13"
    Number* to = channel.outgoing(2, w.status);
    to = put_symmetric(to, w.j_joint13.Phi_rod10);
    put(to, w.j_joint13.b_rod10);
    channel.send(2, w.status);
  }
  stamp(5);
  {  // from process 0: forces on: chain of "joint13"
    const Number* from = channel.receive(3, w.status);
    get(from, w.j_joint13.F_on_rod10);
  }
  stamp(6);
  disassemble_joint13(w);
  stamp(7);
  {  // to process 3: forces on: chain of "joint14"
    Number* to = channel.outgoing(5, w.status);
    put(to, w.j_joint14.F_on_rod13);
    channel.send(5, w.status);
  }
  stamp(8);
  disassemble_joint11(w);
  disassemble_joint12(w);
  stamp(9);
}

// Process 3: 3 of 16 joints: "joint14", "joint15", "joint16"; kinematics of 13 more on the way to the ground
static void run_3([[maybe_unused]] Workspace& w, [[maybe_unused]] Channel& channel) {
  w.ground = ground(w);
  kinematics_joint01(w);
  kinematics_joint02(w);
  kinematics_joint03(w);
  kinematics_joint04(w);
  kinematics_joint05(w);
  kinematics_joint06(w);
  kinematics_joint07(w);
  kinematics_joint08(w);
  kinematics_joint09(w);
  kinematics_joint10(w);
  kinematics_joint11(w);
  kinematics_joint12(w);
  kinematics_joint13(w);
  kinematics_joint14(w);
  kinematics_joint15(w);
  kinematics_joint16(w);
  stamp(1);
  link_bias(kLinks[15], w.j_joint15.v, w.j_joint15.b);
  link_bias(kLinks[16], w.j_joint16.v, w.j_joint16.b);
  assemble_joint16(w);
  link_bias(kLinks[14], w.j_joint14.v, w.j_joint14.b);
  assemble_joint15(w);
  link_bias(kLinks[13], w.j_joint13.v, w.j_joint13.b);
  assemble_joint14(w);
  stamp(2);
  {  // to process 2: assembled: chain of "joint14"
    Number* to = channel.outgoing(1, w.status);
    to = put_symmetric(to, w.j_joint14.Phi_rod13);
    put(to, w.j_joint14.b_rod13);
    channel.send(1, w.status);
  }
  stamp(3);
  {  // from process 2: forces on: chain of "joint14"
    const Number* from = channel.receive(5, w.status);
    get(from, w.j_joint14.F_on_rod13);
  }
  stamp(4);
  disassemble_joint14(w);
  disassemble_joint15(w);
  disassemble_joint16(w);
  stamp(5);
}

[[maybe_unused]] constexpr std::array<StageInfo, 11> kStages_0{ {
    {"kinematics", 9, -1}, {"assembly", 4, -1}, {"receive", -1, 0}, {"assembly", 5, -1},
    {"receive", -1, 2}, {"assembly", 9, -1}, {"disassembly", 9, -1}, {"send", -1, 3},
    {"disassembly", 5, -1}, {"send", -1, 4}, {"disassembly", 4, -1}
} };
[[maybe_unused]] constexpr std::array<StageInfo, 5> kStages_1{ {
    {"kinematics", 8, -1}, {"assembly", 6, -1}, {"send", -1, 0}, {"receive", -1, 4},
    {"disassembly", 6, -1}
} };
[[maybe_unused]] constexpr std::array<StageInfo, 9> kStages_2{ {
    {"kinematics", 12, -1}, {"assembly", 10, -1}, {"receive", -1, 1}, {"assembly", 12, -1},
    {"send", -1, 2}, {"receive", -1, 3}, {"disassembly", 12, -1}, {"send", -1, 5},
    {"disassembly", 10, -1}
} };
[[maybe_unused]] constexpr std::array<StageInfo, 5> kStages_3{ {
    {"kinematics", 15, -1}, {"assembly", 13, -1}, {"send", -1, 1}, {"receive", -1, 5},
    {"disassembly", 13, -1}
} };
[[maybe_unused]] constexpr std::array<void (*)(Workspace&, Channel&), kProcesses> kRun{run_0, run_1, run_2, run_3};

constexpr std::array<Range, 6> kRanges_0{ {{0, 10}, {0, 10}, {0, 6}, {9, 1}, {0, 6}, {9, 1}} };
constexpr std::array<Range, 4> kRanges_1{ {{0, 9}, {0, 9}, {6, 3}, {6, 3}} };
constexpr std::array<Range, 4> kRanges_2{ {{0, 13}, {0, 13}, {10, 3}, {10, 3}} };
constexpr std::array<Range, 4> kRanges_3{ {{0, 16}, {0, 16}, {13, 3}, {13, 3}} };
[[maybe_unused]] constexpr std::array<ProcessInfo, kProcesses> kProcess{ {
    {{1, kRanges_0.data()}, {1, kRanges_0.data() + 1}, {2, kRanges_0.data() + 2}, {2, kRanges_0.data() + 4}, {11, kStages_0.data()}},
    {{1, kRanges_1.data()}, {1, kRanges_1.data() + 1}, {1, kRanges_1.data() + 2}, {1, kRanges_1.data() + 3}, {5, kStages_1.data()}},
    {{1, kRanges_2.data()}, {1, kRanges_2.data() + 1}, {1, kRanges_2.data() + 2}, {1, kRanges_2.data() + 3}, {9, kStages_2.data()}},
    {{1, kRanges_3.data()}, {1, kRanges_3.data() + 1}, {1, kRanges_3.data() + 2}, {1, kRanges_3.data() + 3}, {5, kStages_3.data()}}}};

#include "adagen/whole_mpi.hpp"
