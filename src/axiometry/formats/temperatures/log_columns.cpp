// SPDX-License-Identifier: Apache-2.0
#include "axiometry/formats/temperatures/log_columns.h"

#include <fmt/format.h>

#include <algorithm>
#include <initializer_list>
#include <map>
#include <ranges>
#include <set>
#include <utility>

#include "axiometry/base/text/number_text.h"
#include "axiometry/base/text/text.h"
#include "axiometry/formats/recordings/sample_columns.h"
#include "axiometry/formats/recordings/time_text.h"
#include "axiometry/formats/temperatures/sensor_role.h"
#include "axiometry/formats/temperatures/temperature_log.h"
#include "axiometry/formats/text/name_words.h"

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
/// Of columns that are no temperatures.
constexpr std::string_view other_units[] = {"%",   "%rh",  "% rh", "rh", "%rf", "% rf", "% r.f.", "g/m³", "g/m3",
                                            "hpa", "mbar", "bar",  "pa", "kpa", "psi",  "ppm",    "v",    "mv",
                                            "a",   "ma",   "w",    "hz", "lx",  "lux",  "m/s",    "dbm",  "mm",
                                            "µm",  "um",   "ohm",  "Ω",  "1",   "-"};
/// Of these also without brackets: "position_mm", which is no temperature of 20 °C at 20 mm.
constexpr std::string_view travel_units[] = {"mm", "µm", "um", "nm", "arcsec", "urad", "µrad", "mrad"};
constexpr std::string_view no_values[] = {"-",   "--",    "---",  "nan", "na",    "n/a",    "null",        "none",
                                          "err", "error", "open", "oor", "fault", "fehler", "unavailable", "unknown"};

struct Head {
  std::string name;
  const TemperatureUnit* unit = nullptr;
  std::optional<double> seconds;
  bool other_unit = false;   ///< a unit of something else, in brackets
  bool letter_unit = false;  ///< the unit is a letter that may belong to the name: "Air_F", "Air C", "Air (C)"
  std::string whole{};       ///< with what was taken for the unit
};

const TemperatureUnit* find_temperature_unit(std::string_view word) {
  const auto* found = std::ranges::find(temperature_units, text::to_lower(text::trim(word)), &TemperatureUnit::word);
  return found == std::end(temperature_units) ? nullptr : found;
}

bool names_time(std::string_view name) {
  const std::string lower = text::to_lower(name);
  return text::is_one_of(lower, time_heads) || lower.find("time") != lower.npos || lower.find("zeit") != lower.npos;
}

/// "Bed [°C]", "Bed (C)", "Bed/°C", "bed_C", "Bed, °C", "Bed °C", "°C". What stands in brackets and is no unit belongs
/// to the name: "Air (hall 2)".
Head head_of(std::string_view cell) {
  cell = text::trim(cell);
  Head head{std::string(cell), nullptr, {}};
  head.whole = cell;
  for (const auto& [open, close] : {std::pair('[', "]"), std::pair('(', ")"), std::pair('/', ""), std::pair('_', ""),
                                    std::pair(',', ""), std::pair(' ', "")}) {
    const std::size_t at = cell.rfind(open);
    const std::string_view closing = close;
    if (at == cell.npos || !cell.ends_with(closing)) continue;
    const std::string_view unit = text::trim(cell.substr(at + 1, cell.size() - at - 1 - closing.size()));
    const std::string_view name = text::trim(cell.substr(0, at));
    head.unit = find_temperature_unit(unit);
    if (head.unit == nullptr && (!closing.empty() || names_time(name))) head.seconds = seconds_per_unit(unit);
    if (head.unit != nullptr || head.seconds) {
      head.letter_unit = head.unit != nullptr && unit.size() == 1 && open != '[' && open != '/';
      head.name = name;
      return head;
    }
    head.other_unit =
        head.other_unit ||
        (!closing.empty() && (open == '[' || unit.size() > 1 || unit == "%") && text::is_one_of(unit, other_units)) ||
        text::is_one_of(unit, travel_units);
  }
  head.unit = find_temperature_unit(cell);
  return head;
}

bool names_other(std::string_view name) { return name.starts_with('%') || has_any_word(name, other_words); }

/// "3/2/2026": a day with slashes that no rule tells from a month.
bool is_slashed_date(std::string_view cell) {
  const std::size_t first = cell.find('/');
  return first != cell.npos && first >= 1 && first <= 2 && cell.find('/', first + 1) != cell.npos &&
         cell.front() >= '0' && cell.front() <= '9';
}

