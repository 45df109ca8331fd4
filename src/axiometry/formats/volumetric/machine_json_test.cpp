// SPDX-License-Identifier: Apache-2.0
#include "axiometry/formats/volumetric/machine_json.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <string>

namespace axiometry::formats {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;

constexpr std::string_view least_machine =
    R"("chain": "XFYZ", "travel_mm": {"X": [0, 1000], "Y": [0, 600], "Z": [-500, 0]},
       "tools_mm": {"T1": [0, 0, -150]})";

std::string with(std::string_view more) { return "{" + std::string(least_machine) + std::string(more) + "}"; }

std::string machine_refusal(const std::string& text) {
  const auto file = read_machine(text);
  return file ? "none" : file.error().to_string();
}

TEST(MachineJson, NeedsNoMoreThanChainTravelsAndOneTool) {
  const auto file = read_machine(with(""));
  ASSERT_TRUE(file) << file.error().to_string();
  EXPECT_EQ(file->machine.chain.text(), "XFYZ");
  EXPECT_EQ(file->machine.travel.lowest_mm, (Vector3{0, 0, -500}));
  EXPECT_EQ(file->machine.tools.front().offset_mm, (Vector3{0, 0, -150}));
  EXPECT_FALSE(file->machine.scale_uncertainty) << "absent is not 0";
  EXPECT_THAT(file->remarks, testing::IsEmpty());
}

TEST(MachineJson, IsReadBackAsItIsWritten) {
  const auto file = read_machine(with(
      R"(, "name": "Mill 1", "instrument": {"a_um": 0.4, "b_um_per_m": 0.7, "scale_u_um_per_m": 0.2},
         "repeatability_um": 0.5, "stations_mm": {"S1": [1, 2, 3]}, "functional_point_mm": {"Y": [10, 0, -20]})"));
  ASSERT_TRUE(file) << file.error().to_string();
  const auto again = machine_from(machine_value(file->machine));
  ASSERT_TRUE(again) << again.error().to_string();
  EXPECT_EQ(json::dump(machine_value(again->machine)), json::dump(machine_value(file->machine)));
  EXPECT_EQ(again->machine.name, "Mill 1");
  EXPECT_DOUBLE_EQ(again->machine.scale_uncertainty->in_um_per_m(), 0.2);
  EXPECT_EQ(again->machine.stations.front().at_mm, (Vector3{1, 2, 3}));
  EXPECT_EQ(again->machine.functional_point_mm[1], (Vector3{10, 0, -20}));
}

TEST(MachineJson, TellsMembersThatNobodyKnows) {
  const auto file = read_machine(with(R"(, "colour": "green")"));
  ASSERT_TRUE(file) << file.error().to_string();
  EXPECT_THAT(file->remarks, ElementsAre("passed over the member colour of the machine's file"));
}

TEST(MachineJson, RefusesWhatIsNoMachine) {
  EXPECT_THAT(machine_refusal("{}"), HasSubstr("chain"));
  EXPECT_THAT(machine_refusal(with(R"(, "chains": "XFYZ")")), HasSubstr("chain")) << "a member with a typing error";
  EXPECT_THAT(machine_refusal(R"({"chain": "XXFZ"})"), HasSubstr("found the chain \"XXFZ\""));
  EXPECT_THAT(machine_refusal(with(R"(, "repeatability_um": -1)")), HasSubstr("expected 0 to 10000"));
  EXPECT_THAT(machine_refusal(with(R"(, "instrument": {"a_um": 0, "b_um_per_m": 0})")),
              HasSubstr("without any uncertainty"));
  EXPECT_THAT(machine_refusal(with(R"(, "stations_mm": {"S1": [1e10, 0, 0]})")), HasSubstr("expected at most 1e9 mm"));
  EXPECT_THAT(machine_refusal(R"({"chain": "XFYZ", "travel_mm": {"X": [1000, 0], "Y": [0, 600], "Z": [-500, 0]}})"),
              HasSubstr("expected its lower end first"));
  EXPECT_THAT(machine_refusal(
                  R"({"chain": "XFYZ", "travel_mm": {"X": [0, 1], "Y": [0, 600], "Z": [-500, 0]}, "tools_mm": {}})"),
              HasSubstr("found no tool"));
}

}  // namespace
}  // namespace axiometry::formats
