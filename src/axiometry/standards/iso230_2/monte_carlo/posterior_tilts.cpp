// SPDX-License-Identifier: Apache-2.0

// Of posterior.h: slopes that the runs have of their own.
#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include "axiometry/numeric/distributions/possible_shares.h"
#include "axiometry/standards/iso230_2/monte_carlo/posterior.h"
#include "axiometry/standards/iso230_2/scatter/run_tilts.h"
#include "axiometry/standards/readings/runs_made.h"

namespace axiometry::iso230_2 {
namespace {

/// Σ of the products of what both lie beside their means, over the runs that have both.
double products_of(const std::vector<double>& a, const std::vector<double>& b) {
  double count = 0.0, sum_a = 0.0, sum_b = 0.0, products = 0.0;
  for (std::size_t j = 0; j < a.size(); ++j)
    if (!std::isnan(a[j]) && !std::isnan(b[j])) count += 1.0, sum_a += a[j], sum_b += b[j], products += a[j] * b[j];
  return count > 0.0 ? products - sum_a * sum_b / count : 0.0;
}

}  // namespace

void ReadingPosterior::find_tilts(const Series& numbered) {
  const Series series = without_empty_runs(numbered);
  const TiltStudy study = tilt_study(series);
  if (!counts(study)) return;
  const std::array<std::vector<double>, 2> of = direction_tilts(series);
  std::array<double, 2> found{}, kept{};
  for (std::size_t d = 0; d < 2; ++d) {
    found[d] = products_of(of[d], of[d]) / study.degrees();
    kept[d] = std::max(0.0, found[d] - study.of_scatter_each);
  }
  if (!(kept[0] + kept[1] > 0.0)) return;
  const double correlation =
      found[0] > 0.0 && found[1] > 0.0
          ? std::clamp(products_of(of[0], of[1]) / study.degrees() / std::sqrt(found[0] * found[1]), -1.0, 1.0)
          : 0.0;
  const double up = std::sqrt(kept[0]), down = std::sqrt(kept[1]);
  Tilts tilts{.runs = static_cast<double>(study.runs),
              .variances = kept,
              .factor = {up, correlation * down, std::sqrt(1.0 - correlation * correlation) * down},
              .levers = tilt_levers(series)};
  const double directions = series.has(Direction::up) && series.has(Direction::down) ? 2.0 : 1.0;
  double mean_square = 0.0;
  for (const double lever : tilts.levers) mean_square += lever * lever / static_cast<double>(tilts.levers.size());
  const double beside = std::max(0.0, study.within * study.within - noise_.reading * noise_.reading);
  tilts.kept = beside / (beside + mean_square * (kept[0] + kept[1]) / directions);
  if (run_shifts_.size() == of[0].size())
    for (std::size_t d = 0; d < 2; ++d)
      if (kept[d] > 0.0) tilts.shifts[d] = products_of(of[d], run_shifts_) / (found[d] * study.degrees());
  tilts_.emplace(std::move(tilts));
}

ReadingPosterior::TiltDraws ReadingPosterior::draw_tilts(numeric::RandomKey key, std::size_t trials) const {
  if (!tilts_) return {};
  TiltDraws draws{{std::vector<double>(trials), std::vector<double>(trials)}, std::vector<double>(trials)};
  std::vector<double> normals(2 * trials), uniforms(trials);
  numeric::fill_normal({key.seed, key.stream + 1, 2 * key.block}, normals);
  numeric::fill_uniform({key.seed, key.stream + 1, 2 * key.block + 1}, uniforms);
  const auto& [u, v, w] = tilts_->factor;
  const numeric::PossibleShares shares(tilts_->runs - 1.0);
  for (std::size_t t = 0; t < trials; ++t) {
    const double share = shares(uniforms[t]), of_mean = share / std::sqrt(tilts_->runs);
    draws.of_mean[0][t] = of_mean * u * normals[2 * t];
    draws.of_mean[1][t] = of_mean * (v * normals[2 * t] + w * normals[2 * t + 1]);
    draws.square_shares[t] = share * share;
  }
  return draws;
}

}  // namespace axiometry::iso230_2
