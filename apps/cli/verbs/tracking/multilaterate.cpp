// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <algorithm>
#include <memory>
#include <string>
#include <vector>
#include "cli/flags/verb.h"

#include "axiometry/app/tracking/multilaterate.h"
#include "axiometry/app/tracking/tracking_text.h"
#include "cli/failure.h"
#include "cli/flags/experiment_flags.h"
#include "cli/flags/option_text.h"
#include "cli/flags/ranging_flag.h"
#include "cli/text/document_text.h"
#include "cli/verbs/commands.h"
#include "cli/verbs/tracking/tracking.h"

namespace axiometry::cli {
namespace {

constexpr const char* tracking_multilaterate_examples =
    R"(The columns are point,station,length_mm, where a beam was broken segment, and x_mm,y_mm,z_mm of the
nominal points here or in --points. Readings of one station stand in the order of measurement. Four
stations need ten points, five seven, six and more six; up to five must not stand on one plane.
Exit code 3: the result should not be used as it is, a finding says why.
Examples:
  axiometry tracking multilaterate ranges.csv --points nominal.csv
  axiometry tracking multilaterate ranges.csv --repeatability 0.5um --out points.csv --report m.pdf
  axiometry tracking multilaterate ranges.csv --scale free --scale-prior 0.1 --json -)";

struct TrackingMultilaterateArguments {
  app::MultilaterateRequest request;
  app::MultilateratedNames names;
  ExperimentArguments outputs;
};

using tracking::ScaleModel;

void add_model(const Verb& verb, tracking::MultilaterationOptions& options) {
  add_read(verb, {"--scale", "MODEL", "Scale of the lengths: fixed, common (one unknown) or free (one each) (fixed)"},
           [&options](const std::string& word) -> Result<void> {
             AXIOMETRY_TRY(options.scale, app::parse_scale_model(word));
             return {};
           })
      ->group("Model");
  add_number(verb, {"--scale-prior", "PPM", "Standard uncertainty of an unknown scale about 1, in 10⁻⁶ (none)"},
             [&options](double ppm) {
               if (!(ppm > 0.0))
                 throw UsageError("--scale-prior", fmt::format("found {}, expected a number above 0", ppm));
               options.scale_prior = 1e-6 * ppm;
             })
      ->group("Model");
  add_ranging(verb, [&options](const RangingUncertainty& ranging) { options.ranging = ranging; })->group("Model");
  add_read(verb,
           {"--repeatability", "LENGTH", "Standard uncertainty of the machine between stations along a beam (0um)"},
           [&options](const std::string& text) -> Result<void> {
             AXIOMETRY_TRY(const Length sigma, app::parse_length_sigma(text));
             options.repeatability_sigma_mm = sigma.in_mm();
             return {};
           })
      ->group("Model");
  verb.add_flag_callback(
          "--no-breaks", [&options] { options.find_breaks = false; },
          "Do not look for breaks of the beam that the file does not state")
      ->group("Model");
  verb.add_flag_callback(
          "--no-covariances", [&options] { options.point_covariances = false; },
          "No covariances of points and no search for readings that do not fit")
      ->group("Model");
}

/// What a terminal shows of the report.
report::Document summary_of(report::Document document) {
  std::erase_if(document.sections, [](const report::Section& s) { return s.id == "method" || s.id == "source"; });
  return document;
}

int run(TrackingMultilaterateArguments& arguments) {
  std::vector<app::InputFile> inputs = {{arguments.request.ranges, false}};
  if (!arguments.request.points.empty()) inputs.push_back({arguments.request.points, false});
  arguments.names.outputs = arguments.outputs.outputs;
  arguments.names.outputs.inputs = app::InputFiles(inputs);
  if (auto spared = app::check_inputs_spared(arguments.names.outputs); !spared)
    return failed(spared.error(), exit_usage);
  for (const std::string& file : {arguments.names.points, arguments.names.residuals})
    if (auto spared = arguments.names.outputs.inputs.check_spared(file); !file.empty() && !spared)
      return failed(spared.error(), exit_usage);
  const auto result = app::multilaterate_files(arguments.request);
  if (!result) return failed(result.error());
  const report::Document document = app::compose(**result, arguments.outputs.report);
  if (!arguments.outputs.quiet && arguments.outputs.outputs.json != "-")
    fmt::print("{}", document_text(summary_of(document), arguments.outputs.report, Terminal(ColourChoice::automatic)));
  const auto written = app::write_outputs(**result, document, arguments.names, arguments.outputs.report);
  if (!written) return failed(written.error());
  return std::ranges::any_of((*result)->fit.findings, [](const tracking::Finding& f) { return f.serious; })
             ? exit_exceeded
             : exit_done;
}

}  // namespace

void add_tracking_multilaterate(const Verb& tracking, int& exit_code) {
  Verb verb = tracking.add_subcommand(
      "multilaterate", "Points and stations from lengths between them: several stations, or one in sequence");
  verb->footer(tracking_multilaterate_examples);
  auto arguments = std::make_shared<TrackingMultilaterateArguments>();
  verb->add_option("RANGES", arguments->request.ranges, "Lengths as CSV, or - for the standard input")->required();
  verb->add_option("--points", arguments->request.points, "Nominal points as CSV: point,x_mm,y_mm,z_mm")
      ->type_name("FILE");
  add_model(*verb, arguments->request.options);
  verb->add_option("--out", arguments->names.points, "The points found, as CSV to FILE")
      ->type_name("FILE")
      ->group("Outputs");
  verb->add_option("--residuals", arguments->names.residuals, "Every reading with its residual, as CSV to FILE")
      ->type_name("FILE")
      ->group("Outputs");
  add_experiment_flags(*verb, arguments->outputs);
  verb->callback([arguments, &exit_code] {
    check_experiment_outputs(arguments->outputs,
                             {{"--out", arguments->names.points}, {"--residuals", arguments->names.residuals}});
    const auto& options = arguments->request.options;
    if (options.scale == ScaleModel::fixed && options.scale_prior > 0.0)
      throw UsageError("--scale-prior", "found it with a fixed scale, expected --scale common or free");
    if (!(options.ranging.standard_mm(1000.0) > 0.0) && options.repeatability_sigma_mm == 0.0)
      throw UsageError("--ranging", "found an uncertainty of 0, expected one above 0 to weigh by");
    exit_code = run(*arguments);
  });
}

}  // namespace axiometry::cli
