// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <span>
#include <string>
#include <vector>

#include "axiometry/base/result.h"
#include "axiometry/tracking/ranges/multilateration.h"

/// Where each station about stands, found from the nominal points alone; and breaks of the beam that its readings do
/// not state. Internal to multilaterate() and adjust_polar().
namespace axiometry::tracking::detail {

/// The readings of one station in the order of measurement.
struct StationReadings {
  std::vector<Vector3> nominal_mm;
  std::vector<double> length_mm;
  std::vector<std::size_t> segment;  ///< segment per reading, within the station
  std::vector<std::size_t> reading;  ///< index among all
  std::vector<std::size_t> point;
  std::size_t segments = 0;
};

struct StationStart {
  Vector3 station_mm;
  std::vector<double> dead_mm;         ///< dead path per segment
  double rms_mm = 0.0;                 ///< root mean square of the residuals, which hold the machine's errors
  std::optional<Vector3> mirror_mm{};  ///< fits as well: the nominal points lie on a plane
};

/// Eq. 14 for the longest segment, then least squares on the distances with one dead path for each segment; from many
/// starts where eq. 14 has no unique solution. Of two mirror images the one on the upper side of the plane (+Z, else
/// +Y, else +X). Fails on fewer readings than unknowns. `name` is that of the station, for messages.
Result<StationStart> start_station(const StationReadings& readings, const std::string& name);

/// The step that explains the residuals about a start better than anything else, where it is well above their scatter
/// and more than machines err (0.05 mm).
struct LengthStep {
  std::size_t before = 0;  ///< index among the station's readings
  double jump_mm = 0.0;
};
std::optional<LengthStep> find_step(const StationReadings& readings, const StationStart& start);

/// Changes of length between readings that follow one another which no way between their points explains. Machines err
/// by less than 1 mm.
struct TriangleCheck {
  std::size_t pairs = 0;
  std::vector<LengthStep> violations;
};
TriangleCheck check_triangles(const StationReadings& readings);

/// Begins a new segment there; `before` must not be the first reading of its segment.
void restart_segment(StationReadings& readings, std::size_t before);

/// Moves the beginning of the last segment to where both dead paths explain the readings best; says where that is.
std::size_t settle_restart(StationReadings& readings, std::size_t before, const StationStart& start);

}  // namespace axiometry::tracking::detail
