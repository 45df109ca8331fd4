// SPDX-License-Identifier: Apache-2.0
#include "axiometry/formats/csv/csv_preamble.h"

#include <fmt/format.h>

#include <algorithm>
#include <optional>

#include "axiometry/base/text/text.h"
#include "axiometry/formats/text/text_source.h"
#include "axiometry/model/fields.h"

namespace axiometry::formats {
namespace {

constexpr KeyAlias aliases[] = {
    {"axis", "axis.name"},
    {"axis_kind", "axis.kind"},
    {"scale", "axis.scale_type"},
    {"compensation", "axis.compensation"},
    {"machine", "machine.name"},
    {"machine_type", "machine.type"},
    {"serial_number", "machine.serial_number"},
    {"serial_no", "machine.serial_number"},
    {"serial", "machine.serial_number"},
    {"s/n", "machine.serial_number"},
    {"location", "machine.location"},
    {"date", "test.date"},
    {"date_of_test", "test.date"},
    {"inspector", "test.inspector"},
    {"operator", "test.inspector"},
    {"laboratory", "test.laboratory"},
    {"lab", "test.laboratory"},
    {"customer", "test.customer"},
    {"report_number", "test.report_number"},
    {"purpose", "test.purpose"},
    {"comment", "test.comment"},
    {"note", "test.comment"},
    {"remark", "test.comment"},
    {"cycle", "test.cycle"},
    {"feed", "test.feed"},
    {"feed_rate", "test.feed"},
    {"feed_speed", "test.feed"},
    {"feedrate", "test.feed"},
    {"dwell", "test.dwell_s"},
    {"dwell_time", "test.dwell_s"},
    {"warm_up", "test.warm_up"},
    {"sensor", "sensors"},
    {"instrument", "equipment"},
    {"maschine", "machine.name"},
    {"maschinentyp", "machine.type"},
    {"seriennummer", "machine.serial_number"},
    {"achse", "axis.name"},
    {"datum", "test.date"},
    {"prüfer", "test.inspector"},
    {"bediener", "test.inspector"},
    {"labor", "test.laboratory"},
    {"kunde", "test.customer"},
    {"bemerkung", "test.comment"},
    {"vorschub", "test.feed"},
};

constexpr std::string_view reading_unit_keys[] = {"unit", "units", "deviation_unit", "reading_unit"};
constexpr std::string_view target_unit_keys[] = {"target_unit", "position_unit"};

struct KeyAndValue {
  std::string key;  // lower case, blanks and hyphens as underscores
  std::string_view value;
  std::size_t value_column;
};

/// Spreadsheets quote a cell with commas and fill the row up with delimiters; both are undone.
std::string_view without_spreadsheet_traces(std::string_view line) {
  line = text::trim(line);
  while (!line.empty() && (line.back() == ';' || line.back() == ',' || line.back() == '\t')) line.remove_suffix(1);
  if (line.starts_with("\"#") && line.ends_with('"')) line = line.substr(1, line.size() - 2);
  return line;
}

std::optional<KeyAndValue> key_and_value(std::string_view line) {
  const std::string_view content = without_spreadsheet_traces(line);
  const std::size_t begin = content.find_first_not_of("# \t");
  const std::size_t colon = content.find(':');
  if (begin == std::string_view::npos || colon == std::string_view::npos || colon < begin) return std::nullopt;
  std::string key = text::to_lower(text::trim(content.substr(begin, colon - begin)));
  std::ranges::replace(key, ' ', '_');
  std::ranges::replace(key, '-', '_');
  const std::string_view value = text::trim(content.substr(colon + 1));
  const char* place = value.empty() ? content.data() + colon : value.data();
  return KeyAndValue{std::move(key), value, static_cast<std::size_t>(place - line.data()) + 1};
}

/// "machine.nam" is meant as a key; "ISO 230-2:2014" and "http://…" are not.
bool looks_like_a_path(std::string_view key) {
  const auto is_key_char = [](char c) {
    return (c >= 'a' && c <= 'z') || (c >= '0' && c <= '9') || c == '_' || c == '.';
  };
  return key.find('.') != std::string_view::npos && std::ranges::all_of(key, is_key_char) && !key.starts_with('.') &&
         !key.ends_with('.');
}

std::vector<std::string_view> known_keys() {
  std::vector<std::string_view> keys;
  for (const Field& field : metadata_fields()) keys.push_back(field.key);
  for (const KeyAlias& alias : aliases) keys.push_back(alias.alias);
  keys.insert(keys.end(), std::begin(reading_unit_keys), std::end(reading_unit_keys));
  keys.insert(keys.end(), std::begin(target_unit_keys), std::end(target_unit_keys));
  return keys;
}

/// Keys are compared without regard to case; "Machine name" stands for machine.name.
bool spells(std::string_view field_key, std::string_view key) {
  std::string plain(field_key);
  if (key.find('.') == std::string_view::npos) std::ranges::replace(plain, '.', '_');
  return text::equal_ignoring_case(plain, key);
}

/// The field that a key names; nothing for a comment.
Result<std::optional<std::string>> field_key(const std::string& key, TextPosition at) {
  const auto fields = metadata_fields();
  const auto field = std::ranges::find_if(fields, [&](const Field& f) { return spells(f.key, key); });
  if (field != fields.end()) return std::string(field->key);
  const auto alias = std::ranges::find(aliases, std::string_view(key), &KeyAlias::alias);
  if (alias != std::end(aliases)) return std::string(alias->key);
  if (text::is_one_of(key, reading_unit_keys) || text::is_one_of(key, target_unit_keys)) return key;
  const auto near = text::nearest(key, known_keys());
  constexpr std::size_t shortest_word_with_a_typing_error = 6;
  if (looks_like_a_path(key) || (near && key.size() >= shortest_word_with_a_typing_error))
    return fail(fmt::format("found the unknown key {}, expected {}", text::quoted(key),
                            near ? fmt::format("perhaps {}", *near) : std::string("one of the metadata keys")),
                at);
  return std::nullopt;
}

/// "# air temperature: 68 F", by its few words; "# Readings: ISO 230-2:2014, Table 2. All else is made up" is prose, as
/// "# taken from "x.rtl", read as …" is.
bool looks_like_a_particular(const KeyAndValue& pair) {
  constexpr std::ptrdiff_t most_words = 3;
  return !pair.value.empty() && std::ranges::count(pair.key, '_') < most_words &&
         std::ssize(text::words(pair.value)) <= most_words;
}

Result<void> take_comment_line(Preamble& preamble, std::string_view line, std::size_t number) {
  const auto pair = key_and_value(line);
  if (!pair) return {};
  if (pair->key == source_remark_key) {
    if (!pair->value.empty()) preamble.remarks.push_back({false, std::string(first_read).append(pair->value)});
    return {};
  }
  AXIOMETRY_TRY(auto key, field_key(pair->key, {number, line.find_first_not_of("\"# \t") + 1}));
  if (!key) {
    if (looks_like_a_particular(*pair)) preamble.passed_over.add(line);
    return {};
  }
  const TextPosition at{number, pair->value_column};
  const bool reading = text::is_one_of(*key, reading_unit_keys);
  if (!reading && !text::is_one_of(*key, target_unit_keys)) {
    preamble.metadata.push_back({std::move(*key), std::string(pair->value), at});
    return {};
  }
  const Unit* unit = find_unit(pair->value);
  if (unit == nullptr)
    return fail(fmt::format("found the unknown unit {}, expected one of {}", text::quoted(pair->value), unit_names()),
                at);
  const Unit*& stated = reading ? preamble.default_units.reading : preamble.default_units.target;
  if (stated != nullptr && stated != unit)
    return fail(fmt::format("found the unit {} of the {}, expected only {}, which a line above states", unit->name,
                            reading ? "readings" : "targets", stated->name),
                at);
  stated = unit;
  return {};
}

bool is_comment(std::string_view line) { return line.starts_with('#') || line.starts_with("\"#"); }
bool is_separator_hint(std::string_view line) { return line.size() <= 5 && line.starts_with("sep="); }

bool is_header(std::string_view line) {
  const std::string_view content = text::trim(line);
  return !content.empty() && !is_comment(content) && !is_separator_hint(content);
}

class LineWalk {
 public:
  explicit LineWalk(std::string_view text) : text_(text) {}

