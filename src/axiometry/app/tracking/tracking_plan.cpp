// SPDX-License-Identifier: Apache-2.0
#include "axiometry/app/tracking/tracking_plan.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "axiometry/app/files/number_list.h"
#include "axiometry/app/files/output.h"
#include "axiometry/app/files/whole_file.h"
#include "axiometry/app/results/result_json.h"
#include "axiometry/base/json/json.h"
#include "axiometry/base/text/number_text.h"
#include "axiometry/base/text/text.h"
#include "axiometry/formats/plan/tracking_plan_json.h"
#include "axiometry/formats/tracking/station_json.h"
#include "axiometry/model/aligned.h"
#include "axiometry/report/tracking.h"
#include "axiometry/standards/iso230_2/plan/plan.h"

namespace axiometry::app {
namespace {

Result<TrackingSetup> setup_from_file(const std::string& file) {
  AXIOMETRY_TRY(const std::string bytes, whole_file(file));
  if (formats::is_tracking_plan(bytes)) {
    AXIOMETRY_TRY(TrackingPlan plan, in_file(formats::read_tracking_plan(bytes), file));
    return std::move(plan.setup);
  }
  AXIOMETRY_TRY(const json::Value value, in_file(json::parse(bytes), file));
  return in_file(formats::tracking_setup_from(value), file);
}

/// Three numbers, or the name of a file.
Result<Station> station_of(const std::string& text) {
  const auto place = parse_vector(text);
  if (place) return Station{*place, {}};
  const auto parts = text::split(text, ',');
  const auto numbers = static_cast<std::size_t>(
      std::ranges::count_if(parts, [](std::string_view p) { return parse_number(text::trim(p)).has_value(); }));
  const bool misread_place = parts.size() == 3 ? numbers > 0 : parts.size() > 1 && numbers == parts.size();
  if (misread_place) return std::unexpected(place.error());
  AXIOMETRY_TRY(const std::string bytes, whole_file(text));
  return in_file(formats::read_station(bytes), text);
}

template <typename T>
void take(std::optional<T> given, T& target) {
  if (given) target = *std::move(given);
}

std::vector<std::string> seven_of(const tracking::LinesRequest& request) {
  std::vector<std::string> ids;
  for (std::string_view id : tracking::seven_lines)
    if (request.ids.empty() || std::ranges::find(request.ids, id) != request.ids.end()) ids.emplace_back(id);
  return ids;
}

std::string place_text(Vector3 v) {
  return fmt::format("X {}, Y {}, Z {} mm", format_fixed(v.x, 3), format_fixed(v.y, 3), format_fixed(v.z, 3));
}

std::string direction_text(Vector3 axis) {
  return fmt::format("({}, {}, {})", format_fixed(axis.x, 3), format_fixed(axis.y, 3), format_fixed(axis.z, 3));
}

constexpr std::string_view no_station_word = "none";

bool only_diagonals(const tracking::LinesRequest& lines) {
  return !lines.ids.empty() && std::ranges::none_of(lines.ids, [](const std::string& id) {
    return std::ranges::find(tracking::seven_lines, id) != tracking::seven_lines.end();
  });
}

/// What says something of a tracking interferometer; "" for nothing.
std::string_view said_of_tracker(const TrackingPlanRequest& request) {
  const SetupRequest& setup = request.setup;
  if (setup.range_mm) return "a range of the instrument";
  if (setup.elevation_deg) return "an elevation of the beam";
  if (setup.incidence_deg || setup.reflector_axis || request.turn_reflector) return "a direction of the reflector";
  if (setup.safe_radius_mm) return "a safe radius about the station";
  if (setup.line_least_mm) return "a least length of lines";
  if (request.suggest) return "a better station to be suggested";
  if (request.lines.rule != tracking::DiagonalRule::equal_increments) return "a rule for diagonals from the station";
  return {};
}

/// For diagonals alone a station need not be given: the interferometer is then aligned with each of them.
SetupRequest setup_request(const TrackingPlanRequest& request) {
  SetupRequest setup = request.setup;
  const bool begun = setup.whole || !setup.file.empty();
  if (setup.station.empty() && !begun && only_diagonals(request.lines)) setup.station = no_station_word;
  return setup;
}

Result<void> check_aligned(const TrackingSetup& setup, const TrackingPlanRequest& request) {
  if (!is_aligned(setup)) return {};
  if (!only_diagonals(request.lines))
    return fail(
        "found no station, expected its place or the file of a located one: only diagonals of the travels need none");
  if (const std::string_view said = said_of_tracker(request); !said.empty())
    return fail(
        fmt::format("found {} without a station, expected none: the interferometer is aligned with each "
                    "diagonal",
                    said));
  return {};
}

bool may_turn(const TrackingPlanRequest& request) {
  const SetupRequest& setup = request.setup;
  return request.turn_reflector || (setup.file.empty() && !setup.whole && !setup.reflector_axis);
}

/// Of all directions the one that keeps the most lines; that of the set-up where none is better.
std::optional<std::string> turn_reflector(TrackingSetup& setup, const tracking::LinesRequest& request) {
  const auto ids = seven_of(request);
  if (ids.empty()) return std::nullopt;
  const auto turned =
      tracking::suggest_station(setup, ids, request.rule, {.may_move = {false, false, false}, .turn_reflector = true});
  if (turned.lines == 0 || distance(turned.reflector_axis, unit(setup.limits.reflector_axis)) < 1e-9)
    return std::nullopt;
  setup.limits.reflector_axis = turned.reflector_axis + Vector3{};
  return fmt::format("mount the reflector so that it looks along {}: it then sees the station from {} of {} lines",
                     direction_text(turned.reflector_axis), turned.lines, ids.size());
}

/// What a station elsewhere would keep: where it stands on the table, and where that is not enough, higher or lower.
StationAdvice advice_on(const TrackingSetup& setup, const TrackingPlanRequest& request) {
  const auto ids = seven_of(request.lines);
  StationAdvice advice;
  advice.lines = ids.size();
  if (ids.empty()) return advice;
  tracking::StationFreedom freedom{.may_move = {false, false, false}, .turn_reflector = may_turn(request)};
  advice.now = tracking::suggest_station(setup, ids, request.lines.rule, freedom);
  freedom.may_move = {true, true, false};
  for (bool may_rise : {false, true}) {
    freedom.may_move[2] = may_rise;
    const auto better = tracking::suggest_station(setup, ids, request.lines.rule, freedom);
    if (better.lines > advice.now.lines || better.shortest_mm > advice.now.shortest_mm + 1.0)
      advice.better.push_back({better, may_rise});
    if (better.lines == ids.size()) break;
  }
  return advice;
}

std::vector<std::string> told(const StationAdvice& advice) {
  std::vector<std::string> texts;
  if (advice.lines == 0) return texts;
  for (const auto& [better, raised] : advice.better)
    texts.push_back(
        fmt::format("a station at {}{} would keep {} of {} lines, the shortest of {:.1f} mm; here it is {} of {}, "
                    "the shortest of "
                    "{:.1f} mm",
                    place_text(better.position_mm), raised ? " (raised or lowered)" : "", better.lines, advice.lines,
                    better.shortest_mm, advice.now.lines, advice.lines, advice.now.shortest_mm));
  if (texts.empty()) texts.emplace_back("no other place for the station keeps more lines, or a longer shortest one");
  return texts;
}

}  // namespace

Result<TrackingSetup> setup_of(const SetupRequest& request) {
  TrackingSetup setup = request.whole.value_or(TrackingSetup{});
  if (!request.file.empty()) {
    AXIOMETRY_TRY(setup, setup_from_file(request.file));
  }
  const bool begun = request.whole || !request.file.empty();
  if (!begun && !request.travel)
    return fail("found no travels, expected those of X, Y and Z, or a set-up that has them");
  if (!begun && request.station.empty())
    return fail("found no station, expected its place or the file of a located one");
  take(request.travel, setup.travel);
  take(request.tool_offset_mm, setup.tool_offset_mm);
  if (request.station == no_station_word) {
    setup.station = no_station();
  } else if (!request.station.empty()) {
    AXIOMETRY_TRY(setup.station, station_of(request.station));
  }
  if (request.range_mm) {
    setup.limits.range_least_mm = request.range_mm->low;
    setup.limits.range_most_mm = request.range_mm->high;
  }
  if (request.elevation_deg) {
    setup.limits.elevation_lowest_deg = request.elevation_deg->low;
    setup.limits.elevation_highest_deg = request.elevation_deg->high;
  }
  take(request.incidence_deg, setup.limits.incidence_most_deg);
  take(request.reflector_axis, setup.limits.reflector_axis);
  take(request.safe_radius_mm, setup.limits.safe_radius_mm);
  take(request.line_least_mm, setup.limits.line_least_mm);
  take(request.ranging, setup.ranging);
  setup.obstacles.insert(setup.obstacles.end(), request.obstacles.begin(), request.obstacles.end());
  AXIOMETRY_TRY_VOID(tracking::check_setup(setup));
  return setup;
}

Result<MountedSetup> mounted_setup(const TrackingPlanRequest& request) {
  MountedSetup mounted;
  AXIOMETRY_TRY(mounted.setup, setup_of(setup_request(request)));
  AXIOMETRY_TRY_VOID(check_aligned(mounted.setup, request));
  if (is_aligned(mounted.setup)) return mounted;
  if (may_turn(request))
    if (auto turned = turn_reflector(mounted.setup, request.lines)) mounted.remarks.push_back(*std::move(turned));
  return mounted;
}

Result<StationAdvice> advise_station(const TrackingPlanRequest& request) {
  AXIOMETRY_TRY(const MountedSetup mounted, mounted_setup(request));
  if (is_aligned(mounted.setup)) return fail("found no station, expected one");
  return advice_on(mounted.setup, request);
}

Result<PlannedLines> plan_tracking(const TrackingPlanRequest& request) {
  AXIOMETRY_TRY(auto mounted, mounted_setup(request));
  auto& [setup, remarks] = mounted;
  if (request.lines.acceleration) AXIOMETRY_TRY_VOID(check_acceleration(*request.lines.acceleration));
  if (request.suggest)
    for (std::string& text : told(advice_on(setup, request))) remarks.push_back(std::move(text));
  auto plan = tracking::plan_lines(setup, request.lines);
  if (!plan) {
    Error error = std::move(plan).error();
    if (error.message.starts_with(tracking::none_left))
      for (const std::string& remark : remarks) error.message += "; " + remark;
    return std::unexpected(std::move(error));
  }
  plan->remarks.insert(plan->remarks.begin(), remarks.begin(), remarks.end());
  return planned_lines(*std::move(plan));
}

PlannedLines planned_lines(TrackingPlan plan) {
  const Duration duration = tracking::estimated_duration(plan);
  return {std::move(plan), duration};
}

json::Value to_json(const PlannedLines& planned) {
  json::Value root = formats::tracking_plan_value(planned.plan);
  root.add("duration_s", std::round(planned.duration.in_s() * 10.0) / 10.0);
  root.add("program", program_to_json());
  return root;
}

Result<PlannedLocation> plan_location_points(const TrackingPlanRequest& request, std::size_t count) {
  AXIOMETRY_TRY(const MountedSetup mounted, mounted_setup(request));
  if (is_aligned(mounted.setup)) return fail("found no station, expected one");
  AXIOMETRY_TRY(PlannedLocation planned, plan_location_points(mounted.setup, count));
  planned.plan.remarks.insert(planned.plan.remarks.begin(), mounted.remarks.begin(), mounted.remarks.end());
  return planned;
}

Result<TrackingPlan> read_tracking_plan_file(const std::string& file) {
  AXIOMETRY_TRY(const std::string bytes, whole_file(file));
  return in_file(formats::read_tracking_plan(bytes), file);
}

Result<void> write_outputs(const PlannedLines& planned, const OutputNames& names, const report::Options& options) {
  if (!names.reports.empty()) {
    const report::Document sheet = report::tracking_sheet(planned.plan, planned.duration, options);
    AXIOMETRY_TRY_VOID(write_document(sheet, names.reports, options));
  }
  if (names.json.empty()) return {};
  return write_file(names.json, json::dump(to_json(planned)) + "\n");
}

Result<bool> is_tracking_plan_file(const std::string& file) {
  AXIOMETRY_TRY(const std::string bytes, whole_file(file));
  return formats::is_tracking_plan(bytes);
}

}  // namespace axiometry::app
