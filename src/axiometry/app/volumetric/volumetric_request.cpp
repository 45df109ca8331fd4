// SPDX-License-Identifier: Apache-2.0
#include "axiometry/app/volumetric/volumetric_request.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <numeric>
#include <set>
#include <utility>

#include "axiometry/app/files/given_text.h"
#include "axiometry/app/files/request_members.h"
#include "axiometry/app/files/whole_file.h"
#include "axiometry/app/plan/plan.h"
#include "axiometry/base/counted.h"
#include "axiometry/base/text/number_text.h"
#include "axiometry/base/text/text.h"
#include "axiometry/formats/text/json_members.h"
#include "axiometry/formats/volumetric/machine_json.h"
#include "axiometry/formats/volumetric/volumetric_plan_json.h"
#include "axiometry/formats/volumetric/volumetric_result_json.h"
#include "axiometry/volumetric/field/tool_fields.h"

namespace axiometry::app {
namespace {

using formats::JsonMembers;
using json::Kind;
using json::Value;
using volumetric::CalibrationPlan;
using volumetric::ErrorModel;
using volumetric::MachineModel;

constexpr double most_points = 500, most_stations = 8, most_nodes = 21, most_table_nodes = 401;
constexpr std::size_t most_tools_planned = 6, most_points_in_all = 12'000, most_solids = 20;
constexpr std::size_t most_tools_found = 16, most_visits = 200, most_segments = 1000, most_coefficients = 1500;
constexpr std::size_t most_spans_of_axes = 240;  // cubic: 6 (240 + 9) + 3 coefficients

Result<void> check_count(std::string_view what, std::size_t count, std::size_t most) {
  if (count <= most) return {};
  return fail(fmt::format("found {} {}, expected at most {}", count, what, most));
}

Result<void> check_names(const MachineModel& machine) {
  AXIOMETRY_TRY_VOID(given_line("the name of the machine", machine.name));
  for (const auto& tool : machine.tools) AXIOMETRY_TRY_VOID(given_line("the name of a tool", tool.name));
  for (const auto& station : machine.stations) AXIOMETRY_TRY_VOID(given_line("the name of a station", station.name));
  return {};
}

Result<void> check_plan_size(const CalibrationPlan& plan) {
  AXIOMETRY_TRY_VOID(check_names(plan.machine));
  AXIOMETRY_TRY_VOID(check_count("tools", plan.machine.tools.size(), most_tools_planned));
  AXIOMETRY_TRY_VOID(check_count("stations", plan.machine.stations.size(), static_cast<std::size_t>(most_stations)));
  AXIOMETRY_TRY_VOID(check_count("obstacles", plan.obstacles.size(), most_solids));
  for (const Obstacle& obstacle : plan.obstacles)
    AXIOMETRY_TRY_VOID(given_line("the name of an obstacle", obstacle.name));
  std::size_t points = 0;
  for (const auto& run : plan.runs) points += run.stops.size();
  return check_count("points in all runs", points, most_points_in_all);
}

/// {"X": [a, b], "Y": …, "Z": …}.
Result<TravelBox> box_in(const Value& value, std::string_view what) {
  AXIOMETRY_TRY(JsonMembers members, JsonMembers::of(value, std::string(what)));
  TravelBox box;
  for (std::size_t a = 0; a < 3; ++a) {
    AXIOMETRY_TRY(const Value* ends, members.required(std::string_view("XYZ").substr(a, 1)));
    AXIOMETRY_TRY(const auto* items, formats::items_in(*ends, what));
    if (items->size() != 2)
      return fail(fmt::format("{}: found {}, expected two ends", what, counted(items->size(), "number")), ends->at());
    AXIOMETRY_TRY(box.lowest_mm[a], formats::number_in((*items)[0], what));
    AXIOMETRY_TRY(box.highest_mm[a], formats::number_in((*items)[1], what));
    if (!(box.lowest_mm[a] <= box.highest_mm[a]))
      return fail(fmt::format("{}: found ends that fall, expected the lower one first", what), ends->at());
  }
  AXIOMETRY_TRY_VOID(members.finish());
  return box;
}

Result<void> take_layout(JsonMembers& members, PlanVolumeRequest& request) {
  bool propose = true;
  if (members.optional("propose_stations") != nullptr) {
    AXIOMETRY_TRY_VOID(take_switch(members, "propose_stations", propose));
    request.propose_stations = propose;
  }
  AXIOMETRY_TRY(const auto stations, whole_member(members, "stations", {1, most_stations}));
  AXIOMETRY_TRY(const auto points, whole_member(members, "points", {1, most_points}));
  if (stations) request.options.stations = static_cast<std::size_t>(*stations);
  if (points) request.options.points = static_cast<std::size_t>(*points);
  if (const Value* room = members.optional("room_mm")) {
    AXIOMETRY_TRY(request.options.room, box_in(*room, "room_mm"));
  }
  return {};
}

Result<void> check_lengths_size(const volumetric::VolumetricLengths& lengths) {
  std::set<std::pair<std::size_t, std::size_t>> visits;
  std::set<std::array<std::size_t, 3>> segments;
  for (const auto& reading : lengths.readings) {
    visits.emplace(reading.station, reading.tool);
    segments.insert({reading.station, reading.tool, reading.segment});
  }
  AXIOMETRY_TRY_VOID(check_count("stations with a tool", visits.size(), most_visits));
  return check_count("segments", segments.size(), most_segments);
}

Result<void> check_model(const ErrorModel& model) {
  AXIOMETRY_TRY_VOID(check_names(model.machine()));
  AXIOMETRY_TRY_VOID(check_count("tools", model.machine().tools.size(), most_tools_found));
  return check_count("coefficients", model.coefficients().raw(), most_coefficients);
}

}  // namespace

Result<volumetric::PlannedCalibration> requested_calibration(const Value& body, std::stop_token stop) {
  AXIOMETRY_TRY(JsonMembers members, JsonMembers::of(body, "body"));
  AXIOMETRY_TRY(const Value* machine, members.required("machine"));
  AXIOMETRY_TRY(formats::MachineFile file, formats::machine_from(*machine));
  CalibrationPlan said{.machine = file.machine};
  PlanVolumeRequest request;
  AXIOMETRY_TRY_VOID(take_layout(members, request));
  AXIOMETRY_TRY_VOID(formats::take_circumstances(members, said));
  AXIOMETRY_TRY_VOID(members.finish());
  const bool proposes = request.propose_stations.value_or(file.machine.stations.empty());
  AXIOMETRY_TRY_VOID(check_plan_size(said));
  const std::size_t stations = proposes ? request.options.stations : file.machine.stations.size();
  AXIOMETRY_TRY_VOID(check_count("points in all runs", stations * file.machine.tools.size() * request.options.points,
                                 most_points_in_all));
  AXIOMETRY_TRY(request.date, plan_date(said.date));
  request.limits = said.limits;
  request.obstacles = std::move(said.obstacles);
  request.feed_mm_per_min = said.feed_mm_per_min;
  request.dwell = said.dwell;
  request.machine = "machine";
  request.options.stop = std::move(stop);
  return plan_volume(std::move(file), request);
}

Result<CalibrationPlan> given_calibration(const Value& body) {
  const Value* given = body.is(Kind::object) ? body.find("plan") : nullptr;
  if (given == nullptr) return fail("found no plan, expected one", body.at());
  AXIOMETRY_TRY(CalibrationPlan plan, formats::volumetric_plan_from(*given));
  AXIOMETRY_TRY_VOID(check_plan_size(plan));
  return plan;
}

Result<IdentifiedMachine> identify_presentable(const IdentifyFiles& files, const IdentifyChoices& choices) {
  if (files.machine) {
    const GivenFile& own = *files.machine;
    AXIOMETRY_TRY(const formats::MachineFile file, in_file(formats::read_machine(own.bytes), own.name));
    AXIOMETRY_TRY_VOID(in_file(check_names(file.machine), own.name));
    AXIOMETRY_TRY_VOID(in_file(check_count("tools", file.machine.tools.size(), most_tools_found), own.name));
  }
  if (files.plan) {
    AXIOMETRY_TRY(const CalibrationPlan plan,
                  in_file(formats::read_volumetric_plan(files.plan->bytes), files.plan->name));
    AXIOMETRY_TRY_VOID(in_file(check_plan_size(plan), files.plan->name));
  }
  const auto& sizes = choices.model.sizes;
  AXIOMETRY_TRY_VOID(
      check_count("spans", std::accumulate(sizes.begin(), sizes.end(), std::size_t{0}), most_spans_of_axes));
  IdentifyChoices in_one_thread = choices;
  in_one_thread.model.threads = 1;
  const std::string name = files.lengths.size() == 1 ? files.lengths.front().name : std::string();
  return identify_lengths(files, in_one_thread, [&](const volumetric::VolumetricLengths& lengths) -> Result<void> {
    const Result<void> small = check_lengths_size(lengths);
    return name.empty() ? small : in_file(small, name);
  });
}

Result<Assembled> assemble_presentable(const AssembleFiles& files, const Value& options) {
  const GivenFile& own = files.machine;
  AXIOMETRY_TRY(const formats::MachineFile machine, in_file(formats::read_machine(own.bytes), own.name));
  AXIOMETRY_TRY_VOID(in_file(check_names(machine.machine), own.name));
  AXIOMETRY_TRY_VOID(in_file(check_count("tools", machine.machine.tools.size(), most_tools_found), own.name));
  AXIOMETRY_TRY(AssembleRequest request, assemble_request_from(options, files));
  request.stop = files.stop;
  return assemble_singles(request);
}

Result<ErrorModel> given_model(const Value& body, std::string_view name) {
  const Value* given = body.is(Kind::object) ? body.find(name) : nullptr;
  if (given == nullptr) return fail(fmt::format("found no {}, expected that of a result", name), body.at());
  AXIOMETRY_TRY(ErrorModel model, formats::error_model_from(*given));
  AXIOMETRY_TRY_VOID(check_model(model));
  return model;
}

Result<std::size_t> given_nodes(const Value& body) {
  AXIOMETRY_TRY(JsonMembers members, JsonMembers::of(body, "body"));
  for (const std::string_view known : {"model", "findings", "remarks", "before", "findings_before", "remarks_before",
                                       "after", "findings_after", "remarks_after"})
    members.pass_over(known);
  AXIOMETRY_TRY(const auto nodes, whole_member(members, "nodes", {2, most_nodes}));
  AXIOMETRY_TRY_VOID(members.finish());
  return nodes ? static_cast<std::size_t>(*nodes) : volumetric::field_nodes;
}

Result<PredictRequest> line_request_from(const Value& body) {
  AXIOMETRY_TRY(JsonMembers members, JsonMembers::of(body, "body"));
  PredictRequest request;
  for (const std::string_view known : {"model", "findings", "remarks"}) members.pass_over(known);
  AXIOMETRY_TRY_VOID(members.take("axis", request.axis));
  AXIOMETRY_TRY_VOID(members.take("diagonal", request.diagonal));
  AXIOMETRY_TRY_VOID(members.take("tool", request.tool));
  if (const Value* at = members.optional("at_mm")) {
    AXIOMETRY_TRY(const Vector3 place, formats::vector_in(*at, "at_mm"));
    for (std::size_t a = 0; a < 3; ++a)  // of the axis itself it says nothing
      if (!request.axis.empty() && request.axis != std::string_view("XYZ").substr(a, 1))
        request.at += fmt::format("{}{}={}", request.at.empty() ? "" : ",", "xyz"[a], format_exact(place[a]));
  }
  AXIOMETRY_TRY_VOID(members.finish());
  return request;
}

Result<ExportRequest> table_request_from(const Value& body) {
  AXIOMETRY_TRY(JsonMembers members, JsonMembers::of(body, "body"));
  ExportRequest request;
  for (const std::string_view known : {"model", "findings", "remarks"}) members.pass_over(known);
  AXIOMETRY_TRY_VOID(members.take("table", request.table));
  AXIOMETRY_TRY_VOID(members.take("tool", request.tool));
  AXIOMETRY_TRY(const auto nodes, whole_member(members, "nodes", {2, most_table_nodes}));
  AXIOMETRY_TRY_VOID(members.finish());
  if (nodes) request.nodes = static_cast<std::size_t>(*nodes);
  return request;
}

}  // namespace axiometry::app
