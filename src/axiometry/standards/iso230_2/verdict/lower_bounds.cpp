// SPDX-License-Identifier: Apache-2.0
#include "axiometry/standards/iso230_2/verdict/lower_bounds.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstddef>

namespace axiometry::iso230_2 {
namespace {

/// Whether a target has every term that a parameter takes from it.
bool has_terms(const PositionResult& at, const ParameterInfo& parameter) {
  const bool of_up = !parameter.key.ends_with("_down"), of_down = !parameter.key.ends_with("_up");
  const bool of_scatter = parameter.key.starts_with('A') || parameter.key.starts_with('R');
  const auto direction = [&](bool asked, const auto& mean, const auto& s) {
    return !asked || (mean.has_value() && (!of_scatter || s.has_value()));
  };
  return direction(of_up, at.mean_up, at.s_up) && direction(of_down, at.mean_down, at.s_down);
}

}  // namespace

bool is_mean_over_targets(const ParameterInfo& parameter) { return parameter.member == &AxisParameters::B_mean; }

LowerBounds lower_bounds(const Evaluation& evaluation) {
  LowerBounds all;
  for (std::size_t k = 0; k < std::size(parameters); ++k) {
    const ParameterInfo& parameter = parameters[k];
    const auto lacking = std::ranges::count_if(evaluation.positions,
                                               [&](const PositionResult& at) { return !has_terms(at, parameter); });
    if (!(evaluation.parameters.*parameter.member) || lacking == 0) continue;
    all[k] = fmt::format("readings are missing at {} of {} targets, and the others give {}", lacking,
                         evaluation.positions.size(),
                         is_mean_over_targets(parameter) ? "the mean of a part" : "a lower bound");
  }
  return all;
}

}  // namespace axiometry::iso230_2
