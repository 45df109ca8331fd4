// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <span>

namespace axiometry::numeric {

/// A table with a column for every trial, the form in which kernels work on many trials at once: value t of row r
/// is values[r·stride + t].
template <typename Number>
struct Rows {
  std::span<Number> values;
  std::size_t stride = 0;  ///< at least the number of trials

  std::span<Number> row(std::size_t r, std::size_t trials) const { return values.subspan(r * stride, trials); }
  /// Whether the first `trials` values of this many rows are there.
  bool hold(std::size_t rows, std::size_t trials) const {
    return rows == 0 || trials == 0 || (trials <= stride && (rows - 1) * stride + trials <= values.size());
  }
  operator Rows<const Number>() const { return {values, stride}; }
};

}  // namespace axiometry::numeric
