// SPDX-License-Identifier: Apache-2.0
#include "axiometry/formats/volumetric/volumetric_lengths_csv.h"

#include <fmt/format.h>

#include <array>
#include <iterator>

#include "axiometry/base/text/number_text.h"
#include "axiometry/base/text/text.h"
#include "axiometry/formats/text/decoded_text.h"
#include "axiometry/formats/text/named_rows.h"
#include "axiometry/formats/text/simulated_note.h"
#include "axiometry/formats/text/table_heads.h"

namespace axiometry::formats {
namespace {

using volumetric::VolumetricLengths;
using volumetric::VolumetricReading;

enum Role : std::size_t { role_station, role_tool, role_segment, role_x, role_y, role_z, role_length, role_count };
constexpr auto canonical = names_of<role_count>(volumetric_lengths_head);
constexpr ColumnWord words[] = {{"station", role_station},
                                {"station id", role_station},
                                {"tracker", role_station},
                                {"tool", role_tool},
                                {"tool id", role_tool},
                                {"reflector", role_tool},
                                {"segment", role_segment},
                                {"beam", role_segment},
                                {"x", role_x},
                                {"y", role_y},
                                {"z", role_z},
                                {"length", role_length},
                                {"range", role_length},
                                {"distance", role_length}};
constexpr TableWords table = {canonical, words, role_x};

void add_remarks(const NamedColumns& columns, const DecodedText& decoded, std::vector<std::string>& remarks) {
  if (columns.simulated) remarks.emplace_back(simulated_lengths);
  if (!columns.passed_over.empty()) remarks.push_back(passed_over(columns.passed_over));
  for (const SourceRemark& remark : encoding_remarks(decoded)) remarks.push_back(remark.message);
}

}  // namespace

/// A row that begins with # would be a comment.
std::string name_cell(const std::string& name) {
  return name.starts_with('#') && !name.contains('"') ? '"' + name + '"' : text::csv_cell(name);
}

Result<VolumetricLengths> read_volumetric_lengths(std::string_view bytes) {
  AXIOMETRY_TRY(const DecodedText decoded, decoded_text(bytes));
  constexpr std::size_t required[] = {role_station, role_tool, role_x, role_y, role_z, role_length};
  NamedColumns columns;
  NamedCells cells(columns, table);
  NameNumbers stations, tools, segments;
  VolumetricLengths lengths;
  std::size_t missing = 0;
  const auto take = [&](const NamedRow& row) -> Result<void> {
    AXIOMETRY_TRY(const std::string_view station, cells.name(row, role_station));
    AXIOMETRY_TRY(const std::string_view tool, cells.name(row, role_tool));
    if (is_missing(row.cell(role_length))) {
      ++missing;
      return {};
    }
    VolumetricReading reading;
    reading.station = stations.number(station);
    reading.tool = tools.number(tool);
    reading.segment = segments.number(columns.has(role_segment) ? row.cell(role_segment) : std::string_view("1"));
    AXIOMETRY_TRY(reading.axes_mm, cells.place(row, role_x));
    AXIOMETRY_TRY(reading.length_mm, cells.length(row, role_length));
    reading.line = row.number();
    lengths.readings.push_back(reading);
    return {};
  };
  AXIOMETRY_TRY_VOID(for_named_rows(decoded.text, columns, table, required, volumetric_lengths_head, take));
  if (lengths.readings.empty()) return fail("found a header and no lengths below it, expected one in each row");
  lengths.stations = stations.take();
  lengths.tools = tools.take();
  lengths.segments = segments.take();
  add_remarks(columns, decoded, lengths.remarks);
  if (missing > 0)
    lengths.remarks.push_back(fmt::format("passed over {} row{} without a length", missing, missing == 1 ? "" : "s"));
  return lengths;
}

std::string write_volumetric_lengths(const VolumetricLengths& lengths) {
  std::string text = fmt::format("{}\n", volumetric_lengths_head);
  for (const VolumetricReading& r : lengths.readings)
    fmt::format_to(std::back_inserter(text), "{},{},{},{},{},{},{}\n", name_cell(lengths.stations[r.station]),
                   name_cell(lengths.tools[r.tool]), name_cell(lengths.segments[r.segment]), format_exact(r.axes_mm.x),
                   format_exact(r.axes_mm.y), format_exact(r.axes_mm.z), format_exact(r.length_mm));
  return text;
}

Result<VolumePoints> read_volume_points(std::string_view bytes) {
  AXIOMETRY_TRY(const DecodedText decoded, decoded_text(bytes));
  constexpr std::size_t required[] = {role_x, role_y, role_z};
  NamedColumns columns;
  NamedCells cells(columns, table);
  VolumePoints points;
  const auto take = [&](const NamedRow& row) -> Result<void> {
    VolumePoint point;
    if (columns.has(role_tool)) {
      AXIOMETRY_TRY(point.tool, cells.name(row, role_tool));
    }
    AXIOMETRY_TRY(point.axes_mm, cells.place(row, role_x));
    point.line = row.number();
    points.points.push_back(std::move(point));
    return {};
  };
  AXIOMETRY_TRY_VOID(for_named_rows(decoded.text, columns, table, required, volume_points_head, take));
  if (points.points.empty()) return fail("found a header and no points below it, expected one in each row");
  add_remarks(columns, decoded, points.remarks);
  return points;
}

}  // namespace axiometry::formats
