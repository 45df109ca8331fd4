// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "axiometry/numeric/vector_target.h"

namespace axiometry::numeric {

/// Rows of as many ascending numbers each, in which places are looked for: what is left of a distribution on a grid,
/// from which uniform numbers draw.
class CumulativeRows {
 public:
  CumulativeRows() = default;
  /// All numbers are ∞. Contract: at least one number in a row.
  CumulativeRows(std::size_t rows, std::size_t numbers);

  bool empty() const { return rows_ == 0; }

  void set(std::size_t row, std::size_t index, float number);

  /// Of each of the finite numbers how many of a row are at most as large: of the first row for the first number and so
  /// on, or of the rows that are said.
  void count_up_to(std::span<const float> numbers, std::span<const std::uint32_t> rows, std::span<std::uint32_t> found,
                   VectorTarget target = best_vector_target()) const;

 private:
  std::size_t rows_ = 0;
  std::size_t numbers_ = 0;
  std::size_t blocks_ = 0;
  std::size_t ends_ = 0;  ///< numbers before the blocks, in which the block is looked for
  std::size_t stride_ = 0;
  std::vector<float> values_;
};

}  // namespace axiometry::numeric
