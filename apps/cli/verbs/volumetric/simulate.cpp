// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <memory>
#include <string>
#include <vector>

#include "axiometry/app/files/number_list.h"
#include "axiometry/app/files/output.h"
#include "axiometry/app/tracking/tracking_text.h"
#include "axiometry/app/volumetric/identify_options.h"
#include "axiometry/app/volumetric/simulate_calibration.h"
#include "axiometry/base/counted.h"
#include "axiometry/base/json/json.h"
#include "axiometry/base/text/number_text.h"
#include "axiometry/base/text/text.h"
#include "cli/failure.h"
#include "cli/flags/option_text.h"
#include "cli/flags/ranging_flag.h"
#include "cli/flags/verb.h"
#include "cli/verbs/commands.h"
#include "cli/verbs/volumetric/volumetric.h"

namespace axiometry::cli {
namespace {

constexpr const char* volumetric_simulate_examples =
    R"(Noise is that of the instrument and of the repeatability in the machine's file. Stations are those of the file
(stations_mm) unless given; with --plan, stations and points are those of the plan. The truth holds the errors as they
are and as identify states them.
Examples:
  axiometry volumetric simulate --machine machine.json --seed 7 --lengths lengths.csv --truth truth.json
  axiometry volumetric simulate --machine machine.json --errors truth.json --station 500,300,-900 \
      --station -200,-150,-700 --station 1200,-150,-650 --station 500,800,-680 --points 150 --drift 2um \
      --outliers 5 --untold-breaks 1 --lengths lengths.csv
  axiometry volumetric simulate --plan plan.json --lengths lengths.csv
  axiometry volumetric simulate --plan plan.json --reversal curves --lengths lengths.csv --truth truth.json
  axiometry volumetric simulate --plan plan.json --drift 2um --recording 'run{part}.csv' --truth truth.json
  axiometry volumetric simulate --machine machine.json --trials 200 --json coverage.json
  axiometry volumetric simulate --machine machine.json --trials 200 --spans 6 --points 150 --reversal curves)";

struct VolumetricSimulateArguments {
  app::SimulateRequest request;
  app::SimulateFiles files;
  std::size_t trials = 0;
  std::string json;
  bool quiet = false;
};

Result<volumetric::DrawnSize> size_of(const std::string& text) {
  const std::vector<std::string_view> parts = text::split(text, ',');
  const auto displacement = parse_number(parts.front()), rotation = parse_number(parts.back());
  constexpr double most = 1e4;
  if (parts.size() != 2 || !displacement || !rotation || !(*displacement >= 0.0 && *displacement <= most) ||
      !(*rotation >= 0.0 && *rotation <= most))
    return fail(fmt::format("found {}, expected two numbers from 0 to 10000: um, urad", text::quoted(text)));
  return volumetric::DrawnSize{*displacement, *rotation};
}

void add_truth(const Verb& verb, VolumetricSimulateArguments& a) {
  constexpr const char* group = "Truth";
  verb.add_option("--errors", a.request.errors, "Errors of the machine as JSON: a truth, or a result of identify")
      ->type_name("FILE")
      ->group(group);
  add_read(verb, {"--amplitude", "UM,URAD", "Size of errors that are drawn: of displacements, of rotations (8,12)"},
           [&a](const std::string& text) -> Result<void> {
             AXIOMETRY_TRY(a.request.size, size_of(text));
             return {};
           })
      ->group(group);
  add_read(verb, {"--station", "X,Y,Z", "Where a station stands, mm; repeated (those of the machine's file)"},
           [&a](const std::string& text) -> Result<void> {
             AXIOMETRY_TRY(const Vector3 at, app::parse_vector(text));
             a.request.stations_mm.push_back(at);
             return {};
           })
      ->take_all()
      ->trigger_on_parse()
      ->group(group);
  add_count(verb, {"--points", "N", "Points of each station and tool (100)"}, [&a](unsigned long long n) {
    a.request.points = static_cast<std::size_t>(n);
  })->group(group);
  add_seed(verb, "Seed of all that is random (1)", [&a](unsigned long long seed) {
    a.request.seed = seed;
  })->group(group);
}

void add_faults(const Verb& verb, volumetric::SimulatedFaults& faults) {
  constexpr const char* group = "Faults";
  verb.add_flag_callback(
          "--no-noise", [&faults] { faults.noise = false; }, "Lengths without noise")
      ->group(group);
  add_read(verb, {"--drift", "LENGTH", "Standard deviation of what a dead path drifts over a station and tool (0)"},
           [&faults](const std::string& text) -> Result<void> {
             AXIOMETRY_TRY(const Length drift, app::parse_length_sigma(text));
             faults.drift_um = drift.in_um();
             return {};
           })
      ->group(group);
  add_number(verb, {"--part-scale", "UM_PER_M", "Standard deviation of the scale of axes at a station with a tool (0)"},
             [&faults](double x) {
               if (!(x >= 0.0 && x <= 1e4)) throw UsageError("--part-scale", "expected 0 to 10000");
               faults.part_scale_um_per_m = x;
             })
      ->group(group);
  add_number(verb,
             {"--station-share", "SHARE", "Share of its variance that the tools of a station have in common (0.5)"},
             [&faults](double x) {
               if (!(x >= 0.0 && x <= 1.0)) throw UsageError("--station-share", "expected 0 to 1");
               faults.share_of_station = x;
             })
      ->group(group);
  const auto count = [&](const char* name, std::size_t& target, const char* description) {
    add_count(verb, {name, "N", description}, [&target](unsigned long long n) {
      target = static_cast<std::size_t>(n);
    })->group(group);
  };
  count("--breaks", faults.told_breaks, "Breaks of the beam that begin a segment (0)");
  count("--untold-breaks", faults.untold_breaks, "Breaks of the beam that the file does not tell (0)");
  count("--lost", faults.lost, "Readings that are not there (0)");
  count("--outliers", faults.outliers, "Readings that are wrong by 20 um to 2 mm (0)");
}

int run_trials(const VolumetricSimulateArguments& a) {
  if (!a.files.lengths.empty() || !a.files.truth.empty() || !a.files.recordings.empty())
    throw UsageError("--trials",
                     "lengths, recordings and truth are those of one trial: leave --lengths, --recording and --truth "
                     "out");
  const auto coverage = app::coverage_of(a.request, a.trials);
  if (!coverage) return failed(coverage.error());
  if (!a.json.empty())
    if (const auto written = app::write_file(a.json, json::dump(app::coverage_value(a.request, *coverage)) + "\n");
        !written)
      return failed(written.error());
  if (!a.quiet && a.json != "-") fmt::print("{}", app::coverage_text(*coverage));
  return exit_done;
}

int run(const VolumetricSimulateArguments& a) {
  if (a.trials > 0) return run_trials(a);
  if (!a.json.empty()) throw UsageError("--json", "goes with --trials");
  const auto calibration = app::simulate_calibration(a.request);
  if (!calibration) return failed(calibration.error());
  const auto written = app::write_simulated(*calibration, a.files);
  if (!written) return failed(written.error());
  if (a.quiet || a.files.lengths == "-" || a.files.truth == "-" || a.files.recordings == "-") return exit_done;
  if (!a.files.lengths.empty())
    fmt::print("{}: {} of {} and {}, seed {}\n", a.files.lengths,
               counted(calibration->simulated.lengths.readings.size(), "length"),
               counted(calibration->machine.stations.size(), "station"),
               counted(calibration->machine.tools.size(), "tool"), a.request.seed);
  if (written->recordings > 0)
    fmt::print("{}: {}, {}\n", a.files.recordings, counted(written->recordings, "recording"),
               counted(written->samples, "sample"));
  if (!a.files.truth.empty()) fmt::print("{}: the truth\n", a.files.truth);
  return exit_done;
}

}  // namespace

