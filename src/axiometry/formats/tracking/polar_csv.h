// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "axiometry/base/result.h"

/// Readings of instruments that give angles too, as a table with one row for each reading.
namespace axiometry::formats {

struct PolarAngles {
  double azimuth_deg = 0.0;                                        ///< angle from x towards y
  double elevation_deg = 0.0;                                      ///< angle above the plane of x and y
  std::optional<double> azimuth_u_arcsec{}, elevation_u_arcsec{};  ///< standard uncertainties, where the file has them
};

struct PolarTableRow {
  std::size_t point = 0, station = 0, segment = 0;
  double length_mm = 0.0;
  std::optional<double> length_u_mm{};  ///< standard uncertainty, where the file has it
  std::optional<PolarAngles> angles{};  ///< absent where the row has a length alone
  std::size_t line = 0;
};

/// Names are those of the file, in the order in which they come first.
struct PolarFile {
  std::vector<std::string> points;
  std::vector<std::string> stations;
  std::vector<std::vector<std::string>> segments;  ///< names, per station
  std::vector<PolarTableRow> rows;
  std::vector<std::string> remarks;  ///< sentences without full stop
};

/// Columns `point,station,length_mm,azimuth_deg,elevation_deg`, or `zenith_deg` (0 upwards) for the elevation, and
/// where they are known the standard uncertainties (k = 1) `u_length_um,u_azimuth_arcsec,u_elevation_arcsec`; `segment`
/// of a beam that was broken, for stations of lengths alone. In any order; other columns are passed over. Every column
/// of a length or an angle states its unit. Rows without angles are lengths; rows without a length are passed over.
/// Cells as read_ranges() has them.
///
/// Fails, with line and column, as read_ranges() does; on a row with one angle; at a station with angles on a length
/// that is not above 0, an azimuth beyond 720° and an elevation beyond 90°; on an uncertainty that is not above 0, of
/// lengths beyond 1 m and of angles beyond 1°.
Result<PolarFile> read_polar(std::string_view bytes);

}  // namespace axiometry::formats
