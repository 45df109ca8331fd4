// SPDX-License-Identifier: Apache-2.0
#include <cmath>

#include "axiometry/app/dynamics/dynamic_motion.h"
#include "axiometry/app/results/result_json.h"

namespace axiometry::app {
namespace {

using json::Value;

Value extreme_to_json(const DynamicMotion& m, double value, std::size_t sample) {
  Value object = Value::object();
  object.add("value", value);
  object.add("time_s", m.record.time_s(sample));
  object.add("position", m.record.positions[sample]);
  return object;
}

Value stretch_to_json(const DynamicMotion& m, const capture::UniformStretch& s) {
  const double deviation = deviation_per_position(m.kind);
  Value object = Value::object();
  object.add("direction", s.velocity > 0.0 ? "up" : "down");
  object.add("begin_s", m.record.time_s(s.first));
  object.add("end_s", m.record.time_s(s.last));
  object.add("from", m.record.positions[s.first]);
  object.add("to", m.record.positions[s.last]);
  object.add("velocity_per_s", s.velocity);
  object.add("feed_error_percent", m.feed ? Value(100.0 * (std::abs(s.velocity) * 60.0 / *m.feed - 1.0)) : Value());
  object.add("velocity_standard_deviation_per_s", s.velocity_deviation);
  object.add("velocity_range_per_s", s.velocity_range);
  object.add("deviation_range", s.deviation_range * deviation);
  object.add("deviation_rms", s.deviation_rms * deviation);
  object.add("acceleration_rms_per_s2", s.acceleration_rms);
  return object;
}

Value spectrum_to_json(const DynamicMotion& m) {
  Value object = Value::object();
  object.add("of", m.spectrum_of == SpectrumOf::whole ? "recording" : "longest_stretch");
  object.add("begin_s", m.record.time_s(m.spectrum_stretch.first));
  object.add("end_s", m.record.time_s(m.spectrum_stretch.last));
  object.add("window", "hann");
  object.add("step_hz", m.spectrum.step_hz);
  object.add("resolution_hz", m.spectrum.resolution_hz);
  object.add("floor", m.spectrum.floor);
  object.add("threshold", m.spectrum.threshold);
  object.add("peaks_more", m.spectrum.peaks_more);
  object.add("peaks_beside", m.spectrum.peaks_beside);
  Value& peaks = object.add("peaks", Value::array());
  for (const capture::SpectrumPeak& peak : m.spectrum.peaks) {
    Value& row = peaks.push(Value::object());
    row.add("frequency_hz", peak.frequency_hz);
    row.add("amplitude", peak.amplitude);
    const auto way = way_of(m, peak);
    row.add("period", way ? Value(*way) : Value());
  }
  return object;
}

}  // namespace

Value to_json(const DynamicMotion& m) {
  const DynamicExtremes at = extremes_of(m);
  Value object = Value::object();
  object.add("result", "dynamic");
  object.add("unit", position_unit(m.kind));
  object.add("deviation_unit", deviation_unit_key(m.kind));
  object.add("samples", m.record.positions.size());
  object.add("rate_hz", m.record.rate_hz);
  object.add("begin_s", m.record.begin_s);
  object.add("window_s", m.course.window_s);
  Value& noise = object.add("noise", Value::object());
  noise.add("position", m.course.noise);
  noise.add("velocity_per_s", m.course.velocity_noise);
  noise.add("acceleration_per_s2", m.course.acceleration_noise);
  Value& velocity = object.add("velocity_per_s", Value::object());
  velocity.add("highest", extreme_to_json(m, m.course.velocity[at.fastest_up], at.fastest_up));
  velocity.add("lowest", extreme_to_json(m, m.course.velocity[at.fastest_down], at.fastest_down));
  Value& acceleration = object.add("acceleration_per_s2", Value::object());
  acceleration.add("highest", extreme_to_json(m, m.course.acceleration[at.strongest_up], at.strongest_up));
  acceleration.add("lowest", extreme_to_json(m, m.course.acceleration[at.strongest_down], at.strongest_down));
  object.add("feed_per_min", m.feed ? Value(*m.feed) : Value());
  object.add("uniform_share", m.uniform_share);
  Value& stretches = object.add("uniform", Value::array());
  for (const capture::UniformStretch& s : m.stretches) stretches.push(stretch_to_json(m, s));
  object.add("spectrum", spectrum_to_json(m));
  Value& remarks = object.add("remarks", Value::array());
  for (const std::string& remark : m.remarks) remarks.push(remark);
  Value& source = object.add("source", Value::object());
  source.add("file", m.file);
  source.add("sha256", m.sha256);
  source.add("format", m.layout);
  object.add("program", program_to_json());
  return object;
}

}  // namespace axiometry::app
