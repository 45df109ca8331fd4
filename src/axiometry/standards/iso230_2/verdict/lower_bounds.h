// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <string>

#include "axiometry/standards/iso230_2/parameters.h"

/// What a value can show of which terms are missing.
namespace axiometry::iso230_2 {

/// Why a parameter is not the one of clause 3, since some target lacks a term of it that others have: a mean for E and
/// M, a reversal for B and B̄, an s_i too for R and A. A range or a largest value over the rest is a lower bound, which
/// can show that a limit is exceeded and never that it is kept; B̄ over the rest can show neither. Empty for what does
/// not exist, and where nothing is missing. One per parameter, in the order of `parameters`.
using LowerBounds = std::array<std::string, std::size(parameters)>;
LowerBounds lower_bounds(const Evaluation& evaluation);

/// Whether it is a mean over targets, which a missing term may move either way; all others are ranges or maxima.
bool is_mean_over_targets(const ParameterInfo& parameter);

}  // namespace axiometry::iso230_2
