// SPDX-License-Identifier: Apache-2.0
#include "axiometry/formats/recordings/sample_columns.h"

#include <fmt/format.h>

#include <algorithm>
#include <string>

#include "axiometry/base/counted.h"
#include "axiometry/base/text/number_text.h"
#include "axiometry/base/text/text.h"
#include "axiometry/formats/recordings/time_text.h"
#include "axiometry/formats/text/name_words.h"
#include "axiometry/formats/text/units.h"

namespace axiometry::formats {
namespace {

constexpr std::string_view time_names[] = {"time",       "t",        "zeit", "timestamp",
                                           "time stamp", "datetime", "date", "elapsed"};

bool is_digit(char c) { return c >= '0' && c <= '9'; }

bool begins_with_date(std::string_view word) {
  return word.size() == 10 && is_digit(word[0]) && (word[4] == '-' || word[4] == '/') && is_digit(word[9]);
}

std::string_view unquoted(std::string_view cell) {
  cell = text::trim(cell);
  if (cell.size() >= 2 && cell.front() == '"' && cell.back() == '"') cell = text::trim(cell.substr(1, cell.size() - 2));
  return cell;
}

/// Name and unit of a header cell: "pos [mm]", "pos (mm)", "pos/mm", "pos_mm", "mm".
struct Heading {
  std::string name;
  std::optional<double> seconds;  // seconds of the unit where it is one of time
  const Unit* unit = nullptr;     // the unit where it is one of a position
};

bool take_unit(Heading& heading, std::string_view unit) {
  unit = text::trim(unit);
  heading.seconds = seconds_per_unit(unit);
  heading.unit = heading.seconds ? nullptr : find_unit(unit);
  return heading.seconds || heading.unit != nullptr;
}

Heading heading_of(std::string_view cell) {
  cell = unquoted(cell);
  Heading heading{std::string(cell), {}, nullptr};
  for (const auto& [open, close] :
       {std::pair('[', "]"), std::pair('(', ")"), std::pair('/', ""), std::pair('_', ""), std::pair(' ', "")}) {
    const std::size_t at = cell.rfind(open);
    if (at == cell.npos) continue;
    std::string_view unit = cell.substr(at + 1);
    if (unit.ends_with(close) && take_unit(heading, unit.substr(0, unit.size() - std::string_view(close).size()))) {
      heading.name = text::trim(cell.substr(0, at));
      return heading;
    }
  }
  const bool named_t = std::ranges::any_of(time_names, [&](auto n) { return text::equal_ignoring_case(n, cell); });
  if (!named_t && take_unit(heading, cell)) heading.name.clear();
  return heading;
}

bool is_time(const Heading& heading) {
  return heading.seconds || std::ranges::any_of(time_names, [&](std::string_view name) {
           return text::equal_ignoring_case(name, heading.name);
         });
}

/// What a column is called that holds what the axis shall do, not what was measured.
constexpr NameWord setpoint_words[] = {
    {"setpoint", WordPlace::anywhere}, {"set_point", WordPlace::anywhere},  {"set point", WordPlace::anywhere},
    {"command", WordPlace::anywhere},  {"cmd", WordPlace::front_or_back},   {"target", WordPlace::anywhere},
    {"demand", WordPlace::anywhere},   {"nominal", WordPlace::anywhere},    {"reference", WordPlace::anywhere},
    {"desired", WordPlace::anywhere},  {"programmed", WordPlace::anywhere}, {"soll", WordPlace::front_or_back}};
constexpr NameWord position_words[] = {{"position", WordPlace::anywhere}, {"pos", WordPlace::front_or_back},
                                       {"distance", WordPlace::anywhere}, {"displacement", WordPlace::anywhere},
                                       {"angle", WordPlace::back},        {"winkel", WordPlace::front_or_back},
                                       {"weg", WordPlace::front_or_back}};
/// What a position may be called where nothing says that it is anything else.
constexpr NameWord measured_words[] = {{"actual", WordPlace::front},
                                       {"measured", WordPlace::front},
                                       {"laser", WordPlace::front_or_back},
                                       {"encoder", WordPlace::front_or_back},
                                       {"ist", WordPlace::front}};
/// How far something is off, which is no position beside another.
constexpr NameWord deviation_words[] = {
    {"deviation", WordPlace::front},
    {"abweichung", WordPlace::front_or_back},
    {"lag"},
    {"following", WordPlace::front},
    {"err"},
    {"error", WordPlace::front_or_back},
    {"residual", WordPlace::front},
    {"fehler", WordPlace::front_or_back},
    {"straight", WordPlace::front},
    {"geradheit", WordPlace::front},
};
/// What is no position at all.
constexpr NameWord other_words[] = {{"temp", WordPlace::front_or_back},
                                    {"temperat", WordPlace::anywhere},
                                    {"humid", WordPlace::anywhere},
                                    {"feucht", WordPlace::anywhere},
                                    {"pressure", WordPlace::anywhere},
                                    {"druck", WordPlace::front_or_back},
                                    {"speed", WordPlace::anywhere},
                                    {"velocity", WordPlace::anywhere},
                                    {"geschwindigkeit", WordPlace::anywhere},
                                    {"drehzahl", WordPlace::anywhere},
                                    {"feedrate", WordPlace::anywhere},
                                    {"count"},
                                    {"counts"},
                                    {"counter"},
                                    {"quality", WordPlace::anywhere},
                                    {"status", WordPlace::anywhere},
                                    {"error", WordPlace::anywhere},
                                    {"flag"},
                                    {"flags"},
                                    {"torque", WordPlace::anywhere},
                                    {"strom", WordPlace::front_or_back},
                                    {"voltage", WordPlace::anywhere},
                                    {"spannung", WordPlace::anywhere}};
/// … unless the name tells a position too: "Current position", "Position of the feed axis".
constexpr NameWord perhaps_other_words[] = {{"current"}, {"feed"}, {"signal"}};

bool names_other(std::string_view name) {
  return has_any_word(name, other_words) ||
         (has_any_word(name, perhaps_other_words) && !has_any_word(name, position_words));
}

/// Units of positions that are not read: what stands in them must not count as mm or °.
constexpr std::string_view units_not_read[] = {"cm",    "dm",     "km",   "ft",   "foot",  "feet",   "yd",     "yard",
                                               "yards", "gon",    "grad", "rev",  "revs",  "count",  "counts", "cts",
                                               "pulse", "pulses", "mV",   "volt", "volts", "gradian"};

/// The last word of a heading, in brackets or not, where it is one of them.
std::string_view unit_not_read(std::string_view name) {
  while (!name.empty() && (name.back() == ']' || name.back() == ')' || name.back() == ' ')) name.remove_suffix(1);
  const std::size_t mark = name.find_last_of("[(/_ ");
  const std::string_view word = mark == name.npos ? name : name.substr(mark + 1);
  if (mark == name.npos && names_other(name)) return {};  // "count" is a name too
  const bool is_unit =
      std::ranges::any_of(units_not_read, [&](std::string_view unit) { return text::equal_ignoring_case(unit, word); });
  return is_unit ? word : std::string_view();
}

bool names_position(std::string_view name) {
  return has_any_word(name, position_words) || has_any_word(name, measured_words);
}

/// Which of the columns beside the time is the position.
Result<std::size_t> position_column(const std::vector<Heading>& headings, std::size_t time, PositionChoice choice) {
  const std::size_t beside = headings.size() - 1;
  if (choice.stated && *choice.stated >= beside)
    return fail(
        fmt::format("found {} beside the time, expected at least {}", counted(beside, "column"), *choice.stated + 1));
  const auto nth_beside = [&](std::size_t k) { return k < time ? k : k + 1; };
  if (choice.stated || beside == 1) return nth_beside(choice.stated.value_or(0));
  std::vector<std::size_t> possible, with_unit, called;
  for (std::size_t k = 0; k < headings.size(); ++k) {
    const Heading& heading = headings[k];
    if (k == time || has_any_word(heading.name, setpoint_words)) continue;
    const bool deviates = has_any_word(heading.name, deviation_words);
    if (deviates ? !choice.at_standstill : names_other(heading.name)) continue;
    possible.push_back(k);
    if (heading.unit != nullptr) with_unit.push_back(k);
    if (deviates || names_position(heading.name)) called.push_back(k);
  }
  // A unit tells nothing of a position where another column is called one.
  if (with_unit.size() == 1 && (called.empty() || std::ranges::find(called, with_unit.front()) != called.end()))
    return with_unit.front();
  if (called.size() == 1 && (with_unit.empty() || choice.at_standstill)) return called.front();
  if (choice.at_standstill) return possible.empty() ? nth_beside(0) : possible.front();
  std::string names;
  for (std::size_t k = 0; k < headings.size(); ++k)
    if (k != time) names += (names.empty() ? "" : ", ") + text::quoted(headings[k].name);
  return fail(fmt::format(
      "found the columns {} beside the time, expected the number of the one with the position: 1 is the first of these",
      names));
}

std::vector<Heading> headings_of(const std::vector<std::string_view>& cells) {
  std::vector<Heading> headings;
  for (std::string_view cell : cells) headings.push_back(heading_of(cell));
  return headings;
}

/// All but the column that is read; nothing without a time, or with nothing beside it.
std::optional<SampleColumns> time_columns(const std::vector<Heading>& headings, char delimiter) {
  const auto time = std::ranges::find_if(headings, is_time);
  if (time == headings.end() || headings.size() < 2) return std::nullopt;
  SampleColumns columns;
  columns.by_header = true;
  columns.delimiter = delimiter;
  columns.time = static_cast<std::size_t>(time - headings.begin());
  columns.seconds_per_unit = time->seconds.value_or(1.0);
  columns.time_has_unit = time->seconds.has_value();
  return columns;
}

/// A delimiter between quotes parts no cells: `"20,5"`.
std::vector<std::string_view> split_beside_quotes(std::string_view line, char delimiter) {
  std::vector<std::string_view> cells;
  while (true) {
    const std::size_t begin = std::min(line.find_first_not_of(delimiter == '\t' ? " " : " \t"), line.size());
    const std::size_t closing = line.substr(begin, 1) == "\"" ? line.find('"', begin + 1) : line.npos;
    const std::size_t end = std::min(line.find(delimiter, closing == line.npos ? 0 : closing), line.size());
    cells.push_back(line.substr(0, end));
    if (end == line.size()) return cells;
    line.remove_prefix(end + 1);
  }
}

}  // namespace

std::vector<std::string_view> cells_of(std::string_view line, char delimiter) {
  if (delimiter != ' ') {
    const bool quotes = line.find('"') != line.npos;
    std::vector<std::string_view> cells = quotes ? split_beside_quotes(line, delimiter) : text::split(line, delimiter);
    for (std::string_view& cell : cells) cell = unquoted(cell);
    while (cells.size() > 2 && cells.back().empty()) cells.pop_back();  // a delimiter at the end of the line
    return cells;
  }
  std::vector<std::string_view> cells = text::words(line);
  for (std::size_t k = 0; k + 1 < cells.size(); ++k) {
    if (!begins_with_date(cells[k]) || cells[k + 1].find(':') == std::string_view::npos) continue;
    const char* const begin = cells[k].data();
    const char* const end = cells[k + 1].data() + cells[k + 1].size();
    cells[k] = std::string_view(begin, static_cast<std::size_t>(end - begin));
    cells.erase(cells.begin() + static_cast<std::ptrdiff_t>(k) + 1);
  }
  return cells;
}

std::optional<double> number_of(std::string_view cell, char delimiter) {
  if (const auto number = parse_number(cell)) return number;
  if (delimiter == ',') return std::nullopt;
  const std::size_t comma = cell.find(',');
  if (comma == cell.npos || cell.find('.') != cell.npos) return std::nullopt;
  std::string with_point(cell);
  with_point[comma] = '.';
  return parse_number(with_point);
}

char sample_delimiter(std::string_view line) {
  if (line.find(';') != line.npos) return ';';
  if (line.find('\t') != line.npos) return '\t';
  if (line.find(',') == line.npos) return ' ';
  const auto words = text::words(line);
  const bool decimal_commas =
      words.size() >= 2 && std::ranges::all_of(words, [](std::string_view w) { return number_of(w, ' ').has_value(); });
  return decimal_commas ? ' ' : ',';
}

std::optional<SampleColumns> columns_by_values(std::string_view line, std::optional<std::size_t> stated) {
  SampleColumns columns;
  columns.delimiter = sample_delimiter(line);
  columns.position = 1 + stated.value_or(0);
  const auto cells = cells_of(line, columns.delimiter);
  if (stated ? cells.size() <= columns.position : cells.size() != 2) return std::nullopt;
  columns.stamps = parse_time_stamp(cells[0]).has_value();
  if (!columns.stamps && !number_of(cells[0], columns.delimiter)) return std::nullopt;
  if (!number_of(cells[columns.position], columns.delimiter)) return std::nullopt;
  return columns;
}

Result<SampleColumns> columns_by_header(std::string_view line, AxisKind kind, PositionChoice choice) {
  const char delimiter = sample_delimiter(line);
  const auto cells = cells_of(line, delimiter);
  const std::vector<Heading> headings = headings_of(cells);
  const auto timed = time_columns(headings, delimiter);
  if (!timed)
    return fail(
        fmt::format("found {}, expected two columns, time and position, perhaps below a header such as "
                    "time_s,position_mm",
                    text::quoted(line)));
  SampleColumns columns = *timed;
  AXIOMETRY_TRY(columns.position, position_column(headings, columns.time, choice));
  const Heading& position = headings[columns.position];
  if (position.unit != nullptr && position.unit->kind != kind)
    return fail(fmt::format("found positions in {}, expected {} for a {} axis", position.unit->symbol,
                            kind == AxisKind::linear ? "a unit of length" : "a unit of angle", axis_kind_name(kind)));
  const std::string_view unread =
      position.unit != nullptr || choice.in_any_unit ? std::string_view() : unit_not_read(position.name);
  if (!unread.empty())
    return fail(fmt::format("found positions in {}, expected one of {}", text::quoted(unread), unit_names()));
  if (!choice.stated && position.unit == nullptr && names_other(position.name))
    return fail(fmt::format("found the column {}, expected positions", text::quoted(cells[columns.position])));
  if (position.unit != nullptr) {
    columns.position_has_unit = true;
    columns.position_factor = position.unit->factor;
    columns.position_divisor = position.unit->divisor * deviation_per_position(kind);
  }
  return columns;
}

Result<SampleColumns> value_columns_by_header(std::string_view line, std::optional<std::size_t> stated) {
  const char delimiter = sample_delimiter(line);
  const auto cells = cells_of(line, delimiter);
  const std::vector<Heading> headings = headings_of(cells);
  const auto timed = time_columns(headings, delimiter);
  if (!timed)
    return fail(
        fmt::format("found {}, expected two columns, time and reading, perhaps below a header such as "
                    "time_s,straightness_um",
                    text::quoted(line)));
  const std::size_t beside = headings.size() - 1;
  if (!stated && beside > 1)
    return fail(fmt::format(
        "found {} columns beside the time, expected the number of the one with the readings: 1 is the first of these",
        beside));
  if (stated && *stated >= beside)
    return fail(fmt::format("found {} beside the time, expected at least {}", counted(beside, "column"), *stated + 1));
  SampleColumns columns = *timed;
  const std::size_t nth = stated.value_or(0);
  columns.position = nth < columns.time ? nth : nth + 1;
  const Heading& heading = headings[columns.position];
  columns.unit = heading.unit;
  columns.name = heading.name;
  // "level [V]": whoever wrote a unit there meant one.
  if (heading.unit == nullptr && (heading.name.ends_with(']') || heading.name.ends_with(')')))
    return fail(fmt::format("found the column {} in a unit that is not known, expected one of {}",
                            text::quoted(heading.name), unit_names()));
  return columns;
}

}  // namespace axiometry::formats
