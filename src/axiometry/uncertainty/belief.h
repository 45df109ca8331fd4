// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <variant>
#include <vector>

#include "axiometry/uncertainty/sampled_distribution.h"

/// What is believed of a quantity Y where more than one distribution is held possible and nobody knows which is right
/// (a probability box; Ferson et al., SAND2002-4015). A probability then lies between the least and the most that any
/// of them gives, and what is stated with 95 % must hold with 95 % in each.
namespace axiometry::uncertainty {

/// From the least to the most that the distributions held possible say.
struct Range {
  double least = 0.0;
  double most = 0.0;

  /// The one that says least: where they leave room, the one nearest to 0.5.
  double cautious() const;
};

/// One distribution that is held possible: that of the trials, all of them moved by `shift`.
struct Possible {
  const SampledDistribution* trials = nullptr;
  double shift = 0.0;

  double probability_below(double x) const { return trials->probability_below(x - shift); }
  double quantile(double p) const { return trials->quantile(p) + shift; }
};

class Belief {
 public:
  /// Y normal about `value` with the standard deviation u ≥ 0; with u = 0 it is the value.
  static Belief normal(double value, double u);
  /// (Y − value)/u after Student's t; contract: u > 0, ν > 0.
  static Belief student_t(double value, double u, double degrees_of_freedom);
  /// Y after any of these, each with trials; `value` is what was measured. The trials must outlive this.
  static Belief sampled(double value, std::vector<Possible> distributions);

  double value() const { return value_; }
  bool is_sampled() const { return !distributions_.empty(); }

  Range probability_at_most(double x) const;  ///< P(Y ≤ x)
  /// P(−limit ≤ Y + shift ≤ limit); contract: limit ≥ 0.
  Range probability_within(double limit, double shift = 0.0) const;
  /// G⁻¹(p), 0 < p < 1: of the distribution where it is least, and where it is most.
  Range quantile(double p) const;

 private:
  Belief(double value, double u, double degrees_of_freedom, std::vector<Possible> distributions)
      : value_(value), u_(u), degrees_of_freedom_(degrees_of_freedom), distributions_(std::move(distributions)) {}

  double about_value(double x) const;  ///< P(Y ≤ x) of the one distribution that is not sampled; contract: u > 0

  double value_ = 0.0;
  double u_ = 0.0;
  double degrees_of_freedom_ = 0.0;      ///< infinite: normal
  std::vector<Possible> distributions_;  ///< empty: normal, or Student's t
};

}  // namespace axiometry::uncertainty
