// SPDX-License-Identifier: Apache-2.0
//
// docs/controls-compensation.md says of every control what its descriptor says.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <string>

#include "axiometry/nc/axis_table.h"
#include "tests/support/repository_file.h"

namespace axiometry::nc {
namespace {

std::string curves_text(const AxisTable& table) {
  if (table.curves == TableCurves::each_way) return "each direction";
  return table.curves == TableCurves::with_backlash ? "scale and backlash" : "both directions alike";
}

std::string limits_text(const AxisTable& table) {
  const AxisTableLimits& limits = table.limits;
  if (limits.points <= 2 && limits.points > 0) return limits.rotary ? "no table" : "no table; linear axes";
  std::string text = limits.points > 0 ? fmt::format("at most {} positions", limits.points) : "positions not limited";
  if (limits.step_native > 0.0) {
    text += fmt::format(", {} mm apart", limits.step_native);
  } else {
    text += limits.equidistant ? ", one spacing" : ", any spacing";
  }
  if (limits.origin == TableOrigin::on_grid) text += ", reference point a whole number of steps from them";
  if (limits.origin == TableOrigin::first) text += ", the first at the reference point";
  if (limits.origin == TableOrigin::last) text += ", the last at the reference point";
  return limits.rotary ? text : text + "; linear axes";
}

/// What the page says of one control.
std::string section(const AxisTable& table) {
  return fmt::format(
      "### {}\n\n`--for {}` · {} · {}\n\n- **Sign.** {}\n- **Loading.** {}\n- **Verified.** {}\n"
      "- **Inferred.** {}\n",
      table.title, table.id, curves_text(table), limits_text(table), table.sign, table.loading, table.verified,
      table.inferred.empty() ? "Nothing." : table.inferred);
}

TEST(CompensationsPage, SaysOfEveryControlWhatItsDescriptorSays) {
  const std::string page = testing_support::repository_file("docs/controls-compensation.md");
  std::string all;
  for (const AxisTable* table : axis_table_table()) all += (all.empty() ? "" : "\n") + section(*table);
  EXPECT_TRUE(page.ends_with(all)) << "the page should end with\n<<<\n" << all << ">>>";
}

}  // namespace
}  // namespace axiometry::nc
