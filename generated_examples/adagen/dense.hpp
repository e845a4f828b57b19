// adagen's runtime, the same for all robots.
#pragma once

#include <cmath>
#include <utility>

#include "common.hpp"

namespace {

// Matrices of a fixed, small size, column by column. Operators return matrices: compilers join
// their loops, and have no types of expressions to read, which takes them longer than the rest.
template <class T, int rows, int columns>
struct Dense {
  static constexpr int kRows = rows, kColumns = columns, kSize = rows * columns;
  using Row = Dense<T, 1, columns>;
  using Column = Dense<T, rows, 1>;
  using Transposed = Dense<T, columns, rows>;

  // Part of a matrix, to be changed in place: entry (i, k) is at [i * down + k * right].
  template <int down, int right>
  struct Part {
    T* first;

    T& operator()(int i, int k) const { return first[i * down + k * right]; }
    T& operator[](int k) const { return first[k * (columns == 1 ? down : right)]; }
    operator Dense() const {
      Dense result;
      ADAGEN_FOR (k, 0, columns)
        ADAGEN_FOR (i, 0, rows) result(i, k) = (*this)(i, k);
      return result;
    }
    const Part& operator=(const Dense& m) const {
      ADAGEN_FOR (k, 0, columns)
        ADAGEN_FOR (i, 0, rows) (*this)(i, k) = m(i, k);
      return *this;
    }
    const Part& operator=(const Part& m) const { return *this = Dense(m); }
    void operator+=(const Dense& m) const { *this = *this + m; }
    void operator-=(const Dense& m) const { *this = *this - m; }
    void operator*=(T x) const { *this = *this * x; }
    void setZero() const { *this = Dense::Zero(); }
    Transposed transpose() const { return Dense(*this).transpose(); }
    template <class S>
    Dense<S, rows, columns> cast() const {
      return Dense(*this).template cast<S>();
    }
    template <int count>
    auto head() const {
      return typename Dense<T, count, 1>::template Part<down, right>{first};
    }
    template <int count>
    auto tail() const {
      return typename Dense<T, count, 1>::template Part<down, right>{first + (rows - count) * down};
    }
  };

  T entry[kSize];

  Dense() = default;
  // All entries, row by row.
  template <class... More>
  Dense(T x, T y, More... more) {
    static_assert(sizeof...(more) + 2 == kSize);
    const T given[kSize] = {x, y, static_cast<T>(more)...};
    ADAGEN_FOR (i, 0, rows)
      ADAGEN_FOR (k, 0, columns) entry[i + rows * k] = given[i * columns + k];
  }
  static Dense Zero() {
    Dense result;
    ADAGEN_FOR (k, 0, kSize) result.entry[k] = 0;
    return result;
  }
  static Dense Identity() {
    Dense result = Zero();
    ADAGEN_FOR (k, 0, rows) result(k, k) = 1;
    return result;
  }
  // From numbers in memory, column by column; or row by row.
  template <class S>
  static Dense of(const S* from) {
    Dense result;
    ADAGEN_FOR (k, 0, kSize) result.entry[k] = T(from[k]);
    return result;
  }
  template <class S>
  static Dense of_rows(const S* from) {
    return Transposed::of(from).transpose();
  }

  constexpr T& operator()(int i, int k) { return entry[i + rows * k]; }
  constexpr const T& operator()(int i, int k) const { return entry[i + rows * k]; }
  constexpr T& operator[](int k) { return entry[k]; }
  constexpr const T& operator[](int k) const { return entry[k]; }
  T* data() { return entry; }
  const T* data() const { return entry; }

