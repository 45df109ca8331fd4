// SPDX-License-Identifier: Apache-2.0
#include "axiometry/uncertainty/joint_distribution.h"

#include <algorithm>
#include <utility>

#include "axiometry/base/contract.h"

namespace axiometry::uncertainty {

JointDistribution::JointDistribution(std::vector<Distribution> marginals, Correlation correlation)
    : marginals_(std::move(marginals)), correlation_(std::move(correlation)) {
  AXIOMETRY_CONTRACT(correlation_.size() == marginals_.size());
}

JointDistribution::JointDistribution(std::vector<Distribution> marginals)
    : marginals_(std::move(marginals)), correlation_(Correlation::none(marginals_.size())) {}

void JointDistribution::sample(numeric::RandomKey key, BlockOutputs rows) const {
  AXIOMETRY_CONTRACT(rows.values.size() >= size() * rows.trials);
  const auto key_of = [key](std::size_t input) { return numeric::RandomKey{key.seed, key.stream + input, key.block}; };
  std::vector<std::size_t> coupled;
  for (std::size_t i = 0; i < size(); ++i) {
    if (correlation_.correlated(i)) {
      coupled.push_back(i);
      numeric::fill_normal(key_of(i), rows.row(i));
    } else {
      marginals_[i].sample(key_of(i), rows.row(i));
    }
  }
  // A row needs the normal numbers of the rows before it, so the last is replaced first.
  std::ranges::reverse(coupled);
  for (const std::size_t i : coupled) {
    const auto factors = correlation_.factor_row(i);
    const auto row = rows.row(i);
    for (double& z : row) z *= factors[i];
    for (std::size_t j = 0; j < i; ++j) {
      if (factors[j] == 0.0) continue;
      const auto before = rows.row(j);
      for (std::size_t t = 0; t < row.size(); ++t) row[t] += factors[j] * before[t];
    }
  }
  for (const std::size_t i : coupled)
    for (double& x : rows.row(i)) x = marginals_[i].from_normal(x);
}

BlockModel block_model(ModelFunction function, JointDistribution inputs, std::uint64_t seed) {
  return [function = std::move(function), inputs = std::move(inputs), seed](std::uint64_t block, BlockOutputs outputs) {
    const std::size_t n = outputs.trials, output_count = outputs.values.size() / n;
    std::vector<double> rows(inputs.size() * n), x(inputs.size()), y(output_count);
    const BlockOutputs draws{rows, n};
    inputs.sample({seed, 0, block}, draws);
    for (std::size_t t = 0; t < n; ++t) {
      for (std::size_t i = 0; i < x.size(); ++i) x[i] = rows[i * n + t];
      function(x, y);
      for (std::size_t k = 0; k < output_count; ++k) outputs.values[k * n + t] = y[k];
    }
  };
}

}  // namespace axiometry::uncertainty
