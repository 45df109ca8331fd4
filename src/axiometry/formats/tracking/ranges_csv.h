// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "axiometry/base/result.h"
#include "axiometry/model/tracking.h"

/// Lengths of a multilateration as a table, one row for each reading, and its nominal points.
namespace axiometry::formats {

/// Names are those of the file, in the order in which they come first.
struct RangesFile {
  std::vector<std::string> points;
  std::vector<std::string> stations;
  std::vector<RangeReading> readings;              ///< readings in the order of the file, which is that of measurement
  std::vector<std::size_t> lines;                  ///< line of each point's first reading
  std::vector<std::size_t> reading_lines;          ///< line of each reading
  std::vector<Vector3> nominal_mm;                 ///< nominal place per point; empty when the file has no coordinates
  std::vector<std::vector<std::string>> segments;  ///< names, per station
  std::vector<std::string> remarks;  ///< sentences without full stop: the encoding, columns and rows passed over
};

/// The least a head must have, as we write it.
inline constexpr std::string_view ranges_head = "point,station,length_mm";

/// Columns `point,station,length_mm`, where the beam was broken and found again `segment`, and nominal
/// `x_mm,y_mm,z_mm`, in any order; other columns are passed over. Points, stations and segments are names or numbers. A
/// segment belongs to its station, whose readings without one are of a segment of their own. Delimited by comma,
/// semicolon or tab, with decimal point or, but for the comma, decimal comma. Lengths and coordinates state their unit:
/// `length_mm`, `x [m]`, `range (µm)`. Lines that begin with # are comments; rows whose length is empty or "-" are
/// passed over.
///
/// Fails, with line and column, on a column that is missing, there twice or without unit of length, on an empty name,
/// on a cell that is no finite number up to 1e9 mm, on a point with two nominal places, on rows that are cut off, on
/// broken quotes, and as decoded_text() does. 800 000 rows take about a fifth of a second.
Result<RangesFile> read_ranges(std::string_view bytes);

struct NamedPoints {
  std::vector<std::string> names;
  std::vector<Vector3> at_mm;
  std::vector<std::string> remarks;
};

/// Columns `point,x_mm,y_mm,z_mm`, as above. Fails also on a point given twice.
Result<NamedPoints> read_named_points(std::string_view bytes);

}  // namespace axiometry::formats
