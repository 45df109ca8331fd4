// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "axiometry/base/result.h"
#include "axiometry/model/tracking.h"

/// The seven lines from one station (Lee et al., 3.1, 3.2, Figs 8 and 9): x, y, z after ISO 230-2, xy, xz, yz, xyz
/// after ISO 230-6. Each is a straight line of the reflector through the station; what of it can be driven and seen
/// decides whether the line can be measured. Derivation: docs/theory/seven-lines.md.
namespace axiometry::tracking {

inline constexpr std::array<std::string_view, 7> seven_lines = {"x", "y", "z", "xy", "xz", "yz", "xyz"};

enum class DiagonalRule {
  equal_increments,  ///< all axes by the same amount: 45° and 54.7°
  box_corner,        ///< from the station towards the corner of the travels
};

/// What of a line from the station can be measured.
struct UsableInterval {
  std::string id;
  Vector3 direction;      ///< of the reflector from the station, the best of its octants
  std::string octant;     ///< signs of X, Y, Z: "+0−"
  double begin_mm = 0.0;  ///< distances from the station
  double end_mm = 0.0;
  std::string limited_by_begin;  ///< what ends it: "range of the instrument", "travel of X", …
  std::string limited_by_end;
};

struct LineChoice {
  std::vector<UsableInterval> lines;
  std::vector<LostLine> lost;  ///< with reason and numbers: "the station is 12 mm outside the travel of Y, …"
};

/// For each of the ids the best direction: the longest usable interval.
LineChoice choose_lines(const TrackingSetup& setup, std::span<const std::string> ids, DiagonalRule rule);

/// How the lines shall be measured; what is absent is chosen as make_plan() of ISO 230-2 does.
struct LinesRequest {
  std::vector<std::string> ids;  ///< all seven when empty; "body" and "face" diagonals: standards/iso230_6.h
  DiagonalRule rule = DiagonalRule::equal_increments;
  std::optional<std::size_t> count = {};  ///< targets of a line
  std::optional<std::size_t> runs = {};
  std::optional<Position> overrun = {};
  std::optional<double> feed = {};
  std::optional<Duration> dwell = {};
  std::optional<double> acceleration = {};
  std::size_t warm_up_runs = 1;
  std::array<std::optional<Position>, 3> periods = {};  ///< expected of X, Y, Z
  double step_mm = 0.001;                               ///< to which the coordinates of targets are rounded
  std::uint64_t seed = 0;
  std::string title = {}, machine = {}, date = {};
};

/// Intervals, targets (formula (1) of ISO 230-2 along the line), and safe ways from line to line. Lines that cannot be
/// measured are in `lost`. Fails when none is left, on a box without extent, and as make_plan() does.
Result<TrackingPlan> plan_lines(const TrackingSetup& setup, const LinesRequest& request);

/// A station that keeps the most lines, and among such the one with the longest shortest line: searched over the places
/// where an instrument may stand.
struct StationSuggestion {
  Vector3 position_mm;
  std::size_t lines = 0;     ///< of those asked for
  double shortest_mm = 0.0;  ///< usable length of the shortest of them
};
StationSuggestion suggest_station(const TrackingSetup& setup, std::span<const std::string> ids, DiagonalRule rule);

}  // namespace axiometry::tracking
