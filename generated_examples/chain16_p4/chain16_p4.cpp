// Forward dynamics of "chain16" on 4 processes, emitted by adagen 0.1.0 (solver.cpp.j2). Do not edit: emit anew.
//
// robot     "chain16", 16 joints, 16 degrees of freedom, description sha256 b739552da6e27ec438b5eb7d6da98218430542949a453e8cd1010513e6e26b8a
// command   adagen ../models/chain16.urdf --procs 4 --form=ada --channel=message
// options   form ada, shape joints, scalar double, channel message, fixed base, gravity 0.0, 0.0, -9.81
// links     adagen_program.cpp -DADAGEN_MPI
// program   4 processes, joined at cuts; 2.61 us predicted (default profile)
//           process 0: joint01 .. joint06, joint10
//           process 1: joint07 .. joint09
//           process 2: joint11 .. joint14
//           process 3: joint15 .. joint16
// schedule  joint10@0-3(joint06@0-1(joint05@0(joint04(joint03(joint02(joint01|)|)|)|) | joint07@1(|joint08(|joint09))) | joint14@2-3(joint11@2(|joint12(|joint13)) | joint15@3(|joint16)))
// licence   yours to choose: what adagen emits belongs to whoever emits it
//
// The assembly-disassembly algorithm of Yamane and Nakamura. Phi are inverse articulated-body inertias, b
// bias accelerations. Joint i joins chain A (its parent link's side) and chain B (its child link's side)
// to chain C: assembly, Eq. (3)-(7), goes up the schedule, disassembly, Eq. (8)-(10), comes down. Spatial
// vectors are [angular; linear], in link frames turned so that every joint axis is z.
//
// How to read on:
//   1. interface   what a program that links this file calls
//   2. model       the robot's constants
//   3. runtime     spatial algebra, joints, exchange between processes
//   4. joints      for each joint its memory, then what is done with it, step by step
//   5. processes   who does what, in order
//   6. program     what the program around it, adagen_program.cpp, is told; main

// ---- 1. interface -------------------------------------------------------------------------------
// To use it from a program of yours: compile this file with -DADAGEN_NO_MAIN and link it; chain16_p4.h
// beside it is this part.
// C interface of the solver chain16_p4: forward dynamics of "chain16" on 4 processes,
// emitted by adagen 0.1.0 (interface.h.j2). Do not edit: emit anew.
#ifndef ADAGEN_CHAIN16_P4_H
#define ADAGEN_CHAIN16_P4_H

#include <mpi.h>

enum {
  CHAIN16_P4_PROCESSES = 4,
  CHAIN16_P4_JOINTS = 16,
  CHAIN16_P4_NQ = 16,  // numbers in q
  CHAIN16_P4_NV = 16,  // in v and qdd
  CHAIN16_P4_NTAU = 16  // in tau
};

// Where each joint begins in q, and in v, tau and qdd.
enum {
  CHAIN16_P4_Q_joint01 = 0,
  CHAIN16_P4_V_joint01 = 0,  // joint 0, "joint01": revolute, 1 in q, 1 in v
  CHAIN16_P4_Q_joint02 = 1,
  CHAIN16_P4_V_joint02 = 1,  // joint 1, "joint02": revolute, 1 in q, 1 in v
  CHAIN16_P4_Q_joint03 = 2,
  CHAIN16_P4_V_joint03 = 2,  // joint 2, "joint03": revolute, 1 in q, 1 in v
  CHAIN16_P4_Q_joint04 = 3,
  CHAIN16_P4_V_joint04 = 3,  // joint 3, "joint04": revolute, 1 in q, 1 in v
  CHAIN16_P4_Q_joint05 = 4,
  CHAIN16_P4_V_joint05 = 4,  // joint 4, "joint05": revolute, 1 in q, 1 in v
  CHAIN16_P4_Q_joint06 = 5,
  CHAIN16_P4_V_joint06 = 5,  // joint 5, "joint06": revolute, 1 in q, 1 in v
  CHAIN16_P4_Q_joint07 = 6,
  CHAIN16_P4_V_joint07 = 6,  // joint 6, "joint07": revolute, 1 in q, 1 in v
  CHAIN16_P4_Q_joint08 = 7,
  CHAIN16_P4_V_joint08 = 7,  // joint 7, "joint08": revolute, 1 in q, 1 in v
  CHAIN16_P4_Q_joint09 = 8,
  CHAIN16_P4_V_joint09 = 8,  // joint 8, "joint09": revolute, 1 in q, 1 in v
  CHAIN16_P4_Q_joint10 = 9,
  CHAIN16_P4_V_joint10 = 9,  // joint 9, "joint10": revolute, 1 in q, 1 in v
  CHAIN16_P4_Q_joint11 = 10,
  CHAIN16_P4_V_joint11 = 10,  // joint 10, "joint11": revolute, 1 in q, 1 in v
  CHAIN16_P4_Q_joint12 = 11,
  CHAIN16_P4_V_joint12 = 11,  // joint 11, "joint12": revolute, 1 in q, 1 in v
  CHAIN16_P4_Q_joint13 = 12,
  CHAIN16_P4_V_joint13 = 12,  // joint 12, "joint13": revolute, 1 in q, 1 in v
  CHAIN16_P4_Q_joint14 = 13,
  CHAIN16_P4_V_joint14 = 13,  // joint 13, "joint14": revolute, 1 in q, 1 in v
  CHAIN16_P4_Q_joint15 = 14,
  CHAIN16_P4_V_joint15 = 14,  // joint 14, "joint15": revolute, 1 in q, 1 in v
  CHAIN16_P4_Q_joint16 = 15,
  CHAIN16_P4_V_joint16 = 15  // joint 15, "joint16": revolute, 1 in q, 1 in v
};

// Why a call failed, as chain16_p4_reason tells of the status that it returned.
enum {
  CHAIN16_P4_FINE = 0,  // none
  CHAIN16_P4_NOT_FINITE = 1,  // q, v or tau of a joint is not a finite number
  CHAIN16_P4_ZERO_QUATERNION = 2,  // a joint's quaternion cannot be normalised
  CHAIN16_P4_FACTORIZATION = 3,  // inertias beside a joint differ too much for the scalar
  CHAIN16_P4_OVERFLOW = 4,  // a joint's acceleration is not a finite number
  CHAIN16_P4_NO_ANSWER = 5,  // a process did not answer within the time limit
  CHAIN16_P4_ENDED = 6,  // process 0 has ended the evaluations
  CHAIN16_P4_NOT_REFINED = 7,  // refinement does not converge
  CHAIN16_P4_GIMBAL_LOCK = 8,  // joints that are joined as one do not move in as many directions
  CHAIN16_P4_GROWTH = 9,  // a link beside a joint is too light for its neighbours
  CHAIN16_P4_NOT_SET = 16,  // what is to be set at run time is not finite, or is no mass
  CHAIN16_P4_TOO_FEW_STEPS = 11,  // refinement converges too slowly
  CHAIN16_P4_LOOP_OPEN = 12,  // a loop or coupling is not closed in this configuration
  CHAIN16_P4_LOOP_TORN = 13,  // this velocity tears a loop or coupling open
  CHAIN16_P4_LOOP_SINGULAR = 14,  // what a loop holds changes in this pose
  CHAIN16_P4_LOOP_FREE = 15  // loops leave a joint a motion that no inertia resists
};

#ifdef __cplusplus
extern "C" {
#endif
typedef struct chain16_p4_solver chain16_p4_solver;

// Joints in order, each with its place in the state: gives name, start and size in q and v of joint
// k, or returns 0 where there is none.
int chain16_p4_joint(int k, const char** name, int* q, int* nq, int* v, int* nv);

// Collective over a communicator of 4 processes. channel: "auto", "window" (shared memory) or
// "message"; time_limit: seconds that a process waits for another. Returns null where it cannot be
// done; chain16_p4_failure(NULL) says why.
chain16_p4_solver* chain16_p4_open(MPI_Comm comm, const char* channel, double time_limit);

// One evaluation, collective. q: 16 numbers, v and tau: 16 each, qdd: 16; joints in order, quaternions
// x y z w (normalised here), floating joints [linear; angular] in the body's frame.
// solve: every process passes the state and gets its own joints' accelerations (others untouched);
// solve_at_root: process 0 passes the state and gets them all, the others may pass null, or serve.
// Returns 0, or a status that chain16_p4_failure puts into words; no acceleration is written then.
int chain16_p4_solve(chain16_p4_solver* solver, const double* q, const double* v, const double* tau, double* qdd);
int chain16_p4_solve_at_root(chain16_p4_solver* solver, const double* q, const double* v, const double* tau, double* qdd);

// What every process but 0 can do all the time: takes part in each solve_at_root of process 0, however
// long that lets it wait, until process 0 ends it. Returns 0, or why it cannot go on.
int chain16_p4_serve(chain16_p4_solver* solver);

// At process 0: the others' serve returns. They may serve again, or all close.
int chain16_p4_end(chain16_p4_solver* solver);

// What a status says: its reason, and which joint it is about, -1 for none.
int chain16_p4_reason(int status);
int chain16_p4_failed_joint(int status);

// The last failure of a solver in words, valid until the next call; of null, why the last open of this
// thread returned null.
const char* chain16_p4_failure(const chain16_p4_solver* solver);

// Collective.
void chain16_p4_close(chain16_p4_solver* solver);
#ifdef __cplusplus
}
#endif
#endif

#include <algorithm>
#include <array>
#include <atomic>
#include <chrono>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <cstring>
#include <exception>
#include <limits>
#include <memory>
#include <new>
#include <string>
#include <thread>
#include <type_traits>
#include <utility>
#include <vector>

#include <Eigen/Core>
#include <Eigen/Geometry>
#include <Eigen/LU>

#define ADAGEN_NOINLINE [[maybe_unused]] __attribute__((noinline))
// A counted loop that is to be unrolled whole, so that indices computed in it become constants.
#if defined(__clang__)
#define ADAGEN_FOR(k, first, last) _Pragma("clang loop unroll(full)") for (int k = first; k < last; ++k)
#else
#define ADAGEN_FOR(k, first, last) _Pragma("GCC unroll 16") for (int k = first; k < last; ++k)
#endif

namespace {

using Number = double;  // of states, answers and messages
using Real = double;    // of all between
constexpr int kProcesses = 4;
[[maybe_unused]] constexpr bool kAlone = false;  // whether process 0 does all, and no other takes part
constexpr int kJointCount = 16, kLinkCount = kJointCount + 1;
constexpr int kNq = 16, kNv = 16;
constexpr int kOuterCount = 0, kNtau = kNv + 6 * kOuterCount;
constexpr int kNqdd = 16;
[[maybe_unused]] constexpr int kColumns = 1;  // right-hand sides: the motion, and one per slaved joint
[[maybe_unused]] constexpr std::size_t kSlavedCount = 0;  // joints that follow others
[[maybe_unused]] constexpr bool kBatch = false;  // whether many states are solved at once
[[maybe_unused]] constexpr int kRefine = 0;  // steps of iterative refinement
[[maybe_unused]] constexpr int kPlanMessages = 6;
constexpr std::size_t kCacheLine = 64, kTextSize = 1000;
[[maybe_unused]] constexpr double kTolerance = 1e-09;
const MPI_Datatype kMpiNumber = MPI_DOUBLE;

// ---- 2. model -----------------------------------------------------------------------------------

enum class JointKind { kRevolute, kPrismatic, kSpherical, kPlanar, kFloating };

// What a joint does by itself: of its torque, damping qd + friction tanh(qd / friction_speed)
// + stiffness (q - rest) + rotor qdd do not reach the links. Where its acceleration is prescribed,
// tau holds that.
struct Passive {
  Number damping = 0, friction = 0, friction_speed = 1, stiffness = 0, rest = 0, rotor = 0;
  bool prescribed = false;
};

// A joint's frame is turned so that its axis is z (a planar joint's normal, too); the child link
// has the joint's frame at q = 0.
struct JointConstants {
  const char* name;
  JointKind kind;
  int parent;             // parent link; the child link has the joint's number plus one
  int q, nq, v, nv;       // where its configuration and velocity are
  Number rotation[9];     // joint frame to parent link's frame, row by row
  Number translation[3];  // origin of the joint frame in the parent link's frame, m
  int source;             // joint that it is slaved to, or -1: q = multiplier q_source + offset
  double multiplier, offset;
  Passive passive{};
};

// An outer force that is an input, told in the frame of the link that has its name.
struct OuterForce {
  const char* name;
  int link;               // that feels it
  Number rotation[9];     // from that frame to the link's, row by row
  Number translation[3];  // its origin in the link's frame, m
};

struct LinkConstants {
  const char* name;
  Number mass;               // kg
  Number com[3];             // centre of mass, m
  Number tensor[9];          // rotational inertia about it, kg m^2
  Number tensor_inverse[9];  // J, its inverse
};

// Entries first .. first + count - 1 of a vector.
struct Range {
  int first, count;
};
struct Ranges {
  int count;
  const Range* ranges;
};

// What a process reads of the state, and which velocity entries' accelerations it owns.
struct ProcessInfo {
  Ranges q, v, own, tau;
};

// What goes from one process to another once in an evaluation.
struct MessageInfo {
  int source, target, size;  // size in Number, the status not counted
};

[[maybe_unused]] constexpr std::array<double, 3> kGravity{0.0, 0.0, -9.81};  // m/s^2

constexpr std::array<LinkConstants, kLinkCount> kLinks{ {
    {"ceiling", 0.0, {0.0, 0.0, 0.0},
     {0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0},
     {}},
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
     {74.44187206419866, 0.0, 0.0, 0.0, 5000.0, 0.0, 0.0, 0.0, 74.44187206419866}},
} };

constexpr std::array<JointConstants, kJointCount> kJoints{ {
    {"joint01", JointKind::kRevolute, 0, 0, 1, 0, 1,
     {0.0, 0.0, 1.0, 1.0, 0.0, 0.0, 0.0, 1.0, 0.0},
     {0.0, 0.0, 0.0}, -1, 0.0, 0.0},
    {"joint02", JointKind::kRevolute, 1, 1, 1, 1, 1,
     {0.0, 0.0, 1.0, 1.0, 0.0, 0.0, 0.0, 1.0, 0.0},
     {0.0, -0.4, 0.0}, -1, 0.0, 0.0},
    {"joint03", JointKind::kRevolute, 2, 2, 1, 2, 1,
     {0.0, 0.0, 1.0, 1.0, 0.0, 0.0, 0.0, 1.0, 0.0},
     {-0.4, 0.0, 0.0}, -1, 0.0, 0.0},
    {"joint04", JointKind::kRevolute, 3, 3, 1, 3, 1,
     {0.0, 0.0, 1.0, 1.0, 0.0, 0.0, 0.0, 1.0, 0.0},
     {0.0, 0.0, -0.4}, -1, 0.0, 0.0},
    {"joint05", JointKind::kRevolute, 4, 4, 1, 4, 1,
     {0.0, 0.0, 1.0, 1.0, 0.0, 0.0, 0.0, 1.0, 0.0},
     {0.0, -0.4, 0.0}, -1, 0.0, 0.0},
    {"joint06", JointKind::kRevolute, 5, 5, 1, 5, 1,
     {0.0, 0.0, 1.0, 1.0, 0.0, 0.0, 0.0, 1.0, 0.0},
     {-0.4, 0.0, 0.0}, -1, 0.0, 0.0},
    {"joint07", JointKind::kRevolute, 6, 6, 1, 6, 1,
     {0.0, 0.0, 1.0, 1.0, 0.0, 0.0, 0.0, 1.0, 0.0},
     {0.0, 0.0, -0.4}, -1, 0.0, 0.0},
    {"joint08", JointKind::kRevolute, 7, 7, 1, 7, 1,
     {0.0, 0.0, 1.0, 1.0, 0.0, 0.0, 0.0, 1.0, 0.0},
     {0.0, -0.4, 0.0}, -1, 0.0, 0.0},
    {"joint09", JointKind::kRevolute, 8, 8, 1, 8, 1,
     {0.0, 0.0, 1.0, 1.0, 0.0, 0.0, 0.0, 1.0, 0.0},
     {-0.4, 0.0, 0.0}, -1, 0.0, 0.0},
    {"joint10", JointKind::kRevolute, 9, 9, 1, 9, 1,
     {0.0, 0.0, 1.0, 1.0, 0.0, 0.0, 0.0, 1.0, 0.0},
     {0.0, 0.0, -0.4}, -1, 0.0, 0.0},
    {"joint11", JointKind::kRevolute, 10, 10, 1, 10, 1,
     {0.0, 0.0, 1.0, 1.0, 0.0, 0.0, 0.0, 1.0, 0.0},
     {0.0, -0.4, 0.0}, -1, 0.0, 0.0},
    {"joint12", JointKind::kRevolute, 11, 11, 1, 11, 1,
     {0.0, 0.0, 1.0, 1.0, 0.0, 0.0, 0.0, 1.0, 0.0},
     {-0.4, 0.0, 0.0}, -1, 0.0, 0.0},
    {"joint13", JointKind::kRevolute, 12, 12, 1, 12, 1,
     {0.0, 0.0, 1.0, 1.0, 0.0, 0.0, 0.0, 1.0, 0.0},
     {0.0, 0.0, -0.4}, -1, 0.0, 0.0},
    {"joint14", JointKind::kRevolute, 13, 13, 1, 13, 1,
     {0.0, 0.0, 1.0, 1.0, 0.0, 0.0, 0.0, 1.0, 0.0},
     {0.0, -0.4, 0.0}, -1, 0.0, 0.0},
    {"joint15", JointKind::kRevolute, 14, 14, 1, 14, 1,
     {0.0, 0.0, 1.0, 1.0, 0.0, 0.0, 0.0, 1.0, 0.0},
     {-0.4, 0.0, 0.0}, -1, 0.0, 0.0},
    {"joint16", JointKind::kRevolute, 15, 15, 1, 15, 1,
     {0.0, 0.0, 1.0, 1.0, 0.0, 0.0, 0.0, 1.0, 0.0},
     {0.0, 0.0, -0.4}, -1, 0.0, 0.0},
} };

