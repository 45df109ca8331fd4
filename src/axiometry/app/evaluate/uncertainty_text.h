// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string_view>

#include "axiometry/app/evaluate/evaluate.h"
#include "axiometry/base/result.h"

namespace axiometry::app {

/// "annex-a,gum,monte-carlo": turns the named methods on. Annex A is always there and may be left out or named.
/// Fails on an empty list and an unknown name (the message names the nearest).
Result<void> choose_methods(std::string_view list, UncertaintyOptions& options);

/// Fewest trials that may be asked for.
inline constexpr double trials_min = 100;

/// A probability that intervals may have: from 0.5 to 0.9999.
bool is_coverage(double probability);

/// A whole number of 64 bits; a probability, is_coverage(); pooled, t-scaled or resampled.
Result<void> choose_seed(std::string_view text, UncertaintyOptions& options);
Result<void> choose_coverage(std::string_view text, UncertaintyOptions& options);
Result<void> choose_type_a(std::string_view text, UncertaintyOptions& options);

/// "auto" (adaptive, JCGM 101, 7.9) or a whole number from 100 to 1e9, also as 1e6.
Result<void> choose_trials(std::string_view text, UncertaintyOptions& options);

}  // namespace axiometry::app
