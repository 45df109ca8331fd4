// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <algorithm>
#include <memory>
#include <string>

#include "axiometry/app/files/file_name_part.h"
#include "axiometry/app/files/given_text.h"
#include "axiometry/app/plan/nc_program.h"
#include "axiometry/app/plan/plan_request.h"
#include "axiometry/app/workbench/workbench_values.h"
#include "axiometry/base/text/number_text.h"
#include "axiometry/base/text/text.h"
#include "axiometry/digest/sha256.h"
#include "axiometry/report/shown_number.h"
#include "server/http/request_values.h"
#include "server/routes/routes.h"

namespace axiometry::server {
namespace {

using json::Kind;
using json::Value;
using store::PlanRecord;
using VersionedPlan = store::Versioned<PlanRecord>;

Result<std::optional<store::Id>> number_member(const Value& body, std::string_view name) {
  const Value* value = body.find(name);
  if (value == nullptr || value->is(Kind::null)) return std::optional<store::Id>();
  AXIOMETRY_TRY(const store::Id number, app::given_number(name, *value));
  return std::optional(number);
}

/// What the user calls it, or its axis and travel.
Result<std::string> title_for(const Value& body, const Plan& plan) {
  AXIOMETRY_TRY(std::string given, line_member(body, "title"));
  if (!given.empty()) return given;
  const report::Options plain;
  return app::given_line(
      "title", fmt::format("{}{}{} to {} {}", plan.machine.empty() ? "" : plan.machine + ", ",
                           plan.axis.name.empty() ? "" : plan.axis.name + " ",
                           report::shown_short(plan.targets.front().in_native(), plain),
                           report::shown_short(plan.targets.back().in_native(), plain), position_unit(plan.axis.kind)));
}

/// What every list of plans says of one.
Value row_value(const VersionedPlan& plan) {
  Value value = Value::object();
  value.add("id", app::id_value(plan.id));
  value.add("version", plan.version);
  value.add("title", plan.value.title);
  value.add("axis", plan.value.axis ? app::id_value(*plan.value.axis) : Value());
  value.add("change", app::to_json(plan.change));
  return value;
}

/// How the answer shall look.
struct Look {
  app::Reader reader;
  bool dark = false;
};

Result<Look> look_of(const Request& request) {
  AXIOMETRY_TRY(const app::Reader reader, reader_of(request));
  return Look{reader, request.parameter("theme") == "dark"};
}

Value plan_value(const VersionedPlan& kept, const app::RequestedPlan& plan, const Look& look) {
  Value value = row_value(kept);
  const Value draft = app::draft_value(plan, look.reader, look.dark);
  for (const auto& [name, member] : draft.members()) value.add(name, member);
  return value;
}

Value rows_value(std::string_view name, const std::vector<VersionedPlan>& plans) {
  Value rows = Value::array();
  for (const VersionedPlan& plan : plans) rows.push(row_value(plan));
  Value value = Value::object();
  value.add(name, std::move(rows));
  return value;
}

/// A kept plan with its content.
struct Kept {
  VersionedPlan record;
  app::RequestedPlan plan;
};

Result<Kept> kept_plan(const store::Store& store, const Request& request) {
  AXIOMETRY_TRY(const store::Id id, id_of(request, "plan"));
  AXIOMETRY_TRY(const auto version, version_of(request));
  AXIOMETRY_TRY(VersionedPlan record, store.get<PlanRecord>(id, version));
  AXIOMETRY_TRY(const store::Content content, store.content(record.value.content));
  AXIOMETRY_TRY(app::RequestedPlan plan, app::read_requested(content.bytes));
  return Kept{std::move(record), std::move(plan)};
}

Result<PlanRecord> record_of(store::Store& store, const Value& body, const app::RequestedPlan& plan,
                             const store::By& by) {
  AXIOMETRY_TRY(const auto axis, number_member(body, "axis"));
  AXIOMETRY_TRY(std::string title, title_for(body, plan.planned.plan));
  const std::string bytes = app::write_requested(plan);
  const store::Content content{.sha256 = sha256(bytes),
                               .file_name = app::file_name_part(title) + ".plan.json",
                               .format = "axiometry-plan",
                               .bytes = bytes};
  AXIOMETRY_TRY(std::string kept, store.keep(content, by));
  return PlanRecord{std::move(title), axis, std::move(kept)};
}

Result<store::By> by_with_reason(const Request& request, const Value& body) {
  AXIOMETRY_TRY(std::string reason, line_member(body, "reason"));
  return by_of(request, std::move(reason));
}

Result<Response> program_response(const Plan& plan, const std::vector<std::pair<std::string, std::string>>& texts,
                                  bool to_keep) {
  constexpr std::string_view of_the_request[] = {"dialect", "part", "version", "language", "download"};
  app::NcRequest wanted;
  std::vector<std::pair<std::string, std::string>> options;
  for (const auto& [name, text] : texts) {
    if (name == "dialect") wanted.dialect = text;
    if (std::ranges::find(of_the_request, std::string_view(name)) == std::end(of_the_request))
      options.emplace_back(name, text);
    if (name != "part" || text.empty()) continue;
    const auto part = parse_count(text);
    if (!part) return fail(fmt::format("part: found {}, expected a whole number from 1", text::quoted(text)));
    wanted.part = *part;
  }
  AXIOMETRY_TRY(wanted.options, app::nc_options(options));
  AXIOMETRY_TRY(const nc::Dialect* const dialect, app::dialect_of(wanted.dialect));
  AXIOMETRY_TRY(std::string program, app::nc_program_of(plan, wanted));
  if (!to_keep)
    return Response{.content_type = "text/plain; charset=utf-8",
                    .body = std::move(program),
                    .headers = {{"Cache-Control", "no-store"}}};
  const std::string name =
      app::file_name_part(fmt::format("{}{}", plan.axis.name.empty() ? "axis" : plan.axis.name,
                                      wanted.part == 1 ? "" : fmt::format("-part-{}", wanted.part)));
  return download(std::move(program), "text/plain; charset=utf-8", fmt::format("{}{}", name, dialect->extension));
}

Result<Response> sheet_response(const app::RequestedPlan& plan, const Request& request) {
  AXIOMETRY_TRY(const bool to_keep, flag_of(request, "download", false));
  AXIOMETRY_TRY(const report::Options options, report_options_of(request));
  const std::string extension = text::to_lower(request.segment("extension"));
  AXIOMETRY_TRY(std::string bytes, app::plan_sheet_file(plan.planned, extension, options));
  const std::string_view type = app::media_type_of(extension);
  if (!to_keep) {
    Response response{
        .content_type = std::string(type), .body = std::move(bytes), .headers = {{"Cache-Control", "no-store"}}};
    if (extension == "html" || extension == "svg")
      response.headers.emplace_back("Content-Security-Policy", document_policy);
    return response;
  }
  const Plan& sheet = plan.planned.plan;
  return download(
      std::move(bytes), type,
      fmt::format("plan-{}.{}", app::file_name_part(sheet.axis.name.empty() ? "axis" : sheet.axis.name), extension));
}

/// A request may stand alone where nothing else is asked.
Result<app::RequestedPlan> draft_of(const Value& body) {
  const bool bare = body.find("request") == nullptr && body.find("plan") == nullptr;
  return bare ? app::requested_plan_of(body) : app::requested_plan(body);
}

/// Of what is shown of a plan that was made or read already: its readings tell what that costs.
template <typename Show>
ReadRequest reading_of(const Plan& plan, Show show) {
  constexpr std::size_t light_readings = 5'000;
  const Load load = app::planned_readings(plan) > light_readings ? Load::heavy : Load::light;
  return {.load = load, .answer = std::move(show)};
}

Result<ReadRequest> read_draft_request(const Request& request) {
  AXIOMETRY_TRY(const Value body, json_body(request));
  AXIOMETRY_TRY(app::RequestedPlan plan, draft_of(body));
  AXIOMETRY_TRY(const Look look, look_of(request));
  const auto shared = std::make_shared<const app::RequestedPlan>(std::move(plan));
  return reading_of(shared->planned.plan, [shared, look](const Request&) -> Result<Response> {
    return json_response(app::draft_value(*shared, look.reader, look.dark));
  });
}

Result<ReadRequest> read_program_request(const Request& request) {
  AXIOMETRY_TRY(const Value body, json_body(request));
  AXIOMETRY_TRY(app::RequestedPlan plan, app::requested_plan(body));
  AXIOMETRY_TRY(auto texts, options_member(body));
  AXIOMETRY_TRY(const std::string dialect, line_member(body, "dialect"));
  texts.emplace_back("dialect", dialect);
  AXIOMETRY_TRY(const bool to_keep, flag_of(request, "download", false));
  const auto shared = std::make_shared<const app::RequestedPlan>(std::move(plan));
  return reading_of(shared->planned.plan, [shared, texts, to_keep](const Request&) {
    return program_response(shared->planned.plan, texts, to_keep);
  });
}

void add_draft_routes(Router& router) {
  constexpr Terms only_looks{.only_looks = true};
  router.add_read("POST", "/api/plans/draft", read_draft_request, only_looks);
  router.add_read("POST", "/api/plans/draft/program", read_program_request, only_looks);
  router.add(
      "POST", "/api/plans/draft/sheet.{extension}",
      [](const Request& request) -> Result<Response> {
        AXIOMETRY_TRY(const Value body, json_body(request));
        AXIOMETRY_TRY(const app::RequestedPlan plan, app::requested_plan(body));
        return sheet_response(plan, request);
      },
      Weight::heavy, only_looks);
}

void add_writing_routes(Router& router, store::Store& store) {
  router.add(
      "POST", "/api/plans",
      [&store](const Request& request) -> Result<Response> {
        AXIOMETRY_TRY(const Value body, json_body(request));
        AXIOMETRY_TRY(const Look look, look_of(request));
        AXIOMETRY_TRY(const app::RequestedPlan plan, app::requested_plan(body));
        AXIOMETRY_TRY(const store::By by, by_with_reason(request, body));
        AXIOMETRY_TRY(const PlanRecord record, record_of(store, body, plan, by));
        AXIOMETRY_TRY(const VersionedPlan kept, store.add(record, by));
        return kept_response(plan_value(kept, plan, look), {.id = kept.id, .version = kept.version}, 201);
      },
      Weight::edit);
  router.add(
      "PUT", "/api/plans/{id}",
      [&store](const Request& request) -> Result<Response> {
        AXIOMETRY_TRY(const store::Id id, id_of(request, "plan"));
        AXIOMETRY_TRY(const Value body, json_body(request));
        AXIOMETRY_TRY(const Look look, look_of(request));
        const Value* const base = body.find("base_version");
        if (base == nullptr) return fail("found no base_version, expected the version that was edited", body.at());
        AXIOMETRY_TRY(const int base_version, app::given_version("base_version", *base));
        AXIOMETRY_TRY(const app::RequestedPlan plan, app::requested_plan(body));
        AXIOMETRY_TRY(const store::By by, by_with_reason(request, body));
        AXIOMETRY_TRY(const PlanRecord record, record_of(store, body, plan, by));
        AXIOMETRY_TRY(const VersionedPlan kept, store.change(id, base_version, record, by));
        return kept_response(plan_value(kept, plan, look), {.id = kept.id, .version = kept.version});
      },
      Weight::edit);
}

void add_reading_routes(Router& router, const store::Store& store) {
  router.add("GET", "/api/plans", [&store](const Request&) -> Result<Response> {
    AXIOMETRY_TRY(const auto plans, store.all<PlanRecord>());
    return json_response(rows_value("plans", plans));
  });
  router.add_read("GET", "/api/plans/{id}", [&store](const Request& request) -> Result<ReadRequest> {
    AXIOMETRY_TRY(Kept kept, kept_plan(store, request));
    AXIOMETRY_TRY(const Look look, look_of(request));
    const auto shared = std::make_shared<const Kept>(std::move(kept));
    return reading_of(shared->plan.planned.plan, [shared, look](const Request&) -> Result<Response> {
      return json_response(plan_value(shared->record, shared->plan, look));
    });
  });
  router.add("GET", "/api/plans/{id}/versions", [&store](const Request& request) -> Result<Response> {
    AXIOMETRY_TRY(const store::Id id, id_of(request, "plan"));
    AXIOMETRY_TRY(const auto versions, store.versions<PlanRecord>(id));
    return json_response(rows_value("versions", versions));
  });
  router.add_read("GET", "/api/plans/{id}/plan.json", [&store](const Request& request) -> Result<ReadRequest> {
    AXIOMETRY_TRY(Kept kept, kept_plan(store, request));
    const auto shared = std::make_shared<const Kept>(std::move(kept));
    return reading_of(shared->plan.planned.plan, [shared](const Request&) -> Result<Response> {
      return download(json::dump(app::plan_to_json(shared->plan.planned)) + "\n", "application/json",
                      app::file_name_part(shared->record.value.title) + ".plan.json");
    });
  });
  router.add(
      "GET", "/api/plans/{id}/sheet.{extension}",
      [&store](const Request& request) -> Result<Response> {
        AXIOMETRY_TRY(const Kept kept, kept_plan(store, request));
        return sheet_response(kept.plan, request);
      },
      Weight::heavy);
  router.add_read("GET", "/api/plans/{id}/program", [&store](const Request& request) -> Result<ReadRequest> {
    AXIOMETRY_TRY(Kept kept, kept_plan(store, request));
    AXIOMETRY_TRY(const bool to_keep, flag_of(request, "download", false));
    const auto shared = std::make_shared<const Kept>(std::move(kept));
    return reading_of(shared->plan.planned.plan, [shared, to_keep](const Request& again) {
      return program_response(shared->plan.planned.plan, again.query, to_keep);
    });
  });
}

}  // namespace

void add_plan_routes(Router& router, const Context& context) {
  add_draft_routes(router);
  add_reading_routes(router, context.store);
  add_writing_routes(router, context.store);
}

}  // namespace axiometry::server
