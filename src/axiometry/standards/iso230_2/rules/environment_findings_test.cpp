// SPDX-License-Identifier: Apache-2.0
#include "axiometry/standards/iso230_2/rules/environment_findings.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <string>
#include <vector>

namespace axiometry::iso230_2 {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

constexpr double an_hour_of_it = 3600.0;

/// Of a hall at that temperature for hours, and nothing on the machine.
TemperatureLog hall(double hours, double celsius) {
  TemperatureCourse course{"air", "Hall", {}, {}};
  for (double t = 0.0; t <= hours * an_hour_of_it; t += 600.0) {
    course.times_s.push_back(t);
    course.celsius.push_back(celsius);
  }
  return {moment_of("2026-03-02T00:00"), {course}, {}};
}

const TimeStretch after_twelve_hours{12 * an_hour_of_it, 13 * an_hour_of_it};

std::vector<std::string> keys_of(const std::vector<Finding>& findings) {
  std::vector<std::string> keys;
  for (const Finding& finding : findings) keys.push_back(finding.id);
  return keys;
}

TEST(EnvironmentFindings, AskForLimitsOfTheRateAlone) {  // 4.1
  const auto found = environment_findings(test_environment(hall(13, 20), after_twelve_hours, {}));
  EXPECT_THAT(keys_of(found), ElementsAre("environment-rate-not-agreed", "environment-rate-before-not-agreed"));
  for (const Finding& finding : found) EXPECT_EQ(finding.severity, Severity::note);
}

TEST(EnvironmentFindings, DepartWhereAnAgreedLimitIsExceeded) {  // 7
  AgreedEnvironment agreed;
  agreed.highest = Temperature::celsius(22);
  agreed.rate = 0.5;
  const auto found = environment_findings(test_environment(hall(13, 22.0004), after_twelve_hours, agreed));
  ASSERT_THAT(keys_of(found), ElementsAre("environment-highest-exceeded"));
  EXPECT_EQ(found[0].severity, Severity::departure);
  EXPECT_EQ(found[0].clause, "7");
  EXPECT_EQ(found[0].message,
            "found highest temperature of the air: 22.0004 °C, expected at most 22 °C as agreed between the parties")
      << "never the limit itself";
  EXPECT_THAT(environment_findings(test_environment(hall(13, 22.0), after_twelve_hours, agreed)), IsEmpty());
  EXPECT_THAT(
      keys_of(environment_findings(test_environment(hall(13, 23), after_twelve_hours, agreed), Depth::departures_only)),
      ElementsAre("environment-highest-exceeded"));
}

TEST(EnvironmentFindings, MissWhatWasAgreedAndNotMeasured) {
  AgreedEnvironment agreed;
  agreed.rate = 0.5;
  agreed.machine_gradient = TemperatureDifference::kelvin(1);
  const auto found = environment_findings(test_environment(hall(13, 20), after_twelve_hours, agreed));
  ASSERT_THAT(keys_of(found), ElementsAre("environment-gradient-not-measured"));
  EXPECT_EQ(found[0].severity, Severity::missing);
}

TEST(EnvironmentFindings, MissWhetherALimitWasExceededDuringTheTest) {
  AgreedEnvironment agreed;
  agreed.highest = Temperature::celsius(22);
  const auto found = environment_findings(test_environment(hall(13, 23), std::nullopt, agreed));
  ASSERT_THAT(keys_of(found),
              ElementsAre("environment-perhaps-exceeded", "environment-rate-not-agreed", "environment-gap"));
  EXPECT_EQ(found[0].severity, Severity::missing);
  EXPECT_EQ(found[0].message,
            "found highest temperature of the air: 23 °C, expected at most 22 °C as agreed between the parties; nobody "
            "can say whether that was during the test");
  EXPECT_THAT(environment_findings(test_environment(hall(13, 23), std::nullopt, agreed), Depth::departures_only),
              IsEmpty());
}

TEST(EnvironmentFindings, TellWhatIsKnownInPartOnly) {
  AgreedEnvironment agreed;
  agreed.highest = Temperature::celsius(22);
  agreed.rate = 0.5;
  const auto unplaced = environment_findings(test_environment(hall(13, 20), std::nullopt, agreed));
  EXPECT_THAT(keys_of(unplaced),
              ElementsAre("environment-rate-before-not-measured", "environment-known-in-part", "environment-gap"));
  EXPECT_THAT(unplaced[1].message, HasSubstr("highest temperature of the air; change per hour, during the test"));
  const TimeStretch longer{12 * an_hour_of_it, 15 * an_hour_of_it};
  const auto part = environment_findings(test_environment(hall(13, 20), longer, agreed));
  EXPECT_THAT(keys_of(part), ElementsAre("environment-known-in-part", "environment-gap"));
  EXPECT_THAT(part[1].message, HasSubstr("recorded in 1.00 h of the 3.00 h of the test"));
}

}  // namespace
}  // namespace axiometry::iso230_2
