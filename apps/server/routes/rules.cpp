// SPDX-License-Identifier: Apache-2.0
// A kept test by other rules than ISO 230-2:2014; nothing is kept.
#include <fmt/format.h>

#include <algorithm>
#include <cstdint>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "axiometry/app/compare_rules/compare_rules.h"
#include "axiometry/app/evaluate/uncertainty_text.h"
#include "axiometry/app/workbench/withdrawn.h"
#include "axiometry/app/workbench/workbench.h"
#include "axiometry/base/text/text.h"
#include "axiometry/report/rules.h"
#include "axiometry/standards/rules/rule_trials.h"
#include "server/http/request_values.h"
#include "server/routes/made_documents.h"
#include "server/routes/routes.h"

namespace axiometry::server {
namespace {

using app::Workbench;

/// ?standards=vdi-dgq-3441,iso-230-2-2006; all where none is named. Fails on unknown ones and on one named twice.
Result<std::vector<const standards::AxisRule*>> rules_asked_for(const Request& request) {
  std::vector<std::string> ids;
  const std::string_view named = request.parameter("standards").value_or("");
  if (!named.empty())
    for (const std::string_view id : text::split(named, ',')) ids.emplace_back(text::trim(id));
  return app::named_rules(ids);
}

/// &seed=, &coverage= and &type_a= of trials, in the words of the command line.
Result<void> take_drawing(const Request& request, app::UncertaintyOptions& options) {
  using Choose = Result<void> (*)(std::string_view text, app::UncertaintyOptions & options);
  constexpr std::pair<std::string_view, Choose> choices[] = {
      {"seed", app::choose_seed}, {"coverage", app::choose_coverage}, {"type_a", app::choose_type_a}};
  for (const auto& [name, choose] : choices)
    if (const auto text = request.parameter(name); text && !text->empty())
      if (auto chosen = choose(*text, options); !chosen)
        return fail(fmt::format("{}: {}", name, chosen.error().message));
  return {};
}

/// ?uncertainty=monte-carlo, and how many &trials=, else as many as are usual.
Result<app::UncertaintyOptions> trials_asked_for(const Request& request) {
  constexpr std::int64_t trials_max = 1'000'000;
  app::UncertaintyOptions options;
  const std::string_view method = request.parameter("uncertainty").value_or("");
  AXIOMETRY_TRY(const auto trials, whole_of(request, "trials", trials_max));
  if (method.empty())
    for (const std::string_view name : {"trials", "seed", "coverage", "type_a"})
      if (request.parameter(name))
        return fail(fmt::format("found {} without uncertainty=monte-carlo, expected both", name));
  if (method.empty()) return options;
  if (method != "monte-carlo") return fail(fmt::format("found {}, expected monte-carlo", text::quoted(method)));
  options.monte_carlo = true;
  if (trials) options.trials.propagation.trials = static_cast<std::size_t>(*trials);
  AXIOMETRY_TRY_VOID(take_drawing(request, options));
  options.trials.propagation.on_progress = [stop = request.stop](const uncertainty::Progress&) {
    return !stop.stop_requested();
  };
  return options;
}

/// Every reading is drawn in every trial, and every figure of every rule formed of them: two minutes or so at most.
Result<void> take_share(const Series& series, std::optional<std::size_t>& trials) {
  constexpr std::size_t draws_max = 200'000'000, trials_least = 1'000;
  const std::size_t readings = std::max<std::size_t>(1, series.reading_count());
  if (!trials) trials = std::clamp(draws_max / readings, trials_least, standards::usual_rule_trials);
  if (*trials <= std::max(trials_least, draws_max / readings)) return {};
  return fail(fmt::format("found {} trials of {} readings, expected at most {}", *trials, readings,
                          std::max(trials_least, draws_max / readings)));
}

Result<app::ComparedRules> compared_of(const Workbench& workbench, const Request& request) {
  AXIOMETRY_TRY(const store::Id id, id_of(request, "test"));
  AXIOMETRY_TRY(const auto version, version_of(request));
  AXIOMETRY_TRY(const auto rules, rules_asked_for(request));
  AXIOMETRY_TRY(app::UncertaintyOptions uncertainty, trials_asked_for(request));
  AXIOMETRY_TRY(app::PreparedTest prepared, workbench.prepared(id, version));
  if (uncertainty.monte_carlo)
    AXIOMETRY_TRY_VOID(take_share(prepared.test.series, uncertainty.trials.propagation.trials));
  AXIOMETRY_TRY(app::ComparedRules compared, app::compare_rules_of(std::move(prepared.test), rules, uncertainty));
  auto& assessment = compared.comparison.iso230_2;
  if (prepared.record.withdrawn) assessment = app::labelled_withdrawn(std::move(assessment));
  return compared;
}

Result<Response> test_by_rules(const Workbench& workbench, const Request& request) {
  AXIOMETRY_TRY(const app::Reader reader, reader_of(request));
  AXIOMETRY_TRY(const app::ComparedRules compared, compared_of(workbench, request));
  return json_response(app::to_json(compared, reader));
}

/// A comparison has tables and no figures: a picture of it would be empty.
Result<void> refuse_picture(std::string_view extension) {
  if (extension != "svg" && extension != "png") return {};
  return fail(ErrorKind::not_found,
              fmt::format("found {}, expected html, pdf or csv: there is no figure", text::quoted(extension)));
}

Result<Response> report_of_rules(const Workbench& workbench, const Request& request) {
  AXIOMETRY_TRY_VOID(refuse_picture(text::to_lower(request.segment("extension"))));
  AXIOMETRY_TRY(const report::Options options, document_options_of(request));
  AXIOMETRY_TRY(const app::ComparedRules compared, compared_of(workbench, request));
  const std::string stem = fmt::format("test-{}-by-rules", request.segment("id"));
  if (wants_json(request)) return json_file(app::to_json(compared), stem);
  return document_response(report::compose({compared.test, compared.comparison}, options), request, options, stem);
}

}  // namespace

void add_rule_routes(Router& router, const Context& context) {
  Workbench& workbench = context.workbench;
  const auto add = [&](std::string_view pattern, auto handler) {
    router.add_read("GET", pattern, [&workbench, handler](const Request& request) -> Result<ReadRequest> {
      AXIOMETRY_TRY(const app::UncertaintyOptions uncertainty, trials_asked_for(request));
      return ReadRequest{.load = uncertainty.monte_carlo ? Load::lone : Load::heavy,
                         .answer = [&workbench, handler](const Request& again) { return handler(workbench, again); }};
    });
  };
  add("/api/tests/{id}/rules", test_by_rules);
  add("/api/tests/{id}/rules/report.{extension}", report_of_rules);
}

}  // namespace axiometry::server
