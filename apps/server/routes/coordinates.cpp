// SPDX-License-Identifier: Apache-2.0
// Points from lengths of several stations, and from lengths with angles. Nothing is kept.
#include <fmt/format.h>

#include <algorithm>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "axiometry/app/files/given_text.h"
#include "axiometry/app/results/localised_result.h"
#include "axiometry/app/tracking/coordinates_request.h"
#include "axiometry/base/text.h"
#include "axiometry/language/language.h"
#include "server/http/multipart.h"
#include "server/http/request_values.h"
#include "server/routes/made_documents.h"
#include "server/routes/routes.h"

namespace axiometry::server {
namespace {

using json::Value;

// Seconds of one processor: 200 000 lengths; of a polar reading the answer has what each of its parts tells.
constexpr std::size_t ranges_bytes_max = std::size_t{8} << 20;
constexpr std::size_t polar_bytes_max = std::size_t{2} << 20;

/// What a form of readings holds, with or without nominal points.
struct CoordinatesForm {
  std::vector<app::GivenFile> readings;
  std::optional<app::GivenFile> points;
  Value options;
};

Result<void> take_coordinates_part(CoordinatesForm& form, const FormPart& part, std::string_view readings) {
  if (part.name == "options" && !part.is_file) {
    if (!form.options.is(json::Kind::null)) return fail("found options twice, expected them once");
    AXIOMETRY_TRY(form.options, parsed_options(part.bytes));
    return {};
  }
  const bool is_readings = part.name == readings;
  if (!part.is_file || (!is_readings && part.name != "points"))
    return fail(fmt::format("found the part {} in the form, expected the files {} and points, and options",
                            text::quoted(part.name), readings));
  AXIOMETRY_TRY(std::string name, app::given_file_name(part.file_name));
  if (is_readings) {
    form.readings.push_back({std::move(name), part.bytes});
    return {};
  }
  if (form.points) return fail("found two files points, expected one");
  form.points = app::GivenFile{std::move(name), part.bytes};
  return {};
}

/// `readings` is what the files of readings are called.
Result<CoordinatesForm> coordinates_form(const Request& request, std::string_view readings) {
  const std::string_view type = request.header("content-type").value_or("");
  if (!is_form(type)) return fail(fmt::format("found no form, expected one with the file {}", readings));
  AXIOMETRY_TRY(const auto parts, form_parts(type, request.body));
  CoordinatesForm form;
  for (const FormPart& part : parts) AXIOMETRY_TRY_VOID(take_coordinates_part(form, part, readings));
  if (form.readings.empty()) return fail(fmt::format("found no file {}, expected one", readings));
  return form;
}

Result<std::unique_ptr<app::Multilaterated>> multilaterated(const Request& request) {
  AXIOMETRY_TRY(const CoordinatesForm form, coordinates_form(request, "ranges"));
  if (form.readings.size() > 1) return fail("found two files ranges, expected one");
  return app::multilaterate_given({form.readings.front(), form.points, request.stop}, form.options);
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
  AXIOMETRY_TRY(const CoordinatesForm form, coordinates_form(request, "readings"));
  return app::adjust_polar_given({form.readings, form.points, request.stop}, form.options);
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
