// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <cmath>

#include "axiometry/app/files/output.h"
#include "axiometry/app/files/piecewise.h"
#include "axiometry/app/results/named_findings_json.h"
#include "axiometry/app/results/result_json.h"
#include "axiometry/app/tracking/multilaterate.h"
#include "axiometry/base/contract.h"
#include "axiometry/base/text/number_text.h"
#include "axiometry/base/text/text.h"
#include "axiometry/formats/text/json_members.h"

namespace axiometry::app {
namespace {

using formats::matrix_value;
using formats::vector_value;
using json::Value;

std::string_view scale_name(tracking::ScaleModel scale) {
  switch (scale) {
    case tracking::ScaleModel::fixed: return "fixed";
    case tracking::ScaleModel::common: return "common";
    case tracking::ScaleModel::free: return "free";
  }
  return "";
}

Value rank_value(const tracking::MultilaterationRank& rank) {
  Value object = Value::object();
  object.add("unknowns", rank.unknowns);
  object.add("equations", rank.equations);
  object.add("gauge", rank.gauge);
  object.add("null_directions", rank.null_directions);
  object.add("condition", rank.condition);
  object.add("weakest_mm", rank.weakest_mm);
  object.add("points_least", rank.points_least);
  object.add("stations_coplanar", rank.stations_coplanar);
  object.add("stations_off_plane_mm", rank.stations_off_plane_mm);
  return object;
}

/// "2" for a stated segment; a segment that begins at a break nobody stated has no name.
Value segment_name(const Multilaterated& r, std::size_t station, std::size_t segment) {
  const auto& names = r.ranges.segments[station];
  return segment < names.size() ? Value(names[segment]) : Value();
}

Value stations_value(const Multilaterated& r) {
  Value list = Value::array();
  for (std::size_t j = 0; j < r.ranges.stations.size(); ++j) {
    Value& station = list.push(Value::object());
    station.add("name", r.ranges.stations[j]);
    station.add("position_mm", vector_value(r.fit.stations_mm[j]));
    station.add("covariance_mm2", matrix_value(r.fit.station_covariances_mm2[j]));
    Value& dead = station.add("dead_paths", Value::array());
    for (std::size_t k = 0; k < r.fit.dead_paths_mm[j].size(); ++k) {
      Value& path = dead.push(Value::object());
      path.add("segment", segment_name(r, j, k));
      path.add("dead_path_mm", r.fit.dead_paths_mm[j][k]);
      path.add("u_mm", r.fit.dead_path_sigmas_mm[j][k]);
    }
    station.add("scale", r.fit.scales[j]);
    station.add("scale_u", r.fit.scale_sigmas[j]);
  }
  return list;
}

Value breaks_value(const Multilaterated& r) {
  Value list = Value::array();
  for (const auto& b : r.fit.breaks) {
    Value& item = list.push(Value::object());
    item.add("station", r.ranges.stations[b.station]);
    item.add("reading", b.reading + 1);
    item.add("line", r.ranges.reading_lines[b.reading]);
    item.add("point", r.ranges.points[r.ranges.readings[b.reading].point]);
    item.add("jump_mm", b.jump_mm);
  }
  return list;
}

Value point_value(const Multilaterated& r, std::size_t i) {
  Value point = Value::object();
  point.add("name", r.ranges.points[i]);
  point.add("position_mm", vector_value(r.fit.points_mm[i]));
  point.add("deviation_um", vector_value(1000.0 * (r.fit.points_mm[i] - r.ranges.nominal_mm[i])));
  if (!r.fit.point_covariances_mm2.empty()) point.add("covariance_mm2", matrix_value(r.fit.point_covariances_mm2[i]));
  return point;
}

Value head_value(const Multilaterated& r) {
  Value object = Value::object();
  object.add("result", "multilateration");
  object.add("scale", scale_name(r.options.scale));
  object.add("scale_prior", r.options.scale_prior > 0.0 ? Value(r.options.scale_prior) : Value());
  object.add("converged", r.fit.converged);
  object.add("iterations", r.fit.iterations);
  object.add("chi_squared", r.fit.chi_squared);
  object.add("degrees_of_freedom", r.fit.degrees_of_freedom);
  object.add("variance_factor", r.fit.variance_factor());
  object.add("rank", rank_value(r.fit.rank));
  object.add("stations", stations_value(r));
  object.add("breaks", breaks_value(r));
  object.add("findings", findings_value(r.fit.findings));
  Value& remarks = object.add("remarks", Value::array());
  for (const std::string& remark : r.ranges.remarks) remarks.push(remark);
  Provenance source;
  source.file = r.file;
  source.sha256 = r.sha256;
  source.format = "ranges-csv";
  object.add("source", source_to_json(source));
  if (!r.points_file.empty()) {
    source.file = r.points_file;
    source.sha256 = r.points_sha256;
    source.format = "points-csv";
    object.add("points_source", source_to_json(source));
  }
  object.add("program", program_to_json());
  return object;
}

/// The tree of everything but points and residuals, and these behind it, written as they come.
Result<void> write_json(const Multilaterated& r, const std::string& file) {
  AXIOMETRY_TRY(OutputFile output, OutputFile::create(file));
  std::string text = json::dump(head_value(r));
  text.resize(text.rfind("\n}"));
  text += ",\n  \"points\": [";
  for (std::size_t i = 0; i < r.fit.points_mm.size(); ++i) {
    text += fmt::format("{}\n    {}", i == 0 ? "" : ",", json::dump(point_value(r, i), 0));
    AXIOMETRY_TRY_VOID(output.write(text));
    text.clear();
  }
  text += "\n  ],\n  \"residuals_um\": [";
  for (std::size_t k = 0; k < r.fit.residuals_mm.size(); ++k) {
    text += fmt::format("{}{}{}", k == 0 ? "" : ",", k % 10 == 0 ? "\n    " : " ",
                        json::dump(1000.0 * r.fit.residuals_mm[k], 0));
    if (k % 1000 != 999) continue;
    AXIOMETRY_TRY_VOID(output.write(text));
    text.clear();
  }
  AXIOMETRY_TRY_VOID(output.write(text + "\n  ]\n}\n"));
  return output.commit();
}

constexpr std::string_view points_head = "point,x_mm,y_mm,z_mm,dx_um,dy_um,dz_um";

std::string point_row(const Multilaterated& r, std::size_t i) {
  const Vector3 p = r.fit.points_mm[i], d = 1000.0 * (p - r.ranges.nominal_mm[i]);
  std::string row = text::csv_cell(text::no_formula(r.ranges.points[i]));
  for (double x : {p.x, p.y, p.z}) row += fmt::format(",{:.7f}", x);
  for (double x : {d.x, d.y, d.z}) row += fmt::format(",{:.4f}", x);
  if (!r.fit.point_covariances_mm2.empty())
    for (std::size_t c = 0; c < 3; ++c)
      row += fmt::format(",{:.4f}", 1000.0 * std::sqrt(r.fit.point_covariances_mm2[i][c][c]));
  return row + "\n";
}

std::string residual_row(const Multilaterated& r, std::size_t k) {
  const RangeReading& reading = r.ranges.readings[k];
  std::string row = fmt::format("{},{},{},{},{:.4f}", text::csv_cell(text::no_formula(r.ranges.points[reading.point])),
                                text::csv_cell(text::no_formula(r.ranges.stations[reading.station])),
                                r.fit.segments[k] + 1, format_exact(reading.length_mm), 1000.0 * r.fit.residuals_mm[k]);
  if (!r.fit.normalised_residuals.empty()) row += fmt::format(",{:.3f}", r.fit.normalised_residuals[k]);
  return row + "\n";
}

/// A table, its rows handed over as they come.
template <typename Put>
Result<void> put_points(const Multilaterated& r, const Put& put) {
  AXIOMETRY_TRY_VOID(
      put(fmt::format("{}{}\n", points_head, r.fit.point_covariances_mm2.empty() ? "" : ",ux_um,uy_um,uz_um")));
  for (std::size_t i = 0; i < r.fit.points_mm.size(); ++i) AXIOMETRY_TRY_VOID(put(point_row(r, i)));
  return {};
}

template <typename Put>
Result<void> put_residuals(const Multilaterated& r, const Put& put) {
  AXIOMETRY_TRY_VOID(put(fmt::format("point,station,segment,length_mm,residual_um{}\n",
                                     r.fit.normalised_residuals.empty() ? "" : ",normalised")));
  for (std::size_t k = 0; k < r.ranges.readings.size(); ++k) AXIOMETRY_TRY_VOID(put(residual_row(r, k)));
  return {};
}

Result<void> write_points(const Multilaterated& r, const std::string& file) {
  return write_piecewise(file, [&](const auto& put) { return put_points(r, put); });
}

Result<void> write_residuals(const Multilaterated& r, const std::string& file) {
  return write_piecewise(file, [&](const auto& put) { return put_residuals(r, put); });
}

}  // namespace

Value to_json(const Multilaterated& r) {
  Value object = head_value(r);
  Value& points = object.add("points", Value::array());
  for (std::size_t i = 0; i < r.fit.points_mm.size(); ++i) points.push(point_value(r, i));
  Value& residuals = object.add("residuals_um", Value::array());
  for (const double residual : r.fit.residuals_mm) residuals.push(1000.0 * residual);
  return object;
}

std::string points_csv(const Multilaterated& r) {
  return text_of_pieces([&](const auto& put) { return put_points(r, put); });
}

std::string residuals_csv(const Multilaterated& r) {
  return text_of_pieces([&](const auto& put) { return put_residuals(r, put); });
}

Result<void> write_outputs(const Multilaterated& result, const report::Document& document,
                           const MultilateratedNames& names, const report::Options& options) {
  AXIOMETRY_TRY_VOID(check_inputs_spared(names.outputs));
  for (const std::string& file : {names.points, names.residuals})
    if (!file.empty()) AXIOMETRY_TRY_VOID(names.outputs.inputs.check_spared(file));
  AXIOMETRY_TRY_VOID(write_document(document, names.outputs.reports, options));
  if (!names.points.empty()) AXIOMETRY_TRY_VOID(write_points(result, names.points));
  if (!names.residuals.empty()) AXIOMETRY_TRY_VOID(write_residuals(result, names.residuals));
  if (!names.outputs.json.empty()) AXIOMETRY_TRY_VOID(write_json(result, names.outputs.json));
  return {};
}

}  // namespace axiometry::app
