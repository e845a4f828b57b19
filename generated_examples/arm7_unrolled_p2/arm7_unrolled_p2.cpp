// Forward dynamics of "arm7" on 2 processes, emitted by adagen 0.1.0 (solver.cpp.j2). Do not edit: generate again. Licence: yours to choose.
// robot     "arm7", 9 joints, 9 degrees of freedom, description sha256 35a799ae72b600eeca178cc12eccff22927d06b6ca76bda0ede3ef5832ebda29
// command   adagen ../models/arm7.urdf --procs 2 --shape=unrolled --form=ada --name=arm7_unrolled
// input     profile default, sha256 fe36af9ff4727e4941af0e7182db7f87cd64c54109bc287302f720e9ad83c3a8
// options   form ada (assembly-disassembly algorithm), shape unrolled (spatial vectors [angular; linear] in link frames whose joint axes are z), scalar double, channel auto, fixed base, gravity 0.0, 0.0, -9.81
// links     adagen_program.cpp -DADAGEN_MPI; or, compiled with -DADAGEN_NO_MAIN, a program of yours that includes arm7_unrolled_p2.h
// program   2 processes, joined at cuts; 0.617 us predicted (default profile)
//           process 0: base_yaw .. wrist_pitch
//           process 1: flange_roll .. right_finger_slide
// schedule  wrist_pitch@0-1(forearm_roll@0(elbow_pitch(upper_arm_roll(shoulder_pitch(base_yaw|)|)|)|) | flange_roll@1(|left_finger_slide(right_finger_slide|)))
//
// Assembly-disassembly algorithm of Yamane and Nakamura. Phi are inverse articulated-body inertias, b
// bias accelerations. Joint i joins chain A (its parent link's side) and chain B (its child link's side)
// to chain C: assembly, Eq. (3)-(7), goes up the schedule, disassembly, Eq. (8)-(10), comes down.

#include "arm7_unrolled_p2.h"
#define ADAGEN_CALL(word) arm7_unrolled_p2_##word
#define ADAGEN_NAMED(WORD) ARM7_UNROLLED_P2_##WORD
#define ADAGEN_MPI
#include "adagen/settings.hpp"

namespace { struct arm7_unrolled_p2_settings : PlainSettings {
  static constexpr int kVersion = 100, kJointCount = 9, kNq = 9, kNv = 9;
  [[maybe_unused]] static constexpr const char* kRobot = "arm7";
  static constexpr int kProcesses = 2;
  static constexpr bool kAlone = false;
  static constexpr int kPlanMessages = 2;
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
     {0.0, -0.9999999999964793, -2.65358979335273e-06, 0.0, 2.65358979335273e-06, -0.9999999999964793, 1.0, 0.0, 0.0}, {0.0, 0.0, 0.13}}}};

[[maybe_unused]] constexpr std::array<MessageInfo, 4> kMessages{ {
    {1, 0, 27},  // 0: assembled: chain of "flange_roll"
    {0, 1, 6},  // 1: forces on: chain of "flange_roll"
    {0, 1, 21},  // 2: state
    {1, 0, 3}}};  // 3: accelerations

// ---- functions ----------------------------------------------------------------------------------

#include "adagen/far_angles.hpp"
#include "adagen/channel.hpp"
#include "adagen/unrolled_memory.hpp"

namespace {

struct Workspace : StraightMemory<8, 0, 196> {};

}  // namespace

#include "adagen/unrolled_numbers.hpp"
#include "adagen/unrolled_sines.hpp"
#include "adagen/unrolled.hpp"

