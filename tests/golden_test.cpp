// SPDX-License-Identifier: Apache-2.0
//
// Validation against ISO 230-2:2014: Table 2 and Tables A.4 to A.7. The exact values come from an
// independent evaluation of the published readings and inputs; the printed ones are their roundings.
#include <gtest/gtest.h>

#include <cmath>

#include "axiometry/standards/iso230_2/assessment/assessment.h"
#include "tests/support/series.h"

namespace axiometry::iso230_2 {
namespace {

namespace table2 = testing_support::table2;

constexpr double exact = 1e-9;  // µm

using Member = std::optional<Deviation> PositionResult::*;

void expect_column(const std::vector<PositionResult>& positions, Member member, const std::vector<double>& expected) {
  ASSERT_EQ(positions.size(), expected.size());
  for (std::size_t i = 0; i < expected.size(); ++i) {
    ASSERT_TRUE(positions[i].*member) << i;
    EXPECT_NEAR((positions[i].*member)->in_native(), expected[i], exact) << "target " << i + 1;
  }
}

TEST(GoldenTable2, PositionsAreExact) {
  const auto positions = evaluate(table2::series()).positions;
  expect_column(positions, &PositionResult::mean_up,
                {-1.6, -0.7, -0.33999999999999997, -0.9399999999999998, -2.16, -3.34, -4.14, -4.279999999999999, -4.1,
                 -3.72, -3.96});
  expect_column(positions, &PositionResult::mean_down,
                {2.2600000000000002, 3.4199999999999995, 3.4200000000000004, 2.7800000000000002, 1.44, 0.24, -0.6,
                 -0.62, -0.2, -0.12000000000000002, -0.48});
  expect_column(
      positions, &PositionResult::mean,
      {0.33000000000000007, 1.3599999999999999, 1.5400000000000003, 0.9200000000000002, -0.3600000000000001,
       -1.5499999999999998, -2.3699999999999997, -2.4499999999999997, -2.15, -1.9200000000000002, -2.2199999999999998});
  expect_column(positions, &PositionResult::reversal,
                {-3.8600000000000003, -4.119999999999999, -3.7600000000000002, -3.72, -3.6, -3.58, -3.5399999999999996,
                 -3.6599999999999993, -3.8999999999999995, -3.6, -3.48});
  expect_column(positions, &PositionResult::s_up,
                {0.33166247903553997, 0.3535533905932738, 0.4505552130427524, 0.46151923036857306, 0.5549774770204643,
                 0.4159326868617086, 0.46151923036857284, 0.6300793600809343, 0.7382411530116699, 0.7463243262818117,
                 0.5683308895353127});
  expect_column(positions, &PositionResult::s_down,
                {0.33615472627943216, 0.2588435821108957, 0.2949576240750525, 0.3193743884534263, 0.38470768123342686,
                 0.4393176527297759, 0.4062019202317981, 0.4266145801540308, 0.5873670062235365, 0.5585696017507576,
                 0.6379655163094633});
  expect_column(positions, &PositionResult::R_up,
                {1.3266499161421599, 1.4142135623730951, 1.8022208521710097, 1.8460769214742923, 2.219909908081857,
                 1.6637307474468344, 1.8460769214742914, 2.5203174403237374, 2.9529646120466797, 2.9852973051272467,
                 2.273323558141251});
  expect_column(positions, &PositionResult::R_down,
                {1.3446189051177286, 1.0353743284435828, 1.17983049630021, 1.2774975538137052, 1.5388307249337074,
                 1.7572706109191036, 1.6248076809271923, 1.7064583206161232, 2.349468024894146, 2.2342784070030306,
                 2.551862065237853});
  expect_column(
      positions, &PositionResult::R,
      {5.195634410629944, 5.344793945408338, 5.25102567423561, 5.281787237643999, 5.479370316507783, 5.290500679182969,
       5.275442301200742, 5.7733878804699295, 6.551216318470413, 6.209787856065139, 5.892592811689552});
}

TEST(GoldenTable2, ParametersAreExact) {
  const AxisParameters p = evaluate(table2::series()).parameters;
  EXPECT_NEAR(p.A->in_native(), 9.586397554173445, exact);
  EXPECT_NEAR(p.A_up->in_native(), 6.137592732108844, exact);
  EXPECT_NEAR(p.A_down->in_native(), 5.765846280769032, exact);
  EXPECT_NEAR(p.E->in_native(), 7.699999999999999, exact);
  EXPECT_NEAR(p.E_up->in_native(), 3.9399999999999995, exact);
  EXPECT_NEAR(p.E_down->in_native(), 4.04, exact);
  EXPECT_NEAR(p.M->in_native(), 3.99, exact);
  EXPECT_NEAR(p.R->in_native(), 6.551216318470413, exact);
  EXPECT_NEAR(p.R_up->in_native(), 2.9852973051272467, exact);
  EXPECT_NEAR(p.R_down->in_native(), 2.551862065237853, exact);
  EXPECT_NEAR(p.B->in_native(), 4.119999999999999, exact);
  EXPECT_NEAR(p.B_mean->in_native(), -3.710909090909091, exact);
}

/// Inputs and results of one of Tables A.4 to A.7.
struct Example {
  const char* table;
  AnnexAInputs inputs;
  struct {
    double device, misalignment, m_machine, e_machine, e_device, eve, R_unidirectional, B, R, E, M, A;
  } U;
};

AnnexAInputs shared_inputs(double misalignment_mm, double difference_K, double range_K) {
  AnnexAInputs in;
  in.length = Length::mm(1751);
  in.misalignment = Length::mm(misalignment_mm);
  in.machine_expansion = ExpansionCoefficient::um_per_m_K(12);
  in.machine_temperature_difference = TemperatureDifference::kelvin(difference_K);
  in.machine_temperature_range = TemperatureDifference::kelvin(range_K);
  in.machine_expansion_range = ExpansionCoefficient::um_per_m_K(2);
  in.environmental_variation = Deviation::native(1.7);
  return in;
}

std::vector<Example> examples() {
  std::vector<Example> list;
  list.push_back({"A.4",
                  shared_inputs(4, 5, 0.7),
                  {3.57204, 2.741290691033695, 8.825039999999998, 10.506, 0.0, 1.02, 2.04, 0.918, 2.244,
                   14.447823068405425, 14.444222077216478, 14.591134000342398}});
  list.back().inputs.device_error_range = RelativeLength::um_per_m(3.4);
  list.push_back({"A.5",
                  shared_inputs(1, 1, 0.2),
                  {1.751, 0.17133066818960593, 2.5214399999999997, 2.1012, 0.0, 1.02, 2.04, 0.918, 2.244,
                   3.7518177343072376, 3.7379267397131115, 4.27056627526869}});
  list.back().inputs.device_calibration_per_length = RelativeLength::um_per_m(1.0);
  list.push_back({"A.6",
                  shared_inputs(0.5, 5, 0.1),
                  {2.1012, 0.04283266704740148, 1.2607199999999998, 10.506, 10.506, 1.02, 2.04, 0.918, 2.244,
                   15.065405503861035, 15.061952164170698, 15.202895875318173}});
  list.back().inputs.device_error_range = RelativeLength::um_per_m(2.0);
  list.back().inputs.device_temperature_difference = TemperatureDifference::kelvin(5);
  list.back().inputs.device_expansion_range = ExpansionCoefficient::um_per_m_K(2);
  list.push_back({"A.7",
                  shared_inputs(0.5, 1, 0.05),
                  {1.8, 0.04283266704740148, 0.6303599999999999, 2.1012, 2.1012, 1.02, 2.04, 0.918, 2.244,
                   3.5605268215485184, 3.545886524829354, 4.1035291210086955}});
  list.back().inputs.device_calibration = Deviation::native(1.8);
  list.back().inputs.device_temperature_difference = TemperatureDifference::kelvin(1);
  list.back().inputs.device_expansion_range = ExpansionCoefficient::um_per_m_K(2);
  return list;
}

double U_of(const AnnexA& annex, std::string_view key) {
  for (const Contributor& row : annex.budget)
    if (row.key == key) return row.U ? row.U->in_native() : 0.0;
  ADD_FAILURE() << "no contributor " << key;
  return NAN;
}

TEST(GoldenAnnexA, TablesA4ToA7AreExact) {
  for (const Example& example : examples()) {
    SCOPED_TRACE(example.table);
    Metadata metadata;
    metadata.uncertainty = example.inputs;
    const Series series = table2::series();
    const auto annex = annex_a(metadata, series, evaluate(series));
    ASSERT_TRUE(annex);
    EXPECT_NEAR(U_of(*annex, "device"), example.U.device, exact);
    EXPECT_NEAR(U_of(*annex, "misalignment"), example.U.misalignment, exact);
    EXPECT_NEAR(U_of(*annex, "m_machine"), example.U.m_machine, exact);
    EXPECT_NEAR(U_of(*annex, "m_device"), 0.0, exact);
    EXPECT_NEAR(U_of(*annex, "e_machine"), example.U.e_machine, exact);
    EXPECT_NEAR(U_of(*annex, "e_device"), example.U.e_device, exact);
    EXPECT_NEAR(U_of(*annex, "eve"), example.U.eve, exact);
    for (auto member : {&AxisParameters::R_up, &AxisParameters::R_down})
      EXPECT_NEAR((annex->U.*member)->in_native(), example.U.R_unidirectional, exact);
    for (auto member : {&AxisParameters::B, &AxisParameters::B_mean})
      EXPECT_NEAR((annex->U.*member)->in_native(), example.U.B, exact);
    EXPECT_NEAR(annex->U.R->in_native(), example.U.R, exact);
    for (auto member : {&AxisParameters::E, &AxisParameters::E_up, &AxisParameters::E_down})
      EXPECT_NEAR((annex->U.*member)->in_native(), example.U.E, exact);
    EXPECT_NEAR(annex->U.M->in_native(), example.U.M, exact);
    for (auto member : {&AxisParameters::A, &AxisParameters::A_up, &AxisParameters::A_down})
      EXPECT_NEAR((annex->U.*member)->in_native(), example.U.A, exact);
  }
}

TEST(GoldenTable2, WithEveryItemOfTheReportIsConforming) {
  const Assessment assessment = assess(table2::complete_test());
  EXPECT_TRUE(assessment.conforming());
  for (const Finding& f : assessment.findings) EXPECT_EQ(f.severity, Severity::note) << f.clause << ": " << f.message;
  EXPECT_EQ(assessment.label, "");
}

}  // namespace
}  // namespace axiometry::iso230_2
