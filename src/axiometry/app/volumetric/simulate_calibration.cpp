// SPDX-License-Identifier: Apache-2.0
#include "axiometry/app/volumetric/simulate_calibration.h"

#include <fmt/format.h>

#include <algorithm>
#include <string_view>
#include <utility>

#include "axiometry/app/files/output.h"
#include "axiometry/app/files/whole_file.h"
#include "axiometry/app/recordings/raw_recording.h"
#include "axiometry/app/results/outputs.h"
#include "axiometry/app/results/result_json.h"
#include "axiometry/base/text/text.h"
#include "axiometry/formats/text/json_members.h"
#include "axiometry/formats/volumetric/machine_json.h"
#include "axiometry/formats/volumetric/true_errors_json.h"
#include "axiometry/formats/volumetric/volumetric_lengths_csv.h"
#include "axiometry/formats/volumetric/volumetric_plan_json.h"

namespace axiometry::app {
namespace {

using formats::vector_value;
using json::Value;
using volumetric::MachineModel;
using volumetric::VolumetricReading;

constexpr std::size_t simulated_readings_most = 1'000'000;
constexpr std::string_view part_place = "{part}";

/// Which of the readings in the table; 1 is the first below the header and the comment.
void add_simulated_reading(Value& object, const SimulatedCalibration& calibration, std::size_t i) {
  const VolumetricReading& reading = calibration.simulated.lengths.readings[i];
  object.add("reading", i + 1);
  object.add("station", calibration.machine.stations[reading.station].name);
  object.add("tool", calibration.machine.tools[reading.tool].name);
}

/// A recording that is to be written: of which parts.
struct NamedRecording {
  std::string name;
  PartRange parts;
};

Result<std::vector<NamedRecording>> recordings_of(const SimulatedCalibration& calibration, const std::string& name) {
  std::vector<NamedRecording> recordings;
  if (name.empty()) return recordings;
  if (!calibration.plan) return fail("found recordings asked for without a plan, expected the ways of one");
  AXIOMETRY_TRY(const RawLayout layout, raw_layout_of(name));
  if (layout == RawLayout::umd)
    return fail(
        fmt::format("found the recording {}, expected a file ending in .csv, .txt or .npy", text::quoted(name)));
  const std::size_t parts = calibration.plan->runs.size();
  const std::size_t at = name.find(part_place);
  if (at == std::string::npos) return std::vector{NamedRecording{name, {1, parts}}};
  for (std::size_t part = 1; part <= parts; ++part) {
    if (calibration.plan->runs[part - 1].stops.empty()) continue;
    std::string own = name;
    own.replace(at, part_place.size(), fmt::format("{}", part));
    recordings.push_back({std::move(own), {part, part}});
  }
  return recordings;
}

struct WrittenRecordings {
  std::vector<RawRecording> files;  // not committed yet
  std::size_t samples = 0;
};

Result<WrittenRecordings> write_recordings(const SimulatedCalibration& calibration,
                                           const std::vector<NamedRecording>& names) {
  WrittenRecordings written;
  for (const NamedRecording& named : names) {
    AXIOMETRY_TRY(const PartsRecording recording,
                  PartsRecording::make(*calibration.plan, named.parts, calibration.errors, calibration.simulated,
                                       calibration.request.recording, calibration.request.seed + named.parts.first));
    RawSetting setting;
    setting.samples = recording.samples();
    setting.rate = calibration.request.recording.rate;
    setting.lengths = true;
    AXIOMETRY_TRY(RawRecording file, RawRecording::create(named.name, setting));
    AXIOMETRY_TRY_VOID(recording.record([&](std::span<const Sample> some) { return file.write(some); }));
    written.files.push_back(std::move(file));
    written.samples += recording.samples();
  }
  return written;
}

Result<void> check_simulate_names(const SimulateRequest& request, const SimulateFiles& files,
                                  const std::vector<NamedRecording>& recordings) {
  std::vector<std::string> names;
  for (const std::string& name : {files.lengths, files.truth})
    if (!name.empty()) names.push_back(name);
  for (const NamedRecording& recording : recordings) names.push_back(recording.name);
  if (names.empty()) return fail("found no output, expected lengths, a recording or the truth");
  std::vector<std::string> sorted = names;
  std::ranges::sort(sorted);
  if (const auto twice = std::ranges::adjacent_find(sorted); twice != sorted.end())
    return fail(fmt::format("found the output {} twice, expected different names", text::quoted(*twice)));
  std::vector<InputFile> read = {{request.machine.empty() ? request.plan : request.machine, false}};
  if (!request.errors.empty()) read.push_back({request.errors, false});
  const InputFiles inputs(read);
  for (const std::string& name : names)
    if (name != "-") AXIOMETRY_TRY_VOID(inputs.check_spared(name));
  return {};
}

Result<SimulationInputs> machine_and_visits(std::string_view bytes, const SimulateRequest& request) {
  if (!request.plan.empty()) {
    AXIOMETRY_TRY(volumetric::CalibrationPlan plan, formats::read_volumetric_plan(bytes));
    std::vector<volumetric::Visit> visits = volumetric::visits_of(plan);
    MachineModel machine = plan.machine;
    return SimulationInputs{std::move(machine), false, {}, std::move(visits), std::move(plan)};
  }
  AXIOMETRY_TRY(formats::MachineFile file, formats::read_machine(bytes));
  MachineModel& machine = file.machine;
  if (!request.stations_mm.empty()) {
    machine.stations.clear();
    for (const Vector3& at : request.stations_mm)
      machine.stations.push_back({fmt::format("S{}", machine.stations.size() + 1), at});
  }
  if (machine.stations.empty())
    return fail("found no station, expected stations_mm of the machine, or one that is stated");
  if (request.points == 0 || request.points > simulated_readings_most / machine.stations.size() / machine.tools.size())
    return fail(fmt::format("found {} points of each station and tool, expected 1 to {} readings in all",
                            request.points, simulated_readings_most));
  return SimulationInputs{std::move(file.machine), false, {}, {}, {}};
}

}  // namespace

Result<SimulationInputs> simulation_inputs(const SimulateRequest& request) {
  if (request.machine.empty() == request.plan.empty())
    return fail("found neither a machine nor a plan, or both, expected one of them");
  if (!request.plan.empty() && !request.stations_mm.empty())
    return fail("found a plan and stations beside it, expected those of the plan alone");
  const std::string& name = request.plan.empty() ? request.machine : request.plan;
  AXIOMETRY_TRY(const std::string bytes, whole_file(name));
  AXIOMETRY_TRY(SimulationInputs inputs, in_file(machine_and_visits(bytes, request), name));
  inputs.has_errors = !request.errors.empty();
  if (inputs.has_errors) {
    AXIOMETRY_TRY(const std::string error_bytes, whole_file(request.errors));
    AXIOMETRY_TRY(inputs.errors, in_file(formats::read_true_errors(error_bytes, inputs.machine), request.errors));
  }
  return inputs;
}

Result<SimulatedCalibration> simulate_calibration(const SimulateRequest& request) {
  AXIOMETRY_TRY(SimulationInputs inputs, simulation_inputs(request));
  if (inputs.has_errors && request.reversal != volumetric::Reversal::none)
    return fail("found errors of a file and reversal to be drawn, expected the reversal that the file holds");
  const volumetric::Draw draw{request.seed, 0};
  volumetric::SimulatedCourse course =
      volumetric::simulated_course(inputs.machine,
                                   {.errors = inputs.has_errors ? &inputs.errors : nullptr,
                                    .size = request.size,
                                    .reversal = request.reversal,
                                    .visits = inputs.visits,
                                    .points = request.points},
                                   draw);
  AXIOMETRY_TRY(volumetric::SimulatedLengths simulated,
                volumetric::simulate_lengths(inputs.machine, course.errors, course.visits, request.faults, draw));
  return SimulatedCalibration{request, std::move(inputs.machine), std::move(course.errors), std::move(simulated),
                              std::move(inputs.plan)};
}

Value truth_value(const SimulatedCalibration& calibration) {
  const volumetric::SimulatedLengths& simulated = calibration.simulated;
  Value root = Value::object();
  root.add("format", "axiometry-volumetric-truth/1");
  root.add("seed", static_cast<double>(calibration.request.seed));
  root.add("machine", formats::machine_value(calibration.machine));
  root.add("errors", formats::true_errors_value(calibration.errors));
  root.add("errors_in_gauge",
           formats::true_errors_value(volumetric::in_gauge(calibration.errors, calibration.machine)));
  Value& paths = root.add("dead_paths", Value::array());
  for (const volumetric::SimulatedDeadPath& p : simulated.dead_paths) {
    Value& item = paths.push(Value::object());
    item.add("station", calibration.machine.stations[p.station].name);
    item.add("tool", calibration.machine.tools[p.tool].name);
    item.add("dead_path_mm", p.dead_path_mm);
    item.add("drift_um", p.drift_um);
    if (p.scale_um_per_m != 0.0) item.add("scale_um_per_m", p.scale_um_per_m);
  }
  Value& jumps = root.add("beam_breaks", Value::array());
  for (const volumetric::SimulatedJump& j : simulated.jumps) {
    Value& item = jumps.push(Value::object());
    add_simulated_reading(item, calibration, j.before_reading);
    item.add("jump_um", j.jump_um);
    item.add("told", j.told);
  }
  Value& outliers = root.add("outliers", Value::array());
  for (const volumetric::SimulatedOutlier& o : simulated.outliers) {
    Value& item = outliers.push(Value::object());
    add_simulated_reading(item, calibration, o.reading);
    item.add("error_um", o.error_um);
  }
  Value& lost = root.add("lost", Value::array());
  for (const volumetric::Visit& visit : simulated.lost) {
    Value& item = lost.push(Value::object());
    item.add("station", calibration.machine.stations[visit.station].name);
    item.add("tool", calibration.machine.tools[visit.tool].name);
    item.add("axes_mm", vector_value(visit.axes_mm));
  }
  Value& readings = root.add("displacements_um", Value::array());
  for (const Vector3& d : simulated.displacements_um) readings.push(vector_value(d));
  root.add("program", program_to_json());
  return root;
}

Result<SimulatedSummary> write_simulated(const SimulatedCalibration& calibration, const SimulateFiles& files) {
  AXIOMETRY_TRY(const std::vector<NamedRecording> recordings, recordings_of(calibration, files.recordings));
  AXIOMETRY_TRY_VOID(check_simulate_names(calibration.request, files, recordings));
  std::vector<std::pair<std::string, std::string>> texts;
  if (!files.lengths.empty())
    texts.emplace_back(files.lengths, fmt::format("# Simulated, not measured; seed {}\n", calibration.request.seed) +
                                          formats::write_volumetric_lengths(calibration.simulated.lengths));
  if (!files.truth.empty()) texts.emplace_back(files.truth, json::dump(truth_value(calibration)) + "\n");
  std::vector<OutputFile> outputs;
  for (const auto& [name, text] : texts) {
    AXIOMETRY_TRY(OutputFile output, OutputFile::create(name));
    AXIOMETRY_TRY_VOID(output.write(text));
    outputs.push_back(std::move(output));
  }
  AXIOMETRY_TRY(WrittenRecordings written, write_recordings(calibration, recordings));
  for (RawRecording& file : written.files) AXIOMETRY_TRY_VOID(file.commit());
  for (OutputFile& output : outputs) AXIOMETRY_TRY_VOID(output.commit());
  return SimulatedSummary{recordings.size(), written.samples};
}

}  // namespace axiometry::app
