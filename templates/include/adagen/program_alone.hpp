// adagen's runtime, the same for all robots.
// The description of a solver for one process, without loops, outer forces or outputs; and main.
#pragma once

#include "description.hpp"
#include "measured_alone.hpp"
#include "sample/processes.hpp"
#include "sizes.hpp"
#include "tell.hpp"

#define ADAGEN_DESCRIBED  // it is

namespace {

adagen::Description<Number> description() {
  static const adagen::Table<adagen::Stage> stages = table<kStages_0>();
  return plain_description(&stages);
}

}  // namespace

#include "entry.hpp"
