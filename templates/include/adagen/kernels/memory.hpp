// adagen's runtime, the same for all robots.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstring>
#include <limits>
#include <type_traits>
#include <utility>

#include "../constants.hpp"
#include "../sample/cuts.hpp"
#include "../sample/inertias.hpp"
#include "../sample/robot.hpp"
#include "../sample/state.hpp"
#include "../sizes.hpp"
#include "../status.hpp"
#include "../value.hpp"
#include "algebra.hpp"
#include "blocks.hpp"
#include "lanes.hpp"
#include "loop_settings.hpp"

namespace {

// The memory of a process.

// Joints that are treated together, one in each lane of T; their slots follow each other.
template <class T>  // T may be one Value itself: NOLINTNEXTLINE(bugprone-sizeof-expression)
[[maybe_unused]] constexpr int kWidth = static_cast<int>(sizeof(T) / sizeof(Value));
template <class T>
struct Joints {
  int slot;  // of the first one
  int joint[kWidth<T>];

  constexpr const JointConstants& any() const {
    return kJoints[static_cast<std::size_t>(joint[0])];
  }
};
ADAGEN_INLINE Joints<Value> single(int j) { return {slot_of(j), {j}}; }

// A number of each of the joints.
template <class T, class Number, std::size_t... lane>
ADAGEN_INLINE T each_of(const Joints<T>& joints, const Number& number,
                        std::index_sequence<lane...>) {
  return T{Real(number(kJoints[static_cast<std::size_t>(joints.joint[lane])]))...};
}
template <class T, class Number>
ADAGEN_INLINE T each(const Joints<T>& joints, const Number& number) {
  if constexpr (kWidth<T> == 1) {
    const auto one = number(kJoints[static_cast<std::size_t>(joints.joint[0])]);
    if constexpr (std::is_same_v<decltype(one), const T>)
      return one;
    else
      return T{} + one;
  } else {
    return each_of(joints, number, std::make_index_sequence<kWidth<T>>{});
  }
}

// Blocks in memory: all, or those of a tile, which the tiles of a run take in turn (tiles.hpp).
constexpr int kWindow = kTile > 0 ? kTile / kPerBlock : kBlockCount;
[[maybe_unused]] constexpr int kColumnCount = kTile > 0 ? kTile : kJointCount;

// What a block holds of each link j + 1, joint j being the one above it; in the axes of its base.
enum Entry : int {
  kTurn = 0,           // rotation from the child's to the parent link's axes, row by row
  kAxes = 9,           // the link's orientation R, row by row: its z is the joint's axis
  kOmega = 18,         // angular velocity
  kAlpha = 21,         // angular acceleration and
  kAcceleration = 24,  // acceleration of its origin less gravity, were all joint accelerations zero
  kRotational = 27,    // A of the bare link
  kMoments = 33,       // mass times centre of mass: B of the bare link is its cross product
  kTorque = 36,        // bias force n
  kForce = 39,         // and f of the bare link
  kGained = 42,        // for residuals: what it accelerates by beyond that, angular and
  kGainedAlong = 45,   // linear, and
  kReached = 48,       // squares of what is uncertain of it in the last place
  kReachedAlong = 49,
  kTakenTorque = 50,  // what it takes with all that: n
  kTakenForce = 53,   // and f, and
  kTakenUnits = 56,   // the square of what may be rounding of it
  kEntries = kWeighed ? 57 : 42
};

// Whether joints have one freedom each, so that their numbers are those of their freedoms.
[[maybe_unused]] constexpr bool one_each() {
  for (int j = 0; j < kJointCount; ++j)
    if (kJoints[static_cast<std::size_t>(j)].v != j) return false;
  return kJointCount == kNv;
}
[[maybe_unused]] constexpr bool kOneEach = one_each();

struct alignas(64) Block {
  Value entries[kEntries][kPerBlock];
};

// Three numbers of each of the joints, that follow each other in x.
template <class T>
ADAGEN_INLINE Vector<T> each_vector(const Joints<T>& joints, const Value* x,
                                    int JointConstants::* place) {
  const auto number = [&](int k) {
    return each(joints, [&](const JointConstants& own) { return x[own.*place + k]; });
  };
  return {number(0), number(1), number(2)};
}

// Whether a joint between moving links is of a kind; one on the ground that floats needs nothing.
[[maybe_unused]] constexpr bool any_of(JointKind kind) {
  for (const JointConstants& joint : kJoints)
    if (joint.kind == kind && (joint.parent > 0 || kind != JointKind::kFloating)) return true;
  return false;
}
// Whether the body beyond a floating joint is kept: for mobilities, and for residuals.
[[maybe_unused]] constexpr bool kKeepsFree =
    kPassesFree || (kWeighed && any_of(JointKind::kFloating));
// Evaluated once each, not at each use in templates: g++ would need time quadratic in the joints.
[[maybe_unused]] constexpr bool kAnyPrismatic = any_of(JointKind::kPrismatic);
[[maybe_unused]] constexpr bool kAnySpherical = any_of(JointKind::kSpherical);
[[maybe_unused]] constexpr bool kAnyPlanar = any_of(JointKind::kPlanar);
[[maybe_unused]] constexpr bool kAnyFloating = any_of(JointKind::kFloating);
constexpr bool any_with(Number Passive::* number) {
  for (const JointConstants& joint : kJoints)
    if (joint.passive.*number != 0) return true;
  return false;
}
[[maybe_unused]] constexpr bool kAnyFriction = any_with(&Passive::friction),
                                kAnySpring = any_with(&Passive::stiffness);
[[maybe_unused]] constexpr bool kAnySpent =
    any_with(&Passive::damping) || kAnyFriction || kAnySpring;
[[maybe_unused]] constexpr bool kAnyRotor = any_with(&Passive::rotor);

// Whether a joint's axis lies beside what it is treated with, and not with those of its block.
template <class T>
constexpr bool kWithAxis = kByColumns && kWidth<T> == 1;
// Of a joint with one freedom: U / D (6), u / D, 1 / D; of others see inward.hpp.
constexpr int kMostFactors = kAnyPlanar ? 24 : kAnySpherical ? 18 : 8;

// What is kept of a joint from the inward to the outward sweep.
template <class T, bool with_axis = kWithAxis<T>>
struct Eliminated {
  Vector<T> r;  // from the parent link's origin to the child link's
  T e[kMostFactors];
};
template <class T>
struct alignas(64) Eliminated<T, true> {
  Vector<T> axis;
  T none;  // so that axis and r lie as the halves of a column
  Vector<T> r;
  T nothing;
  T e[kMostFactors];
};
using Memory = Eliminated<Value>;

// A bare link as it is added to columns (see inward_columns.hpp).
struct alignas(64) LinkColumns {
  Real tensor[8], moments[8], force[8];
};

// A link's orientation and how it moves, were all joint accelerations zero; in the axes of the base
// (of the ground, or of a floating base's link), about the link's own origin.
template <class T>
struct Frame {
  Matrix<T> R;
  Vector<T> omega, alpha, a;
};

struct Workspace : State, Cuts, Inertias {
  int status = kFine;
  bool lost = false;   // whether a sweep in axes of the base found too few digits left
  bool again = false;  // whether links feel the forces in their blocks, and no motion's
  alignas(64) std::array<Value, kWindow * kPerBlock> angle{};  // of each joint that turns
  std::array<Block, kWindow> blocks{};
  std::array<Memory, kJointCount> joints{};
  std::array<Eliminated<Two>, kInLanes ? kSlotCount / 2 : 0> twos{};  // of joints in lanes, by slot
  std::array<Eliminated<Four>, kInLanes ? kSlotCount / 4 : 0> fours{};
  // Of joints of parts, one part in each lane, and what unit wrenches on the parts' ends do to
  // them.
  std::array<Eliminated<Lanes>, kInParts ? kBlockCount : 0> rows{};
  std::array<std::array<Lanes, 6>, kInParts ? kBlockCount : 0> drives{};
  // Of the link beyond each joint, and one for slots that are not filled.
  std::array<LinkColumns, kByColumns ? kColumnCount + 1 : 0> columns{};
  std::array<Body<Value>, kLinkCount> bodies{};     // what hangs on a link, where paths meet
  std::array<Motion<Value>, kLinkCount> motions{};  // accelerations beyond those of a Frame
  std::array<Value, kNv> answer{};
  std::array<Value, kAnySpent ? kNv : 0> spent{};  // by damping, friction and springs
  std::array<Value, kAnySpent && kWeighed ? kNv : 0> spent_squares{};  // of each of them
  std::array<Body<Value>, kKeepsFree ? kJointCount : 0> free{};        // beyond floating joints
  std::array<Lanes, kCarriesAlong ? kJointCount : 0> driven{};  // by unit wrenches on a run's end
  std::array<Body<Value>, kWide ? kJointCount : 0> whole{};     // beyond each joint, to be refined

