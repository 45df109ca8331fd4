// SPDX-License-Identifier: Apache-2.0
#include "axiometry/capture/cell.h"

#include <algorithm>
#include <cmath>
#include <cstring>

#include "axiometry/base/contract.h"
#include "axiometry/numeric/median.h"

namespace axiometry::capture {
namespace {

/// Time and position of one sample side by side, so that one instruction works on both.
typedef double Pair __attribute__((vector_size(16)));
static_assert(sizeof(Sample) == sizeof(Pair));

Pair load(const Sample& sample) {
  Pair pair;
  std::memcpy(&pair, &sample, sizeof pair);
  return pair;
}

Pair larger(Pair a, Pair b) { return a > b ? a : b; }
Pair smaller(Pair a, Pair b) { return a < b ? a : b; }

constexpr double mad_to_deviation = 1.4826;  // 1/Φ⁻¹(3/4): MAD of normal noise to its standard deviation
constexpr double rejection = 8.0;
constexpr double suspicion = 5.0;
constexpr std::size_t always_searched = 40;  // below, one outlier cannot stand 5 standard deviations out
constexpr std::size_t always_trusted = 16;
constexpr std::size_t one_of = 10;

}  // namespace

CellSums sums_of(std::span<const Sample> samples) {
  AXIOMETRY_CONTRACT(!samples.empty());
  const std::size_t n = samples.size();
  const Pair origin = load(samples[0]);
  Pair sum[2] = {}, squares[2] = {}, lowest[2] = {}, highest[2] = {}, longest[2] = {}, shortest[2] = {};
  const auto add = [&](std::size_t k, std::size_t lane) {
    const Pair x = load(samples[k]);
    const Pair step = x - load(samples[k - 1]);
    const Pair d = x - origin;
    sum[lane] += d;
    squares[lane] += d * d;
    lowest[lane] = smaller(lowest[lane], d);
    highest[lane] = larger(highest[lane], d);
    longest[lane] = larger(longest[lane], step);
    shortest[lane] = smaller(shortest[lane], step);
  };
  std::size_t k = 1;
  for (; k + 1 < n; k += 2) {
    add(k, 0);
    add(k + 1, 1);
  }
  if (k < n) add(k, 0);
  const Pair total = sum[0] + sum[1];
  AXIOMETRY_CONTRACT(std::isfinite(total[0]) && std::isfinite(total[1]) && std::isfinite(origin[1]));
  AXIOMETRY_CONTRACT(smaller(shortest[0], shortest[1])[0] >= 0.0);
  const auto count = static_cast<double>(n);
  const double offset = total[1] / count;
  const double variance = n > 1 ? ((squares[0] + squares[1])[1] - offset * total[1]) / (count - 1.0) : 0.0;
  return {.mean = origin[1] + offset,
          .standard_deviation = std::sqrt(std::max(variance, 0.0)),
          .lowest = origin[1] + smaller(lowest[0], lowest[1])[1],
          .highest = origin[1] + larger(highest[0], highest[1])[1],
          .mean_time_s = origin[0] + total[0] / count,
          .longest_step_s = larger(longest[0], longest[1])[0]};
}

SampleCell CellMaker::make(std::span<const Sample> samples, const CellSums& sums, double noise, double floor) {
  SampleCell cell{.begin_s = samples.front().time_s,
                  .end_s = samples.back().time_s,
                  .mean_time_s = sums.mean_time_s,
                  .count = samples.size(),
                  .rejected = 0,
                  .mean = sums.mean,
                  .standard_deviation = sums.standard_deviation,
                  .scale = sums.standard_deviation,
                  .lowest = sums.lowest,
                  .highest = sums.highest};
  const double farthest = std::max(sums.highest - sums.mean, sums.mean - sums.lowest);
  if (samples.size() >= always_searched && farthest <= suspicion * sums.standard_deviation) return cell;
  positions_.clear();
  for (const Sample& s : samples) positions_.push_back(s.position);
  const double middle = numeric::median_of(positions_);
  distances_.clear();
  for (double x : positions_) distances_.push_back(std::abs(x - middle));
  cell.scale = mad_to_deviation * numeric::median_of(distances_);
  const double limit = rejection * std::max({cell.scale, floor, samples.size() < always_trusted ? noise : 0.0});
  if (std::max(sums.highest - middle, middle - sums.lowest) <= limit) return cell;
  std::erase_if(positions_, [&](double x) { return std::abs(x - middle) > limit; });
  const std::size_t rejected = samples.size() - positions_.size();
  if (rejected > std::max<std::size_t>(1, samples.size() / one_of) || positions_.size() < 2) return cell;
  double sum = 0.0, squares = 0.0;
  for (double x : positions_) sum += x - middle;
  const double offset = sum / static_cast<double>(positions_.size());
  for (double x : positions_) squares += (x - middle - offset) * (x - middle - offset);
  cell.count = positions_.size();
  cell.rejected = rejected;
  cell.mean = middle + offset;
  cell.standard_deviation = std::sqrt(squares / static_cast<double>(positions_.size() - 1));
  cell.lowest = std::ranges::min(positions_);
  cell.highest = std::ranges::max(positions_);
  return cell;
}

double rest_threshold(double quantum, std::vector<double> standard_deviations, const RestLimits& limits) {
  constexpr double noise_factor = 6.0, quantum_factor = 1.5;  // derivation in docs/theory/capture.md
  const double noise = numeric::median(std::move(standard_deviations));
  return std::min(limits.greatest, std::max({limits.smallest, quantum_factor * quantum, noise_factor * noise}));
}

}  // namespace axiometry::capture
