// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <stddef.h>
#include <stdint.h>

#if defined(__SSE2__)
#include <immintrin.h>
#endif

// Vectors as wide as the registers of the target that is compiled, for kernels only (*_kernel.h).
//
// A kernel is compiled with instructions that the processor may not have. Whatever it defines lies therefore in the
// namespace of its target, and it calls no inline function or template of a shared header, which the linker could hand
// to the rest of the program (tools/check_kernels.py).
#if !defined(AXIOMETRY_VECTOR_TARGET)
#error "found no AXIOMETRY_VECTOR_TARGET, expected to be compiled by axiometry_vector_kernels()"
#endif

namespace axiometry::numeric::AXIOMETRY_VECTOR_TARGET {

#if defined(__AVX512F__)
inline constexpr size_t register_bytes = 64;
#elif defined(__AVX2__)
inline constexpr size_t register_bytes = 32;
#else
inline constexpr size_t register_bytes = 16;
#endif

typedef double Doubles __attribute__((vector_size(register_bytes)));
typedef float Floats __attribute__((vector_size(register_bytes)));
typedef uint64_t Words __attribute__((vector_size(register_bytes)));
typedef uint32_t HalfWords __attribute__((vector_size(register_bytes)));
typedef int32_t Integers __attribute__((vector_size(register_bytes)));

template <typename Vector>
inline constexpr size_t lanes = 0;
template <>
inline constexpr size_t lanes<Doubles> = register_bytes / sizeof(double);
template <>
inline constexpr size_t lanes<Floats> = register_bytes / sizeof(float);

template <typename Vector, typename Number>
[[gnu::always_inline]] inline Vector load(const Number* from) {
  Vector vector;
  __builtin_memcpy(&vector, from, sizeof vector);
  return vector;
}

template <typename Vector, typename Number>
[[gnu::always_inline]] inline void store(Number* to, Vector vector) {
  __builtin_memcpy(to, &vector, sizeof vector);
}

/// The same number in every lane. Less 0, which the compiler leaves out; adding 0 it may not, which makes 0 of −0.
template <typename Vector, typename Number>
[[gnu::always_inline]] inline Vector all(Number number) {
  return number - Vector{};
}

/// The larger by a > b ? a : b, the smaller by a < b ? a : b: what the instructions do, also with ±0.
template <typename Vector>
[[gnu::always_inline]] inline Vector lanewise_larger(Vector a, Vector b) {
  for (size_t k = 0; k < lanes<Vector>; ++k) a[k] = a[k] > b[k] ? a[k] : b[k];
  return a;
}

template <typename Vector>
[[gnu::always_inline]] inline Vector lanewise_smaller(Vector a, Vector b) {
  for (size_t k = 0; k < lanes<Vector>; ++k) a[k] = a[k] < b[k] ? a[k] : b[k];
  return a;
}

// Of AVX-512 the forms with a mask: g++ 12 takes the others for reading a variable before it is set.
#if defined(__AVX512F__)
[[gnu::always_inline]] inline Doubles larger(Doubles a, Doubles b) { return _mm512_maskz_max_pd(0xff, a, b); }
[[gnu::always_inline]] inline Doubles smaller(Doubles a, Doubles b) { return _mm512_maskz_min_pd(0xff, a, b); }
[[gnu::always_inline]] inline Doubles square_root(Doubles x) { return _mm512_maskz_sqrt_pd(0xff, x); }
[[gnu::always_inline]] inline Floats larger(Floats a, Floats b) { return _mm512_maskz_max_ps(0xffff, a, b); }
[[gnu::always_inline]] inline Floats smaller(Floats a, Floats b) { return _mm512_maskz_min_ps(0xffff, a, b); }
[[gnu::always_inline]] inline Floats square_root(Floats x) { return _mm512_maskz_sqrt_ps(0xffff, x); }
#elif defined(__AVX2__)
[[gnu::always_inline]] inline Doubles larger(Doubles a, Doubles b) { return _mm256_max_pd(a, b); }
[[gnu::always_inline]] inline Doubles smaller(Doubles a, Doubles b) { return _mm256_min_pd(a, b); }
[[gnu::always_inline]] inline Doubles square_root(Doubles x) { return _mm256_sqrt_pd(x); }
[[gnu::always_inline]] inline Floats larger(Floats a, Floats b) { return _mm256_max_ps(a, b); }
[[gnu::always_inline]] inline Floats smaller(Floats a, Floats b) { return _mm256_min_ps(a, b); }
[[gnu::always_inline]] inline Floats square_root(Floats x) { return _mm256_sqrt_ps(x); }
#elif defined(__SSE2__)
[[gnu::always_inline]] inline Doubles larger(Doubles a, Doubles b) { return _mm_max_pd(a, b); }
[[gnu::always_inline]] inline Doubles smaller(Doubles a, Doubles b) { return _mm_min_pd(a, b); }
[[gnu::always_inline]] inline Doubles square_root(Doubles x) { return _mm_sqrt_pd(x); }
[[gnu::always_inline]] inline Floats larger(Floats a, Floats b) { return _mm_max_ps(a, b); }
[[gnu::always_inline]] inline Floats smaller(Floats a, Floats b) { return _mm_min_ps(a, b); }
[[gnu::always_inline]] inline Floats square_root(Floats x) { return _mm_sqrt_ps(x); }
#else
[[gnu::always_inline]] inline Doubles larger(Doubles a, Doubles b) { return lanewise_larger(a, b); }
[[gnu::always_inline]] inline Doubles smaller(Doubles a, Doubles b) { return lanewise_smaller(a, b); }
[[gnu::always_inline]] inline Floats larger(Floats a, Floats b) { return lanewise_larger(a, b); }
[[gnu::always_inline]] inline Floats smaller(Floats a, Floats b) { return lanewise_smaller(a, b); }
[[gnu::always_inline]] inline Doubles square_root(Doubles x) {
  for (size_t k = 0; k < lanes<Doubles>; ++k) x[k] = __builtin_sqrt(x[k]);
  return x;
}
[[gnu::always_inline]] inline Floats square_root(Floats x) {
  for (size_t k = 0; k < lanes<Floats>; ++k) x[k] = __builtin_sqrtf(x[k]);
  return x;
}
#endif

[[gnu::always_inline]] inline Doubles magnitude(Doubles x) {
  return reinterpret_cast<Doubles>(reinterpret_cast<Words>(x) & 0x7fff'ffff'ffff'ffffu);
}
[[gnu::always_inline]] inline Floats magnitude(Floats x) {
  return reinterpret_cast<Floats>(reinterpret_cast<HalfWords>(x) & 0x7fff'ffffu);
}

}  // namespace axiometry::numeric::AXIOMETRY_VECTOR_TARGET
