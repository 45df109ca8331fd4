// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <memory>
#include <string>
#include <vector>

#include "axiometry/app/volumetric/predict_line.h"
#include "cli/failure.h"
#include "cli/flags/experiment_flags.h"
#include "cli/flags/verb.h"
#include "cli/verbs/commands.h"
#include "cli/verbs/serious_findings.h"
#include "cli/verbs/volumetric/volumetric.h"

namespace axiometry::cli {
namespace {

constexpr const char* volumetric_predict_examples =
    R"(Deviations are those along the line, less the mean of all: the zero of a deviation curve is a convention.
Exit code 3: a measured test departs from the prediction by more than chance.
Examples:
  axiometry volumetric predict result.json --axis X --at y=300,z=-250 --tool T1
  axiometry volumetric predict result.json --axis X --at y=300,z=-250 --tool T1 --measured x_axis.json --json -
  axiometry volumetric predict result.json --diagonal PPP-NNN --tool T1 --report diagonal.pdf)";

struct VolumetricPredictArguments {
  app::PredictRequest request;
  ExperimentArguments outputs;
};

int run(VolumetricPredictArguments& arguments) {
  std::vector<app::InputFile> inputs;
  for (const std::string& file : {arguments.request.result, arguments.request.plan, arguments.request.measured})
    if (!file.empty()) inputs.push_back({file, false});
  arguments.outputs.outputs.inputs = app::InputFiles(inputs);
  if (const auto spared = app::check_inputs_spared(arguments.outputs.outputs); !spared)
    return failed(spared.error(), exit_usage);
  const auto test = app::predict_test(arguments.request);
  if (!test) return failed_for_tool(test.error(), arguments.request.tool);
  if (const int code = finish_experiment(app::present(*test, arguments.outputs.report), arguments.outputs);
      code != exit_done)
    return code;
  return exit_code_of_findings(test->findings);
}

}  // namespace

void add_volumetric_predict(const Verb& volumetric, int& exit_code) {
  Verb verb = volumetric.add_subcommand("predict", "What a test of an axis or a diagonal would show");
  verb->footer(volumetric_predict_examples);
  auto arguments = std::make_shared<VolumetricPredictArguments>();
  app::PredictRequest& request = arguments->request;
  verb->add_option("RESULT", request.result, "What identify wrote with --out")->required();
  Flag axis = verb->add_option("--axis", request.axis, "X, Y or Z: a test after ISO 230-2")->type_name("AXIS");
  verb->add_option("--at", request.at, "Where the other axes stand, mm: y=300,z=-250")->type_name("PLACE");
  verb->add_option("--diagonal", request.diagonal,
                   "PPP-NNN, NPP-PNN, PNP-NPN, PPN-NNP, or of a face as \"XY PP-NN\": a test after ISO 230-6")
      ->type_name("NAME")
      ->excludes(axis);
  verb->add_option("--tool", request.tool, "A tool of the machine (the only one)")->type_name("NAME");
  verb->add_option("--plan", request.plan, "Its targets, and its line in space (11 targets over the travel)")
      ->type_name("FILE");
  verb->add_option("--measured", request.measured, "A measured test, to be held against the prediction")
      ->type_name("FILE");
  add_experiment_flags(*verb, arguments->outputs);
  verb->callback([arguments, &exit_code] {
    check_experiment_outputs(arguments->outputs);
    exit_code = run(*arguments);
  });
}

}  // namespace axiometry::cli
