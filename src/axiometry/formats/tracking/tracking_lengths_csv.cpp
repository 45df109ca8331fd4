// SPDX-License-Identifier: Apache-2.0
#include "axiometry/formats/tracking/tracking_lengths_csv.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <optional>
#include <tuple>
#include <utility>

#include "axiometry/base/text/number_text.h"
#include "axiometry/base/text/text.h"
#include "axiometry/formats/csv/csv_values.h"
#include "axiometry/formats/text/csv_cells.h"
#include "axiometry/formats/text/decoded_text.h"
#include "axiometry/formats/text/simulated_note.h"
#include "axiometry/formats/text/table_heads.h"
#include "axiometry/formats/text/text_source.h"
#include "axiometry/model/simulated.h"

namespace axiometry::formats {
namespace {

constexpr double position_slack_mm = 0.05;
constexpr double segment_most = 1e6;

enum LengthsRole : std::size_t {
  line_role,
  target_role,
  direction_role,
  run_role,
  length_role,
  segment_role,
  time_role,
  roles
};

std::optional<LengthsRole> lengths_role_of(const TableHead& head) {
  if (head.name == "line") return line_role;
  if (head.name == "target" || head.name == "position" || head.name == "target position") return target_role;
  if (head.name == "direction" || head.name == "dir" || head.name == "approach") return direction_role;
  if (head.name == "run") return run_role;
  if (head.name == "segment") return segment_role;
  if (head.name == "time" && head.unit == "s") return time_role;
  if (head.name == "length" || is_length_difference(head.name)) return length_role;
  return std::nullopt;
}

struct LengthsColumns {
  std::array<std::optional<std::size_t>, roles> at;
  const Unit* length_unit = nullptr;
  const Unit* position_unit = nullptr;  // null: targets by number
  std::size_t count = 0;
  std::size_t needed = 0;  // up to the last one that is read
  std::size_t line = 0;
  char delimiter = ',';
  std::vector<std::string> passed_over;

  bool labelled() const { return at[line_role] || at[target_role] || at[direction_role] || at[run_role]; }
};

Result<void> check_labels(const LengthsColumns& columns) {
  const auto missing = [&](std::string_view name) {
    return fail(fmt::format("found no column {}, expected line, target, direction, run and length_difference_mm, or "
                            "length_difference_mm alone for lengths in the order of the program",
                            name),
                {columns.line, 1});
  };
  if (!columns.at[length_role]) return missing("length_difference_mm");
  if (!columns.labelled()) return {};
  if (!columns.at[line_role]) return missing("line");
  if (!columns.at[target_role]) return missing("target");
  return {};
}

Result<LengthsColumns> lengths_columns_of(std::string_view header, std::size_t line) {
  LengthsColumns columns;
  columns.line = line;
  columns.delimiter = delimiter_of(header);
  AXIOMETRY_TRY(const std::vector<CsvCell> heads, split_row(header, columns.delimiter, line));
  columns.count = heads.size();
  if (columns.count == 1) columns.delimiter = ';';  // nothing to part: a comma is the decimal mark
  for (std::size_t k = 0; k < heads.size(); ++k) {
    const TableHead named = table_head(heads[k].text);
    const auto role = lengths_role_of(named);
    if (!role) {
      if (!heads[k].text.empty()) columns.passed_over.push_back(heads[k].text);
      continue;
    }
    if (columns.at[*role])
      return fail(fmt::format("found {} a second time, expected one column of it", text::quoted(heads[k].text)),
                  {line, heads[k].column});
    columns.at[*role] = k;
    columns.needed = k + 1;
    if (*role == length_role) {
      AXIOMETRY_TRY(columns.length_unit, length_unit(heads[k], named, "length_difference_mm", line));
    }
    if (*role == target_role && !(named.name == "target" && named.unit.empty())) {
      AXIOMETRY_TRY(columns.position_unit, length_unit(heads[k], named, "position_mm", line));
    }
  }
  AXIOMETRY_TRY_VOID(check_labels(columns));
  return columns;
}

/// Rows below the header, one after the other.
class Reader {
 public:
  Reader(const TrackingPlan& plan, LengthsColumns columns)
      : plan_(plan), columns_(std::move(columns)), numbers_(columns_.delimiter) {}

