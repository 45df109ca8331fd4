// SPDX-License-Identifier: Apache-2.0
// The tracking interferometer: where it stands, its lines, and what was measured along them. Nothing is kept.
#include <fmt/format.h>

#include <array>
#include <optional>
#include <string>
#include <utility>

#include "axiometry/app/files/file_name_part.h"
#include "axiometry/app/files/given_text.h"
#include "axiometry/app/plan/nc_program.h"
#include "axiometry/app/results/localised_result.h"
#include "axiometry/app/results/outputs.h"
#include "axiometry/app/tracking/evaluate_options.h"
#include "axiometry/app/tracking/tracking_json.h"
#include "axiometry/app/tracking/tracking_request.h"
#include "axiometry/app/workbench/workbench_values.h"
#include "axiometry/base/text/text.h"
#include "axiometry/report/tracking.h"
#include "server/forms/sent_files.h"
#include "server/forms/sent_form.h"
#include "server/http/request_values.h"
#include "server/routes/made_documents.h"
#include "server/routes/routes.h"

namespace axiometry::server {
namespace {

using json::Value;

constexpr std::size_t points_bytes_max = std::size_t{256} << 10;  // thousands of points: six to fifty are measured
constexpr std::size_t lengths_bytes_max = std::size_t{16} << 20;  // the lengths, and a plan of as many readings

Result<std::string> name_of(const SentFile& file, std::string_view otherwise) {
  if (file.name.empty()) return std::string(otherwise);
  return app::given_file_name(file.name);
}

Result<app::Located> located(const Request& request) {
  app::LocateRequest wish;
  if (const auto text = request.parameter("options")) {
    AXIOMETRY_TRY(const Value value, parsed_options(*text));
    AXIOMETRY_TRY(wish, app::locate_request_from(value));
  }
  AXIOMETRY_TRY(const SentFile file, file_of(request));
  AXIOMETRY_TRY(wish.file, name_of(file, "points.csv"));
  return app::locate(wish, file.bytes);
}

Result<Response> station(const Request& request) {
  AXIOMETRY_TRY(const app::Reader reader, reader_of(request));
  AXIOMETRY_TRY(const app::Located found, located(request));
  return json_response(app::localised_result(app::to_json(found), app::ResultKind::findings_beside_all, reader));
}

Result<Response> station_report(const Request& request) {
  AXIOMETRY_TRY(const report::Options options, document_options_of(request));
  AXIOMETRY_TRY(const app::Located found, located(request));
  if (wants_json(request)) return json_file(app::to_json(found), "station");
  return document_response(app::present(found, options).document, request, options, "station");
}

Result<Response> lines(const Request& request) {
  AXIOMETRY_TRY(const app::Reader reader, reader_of(request));
  AXIOMETRY_TRY(const Value body, json_body(request));
  AXIOMETRY_TRY(const app::RequestedLines planned, app::requested_lines(body));
  return json_response(app::lines_value(planned, reader));
}

/// {"request", …}: what is asked about the set-up of a plan.
Result<app::TrackingPlanRequest> wish_of(const Value& body) {
  const Value* request = body.find("request");
  if (request == nullptr) return fail("found no request, expected one", body.at());
  return app::tracking_request_from(*request);
}

Result<Response> advice(const Request& request) {
  AXIOMETRY_TRY(const Value body, json_body(request));
  AXIOMETRY_TRY(const app::TrackingPlanRequest wish, wish_of(body));
  AXIOMETRY_TRY(const app::StationAdvice advice, app::advise_station(wish));
  return json_response(app::advice_value(advice));
}

Result<app::PlannedLocation> planned_points(const Value& body) {
  constexpr double usual_count = 8, count_max = 50;
  AXIOMETRY_TRY(const app::TrackingPlanRequest wish, wish_of(body));
  double count = usual_count;
  if (const Value* given = body.find("count"); given != nullptr && !given->is(json::Kind::null)) {
    AXIOMETRY_TRY(const std::int64_t number, app::given_number("count", *given));
    count = std::min(static_cast<double>(number), count_max + 1);
  }
  return app::plan_location_points(wish, static_cast<std::size_t>(count));
}

Result<Response> points(const Request& request) {
  AXIOMETRY_TRY(const app::Reader reader, reader_of(request));
  AXIOMETRY_TRY(const Value body, json_body(request));
  AXIOMETRY_TRY(const app::PlannedLocation planned, planned_points(body));
  return json_response(app::points_value(planned, reader));
}

Result<Response> points_sheet(const Request& request) {
  AXIOMETRY_TRY(const report::Options options, document_options_of(request));
  AXIOMETRY_TRY(const Value body, json_body(request));
  AXIOMETRY_TRY(const app::PlannedLocation planned, planned_points(body));
  return document_response(app::present(planned, options).document, request, options, "location-points");
}

/// The request or the plan of a body that says more.
Value subject_of(const Value& body) {
  Value subject = Value::object();
  for (const std::string_view name : {"request", "plan"})
    if (const Value* value = body.find(name)) subject.add(name, *value);
  return subject;
}

Result<Response> sheet(const Request& request) {
  AXIOMETRY_TRY(const report::Options options, document_options_of(request));
  AXIOMETRY_TRY(const Value body, json_body(request));
  AXIOMETRY_TRY(const app::RequestedLines planned, app::requested_lines(body));
  const app::PlannedLines& plan = planned.planned;
  return document_response(report::tracking_sheet(plan.plan, plan.duration, options), request, options,
                           "tracking-plan");
}

Result<Response> program(const Request& request) {
  AXIOMETRY_TRY(const bool to_keep, flag_of(request, "download", false));
  AXIOMETRY_TRY(const Value body, json_body(request));
  app::NcRequest wanted;
  AXIOMETRY_TRY(wanted.dialect, line_member(body, "dialect"));
  AXIOMETRY_TRY(wanted.line, line_member(body, "line"));
  AXIOMETRY_TRY(const Pairs options, options_member(body));
  AXIOMETRY_TRY(wanted.options, app::nc_options(options));
  AXIOMETRY_TRY(const nc::Dialect* const dialect, app::dialect_of(wanted.dialect));
  AXIOMETRY_TRY(const app::RequestedLines planned, app::requested_lines(subject_of(body)));
  AXIOMETRY_TRY(std::string program, app::nc_program_of(planned.planned.plan, wanted));
  const std::string stem = wanted.line.empty() ? "lines" : app::file_name_part("line-" + wanted.line);
  return made_text_response(std::move(program), to_keep, stem + std::string(dialect->extension));
}

constexpr std::array evaluation_parts = {KnownPart{"lengths", PartContent::file}, KnownPart{"plan", PartContent::file},
                                         KnownPart{"station", PartContent::file},
                                         KnownPart{"tolerances", PartContent::file},
                                         KnownPart{"options", PartContent::json}};
constexpr KnownForm evaluation_form{"one with the files lengths and plan",
                                    "the files lengths, plan, station and tolerances, and options", evaluation_parts};

Result<app::EvaluatedLines> evaluated(const Request& request) {
  AXIOMETRY_TRY(const SentForm form, sent_form(request, evaluation_form));
  app::TrackingEvaluateOptions options;
  if (const auto given = form.value("options")) {
    AXIOMETRY_TRY(options, app::evaluate_options_from(*given));
  }
  const auto lengths = form.file("lengths"), plan = form.file("plan");
  if (!lengths || !plan)
    return fail(
        fmt::format("found a form without {}, expected the files lengths and plan", lengths ? "a plan" : "lengths"));
  AXIOMETRY_TRY_VOID(app::take_tolerances(form.file("tolerances"), options.tolerance));
  return app::evaluate_presentable({*lengths, *plan, form.file("station")}, options);
}

Result<Response> evaluation(const Request& request) {
  AXIOMETRY_TRY(const app::Reader reader, reader_of(request));
  AXIOMETRY_TRY(const app::EvaluatedLines found, evaluated(request));
  return json_response(app::localised_result(app::to_json(found), app::ResultKind::lines, reader));
}

Result<Response> evaluation_report(const Request& request) {
  AXIOMETRY_TRY(const report::Options options, document_options_of(request));
  AXIOMETRY_TRY(const app::EvaluatedLines found, evaluated(request));
  if (wants_json(request)) return json_file(app::to_json(found), "lines");
  return document_response(app::lines_document(found, options), request, options, "lines");
}

}  // namespace

void add_tracking_routes(Router& router) {
  constexpr Terms looks{.only_looks = true};
  constexpr Terms at_points{.sent = Sent::files, .only_looks = true, .body_max = points_bytes_max};
  constexpr Terms at_lengths{.sent = Sent::files, .only_looks = true, .body_max = lengths_bytes_max};
  const auto add = [&](std::string_view pattern, auto handler, const Terms& terms) {
    router.add("POST", pattern, handler, Weight::heavy, terms);
  };
  add("/api/tracking/station", station, at_points);
  add("/api/tracking/station/report.{extension}", station_report, at_points);
  add("/api/tracking/station/advice", advice, looks);
  add("/api/tracking/points", points, looks);
  add("/api/tracking/points/sheet.{extension}", points_sheet, looks);
  add("/api/tracking/lines", lines, looks);
  add("/api/tracking/lines/program", program, looks);
  add("/api/tracking/lines/sheet.{extension}", sheet, looks);
  add("/api/tracking/evaluation", evaluation, at_lengths);
  add("/api/tracking/evaluation/report.{extension}", evaluation_report, at_lengths);
}

}  // namespace axiometry::server
