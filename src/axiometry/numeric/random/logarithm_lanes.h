// SPDX-License-Identifier: Apache-2.0
#pragma once

// What random numbers are made of beside their bits, for kernels only (lanes.h): logarithm, sine and cosine.
#include "axiometry/numeric/kernels/lanes.h"
#include "axiometry/numeric/random/normal_polynomials.h"

namespace axiometry::numeric::AXIOMETRY_VECTOR_TARGET {
namespace {

/// Estrin's scheme: half as many dependent steps as Horner's, for 4 to 8 coefficients.
template <typename Vector, typename Number, size_t count>
[[gnu::always_inline]] inline Vector polynomial(Vector z, const Number (&c)[count]) {
  static_assert(count >= 4 && count <= 8);
  const Vector z2 = z * z;
  const Vector low = (c[0] + z * c[1]) + z2 * (c[2] + z * c[3]);
  if constexpr (count == 4) return low;
  const Vector z4 = z2 * z2;
  if constexpr (count == 5) return low + z4 * c[4 % count];
  if constexpr (count == 7) return low + z4 * ((c[4 % count] + z * c[5 % count]) + z2 * c[6 % count]);
  return low + z4 * ((c[4 % count] + z * c[5 % count]) + z2 * (c[6 % count] + z * c[7 % count]));
}

constexpr uint64_t exponent_of_1 = 0x3ff0'0000'0000'0000u;
constexpr uint64_t exponent_of_2_to_52 = 0x4330'0000'0000'0000u;
constexpr uint64_t exponent_of_2_to_84 = 0x4530'0000'0000'0000u;

/// The nearest number to an integer of 64 bits: its halves, placed in the mantissas of 2⁸⁴ and 2⁵², are exact.
[[gnu::always_inline]] inline Doubles converted(Words x) {
#if defined(__AVX512DQ__)
  return _mm512_cvtepu64_pd(reinterpret_cast<__m512i>(x));
#endif
  const Doubles high = reinterpret_cast<Doubles>((x >> 32) | exponent_of_2_to_84) - (0x1p84 + 0x1p52);
  return high + reinterpret_cast<Doubles>((x & 0xffff'ffffu) | exponent_of_2_to_52);
}

/// −2 ln(x·2⁻ᵏ) of finite x ≥ 1, to 3e-16 of itself beside the rounding of x.
[[gnu::always_inline]] inline Doubles minus_two_ln(Doubles number, double k) {
  constexpr uint64_t root_half = 0x3fe6'a09e'667f'3bcdu;
  const Words x = reinterpret_cast<Words>(number);
  const Words above = x - root_half;  // its exponent is e in x = 2ᵉ·m, √½ ≤ m < √2
  const Doubles m = reinterpret_cast<Doubles>(x - (above & 0xfff0'0000'0000'0000u));
  const Doubles exponent = reinterpret_cast<Doubles>((above >> 52) | exponent_of_2_to_52) - (0x1p52 + k);
  const Doubles s = (m - 1.0) / (m + 1.0);
  constexpr double minus_2_ln_2 = -0x1.62e42fefa39efp+0;
  return exponent * minus_2_ln_2 + s * polynomial(s * s, NormalPolynomials<double>::logarithm);
}

}  // namespace
}  // namespace axiometry::numeric::AXIOMETRY_VECTOR_TARGET