[[maybe_unused]] constexpr std::array<OuterForce, kOuterCount> kOuterForces{};

// Slaved joints follow their sources; what was given for them is ignored.
template <class Joints, class Value>
void slave(const Joints& joints, [[maybe_unused]] Value* q, [[maybe_unused]] Value* v) {
  for (const auto& joint : joints) {
    if (joint.source < 0) continue;
    const auto& source = joints[joint.source];
    q[joint.q] = static_cast<Value>(joint.multiplier * double(q[source.q]) + joint.offset);
    v[joint.v] = static_cast<Value>(joint.multiplier * double(v[source.v]));
  }
}

// ---- 3. runtime ---------------------------------------------------------------------------------

// Spatial vectors are [angular; linear], in link frames. A right-hand side has kColumns columns:
// the motion itself, and one for each slaved joint's coupling torque.
using Vec3 = Eigen::Matrix<Real, 3, 1>;
using Mat3 = Eigen::Matrix<Real, 3, 3>;
using Vec6 = Eigen::Matrix<Real, 6, 1>;
using Mat6 = Eigen::Matrix<Real, 6, 6>;
using Columns6 = Eigen::Matrix<Real, 6, kColumns>;

// Motion transform X = [[E, 0], [-E rx, E]] from the parent link's to the child link's frame.
struct Transform {
  Mat3 E;  // rotates parent coordinates into child coordinates
  Vec3 r;  // origin of the child frame in parent coordinates

  template <class M>
  void times(const M& m, M& result) const {
    for (int k = 0; k < M::ColsAtCompileTime; ++k) {
      const Vec3 angular = m.col(k).template head<3>();
      const Vec3 linear = m.col(k).template tail<3>();
      result.col(k).template head<3>().noalias() = E * angular;
      result.col(k).template tail<3>().noalias() = E * (linear - r.cross(angular));
    }
  }

  // X^T m: takes a wrench on the child to the same wrench on the parent.
  Columns6 transposed_times(const Columns6& m) const {
    Columns6 result;
    for (int k = 0; k < kColumns; ++k) {
      const Vec3 force = E.transpose() * m.col(k).template tail<3>();
      result.col(k).template head<3>() =
          E.transpose() * m.col(k).template head<3>() + r.cross(force);
      result.col(k).template tail<3>() = force;
    }
    return result;
  }
};

ADAGEN_NOINLINE Mat6 operator*(const Transform& X, const Mat6& m) {
  Mat6 result;
  X.times(m, result);
  return result;
}

ADAGEN_NOINLINE Mat6 times_transposed(const Transform& X, const Mat6& m) {
  Mat6 transposed, result;
  transposed.noalias() = m.transpose();
  X.times(transposed, result);
  return result;
}

// m X^T, which is (X m^T)^T: with m = X Phi the congruence X Phi X^T.
ADAGEN_NOINLINE Mat6 from_right(const Mat6& m, const Transform& X) {
  Mat6 result = times_transposed(X, m);
  result.transposeInPlace();
  return result;
}

template <int columns>
Eigen::Matrix<Real, 6, columns> operator*(const Transform& X,
                                          const Eigen::Matrix<Real, 6, columns>& m) {
  Eigen::Matrix<Real, 6, columns> result;
  X.times(m, result);
  return result;
}

// Phi = I^-1 of a bare link at its origin, from its upper triangle row by row.
[[maybe_unused]] Mat6 symmetric(const std::array<Real, 21>& upper) {
  Mat6 result;
  std::size_t k = 0;
  for (int i = 0; i < 6; ++i)
    for (int j = i; j < 6; ++j) result(i, j) = result(j, i) = upper[k++];
  return result;
}

// Rotation of a unit quaternion's conjugate: parent coordinates into child coordinates. The
// quaternion (x, y, z, w) is normalised here; its squared length is returned, to be checked.
[[maybe_unused]] Real conjugate_rotation(const Number* quaternion, Mat3& E) {
  const Real x = Real(quaternion[0]), y = Real(quaternion[1]);
  const Real z = Real(quaternion[2]), w = Real(quaternion[3]);
  const Real squared = x * x + y * y + z * z + w * w;
  const Real s = 2 / squared;
  E << 1 - s * (y * y + z * z), s * (x * y + z * w), s * (x * z - y * w),  //
      s * (x * y - z * w), 1 - s * (x * x + z * z), s * (y * z + x * w),   //
      s * (x * z + y * w), s * (y * z - x * w), 1 - s * (x * x + y * y);
  return squared;
}

// b of a bare link: its acceleration (relative to free fall) when nothing acts on it.
ADAGEN_NOINLINE void link_bias(const LinkConstants& link, const Vec6& velocity, Columns6& b) {
  using Constant3 = Eigen::Map<const Eigen::Matrix<Number, 3, 3, Eigen::RowMajor>>;
  const Vec3 omega = velocity.head<3>(), v = velocity.tail<3>();
  const Vec3 c(Real(link.com[0]), Real(link.com[1]), Real(link.com[2]));
  const Vec3 momentum = Constant3(link.tensor).cast<Real>() * omega;
  const Vec3 alpha = Constant3(link.tensor_inverse).cast<Real>() * momentum.cross(omega);
  b.setZero();
  b.col(0).template head<3>() = alpha;
  b.col(0).template tail<3>() = c.cross(alpha) - omega.cross(omega.cross(c) + v);
}

// What can go wrong in an evaluation. A status travels with every message, so that all processes
// learn of a failure and none waits for an answer that cannot come. It must be exact in a float.
enum Failure : int {
  kFine = 0,
  kNotFinite = 1,       // the state of a joint is not a finite number
  kZeroQuaternion = 2,  // the orientation of a joint is a quaternion of no length, or of too much
  kFactorization = 3,   // V^-1 of a joint is not positive definite
  kOverflow = 4,        // the acceleration of a joint is not a finite number
  kGimbalLock = 8,      // joints that are joined as one do not move in as many directions
  kGrowth = 9,          // a link's mobility beside a joint is lost to its neighbours
  kSingularPose = 10,   // no failure: the evaluation is done again in another way
  kLoopOpen = 12,       // a loop or coupling is open (numbered behind all joints)
  kLoopTorn = 13,       // its velocity tears it open
  kLoopSingular = 14,   // what it holds cannot be told from this pose
  kLoopFree = 15,       // loops leave a joint a motion that nothing resists
  kNoAnswer = 5,        // a process did not answer in time (numbered in place of a joint)
  kEnded = 6,           // no failure: process 0 has no more to evaluate
  kNotRefined = 7,      // a correction is as large as the one before: refinement does not converge
  kTooFewSteps = 11,    // refinement converges, but has not reached the digits that it owes
  kNotSet = 16,         // what is to be set at run time is not finite, or is no mass
};

constexpr int kFailureBase = 1 << 20;
[[maybe_unused]] constexpr int failure(Failure kind, int joint) {
  return kind * kFailureBase + joint;
}
constexpr Failure failure_kind(int status) { return static_cast<Failure>(status / kFailureBase); }
[[maybe_unused]] constexpr int failure_place(int status) { return status % kFailureBase; }

// Words without memory from the heap; what is too long is cut.
class Text {
 public:
  Text() = default;
  explicit Text(const char* words) { *this += words; }
  Text& operator+=(char c) {
    if (size_ + 1 < sizeof data_) data_[size_++] = c, data_[size_] = '\0';
    return *this;
  }
  Text& operator+=(const char* more) {
    for (; *more != '\0'; ++more) *this += *more;
    return *this;
  }
  Text& operator+=(int number) {
    if (number < 0) *this += '-';
    long rest = number < 0 ? -static_cast<long>(number) : number, unit = 1;
    while (rest / unit > 9) unit *= 10;
    for (; unit > 0; unit /= 10) *this += static_cast<char>('0' + rest / unit % 10);
    return *this;
  }
  const char* c_str() const { return data_; }
  bool empty() const { return size_ == 0; }
  void clear() { data_[size_ = 0] = '\0'; }

 private:
  std::size_t size_ = 0;
  char data_[kTextSize] = "";
};

// Adds text as a JSON string, in one line.
template <class Words>
void add_quoted(Words& to, const char* text) {
  to += '"';
  for (; *text != '\0'; ++text) {
    const unsigned char c = static_cast<unsigned char>(*text);
    if (c == '"' || c == '\\') {
      to += '\\';
      to += *text;
    } else if (c < 0x20 || c == 0x7F) {
      const char* const digits = "0123456789abcdef";
      to += "\\u00";
      to += digits[c / 16];
      to += digits[c % 16];
    } else {
      to += *text;
    }
  }
  to += '"';
}

// Adds the names of a joint and of those before it that it is joined with: the links between them
// have neither mass nor inertia.
void add_names_of_run(Text& to, int joint) {
  const int link = kJoints[joint].parent;
  const LinkConstants& own = kLinks[link];
  if (link > 0 && !(own.mass > 0 || own.tensor[0] + own.tensor[4] + own.tensor[8] > 0)) {
    add_names_of_run(to, link - 1);
    to += ", ";
  }
  add_quoted(to, kJoints[joint].name);
}

// A failure in words, about a joint or not.
struct FailureWords {
  bool of_joint;
  const char* text;
};

constexpr FailureWords words_of(Failure kind) {
  switch (kind) {
    case kFine:
      return {false, "no error"};
    case kNotFinite:
      return {true, "its q, v or tau is not a finite number"};
    case kZeroQuaternion:
      return {true, "its quaternion cannot be normalised"};
    case kFactorization:
      return {true, "factorization failed: the inertias beside it differ too much for the scalar"};
    case kGimbalLock:
      return {false,
              "gimbal lock: through links without mass, they do not move in as many directions"};
    case kGrowth:
      return {true,
              "no digits left: a link beside it is too light for its neighbours and the scalar"};
    case kOverflow:
      return {true, "its acceleration is not a finite number (overflow)"};
    case kSingularPose:
      return {true, "its mobility is singular in this pose"};
    case kEnded:
      return {false, "the evaluations are over"};
    case kNotRefined:
      return {false, "refinement does not converge: the inertias differ too much for the scalar"};
    case kTooFewSteps:
      return {false,
              "refinement converges too slowly: its last correction is too large; take more steps "
              "(--refine) or --scalar double"};
    case kLoopOpen:
      return {false, "it is not closed in this configuration, by more than its tolerance"};
    case kLoopTorn:
      return {false, "this velocity tears it open"};
    case kLoopSingular:
      return {false, "this pose is singular: what it holds, and what it leaves free, changes here"};
    case kLoopFree:
      return {true, "closed loops leave it a motion that no inertia resists"};
    case kNotSet:
      return {false, "what is to be set at run time is not finite, or is no mass"};
    case kNoAnswer:
      return {false, " did not answer within the time limit"};
  }
  return {false, "unknown failure"};
}

// Whether a failure is numbered with a loop or coupling, behind all joints.
[[maybe_unused]] constexpr bool is_of_loop(Failure kind) {
  return kind == kLoopOpen || kind == kLoopTorn || kind == kLoopSingular;
}

// Whether a failure is numbered with a joint.
constexpr bool is_of_joint(Failure kind) { return words_of(kind).of_joint || kind == kGimbalLock; }

Text describe(int status) {
  const Failure kind = failure_kind(status);
  const FailureWords words = words_of(kind);
  Text text;
  if (words.of_joint) {
    text += "joint ";
    add_quoted(text, kJoints[failure_place(status)].name);
    text += ": ";
  } else if (kind == kGimbalLock) {
    text += "joints ";
    add_names_of_run(text, failure_place(status));
    text += ": ";
#ifdef ADAGEN_LOOPS
  } else if (is_of_loop(kind)) {
    const int place = failure_place(status) - static_cast<int>(kJoints.size());
    text += place < kLoopCount ? "loop " : "coupling ";
    add_quoted(text, kLoopNames[static_cast<std::size_t>(place)]);
    text += ": ";
#endif
  } else if (kind == kNoAnswer) {
    text += "process ";
    text += failure_place(status);
  }
  text += words.text;
  return text;
}

// Joint kinds in their canonical frames: the rows of a spatial vector that a joint frees (R, S) and
// those it constrains (N). Both are selections, so N and R cost nothing and round nothing.
template <int... Rows>
struct Selection {
  static constexpr int count = sizeof...(Rows);
  static constexpr std::array<int, sizeof...(Rows)> row{Rows...};
};

struct Revolute {
  using Free = Selection<2>;
  using Constrained = Selection<0, 1, 3, 4, 5>;
};
struct Prismatic {
  using Free = Selection<5>;
  using Constrained = Selection<0, 1, 2, 3, 4>;
};
struct Spherical {
  using Free = Selection<0, 1, 2>;
  using Constrained = Selection<3, 4, 5>;
};
struct Planar {
  using Free = Selection<3, 4, 2>;
  using Constrained = Selection<0, 1, 5>;
};
struct Floating {
  using Free = Selection<3, 4, 5, 0, 1, 2>;
  using Constrained = Selection<>;
};

template <class Kind>
[[maybe_unused]] constexpr int kFree = Kind::Free::count;
template <class Kind>
[[maybe_unused]] constexpr int kConstrained = Kind::Constrained::count;

// S qd, the velocity across a joint.
template <class Kind>
Vec6 joint_velocity(const Number* qd) {
  Vec6 result = Vec6::Zero();
  for (int k = 0; k < kFree<Kind>; ++k) result[Kind::Free::row[k]] = Real(qd[k]);
  return result;
}

// c_i = v_i x S qd, the part of the acceleration across a joint that qdd has no say in.
template <class Kind>
Columns6 velocity_product(const Vec6& velocity, const Number* qd) {
  const Vec6 motion = joint_velocity<Kind>(qd);
  Columns6 result = Columns6::Zero();
  result.col(0).template head<3>() = velocity.head<3>().cross(motion.head<3>());
  result.col(0).template tail<3>() =
      velocity.head<3>().cross(motion.tail<3>()) + velocity.tail<3>().cross(motion.head<3>());
  return result;
}