  Workspace() {
    for (Block& block : blocks)  // slots that are not filled do not turn
      for (const int k : {0, 4, 8}) std::fill_n(block.entries[kTurn + k], kPerBlock, Value{} + 1);
    for (int j = 0; j < kJointCount; ++j)  // what an angle does not change stays as it is
      for (int k = 0; k < 9; ++k)
        of(j, kTurn)[k * kPerBlock] = Value{} + kJoints[static_cast<std::size_t>(j)].rotation[k];
  }

  Value* of(int joint, Entry entry) { return at(slot_of(joint), entry); }
  Value* at(int slot, int entry) {
    const int block = slot / kPerBlock % kWindow;
    return &blocks[static_cast<std::size_t>(block)].entries[entry][slot % kPerBlock];
  }

  template <class T>
  Eliminated<T>& memory(const Joints<T>& of) {
    if constexpr (kWidth<T> == 1)
      return joints[static_cast<std::size_t>(of.joint[0])];
    else if constexpr (kWidth<T> == 2)
      return twos[static_cast<std::size_t>(of.slot / 2)];
    else if constexpr (kWidth<T> == kPerBlock)
      return rows[static_cast<std::size_t>(of.slot / kPerBlock)];
    else
      return fours[static_cast<std::size_t>(of.slot / 4)];
  }
};

template <class T = Value>
ADAGEN_INLINE T number_at(const Value* x) {
  return from_memory<T>(x);
}
template <class T>
ADAGEN_INLINE void put_at(Value* x, const T& number) {
  to_memory(number, x);
}
template <class T = Value>
ADAGEN_INLINE Vector<T> vector_at(const Value* x, int stride = kPerBlock) {
  return {number_at<T>(x), number_at<T>(x + stride), number_at<T>(x + 2 * stride)};
}
template <class T>
ADAGEN_INLINE void put_at(Value* x, const Vector<T>& a) {
  put_at(x, a.x), put_at(x + kPerBlock, a.y), put_at(x + 2 * kPerBlock, a.z);
}
template <class T = Value>
ADAGEN_INLINE Matrix<T> matrix_at(const Value* x) {
  return {vector_at<T>(x), vector_at<T>(x + 3 * kPerBlock), vector_at<T>(x + 6 * kPerBlock)};
}
template <class T>
ADAGEN_INLINE void put_at(Value* x, const Matrix<T>& m) {
  put_at(x, m.x), put_at(x + 3 * kPerBlock, m.y), put_at(x + 6 * kPerBlock, m.z);
}
template <class T = Value>
ADAGEN_INLINE Vector<T> axis_at(const Value* R) {
  return vector_at<T>(R + 2 * kPerBlock, 3 * kPerBlock);
}
template <class T>
ADAGEN_INLINE void put_axis_at(Value* R, const Vector<T>& axis) {
  put_at(R + 2 * kPerBlock, axis.x), put_at(R + 5 * kPerBlock, axis.y);
  put_at(R + 8 * kPerBlock, axis.z);
}
template <class T>
ADAGEN_INLINE Vector<T> axis_of(Workspace& w, const Joints<T>& joints) {
  if constexpr (kWithAxis<T>)
    return w.memory(joints).axis;
  else
    return axis_at<T>(w.at(joints.slot, kAxes));
}

// A body in a message.
[[maybe_unused]] constexpr int kBodyNumbers = 27;
template <class T>
ADAGEN_INLINE Number* put(Number* to, const Body<T>& X) {
  static_assert(sizeof X == kBodyNumbers * sizeof(Real));
  Real numbers[kBodyNumbers];
  std::memcpy(numbers, &X, sizeof X);
  return std::copy_n(numbers, kBodyNumbers, to);
}
template <class T>
ADAGEN_INLINE const Number* get(const Number* from, Body<T>& X) {
  Real numbers[kBodyNumbers];
  std::copy_n(from, kBodyNumbers, numbers);
  std::memcpy(&X, numbers, sizeof X);
  return from + kBodyNumbers;
}
template <class T>
ADAGEN_INLINE const Number* add(const Number* from, Body<T>& X) {
  Body<T> other;
  from = get(from, other);
  X += other;
  return from;
}

ADAGEN_INLINE Lanes wide(const Value* x) { return from_memory<Lanes>(x); }

// The torque along a freedom, by its place in v, that reaches the links: less damping, friction and
// what a spring takes. Of forces that are repeated, these are no part.
ADAGEN_INLINE Value torque_at(const Workspace& w, int place) {
  const Value& tau = w.tau[place];
  if constexpr (kAnySpent)
    if (!(kAgain && w.again)) return tau - w.spent[static_cast<std::size_t>(place)];
  return tau;
}
ADAGEN_INLINE Value torque(const Workspace& w, const JointConstants& joint, int freedom = 0) {
  return torque_at(w, joint.v + freedom);
}
ADAGEN_INLINE Value torque(const Workspace& w, int joint) {
  if constexpr (kOneEach) return torque_at(w, joint);
  return torque(w, kJoints[static_cast<std::size_t>(joint)]);
}

// A joint of prescribed motion among limbs in lanes: no force moves it, it follows its
// prescription.
ADAGEN_INLINE Real immovable(const JointConstants& joint) {
  return joint.passive.prescribed ? std::numeric_limits<Real>::infinity() : 0;
}
ADAGEN_INLINE Value prescribed(const Workspace& w, const JointConstants& joint) {
  return joint.passive.prescribed ? w.tau[joint.v] : Value{};
}

// Accelerations are given only where all went well.
inline void give(Workspace& w, int first, int count) {
  if (w.status == kFine)
    std::copy_n(&w.answer[static_cast<std::size_t>(first)], count, w.qdd + first);
}

[[maybe_unused]] constexpr int block(int joint) { return joint / kPerBlock; }

}  // namespace
