// SPDX-License-Identifier: Apache-2.0
#include "axiometry/standards/iso230_2/inputs/resolved_inputs.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <set>

#include "axiometry/model/fields.h"
#include "axiometry/standards/iso230_2/assessment/assessment.h"
#include "axiometry/standards/iso230_2/monte_carlo/trials.h"
#include "tests/support/series.h"

namespace axiometry::iso230_2 {
namespace {

using testing::HasSubstr;
using testing::IsEmpty;

/// The readings of Table 2 with the budget of Table A.5, as examples/iso230-2-table2.csv has it.
axiometry::Test example() {
  axiometry::Test test = testing_support::table2::complete_test();
  test.metadata.nde.machine_expansion = ExpansionCoefficient::um_per_m_K(12);
  test.metadata.axis.scale_expansion = ExpansionCoefficient::um_per_m_K(12);
  return test;
}

/// As the command line states it.
axiometry::Test with_flags(axiometry::Test test, const std::vector<std::pair<std::string, std::string>>& flags) {
  for (const auto& [key, text] : flags) {
    const auto set = set_field_text(test.metadata, key, text);
    EXPECT_TRUE(set) << set.error().message;
    test.provenance.stated.items.push_back({key, StatedBy::flag, {}, 1});
  }
  return test;
}

ResolvedInputs resolved(const axiometry::Test& test) {
  return resolve_inputs(test.metadata, test.series, test.provenance.stated);
}

const ResolvedRow& row_of(const ResolvedInputs& inputs, std::string_view key) {
  for (const ResolvedRow& row : inputs.rows)
    if (row.key == key) return row;
  throw std::out_of_range(std::string(key));
}

std::vector<std::string> remarks_of(const ResolvedInputs& inputs) {
  std::vector<std::string> all;
  for (const ResolvedRemark& remark : inputs.remarks) all.push_back(remark.message);
  return all;
}

double annex_U(const axiometry::Test& test, std::string_view key) {
  const auto annex = annex_a(test.metadata, test.series, evaluate(test.series), test.provenance.stated);
  return (annex->U.*find_parameter(key)->member)->in_native();
}

GumUncertainty gum_of(const axiometry::Test& test) {
  auto result = gum(test, evaluate(test.series));
  EXPECT_TRUE(result) << result.error().message;
  return result.value().value();
}

double gum_U(const axiometry::Test& test, std::string_view key) {
  return gum_of(test).find(key)->uncertainty.U.in_native();
}

MonteCarlo trials_of(const axiometry::Test& test) {
  MonteCarloOptions options;
  options.propagation.trials = 2000;
  options.propagation.threads = 1;
  options.contribution_trials = 0;
  auto result = monte_carlo(test, evaluate(test.series), options);
  EXPECT_TRUE(result) << result.error().message;
  return *std::move(*result);
}

TEST(ResolvedInputs, OfOneStatementEachAreThatStatement) {
  const ResolvedInputs inputs = resolved(example());
  EXPECT_THAT(remarks_of(inputs), IsEmpty());
  EXPECT_EQ(inputs.length_m.value, 1.751);
  EXPECT_EQ(inputs.device_calibration.per_length->value, 1.0);
  EXPECT_FALSE(inputs.device_calibration.constant);
  EXPECT_EQ(inputs.machine->expansion->value, 12.0);
  EXPECT_EQ(inputs.machine->expansion_range->value, 2.0);
  EXPECT_EQ(inputs.machine->difference->value, 1.0);
  EXPECT_EQ(inputs.machine->temperature_range->value, 0.2);
  EXPECT_FALSE(inputs.device);
  for (const ResolvedRow& row : inputs.rows) {
    EXPECT_EQ(row.use, InputUse::all) << row.key;
    EXPECT_EQ(row.origin, InputOrigin::file) << row.key;
  }
}

TEST(ResolvedInputs, ShowWhatWasAssumed) {
  axiometry::Test test = example();
  test.metadata.uncertainty.machine_expansion.reset();
  test.metadata.uncertainty.machine_expansion_range.reset();
  test.metadata.uncertainty.length.reset();
  test.metadata.nde = {};
  test.metadata.axis.scale_expansion.reset();
  const ResolvedInputs inputs = resolved(test);
  EXPECT_EQ(row_of(inputs, "uncertainty.machine_expansion_um_per_m_C").origin, InputOrigin::assumed);
  EXPECT_EQ(*row_of(inputs, "uncertainty.machine_expansion_um_per_m_C").value, 12.0);
  EXPECT_EQ(row_of(inputs, "uncertainty.machine_expansion_range_um_per_m_C").origin, InputOrigin::assumed);
  EXPECT_EQ(row_of(inputs, "uncertainty.length_mm").origin, InputOrigin::measured_travel);
  EXPECT_THAT(remarks_of(inputs), IsEmpty()) << "budgets mark what is assumed";
}

TEST(ResolvedInputs, LetAFlagWinOverAnotherStatementOfTheFileAboutTheSameThing) {
  const axiometry::Test test = with_flags(example(), {{"uncertainty.device_error_range_um_per_m", "50"}});
  const ResolvedInputs inputs = resolved(test);
  EXPECT_EQ(inputs.device_error_range->value, 50.0);
  EXPECT_FALSE(inputs.device_calibration.per_length);
  EXPECT_EQ(row_of(inputs, "uncertainty.device_calibration_um_per_m").use, InputUse::none);
  EXPECT_THAT(remarks_of(inputs),
              testing::ElementsAre("uncertainty.device_calibration_um_per_m = 1 µm/m (file) does not count: "
                                   "uncertainty.device_error_range_um_per_m = 50 µm/m (flag) takes its place"));
  EXPECT_NEAR(annex_U(test, "A"), 52.7, 0.1);
  EXPECT_GT(gum_U(test, "A"), 30.0) << "over the 1.06 m between the extremes";
  EXPECT_GT(trials_of(test).distributions[0]->summary.sd, 10.0);
}

TEST(ResolvedInputs, KeepTheCalibrationWhereTheSamePlaceStatesAnErrorRangeToo) {
  axiometry::Test test = example();
  test.metadata.uncertainty.device_error_range = RelativeLength::um_per_m(50);
  const ResolvedInputs inputs = resolved(test);
  EXPECT_FALSE(inputs.device_error_range);
  EXPECT_THAT(remarks_of(inputs),
              testing::ElementsAre(HasSubstr("device_error_range_um_per_m = 50 µm/m (file) does not")));
}

TEST(ResolvedInputs, LetAFlaggedCoefficientReachEveryMethod) {
  const axiometry::Test test = with_flags(example(), {{"uncertainty.machine_expansion_um_per_m_C", "20"}});
  EXPECT_GT(annex_U(test, "E"), annex_U(example(), "E"));
  EXPECT_GT(gum_U(test, "E"), gum_U(example(), "E"));
  EXPECT_GT(trials_of(test).distributions[3]->summary.sd, trials_of(example()).distributions[3]->summary.sd);
  EXPECT_THAT(remarks_of(resolved(test)),
              testing::Contains(testing::AllOf(HasSubstr("nde.machine_expansion_um_per_m_C = 12"), HasSubstr("14 µm"))))
      << "the correction took another coefficient";
}

TEST(ResolvedInputs, SayWhatCannotAct) {
  const ResolvedInputs inputs = resolved(with_flags(example(), {{"uncertainty.device_temperature_range_C", "9"}}));
  ASSERT_EQ(inputs.remarks.size(), 1);
  EXPECT_TRUE(inputs.remarks[0].missing);
  EXPECT_EQ(
      inputs.remarks[0].message,
      "uncertainty.device_temperature_range_C = 9 °C (flag) cannot act: the expansion coefficient of the measuring "
      "device is not known");
}

TEST(ResolvedInputs, LetFlaggedSensorsWinOverADifferenceOfTheFile) {
  axiometry::Test test = example();
  test.metadata.environment.sensors.push_back({"machine", "table", Temperature::celsius(25), Temperature::celsius(25)});
  EXPECT_EQ(resolved(test).machine->difference->value, 5.0)
      << "no largest difference is smaller than one that is shown";
  EXPECT_THAT(remarks_of(resolved(test)),
              testing::ElementsAre(HasSubstr("temperature_difference_C = 1 °C (file) does not count: sensors")));
  test.provenance.stated.items = {{"uncertainty.machine_temperature_difference_C", StatedBy::flag}};
  EXPECT_EQ(resolved(test).machine->difference->value, 1.0) << "a flag wins over the file";
  EXPECT_THAT(remarks_of(resolved(test)),
              testing::ElementsAre(HasSubstr("sensors (machine) = 5 °C (file) does not count")));
  test.provenance.stated.items = {{"sensors", StatedBy::flag, {}, 1}};
  EXPECT_EQ(resolved(test).machine->difference->value, 5.0);
  EXPECT_THAT(remarks_of(resolved(test)),
              testing::ElementsAre(HasSubstr("temperature_difference_C = 1 °C (file) does not")));
  test.metadata.environment.sensors.push_back({"air", "beam", Temperature::celsius(21), Temperature::celsius(21)});
  EXPECT_EQ(resolved(test).machine->difference->value, 5.0) << "of the flag is the last one alone, of the air";
}

TEST(ResolvedInputs, LetAFlagWinOverADistributionOfTheFile) {
  axiometry::Test test = example();
  test.metadata.gum.distributions = {{"device", "uniform -1 1"}};
  EXPECT_EQ(resolved(test).distributions.size(), 1);
  EXPECT_EQ(row_of(resolved(test), "uncertainty.device_calibration_um_per_m").use, InputUse::annex_a);
  const axiometry::Test flagged = with_flags(test, {{"uncertainty.device_calibration_um_per_m", "9"}});
  EXPECT_THAT(resolved(flagged).distributions, IsEmpty());
  EXPECT_GT(gum_U(flagged, "E"), 9.0);
}

TEST(ResolvedInputs, LetADistributionOfAFlagTakeThePlaceOfThatOfTheFile) {
  axiometry::Test test = example();
  test.metadata.gum.distributions = {{"device", "uniform -1 1"}, {"device", "uniform -2 2"}};
  EXPECT_FALSE(uncertainty_inputs(test.metadata, test.series)) << "the file states both";
  test.provenance.stated.items = {{"uncertainty.distributions", StatedBy::flag, {}, 1}};
  const ResolvedInputs inputs = resolved(test);
  ASSERT_EQ(inputs.distributions.size(), 1);
  EXPECT_EQ(inputs.distributions[0].distribution, "uniform -2 2");
  EXPECT_THAT(remarks_of(inputs), testing::Contains(HasSubstr("uniform -1 1 (file) does not count")));
}

TEST(ResolvedInputs, PutBothPartsOfACalibrationTogetherAsTheCertificateSays) {
  axiometry::Test test = example();
  test.metadata.uncertainty.device_calibration = Deviation::native(2);
  ResolvedCalibration certificate = resolved(test).device_calibration;
  EXPECT_NEAR(certificate.at(1.751), 3.751, 1e-12) << "linear unless it says otherwise";
  test.metadata.uncertainty.device_calibration_sum = CalibrationSum::quadratic;
  certificate = resolved(test).device_calibration;
  EXPECT_NEAR(certificate.at(1.751), std::hypot(2, 1.751), 1e-12);
  EXPECT_EQ(certificate.widening(1.751), 1.0);
}

TEST(ResolvedInputs, NeverStateLessForADisplacementThanTheCertificate) {
  for (const double a : {0.0, 0.1, 1.0, 5.0, 100.0})
    for (const double b : {0.0, 0.3, 1.0, 20.0})
      for (const double L : {0.2, 1.751, 30.0}) {
        const ResolvedCalibration certificate{ResolvedValue{a}, ResolvedValue{b}, CalibrationSum::linear};
        const double w = certificate.widening(L);
        EXPECT_LE(w, std::sqrt(2.0));
        for (int k = 1; k <= 1000; ++k) {
          const double l = L * k / 1000.0;
          const double stated = a + b * l;
          EXPECT_GE(w * std::hypot(a, b * l), stated * (1.0 - 1e-12)) << a << " " << b << " " << l;
        }
        const double narrowest = b > 0.0 ? std::min(L, a / b) : L;
        EXPECT_NEAR(w * std::hypot(a, b * narrowest), a + b * narrowest, 1e-9) << "and somewhere no more than needed";
      }
}

TEST(ResolvedInputs, GiveEveryDisplacementOfATestAtLeastWhatTheCertificateStates) {
  Metadata m;
  m.uncertainty.device_calibration = Deviation::native(1);
  m.uncertainty.device_calibration_per_length = RelativeLength::um_per_m(2);
  for (const double far : {10.0, 100.0, 500.0, 2000.0}) {
    const Series series = testing_support::make_series({0, far}, {{0, 5}, {0, 5}, {0, 5}}, {});
    const auto result = gum(axiometry::Test{m, series, {}}, evaluate(series));
    EXPECT_GE((*result)->find("E_up")->uncertainty.U.in_native(), (1.0 + 2e-3 * far) * (1.0 - 1e-12)) << far;
    EXPECT_GE((*result)->positions[1].up->total.U.in_native(), (1.0 + 2e-3 * far) * (1.0 - 1e-12)) << far;
  }
}

TEST(ResolvedInputs, TellWhenACalibrationIsPutTogetherFromTwoSources) {
  const axiometry::Test test = with_flags(example(), {{"uncertainty.device_calibration", "2"}});
  EXPECT_THAT(remarks_of(resolved(test)), testing::ElementsAre(HasSubstr("put together from two sources")));
  EXPECT_NEAR(annex_U(test, "M"), std::sqrt(3.738 * 3.738 - 1.751 * 1.751 + 3.751 * 3.751), 0.01);
}

/// What every method states, in one line of figures.
std::vector<double> stated_by_all(const axiometry::Test& test, bool annex, bool propagated) {
  std::vector<double> figures;
  if (annex)
    for (const ParameterInfo& info : parameters) figures.push_back(annex_U(test, info.key));
  if (!propagated) return figures;
  const GumUncertainty u = gum_of(test);
  for (const GumParameter& p : u.parameters) figures.push_back(p.uncertainty.U.in_native());
  for (const PositionUncertainty& p : u.positions) figures.push_back(p.mean->U.in_native());
  return figures;
}

TEST(ResolvedInputs, NoItemOfTheUncertaintyIsEverSilent) {
  // Those of another question: which uncertainty is stated, and how E_VE moves the readings.
  const std::set<std::string_view> of_other_tests = {"uncertainty.measurand", "uncertainty.method",
                                                     "uncertainty.environment_kind", "uncertainty.drift_recording",
                                                     "uncertainty.drift_interval_s"};
  // Annex A has no formula for these, and says so.
  const std::set<std::string_view> beyond_annex_a = {"uncertainty.axis_resolution",
                                                     "uncertainty.instrument_resolution",
                                                     "uncertainty.environment_sensitivity_um_per_m_C",
                                                     "uncertainty.up_down_correlation",
                                                     "uncertainty.run_drift",
                                                     "uncertainty.distributions"};
  const axiometry::Test before = example();
  for (const axiometry::Field& field : metadata_fields()) {
    if (!field.key.starts_with("uncertainty.") || of_other_tests.contains(field.key)) continue;
    const std::string text = field.type == FieldType::records     ? "scale:optics | normal 0 3"
                             : field.type == FieldType::choice    ? std::string(field.choices.back())
                             : field.key.ends_with("correlation") ? "0.5"
                                                                  : "9";
    const axiometry::Test after = with_flags(before, {{std::string(field.key), text}});
    const auto remarks = remarks_of(resolved(after));
    const bool named =
        std::ranges::any_of(remarks, [&](const std::string& remark) { return remark.contains(field.key); });
    const bool annex = stated_by_all(before, true, false) != stated_by_all(after, true, false);
    const bool propagated = stated_by_all(before, false, true) != stated_by_all(after, false, true);
    EXPECT_TRUE(named || (annex && propagated)) << field.key;
    if (beyond_annex_a.contains(field.key)) EXPECT_TRUE(named && (propagated || !annex)) << field.key;
  }
}

/// Metres for millimetres made U a thousandth of itself.
TEST(ResolvedInputs, TakeNoLengthShorterThanWhatWasMeasured) {
  axiometry::Test test = example();
  test.metadata.uncertainty.length.reset();
  const double U = annex_U(test, "E");
  test.metadata.uncertainty.length = Length::mm(1.751);
  const ResolvedInputs inputs = resolved(test);
  EXPECT_EQ(inputs.length_m.origin, InputOrigin::measured_travel);
  EXPECT_NEAR(inputs.length_m.value, 1.744209, 1e-9);
  EXPECT_EQ(row_of(inputs, "uncertainty.length_mm").use, InputUse::none);
  EXPECT_THAT(remarks_of(inputs), testing::ElementsAre("uncertainty.length_mm = 1.751 mm (file) does not count: the "
                                                       "readings reach over 1744.209 mm"));
  EXPECT_EQ(annex_U(test, "E"), U);
  test.metadata.uncertainty.length = Length::mm(1744);
  EXPECT_EQ(resolved(test).length_m.value, 1.744) << "rounded";
  EXPECT_THAT(remarks_of(resolved(test)), IsEmpty());
}

TEST(ResolvedInputs, TellOfALengthFarAboveWhatWasMeasured) {
  axiometry::Test test = example();
  test.metadata.uncertainty.length = Length::mm(2100);
  EXPECT_THAT(remarks_of(resolved(test)), IsEmpty());
  test.metadata.uncertainty.length = Length::mm(17510);
  EXPECT_EQ(resolved(test).length_m.value, 17.51);
  EXPECT_THAT(remarks_of(resolved(test)),
              testing::ElementsAre(HasSubstr("uncertainty.length_mm = 17510 mm (file) is far above the 1744.209 mm")));
}

TEST(ResolvedInputs, OnARotaryAxisNameWhatMeansNothingThere) {
  axiometry::Test test = example();
  test.metadata.axis.kind = AxisKind::rotary;
  const auto remarks = remarks_of(resolved(test));
  for (std::string_view key : {"device_calibration_um_per_m", "misalignment_mm", "machine_expansion_um_per_m_C",
                               "machine_temperature_range_C", "length_mm"})
    EXPECT_THAT(remarks, testing::Contains(testing::AllOf(HasSubstr(key), HasSubstr("rotary axis"))));
}

TEST(ResolvedInputs, TakeTheStrongerOfTwoMisalignments) {
  axiometry::Test test = example();
  test.metadata.gum.alignment_angle = Angle::deg(0.01);
  EXPECT_EQ(resolved(test).misalignment_mm->value, 1.0) << "of two alike the larger";
  test.metadata.gum.alignment_angle = Angle::deg(1);
  EXPECT_NEAR(resolved(test).misalignment_mm->value, 1751 * std::tan(M_PI / 180), 1e-9);
  const axiometry::Test flagged = with_flags(example(), {{"uncertainty.alignment_angle_deg", "0.01"}});
  EXPECT_EQ(resolved(flagged).alignment_deg->value, 0.01);
  EXPECT_LT(annex_U(flagged, "E"), annex_U(example(), "E"));
}

TEST(ResolvedInputs, AreFindingsOfTheAssessment) {
  const Assessment assessment = assess(with_flags(example(), {{"uncertainty.device_temperature_range_C", "9"}}));
  EXPECT_THAT(assessment.findings,
              testing::Contains(testing::AllOf(
                  testing::Field(&Finding::clause, "8.2.1"), testing::Field(&Finding::severity, Severity::missing),
                  testing::Field(&Finding::message, HasSubstr("device_temperature_range_C")))));
  EXPECT_FALSE(assessment.inputs.rows.empty());
}

TEST(MeanCosineError, IsInsideTheUncertainty) {
  axiometry::Test test = example();
  test.metadata.uncertainty = {};
  test.metadata.gum.alignment_angle = Angle::deg(1);
  const GumUncertainty u = gum_of(test);
  const auto* E = u.find("E");
  double mean = 0.0;
  for (std::size_t k = 0; k < u.sources.size(); ++k)
    if (u.sources[k].key == "alignment_mean") mean = E->contributions[k].in_native();
  const double theta = M_PI / 180.0;
  EXPECT_NEAR(mean / (1e6 * theta * theta / 6.0), 1.059, 0.001) << "over what lies between the extremes";
  EXPECT_GT(E->uncertainty.u.in_native(), mean);
}

TEST(MeanCosineError, HidesTravelThatTrialsGiveBack) {
  // The axis goes too far in proportion to the way; an instrument at θ shows cos θ of every length.
  constexpr double theta_deg = 0.5;
  const double shown = std::cos(theta_deg * M_PI / 180.0);
  const double truth_um = 30.0;
  const auto reading = [&](double P_mm) {
    const double true_mm = P_mm * (1.0 + truth_um * 1e-3 / 2000.0);
    return (true_mm * shown - P_mm) * 1e3;
  };
  const double far = reading(2000), middle = reading(1000);
  const Series series =
      testing_support::make_series({0, 1000, 2000}, std::vector<std::vector<double>>(3, {0, middle, far}), {});
  Metadata m;
  m.gum.distributions = {{"alignment", "normal 0.5 0.000001"}};
  MonteCarloOptions options;
  options.propagation.trials = 2000;
  options.contribution_trials = 0;
  const Evaluation evaluation = evaluate(series);
  const auto result = monte_carlo(axiometry::Test{m, series, {}}, evaluation, options);
  ASSERT_TRUE(result) << result.error().message;
  const std::size_t E_up = static_cast<std::size_t>(find_parameter("E_up") - parameters);
  EXPECT_LT(far, 0.0) << "too little is shown";
  EXPECT_NEAR((*result)->distributions[E_up]->summary.mean, truth_um, 0.01 * truth_um);
}

}  // namespace
}  // namespace axiometry::iso230_2