// What disassembly needs of a joint i that was assembled.
template <class Kind>
struct Joined {
  static constexpr int n = kFree<Kind>, m = kConstrained<Kind>;
  std::array<std::array<Real, m>, m> L;         // Cholesky factor of V_i^-1; its diagonal inverted
  std::array<std::array<Real, m>, n> RPN;       // R_i (Phi_Ai + Phi_Bi) N_i^T
  std::array<std::array<Real, kColumns>, m> z;  // L^-1 N_i beta_i
  std::array<std::array<Real, kColumns>, n> R_beta;  // R_i beta_i
  std::array<std::array<Real, kColumns>, n> tau;
};

// How a joint i and a handle j of one chain feel each other: Z = L^-1 N_i Phi_ij, Y = R_i Phi_ij.
template <class Kind>
struct Coupled {
  std::array<std::array<Real, 6>, kConstrained<Kind>> Z;
  std::array<std::array<Real, 6>, kFree<Kind>> Y;
};

// x <- L^-1 x, row by row.
template <std::size_t m, std::size_t k>
void forward_substitute(const std::array<std::array<Real, m>, m>& L,
                        std::array<std::array<Real, k>, m>& x) {
  for (std::size_t i = 0; i < m; ++i) {
    for (std::size_t j = 0; j < i; ++j)
      for (std::size_t c = 0; c < k; ++c) x[i][c] -= L[i][j] * x[j][c];
    for (std::size_t c = 0; c < k; ++c) x[i][c] *= L[i][i];
  }
}

// x <- L^-T x.
template <std::size_t m, std::size_t k>
void backward_substitute(const std::array<std::array<Real, m>, m>& L,
                         std::array<std::array<Real, k>, m>& x) {
  for (std::size_t i = m; i-- > 0;) {
    for (std::size_t c = 0; c < k; ++c) x[i][c] *= L[i][i];
    for (std::size_t j = 0; j < i; ++j)
      for (std::size_t c = 0; c < k; ++c) x[j][c] -= L[i][j] * x[i][c];
  }
}

// Cholesky's factorization in place, the inverse of the diagonal in its place. False where a pivot
// has lost every digit, or was none to begin with.
template <std::size_t m>
bool factorize(std::array<std::array<Real, m>, m>& L) {
  bool good = true;
  for (std::size_t j = 0; j < m; ++j) {
    Real pivot = L[j][j];
    const Real least = 8 * std::numeric_limits<Real>::epsilon() * pivot;
    for (std::size_t k = 0; k < j; ++k) pivot -= L[j][k] * L[j][k];
    good = good && pivot > least && pivot <= std::numeric_limits<Real>::max();
    const Real inverse = 1 / std::sqrt(pivot);
    L[j][j] = inverse;
    for (std::size_t i = j + 1; i < m; ++i) {
      for (std::size_t k = 0; k < j; ++k) L[i][j] -= L[i][k] * L[j][k];
      L[i][j] *= inverse;
    }
  }
  return good;
}

// Whether M = N (Phi_A + Phi_B) N^T keeps digits. Phi - Z^T Z of earlier joins has taken away most
// of a light link's mobility, with a rounding error of eps times what the bare link had: least, for
// each row, is 64 eps times that.
template <class Kind>
bool keeps_digits(const Mat6& Phi_A, const Mat6& Phi_B, const std::array<Real, 6>& least) {
  bool good = true;
  for (int k : Kind::Constrained::row)
    good = good && Phi_A(k, k) + Phi_B(k, k) > least[static_cast<std::size_t>(k)];
  return good;
}

// V_i and beta_i of Eq. (3)-(7): Phi_A and Phi_B are those of the joint's two sides in its frame,
// b_A, b_B and c the accelerations there. Returns false where the factorization fails.
template <class Kind>
ADAGEN_NOINLINE bool join(Joined<Kind>& i, const Mat6& Phi_A, const Mat6& Phi_B,
                          const Columns6& b_A, const Columns6& b_B, const Columns6& c) {
  constexpr int n = kFree<Kind>, m = kConstrained<Kind>;
  constexpr auto& free = Kind::Free::row;
  [[maybe_unused]] constexpr auto& constrained = Kind::Constrained::row;
  const Mat6 Phi = Phi_A + Phi_B;
  Columns6 beta = b_A - b_B + c;
  for (int k = 0; k < n; ++k)
    for (int column = 0; column < kColumns; ++column)
      beta.col(column) -= Phi.col(free[k]) * i.tau[k][column];
  for (int row = 0; row < n; ++row) {
    for (int column = 0; column < kColumns; ++column)
      i.R_beta[row][column] = beta(free[row], column);
    for (int k = 0; k < m; ++k) i.RPN[row][k] = Phi(free[row], constrained[k]);
  }
  if constexpr (m > 0) {
    for (int row = 0; row < m; ++row) {
      for (int k = 0; k <= row; ++k) i.L[row][k] = Phi(constrained[row], constrained[k]);
      for (int column = 0; column < kColumns; ++column)
        i.z[row][column] = beta(constrained[row], column);
    }
    const bool good = factorize(i.L);
    forward_substitute(i.L, i.z);
    return good;
  }
  return true;
}

// Z and Y of a handle j, Phi_ij being given with the joint's frame on its left.
template <class Kind>
ADAGEN_NOINLINE void couple(const Joined<Kind>& i, const Mat6& Phi_ij, Coupled<Kind>& j) {
  for (int row = 0; row < kFree<Kind>; ++row)
    for (int k = 0; k < 6; ++k) j.Y[row][k] = Phi_ij(Kind::Free::row[row], k);
  if constexpr (kConstrained<Kind> > 0) {
    for (int row = 0; row < kConstrained<Kind>; ++row)
      for (int k = 0; k < 6; ++k) j.Z[row][k] = Phi_ij(Kind::Constrained::row[row], k);
    forward_substitute(i.L, j.Z);
  }
}

// Phi_Aji W_i Phi_Aik = Z_j^T Z_k: what Eq. (3) and (4) subtract and Eq. (5) is.
template <class Kind>
ADAGEN_NOINLINE Mat6 product([[maybe_unused]] const Coupled<Kind>& j,
                             [[maybe_unused]] const Coupled<Kind>& k) {
  Mat6 result = Mat6::Zero();
  if constexpr (kConstrained<Kind> > 0) {
    for (int row = 0; row < kConstrained<Kind>; ++row) {
      const Vec6 left = Eigen::Map<const Vec6>(j.Z[row].data());
      const Vec6 right = Eigen::Map<const Vec6>(k.Z[row].data());
      result.noalias() += left * right.transpose();
    }
  }
  return result;
}

// Phi_ji gamma_i = Z^T z + Y^T tau: the change of b_j in Eq. (6) and (7).
template <class Kind>
Columns6 bias_change(const Joined<Kind>& i, const Coupled<Kind>& j) {
  Columns6 result = Columns6::Zero();
  for (int column = 0; column < kColumns; ++column) {
    for (int row = 0; row < kConstrained<Kind>; ++row)
      result.col(column) += Eigen::Map<const Vec6>(j.Z[row].data()) * i.z[row][column];
    for (int row = 0; row < kFree<Kind>; ++row)
      result.col(column) += Eigen::Map<const Vec6>(j.Y[row].data()) * i.tau[row][column];
  }
  return result;
}

// Disassembly of a joint: collects what the outer forces do to it, then gives its acceleration and
// its force.
template <class Kind>
class Release {
 public:
  explicit Release(const Joined<Kind>& i) : i_(i), z_(i.z), qdd_(i.R_beta) {
    for (auto& row : qdd_)
      for (Real& x : row) x = -x;
  }

  void feel_A(const Coupled<Kind>& j, const Columns6& f) { feel(j, f, Real(1)); }
  void feel_B(const Coupled<Kind>& k, const Columns6& f) { feel(k, f, Real(-1)); }

  // f_i, Eq. (10); on the way n_i, Eq. (8), and qdd_i, Eq. (9).
  Columns6 force() {
    if constexpr (kConstrained<Kind> > 0) backward_substitute(i_.L, z_);
    Columns6 f;
    for (int column = 0; column < kColumns; ++column) {
      for (int k = 0; k < kConstrained<Kind>; ++k)
        f(Kind::Constrained::row[k], column) = z_[k][column];
      for (int k = 0; k < kFree<Kind>; ++k) {
        f(Kind::Free::row[k], column) = i_.tau[k][column];
        for (int l = 0; l < kConstrained<Kind>; ++l)
          qdd_[k][column] += i_.RPN[k][l] * z_[l][column];
      }
    }
    return f;
  }

  const std::array<std::array<Real, kColumns>, kFree<Kind>>& qdd() const { return qdd_; }

 private:
  void feel(const Coupled<Kind>& j, const Columns6& f, Real sign) {
    for (int column = 0; column < kColumns; ++column) {
      const Vec6 signed_f = sign * f.col(column);
      for (int row = 0; row < kConstrained<Kind>; ++row)
        z_[row][column] += Eigen::Map<const Vec6>(j.Z[row].data()).dot(signed_f);
      for (int row = 0; row < kFree<Kind>; ++row)
        qdd_[row][column] -= Eigen::Map<const Vec6>(j.Y[row].data()).dot(signed_f);
    }
  }

  const Joined<Kind>& i_;
  std::array<std::array<Real, kColumns>, kConstrained<Kind>> z_;
  std::array<std::array<Real, kColumns>, kFree<Kind>> qdd_;
};

constexpr std::array<MessageInfo, 12> kMessages{ {
    {1, 0, 120},  // 0: assembled: chain of "joint07"
    {3, 2, 42},  // 1: assembled: chain of "joint15"
    {2, 0, 42},  // 2: assembled: chain of "joint14"
    {0, 2, 6},  // 3: forces on: chain of "joint14"
    {0, 1, 12},  // 4: forces on: chain of "joint07"
    {2, 3, 6},  // 5: forces on: chain of "joint15"
    {0, 1, 21},  // 6: state
    {1, 0, 3},  // 7: accelerations
    {0, 2, 32},  // 8: state
    {2, 0, 4},  // 9: accelerations
    {0, 3, 34},  // 10: state
    {3, 0, 2},  // 11: accelerations
} };

enum class ChannelMode { kAuto, kWindow, kMessage };

inline void relax() {
#if defined(__x86_64__) || defined(__i386__)
  __builtin_ia32_pause();
#elif defined(__aarch64__)
  asm volatile("yield");
#endif
}

// What a process does in an evaluation as the others see it: the messages that it sends and
// receives, in order, and what those received hold. Played again, it computes the same by itself:
// what it sends goes nowhere, and what it receives is there at once. (--stretches)
class Take {
 public:
  using Clock = std::chrono::steady_clock;

  // Notes from here on what goes through the channel.
  void record() { playing_ = false; }

  // Plays from the start, and looks at the clock at each message.
  void play() {
    playing_ = true;
    next_ = 0;
  }

  bool playing() const { return playing_; }
  const std::vector<int>& messages() const { return messages_; }
  const std::vector<Clock::rep>& looks() const { return looks_; }  // one at each message

  // Message k was sent, or received with this content, its status before it.
  ADAGEN_NOINLINE void note(int k, const Number* content = nullptr) {
    messages_.push_back(k);
    looks_.push_back(0);
    starts_.push_back(contents_.size());
    const std::size_t size =
        content ? static_cast<std::size_t>(kMessages[static_cast<std::size_t>(k)].size) + 1 : 0;
    contents_.insert(contents_.end(), content, content + size);
  }

  // The next message is due; returns its content, if it is one received.
  ADAGEN_NOINLINE const Number* pass() {
    looks_[next_] = Clock::now().time_since_epoch().count();
    return contents_.data() + starts_[next_++];
  }

 private:
  bool playing_ = false;
  std::size_t next_ = 0;
  std::vector<int> messages_;
  std::vector<Clock::rep> looks_;
  std::vector<std::size_t> starts_;  // in contents_
  std::vector<Number> contents_;
};

// Exchange between processes. Processes on one node meet in a shared window: a message is a slot
// that its source fills and then numbers (release), and that its target reads once it sees the
// number (acquire). Other pairs exchange MPI messages. A message has two slots, taken in turn: when
// one is written again, two evaluations later, its target has answered in the one between.
class Channel {
 public:
  Channel() = default;
  Channel(const Channel&) = delete;
  Channel& operator=(const Channel&) = delete;

  // Collective. Returns an empty string, or what is wrong. hosts: if not 0, processes are taken to
  // be on so many hosts, in equal parts, whatever they share.
  std::string open(MPI_Comm comm, ChannelMode mode, double time_limit, int hosts = 0) {
    MPI_Comm_dup(comm, &comm_);
    MPI_Comm_rank(comm_, &rank_);
    time_limit_ = std::chrono::duration_cast<Clock::duration>(
        std::chrono::duration<double>(std::min(time_limit, 1e8)));
    ports_.resize(kMessages.size());
    find_node(hosts);
    const bool window = mode == ChannelMode::kMessage || open_window();
    std::array<int, 2> ways{};  // messages through MPI, through the window
    for (std::size_t k = 0; k < ports_.size(); ++k) {
      const MessageInfo& info = kMessages[k];
      if (info.source != rank_ && info.target != rank_) continue;
      if (info.size > 0) ++ways[ports_[k].slots ? 1 : 0];  // none goes to a process without work
      if (!ports_[k].slots) ports_[k].buffer.resize(static_cast<std::size_t>(info.size) + 1);
    }
    MPI_Allreduce(MPI_IN_PLACE, ways.data(), 2, MPI_INT, MPI_SUM, comm_);
    name_ = ways[0] == 0   ? (ways[1] == 0 ? "message" : "window")
            : ways[1] == 0 ? "message"
                           : "mixed";
    if (mode != ChannelMode::kWindow || ways[0] == 0) return "";
    return window ? "channel window: not all processes are on one node"
                  : "channel window: this MPI gives processes no common memory";
  }

  void close() {
    if (comm_ == MPI_COMM_NULL) return;
    int status = kFine;
    for (std::size_t k = 0; k < ports_.size(); ++k)  // what others still wait for gets there
      wait(ports_[k].request, kMessages[k].target, status);
    if (window_ != MPI_WIN_NULL) {
      MPI_Win_unlock_all(window_);
      MPI_Win_free(&window_);
    }
    if (node_ != MPI_COMM_NULL) MPI_Comm_free(&node_);
    MPI_Comm_free(&comm_);
  }

  // Where to write message k. Waits for an MPI message that is still under way.
  Number* outgoing(int k, int& status) {
    Port& port = ports_[k];
    if (port.slots) return port.slot(port.count + 1, k).content() + 1;
    wait(port.request, kMessages[k].target, status);
    return port.buffer.data() + 1;
  }

  void send(int k, int& status) {
    if (take_) {
      if (take_->playing()) return void(take_->pass());
      take_->note(k);
    }
    Port& port = ports_[k];
    if (port.slots) {
      Slot& slot = port.slot(++port.count, k);
      slot.content()[0] = static_cast<Number>(status);
      slot.number.store(port.count, std::memory_order_release);
      return;
    }
    port.buffer[0] = static_cast<Number>(status);
    MPI_Isend(port.buffer.data(), static_cast<int>(port.buffer.size()), kMpiNumber,
              kMessages[k].target, k, comm_, &port.request);
  }

  // Waits for message k, patient: however long it takes, and returns its content; what its source
  // knows of failures joins the status.
  const Number* receive(int k, int& status, bool patient = false) {
    if (take_ && take_->playing()) return opened(take_->pass(), status);
    Port& port = ports_[k];
    const Number* content;
    if (port.slots) {
      const std::uint64_t number = ++port.count;
      Slot& slot = port.slot(number, k);
      const auto is_there = [&] { return slot.number.load(std::memory_order_acquire) >= number; };
      if (!wait_until(is_there, patient)) fail(status, failure(kNoAnswer, kMessages[k].source));
      content = slot.content();
    } else {
      MPI_Irecv(port.buffer.data(), static_cast<int>(port.buffer.size()), kMpiNumber,
                kMessages[k].source, k, comm_, &port.request);
      wait(port.request, kMessages[k].source, status, [](const MPI_Status&) {}, patient);
      content = port.buffer.data();
    }
    if (take_) take_->note(k, content);
    return opened(content, status);
  }

