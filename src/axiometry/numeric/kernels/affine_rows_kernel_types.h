// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>

#include "axiometry/numeric/vector_target.h"

namespace axiometry::numeric {

/// The map of affine_rows.h as the kernel reads it: the terms of row r are those from begins[r] to begins[r + 1].
template <typename Number>
struct AffineMapView {
  std::size_t rows = 0;
  const Number* constants = nullptr;
  const std::uint32_t* begins = nullptr;
  const std::uint32_t* sources = nullptr;
  const Number* factors = nullptr;
};

template <typename Number>
struct AffineInput {
  const Number* values = nullptr;
  std::size_t stride = 0;
  std::size_t trials = 0;
};

struct AffineKernel {
  void (*apply)(const AffineMapView<double>& map, AffineInput<double> input, double* rows, std::size_t stride);
  void (*apply_single)(const AffineMapView<float>& map, AffineInput<float> input, float* rows, std::size_t stride);
  void (*subtract)(const double* factors, std::size_t terms, std::size_t rows, AffineInput<double> input, double* to,
                   std::size_t stride);
};

/// The one for this target; contract: it is available.
const AffineKernel& affine_kernel_of(VectorTarget target);

}  // namespace axiometry::numeric
