// SPDX-License-Identifier: Apache-2.0
// Compensations: tables by which a control corrects an axis, made from a test, kept, proved by another test.
#include <fmt/format.h>

#include <array>
#include <optional>
#include <string>
#include <utility>

#include "axiometry/app/compensate/compensate_options.h"
#include "axiometry/app/files/given_text.h"
#include "axiometry/app/files/whole_file.h"
#include "axiometry/app/workbench/compensations/compensation_json.h"
#include "axiometry/app/workbench/compensations/compensations.h"
#include "axiometry/app/workbench/equipment_json.h"
#include "axiometry/app/workbench/workbench.h"
#include "axiometry/base/text/text.h"
#include "server/forms/sent_form.h"
#include "server/http/request_values.h"
#include "server/routes/made_documents.h"
#include "server/routes/routes.h"
#include "server/routing/adder.h"

namespace axiometry::server {
namespace {

using app::Workbench;
using json::Value;

constexpr std::size_t table_bytes_max = std::size_t{1} << 20;

constexpr std::array existing_parts = {KnownPart{"existing", PartContent::file},
                                       KnownPart{"options", PartContent::json}, KnownPart{"notes", PartContent::text}};
constexpr KnownForm existing_form{"one with options", "options, notes and one file existing", existing_parts};
constexpr std::array read_parts = {KnownPart{"table", PartContent::file}, KnownPart{"options", PartContent::json},
                                   KnownPart{"notes", PartContent::text}};
constexpr KnownForm read_form{"one with options", "options, notes and one file table", read_parts};

std::optional<app::NamedTable> table_of(const SentForm& form, std::string_view part) {
  const auto file = form.file(part);
  return file ? std::optional(app::NamedTable{file->name, std::string(file->bytes)}) : std::nullopt;
}

Result<app::NewCompensation> new_compensation_of(const Request& request) {
  AXIOMETRY_TRY(const store::Id test, id_of(request, "test"));
  AXIOMETRY_TRY(const auto version, version_of(request));
  AXIOMETRY_TRY(const SentForm form, sent_form(request, existing_form));
  AXIOMETRY_TRY(std::string notes, app::given_text("notes", form.text("notes")));
  return app::NewCompensation{test, version, form.value("options").value_or(Value::object()),
                              table_of(form, "existing"), std::move(notes)};
}

Result<Response> answer_compensation(const Result<app::KeptCompensation>& kept, const Request& request,
                                     int status = 200) {
  if (!kept) return std::unexpected(kept.error());
  AXIOMETRY_TRY(const app::Reader reader, reader_of(request));
  const auto& compensation = kept->head.compensation;
  return kept_response(app::to_json(*kept, reader), {.id = compensation.id, .version = compensation.version}, status);
}

Result<Response> list_controls(Workbench&, const Request& request) {
  AXIOMETRY_TRY(const app::Reader reader, reader_of(request));
  return json_response(app::controls_to_json(reader));
}

Result<Response> read_table(Workbench&, const Request& request) {
  const auto control = nc::axis_table_named(request.segment("control"));
  if (!control) return fail(ErrorKind::not_found, control.error().message);
  AXIOMETRY_TRY(const SentForm form, sent_form(request, read_form));
  AXIOMETRY_TRY_VOID(app::given_text("notes", form.text("notes")));
  const auto table = table_of(form, "table");
  if (!table) return fail("found no file, expected a table");
  AXIOMETRY_TRY(const auto options, app::table_reading_from(form.value("options").value_or(Value::object())));
  AXIOMETRY_TRY(const Value read, app::in_file(app::read_table_to_json(**control, options, table->text), table->name));
  return json_response(read);
}

Result<Response> make_table(Workbench& workbench, const Request& request) {
  AXIOMETRY_TRY(const app::NewCompensation wanted, new_compensation_of(request));
  AXIOMETRY_TRY(const app::Reader reader, reader_of(request));
  AXIOMETRY_TRY(const app::MadeCompensation made, app::make_compensation(workbench, wanted));
  return json_response(app::to_json(made, reader));
}

Result<Response> keep_table(Workbench& workbench, const Request& request) {
  AXIOMETRY_TRY(const app::NewCompensation wanted, new_compensation_of(request));
  const auto kept = app::keep_compensation(workbench, wanted, by_of(request));
  AXIOMETRY_TRY(Response response, answer_compensation(kept, request, 201));
  response.headers.emplace_back("Location", fmt::format("/api/compensations/{}", kept->head.compensation.id));
  return response;
}

Result<Response> list_compensations(Workbench& workbench, const Request& request) {
  store::CompensationFilter filter;
  AXIOMETRY_TRY(filter.test, id_parameter(request, "test"));
  AXIOMETRY_TRY(filter.axis, id_parameter(request, "axis"));
  AXIOMETRY_TRY(filter.withdrawn, flag_of(request, "withdrawn", false));
  AXIOMETRY_TRY(const auto limit, whole_of(request, "limit", store::largest_page));
  filter.limit = limit.value_or(store::largest_page);
  AXIOMETRY_TRY(const auto listed, app::listed_compensations(workbench.archive(), filter));
  return json_response(app::to_json(listed, {.language = request.language}));
}

Result<Response> get_compensation(Workbench& workbench, const Request& request) {
  AXIOMETRY_TRY(const store::Id id, id_of(request, "compensation"));
  AXIOMETRY_TRY(const auto version, version_of(request));
  AXIOMETRY_TRY(const app::Reader reader, reader_of(request));
  AXIOMETRY_TRY(const app::KeptCompensation kept, app::kept_compensation(workbench.archive(), id, version));
  return json_response(app::to_json(kept, reader));
}

Result<Response> revise_compensation(Workbench& workbench, const Request& request) {
  AXIOMETRY_TRY(const store::Id id, id_of(request, "compensation"));
  AXIOMETRY_TRY(const Value body, json_body(request));
  AXIOMETRY_TRY(const app::CompensationRevision revision, app::compensation_revision_from(body));
  return answer_compensation(app::revise_compensation(workbench, id, revision, by_of(request, revision.reason)),
                             request, 201);
}

Result<Response> withdraw_compensation(Workbench& workbench, const Request& request, bool withdrawn) {
  AXIOMETRY_TRY(const store::Id id, id_of(request, "compensation"));
  AXIOMETRY_TRY(const Value body, optional_json_body(request));
  AXIOMETRY_TRY(std::string reason, app::reason_from(body));
  return answer_compensation(
      app::withdraw_compensation(workbench.archive(), id, withdrawn, by_of(request, std::move(reason))), request);
}

Result<Response> compensation_file(Workbench& workbench, const Request& request) {
  AXIOMETRY_TRY(const store::Id id, id_of(request, "compensation"));
  AXIOMETRY_TRY(app::Rendered file,
                app::compensation_file(workbench.archive(), id, std::string(request.segment("role"))));
  return download(std::move(file.bytes), file.media_type, file.file_name);
}

Result<Response> compensation_report(Workbench& workbench, const Request& request) {
  AXIOMETRY_TRY(const store::Id id, id_of(request, "compensation"));
  AXIOMETRY_TRY(const auto version, version_of(request));
  AXIOMETRY_TRY(const app::ReportRequest wanted, report_request_of(request));
  AXIOMETRY_TRY(app::Rendered rendered, app::compensation_report(workbench, id, version, wanted));
  return rendered_response(std::move(rendered), request);
}

}  // namespace

void add_compensation_routes(Router& router, const Context& context) {
  const auto add = adder(router, context.workbench);
  const Terms looks{.sent = Sent::files, .only_looks = true, .body_max = table_bytes_max};
  add("GET", "/api/controls", list_controls);
  add("POST", "/api/controls/{control}/table", read_table, Weight::heavy, looks);
  add("POST", "/api/tests/{id}/compensation", make_table, Weight::heavy, looks);
  add("POST", "/api/tests/{id}/compensations", keep_table, Weight::heavy,
      {.sent = Sent::files, .body_max = table_bytes_max});
  add("GET", "/api/compensations", list_compensations);
  add("GET", "/api/compensations/{id}", get_compensation);
  add("POST", "/api/compensations/{id}/versions", revise_compensation, Weight::heavy);
  const auto set_withdrawn = [](bool withdrawn) {
    return [withdrawn](Workbench& w, const Request& r) { return withdraw_compensation(w, r, withdrawn); };
  };
  add("POST", "/api/compensations/{id}/withdraw", set_withdrawn(true), Weight::edit);
  add("POST", "/api/compensations/{id}/reinstate", set_withdrawn(false), Weight::edit);
  add("GET", "/api/compensations/{id}/files/{role}", compensation_file);
  add("GET", "/api/compensations/{id}/report.{extension}", compensation_report, Weight::heavy);
}

}  // namespace axiometry::server