  // Notes from here on what is sent and received, or plays it; null for neither.
  void use(Take* take) { take_ = take; }

  // Waits until a peer has done its part; then tells done of it. What never comes is given up.
  template <class Done>
  void wait(MPI_Request& request, int peer, int& status, Done done, bool patient = false) {
    if (request == MPI_REQUEST_NULL) return;
    MPI_Status found;
    const auto is_done = [&] {
      int flag = 0;
      MPI_Test(&request, &flag, &found);
      return flag != 0;
    };
    const bool in_time = wait_until(is_done, patient);
    if (in_time) return done(found);
    give_up(request);
    fail(status, failure(kNoAnswer, peer));
  }
  void wait(MPI_Request& request, int peer, int& status) {
    wait(request, peer, status, [](const MPI_Status&) {});
  }

  // To a process that has no part in evaluations: they are over. And there: waits for that, asleep.
  void send_end(int target) { MPI_Send(nullptr, 0, kMpiNumber, target, kEndTag, comm_); }
  void await_end() {
    MPI_Request over;
    MPI_Irecv(nullptr, 0, kMpiNumber, 0, kEndTag, comm_, &over);
    for (int done = 0; MPI_Test(&over, &done, MPI_STATUS_IGNORE), !done;)
      std::this_thread::sleep_for(std::chrono::milliseconds(1));
  }

  static void give_up(MPI_Request& request) {
    if (request != MPI_REQUEST_NULL) MPI_Cancel(&request), MPI_Request_free(&request);
  }

  static void fail(int& status, int failure) {
    if (status == kFine) status = failure;
  }

  MPI_Comm comm() const { return comm_; }
  int rank() const { return rank_; }
  bool broken() const { return broken_; }
  bool windowed() const { return window_ != MPI_WIN_NULL; }
  bool on_one_host() const { return on_one_host_; }
  const char* name() const { return name_; }

 private:
  using Clock = std::chrono::steady_clock;
  // Behind those of all other messages, in batches, too.
  static constexpr int kEndTag = static_cast<int>(kMessages.size()) + 3;
  static constexpr std::chrono::milliseconds kPatience{100};

  struct alignas(kCacheLine) Slot {
    std::atomic<std::uint64_t> number;
    Number* content() {
      return reinterpret_cast<Number*>(reinterpret_cast<char*>(this) + kCacheLine);
    }
  };

  struct Port {
    char* slots = nullptr;
    std::uint64_t count = 0;
    Slot& slot(std::uint64_t number, int k) const {
      return *reinterpret_cast<Slot*>(slots + (number & 1) * slot_bytes(kMessages[k]));
    }
    std::vector<Number> buffer;
    MPI_Request request = MPI_REQUEST_NULL;
  };

  static const Number* opened(const Number* content, int& status) {
    if (failure_kind(status) != kNoAnswer) fail(status, static_cast<int>(content[0]));
    return content + 1;
  }

  static std::size_t slot_bytes(const MessageInfo& info) {
    const std::size_t content = (static_cast<std::size_t>(info.size) + 1) * sizeof(Number);
    return kCacheLine + (content + kCacheLine - 1) / kCacheLine * kCacheLine;
  }

  void find_node(int hosts) {
    MPI_Comm real;
    MPI_Comm_split_type(comm_, MPI_COMM_TYPE_SHARED, 0, MPI_INFO_NULL, &real);
    MPI_Comm_split(real, rank_ * hosts / kProcesses, 0, &node_);
    MPI_Comm_free(&real);
    int size = 0;
    MPI_Comm_size(node_, &size);
    on_one_host_ = size == kProcesses;
  }

  // Each process holds the slots of the messages that it sends to processes on its node. Returns
  // whether there was memory to share.
  bool open_window() {
    std::vector<int> on_node(kProcesses, MPI_UNDEFINED), all(kProcesses);
    for (int p = 0; p < kProcesses; ++p) all[p] = p;
    MPI_Group whole, near;
    MPI_Comm_group(comm_, &whole);
    MPI_Comm_group(node_, &near);
    MPI_Group_translate_ranks(whole, kProcesses, all.data(), near, on_node.data());
    MPI_Group_free(&whole);
    MPI_Group_free(&near);
    const auto near_pair = [&](const MessageInfo& info) {
      return info.size > 0 && on_node[info.source] != MPI_UNDEFINED &&
             on_node[info.target] != MPI_UNDEFINED;
    };
    if (std::none_of(kMessages.begin(), kMessages.end(), near_pair)) return true;
    std::size_t own = 0;
    for (const MessageInfo& info : kMessages)
      if (info.source == rank_ && near_pair(info)) own += 2 * slot_bytes(info);
    if (!share_memory(own)) return false;
    std::vector<char*> next(kProcesses, nullptr);
    for (int p = 0; p < kProcesses; ++p) {
      if (on_node[p] == MPI_UNDEFINED) continue;
      MPI_Aint bytes;
      int unit;
      MPI_Win_shared_query(window_, on_node[p], &bytes, &unit, &next[p]);
    }
    for (std::size_t k = 0; k < ports_.size(); ++k) {
      const MessageInfo& info = kMessages[k];
      if (!near_pair(info)) continue;
      ports_[k].slots = next[info.source];
      next[info.source] += 2 * slot_bytes(info);
      if (info.source == rank_) {
        std::memset(ports_[k].slots, 0, 2 * slot_bytes(info));  // first touch
        for (std::uint64_t n : {0, 1}) new (&ports_[k].slot(n, static_cast<int>(k))) Slot{};
      }
    }
    MPI_Win_sync(window_);
    MPI_Barrier(node_);
    MPI_Win_sync(window_);
    return true;
  }

  // Returns whether all processes of the node could.
  bool share_memory(std::size_t own) {
    char* base = nullptr;
    MPI_Info hints;
    MPI_Info_create(&hints);
    MPI_Info_set(hints, "alloc_shared_noncontig",
                 "true");  // every part on pages of its own process
    MPI_Comm_set_errhandler(node_, MPI_ERRORS_RETURN);
    int good = MPI_Win_allocate_shared(static_cast<MPI_Aint>(own), 1, hints, node_, &base,
                                       &window_) == MPI_SUCCESS;
    MPI_Comm_set_errhandler(node_, MPI_ERRORS_ARE_FATAL);
    MPI_Info_free(&hints);
    MPI_Allreduce(MPI_IN_PLACE, &good, 1, MPI_INT, MPI_MIN, node_);
    if (good != 0)
      MPI_Win_lock_all(MPI_MODE_NOCHECK, window_);
    else
      window_ = MPI_WIN_NULL;
    return good != 0;
  }

  // Spins briefly, then yields, so that more processes than cores still finish. Who waits without
  // limit sleeps between looks once it has waited for long.
  template <class Ready>
  bool wait_until(Ready ready, bool patient) {
    for (int k = 0; k < 4000; ++k) {
      if (ready()) return true;
      relax();
    }
    if (broken_) return false;  // a peer is gone: do not wait for it once more
    const Clock::time_point end =
        Clock::now() + (patient ? Clock::duration(kPatience) : time_limit_);
    while (!ready()) {
      std::this_thread::yield();
      if (Clock::now() <= end) continue;
      if (patient) {
        std::this_thread::sleep_for(std::chrono::microseconds(50));
      } else {
        broken_ = true;
        return false;
      }
    }
    return true;
  }

  MPI_Comm comm_ = MPI_COMM_NULL, node_ = MPI_COMM_NULL;
  MPI_Win window_ = MPI_WIN_NULL;
  int rank_ = 0;
  Clock::duration time_limit_{};
  bool broken_ = false, on_one_host_ = true;
  Take* take_ = nullptr;
  const char* name_ = "message";
  std::vector<Port> ports_;
};

// Time stamps between the stages of a process's work (--trace); nothing is stamped otherwise.
std::chrono::steady_clock::rep* trace_stamps =
    nullptr;  // where an evaluation puts them: its start, then each end

[[maybe_unused]] inline void stamp(int k) {
  if (trace_stamps) trace_stamps[k] = std::chrono::steady_clock::now().time_since_epoch().count();
}

// ---- 4. joints ----------------------------------------------------------------------------------

// The memory of a process. Whatever belongs to a joint is kept with it.
struct Workspace;

struct Joint_joint01 {
  Transform X;  // parent link's to child link's frame
  Vec6 v;  // velocity of link "rod01"
  Columns6 b;  // bias of the bare link "rod01"
  Mat6 Phi_rod01;  // of the chain it completes
  Columns6 b_rod01;
  Joined<Revolute> joined;
  Coupled<Revolute> at_rod01;
  Columns6 F_on_rod01;  // outer wrench on that chain
};

struct Joint_joint02 {
  Transform X;  // parent link's to child link's frame
  Vec6 v;  // velocity of link "rod02"
  Columns6 b;  // bias of the bare link "rod02"
  Mat6 Phi_rod02;  // of the chain it completes
  Columns6 b_rod02;
  Joined<Revolute> joined;
  Coupled<Revolute> at_rod02;
  Columns6 F_on_rod02;  // outer wrench on that chain
};

struct Joint_joint03 {
  Transform X;  // parent link's to child link's frame
  Vec6 v;  // velocity of link "rod03"
  Columns6 b;  // bias of the bare link "rod03"
  Mat6 Phi_rod03;  // of the chain it completes
  Columns6 b_rod03;
  Joined<Revolute> joined;
  Coupled<Revolute> at_rod03;
  Columns6 F_on_rod03;  // outer wrench on that chain
};

struct Joint_joint04 {
  Transform X;  // parent link's to child link's frame
  Vec6 v;  // velocity of link "rod04"
  Columns6 b;  // bias of the bare link "rod04"
  Mat6 Phi_rod04;  // of the chain it completes
  Columns6 b_rod04;
  Joined<Revolute> joined;
  Coupled<Revolute> at_rod04;
  Columns6 F_on_rod04;  // outer wrench on that chain
};

struct Joint_joint05 {
  Transform X;  // parent link's to child link's frame
  Vec6 v;  // velocity of link "rod05"
  Columns6 b;  // bias of the bare link "rod05"
  Mat6 Phi_rod05;  // of the chain it completes
  Columns6 b_rod05;
  Joined<Revolute> joined;
  Coupled<Revolute> at_rod05;
  Columns6 F_on_rod05;  // outer wrench on that chain
};

struct Joint_joint06 {
  Transform X;  // parent link's to child link's frame
  Vec6 v;  // velocity of link "rod06"
  Mat6 Phi_rod09;  // of the chain it completes
  Columns6 b_rod09;
  Joined<Revolute> joined;
  Coupled<Revolute> at_rod09;
  Columns6 b;  // bias of the bare link "rod06"
  Columns6 F_on_rod09;  // outer wrench on that chain
};

struct Joint_joint07 {
  Transform X;  // parent link's to child link's frame
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
  Transform X;  // parent link's to child link's frame
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
  Transform X;  // parent link's to child link's frame
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
  Transform X;  // parent link's to child link's frame
  Vec6 v;  // velocity of link "rod10"
  Joined<Revolute> joined;
  Columns6 b;  // bias of the bare link "rod10"
};

struct Joint_joint11 {
  Transform X;  // parent link's to child link's frame
  Vec6 v;  // velocity of link "rod11"
  Columns6 b;  // bias of the bare link "rod11"
  Mat6 Phi_rod10;  // of the chain it completes
  Mat6 Phi_rod10_rod13;  // of the chain it completes
  Mat6 Phi_rod13;  // of the chain it completes
  Columns6 b_rod10;
  Columns6 b_rod13;
  Joined<Revolute> joined;
  Coupled<Revolute> at_rod10;
  Coupled<Revolute> at_rod13;
  Columns6 F_on_rod13;  // outer wrench on that chain
};

struct Joint_joint12 {
  Transform X;  // parent link's to child link's frame
  Vec6 v;  // velocity of link "rod12"
  Columns6 b;  // bias of the bare link "rod12"
  Mat6 Phi_rod11;  // of the chain it completes
  Mat6 Phi_rod11_rod13;  // of the chain it completes
  Mat6 Phi_rod13;  // of the chain it completes
  Columns6 b_rod11;
  Columns6 b_rod13;
  Joined<Revolute> joined;
  Coupled<Revolute> at_rod11;
  Coupled<Revolute> at_rod13;
  Columns6 F_on_rod11;  // outer wrench on that chain
};

struct Joint_joint13 {
  Transform X;  // parent link's to child link's frame
  Vec6 v;  // velocity of link "rod13"
  Columns6 b;  // bias of the bare link "rod13"
  Mat6 Phi_rod12;  // of the chain it completes
  Mat6 Phi_rod12_rod13;  // of the chain it completes
  Mat6 Phi_rod13;  // of the chain it completes
  Columns6 b_rod12;
  Columns6 b_rod13;
  Joined<Revolute> joined;
  Coupled<Revolute> at_rod12;
  Coupled<Revolute> at_rod13;
  Columns6 F_on_rod12;  // outer wrench on that chain
};

struct Joint_joint14 {
  Transform X;  // parent link's to child link's frame
  Vec6 v;  // velocity of link "rod14"
  Mat6 Phi_rod10;  // of the chain it completes
  Columns6 b_rod10;
  Joined<Revolute> joined;
  Coupled<Revolute> at_rod10;
  Columns6 b;  // bias of the bare link "rod14"
  Columns6 F_on_rod10;  // outer wrench on that chain
};

struct Joint_joint15 {
  Transform X;  // parent link's to child link's frame
  Vec6 v;  // velocity of link "rod15"
  Columns6 b;  // bias of the bare link "rod15"
  Mat6 Phi_rod14;  // of the chain it completes
  Columns6 b_rod14;
  Joined<Revolute> joined;
  Coupled<Revolute> at_rod14;
  Columns6 F_on_rod14;  // outer wrench on that chain
};

struct Joint_joint16 {
  Transform X;  // parent link's to child link's frame
  Vec6 v;  // velocity of link "rod16"
  Columns6 b;  // bias of the bare link "rod16"
  Mat6 Phi_rod15;  // of the chain it completes
  Columns6 b_rod15;
  Joined<Revolute> joined;
  Coupled<Revolute> at_rod15;
  Columns6 F_on_rod15;  // outer wrench on that chain
};

struct Workspace {
  const Number* q = nullptr;
  const Number* v = nullptr;
  const Number* tau = nullptr;
  Number* qdd = nullptr;
  int status = kFine;
  int near_lock = 0;  // 1 + the last joint of a run that has been near gimbal lock; 0: none
  Columns6 ground;  // its acceleration
  Joint_joint01 j_joint01;
  Joint_joint02 j_joint02;
  Joint_joint03 j_joint03;
  Joint_joint04 j_joint04;
  Joint_joint05 j_joint05;
  Joint_joint06 j_joint06;
  Joint_joint07 j_joint07;
  Joint_joint08 j_joint08;
  Joint_joint09 j_joint09;
  Joint_joint10 j_joint10;
  Joint_joint11 j_joint11;
  Joint_joint12 j_joint12;
  Joint_joint13 j_joint13;
  Joint_joint14 j_joint14;
  Joint_joint15 j_joint15;
  Joint_joint16 j_joint16;

  EIGEN_MAKE_ALIGNED_OPERATOR_NEW
};

inline double gravity(const Workspace&, int k) { return kGravity[static_cast<std::size_t>(k)]; }

inline void fail(Workspace& w, Failure kind, int joint) {
  Channel::fail(w.status, failure(kind, joint));
}

// x - x is zero for finite x only.
inline void require_finite(Workspace& w, const Number* x, int count, int joint) {
  Number sum = 0;
  for (int k = 0; k < count; ++k) sum += x[k] - x[k];
  if (!(sum == 0)) fail(w, kNotFinite, joint);
}

