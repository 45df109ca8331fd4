// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <memory>
#include <string>

#include "axiometry/app/dynamics/dynamic_motion.h"
#include "axiometry/base/reading_limits.h"
#include "axiometry/base/text/number_text.h"
#include "axiometry/base/text/text.h"
#include "cli/failure.h"
#include "cli/flags/experiment_flags.h"
#include "cli/flags/option_text.h"
#include "cli/flags/verb.h"
#include "cli/text/document_text.h"
#include "cli/verbs/commands.h"
#include "cli/verbs/dynamic.h"

namespace axiometry::cli {
namespace {

struct DynamicArguments {
  std::string file, series, spectrum;
  app::DynamicOptions options;
  ExperimentArguments outputs;
};

double checked_positive(const char* option, double x, double most) {
  if (x > 0.0 && x <= most) return x;
  throw UsageError(option, fmt::format("found {}, expected a number above 0 and up to {}", format_exact(x), most));
}

int run_dynamic(DynamicArguments& a) {
  check_experiment_outputs(a.outputs, {{"--series", a.series}, {"--spectrum", a.spectrum}});
  app::OutputNames& names = a.outputs.outputs;
  const app::InputFile input{a.file, false};
  names.inputs = app::InputFiles(std::span(&input, 1));
  if (const auto spared = app::check_inputs_spared(names); !spared) return failed(spared.error(), exit_usage);
  for (const std::string* file : {&a.series, &a.spectrum})
    if (!file->empty() && *file != "-")
      if (const auto spared = names.inputs.check_spared(*file); !spared) return failed(spared.error(), exit_usage);
  const auto motion = app::measure_dynamic(a.file, a.options);
  if (!motion) return failed(motion.error());
  const app::Experiment experiment =
      app::present(*motion, a.outputs.report, {.report = !names.reports.empty(), .json = !names.json.empty()});
  if (!a.outputs.quiet && names.json != "-")
    fmt::print("{}", document_text(experiment.document, a.outputs.report, Terminal(ColourChoice::automatic)));
  if (const auto written = app::write_outputs(experiment, names, a.outputs.report); !written)
    return failed(written.error());
  if (!a.series.empty())
    if (const auto written = app::write_series(*motion, a.series); !written) return failed(written.error());
  if (!a.spectrum.empty())
    if (const auto written = app::write_spectrum(*motion, a.spectrum); !written) return failed(written.error());
  return exit_done;
}

}  // namespace

void add_dynamic(const Verb& program, int& exit_code) {
  Verb verb = program.add_subcommand("dynamic", "Velocity, acceleration, vibrations and even motion of a recording");
  auto a = std::make_shared<DynamicArguments>();
  app::DynamicOptions& o = a->options;
  constexpr double most = largest_stated;
  verb->add_option("FILE", a->file, "A continuous recording (.rtx, .npy, .csv, …), or - for the standard input")
      ->required();
  verb->add_flag_callback(
      "--rotary", [&o] { o.kind = AxisKind::rotary; }, "The axis turns: positions are in degrees");
  verb->add_option("--stream", o.stream, "Layout of the recording instead of recognising it")->type_name("ID");
  add_number(*verb, {"--rate", "HZ", "Samples per second, for layouts that do not tell it"},
             [&o](double x) { o.rate_hz = checked_positive("--rate", x, most); });
  add_number(*verb, {"--units-per-count", "MM", "mm or degrees per count, for layouts of counts"},
             [&o](double x) { o.units_per_count = x; });
  add_read(*verb, {"--stream-axis", "N", "Which axis or column of a stream of several (1)"},
           [&o](const std::string& word) -> Result<void> {
             constexpr std::size_t streams_most = app::largest_stream_axis;
             const auto number = parse_count(word);
             if (!number || *number < 1 || *number > streams_most)
               return fail(
                   fmt::format("found {}, expected a whole number from {} to {}", text::quoted(word), 1, streams_most));
             o.stream_axis = static_cast<std::size_t>(*number - 1);
             return {};
           });
  verb->add_flag("--skip-damaged", o.skip_damaged,
                 "Leave out what is no sample instead of refusing the recording, as long as none is missing in the "
                 "part that is looked at; always so for what a live capture wrote");
  verb->add_flag("--reverse", o.reverse, "The instrument counts up when the axis moves down");
  add_number(*verb, {"--feed", "FEED", "Feed that was asked for, mm/min or °/min"},
             [&o](double x) { o.feed = checked_positive("--feed", x, most); });
  add_number(*verb, {"--window", "S", "Time over which velocity and acceleration are taken (0.01)"},
             [&o](double x) { o.window_s = checked_positive("--window", x, most); });
  add_number(*verb, {"--even", "PERCENT", "How far the velocity of even motion may be from its median (5)"},
             [&o](double x) { o.uniform_share = checked_positive("--even", x, app::largest_even_percent) / 100.0; });
  add_number(*verb, {"--from", "S", "Only from this time of the recording on"}, [&o](double x) { o.from_s = x; });
  add_number(*verb, {"--to", "S", "Only up to this time"}, [&o](double x) { o.to_s = x; });
  verb->add_option("--series", a->series, "Time, position, velocity and acceleration of every sample as CSV to FILE")
      ->check(fault_of_name)
      ->type_name("FILE");
  verb->add_option("--spectrum", a->spectrum, "All amplitudes by frequency as CSV to FILE")
      ->check(fault_of_name)
      ->type_name("FILE");
  add_experiment_flags(*verb, a->outputs);
  verb->callback([a, &exit_code] { exit_code = run_dynamic(*a); });
  verb->footer(R"(No plan and no standstill is needed, and no parameter of ISO 230-2 comes of it.
Examples:
  axiometry dynamic x-axis.rtx --feed 6000
  axiometry dynamic x-axis.rtx --report motion.pdf --series motion.csv --spectrum spectrum.csv
  axiometry dynamic run.npy --from 2 --to 8 --json -)");
}

}  // namespace axiometry::cli