void add_volumetric_simulate(const Verb& volumetric, int& exit_code) {
  Verb verb = volumetric.add_subcommand("simulate", "Lengths of a machine whose 21 errors are known");
  verb->footer(volumetric_simulate_examples);
  auto arguments = std::make_shared<VolumetricSimulateArguments>();
  verb->add_option("--machine", arguments->request.machine, "The machine, its tools and the instrument, as JSON")
      ->type_name("FILE");
  verb->add_option("--plan", arguments->request.plan, "A plan of 'volumetric plan', in place of the machine")
      ->type_name("FILE");
  add_truth(*verb, *arguments);
  add_faults(*verb, arguments->request.faults);
  verb->add_option("--lengths", arguments->files.lengths, "Lengths as CSV, as identify reads them")
      ->type_name("FILE")
      ->group("Outputs");
  verb->add_option(
          "--recording", arguments->files.recordings,
          "What the instrument shows all the time, time and length, as .csv, .txt or .npy: one of each part of "
          "the plan where the name has {part}, else one of all")
      ->type_name("FILE")
      ->group("Outputs");
  add_read(*verb, {"--rate", "HZ", "Samples per second of --recording (100)"},
           [arguments](const std::string& text) -> Result<void> {
             const auto rate = parse_number(text);
             if (!rate || !(*rate >= 0.001 && *rate <= 1e7))
               return fail(fmt::format("found {}, expected 0.001 to 10000000 samples a second", text::quoted(text)));
             arguments->request.recording.rate = *rate;
             return {};
           })
      ->group("Outputs");
  add_read(*verb, {"--sample-noise", "LENGTH", "Standard deviation of the noise of each sample of --recording (0.1um)"},
           [arguments](const std::string& text) -> Result<void> {
             AXIOMETRY_TRY(arguments->request.recording.sigma, app::parse_length_sigma(text));
             return {};
           })
      ->group("Outputs");
  verb->add_option("--truth", arguments->files.truth, "What was true, as JSON")->type_name("FILE")->group("Outputs");
  add_count(*verb, {"--trials", "N", "Simulate and identify N times, and hold what is stated against what was true"},
            [arguments](unsigned long long n) { arguments->trials = static_cast<std::size_t>(n); })
      ->group("Trials");
  add_count(*verb, {"--spans", "N", "Spans of the curves in the trials (as many as identify chooses)"},
            [arguments](unsigned long long n) { arguments->request.spans = static_cast<std::size_t>(n); })
      ->group("Trials");
  add_read(*verb,
           {"--reversal", "MODEL",
            "How the directions of an axis differ where errors are drawn, and what trials look for: none, constant or "
            "curves (none)"},
           [arguments](const std::string& word) -> Result<void> {
             AXIOMETRY_TRY(arguments->request.reversal, app::parse_reversal(word));
             return {};
           })
      ->group("Truth");
  verb->add_option("--json", arguments->json, "What came of the trials, as JSON to FILE or, with -, standard output")
      ->check(fault_of_name)
      ->type_name("FILE")
      ->group("Trials");
  verb->add_flag("--quiet,-q", arguments->quiet, "No summary in the terminal")->group("Outputs");
  verb->callback([arguments, &exit_code] { exit_code = run(*arguments); });
}

}  // namespace axiometry::cli
