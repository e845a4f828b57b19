// adagen's runtime, the same for all robots.
#pragma once

#include <array>
#include <cstddef>

#include "constants.hpp"
#include "failures.hpp"
#include "sample/parameters.hpp"
#include "sample/robot.hpp"
#include "sizes.hpp"
#include "status.hpp"

namespace {

// Sets a link's mass, or its centre, if that can be; returns a status.
template <class AnySolver>
int refuse(AnySolver& solver) {
  solver.text = describe(failure(kNotSet, 0));
  return failure(kNotSet, 0);
}
inline const SettableLink* settable(int link) {
  const auto count = static_cast<int>(kSettableLinks.size());
  return link < 0 || link >= count ? nullptr : &kSettableLinks[static_cast<std::size_t>(link)];
}
template <class AnySolver>
int set_mass(AnySolver& solver, int link, Number mass) {
  const SettableLink* const own = settable(link);
  if (own == nullptr || own->mass < 0 || !(mass > 0)) return refuse(solver);
  return set_parameters(solver, own->mass, 1, &mass);
}
template <class AnySolver>
int set_center(AnySolver& solver, int link, const Number* center) {
  const SettableLink* const own = settable(link);
  if (own == nullptr || own->center < 0) return refuse(solver);
  std::array<Number, 3> turned{};
  for (std::size_t k = 0; k < 9; ++k)
    turned[k / 3] += static_cast<Number>(own->axes[k]) * center[k % 3];
  return set_parameters(solver, own->center, 3, turned.data());
}

}  // namespace
