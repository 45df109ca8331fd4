// SPDX-License-Identifier: Apache-2.0
#include "axiometry/formats/motions/motion_csv.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <map>
#include <set>
#include <string>
#include <utility>

#include "axiometry/base/counted.h"
#include "axiometry/base/read_budget.h"
#include "axiometry/base/text/text.h"
#include "axiometry/formats/csv/csv_values.h"
#include "axiometry/formats/motions/motion_rows.h"
#include "axiometry/formats/motions/motion_units.h"
#include "axiometry/formats/text/csv_cells.h"
#include "axiometry/formats/text/decoded_text.h"
#include "axiometry/formats/text/table_heads.h"
#include "axiometry/formats/text/text_lines.h"
#include "axiometry/formats/text/text_source.h"
#include "axiometry/formats/text/units.h"
#include "axiometry/model/fields.h"

namespace axiometry::formats {
namespace {

enum MotionRole : std::size_t { position_column, run_column, direction_column, value_column, motion_roles };

constexpr std::string_view columns_expected = "position_mm, run, direction and straightness_um or angle_urad";

struct MotionColumns {
  std::array<std::optional<std::size_t>, motion_roles> at;
  const Unit* position_unit = nullptr;
  const Unit* value_unit = nullptr;
  std::optional<MotionName> error;
  std::size_t count = 0;
  std::size_t needed = 0;
  std::size_t line = 0;
  char delimiter = ',';
  std::vector<std::string> passed_over;
  bool may_be_positions = false;
  std::string turn;  ///< as that of MotionFile
};

std::optional<MotionRole> motion_role(std::string_view name) {
  if (name == "position" || name == "target" || name == "target position") return position_column;
  if (name == "run") return run_column;
  if (name == "direction" || name == "dir" || name == "approach") return direction_column;
  for (const std::string_view value : {"straightness", "horizontal straightness", "vertical straightness", "angle",
                                       "roll", "pitch", "yaw", "deviation", "reading"})
    if (name == value) return value_column;
  if (motion_name(name)) return value_column;
  return std::nullopt;
}

/// What a capture says of a reading beside it, and no figure is made of.
bool is_beside_reading(std::string_view name) {
  return name == "time" || name == "scatter" || name == "drift" || name == "samples";
}

bool is_turn(std::string_view name) { return name == "roll" || name == "pitch" || name == "yaw"; }

/// As table_head(), and with inclinations: "pitch_um/m".
TableHead motion_head(std::string_view text) {
  TableHead head = table_head(text);
  const std::string_view trimmed = text::trim(text);
  const std::size_t mark = trimmed.find_last_of("_ ");
  if (!head.unit.empty() || mark == trimmed.npos || find_motion_unit(trimmed.substr(mark + 1)) == nullptr) return head;
  return {plain_name(trimmed.substr(0, mark)), std::string(trimmed.substr(mark + 1))};
}

/// The unit of the readings: of the kind that their name asks for.
Result<const Unit*> value_unit(const CsvCell& head, const TableHead& named, std::size_t line) {
  const TextPosition at{line, head.column};
  const auto error = motion_name(named.name);
  const bool length = named.name.ends_with("straightness") || (error && !error->rotation());
  const bool angle = named.name == "angle" || is_turn(named.name) || (error && error->rotation());
  const std::string_view wanted = length  ? "of length: um, mm, nm, m or in"
                                  : angle ? "of angle: urad, mrad, um/m, mm/m, arcsec or deg"
                                          : "such as um, urad or arcsec";
  if (named.unit.empty())
    return fail(fmt::format("found the column {} without a unit, expected one {}", text::quoted(head.text), wanted),
                at);
  const Unit* unit = find_motion_unit(named.unit);
  if (unit == nullptr || (length && unit->kind != AxisKind::linear) || (angle && unit->kind != AxisKind::rotary))
    return fail(fmt::format("found the unit {} of the column {}, expected one {}", text::quoted(named.unit),
                            text::quoted(head.text), wanted),
                at);
  return unit;
}

Result<MotionColumns> motion_columns(std::string_view header, std::size_t line, bool planned = false) {
  MotionColumns columns;
  columns.line = line;
  columns.delimiter = delimiter_of(header);
  AXIOMETRY_TRY(const std::vector<CsvCell> heads, split_row(header, columns.delimiter, line));
  columns.count = heads.size();
  for (std::size_t k = 0; k < heads.size(); ++k) {
    const TableHead named = motion_head(heads[k].text);
    const auto role = motion_role(named.name);
    if (!role) {
      if (!heads[k].text.empty() && !is_beside_reading(named.name)) columns.passed_over.push_back(heads[k].text);
      continue;
    }
    if (columns.at[*role])
      return fail(fmt::format("found {} beside {}, expected one column of them", text::quoted(heads[k].text),
                              text::quoted(heads[*columns.at[*role]].text)),
                  {line, heads[k].column});
    columns.at[*role] = k;
    columns.needed = k + 1;
    if (*role == position_column) {
      AXIOMETRY_TRY(columns.position_unit, length_unit(heads[k], named, "position_mm", line));
    } else if (*role == value_column) {
      AXIOMETRY_TRY(columns.value_unit, value_unit(heads[k], named, line));
      if (const auto error = motion_name(named.name)) columns.error = *error;
      if (is_turn(named.name)) columns.turn = named.name;
      columns.may_be_positions = named.name == "deviation" && columns.value_unit->kind == AxisKind::linear;
    }
  }
  const auto missing = [&](std::string_view name) {
    return fail(fmt::format("found no column {}, expected {}", name, columns_expected), {line, 1});
  };
  for (const MotionRole role : {position_column, run_column, direction_column})
    if (planned && columns.at[role])
      return fail(fmt::format("found the column {} beside a plan, expected readings alone in the order of the plan",
                              text::quoted(heads[*columns.at[role]].text)),
                  {line, heads[*columns.at[role]].column});
  if (!columns.at[position_column] && !planned) return missing("position_mm");
  if (!columns.at[value_column]) return missing("straightness_um");
  return columns;
}

class MotionRows {
 public:
  MotionRows(MotionColumns columns, const Plan* plan)
      : columns_(std::move(columns)), numbers_(columns_.delimiter), plan_(plan) {
    if (plan != nullptr) order_ = approaches(*plan);
  }

