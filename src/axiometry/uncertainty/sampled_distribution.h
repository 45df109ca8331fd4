// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <utility>
#include <vector>

/// What a Monte Carlo run leaves of the distribution of an output: counts in cells so narrow that the finite number
/// of trials outweighs their width by far (fine_counts.h), in memory that does not depend on the number of trials.
namespace axiometry::uncertainty {

struct Interval {
  double lower = 0.0;
  double upper = 0.0;
};

/// Equal bins over the interesting part of the distribution, for drawing.
struct Histogram {
  double lower = 0.0;
  double width = 0.0;  ///< width of one bin; 0 for an output that is constant
  std::vector<std::uint64_t> counts;
};

class SampledDistribution {
 public:
  /// Trials between two values, spread evenly there.
  struct Cell {
    double lower = 0.0;
    double upper = 0.0;
    std::uint64_t below = 0;  ///< trials in all cells before
    std::uint64_t count = 0;
  };

  SampledDistribution() = default;
  /// Contract: ascending, without overlap, each count above 0, `below` their running sum.
  explicit SampledDistribution(std::vector<Cell> cells);

  std::uint64_t trials() const;
  const std::vector<Cell>& cells() const { return cells_; }

  double probability_below(double x) const;  ///< estimate of P(output ≤ x); contract: trials() > 0
  double quantile(double p) const;           ///< contract: trials() > 0, 0 ≤ p ≤ 1; 0 and 1 give the extremes

  /// Standard error of quantile(p) from the finite number of trials: half the distance between the quantiles one
  /// standard deviation √(p(1−p)/M) of the rank below and above.
  double quantile_error(double p) const;

  /// Mean of (output − centre)^4.
  double fourth_moment(double centre) const;

  Interval symmetric_interval(double coverage) const;  ///< 7.7.2: as much probability below as above

  /// 7.7.4. The length of the intervals [G⁻¹(a), G⁻¹(a + p)] as a function of a is a noisy curve around its minimum,
  /// and the place of its least value scatters several times more than a quantile; the vertex of a parabola through the
  /// lengths near the least one scatters less. At the end of the range of a the end itself is kept.
  Interval shortest_interval(double coverage) const;

 private:
  std::vector<Cell> cells_;
};

}  // namespace axiometry::uncertainty
