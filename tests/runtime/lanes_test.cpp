// Numbers side by side, and vectors and bodies of them: adagen/kernels/.
#include "adagen/kernels/lanes.hpp"

#include <cmath>

#include "adagen/kernels/algebra.hpp"
#include "adagen/kernels/columns.hpp"
#include "adagen/kernels/quaternions.hpp"
#include "adagen/kernels/scans.hpp"
#include "adagen/kernels/shuffles.hpp"
#include "adagen/registers.hpp"
#include "doctest/doctest.h"
#include "near.hpp"

namespace {

bool near(const Vector<double>& a, const Vector<double>& b, double units = 4) {
  return near(a.x, b.x, units) && near(a.y, b.y, units) && near(a.z, b.z, units);
}

Lanes counted(double first, double step) {
  Lanes x{};
  for (int k = 0; k < kLanes; ++k) x[k] = first + step * k;
  return x;
}

// A rotation about z.
Matrix<double> about_z(double angle) {
  const double c = std::cos(angle), s = std::sin(angle);
  return {{c, -s, 0}, {s, c, 0}, {0, 0, 1}};
}

}  // namespace

// What one register holds, or two or four of 128 bits.
using TwoNumbers = SideBySide<double, 2>::T;
TEST_CASE_TEMPLATE("numbers in several registers are computed with one by one", T, TwoNumbers,
                   Halves<TwoNumbers>, Halves<Halves<TwoNumbers>>, Lanes) {
  constexpr std::size_t count = sizeof(T) / sizeof(double);
  double a[count], b[count], stored[count + 1];
  for (std::size_t k = 0; k < count; ++k)
    a[k] = 1.5 + static_cast<double>(k), b[k] = 2.5 - 0.75 * static_cast<double>(k % 3);
  const T x = from_memory<T>(a), y = from_memory<T>(b), none{};
  const T results[]{x + y, x - y, x * y, x / y, -x, 2 - x, x * 3, 1 / y};
  T sum = x;
  sum += y, sum *= x, sum -= 1;
  const auto less = x < y, same = ~(x == x);
  const T least =
      same_bits<T>((same_bits<BitsOf<T>>(x) & less) | (same_bits<BitsOf<T>>(y) & ~less));
  const T first = from_memory<T, sizeof(double)>(a);
  stored[count] = -1;
  to_memory(sum, stored);
  for (std::size_t k = 0; k < count; ++k) {
    const double expected[]{a[k] + b[k], a[k] - b[k], a[k] * b[k], a[k] / b[k],
                            -a[k],       2 - a[k],    a[k] * 3,    1 / b[k]};
    for (std::size_t i = 0; i < 8; ++i) CHECK(results[i][k] == expected[i]);
    CHECK(stored[k] == (a[k] + b[k]) * a[k] - 1);
    CHECK(least[k] == std::min(a[k], b[k]));
    CHECK(none[k] == 0);
    CHECK(first[k] == (k == 0 ? a[0] : 0));
  }
  CHECK(stored[count] == -1);
  CHECK(any_of(less));
  CHECK(!any_of(same));
}

template <class T, std::size_t... k>
void shuffle_all(std::index_sequence<k...>) {
  constexpr int count = sizeof...(k);
  const T x{static_cast<double>(k)...}, y = x + count;
  const T reversed = shuffled<(count - 1 - static_cast<int>(k))...>(x, y);
  const T behind = shuffled<(static_cast<int>(k) + count / 2 + 1)...>(x, y);
  const T spread = shuffled<(static_cast<int>(k) * 2 * count / (count + 1))...>(x, y);
  const T moved_by_one = moved(x, BitsOf<T>{(static_cast<int>(k) + 1) % count...});
  for (int i = 0; i < count; ++i) {
    CHECK(reversed[i] == count - 1 - i);
    CHECK(behind[i] == i + count / 2 + 1);
    CHECK(spread[i] == i * 2 * count / (count + 1));
    CHECK(moved_by_one[i] == (i + 1) % count);
  }
}
TEST_CASE_TEMPLATE("numbers in several registers change places", T, TwoNumbers, Halves<TwoNumbers>,
                   Halves<Halves<TwoNumbers>>, Lanes) {
  shuffle_all<T>(std::make_index_sequence<sizeof(T) / sizeof(double)>{});
}

TEST_CASE("sines and cosines of all lanes have the last place right, near and far") {
  for (const double angle : {0.0, 1e-9, 0.5, -0.785, 3.14159, -1000.25, 12345.678, 1e6}) {
    Lanes sine, cosine;
    sine_and_cosine(Lanes{} + angle, sine, cosine);
    CHECK(near(sine[0], std::sin(angle), 1));
    CHECK(near(cosine[kLanes - 1], std::cos(angle), 1));
  }
}

TEST_CASE("hyperbolic tangents of all lanes are those of the C library") {
  for (const double x : {-1e300, -30.0, -1.5, -0.6, 0.0, 1e-12, 0.3, 0.7, 5.0, 19.99}) {
    Lanes all = Lanes{} + 0.1;
    all[kLanes - 1] = x;
    const Lanes found = hyperbolic_tangent(all);
    CHECK(near(found[0], std::tanh(0.1), 1));
    CHECK(near(found[kLanes - 1], std::tanh(x), 1));
  }
}

