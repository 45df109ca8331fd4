// SPDX-License-Identifier: Apache-2.0
#include "axiometry/formats/plan/tracking_plan_json.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "axiometry/base/text/text.h"
#include "axiometry/formats/plan/plan_json.h"
#include "axiometry/formats/test/test_schema.h"
#include "axiometry/formats/text/json_members.h"
#include "axiometry/formats/text/text_source.h"
#include "axiometry/model/aligned.h"

namespace axiometry::formats {
namespace {

using json::Kind;
using json::Value;

/// "NNN-PPP": a diagonal of the travels.
bool names_diagonal(std::string_view id) {
  constexpr std::size_t letters = 3;
  return id.size() == 2 * letters + 1 && id[letters] == '-' && id.find_first_not_of("NP0-") == id.npos;
}

/// As iso230_6::Diagonal names the line of that direction.
std::string diagonal_name(Vector3 direction) {
  constexpr double stands_below = 1e-6;
  std::string begin, end;
  for (std::size_t k = 0; k < 3; ++k) {
    const bool stands = std::abs(direction[k])<stands_below, rises = direction[k]> 0.0;
    begin += stands ? '0' : rises ? 'N' : 'P';
    end += stands ? '0' : rises ? 'P' : 'N';
  }
  return begin + "-" + end;
}

Result<TrackingLine> line_from(const Value& value, const std::vector<TrackingLine>& before) {
  AXIOMETRY_TRY(JsonMembers members, JsonMembers::of(value, "line"));
  TrackingLine line;
  AXIOMETRY_TRY(const Value* id, members.required("id"));
  AXIOMETRY_TRY(line.id, text_in(*id, "id"));
  AXIOMETRY_TRY(const Value* plan, members.required("plan"));
  AXIOMETRY_TRY_VOID(members.finish());
  if (line.id.empty()) return fail("found a line without a name, expected one such as \"xy\"", id->at());
  if (std::ranges::find(before, line.id, &TrackingLine::id) != before.end())
    return fail(fmt::format("found the line {} a second time, expected each once", text::quoted(line.id)), id->at());
  AXIOMETRY_TRY(line.plan, plan_from_value(*plan));
  const auto way = spatial_line(line.plan.axis);
  if (!way)
    return fail(fmt::format("found the line {} without line_origin_mm and line_direction in its axis, expected both",
                            text::quoted(line.id)),
                plan->at());
  if (const std::string name = diagonal_name(way->direction); names_diagonal(line.id) && line.id != name)
    return fail(fmt::format("found the line {} with the direction of {}, expected that of its name",
                            text::quoted(line.id), text::quoted(name)),
                plan->at());
  return line;
}

Result<LostLine> lost_from(const Value& value) {
  AXIOMETRY_TRY(JsonMembers members, JsonMembers::of(value, "lost"));
  LostLine lost;
  AXIOMETRY_TRY_VOID(members.take("id", lost.id));
  AXIOMETRY_TRY_VOID(members.take("reason", lost.reason));
  AXIOMETRY_TRY_VOID(members.finish());
  return lost;
}

/// Each item of an array that may be absent.
template <typename Take>
Result<void> each(const Value* list, std::string_view what, Take take) {
  if (list == nullptr) return {};
  AXIOMETRY_TRY(const auto* items, items_in(*list, what));
  for (const Value& item : *items) AXIOMETRY_TRY_VOID(take(item));
  return {};
}

}  // namespace

Result<TrackingPlan> tracking_plan_from(const Value& root) {
  AXIOMETRY_TRY(JsonMembers members, JsonMembers::of(root, "tracking plan"));
  AXIOMETRY_TRY(const Value* format, members.required("format"));
  if (!format->is(Kind::text) || format->text() != tracking_plan_format_name)
    return fail(fmt::format("found another \"format\", expected \"{}\"", tracking_plan_format_name), format->at());
  TrackingPlan plan;
  for (const auto& [name, member] :
       {std::pair{"title", &plan.title}, std::pair{"machine", &plan.machine}, std::pair{"date", &plan.date}})
    AXIOMETRY_TRY_VOID(members.take(name, *member));
  if (const Value* date = members.optional("date")) AXIOMETRY_TRY_VOID(placed(check_plan_date(plan.date), date->at()));
  AXIOMETRY_TRY(const Value* setup, members.required("setup"));
  AXIOMETRY_TRY(plan.setup, tracking_setup_from(*setup));
  AXIOMETRY_TRY(const Value* lines, members.required("lines"));
  AXIOMETRY_TRY_VOID(each(lines, "lines", [&](const Value& item) -> Result<void> {
    AXIOMETRY_TRY(TrackingLine line, line_from(item, plan.lines));
    plan.lines.push_back(std::move(line));
    return {};
  }));
  for (const TrackingLine& line : plan.lines)
    if (is_aligned(plan.setup) && !names_diagonal(line.id))
      return fail(
          fmt::format("found the line {} in a plan without a station, expected diagonals of the travels such as "
                      "NNN-PPP",
                      text::quoted(line.id)),
          lines->at());
  AXIOMETRY_TRY_VOID(each(members.optional("lost"), "lost", [&](const Value& item) -> Result<void> {
    AXIOMETRY_TRY(plan.lost.emplace_back(), lost_from(item));
    return {};
  }));
  AXIOMETRY_TRY_VOID(each(members.optional("remarks"), "remarks", [&](const Value& item) -> Result<void> {
    AXIOMETRY_TRY(plan.remarks.emplace_back(), text_in(item, "remarks"));
    return {};
  }));
  for (std::string_view name : {"$schema", "program", "version", "duration_s"}) members.pass_over(name);
  AXIOMETRY_TRY_VOID(members.finish());
  return plan;
}

Value tracking_plan_value(const TrackingPlan& plan) {
  Value root = object({{"format", tracking_plan_format_name}});
  for (const auto& [name, text] :
       {std::pair{"title", &plan.title}, std::pair{"machine", &plan.machine}, std::pair{"date", &plan.date}})
    if (!text->empty()) root.add(name, *text);
  root.add("setup", tracking_setup_value(plan.setup));
  Value& lines = root.add("lines", Value::array());
  for (const TrackingLine& line : plan.lines) lines.push(object({{"id", line.id}, {"plan", plan_value(line.plan)}}));
  Value& lost = root.add("lost", Value::array());
  for (const LostLine& line : plan.lost) lost.push(object({{"id", line.id}, {"reason", line.reason}}));
  Value& remarks = root.add("remarks", Value::array());
  for (const std::string& remark : plan.remarks) remarks.push(remark);
  return root;
}

std::string write_tracking_plan(const TrackingPlan& plan) { return json::dump(tracking_plan_value(plan)) + "\n"; }

bool is_tracking_plan(std::string_view bytes) { return stated_format(bytes) == tracking_plan_format_name; }

Result<TrackingPlan> read_tracking_plan(std::string_view bytes) {
  AXIOMETRY_TRY(const std::string_view text, utf8_text(bytes));
  AXIOMETRY_TRY(const Value root, json::parse(text));
  return tracking_plan_from(root);
}

}  // namespace axiometry::formats
