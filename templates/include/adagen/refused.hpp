// adagen's runtime, the same for all robots.
#pragma once

#include "open_failure.hpp"
#include "reproducible.hpp"

namespace {

// Whether answers would be others here: open_failure tells why.
bool refused() {
  const char* const why = why_not_reproducible();
  open_failure.clear();
  if (why != nullptr) open_failure += why;
  return why != nullptr;
}

}  // namespace
