// SPDX-License-Identifier: Apache-2.0
#include "axiometry/report/finding_text.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/support/report_subject.h"

namespace axiometry::report {
namespace {

using ::testing::HasSubstr;
using ::testing::Not;
using testing_support::Reported;

std::string message(const Reported& reported, std::string_view part, AxisKind kind, DisplayUnit unit) {
  Options options = reported.options;
  options.unit = unit;
  for (const auto& finding : reported.assessment.findings)
    if (finding.message.contains(part)) return shown_message(finding, reported.assessment, kind, options);
  return "";
}

Reported rotary_with_findings() {
  Test test{{}, testing_support::table2::series(), {}};
  test.metadata.axis.kind = AxisKind::rotary;
  return testing_support::reported(std::move(test));
}

TEST(FindingText, FollowsTheUnitThatWasAskedFor) {
  const Reported axis = rotary_with_findings();
  EXPECT_THAT(message(axis, "reversal error", AxisKind::rotary, DisplayUnit::native), HasSubstr("−3.7 ″ on average"));
  const std::string in_degrees = message(axis, "reversal error", AxisKind::rotary, DisplayUnit::deg);
  EXPECT_THAT(in_degrees, HasSubstr("−0.00103° on average"));
  EXPECT_THAT(in_degrees, Not(HasSubstr("″")));
  const Reported linear = testing_support::reported_without_metadata();
  EXPECT_THAT(message(linear, "reversal error", AxisKind::linear, DisplayUnit::mm), HasSubstr("−0.0037 mm on average"));
  EXPECT_THAT(message(linear, "reversal error", AxisKind::linear, DisplayUnit::nm), HasSubstr("−3711 nm on average"));
}

TEST(FindingText, EndsAParameterWhereItEndsEverywhere) {
  const Reported table2 = testing_support::reported_table2();
  const auto& R = *iso230_2::find_parameter("R");
  const std::string shown = show(R, table2.assessment, AxisKind::linear, table2.options).value;
  EXPECT_THAT(message(table2, "reversal error", AxisKind::linear, DisplayUnit::native),
              HasSubstr("R would be 3.0 µm instead of " + shown + " µm"));
}

TEST(FindingText, LeavesWhatHoldsNoDeviationAlone) {
  const iso230_2::Finding finding{"source-remark", "5.2", iso230_2::Severity::note, "a name with 5 µm in it"};
  const Reported table2 = testing_support::reported_table2();
  EXPECT_EQ(shown_message(finding, table2.assessment, AxisKind::linear, {.unit = DisplayUnit::mm}), finding.message);
}

}  // namespace
}  // namespace axiometry::report
