// The program around a solver, emitted by adagen 0.1.0 (adagen_program.cpp.j2). Do not edit: emit anew.
//
// It is the same for all robots: states in, accelerations out; check; time; trace; simulate. Compile
// it as the last section of a solver, NAME_pP.cpp, says, and link both:
//   -DADAGEN_MPI    the solver is for several processes
//   -DADAGEN_FLOAT  its states and accelerations are float
//
// licence   yours to choose: what adagen emits belongs to whoever emits it

#if defined(ADAGEN_MPI)
#include <mpi.h>
#endif

#include <algorithm>
#include <array>
#include <atomic>
#include <charconv>
#include <chrono>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <fstream>
#include <initializer_list>
#include <iterator>
#include <limits>
#include <memory>
#include <new>
#include <sstream>
#include <stdexcept>
#include <string>
#include <thread>
#include <type_traits>
#include <utility>
#include <vector>
#if defined(__linux__)
#include <sched.h>
#endif
#if defined(__unix__) || defined(__APPLE__)
#include <sys/time.h>
#include <unistd.h>

#include <csignal>
#endif

#define ADAGEN_NOINLINE [[maybe_unused]] __attribute__((noinline))
#define ADAGEN_HOT [[gnu::hot]] ADAGEN_NOINLINE  // called in each step of a simulation; all else is cold

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

namespace adagen {
namespace {

#if defined(ADAGEN_FLOAT)
using Number = float;
#else
using Number = double;
#endif

#if defined(ADAGEN_MPI)
const MPI_Datatype kMpiNumber = sizeof(Number) == sizeof(double) ? MPI_DOUBLE : MPI_FLOAT;
#else
// What the program asks of MPI, for one process without it: there is nobody else. A launcher's word
// is taken for how many were started, so that none of several goes on by itself.
using MPI_Comm = OneProcess;
using MPI_Datatype = std::size_t;  // its size
using MPI_Request = int;
struct MPI_Status {};
constexpr MPI_Comm MPI_COMM_WORLD{};
constexpr MPI_Datatype MPI_BYTE = 1, MPI_INT = sizeof(int), MPI_DOUBLE = sizeof(double),
                       MPI_LONG_LONG = sizeof(long long), kMpiNumber = sizeof(Number);
constexpr int MPI_MAX = 0, MPI_MIN = 0, MPI_SUM = 0, MPI_BOR = 0, MPI_COMM_TYPE_SHARED = 0,
              MPI_INFO_NULL = 0;
constexpr std::nullptr_t MPI_IN_PLACE = nullptr, MPI_STATUS_IGNORE = nullptr;

int of_launcher(std::initializer_list<const char*> names, int alone) {
  for (const char* const name : names)
    if (const char* const said = std::getenv(name)) return std::atoi(said);
  return alone;
}

inline void MPI_Init(int*, char***) {}
inline void MPI_Finalize() {}
inline void MPI_Comm_rank(MPI_Comm, int* rank) {
  *rank = of_launcher({"OMPI_COMM_WORLD_RANK", "PMI_RANK"}, 0);
}
inline void MPI_Comm_size(MPI_Comm, int* size) {
  *size = of_launcher({"OMPI_COMM_WORLD_SIZE", "PMI_SIZE"}, 1);
}
inline void MPI_Comm_split_type(MPI_Comm, int, int, int, MPI_Comm*) {}
inline void MPI_Comm_free(MPI_Comm*) {}
[[noreturn]] inline void MPI_Abort(MPI_Comm, int status) { std::_Exit(status); }
inline void MPI_Ibarrier(MPI_Comm, MPI_Request*) {}
inline void MPI_Test(MPI_Request*, int* done, std::nullptr_t) { *done = 1; }
inline void MPI_Bcast(void*, int, MPI_Datatype, int, MPI_Comm) {}
inline void MPI_Allreduce(const void* from, void* to, int count, MPI_Datatype size, int, MPI_Comm) {
  if (from != nullptr) std::memcpy(to, from, static_cast<std::size_t>(count) * size);
}
inline void MPI_Reduce(const void*, void*, int, MPI_Datatype, int, int, MPI_Comm) {}
inline void MPI_Send(const void*, int, MPI_Datatype, int, int, MPI_Comm) {}
inline void MPI_Recv(void*, int, MPI_Datatype, int, int, MPI_Comm, std::nullptr_t) {}
inline void MPI_Probe(int, int, MPI_Comm, MPI_Status*) {}
inline void MPI_Get_count(const MPI_Status*, MPI_Datatype, int*) {}
#endif

using Joint = adagen::Joint<Number>;
using Link = adagen::Link<Number>;
using OuterForce = adagen::OuterForce<Number>;
using Loop = adagen::Loop<Number>;
using Coupling = adagen::Coupling<Number>;
using Solver = AnySolver<Number, MPI_Comm>;

constexpr int kRandomStates = 64;
constexpr std::size_t kTextSize = 1000;

Description<Number> about;  // the solver, as its main has it

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

// An independent check: inverse dynamics by Newton's and Euler's equations, body by body, in
// long double. It shares the model's constants with the solver, and no arithmetic.
namespace check {

using Real = long double;
using Vec = std::array<Real, 3>;
using Mat = std::array<Vec, 3>;

Vec operator+(const Vec& a, const Vec& b) { return {a[0] + b[0], a[1] + b[1], a[2] + b[2]}; }
Vec cross(const Vec& a, const Vec& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}
Vec times(const Mat& m, const Vec& a) {
  Vec result{};
  for (int i = 0; i < 3; ++i) result[i] = m[i][0] * a[0] + m[i][1] * a[1] + m[i][2] * a[2];
  return result;
}
Vec transposed_times(const Mat& m, const Vec& a) {
  Vec result{};
  for (int i = 0; i < 3; ++i) result[i] = m[0][i] * a[0] + m[1][i] * a[1] + m[2][i] * a[2];
  return result;
}
Mat times(const Mat& a, const Mat& b) {
  Mat result{};
  for (int i = 0; i < 3; ++i)
    for (int j = 0; j < 3; ++j)
      for (int k = 0; k < 3; ++k) result[i][j] += a[i][k] * b[k][j];
  return result;
}
Real length(const Vec& a) { return std::sqrt(a[0] * a[0] + a[1] * a[1] + a[2] * a[2]); }
Vec vec3(const Number* x) { return {Real(x[0]), Real(x[1]), Real(x[2])}; }
Mat mat3(const Number* x) { return {vec3(x), vec3(x + 3), vec3(x + 6)}; }

// How large the terms are from which something is added up: what rounding errors are relative to.
// A rotation changes no length, so that sizes hold in every frame.
struct Sizes {
  Real dw, a, f, n;
};

struct Body {
  Mat turn;   // child to parent coordinates
  Vec shift;  // child origin in parent coordinates
  Vec w, dw;  // angular velocity and acceleration, in the body's frame
  Vec a;      // acceleration of its origin minus gravity, in the body's frame
  Vec f, n;   // force on it through its joint, and moment about its origin
  Sizes size;
};

// Rotation and origin of the child frame in the joint frame.
void displace(const Joint& joint, const Number* q, Mat& turn, Vec& shift) {
  turn = {Vec{1, 0, 0}, Vec{0, 1, 0}, Vec{0, 0, 1}};
  shift = {};
  const auto about_z = [&turn](Real angle) {
    const Real c = std::cos(angle), s = std::sin(angle);
    turn = {Vec{c, -s, 0}, Vec{s, c, 0}, Vec{0, 0, 1}};
  };
  const auto orient = [&turn](const Number* p) {
    Real x = p[0], y = p[1], z = p[2], w = p[3];
    const Real size = std::sqrt(x * x + y * y + z * z + w * w);
    x /= size, y /= size, z /= size, w /= size;
    turn = {Vec{1 - 2 * (y * y + z * z), 2 * (x * y - z * w), 2 * (x * z + y * w)},
            Vec{2 * (x * y + z * w), 1 - 2 * (x * x + z * z), 2 * (y * z - x * w)},
            Vec{2 * (x * z - y * w), 2 * (y * z + x * w), 1 - 2 * (x * x + y * y)}};
  };
  switch (joint.kind) {
    case JointKind::kRevolute:
      about_z(q[0]);
      break;
    case JointKind::kPrismatic:
      shift[2] = Real(q[0]);
      break;
    case JointKind::kSpherical:
      orient(q);
      break;
    case JointKind::kPlanar:
      about_z(q[2]), shift = {Real(q[0]), Real(q[1]), 0};
      break;
    case JointKind::kFloating:
      orient(q + 3), shift = vec3(q);
      break;
  }
}

// Angular and linear part of a joint's velocity or acceleration, in the child's frame.
void motion(const Joint& joint, const Number* x, Vec& angular, Vec& linear) {
  angular = linear = {};
  switch (joint.kind) {
    case JointKind::kRevolute:
      angular[2] = Real(x[0]);
      break;
    case JointKind::kPrismatic:
      linear[2] = Real(x[0]);
      break;
    case JointKind::kSpherical:
      angular = vec3(x);
      break;
    case JointKind::kPlanar:
      linear = {Real(x[0]), Real(x[1]), 0}, angular[2] = Real(x[2]);
      break;
    case JointKind::kFloating:
      linear = vec3(x), angular = vec3(x + 3);
      break;
  }
}

// What is added up in a row of the equation of motion, and the size of it.
struct Row {
  Real value = 0, size = 0;

  void add(Real x) { value += x, size += std::abs(x); }
};

// What a joint's damping, friction, spring and rotor take of its torque.
void add_passive(const Joint& joint, const Number* q, const Number* v, const Number* qdd,
                 Row* row) {
  for (int k = 0; k < joint.nv; ++k) {
    const double rate = double(v[joint.v + k]);
    row[k].add(joint.damping * rate);
    row[k].add(joint.rotor * double(qdd[joint.v + k]));
    row[k].add(joint.friction * std::tanh(rate / joint.friction_speed));
  }
  if (joint.stiffness != 0) row[0].add(joint.stiffness * (double(q[joint.q]) - joint.rest));
}

// The outer forces push their links.
void push(const Number* outer, std::vector<Body>& body) {
  for (const OuterForce& one : about.outer_forces) {
    Body& b = body[static_cast<std::size_t>(one.link)];
    const Mat turn = mat3(one.rotation);
    const Vec force = times(turn, vec3(outer)), moment = times(turn, vec3(outer + 3));
    const Vec place = vec3(one.translation), lever = cross(place, force);
    for (int k = 0; k < 3; ++k) b.f[k] -= force[k], b.n[k] -= moment[k] + lever[k];
    b.size.f += length(force), b.size.n += length(moment) + length(place) * length(force);
    outer += 6;
  }
}

// What moves a body: its inertia times its acceleration, and what that takes at its joint.
void set_in_motion(const Link& link, Body& b) {
  const Vec c = vec3(link.com);
  const Vec at_com = b.a + cross(b.dw, c) + cross(b.w, cross(b.w, c));
  const Mat inertia = mat3(link.tensor);
  for (int k = 0; k < 3; ++k) b.f[k] = link.mass * at_com[k];
  b.n = times(inertia, b.dw) + cross(b.w, times(inertia, b.w)) + cross(c, b.f);
  const Real turning = b.size.dw + length(b.w) * length(b.w);
  const Real about_com = std::hypot(length(inertia[0]), length(inertia[1]), length(inertia[2]));
  b.size.f = link.mass * (b.size.a + turning * length(c));
  b.size.n = about_com * turning + length(c) * b.size.f;
}

// The motion of body j + 1. Errors of joints' accelerations are independent of each other: what
// they add up to in an angular acceleration grows with their root mean square.
void set_motion(int j, const Number* q, const Number* v, const Number* qdd,
                std::vector<Body>& body) {
  const Joint& joint = about.joints[j];
  const Body& parent = body[static_cast<std::size_t>(joint.parent)];
  Body& b = body[static_cast<std::size_t>(j) + 1];
  Mat turn;
  Vec shift, spin, slide, spin_rate, slide_rate;
  displace(joint, q + joint.q, turn, shift);
  motion(joint, v + joint.v, spin, slide);
  motion(joint, qdd + joint.v, spin_rate, slide_rate);
  b.turn = times(mat3(joint.rotation), turn);
  b.shift = vec3(joint.translation) + times(mat3(joint.rotation), shift);
  const Vec carried = transposed_times(b.turn, parent.w);
  b.w = carried + spin;
  b.dw = transposed_times(b.turn, parent.dw) + cross(carried, spin) + spin_rate;
  const Vec at_origin =
      parent.a + cross(parent.dw, b.shift) + cross(parent.w, cross(parent.w, b.shift));
  const Vec coriolis = cross(carried, slide);
  b.a = transposed_times(b.turn, at_origin) + coriolis + coriolis + cross(spin, slide) + slide_rate;
  const Real turning = parent.size.dw + length(parent.w) * length(parent.w);
  b.size.dw = std::hypot(parent.size.dw, length(carried) * length(spin), length(spin_rate));
  b.size.a = parent.size.a + turning * length(b.shift) + 2 * length(b.w) * length(slide) +
             length(slide_rate);
}

// The torques of a joint: moments and forces along its freedoms.
void take_torques(const Joint& joint, const Body& b, Row* row) {
  const auto take = [&row](const Vec& x, Real size, int first, int count) {
    for (int k = first; k < first + count; ++k, ++row) row->value = x[k], row->size = size;
  };
  switch (joint.kind) {
    case JointKind::kRevolute:
      return take(b.n, b.size.n, 2, 1);
    case JointKind::kPrismatic:
      return take(b.f, b.size.f, 2, 1);
    case JointKind::kSpherical:
      return take(b.n, b.size.n, 0, 3);
    case JointKind::kPlanar:
      return take(b.f, b.size.f, 0, 2), take(b.n, b.size.n, 2, 1);
    case JointKind::kFloating:
      return take(b.f, b.size.f, 0, 3), take(b.n, b.size.n, 0, 3);
  }
}

// A slaved joint counts through its source's torque.
void fold(Row* row) {
  for (const Joint& joint : about.joints) {
    if (joint.source < 0) continue;
    Row& source = row[about.joints[joint.source].v];
    source.value += joint.multiplier * row[joint.v].value;
    source.size += std::abs(joint.multiplier) * row[joint.v].size;
    row[joint.v] = {};
  }
}

// Torques that give accelerations qdd at (q, v) beside the outer forces.
void inverse_dynamics(const Number* q, const Number* v, const Number* qdd, const Number* outer,
                      std::vector<Row>& rows) {
  static std::vector<Body> body;
  body.resize(static_cast<std::size_t>(about.links.count));
  body[0] = {};
  for (int k = 0; k < 3; ++k) body[0].a[k] = -about.gravity[k];
  body[0].size.a = length(body[0].a);
  for (int j = 0; j < about.joints.count; ++j) {
    set_motion(j, q, v, qdd, body);
    set_in_motion(about.links[j + 1], body[static_cast<std::size_t>(j) + 1]);
  }
  push(outer, body);
  for (int j = about.joints.count - 1; j >= 0; --j) {
    const Joint& joint = about.joints[j];
    const Body& b = body[static_cast<std::size_t>(j) + 1];
    take_torques(joint, b, &rows[static_cast<std::size_t>(joint.v)]);
    add_passive(joint, q, v, qdd, &rows[static_cast<std::size_t>(joint.v)]);
    Body& parent = body[static_cast<std::size_t>(joint.parent)];
    const Vec force = times(b.turn, b.f);
    parent.f = parent.f + force;
    parent.n = parent.n + times(b.turn, b.n) + cross(b.shift, force);
    parent.size.f += b.size.f;
    parent.size.n += b.size.n + length(b.shift) * b.size.f;
  }
  fold(rows.data());
}

// How far a slaved acceleration is from following its source, relative to its size, and a
// prescribed one from what was prescribed.
double slip(const Joint& joint, const Number* tau, const Number* qdd) {
  double worst = 0;
  for (int k = joint.v; joint.prescribed && k < joint.v + joint.nv; ++k)
    worst = std::max(worst, std::abs(double(qdd[k]) - double(tau[k])));
  if (joint.source < 0) return worst;
  const double own = double(qdd[joint.v]);
  const double due = joint.multiplier * double(qdd[about.joints[joint.source].v]);
  return std::max(worst, std::abs(own - due) / std::max(1.0, std::abs(due)));
}

// What is left over of the equation of motion.
struct Left {
  std::vector<Real> over, size;  // of each row: ID(q, v, qdd) - tau, and how much is added up there
  double residual = 0;           // length of over beside that of the torques that it balances
  double backward = 0;           // the largest of over / size, the backward error
  int joint = 0;                 // whose row that is
};

// Nobody asks for the torque of a prescribed joint.
Left left_over(const Number* q, const Number* v, const Number* tau, const Number* qdd) {
  const std::size_t nv = static_cast<std::size_t>(about.nv);
  static std::vector<Row> needed(nv), at_rest(nv), given(nv);
  static const std::vector<Number> zero(nv);
  inverse_dynamics(q, v, qdd, tau + nv, needed);
  inverse_dynamics(q, v, zero.data(), tau + nv, at_rest);
  for (std::size_t k = 0; k < nv; ++k) given[k] = {Real(tau[k]), std::abs(Real(tau[k]))};
  fold(given.data());
  Left left;
  left.over.resize(nv), left.size.resize(nv);
  Real error = 0, size = 0;
  for (int j = 0; j < about.joints.count; ++j) {
    const Joint& joint = about.joints[j];
    for (int at = joint.v; !joint.prescribed && at < joint.v + joint.nv; ++at) {
      const std::size_t k = static_cast<std::size_t>(at);
      left.over[k] = needed[k].value - given[k].value,
      left.size[k] = needed[k].size + given[k].size;
      const double part = left.size[k] > 0 ? double(std::abs(left.over[k]) / left.size[k]) : 0;
      if (!(part <= left.backward)) left.backward = part, left.joint = j;
      error += left.over[k] * left.over[k];
      size += given[k].value * given[k].value + at_rest[k].value * at_rest[k].value;
    }
  }
  left.residual = double(size > 0 ? std::sqrt(error / size) : std::sqrt(error));
  return left;
}

}  // namespace check

// Text as a JSON string, in one line.
std::string quoted(const char* text) {
  std::string result;
  add_quoted(result, text);
  return result;
}

// Reads JSON piece by piece; what is wrong is thrown.
class JsonReader {
 protected:
  explicit JsonReader(std::string text) : text_(std::move(text)) {}

  [[noreturn]] void refuse(const std::string& what) const {
    throw std::runtime_error(where_ + what);
  }

  void white() {
    while (at_ < text_.size() && std::strchr(" \t\r\n", text_[at_]) != nullptr) ++at_;
  }
  char peek() {
    white();
    if (at_ >= text_.size()) refuse("the file ends too early");
    return text_[at_];
  }
  void expect(char c) {
    if (peek() != c) refuse(std::string("expected '") + c + "', found '" + text_[at_] + "'");
    ++at_;
  }
  bool take(char c) {
    if (peek() != c) return false;
    ++at_;
    return true;
  }

