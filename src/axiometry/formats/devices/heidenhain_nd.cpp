// SPDX-License-Identifier: Apache-2.0
//
// Compensation tables of HEIDENHAIN read-outs: ND 280 and 287 ('#'), ND 200 B and ND 700 ('*').
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

#include "axiometry/base/text/number_text.h"
#include "axiometry/base/text/text.h"
#include "axiometry/formats/format.h"
#include "axiometry/formats/series/approaches.h"
#include "axiometry/formats/text/csv_cells.h"
#include "axiometry/formats/text/decoded_text.h"
#include "axiometry/formats/text/text_lines.h"
#include "axiometry/formats/text/text_source.h"
#include "axiometry/formats/text/units.h"

namespace axiometry::formats {
namespace heidenhain_nd {
namespace {

constexpr std::uint64_t point_limit = 1000;    // the largest read-outs have 200
constexpr double step_of_exponents_mm = 1e-4;  // a spacing of n is 2^n of these
constexpr double rotary_spacing_deg = 5.0;     // of read-outs that compensate a full turn in 72 points
constexpr double largest_exponent = 30.0;      // 107 m

enum class Angles { none, decimal, minutes_and_seconds };

struct ReadOut {
  std::string model;
  const Unit* unit = nullptr;
  Angles angles = Angles::none;
};

struct UnitWord {
  std::string_view word;
  std::string_view unit;
  Angles angles;
};

constexpr UnitWord unit_words[] = {
    {"mm", "mm", Angles::none},      {"in", "in", Angles::none},      {"inch", "in", Angles::none},
    {"deg", "deg", Angles::decimal}, {"dec", "deg", Angles::decimal}, {"dms", "deg", Angles::minutes_and_seconds},
};

/// "ND-280   MM": the model, and as its last word the unit.
std::optional<ReadOut> read_out_from(std::string_view line) {
  const auto words = text::words(line);
  if (words.size() < 2 || !text::to_lower(words.front()).starts_with("nd")) return std::nullopt;
  for (const UnitWord& u : unit_words) {
    if (!text::equal_ignoring_case(u.word, words.back())) continue;
    const std::size_t size = static_cast<std::size_t>(words.back().data() - line.data());
    return ReadOut{std::string(text::trim(line.substr(0, size))), find_unit(u.unit), u.angles};
  }
  return std::nullopt;
}

bool is_mark(std::string_view line) { return line == "#" || line == "*"; }

/// "CMP. NR. 07", "COMP. NO. 007" (or with a zero in N0.), "X NR. 07": the number of a point.
std::optional<std::size_t> point_number(std::string_view label) {
  const std::string name = text::to_lower(label);
  const auto words = text::words(name);
  if (words.size() < 2) return std::nullopt;
  const std::string_view kind = words[words.size() - 2];
  if (kind != "nr." && kind != "no." && kind != "n0.") return std::nullopt;
  const auto number = parse_count(words.back());
  if (!number || *number >= point_limit) return std::nullopt;
  return static_cast<std::size_t>(*number);
}

bool is_empty_value(std::string_view value) {
  return value.empty() || value.find_first_not_of('-') == std::string_view::npos;
}

struct Value {
  std::size_t number = 0;
  std::optional<double> position{};  ///< in the unit of the read-out, where the line states it
  double value = 0.0;
  TextPosition at;
};

struct Table {
  ReadOut read_out;
  std::string axis;
  std::optional<double> spacing;  ///< mm or °
  double datum = 0.0;
  std::vector<Value> values;
};

class TableReader {
 public:
  Result<Table> read(std::string_view text) {
    for (const TextLine& line : content_lines(text)) AXIOMETRY_TRY_VOID(take(line));
    if (table_.read_out.unit == nullptr)
      return fail("found no model and unit of a read-out, expected a line such as 'ND-280  MM' behind the start mark");
    if (!ended_) return fail("found no end mark, expected # or * behind the last value; is the table cut off?");
    return std::move(table_);
  }

