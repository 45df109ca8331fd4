// SPDX-License-Identifier: Apache-2.0
#include "axiometry/report/shown_targets.h"

#include <gtest/gtest.h>

#include <algorithm>

namespace axiometry::report {
namespace {

/// Results of so many targets, all the same but for what the test changes.
iso230_2::Evaluation results_of(std::size_t count) {
  iso230_2::Evaluation evaluation;
  evaluation.positions.resize(count);
  for (std::size_t i = 0; i < count; ++i) {
    auto& p = evaluation.positions[i];
    p.target = Position::native(double(i));
    for (auto member :
         {&iso230_2::PositionResult::mean_up, &iso230_2::PositionResult::mean_down, &iso230_2::PositionResult::mean,
          &iso230_2::PositionResult::reversal, &iso230_2::PositionResult::s_up, &iso230_2::PositionResult::s_down,
          &iso230_2::PositionResult::R_up, &iso230_2::PositionResult::R_down, &iso230_2::PositionResult::R})
      p.*member = Deviation::native(1.0);
  }
  return evaluation;
}

bool stands(const ShownTargets& shown, std::size_t place) {
  return std::ranges::find(shown.places, place) != shown.places.end();
}

TEST(ShownTargets, AreAllOfAsManyAsAReportCanHold) {
  for (std::size_t count : {0u, 1u, 11u, 1000u}) {
    const ShownTargets shown = shown_targets(results_of(count));
    EXPECT_EQ(shown.places.size(), count);
    EXPECT_FALSE(shown.note);
  }
}

TEST(ShownTargets, AreAboutFiveHundredOfMore) {
  for (std::size_t count : {1001u, 5000u, 20000u, 123457u}) {
    const ShownTargets shown = shown_targets(results_of(count));
    EXPECT_GT(shown.places.size(), 300u) << count;
    EXPECT_LT(shown.places.size(), 510u) << count;
    EXPECT_EQ(shown.places.front(), 0u);
    EXPECT_EQ(shown.places.back(), count - 1);
    EXPECT_TRUE(std::ranges::is_sorted(shown.places, std::ranges::less_equal{}));
    ASSERT_TRUE(shown.note);
  }
  EXPECT_EQ(*shown_targets(results_of(20000)).note,
            "One target in 40 of 20000 stands here, with the first, the last and those at which a result of clause 3 "
            "is the lowest or the highest; CSV and JSON have these results of all targets, the file of the test has "
            "all readings");
}

/// What the note says of extremes, of each result in turn; no place is a multiple of the step.
TEST(ShownTargets, HoldThoseAtWhichAResultIsLowestOrHighest) {
  using Member = std::optional<Deviation> iso230_2::PositionResult::*;
  using P = iso230_2::PositionResult;
  for (Member member :
       {&P::mean_up, &P::mean_down, &P::mean, &P::reversal, &P::s_up, &P::s_down, &P::R_up, &P::R_down, &P::R}) {
    iso230_2::Evaluation evaluation = results_of(20000);
    evaluation.positions[12345].*member = Deviation::native(0.5);
    evaluation.positions[777].*member = Deviation::native(1.5);
    const ShownTargets shown = shown_targets(evaluation);
    EXPECT_TRUE(stands(shown, 12345));
    EXPECT_TRUE(stands(shown, 777));
  }
}

/// A follows from mean ± 2s, which neither mean nor s need have their own extremes for.
TEST(ShownTargets, HoldThoseOfTheBoundaries) {
  iso230_2::Evaluation evaluation = results_of(20000);
  evaluation.positions[1].mean_down = Deviation::native(9.0);  // highest mean
  evaluation.positions[1].s_down = Deviation::native(0.1);
  evaluation.positions[2].s_down = Deviation::native(3.0);  // largest s
  evaluation.positions[3].mean_down = Deviation::native(8.0);
  evaluation.positions[3].s_down = Deviation::native(2.0);  // highest boundary
  EXPECT_TRUE(stands(shown_targets(evaluation), 3));
}

}  // namespace
}  // namespace axiometry::report