  Result<void> row(const TableLine& line, TrackingLengths& lengths) {
    AXIOMETRY_TRY(const std::vector<CsvCell> cells, split_row(line.text, columns_.delimiter, line.number));
    AXIOMETRY_TRY_VOID(check_cell_count(cells, {.expected = columns_.count,
                                                .needed = columns_.needed,
                                                .header_line = columns_.line,
                                                .line = line.number,
                                                .delimiter = columns_.delimiter,
                                                .cut_off = !line.has_break}));
    LengthRow row;
    row.at = {line.number, cells[*columns_.at[length_role]].column};
    row.missing = is_missing(cells[*columns_.at[length_role]].text);
    if (!row.missing) {
      AXIOMETRY_TRY(const double value, numbers_.read(cells[*columns_.at[length_role]].text, row.at));
      AXIOMETRY_TRY(row.reading.length_difference_mm,
                    length_in_mm(*columns_.length_unit, value, cells[*columns_.at[length_role]].text, row.at));
    }
    if (columns_.at[segment_role]) {
      AXIOMETRY_TRY(row.reading.segment, segment_of(cells[*columns_.at[segment_role]], line.number));
    }
    if (columns_.at[time_role] && !is_missing(cells[*columns_.at[time_role]].text)) {
      const CsvCell& cell = cells[*columns_.at[time_role]];
      AXIOMETRY_TRY(row.time_s, numbers_.read(cell.text, {line.number, cell.column}));
    }
    if (columns_.labelled()) {
      AXIOMETRY_TRY_VOID(label(cells, line.number, row));
      if (row.missing) return {};
    }
    lengths.rows.push_back(std::move(row));
    return {};
  }

 private:
  using Place = std::tuple<std::size_t, std::size_t, Direction>;

  Result<std::size_t> segment_of(const CsvCell& cell, std::size_t line) {
    const auto number = parse_number(cell.text);
    if (number && *number >= 0 && *number <= segment_most && std::floor(*number) == *number)
      return static_cast<std::size_t>(*number);
    return fail(fmt::format("found the segment {}, expected a whole number from 0", text::quoted(cell.text)),
                {line, cell.column});
  }

  Result<std::size_t> line_of(const CsvCell& cell, std::size_t line) const {
    std::vector<std::string_view> ids;
    for (std::size_t k = 0; k < plan_.lines.size(); ++k) {
      if (text::equal_ignoring_case(plan_.lines[k].id, cell.text)) return k;
      ids.push_back(plan_.lines[k].id);
    }
    return fail(
        fmt::format("found the line {}, expected one of the plan's: {}", text::quoted(cell.text), fmt::join(ids, ", ")),
        {line, cell.column});
  }

  Result<std::size_t> target_of(const CsvCell& cell, const TrackingLine& own, std::size_t line) {
    const TextPosition at{line, cell.column};
    AXIOMETRY_TRY(const double value, numbers_.read(cell.text, at));
    const auto& targets = own.plan.targets;
    if (columns_.position_unit == nullptr) {
      if (value >= 1 && value <= static_cast<double>(targets.size()) && std::floor(value) == value)
        return static_cast<std::size_t>(value) - 1;
      return fail(fmt::format("found target {} of line {}, expected a whole number from 1 to {}; positions need a "
                              "unit in the header, as in position_mm",
                              text::quoted(cell.text), own.id, targets.size()),
                  at);
    }
    AXIOMETRY_TRY(const double position, length_in_mm(*columns_.position_unit, value, cell.text, at));
    std::size_t nearest = 0;
    double interval = std::numeric_limits<double>::infinity();
    for (std::size_t i = 0; i < targets.size(); ++i) {
      if (std::abs(targets[i].in_native() - position) < std::abs(targets[nearest].in_native() - position)) nearest = i;
      if (i > 0) interval = std::min(interval, targets[i].in_native() - targets[i - 1].in_native());
    }
    if (std::abs(targets[nearest].in_native() - position) <= std::min(position_slack_mm, 0.25 * interval))
      return nearest;
    return fail(fmt::format("found the position {} mm of line {}, expected a target of the plan; the nearest is {} mm",
                            format_exact(position), own.id, format_exact(targets[nearest].in_native())),
                at);
  }

  Result<Direction> direction_of(const std::vector<CsvCell>& cells, const TrackingLine& own, std::size_t line) const {
    if (!columns_.at[direction_role]) {
      if (own.plan.cycle == TestCycle::unidirectional) return Direction::up;
      return fail(
          fmt::format("found no column direction, expected one for line {}, which is run in both directions", own.id),
          {columns_.line, 1});
    }
    const CsvCell& cell = cells[*columns_.at[direction_role]];
    if (const auto direction = direction_from(cell.text)) return *direction;
    return fail(fmt::format("found the direction {}, expected {}", text::quoted(cell.text), direction_words),
                {line, cell.column});
  }

