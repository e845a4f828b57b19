// adagen's runtime, the same for all robots.
// All that the joints of a solver for one process need in front of its memory, where none of them
// has springs, dampers or rotors and none is joined with another.
#pragma once

#include "articulated.hpp"
#include "joints_memory.hpp"
#include "no_channel.hpp"
