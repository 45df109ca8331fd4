// SPDX-License-Identifier: Apache-2.0
#include "axiometry/app/tracking/tracking_request.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <string_view>

#include "axiometry/app/files/given_text.h"
#include "axiometry/app/files/request_members.h"
#include "axiometry/app/files/whole_file.h"
#include "axiometry/app/plan/plan.h"
#include "axiometry/app/plan/plan_request.h"
#include "axiometry/base/reading_limits.h"
#include "axiometry/base/text/number_text.h"
#include "axiometry/base/text/text.h"
#include "axiometry/formats/plan/tracking_plan_json.h"
#include "axiometry/formats/text/json_members.h"
#include "axiometry/model/aligned.h"

namespace axiometry::app {
namespace {

using formats::JsonMembers;
using json::Kind;
using json::Value;

constexpr std::size_t most_obstacles = 100, most_lines = 50;
constexpr std::size_t most_trials = 10'000'000;  // of all lines: a minute or so
constexpr double most_runs = 100, most_targets = 10'000;

Result<void> take_line(JsonMembers& members, std::string_view name, std::string& target) {
  AXIOMETRY_TRY_VOID(members.take(name, target));
  AXIOMETRY_TRY(target, given_line(name, target));
  return {};
}

Result<void> take_ids(JsonMembers& members, std::vector<std::string>& ids) {
  const Value* list = members.optional("lines");
  if (list == nullptr) return {};
  AXIOMETRY_TRY(const auto* items, formats::items_in(*list, "lines"));
  if (items->size() > most_lines)
    return fail(fmt::format("lines: found {} of them, expected at most {}", items->size(), most_lines), list->at());
  for (const Value& item : *items) {
    AXIOMETRY_TRY(std::string id, formats::text_in(item, "lines"));
    ids.push_back(std::move(id));
  }
  return {};
}

Result<void> take_rule(JsonMembers& members, tracking::DiagonalRule& rule) {
  std::string text = "equal";
  AXIOMETRY_TRY_VOID(members.take("rule", text));
  if (text != "equal" && text != "corner")
    return fail(fmt::format("found {}, expected equal or corner", text::quoted(text)), members.optional("rule")->at());
  if (text == "corner") rule = tracking::DiagonalRule::box_corner;
  return {};
}

/// [x, y, z], each a period or null.
Result<void> take_periods(JsonMembers& members, tracking::LinesRequest& lines) {
  const Value* list = members.optional("periods_mm");
  if (list == nullptr) return {};
  AXIOMETRY_TRY(const auto* items, formats::items_in(*list, "periods_mm"));
  if (items->size() != lines.periods.size())
    return fail(fmt::format("periods_mm: found {} of them, expected one of X, Y and Z each", items->size()),
                list->at());
  for (std::size_t k = 0; k < items->size(); ++k) {
    const Value& item = (*items)[k];
    if (item.is(Kind::null)) continue;
    AXIOMETRY_TRY(const double period, formats::number_in(item, "periods_mm"));
    if (!(period > 0.0))
      return fail(fmt::format("periods_mm: found {}, expected periods above 0", format_exact(period)), item.at());
    lines.periods[k] = Position::native(period);
  }
  return {};
}

/// How the lines are measured.
Result<void> take_programme(JsonMembers& members, tracking::LinesRequest& lines) {
  AXIOMETRY_TRY(const auto count, whole_member(members, "targets", {2, most_targets}));
  AXIOMETRY_TRY(const auto runs, whole_member(members, "runs", {1, most_runs}));
  AXIOMETRY_TRY(const auto warm_up, whole_member(members, "warm_up_runs", {0, most_runs}));
  AXIOMETRY_TRY(const auto seed, whole_member(members, "seed", {0, static_cast<double>(seed_limit - 1)}));
  if (count) lines.count = static_cast<std::size_t>(*count);
  if (runs) lines.runs = static_cast<std::size_t>(*runs);
  if (warm_up) lines.warm_up_runs = static_cast<std::size_t>(*warm_up);
  lines.seed = seed ? static_cast<std::uint64_t>(*seed) : drawn_seed();
  std::optional<double> overrun, dwell;
  AXIOMETRY_TRY_VOID(take_number(members, "overrun_mm", overrun));
  AXIOMETRY_TRY_VOID(take_number(members, "dwell_s", dwell));
  AXIOMETRY_TRY_VOID(take_number(members, "feed", lines.feed));
  AXIOMETRY_TRY_VOID(take_number(members, "acceleration", lines.acceleration));
  AXIOMETRY_TRY_VOID(members.take("step_mm", lines.step_mm));
  if (overrun) lines.overrun = Position::native(*overrun);
  if (dwell) lines.dwell = Duration::s(*dwell);
  return take_periods(members, lines);
}

Result<void> take_names(JsonMembers& members, tracking::LinesRequest& lines) {
  AXIOMETRY_TRY_VOID(take_line(members, "title", lines.title));
  AXIOMETRY_TRY_VOID(take_line(members, "machine", lines.machine));
  AXIOMETRY_TRY_VOID(take_line(members, "date", lines.date));
  AXIOMETRY_TRY(lines.date, plan_date(lines.date));
  return {};
}

Result<TrackingSetup> setup_in(const Value& value) {
  AXIOMETRY_TRY(TrackingSetup setup, formats::tracking_setup_from(value));
  if (const Value* limits = value.find("limits"); is_aligned(setup) && limits != nullptr && !limits->is(Kind::null))
    return fail(
        "found limits of a tracking instrument without a station, expected none: the interferometer is aligned with "
        "each diagonal",
        limits->at());
  if (setup.obstacles.size() > most_obstacles)
    return fail(fmt::format("obstacles: found {} of them, expected at most {}", setup.obstacles.size(), most_obstacles),
                value.at());
  for (const Obstacle& obstacle : setup.obstacles)
    AXIOMETRY_TRY_VOID(given_line("the name of an obstacle", obstacle.name));
  return setup;
}

/// As it was asked for, with what was drawn.
Value settled(const Value& request, const tracking::LinesRequest& lines) {
  Value whole = Value::object();
  for (const auto& [name, value] : request.members())
    if (name != "seed" && name != "date") whole.add(name, value);
  whole.add("seed", static_cast<double>(lines.seed));
  whole.add("date", lines.date);
  return whole;
}

Result<void> check_presentable(const TrackingPlan& plan) {
  AXIOMETRY_TRY_VOID(given_line("the name of the machine", plan.machine));
  AXIOMETRY_TRY_VOID(given_line("the title of the plan", plan.title));
  if (plan.lines.size() > most_lines)
    return fail(fmt::format("lines: found {} of them, expected at most {}", plan.lines.size(), most_lines));
  std::size_t readings = 0;
  for (const TrackingLine& line : plan.lines) {
    AXIOMETRY_TRY_VOID(given_line("the name of a line", line.id));
    readings += planned_readings(line.plan);
  }
  if (readings <= most_planned_readings) return {};
  return fail(fmt::format("found {} readings in all lines, expected at most {}", readings, most_planned_readings));
}

}  // namespace

Result<TrackingPlanRequest> tracking_request_from(const Value& value) {
  AXIOMETRY_TRY(JsonMembers members, JsonMembers::of(value, "request"));
  TrackingPlanRequest request;
  AXIOMETRY_TRY(const Value* setup, members.required("setup"));
  AXIOMETRY_TRY(request.setup.whole, setup_in(*setup));
  AXIOMETRY_TRY_VOID(take_switch(members, "turn_reflector", request.turn_reflector));
  AXIOMETRY_TRY_VOID(take_ids(members, request.lines.ids));
  AXIOMETRY_TRY_VOID(take_rule(members, request.lines.rule));
  AXIOMETRY_TRY_VOID(take_programme(members, request.lines));
  AXIOMETRY_TRY_VOID(take_names(members, request.lines));
  AXIOMETRY_TRY_VOID(members.finish());
  return request;
}

Result<RequestedLines> requested_lines(const Value& body) {
  AXIOMETRY_TRY(JsonMembers members, JsonMembers::of(body, "body"));
  const Value* request = members.optional("request");
  const Value* plan = members.optional("plan");
  if ((request == nullptr) == (plan == nullptr))
    return fail(fmt::format("found {}, expected one of them",
                            plan != nullptr ? "both a request and a plan" : "neither a request nor a plan"),
                body.at());
  if (plan != nullptr) {
    AXIOMETRY_TRY(TrackingPlan given, formats::tracking_plan_from(*plan));
    AXIOMETRY_TRY_VOID(check_presentable(given));
    return RequestedLines{planned_lines(std::move(given)), {}};
  }
  AXIOMETRY_TRY(const TrackingPlanRequest wish, tracking_request_from(*request));
  AXIOMETRY_TRY(PlannedLines planned, plan_tracking(wish));
  AXIOMETRY_TRY_VOID(check_presentable(planned.plan));
  return RequestedLines{std::move(planned), settled(*request, wish.lines)};
}

Result<EvaluatedLines> evaluate_presentable(const TrackingFiles& files, const TrackingEvaluateOptions& options) {
  AXIOMETRY_TRY(const TrackingPlan plan, in_file(formats::read_tracking_plan(files.plan.bytes), files.plan.name));
  AXIOMETRY_TRY_VOID(in_file(check_presentable(plan), files.plan.name));
  if (!options.uncertainty.monte_carlo) return evaluate_tracking(files, options);
  TrackingEvaluateOptions in_time = options;
  uncertainty::PropagationOptions& trials = in_time.uncertainty.trials.propagation;
  const std::size_t most = most_trials / std::max<std::size_t>(plan.lines.size(), 1);
  if (trials.trials && *trials.trials > most)
    return fail(fmt::format("found {} trials for each of {} lines, expected at most {} in all", *trials.trials,
                            plan.lines.size(), most_trials));
  trials.trials_max = std::min(trials.trials_max, most);
  return evaluate_tracking(files, in_time);
}

Result<LocateRequest> locate_request_from(const Value& value) {
  AXIOMETRY_TRY(JsonMembers members, JsonMembers::of(value, "options"));
  LocateRequest request;
  AXIOMETRY_TRY_VOID(members.take("tool_offset_mm", request.tool_offset_mm));
  if (const Value* near = members.optional("near_mm")) {
    AXIOMETRY_TRY(request.options.near_mm, formats::vector_in(*near, "near_mm"));
  }
  if (const Value* ranging = members.optional("ranging")) {
    AXIOMETRY_TRY(request.options.ranging, formats::ranging_from(*ranging));
  }
  std::optional<double> sigma_um;
  AXIOMETRY_TRY_VOID(take_number(members, "machine_sigma_um", sigma_um));
  AXIOMETRY_TRY_VOID(members.finish());
  if (!sigma_um) return request;
  if (!(*sigma_um >= 0.0 && *sigma_um <= 1e6))
    return fail(fmt::format("machine_sigma_um: found {}, expected 0 to 1000000", format_exact(*sigma_um)),
                value.find("machine_sigma_um")->at());
  request.options.machine_sigma_mm = *sigma_um / 1000.0;
  return request;
}

}  // namespace axiometry::app
