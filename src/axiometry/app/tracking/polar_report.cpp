// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "axiometry/app/files/output.h"
#include "axiometry/app/results/named_findings_json.h"
#include "axiometry/app/results/result_json.h"
#include "axiometry/app/tracking/polar.h"
#include "axiometry/base/text/number_text.h"
#include "axiometry/base/text/text.h"
#include "axiometry/formats/text/json_members.h"
#include "axiometry/report/sections/source_files.h"
#include "axiometry/report/shown_number.h"
#include "axiometry/report/tracking.h"
#include "axiometry/report/translated.h"

namespace axiometry::app {
namespace {

using formats::matrix_value;
using formats::vector_value;
using json::Value;
using report::Align;
using report::plain;
using report::verbatim;

constexpr std::size_t most_points_shown = 200;
constexpr std::size_t most_points_in_picture = 300;

/// Root of a variance in mm², in µm; rounding may leave a variance of 0 below it.
double sigma_um(double variance_mm2) { return 1000.0 * std::sqrt(std::max(variance_mm2, 0.0)); }

class PolarDocument {
 public:
  PolarDocument(const PolarResult& result, const report::Options& options)
      : r_(result), fit_(result.fit), options_(options) {}

  report::Document compose() const {
    report::Document document;
    document.kind = "Polar measurement";
    document.title = "Points from lengths and angles";
    document.edition = "Lee et al., Sensors 16 (2016) 482, eq. 1";
    document.running_head = report::translated(document.title, options_);
    document.running_status = document.edition;
    for (const PolarSource& source : r_.sources)
      document.identity.push_back({plain("Measured readings"), report::file_cell(source.file)});
    document.identity.push_back({plain("Coordinates"), {plain(coordinates())}});
    document.sections = {result_section(), findings_section(), station_section(),
                         point_section(),  figure_section(),   provenance()};
    return document;
  }

 private:
  report::Section provenance() const {
    std::vector<report::SourceFile> files;
    for (const PolarSource& source : r_.sources) files.push_back({"Measured readings", source.file, source.sha256});
    if (r_.points_source) files.push_back({"Nominal points", r_.points_source->file, r_.points_source->sha256});
    return report::provenance_of_files(files);
  }

  std::string coordinates() const {
    if (r_.options.datum == tracking::PolarDatum::nominal) return "as the nominal points, by least squares";
    return "of the first station with angles";
  }

  report::TableCell cell(double x, int decimals) const { return number_cell(x, decimals, options_); }

  report::Section result_section() const {
    report::Facts facts{"", {}};
    const auto add = [&](std::string_view name, std::string text) {
      facts.facts.push_back({plain(name), {plain(text)}});
    };
    add("Equations", fmt::format("{} for {} unknowns", fit_.equations, fit_.unknowns));
    add("Unknowns that the lengths tell", format_fixed(fit_.told_by_lengths, 1, options_.numbers));
    add("Unknowns that the angles tell", format_fixed(fit_.told_by_angles, 1, options_.numbers));
    const std::size_t nu = fit_.degrees_of_freedom();
    add("χ²/ν", nu == 0
                    ? std::string("no redundancy")
                    : fmt::format("{} with ν = {}",
                                  format_fixed(fit_.chi_squared / static_cast<double>(nu), 3, options_.numbers), nu));
    return {"result", "Result", true, {std::move(facts)}};
  }

  report::Section findings_section() const {
    report::Section section{"findings", "Findings", false, {}};
    report::Table table;
    table.columns = {{plain("Kind"), Align::start, true}, {plain("Finding"), Align::start, false, true}};
    for (const auto& f : fit_.findings)
      table.rows.push_back({f.serious ? report::TableCell{report::strong("Serious"), report::Tone::bad}
                                      : report::TableCell{plain("Note"), report::Tone::quiet},
                            report::TableCell{report::sentence(f.message)}});
    if (!r_.remarks.empty()) {
      table.columns.push_back({plain("File")});
      for (auto& row : table.rows) row.emplace_back();
    }
    for (const PolarRemark& remark : r_.remarks)
      table.rows.push_back({report::TableCell{plain("Note"), report::Tone::quiet},
                            report::TableCell{report::sentence(remark.text)},
                            {verbatim(remark.file)}});
    if (table.rows.empty())
      section.blocks.emplace_back(report::Paragraph{plain("No findings: nothing speaks against the result.")});
    else
      section.blocks.emplace_back(std::move(table));
    return section;
  }

  static void add_axes(report::Table& table) {
    for (const char* axis : {"X", "Y", "Z"}) table.columns.push_back({plain(axis), Align::decimal});
  }

