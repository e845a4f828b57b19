// adagen's runtime, the same for all robots.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstring>
#include <type_traits>
#include <utility>

#include "common.hpp"

namespace {

// Bytes of the machine's widest registers.
#if defined(__AVX512F__)
constexpr std::size_t kRegisterBytes = 64;
#elif defined(__AVX__)
constexpr std::size_t kRegisterBytes = 32;
#else
constexpr std::size_t kRegisterBytes = 16;
#endif

// Where registers are narrower, compilers warn that vectors are passed in other ways. Programs that
// are linked with this one pass none.
#if defined(__clang__)
#if __has_warning("-Wpsabi")
#pragma clang diagnostic ignored "-Wpsabi"
#endif
#elif defined(__GNUC__)
#pragma GCC diagnostic ignored "-Wpsabi"
#endif

// Numbers side by side that one register does not hold: two halves, each a register or two halves
// again. Compilers have vectors of any width, but g++ keeps those in memory that are wider than
// registers, from one operation to the next.
template <class Half>
struct Halves {
  using Number = std::decay_t<decltype(std::declval<Half&>()[0])>;
  static constexpr std::size_t kCount = sizeof(Half) / sizeof(Number) * 2;

  Half low, high;

  Halves() = default;
  // Half by half: compilers copy a whole one as they copy memory.
  constexpr ADAGEN_ALWAYS Halves(const Halves& x) : low(x.low), high(x.high) {}
  ADAGEN_INLINE Halves& operator=(const Halves& x) {
    low = x.low, high = x.high;
    return *this;
  }
  template <class... X, class = std::enable_if_t<sizeof...(X) == kCount>>
  constexpr Halves(X... x) : Halves({static_cast<Number>(x)...}, kHalf) {}
  ADAGEN_INLINE static Halves of(const Half& low, const Half& high) {
    Halves x;
    x.low = low, x.high = high;
    return x;
  }
  template <class K>
  ADAGEN_INLINE Number operator[](K k) const {
    const std::size_t at = static_cast<std::size_t>(k);
    if (!__builtin_constant_p(at)) return reinterpret_cast<const Number*>(this)[at];
    return at < kCount / 2 ? low[at] : high[at - kCount / 2];
  }
  template <class K>
  ADAGEN_INLINE Number& operator[](K k) {
    return reinterpret_cast<Number*>(this)[static_cast<std::size_t>(k)];
  }

 private:
  static constexpr std::make_index_sequence<kCount / 2> kHalf{};
  template <std::size_t... k>
  constexpr Halves(const Number (&x)[kCount], std::index_sequence<k...>)
      : low{x[k]...}, high{x[kCount / 2 + k]...} {}
};

// Operators of halves with halves, and with one number for all of them.
#define ADAGEN_UNARY(op)                                    \
  template <class T>                                        \
  ADAGEN_INLINE Halves<T> operator op(const Halves<T>& a) { \
    return Halves<T>::of(op a.low, op a.high);              \
  }
#define ADAGEN_BINARY(op)                                                            \
  template <class T>                                                                 \
  ADAGEN_INLINE auto operator op(const Halves<T>& a, const Halves<T>& b) {           \
    return Halves<decltype(a.low op b.low)>::of(a.low op b.low, a.high op b.high);   \
  }                                                                                  \
  template <class T, class = decltype(T {} op T{})>                                  \
  ADAGEN_INLINE auto operator op(const Halves<T>& a, typename Halves<T>::Number b) { \
    return Halves<decltype(a.low op b)>::of(a.low op b, a.high op b);                \
  }                                                                                  \
  template <class T, class = decltype(T {} op T{})>                                  \
  ADAGEN_INLINE auto operator op(typename Halves<T>::Number a, const Halves<T>& b) { \
    return Halves<decltype(a op b.low)>::of(a op b.low, a op b.high);                \
  }
#define ADAGEN_ASSIGNED(op)                                              \
  ADAGEN_BINARY(op)                                                      \
  template <class T, class B>                                            \
  ADAGEN_INLINE Halves<T>& operator op## = (Halves<T> & a, const B& b) { \
    return a = a op b;                                                   \
  }
ADAGEN_UNARY(-)
ADAGEN_UNARY(~)
ADAGEN_ASSIGNED(+)
ADAGEN_ASSIGNED(-)
ADAGEN_ASSIGNED(*)
ADAGEN_ASSIGNED(/)
ADAGEN_ASSIGNED(&)
ADAGEN_ASSIGNED(|)
ADAGEN_ASSIGNED(^)
ADAGEN_BINARY(<<)
ADAGEN_BINARY(<)
ADAGEN_BINARY(<=)
ADAGEN_BINARY(>)
ADAGEN_BINARY(>=)
ADAGEN_BINARY(==)
ADAGEN_BINARY(!=)
#undef ADAGEN_UNARY
#undef ADAGEN_BINARY
#undef ADAGEN_ASSIGNED

// So many numbers side by side, in as many registers as they need.
template <class Number, std::size_t count, bool fit = count * sizeof(Number) <= kRegisterBytes>
struct SideBySide {
  typedef Number T __attribute__((vector_size(count * sizeof(Number))));
};
template <class Number, std::size_t count>
struct SideBySide<Number, count, false> {
  using T = Halves<typename SideBySide<Number, count / 2>::T>;
};

// Numbers side by side from memory, wherever they begin, and to it: all, or as many as are first,
// and the others zero.
template <class T>
[[maybe_unused]] constexpr bool kOfHalves = false;
template <class T>
[[maybe_unused]] constexpr bool kOfHalves<Halves<T>> = true;
template <class T, std::size_t bytes = sizeof(T)>
ADAGEN_INLINE T from_memory(const void* from) {
  T x{};
  if constexpr (!kOfHalves<T>) {
    std::memcpy(&x, from, bytes);
  } else {
    using Half = decltype(T::low);
    x.low = from_memory<Half, std::min(bytes, sizeof(Half))>(from);
    if constexpr (bytes > sizeof(Half))
      x.high = from_memory<Half, bytes - sizeof(Half)>(static_cast<const Half*>(from) + 1);
  }
  return x;
}
template <std::size_t bytes, class T>
ADAGEN_INLINE void first_to_memory(const T& x, void* to) {
  if constexpr (!kOfHalves<T>) {
    std::memcpy(to, &x, bytes);
  } else {
    using Half = decltype(T::low);
    first_to_memory<std::min(bytes, sizeof(Half))>(x.low, to);
    if constexpr (bytes > sizeof(Half))
      first_to_memory<bytes - sizeof(Half)>(x.high, static_cast<Half*>(to) + 1);
  }
}
template <class T>
ADAGEN_INLINE void to_memory(const T& x, void* to) {
  first_to_memory<sizeof x>(x, to);
}

// Number by number, one or the other, and the larger one.
template <class Bits, class T>
ADAGEN_INLINE T chosen(const Bits& first, const T& x, const T& y) {
  if constexpr (kOfHalves<T>)
    return T::of(chosen(first.low, x.low, y.low), chosen(first.high, x.high, y.high));
  else
    return first ? x : y;
}
template <class T>
ADAGEN_INLINE T larger(const T& x, const T& y) {
  return chosen(x > y, x, y);
}

// Bits of numbers as those of others: of as many, of the same size.
template <class To, class From>
ADAGEN_INLINE To same_bits(const From& x) {
  return reinterpret_cast<To>(x);
}
template <class To, class T>
ADAGEN_INLINE To same_bits(const Halves<T>& x) {
  return To::of(same_bits<decltype(To::low)>(x.low), same_bits<decltype(To::low)>(x.high));
}

}  // namespace
