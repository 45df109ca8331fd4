// SPDX-License-Identifier: Apache-2.0
#include "cli/verbs/volumetric/volumetric.h"

#include "cli/failure.h"
#include "cli/flags/verb.h"
#include "cli/verbs/commands.h"

namespace axiometry::cli {

int failed_for_tool(Error error, const std::string& tool) {
  if (tool.empty() && error.message.starts_with("found no tool, expected one of")) error.message += " (--tool)";
  return failed(error);
}

void add_volumetric(const Verb& program, int& exit_code) {
  Verb verb = program.add_subcommand("volumetric",
                                     "All 21 errors of a machine from the lengths of one tracking interferometer");
  verb->require_subcommand(1, 1);
  add_volumetric_identify(*verb, exit_code);
  add_volumetric_assemble(*verb, exit_code);
  add_volumetric_field(*verb, exit_code);
  add_volumetric_simulate(*verb, exit_code);
  add_volumetric_plan(*verb, exit_code);
  add_volumetric_predict(*verb, exit_code);
  add_volumetric_export(*verb, exit_code);
  add_volumetric_compensate(*verb, exit_code);
  verb->footer(R"(Examples:
  axiometry volumetric plan --machine machine.json --stations auto --out plan.json
  axiometry volumetric identify lengths.csv --machine machine.json --out result.json
  axiometry volumetric field result.json --report field.pdf

'axiometry volumetric VERB --help' explains each.)");
}

}  // namespace axiometry::cli
