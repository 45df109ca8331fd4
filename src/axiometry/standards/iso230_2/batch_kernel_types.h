// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>

#include "axiometry/numeric/vector_target.h"

namespace axiometry::iso230_2 {

inline constexpr std::size_t batch_parameters = 12;

/// A BatchLayout as the kernel reads it. Cells in the order direction, target.
struct BatchView {
  std::size_t targets = 0;
  const std::uint32_t* begins = nullptr;  ///< 2m + 1; the readings of cell c are rows[begins[c]] to rows[begins[c + 1]]
  const std::uint32_t* rows = nullptr;
  std::size_t complete_runs = 0;           ///< n when every cell has all of n readings, else 0
  int output_rows[batch_parameters] = {};  ///< rows in the order of `parameters`; −1 where one does not exist
};

template <typename Number>
struct BatchInput {
  const Number* values = nullptr;
  std::size_t stride = 0;
};

template <typename Number>
struct BatchOutput {
  Number* values = nullptr;
  std::size_t stride = 0;
};

/// `trials` is at least batch_trials_min: the last register may overlap the one before.
inline constexpr std::size_t batch_trials_min = 16;

template <typename Number>
using BatchFromReadings = void (*)(const BatchView& view, BatchInput<Number> readings, std::size_t trials,
                                   BatchOutput<Number> parameters);
template <typename Number>
using BatchFromMoments = void (*)(const BatchView& view, BatchInput<Number> means, BatchInput<Number> estimators,
                                  std::size_t trials, BatchOutput<Number> parameters);

struct BatchKernel {
  BatchFromReadings<double> from_readings;
  BatchFromReadings<float> from_readings_single;
  BatchFromMoments<double> from_moments;
  BatchFromMoments<float> from_moments_single;
};

/// The one for this target; contract: it is available.
const BatchKernel& batch_kernel_of(numeric::VectorTarget target);

}  // namespace axiometry::iso230_2
