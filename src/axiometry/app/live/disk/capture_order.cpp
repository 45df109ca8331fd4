// SPDX-License-Identifier: Apache-2.0
#include "axiometry/app/live/disk/capture_order.h"

#include "axiometry/app/live/disk/noted.h"
#include "axiometry/formats/plan/plan_json.h"

namespace axiometry::app {

using json::Kind;
using json::Value;

Value to_json(const CaptureOrder& order) {
  Value options = Value::object();
  for (const auto& [name, text] : order.options) options.add(name, text);
  Value value = Value::object();
  value.add("plan", static_cast<double>(order.plan));
  value.add("part", order.part);
  value.add("source", order.source);
  value.add("layout", order.layout);
  value.add("options", std::move(options));
  value.add("actor", order.actor);
  value.add("started", order.started);
  if (order.lengths)
    value.add("lengths", to_json(*order.lengths));
  else
    value.add("walked", formats::plan_value(order.walked));
  if (order.motion) value.add("motion", to_json(*order.motion));
  return value;
}

std::optional<CaptureOrder> capture_order_from(const Value& value) {
  if (!value.is(Kind::object)) return {};
  const Value* walked = value.find("walked");
  const Value *noted_lengths = value.find("lengths"), *noted_motion = value.find("motion");
  auto plan = walked == nullptr ? Result<Plan>(Plan()) : formats::plan_from_value(*walked);
  auto lengths = noted_lengths == nullptr ? std::nullopt : length_order_from(*noted_lengths);
  auto motion = noted_motion == nullptr ? std::nullopt : motion_order_from(*noted_motion);
  if (!plan || (walked == nullptr && !lengths) || (noted_motion != nullptr && !motion)) return {};
  CaptureOrder order{.plan = static_cast<store::Id>(noted_count(value, "plan")),
                     .part = noted_count(value, "part"),
                     .walked = *std::move(plan),
                     .lengths = std::move(lengths),
                     .motion = motion,
                     .source = noted_text(value, "source"),
                     .layout = noted_text(value, "layout"),
                     .options = {},
                     .actor = noted_text(value, "actor"),
                     .started = noted_text(value, "started")};
  if (const Value* options = value.find("options"); options != nullptr && options->is(Kind::object))
    for (const auto& [name, option] : options->members())
      if (option.is(Kind::text)) order.options.emplace_back(name, option.text());
  return order;
}

std::string identity_of(const CaptureOrder& order) { return json::dump(to_json(order)); }

namespace {

Value value_of(const EndedCapture& capture) {
  Value value = Value::object();
  value.add("order", to_json(capture.order));
  value.add("end", to_json(capture.end));
  return value;
}

}  // namespace

std::string text_of(const EndedCapture& capture) { return json::dump(value_of(capture)) + "\n"; }

std::string discard_text_of(const EndedCapture& capture) {
  Value value = value_of(capture);
  value.add("discarded", true);
  return json::dump(value) + "\n";
}

std::optional<EndedCapture> ended_capture_from(std::string_view bytes) {
  const auto value = json::parse(bytes);
  if (!value || !value->is(Kind::object)) return {};
  const Value *order = value->find("order"), *end = value->find("end");
  if (order == nullptr || end == nullptr) return {};
  auto read_order = capture_order_from(*order);
  auto read_end = table_end_from(*end);
  if (!read_order || !becomes_table(*read_order) || !read_end) return {};
  return EndedCapture{*std::move(read_order), *std::move(read_end)};
}

}  // namespace axiometry::app
