// SPDX-License-Identifier: Apache-2.0
#include "axiometry/report/figures/error_motions.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>

#include "axiometry/report/figures/figure_rules_test_support.h"
#include "axiometry/report/figures/tracking/volumetric_residuals.h"
#include "axiometry/volumetric/known_machine_test_support.h"

namespace axiometry::report {
namespace {

using testing::all_words;
using ::testing::Contains;
using testing::fault_of;
using ::testing::HasSubstr;
using ::testing::Not;
using volumetric::testing::known_identification;
using volumetric::testing::known_lengths;
using volumetric::testing::known_machine;

TEST(ErrorMotionFigure, ShowsSixErrorsOfAnAxisInBothLanguagesWithoutOverlap) {
  const auto found = known_identification(known_machine());
  for (const auto language : {language::Language::english, language::Language::german})
    for (std::size_t a = 0; a < 3; ++a) {
      Options options;
      options.language = language;
      const Figure figure = error_motion_figure(found.model, a, options);
      EXPECT_EQ(fault_of(figure), "");
      EXPECT_THAT(all_words(figure), Not(Contains(HasSubstr("not told"))));
      for (std::size_t m = 0; m < 6; ++m)
        EXPECT_THAT(all_words(figure), Contains(HasSubstr(volumetric::error_name({a, m}))));
    }
}

TEST(ErrorMotionFigure, SaysOfAnErrorThatTheLengthsDoNotTell) {
  auto machine = known_machine("FXYZ");
  machine.tools.pop_back();
  const Figure figure = error_motion_figure(known_identification(machine).model, 2, {});
  EXPECT_EQ(fault_of(figure), "");
  EXPECT_EQ(std::ranges::count(all_words(figure), "not told"), 1);  // ECZ, the roll about the line of both tools
}

TEST(VolumetricResidualFigure, NamesEveryStationWithEveryToolAndMarksWhatWasSetAside) {
  const auto machine = known_machine();
  auto lengths = known_lengths(machine, 60);
  lengths.readings[100].length_mm += 0.5;
  const auto found = volumetric::identify(machine, lengths, {});
  ASSERT_TRUE(found) << found.error().to_string();
  const Figure figure = volumetric_residual_figure(lengths, *found, {});
  EXPECT_EQ(fault_of(figure), "");
  EXPECT_THAT(all_words(figure), Contains("S3 T2"));
  EXPECT_THAT(all_words(figure), Contains(HasSubstr("set aside")));
}

TEST(VolumetricResidualFigure, OfManyReadingsShowsWhereMostOfThemAre) {
  const auto machine = known_machine();
  const auto lengths = known_lengths(machine, 600);
  const auto found = volumetric::identify(machine, lengths, {});
  ASSERT_TRUE(found) << found.error().to_string();
  const Figure figure = volumetric_residual_figure(lengths, *found, {});
  EXPECT_EQ(fault_of(figure), "");
  std::size_t dots = 0;
  for (const Operation& operation : figure.operations) dots += std::holds_alternative<Disc>(operation) ? 1 : 0;
  EXPECT_LT(dots, 4 * 1600U);
  EXPECT_THAT(all_words(figure), Contains(HasSubstr("central 95 %")));
  const auto is_band = [](const Operation& operation) {
    const Path* path = std::get_if<Path>(&operation);
    return path && path->closed && path->stroke.width == 0.0 && path->fill.b > path->fill.r && path->points.size() > 3;
  };
  EXPECT_GE(std::ranges::count_if(figure.operations, is_band), 4);  // in the order of measurement, over X, Y and Z
}

}  // namespace
}  // namespace axiometry::report
