// SPDX-License-Identifier: Apache-2.0
#include "axiometry/standards/iso230_2/monte_carlo/trial_figures.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

#include "axiometry/standards/iso230_2/monte_carlo/trials.h"

namespace axiometry::iso230_2 {

/// A trial at a time, as a test of its own; not finite where that would be none. Readings that were not measured are
/// in no trial either.
void TrialModel::evaluate_figures(numeric::Rows<const double> readings, std::size_t runs, const WantedFigures& wanted,
                                  numeric::Rows<double> outputs) const {
  const auto& figures = options_.figures->figures;
  const std::vector<Position> targets(series_.targets().begin(), series_.targets().end());
  std::vector<double> deviations(2 * targets.size() * runs), values(figures.size());
  for (std::size_t t = 0; t < chunk; ++t) {
    for (std::size_t row = 0; row < deviations.size(); ++row) deviations[row] = readings.row(row, chunk)[t];
    const auto trial = Series::make_dense(targets, runs, deviations);
    for (std::size_t k = 0; k < values.size(); ++k)
      values[k] = trial ? figures[k].value : std::numeric_limits<double>::quiet_NaN();
    if (trial) options_.figures->evaluate(*trial, wanted, values);
    for (std::size_t k = 0; k < values.size(); ++k)
      if (wanted.has(figures[k])) outputs.row(k, chunk)[t] = values[k];
  }
}

/// Of n ≥ 2 readings one lies √((n − 1)/2) s above the mean, one as far below it, and all others on it: with divisor
/// n − 1 their estimator is s. A single one is the mean.
void TrialModel::evaluate_figures(numeric::Rows<const double> means, numeric::Rows<const double> estimators,
                                  const WantedFigures& wanted, numeric::Rows<double> outputs) const {
  const std::size_t targets = series_.target_count();
  const std::size_t runs = draws_moments_alone() ? 2 : series_.run_count();
  std::vector<double> readings(2 * targets * runs * chunk, std::numeric_limits<double>::quiet_NaN());
  const numeric::Rows<double> rows{readings, chunk};
  for (std::size_t c = 0; c < 2 * targets; ++c) {
    const auto measured = series_.cell(c % targets, static_cast<Direction>(c / targets));
    const std::size_t all = series_.count(c % targets, static_cast<Direction>(c / targets));
    const std::size_t count = std::min(all, runs);  // two readings for the long run
    std::size_t made = 0;
    for (std::size_t j = 0; made < count; ++j) {
      if (count == all && std::isnan(measured[j])) continue;
      const double side = made == 0 && count > 1 ? 1.0 : made == 1 ? -1.0 : 0.0;
      const double departure = side * std::sqrt(0.5 * static_cast<double>(count - 1));
      const auto row = rows.row(c * runs + (count == all && runs == measured.size() ? j : made), chunk);
      for (std::size_t t = 0; t < chunk; ++t)
        row[t] = means.row(c, chunk)[t] + (side == 0.0 ? 0.0 : departure * estimators.row(c, chunk)[t]);
      ++made;
    }
  }
  evaluate_figures(numeric::Rows<const double>(rows), runs, wanted, outputs);
}

/// Of *this test* figures of means and s are those of the trials of the parameters, so that a figure that is one of
/// them has its very interval; those of single readings are of trials whose readings are made.
void TrialModel::draw_figures(std::uint64_t place, numeric::Rows<double> outputs) const {
  const auto& figures = options_.figures->figures;
  for (std::size_t k = 0; k < figures.size(); ++k) std::ranges::fill(outputs.row(k, chunk), figures[k].value);
  for (const bool of_readings : {false, true}) {
    if (of_readings ? draws_moments_alone() : draws_readings_alone()) continue;
    WantedFigures wanted{!of_readings || draws_readings_alone(), of_readings};
    const auto is_wanted = [&](const TrialFigure& figure) { return wanted.has(figure); };
    std::optional<DrawnCells> drawn;
    for (const bool from_zero : {false, true}) {
      wanted.from_zero = from_zero;
      if (std::ranges::none_of(figures, is_wanted)) continue;
      if (!drawn) drawn = draw_cells(place, of_readings);
      if (from_zero) add_levels(place, *drawn);
      const numeric::Rows<const double> readings{drawn->readings, chunk}, means{drawn->means.all(), chunk},
          estimators{drawn->estimators.all(), chunk};
      if (of_readings)
        evaluate_figures(readings, series_.run_count(), wanted, outputs);
      else
        evaluate_figures(means, estimators, wanted, outputs);
    }
  }
}

}  // namespace axiometry::iso230_2
