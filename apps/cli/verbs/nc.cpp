// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <cstdio>
#include <memory>
#include <string>
#include "cli/flags/verb.h"

#include "axiometry/app/plan/nc_program.h"
#include "axiometry/base/text/number_text.h"
#include "axiometry/base/text/text.h"
#include "axiometry/nc/numbers.h"
#include "cli/failure.h"
#include "cli/flags/option_text.h"
#include "cli/text/terminal.h"
#include "cli/verbs/commands.h"

namespace axiometry::cli {
namespace {

constexpr const char* nc_examples = R"(Examples:
  axiometry nc plan.json --dialect fanuc --out O2302.nc
  axiometry nc plan.json --dialect siemens-840d --inch --trigger 27 > X_TEST.MPF
  axiometry nc plan.json --dialect linuxcnc --unrolled --stop-at-start
  axiometry nc c.plan.json --dialect siemens-840d --rollover on          a rotary axis that counts to 360° only
  axiometry nc plan.json --dialect fanuc --frame G55 --trigger 27
  axiometry nc tracking.json --dialect linuxcnc --out lines.ngc          all lines in one program
  axiometry nc tracking.json --line xy --dialect heidenhain              one of them
  axiometry nc volume.json --part 2 --dialect fanuc --stop-at-start      one station with one tool
  axiometry nc --list
  axiometry nc --manual heidenhain      what the program assumes of the control

Exit codes: 0 done, 1 usage, 2 bad plan, or one that the control cannot be told.)";

struct NcArguments {
  app::NcRequest request;
  std::string output = "-";
  std::string manual;
  std::string trigger;
  unsigned number = 0;
  bool list = false;
  std::string rollover = "off";
  bool inch = false;
  bool no_block_numbers = false;
};

/// "27" or "M27"; which of them a control takes is asked later.
unsigned m_code_in(const std::string& text) {
  std::string_view digits = text;
  if (digits.starts_with('M') || digits.starts_with('m')) digits.remove_prefix(1);
  const auto code = parse_count(digits);
  constexpr unsigned long long code_most = 99'999;  // a code higher than any control has
  if (code && *code <= code_most) return static_cast<unsigned>(*code);
  throw UsageError("--trigger",
                   fmt::format("found {}, expected the number of an M code, one of those that 'axiometry nc "
                               "--manual ID' names",
                               text::quoted(text)));
}

void list_dialects() {
  for (const nc::Dialect* dialect : nc::dialect_table())
    fmt::print("{}{}{}{}\n", left(dialect->id, 14), left(dialect->extension, 6),
               left(dialect->has_loops ? "loops" : "no loops", 10), dialect->title);
  fmt::print("\n'axiometry nc --manual ID' explains one.\n");
}

int run(const NcArguments& arguments) {
  if (arguments.list) {
    list_dialects();
    return exit_done;
  }
  if (!arguments.manual.empty()) {
    const auto dialect = app::dialect_of(arguments.manual);
    if (!dialect) throw UsageError("--manual", dialect.error().message);
    fmt::print("{}\n\nAxes: {}\n", (*dialect)->manual, (*dialect)->axes);
    return exit_done;
  }
  if (arguments.request.plan.empty()) throw MissingOption("PLAN.json");
  if (arguments.request.dialect.empty()) throw MissingOption("--dialect");
  if (const auto known = app::dialect_of(arguments.request.dialect); !known)
    throw UsageError("--dialect", known.error().message);
  const auto written = app::write_nc_program(arguments.request, arguments.output);
  return written ? exit_done : failed(written.error());
}

}  // namespace

void add_nc(const Verb& program, int& exit_code) {
  Verb verb = program.add_subcommand("nc", "Write the part program that walks a plan, for one of many controls");
  auto arguments = std::make_shared<NcArguments>();
  auto& options = arguments->request.options;
  verb->add_option("PLAN.json", arguments->request.plan,
                   "Plan, as 'plan', 'tracking plan' or 'volumetric plan' writes it; - for the standard input");
  verb->add_option("--dialect", arguments->request.dialect, "Control to write for (axiometry nc --list)")
      ->type_name("ID");
  verb->add_option("--out", arguments->output, "File of the program; - for the standard output (-)")->type_name("FILE");
  add_count(*verb,
            {"--part", "N",
             "Which test of the plan: 1 the plan itself, 2 … its further ones; which run of a volumetric plan (1)"},
            [arguments](unsigned long long n) { arguments->request.part = static_cast<std::size_t>(n); });
  verb->add_option("--line", arguments->request.line, "One line of a tracking plan; all of them when not given")
      ->type_name("ID");
  verb->add_flag("--unrolled", options.unrolled, "No loops and variables, every run written out");
  verb->add_flag("--inch", arguments->inch, "Program in inches; angles stay in degrees");
  const Flag trigger =
      verb->add_option("--trigger", arguments->trigger, "M code put out at each target after half the dwell")
          ->type_name("M");
  const Flag number =
      verb->add_option("--number", arguments->number, "Program number, where the control has one")->type_name("N");
  verb->add_option("--decimals", options.decimals, "Decimals of coordinates, more where the targets need them (4)")
      ->check_range(0, nc::decimals_highest)
      ->type_name("N");
  verb->add_flag("--no-block-numbers", arguments->no_block_numbers, "Blocks without N words");
  verb->add_flag("--stop-at-start", options.stop_at_start, "Stop before the first target, to set the instrument");
  verb->add_flag("--stop-at-lines", options.stop_at_lines,
                 "The same before each line of a tracking plan, to find the beam again");
  verb->add_option(
          "--frame", options.frame,
          "Whose coordinates positions are: active (what the control has then), machine, or a work offset such "
          "as G54 (active)")
      ->type_name("FRAME");
  verb->add_option("--rollover", arguments->rollover,
                   "on where the rotary axis counts to 360° only (modulo): words that say which way (off)")
      ->type_name("on|off");
  const Flag list = verb->add_flag("--list", arguments->list, "List the dialects");
  verb->add_option("--manual", arguments->manual, "Explain a dialect")->type_name("ID")->excludes(list);
  verb->footer(nc_examples);
  verb->callback([arguments, verb, trigger, number, &exit_code] {
    check_alone(*verb, "--list");
    check_alone(*verb, "--manual");
    auto& chosen = arguments->request.options;
    const std::string rollover = text::to_lower(arguments->rollover);
    if (rollover != "on" && rollover != "off")
      throw UsageError("--rollover", fmt::format("found {}, expected on or off", text::quoted(arguments->rollover)));
    chosen.rollover = rollover == "on";
    if (arguments->inch) chosen.unit = nc::LengthUnit::inch;
    chosen.block_numbers = !arguments->no_block_numbers;
    if (trigger->count() > 0) chosen.trigger_m_code = m_code_in(arguments->trigger);
    if (number->count() > 0) chosen.number = arguments->number;
    exit_code = run(*arguments);
  });
}

}  // namespace axiometry::cli