TEST_CASE("a square of lanes is transposed") {
  Lanes square[kLanes];
  for (int k = 0; k < kLanes; ++k) square[k] = counted(10 * k, 1);
  transpose(square);
  for (int k = 0; k < kLanes; ++k)
    for (int i = 0; i < kLanes; ++i) CHECK(square[k][i] == 10 * i + k);
  CHECK(any_of(square[0] == square[0]));
  CHECK(!any_of(square[0] != square[0]));
}

TEST_CASE("not a number is neither positive nor zero in any lane") {
  Lanes x = counted(1, 1);
  CHECK(all_positive(x));
  x[kLanes - 1] = NAN;
  CHECK(!all_positive(x));
  CHECK(!all_zero(x));
  CHECK(all_zero(Lanes{}));
}

TEST_CASE("rotations of quaternions of any length are orthogonal") {
  Matrix<double> R;
  const Vector<double> a{1, 2, 3};
  CHECK(near(rotation(0.2, -0.4, 0.6, 0.8, R), 1.2));
  CHECK(near(transposed_times(R, R * a), a));
  CHECK(near(cross(R.x, R.y), R.z));
  // Half a turn about z.
  rotation(0.0, 0.0, 3.0, 0.0, R);
  CHECK(near(R * a, {-1, -2, 3}));
}

TEST_CASE("cross products are at right angles to both") {
  const Vector<double> a{1, 2, 3}, b{-2, 0.5, 4};
  CHECK(near(cross(a, b), {6.5, -10, 4.5}));
  CHECK(near(dot(cross(a, b), a), 0));
}

TEST_CASE("a body told about another point has the same energy, and takes the same power") {
  Body<double> X{{3, 0.1, 0.2, 2, 0.3, 4},
                 {{0, -0.5, 0.25}, {0.5, 0, -1}, {-0.25, 1, 0}},
                 {2, 0, 0, 2, 0, 2},
                 {1, 2, 3},
                 {4, 5, 6}};
  const Vector<double> r{0.3, -0.7, 0.2};
  Motion<double> here{{1, -2, 0.5}, {0.25, 3, -1}};
  const auto energy = [](const Body<double>& Y, const Motion<double>& v) {
    return dot(v.angular, Y.A * v.angular) + 2 * dot(v.angular, Y.B * v.linear) +
           dot(v.linear, Y.C * v.linear);
  };
  const auto power = [](const Body<double>& Y, const Motion<double>& v) {
    return dot(Y.n, v.angular) + dot(Y.f, v.linear);
  };
  const double whole = energy(X, here), taken = power(X, here);
  shift(X, r);
  carry(here, -r);  // told about the point at -r
  CHECK(near(energy(X, here), whole, 32));
  CHECK(near(power(X, here), taken, 32));
}

TEST_CASE("a point mass is shifted as any body is, and by Steiner's theorem") {
  const Vector<double> r{0.3, -0.7, 0.2};
  Body<double> mass{{}, {}, {2, 0, 0, 2, 0, 2}, {}, {1, 0, 0}}, same = mass;
  shift(mass, r), shift_mass(same, r);
  CHECK(near(mass.A.xy, same.A.xy));
  CHECK(near(mass.A.zz, same.A.zz));
  CHECK(near(mass.n, same.n));
  CHECK(near(mass.B.x, same.B.x));
  CHECK(near(mass.B.y, same.B.y));
  CHECK(near(mass.B.z, same.B.z));
  CHECK(near(mass.A.zz, 2 * (0.3 * 0.3 + 0.7 * 0.7)));
  CHECK(near(mass.A.xy, 2 * 0.3 * 0.7));
}

TEST_CASE("sums over the lanes before each begin with what comes before all") {
  Vector<double> start{100, 0, -1};
  const Vector<Lanes> x{counted(1, 1), counted(0, 0.5), Lanes{}};
  const Vector<Lanes> sums = sums_before(x, start);
  double sum = 100;
  for (int k = 0; k < kLanes; ++k) {
    CHECK(near(sums.x[k], sum));
    CHECK(near(sums.y[k], 0.25 * k * (k - 1)));
    CHECK(sums.z[k] == -1);
    sum += 1 + k;
  }
  CHECK(near(start.x, sum));
}

TEST_CASE("rotations of the lanes before each are multiplied in order") {
  Matrix<double> start = about_z(0.25);
  Matrix<Lanes> turns{};
  for (int k = 0; k < kLanes; ++k) {
    const Matrix<double> R = about_z(0.125 * (k + 1));
    turns.x.x[k] = R.x.x, turns.x.y[k] = R.x.y, turns.x.z[k] = 0;
    turns.y.x[k] = R.y.x, turns.y.y[k] = R.y.y, turns.y.z[k] = 0;
    turns.z.x[k] = 0, turns.z.y[k] = 0, turns.z.z[k] = 1;
  }
  const Matrix<Lanes> products = products_before(turns, start);
  double angle = 0.25;
  for (int k = 0; k < kLanes; ++k) {
    CHECK(near(products.y.x[k], std::sin(angle), 16));
    CHECK(near(products.x.x[k], std::cos(angle), 16));
    angle += 0.125 * (k + 1);
  }
  CHECK(near(start.y.x, std::sin(angle), 16));
}
