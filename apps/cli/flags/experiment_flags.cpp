// SPDX-License-Identifier: Apache-2.0
#include "cli/flags/experiment_flags.h"

#include <fmt/format.h>

#include <string>

#include "axiometry/base/text.h"
#include "cli/failure.h"
#include "cli/flags/option_text.h"
#include "cli/text/document_text.h"

namespace axiometry::cli {

void add_experiment_flags(const Verb& verb, ExperimentArguments& arguments) {
  constexpr const char* group = "Outputs";
  verb.add_option("--json", arguments.outputs.json, "Everything as JSON to FILE, or to the standard output with -")
      ->check(fault_of_name)
      ->type_name("FILE")
      ->group(group);
  verb.add_option("--report", arguments.outputs.reports,
                  "Report to FILE, by its extension html, pdf, svg, png or csv; may be repeated")
      ->type_name("FILE")
      ->one_at_a_time()
      ->group(group);
  Flag decimal = add_decimal(verb, arguments.report.numbers.decimal_mark)->group(group);
  add_language(verb, arguments.report, decimal)->group(group);
  verb.add_flag("--quiet,-q", arguments.quiet, "No summary in the terminal")->group(group);
}

void check_experiment_outputs(const ExperimentArguments& arguments) {
  if (const auto outputs = app::check_outputs(arguments.outputs); !outputs)
    throw UsageError("--report", outputs.error().message);
}

int finish_experiment(const app::Experiment& experiment, const ExperimentArguments& arguments) {
  if (!arguments.quiet && arguments.outputs.json != "-")
    fmt::print("{}", document_text(experiment.document, arguments.report, Terminal(ColourChoice::automatic)));
  if (const auto written = app::write_outputs(experiment, arguments.outputs, arguments.report); !written)
    return failed(written.error());
  return exit_done;
}

}  // namespace axiometry::cli
