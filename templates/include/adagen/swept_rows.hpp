// adagen's runtime, the same for all robots.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>

#include "common.hpp"
#include "sample/unrolled.hpp"
#include "short_vectors.hpp"
#include "sizes.hpp"
#include "unrolled_wide.hpp"

namespace {

// Joints whose residuals are swept together, one in each lane.
template <int lanes>
struct SweptRow {
  int place;                  // of their numbers in the workspace
  int angle;                  // the first one's place among angles
  int width;                  // lanes with a joint
  int count;                  // lanes that have near links; none where all of these are the ground
  bool beside;                // whether the near links are a row in the same lanes
  std::array<short, 3> from;  // squares that turn to be x, y, z: across the axis, along it, both
  std::array<int, lanes> near;  // where the near links' numbers begin, those of the ground, too
};

// Numbers of a row, in the order in which they lie in the workspace, kWidth<T> lanes each. Those
// before kAcceleration are gathered from the links beyond; other links that gather have just these.
struct SweptNumber {
  static constexpr int kWrench = 0;   // that of the reference field, of the link and beyond
  static constexpr int kSquares = 6;  // of moments and forces that were added up beyond
  static constexpr int kForce = 10;  // force that the reference field takes, of the link and beyond
  static constexpr int kAcceleration = 13;
  static constexpr int kAcross = 19;   // D^-1 U but for the entry along the joint
  static constexpr int kInverse = 24;  // 1 / D, zero in lanes that repeat others
  static constexpr int kMissing = 25;  // u of the evaluation
  static constexpr int kTorque = 26;
};

// Constants of a row likewise.
struct SweptConstant {
  static constexpr int kMoments = 0;  // xx, yy, zz, xy, xz, yz about the origin
  static constexpr int kMassCentre = 6;
  static constexpr int kMass = 9;
  static constexpr int kPlacement = 10;  // by rows
  static constexpr int kOrigin = 19;
  static constexpr int kLevers = 22;  // squares of lever arms
  static constexpr int kAll = 25;
};

template <class T>
struct SweptSums {
  T seen, rounded, answer;
};

template <class T>
ADAGEN_INLINE T larger_of(const T& a, const T& b) {
  return a > b ? a : b;
}

// A vector of the child's axes in the parent's: turned about z, then as the joint is placed.
template <class T>
ADAGEN_INLINE void turn_swept(const T (&u)[3], const T& c, const T& s, const T (&placed)[3][3],
                              T (&out)[3]) {
  const T x = c * u[0] - s * u[1], y = s * u[0] + c * u[1];
  ADAGEN_FOR (k, 0, 3) out[k] = placed[k][2] * u[2] + placed[k][0] * x + placed[k][1] * y;
}

// Inwards: residuals of the links of a row, handed on through its joints, and their energy. What is
// known of the links themselves is added up before what comes from beyond, which takes longer.
template <bool floats, class T>
ADAGEN_INLINE void sweep_row(Real* const memory, const SweptRow<kWidth<T>>& row, const T& c,
                             const T& s, const Real* const constant, SweptSums<T>& sums) {
  using Number = SweptNumber;
  using Constant = SweptConstant;
  constexpr int W = kWidth<T>, gathered = floats ? Number::kAcceleration : Number::kForce;
  Real* const own = memory + row.place;
  const auto number = [own](int k) { return load<T>(own + k * W); };
  const auto known = [constant](int k) { return load<T>(constant + k * W); };

  T moment[3], force[3], squares[4];
  {
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
      moment[k] = number(Number::kWrench + k) + taken;
      const T pushed = mass * a[k] + alpha[i] * centre[m] - alpha[m] * centre[i];
      force[k] = number(Number::kWrench + 3 + k) + pushed;
      squares[k] = number(Number::kSquares + k) + moment[k] * moment[k];
    }
  }
  squares[3] = (number(Number::kSquares + 3) + force[0] * force[0]) +
               (force[1] * force[1] + force[2] * force[2]);

