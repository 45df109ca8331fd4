// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "axiometry/app/tolerance_table.h"
#include "axiometry/app/tolerance_text.h"
#include "axiometry/model/test.h"
#include "axiometry/standards/iso230_2_tolerance.h"

/// What is demanded of a test: limits and decision rule from a tolerance table, from the test's own file and from
/// the user, each taking the place of the one before, parameter by parameter.
namespace axiometry::app {

/// What a user gives along with the tests.
struct ToleranceOptions {
  std::vector<ToleranceText> limits{};
  std::optional<RuleText> rule{};
  std::optional<ToleranceTable> table{};
  std::string table_name{};  ///< in the table; empty: the one the test's file names, or the only one
  /// Whether the limits are meant for several tests: then one of a parameter that a test does not have leaves
  /// that test without a verdict on it. For a single test it is a mistake.
  bool many_tests = false;
  std::vector<iso230_2::Tolerance> of_axis{};  ///< apply as a whole where nothing else sets any limit
};

/// The row of a tolerance table that applies to a test.
struct AppliedBand {
  std::string file;
  std::string sha256;
  std::string name;
  std::optional<Position> travel_max;
  std::string travel;  ///< "up to 500 mm"
};

struct Requirements {
  std::vector<iso230_2::Tolerance> tolerances;  ///< in the order of iso230_2::parameters
  uncertainty::DecisionRule rule;               ///< simple acceptance when nobody asks for another
  std::optional<AppliedBand> band;              ///< when there is a table
};

/// Fails as tolerances_for(), rule_for(), stated_rule() and select_band() do, and on a limit given by the user for a
/// single test that has no such parameter (6.2), naming the reason.
Result<Requirements> requirements_for(const Test& test, const iso230_2::AxisParameters& measured,
                                      const ToleranceOptions& options);

}  // namespace axiometry::app
