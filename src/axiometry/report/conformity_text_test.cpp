// SPDX-License-Identifier: Apache-2.0
#include "axiometry/report/conformity_text.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <iterator>

#include "axiometry/standards/iso230_2/rules/uncertainty_findings.h"
#include "axiometry/standards/iso230_2/verdict/tolerance.h"
#include "tests/support/series.h"

namespace axiometry::report {
namespace {

using ::testing::HasSubstr;
using ::testing::IsEmpty;

/// Three runs that scatter by 1 µm, R is about 6 µm.
std::string statement_of(double variation_um, std::string_view parameter, double limit_um) {
  const std::vector<testing_support::RunDeviations> runs = {{0, 1, 3}, {1, 0, 2}, {0.2, 2, 2.5}};
  axiometry::Test test{{}, testing_support::make_series({0, 480, 1000}, runs, runs), {}};
  test.metadata.uncertainty.environmental_variation = Deviation::native(variation_um);
  iso230_2::Assessment assessment = iso230_2::assess(test);
  std::ranges::move(iso230_2::uncertainty_findings(test, assessment), std::back_inserter(assessment.findings));
  const iso230_2::Tolerance limit{iso230_2::find_parameter(parameter), Deviation::native(limit_um)};
  const auto judgements = iso230_2::judge(assessment.evaluation.parameters, std::span(&limit, 1),
                                          {.kind = uncertainty::DecisionRule::Kind::iso_14253_1},
                                          {iso230_2::uncertainties_of_record(assessment)});
  return noise_statement(judgements, assessment);
}

TEST(ConformityText, SaysWhereNoiseMayHaveMovedAOrRBeyondALimit) {
  EXPECT_THAT(statement_of(2.1, "R", 2.0), HasSubstr("A limit that R seems to exceed may be kept"));
  EXPECT_THAT(statement_of(2.1, "A_up", 2.5), HasSubstr("A limit that A↑ seems to exceed may be kept"));
  EXPECT_THAT(statement_of(2.1, "A_up", 2.0), IsEmpty()) << "E↑ is 2.1: means alone exceed it";
  EXPECT_THAT(statement_of(2.1, "R", 20.0), IsEmpty()) << "it is kept as it is";
  EXPECT_THAT(statement_of(2.1, "E", 0.5), IsEmpty()) << "means move little";
  EXPECT_THAT(statement_of(1.0, "R", 2.0), IsEmpty()) << "noise is small";
}

}  // namespace
}  // namespace axiometry::report
