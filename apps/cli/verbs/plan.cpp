// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <algorithm>
#include <cstdio>
#include <memory>
#include <string>
#include <string_view>
#include <vector>
#include "cli/flags/experiment_flags.h"
#include "cli/flags/verb.h"

#include "axiometry/app/plan/plan.h"
#include "axiometry/app/plan/plan_request.h"
#include "axiometry/app/results/outputs.h"
#include "cli/failure.h"
#include "cli/flags/option_text.h"
#include "cli/text/plan_summary.h"
#include "cli/verbs/commands.h"

namespace axiometry::cli {
namespace {

struct PlanArguments {
  app::PlanRequestDraft wish;
  std::string check;
  app::OutputNames outputs;
  report::Options report;
  bool quiet = false;
};

std::vector<Flag> add_plan_flags(const Verb& verb, app::PlanRequestDraft& wish) {
  std::vector<Flag> flags;
  for (const app::PlanOption& option : app::plan_options()) {
    const std::string name(option.name);
    const auto read = [&option, &wish, name](const std::string& text) {
      if (Result<void> done = option.apply(text, wish); !done) throw UsageError(name, done.error().message);
    };
    Flag flag =
        option.repeated
            ? verb.add_option_function<std::vector<std::string>>(
                      name, [read](const std::vector<std::string>& texts) { std::ranges::for_each(texts, read); },
                      std::string(option.help))
                  ->one_at_a_time()
            : verb.add_option_function<std::string>(name, read, std::string(option.help));
    flags.push_back(flag->type_name(std::string(option.values))->group(std::string(option.group)));
  }
  for (const app::PlanOptionPair& pair : app::plan_options_apart())
    verb.get_option(std::string(pair.name))->excludes(verb.get_option(std::string(pair.other)));
  verb.get_option("--at")->needs(verb.get_option("--periodic"));
  return flags;
}

void add_output_flags(const Verb& verb, PlanArguments& arguments) {
  constexpr const char* group = "Outputs";
  verb.add_option("--out", arguments.outputs.json,
                  "The plan as JSON to FILE; to the standard output (-) when not given")
      ->check(fault_of_name)
      ->type_name("FILE")
      ->group(group);
  add_sheet_flags(verb, "--sheet", arguments.outputs, arguments.report, arguments.quiet);
}

/// The sequence may be a file, which is read when the command runs.
Result<Plan> made_plan(app::PlanRequestDraft& wish) {
  if (wish.sequence) {
    AXIOMETRY_TRY(wish.request.sequence, app::read_sequence(*wish.sequence));
  }
  AXIOMETRY_TRY(const iso230_2::PlanRequest request, app::completed(wish));
  AXIOMETRY_TRY(Plan plan, iso230_2::make_plan(request));
  AXIOMETRY_TRY_VOID(app::check_seed_used(wish, plan));
  return plan;
}

int run_plan(PlanArguments& arguments) {
  const bool checks = !arguments.check.empty();
  std::vector<app::InputFile> inputs;
  if (checks) inputs.push_back({arguments.check, false});
  if (arguments.wish.sequence) inputs.push_back({*arguments.wish.sequence, false});
  arguments.outputs.inputs = app::InputFiles(inputs);
  if (auto spared = app::check_inputs_spared(arguments.outputs); !spared) return failed(spared.error(), exit_usage);
  auto plan = checks ? app::read_plan_file(arguments.check) : made_plan(arguments.wish);
  if (!plan) return failed(plan.error());
  const auto planned = app::planned(*std::move(plan), arguments.wish.request.acceleration);
  if (!planned) return failed(planned.error());
  if (auto written = app::write_plan_outputs(*planned, arguments.outputs, arguments.report); !written)
    return failed(written.error());
  if (!arguments.quiet && arguments.outputs.json != "-")
    fmt::print("{}", plan_summary(*planned, arguments.report, Terminal(ColourChoice::automatic)));
  return checks && !planned->conforming() ? exit_exceeded : exit_done;
}

/// "C", "c", "B2": axes that turn, by the names of ISO 841. A plan of one in mm would be no test of it.
bool turns_by_its_name(std::string_view axis) {
  return !axis.empty() && std::string_view("ABCabc").find(axis.front()) != std::string_view::npos &&
         std::ranges::all_of(axis.substr(1), [](char c) { return c >= '0' && c <= '9'; });
}

/// What is asked of a plan that is made says nothing about one that is checked.
void settle(const Verb& verb, PlanArguments& arguments, const std::vector<Flag>& making) {
  const bool checks = !arguments.check.empty();
  for (Flag option : making)
    if (checks && option->count() > 0)
      throw UsageError("--check",
                       fmt::format("found {} beside it, expected a plan and its outputs only", option->get_name()));
  if (!checks && verb.count("--travel") == 0)
    throw UsageError("found neither --travel nor --check, expected the travel of the axis or a plan to check");
  if (const std::string& axis = arguments.wish.request.axis.name;
      !checks && verb.count("--kind") == 0 && turns_by_its_name(axis))
    throw UsageError("--kind", fmt::format("found none of the axis {}, whose name is that of one that turns, expected "
                                           "rotary or linear",
                                           axis));
  if (!checks && arguments.outputs.json.empty()) arguments.outputs.json = "-";
  check_sheet_outputs(arguments.outputs);
}

}  // namespace

void add_plan(const Verb& program, int& exit_code) {
  Verb verb = program.add_subcommand("plan", "Plan the test of an axis after ISO 230-2:2014, or check such a plan");
  auto arguments = std::make_shared<PlanArguments>();
  std::vector<Flag> making = add_plan_flags(*verb, arguments->wish);
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
