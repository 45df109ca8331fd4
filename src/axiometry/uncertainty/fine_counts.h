// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <map>
#include <span>
#include <vector>

#include "axiometry/numeric/vector_target.h"
#include "axiometry/uncertainty/sampled_distribution.h"

/// Counts of the values of one output in narrow cells, and their moments: what a Monte Carlo run keeps instead of the
/// values. Private to uncertainty/.
///
/// The core is 16 384 equal cells laid out from the first block of values, wide enough for the quantiles asked for:
/// for a normal distribution a cell is 8e-4 standard deviations wide and interpolation in it leaves an error below
/// 1e-7 of them, where a million trials leave 2.7e-3 in an end point of a 95 % interval. Beyond the core cells
/// grow with the distance, 32 to an octave, kept only where a value fell. Counts are integers, so that adding them
/// up in any order gives the same.
namespace axiometry::uncertainty {

struct CoreLayout {
  static constexpr std::size_t cell_count = 16'384;
  double lower = 0.0;
  double cell = 1.0;            ///< width, above 0
  double cells_per_unit = 1.0;  ///< 1/cell
  double near_mean = 0.0;       ///< mean of the first block

  /// For quantiles at (1 ± coverage)/2. Contract: not empty, all finite.
  static CoreLayout from_first(std::span<const double> values, double coverage);
  double edge(std::size_t index) const { return lower + static_cast<double>(index) * cell; }
  double centre() const { return edge(cell_count / 2); }
};

/// Moments by way of a fixed value near the mean, so that little is cancelled.
struct ValueMoments {
  double count = 0.0;
  double mean = 0.0;
  double squares = 0.0;  ///< Σ (x − mean)²; not finite when a value is not or is too large to be squared
  double min = 0.0;
  double max = 0.0;

  static ValueMoments of(std::span<const double> values, double near_mean,
                         numeric::VectorTarget target = numeric::best_vector_target());  ///< moments are equal on all
  void add(const ValueMoments& other);  ///< pairwise; the order counts in the last bits
  double sd() const;                    ///< divisor count − 1
};

class FineCounts {
 public:
  explicit FineCounts(const CoreLayout& layout) : layout_(layout) {}

  /// Returns the moments of these values alone; where their squares are not finite, the counts are of no use.
  ValueMoments add(std::span<const double> values, numeric::VectorTarget target = numeric::best_vector_target());
  void add(const FineCounts& other);  ///< contract: of the same layout
  void clear(const CoreLayout& layout);

  /// Cells in ascending order, cut at the extremes.
  SampledDistribution distribution(Interval extremes) const;

  /// The value below which `rank` of the counted values lie.
  double quantile(double rank, Interval extremes) const;

  /// About eighty bins from the quantile 0.0005 to 0.9995.
  Histogram histogram(const SampledDistribution& distribution) const;

 private:
  void add_tails(std::span<const double> values);

  CoreLayout layout_;
  /// The first counts all values below the core, the last all above.
  std::array<std::uint32_t, CoreLayout::cell_count + 2> core_{};
  std::map<std::int64_t, std::uint64_t> tails_;  ///< number of a cell, negative below the core
};

}  // namespace axiometry::uncertainty
