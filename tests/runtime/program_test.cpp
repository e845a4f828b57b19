// The program around solvers: its own inverse dynamics, integrators, loops, JSON.
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include "adagen/integrators.hpp"
#include "adagen/inverse_dynamics.hpp"
#include "adagen/json.hpp"
#include "adagen/loops.hpp"
#include "adagen/manifold.hpp"
#include "adagen/statistics.hpp"
#include "adagen/topology.hpp"
#include "doctest/doctest.h"
#include "near.hpp"

namespace {

using adagen::about;
using adagen::JointKind;
using State = adagen::manifold::State;

constexpr double kOne[9]{1, 0, 0, 0, 1, 0, 0, 0, 1}, kHere[3]{};

adagen::Joint<double> hinge(const char* name, int number, const double* place) {
  adagen::Joint<double> joint{};
  joint.name = name, joint.kind = JointKind::kRevolute;
  joint.parent = number, joint.q = joint.v = number, joint.nq = joint.nv = 1;
  joint.rotation = kOne, joint.translation = place;
  joint.source = -1, joint.friction_speed = 1, joint.given = true;
  return joint;
}

// Two rods that swing in the plane x y; gravity along x, so that they hang at q = 0.
constexpr double kMass1 = 1.5, kMass2 = 0.7, kLength1 = 0.8, kCom1 = 0.5, kCom2 = 0.3;
constexpr double kInertia1 = 0.04, kInertia2 = 0.01, kGravity = 9.81;

struct Pendulum {
  double elbow[3]{kLength1, 0, 0}, com1[3]{kCom1, 0, 0}, com2[3]{kCom2, 0, 0};
  double tensor1[9]{0, 0, 0, 0, kInertia1, 0, 0, 0, kInertia1};
  double tensor2[9]{0, 0, 0, 0, kInertia2, 0, 0, 0, kInertia2};
  double gravity[3]{kGravity, 0, 0};
  std::array<adagen::Joint<double>, 2> joints{hinge("shoulder", 0, kHere),
                                              hinge("elbow", 1, elbow)};
  std::array<adagen::Link<double>, 3> links{
      {{0, kHere, kOne}, {kMass1, com1, tensor1}, {kMass2, com2, tensor2}}};

  Pendulum() {
    about = {};
    about.robot = "pendulum";
    about.nq = about.nv = about.nqdd = about.ntau = 2;
    about.gravity = gravity;
    about.joints = {joints.data(), 2};
    about.links = {links.data(), 3};
  }
  Pendulum(const Pendulum&) = delete;
  Pendulum& operator=(const Pendulum&) = delete;
};

// Torques by Lagrange's equations.
std::array<double, 2> torques(const double* q, const double* v, const double* a) {
  const double h = kMass2 * kLength1 * kCom2;
  const double H22 = kInertia2 + kMass2 * kCom2 * kCom2;
  const double H12 = H22 + h * std::cos(q[1]);
  const double H11 = kInertia1 + kMass1 * kCom1 * kCom1 + kMass2 * kLength1 * kLength1 + H22 +
                     2 * h * std::cos(q[1]);
  const double s = h * std::sin(q[1]);
  const double g2 = kMass2 * kCom2 * kGravity * std::sin(q[0] + q[1]);
  const double g1 = (kMass1 * kCom1 + kMass2 * kLength1) * kGravity * std::sin(q[0]) + g2;
  return {H11 * a[0] + H12 * a[1] - s * (2 * v[0] * v[1] + v[1] * v[1]) + g1,
          H12 * a[0] + H22 * a[1] + s * v[0] * v[0] + g2};
}

double energy(const double* q, const double* v) {
  const std::array<double, 2> none{}, p = torques(q, std::array<double, 2>{}.data(), v);
  const std::array<double, 2> rest = torques(q, none.data(), none.data());
  const double kinetic = ((p[0] - rest[0]) * v[0] + (p[1] - rest[1]) * v[1]) / 2;
  return kinetic - kGravity * ((kMass1 * kCom1 + kMass2 * kLength1) * std::cos(q[0]) +
                               kMass2 * kCom2 * std::cos(q[0] + q[1]));
}

// Accelerations of the free pendulum: Cramer's rule.
int accelerate(const State& at, const State& moving, const State&, State& a) {
  const double *q = at.data(), *v = moving.data();
  const double none[2]{}, e1[2]{1, 0}, e2[2]{0, 1};
  const auto c = torques(q, v, none), rest = torques(q, none, none);
  const auto h1 = torques(q, none, e1), h2 = torques(q, none, e2);
  const double H11 = h1[0] - rest[0], H12 = h1[1] - rest[1], H22 = h2[1] - rest[1];
  const double D = H11 * H22 - H12 * H12;
  a[0] = (-c[0] * H22 + c[1] * H12) / D;
  a[1] = (-c[1] * H11 + c[0] * H12) / D;
  return 0;
}

}  // namespace

