// SPDX-License-Identifier: Apache-2.0
#include "axiometry/app/results/localised_result.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <string>
#include <utility>
#include <vector>

#include "axiometry/app/evaluate/evaluate.h"
#include "axiometry/app/results/result_json.h"
#include "axiometry/store/kept/calibration_kinds.h"
#include "tests/support/series.h"

namespace axiometry::app {
namespace {

constexpr Reader german_reader{.language = language::Language::german, .numbers = {.decimal_mark = ','}};
constexpr std::string_view english_words = "Reversal error", german_words = "Umkehrspanne";

std::string in_german(std::string_view result, ResultKind kind) {
  return json::dump(localised_result(json::parse(result).value(), kind, german_reader), 0);
}

/// A JSON text with the words in every place of "@".
std::string with_words(std::string_view text, std::string_view words) {
  std::string all;
  for (const char c : text) c == '@' ? all.append(words) : all.append(1, c);
  return json::dump(json::parse(all).value(), 0);
}

void expect_sentences(std::string_view result, ResultKind kind) {
  EXPECT_EQ(in_german(with_words(result, english_words), kind), with_words(result, german_words));
}

void expect_no_sentences(std::string_view result, ResultKind kind) {
  const std::string given = with_words(result, english_words);
  EXPECT_EQ(in_german(given, kind), given);
}

TEST(LocalisedResult, OfATestHasItsSentencesInTheLanguage) {
  expect_sentences(R"({"claims": [{"title": "@", "remark": "@", "missing": [{"id": "x", "message": "@"}]}],
    "corrections": [{"title": "@", "details": [{"name": "@", "value": "@"}]}], "label": "@",
    "drift": {"basis": "@"}, "findings": [{"message": "@"}],
    "information": {"smaller_repeatability": {"remark": "@"}}, "tolerances": [{"withheld": "@"}, {"withheld": null}],
    "environment": {"gaps": ["@"], "quantities": [{"title": "@"}], "remarks": ["@", "@"]}})",
                   ResultKind::test);
  expect_sentences(R"({"uncertainty": {"inputs": [{"title": "@", "origin_title": "@", "use_title": "@", "reason": "@"}],
    "annex_a_budget": {"notes": ["@"], "contributors": [{"title": "@", "inputs": [{"note": "@"}]}]},
    "gum_budget": {"notes": ["@"], "sources": [{"title": "@", "note": "@"}]},
    "monte_carlo": {"A": {"refusal": "@"}, "R_up": {"refusal": "@"}},
    "monte_carlo_run": {"notes": ["@"], "inputs": [{"title": "@", "note": "@"}], "contributions": [{"title": "@"}],
                        "hypotheses": [{"title": "@", "reason": "@"}]}}})",
                   ResultKind::test);
}

TEST(LocalisedResult, OfEveryOtherKindHasItsSentencesInTheLanguage) {
  expect_sentences(R"({"lines": [{"test": {"findings": [{"message": "@"}], "label": "@"}}],
    "squareness": {"notes": ["@"]}, "findings": [{"message": "@"}]})",
                   ResultKind::lines);
  expect_sentences(R"({"remarks": ["@"], "angles": [{"remarks": ["@"]}], "lines": [{"remarks": ["@"]}],
    "straightness": {"remarks": ["@"]}})",
                   ResultKind::motions);
  expect_sentences(R"({"label": "@", "findings": [{"message": "@"}]})", ResultKind::periodic);
  expect_sentences(R"({"remarks": ["@", "@"]})", ResultKind::dynamic);
  expect_sentences(R"({"findings": [{"message": "@"}], "remarks": ["@"],
    "gauge": {"means": "@", "straightness": "@"}})",
                   ResultKind::volumetric);
  expect_sentences(R"({"findings": [{"message": "@"}], "reasons": ["@"]})", ResultKind::volumetric_plan);
  expect_sentences(R"({"before": {"findings": [{"message": "@"}]}, "after": {"findings": [{"message": "@"}]}})",
                   ResultKind::field_difference);
  expect_sentences(R"({"sign": "@", "turned_sign": true, "verified": {"verified": "@", "inferred": "@"},
    "known_to_within": {"notes": ["@"]}, "findings": [{"message": "@"}]})",
                   ResultKind::compensation);
  expect_sentences(R"({"title": "@", "sign": "@", "turned_sign": "@", "loading": "@", "verified": "@",
    "inferred": "@"})",
                   ResultKind::control);
  expect_sentences(R"({"findings": [{"message": "@"}]})", ResultKind::findings_beside_all);
  expect_sentences(R"([{"message": "@"}])", ResultKind::findings);
}