  const T torque = number(Number::kTorque), inverse = number(Number::kInverse),
          u = number(Number::kMissing);
  const T driven = torque - moment[2];
  sums.seen += driven * driven * inverse;
  sums.rounded += squares[2] * inverse;
  sums.answer += u * u * inverse;
  T field[3];
  if constexpr (floats) {
    ADAGEN_FOR (k, 0, 3) field[k] = number(Number::kForce + k);
  }
  // The next evaluation begins with what its line leaves, and without squares.
  ADAGEN_FOR (k, 0, 4) put(T{}, own + (Number::kSquares + k) * W);
  if (row.count == 0) return;

  T placed[3][3], out[Number::kAcceleration], turned[3], moved[3];
  ADAGEN_FOR (k, 0, 3) {
    ADAGEN_FOR (i, 0, 3) placed[k][i] = known(Constant::kPlacement + 3 * k + i);
  }
  moment[0] += number(Number::kAcross) * driven;
  moment[1] += number(Number::kAcross + 1) * driven;
  moment[2] = torque;
  ADAGEN_FOR (k, 0, 3) force[k] += number(Number::kAcross + 2 + k) * driven;
  turn_swept(force, c, s, placed, moved);
  turn_swept(moment, c, s, placed, turned);
  const T across = larger_of(squares[0], squares[1]), along = torque * torque;
  const T from[3] = {across, along, larger_of(across, along)};
  ADAGEN_FOR (k, 0, 3) {
    const int i = (k + 1) % 3, m = (k + 2) % 3;
    out[Number::kWrench + k] = turned[k] + known(Constant::kOrigin + i) * moved[m] -
                               known(Constant::kOrigin + m) * moved[i];
    out[Number::kWrench + 3 + k] = moved[k];
    out[Number::kSquares + k] = from[row.from[k]] + known(Constant::kLevers + k) * squares[3];
  }
  out[Number::kSquares + 3] = squares[3];
  if constexpr (floats) {
    turn_swept(field, c, s, placed, turned);
    ADAGEN_FOR (k, 0, 3) out[Number::kForce + k] = turned[k];
  }
  if (row.beside) {
    Real* const near = memory + row.near[0];
    ADAGEN_FOR (k, 0, gathered) put(T(load<T>(near + k * W) + out[k]), near + k * W);
    return;
  }
  for (int lane = 0; lane < row.count; ++lane) {
    Real* const near = memory + row.near[static_cast<std::size_t>(lane)];
    ADAGEN_FOR (k, 0, gathered) near[k * W] += out[k][lane];
  }
}

// Sweeps the residuals of rows inwards; other links gather what these hand on.
//
// gathered: where what they gather begins, up to the sums: the squared error that shows, the
// allowance for rounding in squares of units, and the answer's energy.
template <class T, bool floats, std::size_t rows, std::size_t numbers>
ADAGEN_NOINLINE void sweep_rows(Workspace& w, const std::array<SweptRow<kWidth<T>>, rows>& swept,
                                const std::array<Real, numbers>& constants, int gathered,
                                int sums) {
  constexpr int W = kWidth<T>, step = SweptConstant::kAll * W;
  static_assert(numbers == rows * step);
  Real* const memory = w.x.data();
  std::fill(memory + gathered, memory + sums, Real(0));
  SweptSums<T> found{};
  const Real* constant = constants.data();
  T lane{};
  ADAGEN_FOR (k, 0, W) lane[k] = Real(k);
  for (const SweptRow<W>& row : swept) {
    // Beyond the row's lanes are angles of other joints, or none.
    const auto has_joint = lane < Real(row.width);
    const T c = has_joint ? load<T>(w.cosine.data() + row.angle) : T{};
    const T s = has_joint ? load<T>(w.sine.data() + row.angle) : T{};
    sweep_row<floats>(memory, row, c, s, constant, found);
    constant += step;
  }
  memory[sums] = across<W>(found.seen);
  memory[sums + 1] = across<W>(found.rounded);
  memory[sums + 2] = across<W>(found.answer);
}

}  // namespace
