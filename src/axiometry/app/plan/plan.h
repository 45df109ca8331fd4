// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "axiometry/app/results/outputs.h"
#include "axiometry/base/json/json.h"
#include "axiometry/base/result.h"
#include "axiometry/model/plan.h"
#include "axiometry/report/report.h"
#include "axiometry/standards/iso230_2/plan/plan.h"

/// The use case "from what shall be tested to a plan of it".
namespace axiometry::app {

/// A plan with everything that is said about it.
struct PlannedTest {
  Plan plan;
  std::vector<iso230_2::Finding> findings;
  Duration duration;         ///< how long the plan alone takes
  Duration duration_in_all;  ///< how long it takes with its further plans

  bool conforming() const { return iso230_2::conforming(findings); }
  bool in_accordance() const { return iso230_2::in_accordance(findings); }
};

/// Needs a sound plan. An acceleration that is given takes the place of the plan's. Fails as check_acceleration() and,
/// for the rule of the plan, standards::rule_named() do.
Result<PlannedTest> planned(Plan plan, std::optional<double> acceleration);

/// A plan from a file ("-" is the standard input). Fails with the file's name.
Result<Plan> read_plan_file(const std::string& file);

/// Approaches from a list ("1+ 2+ 2- 1-") or, where the text is none, from the file of that name.
Result<std::vector<Approach>> read_sequence(const std::string& list_or_file);

/// A seed that nobody chose, short enough to be typed.
std::uint64_t drawn_seed();

/// Today's local date, "2026-11-21"; where the environment has SOURCE_DATE_EPOCH, that of so many seconds since 1970
/// (UTC), so that outputs can be made again byte by byte.
std::string today();

/// The day of a plan in the way of today(), which it is where nothing is said. Fails on what is no iso_date().
Result<std::string> plan_date(std::string_view said);

/// The plan as an object, with its findings and duration: what `axiometry plan` writes.
json::Value plan_to_json(const PlannedTest& planned);

/// Its sheet as the bytes of a file. Fails on an extension that no writer has, and as the writer does.
Result<std::string> plan_sheet_file(const PlannedTest& planned, std::string_view extension,
                                    const report::Options& options);

/// Writes the plan with its findings and duration to names.json, and its sheet to names.reports.
Result<void> write_plan_outputs(const PlannedTest& planned, const OutputNames& names, const report::Options& options);

}  // namespace axiometry::app
