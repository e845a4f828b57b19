// adagen's runtime, the same for all robots.
#pragma once

#include <cmath>
#include <cstdint>
#include <cstring>
#include <limits>

#include "sizes.hpp"

namespace {

// Sine and cosine of an angle far from zero, the same wherever the C library is: less a multiple of
// pi/2 by integer arithmetic (Payne and Hanek), then the polynomials of Cephes.

// A word of zeros, then 2/pi behind the point.
constexpr std::uint64_t kTwoOverPiWords[21] = {
    0x0000000000000000, 0xa2f9836e4e441529, 0xfc2757d1f534ddc0, 0xdb6295993c439041,
    0xfe5163abdebbc561, 0xb7246e3a424dd2e0, 0x06492eea09d1921c, 0xfe1deb1cb129a73e,
    0xe88235f52ebb4484, 0xe99c7026b45f7e41, 0x3991d639835339f4, 0x9c845f8bbdf9283b,
    0x1ff897ffde05980f, 0xef2f118b5a0a6d1f, 0x6d367ecf27cb09b7, 0x4f463f669e5fea2d,
    0x7527bac7ebe5f17b, 0x3d0739f78a5292ea, 0x6bfb5fb11f8d5d08, 0x56033046fc7b6bab,
    0xf0cfbc209af4361d};
constexpr double kSinePart[6] = {1.58962301576546568060e-10, -2.50507477628578072866e-8,
                                 2.75573136213857245213e-6,  -1.98412698295895385996e-4,
                                 8.33333333332211858878e-3,  -1.66666666666666307295e-1};
constexpr double kCosinePart[6] = {-1.13585365213876817300e-11, 2.08757008419747316778e-9,
                                   -2.75573141792967388112e-7,  2.48015872888517045348e-5,
                                   -1.38888888888730564116e-3,  4.16666666666665929218e-2};

inline double polynomial_of(const double (&coefficients)[6], double x) {
  double result = coefficients[0];
  for (int k = 1; k < 6; ++k) result = result * x + coefficients[k];
  return result;
}

__extension__ typedef unsigned __int128 TwoWordsOfBits;
__extension__ typedef __int128 SignedBits;

// The angle is rest + quadrant pi/2; it is at least 2^11.
inline double reduced(double angle, unsigned& quadrant) {
  std::uint64_t bits;
  std::memcpy(&bits, &angle, sizeof bits);
  const std::uint64_t one = 1, digits = (bits & ((one << 52) - 1)) | (one << 52);
  // Words of 2/pi whose products with the digits are less than 4 and not yet too small to matter.
  const unsigned first = static_cast<unsigned>((bits >> 52) & 0x7ff) - 1075 + 62;
  const unsigned at = first / 64, shift = first % 64;
  std::uint64_t words[3];
  for (unsigned k = 0; k < 3; ++k) {
    words[k] = kTwoOverPiWords[at + k] << shift;
    if (shift > 0) words[k] |= kTwoOverPiWords[at + k + 1] >> (64 - shift);
  }
  const TwoWordsOfBits low = TwoWordsOfBits(digits) * words[2];
  const TwoWordsOfBits middle = TwoWordsOfBits(digits) * words[1] + (low >> 64);
  const std::uint64_t high = digits * words[0] + static_cast<std::uint64_t>(middle >> 64);
  const TwoWordsOfBits product = (TwoWordsOfBits(high) << 64) | static_cast<std::uint64_t>(middle);
  const SignedBits fraction =
      static_cast<SignedBits>((product << 2) | (static_cast<std::uint64_t>(low) >> 62));
  const bool below = fraction < 0;
  quadrant = static_cast<unsigned>(high >> 62) + (below ? 1 : 0);
  const double size =
      static_cast<double>(static_cast<TwoWordsOfBits>(below ? -fraction : fraction));
  const double rest = size * 0x1p-128 * 1.57079632679489661923;
  return below ? -rest : rest;
}

[[maybe_unused]] inline void far_sine_and_cosine(Real angle, Real& sine, Real& cosine) {
  if (!(std::abs(angle) <= std::numeric_limits<Real>::max())) {
    sine = cosine = angle - angle;
    return;
  }
  unsigned quadrant = 0;
  const double rest = reduced(std::abs(static_cast<double>(angle)), quadrant), square = rest * rest;
  const double s = rest + rest * square * polynomial_of(kSinePart, square);
  const double c = 1 - square / 2 + square * square * polynomial_of(kCosinePart, square);
  const bool swapped = (quadrant & 1) != 0;
  const double size = swapped ? c : s;
  sine = static_cast<Real>(((quadrant & 2) != 0) != (angle < 0) ? -size : size);
  const double other = swapped ? s : c;
  cosine = static_cast<Real>(((quadrant + 1) & 2) != 0 ? -other : other);
}

}  // namespace
