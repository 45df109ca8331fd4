// SPDX-License-Identifier: Apache-2.0
#include "axiometry/standards/iso230_2/scatter/direction_tables.h"

#include <cmath>
#include <utility>

#include "axiometry/base/contract.h"

namespace axiometry::iso230_2::scatter {

Tables tables_of(const Series& series) {
  Tables tables;
  for (Direction d : each_direction) {
    tables[index(d)].reserve(series.target_count() * series.run_count());
    for (std::size_t i = 0; i < series.target_count(); ++i) {
      const auto cell = series.cell(i, d);
      tables[index(d)].insert(tables[index(d)].end(), cell.begin(), cell.end());
    }
  }
  return tables;
}

Series series_of(const Series& like, const Tables& tables) {
  std::vector<double> all = tables[0];
  all.insert(all.end(), tables[1].begin(), tables[1].end());
  auto series = Series::make_dense({like.targets().begin(), like.targets().end()}, like.run_count(), std::move(all));
  AXIOMETRY_CONTRACT(series.has_value());
  return *std::move(series);
}

DirectionFits fits_of(const Tables& tables, std::size_t runs) {
  return {numeric::fit_additive(tables[0], runs), numeric::fit_additive(tables[1], runs)};
}

std::vector<double> means_of(std::span<const double> up, std::span<const double> down) {
  std::vector<double> means;
  for (std::size_t j = 0; j < up.size(); ++j)
    means.push_back(std::isnan(up[j]) ? down[j] : std::isnan(down[j]) ? up[j] : 0.5 * (up[j] + down[j]));
  return means;
}

}  // namespace axiometry::iso230_2::scatter
