// SPDX-License-Identifier: Apache-2.0
#include "cli/flags/experiment_flags.h"

#include <fmt/format.h>

#include <algorithm>
#include <string>
#include <vector>

#include "axiometry/app/files/output.h"
#include "axiometry/base/text/text.h"
#include "cli/failure.h"
#include "cli/flags/option_text.h"
#include "cli/text/document_text.h"

namespace axiometry::cli {

void add_output_flags(const Verb& verb, app::OutputNames& outputs, report::Options& report, bool& quiet,
                      const std::string& kinds) {
  constexpr const char* group = "Outputs";
  verb.add_option("--json", outputs.json, "Everything as JSON to FILE, or to the standard output with -")
      ->check(fault_of_name)
      ->type_name("FILE")
      ->group(group);
  verb.add_option("--report", outputs.reports,
                  fmt::format("Report to FILE, by its extension {}; may be repeated", kinds))
      ->type_name("FILE")
      ->one_at_a_time()
      ->group(group);
  Flag decimal = add_decimal(verb, report.numbers.decimal_mark)->group(group);
  add_language(verb, report, decimal)->group(group);
  verb.add_flag("--quiet,-q", quiet, "No summary in the terminal")->group(group);
}

void add_experiment_flags(const Verb& verb, ExperimentArguments& arguments) {
  add_output_flags(verb, arguments.outputs, arguments.report, arguments.quiet);
}

void check_experiment_outputs(const ExperimentArguments& arguments) {
  if (const auto outputs = app::check_outputs(arguments.outputs); !outputs)
    throw UsageError("--report", outputs.error().message);
}

void check_experiment_outputs(ExperimentArguments& arguments, std::initializer_list<FurtherOutput> further) {
  check_experiment_outputs(arguments);
  std::vector<std::string> taken = arguments.outputs.reports;
  taken.push_back(arguments.outputs.json);
  for (const auto& [option, name] : further) {
    if (name.empty()) continue;
    if (std::ranges::find(taken, name) != taken.end())
      throw UsageError(option, "found the name of another output too, expected a different one");
    taken.push_back(name);
    arguments.quiet = arguments.quiet || name == "-";
  }
}

int finish_experiment(const app::Experiment& experiment, const ExperimentArguments& arguments) {
  if (!arguments.quiet && arguments.outputs.json != "-")
    fmt::print("{}", document_text(experiment.document, arguments.report, Terminal(ColourChoice::automatic)));
  if (const auto written = app::write_outputs(experiment, arguments.outputs, arguments.report); !written)
    return failed(written.error());
  return exit_done;
}

void add_sheet_flags(const Verb& verb, const std::string& names, app::OutputNames& outputs, report::Options& report,
                     bool& quiet) {
  constexpr const char* group = "Outputs";
  verb.add_option(names, outputs.reports,
                  "Sheet to take to the machine to FILE, by its extension html, pdf, svg, png or csv; may be repeated")
      ->type_name("FILE")
      ->one_at_a_time()
      ->group(group);
  Flag decimal = add_decimal(verb, report.numbers.decimal_mark, "Decimal mark in summary and sheet: point or comma");
  add_language(verb, report, decimal->group(group))->group(group);
  verb.add_flag("--quiet,-q", quiet, "No summary in the terminal")->group(group);
}

void check_sheet_outputs(const app::OutputNames& outputs) {
  check_json_out(outputs.json, "; --sheet writes tables and documents of it");
  if (auto checked = app::check_outputs(outputs); !checked) throw UsageError("--sheet", checked.error().message);
}

void check_json_out(const std::string& out, const std::string& instead) {
  if (auto ending = app::check_ending(out, {".json"}); !ending)
    throw UsageError("--out", ending.error().message + instead);
}

}  // namespace axiometry::cli
