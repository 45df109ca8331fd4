// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <algorithm>
#include <memory>
#include <string>
#include <vector>

#include "axiometry/app/files/output.h"
#include "axiometry/app/volumetric/identify_lengths.h"
#include "axiometry/base/json/json.h"
#include "cli/failure.h"
#include "cli/flags/capture_flags.h"
#include "cli/flags/experiment_flags.h"
#include "cli/flags/length_flags.h"
#include "cli/flags/verb.h"
#include "cli/text/document_text.h"
#include "cli/verbs/commands.h"
#include "cli/verbs/serious_findings.h"
#include "cli/verbs/volumetric/volumetric.h"

namespace axiometry::cli {
namespace {

constexpr const char* volumetric_identify_examples =
    R"(LENGTHS is a table with the columns station, tool, x_mm, y_mm, z_mm (where the axes were told to
stand), length_mm and, where a beam was broken, segment; rows in the order of measurement. The machine's file
holds at least
{"chain": "XFYZ", "travel_mm": {"X": [0, 1000], "Y": [0, 600], "Z": [-500, 0]}, "tools_mm": {"T1": [0, 0, -150]}}.
Or LENGTHS are continuous recordings of time and length, with the plan that was driven: one of each part, or one of all
in succession. Which part one is is told by its lengths, or said in order: --parts 1,2,5-8.
Exit code 3: the result should not be used as it is, a finding says why.
Examples:
  axiometry volumetric identify lengths.csv --machine machine.json --out result.json --report volume.pdf
  axiometry volumetric identify lengths.csv --machine machine.json --spans 8 --reversal constant --json -
  axiometry volumetric identify lengths.csv --machine machine.json --spans 16 --smoothness auto --out result.json
  axiometry volumetric identify run1.csv run2.csv --plan plan.json --lengths-out lengths.csv --out result.json)";

struct VolumetricIdentifyArguments {
  app::IdentifyRequest request;
  app::IdentifyChoices choices;
  std::string out, residuals, lengths_out;
  ExperimentArguments outputs;
};

int run(VolumetricIdentifyArguments& arguments) {
  std::vector<app::InputFile> inputs;
  for (const std::string& file : arguments.request.lengths.files) inputs.push_back({file, false});
  for (const std::string& file : {arguments.request.machine, arguments.request.plan})
    if (!file.empty()) inputs.push_back({file, false});
  app::OutputNames& names = arguments.outputs.outputs;
  names.inputs = app::InputFiles(inputs);
  if (const auto spared = app::check_inputs_spared(names); !spared) return failed(spared.error(), exit_usage);
  for (const std::string& file : {arguments.out, arguments.residuals, arguments.lengths_out})
    if (const auto spared = names.inputs.check_spared(file); !file.empty() && !spared)
      return failed(spared.error(), exit_usage);
  arguments.request.options = arguments.choices.model;
  arguments.request.lengths.parts = arguments.choices.parts;
  arguments.request.lengths.recording = arguments.choices.recording;
  const auto identified = app::identify_lengths(arguments.request);
  if (!identified) return failed(identified.error());
  const app::Experiment presented = app::present(*identified, arguments.outputs.report);
  if (!arguments.out.empty())
    if (const auto written = app::write_file(arguments.out, json::dump(presented.json, 0) + "\n"); !written)
      return failed(written.error());
  if (!arguments.residuals.empty())
    if (const auto written = app::write_file(arguments.residuals, app::residuals_csv(*identified)); !written)
      return failed(written.error());
  if (!arguments.lengths_out.empty())
    if (const auto written = app::write_file(arguments.lengths_out, app::gathered_table(*identified)); !written)
      return failed(written.error());
  if (const int code = finish_experiment(presented, arguments.outputs); code != exit_done) return code;
  return exit_code_of_findings(identified->identification.findings);
}

}  // namespace

void add_volumetric_identify(const Verb& volumetric, int& exit_code) {
  Verb verb = volumetric.add_subcommand("identify", "Find the 21 errors from measured lengths");
  verb->footer(volumetric_identify_examples);
  auto arguments = std::make_shared<VolumetricIdentifyArguments>();
  app::LengthsRequest& lengths = arguments->request.lengths;
  verb->add_option("LENGTHS", lengths.files,
                   "Lengths as CSV, or continuous recordings of them with their plan, or - for the standard input")
      ->required();
  verb->add_option("--machine", arguments->request.machine,
                   "The machine, its tools and the instrument, as JSON (those of the plan)")
      ->type_name("FILE");
  verb->add_option("--plan", arguments->request.plan, "The plan of 'volumetric plan' that was driven")
      ->type_name("FILE");
  add_identify_flags(*verb, arguments->choices);
  add_length_switches(
      *verb, [arguments] { arguments->choices.recording.matcher.reversed = true; },
      [arguments] { arguments->choices.model.find_breaks = false; });
  verb->add_option("--out", arguments->out, "The result to FILE, for field, export and predictions")
      ->type_name("FILE")
      ->group("Outputs");
  verb->add_option("--residuals", arguments->residuals, "Every reading with its residual, as CSV to FILE")
      ->type_name("FILE")
      ->group("Outputs");
  verb->add_option("--lengths-out", arguments->lengths_out, "The lengths that were used, as CSV to FILE")
      ->type_name("FILE")
      ->group("Outputs");
  add_length_recording_flags(*verb, arguments->choices.recording);
  add_experiment_flags(*verb, arguments->outputs);
  verb->callback([arguments, &exit_code] {
    if (arguments->request.machine.empty() && arguments->request.plan.empty())
      throw UsageError("--machine", "found neither --machine nor --plan, expected one of them");
    const volumetric::IdentifyOptions& model = arguments->choices.model;
    if (model.smoothness.kind != volumetric::Smoothness::Kind::none && model.curves == volumetric::CurveKind::legendre)
      throw UsageError("--smoothness",
                       "found --curves legendre, expected b-spline or nodes: polynomials are as smooth "
                       "as their degree");
    check_experiment_outputs(
        arguments->outputs,
        {{"--out", arguments->out}, {"--residuals", arguments->residuals}, {"--lengths-out", arguments->lengths_out}});
    check_json_out(arguments->out, "; 'axiometry volumetric export' writes tables");
    exit_code = run(*arguments);
  });
}

}  // namespace axiometry::cli
