// adagen's runtime, the same for all robots.
#pragma once

#include <limits>

#include "error_bound.hpp"

namespace {

// The bound of the error of one of the states of a group; infinite where answers are not certified.
template <class G>
auto bound_of_state(const G& group, int state, int)
    -> decltype(bound_of(group.w.certificate[0][state], group.w.certificate[1][state])) {
  const auto& squares = group.w.certificate;
  return bound_of(static_cast<double>(squares[0][state]), static_cast<double>(squares[1][state]));
}
template <class G>
double bound_of_state(const G&, int, long) {
  return std::numeric_limits<double>::infinity();
}

}  // namespace
