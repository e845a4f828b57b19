// adagen's runtime, the same for all robots.
// A solver says this itself (ADAGEN_SOLVER). Read alone, headers take it of a sample.
#pragma once
#if !defined(ADAGEN_SOLVER)

#include <array>

#include "../constants.hpp"

namespace {

constexpr std::array<MessageInfo, 4> kMessages{{{0, 1, 27}, {1, 0, 27}, {0, 1, 40}, {1, 0, 11}}};

}  // namespace

#endif
