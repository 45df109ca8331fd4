// SPDX-License-Identifier: Apache-2.0
#include "axiometry/formats/volumetric/volumetric_plan_json.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

#include "axiometry/base/text/number_text.h"
#include "axiometry/base/text/text.h"
#include "axiometry/formats/plan/plan_json.h"
#include "axiometry/formats/plan/tracking_plan_json.h"
#include "axiometry/formats/test/test_schema.h"
#include "axiometry/formats/text/json_members.h"
#include "axiometry/formats/text/text_source.h"
#include "axiometry/formats/volumetric/machine_json.h"

namespace axiometry::formats {
namespace {

using json::Kind;
using json::Value;
using volumetric::CalibrationPlan;
using volumetric::MachineModel;
using volumetric::PlannedRun;
using volumetric::PlannedStop;

constexpr std::size_t planned_stops_most = 1'000'000;
constexpr double travel_slack_mm = 0.01;
constexpr double feed_most = 1e6;
constexpr double dwell_most_s = 3600.0;

Result<Vector3> stop_place(const Value& value, std::string_view what, const MachineModel& machine) {
  AXIOMETRY_TRY(const Vector3 at, vector_in(value, what));
  for (std::size_t a = 0; a < 3; ++a)
    if (!(at[a] >= machine.travel.lowest_mm[a] - travel_slack_mm &&
          at[a] <= machine.travel.highest_mm[a] + travel_slack_mm))
      return fail(
          fmt::format("found {} at {} mm, expected it within its travel of {} to {} mm", "XYZ"[a], format_exact(at[a]),
                      format_exact(machine.travel.lowest_mm[a]), format_exact(machine.travel.highest_mm[a])),
          value.at());
  return at;
}

Result<PlannedStop> stop_from(const Value& value, const MachineModel& machine) {
  AXIOMETRY_TRY(JsonMembers members, JsonMembers::of(value, "stop"));
  PlannedStop stop;
  AXIOMETRY_TRY(const Value* at, members.required("at_mm"));
  AXIOMETRY_TRY(stop.axes_mm, stop_place(*at, "at_mm", machine));
  if (const Value* over = members.optional("over_mm")) {
    AXIOMETRY_TRY(const auto* items, items_in(*over, "over_mm"));
    for (const Value& item : *items) {
      AXIOMETRY_TRY(stop.over_mm.emplace_back(), stop_place(item, "over_mm", machine));
    }
  }
  if (const Value* kept = members.optional("beam_kept")) {
    if (!kept->is(Kind::boolean))
      return fail(fmt::format("found {} for beam_kept, expected true or false", json::kind_name(kept->kind())),
                  kept->at());
    stop.beam_kept = kept->boolean();
  }
  AXIOMETRY_TRY_VOID(members.finish());
  return stop;
}

/// The place of a name among those that the machine has.
template <typename Named>
Result<std::size_t> named(const std::vector<Named>& list, const Value& value, std::string_view what) {
  AXIOMETRY_TRY(const std::string name, text_in(value, what));
  const auto at = std::ranges::find(list, name, &Named::name);
  if (at != list.end()) return static_cast<std::size_t>(at - list.begin());
  std::vector<std::string_view> known;
  for (const Named& item : list) known.push_back(item.name);
  return fail(
      fmt::format("found the {} {}, expected one of the machine: {}", what, text::quoted(name), fmt::join(known, ", ")),
      value.at());
}

Result<PlannedRun> run_from(const Value& value, const CalibrationPlan& plan) {
  AXIOMETRY_TRY(JsonMembers members, JsonMembers::of(value, "run"));
  PlannedRun run;
  AXIOMETRY_TRY(const Value* station, members.required("station"));
  AXIOMETRY_TRY(run.station, named(plan.machine.stations, *station, "station"));
  AXIOMETRY_TRY(const Value* tool, members.required("tool"));
  AXIOMETRY_TRY(run.tool, named(plan.machine.tools, *tool, "tool"));
  if (std::ranges::any_of(plan.runs,
                          [&](const PlannedRun& r) { return r.station == run.station && r.tool == run.tool; }))
    return fail("found a run of this station with this tool a second time, expected each once", value.at());
  AXIOMETRY_TRY(const Value* stops, members.required("stops"));
  AXIOMETRY_TRY(const auto* items, items_in(*stops, "stops"));
  for (const Value& item : *items) {
    AXIOMETRY_TRY(PlannedStop stop, stop_from(item, plan.machine));
    run.stops.push_back(std::move(stop));
  }
  AXIOMETRY_TRY_VOID(members.finish());
  return run;
}

/// Limits and obstacles, which a tracking plan's set-up has too.
Result<void> take_surroundings(JsonMembers& members, CalibrationPlan& plan) {
  Value setup = tracking_setup_value({plan.machine.travel, {}, {}, {}, {}, {}});
  Value wanted = object({{"travel", *setup.find("travel")}, {"station", *setup.find("station")}});
  for (const std::string_view name : {"limits", "obstacles"})
    if (const Value* value = members.optional(name)) wanted.add(name, *value);
  AXIOMETRY_TRY(TrackingSetup read, tracking_setup_from(wanted));
  plan.limits = read.limits;
  plan.obstacles = std::move(read.obstacles);
  return {};
}

Result<double> positive(JsonMembers& members, std::string_view name, double usual, double most) {
  double number = usual;
  AXIOMETRY_TRY_VOID(members.take(name, number));
  if (number > 0.0 && number <= most) return number;
  return fail(
      fmt::format("found {} of {}, expected one above 0 and up to {}", name, format_exact(number), format_exact(most)),
      members.optional(name)->at());
}

Value stop_value(const PlannedStop& stop) {
  Value value = object({{"at_mm", vector_value(stop.axes_mm)}});
  if (!stop.over_mm.empty()) {
    Value& over = value.add("over_mm", Value::array());
    for (const Vector3& at : stop.over_mm) over.push(vector_value(at));
  }
  if (!stop.beam_kept) value.add("beam_kept", false);
  return value;
}

}  // namespace

Result<void> take_circumstances(JsonMembers& members, CalibrationPlan& plan) {
  AXIOMETRY_TRY_VOID(members.take("date", plan.date));
  if (const Value* date = members.optional("date")) AXIOMETRY_TRY_VOID(placed(check_plan_date(plan.date), date->at()));
  AXIOMETRY_TRY_VOID(take_surroundings(members, plan));
  AXIOMETRY_TRY(plan.feed_mm_per_min, positive(members, "feed_mm_per_min", plan.feed_mm_per_min, feed_most));
  AXIOMETRY_TRY(const double dwell, positive(members, "dwell_s", plan.dwell.in_s(), dwell_most_s));
  plan.dwell = Duration::s(dwell);
  return {};
}

Result<CalibrationPlan> volumetric_plan_from(const Value& root) {
  AXIOMETRY_TRY(JsonMembers members, JsonMembers::of(root, "plan of a volumetric calibration"));
  AXIOMETRY_TRY(const Value* format, members.required("format"));
  if (!format->is(Kind::text) || format->text() != volumetric_plan_format_name)
    return fail(fmt::format("found another \"format\", expected \"{}\"", volumetric_plan_format_name), format->at());
  AXIOMETRY_TRY(const Value* machine, members.required("machine"));
  AXIOMETRY_TRY(MachineFile file, machine_from(*machine));
  CalibrationPlan plan{.machine = std::move(file.machine)};
  AXIOMETRY_TRY_VOID(take_circumstances(members, plan));
  AXIOMETRY_TRY(const Value* runs, members.required("runs"));
  AXIOMETRY_TRY(const auto* items, items_in(*runs, "runs"));
  if (items->empty()) return fail("found no run, expected one for each station and tool", runs->at());
  std::size_t stops = 0;
  for (const Value& item : *items) {
    AXIOMETRY_TRY(PlannedRun run, run_from(item, plan));
    stops += run.stops.size();
    plan.runs.push_back(std::move(run));
  }
  if (stops > planned_stops_most)
    return fail(fmt::format("found {} stops, expected at most {}", stops, planned_stops_most), runs->at());
  for (std::string_view name : {"$schema", "program", "version"}) members.pass_over(name);
  AXIOMETRY_TRY_VOID(members.finish());
  return plan;
}

Value volumetric_plan_value(const CalibrationPlan& plan) {
  Value root = object({{"format", volumetric_plan_format_name}});
  if (!plan.date.empty()) root.add("date", plan.date);
  root.add("machine", machine_value(plan.machine));
  const Value setup = tracking_setup_value({plan.machine.travel, {}, {}, plan.limits, {}, plan.obstacles});
  root.add("limits", *setup.find("limits"));
  root.add("obstacles", *setup.find("obstacles"));
  root.add("feed_mm_per_min", plan.feed_mm_per_min);
  root.add("dwell_s", plan.dwell.in_s());
  Value& runs = root.add("runs", Value::array());
  for (const PlannedRun& run : plan.runs) {
    Value& item = runs.push(
        object({{"station", plan.machine.stations[run.station].name}, {"tool", plan.machine.tools[run.tool].name}}));
    Value& stops = item.add("stops", Value::array());
    for (const PlannedStop& stop : run.stops) stops.push(stop_value(stop));
  }
  return root;
}

std::string write_volumetric_plan(const CalibrationPlan& plan) {
  return json::dump(volumetric_plan_value(plan)) + "\n";
}

bool is_volumetric_plan(std::string_view bytes) { return stated_format(bytes) == volumetric_plan_format_name; }

Result<CalibrationPlan> read_volumetric_plan(std::string_view bytes) {
  AXIOMETRY_TRY(const std::string_view text, utf8_text(bytes));
  AXIOMETRY_TRY(const Value root, json::parse(text));
  return volumetric_plan_from(root);
}

}  // namespace axiometry::formats
