// adagen's runtime, the same for all robots.
#pragma once

#include <cstddef>

#include "blocks.hpp"
#include "loop_settings.hpp"
#include "tables.hpp"

namespace {

// Inertias of links are constants.
struct Inertias {
  static const LinkInertia& inertia_of(int joint) {
    return kInertias[static_cast<std::size_t>(joint)];
  }
  static const BlockConstants& constants_of(int block) {
    return kBlockConstants[static_cast<std::size_t>(constants_at(block))];
  }
};

}  // namespace
