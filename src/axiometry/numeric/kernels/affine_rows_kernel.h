// SPDX-License-Identifier: Apache-2.0
#pragma once

// The map of affine_rows.h for one target; compiled once for each (vector_target.h).
#include "axiometry/numeric/kernels/affine_rows_kernel_types.h"
#include "axiometry/numeric/kernels/lanes.h"

namespace axiometry::numeric::AXIOMETRY_VECTOR_TARGET {
namespace {

/// Some registers of one row at a time: the factor is then loaded once for all of them.
template <typename Vector, size_t registers, typename Number>
[[gnu::always_inline]] inline void apply_row(const AffineMapView<Number>& map, size_t row, const Number* sources,
                                             size_t stride, Number* to) {
  Vector sums[registers];
  for (size_t k = 0; k < registers; ++k) sums[k] = all<Vector>(map.constants[row]);
  for (size_t term = map.begins[row]; term < map.begins[row + 1]; ++term) {
    const Vector factor = all<Vector>(map.factors[term]);
    const Number* const from = sources + map.sources[term] * stride;
    for (size_t k = 0; k < registers; ++k) sums[k] += factor * load<Vector>(from + k * lanes<Vector>);
  }
  for (size_t k = 0; k < registers; ++k) store(to + k * lanes<Vector>, sums[k]);
}

template <typename Vector, typename Number>
[[gnu::always_inline]] inline void apply_all(const AffineMapView<Number>& map, AffineInput<Number> input, Number* rows,
                                             size_t stride) {
  constexpr size_t registers = register_bytes == 64 ? 8 : 4;  // AVX-512 has twice as many
  constexpr size_t wide = registers * lanes<Vector>;
  for (size_t row = 0; row < map.rows; ++row) {
    Number* const to = rows + row * stride;
    size_t t = 0;
    for (; t + wide <= input.trials; t += wide)
      apply_row<Vector, registers>(map, row, input.values + t, input.stride, to + t);
    for (; t + lanes<Vector> <= input.trials; t += lanes<Vector>)
      apply_row<Vector, 1>(map, row, input.values + t, input.stride, to + t);
    for (; t < input.trials; ++t) {
      Number sum = map.constants[row];
      for (size_t term = map.begins[row]; term < map.begins[row + 1]; ++term)
        sum += map.factors[term] * input.values[map.sources[term] * input.stride + t];
      to[t] = sum;
    }
  }
}

void apply(const AffineMapView<double>& map, AffineInput<double> input, double* rows, size_t stride) {
  apply_all<Doubles>(map, input, rows, stride);
}

void apply_single(const AffineMapView<float>& map, AffineInput<float> input, float* rows, size_t stride) {
  apply_all<Floats>(map, input, rows, stride);
}

/// Some registers of some rows: a number of the sources is then loaded once for all these rows, a factor once for all
/// registers of its row.
template <typename Vector, size_t rows, size_t registers>
[[gnu::always_inline]] inline void subtract_block(const double* factors, size_t terms, const double* sources,
                                                  size_t stride, double* to, size_t to_stride) {
  Vector left[rows][registers];
  for (size_t r = 0; r < rows; ++r)
    for (size_t k = 0; k < registers; ++k) left[r][k] = load<Vector>(to + r * to_stride + k * lanes<Vector>);
  for (size_t term = 0; term < terms; ++term) {
    Vector source[registers];
    for (size_t k = 0; k < registers; ++k) source[k] = load<Vector>(sources + term * stride + k * lanes<Vector>);
    for (size_t r = 0; r < rows; ++r) {
      const Vector factor = all<Vector>(factors[r * terms + term]);
      for (size_t k = 0; k < registers; ++k) left[r][k] -= factor * source[k];
    }
  }
  for (size_t r = 0; r < rows; ++r)
    for (size_t k = 0; k < registers; ++k) store(to + r * to_stride + k * lanes<Vector>, left[r][k]);
}

template <size_t rows, size_t registers>
[[gnu::always_inline]] inline void subtract_from(const double* factors, size_t terms, AffineInput<double> input,
                                                 double* to, size_t to_stride) {
  constexpr size_t wide = registers * lanes<Doubles>;
  size_t t = 0;
  if constexpr (registers > 1)
    for (; t + wide <= input.trials; t += wide)
      subtract_block<Doubles, rows, registers>(factors, terms, input.values + t, input.stride, to + t, to_stride);
  for (; t + lanes<Doubles> <= input.trials; t += lanes<Doubles>)
    subtract_block<Doubles, rows, 1>(factors, terms, input.values + t, input.stride, to + t, to_stride);
  for (; t < input.trials; ++t)
    for (size_t r = 0; r < rows; ++r)
      for (size_t term = 0; term < terms; ++term)
        to[r * to_stride + t] -= factors[r * terms + term] * input.values[term * input.stride + t];
}

/// Five sums at once: sums that wait for each other would take four times as long. They are those of five rows, the
/// runs of the standard programme (5.3.2), where registers are so wide that loads take the time: a number of the
/// sources is loaded once for all of them, which counts twice where it lies in two lines of the cache. Of 16 bytes it
/// seldom does, and there are too few registers for sums and factors.
void subtract(const double* factors, size_t terms, size_t rows, AffineInput<double> input, double* to, size_t stride) {
  constexpr size_t sums = 5;
  size_t r = 0;
  if constexpr (register_bytes > 16)
    for (; r + sums <= rows; r += sums)
      subtract_from<sums, 1>(factors + r * terms, terms, input, to + r * stride, stride);
  for (; r < rows; ++r) subtract_from<1, sums>(factors + r * terms, terms, input, to + r * stride, stride);
}

}  // namespace

extern const AffineKernel affine_kernel;
const AffineKernel affine_kernel = {apply, apply_single, subtract};

}  // namespace axiometry::numeric::AXIOMETRY_VECTOR_TARGET
