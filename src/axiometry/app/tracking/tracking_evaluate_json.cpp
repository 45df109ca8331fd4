// SPDX-License-Identifier: Apache-2.0
#include <cmath>

#include "axiometry/app/results/named_findings_json.h"
#include "axiometry/app/results/result_json.h"
#include "axiometry/app/results/uncertainty_json.h"
#include "axiometry/app/tracking/tracking_evaluate.h"
#include "axiometry/formats/plan/tracking_plan_json.h"
#include "axiometry/formats/text/json_members.h"
#include "axiometry/standards/error_motions/motion_estimate.h"
#include "axiometry/tracking/lengths/face_pairs.h"

namespace axiometry::app {
namespace {

using formats::vector_value;
using json::Value;

Value finite_or_null(double x) { return std::isfinite(x) ? Value(x) : Value(); }

/// Null when nothing is known about the station.
Value length_difference_to_json(const tracking::EvaluatedLine& line) {
  if (line.length_difference_bounds.empty()) return {};
  Value object = Value::object();
  object.add("station_uncertainty_mm", Value::array({line.offset.larger_mm, line.offset.smaller_mm}));
  Value& bounds = object.add("bounds_um", Value::array());
  for (const Length& bound : line.length_difference_bounds) bounds.push(bound.in_um());
  object.add("negligible_from_mm", finite_or_null(line.negligible_from_mm));
  return object;
}

Value breaks_to_json(const tracking::EvaluatedLine& line) {
  Value list = Value::array();
  for (const tracking::BeamBreak& b : line.breaks) {
    Value& row = list.push(Value::object());
    row.add("before_reading", b.before_reading + 1);
    row.add("jump_mm", b.jump_mm);
  }
  return list;
}

Value dead_paths_to_json(const tracking::EvaluatedLine& line) {
  Value list = Value::array();
  for (const tracking::DeadPath& p : line.dead_paths) {
    Value& row = list.push(Value::object());
    row.add("first_reading", p.first_reading + 1);
    row.add("readings", p.readings);
    row.add("dead_path_mm", p.dead_path_mm);
    row.add("u_mm", p.uncertainty_mm);
    row.add("ties", p.ties);
    row.add("tied", p.tied);
  }
  return list;
}

Value line_to_json(const tracking::EvaluatedLine& line, const Evaluated& test) {
  const Metadata& metadata = test.test.metadata;
  Value object = Value::object();
  object.add("id", line.id);
  object.add("standard", is_diagonal(metadata.axis) ? iso230_6::edition : iso230_2::edition);
  const auto spatial = spatial_line(metadata.axis);
  object.add("direction", spatial ? vector_value(spatial->direction) : Value());
  Value& slope = object.add("slope", Value::object());
  slope.add("um_per_m", line.slope_um_per_m);
  slope.add("u_um_per_m", line.slope_uncertainty_um_per_m);
  const bool tells_scatter = line.slope_uncertainty_um_per_m > 0.0;
  slope.add("k", tells_scatter ? Value(error_motions::coverage_of(line.slope_degrees_of_freedom)) : Value());
  Value& distances = object.add("distances_mm", Value::array());
  for (const double d : line.distances_mm) distances.push(d);
  object.add("length_difference", length_difference_to_json(line));
  object.add("beam_angle_most_deg", line.beam_angle_most_deg);
  object.add("breaks", breaks_to_json(line));
  object.add("dead_paths", dead_paths_to_json(line));
  object.add("test", to_json(test));
  return object;
}

Value largest_to_json(const std::optional<iso230_6::DiagonalSummary::Largest>& largest) {
  if (!largest) return {};
  Value object = Value::object();
  object.add("line", largest->id);
  object.add("value_um", largest->value.in_native());
  return object;
}

Value face_pairs_to_json(std::span<const tracking::EvaluatedLine> lines) {
  Value list = Value::array();
  for (const tracking::FacePair& pair : tracking::face_pairs(lines)) {
    Value& row = list.push(Value::object());
    row.add("face", pair.face);
    row.add("lines", Value::array({pair.first, pair.second}));
    row.add("slope_difference_um_per_m", pair.slope_difference_um_per_m);
    row.add("squareness", pair.term);
    row.add("um_per_m", pair.squareness_um_per_m);
    row.add("u_um_per_m", number_or_null(pair.uncertainty_um_per_m));
    row.add("k", pair.uncertainty_um_per_m ? Value(pair.coverage_factor) : Value());
  }
  return list;
}

Value diagonals_to_json(const EvaluatedLines& evaluated) {
  Value object = Value::object();
  object.add("standard", iso230_6::edition);
  Value& ids = object.add("lines", Value::array());
  for (const Evaluated& test : evaluated.tests)
    if (is_diagonal(test.test.metadata.axis)) ids.push(test.name);
  object.add("E", largest_to_json(evaluated.diagonals.E));
  object.add("R", largest_to_json(evaluated.diagonals.R));
  object.add("B", largest_to_json(evaluated.diagonals.B));
  object.add("face_pairs", face_pairs_to_json(evaluated.evaluation.lines));
  return object;
}

Value squareness_to_json(const std::optional<tracking::ScalesAndSquareness>& squareness) {
  if (!squareness) return {};
  Value object = Value::object();
  Value& terms = object.add("terms", Value::array());
  for (const tracking::SquarenessTerm& term : squareness->terms) {
    Value& row = terms.push(Value::object());
    row.add("id", term.id);
    row.add("um_per_m", number_or_null(term.value_um_per_m));
    row.add("u_um_per_m", number_or_null(term.uncertainty_um_per_m));
    row.add("k", term.uncertainty_um_per_m ? Value(term.coverage_factor) : Value());
  }
  object.add("rank", squareness->rank);
  object.add("degrees_of_freedom", squareness->degrees_of_freedom);
  object.add("chi_squared", squareness->weighted ? Value(squareness->chi_squared) : Value());
  Value& residuals = object.add("residuals_um_per_m", Value::array());
  for (const double r : squareness->residuals_um_per_m) residuals.push(r);
  Value& notes = object.add("notes", Value::array());
  for (const std::string& note : squareness->notes) notes.push(note);
  return object;
}

Value read_file_to_json(const ReadFile& file) {
  Value object = Value::object();
  object.add("file", file.file);
  object.add("sha256", file.sha256);
  return object;
}

}  // namespace

json::Value to_json(const EvaluatedLines& evaluated) {
  Value object = Value::object();
  object.add("result", "tracking-evaluation");
  object.add("machine", evaluated.plan.machine);
  object.add("setup", formats::tracking_setup_value(evaluated.plan.setup));
  Value& lines = object.add("lines", Value::array());
  for (std::size_t k = 0; k < evaluated.tests.size(); ++k)
    lines.push(line_to_json(evaluated.evaluation.lines[k], evaluated.tests[k]));
  object.add("iso230_6", diagonals_to_json(evaluated));
  object.add("squareness", squareness_to_json(evaluated.evaluation.squareness));
  object.add("findings", findings_value(evaluated.evaluation.findings));
  Value& source = object.add("source", read_file_to_json(evaluated.lengths));
  source.add("format", !evaluated.recording.empty() ? evaluated.recording
                       : evaluated.in_program_order ? std::string("tracking-lengths-in-order")
                                                    : std::string("tracking-lengths"));
  source.add("plan", read_file_to_json(evaluated.plan_file));
  source.add("station", evaluated.station_file ? read_file_to_json(*evaluated.station_file) : Value());
  object.add("program", program_to_json());
  return object;
}

}  // namespace axiometry::app
