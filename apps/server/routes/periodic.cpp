// SPDX-License-Identifier: Apache-2.0
// The periodic error of a kept test (Annex C); nothing is kept.
#include <fmt/format.h>

#include <optional>
#include <string>
#include <string_view>
#include <utility>

#include "axiometry/app/periodic/periodic.h"
#include "axiometry/app/workbench/withdrawn.h"
#include "axiometry/app/workbench/workbench.h"
#include "axiometry/report/periodic.h"
#include "server/http/request_values.h"
#include "server/routes/made_documents.h"
#include "server/routes/routes.h"

namespace axiometry::server {
namespace {

using app::Workbench;

/// They take a second or so, and some 30 MB.
constexpr double periods_searched_most = 300'000;

/// ?period=, or ?min_period= and &max_period= of the search.
Result<iso230_2::PeriodicOptions> periods_asked_for(const Request& request) {
  iso230_2::PeriodicOptions options;
  options.lines_most = periods_searched_most;
  const std::pair<std::string_view, std::optional<Position>&> periods[] = {
      {"period", options.period}, {"min_period", options.shortest}, {"max_period", options.longest}};
  for (const auto& [name, period] : periods) {
    const auto text = request.parameter(name);
    if (!text || text->empty()) continue;
    const auto parsed = app::parsed_period(*text);
    if (!parsed) return fail(fmt::format("{}: {}", name, parsed.error().message));
    period = *parsed;
  }
  return options;
}

Result<app::EvaluatedPeriodic> evaluated_of(const Workbench& workbench, const Request& request) {
  AXIOMETRY_TRY(const store::Id id, id_of(request, "test"));
  AXIOMETRY_TRY(const auto version, version_of(request));
  AXIOMETRY_TRY(const auto options, periods_asked_for(request));
  AXIOMETRY_TRY(app::PreparedTest prepared, workbench.prepared(id, version));
  AXIOMETRY_TRY(app::EvaluatedPeriodic evaluated, app::periodic_error_of(std::move(prepared.test), options));
  if (prepared.record.withdrawn) evaluated.result.label = app::labelled_withdrawn(std::move(evaluated.result.label));
  return evaluated;
}

Result<Response> periodic_error(const Workbench& workbench, const Request& request) {
  AXIOMETRY_TRY(const report::Options options, report_options_of(request));
  AXIOMETRY_TRY(const app::EvaluatedPeriodic evaluated, evaluated_of(workbench, request));
  return json_response(app::to_json(evaluated, options, request.parameter("theme") == "dark"));
}

Result<Response> report_of_periodic_error(const Workbench& workbench, const Request& request) {
  AXIOMETRY_TRY(const report::Options options, document_options_of(request));
  AXIOMETRY_TRY(const app::EvaluatedPeriodic evaluated, evaluated_of(workbench, request));
  const std::string stem = fmt::format("test-{}-periodic", request.segment("id"));
  if (wants_json(request)) return json_file(app::to_json(evaluated), stem);
  return document_response(report::compose({evaluated.test, evaluated.result}, options), request, options, stem);
}

}  // namespace

void add_periodic_routes(Router& router, const Context& context) {
  Workbench& workbench = context.workbench;
  const auto add = [&](std::string_view pattern, auto handler) {
    router.add_read("GET", pattern, [&workbench, handler](const Request&) -> Result<ReadRequest> {
      return ReadRequest{.load = Load::heavy,
                         .answer = [&workbench, handler](const Request& again) { return handler(workbench, again); }};
    });
  };
  add("/api/tests/{id}/periodic", periodic_error);
  add("/api/tests/{id}/periodic/report.{extension}", report_of_periodic_error);
}

}  // namespace axiometry::server
