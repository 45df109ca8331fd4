// SPDX-License-Identifier: Apache-2.0
#include "axiometry/formats/volumetric/true_errors_json.h"

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <string>

#include "axiometry/formats/volumetric/machine_json.h"

namespace axiometry::formats {
namespace {

using ::testing::HasSubstr;

constexpr TravelBox small_travel = {{0, 0, -500}, {1000, 600, 0}};
const volumetric::MachineModel small_machine = {
    .chain = *volumetric::KinematicChain::make("XFYZ"), .travel = small_travel, .tools = {{"T1", {0, 0, -100}}}};

std::string refusal_of_errors(std::string_view text) {
  const auto errors = read_true_errors(text, small_machine);
  return errors ? "none" : errors.error().to_string();
}

TEST(TrueErrorsJson, AreReadBackAsTheyAreWritten) {
  const volumetric::TrueErrors drawn = volumetric::drawn_errors(small_travel, {}, {.seed = 4});
  json::Value file = json::Value::object();
  file.add("errors", true_errors_value(drawn));
  const auto read = read_true_errors(json::dump(file), small_machine);
  ASSERT_TRUE(read) << read.error().to_string();
  EXPECT_EQ(json::dump(true_errors_value(*read)), json::dump(true_errors_value(drawn)));
}

TEST(TrueErrorsJson, HoldWhatEachDirectionIs) {
  volumetric::TrueErrors drawn = volumetric::drawn_errors(small_travel, {}, {.seed = 4});
  drawn = volumetric::with_drawn_reversal(drawn, small_travel, volumetric::Reversal::curves, {}, {.seed = 4});
  json::Value file = json::Value::object();
  file.add("errors", true_errors_value(drawn));
  const auto read = read_true_errors(json::dump(file), small_machine);
  ASSERT_TRUE(read) << read.error().to_string();
  for (const double approach : {-1.0, 0.0, 1.0}) {
    const volumetric::Approaches approaches = {approach, -approach, approach};
    const volumetric::ErrorValues is = read->at({333, 222, -111}, approaches);
    const volumetric::ErrorValues was = drawn.at({333, 222, -111}, approaches);
    for (std::size_t a = 0; a < 3; ++a)
      for (std::size_t m = 0; m < 6; ++m) EXPECT_NEAR(is.motions[a][m], was.motions[a][m], 1e-12);
  }
}

TEST(TrueErrorsJson, RefuseOneDirectionAlone) {
  const auto with = [](std::string_view second) {
    return refusal_of_errors(
        fmt::format(R"({{"errors": {{"EXX": [
                       {{"position": 0, "value": 1, "up": {{"value": 2}}, "down": {{"value": 0}}}},
                       {{"position": 1000, "value": 3{}}}]}}}})",
                    second));
  };
  EXPECT_EQ(with(R"(, "up": {"value": 4}, "down": {"value": 2})"), "none");
  EXPECT_THAT(with(""), HasSubstr("found values of EXX with and without those of each direction"));
  EXPECT_THAT(with(R"(, "up": {"value": 4})"), HasSubstr("down"));
  EXPECT_THAT(with(R"(, "up": {"value": null}, "down": {"value": 2})"), HasSubstr("found no member \"value\" in EXX"));
}

TEST(TrueErrorsJson, AreNothingWhereTheFileHasNone) {
  const auto read = read_true_errors(
      R"({"errors": {"EXX": [{"position": 0, "value": 1}, {"position": 1000, "value": 3}]}})", small_machine);
  ASSERT_TRUE(read) << read.error().to_string();
  const volumetric::ErrorValues at = read->at({500, 100, -100});
  EXPECT_DOUBLE_EQ(at.motions[0][0], 2.0);
  EXPECT_DOUBLE_EQ(at.motions[1][1], 0.0);
  EXPECT_DOUBLE_EQ(at.squareness_urad[0], 0.0);
}

TEST(TrueErrorsJson, RefuseWhatIsNoErrorOfTheMachine) {
  EXPECT_THAT(refusal_of_errors("{}"), HasSubstr("errors"));
  EXPECT_THAT(refusal_of_errors(R"({"errors": {"EXQ": []}})"), HasSubstr("found the error \"EXQ\""));
  EXPECT_THAT(refusal_of_errors(R"({"errors": {"EXX": []}})"), HasSubstr("found no value of EXX"));
  EXPECT_THAT(
      refusal_of_errors(R"({"errors": {"EXX": [{"position": 300, "value": 1}, {"position": 1000, "value": 3}]}})"),
      HasSubstr("found EXX from 300 to 1000 mm, expected it over the travel of 0 to 1000 mm"));
  EXPECT_THAT(refusal_of_errors(R"({"errors": {"C0Y": {"value": 1e7}}})"), HasSubstr("expected at most 1e6"));
}

TEST(TrueErrorsJson, RefuseErrorsOfAMachineOnWhichTheyMeanSomethingElse) {
  const auto of_machine = [](const volumetric::MachineModel& machine, bool is_result) {
    json::Value file = json::Value::object();
    json::Value& owner = is_result ? file.add("model", json::Value::object()) : file;
    owner.add("machine", machine_value(machine));
    file.add("errors", true_errors_value({}));
    return json::dump(file);
  };
  for (const bool is_result : {false, true}) {
    volumetric::MachineModel other = small_machine;
    other.name = "another name";
    EXPECT_EQ(refusal_of_errors(of_machine(other, is_result)), "none");
    other.chain = *volumetric::KinematicChain::make("YFXZ");
    EXPECT_THAT(refusal_of_errors(of_machine(other, is_result)),
                HasSubstr("found errors of a machine of the chain YFXZ, expected those of one of the chain XFYZ"));
    other = small_machine;
    other.functional_point_mm[1] = {0, 0, -250};
    EXPECT_THAT(refusal_of_errors(of_machine(other, is_result)),
                HasSubstr("found errors of Y about its functional point (0, 0, -250) mm, expected about (0, 0, 0) mm"));
  }
}

}  // namespace
}  // namespace axiometry::formats
