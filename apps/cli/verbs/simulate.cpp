// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <cstdio>
#include <memory>
#include <string>
#include <vector>
#include "cli/flags/verb.h"

#include "axiometry/app/simulate/simulate.h"
#include "axiometry/base/counted.h"
#include "axiometry/base/text/number_text.h"
#include "axiometry/base/text/text.h"
#include "axiometry/simulation/presets.h"
#include "cli/failure.h"
#include "cli/flags/option_text.h"
#include "cli/text/terminal.h"
#include "cli/verbs/commands.h"

namespace axiometry::cli {
namespace {

constexpr const char* simulate_examples = R"(Examples:
  axiometry simulate --fault backlash --out test.json           what play looks like
  axiometry simulate --backlash 3um --cyclic 10mm:1.5um --noise 0.1um --seed 7 --out test.json
  axiometry simulate --plan plan.json --fault mixed --raw recording.csv --rate 1000 --truth truth.json
  axiometry simulate --list-faults

Sizes are in um, mm and so on, on a rotary axis in arcsec or deg. Without --fault only what is given is wrong.)";

struct SimulateArguments {
  std::string fault;
  std::uint64_t seed = 1;
  bool list_faults = false;
  bool quiet = false;
  app::SimulationOutputs outputs;
  std::vector<std::vector<std::string>> options{app::simulation_options().size()};
};

int print_faults() {
  for (const simulation::Preset& preset : simulation::presets())
    fmt::print("{}{}\n{}{}\n", left(preset.id, 29), preset.title, std::string(29, ' '), wrapped(preset.sign, 100, 29));
  return exit_done;
}

void choose_fault(const SimulateArguments& arguments, app::SimulationRequest& request) {
  if (arguments.fault.empty()) return;
  const simulation::Preset* preset = simulation::find_preset(arguments.fault);
  if (preset == nullptr) {
    std::vector<std::string_view> known;
    for (const simulation::Preset& p : simulation::presets()) known.push_back(p.id);
    const auto near = text::nearest(arguments.fault, known);
    throw UsageError("--fault", fmt::format("found {}, expected {}", text::quoted(arguments.fault),
                                            near ? fmt::format("perhaps {}", *near)
                                                 : std::string("one that 'axiometry simulate --list-faults' lists")));
  }
  request.simulate.axis = preset->make(request.simulate.plan);
  request.simulate.fault = preset->id;
}

void choose_options(const SimulateArguments& arguments, app::SimulationRequest& request) {
  const auto options = app::simulation_options();
  for (std::size_t k = 0; k < options.size(); ++k) {
    const std::vector<std::string>& texts = arguments.options[k];
    if (texts.empty()) continue;
    const std::string name(options[k].name);
    if (options[k].group == app::recording_group && arguments.outputs.raw.empty())
      throw UsageError(name, "found no recording that it could change, expected --raw");
    if (const auto applied = options[k].apply(texts, request); !applied)
      throw UsageError(name, applied.error().message);
    std::string& fault = request.simulate.fault;
    for (const std::string& text : texts) fault += fmt::format("{}{} {}", fault.empty() ? "" : ", ", name, text);
  }
}

/// "True in this test: A 9.79 E 7.69 µm"; of a test from one direction its unidirectional parameters.
std::string true_text(const app::SimulationSummary& summary, AxisKind kind) {
  std::string both, each;
  for (const auto& info : iso230_2::parameters)
    if (const auto& x = summary.true_parameters.*info.member; x && info.acceptance)
      (info.key.size() == 1 ? both : each) += fmt::format(" {} {}", info.symbol, format_fixed(x->in_native(), 2));
  if (both.empty() && each.empty())
    return "True in this test: no figure, it has none of the parameters that acceptance uses";
  return fmt::format("True in this test:{} {}", both.empty() ? each : both, deviation_unit(kind));
}

void print_summary(const SimulateArguments& arguments, const app::SimulationSummary& summary, AxisKind kind) {
  const app::SimulationOutputs& out = arguments.outputs;
  if (arguments.quiet || out.test == "-" || out.raw == "-" || out.truth == "-") return;
  if (!out.test.empty())
    fmt::print("{}: {} at {}, seed {}\n", out.test, counted(summary.readings, "reading"),
               counted(summary.targets, "target"), arguments.seed);
  if (!out.raw.empty())
    fmt::print("{}: {} in {} s\n", out.raw, counted(summary.samples, "sample"),
               format_fixed(summary.duration.in_s(), 1));
  if (!out.truth.empty()) fmt::print("{}: the truth\n", out.truth);
  fmt::print("{}\n", true_text(summary, kind));
}

int simulate(const SimulateArguments& arguments) {
  if (arguments.list_faults) return print_faults();
  const app::SimulationOutputs& out = arguments.outputs;
  if (out.test.empty() && out.raw.empty() && out.truth.empty())
    throw UsageError("found no output, expected --out, --raw or --truth");
  if (const auto checked = app::check_simulation_outputs(out); !checked) throw UsageError(checked.error().to_string());
  app::SimulationRequest request;
  request.simulate.seed = arguments.seed;
  auto plan = app::simulation_plan(out.plan);
  if (!plan) return failed(plan.error());
  request.simulate.plan = std::move(*plan);
  choose_fault(arguments, request);
  if (!arguments.outputs.pitch_table.empty()) {
    auto table = app::read_pitch_table(arguments.outputs.pitch_table);
    if (!table) return failed(table.error());
    request.simulate.axis.pitch.table = std::move(*table);
    request.simulate.fault += request.simulate.fault.empty() ? "--pitch-table" : ", --pitch-table";
  }
  choose_options(arguments, request);
  const auto summary = app::run_simulation(request, out);
  if (!summary) return failed(summary.error());
  print_summary(arguments, *summary, request.simulate.plan.axis.kind);
  return exit_done;
}

void add_output_options(const Verb& verb, SimulateArguments& arguments) {
  constexpr const char* group = "Outputs";
  verb.add_option("--out", arguments.outputs.test, "Readings, as a test that 'axiometry evaluate' reads")
      ->type_name("FILE")
      ->group(group);
  verb.add_option("--raw", arguments.outputs.raw,
                  "What the instrument says all the time: .csv or .txt (time and position), .npy, or .umd (counts)")
      ->type_name("FILE")
      ->group(group);
  verb.add_option("--truth", arguments.outputs.truth, "What was true, as JSON (docs/howto/simulate.md)")
      ->type_name("FILE")
      ->group(group);
  verb.add_flag("--quiet,-q", arguments.quiet, "No summary in the terminal")->group(group);
}

}  // namespace

