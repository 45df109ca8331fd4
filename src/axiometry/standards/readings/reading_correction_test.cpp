// SPDX-License-Identifier: Apache-2.0
#include "axiometry/standards/readings/reading_correction.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "axiometry/standards/iso230_2/assessment/assessment.h"
#include "axiometry/standards/readings/drift.h"
#include "axiometry/standards/readings/nde_correction.h"
#include "tests/support/series.h"

namespace axiometry {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using Measured = axiometry::Test;  // within a TEST, Test is the fixture

using testing_support::exact_um;
using testing_support::none;
using testing_support::x;

/// A laser that assumed n = 1.0002714, in air that becomes warmer, thinner and drier. Readings in the order of the
/// standard cycle: shares 0, 1/3, 2/3 and 1 of the test.
Measured in_air() {
  Measured test{{}, testing_support::make_series({0, 1000}, {{0.5, 4}}, {{-0.5, 5}}), {}};
  Environment& e = test.metadata.environment;
  e.air_temperature_start = Temperature::celsius(20);
  e.air_temperature_end = Temperature::celsius(23);
  e.air_pressure_start = Pressure::kPa(101);
  e.air_pressure_end = Pressure::kPa(100.4);
  e.air_humidity_start = RelativeHumidity::percent(50);
  e.air_humidity_end = RelativeHumidity::percent(40);
  InstrumentSettings& i = test.metadata.instrument;
  i.refractive_index = 1.0002714;
  i.dead_path = Length::mm(250);
  i.air_co2_ppm = 420;
  return test;
}

Measured table2() { return {{}, testing_support::table2::series(), {}}; }

std::string refusal_of(const Measured& test, const CorrectionRequest& request) {
  const auto result = correct_readings(test, request);
  return result ? "nothing" : result.error().message;
}

std::vector<std::string> ids(const Measured& test) {
  std::vector<std::string> all;
  for (const AppliedCorrection& correction : test.provenance.corrections) all.push_back(correction.id);
  return all;
}

std::string detail(const AppliedCorrection& correction, std::string_view name) {
  for (const auto& d : correction.details)
    if (d.name == name) return d.value;
  return "none";
}

void expect_same(const Series& a, const Series& b, double within) {
  for (Direction d : {Direction::up, Direction::down})
    for (std::size_t i = 0; i < a.target_count(); ++i)
      for (std::size_t j = 0; j < a.run_count(); ++j)
        EXPECT_NEAR(x(a, i, d, j), x(b, i, d, j), within) << i << arrow(d) << j;
}

TEST(ReadingCorrection, DoesNothingUnasked) {
  const Measured test = correct_readings(in_air(), {}).value();
  EXPECT_FALSE(test.as_measured);
  EXPECT_TRUE(test.provenance.corrections.empty());
  expect_same(test.series, in_air().series, 0);
}

TEST(ReadingCorrection, KeepsTheReadingsAsTheyWereMeasuredThroughAllCorrections) {
  Measured before = in_air();
  before.metadata.instrument.gain = 1.00001;
  before.metadata.axis.scale_expansion = ExpansionCoefficient::um_per_m_K(10);
  before.metadata.environment.sensors = {{"machine", "", Temperature::celsius(21), Temperature::celsius(22)}};
  before.series = testing_support::make_series({0, 1000}, {{0.5, 4}, {0.6, none}}, {{-0.5, 5}, {-0.4, 5}});
  const CorrectionRequest all{
      .sign = true, .gain = true, .air = AirEquation::edlen, .dead_path = true, .expansion = true, .drift = true};
  const Measured after = correct_readings(before, all).value();
  EXPECT_THAT(ids(after), ElementsAre("sign", "gain", "air", "dead-path", "nde", "drift"));
  EXPECT_TRUE(after.provenance.expansion_correction);
  EXPECT_FALSE(after.series.reading(1, Direction::up, 1)) << "missing stays missing";
  for (Direction d : {Direction::up, Direction::down})
    for (std::size_t i = 0; i < 2; ++i) EXPECT_EQ(x(*after.as_measured, i, d, 0), x(before.series, i, d, 0));
}

TEST(SignCorrection, ReversesTheDeviationsWhereTheAxisWentTheRightWay) {
  const Measured after = correct_readings(table2(), {.sign = true}).value();
  EXPECT_EQ(x(after.series, 3, Direction::down, 2), -2.4);
  EXPECT_EQ(after.provenance.corrections[0].largest.in_native(), 2 * 5.1);
  EXPECT_THAT(detail(after.provenance.corrections[0], "What was reversed"), HasSubstr("the deviations"));
}

TEST(SignCorrection, ReversesTheDisplayedPositionsOfASensorThatCountsTheOtherWay) {
  Measured test{{}, testing_support::make_series({100, 300}, {{0, -400'000 - 3}}, {{1, -400'000 - 2}}), {}};
  // Shown: 100 and 300 − 400.003 = −100.003 mm; the axis was at 300.003 mm.
  test = correct_readings(test, {.sign = true}).value();
  EXPECT_NEAR(x(test.series, 0, Direction::up, 0), 0, exact_um);
  EXPECT_NEAR(x(test.series, 1, Direction::up, 0), 3, exact_um);
  EXPECT_NEAR(x(test.series, 0, Direction::down, 0), -1, exact_um);
  EXPECT_THAT(detail(test.provenance.corrections[0], "What was reversed"), HasSubstr("displayed positions"));
}

TEST(SignCorrection, MirrorsAtTheDatumOfARotaryAxis) {
  Measured test{{}, testing_support::make_series({0, 90}, {{-360.0 * 3600, -540.0 * 3600 - 5}}, {}), {}};
  test.metadata.axis.kind = AxisKind::rotary;
  test.metadata.nde.datum = Position::native(-180);
  test = correct_readings(test, {.sign = true}).value();
  EXPECT_NEAR(x(test.series, 0, Direction::up, 0), 0, 1e-6);
  EXPECT_NEAR(x(test.series, 1, Direction::up, 0), 5, 1e-6);
}

TEST(SignCorrection, TwiceIsIdentity) {
  const Measured once = correct_readings(table2(), {.sign = true}).value();
  expect_same(correct_readings(once, {.sign = true})->series, table2().series, 0);
}

TEST(SignCorrection, IsRefusedWhereNothingIsReversed) {
  Measured test = table2();
  test.metadata.instrument.sign_reversed = false;
  EXPECT_THAT(refusal_of(test, {.sign = true}), HasSubstr("instrument.sign_reversed = no"));
  test = {{}, testing_support::make_series({0, 100}, {{0, -100'000}}, {}), {}};
  EXPECT_THAT(refusal_of(test, {.sign = true}), HasSubstr("neither rise nor fall"));
}

TEST(GainCorrection, StretchesTheDisplayedLengthFromTheDatum) {
  Measured test{{}, testing_support::make_series({100, 300}, {{2, -8}}, {}), {}};
  test.metadata.instrument.gain = 1.00005;
  const Measured after = correct_readings(test, {.gain = true}).value();
  EXPECT_NEAR(x(after.series, 0, Direction::up, 0), 2 * 1.00005, exact_um);
  EXPECT_NEAR(x(after.series, 1, Direction::up, 0), (200'000 - 8) * 1.00005 - 200'000, exact_um);
}

TEST(GainCorrection, ByAGainAndItsInverseIsIdentity) {
  Measured test = table2();
  test.metadata.instrument.gain = 1.25;
  test = correct_readings(test, {.gain = true}).value();
  test.metadata.instrument.gain = 0.8;
  expect_same(correct_readings(test, {.gain = true})->series, table2().series, 1e-8);
}

TEST(GainCorrection, IsRefusedWithoutAGain) {
  Measured test = table2();
  EXPECT_THAT(refusal_of(test, {.gain = true}), HasSubstr("expected instrument.gain"));
  test.metadata.instrument.gain = 0;
  EXPECT_THAT(refusal_of(test, {.gain = true}), HasSubstr("other than 0"));
}

// Golden: both equations and the formulas written once more in Python.
TEST(AirCorrection, BringsEveryReadingToTheWavelengthOfItsTime) {
  const Series by_ciddor = correct_readings(in_air(), {.air = AirEquation::ciddor})->series;
  EXPECT_NEAR(x(by_ciddor, 0, Direction::up, 0) - 0.5, 0.000000452, exact_um);
  EXPECT_NEAR(x(by_ciddor, 1, Direction::up, 0) - 4, 2.356993828, exact_um);
  EXPECT_NEAR(x(by_ciddor, 1, Direction::down, 0) - 5, 3.798472742, exact_um);
  EXPECT_NEAR(x(by_ciddor, 0, Direction::down, 0) - -0.5, -0.000002614, exact_um);
  const Series by_edlen = correct_readings(in_air(), {.air = AirEquation::edlen})->series;
  EXPECT_NEAR(x(by_edlen, 0, Direction::up, 0) - 0.5, 0.000000451, exact_um);
  EXPECT_NEAR(x(by_edlen, 1, Direction::up, 0) - 4, 2.355374850, exact_um);
  EXPECT_NEAR(x(by_edlen, 1, Direction::down, 0) - 5, 3.796870297, exact_um);
  EXPECT_NEAR(x(by_edlen, 0, Direction::down, 0) - -0.5, -0.000002613, exact_um);
}

TEST(AirCorrection, IsNoneWhereTheInstrumentAssumedTheIndexThatWas) {
  Measured test = in_air();
  test.metadata.environment.air_temperature_end.reset();
  test.metadata.environment.air_pressure_end.reset();
  test.metadata.environment.air_humidity_end.reset();
  test.metadata.instrument.refractive_index =
      1.0 + air_refractivity(AirEquation::ciddor,
                             {Temperature::celsius(20), Pressure::kPa(101), RelativeHumidity::percent(50), 420},
                             Length::nm(632.9909))
                .value();
  const Measured after = correct_readings(test, {.air = AirEquation::ciddor}).value();
  expect_same(after.series, test.series, 1e-9);
  EXPECT_THAT(detail(after.provenance.corrections[0], "Air temperature"),
              HasSubstr("read at the start only and taken as constant"));
}

TEST(AirCorrection, TakesTheTimesOfTheReadings) {
  Measured test = in_air();
  test.times_s = {0, 10, 100, 90};  // dense: ↑ at both targets, then ↓ at the first and at the second
  const Series timed = correct_readings(test, {.air = AirEquation::ciddor})->series;
  const Series even = correct_readings(in_air(), {.air = AirEquation::ciddor})->series;
  EXPECT_NEAR(x(timed, 0, Direction::up, 0), x(even, 0, Direction::up, 0), exact_um);
  EXPECT_LT(x(timed, 1, Direction::up, 0), x(even, 1, Direction::up, 0)) << "less warm at 0.1 than at 1/3";
  EXPECT_GT(x(timed, 1, Direction::down, 0), x(even, 1, Direction::down, 0)) << "warmer at 0.9 than at 2/3";
}

TEST(AirCorrection, TakesTheAirFromSensorsAndStatesWhatItAssumed) {
  Measured test = in_air();
  test.metadata.environment.air_temperature_start.reset();
  test.metadata.environment.air_temperature_end.reset();
  test.metadata.environment.sensors = {{"air", "", Temperature::celsius(19), {}},
                                       {"Air", "", Temperature::celsius(21), Temperature::celsius(27)}};
  test.metadata.instrument.air_co2_ppm.reset();
  const auto record = correct_readings(test, {.air = AirEquation::ciddor})->provenance.corrections.at(0);
  EXPECT_EQ(detail(record, "Air temperature"), "20 °C at the start, 23 °C at the end");
  EXPECT_EQ(detail(record, "Carbon dioxide"), "450 ppm, assumed");
  EXPECT_EQ(detail(record, "Vacuum wavelength"), "632.9909 nm, assumed");
  EXPECT_EQ(detail(record, "Index assumed by the instrument"), "1.0002714");
  EXPECT_THAT(detail(record, "Course of the test"), HasSubstr("standard cycle"));
}

TEST(AirCorrection, NamesEverythingThatIsMissing) {
  EXPECT_EQ(refusal_of(table2(), {.air = AirEquation::ciddor}),
            "found too little for the correction air, expected also instrument.refractive_index (1 when lengths in "
            "vacuum are shown), environment.air_temperature_start_C, environment.air_pressure_start_kPa, "
            "environment.air_humidity_start_percent");
  Measured test = in_air();
  test.metadata.instrument.dead_path.reset();
  EXPECT_EQ(refusal_of(test, {.dead_path = true}),
            "found too little for the correction dead-path, expected also instrument.dead_path_mm");
}

TEST(AirCorrection, IsRefusedWhereItMakesNoSense) {
  Measured test = in_air();
  test.metadata.axis.kind = AxisKind::rotary;
  EXPECT_THAT(refusal_of(test, {.air = AirEquation::ciddor}), HasSubstr("rotary"));
  EXPECT_THAT(refusal_of(test, {.dead_path = true}), HasSubstr("rotary"));
  test = in_air();
  test.metadata.environment.air_pressure_end = Pressure::kPa(1004);
  EXPECT_THAT(refusal_of(test, {.air = AirEquation::ciddor}), HasSubstr("is it hPa? (air at the end of the test)"));
  const Measured once = correct_readings(in_air(), {.air = AirEquation::ciddor}).value();
  EXPECT_THAT(refusal_of(once, {.air = AirEquation::edlen}), HasSubstr("already corrected (air)"));
}

TEST(DeadPathCorrection, TakesOutWhatTheAirDidToThePathBeforeTheDatum) {
  const Series by_ciddor = correct_readings(in_air(), {.dead_path = true})->series;
  EXPECT_NEAR(x(by_ciddor, 0, Direction::up, 0) - 0.5, 0.0, exact_um);
  EXPECT_NEAR(x(by_ciddor, 1, Direction::up, 0) - 4, 0.363418435, exact_um);
  EXPECT_NEAR(x(by_ciddor, 1, Direction::down, 0) - 5, 0.723785447, exact_um);
  EXPECT_NEAR(x(by_ciddor, 0, Direction::down, 0) - -0.5, 1.081071099, exact_um);
}

TEST(DeadPathCorrection, ChangesSignWithTheSideOfTheInterferometer) {
  Measured test = in_air();
  const Series beyond = correct_readings(test, {.dead_path = true})->series;
  test.metadata.instrument.dead_path = Length::mm(-250);
  const Series before = correct_readings(test, {.dead_path = true})->series;
  EXPECT_NEAR(x(beyond, 1, Direction::down, 0) - 5, -(x(before, 1, Direction::down, 0) - 5), exact_um);
  EXPECT_NEAR(x(beyond, 0, Direction::up, 0), 0.5, exact_um) << "nothing has changed at the start";
}

// A perfect axis seen by an interferometer that shows N λ/(2 n₀) of N fringes: L_d in air n_s at zero, then n(t).
TEST(DeadPathCorrection, AndAirMakeAPerfectAxisPerfectAgain) {
  Measured test = in_air();
  const auto index = [&](double share) {
    return 1.0 + air_refractivity(AirEquation::edlen,
                                  {Temperature::celsius(20 + 3 * share), Pressure::kPa(101 - 0.6 * share),
                                   RelativeHumidity::percent(50 - 10 * share), 420},
                                  Length::nm(632.9909))
                     .value();
  };
  const auto shown = [&](double target_mm, double share) {
    const double optical_um = index(share) * (250e3 + 1e3 * target_mm) - index(0) * 250e3;
    return optical_um / 1.0002714 - 1e3 * target_mm;
  };
  test.series = testing_support::make_series({0, 1000}, {{shown(0, 0), shown(1000, 1.0 / 3)}},
                                             {{shown(0, 1), shown(1000, 2.0 / 3)}});
  const Measured after = correct_readings(test, {.air = AirEquation::edlen, .dead_path = true}).value();
  expect_same(after.series, testing_support::make_series({0, 1000}, {{0, 0}}, {{0, 0}}), 1e-9);
}

TEST(DriftCorrection, TakesOutTheLineThatWasFound) {
  const Drift found = drift_of(table2()).value();
  const Measured after = correct_readings(table2(), {.drift = true}).value();
  EXPECT_NEAR(drift_of(after)->over_test.in_native(), 0.0, 1e-12);
  EXPECT_EQ(x(after.series, 0, Direction::up, 0), -1.2) << "nothing has drifted at the start";
  EXPECT_NEAR(x(after.series, 0, Direction::down, 4), 2.2 - found.over_test.in_native(), exact_um);
  EXPECT_THAT(detail(after.provenance.corrections[0], "Drift over the test"), HasSubstr("-0.2815 µm"));
}

TEST(DriftCorrection, IsRefusedWithASingleApproach) {
  EXPECT_THAT(refusal_of(in_air(), {.drift = true}), HasSubstr("expected n of 2 or more"));
}

TEST(ReadingCorrection, TellsWhatMustBeKnownOfTheReadings) {
  Measured test = table2();
  test.metadata.instrument.sign_reversed = true;
  test.metadata.instrument.gain = 2.0;
  EXPECT_EQ(remarks_on_readings(test).size(), 2u);
  EXPECT_TRUE(remarks_on_readings(correct_readings(test, {.sign = true, .gain = true}).value()).empty());
  test.metadata.instrument.gain = 1.0;
  test.metadata.instrument.sign_reversed = false;
  EXPECT_TRUE(remarks_on_readings(test).empty());
  const auto without_drift = correct_readings(test, {.drift = true}).value();
  EXPECT_THAT(remarks_on_readings(without_drift).at(0).message, HasSubstr("warms up"));
}

TEST(ReadingCorrection, TellsWhoseUncertaintyTheAirBrings) {
  Measured test = correct_readings(in_air(), {.air = AirEquation::ciddor}).value();
  ASSERT_EQ(remarks_on_readings(test).size(), 1u);
  EXPECT_THAT(remarks_on_readings(test)[0].message, HasSubstr("only as far as that of the measuring device"));
  test.metadata.gum.distributions = {{"scale:air", "normal 0 0.3"}};
  EXPECT_TRUE(remarks_on_readings(test).empty());
}

TEST(Assessment, ListsTheRemarksOfTheReader) {
  Measured test = testing_support::table2::complete_test();
  test.provenance.remarks = {{false, "decimal commas"}, {true, "averages only"}};
  const iso230_2::Assessment assessment = iso230_2::assess(test);
  EXPECT_FALSE(assessment.conforming());
  EXPECT_EQ(assessment.findings.front().message, "averages only");
  EXPECT_EQ(assessment.findings.front().clause, "source");
  EXPECT_EQ(assessment.findings.front().severity, iso230_2::Severity::departure);
  EXPECT_EQ(assessment.findings.back().message, "decimal commas");
  EXPECT_EQ(assessment.findings.back().severity, iso230_2::Severity::note);
  const auto quick = iso230_2::assess(test, iso230_2::Depth::departures_only);
  EXPECT_EQ(quick.findings.size(), 1u);
}

}  // namespace
}  // namespace axiometry