  template <class Item>
  void array(Item item) {
    if (++depth_ > 64) refuse("nested too deeply");
    expect('[');
    if (!take(']')) {
      do item();
      while (take(','));
      expect(']');
    }
    --depth_;
  }
  template <class Item>
  void object(Item item) {
    if (++depth_ > 64) refuse("nested too deeply");
    expect('{');
    if (!take('}')) {
      do {
        const std::string key = string();
        expect(':');
        item(key);
      } while (take(','));
      expect('}');
    }
    --depth_;
  }

  std::vector<double> numbers() {
    std::vector<double> result;
    if (peek() == '[')
      array([&] { result.push_back(number()); });
    else
      result.push_back(number());
    return result;
  }

  double number() {
    peek();
    const std::size_t start = at_;
    const auto digits = [this] {
      const std::size_t first = at_;
      while (at_ < text_.size() && text_[at_] >= '0' && text_[at_] <= '9') ++at_;
      return at_ > first;
    };
    const auto next_is = [this](char a, char b) {
      return at_ < text_.size() && (text_[at_] == a || text_[at_] == b);
    };
    if (next_is('-', '-')) ++at_;
    bool good = digits();
    if (good && next_is('.', '.')) ++at_, good = digits();
    if (good && next_is('e', 'E')) {
      ++at_;
      if (next_is('+', '-')) ++at_;
      good = digits();
    }
    double value = 0;
    if (good) {
      const auto end = std::from_chars(text_.data() + start, text_.data() + at_, value);
      good = end.ec == std::errc() && end.ptr == text_.data() + at_ && std::isfinite(value);
    }
    if (!good) refuse("expected a finite number");
    return value;
  }

  bool boolean() {
    peek();
    for (const bool value : {true, false}) {
      const std::string word = value ? "true" : "false";
      if (text_.compare(at_, word.size(), word) == 0) {
        at_ += word.size();
        return value;
      }
    }
    refuse("expected true or false");
  }

  std::string string() {
    expect('"');
    std::string result;
    for (;;) {
      if (at_ >= text_.size()) refuse("a string does not end");
      const char c = text_[at_++];
      if (c == '"') return result;
      if (static_cast<unsigned char>(c) < 0x20) refuse("a control character in a string");
      if (c != '\\') {
        result += c;
        continue;
      }
      if (at_ >= text_.size()) refuse("a string does not end");
      const char escape = text_[at_++];
      const char* const from = "\"\\/bfnrt";
      const char* const to = "\"\\/\b\f\n\r\t";
      if (const char* place = std::strchr(from, escape); place != nullptr && escape != '\0')
        result += to[place - from];
      else if (escape == 'u')
        append_utf8(result, code_point());
      else
        refuse("an unknown escape in a string");
    }
  }

  unsigned hex4() {
    if (at_ + 4 > text_.size()) refuse("a string does not end");
    unsigned value = 0;
    const auto end = std::from_chars(text_.data() + at_, text_.data() + at_ + 4, value, 16);
    if (end.ec != std::errc() || end.ptr != text_.data() + at_ + 4)
      refuse("four hexadecimal digits expected");
    at_ += 4;
    return value;
  }
  unsigned code_point() {
    const unsigned high = hex4();
    if (high < 0xD800 || high > 0xDBFF) return high;
    if (text_.compare(at_, 2, "\\u") != 0) refuse("half a surrogate pair in a string");
    at_ += 2;
    return 0x10000 + ((high - 0xD800) << 10) + ((hex4() - 0xDC00) & 0x3FF);
  }
  static void append_utf8(std::string& s, unsigned c) {
    const auto put = [&s](unsigned byte) { s += static_cast<char>(byte); };
    if (c < 0x80) return put(c);
    if (c < 0x800) return put(0xC0 | c >> 6), put(0x80 | (c & 63));
    if (c < 0x10000) return put(0xE0 | c >> 12), put(0x80 | (c >> 6 & 63)), put(0x80 | (c & 63));
    put(0xF0 | c >> 18), put(0x80 | (c >> 12 & 63)), put(0x80 | (c >> 6 & 63)),
        put(0x80 | (c & 63));
  }

  void skip() {
    const char c = peek();
    if (c == '{')
      object([&](const std::string&) { skip(); });
    else if (c == '[')
      array([&] { skip(); });
    else if (c == '"')
      string();
    else if (c == 't' || c == 'f')
      boolean();
    else if (text_.compare(at_, 4, "null") == 0)
      at_ += 4;
    else
      number();
  }

  std::string text_, where_;
  std::size_t at_ = 0;
  int depth_ = 0;
};

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

// Reads a states file (JSON) and writes a result file, joints by name.
struct States {
  int count = 0;
  std::vector<Number> q, v, tau;  // one state after the other
  std::vector<double> gravity;    // where it is set; else none
};

class StatesReader : private JsonReader {
 public:
  explicit StatesReader(std::string text) : JsonReader(std::move(text)) {}

  // Returns an empty string, or what is wrong, as "LINE: message".
  std::string read(States& states) {
    try {
      parse(states);
      return "";
    } catch (const std::runtime_error& error) {
      return std::to_string(
                 1 + std::count(text_.begin(), text_.begin() + static_cast<long>(at_), '\n')) +
             ": error: " + error.what();
    }
  }

 private:
  static std::size_t as_size(int n) { return static_cast<std::size_t>(n); }

  void parse(States& states) {
    std::vector<bool> seen(static_cast<std::size_t>(about.joints.count));
    std::vector<std::vector<double>> forces(static_cast<std::size_t>(about.outer_forces.count));
    bool joints = false;
    object([&](const std::string& key) {
      if (key == "joints") {
        joints = true;
        object([&](const std::string& name) { read_joint(name, seen, states); });
      } else if (key == "forces" && about.outer_forces.count > 0) {
        object([&](const std::string& name) { read_force(name, forces); });
      } else if (key == "floating") {
        if (boolean() != about.floating)
          refuse(std::string("\"floating\": this solver's base is ") +
                 (about.floating ? "floating" : "fixed") + "; generate it anew");
      } else if (key == "gravity") {
        const std::vector<double> given = numbers();
        if (given.size() != 3) refuse("\"gravity\" is not three numbers");
        if (about.sets_gravity)
          states.gravity = given;
        else if (!std::equal(given.begin(), given.end(), about.gravity))
          refuse("\"gravity\": another gravity is compiled into this solver; generate it anew");
      } else {
        refuse("unknown member " + quoted(key.c_str()));
      }
    });
    white();
    if (at_ != text_.size()) refuse("text behind the end");
    if (!joints) refuse("\"joints\" is missing");
    for (int j = 0; j < about.joints.count; ++j)
      if (!seen[j] && about.joints[j].source < 0)
        refuse("joint " + quoted(about.joints[j].name) + " is missing");
    fill_slaved(states);
    for (int k = 0; k < about.outer_forces.count; ++k) fill_force(k, forces[as_size(k)], states);
  }

  void read_joint(const std::string& name, std::vector<bool>& seen, States& states) {
    int j = 0;
    while (j < about.joints.count && name != about.joints[j].name) ++j;
    if (j == about.joints.count) refuse("unknown joint " + quoted(name.c_str()));
    const std::string joint = "joint " + quoted(name.c_str());
    if (seen[j]) refuse(joint + " comes twice");
    seen[j] = true;
    std::array<bool, 3> found{};
    const char* const input = about.joints[j].prescribed ? "qdd" : "tau";
    object([&](const std::string& key) {
      if (key == "type" || (key == "qdd" && key != input))
        return skip();  // as in a file of true answers
      const char* const fields[] = {"q", "v", input};
      const auto field = std::find(std::begin(fields), std::end(fields), key);
      if (field == std::end(fields)) refuse(joint + ": unknown member " + quoted(key.c_str()));
      bool& there = found[static_cast<std::size_t>(field - std::begin(fields))];
      if (there) refuse(joint + ": " + key + " comes twice");
      there = true;
      where_ = joint + ": " + key + ": ";
      read_field(about.joints[j], key, states);
      where_.clear();
    });
    if (!found[0] || !found[1] || !found[2]) refuse(joint + " needs q, v and " + input);
  }

  // One of q, v and tau of a joint: an entry for each state.
  void read_field(const Joint& joint, const std::string& key, States& states) {
    const bool is_q = key == "q";
    const auto size = static_cast<std::size_t>(is_q ? joint.nq : joint.nv);
    const auto start = static_cast<std::size_t>(is_q ? joint.q : joint.v);
    const std::size_t stride = as_size(is_q ? about.nq : key == "v" ? about.nv : about.ntau);
    std::vector<Number>& values = is_q ? states.q : key == "v" ? states.v : states.tau;
    int count = 0;
    array([&] {
      const std::vector<double> entry = numbers();
      if (entry.size() != size)
        refuse("state " + std::to_string(count + 1) + " has " + std::to_string(entry.size()) +
               " numbers, not " + std::to_string(size));
      const std::size_t row = stride * static_cast<std::size_t>(count);
      if (values.size() < row + stride) values.resize(row + stride);
      for (std::size_t k = 0; k < size; ++k)
        values[row + start + k] = static_cast<Number>(entry[k]);
      ++count;
    });
    if (count == 0) refuse("there is no state");
    if (states.count == 0) states.count = count;
    if (count != states.count)
      refuse(std::to_string(count) + " states, but others have " + std::to_string(states.count));
  }

  // One link's outer force: six numbers for each state.
  void read_force(const std::string& name, std::vector<std::vector<double>>& forces) {
    int k = 0;
    while (k < about.outer_forces.count && name != about.outer_forces[k].name) ++k;
    if (k == about.outer_forces.count)
      refuse("no outer force acts on link " + quoted(name.c_str()));
    where_ = "force on link " + quoted(name.c_str()) + ": ";
    std::vector<double>& own = forces[as_size(k)];
    if (!own.empty()) refuse("comes twice");
    array([&] {
      const std::vector<double> entry = numbers();
      if (entry.size() != 6) refuse("needs six numbers for each state");
      own.insert(own.end(), entry.begin(), entry.end());
    });
    where_.clear();
  }

  void fill_force(int k, const std::vector<double>& given, States& states) {
    if (given.size() != 6 * static_cast<std::size_t>(states.count))
      refuse("force on link " + quoted(about.outer_forces[k].name) + ": " +
             std::to_string(given.size() / 6) + " states, but the joints have " +
             std::to_string(states.count));
    for (std::size_t i = 0; i < given.size(); ++i)
      states.tau[i / 6 * as_size(about.ntau) + as_size(about.nv + 6 * k) + i % 6] =
          static_cast<Number>(given[i]);
  }

  static void fill_slaved(States& states) {
    for (int s = 0; s < states.count; ++s)
      slave(about.joints, states.q.data() + static_cast<long>(s) * about.nq,
            states.v.data() + static_cast<long>(s) * about.nv);
  }
};

// One number, or several in brackets.
void write_numbers(std::FILE* file, const Number* x, int count) {
  if (count > 1) std::fputs("[", file);
  for (int k = 0; k < count; ++k)
    if (x[k] == x[k])
      std::fprintf(file, "%s%.17g", k == 0 ? "" : ", ", static_cast<double>(x[k]));
    else  // of a batch, a state that failed
      std::fputs(k == 0 ? "null" : ", null", file);
  if (count > 1) std::fputs("]", file);
}

// The forces of loops or couplings, which start at an entry of each state; returns where they end.
template <class Things>
int write_forces(std::FILE* file, const char* what, const Things& things, int numbers,
                 const std::vector<Number>& qdd, int count, int at) {
  if (things.count > 0) std::fprintf(file, ",\n\"%s\": {", what);
  for (int k = 0; k < things.count; ++k, at += numbers) {
    std::fprintf(file, "%s\n%s: {\"force\": [", k == 0 ? "" : ",", quoted(things[k].name).c_str());
    for (int s = 0; s < count; ++s) {
      std::fputs(s == 0 ? "" : ", ", file);
      write_numbers(file, qdd.data() + static_cast<long>(s) * about.nqdd + at, numbers);
    }
    std::fputs("]}", file);
  }
  if (things.count > 0) std::fputs("\n}", file);
  return at;
}

// more: further members of the file, each after a comma.
bool write_result(const std::string& path, const std::vector<Number>& qdd, int count,
                  const std::string& more) {
  std::FILE* file = std::fopen(path.c_str(), "w");
  if (file == nullptr) return false;
  std::fputs("{\"joints\": {", file);
  for (int j = 0; j < about.joints.count; ++j) {
    std::fprintf(file, "%s\n%s: {\"qdd\": [", j == 0 ? "" : ",",
                 quoted(about.joints[j].name).c_str());
    for (int s = 0; s < count; ++s) {
      const Number* x = qdd.data() + static_cast<long>(s) * about.nqdd + about.joints[j].v;
      std::fputs(s == 0 ? "" : ", ", file);
      write_numbers(file, x, about.joints[j].nv);
    }
    std::fputs("]}", file);
  }
  std::fputs("\n}", file);
  if (about.nqdd >
      about.nv) {  // behind the accelerations: six numbers of each loop, one of each coupling
    int at = about.nv;
    at = write_forces(file, "loops", about.loops, 6, qdd, count, at);
    write_forces(file, "couplings", about.couplings, 1, qdd, count, at);
  }
  std::fprintf(file, "%s}\n", more.c_str());
  const bool good = std::ferror(file) == 0;
  return std::fclose(file) == 0 && good;
}

// Configurations as points of a manifold. Near an anchor q0 a configuration has local coordinates
// x, as many as velocities: a rotation vector in the child's frame where there is a quaternion,
// the change of q itself elsewhere (of a floating or planar joint's position: in its joint frame).
namespace manifold {

using State = std::vector<double>;

// a x b.
inline void cross(const double* a, const double* b, double* result) {
  for (int k = 0; k < 3; ++k)
    result[k] = a[(k + 1) % 3] * b[(k + 2) % 3] - a[(k + 2) % 3] * b[(k + 1) % 3];
}

// The joint's own rotation takes v, in the child's frame, to the joint frame: v + 2 p x (w v + p x
// v) for a quaternion (p, w) of any length.
inline void rotate(const double* quaternion, const double* v, double* result) {
  double squared = 0, inner[3], outer[3];
  for (int k = 0; k < 4; ++k) squared += quaternion[k] * quaternion[k];
  cross(quaternion, v, inner);
  for (int k = 0; k < 3; ++k) inner[k] += quaternion[3] * v[k];
  cross(quaternion, inner, outer);
  for (int k = 0; k < 3; ++k) result[k] = v[k] + 2 / squared * outer[k];
}

// Quaternions p times (x, w).
inline void multiply(const double* p, const double* x, double w, double* result) {
  double twisted[3];
  cross(p, x, twisted);
  for (int k = 0; k < 3; ++k) result[k] = p[3] * x[k] + w * p[k] + twisted[k];
  result[3] = p[3] * w - (p[0] * x[0] + p[1] * x[1] + p[2] * x[2]);
}

inline double length(const double* x, int count) {
  double squared = 0;
  for (int k = 0; k < count; ++k) squared += x[k] * x[k];
  return std::sqrt(squared);
}

constexpr bool turns_freely(const Joint& joint) { return joint.nq >= 4; }

ADAGEN_HOT void normalise(State& q) {
  for (const Joint& joint : about.joints) {
    if (!turns_freely(joint)) continue;
    double* const quaternion = &q[static_cast<std::size_t>(joint.q + joint.nq - 4)];
    const double size = length(quaternion, 4);
    if (!(size > 0)) continue;  // the solver refuses it by name
    for (int k = 0; k < 4; ++k) quaternion[k] /= size;
  }
}

// Velocity of the origin of a floating or planar joint's child, told in the joint frame; its row
// count.
inline int position_rate(const Joint& joint, const double* q, const double* v, double* rate) {
  if (joint.kind == JointKind::kFloating) {
    rotate(q + 3, v, rate);
    return 3;
  }
  if (joint.kind != JointKind::kPlanar) return 0;
  const double c = std::cos(q[2]), s = std::sin(q[2]);
  rate[0] = c * v[0] - s * v[1];
  rate[1] = s * v[0] + c * v[1];
  return 2;
}

// q' as numbers: quaternions by half their product with the angular velocity.
ADAGEN_HOT void rate(const State& q, const State& v, State& result) {
  for (const Joint& joint : about.joints) {
    const double* const own = &q[static_cast<std::size_t>(joint.q)];
    const double* const speed = &v[static_cast<std::size_t>(joint.v)];
    double* const to = &result[static_cast<std::size_t>(joint.q)];
    const int done = position_rate(joint, own, speed, to);
    if (turns_freely(joint)) {
      const double half[3] = {speed[done] / 2, speed[done + 1] / 2, speed[done + 2] / 2};
      multiply(own + done, half, 0, to + done);
    } else {
      std::copy(speed + done, speed + joint.nv, to + done);
    }
  }
}

// x' at local coordinates x, where the configuration is q: for rotations the inverse of the
// exponential's derivative, v + x x v / 2 + c x x (x x v), c = (1 - a cot a) / (2 a)^2 at a =
// |x|/2.
ADAGEN_HOT void local_rate(const State& q, const State& x, const State& v, State& result) {
  for (const Joint& joint : about.joints) {
    const double* const speed = &v[static_cast<std::size_t>(joint.v)];
    double* const to = &result[static_cast<std::size_t>(joint.v)];
    const int done = position_rate(joint, &q[static_cast<std::size_t>(joint.q)], speed, to);
    std::copy(speed + done, speed + joint.nv, to + done);
    if (!turns_freely(joint)) continue;
    const double* const turn = &x[static_cast<std::size_t>(joint.v + done)];
    const double half = length(turn, 3) / 2;
    const double c = half < 1e-3 ? 1.0 / 12 + half * half / 180
                                 : (1 - half / std::tan(half)) / (4 * half * half);
    double once[3], twice[3];
    cross(turn, speed + done, once);
    cross(turn, once, twice);
    for (int k = 0; k < 3; ++k) to[done + k] += once[k] / 2 + c * twice[k];
  }
}

// The configuration with local coordinates x about the anchor.
ADAGEN_HOT void advance(const State& anchor, const State& x, State& q) {
  for (const Joint& joint : about.joints) {
    const double* const from = &anchor[static_cast<std::size_t>(joint.q)];
    const double* const by = &x[static_cast<std::size_t>(joint.v)];
    double* const to = &q[static_cast<std::size_t>(joint.q)];
    const int plain = turns_freely(joint) ? joint.nq - 4 : joint.nq;
    for (int k = 0; k < plain; ++k) to[k] = from[k] + by[k];
    if (!turns_freely(joint)) continue;
    const double* const turn = by + plain;
    const double half = length(turn, 3) / 2;
    const double part = half < 1e-3 ? 0.5 - half * half / 12 : std::sin(half) / (2 * half);
    const double vector[3] = {part * turn[0], part * turn[1], part * turn[2]};
    multiply(from + plain, vector, std::cos(half), to + plain);
  }
}

// A configuration moved by a step in the components of velocities.
inline void move(const State& from, const State& step, State& q) {
  State local = step;
  for (const Joint& joint : about.joints)  // positions are told in the joint frame
    position_rate(joint, &from[static_cast<std::size_t>(joint.q)],
                  &step[static_cast<std::size_t>(joint.v)],
                  &local[static_cast<std::size_t>(joint.v)]);
  advance(from, local, q);
  normalise(q);
}

}  // namespace manifold

// Closed loops: how far they are open, how fast, and states in which they are closed. In long
// double, straight from the frames of the model, in axes of the ground.
namespace loops {

using check::Mat;
using check::Real;
using check::Vec;
using check::operator+;

struct Pose {
  Mat turn;    // link to ground coordinates
  Vec origin;  // in ground coordinates
};

// Constraints at a configuration: gaps, and the rows J of their rates.
struct Constraints {
  std::vector<Real> gaps, rows;  // rows: one after the other

