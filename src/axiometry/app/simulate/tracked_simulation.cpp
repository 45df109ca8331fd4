// SPDX-License-Identifier: Apache-2.0
#include "axiometry/app/simulate/tracked_simulation.h"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "axiometry/app/files/output.h"
#include "axiometry/app/files/whole_file.h"
#include "axiometry/app/recordings/raw_recording.h"
#include "axiometry/app/results/outputs.h"
#include "axiometry/app/simulate/tracked_truth.h"
#include "axiometry/base/text/text.h"
#include "axiometry/formats/plan/tracking_plan_json.h"
#include "axiometry/model/aligned.h"
#include "axiometry/simulation/tracked_recording.h"
#include "axiometry/tracking/station/location_points.h"

namespace axiometry::app {
namespace {

constexpr std::size_t location_points = 6;
constexpr std::size_t grid_most = 1'000'000;

Result<void> check_output_names(const TrackedFiles& files) {
  std::vector<std::string> names;
  for (const std::string* name : {&files.points, &files.lengths, &files.recording, &files.ranges, &files.truth})
    if (!name->empty()) names.push_back(*name);
  if (names.empty()) return fail("found no output, expected points, lengths, a recording, ranges or the truth");
  if (!files.recording.empty()) {
    AXIOMETRY_TRY(const RawLayout layout, raw_layout_of(files.recording));
    if (layout == RawLayout::umd)
      return fail(fmt::format("found the recording {}, expected a file ending in .csv, .txt or .npy",
                              text::quoted(files.recording)));
  }
  const InputFile plan{files.plan, false};
  const InputFiles inputs(files.plan.empty() ? std::span<const InputFile>() : std::span(&plan, 1));
  for (std::size_t k = 0; k < names.size(); ++k) {
    if (std::ranges::count(names, names[k]) > 1)
      return fail(fmt::format("found the output {} twice, expected different names", text::quoted(names[k])));
    if (names[k] != "-") AXIOMETRY_TRY_VOID(inputs.check_spared(names[k]));
  }
  return {};
}

/// Evenly over the places of the reflector that the travels allow.
Result<std::vector<Vector3>> grid_points(const TrackedSimulation& request, const std::optional<TrackingPlan>& plan) {
  if (!plan) return fail("found no plan whose travels a grid could fill, expected a plan or points of the location");
  const auto& [nx, ny, nz] = request.grid;
  if (nx == 0 || ny == 0 || nz == 0 || nx > grid_most || ny > grid_most || nz > grid_most || nx * ny > grid_most ||
      nx * ny * nz > grid_most)
    return fail(fmt::format("found a grid of {} × {} × {} points, expected 1 to {} in all", nx, ny, nz, grid_most));
  const Vector3 low = plan->setup.travel.lowest_mm + plan->setup.tool_offset_mm;
  const Vector3 way = plan->setup.travel.highest_mm - plan->setup.travel.lowest_mm;
  const auto share = [](std::size_t k, std::size_t n) {
    return n == 1 ? 0.5 : static_cast<double>(k) / static_cast<double>(n - 1);
  };
  std::vector<Vector3> points;
  for (std::size_t z = 0; z < nz; ++z)
    for (std::size_t y = 0; y < ny; ++y)
      for (std::size_t x = 0; x < nx; ++x)
        points.push_back(low + Vector3{share(x, nx) * way.x, share(y, ny) * way.y, share(z, nz) * way.z});
  return points;
}

Result<std::vector<Vector3>> location_points_of(const TrackedSimulation& request,
                                                const std::optional<TrackingPlan>& plan) {
  if (!request.location_points_mm.empty()) return request.location_points_mm;
  if (!plan) return fail("found no points of a station location, expected some, or a plan to choose them for");
  AXIOMETRY_TRY(auto chosen, tracking::plan_location(plan->setup, location_points));
  return std::move(chosen.points_mm);
}

Result<TrackedResults> simulate(const TrackedSimulation& request, const TrackedFiles& files) {
  TrackedResults results{.tracker = request.truth.tracker,
                         .location = {},
                         .plan = {},
                         .lengths = {},
                         .range_points_mm = {},
                         .stations_mm = request.stations_mm,
                         .ranges = {}};
  if (!files.plan.empty()) {
    AXIOMETRY_TRY(const std::string text, whole_file(files.plan));
    AXIOMETRY_TRY(results.plan, in_file(formats::read_tracking_plan(text), files.plan));
  }
  const bool aligned = results.plan && is_aligned(results.plan->setup);
  if (aligned && (request.station_mm || !files.points.empty() || !files.recording.empty() || !files.ranges.empty()))
    return fail(
        "found a station, points, a recording or ranges for a plan whose interferometer is aligned with each line, "
        "expected lengths and the truth alone");
  if (!request.station_mm && !results.plan)
    return fail("found neither a true station nor a plan that has one, expected one of them");
  if (aligned)
    results.tracker.station_mm = setup_along(results.plan->setup, results.plan->lines.at(0)).station.position_mm;
  else
    results.tracker.station_mm = request.station_mm ? *request.station_mm : results.plan->setup.station.position_mm;
  if (results.stations_mm.empty()) results.stations_mm = {results.tracker.station_mm};
  const simulation::TrackedMachine& machine = request.truth.machine;
  simulation::PointDrive drive;
  if (results.plan) drive.tool_offset_mm = results.plan->setup.tool_offset_mm;

  Duration begin;
  if (!files.points.empty() || !request.location_points_mm.empty()) {
    AXIOMETRY_TRY(const auto points, location_points_of(request, results.plan));
    AXIOMETRY_TRY(results.location,
                  simulation::simulate_location(machine, results.tracker, points, drive, request.seed));
    results.tracker.dead_path_mm = results.location->dead_path_mm;
    begin = results.location->duration;
  }
  if (!files.lengths.empty() || !files.recording.empty()) {
    if (!results.plan) return fail("found no plan of lines to walk, expected one");
    AXIOMETRY_TRY(results.lengths,
                  simulation::simulate_lengths(machine, results.tracker, *results.plan, begin, request.seed));
  }
  if (!files.ranges.empty()) {
    if (request.location_points_mm.empty()) {
      AXIOMETRY_TRY(results.range_points_mm, grid_points(request, results.plan));
    } else {
      results.range_points_mm = request.location_points_mm;
    }
    simulation::VirtualTracker tracker = request.truth.tracker;  // its beam breaks in lines, if there are any
    if (results.lengths) tracker.breaks.clear();
    AXIOMETRY_TRY(results.ranges, simulation::simulate_ranges(machine, tracker, results.stations_mm,
                                                              results.range_points_mm, drive, request.seed));
  }
  return results;
}

struct WrittenRecording {
  RawRecording file;
  std::size_t samples = 0;
};

/// What the instrument shows all the time on the lines; not committed yet.
Result<WrittenRecording> record_lines(const TrackedSimulation& request, const TrackedResults& results,
                                      const std::string& name) {
  AXIOMETRY_TRY(const auto recording,
                simulation::TrackedRecording::make(request.truth.machine, results.tracker, *results.plan,
                                                   *results.lengths, request.rate, request.seed));
  RawSetting setting;
  setting.samples = recording.samples();
  setting.rate = request.rate;
  setting.lengths = true;
  AXIOMETRY_TRY(RawRecording raw, RawRecording::create(name, setting));
  AXIOMETRY_TRY_VOID(recording.record([&](std::span<const Sample> some) { return raw.write(some); }));
  return WrittenRecording{std::move(raw), recording.samples()};
}

}  // namespace

Result<TrackedSummary> run_tracked_simulation(const TrackedSimulation& request, const TrackedFiles& files) {
  AXIOMETRY_TRY_VOID(check_output_names(files));
  AXIOMETRY_TRY_VOID(check_sound(request.truth.machine));
  AXIOMETRY_TRY_VOID(check_sound(request.truth.tracker));
  AXIOMETRY_TRY(const TrackedResults results, simulate(request, files));
  std::vector<std::pair<std::string, std::string>> texts;
  if (!files.points.empty()) texts.emplace_back(files.points, location_table(request, *results.location));
  if (!files.lengths.empty()) texts.emplace_back(files.lengths, length_table(request, *results.lengths));
  if (!files.ranges.empty()) texts.emplace_back(files.ranges, range_table(request, results));
  if (!files.truth.empty()) texts.emplace_back(files.truth, json::dump(tracked_truth_value(request, results)) + "\n");
  std::optional<WrittenRecording> recording;
  if (!files.recording.empty()) {
    AXIOMETRY_TRY(recording, record_lines(request, results, files.recording));
  }
  std::vector<OutputFile> outputs;
  for (const auto& [name, text] : texts) {
    AXIOMETRY_TRY(OutputFile output, OutputFile::create(name));
    AXIOMETRY_TRY_VOID(output.write(text));
    outputs.push_back(std::move(output));
  }
  if (recording) AXIOMETRY_TRY_VOID(recording->file.commit());
  for (OutputFile& output : outputs) AXIOMETRY_TRY_VOID(output.commit());

  TrackedSummary summary{.station_mm = results.tracker.station_mm, .duration = {}};
  if (results.location) {
    summary.points = results.location->points.size();
    summary.duration = results.location->duration;
  }
  if (results.lengths) {
    summary.lengths = results.lengths->readings.size();
    summary.lines = results.plan->lines.size();
    summary.duration = results.lengths->end;
  }
  if (recording) summary.samples = recording->samples;
  if (results.ranges) summary.ranges = results.ranges->readings.size();
  return summary;
}

}  // namespace axiometry::app
