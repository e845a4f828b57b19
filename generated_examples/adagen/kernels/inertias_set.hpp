// adagen's runtime, the same for all robots.
#pragma once

#include <array>
#include <cstddef>

#include "../sample/robot.hpp"
#include "../sizes.hpp"
#include "blocks.hpp"
#include "loop_settings.hpp"
#include "tables.hpp"

namespace {

// Inertias of links, of which some are set at run time.
struct Inertias {
  std::array<LinkInertia, kJointCount> inertias = kInertias;
  std::array<BlockConstants, kConstantsCount> constants = kBlockConstants;

  // The bits are the same whether a mass is set to what it is at first, or not: a compiler that
  // knew the numbers would round each product, where a processor fuses it with a sum.
  Inertias() {
    for (const SettableLink& own : kSettableLinks) {
      const LinkConstants& link = kLinks[static_cast<std::size_t>(own.link)];
      const volatile Number mass = link.mass, x = link.com[0], y = link.com[1], z = link.com[2];
      const Number center[3] = {x, y, z};
      set_inertia(own.link, mass, center);
    }
  }

  const LinkInertia& inertia_of(int joint) const {
    return inertias[static_cast<std::size_t>(joint)];
  }
  const BlockConstants& constants_of(int block) const {
    return constants[static_cast<std::size_t>(block)];
  }

  // Of a mass and its centre c: the pseudo-inertia about the link's origin is
  // tr(I) / 2 - I + m c c^T, with the rotational inertia I about the centre.
  void set_inertia(int link, Number mass, const Number (&c)[3]) {
    const Number(&I)[9] = kLinks[static_cast<std::size_t>(link)].tensor;
    const Number half = (I[0] + I[4] + I[8]) / 2;
    LinkInertia& own = inertias[static_cast<std::size_t>(link - 1)];
    const int slot = slot_of(link - 1);
    BlockConstants& block = constants[static_cast<std::size_t>(slot / kPerBlock)];
    const std::size_t lane = static_cast<std::size_t>(slot % kPerBlock);
    block.mass[lane] = own.mass = static_cast<Real>(mass);
    for (int i = 0, n = 0; i < 3; ++i) {
      block.moments[i][lane] = own.moments[i] = static_cast<Real>(mass * c[i]);
      for (int k = i; k < 3; ++k, ++n)
        block.tensor[n][lane] = own.tensor[n] =
            static_cast<Real>((i == k ? half : 0) - I[3 * i + k] + mass * c[i] * c[k]);
    }
  }
};

}  // namespace
