// SPDX-License-Identifier: Apache-2.0
#include <memory>
#include <string>
#include <vector>

#include "axiometry/app/files/output.h"
#include "axiometry/app/volumetric/field_points.h"
#include "axiometry/app/volumetric/field_volume.h"
#include "axiometry/base/text/number_text.h"
#include "axiometry/base/text/text.h"
#include "cli/failure.h"
#include "cli/flags/experiment_flags.h"
#include "cli/flags/option_text.h"
#include "cli/flags/verb.h"
#include "cli/verbs/commands.h"
#include "cli/verbs/serious_findings.h"
#include "cli/verbs/volumetric/volumetric.h"

namespace axiometry::cli {
namespace {

constexpr const char* volumetric_field_examples =
    R"(Without --at: how large the error is over the travel that was observed, with each tool, and along the diagonals.
Points of --at are a table with the columns tool, x_mm, y_mm, z_mm: where the axes stand.
Examples:
  axiometry volumetric field result.json --report field.pdf
  axiometry volumetric field result.json --grid 21 --csv grid.csv --json -
  axiometry volumetric field result.json --at points.csv --json -)";

constexpr std::size_t nodes_least = 2, nodes_most = 101;

struct VolumetricFieldArguments {
  app::FieldRequest points;
  app::FieldVolumeRequest volume;
  std::string csv;
  ExperimentArguments outputs;
};

int run_points(const VolumetricFieldArguments& arguments) {
  const auto field = app::field_at_points(arguments.points);
  if (!field) return failed(field.error());
  const std::string& json = arguments.outputs.outputs.json;
  const auto written = app::write_file(json.empty() ? "-" : json, json::dump(field->value) + "\n");
  if (!written) return failed(written.error());
  tell_serious(field->findings);
  return exit_code_of_findings(field->findings);
}

int run_volume(VolumetricFieldArguments& arguments) {
  app::OutputNames& names = arguments.outputs.outputs;
  const std::vector<app::InputFile> inputs = {{arguments.points.result, false}};
  names.inputs = app::InputFiles(inputs);
  if (const auto spared = app::check_inputs_spared(names); !spared) return failed(spared.error(), exit_usage);
  if (const auto spared = names.inputs.check_spared(arguments.csv); !arguments.csv.empty() && !spared)
    return failed(spared.error(), exit_usage);
  arguments.volume.result = arguments.points.result;
  const auto volume = app::field_volume(arguments.volume);
  if (!volume) return failed(volume.error());
  if (!arguments.csv.empty())
    if (const auto written = app::write_file(arguments.csv, app::field_csv(*volume)); !written)
      return failed(written.error());
  if (const int code = finish_experiment(app::present(*volume, arguments.outputs.report), arguments.outputs);
      code != exit_done)
    return code;
  tell_serious(volume->findings);
  return exit_code_of_findings(volume->findings);
}

}  // namespace

void add_volumetric_field(const Verb& volumetric, int& exit_code) {
  Verb verb = volumetric.add_subcommand("field", "The error of the tool point over the volume, or at given places");
  verb->footer(volumetric_field_examples);
  auto arguments = std::make_shared<VolumetricFieldArguments>();
  verb->add_option("RESULT", arguments->points.result, "What identify wrote with --out")->required();
  Flag at = verb->add_option("--at", arguments->points.points,
                             "The error with its covariance at these places, as CSV, or - for the standard input; "
                             "JSON alone")
                ->type_name("FILE");
  add_read(*verb, {"--grid", "N", "Nodes along each axis, 2 to 101 (11)"},
           [arguments](const std::string& text) -> Result<void> {
             const auto number = parse_number(text);
             if (!number || !(*number >= nodes_least && *number <= nodes_most) ||
                 *number != static_cast<double>(static_cast<int>(*number)))
               return fail("found " + text::quoted(text) + ", expected a whole number from 2 to 101");
             arguments->volume.nodes = static_cast<std::size_t>(*number);
             return {};
           })
      ->excludes(at);
  verb->add_option("--csv", arguments->csv, "Every node of the grid to FILE")
      ->check(fault_of_name)
      ->type_name("FILE")
      ->excludes(at);
  add_experiment_flags(*verb, arguments->outputs);
  verb->get_option("--report")->excludes(at);
  verb->callback([arguments, &exit_code] {
    check_experiment_outputs(arguments->outputs, {{"--csv", arguments->csv}});
    exit_code = arguments->points.points.empty() ? run_volume(*arguments) : run_points(*arguments);
  });
}

}  // namespace axiometry::cli
