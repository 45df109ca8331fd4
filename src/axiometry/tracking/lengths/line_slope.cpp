// SPDX-License-Identifier: Apache-2.0
#include "axiometry/tracking/lengths/line_slope.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <span>
#include <vector>

#include "axiometry/standards/iso230_2/parameters.h"
#include "axiometry/standards/iso230_2/scatter/run_tilts.h"

namespace axiometry::tracking {
namespace {

constexpr double slopes_by_chance = 0.2;  // a slope is nothing else: asked for less, slopes would be missed that matter

struct Mean {
  double position_mm = 0.0;
  double deviation_um = 0.0;
  double weight = 0.0;
  double variance_um2 = 0.0;  // variance of the mean, from repetition
  double per_freedom = 0.0;   // Σ of the squares of the parts of this variance over their degrees of freedom
};

double mean_variance(const std::optional<Deviation>& s, std::size_t count) {
  return s && count > 0 ? s->in_native() * s->in_native() / static_cast<double>(count) : 0.0;
}

double per_freedom(double variance, std::size_t count) {
  return count > 1 ? variance * variance / static_cast<double>(count - 1) : 0.0;
}

std::vector<Mean> means_of(std::span<const iso230_2::PositionResult> positions) {
  const bool both = std::ranges::any_of(positions, [](const auto& p) { return p.mean.has_value(); });
  std::vector<Mean> means;
  for (const auto& p : positions) {
    const double up = mean_variance(p.s_up, p.count_up), down = mean_variance(p.s_down, p.count_down);
    const double up_share = per_freedom(up, p.count_up), down_share = per_freedom(down, p.count_down);
    const auto count = static_cast<double>(p.count_up + p.count_down);
    const double at = p.target.in_native();
    if (both && p.mean)
      means.push_back({at, p.mean->in_native(), count, 0.25 * (up + down), 0.0625 * (up_share + down_share)});
    if (both) continue;
    if (p.mean_up) means.push_back({at, p.mean_up->in_native(), count, up, up_share});
    if (p.mean_down) means.push_back({at, p.mean_down->in_native(), count, down, down_share});
  }
  return means;
}

/// Where chance hardly makes the slopes of the runs differ as they do, what these let the mean of them be uncertain by,
/// if that is more. s_i of the readings hold these slopes too, but not what of them is common to all targets of a run.
SlopeFit with_runs(const SlopeFit& of_readings, const Series& series) {
  const iso230_2::TiltStudy tilts = iso230_2::tilt_study(series);
  if (tilts.p > slopes_by_chance) return of_readings;
  const double of_runs = 1000.0 * std::sqrt(tilts.variance / static_cast<double>(tilts.runs)) / series.travel_native();
  if (!(of_runs > of_readings.uncertainty_um_per_m)) return of_readings;
  return {of_readings.slope_um_per_m, of_runs, tilts.degrees()};
}

}  // namespace

SlopeFit fit_slope(const Series& series) {
  const std::vector<Mean> means = means_of(iso230_2::evaluate_positions(series));
  double weight = 0.0, position = 0.0, deviation = 0.0;
  for (const Mean& m : means) {
    weight += m.weight;
    position += m.weight * m.position_mm;
    deviation += m.weight * m.deviation_um;
  }
  position /= weight;
  deviation /= weight;
  double squares = 0.0, products = 0.0, repetition = 0.0, per_degree = 0.0;
  for (const Mean& m : means) {
    const double p = m.position_mm - position;
    squares += m.weight * p * p;
    products += m.weight * p * (m.deviation_um - deviation);
    const double share = m.weight * m.weight * p * p;
    repetition += share * m.variance_um2;
    per_degree += share * share * m.per_freedom;
  }
  if (!(squares > 0.0)) return {};
  const double slope = products / squares;
  double residuals = 0.0;
  for (const Mean& m : means) {
    const double r = m.deviation_um - deviation - slope * (m.position_mm - position);
    residuals += m.weight * r * r;
  }
  const double repeated = repetition / (squares * squares);
  const double left = means.size() > 2 ? static_cast<double>(means.size() - 2) : 0.0;
  const double scattered = left > 0.0 ? residuals / left / squares : 0.0;
  SlopeFit fit{1000.0 * slope, 1000.0 * std::sqrt(repeated)};
  if (per_degree > 0.0) fit.degrees_of_freedom = repetition * repetition / per_degree;
  fit = with_runs(fit, series);
  const SlopeFit about_line{fit.slope_um_per_m, 1000.0 * std::sqrt(scattered), left};
  return about_line.uncertainty_um_per_m > fit.uncertainty_um_per_m ? about_line : fit;
}

}  // namespace axiometry::tracking
