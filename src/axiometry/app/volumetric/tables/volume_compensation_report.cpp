// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <algorithm>
#include <string>
#include <utility>
#include <vector>

#include "axiometry/app/volumetric/tables/volume_compensation.h"
#include "axiometry/base/text/number_text.h"
#include "axiometry/report/figures/compensation_curves.h"
#include "axiometry/report/sections/added_table.h"
#include "axiometry/report/sections/source_files.h"
#include "axiometry/report/translated.h"

namespace axiometry::app {
namespace {

using report::Align;
using report::plain;

constexpr int displacement_decimals = 2;
constexpr std::size_t line_rows = 21;  // of the 201 places that are known: each tenth

report::Section remaining_section(const VolumeCompensation& made, const report::Options& options) {
  report::Table table;
  table.columns = {{plain("Quantity"), Align::start, true, true},
                   {plain("Without / µm"), Align::decimal},
                   {plain("With the table / µm"), Align::decimal}};
  const auto add = [&](std::string_view name, double before, double after) {
    table.rows.push_back({word_cell(name), number_cell(before, displacement_decimals, options),
                          number_cell(after, displacement_decimals, options)});
  };
  add("Displacement on the line, range", made.line_before_um, made.line_after_um);
  add("Error of the tool point, largest", made.effect.before.largest.value, made.effect.after.largest.value);
  add("Error of the tool point, 95 % below", made.effect.before.percent_95, made.effect.after.percent_95);
  add("Error of the tool point, mean", made.effect.before.mean, made.effect.after.mean);
  table.notes = {
      plain("The line runs through the middle of the volume that was observed, both directions of approach. The "
            "error of the tool point is over that volume, without rigid motion, with this table alone."),
      plain("Predicted from the 21 errors, not measured: only another calibration proves it.")};
  return {"remaining", "What remains", true, {std::move(table)}};
}

report::CorrectedLine figure_of_line(const VolumeCompensation& made) {
  const LineOfVolume& line = made.line;
  return {line.positions_mm,
          {line.up_um, line.up_u_um},
          {line.down_um, line.down_u_um},
          line.up_um != line.down_um,
          made.applied};
}

report::Section line_section(const VolumeCompensation& made, const report::Options& options) {
  report::Table table;
  table.columns = {{plain("Position / mm"), Align::decimal, true},
                   {plain("Without ↑ / µm"), Align::decimal},
                   {plain("Without ↓ / µm"), Align::decimal},
                   {plain("With the table ↑ / µm"), Align::decimal},
                   {plain("With the table ↓ / µm"), Align::decimal}};
  const LineOfVolume& line = made.line;
  const std::size_t step = std::max<std::size_t>(1, (line.positions_mm.size() - 1) / (line_rows - 1));
  for (std::size_t k = 0; k < line.positions_mm.size(); k += step) {
    const double position = line.positions_mm[k];
    const auto with = [&](double found, Direction direction) { return found + made.applied.at(position, direction); };
    table.rows.push_back({number_cell(position, 3, options), number_cell(line.up_um[k], displacement_decimals, options),
                          number_cell(line.down_um[k], displacement_decimals, options),
                          number_cell(with(line.up_um[k], Direction::up), displacement_decimals, options),
                          number_cell(with(line.down_um[k], Direction::down), displacement_decimals, options)});
  }
  table.dense = true;
  table.notes = {plain(
      "The range of a curve counts, not its height: the table does nothing at the reference point of the axis, and "
      "what is the same everywhere the zero of the workpiece takes up.")};
  return {"line",
          "Displacement on the line",
          true,
          {report::corrected_line_figure(figure_of_line(made), options), std::move(table)}};
}

report::Section nodes_section(const VolumeCompensation& made, const report::Options& options) {
  constexpr std::size_t rows_most = 41;  // with its figure a page
  return {"table",
          "Table",
          true,
          {report::line_correction_figure(figure_of_line(made), options),
           report::added_table(made.applied, rows_most, made.control->limits.rolls_over, options)}};
}

report::Section control_words(const VolumeCompensation& made) {
  const nc::AxisTable& control = *made.control;
  report::Facts facts{"", {}};
  const auto add = [&](std::string_view name, std::string_view value) {
    facts.facts.push_back({plain(name), word_cell(value)});
  };
  add("Control", control.title);
  add("A number in the file", nc::sign_of(control, made.options));
  add("Loading", control.loading);
  add("Verified of this format", control.verified);
  if (!control.inferred.empty()) add("Inferred, not seen", control.inferred);
  return {"control", "Control", true, {std::move(facts)}};
}

}  // namespace

Experiment present(const VolumeCompensation& made, const report::Options& options) {
  constexpr std::string_view letters = "XYZ";
  report::Document document = experiment_document("Compensation of the volume", "From the 21 errors of a machine");
  document.kind = "Compensation";
  document.running_head = report::translated(document.title, options);
  document.running_status = "Compensation, predicted";
  if (!made.machine.empty()) document.identity.push_back({plain("Machine"), {report::verbatim(made.machine)}});
  if (!made.tool.empty()) document.identity.push_back({plain("Tool"), {report::verbatim(made.tool)}});
  document.identity.push_back({plain("Positions of axis"), {report::verbatim(letters.substr(made.along, 1))}});
  document.identity.push_back(
      {plain("Direction that is corrected"), {report::verbatim(letters.substr(made.component, 1))}});
  document.identity.push_back({plain("Errors"), {report::verbatim(made.errors)}});
  report::Notice notice{report::Tone::normal,
                        plain(fmt::format("Displacement on the line from {} to {} µm, as predicted from the 21 errors",
                                          format_fixed(made.line_before_um, displacement_decimals, options.numbers),
                                          format_fixed(made.line_after_um, displacement_decimals, options.numbers))),
                        {}};
  for (const NamedFinding& finding : made.findings) {
    if (finding.serious) notice.tone = report::Tone::bad;
    notice.lines.push_back(report::sentence(finding.message));
  }
  document.status = {std::move(notice)};
  document.sections = {remaining_section(made, options), line_section(made, options), nodes_section(made, options),
                       control_words(made)};
  const report::SourceFile source{"Result", made.result, made.result_sha256};
  document.sections.push_back(report::provenance_of_files({&source, 1}));
  return {std::move(document), to_json(made)};
}

}  // namespace axiometry::app
