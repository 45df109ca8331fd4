// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "axiometry/numeric/additive_table.h"

/// The search for outliers in the table of one direction, targets by runs, for scatter.cpp. Private to
/// standards/.
namespace axiometry::iso230_2::scatter {

/// The step of the readings: what all are whole multiples of.
struct Rounding {
  double step = 0.0;
  double variance() const { return step * step / 12.0; }
};

struct Place {
  std::size_t row = 0;
  std::size_t column = 0;
};

/// A reading that may be an outlier.
struct Candidate {
  Place at;
  double p = 1.0;  ///< chance of it anywhere among the readings of the direction, or in all cells
};

/// Generalised ESD in a table and its fit: takes one after the other; as many are outliers as the last that is
/// significant counts.
std::vector<Candidate> pooled_outliers(const numeric::AdditiveFit& whole, std::span<const double> of,
                                       const Rounding& rounding, double level);

/// Grubbs in every cell; `cells` are those of both directions.
std::vector<Candidate> cell_outliers(const numeric::AdditiveFit& fit, const Rounding& rounding, double cells,
                                     double level);

/// Rows with a value.
double rows_of(const numeric::AdditiveFit& fit);

/// Sum of the squares of a row's residuals, freed of what its part in the shifts has taken.
double row_squares(const numeric::AdditiveFit& fit, std::size_t row, double rows);

}  // namespace axiometry::iso230_2::scatter
