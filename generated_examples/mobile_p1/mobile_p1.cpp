// Forward dynamics of "mobile" on 1 process, emitted by adagen 0.1.0 (solver.cpp.j2). Do not edit: generate again. Licence: yours to choose.
// robot     "mobile", 6 joints, 13 degrees of freedom, description sha256 421e40d13e3d94e0ea25fa3a829795267d134cdc98cb6abe58b7ec78cf6d9704
// command   adagen ../models/mobile.urdf --procs 1
// input     profile default, sha256 fe36af9ff4727e4941af0e7182db7f87cd64c54109bc287302f720e9ad83c3a8
// options   form segment (articulated-body algorithm), shape unrolled (spatial vectors [angular; linear] in link frames whose joint axes are z), scalar double, channel auto, fixed base, gravity 0.0, 0.0, -9.81
// links     adagen_program.cpp; or, compiled with -DADAGEN_NO_MAIN, a program of yours that includes mobile_p1.h
// program   1 process; 0.157 us predicted (default profile)
//           process 0: drive .. loose

#include "mobile_p1.h"
#define ADAGEN_CALL(word) mobile_p1_##word
#define ADAGEN_NAMED(WORD) MOBILE_P1_##WORD
#include "adagen/settings.hpp"

namespace { struct mobile_p1_settings : PlainSettings {
  static constexpr int kVersion = 100, kJointCount = 6, kNq = 14, kNv = 13;
  [[maybe_unused]] static constexpr const char* kRobot = "mobile";
}; }  // namespace: a program may load several solvers of one name

#include "adagen/constants.hpp"

constexpr std::array<LinkConstants, kLinkCount> kLinks{ {
    {"floor", 0.0, {0.0, 0.0, 0.0}},
    {"cart", 35.5, {-0.02799449804688646, 0.0, 0.21497801221230384},
     {2.082900209661478, 0.0, 0.33755007267889864, 0.0, 2.5480080181799307, 0.0, 0.33755007267889864, 0.0, 1.442107808518453}},
    {"laser", 0.35, {0.0, 0.0, -0.04},
     {0.000245, 0.0, 0.0, 0.0, 0.000245, 0.0, 0.0, 0.0, 0.00028}},
    {"carriage", 4.2, {0.08, 0.0, 0.0},
     {0.02086, 0.0, 0.0, 0.0, 0.01372, 0.0, 0.0, 0.0, 0.02086}},
    {"boom", 2.4, {0.17560487334233152, 0.02197563328834232, 0.03286335345030997},
     {0.0031240337753782573, -0.002972881060907817, -0.0044457804600413296, -0.002972881060907817, 0.026507966224621746, -0.0005563560920082658, -0.0044457804600413296, -0.0005563560920082658, 0.026048}},
    {"bowl", 0.9, {0.0, 0.0, 0.1},
     {0.0021075, 0.0, 0.0, 0.0, 0.00384, 0.0, 0.0, 0.0, 0.0021075}},
    {"load", 0.6, {0.01, -0.02, 0.015},
     {0.0006, 0.0, 0.0, 0.0, 0.0006, 0.0, 0.0, 0.0, 0.0006}}}};

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

// ---- functions ----------------------------------------------------------------------------------

#include "adagen/far_angles.hpp"
#include "adagen/no_channel.hpp"
#include "adagen/unrolled_memory.hpp"

