// SPDX-License-Identifier: Apache-2.0
#include "axiometry/formats/compensation/compensation.h"

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <string>
#include <string_view>
#include <system_error>
#include <vector>

#include "axiometry/formats/format.h"
#include "axiometry/volumetric/field/axis_tables.h"
#include "axiometry/volumetric/field/machine_zero.h"
#include "axiometry/volumetric/known_machine_test_support.h"

namespace axiometry::formats {
namespace {

using ::testing::HasSubstr;
using volumetric::Coefficients;
using volumetric::CurveBasis;
using volumetric::CurveKind;
using volumetric::ErrorModel;
using volumetric::testing::known_identification;
using volumetric::testing::known_machine;

/// Only EXX, a straight line of 20 µm/m, and C0Y of 10 µrad; with reversal EXX is 3 µm more upwards, and less
/// downwards.
ErrorModel scale_and_squareness(volumetric::Reversal reversal = volumetric::Reversal::none) {
  const auto basis = [](double low, double high) { return *CurveBasis::make(CurveKind::nodes, low, high, 1); };
  const Coefficients coefficients({basis(0, 1000), basis(0, 600), basis(-500, 0)}, reversal);
  const std::size_t n = coefficients.raw();
  std::vector<double> values(n, 0.0), covariance(n * n, 0.0);
  values[coefficients.curve(0)] = -10.0;
  values[coefficients.curve(0) + volumetric::motion_count] = 10.0;
  values[coefficients.squareness()] = 10.0;
  if (reversal == volumetric::Reversal::constant) values[coefficients.half(0)] = 3.0;
  auto machine = known_machine();
  machine.name = "Mill\n1";
  return ErrorModel({machine, coefficients, values, covariance, {}, machine.travel});
}

std::string written(const char* id, const ErrorModel& model, std::size_t nodes = 3) {
  const auto table = compensation_named(id);
  EXPECT_TRUE(table);
  const auto text = (*table)->write({model, 0, nodes});
  return text ? *text : text.error().to_string();
}

TEST(Compensation, OfEveryTableSaysWhatAPositiveNumberDoes) {
  EXPECT_EQ(compensation_table().size(), 3u);
  for (const Compensation* table : compensation_table()) {
    const std::string text = written(std::string(table->id).c_str(), scale_and_squareness());
    EXPECT_THAT(text, HasSubstr("A positive number: ")) << table->id;
    EXPECT_THAT(text, HasSubstr("Machine: Mill 1\n")) << table->id;
    EXPECT_THAT(text, HasSubstr("XFYZ")) << table->id;
    EXPECT_THAT(text, HasSubstr("with these tables, predicted, largest ")) << table->id;
  }
  EXPECT_THAT(compensation_named("fanuc").error().message, HasSubstr("expected one of axis-csv, general-csv"));
}

TEST(Compensation, SaysBeforeAllElseWhatSpeaksAgainstIt) {
  const ErrorModel model = scale_and_squareness();
  for (const Compensation* table : compensation_table()) {
    const auto plain = written_table(*table, {model, 0, 3}, ""), warned = written_table(*table, {model, 0, 3}, "NO");
    ASSERT_TRUE(plain && warned);
    EXPECT_EQ(*plain, *table->write({model, 0, 3}));
    EXPECT_EQ(*warned, fmt::format("{} NO\n{}", table->comment, *plain));
    EXPECT_TRUE(plain->starts_with(fmt::format("{} ", table->comment))) << table->id;
  }
  EXPECT_TRUE(recognise(*written_table(**compensation_named("twincat-cnc"), {model, 0, 3}, "NO")));
}

TEST(Compensation, GeneralTableHoldsAll21Errors) {
  const std::string text = written("general-csv", scale_and_squareness());
  EXPECT_THAT(text, HasSubstr("X_mm,EXX_um,EYX_um,EZX_um,EAX_urad"));
  EXPECT_THAT(text, HasSubstr(",C0Y_urad,B0Z_urad,A0Z_urad\n0,-10.0000,0.0000"));
  EXPECT_THAT(text, HasSubstr("\n1000,10.0000,"));
  EXPECT_THAT(text, HasSubstr(",10.0000,0.0000,0.0000\n"));
}

TEST(Compensation, VolumetricTableIsReadBackByTheReaderOfSuchTables) {
  const std::string text = written("twincat-cnc", scale_and_squareness());
  EXPECT_THAT(text, HasSubstr("chain, workpiece to tool: XYZ; workpiece_axes: X\n"));
  EXPECT_THAT(text, HasSubstr("\nY EXY EYY EZY EAY EBY ECY C0Y\n"));
  EXPECT_THAT(text, HasSubstr(" 0.000010000\n"));
  const auto format = recognise(text);
  ASSERT_TRUE(format) << format.error().to_string();
  EXPECT_EQ((*format)->id, "isg-csv");
  const std::string x = text.substr(0, text.find("\n#") + 1);
  const auto test = (*format)->read(x);
  ASSERT_TRUE(test) << test.error().to_string();
  EXPECT_NEAR(test->series.reading(0, Direction::up, 0)->in_native(), -10.0, 1e-9);
  EXPECT_NEAR(test->series.reading(2, Direction::up, 0)->in_native(), 10.0, 1e-9);
}

TEST(Compensation, OfSingleAxesSaysWhatStays) {
  const auto tables = volumetric::axis_tables(scale_and_squareness(), {0, 0, -150}, 3);
  ASSERT_TRUE(tables);
  EXPECT_NEAR(tables->axes[0][0].deviation.value, -10.0, 1e-9);
  EXPECT_NEAR(tables->axes[1][2].deviation.value, 0.0, 1e-9) << "squareness is no positioning";
  // The scale goes, and of squareness the shear stays that no rotation takes away.
  const double turned = 10.0 * 600 * 600 / (1000.0 * 1000 + 600 * 600);
  EXPECT_NEAR(tables->effect.after.largest.value, std::hypot((10 - turned) * 0.3, turned * 0.5), 1e-9);
  EXPECT_GT(tables->effect.before.largest.value, tables->effect.after.largest.value + 5.0);
  EXPECT_THAT(written("axis-csv", scale_and_squareness()), HasSubstr("\nX,1000,10.0000,0.0000\n"));
}

TEST(Compensation, OfEachDirectionWhereTheErrorsDiffer) {
  const ErrorModel model = scale_and_squareness(volumetric::Reversal::constant);
  const std::string axes = written("axis-csv", model);
  EXPECT_THAT(axes, HasSubstr("axis,position_mm,deviation_um,u_um,up_um,up_u_um,down_um,down_u_um\n"));
  EXPECT_THAT(axes, HasSubstr("\nX,1000,10.0000,0.0000,13.0000,0.0000,7.0000,0.0000\n"));
  EXPECT_THAT(axes, HasSubstr("half of what the directions differ by, up to 3.00\n"));
  const std::string general = written("general-csv", model);
  EXPECT_THAT(general, HasSubstr("\ndirection,X_mm,EXX_um"));
  EXPECT_THAT(general, HasSubstr("\nup,0,-7.0000,"));
  EXPECT_THAT(general, HasSubstr("\ndown,1000,7.0000,"));
  EXPECT_THAT(general, ::testing::Not(HasSubstr("half of what")));
  EXPECT_THAT(written("twincat-cnc", model), HasSubstr("half of what the directions differ by, up to 3.00\n"));
}

TEST(Compensation, HoldsMeansWhereNothingTellsTheDirectionsOfAnErrorItNeedsAndNamesThat) {
  const auto without = [](const volumetric::ErrorMotion& untold) {
    ErrorModel::Parts parts = scale_and_squareness(volumetric::Reversal::constant).parts();
    std::vector<double>& direction = parts.unseen.emplace_back(parts.coefficients.raw(), 0.0);
    direction[parts.coefficients.half(untold.axis) + untold.motion] = 1.0;
    return ErrorModel(std::move(parts));
  };
  const ErrorModel yaw = without({0, 5}), straight = without({0, 1});
  const std::string of_yaw = "# Nothing tells by what the directions differ of ECX.\n";
  for (const std::string& text : {written("general-csv", yaw), written("axis-csv", yaw)}) {
    EXPECT_THAT(text, HasSubstr("# The errors differ by direction; these are the means of both.\n" + of_yaw));
    EXPECT_THAT(text, HasSubstr("half of what the directions differ by, which is not told of all errors\n"));
    EXPECT_THAT(text, ::testing::Not(HasSubstr("direction,"))) << text;
    EXPECT_THAT(text, ::testing::Not(HasSubstr("up_um"))) << text;
  }
  EXPECT_THAT(written("general-csv", yaw), HasSubstr("\n1000,10.0000,"));
  EXPECT_THAT(written("axis-csv", yaw), HasSubstr("\nX,1000,10.0000,0.0000\n"));
  // Straightness of X moves no axis along itself.
  EXPECT_THAT(written("axis-csv", straight), HasSubstr("\nX,1000,10.0000,0.0000,13.0000,0.0000,7.0000,0.0000\n"));
  EXPECT_THAT(written("axis-csv", straight), HasSubstr("differ of EYX.\n"));
}

TEST(Compensation, OfAllErrorsLeavesWhatStraightLinesLeaveBetweenTheirPositions) {
  const auto found = known_identification(known_machine(), 80);
  const auto coarse = volumetric::effect_of_all_errors(found.model, {0, 0, -150}, 5);
  const auto fine = volumetric::effect_of_all_errors(found.model, {0, 0, -150}, 41);
  ASSERT_TRUE(coarse && fine);
  EXPECT_GT(coarse->after.largest.value, 10.0 * fine->after.largest.value);
  EXPECT_GT(fine->after.largest.value, 0.0) << "looked at between the positions";
  EXPECT_LT(coarse->after.largest.value, coarse->before.largest.value);
}

TEST(Compensation, LeavesLessOfARealFieldThanNone) {
  const auto found = known_identification(known_machine(), 80);
  const auto tables = volumetric::axis_tables(found.model, {0, 0, -150}, 41);
  ASSERT_TRUE(tables);
  EXPECT_LT(tables->effect.after.mean, tables->effect.before.mean);
}

std::string without_comments(const std::string& text, std::string_view mark) {
  std::string rows;
  for (std::size_t at = 0; at < text.size();) {
    const std::size_t end = text.find('\n', at);
    const std::string line = text.substr(at, end - at);
    if (!line.starts_with(mark)) rows += line + '\n';
    at = end == std::string::npos ? text.size() : end + 1;
  }
  return rows;
}

/// Numbers of two tables of one layout.
double farthest_apart(const std::string& a, const std::string& b) {
  const auto numbers = [](const std::string& text) {
    std::vector<double> all;
    for (const char *at = text.data(), *end = at + text.size(); at < end;) {
      double x = 0.0;
      const auto [behind, error] = std::from_chars(at, end, x);
      if (error == std::errc{}) all.push_back(x);
      at = error == std::errc{} ? behind : at + 1;
    }
    return all;
  };
  const std::vector<double> first = numbers(a), second = numbers(b);
  EXPECT_EQ(first.size(), second.size());
  double most = 0.0;
  for (std::size_t k = 0; k < std::min(first.size(), second.size()); ++k)
    most = std::max(most, std::abs(first[k] - second[k]));
  return most;
}

/// A control levers from the machine's zero, whatever point the report states straightness at.
TEST(Compensation, OfAllErrorsIsTheSameWhateverTheFunctionalPoints) {
  const auto plain = known_machine();
  auto elsewhere = plain;
  elsewhere.functional_point_mm = {Vector3{100, 50, -300}, {0, 200, 0}, {0, 0, -500}};
  const auto lengths = volumetric::testing::known_lengths(plain, 60);
  volumetric::IdentifyOptions options;
  options.sizes = {6, 6, 6};
  const auto at_zero = volumetric::identify(plain, lengths, options);
  const auto moved = volumetric::identify(elsewhere, lengths, options);
  ASSERT_TRUE(at_zero && moved);
  const volumetric::ErrorMotion eyx{0, 1};
  EXPECT_GT(std::abs(at_zero->model.motion(eyx, 0.0)->value - moved->model.motion(eyx, 0.0)->value), 0.1)
      << "the point counts";
  const auto back = volumetric::at_machine_zero(moved->model);
  for (const double x : {0.0, 300.0, 1000.0}) {
    const auto a = at_zero->model.motion(eyx, x), b = back.motion(eyx, x);
    EXPECT_NEAR(a->value, b->value, 2e-3);
    EXPECT_NEAR(a->u, b->u, 1e-2 * a->u);
  }
  for (const auto which : {volumetric::Squareness::C0Y, volumetric::Squareness::B0Z, volumetric::Squareness::A0Z}) {
    EXPECT_NEAR(at_zero->model.squareness(which)->value, back.squareness(which)->value, 5e-3);
    EXPECT_NEAR(at_zero->model.squareness(which)->u, back.squareness(which)->u, 1e-2 * back.squareness(which)->u);
  }
  // Not to the last digit: steps of the search end where they are small.
  EXPECT_LT(farthest_apart(without_comments(written("general-csv", at_zero->model), "#"),
                           without_comments(written("general-csv", moved->model), "#")),
            1e-2);
  EXPECT_LT(farthest_apart(without_comments(written("twincat-cnc", at_zero->model), "//"),
                           without_comments(written("twincat-cnc", moved->model), "//")),
            1e-5);
  EXPECT_THAT(written("twincat-cnc", moved->model),
              HasSubstr("at other points, mm: X 100 50 -300, Y 0 200 0, Z 0 0 -500\n"));
  EXPECT_THAT(written("general-csv", at_zero->model), HasSubstr("the machine's zero\n"));
  EXPECT_THAT(written("general-csv", at_zero->model), ::testing::Not(HasSubstr("at other points")));
}

TEST(Compensation, RefusesErrorsThatTheLengthsDoNotTell) {
  auto machine = known_machine("FXYZ");
  machine.tools.resize(2);
  const auto found = known_identification(machine);
  for (const char* id : {"general-csv", "twincat-cnc"})
    EXPECT_THAT(written(id, found.model), HasSubstr("the readings do not tell ECY and ECZ, expected all 21 errors"));
  EXPECT_THAT(written("axis-csv", found.model), HasSubstr("axis,position_mm,deviation_um,u_um"))
      << "both errors do not move a tool on their line";
}

}  // namespace
}  // namespace axiometry::formats
