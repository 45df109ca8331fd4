// SPDX-License-Identifier: Apache-2.0
#include "axiometry/app/volumetric/plan_volume.h"

#include <fmt/format.h>

#include <iterator>
#include <utility>

#include "axiometry/app/files/whole_file.h"
#include "axiometry/app/results/named_findings_json.h"
#include "axiometry/app/results/result_json.h"
#include "axiometry/app/volumetric/rank_json.h"
#include "axiometry/base/text/number_text.h"
#include "axiometry/base/text/text.h"
#include "axiometry/formats/text/json_members.h"
#include "axiometry/formats/volumetric/machine_json.h"
#include "axiometry/formats/volumetric/volumetric_lengths_csv.h"
#include "axiometry/formats/volumetric/volumetric_plan_json.h"
#include "axiometry/volumetric/field/unseen_reasons.h"

namespace axiometry::app {
namespace {

using formats::vector_value;
using json::Value;
using volumetric::CalibrationPlan;
using volumetric::ExpectedError;
using volumetric::ExpectedTool;
using volumetric::PlannedCalibration;
using volumetric::PlannedRun;
using volumetric::VolumetricFinding;

Value or_nothing(const std::optional<double>& number) { return number ? Value(*number) : Value(); }

std::string or_dash(const std::optional<double>& number) { return number ? format_fixed(*number, 2) : "-"; }

Value volume_value(const PlannedCalibration& planned) {
  Value volume = Value::object();
  volume.add("u_rms_um", or_nothing(planned.expected.u_rms_um));
  volume.add("u_max_um", or_nothing(planned.expected.u_most_um));
  Value& tools = volume.add("tools", Value::object());
  for (const ExpectedTool& t : planned.expected.tools) {
    Value& item = tools.add(planned.plan.machine.tools[t.tool].name, Value::object());
    item.add("u_rms_um", or_nothing(t.u_rms_um));
    item.add("u_max_um", or_nothing(t.u_most_um));
  }
  return volume;
}

}  // namespace

Result<PlannedCalibration> plan_volume(const PlanVolumeRequest& request) {
  AXIOMETRY_TRY(const std::string bytes, whole_file(request.machine));
  AXIOMETRY_TRY(formats::MachineFile file, in_file(formats::read_machine(bytes), request.machine));
  return plan_volume(std::move(file), request);
}

Result<PlannedCalibration> plan_volume(formats::MachineFile file, const PlanVolumeRequest& request) {
  volumetric::PlanOptions options = request.options;
  options.propose_stations = request.propose_stations.value_or(file.machine.stations.empty());
  CalibrationPlan plan{.date = request.date, .machine = std::move(file.machine)};
  plan.limits = request.limits;
  plan.obstacles = request.obstacles;
  if (request.feed_mm_per_min) plan.feed_mm_per_min = *request.feed_mm_per_min;
  if (request.dwell) plan.dwell = *request.dwell;
  AXIOMETRY_TRY(PlannedCalibration planned,
                in_file(volumetric::plan_calibration(std::move(plan), options), request.machine));
  for (std::string& remark : file.remarks)
    planned.findings.push_back({"volumetric-passed-over", false, std::move(remark)});
  return planned;
}

Value expectation_value(const PlannedCalibration& planned) {
  const auto names = volumetric::error_names();
  Value root = Value::object();
  Value& stations = root.add("stations", Value::object());
  for (const volumetric::NamedStation& s : planned.plan.machine.stations) stations.add(s.name, vector_value(s.at_mm));
  Value& runs = root.add("runs", Value::array());
  for (const PlannedRun& run : planned.plan.runs) {
    Value& item = runs.push(Value::object());
    item.add("station", planned.plan.machine.stations[run.station].name);
    item.add("tool", planned.plan.machine.tools[run.tool].name);
    item.add("points", run.stops.size());
  }
  root.add("points", planned.expected.readings);
  root.add("rank", to_json(planned.expected.rank));
  Value& unseen = root.add("unseen", Value::array());
  for (const std::size_t e : planned.expected.unseen) unseen.push(names[e]);
  Value& reasons = root.add("reasons", Value::array());
  for (const std::string& reason : planned.expected.reasons) reasons.push(reason);
  Value& errors = root.add("errors", Value::object());
  for (std::size_t e = 0; e < names.size(); ++e) {
    const ExpectedError& expected = planned.expected.errors[e];
    Value& item = errors.add(names[e], Value::object());
    item.add("u_mean", or_nothing(expected.u_mean));
    item.add("u_max", or_nothing(expected.u_most));
  }
  root.add("volume", volume_value(planned));
  root.add("findings", findings_value(planned.findings));
  root.add("program", program_to_json());
  return root;
}

std::string planned_points_csv(const CalibrationPlan& plan) {
  std::string table = fmt::format("{}\n", formats::volumetric_lengths_head);
  for (const PlannedRun& run : plan.runs) {
    std::size_t segment = 1;
    for (const volumetric::PlannedStop& stop : run.stops) {
      if (!stop.beam_kept) ++segment;
      fmt::format_to(std::back_inserter(table), "{},{},{},{},{},{},\n",
                     formats::name_cell(text::no_formula(plan.machine.stations[run.station].name)),
                     formats::name_cell(text::no_formula(plan.machine.tools[run.tool].name)), segment,
                     format_exact(stop.axes_mm.x), format_exact(stop.axes_mm.y), format_exact(stop.axes_mm.z));
    }
  }
  return table;
}

std::string expectation_text(const PlannedCalibration& planned) {
  const auto names = volumetric::error_names();
  const CalibrationPlan& plan = planned.plan;
  std::string text;
  const auto out = std::back_inserter(text);
  for (const volumetric::NamedStation& s : plan.machine.stations)
    fmt::format_to(out, "Station {}: X {:.0f}, Y {:.0f}, Z {:.0f} mm\n", s.name, s.at_mm.x, s.at_mm.y, s.at_mm.z);
  fmt::format_to(out, "{} points in {} runs of one station and tool each\n", planned.expected.readings,
                 plan.runs.size());
  fmt::format_to(out, "Rank {} of {}, condition {:.0f}\n\n",
                 planned.expected.rank.unknowns - planned.expected.rank.null_directions, planned.expected.rank.unknowns,
                 planned.expected.rank.condition);
  fmt::format_to(out, "Expected standard uncertainties (um, urad): mean, largest\n");
  for (std::size_t e = 0; e < names.size(); ++e)
    fmt::format_to(out, "{} {:>6} {:>6}{}", names[e], or_dash(planned.expected.errors[e].u_mean),
                   or_dash(planned.expected.errors[e].u_most), e % 3 == 2 ? "\n" : "   ");
  for (const ExpectedTool& t : planned.expected.tools)
    fmt::format_to(out, "Tool point {}: {} um rms, {} um at most\n", plan.machine.tools[t.tool].name,
                   or_dash(t.u_rms_um), or_dash(t.u_most_um));
  if (!planned.findings.empty()) text += "\n";
  for (const VolumetricFinding& f : planned.findings)
    fmt::format_to(out, "{}: {}\n", f.serious ? "serious" : "note", f.message);
  return text;
}

Result<bool> is_volumetric_plan_file(const std::string& file) {
  AXIOMETRY_TRY(const std::string bytes, whole_file(file));
  return formats::is_volumetric_plan(bytes);
}

}  // namespace axiometry::app
