// SPDX-License-Identifier: Apache-2.0
// Live captures: what may be listened to, and captures that run.
#include <fmt/format.h>

#include <algorithm>

#include "axiometry/app/files/given_text.h"
#include "axiometry/app/live/capture_keeping.h"
#include "axiometry/app/plan/plan_request.h"
#include "server/http/request_values.h"
#include "server/routes/routes.h"

namespace axiometry::server {
namespace {

using app::CaptureService;
using app::CaptureState;
using json::Kind;
using json::Value;

constexpr std::string_view capture_members[] = {"plan", "source", "layout", "options", "resume"};

Result<void> check_members(const Value& body) {
  for (const auto& [name, value] : body.members())
    if (std::ranges::find(capture_members, std::string_view(name)) == std::end(capture_members))
      return fail(
          fmt::format("found the unknown member \"{}\", expected plan, source, layout and options, or resume", name),
          value.at());
  return {};
}

Result<void> check_writable(const store::Store& store) {
  const store::Info info = store.info();
  if (info.writable) return {};
  return fail(ErrorKind::read_only, fmt::format("found a store that cannot be written: {}", info.why_not));
}

Result<CaptureState> start(const Context& context, const Request& request, const Value& body) {
  const Value* number = body.find("plan");
  if (number == nullptr) return fail("found no plan, expected the number of one", body.at());
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

Result<Response> stop(CaptureService& captures, const Request& request) {
  AXIOMETRY_TRY(const app::Reader reader, reader_of(request));
  AXIOMETRY_TRY(const store::Id id, id_of(request, "capture"));
  AXIOMETRY_TRY(const CaptureState state, captures.stop(id));
  return json_response(app::to_json(state, reader));
}

}  // namespace

void add_capture_routes(Router& router, const Context& context) {
  CaptureService& captures = context.captures;
  router.add("GET", "/api/sources", [&captures](const Request& request) { return sources(captures, request); });
  router.add("GET", "/api/captures", [&captures](const Request& request) { return list_captures(captures, request); });
  router.add("POST", "/api/captures", [context](const Request& request) { return post(context, request); });
  router.add("GET", "/api/captures/{id}",
             [&captures](const Request& request) { return get_capture(captures, request); });
  router.add(
      "POST", "/api/captures/{id}/stop", [&captures](const Request& request) { return stop(captures, request); },
      Weight::edit);  // waits for what is still to be kept
}

}  // namespace axiometry::server
