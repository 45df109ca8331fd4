// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <string>
#include <utility>

#include "axiometry/app/files/source.h"
#include "axiometry/app/results/named_findings_json.h"
#include "axiometry/app/results/result_json.h"
#include "axiometry/app/volumetric/errors_json.h"
#include "axiometry/app/volumetric/identify_lengths.h"
#include "axiometry/app/volumetric/rank_json.h"
#include "axiometry/formats/text/json_members.h"
#include "axiometry/formats/volumetric/machine_json.h"
#include "axiometry/formats/volumetric/volumetric_result_json.h"

namespace axiometry::app {
namespace {

using formats::matrix_value;
using formats::vector_value;
using json::Value;
using volumetric::axis_count;
using volumetric::CurveBasis;
using volumetric::ErrorModel;
using volumetric::FoundBreak;
using volumetric::Identification;
using volumetric::IdentifiedStation;
using volumetric::IdentifiedStretch;
using volumetric::SetAside;
using volumetric::VolumetricRank;
using volumetric::VolumetricReading;

const char* reason_name(SetAside::Reason reason) {
  switch (reason) {
    case SetAside::Reason::outlier: return "outlier";
    case SetAside::Reason::beside_break: return "beside a break";
    case SetAside::Reason::unknown_direction: return "unknown direction";
  }
  return "";
}

Value gauge_value(const ErrorModel& model) {
  Value gauge = Value::object();
  gauge.add("chain", model.machine().chain.text());
  gauge.add("means",
            "the mean of each of the 18 functions over its range is 0: constants are a place of the whole machine");
  gauge.add(
      "straightness",
      "the best straight line of the six straightness functions is level: their slopes are squareness, or turn the "
      "whole machine");
  Value range = Value::object(), points = Value::object();
  for (std::size_t a = 0; a < axis_count; ++a) {
    const CurveBasis& basis = model.coefficients().basis(a);
    const std::string axis(1, "XYZ"[a]);
    range.add(axis, Value::array({basis.lower_mm(), basis.upper_mm()}));
    points.add(axis, vector_value(model.machine().functional_point_mm[a]));
  }
  gauge.add("range_mm", std::move(range));
  gauge.add("functional_point_mm", std::move(points));
  return gauge;
}

Value stations_value(const IdentifiedMachine& identified) {
  Value stations = Value::array();
  const Identification& found = identified.identification;
  for (std::size_t v = 0; v < found.stations.size(); ++v) {
    const IdentifiedStation& own = found.stations[v];
    Value& station = stations.push(Value::object());
    station.add("station", identified.lengths.stations[own.station]);
    station.add("tool", identified.lengths.tools[own.tool]);
    station.add("position_mm", vector_value(own.at_mm));
    station.add("covariance_um2", matrix_value(own.covariance_um2));
    station.add("readings", own.readings);
    station.add("rms_um", own.rms_um);
    station.add("normalised_rms", own.normalised_rms);
    if (own.scale_um_per_m) station.add("scale_um_per_m", *own.scale_um_per_m);
    if (own.scale_u_um_per_m) station.add("scale_u_um_per_m", *own.scale_u_um_per_m);
    Value& stretches = station.add("segments", Value::array());
    for (const IdentifiedStretch& s : found.stretches) {
      if (s.station != v) continue;
      Value& stretch = stretches.push(Value::object());
      stretch.add("segment", identified.lengths.segments[s.segment]);
      stretch.add("readings", s.readings);
      stretch.add("dead_path_mm", s.dead_path_mm);
      if (s.drift_um) stretch.add("drift_um", *s.drift_um);
    }
  }
  return stations;
}

/// Null where nothing was taken for known of the curves.
Value smoothness_value(const IdentifiedMachine& identified) {
  const auto& smoothed = identified.identification.smoothed;
  if (!smoothed) return {};
  const auto names = volumetric::error_names();
  Value value = Value::object();
  value.add("stated", identified.request.options.smoothness.kind == volumetric::Smoothness::Kind::stated);
  const auto bent = [&](bool rotations, double size) {
    const bool any = std::ranges::any_of(smoothed->errors, [&](const volumetric::SmoothedError& s) {
      return volumetric::error_motion_named(names[s.error])->is_rotation() == rotations;
    });
    return any ? Value(size) : Value();
  };
  value.add("displacement_um", bent(false, smoothed->displacement_um));
  value.add("rotation_urad", bent(true, smoothed->rotation_urad));
  value.add("unknowns_told_by_it", smoothed->taken);
  Value& errors = value.add("errors", Value::object());
  for (const volumetric::SmoothedError& s : smoothed->errors) {
    Value& error = errors.add(names[s.error], Value::object());
    error.add("u_ratio", s.u_ratio);
    error.add("bias", s.bias);
    error.add("bend_ratio", s.bend_ratio);
    error.add("chance", s.chance);
  }
  return value;
}

/// Null where parts differ in scale no more than chance lets them.
Value part_scales_value(const Identification& found) {
  if (!found.part_scales) return {};
  Value value = Value::object();
  value.add("spread_um_per_m", found.part_scales->spread_um_per_m);
  value.add("chance", found.part_scales->chance);
  value.add("held", found.part_scales->held);
  value.add("about_mm", vector_value(found.part_scales->about_mm));
  return value;
}

/// Where a reading stands, for a person: its line, or which it is.
void add_reading(Value& object, const IdentifiedMachine& identified, std::size_t i) {
  const VolumetricReading& reading = identified.lengths.readings[i];
  object.add("reading", i + 1);
  if (reading.line > 0) object.add("line", reading.line);
  object.add("station", identified.lengths.stations[reading.station]);
  object.add("tool", identified.lengths.tools[reading.tool]);
}

Value source_value(const IdentifiedMachine& identified) {
  Value source = Value::object();
  if (identified.files.size() == 1) {
    source.add("lengths", identified.files.front().file);
    source.add("lengths_sha256", identified.files.front().sha256);
  }
  Value& files = source.add("files", Value::array());
  for (const LengthsFile& f : identified.files) {
    Value& file = files.push(Value::object());
    file.add("file", f.file);
    file.add("sha256", f.sha256);
    file.add("lengths", f.lengths);
    if (f.layout.empty()) continue;
    file.add("recording", f.layout);
    file.add("first_part", f.parts.first);
    file.add("last_part", f.parts.last);
    file.add("stops", f.planned);
  }
  source.add("machine", base_name(identified.machine_file()));
  source.add("machine_sha256", identified.machine_sha256);
  if (!identified.request.plan.empty()) {
    source.add("plan", base_name(identified.request.plan));
    source.add("plan_sha256", identified.plan_sha256);
  }
  return source;
}

}  // namespace

Value to_json(const VolumetricRank& rank) {
  Value value = Value::object();
  value.add("unknowns", rank.unknowns);
  value.add("errors", rank.errors);
  value.add("rank", rank.unknowns - rank.null_directions);
  value.add("null_directions", rank.null_directions);
  value.add("condition", rank.condition);
  return value;
}

Value to_json(const IdentifiedMachine& identified) {
  const Identification& found = identified.identification;
  const auto names = volumetric::error_names();
  Value root = Value::object();
  root.add("source", source_value(identified));
  root.add("errors", errors_value(found.model));
  root.add("gauge", gauge_value(found.model));
  root.add("rank", to_json(found.rank));
  Value& unseen = root.add("unseen", Value::array());
  for (const std::size_t e : found.model.unseen_errors()) unseen.push(names[e]);
  root.add("chi2_per_dof", found.degrees_of_freedom > 0 ? Value(found.chi_squared_per_dof()) : Value());
  root.add("chi2", found.chi_squared);
  root.add("degrees_of_freedom", found.degrees_of_freedom);
  root.add("variance_factor", found.variance_factor());
  root.add("readings", identified.lengths.readings.size());
  root.add("stations", stations_value(identified));
  Value& aside = root.add("set_aside", Value::array());
  for (const SetAside& s : found.set_aside) {
    Value& item = aside.push(Value::object());
    add_reading(item, identified, s.reading);
    item.add("residual_um", s.residual_um);
    item.add("normalised", s.normalised);
    item.add("why", reason_name(s.reason));
  }
  Value& breaks = root.add("breaks", Value::array());
  for (const FoundBreak& b : found.breaks) {
    Value& item = breaks.push(Value::object());
    add_reading(item, identified, b.before_reading);
    item.add("jump_um", b.jump_um);
    item.add("earliest_reading", b.earliest_reading + 1);
    item.add("latest_reading", b.latest_reading + 1);
  }
  root.add("drift", found.drift);
  root.add("smoothness", smoothness_value(identified));
  root.add("part_scales", part_scales_value(found));
  root.add("findings", findings_value(found.findings));
  root.add("model", formats::error_model_value(found.model));
  return root;
}

}  // namespace axiometry::app
