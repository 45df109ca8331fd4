// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <algorithm>
#include <memory>
#include <string>
#include <vector>
#include "cli/flags/verb.h"

#include "axiometry/app/tracking/polar.h"
#include "cli/failure.h"
#include "cli/flags/experiment_flags.h"
#include "cli/flags/option_text.h"
#include "cli/verbs/commands.h"
#include "cli/verbs/tracking/tracking.h"

namespace axiometry::cli {
namespace {

constexpr const char* polar_examples =
    R"(The columns are point,station,length_mm,azimuth_deg,elevation_deg (or zenith_deg), and where they are
known u_length_um,u_azimuth_arcsec,u_elevation_arcsec (k = 1). Azimuth is from x towards y, elevation above
the plane of x and y. A station with angles shows distances; one without shows changes of length. Stations
are joined by the points that they share: three or more, off one line.
Exit code 3: the result should not be used as it is, a finding says why.
Examples:
  axiometry tracking polar tracker.csv --instrument leica-at901
  axiometry tracking polar tracker.csv tracer.csv --instrument faro-ion --instrument TR=etalon-lasertracer
  axiometry tracking polar tracker.csv --ranging 20um+1um/m --angles 4arcsec --points nominal.csv --json -)";

struct PolarArguments {
  app::PolarRequest request;
  std::string out;
  ExperimentArguments outputs;
};

int run_polar(PolarArguments& arguments) {
  std::vector<app::InputFile> inputs;
  for (const std::string& file : arguments.request.files) inputs.push_back({file, false});
  if (!arguments.request.points.empty()) inputs.push_back({arguments.request.points, false});
  app::OutputNames& outputs = arguments.outputs.outputs;
  outputs.inputs = app::InputFiles(inputs);
  if (const auto spared = app::check_inputs_spared(outputs); !spared) return failed(spared.error(), exit_usage);
  if (!arguments.out.empty())
    if (const auto spared = outputs.inputs.check_spared(arguments.out); !spared)
      return failed(spared.error(), exit_usage);
  const auto result = app::adjust_polar_files(arguments.request);
  if (!result) return failed(result.error());
  if (!arguments.out.empty())
    if (const auto written = app::write_polar_points(**result, arguments.out); !written) return failed(written.error());
  const int code = finish_experiment(app::present(**result, arguments.outputs.report), arguments.outputs);
  if (code != exit_done) return code;
  return std::ranges::any_of((*result)->fit.findings, &tracking::Finding::serious) ? exit_exceeded : exit_done;
}

}  // namespace

void add_tracking_polar(const Verb& tracking, int& exit_code) {
  Verb verb = tracking.add_subcommand(
      "polar", "Points from lengths and angles of trackers, joined with lengths of others, each by its uncertainty");
  verb->footer(polar_examples);
  auto arguments = std::make_shared<PolarArguments>();
  app::PolarRequest& request = arguments->request;
  verb->add_option("READINGS", request.files, "Readings as CSV, or - for the standard input; several are joined")
      ->required();
  verb->add_option("--points", request.points, "Nominal points as CSV: coordinates and deviations are in theirs")
      ->type_name("FILE");
  verb->add_flag("--in-station", request.in_station,
                 "With --points too, coordinates are those of the first station with angles");
  add_read(*verb,
           {"--instrument", "[STATION=]NAME",
            "Kind whose uncertainty counts where the rows state none, of all stations or of one; repeated"},
           [&request](const std::string& text) -> Result<void> { return app::put_tracker(text, request); })
      ->take_all()
      ->trigger_on_parse()
      ->group("Uncertainty");
  add_read(*verb, {"--ranging", "U", "Expanded uncertainty (k = 2) of lengths, U = a + b L: 20um+1um/m"},
           [&request](const std::string& text) -> Result<void> { return app::put_polar_lengths(text, request); })
      ->group("Uncertainty");
  add_read(*verb, {"--angles", "U", "The same of angles: 2arcsec, or across the beam over the distance: 30um+12um/m"},
           [&request](const std::string& text) -> Result<void> {
             AXIOMETRY_TRY(request.stated.across, app::parse_across(text));
             return {};
           })
      ->group("Uncertainty");
  verb->add_option("--out", arguments->out, "The points found, with covariances, as CSV to FILE")
      ->type_name("FILE")
      ->group("Outputs");
  add_experiment_flags(*verb, arguments->outputs);
  verb->callback([arguments, &exit_code] {
    check_experiment_outputs(arguments->outputs, {{"--out", arguments->out}});
    if (arguments->request.in_station && arguments->request.points.empty())
      throw UsageError("--in-station", "found it without --points, expected both: without, they are anyway");
    exit_code = run_polar(*arguments);
  });
}

}  // namespace axiometry::cli
