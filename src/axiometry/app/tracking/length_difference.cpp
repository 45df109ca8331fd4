// SPDX-License-Identifier: Apache-2.0
#include "axiometry/app/tracking/length_difference.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "axiometry/app/results/result_json.h"
#include "axiometry/base/text/number_text.h"
#include "axiometry/formats/text/json_members.h"
#include "axiometry/report/figures/tracking/length_difference.h"
#include "axiometry/report/translated.h"

namespace axiometry::app {
namespace {

using formats::vector_value;
using json::Value;
using report::Align;
using report::plain;

constexpr std::string_view equations_source =
    "Lee et al., Sensors 16 (2016) 482, 4.1, eqs 16 to 23 with corrected signs";

Value numbers_value(const std::vector<double>& list) {
  Value array = Value::array();
  for (const double x : list) array.push(x);
  return array;
}

std::vector<double> degrees(const LengthDifferenceLine& line) {
  std::vector<double> list;
  for (const auto& v : line.values) list.push_back(v.alpha.in_deg());
  return list;
}

std::vector<double> differences_um(const LengthDifferenceLine& line) {
  std::vector<double> list;
  for (const auto& v : line.values) list.push_back(v.difference.in_um());
  return list;
}

std::vector<double> micrometres(const std::vector<Length>& lengths) {
  std::vector<double> list;
  for (const Length x : lengths) list.push_back(x.in_um());
  return list;
}

Value length_differences_to_json(const LengthDifferences& r) {
  Value object = Value::object();
  object.add("result", "length-difference");
  object.add("station_error_mm", vector_value(r.request.station_error_mm));
  if (r.request.direction) object.add("direction", vector_value(unit(*r.request.direction)));
  object.add("reference_mm", r.request.distances_mm[r.reference]);
  object.add("distances_mm", numbers_value(r.request.distances_mm));
  Value& alpha = object.add("alpha_deg", Value::object());
  for (const auto& line : r.lines) alpha.add(line.name, numbers_value(degrees(line)));
  Value& difference = object.add("difference_um", Value::object());
  for (const auto& line : r.lines) difference.add(line.name, numbers_value(differences_um(line)));
  difference.add("combined", numbers_value(micrometres(r.combined)));
  if (r.request.station_uncertainty_mm) {
    Value& bounds = object.add("uncertainty", Value::object());
    bounds.add("station_standard_mm", vector_value(*r.request.station_uncertainty_mm));
    bounds.add("probability", 0.95);
    Value& half = bounds.add("bound_um", Value::object());
    for (const auto& line : r.lines) half.add(line.name, numbers_value(micrometres(line.bounds)));
    Value& from = bounds.add("negligible_from_mm", Value::object());
    for (const auto& line : r.lines)
      from.add(line.name, line.negligible_from_mm ? Value(*line.negligible_from_mm) : Value());
  }
  object.add("program", program_to_json());
  return object;
}

report::Table value_table(const LengthDifferences& r, const report::Options& options) {
  report::Table table;
  table.groups = {{{}, 1},
                  {report::joined({report::italic("α"), plain(" in °")}), r.lines.size()},
                  {report::joined({plain("Δ"), report::italic("d"), plain(" in µm")}), r.lines.size() + 1}};
  table.columns = {{report::joined({report::italic("d"), plain(" in mm")}), Align::decimal, true}};
  for (const auto& line : r.lines) table.columns.push_back({plain(line.name), Align::decimal});
  for (const auto& line : r.lines) table.columns.push_back({plain(line.name), Align::decimal});
  table.columns.push_back({plain("eq. 23"), Align::decimal});
  table.columns[1].opens_group = table.columns[1 + r.lines.size()].opens_group = true;
  for (std::size_t k = 0; k < r.request.distances_mm.size(); ++k) {
    auto& row = table.rows.emplace_back();
    const double d = r.request.distances_mm[k];
    row.push_back(number_cell(d, d == std::floor(d) ? 0 : 3, options));
    for (const auto& line : r.lines) row.push_back(number_cell(line.values[k].alpha.in_deg(), 4, options));
    for (const auto& line : r.lines) row.push_back(number_cell(line.values[k].difference.in_um(), 3, options));
    row.push_back(number_cell(r.combined[k].in_um(), 3, options));
  }
  table.notes = {
      plain("eq. 23 combines x, y and z in quadrature at the same place in the list. It is kept for "
            "comparison with the paper; no path of the machine has that error.")};
  table.dense = true;
  return table;
}

report::Table bound_table(const LengthDifferences& r, const report::Options& options) {
  report::Table table;
  table.caption = plain("Half widths in µm that hold |Δd| with 95 %, from the stated uncertainty of the station");
  table.columns = {{report::joined({report::italic("d"), plain(" in mm")}), Align::decimal, true}};
  for (const auto& line : r.lines) table.columns.push_back({plain(line.name), Align::decimal});
  table.columns.push_back({plain("U of the instrument"), Align::decimal, false, false, true});
  for (std::size_t k = 0; k < r.request.distances_mm.size(); ++k) {
    auto& row = table.rows.emplace_back();
    const double d = r.request.distances_mm[k];
    row.push_back(number_cell(d, d == std::floor(d) ? 0 : 3, options));
    for (const auto& line : r.lines) row.push_back(number_cell(line.bounds[k].in_um(), 4, options));
    row.push_back(number_cell(2e3 * r.request.ranging.standard_mm(d), 4, options));
  }
  for (const auto& line : r.lines)
    table.notes.push_back(
        plain(line.negligible_from_mm
                  ? fmt::format("{}: below a third of the instrument's U from {} mm on, which adds at most 5 % to it.",
                                line.name, format_fixed(*line.negligible_from_mm, 1, options.numbers))
                  : fmt::format("{}: never below a third of the instrument's U.", line.name)));
  table.dense = true;
  return table;
}

report::Figure difference_figure(const LengthDifferences& r, std::span<const std::string_view> names,
                                 std::string_view title, const report::Options& options) {
  report::DistanceSubject subject{.distances_mm = r.request.distances_mm, .curves = {}};
  for (const auto& line : r.lines)
    if (std::ranges::find(names, line.name) != names.end())
      subject.curves.push_back({report::translated(line.name, options), differences_um(line)});
  subject.title = std::string(title);
  subject.description = fmt::format("How much longer lengths seem on {} line{}, over the distance from the station.",
                                    fmt::join(names, ", "), names.size() > 1 ? "s" : "");
  return report::length_difference_figure(subject, r.request.ranging, options);
}

report::Section figure_section(const LengthDifferences& r, const report::Options& options) {
  report::Section section{"figures", "Figures", true, {}};
  report::DistanceSubject angles{.distances_mm = r.request.distances_mm, .curves = {}};
  for (const auto& line : r.lines) angles.curves.push_back({report::translated(line.name, options), degrees(line)});
  angles.title = "Angle between the beam and the line (as Fig. 11 of the paper)";
  angles.description = "The angle falls with one over the distance.";
  section.blocks.emplace_back(report::station_angle_figure(angles, options));
  using Names = std::vector<std::string_view>;
  section.blocks.emplace_back(
      difference_figure(r, Names{"x"}, "Length difference on the x line (as Fig. 12 of the paper)", options));
  section.blocks.emplace_back(
      difference_figure(r, Names{"y", "z"},
                        "Length difference on the y and z lines (as Fig. 13 of the paper, corrected signs)", options));
  if (r.request.direction)
    section.blocks.emplace_back(
        difference_figure(r, Names{"direction"}, "Length difference along the direction given", options));
  return section;
}

}  // namespace

Result<LengthDifferences> compare_lengths(const LengthDifferenceRequest& request) {
  const auto& d = request.distances_mm;
  if (d.empty()) return fail("found no distance, expected at least one");
  LengthDifferences result{.request = request, .reference = d.size() - 1, .lines = {}, .combined = {}};
  if (request.reference_mm) {
    const auto at = std::ranges::find(d, *request.reference_mm);
    if (at == d.end())
      return fail(fmt::format("found the reference {:g} mm, expected one of the distances", *request.reference_mm));
    result.reference = static_cast<std::size_t>(at - d.begin());
  }
  std::vector<std::pair<std::string, Vector3>> lines = {{"x", {1, 0, 0}}, {"y", {0, 1, 0}}, {"z", {0, 0, 1}}};
  if (request.direction) {
    if (!(norm(*request.direction) >= 1e-9))
      return fail("found a direction without length, expected one that is not 0,0,0");
    lines.emplace_back("direction", unit(*request.direction));
  }
  Matrix3 covariance{};
  if (const auto& u = request.station_uncertainty_mm) {
    for (std::size_t k = 0; k < 3; ++k) {
      if (!((*u)[k] >= 0.0)) return fail(fmt::format("found an uncertainty of {:g} mm, expected 0 or more", (*u)[k]));
      covariance[k][k] = (*u)[k] * (*u)[k];
    }
  }
  for (const auto& [name, direction] : lines) {
    LengthDifferenceLine line{name,
                              direction,
                              tracking::length_differences(request.station_error_mm, direction, d, result.reference),
                              {},
                              {}};
    if (request.station_uncertainty_mm) {
      const auto offset = tracking::offset_uncertainty(covariance, direction);
      line.bounds = tracking::length_difference_bounds(offset, d, result.reference);
      const double from = tracking::negligible_from_mm(offset, request.ranging, 1.0 / 3.0);
      if (std::isfinite(from)) line.negligible_from_mm = from;
    }
    result.lines.push_back(std::move(line));
  }
  result.combined = tracking::combined_length_differences(request.station_error_mm, d, result.reference);
  return result;
}

Experiment present(const LengthDifferences& result, const report::Options& options) {
  Experiment experiment{experiment_document("Length difference", equations_source), length_differences_to_json(result)};
  report::Document& document = experiment.document;
  document.running_head = report::translated(document.running_head, options);
  const Vector3 error = result.request.station_error_mm;
  const auto mm = [&](double x) { return format_fixed(x, 4, options.numbers); };
  document.identity = {{plain("Error of the station, determined − actual"),
                        word_cell(fmt::format("{}, {}, {} mm", mm(error.x), mm(error.y), mm(error.z)))},
                       {plain("Relative to the target at"),
                        word_cell(fmt::format("{} mm", format_fixed(result.request.distances_mm[result.reference], 3,
                                                                    options.numbers)))}};
  report::Section values{"values", "Angle and length difference", true, {}};
  values.blocks.emplace_back(value_table(result, options));
  document.sections.push_back(std::move(values));
  if (result.request.station_uncertainty_mm) {
    report::Section bounds{"bounds", "Bounds", true, {}};
    bounds.blocks.emplace_back(bound_table(result, options));
    document.sections.push_back(std::move(bounds));
  }
  document.sections.push_back(figure_section(result, options));
  return experiment;
}

}  // namespace axiometry::app
