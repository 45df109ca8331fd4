// SPDX-License-Identifier: Apache-2.0
#include "axiometry/report/figures/tracking/length_difference.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <numbers>

#include "axiometry/report/figures/figure_rules_test_support.h"

namespace axiometry::report {
namespace {

using testing::all_words;
using ::testing::Contains;
using testing::expect_golden;
using testing::fault_of;
using ::testing::Not;

const std::vector<double> distances = {10,  20,  30,  40,  50,  60,  70,  80,  90,   100,
                                       200, 300, 400, 500, 600, 700, 800, 900, 1000, 1100};

/// Eqs 18 and 19 written anew for errors along and across a line, mm.
struct Across {
  double along, across;
  double alpha_deg(double d) const { return std::atan2(across, along + d) * 180.0 / std::numbers::pi; }
  double excess_um(double d) const { return 1000.0 * (std::hypot(along + d, across) - (along + d)); }
  double difference_um(double d) const { return excess_um(d) - excess_um(distances.back()); }
};
const std::vector<std::pair<std::string, Across>> lines = {{"x", {0.7978, std::hypot(0.2715, 0.1965)}},
                                                           {"y", {0.2715, std::hypot(0.7978, 0.1965)}},
                                                           {"z", {0.1965, std::hypot(0.7978, 0.2715)}}};

template <typename Value>
DistanceSubject subject_of(const Value& value) {
  DistanceSubject subject{.distances_mm = distances, .curves = {}, .title = "Figure", .description = "Curves."};
  for (const auto& [label, line] : lines) {
    subject.curves.push_back({label, {}});
    for (double d : distances) subject.curves.back().values.push_back(value(line, d));
  }
  return subject;
}

DistanceSubject angles() {
  return subject_of([](const Across& line, double d) { return line.alpha_deg(d); });
}
DistanceSubject differences() {
  return subject_of([](const Across& line, double d) { return line.difference_um(d); });
}

TEST(LengthDifferenceFigures, OfThePaperAreTheGoldenOnes) {
  const Figure angle = station_angle_figure(angles(), {});
  EXPECT_EQ(fault_of(angle), "");
  expect_golden(angle, "length_difference_angle");
  const Figure difference = length_difference_figure(differences(), RangingUncertainty{}, {});
  EXPECT_EQ(fault_of(difference), "");
  expect_golden(difference, "length_difference");
}

TEST(LengthDifferenceFigures, CompareWithTheInstrumentOnlyWhereItIsKnown) {
  EXPECT_THAT(all_words(length_difference_figure(differences(), RangingUncertainty{}, {})),
              Contains("U of the instrument"));
  EXPECT_THAT(all_words(length_difference_figure(differences(), {}, {})), Not(Contains("U of the instrument")));
}

TEST(LengthDifferenceFigures, KeepTheirBoxForAnyValues) {
  const double nan = std::numeric_limits<double>::quiet_NaN(), inf = std::numeric_limits<double>::infinity();
  const std::vector<double> some = {10, 100, 1000};
  const std::vector<double> odd = {-5, 0, 100};
  std::vector<DistanceSubject> subjects;
  subjects.push_back({});
  subjects.push_back({.distances_mm = some, .curves = {{"zero", {0, 0, 0}}}});
  subjects.push_back({.distances_mm = some, .curves = {{"gap", {1, nan, 3}}, {"far", {inf, -inf, 1e300}}}});
  subjects.push_back({.distances_mm = some, .curves = {{"few", {1}}, {"many", {1, -2, 3, 4, 5}}}});
  subjects.push_back({.distances_mm = odd, .curves = {{"odd", {1, 2, 3}}}});
  subjects.push_back({.distances_mm = some, .curves = {{"tiny", {1e-9, 2e-9, 0}}, {"huge", {1e9, 1e3, 0}}}});
  subjects.push_back({.distances_mm = some, .curves = {{std::string(400, 'W'), {1, 2, 3}}}});
  for (std::size_t k = 0; k < subjects.size(); ++k) {
    EXPECT_EQ(fault_of(station_angle_figure(subjects[k], {})), "") << k;
    EXPECT_EQ(fault_of(length_difference_figure(subjects[k], RangingUncertainty{}, {})), "") << k;
  }
}

TEST(LengthDifferenceFigures, UseTheDecimalMarkOfTheOptions) {
  Options options;
  options.numbers.decimal_mark = ',';
  EXPECT_THAT(all_words(station_angle_figure(angles(), options)), Contains("0,5"));
}

}  // namespace
}  // namespace axiometry::report
