// SPDX-License-Identifier: Apache-2.0
#include "axiometry/app/plan/nc_program.h"

#include <fmt/format.h>

#include <filesystem>
#include <optional>
#include <span>
#include <system_error>
#include <vector>

#include "axiometry/app/files/output.h"
#include "axiometry/app/files/whole_file.h"
#include "axiometry/base/text/number_text.h"
#include "axiometry/base/text/text.h"
#include "axiometry/formats/plan/plan_json.h"
#include "axiometry/formats/plan/tracking_plan_json.h"
#include "axiometry/formats/volumetric/volumetric_plan_json.h"
#include "axiometry/model/aligned.h"
#include "axiometry/nc/numbers.h"
#include "axiometry/standards/iso230_2/plan/plan.h"
#include "axiometry/tracking/lines/seven_lines.h"
#include "axiometry/volumetric/plan/run_way.h"

namespace axiometry::app {
namespace {

/// What one program walks.
struct Programme {
  std::string title;
  std::vector<Plan> plans;
  /// For each plan: the interferometer is aligned with one line after the other, so that the program always waits for
  /// the operator before each.
  bool set_up_anew = false;
  nc::PlanStanding standing{};  ///< of the plan that a single test is of, with those that belong to it
};

nc::PlanStanding standing_of(const Plan& plan) {
  nc::PlanStanding standing;
  for (const iso230_2::Finding& finding : iso230_2::plan_findings(plan)) {
    if (finding.severity == iso230_2::Severity::departure) ++standing.departures;
    if (finding.severity == iso230_2::Severity::missing) ++standing.missing;
  }
  return standing;
}

Result<Programme> programme_of_part(const Plan& plan, const NcRequest& request) {
  if (!request.line.empty())
    return fail(fmt::format("found the line {} asked for, expected none: this is no tracking plan, which has lines",
                            text::quoted(request.line)));
  if (request.options.stop_at_lines)
    return fail("found a stop before each line asked for, expected none: this is no tracking plan, which has lines");
  if (request.part < 1 || request.part > plan.further.size() + 1)
    return fail(fmt::format("found part {} asked for, expected {}", request.part,
                            plan.further.empty() ? "1" : fmt::format("1 to {}", plan.further.size() + 1)));
  return Programme{
      .title = "", .plans = {request.part == 1 ? plan : plan.further[request.part - 2]}, .standing = standing_of(plan)};
}

/// What a comment in the program can say.
Plan plan_of_line(const TrackingLine& line, const TrackingPlan& whole, bool alone) {
  Plan plan = alone ? tracking::plan_alone(whole.setup, line) : line.plan;
  if (plan.axis.name.empty()) plan.axis.name = line.id;
  if (plan.machine.empty()) plan.machine = whole.machine;
  if (plan.date.empty()) plan.date = whole.date;
  return plan;
}

std::string line_ids(const TrackingPlan& plan) {
  std::vector<std::string_view> ids;
  for (const TrackingLine& line : plan.lines) ids.push_back(line.id);
  return fmt::format("{}", fmt::join(ids, ", "));
}

/// The line that is asked for is lost, or there is none at all.
std::unexpected<Error> no_line(const TrackingPlan& plan, const std::string& id) {
  for (const LostLine& lost : plan.lost)
    if (lost.id == id)
      return fail(fmt::format("found the line {} asked for, which is lost ({}), expected one of {}", text::quoted(id),
                              lost.reason, line_ids(plan)));
  return fail(fmt::format("found the line {} asked for, expected one of {}", text::quoted(id), line_ids(plan)));
}

Result<Programme> lines_of(const TrackingPlan& plan, const NcRequest& request) {
  if (request.part != 1)
    return fail(fmt::format("found part {} asked for, expected none: a tracking plan has lines", request.part));
  if (plan.lines.empty()) return fail("found a tracking plan without lines, expected at least one that is not lost");
  Programme programme{.title = plan.title, .plans = {}};
  const bool all = request.line.empty();
  for (const TrackingLine& line : plan.lines)
    if (all || request.line == line.id) programme.plans.push_back(plan_of_line(line, plan, !all));
  if (programme.plans.empty()) return no_line(plan, request.line);
  programme.set_up_anew = is_aligned(plan.setup) && programme.plans.size() > 1;
  return programme;
}

Result<Programme> programme_of(std::string_view bytes, const NcRequest& request) {
  if (formats::is_tracking_plan(bytes)) {
    AXIOMETRY_TRY(const TrackingPlan plan, formats::read_tracking_plan(bytes));
    return lines_of(plan, request);
  }
  AXIOMETRY_TRY(const Plan plan, formats::read_plan(bytes));
  return programme_of_part(plan, request);
}

/// Of several plans with the way from the end of each to the next.
Duration duration_of(std::span<const Plan> plans) {
  Duration sum;
  std::optional<Vector3> at;
  for (Plan plan : plans) {
    const auto line = spatial_line(plan.axis);
    if (at) plan.way_in_mm.insert(plan.way_in_mm.begin(), *at);
    if (line) at = plan.way_out_mm.empty() ? line->at(reach(plan).lowest) : plan.way_out_mm.back();
    sum = sum + iso230_2::estimated_duration(plan);
  }
  return sum;
}

Result<std::string> program_of(const Programme& programme, const nc::Dialect& dialect, nc::ProgramOptions options) {
  options.title = programme.title;
  options.duration = duration_of(programme.plans);
  options.acceleration = iso230_2::acceleration_of(programme.plans.front());
  options.standing = programme.standing;
  options.stop_at_lines = options.stop_at_lines || programme.set_up_anew;
  return dialect.write(programme.plans, options);
}

/// One station with one tool: the operator moves the instrument and changes the tool between programs.
Result<nc::PointTour> tour_of(const volumetric::CalibrationPlan& plan, const NcRequest& request) {
  if (!request.line.empty())
    return fail(fmt::format(
        "found the line {} asked for, expected none: this is the plan of a volumetric calibration, which has runs",
        text::quoted(request.line)));
  if (request.options.stop_at_lines)
    return fail(
        "found a stop before each line asked for, expected none: this is the plan of a volumetric calibration, whose "
        "programs stop wherever the beam is to be found again");
  if (request.part < 1 || request.part > plan.runs.size())
    return fail(fmt::format("found part {} asked for, expected 1 to {}: a run for each station and tool", request.part,
                            plan.runs.size()));
  const volumetric::PlannedRun& run = plan.runs[request.part - 1];
  const volumetric::NamedStation& station = plan.machine.stations[run.station];
  const volumetric::Tool& tool = plan.machine.tools[run.tool];
  const auto place = [](Vector3 v) {
    return fmt::format("X {} Y {} Z {}", format_exact(v.x), format_exact(v.y), format_exact(v.z));
  };
  if (run.stops.empty())
    return fail(fmt::format("found no point of station {} with tool {} (part {}), expected at least one",
                            text::quoted(station.name), text::quoted(tool.name), request.part));
  nc::PointTour tour{{}, {}, plan.feed_mm_per_min, plan.dwell};
  tour.heading = {fmt::format("VOLUMETRIC CALIBRATION, RUN {} OF {}", request.part, plan.runs.size()),
                  fmt::format("STATION {} AT {}", station.name, place(station.at_mm)),
                  fmt::format("TOOL {}, REFLECTOR AT {}", tool.name, place(tool.offset_mm))};
  if (!plan.machine.name.empty()) tour.heading.push_back("MACHINE " + plan.machine.name);
  if (!plan.date.empty()) tour.heading.push_back("DATE " + plan.date);
  for (const volumetric::WayPoint& point : volumetric::way_of(plan, run))
    tour.stops.push_back({point.axes_mm, point.is_reading, point.is_reading && !point.beam_kept});
  return tour;
}

Result<bool> switch_of(const std::string& text) {
  if (text.empty() || text == "1" || text == "true" || text == "on") return true;
  if (text == "0" || text == "false" || text == "off") return false;
  return fail(fmt::format("found {}, expected 1 or 0", text::quoted(text)));
}

Result<unsigned> whole_of(const std::string& text, unsigned long long most) {
  const auto count = parse_count(text);
  if (!count || *count > most)
    return fail(fmt::format("found {}, expected a whole number up to {}", text::quoted(text), most));
  return static_cast<unsigned>(*count);
}

/// None where nothing is said.
Result<std::optional<unsigned>> number_or_none(const std::string& text) {
  constexpr unsigned long long most = 99'999'999;
  if (text.empty()) return std::optional<unsigned>();
  return whole_of(text, most);
}

Result<void> put_option(nc::ProgramOptions& options, const std::string& name, const std::string& text) {
  if (name == "unit") {
    if (text != "mm" && text != "inch") return fail(fmt::format("found {}, expected mm or inch", text::quoted(text)));
    options.unit = text == "mm" ? nc::LengthUnit::mm : nc::LengthUnit::inch;
  } else if (name == "unrolled") {
    AXIOMETRY_TRY(options.unrolled, switch_of(text));
  } else if (name == "block_numbers") {
    AXIOMETRY_TRY(options.block_numbers, switch_of(text));
  } else if (name == "stop_at_start") {
    AXIOMETRY_TRY(options.stop_at_start, switch_of(text));
  } else if (name == "stop_at_lines") {
    AXIOMETRY_TRY(options.stop_at_lines, switch_of(text));
  } else if (name == "decimals") {
    AXIOMETRY_TRY(const unsigned decimals, whole_of(text, nc::decimals_highest));
    options.decimals = static_cast<int>(decimals);
  } else if (name == "trigger_m_code") {
    AXIOMETRY_TRY(options.trigger_m_code, number_or_none(text));
  } else if (name == "number") {
    AXIOMETRY_TRY(options.number, number_or_none(text));
  } else if (name == "frame") {
    options.frame = text;
  } else if (name == "rollover") {
    AXIOMETRY_TRY(options.rollover, switch_of(text));
  } else {
    return fail(
        "found no such option, expected unit, unrolled, trigger_m_code, number, decimals, block_numbers, "
        "stop_at_start, stop_at_lines, frame or rollover");
  }
  return {};
}

}  // namespace

Result<const nc::Dialect*> dialect_of(std::string_view id) {
  if (const nc::Dialect* dialect = nc::find_dialect(id)) return dialect;
  std::vector<std::string_view> known;
  for (const nc::Dialect* dialect : nc::dialect_table()) known.push_back(dialect->id);
  const auto near = text::nearest(id, known);
  return fail(fmt::format("found the unknown dialect {}, expected {}", text::quoted(id),
                          near ? fmt::format("perhaps {}", *near) : fmt::format("one of {}", fmt::join(known, ", "))));
}

Result<std::string> nc_program(const NcRequest& request) {
  AXIOMETRY_TRY(const nc::Dialect* const dialect, dialect_of(request.dialect));
  AXIOMETRY_TRY(const std::string bytes, whole_file(request.plan));
  if (formats::is_volumetric_plan(bytes)) {
    AXIOMETRY_TRY(const auto plan, in_file(formats::read_volumetric_plan(bytes), request.plan));
    return in_file(nc_program_of(plan, request), request.plan);
  }
  AXIOMETRY_TRY(const Programme programme, in_file(programme_of(bytes, request), request.plan));
  return in_file(program_of(programme, *dialect, request.options), request.plan);
}

Result<std::string> nc_program_of(const Plan& plan, const NcRequest& request) {
  AXIOMETRY_TRY(const nc::Dialect* const dialect, dialect_of(request.dialect));
  AXIOMETRY_TRY(const Programme programme, programme_of_part(plan, request));
  return program_of(programme, *dialect, request.options);
}

Result<std::string> nc_program_of(const TrackingPlan& plan, const NcRequest& request) {
  AXIOMETRY_TRY(const nc::Dialect* const dialect, dialect_of(request.dialect));
  AXIOMETRY_TRY(const Programme programme, lines_of(plan, request));
  return program_of(programme, *dialect, request.options);
}

Result<std::string> nc_program_of(const volumetric::CalibrationPlan& plan, const NcRequest& request) {
  AXIOMETRY_TRY(const nc::Dialect* const dialect, dialect_of(request.dialect));
  AXIOMETRY_TRY(const nc::PointTour tour, tour_of(plan, request));
  return dialect->write_tour(tour, request.options);
}

Result<nc::ProgramOptions> nc_options(std::span<const std::pair<std::string, std::string>> texts) {
  nc::ProgramOptions options;
  for (const auto& [name, text] : texts)
    if (auto put = put_option(options, name, text); !put) return fail(fmt::format("{}: {}", name, put.error().message));
  return options;
}

Result<void> write_nc_program(const NcRequest& request, const std::string& output) {
  std::error_code none;  // where a file does not exist there is nothing to spare
  if (output != "-" && request.plan != "-" && std::filesystem::equivalent(request.plan, output, none))
    return std::unexpected(Error{"found the plan itself, expected another file for the program", output, {}});
  AXIOMETRY_TRY(const std::string program, nc_program(request));
  return write_file(output, program);
}

}  // namespace axiometry::app
