// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <algorithm>
#include <cstdio>
#include <memory>
#include <string>
#include <vector>
#include "cli/flags/verb.h"

#include "axiometry/app/periodic/periodic.h"
#include "axiometry/base/counted.h"
#include "axiometry/base/text/number_text.h"
#include "axiometry/base/text/text.h"
#include "axiometry/report/drawing/utf8.h"
#include "axiometry/report/periodic.h"
#include "axiometry/report/translated.h"
#include "cli/failure.h"
#include "cli/flags/experiment_flags.h"
#include "cli/flags/option_text.h"
#include "cli/flags/reading_flags.h"
#include "cli/text/findings_text.h"
#include "cli/text/terminal.h"
#include "cli/text/title_text.h"
#include "cli/verbs/commands.h"

namespace axiometry::cli {
namespace {

using iso230_2::PeriodicDirection;

struct PeriodicArguments {
  std::string file;
  app::EvaluateOptions reading;
  iso230_2::PeriodicOptions options;
  app::OutputNames outputs;
  report::Options report;
  ColourChoice colour = ColourChoice::automatic;
  bool quiet = false;
};

std::string heading(const app::EvaluatedPeriodic& e, const report::Options& options, const Terminal& terminal) {
  const Metadata& m = e.test.metadata;
  const std::string title = title_text(m.axis, m.machine.name, options);
  const Provenance& p = e.test.provenance;
  return fmt::format(
      "{}  {}, {}, {}\n{}\n", terminal.bold(report::printable(title)),
      report::translated("periodic positioning error", options), iso230_2::edition,
      report::translated("Annex C", options),
      terminal.faint(fmt::format(
          "{} ({})", p.file == "-" ? report::translated("standard input", options) : report::printable(p.file),
          p.format)));
}

std::string result_rows(const PeriodicDirection& d, const PeriodicArguments& arguments, AxisKind kind,
                        const Terminal& terminal) {
  auto rows = report::periodic_rows(d, kind, arguments.report);
  const auto said = [&](std::string_view english) { return report::translated(english, arguments.report); };
  for (report::PeriodicRow& row : rows) row.title = said(row.title);
  std::size_t title_width = 0, value_width = 0, U_width = 0;
  for (const report::PeriodicRow& row : rows) {
    title_width = std::max(title_width, display_width(row.title));
    value_width = std::max(value_width, display_width(row.value));
    U_width = std::max(U_width, display_width(row.U));
  }
  std::string text = fmt::format("\n{} {}\n", terminal.bold(std::string(arrow(d.direction))),
                                 said(fmt::format("{} targets, {}", d.points.size(), counted(d.runs, "run"))));
  for (const report::PeriodicRow& row : rows)
    text += fmt::format("{}  {}{} {}\n", left(row.title, title_width), right(row.value, value_width),
                        row.U.empty() ? std::string(U_width > 0 ? U_width + 3 : 0, ' ') : " ± " + right(row.U, U_width),
                        row.unit);
  std::string harmonics;
  for (const auto& h : d.harmonics)
    if (h.order > 1)
      harmonics += fmt::format(
          "{}{} {}{}", harmonics.empty() ? "" : ", ", h.order,
          format_fixed(h.amplitude.value.in_native(), decimals_for(d.coverage_factor * h.amplitude.u.in_native(), 2),
                       arguments.report.numbers),
          h.significant ? "" : fmt::format(" ({})", said("not significant")));
  if (!harmonics.empty())
    text += terminal.faint(wrapped(
                fmt::format("{} {}: {}", said("Amplitudes of the harmonics in"), deviation_unit(kind), harmonics),
                terminal.width(), 0)) +
            "\n";
  return text;
}

std::string summary(const app::EvaluatedPeriodic& e, const PeriodicArguments& arguments, const Terminal& terminal) {
  const AxisKind kind = e.test.metadata.axis.kind;
  const auto said = [&](std::string_view english) { return report::translated(english, arguments.report); };
  std::string text = heading(e, arguments.report, terminal);
  for (const auto& d : e.result.directions) text += result_rows(d, arguments, kind, terminal);
  text += terminal.faint(said("± U for about 95 %, from the residuals alone")) + "\n\n";
  text += findings_text(e.result.findings, arguments.report, terminal);
  text += e.result.conforming() ? terminal.green(said("Test of Annex C; no result for acceptance."))
                                : terminal.red(said("Departs from Annex C; no result for acceptance."));
  if (!e.result.label.empty()) text += " " + terminal.bold(said(e.result.label + "."));
  return text + "\n";
}

int run(PeriodicArguments& arguments) {
  const app::InputFile input{arguments.file, false};
  arguments.outputs.inputs = app::InputFiles(std::span(&input, 1));
  if (auto spared = app::check_inputs_spared(arguments.outputs); !spared) return failed(spared.error(), exit_usage);
  auto evaluated = app::evaluate_periodic(arguments.file, arguments.reading, arguments.options);
  if (!evaluated) return failed(evaluated.error());
  if (!arguments.quiet && arguments.outputs.json != "-")
    fmt::print("{}", summary(*evaluated, arguments, Terminal(arguments.colour)));
  if (auto written = app::write_outputs(*evaluated, arguments.outputs, arguments.report); !written)
    return failed(written.error());
  return exit_done;
}

/// A length or angle above zero, in the unit of positions.
void add_period(const Verb& verb, const std::string& name, std::optional<Position>& target,
                const std::string& description) {
  verb.add_option_function<std::string>(
          name,
          [name, &target](const std::string& text) {
            const auto period = app::parsed_period(text);
            if (!period) throw UsageError(name, period.error().message);
            target = *period;
          },
          description)
      ->type_name("NUMBER")
      ->group("Period, in mm or °");
}

void add_flags(const Verb& verb, const std::shared_ptr<PeriodicArguments>& arguments) {
  PeriodicArguments& a = *arguments;
  verb.add_option("FILE", a.file, "Measured test, or - for the standard input")->required();
  add_reading_flags(verb, a.reading, "axis.expected_period=10");
  add_period(verb, "--period", a.options.period,
             "The period, where it is known (pitch of the screw); else it is searched");
  add_period(verb, "--min-period", a.options.shortest,
             "Shortest period searched (2.1 times the mean spacing of the targets)");
  add_period(verb, "--max-period", a.options.longest, "Longest period searched (half the measured travel)");
  add_output_flags(verb, a.outputs, a.report, a.quiet);
}

}  // namespace

void add_periodic(const Verb& program, int& exit_code) {
  Verb verb =
      program.add_subcommand("periodic", "Find the periodic error of an axis (Annex C): period, amplitude, phase");
  auto arguments = std::make_shared<PeriodicArguments>();
  add_flags(*verb, arguments);
  verb->callback([arguments, &exit_code] {
    if (arguments->options.period && (arguments->options.shortest || arguments->options.longest))
      throw UsageError("--period", "found a known period and a band to search, expected one of them");
    if (auto outputs = app::check_outputs(arguments->outputs); !outputs)
      throw UsageError("--report", outputs.error().message);
    exit_code = run(*arguments);
  });
  verb->footer(
      R"(Each direction is evaluated for itself. A straight line is fitted along with the period and removed in this
view only. Examples:
  axiometry periodic screw.csv
  axiometry periodic screw.csv --period 10 --report screw.pdf
  axiometry periodic scale.csv --min-period 0.01 --max-period 0.1 --json -)");
}

}  // namespace axiometry::cli
