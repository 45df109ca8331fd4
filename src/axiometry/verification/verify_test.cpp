// SPDX-License-Identifier: Apache-2.0
#include "axiometry/verification/verify.h"

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <random>
#include <string>
#include <vector>

#include "axiometry/app/evaluate/evaluate.h"
#include "axiometry/app/results/result_json.h"
#include "axiometry/app/results/second_opinion.h"
#include "axiometry/report/documents/compose.h"
#include "axiometry/verification/clause3.h"
#include "axiometry/verification/document_check.h"
#include "tests/support/report_subject.h"
#include "tests/support/series.h"
#include "tests/support/statistics_of_trials.h"

namespace axiometry::verification {
namespace {

using ::testing::HasSubstr;

constexpr double missing = std::numeric_limits<double>::quiet_NaN();

app::EvaluateOptions with_limits(std::vector<std::string> limits, std::string_view rule = "simple") {
  app::EvaluateOptions options;
  for (const std::string& limit : limits) options.tolerance.limits.push_back(app::parse_tolerance(limit).value());
  options.tolerance.rule = app::parse_rule(rule).value();
  return options;
}

app::Evaluated evaluated(axiometry::Test test, const app::EvaluateOptions& options) {
  return app::evaluate_test(std::move(test), options).value();
}

app::Evaluated table2(std::string_view rule = "simple") {
  return evaluated(testing_support::table2::complete_test(), with_limits({"A=10um", "E=7um", "B=6um"}, rule));
}

/// A member of an object, to be changed.
json::Value with_member(const json::Value& object, std::string_view path, const json::Value& value) {
  const std::string_view name = path.substr(0, path.find('/'));
  const bool last = name.size() == path.size();
  const auto changed = [&](const json::Value& old) {
    return last ? value : with_member(old, path.substr(name.size() + 1), value);
  };
  if (object.is(json::Kind::array)) {
    json::Value list = json::Value::array();
    for (std::size_t k = 0; k < object.items().size(); ++k)
      list.push(fmt::format("{}", k) == name ? changed(object.items()[k]) : object.items()[k]);
    return list;
  }
  json::Value copy = json::Value::object();
  for (const auto& [key, old] : object.members()) copy.add(key, key == name ? changed(old) : old);
  return copy;
}

const json::Value& at(const json::Value& root, std::string_view path) {
  const json::Value* value = &root;
  while (!path.empty()) {
    const std::string_view name = path.substr(0, path.find('/'));
    value = value->is(json::Kind::array) ? &value->items().at(static_cast<std::size_t>(std::stoi(std::string(name))))
                                         : value->find(name);
    if (value == nullptr) throw std::logic_error("no member " + std::string(name));
    path.remove_prefix(std::min(path.size(), name.size() + 1));
  }
  return *value;
}

Result<Counts> checked(const app::Evaluated& e, const json::Value& result, const report::Document& document) {
  return verify({result, document}, {e.test.series});
}

report::Document document_of(const app::Evaluated& e) {
  return report::compose({e.test, e.assessment, e.judgements}, {});
}

TEST(Verification, FindsAWholeResultAgain) {
  for (const std::string_view rule : {"simple", "iso14253-1", "guard-band=1um"}) {
    const auto counts = app::second_opinion(table2(rule), {}, {});
    ASSERT_TRUE(counts) << rule << ": " << counts.error().message;
    EXPECT_GT(counts->figures, 600U);
    EXPECT_GE(counts->verdicts, 9U);  // in the result, on the first page, in two tables
  }
}

TEST(Verification, CountsNoVerdictWhereNoneWasMade) {
  const auto counts = app::second_opinion(evaluated(testing_support::table2::complete_test(), with_limits({})), {}, {});
  ASSERT_TRUE(counts) << counts.error().message;
  EXPECT_EQ(counts->verdicts, 0U);
}

/// Of every kind of noise and both measurands: the interval is the envelope of several distributions.
TEST(Verification, FindsAMonteCarloResultWithAnEnvironmentAgain) {
  for (const auto kind : {EnvironmentKind::unknown, EnvironmentKind::white, EnvironmentKind::drift})
    for (const auto measurand : {Measurand::this_test, Measurand::this_machine}) {
      axiometry::Test test = testing_support::table2::complete_test();
      test.metadata.uncertainty.environmental_variation = Deviation::native(kind == EnvironmentKind::white ? 0.4 : 1.7);
      test.metadata.gum.environment_kind = kind;
      test.metadata.gum.measurand = measurand;
      app::EvaluateOptions options = with_limits({"A=12um", "R=6.56um", "B_mean=4um"}, "iso14253-1");
      options.uncertainty.monte_carlo = options.uncertainty.gum = true;
      options.uncertainty.trials.propagation.trials = 2000;
      options.uncertainty.trials.contribution_trials = 500;
      const auto counts = app::second_opinion(evaluated(test, options), options.uncertainty, {});
      EXPECT_TRUE(counts) << counts.error().message;
    }
}

TEST(Verification, FindsAGumResultWithFewApproachesAgain) {
  axiometry::Test test{{},
                       testing_support::make_series({0, 500, 1000}, {{1, 3, 2}, {2, 3.5, 2.2}, {1.5, 3.2, 2.1}},
                                                    {{2, 4, 3}, {3, 4.4, 3.3}, {2.5, 4.2, 3.1}}),
                       {}};
  test.metadata.uncertainty.environmental_variation = Deviation::native(0.5);
  test.metadata.gum.measurand = Measurand::this_machine;
  test.metadata.gum.method = UncertaintyMethod::gum;
  const app::EvaluateOptions options = with_limits({"A=12um", "R=6um", "B_mean=4um"}, "iso14253-1");
  const app::Evaluated e = evaluated(test, options);
  ASSERT_TRUE(e.judgements.front().uncertainty->degrees_of_freedom) << "Student's t";
  const auto counts = app::second_opinion(e, options.uncertainty, {});
  EXPECT_TRUE(counts) << counts.error().message;
}

TEST(Verification, FindsTheTargetsAgainThatAReportOfVeryManyShows) {
  std::vector<double> targets;
  testing_support::RunDeviations first, second;
  for (std::size_t i = 0; i < 1500; ++i) {
    targets.push_back(double(i));
    first.push_back(0.01 * double(i * i % 313));
    second.push_back(0.01 * double(i * i % 311) + 0.001 * double(i));
  }
  axiometry::Test test{{}, testing_support::make_series(targets, {first, second}, {second, first}), {}};
  test.metadata.uncertainty.environmental_variation = Deviation::native(0.1);
  const app::Evaluated e = evaluated(std::move(test), {});
  EXPECT_TRUE(app::second_opinion(e, {}, {}));
  report::Document document = document_of(e);
  for (report::Section& section : document.sections)  // a line under another target's number
    if (section.id == "uncertainty")
      for (report::Block& block : section.blocks)
        if (auto* table = std::get_if<report::Table>(&block); table != nullptr && table->rows.size() > 400)
          table->rows[7][0].text = report::plain("23");
  EXPECT_FALSE(checked(e, app::to_json(e), document));
}

TEST(Verification, FindsItAgainInEveryUnitAndStyle) {
  const app::Evaluated e = table2("iso14253-1");
  for (const auto unit : {report::DisplayUnit::mm, report::DisplayUnit::nm, report::DisplayUnit::native})
    for (const char mark : {'.', ','})
      for (const int digits : {1, 2, 4}) {
        report::Options options;
        options.unit = unit;
        options.numbers.decimal_mark = mark;
        options.uncertainty_digits = digits;
        if (digits == 4) options.deviation_decimals = 4;
        const auto counts = app::second_opinion(e, {}, options);
        EXPECT_TRUE(counts) << counts.error().message;
      }
}

TEST(Verification, FindsARotaryAxisAgain) {
  axiometry::Test test{{}, testing_support::table2::series(), {}};
  test.metadata.axis.kind = AxisKind::rotary;
  test.metadata.axis.name = "C";
  test.metadata.uncertainty.environmental_variation = Deviation::native(1.7);
  for (const auto unit : {report::DisplayUnit::native, report::DisplayUnit::deg}) {
    report::Options options;
    options.unit = unit;
    const auto counts =
        app::second_opinion(evaluated(test, with_limits({"A=10arcsec", "B_mean=3arcsec"}, "iso14253-1")), {}, options);
    EXPECT_TRUE(counts) << counts.error().message;
  }
}

TEST(Verification, CatchesAChangedFigureOfTheResult) {
  const app::Evaluated e = table2();
  const json::Value result = app::to_json(e);
  const report::Document document = document_of(e);
  ASSERT_TRUE(checked(e, result, document));
  for (const std::string_view path :
       {"parameters/A", "parameters/B_mean", "parameters/R_up", "positions/3/mean_up", "positions/0/s_down",
        "positions/10/R", "positions/5/n_up", "positions/2/target", "uncertainty/annex_a/E",
        "uncertainty/annex_a_budget/contributors/2/U", "uncertainty/annex_a_budget/runs",
        "uncertainty/annex_a_budget/corrected_repeatability/R"}) {
    const double figure = at(result, path).number();
    for (const double changed : {figure + 1e-9, figure - 1e-9, figure * 1.1, -figure - 1.0})
      EXPECT_FALSE(checked(e, with_member(result, path, changed), document)) << path << " " << changed;
    EXPECT_FALSE(checked(e, with_member(result, path, json::Value()), document) && path.starts_with("param")) << path;
  }
}

TEST(Verification, CatchesASwappedVerdict) {
  for (const std::string_view rule : {"simple", "iso14253-1", "guard-band=1um"}) {
    const app::Evaluated e = table2(rule);
    const json::Value result = app::to_json(e);
    const report::Document document = document_of(e);
    for (int row = 0; row < 3; ++row)
      for (const std::string_view verdict : {"conforms", "does not conform", "undecided", "not applicable"}) {
        const std::string path = fmt::format("tolerances/{}/verdict", row);
        const bool same = at(result, path).text() == verdict;
        EXPECT_EQ(checked(e, with_member(result, path, verdict), document).has_value(), same) << rule << verdict;
      }
    for (const std::string_view verdict : {"conforms", "does not conform", "undecided"})
      EXPECT_EQ(checked(e, with_member(result, "verdict", verdict), document).has_value(),
                at(result, "verdict").text() == verdict);
  }
}

TEST(Verification, CatchesAnInputThatIsNotTheOneOfItsU) {
  const app::Evaluated e = table2();
  const json::Value result = app::to_json(e);
  const std::string path = "uncertainty/annex_a_budget/contributors/6/inputs/0/value";
  const auto refused = checked(e, with_member(result, path, at(result, path).number() * 1.001), document_of(e));
  ASSERT_FALSE(refused);
  EXPECT_THAT(refused.error().message, HasSubstr("U_EVE in the budget of Annex A: printed 1.02"));
}

/// Every cell of the tables that hold results, with its last digit changed.
TEST(Verification, CatchesAChangedDigitInTheReport) {
  const app::Evaluated e = table2("iso14253-1");
  const json::Value result = app::to_json(e);
  const report::Document document = document_of(e);
  const Evidence evidence{e.test.series};
  Ledger of_result;
  const Found found = check_result(result, evidence, of_result);  // once: it takes most of the time
  const auto agrees = [&](const report::Document& printed) {
    Ledger ledger;
    check_document(printed, result, found, evidence, 2, ledger);
    return ledger.agrees();
  };
  ASSERT_TRUE(of_result.agrees());
  ASSERT_TRUE(agrees(document));
  std::size_t changed_cells = 0;
  for (std::size_t s = 0; s < document.sections.size(); ++s) {
    const std::string& id = document.sections[s].id;
    if (id != "parameters" && id != "conformity" && id != "positions" && id != "uncertainty") continue;
    for (std::size_t b = 0; b < document.sections[s].blocks.size(); ++b) {
      const auto* table = std::get_if<report::Table>(&document.sections[s].blocks[b]);
      if (table == nullptr) continue;
      for (std::size_t row = 0; row < table->rows.size(); ++row)
        for (std::size_t column = 0; column < table->columns.size(); ++column) {
          if (table->columns[column].align != report::Align::decimal) continue;
          if (column == 0 && id != "parameters") continue;  // the number of a target
          report::Document mutant = document;
          auto& cells = std::get<report::Table>(mutant.sections[s].blocks[b]).rows[row];
          if (cells[column].text.empty()) continue;
          std::string& text = cells[column].text.back().text;
          const std::size_t digit = text.find_last_of("0123456789");
          if (digit == std::string::npos) continue;
          text[digit] = text[digit] < '5' ? static_cast<char>(text[digit] + 2) : static_cast<char>(text[digit] - 2);
          EXPECT_FALSE(agrees(mutant)) << id << " " << row << " " << column << ": " << text;
          ++changed_cells;
        }
    }
  }
  EXPECT_GT(changed_cells, 300U);
}

TEST(Verification, CatchesAnotherVerdictInTheReport) {
  const app::Evaluated e = table2();
  const json::Value result = app::to_json(e);
  const report::Document document = document_of(e);
  for (std::size_t line = 0; line < document.status.front().lines.size(); ++line) {
    report::Document mutant = document;
    for (auto& notice : mutant.status)
      for (auto& run : notice.heading)
        if (run.text.starts_with("Does not conform")) run.text = "Conforms: ";
    EXPECT_FALSE(checked(e, result, mutant));
  }
  report::Document mutant = document;
  for (auto& section : mutant.sections)
    if (section.id == "parameters")
      for (auto& row : std::get<report::Table>(section.blocks.front()).rows)
        for (auto& cell : row)
          for (auto& run : cell.text)
            if (run.text == "does not conform") run.text = "conforms";
  EXPECT_FALSE(checked(e, result, mutant));
}

TEST(Verification, CatchesAReportWithoutItsTables) {
  const app::Evaluated e = table2();
  report::Document mutant = document_of(e);
  std::erase_if(mutant.sections, [](const report::Section& section) { return section.id == "positions"; });
  EXPECT_FALSE(checked(e, app::to_json(e), mutant));
  mutant = document_of(e);
  for (auto& section : mutant.sections)
    if (section.id == "parameters")
      std::get<report::Table>(section.blocks.front()).columns[3].head = report::plain("?");
  EXPECT_FALSE(checked(e, app::to_json(e), mutant));
}

TEST(Verification, SaysWhatWasPrintedAndWhatIsRight) {
  const app::Evaluated e = table2();
  const auto refused = checked(e, with_member(app::to_json(e), "parameters/E", 7.8), document_of(e));
  ASSERT_FALSE(refused);
  EXPECT_THAT(refused.error().message, HasSubstr("E in the parameters: printed 7.8, right is 7.7"));
}

TEST(Verification, RefusesNumbersBeyondItsArithmetic) {
  const app::Evaluated e = table2();
  const json::Value result = with_member(app::to_json(e), "tolerances/0/limit", 1e300);
  const auto refused = checked(e, result, document_of(e));
  ASSERT_FALSE(refused);
  EXPECT_THAT(refused.error().message, HasSubstr("cannot verify"));
}

/// Readings on a grid, some of them missing, some tests with one run or one direction only.
Series random_series(std::mt19937_64& random, int places) {
  const std::size_t targets = 2 + random() % 14;
  const std::size_t runs = 1 + random() % 10;
  const double unit = std::pow(10.0, places);
  std::vector<Position> positions;
  for (std::size_t i = 0; i < targets; ++i)
    positions.push_back(Position::native(static_cast<double>(i * 100'000 + random() % 90'000) / 1000.0));
  std::vector<double> deviations(2 * targets * runs);
  const double offset = static_cast<double>(static_cast<int>(random() % 20'000) - 10'000) / 10.0;
  const auto spread = static_cast<int>(1 + random() % 2000);
  for (double& x : deviations)
    x = std::round((offset * unit) + static_cast<double>(static_cast<int>(random() % 4001) % spread - spread / 2)) /
        unit;
  if (random() % 3 == 0)
    for (double& x : deviations)
      if (random() % 10 == 0) x = missing;
  if (random() % 8 == 0)
    for (std::size_t k = 0; k < targets * runs; ++k) deviations[k] = missing;
  for (std::size_t i = 0; i < targets; ++i) deviations[(targets + i) * runs] = offset;
  return Series::make_dense(positions, runs, deviations).value();
}

TEST(Verification, AgreesWithTheEvaluationOfAnySeries) {
  AXIOMETRY_STATISTICS_OF_TRIALS();
  std::mt19937_64 random(20140);
  for (int trial = 0; trial < 400; ++trial) {
    axiometry::Test test{{}, random_series(random, static_cast<int>(random() % 5)), {}};
    test.provenance.file = "made up";
    if (trial % 2 == 0) test.metadata.uncertainty.environmental_variation = Deviation::native(0.1 * (trial % 30));
    if (trial % 3 == 0) test.metadata.uncertainty.device_calibration = Deviation::native(1.3);
    app::EvaluateOptions options = with_limits({"E=100um", "B=1um"}, trial % 2 == 0 ? "iso14253-1" : "simple");
    options.tolerance.many_tests = true;
    const auto counts = app::second_opinion(evaluated(std::move(test), options), {}, {});
    EXPECT_TRUE(counts) << trial << ": " << counts.error().message;
  }
}

// Of 200 files of positions 95 were once refused at their own limit.
TEST(Verification, KnowsValuesAtTheirLimit) {
  std::mt19937_64 random(95);
  for (int trial = 0; trial < 300; ++trial) {
    const int places = 1 + trial % 3;  // 0.1, 0.01, 0.001 µm
    const double unit = std::pow(10.0, places);
    const auto steps = static_cast<int>(1 + random() % 400);
    std::vector<double> deviations(4 * 5, 0.0);
    for (std::size_t j = 0; j < 5; ++j) deviations[j] = steps / unit;
    const std::vector<Position> targets = {Position::native(0), Position::native(100)};
    axiometry::Test test{{}, Series::make_dense(targets, 5, deviations).value(), {}};
    for (const int off : {-1, 0, 1}) {
      if (steps + off <= 0) continue;
      const std::string limit = fmt::format("E={:.{}f}um", (steps + off) / unit, places);
      const app::Evaluated e = evaluated(test, with_limits({limit}));
      json::Value result = app::to_json(e);
      const std::string_view right = off < 0 ? "does not conform" : "conforms";
      const std::string_view wrong = off < 0 ? "conforms" : "does not conform";
      const report::Document document = document_of(e);
      for (const std::string_view verdict : {right, wrong}) {
        result = with_member(with_member(result, "tolerances/0/verdict", verdict), "verdict", verdict);
        const auto counts = checked(e, result, document);
        // The report says what the program decided; the decision alone is looked at here.
        const bool refused = !counts && counts.error().message.contains("verdict of E against its limit");
        EXPECT_EQ(refused, verdict == wrong) << limit << " " << verdict;
      }
    }
  }
}

}  // namespace
}  // namespace axiometry::verification