  Result<void> row(const TableLine& line, MotionFile& file) {
    AXIOMETRY_TRY(const std::vector<CsvCell> cells, split_row(line.text, columns_.delimiter, line.number));
    AXIOMETRY_TRY_VOID(check_cell_count(cells, {.expected = columns_.count,
                                                .needed = columns_.needed,
                                                .header_line = columns_.line,
                                                .line = line.number,
                                                .delimiter = columns_.delimiter,
                                                .cut_off = !line.has_break}));
    AXIOMETRY_TRY(MotionReading r, plan_ != nullptr ? planned(line.number) : stated(cells, line.number));
    const CsvCell& reading = cells[*columns_.at[value_column]];
    r.at = {line.number, reading.column};
    if (plan_ == nullptr) order_of_rows_.take({r.run, r.direction}, r.position_mm);
    if (is_missing(reading.text)) {
      empty_mm_.insert(r.position_mm + 0.0);  // −0 is 0
      empty_runs_.insert({r.run, r.direction});
      return {};
    }
    AXIOMETRY_TRY(const double value, numbers_.read(reading.text, r.at));
    r.value = motion_value(*columns_.value_unit, value);
    file.readings.push_back(r);
    return {};
  }

  /// Whether every approach of the plan has its row.
  Result<void> check_complete() const {
    if (plan_ == nullptr || next_ == order_.size()) return {};
    return fail(
        fmt::format("found {}, expected {} as the plan has approaches", counted(next_, "reading"), order_.size()));
  }

  /// What is to be told of the rows as a whole.
  Result<void> remark(MotionFile& file) const {
    if (plan_ == nullptr)
      AXIOMETRY_TRY_VOID(order_of_rows_.put_remark(columns_.at[direction_column].has_value(), file.remarks));
    if (const auto left = positions_without_reading(empty_mm_, file.readings); !left.empty())
      file.remarks.push_back(left_out_positions(left));
    if (const auto left = runs_without_reading(empty_runs_, file.readings); !left.empty())
      file.remarks.push_back(left_out_runs(left));
    return {};
  }

  const MotionColumns& columns() const { return columns_; }

 private:
  Result<MotionReading> planned(std::size_t line) {
    if (next_ == order_.size())
      return fail(fmt::format("found more than {} readings, expected as many as the plan has approaches", next_),
                  {line, 1});
    const Approach& approach = order_[next_++];
    return MotionReading{.position_mm = plan_->targets[approach.target].in_native(),
                         .direction = approach.direction,
                         .run = approach.run + 1};
  }

