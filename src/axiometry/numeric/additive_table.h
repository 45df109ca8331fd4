// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <span>
#include <vector>

/// A table whose values are a row's level plus a column's shift plus scatter; the shifts have mean 0.
namespace axiometry::numeric {

struct AdditiveFit {
  std::size_t columns = 0;
  std::vector<double> residuals;        ///< as the table; NaN where it has no value
  std::vector<double> levels;           ///< level per row; NaN for one without a value
  std::vector<double> shifts;           ///< shift per column; NaN for one without a value
  std::vector<std::size_t> row_counts;  ///< values there are
  std::vector<std::size_t> column_counts;
  std::size_t count = 0;  ///< number of all values
  double squares = 0.0;   ///< sum of the squares of the residuals
  double degrees = 0.0;   ///< degrees of freedom of that sum; may be 0

  std::span<const double> row(std::size_t i) const { return {residuals.data() + i * columns, columns}; }
  /// Variance of a residual by that of a value: (1 − 1/n_row)(1 − 1/n_column), exact for a full table.
  double share(std::size_t row, std::size_t column) const;
};

/// Least squares of both, NaN standing for a value that is missing. A full table takes one pass; one with gaps a few
/// more, until the levels move by less than 1e-12 of the table's spread; one whose parts few values tie together takes
/// 60, and then one for each column, at most 200: beyond so many columns it may be less exact. Contract: whole rows.
AdditiveFit fit_additive(std::span<const double> table, std::size_t columns);

}  // namespace axiometry::numeric
