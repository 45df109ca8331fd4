// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <algorithm>
#include <memory>
#include <string>
#include <vector>

#include "axiometry/app/compensate/compensate.h"
#include "axiometry/app/files/output.h"
#include "axiometry/base/text/number_text.h"
#include "axiometry/base/text/text.h"
#include "axiometry/nc/axis_table.h"
#include "cli/failure.h"
#include "cli/flags/compensate_flags.h"
#include "cli/flags/correction_flags.h"
#include "cli/flags/experiment_flags.h"
#include "cli/flags/option_text.h"
#include "cli/flags/reading_flags.h"
#include "cli/flags/verb.h"
#include "cli/verbs/commands.h"

namespace axiometry::cli {
namespace {

constexpr const char* compensate_examples =
    R"(The table is read back by the control's own rule and applied to the readings: where that would not make the axis
better, no file is written. What stands beside "predicted" is a prediction; only a re-test proves it: --retest holds one
against it, and names a sign mistake, a table that is not active, or one that is applied twice.
The readings are those of the axis: what the test tells of its instrument and of temperatures is corrected by --correct,
in the re-test likewise.
Exit code 3: something must be looked at before the table is used.
Examples:
  axiometry compensate --list
  axiometry compensate x.csv --for linuxcnc --out x.comp --report x.pdf
  axiometry compensate x.csv --for siemens-lec --axis X1 --start 0 --end 500 --step 10 --out x.ini
  axiometry compensate x.csv --for siemens-lec --curves with-backlash --periodic leave --period 10 --out x.ini
  axiometry compensate again.csv --for linuxcnc --existing x.comp --out x2.comp
  axiometry compensate x.csv --for linuxcnc --retest after.csv)";

struct CompensateArguments {
  app::CompensateFiles files;
  app::CompensateRequest request;
  std::string out;
  bool list = false;
  ExperimentArguments outputs;
};

int list_controls(const CompensateArguments& arguments) {
  if (arguments.outputs.outputs.json == "-") {
    json::Value controls = json::Value::array();
    for (const nc::AxisTable* control : nc::axis_table_table()) controls.push(app::control_to_json(*control));
    fmt::print("{}\n", json::dump(controls));
    return exit_done;
  }
  for (const nc::AxisTable* control : nc::axis_table_table())
    fmt::print("{}: {} ({})\n  {}\n  verified: {}\n{}", control->id, control->title, curves_name(control->curves),
               control->sign, control->verified,
               control->inferred.empty() ? "" : fmt::format("  inferred: {}\n", control->inferred));
  return exit_done;
}

int run(CompensateArguments& arguments) {
  if (arguments.list) return list_controls(arguments);
  const app::CompensateFiles& files = arguments.files;
  if (files.test.empty()) throw MissingOption("FILE");
  check_control_named(arguments.request);
  std::vector<app::InputFile> inputs;
  for (const std::string& file : {files.test, files.existing, files.retest})
    if (!file.empty()) inputs.push_back({file, false});
  arguments.outputs.outputs.inputs = app::InputFiles(inputs);
  if (const auto spared = app::check_inputs_spared(arguments.outputs.outputs); !spared)
    return failed(spared.error(), exit_usage);
  if (!arguments.out.empty())
    if (const auto spared = arguments.outputs.outputs.inputs.check_spared(arguments.out); !spared)
      return failed(spared.error(), exit_usage);
  auto measured = app::read_measured_axis(files);
  if (!measured) return failed(measured.error());
  const auto done = app::compensate(*std::move(measured), arguments.request);
  if (!done) return failed(done.error());
  if (!arguments.out.empty())
    if (const auto written = app::write_file(arguments.out, done->text); !written) return failed(written.error());
  if (const int code = finish_experiment(app::present(*done, arguments.outputs.report), arguments.outputs);
      code != exit_done)
    return code;
  return std::ranges::any_of(done->findings, &NamedFinding::serious) ? exit_exceeded : exit_done;
}

}  // namespace

void add_compensate(const Verb& program, int& exit_code) {
  Verb verb =
      program.add_subcommand("compensate", "The table by which a control corrects an axis, from a measured test");
  verb->footer(compensate_examples);
  auto arguments = std::make_shared<CompensateArguments>();
  verb->add_option("FILE", arguments->files.test, "Measured test, or - for the standard input");
  verb->add_flag("--list", arguments->list, "The controls that there are, and what of each is verified");
  Flag out = verb->add_option("--out", arguments->out, "The table to FILE, or to the standard output with -")
                 ->check(fault_of_name)
                 ->type_name("FILE")
                 ->group("Outputs");
  verb->add_option("--retest", arguments->files.retest,
                   "A test with the new table active, to be held against the prediction")
      ->type_name("FILE")
      ->excludes(out);
  verb->add_option("--existing", arguments->files.existing,
                   "The table that was active while the test was measured: the new one replaces it, at its positions")
      ->type_name("FILE")
      ->group("Table");
  add_compensate_flags(*verb, arguments->request);
  add_measured_flags(*verb, arguments->request);
  add_reading_flags(*verb, arguments->files.reading, "axis.kind=rotary");
  add_correction_flags(*verb, arguments->files.reading.corrections);
  add_experiment_flags(*verb, arguments->outputs);
  verb->callback([arguments, verb, &exit_code] {
    check_alone(*verb, "--list", {"--json"});
    check_experiment_outputs(arguments->outputs, {{"--out", arguments->out}});
    exit_code = run(*arguments);
  });
}

}  // namespace axiometry::cli
