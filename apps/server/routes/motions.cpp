// SPDX-License-Identifier: Apache-2.0
// Straightness, angles and squareness that are only looked at.
#include <fmt/format.h>

#include "axiometry/app/results/localised_result.h"
#include "axiometry/app/workbench/calibrations/calibration_json.h"
#include "axiometry/base/text/text.h"
#include "server/http/request_values.h"
#include "server/routes/calibration_form.h"
#include "server/routes/made_documents.h"
#include "server/routes/routes.h"

namespace axiometry::server {
namespace {

/// Without a kind, as the readings are.
Result<app::EvaluatedCalibration> motions_of(const Request& request) {
  AXIOMETRY_TRY(CalibrationForm form, calibration_form_of(request));
  if (!form.about.is(json::Kind::object) || !form.about.members().empty())
    return fail("found the part about in the form, expected it where it is kept");
  if (form.kind.empty() && !form.files.empty()) form.kind = app::motion_kind_of_files(form.files);
  if (!app::is_motion_kind(form.kind))
    return fail(fmt::format("found the kind {}, expected straightness, angles or squareness", text::quoted(form.kind)));
  return app::evaluate_calibration(form.kind, form.files, form.options);
}

Result<Response> motions(const Request& request) {
  AXIOMETRY_TRY(const app::Reader reader, reader_of(request));
  AXIOMETRY_TRY(const app::EvaluatedCalibration evaluated, motions_of(request));
  return json_response(app::localised_result(app::result_of(evaluated), app::ResultKind::motions, reader));
}

Result<Response> motions_report(const Request& request) {
  AXIOMETRY_TRY(const report::Options options, document_options_of(request));
  AXIOMETRY_TRY(const app::EvaluatedCalibration evaluated, motions_of(request));
  if (wants_json(request)) return json_file(app::result_of(evaluated), "motions");
  return document_response(app::document_of(evaluated, options), request, options, "motions");
}

}  // namespace

void add_motion_routes(Router& router) {
  const Terms looked_at{.sent = Sent::files, .only_looks = true, .body_max = calibration_bytes_max};
  router.add("POST", "/api/motions", motions, Weight::heavy, looked_at);
  router.add("POST", "/api/motions/report.{extension}", motions_report, Weight::heavy, looked_at);
}

}  // namespace axiometry::server
