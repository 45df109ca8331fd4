// SPDX-License-Identifier: Apache-2.0
// Points from lengths of several stations, and from lengths with angles. Nothing is kept.
#include <array>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "axiometry/app/results/localised_result.h"
#include "axiometry/app/tracking/coordinates_request.h"
#include "axiometry/language/language.h"
#include "server/forms/sent_form.h"
#include "server/http/request_values.h"
#include "server/routes/made_documents.h"
#include "server/routes/routes.h"

namespace axiometry::server {
namespace {

using json::Value;

// Seconds of one processor: 200 000 lengths; of a polar reading the answer has what each of its parts tells.
constexpr std::size_t ranges_bytes_max = std::size_t{8} << 20;
constexpr std::size_t polar_bytes_max = std::size_t{2} << 20;

constexpr std::array ranges_parts = {KnownPart{"ranges", PartContent::file}, KnownPart{"points", PartContent::file},
                                     KnownPart{"options", PartContent::json}};
constexpr KnownForm ranges_form{"one with the file ranges", "the files ranges and points, and options", ranges_parts};
constexpr std::array polar_parts = {KnownPart{"readings", PartContent::files}, KnownPart{"points", PartContent::file},
                                    KnownPart{"options", PartContent::json}};
constexpr KnownForm polar_form{"one with the file readings", "the files readings and points, and options", polar_parts};

Result<std::unique_ptr<app::Multilaterated>> multilaterated(const Request& request) {
  AXIOMETRY_TRY(const SentForm form, sent_form(request, ranges_form));
  const auto ranges = form.file("ranges");
  if (!ranges) return fail("found no file ranges, expected one");
  return app::multilaterate_given({*ranges, form.file("points"), request.stop},
                                  form.value("options").value_or(Value()));
}

Result<Response> multilateration(const Request& request) {
  AXIOMETRY_TRY(const app::Reader reader, reader_of(request));
  AXIOMETRY_TRY(const auto found, multilaterated(request));
  return json_response(app::localised_result(app::to_json(*found), app::ResultKind::coordinates, reader));
}

Result<Response> multilateration_report(const Request& request) {
  AXIOMETRY_TRY(const report::Options options, document_options_of(request));
  AXIOMETRY_TRY(const auto found, multilaterated(request));
  if (wants_json(request)) return json_file(app::to_json(*found), "multilateration");
  return document_response(app::compose(*found, options), request, options, "multilateration");
}

Result<Response> multilateration_points(const Request& request) {
  AXIOMETRY_TRY(const auto found, multilaterated(request));
  return download(app::points_csv(*found), app::media_type_of("csv"), "points.csv");
}

Result<Response> multilateration_residuals(const Request& request) {
  AXIOMETRY_TRY(const auto found, multilaterated(request));
  return download(app::residuals_csv(*found), app::media_type_of("csv"), "residuals.csv");
}

Result<std::unique_ptr<app::PolarResult>> adjusted(const Request& request) {
  AXIOMETRY_TRY(const SentForm form, sent_form(request, polar_form));
  const std::vector<app::GivenFile> readings = form.files_named("readings");
  if (readings.empty()) return fail("found no file readings, expected one");
  return app::adjust_polar_given({readings, form.file("points"), request.stop},
                                 form.value("options").value_or(Value()));
}

Result<Response> polar(const Request& request) {
  AXIOMETRY_TRY(const app::Reader reader, reader_of(request));
  AXIOMETRY_TRY(const auto found, adjusted(request));
  // With the names of their files they are no phrases any more.
  for (app::PolarRemark& remark : found->remarks)
    remark.text = language::translated(remark.text, reader.language, reader.numbers);
  return json_response(app::localised_result(app::present(*found, {}).json, app::ResultKind::coordinates, reader));
}

Result<Response> polar_report(const Request& request) {
  AXIOMETRY_TRY(const report::Options options, document_options_of(request));
  AXIOMETRY_TRY(const auto found, adjusted(request));
  const app::Experiment made = app::present(*found, options);
  if (wants_json(request)) return json_file(made.json, "polar");
  return document_response(made.document, request, options, "polar");
}

Result<Response> polar_points(const Request& request) {
  AXIOMETRY_TRY(const auto found, adjusted(request));
  return download(app::polar_points_csv(*found), app::media_type_of("csv"), "points.csv");
}

}  // namespace

void add_coordinates_routes(Router& router) {
  const auto add = [&](std::string_view pattern, auto handler, std::size_t bytes_max) {
    router.add("POST", pattern, handler, Weight::heavy,
               {.sent = Sent::files, .only_looks = true, .body_max = bytes_max});
  };
  add("/api/tracking/multilateration", multilateration, ranges_bytes_max);
  add("/api/tracking/multilateration/report.{extension}", multilateration_report, ranges_bytes_max);
  add("/api/tracking/multilateration/points", multilateration_points, ranges_bytes_max);
  add("/api/tracking/multilateration/residuals", multilateration_residuals, ranges_bytes_max);
  add("/api/tracking/polar", polar, polar_bytes_max);
  add("/api/tracking/polar/report.{extension}", polar_report, polar_bytes_max);
  add("/api/tracking/polar/points", polar_points, polar_bytes_max);
}

}  // namespace axiometry::server