  int count() const { return static_cast<int>(gaps.size()); }
  Real* row(int k) { return rows.data() + static_cast<std::size_t>(k) * std::size_t(about.nv); }
  const Real* row(int k) const {
    return rows.data() + static_cast<std::size_t>(k) * std::size_t(about.nv);
  }
};

inline bool any() { return about.loops.count + about.couplings.count > 0; }
inline Real dot(const Vec& a, const Vec& b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }
inline Vec minus(const Vec& a, const Vec& b) { return {a[0] - b[0], a[1] - b[1], a[2] - b[2]}; }
inline Vec column(const Mat& m, int k) { return {m[0][k], m[1][k], m[2][k]}; }

inline std::vector<Pose> poses(const Number* q) {
  std::vector<Pose> result(static_cast<std::size_t>(about.links.count));
  result[0] = {{Vec{1, 0, 0}, Vec{0, 1, 0}, Vec{0, 0, 1}}, {}};
  for (int j = 0; j < about.joints.count; ++j) {
    const Joint& joint = about.joints[j];
    const Pose& parent = result[static_cast<std::size_t>(joint.parent)];
    Mat turn;
    Vec shift;
    check::displace(joint, q + joint.q, turn, shift);
    const Mat base = check::mat3(joint.rotation);
    const Vec place = check::vec3(joint.translation) + check::times(base, shift);
    result[static_cast<std::size_t>(j) + 1] = {check::times(parent.turn, check::times(base, turn)),
                                               parent.origin + check::times(parent.turn, place)};
  }
  return result;
}

// Both frames of a loop in ground coordinates.
struct Frames {
  const Loop& loop;
  Mat axes1, axes2;
  Vec place1, place2;  // of their origins
  Vec apart;           // from the first to the second
  Vec seen;            // where frame 2 is if the loop is closed: a point of link 1

  Frames(const Loop& given, const std::vector<Pose>& pose) : loop(given) {
    const Pose& one = pose[static_cast<std::size_t>(loop.link1)];
    const Pose& two = pose[static_cast<std::size_t>(loop.link2)];
    axes1 = check::times(one.turn, check::mat3(loop.rotation1));
    axes2 = check::times(two.turn, check::mat3(loop.rotation2));
    place1 = one.origin + check::times(one.turn, check::vec3(loop.translation1));
    place2 = two.origin + check::times(two.turn, check::vec3(loop.translation2));
    apart = minus(place2, place1);
    seen = place1;
    for (int k = 0; k < 3; ++k) {
      if (loop.holds(k)) continue;
      const Vec axis = column(axes1, k);
      for (int i = 0; i < 3; ++i) seen[i] += axis[i] * dot(axis, apart);
    }
  }

  // The direction about which the k-th angular row is: an axis of frame 1, or the common normal.
  Vec turning_axis(int k) const {
    return loop.universal ? check::cross(column(axes2, 2), column(axes1, 2)) : column(axes1, k);
  }

  Real misaligned(int k) const {
    if (loop.universal) return dot(column(axes1, 2), column(axes2, 2));
    const bool whole = loop.bars(2);
    Vec twist{};
    for (int i = whole ? 0 : 2; i < 3; ++i)
      twist = twist + check::cross(column(axes1, i), column(axes2, i));
    return dot(column(axes1, k), twist) / (whole ? 2 : 1);
  }

  // Calls for each row: whether it is of places, its direction, its gap.
  template <class Do>
  void each(Do row) const {
    for (int k = 0; k < 3; ++k)
      if (loop.holds(k)) row(true, column(axes1, k), dot(column(axes1, k), apart));
    for (int k = 0; k < 3; ++k)
      if (loop.bars(k)) row(false, turning_axis(k), misaligned(k));
  }
};

// Adds how fast a point of a link moves along a direction, or the link turns about it.
inline void add_rate(const std::vector<Pose>& pose, int link, Real sign, bool linear, const Vec& n,
                     const Vec& place, Real* row) {
  for (; link > 0; link = about.joints[link - 1].parent) {
    const Joint& joint = about.joints[link - 1];
    const Pose& own = pose[static_cast<std::size_t>(link)];
    for (int k = 0; k < joint.nv; ++k) {
      Number unit[6] = {};
      unit[k] = 1;
      Vec angular, sliding;
      check::motion(joint, unit, angular, sliding);
      const Vec w = check::times(own.turn, angular);
      const Vec v = check::times(own.turn, sliding) + check::cross(w, minus(place, own.origin));
      row[joint.v + k] += sign * dot(n, linear ? v : w);
    }
  }
}

inline Constraints constraints(const Number* q) {
  Constraints found;
  const std::vector<Pose> pose = poses(q);
  const auto add = [&found](Real gap) {
    found.gaps.push_back(gap);
    found.rows.resize(found.rows.size() + static_cast<std::size_t>(about.nv));
    return found.row(found.count() - 1);
  };
  for (const Loop& loop : about.loops) {
    const Frames frames(loop, pose);
    frames.each([&](bool linear, const Vec& n, Real gap) {
      Real* const row = add(gap);
      add_rate(pose, loop.link2, 1, linear, n, frames.place2, row);
      add_rate(pose, loop.link1, -1, linear, n, frames.seen, row);
    });
  }
  for (const Coupling& coupling : about.couplings) {
    Real gap = -Real(coupling.offset);
    for (int k = 0; k < coupling.count; ++k)
      gap += Real(coupling.factors[k]) * Real(q[about.joints[coupling.joints[k]].q]);
    Real* const row = add(gap);
    for (int k = 0; k < coupling.count; ++k)
      row[about.joints[coupling.joints[k]].v] += Real(coupling.factors[k]);
  }
  return found;
}

// x = W J^T y with (J W J^T + damping) y = r, the damping beside rows brought to one size: for a
// small one the x of least size that moves the gaps by r, as far as it can be had. W: weights,
// or 1.
inline std::vector<Real> least(const Constraints& at, const std::vector<Real>& r, Real damping,
                               const std::vector<Real>* weights, std::vector<Real>* forces) {
  const int m = at.count(), n = about.nv;
  const std::size_t rows = static_cast<std::size_t>(m);
  std::vector<Real> square(rows * rows), y(r), x(static_cast<std::size_t>(n));
  const auto weight = [weights](int k) { return weights ? (*weights)[std::size_t(k)] : Real(1); };
  const auto entry = [&square, m](int i, int k) -> Real& {
    return square[static_cast<std::size_t>(i * m + k)];
  };
  std::vector<Real> scale(rows);  // rows in metres and radians, light and heavy, come to one size
  for (int i = 0; i < m; ++i) {
    for (int k = 0; k <= i; ++k)
      for (int j = 0; j < n; ++j) entry(i, k) += at.row(i)[j] * weight(j) * at.row(k)[j];
    scale[std::size_t(i)] = entry(i, i) > 0 ? 1 / std::sqrt(entry(i, i)) : 0;
    for (int k = 0; k <= i; ++k) entry(i, k) *= scale[std::size_t(i)] * scale[std::size_t(k)];
    entry(i, i) += damping;
    y[std::size_t(i)] *= scale[std::size_t(i)];
  }
  for (int i = 0; i < m; ++i) {  // L L^T
    for (int k = 0; k <= i; ++k) {
      for (int j = 0; j < k; ++j) entry(i, k) -= entry(i, j) * entry(k, j);
      if (k < i)
        entry(i, k) /= entry(k, k) > 0 ? entry(k, k) : 1;
      else
        entry(i, i) = entry(i, i) > 0 ? std::sqrt(entry(i, i)) : 0;
    }
  }
  const auto divided = [&entry](Real value, int i) {
    return entry(i, i) > 0 ? value / entry(i, i) : 0;
  };
  for (int i = 0; i < m; ++i) {
    for (int k = 0; k < i; ++k) y[std::size_t(i)] -= entry(i, k) * y[std::size_t(k)];
    y[std::size_t(i)] = divided(y[std::size_t(i)], i);
  }
  for (int i = m - 1; i >= 0; --i) {
    for (int k = i + 1; k < m; ++k) y[std::size_t(i)] -= entry(k, i) * y[std::size_t(k)];
    y[std::size_t(i)] = divided(y[std::size_t(i)], i);
  }
  for (int i = 0; i < m; ++i) y[std::size_t(i)] *= scale[std::size_t(i)];
  for (int i = 0; i < m; ++i)
    for (int j = 0; j < n; ++j) x[std::size_t(j)] += weight(j) * at.row(i)[j] * y[std::size_t(i)];
  if (forces != nullptr) *forces = y;
  return x;
}

inline Real largest(const std::vector<Real>& values) {
  Real size = 0;
  for (const Real x : values) size = std::max(size, std::abs(x));
  return size;
}

constexpr Real kLittle = 1e-15L;  // damping beside rows that follow from others

// Newton's method with Levenberg's damping, as near as can be. Returns how far loops stay open.
inline Real close(std::vector<double>& q) {
  std::vector<Number> at(q.size());
  const auto found = [&at](const std::vector<double>& x) {
    std::transform(x.begin(), x.end(), at.begin(), [](double y) { return static_cast<Number>(y); });
    return constraints(at.data());
  };
  const auto cost = [](const Constraints& one) {
    Real sum = 0;
    for (const Real gap : one.gaps) sum += gap * gap;
    return sum;
  };
  constexpr Real kRounding = std::numeric_limits<Number>::epsilon();
  Constraints now = found(q);
  Real damping = 1e-3L;
  for (int k = 0; k < 100 && largest(now.gaps) > kRounding && damping < 1e6L; ++k) {
    const std::vector<Real> step =
        least(now, now.gaps, std::max(damping, kLittle), nullptr, nullptr);
    std::vector<double> by(step.size()), next(q);
    std::transform(step.begin(), step.end(), by.begin(), [](Real x) { return double(-x); });
    manifold::move(q, by, next);
    Constraints tried = found(next);
    if (cost(tried) < cost(now))
      q = next, now = std::move(tried), damping *= 0.1L;
    else
      damping = std::max(damping, kLittle) * 10;
  }
  return largest(now.gaps);
}

// Takes from velocities what would tear loops open.
inline void hold(const Number* q, std::vector<double>& v) {
  const Constraints now = constraints(q);
  for (int again = 0; again < 2; ++again) {
    std::vector<Real> rates(now.gaps.size());
    for (int i = 0; i < now.count(); ++i)
      for (int j = 0; j < about.nv; ++j)
        rates[std::size_t(i)] += now.row(i)[j] * Real(v[std::size_t(j)]);
    const std::vector<Real> excess = least(now, rates, kLittle, nullptr, nullptr);
    for (std::size_t j = 0; j < v.size(); ++j) v[j] -= double(excess[j]);
  }
}

// Closes a state that is nearly closed; whether that can be.
inline bool settle(std::vector<double>& q, std::vector<double>& v) {
  constexpr Real kClosed = sizeof(Number) == sizeof(double) ? 1e-10L : 3e-5L;
  if (!(close(q) <= kClosed)) return false;
  std::vector<Number> at(q.begin(), q.end());
  hold(at.data(), v);
  return true;
}

// The size of a row of the acceleration, and how far it is from zero.
struct Parting {
  Real value, size;
};

inline Parting parting(const Frames& frames, const std::vector<Pose>& pose,
                       const std::vector<check::Body>& body, const Number* v, bool linear,
                       const Vec& n) {
  const Loop& loop = frames.loop;
  Vec spin[2], spin_rate[2], at[2];
  Real size = 0;
  const int links[] = {loop.link1, loop.link2};
  const Vec places[] = {frames.seen, frames.place2};
  for (int k = 0; k < 2; ++k) {
    const check::Body& b = body[static_cast<std::size_t>(links[k])];
    const Pose& own = pose[static_cast<std::size_t>(links[k])];
    const Vec arm = minus(places[k], own.origin);
    spin[k] = check::times(own.turn, b.w), spin_rate[k] = check::times(own.turn, b.dw);
    at[k] = check::times(own.turn, b.a) + check::cross(spin_rate[k], arm) +
            check::cross(spin[k], check::cross(spin[k], arm));
    const Real turning = b.size.dw + dot(b.w, b.w);
    size += linear ? b.size.a + turning * check::length(arm) : turning;
  }
  const Vec turning = minus(spin[1], spin[0]);
  if (linear) {
    Vec sliding{};
    for (int k = 0; k < 3; ++k) {
      if (loop.holds(k)) continue;
      const Vec axis = column(frames.axes1, k);
      std::vector<Real> row(static_cast<std::size_t>(about.nv));
      add_rate(pose, loop.link2, 1, true, axis, frames.place2, row.data());
      add_rate(pose, loop.link1, -1, true, axis, frames.seen, row.data());
      Real speed = 0;
      for (std::size_t j = 0; j < row.size(); ++j) speed += row[j] * Real(v[j]);
      for (int i = 0; i < 3; ++i) sliding[i] += axis[i] * speed;
    }
    const Vec coriolis = check::cross(spin[0], sliding);
    size += 2 * check::length(coriolis);
    return {dot(n, minus(minus(at[1], at[0]), coriolis + coriolis)), size};
  }
  const Real rates = dot(n, minus(spin_rate[1], spin_rate[0]));
  if (!loop.universal) return {rates - dot(n, check::cross(spin[0], turning)), size};
  const Vec a = column(frames.axes1, 2), b = column(frames.axes2, 2);
  const Vec changing =
      check::cross(check::cross(spin[1], b), a) + check::cross(b, check::cross(spin[0], a));
  return {rates + dot(changing, turning), size};
}

// What is left over of the equation of motion may be forces of constraints: those that fit best are
// taken from it. In exchange accelerations must not tear loops open.
inline void account(const Number* q, const Number* v, const Number* qdd, check::Left& left) {
  const Constraints now = constraints(q);
  const std::size_t nv = left.over.size();
  std::vector<Real> weights(nv), held(nv);
  // Links without mass have rows of no size, which constraint forces have to balance all the same.
  const Real usual = std::max(largest(left.size), std::numeric_limits<Real>::min()) * 1e-4L;
  for (std::size_t k = 0; k < nv; ++k) {
    const Real size = std::max(left.size[k], usual);
    weights[k] = 1 / (size * size);
  }
  const auto squares = [&left] {
    Real sum = 0;
    for (const Real x : left.over) sum += x * x;
    return sum;
  };
  const Real before = squares();
  for (int again = 0; again < 4; ++again) {  // the damping's share is left to the next
    std::vector<Real> right(now.gaps.size()), forces;
    for (int i = 0; i < now.count(); ++i)
      for (std::size_t k = 0; k < nv; ++k)
        right[static_cast<std::size_t>(i)] += now.row(i)[k] * weights[k] * left.over[k];
    least(now, right, kLittle, &weights, &forces);
    for (std::size_t k = 0; k < nv; ++k)
      for (int i = 0; i < now.count(); ++i) {
        const Real part = now.row(i)[k] * forces[static_cast<std::size_t>(i)];
        left.over[k] -= part;
        if (again == 0) held[k] += std::abs(part);
      }
  }
  for (std::size_t k = 0; k < nv; ++k) left.size[k] += held[k];
  const Real after = squares();
  left.residual *= before > 0 ? double(std::sqrt(after / before)) : 1;
  left.backward = 0;
  // Beside the largest, what is as small as this is rounding noise: of joints that nothing moves.
  constexpr Real kNoise = 1e-8L;
  const auto note = [&left](Real value, Real size, int joint) {
    const double part = size > 0 ? double(std::abs(value) / size) : 0;
    if (!(part <= left.backward)) left.backward = part, left.joint = joint;
  };
  const Real least_size = kNoise * largest(left.size);
  for (int j = 0; j < about.joints.count; ++j)
    for (int k = about.joints[j].v; k < about.joints[j].v + about.joints[j].nv; ++k)
      note(left.over[static_cast<std::size_t>(k)],
           std::max(least_size, left.size[static_cast<std::size_t>(k)]), j);
  std::vector<check::Body> body(static_cast<std::size_t>(about.links.count));
  for (int k = 0; k < 3; ++k) body[0].a[k] = -about.gravity[k];
  body[0].size.a = check::length(body[0].a);
  for (int j = 0; j < about.joints.count; ++j) check::set_motion(j, q, v, qdd, body);
  const std::vector<Pose> pose = poses(q);
  for (const Loop& loop : about.loops) {
    const Frames frames(loop, pose);
    frames.each([&](bool linear, const Vec& n, Real) {
      const Parting found = parting(frames, pose, body, v, linear, n);
      note(found.value, found.size, std::max(loop.link1, loop.link2) - 1);
    });
  }
  Real fastest = 0;
  for (int k = 0; k < about.nv; ++k) fastest = std::max(fastest, std::abs(Real(qdd[k])));
  for (const Coupling& coupling : about.couplings) {
    Real sum = 0, size = kNoise * fastest;
    for (int k = 0; k < coupling.count; ++k) {
      const Real part = Real(coupling.factors[k]) * Real(qdd[about.joints[coupling.joints[k]].v]);
      sum += part, size += std::abs(part);
    }
    note(sum, size, coupling.joints[0]);
  }
}

}  // namespace loops

// Damping D, stiffness K and friction of joints as they act at the end of a step, where these
// joints move with v + u instead of v: they take g(u) = (D + h K) u + friction at v + u less
// friction at v of the torques with springs at q + h v, for which a0 would be the answer. From the
// evaluations of unit torques, M = (H^-1) at these joints: u = h (a0 - M g(u)). One evaluation for
// each such degree of freedom, and two.
class PassiveTerms {
 public:
  using State = std::vector<double>;

