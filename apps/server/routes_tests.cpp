// SPDX-License-Identifier: Apache-2.0
// Tests: looking at files, keeping them, evaluating them anew, their reports, figures and documents.
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <memory>
#include <mutex>
#include <utility>

#include "axiometry/app/examples.h"
#include "axiometry/app/given_text.h"
#include "axiometry/app/wire_equipment.h"
#include "axiometry/app/wire_workbench.h"
#include "axiometry/app/workbench.h"
#include "axiometry/base/number_text.h"
#include "axiometry/base/text.h"
#include "axiometry/formats/json_members.h"
#include "request_values.h"
#include "routes.h"

namespace axiometry::server {
namespace {

using app::Workbench;
using json::Value;
using Order = store::TestFilter::Order;

constexpr std::array orders = {
    std::pair{std::string_view("received"), Order::received},
    std::pair{std::string_view("measured"), Order::measured},
    std::pair{std::string_view("title"), Order::title},
    std::pair{std::string_view("machine"), Order::machine},
    std::pair{std::string_view("A"), Order::A},
    std::pair{std::string_view("E"), Order::E},
    std::pair{std::string_view("R"), Order::R},
    std::pair{std::string_view("B"), Order::B},
};

Result<store::TestFilter> filter_of(const Request& request) {
  constexpr std::int64_t limit_max = 1000;
  store::TestFilter filter;
  const auto text = [&](std::string_view name) { return std::string(request.parameter(name).value_or("")); };
  filter.text = text("text");
  AXIOMETRY_TRY(filter.measured_from, date_of(request, "from"));
  AXIOMETRY_TRY(filter.measured_to, date_of(request, "to"));
  filter.verdict = text("verdict");
  filter.sha256 = text("sha256");
  AXIOMETRY_TRY(filter.machine, whole_of(request, "machine", store::id_max));
  AXIOMETRY_TRY(filter.axis, whole_of(request, "axis", store::id_max));
  AXIOMETRY_TRY(filter.instrument, whole_of(request, "instrument", store::id_max));
  AXIOMETRY_TRY(filter.withdrawn, flag_of(request, "withdrawn", false));
  AXIOMETRY_TRY(filter.descending, flag_of(request, "descending", true));
  AXIOMETRY_TRY(const auto offset, whole_of(request, "offset", store::id_max));
  AXIOMETRY_TRY(const auto limit, whole_of(request, "limit", limit_max));
  filter.offset = offset.value_or(0);
  filter.limit = limit.value_or(filter.limit);
  const std::string order = text("order");
  if (order.empty()) return filter;
  const auto row = std::ranges::find(orders, order, &std::pair<std::string_view, Order>::first);
  if (row == orders.end())
    return fail(fmt::format("found the order {}, expected received, measured, title, machine, A, E, R or B",
                            text::quoted(order)));
  filter.order = row->second;
  return filter;
}

Result<app::ReportRequest> report_request(const Request& request, std::string extension) {
  AXIOMETRY_TRY(const report::Options options, report_options_of(request));
  return app::ReportRequest{std::move(extension), options, request.language};
}

/// To look at: what could run scripts is shut into a sandbox.
Response shown(app::Rendered rendered) {
  Response response{.content_type = rendered.media_type, .body = std::move(rendered.bytes)};
  const bool is_document = rendered.media_type.starts_with("text/html") || rendered.media_type == "image/svg+xml";
  if (is_document) response.headers.emplace_back("Content-Security-Policy", document_policy);
  return response;
}

Response kept_as_file(app::Rendered rendered) {
  return download(std::move(rendered.bytes), rendered.media_type, rendered.file_name);
}

Result<Response> answer_test(Result<app::KeptTest> kept, const Request& request, int status = 200) {
  AXIOMETRY_TRY(const app::Reader reader, reader_of(request));
  AXIOMETRY_TRY(const app::KeptTest test, std::move(kept));
  return json_response(app::to_json(test, reader), status);
}

app::Upload upload_of(const SentFile& file) {
  return {.name = file.name, .bytes = file.bytes, .profile = file.profile};
}

Result<Response> preview(const Workbench& workbench, const Request& request) {
  AXIOMETRY_TRY(const app::Reader reader, reader_of(request));
  AXIOMETRY_TRY(const SentFile file, file_of(request));
  AXIOMETRY_TRY(const app::Preview preview, workbench.preview(upload_of(file)));
  return json_response(app::to_json(preview, reader));
}

Result<Response> evaluate(const Workbench& workbench, const Request& request) {
  AXIOMETRY_TRY(const app::Reader reader, reader_of(request));
  AXIOMETRY_TRY(const SentFile file, file_of(request));
  app::Draft draft;
  if (const auto text = request.parameter("draft")) {
    AXIOMETRY_TRY(const Value value, json::parse(*text));
    AXIOMETRY_TRY(draft, app::draft_from(value));
  }
  AXIOMETRY_TRY(const app::Outcome outcome,
                workbench.evaluate(upload_of(file), draft, std::string(request.parameter("test").value_or(""))));
  return json_response(app::to_json(outcome, reader));
}

Result<Response> receive(Workbench& workbench, const Request& request) {
  AXIOMETRY_TRY(const app::Reader reader, reader_of(request));
  AXIOMETRY_TRY(const auto plan, whole_of(request, "plan", store::id_max));
  AXIOMETRY_TRY(const auto files, files_of(request));
  std::vector<app::Upload> uploads;
  for (const SentFile& file : files) {
    uploads.push_back(upload_of(file));
    uploads.back().plan = plan;
  }
  AXIOMETRY_TRY(const app::Received received, workbench.receive(uploads, by_of(request)));
  Response response = json_response(app::to_json(received, reader), 201);
  response.headers.emplace_back("Location", fmt::format("/api/tests/{}", received.tests.front().id));
  return response;
}

/// One at a time: the second to ask at once finds what the first has loaded.
Result<Response> load_examples(Workbench& workbench, std::mutex& turn) {
  const std::lock_guard lock(turn);
  AXIOMETRY_TRY(const std::size_t count, app::add_examples(workbench));
  if (count == 0)
    return fail(ErrorKind::conflict, "found an archive that holds something, expected an empty one for the examples");
  Value object = Value::object();
  object.add("tests", count);
  return json_response(object, 201);
}

Result<Response> list_tests(const Workbench& workbench, const Request& request) {
  AXIOMETRY_TRY(const app::Reader reader, reader_of(request));
  AXIOMETRY_TRY(const store::TestFilter filter, filter_of(request));
  AXIOMETRY_TRY(const store::TestPage page, workbench.archive().tests(filter));
  return json_response(app::to_json(page, reader));
}

Result<Response> one(const Workbench& workbench, const Request& request) {
  AXIOMETRY_TRY(const store::Id id, id_of(request, "test"));
  AXIOMETRY_TRY(const auto version, version_of(request));
  return answer_test(workbench.test(id, version), request);
}

Result<Response> raw(const Workbench& workbench, const Request& request) {
  AXIOMETRY_TRY(const store::Id id, id_of(request, "test"));
  AXIOMETRY_TRY(app::Rendered rendered, workbench.raw(id));
  return kept_as_file(std::move(rendered));
}

Result<Response> draft(const Workbench& workbench, const Request& request) {
  AXIOMETRY_TRY(const store::Id id, id_of(request, "test"));
  AXIOMETRY_TRY(const app::Reader reader, reader_of(request));
  AXIOMETRY_TRY(const Value body, json_body(request));
  AXIOMETRY_TRY(const app::Draft draft, app::draft_from(body));
  AXIOMETRY_TRY(const app::Outcome outcome, workbench.draft(id, draft));
  return json_response(app::to_json(outcome, reader));
}

Result<Response> revise(Workbench& workbench, const Request& request) {
  AXIOMETRY_TRY(const store::Id id, id_of(request, "test"));
  AXIOMETRY_TRY(const Value body, json_body(request));
  AXIOMETRY_TRY(const app::Revision revision, app::revision_from(body));
  return answer_test(workbench.revise(id, revision, by_of(request, revision.reason)), request, 201);
}

Result<Response> withdraw(Workbench& workbench, const Request& request, bool withdrawn) {
  AXIOMETRY_TRY(const store::Id id, id_of(request, "test"));
  AXIOMETRY_TRY(const Value body, optional_json_body(request));
  AXIOMETRY_TRY(std::string reason, app::reason_from(body));
  return answer_test(workbench.withdraw(id, withdrawn, by_of(request, std::move(reason))), request);
}

Result<Response> report(const Workbench& workbench, const Request& request) {
  AXIOMETRY_TRY(const store::Id id, id_of(request, "test"));
  AXIOMETRY_TRY(const auto version, version_of(request));
  AXIOMETRY_TRY(const bool as_file, flag_of(request, "download", false));
  AXIOMETRY_TRY(const auto wanted, report_request(request, std::string(request.segment("extension"))));
  AXIOMETRY_TRY(app::Rendered rendered, workbench.report(id, version, wanted));
  return as_file ? kept_as_file(std::move(rendered)) : shown(std::move(rendered));
}

Result<Response> figures(const Workbench& workbench, const Request& request) {
  AXIOMETRY_TRY(const store::Id id, id_of(request, "test"));
  AXIOMETRY_TRY(const auto version, version_of(request));
  AXIOMETRY_TRY(const auto wanted, report_request(request, "svg"));
  AXIOMETRY_TRY(const auto titles, workbench.figures(id, version, wanted));
  Value object = Value::object();
  Value& rows = object.add("figures", Value::array());
  for (std::size_t k = 0; k < titles.size(); ++k) {
    Value& row = rows.push(Value::object());
    row.add("id", k + 1);
    row.add("title", titles[k]);
  }
  return json_response(object);
}

Result<Response> figure(const Workbench& workbench, const Request& request) {
  AXIOMETRY_TRY(const store::Id id, id_of(request, "test"));
  AXIOMETRY_TRY(const auto version, version_of(request));
  AXIOMETRY_TRY(const auto wanted, report_request(request, "svg"));
  const auto number = parse_count(request.segment("n"));
  if (!number || *number == 0)
    return fail(ErrorKind::not_found, fmt::format("found no figure {}", text::quoted(request.segment("n"))));
  const bool dark = request.parameter("theme") == "dark";
  AXIOMETRY_TRY(std::string svg, workbench.figure(id, version, *number - 1, dark, wanted));
  return shown({std::move(svg), "image/svg+xml", {}});
}

/// {"extension", "language", "decimal", "unit", "version", "reason"}
Result<Response> issue(Workbench& workbench, const Request& request) {
  AXIOMETRY_TRY(const store::Id id, id_of(request, "test"));
  AXIOMETRY_TRY(const Value body, json_body(request));
  AXIOMETRY_TRY(auto members, formats::JsonMembers::of(body, "request"));
  std::string extension, tag, decimal, unit, reason;
  AXIOMETRY_TRY(const Value* given, members.required("extension"));
  AXIOMETRY_TRY(extension, formats::text_in(*given, "extension"));
  AXIOMETRY_TRY_VOID(members.take("language", tag));
  AXIOMETRY_TRY_VOID(members.take("decimal", decimal));
  AXIOMETRY_TRY_VOID(members.take("unit", unit));
  AXIOMETRY_TRY_VOID(members.take("reason", reason));
  AXIOMETRY_TRY(reason, app::given_line("reason", reason));
  std::optional<int> version;
  if (const Value* number = members.optional("version")) {
    AXIOMETRY_TRY(version, app::given_version("version", *number));
  }
  AXIOMETRY_TRY_VOID(members.finish());
  Request styled = request;
  if (!tag.empty()) {
    const auto language = language::language_of(tag);
    if (!language) return fail(fmt::format("found the language {}, expected en or de", text::quoted(tag)));
    styled.language = *language;
  }
  AXIOMETRY_TRY(auto wanted, report_request(styled, extension));
  AXIOMETRY_TRY_VOID(choose_number_style(decimal, unit, wanted.options));
  AXIOMETRY_TRY(const store::Document document, workbench.issue(id, version, wanted, by_of(request, reason)));
  return json_response(app::to_json(document), 201);
}

Result<Response> attach(Workbench& workbench, const Request& request) {
  AXIOMETRY_TRY(const store::Id id, id_of(request, "test"));
  AXIOMETRY_TRY(const SentFile file, file_of(request));
  AXIOMETRY_TRY(const store::Document document,
                workbench.attach(id, {file.name, file.media_type, file.bytes}, by_of(request)));
  return json_response(app::to_json(document), 201);
}

/// Always as a file: what somebody attached must not run as part of the page.
Result<Response> document(const Workbench& workbench, const Request& request) {
  AXIOMETRY_TRY(const store::Id id, id_of(request, "document"));
  AXIOMETRY_TRY(app::Rendered rendered, workbench.document(id));
  return kept_as_file(std::move(rendered));
}

}  // namespace

void add_test_routes(Router& router, const Context& context) {
  Workbench& workbench = context.workbench;
  const auto add = [&](std::string_view method, std::string_view pattern, auto handler, Weight weight = Weight::light) {
    router.add(
        method, pattern, [&workbench, handler](const Request& request) { return handler(workbench, request); }, weight);
  };
  add("POST", "/api/preview", preview, Weight::by_size);
  add("POST", "/api/evaluations", evaluate, Weight::by_method);
  add(
      "POST", "/api/examples",
      [turn = std::make_shared<std::mutex>()](Workbench& w, const Request&) { return load_examples(w, *turn); },
      Weight::heavy);
  add("GET", "/api/tests", list_tests);
  add("POST", "/api/tests", receive, Weight::by_size);
  add("GET", "/api/tests/{id}", one);
  add("GET", "/api/tests/{id}/raw", raw);
  add("POST", "/api/tests/{id}/evaluate", draft, Weight::by_method);
  add("POST", "/api/tests/{id}/versions", revise, Weight::by_method);
  add("POST", "/api/tests/{id}/withdraw", [](Workbench& w, const Request& r) { return withdraw(w, r, true); });
  add("POST", "/api/tests/{id}/reinstate", [](Workbench& w, const Request& r) { return withdraw(w, r, false); });
  add("GET", "/api/tests/{id}/report.{extension}", report, Weight::heavy);
  add("GET", "/api/tests/{id}/figures", figures, Weight::heavy);
  add("GET", "/api/tests/{id}/figures/{n}.svg", figure, Weight::heavy);
  add("POST", "/api/tests/{id}/reports", issue, Weight::heavy);
  add("POST", "/api/tests/{id}/attachments", attach);
  add("GET", "/api/documents/{id}", document);
}

}  // namespace axiometry::server
