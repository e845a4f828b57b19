// adagen's runtime, the same for all robots.
// State and sweeps of a solver that keeps nothing where segments meet, for refinement or for
// certificates, and whose links have constant inertias.
#pragma once

#include "plain_state.hpp"
#include "sweeps.hpp"
