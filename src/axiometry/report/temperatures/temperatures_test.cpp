// SPDX-License-Identifier: Apache-2.0
#include "axiometry/report/temperatures/temperatures.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <functional>

#include "axiometry/report/figures/figure_rules_test_support.h"
#include "axiometry/report/figures/parts/ink.h"
#include "axiometry/report/translated.h"
#include "axiometry/report/writer.h"

namespace axiometry::report {
namespace {

using testing::fault_of;
using ::testing::HasSubstr;

constexpr double hour = 3600.0;

struct Logged {
  TemperatureLog log;
  std::optional<TimeStretch> test;
  iso230_2::AgreedEnvironment agreed;
  iso230_2::TestEnvironment environment{};
  Options options{};

  TemperatureSubject subject() {
    environment = iso230_2::test_environment(log, test, agreed);
    return {"hall.csv", "00ff", "2026-03-02T12:00", "", log, test, environment};
  }
};

TemperatureCourse air(double to_s, double step_s, const std::function<double(double)>& celsius) {
  TemperatureCourse course{"air", "Hall", {}, {}};
  for (double t = 0.0; t <= to_s + 1e-9; t += step_s) {
    course.times_s.push_back(t);
    course.celsius.push_back(celsius(t));
  }
  return course;
}

Logged day() {
  Logged logged{{moment_of("2026-03-02T00:00"), {air(13 * hour, 600, [](double t) { return 20 + t / hour / 10; })}, {}},
                TimeStretch{12 * hour, 13 * hour},
                {}};
  logged.agreed.highest = Temperature::celsius(22);
  return logged;
}

/// Lines in the colour of the air, but those of the legend.
std::vector<Path> courses_in(const Figure& figure) {
  std::vector<Path> found;
  for (const Operation& operation : figure.operations)
    if (const Path* path = std::get_if<Path>(&operation);
        path != nullptr && path->stroke.colour == plot::ink::blue && path->points.size() > 2)
      found.push_back(*path);
  return found;
}

TEST(TemperatureFigure, KeepsTheRulesOfFiguresAndShowsTestAndLimit) {
  Logged logged = day();
  const Figure figure = temperature_figure(logged.subject(), logged.options);
  EXPECT_EQ(fault_of(figure), "");
  const auto words = testing::all_words(figure);
  EXPECT_THAT(words, ::testing::Contains(HasSubstr("time of the test")));
  EXPECT_THAT(words, ::testing::Contains(HasSubstr("agreed limit")));
  EXPECT_THAT(words, ::testing::Contains("Hall (air)"));
  logged.test.reset();
  logged.agreed = {};
  const auto without = testing::all_words(temperature_figure(logged.subject(), logged.options));
  EXPECT_THAT(without, ::testing::Not(::testing::Contains(HasSubstr("time of the test"))));
  EXPECT_THAT(without, ::testing::Not(::testing::Contains(HasSubstr("agreed limit"))));
}

TEST(TemperatureFigure, KeepsEveryExtremeOfManyReadings) {
  Logged logged = day();
  logged.log.sensors = {air(13 * hour, 1, [](double t) { return t == 20000.0 ? 25.0 : t == 30001.0 ? 15.0 : 20.0; })};
  const auto courses = courses_in(temperature_figure(logged.subject(), logged.options));
  ASSERT_EQ(courses.size(), 1u);
  EXPECT_LT(courses[0].points.size(), 1500u);
  double highest = 1e9, lowest = -1e9, usual = courses[0].points.front().y;
  for (const Point& p : courses[0].points) highest = std::min(highest, p.y), lowest = std::max(lowest, p.y);
  EXPECT_NEAR(usual - highest, lowest - usual, 1e-6) << "5 °C above and 5 °C below";
  EXPECT_GT(usual - highest, 20.0);
}

TEST(TemperatureFigure, DrawsNothingWhereNothingWasRecorded) {
  Logged logged = day();
  auto& course = logged.log.sensors[0];
  for (std::size_t k = 0; k < course.times_s.size(); ++k)
    if (k >= 40) course.times_s[k] += 2 * hour;
  EXPECT_EQ(courses_in(temperature_figure(logged.subject(), logged.options)).size(), 2u);
}

TEST(TemperatureFigure, IsDrawnOfASingleReadingToo) {
  Logged logged = day();
  logged.log.sensors = {air(0, 1, [](double) { return 20.0; })};
  logged.test.reset();
  EXPECT_EQ(fault_of(temperature_figure(logged.subject(), logged.options)), "");
}

TEST(TemperatureDocument, SaysWhatIsNotKnown) {
  Logged logged = day();
  const Document kept = compose(logged.subject(), logged.options);
  EXPECT_EQ(kept.running_status, "The agreed limits were kept");
  logged.agreed.machine_gradient = TemperatureDifference::kelvin(1);
  EXPECT_EQ(compose(logged.subject(), logged.options).running_status, "Not known whether every agreed limit was kept");
  logged.agreed.highest = Temperature::celsius(21);
  EXPECT_EQ(compose(logged.subject(), logged.options).running_status, "An agreed limit is exceeded");
  logged.agreed = {};
  EXPECT_EQ(compose(logged.subject(), logged.options).running_status, "No limits were agreed");
  logged.test = TimeStretch{12 * hour, 15 * hour};
  const auto gaps = iso230_2::gaps_of(iso230_2::test_environment(logged.log, logged.test, {}));
  ASSERT_EQ(gaps.size(), 1u);
  EXPECT_THAT(gaps[0], HasSubstr("recorded in 1.00 h of the 3.00 h of the test"));
}

TEST(TemperatureDocument, SaysThatNobodyToldTheEndOfTheTest) {
  Logged logged = day();
  logged.test = TimeStretch{12 * hour, 13 * hour, false};
  EXPECT_EQ(compose(logged.subject(), logged.options).running_status, "Not known whether every agreed limit was kept");
  EXPECT_THAT(iso230_2::gaps_of(logged.environment),
              ::testing::ElementsAre("nobody said when the test ended: the end of the log is taken for it"));
  logged.test = TimeStretch{13.5 * hour, 13.5 * hour, false};
  logged.subject();
  EXPECT_THAT(iso230_2::gaps_of(logged.environment),
              ::testing::ElementsAre("nobody said when the test ended, and the log ends no later than the test began",
                                     HasSubstr("of the twelve hours before the test")));
}

TEST(TemperatureDocument, ShowsALimitThatIsExceededByLittle) {
  iso230_2::EnvironmentItem item{"highest_C", "Highest temperature of the air", "°C", "7", false, 22.0004, 22.0};
  EXPECT_EQ(measured_text(item, {}), "22.0004\u00a0°C");
  item.measured = 21.5;
  EXPECT_EQ(measured_text(item, {}), "21.50\u00a0°C");
  EXPECT_EQ(agreed_text(item, {}), "at most 22 °C");
  item.lower_limit = true;
  item.agreed = 18.5;
  EXPECT_EQ(agreed_text(item, {.numbers = {','}}), "at least 18,5 °C");
}

TEST(TemperatureDocument, SaysInItsTablesForSpreadsheetsWhatIsNotKnown) {
  Logged logged = day();
  const auto written = [&] {
    return find_writer("csv")->set(translated(compose(logged.subject(), logged.options), logged.options), {}).value();
  };
  EXPECT_THAT(written(), ::testing::Not(HasSubstr("What is not known")));
  logged.test = TimeStretch{12 * hour, 15 * hour};
  EXPECT_THAT(written(), HasSubstr("What is not known\r\n"));
  EXPECT_THAT(written(),
              HasSubstr("The temperature of the air was recorded in 1.00 h of the 3.00 h of the test; what"));
  logged.options.language = language::Language::german;
  EXPECT_THAT(written(), HasSubstr("Die Lufttemperatur ist in 1.00 h der 3.00 h der Prüfung aufgezeichnet"));
}

}  // namespace
}  // namespace axiometry::report