TEST_CASE("inverse dynamics are Lagrange's of a double pendulum") {
  static const Pendulum pendulum;
  for (int round = 0; round < 20; ++round) {
    const double k = round;
    const double q[2]{std::sin(k), 3 * std::cos(k)}, v[2]{2 * std::cos(3 * k), -k / 4};
    const double a[2]{5 - k, std::sin(7 * k)}, tau[2]{};
    std::vector<adagen::check::Row> rows(2);
    adagen::check::inverse_dynamics(q, v, a, tau + 2, rows);
    const auto due = torques(q, v, a);
    for (std::size_t i = 0; i < 2; ++i) {
      CHECK(near(static_cast<double>(rows[i].value), due[i], 16));
      CHECK(std::abs(rows[i].value) <= rows[i].size);
    }
  }
}

TEST_CASE("what is left over of right torques is rounding, of wrong ones what is wrong") {
  static const Pendulum pendulum;
  const double q[2]{0.3, -1.2}, v[2]{1, 2}, a[2]{-3, 4};
  auto tau = torques(q, v, a);
  CHECK(adagen::check::left_over(q, v, tau.data(), a).backward < 1e-15);
  tau[1] += 0.01;
  const auto left = adagen::check::left_over(q, v, tau.data(), a);
  CHECK(left.joint == 1);
  CHECK(static_cast<double>(left.over[1]) == doctest::Approx(-0.01));
}

TEST_CASE("a light body that falls freely far from the base turns by no more than rounding") {
  const double far[3]{0, 3, 0}, gravity[3]{0, 0, -kGravity};
  const double ball[9]{1e-6, 0, 0, 0, 1e-6, 0, 0, 0, 1e-6};
  adagen::Joint<double> free = hinge("free", 0, far);
  free.kind = JointKind::kFloating, free.nq = 7, free.nv = 6;
  const std::array<adagen::Link<double>, 2> links{{{0, kHere, kOne}, {0.01, kHere, ball}}};
  about = {};
  about.robot = "body";
  about.nq = 7, about.nv = about.nqdd = about.ntau = 6;
  about.gravity = gravity;
  about.joints = {&free, 1};
  about.links = {links.data(), 2};
  const double q[7]{0, 0, 0, 0, 0, 0, 1};
  const std::vector<double> none(6);
  const auto backward = [&](double spin_rate) {
    const double falls[6]{0, 0, -kGravity, 0, spin_rate, 0};  // m/s^2, rad/s^2
    std::vector<adagen::check::Row> rows(6);
    adagen::check::inverse_dynamics(q, none.data(), falls, none.data() + 6, rows);
    return adagen::check::part_of(rows[4].value, rows[4].size, rows[4].about_base);
  };
  CHECK(backward(2e-12) < 1e-15);
  CHECK(backward(1e-6) > 0.5);
}

TEST_CASE("rows are solved by elimination; singular ones are not") {
  const auto x = adagen::check::solved({{0, 2, 4}, {3, 1, 11}});
  REQUIRE(x.size() == 2);
  CHECK(near(static_cast<double>(x[0]), 3));
  CHECK(near(static_cast<double>(x[1]), 2));
  CHECK(adagen::check::solved({{1, 2, 3}, {2, 4, 6}}).empty());
}

