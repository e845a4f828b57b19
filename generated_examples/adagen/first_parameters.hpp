// adagen's runtime, the same for all robots.
#pragma once

#include <array>
#include <cstddef>

#include "sample/robot.hpp"
#include "sizes.hpp"

namespace {

// Initial values of run-time parameters. T: the type for computing.
template <class T>
std::array<T, kParameterCount> first_parameters() {
  std::array<T, kParameterCount> result{};
  for (std::size_t k = 0; k < result.size(); ++k) result[k] += static_cast<Number>(kParameters[k]);
  return result;
}

}  // namespace
