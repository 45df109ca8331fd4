// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <cstdio>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "axiometry/app/outputs.h"
#include "axiometry/app/plan.h"
#include "axiometry/app/plan_text.h"
#include "axiometry/base/number_text.h"
#include "axiometry/base/text.h"
#include "commands.h"
#include "failure.h"
#include "option_text.h"
#include "plan_summary.h"

namespace axiometry::cli {
namespace {

struct PlanArguments {
  iso230_2::PlanRequest request;
  std::optional<std::uint64_t> seed;
  std::vector<std::string> areas;       ///< understood when the kind of the axis is known
  std::optional<std::string> sequence;  ///< a list, or a file that is read when the command runs
  std::optional<Position> periodic_at;
  std::string check;
  app::OutputNames outputs;
  report::Options report;
  bool quiet = false;
};

Result<void> read_targets(iso230_2::PlanRequest& request, const std::string& text) {
  if (const auto count = parse_count(text)) {
    request.count = *count;
    return {};
  }
  AXIOMETRY_TRY(const std::vector<double> positions, app::parse_positions(text));
  for (double x : positions) request.targets.push_back(Position::native(x));
  return {};
}

Result<TestCycle> read_cycle(const std::string& text) {
  using enum TestCycle;
  for (TestCycle cycle : {standard, step, pilgrim, unidirectional, user_defined})
    if (cycle_name(cycle) == text) return cycle;
  return fail(
      fmt::format("found {}, expected standard, step, pilgrim, unidirectional or user-defined", text::quoted(text)));
}

auto into(std::optional<iso230_2::Stretch>& target) {
  return [&target](const std::string& text) -> Result<void> {
    AXIOMETRY_TRY(target, app::parse_stretch(text));
    return {};
  };
}

std::vector<CLI::Option*> add_axis_flags(CLI::App& verb, PlanArguments& arguments) {
  iso230_2::PlanRequest& request = arguments.request;
  std::vector<CLI::Option*> options = {
      verb.add_option("--axis", request.axis.name, "Name of the axis")->type_name("NAME"),
      add_read(verb, {"--kind", "KIND", "linear (mm) or rotary (°); linear when not given"},
               [&](const std::string& text) -> Result<void> {
                 if (text != "linear" && text != "rotary")
                   return fail(fmt::format("found {}, expected linear or rotary", text::quoted(text)));
                 request.axis.kind = text == "linear" ? AxisKind::linear : AxisKind::rotary;
                 return {};
               }),
      add_read(verb,
               {"--travel", "FROM:TO",
                "Axis travel (3.1). A rotary axis of exactly 360° is taken for one that turns without end, unless "
                "--soft-limits are given"},
               [&](const std::string& text) -> Result<void> {
                 AXIOMETRY_TRY(const iso230_2::Stretch travel, app::parse_stretch(text));
                 request.axis.travel_begin = travel.from;
                 request.axis.travel_end = travel.to;
                 return {};
               }),
      add_read(verb, {"--soft-limits", "FROM:TO", "Of the control, where they are narrower than the travel"},
               into(request.soft_limits)),
      add_number(
          verb,
          {"--period", "PERIOD",
           "Expected period of a periodic error, such as the pitch of the screw: targets shift by up to one period"},
          [&](double x) { request.axis.expected_period = Position::native(x); }),
      add_read(verb,
               {"--compensation-points", "LIST",
                "Sampling points of the compensation, which targets keep off: 0:500:50 (from, to, every) or a list"},
               [&](const std::string& text) -> Result<void> {
                 AXIOMETRY_TRY(request.axis.compensation_points, app::parse_positions(text));
                 return {};
               }),
      add_number(verb,
                 {"--segment", "LENGTH", "Length of the segments of a scale, each of which is given a target (5.3.3)"},
                 [&](double x) { request.segment = Position::native(x); }),
      add_number(verb, {"--acceleration", "A", "Of the axis, mm/s² or °/s² (1000 or 500)"},
                 [&](double x) { request.acceleration = x; }),
      verb.add_option("--machine", request.machine, "Name of the machine")->type_name("NAME"),
      verb.add_option("--date", request.date, "Date of the plan, such as 2026-11-21; today when not given")
          ->type_name("DATE"),
  };
  for (CLI::Option* option : options) option->group("Axis");
  return options;
}

std::vector<CLI::Option*> add_target_flags(CLI::App& verb, PlanArguments& arguments) {
  iso230_2::PlanRequest& request = arguments.request;
  std::vector<CLI::Option*> options = {
      add_read(verb,
               {"--targets", "N or LIST", "Number of targets, or their positions; as many as the clause asks for"},
               [&](const std::string& text) { return read_targets(request, text); }),
      add_number(verb, {"--interval", "P", "Mean interval of the targets at most"},
                 [&](double x) { request.interval = Position::native(x); }),
      add_number(verb, {"--step", "STEP", "To which targets are rounded (0.001 mm or 0.0001°)"},
                 [&](double x) { request.step = Position::native(x); }),
      add_count(verb,
                {"--seed", "N", "Of the random part of the targets; drawn and written into the plan when not given"},
                [&](unsigned long long seed) { arguments.seed = seed; }),
      verb.add_option("--area", arguments.areas,
                      "Stretch of the normal working area for the tests that belong to one above 2 000 mm or 360°; TO "
                      "may be left out; may be repeated; the middle")
          ->type_name("FROM[:TO]")
          ->allow_extra_args(false),
      add_number(
          verb,
          {"--periodic", "PERIOD",
           "Plan the test for a periodic error of this period (Annex C) instead: dense targets from one direction"},
          [&](double x) {
            request.axis.expected_period = Position::native(x);
            request.periodic.emplace();
          }),
      add_number(verb, {"--at", "POSITION", "Middle of that test; of the travel"},
                 [&](double x) { arguments.periodic_at = Position::native(x); }),
  };
  options.push_back(add_read(verb, {"--measure", "FROM:TO", "Measurement travel (3.2); all that the overruns leave"},
                             into(request.measurement)));
  for (CLI::Option* option : options) option->group("Targets");
  options[6]->needs(options[5]);
  options[5]->excludes(verb.get_option("--period"));
  options[0]->excludes(options[1]);
  options[0]->excludes(options[5]);
  return options;
}

std::vector<CLI::Option*> add_programme_flags(CLI::App& verb, PlanArguments& arguments) {
  iso230_2::PlanRequest& request = arguments.request;
  std::vector<CLI::Option*> options = {
      add_read(verb, {"--cycle", "CYCLE", "standard, step (Annex B), pilgrim, unidirectional or user-defined"},
               [&](const std::string& text) -> Result<void> {
                 AXIOMETRY_TRY(request.cycle, read_cycle(text));
                 return {};
               }),
      add_read(verb,
               {"--sequence", "LIST or FILE",
                "The approaches of the user-defined cycle: '1+ 2+ 2- 1-', numbers of targets and directions"},
               [&](const std::string& text) -> Result<void> {
                 arguments.sequence = text;
                 return {};
               }),
      add_count(verb, {"--runs", "N", "Approaches to each target from each direction (5; 1 above 2 000 mm or 360°)"},
                [&](unsigned long long runs) { request.runs = runs; }),
      add_number(
          verb,
          {"--overrun", "LENGTH",
           "Distance beyond a target before the direction changes (1 % of the travel within 1 and 10, more to reach "
           "the feed)"},
          [&](double x) { request.overrun = Position::native(x); }),
      add_number(verb, {"--feed", "FEED", "mm/min or °/min (1000 or 720)"}, [&](double x) { request.feed = x; }),
      add_number(verb, {"--dwell", "SECONDS", "At rest on every target (3)"},
                 [&](double x) { request.dwell = Duration::s(x); }),
      add_count(verb, {"--warm-up", "N", "Runs there and back before the first reading (1)"},
                [&](unsigned long long runs) { request.warm_up_runs = runs; }),
  };
  for (CLI::Option* option : options) option->group("Programme");
  options[0]->excludes(verb.get_option("--periodic"));
  options[1]->excludes(verb.get_option("--periodic"));
  return options;
}

void add_output_flags(CLI::App& verb, PlanArguments& arguments) {
  constexpr const char* group = "Outputs";
  verb.add_option("--out", arguments.outputs.json,
                  "The plan as JSON to FILE; to the standard output (-) when not given")
      ->check(fault_of_name)
      ->type_name("FILE")
      ->group(group);
  verb.add_option("--sheet", arguments.outputs.reports,
                  "Sheet to take to the machine to FILE, by its extension html, pdf, svg, png or csv; may be repeated")
      ->type_name("FILE")
      ->allow_extra_args(false)
      ->group(group);
  CLI::Option* decimal =
      add_decimal(verb, arguments.report.numbers.decimal_mark, "Decimal mark in summary and sheet: point or comma")
          ->group(group);
  add_language(verb, arguments.report, decimal)->group(group);
  verb.add_flag("--quiet,-q", arguments.quiet, "No summary in the terminal")->group(group);
}

Result<Plan> made_plan(PlanArguments& arguments) {
  iso230_2::PlanRequest& request = arguments.request;
  for (const std::string& text : arguments.areas) {
    AXIOMETRY_TRY(request.areas.emplace_back(), app::parse_area(text, request.axis.kind));
  }
  if (arguments.sequence) {
    AXIOMETRY_TRY(request.sequence, app::read_sequence(*arguments.sequence));
  }
  if (request.periodic) request.periodic->at = arguments.periodic_at;
  request.seed = arguments.seed ? *arguments.seed : app::drawn_seed();
  if (request.date.empty()) request.date = app::today();
  return iso230_2::make_plan(request);
}

int run_plan(PlanArguments& arguments) {
  const bool checks = !arguments.check.empty();
  std::vector<app::InputFile> inputs;
  if (checks) inputs.push_back({arguments.check, false});
  if (arguments.sequence) inputs.push_back({*arguments.sequence, false});
  arguments.outputs.inputs = app::InputFiles(inputs);
  if (auto spared = app::check_inputs_spared(arguments.outputs); !spared) return failed(spared.error(), exit_usage);
  auto plan = checks ? app::read_plan_file(arguments.check) : made_plan(arguments);
  if (!plan) return failed(plan.error());
  const auto planned = app::planned(*std::move(plan), arguments.request.acceleration);
  if (!planned) return failed(planned.error());
  if (auto written = app::write_plan_outputs(*planned, arguments.outputs, arguments.report); !written)
    return failed(written.error());
  if (!arguments.quiet && arguments.outputs.json != "-")
    fmt::print("{}", plan_summary(*planned, arguments.report, Terminal(ColourChoice::automatic)));
  return checks && !planned->conforming() ? exit_exceeded : exit_done;
}

/// What is asked of a plan that is made says nothing about one that is checked.
void settle(CLI::App& verb, PlanArguments& arguments, const std::vector<CLI::Option*>& making) {
  const bool checks = !arguments.check.empty();
  for (const CLI::Option* option : making)
    if (checks && option->count() > 0)
      throw CLI::ValidationError(
          "--check", fmt::format("found {} beside it, expected a plan and its outputs only", option->get_name()));
  if (!checks && verb.count("--travel") == 0)
    throw CLI::ValidationError(
        "found neither --travel nor --check, expected the travel of the axis or a plan to check");
  if (!checks && arguments.outputs.json.empty()) arguments.outputs.json = "-";
  if (auto outputs = app::check_outputs(arguments.outputs); !outputs)
    throw CLI::ValidationError("--sheet", outputs.error().message);
}

}  // namespace

void add_plan(CLI::App& program, int& exit_code) {
  CLI::App* verb =
      program.add_subcommand("plan", "Plan the test of an axis after ISO 230-2:2014, or check such a plan");
  auto arguments = std::make_shared<PlanArguments>();
  std::vector<CLI::Option*> making = add_axis_flags(*verb, *arguments);
  for (CLI::Option* option : add_target_flags(*verb, *arguments)) making.push_back(option);
  for (CLI::Option* option : add_programme_flags(*verb, *arguments)) making.push_back(option);
  std::erase(making, verb->get_option("--acceleration"));
  verb->add_option("--check", arguments->check,
                   "Check this plan, as made or edited, instead of making one; exit code 3 when it "
                   "departs from the standard")
      ->type_name("FILE")
      ->group("Outputs");
  add_output_flags(*verb, *arguments);
  making.push_back(verb->get_option("--out"));
  verb->callback([verb, arguments, making, &exit_code] {
    settle(*verb, *arguments, making);
    exit_code = run_plan(*arguments);
  });
  verb->footer(R"(Examples:
  axiometry plan --axis X --travel 0:500 --period 10 --out plan.json --sheet plan.pdf
  axiometry plan --axis X --travel 0:500 --compensation-points 0:500:50 --seed 7 --out plan.json
  axiometry plan --axis C --kind rotary --travel 0:360 --out plan.json
  axiometry plan --axis Y --travel 0:6000 --area 500 --area 3000 --out plan.json
  axiometry plan --axis X --travel 0:500 --periodic 10 --at 200 --out periodic.json
  axiometry plan --axis X --travel 0:500 --targets 4 --cycle user-defined --sequence '1+ 3+ 4- 2-'
  axiometry plan --check plan.json

Positions are in mm, of rotary axes in degrees.)");
}

}  // namespace axiometry::cli