  report::Section station_section() const {
    std::vector<double> lengths(r_.stations.size(), 0.0), across(r_.stations.size(), 0.0);
    std::vector<std::size_t> readings(r_.stations.size(), 0), angles(r_.stations.size(), 0);
    for (const auto& reading : r_.readings) {
      const std::size_t j = reading.station;
      ++readings[j];
      lengths[j] += reading.length_sigma_mm * reading.length_sigma_mm;
      if (!reading.direction) continue;
      ++angles[j];
      const double side = reading.length_mm * reading.direction->sideways_sigma_rad,
                   up = reading.length_mm * reading.direction->upwards_sigma_rad;
      across[j] += 0.5 * (side * side + up * up);
    }
    const auto rms = [](double sum, std::size_t n) { return 1000.0 * std::sqrt(sum / static_cast<double>(n)); };
    report::Table table;
    table.groups = {{{}, 1},
                    {plain("Place / mm"), 3},
                    {report::joined({report::italic("u"), plain(" / µm")}), 3},
                    {{}, 1},
                    {plain("u of readings / µm"), 2}};
    table.columns = {{plain("Station"), Align::start, true}};
    add_axes(table);
    add_axes(table);
    table.columns.push_back({plain("Readings"), Align::decimal});
    table.columns.push_back({plain("lengths"), Align::decimal});
    table.columns.push_back({plain("across"), Align::decimal});
    for (std::size_t j = 0; j < fit_.stations.size(); ++j) {
      auto& row = table.rows.emplace_back();
      row.push_back({verbatim(r_.stations[j])});
      for (std::size_t c = 0; c < 3; ++c) row.push_back(cell(fit_.stations[j].position_mm[c], 4));
      for (std::size_t c = 0; c < 3; ++c) row.push_back(cell(sigma_um(fit_.stations[j].covariance_mm2[c][c]), 2));
      row.push_back(word_cell(fmt::format("{}", readings[j])));
      row.push_back(cell(rms(lengths[j], readings[j]), 2));
      row.push_back(angles[j] > 0 ? cell(rms(across[j], angles[j]), 2)
                                  : report::TableCell{plain("–"), report::Tone::quiet});
    }
    table.notes = {
        plain("Standard uncertainties (k = 1). A reading counts by one over the square of its own: the "
              "angles by what they are worth across the beam, where the point is.")};
    table.dense = true;
    return {"stations", "Stations", true, {std::move(table)}};
  }

  report::Section point_section() const {
    const std::size_t shown = std::min(most_points_shown, fit_.points_mm.size());
    const bool nominal = r_.options.datum == tracking::PolarDatum::nominal;
    report::Table table;
    table.groups = {{{}, 1}, {plain("Place / mm"), 3}};
    table.columns = {{plain("Point"), Align::start, true}};
    add_axes(table);
    if (nominal) {
      table.groups.push_back({plain("Off nominal / µm"), 3});
      add_axes(table);
    }
    table.groups.push_back({report::joined({report::italic("u"), plain(" / µm")}), 3});
    add_axes(table);
    for (std::size_t i = 0; i < shown; ++i) {
      auto& row = table.rows.emplace_back();
      row.push_back({verbatim(r_.points[i])});
      for (std::size_t c = 0; c < 3; ++c) row.push_back(cell(fit_.points_mm[i][c], 4));
      for (std::size_t c = 0; nominal && c < 3; ++c)
        row.push_back(cell(1000.0 * (fit_.points_mm[i][c] - r_.nominal_mm[i][c]), 2));
      for (std::size_t c = 0; c < 3; ++c) row.push_back(cell(sigma_um(fit_.covariances_mm2[i][c][c]), 2));
    }
    table.notes = {
        plain(nominal ? "u (k = 1) relative to the points as a whole." : "u (k = 1) in the station's frame.")};
    if (shown < fit_.points_mm.size())
      table.notes.push_back(plain(fmt::format(
          "The first {} of {} points; all are in the JSON and in the table of points.", shown, fit_.points_mm.size())));
    table.dense = true;
    return {"points", "Points", true, {std::move(table)}};
  }

  report::Section figure_section() const {
    report::Layout layout;
    layout.title = "Stations and points";
    layout.description = "A parallel projection of the stations and the points, with three views along the axes.";
    const std::size_t n = fit_.points_mm.size(), shown = std::min(n, most_points_in_picture);
    for (std::size_t k = 0; k < shown; ++k) {
      layout.points_mm.push_back(fit_.points_mm[k * n / shown]);
      layout.point_names.push_back(r_.points[k * n / shown]);
    }
    for (const auto& station : fit_.stations) layout.stations_mm.push_back(station.position_mm);
    layout.station_names = r_.stations;
    return {"figures", "Figures", true, {report::layout_figure(layout, options_)}};
  }

