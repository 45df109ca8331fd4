// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <memory>
#include <optional>
#include <string>
#include "cli/flags/experiment_flags.h"
#include "cli/flags/verb.h"

#include "axiometry/app/files/number_list.h"
#include "axiometry/app/plan/plan.h"
#include "axiometry/app/tracking/tracking_locate.h"
#include "axiometry/app/tracking/tracking_plan.h"
#include "axiometry/base/text/text.h"
#include "cli/failure.h"
#include "cli/flags/option_text.h"
#include "cli/flags/ranging_flag.h"
#include "cli/text/document_text.h"
#include "cli/text/tracking_plan_summary.h"
#include "cli/verbs/commands.h"
#include "cli/verbs/tracking/tracking.h"

namespace axiometry::cli {
namespace {

constexpr const char* tracking_plan_examples =
    R"(The station and obstacles are in the coordinates of the reflector: where it stands when the axes
stand at X, Y, Z, plus the tool offset. Lengths are in mm unless they carry a unit (0.2m).
Examples:
  axiometry tracking plan --travel X=0:800,Y=0:600,Z=-500:0 --tool 0,0,-120 --station 100,80,-600 --out lines.json
  axiometry tracking plan --travel X=0:800,Y=0:600,Z=-500:0 --tool 0,0,-120 --station station.json \
      --obstacle vice=box:450,130,-700:550,230,-520 --period 10 --sheet lines.pdf --out lines.json
  axiometry tracking plan --travel X=0:800,Y=0:600,Z=-500:0 --tool 0,0,-120 --station 100,80,-600 \
      --locate 6 --points points.csv
  axiometry tracking plan --setup lines.json --station 400,-20,-600 --suggest --out other.json
  axiometry tracking plan --setup lines.json --lines x,y,xy --rule corner --out three.json
  axiometry tracking plan --travel X=0:800,Y=0:600,Z=-500:0 --diagonals body,face --sheet d.pdf --out diagonals.json)";

struct TrackingPlanArguments {
  app::TrackingPlanRequest request;
  std::optional<std::uint64_t> seed;
  std::optional<std::size_t> location_points;  ///< how many to plan, instead of lines
  std::string points;                          ///< file of their table
  app::OutputNames outputs;
  report::Options report;
  bool quiet = false;
};

template <typename T, typename Parse>
auto into(std::optional<T>& target, Parse parse) {
  return [&target, parse](const std::string& text) -> Result<void> {
    AXIOMETRY_TRY(target, parse(text));
    return {};
  };
}

Result<void> take_reflector(app::TrackingPlanRequest& request, const std::string& text) {
  request.turn_reflector = text == "auto";
  if (request.turn_reflector) return {};
  AXIOMETRY_TRY(request.setup.reflector_axis, app::parse_vector(text));
  return {};
}

void add_setup(const Verb& verb, TrackingPlanArguments& arguments) {
  app::SetupRequest& setup = arguments.request.setup;
  constexpr const char* group = "Set-up";
  verb.add_option("--setup", setup.file,
                  "Set-up or tracking plan (JSON) to begin with; what is given beside it goes before")
      ->type_name("FILE")
      ->group(group);
  add_read(verb, {"--travel", "X=A:B,Y=A:B,Z=A:B", "Travels of the axes"}, into(setup.travel, app::parse_travel_box))
      ->group(group);
  add_read(verb, {"--tool", "X,Y,Z", "From where the axes stand to the centre of the reflector (0,0,0)"},
           into(setup.tool_offset_mm, app::parse_vector))
      ->group(group);
  verb.add_option("--station", setup.station,
                  "Where the instrument stands, X,Y,Z, or the file that `tracking locate --json` wrote; none: it is "
                  "aligned with each diagonal")
      ->type_name("X,Y,Z, FILE or none")
      ->group(group);
  verb.add_option_function<std::vector<std::string>>(
          "--obstacle",
          [&setup](const std::vector<std::string>& texts) {
            for (const std::string& text : texts) {
              auto obstacle = app::parse_obstacle(text);
              if (!obstacle) throw UsageError("--obstacle", obstacle.error().message);
              setup.obstacles.push_back(*std::move(obstacle));
            }
          },
          "NAME=box:X,Y,Z:X,Y,Z, NAME=sphere:X,Y,Z:RADIUS or NAME=cylinder:X,Y,Z:RADIUS:HEIGHT; may be repeated")
      ->type_name("SOLID")
      ->one_at_a_time()
      ->group(group);
}

void add_limits(const Verb& verb, TrackingPlanArguments& arguments) {
  app::SetupRequest& setup = arguments.request.setup;
  constexpr const char* group = "Limits";
  add_read(verb, {"--range", "LEAST:MOST", "Of the instrument (0.2m:15m)"}, into(setup.range_mm, app::parse_range))
      ->group(group);
  add_read(verb, {"--elevation", "LOWEST:HIGHEST", "Of the beam above the plane of X and Y, ° (-20:90)"},
           into(setup.elevation_deg, app::parse_elevation))
      ->group(group);
  add_read(
      verb,
      {"--reflector", "X,Y,Z or auto",
       "Where the reflector looks, from the spindle; auto: the direction that keeps the most lines (auto, or that of "
       "--setup)"},
      [&arguments](const std::string& text) { return take_reflector(arguments.request, text); })
      ->group(group);
  add_number(verb, {"--incidence", "DEGREES", "Largest angle between the beam and that direction (60)"},
             [&setup](double x) { setup.incidence_deg = x; })
      ->group(group);
  add_number(verb, {"--safe-radius", "MM", "Nothing of the machine comes nearer to the station (120)"},
             [&setup](double x) { setup.safe_radius_mm = x; })
      ->group(group);
  add_number(verb, {"--min-length", "MM", "A shorter line is lost (100)"}, [&setup](double x) {
    setup.line_least_mm = x;
  })->group(group);
  add_ranging(verb, [&setup](const RangingUncertainty& ranging) { setup.ranging = ranging; })->group(group);
}

/// "x,y,NNN-PPP", appended: --lines and --diagonals may both be given.
void add_ids(std::vector<std::string>& ids, const std::string& text) {
  for (std::string_view id : text::split(text, ',')) ids.emplace_back(text::trim(id));
}

void add_lines(const Verb& verb, TrackingPlanArguments& arguments) {
  tracking::LinesRequest& lines = arguments.request.lines;
  constexpr const char* group = "Lines";
  add_read(verb, {"--lines", "LIST", "Of x, y, z, xy, xz, yz, xyz; exit code 3 when one of them is lost (all seven)"},
           [&lines](const std::string& text) -> Result<void> {
             add_ids(lines.ids, text);
             return {};
           })
      ->group(group);
  add_read(verb,
           {"--diagonals", "LIST",
            "Full diagonals of the travels (ISO 230-6): body, face, or some such as NNN-PPP,NN0-PP0. For an "
            "interferometer aligned with each of them, which needs no station"},
           [&lines](const std::string& text) -> Result<void> {
             add_ids(lines.ids, text);
             return {};
           })
      ->group(group);
  add_read(verb, {"--rule", "RULE", "Diagonals from the station: equal (increments, 45°) or corner (of the travels)"},
           [&lines](const std::string& text) -> Result<void> {
             if (text != "equal" && text != "corner")
               return fail(fmt::format("found {}, expected equal or corner", text::quoted(text)));
             lines.rule =
                 text == "equal" ? tracking::DiagonalRule::equal_increments : tracking::DiagonalRule::box_corner;
             return {};
           })
      ->group(group);
  verb.add_flag("--suggest", arguments.request.suggest, "Say from which station more lines could be measured")
      ->group(group);
}

void add_programme(const Verb& verb, TrackingPlanArguments& arguments) {
  tracking::LinesRequest& lines = arguments.request.lines;
  const std::vector<Flag> options = {
      add_count(verb, {"--targets", "N", "Of each line (as the clause asks: five, and five per metre)"},
                [&lines](unsigned long long n) { lines.count = n; }),
      add_count(verb, {"--runs", "N", "Approaches to each target from each direction (5)"},
                [&lines](unsigned long long n) { lines.runs = n; }),
      add_number(verb, {"--overrun", "MM", "Beyond a target before the direction changes (1 to 10, as `plan` has it)"},
                 [&lines](double x) { lines.overrun = Position::native(x); }),
      add_number(verb, {"--feed", "FEED", "mm/min along the line (1000)"}, [&lines](double x) { lines.feed = x; }),
      add_number(verb, {"--dwell", "SECONDS", "At rest on every target (3)"},
                 [&lines](double x) { lines.dwell = Duration::s(x); }),
      add_count(verb, {"--warm-up", "N", "Runs there and back on each line before its first reading (1)"},
                [&lines](unsigned long long n) { lines.warm_up_runs = n; }),
      add_number(verb, {"--acceleration", "A", "Of the axes, mm/s² (1000)"},
                 [&lines](double x) { lines.acceleration = x; }),
      add_read(verb, {"--period", "PERIODS", "Expected of periodic errors, mm: 10, or X=10,Y=10,Z=5"},
               [&lines](const std::string& text) -> Result<void> {
                 AXIOMETRY_TRY(lines.periods, app::parse_periods(text));
                 return {};
               }),
      add_number(verb, {"--step", "MM", "To which coordinates of targets are rounded (0.001)"},
                 [&lines](double x) { lines.step_mm = x; }),
      add_count(verb, {"--seed", "N", "Of the random part of the targets; drawn and written down when not given"},
                [&arguments](unsigned long long n) { arguments.seed = n; }),
      verb.add_option("--title", lines.title, "Title of the test")->type_name("TEXT"),
      verb.add_option("--machine", lines.machine, "Name of the machine")->type_name("NAME"),
      verb.add_option("--date", lines.date, "Of the plan, such as 2026-11-21; today when not given")->type_name("DATE"),
  };
  for (Flag option : options) option->group("Programme");
}

void add_location(const Verb& verb, TrackingPlanArguments& arguments) {
  constexpr const char* group = "Station location";
  add_count(verb, {"--locate", "N", "Plan N points (6 to 50) that find the station well, instead of lines (8)"},
            [&arguments](unsigned long long n) { arguments.location_points = n; })
      ->group(group);
  verb.add_option("--points", arguments.points,
                  "Their table to FILE, or to the standard output with -: to be filled in at the machine, and read by "
                  "`tracking locate`; --sheet and --out are of these points")
      ->type_name("FILE")
      ->group(group);
}

void add_outputs(const Verb& verb, TrackingPlanArguments& arguments) {
  constexpr const char* group = "Outputs";
  verb.add_option("--out,--json", arguments.outputs.json, "The plan as JSON to FILE, or to the standard output with -")
      ->check(fault_of_name)
      ->type_name("FILE")
      ->group(group);
  add_sheet_flags(verb, "--sheet,--report", arguments.outputs, arguments.report, arguments.quiet);
}

app::InputFiles inputs_of(const app::SetupRequest& setup) {
  std::vector<app::InputFile> inputs;
  if (!setup.file.empty()) inputs.push_back({setup.file, false});
  if (!setup.station.empty() && setup.station != "none" && !app::parse_vector(setup.station))
    inputs.push_back({setup.station, false});
  return app::InputFiles(inputs);
}

constexpr std::size_t usual_points = 8;  // two more than needed: a misread length is then known by its number

int run_location(const TrackingPlanArguments& arguments) {
  const auto planned = app::plan_location_points(arguments.request, arguments.location_points.value_or(usual_points));
  if (!planned) return failed(planned.error());
  const app::Experiment presented = app::present(*planned, arguments.report);
  if (!arguments.points.empty())
    if (auto written = app::write_location_points(*planned, arguments.points); !written) return failed(written.error());
  if (auto written = app::write_outputs(presented, arguments.outputs, arguments.report); !written)
    return failed(written.error());
  if (!arguments.quiet && arguments.outputs.json != "-" && arguments.points != "-")
    fmt::print("{}", document_text(presented.document, arguments.report, Terminal(ColourChoice::automatic)));
  return exit_done;
}

int run(TrackingPlanArguments& arguments) {
  arguments.outputs.inputs = inputs_of(arguments.request.setup);
  if (auto spared = app::check_inputs_spared(arguments.outputs); !spared) return failed(spared.error(), exit_usage);
  if (!arguments.points.empty())
    if (auto spared = arguments.outputs.inputs.check_spared(arguments.points); !spared)
      return failed(spared.error(), exit_usage);
  if (arguments.location_points || !arguments.points.empty()) return run_location(arguments);
  tracking::LinesRequest& lines = arguments.request.lines;
  lines.seed = arguments.seed ? *arguments.seed : app::drawn_seed();
  auto date = app::plan_date(lines.date);
  if (!date) return failed(date.error());
  lines.date = *std::move(date);
  const auto planned = app::plan_tracking(arguments.request);
  if (!planned) return failed(planned.error());
  if (auto written = app::write_outputs(*planned, arguments.outputs, arguments.report); !written)
    return failed(written.error());
  if (!arguments.quiet && arguments.outputs.json != "-")
    fmt::print("{}", tracking_plan_summary(*planned, arguments.report, Terminal(ColourChoice::automatic)));
  return !lines.ids.empty() && !planned->plan.lost.empty() ? exit_exceeded : exit_done;
}

}  // namespace

void add_tracking_plan(const Verb& tracking, int& exit_code) {
  Verb verb = tracking.add_subcommand("plan", "Plan seven lines from one station, or diagonals of the travels");
  verb->footer(tracking_plan_examples);
  auto arguments = std::make_shared<TrackingPlanArguments>();
  add_setup(*verb, *arguments);
  add_limits(*verb, *arguments);
  add_lines(*verb, *arguments);
  add_programme(*verb, *arguments);
  add_location(*verb, *arguments);
  add_outputs(*verb, *arguments);
  verb->callback([arguments, &exit_code] {
    check_sheet_outputs(arguments->outputs);
    exit_code = run(*arguments);
  });
}

}  // namespace axiometry::cli