namespace {

struct Workspace : StraightMemory<8, 0, 0> {};

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
// Process 0: 764 products, 627 sums, 6 quotients
// =================================================================================================

ADAGEN_NOINLINE ADAGEN_AS_IT_STANDS void part_0_0(Workspace& w) {
  ADAGEN_INPUTS
  // joint 0 "drive": placement, velocity and reference acceleration of its link
  const Real x15 = v[2] * v[2];
  const Real x12 = v[1] * v[2];
  const Real x14 = v[0] * v[2];
  // joint 1 "laser_spin": placement, velocity and reference acceleration of its link
  const Real x29 = x12 + x15 * 0.22;
  // joint 2 "lift": placement, velocity and reference acceleration of its link
  const Real x60 = v[2] * 0.9987502603949663;
  const Real x61 = v[2] * 0.04997916927067833;
  const Real x57 = -0.08507706744923418 + q[4] * 0.04997916927067833;
  const Real x83 = x60 * x60;
  const Real x87 = x60 * x61;
  const Real x65 = x12 + x15 * x57;
  const Real x80 = x14 + v[4] * (2.0 * x61);
  const Real x74 = -0.49029565054535446 - 0.9987502603949663 * x65;
  const Real x70 = 9.79774005447462 - 0.04997916927067833 * x65;
  // joint 3 "shoulder": placement, velocity and reference acceleration of its link
  const Real x146 = v[5] - (x61 * 0.18257418583505539 + x60 * 0.36514837167011077);
  const Real x191 = x146 * x146;
  const Real x157 = x74 - (x83 * 0.15 + x87 * 0.02);
  const Real x164 = x70 - (x87 * 0.15 + x61 * x61 * 0.02);
  // joint 4 "wrist": placement, velocity and reference acceleration of its link
  const Real x240 = cosine[3] * 0.4955543024180784 + sine[3] * 0.8497464879390758;
  const Real x229 = 0.04136261787763011 * sine[3] - cosine[3] * 0.4028214625008311;
  const Real x246 = sine[3] * 0.4955543024180784 - cosine[3] * 0.8497464879390758;
  const Real x233 = 0.04136261787763011 * cosine[3] + sine[3] * 0.4028214625008311;
  // joint 5 "loose": placement, velocity and reference acceleration of its link
  const Real x389 = q[10] * q[10] + q[11] * q[11] + q[12] * q[12];
  const Real x390 = q[13] * q[13] + x389;
  require_length(w, x390, 5);
  const Real x431 = 0.08 + q[8] * 0.29552020666133955 + q[9] * 0.955336489125606;
  const Real x438 = 0.1 + q[7] * 0.9800665778412416 + q[8] * 0.18979606097868743;
  const Real x439 = x438 - q[9] * 0.058710801693826524;
  const Real x427 = q[8] * 0.9362933635841992 - q[7] * 0.19866933079506122 - q[9] * 0.28962947762551555;
  const Real x392 = 2.0 * (1 / x390);
  const Real x393 = q[10] * x392;
  const Real x394 = q[11] * x392;
  const Real x395 = q[12] * x392;
  // joint 3 "shoulder": placement, velocity and reference acceleration of its link
  const Real x105 = 0.12208685160190179 * sine[2];
  const Real x107 = 0.12208685160190179 * cosine[2];
  const Real x106 = 0.9755826296796196 * cosine[2] + x105;
  const Real x109 = x107 - 0.9755826296796196 * sine[2];
  const Real x123 = 0.18257418583505539 * cosine[2] - 0.9128709291752769 * sine[2];
  const Real x127 = 0.9128709291752769 * cosine[2] + 0.18257418583505539 * sine[2];
  const Real x114 = x107 + sine[2] * 0.3895657419904911;
  const Real x119 = x105 - cosine[2] * 0.3895657419904911;
  const Real x132 = x60 * x123 - x61 * x106;
  const Real x137 = x61 * x109 + x60 * x127;
  const Real x149 = v[5] * x132;
  const Real x188 = x132 * x132;
  const Real x189 = x137 * x137;
  const Real x194 = x132 * x137;
  const Real x205 = x132 * x146;
  // joint 4 "wrist": placement, velocity and reference acceleration of its link
  const Real x251 = 0.7695198520529689 * cosine[3] - sine[3] * 0.5255663993041366;
  const Real x255 = cosine[3] * 0.5255663993041366 + 0.7695198520529689 * sine[3];
  // joint 5 "loose": placement, velocity and reference acceleration of its link
  const Real x396 = q[11] * x394;
  const Real x397 = q[12] * x395;
  const Real x400 = q[11] * x393;
  const Real x401 = q[13] * x395;
  const Real x403 = q[12] * x393;
  const Real x404 = q[13] * x394;
  // joint 4 "wrist": articulated-body inertia and bias force through it
  const Real x1203 = x240 * 0.9;
  const Real x1200 = x229 * 0.9;
  const Real x1205 = x246 * 0.9;
  const Real x1201 = x233 * 0.9;
  const Real x1124 = x251 * 0.09000000000000001;
  const Real x1122 = x255 * 0.09000000000000001;
  const Real x1233 = x240 * x1203 + 0.029121155631123948 + x246 * x1205;
  const Real x1221 = -0.14802495261763252 - x240 * x1200 + x246 * x1201;
  const Real x1161 = x240 * x1122 - x246 * x1124;
  const Real x1155 = x229 * x1122 + x233 * x1124;
  const Real x1215 = x229 * x1200 + 0.7524216028719005 + x233 * x1201;
  const Real x1199 = x251 * (x251 * 0.011107500000000001) + x255 * (x255 * 0.01284);
  const Real x1275 = x1161 + 0.3707213992782555 * x1233 - 0.04639300360872268 * x1221;
  const Real x1261 = 0.3707213992782555 * x1221 - x1155 - 0.04639300360872268 * x1215;
  const Real x1240 = -0.05873339565585371 - x251 * x1203 - x255 * x1205;
  const Real x1349 = x1199 + 0.3707213992782555 * x1161 + 0.04639300360872268 * x1155;
  const Real x1166 = x255 * x1124 - x251 * x1122;
  const Real x1227 = x251 * x1200 + 0.2985461229340252 - x255 * x1201;
  const Real x1267 = 0.3707213992782555 * x1240;
  const Real x1413 = 0.3707213992782555 * x1275 + x1349 - 0.04639300360872268 * x1261 + 0.10121599999999999;
  require_more(w, x1413, 0.0, kFactorization, 3);
  // joint 3 "shoulder": placement, velocity and reference acceleration of its link
  const Real x147 = v[5] * x137;
  const Real x170 = x106 * x157 - x80 * x114 + x123 * x164;
  const Real x176 = x109 * x157 + x80 * x119 - x127 * x164;
  const Real x192 = x189 + x191;
  const Real x196 = x188 + x191;
  const Real x198 = x137 * x146;
  const Real x206 = x149 + x205;
  const Real x182 = 0.18257418583505539 * x157 + x80 * 0.9128709291752769 - 0.36514837167011077 * x164;
  const Real x200 = x147 - x198;
  const Real x201 = x147 + x198;
  const Real x207 = x205 - x149;
  const Real x203 = x188 + x189;
  // joint 4 "wrist": placement, velocity and reference acceleration of its link
  const Real x262 = x132 * x229 + x146 * x251 + x137 * x240;
  const Real x269 = x132 * x233 - x146 * x255 - x137 * x246;
  const Real x306 = x170 - x194 * 0.04639300360872268 - x192 * 0.3707213992782555;
  const Real x307 = x207 * 0.06937819061732105 + x306;
  const Real x314 = x176 - x194 * 0.3707213992782555 - x196 * 0.04639300360872268;
  const Real x315 = x200 * 0.06937819061732105 + x314;
  // joint 5 "loose": placement, velocity and reference acceleration of its link
  const Real x407 = q[10] * x393;
  const Real x410 = q[12] * x394;
  const Real x411 = q[13] * x393;
  const Real x402 = x400 - x401;
  const Real x406 = x400 + x401;
  const Real x413 = x403 - x404;
  const Real x414 = x410 + x411;
  const Real x399 = 1.0 - (x396 + x397);
  const Real x405 = x403 + x404;
  const Real x409 = 1.0 - (x397 + x407);
  const Real x412 = x410 - x411;
  const Real x416 = 1.0 - (x396 + x407);
  // joint 4 "wrist": articulated-body inertia and bias force through it
  const Real x1247 = 0.04639300360872268 * x1227;
  const Real x1414 = -0.05274151989202157 + x1261;
  const Real x1415 = 0.42145169602159566 + x1275;
  const Real x1288 = x1166 + x1267 - x1247;
  const Real x1245 = x251 * (x251 * 0.9) + 0.11845724149697545;
  const Real x1246 = x255 * (x255 * 0.9) + x1245;
  // joint 3 "shoulder": articulated-body inertia and bias force through it
  const Real x1426 = 1 / x1413;
  const Real x1431 = x1414 * x1426;
  const Real x1432 = x1415 * x1426;
  const Real x1433 = x1288 * x1426;
  const Real x1463 = 2.4 + x1215 - x1414 * x1431;
  const Real x1466 = x1221 - x1414 * x1432;
  const Real x1472 = 2.4 + x1233 - x1415 * x1432;
  // joint 4 "wrist": placement, velocity and reference acceleration of its link
  const Real x276 = x132 * 0.9143434820629502 + x146 * 0.3627935462750979 + x137 * 0.17988007001927067;
  const Real x277 = v[6] + x276;
  const Real x322 = x182 + x206 * 0.3707213992782555 - x201 * 0.04639300360872268;
  const Real x323 = x322 - x203 * 0.06937819061732105;
  const Real x295 = x149 * x240 - x147 * x229 + v[6] * x269;
  const Real x298 = x147 * x233 + x149 * x246 + v[6] * x262;
  const Real x355 = x269 * x277;
  const Real x360 = x262 * x277;
  const Real x329 = x229 * x307 - x240 * x315 + x251 * x323;
  // joint 5 "loose": placement, velocity and reference acceleration of its link
  const Real x476 = 0.18979606097868743 * x406 - x413 * 0.058710801693826524 + 0.9800665778412416 * x399;
  const Real x482 = 0.9800665778412416 * x402 - x414 * 0.058710801693826524 + 0.18979606097868743 * x409;
  const Real x446 = 0.9362933635841992 * x406 - x413 * 0.28962947762551555 - x399 * 0.19866933079506122;
  const Real x454 = 0.9362933635841992 * x409 - (x402 * 0.19866933079506122 + x414 * 0.28962947762551555);
  const Real x464 = 0.29552020666133955 * x406 + 0.955336489125606 * x413;
  const Real x467 = 0.29552020666133955 * x409 + 0.955336489125606 * x414;
  const Real x488 = 0.9800665778412416 * x405 + 0.18979606097868743 * x412 - x416 * 0.058710801693826524;
  const Real x461 = 0.9362933635841992 * x412 - x405 * 0.19866933079506122 - x416 * 0.28962947762551555;
  const Real x470 = 0.29552020666133955 * x412 + 0.955336489125606 * x416;
  // joint 4 "wrist": articulated-body inertia and bias force through it
  const Real x1116 = x233 * 0.09000000000000001;
  const Real x1117 = x229 * 0.09000000000000001;
  const Real x1119 = x246 * 0.09000000000000001;
  const Real x1120 = x240 * 0.09000000000000001;
  const Real x1167 = x229 * 0.011107500000000001;
  const Real x1168 = x233 * 0.01284;
  const Real x1169 = x240 * 0.011107500000000001;
  const Real x1171 = x246 * 0.01284;
  const Real x1134 = x240 * x1116 + x246 * x1117;
  const Real x1146 = x246 * x1120 - x240 * x1119;
  const Real x1248 = 0.06937819061732105 * x1221;
  // joint 3 "shoulder": articulated-body inertia and bias force through it
  const Real x1469 = x1227 - x1414 * x1433;
  const Real x1475 = x1240 - x1415 * x1433;
  const Real x1478 = 2.4 + x1246 - x1288 * x1433;
  // joint 4 "wrist": placement, velocity and reference acceleration of its link
  const Real x335 = x233 * x307 + x246 * x315 - x255 * x323;
  const Real x345 = x262 * x262;
  const Real x346 = x269 * x269;
  const Real x356 = x355 - x295;
  const Real x362 = x360 - x298;
  const Real x341 = 0.9143434820629502 * x307 - 0.17988007001927067 * x315 + 0.3627935462750979 * x323;
  const Real x358 = x345 + x346;
  // joint 5 "loose": articulated-body inertia and bias force through it
  const Real x1090 = x476 * tau[7] + x482 * tau[8] + x488 * tau[9];
  const Real x1080 = x446 * tau[7] + x454 * tau[8] + x461 * tau[9];
  const Real x1085 = x464 * tau[7] + x467 * tau[8] + x470 * tau[9];
  const Real x1065 = x446 * tau[10] + x454 * tau[11] + x461 * tau[12];
  // joint 4 "wrist": articulated-body inertia and bias force through it
  const Real x1142 = x229 * x1119 + x233 * x1120;
  const Real x1266 = 0.04639300360872268 * x1240 - x1134 - 0.06937819061732105 * x1233;
  const Real x1270 = x1146 + x1248 - x1267;
  const Real x1139 = x251 * x1116 + x255 * x1117;
  const Real x1150 = x251 * x1119 - x255 * x1120;
  const Real x1251 = x229 * x1116 - x233 * x1117 + x1247 - x1248;
  const Real x1256 = x1142 + 0.06937819061732105 * x1215 - 0.3707213992782555 * x1227;
  const Real x1315 = x251 * x1167 - x255 * x1168 + 0.04639300360872268 * x1166;
  const Real x1336 = x251 * x1169 + x255 * x1171 + 0.06937819061732105 * x1155;
  // joint 3 "shoulder": articulated-body inertia and bias force through it
  const Real x1660 = x123 * x1463 - x127 * x1466 - 0.36514837167011077 * x1469;
  const Real x1667 = x123 * x1466 - x127 * x1472 - 0.36514837167011077 * x1475;
  const Real x1674 = x123 * x1469 - x127 * x1475 - 0.36514837167011077 * x1478;
  // joint 5 "loose": articulated-body inertia and bias force through it
  const Real x1070 = x464 * tau[10] + x467 * tau[11] + x470 * tau[12];
  const Real x1109 = x329 * 0.9 + x362 * 0.09000000000000001 + x1080;
  const Real x1110 = x335 * 0.9 + x356 * 0.09000000000000001 + x1085;
  // link 5 "bowl": bias force in the reference field
  const Real x871 = x295 * 0.011107500000000001 - x355 * 0.0107325 - x335 * 0.09000000000000001;
  // joint 5 "loose": articulated-body inertia and bias force through it
  const Real x1106 = x1065 + x431 * x1090 - x439 * x1085 + x871;
  const Real x1111 = x341 * 0.9 - x358 * 0.09000000000000001 + x1090;
  // link 5 "bowl": bias force in the reference field
  const Real x873 = x360 * 0.009000000000000001 - x298 * 0.01284 + x329 * 0.09000000000000001;
  // joint 5 "loose": articulated-body inertia and bias force through it
  const Real x1107 = x1070 + x439 * x1080 - x427 * x1090 + x873;
  // joint 4 "wrist": articulated-body inertia and bias force through it
  const Real x1280 = x1139 + 0.04639300360872268 * x1246 - 0.06937819061732105 * x1240;
  const Real x1317 = x1315 - 0.06937819061732105 * x1161 + 0.3707213992782555 * x1266;
  const Real x1340 = 0.3707213992782555 * x1270 - (0.3707213992782555 * x1166 + x1336);
  const Real x1285 = x1150 + 0.06937819061732105 * x1227 - 0.3707213992782555 * x1246;
  const Real x1295 = x229 * x1167 + x233 * x1168 + 0.04639300360872268 * x1139;
  const Real x1305 = x246 * x1168 - x240 * x1167 + 0.04639300360872268 * x1150;
  const Real x1325 = x240 * x1169 + x246 * x1171 + 0.06937819061732105 * x1142;
  const Real x1406 = x1317 - 0.04639300360872268 * x1251 + -0.01829609650863162;
  const Real x1410 = x1340 - 0.04639300360872268 * x1256 + -0.0022896193017263246;
  const Real x1382 = x246 * x1110 - x240 * x1109 - 0.17988007001927067 * x1111;
  const Real x1375 = x229 * x1109 + x233 * x1110 + 0.9143434820629502 * x1111;
  const Real x1297 = 0.06937819061732105 * x1134 + x1295 + 0.04639300360872268 * x1280;
  // joint 3 "shoulder": articulated-body inertia and bias force through it
  const Real x1712 = x123 * x1660 - x127 * x1667 - 0.36514837167011077 * x1674;
  const Real x1834 = 4.2 + x1712;
  require_more(w, x1834, 0.0, kFactorization, 2);
  const Real x1625 = x106 * x1463 + x109 * x1466 + 0.18257418583505539 * x1469;
  const Real x1630 = x106 * x1466 + x109 * x1472 + 0.18257418583505539 * x1475;
  const Real x1635 = x106 * x1469 + x109 * x1475 + 0.18257418583505539 * x1478;
  const Real x1692 = x123 * x1625 - x127 * x1630 - 0.36514837167011077 * x1635;
  // joint 2 "lift": articulated-body inertia and bias force through it
  const Real x1841 = 1 / x1834;
  // link 4 "boom": bias force in the reference field
  const Real x800 = x200 * 0.01829609650863162 - x194 * 0.09623387584880971 - x207 * 0.0022896193017263246;
  const Real x801 = x800 - 0.012234548981428322 * (x196 - x192);
  // joint 4 "wrist": articulated-body inertia and bias force through it
  const Real x1307 = x1305 - 0.06937819061732105 * x1146 + 0.06937819061732105 * x1251;
  const Real x1327 = x1325 - 0.3707213992782555 * x1150 + 0.06937819061732105 * x1256;
  const Real x1370 = x251 * x1106 + 0.3627935462750979 * tau[6] - x255 * x1107;
  // link 4 "boom": bias force in the reference field
  const Real x816 = x176 * 0.42145169602159566 - x170 * 0.05274151989202157 + x801;
  // joint 3 "shoulder": articulated-body inertia and bias force through it
  const Real x1429 = x1406 * x1426;
  const Real x1430 = x1410 * x1426;
  const Real x1442 = x1251 - x1406 * x1431;
  const Real x1445 = -0.07887204828074391 + x1266 - x1406 * x1432;
  const Real x1454 = 0.07887204828074391 + x1256 - x1410 * x1431;
  const Real x1457 = x1270 - x1410 * x1432;
  const Real x1448 = 0.05274151989202157 + x1280 - x1406 * x1433;
  const Real x1460 = -0.42145169602159566 + x1285 - x1410 * x1433;
  const Real x1641 = x119 * x1466 - x114 * x1463 + 0.9128709291752769 * x1469;
  const Real x1647 = x119 * x1472 - x114 * x1466 + 0.9128709291752769 * x1475;
  const Real x1679 = x106 * x1625 + x109 * x1630 + 0.18257418583505539 * x1635;
  const Real x1436 = x1297 - 0.06937819061732105 * x1266 + 0.0068750620755951355 - x1406 * x1429;
  const Real x1439 = x1307 - 0.3707213992782555 * x1280 + -0.012234548981428322 - x1406 * x1430;
  const Real x1451 = x1327 - 0.3707213992782555 * x1285 + 0.10310893792440486 - x1410 * x1430;
  const Real x1491 = x106 * x1442 + x109 * x1454;
  const Real x1494 = x106 * x1445 + x109 * x1457;
  const Real x1513 = x123 * x1442 - x127 * x1454;
  const Real x1517 = x123 * x1445 - x127 * x1457;
  const Real x1653 = x119 * x1475 - x114 * x1469 + 0.9128709291752769 * x1478;
  const Real x1497 = x106 * x1448 + x109 * x1460;
  const Real x1521 = x123 * x1448 - x127 * x1460;
  // joint 2 "lift": articulated-body inertia and bias force through it
  const Real x1847 = x1692 * x1841;
  const Real x1887 = 4.2 + x1679 - x1692 * x1847;
  // link 4 "boom": bias force in the reference field
  const Real x824 = x170 * 2.4 - x194 * 0.05274151989202157 - x192 * 0.42145169602159566;
  const Real x833 = x176 * 2.4 - x194 * 0.42145169602159566 - x196 * 0.05274151989202157;
  const Real x767 = x198 * 0.0018929379244048662 - x147 * 0.0068750620755951355 + x194 * 0.01829609650863162;
  const Real x842 = x182 * 2.4 + x206 * 0.42145169602159566 - x201 * 0.05274151989202157;
  const Real x785 = x149 * 0.10310893792440486 + x205 * 0.09434093792440484 + x194 * 0.0022896193017263246;
  // joint 4 "wrist": articulated-body inertia and bias force through it
  const Real x1388 = x251 * x1109 - x255 * x1110 + 0.3627935462750979 * x1111;
  const Real x1356 = x229 * x1106 + 0.9143434820629502 * tau[6] + x233 * x1107;
  const Real x1421 = x1370 + 0.3707213992782555 * x1382 - 0.04639300360872268 * x1375 + x816;
  // joint 3 "shoulder": articulated-body inertia and bias force through it
  const Real x1578 = x106 * x1436 + x109 * x1439;
  const Real x1581 = x106 * x1439 + x109 * x1451;
  const Real x1698 = x119 * x1647 - x114 * x1641 + 0.9128709291752769 * x1653;
  const Real x1428 = x1426 * (tau[5] - x1421);
  const Real x1532 = x119 * x1494 - x114 * x1491 + 0.9128709291752769 * x1497;
  const Real x1568 = x119 * x1517 - x114 * x1513 + 0.9128709291752769 * x1521;
  const Real x1705 = x123 * x1641 - x127 * x1647 - 0.36514837167011077 * x1653;
  const Real x1617 = x123 * (x123 * x1436 - x127 * x1439);
  const Real x1725 = x1532 - 0.02 * x1698;
  const Real x1731 = x1568 + 0.15 * x1698;
  const Real x1484 = x207 * 0.07887204828074391 + x824 + x1375 + x1414 * x1428;
  const Real x1486 = x200 * 0.07887204828074391 + x833 + x1382 + x1415 * x1428;
  // link 4 "boom": bias force in the reference field
  const Real x769 = x206 * 0.012234548981428322 + x767 - (x203 - x196) * 0.0022896193017263246;
  const Real x788 = x201 * 0.012234548981428322 - x785 - 0.01829609650863162 * (x192 - x203);
  // joint 4 "wrist": articulated-body inertia and bias force through it
  const Real x1364 = x246 * x1107 - (x240 * x1106 + 0.17988007001927067 * tau[6]);
  // link 4 "boom": bias force in the reference field
  const Real x806 = x182 * 0.05274151989202157 - x176 * 0.07887204828074391 + x769;
  const Real x811 = x170 * 0.07887204828074391 - x182 * 0.42145169602159566 + x788;
  // joint 3 "shoulder": articulated-body inertia and bias force through it
  const Real x1539 = x123 * x1491 - x127 * x1494 - 0.36514837167011077 * x1497;
  const Real x1734 = x1539 - 0.02 * x1705;
  const Real x1575 = x123 * x1513 - x127 * x1517 - 0.36514837167011077 * x1521;
  const Real x1740 = x1575 + 0.15 * x1705;
  const Real x1620 = x1617 - x127 * (x123 * x1439 - x127 * x1451);
  const Real x1488 = x842 - x203 * 0.07887204828074391 + x1388 + x1288 * x1428;
  const Real x1685 = x119 * x1630 - x114 * x1625 + 0.9128709291752769 * x1635;
  const Real x1745 = x106 * x1578 + x109 * x1581 - 0.02 * x1532;
  // joint 4 "wrist": articulated-body inertia and bias force through it
  const Real x1419 = x1356 + 0.04639300360872268 * x1388 - 0.06937819061732105 * x1382 + x806;
  // joint 3 "shoulder": articulated-body inertia and bias force through it
  const Real x1480 = x1419 + x1406 * x1428;
  const Real x1526 = x106 * x1491 + x109 * x1494 + 0.18257418583505539 * x1497;
  const Real x1562 = x106 * x1513 + x109 * x1517 + 0.18257418583505539 * x1521;
  const Real x1758 = x123 * x1578 - x127 * x1581 - 0.02 * x1568;
  // joint 4 "wrist": articulated-body inertia and bias force through it
  const Real x1420 = x1364 + 0.06937819061732105 * x1375 - 0.3707213992782555 * x1388 + x811;
  // joint 3 "shoulder": articulated-body inertia and bias force through it
  const Real x1482 = x1420 + x1410 * x1428;
  const Real x1816 = x123 * x1484 - x127 * x1486 - 0.36514837167011077 * x1488;
  const Real x1809 = x119 * x1486 - x114 * x1484 + 0.9128709291752769 * x1488;
  // joint 2 "lift": articulated-body inertia and bias force through it
  const Real x1848 = x1705 * x1841;
  const Real x1844 = x1734 * x1841;
  const Real x1846 = x1740 * x1841;
  // joint 3 "shoulder": articulated-body inertia and bias force through it
  const Real x1830 = x1620 + 0.15 * x1568 + 0.15 * x1731 + 0.047740000000000005;
  // joint 2 "lift": articulated-body inertia and bias force through it
  const Real x1878 = x1830 - x1740 * x1846;
  const Real x1893 = 4.2 + x1698 - x1705 * x1848;
  const Real x1949 = 0.9987502603949663 * (x1685 - x1692 * x1848);
  const Real x1851 = x1745 - 0.02 * x1725 + 0.02086 - x1734 * x1844;
  const Real x1904 = 0.9987502603949663 * (0.336 + x1731 - x1740 * x1848);
  const Real x1907 = x1904 - 0.04997916927067833 * (x1725 - x1734 * x1848);
  // joint 1 "laser_spin": articulated-body inertia and bias force through it
  const Real x2135 = x1887 - 0.04997916927067833 * (0.04997916927067833 * x1887) + 35.5 + 0.35;
  require_more(w, x2135, 0.0, kFactorization, 0);
  // joint 0 "drive": articulated-body inertia and bias force through it
  const Real x2147 = 1 / x2135;
  const Real x2148 = x1949 * x2147;
  // joint 4 "wrist": placement, velocity and reference acceleration of its link
  const Real x347 = x277 * x277;
  const Real x350 = x262 * x269;
  const Real x293 = x149 * 0.17988007001927067 - x147 * 0.9143434820629502;
  // link 2 "laser": bias force in the reference field
  const Real x682 = (cosine[1] * x29 + x14 * sine[1]) * 0.35;
  const Real x684 = (sine[1] * x29 - x14 * cosine[1]) * 0.35;
  // joint 3 "shoulder": articulated-body inertia and bias force through it
  const Real x1798 = x123 * x1480 - 0.36514837167011077 * tau[5] - x127 * x1482;
  const Real x1803 = x106 * x1484 + x109 * x1486 + 0.18257418583505539 * x1488;
  const Real x1785 = x106 * x1480 + 0.18257418583505539 * tau[5] + x109 * x1482;
  // joint 2 "lift": articulated-body inertia and bias force through it
  const Real x1842 = tau[4] - (x70 * 4.2 - x87 * 0.336 + x1816);
  const Real x1843 = x1841 * x1842;
  const Real x1915 = 0.04997916927067833 * (x1526 - 0.02 * x1685 - x1734 * x1847);
  const Real x1917 = 0.9987502603949663 * (x1562 + 0.15 * x1685 - x1740 * x1847);
  const Real x1937 = (0.15 * x1725 + x1758 - x1734 * x1846) * 1.9975005207899326;
  const Real x1976 = x1907 + x57 * x1893;
  // joint 3 "shoulder": articulated-body inertia and bias force through it
  const Real x1837 = x74 * 4.2 - x83 * 0.336 + x1803;
  // joint 2 "lift": articulated-body inertia and bias force through it
  const Real x1967 = x57 * x1949 - 0.9987502603949663 * (x1915 - x1917);
  // joint 3 "shoulder": articulated-body inertia and bias force through it
  const Real x1836 = x1798 + 0.15 * x1809 + x80 * 0.336;
  // joint 2 "lift": articulated-body inertia and bias force through it
  const Real x1945 = x1878 - 0.04997916927067833 * (0.04997916927067833 * (x1878 - x1851) + x1937);
  const Real x1903 = x80 * 4.2 + x1809 + x1705 * x1843;
  const Real x2032 = 0.04997916927067833 * (x1785 - 0.02 * x1809 + x1734 * x1843);
  const Real x2044 = 0.04997916927067833 * tau[4] + 0.9987502603949663 * (x1837 + x1692 * x1843);
  const Real x2034 = 0.9987502603949663 * (x1836 + x1740 * x1843) - x2032;
  // joint 1 "laser_spin": articulated-body inertia and bias force through it
  const Real x2136 = 35.5 + x1893 + 0.35;
  const Real x2111 = cosine[1] * x684 - sine[1] * x682;
  // joint 2 "lift": articulated-body inertia and bias force through it
  const Real x2061 = x57 * x1907 + x57 * x1976 + x1945 + 1.4699288717103012;
  // joint 1 "laser_spin": articulated-body inertia and bias force through it
  const Real x2133 = x2061 + 0.01694;
  // joint 2 "lift": articulated-body inertia and bias force through it
  const Real x2069 = x15 * 0.9938046806644694 - x12 * 35.5 + x2044;
  const Real x2068 = x2034 + x57 * x1903 - x14 * 0.9938046806644694;
  // joint 0 "drive": articulated-body inertia and bias force through it
  const Real x2152 = x2136 - x1949 * x2148;
  const Real x2156 = 1 / x2152;
  const Real x2149 = x1967 * x2147;
  const Real x2155 = -0.9938046806644694 + x1976 + 0.077 - x1967 * x2148;
  const Real x2157 = x2155 * x2156;
  const Real x2167 = tau[0] - (x2069 - (cosine[1] * x682 + sine[1] * x684));
  const Real x2163 = x2133 - x1967 * x2149 - x2155 * x2157;
  // joint 5 "loose": placement, velocity and reference acceleration of its link
  const Real x493 = x262 * x446 + x269 * x464 + x277 * x476;
  const Real x498 = x262 * x454 + x269 * x467 + x277 * x482;
  const Real x503 = x262 * x461 + x269 * x470 + x277 * x488;
  const Real x544 = (x350 - x293) * x431 - (x346 + x347) * x427;
  const Real x551 = (x293 + x350) * x427 - (x345 + x347) * x431;
  const Real x504 = v[10] + x493;
  const Real x505 = v[11] + x498;
  const Real x506 = v[12] + x503;
  const Real x546 = x362 * x439 + x544 + x329;
  const Real x553 = x356 * x439 + x551 + x335;
  const Real x558 = (x298 + x360) * x427 - x358 * x439;
  const Real x512 = x295 * x446 + x293 * x476 - x298 * x464;
  const Real x529 = v[12] * x498 - v[11] * x503 + x512;
  const Real x518 = x295 * x454 + x293 * x482 - x298 * x467;
  const Real x534 = v[10] * x503 - v[12] * x493 + x518;
  const Real x524 = x295 * x461 + x293 * x488 - x298 * x470;
  const Real x539 = v[11] * x493 - v[10] * x498 + x524;
  // joint 0 "drive": articulated-body inertia and bias force through it
  const Real x2168 = tau[1] - (x14 * 35.5 + x1903 - x2111);
  const Real x2172 = x2168 - x2148 * x2167;
  const Real x2169 = tau[2] - (x2068 - (tau[3] + 0.22 * x2111));
  const Real x2181 = 1 / x2163 * (x2169 - x2149 * x2167 - x2157 * x2172);
  w.result[2] = x2181;
  const Real x2184 = x2156 * x2172 - x2157 * x2181;
  w.result[1] = x2184;
  const Real x2190 = x2147 * x2167 - x2149 * x2181 - x2148 * x2184;
  w.result[0] = x2190;
  // joint 2 "lift": its acceleration, and that of the link beyond
  const Real x2281 = 0.04997916927067833 * x2181;
  const Real x2280 = 0.9987502603949663 * x2181;
  const Real x2279 = x2184 + x57 * x2181;
  const Real x2284 = 0.9987502603949663 * x2190;
  const Real x2294 = x1843 + x1844 * x2281 - x1846 * x2280;
  const Real x2296 = x2294 - x1848 * x2279 - x1847 * x2284;
  // joint 3 "shoulder": its acceleration, and that of the link beyond
  const Real x2304 = 0.02 * x2281 + 0.15 * x2280 + x2279;
  const Real x2308 = x123 * x2280 - x106 * x2281;
  // joint 5 "loose": placement, velocity and reference acceleration of its link
  const Real x560 = (x295 + x355) * x431 + x558 + x341;
  const Real x576 = 2.0 * x493;
  const Real x577 = 2.0 * x498;
  const Real x578 = 2.0 * x503;
  const Real x614 = x504 * x505;
  const Real x619 = x505 * x506;
  const Real x624 = x504 * x506;
  const Real x609 = x504 * x504;
  const Real x610 = x505 * x505;
  const Real x611 = x506 * x506;
  const Real x615 = x614 - x539;
  const Real x625 = x624 - x534;
  const Real x612 = x610 + x611;
  const Real x616 = x539 + x614;
  const Real x617 = x609 + x611;
  const Real x620 = x619 - x529;
  const Real x621 = x529 + x619;
  const Real x622 = x609 + x610;
  const Real x565 = x446 * x546 + x464 * x553 + x476 * x560;
  const Real x570 = x454 * x546 + x467 * x553 + x482 * x560;
  const Real x575 = x461 * x546 + x470 * x553 + x488 * x560;
  const Real x626 = x534 + x624;
  // joint 3 "shoulder": its acceleration, and that of the link beyond
  const Real x2313 = x109 * x2281 + x127 * x2280;
  const Real x2326 = x106 * x2284 - x114 * x2304 + x123 * x2296;
  const Real x2332 = x109 * x2284 + x119 * x2304 - x127 * x2296;
  // joint 5 "loose": placement, velocity and reference acceleration of its link
  const Real x583 = v[9] * x577 - v[8] * x578 + x565;
  const Real x598 = v[9] * v[11] - v[8] * v[12] + x583;
  const Real x588 = v[7] * x578 - v[9] * x576 + x570;
  const Real x603 = v[7] * v[12] - v[9] * v[10] + x588;
  const Real x593 = v[8] * x576 - v[7] * x577 + x575;
  const Real x608 = v[8] * v[10] - v[7] * v[11] + x593;
  // link 6 "load": bias force in the reference field
  const Real x921 = x529 * 0.000975 + x619 * 0.00010500000000000002 - x625 * 0.00012;
  const Real x934 = x534 * 0.0007949999999999999 + x624 * 7.499999999999998e-05 - x615 * 0.00017999999999999998;
  const Real x948 = x539 * 0.0009 - x614 * 0.00018 + x620 * 8.999999999999999e-05;
  const Real x923 = x921 - x616 * 8.999999999999999e-05 + 0.00017999999999999998 * (x622 - x617);
  const Real x936 = x621 * 0.00012 + x934 - 8.999999999999999e-05 * (x612 - x622);
  const Real x975 = x626 * 0.009 - (x612 * 0.006 + x615 * 0.012);
  const Real x983 = x616 * 0.006 + x617 * 0.012 + x620 * 0.009;
  const Real x950 = x626 * 0.00017999999999999998 + x948 + 0.00012 * (x617 - x612);
  const Real x992 = x625 * 0.006 - x622 * 0.009 - x621 * 0.012;
  // joint 5 "loose": articulated-body inertia and bias force through it
  const Real x1075 = x476 * tau[10] + x482 * tau[11] + x488 * tau[12];
  const Real x1105 = x1075 + x427 * x1085 - x431 * x1080;
  const Real x1013 = tau[7] - (x598 * 0.6 + x975);
  const Real x1014 = tau[8] - (x603 * 0.6 + x983);
  const Real x1015 = tau[9] - (x608 * 0.6 + x992);
  const Real x1016 = tau[10] - (x923 - x608 * 0.012 - x603 * 0.009);
  const Real x1017 = tau[11] - (x936 + x598 * 0.009 - x608 * 0.006);
  // joint 4 "wrist": articulated-body inertia and bias force through it
  const Real x1114 = tau[6] - (x293 * 0.0021075 + x350 * 0.0017325 + x1105);
  const Real x1115 = 474.4958481613286 * x1114;
  // joint 3 "shoulder": its acceleration, and that of the link beyond
  const Real x2338 = 0.18257418583505539 * x2284 + 0.9128709291752769 * x2304 - 0.36514837167011077 * x2296;
  const Real x2350 = x1428 - x1429 * x2308 + x1430 * x2313;
  const Real x2352 = x2350 - x1431 * x2326 - x1432 * x2332;
  const Real x2353 = x2352 - x1433 * x2338;
  // joint 4 "wrist": its acceleration, and that of the link beyond
  const Real x2363 = x2326 - 0.06937819061732105 * x2313 - 0.04639300360872268 * x2353;
  const Real x2375 = 0.3707213992782555 * x2313 + 0.04639300360872268 * x2308 + x2338;
  const Real x2369 = x2332 - 0.06937819061732105 * x2308 + 0.3707213992782555 * x2353;
  const Real x2381 = x229 * x2308 + x240 * x2313 + x251 * x2353;
  const Real x2388 = x233 * x2308 - x246 * x2313 - x255 * x2353;
  // joint 5 "loose": articulated-body inertia and bias force through it
  const Real x1018 = tau[12] - (x950 + x603 * 0.006 + x598 * 0.012);
  const Real x1040 = 1666.6666666666667 * (x1016 + 0.015 * x1014 + 0.02 * x1015);
  const Real x1041 = 1666.6666666666667 * (x1017 - 0.015 * x1013 + 0.01 * x1015);
  const Real x1042 = 1666.6666666666667 * (x1018 - 0.02 * x1013 - 0.01 * x1014);
  // joint 0 "drive": articulated-body inertia and bias force through it
  const Real x2165 = 1.7763568394002505e-15 * x2136;
  require_more(w, x2152, x2165, kFactorization, 0);
  const Real x2166 = 1.7763568394002505e-15 * x2133;
  require_more(w, x2163, x2166, kFactorization, 0);
  // joint 1 "laser_spin": its acceleration, and that of the link beyond
  const Real x2274 = tau[3] * 3571.4285714285716 + x2181;
  w.result[3] = x2274;
  // joint 2 "lift": its acceleration, and that of the link beyond
  const Real x2297 = x2296 - 0.04997916927067833 * x2190;
  w.result[4] = x2297;
  // joint 3 "shoulder": its acceleration, and that of the link beyond
  const Real x2354 = 0.18257418583505539 * x2281 + 0.36514837167011077 * x2280 + x2353;
  w.result[5] = x2354;
  // joint 4 "wrist": its acceleration, and that of the link beyond
  const Real x2394 = 0.9143434820629502 * x2308 + 0.17988007001927067 * x2313 + 0.3627935462750979 * x2353;
  const Real x2413 = x1115 - x2394;
  w.result[6] = x2413;
  const Real x2400 = x229 * x2363 + x251 * x2375 - x240 * x2369;
  // joint 5 "loose": its acceleration, and that of the link beyond
  const Real x2422 = x439 * x2388 - x431 * x1115 + x2400;
  // joint 4 "wrist": its acceleration, and that of the link beyond
  const Real x2406 = x233 * x2363 - x255 * x2375 + x246 * x2369;
  // joint 5 "loose": its acceleration, and that of the link beyond
  const Real x2428 = x427 * x1115 - x439 * x2381 + x2406;
  // joint 4 "wrist": its acceleration, and that of the link beyond
  const Real x2412 = 0.9143434820629502 * x2363 + 0.3627935462750979 * x2375 - 0.17988007001927067 * x2369;
  // joint 5 "loose": its acceleration, and that of the link beyond
  const Real x2434 = x431 * x2381 - x427 * x2388 + x2412;
  // joint 5 "loose": articulated-body inertia and bias force through it
  const Real x1060 = 1.6666666666666667 * x1013 - 0.015 * x1041 - 0.02 * x1042;
  // joint 5 "loose": its acceleration, and that of the link beyond
  const Real x2454 = x446 * x2422 + x464 * x2428 + x476 * x2434;
  const Real x2465 = x1060 - x2454;
  w.result[7] = x2465;
  // joint 5 "loose": articulated-body inertia and bias force through it
  const Real x1054 = 1.6666666666666667 * x1014 + 0.015 * x1040 - 0.01 * x1042;
  // joint 5 "loose": its acceleration, and that of the link beyond
  const Real x2459 = x454 * x2422 + x467 * x2428 + x482 * x2434;
  const Real x2466 = x1054 - x2459;
  w.result[8] = x2466;
  // joint 5 "loose": articulated-body inertia and bias force through it
  const Real x1048 = 1.6666666666666667 * x1015 + 0.02 * x1040 + 0.01 * x1041;
  // joint 5 "loose": its acceleration, and that of the link beyond
  const Real x2464 = x461 * x2422 + x470 * x2428 + x488 * x2434;
  const Real x2467 = x1048 - x2464;
  w.result[9] = x2467;
  const Real x2439 = x446 * x2381 + x476 * x1115 + x464 * x2388;
  const Real x2468 = x1040 - x2439;
  w.result[10] = x2468;
  const Real x2444 = x454 * x2381 + x482 * x1115 + x467 * x2388;
  const Real x2469 = x1041 - x2444;
  w.result[11] = x2469;
  const Real x2449 = x461 * x2381 + x488 * x1115 + x470 * x2388;
  const Real x2470 = x1042 - x2449;
  w.result[12] = x2470;
}

// ---- processes ----------------------------------------------------------------------------------

// Process 0: 6 of 6 joints: "drive", "laser_spin", "lift", "shoulder", "wrist", "loose"
constexpr std::array<int, 6> kRead_0{0, 1, 2, 3, 4, 5};
constexpr std::array<int, 6> kOwned_0{0, 1, 2, 3, 4, 5};
constexpr std::array<int, 4> kAngles_0{2, 3, 5, 6};

ADAGEN_AS_IT_STANDS void run_0([[maybe_unused]] Workspace& w, [[maybe_unused]] Channel& channel) {
  ADAGEN_INPUTS
  if (!all(unlike_zero(q + 0, 3) + unlike_zero(v + 3, 1) == 0))
    name_what_is_not_finite(w, kRead_0, kOwned_0);
  take_sines_and_cosines(q, kAngles_0, w.sine.data(), w.cosine.data());
  part_0_0(w);
  stamp(1);
  stamp(2);
  stamp(3);
  if (__builtin_expect(w.status != kFine || !all(unlike_zero(w.result.data() + 0, 13) == 0), 0)) {
    find_fault(w, kRead_0, kOwned_0);
  }
  if (w.status != kFine) return;
  std::copy_n(w.result.data() + 0, 13, w.qdd + 0);
}


}  // namespace

[[maybe_unused]] constexpr std::array<StageInfo, 3> kStages_0{ {{"kinematics", 5, -1}, {"assembly", 0, -1}, {"disassembly", 0, -1}} };

#include "adagen/whole_alone.hpp"