void add_simulate(const Verb& program, int& exit_code) {
  Verb verb = program.add_subcommand("simulate", "Make readings and recordings of an axis with known faults");
  verb->footer(simulate_examples);
  auto arguments = std::make_shared<SimulateArguments>();
  verb->add_option("--plan", arguments->outputs.plan, "Plan to walk (a standard one of 500 mm when there is none)")
      ->type_name("FILE");
  verb->add_option("--fault", arguments->fault, "Axis in good order but for this fault (see --list-faults)")
      ->type_name("ID");
  verb->add_flag("--list-faults", arguments->list_faults, "List the faults with how they show, and exit");
  add_seed(*verb, "Seed of all that is random (1): the same seed gives the same bits",
           [arguments](unsigned long long seed) { arguments->seed = seed; });
  add_output_options(*verb, *arguments);
  const auto options = app::simulation_options();
  verb->add_option("--pitch-table", arguments->outputs.pitch_table,
                   "Errors of the scale from a file: position, deviation")
      ->type_name("FILE")
      ->group(std::string(options.front().group));
  for (std::size_t k = 0; k < options.size(); ++k) {
    const app::SimulationOption& option = options[k];
    verb->add_option(std::string(option.name), arguments->options[k], std::string(option.help))
        ->type_name(std::string(option.values))
        ->expected(1, option.repeated ? any_number : 1)
        ->one_at_a_time()
        ->group(std::string(option.group));
  }
  verb->callback([arguments, &exit_code] { exit_code = simulate(*arguments); });
}

}  // namespace axiometry::cli
