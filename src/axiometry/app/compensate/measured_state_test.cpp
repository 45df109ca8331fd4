// SPDX-License-Identifier: Apache-2.0
//
// What a test says of itself that speaks against a table of its readings.
#include "axiometry/app/compensate/measured_state.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <string>
#include <utility>
#include <vector>

#include "axiometry/app/compensate/compensate.h"
#include "axiometry/language/language.h"
#include "axiometry/model/swapped_labels.h"
#include "tests/support/series.h"

namespace axiometry::app {
namespace {

using StatedRuns = std::vector<testing_support::RunDeviations>;

/// 40 µm/m over 400 mm, ↓ 4 µm below ↑, a little scatter that differs with `seed`.
NamedTest stated_axis(int seed = 0) {
  StatedRuns up, down;
  for (int j = 0; j < 5; ++j) {
    testing_support::RunDeviations run_up, run_down;
    for (int i = 0; i < 5; ++i) {
      run_up.push_back(4.0 * i + 0.1 * ((3 * i + 2 * j + seed) % 5));
      run_down.push_back(4.0 * i - 4.0 + 0.1 * ((2 * i + j + seed) % 5));
    }
    up.push_back(run_up);
    down.push_back(run_down);
  }
  axiometry::Test test{{}, testing_support::make_series({0, 110, 190, 310, 400}, up, down), {}};
  test.metadata.axis.name = "X";
  return {"x.csv", std::move(test)};
}

void expect_in_both_languages(const std::string& message) {
  for (const auto other : {language::Language::german, language::Language::french})
    EXPECT_TRUE(language::is_known(message, other)) << message;
}

/// The serious findings of the table that is made.
std::vector<std::string> serious_ids(NamedTest test, std::optional<NamedTable> existing = {}) {
  const auto made = compensate({std::move(test), std::move(existing)}, {.control = "linuxcnc"});
  EXPECT_TRUE(made) << made.error().message;
  std::vector<std::string> ids;
  if (!made) return ids;
  for (const NamedFinding& finding : made->findings) {
    expect_in_both_languages(finding.message);
    if (finding.serious) ids.push_back(finding.id);
  }
  return ids;
}

void expect_refused(NamedTest test, const std::string& part) {
  const auto made = compensate({std::move(test)}, {.control = "linuxcnc"});
  ASSERT_FALSE(made) << part;
  EXPECT_NE(made.error().message.find(part), std::string::npos) << made.error().message;
  expect_in_both_languages(made.error().message);
}

TEST(MeasuredState, AReversedSignMakesNoTable) {
  NamedTest axis = stated_axis();
  axis.test.metadata.instrument.sign_reversed = true;
  expect_refused(axis, "the correction of the sign");
  EvaluateOptions options;
  options.corrections.sign = true;
  auto corrected = prepare_test(axis.test, options);
  ASSERT_TRUE(corrected) << corrected.error().message;
  EXPECT_TRUE(serious_ids({"x.csv", *corrected}).empty()) << "what is named mends it";
}

TEST(MeasuredState, AKeptTableIsShownAlthoughNoneIsMadeOfItsTestAnyMore) {
  MeasuredAxis reversed{stated_axis()}, diagonal{stated_axis()};
  reversed.measured.test.metadata.instrument.sign_reversed = true;
  diagonal.measured.test.metadata.axis.line_direction = {1.0, 1.0, 0.0};
  for (MeasuredAxis* axis : {&reversed, &diagonal}) {
    EXPECT_FALSE(compensate(*axis, {.control = "linuxcnc"}));
    axis->is_kept = true;
    const auto made = compensate(*axis, {.control = "linuxcnc"});
    ASSERT_TRUE(made) << made.error().message;
    const auto told = std::ranges::find(made->findings, "compensation-made-no-more", &NamedFinding::id);
    ASSERT_NE(told, made->findings.end());
    EXPECT_TRUE(told->serious);
    expect_in_both_languages(told->message);
  }
  EXPECT_TRUE(serious_ids(stated_axis()).empty());
}

TEST(MeasuredState, DirectionsThatTheRowsContradictAreSeriousWhereTheTableKnowsDirections) {
  NamedTest swapped = stated_axis();
  swapped.test.provenance.remarks.push_back(swapped_labels_remark());
  EXPECT_EQ(serious_ids(swapped), std::vector<std::string>{"compensation-directions-swapped"});
  const auto one_curve = compensate({swapped}, {.control = "linuxcnc", .curves = TableCurves::both_ways});
  ASSERT_TRUE(one_curve) << one_curve.error().message;
  EXPECT_TRUE(std::ranges::none_of(one_curve->findings, &NamedFinding::serious));

  const auto made = compensate({stated_axis(), {}, std::move(swapped)}, {.control = "linuxcnc"});
  ASSERT_TRUE(made) << made.error().message;
  const auto found = std::ranges::find(made->findings, "retest-directions-swapped", &NamedFinding::id);
  ASSERT_NE(found, made->findings.end());
  EXPECT_TRUE(found->serious);
  expect_in_both_languages(found->message);
}

TEST(MeasuredState, AStatementThatNoTableWasActiveSpeaksAgainstOne) {
  const auto first = compensate({stated_axis()}, {.control = "linuxcnc"});
  ASSERT_TRUE(first) << first.error().message;
  for (const std::string stated : {"none", "keine", ""}) {
    NamedTest axis = stated_axis(), again = stated_axis(1);
    axis.test.metadata.axis.compensation = again.test.metadata.axis.compensation = stated;
    const auto upon = compensate({axis, NamedTable{"old.comp", first->text}, again}, {.control = "linuxcnc"});
    ASSERT_TRUE(upon) << upon.error().message;
    for (const std::string id : {"compensation-states-no-table", "retest-states-no-table"}) {
      const auto told = std::ranges::find(upon->findings, id, &NamedFinding::id);
      ASSERT_EQ(told != upon->findings.end(), !stated.empty()) << id << ' ' << stated;
      if (stated.empty()) continue;
      EXPECT_TRUE(told->serious);
      expect_in_both_languages(told->message);
    }
  }
}

TEST(MeasuredState, WhatWasNotCorrectedIsSerious) {
  const std::vector<std::string> told{"compensation-uncorrected"};
  EXPECT_TRUE(serious_ids(stated_axis()).empty());
  NamedTest gained = stated_axis();
  gained.test.metadata.instrument.gain = 1.0001;
  EXPECT_EQ(serious_ids(gained), told);
  EvaluateOptions options;
  options.corrections.gain = true;
  auto corrected = prepare_test(gained.test, options);
  ASSERT_TRUE(corrected) << corrected.error().message;
  EXPECT_TRUE(serious_ids({"x.csv", *corrected}).empty());

  NamedTest warm = stated_axis();
  warm.test.metadata.nde.applied = false;
  warm.test.metadata.environment.air_temperature_start = Temperature::celsius(30.0);
  EXPECT_EQ(serious_ids(warm), told);
  warm.test.metadata.nde.applied = true;
  EXPECT_TRUE(serious_ids(warm).empty());
}

TEST(MeasuredState, AnUncorrectedRetestIsToldToo) {
  NamedTest again = stated_axis(1);
  again.test.metadata.instrument.gain = 1.0001;
  const auto made = compensate({stated_axis(), {}, std::move(again)}, {.control = "linuxcnc"});
  ASSERT_TRUE(made) << made.error().message;
  const auto found = std::ranges::find(made->findings, "retest-uncorrected", &NamedFinding::id);
  ASSERT_NE(found, made->findings.end());
  EXPECT_TRUE(found->serious);
  expect_in_both_languages(found->message);
}

TEST(MeasuredState, AnActiveCompensationWantsItsTable) {
  const std::vector<std::string> told{"compensation-active-table-unknown"};
  NamedTest active = stated_axis();
  active.test.metadata.axis.compensation = "leadscrew and reversal table active";
  EXPECT_EQ(serious_ids(active), told);
  const NamedTable old{"old.comp", "0 0 0\n400 400.001 400.001\n"};
  EXPECT_TRUE(serious_ids(active, old).empty()) << "it is counted from";
  NamedTest sampled = stated_axis();
  sampled.test.metadata.axis.compensation_points = {0, 50, 100};
  EXPECT_EQ(serious_ids(sampled), told);
  sampled.test.metadata.axis.compensation = "none";
  EXPECT_EQ(serious_ids(sampled), told) << "one of both is wrong";
  for (const char* none : {"", "none", "None", "not used", "-", "–", "n/a", "keine", "aucune", " not active "}) {
    NamedTest bare = stated_axis();
    bare.test.metadata.axis.compensation = none;
    EXPECT_TRUE(serious_ids(bare).empty()) << none;
  }
}

TEST(MeasuredState, ALineOfSeveralAxesMakesNoTable) {
  NamedTest diagonal = stated_axis();
  diagonal.test.metadata.axis.line_direction = {1, 1, 0};
  expect_refused(diagonal, "2 axes drive together");
  diagonal.test.metadata.axis.line_origin_mm = {0, 0, 0};
  expect_refused(diagonal, "2 axes drive together");
  diagonal.test.metadata.axis.line_direction = {0, 0, 0};
  expect_refused(diagonal, "no direction");
  for (const std::vector<double>& along : {std::vector<double>{1, 0, 0}, {0, -2, 0}}) {
    NamedTest straight = stated_axis();
    straight.test.metadata.axis.line_direction = along;
    EXPECT_TRUE(serious_ids(straight).empty());
  }
}

TEST(MeasuredState, ATestIsNotItsOwnRetest) {
  const auto refused = [](const NamedTest& test, const NamedTest& again) {
    const auto made = compensate({test, {}, again}, {.control = "linuxcnc"});
    if (!made) expect_in_both_languages(made.error().message);
    return !made;
  };
  NamedTest first = stated_axis(), other = stated_axis(1);
  EXPECT_FALSE(refused(first, first)) << "nobody knows that it is one file";
  first.test.provenance.sha256 = other.test.provenance.sha256 = "ab12";
  EXPECT_TRUE(refused(first, first));
  EXPECT_FALSE(refused(first, other)) << "two tests of a file of many";
}

}  // namespace
}  // namespace axiometry::app