/// "11:00:00 AM", "2026-03-02 01:00 p.m.", or "PM" in a cell of its own.
bool tells_half_of_day(std::string_view cell) {
  const std::string lower = text::to_lower(text::trim(cell));
  const auto ends = [&](std::string_view word) {
    if (!lower.ends_with(word)) return false;
    const std::string_view before = text::trim(std::string_view(lower).substr(0, lower.size() - word.size()));
    return before.empty() || (before.contains(':') && before.back() >= '0' && before.back() <= '9');
  };
  return std::ranges::any_of(std::initializer_list<std::string_view>{"am", "pm", "a.m.", "p.m."}, ends);
}

/// Whether the date in that cell stands where readings have theirs: no word before it, and a number in another cell.
/// Else the line is one about the logger.
bool dates_readings(const std::vector<std::string_view>& cells, std::size_t date, char delimiter) {
  const auto is_number = [&](std::string_view cell) { return log_number(cell, delimiter).has_value(); };
  const auto is_word = [&](std::string_view cell) {
    return !is_number(cell) && !has_no_value(cell) && !time_of_day_s(cell) && !day_of(cell) && !moment_of(cell);
  };
  const auto before = cells | std::views::take(date);
  const auto after = cells | std::views::drop(date + 1);
  return std::ranges::none_of(before, is_word) &&
         (std::ranges::any_of(before, is_number) || std::ranges::any_of(after, is_number));
}

/// "CET" of "2026-03-02 09:00 CET", "+25:00": what stands behind a moment and is no zone that is read.
std::optional<std::string_view> behind_moment(std::string_view cell) {
  constexpr std::size_t shortest = 14;  // "1.3.2026 09:00"
  if (moment_of(cell)) return std::nullopt;
  for (std::size_t end = cell.size(); end-- > shortest;) {
    const auto moment = moment_of(text::trim(cell.substr(0, end)));
    if (!moment || moment->zoned) continue;
    const std::string_view rest = text::trim(cell.substr(end));
    return std::string_view(":.,0123456789").contains(rest.front()) ? std::nullopt : std::optional(rest);
  }
  return std::nullopt;
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
    const auto named = std::ranges::find_if(heads, [](const Head& h) { return h.seconds || names_time(h.name); });
    if (named == heads.end()) return std::nullopt;
    columns.time = static_cast<std::size_t>(named - heads.begin());
    columns.seconds_per_unit = named->seconds.value_or(1.0);
    columns.seconds_told = named->seconds || seconds_per_unit(named->name) == 1.0;
  }
  if (columns.time >= cells.size() || !number_of(cells[columns.time], delimiter)) return std::nullopt;
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

std::optional<double> log_number(std::string_view cell, char delimiter) {
  return number_of(cell, delimiter == ',' ? ';' : delimiter);
}

bool has_no_value(std::string_view cell) { return cell.empty() || text::is_one_of(cell, no_values); }

