// adagen's runtime, the same for all robots.
// The description of a solver for several processes, without loops, outer forces or outputs; and
// main.
#pragma once

#include "description.hpp"
#include "sizes.hpp"
#include "tell_processes.hpp"

#define ADAGEN_DESCRIBED  // it is

namespace {

adagen::Description<Number> description() { return plain_description(stages_of_processes()); }

}  // namespace

#include "entry.hpp"
