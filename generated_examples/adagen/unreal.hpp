// adagen's runtime, the same for all robots.
#pragma once

#include <string>

#include "inverse_dynamics.hpp"
#include "json.hpp"
#include "program_setting.hpp"

namespace adagen {
namespace {

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

}  // namespace
}  // namespace adagen
