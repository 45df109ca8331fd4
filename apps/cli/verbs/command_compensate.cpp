// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <algorithm>
#include <memory>
#include <string>
#include <vector>

#include "axiometry/app/compensate/compensate.h"
#include "axiometry/app/files/output.h"
#include "axiometry/base/number_text.h"
#include "axiometry/base/text.h"
#include "cli/failure.h"
#include "cli/flags/experiment_flags.h"
#include "cli/flags/option_text.h"
#include "cli/flags/verb.h"
#include "cli/verbs/commands.h"

namespace axiometry::cli {
namespace {

constexpr const char* examples =
    R"(The table is read back by the control's own rule and applied to the readings: where that would not make the axis
better, no file is written. What stands beside "predicted" is a prediction; only a re-test proves it: --retest holds one
against it, and names a sign mistake, a table that is not active, or one that is applied twice.
Exit code 3: something must be looked at before the table is used.
Examples:
  axiometry compensate --list
  axiometry compensate x.csv --for linuxcnc --out x.comp --report x.pdf
  axiometry compensate x.csv --for siemens-lec --axis X1 --start 0 --end 500 --step 10 --out x.ini
  axiometry compensate again.csv --for linuxcnc --existing x.comp --out x2.comp
  axiometry compensate x.csv --for linuxcnc --retest after.csv)";

struct Arguments {
  app::CompensateRequest request;
  std::string out;
  bool list = false;
  ExperimentArguments outputs;
};

int list_controls(const Arguments& arguments) {
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

int run(Arguments& arguments) {
  if (arguments.list) return list_controls(arguments);
  app::CompensateRequest& request = arguments.request;
  if (request.file.empty()) throw MissingOption("FILE");
  if (request.control.empty()) throw MissingOption("--for");
  std::vector<app::InputFile> inputs;
  for (const std::string& file : {request.file, request.existing, request.retest})
    if (!file.empty()) inputs.push_back({file, false});
  arguments.outputs.outputs.inputs = app::InputFiles(inputs);
  if (const auto spared = app::check_inputs_spared(arguments.outputs.outputs); !spared)
    return failed(spared.error(), exit_usage);
  if (!arguments.out.empty())
    if (const auto spared = arguments.outputs.outputs.inputs.check_spared(arguments.out); !spared)
      return failed(spared.error(), exit_usage);
  for (const std::string& other : arguments.outputs.outputs.reports)
    if (other == arguments.out) throw UsageError("--out", "found the name of a report too, expected another one");
  if (!arguments.out.empty() && arguments.out == arguments.outputs.outputs.json)
    throw UsageError("--out", "found the name of --json too, expected another one");
  const auto done = app::compensate(request);
  if (!done) return failed(done.error());
  if (!arguments.out.empty())
    if (const auto written = app::write_file(arguments.out, done->text); !written) return failed(written.error());
  if (const int code = finish_experiment(app::present(*done, arguments.outputs.report), arguments.outputs);
      code != exit_done)
    return code;
  return std::ranges::any_of(done->findings, &NamedFinding::serious) ? exit_exceeded : exit_done;
}

Result<double> number_in(const std::string& text) {
  if (const auto number = parse_number(text)) return *number;
  return fail(fmt::format("found {}, expected a number", text::quoted(text)));
}

void add_reading_flags(const Verb& verb, app::EvaluateOptions& reading) {
  constexpr const char* group = "Input";
  verb.add_option("--format", reading.format, "Read as this format instead of recognising it")
      ->type_name("ID")
      ->group(group);
  verb.add_option_function<std::vector<std::string>>(
          "--set",
          [&reading](const std::vector<std::string>& pairs) {
            for (const std::string& pair : pairs) {
              const std::size_t equals = pair.find('=');
              if (equals == std::string::npos)
                throw UsageError("--set", fmt::format("found {}, expected KEY=VALUE", text::quoted(pair)));
              reading.metadata.emplace_back(pair.substr(0, equals), pair.substr(equals + 1));
            }
          },
          "Metadata over what the file says, such as axis.kind=rotary; may be repeated")
      ->type_name("KEY=VALUE")
      ->one_at_a_time()
      ->group(group);
}

void add_grid_flags(const Verb& verb, app::CompensateRequest& request) {
  constexpr const char* group = "Positions of the table, mm or °";
  const auto add_place = [&](const char* name, const char* description, std::optional<double>& target) {
    add_number(verb, {name, "NUMBER", description}, [&target](double x) { target = x; })->group(group);
  };
  add_place("--start", "The first one (within the targets)", request.grid.start);
  add_place("--end", "The last one (within the targets)", request.grid.end);
  add_read(verb, {"--step", "NUMBER", "Their spacing, or auto (auto)"},
           [&request](const std::string& text) -> Result<void> {
             if (text::to_lower(text) == "auto") {
               request.grid.step.reset();
               return {};
             }
             AXIOMETRY_TRY(request.grid.step, number_in(text));
             return {};
           })
      ->group(group);
  add_count(verb, {"--points", "N", "How many"}, [&request](unsigned long long n) {
    request.grid.points = static_cast<std::size_t>(n);
  })->group(group);
  verb.add_flag("--hold-ends", request.hold_ends,
                "Beyond the targets hold the value at the last one, which nobody measured there")
      ->group(group);
  add_number(verb, {"--reference", "NUMBER", "Reference point of the machine, where the table does nothing (0)"},
             [&request](double x) { request.table.reference = x; })
      ->group(group);
}

void add_table_flags(const Verb& verb, app::CompensateRequest& request) {
  constexpr const char* group = "Table";
  verb.add_option("--axis", request.axis, "As the control names it (as the test does)")
      ->type_name("AXIS")
      ->group(group);
  verb.add_option("--existing", request.existing,
                  "The table that was active while the test was measured: the new one replaces it, at its positions")
      ->type_name("FILE")
      ->group(group);
  add_read(verb, {"--method", "WORD", "least-squares of all readings, or interpolation of means (least-squares)"},
           [&request](const std::string& text) -> Result<void> {
             if (text != "least-squares" && text != "interpolation")
               return fail(fmt::format("found {}, expected least-squares or interpolation", text::quoted(text)));
             request.method =
                 text == "interpolation" ? compensation::Method::interpolation : compensation::Method::least_squares;
             return {};
           })
      ->group(group);
  verb.add_flag("--smooth", request.smooth, "As smooth as foretells targets best that are left out")->group(group);
  add_read(verb, {"--curves", "WORD", "both-ways: one curve although the control has one for each direction"},
           [&request](const std::string& text) -> Result<void> {
             if (text != curves_name(TableCurves::both_ways))
               return fail(fmt::format("found {}, expected both-ways", text::quoted(text)));
             request.curves = TableCurves::both_ways;
             return {};
           })
      ->group(group);
  verb.add_flag("--inch", request.table.in_inch, "The control counts in inches")->group(group);
  add_count(verb, {"--number", "N", "Of the table, encoder, joint or first point, as the control counts (0)"},
            [&request](unsigned long long n) { request.table.number = static_cast<unsigned>(std::min(n, 99'999ull)); })
      ->group(group);
  add_read(verb, {"--resolution", "NUMBER", "What one count of the control stands for, µm or ″ (1)"},
           [&request](const std::string& text) -> Result<void> {
             AXIOMETRY_TRY(request.table.resolution, number_in(text));
             if (request.table.resolution >= 1e-6 && request.table.resolution <= 1e4) return {};
             return fail(fmt::format("found {}, expected a number from 0.000001 to 10000", text::quoted(text)));
           })
      ->group(group);
  add_count(verb, {"--magnification", "N", "By which the control multiplies the table's numbers (1)"},
            [&request](unsigned long long n) {
              request.table.magnification = static_cast<unsigned>(std::clamp(n, 1ull, 1000ull));
            })
      ->group(group);
  add_count(verb,
            {"--largest", "N", "Number that the control takes in its table (the least that is known of its kind)"},
            [&request](unsigned long long n) { request.table.largest = static_cast<unsigned>(std::min(n, 99'999ull)); })
      ->group(group);
  add_read(verb, {"--steps-per-unit", "NUMBER", "Steps per mm or ° of a control without tables, before any change"},
           [&request](const std::string& text) -> Result<void> {
             AXIOMETRY_TRY(request.table.steps_per_unit, number_in(text));
             if (request.table.steps_per_unit > 0.0 && request.table.steps_per_unit <= 1e7) return {};
             return fail(fmt::format("found {}, expected a number above 0, at most 10000000", text::quoted(text)));
           })
      ->group(group);
}

}  // namespace

void add_compensate(const Verb& program, int& exit_code) {
  Verb verb =
      program.add_subcommand("compensate", "The table by which a control corrects an axis, from a measured test");
  verb->footer(examples);
  auto arguments = std::make_shared<Arguments>();
  verb->add_option("FILE", arguments->request.file, "Measured test, or - for the standard input");
  verb->add_flag("--list", arguments->list, "The controls that there are, and what of each is verified");
  verb->add_option("--for", arguments->request.control, "One of --list")->type_name("CONTROL");
  Flag out = verb->add_option("--out", arguments->out, "The table to FILE, or to the standard output with -")
                 ->check(fault_of_name)
                 ->type_name("FILE")
                 ->group("Outputs");
  verb->add_option("--retest", arguments->request.retest,
                   "A test with the new table active, to be held against the prediction")
      ->type_name("FILE")
      ->excludes(out);
  add_grid_flags(*verb, arguments->request);
  add_table_flags(*verb, arguments->request);
  add_reading_flags(*verb, arguments->request.reading);
  add_experiment_flags(*verb, arguments->outputs);
  verb->callback([arguments, &exit_code] {
    check_experiment_outputs(arguments->outputs);
    exit_code = run(*arguments);
  });
}

}  // namespace axiometry::cli
