// SPDX-License-Identifier: Apache-2.0
// Tests: looking at files, keeping them, evaluating them anew, their reports, figures and documents.
#include <fmt/format.h>

#include <memory>
#include <mutex>
#include <utility>

#include "axiometry/app/files/given_text.h"
#include "axiometry/app/workbench/equipment_json.h"
#include "axiometry/app/workbench/examples/examples.h"
#include "axiometry/app/workbench/workbench.h"
#include "axiometry/app/workbench/workbench_json.h"
#include "axiometry/base/text/number_text.h"
#include "axiometry/base/text/text.h"
#include "axiometry/digest/sha256.h"
#include "axiometry/formats/text/json_members.h"
#include "server/forms/sent_files.h"
#include "server/http/request_values.h"
#include "server/routes/routes.h"
#include "server/routes/test_filter.h"
#include "server/routing/adder.h"

namespace axiometry::server {
namespace {

using app::Workbench;
using json::Value;

Result<app::ReportRequest> report_request(const Request& request, std::string extension) {
  AXIOMETRY_TRY(const report::Options options, report_options_of(request));
  return app::ReportRequest{std::move(extension), options, request.language, request.stop};
}

/// The same for all who ask for the same while nothing changes in the archive: every change adds to its trail.
Result<std::string> key_of(const Workbench& workbench, const Request& request) {
  AXIOMETRY_TRY(const auto newest, workbench.archive().audit({}, 0, 1));
  std::string key = fmt::format("{}\n{}\n{}\n", request.path, newest.empty() ? 0 : newest.front().id,
                                language::tag(request.language));
  for (const auto& [name, value] : request.query) key += fmt::format("{}={}\n", name, value);
  if (!request.body.empty()) key += sha256(request.body);
  return key;
}

Load load_with(bool trials, Load otherwise) { return trials ? Load::lone : otherwise; }

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
  return kept_response(app::to_json(test, reader), {.id = test.record.id, .version = test.record.version}, status);
}

app::Upload upload_of(const SentFile& file) {
  return {.name = file.name, .bytes = file.bytes, .profile = file.profile};
}

Result<Response> preview(const Workbench& workbench, const Request& request) {
  AXIOMETRY_TRY(const app::Reader reader, reader_of(request));
  AXIOMETRY_TRY(const SentFile file, file_of(request));
  AXIOMETRY_TRY(const app::Preview preview, workbench.preview(upload_of(file), request.stop));
  return json_response(app::to_json(preview, reader));
}

Result<Response> evaluate(const Workbench& workbench, const Request& request, const app::Draft& draft) {
  AXIOMETRY_TRY(const app::Reader reader, reader_of(request));
  AXIOMETRY_TRY(const SentFile file, file_of(request));
  AXIOMETRY_TRY(
      const app::Outcome outcome,
      workbench.evaluate(upload_of(file), draft, std::string(request.parameter("test").value_or("")), request.stop));
  return json_response(app::to_json(outcome, reader));
}

Result<ReadRequest> read_evaluation(const Workbench& workbench, const Request& request) {
  app::Draft draft;
  if (const auto text = request.parameter("draft")) {
    AXIOMETRY_TRY(const Value value, json::parse(*text));
    AXIOMETRY_TRY(draft, app::draft_from(value));
  }
  const bool trials = draft.options.monte_carlo;
  return ReadRequest{.load = load_with(trials, Load::heavy),
                     .answer = [&workbench, draft = std::move(draft)](const Request& again) {
                       return evaluate(workbench, again, draft);
                     }};
}

Result<Response> receive(Workbench& workbench, const Request& request) {
  AXIOMETRY_TRY(const app::Reader reader, reader_of(request));
  AXIOMETRY_TRY(const auto plan, id_parameter(request, "plan"));
  AXIOMETRY_TRY(const auto files, files_of(request));
  std::vector<app::Upload> uploads;
  for (const SentFile& file : files) {
    uploads.push_back(upload_of(file));
    uploads.back().plan = plan;
  }
  AXIOMETRY_TRY(const app::Received received, workbench.receive(uploads, by_of(request), request.stop));
  const store::Id first = received.tests.front().id;
  Response response = kept_response(app::to_json(received, reader), {.id = first, .version = 1}, 201);
  response.headers.emplace_back("Location", fmt::format("/api/tests/{}", first));
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
  AXIOMETRY_TRY(const store::TestFilter filter, test_filter_of(request));
  AXIOMETRY_TRY(const store::TestPage page, workbench.archive().tests(filter));
  return json_response(app::to_json(page, reader));
}

Result<Response> one(const Workbench& workbench, const Request& request) {
  AXIOMETRY_TRY(const store::Id id, id_of(request, "test"));
  AXIOMETRY_TRY(const auto version, version_of(request));
  return answer_test(workbench.test(id, version), request);
}

/// What a test of many readings has found is megabytes, which take their time to be read and spelt anew.
Result<ReadRequest> read_one(const Workbench& workbench, const Request& request) {
  constexpr std::size_t light_result_max = std::size_t{256} << 10;
  AXIOMETRY_TRY(const store::Id id, id_of(request, "test"));
  AXIOMETRY_TRY(const auto version, version_of(request));
  AXIOMETRY_TRY(const store::TestRecord record, workbench.archive().test(id, version));
  ReadRequest reading{.answer = [&workbench](const Request& again) { return one(workbench, again); }};
  if (record.state.evaluation.result.size() <= light_result_max) return reading;
  reading.load = Load::heavy;
  AXIOMETRY_TRY(reading.key, key_of(workbench, request));
  return reading;
}

Result<Response> raw(const Workbench& workbench, const Request& request) {
  AXIOMETRY_TRY(const store::Id id, id_of(request, "test"));
  AXIOMETRY_TRY(app::Rendered rendered, workbench.raw(id));
  return kept_as_file(std::move(rendered));
}

Result<ReadRequest> read_draft(const Workbench& workbench, const Request& request) {
  AXIOMETRY_TRY(const store::Id id, id_of(request, "test"));
  AXIOMETRY_TRY(const app::Reader reader, reader_of(request));
  AXIOMETRY_TRY(const Value body, json_body(request));
  AXIOMETRY_TRY(app::Draft draft, app::draft_from(body));
  AXIOMETRY_TRY(std::string key, key_of(workbench, request));
  const bool trials = draft.options.monte_carlo;
  return ReadRequest{
      .load = load_with(trials, Load::heavy),
      .key = std::move(key),
      .answer = [&workbench, id, reader, draft = std::move(draft)](const Request& again) -> Result<Response> {
        AXIOMETRY_TRY(const app::Outcome outcome, workbench.draft(id, draft, again.stop));
        return json_response(app::to_json(outcome, reader));
      }};
}

Result<ReadRequest> read_revision(Workbench& workbench, const Request& request) {
  AXIOMETRY_TRY(const store::Id id, id_of(request, "test"));
  AXIOMETRY_TRY(const Value body, json_body(request));
  AXIOMETRY_TRY(app::Revision revision, app::revision_from(body));
  const bool trials = revision.draft.options.monte_carlo;
  return ReadRequest{.load = load_with(trials, Load::edit),
                     .answer = [&workbench, id, revision = std::move(revision)](const Request& again) {
                       return answer_test(workbench.revise(id, revision, by_of(again, revision.reason), again.stop),
                                          again, 201);
                     }};
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
  const bool is_data = rendered.media_type == "application/json";
  return as_file || is_data ? kept_as_file(std::move(rendered)) : shown(std::move(rendered));
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

/// Of what is shown of a kept version: made once for all who ask at once. A report in JSON is what the version keeps.
template <auto show>
Result<ReadRequest> read_view(const Workbench& workbench, const Request& request) {
  AXIOMETRY_TRY(const store::Id id, id_of(request, "test"));
  AXIOMETRY_TRY(const auto version, version_of(request));
  AXIOMETRY_TRY(bool trials, workbench.runs_trials_for(id, version));
  trials = trials && !text::to_lower(request.path).ends_with("/report.json");
  AXIOMETRY_TRY(std::string key, key_of(workbench, request));
  return ReadRequest{.load = load_with(trials, Load::heavy),
                     .key = std::move(key),
                     .answer = [&workbench](const Request& again) { return show(workbench, again); }};
}

/// A report that is to be kept.
struct Issue {
  store::Id test = 0;
  std::optional<int> version;
  app::ReportRequest wanted;
  std::string reason;
};

/// {"extension", "language", "decimal", "unit", "version", "reason"}
Result<Issue> issue_of(const Request& request) {
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
    AXIOMETRY_TRY(styled.language, language::chosen_language(tag));
  }
  AXIOMETRY_TRY(auto wanted, report_request(styled, extension));
  AXIOMETRY_TRY_VOID(choose_number_style(decimal, unit, wanted.options));
  return Issue{id, version, std::move(wanted), std::move(reason)};
}

Result<ReadRequest> read_issue(Workbench& workbench, const Request& request) {
  AXIOMETRY_TRY(Issue issue, issue_of(request));
  AXIOMETRY_TRY(const bool trials, workbench.runs_trials_for(issue.test, issue.version));
  return ReadRequest{.load = load_with(trials, Load::heavy),
                     .answer = [&workbench, issue = std::move(issue)](const Request& again) -> Result<Response> {
                       app::ReportRequest wanted = issue.wanted;
                       wanted.stop = again.stop;
                       AXIOMETRY_TRY(const store::DocumentRecord document,
                                     workbench.issue(issue.test, issue.version, wanted, by_of(again, issue.reason)));
                       return kept_response(app::to_json(document), {.id = document.id}, 201);
                     }};
}

Result<Response> attach(Workbench& workbench, const Request& request) {
  AXIOMETRY_TRY(const store::Id id, id_of(request, "test"));
  AXIOMETRY_TRY(const SentFile file, file_of(request));
  AXIOMETRY_TRY(const store::DocumentRecord document,
                workbench.attach(id, {file.name, file.media_type, file.bytes}, by_of(request)));
  return kept_response(app::to_json(document), {.id = document.id}, 201);
}

/// Always as a file: what somebody attached must not run as part of the page.
Result<Response> document(const Workbench& workbench, const Request& request) {
  AXIOMETRY_TRY(const store::Id id, id_of(request, "document"));
  AXIOMETRY_TRY(app::Rendered rendered, workbench.document(id));
  return kept_as_file(std::move(rendered));
}

/// By which roles are given, also where the log is refused without any.
Result<Response> temperature_sensors(const Workbench& workbench, const Request& request) {
  AXIOMETRY_TRY(const store::Id id, id_of(request, "document"));
  AXIOMETRY_TRY(const auto sensors, workbench.temperature_sensors(id));
  Value object = Value::object();
  Value& names = object.add("sensors", Value::array());
  for (const std::string& name : sensors) names.push(name);
  return json_response(object);
}

}  // namespace

