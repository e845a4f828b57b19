// adagen's runtime, the same for all robots.
#pragma once

#include <algorithm>
#include <array>
#include <type_traits>

#include "failures.hpp"
#include "sample/apply.hpp"
#include "sample/robot.hpp"
#include "sample/workspace.hpp"
#include "sizes.hpp"
#include "status.hpp"

namespace {

// Run-time parameters are sent to other processes with each state.
template <class T>
Number number_of(const T& parameter) {
  if constexpr (std::is_same_v<T, Number>)
    return parameter;
  else
    return parameter[0];  // the same in all lanes
}
inline Number* pack_parameters(Number* to, const Workspace& w) {
  for (const auto& parameter : w.parameters) *to++ = number_of(parameter);
  return to;
}
inline const Number* unpack_parameters(const Number* from, Workspace& w) {
  for (auto& parameter : w.parameters) parameter = std::decay_t<decltype(parameter)>{} + *from++;
  apply_parameters(w);
  return from;
}
[[maybe_unused]] inline void copy_parameters(const Workspace& from, Workspace& to) {
  to.parameters = from.parameters;
  apply_parameters(to);
}

// Sets count numbers from the one numbered first on, if they are finite; returns a status.
template <class AnySolver>
int set_parameters(AnySolver& solver, int first, int count, const Number* x) {
  Number sum = 0;
  for (int k = 0; k < count; ++k) sum += x[k] - x[k];
  if (!(sum == 0)) {
    solver.text = describe(failure(kNotSet, 0));
    return failure(kNotSet, 0);
  }
  std::array<Number, kParameterCount> numbers{};
  pack_parameters(numbers.data(), solver.workspace(0));
  std::copy_n(x, count, numbers.begin() + first);
  for (int k = 0; k < AnySolver::kWorkspaces; ++k)
    unpack_parameters(numbers.data(), solver.workspace(k));
  return kFine;
}

}  // namespace