  PassiveTerms() {
    for (State* x : {&extra_, &base_, &unit_}) x->resize(static_cast<std::size_t>(about.nv));
    for (const Joint& joint : about.joints)
      for (int k = 0; k < joint.nv; ++k) {
        if (!joint.prescribed && (joint.damping > 0 || joint.stiffness > 0 || joint.friction > 0))
          rows_.push_back({static_cast<std::size_t>(joint.v + k), double(joint.damping),
                           double(joint.stiffness), double(joint.friction),
                           double(joint.friction_speed)});
      }
    for (State* x : {&taken_, &next_, &slope_, &u_, &du_}) x->resize(rows_.size());
    for (State* x : {&matrix_, &factors_}) x->resize(rows_.size() * rows_.size());
  }

  // a at the end of a step of length h from (q, v).
  template <class Accelerate>
  int accelerate(double h, const State& q, const State& v, State& a, Accelerate evaluate) {
    const std::size_t n = rows_.size();
    std::fill(extra_.begin(), extra_.end(), 0.0);
    for (const Row& row : rows_) extra_[row.v] = -h * row.stiffness * v[row.v];
    if (const int failed = evaluate(q, v, extra_, base_)) return failed;
    if (n == 0) {
      a = base_;
      return kFine;
    }
    for (std::size_t k = 0; k < n; ++k) {
      const double before = extra_[rows_[k].v];
      extra_[rows_[k].v] += 1;
      if (const int failed = evaluate(q, v, extra_, unit_)) return failed;
      extra_[rows_[k].v] = before;
      for (std::size_t i = 0; i < n; ++i)
        matrix_[i * n + k] = unit_[rows_[i].v] - base_[rows_[i].v];
    }
    settle(h, v);
    for (std::size_t k = 0; k < n; ++k) extra_[rows_[k].v] -= taken_[k];
    return evaluate(q, v, extra_, a);
  }

 private:
  struct Row {
    std::size_t v;
    double damping, stiffness, friction, friction_speed;

    bool rubs() const { return friction > 0; }

    // What is taken at the end of a step that changes the velocity v by u.
    double torque(double h, double at, double u) const {
      const double linear = (damping + h * stiffness) * u;
      if (!rubs()) return linear;
      return linear +
             friction * (std::tanh((at + u) / friction_speed) - std::tanh(at / friction_speed));
    }

    // Its derivative by u.
    double slope(double h, double end) const {
      if (!rubs()) return damping + h * stiffness;
      const double part = std::tanh(end / friction_speed);
      return damping + h * stiffness + friction / friction_speed * (1 - part) * (1 + part);
    }
  };

  static constexpr int kMostSteps = 100;
  static constexpr double kNear = 1e-10, kFlat = 0.1;

  // taken_ <- g(u) by Newton's method. g grows with u and M is positive semi-definite, so that u is
  // where a convex function is least: a step is shortened until that function no longer rises
  // steeply. What is linear takes one step.
  void settle(double h, const State& v) {
    const bool rubs =
        std::any_of(rows_.begin(), rows_.end(), [](const Row& row) { return row.rubs(); });
    std::fill(taken_.begin(), taken_.end(), 0.0);
    for (int step = 0; step < (rubs ? kMostSteps : 1); ++step) {
      aim(h, v);
      const double length = rubs ? step_length(h, v) : 1;
      bool near = true;
      for (std::size_t k = 0; k < rows_.size(); ++k) {
        const double change = next_[k] - taken_[k];
        taken_[k] += length * change;
        near &= std::abs(change) <= kNear * std::abs(taken_[k]) ||
                std::abs(du_[k]) <= kNear * (std::abs(v[rows_[k].v]) + std::abs(u_[k]));
      }
      if (near || length == 0) return;
    }
  }

  // From taken_: u_; by the derivative there, next_ as taken_ would be and du_ as u_ would change.
  ADAGEN_HOT void aim(double h, const State& v) {
    const std::size_t n = rows_.size();
    for (std::size_t i = 0; i < n; ++i) {
      const Row& row = rows_[i];
      double a = base_[row.v];
      for (std::size_t k = 0; k < n; ++k) a -= matrix_[i * n + k] * taken_[k];
      u_[i] = h * a;
      slope_[i] = row.slope(h, v[row.v] + u_[i]);
      next_[i] = slope_[i] * (h * base_[row.v] - u_[i]) + row.torque(h, v[row.v], u_[i]);
      for (std::size_t k = 0; k < n; ++k)
        factors_[i * n + k] = (i == k) + h * slope_[i] * matrix_[i * n + k];
    }
    solve();
    for (std::size_t i = 0; i < n; ++i) {
      du_[i] = 0;
      for (std::size_t k = 0; k < n; ++k) du_[i] -= h * matrix_[i * n + k] * (next_[k] - taken_[k]);
    }
  }

  // How much of the way from taken_ to next_ is gone, at most 1; 0 where there is nowhere to go.
  double step_length(double h, const State& v) const {
    const double start = rise(0, h, v);
    if (!(start < 0)) return 0;
    double low = 0, high = 1, length = 1;
    for (int halvings = 0; halvings < 60; ++halvings) {
      const double found = rise(length, h, v);
      if (std::abs(found) <= -kFlat * start || (length == 1 && found < 0)) break;
      (found > 0 ? high : low) = length;
      length = (low + high) / 2;
    }
    return length;
  }

  // The convex function's derivative at a part of the way.
  ADAGEN_HOT double rise(double part, double h, const State& v) const {
    double sum = 0;
    for (std::size_t k = 0; k < rows_.size(); ++k) {
      const double there = taken_[k] + part * (next_[k] - taken_[k]);
      sum += du_[k] * (rows_[k].torque(h, v[rows_[k].v], u_[k] + part * du_[k]) - there);
    }
    return sum;
  }

  // next_ <- factors_^-1 next_ by elimination, without pivoting: but for scales of rows and
  // columns the matrix is symmetric and positive definite.
  ADAGEN_HOT void solve() {
    const std::size_t n = rows_.size();
    for (std::size_t k = 0; k < n; ++k)
      for (std::size_t i = k + 1; i < n; ++i) {
        const double part = factors_[i * n + k] / factors_[k * n + k];
        for (std::size_t j = k; j < n; ++j) factors_[i * n + j] -= part * factors_[k * n + j];
        next_[i] -= part * next_[k];
      }
    for (std::size_t k = n; k-- > 0;) {
      for (std::size_t j = k + 1; j < n; ++j) next_[k] -= factors_[k * n + j] * next_[j];
      next_[k] /= factors_[k * n + k];
    }
  }

  std::vector<Row> rows_;
  State extra_, base_, unit_, matrix_, factors_;
  State taken_, next_, slope_, u_, du_;  // torques twice; their derivatives; changes of velocity
};

// Fixed-step integrators of q' = G(q) v, v' = a(q, v). All but RK4 and the explicit Euler method
// move quaternions by the exponential map, so that these keep their length.
enum class Integrator { kEuler, kSemiImplicit, kImplicit, kRk4, kRkmk4 };

struct IntegratorInfo {
  const char* name;
  Integrator kind;
};

constexpr std::array<IntegratorInfo, 5> kIntegrators{{
    {"euler", Integrator::kEuler},
    {"semi-implicit", Integrator::kSemiImplicit},
    {"implicit", Integrator::kImplicit},
    {"rk4", Integrator::kRk4},
    {"rkmk4", Integrator::kRkmk4},
}};

class Stepper {
 public:
  using State = manifold::State;

  Stepper() {
    for (State* x : {&middle_q_, &q_rate_, &q_sum_}) x->resize(static_cast<std::size_t>(about.nq));
    for (State* x : {&middle_v_, &a_, &v_sum_, &x_, &x_rate_, &x_sum_, &none_})
      x->resize(static_cast<std::size_t>(about.nv));
  }

  // One step of length h from (q, v) to (q, v). accelerate(q, v, extra, a) evaluates with extra
  // torques and returns a status; where that is a failure, the state stays as it was.
  template <class Accelerate>
  int step(Integrator kind, double h, State& q, State& v, Accelerate accelerate) {
    switch (kind) {
      case Integrator::kRk4:
        return runge_kutta(h, q, v, accelerate);
      case Integrator::kRkmk4:
        return munthe_kaas(h, q, v, accelerate);
      case Integrator::kImplicit:
        return implicit(h, q, v, accelerate);
      default:
        return euler(kind == Integrator::kSemiImplicit, h, q, v, accelerate);
    }
  }

 private:
  static constexpr std::array<double, 4> kNode{0, 0.5, 0.5, 1}, kWeight{1, 2, 2, 1};

  // y + h dy
  ADAGEN_HOT static void move(const State& y, double h, const State& dy, State& result) {
    for (std::size_t k = 0; k < y.size(); ++k) result[k] = y[k] + h * dy[k];
  }

  template <class Accelerate>
  int euler(bool semi_implicit, double h, State& q, State& v, Accelerate accelerate) {
    if (const int failed = accelerate(q, v, none_, a_)) return failed;
    manifold::rate(q, v, q_rate_);
    move(v, h, a_, v);
    if (semi_implicit)
      follow(h, q, v);
    else
      move(q, h, q_rate_, q);
    manifold::normalise(q);
    return kFine;
  }

  // The semi-implicit method with damping and springs as they are at the end of the step.
  template <class Accelerate>
  int implicit(double h, State& q, State& v, Accelerate accelerate) {
    if (const int failed = passive_.accelerate(h, q, v, a_, accelerate)) return failed;
    move(v, h, a_, v);
    follow(h, q, v);
    manifold::normalise(q);
    return kFine;
  }

  // Moves q along v by the exponential map.
  void follow(double h, State& q, const State& v) {
    std::fill(x_.begin(), x_.end(), 0.0);
    manifold::local_rate(q, x_, v, x_rate_);
    move(x_, h, x_rate_, x_);
    manifold::advance(q, x_, middle_q_);
    q.swap(middle_q_);
  }

  // The classical method on q as numbers; quaternions are normalised after the step.
  template <class Accelerate>
  int runge_kutta(double h, State& q, State& v, Accelerate accelerate) {
    middle_q_ = q;
    middle_v_ = v;
    std::fill(q_sum_.begin(), q_sum_.end(), 0.0);
    std::fill(v_sum_.begin(), v_sum_.end(), 0.0);
    for (std::size_t k = 0; k < kNode.size(); ++k) {
      if (k > 0) {
        move(q, kNode[k] * h, q_rate_, middle_q_);
        move(v, kNode[k] * h, a_, middle_v_);
      }
      if (const int failed = accelerate(middle_q_, middle_v_, none_, a_)) return failed;
      manifold::rate(middle_q_, middle_v_, q_rate_);
      move(q_sum_, kWeight[k] / 6, q_rate_, q_sum_);
      move(v_sum_, kWeight[k] / 6, a_, v_sum_);
    }
    move(q, h, q_sum_, q);
    move(v, h, v_sum_, v);
    manifold::normalise(q);
    return kFine;
  }

  // Runge-Kutta-Munthe-Kaas: the same method on local coordinates about the step's start.
  template <class Accelerate>
  int munthe_kaas(double h, State& q, State& v, Accelerate accelerate) {
    middle_q_ = q;
    middle_v_ = v;
    for (State* x : {&x_, &x_sum_, &v_sum_}) std::fill(x->begin(), x->end(), 0.0);
    for (std::size_t k = 0; k < kNode.size(); ++k) {
      if (k > 0) {
        for (std::size_t i = 0; i < x_.size(); ++i) x_[i] = kNode[k] * h * x_rate_[i];
        manifold::advance(q, x_, middle_q_);
        move(v, kNode[k] * h, a_, middle_v_);
      }
      if (const int failed = accelerate(middle_q_, middle_v_, none_, a_)) return failed;
      manifold::local_rate(middle_q_, x_, middle_v_, x_rate_);
      move(x_sum_, h * kWeight[k] / 6, x_rate_, x_sum_);
      move(v_sum_, h * kWeight[k] / 6, a_, v_sum_);
    }
    manifold::advance(q, x_sum_, middle_q_);
    q.swap(middle_q_);
    move(v, 1, v_sum_, v);
    manifold::normalise(q);
    return kFine;
  }

  State middle_q_, middle_v_, q_rate_, a_, q_sum_, v_sum_, x_, x_rate_, x_sum_;
  State none_;  // no extra torques
  PassiveTerms passive_;
};

// Where --trajectory goes: times, configurations and velocities as CSV, a line each, or as .npz
// (numpy: time (T), q (T, nq), v (T, nv), and the joints' names).
class Trajectory {
 public:
  static constexpr double kMostBytes = 4e9;  // a member of a zip file without 64-bit extensions

  static bool is_npz(const std::string& path) { return ends_with(path, ".npz"); }
  static bool is_known(const std::string& path) { return is_npz(path) || ends_with(path, ".csv"); }

  // False where the file cannot be written.
  bool open(const std::string& path) {
    path_ = path;
    if (path.empty()) return true;
    file_.reset(std::fopen(path.c_str(), "wb"));
    if (file_ == nullptr) return false;
    if (!is_npz(path)) write_names();
    return true;
  }

  void record(double time, const std::vector<double>& q, const std::vector<double>& v) {
    if (file_ == nullptr) return;
    if (is_npz(path_)) {
      times_.push_back(time);
      q_.insert(q_.end(), q.begin(), q.end());
      v_.insert(v_.end(), v.begin(), v.end());
      return;
    }
    std::fprintf(file_.get(), "%.17g", time);
    for (const std::vector<double>* values : {&q, &v})
      for (const double x : *values) std::fprintf(file_.get(), ",%.17g", x);
    std::fputc('\n', file_.get());
  }

  // False where writing has failed.
  bool close() {
    if (file_ == nullptr) return true;
    if (is_npz(path_)) write_archive();
    const bool good = std::ferror(file_.get()) == 0;
    return std::fclose(file_.release()) == 0 && good;
  }

 private:
  struct Close {
    void operator()(std::FILE* file) const { std::fclose(file); }
  };
  struct Member {
    std::string name;
    std::uint32_t check, size, offset;
  };

  static bool ends_with(const std::string& text, const std::string& end) {
    return text.size() >= end.size() &&
           text.compare(text.size() - end.size(), end.size(), end) == 0;
  }

  // "time", then a name for each number: JOINT.q, or JOINT.q0 and so on where there are several.
  void write_names() {
    std::fputs("time", file_.get());
    for (const char field : {'q', 'v'})
      for (const Joint& joint : about.joints) {
        std::string name;
        for (const char* c = joint.name; *c != '\0'; ++c)
          name += *c == '"' ? "\"\"" : std::string(1, *c);
        const int count = field == 'q' ? joint.nq : joint.nv;
        for (int k = 0; k < count; ++k)
          std::fprintf(file_.get(), ",\"%s.%c%s\"", name.c_str(), field,
                       count > 1 ? std::to_string(k).c_str() : "");
      }
    std::fputc('\n', file_.get());
  }

  void write_archive() {
    std::vector<Member> members;
    const auto rows = std::to_string(times_.size());
    const auto add = [&](const char* name, const std::string& type, const std::string& shape,
                         const void* data, std::size_t bytes) {
      members.push_back(write_member(name, npy_head(type, shape), data, bytes));
    };
    add("time.npy", "<f8", "(" + rows + ",)", times_.data(), 8 * times_.size());
    add("q.npy", "<f8", "(" + rows + ", " + std::to_string(about.nq) + ")", q_.data(),
        8 * q_.size());
    add("v.npy", "<f8", "(" + rows + ", " + std::to_string(about.nv) + ")", v_.data(),
        8 * v_.size());
    std::size_t longest = 1;
    for (const Joint& joint : about.joints) longest = std::max(longest, std::strlen(joint.name));
    std::string names;  // UTF-8, padded with zeros
    for (const Joint& joint : about.joints) {
      names += joint.name;
      names.resize((names.size() / longest + (names.size() % longest > 0)) * longest);
    }
    add("joints.npy", "|S" + std::to_string(longest),
        "(" + std::to_string(about.joints.count) + ",)", names.data(), names.size());
    write_directory(members);
  }

  static std::string npy_head(const std::string& type, const std::string& shape) {
    std::string text =
        "{'descr': '" + type + "', 'fortran_order': False, 'shape': " + shape + ", }";
    text.resize((10 + text.size() + 1 + 63) / 64 * 64 - 11, ' ');
    text += '\n';
    return std::string("\x93NUMPY\x01\x00", 8) + low_bytes(text.size(), 2) + text;
  }

  static std::string low_bytes(std::uint64_t value, int count) {
    std::string result;
    for (int k = 0; k < count; ++k) result += static_cast<char>(value >> 8 * k & 0xFF);
    return result;
  }

  static std::uint32_t crc32(std::uint32_t before, const void* data, std::size_t bytes) {
    static const std::vector<std::uint32_t> table = [] {
      std::vector<std::uint32_t> rows(256);
      for (std::uint32_t k = 0; k < 256; ++k) {
        std::uint32_t x = k;
        for (int bit = 0; bit < 8; ++bit) x = x >> 1 ^ (x & 1 ? 0xEDB88320u : 0u);
        rows[k] = x;
      }
      return rows;
    }();
    std::uint32_t x = ~before;
    const auto* const at = static_cast<const unsigned char*>(data);
    for (std::size_t k = 0; k < bytes; ++k) x = table[(x ^ at[k]) & 0xFF] ^ x >> 8;
    return ~x;
  }

  // Method 0 (stored), 1 January 1980.
  static std::string zip_fields(const Member& member) {
    return low_bytes(20, 2) + low_bytes(0, 4) + low_bytes(0, 2) + low_bytes(0x21, 2) +
           low_bytes(member.check, 4) + low_bytes(member.size, 4) + low_bytes(member.size, 4) +
           low_bytes(member.name.size(), 2) + low_bytes(0, 2);
  }

  Member write_member(const char* name, const std::string& head, const void* data,
                      std::size_t bytes) {
    const Member member{name, crc32(crc32(0, head.data(), head.size()), data, bytes),
                        static_cast<std::uint32_t>(head.size() + bytes), written_};
    put(std::string("PK\x03\x04", 4) + zip_fields(member) + member.name + head);
    if (bytes > 0) std::fwrite(data, 1, bytes, file_.get());
    written_ += static_cast<std::uint32_t>(bytes);
    return member;
  }

  void write_directory(const std::vector<Member>& members) {
    const std::uint32_t start = written_;
    for (const Member& member : members)
      put(std::string("PK\x01\x02", 4) + low_bytes(20, 2) + zip_fields(member) + low_bytes(0, 10) +
          low_bytes(member.offset, 4) + member.name);
    const std::uint32_t size = written_ - start;
    put(std::string("PK\x05\x06", 4) + low_bytes(0, 4) + low_bytes(members.size(), 2) +
        low_bytes(members.size(), 2) + low_bytes(size, 4) + low_bytes(start, 4) + low_bytes(0, 2));
  }

