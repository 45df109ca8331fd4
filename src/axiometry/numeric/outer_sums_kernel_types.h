// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>

#include "axiometry/numeric/vector_target.h"

namespace axiometry::numeric {

/// Neighbouring entries of a row that is 0 elsewhere.
struct RowPiece {
  std::size_t first = 0;
  std::size_t count = 0;
  const double* values = nullptr;
};

/// A row as pieces whose places rise, and its weight.
struct PiecedRow {
  const RowPiece* pieces = nullptr;
  std::size_t count = 0;
  double weight = 0.0;
};

struct OuterSumsKernel {
  /// Adds w a aᵀ to the upper triangle of a matrix of `columns` squared by rows; entries below it may change.
  void (*add)(PiecedRow row, double* matrix, std::size_t columns);
  /// The same of four rows whose pieces have the same places, with a quarter of the memory's work.
  void (*add_four)(const PiecedRow* rows, double* matrix, std::size_t columns);
};

/// The one for this target; contract: it is available.
const OuterSumsKernel& outer_sums_kernel_of(VectorTarget target);

}  // namespace axiometry::numeric
