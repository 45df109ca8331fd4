// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cmath>

#include "axiometry/standards/iso230_2/monte_carlo/trials.h"

namespace axiometry::iso230_2 {
namespace {

constexpr std::size_t rows_of_target = 3;  // x̄_i↑, x̄_i↓, x̄_i

}  // namespace

/// Of every trial of the chunk; readings that are missing are no part of it.
std::vector<double> TrialModel::mean_of_cell(const DrawnCells& drawn, std::size_t target, Direction direction) const {
  const std::size_t cell = static_cast<std::size_t>(direction) * series_.target_count() + target;
  if (drawn.readings.empty()) {
    const auto row = drawn.means.all().subspan(cell * chunk, chunk);
    return {row.begin(), row.end()};
  }
  std::vector<double> mean(chunk);
  const auto measured = series_.cell(target, direction);
  const double share = 1.0 / static_cast<double>(series_.count(target, direction));
  for (std::size_t j = 0; j < measured.size(); ++j) {
    if (std::isnan(measured[j])) continue;
    const double* const row = drawn.readings.data() + (cell * series_.run_count() + j) * chunk;
    for (std::size_t t = 0; t < chunk; ++t) mean[t] += share * row[t];
  }
  return mean;
}

/// What a whole test is displaced by, against the place where the instrument was set to zero.
std::vector<double> TrialModel::displacements(std::uint64_t place) const {
  std::vector<double> displaced(chunk);
  for (std::size_t k = 0; k < inputs_.inputs.size(); ++k) {
    if (inputs_.inputs[k].effect != Effect::displacement) continue;
    const std::vector<double> error = draws(k, place);
    for (std::size_t t = 0; t < chunk; ++t) displaced[t] += error[t];
  }
  return displaced;
}

void TrialModel::draw_means(std::uint64_t block, std::span<const std::size_t> targets,
                            uncertainty::BlockOutputs outputs) const {
  for (std::size_t begin = 0; begin < outputs.trials; begin += chunk) {
    const std::uint64_t place = block * (uncertainty::block_size / chunk) + begin / chunk;
    DrawnCells drawn = draw_cells(place);
    add_levels(place, drawn);
    const std::vector<double> displaced = displacements(place);
    const std::size_t count = std::min(chunk, outputs.trials - begin);
    for (std::size_t k = 0; k < targets.size(); ++k) {
      std::vector<double> both(chunk);
      std::size_t directions = 0;
      for (const Direction direction : {Direction::up, Direction::down}) {
        if (series_.count(targets[k], direction) == 0) continue;
        std::vector<double> mean = mean_of_cell(drawn, targets[k], direction);
        for (std::size_t t = 0; t < chunk; ++t) both[t] += mean[t] += displaced[t];
        const auto row = outputs.row(rows_of_target * k + static_cast<std::size_t>(direction));
        std::copy_n(mean.begin(), count, row.begin() + static_cast<std::ptrdiff_t>(begin));
        ++directions;
      }
      if (directions < 2) continue;
      const auto row = outputs.row(rows_of_target * k + 2);
      for (std::size_t t = 0; t < count; ++t) row[begin + t] = 0.5 * both[t];
    }
  }
}

}  // namespace axiometry::iso230_2
