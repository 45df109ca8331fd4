// SPDX-License-Identifier: Apache-2.0

// The trials of trials.h where means and estimators of the cells are all that is asked of the readings: these are never
// kept, if they are made at all, and each cell stays in the nearest cache until it is done.
#include <cmath>
#include <optional>

#include "axiometry/standards/iso230_2/monte_carlo/kernels/cell_kernel_types.h"
#include "axiometry/standards/iso230_2/monte_carlo/trials.h"

namespace axiometry::iso230_2 {

/// x̄ and s of every cell that has readings: of what perfect instruments would have read, less the drift, moved by the
/// errors of length and by those of the station, in this order.
///
/// Where each reading has noise of its own no reading is drawn: mean and squares are, which takes fewer numbers. Else
/// the readings of a trial follow from the shifts of runs and targets and from the drift, so that they are as quickly
/// made.
void TrialModel::draw_cell_moments(std::uint64_t place, numeric::Rows<double> means,
                                   numeric::Rows<double> estimators) const {
  const ReadingPosterior& posterior = posteriors_[place % posteriors_.size()];
  if (!posterior.independent_noise()) return take_cell_moments(place, means, estimators);
  std::optional<DriftPosterior::Drawn> drift;
  ReadingPosterior::TakeAway take_away;
  if (drift_) {
    drift = drift_->draw(drift_key(place), chunk);
    take_away = [&](std::size_t cell, numeric::Rows<double> readings) {
      drift_->subtract_from_cell(*drift, cell, readings);
    };
  }
  posterior.draw_moments(posterior_key(place), {means, estimators}, take_away);
  add_length_errors(place, 1, means);
  add_station_errors(place, 1, means);
}

/// The same of readings that are made, one cell after the other.
void TrialModel::take_cell_moments(std::uint64_t place, numeric::Rows<double> means,
                                   numeric::Rows<double> estimators) const {
  const std::vector<double> lengths = length_errors_.empty() ? std::vector<double>{} : length_errors(place);
  const std::vector<double> squares = station_ ? station_squares(place) : std::vector<double>{};
  std::vector<double> of_position(squares.size());
  std::optional<DriftPosterior::Drawn> drift;
  if (drift_) drift = drift_->draw(drift_key(place), chunk);
  const CellKernel& kernel = cell_kernel_of(numeric::best_vector_target());
  std::vector<const double*> present;
  posteriors_[place % posteriors_.size()].draw_cells(
      posterior_key(place), chunk, [&](std::size_t cell, numeric::Rows<double> readings) {
        if (drift) drift_->subtract_from_cell(*drift, cell, readings);
        const std::size_t target = cell % series_.target_count();
        for (std::size_t t = 0; t < squares.size(); ++t) of_position[t] = station_->error_um(target, squares[t]);
        const auto measured = series_.cell(target, static_cast<Direction>(cell / series_.target_count()));
        present.clear();
        for (std::size_t j = 0; j < measured.size(); ++j)
          if (!std::isnan(measured[j])) present.push_back(readings.row(j, chunk).data());
        kernel.moments({.trials = chunk,
                        .count = present.size(),
                        .readings = present.data(),
                        .position = series_.targets()[target].in_native(),
                        .length_errors = lengths.empty() ? nullptr : lengths.data(),
                        .position_errors = squares.empty() ? nullptr : of_position.data(),
                        .means = means.row(cell, chunk).data(),
                        .estimators = estimators.row(cell, chunk).data()});
      });
}

}  // namespace axiometry::iso230_2
