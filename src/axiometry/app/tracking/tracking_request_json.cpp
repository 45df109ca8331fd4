// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cmath>

#include "axiometry/app/plan/plan_request.h"
#include "axiometry/app/tracking/tracking_json.h"
#include "axiometry/app/tracking/tracking_request.h"
#include "axiometry/formats/text/json_members.h"
#include "axiometry/report/tracking.h"
#include "axiometry/standards/iso230_6.h"

namespace axiometry::app {
namespace {

using formats::vector_value;
using json::Value;

/// Texts of this program in the reader's language.
class Teller {
 public:
  explicit Teller(const Reader& reader) : reader_(reader) {}

  Value operator()(std::string_view english) const {
    return language::translated(english, reader_.language, reader_.numbers);
  }

  Value list(const std::vector<std::string>& texts) const {
    Value told = Value::array();
    for (const std::string& text : texts) told.push((*this)(text));
    return told;
  }

 private:
  Reader reader_;
};

/// Null for a diagonal of the travels, and where an edited plan leads along a line that cannot be seen.
Value usable_value(const TrackingSetup& setup, const TrackingLine& line, const Teller& told) {
  const auto interval = tracking::interval_of(setup, line);
  if (!interval) return {};
  Value value = Value::object();
  value.add("octant", interval->octant);
  value.add("begin_mm", interval->begin_mm);
  value.add("end_mm", interval->end_mm);
  value.add("limited_by_begin", told(interval->limited_by_begin));
  value.add("limited_by_end", told(interval->limited_by_end));
  return value;
}

/// Where the reflector stands at the targets.
Value target_places(const TrackingSetup& setup, const Plan& plan) {
  Value places = Value::array();
  const auto line = spatial_line(plan.axis);
  if (!line) return places;
  for (const Position target : plan.targets) places.push(vector_value(line->at(target) + setup.tool_offset_mm));
  return places;
}

Value line_value(const TrackingSetup& setup, const TrackingLine& line, const Teller& told) {
  Value value = Value::object();
  value.add("id", line.id);
  value.add("standard", is_diagonal(line.plan.axis) ? iso230_6::edition : iso230_2::edition);
  value.add("targets", target_places(setup, line.plan));
  value.add("runs", line.plan.runs);
  value.add("readings", planned_readings(line.plan));
  value.add("usable", usable_value(setup, line, told));
  return value;
}

Value way_value(const TrackingPlan& plan) {
  Value way = Value::array();
  for (const Vector3 place : report::layout_of(plan, true).way_mm) way.push(vector_value(place));
  return way;
}

Value kept_value(const tracking::StationSuggestion& station) {
  Value value = Value::object();
  value.add("position_mm", vector_value(station.position_mm));
  value.add("reflector_axis", vector_value(station.reflector_axis));
  value.add("lines", station.lines);
  value.add("shortest_mm", std::round(station.shortest_mm * 10.0) / 10.0);
  return value;
}

}  // namespace

Value lines_value(const RequestedLines& lines, const Reader& reader) {
  const Teller told(reader);
  const TrackingPlan& plan = lines.planned.plan;
  const TrackingSetup& setup = plan.setup;
  Value value = Value::object();
  value.add("plan", to_json(lines.planned));
  value.add("request", lines.request);
  value.add("duration_s", std::round(lines.planned.duration.in_s() * 10.0) / 10.0);
  Value& reach = value.add("reach", Value::object());
  reach.add("lowest_mm", vector_value(setup.travel.lowest_mm + setup.tool_offset_mm));
  reach.add("highest_mm", vector_value(setup.travel.highest_mm + setup.tool_offset_mm));
  Value& rows = value.add("lines", Value::array());
  for (const TrackingLine& line : plan.lines) rows.push(line_value(setup, line, told));
  Value& lost = value.add("lost", Value::array());
  for (const LostLine& line : plan.lost) {
    Value& row = lost.push(Value::object());
    row.add("id", line.id);
    row.add("reason", told(line.reason));
  }
  value.add("remarks", told.list(plan.remarks));
  value.add("way_mm", way_value(plan));
  return value;
}

Value points_value(const PlannedLocation& planned, const Reader& reader) {
  Value value = Value::object();
  const Value whole = to_json(planned);
  value.add("points", *whole.find("points"));
  value.add("expected", *whole.find("expected"));
  value.add("remarks", Teller(reader).list(planned.plan.remarks));
  value.add("csv", location_points_csv(planned));
  return value;
}

Value advice_value(const StationAdvice& advice) {
  Value value = Value::object();
  value.add("lines", advice.lines);
  value.add("now", kept_value(advice.now));
  Value& better = value.add("better", Value::array());
  for (const auto& [station, raised] : advice.better) {
    Value row = kept_value(station);
    row.add("raised", raised);
    better.push(std::move(row));
  }
  return value;
}

}  // namespace axiometry::app
