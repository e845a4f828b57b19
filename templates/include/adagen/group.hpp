// adagen's runtime, the same for all robots.
#pragma once
#if !defined(ADAGEN_SOLVER)
#define ADAGEN_BATCH  // read alone, it is of a solver for batches
#endif

#include <algorithm>
#include <array>
#include <cstddef>
#include <type_traits>

#include "common.hpp"
#include "kernels/lanes.hpp"
#include "kernels/shuffles.hpp"
#include "sample/processes.hpp"
#include "sample/workspace.hpp"
#include "sizes.hpp"
#include "value.hpp"

namespace {

// As many states as there are lanes, one in each, and what they are solved with.
struct Group {
  Workspace w;
  std::array<Value, kNq> q{};
  std::array<Value, kNv> v{};
  std::array<Value, kNqdd> qdd{};
  std::array<Value, kNtau> tau{};
};

// Groups that go through each part before the next one, so that its instructions are fetched once
// for all: as many as fill half of the second-level cache, or many where not even the code fits.
constexpr int kGroups = [] {
  constexpr std::size_t kCache = 1 << 20, kCodeOfPart = 8 << 10, kMost = 8;
  constexpr std::size_t kCode = kParts.size() * kCodeOfPart;
  if (kParts.size() == 1) return 1;
  if (kCode + sizeof(Group) > kCache) return static_cast<int>(kMost);
  return static_cast<int>(std::clamp<std::size_t>(kCache / 2 / sizeof(Group), 1, kMost));
}();

// Rows of numbers, one for each state, become lanes; lanes without a state repeat the last one.
template <std::size_t width>
void to_lanes(int states, const Number* rows, std::array<Value, width>& lanes) {
  static_assert(std::is_same_v<Number, Real>);
  constexpr std::size_t kSquare = static_cast<std::size_t>(kLanes);
  if constexpr (width >= kSquare) {
    for (std::size_t k = 0; k < width && states == kLanes; k += kSquare) {
      const std::size_t first = std::min(k, width - kSquare);  // the last ones overlap
      Lanes square[kLanes];
      ADAGEN_FOR (s, 0, kLanes) load(rows + static_cast<std::size_t>(s) * width + first, square[s]);
      transpose(square);
      ADAGEN_FOR (s, 0, kLanes) lanes[first + static_cast<std::size_t>(s)] = square[s];
    }
    if (states == kLanes) return;
  }
  for (std::size_t k = 0; k < width; ++k)
    ADAGEN_FOR (s, 0, kLanes)
      lanes[k][s] = rows[static_cast<std::size_t>(std::min(s, states - 1)) * width + k];
}

// Lanes become rows of numbers.
template <std::size_t width>
void to_rows(int states, const std::array<Value, width>& lanes, Number* rows) {
  constexpr std::size_t kSquare = static_cast<std::size_t>(kLanes);
  if constexpr (width >= kSquare) {
    for (std::size_t k = 0; k < width && states == kLanes; k += kSquare) {
      const std::size_t first = std::min(k, width - kSquare);
      Lanes square[kLanes];
      ADAGEN_FOR (s, 0, kLanes) square[s] = lanes[first + static_cast<std::size_t>(s)];
      transpose(square);
      ADAGEN_FOR (s, 0, kLanes)
        store(square[s], rows + static_cast<std::size_t>(s) * width + first);
    }
    if (states == kLanes) return;
  }
  for (int s = 0; s < states; ++s)
    for (std::size_t k = 0; k < width; ++k) *rows++ = lanes[k][s];
}

}  // namespace
