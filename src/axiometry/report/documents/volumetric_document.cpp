// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "axiometry/report/documents/volumetric_sections.h"
#include "axiometry/report/figures/error_motions.h"
#include "axiometry/report/figures/residuals.h"
#include "axiometry/report/figures/tracking/volumetric_residuals.h"
#include "axiometry/report/sections/fact.h"
#include "axiometry/report/sections/sections.h"
#include "axiometry/report/sections/source_files.h"
#include "axiometry/report/shown_number.h"
#include "axiometry/report/translated.h"
#include "axiometry/report/volumetric.h"
#include "axiometry/volumetric/field/curve_nodes.h"
#include "axiometry/volumetric/field/machine_zero.h"

namespace axiometry::report {
namespace {

using volumetric::axis_count;
using volumetric::CurveBasis;
using volumetric::CurveKind;
using volumetric::CurveNode;
using volumetric::ErrorMotion;
using volumetric::Identification;
using volumetric::IdentifiedStation;
using volumetric::motion_count;
using volumetric::Squareness;
using volumetric::VolumetricFinding;
using volumetric::VolumetricRank;

/// How large one function is over its range, and how well it is known.
struct CurveSummary {
  double largest = 0.0;
  double range = 0.0;
  double u_mean = 0.0;
  double u_largest = 0.0;
};

CurveSummary summary_of(std::span<const CurveNode> nodes) {
  CurveSummary s;
  double lowest = nodes.front().mean.value, highest = lowest;
  for (const CurveNode& node : nodes) {
    s.largest = std::max(s.largest, std::abs(node.mean.value));
    lowest = std::min(lowest, node.mean.value);
    highest = std::max(highest, node.mean.value);
    s.u_mean += node.mean.u / static_cast<double>(nodes.size());
    s.u_largest = std::max(s.u_largest, node.mean.u);
  }
  s.range = highest - lowest;
  return s;
}

class VolumetricComposition {
 public:
  VolumetricComposition(const VolumetricSubject& subject, const Options& options)
      : s_(subject), found_(subject.found), options_(options) {}

  Document compose() const {
    Document document;
    document.kind = "Volumetric calibration";
    document.title = s_.machine.name.empty() ? "The 21 errors of the machine" : s_.machine.name;
    document.edition = "ISO 230-1:2012, names of errors";
    document.running_head = translated(document.title, options_);
    document.running_status = document.edition;
    document.identity = {measured_fact(), file_fact("Machine", s_.machine_file)};
    document.status = {status()};
    document.sections = {result_section(),    findings_section(), squareness_section(),
                         motions_section(),   curves_section(),   station_section(),
                         residuals_section(), method(),           source()};
    return document;
  }

 private:
  std::string number(double x, int decimals) const { return format_fixed(x, decimals, options_.numbers); }
  TableCell cell(double x, int decimals) const { return text_cell(number(x, decimals)); }

  Fact file_fact(std::string_view name, const std::string& file) const { return {plain(name), file_cell(file)}; }

  bool has_recordings() const {
    return std::ranges::any_of(s_.lengths_files, [](const VolumetricLengthsFile& f) { return !f.parts.empty(); });
  }

  Fact measured_fact() const {
    if (s_.lengths_files.size() == 1) return file_fact("Measured lengths", s_.lengths_files.front().file);
    return fact("Measured lengths", fmt::format("{} files", s_.lengths_files.size()));
  }

  Notice status() const {
    const bool serious = std::ranges::any_of(found_.findings, &VolumetricFinding::serious);
    const std::size_t told = volumetric::error_names().size() - found_.model.unseen_errors().size();
    return {serious ? Tone::caution : Tone::good,
            plain(fmt::format("{} of 21 errors found from {} lengths", told, s_.lengths.readings.size())),
            serious ? std::vector<RichText>{plain("Read the findings before the result is used.")}
                    : std::vector<RichText>{}};
  }

  std::string curves_text() const {
    std::string text;
    for (std::size_t a = 0; a < axis_count; ++a) {
      const CurveBasis& basis = found_.model.coefficients().basis(a);
      text += fmt::format("{}{} {}", a == 0 ? "" : ", ", "XYZ"[a], basis.size());
    }
    switch (found_.model.coefficients().basis(0).kind()) {
      case CurveKind::spline: return fmt::format("cubic B-splines, spans: {}", text);
      case CurveKind::legendre: return fmt::format("Legendre polynomials, degree: {}", text);
      case CurveKind::nodes: return fmt::format("straight lines between nodes, spans: {}", text);
    }
    return text;
  }

  /// Straightness depends on them.
  Fact functional_points() const {
    const volumetric::MachineModel& machine = found_.model.machine();
    if (volumetric::is_at_machine_zero(machine)) return fact("Functional points of the axes", "the machine's zero");
    std::string text;
    for (std::size_t a = 0; a < axis_count; ++a) {
      const Vector3& c = machine.functional_point_mm[a];
      text += fmt::format("{}{} ({}; {}; {})", a == 0 ? "" : ", ", "XYZ"[a], number(c.x, 3), number(c.y, 3),
                          number(c.z, 3));
    }
    return {plain("Functional points of the axes, x; y; z in mm"), verbatim_cell(text)};
  }

