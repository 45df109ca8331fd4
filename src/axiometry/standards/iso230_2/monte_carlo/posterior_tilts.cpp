// SPDX-License-Identifier: Apache-2.0

// Of posterior.h: slopes that the runs have of their own.
#include <cmath>
#include <span>

#include "axiometry/standards/iso230_2/monte_carlo/posterior.h"
#include "axiometry/standards/iso230_2/scatter/scatter.h"

namespace axiometry::iso230_2 {

void ReadingPosterior::find_tilts(const Series& series) {
  const auto tilts = scatter_study(series).tilts;
  if (!tilts) return;
  tilts_.emplace(Tilts{tilts->between(), tilts->degrees(), tilts->within, tilt_levers(series)});
  for (const double lever : tilts_->levers)
    tilts_->mean_square += lever * lever / static_cast<double>(tilts_->levers.size());
  const std::vector<double> of_runs = run_tilts(series);
  double count = 0.0, mean = 0.0, products = 0.0, squares = 0.0;
  for (const double tilt : of_runs)
    if (!std::isnan(tilt)) count += 1.0, mean += tilt;
  for (std::size_t j = 0; j < of_runs.size(); ++j)
    if (const double beside = of_runs[j] - mean / count; !std::isnan(beside))
      products += beside * run_shifts_[j], squares += beside * beside;
  tilts_->shift = products / squares;
}

/// Of n tilts with n − 1 degrees of freedom: their mean is off by σ z/√n, and σ is s √(ν/χ²_ν), χ² of ν normal numbers.
ReadingPosterior::TiltDraws ReadingPosterior::draw_tilts(numeric::RandomKey key, std::size_t trials) const {
  if (!tilts_) return {};
  TiltDraws draws{std::vector<double>(trials), std::vector<double>(trials)};
  const auto of_sd = static_cast<std::size_t>(tilts_->degrees);
  std::vector<double> normals((of_sd + 1) * trials);
  numeric::fill_normal({key.seed, key.stream + 1, key.block}, normals);
  for (std::size_t t = 0; t < trials; ++t) {
    const std::span<const double> z = std::span(normals).subspan(t * (of_sd + 1), of_sd + 1);
    double squares = 0.0;
    for (const double x : z.first(of_sd)) squares += x * x;
    draws.sds[t] = tilts_->sd * std::sqrt(tilts_->degrees / squares);
    draws.of_mean[t] = draws.sds[t] * z[of_sd] / std::sqrt(tilts_->degrees + 1.0);
  }
  return draws;
}

}  // namespace axiometry::iso230_2
