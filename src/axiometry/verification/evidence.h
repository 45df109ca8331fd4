// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>
#include <optional>
#include <string_view>

#include "axiometry/model/series.h"

namespace axiometry::verification {

/// From the least to the most that the distributions held possible say.
struct ProbabilityRange {
  double least = 0.0;
  double most = 0.0;
};

/// P(low < parameter ≤ high) of the Monte Carlo run that a result states, which only its trials know; nothing where
/// there was no such run. `low` may be −∞.
using Drawn = std::function<std::optional<ProbabilityRange>(std::string_view parameter_key, double low, double high)>;

/// What a test is verified from.
struct Evidence {
  const Series& series;
  const Series* as_measured = nullptr;  ///< readings before corrections by the program; nullptr: there were none
  Drawn drawn{};
};

}  // namespace axiometry::verification