  Result<void> label(const std::vector<CsvCell>& cells, std::size_t line, LengthRow& row) {
    AXIOMETRY_TRY(const std::size_t number, line_of(cells[*columns_.at[line_role]], line));
    const TrackingLine& own = plan_.lines[number];
    Approach& approach = row.reading.approach;
    row.reading.line = own.id;
    AXIOMETRY_TRY(approach.target, target_of(cells[*columns_.at[target_role]], own, line));
    AXIOMETRY_TRY(approach.direction, direction_of(cells, own, line));
    const Place place{number, approach.target, approach.direction};
    if (columns_.at[run_role]) {
      const CsvCell& cell = cells[*columns_.at[run_role]];
      AXIOMETRY_TRY(const std::size_t run, run_number(cell.text, {line, cell.column}));
      approach.run = run - 1;
    } else {
      approach.run = approaches_[place]++;
    }
    const auto [first, is_new] = seen_.emplace(std::pair{place, approach.run}, line);
    if (is_new) return {};
    return fail(
        fmt::format("found target {}{} run {} of line {} a second time, expected each reading once; the first is "
                    "on line {}",
                    approach.target + 1, arrow(approach.direction), approach.run + 1, own.id, first->second),
        {line, 1});
  }

  const TrackingPlan& plan_;
  LengthsColumns columns_;
  NumberReader numbers_;
  std::map<Place, std::size_t> approaches_;
  std::map<std::pair<Place, std::size_t>, std::size_t> seen_;
};

/// `# key: value`, and that nobody measured; other comments are none of ours.
Result<void> take_comment(std::string_view content, std::size_t line, TrackingLengths& lengths) {
  Metadata& metadata = lengths.metadata;
  if (is_simulated_note(content)) {
    lengths.remarks.push_back({false, std::string(simulated_lengths)});
    if (metadata.conditions.purpose.empty()) metadata.conditions.purpose = simulation_purpose;
    return {};
  }
  const std::string_view plain = text::trim(content.substr(1));
  const std::size_t colon = plain.find(':');
  if (colon == std::string_view::npos) return {};
  const Field* field = find_field(text::trim(plain.substr(0, colon)));
  if (field == nullptr) return {};
  return placed(set_line_value(metadata, *field, text::trim(plain.substr(colon + 1))), {line, 1});
}

}  // namespace

Result<TrackingLengths> read_tracking_lengths(std::string_view bytes, const TrackingPlan& plan) {
  AXIOMETRY_TRY(const DecodedText decoded, decoded_text(bytes));
  TrackingLengths lengths;
  lengths.remarks = encoding_remarks(decoded);
  std::optional<Reader> reader;
  AXIOMETRY_TRY_VOID(for_table_lines(decoded.text, [&](const TableLine& line) -> Result<void> {
    if (line.content.starts_with('#')) return take_comment(line.content, line.number, lengths);
    if (reader) return reader->row(line, lengths);
    AXIOMETRY_TRY(LengthsColumns columns, lengths_columns_of(line.text, line.number));
    lengths.in_program_order = !columns.labelled();
    if (!columns.passed_over.empty()) lengths.remarks.push_back({false, passed_over(columns.passed_over)});
    reader.emplace(plan, std::move(columns));
    return {};
  }));
  if (!reader)
    return fail(
        fmt::format("found no header, expected one with {}", fmt::join(names_of<5>(tracking_lengths_head), ", ")),
        {1, 1});
  if (lengths.rows.empty()) return fail("found no lengths below the header, expected one on each line");
  return lengths;
}

std::string write_tracking_lengths(std::span<const LengthReading> readings, std::span<const double> times_s) {
  const bool segments = std::ranges::any_of(readings, [](const LengthReading& r) { return r.segment != 0; });
  const bool timed = !times_s.empty();
  std::string text = fmt::format("{}{}{}\n", tracking_lengths_head, segments ? ",segment" : "", timed ? ",time_s" : "");
  for (std::size_t k = 0; k < readings.size(); ++k) {
    const LengthReading& r = readings[k];
    text += fmt::format("{},{},{},{},{}", text::csv_cell(r.line), r.approach.target + 1,
                        r.approach.direction == Direction::up ? "up" : "down", r.approach.run + 1,
                        format_exact(r.length_difference_mm));
    if (segments) text += fmt::format(",{}", r.segment);
    if (timed) text += fmt::format(",{:.3f}", times_s[k]);
    text += '\n';
  }
  return text;
}

}  // namespace axiometry::formats
