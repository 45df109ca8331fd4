// SPDX-License-Identifier: Apache-2.0
#include "axiometry/simulation/tracked_machine.h"

#include <fmt/format.h>

#include <cmath>

#include "axiometry/base/text/text.h"
#include "axiometry/model/aligned.h"
#include "axiometry/numeric/random/random.h"
#include "axiometry/simulation/elementary.h"

namespace axiometry::simulation {
namespace {

/// The streams of the seed that belong to tracking; virtual_axis has its own below 64. Blocks: what is simulated.
enum TrackingStream : std::uint64_t { stream_stop = 64, stream_length = 65 };
enum Block : std::uint64_t { block_location = 0, block_lines = 1, block_ranges = 2 };

constexpr double way_most_mm = 1e6;

/// std::hypot is not the same on all systems.
double length_of(Vector3 a) { return std::sqrt(dot(a, a)); }

double relative(RelativeLength x) { return x.in_um_per_m() * 1e-6; }

double warmed(const TrackedMachine& machine, Duration time) {
  return 1.0 - exponential(-time.in_s() / machine.growth_time.in_s());
}

/// Drives from place to place and knows where play and chance leave the reflector.
class Drive {
 public:
  Drive(const TrackedMachine& machine, Vector3 tool_offset_mm, numeric::RandomKey key, std::size_t stops)
      : machine_(&machine), tool_(tool_offset_mm), normal_(3 * stops) {
    numeric::fill_normal(key, normal_);
  }

  /// To a place of the axes, at a feed in mm/min.
  void go(Vector3 axes_mm, double feed) {
    if (began_) {
      const Vector3 way = axes_mm - at_;
      for (std::size_t a = 0; a < 3; ++a)
        if (way[a] != 0.0) sign_[a] = way[a] > 0.0 ? 1.0 : -1.0;
      time_s_ += length_of(way) / feed * 60.0;
    }
    began_ = true;
    at_ = axes_mm;
  }
  void rest(Duration dwell) { time_s_ += dwell.in_s(); }
  void begin_at(Duration time) { time_s_ = time.in_s(); }
  Duration time() const { return Duration::s(time_s_); }

  /// Where the reflector comes to rest; one after the other.
  Vector3 reflector() {
    Vector3 r = at_ + tool_ + displacement_mm(*machine_, at_, time());
    for (std::size_t a = 0; a < 3; ++a) {
      r[a] -= 0.5 * sign_[a] * machine_->backlash[a].in_mm();
      r[a] += machine_->repeatability[a].in_mm() * normal_[3 * stop_ + a];
    }
    ++stop_;
    return r;
  }

 private:
  const TrackedMachine* machine_;
  Vector3 tool_;
  std::vector<double> normal_;
  std::size_t stop_ = 0;
  Vector3 at_;
  Vector3 sign_ = {1.0, 1.0, 1.0};
  bool began_ = false;
  double time_s_ = 0.0;
};

/// What the instrument shows, reading by reading.
class Display {
 public:
  Display(const VirtualTracker& tracker, numeric::RandomKey key, std::size_t readings)
      : tracker_(&tracker), normal_(readings), dead_path_(tracker.dead_path_mm) {
    numeric::fill_normal(key, normal_);
  }

  /// A new station: another dead path, another segment count.
  void move_to(Vector3 station_mm) {
    station_ = station_mm;
    dead_path_ = tracker_->dead_path_mm;
    jumped_ = 0.0;
    segment_ = 0;
  }

  /// `full` shows (1 + κ) L − L_0, as eq. 2 of multilateration has it; else (1 + κ)(L − L_0).
  TrueLength show(Vector3 reflector_mm, Duration time, bool full) {
    for (; break_ < tracker_->breaks.size() && tracker_->breaks[break_].before_reading == reading_; ++break_) {
      jumped_ += tracker_->breaks[break_].jump_mm;
      segment_ += tracker_->breaks[break_].told;
    }
    const double length = length_of(reflector_mm - station_);
    if (!dead_path_) dead_path_ = length;
    const double kappa = 1.0 + relative(tracker_->scale_error);
    const double sigma = tracker_->noise.in_mm() + relative(tracker_->noise_per_length) * length;
    const double raw = (full ? kappa * length - *dead_path_ : kappa * (length - *dead_path_)) + jumped_;
    return {reflector_mm, length, rounded(raw + sigma * normal_[reading_++]), time};
  }
  std::size_t segment() const { return segment_; }
  double dead_path_mm() const { return dead_path_.value_or(0.0); }
  std::size_t breaks_seen() const { return break_; }

