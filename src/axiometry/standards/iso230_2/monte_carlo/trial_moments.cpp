// SPDX-License-Identifier: Apache-2.0

// The trials of trials.h where means and estimators of the cells are all that is asked of the readings: these are never
// kept, and each cell stays in the nearest cache until it is done.
#include <cmath>
#include <optional>

#include "axiometry/standards/iso230_2/monte_carlo/cell_kernel_types.h"
#include "axiometry/standards/iso230_2/monte_carlo/trials.h"

namespace axiometry::iso230_2 {

/// x̄ and s of every cell that has readings: of the readings drawn, less the drift, moved by the errors of length and
/// by those of the station, in this order.
void TrialModel::draw_cell_moments(std::uint64_t place, numeric::Rows<double> means,
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
