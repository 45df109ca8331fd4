// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <algorithm>
#include <optional>
#include <string>

#include "axiometry/base/counted.h"
#include "axiometry/report/documents/volumetric_sections.h"
#include "axiometry/report/sections/fact.h"
#include "axiometry/report/sections/sections.h"
#include "axiometry/report/shown_number.h"
#include "axiometry/report/tracking.h"
#include "axiometry/report/translated.h"
#include "axiometry/report/volumetric.h"

namespace axiometry::report {
namespace {

using volumetric::CalibrationPlan;
using volumetric::Expectation;
using volumetric::ExpectedError;
using volumetric::NamedStation;
using volumetric::PlannedRun;
using volumetric::PlannedStop;
using volumetric::Tool;

class CalibrationSheet {
 public:
  CalibrationSheet(const volumetric::PlannedCalibration& planned, const Options& options)
      : planned_(planned), plan_(planned.plan), options_(options) {}

  Document compose() const {
    Document document;
    document.kind = "Test plan";
    document.title = plan_.machine.name.empty() ? "The 21 errors of the machine" : plan_.machine.name;
    document.edition = "ISO 230-1:2012, names of errors";
    document.running_head = translated(document.title, options_);
    document.running_status = "Test plan · " + document.edition;
    document.date = plan_.date;
    document.identity = {
        {plain("Machine"), plan_.machine.name.empty() ? quiet_cell("not stated") : verbatim_cell(plan_.machine.name)},
        {plain("Date of plan"), plan_.date.empty() ? quiet_cell("not stated") : verbatim_cell(plan_.date)}};
    document.status = {status()};
    if (!planned_.findings.empty())
      document.sections.push_back({"findings", "Findings", false, {finding_table(planned_.findings)}});
    document.sections.push_back({"runs", "Runs", false, {run_table()}});
    document.sections.push_back(setup_section());
    document.sections.push_back({"expected", "What the lengths will tell", false, {expected_facts(), error_table()}});
    return document;
  }

 private:
  std::string number(double x, int decimals) const { return format_fixed(x, decimals, options_.numbers); }
  std::string mm(double x) const { return shown_short(x, options_) + "\u00a0mm"; }
  std::string place(Vector3 v) const {
    return fmt::format("X {}, Y {}, Z {}", shown_short(v.x, options_), shown_short(v.y, options_),
                       shown_short(v.z, options_));
  }
  TableCell told(const std::optional<double>& u) const { return u ? text_cell(number(*u, 2)) : text_cell("not told"); }

  Notice status() const {
    const std::size_t told = volumetric::error_names().size() - planned_.expected.unseen.size();
    const bool serious = std::ranges::any_of(planned_.findings, &volumetric::VolumetricFinding::serious);
    return {serious ? Tone::caution : Tone::good,
            plain(fmt::format("{} of 21 errors will be told by {} lengths", told, planned_.expected.readings)),
            serious ? std::vector<RichText>{plain("Read the findings before the plan is measured.")}
                    : std::vector<RichText>{}};
  }

  Table run_table() const {
    Table table;
    table.columns = {{plain("Run number"), Align::decimal, true},
                     {plain("Station"), Align::start},
                     {plain("Tool"), Align::start},
                     {plain("Points"), Align::decimal},
                     {plain("Beam lost"), Align::decimal},
                     {plain("First point"), Align::start}};
    for (std::size_t k = 0; k < plan_.runs.size(); ++k) {
      const PlannedRun& run = plan_.runs[k];
      const auto lost = std::ranges::count_if(run.stops, [](const PlannedStop& stop) { return !stop.beam_kept; });
      table.rows.push_back({text_cell(fmt::format("{}", k + 1)),
                            verbatim_cell(plan_.machine.stations[run.station].name),
                            verbatim_cell(plan_.machine.tools[run.tool].name),
                            text_cell(fmt::format("{}", run.stops.size())), text_cell(fmt::format("{}", lost)),
                            run.stops.empty() ? text_cell("–") : text_cell(place(run.stops.front().axes_mm))});
    }
    table.notes = {
        plain("A run is one program: one station with one tool. Between programs the instrument is moved or the tool "
              "changed. "
              "Where the beam is lost the program stops until it is found again, and another segment begins.")};
    return table;
  }

