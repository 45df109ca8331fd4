// SPDX-License-Identifier: Apache-2.0
#include "axiometry/formats/csv/csv_columns.h"

#include <fmt/format.h>

#include <algorithm>
#include <span>
#include <unordered_map>

#include "axiometry/base/read_budget.h"
#include "axiometry/base/text/number_text.h"
#include "axiometry/base/text/text.h"
#include "axiometry/formats/text/head_words.h"

namespace axiometry::formats {
namespace {

struct NameAndUnit {
  std::string_view name;
  std::string_view unit;  // empty when none is stated
};

/// Parts "deviation_um", "deviation (um)", "deviation [um]", "deviation/um" and "deviation in um".
NameAndUnit part_unit(std::string_view name) {
  for (const auto& [open, close] : {std::pair{'(', ')'}, std::pair{'[', ']'}}) {
    const std::size_t begin = name.rfind(open);
    if (name.ends_with(close) && begin != std::string_view::npos)
      return {text::trim(name.substr(0, begin)), text::trim(name.substr(begin + 1, name.size() - begin - 2))};
  }
  const std::size_t mark = name.find_last_of("_ /-");
  if (mark == std::string_view::npos || find_unit(name.substr(mark + 1)) == nullptr) return {name, {}};
  std::string_view before = text::trim(name.substr(0, mark));
  if (name[mark] == ' ' && before.ends_with(" in")) before = text::trim(before.substr(0, before.size() - 3));
  return {before, name.substr(mark + 1)};
}

bool is_digit(char c) { return c >= '0' && c <= '9'; }
bool is_letter(char c) { return (c >= 'a' && c <= 'z') || static_cast<unsigned char>(c) >= 0x80; }

bool is_sign(char c) { return c == '+' || c == '-'; }

/// "Run 1 (+)" means "Run 1 +"; the brackets hold no unit.
std::string without_brackets_around_signs(std::string name) {
  for (std::string_view sign : {"(+)", "(-)", "[+]", "[-]"})
    if (const std::size_t k = name.find(sign); k != std::string::npos) name[k] = name[k + 2] = ' ';
  return name;
}

/// A sign is a direction at the very beginning or end and between a blank and a digit: "1-", "+ 2", "Run +1", not
/// the hyphen in "run-1".
std::string spell_out_signs(std::string name) {
  for (const auto& [sign, word] :
       {std::pair<std::string_view, std::string_view>{"↑", " up "}, {"↓", " down "}, {"\u2212", "-"}})
    for (std::size_t k; (k = name.find(sign)) != std::string::npos;) name.replace(k, sign.size(), word);
  const std::string trimmed(text::trim(name));
  if (trimmed.size() < 2 || trimmed.contains("+/-")) return trimmed;
  const auto spelled = [](char c) { return c == '+' ? " up " : " down "; };
  if (is_sign(trimmed.back())) return trimmed.substr(0, trimmed.size() - 1) + spelled(trimmed.back());
  if (is_sign(trimmed.front())) return spelled(trimmed.front()) + trimmed.substr(1);
  for (std::size_t k = 1; k + 1 < trimmed.size(); ++k)
    if (trimmed[k - 1] == ' ' && is_sign(trimmed[k]) && is_digit(trimmed[k + 1]))
      return trimmed.substr(0, k) + spelled(trimmed[k]) + trimmed.substr(k + 1);
  return trimmed;
}

// English and German, as instruments and spreadsheets write them.
constexpr std::string_view deviation_words[] = {
    "deviation",      "deviations",         "dev", "error", "err", "delta", "abweichung", "abweichungen", "fehler",
    "messabweichung", "positionsabweichung"};
constexpr std::string_view measured_words[] = {"measured",    "actual",  "measurement", "ist",
                                               "istposition", "istwert", "messwert",    "gemessen"};
constexpr std::string_view target_words[] = {"target", "nominal",  "setpoint",     "commanded", "command",     "set",
                                             "soll",   "sollwert", "sollposition", "ziel",      "zielposition"};
constexpr std::string_view position_words[] = {"position", "positions", "pos", "messposition"};
constexpr std::string_view direction_column_words[] = {"direction", "dir",      "approach",
                                                       "sense",     "richtung", "anfahrrichtung"};
constexpr std::string_view run_words[] = {"run",  "cycle",    "pass",   "repeat",    "repetition",
                                          "lauf", "messlauf", "zyklus", "durchgang", "messung"};
constexpr std::string_view test_words[] = {"test"};
constexpr std::string_view numbering_words[] = {"no", "nr", "number", "index", "id", "name", "num"};
constexpr std::string_view filler_words[] = {"positioning", "of", "point", "x",      "the",
                                             "reading",     "at", "axis",  "travel", "value"};
constexpr std::string_view ignored_words[] = {
    "time",        "timestamp", "date",        "comment",  "comments", "note",     "notes", "remark",    "remarks",
    "temperature", "temp",      "pressure",    "humidity", "operator", "sequence", "no",    "nr",        "index",
    "point",       "row",       "line",        "i",        "zeit",     "uhrzeit",  "datum", "kommentar", "bemerkung",
    "temperatur",  "luftdruck", "luftfeuchte", "prüfer",   "bediener", "zeile"};
// Computed from the readings: computed again here.
constexpr std::string_view computed_words[] = {"mean",
                                               "average",
                                               "avg",
                                               "std",
                                               "stdev",
                                               "stddev",
                                               "sigma",
                                               "s",
                                               "min",
                                               "max",
                                               "minimum",
                                               "maximum",
                                               "median",
                                               "range",
                                               "sum",
                                               "total",
                                               "mittel",
                                               "mittelwert",
                                               "standardabweichung",
                                               "streuung",
                                               "summe"};
constexpr std::string_view up_header_words[] = {"up",        "forward", "fwd", "positive", "auf",       "aufwärts",
                                                "aufwaerts", "hin",     "vor", "vorwärts", "vorwaerts", "positiv"};
constexpr std::string_view down_header_words[] = {
    "down",    "backward", "bwd",    "back",    "reverse", "rev",   "negative",  "neg",         "ab",
    "abwärts", "abwaerts", "zurück", "zurueck", "rück",    "rueck", "rückwärts", "rueckwaerts", "negativ"};

/// What a word may stand for; several may be true of one.
using Meanings = unsigned;
namespace meaning {
constexpr Meanings deviation = 1, measured = 2, target = 4, position = 8, direction_column = 16, run = 32, test = 64,
                   numbering = 128, filler = 256, ignored = 512, up = 1024, down = 2048, computed = 4096;
constexpr Meanings known =
    deviation | measured | target | position | direction_column | run | test | numbering | filler | up | down;
}  // namespace meaning

/// Looked up for every cell in which a header is looked for, so once for each word.
Meanings meanings_of(std::string_view word) {
  static const std::unordered_map<std::string_view, Meanings> table = [] {
    std::unordered_map<std::string_view, Meanings> made;
    const auto add = [&](std::span<const std::string_view> words, Meanings meaning) {
      for (const std::string_view w : words) made[w] |= meaning;
    };
    add(deviation_words, meaning::deviation);
    add(measured_words, meaning::measured);
    add(target_words, meaning::target);
    add(position_words, meaning::position);
    add(direction_column_words, meaning::direction_column);
    add(run_words, meaning::run);
    add(test_words, meaning::test);
    add(numbering_words, meaning::numbering);
    add(filler_words, meaning::filler);
    add(ignored_words, meaning::ignored);
    add(computed_words, meaning::ignored | meaning::computed);
    add(up_header_words, meaning::up);
    add(down_header_words, meaning::down);
    return made;
  }();
  const auto found = table.find(word);
  return found == table.end() ? 0 : found->second;
}

struct Word {
  std::string text;
  Meanings meanings = 0;

