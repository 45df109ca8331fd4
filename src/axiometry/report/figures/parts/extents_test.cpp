// SPDX-License-Identifier: Apache-2.0
#include "axiometry/report/figures/parts/extents.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include "axiometry/report/figures/figures_test_support.h"

namespace axiometry::report::plot {
namespace {

using iso230_2::AxisParameters;
using testing::drawn_from;
using testing::evenly;

void expect_extents_equal_parameters(const iso230_2::Evaluation& evaluation) {
  for (const iso230_2::ParameterInfo& parameter : iso230_2::parameters) {
    const auto span = extent(evaluation, parameter.member);
    const auto value = evaluation.parameters.*parameter.member;
    if (parameter.member == &AxisParameters::B_mean) {
      EXPECT_FALSE(span.has_value());
      continue;
    }
    ASSERT_EQ(span.has_value(), value.has_value()) << parameter.key;
    if (!span) continue;
    const double tolerance = 1e-9 * std::max(1.0, std::abs(value->in_native()));
    EXPECT_NEAR(span->high.in_native() - span->low.in_native(), value->in_native(), tolerance) << parameter.key;
  }
}

TEST(Extents, EqualTheParametersOfTheWorkedExample) {
  const auto example = testing::table_2();
  expect_extents_equal_parameters(example.assessment.evaluation);
}

TEST(Extents, EqualTheParametersInEveryCrowdedCase) {
  for (const auto& c : testing::crowded_cases()) {
    SCOPED_TRACE(c.name);
    expect_extents_equal_parameters(c.drawn.assessment.evaluation);
  }
}

TEST(Extents, LieWhereTheWorkedExampleAttainsThem) {
  const auto example = testing::table_2();
  const auto& evaluation = example.assessment.evaluation;
  const auto B = extent(evaluation, &AxisParameters::B);
  EXPECT_EQ(B->high_at, 1u);
  EXPECT_EQ(B->low_at, 1u);
  EXPECT_DOUBLE_EQ(B->high.in_native(), evaluation.positions[1].mean_down->in_native());
  EXPECT_DOUBLE_EQ(B->low.in_native(), evaluation.positions[1].mean_up->in_native());
  EXPECT_EQ(extent(evaluation, &AxisParameters::R)->high_at, 8u);
  EXPECT_EQ(extent(evaluation, &AxisParameters::E)->low_at, 7u);
  EXPECT_EQ(extent(evaluation, &AxisParameters::A)->high_at, 2u);
}

TEST(Extents, OfRCoverOneBandWhenThatIsWiderThanBothMeansWithTheirHalves) {
  // ↑ scatters widely, ↓ not at all, and the means are equal: R = 4 s↑.
  const auto one_wide = drawn_from({0, 100}, 2, [](std::size_t, Direction direction, std::size_t j) {
    return direction == Direction::down ? 0.0 : j == 0 ? -1.0 : 1.0;
  });
  const auto& evaluation = one_wide.assessment.evaluation;
  const auto R = extent(evaluation, &AxisParameters::R);
  EXPECT_NEAR(R->high.in_native(), 2.0 * std::sqrt(2.0), 1e-12);
  EXPECT_NEAR(R->low.in_native(), -2.0 * std::sqrt(2.0), 1e-12);
}

RC_GTEST_PROP(Extents, EqualTheParametersOfAnySeries, ()) {
  const auto m = *rc::gen::inRange<std::size_t>(2, 12);
  const auto n = *rc::gen::inRange<std::size_t>(1, 6);
  const auto cells = *rc::gen::container<std::vector<int>>(2 * m * n, rc::gen::inRange(-1000, 1000));
  const auto any = drawn_from(evenly(0, 1000, m), n, [&](std::size_t i, Direction direction, std::size_t j) {
    const int cell = cells[(static_cast<std::size_t>(direction) * m + i) * n + j];
    const bool keep = j == i % n || cell % 3 != 0;  // every target has a reading
    return keep ? 0.01 * cell : std::nan("");
  });
  expect_extents_equal_parameters(any.assessment.evaluation);
}

}  // namespace
}  // namespace axiometry::report::plot
