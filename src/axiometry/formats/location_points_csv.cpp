// SPDX-License-Identifier: Apache-2.0
#include "axiometry/formats/location_points_csv.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <utility>

#include "axiometry/base/text.h"
#include "axiometry/formats/csv_cells.h"
#include "axiometry/formats/decoded_text.h"
#include "axiometry/formats/text_lines.h"
#include "axiometry/formats/units.h"

namespace axiometry::formats {
namespace {

constexpr double limit_mm = 1e9;  // the Plan's own limit of coordinates

enum Role : std::size_t { role_x, role_y, role_z, role_length, role_count };
constexpr std::array<std::string_view, role_count> canonical = {"x_mm", "y_mm", "z_mm", "length_difference_mm"};
constexpr std::string_view length_words[] = {
    "length difference", "length change", "delta length", "delta l", "deltal", "dl", "d l",
    "\u0394l",           "\u0394L",       "\u2206l",      "\u2206L"};

struct NamedUnit {
  std::string name;  ///< lower case, parts parted by one blank
  std::string unit;  ///< as it stands there, or empty
};

/// "x_mm", "X [mm]", "length difference (µm)".
NamedUnit parted(std::string_view head) {
  head = text::trim(head);
  const std::size_t open = head.find_first_of("[(");
  if (open != std::string_view::npos && (head.ends_with(']') || head.ends_with(')')))
    return {plain_name(text::trim(head.substr(0, open))),
            std::string(text::trim(head.substr(open + 1, head.size() - open - 2)))};
  const std::size_t mark = head.find_last_of("_ ");
  if (mark != std::string_view::npos && find_unit(head.substr(mark + 1)) != nullptr)
    return {plain_name(head.substr(0, mark)), std::string(head.substr(mark + 1))};
  return {plain_name(head), ""};
}

std::optional<Role> role_of(std::string_view name) {
  if (name == "x") return role_x;
  if (name == "y") return role_y;
  if (name == "z") return role_z;
  if (std::ranges::find(length_words, name) != std::end(length_words)) return role_length;
  return std::nullopt;
}

struct Columns {
  std::array<std::optional<std::size_t>, role_count> at;
  std::array<const Unit*, role_count> unit{};
  std::size_t count = 0;
  std::size_t needed = 0;  ///< up to the last one that is read
  std::size_t line = 0;
  bool has_axes = false;
  char delimiter = ',';
  std::vector<std::string> passed_over;
};

Result<const Unit*> length_unit(const CsvCell& head, const NamedUnit& named, Role role, std::size_t line) {
  if (named.unit.empty())
    return fail(fmt::format("found the column {} without a unit, expected one as in {}", text::quoted(head.text),
                            canonical[role]),
                {line, head.column});
  const Unit* unit = find_unit(named.unit);
  if (unit == nullptr || unit->kind != AxisKind::linear)
    return fail(fmt::format("found the unit {} of the column {}, expected a unit of length: um, mm, nm, m or in",
                            text::quoted(named.unit), text::quoted(head.text)),
                {line, head.column});
  return unit;
}

Result<Columns> columns_of(std::string_view text, std::size_t line) {
  Columns columns;
  columns.line = line;
  columns.delimiter = delimiter_of(text);
  AXIOMETRY_TRY(const std::vector<CsvCell> heads, split_row(text, columns.delimiter, line));
  columns.count = heads.size();
  for (std::size_t k = 0; k < heads.size(); ++k) {
    const NamedUnit named = parted(heads[k].text);
    const auto role = role_of(named.name);
    if (!role) {
      const bool is_axis = named.name == "axes x" || named.name == "axes y" || named.name == "axes z";
      columns.has_axes = columns.has_axes || is_axis;
      if (!heads[k].text.empty() && !is_axis && named.name != "point") columns.passed_over.push_back(heads[k].text);
      continue;
    }
    if (columns.at[*role])
      return fail(fmt::format("found {} a second time, expected one column of it", text::quoted(heads[k].text)),
                  {line, heads[k].column});
    columns.at[*role] = k;
    columns.needed = k + 1;
    AXIOMETRY_TRY(columns.unit[*role], length_unit(heads[k], named, *role, line));
  }
  for (std::size_t role = 0; role < role_count; ++role)
    if (!columns.at[role])
      return fail(
          fmt::format("found no column {}, expected a header with {}", canonical[role], fmt::join(canonical, ", ")),
          {line, 1});
  return columns;
}

Result<LocationPoint> point_of(const std::vector<CsvCell>& cells, const Columns& columns, NumberReader& numbers,
                               std::size_t line) {
  std::array<double, role_count> value{};
  for (std::size_t role = 0; role < role_count; ++role) {
    const CsvCell& cell = cells[*columns.at[role]];
    const TextPosition at{line, cell.column};
    AXIOMETRY_TRY(const double number, numbers.read(cell.text, at));
    value[role] = position_in(*columns.unit[role], number).in_native();
    if (!(std::abs(value[role]) <= limit_mm))
      return fail(fmt::format("found {}, expected a length up to 1e9 mm", text::quoted(cell.text)), at);
  }
  return LocationPoint{{value[role_x], value[role_y], value[role_z]}, value[role_length]};
}

/// Blanks at the ends stay, since a tab there parts cells.
struct Line {
  std::string_view text;
  std::size_t number = 0;
  bool has_break = true;
};

std::vector<Line> lines_of(std::string_view text) {
  std::vector<Line> lines;
  for (std::size_t begin = 0; begin < text.size();) {
    const std::size_t line_break = text.find('\n', begin);
    const std::size_t end = std::min(line_break, text.size());
    std::string_view line = text.substr(begin, end - begin);
    if (line.ends_with('\r')) line.remove_suffix(1);
    lines.push_back({line, lines.size() + 1, line_break != std::string_view::npos});
    begin = end + 1;
  }
  return lines;
}

std::string passed_over_remark(const std::vector<std::string>& names) {
  std::string list;
  for (const std::string& name : names) list += fmt::format("{}{}", list.empty() ? "" : ", ", text::quoted(name));
  return fmt::format("passed over the column{} {}", names.size() == 1 ? "" : "s", list);
}

}  // namespace

Result<LocationPointsFile> read_location_points(std::string_view bytes) {
  AXIOMETRY_TRY(const DecodedText decoded, decoded_text(bytes));
  LocationPointsFile file;
  for (const SourceRemark& remark : encoding_remarks(decoded)) file.remarks.push_back(remark.message);
  std::optional<Columns> columns;
  std::optional<NumberReader> numbers;
  for (const Line& line : lines_of(decoded.text)) {
    const std::string_view content = text::trim(line.text);
    if (content.empty() || content.starts_with('#')) continue;
    if (!columns) {
      if (text::to_lower(content.substr(0, 4)) == "sep=") continue;  // a spreadsheet's
      AXIOMETRY_TRY(columns, columns_of(line.text, line.number));
      numbers.emplace(columns->delimiter);
      file.has_axes = columns->has_axes;
      if (!columns->passed_over.empty()) file.remarks.push_back(passed_over_remark(columns->passed_over));
      continue;
    }
    AXIOMETRY_TRY(const std::vector<CsvCell> cells, split_row(line.text, columns->delimiter, line.number));
    AXIOMETRY_TRY_VOID(check_cell_count(cells, {.expected = columns->count,
                                                .needed = columns->needed,
                                                .header_line = columns->line,
                                                .line = line.number,
                                                .delimiter = columns->delimiter,
                                                .cut_off = !line.has_break}));
    AXIOMETRY_TRY(file.points.emplace_back(), point_of(cells, *columns, *numbers, line.number));
  }
  if (!columns) return fail(fmt::format("found no header, expected one with {}", fmt::join(canonical, ", ")), {1, 1});
  return file;
}

}  // namespace axiometry::formats