TEST_CASE("integrators keep the energy of a pendulum to their order") {
  static const Pendulum pendulum;
  const auto lost = [](adagen::Integrator kind, double h) {
    adagen::Stepper stepper;
    State q{1, 0.5}, v{0, -1};
    const double before = energy(q.data(), v.data());
    for (int k = 0; k < static_cast<int>(std::lround(0.5 / h)); ++k)
      stepper.step(kind, h, q, v, accelerate);
    return std::abs(energy(q.data(), v.data()) - before);
  };
  using adagen::Integrator;
  for (const Integrator kind : {Integrator::kRk4, Integrator::kRkmk4}) {
    CHECK(lost(kind, 1e-3) < 1e-9);
    CHECK(lost(kind, 1e-2) / lost(kind, 5e-3) > 12);  // of fourth order: 16, and more
  }
  for (const Integrator kind : {Integrator::kEuler, Integrator::kSemiImplicit}) {
    CHECK(lost(kind, 1e-3) < 0.1);
    CHECK(lost(kind, 1e-2) / lost(kind, 5e-3) > 1.5);
  }
}

TEST_CASE("a body that turns about one axis comes round, and its quaternion stays one") {
  static adagen::Joint<double> ball = hinge("ball", 0, kHere);
  ball.kind = JointKind::kSpherical, ball.nq = 4, ball.nv = 3;
  about = {};
  about.joints = {&ball, 1};
  about.nq = 4, about.nv = 3;
  State q{0, 0, 0, 1}, to(4);
  const double pi = std::acos(-1.0);
  adagen::manifold::advance(q, {0, pi / 2, 0}, to);  // a quarter about y
  CHECK(near(to[1], std::sqrt(0.5)));
  CHECK(near(to[3], std::sqrt(0.5)));
  double turned[3];
  const double x_axis[3]{1, 0, 0};
  adagen::manifold::rotate(to.data(), x_axis, turned);
  CHECK(near(turned[2], -1));
  for (int k = 0; k < 8; ++k) adagen::manifold::advance(State(q), {0, pi / 2, 0}, q);
  CHECK(near(q[3], 1, 64));  // twice round
  // The rate of the quaternion is the derivative of moving on.
  State rate(4), later(4);
  const State v{0.3, -0.2, 0.9};
  adagen::manifold::rate(to, v, rate);
  const double h = 1e-6;
  adagen::manifold::advance(to, {h * v[0], h * v[1], h * v[2]}, later);
  for (std::size_t k = 0; k < 4; ++k) CHECK(std::abs((later[k] - to[k]) / h - rate[k]) < 1e-6);
}

TEST_CASE("a loop that is closed has no gap; one that is open, that gap and its rate") {
  static const Pendulum pendulum;
  static const double tip[3]{0.6, 0, 0};
  static const double anchor[3]{kLength1, 0.6,
                                0};  // where the tip is with the elbow at a right angle
  static const adagen::Loop<double> pin{"pin", 0, 2, kOne, anchor, kOne, tip, 7u, 0u, false};
  about.loops = {&pin, 1};
  const double right[2]{0, std::acos(-1.0) / 2}, straight[2]{};
  const auto gaps = [](const double* q) {
    std::vector<double> found;
    for (const auto gap : adagen::loops::constraints(q).gaps)
      found.push_back(static_cast<double>(gap));
    return found;
  };
  for (const double gap : gaps(right)) CHECK(near(gap, 0));
  const auto open = gaps(straight);
  REQUIRE(open.size() == 3);
  CHECK(near(open[0], 0.6));
  CHECK(near(open[1], -0.6));
  // Rows are derivatives of gaps.
  auto rows = adagen::loops::constraints(straight);
  const double h = 1e-6;
  for (int j = 0; j < 2; ++j) {
    double moved[2]{};
    moved[j] = h;
    const auto after = gaps(moved);
    for (int k = 0; k < 3; ++k)
      CHECK(std::abs((after[static_cast<std::size_t>(k)] - open[static_cast<std::size_t>(k)]) / h -
                     static_cast<double>(rows.row(k)[j])) < 1e-5);
  }
}

