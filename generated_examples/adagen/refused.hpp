// adagen's runtime, the same for all robots.
#pragma once

#include "open_failure.hpp"
#include "reproducible.hpp"

namespace {

// Whether this environment would change answers: open_failure says why.
[[maybe_unused]] bool refused() {
  const char* const why = why_not_reproducible();
  open_failure.clear();
  if (why != nullptr) open_failure += why;
  return why != nullptr;
}

}  // namespace
