// SPDX-License-Identifier: Apache-2.0
#include <cmath>

#include "axiometry/app/error_motions/motion_tables.h"
#include "axiometry/formats/test/metadata_json.h"

namespace axiometry::app {
namespace {

using error_motions::MotionEstimate;
using error_motions::PathKind;
using json::Value;

Value known(const std::optional<double>& x) { return x ? Value(*x) : Value(); }

Value scatter_word(MotionEstimate::Scatter scatter) {
  if (scatter == MotionEstimate::Scatter::runs) return Value("runs");
  if (scatter == MotionEstimate::Scatter::noise) return Value("noise");
  if (scatter == MotionEstimate::Scatter::residuals) return Value("residuals");
  return {};
}

Value course_to_json(const error_motions::AxisMotion& motion, const error_motions::MotionPath& path) {
  Value object = Value::object();
  object.add("course", course_key(path.kind));
  object.add("range", estimate_to_json(path.range));
  object.add("highest_mm", motion.positions[path.highest].position_mm);
  object.add("lowest_mm", motion.positions[path.lowest].position_mm);
  if (motion.reference == error_motions::Reference::none) return object;
  object.add("slope_per_m", estimate_to_json(path.slope_per_m));
  if (!is_angle(motion.unit)) object.add("theta_arcsec", error_motions::slope_arcsec(path.slope_per_m.value));
  object.add("intercept", estimate_to_json(path.intercept));
  return object;
}

/// One list of numbers for each thing, which takes a third of an object for each position.
template <typename Of>
Value column_to_json(const error_motions::AxisMotion& motion, const Of& of) {
  Value list = Value::array();
  for (std::size_t i = 0; i < motion.positions.size(); ++i) list.push(of(i));
  return list;
}

Value motion_positions_to_json(const error_motions::AxisMotion& motion) {
  const auto& positions = motion.positions;
  Value object = Value::object();
  object.add("position_mm", column_to_json(motion, [&](std::size_t i) { return Value(positions[i].position_mm); }));
  for (const auto& path : motion.paths) {
    Value& course = object.add(course_key(path.kind), Value::object());
    course.add("mean", column_to_json(motion, [&](std::size_t i) { return Value(path.means[i]); }));
    course.add("residual", column_to_json(motion, [&](std::size_t i) { return Value(path.residuals[i]); }));
    if (motion.runs < 2 || path.kind == PathKind::mean) continue;
    course.add("s", column_to_json(motion, [&](std::size_t i) {
                 return known(path.kind == PathKind::up ? positions[i].s_up : positions[i].s_down);
               }));
  }
  if (motion.paths.size() < 2) return object;
  object.add("reversal", column_to_json(motion, [&](std::size_t i) { return known(positions[i].reversal); }));
  if (motion.runs >= 2)
    object.add("repeatability",
               column_to_json(motion, [&](std::size_t i) { return known(positions[i].repeatability); }));
  return object;
}

}  // namespace

std::string_view course_key(PathKind kind) {
  return kind == PathKind::up ? "up" : kind == PathKind::down ? "down" : "mean";
}

Value texts_to_json(const std::vector<std::string>& texts) {
  Value list = Value::array();
  for (const std::string& text : texts) list.push(text);
  return list;
}

Value numbers_to_json(std::span<const double> numbers) {
  Value list = Value::array();
  for (const double x : numbers) list.push(x);
  return list;
}

Value estimate_to_json(const MotionEstimate& e) {
  Value object = Value::object();
  object.add("value", e.value);
  const bool tells_U = e.tells_U();
  object.add("u", tells_U ? Value(*e.u) : Value());
  object.add("k", tells_U ? Value(e.k) : Value());
  object.add("U", tells_U ? Value(e.U()) : Value());
  object.add("scatter", scatter_word(e.scatter));
  const bool scatters = e.scatter != MotionEstimate::Scatter::none;
  object.add("u_scatter", scatters ? Value(e.scatter_u) : Value());
  object.add("degrees_of_freedom", scatters && std::isfinite(e.scatter_degrees) ? Value(e.scatter_degrees) : Value());
  object.add("u_instrument", known(e.instrument_u));
  return object;
}

Value instrument_to_json(const std::optional<error_motions::InstrumentUncertainty>& instrument) {
  if (!instrument) return {};
  Value object = Value::object();
  object.add("U_constant", instrument->a);
  object.add("U_per_m", instrument->b_per_m);
  return object;
}

Value motion_to_json(const MeasuredMotion& measured) {
  const error_motions::AxisMotion& motion = measured.motion;
  Value object = Value::object();
  object.add("error", measured.error ? Value(measured.error->text()) : Value());
  object.add("read_positive", measured.sense ? Value(measured.sense->text()) : Value());
  object.add("unit", motion_unit_name(motion.unit));
  object.add("reference", error_motions::reference_key(motion.reference));
  object.add("runs", motion.runs);
  object.add("instrument", instrument_to_json(measured.instrument));
  Value& courses = object.add("courses", Value::array());
  for (const auto& path : motion.paths) courses.push(course_to_json(motion, path));
  object.add("range_both", motion.range_both ? estimate_to_json(*motion.range_both) : Value());
  object.add("reversal", motion.reversal ? estimate_to_json(*motion.reversal) : Value());
  object.add("reversal_mean", known(motion.reversal_mean));
  object.add("repeatability_up", known(motion.repeatability_up));
  object.add("repeatability_down", known(motion.repeatability_down));
  object.add("repeatability", known(motion.repeatability));
  object.add("positions", motion_positions_to_json(motion));
  object.add("remarks", texts_to_json(measured.remarks));
  Value metadata = Value::object();
  formats::add_metadata(metadata, measured.metadata);
  object.add("metadata", std::move(metadata));
  Value& source = object.add("source", Value::object());
  source.add("file", measured.file);
  source.add("sha256", measured.sha256);
  return object;
}

}  // namespace axiometry::app
