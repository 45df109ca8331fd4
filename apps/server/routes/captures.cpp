// SPDX-License-Identifier: Apache-2.0
// Live captures: what may be listened to, and captures that run.
#include <fmt/format.h>

#include <algorithm>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "axiometry/app/files/given_text.h"
#include "axiometry/app/live/disk/stop_marks.h"
#include "axiometry/app/live/lengths/length_task.h"
#include "axiometry/app/live/service/capture_keeping.h"
#include "axiometry/app/plan/plan_request.h"
#include "axiometry/app/workbench/workbench_values.h"
#include "axiometry/base/text/text.h"
#include "axiometry/language/language.h"
#include "server/http/request_values.h"
#include "server/routes/routes.h"
#include "server/routing/adder.h"

namespace axiometry::server {
namespace {

using app::CaptureService;
using app::CaptureState;
using json::Kind;
using json::Value;

constexpr std::string_view capture_members[] = {"plan", "lengths", "source", "layout", "options", "resume"};
constexpr std::size_t length_plan_bytes_max = std::size_t{4} << 20;  // 12 000 points with their ways
constexpr std::size_t joined_captures_max = 500;                     // more than any plan has parts

/// A text of this program in the reader's language.
Value told_to(const app::Reader& reader, std::string_view words) {
  return language::translated(words, reader.language, reader.numbers);
}

Result<void> check_members(const Value& body) {
  for (const auto& [name, value] : body.members())
    if (std::ranges::find(capture_members, std::string_view(name)) == std::end(capture_members))
      return fail(
          fmt::format(
              "found the unknown member \"{}\", expected plan or lengths, source, layout and options, or resume", name),
          value.at());
  return {};
}

Result<void> check_writable(const store::Store& store) {
  const store::Info info = store.info();
  if (info.writable) return {};
  return fail(ErrorKind::read_only, fmt::format("found a store that cannot be written: {}", info.why_not));
}

/// {"kind", "plan", "part"}; a part that is not there is the whole of a plan of lines.
Result<app::LengthTask> length_task_of(const Value& value) {
  if (!value.is(Kind::object))
    return fail(fmt::format("lengths: found {}, expected an object", json::kind_name(value.kind())), value.at());
  for (const auto& [name, member] : value.members())
    if (name != "kind" && name != "plan" && name != "part")
      return fail(fmt::format("found the unknown member \"{}\", expected kind, plan and part", name), member.at());
  AXIOMETRY_TRY(const std::string word, line_member(value, "kind"));
  const auto kind = app::length_plan_kind(word);
  if (!kind) return fail(fmt::format("found the kind {}, expected lines or volume", text::quoted(word)), value.at());
  std::size_t part = 0;
  if (const Value* number = value.find("part");
      number != nullptr && !(number->is(Kind::number) && number->number() == 0.0)) {
    AXIOMETRY_TRY(const std::int64_t given, app::given_number("part", *number));
    part = static_cast<std::size_t>(given);
  }
  Value subject = Value::object();
  if (const Value* plan = value.find("plan")) subject.add("plan", *plan);
  return app::LengthTask::make(*kind, subject, part);
}

Result<CaptureState> start_lengths(const Context& context, const Request& request, const Value& body) {
  if (const Value* plan = body.find("plan"))
    return fail("found a plan beside lengths, expected one of them", plan->at());
  AXIOMETRY_TRY(app::LengthTask task, length_task_of(*body.find("lengths")));
  app::LengthWish wish{.task = std::move(task), .source = {}, .layout = {}, .options = {}, .actor = request.actor};
  AXIOMETRY_TRY(wish.source, line_member(body, "source"));
  AXIOMETRY_TRY(wish.layout, line_member(body, "layout"));
  AXIOMETRY_TRY(wish.options, options_member(body));
  return context.captures.start(wish);
}

Result<CaptureState> start(const Context& context, const Request& request, const Value& body) {
  if (body.find("lengths") != nullptr) return start_lengths(context, request, body);
  const Value* number = body.find("plan");
  if (number == nullptr) return fail("found no plan, expected the number of one, or lengths", body.at());
  AXIOMETRY_TRY(const store::Id plan, app::given_number("plan", *number));
  app::CaptureWish wish{.plan = plan, .whole = {}, .source = {}, .layout = {}, .options = {}, .actor = request.actor};
  AXIOMETRY_TRY(wish.source, line_member(body, "source"));
  AXIOMETRY_TRY(wish.layout, line_member(body, "layout"));
  AXIOMETRY_TRY(wish.options, options_member(body));
  AXIOMETRY_TRY(const auto record, context.store.get<store::PlanRecord>(plan));
  AXIOMETRY_TRY(const store::Content content, context.store.content(record.value.content));
  AXIOMETRY_TRY(app::RequestedPlan kept, app::read_requested(content.bytes));
  AXIOMETRY_TRY(wish.whole, app::captured_plan(context.store, record.value, std::move(kept.planned.plan)));
  return context.captures.start(wish);
}

Result<Response> post(const Context& context, const Request& request) {
  AXIOMETRY_TRY(const app::Reader reader, reader_of(request));
  AXIOMETRY_TRY(const Value body, json_body(request));
  AXIOMETRY_TRY_VOID(check_members(body));
  AXIOMETRY_TRY_VOID(check_writable(context.store));
  const Value* resumed = body.find("resume");
  if (resumed == nullptr || resumed->is(Kind::null)) {
    AXIOMETRY_TRY(const CaptureState state, start(context, request, body));
    return json_response(app::to_json(state, reader), 201);
  }
  if (body.members().size() > 1) return fail("found more beside resume, expected it alone", resumed->at());
  AXIOMETRY_TRY(const store::Id id, app::given_number("resume", *resumed));
  AXIOMETRY_TRY(const CaptureState state, context.captures.resume(id));
  return json_response(app::to_json(state, reader), 201);
}

Result<Response> list_captures(CaptureService& captures, const Request& request) {
  AXIOMETRY_TRY(const app::Reader reader, reader_of(request));
  Value list = Value::array();
  for (const CaptureState& state : captures.states()) list.push(app::to_json(state, reader));
  Value value = Value::object();
  value.add("captures", std::move(list));
  return json_response(value);
}

Result<Response> sources(const CaptureService& captures, const Request& request) {
  AXIOMETRY_TRY(const app::Reader reader, reader_of(request));
  Value list = Value::array();
  for (const app::CaptureSource& source : captures.sources()) list.push(app::to_json(source, reader));
  Value value = Value::object();
  value.add("sources", std::move(list));
  return json_response(value);
}

Result<Response> get_capture(CaptureService& captures, const Request& request) {
  AXIOMETRY_TRY(const app::Reader reader, reader_of(request));
  AXIOMETRY_TRY(const store::Id id, id_of(request, "capture"));
  AXIOMETRY_TRY(const auto after, whole_of(request, "after", std::int64_t{1} << 53));
  AXIOMETRY_TRY(const CaptureState state, captures.state(id, static_cast<app::CaptureRevision>(after.value_or(0))));
  return json_response(app::to_json(state, reader));
}

Value part_value(const app::TaskPart& part, const app::Reader& reader) {
  Value value = Value::object();
  value.add("part", part.part);
  value.add("title", told_to(reader, part.title));
  value.add("stops", part.stops);
  return value;
}

/// The parts of a plan, and the captures of any of them.
Result<Response> length_parts(CaptureService& captures, const Request& request) {
  AXIOMETRY_TRY(const app::Reader reader, reader_of(request));
  AXIOMETRY_TRY(const Value body, json_body(request));
  AXIOMETRY_TRY(const app::LengthTask task, length_task_of(body));
  const std::string plan_id = task.plan_id();
  Value parts = Value::array(), of_plan = Value::array();
  for (const app::TaskPart& part : task.parts()) parts.push(part_value(part, reader));
  for (const CaptureState& state : captures.states())
    if (state.lengths && state.lengths->order.plan_id == plan_id) of_plan.push(app::to_json(state, reader));
  Value value = Value::object();
  value.add("kind", app::kind_name(task.kind()));
  value.add("plan_id", plan_id);
  value.add("parts", std::move(parts));
  value.add("captures", std::move(of_plan));
  return json_response(value);
}

Value stop_value(const app::TaskStop& stop, const app::Reader& reader) {
  Value value = Value::object(), at = Value::array();
  for (const double mm : {stop.reflector_mm.x, stop.reflector_mm.y, stop.reflector_mm.z}) at.push(mm);
  value.add("group", told_to(reader, stop.group));
  value.add("name", told_to(reader, stop.name));
  value.add("reflector_mm", std::move(at));
  value.add("begins_segment", stop.begins_segment);
  return value;
}

Result<Response> length_plan(CaptureService& captures, const Request& request) {
  AXIOMETRY_TRY(const app::Reader reader, reader_of(request));
  AXIOMETRY_TRY(const store::Id id, id_of(request, "capture"));
  AXIOMETRY_TRY(const CaptureState state, captures.state(id));
  AXIOMETRY_TRY(const app::LengthTask task, captures.task_of(state));
  Value stops = Value::array(), parts = Value::array();
  for (const app::TaskStop& stop : task.stops()) stops.push(stop_value(stop, reader));
  for (const app::TaskPart& part : task.parts()) parts.push(part_value(part, reader));
  Value value = Value::object();
  value.add("kind", app::kind_name(task.kind()));
  value.add("plan", task.plan_value());
  value.add("plan_id", task.plan_id());
  value.add("part", task.part());
  value.add("parts", std::move(parts));
  value.add("stops", std::move(stops));
  return json_response(value);
}

Result<Response> captured_file(CaptureService& captures, const Request& request) {
  AXIOMETRY_TRY(const store::Id id, id_of(request, "capture"));
  const std::string role(request.segment("role"));
  AXIOMETRY_TRY(std::string bytes, captures.file_of(id, role));
  const bool is_table = role == "lengths" || role == "readings";
  const std::string_view extension = is_table          ? ".csv"
                                     : role == "times" ? ".raw.times"
                                     : role == "keys"  ? ".raw.keys"
                                                       : ".raw";
  return download(std::move(bytes), is_table ? app::media_type_of("csv") : "application/octet-stream",
                  fmt::format("capture-{}{}", id, extension));
}

/// The tables of captures of one plan, in the order in which they are named.
Result<Response> joined_lengths(CaptureService& captures, const Request& request) {
  AXIOMETRY_TRY(const Value body, json_body(request));
  const Value* ids = body.find("captures");
  if (ids == nullptr || !ids->is(Kind::array) || ids->items().empty() || ids->items().size() > joined_captures_max)
    return fail(fmt::format("found no captures, expected the numbers of 1 to {}", joined_captures_max), body.at());
  std::optional<app::LengthTask> plan;
  std::string plan_id;
  std::vector<app::CapturedTable> tables;
  for (const Value& item : ids->items()) {
    AXIOMETRY_TRY(const store::Id id, app::given_number("captures", item));
    AXIOMETRY_TRY(const CaptureState state, captures.state(id));
    if (!plan) {
      AXIOMETRY_TRY(plan, captures.task_of(state));
      plan_id = plan->plan_id();
    } else if (!state.lengths || state.lengths->order.plan_id != plan_id) {
      return fail(fmt::format("found capture {} of another plan, expected captures of one plan", id), item.at());
    }
    AXIOMETRY_TRY(std::string table, captures.file_of(state, "lengths"));
    tables.push_back({fmt::format("capture {}", id), std::move(table)});
  }
  AXIOMETRY_TRY(std::string joined, app::joined_tables(*plan, tables));
  return download(std::move(joined), app::media_type_of("csv"), "lengths.csv");
}

Result<Response> discard(CaptureService& captures, const Request& request) {
  AXIOMETRY_TRY(const app::Reader reader, reader_of(request));
  AXIOMETRY_TRY(const store::Id id, id_of(request, "capture"));
  AXIOMETRY_TRY(const CaptureState state, captures.state(id));
  if (!state.lengths && !state.motion)
    return fail(ErrorKind::conflict,
                fmt::format("found capture {} of a test, expected one of lengths or readings", id));
  AXIOMETRY_TRY_VOID(captures.discard(id, request.actor));
  return json_response(app::to_json(state, reader));
}

Result<Response> stop(CaptureService& captures, const Request& request) {
  AXIOMETRY_TRY(const app::Reader reader, reader_of(request));
  AXIOMETRY_TRY(const store::Id id, id_of(request, "capture"));
  AXIOMETRY_TRY(const CaptureState state, captures.stop(id));
  return json_response(app::to_json(state, reader));
}

/// {"key": "take"}
Result<capture::StopKey> stop_key_of(const Value& body) {
  for (const auto& [name, member] : body.members())
    if (name != "key") return fail(fmt::format("found the unknown member \"{}\", expected key", name), member.at());
  AXIOMETRY_TRY(const std::string word, line_member(body, "key"));
  const auto key = app::stop_key(word);
  if (!key) return fail(fmt::format("found the key {}, expected take, skip or undo", text::quoted(word)), body.at());
  return *key;
}

Result<Response> press(CaptureService& captures, const Request& request) {
  AXIOMETRY_TRY(const app::Reader reader, reader_of(request));
  AXIOMETRY_TRY(const store::Id id, id_of(request, "capture"));
  AXIOMETRY_TRY(const Value body, json_body(request));
  AXIOMETRY_TRY(const capture::StopKey key, stop_key_of(body));
  AXIOMETRY_TRY(const CaptureState state, captures.press(id, key));
  return json_response(app::to_json(state, reader));
}

}  // namespace

void add_capture_routes(Router& router, const Context& context) {
  CaptureService& captures = context.captures;
  const auto add = adder(router, captures);
  add("GET", "/api/sources", sources);
  add("GET", "/api/captures", list_captures);
  router.add("POST", "/api/captures", [context](const Request& request) { return post(context, request); },
             Weight::by_size, {.body_max = length_plan_bytes_max});
  add("GET", "/api/captures/{id}", get_capture);
  add("POST", "/api/captures/{id}/stop", stop, Weight::edit);  // waits for what is still to be kept
  add("POST", "/api/captures/parts", length_parts, Weight::by_size,
      {.only_looks = true, .body_max = length_plan_bytes_max});
  add("POST", "/api/captures/lengths", joined_lengths, Weight::heavy, {.only_looks = true});
  add("GET", "/api/captures/{id}/plan", length_plan, Weight::heavy);
  add("GET", "/api/captures/{id}/files/{role}", captured_file, Weight::light);
  add("POST", "/api/captures/{id}/discard", discard, Weight::edit);
  add("POST", "/api/captures/{id}/keys", press, Weight::light);  // somebody stands at a machine that moves on
}

}  // namespace axiometry::server
