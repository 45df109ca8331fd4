// SPDX-License-Identifier: Apache-2.0
#include "axiometry/app/simulate/tracked_truth.h"

#include <fmt/format.h>

#include "axiometry/app/results/result_json.h"
#include "axiometry/base/text/number_text.h"
#include "axiometry/formats/text/json_members.h"
#include "axiometry/formats/tracking/location_points_csv.h"
#include "axiometry/formats/tracking/ranges_csv.h"
#include "axiometry/formats/tracking/tracking_lengths_csv.h"

namespace axiometry::app {
namespace {

using formats::vector_value;
using json::Value;
using simulation::TrueLength;

Value vectors_value(std::span<const Vector3> vectors) {
  Value array = Value::array();
  for (const Vector3 v : vectors) array.push(vector_value(v));
  return array;
}

template <typename Quantity>
Value three(const std::array<Quantity, 3>& values, double (Quantity::*unit)() const) {
  Value array = Value::array();
  for (const Quantity& value : values) array.push((value.*unit)());
  return array;
}

Value machine_value(const simulation::TrackedMachine& m) {
  Value object = Value::object();
  object.add("origin_mm", vector_value(m.origin_mm));
  object.add("scale_um_per_m", three(m.scale, &RelativeLength::in_um_per_m));
  object.add("C0Y_urad", m.C0Y.in_um_per_m());
  object.add("B0Z_urad", m.B0Z.in_um_per_m());
  object.add("A0Z_urad", m.A0Z.in_um_per_m());
  object.add("offset_mm", vector_value(m.offset_mm));
  Value& waves = object.add("waves", Value::array());
  for (const auto& w : m.waves) {
    Value& value = waves.push(Value::object());
    value.add("displaced", std::string(1, static_cast<char>('x' + w.displaced)));
    value.add("moved", std::string(1, static_cast<char>('x' + w.moved)));
    value.add("amplitude_um", w.amplitude.in_um());
    value.add("period_mm", w.period_mm);
    value.add("phase_deg", w.phase.in_deg());
  }
  object.add("backlash_um", three(m.backlash, &Length::in_um));
  object.add("repeatability_um", three(m.repeatability, &Length::in_um));
  object.add("growth_um", three(m.growth, &Length::in_um));
  object.add("warming_um_per_m", three(m.warming, &RelativeLength::in_um_per_m));
  object.add("growth_time_s", m.growth_time.in_s());
  return object;
}

Value tracker_value(const simulation::VirtualTracker& t) {
  Value object = Value::object();
  object.add("noise_um", t.noise.in_um());
  object.add("noise_um_per_m", t.noise_per_length.in_um_per_m());
  object.add("scale_error_um_per_m", t.scale_error.in_um_per_m());
  object.add("resolution_um", t.resolution.in_um());
  Value& breaks = object.add("beam_breaks", Value::array());
  for (const auto& b : t.breaks) {
    Value& value = breaks.push(Value::object());
    value.add("reading", b.before_reading + 1);
    value.add("jump_mm", b.jump_mm);
    value.add("told", b.told);
  }
  return object;
}

void add_length(Value& row, const TrueLength& t) {
  row.add("reflector_mm", vector_value(t.reflector_mm));
  row.add("distance_mm", t.distance_mm);
  row.add("shown_mm", t.shown_mm);
  row.add("time_s", t.time.in_s());
}

Value points_value(const simulation::SimulatedLocation& location) {
  Value list = Value::array();
  for (std::size_t k = 0; k < location.points.size(); ++k) {
    Value& row = list.push(Value::object());
    row.add("nominal_mm", vector_value(location.points[k].at_mm));
    add_length(row, location.truth[k]);
  }
  return list;
}

Value lines_value(const simulation::TrackedMachine& machine, const TrackingPlan& plan) {
  Value list = Value::array();
  for (const TrackingLine& line : plan.lines) {
    const Vector3 direction = spatial_line(line.plan.axis)->direction;
    Value& row = list.push(Value::object());
    row.add("line", line.id);
    row.add("direction", vector_value(direction));
    row.add("stretch_um_per_m", simulation::stretch(machine, direction).in_um_per_m());
  }
  return list;
}

Value lengths_value(const simulation::SimulatedLineLengths& lengths) {
  Value list = Value::array();
  for (std::size_t k = 0; k < lengths.readings.size(); ++k) {
    const LengthReading& r = lengths.readings[k];
    Value& row = list.push(Value::object());
    row.add("line", r.line);
    row.add("target", r.approach.target + 1);
    row.add("direction", r.approach.direction == Direction::up ? "up" : "down");
    row.add("run", r.approach.run + 1);
    add_length(row, lengths.truth[k]);
  }
  return list;
}

Value ranges_value(const TrackedResults& results) {
  Value object = Value::object();
  object.add("stations_mm", vectors_value(results.stations_mm));
  Value& dead = object.add("dead_paths_mm", Value::array());
  for (const double l : results.ranges->dead_paths_mm) dead.push(l);
  object.add("nominal_mm", vectors_value(results.range_points_mm));
  Value& list = object.add("lengths", Value::array());
  for (std::size_t k = 0; k < results.ranges->readings.size(); ++k) {
    const RangeReading& r = results.ranges->readings[k];
    Value& row = list.push(Value::object());
    row.add("point", r.point + 1);
    row.add("station", r.station + 1);
    add_length(row, results.ranges->truth[k]);
  }
  return object;
}

std::string no_measurement(const TrackedSimulation& request) {
  return fmt::format("# Simulated, not measured; seed {}\n", request.seed);
}

}  // namespace

Value tracked_truth_value(const TrackedSimulation& request, const TrackedResults& results) {
  Value object = Value::object();
  object.add("format", "axiometry-tracking-truth/1");
  object.add("seed", static_cast<double>(request.seed));
  object.add("station_mm", vector_value(results.tracker.station_mm));
  if (results.tracker.dead_path_mm) object.add("dead_path_mm", *results.tracker.dead_path_mm);
  object.add("machine", machine_value(request.truth.machine));
  object.add("instrument", tracker_value(results.tracker));
  if (results.location) object.add("points", points_value(*results.location));
  if (results.lengths) {
    object.add("lines", lines_value(request.truth.machine, *results.plan));
    object.add("lengths", lengths_value(*results.lengths));
  }
  if (results.ranges) object.add("ranges", ranges_value(results));
  object.add("program", program_to_json());
  return object;
}

std::string location_table(const TrackedSimulation& request, const simulation::SimulatedLocation& location) {
  std::string text = fmt::format("{}{}\n", no_measurement(request), formats::location_points_head);
  for (const LocationPoint& p : location.points)
    text += fmt::format("{},{},{},{}\n", format_exact(p.at_mm.x), format_exact(p.at_mm.y), format_exact(p.at_mm.z),
                        format_exact(p.length_difference_mm));
  return text;
}

std::string length_table(const TrackedSimulation& request, const simulation::SimulatedLineLengths& lengths) {
  std::string text = fmt::format("{}{},segment,time_s\n", no_measurement(request), formats::tracking_lengths_head);
  for (std::size_t k = 0; k < lengths.readings.size(); ++k) {
    const LengthReading& r = lengths.readings[k];
    text += fmt::format("{},{},{},{},{},{},{:.2f}\n", r.line, r.approach.target + 1,
                        r.approach.direction == Direction::up ? "up" : "down", r.approach.run + 1,
                        format_exact(r.length_difference_mm), r.segment, lengths.truth[k].time.in_s());
  }
  return text;
}

std::string range_table(const TrackedSimulation& request, const TrackedResults& results) {
  std::string text = fmt::format("{}{},segment,x_mm,y_mm,z_mm\n", no_measurement(request), formats::ranges_head);
  for (const RangeReading& r : results.ranges->readings) {
    const Vector3 at = results.range_points_mm[r.point];
    text += fmt::format("{},{},{},{},{},{},{}\n", r.point + 1, r.station + 1, format_exact(r.length_mm), r.segment,
                        format_exact(at.x), format_exact(at.y), format_exact(at.z));
  }
  return text;
}

}  // namespace axiometry::app
