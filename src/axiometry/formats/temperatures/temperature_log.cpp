// SPDX-License-Identifier: Apache-2.0
#include "axiometry/formats/temperatures/temperature_log.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <map>

#include "axiometry/base/read_budget.h"
#include "axiometry/base/text/number_text.h"
#include "axiometry/base/text/text.h"
#include "axiometry/formats/recordings/sample_columns.h"
#include "axiometry/formats/temperatures/log_columns.h"
#include "axiometry/formats/temperatures/sensor_role.h"
#include "axiometry/formats/text/decoded_text.h"
#include "axiometry/formats/text/text_lines.h"
#include "axiometry/model/sensor_extremes.h"

namespace axiometry::formats {
namespace {

constexpr std::size_t sensors_max = 64;
constexpr std::size_t line_bytes_max = std::size_t{16} << 10;  // lines of 64 sensors have 2 KiB
constexpr std::size_t preamble_max = 200;                      // lines above the readings
constexpr double coldest = -60.0, hottest = 100.0;
constexpr double day_s = 86400.0;
constexpr double unix_from = 1e8, unix_ms_from = 1e11;  // 1973 in seconds; numbers of that size count from 1970
constexpr double unix_to_s = 7289654400.0;              // end of 2200, as of written moments
constexpr std::string_view role_words[] = {"machine", "equipment", "air", "none"};

/// What is told of sensors whose role follows from their names.
struct NamedRole {
  std::string_view role;
  std::string_view one, several;
};
constexpr NamedRole named_roles[] = {
    {"air", "temperature sensor {} is taken for one of the air by its name",
     "temperature sensors {} are taken for ones of the air by their names"},
    {"machine", "temperature sensor {} is taken for one of the machine by its name",
     "temperature sensors {} are taken for ones of the machine by their names"},
    {"equipment", "temperature sensor {} is taken for one of the equipment by its name",
     "temperature sensors {} are taken for ones of the equipment by their names"},
};

class LogReader {
 public:
  Result<TemperatureLog> read(std::string_view text, const SensorRoles& roles) {
    AXIOMETRY_TRY_VOID(read_lines(text));
    AXIOMETRY_TRY_VOID(order_times());
    return log_of(roles);
  }

  Result<std::vector<std::string>> sensors(std::string_view text) {
    AXIOMETRY_TRY_VOID(read_lines(text, Reads::columns));
    std::vector<std::string> names;
    for (const LogColumn& column : columns_->temperatures) names.push_back(column.name);
    return names;
  }

 private:
  enum class Reads { columns, all };

  Result<void> read_lines(std::string_view text, Reads reads = Reads::all) {
    std::size_t preamble = 0;
    for (const TextLine& line : content_lines(text)) {
      if (line.text.front() == '#' || line.text.front() == '%') continue;
      if (line.text.size() > line_bytes_max)
        return fail(fmt::format("found a line of {} bytes in a temperature log, expected at most {}", line.text.size(),
                                line_bytes_max),
                    {line.number, line.column});
      if (!columns_) {
        AXIOMETRY_TRY_VOID(seek_columns(line));
        if (!columns_ && ++preamble > preamble_max) break;
        if (!columns_) continue;
        if (reads == Reads::columns) return {};
      }
      AXIOMETRY_TRY_VOID(take(line));
    }
    if (columns_) return {};
    if (!no_temperatures_.empty())
      return fail(
          fmt::format("found {} beside the time in a temperature log, expected a column that says that it is a "
                      "temperature, by its name or by a unit such as [°C]",
                      fmt::join(no_temperatures_, ", ")));
    return fail(
        "found no line of a time and a temperature, expected a temperature log such as 'time;air [°C]' with "
        "lines below it");
  }

  Result<void> seek_columns(const TextLine& line) {
    auto found = log_columns(line.text, above_);
    if (!found) return fail(found.error().message, {line.number, line.column});
    if (*found && (*found)->temperatures.empty()) {
      // The header stays above: without it the next line's humidity would be a temperature.
      if (no_temperatures_.empty())
        for (const std::string& head : (*found)->other_numbers) no_temperatures_.push_back(text::quoted(head));
      return {};
    }
    above_ = line.text;
    columns_ = *std::move(found);
    if (!columns_) return {};
    if (columns_->temperatures.size() > sensors_max)
      return fail(fmt::format("found {} sensors in a temperature log, expected at most {}",
                              columns_->temperatures.size(), sensors_max),
                  {line.number, line.column});
    values_.resize(columns_->temperatures.size());
    missing_.resize(values_.size());
    beyond_.resize(values_.size());
    return {};
  }