[[maybe_unused]] inline void require_length(Workspace& w, Real squared, int joint) {
  if (!(squared >= std::numeric_limits<Real>::min() && squared <= std::numeric_limits<Real>::max()))
    fail(w, kZeroQuaternion, joint);
}

template <std::size_t n>
void load_torque(Workspace& w, int joint, int v, std::array<std::array<Real, kColumns>, n>& tau) {
  require_finite(w, w.tau + v, static_cast<int>(n), joint);
  for (std::size_t k = 0; k < n; ++k) {
    tau[k] = {};
    tau[k][0] = Real(w.tau[v + static_cast<int>(k)]);
  }
}

// An acceleration is given only where all went well.
template <std::size_t n>
void store_acceleration(Workspace& w, int joint, int v,
                        const std::array<std::array<Real, kColumns>, n>& qdd) {
  Real sum = 0;
  for (std::size_t k = 0; k < n; ++k) sum += qdd[k][0] - qdd[k][0];
  if (!(sum == 0)) fail(w, kOverflow, joint);
  if (w.status != kFine) return;
  for (std::size_t k = 0; k < n; ++k) w.qdd[v + static_cast<int>(k)] = qdd[k][0];
}

const Mat6 kZero = Mat6::Zero();

// The ground accelerates against gravity: all accelerations are relative to free fall.
[[maybe_unused]] inline Columns6 ground(const Workspace& w) {
  Columns6 result = Columns6::Zero();
  for (int k = 0; k < 3; ++k) result(3 + k, 0) = -Real(gravity(w, k));
  return result;
}

// Accelerations of all right-hand sides, added up with the coupling torques.
template <std::size_t n, std::size_t m>
void store_coupled(Workspace& w, int joint, int v,
                   const std::array<std::array<Real, kColumns>, n>& qdd,
                   const std::array<Real, m>& torques) {
  std::array<std::array<Real, kColumns>, n> sum{};
  for (std::size_t k = 0; k < n; ++k) {
    sum[k][0] = qdd[k][0];
    for (std::size_t c = 0; c < m; ++c) sum[k][0] += qdd[k][c + 1] * torques[c];
  }
  store_acceleration(w, joint, v, sum);
}

// What goes into a message, and out of one.
template <class M>
Number* put(Number* to, const M& m) {
  Eigen::Map<Eigen::Matrix<Number, M::RowsAtCompileTime, M::ColsAtCompileTime>>{to} =
      m.template cast<Number>();
  return to + M::SizeAtCompileTime;
}

template <class M>
const Number* get(const Number* from, M& m) {
  using Content = Eigen::Matrix<Number, M::RowsAtCompileTime, M::ColsAtCompileTime>;
  m = Eigen::Map<const Content>(from).template cast<Real>();
  return from + M::SizeAtCompileTime;
}

template <std::size_t n>
Number* put(Number* to, const std::array<Real, n>& x) {
  return std::copy(x.begin(), x.end(), to);
}

template <std::size_t n>
const Number* get(const Number* from, std::array<Real, n>& x) {
  std::transform(from, from + n, x.begin(), [](Number value) { return Real(value); });
  return from + n;
}

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

// =================================================================================================
// Joint 0 "joint01": revolute, between links "ceiling" and "rod01"
// =================================================================================================

void kinematics_joint01(Workspace& w) {
  auto& i = w.j_joint01;
  require_finite(w, w.q + 0, 1, 0);
  require_finite(w, w.v + 0, 1, 0);
  const Real q = Real(w.q[0]);
  const Real c = std::cos(q), s = std::sin(q);
  i.X.E << 0.0, c, s,  //
      0.0, -s, c,  //
      1.0, 0.0, 0.0;
  i.X.r << 0.0, 0.0, 0.0;
  i.v = joint_velocity<Revolute>(w.v + 0);
}

