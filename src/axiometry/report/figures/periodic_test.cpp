// SPDX-License-Identifier: Apache-2.0
#include "axiometry/report/periodic.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

#include "axiometry/report/figures/figure_rules_test_support.h"
#include "tests/support/document_parts.h"
#include "tests/support/series.h"

namespace axiometry::report {
namespace {

using testing::all_words;
using ::testing::Contains;
using ::testing::ElementsAre;
using testing::expect_golden;
using testing::fault_of;
using ::testing::HasSubstr;
using ::testing::Not;

/// Scatter without a random number: −1 to 1, the same on every machine.
double scatter(std::size_t k) { return (static_cast<double>((k * 7919 + 31) % 101) - 50.0) / 50.0; }

struct Shape {
  std::string name;
  std::size_t count = 41;
  double step = 1.0;
  double first = 0.0;
  double period = 10.0;
  double amplitude = 1.5;
  double noise = 0.2;
  double slope = 0.02;
  AxisKind kind = AxisKind::linear;
  bool both = false;
};

axiometry::Test made(const Shape& shape) {
  std::vector<double> targets;
  std::vector<testing_support::RunDeviations> up(2), down;
  for (std::size_t k = 0; k < shape.count; ++k) {
    const double x = shape.first + shape.step * (static_cast<double>(k) + 0.3 * scatter(k + 7));
    targets.push_back(x);
    for (std::size_t j = 0; j < 2; ++j)
      up[j].push_back(shape.slope * (x - shape.first) +
                      shape.amplitude * std::sin(6.283185307179586 * x / shape.period) +
                      shape.noise * scatter(3 * k + 5 * j));
  }
  if (shape.both) down = {up[1]};
  axiometry::Test test{{}, testing_support::make_series(targets, up, down), {}};
  test.metadata.axis.name = shape.kind == AxisKind::linear ? "X" : "C";
  test.metadata.axis.kind = shape.kind;
  if (!shape.both) test.metadata.conditions.cycle = TestCycle::unidirectional;
  return test;
}

const Shape shapes[] = {
    {.name = "periodic_screw"},
    {.name = "periodic_rotary", .count = 120, .step = 3.0, .period = 45.0, .kind = AxisKind::rotary},
    {.name = "periodic_scale",
     .count = 200,
     .step = 0.001,
     .first = 250.0,
     .period = 0.02,
     .amplitude = 0.05,
     .noise = 0.01,
     .slope = 0.0},
    {.name = "periodic_long", .count = 1200, .step = 1.1, .first = -600.0, .amplitude = 3.0, .noise = 2.0},
    {.name = "periodic_few", .count = 8, .step = 2.5},
    {.name = "periodic_huge", .count = 60, .step = 1e6, .period = 1e7, .amplitude = 1e8, .noise = 1e6},
    {.name = "periodic_steep", .slope = 300.0},
    {.name = "periodic_both", .both = true},
};

TEST(PeriodicFigures, KeepTheirBoxAndTheirTextsApart) {
  for (const Shape& shape : shapes) {
    const auto test = made(shape);
    auto result = iso230_2::periodic_error(test);
    ASSERT_TRUE(result) << shape.name << ' ' << result.error().message;
    for (const char* label : {"", "step cycle (Annex B), not for acceptance"}) {
      result->label = label;
      const auto figures = periodic_figures({test, *result}, {});
      EXPECT_EQ(figures.size(), shape.both ? 8u : 4u);
      for (const Figure& figure : figures) EXPECT_EQ(fault_of(figure), "") << shape.name << ' ' << figure.title;
    }
  }
}

TEST(PeriodicFigures, OfAScrewAreTheGoldenOnes) {
  const auto test = made(shapes[0]);
  const auto result = iso230_2::periodic_error(test, {.period = Position::native(10)}).value();
  const auto figures = periodic_figures({test, result}, {});
  const char* names[] = {"periodic_deviations", "periodic_residuals", "periodic_folded", "periodic_spectrum"};
  for (std::size_t k = 0; k < 4; ++k) expect_golden(figures[k], names[k]);
}

TEST(PeriodicFigures, OfAFlatSeriesCanBeDrawn) {
  std::vector<double> targets;
  for (int k = 0; k < 20; ++k) targets.push_back(k);
  axiometry::Test test{{}, testing_support::make_series(targets, {testing_support::RunDeviations(20, 0.0)}, {}), {}};
  const auto result = iso230_2::periodic_error(test).value();
  for (const Figure& figure : periodic_figures({test, result}, {})) EXPECT_EQ(fault_of(figure), "") << figure.title;
}

TEST(PeriodicFigures, ShowDegreesAndArcsecondsOfARotaryAxis) {
  const auto test = made(shapes[1]);
  const auto result = iso230_2::periodic_error(test).value();
  const auto figures = periodic_figures({test, result}, {});
  EXPECT_THAT(all_words(figures[0]), Contains("Deviation / ″"));
  EXPECT_THAT(all_words(figures[3]), Contains("Period / °"));
}

TEST(PeriodicFigures, OfVeryManyTargetsShowBandsAndNoLinesAcrossThePeriod) {
  const auto test = made({.name = "many", .count = 20'500, .step = 0.01});
  const auto result = iso230_2::periodic_error(test, {.period = Position::native(10)}).value();
  const auto figures = periodic_figures({test, result}, {});
  for (const std::size_t k : {1u, 2u}) {
    EXPECT_EQ(fault_of(figures[k]), "");
    EXPECT_THAT(all_words(figures[k]), Contains(HasSubstr("central 95 %")));
    EXPECT_LT(figures[k].operations.size(), 1000u);
  }
}

TEST(PeriodicDocument, SaysWhatWasFoundAndWhatWasNot) {
  const auto test = made(shapes[0]);
  const auto result = iso230_2::periodic_error(test).value();
  const Document document = compose({test, result}, {});
  EXPECT_EQ(document.kind, "Periodic positioning error");
  EXPECT_EQ(document.title, "Periodic positioning error of axis X");
  EXPECT_THAT(testing_support::section_ids(document),
              ElementsAre("results", "figures", "findings", "identification", "method", "provenance", "release"));
  EXPECT_THAT(plain_text(document.status[1].heading), HasSubstr("peak to valley"));
  const auto tables = testing_support::tables(document.sections.front());
  ASSERT_EQ(tables.size(), 2u);
  EXPECT_EQ(plain_text(tables[0].rows[0][0].text), "Period, found");
  EXPECT_EQ(tables[1].rows.size(), result.directions[0].harmonics.size());

  const auto noise_only = made({.name = "noise", .amplitude = 0.0, .slope = 0.0});
  const auto nothing = iso230_2::periodic_error(noise_only).value();
  if (!nothing.directions[0].significant) {
    EXPECT_THAT(plain_text(compose({noise_only, nothing}, {}).status[1].heading), HasSubstr("No significant"));
  }
}

TEST(PeriodicDocument, NeverPassesForATestThatKeepsToTheAnnex) {
  const auto test = made({.name = "short", .count = 14});
  const auto result = iso230_2::periodic_error(test, {.period = Position::native(10)}).value();
  ASSERT_FALSE(result.conforming());
  const Document document = compose({test, result}, {});
  EXPECT_EQ(document.status[0].tone, Tone::bad);
  EXPECT_EQ(document.edition, "departs from ISO 230-2:2014, Annex C");
}

TEST(PeriodicRows, EndAtThePlaceOfTheirUncertainty) {
  const auto test = made(shapes[0]);
  const auto result = iso230_2::periodic_error(test).value();
  for (const PeriodicRow& row : periodic_rows(result.directions[0], AxisKind::linear, {})) {
    if (row.U.empty()) continue;
    EXPECT_EQ(fraction_length(row.value), fraction_length(row.U)) << row.title;
  }
}

}  // namespace
}  // namespace axiometry::report