  Result<void> take(const TextLine& line) {
    const auto cells = log_cells(line.text, columns_->delimiter);
    const auto time = time_of(cells);
    if (!time)
      return fail(
          fmt::format("found {}, expected a time and temperatures as in the lines before", text::quoted(line.text)),
          {line.number, line.column});
    if (auto checked = check_zones(cells, columns_->zones); !checked)
      return fail(std::move(checked).error().message, {line.number, line.column});
    times_.push_back(*time);
    lines_.push_back(line.number);
    for (std::size_t k = 0; k < columns_->temperatures.size(); ++k) {
      const LogColumn& column = columns_->temperatures[k];
      const std::string_view cell = column.place < cells.size() ? cells[column.place] : std::string_view{};
      const auto number = log_number(cell, columns_->delimiter);
      if (!number && !has_no_value(cell))
        return fail(fmt::format("found {}, expected a temperature", text::quoted(cell)), line.at(cell));
      double celsius = number ? *number * column.factor + column.shift : std::nan("");
      if (!number) ++missing_[k];
      if (number && !(celsius >= coldest && celsius <= hottest)) {
        ++beyond_[k];
        celsius = std::nan("");
      }
      values_[k].push_back(celsius);
    }
    return {};
  }

  /// Seconds from the beginning of the log.
  std::optional<double> time_of(const std::vector<std::string_view>& cells) {
    if (columns_->time >= cells.size()) return std::nullopt;
    const std::string_view cell = cells[columns_->time];
    switch (columns_->kind) {
      case LogTime::moment: {
        const auto moment = moment_of(cell);
        return moment ? since_begin(*moment) : std::nullopt;
      }
      case LogTime::date_and_day: {
        if (columns_->time_of_day >= cells.size()) return std::nullopt;
        const auto day = day_of(cell);
        const auto seconds = time_of_day_s(cells[columns_->time_of_day]);
        if (!day || !seconds) return std::nullopt;
        return since_begin({static_cast<std::int64_t>(*day) * 86'400'000'000'000 +
                                static_cast<std::int64_t>(std::llround(*seconds * 1e9)),
                            false});
      }
      case LogTime::time_of_day: {
        const auto seconds = time_of_day_s(cell);
        if (!seconds) return std::nullopt;
        if (!times_.empty() && *seconds + midnights_ * day_s < times_.back() - day_s / 2.0) midnights_ += 1.0;
        return *seconds + midnights_ * day_s;
      }
      case LogTime::number: {
        const auto number = number_of(cell, columns_->delimiter);
        if (!number) return std::nullopt;
        const double seconds = *number * columns_->seconds_per_unit;
        if (times_.empty() && seconds >= unix_from) since_1970_ = seconds >= unix_ms_from ? 1e-3 : 1.0;
        if (!since_1970_) return seconds;
        if (!(std::abs(seconds * *since_1970_) < unix_to_s)) return std::nullopt;
        return since_begin({static_cast<std::int64_t>(std::llround(seconds * *since_1970_ * 1e3)) * 1'000'000, true});
      }
    }
    return std::nullopt;
  }

  std::optional<double> since_begin(const Moment& moment) {
    if (!begin_) begin_ = moment;
    if (begin_->zoned != moment.zoned) return std::nullopt;
    last_ = moment;
    return moment.seconds_since(*begin_);
  }

  Result<void> order_times() {
    if (times_.size() > 1 && times_.front() > times_.back() && std::ranges::is_sorted(times_, std::greater{})) {
      std::ranges::reverse(times_);
      begin_ = last_;
      for (auto& values : values_) std::ranges::reverse(values);
      remarks_.emplace_back("the temperature log begins with the newest reading and was turned round");
    } else if (const auto at = std::ranges::is_sorted_until(times_); at != times_.end()) {
      return fail("found a time before that of the line before, expected the order of time",
                  {lines_[static_cast<std::size_t>(at - times_.begin())], 1});
    }
    const double first = times_.front();
    for (double& time : times_) time -= first;
    return {};
  }

