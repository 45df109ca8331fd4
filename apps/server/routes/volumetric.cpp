// SPDX-License-Identifier: Apache-2.0
// The volumetric calibration: its plan, the errors that lengths tell, the field that they make. Nothing is kept.
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <string>
#include <utility>

#include "axiometry/app/files/file_name_part.h"
#include "axiometry/app/plan/nc_program.h"
#include "axiometry/app/results/localised_result.h"
#include "axiometry/app/results/outputs.h"
#include "axiometry/app/volumetric/field_difference.h"
#include "axiometry/app/volumetric/identify_options.h"
#include "axiometry/app/volumetric/tables/volume_compensation_request.h"
#include "axiometry/app/volumetric/volumetric_request.h"
#include "axiometry/app/workbench/workbench_values.h"
#include "axiometry/base/text/text.h"
#include "axiometry/report/volumetric.h"
#include "server/forms/sent_form.h"
#include "server/http/request_values.h"
#include "server/routes/made_documents.h"
#include "server/routes/routes.h"

namespace axiometry::server {
namespace {

using json::Value;

constexpr std::size_t volume_plan_bytes_max = std::size_t{4} << 20;     // 12 000 points with their ways
constexpr std::size_t volume_lengths_bytes_max = std::size_t{8} << 20;  // 150 000 lengths, a second of one processor
constexpr std::size_t volume_model_bytes_max = std::size_t{32} << 20;   // 1500 coefficients: a million covariances
constexpr std::size_t volume_models_bytes_max = 2 * volume_model_bytes_max;

Result<Response> volume_plan(const Request& request) {
  AXIOMETRY_TRY(const app::Reader reader, reader_of(request));
  AXIOMETRY_TRY(const Value body, json_body(request));
  AXIOMETRY_TRY(const auto planned, app::requested_calibration(body, request.stop));
  return json_response(app::draft_value(planned, reader));
}

Result<Response> volume_sheet(const Request& request) {
  AXIOMETRY_TRY(const report::Options options, document_options_of(request));
  AXIOMETRY_TRY(const Value body, json_body(request));
  AXIOMETRY_TRY(volumetric::CalibrationPlan plan, app::given_calibration(body));
  AXIOMETRY_TRY(const auto planned, volumetric::judge_plan(std::move(plan)));
  return document_response(report::calibration_sheet(planned, options), request, options, "volume-plan");
}

Result<Response> volume_program(const Request& request) {
  AXIOMETRY_TRY(const bool to_keep, flag_of(request, "download", false));
  AXIOMETRY_TRY(const Value body, json_body(request));
  app::NcRequest wanted;
  AXIOMETRY_TRY(wanted.dialect, line_member(body, "dialect"));
  AXIOMETRY_TRY(Pairs options, options_member(body));
  if (const auto part = std::ranges::find(options, "part", [](const auto& pair) { return pair.first; });
      part != options.end()) {
    const auto number = parse_count(part->second);
    if (!number) return fail(fmt::format("part: found {}, expected a whole number", text::quoted(part->second)));
    wanted.part = static_cast<std::size_t>(*number);
    options.erase(part);
  }
  AXIOMETRY_TRY(wanted.options, app::nc_options(options));
  AXIOMETRY_TRY(const nc::Dialect* const dialect, app::dialect_of(wanted.dialect));
  AXIOMETRY_TRY(const volumetric::CalibrationPlan plan, app::given_calibration(body));
  AXIOMETRY_TRY(std::string program, app::nc_program_of(plan, wanted));
  const volumetric::PlannedRun& run = plan.runs[wanted.part - 1];
  const std::string stem =
      app::file_name_part(plan.machine.stations[run.station].name + "-" + plan.machine.tools[run.tool].name);
  return made_text_response(std::move(program), to_keep, stem + std::string(dialect->extension));
}

constexpr std::array identification_parts = {
    KnownPart{"lengths", PartContent::files}, KnownPart{"machine", PartContent::file},
    KnownPart{"plan", PartContent::file}, KnownPart{"options", PartContent::json}};
constexpr KnownForm identification_form{"one with the files lengths and machine",
                                        "the files lengths, machine and plan, and options", identification_parts};

Result<app::IdentifiedMachine> identified(const Request& request) {
  AXIOMETRY_TRY(const SentForm form, sent_form(request, identification_form));
  app::IdentifyChoices choices;
  if (const auto options = form.value("options")) {
    AXIOMETRY_TRY(choices, app::identify_choices_from(*options));
  }
  const app::IdentifyFiles files{form.files_named("lengths"), form.file("machine"), form.file("plan"), request.stop};
  if (files.lengths.empty()) return fail("found no file lengths, expected one");
  if (!files.machine && !files.plan) return fail("found neither a file machine nor a file plan, expected one of them");
  if (files.lengths.size() > app::files_of_lengths_most)
    return fail(fmt::format("found {} files of lengths, expected at most {}", files.lengths.size(),
                            app::files_of_lengths_most));
  return app::identify_presentable(files, choices);
}

Result<Response> identification(const Request& request) {
  AXIOMETRY_TRY(const app::Reader reader, reader_of(request));
  AXIOMETRY_TRY(const app::IdentifiedMachine found, identified(request));
  return json_response(app::localised_result(app::to_json(found), app::ResultKind::volumetric, reader));
}

Result<Response> identification_report(const Request& request) {
  AXIOMETRY_TRY(const report::Options options, document_options_of(request));
  AXIOMETRY_TRY(const app::IdentifiedMachine found, identified(request));
  if (wants_json(request)) return json_file(app::to_json(found), "volume");
  return document_response(app::present(found, options).document, request, options, "volume");
}

Result<Response> residuals(const Request& request) {
  AXIOMETRY_TRY(const app::IdentifiedMachine found, identified(request));
  return download(app::residuals_csv(found), app::media_type_of("csv"), "residuals.csv");
}

constexpr std::array assembly_parts = {KnownPart{"errors", PartContent::files}, KnownPart{"machine", PartContent::file},
                                       KnownPart{"options", PartContent::json}};
constexpr KnownForm assembly_form{"one with the file machine, files errors and options",
                                  "the files errors and machine, and options", assembly_parts};

Result<app::Assembled> assembled(const Request& request) {
  AXIOMETRY_TRY(const SentForm form, sent_form(request, assembly_form));
  const auto machine = form.file("machine");
  if (!machine) return fail("found no file machine, expected one");
  const auto options = form.value("options");
  if (!options) return fail("found no options, expected them: they say which errors are given");
  return app::assemble_presentable({form.files_named("errors"), *machine, request.stop}, *options);
}

Result<Response> assembly(const Request& request) {
  AXIOMETRY_TRY(const app::Reader reader, reader_of(request));
  AXIOMETRY_TRY(const app::Assembled made, assembled(request));
  return json_response(app::localised_result(app::present(made, {}).json, app::ResultKind::volumetric, reader));
}

Result<Response> assembly_report(const Request& request) {
  AXIOMETRY_TRY(const report::Options options, document_options_of(request));
  AXIOMETRY_TRY(const app::Assembled made, assembled(request));
  const app::Experiment experiment = app::present(made, options);
  if (wants_json(request)) return json_file(experiment.json, "volume");
  return document_response(experiment.document, request, options, "volume");
}

Result<Response> shown_result(const Request& request) {
  AXIOMETRY_TRY(const app::Reader reader, reader_of(request));
  AXIOMETRY_TRY(const Value body, json_body(request));
  AXIOMETRY_TRY(const Value result, app::given_result(body, reader));
  return json_response(result);
}

Result<Response> field(const Request& request) {
  AXIOMETRY_TRY(const app::Reader reader, reader_of(request));
  AXIOMETRY_TRY(const Value body, json_body(request));
  AXIOMETRY_TRY(const std::size_t nodes, app::given_nodes(body));
  AXIOMETRY_TRY(app::KeptModel kept, app::given_kept_model(body));
  const app::FieldVolume volume = app::field_volume(std::move(kept), {"result", nodes});
  return json_response(app::localised_result(app::field_value(volume), app::ResultKind::findings_beside_all, reader));
}

Result<Response> difference(const Request& request) {
  AXIOMETRY_TRY(const app::Reader reader, reader_of(request));
  AXIOMETRY_TRY(const Value body, json_body(request));
  AXIOMETRY_TRY(const std::size_t nodes, app::given_nodes(body));
  AXIOMETRY_TRY(const app::KeptModel before, app::given_kept_model(body, "before", "findings_before"));
  AXIOMETRY_TRY(const app::KeptModel after, app::given_kept_model(body, "after", "findings_after"));
  AXIOMETRY_TRY(const Value value, app::field_difference(before, after, nodes));
  return json_response(app::localised_result(value, app::ResultKind::field_difference, reader));
}

Result<Response> prediction(const Request& request) {
  AXIOMETRY_TRY(const app::Reader reader, reader_of(request));
  AXIOMETRY_TRY(const Value body, json_body(request));
  AXIOMETRY_TRY(const app::PredictRequest wish, app::line_request_from(body));
  AXIOMETRY_TRY(app::KeptModel kept, app::given_kept_model(body));
  AXIOMETRY_TRY(const app::PredictedTest predicted, app::predict_test(std::move(kept), wish));
  return json_response(
      app::localised_result(app::present(predicted, {}).json, app::ResultKind::findings_beside_all, reader));
}

Result<Response> table(const Request& request) {
  AXIOMETRY_TRY(const bool to_keep, flag_of(request, "download", false));
  AXIOMETRY_TRY(const Value body, json_body(request));
  AXIOMETRY_TRY(const app::ExportRequest wish, app::table_request_from(body));
  AXIOMETRY_TRY(app::KeptModel kept, app::given_kept_model(body));
  AXIOMETRY_TRY(app::ExportedTable made, app::exported_table(std::move(kept), wish));
  return made_text_response(std::move(made.text), to_keep, wish.table + ".csv");
}

Result<Response> volume_table(const Request& request) {
  AXIOMETRY_TRY(const app::Reader reader, reader_of(request));
  AXIOMETRY_TRY(const Value body, json_body(request));
  AXIOMETRY_TRY(const app::VolumeCompensationRequest wish, app::volume_compensation_request_from(body));
  AXIOMETRY_TRY(const app::KeptModel kept, app::given_kept_model(body));
  AXIOMETRY_TRY(const app::VolumeCompensation made, app::compensate_volume(kept, wish));
  return json_response(app::volume_compensation_value(made, reader));
}

}  // namespace

void add_volumetric_routes(Router& router) {
  const auto add = [&](std::string_view pattern, auto handler, std::size_t bytes, Sent sent = Sent::json) {
    router.add("POST", pattern, handler, Weight::heavy, Terms{.sent = sent, .only_looks = true, .body_max = bytes});
  };
  add("/api/volumetric/plan", volume_plan, volume_plan_bytes_max);
  add("/api/volumetric/plan/sheet.{extension}", volume_sheet, volume_plan_bytes_max);
  add("/api/volumetric/plan/program", volume_program, volume_plan_bytes_max);
  add("/api/volumetric/identification", identification, volume_lengths_bytes_max, Sent::files);
  add("/api/volumetric/identification/report.{extension}", identification_report, volume_lengths_bytes_max,
      Sent::files);
  add("/api/volumetric/identification/residuals", residuals, volume_lengths_bytes_max, Sent::files);
  add("/api/volumetric/assembly", assembly, volume_lengths_bytes_max, Sent::files);
  add("/api/volumetric/assembly/report.{extension}", assembly_report, volume_lengths_bytes_max, Sent::files);
  add("/api/volumetric/result", shown_result, volume_model_bytes_max);
  add("/api/volumetric/field", field, volume_model_bytes_max);
  add("/api/volumetric/difference", difference, volume_models_bytes_max);
  add("/api/volumetric/prediction", prediction, volume_model_bytes_max);
  add("/api/volumetric/table", table, volume_model_bytes_max);
  add("/api/volumetric/compensation", volume_table, volume_model_bytes_max);
}

}  // namespace axiometry::server
