// SPDX-License-Identifier: Apache-2.0
#include "axiometry/capture/values/still_values.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include "axiometry/base/counted.h"
#include "axiometry/base/text/number_text.h"
#include "axiometry/capture/cell.h"
#include "axiometry/numeric/median.h"

namespace axiometry::capture {
namespace {

constexpr std::size_t quarters = 4;
constexpr double greatest_share = 10.0;

using Quarters = std::array<SampleCell, quarters>;

Quarters quarters_of(std::span<const Sample> samples, double floor) {
  CellMaker maker;
  Quarters cells;
  double noise = 0.0;
  for (std::size_t k = 0; k < quarters; ++k) {
    const std::size_t begin = k * samples.size() / quarters, end = (k + 1) * samples.size() / quarters;
    const auto part = samples.subspan(begin, end - begin);
    cells[k] = maker.make(part, sums_of(part), noise, floor);
    noise = std::max(noise, cells[k].scale);
  }
  return cells;
}

/// The smallest step between two samples that differ; 0 where all are alike.
double quantum_of(std::span<const Sample> samples) {
  double least = 0.0;
  for (std::size_t k = 1; k < samples.size(); ++k) {
    const double step = std::abs(samples[k].position - samples[k - 1].position);
    if (step > 0.0 && (least <= 0.0 || step < least)) least = step;
  }
  return least;
}

double threshold_of(const Quarters& cells, double quantum, const StillOptions& options) {
  if (options.threshold) return *options.threshold;
  std::vector<double> noises;
  for (const SampleCell& cell : cells) noises.push_back(cell.standard_deviation);
  return rest_threshold(quantum, std::move(noises), {options.smallest, greatest_share * options.smallest});
}

double slope_of(const Quarters& cells) {
  double t = 0.0, x = 0.0, tt = 0.0, tx = 0.0;
  for (const SampleCell& cell : cells) {
    t += cell.mean_time_s / quarters;
    x += cell.mean / quarters;
  }
  for (const SampleCell& cell : cells) {
    tt += (cell.mean_time_s - t) * (cell.mean_time_s - t);
    tx += (cell.mean_time_s - t) * (cell.mean - x);
  }
  return tt > 0.0 ? tx / tt : 0.0;
}

}  // namespace

Result<StillValue> still_value(std::span<const Sample> samples, const StillOptions& options) {
  if (samples.size() < samples_to_judge)
    return fail(fmt::format("found {}, expected at least {} to tell whether they stand still",
                            counted(samples.size(), "sample"), samples_to_judge));
  const double quantum = quantum_of(samples);
  const Quarters cells = quarters_of(samples, std::max(0.5 * options.smallest, quantum));
  const auto [lowest, highest] = std::ranges::minmax(cells, {}, &SampleCell::mean);
  const double range = highest.mean - lowest.mean;
  const double threshold = threshold_of(cells, quantum, options);
  if (range > threshold)
    return fail(fmt::format("found means that range over {} {}, expected {} at most", format_fixed(range, 2),
                            options.unit, format_fixed(threshold, 2)));
  StillValue still{.from_s = samples.front().time_s, .to_s = samples.back().time_s};
  double sum = 0.0;
  for (const SampleCell& cell : cells) {
    still.count += cell.count;
    still.rejected += cell.rejected;
    sum += static_cast<double>(cell.count) * cell.mean;
  }
  still.value = sum / static_cast<double>(still.count);
  double squares = 0.0;
  for (const SampleCell& cell : cells) {
    const auto n = static_cast<double>(cell.count);
    squares += (n - 1.0) * cell.standard_deviation * cell.standard_deviation +
               n * (cell.mean - still.value) * (cell.mean - still.value);
  }
  still.spread = std::sqrt(squares / static_cast<double>(still.count - 1));
  still.drift = slope_of(cells) * (still.to_s - still.from_s);
  return still;
}

}  // namespace axiometry::capture
