// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "axiometry/base/quantity.h"
#include "axiometry/base/result.h"
#include "axiometry/model/tracking.h"

/// A machine of three linear axes whose errors are known, and a tracking interferometer on its table: what locates a
/// station, tests lines or solves a multilateration can be tried on numbers whose truth stands beside. The same request
/// and seed give the same bits on any system (elementary.h; square roots are exact in IEEE 754).
///
/// The axes are told to stand at q. The reflector, at q + t on a perfect machine, stands at
///   r = q + t + δ(q, time) − ½ g b + ρ
/// with δ = displacement_mm(), the play b of each axis (g = +1 after it moved up, −1 after it moved down, +1 before it
/// ever moved) and ρ normal. At the distance L = |r − s| the instrument shows
///   (1 + κ)(L − L_0) + noise, rounded to the resolution.
///
/// Deliberately absent: rotations of the axes (a single reflector sees them as straightness and scale, to first order),
/// anything in motion (every reading is taken at rest), the instrument's own axes (a sphere hides their errors).
namespace axiometry::simulation {

/// Displacement in one direction, a sinusoid of the coordinate of one axis: straightness where the two differ, a cyclic
/// error of positioning where they are the same. δ_displaced = amplitude·sin(2π q_moved/period + phase).
struct MotionWave {
  std::size_t displaced = 0;  ///< 0 to 2: X, Y, Z
  std::size_t moved = 0;
  Length amplitude = {};
  double period_mm = 0.0;
  Angle phase = {};
};

/// Every member is zero until somebody wants it: a TrackedMachine{} is perfect.
struct TrackedMachine {
  Vector3 origin_mm = {};                 ///< o: where scales and squareness displace nothing
  std::array<RelativeLength, 3> scale{};  ///< e: δ_a = e_a (q_a − o_a)
  RelativeLength C0Y;                     ///< squareness, µm/m = µrad: δ_x = −C0Y (q_y − o_y)
  RelativeLength B0Z;                     ///< δ_x = +B0Z (q_z − o_z)
  RelativeLength A0Z;                     ///< δ_y = −A0Z (q_z − o_z)
  Vector3 offset_mm = {};                 ///< constant displacement
  std::vector<MotionWave> waves = {};
  std::array<Length, 3> backlash{};       ///< b
  std::array<Length, 3> repeatability{};  ///< standard deviation of ρ, drawn anew at each stop
  std::array<Length, 3> growth{};  ///< growth of spindle or column: δ_a = growth_a (1 − e^(−time/growth_time))
  std::array<RelativeLength, 3> warming{};  ///< warming of the scales: added to e_a, times (1 − e^(−time/growth_time))
  Duration growth_time = Duration::s(3600.0);
};

/// The beam is broken before a reading: from then on the lengths have another dead path.
struct TrueBreak {
  std::size_t before_reading = 0;  ///< number in the order of measurement, from 0
  double jump_mm = 0.0;            ///< what is added to all lengths from then on
  bool told = false;               ///< whether the readings say so, by another segment
};

struct VirtualTracker {
  Vector3 station_mm = {};  ///< s
  std::optional<double> dead_path_mm =
      {};             ///< L_0, at which it shows 0; the true distance of the first point when absent
  Length noise = {};  ///< standard deviation of one reading: noise + noise_per_length·L
  RelativeLength noise_per_length = {};
  RelativeLength scale_error = {};     ///< κ: air, wavelength
  Length resolution = {};              ///< step of what is shown; 0: all digits
  std::vector<TrueBreak> breaks = {};  ///< breaks in the lengths of lines; ascending
};

/// Fails, naming what is wrong, on what is not finite, on negative sizes, displacements beyond 1e4 mm, relative ones
/// beyond 0.5, stations beyond 1e6 mm, periods and times that are not above 0, breaks that are not ascending.
Result<void> check_sound(const TrackedMachine& machine);
Result<void> check_sound(const VirtualTracker& tracker);

/// δ of the axes at q: scale, squareness, offset, waves and growth. Without play and ρ. Needs a sound machine.
Vector3 displacement_mm(const TrackedMachine& machine, Vector3 axes_mm, Duration time);

/// To first order the relative stretch uᵀDu of a line in the direction u, cold: what its measured slope estimates.
RelativeLength stretch(const TrackedMachine& machine, Vector3 direction);

/// Where the reflector was and what was shown there.
struct TrueLength {
  Vector3 reflector_mm = {};
  double distance_mm = 0.0;  ///< distance from the station
  double shown_mm = 0.0;
  Duration time;
};

/// How the points of a location or a multilateration are driven to.
struct PointDrive {
  Vector3 tool_offset_mm = {};  ///< t
  double feed = 3000.0;         ///< mm/min
  Duration dwell = Duration::s(3.0);
};

struct SimulatedLocation {
  std::vector<LocationPoint> points = {};  ///< as told, with the lengths shown
  std::vector<TrueLength> truth = {};
  double dead_path_mm = 0.0;  ///< L_0
  Duration duration;
};

/// The points are where the reflector shall stand, in the order in which they are driven to. Fails as check_sound()
/// does and on no point, or one beyond 1e6 mm.
Result<SimulatedLocation> simulate_location(const TrackedMachine& machine, const VirtualTracker& tracker,
                                            std::span<const Vector3> points_mm, const PointDrive& drive,
                                            std::uint64_t seed);

struct SimulatedLineLengths {
  std::vector<LengthReading> readings = {};  ///< readings in the order of measurement
  std::vector<TrueLength> truth = {};        ///< truth of each reading
  Duration end;                              ///< time of the last move
};

/// Walks the lines of a plan, ways and overruns included, from the time `begin` on. A dead path that is absent is the
/// distance of the first reading. Fails as check_sound() does, on a plan that cannot be walked, without lines or with
/// lines that are none in space, and on a beam that breaks after the last reading.
Result<SimulatedLineLengths> simulate_lengths(const TrackedMachine& machine, const VirtualTracker& tracker,
                                              const TrackingPlan& plan, Duration begin, std::uint64_t seed);

struct SimulatedRanges {
  std::vector<RangeReading> readings;      ///< l = (1 + κ) L − L_0
  std::vector<TrueLength> truth = {};      ///< truth of each reading
  std::vector<double> dead_paths_mm = {};  ///< L_0 of each station, before a beam was broken
};

/// One instrument at the stations in turn (`tracker.station_mm` is not used), all points from each in the given order;
/// breaks count over all readings. Each station's dead path is the distance of its first point when it is absent.
/// Fails as simulate_location() does and on no station.
Result<SimulatedRanges> simulate_ranges(const TrackedMachine& machine, const VirtualTracker& tracker,
                                        std::span<const Vector3> stations_mm, std::span<const Vector3> points_mm,
                                        const PointDrive& drive, std::uint64_t seed);

}  // namespace axiometry::simulation
