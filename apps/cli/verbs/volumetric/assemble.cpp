// SPDX-License-Identifier: Apache-2.0
#include <memory>
#include <string>
#include <vector>
#include "cli/flags/verb.h"

#include "axiometry/app/files/output.h"
#include "axiometry/app/volumetric/singles/assemble_singles.h"
#include "cli/failure.h"
#include "cli/flags/experiment_flags.h"
#include "cli/flags/option_text.h"
#include "cli/verbs/commands.h"
#include "cli/verbs/volumetric/volumetric.h"

namespace axiometry::cli {
namespace {

constexpr const char* assemble_examples =
    R"(Items are NAME=FILE: EXX, EYY, EZZ with a test of positions in any format, straightness (EYX, …) and rotations
(EAX, …) as axiometry straightness and angles read them, or as their --json OUT; squareness as the JSON of axiometry
squareness --positive …: C0Y=square.json, or in µrad with its U (k = 2): C0Y=-12.5,1.2.
C0Y turns Y about Z, B0Z turns Z about Y, A0Z turns Z about X. --at says for each axis where the axes stood and
with which tool while it was measured: rotations act on displacements by the lever from there. Behind the others it
may say in which direction they came to rest there (300:up): their rotations of it are in the squareness.
An error that was read in both directions has a curve of each; --reversal none keeps their mean alone.
Examples:
  axiometry volumetric assemble EXX=x.csv EYX=yx.csv ECX=cx.csv C0Y=-12.5,1.2 --machine machine.json \
    --at X=0,300:up,-200:down@T1 --at Y=500:up,0,-200:down@T1 --instrument EYX=0.4,0.5 --out result.json
  axiometry volumetric field result.json)";

struct AssembleArguments {
  app::AssembleRequest request;
  std::vector<std::string> items, instruments;
  std::string out;
  ExperimentArguments outputs;
};

void complete(AssembleArguments& arguments) {
  for (const std::string& text : arguments.items) {
    const auto item = app::parse_single(text);
    if (!item) throw UsageError("ITEM", item.error().message);
    arguments.request.items.push_back(*item);
  }
  for (const std::string& text : arguments.instruments)
    if (const auto put = app::put_instrument(text, arguments.request); !put)
      throw UsageError("--instrument", put.error().message);
}

int run_assemble(AssembleArguments& arguments) {
  std::vector<app::InputFile> inputs = {{arguments.request.machine, false}};
  for (const app::SingleItem& item : arguments.request.items)
    if (!item.file.empty()) inputs.push_back({item.file, false});
  app::OutputNames& names = arguments.outputs.outputs;
  names.inputs = app::InputFiles(inputs);
  if (const auto spared = app::check_inputs_spared(names); !spared) return failed(spared.error(), exit_usage);
  if (!arguments.out.empty())
    if (const auto spared = names.inputs.check_spared(arguments.out); !spared)
      return failed(spared.error(), exit_usage);
  const auto assembled = app::assemble_singles(arguments.request);
  if (!assembled) return failed(assembled.error());
  const app::Experiment experiment = app::present(*assembled, arguments.outputs.report);
  if (!arguments.out.empty())
    if (const auto written = app::write_file(arguments.out, json::dump(experiment.json) + "\n"); !written)
      return failed(written.error());
  return finish_experiment(experiment, arguments.outputs);
}

}  // namespace

void add_volumetric_assemble(const Verb& volumetric, int& exit_code) {
  Verb verb = volumetric.add_subcommand("assemble", "The model of a machine from its errors measured one by one");
  verb->footer(assemble_examples);
  auto arguments = std::make_shared<AssembleArguments>();
  verb->add_option("ITEM", arguments->items, "Errors: NAME=FILE, or of squareness also NAME=VALUE,U")->required();
  verb->add_option("--machine", arguments->request.machine, "The machine as JSON (axiometry schema machine)")
      ->type_name("FILE")
      ->required();
  add_read(*verb, {"--at", "AXIS=X,Y,Z@TOOL", "Where the axes stood while AXIS was measured, mm; once for each axis"},
           [arguments](const std::string& text) { return app::put_stand(text, arguments->request); })
      ->take_all()
      ->trigger_on_parse();
  verb->add_option("--instrument", arguments->instruments,
                   "Expanded uncertainty (k = 2) of the readings of one error, A + B per metre, µm or µrad; repeated")
      ->type_name("ERROR=A,B")
      ->one_at_a_time();
  add_read(
      *verb,
      {"--reversal", "MODEL", "Curves of both directions where they were read: curves, or none: their mean (curves)"},
      [arguments](const std::string& word) -> Result<void> {
        AXIOMETRY_TRY(arguments->request.reversal, app::parse_single_reversal(word));
        return {};
      });
  verb->add_option("--out", arguments->out, "The model, for volumetric field, predict, compensate and export, to FILE")
      ->check(fault_of_name)
      ->type_name("FILE")
      ->group("Outputs");
  add_experiment_flags(*verb, arguments->outputs);
  verb->callback([arguments, &exit_code] {
    check_experiment_outputs(arguments->outputs, {{"--out", arguments->out}});
    check_json_out(arguments->out, "; 'axiometry volumetric export' writes tables");
    complete(*arguments);
    exit_code = run_assemble(*arguments);
  });
}

}  // namespace axiometry::cli