/// Texts of three words and more that stand alike in both, but distributions, symbols and what a user wrote.
void add_untranslated(const json::Value& english, const json::Value& other, const std::string& place,
                      std::vector<std::string>& found) {
  if (english.is(json::Kind::text) && english.text() == other.text() && std::ranges::count(english.text(), ' ') > 1)
    found.push_back(place + ": " + english.text());
  if (english.is(json::Kind::array))
    for (std::size_t k = 0; k < english.items().size(); ++k)
      add_untranslated(english.items()[k], other.items()[k], place + "[].", found);
  if (!english.is(json::Kind::object)) return;
  for (const auto& [name, member] : english.members())
    if (name != "metadata" && name != "source" && name != "distribution" && name != "symbol")
      add_untranslated(member, *other.find(name), place + name + '.', found);
}

/// What a user wrote stands beside it, in the metadata alone.
TEST(LocalisedResult, OfATestHasNoSentenceLeftInEnglish) {
  axiometry::Test test = testing_support::table2::complete_test();
  test.metadata.instrument.gain = 2;
  EvaluateOptions options;
  options.corrections = {.gain = true, .drift = true};
  const std::string stated = "ctrap 1.9 3.0 0.2";
  options.metadata = {{"uncertainty.distributions", "machine_temperature | " + stated}};
  options.uncertainty.gum = options.uncertainty.monte_carlo = true;
  options.uncertainty.trials.propagation.trials = 10'000;
  const auto evaluated = evaluate_test(std::move(test), options);
  ASSERT_TRUE(evaluated) << evaluated.error().to_string();
  const json::Value result = to_json(*evaluated);
  ASSERT_FALSE(result.find("uncertainty")->find("monte_carlo_run")->find("hypotheses")->items().empty());
  std::vector<std::string> left;
  add_untranslated(result, localised_result(result, ResultKind::test, german_reader), "", left);
  EXPECT_EQ(left, std::vector<std::string>{"uncertainty.inputs.[].value.: " + stated});
}

TEST(LocalisedResult, HasNoSentenceOfTheGaugeInEnglish) {
  for (const std::string_view text :
       {"the mean of each of the 18 functions over its range is 0: constants are a place of the whole machine",
        "the best straight line of the six straightness functions is level: their slopes are squareness, or turn the "
        "whole machine"})
    for (const language::Language language : {language::Language::german, language::Language::french})
      EXPECT_TRUE(language::is_known(text, language)) << text;
}

/// Words of a user that read like the program's own, wherever a result has such.
TEST(LocalisedResult, LeavesWhatUsersWrote) {
  expect_no_sentences(R"({"axis": {"name": "@"}, "source": {"file": "@", "title": "@", "test": "@"},
    "tolerance_table": {"file": "@", "name": "@"}, "uncertainty": {"inputs": [{"instrument": "@"}]},
    "metadata": {"machine": {"name": "@", "title": "@"}, "conditions": {"inspector": "@", "comment": "@"},
                 "label": "@", "note": "@", "findings": [{"message": "@"}]},
    "environment": {"sensors": [{"name": "@", "role": "@", "title": "@"}], "source": {"file": "@"}}})",
                      ResultKind::test);
  expect_no_sentences(R"({"machine": "@", "setup": {"title": "@", "obstacles": [{"name": "@", "label": "@"}]},
    "lines": [{"id": "@", "title": "@", "test": {"axis": {"name": "@"}, "metadata": {"title": "@"}}}]})",
                      ResultKind::lines);
  expect_no_sentences(R"({"stations": [{"station": "@", "tool": "@", "note": "@"}], "title": "@", "note": "@",
    "machine": {"message": "@"}, "model": {"machine": {"name": "@", "title": "@", "remarks": ["@"]}}})",
                      ResultKind::volumetric);
  expect_no_sentences(
      R"({"straightness": {"metadata": {"machine": {"name": "@"}}, "source": {"file": "@"}, "note": "@"},
    "title": "@"})",
      ResultKind::motions);
  expect_no_sentences(R"({"axis": "@", "output_axis": "@", "title": "@", "notes": "@"})", ResultKind::compensation);
}

TEST(LocalisedResult, LeavesAMemberThatHasAnotherShapeThanItsPlace) {
  expect_no_sentences(R"({"findings": "@", "claims": {"title": "@"}, "label": ["@", {"title": "@"}]})",
                      ResultKind::test);
}

TEST(LocalisedResult, IsTheEnglishOneInEnglish) {
  const json::Value result = json::parse(R"({"label": "Reversal error", "sign": 0.5})").value();
  EXPECT_EQ(json::dump(localised_result(result, ResultKind::test, {})), json::dump(result));
}

TEST(LocalisedResult, KnowsEveryKindOfCalibration) {
  for (const std::string_view kind : store::calibration_kinds) {
    const bool motions = kind != "lines" && kind != "volumetric";
    EXPECT_EQ(result_kind_of_calibration(kind) == ResultKind::motions, motions) << kind;
  }
}

}  // namespace
}  // namespace axiometry::app
