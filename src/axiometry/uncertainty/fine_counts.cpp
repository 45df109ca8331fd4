// SPDX-License-Identifier: Apache-2.0
#include "axiometry/uncertainty/fine_counts.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <limits>
#include <numeric>

#include "axiometry/base/contract.h"
#include "axiometry/numeric/kernels/kernel_table.h"
#include "axiometry/uncertainty/summary_kernel_types.h"

namespace axiometry::uncertainty {

AXIOMETRY_KERNEL_TABLE(summary_kernel, SummaryKernel);

const SummaryKernel& summary_kernel_of(numeric::VectorTarget target) { return summary_kernel_table.of(target); }

namespace {

constexpr std::size_t above = CoreLayout::cell_count + 1;
constexpr int tail_shift = 47;  // keeps the exponent and five bits of the fraction of a distance

std::int64_t tail_number(double distance) {
  return static_cast<std::int64_t>(std::bit_cast<std::uint64_t>(distance) >> tail_shift) + 1;
}

double tail_begin(std::int64_t number) {
  return std::bit_cast<double>(static_cast<std::uint64_t>(number - 1) << tail_shift);
}

std::uint32_t sum(std::span<const std::uint32_t> counts) {
  return std::accumulate(counts.begin(), counts.end(), std::uint32_t{0});
}

SummarySums nothing_seen() {
  SummarySums sums{};
  std::ranges::fill(sums.min, std::numeric_limits<double>::infinity());
  std::ranges::fill(sums.max, -std::numeric_limits<double>::infinity());
  return sums;
}

/// By halves, as a tree.
double sum_of_lanes(std::span<const double, summary_lanes> lanes) {
  std::array<double, summary_lanes> sums;
  std::ranges::copy(lanes, sums.begin());
  for (std::size_t half = summary_lanes / 2; half > 0; half /= 2)
    for (std::size_t k = 0; k < half; ++k) sums[k] += sums[k + half];
  return sums[0];
}

ValueMoments moments_of(const SummarySums& sums, std::size_t count, double near_mean) {
  const auto n = static_cast<double>(count);
  const double s1 = sum_of_lanes(sums.first), s2 = sum_of_lanes(sums.second);
  const double squares = s2 - s1 * s1 / n;
  return {n, near_mean + s1 / n, std::isfinite(s2) ? std::max(squares, 0.0) : s2, std::ranges::min(sums.min),
          std::ranges::max(sums.max)};
}

}  // namespace

CoreLayout CoreLayout::from_first(std::span<const double> values, double coverage) {
  AXIOMETRY_CONTRACT(!values.empty());
  std::vector<double> sorted(values.begin(), values.end());
  const double outside = std::min(0.001, (1.0 - coverage) / 8) * static_cast<double>(sorted.size());
  const auto low = sorted.begin() + static_cast<std::ptrdiff_t>(outside);
  const auto high = sorted.end() - 1 - static_cast<std::ptrdiff_t>(outside);
  std::nth_element(sorted.begin(), low, sorted.end());
  double begin = *low;
  std::nth_element(low, high, sorted.end());  // may move what `low` pointed at
  double width = *high - begin;
  if (width == 0.0) {
    const auto [min, max] = std::ranges::minmax(values);
    begin = min;
    width = max - min;
  }
  width = std::max({width, std::abs(begin) * 0x1p-30, 1e-290});
  const double cell = 2.0 * width / static_cast<double>(cell_count);
  return {begin - width / 2, cell, 1.0 / cell, ValueMoments::of(values, values[0]).mean};
}

ValueMoments ValueMoments::of(std::span<const double> values, double near_mean, numeric::VectorTarget target) {
  SummarySums sums = nothing_seen();
  summary_kernel_of(target).moments(values.data(), values.size(), near_mean, sums);
  return moments_of(sums, values.size(), near_mean);
}

void ValueMoments::add(const ValueMoments& other) {
  if (count == 0.0) {
    *this = other;
    return;
  }
  const double together = count + other.count, difference = other.mean - mean;
  mean += difference * (other.count / together);
  squares += other.squares + difference * difference * (count * other.count / together);
  count = together;
  min = std::min(min, other.min);
  max = std::max(max, other.max);
}

double ValueMoments::sd() const { return count < 2.0 ? 0.0 : std::sqrt(squares / (count - 1.0)); }

ValueMoments FineCounts::add(std::span<const double> values, numeric::VectorTarget target) {
  const std::uint32_t outside = core_[0] + core_[above];
  SummarySums sums = nothing_seen();
  summary_kernel_of(target).counts(values.data(), values.size(), layout_.near_mean, sums,
                                   {layout_.lower, layout_.cells_per_unit, above, core_.data()});
  const ValueMoments moments = moments_of(sums, values.size(), layout_.near_mean);
  if (core_[0] + core_[above] != outside && std::isfinite(moments.squares)) add_tails(values);
  return moments;
}

/// The same values that the kernel finds outside, which rounds ½ to 0 and 16 384½ to the even number below.
void FineCounts::add_tails(std::span<const double> values) {
  for (const double x : values) {
    const double place = (x - layout_.lower) * layout_.cells_per_unit + 0.5;
    if (place > 0.5 && place <= static_cast<double>(above) - 0.5) continue;
    const std::int64_t number = tail_number(std::abs(x - layout_.centre()));
    ++tails_[x < layout_.centre() ? -number : number];
  }
}

void FineCounts::add(const FineCounts& other) {
  AXIOMETRY_CONTRACT(layout_.lower == other.layout_.lower && layout_.cell == other.layout_.cell);
  for (std::size_t i = 0; i < core_.size(); ++i) core_[i] += other.core_[i];
  for (const auto& [number, count] : other.tails_) tails_[number] += count;
}

void FineCounts::clear(const CoreLayout& layout) {
  layout_ = layout;
  core_.fill(0);
  tails_.clear();
}

SampledDistribution FineCounts::distribution(Interval extremes) const {
  std::vector<SampledDistribution::Cell> cells;
  cells.reserve(tails_.size() + core_.size() - static_cast<std::size_t>(std::ranges::count(core_, 0u)));
  const auto append = [&cells](double lower, double upper, std::uint64_t count) {
    if (count == 0) return;
    const std::uint64_t below = cells.empty() ? 0 : cells.back().below + cells.back().count;
    if (!cells.empty()) lower = std::max(lower, cells.back().upper);
    cells.push_back({lower, std::max(lower, upper), below, count});
  };
  const double centre = layout_.centre();
  const double core_end = layout_.edge(CoreLayout::cell_count);
  auto tail = tails_.begin();
  for (; tail != tails_.end() && tail->first < 0; ++tail)
    append(centre - tail_begin(-tail->first + 1), std::min(centre - tail_begin(-tail->first), layout_.lower),
           tail->second);
  for (std::size_t i = 1; i < above; ++i) append(layout_.edge(i - 1), layout_.edge(i), core_[i]);
  for (; tail != tails_.end(); ++tail)
    append(std::max(centre + tail_begin(tail->first), core_end), centre + tail_begin(tail->first + 1), tail->second);
  if (cells.empty()) return {};
  // An extreme on the edge between two cells may, by rounding, have been counted in the one that it is not in.
  for (auto& cell : cells) {
    cell.lower = std::clamp(cell.lower, extremes.lower, extremes.upper);
    cell.upper = std::clamp(cell.upper, extremes.lower, extremes.upper);
  }
  cells.front().lower = extremes.lower;
  cells.back().upper = extremes.upper;
  return SampledDistribution(std::move(cells));
}

double FineCounts::quantile(double rank, Interval extremes) const {
  constexpr std::size_t stride = 64;
  static_assert(CoreLayout::cell_count % stride == 0);
  double below = core_[0];
  if (rank > below) {
    const auto core = std::span(core_).subspan(1, CoreLayout::cell_count);
    std::size_t i = 0;
    for (; i < core.size(); i += stride) {
      const double next = below + sum(core.subspan(i, stride));
      if (next >= rank) break;
      below = next;
    }
    for (; i < core.size(); ++i) {
      const double next = below + core[i];
      if (next >= rank)
        return std::clamp(layout_.edge(i) + (rank - below) / core[i] * layout_.cell, extremes.lower, extremes.upper);
      below = next;
    }
  }
  const SampledDistribution whole = distribution(extremes);
  return whole.quantile(std::min(rank / static_cast<double>(whole.trials()), 1.0));
}

Histogram FineCounts::histogram(const SampledDistribution& distribution) const {
  const double low = distribution.quantile(0.0005), high = distribution.quantile(0.9995);
  if (low == high) return {low, 0.0, {distribution.trials()}};
  const auto index_of = [this](double x) {
    const double place = std::floor((x - layout_.lower) * layout_.cells_per_unit);
    return static_cast<std::size_t>(std::clamp(place, 0.0, static_cast<double>(CoreLayout::cell_count - 1)));
  };
  const std::size_t first = index_of(low), last = index_of(high);
  const std::size_t group = (last - first + 80) / 80;
  Histogram histogram{layout_.edge(first), static_cast<double>(group) * layout_.cell, {}};
  for (std::size_t i = first; i <= last; i += group) {
    const auto cells = std::span(core_).subspan(i + 1, std::min(group, CoreLayout::cell_count - i));
    histogram.counts.push_back(std::accumulate(cells.begin(), cells.end(), std::uint64_t{0}));
  }
  return histogram;
}

}  // namespace axiometry::uncertainty
