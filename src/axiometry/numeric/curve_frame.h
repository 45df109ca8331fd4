// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <memory>
#include <span>
#include <vector>

#include "axiometry/numeric/curve_axes.h"
#include "axiometry/numeric/kernels/matern_filter.h"

namespace axiometry::numeric {

/// What the posteriors of curves over the same places have in common; private to curve_posterior.h.
struct CurveFrame {
  std::vector<double> places;
  std::size_t terms = 0;
  std::vector<double> trend;                        ///< columns, one after the other
  std::vector<CurveAxes> axes;                      ///< axes of every length; empty where there are filters
  std::size_t stride = 0;                           ///< distance from one column to the next, in what follows
  std::vector<std::vector<double>> padded_columns;  ///< axes of every length (curve_kernel_types.h)
  std::shared_ptr<const std::vector<MaternFilter>> filters;

  MaternFilter::Trend filter_trend() const { return {trend, terms}; }
};

/// Lengths of the smooth part, halving from over half the range down to the spacing.
std::vector<double> smooth_lengths(std::span<const double> places);

}  // namespace axiometry::numeric
