// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <algorithm>
#include <cstdio>
#include <functional>
#include <memory>
#include <string>
#include <vector>
#include "cli/flags/verb.h"

#include "axiometry/app/results/second_opinion.h"
#include "axiometry/app/tracking/tracking_evaluate.h"
#include "cli/failure.h"
#include "cli/flags/capture_flags.h"
#include "cli/flags/length_flags.h"
#include "cli/flags/option_text.h"
#include "cli/flags/uncertainty_flags.h"
#include "cli/text/progress.h"
#include "cli/text/terminal.h"
#include "cli/text/tracking_lines_text.h"
#include "cli/verbs/commands.h"
#include "cli/verbs/tracking/tracking.h"

namespace axiometry::cli {
namespace {

struct TrackingEvaluateArguments {
  std::string file;
  app::TrackingEvaluateOptions evaluate;
  std::string tolerance_table;
  app::OutputNames outputs;
  std::string tests;
  report::Options report;
  bool verify = false;
  bool quiet = false;
};

Result<void> open_table(TrackingEvaluateArguments& a) {
  if (a.tolerance_table.empty()) return {};
  const auto [file, name] = app::parse_table_name(a.tolerance_table);
  AXIOMETRY_TRY(a.evaluate.tolerance.table, app::open_tolerance_table(file));
  a.evaluate.tolerance.table_name = name;
  return {};
}

std::vector<app::InputFile> inputs_of(const TrackingEvaluateArguments& a) {
  std::vector<app::InputFile> inputs{{a.file}, {a.evaluate.plan}};
  if (!a.evaluate.station.empty()) inputs.push_back({a.evaluate.station});
  if (a.evaluate.tolerance.table) inputs.push_back({a.evaluate.tolerance.table->file});
  return inputs;
}

/// A result that should not be used as it is counts as one that does not conform, as in `tracking locate`.
int exit_code_of(const app::EvaluatedLines& evaluated) {
  using uncertainty::Verdict;
  bool exceeded = std::ranges::any_of(evaluated.evaluation.findings, &tracking::Finding::serious);
  bool undecided = false;
  for (const app::Evaluated& e : evaluated.tests) {
    const auto verdict = iso230_2::overall_verdict(e.judgements);
    exceeded = exceeded || verdict == Verdict::does_not_conform;
    undecided = undecided || verdict == Verdict::undecided || verdict == Verdict::not_applicable;
  }
  return exceeded ? exit_exceeded : undecided ? exit_undecided : exit_done;
}

Result<app::EvaluatedLines> evaluated(TrackingEvaluateArguments& a) {
  ProgressBar bar(!a.quiet);
  a.evaluate.uncertainty.trials.propagation.on_progress = std::ref(bar);
  AXIOMETRY_TRY(auto result, app::evaluate_tracking(a.file, a.evaluate));
  for (app::Evaluated& line : result.tests) {
    if (!a.verify) break;
    AXIOMETRY_TRY(line.verified, app::second_opinion(line, a.evaluate.uncertainty, a.report));
  }
  return result;
}

int run(TrackingEvaluateArguments& a) {
  if (auto table = open_table(a); !table) return failed(table.error());
  const std::vector<app::InputFile> inputs = inputs_of(a);
  a.outputs.inputs = app::InputFiles(inputs);
  if (auto spared = app::check_inputs_spared(a.outputs); !spared) return failed(spared.error(), exit_usage);
  const auto result = evaluated(a);
  if (!result) return failed(result.error(), InterruptGuard::interrupted() ? exit_interrupted : exit_bad_input);
  if (!a.quiet && a.outputs.json != "-")
    fmt::print("{}", lines_summary(*result, a.report, Terminal(ColourChoice::automatic)));
  if (auto written = app::write_outputs(*result, a.outputs, a.report); !written) return failed(written.error());
  if (!a.tests.empty())
    if (auto saved = app::save_tests(*result, a.tests, a.outputs.inputs); !saved) return failed(saved.error());
  return exit_code_of(*result);
}

void add_input_flags(const Verb& verb, TrackingEvaluateArguments& a) {
  constexpr const char* group = "Input";
  verb.add_option("FILE", a.file,
                  "Lengths as CSV or as a continuous recording of time and length, or - for the standard input")
      ->required();
  verb.add_option("--plan", a.evaluate.plan, "The plan whose lines were measured (axiometry tracking plan)")
      ->required()
      ->check(fault_of_empty_name)
      ->type_name("FILE")
      ->group(group);
  verb.add_option("--station", a.evaluate.station,
                  "The station as it was located (axiometry tracking locate --json), in place of the plan's")
      ->check(fault_of_empty_name)
      ->type_name("FILE")
      ->group(group);
}

void add_output_flags(const Verb& verb, TrackingEvaluateArguments& a) {
  constexpr const char* group = "Outputs";
  verb.add_option("--json", a.outputs.json, "Everything as JSON to FILE, or to the standard output with -")
      ->check(fault_of_empty_name)
      ->type_name("FILE")
      ->group(group);
  verb.add_option("--report", a.outputs.reports,
                  "One report of all lines to FILE, by its extension html, pdf, svg, png or csv; may be repeated")
      ->type_name("FILE")
      ->one_at_a_time()
      ->group(group);
  verb.add_option("--save-tests", a.tests,
                  "The test of each line to a file of its own, such as 'tests/{name}.json', for 'axiometry evaluate'")
      ->check(fault_of_empty_name)
      ->type_name("FILE")
      ->group(group);
  Flag decimal = add_decimal(verb, a.report.numbers.decimal_mark)->group(group);
  add_language(verb, a.report, decimal)->group(group);
  verb.add_flag(
          "--verify", a.verify,
          "Compute clause 3, Annex A and every verdict of each line once more by a second, independent way in exact "
          "arithmetic, and compare all other figures; where one differs nothing is shown or written, and the exit "
          "code is 2")
      ->group(group);
  verb.add_flag("--quiet,-q", a.quiet, "No summary in the terminal")->group(group);
}

}  // namespace

void add_tracking_evaluate(const Verb& tracking, int& exit_code) {
  Verb verb = tracking.add_subcommand("evaluate", "Evaluate lengths measured along the lines of a plan");
  auto arguments = std::make_shared<TrackingEvaluateArguments>();
  add_input_flags(*verb, *arguments);
  app::TrackingEvaluateOptions& evaluate = arguments->evaluate;
  add_lines_flags(*verb, evaluate, arguments->tolerance_table);
  add_length_switches(
      *verb, [arguments] { arguments->evaluate.reversed = true; },
      [arguments] { arguments->evaluate.find_breaks = false; });
  add_length_recording_flags(*verb, evaluate.recording);
  add_method_flags(*verb, arguments->evaluate.uncertainty);
  add_output_flags(*verb, *arguments);
  verb->callback([verb, arguments, &exit_code] {
    check_method_flags(*verb, arguments->evaluate.uncertainty);
    if (auto outputs = app::check_outputs(arguments->outputs); !outputs)
      throw UsageError("--report", outputs.error().message);
    const InterruptGuard guard;
    exit_code = run(*arguments);
  });
  verb->footer(
      R"(The file has the columns line,target,direction,run,length_difference_mm, or length_difference_mm alone in
the order of the program; or it is a continuous recording of the whole measurement in a layout of 'axiometry formats':
standstills are then found and matched to the plan. Examples:
  axiometry tracking evaluate lengths.csv --plan seven.json --station located.json
  axiometry tracking evaluate run.csv --plan seven.json
  axiometry tracking evaluate lengths.csv --plan seven.json --json - --save-tests 'tests/{name}.json'
  axiometry tracking evaluate lengths.csv --plan seven.json --tolerance A=10um --tolerance xy:E=20um

Exit codes: 0 done, 1 usage, 2 bad input, 3 a parameter does not conform or a finding is serious, 4 undecided.)");
}

}  // namespace axiometry::cli