namespace {

// Each function is a straight line. A value is called x and its number in the expression graph; zeros
// and constants are folded in, common subexpressions are shared, and dead code is left out.
// Frames are the links' own; accelerations are deviations from the field that the links would have
// with all joint accelerations zero.

// =================================================================================================
// Process 0: 1507 products, 1175 sums, 23 quotients
// =================================================================================================

ADAGEN_NOINLINE ADAGEN_AS_IT_STANDS void part_0_0(Workspace& w) {
  ADAGEN_INPUTS
  // joint 1 "shoulder_pitch": placement, velocity and reference acceleration of its link
  const Real x20 = v[0] * 0.9999999999932537;
  const Real x29 = v[1] - v[0] * 3.673205103346574e-06;
  const Real x27 = cosine[1] * x20;
  const Real x25 = sine[1] * x20;
  const Real x37 = sine[1] * 9.809999999933819;
  const Real x30 = v[1] * x27;
  const Real x59 = x27 * x29;
  const Real x32 = v[1] * x25;
  const Real x55 = x25 * x27;
  const Real x62 = x30 + x59;
  // joint 2 "upper_arm_roll": placement, velocity and reference acceleration of its link
  const Real x80 = 3.673205103346574e-06 * x27 + 0.9999999999932537 * x29;
  const Real x95 = 3.673205103346574e-06 * x32;
  const Real x120 = (x25 * x25 + x29 * x29) * 0.3;
  const Real x122 = x120 - cosine[1] * 9.809999999933819;
  const Real x125 = -3.603414206382989e-05 + x62 * 0.3;
  const Real x93 = x25 * sine[2] + cosine[2] * x80;
  // joint 0 "base_yaw": assembly: its two sides become one chain
  const Real x485 = w.x[0] = 113.37868480725623 * tau[0];
  // link 2 "upper_arm": acceleration where nothing acts on it
  const Real x555 = x32 * 0.00558 * 179.2114695340502;
  const Real x529 = x55 * 0.04309 + x37 * 0.31000000000000005;
  const Real x535 = x37 * 3.1 + x55 * 0.31000000000000005;
  const Real x545 = -0.00011170584039787267 + x62 * 0.31000000000000005;
  const Real x526 = 1.1170584039787268e-05 - (x30 * 0.048670000000000005 + x59 * 0.04309);
  const Real x565 = x529 * 5.659309564233164 - x535 * 0.8885116015846066;
  const Real x554 = x526 * 56.59309564233163 + x545 * 5.659309564233164;
  const Real x569 = x526 * 5.659309564233164 + x545 * 0.8885116015846066;
  // joint 1 "shoulder_pitch": assembly: its two sides become one chain
  const Real x614 = 5.659309564233164 * tau[1];
  const Real x600 = 0.9999999999932537 * x485;
  const Real x590 = cosine[1] * 113.37868480572648;
  const Real x587 = w.x[1] = sine[1] * 0.0004164631636419267;
  const Real x588 = w.x[2] = cosine[1] * 0.0004164631636419267;
  const Real x594 = cosine[1] * x590;
  const Real x592 = sine[1] * x590;
  const Real x598 = 179.2114695340502 + x594;
  require_more(w, x598, 2.8880270885273612e-12, kGrowth, 1);
  const Real x597 = 113.37868480572648 - x594 + 56.59309564233163;
  require_more(w, x597, 1.1455151917378305e-12, kGrowth, 1);
  require_more(w, x597, 0.0, kFactorization, 1);
  const Real x624 = w.x[3] = 1 / x597;
  const Real x625 = w.x[4] = x592 * x624;
  const Real x626 = w.x[5] = 5.659309564233164 * x624;
  const Real x665 = 56.59309564233163 * x624;
  const Real x619 = w.x[6] = x565 + x614;
  const Real x630 = w.x[7] = 5.659309564233164 * x625;
  const Real x655 = w.x[8] = 56.59309564233163 * x625;
  const Real x616 = w.x[9] = x554 - sine[1] * x600 - tau[1] * x587;
  // joint 3 "elbow_pitch": assembly: its two sides become one chain
  const Real x1619 = 2.0 * sine[3];
  // joint 2 "upper_arm_roll": placement, velocity and reference acceleration of its link
  const Real x89 = sine[2] * x80 - x25 * cosine[2];
  const Real x94 = 0.9999999999932537 * x27 - 3.673205103346574e-06 * x29 + v[2];
  const Real x118 = x37 + x55 * 0.3;
  const Real x129 = 0.9999999999932537 * x125 - 3.673205103346574e-06 * x122;
  const Real x111 = v[2] * x93 - (x30 * cosine[2] + sine[2] * x95);
  const Real x157 = x93 * x94;
  const Real x162 = x89 * x94;
  const Real x114 = x30 * sine[2] - cosine[2] * x95 - v[2] * x89;
  const Real x143 = sine[2] * x118 + cosine[2] * x129;
  const Real x139 = sine[2] * x129 - cosine[2] * x118;
  const Real x148 = x93 * x93;
  const Real x134 = 0.9999999999932537 * x122 + 3.673205103346574e-06 * x125;
  // link 2 "upper_arm": acceleration where nothing acts on it
  const Real x560 = x535 * 5.659309564233164 - x529 * 56.59309564233163;
  // joint 1 "shoulder_pitch": assembly: its two sides become one chain
  const Real x629 = x598 - x592 * x625;
  const Real x649 = x616 * x626;
  const Real x632 = w.x[10] = 1 / x629;
  const Real x617 = x555 - cosine[1] * x600 - tau[1] * x588;
  const Real x648 = w.x[11] = x617 - x616 * x625;
  const Real x727 = 56.59309564233163 * tau[1] - x619 * 6.369426751592357 - x560;
  const Real x633 = w.x[12] = x630 * x632;
  const Real x668 = 179.2114695340502 * x632;
  const Real x666 = x632 * x655;
  const Real x663 = w.x[13] = 179.2114695340502 * x633;
  const Real x651 = x633 * x648;
  const Real x642 = w.x[14] = 0.8885116015846066 - 5.659309564233164 * x626 - x630 * x633;
  require_more(w, x642, 1.5783136603612864e-15, kFactorization, 1);
  const Real x662 = w.x[15] = 5.659309564233164 - 56.59309564233163 * x626 - x633 * x655;
  const Real x654 = w.x[16] = x569 - x649 + x651;
  const Real x643 = w.x[17] = 1 / x642;
  const Real x671 = x643 * x663;
  const Real x670 = x643 * x662;
  // link 3 "elbow_housing": acceleration where nothing acts on it
  const Real x754 = x111 * 0.01132625 - x157 * 0.007393749999999999 + x143 * 0.078;
  const Real x765 = x143 * 2.6 - (x157 - x111) * 0.078;
  const Real x757 = x114 * 0.01132625 + x162 * 0.007393749999999999 - x139 * 0.078;
  const Real x761 = x139 * 2.6 - (x114 + x162) * 0.078;
  const Real x780 = x754 * 111.2811239393518 - x765 * 3.338433718180554;
  // joint 2 "upper_arm_roll": assembly: its two sides become one chain
  const Real x917 = x619 - x614 - x565 + 0.3 * x727;
  // joint 2 "upper_arm_roll": placement, velocity and reference acceleration of its link
  const Real x97 = 0.9999999999932537 * x32;
  // joint 1 "shoulder_pitch": assembly: its two sides become one chain
  const Real x672 = x642 * x643;
  const Real x695 = 179.2114695340502 - 179.2114695340502 * x668 - x663 * x671;
  const Real x680 = 56.59309564233163 - 56.59309564233163 * x665 - x655 * x666;
  const Real x681 = x680 - x662 * x670;
  const Real x686 = x655 * x668 - x662 * x671;
  const Real x689 = x662 - x662 * x672;
  const Real x726 = x648 * x668 + x654 * x671 - x555;
  const Real x713 = x616 * x665 - x648 * x666 + x654 * x670;
  const Real x725 = x713 - x554;
  // link 3 "elbow_housing": acceleration where nothing acts on it
  const Real x783 = x757 * 111.2811239393518 + x761 * 3.338433718180554;
  const Real x788 = x757 * 3.338433718180554 + x761 * 0.4847683961608012;
  const Real x792 = x765 * 0.4847683961608012 - x754 * 3.338433718180554;
  // joint 2 "upper_arm_roll": assembly: its two sides become one chain
  const Real x855 = 3.673205103346574e-06 * x686;
  const Real x857 = 0.9999999999932537 * x686;
  const Real x860 = 3.673205103346574e-06 * (x695 - 20.546537908362435);
  const Real x802 = x689 - 0.3 * x681;
  const Real x805 = x663 - x663 * x672 - 0.3 * x686;
  const Real x865 = 3.673205103346574e-06 * x860;
  const Real x816 = 0.9999999999932537 * x802;
  const Real x819 = 0.9999999999932537 * x805;
  const Real x817 = 3.673205103346574e-06 * x802;
  const Real x863 = 0.9999999999932537 * x860;
  const Real x924 = 0.9999999999932537 * x727 - 3.673205103346574e-06 * x726;
  // joint 1 "shoulder_pitch": assembly: its two sides become one chain
  const Real x729 = x649 - x651 + x654 * x672 - x569;
  // joint 2 "upper_arm_roll": assembly: its two sides become one chain
  const Real x920 = x729 - 0.3 * x725;
  const Real x867 = 20.546537908362435 + x865;
  const Real x812 = x642 - x642 * x672 - 0.3 * x689;
  const Real x813 = x812 - 0.3 * x802;
  const Real x823 = w.x[18] = 3.673205103346574e-06 * x819;
  const Real x820 = 0.9999999999932537 * x819;
  const Real x890 = 3.673205103346574e-06 * x813;
  const Real x821 = x805 - x820;
  const Real x872 = w.x[19] = sine[2] * x863 - cosine[2] * x857;
  const Real x894 = 3.673205103346574e-06 * x890;
  const Real x892 = 0.9999999999932537 * x890;
  const Real x848 = cosine[2] * x823 + sine[2] * (6.1639613724671465 + x816);
  const Real x938 = 0.9999999999932537 * x920;
  const Real x882 = cosine[2] * (x681 - x867) - x855 * (2.0 * sine[2]);
  const Real x896 = x813 - x894;
  const Real x849 = sine[2] * x848;
  const Real x852 = cosine[2] * x848;
  const Real x828 = sine[2] * x821 - cosine[2] * x817;
  const Real x915 = 0.3846153846153846 + x894;
  require_more(w, x915, 1.0049860034323996e-14, kGrowth, 2);
  const Real x886 = cosine[2] * x882;
  const Real x853 = x852 - x823;
  const Real x876 = w.x[20] = sine[2] * x857 + cosine[2] * x863;
  const Real x884 = x855 + sine[2] * x882;
  // joint 3 "elbow_pitch": placement, velocity and reference acceleration of its link
  const Real x174 = 0.9999999999932537 * x94 - 3.673205103346574e-06 * x93;
  const Real x193 = 3.673205103346574e-06 * x114 + 0.9999999999932537 * x97;
  // link 3 "elbow_housing": acceleration where nothing acts on it
  const Real x770 = (x89 * x89 + x148) * 0.078 - x134 * 2.6;
  const Real x793 = x770 * 0.3846153846153846;
  // joint 2 "upper_arm_roll": assembly: its two sides become one chain
  const Real x902 = cosine[2] * (1.849188411752619 - x896);
  const Real x909 = x816 - x849 + -3.338433718180554;
  const Real x838 = w.x[21] = cosine[2] * 2.264149437033022e-05 + sine[2] * x820;
  const Real x908 = x867 + x886 + 111.2811239393518;
  require_more(w, x908, 1.9286837244164575e-12, kGrowth, 2);
  require_more(w, x908, 0.0, kFactorization, 2);
  const Real x910 = x681 - x886 + 111.2811239393518;
  require_more(w, x910, 1.9286837244164575e-12, kGrowth, 2);
  const Real x905 = cosine[2] * x902;
  const Real x972 = w.x[22] = 1 / x908;
  const Real x948 = cosine[2] * x725 + sine[2] * x924 + x780;
  const Real x962 = w.x[23] = x948 - tau[2] * x872;
  const Real x844 = w.x[24] = sine[2] * 2.264149437033022e-05 - cosine[2] * x820;
  const Real x949 = cosine[2] * x924 - sine[2] * x725 + x783;
  const Real x913 = x896 + x905 + 0.4847683961608012;
  require_more(w, x913, 1.1473119930685861e-14, kGrowth, 2);
  const Real x914 = 1.849188411752619 - x905 + 0.4847683961608012;
  require_more(w, x914, 1.1473119930685861e-14, kGrowth, 2);
  const Real x952 = cosine[2] * x917 + sine[2] * x938 + x788;
  const Real x953 = cosine[2] * x938 - sine[2] * x917 + x792;
  const Real x973 = w.x[25] = x884 * x972;
  const Real x975 = w.x[26] = x853 * x972;
  const Real x976 = w.x[27] = x909 * x972;
  const Real x977 = w.x[28] = x828 * x972;
  const Real x1181 = 111.2811239393518 * x972;
  const Real x1182 = 3.338433718180554 * x972;
  const Real x980 = x910 - x884 * x973;
  const Real x983 = 6.1639613724671465 - x849 + 3.338433718180554 + x853 * x973;
  const Real x986 = x909 * x973 - x852;
  const Real x989 = sine[2] * x817 + cosine[2] * x821 + x828 * x973;
  const Real x990 = w.x[29] = 1 / x980;
  const Real x1092 = w.x[30] = 111.2811239393518 * x973;
  const Real x1094 = w.x[31] = 3.338433718180554 * x973;
  const Real x1064 = w.x[32] = x949 - tau[2] * x876 + x962 * x973;
  const Real x968 = x793 - 3.673205103346574e-06 * x920 - tau[2] * x823;
  const Real x991 = w.x[33] = x983 * x990;
  const Real x992 = w.x[34] = x986 * x990;
  const Real x993 = w.x[35] = x989 * x990;
  const Real x1185 = 111.2811239393518 * x990;
  const Real x1184 = x990 * x1092;
  const Real x1187 = x990 * x1094;
  const Real x1186 = 3.338433718180554 * x990;
  const Real x999 = x913 - x853 * x975 - x983 * x991;
  const Real x1006 = sine[2] * x902 + x909 * x975 + x986 * x991;
  const Real x1014 = sine[2] * x892 + x828 * x975 + x989 * x991;
  const Real x1104 = w.x[36] = 3.338433718180554 - 111.2811239393518 * x991;
  const Real x1016 = w.x[37] = 1 / x999;
  const Real x1100 = w.x[38] = 111.2811239393518 * x975 + x991 * x1092;
  const Real x1112 = w.x[39] = 3.338433718180554 * x975 + x991 * x1094;
  const Real x1107 = w.x[40] = 0.4847683961608012 - 3.338433718180554 * x991;
  const Real x1017 = w.x[41] = x1006 * x1016;
  const Real x1019 = w.x[42] = x1014 * x1016;
  const Real x1191 = x1016 * x1104;
  const Real x1189 = x1016 * x1100;
  const Real x1193 = x1016 * x1112;
  const Real x1192 = x1016 * x1107;
  const Real x1028 = x914 - x909 * x976 - x986 * x992;
  const Real x1029 = x1028 - x1006 * x1017;
  const Real x1038 = cosine[2] * x892 + x828 * x976 + x989 * x992;
  const Real x1040 = x1014 * x1017 + x1038;
  const Real x1054 = x915 - x828 * x977 - x989 * x993;
  const Real x1126 = w.x[43] = x1017 * x1104 - 111.2811239393518 * x992;
  const Real x1120 = -3.338433718180554 - 111.2811239393518 * x976 - x992 * x1092;
  const Real x1121 = w.x[44] = x1120 - x1017 * x1100;
  const Real x1042 = w.x[45] = 1 / x1029;
  const Real x1214 = 111.2811239393518 - 111.2811239393518 * x1181 - x1092 * x1184;
  const Real x1139 = 0.4847683961608012 + 3.338433718180554 * x976 + x992 * x1094;
  const Real x1140 = w.x[46] = x1017 * x1112 + x1139;
  const Real x1131 = w.x[47] = x1017 * x1107 - 3.338433718180554 * x992;
  // joint 3 "elbow_pitch": placement, velocity and reference acceleration of its link
  const Real x183 = x89 * cosine[3] + sine[3] * x174;
  const Real x187 = cosine[3] * x174 - x89 * sine[3];
  const Real x188 = v[3] - (0.9999999999932537 * x93 + 3.673205103346574e-06 * x94);
  const Real x220 = x143 + (x89 * x93 - x97) * 0.08;
  const Real x222 = (x162 - x114) * 0.08 - x134;
  // joint 2 "upper_arm_roll": assembly: its two sides become one chain
  const Real x1330 = 0.4847683961608012 - 3.338433718180554 * x1182 - x1094 * x1187;
  const Real x1251 = -3.338433718180554 + 111.2811239393518 * x1182 + x1092 * x1187;
  const Real x1069 = x952 + tau[2] * x838 - x962 * x975;
  const Real x1070 = w.x[48] = x1069 - x991 * x1064;
  const Real x1077 = x953 - tau[2] * x844 - x962 * x976;
  const Real x1043 = w.x[49] = x1040 * x1042;
  const Real x1195 = x1042 * x1126;
  const Real x1194 = x1042 * x1121;
  const Real x1197 = x1042 * x1140;
  const Real x1196 = x1042 * x1131;
  const Real x1056 = x1054 - x1014 * x1019 - x1040 * x1043;
  const Real x1161 = w.x[50] = x1019 * x1104 - 111.2811239393518 * x993 + x1043 * x1126;
  const Real x1266 = 111.2811239393518 - 111.2811239393518 * x1185 - x1104 * x1191;
  const Real x1151 = 111.2811239393518 * x977 + x993 * x1092 + x1019 * x1100;
  const Real x1153 = w.x[51] = x1043 * x1121 - x1151;
  const Real x1179 = 3.338433718180554 * x977 + x993 * x1094 + x1019 * x1112;
  const Real x1180 = w.x[52] = x1043 * x1140 + x1179;
  const Real x1057 = w.x[53] = 1 / x1056;
  const Real x1169 = w.x[54] = x1019 * x1107 - 3.338433718180554 * x993 + x1043 * x1131;
  const Real x1079 = w.x[55] = x1077 - x992 * x1064 + x1017 * x1070;
  const Real x1278 = 3.338433718180554 - 111.2811239393518 * x1186 - x1104 * x1192;
  const Real x1303 = 0.4847683961608012 - 3.338433718180554 * x1186 - x1107 * x1192;
  const Real x1089 = x968 - x962 * x977 - x993 * x1064;
  const Real x1199 = x1057 * x1161;
  const Real x1198 = x1057 * x1153;
  const Real x1202 = 0.3846153846153846 * x1057;
  const Real x1201 = x1057 * x1180;
  const Real x1200 = x1057 * x1169;
  const Real x1292 = x1161 * x1202;
  const Real x1268 = x1266 - x1126 * x1195 - x1161 * x1199;
  const Real x1216 = x1214 - x1100 * x1189 - x1121 * x1194;
  const Real x1217 = x1216 - x1153 * x1198;
  const Real x1227 = x1100 * x1191 - x1092 * x1185 - x1121 * x1195;
  const Real x1228 = x1227 - x1153 * x1199;
  const Real x1290 = 111.2811239393518 * x1187 - x1104 * x1193 - x1126 * x1197;
  const Real x1291 = x1290 - x1161 * x1201;
  const Real x1332 = x1330 - x1112 * x1193 - x1140 * x1197;
  const Real x1253 = x1100 * x1193 + x1251 - x1121 * x1197;
  const Real x1254 = x1253 - x1153 * x1201;
  // joint 4 "forearm_roll": assembly: its two sides become one chain
  const Real x2553 = 2.0 * sine[4];
  // joint 2 "upper_arm_roll": assembly: its two sides become one chain
  const Real x1280 = x1278 - x1126 * x1196 - x1161 * x1200;
  const Real x1238 = x1100 * x1192 - x1092 * x1186 - x1121 * x1196;
  const Real x1239 = x1238 - x1153 * x1200;
  const Real x1315 = 3.338433718180554 * x1187 - x1107 * x1193 - x1131 * x1197;
  const Real x1316 = x1315 - x1169 * x1201;
  const Real x1305 = x1303 - x1131 * x1196 - x1169 * x1200;
  const Real x1091 = w.x[56] = x1019 * x1070 + x1089 + x1043 * x1079;
  // joint 3 "elbow_pitch": assembly: its two sides become one chain
  const Real x1596 = 3.673205103346574e-06 * x1228;
  const Real x1525 = x1332 - x1180 * x1201 + 1.6274634456452637;
  const Real x1601 = 3.673205103346574e-06 * (x1268 - 254.29116338207245);
  const Real x1515 = x1292 + 0.08 * x1268;
  const Real x1511 = x1153 * x1202 + 0.08 * x1228;
  const Real x1528 = x1180 * x1202 + 0.08 * x1291;
  const Real x1605 = 3.673205103346574e-06 * x1601;
  const Real x1536 = 3.673205103346574e-06 * x1280;
  const Real x1607 = 254.29116338207245 + x1605;
  const Real x1534 = 0.3846153846153846 - 0.3846153846153846 * x1202 + 0.08 * x1292;
  const Real x1535 = 0.08 * x1515 + x1534;
  const Real x1544 = 3.673205103346574e-06 * x1254 + 0.9999999999932537 * x1511;
  const Real x1521 = x1169 * x1202 + 0.08 * x1280;
  const Real x1555 = 0.9999999999932537 * (20.343293070565796 - x1515) - 3.673205103346574e-06 * x1291;
  const Real x1550 = 3.673205103346574e-06 * x1511 - 0.9999999999932537 * x1254;
  const Real x1560 = 3.673205103346574e-06 * x1555;
  const Real x1556 = 0.9999999999932537 * x1555;
  const Real x1633 = 3.673205103346574e-06 * x1316 + 0.9999999999932537 * x1521;
  const Real x1622 = cosine[3] * (x1217 - x1607) - x1596 * x1619;
  const Real x1645 = 3.673205103346574e-06 * (x1525 - x1535) + 1.9999999999865075 * x1528;
  const Real x1557 = x1515 + x1556;
  const Real x1639 = 3.673205103346574e-06 * x1521 - 0.9999999999932537 * x1316;
  const Real x1626 = cosine[3] * x1622;
  const Real x1650 = 3.673205103346574e-06 * x1645;
  const Real x1624 = x1596 + sine[3] * x1622;
  const Real x1652 = x1535 + x1650;
  const Real x1587 = cosine[3] * (x1239 + x1560) - sine[3] * (x1536 + x1544);
  const Real x1649 = 0.9999999999932537 * x1645 - x1528;
  const Real x1672 = x1607 + x1626 + 97.57715913858884;
  require_more(w, x1672, 2.0354041913285566e-12, kGrowth, 3);
  require_more(w, x1672, 0.0, kFactorization, 3);
  const Real x1674 = x1217 - x1626 + 363.6363636363637;
  require_more(w, x1674, 5.816332892088654e-12, kGrowth, 3);
  const Real x1593 = cosine[3] * x1587;
  const Real x1588 = sine[3] * x1587;
  const Real x1673 = cosine[3] * x1550 - sine[3] * x1557 + -9.757715913858885;
  const Real x1746 = w.x[57] = 1 / x1672;
  const Real x1682 = x1525 - x1650 + 2.3394079550222524;
  require_more(w, x1682, 3.871069992040982e-14, kGrowth, 3);
  const Real x1594 = x1593 - x1560;
  const Real x1589 = x1544 + x1588;
  // joint 3 "elbow_pitch": placement, velocity and reference acceleration of its link
  const Real x211 = x111 * cosine[3] - sine[3] * x193 + v[3] * x187;
  const Real x214 = x111 * sine[3] + cosine[3] * x193 + v[3] * x183;
  const Real x246 = x188 * x188;
  const Real x254 = x187 * x188;
  const Real x259 = x183 * x188;
  const Real x199 = 3.673205103346574e-06 * x97 - 0.9999999999932537 * x114;
  const Real x218 = x139 - (x148 + x94 * x94) * 0.08;
  const Real x226 = 0.9999999999932537 * x222 - 3.673205103346574e-06 * x220;
  // joint 3 "elbow_pitch": assembly: its two sides become one chain
  const Real x1665 = cosine[3] * (x1305 - x1652) - x1619 * x1633;
  const Real x1669 = cosine[3] * x1665;
  const Real x1747 = w.x[58] = x1624 * x1746;
  const Real x1749 = w.x[59] = x1594 * x1746;
  const Real x1750 = w.x[60] = x1589 * x1746;
  const Real x1752 = w.x[61] = x1673 * x1746;
  const Real x1958 = 97.57715913858884 * x1746;
  const Real x1959 = 9.757715913858885 * x1746;
  const Real x1679 = x1652 + x1669 + 1.430317045931343;
  require_more(w, x1679, 2.5791741088407997e-14, kGrowth, 3);
  const Real x1681 = x1305 - x1669 + 0.6984883523919266;
  require_more(w, x1681, 1.5391829848103258e-14, kGrowth, 3);
  const Real x1755 = x1674 - x1624 * x1747;
  const Real x1758 = x1594 * x1747 - (x1536 + x1588);
  const Real x1761 = x1239 - x1593 - x1589 * x1747;
  const Real x1765 = w.x[62] = 1 / x1755;
  const Real x1675 = -18.181818181818183 - (sine[3] * x1550 + cosine[3] * x1557);
  const Real x1764 = x1675 + x1673 * x1747;
  const Real x1857 = w.x[63] = 97.57715913858884 * x1747;
  const Real x1861 = w.x[64] = -18.181818181818183 - 9.757715913858885 * x1747;
  const Real x1766 = w.x[65] = x1758 * x1765;
  const Real x1767 = w.x[66] = x1761 * x1765;
  const Real x1768 = w.x[67] = x1764 * x1765;
  const Real x1962 = 363.6363636363637 * x1765;
  const Real x1961 = x1765 * x1857;
  const Real x1963 = x1765 * x1861;
  const Real x1868 = w.x[68] = 363.6363636363637 * x1766;
  const Real x1774 = x1679 - x1594 * x1749 - x1758 * x1766;
  const Real x1779 = 0.48788579569294427 - (x1633 + sine[3] * x1665) + x1589 * x1749;
  const Real x1780 = x1779 - x1761 * x1766;
  const Real x1785 = cosine[3] * x1639 + sine[3] * x1649 - x1673 * x1749;
  const Real x1786 = x1785 - x1764 * x1766;
  const Real x1805 = cosine[3] * x1649 - sine[3] * x1639 + x1673 * x1750;
  // joint 3 "elbow_pitch": placement, velocity and reference acceleration of its link
  const Real x231 = 0.9999999999932537 * x220 + 3.673205103346574e-06 * x222;
  const Real x247 = x187 * x187 + x246;
  const Real x249 = x183 * x187;
  const Real x252 = x183 * x183 + x246;
  const Real x260 = x214 + x259;
  // link 3 "elbow_housing": acceleration where nothing acts on it
  const Real x784 = x97 * 0.0039325 * 254.29116338207245;
  // joint 2 "upper_arm_roll": assembly: its two sides become one chain
  const Real x1355 = x1064 * x1185 + x1070 * x1191 + x1079 * x1195;
  // joint 3 "elbow_pitch": assembly: its two sides become one chain
  const Real x1787 = w.x[69] = 1 / x1774;
  const Real x1866 = w.x[70] = 97.57715913858884 * x1749 + x1766 * x1857;
  const Real x1874 = w.x[71] = 9.757715913858885 * x1749 - x1766 * x1861;
  const Real x1788 = w.x[72] = x1780 * x1787;
  const Real x1789 = w.x[73] = x1786 * x1787;
  const Real x1966 = x1787 * x1868;
  const Real x1968 = 9.757715913858885 * x1787;
  const Real x1964 = x1787 * x1866;
  const Real x1971 = x1787 * x1874;
  const Real x1970 = 0.48788579569294427 * x1787;
  const Real x1969 = 1.430317045931343 * x1787;
  const Real x1797 = x1681 - x1589 * x1750 - x1761 * x1767;
  const Real x1798 = x1797 - x1780 * x1788;
  const Real x1807 = x1805 - x1764 * x1767 - x1786 * x1788;
  const Real x1819 = x1682 - x1673 * x1752 - x1764 * x1768;
  const Real x1887 = w.x[74] = x1788 * x1868 - 363.6363636363637 * x1767;
  const Real x1890 = w.x[75] = 4.878857956929442 - 9.757715913858885 * x1788;
  const Real x1808 = w.x[76] = 1 / x1798;
  const Real x1882 = w.x[77] = 97.57715913858884 * x1750 - x1767 * x1857 + x1788 * x1866;
  const Real x1905 = w.x[78] = 9.757715913858885 * x1750 + x1767 * x1861 + x1788 * x1874;
  const Real x1916 = -9.757715913858885 - 97.57715913858884 * x1752 - x1768 * x1857;
  const Real x1955 = 2.3394079550222524 + 9.757715913858885 * x1752 - x1768 * x1861;
  const Real x1896 = w.x[79] = 0.6984883523919266 - 0.48788579569294427 * x1788;
  const Real x1999 = 97.57715913858884 - 97.57715913858884 * x1958 - x1857 * x1961;
  const Real x2052 = -9.757715913858885 + 97.57715913858884 * x1959 - x1857 * x1963;
  const Real x2193 = 2.3394079550222524 - 9.757715913858885 * x1959 - x1861 * x1963;
  const Real x1809 = w.x[80] = x1807 * x1808;
  const Real x1973 = x1808 * x1887;
  const Real x1974 = x1808 * x1890;
  const Real x1972 = x1808 * x1882;
  const Real x1977 = x1808 * x1905;
  const Real x1976 = x1808 * x1896;
  const Real x1893 = w.x[81] = 0.48788579569294427 - 1.430317045931343 * x1788;
  // joint 2 "upper_arm_roll": assembly: its two sides become one chain
  const Real x1373 = x1070 * x1193 - (x962 * x1182 + x1064 * x1187);
  // joint 3 "elbow_pitch": assembly: its two sides become one chain
  const Real x1821 = x1819 - x1786 * x1789 - x1807 * x1809;
  const Real x1926 = -18.181818181818183 - 363.6363636363637 * x1768 + x1789 * x1868;
  const Real x1927 = w.x[82] = x1926 - x1809 * x1887;
  const Real x1932 = w.x[83] = 9.757715913858885 * x1789 + x1809 * x1890;
  const Real x2065 = 363.6363636363637 - 363.6363636363637 * x1962 - x1868 * x1966;
  const Real x1918 = w.x[84] = x1789 * x1866 + x1916 - x1809 * x1882;
  const Real x1957 = w.x[85] = x1955 - x1789 * x1874 + x1809 * x1905;
  const Real x1822 = w.x[86] = 1 / x1821;
  const Real x1944 = w.x[87] = 0.48788579569294427 * x1789 + x1809 * x1896;
  const Real x2101 = -18.181818181818183 - 363.6363636363637 * x1963 + x1868 * x1971;
  const Real x1975 = x1808 * x1893;
  const Real x1938 = w.x[88] = 1.430317045931343 * x1789 + x1809 * x1893;
  const Real x1980 = x1822 * x1927;
  const Real x1981 = x1822 * x1932;
  const Real x1979 = x1822 * x1918;
  const Real x1987 = x1822 * x1957;
  const Real x1985 = x1822 * x1944;
  const Real x2067 = x2065 - x1887 * x1973 - x1927 * x1980;
  const Real x2111 = 97.57715913858884 - 9.757715913858885 * x1968 - x1890 * x1974;
  const Real x2112 = x2111 - x1932 * x1981;
  const Real x2075 = x1868 * x1968 - x1887 * x1974 + x1927 * x1981;
  const Real x2013 = x1857 * x1962 + x1866 * x1966 + x1882 * x1973;
  const Real x2015 = x1918 * x1980 + x2013;
  const Real x2024 = x1866 * x1968 - x1882 * x1974 + x1918 * x1981;
  const Real x2001 = x1999 - x1866 * x1964 - x1882 * x1972;
  const Real x2002 = x2001 - x1918 * x1979;
  const Real x2103 = x1887 * x1977 + x2101 - x1927 * x1987;
  const Real x2054 = x1866 * x1971 + x2052 + x1882 * x1977;
  const Real x2055 = x2054 - x1918 * x1987;
  const Real x2138 = x1890 * x1977 - 9.757715913858885 * x1971 + x1932 * x1987;
  const Real x2195 = x2193 - x1874 * x1971 - x1905 * x1977;
  const Real x2129 = 4.878857956929442 - 9.757715913858885 * x1970 - x1890 * x1976;
  const Real x2130 = x2129 - x1932 * x1985;
  // joint 4 "forearm_roll": assembly: its two sides become one chain
  const Real x2393 = 0.08 * x2075;
  const Real x2522 = 3.673205103346574e-06 * x2015 - 0.9999999999932537 * x2024;
  const Real x2534 = 3.673205103346574e-06 * (x2067 - x2112) + 1.9999999999865075 * x2075;
  const Real x2378 = 0.38 * x2024;
  // joint 3 "elbow_pitch": placement, velocity and reference acceleration of its link
  const Real x250 = x249 - x199;
  const Real x251 = x199 + x249;
  const Real x256 = x211 + x254;
  const Real x235 = cosine[3] * x218 + sine[3] * x226;
  const Real x239 = cosine[3] * x226 - sine[3] * x218;
  // joint 2 "upper_arm_roll": assembly: its two sides become one chain
  const Real x1347 = x962 * x1181 + x1064 * x1184 - x1070 * x1189;
  const Real x1378 = x1091 * x1199 + x1355 - x783;
  const Real x1379 = x784 + 254.29116338207245 * tau[2];
  // joint 3 "elbow_pitch": assembly: its two sides become one chain
  const Real x1983 = x1822 * x1938;
  const Real x2172 = 0.6984883523919266 - 0.48788579569294427 * x1970 - x1896 * x1976;
  const Real x2120 = 9.757715913858885 - 9.757715913858885 * x1969 - x1890 * x1975;
  const Real x2121 = x2120 - x1932 * x1983;
  // joint 4 "forearm_roll": assembly: its two sides become one chain
  const Real x2400 = x2103 + 0.08 * x2067 - 0.38 * x2015;
  const Real x2539 = 3.673205103346574e-06 * x2534;
  const Real x2541 = x2112 + x2539;
  const Real x2389 = x2055 - 0.08 * x2015 + 0.38 * x2002;
  // joint 3 "elbow_pitch": assembly: its two sides become one chain
  const Real x2091 = x1868 * x1970 - x1887 * x1976 + x1927 * x1985;
  // joint 4 "forearm_roll": assembly: its two sides become one chain
  const Real x2395 = x2091 - x2393;
  const Real x2406 = x2130 - 0.08 * x2112;
  const Real x2408 = x2138 + x2393 + x2378;
  const Real x2449 = x2195 - x1957 * x1987 + 0.08 * x2103;
  const Real x2555 = cosine[4] * (x2002 - x2541) + x2522 * x2553;
  const Real x2558 = cosine[4] * x2555;
  // joint 3 "elbow_pitch": assembly: its two sides become one chain
  const Real x2040 = x1866 * x1970 - x1882 * x1976 + x1918 * x1985;
  // joint 4 "forearm_roll": assembly: its two sides become one chain
  const Real x2383 = x2040 - 0.08 * x2024;
  // joint 3 "elbow_pitch": assembly: its two sides become one chain
  const Real x2181 = x1896 * x1977 - 0.48788579569294427 * x1971 + x1944 * x1987;
  // joint 2 "upper_arm_roll": assembly: its two sides become one chain
  const Real x1377 = x1079 * x1194 + x1347 + x1091 * x1198 - x780;
  const Real x1362 = x1064 * x1186 + x1070 * x1192 + x1079 * x1196;
  const Real x1380 = x1091 * x1200 + x1362 - x788;
  // link 4 "forearm": acceleration where nothing acts on it
  const Real x1424 = x199 * 0.037748300000000005 - x249 * 0.023998300000000004;
  const Real x1406 = x211 * 0.03224830000000001 + x254 * 0.029498300000000005 - x260 * 0.011000000000000003;
  const Real x1428 = x1406 - x231 * 0.22000000000000003;
  const Real x1459 = x256 * 0.22000000000000003 - (x231 * 2.2 + x260 * 0.11000000000000001);
  const Real x1416 = x256 * 0.011000000000000003 - (x214 * 0.00825 + x259 * 0.005500000000000001);
  const Real x1431 = x1416 - x231 * 0.11000000000000001;
  const Real x1443 = x247 * 0.11000000000000001 + x250 * 0.22000000000000003 + x235 * 2.2;
  const Real x1451 = x239 * 2.2 - (x251 * 0.11000000000000001 + x252 * 0.22000000000000003);
  const Real x1436 = 0.011000000000000003 * (x252 - x247) + x1424 - x239 * 0.11000000000000001;
  const Real x1437 = x1436 - x235 * 0.22000000000000003;
  const Real x1473 = x1428 * 97.57715913858884 - x1459 * 9.757715913858885;
  // joint 3 "elbow_pitch": assembly: its two sides become one chain
  const Real x1598 = 0.9999999999932537 * x1228;
  const Real x1603 = 0.9999999999932537 * x1601;
  // joint 2 "upper_arm_roll": assembly: its two sides become one chain
  const Real x1381 = x1079 * x1197 + x1373 + x1091 * x1201 - x792;
  // joint 3 "elbow_pitch": assembly: its two sides become one chain
  const Real x1685 = x1381 + 0.08 * x1379;
  const Real x1688 = x1091 * x1202 - x793 - 0.08 * x1378;
  const Real x1692 = 0.9999999999932537 * x1379 - 3.673205103346574e-06 * x1378;
  const Real x1538 = 0.9999999999932537 * x1280;
  const Real x1559 = 20.343293070565796 - x1556;
  const Real x2155 = 0.48788579569294427 - 1.430317045931343 * x1970 - x1893 * x1976;
  const Real x1612 = w.x[89] = sine[3] * x1603 - cosine[3] * x1598;
  const Real x1709 = 0.9999999999932537 * x1688 - 3.673205103346574e-06 * x1685;
  const Real x2146 = 1.430317045931343 - 1.430317045931343 * x1969 - x1893 * x1975;
  // joint 4 "forearm_roll": assembly: its two sides become one chain
  const Real x2433 = x2172 - x1944 * x1985 - 0.08 * x2130;
  const Real x2434 = x2433 - 0.08 * x2406;
  const Real x2451 = 0.38 * x2055 + x2449 + 0.08 * x2400;
  const Real x2452 = 0.38 * x2389 + x2451;
  const Real x2603 = x2541 + x2558 + 222.85165433925602;
  require_more(w, x2603, 3.7782214362185915e-12, kGrowth, 4);
  require_more(w, x2603, 0.0, kFactorization, 4);
  // joint 3 "elbow_pitch": assembly: its two sides become one chain
  const Real x2083 = x1868 * x1969 - x1887 * x1975 + x1927 * x1983;
  // joint 4 "forearm_roll": assembly: its two sides become one chain
  const Real x2392 = x2083 - 0.38 * x2075;
  const Real x2403 = x2121 - 0.38 * x2112;
  const Real x2441 = x2181 - 0.08 * x2138 + 0.08 * x2395;
  const Real x2442 = 0.38 * x2383 + x2441;
  const Real x2479 = 3.673205103346574e-06 * (x2395 - x2408) + 0.9999999999932537 * (x2400 + x2406);
  const Real x2687 = w.x[90] = 1 / x2603;
  // joint 3 "elbow_pitch": assembly: its two sides become one chain
  const Real x2032 = x1866 * x1969 - x1882 * x1975 + x1918 * x1983;
  // joint 4 "forearm_roll": assembly: its two sides become one chain
  const Real x2380 = x2032 - x2378;
  // joint 3 "elbow_pitch": assembly: its two sides become one chain
  const Real x2164 = x1893 * x1977 - 1.430317045931343 * x1971 + x1938 * x1987;
  // joint 4 "forearm_roll": assembly: its two sides become one chain
  const Real x2485 = 3.673205103346574e-06 * x2479;
  const Real x2457 = 3.673205103346574e-06 * x2392 + 0.9999999999932537 * x2403;
  const Real x2467 = 3.673205103346574e-06 * x2383 + 0.9999999999932537 * x2389;
  const Real x2487 = x2408 + x2485;
  // joint 4 "forearm_roll": placement, velocity and reference acceleration of its link
  const Real x273 = 3.673205103346574e-06 * x187 + 0.9999999999932537 * x188;
  // link 4 "forearm": acceleration where nothing acts on it
  const Real x1478 = x1431 * 363.6363636363637 - x1459 * 18.181818181818183;
  const Real x1488 = x1443 * 1.430317045931343 + x1451 * 0.48788579569294427 + x1437 * 9.757715913858885;
  const Real x1493 = x1443 * 0.48788579569294427 + x1451 * 0.6984883523919266 + x1437 * 4.878857956929442;
  const Real x1501 = x1459 * 2.3394079550222524 - (x1428 * 9.757715913858885 + x1431 * 18.181818181818183);
  // joint 3 "elbow_pitch": assembly: its two sides become one chain
  const Real x1616 = w.x[91] = sine[3] * x1598 + cosine[3] * x1603;
  const Real x1677 = w.x[92] = sine[3] * x1559 - cosine[3] * x1538 + 9.757715913858885;
  const Real x1723 = cosine[3] * x1377 + sine[3] * x1692 + x1473;
  const Real x1735 = w.x[93] = x1723 - tau[3] * x1612;
  const Real x1678 = w.x[94] = sine[3] * x1538 + cosine[3] * x1559 + 4.878857956929442;
  const Real x1724 = cosine[3] * x1692 - sine[3] * x1377 + x1478;
  const Real x1562 = w.x[95] = x1291 + x1560;
  const Real x1726 = cosine[3] * x1380 + sine[3] * x1709 + x1488;
  const Real x1829 = w.x[96] = x1724 - tau[3] * x1616 + x1735 * x1747;
  const Real x1727 = cosine[3] * x1709 - sine[3] * x1380 + x1493;
  const Real x1728 = x1501 - (0.9999999999932537 * x1685 + 3.673205103346574e-06 * x1688);
  const Real x1834 = x1726 - tau[3] * x1677 - x1735 * x1749;
  const Real x1835 = w.x[97] = x1834 - x1766 * x1829;
  // joint 4 "forearm_roll": assembly: its two sides become one chain
  const Real x2576 = 3.673205103346574e-06 * (x2434 - x2452) + 1.9999999999865075 * x2442;
  const Real x2557 = x2522 - sine[4] * x2555;
  const Real x2419 = x2155 - x1938 * x1985 - 0.38 * x2130;
  const Real x2420 = x2419 - 0.08 * x2403;
  const Real x2427 = x2164 - 0.38 * x2138 + 0.08 * x2392;
  const Real x2428 = 0.38 * x2380 + x2427;
  const Real x2581 = 3.673205103346574e-06 * x2576;
  const Real x2688 = w.x[98] = x2557 * x2687;
  const Real x2413 = x2146 - x1938 * x1983 - 0.38 * x2121;
  const Real x2414 = x2413 - 0.38 * x2403;
  const Real x2583 = x2452 + x2581;
  const Real x2606 = x2002 - x2558 + 222.85165433925602;
  require_more(w, x2606, 3.7782214362185915e-12, kGrowth, 4);
  const Real x2509 = cosine[4] * (x2380 - x2487) - sine[4] * (x2457 + x2467);
  const Real x2565 = 3.673205103346574e-06 * x2420 + 0.9999999999932537 * x2428;
  const Real x2694 = x2606 - x2557 * x2688;
  const Real x2510 = sine[4] * x2509;
  const Real x2515 = cosine[4] * x2509;
  const Real x2704 = w.x[99] = 1 / x2694;
  const Real x2516 = x2487 + x2515;
  const Real x2596 = cosine[4] * (x2414 - x2583) - x2553 * x2565;
  const Real x2600 = cosine[4] * x2596;
  // joint 4 "forearm_roll": placement, velocity and reference acceleration of its link
  const Real x282 = x183 * cosine[4] - sine[4] * x273;
  const Real x287 = x183 * sine[4] + cosine[4] * x273;
  const Real x289 = 0.9999999999932537 * x187 - 3.673205103346574e-06 * x188 + v[4];
  const Real x294 = 3.673205103346574e-06 * x214 - 0.9999999999932537 * x199;
  const Real x356 = x282 * x282;
  const Real x325 = x239 - (0.08 * x251 + x252 * 0.38);
  const Real x331 = x256 * 0.38 - (x231 + 0.08 * x260);
  const Real x367 = x356 + x289 * x289;
  const Real x374 = x356 + x287 * x287;
  const Real x369 = x287 * x289;
  const Real x310 = x211 * cosine[4] + sine[4] * x294 - v[4] * x287;
  const Real x318 = 0.08 * x247 + x250 * 0.38 + x235;
  const Real x336 = 3.673205103346574e-06 * x325 + 0.9999999999932537 * x331;
  const Real x299 = 0.9999999999932537 * x214 + 3.673205103346574e-06 * x199;
  // joint 3 "elbow_pitch": assembly: its two sides become one chain
  const Real x1842 = x1727 - tau[3] * x1678 + x1735 * x1750;
  const Real x1844 = w.x[100] = x1842 - x1767 * x1829 - x1788 * x1835;
  const Real x1853 = x1728 - tau[3] * x1562 - x1735 * x1752;
  const Real x1855 = x1853 - x1768 * x1829 - x1789 * x1835;
  const Real x1856 = w.x[101] = x1855 - x1809 * x1844;
  // joint 4 "forearm_roll": assembly: its two sides become one chain
  const Real x2689 = w.x[102] = x2516 * x2687;
  const Real x2697 = 17.828132347140482 - (x2457 + x2510) - x2516 * x2688;
  const Real x2610 = x2583 + x2600 + 2.0725831948881592;
  require_more(w, x2610, 3.591265808372574e-14, kGrowth, 4);
  const Real x2705 = w.x[103] = x2697 * x2704;
  const Real x2604 = -17.828132347140482 - (x2467 + x2510);
  const Real x2481 = 0.9999999999932537 * x2479;
  const Real x2713 = x2610 - x2516 * x2689 - x2697 * x2705;
  const Real x2472 = 0.9999999999932537 * x2383 - 3.673205103346574e-06 * x2389;
  const Real x2483 = x2400 - x2481;
  const Real x2728 = w.x[104] = 1 / x2713;
  // joint 4 "forearm_roll": placement, velocity and reference acceleration of its link
  const Real x341 = 0.9999999999932537 * x325 - 3.673205103346574e-06 * x331;
  const Real x362 = x282 * x287;
  const Real x313 = cosine[4] * x294 - x211 * sine[4] - v[4] * x282;
  const Real x350 = sine[4] * x318 + cosine[4] * x336;
  const Real x364 = x299 - x362;
  const Real x376 = x282 * x289;
  const Real x378 = x313 + x376;
  const Real x345 = cosine[4] * x318 - sine[4] * x336;
  // link 4 "forearm": acceleration where nothing acts on it
  const Real x1483 = x1443 * 9.757715913858885 + x1451 * 4.878857956929442 + x1437 * 97.57715913858884;
  // joint 3 "elbow_pitch": assembly: its two sides become one chain
  const Real x2207 = x1735 * x1958 + x1829 * x1961 - x1835 * x1964;
  const Real x2216 = x1829 * x1962 - x1835 * x1966 + x1844 * x1973;
  const Real x2244 = x1829 * x1963 - x1735 * x1959 + x1835 * x1971;
  const Real x2223 = x1835 * x1968 + x1844 * x1974 - x1856 * x1981;
  const Real x2251 = x1856 * x1980 + x2216 - x1478;
  const Real x2235 = x1835 * x1970 + x1844 * x1976 - x1856 * x1985;
  const Real x2250 = x1844 * x1972 + x2207 + x1856 * x1979 - x1473;
  const Real x2252 = 97.57715913858884 * tau[3] + x2223 - x1483;
  // link 5 "wrist_housing": acceleration where nothing acts on it
  const Real x2279 = x369 * 0.01347604 + 0.00136 * (x374 - x367);
  const Real x2301 = x310 * 0.01553729 + x2279 + x341 * 0.017;
  const Real x2302 = x2301 - x350 * 0.136;
  const Real x2327 = x341 * 1.7 + x374 * 0.136;
  const Real x2328 = (x310 - x369) * 0.017 + x2327;
  // joint 4 "forearm_roll": assembly: its two sides become one chain
  const Real x2700 = x2380 - x2515 - x2604 * x2688;
  const Real x2690 = w.x[105] = x2604 * x2687;
  const Real x2611 = x2414 - x2600 + 2.0144858818888856;
  require_more(w, x2611, 3.508704560934945e-14, kGrowth, 4);
  const Real x2706 = w.x[106] = x2700 * x2704;
  const Real x2718 = x2565 + sine[4] * x2596 + x2604 * x2689;
  const Real x2720 = x2700 * x2705 + x2718;
  const Real x2570 = 0.9999999999932537 * x2420 - 3.673205103346574e-06 * x2428;
  const Real x2580 = x2442 - 0.9999999999932537 * x2576;
  const Real x2605 = cosine[4] * x2472 + sine[4] * x2483 + -2.2285165433925602;
  // joint 3 "elbow_pitch": assembly: its two sides become one chain
  const Real x2255 = x2244 - x1844 * x1977 + x1856 * x1987 - x1501;
  // joint 4 "forearm_roll": assembly: its two sides become one chain
  const Real x2729 = w.x[107] = x2720 * x2728;
  // joint 3 "elbow_pitch": assembly: its two sides become one chain
  const Real x2229 = x1835 * x1969 + x1844 * x1975 - x1856 * x1983;
  // link 5 "wrist_housing": acceleration where nothing acts on it
  const Real x2321 = (x310 + x369) * 0.136 - x367 * 0.017;
  const Real x2322 = x2321 - x350 * 1.7;
  const Real x2288 = x376 * 0.01364604 - x364 * 0.00136 + x313 * 0.01536729;
  const Real x2305 = x2288 - x345 * 0.136;
  const Real x2297 = x362 * 0.00017 - x299 * 0.00189125 + x378 * 0.00136;
  const Real x2308 = x2297 - x345 * 0.017;
  const Real x2314 = x364 * 0.017 - x378 * 0.136 + x345 * 1.7;
  const Real x2346 = x2302 * 222.85165433925602 - x2328 * 2.2285165433925602 - x2322 * 17.828132347140482;
  const Real x2349 = x2305 * 222.85165433925602 + x2314 * 17.828132347140482;
  const Real x2357 = x2305 * 17.828132347140482 + x2308 * 5.809731299927379 + x2314 * 2.0725831948881592;
  // joint 4 "forearm_roll": assembly: its two sides become one chain
  const Real x2527 = 0.9999999999932537 * x2015 + 3.673205103346574e-06 * x2024;
  const Real x2538 = x2075 - 0.9999999999932537 * x2534;
  const Real x2619 = 4.878857956929442 * tau[3] + x2235 - x1493 - 0.08 * x2252;
  const Real x2624 = x2255 + 0.08 * x2251 + 0.38 * x2250;
  const Real x2629 = 3.673205103346574e-06 * x2251 + 0.9999999999932537 * x2252;
  const Real x2703 = cosine[4] * x2483 - sine[4] * x2472 - x2605 * x2688;
  const Real x2462 = 0.9999999999932537 * x2392 - 3.673205103346574e-06 * x2403;
  const Real x2484 = x2406 - x2481;
  const Real x2739 = x2611 - x2604 * x2690 - x2700 * x2706;
  const Real x2740 = x2739 - x2720 * x2729;
  const Real x2546 = w.x[108] = sine[4] * x2538 - cosine[4] * x2527;
  const Real x2616 = 9.757715913858885 * tau[3] + x2229 - x1488 - 0.38 * x2252;
  const Real x2649 = 3.673205103346574e-06 * x2619 + 0.9999999999932537 * x2624;
  const Real x2750 = w.x[109] = 1 / x2740;
  const Real x2691 = w.x[110] = x2605 * x2687;
  const Real x2726 = cosine[4] * x2570 + sine[4] * x2580 - x2605 * x2689;
  const Real x2727 = x2726 - x2703 * x2705;
  const Real x2612 = cosine[4] * x2580 - sine[4] * x2570 + 0.17828132347140482;
  const Real x2550 = w.x[111] = sine[4] * x2527 + cosine[4] * x2538;
  const Real x2613 = x2434 - x2581 + 0.6105204595515726;
  require_more(w, x2613, 1.513549696734667e-14, kGrowth, 4);
  const Real x2707 = w.x[112] = x2703 * x2704;
  const Real x2609 = w.x[113] = cosine[4] * x2462 + sine[4] * x2484 + 5.809731299927379;
  // link 5 "wrist_housing": acceleration where nothing acts on it
  const Real x2363 = x2328 * 0.17828132347140482 - x2302 * 17.828132347140482 + x2322 * 2.0144858818888856;
  const Real x2369 = x2328 * 0.6105204595515726 - x2302 * 2.2285165433925602 + x2322 * 0.17828132347140482;
  // joint 4 "forearm_roll": assembly: its two sides become one chain
  const Real x2665 = cosine[4] * x2250 - sine[4] * x2629 + x2346;
  const Real x2677 = w.x[114] = x2665 - tau[4] * x2546;
  const Real x2731 = w.x[115] = x2727 * x2728;
  const Real x2748 = x2612 - x2605 * x2690 - x2703 * x2706;
  const Real x2749 = x2727 * x2729 + x2748;
  const Real x2502 = w.x[116] = cosine[4] * x2484 - sine[4] * x2462;
  const Real x2666 = x2349 - (sine[4] * x2250 + cosine[4] * x2629);
  const Real x2751 = w.x[117] = x2749 * x2750;
  const Real x2488 = w.x[118] = x2395 - x2485;
  const Real x2668 = cosine[4] * x2616 - sine[4] * x2649 + x2357;
  const Real x2771 = w.x[119] = x2666 - tau[4] * x2550 - x2677 * x2688;
  const Real x2799 = w.x[120] = 222.85165433925602 * x2688;
  const Real x2801 = w.x[121] = 17.828132347140482 * x2688;
  const Real x2803 = w.x[122] = 2.2285165433925602 * x2688;
  const Real x2761 = x2613 - x2605 * x2691 - x2703 * x2707;
  const Real x2669 = x2363 - (sine[4] * x2616 + cosine[4] * x2649);
  const Real x2815 = w.x[123] = 2.0725831948881592 - 17.828132347140482 * x2705;
  const Real x2763 = x2761 - x2727 * x2731 - x2749 * x2751;
  const Real x2670 = 0.9999999999932537 * x2619 - 3.673205103346574e-06 * x2624 + x2369;
  const Real x2776 = x2668 - tau[4] * x2609 - x2677 * x2689;
  const Real x2777 = w.x[124] = x2776 - x2705 * x2771;
  const Real x2809 = w.x[125] = x2705 * x2799 - 222.85165433925602 * x2689;
  const Real x2812 = w.x[126] = 17.828132347140482 - 222.85165433925602 * x2705;
  const Real x2820 = w.x[127] = 17.828132347140482 * x2689 - x2705 * x2801;
  const Real x2825 = w.x[128] = 2.2285165433925602 * x2689 - x2705 * x2803;
  const Real x2764 = w.x[129] = 1 / x2763;
  const Real x2784 = x2669 - tau[4] * x2502 - x2677 * x2690;
  const Real x2840 = w.x[130] = 5.809731299927379 * x2729;
  const Real x2846 = w.x[131] = x2729 * x2815 - 17.828132347140482 * x2706;
  const Real x2786 = w.x[132] = x2784 - x2706 * x2771 + x2729 * x2777;
  const Real x2795 = x2670 - tau[4] * x2488 - x2677 * x2691;
  const Real x2833 = -17.828132347140482 - 222.85165433925602 * x2690 + x2706 * x2799;
  const Real x2834 = w.x[133] = x2729 * x2809 + x2833;
  const Real x2839 = w.x[134] = x2729 * x2812 - 222.85165433925602 * x2706;
  const Real x2854 = 2.0144858818888856 + 17.828132347140482 * x2690 - x2706 * x2801;
  const Real x2855 = w.x[135] = x2729 * x2820 + x2854;
  const Real x2863 = 0.17828132347140482 + 2.2285165433925602 * x2690 - x2706 * x2803;
  const Real x2864 = w.x[136] = x2729 * x2825 + x2863;
  const Real x2927 = 222.85165433925602 * x2687;
  const Real x2928 = 17.828132347140482 * x2687;
  const Real x2930 = 2.2285165433925602 * x2687;
  const Real x2932 = x2704 * x2799;
  const Real x2935 = 17.828132347140482 * x2704;
  const Real x2936 = x2704 * x2801;
  const Real x2937 = x2704 * x2803;
  const Real x2941 = x2728 * x2815;
  const Real x2874 = -2.2285165433925602 - 222.85165433925602 * x2691 + x2707 * x2799;
  const Real x2891 = w.x[137] = 5.809731299927379 * x2731 + x2751 * x2840;
  const Real x2901 = w.x[138] = 17.828132347140482 * x2707 + x2731 * x2815 + x2751 * x2846;
  const Real x2912 = 0.17828132347140482 + 17.828132347140482 * x2691 - x2707 * x2801;
  const Real x2924 = 0.6105204595515726 + 2.2285165433925602 * x2691 - x2707 * x2803;
  const Real x2934 = 222.85165433925602 * x2704;
  const Real x2938 = x2728 * x2809;
  const Real x2939 = x2728 * x2812;
  const Real x2940 = 5.809731299927379 * x2728;
  const Real x2942 = x2728 * x2820;
  const Real x2943 = x2728 * x2825;
  const Real x2946 = x2750 * x2840;
  const Real x2947 = x2750 * x2846;
  const Real x2797 = x2795 - x2707 * x2771 - x2731 * x2777;
  const Real x2798 = w.x[139] = x2797 - x2751 * x2786;
  const Real x2876 = w.x[140] = x2874 - x2731 * x2809 - x2751 * x2834;
  const Real x2885 = w.x[141] = 222.85165433925602 * x2707 + x2731 * x2812 + x2751 * x2839;
  const Real x2914 = w.x[142] = x2912 - x2731 * x2820 - x2751 * x2855;
  const Real x2926 = w.x[143] = x2924 - x2731 * x2825 - x2751 * x2864;
  const Real x2944 = x2750 * x2834;
  const Real x2945 = x2750 * x2839;
  const Real x2948 = x2750 * x2855;
  const Real x2949 = x2750 * x2864;
  const Real x2953 = x2764 * x2891;
  const Real x2955 = x2764 * x2901;
  // link 5 "wrist_housing": acceleration where nothing acts on it
  const Real x2352 = x2308 * 580.9731299927379 + x2314 * 5.809731299927379;
  // joint 4 "forearm_roll": assembly: its two sides become one chain
  const Real x2950 = x2764 * x2876;
  const Real x2951 = x2764 * x2885;
  const Real x2957 = x2764 * x2914;
  const Real x2958 = x2764 * x2926;
  const Real x2970 = 222.85165433925602 - 222.85165433925602 * x2927 - x2799 * x2932;
  const Real x3016 = -17.828132347140482 + 222.85165433925602 * x2928 + x2799 * x2936;
  const Real x3031 = -2.2285165433925602 + 222.85165433925602 * x2930 + x2799 * x2937;
  const Real x3180 = 2.0144858818888856 - 17.828132347140482 * x2928 - x2801 * x2936;
  const Real x3195 = 0.17828132347140482 - 17.828132347140482 * x2930 - x2801 * x2937;
  // joint 1 "shoulder_pitch": assembly: its two sides become one chain
  w.x[144] = x560 - 3.673205103346574e-06 * x485 - tau[1] * 56.59309564386139;
  const Real x644 = 1.7763568394002505e-15 * x598;
  require_more(w, x629, x644, kFactorization, 1);
  // joint 2 "upper_arm_roll": assembly: its two sides become one chain
  const Real x950 = 0.9999999999932537 * x726 + 3.673205103346574e-06 * x727 + x784;
  w.x[145] = x950 + tau[2] * (x695 - x865 + 254.29116338207245);
  const Real x1058 = 1.7763568394002505e-15 * x910;
  require_more(w, x980, x1058, kFactorization, 2);
  const Real x1059 = 1.7763568394002505e-15 * x913;
  require_more(w, x999, x1059, kFactorization, 2);
  const Real x1060 = 1.7763568394002505e-15 * x914;
  require_more(w, x1029, x1060, kFactorization, 2);
  const Real x1061 = 1.7763568394002505e-15 * x915;
  require_more(w, x1056, x1061, kFactorization, 2);
  // joint 3 "elbow_pitch": assembly: its two sides become one chain
  const Real x1725 = x1483 - (0.9999999999932537 * x1378 + 3.673205103346574e-06 * x1379);
  w.x[146] = x1725 - tau[3] * (x1268 - x1605 + 97.57715913858884);
  const Real x1823 = 1.7763568394002505e-15 * x1674;
  require_more(w, x1755, x1823, kFactorization, 3);
  const Real x1824 = 1.7763568394002505e-15 * x1679;
  require_more(w, x1774, x1824, kFactorization, 3);
  const Real x1825 = 1.7763568394002505e-15 * x1681;
  require_more(w, x1798, x1825, kFactorization, 3);
  const Real x1826 = 1.7763568394002505e-15 * x1682;
  require_more(w, x1821, x1826, kFactorization, 3);
  // joint 4 "forearm_roll": assembly: its two sides become one chain
  const Real x3210 = 0.6105204595515726 - 2.2285165433925602 * x2930 - x2803 * x2937;
  const Real x3223 = x2677 * x2927 - x2771 * x2932 + x2777 * x2938;
  const Real x3246 = x2771 * x2935 + x2777 * x2941 + x2786 * x2947;
  const Real x3255 = x2771 * x2936 - x2677 * x2928 + x2777 * x2942;
  const Real x3265 = x2771 * x2937 - x2677 * x2930 + x2777 * x2943;
  const Real x3044 = 222.85165433925602 - 222.85165433925602 * x2934 - x2812 * x2939;
  const Real x3066 = 17.828132347140482 - 222.85165433925602 * x2935 - x2812 * x2941;
  const Real x3140 = 2.0725831948881592 - 17.828132347140482 * x2935 - x2815 * x2941;
  const Real x3232 = x2771 * x2934 + x2777 * x2939 + x2786 * x2945;
  const Real x3239 = x2777 * x2940 + x2786 * x2946 - x2798 * x2953;
  const Real x2667 = 0.9999999999932537 * x2251 - 3.673205103346574e-06 * x2252 + x2352;
  w.x[147] = x2667 - tau[4] * (x2067 - x2539 + 580.9731299927379);
  const Real x2765 = 1.7763568394002505e-15 * x2606;
  require_more(w, x2694, x2765, kFactorization, 4);
  const Real x2766 = 1.7763568394002505e-15 * x2610;
  require_more(w, x2713, x2766, kFactorization, 4);
  const Real x2767 = 1.7763568394002505e-15 * x2611;
  require_more(w, x2740, x2767, kFactorization, 4);
  const Real x2768 = 1.7763568394002505e-15 * x2613;
  require_more(w, x2763, x2768, kFactorization, 4);
  const Real x2972 = x2970 - x2809 * x2938 - x2834 * x2944;
  w.x[148] = x2972 - x2876 * x2950;
  const Real x2983 = x2799 * x2934 - x2809 * x2939 - x2834 * x2945;
  w.x[149] = x2876 * x2951 + x2983;
  w.x[150] = x2876 * x2953 - (x2809 * x2940 + x2834 * x2946);
  const Real x3003 = x2799 * x2935 - x2809 * x2941 - x2834 * x2947;
  w.x[151] = x2876 * x2955 + x3003;
  const Real x3018 = x3016 - x2809 * x2942 - x2834 * x2948;
  w.x[152] = x3018 - x2876 * x2957;
  const Real x3033 = x3031 - x2809 * x2943 - x2834 * x2949;
  w.x[153] = x3033 - x2876 * x2958;
  w.x[154] = x3044 - x2839 * x2945 - x2885 * x2951;
  w.x[155] = x2812 * x2940 + x2839 * x2946 + x2885 * x2953;
  w.x[156] = x3066 - x2839 * x2947 - x2885 * x2955;
  const Real x3079 = 222.85165433925602 * x2936 + x2812 * x2942 + x2839 * x2948;
  w.x[157] = x2885 * x2957 - x3079;
  const Real x3092 = 222.85165433925602 * x2937 + x2812 * x2943 + x2839 * x2949;
  w.x[158] = x2885 * x2958 - x3092;
  const Real x3102 = 580.9731299927379 - 5.809731299927379 * x2940 - x2840 * x2946;
  w.x[159] = x3102 - x2891 * x2953;
  const Real x3111 = 5.809731299927379 - 5.809731299927379 * x2941 - x2840 * x2947;
  w.x[160] = x3111 - x2891 * x2955;
  w.x[161] = x2891 * x2957 - (5.809731299927379 * x2942 + x2840 * x2948);
  w.x[162] = x2891 * x2958 - (5.809731299927379 * x2943 + x2840 * x2949);
  w.x[163] = x3140 - x2846 * x2947 - x2901 * x2955;
  const Real x3153 = 17.828132347140482 * x2936 + x2815 * x2942 + x2846 * x2948;
  w.x[164] = x2901 * x2957 - x3153;
  const Real x3166 = 17.828132347140482 * x2937 + x2815 * x2943 + x2846 * x2949;
  w.x[165] = x2901 * x2958 - x3166;
  const Real x3182 = x3180 - x2820 * x2942 - x2855 * x2948;
  w.x[166] = x3182 - x2914 * x2957;
  const Real x3197 = x3195 - x2820 * x2943 - x2855 * x2949;
  w.x[167] = x3197 - x2914 * x2958;
  const Real x3212 = x3210 - x2825 * x2943 - x2864 * x2949;
  w.x[168] = x3212 - x2926 * x2958;
  w.x[169] = x2786 * x2944 + x3223 + x2798 * x2950 - x2346;
  w.x[170] = x3232 - x2798 * x2951 - x2349;
  w.x[171] = 580.9731299927379 * tau[4] + x3239 - x2352;
  w.x[172] = x3246 - x2798 * x2955 + 5.809731299927379 * tau[4] - x2357;
  w.x[173] = x2786 * x2948 + x3255 + x2798 * x2957 - x2363;
  w.x[174] = x2786 * x2949 + x3265 + x2798 * x2958 - x2369;
}

ADAGEN_NOINLINE ADAGEN_AS_IT_STANDS void part_0_1(Workspace& w) {
  ADAGEN_INPUTS
  // message received
  const Real x3276 = w.from[0][0];
  const Real x3277 = w.from[0][1];
  const Real x3282 = w.from[0][6];
  const Real x3279 = w.from[0][3];
  const Real x3284 = w.from[0][8];
  const Real x3291 = w.from[0][15];
  const Real x3280 = w.from[0][4];
  const Real x3285 = w.from[0][9];
  const Real x3292 = w.from[0][16];
  const Real x3294 = w.from[0][18];
  const Real x3281 = w.from[0][5];
  const Real x3286 = w.from[0][10];
  const Real x3293 = w.from[0][17];
  const Real x3278 = w.from[0][2];
  const Real x3295 = w.from[0][19];
  const Real x3283 = w.from[0][7];
  const Real x3297 = w.from[0][21];
  const Real x3288 = w.from[0][12];
  const Real x3298 = w.from[0][22];
  const Real x3296 = w.from[0][20];
  const Real x3289 = w.from[0][13];
  const Real x3300 = w.from[0][24];
  const Real x3290 = w.from[0][14];
  const Real x3301 = w.from[0][25];
  const Real x3302 = w.from[0][26];
  w.x[175] = w.from[0][11];
  w.x[176] = w.from[0][23];
  // joint 5 "wrist_pitch": assembly: its two sides become one chain
  const Real x3398 = 2.0 * sine[5];
  const Real x2984 = w.x[149];
  const Real x2993 = w.x[150];
  const Real x3367 = 0.9999999999932537 * x2993 - 3.673205103346574e-06 * x2984;
  const Real x3068 = w.x[156];
  const Real x3112 = w.x[160];
  const Real x3307 = 0.9999999999932537 * x3112 - 3.673205103346574e-06 * x3068;
  const Real x3046 = w.x[154];
  const Real x3055 = w.x[155];
  const Real x3103 = w.x[159];
  const Real x3379 = 3.673205103346574e-06 * (x3046 - x3103) + 1.9999999999865075 * x3055;
  const Real x3019 = w.x[152];
  const Real x3034 = w.x[153];
  const Real x3317 = 0.9999999999932537 * x3034 - 3.673205103346574e-06 * x3019;
  const Real x3081 = w.x[157];
  const Real x3094 = w.x[158];
  const Real x3121 = w.x[161];
  const Real x3130 = w.x[162];
  const Real x3329 = 0.9999999999932537 * (x3094 + x3121) - 3.673205103346574e-06 * (x3081 - x3130);
  const Real x3384 = w.x[177] = 3.673205103346574e-06 * x3379;
  const Real x3183 = w.x[166];
  const Real x3198 = w.x[167];
  const Real x3213 = w.x[168];
  const Real x3420 = 1.9999999999865075 * x3198 - 3.673205103346574e-06 * (x3183 - x3213);
  const Real x3155 = w.x[164];
  const Real x3168 = w.x[165];
  const Real x3409 = 0.9999999999932537 * x3168 - 3.673205103346574e-06 * x3155;
  const Real x3333 = 3.673205103346574e-06 * x3329;
  const Real x3330 = 0.9999999999932537 * x3329;
  const Real x3322 = 0.9999999999932537 * x3019 + 3.673205103346574e-06 * x3034;
  const Real x3386 = x3103 + x3384;
  const Real x3423 = 3.673205103346574e-06 * x3420;
  const Real x3335 = x3130 - x3333;
  const Real x3331 = x3094 - x3330;
  const Real x3425 = x3213 - x3423;
  const Real x3414 = 0.9999999999932537 * x3155 + 3.673205103346574e-06 * x3168;
  const Real x3422 = x3198 - 0.9999999999932537 * x3420;
  const Real x3372 = 0.9999999999932537 * x2984 + 3.673205103346574e-06 * x2993;
  const Real x3383 = 0.9999999999932537 * x3379 - x3055;
  const Real x2973 = w.x[148];
  const Real x3400 = cosine[5] * (x2973 - x3386) + x3367 * x3398;
  const Real x3004 = w.x[151];
  const Real x3357 = cosine[5] * (x3004 - x3335) + sine[5] * (x3307 + x3317);
  const Real x3449 = sine[5] * x3331 - cosine[5] * x3322 + x3281;
  const Real x3403 = cosine[5] * x3400;
  const Real x3142 = w.x[163];
  const Real x3438 = cosine[5] * (x3142 - x3425) + x3398 * x3409;
  const Real x3271 = w.x[170];
  const Real x3272 = w.x[171];
  const Real x3468 = 0.9999999999932537 * x3272 - 3.673205103346574e-06 * x3271;
  const Real x3361 = cosine[5] * x3357;
  const Real x3358 = sine[5] * x3357;
  const Real x3441 = cosine[5] * x3438;
  const Real x3444 = x3386 + x3403 + x3276;
  require_more(w, x3444, 1.2260061762262752e-11, kGrowth, 5);
  require_more(w, x3444, 0.0, kFactorization, 5);
  const Real x3445 = x3367 - sine[5] * x3400 + x3277;
  const Real x3450 = w.x[178] = x2973 - x3403 + x3282;
  require_more(w, x3450, 1.2260061762262752e-11, kGrowth, 5);
  const Real x3447 = x3335 + x3361 + x3279;
  const Real x3448 = x3317 - x3358 + x3280;
  const Real x3525 = 1 / x3444;
  const Real x3459 = w.x[179] = x3425 + x3441 + x3291;
  require_more(w, x3459, 2.0383895677461698e-14, kGrowth, 5);
  const Real x3312 = 0.9999999999932537 * x3068 + 3.673205103346574e-06 * x3112;
  const Real x3332 = x3121 - x3330;
  const Real x3462 = w.x[180] = x3142 - x3441 + x3294;
  require_more(w, x3462, 3.678103573346401e-14, kGrowth, 5);
  const Real x3446 = w.x[181] = sine[5] * x3383 - cosine[5] * x3372 + x3278;
  const Real x3274 = w.x[173];
  const Real x3275 = w.x[174];
  const Real x3485 = 0.9999999999932537 * x3275 - 3.673205103346574e-06 * x3274;
  const Real x3526 = x3445 * x3525;
  const Real x3527 = x3447 * x3525;
  const Real x3528 = x3448 * x3525;
  const Real x3451 = w.x[182] = sine[5] * x3372 + cosine[5] * x3383 + x3283;
  const Real x3532 = w.x[183] = x3450 - x3445 * x3526;
  const Real x3535 = x3307 - x3358 + x3284 - x3447 * x3526;
  const Real x3538 = x3004 - x3361 + x3285 - x3448 * x3526;
  const Real x3454 = sine[5] * x3322 + cosine[5] * x3331 + x3286;
  const Real x3541 = x3454 - x3449 * x3526;
  const Real x3461 = sine[5] * x3422 - cosine[5] * x3414 + x3293;
  const Real x3542 = 1 / x3532;
  const Real x3529 = x3449 * x3525;
  const Real x3463 = sine[5] * x3414 + cosine[5] * x3422 + x3295;
  const Real x3456 = w.x[184] = sine[5] * x3332 - cosine[5] * x3312 + x3288;
  const Real x3270 = w.x[169];
  const Real x3499 = cosine[5] * x3270 + sine[5] * x3468 - x3297;
  const Real x3513 = x3499 - tau[5] * x3446;
  const Real x3464 = w.x[185] = x3183 + x3423 + x3296;
  require_more(w, x3464, 3.787417840386417e-14, kGrowth, 5);
  const Real x3457 = w.x[186] = sine[5] * x3312 + cosine[5] * x3332 + x3289;
  const Real x3500 = cosine[5] * x3468 - sine[5] * x3270 - x3298;
  const Real x3458 = w.x[187] = x3081 + x3333 + x3290;
  const Real x3273 = w.x[172];
  const Real x3503 = cosine[5] * x3273 + sine[5] * x3485 - x3300;
  const Real x3543 = x3535 * x3542;
  const Real x3544 = x3538 * x3542;
  const Real x3545 = x3541 * x3542;
  const Real x3606 = x3500 - tau[5] * x3451 - x3513 * x3526;
  const Real x3504 = cosine[5] * x3485 - sine[5] * x3273 - x3301;
  const Real x3505 = 0.9999999999932537 * x3274 + 3.673205103346574e-06 * x3275 + x3302;
  const Real x3551 = w.x[188] = x3459 - x3447 * x3527 - x3535 * x3543;
  const Real x3556 = x3409 - sine[5] * x3438 + x3292 - x3448 * x3527;
  const Real x3557 = x3556 - x3538 * x3543;
  const Real x3563 = x3461 - x3449 * x3527 - x3541 * x3543;
  const Real x3611 = x3503 - tau[5] * x3456 - x3513 * x3527;
  const Real x3612 = x3611 - x3543 * x3606;
  const Real x3564 = 1 / x3551;
  const Real x3619 = x3504 - tau[5] * x3457 - x3513 * x3528;
  const Real x3630 = x3505 + tau[5] * x3458 + x3513 * x3529;
  const Real x3565 = x3557 * x3564;
  const Real x3566 = x3563 * x3564;
  const Real x3574 = x3462 - x3448 * x3528 - x3538 * x3544;
  const Real x3575 = w.x[189] = x3574 - x3557 * x3565;
  const Real x3583 = x3463 - x3449 * x3528 - x3541 * x3544;
  const Real x3584 = x3583 - x3563 * x3565;
  const Real x3596 = x3464 - x3449 * x3529 - x3541 * x3545;
  const Real x3621 = x3619 - x3544 * x3606 - x3565 * x3612;
  const Real x3585 = 1 / x3575;
  const Real x3586 = x3584 * x3585;
  const Real x3598 = w.x[190] = x3596 - x3563 * x3566 - x3584 * x3586;
  const Real x3634 = x3545 * x3606 + x3630 + x3566 * x3612;
  // joint 5 "wrist_pitch": disassembly: its acceleration and force
  const Real x3642 = w.x[191] = 1 / x3598 * (x3586 * x3621 + x3634);
  const Real x3643 = -x3642;
  w.to[1][5] = x3643;
  const Real x3646 = w.x[192] = x3585 * x3621 + x3586 * x3642;
  w.to[1][4] = x3646;
  const Real x3652 = w.x[193] = x3564 * x3612 + x3566 * x3642 - x3565 * x3646;
  w.to[1][3] = x3652;
  const Real x3660 = x3542 * x3606 + x3545 * x3642 - x3544 * x3646;
  const Real x3661 = w.x[194] = x3660 - x3543 * x3652;
  w.to[1][1] = x3661;
  const Real x3671 = x3513 * x3525 + x3529 * x3642 - x3528 * x3646;
  const Real x3673 = w.x[195] = x3671 - x3527 * x3652 - x3526 * x3661;
  w.to[1][0] = x3673;
}

ADAGEN_NOINLINE ADAGEN_AS_IT_STANDS void part_0_2(Workspace& w) {
  ADAGEN_INPUTS
  // joint 5 "wrist_pitch": assembly: its two sides become one chain
  const Real x3464 = w.x[185];
  const Real x3598 = w.x[190];
  const Real x3603 = 1.7763568394002505e-15 * x3464;
  require_more(w, x3598, x3603, kFactorization, 5);
  const Real x3271 = w.x[170];
  const Real x3272 = w.x[171];
  const Real x3299 = w.x[176];
  const Real x3501 = 0.9999999999932537 * x3271 + 3.673205103346574e-06 * x3272 + x3299;
  const Real x3450 = w.x[178];
  const Real x3532 = w.x[183];
  const Real x3600 = 1.7763568394002505e-15 * x3450;
  require_more(w, x3532, x3600, kFactorization, 5);
  const Real x3459 = w.x[179];
  const Real x3551 = w.x[188];
  const Real x3601 = 1.7763568394002505e-15 * x3459;
  require_more(w, x3551, x3601, kFactorization, 5);
  const Real x3462 = w.x[180];
  const Real x3575 = w.x[189];
  const Real x3602 = 1.7763568394002505e-15 * x3462;
  require_more(w, x3575, x3602, kFactorization, 5);
  // joint 5 "wrist_pitch": disassembly: its acceleration and force
  const Real x3646 = w.x[192];
  const Real x3652 = w.x[193];
  const Real x3708 = sine[5] * x3652 + cosine[5] * x3646;
  const Real x3705 = cosine[5] * x3652 - sine[5] * x3646;
  const Real x3642 = w.x[191];
  const Real x3713 = 0.9999999999932537 * x3642 - 3.673205103346574e-06 * x3708;
  const Real x3717 = 0.9999999999932537 * x3708 + 3.673205103346574e-06 * x3642;
  const Real x3456 = w.x[184];
  const Real x3457 = w.x[186];
  const Real x3458 = w.x[187];
  const Real x3681 = x3457 * x3646 - x3458 * x3642 + x3456 * x3652;
  const Real x3661 = w.x[194];
  const Real x3673 = w.x[195];
  const Real x3691 = sine[5] * x3673 + cosine[5] * x3661;
  const Real x3688 = cosine[5] * x3673 - sine[5] * x3661;
  const Real x3696 = 3.673205103346574e-06 * x3691 + 0.9999999999932537 * tau[5];
  const Real x3701 = 0.9999999999932537 * x3691 - 3.673205103346574e-06 * tau[5];
  // joint 4 "forearm_roll": disassembly: its acceleration and force
  const Real x2901 = w.x[138];
  const Real x2914 = w.x[142];
  const Real x2926 = w.x[143];
  const Real x3798 = x2901 * x3705 - x2914 * x3713 - x2926 * x3717;
  const Real x2846 = w.x[131];
  const Real x2855 = w.x[135];
  const Real x2864 = w.x[136];
  const Real x3779 = x2846 * x3705 + x2855 * x3713 + x2864 * x3717;
  const Real x2815 = w.x[123];
  const Real x2820 = w.x[127];
  const Real x2825 = w.x[128];
  const Real x3760 = x2815 * x3705 + x2820 * x3713 + x2825 * x3717;
  const Real x2801 = w.x[121];
  const Real x2803 = w.x[122];
  const Real x3743 = 17.828132347140482 * x3705 + x2801 * x3713 + x2803 * x3717;
  const Real x3731 = 17.828132347140482 * x3713 + 2.2285165433925602 * x3717 - 222.85165433925602 * x3688;
  const Real x2876 = w.x[140];
  const Real x2885 = w.x[141];
  const Real x3800 = x3798 - x2876 * x3688 - x2885 * x3696;
  // joint 5 "wrist_pitch": assembly: its two sides become one chain
  const Real x3046 = w.x[154];
  const Real x3287 = w.x[175];
  const Real x3384 = w.x[177];
  const Real x3515 = x3501 + tau[5] * (x3046 - x3384 + x3287);
  // joint 5 "wrist_pitch": disassembly: its acceleration and force
  const Real x3446 = w.x[181];
  const Real x3451 = w.x[182];
  const Real x3684 = x3451 * x3661 + x3681 + x3446 * x3673 + x3515;
  w.result[5] = x3684;
  // joint 4 "forearm_roll": disassembly: its acceleration and force
  const Real x2834 = w.x[133];
  const Real x2839 = w.x[134];
  const Real x3783 = x2839 * x3696 - (x2834 * x3688 + x3779);
  const Real x2809 = w.x[125];
  const Real x2812 = w.x[126];
  const Real x3764 = x2812 * x3696 - (x2809 * x3688 + x3760);
  const Real x2771 = w.x[119];
  const Real x2799 = w.x[120];
  const Real x3803 = x2771 - (x2799 * x3688 - x3743 + 222.85165433925602 * x3696);
  const Real x2764 = w.x[129];
  const Real x2798 = w.x[139];
  const Real x2891 = w.x[137];
  const Real x3819 = x2764 * (x2798 - (x2891 * x3701 + x3800));
  const Real x2750 = w.x[109];
  const Real x2786 = w.x[132];
  const Real x2840 = w.x[130];
  const Real x3818 = x2750 * (x2786 - (x3783 - x2840 * x3701));
  const Real x2751 = w.x[117];
  const Real x3822 = x3818 - x2751 * x3819;
  const Real x2728 = w.x[104];
  const Real x2777 = w.x[124];
  const Real x3817 = x2728 * (x2777 - (x3764 - 5.809731299927379 * x3701));
  const Real x2729 = w.x[107];
  const Real x2731 = w.x[115];
  const Real x3828 = x3817 - x2731 * x3819 + x2729 * x3822;
  const Real x2677 = w.x[114];
  const Real x2687 = w.x[90];
  const Real x2691 = w.x[110];
  const Real x3846 = x2687 * (x2677 - x3731) - x2691 * x3819;
  const Real x2704 = w.x[99];
  const Real x2706 = w.x[106];
  const Real x2707 = w.x[112];
  const Real x3836 = x2704 * x3803 - x2707 * x3819 - x2706 * x3822;
  const Real x2705 = w.x[103];
  const Real x3837 = x3836 - x2705 * x3828;
  const Real x3883 = sine[4] * x3828 + cosine[4] * x3822;
  const Real x3880 = cosine[4] * x3828 - sine[4] * x3822;
  const Real x2689 = w.x[102];
  const Real x2690 = w.x[105];
  const Real x3848 = x3846 - x2690 * x3822 - x2689 * x3828;
  const Real x2688 = w.x[98];
  const Real x3849 = x3848 - x2688 * x3837;
  const Real x3887 = 0.9999999999932537 * x3819 - 3.673205103346574e-06 * x3883;
  const Real x3892 = 0.9999999999932537 * x3883 + 3.673205103346574e-06 * x3819;
  const Real x3866 = sine[4] * x3849 + cosine[4] * x3837;
  const Real x3896 = cosine[4] * x3849 - sine[4] * x3837 - 0.38 * x3892;
  const Real x2488 = w.x[118];
  const Real x2502 = w.x[116];
  const Real x2609 = w.x[113];
  const Real x3856 = x2502 * x3822 + x2488 * x3819 + x2609 * x3828;
  const Real x3899 = 0.9999999999932537 * tau[4] - 3.673205103346574e-06 * x3866 - 0.08 * x3892;
  const Real x3875 = 0.9999999999932537 * x3866 + 3.673205103346574e-06 * tau[4];
  const Real x3906 = 0.08 * x3887 + 0.38 * x3880 + x3875;
  // joint 3 "elbow_pitch": disassembly: its acceleration and force
  const Real x1938 = w.x[88];
  const Real x1944 = w.x[87];
  const Real x1957 = w.x[85];
  const Real x3974 = x1938 * x3880 + x1944 * x3887 + x1957 * x3892;
  const Real x1893 = w.x[81];
  const Real x1896 = w.x[79];
  const Real x1905 = w.x[78];
  const Real x3955 = x1893 * x3880 + x1896 * x3887 + x1905 * x3892;
  const Real x1874 = w.x[71];
  const Real x3938 = x1874 * x3892 - (1.430317045931343 * x3880 + 0.48788579569294427 * x3887);
  // joint 4 "forearm_roll": disassembly: its acceleration and force
  const Real x2546 = w.x[108];
  const Real x2550 = w.x[111];
  const Real x3858 = x2550 * x3837 + x3856 + x2546 * x3849;
  const Real x2679 = w.x[147];
  const Real x3859 = x3858 - (580.9731299927379 * x3701 + 5.809731299927379 * x3705 + x2679);
  w.result[4] = x3859;
  // joint 3 "elbow_pitch": disassembly: its acceleration and force
  const Real x1918 = w.x[84];
  const Real x1927 = w.x[82];
  const Real x3976 = x3974 - x1918 * x3896 - x1927 * x3899;
  const Real x1882 = w.x[77];
  const Real x1887 = w.x[74];
  const Real x3959 = x1882 * x3896 + x3955 + x1887 * x3899;
  const Real x1866 = w.x[70];
  const Real x1868 = w.x[68];
  const Real x3940 = x1866 * x3896 + x3938 + x1868 * x3899;
  const Real x1857 = w.x[63];
  const Real x1861 = w.x[64];
  const Real x3925 = x1861 * x3892 - x1857 * x3896 - 363.6363636363637 * x3899;
  const Real x3990 = 97.57715913858884 * x3906 - (9.757715913858885 * x3880 + 4.878857956929442 * x3887);
  const Real x1822 = w.x[86];
  const Real x1856 = w.x[101];
  const Real x1932 = w.x[83];
  const Real x3996 = x1822 * (x1856 - (x3976 - x1932 * x3906));
  const Real x1808 = w.x[76];
  const Real x1844 = w.x[100];
  const Real x1890 = w.x[75];
  const Real x3995 = x1808 * (x1844 - (x1890 * x3906 - x3959));
  const Real x1809 = w.x[80];
  const Real x3999 = x3995 - x1809 * x3996;
  const Real x1787 = w.x[69];
  const Real x1835 = w.x[97];
  const Real x3994 = x1787 * (x1835 - (9.757715913858885 * x3906 + x3940));
  const Real x1735 = w.x[93];
  const Real x1746 = w.x[57];
  const Real x3992 = x1746 * (97.57715913858884 * x3896 + 9.757715913858885 * x3892 + x1735);
  const Real x1788 = w.x[72];
  const Real x1789 = w.x[73];
  const Real x4005 = x3994 - x1789 * x3996 - x1788 * x3999;
  const Real x1765 = w.x[62];
  const Real x1768 = w.x[67];
  const Real x1829 = w.x[96];
  const Real x4012 = x1765 * (x1829 - x3925) - x1768 * x3996;
  const Real x1766 = w.x[65];
  const Real x1767 = w.x[66];
  const Real x4014 = x4012 - x1767 * x3999 - x1766 * x4005;
  const Real x1750 = w.x[60];
  const Real x1752 = w.x[61];
  const Real x4024 = x3992 - x1752 * x3996 + x1750 * x3999;
  const Real x4060 = sine[3] * x4005 + cosine[3] * x3999;
  const Real x4057 = cosine[3] * x4005 - sine[3] * x3999;
  const Real x1747 = w.x[58];
  const Real x1749 = w.x[59];
  const Real x4026 = x4024 - x1749 * x4005 + x1747 * x4014;
  const Real x4065 = 3.673205103346574e-06 * x4060 + 0.9999999999932537 * x3996;
  const Real x4070 = 0.9999999999932537 * x4060 - 3.673205103346574e-06 * x3996;
  const Real x4043 = sine[3] * x4026 + cosine[3] * x4014;
  const Real x4040 = cosine[3] * x4026 - sine[3] * x4014;
  const Real x1562 = w.x[95];
  const Real x1677 = w.x[92];
  const Real x1678 = w.x[94];
  const Real x4033 = x1678 * x3999 + x1562 * x3996 + x1677 * x4005;
  const Real x1612 = w.x[89];
  const Real x1616 = w.x[91];
  const Real x4035 = x1616 * x4014 + x4033 + x1612 * x4026;
  const Real x1737 = w.x[146];
  const Real x4036 = x3990 - x1737 + x4035;
  w.result[3] = x4036;
  const Real x4073 = 3.673205103346574e-06 * x4043 + 0.9999999999932537 * tau[3] + 0.08 * x4070;
  // joint 2 "upper_arm_roll": disassembly: its acceleration and force
  const Real x1169 = w.x[54];
  const Real x1180 = w.x[52];
  const Real x4127 = x1180 * x4065 - x1169 * x4057 - 0.3846153846153846 * x4070;
  // joint 3 "elbow_pitch": disassembly: its acceleration and force
  const Real x4077 = 0.9999999999932537 * x4043 - 3.673205103346574e-06 * tau[3] - 0.08 * x4065;
  // joint 2 "upper_arm_roll": disassembly: its acceleration and force
  const Real x1121 = w.x[44];
  const Real x1131 = w.x[47];
  const Real x1140 = w.x[46];
  const Real x4116 = x1140 * x4065 - x1131 * x4057 - x1121 * x4040;
  const Real x1100 = w.x[38];
  const Real x1107 = w.x[40];
  const Real x1112 = w.x[39];
  const Real x4107 = x1112 * x4065 - x1107 * x4057 + x1100 * x4040;
  const Real x1092 = w.x[30];
  const Real x1094 = w.x[31];
  const Real x4097 = 3.338433718180554 * x4057 + x1094 * x4065 + x1092 * x4040;
  const Real x1091 = w.x[56];
  const Real x1153 = w.x[51];
  const Real x1161 = w.x[50];
  const Real x4134 = x1091 - (x4127 - x1153 * x4040 + x1161 * x4073);
  const Real x1057 = w.x[53];
  const Real x4142 = x1057 * x4134;
  const Real x1042 = w.x[45];
  const Real x1079 = w.x[55];
  const Real x1126 = w.x[43];
  const Real x4141 = x1042 * (x1079 - (x1126 * x4073 + x4116));
  const Real x1043 = w.x[49];
  const Real x4145 = x4141 + x1043 * x4142;
  const Real x1016 = w.x[37];
  const Real x1070 = w.x[48];
  const Real x1104 = w.x[36];
  const Real x4140 = x1016 * (x1070 - (x1104 * x4073 + x4107));
  const Real x990 = w.x[29];
  const Real x1064 = w.x[32];
  const Real x4139 = x990 * (x1064 - (111.2811239393518 * x4073 - x4097));
  const Real x962 = w.x[23];
  const Real x972 = w.x[22];
  const Real x4138 = x972 * (111.2811239393518 * x4040 + 3.338433718180554 * x4065 + x962);
  const Real x1017 = w.x[41];
  const Real x1019 = w.x[42];
  const Real x4151 = x4140 + x1019 * x4142 + x1017 * x4145;
  const Real x992 = w.x[34];
  const Real x993 = w.x[35];
  const Real x4159 = x4139 - x993 * x4142 - x992 * x4145;
  const Real x991 = w.x[33];
  const Real x4160 = x4159 - x991 * x4151;
  const Real x976 = w.x[27];
  const Real x977 = w.x[28];
  const Real x4170 = x4138 - x977 * x4142 - x976 * x4145;
  const Real x4204 = cosine[2] * x4151 - sine[2] * x4145;
  const Real x973 = w.x[25];
  const Real x975 = w.x[26];
  const Real x4172 = x4170 - x975 * x4151 + x973 * x4160;
  const Real x4214 = 0.9999999999932537 * (sine[2] * x4151 + cosine[2] * x4145);
  const Real x4217 = x4214 - 3.673205103346574e-06 * x4142;
  const Real x823 = w.x[18];
  const Real x838 = w.x[21];
  const Real x844 = w.x[24];
  const Real x4180 = x844 * x4145 + x823 * x4142 - x838 * x4151;
  const Real x4190 = sine[2] * x4172 + cosine[2] * x4160;
  const Real x4220 = cosine[2] * x4172 - sine[2] * x4160 - 0.3 * x4217;
  const Real x872 = w.x[19];
  const Real x876 = w.x[20];
  const Real x4182 = x876 * x4160 + x4180 + x872 * x4172;
  const Real x964 = w.x[145];
  const Real x4183 = x964 - 254.29116338207245 * x4077 + x4182;
  w.result[2] = x4183;
  const Real x4195 = 3.673205103346574e-06 * x4190 + 0.9999999999932537 * tau[2];
  const Real x4223 = 0.9999999999932537 * x4190 - 3.673205103346574e-06 * tau[2] + 0.3 * x4204;
  // joint 1 "shoulder_pitch": disassembly: its acceleration and force
  const Real x642 = w.x[14];
  const Real x662 = w.x[15];
  const Real x663 = w.x[13];
  const Real x4255 = x663 * x4195 - (x662 * x4220 + x642 * x4217);
  const Real x630 = w.x[7];
  const Real x655 = w.x[8];
  const Real x4241 = x655 * x4220 + x630 * x4217 + 179.2114695340502 * x4195;
  const Real x643 = w.x[17];
  const Real x654 = w.x[16];
  const Real x4271 = x643 * (x654 - x4255);
  const Real x632 = w.x[10];
  const Real x633 = w.x[12];
  const Real x648 = w.x[11];
  const Real x4274 = x632 * (x648 - x4241) + x633 * x4271;
  const Real x616 = w.x[9];
  const Real x624 = w.x[3];
  const Real x4267 = x624 * (56.59309564233163 * x4220 + 5.659309564233164 * x4217 + x616);
  const Real x619 = w.x[6];
  const Real x4269 = 1.1254777070063695 * (x619 - (5.659309564233164 * x4223 - 0.8885116015846066 * x4204));
  const Real x625 = w.x[4];
  const Real x626 = w.x[5];
  const Real x4280 = x4267 - x626 * x4271 - x625 * x4274;
  const Real x587 = w.x[1];
  const Real x588 = w.x[2];
  const Real x4286 = x588 * x4274 - 5.659309564233164 * x4269 + x587 * x4280;
  const Real x618 = w.x[144];
  const Real x4287 = 5.659309564233164 * x4204 - 56.59309564233163 * x4223 - x618 + x4286;
  w.result[1] = x4287;
  const Real x4299 = 0.9999999999932537 * (sine[1] * x4280 + cosine[1] * x4274);
  // joint 0 "base_yaw": disassembly: its acceleration and force
  const Real x485 = w.x[0];
  const Real x4350 = x485 + 113.37868480725623 * (x4299 + 3.673205103346574e-06 * tau[1]);
  w.result[0] = x4350;
}

// =================================================================================================
// Process 1: 1397 products, 1172 sums, 12 quotients
// =================================================================================================

ADAGEN_NOINLINE ADAGEN_AS_IT_STANDS void part_1_0(Workspace& w) {
  ADAGEN_INPUTS
  // joint 1 "shoulder_pitch": placement, velocity and reference acceleration of its link
  const Real x20 = v[0] * 0.9999999999932537;
  const Real x29 = v[1] - v[0] * 3.673205103346574e-06;
  const Real x27 = cosine[1] * x20;
  const Real x25 = sine[1] * x20;
  // joint 8 "right_finger_slide": placement, velocity and reference acceleration of its link
  const Real x585 = q[8] * 2.65358979335273e-06;
  const Real x588 = q[8] * 0.9999999999964793;
  // joint 8 "right_finger_slide": assembly: its two sides become one chain
  const Real x950 = x588 * 300.9051975855012;
  const Real x943 = x588 * 47.81116318204386;
  const Real x957 = x588 * 328.7950427750268;
  const Real x971 = x588 * 7.026218837536823;
  const Real x956 = 5.698005698005698 + x585 * 672.6812282367838;
  const Real x949 = x585 * 47.81116318204386 + -12.020625953341622;
  const Real x1004 = 1.2247360482654601 + x585 * 5.698005698005698;
  const Real x962 = -0.8107676238711207 - x585 * 328.7950427750268;
  const Real x995 = x585 * 7.026218837536823 + 0.11703803530578138;
  const Real x1026 = 2.65358979335273e-06 * x943;
  const Real x1149 = w.x[0] = x943 * 3.3296807285906615e-06;
  const Real x1019 = 2.65358979335273e-06 * x962 - 0.9999999999964793 * x957;
  const Real x1031 = 0.9999999999964793 * (x949 + 27.77777777777778) - x1026;
  const Real x1079 = w.x[1] = x588 * x950 + x1004 + x585 * x956 + 25.999988000024;
  require_more(w, x1079, 3.862007046714566e-13, kGrowth, 8);
  const Real x970 = x588 * x957 + 2.3235294117647056;
  const Real x1075 = 0.9999999999964793 * x950 + 2.65358979335273e-06 * x956 + -599.9988000024;
  const Real x1159 = x1075 - x943 * 0.00015919590865819434;
  const Real x997 = w.x[2] = x995 - 0.13 * x949 - x585 * x962;
  const Real x1032 = 0.9999999999964793 * x1031;
  const Real x1036 = w.x[3] = 2.65358979335273e-06 * x1031;
  const Real x1073 = 3000.003000003 + x1019;
  const Real x1166 = w.x[4] = x1159 * 1.658353407741297e-05;
  const Real x978 = 0.13 * x943 - x971 - x585 * x957;
  const Real x986 = x585 * 27.77777777777778 + 0.23529411764705882 + x588 * x943;
  const Real x998 = x588 * x949;
  const Real x1180 = 2.65358979335273e-06 * x950 - 0.9999999999964793 * x956 - x943 * 4.2244063836038523e-10;
  const Real x1181 = x1159 * 1.63606725685963e-08 + x1180;
  const Real x1189 = w.x[5] = x1181 * 1.648191504944564e-05;
  const Real x1162 = x943 + x1036 + x1073 * 0.00015919590865819434;
  const Real x1150 = w.x[6] = x1073 * 3.3296807285906615e-06;
  const Real x1065 = 2.65358979335273e-06 * (x970 - x997) + x978 * 1.9999999999929585;
  const Real x1167 = w.x[7] = x1162 * 1.658353407741297e-05;
  const Real x1069 = w.x[8] = 2.65358979335273e-06 * x1065;
  const Real x1198 = x1079 - x943 * x1149 - x1159 * x1166;
  const Real x1199 = w.x[9] = x1198 - x1181 * x1189;
  const Real x1186 = x1032 - x949 + -1799.9964000071998 - x1073 * 4.2244063836038523e-10;
  const Real x1187 = x1186 - x1162 * 1.63606725685963e-08;
  // joint 1 "shoulder_pitch": placement, velocity and reference acceleration of its link
  const Real x30 = v[1] * x27;
  const Real x32 = v[1] * x25;
  // joint 2 "upper_arm_roll": placement, velocity and reference acceleration of its link
  const Real x80 = 3.673205103346574e-06 * x27 + 0.9999999999932537 * x29;
  const Real x95 = 3.673205103346574e-06 * x32;
  const Real x89 = sine[2] * x80 - x25 * cosine[2];
  const Real x93 = x25 * sine[2] + cosine[2] * x80;
  const Real x94 = 0.9999999999932537 * x27 - 3.673205103346574e-06 * x29 + v[2];
  const Real x120 = (x25 * x25 + x29 * x29) * 0.3;
  const Real x122 = x120 - cosine[1] * 9.809999999933819;
  const Real x125 = -3.603414206382989e-05 + (x30 + x27 * x29) * 0.3;
  const Real x97 = 0.9999999999932537 * x32;
  const Real x114 = x30 * sine[2] - cosine[2] * x95 - v[2] * x89;
  const Real x118 = sine[1] * 9.809999999933819 + x25 * x27 * 0.3;
  const Real x129 = 0.9999999999932537 * x125 - 3.673205103346574e-06 * x122;
  const Real x111 = v[2] * x93 - (x30 * cosine[2] + sine[2] * x95);
  // joint 3 "elbow_pitch": placement, velocity and reference acceleration of its link
  const Real x174 = 0.9999999999932537 * x94 - 3.673205103346574e-06 * x93;
  const Real x193 = 3.673205103346574e-06 * x114 + 0.9999999999932537 * x97;
  // joint 8 "right_finger_slide": assembly: its two sides become one chain
  const Real x1206 = 0.9999999999964793 * x986 + 2.65358979335273e-06 * x998 + x1073 * x1149;
  const Real x1210 = w.x[10] = 1 / x1199;
  const Real x1190 = w.x[11] = x1187 * 1.648191504944564e-05;
  const Real x1081 = w.x[12] = x970 - x1069 + 103.99992200024599;
  require_more(w, x1081, 1.4946464345439562e-12, kGrowth, 8);
  const Real x1209 = x1162 * x1166 - x1206 - x1187 * x1189;
  const Real x1222 = x1081 - (x1073 * x1150 + x1162 * x1167);
  const Real x1211 = w.x[13] = x1209 * x1210;
  const Real x1359 = x943 - 328.7950427750268 * x1149 - x1166 * 47.758820356278655;
  const Real x1360 = w.x[14] = x1359 - x1189 * 0.0001275136846625453;
  const Real x1224 = w.x[15] = x1222 - x1187 * x1190 - x1209 * x1211;
  const Real x1225 = w.x[16] = 1 / x1224;
  const Real x1416 = x1019 - 328.7950427750268 * x1150 + x1167 * 47.758820356278655;
  const Real x1418 = w.x[17] = x1416 - x1190 * 0.0001275136846625453 - x1211 * x1360;
  const Real x1466 = x1210 * x1360;
  const Real x1472 = x1225 * x1418;
  // joint 3 "elbow_pitch": placement, velocity and reference acceleration of its link
  const Real x183 = x89 * cosine[3] + sine[3] * x174;
  const Real x187 = cosine[3] * x174 - x89 * sine[3];
  const Real x188 = v[3] - (0.9999999999932537 * x93 + 3.673205103346574e-06 * x94);
  // joint 2 "upper_arm_roll": placement, velocity and reference acceleration of its link
  const Real x143 = sine[2] * x118 + cosine[2] * x129;
  // joint 3 "elbow_pitch": placement, velocity and reference acceleration of its link
  const Real x220 = x143 + (x89 * x93 - x97) * 0.08;
  const Real x221 = (x89 * x94 - x114) * 0.08;
  const Real x222 = x221 - (0.9999999999932537 * x122 + 3.673205103346574e-06 * x125);
  const Real x199 = 3.673205103346574e-06 * x97 - 0.9999999999932537 * x114;
  const Real x214 = x111 * sine[3] + cosine[3] * x193 + v[3] * x183;
  const Real x246 = x188 * x188;
  const Real x249 = x183 * x187;
  const Real x211 = x111 * cosine[3] - sine[3] * x193 + v[3] * x187;
  const Real x216 = (x93 * x93 + x94 * x94) * 0.08;
  const Real x218 = sine[2] * x129 - cosine[2] * x118 - x216;
  const Real x226 = 0.9999999999932537 * x222 - 3.673205103346574e-06 * x220;
  // joint 4 "forearm_roll": placement, velocity and reference acceleration of its link
  const Real x273 = 3.673205103346574e-06 * x187 + 0.9999999999932537 * x188;
  const Real x294 = 3.673205103346574e-06 * x214 - 0.9999999999932537 * x199;
  const Real x282 = x183 * cosine[4] - sine[4] * x273;
  const Real x321 = (x183 * x183 + x246) * 0.38;
  // joint 3 "elbow_pitch": placement, velocity and reference acceleration of its link
  const Real x231 = 0.9999999999932537 * x220 + 3.673205103346574e-06 * x222;
  // joint 8 "right_finger_slide": assembly: its two sides become one chain
  const Real x1626 = w.x[18] = 328.3972582458297 - x1360 * x1466 - x1418 * x1472;
  const Real x1343 = 47.81116318204386 * x1149 - x950 + x1166 * 300.897586242875;
  const Real x1344 = w.x[19] = x1189 * 0.0008033816505865777 + x1343;
  const Real x1394 = 0.9999999999964793 * x943 + 2.65358979335273e-06 * x949 + 47.81116318204386 * x1150;
  const Real x1396 = x1394 - x1167 * 300.897586242875 + x1190 * 0.0008033816505865777;
  const Real x1397 = w.x[20] = x1396 - x1211 * x1344;
  const Real x1464 = x1210 * x1344;
  const Real x1470 = x1225 * x1397;
  // joint 7 "left_finger_slide": assembly: its two sides become one chain
  const Real x2001 = 300000.3000003 + x1626;
  require_more(w, x2001, 4.265036626975881e-09, kGrowth, 7);
  require_more(w, x2001, 0.0, kFactorization, 7);
  const Real x2043 = w.x[21] = 1 / x2001;
  // joint 4 "forearm_roll": placement, velocity and reference acceleration of its link
  const Real x287 = x183 * sine[4] + cosine[4] * x273;
  const Real x289 = 0.9999999999932537 * x187 - 3.673205103346574e-06 * x188 + v[4];
  // joint 3 "elbow_pitch": placement, velocity and reference acceleration of its link
  const Real x239 = cosine[3] * x226 - sine[3] * x218;
  // joint 4 "forearm_roll": placement, velocity and reference acceleration of its link
  const Real x325 = x239 - (0.08 * (x199 + x249) + x321);
  const Real x329 = x231 + 0.08 * (x214 + x183 * x188);
  const Real x331 = (x211 + x187 * x188) * 0.38 - x329;
  const Real x299 = 0.9999999999932537 * x214 + 3.673205103346574e-06 * x199;
  const Real x313 = cosine[4] * x294 - x211 * sine[4] - v[4] * x282;
  const Real x314 = 0.08 * (x187 * x187 + x246);
  // joint 3 "elbow_pitch": placement, velocity and reference acceleration of its link
  const Real x235 = cosine[3] * x218 + sine[3] * x226;
  // joint 4 "forearm_roll": placement, velocity and reference acceleration of its link
  const Real x318 = x314 + (x249 - x199) * 0.38 + x235;
  const Real x336 = 3.673205103346574e-06 * x325 + 0.9999999999932537 * x331;
  const Real x310 = x211 * cosine[4] + sine[4] * x294 - v[4] * x287;
  const Real x341 = 0.9999999999932537 * x325 - 3.673205103346574e-06 * x331;
  const Real x350 = sine[4] * x318 + cosine[4] * x336;
  // joint 5 "wrist_pitch": placement, velocity and reference acceleration of its link
  const Real x387 = 3.673205103346574e-06 * x287 + 0.9999999999932537 * x289;
  const Real x405 = 3.673205103346574e-06 * x313 + 0.9999999999932537 * x299;
  const Real x395 = x282 * cosine[5] + sine[5] * x387;
  const Real x399 = cosine[5] * x387 - x282 * sine[5];
  const Real x400 = 0.9999999999932537 * x287 - 3.673205103346574e-06 * x289 + v[5];
  // joint 8 "right_finger_slide": assembly: its two sides become one chain
  const Real x1516 = w.x[22] = -47.52050645167994 - x1344 * x1466 - x1397 * x1472;
  const Real x1351 = w.x[23] = x956 - x1166 * 0.0017850200414291078 + x1189 * 672.6812282343863;
  const Real x1490 = 299.3961237250212 - x1344 * x1464 - x1397 * x1470;
  const Real x1405 = -27.77777777767998 + x1167 * 0.0017850200414291078 + x1190 * 672.6812282343863;
  const Real x1406 = w.x[24] = x1405 - x1211 * x1351;
  const Real x1465 = x1210 * x1351;
  const Real x1385 = w.x[25] = x1004 - x1166 * 1.5120169762693617e-05 + x1189 * 5.69800569798539;
  const Real x1471 = x1225 * x1406;
  const Real x1576 = w.x[26] = 5.221991839953887e-25 - x1351 * x1466 - x1406 * x1472;
  const Real x1447 = -0.2352941176462304 + x1167 * 1.5120169762693617e-05 + x1190 * 5.69800569798539;
  const Real x1448 = w.x[27] = x1447 - x1211 * x1385;
  const Real x1469 = x1210 * x1385;
  // joint 7 "left_finger_slide": assembly: its two sides become one chain
  const Real x2044 = w.x[28] = x1516 * x2043;
  const Real x2003 = w.x[29] = 59999.880000239995 + x1490;
  require_more(w, x2003, 8.544255267675666e-10, kGrowth, 7);
  const Real x2048 = x1516 * x2044;
  const Real x2050 = w.x[30] = x2003 - x2048;
  const Real x2060 = w.x[31] = 1 / x2050;
  // joint 4 "forearm_roll": placement, velocity and reference acceleration of its link
  const Real x345 = cosine[4] * x318 - sine[4] * x336;
  // joint 5 "wrist_pitch": placement, velocity and reference acceleration of its link
  const Real x411 = 3.673205103346574e-06 * x299 - 0.9999999999932537 * x313;
  const Real x426 = x310 * sine[5] + cosine[5] * x405 + v[5] * x395;
  const Real x431 = 3.673205103346574e-06 * x350 + 0.9999999999932537 * x341;
  const Real x452 = x395 * x399;
  const Real x462 = x395 * x400;
  const Real x454 = x411 + x452;
  const Real x463 = x426 + x462;
  const Real x436 = 0.9999999999932537 * x350 - 3.673205103346574e-06 * x341;
  const Real x443 = cosine[5] * x431 - x345 * sine[5];
  const Real x449 = x400 * x400;
  const Real x423 = x310 * cosine[5] - sine[5] * x405 + v[5] * x399;
  const Real x450 = x399 * x399 + x449;
  const Real x439 = x345 * cosine[5] + sine[5] * x431;
  // joint 6 "flange_roll": placement, velocity and reference acceleration of its link
  const Real x474 = 0.9999999999932537 * x400 - 3.673205103346574e-06 * x399;
  const Real x483 = x395 * cosine[6] + sine[6] * x474;
  const Real x487 = cosine[6] * x474 - x395 * sine[6];
  const Real x488 = v[6] - (0.9999999999932537 * x399 + 3.673205103346574e-06 * x400);
  const Real x492 = 3.673205103346574e-06 * x426 + 0.9999999999932537 * x411;
  const Real x514 = x443 + x454 * 0.09;
  const Real x516 = x436 + x463 * 0.09;
  const Real x497 = 0.9999999999932537 * x426 - 3.673205103346574e-06 * x411;
  // joint 8 "right_finger_slide": assembly: its two sides become one chain
  const Real x1366 = -0.5054466230936819 - x585 * 59.67078189300412 + x1166 * 0.00015834177779265263;
  const Real x1367 = w.x[32] = x1366 - x1189 * 59.670781892791446;
  const Real x1501 = -3.290040935476213e-24 - x1344 * x1465 - x1397 * x1471;
  const Real x1475 = x1225 * x1448;
  const Real x1565 = 665.2231611029742 - x1351 * x1465 - x1406 * x1471;
  const Real x1426 = 1.2875816993418725 - x1167 * 0.00015834177779265263 - x1190 * 59.670781892791446;
  const Real x1427 = w.x[33] = x1426 - x1211 * x1367;
  const Real x1467 = x1210 * x1367;
  const Real x1553 = -2.786858204168086e-26 - x1344 * x1469 - x1397 * x1475;
  const Real x1663 = w.x[34] = 4.423334264431528e-27 - x1360 * x1469 - x1418 * x1475;
  const Real x1473 = x1225 * x1427;
  const Real x1611 = 5.634831482284017 - x1351 * x1469 - x1406 * x1475;
  const Real x1736 = 1.224200925496994 - x1385 * x1469 - x1448 * x1475;
  // joint 7 "left_finger_slide": assembly: its two sides become one chain
  const Real x2045 = w.x[35] = x1576 * x2043;
  const Real x2053 = w.x[36] = x1501 - x1576 * x2044;
  const Real x2006 = w.x[37] = 59999.880000239995 + x1565;
  require_more(w, x2006, 8.544255267675666e-10, kGrowth, 7);
  const Real x2061 = w.x[38] = x2053 * x2060;
  const Real x2064 = x1576 * x2045;
  const Real x1921 = q[7] * x1516;
  const Real x2066 = x2053 * x2061;
  const Real x1932 = x1553 + q[7] * x1490;
  const Real x1952 = x1663 + x1921;
  const Real x2069 = w.x[39] = x2006 - x2064 - x2066;
  // joint 6 "flange_roll": placement, velocity and reference acceleration of its link
  const Real x538 = x483 * x483;
  const Real x539 = x487 * x487;
  const Real x540 = x488 * x488;
  const Real x543 = x483 * x487;
  const Real x512 = x439 - x450 * 0.09;
  const Real x520 = 0.9999999999932537 * x516 - 3.673205103346574e-06 * x514;
  const Real x541 = x539 + x540;
  const Real x544 = x543 - x497;
  const Real x545 = x497 + x543;
  const Real x546 = x538 + x540;
  const Real x506 = x423 * cosine[6] + sine[6] * x492 + v[6] * x487;
  const Real x509 = cosine[6] * x492 - x423 * sine[6] - v[6] * x483;
  const Real x548 = x487 * x488;
  const Real x551 = x538 + x539;
  const Real x553 = x483 * x488;
  const Real x525 = 0.9999999999932537 * x514 + 3.673205103346574e-06 * x516;
  const Real x529 = cosine[6] * x512 + sine[6] * x520;
  const Real x533 = cosine[6] * x520 - sine[6] * x512;
  const Real x549 = x548 - x506;
  const Real x554 = x553 - x509;
  const Real x555 = x509 + x553;
  const Real x550 = x506 + x548;
  // joint 7 "left_finger_slide": placement, velocity and reference acceleration of its link
  const Real x560 = x555 * 0.13;
  // joint 8 "right_finger_slide": placement, velocity and reference acceleration of its link
  const Real x593 = x487 * 2.65358979335273e-06 - x483 * 0.9999999999964793;
  const Real x598 = x483 * 2.65358979335273e-06 + x487 * 0.9999999999964793;
  const Real x650 = x593 * x593;
  // joint 8 "right_finger_slide": assembly: its two sides become one chain
  const Real x1637 = w.x[40] = -4.632213938029683e-26 - x1360 * x1467 - x1418 * x1473;
  const Real x1527 = 2.918459841587135e-25 - x1344 * x1467 - x1397 * x1473;
  const Real x1588 = -59.009207467252075 - x1351 * x1467 - x1406 * x1473;
  const Real x1675 = 6.410934403565655 - x1367 * x1467 - x1427 * x1473;
  const Real x1698 = -0.4998426985461352 - x1367 * x1469 - x1427 * x1475;
  // joint 7 "left_finger_slide": assembly: its two sides become one chain
  const Real x2082 = w.x[41] = 1 / x2069;
  const Real x1942 = x1611 + q[7] * x1501;
  const Real x1999 = x1736 + q[7] * x1553;
  const Real x2056 = -599.9988000024 + x1932 - x1952 * x2044;
  const Real x2046 = w.x[42] = x1952 * x2043;
  const Real x1948 = x1637 - q[7] * x1626 + 0.13 * x1576;
  const Real x2008 = w.x[43] = q[7] * x1932 + x1999 + 25.999988000024;
  require_more(w, x2008, 3.862007046714566e-13, kGrowth, 7);
  const Real x2062 = w.x[44] = x2056 * x2060;
  const Real x2075 = x1942 - x1952 * x2045 - x2056 * x2061;
  const Real x1923 = 0.13 * x1501;
  const Real x2002 = 3000.003000003 + x1948;
  const Real x2083 = w.x[45] = x2075 * x2082;
  // joint 7 "left_finger_slide": placement, velocity and reference acceleration of its link
  const Real x565 = x549 * 0.13;
  const Real x571 = x525 + x551 * 0.13;
  const Real x574 = 2.0 * x488;
  // joint 8 "right_finger_slide": placement, velocity and reference acceleration of its link
  const Real x653 = x650 + x598 * x598;
  const Real x665 = x540 + x650;
  const Real x616 = x541 * x585 - x544 * x588 + x529 + x560;
  const Real x623 = x546 * x588 - x545 * x585 + x533 + x565;
  const Real x667 = x488 * x598;
  const Real x603 = x509 * 2.65358979335273e-06 - x506 * 0.9999999999964793;
  const Real x608 = x506 * 2.65358979335273e-06 + x509 * 0.9999999999964793;
  const Real x655 = x488 * x593;
  const Real x660 = x593 * x598;
  const Real x630 = x571 + x554 * x585 + x550 * x588;
  const Real x646 = v[8] * (2.0 * x593) - x630;
  const Real x657 = x655 - x608;
  const Real x662 = x497 + x660;
  const Real x640 = 2.65358979335273e-06 * x616 + 0.9999999999964793 * x623;
  const Real x649 = 2.65358979335273e-06 * x623 - 0.9999999999964793 * x616 - x574 * v[8];
  // link 7 "hand": acceleration where nothing acts on it
  const Real x710 = x553 * 0.006916 - 0.00014399999999999992 * (x541 - x551);
  // link 9 "right_finger": acceleration where nothing acts on it
  const Real x829 = x497 * 8.33333e-06;
  // joint 7 "left_finger_slide": assembly: its two sides become one chain
  const Real x1926 = x1527 - x1921 + x1923;
  const Real x1938 = x1588 - q[7] * x1576 + 0.13 * x1565;
  const Real x1962 = x1675 - q[7] * x1637 + 0.13 * x1588;
  const Real x1981 = x1698 - q[7] * x1663 + 0.13 * x1611;
  const Real x2059 = x1926 - x2002 * x2044;
  const Real x2092 = x2008 - x1952 * x2046 - x2056 * x2062;
  const Real x2093 = w.x[46] = x2092 - x2075 * x2083;
  const Real x2103 = w.x[47] = 1 / x2093;
  const Real x2047 = w.x[48] = x2002 * x2043;
  const Real x2081 = -1799.9964000071998 + x1938 - x2002 * x2045 - x2059 * x2061;
  // link 7 "hand": acceleration where nothing acts on it
  const Real x703 = x506 * 0.01009033 - (x548 * 0.00506167 + x545 * 0.00014399999999999992);
  const Real x724 = x703 - x533 * 0.0754;
  const Real x728 = x509 * 0.008236 + x710 + x525 * 0.007199999999999999;
  const Real x729 = x529 * 0.0754 + x728;
  const Real x721 = x497 * 0.00317433 - x543 * 0.0018543300000000004 + x549 * 0.00014399999999999992;
  const Real x731 = x721 + x533 * 0.007199999999999999;
  const Real x750 = x554 * 0.007199999999999999 - (x525 * 0.85 + x551 * 0.0754);
  const Real x737 = x555 * 0.0754 - x541 * 0.007199999999999999 + x529 * 0.85;
  const Real x742 = x545 * 0.007199999999999999 + x549 * 0.0754 + x533 * 0.85;
  const Real x769 = x724 * 300.9051975855012 - x731 * 47.81116318204386 + x742 * 27.097049732773534;
  const Real x776 = x729 * 672.6812282367838 + x750 * 5.698005698005698 - x737 * 59.67078189300412;
  const Real x784 = x731 * 328.7950427750268 - x724 * 47.81116318204386 - x742 * 7.026218837536823;
  const Real x793 = x737 * 6.46961994674413 - (x729 * 59.67078189300412 + x750 * 0.5054466230936819);
  const Real x799 = x724 * 27.097049732773534 - x731 * 7.026218837536823 + x742 * 3.639654500566341;
  // link 9 "right_finger": acceleration where nothing acts on it
  const Real x846 = x667 * 5.333337e-05 - 1.5e-05 * (x653 - x665);
  const Real x837 = x829 + x660 * 5e-06 - x657 * 1.5e-05;
  const Real x859 = x837 - x649 * 0.0005;
  const Real x863 = x603 * 6.66667e-05 + x846 + x646 * 0.0005;
  const Real x864 = w.x[49] = x640 * 0.0015 + x863;
  const Real x871 = (x603 - x667) * 0.0005 - x653 * 0.0015;
  const Real x872 = w.x[50] = x646 * 0.05 + x871;
  const Real x878 = x657 * 0.0015 - x662 * 0.0005 + x649 * 0.05;
  const Real x885 = (x603 + x667) * 0.0015 + x665 * 0.0005;
  const Real x887 = w.x[51] = x640 * 0.05 + x885;
  // joint 7 "left_finger_slide": assembly: its two sides become one chain
  const Real x2010 = w.x[52] = x1962 - q[7] * x1948 + 0.13 * x1938 + 103.99992200024599;
  require_more(w, x2010, 1.4946464345439562e-12, kGrowth, 7);
  const Real x2063 = w.x[53] = x2059 * x2060;
  const Real x2100 = q[7] * x1926 + x1981 - x2002 * x2046;
  const Real x2084 = w.x[54] = x2081 * x2082;
  const Real x2102 = x2100 - x2059 * x2062 - x2081 * x2083;
  const Real x2161 = w.x[55] = x1490 - x2048;
  const Real x2104 = w.x[56] = x2102 * x2103;
  const Real x2114 = x2010 - x2002 * x2047 - x2059 * x2063;
  const Real x2179 = w.x[57] = x1501 - x1516 * x2045 - x2061 * x2161;
  // link 7 "hand": acceleration where nothing acts on it
  const Real x805 = x729 * 5.698005698005698 + x750 * 1.2247360482654601 - x737 * 0.5054466230936819;
  // link 9 "right_finger": acceleration where nothing acts on it
  const Real x856 = x655 * 5.833337e-05 - x662 * 1.5e-05 - x608 * 6.16667e-05;
  const Real x866 = x856 + x649 * 0.0015;
  // joint 8 "right_finger_slide": assembly: its two sides become one chain
  const Real x1024 = w.x[58] = 2.65358979335273e-06 * x957 + 0.9999999999964793 * x962;
  const Real x1076 = w.x[59] = x1032 - 27.77777777777778 + 1799.9964000071998;
  const Real x1129 = tau[8] * x1024;
  const Real x1089 = w.x[60] = x793 + x588 * x784 + 0.13 * x776;
  const Real x1096 = w.x[61] = 0.13 * x769 - x799 + x585 * x784;
  // link 9 "right_finger": acceleration where nothing acts on it
  const Real x909 = x864 * 59999.880000239995 - x872 * 599.9988000024 - x887 * 1799.9964000071998;
  // joint 8 "right_finger_slide": assembly: its two sides become one chain
  const Real x1136 = w.x[62] = x859 * 300000.3000003 + x878 * 3000.003000003 - x784 + x1129;
  const Real x1080 = w.x[63] = 0.9999999999964793 * x998 - 2.65358979335273e-06 * x986 + -17.999964000071998;
  // link 9 "right_finger": acceleration where nothing acts on it
  const Real x913 = x866 * 59999.880000239995 - x878 * 1799.9964000071998;
  // joint 8 "right_finger_slide": assembly: its two sides become one chain
  const Real x1124 = 0.9999999999964793 * x769 - 2.65358979335273e-06 * x776 + x909;
  const Real x1377 = 7.026218837536823 * x1149 - x588 * 27.097049732773534 + x1166 * 27.095931187385858;
  const Real x1378 = w.x[64] = x1189 * 7.234479409858621e-05 + x1377;
  const Real x1436 = 0.9999999999964793 * x971 + 2.65358979335273e-06 * x995 + 7.026218837536823 * x1150;
  const Real x1068 = w.x[65] = 0.9999999999964793 * x1065 - x978;
  // link 9 "right_finger": acceleration where nothing acts on it
  const Real x921 = x872 * 25.999988000024 - x864 * 599.9988000024 + x887 * 17.999964000071998;
  // joint 8 "right_finger_slide": assembly: its two sides become one chain
  const Real x1125 = 2.65358979335273e-06 * x769 + 0.9999999999964793 * x776 + x913;
  const Real x1233 = w.x[66] = x1124 - tau[8] * x1076 - x1136 * 0.00015919590865819434;
  // joint 7 "left_finger_slide": assembly: its two sides become one chain
  const Real x2116 = w.x[67] = x2114 - x2081 * x2084 - x2102 * x2104;
  const Real x2117 = w.x[68] = 1 / x2116;
  const Real x2213 = x1932 - x1516 * x2046 - x2062 * x2161;
  const Real x2214 = w.x[69] = x2213 - x2083 * x2179;
  const Real x2336 = x2060 * x2161;
  const Real x2269 = x1926 - x1516 * x2047 - x2063 * x2161;
  const Real x2341 = x2082 * x2179;
  const Real x2271 = w.x[70] = x2269 - x2084 * x2179 - x2104 * x2214;
  const Real x2347 = x2103 * x2214;
  // link 9 "right_finger": acceleration where nothing acts on it
  const Real x927 = x859 * 3000.003000003 - x866 * 1799.9964000071998 + x878 * 103.99992200024599;
  // joint 8 "right_finger_slide": assembly: its two sides become one chain
  const Real x1126 = x588 * x769 - (x805 + x585 * x776) + x921;
  const Real x1438 = x1436 - x1167 * 27.095931187385858 + x1190 * 7.234479409858621e-05;
  const Real x1439 = w.x[71] = x1438 - x1211 * x1378;
  const Real x1468 = x1210 * x1378;
  const Real x1127 = 0.9999999999964793 * x1089 + 2.65358979335273e-06 * x1096 + x927;
  const Real x1238 = x1125 - tau[8] * x1036 - x1136 * 4.2244063836038523e-10;
  const Real x1239 = w.x[72] = 1.63606725685963e-08 * x1233 + x1238;
  const Real x1474 = x1225 * x1439;
  const Real x1246 = x1126 - tau[8] * x1080 - x1136 * x1149;
  const Real x1248 = w.x[73] = x1246 - x1166 * x1233 - x1189 * x1239;
  const Real x1257 = x1127 - tau[8] * x1068 - x1136 * x1150;
  const Real x1652 = w.x[74] = -6.997066406854872 - x1360 * x1468 - x1418 * x1474;
  const Real x1542 = 26.96072397096317 - x1344 * x1468 - x1397 * x1474;
  // joint 7 "left_finger_slide": assembly: its two sides become one chain
  const Real x2181 = w.x[75] = x1565 - x2064 - x2066;
  const Real x2353 = x2117 * x2271;
  const Real x2368 = x2161 - x2161 * x2336 - x2179 * x2341;
  const Real x2222 = x1942 - x1576 * x2046 - x2053 * x2062;
  const Real x2223 = w.x[76] = x2222 - x2083 * x2181;
  const Real x2167 = w.x[77] = x1527 - x1637 * x2044;
  const Real x2281 = x1938 - x1576 * x2047 - x2053 * x2063;
  const Real x2342 = x2082 * x2181;
  const Real x2283 = w.x[78] = x2281 - x2084 * x2181 - x2104 * x2223;
  const Real x2348 = x2103 * x2223;
  const Real x2193 = w.x[79] = x1588 - x1637 * x2045 - x2061 * x2167;
  const Real x2354 = x2117 * x2283;
  // joint 6 "flange_roll": assembly: its two sides become one chain
  const Real x2924 = x2368 - x2214 * x2347 - x2271 * x2353 + 769.2307692307693;
  require_more(w, x2924, 7.919928947270557e-12, kGrowth, 6);
  require_more(w, x2924, 0.0, kFactorization, 6);
  const Real x3004 = w.x[80] = 1 / x2924;
  // joint 7 "left_finger_slide": placement, velocity and reference acceleration of its link
  const Real x567 = x533 - x546 * q[7] + x565;
  const Real x576 = x550 * q[7] - x571 + 2.0 * x483 * v[7];
  const Real x579 = x529 + x544 * q[7] + x560 - v[7] * x574;
  // joint 8 "right_finger_slide": assembly: its two sides become one chain
  const Real x1259 = x1167 * x1233 + x1257 - x1190 * x1239;
  const Real x1260 = w.x[81] = x1259 - x1211 * x1248;
  const Real x1599 = -2.96269318423145e-25 - x1351 * x1468 - x1406 * x1474;
  const Real x1686 = 2.628083130482957e-26 - x1367 * x1468 - x1427 * x1474;
  const Real x1724 = -2.5095754031136986e-27 - x1378 * x1469 - x1439 * x1475;
  const Real x1778 = x1136 * 0.0010947825175841488 + x1233 * 0.0007920100248753914 + x1239 * 2.101669718249871e-09;
  const Real x1269 = w.x[82] = x1026 - 0.9999999999964793 * x949;
  const Real x1759 = x1136 * 0.00015919590865875482 + x1233 * 0.004989945375270026 + x1239 * 1.3241268117251393e-08;
  // link 8 "left_finger": acceleration where nothing acts on it
  const Real x1845 = x548 * 5.333337e-05 + (x551 - x546) * 1.5e-05;
  const Real x1839 = x829 - x543 * 5e-06 - x555 * 1.5e-05;
  const Real x1856 = x1839 - x579 * 0.0005;
  const Real x1869 = w.x[83] = x550 * 0.0005 - x551 * 0.0015 + x576 * 0.05;
  const Real x1874 = x555 * 0.0015 + x544 * 0.0005 + x579 * 0.05;
  const Real x1880 = w.x[84] = x549 * 0.0015 - x546 * 0.0005 + x567 * 0.05;
  // joint 7 "left_finger_slide": assembly: its two sides become one chain
  const Real x2239 = x1698 + q[7] * x1527 - x1637 * x2046;
  const Real x2333 = x1637 * x2043;
  const Real x2170 = w.x[85] = x1542 - x1652 * x2044;
  const Real x2241 = w.x[86] = x2239 - x2062 * x2167 - x2083 * x2193;
  const Real x2338 = x2060 * x2167;
  const Real x2378 = x2179 - x2179 * x2342 - x2214 * x2348;
  const Real x2379 = x2378 - x2271 * x2354;
  const Real x2305 = x1962 - x1637 * x2047 - x2063 * x2167;
  const Real x2344 = x2082 * x2193;
  const Real x1972 = x1686 - q[7] * x1652 + 0.13 * x1599;
  // joint 8 "right_finger_slide": assembly: its two sides become one chain
  const Real x1770 = x1233 * 2.9601940685904722e-08 - x1239 * 0.011087074859115907 + x1248 * x1465;
  const Real x1788 = x1239 * 0.0009834887580909876 - x1233 * 2.6258662679026073e-09 + x1248 * x1467;
  const Real x1814 = x1233 * 2.507458505158988e-10 - x1239 * 9.39140458654524e-05 + x1248 * x1469;
  const Real x1762 = x1248 * x1464 - x1759 + x1260 * x1470;
  const Real x1818 = x1248 * x1466 + x1778 + x1260 * x1472 - x1129;
  const Real x1826 = w.x[87] = x784 + x1818;
  const Real x1822 = w.x[88] = tau[8] * x1269 + x1762 + x769;
  // link 8 "left_finger": acceleration where nothing acts on it
  const Real x1860 = x506 * 6.66667e-05 - x1845 + x576 * 0.0005;
  const Real x1861 = w.x[89] = x1860 - x567 * 0.0015;
  const Real x1853 = x553 * 5.833337e-05 + x544 * 1.5e-05 + x509 * 6.16667e-05;
  const Real x1863 = x1853 + x579 * 0.0015;
  // joint 7 "left_finger_slide": assembly: its two sides become one chain
  const Real x2199 = w.x[90] = x1599 - x1652 * x2045 - x2061 * x2170;
  const Real x2447 = x2181 - x2181 * x2342 - x2223 * x2348;
  const Real x2307 = w.x[91] = x2305 - x2084 * x2193 - x2104 * x2241;
  const Real x2350 = x2103 * x2241;
  const Real x2248 = x1724 + q[7] * x1542 - x1652 * x2046;
  const Real x2334 = x1652 * x2043;
  const Real x2356 = x2117 * x2307;
  const Real x2406 = x1527 - x1516 * x2333 - x2161 * x2338;
  const Real x2475 = x1588 - x1576 * x2333 - x2053 * x2338;
  const Real x1929 = w.x[92] = x1542 - 0.13 * x1490;
  const Real x1951 = w.x[93] = x1652 - 0.13 * x1516;
  const Real x2250 = w.x[94] = x2248 - x2062 * x2170 - x2083 * x2199;
  const Real x2339 = x2060 * x2170;
  const Real x2173 = w.x[95] = x1553 - x1663 * x2044;
  const Real x1993 = w.x[96] = x1724 - 0.13 * x1553;
  const Real x2005 = w.x[97] = 1799.9964000071998 + x1929;
  const Real x2031 = w.x[98] = tau[7] * x1951;
  const Real x2317 = x1972 - x1652 * x2047 - x2063 * x2170;
  const Real x2345 = x2082 * x2199;
  const Real x2408 = x2406 - x2179 * x2344 - x2214 * x2350;
  const Real x2409 = x2408 - x2271 * x2356;
  const Real x2477 = x2475 - x2181 * x2344 - x2223 * x2350;
  // joint 6 "flange_roll": assembly: its two sides become one chain
  const Real x3005 = w.x[99] = x2379 * x3004;
  const Real x2927 = w.x[100] = x2447 - x2283 * x2354 + 769.2307692307693;
  require_more(w, x2927, 1.3203184105450422e-11, kGrowth, 6);
  const Real x3011 = w.x[101] = x2927 - x2379 * x3005;
  const Real x3021 = w.x[102] = 1 / x3011;
  // joint 5 "wrist_pitch": placement, velocity and reference acceleration of its link
  const Real x455 = x395 * x395 + x449;
  const Real x457 = x399 * x400;
  const Real x459 = x423 + x457;
  // joint 8 "right_finger_slide": assembly: its two sides become one chain
  const Real x1824 = x1260 * x1471 + x1770 - tau[8] * 7.371082759313139e-05 + x776;
  const Real x1828 = x1260 * x1473 + x1788 + tau[8] * 3.4167136554933856e-06 + x793;
  const Real x1832 = x1260 * x1475 + x1814 - tau[8] * 6.243740690241717e-07 + x805;
  const Real x1713 = 3.6273146653411508 - x1378 * x1468 - x1439 * x1474;
  // joint 7 "left_finger_slide": assembly: its two sides become one chain
  const Real x2580 = x1675 - x1637 * x2333 - x2167 * x2338;
  const Real x1939 = w.x[103] = x1599 - x1923;
  // link 8 "left_finger": acceleration where nothing acts on it
  const Real x1889 = 1799.9964000071998 * x1880 - 599.9988000024 * x1869 + 59999.880000239995 * x1861;
  // joint 7 "left_finger_slide": assembly: its two sides become one chain
  const Real x2037 = w.x[104] = 300000.3000003 * x1856 + 3000.003000003 * x1874 - x1826 - x2031;
  const Real x2319 = w.x[105] = x2317 - x2084 * x2199 - x2104 * x2250;
  const Real x2351 = x2103 * x2250;
  const Real x2205 = w.x[106] = x1611 - x1663 * x2045 - x2061 * x2173;
  const Real x2009 = w.x[107] = q[7] * x1929 + x1993 + -17.999964000071998;
  const Real x2033 = tau[7] * x1939;
  const Real x2122 = x2037 * x2044;
  const Real x2357 = x2117 * x2319;
  const Real x2421 = x1542 - x1516 * x2334 - x2161 * x2339;
  const Real x2335 = x1663 * x2043;
  const Real x2582 = x2580 - x2193 * x2344 - x2241 * x2350;
  const Real x1973 = w.x[108] = x1972 - 0.13 * x1926;
  // link 8 "left_finger": acceleration where nothing acts on it
  const Real x1900 = 25.999988000024 * x1869 - 17.999964000071998 * x1880 - 599.9988000024 * x1861;
  // joint 7 "left_finger_slide": assembly: its two sides become one chain
  const Real x2124 = w.x[109] = x1889 - x1822 - tau[7] * x2005 - x2122;
  const Real x2125 = x2037 * x2045;
  const Real x2258 = x1999 - x1663 * x2046 - x2062 * x2173;
  const Real x2259 = w.x[110] = x2258 - x2083 * x2205;
  const Real x2340 = x2060 * x2173;
  // link 8 "left_finger": acceleration where nothing acts on it
  const Real x1906 = 3000.003000003 * x1856 - 1799.9964000071998 * x1863 + 103.99992200024599 * x1874;
  // joint 6 "flange_roll": assembly: its two sides become one chain
  const Real x2915 = cosine[6] * 1.9230769230758853 + 2.0 * sine[6] * 1.4127711935948361e-06;
  const Real x2920 = cosine[6] * x2915;
  const Real x3006 = w.x[111] = x2409 * x3004;
  const Real x3014 = x2477 - x2283 * x2356 + 7.692307692255798 - x2409 * x3005;
  const Real x2933 = w.x[112] = x2582 - x2307 * x2356 + (2.7692307692297313 - x2920);
  require_more(w, x2933, 1.028702558297553e-13, kGrowth, 6);
  const Real x3022 = w.x[113] = x3014 * x3021;
  // joint 7 "left_finger_slide": assembly: its two sides become one chain
  const Real x2127 = x2061 * x2124;
  const Real x2039 = 59999.880000239995 * x1863 - 1799.9964000071998 * x1874 - x1824 - x2033;
  const Real x2164 = w.x[114] = x1516 - x1626 * x2044;
  const Real x2423 = x2421 - x2179 * x2345 - x2214 * x2351;
  const Real x2490 = x1599 - x1576 * x2334 - x2053 * x2339;
  const Real x2595 = x1686 - x1637 * x2334 - x2167 * x2339;
  const Real x2329 = x1981 - x1663 * x2047 - x2063 * x2173;
  const Real x2346 = x2082 * x2205;
  const Real x2029 = q[7] * x1826 - x1828 - 0.13 * x1824 + x1906;
  const Real x2130 = w.x[115] = x2039 - x2125 - x2127;
  const Real x2040 = x1900 - (x1832 + q[7] * x1822) - tau[7] * x2009;
  const Real x2331 = w.x[116] = x2329 - x2084 * x2205 - x2104 * x2259;
  const Real x2352 = x2103 * x2259;
  const Real x2187 = w.x[117] = x1576 - x1626 * x2045 - x2061 * x2164;
  const Real x2492 = x2490 - x2181 * x2345 - x2223 * x2351;
  const Real x2597 = x2595 - x2193 * x2345 - x2241 * x2351;
  const Real x2625 = x1713 - x1652 * x2334 - x2170 * x2339;
  const Real x2358 = x2117 * x2331;
  const Real x2436 = x1553 - x1516 * x2335 - x2161 * x2340;
  const Real x2138 = x2040 - x2037 * x2046 - x2062 * x2124;
  const Real x2139 = w.x[118] = x2138 - x2083 * x2130;
  // link 6 "wrist": acceleration where nothing acts on it
  const Real x2772 = x411 * 0.00351 + x452 * 0.0019500000000000001;
  const Real x2789 = (x452 - x411) * 0.013000000000000001 - x450 * 0.052000000000000005;
  const Real x2790 = x439 * 1.3 + x2789;
  const Real x2796 = x454 * 0.052000000000000005 - x455 * 0.013000000000000001 + x443 * 1.3;
  // joint 6 "flange_roll": assembly: its two sides become one chain
  const Real x2925 = x2423 - x2271 * x2357 + -7.692307692255798;
  const Real x3030 = w.x[119] = x2933 - x2409 * x3006 - x3014 * x3022;
  const Real x3043 = w.x[120] = 1 / x3030;
  // joint 7 "left_finger_slide": assembly: its two sides become one chain
  const Real x2148 = x2029 - tau[7] * x1973 - x2037 * x2047;
  const Real x2332 = w.x[121] = x1626 * x2043;
  const Real x2505 = x1611 - x1576 * x2335 - x2053 * x2340;
  const Real x2231 = x1952 - x1626 * x2046 - x2062 * x2164;
  const Real x2232 = w.x[122] = x2231 - x2083 * x2187;
  const Real x2337 = w.x[123] = x2060 * x2164;
  const Real x2627 = x2625 - x2199 * x2345 - x2250 * x2351;
  const Real x2438 = x2436 - x2179 * x2346 - x2214 * x2352;
  const Real x2610 = x1698 - x1637 * x2335 - x2167 * x2340;
  const Real x2150 = x2148 - x2063 * x2124 - x2084 * x2130;
  const Real x2151 = w.x[124] = x2150 - x2104 * x2139;
  const Real x2293 = x1948 - x1626 * x2047 - x2063 * x2164;
  const Real x2343 = w.x[125] = x2082 * x2187;
  const Real x2507 = x2505 - x2181 * x2346 - x2223 * x2352;
  const Real x2640 = x1724 - x1652 * x2335 - x2170 * x2340;
  // link 6 "wrist": acceleration where nothing acts on it
  const Real x2753 = x423 * 0.0014299999999999998 + x457 * 0.00013000000000000002 + x463 * 0.0005200000000000001;
  const Real x2775 = x2753 + x436 * 0.013000000000000001;
  const Real x2764 = x426 * 0.00338 + x462 * 0.0020800000000000003 + x459 * 0.0005200000000000001;
  const Real x2778 = x2764 + x436 * 0.052000000000000005;
  const Real x2783 = x2772 - 0.0005200000000000001 * (x455 - x450) + x443 * 0.052000000000000005;
  const Real x2784 = x2783 - x439 * 0.013000000000000001;
  const Real x2801 = x436 * 1.3 + x463 * 0.052000000000000005 + x459 * 0.013000000000000001;
  const Real x2817 = w.x[126] = x2801 * 30.76923076923077 - x2778 * 769.2307692307693;
  const Real x2823 = w.x[127] = x2790 * 7.6923076923076925 - x2796 * 30.76923076923077 + x2784 * 769.2307692307693;
  // joint 6 "flange_roll": assembly: its two sides become one chain
  const Real x3017 = x2492 - x2283 * x2357 - x2925 * x3005;
  const Real x3007 = w.x[128] = x2925 * x3004;
  const Real x2934 = x2597 - x2307 * x2357 + (-1.4127711935948361e-06 + sine[6] * x2915);
  const Real x2876 = cosine[6] * 2.8255423871896722e-05 - sine[6] * 38.46153846153846;
  const Real x2936 = w.x[129] = x2627 - x2319 * x2357 + (0.8461538461538461 + x2920);
  require_more(w, x2936, 6.265402802508093e-14, kGrowth, 6);
  const Real x3023 = w.x[130] = x3017 * x3021;
  const Real x3036 = x2934 - x2925 * x3006 - x3017 * x3022;
  const Real x2881 = sine[6] * 2.8255423871896722e-05 + cosine[6] * 38.46153846153846;
  const Real x2926 = x2438 - x2271 * x2358 + x2876;
  // joint 8 "right_finger_slide": assembly: its two sides become one chain
  const Real x1293 = w.x[131] = 2.65358979335273e-06 * x971 - 0.9999999999964793 * x995;
  const Real x1803 = x1136 * 2.339506545820704e-05 + x1233 * 0.00044934629820525036 + x1239 * 1.1923807506025343e-09;
  // joint 7 "left_finger_slide": assembly: its two sides become one chain
  const Real x2295 = w.x[132] = x2293 - x2084 * x2187 - x2104 * x2232;
  const Real x2349 = w.x[133] = x2103 * x2232;
  const Real x2668 = x2122 + x2124 * x2336 + x2130 * x2341;
  const Real x2612 = x2610 - x2193 * x2346 - x2241 * x2352;
  const Real x2355 = w.x[134] = x2117 * x2295;
  const Real x2391 = x1516 - x1516 * x2332 - x2161 * x2337;
  const Real x2642 = x2640 - x2199 * x2346 - x2250 * x2352;
  const Real x2655 = x1736 - x1663 * x2335 - x2173 * x2340;
  const Real x2154 = w.x[135] = x1686 - 0.13 * x1527;
  const Real x2460 = x1576 - x1576 * x2332 - x2053 * x2337;
  const Real x2535 = x1637 - x1626 * x2333 - x2164 * x2338;
  const Real x2676 = x2125 + x2127 + x2130 * x2342 + x2139 * x2348;
  const Real x2693 = x2037 * x2333 + x2124 * x2338 + x2130 * x2344;
  const Real x2670 = x2139 * x2347 + x2668 + x2151 * x2353;
  // link 6 "wrist": acceleration where nothing acts on it
  const Real x2837 = 2.0 * x2796 - x2790 * 0.3076923076923077 - x2784 * 30.76923076923077;
  const Real x2845 = x2801 * 2.076923076923077 - (x2775 * 7.6923076923076925 + x2778 * 30.76923076923077);
  const Real x2813 = x2775 * 769.2307692307693 - x2801 * 7.6923076923076925;
  // joint 6 "flange_roll": assembly: its two sides become one chain
  const Real x3044 = w.x[136] = x3036 * x3043;
  const Real x2941 = x2837 + 0.09 * x2823;
  const Real x2945 = 0.09 * x2817 - x2845;
  const Real x2950 = 3.673205103346574e-06 * x2817 - 0.9999999999932537 * x2823;
  const Real x2901 = cosine[6] * 0.3846153846127899 + sine[6] * 2.825542387170617e-07;
  const Real x3020 = x2507 - x2283 * x2358 - x2881 - x2926 * x3005;
  // joint 8 "right_finger_slide": assembly: its two sides become one chain
  const Real x1806 = x1248 * x1468 - x1803 + x1260 * x1474;
  const Real x1830 = w.x[137] = tau[8] * x1293 + x1806 + x799;
  // joint 7 "left_finger_slide": assembly: its two sides become one chain
  const Real x1987 = w.x[138] = x1713 - 0.13 * x1542;
  const Real x2393 = x2391 - x2179 * x2343 - x2214 * x2349;
  const Real x2394 = w.x[139] = x2393 - x2271 * x2355;
  const Real x2550 = x1652 - x1626 * x2334 - x2164 * x2339;
  const Real x2702 = x2037 * x2334 + x2124 * x2339 + x2130 * x2345;
  const Real x2657 = x2655 - x2205 * x2346 - x2259 * x2352;
  const Real x2462 = x2460 - x2181 * x2343 - x2223 * x2349;
  const Real x2463 = w.x[140] = x2462 - x2283 * x2355;
  const Real x2537 = x2535 - x2187 * x2344 - x2232 * x2350;
  const Real x2711 = x2037 * x2335 + x2124 * x2340 + x2130 * x2346;
  const Real x2695 = x2139 * x2350 + x2693 + x2151 * x2356;
  const Real x2552 = x2550 - x2187 * x2345 - x2232 * x2351;
  const Real x2565 = x1663 - x1626 * x2335 - x2164 * x2340;
  const Real x2704 = x2139 * x2351 + x2702 + x2151 * x2357;
  // link 6 "wrist": acceleration where nothing acts on it
  const Real x2830 = x2790 * 0.8461538461538461 - x2796 * 0.3076923076923077 + x2784 * 7.6923076923076925;
  // joint 6 "flange_roll": assembly: its two sides become one chain
  const Real x3053 = x2936 - x2925 * x3007 - x3017 * x3023;
  const Real x3054 = w.x[141] = x3053 - x3036 * x3044;
  const Real x2907 = sine[6] * 0.3846153846127899 - cosine[6] * 2.825542387170617e-07;
  const Real x2967 = 3.673205103346574e-06 * x2941 + 0.9999999999932537 * x2945;
  const Real x3064 = w.x[142] = 1 / x3054;
  const Real x3138 = cosine[6] * 7.6923076923076925;
  const Real x3008 = w.x[143] = x2926 * x3004;
  const Real x3041 = x2612 - x2307 * x2358 - x2901 - x2926 * x3006;
  const Real x3042 = x3041 - x3020 * x3022;
  // joint 7 "left_finger_slide": assembly: its two sides become one chain
  const Real x2720 = tau[7] * x1929 + x2670 + x1822;
  // joint 6 "flange_roll": assembly: its two sides become one chain
  const Real x3116 = w.x[144] = sine[6] * 7.692307692255798;
  const Real x3123 = w.x[145] = sine[6] * 0.0028255423871896726;
  const Real x3135 = w.x[146] = sine[6] * 769.2307692255798;
  const Real x3142 = sine[6] * 7.6923076923076925;
  const Real x3161 = w.x[147] = sine[6] * 30.769230769023192;
  const Real x3179 = w.x[148] = x3138 + sine[6] * 0.00011302169548758689;
  const Real x2938 = w.x[149] = x2657 - x2331 * x2358 + 2.6923076923087303;
  require_more(w, x2938, 2.8335972750372623e-14, kGrowth, 6);
  const Real x3024 = w.x[150] = x3020 * x3021;
  const Real x3061 = x2642 - x2319 * x2358 + x2907 - x2926 * x3007;
  const Real x2931 = w.x[151] = x2537 - x2295 * x2356 - x2876;
  // joint 7 "left_finger_slide": assembly: its two sides become one chain
  const Real x2722 = x2151 * x2354 + x2676 + x2033 + x1824;
  // joint 6 "flange_roll": assembly: its two sides become one chain
  const Real x2981 = sine[6] * x2950 - cosine[6] * x2813 + x2720;
  const Real x2993 = w.x[152] = x2981 - x2394 * tau[6];
  const Real x3113 = w.x[153] = cosine[6] * 769.2307692307693;
  const Real x3118 = cosine[6] * 7.692307692255798;
  // joint 7 "left_finger_slide": assembly: its two sides become one chain
  const Real x2713 = x2139 * x2352 + x2711 + x2151 * x2358;
  const Real x2567 = x2565 - x2187 * x2346 - x2232 * x2352;
  const Real x2568 = w.x[154] = x2567 - x2295 * x2358;
  // joint 6 "flange_roll": assembly: its two sides become one chain
  const Real x3045 = w.x[155] = x3042 * x3043;
  const Real x3063 = x3061 - x3020 * x3023 - x3042 * x3044;
  const Real x2932 = w.x[156] = x2552 - x2295 * x2357 + x2881;
  // joint 7 "left_finger_slide": assembly: its two sides become one chain
  const Real x2726 = tau[7] * x2154 + x2695 + x1828;
  // joint 6 "flange_roll": assembly: its two sides become one chain
  const Real x2982 = sine[6] * x2813 + cosine[6] * x2950 + x2722;
  const Real x3197 = w.x[157] = x3005 * x3123 - cosine[6] * 0.0028255423871896726;
  const Real x3200 = w.x[158] = cosine[6] * 769.2307692255798 - x3005 * x3135;
  const Real x3203 = w.x[159] = x3118 - x3005 * x3116;
  const Real x3206 = w.x[160] = x3005 * x3161 - cosine[6] * 30.769230769023192;
  const Real x3209 = w.x[161] = x3142 - cosine[6] * 0.00011302169548758689 + x3005 * x3179;
  const Real x3065 = w.x[162] = x3063 * x3064;
  // joint 7 "left_finger_slide": assembly: its two sides become one chain
  const Real x2728 = tau[7] * x1987 + x2704 + x1830;
  // joint 6 "flange_roll": assembly: its two sides become one chain
  const Real x2984 = sine[6] * x2967 - cosine[6] * x2830 + x2726;
  const Real x3085 = w.x[163] = x2982 - x2463 * tau[6] - x2993 * x3005;
  const Real x3193 = w.x[164] = sine[6] * 769.2307692307693 + x3005 * x3113;
  const Real x3075 = x2938 - x2926 * x3008 - x3020 * x3024;
  // joint 7 "left_finger_slide": assembly: its two sides become one chain
  const Real x2730 = tau[7] * x1993 + x2713 + x1832;
  // joint 6 "flange_roll": assembly: its two sides become one chain
  const Real x2985 = sine[6] * x2830 + cosine[6] * x2967 + x2728;
  const Real x3222 = w.x[165] = x3006 * x3123 - sine[6] * 38.46153846127899 - x3022 * x3197;
  const Real x3227 = x3138 - sine[6] * 0.00014127711935948362 - x3006 * x3135;
  const Real x3228 = w.x[166] = x3227 - x3022 * x3200;
  const Real x3233 = cosine[6] * 0.8461538461538461 - sine[6] * 1.4127711935948361e-06 - x3006 * x3116;
  const Real x3234 = w.x[167] = x3233 - x3022 * x3203;
  const Real x3239 = sine[6] * 2.8255423871896723e-06 - cosine[6] * 0.3076923076923077 + x3006 * x3161;
  const Real x3240 = w.x[168] = x3239 - x3022 * x3206;
  const Real x3246 = w.x[169] = x3006 * x3179 - sine[6] * 0.6923076923030216 - x3022 * x3209;
  const Real x3077 = w.x[170] = x3075 - x3042 * x3045 - x3063 * x3065;
  const Real x2986 = 0.9999999999932537 * x2941 - 3.673205103346574e-06 * x2945 + x2730;
  const Real x3090 = x2984 - tau[6] * x2931 - x2993 * x3006;
  const Real x3091 = w.x[171] = x3090 - x3022 * x3085;
  const Real x3216 = w.x[172] = x3022 * x3193 - (x3116 + x3006 * x3113);
  const Real x3272 = x3142 + cosine[6] * 0.00014127711935948362 + x3007 * x3135;
  const Real x3284 = sine[6] * 0.8461538461538461 + cosine[6] * 1.4127711935948361e-06 + x3007 * x3116;
  const Real x3296 = sine[6] * 0.3076923076923077 + cosine[6] * 2.8255423871896723e-06 + x3007 * x3161;
  const Real x3078 = w.x[173] = 1 / x3077;
  const Real x3098 = x2985 - tau[6] * x2932 - x2993 * x3007;
  const Real x3264 = x3007 * x3123 - cosine[6] * 38.46153846127899 - x3023 * x3197;
  const Real x3265 = w.x[174] = x3264 - x3044 * x3222;
  const Real x3276 = w.x[175] = x3023 * x3200 + x3272 + x3044 * x3228;
  const Real x3288 = w.x[176] = x3023 * x3203 + x3284 + x3044 * x3234;
  const Real x3298 = w.x[177] = x3296 - x3023 * x3206 - x3044 * x3240;
  const Real x3306 = x3007 * x3179 - cosine[6] * 0.6923076923030216 - x3023 * x3209;
  const Real x3307 = w.x[178] = x3306 - x3044 * x3246;
  const Real x3381 = x3004 * x3123;
  const Real x3383 = x3004 * x3135;
  const Real x3384 = x3004 * x3116;
  const Real x3385 = x3004 * x3161;
  const Real x3387 = x3004 * x3179;
  const Real x3391 = x3021 * x3197;
  const Real x3392 = x3021 * x3200;
  const Real x3393 = x3021 * x3203;
  const Real x3394 = x3021 * x3206;
  const Real x3395 = x3021 * x3209;
  const Real x3100 = w.x[179] = x3098 - x3023 * x3085 - x3044 * x3091;
  const Real x3109 = x2986 - x2568 * tau[6] - x2993 * x3008;
  const Real x3255 = x3023 * x3193 - (x3118 + x3007 * x3113);
  const Real x3256 = w.x[180] = x3255 - x3044 * x3216;
  const Real x3329 = 0.00014127711935948362 + x3008 * x3123 - x3024 * x3197;
  const Real x3341 = -38.46153846127899 - x3008 * x3135 - x3024 * x3200;
  const Real x3353 = -0.3846153846127899 - x3008 * x3116 - x3024 * x3203;
  const Real x3365 = 0.7692307692255798 + x3008 * x3161 - x3024 * x3206;
  const Real x3377 = 2.5429881484707045e-06 + x3008 * x3179 - x3024 * x3209;
  const Real x3380 = x3004 * x3113;
  const Real x3389 = x3021 * x3193;
  const Real x3397 = x3043 * x3222;
  const Real x3398 = x3043 * x3228;
  const Real x3399 = x3043 * x3234;
  const Real x3400 = x3043 * x3240;
  const Real x3401 = x3043 * x3246;
  const Real x3317 = 2.8255423871896722e-05 - x3008 * x3113 + x3024 * x3193;
  const Real x3331 = w.x[181] = x3329 - x3045 * x3222 - x3065 * x3265;
  const Real x3343 = w.x[182] = x3341 - x3045 * x3228 + x3065 * x3276;
  const Real x3355 = w.x[183] = x3353 - x3045 * x3234 + x3065 * x3288;
  const Real x3367 = w.x[184] = x3365 - x3045 * x3240 - x3065 * x3298;
  const Real x3379 = w.x[185] = x3377 - x3045 * x3246 - x3065 * x3307;
  const Real x3396 = x3043 * x3216;
  const Real x3403 = x3064 * x3265;
  const Real x3404 = x3064 * x3276;
  const Real x3406 = x3064 * x3288;
  const Real x3408 = x3064 * x3298;
  const Real x3409 = x3064 * x3307;
  const Real x3111 = x3109 - x3024 * x3085 - x3045 * x3091;
  const Real x3112 = w.x[186] = x3111 - x3065 * x3100;
  const Real x3319 = w.x[187] = x3317 - x3045 * x3216 - x3065 * x3256;
  const Real x3402 = x3064 * x3256;
  const Real x3411 = x3078 * x3331;
  const Real x3412 = x3078 * x3343;
  const Real x3413 = x3078 * x3355;
  const Real x3414 = x3078 * x3367;
  const Real x3415 = x3078 * x3379;
  const Real x3410 = x3078 * x3319;
  const Real x3755 = x3085 * x3391 - x2993 * x3381 + x3091 * x3397;
  const Real x3765 = x2993 * x3383 + x3085 * x3392 + x3091 * x3398;
  const Real x3775 = x2993 * x3384 + x3085 * x3393 + x3091 * x3399;
  const Real x3785 = x3085 * x3394 - x2993 * x3385 + x3091 * x3400;
  const Real x3795 = x3085 * x3395 - x2993 * x3387 + x3091 * x3401;
  const Real x3427 = 769.2307692307693 - x3113 * x3380 - x3193 * x3389;
  const Real x3498 = -7.6923076923076925 + x3113 * x3387 + x3193 * x3395;
  const Real x3513 = 769.2307692307693 - x3123 * x3381 - x3197 * x3391;
  const Real x3574 = 30.76923076923077 - x3123 * x3387 - x3197 * x3395;
  const Real x3589 = 769.2307692307693 - x3135 * x3383 - x3200 * x3392;
  const Real x3604 = 7.6923076923076925 - x3135 * x3384 - x3200 * x3393;
  const Real x3619 = -30.76923076923077 + x3135 * x3385 - x3200 * x3394;
  const Real x3648 = 0.8461538461538461 - x3116 * x3384 - x3203 * x3393;
  const Real x3663 = -0.3076923076923077 + x3116 * x3385 - x3203 * x3394;
  const Real x3692 = 2.0 - x3161 * x3385 - x3206 * x3394;
  const Real x3725 = 2.076923076923077 - x3179 * x3387 - x3209 * x3395;
  const Real x3745 = x2993 * x3380 - x3085 * x3389 + x3091 * x3396;
  const Real x3442 = x3113 * x3381 + x3193 * x3391 - x3216 * x3397;
  const Real x3456 = x3193 * x3392 - x3113 * x3383 - x3216 * x3398;
  const Real x3470 = x3193 * x3393 - x3113 * x3384 - x3216 * x3399;
  const Real x3484 = x3113 * x3385 + x3193 * x3394 - x3216 * x3400;
  const Real x3528 = x3123 * x3383 - x3197 * x3392 - x3222 * x3398;
  const Real x3542 = x3123 * x3384 - x3197 * x3393 - x3222 * x3399;
  const Real x3557 = x3123 * x3385 + x3197 * x3394 + x3222 * x3400;
  const Real x3634 = x3135 * x3387 - x3200 * x3395 - x3228 * x3401;
  const Real x3678 = x3116 * x3387 - x3203 * x3395 - x3234 * x3401;
  const Real x3708 = x3161 * x3387 + x3206 * x3395 + x3240 * x3401;
  const Real x3757 = x3100 * x3403 + x3755 + x3112 * x3411;
  const Real x3767 = x3765 - x3100 * x3404 + x3112 * x3412;
  const Real x3777 = x3775 - x3100 * x3406 + x3112 * x3413;
  const Real x3787 = x3100 * x3408 + x3785 + x3112 * x3414;
  const Real x3797 = x3100 * x3409 + x3795 + x3112 * x3415;
  const Real x3429 = x3427 - x3216 * x3396 - x3256 * x3402;
  const Real x3430 = x3429 - x3319 * x3410;
  w.to[0][0] = x3430;
  const Real x3444 = x3442 - x3256 * x3403 - x3319 * x3411;
  w.to[0][1] = x3444;
  const Real x3458 = x3256 * x3404 + x3456 - x3319 * x3412;
  w.to[0][2] = x3458;
  const Real x3472 = x3256 * x3406 + x3470 - x3319 * x3413;
  w.to[0][3] = x3472;
  const Real x3486 = x3484 - x3256 * x3408 - x3319 * x3414;
  w.to[0][4] = x3486;
  const Real x3500 = x3498 - x3216 * x3401 - x3256 * x3409;
  const Real x3501 = x3500 - x3319 * x3415;
  w.to[0][5] = x3501;
  const Real x3515 = x3513 - x3222 * x3397 - x3265 * x3403;
  const Real x3516 = x3515 - x3331 * x3411;
  w.to[0][6] = x3516;
  const Real x3530 = x3265 * x3404 + x3528 - x3331 * x3412;
  w.to[0][7] = x3530;
  const Real x3544 = x3265 * x3406 + x3542 - x3331 * x3413;
  w.to[0][8] = x3544;
  const Real x3576 = x3574 - x3222 * x3401 - x3265 * x3409;
  const Real x3577 = x3576 - x3331 * x3415;
  w.to[0][10] = x3577;
  const Real x3591 = x3589 - x3228 * x3398 - x3276 * x3404;
  const Real x3592 = x3591 - x3343 * x3412;
  w.to[0][11] = x3592;
  const Real x3606 = x3604 - x3228 * x3399 - x3276 * x3406;
  const Real x3607 = x3606 - x3343 * x3413;
  w.to[0][12] = x3607;
  const Real x3621 = x3619 - x3228 * x3400 + x3276 * x3408;
  const Real x3622 = x3621 - x3343 * x3414;
  w.to[0][13] = x3622;
  const Real x3636 = x3276 * x3409 + x3634 - x3343 * x3415;
  w.to[0][14] = x3636;
  const Real x3650 = x3648 - x3234 * x3399 - x3288 * x3406;
  const Real x3651 = x3650 - x3355 * x3413;
  w.to[0][15] = x3651;
  const Real x3665 = x3663 - x3234 * x3400 + x3288 * x3408;
  const Real x3666 = x3665 - x3355 * x3414;
  w.to[0][16] = x3666;
  const Real x3680 = x3288 * x3409 + x3678 - x3355 * x3415;
  w.to[0][17] = x3680;
  const Real x3694 = x3692 - x3240 * x3400 - x3298 * x3408;
  const Real x3695 = x3694 - x3367 * x3414;
  w.to[0][18] = x3695;
  const Real x3727 = x3725 - x3246 * x3401 - x3307 * x3409;
  const Real x3728 = x3727 - x3379 * x3415;
  w.to[0][20] = x3728;
  const Real x3562 = -(x3265 * x3408 + x3557 + x3331 * x3414);
  w.to[0][9] = x3562;
  const Real x3713 = -(x3298 * x3409 + x3708 + x3367 * x3415);
  w.to[0][19] = x3713;
  const Real x3804 = -(x3100 * x3402 + x3745 + x3112 * x3410 + x2813);
  w.to[0][21] = x3804;
  const Real x3806 = -(x3757 - tau[6] * 769.2307692255798 + x2817);
  w.to[0][22] = x3806;
  const Real x3808 = -(x3767 - tau[6] * 0.0028255423871896726 + x2823);
  w.to[0][23] = x3808;
  const Real x3810 = -(x3777 - tau[6] * 2.8255423871896722e-05 + x2830);
  w.to[0][24] = x3810;
  const Real x3812 = -(tau[6] * 0.00011302169548758689 + x3787 + x2837);
  w.to[0][25] = x3812;
  const Real x3814 = -(x3797 - tau[6] * 30.769230769023192 + x2845);
  w.to[0][26] = x3814;
}

ADAGEN_NOINLINE ADAGEN_AS_IT_STANDS void part_1_1(Workspace& w) {
  ADAGEN_INPUTS
  // joint 8 "right_finger_slide": assembly: its two sides become one chain
  const Real x1079 = w.x[1];
  const Real x1199 = w.x[9];
  const Real x1229 = x1079 * 1.7763568394002505e-15;
  require_more(w, x1199, x1229, kFactorization, 8);
  const Real x1081 = w.x[12];
  const Real x1224 = w.x[15];
  const Real x1230 = x1081 * 1.7763568394002505e-15;
  require_more(w, x1224, x1230, kFactorization, 8);
  // link 9 "right_finger": acceleration where nothing acts on it
  const Real x864 = w.x[49];
  const Real x872 = w.x[50];
  const Real x887 = w.x[51];
  const Real x934 = x864 * 1799.9964000071998 - x872 * 17.999964000071998 - x887 * 73.999892000216;
  // joint 8 "right_finger_slide": assembly: its two sides become one chain
  const Real x1089 = w.x[60];
  const Real x1096 = w.x[61];
  const Real x1128 = 2.65358979335273e-06 * x1089 - 0.9999999999964793 * x1096 + x934;
  const Real x997 = w.x[2];
  const Real x1069 = w.x[8];
  w.x[188] = x1128 - tau[8] * (x997 + x1069 + 73.999892000216);
  // joint 7 "left_finger_slide": assembly: its two sides become one chain
  const Real x2003 = w.x[29];
  const Real x2050 = w.x[30];
  const Real x2118 = 1.7763568394002505e-15 * x2003;
  require_more(w, x2050, x2118, kFactorization, 7);
  const Real x2006 = w.x[37];
  const Real x2069 = w.x[39];
  const Real x2119 = 1.7763568394002505e-15 * x2006;
  require_more(w, x2069, x2119, kFactorization, 7);
  const Real x2008 = w.x[43];
  const Real x2093 = w.x[46];
  const Real x2120 = 1.7763568394002505e-15 * x2008;
  require_more(w, x2093, x2120, kFactorization, 7);
  const Real x2010 = w.x[52];
  const Real x2116 = w.x[67];
  const Real x2121 = 1.7763568394002505e-15 * x2010;
  require_more(w, x2116, x2121, kFactorization, 7);
  const Real x1626 = w.x[18];
  const Real x2164 = w.x[114];
  const Real x2332 = w.x[121];
  const Real x2337 = w.x[123];
  const Real x2520 = x1626 - x1626 * x2332 - x2164 * x2337;
  const Real x2187 = w.x[117];
  const Real x2232 = w.x[122];
  const Real x2343 = w.x[125];
  const Real x2349 = w.x[133];
  const Real x2522 = x2520 - x2187 * x2343 - x2232 * x2349;
  // link 8 "left_finger": acceleration where nothing acts on it
  const Real x1861 = w.x[89];
  const Real x1869 = w.x[83];
  const Real x1880 = w.x[84];
  const Real x1912 = 73.999892000216 * x1880 - 17.999964000071998 * x1869 + 1799.9964000071998 * x1861;
  // joint 7 "left_finger_slide": assembly: its two sides become one chain
  const Real x1929 = w.x[92];
  const Real x1987 = w.x[138];
  const Real x2036 = tau[7] * (x1987 - 0.13 * x1929 + 73.999892000216);
  const Real x1822 = w.x[88];
  const Real x1830 = w.x[137];
  w.x[189] = 0.13 * x1822 - x1830 + x1912 - x2036;
  const Real x2037 = w.x[104];
  const Real x2124 = w.x[109];
  const Real x2130 = w.x[115];
  const Real x2684 = x2037 * x2332 + x2124 * x2337 + x2130 * x2343;
  const Real x2031 = w.x[98];
  const Real x2139 = w.x[118];
  const Real x2151 = w.x[124];
  const Real x2355 = w.x[134];
  const Real x2716 = x2139 * x2349 + x2684 + x2151 * x2355 + x2031;
  // joint 6 "flange_roll": assembly: its two sides become one chain
  const Real x2927 = w.x[100];
  const Real x3011 = w.x[101];
  const Real x3079 = 1.7763568394002505e-15 * x2927;
  require_more(w, x3011, x3079, kFactorization, 6);
  const Real x2933 = w.x[112];
  const Real x3030 = w.x[119];
  const Real x3080 = 1.7763568394002505e-15 * x2933;
  require_more(w, x3030, x3080, kFactorization, 6);
  const Real x2936 = w.x[129];
  const Real x3054 = w.x[141];
  const Real x3081 = 1.7763568394002505e-15 * x2936;
  require_more(w, x3054, x3081, kFactorization, 6);
  const Real x2938 = w.x[149];
  const Real x3077 = w.x[170];
  const Real x3082 = 1.7763568394002505e-15 * x2938;
  require_more(w, x3077, x3082, kFactorization, 6);
  const Real x1826 = w.x[87];
  const Real x2817 = w.x[126];
  const Real x2823 = w.x[127];
  const Real x2983 = x1826 + x2716 + (0.9999999999932537 * x2817 + 3.673205103346574e-06 * x2823);
  const Real x2295 = w.x[132];
  w.x[190] = x2983 - tau[6] * (x2522 - x2295 * x2355 + 769.2307692307693);
}

ADAGEN_NOINLINE ADAGEN_AS_IT_STANDS void part_1_2(Workspace& w) {
  ADAGEN_INPUTS
  // message received
  const Real x3815 = w.from[1][0];
  const Real x3816 = w.from[1][1];
  const Real x3817 = w.from[1][2];
  const Real x3818 = w.from[1][3];
  const Real x3819 = w.from[1][4];
  const Real x3820 = w.from[1][5];
  // joint 6 "flange_roll": disassembly: its acceleration and force
  const Real x3899 = 769.2307692255798 * x3816 + 0.0028255423871896726 * x3817 + 2.8255423871896722e-05 * x3818;
  const Real x3113 = w.x[153];
  const Real x3123 = w.x[145];
  const Real x3135 = w.x[146];
  const Real x3832 = x3113 * x3815 - x3123 * x3816 + x3135 * x3817;
  const Real x3116 = w.x[144];
  const Real x3161 = w.x[147];
  const Real x3834 = x3116 * x3818 + x3832 - x3161 * x3819;
  const Real x3193 = w.x[164];
  const Real x3197 = w.x[157];
  const Real x3200 = w.x[158];
  const Real x3844 = x3197 * x3816 - x3193 * x3815 + x3200 * x3817;
  const Real x3203 = w.x[159];
  const Real x3206 = w.x[160];
  const Real x3846 = x3203 * x3818 + x3844 + x3206 * x3819;
  const Real x3216 = w.x[172];
  const Real x3222 = w.x[165];
  const Real x3228 = w.x[166];
  const Real x3855 = x3216 * x3815 + x3222 * x3816 + x3228 * x3817;
  const Real x3234 = w.x[167];
  const Real x3240 = w.x[168];
  const Real x3857 = x3234 * x3818 + x3855 + x3240 * x3819;
  const Real x3256 = w.x[180];
  const Real x3265 = w.x[174];
  const Real x3276 = w.x[175];
  const Real x3868 = x3256 * x3815 + x3265 * x3816 - x3276 * x3817;
  const Real x3288 = w.x[176];
  const Real x3298 = w.x[177];
  const Real x3870 = x3868 - x3288 * x3818 + x3298 * x3819;
  const Real x3319 = w.x[187];
  const Real x3331 = w.x[181];
  const Real x3343 = w.x[182];
  const Real x3879 = x3319 * x3815 + x3331 * x3816 + x3343 * x3817;
  const Real x3355 = w.x[183];
  const Real x3367 = w.x[184];
  const Real x3881 = x3355 * x3818 + x3879 + x3367 * x3819;
  const Real x3078 = w.x[173];
  const Real x3112 = w.x[186];
  const Real x3379 = w.x[185];
  const Real x3909 = x3078 * (x3379 * x3820 + x3881 + x3112);
  const Real x3064 = w.x[142];
  const Real x3100 = w.x[179];
  const Real x3307 = w.x[178];
  const Real x3908 = x3064 * (x3307 * x3820 + x3870 + x3100);
  const Real x3065 = w.x[162];
  const Real x3912 = x3908 - x3065 * x3909;
  const Real x3043 = w.x[120];
  const Real x3091 = w.x[171];
  const Real x3246 = w.x[169];
  const Real x3907 = x3043 * (x3246 * x3820 + x3857 + x3091);
  const Real x3021 = w.x[102];
  const Real x3085 = w.x[163];
  const Real x3209 = w.x[161];
  const Real x3906 = x3021 * (x3209 * x3820 + x3846 + x3085);
  const Real x2993 = w.x[152];
  const Real x3004 = w.x[80];
  const Real x3179 = w.x[148];
  const Real x3905 = x3004 * (x3834 - x3179 * x3820 + x2993);
  const Real x3044 = w.x[136];
  const Real x3045 = w.x[155];
  const Real x3918 = x3907 - x3045 * x3909 - x3044 * x3912;
  const Real x3023 = w.x[130];
  const Real x3024 = w.x[150];
  const Real x3926 = x3906 - x3024 * x3909 - x3023 * x3912;
  const Real x3022 = w.x[113];
  const Real x3927 = x3926 - x3022 * x3918;
  const Real x3007 = w.x[128];
  const Real x3008 = w.x[143];
  const Real x3937 = x3905 - x3008 * x3909 - x3007 * x3912;
  const Real x3005 = w.x[99];
  const Real x3006 = w.x[111];
  const Real x3939 = x3937 - x3006 * x3918 - x3005 * x3927;
  const Real x2568 = w.x[154];
  const Real x2931 = w.x[151];
  const Real x2932 = w.x[156];
  const Real x3946 = x2932 * x3912 + x2568 * x3909 + x2931 * x3918;
  // joint 7 "left_finger_slide": disassembly: its acceleration and force
  const Real x4089 = x3912 - tau[7];
  const Real x2295 = w.x[132];
  const Real x2319 = w.x[105];
  const Real x2331 = w.x[116];
  const Real x4002 = x2295 * tau[6] + x2331 * x3909 + x2319 * x3912;
  const Real x2232 = w.x[122];
  const Real x2250 = w.x[94];
  const Real x2259 = w.x[110];
  const Real x3991 = x2232 * tau[6] + x2259 * x3909 + x2250 * x3912;
  const Real x2187 = w.x[117];
  const Real x2199 = w.x[90];
  const Real x2205 = w.x[106];
  const Real x3980 = x2187 * tau[6] + x2205 * x3909 + x2199 * x3912;
  const Real x2164 = w.x[114];
  const Real x2170 = w.x[85];
  const Real x2173 = w.x[95];
  const Real x3969 = x2164 * tau[6] + x2173 * x3909 + x2170 * x3912;
  const Real x1626 = w.x[18];
  const Real x1652 = w.x[74];
  const Real x1663 = w.x[34];
  const Real x3958 = x1626 * tau[6] + x1663 * x3909 + x1652 * x3912;
  const Real x2283 = w.x[78];
  const Real x2307 = w.x[91];
  const Real x4004 = x2307 * x3918 + x4002 + x2283 * x3927;
  const Real x2223 = w.x[76];
  const Real x2241 = w.x[86];
  const Real x3993 = x2241 * x3918 + x3991 + x2223 * x3927;
  const Real x2181 = w.x[75];
  const Real x2193 = w.x[79];
  const Real x3982 = x2193 * x3918 + x3980 + x2181 * x3927;
  const Real x2053 = w.x[36];
  const Real x2167 = w.x[77];
  const Real x3971 = x2167 * x3918 + x3969 + x2053 * x3927;
  const Real x1576 = w.x[26];
  const Real x1637 = w.x[40];
  const Real x3960 = x1637 * x3918 + x3958 + x1576 * x3927;
  const Real x1951 = w.x[93];
  const Real x1987 = w.x[138];
  const Real x1993 = w.x[96];
  const Real x4018 = x1951 * tau[6] + x1993 * x3909 + x1987 * x3912;
  const Real x2117 = w.x[68];
  const Real x2151 = w.x[124];
  const Real x2271 = w.x[70];
  const Real x4028 = x2117 * (x2271 * x3939 + x4004 + x2151);
  const Real x1939 = w.x[103];
  const Real x2154 = w.x[135];
  const Real x4020 = x2154 * x3918 + x4018 + x1939 * x3927;
  const Real x4088 = x3918 - x4028;
  // joint 6 "flange_roll": disassembly: its acceleration and force
  const Real x2995 = w.x[190];
  const Real x3903 = 0.00011302169548758689 * x3819 - x3899 - 30.769230769023192 * x3820 + x2995;
  const Real x2394 = w.x[139];
  const Real x2463 = w.x[140];
  const Real x3949 = x2463 * x3927 + x3946 + x2394 * x3939 - x3903;
  w.result[6] = x3949;
  // joint 7 "left_finger_slide": disassembly: its acceleration and force
  const Real x2103 = w.x[47];
  const Real x2139 = w.x[118];
  const Real x2214 = w.x[69];
  const Real x4027 = x2103 * (x2214 * x3939 + x3993 + x2139);
  const Real x2104 = w.x[56];
  const Real x4031 = x4027 - x2104 * x4028;
  const Real x2082 = w.x[41];
  const Real x2130 = w.x[115];
  const Real x2179 = w.x[57];
  const Real x4026 = x2082 * (x2179 * x3939 + x3982 + x2130);
  const Real x2060 = w.x[31];
  const Real x2124 = w.x[109];
  const Real x2161 = w.x[55];
  const Real x4025 = x2060 * (x2161 * x3939 + x3971 + x2124);
  const Real x1516 = w.x[22];
  const Real x2037 = w.x[104];
  const Real x2043 = w.x[21];
  const Real x4024 = x2043 * (x1516 * x3939 + x3960 + x2037);
  const Real x4090 = x3909 - x4031;
  const Real x2083 = w.x[45];
  const Real x2084 = w.x[54];
  const Real x4037 = x4026 - x2084 * x4028 - x2083 * x4031;
  const Real x2062 = w.x[44];
  const Real x2063 = w.x[53];
  const Real x4045 = x4025 - x2063 * x4028 - x2062 * x4031;
  const Real x2061 = w.x[38];
  const Real x4046 = x4045 - x2061 * x4037;
  const Real x2046 = w.x[42];
  const Real x2047 = w.x[48];
  const Real x4056 = x4024 - x2047 * x4028 - x2046 * x4031;
  const Real x4086 = x3927 - (x4037 + 0.13 * x4028);
  const Real x2044 = w.x[28];
  const Real x2045 = w.x[35];
  const Real x4058 = x4056 - x2045 * x4037 - x2044 * x4046;
  const Real x4085 = x3939 - (q[7] * x4031 - 0.13 * tau[7] + x4046);
  const Real x1973 = w.x[108];
  const Real x2009 = w.x[107];
  const Real x4065 = x2009 * x4031 + x1973 * x4028 + x1939 * x4037;
  const Real x4087 = tau[6] - (x4058 - q[7] * x4028);
  const Real x2005 = w.x[97];
  const Real x4067 = x2005 * x4046 + x4065 + x1951 * x4058;
  const Real x1929 = w.x[92];
  const Real x2042 = w.x[189];
  const Real x4068 = x4067 - (x1929 * x3939 + x4020 + x2042);
  w.result[7] = x4068;
  // joint 8 "right_finger_slide": disassembly: its acceleration and force
  const Real x1427 = w.x[33];
  const Real x1439 = w.x[71];
  const Real x1448 = w.x[27];
  const Real x4148 = x1427 * x4088 + x1439 * x4089 + x1448 * x4090;
  const Real x1367 = w.x[32];
  const Real x1378 = w.x[64];
  const Real x1385 = w.x[25];
  const Real x4137 = x1367 * x4088 + x1378 * x4089 + x1385 * x4090;
  const Real x4126 = 59.670781892791446 * x4088 - 7.234479409858621e-05 * x4089 - 5.69800569798539 * x4090;
  const Real x4111 = 1.5120169762693617e-05 * x4090 - (0.00015834177779265263 * x4088 + 27.095931187385858 * x4089);
  const Real x1293 = w.x[131];
  const Real x4167 = 3.4167136554933856e-06 * x4088 + x1293 * x4089 - 6.243740690241717e-07 * x4090;
  const Real x1397 = w.x[20];
  const Real x1406 = w.x[24];
  const Real x4150 = x1406 * x4086 + x4148 + x1397 * x4085;
  const Real x1344 = w.x[19];
  const Real x1351 = w.x[23];
  const Real x4139 = x1351 * x4086 + x4137 + x1344 * x4085;
  const Real x4128 = x4126 - 672.6812282343863 * x4086 - 0.0008033816505865777 * x4085;
  const Real x4113 = 0.0017850200414291078 * x4086 + x4111 - 300.897586242875 * x4085;
  const Real x1269 = w.x[82];
  const Real x4169 = x4167 - 7.371082759313139e-05 * x4086 + x1269 * x4085;
  const Real x4099 = 328.7950427750268 * x4087 - (47.81116318204386 * x4085 + 7.026218837536823 * x4089);
  const Real x1225 = w.x[16];
  const Real x1260 = w.x[81];
  const Real x1418 = w.x[17];
  const Real x4177 = x1225 * (x1418 * x4087 + x4150 + x1260);
  const Real x1210 = w.x[10];
  const Real x1248 = w.x[73];
  const Real x1360 = w.x[14];
  const Real x4176 = x1210 * (x1360 * x4087 + x4139 + x1248);
  const Real x1211 = w.x[13];
  const Real x4180 = x4176 - x1211 * x4177;
  const Real x1239 = w.x[72];
  const Real x4175 = 1.648191504944564e-05 * (0.0001275136846625453 * x4087 + x4128 + x1239);
  const Real x1233 = w.x[66];
  const Real x4174 = 1.658353407741297e-05 * (47.758820356278655 * x4087 + x4113 + x1233);
  const Real x1189 = w.x[5];
  const Real x1190 = w.x[11];
  const Real x4186 = x4175 - x1190 * x4177 - x1189 * x4180;
  const Real x1136 = w.x[62];
  const Real x1150 = w.x[6];
  const Real x4204 = 3.3296807285906615e-06 * (x1136 + x4099) - x1150 * x4177;
  const Real x1166 = w.x[4];
  const Real x1167 = w.x[7];
  const Real x4194 = x4174 + x1167 * x4177 - x1166 * x4180;
  const Real x4195 = 1.63606725685963e-08 * x4186 + x4194;
  const Real x1149 = w.x[0];
  const Real x4206 = x4204 - x1149 * x4180 - 4.2244063836038523e-10 * x4186;
  const Real x1036 = w.x[3];
  const Real x1068 = w.x[65];
  const Real x1080 = w.x[63];
  const Real x4215 = x1080 * x4180 + x1068 * x4177 + x1036 * x4186;
  const Real x1024 = w.x[58];
  const Real x4208 = x1024 * (x4206 - 0.00015919590865819434 * x4195);
  const Real x1076 = w.x[59];
  const Real x4217 = x1076 * x4195 + x4215 - x4208;
  const Real x1141 = w.x[188];
  const Real x4218 = x4217 - (x4169 - x1024 * x4087 + x1141);
  w.result[8] = x4218;
}

// ---- processes ----------------------------------------------------------------------------------

// Process 0: 6 of 9 joints: "base_yaw", "shoulder_pitch", "upper_arm_roll", "elbow_pitch", "forearm_roll", "wrist_pitch"
constexpr std::array<int, 6> kRead_0{0, 1, 2, 3, 4, 5};
constexpr std::array<int, 6> kOwned_0{0, 1, 2, 3, 4, 5};
constexpr std::array<int, 6> kAngles_0{0, 1, 2, 3, 4, 5};

ADAGEN_AS_IT_STANDS void run_0([[maybe_unused]] Workspace& w, [[maybe_unused]] Channel& channel) {
  ADAGEN_INPUTS
  if (!all(unlike_zero(q + 0, 6) + unlike_zero(v + 0, 6) + unlike_zero(tau + 0, 6) == 0))
    name_what_is_not_finite(w, kRead_0, kOwned_0);
  w.to[1] = channel.outgoing(1, w.status);
  take_sines_and_cosines(q, kAngles_0, w.sine.data(), w.cosine.data());
  w.to[1][2] = tau[5];
  part_0_0(w);
  stamp(1);
  stamp(2);
  w.from[0] = channel.receive(0, w.status);  // from process 1: assembled: chain of "flange_roll"
  stamp(3);
  part_0_1(w);
  stamp(4);
  stamp(5);
  channel.send(1, w.status);  // to process 1: forces on: chain of "flange_roll"
  stamp(6);
  part_0_2(w);
  stamp(7);
  if (!all(unlike_zero(w.result.data() + 0, 6) == 0)) name_what_overflows(w, kOwned_0);
  if (w.status != kFine) return;
  std::copy_n(w.result.data() + 0, 6, w.qdd + 0);
}

// Process 1: 3 of 9 joints: "flange_roll", "left_finger_slide", "right_finger_slide"; kinematics of 6 more on the way to the ground
constexpr std::array<int, 9> kRead_1{0, 1, 2, 3, 4, 5, 6, 7, 8};
constexpr std::array<int, 3> kOwned_1{6, 7, 8};
constexpr std::array<int, 7> kAngles_1{0, 1, 2, 3, 4, 5, 6};

ADAGEN_AS_IT_STANDS void run_1([[maybe_unused]] Workspace& w, [[maybe_unused]] Channel& channel) {
  ADAGEN_INPUTS
  if (!all(unlike_zero(q + 0, 9) + unlike_zero(v + 0, 9) + unlike_zero(tau + 6, 3) == 0))
    name_what_is_not_finite(w, kRead_1, kOwned_1);
  w.to[0] = channel.outgoing(0, w.status);
  take_sines_and_cosines(q, kAngles_1, w.sine.data(), w.cosine.data());
  part_1_0(w);
  stamp(1);
  stamp(2);
  channel.send(0, w.status);  // to process 0: assembled: chain of "flange_roll"
  stamp(3);
  part_1_1(w);
  w.from[1] = channel.receive(1, w.status);  // from process 0: forces on: chain of "flange_roll"
  stamp(4);
  part_1_2(w);
  stamp(5);
  if (!all(unlike_zero(w.result.data() + 6, 3) == 0)) name_what_overflows(w, kOwned_1);
  if (w.status != kFine) return;
  std::copy_n(w.result.data() + 6, 3, w.qdd + 6);
}


}  // namespace

