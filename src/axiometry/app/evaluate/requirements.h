// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "axiometry/app/evaluate/tolerance_table.h"
#include "axiometry/app/evaluate/tolerance_text.h"
#include "axiometry/model/test.h"
#include "axiometry/standards/iso230_2/verdict/tolerance.h"

/// What is demanded of a test: limits and decision rule of the axis, from a tolerance table, from the test's own file,
/// entered for it and from the user, each taking the place of the one before, parameter by parameter.
namespace axiometry::app {

/// What a user gives along with the tests.
struct ToleranceOptions {
  std::vector<ToleranceText> limits{};
  std::optional<RuleText> rule{};
  std::optional<ToleranceTable> table{};
  std::string table_name{};  ///< name of a table in the file; empty: the one the test's file names, or the only one
  /// Whether the limits are meant for several tests: then one of a parameter that a test does not have leaves
  /// that test without a verdict on it, which a finding tells. For a single test it is a mistake.
  bool many_tests = false;
  std::vector<iso230_2::Tolerance> of_axis{};  ///< what the archive says of the axis
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
  std::vector<iso230_2::Tolerance> tolerances;  ///< limits in the order of iso230_2::parameters
  uncertainty::DecisionRule rule;               ///< simple acceptance when nobody asks for another
  std::optional<AppliedBand> band;              ///< when there is a table
  /// What must be known of the demands: limits and rules that replace others or were taken away, and limits of what the
  /// test does not have.
  std::vector<iso230_2::Finding> findings;
};

/// `entries` are the metadata that a person has put over what the test's file says, which stood in `file` before
/// (nullptr: as now): a limit among them was entered, replaces one of the file or takes it away. Fails as
/// tolerances_for(), rule_for(), stated_rule() and select_band() do, and on a limit given by the user for a single test
/// that has no such parameter (6.2), naming the reason.
Result<Requirements> requirements_for(const Test& test, const iso230_2::AxisParameters& measured,
                                      const ToleranceOptions& options,
                                      std::span<const std::pair<std::string, std::string>> entries = {},
                                      const Metadata* file = nullptr);

}  // namespace axiometry::app