  auto col(int k) & { return typename Column::template Part<1, rows>{entry + rows * k}; }
  auto row(int i) & { return typename Row::template Part<1, rows>{entry + i}; }
  template <int r, int c>
  auto block(int i, int k) & {
    return typename Dense<T, r, c>::template Part<1, rows>{entry + i + rows * k};
  }
  template <int count>
  auto head() & {
    return block<count, 1>(0, 0);
  }
  template <int count>
  auto tail() & {
    return block<count, 1>(rows - count, 0);
  }
  // Of what cannot be changed, parts are copies.
  template <int r, int c>
  Dense<T, r, c> block(int i, int k) const& {
    Dense<T, r, c> result;
    ADAGEN_FOR (b, 0, c)
      ADAGEN_FOR (a, 0, r) result(a, b) = (*this)(i + a, k + b);
    return result;
  }
  Column col(int k) const& { return block<rows, 1>(0, k); }
  Row row(int i) const& { return block<1, columns>(i, 0); }
  template <int count>
  Dense<T, count, 1> head() const& {
    return block<count, 1>(0, 0);
  }
  template <int count>
  Dense<T, count, 1> tail() const& {
    return block<count, 1>(rows - count, 0);
  }

  void setZero() { *this = Zero(); }
  void setIdentity() { *this = Identity(); }
  Transposed transpose() const {
    Transposed result;
    ADAGEN_FOR (k, 0, columns)
      ADAGEN_FOR (i, 0, rows) result(k, i) = (*this)(i, k);
    return result;
  }
  template <class S>
  Dense<S, rows, columns> cast() const {
    return Dense<S, rows, columns>::of(entry);
  }
  T dot(const Dense& m) const {
    T sum = 0;
    ADAGEN_FOR (k, 0, kSize) sum += entry[k] * m.entry[k];
    return sum;
  }
  T squaredNorm() const { return dot(*this); }
  T norm() const { return std::sqrt(squaredNorm()); }
  Dense cross(const Dense& b) const {
    const T* const a = entry;
    return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
  }

  Dense& operator+=(const Dense& m) {
    ADAGEN_FOR (k, 0, kSize) entry[k] += m.entry[k];
    return *this;
  }
  Dense& operator-=(const Dense& m) {
    ADAGEN_FOR (k, 0, kSize) entry[k] -= m.entry[k];
    return *this;
  }
  Dense& operator*=(T x) {
    ADAGEN_FOR (k, 0, kSize) entry[k] *= x;
    return *this;
  }
  Dense operator-() const { return Dense(*this) *= -1; }
  friend Dense operator+(Dense a, const Dense& b) { return a += b; }
  friend Dense operator-(Dense a, const Dense& b) { return a -= b; }
  friend Dense operator*(Dense m, T x) { return m *= x; }
  friend Dense operator*(T x, Dense m) { return m *= x; }
  friend Column operator*(const Dense& m, const Dense<T, columns, 1>& x) {
    return m.template times<1>(x);
  }
  template <int k>
  friend Dense<T, rows, k> operator*(const Dense& m, const Dense<T, columns, k>& n) {
    return m.times(n);
  }
  template <int count>
  Dense<T, rows, count> times(const Dense<T, columns, count>& n) const {
    Dense<T, rows, count> result = Dense<T, rows, count>::Zero();
    ADAGEN_FOR (c, 0, count)
      ADAGEN_FOR (k, 0, columns)
        ADAGEN_FOR (i, 0, rows) result(i, c) += (*this)(i, k) * n(k, c);
    return result;
  }
};

// x of m x = b, by elimination with partial pivoting.
template <class T, int n>
[[maybe_unused]] Dense<T, n, 1> solve(Dense<T, n, n> m, Dense<T, n, 1> b) {
  for (int c = 0; c < n; ++c) {
    int most = c;
    for (int i = c + 1; i < n; ++i)
      if (std::abs(m(i, c)) > std::abs(m(most, c))) most = i;
    for (int k = c; k < n; ++k) std::swap(m(c, k), m(most, k));
    std::swap(b[c], b[most]);
    for (int i = c + 1; i < n; ++i) {
      const T factor = m(i, c) / m(c, c);
      for (int k = c + 1; k < n; ++k) m(i, k) -= factor * m(c, k);
      b[i] -= factor * b[c];
    }
  }
  for (int c = n; c-- > 0;) {
    for (int k = c + 1; k < n; ++k) b[c] -= m(c, k) * b[k];
    b[c] /= m(c, c);
  }
  return b;
}

}  // namespace
