// SPDX-License-Identifier: Apache-2.0
#include "axiometry/volumetric/identify/anomalies.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "axiometry/numeric/distributions/chi_square.h"
#include "axiometry/numeric/distributions/normal_and_student_t.h"

namespace axiometry::volumetric::detail {
namespace {

constexpr double clipped_at = 4.0;
constexpr std::size_t least_on_a_side = 3;

/// Readings that count, of each stretch in order.
std::vector<std::vector<std::size_t>> by_stretch(const Problem& problem) {
  std::vector<std::vector<std::size_t>> readings(problem.unknowns.stretches.size());
  for (std::size_t i = 0; i < problem.readings.size(); ++i)
    if (problem.weights[i] > 0.0) readings[problem.unknowns.stretch_of[i]].push_back(i);
  return readings;
}

struct Normalised {
  const Problem& problem;
  std::span<const double> residuals;
  double scale;

  double operator()(std::size_t i) const {
    return std::clamp(std::sqrt(problem.weights[i]) * residuals[i] / scale, -clipped_at, clipped_at);
  }
};

/// What a straight line takes of the sum of squares.
double line_statistic(std::span<const std::size_t> readings, const Normalised& z) {
  const double n = static_cast<double>(readings.size());
  if (readings.size() < 3) return 0.0;
  double sum = 0.0;
  for (std::size_t k = 0; k < readings.size(); ++k) sum += z(readings[k]) * (static_cast<double>(k) - 0.5 * (n - 1.0));
  return sum * sum / (n * (n * n - 1.0) / 12.0);
}

double mean_residual(std::span<const std::size_t> readings, std::span<const double> residuals) {
  double sum = 0.0;
  for (const std::size_t i : readings) sum += residuals[i];
  return sum / static_cast<double>(readings.size());
}

/// What a stretch says of the length at one of its ends.
struct SaidAtEnd {
  std::size_t readings = 0;  ///< readings that count
  double variance_um2 = 0.0;
};

/// By its readings that count: their mean, or where stretches drift the straight line at that end:
/// 1/Σw + (x − x̄)²/Σw(x_i − x̄)², of many readings four times that of the mean. Infinite where there are too few.
SaidAtEnd said_at_end(const Problem& problem, std::span<const std::size_t> readings, double along) {
  SaidAtEnd said{0, std::numeric_limits<double>::infinity()};
  double weight = 0.0, first = 0.0, second = 0.0;
  for (const std::size_t i : readings) {
    const double off = problem.unknowns.along_stretch[i] - along;
    weight += problem.weights[i];
    first += problem.weights[i] * off;
    second += problem.weights[i] * off * off;
    ++said.readings;
  }
  if (said.readings < (problem.unknowns.drift ? 2u : 1u)) return said;
  said.variance_um2 = 1.0 / weight;
  if (problem.unknowns.drift) said.variance_um2 = second / (weight * second - first * first);
  return said;
}

/// The jump squared over what clearest_break() asks for, in variances as stated: 1 and more is clear.
double share_of_clear(const Problem& problem, const State& state, std::span<const std::vector<std::size_t>> readings,
                      std::size_t before) {
  const Unknowns& unknowns = problem.unknowns;
  const SaidAtEnd from = said_at_end(problem, readings[stretch_before(unknowns, before)], 0.5);
  const SaidAtEnd to = said_at_end(problem, readings[unknowns.stretch_of[before]], -0.5);
  const double jump = jump_um(unknowns, state, before);
  return jump * jump / (break_limit(from.readings + to.readings) * (from.variance_um2 + to.variance_um2));
}

}  // namespace

/// By chance of n normalised residuals less than once in 10⁵ stretches.
double break_limit(std::size_t readings) { return 30.0 + 4.0 * std::log(static_cast<double>(readings)); }

std::size_t stretch_before(const Unknowns& unknowns, std::size_t reading) {
  const BeamStretch& own = unknowns.stretches[unknowns.stretch_of[reading]];
  std::size_t last = reading;
  while (last-- > 0) {
    const BeamStretch& other = unknowns.stretches[unknowns.stretch_of[last]];
    if (other.virtual_station == own.virtual_station && other.segment == own.segment) break;
  }
  return unknowns.stretch_of[last];
}

std::optional<BreakSuspected> clearest_break(const Problem& problem, std::span<const double> residuals) {
  const Normalised z{problem, residuals, robust_scale(problem, residuals)};
  std::optional<BreakSuspected> clearest;
  for (const auto& readings : by_stretch(problem)) {
    const std::size_t n = readings.size();
    if (n < 2 * least_on_a_side) continue;
    double total = 0.0;
    for (const std::size_t i : readings) total += z(i);
    double sum = 0.0, best = 0.0;
    std::size_t at = 0;
    for (std::size_t k = 1; k + least_on_a_side <= n; ++k) {
      sum += z(readings[k - 1]);
      if (k < least_on_a_side) continue;
      const double share = static_cast<double>(k) / static_cast<double>(n);
      const double off = sum - share * total;
      const double statistic = off * off / (share * static_cast<double>(n - k));
      if (statistic > best) {
        best = statistic;
        at = k;
      }
    }
    if (best < break_limit(n) || best < line_statistic(readings, z)) continue;
    if (clearest && best <= clearest->statistic) continue;
    const std::span<const std::size_t> all = readings;
    clearest = {all[at], mean_residual(all.subspan(at), residuals) - mean_residual(all.first(at), residuals), best};
  }
  return clearest;
}

double jump_um(const Unknowns& unknowns, const State& state, std::size_t before) {
  const std::size_t from = stretch_before(unknowns, before), to = unknowns.stretch_of[before];
  const double drifts = unknowns.drift ? 0.5 * (state.drifts_um[from] + state.drifts_um[to]) : 0.0;
  return 1000.0 * (state.dead_paths_mm[from] - state.dead_paths_mm[to]) - drifts;
}

std::optional<std::size_t> least_clear_break(const Problem& problem, const State& state,
                                             std::span<const double> residuals, std::span<const std::size_t> breaks) {
  const double scale = robust_scale(problem, residuals);
  const auto readings = by_stretch(problem);
  std::optional<std::size_t> least;
  double least_share = 1.0;
  for (const std::size_t before : breaks) {
    const double share = share_of_clear(problem, state, readings, before) / (scale * scale);
    if (share >= least_share) continue;
    least_share = share;
    least = before;
  }
  return least;
}

double drift_chance(const Problem& problem, std::span<const double> residuals) {
  const Normalised z{problem, residuals, robust_scale(problem, residuals)};
  double sum = 0.0, degrees = 0.0;
  for (const auto& readings : by_stretch(problem)) {
    if (readings.size() < 3) continue;
    sum += line_statistic(readings, z);
    degrees += 1.0;
  }
  return degrees > 0.0 ? 1.0 - numeric::chi_square_probability(sum, degrees) : 1.0;
}

double outlier_limit(std::size_t readings) {
  return -numeric::normal_quantile(0.0005 / static_cast<double>(std::max(readings, std::size_t{1})));
}

}  // namespace axiometry::volumetric::detail
