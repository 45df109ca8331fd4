// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "axiometry/base/quantity.h"
#include "axiometry/base/vector3.h"
#include "axiometry/model/plan.h"

/// Tests with a tracking interferometer: a station on the table follows a reflector on the spindle and measures changes
/// of their distance. Points are in the machine's coordinates, in mm: the reflector stands at q + t when the axes stand
/// at q and the tool offset is t; the station s is given in the reflector's coordinates, so that the distance is
/// |q + t − s|. Method and terms: Lee et al., Sensors 16 (2016) 482; docs/theory/tracking.md.
namespace axiometry {

/// Where the instrument stands, and how well that is known.
struct Station {
  Vector3 position_mm;                         ///< s
  std::optional<Matrix3> covariance_mm2 = {};  ///< covariance of s; absent when nothing is known about it
};

/// What the maker states about lengths: U = a + b·L, k = 2 (Table 1 of Lee et al. for the LaserTRACER).
struct RangingUncertainty {
  Length constant = Length::um(0.2);                          ///< a
  RelativeLength per_length = RelativeLength::um_per_m(0.3);  ///< b

  /// Standard uncertainty (k = 1) of a length, mm.
  double standard_mm(double length_mm) const {
    return (constant.in_mm() + per_length.in_um_per_m() * 1e-6 * length_mm) / 2.0;
  }
};

/// What instrument and reflector can do. The defaults are those of a catalogue (range) or usual (all others): a
/// configuration, no constants of nature.
struct TrackerLimits {
  double range_least_mm = 200.0;
  double range_most_mm = 15'000.0;
  double elevation_lowest_deg = -20.0;  ///< smallest angle of the beam above the plane of X and Y
  double elevation_highest_deg = 90.0;
  Vector3 reflector_axis = {0.0, 0.0, -1.0};  ///< direction in which the reflector looks from the spindle
  double incidence_most_deg = 60.0;           ///< largest angle between the beam and that axis
  double safe_radius_mm = 120.0;              ///< nothing of the machine comes nearer to the station
  double line_least_mm = 100.0;               ///< a shorter line is not worth a test
};

/// Something that stands in the way of the reflector and of the beam; at rest in the station's coordinates.
struct BoxObstacle {
  Vector3 lowest_mm;
  Vector3 highest_mm;
};
struct SphereObstacle {
  Vector3 centre_mm;
  double radius_mm = 0.0;
};
/// Upright, along Z.
struct CylinderObstacle {
  Vector3 base_mm;  ///< middle of its lower end
  double radius_mm = 0.0;
  double height_mm = 0.0;
};
struct Obstacle {
  std::string name;  ///< "vice"
  std::variant<BoxObstacle, SphereObstacle, CylinderObstacle> shape;
};

/// Where the axes may stand.
struct TravelBox {
  Vector3 lowest_mm;
  Vector3 highest_mm;
};

struct TrackingSetup {
  TravelBox travel;
  Vector3 tool_offset_mm;  ///< t, from where the axes stand to the centre of the reflector
  Station station;
  TrackerLimits limits;
  RangingUncertainty ranging;
  std::vector<Obstacle> obstacles;
};

/// A line to be measured: "x", "xy", "xyz" and so on of the seven lines, "PPP-NNN" and the like of diagonals of the
/// box. Its plan has a line in space, with this meaning of positions:
/// - x, y, z: the coordinate of the machine's axis; its direction is that of the axis;
/// - other lines of the seven: the distance from the station's place on it, negative before it; the first axis that
///   moves goes up with it;
/// - diagonals of the box: the distance from the corner at which the first axis is at its lower end.
struct TrackingLine {
  std::string id;
  Plan plan;
};

/// A line that cannot be measured from this station, and why.
struct LostLine {
  std::string id;
  std::string reason;
};

/// The whole measurement: lines in the order in which they are driven. plan.way_in_mm of each leads from the end of
/// the one before.
struct TrackingPlan {
  std::string title;
  std::string machine;
  std::string date;
  TrackingSetup setup;
  std::vector<TrackingLine> lines;
  std::vector<LostLine> lost;
  std::vector<std::string> remarks;  ///< what the planner tells people
};

/// A point of the station location (Lee et al., 3.3): where the reflector stood, and the change of length shown.
struct LocationPoint {
  Vector3 at_mm;
  double length_difference_mm = 0.0;  ///< ΔL_i = L_i − L_0 (12)
};

/// One measured length of a line.
struct LengthReading {
  std::string line;  ///< id of the line
  Approach approach;
  double length_difference_mm = 0.0;  ///< as shown: since the instrument was set to zero
  /// Readings of one segment share a dead path; a beam that was broken begins another. As stated by the file; 0 first.
  std::size_t segment = 0;
};

/// One measured length of a multilateration (Lee et al., eq. 2).
struct RangeReading {
  std::size_t point = 0;
  std::size_t station = 0;
  double length_mm = 0.0;   ///< l_ij
  std::size_t segment = 0;  ///< which segment of the station's beam; each has its own dead path l_0
};

}  // namespace axiometry
