// SPDX-License-Identifier: Apache-2.0
#include "cli/verbs/temperatures.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstdio>
#include <memory>
#include <string>
#include <vector>

#include "axiometry/app/temperatures/temperatures.h"
#include "axiometry/base/text/text.h"
#include "axiometry/report/drawing/utf8.h"
#include "axiometry/report/temperatures/temperatures.h"
#include "axiometry/report/translated.h"
#include "cli/failure.h"
#include "cli/flags/experiment_flags.h"
#include "cli/flags/option_text.h"
#include "cli/flags/temperature_flags.h"
#include "cli/text/terminal.h"
#include "cli/verbs/commands.h"

namespace axiometry::cli {
namespace {

using iso230_2::EnvironmentItem;
using iso230_2::EnvironmentStanding;

struct TemperatureArguments {
  std::string file;
  app::TemperatureRequest request;
  app::OutputNames outputs;
  report::Options report;
  bool quiet = false;
};

std::string temperature_sentence(std::string_view english, const report::Options& options) {
  std::string said = report::translated(english, options);
  if (!said.empty() && said.front() >= 'a' && said.front() <= 'z') said.front() = static_cast<char>(said.front() - 32);
  return said + ".";
}

std::string standing_in_colour(const EnvironmentItem& item, const Terminal& terminal, const report::Options& options) {
  const std::string text = report::translated(iso230_2::standing_text(item.standing), options);
  switch (item.standing) {
    case EnvironmentStanding::kept: return terminal.green(text);
    case EnvironmentStanding::exceeded: return terminal.red(text);
    case EnvironmentStanding::known_in_part: return terminal.yellow(text);
    case EnvironmentStanding::not_measured:
    case EnvironmentStanding::not_agreed: return terminal.faint(text);
  }
  return text;
}

void print_temperatures(const app::EvaluatedTemperatures& found, const report::Options& options) {
  const Terminal terminal(ColourChoice::automatic);
  const auto said = [&](std::string_view english) { return report::translated(english, options); };
  struct Row {
    std::string title, measured, agreed, standing;
  };
  std::vector<Row> rows;
  std::size_t title_width = 0, measured_width = 0, agreed_width = 0;
  for (const EnvironmentItem& item : found.environment.items) {
    const std::string agreed = report::agreed_text(item, options);
    Row row{said(item.title), item.measured ? report::measured_text(item, options) : "–",
            agreed.empty() ? "" : said(agreed), standing_in_colour(item, terminal, options)};
    title_width = std::max(title_width, display_width(row.title));
    measured_width = std::max(measured_width, display_width(row.measured));
    agreed_width = std::max(agreed_width, display_width(row.agreed));
    rows.push_back(std::move(row));
  }
  fmt::print("{}\n", terminal.bold(said("Temperatures before and during the test")));
  fmt::print("{}\n\n", terminal.faint(found.file == "-" ? said("standard input") : report::printable(found.file)));
  for (const Row& row : rows)
    fmt::print("{}  {}  {}  {}\n", left(row.title, title_width), right(row.measured, measured_width),
               left(row.agreed, agreed_width), row.standing);
  std::vector<std::string> sentences = iso230_2::gaps_of(found.environment, options.numbers);
  sentences.insert(sentences.end(), found.log.remarks.begin(), found.log.remarks.end());
  if (!sentences.empty()) fmt::print("\n");
  for (const std::string& text : sentences)
    fmt::print("{}\n", wrapped(report::printable(temperature_sentence(text, options)), terminal.width(), 0));
}

int run_temperatures(TemperatureArguments& arguments) {
  const app::InputFile input{arguments.file, false};
  arguments.outputs.inputs = app::InputFiles(std::span(&input, 1));
  if (auto spared = app::check_inputs_spared(arguments.outputs); !spared) return failed(spared.error(), exit_usage);
  const auto found = app::evaluate_temperatures(arguments.file, arguments.request);
  if (!found) return failed(found.error());
  if (!arguments.quiet && arguments.outputs.json != "-") print_temperatures(*found, arguments.report);
  if (auto written = app::write_outputs(*found, arguments.outputs, arguments.report); !written)
    return failed(written.error());
  if (found->environment.exceeded()) return exit_exceeded;
  return found->environment.open() ? exit_undecided : exit_done;
}

}  // namespace

void add_temperatures(const Verb& program, int& exit_code) {
  Verb verb = program.add_subcommand(
      "temperatures", "Hold a log of temperatures against what was agreed on the surroundings of a test");
  auto arguments = std::make_shared<TemperatureArguments>();
  verb->add_option("FILE", arguments->file,
                   "Temperature log: time and one or more sensors in columns, or - for the standard input")
      ->required();
  add_temperature_flags(*verb, arguments->request, "", "The test");
  add_output_flags(*verb, arguments->outputs, arguments->report, arguments->quiet);
  verb->callback([arguments, &exit_code] {
    if (auto outputs = app::check_outputs(arguments->outputs); !outputs)
      throw UsageError("--report", outputs.error().message);
    exit_code = run_temperatures(*arguments);
  });
  verb->footer(R"(Lowest and highest temperature of the air, its change per hour during the test and in the twelve hours
before it, and the largest difference between sensors on the machine. What was not measured is never called kept.
Exit codes: 3 when an agreed limit is exceeded, 4 when nobody can say whether one was kept.

Examples:
  axiometry temperatures hall.csv
  axiometry temperatures hall.csv --began 2026-03-02T09:00 --ended 2026-03-02T10:10 --rate 0.5
  axiometry temperatures hall.csv --began 2026-03-02T09:00 --lowest 19 --highest 22 --report hall.pdf
  axiometry temperatures log.csv --sensor T1=air --sensor T2=machine --json -)");
}

}  // namespace axiometry::cli