  const PolarResult& r_;
  const tracking::PolarFit& fit_;
  const report::Options& options_;
};

Value polar_stations_value(const PolarResult& r) {
  Value list = Value::array();
  for (std::size_t j = 0; j < r.stations.size(); ++j) {
    const tracking::PolarStation& s = r.fit.stations[j];
    Value& station = list.push(Value::object());
    station.add("name", r.stations[j]);
    station.add("position_mm", vector_value(s.position_mm));
    station.add("covariance_mm2", matrix_value(s.covariance_mm2));
    station.add("has_angles", s.has_angles);
    station.add("turn", s.has_angles ? matrix_value(s.turn) : Value());
    Value& dead = station.add("dead_paths", Value::array());
    for (std::size_t k = 0; k < s.dead_paths_mm.size(); ++k) {
      Value& path = dead.push(Value::object());
      path.add("segment", r.segments[j][k]);
      path.add("dead_path_mm", s.dead_paths_mm[k]);
    }
  }
  return list;
}

Value polar_points_value(const PolarResult& r) {
  Value list = Value::array();
  for (std::size_t i = 0; i < r.points.size(); ++i) {
    Value& point = list.push(Value::object());
    point.add("name", r.points[i]);
    point.add("position_mm", vector_value(r.fit.points_mm[i]));
    if (r.options.datum == tracking::PolarDatum::nominal)
      point.add("deviation_um", vector_value(1000.0 * (r.fit.points_mm[i] - r.nominal_mm[i])));
    point.add("covariance_mm2", matrix_value(r.fit.covariances_mm2[i]));
  }
  return list;
}

Value polar_residuals_value(const PolarResult& r) {
  Value list = Value::array();
  for (std::size_t k = 0; k < r.readings.size(); ++k) {
    const tracking::PolarResidual& residual = r.fit.residuals[k];
    Value& item = list.push(Value::object());
    item.add("point", r.points[r.readings[k].point]);
    item.add("station", r.stations[r.readings[k].station]);
    item.add("length_um", 1000.0 * residual.length_mm);
    item.add("length_normalised", residual.length_normalised);
    if (!r.readings[k].direction) continue;
    item.add("sideways_um", 1000.0 * residual.sideways_mm);
    item.add("sideways_normalised", residual.sideways_normalised);
    item.add("upwards_um", 1000.0 * residual.upwards_mm);
    item.add("upwards_normalised", residual.upwards_normalised);
  }
  return list;
}

Value polar_source_value(const PolarSource& source, std::string_view format) {
  Provenance provenance;
  provenance.file = source.file;
  provenance.sha256 = source.sha256;
  provenance.format = std::string(format);
  return source_to_json(provenance);
}

}  // namespace

Experiment present(const PolarResult& r, const report::Options& options) {
  Experiment experiment{PolarDocument(r, options).compose(), Value::object()};
  Value& json = experiment.json;
  json.add("result", "polar");
  json.add("coordinates", r.options.datum == tracking::PolarDatum::nominal ? "nominal" : "station");
  json.add("equations", r.fit.equations);
  json.add("unknowns", r.fit.unknowns);
  json.add("told_by_lengths", r.fit.told_by_lengths);
  json.add("told_by_angles", r.fit.told_by_angles);
  json.add("chi_squared", r.fit.chi_squared);
  json.add("degrees_of_freedom", r.fit.degrees_of_freedom());
  json.add("variance_factor", r.fit.variance_factor());
  json.add("stations", polar_stations_value(r));
  json.add("points", polar_points_value(r));
  json.add("residuals", polar_residuals_value(r));
  json.add("findings", findings_value(r.fit.findings));
  Value& remarks = json.add("remarks", Value::array());
  for (const PolarRemark& remark : r.remarks) remarks.push(fmt::format("{}: {}", remark.file, remark.text));
  Value& sources = json.add("sources", Value::array());
  for (const PolarSource& source : r.sources) sources.push(polar_source_value(source, "polar-csv"));
  if (r.points_source) json.add("points_source", polar_source_value(*r.points_source, "points-csv"));
  json.add("program", program_to_json());
  return experiment;
}

std::string polar_points_csv(const PolarResult& r) {
  std::string table = "point,x_mm,y_mm,z_mm,ux_um,uy_um,uz_um,cxy_um2,cxz_um2,cyz_um2\n";
  for (std::size_t i = 0; i < r.points.size(); ++i) {
    const Vector3 p = r.fit.points_mm[i];
    const Matrix3& c = r.fit.covariances_mm2[i];
    table += text::csv_cell(text::no_formula(r.points[i]));
    for (const double x : {p.x, p.y, p.z}) table += fmt::format(",{:.7f}", x);
    for (std::size_t k = 0; k < 3; ++k) table += fmt::format(",{:.4f}", sigma_um(c[k][k]));
    for (const double x : {c[0][1], c[0][2], c[1][2]}) table += fmt::format(",{:.6g}", 1e6 * x);
    table += '\n';
  }
  return table;
}

Result<void> write_polar_points(const PolarResult& r, const std::string& file) {
  return write_file(file, polar_points_csv(r));
}

}  // namespace axiometry::app
