// adagen's runtime, the same for all robots.
#pragma once
#if !defined(ADAGEN_SOLVER)
#define ADAGEN_BATCH  // read alone, it is of a solver for batches
#endif

#include <algorithm>
#include <array>
#include <cstddef>
#include <limits>

#include "sample/processes.hpp"
#include "sample/workspace.hpp"
#include "sizes.hpp"
#include "value.hpp"

namespace {

// States that are solved together: as many as there are lanes, one in each, or one by itself.
constexpr int kTogether = static_cast<int>(sizeof(Value) / sizeof(Real));

// Accelerations that nobody has computed, or asked for, are not numbers.
inline std::array<Value, kNqdd> no_accelerations() {
  std::array<Value, kNqdd> none;
  none.fill(Value{} + std::numeric_limits<Real>::quiet_NaN());
  return none;
}

// These, and what they are solved with.
struct Group {
  Workspace w;
  std::array<Value, kNq> q{};
  std::array<Value, kNv> v{};
  std::array<Value, kNqdd> qdd = no_accelerations();
  std::array<Value, kNtau> tau{};
};

// Groups that go through each part before the next one, so that its instructions are fetched once
// for all: as many as fill a quarter of the second-level cache, or many where not even the code
// fits. One in registers of 512 bits where all instructions fit the first-level cache, as those of
// four functions and the two around them do: what a group holds then stays in that of data. In
// narrower registers a group holds less, and is fewer states to fetch instructions for: one only
// where a single function, a loop, does it all.
constexpr int kGroups = [] {
  constexpr std::size_t kHalf = Settings::kCache / 2, kCodeOfPart = 8 << 10, kMost = 8;
  constexpr std::size_t kCode = kParts.size() * kCodeOfPart, kFew = kLaneBytes == 64 ? 6 : 1;
  if (kParts.size() <= kFew) return 1;
  if (kCode + sizeof(Group) > kHalf) return static_cast<int>(kMost);
  return static_cast<int>(std::clamp<std::size_t>(kHalf / 2 / sizeof(Group), 1, kMost));
}();

}  // namespace