 private:
  Result<void> take(const TextLine& line) {
    if (is_mark(line.text)) {
      ended_ = begun_;
      begun_ = true;
      return {};
    }
    if (ended_)
      return fail(fmt::format("found {} behind the end mark, expected one table; a file of several must be parted",
                              text::quoted(line.text)),
                  {line.number, line.column});
    if (table_.read_out.unit == nullptr) {
      const auto read_out = read_out_from(line.text);
      if (!read_out)
        return fail(fmt::format("found {}, expected model and unit of the read-out (MM, IN, DEC or DMS)",
                                text::quoted(line.text)),
                    {line.number, line.column});
      table_.read_out = *read_out;
      return {};
    }
    const auto parts = text::split(line.text, '=');
    if (parts.size() < 2)
      return fail(fmt::format("found {}, expected a name, = and a value", text::quoted(line.text)),
                  {line.number, line.column});
    return take_item(line, text::trim(parts[0]), parts);
  }

  Result<void> take_item(const TextLine& line, std::string_view label, const std::vector<std::string_view>& parts) {
    const std::string name = text::to_lower(label);
    const std::string_view value = text::trim(parts[1]);
    if (name.contains(" fct. ")) return check_cause(line, label);
    if (name.starts_with("axis")) {
      table_.axis = text::trim(label.substr(4));
    } else if (name.starts_with("spacing") || name.starts_with("pktabst")) {
      AXIOMETRY_TRY(table_.spacing, spacing_from(value, line));
    } else if (name.starts_with("datum") && !is_empty_value(value)) {
      AXIOMETRY_TRY(table_.datum, number_from(value, line));
    } else if (const auto number = point_number(label)) {
      return take_value(line, *number, parts);
    }
    return {};
  }

  /// "X FCT. Y": the error of X as a function of Y is no positioning error.
  Result<void> check_cause(const TextLine& line, std::string_view label) {
    const auto words = text::words(label);
    if (words.size() == 3 && words[0] == words[2]) return {};
    return fail(fmt::format("found {}, expected the error of an axis as a function of itself", text::quoted(label)),
                {line.number, line.column});
  }

  /// A whole number is an exponent: 2^n · 0.1 µm; with a decimal mark it is a length.
  Result<double> spacing_from(std::string_view value, const TextLine& line) {
    AXIOMETRY_TRY(const double spacing, number_from(value, line));
    if (!(spacing > 0.0))
      return fail(fmt::format("found the spacing {}, expected more than zero", text::quoted(value)), line.at(value));
    if (value.find_first_of(".,") != std::string_view::npos)
      return position_in(*table_.read_out.unit, spacing).in_native();
    if (spacing > largest_exponent || table_.read_out.unit->kind == AxisKind::rotary)
      return fail(fmt::format("found the spacing {}, expected a length with a decimal mark or an exponent up to {}",
                              text::quoted(value), largest_exponent),
                  line.at(value));
    return std::ldexp(step_of_exponents_mm, static_cast<int>(spacing));
  }

  /// The sign may stand far from its digits; angles may be in degrees, minutes and seconds: "- 0.00.43".
  Result<double> number_from(std::string_view value, const TextLine& line) {
    std::string plain(value);
    std::erase(plain, ' ');
    if (table_.read_out.angles != Angles::minutes_and_seconds) return numbers_.read(plain, line.at(value));
    const double sign = plain.starts_with('-') ? -1.0 : 1.0;
    if (plain.starts_with('-') || plain.starts_with('+')) plain.erase(0, 1);
    const auto parts = text::split(plain, '.');
    std::array<double, 3> angle{};
    bool valid = parts.size() == 3;
    for (std::size_t k = 0; valid && k < 3; ++k) {
      const auto count = parse_count(parts[k]);
      valid = count && (k == 0 || *count < 60);
      if (valid) angle[k] = static_cast<double>(*count);
    }
    if (valid) return sign * (angle[0] + angle[1] / 60.0 + angle[2] / 3600.0);
    return fail(fmt::format("found {}, expected degrees.minutes.seconds", text::quoted(value)), line.at(value));
  }

  Result<void> take_value(const TextLine& line, std::size_t number, const std::vector<std::string_view>& parts) {
    const std::string_view last = text::trim(parts.back());
    if (is_empty_value(last)) return {};
    const auto again = std::ranges::find(table_.values, number, &Value::number);
    if (again != table_.values.end())
      return fail(fmt::format("found point {} again, expected only that on line {}", number, again->at.line),
                  {line.number, line.column});
    Value value{.number = number, .at = line.at(last)};
    AXIOMETRY_TRY(value.value, number_from(last, line));
    if (parts.size() == 3) {
      AXIOMETRY_TRY(value.position, number_from(text::trim(parts[1]), line));
    }
    table_.values.push_back(value);
    return {};
  }

