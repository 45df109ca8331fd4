// SPDX-License-Identifier: Apache-2.0
#include "axiometry/uncertainty/sampled_distribution.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <span>

#include "axiometry/base/contract.h"

namespace axiometry::uncertainty {
namespace {

using Cell = SampledDistribution::Cell;

constexpr std::size_t steps = 400;  // of the lower probability a, from 0 to 1 − p
constexpr std::size_t reach = 60;   // of the parabola, on either side

/// Where the parabola through the lengths from `first` on, in least squares, is lowest; `least` when it is not convex.
/// The result stays between the first and the last of them.
double vertex(std::span<const double> lengths, std::size_t first, std::size_t least) {
  const double centre = static_cast<double>(lengths.size() - 1) / 2;
  double s0 = 0, s2 = 0, s4 = 0, t0 = 0, t1 = 0, t2 = 0;
  for (std::size_t i = 0; i < lengths.size(); ++i) {
    const double x = static_cast<double>(i) - centre, y = lengths[i] - lengths[least - first];
    s0 += 1;
    s2 += x * x;
    s4 += x * x * x * x;
    t0 += y;
    t1 += x * y;
    t2 += x * x * y;
  }
  const double curvature = (t2 * s0 - t0 * s2) / (s4 * s0 - s2 * s2);
  if (!(curvature > 0.0)) return static_cast<double>(least);
  const double x = std::clamp(-t1 / s2 / (2 * curvature), -centre, centre);
  return static_cast<double>(first) + centre + x;
}

}  // namespace

SampledDistribution::SampledDistribution(std::vector<Cell> cells) : cells_(std::move(cells)) {
  std::uint64_t below = 0;
  for (std::size_t i = 0; i < cells_.size(); ++i) {
    AXIOMETRY_CONTRACT(cells_[i].lower <= cells_[i].upper && (i == 0 || cells_[i - 1].upper <= cells_[i].lower));
    AXIOMETRY_CONTRACT(cells_[i].count > 0 && cells_[i].below == below);
    below += cells_[i].count;
  }
}

std::uint64_t SampledDistribution::trials() const {
  return cells_.empty() ? 0 : cells_.back().below + cells_.back().count;
}

double SampledDistribution::probability_below(double x) const {
  AXIOMETRY_CONTRACT(!cells_.empty());
  const auto after = std::ranges::upper_bound(cells_, x, {}, &Cell::lower);
  if (after == cells_.begin()) return 0.0;
  const Cell& cell = *std::prev(after);
  const double share = x >= cell.upper ? 1.0 : (x - cell.lower) / (cell.upper - cell.lower);
  return (static_cast<double>(cell.below) + share * static_cast<double>(cell.count)) / static_cast<double>(trials());
}

double SampledDistribution::quantile(double p) const {
  AXIOMETRY_CONTRACT(!cells_.empty() && p >= 0.0 && p <= 1.0);
  const double rank = p * static_cast<double>(trials());
  const auto begins_below = [rank](const Cell& cell) { return static_cast<double>(cell.below) < rank; };
  const auto after = std::ranges::partition_point(cells_, begins_below);
  if (after == cells_.begin()) return cells_.front().lower;
  const Cell& cell = *std::prev(after);
  const double share = (rank - static_cast<double>(cell.below)) / static_cast<double>(cell.count);
  return share >= 1.0 ? cell.upper : cell.lower + share * (cell.upper - cell.lower);
}

double SampledDistribution::quantile_error(double p) const {
  const double rank_sd = std::sqrt(p * (1.0 - p) / static_cast<double>(trials()));
  return (quantile(std::min(p + rank_sd, 1.0)) - quantile(std::max(p - rank_sd, 0.0))) / 2;
}

double SampledDistribution::fourth_moment(double centre) const {
  AXIOMETRY_CONTRACT(!cells_.empty());
  double sum = 0.0;
  for (const Cell& cell : cells_) {
    const double x = cell.lower + (cell.upper - cell.lower) / 2 - centre;
    sum += static_cast<double>(cell.count) * (x * x) * (x * x);
  }
  return sum / static_cast<double>(trials());
}

Interval SampledDistribution::symmetric_interval(double coverage) const {
  return {quantile((1.0 - coverage) / 2), quantile((1.0 + coverage) / 2)};
}

Interval SampledDistribution::shortest_interval(double coverage) const {
  const auto interval = [&](double step) {
    const double a = (1.0 - coverage) * step / steps;
    return Interval{quantile(a), quantile(std::min(a + coverage, 1.0))};
  };
  std::vector<double> lengths;
  for (std::size_t k = 0; k <= steps; ++k) {
    const Interval i = interval(static_cast<double>(k));
    lengths.push_back(i.upper - i.lower);
  }
  const auto least = static_cast<std::size_t>(std::ranges::min_element(lengths) - lengths.begin());
  // Half way to the ends at most: there the extremes of the trials scatter. A minimum at an end itself is no vertex,
  // the density drops to nothing there.
  const std::size_t side = std::min({reach, least / 2, (steps - least) / 2});
  if (side < 3) return interval(static_cast<double>(least));
  return interval(vertex(std::span(lengths).subspan(least - side, 2 * side + 1), least - side, least));
}

}  // namespace axiometry::uncertainty
