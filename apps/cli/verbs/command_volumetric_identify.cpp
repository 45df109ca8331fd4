// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <memory>
#include <string>
#include <vector>

#include "axiometry/app/files/output.h"
#include "axiometry/app/volumetric/identify_lengths.h"
#include "axiometry/app/volumetric/identify_options.h"
#include "axiometry/base/json.h"
#include "axiometry/base/number_text.h"
#include "axiometry/base/text.h"
#include "cli/failure.h"
#include "cli/flags/capture_flags.h"
#include "cli/flags/experiment_flags.h"
#include "cli/flags/option_text.h"
#include "cli/flags/verb.h"
#include "cli/text/document_text.h"
#include "cli/verbs/command_volumetric.h"
#include "cli/verbs/commands.h"
#include "cli/verbs/serious.h"

namespace axiometry::cli {
namespace {

using volumetric::CurveKind;
using volumetric::DriftModel;
using volumetric::IdentifyOptions;
using volumetric::Reversal;

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
  std::string out, residuals, lengths_out;
  ExperimentArguments outputs;
};

Result<CurveKind> curve_kind_of(const std::string& word) {
  for (const CurveKind kind : {CurveKind::spline, CurveKind::legendre, CurveKind::nodes})
    if (word == volumetric::curve_kind_name(kind)) return kind;
  return fail(fmt::format("found {}, expected b-spline, legendre or nodes", text::quoted(word)));
}

Result<Reversal> reversal_of(const std::string& word) {
  if (word == "none") return Reversal::none;
  if (word == "constant") return Reversal::constant;
  if (word == "curves") return Reversal::curves;
  return fail(fmt::format("found {}, expected none, constant or curves", text::quoted(word)));
}

Result<DriftModel> drift_of(const std::string& word) {
  if (word == "auto") return DriftModel::automatic;
  if (word == "none") return DriftModel::none;
  if (word == "linear") return DriftModel::linear;
  return fail(fmt::format("found {}, expected auto, none or linear", text::quoted(word)));
}

/// "8" for all axes, or "8,6,4" for X, Y, Z.
Result<std::array<std::size_t, volumetric::axis_count>> sizes_of(const std::string& text) {
  std::array<std::size_t, volumetric::axis_count> sizes{};
  const std::vector<std::string_view> parts = text::split(text, ',');
  if (parts.size() != 1 && parts.size() != 3)
    return fail(fmt::format("found {}, expected one number, or three for X, Y, Z", text::quoted(text)));
  for (std::size_t a = 0; a < sizes.size(); ++a) {
    const auto number = parse_number(parts[parts.size() == 1 ? 0 : a]);
    if (!number || !(*number >= 1.0 && *number <= 400.0) || *number != static_cast<double>(static_cast<int>(*number)))
      return fail(fmt::format("found {}, expected whole numbers from 1 to 400", text::quoted(text)));
    sizes[a] = static_cast<std::size_t>(*number);
  }
  return sizes;
}

void add_model(const Verb& verb, IdentifyOptions& options) {
  constexpr const char* group = "Model";
  add_read(verb, {"--curves", "KIND", "What error motions are made of: b-spline, legendre or nodes (b-spline)"},
           [&options](const std::string& word) -> Result<void> {
             AXIOMETRY_TRY(options.curves, curve_kind_of(word));
             return {};
           })
      ->group(group);
  add_read(verb, {"--spans", "N|X,Y,Z", "Spans of the curves, or their degree (as many as the lengths support)"},
           [&options](const std::string& text) -> Result<void> {
             AXIOMETRY_TRY(options.sizes, sizes_of(text));
             return {};
           })
      ->group(group);
  add_read(verb, {"--reversal", "MODEL", "How the directions of an axis differ: none, constant or curves (none)"},
           [&options](const std::string& word) -> Result<void> {
             AXIOMETRY_TRY(options.reversal, reversal_of(word));
             return {};
           })
      ->group(group);
  add_read(
      verb,
      {"--smoothness", "none|auto|UM[,URAD]",
       "By how much slopes of curves change over an axis, standard deviation of displacements and rotations; auto: "
       "as the lengths of all let it appear (none)"},
      [&options](const std::string& text) -> Result<void> {
        AXIOMETRY_TRY(options.smoothness, app::parse_smoothness(text));
        return {};
      })
      ->group(group);
  add_read(verb,
           {"--drift", "MODEL", "Drift of the dead paths: auto (where residuals demand it), none or linear (auto)"},
           [&options](const std::string& word) -> Result<void> {
             AXIOMETRY_TRY(options.drift, drift_of(word));
             return {};
           })
      ->group(group);
  verb.add_flag_callback(
          "--no-breaks", [&options] { options.find_breaks = false; },
          "Do not look for breaks of the beam that the file does not state")
      ->group(group);
  verb.add_flag_callback(
          "--no-outliers", [&options] { options.find_outliers = false; },
          "Set no reading aside, however far it lies from what the others predict")
      ->group(group);
}

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
  add_read(*verb, {"--parts", "N,N,…", "Part of the plan that each recording is, in their order, or 1-4 of several"},
           [&lengths](const std::string& text) -> Result<void> {
             for (const std::string_view part : text::split(text, ',')) {
               AXIOMETRY_TRY(const app::PartRange parts, app::parse_part_range(part));
               lengths.parts.push_back(parts);
             }
             return {};
           });
  verb->add_flag("--reversed", lengths.recording.matcher.reversed,
                 "The lengths shown by a recording fall where the reflector recedes");
  add_model(*verb, arguments->request.options);
  verb->add_option("--out", arguments->out, "The result to FILE, for field, export and predictions")
      ->type_name("FILE")
      ->group("Outputs");
  verb->add_option("--residuals", arguments->residuals, "Every reading with its residual, as CSV to FILE")
      ->type_name("FILE")
      ->group("Outputs");
  verb->add_option("--lengths-out", arguments->lengths_out, "The lengths that were used, as CSV to FILE")
      ->type_name("FILE")
      ->group("Outputs");
  add_length_recording_flags(*verb, lengths.recording);
  add_experiment_flags(*verb, arguments->outputs);
  verb->callback([arguments, &exit_code] {
    if (arguments->request.machine.empty() && arguments->request.plan.empty())
      throw UsageError("--machine", "found neither --machine nor --plan, expected one of them");
    const IdentifyOptions& options = arguments->request.options;
    if (options.smoothness.kind != volumetric::Smoothness::Kind::none && options.curves == CurveKind::legendre)
      throw UsageError("--smoothness",
                       "found --curves legendre, expected b-spline or nodes: polynomials are as smooth "
                       "as their degree");
    check_experiment_outputs(
        arguments->outputs,
        {{"--out", arguments->out}, {"--residuals", arguments->residuals}, {"--lengths-out", arguments->lengths_out}});
    exit_code = run(*arguments);
  });
}

}  // namespace axiometry::cli