  Table table_;
  NumberReader numbers_{' '};
  bool begun_ = false;
  bool ended_ = false;
};

Result<Position> position_of(const Value& value, const Table& table) {
  const Unit& unit = *table.read_out.unit;
  if (value.position) return position_in(unit, *value.position);
  std::optional<double> spacing = table.spacing;
  if (!spacing && unit.kind == AxisKind::rotary) spacing = rotary_spacing_deg;
  if (!spacing)
    return fail(fmt::format("found point {} without a position, expected a line SPACING", value.number), value.at);
  const double datum = position_in(unit, table.datum).in_native();
  return Position::native(datum + static_cast<double>(value.number) * *spacing);
}

Result<Test> read(std::string_view bytes) {
  AXIOMETRY_TRY(const DecodedText decoded, decoded_text(bytes));
  AXIOMETRY_TRY(const Table table, TableReader().read(decoded.text));
  const ReadingRule rule{Measured::deviation, table.read_out.unit};
  std::vector<ListedReading> approaches;
  for (const Value& value : table.values) {
    ListedReading approach{.at = value.at};
    AXIOMETRY_TRY(approach.target, position_of(value, table));
    AXIOMETRY_TRY(const double deviation, placed(native_deviation(rule, approach.target, value.value), value.at));
    approach.deviation = Deviation::native(deviation);
    approaches.push_back(approach);
  }
  if (approaches.empty()) return fail("found no compensation values, expected at least two");
  AXIOMETRY_TRY(GatheredSeries result, gathered(approaches));
  Test test{Metadata{}, std::move(result.series), Provenance{}};
  test.metadata.axis.kind = table.read_out.unit->kind;
  test.metadata.axis.name = table.axis;
  test.metadata.conditions.comment = fmt::format("Compensation table of {}", table.read_out.model);
  test.provenance.remarks = encoding_remarks(decoded);
  test.provenance.remarks.push_back(
      {true, "found a compensation table, expected measured approaches; its values stand under ↑ with the sign found"});
  return test;
}

/// "ND-280", "ND 231 B".
bool is_model(std::string_view line) {
  const std::string name = text::to_lower(line.substr(0, 4));
  return name.size() == 4 && name.starts_with("nd") && (name[2] == '-' || name[2] == ' ') && name[3] >= '0' &&
         name[3] <= '9';
}

int recognise(std::string_view head) {
  bool marked = false;
  for (const TextLine& line : content_lines(head)) {
    if (!is_mark(line.text)) return marked && is_model(line.text) ? 96 : 0;
    marked = true;
  }
  return 0;
}

constexpr std::string_view manual =
    R"(The compensation table of a HEIDENHAIN read-out, as it is sent over the data interface.

```
#
ND-287             MM
AXIS X1       =      0
DATUM         =      +0.0000
COMP. NO. 000 =      +0.0000 =      +0.0000
COMP. NO. 001 =     +50.0000 =      +0.0012
COMP. NO. 002 =    +100.0000 =      +0.0031
COMP. NO. 003 =   ---------- =   ----------
#
```

- Begins and ends with `#` (ND 280, ND 287) or `*` (ND 200 B, ND 700). The second line names the model and the unit: MM,
  IN, DEC (degrees) or DMS (degrees.minutes.seconds).
- `COMP. NO.` lines state position and value. `CMP. NR.` or `X NR.` lines state the value alone: its position is `DATUM`
  plus its number times `SPACING` (`PKTABST.`). A spacing with a decimal mark is a length in the unit of the file, a
  whole number n is 2ⁿ·0.1 µm, so 16 is 6.5536 mm. Angular tables without a spacing have steps of 5°.
- `----------` is an empty point and left out. `X FCT. Y` tables, errors of one axis caused by another, are refused.
- The values stand under ↑ as the only run, with the sign as found: whether they are errors or corrections is the
  read-out's business. They are no measured approaches, so the test is no test after ISO 230-2.
- Refused: a table without its end mark, a point given twice, several tables in one file.
)";

}  // namespace
}  // namespace heidenhain_nd

extern const Format heidenhain_nd_format;
const Format heidenhain_nd_format = {
    .id = "heidenhain-nd",
    .title = "HEIDENHAIN ND read-out, compensation table",
    .extensions = ".txt",
    .manual = heidenhain_nd::manual,
    .recognise = heidenhain_nd::recognise,
    .read = heidenhain_nd::read,
};

}  // namespace axiometry::formats
