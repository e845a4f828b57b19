// adagen's runtime, the same for all robots.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <type_traits>
#include <utility>

#include "common.hpp"
#include "kernels/shuffles.hpp"
#include "sample/unrolled.hpp"
#include "short_vectors.hpp"
#include "sizes.hpp"
#include "unrolled_wide.hpp"

// Lines with such a loop are longer than an instruction cache: like ADAGEN_AS_IT_STANDS, and what
// is on the stack is reached by shorter instructions.
#if defined(__clang__)
#define ADAGEN_DENSE
#else
#define ADAGEN_DENSE __attribute__((optimize("no-tree-slp-vectorize", "no-omit-frame-pointer")))
#endif

namespace {

// A record: joints whose residuals are swept together, one in each lane.
template <int lanes>
struct SweptRow {
  int place;    // of their numbers in the workspace
  int passes;   // in which they are handed on; none where all near links are the ground
  bool next;    // whether all is handed on to the next record instead, lane by lane
  bool added;   // whether squares and forces are added to its numbers, by others or the line
  bool slides;  // whether one of its joints slides
  std::array<short, lanes> angle;  // places among angles; of what is zero in lanes without a joint
};

// What lanes of a record hand on to another one.
template <int lanes>
struct SweptPass {
  int near;   // where the other one's numbers begin
  bool more;  // whether the next pass is to the same one
  std::array<std::conditional_t<sizeof(Real) == 8, std::int64_t, std::int32_t>, lanes> from;
  std::array<Real, lanes> counts;  // 1 in lanes of the other one that take those of from, or 0
};

// Numbers of a row, in the order in which they lie in the workspace, kWidth<T> lanes each. Those
// before kAcceleration are gathered from the links beyond; other links that gather have just these.
struct SweptNumber {
  static constexpr int kWrench = 0;   // that of the reference field, of the link and beyond
  static constexpr int kSquares = 6;  // of moments and forces that were added up beyond
  static constexpr int kForce = 10;   // force that the motion takes, of the link and beyond
  static constexpr int kAcceleration = 13;
  static constexpr int kAcross = 19;   // D^-1 U but for the entry along the joint: x, y; x, y; z
  static constexpr int kInverse = 24;  // 1 / D, zero in lanes that repeat others
  static constexpr int kTorque = 25;   // less what a rotor takes
  static constexpr int kMoment = 26;   // for joints that hold: the moment or force along it, and
  static constexpr int kSquare = 27;   // the square of all that came together there
  static constexpr int kShift = 28;    // where some joints slide: how far
};

// What there is among rows.
template <bool some_float, bool some_close, bool some_slide, bool some_drive>
struct SweptKinds {
  static constexpr bool floats = some_float;  // a base: forces are handed on
  static constexpr bool closed = some_close;  // loops: some joints hold
  static constexpr bool slides = some_slide;
  static constexpr bool rotors = some_drive;
};

// Constants of a row likewise.
template <class Kinds>
struct SweptConstant {
  static constexpr int kMoments = 0;  // xx, yy, zz, xy, xz, yz about the origin
  static constexpr int kMassCentre = 6;
  static constexpr int kMass = 9;
  static constexpr int kPlacement = 10;  // by rows
  static constexpr int kOrigin = 19;
  static constexpr int kLevers = 22;  // squares of lever arms
  static constexpr int kAcross = 25;  // squares across the joint that turn to be x, y, z: 1; or 0
  static constexpr int kAlong = 28;   // likewise those along it
  static constexpr int kHolds = 31;   // whether the joint passes on all of a wrench
  static constexpr int kCounts = 32;  // zero in lanes that repeat others
  static constexpr int kSlides = 33;  // whether it slides; then squares about y, like kAcross
  static constexpr int kOther = 34;
  static constexpr int kRotor = Kinds::slides ? 37 : 33;  // its inertia
  static constexpr int kAll = kRotor + (Kinds::rotors ? 1 : 0);
};

template <class T>
struct SweptSums {
  T seen, rounded, answer;
};

// A vector of the child's axes in the parent's.
template <class T>
ADAGEN_INLINE void turn_swept(const T (&u)[3], const T (&turn)[3][3], T (&out)[3]) {
  ADAGEN_FOR (k, 0, 3) out[k] = turn[k][2] * u[2] + turn[k][0] * u[0] + turn[k][1] * u[1];
}

// One number for each lane.
template <class T, std::size_t... lane>
ADAGEN_INLINE T of_angles(const Real* from, const std::array<short, kWidth<T>>& places,
                          std::index_sequence<lane...>) {
  return T{from[places[lane]]...};
}

// Adds what lanes hand on to those of another record, in several passes where they meet there.
template <int gathered, class T>
ADAGEN_INLINE const SweptPass<kWidth<T>>* hand_on(Real* const memory,
                                                  const SweptPass<kWidth<T>>* pass,
                                                  const T (&out)[SweptNumber::kAcceleration]) {
  Real* const near = memory + pass->near;
  T sum[gathered];
  ADAGEN_FOR (k, 0, gathered) sum[k] = load<T>(near + k * kWidth<T>);
  for (bool more = true; more; ++pass) {
    more = pass->more;
    const T counts = load<T>(pass->counts.data());
    const auto from = from_memory<BitsOf<T>>(pass->from.data());
    ADAGEN_FOR (k, 0, gathered) sum[k] += counts * moved(out[k], from);
  }
  ADAGEN_FOR (k, 0, gathered) put(sum[k], near + k * kWidth<T>);
  return pass;
}

// Inwards: residuals of the links of a record, handed on through its joints, and their energy. What
// is known of the links themselves is added up before what comes from beyond, which takes longer.
//
// handed: by the record before, and then by this one to the next.
template <class Kinds, class T>
ADAGEN_INLINE void sweep_row(Real* const memory, const SweptRow<kWidth<T>>& row,
                             const SweptPass<kWidth<T>>* const passes, const T& c, const T& s,
                             const Real* const constant, SweptSums<T>& sums,
                             T (&handed)[SweptNumber::kAcceleration]) {
  using Number = SweptNumber;
  using Constant = SweptConstant<Kinds>;
  constexpr bool floats = Kinds::floats, closed = Kinds::closed;
  const bool slides = Kinds::slides && row.slides;
  constexpr int W = kWidth<T>, gathered = floats ? Number::kAcceleration : Number::kForce;
  Real* const own = memory + row.place;
  const auto number = [own](int k) { return load<T>(own + k * W); };
  const auto known = [constant](int k) { return load<T>(constant + k * W); };

  if (row.added)
    ADAGEN_FOR (k, Number::kSquares, gathered) handed[k] += number(k);
  T moment[3], force[3], squares[4], field[3];
  {
    T energy{};
    T alpha[3], a[3], centre[3];
    const T mass = known(Constant::kMass);
    ADAGEN_FOR (k, 0, 3) {
      alpha[k] = number(Number::kAcceleration + k);
      a[k] = number(Number::kAcceleration + 3 + k);
      centre[k] = known(Constant::kMassCentre + k);
    }
    const T xy = known(Constant::kMoments + 3), xz = known(Constant::kMoments + 4),
            yz = known(Constant::kMoments + 5);
    ADAGEN_FOR (k, 0, 3) {
      const int i = (k + 1) % 3, m = (k + 2) % 3;
      const T& with_i = k == 0 ? xy : k == 1 ? yz : xz;
      const T& with_m = k == 0 ? xz : k == 1 ? xy : yz;
      const T taken = known(Constant::kMoments + k) * alpha[k] + with_i * alpha[i] +
                      with_m * alpha[m] + centre[i] * a[m] - centre[m] * a[i];
      moment[k] = (number(Number::kWrench + k) + taken) + handed[Number::kWrench + k];
      const T pushed = mass * a[k] + alpha[i] * centre[m] - alpha[m] * centre[i];
      force[k] = (number(Number::kWrench + 3 + k) + pushed) + handed[Number::kWrench + 3 + k];
      if constexpr (floats) field[k] = handed[Number::kForce + k] + pushed;
      if constexpr (closed) energy += alpha[k] * taken + a[k] * pushed;
      squares[k] = handed[Number::kSquares + k] + moment[k] * moment[k];
    }
    if constexpr (closed) sums.answer += energy * known(Constant::kCounts);
  }
  squares[3] = (handed[Number::kSquares + 3] + force[0] * force[0]) +
               (force[1] * force[1] + force[2] * force[2]);

  const T torque = number(Number::kTorque), inverse = number(Number::kInverse);
  T free = moment[2], square = squares[2];
  if (slides) {
    const auto sliding = known(Constant::kSlides) > Real(0);
    free = chosen(sliding, force[2], free);
    square = chosen(sliding, squares[3], square);
  }
  const T driven = torque - free;
  sums.seen += driven * (driven * inverse);
  sums.rounded += square * inverse;
  T passed = torque, along = torque * torque;
  if constexpr (Kinds::rotors) passed -= known(Constant::kRotor) * inverse * driven;
  if constexpr (closed) {
    const auto holds = known(Constant::kHolds) > Real(0);
    passed = chosen(holds, free, passed);
    along = chosen(holds, square, along);
    put(free, own + Number::kMoment * W);
    put(square, own + Number::kSquare * W);
  }
  // The next evaluation begins with what its line leaves, and with nothing else, in no lane: what
  // is not finite may have come into all of them.
  if (row.added)
    ADAGEN_FOR (k, 0, gathered) put(T{}, own + k * W);
  if (row.passes == 0 && !row.next) {
    ADAGEN_FOR (k, 0, gathered) handed[k] = T{};
    return;
  }

  // Turned about z, then as the joint is placed.
  T turn[3][3], turned[3], moved[3], origin[3], levers[3], about[3];
  const T across = larger(squares[0], squares[1]);
  ADAGEN_FOR (k, 0, 3) {
    const T x = known(Constant::kPlacement + 3 * k), y = known(Constant::kPlacement + 3 * k + 1);
    turn[k][0] = c * x + s * y;
    turn[k][1] = c * y - s * x;
    turn[k][2] = known(Constant::kPlacement + 3 * k + 2);
    origin[k] = known(Constant::kOrigin + k);
    levers[k] = known(Constant::kLevers + k);
    about[k] = across * known(Constant::kAcross + k);
  }
  ADAGEN_FOR (k, 0, 2) {
    moment[k] += number(Number::kAcross + k) * driven;
    force[k] += number(Number::kAcross + 2 + k) * driven;
  }
  const T other = number(Number::kAcross + 4) * driven;
  if (slides) {
    const auto sliding = known(Constant::kSlides) > Real(0);
    const T across_slides = moment[2] + other;
    moment[2] = chosen(sliding, across_slides, passed);
    force[2] = chosen(sliding, passed, T(force[2] + other));
    along = chosen(sliding, squares[2], along);
    T arms[3];  // no less than to where the joint is placed: sliding may take that back
    ADAGEN_FOR (k, 0, 3) {
      const T place = origin[k];
      origin[k] += turn[k][2] * number(Number::kShift);
      arms[k] = larger(T(place * place), T(origin[k] * origin[k]));
      about[k] = larger(T(squares[0] * known(Constant::kAcross + k)),
                        T(squares[1] * known(Constant::kOther + k)));
    }
    ADAGEN_FOR (k, 0, 3) {
      const int i = (k + 1) % 3, m = (k + 2) % 3;
      levers[k] = arms[i] + arms[m];
    }
  } else {
    moment[2] = passed;
    force[2] += other;
  }
  turn_swept(force, turn, moved);
  turn_swept(moment, turn, turned);
  ADAGEN_FOR (k, 0, 3) {
    const int i = (k + 1) % 3, m = (k + 2) % 3;
    handed[Number::kWrench + k] = turned[k] + origin[i] * moved[m] - origin[m] * moved[i];
    handed[Number::kWrench + 3 + k] = moved[k];
    const T from = larger(about[k], T(along * known(Constant::kAlong + k)));
    handed[Number::kSquares + k] = from + levers[k] * squares[3];
  }
  handed[Number::kSquares + 3] = squares[3];
  if constexpr (floats) {
    turn_swept(field, turn, turned);
    ADAGEN_FOR (k, 0, 3) handed[Number::kForce + k] = turned[k];
  }
  if (row.next) return;
  for (const auto* pass = passes; pass < passes + row.passes;)
    pass = hand_on<gathered>(memory, pass, handed);
  ADAGEN_FOR (k, 0, gathered) handed[k] = T{};
}

// Sweeps the residuals of records inwards; other links gather what these hand on. In robots with
// closed loops some joints hold, and the energy of the answer is found link by link.
//
// gathered: where what they gather begins, up to the sums: the squared error that shows, the
// allowance for rounding in squares of units, and, of links, the answer's energy.
template <class T, class Kinds, std::size_t rows, std::size_t count, std::size_t numbers>
ADAGEN_NOINLINE void sweep_rows(Workspace& w, const std::array<SweptRow<kWidth<T>>, rows>& swept,
                                const std::array<SweptPass<kWidth<T>>, count>& passes,
                                const std::array<Real, numbers>& constants, int gathered,
                                int sums) {
  using Constant = SweptConstant<Kinds>;
  constexpr int W = kWidth<T>, step = Constant::kAll * W;
  static_assert(numbers == rows * step);
  Real* const memory = w.x.data();
  std::fill(memory + gathered, memory + sums, Real(0));
  SweptSums<T> found{};
  T handed[SweptNumber::kAcceleration]{};
  const Real* constant = constants.data();
  const SweptPass<W>* pass = passes.data();
  constexpr auto lanes = std::make_index_sequence<kWidth<T>>{};
  for (const SweptRow<W>& row : swept) {
    T c = of_angles<T>(w.cosine.data(), row.angle, lanes);
    const T s = of_angles<T>(w.sine.data(), row.angle, lanes);
    if (Kinds::slides && row.slides) c += load<T>(constant + Constant::kSlides * W);  // of no angle
    sweep_row<Kinds>(memory, row, pass, c, s, constant, found, handed);
    constant += step;
    pass += row.passes;
  }
  memory[sums] = across<W>(found.seen);
  memory[sums + 1] = across<W>(found.rounded);
  if constexpr (Kinds::closed) memory[sums + 2] = across<W>(found.answer);
}

}  // namespace
