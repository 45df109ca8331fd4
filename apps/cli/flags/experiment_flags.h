// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <initializer_list>
#include <string>

#include "cli/flags/verb.h"

#include "axiometry/app/results/experiment.h"
#include "axiometry/report/report.h"

/// The outputs that verbs of computations have in common.
namespace axiometry::cli {

struct ExperimentArguments {
  app::OutputNames outputs;
  report::Options report;
  bool quiet = false;
};

/// --json, --report, --decimal, --language, --quiet. The kinds of report as the help names them.
void add_output_flags(const Verb& verb, app::OutputNames& outputs, report::Options& report, bool& quiet,
                      const std::string& kinds = "html, pdf, svg, png or csv");

/// The same for what a computation is presented by.
void add_experiment_flags(const Verb& verb, ExperimentArguments& arguments);

/// Checks the names of the outputs; throws a UsageError. Before anything is computed.
void check_experiment_outputs(const ExperimentArguments& arguments);

/// An output beside those that verbs have in common.
struct FurtherOutput {
  const char* option;
  std::string name;  ///< empty where none is asked for
};

/// Throws a UsageError where one output would take the place of another, and checks those in common as above. A summary
/// would be mixed into an output that goes to the standard output: then it is left out.
void check_experiment_outputs(ExperimentArguments& arguments, std::initializer_list<FurtherOutput> further);

/// Prints the document and writes the outputs; returns the exit code.
int finish_experiment(const app::Experiment& experiment, const ExperimentArguments& arguments);

/// Of verbs that plan: --sheet, by the names that it has there, --decimal, --language and --quiet, among the outputs.
void add_sheet_flags(const Verb& verb, const std::string& names, app::OutputNames& outputs, report::Options& report,
                     bool& quiet);
/// Checks the names of the plan and its sheets; throws a UsageError.
void check_sheet_outputs(const app::OutputNames& outputs);

/// Throws where the name of --out, which is JSON, ends as that of something else; `instead` says what writes that.
void check_json_out(const std::string& out, const std::string& instead);

}  // namespace axiometry::cli
