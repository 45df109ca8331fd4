// SPDX-License-Identifier: Apache-2.0
#include "axiometry/app/live/lengths/length_task.h"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "axiometry/app/recordings/length_capture.h"
#include "axiometry/app/tracking/tracking_request.h"
#include "axiometry/app/volumetric/part_lengths.h"
#include "axiometry/app/volumetric/volumetric_request.h"
#include "axiometry/capture/capture_result.h"
#include "axiometry/digest/sha256.h"
#include "axiometry/formats/plan/tracking_plan_json.h"
#include "axiometry/formats/volumetric/volumetric_plan_json.h"

namespace axiometry::app {
namespace {

using volumetric::CalibrationPlan;

std::vector<TaskPart> parts_of(const TrackingPlan& plan) {
  std::vector<TaskPart> parts;
  std::size_t all = 0;
  for (const TrackingLine& line : plan.lines) {
    const std::size_t stops = approaches(line.plan).size();
    parts.push_back({parts.size() + 1, fmt::format("measuring line {}", line.id), stops});
    all += stops;
  }
  if (parts.size() > 1) parts.insert(parts.begin(), TaskPart{0, fmt::format("all {} lines", plan.lines.size()), all});
  return parts;
}

std::vector<TaskPart> parts_of(const CalibrationPlan& plan) {
  std::vector<TaskPart> parts;
  for (std::size_t part = 1; part <= plan.runs.size(); ++part)
    parts.push_back({part, part_text(plan, {part, part}), plan.runs[part - 1].stops.size()});
  return parts;
}

}  // namespace

std::string_view kind_name(LengthPlanKind kind) { return kind == LengthPlanKind::lines ? "lines" : "volume"; }

std::optional<LengthPlanKind> length_plan_kind(std::string_view name) {
  for (const LengthPlanKind kind : {LengthPlanKind::lines, LengthPlanKind::volume})
    if (kind_name(kind) == name) return kind;
  return {};
}

Result<LengthTask> LengthTask::make(LengthPlanKind kind, const json::Value& body, std::size_t part) {
  if (kind == LengthPlanKind::volume) {
    AXIOMETRY_TRY(CalibrationPlan plan, given_calibration(body));
    AXIOMETRY_TRY_VOID(check_parts(plan, {part, part}));
    LengthTask task(std::move(plan), part);
    task.parts_ = parts_of(*task.volume());
    return task;
  }
  AXIOMETRY_TRY(RequestedLines requested, requested_lines(body));
  TrackingPlan& plan = requested.planned.plan;
  if (part > plan.lines.size())
    return fail(fmt::format("found line {} asked for, expected 1 to {}, or 0 for all lines", part, plan.lines.size()));
  TrackingPlan wanted = plan;
  if (part > 0) wanted.lines = {plan.lines[part - 1]};
  LengthTask task(std::move(plan), part);
  task.parts_ = parts_of(*task.all_lines());
  task.lines_ = std::move(wanted);
  return task;
}

LengthPlanKind LengthTask::kind() const { return volume() ? LengthPlanKind::volume : LengthPlanKind::lines; }

std::string LengthTask::title() const {
  if (volume()) return part_text(*volume(), {part_, part_});
  if (part_ == 0 && lines()->lines.size() > 1) return fmt::format("all {} lines", lines()->lines.size());
  return lines()->lines.empty() ? "no line" : fmt::format("measuring line {}", lines()->lines.front().id);
}

std::vector<TaskStop> LengthTask::stops() const {
  std::vector<TaskStop> stops;
  if (volume()) {
    const PartStops expected = part_stops(*volume(), {part_, part_});
    for (std::size_t k = 0; k < expected.places.size(); ++k)
      stops.push_back({fmt::format("part {}", part_), fmt::format("point {}", expected.places[k].stop + 1),
                       expected.list.stops[k].reflector_mm, expected.list.stops[k].begins_segment});
    return stops;
  }
  const capture::LineStops expected = capture::line_stops(*lines());
  for (std::size_t k = 0; k < expected.approaches.size(); ++k)
    stops.push_back({fmt::format("measuring line {}", lines()->lines[expected.approaches[k].line].id),
                     capture::approach_name(expected.approaches[k].approach), expected.list.stops[k].reflector_mm,
                     expected.list.stops[k].begins_segment});
  return stops;
}

std::size_t LengthTask::stop_count() const {
  const auto own = std::ranges::find(parts_, part_, &TaskPart::part);
  return own != parts_.end() ? own->stops : parts_.empty() ? 0 : parts_.front().stops;
}

json::Value LengthTask::plan_value() const {
  return volume() ? formats::volumetric_plan_value(*volume()) : formats::tracking_plan_value(*all_lines());
}

std::string LengthTask::plan_id() const {
  const auto undated = [](auto plan) {
    plan.date.clear();
    return plan;
  };
  if (volume()) return sha256(formats::write_volumetric_plan(undated(*volume())));
  return sha256(formats::write_tracking_plan(undated(*all_lines())));
}

Result<CaptureSession> LengthTask::open(const CaptureOptions& options) const {
  if (options.part) return fail("found a part among the options, expected it beside the plan of the lengths");
  return volume() ? open_parts(*volume(), {part_, part_}, options) : CaptureSession::open(*lines(), options);
}

Result<FoundTable> LengthTask::lengths(const CaptureSession& session) const {
  if (volume()) {
    AXIOMETRY_TRY(PartLengths found, part_lengths(*volume(), PartRange{part_, part_}, false, session));
    return FoundTable{part_lengths_table(found), found.lengths.readings.size(), found.planned, std::move(found.notes)};
  }
  AXIOMETRY_TRY(CapturedLengths found, captured_lengths(*lines(), session));
  return FoundTable{length_capture_table(found), found.readings.size(), found.approaches, std::move(found.notes)};
}

}  // namespace axiometry::app