  /// Position, direction and run of a row.
  Result<MotionReading> stated(const std::vector<CsvCell>& cells, std::size_t line_number) {
    const auto cell = [&](MotionRole role) -> const CsvCell& { return cells[*columns_.at[role]]; };
    MotionReading r;
    const TextPosition position_at{line_number, cell(position_column).column};
    AXIOMETRY_TRY(const double position, numbers_.read(cell(position_column).text, position_at));
    AXIOMETRY_TRY(r.position_mm,
                  length_in_mm(*columns_.position_unit, position, cell(position_column).text, position_at));
    if (columns_.at[direction_column]) {
      const auto direction = direction_from(cell(direction_column).text);
      if (!direction)
        return fail(fmt::format("found the direction {}, expected {}", text::quoted(cell(direction_column).text),
                                direction_words),
                    {line_number, cell(direction_column).column});
      r.direction = *direction;
    }
    AXIOMETRY_TRY(r.run, run_of(cells, r, line_number));
    return r;
  }

  /// As it stands there, or the how manieth approach this is.
  Result<std::size_t> run_of(const std::vector<CsvCell>& cells, const MotionReading& r, std::size_t line) {
    if (columns_.at[run_column]) {
      const CsvCell& cell = cells[*columns_.at[run_column]];
      return run_number(cell.text, {line, cell.column});
    }
    const std::size_t run = ++approaches_[{r.position_mm, r.direction}];
    if (run > 1 && !columns_.at[direction_column])
      return fail("found a position a second time and neither run nor direction, expected a column of them",
                  {line, cells[*columns_.at[position_column]].column});
    if (run > read_budget::runs)
      return fail(fmt::format("found more than {} approaches to one position", read_budget::runs), {line, 1});
    return run;
  }

