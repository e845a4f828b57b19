// adagen's runtime, the same for all robots.
// A solver says this itself (ADAGEN_SOLVER). Read alone, headers take it of a sample.
#pragma once
#if !defined(ADAGEN_SOLVER)

#include "../bound_in_place.hpp"
#include "../open_alone.hpp"
#include "../set_links.hpp"
#include "parameters.hpp"
#include "solver.hpp"

#define ADAGEN_CALL(word) sample_p1_##word
#define ADAGEN_NAMED(WORD) SAMPLE_P1_##WORD
#define ADAGEN_SETS_GRAVITY
#define ADAGEN_SETS_MASS
#define ADAGEN_SETS_CENTER
#define ADAGEN_CERTIFIED
#define ADAGEN_REFINES

#endif