  void put(const std::string& bytes) {
    std::fwrite(bytes.data(), 1, bytes.size(), file_.get());
    written_ += static_cast<std::uint32_t>(bytes.size());
  }

  std::string path_;
  std::unique_ptr<std::FILE, Close> file_;
  std::vector<double> times_, q_, v_;
  std::uint32_t written_ = 0;
};

struct SimulationOptions {
  double seconds = 0, step = 1e-3;  // no simulation where seconds are 0
  const IntegratorInfo* integrator = &kIntegrators[3];
  long long every = 1;  // steps between the rows of the trajectory
  std::string trajectory;
};

// What the program is asked to do.
struct Options {
  std::string states, result, trace;
  bool check = false, time = false, stretches = false, json = false, help = false, pin = true;
  int repeat = 200;
  std::uint64_t seed = 1;
  double time_limit = 30, tolerance = about.tolerance;
  std::string channel = about.channel;
  int hosts = 0;  // as many as there are
  SimulationOptions simulation;
};

enum ExitStatus : int { kDone = 0, kInputAtFault = 1, kUsage = 2, kFault = 3 };

const char* const kUsageText =
    "  --states FILE     solve these states (JSON, joints by name); --result FILE takes the "
    "answer\n"
    "  --result FILE     where the accelerations go (JSON); standard output if it is not given\n"
    "  --check           judge the answers to the given or random states: backward error by an\n"
    "                    independent inverse dynamics, and how many digits are sure\n"
    "  --simulate S      integrate for S seconds from the one given state (or a random one), under "
    "its\n"
    "                    torques\n"
    "  --step H          length of a step in seconds (0.001)\n"
    "  --integrator NAME euler, semi-implicit, implicit, rk4 or rkmk4 (rk4)\n"
    "  --trajectory FILE where the motion goes: FILE.csv or FILE.npz\n"
    "  --every N         keep every Nth step of it (1), and the last\n"
    "  --trace FILE      when each process did what, as JSON (medians over random states)\n"
    "  --time            time an evaluation: median, minimum, 99th percentile over random states\n"
    "                    (where there are more processes than cores, as --stretches)\n"
    "  --stretches       time what each process computes between messages, one process at a time,\n"
    "                    and play it through with what messages cost; stands in for --time\n"
    "  --repeat N        evaluations of each random state when timing (200)\n"
    "  --seed N          seed of the random states (1)\n"
    "  --tolerance X     largest backward error that --check lets pass\n"
    "  --channel KIND    auto, window (processes share memory) or message (MPI messages)\n"
    "  --hosts N         take the processes to be on N hosts, in equal parts: only those of one "
    "share memory\n"
    "  --timeout S       how long a process waits for another before it gives up, in seconds (30)\n"
    "  --no-pin          leave the processes to the system's scheduler when timing\n"
    "  --json            report as JSON on standard output\n"
    "  --help            this text\n"
    "Without --states, --check, --time, --trace or --simulate it checks and times. Exit status: 0 "
    "done, 1 "
    "input at "
    "fault\n"
    "(or a check that failed), 2 usage, 3 a process died or did not answer.\n";

constexpr std::array<const char*, 5> kSimulationWords{"--simulate", "--step", "--integrator",
                                                      "--trajectory", "--every"};

// Takes one option of a simulation; number is not a number where the value is none of 0 or more.
// Returns an empty string, or what is wrong.
std::string parse_simulation(const std::string& word, const std::string& value, double number,
                             SimulationOptions& options) {
  if (word == "--integrator") {
    std::string names;
    for (const IntegratorInfo& info : kIntegrators) {
      if (value == info.name) return options.integrator = &info, "";
      names += (names.empty() ? "" : ", ") + std::string(info.name);
    }
    return "--integrator takes one of " + names;
  }
  if (word == "--trajectory") {
    options.trajectory = value;
    return Trajectory::is_known(value) ? "" : "--trajectory takes FILE.csv or FILE.npz";
  }
  if (word == "--every") {
    options.every = number <= 1e12 ? static_cast<long long>(number) : 0;
    const bool whole = options.every >= 1 && number == std::floor(number);
    return whole ? "" : "--every takes a whole number from 1 to 1e12";
  }
  if (!(number > 0)) return word + " takes a number of seconds above 0";
  (word == "--step" ? options.step : options.seconds) = number;
  return "";
}

// Returns what is wrong with what was asked for together, and settles what was left open.
std::string settle(bool simulation_words, Options& options) {
  if (about.batch &&
      (options.simulation.seconds > 0 || !options.trace.empty() || options.stretches))
    return "a batch solver has neither --simulate nor --trace nor --stretches";
  if (about.threads > 1 && (!options.trace.empty() || options.stretches))
    return "a solver of threads has neither --trace nor --stretches: emit it for channel window";
  const bool others = options.check || options.time || !options.trace.empty();
  if (options.simulation.seconds > 0) {
    if (others || !options.result.empty())
      return "--simulate goes alone: without --check, --time, --trace and --result";
    return "";
  }
  if (simulation_words) return "--step, --integrator, --trajectory and --every need --simulate";
  if (!options.result.empty() && options.states.empty()) return "--result needs --states";
  if (options.json && options.result.empty() && !options.states.empty())
    return "--json needs --result FILE where there are --states: both would go to standard output";
  if (options.states.empty() && !others) options.check = options.time = true;
  return "";
}

// Returns an empty string, or what is wrong.
std::string parse(int count, char** words, Options& options) {
  bool simulation_words = false;
  for (int k = 1; k < count; ++k) {
    const std::string word = words[k];
    const auto flag = [&word](const char* name) { return word == name; };
    if (flag("--check"))
      options.check = true;
    else if (flag("--time"))
      options.time = true;
    else if (flag("--stretches"))
      options.time = options.stretches = true;
    else if (flag("--json"))
      options.json = true;
    else if (flag("--help"))
      options.help = true;
    else if (flag("--no-pin"))
      options.pin = false;
    else {
      const char* const known[] = {"--states",    "--result",  "--trace", "--repeat", "--seed",
                                   "--tolerance", "--channel", "--hosts", "--timeout"};
      const bool of_simulation =
          std::any_of(kSimulationWords.begin(), kSimulationWords.end(), flag);
      if (!of_simulation && std::none_of(std::begin(known), std::end(known), flag))
        return "unknown option " + word;
      if (k + 1 == count) return word + " needs a value";
      const std::string value = words[++k];
      char* end = nullptr;
      const double number = std::strtod(value.c_str(), &end);
      const bool numeric = !value.empty() && *end == '\0' && std::isfinite(number) && number >= 0;
      if (of_simulation) {
        simulation_words = true;
        const std::string wrong =
            parse_simulation(word, value, numeric ? number : std::nan(""), options.simulation);
        if (!wrong.empty()) return wrong;
      } else if (flag("--states"))
        options.states = value;
      else if (flag("--result"))
        options.result = value;
      else if (flag("--trace"))
        options.trace = value;
      else if (flag("--channel")) {
        options.channel = value;
        if (value != "auto" && value != "window" && value != "message")
          return "--channel takes auto, window or message";
      } else if (!numeric)
        return word + " takes a number of 0 or more, not \"" + value + "\"";
      else if (flag("--repeat")) {
        if (number < 1 || number > 1e6 || number != std::floor(number))
          return "--repeat takes a whole number from 1 to 1000000";
        options.repeat = static_cast<int>(number);
      } else if (flag("--seed")) {
        if (number > 0x1p53 || number != std::floor(number))
          return "--seed takes a whole number of 0 or more";
        options.seed = static_cast<std::uint64_t>(number);
      } else if (flag("--hosts")) {
        if (number < 1 || number > about.processes || number != std::floor(number))
          return "--hosts takes a whole number from 1 to " + std::to_string(about.processes) +
                 ", that of processes";
        options.hosts = static_cast<int>(number);
      } else if (flag("--tolerance"))
        options.tolerance = number;
      else if (number <= 0 || number > 1e6)
        return "--timeout takes a number of seconds above 0, at most 1000000";
      else
        options.time_limit = number;
    }
  }
  return settle(simulation_words, options);
}

// Bounds the waits that the channel does not: MPI's own collective calls wait for ever for a
// process that was stopped. Whoever sees no progress for the time limit, and a second for the
// channel to say it better, ends, and mpiexec ends the others.
class Watch {
 public:
  void start(int rank, double time_limit) {
    std::snprintf(text(), kLength,
                  "error: process %d: another process did not answer within the time limit\n",
                  rank);
    seconds_ = time_limit + 1;
#if defined(__unix__) || defined(__APPLE__)
    struct sigaction action = {};
    action.sa_handler = give_up;
    sigaction(SIGALRM, &action, nullptr);
#endif
    again();
  }

  // There was progress: the time starts anew.
  void again() const {
#if defined(__unix__) || defined(__APPLE__)
    itimerval timer = {};
    timer.it_value.tv_sec = static_cast<decltype(timer.it_value.tv_sec)>(seconds_);
    timer.it_value.tv_usec =
        static_cast<decltype(timer.it_value.tv_usec)>(1e6 * (seconds_ - std::floor(seconds_)));
    setitimer(ITIMER_REAL, &timer, nullptr);
#endif
  }

 private:
  static constexpr std::size_t kLength = 100;

  static char* text() {
    static char place[kLength];
    return place;
  }

#if defined(__unix__) || defined(__APPLE__)
  // Only what a signal handler may call.
  static void give_up(int) {
    [[maybe_unused]] const auto written = write(STDERR_FILENO, text(), std::strlen(text()));
    _exit(kFault);
  }
#endif

  double seconds_ = 0;
};

struct Statistics {
  double median = 0, least = 0, percentile99 = 0;
};

Statistics statistics(std::vector<double> ns) {
  std::sort(ns.begin(), ns.end());
  const auto at = [&ns](double part) {
    return ns[std::min(ns.size() - 1,
                       static_cast<std::size_t>(part * static_cast<double>(ns.size())))];
  };
  return {at(0.5), ns.front(), at(0.99)};
}

double nanoseconds(std::chrono::steady_clock::rep ticks) {
  using Duration = std::chrono::steady_clock::duration;
  return std::chrono::duration<double, std::nano>(Duration(ticks)).count();
}

// What one look at the clock takes; each time between two looks holds one.
double clock_cost() {
  using Clock = std::chrono::steady_clock;
  double best = 1e9;
  for (int k = 0; k < 64; ++k) {
    const Clock::time_point start = Clock::now();
    for (int i = 0; i < 64; ++i) (void)Clock::now();
    best = std::min(best, nanoseconds((Clock::now() - start).count()) / 65);
  }
  return best;
}

// What --trace FILE writes: when each stage of each process began and ended, as the medians over
// many evaluations of random states; ns from the instant at which the processes start together.
class Trace {
 public:
  using Clock = std::chrono::steady_clock;
  static constexpr std::size_t kMost = 12800;  // evaluations that are kept

  explicit Trace(int rank)
      : rank_(rank),
        stages_(about.stages[rank].count),
        stamps_(static_cast<std::size_t>(stages_) + 1) {}

  Clock::rep* stamps() { return stamps_.data(); }

  // Collective. An evaluation counts from when the first process began.
  void end(MPI_Comm comm, bool keep) {
    long long first = stages_ == 0 ? std::numeric_limits<long long>::max() : stamps_[0];
    MPI_Allreduce(MPI_IN_PLACE, &first, 1, MPI_LONG_LONG, MPI_MIN, comm);
    if (!keep || starts_.size() == kMost * (stamps_.size() - 1)) return;
    for (std::size_t k = 0; k + 1 < stamps_.size(); ++k) {
      starts_.push_back(nanoseconds(stamps_[k] - first));
      lengths_.push_back(nanoseconds(stamps_[k + 1] - stamps_[k]));
    }
    lasts_.push_back(nanoseconds(stamps_.back() - first));
  }

  // Collective; process 0 returns the text.
  std::string text(MPI_Comm comm, const char* channel, bool pinned) const {
    std::vector<double> own;
    for (int k = 0; k < stages_; ++k) {
      own.push_back(median(starts_, k));
      own.push_back(median(lengths_, k));
    }
    if (rank_ != 0) {
      MPI_Send(own.data(), static_cast<int>(own.size()), MPI_DOUBLE, 0, kTag, comm);
      return "";
    }
    std::string text = "{\"model\": " + quoted(about.robot) +
                       ", \"processes\": " + std::to_string(about.processes) + ", \"channel\": \"" +
                       channel + "\", \"pinned\": " + (pinned ? "true" : "false") +
                       ", \"evaluations\": " + std::to_string(lasts_.size()) +
                       ", \"clock_ns\": " + number(clock_cost()) + ",\n \"stages\": [";
    for (int p = 0; p < about.processes; ++p) {
      const std::size_t count = 2 * static_cast<std::size_t>(about.stages[p].count);
      std::vector<double> times(count);
      if (p == 0)
        times = own;
      else
        MPI_Recv(times.data(), static_cast<int>(count), MPI_DOUBLE, p, kTag, comm,
                 MPI_STATUS_IGNORE);
      for (std::size_t k = 0; 2 * k < count; ++k)
        text += row(p, about.stages[p][static_cast<int>(k)], times[2 * k], times[2 * k + 1]) + ",";
    }
    if (text.back() == ',') text.pop_back();
    return text + "\n ]}\n";
  }

 private:
  static constexpr int kTag = 0x7ace;

  static std::string number(double x) {
    char text[32];
    std::snprintf(text, sizeof text, "%.1f", x);
    return text;
  }

  static std::string row(int process, const Stage& stage, double start, double length) {
    const std::string joint = stage.joint < 0 ? "null" : quoted(about.joints[stage.joint].name);
    const std::string message = stage.message < 0 ? "null" : std::to_string(stage.message);
    return "\n  {\"process\": " + std::to_string(process) + ", \"what\": \"" + stage.what +
           "\", \"joint\": " + joint + ", \"message\": " + message +
           ", \"start_ns\": " + number(start) + ", \"length_ns\": " + number(length) + "}";
  }

  double median(const std::vector<double>& all, int stage) const {
    std::vector<double> one;
    const std::size_t step = stamps_.size() - 1;
    for (std::size_t k = static_cast<std::size_t>(stage); k < all.size(); k += step)
      one.push_back(all[k]);
    if (one.empty()) return 0;
    std::nth_element(one.begin(), one.begin() + static_cast<long>(one.size() / 2), one.end());
    return one[one.size() / 2];
  }

  int rank_, stages_;
  std::vector<Clock::rep> stamps_;
  std::vector<double> starts_, lengths_, lasts_;
};

// What the parts of the program share: the solver, the states at work, and how a failure is told.

// Closes the loops of random states, each from its own configuration, then from others: until the
// solver takes one, if any. Near singular poses it does not.
template <class Uniform, class Taken>
void close(States& states, Uniform uniform, Taken taken) {
  constexpr int kTries = 60;
  const std::size_t nq = static_cast<std::size_t>(about.nq),
                    nv = static_cast<std::size_t>(about.nv);
  std::vector<double> rest(nq);
  for (const Joint& joint : about.joints)
    if (joint.nq >= 4) rest[static_cast<std::size_t>(joint.q + joint.nq - 1)] = 1;
  for (int s = 0; s < states.count; ++s) {
    const std::size_t row = static_cast<std::size_t>(s);
    Number *const q = states.q.data() + row * nq, *const v = states.v.data() + row * nv;
    const std::vector<double> drawn(q, q + nq), rates(v, v + nv);
    for (int tries = 0; tries < kTries; ++tries) {
      std::vector<double> rate(rates), step(nv), start(nq);
      for (double& x : step) x = tries == 0 ? 0 : 3 * uniform() / (1 << 2 * (tries % 3));
      manifold::move(tries % 2 == 0 ? drawn : rest, step, start);
      if (!loops::settle(start, rate)) continue;
      std::copy(start.begin(), start.end(), q), std::copy(rate.begin(), rate.end(), v);
      if (taken(s)) break;
    }
  }
}

// Random states, the same on every machine (splitmix64).
States random_states(int count, std::uint64_t seed, Solver& solver) {
  const auto uniform = [&seed] {
    std::uint64_t z = (seed += 0x9E3779B97F4A7C15ULL);
    z = (z ^ (z >> 30)) * 0xBF58476D1CE4E5B9ULL;
    z = (z ^ (z >> 27)) * 0x94D049BB133111EBULL;
    return static_cast<double>((z ^ (z >> 31)) >> 11) * 0x1p-52 - 1;  // in [-1, 1)
  };
  States states;
  states.count = count;
  const auto size = [count](int n) {
    return static_cast<std::size_t>(count) * static_cast<std::size_t>(n);
  };
  states.q.resize(size(about.nq));
  states.v.resize(size(about.nv));
  states.tau.resize(size(about.ntau));
  for (int s = 0; s < count; ++s) {
    const long row = s;
    Number* const q = states.q.data() + row * about.nq;
    Number* const v = states.v.data() + row * about.nv;
    Number* const tau = states.tau.data() + row * about.ntau;
    for (const Joint& joint : about.joints) {
      const bool turns = joint.kind == JointKind::kRevolute;
      for (int k = 0; k < joint.nq; ++k)
        q[joint.q + k] = static_cast<Number>(turns ? 3.141592653589793 * uniform() : uniform());
      if (joint.nq >= 4) {
        double p[4], squared;
        do {
          squared = 0;
          for (double& x : p) x = uniform(), squared += x * x;
        } while (squared > 1 || squared < 0.01);
        for (int k = 0; k < 4; ++k)
          q[joint.q + joint.nq - 4 + k] = static_cast<Number>(p[k] / std::sqrt(squared));
      }
      for (int k = 0; k < joint.nv; ++k) {
        v[joint.v + k] = static_cast<Number>(uniform());
        tau[joint.v + k] = static_cast<Number>(uniform());
      }
    }
    for (int k = about.nv; k < about.ntau; ++k) tau[k] = static_cast<Number>(uniform());
    slave(about.joints, q, v);
  }
  if (loops::any()) {
    std::vector<Number> qdd(static_cast<std::size_t>(std::max(1, about.nqdd)));
    close(states, uniform, [&](int s) {
      const long row = s;
      return solver.solve(states.q.data() + row * about.nq, states.v.data() + row * about.nv,
                          states.tau.data() + row * about.ntau, qdd.data()) == kFine;
    });
  }
  return states;
}

// The states file, read by process 0 and handed to all.
int load(const std::string& path, MPI_Comm comm, int rank, States& states) {
  int status = kDone;
  if (rank == 0) {
    std::ifstream file(path, std::ios::binary);
    file.peek();  // tells a folder from a file
    std::ostringstream text;
    if (!file.bad()) text << file.rdbuf();
    std::string wrong;
    if (!file.is_open() || file.bad())
      wrong = " error: cannot read the states file";
    else
      wrong = StatesReader(text.str()).read(states);
    if (!wrong.empty()) {
      std::fprintf(stderr, "%s:%s\n", path.c_str(), wrong.c_str());
      status = kInputAtFault;
    }
  }
  MPI_Bcast(&status, 1, MPI_INT, 0, comm);
  if (status != kDone) return status;
  MPI_Bcast(&states.count, 1, MPI_INT, 0, comm);
  int gravity = static_cast<int>(states.gravity.size());
  MPI_Bcast(&gravity, 1, MPI_INT, 0, comm);
  states.gravity.resize(static_cast<std::size_t>(gravity));
  MPI_Bcast(states.gravity.data(), gravity, MPI_DOUBLE, 0, comm);
  const auto share = [&](std::vector<Number>& x, int n) {
    x.resize(static_cast<std::size_t>(states.count) * static_cast<std::size_t>(n));
    MPI_Bcast(x.data(), static_cast<int>(x.size()), kMpiNumber, 0, comm);
  };
  if (about.batch) return status;  // handed out as they are solved
  share(states.q, about.nq);
  share(states.v, about.nv);
  share(states.tau, about.ntau);
  return status;
}

struct Session {
  Options options;
  int rank;
  Watch watch;
  Solver& solver;
  States states;
  std::vector<Number> qdd;  // of each state accelerations, and forces of loops where asked for
  bool pinned = false;