[[maybe_unused]] constexpr std::array<StageInfo, 7> kStages_0{ {
    {"kinematics", 5, -1}, {"assembly", 4, -1}, {"receive", -1, 0}, {"assembly", 5, -1},
    {"disassembly", 5, -1}, {"send", -1, 1}, {"disassembly", 4, -1}
} };
[[maybe_unused]] constexpr std::array<StageInfo, 5> kStages_1{ {
    {"kinematics", 8, -1}, {"assembly", 6, -1}, {"send", -1, 0}, {"receive", -1, 1},
    {"disassembly", 6, -1}
} };
[[maybe_unused]] constexpr std::array<void (*)(Workspace&, Channel&), kProcesses> kRun{run_0, run_1};

constexpr std::array<Range, 4> kRanges_0{ {{0, 6}, {0, 6}, {0, 6}, {0, 6}} };
constexpr std::array<Range, 4> kRanges_1{ {{0, 9}, {0, 9}, {6, 3}, {6, 3}} };
[[maybe_unused]] constexpr std::array<ProcessInfo, kProcesses> kProcess{ {
    {{1, kRanges_0.data()}, {1, kRanges_0.data() + 1}, {1, kRanges_0.data() + 2}, {1, kRanges_0.data() + 3}, {7, kStages_0.data()}},
    {{1, kRanges_1.data()}, {1, kRanges_1.data() + 1}, {1, kRanges_1.data() + 2}, {1, kRanges_1.data() + 3}, {5, kStages_1.data()}}}};

#include "adagen/whole_mpi.hpp"
