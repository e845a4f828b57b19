// adagen's runtime, the same for all robots.
// What the program around it knows of a solver for several processes.
#pragma once

#include <array>
#include <cstddef>
#include <vector>

#include "description.hpp"
#include "sample/processes.hpp"
#include "sizes.hpp"
#include "tell.hpp"

namespace {

// What each process does, as long as the program runs.
const adagen::Table<adagen::Stage>* stages_of_processes() {
  static std::array<std::vector<adagen::Stage>, kProcesses> items;
  static std::array<adagen::Table<adagen::Stage>, kProcesses> tables{};
  for (std::size_t p = 0; p < items.size(); ++p) {
    const Stages& own = kProcess[p].stages;
    items[p].clear();
    for (int k = 0; k < own.count; ++k) items[p].push_back(described(own.stages[k]));
    tables[p] = {items[p].data(), own.count};
  }
  return tables.data();
}

}  // namespace
