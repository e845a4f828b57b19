// adagen's runtime, the same for all robots.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>

#include "sizes.hpp"

namespace {

// What goes into a message, and out of one.
template <class M>
Number* put(Number* to, const M& m) {
  std::copy(m.data(), m.data() + M::kSize, to);
  return to + M::kSize;
}

template <class M>
const Number* get(const Number* from, M& m) {
  m = M::of(from);
  return from + M::kSize;
}

template <std::size_t n>
Number* put(Number* to, const std::array<Real, n>& x) {
  return std::copy(x.begin(), x.end(), to);
}

template <std::size_t n>
const Number* get(const Number* from, std::array<Real, n>& x) {
  std::transform(from, from + n, x.begin(), [](Number value) { return Real(value); });
  return from + n;
}

}  // namespace
