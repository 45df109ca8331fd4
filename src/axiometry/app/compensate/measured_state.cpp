// SPDX-License-Identifier: Apache-2.0
#include "axiometry/app/compensate/measured_state.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <string>

#include "axiometry/base/text/text.h"
#include "axiometry/base/time/iso_date.h"
#include "axiometry/model/simulated.h"
#include "axiometry/model/swapped_labels.h"
#include "axiometry/standards/iso230_2/inputs/uncorrected_effects.h"

namespace axiometry::app {
namespace {

/// The axis with its line through the origin where nobody says where it lies: a direction alone tells which axes move.
Axis with_line_anywhere(Axis axis) {
  if (axis.line_origin_mm.empty()) axis.line_origin_mm = {0.0, 0.0, 0.0};
  return axis;
}

bool same_number(double a, double b) { return a == b || (std::isnan(a) && std::isnan(b)); }

bool same_readings(const Series& a, const Series& b) {
  if (a.run_count() != b.run_count() ||
      !std::ranges::equal(a.targets(), b.targets(), {}, &Position::in_native, &Position::in_native))
    return false;
  for (std::size_t i = 0; i < a.target_count(); ++i)
    for (const Direction direction : {Direction::up, Direction::down})
      if (!std::ranges::equal(a.cell(i, direction), b.cell(i, direction), same_number)) return false;
  return true;
}

/// Of a re-test that says itself that it is none of this axis, or none after the table.
void add_doubts_of_retest(const Metadata& before, const Metadata& after, std::vector<NamedFinding>& findings) {
  const auto differs = [&](std::string_view what, const std::string& a, const std::string& b) {
    if (text::trim(a).empty() || text::trim(b).empty() || text::equal_ignoring_case(text::trim(a), text::trim(b)))
      return;
    findings.push_back({"retest-of-another", true,
                        fmt::format("the re-test names the {} {}, the test {}: it proves nothing of this table", what,
                                    text::quoted(b), text::quoted(a))});
  };
  differs("axis", before.axis.name, after.axis.name);
  differs("machine", before.machine.name, after.machine.name);
  differs("serial number", before.machine.serial_number, after.machine.serial_number);
  const std::string first = iso_date(before.conditions.date), then = iso_date(after.conditions.date);
  if (!first.empty() && !then.empty() && then < first)
    findings.push_back({"retest-before-test", true,
                        fmt::format("the re-test is of {}, the test of {}: no table that was made of the test can have "
                                    "been active",
                                    then, first)});
}

}  // namespace

Result<void> check_measures_axis(const Test& test) {
  const Axis& axis = test.metadata.axis;
  if (!axis.line_direction.empty()) {
    const auto line = spatial_line(with_line_anywhere(axis));
    if (!line)
      return fail("found axis.line_direction that is no direction of one linear axis, expected three numbers, or none");
    if (const std::size_t moving = moving_axes(*line); moving > 1)
      return fail(fmt::format(
          "found a test along a line that {} axes drive together (axis.line_direction), expected one of the "
          "axis that the table corrects",
          moving));
  }
  for (const iso230_2::UncorrectedEffect& effect : iso230_2::uncorrected_effects(test))
    if (effect.key == "sign")
      return fail(fmt::format("found that the table would double the error of the axis: {}", effect.reason()));
  return {};
}

NamedFinding finding_of_kept_table(const Error& why_not_made) {
  return {"compensation-made-no-more", true,
          fmt::format("the table is kept, and of such a test none is made any more: {}", why_not_made.message)};
}

std::vector<NamedFinding> findings_of_state(const Test& test, TableCurves curves, bool table_given) {
  std::vector<NamedFinding> findings;
  if (curves != TableCurves::both_ways && has_swapped_labels(test))
    findings.push_back({"compensation-directions-swapped", true,
                        fmt::format("the table's two directions may be exchanged: {}", swapped_labels)});
  for (const iso230_2::UncorrectedEffect& effect : iso230_2::uncorrected_effects(test))
    findings.push_back({"compensation-uncorrected", true,
                        fmt::format("the table corrects what is not of the axis: {}", effect.reason())});
  if (simulated_by_purpose(test.metadata.conditions.purpose))
    findings.push_back({"compensation-simulated", false, "the readings were simulated: the table is of no machine"});
  const Axis& axis = test.metadata.axis;
  if (table_given && states_no_compensation(axis))
    findings.push_back(
        {"compensation-states-no-table", true,
         fmt::format("the test states {} as the compensation used, and a table that was active is given: if "
                     "none was, the new one corrects twice what that one holds",
                     text::quoted(text::trim(axis.compensation)))});
  if (table_given || !may_be_compensated(axis)) return findings;
  const std::string said = !axis.compensation_points.empty()
                               ? "sampling points of a compensation (axis.compensation_points)"
                               : fmt::format("{} as axis.compensation", text::quoted(text::trim(axis.compensation)));
  findings.push_back({"compensation-active-table-unknown", true,
                      fmt::format("the test states {}, and nobody gives a table that was active: where there was one, "
                                  "this table in its place gives up what it corrected",
                                  said)});
  return findings;
}

std::vector<NamedFinding> findings_of_retest_state(const Metadata& before, const Test& retest) {
  std::vector<NamedFinding> findings;
  add_doubts_of_retest(before, retest.metadata, findings);
  if (has_swapped_labels(retest))
    findings.push_back({"retest-directions-swapped", true,
                        fmt::format("the re-test's two directions may be exchanged: {}", swapped_labels)});
  for (const iso230_2::UncorrectedEffect& effect : iso230_2::uncorrected_effects(retest))
    findings.push_back(
        {"retest-uncorrected", true, fmt::format("the re-test shows what is not of the axis: {}", effect.reason())});
  if (states_no_compensation(retest.metadata.axis))
    findings.push_back(
        {"retest-states-no-table", true,
         fmt::format("the re-test states {} as the compensation used: with no table active it proves nothing "
                     "of this one",
                     text::quoted(text::trim(retest.metadata.axis.compensation)))});
  return findings;
}

Result<void> check_not_itself(const Test& test, const Test& retest) {
  const std::string &first = test.provenance.sha256, &then = retest.provenance.sha256;
  if (first.empty() || first != then || !same_readings(test.series, retest.series)) return {};
  return fail("found the test itself as its re-test, expected one with the table active");
}

}  // namespace axiometry::app
