// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <functional>
#include <span>
#include <vector>

#include "axiometry/base/result.h"
#include "axiometry/uncertainty/correlation.h"
#include "axiometry/uncertainty/distribution.h"
#include "axiometry/uncertainty/monte_carlo.h"

/// Input quantities together (JCGM 101:2008, 6.4.8), and measurement models of single trials.
namespace axiometry::uncertainty {

/// A measurement model y = f(x) for any number of outputs: reads the inputs, writes the outputs. Pure; called from
/// several threads by propagate().
using ModelFunction = std::function<void(std::span<const double> inputs, std::span<double> outputs)>;

/// Distributions and what correlates them. Normal distributions become the multivariate normal one with these
/// correlation coefficients. Any other marginal is coupled by a Gaussian copula: the coefficients are those of
/// the normal quantities behind the inputs, x = F⁻¹(Φ(z)), and the coefficients of the inputs themselves come out
/// somewhat smaller (for two rectangular ones (6/π) asin(r/2), at most 0.018 less).
class JointDistribution {
 public:
  /// Contract: one row of the correlation per distribution.
  JointDistribution(std::vector<Distribution> marginals, Correlation correlation);
  explicit JointDistribution(std::vector<Distribution> marginals);  ///< independent

  std::size_t size() const { return marginals_.size(); }
  const std::vector<Distribution>& marginals() const { return marginals_; }
  const Correlation& correlation() const { return correlation_; }

  /// One row of draws per input. Input i takes its random numbers from the stream key.stream + i, so that adding an
  /// input behind the others leaves theirs as they are.
  void sample(numeric::RandomKey key, BlockOutputs rows) const;

 private:
  std::vector<Distribution> marginals_;
  Correlation correlation_;
};

/// The model of single trials as a model of blocks, its inputs from the streams 0, 1, … of the seed.
BlockModel block_model(ModelFunction function, JointDistribution inputs, std::uint64_t seed);

}  // namespace axiometry::uncertainty
