// SPDX-License-Identifier: Apache-2.0
#include "axiometry/app/temperatures/evaluated_temperatures.h"

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <string>
#include <variant>

#include "axiometry/app/evaluate/evaluate.h"
#include "axiometry/app/results/report_subject.h"
#include "axiometry/app/results/result_json.h"
#include "axiometry/report/temperatures/temperatures.h"
#include "axiometry/standards/iso230_2/rules/environment_findings.h"
#include "tests/support/series.h"

namespace axiometry::app {
namespace {

using testing::Contains;
using testing::Field;
using testing::HasSubstr;

/// Of a hall, every ten minutes of a day, at that temperature.
std::string day_of_hall(double celsius) {
  std::string log = "time;Air;T1 bed\n";
  for (int minute = 0; minute < 24 * 60; minute += 10)
    log += fmt::format("2026-03-02 {:02}:{:02};{:.2f};{:.2f}\n", minute / 60, minute % 60, celsius, celsius + 1.0);
  return log;
}

/// Two targets, five runs, a reading every 90 s where `timed`; a thermometer that rose by 2 °C.
axiometry::Test hour_of_test(bool timed) {
  std::vector<testing_support::RunDeviations> runs(5, {1.0, 2.0});
  runs[1] = {1.5, 2.25};
  axiometry::Test test{{}, testing_support::make_series({0.0, 100.0}, runs, runs), {}};
  for (std::size_t k = 0; timed && k < 20; ++k) test.times_s.push_back(90.0 * static_cast<double>(k));
  TemperatureSensor sensor;
  sensor.role = "air";
  sensor.location = "hall";
  sensor.start = Temperature::celsius(20);
  sensor.end = Temperature::celsius(22);
  test.metadata.environment.sensors.push_back(sensor);
  return test;
}

LogWithTest log_of(double celsius) { return {"hall.csv", day_of_hall(celsius), {"2026-03-02T13:00", "", {}, {}}}; }

Evaluated evaluated_with(const LogWithTest& log, bool timed = true) {
  EvaluateOptions options;
  options.temperatures = log;
  auto evaluated = evaluate_test(hour_of_test(timed), options);
  EXPECT_TRUE(evaluated) << evaluated.error().message;
  return *std::move(evaluated);
}

TEST(LogWithTest, EndsWithTheReadingsWhereTheyHaveTimes) {
  const Evaluated timed = evaluated_with(log_of(20));
  EXPECT_EQ(timed.temperatures->ended_by_readings, "2026-03-02T13:28:30") << "nineteen steps of 90 s";
  EXPECT_EQ(timed.temperatures->ended, "") << "nobody said so";
  const json::Value result = to_json(timed);
  const json::Value* environment = result.find("environment");
  EXPECT_EQ(environment->find("ended")->kind(), json::Kind::null);
  EXPECT_EQ(environment->find("ended_by_readings")->text(), "2026-03-02T13:28:30");
  EXPECT_TRUE(timed.assessment.temperatures_recorded);
  const auto section = report::surroundings_section(report_subject(timed), {});
  const auto& facts = std::get<report::Facts>(section->blocks.back()).facts;
  EXPECT_EQ(report::plain_text(facts[1].value.text), "2026-03-02T13:28:30 (by the times of the readings)");
  EXPECT_TRUE(timed.temperatures->environment.during->end_told);
  const Evaluated untimed = evaluated_with(log_of(20), false);
  EXPECT_EQ(untimed.temperatures->ended, "");
  EXPECT_EQ(untimed.temperatures->ended_by_readings, "");
  EXPECT_FALSE(untimed.assessment.temperatures_recorded);
  EXPECT_FALSE(untimed.temperatures->environment.during->end_told);
  EXPECT_THAT(untimed.assessment.findings, Contains(Field(&iso230_2::Finding::id, "environment-gap")));
  LogWithTest said = log_of(20);
  said.request.ended = "2026-03-02T14:00";
  const Evaluated told = evaluated_with(said);
  EXPECT_EQ(told.temperatures->ended, "2026-03-02T14:00") << "who says it is believed";
  EXPECT_EQ(told.temperatures->ended_by_readings, "");
}

TEST(LogWithTest, IsJudgedAmongTheFindingsOfTheTest) {
  LogWithTest log = log_of(23);
  log.request.agreed.highest = Temperature::celsius(22);
  const Evaluated exceeded = evaluated_with(log);
  const auto& findings = exceeded.assessment.findings;
  EXPECT_THAT(findings, Contains(testing::AllOf(
                            Field(&iso230_2::Finding::id, "environment-highest-exceeded"),
                            Field(&iso230_2::Finding::severity, iso230_2::Severity::departure),
                            Field(&iso230_2::Finding::message, HasSubstr("highest temperature of the air: 23 °C")))));
  EXPECT_THAT(findings, Contains(Field(&iso230_2::Finding::message, HasSubstr("of the temperature log: "))));
  EXPECT_THAT(findings, Contains(Field(&iso230_2::Finding::id, "temperature-change")));
  log.request.agreed.rate = 0.5;
  EXPECT_THAT(evaluated_with(log).assessment.findings, Contains(Field(&iso230_2::Finding::id, "temperature-change")))
      << "a limit of the air says nothing of sensors of machine and equipment";
  const json::Value result = to_json(exceeded);
  EXPECT_TRUE(result.find("environment")->find("exceeded")->boolean());
  EXPECT_EQ(result.find("environment")->find("source")->find("file")->text(), "hall.csv");
}

TEST(LogWithTest, ContradictsTemperaturesThatAreStated) {
  const auto told = [](double celsius) {
    const Evaluated evaluated = evaluated_with(log_of(celsius));
    return std::ranges::count(evaluated.assessment.findings, "environment-log-contradicts", &iso230_2::Finding::id);
  };
  EXPECT_EQ(told(21), 0) << "20 and 22 °C are stated";
  EXPECT_EQ(told(35), 2) << "at the beginning and at the end";
}

TEST(LogWithTest, ContradictsTemperaturesOfTheMachineOnlyAtTheSamePlace) {
  const auto told = [](const char* role, const char* location, double celsius) {
    axiometry::Test test = hour_of_test(true);
    TemperatureSensor sensor;
    sensor.role = role;
    sensor.location = location;
    sensor.start = Temperature::celsius(celsius);
    test.metadata.environment.sensors = {sensor};
    EvaluateOptions options;
    options.temperatures = log_of(20);
    const auto evaluated = evaluate_test(std::move(test), options);
    return evaluated && std::ranges::any_of(evaluated->assessment.findings, [](const iso230_2::Finding& finding) {
             return finding.id == "environment-log-contradicts";
           });
  };
  EXPECT_FALSE(told("machine", "spindle nut", 27)) << "the log has the bed";
  EXPECT_FALSE(told("machine", "", 27)) << "nobody knows where";
  EXPECT_TRUE(told("machine", "t1 Bed", 27));
  EXPECT_FALSE(told("machine", "t1 Bed", 21));
  EXPECT_TRUE(told("Air", "above the table", 27)) << "the air is one";
}

TEST(LogWithTest, OfAnotherDayIsTold) {
  const auto told = [](const std::string& day) {
    axiometry::Test test = hour_of_test(true);
    test.metadata.conditions.date = day;
    EvaluateOptions options;
    options.temperatures = log_of(20);
    const auto evaluated = evaluate_test(std::move(test), options);
    return evaluated && std::ranges::any_of(evaluated->assessment.findings, [](const iso230_2::Finding& finding) {
             return finding.id == "environment-other-day" && finding.severity == iso230_2::Severity::missing;
           });
  };
  EXPECT_TRUE(told("2014-05-15"));
  EXPECT_FALSE(told("2026-03-02"));
  EXPECT_TRUE(told("2026-03-01"));
  EXPECT_TRUE(told("2026-03-03"));
  EXPECT_FALSE(told("20260302"));
  EXPECT_FALSE(told("05/06/2014")) << "no day that can be read";
  EXPECT_FALSE(told("unknown"));
  EXPECT_FALSE(told("")) << "not stated, which is told elsewhere";
}

TEST(LogWithTest, OfADateThatCannotBeReadIsNoted) {
  axiometry::Test test = hour_of_test(true);
  test.metadata.conditions.date = "05/06/2014";
  EvaluateOptions options;
  options.temperatures = log_of(35);
  const auto evaluated = evaluate_test(test, options);
  ASSERT_TRUE(evaluated);
  EXPECT_TRUE(evaluated->assessment.temperatures_recorded) << "somebody said when the test began";
  EXPECT_THAT(evaluated->assessment.findings,
              Contains(testing::AllOf(Field(&iso230_2::Finding::id, "environment-day-not-read"),
                                      Field(&iso230_2::Finding::severity, iso230_2::Severity::note))));
  EXPECT_THAT(evaluated->assessment.findings, Contains(Field(&iso230_2::Finding::id, "environment-log-contradicts")));
  options.temperatures->request.began = "";
  const auto alone = evaluate_test(test, options);
  ASSERT_TRUE(alone);
  EXPECT_THAT(alone->assessment.findings,
              testing::Not(Contains(Field(&iso230_2::Finding::id, "environment-day-not-read"))))
      << "nobody says that the log is of the test";
}

TEST(LogWithTest, FailsWithTheNameOfTheLog) {
  EvaluateOptions options;
  options.temperatures = LogWithTest{"words.csv", "these are words\n", {}};
  const auto words = evaluate_test(hour_of_test(true), options);
  ASSERT_FALSE(words);
  EXPECT_EQ(words.error().file, "words.csv");
  options.temperatures = log_of(20);
  options.temperatures->request.began = "2026-04-02T13:00";
  const auto elsewhere = evaluate_test(hour_of_test(true), options);
  ASSERT_FALSE(elsewhere);
  EXPECT_THAT(elsewhere.error().message, HasSubstr("expected one of the test or of the twelve hours before it"));
}

}  // namespace
}  // namespace axiometry::app