void add_test_routes(Router& router, const Context& context) {
  constexpr Terms only_looks{.only_looks = true};
  constexpr Terms looks_at_files{.sent = Sent::files, .only_looks = true};
  Workbench& workbench = context.workbench;
  const auto add = adder(router, workbench);
  const auto add_read = [&](std::string_view method, std::string_view pattern, auto reader, const Terms& terms = {}) {
    router.add_read(
        method, pattern, [&workbench, reader](const Request& request) { return reader(workbench, request); }, terms);
  };
  add("POST", "/api/preview", preview, Weight::by_size, looks_at_files);
  add_read("POST", "/api/evaluations", read_evaluation, looks_at_files);
  add(
      "POST", "/api/examples",
      [turn = std::make_shared<std::mutex>()](Workbench& w, const Request&) { return load_examples(w, *turn); },
      Weight::heavy);
  add("GET", "/api/tests", list_tests);
  add("POST", "/api/tests", receive, Weight::by_size, {.sent = Sent::files});
  add_read("GET", "/api/tests/{id}", read_one);
  add("GET", "/api/tests/{id}/raw", raw);
  add_read("POST", "/api/tests/{id}/evaluate", read_draft, only_looks);
  add_read("POST", "/api/tests/{id}/versions", read_revision);
  const auto set_withdrawn = [](bool withdrawn) {
    return [withdrawn](Workbench& w, const Request& r) { return withdraw(w, r, withdrawn); };
  };
  add("POST", "/api/tests/{id}/withdraw", set_withdrawn(true), Weight::edit);
  add("POST", "/api/tests/{id}/reinstate", set_withdrawn(false), Weight::edit);
  add_read("GET", "/api/tests/{id}/report.{extension}", read_view<report>);
  add_read("GET", "/api/tests/{id}/figures", read_view<figures>);
  add_read("GET", "/api/tests/{id}/figures/{n}.svg", read_view<figure>);
  add_read("POST", "/api/tests/{id}/reports", read_issue);
  add("POST", "/api/tests/{id}/attachments", attach, Weight::light, {.sent = Sent::files});
  add("GET", "/api/documents/{id}", document);
  add("GET", "/api/documents/{id}/temperature-sensors", temperature_sensors, Weight::heavy);
}

}  // namespace axiometry::server
