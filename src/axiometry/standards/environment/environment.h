// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "axiometry/base/quantity.h"
#include "axiometry/base/text/number_text.h"
#include "axiometry/model/metadata.h"
#include "axiometry/model/surroundings.h"
#include "axiometry/model/temperatures.h"
#include "axiometry/standards/environment/ambient_course.h"

/// The temperature of the surroundings (4.1) against what the parties agreed on it (7): stated by who tested, or found
/// from a log.
namespace axiometry::iso230_2 {

using axiometry::AgreedEnvironment;

/// How a quantity stands. What was not measured is never kept.
enum class EnvironmentStanding {
  kept,
  exceeded,
  not_measured,   ///< whether a limit was agreed or not
  not_agreed,     ///< measured, and no limit to hold it against
  known_in_part,  ///< a part of the time was not recorded, or nobody can say that the test was when it was exceeded
};

std::string_view standing_key(EnvironmentStanding standing);   ///< "not-measured"
std::string_view standing_text(EnvironmentStanding standing);  ///< "not measured"

struct EnvironmentItem {
  std::string_view key;    ///< key of what was measured, "highest_C"
  std::string_view title;  ///< "Highest ambient temperature"
  std::string_view unit;   ///< "°C" or "°C/h"
  std::string_view clause;
  bool lower_limit = false;  ///< whether it must not lie below the limit, else not above
  std::optional<double> measured;
  std::optional<double> agreed;
  EnvironmentStanding standing = EnvironmentStanding::not_measured;
  bool stated = false;            ///< whether `measured` is the word of who tested, and no log's
  bool perhaps_exceeded = false;  ///< known in part, and exceeded at a time that nobody knows to be of the test
};

/// How much of a stretch of time was recorded by the sensor that recorded least, h.
struct RecordedShare {
  double recorded_h = 0.0;
  double whole_h = 0.0;
  bool end_told = true;  ///< whether the end of the stretch is told; else whole_h is only what is known of it
  std::string sensor{};  ///< name of the sensor that recorded no more than this, where others did

  /// All of what is known of the stretch, but for a minute.
  bool gapless() const;
  /// All of the stretch: never where nobody told its end.
  bool complete() const { return end_told && gapless(); }
};

struct TestEnvironment {
  /// Lowest, highest, °C/h during the test and in the twelve hours before, gradient over the machine: always all five.
  std::vector<EnvironmentItem> items;
  std::optional<RecordedShare> during;      ///< recorded share of the test, where a log tells when it was
  std::optional<RecordedShare> before;      ///< recorded share of the twelve hours before it, where known
  std::optional<RecordedShare> on_machine;  ///< recorded share of the test by the sensors on the machine, if two
  bool placed = false;                      ///< whether it is known when the test was, or all is stated of the test
  bool ends_recorded = false;               ///< whether the temperature of the air is known at its start and at its end
  std::optional<double> soaked_h{};         ///< h, as stated

  /// Whether any limit is exceeded.
  bool exceeded() const;
  /// Whether a limit was agreed and nobody can say that it was kept.
  bool open() const;
};

/// By the log, of the test within it; without one all of the log counts as the test, and nothing is known of before it.
/// Where nobody told its end, nothing of the test is kept, and what may have been after it exceeds no limit; nor does
/// anything where nobody said when the test was.
TestEnvironment test_environment(const TemperatureLog& log, const std::optional<TimeStretch>& test,
                                 const AgreedEnvironment& agreed);

/// By what is stated alone, where there is no log.
TestEnvironment stated_environment(const Metadata& stated);

/// Of both, by a log and stated: what the log measured is the figure of record, and what it did not is as stated. But a
/// statement beyond the agreed limit exceeds it whatever the log says: who tested knows of something that it missed.
/// Temperatures of the air and of the machine at the start and at the end of the test are of a part of it: they exceed
/// a limit, whatever is stated of the whole, and alone keep none.
TestEnvironment with_statement(TestEnvironment environment, const Metadata& stated);

/// What is stated as a figure of each item, in their order.
std::vector<std::optional<double>> stated_figures(const StatedEnvironment& stated);

/// What of the time was not recorded, and that nobody said when the test was or when it ended; sentences without full
/// stop.
std::vector<std::string> time_gaps_of(const TestEnvironment& environment, const NumberStyle& numbers = {});

/// These, and that a limit was exceeded when nobody can say whether the test was.
std::vector<std::string> gaps_of(const TestEnvironment& environment, const NumberStyle& numbers = {});

/// A log that was held against what was agreed, with where it comes from.
struct LoggedEnvironment {
  std::string file;  ///< as the user gave it
  std::string sha256;
  std::string began;  ///< beginning of the test, as asked; may be empty
  std::string ended;  ///< end of the test, as asked; may be empty
  TemperatureLog log;
  std::optional<TimeStretch> test;  ///< time of the test within the log; absent: all of it counts as the test
  TestEnvironment environment;
  std::string ended_by_readings{};  ///< moment that the times of the readings tell, where nobody told its end
};

}  // namespace axiometry::iso230_2