  Result<TemperatureLog> log_of(const SensorRoles& roles) {
    TemperatureLog log{begin_, {}, {}};
    for (const auto& [name, role] : roles) {
      if (std::ranges::count(roles, name, &SensorRoles::value_type::first) > 1)
        return fail(fmt::format("found two roles of the sensor {}, expected one", text::quoted(name)));
      if (!text::is_one_of(role, role_words))
        return fail(fmt::format("found {} as what a sensor is of, expected machine, equipment, air or none",
                                text::quoted(role)));
      if (std::ranges::find(columns_->temperatures, name, &LogColumn::name) == columns_->temperatures.end())
        return fail(
            fmt::format("found no sensor {} in the temperature log, expected one of {}", text::quoted(name), names()));
    }
    for (std::size_t k = 0; k < values_.size(); ++k) add_sensor(log, k, roles);
    if (log.sensors.empty())
      return fail(
          fmt::format("found no sensor of the machine, the equipment or the air in the temperature log, expected one "
                      "of {} to be stated as such",
                      names()));
    if (std::ranges::all_of(log.sensors, [](const TemperatureCourse& course) { return course.times_s.empty(); }))
      return fail("found no temperature in the temperature log, expected some");
    tell_of_names();
    tell_of_columns();
    log.remarks = std::move(remarks_);
    return log;
  }

  std::string names() const {
    std::string all;
    for (const LogColumn& column : columns_->temperatures)
      all += fmt::format("{}{}", all.empty() ? "" : ", ", text::quoted(column.name));
    return all;
  }

  void add_sensor(TemperatureLog& log, std::size_t k, const SensorRoles& roles) {
    const std::string& name = columns_->temperatures[k].name;
    const auto stated = std::ranges::find(roles, name, &SensorRoles::value_type::first);
    if (stated != roles.end() && text::equal_ignoring_case(stated->second, "none")) return;
    const bool extremes = names_extremes(name);
    if (stated == roles.end() && (names_no_role(name) || (extremes && !tells_air(name)))) {
      remarks_.push_back(
          fmt::format("column {} of the temperature log is by its name no temperature of the machine, the equipment or "
                      "the air and is left out",
                      text::quoted(name)));
      return;
    }
    TemperatureCourse course{{}, name, {}, {}};
    for (std::size_t j = 0; j < times_.size(); ++j) {
      if (std::isnan(values_[k][j])) continue;
      course.times_s.push_back(times_[j]);
      course.celsius.push_back(values_[k][j]);
    }
    if (missing_[k] > 0)
      remarks_.push_back(fmt::format("temperature sensor {}: {} of {} readings have no value and are left out",
                                     text::quoted(name), missing_[k], times_.size()));
    if (beyond_[k] > 0)
      remarks_.push_back(
          fmt::format("temperature sensor {}: {} of {} readings lie outside −60 … 100 °C and are left "
                      "out",
                      text::quoted(name), beyond_[k], times_.size()));
    if (course.times_s.empty())
      remarks_.push_back(fmt::format("temperature sensor {} has no reading at all", text::quoted(name)));
    tell_if_still(course);
    if (stated != roles.end()) {
      course.role = text::to_lower(stated->second);
    } else if (const auto role = sensor_role(name)) {
      course.role = *role;
      by_name_[std::string(*role)].push_back(text::quoted(name));
    } else {
      course.role = "air";
      remarks_.push_back(fmt::format("temperature sensor {} does not say what it is of and is taken for one of the air",
                                     text::quoted(name)));
    }
    if (extremes && course.role == "air")
      remarks_.push_back(
          fmt::format("temperature sensor {} tells extremes of the air by its name: they count for the lowest and the "
                      "highest temperature, and the change per hour is known in part only",
                      text::quoted(name)));
    log.sensors.push_back(std::move(course));
  }

  /// Whether a column of extremes is one of the air: by its name, or beside another column of a sensor of the air.
  bool tells_air(std::string_view name) const {
    if (const auto role = sensor_role(name)) return *role == "air";
    const std::string alone = sensor_alone(name);
    return std::ranges::any_of(columns_->temperatures, [&](const LogColumn& other) {
      return !names_extremes(other.name) && !alone.empty() && sensor_alone(other.name) == alone;
    });
  }

