// SPDX-License-Identifier: Apache-2.0
#include "axiometry/standards/iso230_2/rules/uncertainty_findings.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/support/series.h"

namespace axiometry::iso230_2 {
namespace {

using ::testing::HasSubstr;

axiometry::Test table2_with_variation(double um) {
  axiometry::Test test{{}, testing_support::table2::series(), {}};
  test.metadata.uncertainty.environmental_variation = Deviation::native(um);
  return test;
}

std::string told(const axiometry::Test& test) {
  std::string text;
  for (const Finding& finding : uncertainty_findings(test, assess(test)))
    text += std::string(severity_name(finding.severity)) + " " + finding.message + "\n";
  return text;
}

TEST(UncertaintyFindings, TellOfAVariationThatTheReadingsHaveNoRoomForAsNoise) {
  EXPECT_EQ(told(table2_with_variation(0.3)), "");
  EXPECT_THAT(told(table2_with_variation(1.7)), HasSubstr("note E_VE = 1.7 µm as noise from reading to reading"));
  EXPECT_THAT(told(table2_with_variation(1.7)), HasSubstr("it is a slow variation, or much overstated"));
}

TEST(UncertaintyFindings, TellOfWhiteNoiseThatIsStatedAndRefuted) {
  axiometry::Test test = table2_with_variation(1.7);
  test.metadata.gum.environment_kind = EnvironmentKind::white;
  EXPECT_THAT(told(test), HasSubstr("missing E_VE = 1.7 µm"));
  EXPECT_THAT(told(test), HasSubstr("counts as a slow drift or a random walk"));
}

TEST(UncertaintyFindings, TellOfAMeasurandThatAnnexADoesNotKnow) {
  axiometry::Test test = table2_with_variation(0.3);
  test.metadata.gum.measurand = Measurand::this_machine;
  EXPECT_THAT(told(test), HasSubstr("does not reach Annex A"));
  test.metadata.gum.method = UncertaintyMethod::gum;
  EXPECT_EQ(told(test), "");
}

}  // namespace
}  // namespace axiometry::iso230_2
