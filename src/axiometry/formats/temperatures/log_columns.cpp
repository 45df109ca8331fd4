// SPDX-License-Identifier: Apache-2.0
#include "axiometry/formats/temperatures/log_columns.h"

#include <fmt/format.h>

#include <algorithm>
#include <ranges>
#include <utility>

#include "axiometry/base/number_text.h"
#include "axiometry/base/text.h"
#include "axiometry/formats/recordings/sample_columns.h"
#include "axiometry/formats/recordings/time_text.h"
#include "axiometry/formats/temperatures/name_words.h"
#include "axiometry/formats/temperatures/temperature_log.h"

namespace axiometry::formats {
namespace {

struct TemperatureUnit {
  std::string_view word;
  double factor;
  double shift;
};
constexpr double kelvin_shift = -273.15;
constexpr double fahrenheit_factor = 5.0 / 9.0, fahrenheit_shift = -32.0 * 5.0 / 9.0;
constexpr TemperatureUnit temperature_units[] = {
    {"°c", 1.0, 0.0},
    {"ºc", 1.0, 0.0},
    {"℃", 1.0, 0.0},
    {"c", 1.0, 0.0},
    {"degc", 1.0, 0.0},
    {"deg c", 1.0, 0.0},
    {"deg_c", 1.0, 0.0},
    {"celsius", 1.0, 0.0},
    {"k", 1.0, kelvin_shift},
    {"kelvin", 1.0, kelvin_shift},
    {"°f", fahrenheit_factor, fahrenheit_shift},
    {"ºf", fahrenheit_factor, fahrenheit_shift},
    {"℉", fahrenheit_factor, fahrenheit_shift},
    {"f", fahrenheit_factor, fahrenheit_shift},
    {"degf", fahrenheit_factor, fahrenheit_shift},
    {"deg f", fahrenheit_factor, fahrenheit_shift},
    {"fahrenheit", fahrenheit_factor, fahrenheit_shift},
};
constexpr std::string_view sensor_heads[] = {"sensor", "sensor id", "sensor_id", "sensor name", "channel",
                                             "probe",  "kanal",     "fühler",    "messstelle"};
constexpr std::string_view time_heads[] = {"time",        "t",         "zeit",     "timestamp", "time stamp",
                                           "datetime",    "date time", "elapsed",  "seconds",   "uhrzeit",
                                           "zeitstempel", "sekunden",  "date/time"};
/// Of columns that are no temperatures, where no head tells a unit.
constexpr NameWord other_words[] = {
    {"hum", WordPlace::whole},    {"humid", WordPlace::anywhere},    {"feucht", WordPlace::anywhere},
    {"rh", WordPlace::whole},     {"press", WordPlace::whole},       {"pressure", WordPlace::anywhere},
    {"druck", WordPlace::back},   {"dew", WordPlace::whole},         {"dewpoint", WordPlace::anywhere},
    {"tau", WordPlace::whole},    {"taupunkt", WordPlace::anywhere}, {"batt", WordPlace::whole},
    {"batter", WordPlace::front}, {"co2", WordPlace::whole},         {"index", WordPlace::whole},
    {"number", WordPlace::whole}, {"nummer", WordPlace::back},       {"lfd", WordPlace::whole},
    {"count", WordPlace::whole},  {"counter", WordPlace::whole},     {"volt", WordPlace::front},
    {"no.", WordPlace::front},    {"record", WordPlace::whole}};
constexpr std::string_view no_values[] = {"-",   "--",    "---",  "nan", "na",    "n/a",    "null",        "none",
                                          "err", "error", "open", "oor", "fault", "fehler", "unavailable", "unknown"};

struct Head {
  std::string name;
  const TemperatureUnit* unit = nullptr;
  std::optional<double> seconds;
  bool other_unit = false;  ///< a unit in brackets that is neither
};

const TemperatureUnit* find_temperature_unit(std::string_view word) {
  const auto* found = std::ranges::find(temperature_units, text::to_lower(text::trim(word)), &TemperatureUnit::word);
  return found == std::end(temperature_units) ? nullptr : found;
}

/// "Bed [°C]", "Bed (C)", "Bed/°C", "bed_C", "Bed, °C", "Bed °C", "°C".
Head head_of(std::string_view cell) {
  cell = text::trim(cell);
  Head head{std::string(cell), nullptr, {}, false};
  for (const auto& [open, close] : {std::pair('[', "]"), std::pair('(', ")"), std::pair('/', ""), std::pair('_', ""),
                                    std::pair(',', ""), std::pair(' ', "")}) {
    const std::size_t at = cell.rfind(open);
    const std::string_view closing = close;
    if (at == cell.npos || !cell.ends_with(closing)) continue;
    std::string_view unit = text::trim(cell.substr(at + 1, cell.size() - at - 1 - closing.size()));
    head.unit = find_temperature_unit(unit);
    if (head.unit == nullptr) head.seconds = seconds_per_unit(unit);
    if (head.unit != nullptr || head.seconds) {
      head.name = text::trim(cell.substr(0, at));
      return head;
    }
    head.other_unit = head.other_unit || (!closing.empty() && !unit.empty());
  }
  head.unit = find_temperature_unit(cell);
  return head;
}

bool names_time(const Head& head) {
  const std::string lower = text::to_lower(head.name);
  return text::is_one_of(lower, time_heads) || lower.find("time") != lower.npos || lower.find("zeit") != lower.npos;
}

bool names_other(std::string_view name) {
  return name.starts_with('%') ||
         std::ranges::any_of(other_words, [&](const NameWord& word) { return has_word(name, word); });
}

/// "3/2/2026": a day with slashes that no rule tells from a month.
bool is_slashed_date(std::string_view cell) {
  const std::size_t first = cell.find('/');
  return first != cell.npos && first >= 1 && first <= 2 && cell.find('/', first + 1) != cell.npos &&
         cell.front() >= '0' && cell.front() <= '9';
}

/// Whether the date in that cell stands where readings have theirs: no word before it, and a number in another cell.
/// Else the line is one about the logger.
bool dates_readings(const std::vector<std::string_view>& cells, std::size_t date, char delimiter) {
  const auto is_number = [&](std::string_view cell) { return log_number(cell, delimiter).has_value(); };
  const auto is_word = [&](std::string_view cell) {
    return !is_number(cell) && !has_no_value(cell) && !time_of_day_s(cell);
  };
  const auto before = cells | std::views::take(date);
  const auto after = cells | std::views::drop(date + 1);
  return std::ranges::none_of(before, is_word) &&
         (std::ranges::any_of(before, is_number) || std::ranges::any_of(after, is_number));
}

/// Where the time stands; nothing where the line tells none.
std::optional<LogColumns> time_columns(const std::vector<std::string_view>& cells, const std::vector<Head>& heads,
                                       char delimiter) {
  LogColumns columns;
  columns.delimiter = delimiter;
  const auto first = [&](auto is) { return static_cast<std::size_t>(std::ranges::find_if(cells, is) - cells.begin()); };
  if ((columns.time = first([](auto c) { return moment_of(c).has_value(); })) < cells.size()) {
    columns.kind = LogTime::moment;
    return columns;
  }
  columns.time_of_day = first([](auto c) { return time_of_day_s(c).has_value(); });
  columns.time = first([](auto c) { return day_of(c).has_value(); });
  if (columns.time_of_day < cells.size()) {
    columns.kind = columns.time < cells.size() ? LogTime::date_and_day : LogTime::time_of_day;
    if (columns.kind == LogTime::time_of_day) columns.time = columns.time_of_day;
    return columns;
  }
  columns.kind = LogTime::number;
  columns.time = 0;
  if (!heads.empty()) {
    const auto named = std::ranges::find_if(heads, [](const Head& h) { return h.seconds || names_time(h); });
    if (named == heads.end()) return std::nullopt;
    columns.time = static_cast<std::size_t>(named - heads.begin());
    columns.seconds_per_unit = named->seconds.value_or(1.0);
  }
  if (columns.time >= cells.size() || !log_number(cells[columns.time], delimiter)) return std::nullopt;
  return columns;
}

bool is_time(const LogColumns& columns, std::size_t place) {
  return place == columns.time || (columns.kind == LogTime::date_and_day && place == columns.time_of_day);
}

}  // namespace

std::vector<std::string_view> log_cells(std::string_view line, char delimiter) {
  auto cells = cells_of(line, delimiter);
  if (delimiter != ' ') return cells;
  std::vector<std::string_view> joined;
  for (std::size_t k = 0; k < cells.size(); ++k) {
    std::string_view cell = cells[k];
    if (k + 1 < cells.size() && day_of(cell) && time_of_day_s(cells[k + 1])) {
      const char* const begin = cell.data();
      ++k;
      cell = std::string_view(begin, static_cast<std::size_t>(cells[k].data() + cells[k].size() - begin));
    }
    joined.push_back(cell);
  }
  return joined;
}

std::optional<double> log_number(std::string_view cell, char delimiter) { return number_of(cell, delimiter); }

bool has_no_value(std::string_view cell) { return cell.empty() || text::is_one_of(cell, no_values); }

Result<std::optional<LogColumns>> log_columns(std::string_view line, std::string_view header) {
  const char delimiter = sample_delimiter(line);
  const auto cells = log_cells(line, delimiter);
  std::vector<Head> heads;
  if (const auto names = log_cells(header, delimiter); names.size() >= 2)
    for (const std::string_view name : names) heads.push_back(head_of(name));
  // A header of several words for a moment that blanks part: "date time T1".
  if (delimiter == ' ' && heads.size() == cells.size() + 1) heads.erase(heads.begin());
  if (cells.size() < 2) return std::nullopt;
  if (const auto slashed = std::ranges::find_if(cells, is_slashed_date); slashed != cells.end()) {
    if (!dates_readings(cells, static_cast<std::size_t>(slashed - cells.begin()), delimiter)) return std::nullopt;
    return fail(
        fmt::format("found the date {}, expected 2026-03-02 or 02.03.2026: of slashes nobody knows which is the "
                    "month",
                    text::quoted(*slashed)));
  }
  auto columns = time_columns(cells, heads, delimiter);
  if (!columns) return std::nullopt;
  const bool units = std::ranges::any_of(heads, [](const Head& h) { return h.unit != nullptr; });
  columns->units_assumed = !units;
  for (std::size_t k = 0; k < std::max(cells.size(), heads.size()); ++k) {
    if (is_time(*columns, k)) continue;
    const Head head = k < heads.size() ? heads[k] : Head{fmt::format("column {}", k + 1), nullptr, {}, false};
    const bool number = k < cells.size() && log_number(cells[k], delimiter);
    if (!number && text::is_one_of(head.name, sensor_heads))
      return fail(fmt::format("found a column {} of sensors' names, expected a column for each sensor",
                              text::quoted(head.name)));
    const bool possible = number || k >= cells.size() || has_no_value(cells[k]);
    const bool temperature =
        units ? head.unit != nullptr : !head.other_unit && !head.seconds && !names_other(head.name);
    if (possible && temperature) {
      const TemperatureUnit own = head.unit != nullptr ? *head.unit : temperature_units[0];
      columns->temperatures.push_back(
          {k, head.name.empty() ? fmt::format("column {}", k + 1) : head.name, own.factor, own.shift});
    } else {
      columns->passed_over.push_back(head.name);
    }
  }
  const bool any = std::ranges::any_of(columns->temperatures, [&](const LogColumn& c) {
    return c.place < cells.size() && log_number(cells[c.place], delimiter);
  });
  // Below a head with units the first line may lack its values.
  if (any || (units && !columns->temperatures.empty())) return columns;
  return std::nullopt;
}

}  // namespace axiometry::formats
