// SPDX-License-Identifier: Apache-2.0
#include "axiometry/standards/readings/artefact.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "axiometry/standards/iso230_2/assessment/assessment.h"
#include "axiometry/standards/iso230_2/inputs/inputs.h"
#include "axiometry/standards/iso230_2/monte_carlo/monte_carlo.h"
#include "axiometry/standards/iso230_2/uncertainty/gum.h"
#include "axiometry/standards/readings/nde_correction.h"
#include "tests/support/series.h"

namespace axiometry::iso230_2 {
namespace {

using ::testing::Contains;
using ::testing::Field;
using ::testing::HasSubstr;
using ::testing::Not;
using testing_support::make_series;
using testing_support::RunDeviations;

const std::vector<double> nominal = {0, 50, 100, 150, 200, 250, 300, 350, 400, 450, 500};

/// The axis of the simulations: where the machine says q, the functional point is at q + error(q), µm.
double error_um(double q_mm, Direction direction) {
  return 0.02 * q_mm + 1.5 * std::sin(q_mm / 80.0) + (direction == Direction::down ? 2.5 : 0.0);
}

/// What the machine indicates when its functional point truly stands at x: q + error(q) = x.
double indicated_mm(double x_mm, Direction direction) {
  double q = x_mm;
  for (int k = 0; k < 20; ++k) q = x_mm - 1e-3 * error_um(q, direction);
  return q;
}

/// The artefact as it was calibrated, mm at 20 °C: off its nominal positions, and beginning anywhere.
std::vector<double> calibrated() {
  std::vector<double> positions;
  for (std::size_t i = 0; i < nominal.size(); ++i)
    positions.push_back(12.0 + nominal[i] + 0.004 * std::cos(static_cast<double>(i)));
  return positions;
}

/// Probing of the artefact, stretched by this strain; the machine's zero is at the first place.
axiometry::Test probed(double strain = 0.0, std::size_t runs = 2) {
  const auto places = calibrated();
  std::vector<RunDeviations> runs_of[2];
  const double datum = 0.0;
  for (Direction direction : {Direction::up, Direction::down})
    for (std::size_t j = 0; j < runs; ++j) {
      RunDeviations run;
      for (std::size_t i = 0; i < nominal.size(); ++i) {
        const double truly = datum + (places[i] - places[0]) * (1.0 + strain);
        run.push_back(1e3 * (indicated_mm(truly, direction) - nominal[i]));
      }
      runs_of[static_cast<std::size_t>(direction)].push_back(run);
    }
  axiometry::Test test{{}, make_series(nominal, runs_of[0], runs_of[1]), {}};
  test.metadata.artefact.calibrated_positions = places;
  return test;
}

axiometry::Test applied(axiometry::Test test) {
  auto result = apply_artefact(std::move(test));
  if (!result) throw std::logic_error(result.error().message);
  return *std::move(result);
}

TEST(Artefact, GivesTheDeviationThatAnInterferometerFindsInSignAndSize) {
  const axiometry::Test test = applied(probed());
  for (Direction direction : {Direction::up, Direction::down})
    for (std::size_t i = 0; i < nominal.size(); ++i) {
      const double truth = error_um(nominal[i], direction);
      // The deviation belongs to the indicated position, some µm off the target: 0.02 µm/mm of slope, 5 µm away.
      EXPECT_NEAR(test.series.cell(i, direction)[0], truth, 1e-3) << nominal[i];
    }
  const auto evaluation = evaluate(test.series);
  EXPECT_NEAR(evaluation.parameters.B_mean->in_native(), -2.5, 1e-3);  // x̄↑ − x̄↓, as everywhere
  double low = 1e9, high = -1e9;
  for (double p : nominal) {
    low = std::min(low, error_um(p, Direction::up));
    high = std::max(high, error_um(p, Direction::up));
  }
  EXPECT_NEAR(evaluation.parameters.E_up->in_native(), high - low, 2e-3);
}

TEST(Artefact, KeepsTheReadingsAndSaysWhatWasDone) {
  const axiometry::Test before = probed();
  const axiometry::Test after = applied(before);
  ASSERT_TRUE(after.as_measured);
  for (std::size_t i = 0; i < nominal.size(); ++i)
    EXPECT_EQ(after.as_measured->cell(i, Direction::up)[1], before.series.cell(i, Direction::up)[1]);
  ASSERT_EQ(after.provenance.corrections.size(), 1u);
  EXPECT_EQ(after.provenance.corrections[0].id, "artefact");
  EXPECT_TRUE(is_artefact_test(after));
  EXPECT_FALSE(is_artefact_test(before));
  EXPECT_FALSE(apply_artefact(after));
}

TEST(Artefact, LeavesMissingReadingsMissing) {
  axiometry::Test test = probed();
  std::vector<RunDeviations> up(1, RunDeviations(nominal.size(), 1.0)), down = up;
  up[0][3] = std::nan("");
  test.series = make_series(nominal, up, down);
  test = applied(std::move(test));
  EXPECT_EQ(test.series.count(3, Direction::up), 0u);
  EXPECT_EQ(test.series.reading_count(), 2 * nominal.size() - 1);
}

void set_temperature(axiometry::Test& test, double start, double end, double alpha = 11.5) {
  test.metadata.nde.equipment_expansion = ExpansionCoefficient::um_per_m_K(alpha);
  test.metadata.environment.sensors.push_back(
      {"equipment", "artefact", Temperature::celsius(start), Temperature::celsius(end)});
}

TEST(Artefact, IsAsLongAsItsTemperatureMakesIt) {
  axiometry::Test test = probed(11.5e-6 * 2.0);
  set_temperature(test, 22.0, 22.0);
  test = applied(std::move(test));
  for (std::size_t i = 0; i < nominal.size(); ++i)
    EXPECT_NEAR(test.series.cell(i, Direction::up)[0], error_um(nominal[i], Direction::up), 1e-3);
}

TEST(Artefact, FollowsItsTemperatureOverTheCourseOfTheTest) {
  axiometry::Test test = probed();
  set_temperature(test, 20.0, 22.0);
  const axiometry::Test after = applied(test);
  const double length_mm = calibrated().back() - calibrated().front();
  const auto added = [&](Direction direction, std::size_t run) {
    return after.series.cell(10, direction)[run] + test.series.cell(10, direction)[run] - 1e3 * (length_mm - 500.0);
  };
  // Reading 11 of 44 is the last one up in the first run, 34 − 1 that of the second run.
  EXPECT_NEAR(added(Direction::up, 0), 1e3 * length_mm * 11.5e-6 * 2.0 * 10.0 / 43.0, 1e-9);
  EXPECT_NEAR(added(Direction::up, 1), 1e3 * length_mm * 11.5e-6 * 2.0 * 32.0 / 43.0, 1e-9);
}

TEST(Artefact, IsNotExpandedTwice) {
  // A warm machine that holds a warm artefact of the same material: at 20 °C both are what they were.
  constexpr double strain = 11.5e-6 * 3.0;
  axiometry::Test test = probed();
  for (double& c : test.metadata.artefact.calibrated_positions) c = 12.0 + (c - 12.0);
  set_temperature(test, 23.0, 23.0);
  test.metadata.environment.sensors.push_back({"machine", "table", Temperature::celsius(23), Temperature::celsius(23)});
  test.metadata.nde.machine_expansion = ExpansionCoefficient::um_per_m_K(11.5);
  const axiometry::Test deviations = applied(test);
  const auto corrected = correct_expansion(deviations);
  ASSERT_TRUE(corrected);
  for (std::size_t i = 0; i < nominal.size(); ++i) {
    EXPECT_NEAR(corrected->series.cell(i, Direction::up)[0], error_um(nominal[i], Direction::up), 2e-3);
    EXPECT_NEAR(deviations.series.cell(i, Direction::up)[0],
                error_um(nominal[i], Direction::up) + 1e3 * strain * nominal[i], 2e-3);
  }
  EXPECT_FALSE(corrected->provenance.expansion_correction->equipment);
  EXPECT_EQ(corrected->as_measured->cell(4, Direction::up)[0], test.series.cell(4, Direction::up)[0]);
  // What the instrument corrected already is not done again.
  test.metadata.nde.applied = true;
  EXPECT_NEAR(applied(test).series.cell(10, Direction::up)[0], error_um(500, Direction::up), 1e-3);
}

TEST(Artefact, RefusesPositionsThatDoNotFit) {
  const auto message = [](axiometry::Test test) {
    const auto result = apply_artefact(std::move(test));
    return result ? std::string() : result.error().message;
  };
  axiometry::Test test = probed();
  auto& places = test.metadata.artefact.calibrated_positions;
  places.pop_back();
  EXPECT_THAT(message(test), HasSubstr("found 10 calibrated positions of the artefact for 11 targets"));
  places = calibrated();
  std::swap(places[3], places[4]);
  EXPECT_THAT(message(test), HasSubstr("position 5 at"));
  places = calibrated();
  places[4] += 5.1;
  EXPECT_THAT(message(test), HasSubstr("expected them within 5 mm of each other"));
  places[4] -= 0.2;
  EXPECT_EQ(message(test), "");
  places.clear();
  EXPECT_THAT(message(test), HasSubstr("expected artefact.calibrated_positions"));
  axiometry::Test rotary = probed();
  rotary.metadata.axis.kind = AxisKind::rotary;
  EXPECT_THAT(message(rotary), HasSubstr("rotary"));
  axiometry::Test no_alpha = probed();
  set_temperature(no_alpha, 21, 21);
  no_alpha.metadata.nde.equipment_expansion.reset();
  EXPECT_THAT(message(no_alpha), HasSubstr("no expansion coefficient"));
}

TEST(ArtefactFindings, NameTemperatureSpanAndSteps) {
  axiometry::Test test = probed();
  test.metadata.axis.travel_begin = Position::native(-10);
  test.metadata.axis.travel_end = Position::native(990);
  test.metadata.axis.expected_period = Position::native(10);
  const auto findings = assess(applied(test)).findings;
  EXPECT_THAT(findings, Contains(Field(&Finding::message, HasSubstr("no temperature of the artefact"))));
  EXPECT_THAT(findings, Contains(Field(&Finding::message, HasSubstr("spans 500 mm of an axis travel of 1000 mm"))));
  EXPECT_THAT(findings, Contains(Field(&Finding::message, HasSubstr("hold 5 whole periods of 10 mm"))));
  for (const char* id : {"artefact-temperature", "artefact-shorter-than-axis", "artefact-equal-steps"})
    EXPECT_THAT(findings, Contains(Field(&Finding::id, id)));
  EXPECT_THAT(findings, Not(Contains(Field(&Finding::message, HasSubstr("expected a random shift")))));
  EXPECT_TRUE(std::ranges::is_sorted(findings, {}, &Finding::severity));
  test.metadata.axis.expected_period = Position::native(12.3);
  EXPECT_THAT(assess(applied(test)).findings, Not(Contains(Field(&Finding::message, HasSubstr("whole period")))));
}

TEST(ArtefactFindings, SayWhenCalibratedPositionsWereNotUsed) {
  EXPECT_THAT(assess(probed()).findings, Contains(Field(&Finding::message, HasSubstr("were not used"))));
}

axiometry::Test with_uncertainty() {
  axiometry::Test test = applied(probed(0.0, 5));
  Artefact& artefact = test.metadata.artefact;
  artefact.calibration_uncertainty = Deviation::native(0.8);
  artefact.calibration_uncertainty_per_length = RelativeLength::um_per_m(2.0);
  artefact.probing_uncertainty = Deviation::native(0.6);
  return test;
}

TEST(ArtefactUncertainty, TakesTheDevicesPlaceInAnnexA) {
  axiometry::Test test = with_uncertainty();
  test.metadata.uncertainty.device_calibration_per_length = RelativeLength::um_per_m(77.0);
  const auto evaluation = evaluate(test.series);
  const auto annex = annex_a(test.metadata, test.series, evaluation);
  ASSERT_TRUE(annex);
  const Contributor& device = annex->budget.front();
  EXPECT_EQ(device.title, "Calibration of the artefact");
  EXPECT_NEAR(device.U->in_native(), 0.8 + 2.0 * 0.5, 1e-12) << "a + b·L unless the certificate says otherwise";
  const Contributor& probing = annex->budget.back();
  EXPECT_EQ(probing.key, "probing");
  EXPECT_NEAR(annex->U.E->in_native(), std::sqrt(1.8 * 1.8 + 0.36), 1e-12);
  EXPECT_NEAR(annex->U.B->in_native(), std::sqrt(2.0) * 0.6, 1e-12);
  EXPECT_FALSE(annex->U.R);  // nothing known acts on it
  EXPECT_THAT(annex->notes, Contains(HasSubstr("takes the place of the measuring device")));
}

TEST(ArtefactUncertainty, ReachesTheGumAndMonteCarloThroughTheOneList) {
  axiometry::Test test = with_uncertainty();
  test.metadata.artefact.calibration_sum = CalibrationSum::quadratic;
  const auto inputs = uncertainty_inputs(test.metadata, test.series);
  ASSERT_TRUE(inputs);
  const auto input = [&](std::string_view key) {
    const auto found = std::ranges::find(inputs->inputs, key, &UncertaintyInput::key);
    if (found == inputs->inputs.end()) throw std::logic_error("no such input");
    return *found;
  };
  EXPECT_EQ(input("artefact_calibration").effect, Effect::target);
  EXPECT_NEAR(*input("artefact_calibration").distribution.standard_deviation(), 0.4, 1e-12);
  EXPECT_EQ(input("artefact_calibration_length").effect, Effect::scale);
  EXPECT_NEAR(*input("artefact_calibration_length").distribution.standard_deviation(), 1.0, 1e-12);
  EXPECT_EQ(input("probing").effect, Effect::target_direction);

  const auto evaluation = evaluate(test.series);
  const auto by_gum = gum(test, evaluation);
  ASSERT_TRUE(by_gum && *by_gum);
  // M lies between the ends of the travel: scale 1 µm/m over 0.5 m, calibration of two places, probing averaged over
  // both sides.
  const double expected = std::sqrt(0.25 + 2.0 * 0.16 + 2.0 * 0.09 / 2.0);
  EXPECT_NEAR((*by_gum)->find("M")->uncertainty.u.in_native(), expected, 0.02);
  const auto by_trials = monte_carlo(test, evaluation, {});
  ASSERT_TRUE(by_trials && *by_trials);
}

TEST(ArtefactUncertainty, NamesTheArtefactsExpansion) {
  axiometry::Test test = with_uncertainty();
  set_temperature(test, 21.0, 22.0);
  test.metadata.uncertainty.misalignment = Length::mm(1);
  const auto inputs = uncertainty_inputs(test.metadata, test.series);
  ASSERT_TRUE(inputs);
  std::vector<std::string> titles;
  for (const auto& i : inputs->inputs) titles.push_back(i.title);
  EXPECT_THAT(titles, Contains("Temperature of the artefact, less 20 °C"));
  EXPECT_THAT(titles, Contains("Expansion coefficient of the artefact"));
  EXPECT_THAT(titles, Contains("Misalignment of the artefact"));
  const auto annex = annex_a(test.metadata, test.series, evaluate(test.series));
  const auto row = std::ranges::find(annex->budget, std::string_view("e_device"), &Contributor::key);
  EXPECT_EQ(row->title, "Expansion coefficient of the artefact");
  EXPECT_NEAR(row->U->in_native(), 0.6 * 2.0 * 0.5 * 2.0, 1e-9);
}

TEST(ArtefactUncertainty, IsAbsentWithoutAnArtefact) {
  axiometry::Test test{{}, testing_support::table2::series(), {}};
  test.metadata.uncertainty.device_calibration = Deviation::native(1.0);
  const auto annex = annex_a(test.metadata, test.series, evaluate(test.series));
  EXPECT_EQ(annex->budget.size(), 7u);
  EXPECT_EQ(annex->budget.front().title, "Measuring device");
}

/// Calibrated less indicated positions are decimals as both of them are: no binary rounding lifts E over its limit.
TEST(Artefact, GivesDeviationsAsTheDecimalsOfBothPositions) {
  axiometry::Test test{
      {}, make_series({0, 50, 100, 150, 200}, {{-4.8, -4.4, -2.1, 3.4, -3.2}}, {{-0.1, -4.2, -0.8, 2.8, -1.9}}), {}};
  test.metadata.artefact.type = "ball array";
  test.metadata.artefact.calibrated_positions = {-0.0026, 49.9978, 100.0009, 150.0009, 199.9998};
  const axiometry::Test made = apply_artefact(test).value();
  EXPECT_NEAR(made.series.cell(0, Direction::up)[0], 4.8, 1e-15);
  EXPECT_NEAR(made.series.cell(3, Direction::up)[0], 0.1, 1e-15);
  EXPECT_NEAR(made.series.cell(4, Direction::down)[0], 4.3, 2e-15);
}

}  // namespace
}  // namespace axiometry::iso230_2
