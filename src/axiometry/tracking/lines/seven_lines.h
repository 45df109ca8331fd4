// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstddef>
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
///
/// With q the place of the axes, t the tool offset and s the station, the reflector stands at q + t, and on a line at
/// s + d·u: the axes at s − t + d·u. Elevation and incidence are the same all along the line; range, travels, the safe
/// radius and obstacles (clearance and line of sight) cut it. The longest piece that is left is the usable interval,
/// overruns included; of all signs of u the one whose piece is longest is taken, at equal length that with more axes
/// going up.
namespace axiometry::tracking {

inline constexpr std::array<std::string_view, 7> seven_lines = {"x", "y", "z", "xy", "xz", "yz", "xyz"};

enum class DiagonalRule {
  equal_increments,  ///< all axes by the same amount: 45° and 54.7°
  box_corner,        ///< a line from the station towards the corner of the travels
};

/// What of a line from the station can be measured.
struct UsableInterval {
  std::string id;
  Vector3 direction;      ///< direction from the station to the reflector, the best of its octants
  std::string octant;     ///< signs of X, Y, Z: "+0−"
  double begin_mm = 0.0;  ///< distances from the station; overruns are to fit between them, too
  double end_mm = 0.0;
  std::string limited_by_begin{};  ///< what ends it: "least range of the instrument", "upper end of X", …
  std::string limited_by_end{};

  double length_mm() const { return end_mm - begin_mm; }
};

struct LineChoice {
  std::vector<UsableInterval> lines;
  std::vector<LostLine> lost;  ///< lines with reason and numbers: "the station is 12 mm outside the travel of Y, …"
};

/// Fails, with the numbers, on a set-up in which nothing can be planned: coordinates that are not finite, a travel
/// whose upper end is not above its lower one, limits that exclude each other, obstacles without extent, a station
/// farther from all that the reflector reaches than the instrument measures (metres taken for millimetres).
Result<void> check_setup(const TrackingSetup& setup);

/// For each of the ids the best direction: the longest usable interval. An id that is none of the seven is lost.
LineChoice choose_lines(const TrackingSetup& setup, std::span<const std::string> ids, DiagonalRule rule);

/// How the lines shall be measured; what is absent is chosen as make_plan() of ISO 230-2 does.
struct LinesRequest {
  std::vector<std::string> ids = {};  ///< all seven when empty; "body" and "face" diagonals: standards/iso230_6.h
  DiagonalRule rule = DiagonalRule::equal_increments;
  std::optional<std::size_t> count = {};  ///< targets of a line
  std::optional<std::size_t> runs = {};
  std::optional<Position> overrun = {};
  std::optional<double> feed = {};
  std::optional<Duration> dwell = {};
  std::optional<double> acceleration = {};
  std::size_t warm_up_runs = 1;
  std::array<std::optional<Position>, 3> periods = {};  ///< expected of X, Y, Z
  double step_mm = 0.001;                               ///< step to which the coordinates of targets are rounded
  std::uint64_t seed = 0;
  std::string title = {}, machine = {}, date = {};
};

/// How the error begins when no line is left; the reasons follow.
inline constexpr std::string_view none_left = "found no line that can be measured, expected one at least";

/// Intervals, targets (formula (1) of ISO 230-2 along the line), and safe ways from line to line. Lines that cannot be
/// measured are in `lost`. Fails when none is left, on ids that are no lines, and as check_setup() and make_plan() do.
///
/// - **Targets** lie within the usable interval less an overrun at both ends. Of lines above 2 000 mm the whole is
///   measured with five runs and five targets per metre, which holds the test of every 2 000 mm in it (5.3.3).
/// - **Period**: along a line with direction u the period p_a of axis a is p_a/|u_a|; the largest of those that move is
///   the one that the random part of the targets spans, and so at least one of each of the others.
/// - **Coordinates** of targets are multiples of the step. On equal increments they are so exactly; elsewhere a target
///   is moved along the line, by 0.1 mm at most, to where such a place lies within a quarter of a step beside the line,
///   and its position is the foot of that place on the line. What is left is across the line, and of second order.
/// - **Seed**: of each line its own, seed + the line's number among the seven.
/// - **Order**: the one with the shortest ways, and before that the fewest that lose the beam.
/// - **Box diagonals** ("body", "face", "NNN-PPP", …) are driven over the full travels, whatever the station sees: they
///   are for an interferometer aligned with them. Where the sphere of the station or an obstacle is in their way, they
///   are lost.
Result<TrackingPlan> plan_lines(const TrackingSetup& setup, const LinesRequest& request);

/// The plan of a line that is driven without the others: its ways lead from the upper end of Z above its beginning and
/// back there, in place of those from and to its neighbours, where the axes do not stand. As it is where no such way is
/// safe.
Plan plan_alone(const TrackingSetup& setup, const TrackingLine& line);

/// The usable interval that a line of the seven of a plan lies in; absent for other lines, and where an edited plan
/// leads along a line that cannot be measured.
std::optional<UsableInterval> interval_of(const TrackingSetup& setup, const TrackingLine& line);

/// All lines and the ways between them, from rest to rest; without the way to the first.
Duration estimated_duration(const TrackingPlan& plan);

/// What may be changed to keep more lines.
struct StationFreedom {
  std::array<bool, 3> may_move = {true, true, false};  ///< X, Y, Z; it stands on the table
  bool turn_reflector = false;  ///< whether it may turn to the best of 26 directions: axes, faces' and body's diagonals
};

/// The best found.
struct StationSuggestion {
  Vector3 position_mm;
  std::size_t lines = 0;     ///< how many of the lines that were asked for
  double shortest_mm = 0.0;  ///< usable length of the shortest of them
  double total_mm = 0.0;     ///< usable length of all of them
  Vector3 reflector_axis;    ///< direction of the reflector for which this holds
};

/// A station that keeps the most lines, and among such the one with the longest shortest line, then the longest sum:
/// searched over the places where an instrument may stand, 10 mm inside the reach of the reflector or up to a quarter
/// of it outside, and not in obstacles. A grid and then ever smaller steps about the best of it: the same for the same
/// set-up. Never worse than the station given.
StationSuggestion suggest_station(const TrackingSetup& setup, std::span<const std::string> ids, DiagonalRule rule,
                                  const StationFreedom& freedom = {});

}  // namespace axiometry::tracking
