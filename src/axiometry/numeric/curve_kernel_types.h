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

struct CurveKernel {
  /// Adds in the order of the columns, beginning with 0; sets `stride` values or fewer, at least m.
  void (*draw)(const CurveView& view, const double* normals, double* values);
};

/// The one for this target; contract: it is available.
const CurveKernel& curve_kernel_of(VectorTarget target);

}  // namespace axiometry::numeric
