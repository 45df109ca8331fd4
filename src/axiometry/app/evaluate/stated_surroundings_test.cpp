// SPDX-License-Identifier: Apache-2.0
#include "axiometry/app/evaluate/stated_surroundings.h"

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <string>
#include <utility>
#include <vector>

#include "axiometry/app/evaluate/evaluate.h"
#include "axiometry/app/results/report_subject.h"
#include "axiometry/app/results/result_json.h"
#include "axiometry/report/temperatures/temperatures.h"
#include "axiometry/standards/iso230_2/rules/claims.h"
#include "tests/support/series.h"

namespace axiometry::app {
namespace {

using testing::Contains;
using testing::HasSubstr;
using testing::Not;
using StatedPairs = std::vector<std::pair<std::string, std::string>>;

EvaluateOptions stating(const StatedPairs& items) {
  EvaluateOptions options;
  for (const auto& [key, text] : items) options.metadata.emplace_back("environment." + key, text);
  return options;
}

axiometry::Test any_test() {
  const std::vector<testing_support::RunDeviations> runs(5, {1.0, 2.0});
  return {{}, testing_support::make_series({0.0, 100.0}, runs, runs), {}};
}

Evaluated evaluated_stating(const EvaluateOptions& options) {
  auto evaluated = evaluate_test(any_test(), options);
  EXPECT_TRUE(evaluated) << evaluated.error().message;
  return *std::move(evaluated);
}

std::vector<std::string> ids_of(const Evaluated& evaluated) {
  std::vector<std::string> ids;
  for (const iso230_2::Finding& finding : evaluated.assessment.findings) ids.push_back(finding.id);
  return ids;
}

std::vector<std::string> ids_against_tested(const Evaluated& evaluated) {
  const iso230_2::Claims claims = iso230_2::claims_of(evaluated.test, evaluated.assessment);
  std::vector<std::string> ids;
  for (const iso230_2::Finding& finding : claim(claims, iso230_2::ClaimKind::tested).against) ids.push_back(finding.id);
  return ids;
}

std::string refusal_of(const StatedPairs& items) {
  const auto evaluated = evaluate_test(any_test(), stating(items));
  return evaluated ? "" : evaluated.error().message;
}

/// A day of a hall, every ten minutes, that is at 20 °C and once in the test, at 13:10, at `peak`.
EvaluateOptions with_log(EvaluateOptions options, double peak) {
  std::string log = "time;Air\n";
  for (int minute = 0; minute < 24 * 60; minute += 10)
    log += fmt::format("2026-03-02 {:02}:{:02};{:.2f}\n", minute / 60, minute % 60, minute == 790 ? peak : 20.0);
  options.temperatures = LogWithTest{"hall.csv", log, {"2026-03-02T13:00", "2026-03-02T14:00", {}, {}}};
  return options;
}

TEST(StatedSurroundings, NothingStatedIsNoEnvironment) {
  const Evaluated evaluated = evaluated_stating({});
  EXPECT_EQ(evaluated.environment(), nullptr);
  EXPECT_EQ(to_json(evaluated).find("environment"), nullptr);
}

TEST(StatedSurroundings, BeyondWhatWasAgreedWithdrawTheClaim) {
  const Evaluated evaluated = evaluated_stating(stating({{"lowest_C", "18.5"},
                                                         {"highest_C", "23"},
                                                         {"agreed_lowest_C", "19"},
                                                         {"agreed_highest_C", "22"},
                                                         {"rate_C_per_h", "0.5"},
                                                         {"agreed_rate_C_per_h", "0.5"}}));
  EXPECT_THAT(ids_against_tested(evaluated), Contains("environment-lowest-exceeded"));
  EXPECT_THAT(ids_against_tested(evaluated), Contains("environment-highest-exceeded"));
  EXPECT_THAT(ids_against_tested(evaluated), Not(Contains("environment-rate-exceeded"))) << "at the limit it is kept";
  EXPECT_THAT(ids_against_tested(evaluated), Contains("environment-rate-before-not-measured"));
  const json::Value result = to_json(evaluated);
  const json::Value* environment = result.find("environment");
  ASSERT_NE(environment, nullptr);
  EXPECT_TRUE(environment->find("exceeded")->boolean());
  EXPECT_TRUE(environment->find("open")->boolean());
}

TEST(StatedSurroundings, KeptAreNoFinding) {
  const Evaluated evaluated = evaluated_stating(stating({{"highest_C", "21"}, {"agreed_highest_C", "22"}}));
  for (const std::string& id : ids_of(evaluated)) EXPECT_FALSE(id.starts_with("environment")) << id;
  EXPECT_FALSE(evaluated.environment()->open());
}

TEST(StatedSurroundings, AgreedAloneIsOpen) {
  const Evaluated evaluated = evaluated_stating(stating({{"agreed_gradient_C", "1"}}));
  EXPECT_THAT(ids_against_tested(evaluated), Contains("environment-gradient-not-measured"));
}

TEST(StatedSurroundings, StandInTheReportAsStated) {
  const Evaluated evaluated = evaluated_stating(stating({{"highest_C", "21"}}));
  const auto section = report::surroundings_section(report_subject(evaluated), {});
  ASSERT_TRUE(section);
  const auto& table = std::get<report::Table>(section->blocks.front());
  EXPECT_THAT(report::plain_text(table.rows[1][1].text), HasSubstr("(stated)"));
  ASSERT_EQ(table.notes.size(), 1u) << "how a log is read is no matter of a statement";
}

TEST(StatedSurroundings, ThatCannotBeAreRefused) {
  EXPECT_THAT(refusal_of({{"lowest_C", "22"}, {"highest_C", "20"}}),
              HasSubstr("found a lowest temperature of the air of 22 °C above the highest of 20 °C"));
  EXPECT_THAT(refusal_of({{"agreed_lowest_C", "22"}, {"agreed_highest_C", "20"}}),
              HasSubstr("found an agreed lowest temperature of 22 °C above the highest of 20 °C"));
  EXPECT_NE(refusal_of({{"rate_C_per_h", "-1"}}), "");
  EXPECT_NE(refusal_of({{"rate_before_C_per_h", "-1"}}), "");
  EXPECT_NE(refusal_of({{"machine_gradient_C", "-0.1"}}), "");
  EXPECT_NE(refusal_of({{"soaked_h", "-1"}}), "");
  EXPECT_NE(refusal_of({{"rate", "1"}}), "") << "in °C per hour or per minute";
  EXPECT_NE(refusal_of({{"highest", "70"}}), "") << "in °C or °F";
  EXPECT_EQ(refusal_of({{"lowest_C", "20"}, {"highest_C", "20"}}), "");
}

TEST(StatedSurroundings, GiveWayToTheLogWhichTellsWhereTheyContradictIt) {
  const Evaluated told = evaluated_stating(with_log(stating({{"highest_C", "21"}, {"agreed_highest_C", "24"}}), 23));
  EXPECT_THAT(ids_against_tested(told), Contains("environment-statement-contradicts"));
  EXPECT_EQ(told.environment()->items[1].measured, 23.0);
  EXPECT_FALSE(told.environment()->items[1].stated);
  const Evaluated alike = evaluated_stating(with_log(stating({{"highest_C", "22.5"}, {"agreed_highest_C", "24"}}), 23));
  EXPECT_THAT(ids_of(alike), Not(Contains("environment-statement-contradicts")));
}

TEST(StatedSurroundings, FillInWhatTheLogDidNotMeasure) {
  const Evaluated evaluated =
      evaluated_stating(with_log(stating({{"machine_gradient_C", "0.8"}, {"agreed_gradient_C", "1"}}), 20));
  EXPECT_EQ(evaluated.environment()->items[4].standing, iso230_2::EnvironmentStanding::kept);
  EXPECT_TRUE(evaluated.environment()->items[4].stated);
}

TEST(StatedSurroundings, BeyondWhatWasAgreedExceedItWhateverTheLogSays) {
  const Evaluated evaluated =
      evaluated_stating(with_log(stating({{"highest_C", "23"}, {"agreed_highest_C", "22"}}), 20));
  EXPECT_THAT(ids_against_tested(evaluated), Contains("environment-highest-exceeded"));
  EXPECT_EQ(evaluated.environment()->items[1].measured, 23.0);
}

TEST(StatedSurroundings, LimitsStatedInTheTestHoldForItsLog) {
  EXPECT_THAT(ids_against_tested(evaluated_stating(with_log(stating({{"agreed_highest_C", "22"}}), 23))),
              Contains("environment-highest-exceeded"));
}

TEST(StatedSurroundings, ContradictTheAirStatedAtTheStart) {
  EXPECT_THAT(ids_of(evaluated_stating(stating({{"air_temperature_start_C", "25"}, {"highest_C", "22"}}))),
              Contains("environment-statement-contradicts"));
  EXPECT_THAT(ids_of(evaluated_stating(stating({{"air_temperature_start_C", "22.5"}, {"highest_C", "22"}}))),
              Not(Contains("environment-statement-contradicts")));
}

/// A hall that is said to have stayed at 22 °C and had 22.6 °C when the test began did not.
TEST(StatedSurroundings, OfTheStartAndTheEndExceedALimitAndAloneKeepNone) {
  const Evaluated warm = evaluated_stating(
      stating({{"highest_C", "22"}, {"agreed_highest_C", "22"}, {"air_temperature_start_C", "22.6"}}));
  EXPECT_THAT(ids_against_tested(warm), Contains("environment-highest-exceeded"));
  EXPECT_EQ(warm.environment()->items[1].measured, 22.6);
  const Evaluated ends = evaluated_stating(
      stating({{"agreed_highest_C", "22"}, {"air_temperature_start_C", "20"}, {"air_temperature_end_C", "20"}}));
  EXPECT_THAT(ids_against_tested(ends), Contains("environment-known-in-part"));
  EvaluateOptions machine = stating({{"agreed_gradient_C", "1"}});
  machine.metadata.insert(machine.metadata.end(),
                          {{"sensors", "machine|Bed|20|"}, {"sensors", "machine|Column|21.5|"}});
  EXPECT_THAT(ids_against_tested(evaluated_stating(machine)), Contains("environment-gradient-exceeded"));
}

}  // namespace
}  // namespace axiometry::app