  bool is_number() const { return is_digit(text.front()); }
  bool may_be(Meanings any) const { return (meanings & any) != 0; }
};
using Words = std::vector<Word>;

bool any_may_be(const Words& words, Meanings any) {
  return std::ranges::any_of(words, [&](const Word& w) { return w.may_be(any); });
}

/// Lower-case words and numbers: "Run 1↑" gives run, 1, up.
Words words_of(std::string_view name) {
  const std::string spelled = spell_out_signs(text::to_lower(name));
  Words words;
  for (std::size_t k = 0; k < spelled.size();) {
    const auto in_word = is_digit(spelled[k]) ? is_digit : is_letter;
    std::size_t end = k;
    while (end < spelled.size() && in_word(spelled[end])) ++end;
    if (end > k)
      words.push_back({spelled.substr(k, end - k), meanings_of(std::string_view(spelled).substr(k, end - k))});
    k = std::max(end, k + 1);
  }
  return words;
}

/// A reading of a wide file: a direction or a number in its name and no word of another meaning.
bool read_as_wide(Column& column, const Words& words) {
  std::vector<std::string> numbers;
  for (const Word& w : words) {
    if (w.is_number()) {
      numbers.push_back(w.text);
    } else if (w.may_be(meaning::up | meaning::down)) {
      if (column.direction) return false;
      column.direction = w.may_be(meaning::up) ? Direction::up : Direction::down;
    } else if (!w.may_be(meaning::known) || w.may_be(meaning::target | meaning::test)) {
      return false;
    }
  }
  if (numbers.size() > 1 || (numbers.empty() && !column.direction)) return false;
  if (!numbers.empty()) {
    const auto number = parse_count(numbers.front());
    column.run = static_cast<std::size_t>(number.value_or(~0ull));
  }
  const bool is_position =
      any_may_be(words, meaning::measured | meaning::position) && !any_may_be(words, meaning::deviation);
  column.measured = is_position ? Measured::position : Measured::deviation;
  column.role = ColumnRole::reading;
  return true;
}

/// "Ist-Soll", "deviation (target - actual)": a difference whose sign the generic importer knows.
bool names_a_difference(const Words& words) {
  return any_may_be(words, meaning::target) && any_may_be(words, meaning::measured);
}

/// Comments, temperatures, what is computed from readings; but nothing that may be a second column of readings, such as
/// "Time corrected error" or a number in µm.
bool may_be_passed_over(const Column& column, const Words& words) {
  if (any_may_be(words, meaning::computed)) return true;
  constexpr Meanings readings = meaning::deviation | meaning::measured | meaning::position;
  const bool of_readings = column.unit != nullptr && column.unit_text != "in" && column.unit_text != "m";  // "Temp_in"
  return any_may_be(words, meaning::ignored) && !any_may_be(words, readings) && !of_readings;
}

/// The role of a name without numbers and directions; Measured::position marks the undecided "position".
void read_as_long(Column& column, const Words& words) {
  const bool all_known = std::ranges::all_of(words, [](const Word& w) { return w.may_be(meaning::known); });
  if (text::trim(column.name).empty()) {
    column.role = ColumnRole::ignored;  // the numbering that data frames write, or a delimiter at the end of lines
  } else if (names_a_difference(words)) {
    column.role = ColumnRole::unknown;
  } else if (!all_known) {
    column.role = may_be_passed_over(column, words) ? ColumnRole::ignored : ColumnRole::unknown;
  } else if (any_may_be(words, meaning::deviation)) {
    column.role = ColumnRole::reading;
  } else if (any_may_be(words, meaning::measured)) {
    column.role = ColumnRole::reading;
    column.measured = Measured::position;
  } else if (any_may_be(words, meaning::target)) {
    column.role = any_may_be(words, meaning::numbering) ? ColumnRole::ignored : ColumnRole::target;
  } else if (any_may_be(words, meaning::position)) {
    column.role = any_may_be(words, meaning::numbering) ? ColumnRole::ignored : ColumnRole::target;
    column.measured = Measured::position;
  } else if (any_may_be(words, meaning::run)) {
    column.role = ColumnRole::run;
  } else if (any_may_be(words, meaning::direction_column)) {
    column.role = ColumnRole::direction;
  } else if (any_may_be(words, meaning::test)) {
    column.role = ColumnRole::test;
  } else if (may_be_passed_over(column, words)) {
    column.role = ColumnRole::ignored;
  }
}

Column column_from(const CsvCell& cell) {
  Column column;
  column.name = cell.text;
  column.at_column = cell.column;
  // No column is called so: a paragraph, or a list of numbers in one cell. Looking for words in it would take a time
  // that grows with its square.
  if (cell.text.size() > read_budget::name_bytes) return column;
  const std::string name = without_brackets_around_signs(cell.text);
  if (std::ranges::count(name, '|') > 1) return column;  // "|error|" has lost its sign
  const NameAndUnit parts = part_unit(text::trim(name));
  column.unit_text = std::string(parts.unit);
  column.unit = parts.unit.empty() ? nullptr : find_unit(parts.unit);
  const Words words = words_of(parts.name);
  if (read_as_wide(column, words)) return column;
  column.direction.reset();
  read_as_long(column, words);
  // "deviation_furlong": the last word is meant as a unit when the others alone make sense; "run 1 aller" has none.
  if (column.role == ColumnRole::unknown && parts.unit.empty() && words.size() > 1 && !names_a_difference(words)) {
    const std::size_t mark = cell.text.find_last_of("_ /-");
    const std::string last = mark == std::string::npos ? "" : cell.text.substr(mark + 1);
    const bool tells_direction = !parse_number(last) && generic::direction_word(last);
    if (mark != std::string::npos && !tells_direction) {
      Column shorter = column_from({cell.text.substr(0, mark), cell.column});
      if (shorter.role == ColumnRole::reading || shorter.role == ColumnRole::target) {
        shorter.name = cell.text;
        shorter.unit_text = last;
        shorter.unit = nullptr;
        return shorter;
      }
    }
  }
  return column;
}

bool is_undecided_position(const Column& c) { return c.role == ColumnRole::target && c.measured == Measured::position; }

}  // namespace

std::vector<Column> columns_from(const std::vector<CsvCell>& header) {
  std::vector<Column> columns;
  for (const CsvCell& cell : header) columns.push_back(column_from(cell));
  const bool has_target = std::ranges::any_of(
      columns, [](const Column& c) { return c.role == ColumnRole::target && !is_undecided_position(c); });
  for (Column& c : columns) {
    if (!is_undecided_position(c)) continue;
    if (has_target) {
      c.role = ColumnRole::reading;
    } else {
      c.measured = Measured::deviation;
    }
  }
  const auto plain = [](const Column& c, Measured m) {
    return c.role == ColumnRole::reading && !c.run && !c.direction && c.measured == m;
  };
  if (std::ranges::any_of(columns, [&](const Column& c) { return plain(c, Measured::deviation); }))
    for (Column& c : columns)
      if (plain(c, Measured::position)) c.role = ColumnRole::ignored;
  return columns;
}

std::optional<std::string> passed_over_text(const std::vector<Column>& columns) {
  std::string list;
  std::size_t count = 0;
  for (const Column& c : columns) {
    // A measured position beside a deviation is compared with it.
    if (c.role != ColumnRole::ignored || c.measured == Measured::position || text::trim(c.name).empty()) continue;
    list += fmt::format("{}{}", list.empty() ? "" : ", ", text::quoted(c.name));
    ++count;
  }
  if (count == 0) return std::nullopt;
  return count == 1 ? fmt::format("nothing was read of the column {}", list)
                    : fmt::format("nothing was read of the columns {}", list);
}

std::size_t needed_columns(const std::vector<Column>& columns) {
  std::size_t needed = columns.size();
  while (needed > 0 && columns[needed - 1].role == ColumnRole::ignored) --needed;
  return needed;
}

Result<std::optional<std::size_t>> only_column(const std::vector<Column>& columns, ColumnRole role, std::size_t line) {
  std::optional<std::size_t> found;
  for (std::size_t c = 0; c < columns.size(); ++c) {
    if (columns[c].role != role) continue;
    if (found)
      return fail(fmt::format("found the columns {} and {} of the same meaning, expected one of them",
                              text::quoted(columns[*found].name), text::quoted(columns[c].name)),
                  {line, columns[c].at_column});
    found = c;
  }
  return found;
}

namespace {

Result<void> settle_unit(Column& column, const Unit* default_unit, std::size_t line) {
  const TextPosition at{line, column.at_column};
  if (column.unit_text.empty()) column.unit = default_unit;
  if (column.unit != nullptr) return {};
  if (!column.unit_text.empty())
    return fail(fmt::format("found the unknown unit {} in the column {}, expected one of {}",
                            text::quoted(column.unit_text), text::quoted(column.name), unit_names()),
                at);
  return fail(
      fmt::format("found the column {} without a unit, expected one in its name such as {}", text::quoted(column.name),
                  column.role == ColumnRole::target ? "target_mm or target_deg, or a first line '# target unit: mm'"
                                                    : "deviation_um or deviation_arcsec, or a first line '# unit: um'"),
      at);
}

}  // namespace

Result<void> check_columns(std::vector<Column>& columns, const DefaultUnits& defaults, std::size_t line) {
  for (const Column& c : columns)
    if (c.role == ColumnRole::unknown)
      return fail(
          fmt::format(
              "found the unknown column {}, expected target, direction, run and deviation, or one column per run",
              text::quoted(c.name)),
          {line, c.at_column});
  AXIOMETRY_TRY(const auto target, only_column(columns, ColumnRole::target, line));
  if (!target) return fail("found no target column, expected one such as target_mm or target_deg", {line, 1});
  AXIOMETRY_TRY_VOID(settle_unit(columns[*target], defaults.target, line));
  const Column* first = nullptr;
  for (Column& c : columns) {
    if (c.role != ColumnRole::reading) continue;
    AXIOMETRY_TRY_VOID(settle_unit(c, defaults.reading, line));
    if (first == nullptr) first = &c;
    if (c.unit != first->unit)
      return fail(fmt::format("found the column {} in {} beside {} in {}, expected one unit", text::quoted(c.name),
                              c.unit->name, text::quoted(first->name), first->unit->name),
                  {line, c.at_column});
    if (c.measured != first->measured)
      return fail(fmt::format("found the columns {} and {}, expected deviations or measured positions, not both",
                              text::quoted(first->name), text::quoted(c.name)),
                  {line, c.at_column});
    if (auto kind = kind_of(*columns[*target].unit, *c.unit); !kind)
      return fail(kind.error().message, {line, c.at_column});
  }
  return {};
}

}  // namespace axiometry::formats