  MotionColumns columns_;
  NumberReader numbers_;
  const Plan* plan_;
  std::vector<Approach> order_;  ///< approaches of the plan in their order
  std::size_t next_ = 0;
  std::map<std::pair<double, Direction>, std::size_t> approaches_;
  MotionRowOrder order_of_rows_;
  std::set<double> empty_mm_;       ///< positions of cells without a reading
  std::set<MotionRun> empty_runs_;  ///< runs of such cells
};

Result<void> put_error(MotionFile& file, const MotionName& error, std::size_t line) {
  if (file.error && *file.error != error)
    return fail(fmt::format("found the error {} after {}, expected one in a file", error.text(), file.error->text()),
                {line, 1});
  file.error = error;
  return {};
}

Result<void> put_sense(MotionFile& file, const ReadingSense& sense, std::size_t line) {
  if (file.sense && *file.sense != sense)
    return fail(fmt::format("found readings positive towards {} after {}, expected one way in a file", sense.text(),
                            file.sense->text()),
                {line, 1});
  file.sense = sense;
  return {};
}

Result<void> take_motion_comment(std::string_view content, std::size_t line, MotionFile& file) {
  const std::string_view plain = text::trim(content.substr(1));
  const std::size_t colon = plain.find(':');
  if (colon == std::string_view::npos) return {};
  const std::string_view key = text::trim(plain.substr(0, colon)), value = text::trim(plain.substr(colon + 1));
  if (text::equal_ignoring_case(key, "error")) {
    AXIOMETRY_TRY(const MotionName error, placed(motion_name(value), {line, 1}));
    return put_error(file, error, line);
  }
  if (text::equal_ignoring_case(key, "positive")) {
    AXIOMETRY_TRY(const ReadingSense sense, placed(reading_sense(value), {line, 1}));
    return put_sense(file, sense, line);
  }
  const Field* field = find_field(key);
  if (field == nullptr) return placed(check_unknown_motion_key(key, value), {line, 1});
  return placed(set_line_value(file.metadata, *field, value), {line, 1});
}

/// The unit must be one of the error's kind, however it was named.
Result<void> check_kind(const MotionFile& file, std::size_t line) {
  if (!file.error || file.error->rotation() == is_angle(file.unit)) return {};
  return fail(fmt::format("found {} in {}, expected {}", file.error->text(), motion_unit_symbol(file.unit),
                          file.error->rotation() ? "readings of an angle" : "readings of a length"),
              {line, 1});
}

/// Whether a name is one that no deviation of positions has.
bool names_other_error(std::string_view name) {
  if (const auto error = motion_name(name)) return error->rotation() || error->straightness();
  return name.ends_with("straightness") || is_turn(name);
}

/// "EYX", "straightness", or nothing; of the comments above a table and its header.
std::string other_error_in(std::string_view text) {
  std::string found;
  const auto stop = fail("seen enough");
  const auto looked = for_table_lines(text, [&](const TableLine& line) -> Result<void> {
    if (line.content.starts_with('#')) {
      const std::string_view plain = text::trim(line.content.substr(1));
      const std::size_t colon = std::min(plain.find(':'), plain.size());
      const std::string_view value = text::trim(plain.substr(std::min(colon + 1, plain.size())));
      if (!text::equal_ignoring_case(text::trim(plain.substr(0, colon)), "error") || !names_other_error(value))
        return {};
      const auto error = motion_name(value);
      found = error ? error->text() : std::string(value);
      return stop;
    }
    const auto columns = motion_columns(line.text, line.number);
    if (!columns) return stop;
    const auto heads = split_row(line.text, columns->delimiter, line.number);
    const std::string name = motion_head((*heads)[*columns->at[value_column]].text).name;
    if (names_other_error(name)) found = columns->error ? columns->error->text() : name;
    return stop;
  });
  return found;
}

}  // namespace

Result<void> check_no_other_error(std::string_view head) {
  const auto readable = readable_text(head);
  const auto decoded = readable ? Result<DecodedText>(fail("it is readable"))
                                : decoded_text(head.substr(0, head.size() / 2 * 2));  // UTF-16 cut between two bytes
  if (!readable && !decoded) return {};
  const std::string error = other_error_in(readable ? *readable : std::string_view(decoded->text));
  if (error.empty()) return {};
  const auto name = motion_name(error);
  const bool angle = name ? name->rotation() : !error.ends_with("straightness");
  return fail(fmt::format("found readings of the error {}, expected deviations of positions; axiometry {} evaluates "
                          "these",
                          error, angle ? "angles" : "straightness"),
              {1, 1});
}

namespace {

Result<void> check_plan_of_motion(const Plan& plan) {
  if (plan.axis.kind != AxisKind::linear || !plan.axis.line_direction.empty())
    return fail("found a plan of a rotary axis or of a line in space, expected one of a linear axis");
  if (!plan.further.empty()) return fail("found a plan with further plans, expected one alone");
  return {};
}

Result<MotionFile> read_motion_table(std::string_view bytes, const Plan* plan) {
  AXIOMETRY_TRY(const DecodedText decoded, decoded_text(bytes));
  MotionFile file;
  file.remarks = encoding_remarks(decoded);
  std::optional<MotionRows> rows;
  AXIOMETRY_TRY_VOID(for_table_lines(decoded.text, [&](const TableLine& line) -> Result<void> {
    if (line.content.starts_with('#')) return take_motion_comment(line.content, line.number, file);
    if (rows) return rows->row(line, file);
    AXIOMETRY_TRY(MotionColumns columns, motion_columns(line.text, line.number, plan != nullptr));
    file.unit = motion_unit_of(*columns.value_unit);
    if (motion_value(*columns.value_unit, 1.0) != 1.0) file.unit_in_file = columns.value_unit->symbol;
    file.may_be_positions = columns.may_be_positions;
    file.turn = columns.turn;
    if (columns.error) AXIOMETRY_TRY_VOID(put_error(file, *columns.error, line.number));
    if (!columns.passed_over.empty()) file.remarks.push_back({false, passed_over(columns.passed_over)});
    rows.emplace(std::move(columns), plan);
    return {};
  }));
  if (!rows) return fail(fmt::format("found no header, expected one with {}", columns_expected), {1, 1});
  if (file.readings.empty()) return fail("found no readings below the header, expected one on each line");
  AXIOMETRY_TRY_VOID(check_kind(file, rows->columns().line));
  AXIOMETRY_TRY_VOID(rows->check_complete());
  AXIOMETRY_TRY_VOID(rows->remark(file));
  return file;
}

}  // namespace

Result<MotionFile> read_motion_csv(std::string_view bytes) { return read_motion_table(bytes, nullptr); }

Result<MotionFile> read_planned_motion(std::string_view bytes, const Plan& plan) {
  AXIOMETRY_TRY_VOID(check_plan_of_motion(plan));
  AXIOMETRY_TRY(MotionFile file, read_motion_table(bytes, &plan));
  AXIOMETRY_TRY_VOID(check_error_of_plan(file.error, file.unit, plan));
  if (file.metadata.machine.name.empty()) file.metadata.machine.name = plan.machine;
  return file;
}

}  // namespace axiometry::formats
