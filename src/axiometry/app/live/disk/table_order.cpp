// SPDX-License-Identifier: Apache-2.0
#include "axiometry/app/live/disk/table_order.h"

#include <string_view>

#include "axiometry/app/live/disk/noted.h"
#include "axiometry/app/recordings/stop_options.h"

namespace axiometry::app {

using json::Kind;
using json::Value;

Value to_json(const LengthOrder& order) {
  Value value = Value::object();
  value.add("kind", kind_name(order.kind));
  value.add("plan", order.plan);
  value.add("plan_id", order.plan_id);
  value.add("title", order.title);
  value.add("stops", order.stops);
  return value;
}

Value to_json(const MotionOrder& order) {
  Value value = Value::object();
  value.add("error", order.error.text());
  value.add("stops", stop_sign_word(order.sign));
  return value;
}

Value to_json(const TableEnd& end) {
  Value value = Value::object();
  value.add("stage", end.stage);
  value.add("raw", end.raw);
  value.add("times", end.times);
  if (!end.keys.empty()) value.add("keys", end.keys);
  value.add("table", end.table);
  value.add("found", end.found);
  Value notes = Value::array();
  for (const std::string& note : end.notes) notes.push(note);
  value.add("notes", std::move(notes));
  value.add("error", end.error);
  return value;
}

std::optional<LengthOrder> length_order_from(const Value& value) {
  if (!value.is(Kind::object)) return {};
  const auto kind = length_plan_kind(noted_text(value, "kind"));
  if (!kind) return {};
  return LengthOrder{.kind = *kind,
                     .plan = noted_text(value, "plan"),
                     .plan_id = noted_text(value, "plan_id"),
                     .title = noted_text(value, "title"),
                     .stops = noted_count(value, "stops")};
}

std::optional<MotionOrder> motion_order_from(const Value& value) {
  if (!value.is(Kind::object)) return {};
  const auto error = motion_name(noted_text(value, "error"));
  const auto sign = stop_sign(noted_text(value, "stops"));
  if (!error || !sign) return {};
  return MotionOrder{*error, *sign};
}

std::optional<TableEnd> table_end_from(const Value& value) {
  if (!value.is(Kind::object)) return {};
  TableEnd end{.stage = noted_text(value, "stage"),
               .raw = noted_text(value, "raw"),
               .times = noted_text(value, "times"),
               .keys = noted_text(value, "keys"),
               .table = noted_text(value, "table"),
               .found = noted_count(value, "found"),
               .notes = {},
               .error = noted_text(value, "error")};
  if (end.stage.empty()) return {};
  if (const Value* notes = value.find("notes"); notes != nullptr && notes->is(Kind::array))
    for (const Value& note : notes->items())
      if (note.is(Kind::text)) end.notes.push_back(note.text());
  return end;
}

}  // namespace axiometry::app
