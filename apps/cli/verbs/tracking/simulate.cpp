// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <memory>
#include <string>
#include "cli/flags/verb.h"

#include "axiometry/app/files/number_list.h"
#include "axiometry/app/simulate/tracked_simulation.h"
#include "axiometry/base/counted.h"
#include "axiometry/base/text/number_text.h"
#include "axiometry/base/text/text.h"
#include "cli/failure.h"
#include "cli/flags/option_text.h"
#include "cli/verbs/commands.h"
#include "cli/verbs/tracking/lee_verbs.h"
#include "cli/verbs/tracking/tracking.h"

namespace axiometry::cli {
namespace {

constexpr const char* tracking_simulate_examples =
    R"(Sizes are in um, mm and so on; relative ones bare or in um/m, ppm, %. Examples:
  axiometry tracking simulate --plan lines.json --station-true 412.3,198.1,-60 --scale y=100um/m \
      --squareness C0Y=20urad --noise 0.1um:0.15um/m --points points.csv --lengths lengths.csv --truth truth.json
  axiometry tracking simulate --plan lines.json --station 0,0,0 --station 900,0,50 \
      --station 0,500,90 --station 900,500,400 --grid 6,5,4 --noise 0.2um --ranges ranges.csv --truth truth.json
  axiometry tracking simulate coordinate-offset --noise 1um
  axiometry tracking simulate slope --about station)";

struct TrackingSimulateArguments {
  app::TrackedSimulation request;
  app::TrackedFiles files;
  bool quiet = false;
};

void add_request(const Verb& verb, TrackingSimulateArguments& a) {
  verb.add_option("--plan", a.files.plan, "Lines to walk, as 'axiometry tracking plan' writes them")->type_name("FILE");
  add_read(verb, {"--station-true", "X,Y,Z", "Where the station truly stands, mm (where the plan says)"},
           [&a](const std::string& text) -> Result<void> {
             AXIOMETRY_TRY(a.request.station_mm, app::parse_vector(text));
             return {};
           });
  const auto points = [](const std::string& text, std::vector<Vector3>& list) -> Result<void> {
    AXIOMETRY_TRY(const Vector3 point, app::parse_vector(text));
    list.push_back(point);
    return {};
  };
  // Each value of a repeated option comes by itself.
  const auto repeated = [&](const OptionText& text, std::vector<Vector3>& list) {
    add_read(verb, text, [&list, points](const std::string& value) { return points(value, list); })
        ->take_all()
        ->trigger_on_parse();
  };
  repeated({"--location-point", "X,Y,Z", "A point of the station location, mm; repeated (six, chosen for the plan)"},
           a.request.location_points_mm);
  repeated({"--station", "X,Y,Z", "A station of a multilateration, mm; repeated"}, a.request.stations_mm);
  add_read(verb, {"--grid", "NX,NY,NZ", "Points of a multilateration over the plan's travels (5,5,5)"},
           [&a](const std::string& text) -> Result<void> {
             const auto parts = text::split(text, ',');
             for (std::size_t k = 0; k < 3; ++k) {
               const auto n = parts.size() == 3 ? parse_count(text::trim(parts[k])) : std::nullopt;
               if (!n) return fail(fmt::format("found {}, expected three whole numbers", text::quoted(text)));
               a.request.grid[k] = static_cast<std::size_t>(*n);
             }
             return {};
           });
  add_seed(verb, "Seed of all that is random (1): the same seed gives the same bits",
           [&a](unsigned long long seed) { a.request.seed = seed; });
}

void add_rate(const Verb& verb, TrackingSimulateArguments& a) {
  add_read(verb, {"--rate", "HZ", "Samples per second of --recording (100)"},
           [&a](const std::string& text) -> Result<void> {
             const auto rate = parse_number(text);
             if (!rate || !(*rate >= 0.001 && *rate <= 1e7))
               return fail(fmt::format("found {}, expected 0.001 to 10000000 samples a second", text::quoted(text)));
             a.request.rate = *rate;
             return {};
           })
      ->group("Outputs");
}

void add_truth(const Verb& verb, TrackingSimulateArguments& a) {
  for (const app::TrackedOption& option : app::tracked_options())
    add_read(verb, {std::string(option.name), std::string(option.values), std::string(option.help)},
             [&a, &option](const std::string& text) { return option.apply(text, a.request.truth); })
        ->take_all()
        ->trigger_on_parse()
        ->group(std::string(option.group));
}

void add_outputs(const Verb& verb, TrackingSimulateArguments& a) {
  constexpr const char* group = "Outputs";
  const auto file = [&](const char* name, std::string& target, const char* description) {
    verb.add_option(name, target, description)->type_name("FILE")->group(group);
  };
  file("--points", a.files.points, "Points of the station location, as 'tracking locate' reads them");
  file("--lengths", a.files.lengths, "Lengths along the plan's lines, as 'tracking evaluate' reads them");
  file("--recording", a.files.recording,
       "What the instrument shows all the time along the plan's lines, time and length, as .csv, .txt or .npy; "
       "'tracking "
       "evaluate' reads it too");
  file("--ranges", a.files.ranges, "Lengths from several stations, as 'tracking multilaterate' reads them");
  file("--truth", a.files.truth, "What was true, as JSON (docs/howto/simulate-tracking.md)");
  verb.add_flag("--quiet,-q", a.quiet, "No summary in the terminal")->group(group);
}

int run(const TrackingSimulateArguments& a) {
  const auto summary = app::run_tracked_simulation(a.request, a.files);
  if (!summary) return failed(summary.error());
  const auto& f = a.files;
  if (a.quiet || f.points == "-" || f.lengths == "-" || f.recording == "-" || f.ranges == "-" || f.truth == "-")
    return exit_done;
  if (!f.points.empty()) fmt::print("{}: {}, seed {}\n", f.points, counted(summary->points, "point"), a.request.seed);
  if (!f.lengths.empty())
    fmt::print("{}: {} on {}, {} s\n", f.lengths, counted(summary->lengths, "length"), counted(summary->lines, "line"),
               format_fixed(summary->duration.in_s(), 0));
  if (!f.recording.empty())
    fmt::print("{}: {} of {}\n", f.recording, counted(summary->samples, "sample"), counted(summary->lines, "line"));
  if (!f.ranges.empty()) fmt::print("{}: {}\n", f.ranges, counted(summary->ranges, "length"));
  if (!f.truth.empty()) fmt::print("{}: the truth\n", f.truth);
  return exit_done;
}

}  // namespace

void add_tracking_simulate(const Verb& tracking, int& exit_code) {
  Verb verb = tracking.add_subcommand(
      "simulate", "Measurements of a machine with known errors, and the experiments of Lee et al. (2016)");
  verb->footer(tracking_simulate_examples);
  auto arguments = std::make_shared<TrackingSimulateArguments>();
  add_request(*verb, *arguments);
  add_truth(*verb, *arguments);
  add_outputs(*verb, *arguments);
  add_rate(*verb, *arguments);
  verb->require_subcommand(0, 1);
  add_lee_verbs(*verb, exit_code);
  verb->callback([verb, arguments, &exit_code] {
    if (!verb->has_chosen_subcommand()) exit_code = run(*arguments);
  });
}

}  // namespace axiometry::cli