  Section result_section() const {
    const VolumetricRank& rank = found_.rank;
    Facts facts{"", {}};
    facts.facts = {{plain("Kinematic chain"), verbatim_cell(s_.machine.chain.text())},
                   functional_points(),
                   fact("Curves", curves_text()),
                   fact("Unknowns", fmt::format("{}, of which {} are of errors", rank.unknowns, rank.errors)),
                   fact("Directions of which the lengths say nothing", fmt::format("{}", rank.null_directions)),
                   fact("χ²/ν", found_.degrees_of_freedom == 0
                                    ? std::string("no redundancy")
                                    : fmt::format("{} with ν = {}", number(found_.chi_squared_per_dof(), 3),
                                                  found_.degrees_of_freedom)),
                   fact("Readings set aside", fmt::format("{}", found_.set_aside.size())),
                   fact("Breaks of the beam found", fmt::format("{}", found_.breaks.size()))};
    return {"result", "Result", true, {std::move(facts)}};
  }

  Section findings_section() const {
    Section section{"findings", "Findings", false, {}};
    if (found_.findings.empty()) {
      section.blocks.emplace_back(Paragraph{plain("No findings: nothing speaks against the result.")});
      return section;
    }
    section.blocks.emplace_back(finding_table(found_.findings));
    return section;
  }

  Section squareness_section() const {
    constexpr std::array<std::string_view, 3> meaning = {"Y to X", "Z to X", "Z to Y"};
    Table table;
    table.columns = {{plain("Error"), Align::start, true},
                     {plain("Squareness"), Align::start},
                     {plain("Value / µrad"), Align::decimal},
                     {joined({italic("u"), plain(" / µrad")}), Align::decimal}};
    for (std::size_t k = 0; k < 3; ++k) {
      const auto value = found_.model.squareness(static_cast<Squareness>(k));
      table.rows.push_back({verbatim_cell(volumetric::squareness_names[k]), text_cell(meaning[k]),
                            value ? cell(value->value, 2) : text_cell("not told"),
                            value ? cell(value->u, 2) : text_cell("–")});
    }
    return {"squareness", "Squareness", true, {std::move(table)}};
  }

  Section motions_section() const {
    Table table;
    table.columns = {{plain("Error"), Align::start, true},
                     {plain("Kind"), Align::start},
                     {plain("Unit"), Align::start},
                     {plain("Largest"), Align::decimal},
                     {plain("Spread"), Align::decimal},
                     {joined({italic("u"), plain(", mean")}), Align::decimal},
                     {joined({italic("u"), plain(", largest")}), Align::decimal}};
    for (std::size_t a = 0; a < axis_count; ++a)
      for (std::size_t m = 0; m < motion_count; ++m) {
        const ErrorMotion error{a, m};
        const std::vector<CurveNode> nodes = volumetric::curve_nodes(found_.model, error);
        auto& row = table.rows.emplace_back();
        row = {verbatim_cell(volumetric::error_name(error)), text_cell(volumetric::error_kind(error)),
               text_cell(error.is_rotation() ? "µrad" : "µm")};
        if (nodes.empty()) {
          row.push_back(text_cell("not told"));
          for (int k = 0; k < 3; ++k) row.push_back(text_cell("–"));
          continue;
        }
        const CurveSummary s = summary_of(nodes);
        for (const double x : {s.largest, s.range, s.u_mean, s.u_largest}) row.push_back(cell(x, 2));
      }
    table.notes = {plain("Standard uncertainties (k = 1). The mean of each function over its range is 0, and the best "
                         "straight line of straightness is level."),
                   joined({plain("The straightness of an axis is that of the tool point for the chain "),
                           verbatim(s_.machine.chain.text()),
                           plain(", with each axis' functional point as stated in the result; for another chain it "
                                 "would be other numbers.")})};
    table.dense = true;
    return {"motions", "Error motions", true, {std::move(table)}};
  }

  Section curves_section() const {
    Section section{"curves", "Error motions over the travel", true, {}};
    for (std::size_t a = 0; a < axis_count; ++a)
      section.blocks.emplace_back(error_motion_figure(found_.model, a, options_));
    return section;
  }

  Section residuals_section() const {
    Section section{"residuals", "Residuals", false, {}};
    section.blocks.emplace_back(volumetric_residual_figure(s_.lengths, found_, options_));
    std::vector<bool> aside(found_.residuals_um.size(), false);
    for (const volumetric::SetAside& reading : found_.set_aside) aside[reading.reading] = true;
    std::vector<double> normalised;
    for (std::size_t i = 0; i < aside.size(); ++i)
      if (!aside[i]) normalised.push_back(found_.residuals_um[i] / found_.sigmas_um[i]);
    if (auto figure = residual_figure(normalised, options_)) section.blocks.emplace_back(std::move(*figure));
    return section;
  }

