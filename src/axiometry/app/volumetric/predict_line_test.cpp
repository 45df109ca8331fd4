// SPDX-License-Identifier: Apache-2.0
#include "axiometry/app/volumetric/predict_line.h"

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <string>
#include <string_view>

#include "axiometry/app/volumetric/field_volume.h"
#include "axiometry/formats/volumetric/volumetric_result_json.h"
#include "axiometry/volumetric/known_machine_test_support.h"
#include "tests/support/temporary_folder.h"

namespace axiometry::app {
namespace {

using ::testing::HasSubstr;
using volumetric::testing::known_errors;
using volumetric::testing::known_identification;
using volumetric::testing::known_machine;

std::string result_file(const testing_support::TemporaryFolder& folder) {
  json::Value root = json::Value::object();
  root.add("model", formats::error_model_value(known_identification(known_machine(), 100).model));
  return folder.written("result.json", json::dump(root, 0));
}

/// An axis test of the true machine along X, from its first to its last target in steps of 90 mm, with a scale error,
/// lines of metadata, and what it reads more upwards than downwards.
std::string measured_file(const testing_support::TemporaryFolder& folder, double um_per_m,
                          const std::string& metadata = "", double reversal_um = 0.0) {
  const auto machine = known_machine();
  std::string text = metadata + "target_mm,direction,run,deviation_um\n";
  for (int run = 1; run <= 3; ++run)
    for (const char* direction : {"up", "down"})
      for (int k = 0; k < 11; ++k) {
        const Vector3 q{50.0 + 90.0 * k, 300, -250};
        const double x = volumetric::displacement_um(machine, known_errors(q), q, {0, 0, -150}).x;
        fmt::format_to(std::back_inserter(text), "{},{},{},{:.3f}\n", q.x, direction, run,
                       x + 1e-3 * um_per_m * q.x + 7.0 + 0.05 * ((k * 7 + run * 3) % 5 - 2) +
                           (direction[0] == 'u' ? 0.5 : -0.5) * reversal_um);
      }
  return folder.written("measured.csv", text);
}

TEST(PredictTest, AgreesWithATestOfTheSameMachineAndDepartsFromOneOfAnother) {
  const testing_support::TemporaryFolder folder;
  PredictRequest request{.result = result_file(folder), .axis = "X", .at = "y=300, Z=-250", .tool = "T1"};
  request.measured = measured_file(folder, 0.0);
  const auto same = predict_test(request);
  ASSERT_TRUE(same) << same.error().to_string();
  EXPECT_EQ(same->predicted.line.positions_mm.front(), 50.0);
  EXPECT_GT(same->comparison->probability, 1e-3) << same->comparison->chi_squared;
  EXPECT_EQ(same->findings.front().id, "volumetric-prediction-agrees");
  request.measured = measured_file(folder, 15.0);
  const auto other = predict_test(request);
  ASSERT_TRUE(other) << other.error().to_string();
  EXPECT_EQ(other->findings.front().id, "volumetric-prediction-departs");
  EXPECT_TRUE(other->findings.front().serious);
  const auto shown = present(*other, {});
  EXPECT_EQ(json::dump(*shown.json.find("comparison")->find("agrees")), "false");
}

const NamedFinding* finding_of(const PredictedTest& test, std::string_view id) {
  const auto at = std::ranges::find(test.findings, id, &NamedFinding::id);
  return at == test.findings.end() ? nullptr : &*at;
}

TEST(PredictTest, SaysThatATestWhoseScatterHidesTheErrorsTellsLittle) {
  const testing_support::TemporaryFolder folder;
  PredictRequest request{.result = result_file(folder), .axis = "X", .at = "y=300,z=-250", .tool = "T1"};
  request.measured = measured_file(folder, 0.0);
  const auto sharp = predict_test(request);
  ASSERT_TRUE(sharp) << sharp.error().to_string();
  EXPECT_EQ(finding_of(*sharp, "volumetric-prediction-weak"), nullptr);
  std::string text = "target_mm,direction,run,deviation_um\n";
  for (int run = 1; run <= 2; ++run)
    for (const char* direction : {"up", "down"})
      for (int k = 0; k < 11; ++k)
        fmt::format_to(std::back_inserter(text), "{},{},{},{}\n", 50 + 90 * k, direction, run,
                       400 * ((k * 7 + run * 3 + (direction[0] == 'u' ? 2 : 0)) % 5 - 2));
  request.measured = folder.written("scattered.csv", text);
  const auto weak = predict_test(request);
  ASSERT_TRUE(weak) << weak.error().to_string();
  ASSERT_NE(finding_of(*weak, "volumetric-prediction-agrees"), nullptr) << weak->comparison->chi_squared;
  ASSERT_NE(finding_of(*weak, "volumetric-prediction-weak"), nullptr);
  EXPECT_FALSE(finding_of(*weak, "volumetric-prediction-weak")->serious);
}

/// As measured_file(), of runs that each have a scale error of their own.
std::string tilted_file(const testing_support::TemporaryFolder& folder, const std::array<double, 5>& um_per_m) {
  const auto machine = known_machine();
  std::string text = "target_mm,direction,run,deviation_um\n";
  for (std::size_t run = 0; run < um_per_m.size(); ++run)
    for (int d = 0; d < 2; ++d)
      for (int k = 0; k < 11; ++k) {
        const Vector3 q{50.0 + 90.0 * k, 300, -250};
        const double x = volumetric::displacement_um(machine, known_errors(q), q, {0, 0, -150}).x;
        fmt::format_to(std::back_inserter(text), "{},{},{},{:.3f}\n", q.x, d == 0 ? "up" : "down", run + 1,
                       x + 1e-3 * um_per_m[run] * (q.x - 500.0) +
                           0.05 * static_cast<double>((k * 7 + static_cast<int>(run) * 3 + 2 * d) % 5 - 2));
      }
  return folder.written("tilted.csv", text);
}

TEST(PredictTest, HoldsTheMeanSlopeOfRunsOfATestAsUncertainAsTheyLetItBe) {
  const testing_support::TemporaryFolder folder;
  PredictRequest request{.result = result_file(folder), .axis = "X", .at = "y=300,z=-250", .tool = "T1"};
  request.measured = tilted_file(folder, {-8, 6, 3, 9, 5});  // mean 3, standard uncertainty 2.9 µm/m
  const auto tilted = predict_test(request);
  ASSERT_TRUE(tilted) << tilted.error().to_string();
  EXPECT_EQ(tilted->findings.front().id, "volumetric-prediction-agrees") << tilted->comparison->chi_squared;
  request.measured = tilted_file(folder, {3, 3, 3, 3, 3});
  const auto alike = predict_test(request);
  ASSERT_TRUE(alike);
  EXPECT_EQ(alike->findings.front().id, "volumetric-prediction-departs") << "runs that agree about their slope";
  request.measured = tilted_file(folder, {52, 66, 63, 69, 65});
  const auto other = predict_test(request);
  ASSERT_TRUE(other);
  EXPECT_EQ(other->findings.front().id, "volumetric-prediction-departs") << "more than the runs explain";
}

TEST(PredictTest, DoesNotJustAgreeWithATestWhoseReversalTheErrorsDoNotHold) {
  const testing_support::TemporaryFolder folder;
  PredictRequest request{.result = result_file(folder), .axis = "X", .at = "y=300,z=-250", .tool = "T1"};
  request.measured = measured_file(folder, 0.0, "", 40.0);
  const auto large = predict_test(request);
  ASSERT_TRUE(large) << large.error().to_string();
  EXPECT_EQ(large->findings.front().id, "volumetric-prediction-reversal");
  EXPECT_TRUE(large->findings.front().serious);
  EXPECT_THAT(large->findings.front().message, HasSubstr("differ by up to 40.00 µm"));
  ASSERT_NE(finding_of(*large, "volumetric-prediction-agrees"), nullptr);
  EXPECT_THAT(finding_of(*large, "volumetric-prediction-agrees")->message, HasSubstr("but for what its directions"));
  EXPECT_EQ(json::dump(*present(*large, {}).json.find("comparison")->find("agrees")), "false");
  request.measured = measured_file(folder, 0.0, "", 1.0);  // as most machines have
  const auto small = predict_test(request);
  ASSERT_TRUE(small);
  ASSERT_NE(finding_of(*small, "volumetric-prediction-reversal"), nullptr);
  EXPECT_FALSE(finding_of(*small, "volumetric-prediction-reversal")->serious);
  EXPECT_EQ(json::dump(*present(*small, {}).json.find("comparison")->find("agrees")), "true");
}

TEST(PredictTest, LooksAtWhatTheTestSaysOfItself) {
  const testing_support::TemporaryFolder folder;
  const std::string result = result_file(folder);
  const auto fault = [&](const std::string& metadata, const std::string& at = "y=300,z=-250") {
    const auto found = predict_test(
        {.result = result, .axis = "X", .at = at, .tool = "T1", .measured = measured_file(folder, 0.0, metadata)});
    return found ? std::string("none") : found.error().to_string();
  };
  EXPECT_EQ(fault("# axis.name: X\n"), "none");
  EXPECT_EQ(fault("# axis.name: X1\n"), "none");
  EXPECT_EQ(fault("# axis.name: carriage\n"), "none");
  EXPECT_THAT(fault("# axis.name: Y\n"), HasSubstr("found the axis \"Y\" in the plan or test, expected X"));
  const std::string line = "# axis.line_origin_mm: 0 300 -250\n# axis.line_direction: 1 0 0\n";
  EXPECT_EQ(fault(line), "none");
  EXPECT_THAT(fault(line, "y=310,z=-250"), HasSubstr("10.0 mm beside X"));
  EXPECT_EQ(fault(line + "# test.tool_offset_mm: 0 0 -150\n"), "none");
  EXPECT_THAT(fault(line + "# test.tool_offset_mm: 0 0 -300\n"), HasSubstr("that of the tool \"T1\""));
  EXPECT_EQ(fault("# test.tool_offset_mm: 0 0 150\n"), "none") << "nobody knows from where it is counted";
  PredictRequest both{.result = result, .axis = "X", .at = "y=300,z=-250", .tool = "T1"};
  both.measured = measured_file(folder, 0.0, "# test.tool_offset_mm: 0 0 150\n");
  const auto told = predict_test(both);
  ASSERT_TRUE(told);
  EXPECT_NE(finding_of(*told, "volumetric-prediction-tool"), nullptr);
  PredictRequest stated{.result = result, .tool = "T1", .measured = measured_file(folder, 0.0, line)};
  const auto by_line = predict_test(stated);
  ASSERT_TRUE(by_line) << by_line.error().to_string();
  EXPECT_EQ(by_line->predicted.line.name, "X");
  both.plan = both.measured;
  const auto refused = predict_test(both);
  ASSERT_FALSE(refused);
  EXPECT_THAT(refused.error().message, HasSubstr("both a plan and a measured test"));
}

TEST(PredictTest, SaysWhatItMissesOfTheLine) {
  const testing_support::TemporaryFolder folder;
  const std::string result = result_file(folder);
  const auto fault = [&](PredictRequest request) {
    request.result = result;
    const auto found = predict_test(request);
    return found ? std::string("none") : found.error().to_string();
  };
  EXPECT_THAT(fault({.axis = "X", .tool = "T1"}), HasSubstr("found no place of Y"));
  EXPECT_THAT(fault({.axis = "X", .at = "y=300,z", .tool = "T1"}), HasSubstr("expected where the other axes stand"));
  EXPECT_THAT(fault({.axis = "X", .at = "x=700,y=300,z=-250", .tool = "T1"}), HasSubstr("X moves along the line"));
  EXPECT_THAT(fault({.axis = "X", .at = "y=300,y=200,z=-250", .tool = "T1"}), HasSubstr("found two places of Y"));
  EXPECT_THAT(fault({.diagonal = "PPP-NNN", .at = "y=300", .tool = "T1"}), HasSubstr("and no axis"));
  EXPECT_THAT(fault({.axis = "W", .at = "y=300", .tool = "T1"}), HasSubstr("expected X, Y or Z"));
  EXPECT_THAT(fault({.diagonal = "PPP-NNN"}), HasSubstr("found no tool, expected one of T1, T2, T3"));
  EXPECT_THAT(fault({.diagonal = "PPP", .tool = "T1"}), HasSubstr("expected one of PPP-NNN, NPP-PNN"));
  EXPECT_THAT(fault({.tool = "T1"}), HasSubstr("found no line"));
  EXPECT_THAT(fault({.axis = "X", .at = "y=900,z=-250", .tool = "T1"}), HasSubstr("where the errors are known"));
  EXPECT_EQ(fault({.diagonal = "XY PP-NN", .tool = "T3"}), "none");
}

TEST(FieldVolume, WritesEveryNodeAndTheStatisticsOfEveryTool) {
  const testing_support::TemporaryFolder folder;
  const auto volume = field_volume({result_file(folder), 3});
  ASSERT_TRUE(volume) << volume.error().to_string();
  const std::string csv = field_csv(*volume);
  EXPECT_EQ(std::ranges::count(csv, '\n'), 1 + 3 * 27);
  const auto shown = present(*volume, {});
  EXPECT_EQ(shown.json.find("tools")->items().size(), 3u);
  EXPECT_GT(volume->fields[0].statistics.as_found->largest.value, 1.0);
}

}  // namespace
}  // namespace axiometry::app
