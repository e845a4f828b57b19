// Statuses, texts, constants set at run time, joints that follow others: adagen/*.hpp for all
// shapes.
#include <array>
#include <cmath>
#include <cstddef>
#include <cstring>
#include <limits>
#include <string>

#include "adagen/error_bound.hpp"
#include "adagen/failures.hpp"
#include "adagen/parameters.hpp"
#include "adagen/set_links.hpp"
#include "adagen/slave.hpp"
#include "adagen/status.hpp"
#include "adagen/tangents.hpp"
#include "doctest/doctest.h"
#include "near.hpp"

TEST_CASE("a status holds a reason and a place, in a float, too") {
  const int status = failure(kOverflow, 2);
  CHECK(failure_kind(status) == kOverflow);
  CHECK(failure_place(status) == 2);
  CHECK(static_cast<int>(static_cast<float>(failure(kNotSet, 1000))) == failure(kNotSet, 1000));
}

TEST_CASE("statuses are told with the names of joints") {
  CHECK(std::string(describe(failure(kOverflow, 2)).c_str()) ==
        "joint \"wrist\": its acceleration is not a finite number (overflow)");
  CHECK(std::string(describe(failure(kNoAnswer, 3)).c_str()) ==
        "process 3 did not answer within the time limit");
}

TEST_CASE("texts have room for so much, and no more") {
  Text text;
  CHECK(text.empty());
  (text += "a") += -107;
  CHECK(std::string(text.c_str()) == "a-107");
  text.clear();
  add_quoted(text, "a\"\n");
  CHECK(std::string(text.c_str()) == "\"a\\\"\\u000a\"");
  for (std::size_t k = 0; k < 2 * kTextSize; ++k) text += 'x';
  CHECK(std::strlen(text.c_str()) == kTextSize - 1);
}

TEST_CASE("hyperbolic tangents of our own are those of the C library") {
  for (const double x : {-30.0, -1.5, -0.6, 0.0, 1e-12, 0.3, 0.7, 5.0})
    CHECK(near(hyperbolic_tangent(x), std::tanh(x), 1));
}

TEST_CASE("a joint that follows another takes its coordinate and its velocity") {
  std::array<double, kNq> q{};
  std::array<double, kNv> v{};
  q[7] = 0.5, v[6] = -3, v[7] = 100;  // the elbow, and a wrist that is to follow it twice as far
  slave(kJoints, q.data(), v.data());
  CHECK(q[8] == 1);
  CHECK(v[7] == -6);
}

namespace {

// A solver as parameters.hpp sees it.
struct Set {
  static constexpr int kWorkspaces = 1;
  Workspace w;
  Text text;
  Workspace& workspace(int) { return w; }
};

}  // namespace

TEST_CASE("what is set at run time is set as a whole, or not at all") {
  static Set solver;
  const double gravity[3] = {1, 2, 3}, none[3] = {0, std::numeric_limits<double>::quiet_NaN(), 0};
  CHECK(set_parameters(solver, 0, 3, gravity) == kFine);
  CHECK(solver.w.parameters[1] == 2);
  CHECK(solver.w.parameters[3] == kParameters[3]);
  CHECK(failure_kind(set_parameters(solver, 0, 3, none)) == kNotSet);
  CHECK(!solver.text.empty());
  CHECK(solver.w.parameters[1] == 2);
}

TEST_CASE("masses are set for links that were named, and must be more than zero") {
  static Set solver;
  CHECK(set_mass(solver, 0, 7) == kFine);
  CHECK(solver.w.inertia_of(kSettableLinks[0].link - 1).mass == 7);
  for (const double mass : {0.0, -1.0, std::numeric_limits<double>::quiet_NaN()})
    CHECK(failure_kind(set_mass(solver, 0, mass)) == kNotSet);
  CHECK(failure_kind(set_mass(solver, 1, 7)) == kNotSet);
  CHECK(failure_kind(set_center(solver, 0, kParameters.data())) ==
        kNotSet);  // only its mass can be set
  CHECK(solver.w.inertia_of(kSettableLinks[0].link - 1).mass == 7);
}

TEST_CASE("a bound of an error is that of its norm beside the answer's") {
  CHECK(bound_of(4e-20, 1e-4) == doctest::Approx(2e-8).epsilon(1e-14));
  CHECK(bound_of(0, 1) == 0);
  CHECK(std::isinf(bound_of(1e-20, 0)));
  CHECK(std::isinf(bound_of(0, 0)));
  CHECK(bound_of(1.0, 64.0 * 64.0) == 1.0 / 64);
  CHECK(std::isinf(bound_of(1.0, 4000)));
}