namespace {

/// The heads above a line of readings. None where the line above is one of readings itself, or of another kind.
std::vector<Head> heads_above(std::string_view header, char delimiter, std::size_t cells) {
  std::vector<Head> heads;
  const auto names = log_cells(header, delimiter);
  if (names.size() < 2 || std::ranges::any_of(names, [](std::string_view name) { return moment_of(name).has_value(); }))
    return heads;
  for (const std::string_view name : names) heads.push_back(head_of(name));
  // A header of several words for a moment that blanks part: "date time T1".
  if (delimiter == ' ' && heads.size() == cells + 1) heads.erase(heads.begin());
  return heads;
}

bool names_a_temperature(std::string_view name) {
  constexpr NameWord words[] = {{"temp", WordPlace::anywhere}, {"tmp", WordPlace::whole}};
  return sensor_role(name).has_value() || has_any_word(name, words);
}

bool is_called_t(std::string_view name) { return has_word(name, {"t"}); }

/// Whether a name is perhaps that of a sensor: "Air", "T1", "Sensor 2".
bool may_name_a_sensor(std::string_view name) {
  constexpr NameWord words[] = {{"ch"}, {"ntc"}, {"pt"}};
  return names_a_temperature(name) || is_called_t(name) || has_any_word(name, words) ||
         std::ranges::any_of(sensor_heads, [&](std::string_view word) { return has_word(name, {word}); });
}

/// "bed" of "Bed 2 F".
std::string beginning_of(std::string_view name) {
  const auto ends = [](char c) { return c == ' ' || c == '_' || c == '-' || c == '(' || (c >= '0' && c <= '9'); };
  return text::to_lower(name.substr(0, static_cast<std::size_t>(std::ranges::find_if(name, ends) - name.begin())));
}

/// "Bed R", "Bed (R)", "R"
bool ends_in_a_letter_alone(std::string_view name) {
  if (name.ends_with(')')) name.remove_suffix(1);
  if (name.empty()) return false;
  const char last = name.back();
  const bool letter = (last >= 'a' && last <= 'z') || (last >= 'A' && last <= 'Z');
  return letter && (name.size() == 1 || std::string_view(" _-(").find(name[name.size() - 2]) != std::string_view::npos);
}

/// Whether the letters at the end of names are units. They are where every temperature has one: then a number without
/// one ("RSSI", "Door") is something else. Of such a number beside them it must be certain that it is no sensor that
/// the letters tell from others, as the R (rear) of "Bed R" tells it from "Bed F" (front): neither its name nor its
/// beginning is that of one, it ends in no letter, and either is each letter there twice or it follows the name of a
/// temperature.
bool letters_are_units(const std::vector<Head>& heads, const auto& is_candidate, const auto& is_number) {
  std::set<std::string> lettered_beginnings;
  std::map<const TemperatureUnit*, std::size_t> lettered_units;
  for (std::size_t k = 0; k < heads.size(); ++k) {
    if (!is_candidate(k) || !heads[k].letter_unit) continue;
    lettered_beginnings.insert(beginning_of(heads[k].name));
    ++lettered_units[heads[k].unit];
  }
  bool other_numbers = false, all_told = true;
  for (std::size_t k = 0; k < heads.size(); ++k) {
    const Head& head = heads[k];
    if (!is_candidate(k)) continue;
    if (head.letter_unit)
      all_told =
          all_told && (lettered_units[head.unit] > 1 || names_a_temperature(head.name) || is_called_t(head.name));
    if (head.unit != nullptr) continue;
    const bool alike = !head.name.empty() && lettered_beginnings.contains(beginning_of(head.name));
    if (alike || may_name_a_sensor(head.name) || ends_in_a_letter_alone(head.name)) return false;
    other_numbers = other_numbers || is_number(k);
  }
  return !other_numbers || all_told;
}

/// A letter that is no unit belongs to the name: the F of "front" and the C of the third sensor. Whether it was °F or K
/// nobody can say then.
Result<void> settle_letters(std::vector<Head>& heads, const auto& is_candidate, const auto& is_number) {
  bool any_letter = false;
  for (std::size_t k = 0; k < heads.size(); ++k) any_letter = any_letter || (is_candidate(k) && heads[k].letter_unit);
  if (!any_letter || letters_are_units(heads, is_candidate, is_number)) return {};
  for (Head& head : heads) {
    if (!head.letter_unit) continue;
    if (head.unit->factor != 1.0 || head.unit->shift != 0.0)
      return fail(
          fmt::format("found the column {} beside others without a unit, expected units such as [°C] or [°F]: "
                      "nobody knows whether the last letter is one",
                      text::quoted(head.whole)));
    head.name = head.whole;
    head.unit = nullptr;
    head.letter_unit = false;
  }
  return {};
}

/// Clocks of the log and of the test can be compared when both tell their zone or neither does; one that stands apart
/// from its moment would be lost. Times without a clock have none.
std::vector<ZoneColumn> zone_columns(const std::vector<std::string_view>& cells, const std::vector<Head>& heads,
                                     const LogColumns& columns) {
  std::vector<ZoneColumn> zones;
  const auto moment = moment_of(cells[columns.time]);
  if (columns.kind == LogTime::number || (moment && moment->zoned)) return zones;
  for (std::size_t k = 0; k < std::max(cells.size(), heads.size()); ++k) {
    const Head head = k < heads.size() ? heads[k] : Head{};
    const bool digits = head.unit == nullptr && !head.other_unit && !head.seconds && !may_name_a_sensor(head.name);
    if (auto zone = zone_column(k, head.whole, digits); zone && !is_time(columns, k)) zones.push_back(*std::move(zone));
  }
  return zones;
}

}  // namespace