  Session(Options given, Solver& own, int own_rank)
      : options(std::move(given)), rank(own_rank), solver(own) {}

  MPI_Comm comm() const { return solver.comm(); }
  const Number* q(int s) const { return states.q.data() + static_cast<long>(s) * about.nq; }
  const Number* v(int s) const { return states.v.data() + static_cast<long>(s) * about.nv; }
  const Number* tau(int s) const { return states.tau.data() + static_cast<long>(s) * about.ntau; }
  Number* acceleration(int s) { return qdd.data() + static_cast<long>(s) * about.nqdd; }

  // The states file; where it says another gravity, and that can be set, it holds from now on.
  int load_states() {
    const int status = load(options.states, comm(), rank, states);
    if (status != kDone || states.gravity.empty()) return status;
    gravity_ = states.gravity;
    about.gravity = gravity_.data();
    solver.set_gravity(about.gravity);
    return status;
  }

  void use(States given) {
    states = std::move(given);
    qdd.assign(static_cast<std::size_t>(states.count) * static_cast<std::size_t>(about.nqdd),
               Number(0));
  }

  // Hands the states of process 0 to all.
  void share_states() {
    for (auto* const x : {&states.q, &states.v, &states.tau})
      MPI_Bcast(x->data(), static_cast<int>(x->size()), kMpiNumber, 0, comm());
  }

  int complain(int status, const std::string& what, const std::string& file = "") const {
    const std::string place = file.empty() ? "" : file + ": ";
    if (rank == 0) std::fprintf(stderr, "%serror: %s\n", place.c_str(), what.c_str());
    return status;
  }

  // A process that waited in vain cannot be waited for: the whole run ends.
  void give_up_if_broken(int failed) const {
    if (failure_kind(failed) != kNoAnswer) return;
    std::fprintf(stderr, "error: process %d: %s\n", rank, solver.in_words(failed));
    std::fflush(stderr);
    MPI_Abort(MPI_COMM_WORLD, kFault);
  }

 private:
  std::vector<double> gravity_;
};

// The cores that the processes on this node may use: whether there is one for each of them.
class Cores {
 public:
  // Collective.
  explicit Cores(MPI_Comm comm) : comm_(comm) {
    MPI_Comm node;
    int processes = 1;
    MPI_Comm_split_type(comm, MPI_COMM_TYPE_SHARED, 0, MPI_INFO_NULL, &node);
    MPI_Comm_rank(node, &place_);
    MPI_Comm_size(node, &processes);
#if defined(__linux__)
    CPU_ZERO(&own_);
    cpu_set_t all;
    known_ = sched_getaffinity(0, sizeof own_, &own_) == 0;
    // Each may be bound to one of its own.
    MPI_Allreduce(&own_, &all, static_cast<int>(sizeof all), MPI_BYTE, MPI_BOR, node);
    count_ = CPU_COUNT(&all);
    own_is_enough_ = known_ && CPU_COUNT(&own_) >= processes;
#endif
    if (count_ == 0) count_ = static_cast<int>(std::thread::hardware_concurrency());
    int enough = count_ == 0 || count_ >= processes;
    MPI_Allreduce(MPI_IN_PLACE, &enough, 1, MPI_INT, MPI_MIN, comm);
    enough_ = enough != 0;
    MPI_Comm_free(&node);
  }

  // Whether every process, on any node, can have one to itself.
  bool enough() const { return enough_; }

  int count() const { return count_; }

  // Collective. Each process onto one of its own, if there are as many; whether all are.
  bool pin() const {
    int pinned = own_is_enough_ && pin_to(place_);
    MPI_Allreduce(MPI_IN_PLACE, &pinned, 1, MPI_INT, MPI_MIN, comm_);
    return pinned != 0;
  }

  // This process onto one that others may have, too.
  void pin_in_turn() const { pin_to(place_); }

 private:
  // Onto the k-th of those that this process may use, counted round and round.
  bool pin_to([[maybe_unused]] int k) const {
#if defined(__linux__)
    if (!known_) return false;
    k %= CPU_COUNT(&own_);
    int cpu = 0;
    for (; cpu < CPU_SETSIZE; ++cpu)
      if (CPU_ISSET(cpu, &own_) && k-- == 0) break;
    cpu_set_t one;
    CPU_ZERO(&one);
    CPU_SET(cpu, &one);
    return sched_setaffinity(0, sizeof one, &one) == 0;
#else
    return false;
#endif
  }

  MPI_Comm comm_;
  int place_ = 0, count_ = 0;
  bool enough_ = true, own_is_enough_ = false;
#if defined(__linux__)
  bool known_ = false;
  cpu_set_t own_;
#endif
};

// A process's part in an evaluation: the messages that it sends and receives, in order, and how
// long it computes before each and after the last; ns.
struct Part {
  std::vector<int> messages;
  std::vector<double> stretches;  // one more than messages
};

// When the last process is done, were all to begin together on cores of their own: their parts
// played through, each message of a process waited for.
inline double makespan(const std::vector<Part>& parts, const std::vector<Message>& messages,
                       const Hop& hop) {
  std::vector<double> clock(parts.size(), 0);
  std::vector<std::size_t> at(parts.size(), 0), received(messages.size(), 0);
  std::vector<std::vector<double>> sent(messages.size());  // when, each time
  const auto advance = [&](std::size_t p) {
    const std::size_t k = static_cast<std::size_t>(parts[p].messages[at[p]]);
    const double ready = clock[p] + parts[p].stretches[at[p]];
    const double copying = hop.number * messages[k].size / 2;
    if (messages[k].source == static_cast<int>(p)) {
      clock[p] = ready + hop.send + copying;
      sent[k].push_back(clock[p]);
    } else {
      if (received[k] == sent[k].size()) return false;  // not sent yet
      clock[p] = std::max(ready, sent[k][received[k]++] + hop.latency) + copying;
    }
    ++at[p];
    return true;
  };
  for (bool moved = true; moved;) {
    moved = false;
    for (std::size_t p = 0; p < parts.size(); ++p)
      while (at[p] < parts[p].messages.size() && advance(p)) moved = true;
  }
  double last = 0;
  for (std::size_t p = 0; p < parts.size(); ++p)
    last = std::max(last, clock[p] + parts[p].stretches.back());
  return last;
}

// What messages cost on a channel.
inline const Hop& hop_of(const Solver& solver) {
  return solver.windowed() ? about.window_hop : about.message_hop;
}

// How long an evaluation would take if each process had a core of its own, where they have not: its
// processes compute one at a time, the others asleep, with the messages that they have once had
// (take.hpp); then these stretches and what messages cost are played through (makespan.hpp).
class Stretches {
 public:
  explicit Stretches(Session& session) : session_(session) {}

  // Collective. Evaluates each state of the session, at the root or in place; turn is told before
  // each turn. Returns the first failure.
  template <class Turn>
  int measure(bool at_root, Turn turn) {
    session_.solver.forget(session_.states.count);
    lengths_.assign(count(), {});
    int failed = record(at_root);
    MPI_Allreduce(MPI_IN_PLACE, &failed, 1, MPI_INT, MPI_MAX, session_.comm());
    if (failed != kFine) return failed;
    const int repeat = evaluations() / session_.states.count, rounds = std::min(kRounds, repeat);
    for (int round = 0; round < rounds; ++round)
      for (int p = 0; p < about.processes; ++p) {
        rest();
        if (p != session_.rank) continue;
        turn();
        play(at_root, repeat * (round + 1) / rounds - repeat * round / rounds);
      }
    rest();
    return kFine;
  }

  // Of each state, at most as many as are kept.
  int evaluations() const {
    return std::min(session_.options.repeat, kMost) * session_.states.count;
  }

  // Collective. Over the states, at process 0: medians of the stretches played through, and the
  // least of all. Holds one look at the clock, as other times do.
  Statistics played_through() {
    const std::vector<std::vector<double>> told = bring_together();
    if (session_.rank != 0) return {};
    const std::vector<Message> messages(about.messages.begin(), about.messages.end());
    std::vector<const double*> next;
    for (const std::vector<double>& one : told) next.push_back(one.data());
    work_.assign(processes(), 0);
    std::vector<double> typical, least;
    for (std::size_t s = 0; s < count(); ++s) {
      std::vector<Part> medians(processes()), leasts(processes());
      for (std::size_t p = 0; p < processes(); ++p) {
        next[p] = read(next[p], medians[p], leasts[p]);
        for (const double ns : medians[p].stretches) work_[p] += ns / static_cast<double>(count());
      }
      typical.push_back(makespan(medians, messages, hop()) + look_);
      least.push_back(makespan(leasts, messages, hop()) + look_);
    }
    Statistics found = statistics(std::move(typical));
    found.least = *std::min_element(least.begin(), least.end());
    return found;
  }

  // For how long each process computes in an evaluation, ns, as last played through.
  const std::vector<double>& work() const { return work_; }

 private:
  static constexpr int kTag = 0x57e7, kRounds = 5, kMost = 1000;

  std::size_t count() const { return static_cast<std::size_t>(session_.states.count); }
  static std::size_t processes() { return static_cast<std::size_t>(about.processes); }
  const Hop& hop() const { return hop_of(session_.solver); }

  int record(bool at_root) {
    int failed = kFine;
    for (int s = 0; s < session_.states.count; ++s) {
      const int found = session_.solver.record(s, at_root, session_.q(s), session_.v(s),
                                               session_.tau(s), session_.acceleration(s));
      session_.give_up_if_broken(found);
      if (failed == kFine) failed = found;
    }
    return failed;
  }

  // A turn: all states as often as asked for, after once to warm up.
  void play(bool at_root, int passes) {
    look_ = clock_cost();
    std::vector<Solver::Ticks> looks;
    for (int pass = -1; pass < passes; ++pass)
      for (int s = 0; s < session_.states.count; ++s) {
        looks.resize(static_cast<std::size_t>(session_.solver.noted(s).count) + 2);
        session_.solver.play(s, at_root, session_.q(s), session_.v(s), session_.tau(s),
                             session_.acceleration(s), looks.data());
        if (pass >= 0) keep(looks, lengths_[static_cast<std::size_t>(s)]);
      }
  }

  void keep(const std::vector<Solver::Ticks>& looks, std::vector<double>& lengths) const {
    for (std::size_t k = 1; k < looks.size(); ++k)
      lengths.push_back(std::max(0.0, nanoseconds(looks[k] - looks[k - 1]) - look_));
  }

  // Waits for the others, asleep: whoever computes is not disturbed.
  void rest() const {
    MPI_Request request;
    MPI_Ibarrier(session_.comm(), &request);
    for (int done = 0; MPI_Test(&request, &done, MPI_STATUS_IGNORE), !done;)
      std::this_thread::sleep_for(std::chrono::microseconds(200));
    session_.watch.again();
  }

  // Collective. At process 0, for each process what it found of all states, one after the other:
  // number of messages, the messages, then medians and least of their stretches.
  std::vector<std::vector<double>> bring_together() {
    std::vector<double> own;
    for (std::size_t s = 0; s < count(); ++s) {
      const Table<int> messages = session_.solver.noted(static_cast<int>(s));
      own.push_back(messages.count);
      own.insert(own.end(), messages.begin(), messages.end());
      const std::vector<Statistics> found =
          of_stretches(lengths_[s], static_cast<std::size_t>(messages.count) + 1);
      for (const Statistics& one : found) own.push_back(one.median);
      for (const Statistics& one : found) own.push_back(one.least);
    }
    std::vector<std::vector<double>> all(processes());
    if (session_.rank != 0) {
      MPI_Send(own.data(), static_cast<int>(own.size()), MPI_DOUBLE, 0, kTag, session_.comm());
      return all;
    }
    all[0] = std::move(own);
    for (int p = 1; p < about.processes; ++p) {
      MPI_Status status;
      int size = 0;
      MPI_Probe(p, kTag, session_.comm(), &status);
      MPI_Get_count(&status, MPI_DOUBLE, &size);
      all[static_cast<std::size_t>(p)].resize(static_cast<std::size_t>(size));
      MPI_Recv(all[static_cast<std::size_t>(p)].data(), size, MPI_DOUBLE, p, kTag, session_.comm(),
               MPI_STATUS_IGNORE);
    }
    return all;
  }

  static std::vector<Statistics> of_stretches(const std::vector<double>& lengths,
                                              std::size_t stretches) {
    std::vector<Statistics> found;
    for (std::size_t first = 0; first < stretches; ++first) {
      std::vector<double> one;
      for (std::size_t k = first; k < lengths.size(); k += stretches) one.push_back(lengths[k]);
      found.push_back(statistics(std::move(one)));
    }
    return found;
  }

  static const double* read(const double* from, Part& median, Part& least) {
    const std::size_t messages = static_cast<std::size_t>(*from++);
    median.messages.assign(from, from + messages);
    least.messages = median.messages;
    from += messages;
    median.stretches.assign(from, from + messages + 1);
    from += messages + 1;
    least.stretches.assign(from, from + messages + 1);
    return from + messages + 1;
  }

  Session& session_;
  std::vector<std::vector<double>> lengths_;  // of each state: one evaluation after the other
  double look_ = 0;                           // at the clock
  std::vector<double> work_;
};

// How long batches take (--time): on one process, two, four, ... and all.
class BatchTiming {
 public:
  explicit BatchTiming(Session& session) : session_(session) {}

  static constexpr int kStates = 1024;  // for each process

  // Collective. Times batches of random states. Returns the first failure.
  int measure() {
    const int count = kStates * (session_.rank == 0 ? about.processes : 1);
    session_.use(random_states(count, session_.options.seed, session_.solver));
    for (int active = 1;; active = std::min(2 * active, about.processes)) {
      const int failed = measure_on(active);
      if (failed != kFine || active == about.processes) return failed;
    }
  }

  // Nanoseconds for each state and process, on all processes.
  const Statistics& in_place() const { return steps_.back().in_place; }
  const Statistics& at_root() const { return steps_.back().at_root; }

  // Nothing where nothing was timed.
  std::string json() const {
    std::string text;
    for (const Step& step : steps_) {
      char words[120];
      std::snprintf(words, sizeof words,
                    "%s{\"processes\": %d, \"in_place\": %.4g, \"through_root\": %.4g}",
                    text.empty() ? ", \"states_per_second\": [" : ", ", step.processes,
                    step.per_second(step.in_place), step.per_second(step.at_root));
      text += words;
    }
    return text + (text.empty() ? "" : "]");
  }

  void print(std::FILE* out) const {
    if (steps_.empty()) return;
    std::fprintf(out,
                 "       states per second:  in place  per process   through 0  per process\n");
    for (const Step& step : steps_) {
      const double in_place = step.per_second(step.in_place);
      const double at_root = step.per_second(step.at_root);
      std::fprintf(out, "       %4d process%-2s   %11.3g  %11.3g %11.3g  %11.3g\n", step.processes,
                   step.processes == 1 ? "" : "es", in_place, in_place / step.processes, at_root,
                   at_root / step.processes);
    }
  }

 private:
  struct Step {
    int processes;
    Statistics in_place, at_root;
    double per_second(const Statistics& ns) const { return 1e9 * processes / ns.median; }
  };

  int measure_on(int active) {
    std::vector<double> in_place, at_root;
    int failed = kFine;
    for (int pass = -1; pass < session_.options.repeat && failed == kFine; ++pass) {
      session_.watch.again();
      const Elapsed found = session_.solver.time_batch(
          kStates, active, session_.q(0), session_.v(0), session_.tau(0), session_.acceleration(0));
      for (const int status : {found.status_in_place, found.status_at_root}) {
        session_.give_up_if_broken(status);
        if (failed == kFine) failed = status;
      }
      if (pass >= 0) {
        in_place.push_back(found.in_place / kStates);
        at_root.push_back(found.at_root / kStates);
      }
      MPI_Allreduce(MPI_IN_PLACE, &failed, 1, MPI_INT, MPI_MAX, session_.comm());
    }
    if (failed != kFine) return failed;
    for (std::vector<double>* ns : {&in_place, &at_root})  // over when the last process is done
      MPI_Allreduce(MPI_IN_PLACE, ns->data(), static_cast<int>(ns->size()), MPI_DOUBLE, MPI_MAX,
                    session_.comm());
    steps_.push_back({active, statistics(std::move(in_place)), statistics(std::move(at_root))});
    return kFine;
  }

  Session& session_;
  std::vector<Step> steps_;
};

// How long an evaluation takes (--time, --stretches), and where the time goes (--trace).
class Timing {
 public:
  explicit Timing(Session& session) : session_(session) {}

  int time_all() {
    const Cores cores(session_.comm());
    crowded_ = !cores.enough() || cores.count() < about.threads;
    cores_ = cores.count();
    if (about.batch) return time_batch(cores);
    session_.use(random_states(kRandomStates, session_.options.seed, session_.solver));
    if ((crowded_ && about.threads == 1) || session_.options.stretches)
      return time_stretches(cores);
    session_.pinned = session_.options.pin && cores.pin();
    std::vector<double> in_place, at_root;
    int failed = kFine;
    for (int pass = -1; pass < session_.options.repeat && failed == kFine;
         ++pass) {  // the first one warms up
      session_.watch.again();
      for (int s = 0; s < session_.states.count; ++s) {
        const Elapsed found = session_.solver.time(session_.q(s), session_.v(s), session_.tau(s),
                                                   session_.acceleration(s));
        const int first = found.status_in_place, second = found.status_at_root;
        session_.give_up_if_broken(first);
        session_.give_up_if_broken(second);
        if (failed == kFine) failed = first != kFine ? first : second;
        if (pass < 0) continue;
        in_place.push_back(found.in_place);
        at_root.push_back(found.at_root);
      }
      MPI_Allreduce(MPI_IN_PLACE, &failed, 1, MPI_INT, MPI_MAX, session_.comm());
    }
    if (failed != kFine)
      return session_.complain(kInputAtFault,
                               "random state: " + std::string(session_.solver.in_words(failed)));
    // An evaluation is over when its last process is done.
    MPI_Allreduce(MPI_IN_PLACE, in_place.data(), static_cast<int>(in_place.size()), MPI_DOUBLE,
                  MPI_MAX, session_.comm());
    in_place_ = statistics(std::move(in_place));
    at_root_ = statistics(std::move(at_root));
    evaluations_ = session_.options.repeat * kRandomStates;
    return kDone;
  }

