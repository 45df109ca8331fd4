// SPDX-License-Identifier: Apache-2.0
#include "axiometry/formats/tracking/ranges_csv.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>

#include "axiometry/base/text/number_text.h"
#include "axiometry/base/text/text.h"
#include "axiometry/formats/text/decoded_text.h"
#include "axiometry/formats/text/named_rows.h"
#include "axiometry/formats/text/simulated_note.h"
#include "axiometry/formats/text/table_heads.h"

namespace axiometry::formats {
namespace {

enum Role : std::size_t { role_point, role_station, role_segment, role_length, role_x, role_y, role_z, role_count };
constexpr std::array<std::string_view, role_count> canonical = {"point", "station", "segment", "length_mm",
                                                                "x_mm",  "y_mm",    "z_mm"};
constexpr ColumnWord words[] = {{"point", role_point},
                                {"p", role_point},
                                {"point id", role_point},
                                {"station", role_station},
                                {"s", role_station},
                                {"station id", role_station},
                                {"tracker", role_station},
                                {"segment", role_segment},
                                {"beam", role_segment},
                                {"length", role_length},
                                {"range", role_length},
                                {"distance", role_length},
                                {"l", role_length},
                                {"x", role_x},
                                {"y", role_y},
                                {"z", role_z}};
constexpr TableWords table = {canonical, words, role_length};

Result<void> check_coordinates(const NamedColumns& columns) {
  const std::size_t coordinates = columns.has(role_x) + columns.has(role_y) + columns.has(role_z);
  if (coordinates == 0 || coordinates == 3) return {};
  return fail(fmt::format("found {} of the columns x_mm, y_mm, z_mm, expected all of them or none", coordinates),
              {columns.line, 1});
}

std::string place_text(Vector3 p) {
  return fmt::format("({}, {}, {})", format_exact(p.x), format_exact(p.y), format_exact(p.z));
}

/// Reads rows into a RangesFile.
class RangesReader {
 public:
  Result<RangesFile> read(std::string_view text) {
    constexpr std::size_t needed[] = {role_point, role_station, role_length};
    AXIOMETRY_TRY_VOID(
        for_named_rows(text, columns_, table, needed, ranges_head, [&](const NamedRow& row) -> Result<void> {
          if (file_.readings.empty()) AXIOMETRY_TRY_VOID(check_coordinates(columns_));
          return add(row);
        }));
    AXIOMETRY_TRY_VOID(check_coordinates(columns_));
    if (file_.readings.empty()) return fail("found a header and no lengths below it, expected one in each row");
    file_.points = points_.take();
    file_.stations = stations_.take();
    for (NameNumbers& names : segments_) file_.segments.push_back(names.take());
    if (columns_.simulated) file_.remarks.emplace_back(simulated_lengths);
    if (!columns_.passed_over.empty()) file_.remarks.push_back(passed_over(columns_.passed_over));
    if (missing_ > 0)
      file_.remarks.push_back(fmt::format("passed over {} row{} without a length", missing_, missing_ == 1 ? "" : "s"));
    return std::move(file_);
  }

 private:
  Result<void> add(const NamedRow& row) {
    AXIOMETRY_TRY(const std::string_view point, cells_.name(row, role_point));
    AXIOMETRY_TRY(const std::string_view station, cells_.name(row, role_station));
    if (is_missing(row.cell(role_length))) {
      ++missing_;
      return {};
    }
    RangeReading reading;
    AXIOMETRY_TRY(reading.length_mm, cells_.length(row, role_length));
    const std::size_t points_before = points_.size();
    reading.point = points_.number(point);
    reading.station = stations_.number(station);
    if (reading.station == segments_.size()) segments_.emplace_back();
    reading.segment =
        segments_[reading.station].number(columns_.has(role_segment) ? row.cell(role_segment) : std::string_view());
    const bool is_new = points_.size() > points_before;
    if (is_new) file_.lines.push_back(row.number());
    if (columns_.has(role_x)) AXIOMETRY_TRY_VOID(add_place(row, reading.point, is_new));
    file_.readings.push_back(reading);
    file_.reading_lines.push_back(row.number());
    return {};
  }

  Result<void> add_place(const NamedRow& row, std::size_t point, bool is_new) {
    AXIOMETRY_TRY(const Vector3 at, cells_.place(row, role_x));
    if (is_new) {
      file_.nominal_mm.push_back(at);
      return {};
    }
    if (file_.nominal_mm[point] == at) return {};
    return fail(fmt::format("found point {} at {}, expected {} as on line {}: nominal places do not change",
                            points_[point], place_text(at), place_text(file_.nominal_mm[point]), file_.lines[point]),
                row.at(role_x));
  }

  NamedColumns columns_;
  NamedCells cells_{columns_, table};
  NameNumbers points_, stations_;
  std::vector<NameNumbers> segments_;
  std::size_t missing_ = 0;
  RangesFile file_;
};

}  // namespace

Result<RangesFile> read_ranges(std::string_view bytes) {
  AXIOMETRY_TRY(const DecodedText decoded, decoded_text(bytes));
  AXIOMETRY_TRY(RangesFile file, RangesReader().read(decoded.text));
  for (const SourceRemark& remark : encoding_remarks(decoded)) file.remarks.push_back(remark.message);
  return file;
}

Result<NamedPoints> read_named_points(std::string_view bytes) {
  AXIOMETRY_TRY(const DecodedText decoded, decoded_text(bytes));
  constexpr std::size_t needed[] = {role_point, role_x, role_y, role_z};
  NamedColumns columns;
  NamedCells cells(columns, table);
  NameNumbers names;
  NamedPoints points;
  std::vector<std::size_t> lines;
  AXIOMETRY_TRY_VOID(
      for_named_rows(decoded.text, columns, table, needed, ranges_head, [&](const NamedRow& row) -> Result<void> {
        AXIOMETRY_TRY(const std::string_view name, cells.name(row, role_point));
        const std::size_t k = names.number(name);
        if (k < lines.size())
          return fail(fmt::format("found point {} a second time, expected it once as on line {}", name, lines[k]),
                      row.at(role_point));
        lines.push_back(row.number());
        AXIOMETRY_TRY(points.at_mm.emplace_back(), cells.place(row, role_x));
        return {};
      }));
  if (points.at_mm.empty()) return fail("found a header and no points below it, expected one in each row");
  points.names = names.take();
  if (!columns.passed_over.empty()) points.remarks.push_back(passed_over(columns.passed_over));
  for (const SourceRemark& remark : encoding_remarks(decoded)) points.remarks.push_back(remark.message);
  return points;
}

}  // namespace axiometry::formats