 private:
  /// To the nearest multiple of the resolution; by its whole number per mm where it has one, so that 0.000001 mm gives
  /// numbers of six decimals.
  double rounded(double x) const {
    const double step = tracker_->resolution.in_mm();
    if (step == 0.0) return x;
    const double per_mm = std::nearbyint(1.0 / step);
    if (per_mm >= 1.0 && std::abs(per_mm * step - 1.0) < 1e-9) return std::nearbyint(x * per_mm) / per_mm;
    return std::nearbyint(x / step) * step;
  }

  const VirtualTracker* tracker_;
  std::vector<double> normal_;
  std::optional<double> dead_path_;
  Vector3 station_;
  double jumped_ = 0.0;
  std::size_t reading_ = 0, break_ = 0, segment_ = 0;
};

Result<void> check_points(std::span<const Vector3> points_mm, std::string_view what) {
  if (points_mm.empty()) return fail(fmt::format("found no {}, expected at least one", what));
  for (std::size_t k = 0; k < points_mm.size(); ++k)
    if (!is_finite(points_mm[k]) || length_of(points_mm[k]) > way_most_mm)
      return fail(fmt::format("found {} {} at ({:g}, {:g}, {:g}) mm, expected coordinates up to 1e6 mm", what, k + 1,
                              points_mm[k].x, points_mm[k].y, points_mm[k].z));
  return {};
}

Result<void> check_drive(const PointDrive& drive) {
  if (!is_finite(drive.tool_offset_mm) || !(drive.feed > 0.0) || !std::isfinite(drive.feed) ||
      !(drive.dwell.in_s() >= 0.0) || !std::isfinite(drive.dwell.in_s()))
    return fail(
        fmt::format("found a feed of {:g} mm/min and a dwell of {:g} s, expected a feed above 0 and a dwell of 0 "
                    "or more",
                    drive.feed, drive.dwell.in_s()));
  return {};
}

Result<void> check_breaks_seen(const VirtualTracker& tracker, const Display& display, std::size_t readings) {
  if (display.breaks_seen() == tracker.breaks.size()) return {};
  return fail(fmt::format("found a broken beam before reading {}, expected one of the {} readings",
                          tracker.breaks[display.breaks_seen()].before_reading + 1, readings));
}

}  // namespace

Vector3 displacement_mm(const TrackedMachine& machine, Vector3 axes_mm, Duration time) {
  const Vector3 from_origin = axes_mm - machine.origin_mm;
  const double warm = warmed(machine, time);
  Vector3 d = machine.offset_mm;
  for (std::size_t a = 0; a < 3; ++a) {
    d[a] += (relative(machine.scale[a]) + relative(machine.warming[a]) * warm) * from_origin[a];
    d[a] += machine.growth[a].in_mm() * warm;
  }
  d.x += relative(machine.B0Z) * from_origin.z - relative(machine.C0Y) * from_origin.y;
  d.y -= relative(machine.A0Z) * from_origin.z;
  for (const MotionWave& w : machine.waves)
    d[w.displaced] += w.amplitude.in_mm() * wave(axes_mm[w.moved] / w.period_mm + w.phase.in_deg() / 360.0).sine;
  return d;
}

RelativeLength stretch(const TrackedMachine& machine, Vector3 u) {
  double sum = 0.0;
  for (std::size_t a = 0; a < 3; ++a) sum += machine.scale[a].in_um_per_m() * u[a] * u[a];
  sum += -machine.C0Y.in_um_per_m() * u.x * u.y + machine.B0Z.in_um_per_m() * u.x * u.z -
         machine.A0Z.in_um_per_m() * u.y * u.z;
  return RelativeLength::um_per_m(sum);
}

Result<SimulatedLocation> simulate_location(const TrackedMachine& machine, const VirtualTracker& tracker,
                                            std::span<const Vector3> points_mm, const PointDrive& drive,
                                            std::uint64_t seed) {
  AXIOMETRY_TRY_VOID(check_sound(machine));
  AXIOMETRY_TRY_VOID(check_sound(tracker));
  AXIOMETRY_TRY_VOID(check_points(points_mm, "point"));
  AXIOMETRY_TRY_VOID(check_drive(drive));
  Drive motion(machine, drive.tool_offset_mm, {seed, stream_stop, block_location}, points_mm.size());
  VirtualTracker unbroken = tracker;
  unbroken.breaks.clear();
  Display display(unbroken, {seed, stream_length, block_location}, points_mm.size());
  display.move_to(tracker.station_mm);
  SimulatedLocation location;
  for (const Vector3 point : points_mm) {
    motion.go(point - drive.tool_offset_mm, drive.feed);
    motion.rest(drive.dwell);
    location.truth.push_back(display.show(motion.reflector(), motion.time(), false));
    location.points.push_back({point, location.truth.back().shown_mm});
  }
  location.dead_path_mm = display.dead_path_mm();
  location.duration = motion.time();
  return location;
}

Result<SimulatedLineLengths> simulate_lengths(const TrackedMachine& machine, const VirtualTracker& tracker,
                                              const TrackingPlan& plan, Duration begin, std::uint64_t seed) {
  AXIOMETRY_TRY_VOID(check_sound(machine));
  AXIOMETRY_TRY_VOID(check_sound(tracker));
  if (plan.lines.empty()) return fail("found a plan without lines, expected at least one");
  std::size_t readings = 0;
  for (const TrackingLine& line : plan.lines) {
    const auto named = [&](std::string_view message) {
      return fail(fmt::format("the line {}: {}", text::quoted(line.id), message));
    };
    if (const auto sound = check_sound(line.plan); !sound) return named(sound.error().message);
    if (!spatial_line(line.plan.axis)) return named("found no place in space, expected its origin and direction");
    readings += approaches(line.plan).size();
  }
  Drive motion(machine, plan.setup.tool_offset_mm, {seed, stream_stop, block_lines}, readings);
  motion.begin_at(begin);
  Display display(tracker, {seed, stream_length, block_lines}, readings);
  if (!is_aligned(plan.setup)) display.move_to(tracker.station_mm);
  SimulatedLineLengths lengths;
  for (const TrackingLine& line : plan.lines) {
    // The direction is made a unit vector here, without std::hypot.
    SpatialLine way = *spatial_line(line.plan.axis);
    const std::vector<double>& given = line.plan.axis.line_direction;
    const Vector3 direction = {given[0], given[1], given[2]};
    if (is_aligned(plan.setup)) display.move_to(setup_along(plan.setup, line).station.position_mm);
    way.direction = 1.0 / length_of(direction) * direction;
    for (const Vector3 place : line.plan.way_in_mm) motion.go(place, line.plan.feed);
    for (const PlannedMove& move : moves(line.plan)) {
      motion.go(way.at(move.to), line.plan.feed);
      if (!move.approach) continue;
      motion.rest(line.plan.dwell);
      lengths.truth.push_back(display.show(motion.reflector(), motion.time(), false));
      lengths.readings.push_back({line.id, *move.approach, lengths.truth.back().shown_mm, display.segment()});
    }
    for (const Vector3 place : line.plan.way_out_mm) motion.go(place, line.plan.feed);
  }
  AXIOMETRY_TRY_VOID(check_breaks_seen(tracker, display, readings));
  lengths.end = motion.time();
  return lengths;
}

Result<SimulatedRanges> simulate_ranges(const TrackedMachine& machine, const VirtualTracker& tracker,
                                        std::span<const Vector3> stations_mm, std::span<const Vector3> points_mm,
                                        const PointDrive& drive, std::uint64_t seed) {
  AXIOMETRY_TRY_VOID(check_sound(machine));
  AXIOMETRY_TRY_VOID(check_sound(tracker));
  AXIOMETRY_TRY_VOID(check_points(stations_mm, "station"));
  AXIOMETRY_TRY_VOID(check_points(points_mm, "point"));
  AXIOMETRY_TRY_VOID(check_drive(drive));
  const std::size_t readings = stations_mm.size() * points_mm.size();
  Drive motion(machine, drive.tool_offset_mm, {seed, stream_stop, block_ranges}, readings);
  Display display(tracker, {seed, stream_length, block_ranges}, readings);
  SimulatedRanges ranges;
  for (std::size_t j = 0; j < stations_mm.size(); ++j) {
    display.move_to(stations_mm[j]);
    for (std::size_t i = 0; i < points_mm.size(); ++i) {
      motion.go(points_mm[i] - drive.tool_offset_mm, drive.feed);
      motion.rest(drive.dwell);
      ranges.truth.push_back(display.show(motion.reflector(), motion.time(), true));
      ranges.readings.push_back({i, j, ranges.truth.back().shown_mm, display.segment()});
    }
    ranges.dead_paths_mm.push_back(display.dead_path_mm());
  }
  AXIOMETRY_TRY_VOID(check_breaks_seen(tracker, display, readings));
  return ranges;
}

}  // namespace axiometry::simulation
