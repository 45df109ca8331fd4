// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "axiometry/base/result.h"
#include "axiometry/model/tracking.h"

/// Points of a station location as a table: one row for each point at which the reflector stood.
namespace axiometry::formats {

/// Points in the order of the file, with what else must be told about it.
struct LocationPointsFile {
  std::vector<LocationPoint> points;
  bool has_axes = false;  ///< columns axes_x_mm … stand beside those of the reflector, as a plan of points has them
  std::vector<std::string> remarks;  ///< sentences without full stop: the encoding, columns passed over
};

/// Their head as we write it.
inline constexpr std::string_view location_points_head = "x_mm,y_mm,z_mm,length_difference_mm";

/// Columns `x_mm,y_mm,z_mm,length_difference_mm` in any order and other columns, which are passed over: those of a plan
/// of points (`point`, `axes_x_mm`, …) without a word. Delimited by comma, semicolon or tab, with decimal point or, but
/// for the comma, decimal comma. Each of the four states its unit: `x_mm`, `x [m]`, `length_difference (µm)`; `dl`,
/// `delta_l`, `ΔL` and `length_change` are the length difference as well. Lines that begin with # are comments.
///
/// Fails, with line and column, on a column that is missing, there twice or without unit of length, on a cell that is
/// no finite number up to 1e9 mm, on more points than read_budget::location_points, on rows that are cut off, on broken
/// quotes, and as decoded_text() does.
Result<LocationPointsFile> read_location_points(std::string_view bytes);

}  // namespace axiometry::formats
