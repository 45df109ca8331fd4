// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <string>
#include "cli/flags/verb.h"

#include "axiometry/app/files/number_list.h"
#include "axiometry/app/tracking/tracking_locate.h"
#include "axiometry/app/tracking/tracking_text.h"
#include "axiometry/base/text/number_text.h"
#include "axiometry/report/drawing/utf8.h"
#include "axiometry/report/translated.h"
#include "cli/failure.h"
#include "cli/flags/experiment_flags.h"
#include "cli/flags/option_text.h"
#include "cli/flags/ranging_flag.h"
#include "cli/text/flags_of_words.h"
#include "cli/text/terminal.h"
#include "cli/verbs/commands.h"
#include "cli/verbs/tracking/tracking.h"

namespace axiometry::cli {
namespace {

constexpr const char* tracking_locate_examples =
    R"(FILE is a table with the columns x_mm, y_mm, z_mm (of the reflector) and length_difference_mm, six rows or more.
Exit code 3: the station should not be used as it is, a finding says why.
Examples:
  axiometry tracking locate points.csv
  axiometry tracking locate points.csv --machine-sigma 2um --report station.pdf --json station.json
  axiometry tracking locate axes.csv --tool 0,0,-150 --near 650,-30,260)";

struct TrackingLocateArguments {
  app::LocateRequest request;
  ExperimentArguments outputs;
};

void add_request(const Verb& verb, app::LocateRequest& request) {
  verb.add_option("FILE", request.file, "Points with the lengths measured there, or - for the standard input")
      ->required();
  constexpr const char* group = "Set-up";
  add_read(verb, {"--tool", "X,Y,Z", "Added to the coordinates, mm: from the axes' place to the reflector (0,0,0)"},
           [&request](const std::string& text) -> Result<void> {
             AXIOMETRY_TRY(request.tool_offset_mm, app::parse_vector(text));
             return {};
           })
      ->group(group);
  add_read(verb, {"--near", "X,Y,Z", "About where the station stands, mm: chooses between mirror images"},
           [&request](const std::string& text) -> Result<void> {
             AXIOMETRY_TRY(request.options.near_mm, app::parse_vector(text));
             return {};
           })
      ->group(group);
  constexpr const char* weights = "Uncertainties";
  add_ranging(verb, [&request](const RangingUncertainty& ranging) {
    request.options.ranging = ranging;
  })->group(weights);
  add_read(verb, {"--machine-sigma", "LENGTH", "Standard uncertainty of the machine's points, per axis (0um)"},
           [&request](const std::string& text) -> Result<void> {
             AXIOMETRY_TRY(const Length sigma, app::parse_length_sigma(text));
             request.options.machine_sigma_mm = sigma.in_mm();
             return {};
           })
      ->group(weights);
}

std::string mm(double x, const report::Options& options) { return right(format_fixed(x, 4, options.numbers), 13); }

/// " ± 0.31" µm, or what a number that says nothing is.
std::string u_um(double variance_mm2, const report::Options& options) {
  const double u = 1000.0 * std::sqrt(variance_mm2);
  if (!(u < 1e6)) return right("?", 10);
  return right(format_fixed(u, decimals_for(u, 2), options.numbers), 10);
}

std::string summary(const app::Located& located, const report::Options& options, const Terminal& terminal) {
  const tracking::StationLocation& location = located.location;
  const auto& refined = location.refined;
  const auto said = [&](std::string_view english) { return report::translated(english, options); };
  std::string text = fmt::format("{}  {}\n{}\n\n", terminal.bold(said("Station of the tracking interferometer")),
                                 said(fmt::format("from {} points", located.points.size())),
                                 terminal.faint(report::printable(located.request.file)));
  text += terminal.faint(fmt::format("    {}{}{}{}\n", right(said("refined") + " mm", 13), right("u µm", 10),
                                     right("linear mm", 13), right(said("difference") + " µm", 16)));
  for (std::size_t k = 0; k < 3; ++k) {
    text += fmt::format("{}   {}{}", "XYZ"[k], mm(refined.station_mm[k], options),
                        u_um(refined.covariance_mm2[k][k], options));
    if (location.has_linear())
      text += mm(location.linear->station_mm[k], options) +
              right(format_fixed(1000.0 * location.difference_mm[k], 2, options.numbers), 16);
    text += "\n";
  }
  text += fmt::format("L0  {}{}{}\n\n", mm(refined.L0_mm, options), u_um(refined.L0_variance_mm2, options),
                      location.has_linear() ? mm(location.linear->L0_mm, options) : "");
  const auto exponential = [&](double x) {
    std::string power = fmt::format("{:.1e}", x);
    std::ranges::replace(power, '.', options.numbers.decimal_mark);
    return power;
  };
  const auto condition = [&](double x) {
    return x < 1e15 ? x < 1e5 ? format_fixed(x, 1, options.numbers) : exponential(x) : said("infinite");
  };
  if (location.linear)
    text += said(fmt::format(
                "Linear:  rank {} of 5, condition {}{}", location.linear->rank, condition(location.linear->condition),
                location.has_linear() ? fmt::format(", misclosure {} mm²",
                                                    format_fixed(location.linear->misclosure_mm2, 4, options.numbers))
                                      : std::string(", no station"))) +
            "\n";
  text += said(fmt::format("Refined: condition {}, chi-squared {} with {} degree{} of freedom",
                           condition(refined.condition),
                           refined.chi_squared < 1e5 ? format_fixed(refined.chi_squared, 2, options.numbers)
                                                     : exponential(refined.chi_squared),
                           refined.degrees_of_freedom, refined.degrees_of_freedom == 1 ? "" : "s")) +
          "\n";
  if (!location.findings.empty()) text += "\n";
  for (const tracking::Finding& f : location.findings)
    text += (f.serious ? terminal.red(left(said("serious"), 9)) : terminal.faint(left(said("note"), 9))) +
            wrapped(report::printable(with_flags(said(f.message), f.message)), terminal.width(), 9) + "\n";
  return text;
}

int run(TrackingLocateArguments& arguments) {
  const app::InputFile input{arguments.request.file, false};
  app::OutputNames& names = arguments.outputs.outputs;
  names.inputs = app::InputFiles(std::span(&input, 1));
  if (const auto spared = app::check_inputs_spared(names); !spared) return failed(spared.error(), exit_usage);
  const auto located = app::locate(arguments.request);
  if (!located) return failed(located.error());
  if (!arguments.outputs.quiet && names.json != "-")
    fmt::print("{}", summary(*located, arguments.outputs.report, Terminal(ColourChoice::automatic)));
  const app::Experiment presented = app::present(*located, arguments.outputs.report);
  if (const auto written = app::write_outputs(presented, names, arguments.outputs.report); !written)
    return failed(written.error());
  return located->location.is_serious() ? exit_exceeded : exit_done;
}

}  // namespace

void add_tracking_locate(const Verb& tracking, int& exit_code) {
  Verb verb = tracking.add_subcommand("locate", "Find where the instrument stands, from six points or more");
  verb->footer(tracking_locate_examples);
  auto arguments = std::make_shared<TrackingLocateArguments>();
  add_request(*verb, arguments->request);
  add_experiment_flags(*verb, arguments->outputs);
  verb->callback([arguments, &exit_code] {
    check_experiment_outputs(arguments->outputs);
    exit_code = run(*arguments);
  });
}

}  // namespace axiometry::cli