  // Where processes share cores, or where it is asked for.
  int time_stretches(const Cores& cores) {
    const auto turn = [&] {
      if (session_.options.pin) cores.pin_in_turn();
    };
    Stretches stretches(session_);
    int failed = stretches.measure(true, turn);
    if (failed == kFine) at_root_ = stretches.played_through();
    if (failed == kFine) failed = stretches.measure(false, turn);
    if (failed != kFine)
      return session_.complain(kInputAtFault,
                               "random state: " + std::string(session_.solver.in_words(failed)));
    in_place_ = stretches.played_through();
    work_ = stretches.work();
    evaluations_ = stretches.evaluations();
    return kDone;
  }

  int time_batch(const Cores& cores) {
    session_.pinned = session_.options.pin && cores.pin();
    const int failed = batches_.measure();
    if (failed != kFine)
      return session_.complain(kInputAtFault,
                               "random states: " + std::string(session_.solver.in_words(failed)));
    in_place_ = batches_.in_place();
    at_root_ = batches_.at_root();
    evaluations_ = session_.options.repeat * BatchTiming::kStates;
    return kDone;
  }

  // The same evaluations with time stamps between the stages of each process.
  int trace_all() {
    session_.use(random_states(kRandomStates, session_.options.seed, session_.solver));
    if (!session_.pinned && session_.options.pin) session_.pinned = Cores(session_.comm()).pin();
    Trace trace(session_.rank);
    int failed = kFine;
    for (int pass = -1; pass < session_.options.repeat && failed == kFine; ++pass) {
      session_.watch.again();
      for (int s = 0; s < session_.states.count; ++s) {
        const int found = session_.solver.trace(session_.q(s), session_.v(s), session_.tau(s),
                                                session_.acceleration(s), trace.stamps());
        session_.give_up_if_broken(found);
        trace.end(session_.comm(), pass >= 0);
        if (failed == kFine) failed = found;
      }
      MPI_Allreduce(MPI_IN_PLACE, &failed, 1, MPI_INT, MPI_MAX, session_.comm());
    }
    if (failed != kFine)
      return session_.complain(kInputAtFault,
                               "random state: " + std::string(session_.solver.in_words(failed)));
    const std::string text =
        trace.text(session_.comm(), session_.solver.channel_name(), session_.pinned);
    int status = kDone;
    if (session_.rank == 0) {
      std::ofstream file(session_.options.trace, std::ios::binary);
      if (!(file << text << std::flush))
        status = session_.complain(kFault, "cannot write the trace", session_.options.trace);
    }
    MPI_Bcast(&status, 1, MPI_INT, 0, session_.comm());
    return status;
  }

  // Nothing where nothing was timed.
  std::string json() const {
    if (evaluations_ == 0) return "";
    std::string text = ", \"time\": {\"source\": ";
    text += work_.empty() ? "\"clock\"" : "\"stretches\"";
    text += ", \"evaluations\": " + std::to_string(evaluations_);
    text += session_.pinned ? ", \"pinned\": true" : ", \"pinned\": false";
    text += figures("in_place", in_place_) + figures("through_root", at_root_);
    std::string each;
    for (const double ns : work_) each += (each.empty() ? "" : ", ") + whole(ns);
    if (!each.empty()) text += ", \"work_ns\": [" + each + "]";
    return text + batches_.json() + "}";
  }

  void print(std::FILE* out) const {
    if (evaluations_ == 0) return;
    const bool threads = about.threads > 1;
    const int count = threads ? about.threads : about.processes;
    const char* const what = threads ? "thread" : "process";
    const char* const many = count == 1 ? "" : threads ? "s" : "es";
    std::fprintf(out, "time   %d %s%s%s, ns per %s: median, minimum, 99th percentile\n", count,
                 what, many, session_.pinned ? ", pinned" : "",
                 about.batch ? "state and process" : "evaluation");
    if (crowded_)
      std::fprintf(out, "       (%d cores for %d %s%s: a wall time %s)\n", cores_, count, what,
                   many, about.batch || threads ? "says little" : "would mean nothing");
    if (!work_.empty())
      std::fprintf(out,
                   "       (from measured stretches of computing, one process at a time, played "
                   "through\n        with what messages cost: %.0f ns each and %.2f per number)\n",
                   hop().send + hop().latency, hop().number);
    std::fprintf(out, "       state and result in place       %8.0f %8.0f %8.0f\n",
                 in_place_.median, in_place_.least, in_place_.percentile99);
    std::fprintf(out, "       everything through process 0    %8.0f %8.0f %8.0f\n", at_root_.median,
                 at_root_.least, at_root_.percentile99);
    if (!work_.empty()) {
      std::fprintf(out, "       each process computes           ");
      for (const double ns : work_) std::fprintf(out, "%8.0f ", ns);
      std::fprintf(out, "\n");
    }
    batches_.print(out);
  }

 private:
  static std::string whole(double ns) { return std::to_string(std::llround(ns)); }

  static std::string figures(const char* what, const Statistics& of) {
    return std::string(", \"") + what + "\": {\"median_ns\": " + whole(of.median) +
           ", \"min_ns\": " + whole(of.least) + ", \"p99_ns\": " + whole(of.percentile99) + "}";
  }

  const Hop& hop() const { return hop_of(session_.solver); }

  Session& session_;
  int evaluations_ = 0;
  bool crowded_ = false;  // not a core for each process
  int cores_ = 0;
  Statistics in_place_, at_root_;
  BatchTiming batches_{session_};
  std::vector<double> work_;  // of each process, where times are from stretches
};

// --simulate: process 0 integrates, all processes evaluate. The torques of the initial state act
// all the time.
class Simulation {
 public:
  explicit Simulation(Session& session) : on_(session) {}

  // Collective.
  int run() {
    int status = start();
    MPI_Bcast(&status, 1, MPI_INT, 0, on_.comm());
    if (status != kDone) return status;
    status = about.processes == 1 || on_.rank == 0 ? integrate() : serve();
    MPI_Bcast(&status, 1, MPI_INT, 0, on_.comm());
    return status;
  }

  // Nothing where nothing was simulated.
  std::string json() const {
    if (!done_) return "";
    char text[300];
    std::snprintf(text, sizeof text,
                  ", \"simulation\": {\"integrator\": \"%s\", \"step\": %.17g, \"seconds\": %.17g, "
                  "\"steps\": %lld, \"evaluations\": %lld, \"wall_s\": %.9g}",
                  asked().integrator->name, asked().step, asked().seconds, steps_, evaluations_,
                  wall_);
    return text;
  }

  void print() const {
    if (!done_) return;
    std::printf(
        "simulation  %s: %g s in %lld steps of %g s, %lld evaluations, %.3g s of wall time\n",
        asked().integrator->name, asked().seconds, steps_, asked().step, evaluations_, wall_);
  }

 private:
  using Clock = std::chrono::steady_clock;
  static constexpr const char* kSmaller = "; take a smaller --step";

  const SimulationOptions& asked() const { return on_.options.simulation; }

  // The initial state and the file to write; process 0's status counts.
  int start() {
    if (on_.options.states.empty()) {
      on_.use(random_states(1, on_.options.seed, on_.solver));
    } else {
      const int status = on_.load_states();
      if (status != kDone) return status;
      if (on_.states.count != 1)
        return on_.complain(
            kInputAtFault, std::to_string(on_.states.count) + " states; a simulation starts at one",
            on_.options.states);
    }
    const double steps = std::ceil(asked().seconds / asked().step * (1 - 1e-12));
    if (steps > 1e12) return on_.complain(kUsage, "--simulate: more than 1e12 steps");
    steps_ = std::max(1LL, static_cast<long long>(steps));
    if (on_.rank != 0) return kDone;
    const std::string& path = asked().trajectory;
    const double rows = static_cast<double>(steps_) / static_cast<double>(asked().every) + 2;
    if (Trajectory::is_npz(path) &&
        rows * 8 * std::max(about.nq, about.nv) > Trajectory::kMostBytes)
      return on_.complain(kUsage,
                          "the trajectory has too many rows for .npz; say --every N or .csv");
    if (!trajectory_.open(path)) return on_.complain(kFault, "cannot write the trajectory", path);
    return kDone;
  }

  // Evaluates for process 0 until that says that it is over.
  int serve() {
    if (!on_.solver.has_part()) return kDone;
    for (int status = kFine; failure_kind(status) != kEnded;) {
      status = on_.solver.solve_at_root(nullptr, nullptr, nullptr, nullptr);
      on_.give_up_if_broken(status);
      tick();
    }
    return kDone;
  }

  int integrate() {
    q_.assign(on_.q(0), on_.q(0) + about.nq);
    v_.assign(on_.v(0), on_.v(0) + about.nv);
    real_q_.resize(q_.size()), real_v_.resize(v_.size()),
        real_a_.resize(static_cast<std::size_t>(about.nqdd));
    real_tau_.resize(static_cast<std::size_t>(about.ntau));
    const Clock::time_point began = next_ = Clock::now();
    next_shown_ = began + std::chrono::seconds(1);
    std::string wrong = follow();
    wall_ = std::chrono::duration<double>(Clock::now() - began).count();
    if (told_) std::fputc('\n', stderr);
    on_.give_up_if_broken(on_.solver.end_at_root());
    if (!trajectory_.close())
      return on_.complain(kFault, "cannot write the trajectory", asked().trajectory);
    if (!wrong.empty()) return on_.complain(kInputAtFault, wrong, on_.options.states);
    done_ = true;
    return kDone;
  }

  // Takes all steps; returns an empty string, or what stopped it.
  std::string follow() {
    Stepper stepper;
    manifold::normalise(q_);
    trajectory_.record(0, q_, v_);
    for (long long k = 0; k < steps_; ++k) {
      const double time = static_cast<double>(k) * asked().step;
      const double next = k + 1 < steps_ ? time + asked().step : asked().seconds;
      const int failed = stepper.step(asked().integrator->kind, next - time, q_, v_,
                                      [this](const auto& q, const auto& v, const auto& extra,
                                             auto& a) { return accelerate(q, v, extra, a); });
      on_.give_up_if_broken(failed);
      if (failed != kFine) return on_.solver.in_words(failed) + at(time) + (k > 0 ? kSmaller : "");
      slave(about.joints, q_.data(), v_.data());
      if (loops::any() && !loops::settle(q_, v_))
        return "the loops cannot be closed again" + at(next) + kSmaller;
      const int joint = not_finite();
      if (joint >= 0)
        return "joint " + quoted(about.joints[joint].name) + ": its state is not finite" +
               at(next) + kSmaller;
      if ((k + 1) % asked().every == 0 || k + 1 == steps_) trajectory_.record(next, q_, v_);
      show(next);
    }
    return "";
  }

  static std::string at(double time) {
    char text[40];
    std::snprintf(text, sizeof text, ", at t = %.9g s", time);
    return text;
  }

  ADAGEN_HOT int accelerate(const manifold::State& q, const manifold::State& v,
                            const manifold::State& extra, manifold::State& a) {
    std::copy(q.begin(), q.end(), real_q_.begin());
    std::copy(v.begin(), v.end(), real_v_.begin());
    std::copy(on_.tau(0), on_.tau(0) + about.ntau, real_tau_.begin());
    for (std::size_t k = 0; k < extra.size(); ++k)
      real_tau_[k] = static_cast<Number>(double(real_tau_[k]) + extra[k]);
    const int status =
        on_.solver.solve_at_root(real_q_.data(), real_v_.data(), real_tau_.data(), real_a_.data());
    std::copy_n(real_a_.begin(), a.size(), a.begin());
    ++evaluations_;
    return status;
  }

  // The first joint whose state is not finite, or -1.
  int not_finite() const {
    const auto good = [](double x) { return std::isfinite(x); };
    for (int j = 0; j < about.joints.count; ++j) {
      const auto q = q_.begin() + about.joints[j].q, v = v_.begin() + about.joints[j].v;
      if (!std::all_of(q, q + about.joints[j].nq, good) ||
          !std::all_of(v, v + about.joints[j].nv, good))
        return j;
    }
    return -1;
  }

  // True about every tenth of a second; the watch hears of progress then.
  bool tick() {
    const Clock::time_point now = Clock::now();
    if (now < next_) return false;
    next_ = now + std::chrono::milliseconds(100);
    on_.watch.again();
    return true;
  }

  // Progress on stderr, on runs over a second: a bar that moves on a terminal, else a line every
  // ten seconds.
  void show(double time) {
    if (!tick() || next_ < next_shown_) return;
#if defined(__unix__) || defined(__APPLE__)
    const bool moves = isatty(STDERR_FILENO) != 0;
#else
    const bool moves = false;
#endif
    next_shown_ = next_ + std::chrono::seconds(moves ? 0 : 10);
    const double part = time / asked().seconds;
    std::string bar(30, ' ');
    std::fill_n(bar.begin(), static_cast<int>(30 * part), '#');
    std::fprintf(stderr, "%ssimulating [%s] %3.0f %%, %.4g of %g s%s", moves ? "\r" : "",
                 bar.c_str(), 100 * part, time, asked().seconds, moves ? "" : "\n");
    told_ = moves;
  }

  Session& on_;
  Trajectory trajectory_;
  manifold::State q_, v_;
  std::vector<Number> real_q_, real_v_, real_tau_, real_a_;
  bool done_ = false, told_ = false;
  long long steps_ = 0, evaluations_ = 0;
  double wall_ = 0;
  Clock::time_point next_{}, next_shown_{};
};

// The sizes of the corrections of all states, for people and programs: errors before each step.
class Corrections {
 public:
  // Of the last evaluation.
  void note(const Solver& solver) {
    for (int k = 0; k < about.refine; ++k) sizes_.push_back(solver.correction(k));
  }

  // As a member of a JSON object, a comma before it; nothing without refinement.
  std::string json() const {
    if (sizes_.empty()) return "";
    std::string text = ", \"refine\": {\"steps\": " + std::to_string(about.refine);
    for (const double part : {0.5, 1.0}) {
      text += part < 1 ? ", \"correction_median\": [" : ", \"correction_max\": [";
      for (int k = 0; k < about.refine; ++k) text += (k == 0 ? "" : ", ") + number(at(k, part));
      text += "]";
    }
    return text + "}";
  }

  // The same of every state, for the result file.
  std::string every() const {
    if (sizes_.empty()) return "";
    std::string text = ", \"corrections\": [";
    for (std::size_t s = 0; s < sizes_.size(); s += steps()) {
      text += s == 0 ? "[" : ", [";
      for (std::size_t k = 0; k < steps(); ++k)
        text += (k == 0 ? "" : ", ") + number(sizes_[s + k]);
      text += "]";
    }
    return text + "]";
  }

  void print(std::FILE* out) const {
    if (sizes_.empty()) return;
    for (int k = 0; k < about.refine; ++k)
      std::fprintf(out, "refine error before step %d: median %.1e, largest %.1e\n", k + 1,
                   at(k, 0.5), at(k, 1));
  }

 private:
  static std::size_t steps() { return static_cast<std::size_t>(about.refine); }

  // Of correction k, the least value that a part of all states does not exceed.
  double at(int k, double part) const {
    std::vector<double> of_step;
    for (std::size_t s = static_cast<std::size_t>(k); s < sizes_.size(); s += steps())
      of_step.push_back(sizes_[s]);
    std::sort(of_step.begin(), of_step.end());
    const double place = part * static_cast<double>(of_step.size() - 1);
    return of_step[static_cast<std::size_t>(place)];
  }

  // Infinity is no JSON number.
  static std::string number(double x) {
    char text[32];
    std::snprintf(text, sizeof text, "%.3g", x);
    return std::isfinite(x) ? text : "null";
  }

  std::vector<double> sizes_;
};

namespace check {

// Whether a link could be a real body: second moments of its mass are not negative in any
// direction, but for what printed digits explain.
bool is_real(const Link& link) {
  constexpr Real kPrinted = 1e-3L;
  const Mat inertia = mat3(link.tensor);
  const Real half = (inertia[0][0] + inertia[1][1] + inertia[2][2]) / 2, slack = kPrinted * half;
  Mat m{};
  for (int i = 0; i < 3; ++i)
    for (int k = 0; k < 3; ++k) m[i][k] = (i == k ? half + slack : 0) - inertia[i][k];
  const Real two = m[0][0] * m[1][1] - m[0][1] * m[1][0];
  const Vec third = cross(m[0], m[1]);
  const Real all = third[0] * m[2][0] + third[1] * m[2][1] + third[2] * m[2][2];
  return link.mass >= 0 && m[0][0] >= 0 && two >= 0 && all >= 0;
}

// The first link that no real body is, or 0.
int unreal_link() {
  for (int k = 1; k < about.links.count; ++k)
    if (!is_real(about.links[k])) return k;
  return 0;
}

// What is wrong with that link, in words.
std::string unreal() {
  return "the link that joint " + quoted(about.joints[unreal_link() - 1].name) +
         " moves has an inertia that no real body has";
}

}  // namespace check

// What --check says of the answers: are they those of a robot that differs from the given one by
// rounding errors, and how much do such errors matter?
//
// The backward error of an answer is what is left over of a row of the equation of motion, relative
// to the size of all that is added up in that row, the largest of all rows: by so much the robot's
// constants and the state would have to change for the answer to be exact. A solver that is right
// keeps it small on every robot. What it means for an acceleration is up to the joint-space inertia
// H: what is left over moves the accelerations by H^-1 of it, which the solver itself tells if that
// is added to the torques. What can be known at all is seen from states that differ from the given
// one in their last digits.
class Verdict {
 public:
  static constexpr int kProbes = 4;  // by what is left over; then three times by last digits

  void listen(int rank, const States& states) {
    if (rank > 0) return;
    states_ = states;
    findings_.resize(static_cast<std::size_t>(states.count));
  }

  // All of what follows is process 0's.
  void note_answer(int s, const Number* qdd) {
    Finding& finding = at(s);
    finding.qdd.assign(qdd, qdd + about.nv);
    finding.left = check::left_over(q(s), v(s), tau(s), qdd);
    if (loops::any()) loops::account(q(s), v(s), qdd, finding.left);
    for (int j = 0; j < about.joints.count; ++j) {
      const double slip = check::slip(about.joints[j], tau(s), qdd);
      if (!(slip <= finding.left.backward)) finding.left.backward = slip, finding.left.joint = j;
    }
    finding.error.assign(finding.qdd.size(), 0);
    finding.known.assign(finding.qdd.size(), 0);
  }