namespace {

struct Reader : adagen::JsonReader {
  explicit Reader(const std::string& text) : adagen::JsonReader(text) {}
  std::vector<std::pair<std::string, std::vector<double>>> all() {
    std::vector<std::pair<std::string, std::vector<double>>> found;
    object([&](const std::string& key) { found.emplace_back(key, numbers()); });
    return found;
  }
  std::string one_string() { return string(); }
  void any() { skip(); }
};

}  // namespace

TEST_CASE("JSON is read strictly") {
  const auto found = Reader(R"( {"a" : [1, -2.5e3], "b": 7} )").all();
  REQUIRE(found.size() == 2);
  CHECK(found[0].first == "a");
  CHECK(found[0].second == std::vector<double>{1, -2500});
  CHECK(found[1].second == std::vector<double>{7});
  CHECK(Reader(R"("\u00e9\ud83e\udd16\n")").one_string() == "\xC3\xA9\xF0\x9F\xA4\x96\n");
  for (const char* wrong : {"{", "{\"a\":}", "{\"a\":1e999}", "{\"a\":.5}", "{\"a\":NaN}", "[1",
                            "{\"a\":[1,]}", "{\"a\" 1}"})
    CHECK_THROWS_AS(Reader(wrong).all(), std::runtime_error);
  std::string deep(100, '[');
  CHECK_THROWS_AS(Reader(deep).any(), std::runtime_error);
}

TEST_CASE("statistics of times are medians and the like") {
  std::vector<double> ns;
  for (int k = 200; k > 0; --k) ns.push_back(k);
  const auto found = adagen::statistics(ns);
  CHECK(found.median == 101);
  CHECK(found.least == 1);
  CHECK(found.percentile99 == 199);
}

namespace {

// A machine as Linux describes it, in a folder of its own: cores 0..7, two packages, in each two
// cores of two hardware threads; thread k + 4 is the second one of core k. What is not given is
// absent.
class Machine {
 public:
  std::filesystem::path folder;

  Machine() : folder(std::filesystem::temp_directory_path() / "adagen-topology-XXXXXX") {
    std::string name = folder.string();
    REQUIRE(mkdtemp(name.data()) != nullptr);
    folder = name;
  }
  ~Machine() { std::filesystem::remove_all(folder); }
  Machine(const Machine&) = delete;
  Machine& operator=(const Machine&) = delete;

  void tell(int core, const char* what, const std::string& text) const {
    const auto file = folder / ("cpu" + std::to_string(core)) / what;
    std::filesystem::create_directories(file.parent_path());
    std::ofstream(file) << text << '\n';
  }
  std::vector<int> order(const std::vector<int>& cores) const {
    return adagen::in_order_of_caches(cores, folder.string());
  }
};

}  // namespace

TEST_CASE("processes that meet take cores that share caches") {
  const Machine machine;
  CHECK(machine.order({5, 2, 3}) == std::vector<int>{2, 3, 5});  // nothing is known
  for (int core = 0; core < 8; ++core) {
    const int first = core % 4, package = first % 2;  // packages take turns
    machine.tell(core, "topology/thread_siblings_list",
                 std::to_string(first) + "," + std::to_string(first + 4));
    machine.tell(core, "topology/physical_package_id", std::to_string(package));
    machine.tell(core, "cache/index3/shared_cpu_list", std::to_string(package) + "-7");
    machine.tell(core, "cache/index2/shared_cpu_list", std::to_string(first));
  }
  CHECK(machine.order({0, 1, 2, 3, 4, 5, 6, 7}) == std::vector<int>{0, 2, 1, 3, 4, 6, 5, 7});
  CHECK(machine.order({4, 5, 7}) == std::vector<int>{4, 5, 7});  // second threads, but alone
  CHECK(machine.order({}).empty());
}
