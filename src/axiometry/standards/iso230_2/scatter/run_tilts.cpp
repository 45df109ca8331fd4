// SPDX-License-Identifier: Apache-2.0
#include "axiometry/standards/iso230_2/scatter/run_tilts.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <utility>

#include "axiometry/standards/iso230_2/scatter/scatter.h"
#include "axiometry/standards/iso230_2/scatter/tilts_between.h"
#include "axiometry/standards/iso230_2/scatter/variance_ratio.h"

namespace axiometry::iso230_2 {
namespace {

constexpr double tilts_worth_a_word = 0.25;  // variance of readings by tilts, on average, divided by what is left
constexpr double least_rows = 3.0;           // of fewer targets a slope and scatter look alike
constexpr double no_tilt = std::numeric_limits<double>::quiet_NaN();

/// Slopes of the runs of one direction, of what is left beside levels and shifts.
struct TiltFit {
  std::vector<double> tilts;    ///< NaN of a run with too few targets
  std::vector<double> weights;  ///< Σ of the squares of the levers about their middle: a tilt scatters by s²/weight
  std::vector<double> middles;  ///< mean lever of the targets that the run has
  double squares = 0.0;         ///< what the slopes explain of the squares of the residuals
  double runs = 0.0;            ///< how many have a slope
};

TiltFit fit_tilts(const numeric::AdditiveFit& fit, std::span<const double> levers) {
  TiltFit result{std::vector<double>(fit.columns, no_tilt), std::vector<double>(fit.columns, 0.0),
                 std::vector<double>(fit.columns, 0.0)};
  for (std::size_t j = 0; j < fit.columns; ++j) {
    double count = 0.0, middle = 0.0, residual = 0.0;
    for (std::size_t i = 0; i < levers.size(); ++i)
      if (const double r = fit.row(i)[j]; !std::isnan(r)) count += 1.0, middle += levers[i], residual += r;
    if (count < least_rows) continue;
    result.middles[j] = middle / count;
    double squares = 0.0, products = 0.0;
    for (std::size_t i = 0; i < levers.size(); ++i)
      if (const double r = fit.row(i)[j]; !std::isnan(r)) {
        const double lever = levers[i] - result.middles[j];
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

/// A run, of the directions that it has a slope in.
struct RunTilt {
  std::array<std::optional<std::size_t>, 2> runs;  ///< ↑ and ↓
  double tilt = 0.0;
  double per_variance = 0.0;  ///< variance of the tilt by that of a reading
};

/// ↑ and ↓ of a run together.
std::vector<RunTilt> both_directions(const std::array<TiltFit, 2>& fits) {
  std::array<std::vector<RunTilt>, 2> of;
  std::vector<RunTilt> all;
  const auto mean = [](const RunTilt& a, const RunTilt& b) {
    return RunTilt{{a.runs[0], b.runs[1]}, 0.5 * (a.tilt + b.tilt), 0.25 * (a.per_variance + b.per_variance)};
  };
  bool have_both = false;
  for (std::size_t j = 0; j < fits[0].tilts.size(); ++j) {
    std::size_t directions = 0;
    for (std::size_t d = 0; d < 2; ++d)
      if (const double tilt = fits[d].tilts[j]; !std::isnan(tilt)) {
        of[d].push_back({{}, tilt, 1.0 / fits[d].weights[j]});
        of[d].back().runs[d] = j;
        all.push_back(of[d].back());
        ++directions;
      }
    if (directions < 2) continue;
    have_both = true;
    all.pop_back();
    all.back() = mean(of[0].back(), of[1].back());
  }
  if (have_both || of[0].size() != of[1].size()) return all;
  all.clear();  // each direction has numbers of its own
  for (std::size_t k = 0; k < of[0].size(); ++k) all.push_back(mean(of[0][k], of[1][k]));
  return all;
}

std::array<TiltFit, 2> fits_of_directions(const scatter::DirectionFits& fits, std::span<const double> levers) {
  return {fit_tilts(fits[0], levers), fit_tilts(fits[1], levers)};
}

}  // namespace

/// The tilts against what is left beside level, shift and slope of each direction.
TiltStudy scatter::tilt_study(const DirectionFits& fits, std::span<const double> levers, const Rounding& rounding,
                              double level) {
  const std::array<TiltFit, 2> of = fits_of_directions(fits, levers);
  const std::vector<RunTilt> all = both_directions(of);
  TiltStudy study{.runs = all.size()};
  Sum within;
  double readings = 0.0, levers_squared = 0.0;
  for (std::size_t d = 0; d < 2; ++d) {
    within.squares += std::max(0.0, fits[d].squares - of[d].squares);
    within.degrees += fits[d].degrees - std::max(0.0, of[d].runs - 1.0);
    readings += static_cast<double>(fits[d].count);
    for (const double weight : of[d].weights) levers_squared += weight;
  }
  if (all.size() < 2 || within.degrees < 1.0) return study;
  double weight = 0.0, mean = 0.0, per_variance = 0.0;
  for (const RunTilt& t : all) {
    weight += 1.0 / t.per_variance, mean += t.tilt / t.per_variance;
    per_variance += t.per_variance / static_cast<double>(all.size());
  }
  mean /= weight;
  Sum between{0.0, study.degrees()};
  for (const RunTilt& t : all) {
    const double beside = t.tilt - mean;
    between.squares += beside * beside / t.per_variance;
    study.variance += beside * beside / study.degrees();
    if (std::abs(beside) > std::abs(study.farthest_tilt)) study.farthest = t.runs, study.farthest_tilt = beside;
  }
  const double noise = std::max(within.variance(), rounding.variance());
  study.of_scatter = per_variance * noise;
  double per_variance_each = 0.0, tilts = 0.0;
  for (const TiltFit& fit : of)
    for (const double w : fit.weights)
      if (w > 0.0) per_variance_each += 1.0 / w, tilts += 1.0;
  study.of_scatter_each = per_variance_each / tilts * noise;
  study.within = std::sqrt(within.variance());
  study.in_readings = std::max(0.0, study.variance - study.of_scatter) * levers_squared / readings;
  study.p = ratio_tail(between, within, rounding, level);
  const Sum of_each{of[0].squares + of[1].squares, std::max(0.0, of[0].runs - 1.0) + std::max(0.0, of[1].runs - 1.0)};
  study.p_of_each = ratio_tail(of_each, within, rounding, level);
  return study;
}

std::optional<TiltStudy> scatter::tilts_between(const DirectionFits& fits, std::span<const double> levers,
                                                const Rounding& rounding) {
  const TiltStudy study = tilt_study(fits, levers, rounding, tilt_level);
  const double noise = std::max(study.within * study.within, rounding.variance());
  if (study.p > tilt_level || study.in_readings < tilts_worth_a_word * noise || !(study.in_readings > 0.0))
    return std::nullopt;
  return study;
}

scatter::Tables scatter::untilted(Tables tables, Tables seen, std::span<const double> levers, std::size_t runs) {
  constexpr int sweeps = 20;  // one is exact where no reading lacks
  constexpr double settled = 1e-9;
  for (int sweep = 0; sweep < sweeps; ++sweep) {
    const DirectionFits fits = fits_of(seen, runs);
    double largest = 0.0;
    for (std::size_t d = 0; d < 2; ++d) {
      const TiltFit own = fit_tilts(fits[d], levers);
      for (std::size_t k = 0; k < seen[d].size(); ++k)
        if (const double tilt = own.tilts[k % runs]; !std::isnan(tilt)) {
          const double there = tilt * (levers[k / runs] - own.middles[k % runs]);
          seen[d][k] -= there;
          tables[d][k] -= there;
          largest = std::max(largest, std::abs(tilt));
        }
    }
    if (largest < settled) break;
  }
  return tables;
}

TiltStudy tilt_study(const Series& series) {
  const scatter::DirectionFits fits = scatter::fits_of(scatter::tables_of(series), series.run_count());
  return scatter::tilt_study(fits, tilt_levers(series), {step_of(series)});
}

std::vector<double> tilt_levers(const Series& series) {
  std::vector<double> levers;
  double sum = 0.0;
  for (const Position& target : series.targets()) levers.push_back(target.in_native()), sum += levers.back();
  const double middle = sum / static_cast<double>(levers.size()), range = series.travel_native();
  for (double& lever : levers) lever = range > 0.0 ? (lever - middle) / range : 0.0;
  return levers;
}

std::array<std::vector<double>, 2> direction_tilts(const Series& series) {
  const scatter::DirectionFits fits = scatter::fits_of(scatter::tables_of(series), series.run_count());
  std::array<TiltFit, 2> of = fits_of_directions(fits, tilt_levers(series));
  return {std::move(of[0].tilts), std::move(of[1].tilts)};
}

Series without_tilts(const Series& series) {
  const scatter::Tables tables = scatter::tables_of(series);
  return scatter::series_of(series, scatter::untilted(tables, tables, tilt_levers(series), series.run_count()));
}

}  // namespace axiometry::iso230_2