  // The states of a probe.
  States states_of(int probe) const {
    States states = states_;
    std::uint64_t seed = static_cast<std::uint64_t>(probe);
    for (int s = 0; s < states.count; ++s) {
      Number* const own_q = states.q.data() + static_cast<long>(s) * about.nq;
      Number* const own_v = states.v.data() + static_cast<long>(s) * about.nv;
      Number* const own_tau = states.tau.data() + static_cast<long>(s) * about.ntau;
      if (probe == 0)
        push(at(s), own_tau);
      else
        touch(seed, own_q, own_v, own_tau);
    }
    return states;
  }

  void note_response(int probe, int s, const Number* qdd) {
    Finding& finding = at(s);
    const double step = probe == 0 ? scale(finding) / kPush : 1 / kTouch;
    for (std::size_t k = 0; k < finding.qdd.size(); ++k) {
      const double moved = (double(qdd[k]) - finding.qdd[k]) * step;
      if (probe == 0)
        finding.error[k] = std::abs(moved);
      else if (!(std::abs(moved) <= finding.known[k]))
        finding.known[k] = std::abs(moved);
    }
    finding.probed = probe + 1;
  }

  // Whether the solver is right.
  bool judge(double tolerance) {
    tolerance_ = tolerance;
    for (int s = 0; s < states_.count; ++s) {
      const Finding& finding = at(s);
      residuals_.push_back(finding.left.residual);
      backward_.push_back(finding.left.backward);
      if (s == 0 || !(finding.left.backward <= at(off_).left.backward)) off_ = s;
      if (finding.probed < kProbes) continue;
      const Unsure own = least_known(finding);
      if (!probed_ || !(own.part <= unsure_.part)) unsure_ = own, unsure_state_ = s;
      probed_ = true;
    }
    std::sort(residuals_.begin(), residuals_.end());
    std::sort(backward_.begin(), backward_.end());
    right_ = backward_.back() <= tolerance;
    if (!right_)
      fault_ = "solver";
    else if (probed_ && !(unsure_.part <= kUnsure))
      fault_ = digits() < kNone && check::unreal_link() > 0 ? "model" : "conditioning";
    return right_;
  }

  // What is said of the model where a solver refuses: nothing where all its links are real.
  static std::string of_model() {
    return check::unreal_link() > 0 ? "; the model is at fault: " + check::unreal() : "";
  }

  void print(std::FILE* out) const {
    if (backward_.empty()) return;
    std::fprintf(out, "check  backward error: median %.1e, largest %.1e of %.0e: %s\n",
                 middle(backward_), backward_.back(), tolerance_, right_ ? "right" : "WRONG");
    const std::string where =
        "state " + std::to_string(state() + 1) + ", joint " + quoted(about.joints[joint()].name);
    if (!right_)
      std::fprintf(out, "check  the solver is at fault: %s\n", where.c_str());
    else if (probed_)
      std::fprintf(out, "check  %.1f digits of the accelerations are sure: %s\n", digits(),
                   where.c_str());
    if (fault_ == "conditioning")
      std::fprintf(out,
                   "check  warning: the robot is ill-conditioned there: the last digits of its "
                   "constants and its state decide all others; another shape, or --refine, may "
                   "keep some more\n");
    if (fault_ == "model")
      std::fprintf(out, "check  warning: the model is at fault: %s\n", check::unreal().c_str());
  }

  // As a member of a JSON object, a comma before it.
  std::string json() const {
    if (backward_.empty()) return "";
    const std::string known = probed_ ? number(unsure_.part) : "null";
    return ", \"check\": {\"residual_median\": " + number(middle(residuals_)) +
           ", \"residual_max\": " + number(residuals_.back()) +
           ", \"backward_error_median\": " + number(middle(backward_)) +
           ", \"backward_error_max\": " + number(backward_.back()) +
           ", \"tolerance\": " + number(tolerance_) + ", \"forward_error\": " + known +
           ", \"digits\": " + (probed_ ? number(digits()) : "null") +
           ", \"state\": " + std::to_string(state() + 1) +
           ", \"joint\": " + quoted(about.joints[joint()].name) +
           ", \"fault\": " + (fault_.empty() ? "null" : quoted(fault_.c_str())) +
           ", \"ok\": " + (right_ ? "true" : "false") + "}";
  }

 private:
  static constexpr double kPush = 1024;  // what it does to the answer is told to three digits
  static constexpr double kTouch = 64;   // units of rounding: the solver's own are small beside it
  static constexpr double kRounding = std::numeric_limits<Number>::epsilon() / 2;
  // Where fewer than six digits (float: two) are sure, a warning tells it.
  static constexpr double kUnsure = sizeof(Number) == sizeof(double) ? 1e-6 : 1e-2;
  static constexpr double kNone = 0.5;  // fewer digits are none

  struct Finding {
    check::Left left;
    std::vector<double> qdd, error, known;  // answer, how far it is off, how far it may be
    int probed = 0;
  };

  struct Unsure {
    double part = 0;  // of the largest acceleration of the state
    int joint = 0;
  };

  Finding& at(int s) { return findings_[static_cast<std::size_t>(s)]; }
  const Finding& at(int s) const { return findings_[static_cast<std::size_t>(s)]; }
  const Number* q(int s) const { return states_.q.data() + static_cast<long>(s) * about.nq; }
  const Number* v(int s) const { return states_.v.data() + static_cast<long>(s) * about.nv; }
  const Number* tau(int s) const { return states_.tau.data() + static_cast<long>(s) * about.ntau; }

  static double scale(const Finding& finding) {
    return std::max<double>(finding.left.backward, std::numeric_limits<Number>::min());
  }

  // Adds what is left over to the torques, so much that it stands out.
  static void push(const Finding& finding, Number* tau) {
    for (const Joint& joint : about.joints) {
      if (joint.prescribed || joint.source >= 0) continue;
      for (int k = joint.v; k < joint.v + joint.nv; ++k) {
        const double over = double(finding.left.over[static_cast<std::size_t>(k)]);
        tau[k] = static_cast<Number>(double(tau[k]) + kPush * (over / scale(finding)));
      }
    }
  }

  // Changes the last digits of a state; of angles and orientations those of 1.
  static void touch(std::uint64_t& seed, Number* q, Number* v, Number* tau) {
    const auto change = [&seed](Number& x, double size) {
      seed = seed * 6364136223846793005ULL + 1442695040888963407ULL;
      const double by = ((seed >> 63) != 0 ? kTouch : -kTouch) * kRounding;
      x = static_cast<Number>(double(x) + by * std::max(size, std::abs(double(x))));
    };
    for (const Joint& joint : about.joints) {
      const int angles = turns(joint, 0) ? 0 : joint.nq == 7 ? 3 : joint.nq == 3 ? 2 : joint.nq;
      for (int k = 0; k < joint.nq; ++k) change(q[joint.q + k], k < angles ? 0 : 1);
      for (int k = joint.v; k < joint.v + joint.nv; ++k) change(v[k], 0), change(tau[k], 0);
    }
    for (int k = about.nv; k < about.ntau; ++k) change(tau[k], 0);
    slave(about.joints, q, v);
  }

  // Whether entry k of a joint's motion is an angle's.
  static bool turns(const Joint& joint, int k) {
    switch (joint.kind) {
      case JointKind::kPrismatic:
        return false;
      case JointKind::kPlanar:
        return k == 2;
      case JointKind::kFloating:
        return k >= 3;
      default:
        return true;
    }
  }

  // The joint whose acceleration is least sure, beside the largest one of its unit.
  static Unsure least_known(const Finding& finding) {
    std::array<double, 2> largest{};
    Unsure found;
    for (const bool looking : {true, false}) {
      // What is nothing beside the others, as turns are in free fall, has no digits to lose.
      const double least = 1e-6 * std::max(largest[0], largest[1]);
      for (double& most : largest) most = std::max(most, least);
      for (int j = 0; j < about.joints.count; ++j) {
        for (int k = 0; k < about.joints[j].nv; ++k) {
          const std::size_t i = static_cast<std::size_t>(about.joints[j].v + k);
          double& most = largest[turns(about.joints[j], k)];
          const double own = std::max(finding.error[i], finding.known[i]);
          if (looking)
            most = std::max(most, std::abs(finding.qdd[i]));
          else if (own > 0 && !(own / most <= found.part))
            found = {own / most, j};
        }
      }
    }
    return found;
  }

  // The joint whose acceleration is farther off than anything else explains.
  static int spoilt(const Finding& finding) {
    int found = finding.left.joint;
    double most = 0;
    for (int j = 0; j < about.joints.count && finding.probed == kProbes; ++j) {
      const Joint& joint = about.joints[j];
      for (int k = joint.v; k < joint.v + joint.nv; ++k) {
        const std::size_t i = static_cast<std::size_t>(k);
        const double part = finding.error[i] / finding.known[i];
        if (part > most) most = part, found = j;
      }
    }
    return found;
  }

  static double middle(const std::vector<double>& sorted) { return sorted[sorted.size() / 2]; }

  double digits() const { return std::max(0.0, -std::log10(unsure_.part)); }
  int state() const { return right_ && probed_ ? unsure_state_ : off_; }
  int joint() const { return right_ && probed_ ? unsure_.joint : spoilt(at(off_)); }

  static std::string number(double x) {
    char text[32];
    std::snprintf(text, sizeof text, "%.3g", x);
    return std::isfinite(x) ? text : "null";
  }

  States states_;
  std::vector<Finding> findings_;
  std::vector<double> residuals_, backward_;  // of all states, ascending
  double tolerance_ = 0;
  bool right_ = true, probed_ = false;
  int off_ = 0, unsure_state_ = 0;
  Unsure unsure_;
  std::string fault_;  // "" for none
};

// The program around the solver: solves given states, checks, times, simulates, reports.

class Program {
 public:
  Program(Options options, Solver& solver, int rank) : session_(std::move(options), solver, rank) {}

  int run() {
    const Options& options = session_.options;
    session_.watch.start(session_.rank, options.time_limit);
    const Opening how{options.channel.c_str(), options.time_limit, options.hosts, options.pin};
    const std::string wrong = session_.solver.open(MPI_COMM_WORLD, how);
    if (!wrong.empty()) return session_.complain(kFault, wrong);
    int status = options.simulation.seconds > 0 ? simulation_.run() : answer();
    const auto also = [&status](bool asked, auto task) {
      if (!asked || status == kFault || status == kUsage) return;
      const int found = task();
      if (status == kDone) status = found;
    };
    also(options.time, [this] { return timing_.time_all(); });
    also(!options.trace.empty(), [this] { return timing_.trace_all(); });
    if (status != kFault) collect_warnings();
    if (session_.rank == 0 && status != kFault) report();
    session_.watch.again();
    session_.solver.close();
    return status;
  }

 private:
  // Solves the given states, or random ones to be checked.
  int answer() {
    const Options& options = session_.options;
    int status = kDone;
    if (!options.states.empty()) {
      status = session_.load_states();
      const bool loaded = status == kDone;
      if (loaded) status = solve_all();
      if ((status == kDone || (about.batch && loaded)) && session_.rank == 0) {
        const std::string path = options.result.empty() ? "/dev/stdout" : options.result;
        if (!write_result(path, session_.qdd, session_.states.count, corrections_.every()))
          status = session_.complain(kFault, "cannot write the result", path);
      }
      MPI_Bcast(&status, 1, MPI_INT, 0, session_.comm());
    } else if (options.check) {
      session_.states = random_states(kRandomStates, options.seed, session_.solver);
      status = solve_all();
    }
    session_.watch.again();
    if (status == kDone && options.check) status = check_all();
    return status;
  }

  // Accelerations of all states, in place, then gathered at process 0.
  int solve_all() {
    Session& on = session_;
    on.use(std::move(on.states));
    if (about.batch) return solve_many();
    int at = 0;
    const int failed = solve_each(at, [&] { corrections_.note(on.solver); });
    if (failed != kFine)
      return on.complain(kInputAtFault,
                         "state " + std::to_string(at + 1) + ": " + on.solver.in_words(failed) +
                             (on.options.check ? Verdict::of_model() : ""),
                         on.options.states);
    bring_together();
    return kDone;
  }

  // One state after the other, up to the first that fails; then does after each.
  template <class Then>
  int solve_each(int& at, Then then) {
    Session& on = session_;
    int failed = kFine;
    for (int s = 0; s < on.states.count && failed == kFine; ++s) {
      on.watch.again();
      failed = on.solver.solve(on.q(s), on.v(s), on.tau(s), on.acceleration(s));
      on.give_up_if_broken(failed);
      then();
      // Processes that share no joint's motion do not hear of each other's failures by themselves.
      MPI_Allreduce(MPI_IN_PLACE, &failed, 1, MPI_INT, MPI_MAX, on.comm());
      at = s;
    }
    return failed;
  }

  // As many states at once as there are lanes. States that fail are named, all others solved.
  int solve_many() {
    constexpr int kNamed = 20;
    Session& on = session_;
    Solver& solver = on.solver;
    int status = kDone;
    solve_batch();
    solved_ = on.states.count - solver.failures();
    if (solver.failures() > 0) status = kInputAtFault;
    for (int k = 0; k < kNamed && solver.failed_state(k) >= 0; ++k)
      on.complain(status, solver.why(), on.options.states);
    if (solver.failures() > kNamed) on.complain(status, "and more states", on.options.states);
    MPI_Bcast(&status, 1, MPI_INT, 0, on.comm());
    return status;
  }

  void solve_batch() {
    Session& on = session_;
    on.give_up_if_broken(on.solver.solve_batch_at_root(on.states.count, on.q(0), on.v(0), on.tau(0),
                                                       on.acceleration(0)));
  }

  // The same for states that nobody has given: whether all were solved.
  bool solve_quietly() {
    Session& on = session_;
    on.use(std::move(on.states));
    int failed = kFine, at = 0;
    if (about.batch) {
      solve_batch();
      failed = on.rank == 0 ? on.solver.failures() : 0;
      MPI_Bcast(&failed, 1, MPI_INT, 0, on.comm());
    } else {
      failed = solve_each(at, [] {});
      if (failed == kFine) bring_together();
    }
    return failed == kFine;
  }

  void bring_together() {
    Session& on = session_;
    solved_ = on.states.count;
    // Each process wrote its own joints and left the others zero.
    void* const all = on.qdd.data();
    const int size = static_cast<int>(on.qdd.size());
    if (on.rank == 0)
      MPI_Reduce(MPI_IN_PLACE, all, size, kMpiNumber, MPI_SUM, 0, on.comm());
    else
      MPI_Reduce(all, nullptr, size, kMpiNumber, MPI_SUM, 0, on.comm());
  }

  // Judges the answers; asks the solver for some more, to see how much an error in a row matters.
  int check_all() {
    Session& on = session_;
    const States states = on.states;
    const std::vector<Number> qdd = on.qdd;
    verdict_.listen(on.rank, states);
    for (int s = 0; s < states.count && on.rank == 0; ++s)
      verdict_.note_answer(s, on.acceleration(s));
    for (int probe = 0; probe < Verdict::kProbes; ++probe) {
      if (on.rank == 0) on.states = verdict_.states_of(probe);
      if (!about.batch) on.share_states();
      if (!solve_quietly()) break;
      for (int s = 0; s < states.count && on.rank == 0; ++s)
        verdict_.note_response(probe, s, on.acceleration(s));
    }
    on.states = states, on.qdd = qdd;
    int status = on.rank > 0 || verdict_.judge(on.options.tolerance) ? kDone : kInputAtFault;
    MPI_Bcast(&status, 1, MPI_INT, 0, on.comm());
    return status;
  }

  // What processes have met that costs digits but is no failure, told once.
  void collect_warnings() {
    int joint = session_.solver.near_lock();
    MPI_Allreduce(MPI_IN_PLACE, &joint, 1, MPI_INT, MPI_MAX, session_.comm());
    if (joint == 0) return;
    warning_ = std::string("joints ") + session_.solver.names_of_run(joint - 1) +
               ": near gimbal lock at some state: accelerations lose three digits or more";
    if (session_.rank == 0) std::fprintf(stderr, "warning: %s\n", warning_.c_str());
  }

  void report() const {
    const Options& options = session_.options;
    if (options.json) {
      std::printf("{\"model\": %s, \"processes\": %d, \"channel\": \"%s\"",
                  quoted(about.robot).c_str(), about.processes, session_.solver.channel_name());
      if (!options.states.empty() && options.simulation.seconds == 0)
        std::printf(", \"solved\": %d", solved_);
      if (!warning_.empty()) std::printf(", \"warnings\": [%s]", quoted(warning_.c_str()).c_str());
      std::printf("%s%s%s%s}\n", verdict_.json().c_str(), corrections_.json().c_str(),
                  timing_.json().c_str(), simulation_.json().c_str());
      return;
    }
    std::FILE* const out = options.states.empty() || !options.result.empty() ? stdout : stderr;
    verdict_.print(out);
    corrections_.print(out);
    timing_.print(out);
    simulation_.print();
  }

  Session session_;
  Timing timing_{session_};
  Simulation simulation_{session_};
  Corrections corrections_;
  Verdict verdict_;
  int solved_ = 0;
  std::string warning_;
};

}  // namespace

// Compiled for size, and with it what it alone calls: it runs once.
template <>
[[gnu::cold]] int program(const Description<Number>& description,
                          AnySolver<Number, MPI_Comm>& solver, int count, char** words) {
  about = description;
  Options options;
  const std::string wrong = parse(count, words, options);
  MPI_Init(&count, &words);
  int rank = 0, size = 0;
  MPI_Comm_rank(MPI_COMM_WORLD, &rank);
  MPI_Comm_size(MPI_COMM_WORLD, &size);
  int status = kDone;
  const std::string launch = "mpiexec -n " + std::to_string(about.processes);
  if (!wrong.empty() || (size != about.processes && !options.help)) {
    status = kUsage;
    if (rank == 0 && !wrong.empty())
      std::fprintf(stderr, "error: %s; see --help\n", wrong.c_str());
    else if (rank == 0)
      std::fprintf(stderr, "error: this solver is for exactly %d process%s, started with %d: %s\n",
                   about.processes, about.processes > 1 ? "es" : "", size,
                   about.processes > 1 ? ("use " + launch).c_str() : "start it without mpiexec");
  } else if (options.help) {
    if (rank == 0)
      std::printf("usage: %s%s [options]\n%s", about.processes > 1 ? (launch + " ").c_str() : "",
                  words[0], kUsageText);
  } else {
    status = std::make_unique<Program>(options, solver, rank)->run();
  }
  MPI_Finalize();
  return status;
}

}  // namespace adagen
