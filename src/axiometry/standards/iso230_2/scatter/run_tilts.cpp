// SPDX-License-Identifier: Apache-2.0
#include "axiometry/standards/iso230_2/scatter/run_tilts.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numeric>

#include "axiometry/standards/iso230_2/scatter/tilts_between.h"
#include "axiometry/standards/iso230_2/scatter/variance_ratio.h"

namespace axiometry::iso230_2 {
namespace {

using numeric::AdditiveFit;

constexpr double tilts_worth_a_word = 0.25;  // variance of readings by tilts, on average, divided by what is left
constexpr double least_rows = 3.0;           // of fewer targets a slope and scatter look alike

/// Slopes of the runs of one direction, of what is left beside levels and shifts.
struct TiltFit {
  std::vector<double> tilts;    ///< over the range of the targets; NaN of a run with too few
  std::vector<double> weights;  ///< Σ of the squares of the levers about their mean
  double squares = 0.0;         ///< what the slopes explain of the squares of the residuals
  double runs = 0.0;            ///< how many have a slope
};

TiltFit fit_tilts(const AdditiveFit& fit, std::span<const double> levers) {
  TiltFit result{std::vector<double>(fit.columns, std::numeric_limits<double>::quiet_NaN()),
                 std::vector<double>(fit.columns, 0.0)};
  for (std::size_t j = 0; j < fit.columns; ++j) {
    double count = 0.0, middle = 0.0, residual = 0.0;
    for (std::size_t i = 0; i < levers.size(); ++i)
      if (const double r = fit.row(i)[j]; !std::isnan(r)) count += 1.0, middle += levers[i], residual += r;
    if (count < least_rows) continue;
    double squares = 0.0, products = 0.0;
    for (std::size_t i = 0; i < levers.size(); ++i)
      if (const double r = fit.row(i)[j]; !std::isnan(r)) {
        const double lever = levers[i] - middle / count;
        squares += lever * lever, products += lever * (r - residual / count);
      }
    if (!(squares > 0.0)) continue;
    result.tilts[j] = products / squares;
    result.weights[j] = squares;
    result.squares += products * products / squares;
    result.runs += 1.0;
  }
  return result;
}

}  // namespace

std::optional<RunTilts> scatter::tilts_between(const Fits& fits, std::span<const double> levers,
                                               const Rounding& rounding) {
  Sum between, within;
  double weights = 0.0, runs = 0.0, rows = 0.0;
  std::array<std::vector<double>, 2> tilts;
  for (std::size_t d = 0; d < 2; ++d) {
    const TiltFit fit = fit_tilts(fits[d], levers);
    tilts[d] = fit.tilts;
    if (fit.runs < 2.0) continue;
    between.squares += fit.squares;
    between.degrees += fit.runs - 1.0;
    within.squares += std::max(0.0, fits[d].squares - fit.squares);
    within.degrees += fits[d].degrees - (fit.runs - 1.0);
    weights += std::accumulate(fit.weights.begin(), fit.weights.end(), 0.0);
    runs += fit.runs;
    rows += static_cast<double>(fits[d].count);
  }
  if (between.degrees < 2.0 || within.degrees < 4.0) return std::nullopt;
  const double noise = std::max(within.variance(), rounding.variance());
  const double variance = std::max(0.0, between.variance() - noise) / (weights / runs);
  RunTilts result;
  result.p = ratio_tail(between, within, rounding, tilt_level);
  if (result.p > tilt_level || variance * weights / rows < tilts_worth_a_word * noise || !(variance > 0.0))
    return std::nullopt;
  result.between = Deviation::native(std::sqrt(variance));
  result.within = Deviation::native(std::sqrt(within.variance()));
  const std::vector<double> of_runs = means_of(tilts[0], tilts[1]);
  for (std::size_t j = 0; j < of_runs.size(); ++j)
    if (std::abs(of_runs[j]) > std::abs(result.tilt.in_native()))
      result.run = j, result.tilt = Deviation::native(of_runs[j]);
  return result;
}

std::vector<double> tilt_levers(const Series& series) {
  std::vector<double> levers;
  double sum = 0.0;
  for (const Position& target : series.targets()) levers.push_back(target.in_native()), sum += levers.back();
  const auto [least, largest] = std::ranges::minmax(levers);
  const double middle = sum / static_cast<double>(levers.size());
  for (double& lever : levers) lever = largest > least ? (lever - middle) / (largest - least) : 0.0;
  return levers;
}

std::vector<double> run_tilts(const Series& series) {
  const scatter::Fits fits = scatter::fits_of(scatter::tables_of(series), series.run_count());
  const std::vector<double> levers = tilt_levers(series);
  return scatter::means_of(fit_tilts(fits[0], levers).tilts, fit_tilts(fits[1], levers).tilts);
}

Series without_tilts(const Series& series) {
  scatter::Tables tables = scatter::tables_of(series);
  const std::size_t runs = series.run_count();
  const scatter::Fits fits = scatter::fits_of(tables, runs);
  const std::vector<double> levers = tilt_levers(series);
  for (std::size_t d = 0; d < 2; ++d) {
    const std::vector<double> tilts = fit_tilts(fits[d], levers).tilts;
    for (std::size_t k = 0; k < tables[d].size(); ++k) {
      const std::size_t run = k % runs;
      if (!std::isnan(tables[d][k]))
        tables[d][k] -= fits[d].shifts[run] + (std::isnan(tilts[run]) ? 0.0 : tilts[run] * levers[k / runs]);
    }
  }
  return scatter::series_of(series, tables);
}

}  // namespace axiometry::iso230_2