Result<std::optional<LogColumns>> log_columns(std::string_view line, std::string_view header) {
  const char delimiter = sample_delimiter(line);
  const auto cells = log_cells(line, delimiter);
  if (cells.size() < 2) return std::nullopt;
  std::vector<Head> heads = heads_above(header, delimiter, cells.size());
  if (const auto slashed = std::ranges::find_if(cells, is_slashed_date); slashed != cells.end()) {
    if (!dates_readings(cells, static_cast<std::size_t>(slashed - cells.begin()), delimiter)) return std::nullopt;
    return fail(
        fmt::format("found the date {}, expected 2026-03-02 or 02.03.2026: of slashes nobody knows which is the "
                    "month",
                    text::quoted(*slashed)));
  }
  const auto half = std::ranges::find_if(cells, tells_half_of_day);
  if (half != cells.end() && dates_readings(cells, static_cast<std::size_t>(half - cells.begin()), delimiter))
    return fail(fmt::format("found the time {}, expected hours from 0 to 23: AM and PM are not read",
                            text::quoted(text::trim(*half))));
  const auto zone = std::ranges::find_if(cells, [](std::string_view cell) { return behind_moment(cell).has_value(); });
  if (zone != cells.end() && dates_readings(cells, static_cast<std::size_t>(zone - cells.begin()), delimiter))
    return fail(fmt::format("found {} behind the time in {}, expected nothing, or a time zone such as Z or +01:00",
                            text::quoted(*behind_moment(*zone)), text::quoted(*zone)));
  auto columns = time_columns(cells, heads, delimiter);
  if (!columns) return std::nullopt;
  columns->zones = zone_columns(cells, heads, *columns);
  if (dates_readings(cells, columns->time, delimiter)) AXIOMETRY_TRY_VOID(check_zones(cells, columns->zones));
  const auto is_number = [&](std::size_t k) { return k < cells.size() && log_number(cells[k], delimiter).has_value(); };
  const auto is_possible = [&](std::size_t k) { return is_number(k) || k >= cells.size() || has_no_value(cells[k]); };
  const auto tells_another = [&](const Head& head) {
    return head.other_unit || head.seconds || names_other(head.name);
  };
  const auto is_candidate = [&](std::size_t k) {
    return !is_time(*columns, k) && is_possible(k) && !tells_another(heads[k]);
  };
  AXIOMETRY_TRY_VOID(settle_letters(heads, is_candidate, is_number));
  const bool units = std::ranges::any_of(heads, [](const Head& h) { return h.unit != nullptr; });
  columns->units_assumed = !units;
  for (std::size_t k = 0; k < std::max(cells.size(), heads.size()); ++k) {
    if (is_time(*columns, k)) continue;
    const Head head = k < heads.size() ? heads[k] : Head{fmt::format("column {}", k + 1), nullptr, {}};
    if (!is_number(k) && text::is_one_of(head.name, sensor_heads))
      return fail(fmt::format("found a column {} of sensors' names, expected a column for each sensor",
                              text::quoted(head.name)));
    const bool temperature =
        head.unit != nullptr || (!tells_another(head) && (!units || names_a_temperature(head.name)));
    if (is_possible(k) && temperature) {
      const TemperatureUnit own = head.unit != nullptr ? *head.unit : temperature_units[0];
      const std::string name = head.name.empty() ? fmt::format("column {}", k + 1) : head.name;
      if (units && head.unit == nullptr) columns->without_unit.push_back(name);
      if (head.letter_unit && (own.factor != 1.0 || own.shift != 0.0))
        columns->letter_units.push_back({head.whole, own.factor != 1.0 ? "°F" : "K"});
      columns->temperatures.push_back({k, name, own.factor, own.shift});
      std::erase_if(columns->zones, [&](const ZoneColumn& zone) { return zone.place == k && is_number(k); });
    } else {
      columns->passed_over.push_back(head.name);
      if (is_number(k)) columns->other_numbers.push_back(head.name);
    }
  }
  const bool any =
      std::ranges::any_of(columns->temperatures, [&](const LogColumn& column) { return is_number(column.place); });
  // Below a head the first line may lack its values.
  const bool headed = units || (!heads.empty() && names_time(heads[columns->time].name));
  const bool told_otherwise = columns->temperatures.empty() && !columns->other_numbers.empty();
  if (any || headed || told_otherwise) return columns;
  return std::nullopt;
}

}  // namespace axiometry::formats
