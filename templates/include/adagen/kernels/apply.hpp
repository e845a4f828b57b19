// adagen's runtime, the same for all robots.
#pragma once

#include <cstddef>

#include "../constants.hpp"
#include "../sample/robot.hpp"
#include "../sizes.hpp"
#include "memory.hpp"

namespace {

// Puts masses and their centres that are set at run time where links have theirs.
inline void apply_parameters(Workspace& w) {
  for (const SettableLink& own : kSettableLinks) {
    const LinkConstants& link = kLinks[static_cast<std::size_t>(own.link)];
    const auto number = [&](int entry, Number constant) {
      return entry < 0 ? constant : w.parameters[static_cast<std::size_t>(entry)];
    };
    Number center[3];
    for (int k = 0; k < 3; ++k)
      center[k] = number(own.center < 0 ? -1 : own.center + k, link.com[k]);
    w.set_inertia(own.link, number(own.mass, link.mass), center);
  }
}

}  // namespace
