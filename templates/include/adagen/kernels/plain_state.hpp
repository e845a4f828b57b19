// adagen's runtime, the same for all robots.
// State and memory of a solver that keeps nothing where segments meet, for refinement or for
// certificates, and whose links have constant inertias. A sample solver keeps all of it.
#pragma once
#if defined(ADAGEN_SOLVER)

#include "inertias.hpp"
#include "state.hpp"

namespace {

struct Cuts {};

}  // namespace

#include "keep_nothing.hpp"
#include "reach_nothing.hpp"

#endif
