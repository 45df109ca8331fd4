// SPDX-License-Identifier: Apache-2.0
#include "axiometry/compensation/prediction.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <utility>
#include <vector>

#include "axiometry/numeric/moments.h"

namespace axiometry::compensation {
namespace {

constexpr std::array both_directions{Direction::up, Direction::down};

/// The series with something else at every target and direction: f(target index, direction) is added to its readings.
template <typename Added>
Result<Series> shifted(const Series& series, const Added& added) {
  const std::size_t m = series.target_count(), n = series.run_count();
  std::vector<double> deviations;
  deviations.reserve(2 * m * n);
  for (const Direction direction : both_directions)
    for (std::size_t i = 0; i < m; ++i) {
      const double by = added(i, direction);
      for (const double x : series.cell(i, direction)) deviations.push_back(x + by);
    }
  return Series::make_dense({series.targets().begin(), series.targets().end()}, n, std::move(deviations));
}

double change_at(double position, Direction direction, const AxisCorrection& added, const AxisCorrection* removed) {
  return added.at(position, direction) - (removed ? removed->at(position, direction) : 0.0);
}

}  // namespace

Result<Series> shifted_series(const Series& series, const std::function<double(double, Direction)>& added) {
  return shifted(series,
                 [&](std::size_t i, Direction direction) { return added(series.targets()[i].in_native(), direction); });
}

Result<Series> corrected_series(const Series& series, const AxisCorrection& added, const AxisCorrection* removed) {
  return shifted_series(
      series, [&](double position, Direction direction) { return change_at(position, direction, added, removed); });
}

Result<Series> scatter_alone(const Series& series) {
  return shifted(series,
                 [&](std::size_t i, Direction direction) { return -numeric::moments(series.cell(i, direction)).mean; });
}

std::optional<Effect> effect_of_table(const Series& before, const Series& after, const AxisCorrection& added,
                                      const AxisCorrection* removed, double same_target_native) {
  struct Pair {
    double wanted, found, variance;
  };
  std::vector<Pair> pairs;
  std::map<double, Pair> reversals;  // by position: ↑ less ↓
  std::map<double, int> directions;
  for (const Direction direction : both_directions) {
    std::size_t j = 0;
    for (std::size_t i = 0; i < before.target_count(); ++i) {
      const double position = before.targets()[i].in_native();
      while (j < after.target_count() && after.targets()[j].in_native() < position - same_target_native) ++j;
      if (j == after.target_count() || after.targets()[j].in_native() > position + same_target_native) continue;
      const numeric::Moments a = numeric::moments(before.cell(i, direction));
      const numeric::Moments b = numeric::moments(after.cell(j, direction));
      if (a.count == 0 || b.count == 0) continue;
      const double scatter = a.standard_deviation * a.standard_deviation / static_cast<double>(a.count) +
                             b.standard_deviation * b.standard_deviation / static_cast<double>(b.count);
      pairs.push_back({change_at(position, direction, added, removed), b.mean - a.mean, scatter});
      const double sign = direction == Direction::up ? 1.0 : -1.0;
      Pair& reversal = reversals[position];
      reversal = {reversal.wanted + sign * pairs.back().wanted, reversal.found + sign * pairs.back().found,
                  reversal.variance + scatter};
      ++directions[position];
    }
  }
  if (pairs.size() < 3) return std::nullopt;
  const auto count = static_cast<double>(pairs.size());
  double wanted_mean = 0.0, found_mean = 0.0;
  for (const Pair& p : pairs) wanted_mean += p.wanted / count, found_mean += p.found / count;
  double ww = 0.0, wf = 0.0, ff = 0.0, scatter = 0.0;
  for (const Pair& p : pairs) {
    const double w = p.wanted - wanted_mean, f = p.found - found_mean;
    ww += w * w, wf += w * f, ff += f * f;
    scatter += p.variance * w * w;
  }
  if (!(ww > 0.0)) return std::nullopt;
  Effect effect;
  effect.share = wf / ww;
  const double left = std::max(0.0, ff - effect.share * wf);
  effect.u = std::sqrt(std::max(scatter / (ww * ww), left / (count - 2.0) / ww));
  effect.explained = ff > 0.0 ? 1.0 - left / ff : 1.0;
  effect.compared = pairs.size();
  double rr = 0.0, rf = 0.0, rv = 0.0;
  for (const auto& [position, reversal] : reversals) {
    if (directions[position] != 2) continue;
    rr += reversal.wanted * reversal.wanted;
    rf += reversal.wanted * reversal.found;
    rv += reversal.wanted * reversal.wanted * reversal.variance;
  }
  constexpr double known_most = 0.15;  // standard uncertainty of γ
  if (rr > 0.0 && std::sqrt(rv) / rr < known_most) effect.of_reversal = rf / rr;
  return effect;
}

}  // namespace axiometry::compensation
