// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <algorithm>
#include <memory>
#include <string>
#include <vector>

#include "axiometry/app/files/output.h"
#include "axiometry/app/results/outputs.h"
#include "axiometry/app/volumetric/tables/volume_compensation.h"
#include "axiometry/base/text/text.h"
#include "axiometry/nc/axis_table.h"
#include "cli/failure.h"
#include "cli/flags/compensate_flags.h"
#include "cli/flags/experiment_flags.h"
#include "cli/flags/option_text.h"
#include "cli/flags/verb.h"
#include "cli/text/flags_of_words.h"
#include "cli/verbs/commands.h"
#include "cli/verbs/serious_findings.h"
#include "cli/verbs/volumetric/volumetric.h"

namespace axiometry::cli {
namespace {

constexpr const char* volumetric_compensate_examples =
    R"(The displacement on the line through the middle of the volume is what one table takes away best. Where a control
moves another axis by the position of one (a cross table, such as SINUMERIK's CEC), --component says in which direction:
straightness goes into it, and squareness. What remains of the error of the tool point is told, of this table alone.
Exit code 3: something must be looked at before the table is used.
Examples:
  axiometry volumetric compensate result.json --for siemens-lec --along X --axis AX1 --out x.ini
  axiometry volumetric compensate result.json --for siemens-cec --along Y --component X --axis AX2 --output-axis AX1
      --number 4 --out xy.ini
  axiometry volumetric compensate result.json --for marlin-skew --along Y --component X --out skew.gcode
      --report skew.pdf)";

struct VolumetricCompensateArguments {
  app::VolumeCompensationRequest request;
  std::string out;
  ExperimentArguments outputs;
  bool has_component = false;
};

Result<std::size_t> axis_of_letter(const std::string& text) {
  const std::size_t axis = std::string_view("xyz").find(text::to_lower(text));
  if (text.size() == 1 && axis != std::string_view::npos) return axis;
  return fail(fmt::format("found {}, expected X, Y or Z", text::quoted(text)));
}

void print_made(const app::VolumeCompensation& made) {
  fmt::print("{}: {}\n", made.control->title, made.errors);
  fmt::print("  on the line through the middle: {:.2f} µm without, {:.2f} µm with the table (range)\n",
             made.line_before_um, made.line_after_um);
  const auto sizes = [](const char* name, double before, double after) {
    fmt::print("  over the volume, {}: {:.2f} µm without, {:.2f} µm with this table alone\n", name, before, after);
  };
  sizes("largest", made.effect.before.largest.value, made.effect.after.largest.value);
  sizes("95 % below", made.effect.before.percent_95, made.effect.after.percent_95);
  fmt::print("  {}\n", nc::sign_of(*made.control, made.options));
  for (const NamedFinding& finding : made.findings)
    fmt::print("  {}: {}\n", finding.serious ? "serious" : "note", with_flags(finding.message, finding.message));
}

int run(VolumetricCompensateArguments& arguments) {
  app::VolumeCompensationRequest& request = arguments.request;
  if (request.result.empty()) throw MissingOption("RESULT");
  check_control_named(request.how);
  if (!arguments.has_component) request.component = request.along;
  const std::vector<app::InputFile> inputs = {{request.result, false}};
  app::OutputNames& outputs = arguments.outputs.outputs;
  outputs.inputs = app::InputFiles(inputs);
  if (const auto spared = app::check_inputs_spared(outputs); !spared) return failed(spared.error(), exit_usage);
  if (!arguments.out.empty())
    if (const auto spared = outputs.inputs.check_spared(arguments.out); !spared)
      return failed(spared.error(), exit_usage);
  const auto made = app::compensate_volume(request);
  if (!made) return failed_for_tool(made.error(), request.tool);
  if (!arguments.out.empty())
    if (const auto written = app::write_file(arguments.out, made->text); !written) return failed(written.error());
  const app::Experiment shown = app::present(*made, arguments.outputs.report);
  if (const auto written = app::write_outputs(shown, outputs, arguments.outputs.report); !written)
    return failed(written.error());
  if (!arguments.outputs.quiet && outputs.json != "-") print_made(*made);
  return exit_code_of_findings(made->findings);
}

}  // namespace

void add_volumetric_compensate(const Verb& volumetric, int& exit_code) {
  Verb verb = volumetric.add_subcommand("compensate", "A table of one axis for a control, from the 21 errors");
  verb->footer(volumetric_compensate_examples);
  auto arguments = std::make_shared<VolumetricCompensateArguments>();
  verb->add_option("RESULT", arguments->request.result, "What identify wrote with --out");
  add_read(*verb, {"--along", "AXIS", "X, Y or Z: at whose positions the table stands (X)"},
           [arguments](const std::string& text) -> Result<void> {
             AXIOMETRY_TRY(arguments->request.along, axis_of_letter(text));
             return {};
           });
  add_read(*verb, {"--component", "AXIS", "X, Y or Z: the direction that is corrected (that of --along)"},
           [arguments](const std::string& text) -> Result<void> {
             AXIOMETRY_TRY(arguments->request.component, axis_of_letter(text));
             arguments->has_component = true;
             return {};
           });
  verb->add_option("--output-axis", arguments->request.how.table.output_axis,
                   "The axis that is moved, as the control names it (that of --component)")
      ->type_name("AXIS");
  verb->add_option("--tool", arguments->request.tool, "With which tool (the only one)")->type_name("NAME");
  verb->add_option("--out", arguments->out, "The table to FILE, or to the standard output with -")
      ->check(fault_of_name)
      ->type_name("FILE");
  add_compensate_flags(*verb, arguments->request.how);
  add_experiment_flags(*verb, arguments->outputs);
  verb->callback([arguments, &exit_code] {
    check_experiment_outputs(arguments->outputs, {{"--out", arguments->out}});
    exit_code = run(*arguments);
  });
}

}  // namespace axiometry::cli
