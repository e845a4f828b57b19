// adagen's runtime, the same for all robots.
#pragma once

#include "../value.hpp"

namespace {

// The state that an evaluation reads, and the answer that it writes.
struct State {
  const Value* q = nullptr;
  const Value* v = nullptr;
  const Value* tau = nullptr;
  Value* qdd = nullptr;
};

}  // namespace
