// Rows of states, and lanes of a batch, as many as a register of the machine holds:
// adagen/rows.hpp.
#define ADAGEN_BATCH
#include "adagen/rows.hpp"

#include <algorithm>
#include <array>
#include <cstddef>
#include <numeric>
#include <type_traits>
#include <utility>
#include <vector>

#include "doctest/doctest.h"

namespace {

// Rows of so many numbers, one for each state, there and back; no others are read or written.
template <std::size_t width>
void go_there_and_back() {
  for (int states = 1; states <= kLanes; ++states) {
    const std::size_t count = static_cast<std::size_t>(states) * width;
    std::vector<Real> rows(count), back(count + 1);
    std::iota(rows.begin(), rows.end(), Real(1));
    back[count] = -1;
    std::array<Lanes, width> lanes{};
    to_lanes(states, rows.data(), lanes);
    for (std::size_t k = 0; k < width; ++k)
      for (int s = 0; s < kLanes; ++s) {
        const std::size_t state = static_cast<std::size_t>(std::min(s, states - 1));
        CHECK(lanes[k][s] == rows[state * width + k]);
      }
    to_rows(states, lanes, back.data());
    CHECK(std::equal(rows.begin(), rows.end(), back.begin()));
    CHECK(back[count] == -1);
  }
}
template <std::size_t... k>
void go_there_and_back(std::index_sequence<k...>) {
  (go_there_and_back<k + 1>(), ...);
}

}  // namespace

TEST_CASE("rows of states become lanes and rows again") {
  go_there_and_back(std::make_index_sequence<20>{});
}

TEST_CASE("a register of states is a value") {
  CHECK(std::is_same_v<Value, Lanes>);
  CHECK(sizeof(Value) == kRegisterBytes);
}
