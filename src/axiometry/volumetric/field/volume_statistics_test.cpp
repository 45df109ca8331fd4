// SPDX-License-Identifier: Apache-2.0
#include "axiometry/volumetric/field/volume_statistics.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "axiometry/volumetric/field/field_rows.h"
#include "axiometry/volumetric/field/line_prediction.h"
#include "axiometry/volumetric/known_machine_test_support.h"
#include "tests/support/statistics_of_trials.h"

namespace axiometry::volumetric {
namespace {

using testing::known_errors;
using testing::known_identification;
using testing::known_lengths;
using testing::known_machine;

/// A machine with nothing but squareness C0Y, in µrad, known exactly.
ErrorModel with_squareness(double c0y, Reversal reversal = Reversal::none, double exx_half = 0.0) {
  const auto basis = [](double low, double high) { return *CurveBasis::make(CurveKind::nodes, low, high, 1); };
  const Coefficients coefficients({basis(0, 1000), basis(0, 600), basis(-500, 0)}, reversal);
  std::vector<double> values(coefficients.raw(), 0.0);
  values[coefficients.squareness()] = c0y;
  if (reversal == Reversal::constant) values[coefficients.half(0)] = exx_half;
  const std::size_t n = coefficients.raw();
  std::vector<double> covariance(n * n, 0.0);
  covariance[coefficients.squareness() * n + coefficients.squareness()] = 0.25;
  MachineModel machine = known_machine();
  return ErrorModel({machine, coefficients, values, covariance, {}, machine.travel});
}

TEST(VolumeStatistics, OfSquarenessAreThoseOfItsShear) {
  const auto found = volume_statistics(with_squareness(10.0), {0, 0, -150}, 5);
  ASSERT_TRUE(found.as_found && found.without_rigid_motion);
  EXPECT_NEAR(found.as_found->largest.value, 6.0, 1e-12);  // 10 µrad · 600 mm
  EXPECT_NEAR(found.as_found->largest.u, 0.3, 1e-12);      // 0.5 µrad · 600 mm
  EXPECT_EQ(found.as_found->largest_at_mm.y, 600.0);
  EXPECT_NEAR(found.as_found->mean, 3.0, 1e-12);
  EXPECT_NEAR(found.as_found->percent_95, 6.0, 1e-12);
  // δx = −c y is a rotation about Z by c σ_y²/(σ_x² + σ_y²) and a shear that stays; of the rotation δx = −ω y.
  const double turned = 10.0 * 600 * 600 / (1000.0 * 1000 + 600 * 600);
  EXPECT_NEAR(found.rotation_urad.z, turned, 1e-9);
  EXPECT_NEAR(found.without_rigid_motion->largest.value, std::hypot((10 - turned) * 0.3, turned * 0.5), 1e-9);
  EXPECT_NEAR(found.without_rigid_motion->largest.u, found.without_rigid_motion->largest.value * 0.05, 1e-9);
}

TEST(VolumeStatistics, HaveNoNumberWhereTheLengthsDoNotTellTheField) {
  MachineModel machine = known_machine("FXYZ");
  machine.tools.resize(2);
  const auto found = known_identification(machine);
  EXPECT_TRUE(volume_statistics(found.model, {0, 0, -200}, 4).without_rigid_motion) << "a tool on the same line";
  EXPECT_FALSE(volume_statistics(found.model, {200, 0, -200}, 4).without_rigid_motion) << "a tool beside it";
  EXPECT_FALSE(volume_statistics(found.model, {200, 0, -200}, 4).as_found);
}

TEST(VolumeStatistics, LieWithinTheirUncertaintyOfTheTruth) {
  AXIOMETRY_STATISTICS_OF_TRIALS();
  const MachineModel machine = known_machine();
  const auto found = known_identification(machine, 100);
  constexpr std::size_t nodes = 6;
  const auto told = volume_statistics(found.model, machine.tools[0].offset_mm, nodes).without_rigid_motion;
  ASSERT_TRUE(told);
  // The same of the truth: a model of node tables with the exact errors would need no fit; here only the size is held.
  EXPECT_GT(told->largest.value, 3.0);
  EXPECT_LT(told->largest.u, 1.5);
  EXPECT_LE(told->mean, told->percent_95);
  EXPECT_LE(told->percent_95, told->largest.value);
}

/// Validation: of 41 × 41 × 41 places one by one, whatever the grid, the largest is not more.
TEST(VolumeStatistics, CallLargestWhatIsLargestAnywhere) {
  for (const std::size_t places : {60u, 100u}) {
    const auto found = known_identification(known_machine(), places);
    const ErrorModel& model = found.model;
    for (const Vector3 tool : {Vector3{0, 0, -150}, Vector3{120, 60, -180}})
      for (const std::size_t nodes : {3u, 11u}) {
        const VolumeStatistics told = volume_statistics(model, tool, nodes);
        ASSERT_TRUE(told.as_found && told.without_rigid_motion);
        const RemainingSizes nothing_taken =
            sizes_without(model, tool, {.nodes = nodes}, [](Vector3) { return Vector3{}; });
        EXPECT_EQ(nothing_taken.as_found.largest_at_mm, told.as_found->largest_at_mm);
        EXPECT_EQ(nothing_taken.without_rigid_motion.largest_at_mm, told.without_rigid_motion->largest_at_mm);
        const auto alone = sizes_without_rigid_motion(model, tool, nodes);
        ASSERT_TRUE(alone);
        EXPECT_EQ(alone->largest.u, told.without_rigid_motion->largest.u);
        EXPECT_EQ(remaining_without_rigid_motion(model, tool, {.nodes = nodes}, [](Vector3) { return Vector3{}; })
                      .largest.value,
                  nothing_taken.without_rigid_motion.largest.value);
        const Vector3 middle = place_in(model.observed(), {0.5, 0.5, 0.5});
        double as_found = 0.0, without_motion = 0.0;
        constexpr int steps = 40;
        for (int i = 0; i <= steps; ++i)
          for (int j = 0; j <= steps; ++j)
            for (int k = 0; k <= steps; ++k) {
              const Vector3 q = place_in(model.observed(), {i / double(steps), j / double(steps), k / double(steps)});
              const Vector3 error = field_um(model, model.parts().values, q, tool);
              as_found = std::max(as_found, norm(error));
              without_motion = std::max(
                  without_motion, norm(error - told.translation_um - cross(told.rotation_urad, 1e-3 * (q - middle))));
            }
        EXPECT_GE(told.as_found->largest.value, 0.99 * as_found) << nodes;
        EXPECT_LE(told.as_found->largest.value, 1.01 * as_found) << nodes;
        EXPECT_GE(told.without_rigid_motion->largest.value, 0.99 * without_motion) << nodes;
        EXPECT_LE(told.without_rigid_motion->largest.value, 1.01 * without_motion) << nodes;
      }
  }
}

TEST(FieldSlice, HoldsTheFieldOfItsPlane) {
  const FieldSlice slice = field_slice(with_squareness(10.0), {0, 0, 0}, 2, -100.0, 3);
  ASSERT_EQ(slice.error_um.size(), 9u);
  EXPECT_EQ(slice.up_axis, 1u);
  EXPECT_NEAR(slice.error_um[8]->x, -6.0, 1e-12);
  EXPECT_NEAR(slice.error_um[2]->x, 0.0, 1e-12);
}

TEST(LinePrediction, OfADiagonalHoldsSquarenessAsSlope) {
  // Along the face diagonal (a, b)/L a shear δx = −c y makes −c a b/L² of the length.
  const ErrorModel model = with_squareness(10.0);
  const auto predicted = predict_line(model, *diagonal_line(model, "XY PP-NN", {0, 0, 0}));
  ASSERT_TRUE(predicted);
  const double expected = -10.0 * 600 * 1000 / (1000.0 * 1000 + 600 * 600);
  EXPECT_NEAR(predicted->slope_um_per_m.value, expected, 1e-9);
  EXPECT_NEAR(predicted->slope_um_per_m.u, -expected * 0.05, 1e-9);
  EXPECT_NEAR(predicted->systematic.value, -expected * std::hypot(1.0, 0.6), 1e-9);
  const auto other = predict_line(model, *diagonal_line(model, "XY NP-PN", {0, 0, 0}));
  EXPECT_NEAR(other->slope_um_per_m.value, -expected, 1e-9);
}

TEST(LinePrediction, ShowsReversalAsTheDifferenceOfTheDirections) {
  const ErrorModel model = with_squareness(0.0, Reversal::constant, 1.5);
  const auto predicted = predict_line(model, axis_line(model, 0, {0, 300, -200}, {0, 0, 0}));
  ASSERT_TRUE(predicted);
  EXPECT_NEAR(predicted->reversal_um, 3.0, 1e-12);
  EXPECT_NEAR(predicted->up[0].value, 1.5, 1e-12);
  EXPECT_NEAR(predicted->systematic.value, 3.0, 1e-12);
  EXPECT_NEAR(predict_line(model, axis_line(model, 1, {0, 0, 0}, {0, 0, 0}))->reversal_um, 0.0, 1e-12);
}

TEST(LinePrediction, KnowsEveryDiagonalByNameAndNoOther) {
  const ErrorModel model = with_squareness(1.0);
  EXPECT_EQ(diagonal_names().size(), 10u);
  for (const std::string& name : diagonal_names()) EXPECT_TRUE(diagonal_line(model, name, {0, 0, 0})) << name;
  for (const char* other :
       {"NNN-PPN", "PPP", "NN0-NP0", "N00-P00", "YX PP-NN", "XX PP-NN", "XY PPNNN", "ABC-PPP", "", "XW PP-NN"})
    EXPECT_FALSE(diagonal_line(model, other, {0, 0, 0})) << other;
  // As plans of ISO 230-6 name and begin them (iso230_6::Diagonal).
  const std::pair<const char*, Vector3> planned[] = {
      {"NNN-PPP", {0, 0, -500}}, {"NPP-PNN", {0, 600, 0}}, {"NP0-PN0", {0, 600, -250}}, {"0NP-0PN", {500, 0, 0}}};
  for (const auto& [name, begin] : planned) {
    const auto line = diagonal_line(model, name, {0, 0, 0});
    ASSERT_TRUE(line) << name;
    EXPECT_EQ(line->from_mm, begin) << name;
  }
  EXPECT_EQ(diagonal_line(model, "XY NP-PN", {0, 0, 0})->from_mm, diagonal_line(model, "NP0-PN0", {0, 0, 0})->from_mm);
  EXPECT_EQ(diagonal_line(model, "PPP-NNN", {0, 0, 0})->from_mm, (Vector3{1000, 600, 0}));
}

/// What a perfect instrument would find along a line.
MeasuredMeans measured_truth(const MachineModel& machine, const TestedLine& line, double added_per_m) {
  MeasuredMeans means;
  const Vector3 along = unit(line.to_mm - line.from_mm);
  for (const double position : line.positions_mm) {
    const Vector3 q = line.from_mm + (position - line.first_mm) * along;
    const Vector3 error = displacement_um(machine, known_errors(q), q, line.tool_mm);
    const double value =
        error.x * along.x + error.y * along.y + error.z * along.z + 1e-3 * added_per_m * (position - line.first_mm);
    means.up_um.push_back(value + 100.0);  // another zero
    means.down_um.push_back(value + 100.0);
    means.up_u_um.push_back(0.02);
    means.down_u_um.push_back(0.02);
  }
  return means;
}

/// A mean of both directions cannot show what they differ by: half of it off one way, half the other.
TEST(LineComparison, TellsAReversalThatErrorsWithoutDirectionsCannotHold) {
  const MachineModel machine = known_machine();
  const auto found = known_identification(machine, 150);
  const TestedLine line = axis_line(found.model, 0, {500, 300, -250}, {0, 0, -150});
  const auto predicted = predict_line(found.model, line);
  ASSERT_TRUE(predicted);
  MeasuredMeans means = measured_truth(machine, line, 0.0);
  const LineComparison still = compare(*predicted, means);
  ASSERT_TRUE(still.reversal);
  EXPECT_EQ(still.reversal->largest_um, 0.0);
  EXPECT_GT(still.reversal->probability, 0.999);
  for (double& x : means.up_um) x += 7.5;
  for (double& x : means.down_um) x -= 7.5;
  const LineComparison moved = compare(*predicted, means);
  EXPECT_NEAR(moved.chi_squared, still.chi_squared, 1e-6 * still.chi_squared);
  EXPECT_NEAR(moved.reversal->largest_um, 15.0, 1e-9);
  EXPECT_NEAR(moved.reversal->systematic_um, still.reversal->systematic_um + 15.0, 1e-9);
  EXPECT_LT(moved.reversal->probability, 1e-6);
  means.both_directions = false;
  EXPECT_FALSE(compare(*predicted, means).reversal);
}

TEST(LineComparison, AgreesWithTheTruthAndDepartsFromAnother) {
  const MachineModel machine = known_machine();
  const auto found = known_identification(machine, 150);
  std::vector<TestedLine> lines;
  for (std::size_t a = 0; a < 3; ++a) lines.push_back(axis_line(found.model, a, {500, 300, -250}, {0, 0, -150}));
  for (const std::string& name : diagonal_names()) lines.push_back(*diagonal_line(found.model, name, {0, 0, -300}));
  for (const TestedLine& line : lines) {
    const auto predicted = predict_line(found.model, line);
    ASSERT_TRUE(predicted);
    const LineComparison agreed = compare(*predicted, measured_truth(machine, line, 0.0));
    EXPECT_EQ(agreed.degrees_of_freedom, 10u);
    EXPECT_GT(agreed.probability, 1e-4) << line.name << " " << agreed.chi_squared;
    const LineComparison departed = compare(*predicted, measured_truth(machine, line, 20.0));
    EXPECT_LT(departed.probability, 1e-6) << line.name << " " << departed.chi_squared;
  }
}

}  // namespace
}  // namespace axiometry::volumetric
