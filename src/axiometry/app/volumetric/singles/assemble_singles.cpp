// SPDX-License-Identifier: Apache-2.0
#include "axiometry/app/volumetric/singles/assemble_singles.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "axiometry/app/error_motions/motion_tables.h"
#include "axiometry/app/files/whole_file.h"
#include "axiometry/app/results/named_findings_json.h"
#include "axiometry/app/results/result_json.h"
#include "axiometry/app/volumetric/errors_json.h"
#include "axiometry/app/volumetric/result_model.h"
#include "axiometry/app/volumetric/singles/single_reading.h"
#include "axiometry/base/go_on_unless.h"
#include "axiometry/base/text/number_text.h"
#include "axiometry/base/text/text.h"
#include "axiometry/formats/text/json_members.h"
#include "axiometry/formats/volumetric/machine_json.h"
#include "axiometry/formats/volumetric/volumetric_result_json.h"
#include "axiometry/report/figures/error_motions.h"
#include "axiometry/report/sections/sections.h"
#include "axiometry/report/sections/source_files.h"
#include "axiometry/report/shown_number.h"
#include "axiometry/report/translated.h"

namespace axiometry::app {
namespace {

using json::Value;
using report::Align;
using report::plain;
using volumetric::ErrorMotion;

/// Where the axes stood while each of them was measured.
Value stands_to_json(const std::array<std::optional<SingleStand>, 3>& stands) {
  Value object = Value::object();
  for (std::size_t a = 0; a < stands.size(); ++a) {
    if (!stands[a]) continue;
    Value& stand = object.add(std::string(1, static_cast<char>('X' + a)), Value::object());
    Value& axes = stand.add("axes_mm", Value::array());
    for (const double mm : {stands[a]->axes_mm.x, stands[a]->axes_mm.y, stands[a]->axes_mm.z}) axes.push(mm);
    stand.add("tool", stands[a]->tool.empty() ? Value() : Value(stands[a]->tool));
    Value& approaches = stand.add("approaches", Value::object());
    for (std::size_t b = 0; b < stands.size(); ++b)
      if (const double approach = stands[a]->approaches[b]; approach != 0.0)
        approaches.add(std::string(1, static_cast<char>('X' + b)), approach > 0.0 ? "up" : "down");
  }
  return object;
}

Value singles_to_json(const Assembled& a) {
  Value object = Value::object();
  object.add("result", "volumetric-assembled");
  Value& errors = object.add("errors", Value::array());
  for (const AssembledItem& item : a.items) {
    Value& value = errors.push(Value::object());
    value.add("name", item.name);
    value.add("file", item.file.empty() ? Value() : Value(item.file));
    value.add("sha256", item.sha256.empty() ? Value() : Value(item.sha256));
    value.add("runs", item.runs > 0 ? Value(item.runs) : Value());
    value.add("u_largest", item.u_largest);
    value.add("directions", item.directions.empty() ? Value() : Value(item.directions));
    value.add("reversal_largest", item.directions == "both" ? Value(item.reversal) : Value());
    value.add("instrument", instrument_to_json(item.instrument));
    value.add("equipment", item.equipment.empty() ? Value() : Value(item.equipment));
  }
  object.add("at", stands_to_json(a.request.stands));
  object.add("findings", findings_value(a.made.findings));
  Value& remarks = object.add("remarks", Value::array());
  for (const std::string& remark : a.remarks) remarks.push(remark);
  Value& machine = object.add("machine_source", Value::object());
  machine.add("file", a.request.machine);
  machine.add("sha256", a.machine_sha256);
  object.add("curves", errors_value(a.made.model));
  object.add("model", formats::error_model_value(a.made.model));
  object.add("program", program_to_json());
  return object;
}

/// What is shown of an error: the range of its curve of both directions, or its value; the largest uncertainty, and by
/// what its directions differ the most where that is told.
struct ErrorExtent {
  double size = 0.0, u = 0.0;
  std::optional<double> reversal = {};
};

/// From the nodes of a curve; absent where it has no number.
std::optional<ErrorExtent> extent_of(const volumetric::ErrorModel& model, ErrorMotion error) {
  const volumetric::CurveBasis& basis = model.coefficients().basis(error.axis);
  double lowest = 0.0, highest = 0.0;
  ErrorExtent extent{.reversal = 0.0};
  for (std::size_t n = 0; n <= basis.size(); ++n) {
    const double share = static_cast<double>(n) / static_cast<double>(basis.size());
    const double at = basis.lower_mm() + share * (basis.upper_mm() - basis.lower_mm());
    const auto value = model.motion(error, at), up = model.motion(error, at, 1.0), down = model.motion(error, at, -1.0);
    if (!value) return std::nullopt;
    if (!up || !down)
      extent.reversal.reset();
    else if (extent.reversal)
      extent.reversal = std::max(*extent.reversal, std::abs(up->value - down->value));
    lowest = n == 0 ? value->value : std::min(lowest, value->value);
    highest = n == 0 ? value->value : std::max(highest, value->value);
    extent.u = std::max(extent.u, value->u);
  }
  extent.size = highest - lowest;
  return extent;
}

/// "0.4 + 0.5·L".
report::TableCell instrument_cell(const AssembledItem& item, const report::Options& options) {
  if (item.file.empty()) return report::quiet_cell("–");
  if (!item.instrument) return report::quiet_cell("not stated");
  const auto number = [&](double x) { return report::shown_short(x, options); };
  const auto& [a, b_per_m] = *item.instrument;
  return report::text_cell(b_per_m > 0.0 ? fmt::format("{} + {}·L", number(a), number(b_per_m)) : number(a));
}

report::Table singles_table(const Assembled& a, const report::Options& options) {
  report::Table table;
  table.columns = {{plain("Error"), Align::start, true},
                   {plain("Range or value"), Align::decimal},
                   {plain("largest u"), Align::decimal}};
  const bool by_direction = a.made.model.coefficients().reversal() != volumetric::Reversal::none;
  if (by_direction) table.columns.push_back({plain("largest ↑ − ↓"), Align::decimal});
  table.columns.push_back({plain("Unit")});
  table.columns.push_back({plain("Runs"), Align::decimal});
  table.columns.push_back({plain("U of the instrument")});
  table.columns.push_back({plain("File")});
  const bool named = std::ranges::any_of(a.items, [](const AssembledItem& item) { return !item.equipment.empty(); });
  if (named) table.columns.push_back({plain("Test equipment")});
  for (const AssembledItem& item : a.items) {
    auto& row = table.rows.emplace_back();
    row.push_back({report::verbatim(item.name)});
    const auto error = volumetric::error_motion_named(item.name);
    std::optional<ErrorExtent> shown;
    if (error) {
      shown = extent_of(a.made.model, *error);
    } else if (const auto value = a.made.model.squareness(*squareness_named(item.name))) {
      shown = ErrorExtent{value->value, value->u};
    }
    const auto add = [&](std::optional<double> number) {
      row.push_back(number ? number_cell(*number, 2, options) : report::quiet_cell("–"));
    };
    add(shown ? std::optional(shown->size) : std::nullopt);
    add(shown ? std::optional(shown->u) : std::nullopt);
    if (by_direction) add(shown ? shown->reversal : std::nullopt);
    row.push_back(word_cell(error && !error->is_rotation() ? "µm" : "µrad"));
    row.push_back(item.runs > 0 ? word_cell(fmt::format("{}", item.runs)) : report::quiet_cell("–"));
    row.push_back(instrument_cell(item, options));
    row.push_back(item.file.empty() ? report::quiet_cell("–") : report::file_cell(item.file));
    if (named) row.push_back({report::verbatim(item.equipment)});
  }
  table.notes = {
      plain("In the axes of the machine, without constants and without the slope of straightness, rotations "
            "taken out of displacements by their levers. Uncertainties (k = 1): scatter of the means and, "
            "where it was stated, the instrument, independent from one position to the next."),
      plain("U of the instrument: k = 2, in the unit of the error, L the distance from the lowest position in "
            "metres.")};
  if (by_direction)
    table.notes.push_back(
        plain("Range and u are those of the mean of both directions; ↑ − ↓ is what these differ by, – where nothing "
              "tells it."));
  return table;
}

/// Where the others stood while an axis was measured, each with the direction in which it had come to rest there, and
/// with which tool; no rows where no place was given.
report::Table places_table(const Assembled& a, const report::Options& options) {
  constexpr std::string_view letters = "XYZ";
  report::Table table{
      .caption = plain("Where the other axes stood"), .groups = {}, .columns = {}, .rows = {}, .notes = {}};
  table.columns = {{plain("Axis"), Align::start, true},
                   {plain("X / mm")},
                   {plain("Y / mm")},
                   {plain("Z / mm")},
                   {plain("Tool"), Align::start, true}};
  for (std::size_t axis = 0; axis < a.request.stands.size(); ++axis) {
    const auto& stand = a.request.stands[axis];
    if (!stand) continue;
    auto& row = table.rows.emplace_back();
    row.push_back({report::verbatim(letters.substr(axis, 1))});
    for (std::size_t other = 0; other < letters.size(); ++other) {
      const double approach = stand->approaches[other];
      const std::string_view mark = approach > 0.0 ? " ↑" : approach < 0.0 ? " ↓" : "";
      row.push_back(other == axis
                        ? report::quiet_cell("–")
                        : report::text_cell(report::shown_exact(stand->axes_mm[other], options) + std::string(mark)));
    }
    const auto& tools = a.made.model.machine().tools;
    row.push_back({report::verbatim(stand->tool.empty() ? tools.front().name : stand->tool)});
  }
  return table;
}

/// Of every axis of which an error was measured.
report::Section curves_section(const Assembled& a, const report::Options& options) {
  report::Section section{"curves", "Error motions over the travel", false, {}};
  for (std::size_t axis = 0; axis < 3; ++axis)
    if (std::ranges::any_of(a.items, [&](const AssembledItem& item) {
          const auto error = volumetric::error_motion_named(item.name);
          return error && error->axis == axis;
        }))
      section.blocks.emplace_back(report::error_motion_figure(a.made.model, axis, options));
  return section;
}

}  // namespace

Result<Assembled> assemble_singles(const AssembleRequest& request) {
  std::string bytes;
  if (request.machine_bytes) {
    bytes = *request.machine_bytes;
  } else {
    AXIOMETRY_TRY(bytes, whole_file(request.machine));
  }
  AXIOMETRY_TRY(formats::MachineFile machine, in_file(formats::read_machine(bytes), request.machine));
  AXIOMETRY_TRY(ReadSingles read, read_singles(request.items, request.reversal, request.stop));
  volumetric::SingleErrors& errors = read.errors;
  read.remarks.insert(read.remarks.begin(), machine.remarks.begin(), machine.remarks.end());
  for (std::size_t a = 0; a < 3; ++a) {
    if (!request.stands[a]) continue;
    const auto& tools = machine.machine.tools;
    const auto tool = request.stands[a]->tool.empty() && tools.size() == 1
                          ? std::optional<std::size_t>(0)
                          : machine.machine.tool_named(request.stands[a]->tool);
    if (!tool)
      return fail(
          fmt::format("found the tool {}, expected one of the machine's", text::quoted(request.stands[a]->tool)));
    errors.places[a] =
        volumetric::SinglePlace{request.stands[a]->axes_mm, tools[*tool].offset_mm, request.stands[a]->approaches};
  }
  AXIOMETRY_TRY_VOID(go_on_unless(request.stop));
  AXIOMETRY_TRY(volumetric::SingleModel made, volumetric::model_of_singles(std::move(machine.machine), errors));
  return Assembled{request, sha256(bytes), std::move(read.items), std::move(read.remarks), std::move(made)};
}

Experiment present(const Assembled& a, const report::Options& options) {
  Experiment experiment{experiment_document("Errors of a machine measured singly", "ISO 230-1, names of errors"),
                        singles_to_json(a)};
  report::Document& document = experiment.document;
  document.kind = "Measurement";
  document.running_head = report::translated(document.title, options);
  document.running_status = document.edition;
  const std::string& machine = a.made.model.machine().name;
  document.identity = {{plain("Machine"), machine.empty() ? report::file_cell(a.request.machine)
                                                          : report::TableCell{report::verbatim(machine)}},
                       {plain("Kinematic chain"), {report::verbatim(a.made.model.machine().chain.text())}}};
  report::Section section{"errors", "Errors", true, {}};
  section.blocks.emplace_back(singles_table(a, options));
  if (report::Table places = places_table(a, options); !places.rows.empty())
    section.blocks.emplace_back(std::move(places));
  document.sections.push_back(std::move(section));
  document.sections.push_back(curves_section(a, options));
  if (!a.made.findings.empty() || !a.remarks.empty()) {
    report::Section findings{"findings", "Findings", false, {}};
    for (const NamedFinding& finding : a.made.findings)
      findings.blocks.emplace_back(report::Paragraph{report::sentence(finding.message)});
    for (const std::string& remark : a.remarks)
      findings.blocks.emplace_back(report::Paragraph{report::sentence(remark)});
    document.sections.push_back(std::move(findings));
  }
  std::vector<report::SourceFile> files = {{"Machine", a.request.machine, a.machine_sha256}};
  for (const AssembledItem& item : a.items)
    if (!item.file.empty()) files.push_back({item.name, item.file, item.sha256});
  document.sections.push_back(report::provenance_of_files(files));
  return experiment;
}

}  // namespace axiometry::app