  Section station_section() const {
    Table table;
    const bool scales = found_.part_scales && found_.part_scales->held;
    table.groups = {{{}, 2}, {plain("Place / mm"), 3}, {{}, scales ? 4u : 2u}};
    table.columns = {{plain("Station"), Align::start, true}, {plain("Tool"), Align::start}};
    for (const char* axis : {"X", "Y", "Z"}) table.columns.push_back({plain(axis), Align::decimal});
    table.columns.push_back({plain("Readings"), Align::decimal});
    table.columns.push_back({plain("rms / µm"), Align::decimal});
    if (scales) {
      table.columns.push_back({plain("Scale / µm/m"), Align::decimal});
      table.columns.push_back({joined({italic("u"), plain(" / µm/m")}), Align::decimal});
      table.notes.push_back(
          plain("Scale: how much longer the axes seemed with this station and tool, as where the "
                "machine or the air was warmer or colder. It is taken out of the errors."));
    }
    for (const IdentifiedStation& station : found_.stations) {
      auto& row = table.rows.emplace_back();
      row = {verbatim_cell(s_.lengths.stations[station.station]), verbatim_cell(s_.lengths.tools[station.tool])};
      for (std::size_t k = 0; k < 3; ++k) row.push_back(cell(station.at_mm[k], 4));
      row.push_back(text_cell(fmt::format("{}", station.readings)));
      row.push_back(cell(station.rms_um, 3));
      if (scales && station.scale_um_per_m) {
        row.push_back(cell(*station.scale_um_per_m, 2));
        row.push_back(cell(*station.scale_u_um_per_m, 2));
      } else if (scales) {
        for (int k = 0; k < 2; ++k) row.push_back(text_cell("–"));
      }
    }
    table.dense = true;
    return {"stations", "Stations", true, {std::move(table)}};
  }

  Section method() const {
    std::string text = fmt::format(
        "The errors, the places of the stations and the dead paths are those that minimise the weighted squares of the "
        "residuals of all lengths. Weights follow U = {} µm + {} µm/m · L (k = 2)",
        shown_short(s_.machine.ranging.constant.in_um(), options_),
        shown_short(s_.machine.ranging.per_length.in_um_per_m(), options_));
    if (s_.machine.repeatability.in_um() > 0.0)
      text += fmt::format(" and a repeatability of the machine of {} µm (k = 1)",
                          shown_short(s_.machine.repeatability.in_um(), options_));
    text +=
        ". Each station has a place of its own with each tool, so that a wrong offset of a tool enters as a lever "
        "alone. "
        "Covariances are multiplied by χ²/ν where that is above 1.";
    if (s_.found.part_scales && s_.found.part_scales->held)
      text +=
          " Each part has a scale of its own, normal with a share of its variance, which the lengths tell, "
          "common to the parts of a station; what the lengths leave open of it is in all uncertainties.";
    if (s_.found.smoothed)
      text +=
          " To the squares of the residuals are added those of how far curves bend, over what the findings say of it: "
          "both together are least.";
    return {"method", "Method", false, {Paragraph{plain(text)}}};
  }

  Section source() const {
    Section section{"provenance", "Provenance", false, {}};
    Facts facts{"", {}};
    const bool as_table = s_.lengths_files.size() > 1 || has_recordings();
    if (!as_table) add_file(facts, "Lengths", s_.lengths_files.front().file, s_.lengths_files.front().sha256);
    add_file(facts, "Machine", s_.machine_file, s_.machine_sha256);
    if (!s_.plan_file.empty() && s_.plan_file != s_.machine_file) add_file(facts, "Plan", s_.plan_file, s_.plan_sha256);
    if (as_table) section.blocks.emplace_back(files_table());
    section.blocks.emplace_back(std::move(facts));
    return section;
  }

  void add_file(Facts& facts, std::string_view name, const std::string& file, const std::string& sha256) const {
    facts.facts.push_back(file_fact(name, file));
    facts.facts.push_back({plain("SHA-256"), verbatim_cell(sha256)});
  }

  Table files_table() const {
    Table table;
    table.columns = {{plain("Lengths"), Align::start, true},
                     {plain("Kind"), Align::start},
                     {plain("Part of the plan"), Align::start},
                     {plain("Found"), Align::decimal},
                     {plain("SHA-256"), Align::start, false, true}};
    for (const VolumetricLengthsFile& f : s_.lengths_files)
      table.rows.push_back(
          {file_cell(f.file), text_cell(f.parts.empty() ? "table" : "continuous recording"),
           f.parts.empty() ? text_cell("–") : verbatim_cell(f.parts),
           text_cell(f.parts.empty() ? fmt::format("{}", f.lengths) : fmt::format("{} of {}", f.lengths, f.planned)),
           verbatim_cell(f.sha256)});
    if (has_recordings())
      table.notes.push_back(
          plain("Lengths out of continuous recordings are means over the rests that were matched to the points of the "
                "plan."));
    table.dense = true;
    return table;
  }

  const VolumetricSubject& s_;
  const Identification& found_;
  const Options& options_;
};

}  // namespace

Document compose(const VolumetricSubject& subject, const Options& options) {
  return VolumetricComposition(subject, options).compose();
}

}  // namespace axiometry::report