  Section setup_section() const {
    Facts machine{"Machine", {}};
    machine.facts.push_back({plain("Kinematic chain"), verbatim_cell(plan_.machine.chain.text())});
    for (std::size_t k = 0; k < 3; ++k)
      machine.facts.push_back(fact(fmt::format("Travel of {}", "XYZ"[k]),
                                   fmt::format("{} to {}", shown_short(plan_.machine.travel.lowest_mm[k], options_),
                                               mm(plan_.machine.travel.highest_mm[k]))));
    return {"setup", "Set-up", false, {std::move(machine), tool_table(), station_table(), picture()}};
  }

  Table places_table(std::string_view head) const {
    Table table;
    table.columns = {{plain(head), Align::start, true}};
    for (const char* axis : {"X / mm", "Y / mm", "Z / mm"}) table.columns.push_back({plain(axis), Align::decimal});
    return table;
  }
  void add_place(Table& table, const std::string& name, Vector3 at) const {
    auto& row = table.rows.emplace_back();
    row = {verbatim_cell(name)};
    for (std::size_t k = 0; k < 3; ++k) row.push_back(text_cell(number(at[k], 1)));
  }
  Table tool_table() const {
    Table table = places_table("Tool");
    for (const Tool& tool : plan_.machine.tools) add_place(table, tool.name, tool.offset_mm);
    table.notes = {plain("From where the axes stand to the centre of the reflector.")};
    return table;
  }
  Table station_table() const {
    Table table = places_table("Station");
    for (const NamedStation& station : plan_.machine.stations) add_place(table, station.name, station.at_mm);
    table.notes = {plain(
        "In the coordinates of the reflector. The instrument need not stand there exactly: where it stood comes out of "
        "the lengths.")};
    return table;
  }

  Figure picture() const {
    Layout layout;
    TravelBox reach{plan_.machine.travel.lowest_mm + plan_.machine.tools.front().offset_mm,
                    plan_.machine.travel.highest_mm + plan_.machine.tools.front().offset_mm};
    for (const Tool& tool : plan_.machine.tools)
      for (std::size_t k = 0; k < 3; ++k) {
        reach.lowest_mm[k] = std::min(reach.lowest_mm[k], plan_.machine.travel.lowest_mm[k] + tool.offset_mm[k]);
        reach.highest_mm[k] = std::max(reach.highest_mm[k], plan_.machine.travel.highest_mm[k] + tool.offset_mm[k]);
      }
    layout.box = reach;
    for (const NamedStation& station : plan_.machine.stations) {
      layout.stations_mm.push_back(station.at_mm);
      layout.station_names.push_back(station.name);
    }
    layout.obstacles = plan_.obstacles;
    layout.title = "Layout of the test";
    layout.description = fmt::format("Reach of the reflector with all tools, and {}.",
                                     counted(plan_.machine.stations.size(), "station"));
    return layout_figure(layout, options_);
  }

  Facts expected_facts() const {
    const Expectation& expected = planned_.expected;
    Facts facts{"", {}};
    facts.facts.push_back(
        fact("Directions of which the lengths say nothing", fmt::format("{}", expected.rank.null_directions)));
    for (const volumetric::ExpectedTool& tool : expected.tools)
      facts.facts.push_back({plain(fmt::format("Tool point, {}", plan_.machine.tools[tool.tool].name)),
                             tool.u_rms_um
                                 ? text_cell(fmt::format("u = {} µm, at most {} µm", number(*tool.u_rms_um, 2),
                                                         number(tool.u_most_um.value_or(0.0), 2)))
                                 : text_cell("not told")});
    return facts;
  }

  Table error_table() const {
    Table table;
    table.columns = {{plain("Error"), Align::start, true},
                     {plain("Unit"), Align::start},
                     {joined({italic("u"), plain(", mean")}), Align::decimal},
                     {joined({italic("u"), plain(", largest")}), Align::decimal}};
    const auto names = volumetric::error_names();
    for (std::size_t e = 0; e < names.size(); ++e) {
      const ExpectedError& expected = planned_.expected.errors[e];
      const auto motion = volumetric::error_motion_named(names[e]);
      table.rows.push_back({verbatim_cell(names[e]), text_cell(motion && !motion->is_rotation() ? "µm" : "µrad"),
                            told(expected.u_mean), told(expected.u_most)});
    }
    table.notes = {
        plain("Standard uncertainties (k = 1), from the uncertainties that are stated of the instrument and the "
              "machine, where "
              "all parts are measured at one temperature.")};
    table.dense = true;
    return table;
  }

  const volumetric::PlannedCalibration& planned_;
  const CalibrationPlan& plan_;
  const Options& options_;
};

}  // namespace

Document calibration_sheet(const volumetric::PlannedCalibration& planned, const Options& options) {
  return CalibrationSheet(planned, options).compose();
}

}  // namespace axiometry::report
