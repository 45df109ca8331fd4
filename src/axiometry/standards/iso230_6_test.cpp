// SPDX-License-Identifier: Apache-2.0
#include "axiometry/standards/iso230_6.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/support/series.h"

namespace axiometry::iso230_6 {
namespace {

using testing::ElementsAre;

constexpr TravelBox box{{-100, 0, -600}, {900, 500, -200}};

std::vector<std::string> ids(const std::vector<Diagonal>& diagonals) {
  std::vector<std::string> result;
  for (const Diagonal& diagonal : diagonals) result.push_back(diagonal.id);
  return result;
}

TEST(Iso2306, NamesTheDiagonalsByTheSignsOfTheirEnds) {
  EXPECT_THAT(ids(body_diagonals(box)), ElementsAre("NNN-PPP", "NNP-PPN", "NPN-PNP", "NPP-PNN"));
  EXPECT_THAT(ids(face_diagonals(box)), ElementsAre("NN0-PP0", "NP0-PN0", "N0N-P0P", "N0P-P0N", "0NN-0PP", "0NP-0PN"));
}

TEST(Iso2306, BodyDiagonalsJoinOppositeCorners) {
  const auto all = body_diagonals(box);
  EXPECT_EQ(all[0].begin_mm, box.lowest_mm);
  EXPECT_EQ(all[0].end_mm, box.highest_mm);
  EXPECT_EQ(all[2].begin_mm, (Vector3{-100, 500, -600}));
  EXPECT_EQ(all[2].end_mm, (Vector3{900, 0, -200}));
  for (const Diagonal& diagonal : all) {
    EXPECT_EQ(diagonal.begin_mm + diagonal.end_mm, box.lowest_mm + box.highest_mm) << diagonal.id;
    EXPECT_LT(diagonal.begin_mm.x, diagonal.end_mm.x) << diagonal.id;
    for (std::size_t k = 0; k < 3; ++k)
      EXPECT_EQ(diagonal.begin_mm[k] == box.highest_mm[k], diagonal.id[k] == 'P') << diagonal.id;
  }
}

TEST(Iso2306, FaceDiagonalsLeaveOneAxisInTheMiddleOfItsTravel) {
  for (const Diagonal& diagonal : face_diagonals(box))
    for (std::size_t k = 0; k < 3; ++k) {
      const double middle = (box.lowest_mm[k] + box.highest_mm[k]) / 2.0;
      EXPECT_EQ(diagonal.begin_mm[k] == middle, diagonal.id[k] == '0') << diagonal.id;
      EXPECT_EQ(diagonal.end_mm[k] == middle, diagonal.id[k] == '0') << diagonal.id;
      EXPECT_EQ(diagonal.end_mm[k] == box.highest_mm[k], diagonal.id[4 + k] == 'P') << diagonal.id;
    }
  EXPECT_EQ(face_diagonals(box)[5].begin_mm, (Vector3{400, 0, -200}));
}

TEST(Iso2306, TellsTheLargestOfEachParameterAndWhichDiagonalHasIt) {
  const auto first = iso230_2::evaluate(testing_support::make_series({0, 100}, {{0, 9}, {1, 8}}, {{3, 11}, {3, 11}}));
  const auto second = iso230_2::evaluate(testing_support::make_series({0, 100}, {{0, 2}, {4, 2}}, {{3, 7}, {3, 7}}));
  const NamedEvaluation set[] = {{"NNN-PPP", first}, {"NNP-PPN", second}};
  const DiagonalSummary summary = summarise(set);
  EXPECT_EQ(summary.E->id, "NNN-PPP");
  EXPECT_DOUBLE_EQ(summary.E->value.in_native(), 10.5);  // 11 − 0.5
  EXPECT_EQ(summary.R->id, "NNP-PPN");
  EXPECT_DOUBLE_EQ(summary.R->value.in_native(), second.parameters.R->in_native());
  EXPECT_EQ(summary.B->id, "NNP-PPN");
  EXPECT_DOUBLE_EQ(summary.B->value.in_native(), 5.0);
}

TEST(Iso2306, LeavesOutWhatNoDiagonalHas) {
  const auto up_only = iso230_2::evaluate(testing_support::make_series({0, 100}, {{0, 1}, {9, 8}}, {}));
  const NamedEvaluation set[] = {{"NNN-PPP", up_only}};
  EXPECT_FALSE(summarise(set).E);
  EXPECT_FALSE(summarise(set).R);
  EXPECT_FALSE(summarise(set).B);
  EXPECT_FALSE(summarise({}).E);
}

}  // namespace
}  // namespace axiometry::iso230_6
