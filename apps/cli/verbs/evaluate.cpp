// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <algorithm>
#include <cstdint>
#include <cstdio>
#include <memory>
#include <optional>
#include <string_view>
#include <utility>
#include <vector>
#include "cli/flags/verb.h"

#include "axiometry/app/evaluate/evaluate.h"
#include "axiometry/app/results/outputs.h"
#include "axiometry/base/text/text.h"
#include "axiometry/model/fields.h"
#include "axiometry/report/drawing/utf8.h"
#include "axiometry/report/option_words.h"
#include "cli/flags/capture_flags.h"
#include "cli/flags/correction_flags.h"
#include "cli/flags/option_text.h"
#include "cli/flags/reading_flags.h"
#include "cli/flags/temperature_flags.h"
#include "cli/flags/tolerance_flags.h"
#include "cli/flags/uncertainty_flags.h"
#include "cli/verbs/commands.h"
#include "cli/verbs/evaluate_run.h"

namespace axiometry::cli {
namespace {

/// "uncertainty.machine_temperature_range_C" → "--machine-temperature-range-c"
std::string flag_of(std::string_view key) {
  std::string flag = "--" + text::to_lower(key.substr(key.find('.') + 1));
  std::ranges::replace(flag, '_', '-');
  return flag;
}

/// "Misalignment, in mm (A.4). Of the …"
std::string describe(const Field& field) {
  std::string unit(field.unit_linear);
  if (!field.unit_rotary.empty() && field.unit_rotary != field.unit_linear)
    unit += fmt::format(" or {}", field.unit_rotary);
  std::string text(field.title);
  if (!unit.empty()) text += fmt::format(", in {}", unit);
  if (!field.clause.empty()) text += fmt::format(" ({})", field.clause);
  if (!field.choices.empty()) text += fmt::format(": {}", fmt::join(field.choices, " or "));
  return fmt::format("{}. {}", text, field.description);
}

void add_uncertainty_flags(const Verb& verb, EvaluateArguments& arguments) {
  for (const Field& field : metadata_fields()) {
    if (!field.key.starts_with("uncertainty.") || field.key == "uncertainty.drift_recording") continue;
    const bool records = field.type == FieldType::records;
    verb.add_option_function<std::vector<std::string>>(
            flag_of(field.key),
            [&arguments, key = std::string(field.key)](const std::vector<std::string>& values) {
              for (const std::string& value : values) add_metadata(arguments.evaluate.metadata, key, value);
            },
            describe(field) + (records ? " May be repeated." : ""))
        ->expected(1, records ? any_number : 1)
        ->one_at_a_time()
        ->type_name(field.type == FieldType::number ? "NUMBER"
                    : records                       ? "INPUT|DISTRIBUTION"
                                                    : "WORD")
        ->group("Uncertainty, over what the file says");
  }
}

void add_drift_recording(const Verb& verb, EvaluateArguments& arguments) {
  verb.add_option(
          "--drift-recording", arguments.evaluate.drift_recording,
          "Recording at standstill over the time of a test or longer (A.2.5), time and deviation, in any layout "
          "of continuous recordings ('axiometry formats'). It takes the place of E_VE, of which it then tells "
          "the size.")
      ->type_name("FILE")
      ->group("Uncertainty, over what the file says");
}

void add_temperature_log(const Verb& verb, EvaluateArguments& arguments) {
  constexpr const char* group = "Temperature of the surroundings";
  verb.add_option("--temperatures", arguments.temperatures.file,
                  "Log of temperatures before and during the test (4.1): time and one or more sensors in columns, as "
                  "'axiometry temperatures' reads it")
      ->type_name("FILE")
      ->group(group);
  add_temperature_flags(verb, arguments.temperatures.request, "agreed-", group);
}

/// Flags about a log need one; what was agreed is then as if the test stated it.
void take_temperatures(EvaluateArguments& arguments) {
  const app::TemperatureRequest& request = arguments.temperatures.request;
  if (!arguments.temperatures.file.empty()) {
    arguments.evaluate.temperatures = arguments.temperatures;
    return;
  }
  if (!request.about_log_empty())
    throw UsageError("found flags about a log of temperatures, expected the log too, with --temperatures");
  const auto state = [&](const char* key, const std::optional<double>& x) {
    if (x) arguments.evaluate.metadata.emplace_back(key, format_exact(*x));
  };
  const auto& agreed = request.agreed;
  state("environment.agreed_lowest_C", agreed.lowest.transform(&Temperature::in_celsius));
  state("environment.agreed_highest_C", agreed.highest.transform(&Temperature::in_celsius));
  state("environment.agreed_rate_C_per_h", agreed.rate);
  state("environment.agreed_gradient_C", agreed.machine_gradient.transform(&TemperatureDifference::in_kelvin));
}

/// An option whose value is one of a few words, each standing for a value of `target`.
template <typename Value>
Flag add_choice(const Verb& verb, const std::string& name, Value& target,
                std::vector<std::pair<std::string, Value>> choices, const std::string& description) {
  return verb.add_option_function<std::string>(
      name,
      [name, &target, choices = std::move(choices)](const std::string& word) {
        std::vector<std::string> words;
        for (const auto& [own, value] : choices) {
          if (own == word) {
            target = value;
            return;
          }
          words.push_back(own);
        }
        throw UsageError(name, fmt::format("found {}, expected one of {}", text::quoted(word), fmt::join(words, ", ")));
      },
      description);
}

void add_number_flags(const Verb& verb, EvaluateArguments& arguments) {
  constexpr const char* group = "Numbers in summary and reports";
  add_read(verb, {"--unit", "UNIT", "Unit of the parameters: um, mm, nm, arcsec or deg"},
           [&unit = arguments.report.unit](const std::string& word) -> Result<void> {
             AXIOMETRY_TRY(unit, report::unit_of(word));
             return {};
           })
      ->group(group);
  Flag decimal = add_decimal(verb, arguments.report.numbers.decimal_mark)->group(group);
  add_language(verb, arguments.report, decimal)->group(group);
  verb.add_option("--decimals", arguments.report.deviation_decimals,
                  "Decimals of deviations in µm or arcsec (1, more for a very small A)")
      ->check_range(0, report::most_deviation_decimals)
      ->type_name("N")
      ->group(group);
  verb.add_option("--uncertainty-digits", arguments.report.uncertainty_digits, "Significant digits of U (2)")
      ->check_range(1, 6)
      ->type_name("N")
      ->group(group);
}

void add_output_flags(const Verb& verb, EvaluateArguments& arguments) {
  constexpr const char* group = "Outputs";
  verb.add_option("--json", arguments.outputs.json, "Everything as JSON to FILE, or to the standard output with -")
      ->check(fault_of_name)
      ->type_name("FILE")
      ->group(group);
  verb.add_option(
          "--report", arguments.outputs.reports,
          "Report to FILE, by its extension html, pdf, svg, png or csv; may be repeated. For many tests a .csv holds "
          "a table of all, and {name} in a name makes one report per test")
      ->type_name("FILE")
      ->one_at_a_time()
      ->group(group);
  add_choice(verb, "--color", arguments.colour,
             {{"auto", ColourChoice::automatic}, {"always", ColourChoice::always}, {"never", ColourChoice::never}},
             "Colour in the terminal: auto, always or never")
      ->type_name("WHEN")
      ->group(group);
  verb.add_flag(
          "--verify", arguments.verify,
          "Compute clause 3, Annex A and every verdict once more, by a second, independent way in exact arithmetic, "
          "and "
          "compare all other figures wherever they stand; where one differs nothing is shown or written, and the exit "
          "code is 2")
      ->group(group);
  verb.add_flag("--quiet,-q", arguments.quiet, "No summary in the terminal")->group(group);
  verb.add_flag("--keep-going", arguments.keep_going, "Write combined outputs although some inputs are bad")
      ->group(group);
}

void add_input_flags(const Verb& verb, EvaluateArguments& arguments) {
  constexpr const char* group = "Input";
  verb.add_option("FILE", arguments.inputs, "Measured tests: files, folders, or - for the standard input")->required();
  verb.add_option("--format", arguments.evaluate.format,
                  "Read as this format instead of recognising it (see 'axiometry formats')")
      ->type_name("ID")
      ->group(group);
  verb.add_option("--profile", arguments.evaluate.profile,
                  "Read a table of any layout after this import profile (see 'axiometry convert --guess')")
      ->type_name("FILE")
      ->group(group);
  verb.add_option_function<std::string>(
          "--axis", [&](const std::string& name) { add_metadata(arguments.evaluate.metadata, "axis.name", name); },
          "Name of the axis")
      ->type_name("NAME")
      ->group(group);
  add_metadata_flag(
      verb, arguments.evaluate.metadata,
      "Metadata over what the file says, such as machine.name='Mill 5' (keys: 'axiometry formats metadata')");
  verb.add_flag_function(
          "--artefact,!--no-artefact", [&arguments](std::int64_t count) { arguments.evaluate.artefact = count > 0; },
          "Take the readings for positions that the machine indicated at the balls or faces of an artefact, and "
          "compare "
          "them with artefact.calibrated_positions (Annex D). Done of itself where these are given; --no-artefact "
          "keeps "
          "the readings as deviations")
      ->group(group);
}

void add_flags(const Verb& verb, const std::shared_ptr<EvaluateArguments>& arguments, int& exit_code) {
  add_input_flags(verb, *arguments);
  add_correction_flags(verb, arguments->evaluate.corrections);
  add_capture_flags(verb, arguments->recording);
  add_tolerance_flags(verb, arguments->evaluate.tolerance, arguments->tolerance_table);
  add_output_flags(verb, *arguments);
  add_number_flags(verb, *arguments);
  add_method_flags(verb, arguments->evaluate.uncertainty);
  add_uncertainty_flags(verb, *arguments);
  add_drift_recording(verb, *arguments);
  add_temperature_log(verb, *arguments);
  verb.callback([verb, arguments, &exit_code] {
    take_temperatures(*arguments);
    constexpr bool many_tests_have_threads = true;
    check_method_flags(verb, arguments->evaluate.uncertainty, many_tests_have_threads);
    arguments->outputs.uncertainty = arguments->evaluate.uncertainty;
    if (auto outputs = app::check_outputs(arguments->outputs); !outputs)
      throw UsageError("--report", outputs.error().message);
    arguments->evaluate.many_in_full = app::state_tests_in_full(arguments->outputs);
    arguments->outputs.uncertainty = arguments->evaluate.uncertainty;
    check_capture_flags(verb);
    if (!arguments->recording.plan.empty()) arguments->evaluate.recording = arguments->recording;
    exit_code = run_evaluation(*arguments);
  });
}

}  // namespace

void add_evaluate(const Verb& program, int& exit_code) {
  Verb verb = program.add_subcommand("evaluate", "Evaluate measured tests after ISO 230-2:2014");
  auto arguments = std::make_shared<EvaluateArguments>();
  add_flags(*verb, arguments, exit_code);
  verb->footer(R"(Examples:
  axiometry evaluate test.csv
  axiometry evaluate test.csv --report report.html --report report.pdf
  axiometry evaluate test.csv --device-error-range-um-per-m 3.4 --misalignment-mm 1 --environmental-variation 1.7
  axiometry evaluate test.csv --tolerance A=10um --tolerance R_up=4um --rule iso14253-1
  axiometry evaluate test.csv --correct air=ciddor,dead-path,nde
  axiometry evaluate run.csv --plan x.plan.json      a continuous recording
  axiometry evaluate test.csv --temperatures hall.csv --began 2026-03-02T09:00 --agreed-rate 0.5
  axiometry evaluate machines/ --tolerance-table limits.csv:'Machining centre' --report all.csv
  axiometry evaluate machines/ --json all.json --report all.csv --report 'reports/{name}.pdf'
  zcat big.csv.gz | axiometry evaluate - --quiet --report all.csv

Figures by other rules than ISO 230-2:2014 (earlier editions, VDI/DGQ 3441, JIS, GB/T) stand beside these in
axiometry compare-rules test.csv --standard vdi-dgq-3441.)");
}

void add_uncertainty(const Verb& program, int& exit_code) {
  Verb verb = program.add_subcommand(
      "uncertainty", "State the uncertainty of every parameter by all methods: Annex A, GUM, Monte Carlo");
  auto arguments = std::make_shared<EvaluateArguments>();
  arguments->detail = Detail::full;
  arguments->evaluate.uncertainty.gum = true;
  arguments->evaluate.uncertainty.monte_carlo = true;
  add_flags(*verb, arguments, exit_code);
  verb->footer(R"(As 'evaluate --uncertainty annex-a,gum,monte-carlo'. Examples:
  axiometry uncertainty test.json
  axiometry uncertainty test.json --measurand this-machine --report report.pdf
  axiometry uncertainty test.json --trials 1000000 --seed 7 --json result.json
  axiometry uncertainty test.csv --environmental-variation 1.7
  axiometry uncertainty test.csv --set 'uncertainty.distributions=scale:optics | normal 0 0.2')");
}

}  // namespace axiometry::cli
