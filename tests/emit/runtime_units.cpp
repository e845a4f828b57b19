// What headers of the runtime compute, each taken by itself: the sizes are those of adagen/sample/.
#include <array>
#include <cmath>
#include <cstdio>
#include <cstring>
#include <string>

#include "adagen/failures.hpp"
#include "adagen/kernels/algebra.hpp"
#include "adagen/kernels/lanes.hpp"
#include "adagen/kernels/shuffles.hpp"
#include "adagen/parameters.hpp"
#include "adagen/slave.hpp"
#include "adagen/status.hpp"
#include "adagen/tanh_own.hpp"

namespace {

int wrong = 0;

void expect(bool good, const char* what) {
  if (good) return;
  ++wrong;
  std::printf("wrong: %s\n", what);
}
#define EXPECT(what) expect(what, #what)

bool near(double a, double b, double units = 4) {
  return std::abs(a - b) <= units * 2.3e-16 * std::fmax(1, std::fmax(std::abs(a), std::abs(b)));
}
bool near(const Vector<double>& a, const Vector<double>& b) {
  return near(a.x, b.x) && near(a.y, b.y) && near(a.z, b.z);
}

void statuses() {
  const int status = failure(kOverflow, 2);
  EXPECT(failure_kind(status) == kOverflow && failure_place(status) == 2);
  EXPECT(static_cast<int>(static_cast<float>(failure(kNotSet, 1000))) == failure(kNotSet, 1000));
  EXPECT(std::string(describe(status).c_str()) ==
         "joint \"wrist\": its acceleration is not a finite number (overflow)");
  EXPECT(std::string(describe(failure(kNoAnswer, 3)).c_str()) ==
         "process 3 did not answer within the time limit");
}

void texts() {
  Text text;
  EXPECT(text.empty());
  (text += "a") += -107;
  EXPECT(std::string(text.c_str()) == "a-107");
  text.clear();
  add_quoted(text, "a\"\n");
  EXPECT(std::string(text.c_str()) == "\"a\\\"\\u000a\"");
  for (std::size_t k = 0; k < 2 * kTextSize; ++k) text += 'x';
  EXPECT(std::strlen(text.c_str()) == kTextSize - 1);
}

void vectors() {
  const Vector<double> a{1, 2, 3}, b{-2, 0.5, 4};
  EXPECT(near(cross(a, b), {6.5, -10, 4.5}));
  EXPECT(near(dot(cross(a, b), a), 0));
  Matrix<double> R;
  EXPECT(near(rotation(0.2, -0.4, 0.6, 0.8, R), 1.2));
  EXPECT(near(transposed_times(R, R * a), a));
  EXPECT(near(cross(R.x, R.y), R.z));
}

// A body told about another point has the same energy and takes the same power.
void bodies() {
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
  EXPECT(near(energy(X, here), whole, 32));
  EXPECT(near(power(X, here), taken, 32));
  Body<double> mass{{}, {}, {2, 0, 0, 2, 0, 2}, {}, {1, 0, 0}}, same = mass;
  shift(mass, r), shift_mass(same, r);
  EXPECT(near(mass.A.xy, same.A.xy) && near(mass.A.zz, same.A.zz) && near(mass.n, same.n));
  EXPECT(near(mass.B.x, same.B.x) && near(mass.B.y, same.B.y) && near(mass.B.z, same.B.z));
}

void lanes() {
  const double angles[] = {0, 1e-9, 0.5, -0.785, 3.14159, -1000.25, 12345.678, 1e6};
  for (const double angle : angles) {
    Lanes sine, cosine;
    sine_and_cosine(Lanes{} + angle, sine, cosine);
    EXPECT(near(sine[0], std::sin(angle), 1) && near(cosine[kLanes - 1], std::cos(angle), 1));
  }
  Lanes square[kLanes];
  for (int k = 0; k < kLanes; ++k)
    for (int i = 0; i < kLanes; ++i) square[k][i] = 10 * k + i;
  transpose(square);
  for (int k = 0; k < kLanes; ++k)
    for (int i = 0; i < kLanes; ++i) EXPECT(square[k][i] == 10 * i + k);
  EXPECT(any_of(square[0] == square[0]) && !any_of(square[0] != square[0]));
}

void tangents() {
  for (const double x : {-30.0, -1.5, -0.6, 0.0, 1e-12, 0.3, 0.7, 5.0})
    EXPECT(near(tanh_of(x), std::tanh(x), 1));
}

void slaved() {
  std::array<double, kNq> q{};
  std::array<double, kNv> v{};
  q[7] = 0.5, v[6] = -3, v[7] = 100;  // the elbow, and a wrist that is to follow it twice as far
  slave(kJoints, q.data(), v.data());
  EXPECT(q[8] == 1 && v[7] == -6);
}

// A solver as parameters.hpp sees it.
struct Set {
  static constexpr int kWorkspaces = 1;
  Workspace w;
  Text text;
  Workspace& workspace(int) { return w; }
};

void parameters() {
  static Set solver;
  const double gravity[3] = {1, 2, 3}, none[3] = {0, NAN, 0};
  EXPECT(set_parameters(solver, 0, 3, gravity) == kFine);
  EXPECT(solver.w.parameters[1] == 2 && solver.w.parameters[3] == kParameters[3]);
  EXPECT(failure_kind(set_parameters(solver, 0, 3, none)) == kNotSet && !solver.text.empty());
  EXPECT(solver.w.parameters[1] == 2);
  const double mass = 7;
  EXPECT(set_parameters(solver, 3, 1, &mass) == kFine);
  EXPECT(solver.w.inertia_of(kSettableLinks[0].link - 1).mass == 7);
}

}  // namespace

int main() {
  statuses(), texts(), vectors(), bodies(), lanes(), tangents(), slaved(), parameters();
  if (wrong == 0) std::printf("right\n");
  return wrong == 0 ? 0 : 1;
}
