// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "axiometry/app/files/number_list.h"
#include "axiometry/app/files/output.h"
#include "axiometry/app/plan/plan.h"
#include "axiometry/app/results/outputs.h"
#include "axiometry/app/tracking/tracking_text.h"
#include "axiometry/app/volumetric/plan_volume.h"
#include "axiometry/base/json/json.h"
#include "axiometry/base/text/text.h"
#include "axiometry/formats/volumetric/volumetric_plan_json.h"
#include "cli/failure.h"
#include "cli/flags/experiment_flags.h"
#include "cli/flags/option_text.h"
#include "cli/flags/verb.h"
#include "cli/verbs/commands.h"
#include "cli/verbs/serious_findings.h"
#include "cli/verbs/volumetric/volumetric.h"

namespace axiometry::cli {
namespace {

constexpr const char* volumetric_plan_examples =
    R"(Stations are those of the machine's file (stations_mm); where it has none, or with --stations auto, they are
proposed. Stations and obstacles are in the coordinates of the reflector: where it stands when the axes stand at
X, Y, Z, plus the tool's offset. Exit code 3: these stations, tools and points will not tell all 21 errors, or a
station sees too little; a finding says why.
Examples:
  axiometry volumetric plan --machine machine.json --out plan.json
  axiometry volumetric plan --machine machine.json --stations auto --room X=-200:1200,Y=-200:800,Z=-750:-600 \
      --incidence 80 --points 150 --out plan.json --points-out points.csv --json expected.json
  axiometry nc plan.json --dialect siemens-840d --part 1 --out S1_T1.MPF)";

struct VolumetricPlanArguments {
  app::PlanVolumeRequest request;
  std::string out, points, json;
  bool quiet = false;
};

void add_layout(const Verb& verb, VolumetricPlanArguments& a) {
  constexpr const char* group = "Layout";
  add_read(verb, {"--stations", "auto or file", "Propose stations, or take those of the machine's file"},
           [&a](const std::string& word) -> Result<void> {
             if (word != "auto" && word != "file")
               return fail(fmt::format("found {}, expected auto or file", text::quoted(word)));
             a.request.propose_stations = word == "auto";
             return {};
           })
      ->group(group);
  add_count(verb, {"--count", "N", "How many stations to propose (4)"}, [&a](unsigned long long n) {
    a.request.options.stations = static_cast<std::size_t>(n);
  })->group(group);
  add_read(verb,
           {"--room", "X=A:B,Y=A:B,Z=A:B",
            "Where the instrument's centre may stand (15 % beyond the reach, a quarter of Z about its lowest)"},
           [&a](const std::string& text) -> Result<void> {
             AXIOMETRY_TRY(a.request.options.room, app::parse_travel_box(text));
             return {};
           })
      ->group(group);
  add_count(verb, {"--points", "N", "Points of each station and tool (100)"}, [&a](unsigned long long n) {
    a.request.options.points = static_cast<std::size_t>(n);
  })->group(group);
  add_number(verb, {"--feed", "FEED", "mm/min between points (3000)"}, [&a](double x) {
    a.request.feed_mm_per_min = x;
  })->group(group);
  add_number(verb, {"--dwell", "SECONDS", "At rest on every point (3)"}, [&a](double x) {
    a.request.dwell = Duration::s(x);
  })->group(group);
  verb.add_option("--date", a.request.date, "Of the plan, such as 2026-11-21; today when not given")
      ->type_name("DATE")
      ->group(group);
}

void add_limits(const Verb& verb, VolumetricPlanArguments& a) {
  constexpr const char* group = "Limits";
  TrackerLimits& limits = a.request.limits;
  add_read(verb, {"--range", "LEAST:MOST", "Of the instrument (0.2m:15m)"},
           [&limits](const std::string& text) -> Result<void> {
             AXIOMETRY_TRY(const app::LowHigh range, app::parse_range(text));
             limits.range_least_mm = range.low;
             limits.range_most_mm = range.high;
             return {};
           })
      ->group(group);
  add_read(verb, {"--elevation", "LOWEST:HIGHEST", "Of the beam above the plane of X and Y, ° (-20:90)"},
           [&limits](const std::string& text) -> Result<void> {
             AXIOMETRY_TRY(const app::LowHigh elevation, app::parse_elevation(text));
             limits.elevation_lowest_deg = elevation.low;
             limits.elevation_highest_deg = elevation.high;
             return {};
           })
      ->group(group);
  add_read(verb, {"--reflector", "X,Y,Z", "Where the reflector looks, from the spindle (0,0,-1)"},
           [&limits](const std::string& text) -> Result<void> {
             AXIOMETRY_TRY(limits.reflector_axis, app::parse_vector(text));
             if (norm(limits.reflector_axis) > 0.0) return {};
             return fail(fmt::format("found {}, expected a direction", text::quoted(text)));
           })
      ->group(group);
  add_number(verb, {"--incidence", "DEGREES", "Largest angle between the beam and that direction (60)"},
             [&limits](double x) {
               if (!(x > 0.0 && x <= 180.0)) throw UsageError("--incidence", "expected an angle up to 180°");
               limits.incidence_most_deg = x;
             })
      ->group(group);
  add_number(verb, {"--safe-radius", "MM", "Nothing of the machine comes nearer to the station (120)"},
             [&limits](double x) {
               if (!(x >= 0.0)) throw UsageError("--safe-radius", "expected 0 or more");
               limits.safe_radius_mm = x;
             })
      ->group(group);
  add_read(verb,
           {"--obstacle", "SOLID", "NAME=box:X,Y,Z:X,Y,Z, …=sphere:X,Y,Z:RADIUS or …=cylinder:X,Y,Z:RADIUS:HEIGHT"},
           [&a](const std::string& text) -> Result<void> {
             AXIOMETRY_TRY(a.request.obstacles.emplace_back(), app::parse_obstacle(text));
             return {};
           })
      ->take_all()
      ->trigger_on_parse()
      ->group(group);
}

int run(VolumetricPlanArguments& a) {
  const std::vector<app::InputFile> read = {{a.request.machine, false}};
  const app::InputFiles inputs(read);
  for (const std::string& name : {a.out, a.points, a.json})
    if (const auto spared = inputs.check_spared(name); !name.empty() && !spared)
      return failed(spared.error(), exit_usage);
  auto date = app::plan_date(a.request.date);
  if (!date) return failed(date.error());
  a.request.date = *std::move(date);
  const auto planned = app::plan_volume(a.request);
  if (!planned) return failed(planned.error());
  std::vector<std::pair<std::string, std::string>> texts;
  if (!a.out.empty()) texts.emplace_back(a.out, formats::write_volumetric_plan(planned->plan));
  if (!a.points.empty()) texts.emplace_back(a.points, app::planned_points_csv(planned->plan));
  if (!a.json.empty()) texts.emplace_back(a.json, json::dump(app::expectation_value(*planned)) + "\n");
  for (const auto& [name, text] : texts)
    if (const auto written = app::write_file(name, text); !written) return failed(written.error());
  if (!a.quiet && a.out != "-" && a.points != "-" && a.json != "-") fmt::print("{}", app::expectation_text(*planned));
  return exit_code_of_findings(planned->findings);
}

}  // namespace

void add_volumetric_plan(const Verb& volumetric, int& exit_code) {
  Verb verb = volumetric.add_subcommand("plan", "Where to stand and measure, and what that will tell");
  verb->footer(volumetric_plan_examples);
  auto arguments = std::make_shared<VolumetricPlanArguments>();
  verb->add_option("--machine", arguments->request.machine, "The machine, its tools and the instrument, as JSON")
      ->type_name("FILE")
      ->required();
  add_layout(*verb, *arguments);
  add_limits(*verb, *arguments);
  const auto file = [&](const char* name, std::string& target, const char* description) {
    verb->add_option(name, target, description)->check(fault_of_name)->type_name("FILE")->group("Outputs");
  };
  file("--out", arguments->out, "The plan to FILE, for nc and simulate, or to the standard output with -");
  file("--points-out", arguments->points, "Its points as CSV, with a column for the lengths");
  file("--json", arguments->json, "What it will tell, as JSON");
  verb->add_flag("--quiet,-q", arguments->quiet, "No summary in the terminal")->group("Outputs");
  verb->callback([arguments, &exit_code] {
    check_json_out(arguments->out, "; --points-out writes its points as a table");
    exit_code = run(*arguments);
  });
}

}  // namespace axiometry::cli