  /// A sensor that hangs shows what it last measured, and no change; so does one of coarse steps in a steady room.
  void tell_if_still(const TemperatureCourse& course) {
    constexpr double longest_s = 6.0 * 3600.0;
    constexpr std::size_t fewest = 20;
    std::size_t from = 0, still_from = 0, still_to = 0;
    for (std::size_t j = 1; j <= course.celsius.size(); ++j) {
      if (j < course.celsius.size() && course.celsius[j] == course.celsius[from] &&
          course.times_s[j] - course.times_s[j - 1] <= longest_unrecorded_s)
        continue;
      const std::size_t to = j - 1;
      if (course.times_s[to] - course.times_s[from] > course.times_s[still_to] - course.times_s[still_from])
        still_from = from, still_to = to;
      from = j;
    }
    if (course.celsius.empty() || still_to - still_from + 1 < fewest) return;
    const double still_s = course.times_s[still_to] - course.times_s[still_from];
    if (still_s < longest_s) return;
    remarks_.push_back(fmt::format(
        "temperature sensor {} shows {} °C in {} readings over {} h without any change: it "
        "hangs, or its steps are coarse",
        text::quoted(course.location), format_shortest(std::round(1000.0 * course.celsius[still_from]) / 1000.0),
        still_to - still_from + 1, format_fixed(still_s / 3600.0, 1)));
  }

  void tell_of_names() {
    for (const NamedRole& row : named_roles) {
      const auto found = by_name_.find(row.role);
      if (found == by_name_.end()) continue;
      const std::string_view pattern = found->second.size() > 1 ? row.several : row.one;
      remarks_.push_back(fmt::format(fmt::runtime(pattern), fmt::join(found->second, ", ")));
    }
  }

  void tell_of_columns() {
    if (columns_->units_assumed)
      remarks_.emplace_back("the temperature log tells no unit of its temperatures, which are taken to be in °C");
    for (const std::string& name : columns_->without_unit)
      remarks_.push_back(
          fmt::format("column {} of the temperature log tells no unit, which others do, and is taken to "
                      "be in °C",
                      text::quoted(name)));
    for (const auto& [head, unit] : columns_->letter_units)
      remarks_.push_back(fmt::format("column {} of the temperature log is taken to be in {} by its last letter",
                                     text::quoted(head), unit));
    if (columns_->kind == LogTime::number && !columns_->seconds_told && !since_1970_)
      remarks_.emplace_back("times of the temperature log tell no unit and are taken to be in seconds");
    if (since_1970_) remarks_.emplace_back("times of the temperature log are taken to count from 1970-01-01 UTC");
    for (const std::string& name : columns_->passed_over)
      remarks_.push_back(
          fmt::format("column {} of the temperature log does not say that it is a temperature and is passed over",
                      text::quoted(name)));
  }

  std::string_view above_;                    // the line that may be the header
  std::vector<std::string> no_temperatures_;  // quoted heads of numbers beside a time
  std::optional<LogColumns> columns_;
  std::optional<Moment> begin_, last_;  // of the first and the last line
  std::optional<double> since_1970_;    // seconds per unit
  double midnights_ = 0.0;
  std::vector<double> times_;
  std::vector<std::size_t> lines_;
  std::vector<std::vector<double>> values_;  // NaN: none
  std::vector<std::size_t> missing_;
  std::vector<std::size_t> beyond_;
  std::map<std::string, std::vector<std::string>, std::less<>> by_name_;  // quoted names of sensors, per role
  std::vector<std::string> remarks_;
};

}  // namespace

Result<void> check_log_size(std::size_t bytes) {
  if (bytes <= read_budget::file_bytes) return {};
  // Rounded up: one byte too many is no 64 MiB.
  return fail(fmt::format("found {} MiB of temperatures, expected at most {}", ((bytes - 1) >> 20) + 1,
                          read_budget::file_bytes >> 20));
}

Result<std::vector<std::string>> sensors_of_log(std::string_view bytes) {
  AXIOMETRY_TRY_VOID(check_log_size(bytes.size()));
  AXIOMETRY_TRY(const DecodedText decoded, decoded_text(bytes));
  return LogReader().sensors(decoded.text);
}

Result<TemperatureLog> read_temperature_log(std::string_view bytes, const SensorRoles& roles) {
  AXIOMETRY_TRY_VOID(check_log_size(bytes.size()));
  AXIOMETRY_TRY(const DecodedText decoded, decoded_text(bytes));
  return LogReader().read(decoded.text, roles);
}

}  // namespace axiometry::formats
