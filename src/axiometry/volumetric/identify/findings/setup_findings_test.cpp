// SPDX-License-Identifier: Apache-2.0
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <utility>
#include <vector>

#include "axiometry/volumetric/field/volume_statistics.h"
#include "axiometry/volumetric/identify/findings/finding_test_support.h"

namespace axiometry::volumetric {
namespace {

using test::four_stations;
using test::identified;
using test::measured;
using test::told;
using test::TrueMachine;
using testing::HasSubstr;

std::string exchange_told(const TrueMachine& machine, const VolumetricLengths& lengths) {
  return told(identified(machine, lengths), "volumetric-stations-exchanged");
}

TEST(SetupFindings, NameTwoStationsWhoseNamesAreExchanged) {
  TrueMachine machine("XFYZ", 61);
  machine.model.stations = four_stations();
  const VolumetricLengths lengths = measured(machine, four_stations());
  EXPECT_EQ(exchange_told(machine, lengths), "");
  VolumetricLengths two = lengths;
  std::swap(two.stations[1], two.stations[3]);
  EXPECT_THAT(exchange_told(machine, two),
              HasSubstr(R"(station "B" stands where "D" was said to, and "D" where "B" was)"));
  EXPECT_EQ(told(identified(machine, two), "volumetric-station-place"), "");
  // Three in turn, or one that stands elsewhere, are no two exchanged.
  VolumetricLengths three = two;
  std::swap(three.stations[0], three.stations[1]);
  EXPECT_EQ(exchange_told(machine, three), "");
  EXPECT_NE(told(identified(machine, three), "volumetric-station-place"), "");
  machine.model.stations[2].at_mm.x += 400.0;
  EXPECT_EQ(exchange_told(machine, lengths), "");
}

TEST(SetupFindings, NameStationsExchangedInTheLengthsOfOneTool) {
  TrueMachine machine("XFYZ", 62);
  const VolumetricLengths lengths = measured(machine, four_stations());
  for (const std::size_t tool : {0u, 1u}) {
    VolumetricLengths exchanged = lengths;
    for (VolumetricReading& reading : exchanged.readings)
      if (reading.tool == tool && reading.station > 1) reading.station = 5 - reading.station;
    EXPECT_THAT(
        exchange_told(machine, exchanged),
        HasSubstr(R"(the names of stations "C" and "D" are exchanged in the lengths with tool "short", or in )"))
        << tool;
  }
  // An instrument that was moved between the tools stands nowhere else.
  VolumetricLengths moved = lengths;
  for (VolumetricReading& reading : moved.readings) {
    if (reading.tool != 1 || reading.station != 2) continue;
    const Vector3 p = reading.axes_mm + machine.model.tools[1].offset_mm, s = four_stations()[2].at_mm;
    reading.length_mm += distance(p, s + Vector3{30.0, 0.0, 0.0}) - distance(p, s);
  }
  EXPECT_EQ(exchange_told(machine, moved), "");
  EXPECT_NE(told(identified(machine, moved), "volumetric-station-moved"), "");
  // Nor where another station was seen with neither of these tools.
  std::erase_if(moved.readings, [](const VolumetricReading& r) { return r.station == 3 && r.tool < 2; });
  EXPECT_EQ(exchange_told(machine, moved), "");
  EXPECT_NE(told(identified(machine, moved), "volumetric-station-moved"), "");
}

/// Where all tools are longer by the same, stations stand lower by it, and errors are those of another point: the
/// lengths fit alike, and what is predicted of a tool as it is stated is right of the tool as it is.
TEST(SetupFindings, CannotTellThatAllToolsAreLongerAlike) {
  TrueMachine machine("XFYZ", 63);
  const VolumetricLengths lengths = measured(machine, four_stations());
  const Identification right = identified(machine, lengths);
  const std::vector<Tool> true_tools = machine.model.tools;
  for (Tool& tool : machine.model.tools) tool.offset_mm.z += 30.0;
  const Identification wrong = identified(machine, lengths);
  EXPECT_NEAR(wrong.chi_squared, right.chi_squared, 1e-3 * right.chi_squared);
  EXPECT_EQ(wrong.findings.size(), right.findings.size());
  EXPECT_NEAR(distance(wrong.stations[0].at_mm, right.stations[0].at_mm), 30.0, 0.01);
  for (std::size_t t = 0; t < true_tools.size(); ++t) {
    const Vector3 as_stated = machine.model.tools[t].offset_mm, as_is = true_tools[t].offset_mm;
    const auto largest = [](const Identification& found, Vector3 tool_mm) {
      return volume_statistics(found.model, tool_mm, 5).without_rigid_motion->largest.value;
    };
    EXPECT_NEAR(largest(wrong, as_stated), largest(right, as_is), 0.02);
    EXPECT_GT(std::abs(largest(right, as_stated) - largest(right, as_is)), 0.05) << "the point matters";
  }
}

}  // namespace
}  // namespace axiometry::volumetric
