// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <optional>
#include <string>

#include "axiometry/app/evaluate/evaluate.h"
#include "axiometry/base/json/json.h"

/// The uncertainties of an evaluation as machines read them; belongs to result_json.h. docs/results.md describes the
/// keys.
namespace axiometry::app {

json::Value number_or_null(const std::optional<double>& x);
json::Value number_or_null(const std::optional<Deviation>& x);
json::Value seed_to_json(std::uint64_t seed);  ///< a number, but text above 2⁵³, which not every reader can hold
json::Value parameters_to_json(const iso230_2::AxisParameters& parameters);

/// "record", the uncertainty that stands with the results and decides; "annex_a", "gum" and "monte_carlo" with a member
/// per parameter each, null where the method was not run or says nothing, and beside them their budgets and runs where
/// there are any.
json::Value uncertainty_to_json(const iso230_2::Assessment& assessment);

/// Further columns of the combined CSV for the methods that were asked for, each with a leading comma:
/// gum_U_A …, mc_mean_A …, mc_u_A …, mc_low_A …, mc_high_A …. Empty cells where null, all of them for an error.
std::string method_csv_header(const UncertaintyOptions& asked);
std::string method_csv_cells(const UncertaintyOptions& asked, const Evaluated* evaluated);

}  // namespace axiometry::app
