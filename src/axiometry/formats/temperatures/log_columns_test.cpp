// SPDX-License-Identifier: Apache-2.0
#include "axiometry/formats/temperatures/temperature_log.h"

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace axiometry::formats {
namespace {

using ::testing::Contains;
using ::testing::HasSubstr;
using ::testing::Not;

TemperatureLog read_of(std::string_view text, const SensorRoles& roles = {}) {
  auto log = read_temperature_log(text, roles);
  EXPECT_TRUE(log) << (log ? "" : log.error().to_string());
  return log ? *std::move(log) : TemperatureLog{};
}

TEST(LogColumns, CountExtremesOfTheAirBetweenReadings) {
  for (const char* head : {"Air max [°C]", "Air peak [°C]", "Luft Minimum [°C]", "Air_max"}) {
    const auto log = read_of(fmt::format("time;Air mean [°C];{}\n2026-03-02 09:00;20.3;26\n", head));
    ASSERT_EQ(log.sensors.size(), 2u) << head;
    EXPECT_EQ(log.sensors[1].role, "air");
    EXPECT_THAT(log.remarks, Contains(HasSubstr("tells extremes of the air by its name")));
  }
  const auto unnamed = read_of("time;T1 [°C];T1_max [°C];T2 max [°C]\n2026-03-02 09:00;20.3;26;30\n");
  ASSERT_EQ(unnamed.sensors.size(), 2u) << "T1 counts as one of the air, of T2 nobody knows";
  EXPECT_EQ(unnamed.sensors[1].location, "T1_max");
  const auto left_out = read_of("time;Air [°C];Max [°C];Bed max [°C]\n2026-03-02 09:00;20.3;26;30\n");
  EXPECT_EQ(left_out.sensors.size(), 1u) << "perhaps a limit; and a gradient is one at a moment";
  const auto none = read_of("time;Air [°C];Air max [°C]\n2026-03-02 09:00;20.3;26\n", {{"Air max", "none"}});
  EXPECT_EQ(none.sensors.size(), 1u);
}

TEST(LogColumns, TellThatTimesWithoutAUnitAreTakenForSeconds) {
  const std::string_view assumed = "times of the temperature log tell no unit and are taken to be in seconds";
  for (const char* head : {"Time", "elapsed", "Zeit"})
    EXPECT_THAT(read_of(fmt::format("{};Air [°C]\n0;20.3\n10;20.4\n", head)).remarks, Contains(assumed)) << head;
  for (const char* head : {"time_s", "Time [min]", "seconds", "Sekunden", "time (h)"})
    EXPECT_THAT(read_of(fmt::format("{};Air [°C]\n0;20.3\n10;20.4\n", head)).remarks, Not(Contains(assumed))) << head;
}

}  // namespace
}  // namespace axiometry::formats
