// adagen's runtime, the same for all robots.
#pragma once

#include "../value.hpp"

namespace {

// Where an evaluation finds the state, and puts what it answers.
struct State {
  const Value* q = nullptr;
  const Value* v = nullptr;
  const Value* tau = nullptr;
  Value* qdd = nullptr;
};

}  // namespace
