// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "axiometry/base/result.h"
#include "axiometry/volumetric/machine/volumetric_data.h"

/// Lengths of a volumetric calibration as a table, one row for each reading; and points at which its result is asked.
namespace axiometry::formats {

/// Heads as we write them: of lengths, and of points.
inline constexpr std::string_view volumetric_lengths_head = "station,tool,segment,x_mm,y_mm,z_mm,length_mm";
inline constexpr std::string_view volume_points_head = "tool,x_mm,y_mm,z_mm";

/// Columns `station,tool,x_mm,y_mm,z_mm,length_mm`, where a beam was broken `segment`, in any order; other columns are
/// passed over. x, y, z are where the axes were told to stand. Stations, tools and segments are names or numbers; a
/// segment belongs to its station and tool. Rows are in the order of measurement. Delimiters, units, comments and
/// missing lengths as in read_ranges(), and so are the failures.
Result<volumetric::VolumetricLengths> read_volumetric_lengths(std::string_view bytes);

/// A name as a cell of such tables: quoted where it must be, also where a row would begin as a comment.
std::string name_cell(const std::string& name);

std::string write_volumetric_lengths(const volumetric::VolumetricLengths& lengths);

/// Whether a file with this beginning holds a continuous recording of lengths (formats/recording.h), and not such a
/// table: a layout of recordings recognises it, and its first line names neither station nor tool.
bool is_volumetric_recording(std::string_view head);

/// A place of the axes, and the tool there.
struct VolumePoint {
  std::string tool;
  Vector3 axes_mm;
  std::size_t line = 0;
};
struct VolumePoints {
  std::vector<VolumePoint> points;
  std::vector<std::string> remarks;
};
/// Columns `tool,x_mm,y_mm,z_mm`; without `tool` its name is empty. In the order of the file.
Result<VolumePoints> read_volume_points(std::string_view bytes);

}  // namespace axiometry::formats