  std::optional<std::string_view> next() {
    if (offset_ == text_.size()) return std::nullopt;
    const std::size_t end = std::min(text_.find('\n', offset_), text_.size());
    const std::string_view line = text_.substr(offset_, end - offset_);
    offset_ = std::min(end + 1, text_.size());
    ++number_;
    return line;
  }

  std::size_t number() const { return number_; }  ///< number of the line last given
  std::size_t offset() const { return offset_; }  ///< behind it

 private:
  std::string_view text_;
  std::size_t offset_ = 0;
  std::size_t number_ = 0;
};

/// Whether names of columns stand in the line: a target and what is measured there.
bool names_columns(const std::vector<Column>& columns) {
  const auto has = [&](ColumnRole role) { return std::ranges::find(columns, role, &Column::role) != columns.end(); };
  return has(ColumnRole::target) && (has(ColumnRole::reading) || has(ColumnRole::direction) || has(ColumnRole::run));
}

struct HeaderLine {
  std::string names;  // the line, with a blank in place of a # before them
  std::size_t number = 0;
};

std::vector<Column> columns_in(std::string_view line, std::size_t number) {
  const auto cells = split_row(line, delimiter_of(line), number);
  return cells ? columns_from(*cells) : std::vector<Column>{};
}

/// Array libraries write the header as a comment: "# target_mm,direction,run,deviation_um". Nothing else may stand
/// in it.
std::optional<HeaderLine> header_in_comment(std::string_view line, std::size_t number) {
  const std::size_t mark = line.find('#');
  if (mark == std::string_view::npos || !text::trim(line).starts_with('#')) return std::nullopt;
  HeaderLine header{std::string(line), number};
  header.names[mark] = ' ';
  const std::vector<Column> columns = columns_in(header.names, number);
  const bool pure = std::ranges::find(columns, ColumnRole::unknown, &Column::role) == columns.end();
  if (columns.size() < 3 || !pure || !names_columns(columns)) return std::nullopt;
  return header;
}

/// The first line that names columns, above which instruments print what they know of the test; also one in a
/// comment, when the next line does not name them. When no line names columns, the first that is neither blank nor a
/// comment, whose faults are then told.
std::optional<HeaderLine> find_header(std::string_view text) {
  constexpr std::size_t lines_above_at_most = 200;
  std::optional<HeaderLine> first;
  std::optional<HeaderLine> in_comment;
  LineWalk lines(text);
  while (const auto line = lines.next()) {
    if (is_comment(text::trim(*line))) {
      if (auto header = first ? std::nullopt : header_in_comment(*line, lines.number())) in_comment = std::move(header);
      continue;
    }
    if (!is_header(*line)) continue;
    HeaderLine here{std::string(*line), lines.number()};
    if (names_columns(columns_in(*line, lines.number()))) return here;
    if (in_comment) return in_comment;
    if (!first) first = std::move(here);
    if (lines.number() >= first->number + lines_above_at_most) return first;
  }
  return first ? first : in_comment;
}

/// A number or a word of direction, which no header holds alone.
bool is_datum(const CsvCell& cell) {
  return direction_from(cell.text) || NumberReader(';').read(cell.text, {}).has_value();
}

/// Tells the usual reasons why a line is no header.
Result<void> check_header(const HeaderLine& header, const std::vector<CsvCell>& cells) {
  if (cells.size() > 1 && std::ranges::all_of(cells, is_datum))
    return fail(fmt::format("found a row of readings, expected a header above it that names the columns, such as {}",
                            long_table_head(AxisKind::linear)),
                {header.number, 1});
  if (cells.size() > 1) return {};
  std::vector<CsvCell> words;
  for (std::string_view word : text::words(header.names)) words.push_back({std::string(word), 1});
  if (words.size() > 2 && names_columns(columns_from(words)))
    return fail("found columns separated by blanks, expected commas, semicolons or tabs between them",
                {header.number, 1});
  return {};
}

/// A unit stated for the whole file is that of columns without one.
void remark_other_units(Preamble& preamble) {
  for (const Column& c : preamble.columns) {
    const bool reading = c.role == ColumnRole::reading;
    if (!reading && c.role != ColumnRole::target) continue;
    const Unit* stated = reading ? preamble.default_units.reading : preamble.default_units.target;
    if (stated == nullptr || c.unit == nullptr || c.unit == stated) continue;
    preamble.remarks.push_back(
        {false,
         fmt::format("the unit {} that is stated above the table is not that of the column {}, whose own is taken",
                     stated->symbol, text::quoted(c.name))});
    return;
  }
}

/// What an instrument prints above the header, "Machine:;Mill 5" or "Machine: Mill 5"; all but known keys is passed
/// over, and told.
Result<void> take_plain_line(Preamble& preamble, std::string_view line, std::size_t number) {
  const auto cells = split_row(line, delimiter_of(line), number);
  if (!cells || cells->empty()) return {};
  std::string pair = "# " + cells->front().text;
  if (pair.find(':') == std::string::npos) pair += ':';
  for (std::size_t k = 1; k < cells->size(); ++k)
    if (!(*cells)[k].text.empty()) pair += " " + (*cells)[k].text;
  // A second unit is a contradiction here too; a word that is no unit may be anything.
  if (const auto said = key_and_value(pair);
      said && find_unit(said->value) != nullptr &&
      (text::is_one_of(said->key, reading_unit_keys) || text::is_one_of(said->key, target_unit_keys)))
    return take_comment_line(preamble, pair, number);
  Preamble trial = preamble;
  if (take_comment_line(trial, pair, number) && trial.metadata.size() > preamble.metadata.size())
    preamble = std::move(trial);
  else
    preamble.passed_over.add(line);
  return {};
}

}  // namespace

std::span<const KeyAlias> key_aliases() { return aliases; }

void LinesPassedOver::add(std::string_view line) {
  if (count++ == 0) first = text::trim(line);
}

std::optional<SourceRemark> LinesPassedOver::remark() const {
  if (count == 0) return std::nullopt;
  return SourceRemark{
      false, count == 1 ? fmt::format("1 line above the table told nothing that is known and was passed over: {}",
                                      text::quoted(first))
                        : fmt::format("{} lines above the table told nothing that is known and were passed over, the "
                                      "first of them {}",
                                      count, text::quoted(first))};
}

Result<bool> is_metadata_line(std::string_view line, std::size_t line_number) {
  Preamble scratch;
  AXIOMETRY_TRY_VOID(take_comment_line(scratch, line, line_number));
  return !scratch.metadata.empty() || scratch.default_units.reading != nullptr ||
         scratch.default_units.target != nullptr;
}

Result<Preamble> read_preamble(std::string_view text) {
  Preamble preamble;
  const auto header = find_header(text);
  LineWalk lines(text);
  while (const auto line = lines.next()) {
    AXIOMETRY_TRY_VOID(check_utf8(*line, lines.number()));
    if (header && lines.number() == header->number) break;
    if (is_comment(text::trim(*line))) {
      AXIOMETRY_TRY_VOID(take_comment_line(preamble, *line, lines.number()));
    } else if (is_header(*line)) {
      AXIOMETRY_TRY_VOID(take_plain_line(preamble, *line, lines.number()));
    }
  }
  preamble.size = lines.offset();
  if (!header) return preamble;
  preamble.header_line = header->number;
  preamble.delimiter = delimiter_of(header->names);
  AXIOMETRY_TRY(const std::vector<CsvCell> cells, split_row(header->names, preamble.delimiter, header->number));
  AXIOMETRY_TRY_VOID(check_header(*header, cells));
  preamble.columns = columns_from(cells);
  if (auto remark = preamble.passed_over.remark()) preamble.remarks.push_back(*std::move(remark));
  remark_other_units(preamble);
  return preamble;
}

std::vector<Column> header_columns(std::string_view text) {
  const auto header = find_header(text);
  return header ? columns_in(header->names, header->number) : std::vector<Column>{};
}

bool has_faulty_header(std::string_view text) {
  const auto header = find_header(text);
  if (!header) return false;
  const auto cells = split_row(header->names, delimiter_of(header->names), header->number);
  return cells && !check_header(*header, *cells);
}

}  // namespace axiometry::formats
