// SPDX-License-Identifier: Apache-2.0
//
// Every finding of suspicions.cpp, provoked, in German.
#include <gtest/gtest.h>

#include <cmath>
#include <iterator>
#include <regex>
#include <set>
#include <string>
#include <vector>

#include "axiometry/compensation/fit.h"
#include "axiometry/compensation/grid.h"
#include "axiometry/compensation/prediction.h"
#include "axiometry/compensation/retest_findings.h"
#include "axiometry/compensation/suspicions.h"
#include "axiometry/language/language.h"
#include "tests/support/repository_file.h"
#include "tests/support/series.h"

namespace axiometry::compensation {
namespace {

using language::Language;
using testing_support::make_series;
using testing_support::none;
using Runs = std::vector<testing_support::RunDeviations>;

const std::vector<double> five_targets{0, 100, 200, 300, 400.5};

std::string in_german(const std::string& text) {
  return language::translated(text, Language::german, {.decimal_mark = ','});
}

void expect_german_text(const std::string& message) {
  EXPECT_TRUE(language::is_known(message, Language::german)) << message;
  const std::string german = in_german(message);
  EXPECT_FALSE(std::regex_search(german, std::regex("[0-9]\\.[0-9]"))) << german;
}

/// The names of what was found, each of which must be German.
std::set<std::string> german_ids(const std::vector<NamedFinding>& findings) {
  std::set<std::string> ids;
  for (const NamedFinding& finding : findings) {
    ids.insert(finding.id);
    expect_german_text(finding.message);
  }
  return ids;
}

/// Five runs with a little scatter, and `drift` more from each to the next.
Runs scattered(double shift, double drift) {
  Runs runs;
  for (int j = 0; j < 5; ++j) {
    testing_support::RunDeviations run;
    for (int i = 0; i < 5; ++i) run.push_back(shift + 7.5 * i + 0.1 * ((3 * i + 2 * j) % 5) + drift * j);
    runs.push_back(std::move(run));
  }
  return runs;
}

AxisCorrection straight(AxisKind kind, double first, double last) {
  return AxisCorrection::make(kind, {first, last}, {0, 1}, {0, 1}).value();
}

std::set<std::string> of_readings() {
  std::set<std::string> ids;
  const auto take = [&](const Series& series, AxisKind kind, TableCurves curves) {
    ids.merge(german_ids(findings_of_readings(series, kind, curves)));
  };
  Runs up = scattered(0, 0);
  up[2][1] += 25.0;
  take(make_series(five_targets, up, scattered(-4, 0)), AxisKind::linear, TableCurves::both_ways);
  take(make_series(five_targets, scattered(0, 3.5), scattered(-4, 3.5)), AxisKind::linear, TableCurves::each_way);
  Runs rough = scattered(-4, 0);
  for (std::size_t j = 0; j < rough.size(); ++j)
    for (std::size_t i = 0; i < rough[j].size(); ++i) rough[j][i] += static_cast<double>((3 * i + 2 * j) % 5);
  take(make_series(five_targets, scattered(0, 0), rough), AxisKind::linear, TableCurves::each_way);
  take(make_series(five_targets, scattered(0, 0), {}), AxisKind::linear, TableCurves::both_ways);
  take(make_series(five_targets, {}, scattered(0, 0)), AxisKind::linear, TableCurves::both_ways);
  take(make_series({0, 72.5, 145, 217.5, 290}, scattered(0, 0), scattered(0, 0)), AxisKind::rotary,
       TableCurves::each_way);
  take(make_series({0, 300}, {{0, 6}}, {{4, 9}}), AxisKind::linear, TableCurves::each_way);
  take(make_series({0, 90, 180, 270, 360}, scattered(0, 0), scattered(0, 0)), AxisKind::rotary, TableCurves::each_way);
  return ids;
}

std::set<std::string> of_tables() {
  const Series series = make_series(five_targets, scattered(0, 0), scattered(0, 0));
  std::set<std::string> ids = german_ids(findings_of_table(series, straight(AxisKind::linear, 50.5, 350)));
  ids.merge(german_ids(findings_of_table(series, straight(AxisKind::rotary, -50.5, 450))));
  const AxisCorrection fine =
      AxisCorrection::make(AxisKind::linear, {0, 30, 60, 90, 100.5, 200}, {0, 1, 2, 3, 4, 5}, {0, 1, 2, 3, 4, 5})
          .value();
  ids.merge(german_ids(findings_of_table(series, fine)));
  return ids;
}

/// What a change that is a line shows.
TableShare share_of(double share, double u = 0.01) { return {share, u, 1.0, true, std::abs(share) < 0.1}; }

std::set<std::string> of_retests() {
  std::vector<NamedFinding> findings;
  for (const double share : {1.0, 0.0, -1.0, 2.0, 0.5})
    findings.push_back(finding_of_retest({.whole = share_of(share)}));
  for (const double reversal : {-1.0, 2.0, 0.0, 0.5})
    findings.push_back(
        finding_of_retest({.whole = share_of(1.0), .of_reversal = reversal, .exchanged = reversal < 0.0}));
  findings.push_back(finding_of_retest({.whole = share_of(1.0), .of_reversal = 0.8, .u_of_reversal = 0.4}));
  findings.push_back(finding_of_retest({.whole = share_of(1.0), .has_reversal = true}));
  findings.push_back(finding_of_retest({.whole = share_of(1.0, 0.5)}));
  findings.push_back(finding_of_retest({.whole = share_of(1.0)}, {.above_expected = true}));
  for (const double share : {1.0, 0.9}) {
    findings.push_back(finding_of_retest({.whole = share_of(share)}, {.is_part = true}));
    EXPECT_NE(findings.back().message.find("where it was measured again"), std::string::npos);
  }
  findings.push_back(finding_of_retest({.whole = share_of(0.9)}, {.above_95 = true}));
  const auto whole = testing_support::make_series({0, 100, 200, 300}, {{0, 1, 2, 3}}, {{0, 1, 2, 3}});
  findings.push_back(finding_of_part({.targets = 2, .first = 0.0, .last = 100.0}, whole, AxisKind::linear).value());
  const TableShare no_line{0.3, 0.1, 0.2, false, false};
  findings.push_back(finding_of_retest({.whole = no_line, .directions = {share_of(1.0), share_of(0.0)}}));
  findings.push_back(finding_of_retest({.whole = no_line, .directions = {share_of(0.0), share_of(1.0)}}));
  findings.push_back(finding_of_retest({.whole = no_line, .exchanged = true}));
  findings.push_back(finding_of_retest({.whole = no_line, .mirrored = true}));
  findings.push_back(finding_of_retest({.whole = no_line}));
  for (const bool exchanged : {false, true}) {
    findings.push_back(finding_of_retest({.whole = share_of(-1.0), .exchanged = exchanged}, {.sign_inferred = true}));
    EXPECT_NE(findings.back().message.find("with the other sign"), std::string::npos);
    findings.push_back(finding_of_retest({.whole = share_of(-1.0), .exchanged = exchanged}));
  }
  for (const NamedFinding& finding : findings)
    EXPECT_TRUE(language::is_known(finding.message, Language::french)) << finding.message;
  return german_ids(findings);
}

TEST(GermanSuspicions, AreAllOfThem) {
  std::set<std::string> found = of_readings();
  found.merge(of_tables());
  found.merge(of_retests());
  const std::string source = testing_support::repository_file("src/axiometry/compensation/suspicions.cpp") +
                             testing_support::repository_file("src/axiometry/compensation/retest_findings.cpp");
  const std::regex id(R"("((?:compensation|retest)-[a-z-]+)\")");
  std::set<std::string> expected;
  for (std::sregex_iterator at(source.begin(), source.end(), id), end; at != end; ++at) expected.insert((*at)[1]);
  EXPECT_GE(expected.size(), 19u);
  EXPECT_EQ(found, expected);
}

/// A control that rolls over holds no last value: its file does as far as there are targets, and a turn begins anew.
TEST(Suspicions, TellWhatIsBeyondTheEndsOfATableThatRollsOver) {
  const Series series = make_series(five_targets, scattered(0, 0), scattered(0, 0));
  const auto said = [&](AxisKind kind, double first, double last, bool rolls_over) -> std::string {
    for (const NamedFinding& finding : findings_of_table(series, straight(kind, first, last), rolls_over)) {
      if (finding.id != "compensation-beyond-ends") continue;
      expect_german_text(finding.message);
      EXPECT_TRUE(language::is_known(finding.message, Language::french)) << finding.message;
      return finding.message.substr(finding.message.rfind(": ") + 2);
    }
    return "";
  };
  EXPECT_EQ(said(AxisKind::linear, 50, 350, false), "beyond its ends the control holds the last value");
  EXPECT_EQ(said(AxisKind::linear, 50, 350, true), "over the targets beyond its ends the file holds the last value");
  EXPECT_EQ(said(AxisKind::rotary, 0, 360, true),
            "beyond its ends the control begins the turn anew, and what is foretold there counts on the last value");
  EXPECT_TRUE(said(AxisKind::rotary, 30, 300, true).ends_with("where the turn closes"));
  EXPECT_EQ(said(AxisKind::linear, 0, 400.5, true), "");
}

TEST(Suspicions, CountPositionsThatNoTargetIsNear) {
  const Series series = make_series(five_targets, scattered(0, 0), scattered(0, 0));
  const auto bare = [&](std::vector<double> positions) -> std::string {
    const std::vector<double> zeros(positions.size());
    const auto table = AxisCorrection::make(AxisKind::linear, std::move(positions), zeros, zeros).value();
    for (const NamedFinding& finding : findings_of_table(series, table))
      if (finding.id == "compensation-between-targets")
        return finding.message.substr(0, finding.message.find(" positions"));
    return "";
  };
  EXPECT_EQ(bare({0, 100, 200, 300, 400.5}), "") << "the targets themselves";
  EXPECT_EQ(bare({50, 150, 250, 350}), "") << "one target between each";
  EXPECT_EQ(bare({0, 50, 100, 150, 200, 300, 400.5}), "found 2 of the 7")
      << "50 and 150 follow from the targets that their neighbours stand at";
  EXPECT_EQ(bare({0, 30, 60, 90, 200, 300}), "found 2 of the 6");
  EXPECT_EQ(bare({0, 20, 40, 60, 80, 120, 400.5}), "found 3 of the 7") << "20 to 60: 80 has the target at 100";
  EXPECT_EQ(bare({-90, -60, -30, 0, 100}), "") << "beyond the targets another finding speaks";
}

TEST(GermanSuspicions, SayWhatNoAxisDoes) {
  std::set<std::string> whys;
  for (const double per_mm : {-2.0, -1.0, 24.4, 1.0 / 25.4 - 1.0, 0.305}) {
    testing_support::RunDeviations run;
    for (const double x : five_targets) run.push_back(per_mm * 1000.0 * x);
    const auto plausible = check_plausible(make_series(five_targets, {run}, {run}), AxisKind::linear);
    ASSERT_FALSE(plausible);
    expect_german_text(plausible.error().message);
    whys.insert(in_german(plausible.error().message).substr(in_german(plausible.error().message).rfind(": ")));
  }
  EXPECT_EQ(whys.size(), 5u);
}

TEST(GermanFit, SaysWhatCannotBeFitted) {
  const Series both = make_series(five_targets, scattered(0, 0), scattered(-4, 0));
  const Series up = make_series(five_targets, scattered(0, 0), {}),
               down = make_series(five_targets, {}, scattered(0, 0));
  const Series apart = make_series({0, 100}, {{1, none}}, {{none, 1}});
  const auto expect_refused_in_german = [](const Series& series, std::vector<double> nodes, TableCurves curves) {
    const auto fit = fit_correction(series, AxisKind::linear, {.nodes = std::move(nodes), .curves = curves});
    ASSERT_FALSE(fit);
    expect_german_text(fit.error().message);
  };
  expect_refused_in_german(both, {}, TableCurves::each_way);
  expect_refused_in_german(both, {100.5, 0}, TableCurves::each_way);
  expect_refused_in_german(both, {-0.5, 500}, TableCurves::each_way);
  expect_refused_in_german(both, {-0.5, 500}, TableCurves::both_ways);
  for (const Series& one : {up, down})
    for (const TableCurves curves : {TableCurves::each_way, TableCurves::with_backlash})
      expect_refused_in_german(one, {0, 400}, curves);
  expect_refused_in_german(apart, {0, 100}, TableCurves::with_backlash);
}

TEST(GermanGrid, SaysWhatContradictsItself) {
  const auto expect_no_grid = [](const std::vector<double>& targets, const GridRequest& wish,
                                 const GridLimits& limits) {
    const auto grid = grid_of(targets, wish, limits);
    ASSERT_FALSE(grid);
    expect_german_text(grid.error().message);
  };
  expect_no_grid({0}, {}, {});
  expect_no_grid(five_targets, {.step = 0.0}, {});
  expect_no_grid(five_targets, {.points = 1}, {});
  expect_no_grid(five_targets, {.start = 10.5, .end = 10.5, .points = 3}, {});
  expect_no_grid(five_targets, {.start = 0, .end = 100, .step = 7.5, .points = 3}, {});
  expect_no_grid(five_targets, {.start = 0, .end = 100, .step = 7.5}, {});
  expect_no_grid(five_targets, {.step = 0.5}, {.points = 10});
  expect_no_grid(five_targets, {.step = 900.5}, {});
}

}  // namespace
}  // namespace axiometry::compensation
