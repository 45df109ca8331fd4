// SPDX-License-Identifier: Apache-2.0
//
// The station of a tracking interferometer in each of the three uncertainties and in the findings.
// tests/station_offset_oracle.py holds the program against draws of its own.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "axiometry/standards/iso230_2/assessment/assessment.h"
#include "axiometry/standards/readings/station_offset.h"
#include "tests/support/series.h"

namespace axiometry::iso230_2 {
namespace {

using testing::Contains;
using testing::HasSubstr;
using testing::Not;

constexpr double near_mm = 100.0, far_mm = 1000.0;

/// Means of 0, 5 and 10 µm, on either side of which 2 µm of reversal lie alike at all targets.
Series rising() {
  return testing_support::make_series({near_mm, 400, far_mm}, {{0.9, 5.9, 10.9}, {1.1, 6.1, 11.1}},
                                      {{-1.1, 3.9, 8.9}, {-0.9, 4.1, 9.1}});
}

Metadata beside(double larger_mm, double smaller_mm) {
  Metadata metadata;
  metadata.tracking.station_position = Position::native(0);
  metadata.tracking.station_uncertainty_mm = {larger_mm, smaller_mm};
  return metadata;
}

/// What Δ⊥² makes of the length at the nearest target against the farthest, µm.
double difference_um(double square_mm2) {
  return 1000.0 * ((std::hypot(near_mm, std::sqrt(square_mm2)) - near_mm) -
                   (std::hypot(far_mm, std::sqrt(square_mm2)) - far_mm));
}

std::string messages(const Assessment& assessment, Severity severity) {
  std::string all;
  for (const Finding& finding : assessment.findings)
    if (finding.severity == severity) all += finding.clause + " " + finding.message + "\n";
  return all;
}

TEST(Station, IsAContributorToRangesOverTargetsInAnnexA) {
  const Series series = rising();
  const AnnexA annex = annex_a(beside(0.8, 0.0), series, evaluate(series)).value();
  ASSERT_EQ(annex.budget.size(), 8u);
  const Contributor& row = annex.budget.back();
  EXPECT_EQ(row.key, "station");
  // 95 % of z² lie below 3.8415.
  EXPECT_NEAR(row.U->in_native(), difference_um(0.64 * 3.841458820694124), 1e-8);
  for (auto member :
       {&AxisParameters::E, &AxisParameters::E_up, &AxisParameters::M, &AxisParameters::A, &AxisParameters::A_down})
    EXPECT_NEAR((annex.U.*member)->in_native(), row.U->in_native(), 1e-12);
  EXPECT_FALSE(annex.U.R);
  EXPECT_FALSE(annex.U.B);
  EXPECT_THAT(annex.notes, Contains(HasSubstr("U_STATION is not in Annex A")));
}

TEST(Station, AddsInQuadratureAndLeavesTheMisalignmentOut) {
  const Series series = rising();
  Metadata metadata = beside(0.8, 0.3);
  metadata.uncertainty.device_calibration = Deviation::native(1.5);
  metadata.uncertainty.misalignment = Length::mm(4);
  const AnnexA annex = annex_a(metadata, series, evaluate(series)).value();
  const double station = annex.budget.back().U->in_native();
  EXPECT_NEAR(annex.U.E->in_native(), std::hypot(1.5, station), 1e-12);
  EXPECT_FALSE(annex.budget[1].U);
  EXPECT_THAT(annex.notes, Contains(std::string(followed_beam_note)));
  EXPECT_THAT(annex.notes, Not(Contains(HasSubstr("no misalignment was given"))));
}

TEST(Station, ChangesNothingWhereItIsNotGiven) {
  const Series series = rising();
  Metadata metadata;
  metadata.uncertainty.device_calibration = Deviation::native(1.5);
  const AnnexA annex = annex_a(metadata, series, evaluate(series)).value();
  EXPECT_EQ(annex.budget.size(), 7u);
  metadata.tracking.station_position = Position::native(0);
  const AnnexA half = annex_a(metadata, series, evaluate(series)).value();
  EXPECT_EQ(half.U.E, annex.U.E);
  EXPECT_EQ(half.budget.size(), 7u);
}

/// E is 10 µm + Δd: the mean of (u1 z1)² + (u2 z2)² is u1² + u2², its standard deviation √2 √(u1⁴ + u2⁴).
TEST(Station, HasItsSquareAsAnInputOfTheLawOfPropagation) {
  const Series series = rising();
  const Metadata metadata = beside(0.8, 0.5);
  const GumUncertainty result = gum(axiometry::Test{metadata, series, {}}, evaluate(series)).value().value();
  const double mean = 0.64 + 0.25;
  const double slope =
      1000.0 * (0.5 / std::hypot(near_mm, std::sqrt(mean)) - 0.5 / std::hypot(far_mm, std::sqrt(mean)));
  ASSERT_EQ(result.sources.size(), 3u);
  EXPECT_EQ(result.sources[2].key, "station_mean");
  const GumParameter& E = *result.find("E");
  EXPECT_NEAR(E.contributions[0].in_native(), slope * std::sqrt(2.0) * 0.64, 1e-9);
  EXPECT_NEAR(E.contributions[1].in_native(), slope * std::sqrt(2.0) * 0.25, 1e-9);
  EXPECT_NEAR(E.contributions[2].in_native(), difference_um(mean), 1e-9);
  EXPECT_NEAR(
      E.uncertainty.u.in_native(),
      std::hypot(E.contributions[0].in_native(), E.contributions[1].in_native(), E.contributions[2].in_native()),
      1e-12);
  for (std::string_view key : {"R", "R_up", "B", "B_mean"}) EXPECT_EQ(result.find(key), nullptr) << key;
  EXPECT_NEAR(result.positions[0].up->instrument.in_native(), E.uncertainty.u.in_native(), 1e-12);
  EXPECT_EQ(result.positions[2].up->total.u.in_native(), 0.0);
}

TEST(Station, IsDrawnExactlyByTheMonteCarloMethod) {
  const Series series = rising();
  MonteCarloOptions options;
  options.propagation.trials = 200'000;
  const auto result =
      monte_carlo(axiometry::Test{beside(0.8, 0.0), series, {}}, evaluate(series), options).value().value();
  const auto& E = result.distributions[3].value();
  // Quantiles of z² at 2.5 % and 97.5 %.
  EXPECT_NEAR(E.summary.symmetric.lower, 12.0 + difference_um(0.64 * 0.000982069117175), 1e-3);
  EXPECT_NEAR(E.summary.symmetric.upper, 12.0 + difference_um(0.64 * 5.023886187314888), 0.2);
  EXPECT_NEAR(E.summary.mean, 12.0 + difference_um(0.64), 0.03);
  EXPECT_LT(E.bias(), 0.0) << "the station has made E smaller than it is";
  EXPECT_FALSE(result.distributions[7]) << "R";
  EXPECT_FALSE(result.distributions[10]) << "B";
}

TEST(Station, ContributesEachOfItsDirectionsForItself) {
  const Series series = rising();
  Metadata metadata = beside(0.8, 0.4);
  metadata.gum.distributions = {{"scale:laser", "normal 0 2"}};
  MonteCarloOptions options;
  options.propagation.trials = 20'000;
  options.contribution_trials = 20'000;
  const auto result = monte_carlo(axiometry::Test{metadata, series, {}}, evaluate(series), options).value().value();
  ASSERT_EQ(result.contributions.size(), 3u);
  const auto exact = [](double u) { return 1000.0 * (0.5 / near_mm - 0.5 / far_mm) * std::sqrt(2.0) * u * u; };
  EXPECT_NEAR(result.contributions[0].u[3], exact(0.8), 0.05 * exact(0.8));
  EXPECT_NEAR(result.contributions[1].u[3], exact(0.4), 0.05 * exact(0.4));
  EXPECT_NEAR(result.contributions[2].u[3], 2.0 * 0.9, 0.05);
}

TEST(Station, TakesOtherDistributionsByName) {
  const Series series = rising();
  Metadata metadata = beside(0.8, 0.4);
  metadata.gum.distributions = {{"station", "uniform -1 1"}};
  const UncertaintyInputs inputs = uncertainty_inputs(metadata, series).value();
  ASSERT_EQ(inputs.inputs.size(), 2u);
  EXPECT_EQ(inputs.inputs[0].distribution.text(), "uniform -1 1");
  EXPECT_EQ(inputs.station->in_native(), 0.0);
  const auto message = [&](std::string distribution, bool placed) {
    Metadata m;
    if (placed) m.tracking.station_position = Position::native(0);
    m.gum.distributions = {{"station", std::move(distribution)}};
    const auto failed = uncertainty_inputs(m, series);
    return failed ? "" : failed.error().message;
  };
  EXPECT_EQ(message("normal 0 1", true), "");
  EXPECT_THAT(message("normal 0 1", false), HasSubstr("without tracking.station_position"));
  EXPECT_THAT(message("t 4 0 1", true), HasSubstr("whose square has no standard deviation"));
  EXPECT_THAT(message("normal 0 1e7", true), HasSubstr("expected at most 1e+06"));
}

TEST(Station, StandsInPlaceOfTheMisalignmentInTheFindings) {
  Metadata metadata = beside(0.8, 0.4);
  metadata.uncertainty.device_calibration = Deviation::native(1);
  const auto missing = [&] { return messages(assess({metadata, rising(), {}}), Severity::missing); };
  EXPECT_THAT(missing(), Not(HasSubstr("misalignment")));
  metadata.tracking.station_uncertainty_mm = {0.1};
  EXPECT_THAT(missing(), HasSubstr("misalignment (A.4)"));
  EXPECT_THAT(missing(), HasSubstr("8.2.1 the station of the tracking interferometer is left out of the uncertainty"));
}

TEST(Findings, SayOnceThatADiagonalIsNoTestOfAnAxis) {
  Metadata metadata;
  set_spatial_line(metadata.axis, {{0, 0, 0}, unit({1, 1, 1})});
  const std::vector<double> line = {0.0, 5.0, 10.0, 15.0};
  const Series series = testing_support::make_series({100, 400, 700, 1000}, {line}, {line});
  const Assessment diagonal = assess({metadata, series, {}});
  EXPECT_THAT(messages(diagonal, Severity::note), HasSubstr("230-6 found a line along which 3 axes move"));
  EXPECT_THAT(messages(diagonal, Severity::note), HasSubstr("a squareness error or a correction"));
  set_spatial_line(metadata.axis, {{0, 0, 0}, {0, 1, 0}});
  EXPECT_THAT(messages(assess({metadata, rising(), {}}), Severity::note), Not(HasSubstr("230-6")));
  metadata.axis.line_direction = {0, 0, 0};
  EXPECT_THAT(messages(assess({metadata, rising(), {}}), Severity::missing), HasSubstr("make no line in space"));
}

}  // namespace
}  // namespace axiometry::iso230_2
