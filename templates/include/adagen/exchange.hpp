// adagen's runtime, the same for all robots.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>

#include "sizes.hpp"

namespace {

// Writes and reads the contents of a message.
template <class M>
Number* put(Number* to, const M& m) {
  return std::copy(m.data(), m.data() + M::SizeAtCompileTime, to);
}

template <class M>
const Number* get(const Number* from, M& m) {
  std::transform(from, from + M::SizeAtCompileTime, m.data(), [](Number x) { return Real(x); });
  return from + M::SizeAtCompileTime;
}

// The upper triangle of a symmetric block, column by column: each whole column is written over what
// the one before left below the diagonal.
template <class M>
Number* put_symmetric(Number* to, const M& m) {
  constexpr int n = M::RowsAtCompileTime;
  for (int k = 0; k < n; ++k, to += k) std::copy(m.data() + n * k, m.data() + n * k + n, to);
  return to;
}

template <class M>
const Number* get_symmetric(const Number* from, M& m) {
  for (int k = 0; k < M::RowsAtCompileTime; ++k)
    for (int i = 0; i <= k; ++i) m(i, k) = m(k, i) = Real(*from++);
  return from;
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
