// SPDX-License-Identifier: Apache-2.0
#include "axiometry/standards/environment/ambient_course.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <numbers>

#include "axiometry/standards/environment/environment.h"

namespace axiometry {
namespace {

using iso230_2::EnvironmentStanding;

constexpr double hour = 3600.0;

TemperatureCourse course(std::string role, double from_s, double to_s, double step_s,
                         const std::function<double(double)>& celsius) {
  TemperatureCourse made{std::move(role), "T", {}, {}};
  for (double t = from_s; t <= to_s + 1e-9; t += step_s) {
    made.times_s.push_back(t);
    made.celsius.push_back(celsius(t));
  }
  return made;
}

AmbientTemperatures found(std::vector<TemperatureCourse> sensors, std::optional<TimeStretch> test) {
  return ambient_of(sensors, test);
}

TEST(AmbientCourse, OfASteadyRiseHasItsRateBeforeAndDuring) {
  const auto rise = [](double t) { return 20.0 + 0.4 * t / hour; };
  const auto all = found({course("air", 0, 14 * hour, 600, rise)}, TimeStretch{12 * hour, 14 * hour});
  EXPECT_NEAR(*all.rate, 0.4, 1e-9);
  EXPECT_NEAR(*all.rate_before, 0.4, 1e-9);
  EXPECT_NEAR(all.lowest->in_celsius(), 24.8, 1e-9);
  EXPECT_NEAR(all.highest->in_celsius(), 25.6, 1e-9);
  EXPECT_FALSE(all.machine_gradient) << "no sensor on the machine";
}

TEST(AmbientCourse, OfASensorThatNeverDeliveredIsNotKnown) {
  const auto steady = [](double) { return 20.0; };
  const std::vector<TemperatureCourse> sensors = {course("air", 0, 14 * hour, 600, steady), {"air", "dead", {}, {}}};
  const TimeStretch test{12 * hour, 14 * hour};
  const LeastRecorded least = least_recorded(sensors, "air", test);
  EXPECT_EQ(least.recorded_s, 0.0);
  EXPECT_EQ(least.sensor, "dead");
  EXPECT_FALSE(found(sensors, test).rate_of_every_sensor);
  iso230_2::AgreedEnvironment agreed;
  agreed.highest = Temperature::celsius(22);
  const auto environment = iso230_2::test_environment({moment_of("2026-03-02T00:00"), sensors, {}}, test, agreed);
  EXPECT_EQ(environment.items[1].standing, EnvironmentStanding::known_in_part);
}

TEST(AmbientCourse, HasExtremesAtAMoment) {
  const auto rise = [](double t) { return 20.0 + t / hour; };
  const std::vector<TemperatureCourse> sensors = {course("air", 0, 2 * hour, 600, rise),
                                                  course("air", 0, 2 * hour, 600, [](double) { return 25.0; }),
                                                  course("machine", 0, 2 * hour, 600, [](double) { return 40.0; })};
  const auto one = extremes_at(sensors, "air", hour);
  ASSERT_TRUE(one);
  EXPECT_NEAR(one->low, 21.0, 1e-9);
  EXPECT_NEAR(one->high, 25.0, 1e-9);
  EXPECT_FALSE(extremes_at(sensors, "air", 3 * hour)) << "nothing was recorded then";
  EXPECT_FALSE(extremes_at(sensors, "equipment", hour));
}

TEST(AmbientCourse, FindsTheWorstHourBetweenReadings) {
  // Every 50 minutes: within an hour lies a whole step of 1 °C and 10 minutes of the next one, 0.2 °C.
  const auto all = found({course("air", 0, 10 * hour, 3000.0 / 2, [](double t) { return t / 3000.0; })}, std::nullopt);
  EXPECT_NEAR(*all.rate, 1.2, 1e-9);
}

TEST(AmbientCourse, SeesAPeakWhereverItStands) {
  for (const double at : {0.0, 7000.0, 14000.0}) {
    const auto all = found(
        {course("air", 0, 4 * hour, 10, [&](double t) { return std::abs(t - at) < 15 ? 23.0 : 20.0; })}, std::nullopt);
    EXPECT_NEAR(*all.rate, 3.0, 1e-9) << at;
    EXPECT_EQ(all.highest->in_celsius(), 23.0);
  }
}

TEST(AmbientCourse, OfASineIsItsRangeWithinAnHour) {
  const double amplitude = 0.7, period = 5 * hour;
  const auto sine = [&](double t) { return 20.0 + amplitude * std::sin(2 * std::numbers::pi * t / period); };
  const auto all = found({course("air", 0, 10 * hour, 30, sine)}, std::nullopt);
  EXPECT_NEAR(*all.rate, 2 * amplitude * std::sin(std::numbers::pi * hour / period), 1e-5);
}

TEST(AmbientCourse, AShortTestIsLookedAtWithTheTimeBeforeItToAnHour) {
  const auto rise = [](double t) { return t < 12 * hour ? 20.0 : 20.0 + (t - 12 * hour) / hour; };
  const auto all = found({course("air", 0, 13 * hour, 60, rise)}, TimeStretch{12 * hour, 12.5 * hour});
  EXPECT_NEAR(*all.rate, 0.5, 1e-9) << "half an hour of quiet and half an hour of 1 °C/h";
  EXPECT_EQ(*all.rate_before, 0.0);
}

TEST(AmbientCourse, BeginsAnHourBeforeTheTestHoweverLongThatIs) {
  const auto ramp = [](double t) { return 20.0 + 0.9 * std::clamp((t - 11.5 * hour) / hour, 0.0, 1.0); };
  const auto all = found({course("air", 0, 15 * hour, 600, ramp)}, TimeStretch{12 * hour, 14 * hour});
  EXPECT_NEAR(*all.rate, 0.9, 1e-9) << "half of it in the test, half of it in the hour before";
  EXPECT_NEAR(*all.rate_before, 0.45, 1e-9);
  EXPECT_NEAR(all.lowest->in_celsius(), 20.45, 1e-9) << "the extremes are those of the test";
  const auto spike = [](double t) { return std::abs(t - 11.5 * hour) < 300 ? 23.0 : 20.0; };
  const auto before = found({course("air", 0, 15 * hour, 60, spike)}, TimeStretch{12 * hour, 14 * hour});
  EXPECT_NEAR(*before.rate, 3.0, 1e-9) << "from 23 before the test to 20 in it";
  const auto early = [](double t) { return t < 10 * hour ? 23.0 : 20.0; };
  EXPECT_EQ(*found({course("air", 0, 15 * hour, 60, early)}, TimeStretch{12 * hour, 14 * hour}).rate, 0.0);
}

TEST(AmbientCourse, KnowsNoRateBesideExtremesBetweenReadings) {
  auto mean = course("air", 0, 15 * hour, 600, [](double) { return 20.3; }), peak = mean;
  std::ranges::fill(peak.celsius, 26.0);
  peak.location = "Air max";
  const TimeStretch test{12 * hour, 14 * hour};
  iso230_2::AgreedEnvironment agreed;
  agreed.highest = Temperature::celsius(22);
  agreed.lowest = Temperature::celsius(19);
  agreed.rate = 0.5;
  const TemperatureLog log{moment_of("2026-03-02T00:00"), {mean, peak}, {}};
  const auto environment = iso230_2::test_environment(log, test, agreed);
  EXPECT_EQ(environment.items[0].standing, EnvironmentStanding::kept);
  EXPECT_EQ(environment.items[1].standing, EnvironmentStanding::exceeded);
  EXPECT_EQ(environment.items[2].standing, EnvironmentStanding::known_in_part);
  EXPECT_EQ(environment.items[3].standing, EnvironmentStanding::known_in_part);
}

TEST(AmbientCourse, OfHalfAnHourInSixtyIsNotKnown) {
  auto hall = course("air", 0, 40 * hour, 300, [](double) { return 20.0; });
  const auto later = course("air", 40 * hour + 2100, 90 * hour, 300, [](double) { return 20.0; });
  hall.times_s.insert(hall.times_s.end(), later.times_s.begin(), later.times_s.end());
  hall.celsius.insert(hall.celsius.end(), later.celsius.begin(), later.celsius.end());
  iso230_2::AgreedEnvironment agreed;
  agreed.highest = Temperature::celsius(22);
  const auto environment = iso230_2::test_environment({moment_of("2026-03-02T00:00"), {hall}, {}},
                                                      TimeStretch{20 * hour, 80 * hour}, agreed);
  EXPECT_EQ(environment.items[1].standing, EnvironmentStanding::known_in_part) << "a gap of 35 minutes";
}

TEST(AmbientCourse, ExtrapolatesLessThanAnHourToTheSafeSideAndSaysNothingOfMinutes) {
  const auto rise = [](double t) { return 20.0 + t / hour; };
  EXPECT_NEAR(*found({course("air", 0, 0.5 * hour, 60, rise)}, std::nullopt).rate, 1.0, 1e-9);
  EXPECT_FALSE(found({course("air", 0, 540, 60, rise)}, std::nullopt).rate);
}

TEST(AmbientCourse, KnowsNothingOfGaps) {
  auto broken = course("air", 0, 5 * hour, 600, [](double) { return 20.0; });
  const auto later = course("air", 8 * hour, 13 * hour, 600, [](double) { return 26.0; });
  broken.times_s.insert(broken.times_s.end(), later.times_s.begin(), later.times_s.end());
  broken.celsius.insert(broken.celsius.end(), later.celsius.begin(), later.celsius.end());
  const auto all = found({broken}, TimeStretch{12 * hour, 13 * hour});
  EXPECT_NEAR(least_recorded(std::vector{broken}, "air", {0, 12 * hour}).recorded_s, 9.0 * hour, 1e-6);
  EXPECT_EQ(*all.rate_before, 0.0) << "what happened in the gap is not known";
  const auto in_gap = found({broken}, TimeStretch{5.5 * hour, 7.5 * hour});
  EXPECT_FALSE(in_gap.lowest);
  EXPECT_FALSE(in_gap.rate);
}

/// One sensor, what it recorded in two parts.
TemperatureCourse joined(TemperatureCourse first, const TemperatureCourse& second) {
  first.times_s.insert(first.times_s.end(), second.times_s.begin(), second.times_s.end());
  first.celsius.insert(first.celsius.end(), second.celsius.begin(), second.celsius.end());
  return first;
}

TEST(AmbientCourse, TakesNoRateOfTheTestFromWhatEndedBeforeIt) {
  const double nine = 9 * hour;
  const auto quiet = course("air", nine - 3120, nine - 1920, 60, [](double) { return 20.0; });
  const auto steep = course("air", nine, nine + 480, 60, [&](double t) { return 20.0 + (t - nine) / 100.0; });
  const TimeStretch test{nine, nine + 480};
  const auto all = found({joined(quiet, steep)}, test);
  EXPECT_FALSE(all.rate) << "eight minutes tell none, and what was before a gap is none of the test";
  EXPECT_FALSE(all.rate_of_every_sensor);
  EXPECT_NEAR(all.highest->in_celsius(), 24.8, 1e-9);
  const auto level = course("air", 0, nine + 480, 60, [](double) { return 20.0; });
  const auto both = found({joined(quiet, steep), level}, test);
  EXPECT_EQ(*both.rate, 0.0);
  EXPECT_FALSE(both.rate_of_every_sensor) << "the other one may have changed by more";
  EXPECT_TRUE(found({level}, test).rate_of_every_sensor);
}

TEST(LeastRecorded, IsOfTheSensorThatRecordedLeastAndNamesIt) {
  const auto level = [](double) { return 20.0; };
  auto bed = course("machine", 0, 4 * hour, 600, level), column = course("machine", 0, hour, 600, level);
  bed.location = "Bed", column.location = "Column";
  const TimeStretch test{0, 4 * hour};
  const std::vector sensors{bed, column, course("air", 0, 600, 60, level)};
  const LeastRecorded least = least_recorded(sensors, "machine", test);
  EXPECT_NEAR(least.recorded_s, hour, 1e-6);
  EXPECT_EQ(least.sensor, "Column");
  EXPECT_EQ(least_recorded(sensors, "air", test).sensor, "") << "there is no other";
  EXPECT_EQ(least_recorded(sensors, "equipment", test).recorded_s, 0.0);
}

TEST(AmbientCourse, TakesTheWorstOfSeveralSensorsOfTheAirAndNoneOfOthers) {
  const auto level = [](double celsius) { return [=](double t) { return celsius + (t > 2 * hour ? 0.1 : 0.0); }; };
  const auto all = found({course("air", 0, 4 * hour, 60, level(19.5)), course("air", 0, 4 * hour, 60, level(21.0)),
                          course("equipment", 0, 4 * hour, 60, level(30.0))},
                         std::nullopt);
  EXPECT_EQ(all.lowest->in_celsius(), 19.5);
  EXPECT_EQ(all.highest->in_celsius(), 21.1);
  EXPECT_FALSE(found({course("machine", 0, 4 * hour, 60, level(20))}, std::nullopt).lowest);
}

TEST(AmbientCourse, TheGradientIsTheLargestDifferenceAtOneMoment) {
  const auto warm = [](double t) { return 20.0 + t / hour; };
  const auto late = [](double t) { return 19.0 + std::max(0.0, t / hour - 1.0); };
  const auto all =
      found({course("machine", 0, 3 * hour, 600, warm), course("machine", 300, 3 * hour, 700, late)}, std::nullopt);
  EXPECT_NEAR(all.machine_gradient->in_kelvin(), 2.0, 0.03) << "not the range of both over time, 4";
  EXPECT_FALSE(
      found({course("machine", 0, hour, 600, warm), course("machine", 2 * hour, 3 * hour, 600, late)}, std::nullopt)
          .machine_gradient)
      << "never known at one moment";
}

TemperatureLog log_of(std::vector<TemperatureCourse> sensors) { return {moment_of("2026-03-02T00:00"), sensors, {}}; }

TEST(TestInLog, IsPlacedByItsMoments) {
  const auto log = log_of({course("air", 0, 14 * hour, 600, [](double) { return 20.0; })});
  const auto at = [&](const char* began, const char* ended) {
    return test_in_log(moment_of(began), moment_of(ended), log);
  };
  EXPECT_EQ(at("2026-03-02T12:00", "2026-03-02T13:00")->begin_s, 12 * hour);
  EXPECT_EQ(at("2026-03-02T12:00", "2026-03-02T13:00")->end_s, 13 * hour);
  EXPECT_EQ(at("2026-03-02T12:00", "")->end_s, 14 * hour) << "to the end of the log";
  EXPECT_FALSE(at("2026-03-02T12:00", "")->end_told);
  EXPECT_TRUE(at("2026-03-02T12:00", "2026-03-02T13:00")->end_told);
  EXPECT_EQ(at("2026-03-02T16:00", "")->length_s(), 0.0) << "behind the end of the log";
  EXPECT_FALSE(at("2026-03-02T12:00", "2026-03-02T12:00")) << "no time at all";
  EXPECT_FALSE(at("", "2026-03-02T13:00"));
  EXPECT_FALSE(at("2026-03-02T13:00", "2026-03-02T12:00"));
  EXPECT_FALSE(at("2026-03-02T12:00Z", "2026-03-02T13:00Z")) << "a zone against none";
}

EnvironmentStanding standing(const iso230_2::TestEnvironment& environment, std::string_view key) {
  for (const auto& item : environment.items)
    if (item.key == key) return item.standing;
  ADD_FAILURE() << key;
  return EnvironmentStanding::kept;
}

TEST(EnvironmentOfATest, NeverCallsKeptWhatWasNotMeasured) {  // 4.1, 7
  iso230_2::AgreedEnvironment agreed;
  agreed.lowest = Temperature::celsius(19);
  agreed.highest = Temperature::celsius(22);
  agreed.rate = 0.5;
  agreed.machine_gradient = TemperatureDifference::kelvin(1);
  const auto level = [](double) { return 20.0; };
  const TimeStretch test{12 * hour, 13 * hour};
  const auto whole = iso230_2::test_environment(log_of({course("air", 0, 13 * hour, 600, level)}), test, agreed);
  EXPECT_EQ(standing(whole, "lowest_C"), EnvironmentStanding::kept);
  EXPECT_EQ(standing(whole, "rate_before_C_per_h"), EnvironmentStanding::kept);
  EXPECT_EQ(standing(whole, "machine_gradient_C"), EnvironmentStanding::not_measured);
  EXPECT_TRUE(whole.open()) << "a limit was agreed on what nobody measured";
  EXPECT_FALSE(whole.exceeded());
  const auto late =
      iso230_2::test_environment(log_of({course("air", 4 * hour, 12.5 * hour, 600, level)}), test, agreed);
  EXPECT_EQ(standing(late, "highest_C"), EnvironmentStanding::known_in_part);
  EXPECT_EQ(standing(late, "rate_before_C_per_h"), EnvironmentStanding::known_in_part);
  const auto unplaced =
      iso230_2::test_environment(log_of({course("air", 0, 13 * hour, 600, level)}), std::nullopt, agreed);
  EXPECT_EQ(standing(unplaced, "highest_C"), EnvironmentStanding::known_in_part);
  EXPECT_EQ(standing(unplaced, "rate_before_C_per_h"), EnvironmentStanding::not_measured);
  const auto none = iso230_2::test_environment(log_of({course("machine", 0, 13 * hour, 600, level)}), test, agreed);
  EXPECT_EQ(standing(none, "lowest_C"), EnvironmentStanding::not_measured);
}

TEST(EnvironmentOfATest, NeverCallsKeptWhatMayHaveLastedLonger) {
  iso230_2::AgreedEnvironment agreed;
  agreed.highest = Temperature::celsius(22);
  agreed.rate = 0.5;
  agreed.machine_gradient = TemperatureDifference::kelvin(1);
  const auto level = [](double) { return 20.0; };
  const auto log = log_of({course("air", 0, 13 * hour, 600, level), course("machine", 0, 13 * hour, 600, level),
                           course("machine", 0, 13 * hour, 600, level)});
  const auto endless =
      iso230_2::test_environment(log, test_in_log(moment_of("2026-03-02T12:30"), std::nullopt, log), agreed);
  for (const char* key : {"highest_C", "rate_C_per_h", "machine_gradient_C"})
    EXPECT_EQ(standing(endless, key), EnvironmentStanding::known_in_part) << key;
  EXPECT_EQ(standing(endless, "rate_before_C_per_h"), EnvironmentStanding::kept) << "the beginning was told";
  EXPECT_TRUE(endless.open());
  EXPECT_FALSE(endless.during->complete());
  EXPECT_TRUE(endless.during->gapless());
  const auto behind =
      iso230_2::test_environment(log, test_in_log(moment_of("2026-03-02T14:00"), std::nullopt, log), agreed);
  EXPECT_FALSE(behind.during->gapless());
  EXPECT_EQ(standing(behind, "highest_C"), EnvironmentStanding::not_measured);
}

TEST(EnvironmentOfATest, ExceedsALimitFromTheFirstThousandthOn) {
  iso230_2::AgreedEnvironment agreed;
  agreed.highest = Temperature::celsius(22);
  agreed.lowest = Temperature::celsius(19);
  const auto standing_at = [&](double celsius, std::string_view key) {
    return standing(
        iso230_2::test_environment(log_of({course("air", 0, 13 * hour, 600, [&](double) { return celsius; })}),
                                   TimeStretch{12 * hour, 13 * hour}, agreed),
        key);
  };
  EXPECT_EQ(standing_at(22.0, "highest_C"), EnvironmentStanding::kept) << "at the limit";
  EXPECT_EQ(standing_at(22.001, "highest_C"), EnvironmentStanding::exceeded);
  EXPECT_EQ(standing_at(19.0, "lowest_C"), EnvironmentStanding::kept);
  EXPECT_EQ(standing_at(18.999, "lowest_C"), EnvironmentStanding::exceeded);
  EXPECT_EQ(standing_at(22.0, "rate_C_per_h"), EnvironmentStanding::not_agreed);
}

TEST(EnvironmentOfATest, ExceedsALimitAlsoWhereOnlyAPartWasRecorded) {
  iso230_2::AgreedEnvironment agreed;
  agreed.highest = Temperature::celsius(22);
  const auto part =
      iso230_2::test_environment(log_of({course("air", 12 * hour, 12.2 * hour, 60, [](double) { return 23.0; })}),
                                 TimeStretch{12 * hour, 14 * hour}, agreed);
  EXPECT_EQ(standing(part, "highest_C"), EnvironmentStanding::exceeded);
  EXPECT_TRUE(part.exceeded());
}

TEST(EnvironmentOfATest, ExceedsNoLimitByWhatMayHaveBeenOutsideTheTest) {
  iso230_2::AgreedEnvironment agreed;
  agreed.highest = Temperature::celsius(22);
  agreed.rate = 0.5;
  agreed.machine_gradient = TemperatureDifference::kelvin(1);
  const auto late = [](double from_s) { return [=](double t) { return t < from_s ? 20.0 : 26.0; }; };
  const auto log =
      log_of({course("air", 0, 20 * hour, 600, late(16 * hour)), course("machine", 0, 20 * hour, 600, late(16 * hour)),
              course("machine", 0, 20 * hour, 600, [](double) { return 20.0; })});
  const auto began = moment_of("2026-03-02T12:30");
  const auto open_ended = test_in_log(began, std::nullopt, log);
  for (const auto& test : {open_ended, std::optional<TimeStretch>{}}) {
    const auto found = iso230_2::test_environment(log, test, agreed);
    for (const char* key : {"highest_C", "rate_C_per_h", "machine_gradient_C"})
      EXPECT_EQ(standing(found, key), EnvironmentStanding::known_in_part) << key;
    EXPECT_FALSE(found.exceeded());
    EXPECT_TRUE(found.open());
    EXPECT_TRUE(found.items[1].perhaps_exceeded);
    EXPECT_EQ(iso230_2::gaps_of(found).back(),
              "an agreed limit was exceeded, and nobody can say whether that was during the test");
  }
  const auto told = iso230_2::test_environment(log, test_in_log(began, moment_of("2026-03-02T18:00"), log), agreed);
  for (const char* key : {"highest_C", "rate_C_per_h", "machine_gradient_C"})
    EXPECT_EQ(standing(told, key), EnvironmentStanding::exceeded) << key;
}

TEST(EnvironmentOfATest, ExceedsALimitByWhatWasAtItsBeginningAndBeforeWithoutItsEnd) {
  iso230_2::AgreedEnvironment agreed;
  agreed.highest = Temperature::celsius(22);
  agreed.rate = 0.5;
  const auto log = log_of({course("air", 0, 20 * hour, 600, [](double t) { return 14.0 + t / hour; })});
  const auto found =
      iso230_2::test_environment(log, test_in_log(moment_of("2026-03-02T12:30"), std::nullopt, log), agreed);
  EXPECT_EQ(standing(found, "highest_C"), EnvironmentStanding::exceeded);
  EXPECT_NEAR(*found.items[1].measured, 26.5, 1e-9) << "at the beginning; the 34 at the end of the log are not told";
  EXPECT_EQ(standing(found, "rate_before_C_per_h"), EnvironmentStanding::exceeded);
  EXPECT_EQ(standing(found, "rate_C_per_h"), EnvironmentStanding::known_in_part);
}

TEST(EnvironmentOfATest, IsKnownByTheSensorThatRecordedLeast) {
  iso230_2::AgreedEnvironment agreed;
  agreed.highest = Temperature::celsius(22);
  agreed.rate = 0.5;
  agreed.machine_gradient = TemperatureDifference::kelvin(1);
  const auto level = [](double) { return 20.0; };
  const TimeStretch test{12 * hour, 16 * hour};
  auto dead = course("machine", 0, 12.5 * hour, 600, level), hall = course("air", 0, 16 * hour, 600, level);
  dead.location = "Column";
  const auto bed = course("machine", 0, 16 * hour, 600, level);
  const auto gradient = iso230_2::test_environment(log_of({hall, bed, bed, dead}), test, agreed);
  EXPECT_EQ(standing(gradient, "machine_gradient_C"), EnvironmentStanding::known_in_part);
  EXPECT_EQ(standing(gradient, "highest_C"), EnvironmentStanding::kept);
  EXPECT_TRUE(gradient.ends_recorded);
  ASSERT_EQ(iso230_2::gaps_of(gradient).size(), 1u);
  EXPECT_EQ(iso230_2::gaps_of(gradient)[0],
            "temperature sensor \"Column\" recorded 0.50 h of the 4.00 h of the test; what it was there in the rest is "
            "not known");
  dead.role = "air";
  const auto air = iso230_2::test_environment(log_of({hall, dead}), test, agreed);
  for (const char* key : {"highest_C", "rate_C_per_h"})
    EXPECT_EQ(standing(air, key), EnvironmentStanding::known_in_part) << key;
  EXPECT_EQ(standing(air, "rate_before_C_per_h"), EnvironmentStanding::kept);
  EXPECT_EQ(air.during->sensor, "Column");
  auto late = course("air", 6 * hour, 16 * hour, 600, level);
  late.location = "Late";
  const auto before = iso230_2::test_environment(log_of({hall, late}), test, agreed);
  EXPECT_EQ(standing(before, "rate_before_C_per_h"), EnvironmentStanding::known_in_part);
  EXPECT_EQ(iso230_2::gaps_of(before).back(),
            "temperature sensor \"Late\" recorded 6.00 h of the twelve hours before the test, of which clause 4.1 asks "
            "for all");
}

}  // namespace
}  // namespace axiometry
