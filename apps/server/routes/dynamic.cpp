// SPDX-License-Identifier: Apache-2.0
// Recordings of an axis that does not rest at targets: velocity, acceleration, vibrations, even motion. Keep
// nothing.
#include <string>
#include <utility>

#include "axiometry/app/dynamics/dynamic_motion.h"
#include "axiometry/app/files/given_text.h"
#include "axiometry/app/results/localised_result.h"
#include "axiometry/app/results/outputs.h"
#include "server/forms/sent_files.h"
#include "server/forms/sent_form.h"
#include "server/http/request_values.h"
#include "server/routes/made_documents.h"
#include "server/routes/routes.h"

namespace axiometry::server {
namespace {

/// Each takes some hundred bytes while it is evaluated; of a longer recording a part can be asked for.
constexpr std::size_t dynamic_samples_max = 2'000'000;

Result<app::DynamicMotion> motion_of(const Request& request) {
  app::DynamicOptions options;
  if (const auto text = request.parameter("options")) {
    AXIOMETRY_TRY(const json::Value value, parsed_options(*text));
    AXIOMETRY_TRY(options, app::dynamic_options_from(value));
  }
  options.samples_most = dynamic_samples_max;
  options.stop = request.stop;
  AXIOMETRY_TRY(const SentFile file, file_of(request));
  std::string name = "recording";
  if (!file.name.empty()) {
    AXIOMETRY_TRY(name, app::given_file_name(file.name));
  }
  return app::measure_dynamic(app::GivenFile{std::move(name), file.bytes}, options);
}

Result<Response> dynamic(const Request& request) {
  AXIOMETRY_TRY(const app::Reader reader, reader_of(request));
  AXIOMETRY_TRY(const app::DynamicMotion motion, motion_of(request));
  json::Value result = app::localised_result(app::to_json(motion), app::ResultKind::dynamic, reader);
  result.add("curves", app::curves_to_json(motion));
  return json_response(result);
}

Result<Response> dynamic_report(const Request& request) {
  AXIOMETRY_TRY(const report::Options options, document_options_of(request));
  AXIOMETRY_TRY(const app::DynamicMotion motion, motion_of(request));
  if (wants_json(request)) return json_file(app::to_json(motion), "motion");
  return document_response(app::present(motion, options, {.report = true, .json = false}).document, request, options,
                           "motion");
}

Result<Response> samples_table(const Request& request) {
  AXIOMETRY_TRY(const app::DynamicMotion motion, motion_of(request));
  return download(app::series_csv(motion), app::media_type_of("csv"), "series.csv");
}

Result<Response> amplitudes_table(const Request& request) {
  AXIOMETRY_TRY(const app::DynamicMotion motion, motion_of(request));
  return download(app::spectrum_csv(motion), app::media_type_of("csv"), "spectrum.csv");
}

}  // namespace

void add_dynamic_routes(Router& router) {
  constexpr Terms looks_at_recording{.sent = Sent::files, .only_looks = true};
  const auto add = [&](std::string_view pattern, auto handler) {
    router.add("POST", pattern, handler, Weight::heavy, looks_at_recording);
  };
  add("/api/dynamic", dynamic);
  add("/api/dynamic/report.{extension}", dynamic_report);
  add("/api/dynamic/series.csv", samples_table);
  add("/api/dynamic/spectrum.csv", amplitudes_table);
}

}  // namespace axiometry::server
