// SPDX-License-Identifier: Apache-2.0
// Calibrations: lines, the 21 errors, straightness, angles and squareness that are kept, evaluated again, compared.
#include <fmt/format.h>

#include <array>
#include <optional>
#include <string>
#include <utility>

#include "axiometry/app/files/given_text.h"
#include "axiometry/app/results/localised_result.h"
#include "axiometry/app/workbench/calibrations/calibration_json.h"
#include "axiometry/app/workbench/calibrations/calibrations.h"
#include "axiometry/app/workbench/equipment_json.h"
#include "axiometry/app/workbench/workbench_json.h"
#include "axiometry/base/text/text.h"
#include "axiometry/store/kept/calibration_kinds.h"
#include "server/http/request_values.h"
#include "server/routes/calibration_form.h"
#include "server/routes/made_documents.h"
#include "server/routes/routes.h"
#include "server/routing/adder.h"

namespace axiometry::server {
namespace {

using json::Value;
using store::Store;
using CalibrationOrder = store::CalibrationFilter::Order;

Result<CalibrationOrder> calibration_order(std::string_view name) {
  constexpr std::array orders = {std::pair{std::string_view("received"), CalibrationOrder::received},
                                 std::pair{std::string_view("measured"), CalibrationOrder::measured},
                                 std::pair{std::string_view("title"), CalibrationOrder::title}};
  for (const auto& [word, order] : orders)
    if (word == name) return order;
  return fail(fmt::format("found the order {}, expected received, measured or title", text::quoted(name)));
}

Result<store::CalibrationFilter> calibration_filter(const Request& request) {
  constexpr std::int64_t limit_max = 1000;
  constexpr std::size_t words_max = 30;
  store::CalibrationFilter filter;
  AXIOMETRY_TRY(filter.text, app::given_line("text", request.parameter("text").value_or("")));
  if (const std::size_t words = text::words(filter.text).size(); words > words_max)
    return fail(fmt::format("found {} words to search for, expected at most {}", words, words_max));
  filter.kind = request.parameter("kind").value_or("");
  if (!filter.kind.empty() && !store::is_calibration_kind(filter.kind))
    return fail(
        fmt::format("found the kind {}, expected {}", text::quoted(filter.kind), store::calibration_kinds_text));
  AXIOMETRY_TRY(filter.machine, id_parameter(request, "machine"));
  AXIOMETRY_TRY(filter.instrument, id_parameter(request, "instrument"));
  AXIOMETRY_TRY(const DateRange dates, dates_of(request));
  filter.measured_from = dates.from;
  filter.measured_to = dates.to;
  AXIOMETRY_TRY(filter.withdrawn, flag_of(request, "withdrawn", false));
  AXIOMETRY_TRY(filter.descending, flag_of(request, "descending", true));
  AXIOMETRY_TRY(filter.order, calibration_order(request.parameter("order").value_or("received")));
  AXIOMETRY_TRY(const auto offset, whole_of(request, "offset", store::id_max));
  AXIOMETRY_TRY(const auto limit, whole_of(request, "limit", limit_max));
  filter.offset = offset.value_or(0);
  filter.limit = limit.value_or(filter.limit);
  return filter;
}

Result<app::NewCalibration> new_calibration_of(const Request& request) {
  AXIOMETRY_TRY(CalibrationForm form, calibration_form_of(request));
  AXIOMETRY_TRY(app::NewCalibration calibration, app::new_calibration_from(form.about));
  calibration.kind = std::move(form.kind);
  calibration.files = std::move(form.files);
  calibration.options = std::move(form.options);
  calibration.stop = request.stop;
  return calibration;
}

Result<Response> answer_calibration(const Result<app::KeptCalibration>& kept, const Request& request,
                                    int status = 200) {
  if (!kept) return std::unexpected(kept.error());
  AXIOMETRY_TRY(const app::Reader reader, reader_of(request));
  const auto& calibration = kept->calibration;
  return kept_response(app::to_json(*kept, reader), {.id = calibration.id, .version = calibration.version}, status);
}

Result<Response> list_calibrations(const Store& store, const Request& request) {
  AXIOMETRY_TRY(const store::CalibrationFilter filter, calibration_filter(request));
  AXIOMETRY_TRY(const store::CalibrationPage page, store.calibrations(filter));
  return json_response(app::to_json(page));
}

Result<Response> keep_calibration(Store& store, const Request& request) {
  AXIOMETRY_TRY(const app::NewCalibration calibration, new_calibration_of(request));
  const auto kept = app::keep_calibration(store, calibration, by_of(request));
  AXIOMETRY_TRY(Response response, answer_calibration(kept, request, 201));
  response.headers.emplace_back("Location", fmt::format("/api/calibrations/{}", kept->calibration.id));
  return response;
}

Result<Response> get_calibration(const Store& store, const Request& request) {
  AXIOMETRY_TRY(const store::Id id, id_of(request, "calibration"));
  AXIOMETRY_TRY(const auto version, version_of(request));
  AXIOMETRY_TRY(const app::Reader reader, reader_of(request));
  AXIOMETRY_TRY(const app::KeptCalibration kept, app::kept_calibration(store, id, version));
  return json_response(app::to_json(kept, reader));
}

Result<Response> revise_calibration(Store& store, const Request& request) {
  AXIOMETRY_TRY(const store::Id id, id_of(request, "calibration"));
  AXIOMETRY_TRY(const Value body, json_body(request));
  AXIOMETRY_TRY(app::CalibrationRevision revision, app::calibration_revision_from(body));
  revision.stop = request.stop;
  return answer_calibration(app::revise_calibration(store, id, revision, by_of(request, revision.reason)), request,
                            201);
}

Result<Response> withdraw_calibration(Store& store, const Request& request, bool withdrawn) {
  AXIOMETRY_TRY(const store::Id id, id_of(request, "calibration"));
  AXIOMETRY_TRY(const Value body, optional_json_body(request));
  AXIOMETRY_TRY(std::string reason, app::reason_from(body));
  return answer_calibration(app::withdraw_calibration(store, id, withdrawn, by_of(request, std::move(reason))),
                            request);
}

Result<Response> calibration_file(const Store& store, const Request& request) {
  AXIOMETRY_TRY(const store::Id id, id_of(request, "calibration"));
  AXIOMETRY_TRY(app::Rendered file, app::calibration_file(store, id, std::string(request.segment("role"))));
  return download(std::move(file.bytes), file.media_type, file.file_name);
}

Result<Response> calibration_report(const Store& store, const Request& request) {
  AXIOMETRY_TRY(const store::Id id, id_of(request, "calibration"));
  AXIOMETRY_TRY(const auto version, version_of(request));
  AXIOMETRY_TRY(const app::ReportRequest wanted, report_request_of(request));
  AXIOMETRY_TRY(app::Rendered rendered, app::calibration_report(store, id, version, wanted));
  return rendered_response(std::move(rendered), request);
}

Result<Response> compare_calibrations(const Store& store, const Request& request) {
  AXIOMETRY_TRY(const store::Id before, id_of(request, "calibration"));
  AXIOMETRY_TRY(const auto after, id_parameter(request, "with"));
  if (!after) return fail("found no other calibration to compare with, expected with=NUMBER");
  AXIOMETRY_TRY(const app::CalibrationComparison comparison, app::compare_calibrations(store, before, *after));
  return json_response(app::to_json(comparison));
}

}  // namespace

void add_calibration_routes(Router& router, const Context& context) {
  const auto add = adder(router, context.store);
  add("GET", "/api/calibrations", list_calibrations);
  add("POST", "/api/calibrations", keep_calibration, Weight::heavy,
      {.sent = Sent::files, .body_max = calibration_bytes_max});
  add("GET", "/api/calibrations/{id}", get_calibration, Weight::heavy);
  add("POST", "/api/calibrations/{id}/versions", revise_calibration, Weight::heavy);
  const auto set_withdrawn = [](bool withdrawn) {
    return [withdrawn](Store& s, const Request& r) { return withdraw_calibration(s, r, withdrawn); };
  };
  add("POST", "/api/calibrations/{id}/withdraw", set_withdrawn(true), Weight::edit);
  add("POST", "/api/calibrations/{id}/reinstate", set_withdrawn(false), Weight::edit);
  add("GET", "/api/calibrations/{id}/files/{role}", calibration_file);
  add("GET", "/api/calibrations/{id}/report.{extension}", calibration_report, Weight::heavy);
  add("GET", "/api/calibrations/{id}/comparison", compare_calibrations, Weight::heavy);
}

}  // namespace axiometry::server
