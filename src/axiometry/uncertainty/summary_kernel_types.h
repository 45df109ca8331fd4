// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>

#include "axiometry/numeric/vector_target.h"

namespace axiometry::uncertainty {

/// Value number i of a row adds to sum number i mod summary_lanes, so that every target adds in the same order.
inline constexpr std::size_t summary_lanes = 16;

/// Running sums and extremes of x − near_mean and x.
struct SummarySums {
  double first[summary_lanes];   ///< Σ (x − near_mean)
  double second[summary_lanes];  ///< Σ (x − near_mean)²
  double min[summary_lanes];
  double max[summary_lanes];
};

/// Equal cells: x falls in cell (x − lower)·cells_per_unit + ½, rounded to an integer. The first and the last count
/// what is beyond.
struct SummaryCells {
  double lower = 0.0;
  double cells_per_unit = 1.0;
  std::uint32_t last = 1;  ///< number of the last cell
  std::uint32_t* counts = nullptr;
};

struct SummaryKernel {
  void (*moments)(const double* values, std::size_t count, double near_mean, SummarySums& sums);
  /// Moments, and counts in cells.
  void (*counts)(const double* values, std::size_t count, double near_mean, SummarySums& sums,
                 const SummaryCells& cells);
};

/// The one for this target; contract: it is available.
const SummaryKernel& summary_kernel_of(numeric::VectorTarget target);

}  // namespace axiometry::uncertainty
