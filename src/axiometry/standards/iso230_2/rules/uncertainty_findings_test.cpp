// SPDX-License-Identifier: Apache-2.0
#include "axiometry/standards/iso230_2/rules/uncertainty_findings.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/support/series.h"

namespace axiometry::iso230_2 {
namespace {

using ::testing::HasSubstr;
using ::testing::Not;

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

/// Of three runs that scatter by 1 µm, so that noise of 0.6 µm (E_VE 2.1 µm) is nothing they have no room for.
TEST(UncertaintyFindings, TellOfNoiseThatIsNotSmallAgainstTheScatter) {
  const std::vector<testing_support::RunDeviations> runs = {{0, 1, 3}, {1, 0, 2}, {0.2, 2, 2.5}};
  axiometry::Test test{{}, testing_support::make_series({0, 480, 1000}, runs, runs), {}};
  test.metadata.uncertainty.environmental_variation = Deviation::native(2.1);
  EXPECT_THAT(told(test),
              HasSubstr("note E_VE = 2.1 µm as noise from reading to reading is 0.606 µm beside a scatter"));
  test.metadata.gum.measurand = Measurand::this_machine;
  EXPECT_THAT(told(test), Not(HasSubstr("beside a scatter"))) << "another finding tells that Annex A does not reach it";
  test.metadata.gum.measurand = Measurand::this_test;
  test.metadata.uncertainty.environmental_variation = Deviation::native(1.0);
  EXPECT_EQ(told(test), "");
  test.metadata.uncertainty.environmental_variation = Deviation::native(2.1);
  test.metadata.gum.method = UncertaintyMethod::monte_carlo;
  EXPECT_EQ(told(test), "");
}

/// The GUM takes noise of single readings and of runs too, of either measurand; nothing of it is slow.
TEST(UncertaintyFindings, TellOfNoiseThatIsNoVariationOfTheEnvironment) {
  const std::vector<testing_support::RunDeviations> runs = {{0, 1, 3}, {1, 0, 2}, {0.2, 2, 2.5}};
  axiometry::Test test{{}, testing_support::make_series({0, 480, 1000}, runs, runs), {}};
  test.metadata.gum.method = UncertaintyMethod::gum;
  for (const char* key : {"reading:probe", "run:clamping"}) {
    test.metadata.gum.distributions = {{key, "normal 0 0.7"}};
    EXPECT_THAT(told(test), HasSubstr("The known noise of readings and runs is 0.7 µm beside a scatter of 1 µm"))
        << key;
    test.metadata.gum.distributions = {{key, "normal 0 0.4"}};
    EXPECT_EQ(told(test), "") << key;
  }
  test.metadata.uncertainty.environmental_variation = Deviation::native(1.4);  // u = 0.404
  EXPECT_THAT(told(test), HasSubstr("The known noise of readings and runs is 0.569 µm"));
  test.metadata.gum.measurand = Measurand::this_machine;
  EXPECT_THAT(told(test), HasSubstr("The known noise of readings and runs is 0.569 µm"));
  test.metadata.gum.environment_kind = EnvironmentKind::drift;
  EXPECT_EQ(told(test), "");
  axiometry::Test refuted = table2_with_variation(1.7);
  refuted.metadata.gum.method = UncertaintyMethod::gum;
  EXPECT_THAT(told(refuted), Not(HasSubstr("known noise")));
  refuted.metadata.gum.distributions = {{"run:clamping", "normal 0 1"}};
  EXPECT_THAT(told(refuted), HasSubstr("it is a slow variation"));
  EXPECT_THAT(told(refuted), HasSubstr("The known noise of readings and runs is 1 µm"));
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
