// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>

#include "axiometry/numeric/vector_target.h"

namespace axiometry::numeric {

/// Columns are filled up with zeros to a multiple of so many places.
inline constexpr std::size_t curve_padding = 8;

/// A curve f = Σ_k (mean_k + sd_k z_k) column_k over m places, as many columns.
struct CurveView {
  const double* means = nullptr;
  const double* sds = nullptr;
  const double* columns = nullptr;  ///< one after the other
  std::size_t places = 0;           ///< m
  std::size_t stride = 0;           ///< m, filled up
};

/// Curves over the same places, each of its own means, deviations and columns.
struct CurveDraws {
  const CurveView* views = nullptr;
  std::size_t count = 0;
  const double* normals = nullptr;  ///< m for each curve …
  std::size_t normals_stride = 0;   ///< … which begin so far apart
  double* values = nullptr;         ///< out: `stride` or fewer for each curve, at least m …
  std::size_t values_stride = 0;    ///< … which begin so far apart, at least `stride`
};

struct CurveKernel {
  /// Adds in the order of the columns, beginning with 0.
  void (*draw)(const CurveDraws& curves);
};

/// The one for this target; contract: it is available.
const CurveKernel& curve_kernel_of(VectorTarget target);

}  // namespace axiometry::numeric