// A: the ground "ceiling"; B: link "rod01"; C feels the joint at "rod01"
void assemble_joint01(Workspace& w) {
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

void disassemble_joint01(Workspace& w) {
  auto& i = w.j_joint01;
  Release<Revolute> release(i.joined);
  release.feel_B(i.at_rod01, w.j_joint01.F_on_rod01);
  release.force();  // Eq. (8)
  store_acceleration(w, 0, 0, release.qdd());  // Eq. (9)
}

// =================================================================================================
// Joint 1 "joint02": revolute, between links "rod01" and "rod02"
// =================================================================================================

void kinematics_joint02(Workspace& w) {
  auto& i = w.j_joint02;
  require_finite(w, w.q + 1, 1, 1);
  require_finite(w, w.v + 1, 1, 1);
  const Real q = Real(w.q[1]);
  const Real c = std::cos(q), s = std::sin(q);
  i.X.E << 0.0, c, s,  //
      0.0, -s, c,  //
      1.0, 0.0, 0.0;
  i.X.r << 0.0, -0.4, 0.0;
  i.v = i.X * w.j_joint01.v + joint_velocity<Revolute>(w.v + 1);
}

// A: the chain of "joint01"; B: link "rod02"; C feels the joint at "rod02"
void assemble_joint02(Workspace& w) {
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

void disassemble_joint02(Workspace& w) {
  auto& i = w.j_joint02;
  Release<Revolute> release(i.joined);
  release.feel_B(i.at_rod02, w.j_joint02.F_on_rod02);
  const Columns6 f = release.force();  // Eq. (8), (10)
  store_acceleration(w, 1, 1, release.qdd());  // Eq. (9)
  w.j_joint01.F_on_rod01 = -i.X.transposed_times(f);
}

// =================================================================================================
// Joint 2 "joint03": revolute, between links "rod02" and "rod03"
// =================================================================================================

void kinematics_joint03(Workspace& w) {
  auto& i = w.j_joint03;
  require_finite(w, w.q + 2, 1, 2);
  require_finite(w, w.v + 2, 1, 2);
  const Real q = Real(w.q[2]);
  const Real c = std::cos(q), s = std::sin(q);
  i.X.E << 0.0, c, s,  //
      0.0, -s, c,  //
      1.0, 0.0, 0.0;
  i.X.r << -0.4, 0.0, 0.0;
  i.v = i.X * w.j_joint02.v + joint_velocity<Revolute>(w.v + 2);
}

// A: the chain of "joint02"; B: link "rod03"; C feels the joint at "rod03"
void assemble_joint03(Workspace& w) {
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

void disassemble_joint03(Workspace& w) {
  auto& i = w.j_joint03;
  Release<Revolute> release(i.joined);
  release.feel_B(i.at_rod03, w.j_joint03.F_on_rod03);
  const Columns6 f = release.force();  // Eq. (8), (10)
  store_acceleration(w, 2, 2, release.qdd());  // Eq. (9)
  w.j_joint02.F_on_rod02 = -i.X.transposed_times(f);
}

// =================================================================================================
// Joint 3 "joint04": revolute, between links "rod03" and "rod04"
// =================================================================================================

void kinematics_joint04(Workspace& w) {
  auto& i = w.j_joint04;
  require_finite(w, w.q + 3, 1, 3);
  require_finite(w, w.v + 3, 1, 3);
  const Real q = Real(w.q[3]);
  const Real c = std::cos(q), s = std::sin(q);
  i.X.E << 0.0, c, s,  //
      0.0, -s, c,  //
      1.0, 0.0, 0.0;
  i.X.r << 0.0, 0.0, -0.4;
  i.v = i.X * w.j_joint03.v + joint_velocity<Revolute>(w.v + 3);
}

// A: the chain of "joint03"; B: link "rod04"; C feels the joint at "rod04"
void assemble_joint04(Workspace& w) {
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

void disassemble_joint04(Workspace& w) {
  auto& i = w.j_joint04;
  Release<Revolute> release(i.joined);
  release.feel_B(i.at_rod04, w.j_joint04.F_on_rod04);
  const Columns6 f = release.force();  // Eq. (8), (10)
  store_acceleration(w, 3, 3, release.qdd());  // Eq. (9)
  w.j_joint03.F_on_rod03 = -i.X.transposed_times(f);
}

// =================================================================================================
// Joint 4 "joint05": revolute, between links "rod04" and "rod05"
// =================================================================================================

void kinematics_joint05(Workspace& w) {
  auto& i = w.j_joint05;
  require_finite(w, w.q + 4, 1, 4);
  require_finite(w, w.v + 4, 1, 4);
  const Real q = Real(w.q[4]);
  const Real c = std::cos(q), s = std::sin(q);
  i.X.E << 0.0, c, s,  //
      0.0, -s, c,  //
      1.0, 0.0, 0.0;
  i.X.r << 0.0, -0.4, 0.0;
  i.v = i.X * w.j_joint04.v + joint_velocity<Revolute>(w.v + 4);
}

// A: the chain of "joint04"; B: link "rod05"; C feels the joint at "rod05"
void assemble_joint05(Workspace& w) {
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

void disassemble_joint05(Workspace& w) {
  auto& i = w.j_joint05;
  Release<Revolute> release(i.joined);
  release.feel_B(i.at_rod05, w.j_joint05.F_on_rod05);
  const Columns6 f = release.force();  // Eq. (8), (10)
  store_acceleration(w, 4, 4, release.qdd());  // Eq. (9)
  w.j_joint04.F_on_rod04 = -i.X.transposed_times(f);
}

// =================================================================================================
// Joint 5 "joint06": revolute, between links "rod05" and "rod06"
// =================================================================================================

void kinematics_joint06(Workspace& w) {
  auto& i = w.j_joint06;
  require_finite(w, w.q + 5, 1, 5);
  require_finite(w, w.v + 5, 1, 5);
  const Real q = Real(w.q[5]);
  const Real c = std::cos(q), s = std::sin(q);
  i.X.E << 0.0, c, s,  //
      0.0, -s, c,  //
      1.0, 0.0, 0.0;
  i.X.r << -0.4, 0.0, 0.0;
  i.v = i.X * w.j_joint05.v + joint_velocity<Revolute>(w.v + 5);
}

// A: the chain of "joint05"; B: the chain of "joint07"; C feels the joint at "rod09"
void assemble_joint06(Workspace& w) {
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

void disassemble_joint06(Workspace& w) {
  auto& i = w.j_joint06;
  Release<Revolute> release(i.joined);
  release.feel_B(i.at_rod09, w.j_joint06.F_on_rod09);
  const Columns6 f = release.force();  // Eq. (8), (10)
  store_acceleration(w, 5, 5, release.qdd());  // Eq. (9)
  w.j_joint05.F_on_rod05 = -i.X.transposed_times(f);
  w.j_joint07.F_on_rod06 = f;
}

// =================================================================================================
// Joint 6 "joint07": revolute, between links "rod06" and "rod07"
// =================================================================================================

void kinematics_joint07(Workspace& w) {
  auto& i = w.j_joint07;
  require_finite(w, w.q + 6, 1, 6);
  require_finite(w, w.v + 6, 1, 6);
  const Real q = Real(w.q[6]);
  const Real c = std::cos(q), s = std::sin(q);
  i.X.E << 0.0, c, s,  //
      0.0, -s, c,  //
      1.0, 0.0, 0.0;
  i.X.r << 0.0, 0.0, -0.4;
  i.v = i.X * w.j_joint06.v + joint_velocity<Revolute>(w.v + 6);
}

// A: link "rod06"; B: the chain of "joint08"; C feels the joint at "rod06", "rod09"
void assemble_joint07(Workspace& w) {
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

void disassemble_joint07(Workspace& w) {
  auto& i = w.j_joint07;
  Release<Revolute> release(i.joined);
  release.feel_A(i.at_rod06, w.j_joint07.F_on_rod06);
  release.feel_B(i.at_rod09, w.j_joint06.F_on_rod09);
  const Columns6 f = release.force();  // Eq. (8), (10)
  store_acceleration(w, 6, 6, release.qdd());  // Eq. (9)
  w.j_joint08.F_on_rod07 = f;
}

// =================================================================================================
// Joint 7 "joint08": revolute, between links "rod07" and "rod08"
// =================================================================================================

void kinematics_joint08(Workspace& w) {
  auto& i = w.j_joint08;
  require_finite(w, w.q + 7, 1, 7);
  require_finite(w, w.v + 7, 1, 7);
  const Real q = Real(w.q[7]);
  const Real c = std::cos(q), s = std::sin(q);
  i.X.E << 0.0, c, s,  //
      0.0, -s, c,  //
      1.0, 0.0, 0.0;
  i.X.r << 0.0, -0.4, 0.0;
  i.v = i.X * w.j_joint07.v + joint_velocity<Revolute>(w.v + 7);
}

// A: link "rod07"; B: the chain of "joint09"; C feels the joint at "rod07", "rod09"
void assemble_joint08(Workspace& w) {
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

void disassemble_joint08(Workspace& w) {
  auto& i = w.j_joint08;
  Release<Revolute> release(i.joined);
  release.feel_A(i.at_rod07, w.j_joint08.F_on_rod07);
  release.feel_B(i.at_rod09, w.j_joint06.F_on_rod09);
  const Columns6 f = release.force();  // Eq. (8), (10)
  store_acceleration(w, 7, 7, release.qdd());  // Eq. (9)
  w.j_joint09.F_on_rod08 = f;
}

// =================================================================================================
// Joint 8 "joint09": revolute, between links "rod08" and "rod09"
// =================================================================================================

void kinematics_joint09(Workspace& w) {
  auto& i = w.j_joint09;
  require_finite(w, w.q + 8, 1, 8);
  require_finite(w, w.v + 8, 1, 8);
  const Real q = Real(w.q[8]);
  const Real c = std::cos(q), s = std::sin(q);
  i.X.E << 0.0, c, s,  //
      0.0, -s, c,  //
      1.0, 0.0, 0.0;
  i.X.r << -0.4, 0.0, 0.0;
  i.v = i.X * w.j_joint08.v + joint_velocity<Revolute>(w.v + 8);
}

// A: link "rod08"; B: link "rod09"; C feels the joint at "rod08", "rod09"
void assemble_joint09(Workspace& w) {
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

void disassemble_joint09(Workspace& w) {
  auto& i = w.j_joint09;
  Release<Revolute> release(i.joined);
  release.feel_A(i.at_rod08, w.j_joint09.F_on_rod08);
  release.feel_B(i.at_rod09, w.j_joint06.F_on_rod09);
  release.force();  // Eq. (8)
  store_acceleration(w, 8, 8, release.qdd());  // Eq. (9)
}

// =================================================================================================
// Joint 9 "joint10": revolute, between links "rod09" and "rod10"
// =================================================================================================

void kinematics_joint10(Workspace& w) {
  auto& i = w.j_joint10;
  require_finite(w, w.q + 9, 1, 9);
  require_finite(w, w.v + 9, 1, 9);
  const Real q = Real(w.q[9]);
  const Real c = std::cos(q), s = std::sin(q);
  i.X.E << 0.0, c, s,  //
      0.0, -s, c,  //
      1.0, 0.0, 0.0;
  i.X.r << 0.0, 0.0, -0.4;
  i.v = i.X * w.j_joint09.v + joint_velocity<Revolute>(w.v + 9);
}

// A: the chain of "joint06"; B: the chain of "joint14"; C feels the joint at no link
void assemble_joint10(Workspace& w) {
  auto& i = w.j_joint10;
  load_torque(w, 9, 9, i.joined.tau);
  const Mat6 X_Phi_A = i.X * w.j_joint06.Phi_rod09;
  const Mat6 Phi_A = from_right(X_Phi_A, i.X);
  const Columns6 c = velocity_product<Revolute>(i.v, w.v + 9);
  constexpr std::array<Real, 6> least{1.5829154999642512e-12, 7.157930644734229e-11, 1.5829154999642512e-12, 7.073701457568329e-14, 2.842170943040401e-14, 7.073701457568329e-14};
  if (!keeps_digits<Revolute>(Phi_A, w.j_joint14.Phi_rod10, least))
    fail(w, kGrowth, 9);
  if (!join(i.joined, Phi_A, w.j_joint14.Phi_rod10, i.X * w.j_joint06.b_rod09, w.j_joint14.b_rod10, c))
    fail(w, kFactorization, 9);
}

void disassemble_joint10(Workspace& w) {
  auto& i = w.j_joint10;
  Release<Revolute> release(i.joined);
  const Columns6 f = release.force();  // Eq. (8), (10)
  store_acceleration(w, 9, 9, release.qdd());  // Eq. (9)
  w.j_joint06.F_on_rod09 = -i.X.transposed_times(f);
  w.j_joint14.F_on_rod10 = f;
}

// =================================================================================================
// Joint 10 "joint11": revolute, between links "rod10" and "rod11"
// =================================================================================================

void kinematics_joint11(Workspace& w) {
  auto& i = w.j_joint11;
  require_finite(w, w.q + 10, 1, 10);
  require_finite(w, w.v + 10, 1, 10);
  const Real q = Real(w.q[10]);
  const Real c = std::cos(q), s = std::sin(q);
  i.X.E << 0.0, c, s,  //
      0.0, -s, c,  //
      1.0, 0.0, 0.0;
  i.X.r << 0.0, -0.4, 0.0;
  i.v = i.X * w.j_joint10.v + joint_velocity<Revolute>(w.v + 10);
}

// A: link "rod10"; B: the chain of "joint12"; C feels the joint at "rod10", "rod13"
void assemble_joint11(Workspace& w) {
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
  couple(i.joined, w.j_joint12.Phi_rod11_rod13, i.at_rod13);
  i.Phi_rod10 = kPhi_rod10 - product(i.at_rod10, i.at_rod10);  // Eq. (3)
  i.Phi_rod10_rod13 = product(i.at_rod10, i.at_rod13);  // Eq. (5)
  i.Phi_rod13 = w.j_joint12.Phi_rod13 - product(i.at_rod13, i.at_rod13);  // Eq. (4)
  i.b_rod10 = w.j_joint10.b - bias_change(i.joined, i.at_rod10);  // Eq. (6)
  i.b_rod13 = w.j_joint12.b_rod13 + bias_change(i.joined, i.at_rod13);  // Eq. (7)
}

void disassemble_joint11(Workspace& w) {
  auto& i = w.j_joint11;
  Release<Revolute> release(i.joined);
  release.feel_A(i.at_rod10, w.j_joint14.F_on_rod10);
  release.feel_B(i.at_rod13, w.j_joint11.F_on_rod13);
  const Columns6 f = release.force();  // Eq. (8), (10)
  store_acceleration(w, 10, 10, release.qdd());  // Eq. (9)
  w.j_joint12.F_on_rod11 = f;
}

// =================================================================================================
// Joint 11 "joint12": revolute, between links "rod11" and "rod12"
// =================================================================================================

void kinematics_joint12(Workspace& w) {
  auto& i = w.j_joint12;
  require_finite(w, w.q + 11, 1, 11);
  require_finite(w, w.v + 11, 1, 11);
  const Real q = Real(w.q[11]);
  const Real c = std::cos(q), s = std::sin(q);
  i.X.E << 0.0, c, s,  //
      0.0, -s, c,  //
      1.0, 0.0, 0.0;
  i.X.r << -0.4, 0.0, 0.0;
  i.v = i.X * w.j_joint11.v + joint_velocity<Revolute>(w.v + 11);
}

// A: link "rod11"; B: the chain of "joint13"; C feels the joint at "rod11", "rod13"
void assemble_joint12(Workspace& w) {
  auto& i = w.j_joint12;
  load_torque(w, 11, 11, i.joined.tau);
  const Mat6 X_Phi_A = i.X * kPhi_rod11;
  const Mat6 Phi_A = from_right(X_Phi_A, i.X);
  const Columns6 c = velocity_product<Revolute>(i.v, w.v + 11);
  constexpr std::array<Real, 6> least{1.5829154999642512e-12, 1.5829154999642512e-12, 7.157930644734229e-11, 7.073701457568329e-14, 7.073701457568329e-14, 2.842170943040401e-14};
  if (!keeps_digits<Revolute>(Phi_A, w.j_joint13.Phi_rod12, least))
    fail(w, kGrowth, 11);
  if (!join(i.joined, Phi_A, w.j_joint13.Phi_rod12, i.X * w.j_joint11.b, w.j_joint13.b_rod12, c))
    fail(w, kFactorization, 11);
  couple(i.joined, X_Phi_A, i.at_rod11);
  couple(i.joined, w.j_joint13.Phi_rod12_rod13, i.at_rod13);
  i.Phi_rod11 = kPhi_rod11 - product(i.at_rod11, i.at_rod11);  // Eq. (3)
  i.Phi_rod11_rod13 = product(i.at_rod11, i.at_rod13);  // Eq. (5)
  i.Phi_rod13 = w.j_joint13.Phi_rod13 - product(i.at_rod13, i.at_rod13);  // Eq. (4)
  i.b_rod11 = w.j_joint11.b - bias_change(i.joined, i.at_rod11);  // Eq. (6)
  i.b_rod13 = w.j_joint13.b_rod13 + bias_change(i.joined, i.at_rod13);  // Eq. (7)
}

void disassemble_joint12(Workspace& w) {
  auto& i = w.j_joint12;
  Release<Revolute> release(i.joined);
  release.feel_A(i.at_rod11, w.j_joint12.F_on_rod11);
  release.feel_B(i.at_rod13, w.j_joint11.F_on_rod13);
  const Columns6 f = release.force();  // Eq. (8), (10)
  store_acceleration(w, 11, 11, release.qdd());  // Eq. (9)
  w.j_joint13.F_on_rod12 = f;
}

// =================================================================================================
// Joint 12 "joint13": revolute, between links "rod12" and "rod13"
// =================================================================================================

void kinematics_joint13(Workspace& w) {
  auto& i = w.j_joint13;
  require_finite(w, w.q + 12, 1, 12);
  require_finite(w, w.v + 12, 1, 12);
  const Real q = Real(w.q[12]);
  const Real c = std::cos(q), s = std::sin(q);
  i.X.E << 0.0, c, s,  //
      0.0, -s, c,  //
      1.0, 0.0, 0.0;
  i.X.r << 0.0, 0.0, -0.4;
  i.v = i.X * w.j_joint12.v + joint_velocity<Revolute>(w.v + 12);
}

// A: link "rod12"; B: link "rod13"; C feels the joint at "rod12", "rod13"
void assemble_joint13(Workspace& w) {
  auto& i = w.j_joint13;
  load_torque(w, 12, 12, i.joined.tau);
  const Mat6 X_Phi_A = i.X * kPhi_rod12;
  const Mat6 Phi_A = from_right(X_Phi_A, i.X);
  const Columns6 c = velocity_product<Revolute>(i.v, w.v + 12);
  constexpr std::array<Real, 6> least{1.5829154999642512e-12, 7.157930644734229e-11, 1.5829154999642512e-12, 7.073701457568329e-14, 2.842170943040401e-14, 7.073701457568329e-14};
  if (!keeps_digits<Revolute>(Phi_A, kPhi_rod13, least))
    fail(w, kGrowth, 12);
  if (!join(i.joined, Phi_A, kPhi_rod13, i.X * w.j_joint12.b, w.j_joint13.b, c))
    fail(w, kFactorization, 12);
  couple(i.joined, X_Phi_A, i.at_rod12);
  couple(i.joined, kPhi_rod13, i.at_rod13);
  i.Phi_rod12 = kPhi_rod12 - product(i.at_rod12, i.at_rod12);  // Eq. (3)
  i.Phi_rod12_rod13 = product(i.at_rod12, i.at_rod13);  // Eq. (5)
  i.Phi_rod13 = kPhi_rod13 - product(i.at_rod13, i.at_rod13);  // Eq. (4)
  i.b_rod12 = w.j_joint12.b - bias_change(i.joined, i.at_rod12);  // Eq. (6)
  i.b_rod13 = w.j_joint13.b + bias_change(i.joined, i.at_rod13);  // Eq. (7)
}

void disassemble_joint13(Workspace& w) {
  auto& i = w.j_joint13;
  Release<Revolute> release(i.joined);
  release.feel_A(i.at_rod12, w.j_joint13.F_on_rod12);
  release.feel_B(i.at_rod13, w.j_joint11.F_on_rod13);
  release.force();  // Eq. (8)
  store_acceleration(w, 12, 12, release.qdd());  // Eq. (9)
}

// =================================================================================================
// Joint 13 "joint14": revolute, between links "rod13" and "rod14"
// =================================================================================================

void kinematics_joint14(Workspace& w) {
  auto& i = w.j_joint14;
  require_finite(w, w.q + 13, 1, 13);
  require_finite(w, w.v + 13, 1, 13);
  const Real q = Real(w.q[13]);
  const Real c = std::cos(q), s = std::sin(q);
  i.X.E << 0.0, c, s,  //
      0.0, -s, c,  //
      1.0, 0.0, 0.0;
  i.X.r << 0.0, -0.4, 0.0;
  i.v = i.X * w.j_joint13.v + joint_velocity<Revolute>(w.v + 13);
}

// A: the chain of "joint11"; B: the chain of "joint15"; C feels the joint at "rod10"
void assemble_joint14(Workspace& w) {
  auto& i = w.j_joint14;
  load_torque(w, 13, 13, i.joined.tau);
  const Mat6 X_Phi_A = i.X * w.j_joint11.Phi_rod13;
  const Mat6 Phi_A = from_right(X_Phi_A, i.X);
  const Columns6 c = velocity_product<Revolute>(i.v, w.v + 13);
  constexpr std::array<Real, 6> least{7.157930644734229e-11, 1.5829154999642512e-12, 1.5829154999642512e-12, 2.842170943040401e-14, 7.073701457568329e-14, 7.073701457568329e-14};
  if (!keeps_digits<Revolute>(Phi_A, w.j_joint15.Phi_rod14, least))
    fail(w, kGrowth, 13);
  if (!join(i.joined, Phi_A, w.j_joint15.Phi_rod14, i.X * w.j_joint11.b_rod13, w.j_joint15.b_rod14, c))
    fail(w, kFactorization, 13);
  couple(i.joined, times_transposed(i.X, w.j_joint11.Phi_rod10_rod13), i.at_rod10);
  i.Phi_rod10 = w.j_joint11.Phi_rod10 - product(i.at_rod10, i.at_rod10);  // Eq. (3)
  i.b_rod10 = w.j_joint11.b_rod10 - bias_change(i.joined, i.at_rod10);  // Eq. (6)
}

void disassemble_joint14(Workspace& w) {
  auto& i = w.j_joint14;
  Release<Revolute> release(i.joined);
  release.feel_A(i.at_rod10, w.j_joint14.F_on_rod10);
  const Columns6 f = release.force();  // Eq. (8), (10)
  store_acceleration(w, 13, 13, release.qdd());  // Eq. (9)
  w.j_joint11.F_on_rod13 = -i.X.transposed_times(f);
  w.j_joint15.F_on_rod14 = f;
}

// =================================================================================================
// Joint 14 "joint15": revolute, between links "rod14" and "rod15"
// =================================================================================================

void kinematics_joint15(Workspace& w) {
  auto& i = w.j_joint15;
  require_finite(w, w.q + 14, 1, 14);
  require_finite(w, w.v + 14, 1, 14);
  const Real q = Real(w.q[14]);
  const Real c = std::cos(q), s = std::sin(q);
  i.X.E << 0.0, c, s,  //
      0.0, -s, c,  //
      1.0, 0.0, 0.0;
  i.X.r << -0.4, 0.0, 0.0;
  i.v = i.X * w.j_joint14.v + joint_velocity<Revolute>(w.v + 14);
}

// A: link "rod14"; B: the chain of "joint16"; C feels the joint at "rod14"
void assemble_joint15(Workspace& w) {
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

void disassemble_joint15(Workspace& w) {
  auto& i = w.j_joint15;
  Release<Revolute> release(i.joined);
  release.feel_A(i.at_rod14, w.j_joint15.F_on_rod14);
  const Columns6 f = release.force();  // Eq. (8), (10)
  store_acceleration(w, 14, 14, release.qdd());  // Eq. (9)
  w.j_joint16.F_on_rod15 = f;
}

// =================================================================================================
// Joint 15 "joint16": revolute, between links "rod15" and "rod16"
// =================================================================================================

void kinematics_joint16(Workspace& w) {
  auto& i = w.j_joint16;
  require_finite(w, w.q + 15, 1, 15);
  require_finite(w, w.v + 15, 1, 15);
  const Real q = Real(w.q[15]);
  const Real c = std::cos(q), s = std::sin(q);
  i.X.E << 0.0, c, s,  //
      0.0, -s, c,  //
      1.0, 0.0, 0.0;
  i.X.r << 0.0, 0.0, -0.4;
  i.v = i.X * w.j_joint15.v + joint_velocity<Revolute>(w.v + 15);
}

// A: link "rod15"; B: link "rod16"; C feels the joint at "rod15"
void assemble_joint16(Workspace& w) {
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

void disassemble_joint16(Workspace& w) {
  auto& i = w.j_joint16;
  Release<Revolute> release(i.joined);
  release.feel_A(i.at_rod15, w.j_joint16.F_on_rod15);
  release.force();  // Eq. (8)
  store_acceleration(w, 15, 15, release.qdd());  // Eq. (9)
}


// ---- 5. processes -------------------------------------------------------------------------------

// Process 0: 7 of 16 joints: "joint01", "joint02", "joint03", "joint04", "joint05", "joint06", ...; kinematics of 3 more on the way to the ground
void run_0([[maybe_unused]] Workspace& w, [[maybe_unused]] Channel& channel) {
  w.ground = ground(w);
  stamp(0);
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
    from = get(from, w.j_joint07.Phi_rod06);
    from = get(from, w.j_joint07.Phi_rod06_rod09);
    from = get(from, w.j_joint07.Phi_rod09);
    from = get(from, w.j_joint07.b_rod06);
    from = get(from, w.j_joint07.b_rod09);
  }
  stamp(3);
  assemble_joint06(w);
  stamp(4);
  {  // from process 2: assembled: chain of "joint14"
    const Number* from = channel.receive(2, w.status);
    from = get(from, w.j_joint14.Phi_rod10);
    from = get(from, w.j_joint14.b_rod10);
  }
  stamp(5);
  assemble_joint10(w);
  stamp(6);
  disassemble_joint10(w);
  stamp(7);
  {  // to process 2: forces on: chain of "joint14"
    Number* to = channel.outgoing(3, w.status);
    to = put(to, w.j_joint14.F_on_rod10);
    channel.send(3, w.status);
  }
  stamp(8);
  disassemble_joint06(w);
  stamp(9);
  {  // to process 1: forces on: chain of "joint07"
    Number* to = channel.outgoing(4, w.status);
    to = put(to, w.j_joint07.F_on_rod06);
    to = put(to, w.j_joint06.F_on_rod09);
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
void run_1([[maybe_unused]] Workspace& w, [[maybe_unused]] Channel& channel) {
  w.ground = ground(w);
  stamp(0);
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
    to = put(to, w.j_joint07.Phi_rod06);
    to = put(to, w.j_joint07.Phi_rod06_rod09);
    to = put(to, w.j_joint07.Phi_rod09);
    to = put(to, w.j_joint07.b_rod06);
    to = put(to, w.j_joint07.b_rod09);
    channel.send(0, w.status);
  }
  stamp(3);
  {  // from process 0: forces on: chain of "joint07"
    const Number* from = channel.receive(4, w.status);
    from = get(from, w.j_joint07.F_on_rod06);
    from = get(from, w.j_joint06.F_on_rod09);
  }
  stamp(4);
  disassemble_joint07(w);
  disassemble_joint08(w);
  disassemble_joint09(w);
  stamp(5);
}

// Process 2: 4 of 16 joints: "joint11", "joint12", "joint13", "joint14"; kinematics of 10 more on the way to the ground
void run_2([[maybe_unused]] Workspace& w, [[maybe_unused]] Channel& channel) {
  w.ground = ground(w);
  stamp(0);
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
  stamp(1);
  link_bias(kLinks[12], w.j_joint12.v, w.j_joint12.b);
  link_bias(kLinks[13], w.j_joint13.v, w.j_joint13.b);
  assemble_joint13(w);
  link_bias(kLinks[11], w.j_joint11.v, w.j_joint11.b);
  assemble_joint12(w);
  link_bias(kLinks[10], w.j_joint10.v, w.j_joint10.b);
  assemble_joint11(w);
  stamp(2);
  {  // from process 3: assembled: chain of "joint15"
    const Number* from = channel.receive(1, w.status);
    from = get(from, w.j_joint15.Phi_rod14);
    from = get(from, w.j_joint15.b_rod14);
  }
  stamp(3);
  assemble_joint14(w);
  stamp(4);
  {  // to process 0: assembled: chain of "joint14"
    Number* to = channel.outgoing(2, w.status);
    to = put(to, w.j_joint14.Phi_rod10);
    to = put(to, w.j_joint14.b_rod10);
    channel.send(2, w.status);
  }
  stamp(5);
  {  // from process 0: forces on: chain of "joint14"
    const Number* from = channel.receive(3, w.status);
    from = get(from, w.j_joint14.F_on_rod10);
  }
  stamp(6);
  disassemble_joint14(w);
  stamp(7);
  {  // to process 3: forces on: chain of "joint15"
    Number* to = channel.outgoing(5, w.status);
    to = put(to, w.j_joint15.F_on_rod14);
    channel.send(5, w.status);
  }
  stamp(8);
  disassemble_joint11(w);
  disassemble_joint12(w);
  disassemble_joint13(w);
  stamp(9);
}

// Process 3: 2 of 16 joints: "joint15", "joint16"; kinematics of 14 more on the way to the ground
void run_3([[maybe_unused]] Workspace& w, [[maybe_unused]] Channel& channel) {
  w.ground = ground(w);
  stamp(0);
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
  stamp(2);
  {  // to process 2: assembled: chain of "joint15"
    Number* to = channel.outgoing(1, w.status);
    to = put(to, w.j_joint15.Phi_rod14);
    to = put(to, w.j_joint15.b_rod14);
    channel.send(1, w.status);
  }
  stamp(3);
  {  // from process 2: forces on: chain of "joint15"
    const Number* from = channel.receive(5, w.status);
    from = get(from, w.j_joint15.F_on_rod14);
  }
  stamp(4);
  disassemble_joint15(w);
  disassemble_joint16(w);
  stamp(5);
}

[[maybe_unused]] constexpr std::array<void (*)(Workspace&, Channel&), kProcesses> kRun{run_0, run_1, run_2, run_3};

// What each process reads of q and v, the velocity entries whose qdd is its own, and whose tau it
// reads.
constexpr std::array<Range, 1> kReadQ_0{ {{0, 10}} };
constexpr std::array<Range, 1> kReadV_0{ {{0, 10}} };
constexpr std::array<Range, 2> kOwn_0{ {{0, 6}, {9, 1}} };
constexpr std::array<Range, 2> kTorque_0{ {{0, 6}, {9, 1}} };
constexpr std::array<Range, 1> kReadQ_1{ {{0, 9}} };
constexpr std::array<Range, 1> kReadV_1{ {{0, 9}} };
constexpr std::array<Range, 1> kOwn_1{ {{6, 3}} };
constexpr std::array<Range, 1> kTorque_1{ {{6, 3}} };
constexpr std::array<Range, 1> kReadQ_2{ {{0, 14}} };
constexpr std::array<Range, 1> kReadV_2{ {{0, 14}} };
constexpr std::array<Range, 1> kOwn_2{ {{10, 4}} };
constexpr std::array<Range, 1> kTorque_2{ {{10, 4}} };
constexpr std::array<Range, 1> kReadQ_3{ {{0, 16}} };
constexpr std::array<Range, 1> kReadV_3{ {{0, 16}} };
constexpr std::array<Range, 1> kOwn_3{ {{14, 2}} };
constexpr std::array<Range, 1> kTorque_3{ {{14, 2}} };
[[maybe_unused]] constexpr std::array<ProcessInfo, kProcesses> kProcess{ {
    {{1, kReadQ_0.data()}, {1, kReadV_0.data()}, {2, kOwn_0.data()}, {2, kTorque_0.data()}},
    {{1, kReadQ_1.data()}, {1, kReadV_1.data()}, {1, kOwn_1.data()}, {1, kTorque_1.data()}},
    {{1, kReadQ_2.data()}, {1, kReadV_2.data()}, {1, kOwn_2.data()}, {1, kTorque_2.data()}},
    {{1, kReadQ_3.data()}, {1, kReadV_3.data()}, {1, kOwn_3.data()}, {1, kTorque_3.data()}},
} };

// All constants are as they were emitted.
constexpr int kParameterCount = 0;
inline Number* pack_parameters(Number* to, const Workspace&) { return to; }
inline const Number* unpack_parameters(const Number* from, Workspace&) { return from; }
[[maybe_unused]] inline void copy_parameters(const Workspace&, Workspace&) {}

// One process, or thread, of a solver: state and result in place.
class InPlace {
 public:
  Workspace w;
  Channel channel;
  Text text;  // of the last failure

  static constexpr int kWorkspaces = 1;
  Workspace& workspace(int) { return w; }

  // Reads what this process needs, writes what it owns.
  int solve(const Number* q, const Number* v, const Number* tau, Number* qdd) {
    if (kAlone && kProcesses > 1 && channel.rank() != 0) return finish(kFine);
    if (channel.broken()) return finish(failure(kNoAnswer, 0));
    prepare(q, v, tau, qdd);
    run();
    return finish(w.status);
  }

 protected:
  // A pose that a try cannot stand is known to all processes: they try the next way together.
  void run() {
    const std::size_t rank = kAlone ? 0 : static_cast<std::size_t>(channel.rank());
    kRun[rank](w, channel);
#ifdef ADAGEN_RECOVERS
    for (std::size_t k = rank; k < kRecover.size(); k += std::size_t(kProcesses)) {
      if (failure_kind(w.status) != kSingularPose) return;
      w.status = kFine;
      kRecover[k](w, channel);
    }
#endif
  }

  void prepare(const Number* q, const Number* v, const Number* tau, Number* qdd) {
    w.q = q;
    w.v = v;
    w.tau = tau;
    w.qdd = qdd;
    w.status = kFine;
  }

  int finish(int status) {
    if (status != kFine) text = describe(status);
    return status;
  }
};

// The entries of a vector that a process needs, one after another, and back.
inline Number* pack(Number* to, const Ranges& which, const Number* x) {
  for (int k = 0; k < which.count; ++k)
    to = std::copy_n(x + which.ranges[k].first, which.ranges[k].count, to);
  return to;
}
inline const Number* unpack(const Number* from, const Ranges& which, Number* x) {
  for (int k = 0; k < which.count; ++k) {
    const auto& [first, count] = which.ranges[k];
    std::copy_n(from, count, x + first);
    from += count;
  }
  return from;
}

// Hands states and accelerations between process 0 and the others. Messages behind the plan's own:
// first the state to each process, then the accelerations from each.
class Solver : public InPlace {
 public:
  // Everything through process 0: it has the state and gets all accelerations.
  int solve_at_root(const Number* q, const Number* v, const Number* tau, Number* qdd) {
    if constexpr (kAlone) return solve(q, v, tau, qdd);
    if (channel.broken()) return finish(failure(kNoAnswer, 0));
    return channel.rank() == 0 ? solve_as_root(q, v, tau, qdd) : solve_for_root();
  }

  // At process 0: the others' next solve_at_root returns kEnded, and so does this.
  int end_at_root() {
    if constexpr (kAlone) return kFine;
    return solve_as_root(q_.data(), v_.data(), tau_.data(), qdd_.data(), failure(kEnded, 0));
  }

  // At the others: takes part in what process 0 evaluates until it ends that.
  int serve() {
    const int rank = channel.rank();
    if (rank == 0) return kFine;
    int status = kFine;
    if (has_part(rank)) do
        status = channel.broken() ? failure(kNoAnswer, 0) : solve_for_root(true);
      while (failure_kind(status) != kEnded && failure_kind(status) != kNoAnswer);
    else
      channel.await_end();
    return failure_kind(status) == kEnded ? kFine : finish(status);
  }

  // Collective.
  void close() { channel.close(); }

  // At process 0: the others serve no longer.
  int end() {
    if (channel.rank() != 0) return kFine;
    const int status = end_at_root();
    for (int p = 1; p < kProcesses; ++p)
      if (!has_part(p)) channel.send_end(p);
    return failure_kind(status) == kEnded ? kFine : finish(status);
  }

 private:
  // Whether a process takes part when all goes through process 0.
  static bool has_part(int p) {
    return !kAlone && kProcess[static_cast<std::size_t>(p)].own.count > 0;
  }

  // patient: however long process 0 lets it wait.
  int solve_for_root(bool patient = false) {
    const int rank = channel.rank();
    const ProcessInfo& own = kProcess[static_cast<std::size_t>(rank)];
    if (own.own.count == 0) return finish(kFine);
    int status = kFine;
    const Number* content = channel.receive(state_message(rank), status, patient);
    content = unpack(content, own.q, q_.data());
    content = unpack(content, own.v, v_.data());
    content = unpack(content, own.tau, tau_.data());
    unpack_parameters(content, w);
    prepare(q_.data(), v_.data(), tau_.data(), qdd_.data());
    Channel::fail(w.status, status);
    run();
    Number* result = channel.outgoing(result_message(rank), w.status);
    pack(result, own.own, qdd_.data());
    channel.send(result_message(rank), w.status);
    return finish(w.status);
  }

  int solve_as_root(const Number* q, const Number* v, const Number* tau, Number* qdd,
                    int status = kFine) {
    for (int p = 1; p < kProcesses; ++p) {
      const ProcessInfo& other = kProcess[static_cast<std::size_t>(p)];
      if (other.own.count == 0) continue;
      Number* content = channel.outgoing(state_message(p), status);
      content = pack(content, other.q, q);
      content = pack(content, other.v, v);
      content = pack(content, other.tau, tau);
      pack_parameters(content, w);
      channel.send(state_message(p), status);
    }
    prepare(q, v, tau, qdd_.data());
    Channel::fail(w.status, status);
    run();
    for (int p = 1; p < kProcesses; ++p) {
      const ProcessInfo& other = kProcess[static_cast<std::size_t>(p)];
      if (other.own.count == 0) continue;
      const Number* result = channel.receive(result_message(p), w.status);
      unpack(result, other.own, qdd_.data());
    }
    if (w.status == kFine) std::copy(qdd_.begin(), qdd_.end(), qdd);
    return finish(w.status);
  }

  static int state_message(int process) { return kPlanMessages + 2 * (process - 1); }
  static int result_message(int process) { return kPlanMessages + 2 * (process - 1) + 1; }

  std::array<Number, kNq> q_{};
  std::array<Number, kNv> v_{};
  std::array<Number, kNqdd> qdd_{};
  std::array<Number, kNtau> tau_{};
};

}  // namespace

static_assert(CHAIN16_P4_NQ == kNq && CHAIN16_P4_NV == kNv && CHAIN16_P4_NTAU == kNtau);
static_assert(int(CHAIN16_P4_FINE) == int(kFine));
static_assert(int(CHAIN16_P4_NOT_FINITE) == int(kNotFinite));
static_assert(int(CHAIN16_P4_ZERO_QUATERNION) == int(kZeroQuaternion));
static_assert(int(CHAIN16_P4_FACTORIZATION) == int(kFactorization));
static_assert(int(CHAIN16_P4_OVERFLOW) == int(kOverflow));
static_assert(int(CHAIN16_P4_NO_ANSWER) == int(kNoAnswer));
static_assert(int(CHAIN16_P4_ENDED) == int(kEnded));
static_assert(int(CHAIN16_P4_NOT_REFINED) == int(kNotRefined));
static_assert(int(CHAIN16_P4_GIMBAL_LOCK) == int(kGimbalLock));
static_assert(int(CHAIN16_P4_GROWTH) == int(kGrowth));
static_assert(int(CHAIN16_P4_NOT_SET) == int(kNotSet));
static_assert(int(CHAIN16_P4_TOO_FEW_STEPS) == int(kTooFewSteps));
static_assert(int(CHAIN16_P4_LOOP_OPEN) == int(kLoopOpen));
static_assert(int(CHAIN16_P4_LOOP_TORN) == int(kLoopTorn));
static_assert(int(CHAIN16_P4_LOOP_SINGULAR) == int(kLoopSingular));
static_assert(int(CHAIN16_P4_LOOP_FREE) == int(kLoopFree));

struct chain16_p4_solver : Solver {};

namespace {

// Why the last open of a thread gave no solver.
thread_local Text open_failure;

// What is wrong with what was asked for; an empty string for nothing.
inline std::string why_not_open(MPI_Comm comm, const std::string& kind, double time_limit) {
  int ready = 0, size = 0;
  MPI_Initialized(&ready);
  if (ready == 0) return "MPI is not initialised: call MPI_Init first";
  MPI_Comm_size(comm, &size);
  if (size != kProcesses)
    return "this solver is for exactly " + std::to_string(kProcesses) +
           " processes, the communicator has " + std::to_string(size);
  if (kind != "auto" && kind != "window" && kind != "message")
    return "channel takes auto, window or message, not " + kind;
  return time_limit > 0 ? "" : "the time limit must be more than 0 s";
}

inline ChannelMode mode_of(const std::string& kind) {
  return kind == "window"    ? ChannelMode::kWindow
         : kind == "message" ? ChannelMode::kMessage
                             : ChannelMode::kAuto;
}

template <class AnySolver>
AnySolver* opened(MPI_Comm comm, const char* channel, double time_limit) {
  open_failure.clear();
  try {
    const std::string kind = channel == nullptr ? "auto" : channel;
    std::string wrong = why_not_open(comm, kind, time_limit);
    if (wrong.empty()) {
      auto solver = std::make_unique<AnySolver>();
      wrong = solver->channel.open(comm, mode_of(kind), time_limit);
      if (wrong.empty()) return solver.release();
      solver->channel.close();
    }
    open_failure += wrong.c_str();
  } catch (const std::exception& error) {
    open_failure += error.what();
  }
  return nullptr;
}

}  // namespace

extern "C" {

int chain16_p4_joint(int k, const char** name, int* q, int* nq, int* v, int* nv) {
  if (k < 0 || k >= kJointCount) return 0;
  const JointConstants& joint = kJoints[k];
  *name = joint.name, *q = joint.q, *nq = joint.nq, *v = joint.v, *nv = joint.nv;
  return 1;
}

chain16_p4_solver* chain16_p4_open(MPI_Comm comm, const char* channel, double time_limit) {
  return opened<chain16_p4_solver>(comm, channel, time_limit);
}

int chain16_p4_solve(chain16_p4_solver* solver, const double* q, const double* v, const double* tau, double* qdd) {
  return solver->solve(q, v, tau, qdd);
}

int chain16_p4_solve_at_root(chain16_p4_solver* solver, const double* q, const double* v, const double* tau, double* qdd) {
  return solver->solve_at_root(q, v, tau, qdd);
}

int chain16_p4_serve(chain16_p4_solver* solver) { return solver->serve(); }

int chain16_p4_end(chain16_p4_solver* solver) { return solver->end(); }

int chain16_p4_reason(int status) { return failure_kind(status); }

int chain16_p4_failed_joint(int status) { return is_of_joint(failure_kind(status)) ? failure_place(status) : -1; }

const char* chain16_p4_failure(const chain16_p4_solver* solver) {
  return solver == nullptr ? open_failure.c_str() : solver->text.c_str();
}

void chain16_p4_close(chain16_p4_solver* solver) {
  if (solver == nullptr) return;
  solver->close();
  delete solver;
}

}  // extern "C"

// ---- 6. program ---------------------------------------------------------------------------------
// What this solver tells the program around it, which is the same for all robots: states in,
// accelerations out; check; time; trace; simulate.

#ifndef ADAGEN_NO_MAIN
// What a solver tells the program around it (adagen_program.cpp), and what that asks of it.
#ifndef ADAGEN_DESCRIPTION
#define ADAGEN_DESCRIPTION
namespace adagen {

struct OneProcess {};  // in place of a communicator where there is no MPI

template <class Item>
struct Table {
  const Item* items;
  int count;

  const Item* begin() const { return items; }
  const Item* end() const { return items + count; }
  const Item& operator[](int k) const { return items[k]; }
};

enum class JointKind { kRevolute, kPrismatic, kSpherical, kPlanar, kFloating };

// Joints, links and outer forces as section 2 of the solver has them; rotations have 9 entries, row
// by row.
template <class Number>
struct Joint {
  const char* name;
  JointKind kind;
  int parent, q, nq, v, nv;
  const Number *rotation, *translation;
  int source;
  double multiplier, offset;
  double damping, friction, friction_speed, stiffness, rest, rotor;
  bool prescribed;
};

template <class Number>
struct Link {
  double mass;
  const Number *com, *tensor;
};

template <class Number>
struct OuterForce {
  const char* name;
  int link;
  const Number *rotation, *translation;
};

// A joint that closes a loop; axes of frame 1 along which it holds places together, and about which
// it bars turns, as bits.
template <class Number>
struct Loop {
  const char* name;
  int link1, link2;
  const Number *rotation1, *translation1, *rotation2, *translation2;
  unsigned linear, angular;
  bool universal;

  bool holds(int axis) const { return (linear >> axis & 1u) != 0; }
  bool bars(int axis) const { return (angular >> axis & 1u) != 0; }
};

// Coordinates of joints whose sum, each times its factor, is the offset.
template <class Number>
struct Coupling {
  const char* name;
  int count;
  const int* joints;
  const Number* factors;
  Number offset;
};

struct Message {
  int source, target, size;  // size in numbers, the status not counted
};

// Between two time stamps of a process.
struct Stage {
  const char* what;
  int joint;    // that it ends or begins with; -1 for none
  int message;  // sent or received; -1 for work
};

// What a message costs, ns: its sender, from sent to seen, and per number to put it in and take it
// out again.
struct Hop {
  double send, latency, number;
};

template <class Number>
struct Description {
  const char *robot, *channel;
  int processes, threads, nq, nv, ntau, nqdd, refine;
  bool floating, alone, batch, sets_gravity;
  double tolerance;
  const double* gravity;
  Table<Joint<Number>> joints;
  Table<Link<Number>> links;
  Table<OuterForce<Number>> outer_forces;
  Table<Loop<Number>> loops;
  Table<Coupling<Number>> couplings;
  Table<Message> messages;
  const Table<Stage>* stages;  // of each process
  Hop window_hop, message_hop;
};

// How a solver is opened: its channel, s that processes wait for each other, hosts to play, and
// whether threads of its own are to stay on a core each.
struct Opening {
  const char* channel;
  double time_limit;
  int hosts;
  bool pin;
};

// How long an evaluation took, ns, and its status: state and result in place, and everything
// through process 0.
struct Elapsed {
  double in_place, at_root;
  int status_in_place, status_at_root;
};

// The solver. What is measured is compiled with it.
template <class Number, class Comm>
class AnySolver {
 public:
  using Ticks = std::chrono::steady_clock::rep;

  virtual ~AnySolver() = default;

  // Collective. Returns what is wrong, or an empty string.
  virtual const char* open(Comm comm, const Opening& how) = 0;
  virtual void close() = 0;
  // For all evaluations to come, of this process: where it can be set.
  virtual void set_gravity(const double*) {}
  virtual Comm comm() const = 0;
  virtual const char* channel_name() const = 0;
  virtual bool windowed() const = 0;

  // One evaluation; at the root: process 0 has the state and gets all accelerations. Returns a
  // status.
  virtual int solve(const Number* q, const Number* v, const Number* tau, Number* qdd) = 0;
  virtual int solve_at_root(const Number* q, const Number* v, const Number* tau, Number* qdd) = 0;
  virtual int end_at_root() = 0;
  virtual bool has_part() const = 0;  // whether this process takes part in it

  // Many at once, where the solver is for batches. The k-th state that failed, or -1; then, why.
  virtual int solve_batch_at_root(int, const Number*, const Number*, const Number*, Number*) {
    return 0;
  }
  virtual int failures() const { return 0; }
  virtual int failed_state(int) { return -1; }
  virtual const char* why() const { return ""; }

  // A status in words, valid until the next; the names of the joints that one is joined with.
  virtual const char* in_words(int status) = 0;
  virtual const char* names_of_run(int joint) = 0;
  // The size of the k-th correction of the last evaluation.
  virtual double correction(int k) const = 0;
  // 1 + the last joint of a run that has been near gimbal lock; 0: none.
  virtual int near_lock() const = 0;

  // Collective: processes start together. An evaluation; batches of so many states for each
  // process, on the first of all processes; an evaluation with a stamp at its start, and at each
  // end of a stage.
  virtual Elapsed time(const Number* q, const Number* v, const Number* tau, Number* qdd) = 0;
  virtual Elapsed time_batch(int, int, const Number*, const Number*, const Number*, Number*) {
    return {};
  }
  virtual int trace(const Number* q, const Number* v, const Number* tau, Number* qdd,
                    Ticks* stamps) = 0;

  // Evaluations whose messages are noted once, and then played (take.hpp); numbered from 0 to
  // count - 1. looks has room for the clock at the start, at each message and at the end.
  virtual void forget(int count) = 0;
  virtual int record(int k, bool at_root, const Number* q, const Number* v, const Number* tau,
                     Number* qdd) = 0;
  virtual void play(int k, bool at_root, const Number* q, const Number* v, const Number* tau,
                    Number* qdd, Ticks* looks) = 0;
  virtual Table<int> noted(int k) const = 0;
};

// The whole program; returns its exit status. Of a number and a communicator, as adagen_program.cpp
// is compiled for them.
template <class Number, class Comm>
int program(const Description<Number>& description, AnySolver<Number, Comm>& solver, int count,
            char** words);

}  // namespace adagen
#endif

namespace {

// What is measured (--time, --stretches), of several processes.
using Clock = std::chrono::steady_clock;

Text open_solver(Solver& solver, MPI_Comm comm, const adagen::Opening& how) {
  const std::string wrong =
      solver.channel.open(comm, mode_of(how.channel), how.time_limit, how.hosts);
  return Text(wrong.c_str());
}

// All processes that take part in an evaluation start it at the same instant of their common clock;
// hosts have none. One alone starts at once: to meet others that it does not need would only cool
// its caches.
Clock::time_point start_together(const Channel& channel) {
  if (kAlone) return Clock::now();
  if (!channel.on_one_host()) {
    MPI_Barrier(channel.comm());
    return Clock::now();
  }
  Clock::rep start = 0;
  if (channel.rank() == 0)
    start = (Clock::now() + std::chrono::microseconds(5)).time_since_epoch().count();
  MPI_Bcast(&start, static_cast<int>(sizeof start), MPI_BYTE, 0, channel.comm());
  const Clock::time_point at{Clock::duration(start)};
  const Clock::time_point latest = Clock::now() + std::chrono::microseconds(50);
  Clock::time_point now;
  while ((now = Clock::now()) < at && now < latest) relax();
  return now;
}

// The same where an evaluation has just ended.
Clock::time_point start_again(const Channel& channel) {
  if (!kAlone) MPI_Barrier(channel.comm());
  return Clock::now();
}

// Evaluations whose messages are noted once, and played as often as asked for.
class Takes {
 public:
  void forget(int count) { takes_.assign(static_cast<std::size_t>(count), Take()); }

  template <class Evaluate>
  int record(Channel& channel, int k, Evaluate evaluate) {
    Take& take = takes_[static_cast<std::size_t>(k)];
    take.record();
    channel.use(&take);
    const int status = evaluate();
    channel.use(nullptr);
    return status;
  }

  // looks: at the clock, at the start, at each message and at the end.
  template <class Evaluate>
  void play(Channel& channel, int k, Clock::rep* looks, Evaluate evaluate) {
    Take& take = takes_[static_cast<std::size_t>(k)];
    take.play();
    channel.use(&take);
    const Clock::rep start = Clock::now().time_since_epoch().count();
    evaluate();
    const Clock::rep end = Clock::now().time_since_epoch().count();
    channel.use(nullptr);
    *looks = start;
    *std::copy(take.looks().begin(), take.looks().end(), looks + 1) = end;
  }

  adagen::Table<int> messages(int k) const {
    const std::vector<int>& found = takes_[static_cast<std::size_t>(k)].messages();
    return {found.data(), static_cast<int>(found.size())};
  }

 private:
  std::vector<Take> takes_;
};

// The model as the program takes it.
adagen::Joint<Number> told(const JointConstants& joint) {
  const Passive& own = joint.passive;
  const auto kind = static_cast<adagen::JointKind>(joint.kind);
  return {joint.name,       kind,         joint.parent,   joint.q,           joint.nq,
          joint.v,          joint.nv,     joint.rotation, joint.translation, joint.source,
          joint.multiplier, joint.offset, own.damping,    own.friction,      own.friction_speed,
          own.stiffness,    own.rest,     own.rotor,      own.prescribed};
}
adagen::Link<Number> told(const LinkConstants& link) { return {link.mass, link.com, link.tensor}; }
[[maybe_unused]] adagen::OuterForce<Number> told(const OuterForce& outer) {
  return {outer.name, outer.link, outer.rotation, outer.translation};
}
[[maybe_unused]] adagen::Message told(const MessageInfo& message) {
  return {message.source, message.target, message.size};
}

// All of a table, as long as the program runs.
template <class Own, std::size_t n>
auto table(const std::array<Own, n>& all) {
  using Told = decltype(told(all[0]));
  static std::array<Told, n> items{};
  for (std::size_t k = 0; k < n; ++k) items[k] = told(all[k]);
  return adagen::Table<Told>{items.data(), static_cast<int>(n)};
}

// Shapes that join no runs of joints as one are never near gimbal lock.
template <class S>
auto near_lock_of(const S& solver, int) -> decltype(solver.w.near_lock) {
  return solver.w.near_lock;
}
template <class S>
int near_lock_of(const S&, long) {
  return 0;
}

class ThisSolver final : public adagen::AnySolver<Number, MPI_Comm> {
 public:
  const char* open(MPI_Comm comm, const adagen::Opening& how) override {
    words_ = open_solver(solver_, comm, how);
    return words_.c_str();
  }
  void close() override { solver_.close(); }
  MPI_Comm comm() const override { return solver_.channel.comm(); }
  const char* channel_name() const override { return kAlone ? "none" : solver_.channel.name(); }
  bool windowed() const override { return solver_.channel.windowed(); }

  int solve(const Number* q, const Number* v, const Number* tau, Number* qdd) override {
    return in_place(q, v, tau, qdd);
  }
  int solve_at_root(const Number* q, const Number* v, const Number* tau, Number* qdd) override {
    return at_root(q, v, tau, qdd);
  }
  int end_at_root() override { return solver_.end_at_root(); }
  bool has_part() const override {
    return kProcess[static_cast<std::size_t>(solver_.channel.rank())].own.count > 0;
  }

  const char* in_words(int status) override {
    words_ = describe(status);
    return words_.c_str();
  }
  const char* names_of_run(int joint) override {
    words_.clear();
    add_names_of_run(words_, joint);
    return words_.c_str();
  }
  double correction([[maybe_unused]] int k) const override {
    return 0;
  }
  int near_lock() const override { return near_lock_of(solver_, 0); }

  adagen::Elapsed time(const Number* q, const Number* v, const Number* tau, Number* qdd) override {
    const Clock::time_point start = start_together(solver_.channel);
    const int first = solver_.solve(q, v, tau, qdd);
    const double in_place_ns = since(start);
    const Clock::time_point again = start_again(solver_.channel);
    const int second = solver_.solve_at_root(q, v, tau, qdd);
    const double at_root_ns = since(again);
    return {in_place_ns, at_root_ns, first, second};
  }
  int trace(const Number* q, const Number* v, const Number* tau, Number* qdd, Ticks* stamps) override {
    start_together(solver_.channel);
    trace_stamps = stamps;
    const int status = in_place(q, v, tau, qdd);
    trace_stamps = nullptr;
    return status;
  }

  void forget(int count) override { takes_.forget(count); }
  int record(int k, bool root, const Number* q, const Number* v, const Number* tau, Number* qdd) override {
    return takes_.record(solver_.channel, k, [&] {
      return root ? at_root(q, v, tau, qdd) : in_place(q, v, tau, qdd);
    });
  }
  void play(int k, bool root, const Number* q, const Number* v, const Number* tau, Number* qdd, Ticks* looks) override {
    if (root)
      takes_.play(solver_.channel, k, looks, [&] { at_root(q, v, tau, qdd); });
    else
      takes_.play(solver_.channel, k, looks, [&] { in_place(q, v, tau, qdd); });
  }
  adagen::Table<int> noted(int k) const override { return takes_.messages(k); }

 private:
  // For all but the clock: once in the code, whoever calls it.
  ADAGEN_NOINLINE int in_place(const Number* q, const Number* v, const Number* tau, Number* qdd) {
    return solver_.solve(q, v, tau, qdd);
  }
  ADAGEN_NOINLINE int at_root(const Number* q, const Number* v, const Number* tau, Number* qdd) {
    return solver_.solve_at_root(q, v, tau, qdd);
  }

  static double since(Clock::time_point start) {
    return std::chrono::duration<double, std::nano>(Clock::now() - start).count();
  }

  Solver solver_;
  Takes takes_;
  Text words_;
};

// The stages of each process's work, for --trace.
constexpr std::array<adagen::Stage, 11> kStages_0{ {
    {"kinematics", 9, -1},
    {"assembly", 4, -1},
    {"receive", -1, 0},
    {"assembly", 5, -1},
    {"receive", -1, 2},
    {"assembly", 9, -1},
    {"disassembly", 9, -1},
    {"send", -1, 3},
    {"disassembly", 5, -1},
    {"send", -1, 4},
    {"disassembly", 4, -1},
} };
constexpr std::array<adagen::Stage, 5> kStages_1{ {
    {"kinematics", 8, -1},
    {"assembly", 6, -1},
    {"send", -1, 0},
    {"receive", -1, 4},
    {"disassembly", 6, -1},
} };
constexpr std::array<adagen::Stage, 9> kStages_2{ {
    {"kinematics", 13, -1},
    {"assembly", 10, -1},
    {"receive", -1, 1},
    {"assembly", 13, -1},
    {"send", -1, 2},
    {"receive", -1, 3},
    {"disassembly", 13, -1},
    {"send", -1, 5},
    {"disassembly", 10, -1},
} };
constexpr std::array<adagen::Stage, 5> kStages_3{ {
    {"kinematics", 15, -1},
    {"assembly", 14, -1},
    {"send", -1, 1},
    {"receive", -1, 5},
    {"disassembly", 14, -1},
} };
constexpr std::array<adagen::Table<adagen::Stage>, kProcesses> kStages{ {
    {kStages_0.data(), 11},
    {kStages_1.data(), 5},
    {kStages_2.data(), 9},
    {kStages_3.data(), 5},
} };

// As the cost profile default has them.
constexpr adagen::Hop kWindowHop{0, 159, 0.437};
constexpr adagen::Hop kMessageHop{26, 228, 0.644};

}  // namespace

// Compiled for size: it runs once.
[[gnu::cold]] int main(int count, char** words) {
  const adagen::Description<Number> description{
      "chain16", "message", kProcesses, 1, kNq, kNv, kNtau, kNqdd, kRefine,
      false, kAlone, kBatch, false, kTolerance, kGravity.data(),
      table(kJoints), table(kLinks), table(kOuterForces), {}, {}, table(kMessages), kStages.data(), kWindowHop,
      kMessageHop};
  auto* const solver = new ThisSolver;
  const int status = adagen::program(description, *solver, count, words);
  delete solver;
  return status;
}
#endif  // ADAGEN_NO_MAIN
