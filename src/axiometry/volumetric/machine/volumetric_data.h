// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "axiometry/base/vector3.h"

/// Lengths from stations to the tools of a machine, as they were measured.
namespace axiometry::volumetric {

struct VolumetricReading {
  std::size_t station = 0;
  std::size_t tool = 0;
  std::size_t segment = 0;  ///< segment of this station with this tool: a beam that was broken begins another
  Vector3 axes_mm;          ///< q, where the axes were told to stand
  double length_mm = 0.0;   ///< |p − s| less a dead path that is the same within a segment
  std::size_t line = 0;     ///< line of the file; 0 when there is none
};

/// In the order of measurement.
struct VolumetricLengths {
  std::vector<std::string> stations;
  std::vector<std::string> tools;  ///< as the file names them, in the order in which they come
  std::vector<std::string> segments;
  std::vector<VolumetricReading> readings;
  std::vector<std::string> remarks = {};  ///< sentences without full stop: what was passed over
};

}  // namespace axiometry::volumetric
