// SPDX-License-Identifier: Apache-2.0
#include "axiometry/formats/tracking/location_points_csv.h"

#include <fmt/format.h>

#include <array>
#include <optional>
#include <utility>

#include "axiometry/base/read_budget.h"
#include "axiometry/base/text/text.h"
#include "axiometry/formats/text/csv_cells.h"
#include "axiometry/formats/text/decoded_text.h"
#include "axiometry/formats/text/table_heads.h"

namespace axiometry::formats {
namespace {

enum PointRole : std::size_t { point_role_x, point_role_y, point_role_z, point_role_length, point_role_count };
constexpr auto point_heads = names_of<point_role_count>(location_points_head);
std::optional<PointRole> point_role_of(std::string_view name) {
  if (name == "x") return point_role_x;
  if (name == "y") return point_role_y;
  if (name == "z") return point_role_z;
  if (is_length_difference(name)) return point_role_length;
  return std::nullopt;
}

struct PointColumns {
  std::array<std::optional<std::size_t>, point_role_count> at;
  std::array<const Unit*, point_role_count> unit{};
  std::size_t count = 0;
  std::size_t needed = 0;  ///< up to the last one that is read
  std::size_t line = 0;
  bool has_axes = false;
  char delimiter = ',';
  std::vector<std::string> passed_over;
};

Result<PointColumns> point_columns_of(std::string_view text, std::size_t line) {
  PointColumns columns;
  columns.line = line;
  columns.delimiter = delimiter_of(text);
  AXIOMETRY_TRY(const std::vector<CsvCell> heads, split_row(text, columns.delimiter, line));
  columns.count = heads.size();
  for (std::size_t k = 0; k < heads.size(); ++k) {
    const TableHead named = table_head(heads[k].text);
    const auto role = point_role_of(named.name);
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
    AXIOMETRY_TRY(columns.unit[*role], length_unit(heads[k], named, point_heads[*role], line));
  }
  for (std::size_t role = 0; role < point_role_count; ++role)
    if (!columns.at[role])
      return fail(
          fmt::format("found no column {}, expected a header with {}", point_heads[role], fmt::join(point_heads, ", ")),
          {line, 1});
  return columns;
}

Result<LocationPoint> point_of(const std::vector<CsvCell>& cells, const PointColumns& columns, NumberReader& numbers,
                               std::size_t line) {
  std::array<double, point_role_count> value{};
  for (std::size_t role = 0; role < point_role_count; ++role) {
    const CsvCell& cell = cells[*columns.at[role]];
    const TextPosition at{line, cell.column};
    AXIOMETRY_TRY(const double number, numbers.read(cell.text, at));
    AXIOMETRY_TRY(value[role], length_in_mm(*columns.unit[role], number, cell.text, at));
  }
  return LocationPoint{{value[point_role_x], value[point_role_y], value[point_role_z]}, value[point_role_length]};
}

}  // namespace

Result<LocationPointsFile> read_location_points(std::string_view bytes) {
  AXIOMETRY_TRY(const DecodedText decoded, decoded_text(bytes));
  LocationPointsFile file;
  for (const SourceRemark& remark : encoding_remarks(decoded)) file.remarks.push_back(remark.message);
  std::optional<PointColumns> columns;
  std::optional<NumberReader> numbers;
  AXIOMETRY_TRY_VOID(for_table_lines(decoded.text, [&](const TableLine& line) -> Result<void> {
    if (line.content.starts_with('#')) return {};
    if (!columns) {
      AXIOMETRY_TRY(columns, point_columns_of(line.text, line.number));
      numbers.emplace(columns->delimiter);
      file.has_axes = columns->has_axes;
      if (!columns->passed_over.empty()) file.remarks.push_back(passed_over(columns->passed_over));
      return {};
    }
    AXIOMETRY_TRY(const std::vector<CsvCell> cells, split_row(line.text, columns->delimiter, line.number));
    AXIOMETRY_TRY_VOID(check_cell_count(cells, {.expected = columns->count,
                                                .needed = columns->needed,
                                                .header_line = columns->line,
                                                .line = line.number,
                                                .delimiter = columns->delimiter,
                                                .cut_off = !line.has_break}));
    if (file.points.size() == read_budget::location_points)
      return fail(
          fmt::format("found more than {} points, expected fewer to locate a station by", read_budget::location_points),
          {line.number, 1});
    AXIOMETRY_TRY(file.points.emplace_back(), point_of(cells, *columns, *numbers, line.number));
    return {};
  }));
  if (!columns) return fail(fmt::format("found no header, expected one with {}", fmt::join(point_heads, ", ")), {1, 1});
  return file;
}

}  // namespace axiometry::formats
