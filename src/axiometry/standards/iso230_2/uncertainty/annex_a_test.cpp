// SPDX-License-Identifier: Apache-2.0
//
// The published examples A.4 to A.7 are in tests/golden_test.cpp; here is what they do not show.
#include "axiometry/standards/iso230_2/uncertainty/annex_a.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <array>
#include <cmath>

#include "axiometry/numeric/random/random.h"
#include "tests/support/series.h"

namespace axiometry::iso230_2 {
namespace {

using testing::Contains;
using testing::HasSubstr;
using testing_support::make_series;
using testing_support::none;
using testing_support::RunDeviations;

/// 1 m, n approaches from either direction.
Series metre(std::size_t n) {
  std::vector<RunDeviations> runs;
  for (std::size_t j = 0; j < n; ++j) runs.push_back({0.1 * static_cast<double>(j % 3), 1.0, 2.0});
  return make_series({0, 480, 1000}, runs, runs);
}

std::optional<AnnexA> annex_of(const Metadata& metadata, const Series& series) {
  return annex_a(metadata, series, evaluate(series));
}

const Contributor& row(const AnnexA& annex, std::string_view key) {
  return *std::ranges::find(annex.budget, key, &Contributor::key);
}
double U(const AnnexA& annex, std::string_view key) { return row(annex, key).U->in_native(); }

TEST(AnnexA, IsAbsentWithoutAnyInput) {
  Metadata m;
  EXPECT_FALSE(annex_of(m, metre(5)));
  m.uncertainty.length = Length::mm(900);
  EXPECT_FALSE(annex_of(m, metre(5))) << "L alone says nothing about uncertainty";
  m.environment.sensors = {{"machine", "", Temperature::celsius(25), {}}};
  EXPECT_FALSE(annex_of(m, metre(5))) << "nobody asked for a budget";
}

/// A.11 and A.14 are for noise of single readings; one swing over the test scatters the approaches more.
TEST(AnnexA, TakesOneSwingOverTheTestWhereTheEnvironmentIsStatedToBeSlow) {
  Metadata m;
  m.uncertainty.environmental_variation = Deviation::native(1.0 / 0.6);  // U_EVE = 1
  const AnnexA printed = annex_of(m, metre(5)).value();
  EXPECT_NEAR(printed.U.R_up->in_native(), 2.0, 1e-12);
  for (const auto kind : {EnvironmentKind::drift, EnvironmentKind::random_walk}) {
    m.gum.environment_kind = kind;
    const AnnexA slow = annex_of(m, metre(5)).value();
    EXPECT_TRUE(slow.slow_environment);
    EXPECT_NEAR(slow.U.R_up->in_native(), 2.6352, 1e-4);
    EXPECT_NEAR(slow.U.R->in_native(), 2.6352 + 1.0 / 3.0, 1e-4);
    EXPECT_EQ(slow.U.E->in_native(), printed.U.E->in_native());
    EXPECT_THAT(slow.notes, Contains(HasSubstr("A.11 and A.14 take 2.64 and 2.97")));
  }
}

/// Readings of an axis that scatters by 0.7 µm, each with noise of a known range: what the same approaches would have
/// given without it lies within U in about 95 % of tests. With the factor for n = 5 two approaches had 68 %.
TEST(AnnexA, HoldsRepeatabilityOfFewApproachesToo) {
  constexpr double axis_um = 0.7, noise_range_um = 1.0;
  constexpr std::uint64_t tests = 400;
  Metadata m;
  m.uncertainty.environmental_variation = Deviation::native(noise_range_um);
  for (const std::size_t n : {2, 3, 4, 5}) {
    int held = 0;
    double U_R = 0.0;
    for (std::uint64_t seed = 0; seed < tests; ++seed) {
      std::vector<double> axis(6 * n), noise(6 * n);
      numeric::fill_normal({seed, n, 1}, axis);
      numeric::fill_uniform({seed, n, 2}, noise);
      std::array<std::vector<RunDeviations>, 2> shown, true_up_down;
      for (std::size_t k = 0; k < axis.size(); k += 3) {
        const auto way = static_cast<std::size_t>(k >= 3 * n);
        RunDeviations without, with;
        for (std::size_t i = k; i < k + 3; ++i) {
          without.push_back(axis_um * axis[i]);
          with.push_back(without.back() + noise_range_um * (noise[i] - 0.5));
        }
        true_up_down[way].push_back(without);
        shown[way].push_back(with);
      }
      const Series series = make_series({0, 480, 1000}, shown[0], shown[1]);
      const auto truth = evaluate(make_series({0, 480, 1000}, true_up_down[0], true_up_down[1])).parameters;
      const auto found = evaluate(series).parameters;
      const AnnexA annex = annex_of(m, series).value();
      U_R = annex.U.R_up->in_native();
      held += std::abs(found.R_up->in_native() - truth.R_up->in_native()) <= U_R;
    }
    EXPECT_NEAR(U_R, 4.0 / std::sqrt(double(n) - 1.0) * 0.6 * noise_range_um, 1e-12);
    EXPECT_GE(held, static_cast<int>(tests) * 92 / 100) << n << " approaches";
  }
}

TEST(AnnexA, ListsAllSevenContributorsInOrder) {
  Metadata m;
  m.uncertainty.device_calibration = Deviation::native(1);
  const auto annex = annex_of(m, metre(5));
  std::vector<std::string_view> keys;
  for (const Contributor& c : annex->budget) keys.push_back(c.key);
  EXPECT_THAT(keys,
              testing::ElementsAre("device", "misalignment", "m_machine", "m_device", "e_machine", "e_device", "eve"));
  EXPECT_FALSE(row(*annex, "eve").U);
  EXPECT_TRUE(row(*annex, "eve").inputs.empty());
}

TEST(AnnexA, PrefersTheCalibrationToTheErrorRangeAndSaysSo) {
  Metadata m;
  m.uncertainty.device_error_range = RelativeLength::um_per_m(10);
  EXPECT_DOUBLE_EQ(U(*annex_of(m, metre(5)), "device"), 6.0);
  EXPECT_EQ(row(*annex_of(m, metre(5)), "device").formula, "A.3");
  m.uncertainty.device_calibration_per_length = RelativeLength::um_per_m(2);
  EXPECT_DOUBLE_EQ(U(*annex_of(m, metre(5)), "device"), 2.0);
  EXPECT_THAT(annex_of(m, metre(5))->notes, Contains(HasSubstr("the calibration was taken")));
}

TEST(AnnexA, AddsBothPartsOfACalibrationAsTheCertificateDoes) {
  Metadata m;
  m.uncertainty.device_calibration = Deviation::native(0.7);
  EXPECT_DOUBLE_EQ(U(*annex_of(m, metre(5)), "device"), 0.7);
  EXPECT_EQ(row(*annex_of(m, metre(5)), "device").formula, "A.1");
  m.uncertainty.device_calibration_per_length = RelativeLength::um_per_m(2);
  EXPECT_DOUBLE_EQ(U(*annex_of(m, metre(5)), "device"), 2.7);
  EXPECT_EQ(row(*annex_of(m, metre(5)), "device").formula, "A.1 + A.2");
  m.uncertainty.device_calibration_sum = CalibrationSum::quadratic;
  EXPECT_DOUBLE_EQ(U(*annex_of(m, metre(5)), "device"), std::hypot(0.7, 2.0));
}

TEST(AnnexA, TakesTheMisalignmentFromTheAngleWhereThatIsStated) {
  Metadata m;
  m.gum.alignment_angle = Angle::deg(0.1);
  const double R = 1000.0 * std::tan(0.1 * M_PI / 180.0);
  EXPECT_NEAR(U(*annex_of(m, metre(5)), "misalignment"), 0.3 * R * R, 1e-9);
}

TEST(AnnexA, TakesTheMeasuredTravelForALengthNotGiven) {
  Metadata m;
  m.uncertainty.device_calibration_per_length = RelativeLength::um_per_m(2);
  EXPECT_DOUBLE_EQ(U(*annex_of(m, metre(5)), "device"), 2.0);
  EXPECT_EQ(row(*annex_of(m, metre(5)), "device").inputs[1].note, "measured travel");
  m.uncertainty.length = Length::mm(1200);
  EXPECT_DOUBLE_EQ(U(*annex_of(m, metre(5)), "device"), 2.4);
  m.uncertainty.length = Length::mm(500);
  EXPECT_DOUBLE_EQ(U(*annex_of(m, metre(5)), "device"), 2.0) << "half of what was measured is not L";
}

TEST(AnnexA, FindsTheExpansionCoefficientWhereItWasGiven) {
  Metadata m;
  m.uncertainty.machine_temperature_range = TemperatureDifference::kelvin(1);
  EXPECT_DOUBLE_EQ(U(*annex_of(m, metre(5)), "m_machine"), 0.6 * 12);
  EXPECT_EQ(row(*annex_of(m, metre(5)), "m_machine").inputs[0].note, "assumed");
  m.nde.machine_expansion = ExpansionCoefficient::um_per_m_K(11);
  EXPECT_DOUBLE_EQ(U(*annex_of(m, metre(5)), "m_machine"), 0.6 * 11);
  m.axis.scale_expansion = ExpansionCoefficient::um_per_m_K(10);
  EXPECT_DOUBLE_EQ(U(*annex_of(m, metre(5)), "m_machine"), 0.6 * 10);
  m.uncertainty.machine_expansion = ExpansionCoefficient::um_per_m_K(8);
  EXPECT_DOUBLE_EQ(U(*annex_of(m, metre(5)), "m_machine"), 0.6 * 8);
}

TEST(AnnexA, TakesTheLargestDepartureOfTheMachineSensors) {
  Metadata m;
  m.uncertainty.machine_temperature_range = TemperatureDifference::kelvin(1);
  m.environment.sensors = {{"equipment", "", Temperature::celsius(30), {}},
                           {"Machine", "", Temperature::celsius(21), Temperature::celsius(17)}};
  const auto annex = annex_of(m, metre(5));
  EXPECT_DOUBLE_EQ(U(*annex, "e_machine"), 0.6 * 3 * 2);
  EXPECT_THAT(annex->notes, Contains(HasSubstr("R(α) of the machine tool was not given")));
  EXPECT_FALSE(row(*annex, "e_device").U) << "the device's statement includes its temperature unless told otherwise";
}

TEST(AnnexA, CountsTheMagnitudeOfANegativeDifference) {
  Metadata m;
  m.uncertainty.machine_temperature_difference = TemperatureDifference::kelvin(-4);
  m.uncertainty.machine_expansion_range = ExpansionCoefficient::um_per_m_K(1);
  EXPECT_DOUBLE_EQ(U(*annex_of(m, metre(5)), "e_machine"), 0.6 * 4);
}

TEST(AnnexA, ComputesTheTermsOfTheDeviceWhenAsked) {
  Metadata m;
  m.uncertainty.device_temperature_range = TemperatureDifference::kelvin(0.5);
  EXPECT_FALSE(annex_of(m, metre(5))) << "α of the device is missing and nothing else is known";
  m.uncertainty.device_expansion = ExpansionCoefficient::um_per_m_K(8);
  m.uncertainty.device_temperature_difference = TemperatureDifference::kelvin(2);
  const auto annex = annex_of(m, metre(5));
  EXPECT_DOUBLE_EQ(U(*annex, "m_device"), 0.6 * 8 * 0.5);
  EXPECT_DOUBLE_EQ(U(*annex, "e_device"), 0.6 * 2 * 2);
}

TEST(AnnexA, CallsTheMisalignmentOfAShortAxisByItsName) {
  Metadata m;
  m.uncertainty.misalignment = Length::mm(4);
  const Series short_axis = make_series({0, 50, 200}, {{0, 0, 0}}, {{0, 0, 0}});
  const auto annex = annex_of(m, short_axis);
  EXPECT_NEAR(U(*annex, "misalignment"), 24.0, 1e-9);
  EXPECT_THAT(annex->notes, Contains(HasSubstr("not negligible under 300 mm: 24 µm at L = 200 mm")));
  Metadata silent;
  silent.uncertainty.device_calibration = Deviation::native(1);
  EXPECT_THAT(annex_of(silent, short_axis)->notes, Contains(HasSubstr("1 mm over 200 mm gives 1.5 µm")));
}

TEST(AnnexA, GeneralisesTheNumberOfApproaches) {
  Metadata m;
  m.uncertainty.device_calibration = Deviation::native(3);
  m.uncertainty.environmental_variation = Deviation::native(5);  // U_EVE = 3
  const auto U_with = [&](std::size_t n) { return annex_of(m, metre(n))->U; };
  EXPECT_DOUBLE_EQ(U_with(5).B->in_native(), 0.9 * 3);
  EXPECT_DOUBLE_EQ(U_with(4).B->in_native(), 2 * 3 / 2.0);
  EXPECT_DOUBLE_EQ(U_with(1).B->in_native(), 2 * 3);
  EXPECT_DOUBLE_EQ(U_with(4).E->in_native(), std::sqrt(9 + 9 / 4.0));
  EXPECT_DOUBLE_EQ(U_with(1).E->in_native(), std::sqrt(9 + 9.0));
  EXPECT_DOUBLE_EQ(U_with(1).M->in_native(), std::sqrt(9 + 9 / 2.0));
  EXPECT_FALSE(U_with(1).A);
  EXPECT_FALSE(U_with(1).R_up);
  EXPECT_THAT(annex_of(m, metre(4))->notes, Contains(HasSubstr("For n = 4")));
}

TEST(AnnexA, CountsTheSmallestNumberOfApproaches) {
  Metadata m;
  m.uncertainty.environmental_variation = Deviation::native(1);
  EXPECT_EQ(annex_of(m, make_series({0, 1}, {{0, 0}, {0, 0}, {0, none}}, {{0, none}, {0, none}}))->runs, 2u);
}

TEST(AnnexA, StatesNoUncertaintyOfRepeatabilityWithoutTheEnvironment) {
  Metadata m;
  m.uncertainty.device_calibration = Deviation::native(1);
  const auto annex = annex_of(m, metre(5));
  EXPECT_TRUE(annex->U.E && annex->U.A);
  EXPECT_FALSE(annex->U.R || annex->U.R_up || annex->U.B || annex->U.B_mean);
}

TEST(AnnexA, FloorsTheCorrectedEstimatorAtZero) {
  Metadata m;
  m.uncertainty.environmental_variation = Deviation::native(1.5);                              // U_EVE/2 = 0.45
  const std::vector<RunDeviations> up = {{1, 0.1}, {-1, -0.1}, {1, 0.1}, {-1, -0.1}, {0, 0}};  // s = 1 and 0.1
  const auto annex = annex_of(m, make_series({0, 400}, up, up));
  ASSERT_TRUE(annex->corrected);
  EXPECT_THAT(annex->corrected->floored, testing::ElementsAre(1u));
  EXPECT_NEAR(annex->corrected->positions[0].s_up->in_native(), std::sqrt(1 - 0.45 * 0.45), 1e-12);
  EXPECT_EQ(annex->corrected->positions[1].R_up->in_native(), 0.0);
  EXPECT_NEAR(annex->corrected->parameters.R_up->in_native(), 4 * std::sqrt(1 - 0.45 * 0.45), 1e-12);
}

TEST(AnnexA, CorrectsNothingAboveTwoMetres) {
  Metadata m;
  m.uncertainty.environmental_variation = Deviation::native(1.5);
  const std::vector<RunDeviations> runs = {{0, 1}, {1, 2}};
  const auto annex = annex_of(m, make_series({0, 2400}, runs, runs));
  EXPECT_FALSE(annex->corrected);
  EXPECT_TRUE(annex->U.R);
  EXPECT_THAT(annex->notes, Contains(HasSubstr("2 000 mm")));
}

TEST(AnnexA, LeavesOutWhatAnAbsurdLengthWouldMakeInfinite) {
  Metadata m;
  m.uncertainty.misalignment = Length::mm(1);
  m.uncertainty.device_calibration = Deviation::native(1);
  const auto annex = annex_of(m, make_series({0, 1e-305}, {{0, 0}}, {{0, 0}}));
  EXPECT_FALSE(row(*annex, "misalignment").U);
  EXPECT_DOUBLE_EQ(annex->U.E->in_native(), 1.0);
}

TEST(AnnexA, KeepsOnRotaryAxesWhatHasNoLength) {
  Metadata m;
  m.axis.kind = AxisKind::rotary;
  m.uncertainty.device_calibration = Deviation::native(3);
  m.uncertainty.misalignment = Length::mm(4);
  m.uncertainty.machine_temperature_range = TemperatureDifference::kelvin(1);
  m.uncertainty.environmental_variation = Deviation::native(5);
  const auto annex = annex_of(m, metre(5));
  EXPECT_FALSE(row(*annex, "misalignment").U || row(*annex, "m_machine").U);
  EXPECT_DOUBLE_EQ(annex->U.E->in_native(), std::sqrt(9 + 9 / 5.0));
  EXPECT_EQ(row(*annex, "device").inputs[0].unit, "″");
  EXPECT_THAT(annex->notes, Contains(HasSubstr("linear axes")));
}

/// Of everything that Annex A has, on a metre.
Metadata all_given() {
  Metadata m;
  AnnexAInputs& in = m.uncertainty;
  in.device_calibration = Deviation::native(0.7);
  in.device_calibration_per_length = RelativeLength::um_per_m(2);
  in.misalignment = Length::mm(2);
  in.machine_temperature_range = TemperatureDifference::kelvin(0.7);
  in.machine_temperature_difference = TemperatureDifference::kelvin(5);
  in.device_temperature_range = TemperatureDifference::kelvin(0.2);
  in.device_temperature_difference = TemperatureDifference::kelvin(1);
  in.device_expansion = ExpansionCoefficient::um_per_m_K(8);
  in.environmental_variation = Deviation::native(1.7);
  return m;
}

TEST(AnnexAPositions, OfTheFarthestTargetAreThoseOfTheParametersAsTheAnnexCombinesThem) {
  for (const CalibrationSum sum : {CalibrationSum::linear, CalibrationSum::quadratic}) {
    Metadata m = all_given();
    m.uncertainty.device_calibration_sum = sum;
    const AnnexA annex = annex_of(m, metre(5)).value();
    ASSERT_EQ(annex.positions.size(), 3u);
    const AnnexAPosition& last = annex.positions.back();
    EXPECT_DOUBLE_EQ(last.length_m.value(), 1.0);
    for (std::size_t k = 0; k < annex.budget.size(); ++k) {
      if (annex.budget[k].key == "eve") {
        EXPECT_FALSE(last.contributions[k]) << "it is divided by the approaches";
        continue;
      }
      ASSERT_TRUE(annex.budget[k].U) << annex.budget[k].key;
      EXPECT_DOUBLE_EQ(last.contributions[k]->in_native(), annex.budget[k].U->in_native()) << annex.budget[k].key;
    }
    EXPECT_DOUBLE_EQ(last.up->U.in_native(), annex.U.E_up->in_native());      // A.15
    EXPECT_DOUBLE_EQ(last.down->U.in_native(), annex.U.E_down->in_native());  // A.15
    EXPECT_DOUBLE_EQ(last.mean->U.in_native(), annex.U.M->in_native());       // A.16
  }
}

TEST(AnnexAPositions, KeepAtTheDatumOnlyWhatDoesNotGrowWithTheLength) {
  const AnnexA annex = annex_of(all_given(), metre(5)).value();
  const AnnexAPosition& first = annex.positions.front();
  EXPECT_EQ(first.length_m, 0.0);
  for (std::size_t k = 0; k < annex.budget.size(); ++k) {
    if (annex.budget[k].key == "eve") continue;
    EXPECT_EQ(first.contributions[k]->in_native(), annex.budget[k].key == "device" ? 0.7 : 0.0) << annex.budget[k].key;
  }
  const double U_eve = 0.6 * 1.7;
  EXPECT_DOUBLE_EQ(first.up->environment->in_native(), U_eve / std::sqrt(5.0));
  EXPECT_DOUBLE_EQ(first.up->U.in_native(), std::hypot(0.7, U_eve / std::sqrt(5.0)));
  EXPECT_DOUBLE_EQ(first.mean->U.in_native(), std::hypot(0.7, U_eve / std::sqrt(10.0)));
}

TEST(AnnexAPositions, TakeTheLengthAtTheirTarget) {
  const AnnexA annex = annex_of(all_given(), metre(5)).value();
  const AnnexAPosition& middle = annex.positions[1];
  EXPECT_DOUBLE_EQ(middle.length_m.value(), 0.48);
  const double l = 0.48;
  const double expected[] = {0.7 + 2 * l,       0.3 * 2 * 2 * l, 0.6 * 12 * l * 0.7,
                             0.6 * 8 * l * 0.2, 0.6 * 5 * l * 2, 0.6 * 1 * l * 2};
  for (std::size_t k = 0; k < std::size(expected); ++k)
    EXPECT_NEAR(middle.contributions[k]->in_native(), expected[k], 1e-12) << annex.budget[k].key;
}

TEST(AnnexAPositions, CountFromWhereTheInstrumentWasSetToZero) {
  Metadata m = all_given();
  m.nde.datum = Position::native(480);
  AnnexA annex = annex_of(m, metre(5)).value();
  EXPECT_DOUBLE_EQ(annex.positions[0].length_m.value(), 0.48);
  EXPECT_EQ(annex.positions[1].length_m, 0.0);
  EXPECT_DOUBLE_EQ(annex.positions[2].length_m.value(), 0.52);
  m.nde.datum.reset();
  m.uncertainty.length = Length::mm(1500);  // every length grows with it
  annex = annex_of(m, metre(5)).value();
  EXPECT_DOUBLE_EQ(annex.positions[1].length_m.value(), 0.72);
  EXPECT_NEAR(annex.positions[2].mean->U.in_native(), annex.U.M->in_native(), 1e-12);
}

TEST(AnnexAPositions, DivideTheEnvironmentByTheApproachesOfTheirOwnCell) {
  Metadata m;
  m.uncertainty.environmental_variation = Deviation::native(1.0 / 0.6);  // U_EVE = 1
  const std::vector<RunDeviations> up = {{0.0, 1.0}, {0.1, 1.1}, {0.2, none}, {0.3, none}};
  const std::vector<RunDeviations> down = {{none, 1.0}, {none, 1.1}, {none, 1.2}, {none, 1.3}};
  const AnnexA annex = annex_of(m, make_series({0, 1000}, up, down)).value();
  EXPECT_DOUBLE_EQ(annex.positions[0].up->U.in_native(), 0.5);
  EXPECT_FALSE(annex.positions[0].down);
  EXPECT_FALSE(annex.positions[0].mean) << "of one direction there is no mean of both";
  EXPECT_DOUBLE_EQ(annex.positions[1].up->U.in_native(), std::sqrt(0.5));
  EXPECT_DOUBLE_EQ(annex.positions[1].down->U.in_native(), 0.5);
  EXPECT_DOUBLE_EQ(annex.positions[1].mean->U.in_native(), std::sqrt((0.5 + 0.25) / 4.0));
}

TEST(AnnexAPositions, SayWhichContributorsAreMissing) {
  EXPECT_TRUE(missing_contributors(annex_of(all_given(), metre(5))->budget, AxisKind::linear).empty());
  Metadata m;
  m.uncertainty.device_calibration = Deviation::native(1);
  const AnnexA annex = annex_of(m, metre(5)).value();
  EXPECT_THAT(missing_contributors(annex.budget, AxisKind::linear),
              testing::ElementsAre("misalignment", "m_machine", "e_machine", "eve"));
  EXPECT_THAT(missing_contributors(annex.budget, AxisKind::rotary), testing::ElementsAre("eve"));
  EXPECT_FALSE(annex.positions[1].contributions[1]) << "absent is not 0";
  EXPECT_FALSE(annex.positions[1].mean->environment);
  EXPECT_EQ(missing_contributors({}, AxisKind::linear).size(), 5u);
}

/// ″ do not grow with a length.
TEST(AnnexAPositions, OfARotaryAxisAreTheSameEverywhere) {
  Metadata m;
  m.axis.kind = AxisKind::rotary;
  m.uncertainty.device_calibration = Deviation::native(1.5);
  const AnnexA annex = annex_of(m, metre(5)).value();
  for (const AnnexAPosition& position : annex.positions) {
    EXPECT_FALSE(position.length_m);
    EXPECT_DOUBLE_EQ(position.mean->U.in_native(), annex.U.M->in_native());
  }
}

}  // namespace
}  // namespace axiometry::iso230_2
