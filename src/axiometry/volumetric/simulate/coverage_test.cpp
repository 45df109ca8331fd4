// SPDX-License-Identifier: Apache-2.0
#include "axiometry/volumetric/simulate/coverage.h"

#include <gtest/gtest.h>

#include <cmath>

#include "tests/support/statistics_of_trials.h"

namespace axiometry::volumetric {
namespace {

MachineModel machine_to_try() {
  MachineModel machine{.chain = *KinematicChain::make("XFYZ")};
  machine.travel = {{0, 0, -500}, {1000, 600, 0}};
  machine.tools = {{"short", {0, 0, -150}}, {"long", {0, 0, -300}}, {"beside", {120, 60, -180}}};
  machine.stations = {
      {"S1", {-150, -120, -700}}, {"S2", {1150, -100, -650}}, {"S3", {500, 720, -680}}, {"S4", {200, 300, -900}}};
  return machine;
}

/// Curves of a parabola each, which splines of 2 spans hold, so that nothing but noise is between stated and true.
TrueErrors parabolas(const TravelBox& travel) {
  TrueErrors errors;
  for (std::size_t a = 0; a < axis_count; ++a)
    for (std::size_t m = 0; m < motion_count; ++m) {
      const double low = travel.lowest_mm[a], high = travel.highest_mm[a], size = 2.0 + static_cast<double>(m);
      errors.curves[a][m] = *TrueCurve::make({{low, size}, {0.4 * high + 0.6 * low, -size}, {high, 0.5 * size}});
    }
  errors.squareness_urad = {5.0, -4.0, 3.0};
  return errors;
}

TEST(Coverage, IsThatOfANormalDistributionWhereTheCurvesHoldTheTruth) {
  const MachineModel machine = machine_to_try();
  CoverageOptions options{.trials = 60, .seed = 4, .errors = parabolas(machine.travel), .points = 30};
  options.identify = {.sizes = {2, 2, 2}, .drift = DriftModel::none, .find_breaks = false, .find_outliers = false};
  const auto coverage = try_coverage(machine, options);
  ASSERT_TRUE(coverage) << coverage.error().message;
  EXPECT_EQ(coverage->failed, 0u);
  for (Share CoverageTrial::*which : {&CoverageTrial::curves, &CoverageTrial::field}) {
    const CoverageStudy::Total total = coverage->total(which);
    EXPECT_NEAR(total.share.share(), 0.95, 3.5 * total.standard_error + 0.005);
    EXPECT_NEAR(total.share.rms(), 1.0, 0.06);
  }
  const double dof = static_cast<double>(coverage->trials.front().degrees_of_freedom) * 60.0;
  EXPECT_NEAR(coverage->chi_squared_per_dof(), 1.0, 4.0 * std::sqrt(2.0 / dof));
}

Share squareness_share(const CoverageStudy& study) {
  Share share;
  for (const CoverageTrial& trial : study.trials)
    for (std::size_t k = 18; k < trial.errors.size(); ++k) share.add(trial.errors[k]);
  return share;
}

/// Temperatures that differ by some 0.2 °C from station to station and tool to tool, on a machine of steel.
TEST(Coverage, HoldsWhereStationsAndToolsHaveTemperaturesOfTheirOwn) {
  AXIOMETRY_STATISTICS_OF_TRIALS();
  const MachineModel machine = machine_to_try();
  CoverageOptions options{.trials = 60, .seed = 9, .errors = parabolas(machine.travel), .points = 60};
  options.faults.part_scale_um_per_m = 2.0;
  options.identify = {.sizes = {2, 2, 2}, .drift = DriftModel::none, .find_breaks = false, .find_outliers = false};
  const auto held = try_coverage(machine, options);
  ASSERT_TRUE(held) << held.error().message;
  EXPECT_GE(squareness_share(*held).share(), 0.90);
  EXPECT_GE(held->total(&CoverageTrial::curves).share.share(), 0.90);
  options.identify.find_part_scales = false;
  const auto missed = try_coverage(machine, options);
  ASSERT_TRUE(missed);
  EXPECT_LE(squareness_share(*missed).share(), 0.75);
}

/// Slopes of EXX, EYY and EZZ are those of a mean temperature: of twelve parts, or of four stations alone.
TEST(Coverage, HoldsSlopesWhateverShareOfItsTemperatureAStationHasInCommon) {
  AXIOMETRY_STATISTICS_OF_TRIALS();
  const MachineModel machine = machine_to_try();
  for (const double share_of_station : {0.0, 1.0}) {
    CoverageOptions options{.trials = 100, .seed = 10, .errors = parabolas(machine.travel), .points = 60};
    options.faults.part_scale_um_per_m = 4.0;
    options.faults.share_of_station = share_of_station;
    options.identify = {.sizes = {2, 2, 2}, .drift = DriftModel::none, .find_breaks = false, .find_outliers = false};
    const auto held = try_coverage(machine, options);
    ASSERT_TRUE(held) << held.error().message;
    Share positioning;
    for (const CoverageTrial& trial : held->trials)
      for (const std::size_t error : {std::size_t{0}, std::size_t{7}, std::size_t{14}})
        positioning.add(trial.errors[error]);
    EXPECT_GE(positioning.share(), 0.90) << share_of_station;
  }
}

/// The same with halves of reversal of a constant and a slope.
TrueErrors parabolas_with_halves(const TravelBox& travel) {
  TrueErrors errors = parabolas(travel);
  for (std::size_t a = 0; a < axis_count; ++a)
    for (std::size_t m = 0; m < motion_count; ++m)
      errors.halves[a][m] = *TrueCurve::make({{travel.lowest_mm[a], 2.0}, {travel.highest_mm[a], 1.0}});
  return errors;
}

/// Values of one machine hang together where curves have two directions: of single machines 60 % to 100 % are inside.
TEST(Coverage, IsThatOfANormalDistributionWithReversalOverManyMachines) {
  AXIOMETRY_STATISTICS_OF_TRIALS();
  const MachineModel machine = machine_to_try();
  for (const Reversal reversal : {Reversal::constant, Reversal::curves}) {
    CoverageOptions options{.trials = 60, .seed = 4, .errors = parabolas_with_halves(machine.travel), .points = 60};
    if (reversal == Reversal::constant)
      for (auto& of_axis : options.errors->halves)
        for (TrueCurve& half : of_axis) half = *TrueCurve::make({{-1000.0, 1.5}, {1000.0, 1.5}});
    options.identify = {.sizes = {2, 2, 2},
                        .reversal = reversal,
                        .drift = DriftModel::none,
                        .find_breaks = false,
                        .find_outliers = false};
    const auto coverage = try_coverage(machine, options);
    ASSERT_TRUE(coverage) << coverage.error().message;
    EXPECT_EQ(coverage->failed, 0u);
    for (Share CoverageTrial::*which : {&CoverageTrial::curves, &CoverageTrial::directions, &CoverageTrial::field}) {
      const CoverageStudy::Total total = coverage->total(which);
      EXPECT_GT(total.share.count, 3000u);
      EXPECT_NEAR(total.share.share(), 0.95, 3.5 * total.standard_error + 0.005);
      EXPECT_NEAR(total.share.rms(), 1.0, 0.12);
    }
    const double dof = static_cast<double>(coverage->trials.front().degrees_of_freedom) * 60.0;
    EXPECT_NEAR(coverage->chi_squared_per_dof(), 1.0, 4.0 * std::sqrt(2.0 / dof));
  }
}

TEST(Coverage, IsToldByChiSquaredWhereReversalIsNotLookedFor) {
  const MachineModel machine = machine_to_try();
  CoverageOptions options{.trials = 4, .seed = 4, .errors = parabolas_with_halves(machine.travel), .points = 60};
  options.identify = {.sizes = {2, 2, 2}, .drift = DriftModel::none, .find_breaks = false, .find_outliers = false};
  const auto coverage = try_coverage(machine, options);
  ASSERT_TRUE(coverage);
  EXPECT_GT(coverage->chi_squared_per_dof(), 10.0);
}

TEST(Coverage, FallsWhereTheInstrumentIsWorseThanItsStatement) {
  MachineModel machine = machine_to_try();
  CoverageOptions options{.trials = 6, .seed = 4, .errors = parabolas(machine.travel), .points = 30};
  options.faults.outliers = 60;  // a sixth of the readings, with nobody looking for them
  options.identify = {.sizes = {2, 2, 2}, .drift = DriftModel::none, .find_breaks = false, .find_outliers = false};
  const auto coverage = try_coverage(machine, options);
  ASSERT_TRUE(coverage);
  EXPECT_GT(coverage->chi_squared_per_dof(), 100.0);
}

TEST(Coverage, IsTheSameForTheSameSeed) {
  const MachineModel machine = machine_to_try();
  const CoverageOptions options{.trials = 4, .seed = 9, .points = 40, .identify = {.sizes = {3, 3, 3}}};
  const auto first = try_coverage(machine, options), again = try_coverage(machine, options);
  ASSERT_TRUE(first && again);
  for (std::size_t k = 0; k < 4; ++k) {
    EXPECT_EQ(first->trials[k].chi_squared, again->trials[k].chi_squared);
    EXPECT_EQ(first->trials[k].curves.sum_squares, again->trials[k].curves.sum_squares);
  }
  EXPECT_NE(first->trials[0].chi_squared, first->trials[1].chi_squared);
}

TEST(Coverage, RefusesNoTrialsAndTellsWhyAllFailed) {
  EXPECT_FALSE(try_coverage(machine_to_try(), {.trials = 0}));
  const auto failed = try_coverage(machine_to_try(), {.trials = 2, .points = 1});
  ASSERT_FALSE(failed);
  EXPECT_NE(failed.error().message.find("expected"), std::string::npos);
}

}  // namespace
}  // namespace axiometry::volumetric
