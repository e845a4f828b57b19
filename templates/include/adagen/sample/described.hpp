// adagen's runtime, the same for all robots.
// A solver says this itself (ADAGEN_SOLVER). Read alone, headers take it of a sample.
#pragma once
#if !defined(ADAGEN_SOLVER) && !defined(ADAGEN_DESCRIBED)

#include "../description.hpp"
#include "../sizes.hpp"

namespace {

adagen::Description<Number> description() { return {}; }

}  // namespace

#endif
