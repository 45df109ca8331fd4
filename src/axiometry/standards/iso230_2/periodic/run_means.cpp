// SPDX-License-Identifier: Apache-2.0
#include "axiometry/standards/iso230_2/periodic/run_means.h"

#include <algorithm>
#include <cmath>

#include "axiometry/numeric/additive_table.h"
#include "axiometry/numeric/moments.h"

namespace axiometry::iso230_2 {

RunMeans run_means_of(const Series& series, Direction direction) {
  const std::size_t n = series.run_count();
  std::vector<double> table;
  table.reserve(series.target_count() * n);
  for (std::size_t i = 0; i < series.target_count(); ++i) {
    const auto cell = series.cell(i, direction);
    table.insert(table.end(), cell.begin(), cell.end());
  }
  const numeric::AdditiveFit additive = numeric::fit_additive(table, n);
  const auto driven = [](std::size_t count) { return count > 0; };
  const auto rows = static_cast<std::size_t>(std::ranges::count_if(additive.row_counts, driven));
  const auto columns = static_cast<std::size_t>(std::ranges::count_if(additive.column_counts, driven));
  RunMeans means;
  means.missing = rows * columns - additive.count;
  double squares = 0.0, cells = 0.0, shares = 0.0;
  for (std::size_t i = 0; i < series.target_count(); ++i) {
    std::vector<double> readings(table.begin() + static_cast<std::ptrdiff_t>(i * n),
                                 table.begin() + static_cast<std::ptrdiff_t>((i + 1) * n));
    // Where runs differ in what targets they have, what they are shifted by would be taken for an error of the targets.
    if (means.missing > 0)
      for (std::size_t j = 0; j < n; ++j) readings[j] -= additive.shifts[j];
    const numeric::Moments cell = numeric::moments(readings);
    if (cell.count == 0) continue;
    means.places.push_back(series.targets()[i].in_native());
    means.values.push_back(cell.mean);
    means.runs = std::max(means.runs, cell.count);
    shares += 1.0 / static_cast<double>(cell.count);
    if (cell.count < 2) continue;
    squares += cell.standard_deviation * cell.standard_deviation / static_cast<double>(cell.count);
    cells += 1.0;
  }
  if (means.missing > 0) {  // shifts that were taken out have taken degrees of freedom too
    if (additive.degrees >= 1.0)
      means.scatter =
          std::sqrt(additive.squares / additive.degrees * shares / static_cast<double>(means.places.size()));
  } else if (cells > 0.0) {
    means.scatter = std::sqrt(squares / cells);
  }
  return means;
}

}  // namespace axiometry::iso230_2
