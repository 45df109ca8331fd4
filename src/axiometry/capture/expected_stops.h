// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <vector>

#include "axiometry/base/quantity.h"
#include "axiometry/base/vector3.h"
#include "axiometry/capture/standstill.h"
#include "axiometry/capture/travel.h"
#include "axiometry/model/series.h"
#include "axiometry/model/tracking.h"

/// Where a reflector shall come to rest, as a tracking interferometer sees it: what a continuous recording of lengths
/// is held against (stop_matcher.h). Derivation: docs/theory/capture-lengths.md.
namespace axiometry::capture {

/// A stop at which a length is to be taken.
struct ExpectedStop {
  Vector3 reflector_mm;              ///< q + t: axes and tool
  Vector3 station_mm;                ///< s, perhaps only about
  std::optional<Direction> arrival;  ///< whether the length grows or falls at last on the way there; nothing: no saying
  double lowest_mm = 0.0;            ///< smallest distance on the way from the stop before, both ends included, mm
  double highest_mm = 0.0;
  bool begins_segment = false;  ///< the beam is certainly another one from here on: another station or another tool
  std::optional<Matrix3> station_covariance_mm2{};  ///< covariance of s, where better known than by its largest error

  double distance_mm() const { return distance(reflector_mm, station_mm); }  ///< |q + t − s|
};

/// How the reflector is driven: of that it follows how rest is told from motion.
struct StopDrive {
  double feed = 3000.0;  ///< mm/min
  Duration dwell = Duration::s(3.0);
  double turn_mm = 0.5;  ///< way back along the beam that counts as a change of direction
};

/// standstill_options() of a plan with that feed and dwell.
StandstillOptions standstill_options(const StopDrive& drive);

/// Stops in the order in which they come, and what is known of them.
struct StopList {
  std::vector<ExpectedStop> stops = {};
  StopDrive drive = {};
  double tolerance_mm = 0.5;      ///< how far a change of length may be from the expected one, beside the rest
  double station_error_mm = 5.0;  ///< how far a station may be from where it is said
  bool direction_counts = false;  ///< a stop reached from the other side is none: its reading says the side
};

/// Expected stops of a way along straight lines, point by point.
class StopPath {
 public:
  /// The same `turn_mm` as that of the drive.
  explicit StopPath(Vector3 station_mm, double turn_mm = StopDrive{}.turn_mm);

  void go(Vector3 reflector_mm);    ///< passes there
  void stop(Vector3 reflector_mm);  ///< the reflector goes there and rests
  /// Another station, or another tool: the next stop begins a segment, and the way there is not known.
  void begin_segment(Vector3 station_mm);

  const std::vector<ExpectedStop>& stops() const { return stops_; }

 private:
  void see(double distance_mm);

  Vector3 station_;
  double turn_;
  std::optional<Vector3> at_;
  Travel eager_, slow_;  // travels with half and with twice the turn: where they differ nobody can say the direction
  double lowest_ = 0.0, highest_ = 0.0;
  bool segment_begins_ = false;
  std::vector<ExpectedStop> stops_;
};

/// A stop of a tracking plan, with the approach whose reading is taken there.
struct LineStop {
  std::size_t line = 0;  ///< number of the line in the plan
  Approach approach;
};

/// What a tracking plan makes the reflector do, line by line. Drive: shortest dwell, slowest feed, a quarter of the
/// shortest overrun. Tolerance: 0.5 mm, a quarter of an interval of targets or of the overrun at most. The station may
/// be off by 1 mm and four times its uncertainty, by 5 mm where that is not known.
struct LineStops {
  StopList list;
  std::vector<LineStop> approaches;  ///< which approach of the plan each stop is
};

/// Needs sound plans of lines in space (contract).
LineStops line_stops(const TrackingPlan& plan);

}  // namespace axiometry::capture
