// adagen's runtime, the same for all robots.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstring>

#include "common.hpp"
#include "kernels/lanes.hpp"
#include "kernels/shuffles.hpp"
#include "sizes.hpp"
#include "value.hpp"

namespace {

// Numbers in a row of the squares that rows of so many numbers are taken in.
constexpr int side_of_squares(std::size_t width) {
  int side = kLanes;
  while (static_cast<std::size_t>(side) > width) side /= 2;
  return side;
}

// Does something for squares that cover all lanes and so many columns, several in a register: with
// their first column. The last columns overlap with those before.
template <int side, std::size_t width, class Do>
ADAGEN_INLINE void for_squares(const Do& square) {
  constexpr std::size_t kSide = static_cast<std::size_t>(side);
  for (std::size_t k = 0; k < width; k += kSide) square(std::min(k, width - kSide));
}

// Rows of numbers, one for each state, become lanes; lanes without a state repeat the last one.
template <std::size_t width>
void to_lanes(int states, const Real* rows, std::array<Lanes, width>& lanes) {
  constexpr int side = side_of_squares(width);
  if constexpr (side > 1) {
    if (states == kLanes)
      return for_squares<side, width>([&](std::size_t k) ADAGEN_ALWAYS {
        Lanes columns[side];
        ADAGEN_FOR (j, 0, side)
          columns[j] =
              collected<side, kLanes>(rows + static_cast<std::size_t>(j) * width + k, side * width);
        transpose(columns);
        ADAGEN_FOR (j, 0, side) lanes[k + static_cast<std::size_t>(j)] = columns[j];
      });
  }
  for (std::size_t k = 0; k < width; ++k)
    ADAGEN_FOR (s, 0, kLanes)
      lanes[k][s] = rows[static_cast<std::size_t>(std::min(s, states - 1)) * width + k];
}

// One state, which is solved by itself.
template <std::size_t width>
void to_lanes(int, const Real* row, std::array<Real, width>& numbers) {
  std::copy_n(row, width, numbers.data());
}
template <std::size_t width>
void to_rows(int, const std::array<Real, width>& numbers, Real* row) {
  std::copy_n(numbers.data(), width, row);
}

// Lanes become rows of numbers.
template <std::size_t width>
void to_rows(int states, const std::array<Lanes, width>& lanes, Real* rows) {
  constexpr int side = side_of_squares(width);
  if constexpr (side > 1) {
    if (states == kLanes)
      return for_squares<side, width>([&](std::size_t k) ADAGEN_ALWAYS {
        Lanes columns[side];
        ADAGEN_FOR (j, 0, side) columns[j] = lanes[k + static_cast<std::size_t>(j)];
        transpose(columns);
        ADAGEN_FOR (j, 0, side)
          scatter<side, kLanes>(columns[j], rows + static_cast<std::size_t>(j) * width + k,
                                side * width);
      });
  }
  for (int s = 0; s < states; ++s)
    for (std::size_t k = 0; k < width; ++k) *rows++ = lanes[k][s];
}

}  // namespace
