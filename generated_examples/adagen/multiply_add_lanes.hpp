// adagen's runtime, the same for all robots.
#pragma once

#include <cstddef>

#if defined(__FMA__)
#include <immintrin.h>
#elif defined(__aarch64__)
#include <arm_neon.h>
#endif

#include "common.hpp"
#include "kernels/lanes.hpp"
#include "multiply_add.hpp"
#include "short_vectors.hpp"
#include "sizes.hpp"

namespace {

// Products and sums of lanes that are rounded once. Compilers have no names for them but those of
// instructions, for each type of registers.
enum class Signs { kPlus, kLess, kFrom };  // a b + c, a b - c, c - a b
template <Signs signs>
ADAGEN_INLINE Real fused_as(Real a, Real b, Real c) {
  return signs == Signs::kPlus   ? fused(a, b, c)
         : signs == Signs::kLess ? fused_less(a, b, c)
                                 : fused_from(a, b, c);
}

#define ADAGEN_REGISTER(type, plus, less, from)                                \
  template <Signs signs>                                                       \
  ADAGEN_INLINE type fused_as(type a, type b, type c) {                        \
    return signs == Signs::kPlus ? plus : signs == Signs::kLess ? less : from; \
  }
#define ADAGEN_X86(type, prefix, numbers)                                                     \
  ADAGEN_REGISTER(type, prefix##_fmadd_##numbers(a, b, c), prefix##_fmsub_##numbers(a, b, c), \
                  prefix##_fnmadd_##numbers(a, b, c))
#if defined(__FMA__)
ADAGEN_X86(__m128d, _mm, pd)
ADAGEN_X86(__m256d, _mm256, pd)
ADAGEN_X86(__m128, _mm, ps)
ADAGEN_X86(__m256, _mm256, ps)
#endif
#if defined(__AVX512F__)
ADAGEN_X86(__m512d, _mm512, pd)
ADAGEN_X86(__m512, _mm512, ps)
constexpr std::size_t kFusedBytes = 64;
#elif defined(__FMA__)
constexpr std::size_t kFusedBytes = 32;
#elif defined(ADAGEN_ASKED_FOR_FMA)
typedef Real Register __attribute__((vector_size(16)));
template <Signs signs>
ADAGEN_INLINE Register fused_as(const Register& x, const Register& y, const Register& z) {
  const Register a = signs == Signs::kFrom ? -x : x;
  Register c = signs == Signs::kLess ? -z : z;
  if constexpr (sizeof(Real) == sizeof(double))
    asm volatile("vfmadd231pd %2, %1, %0" : "+x"(c) : "x"(a), "x"(y));
  else
    asm volatile("vfmadd231ps %2, %1, %0" : "+x"(c) : "x"(a), "x"(y));
  return c;
}
constexpr std::size_t kFusedBytes = 16;
#elif defined(__aarch64__)
ADAGEN_REGISTER(float64x2_t, vfmaq_f64(c, a, b), vfmaq_f64(-c, a, b), vfmsq_f64(c, a, b))
ADAGEN_REGISTER(float32x4_t, vfmaq_f32(c, a, b), vfmaq_f32(-c, a, b), vfmsq_f32(c, a, b))
constexpr std::size_t kFusedBytes = 16;
#else
constexpr std::size_t kFusedBytes = 0;
#endif
#undef ADAGEN_X86
#undef ADAGEN_REGISTER

// Register by register: where these are narrower, halves of a vector one after the other.
template <Signs signs, class T>
ADAGEN_INLINE T by_registers(const T& a, const T& b, const T& c) {
  if constexpr (kOfHalves<T>) {
    return T::of(by_registers<signs>(a.low, b.low, c.low),
                 by_registers<signs>(a.high, b.high, c.high));
  } else if constexpr (sizeof(T) > kFusedBytes) {
    typedef Real Half __attribute__((vector_size(sizeof(T) / 2)));
    union InHalves {  // if halves are copied, g++ takes them apart lane by lane
      T whole;
      Half half[2];
    };
    const InHalves x{a}, y{b}, z{c};
    InHalves result;
    for (int k = 0; k < 2; ++k)
      result.half[k] = by_registers<signs>(x.half[k], y.half[k], z.half[k]);
    return result.whole;
  } else {
    return fused_as<signs>(a, b, c);
  }
}

template <Signs signs, class T>
ADAGEN_INLINE T one_by_one(const T& a, const T& b, const T& c) {
  T result;
  for (int k = 0; k < kWidth<T>; ++k) result[k] = fused_as<signs>(a[k], b[k], c[k]);
  return result;
}

#if defined(ADAGEN_ASKED_FOR_FMA)
// Out of the way: compilers would take minutes for thousands of such branches in one function.
template <Signs signs, class T>
ADAGEN_COLD T without_registers(T a, T b, T c) {
  return one_by_one<signs>(a, b, c);
}
template <Signs signs, class T>
ADAGEN_INLINE T as_asked(const T& a, const T& b, const T& c) {
  if constexpr (sizeof(T) >= kFusedBytes) {
    if (__builtin_expect(kHasFma, 1)) return by_registers<signs>(a, b, c);
  }
  return without_registers<signs>(a, b, c);
}
#endif

// A single number stands for all lanes.
template <class T>
ADAGEN_INLINE T in_all_lanes(const T& x) {
  return x;
}
template <class T>
ADAGEN_INLINE T in_all_lanes(Real x) {
  return x - T{};
}

template <Signs signs, class A, class B, class C>
ADAGEN_INLINE auto lane_by_lane(const A& a, const B& b, const C& c) {
  using T = decltype(a + b + c);
  const T x = in_all_lanes<T>(a), y = in_all_lanes<T>(b), z = in_all_lanes<T>(c);
#if defined(ADAGEN_ASKED_FOR_FMA)
  return as_asked<signs>(x, y, z);
#else
  if constexpr (kFusedBytes == 0 || sizeof(T) < 16)
    return one_by_one<signs>(x, y, z);
  else
    return by_registers<signs>(x, y, z);
#endif
}
template <class A, class B, class C>
ADAGEN_INLINE auto fused(const A& a, const B& b, const C& c) {
  return lane_by_lane<Signs::kPlus>(a, b, c);
}
template <class A, class B, class C>
ADAGEN_INLINE auto fused_less(const A& a, const B& b, const C& c) {
  return lane_by_lane<Signs::kLess>(a, b, c);
}
template <class A, class B, class C>
ADAGEN_INLINE auto fused_from(const A& a, const B& b, const C& c) {
  return lane_by_lane<Signs::kFrom>(a, b, c);
}

}  // namespace
