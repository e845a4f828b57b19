// adagen's runtime, the same for all robots.
// What the tables of a solver's model and of its loops are made of; sines of its angles.
#pragma once

#include "../constants.hpp"
#include "../far_angles.hpp"
#include "plain_loops.hpp"
#include "tables.hpp"
