// SPDX-License-Identifier: Apache-2.0
#include "axiometry/app/simulate/simulate.h"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <optional>
#include <vector>

#include "axiometry/app/files/whole_file.h"
#include "axiometry/app/plan/plan.h"
#include "axiometry/app/recordings/raw_recording.h"
#include "axiometry/app/results/outputs.h"
#include "axiometry/app/simulate/simulation_truth.h"
#include "axiometry/base/text/text.h"
#include "axiometry/formats/format.h"
#include "axiometry/model/simulated.h"
#include "axiometry/standards/iso230_2/plan/plan.h"

namespace axiometry::app {
namespace {

/// The format that writes files of this extension; "-" is JSON.
Result<const formats::Format*> format_by_extension(std::string_view name) {
  const std::string extension =
      name == "-" ? ".json" : text::to_lower(std::filesystem::path(name).extension().string());
  std::vector<std::string_view> known;
  for (const formats::Format* format : formats::format_table()) {
    if (format->write == nullptr) continue;
    for (const std::string_view own : text::words(format->extensions)) {
      if (own == extension) return format;
      if (std::ranges::find(known, own) == known.end()) known.push_back(own);
    }
  }
  return fail(fmt::format("found the test's name {}, expected a file ending in {}", text::quoted(name),
                          fmt::join(known, ", ")));
}

Plan standard_plan() {
  iso230_2::PlanRequest request;
  request.axis.name = "X";
  request.axis.travel_begin = Position::native(0.0);
  request.axis.travel_end = Position::native(500.0);
  request.axis.expected_period = Position::native(10.0);
  request.axis.scale_type = "Ball screw and rotary encoder, pitch 10 mm (simulated)";
  request.machine = virtual_machine;
  request.count = 11;
  request.feed = 3000.0;
  request.seed = 1;
  return *iso230_2::make_plan(request);
}

}  // namespace

Result<Plan> simulation_plan(const std::string& file) {
  if (file.empty()) return standard_plan();
  AXIOMETRY_TRY(Plan plan, read_plan_file(file));
  AXIOMETRY_TRY_VOID(in_file(check_measures_positions(plan), file));
  return plan;
}

Result<std::vector<simulation::PitchError::Node>> read_pitch_table(const std::string& file) {
  AXIOMETRY_TRY(const std::string text, whole_file(file));
  return in_file(parse_pitch_table(text), file);
}

Result<void> check_simulation_outputs(const SimulationOutputs& outputs) {
  if (!outputs.test.empty()) {
    AXIOMETRY_TRY([[maybe_unused]] const auto format, format_by_extension(outputs.test));
  }
  if (!outputs.raw.empty()) {
    AXIOMETRY_TRY([[maybe_unused]] const auto layout, raw_layout_of(outputs.raw));
  }
  std::vector<InputFile> read;
  for (const std::string& name : {outputs.plan, outputs.pitch_table})
    if (!name.empty()) read.push_back({name});
  const InputFiles inputs(read);
  const std::string* names[] = {&outputs.test, &outputs.raw, &outputs.truth};
  for (const std::string* name : names) {
    if (name->empty()) continue;
    if (std::ranges::count_if(names, [&](const std::string* other) { return *other == *name; }) > 1)
      return fail(fmt::format("found the output {} twice, expected different names", text::quoted(*name)));
    AXIOMETRY_TRY_VOID(inputs.check_spared(*name));
  }
  return {};
}

Result<SimulationSummary> run_simulation(const SimulationRequest& request, const SimulationOutputs& outputs) {
  AXIOMETRY_TRY_VOID(check_simulation_outputs(outputs));
  AXIOMETRY_TRY(const simulation::SimulatedTest simulated, simulation::simulate(request.simulate));
  SimulationSummary summary{.readings = simulated.test.series.reading_count(),
                            .targets = simulated.test.series.target_count(),
                            .samples = 0,
                            .duration = simulated.readings.back().time,
                            .true_parameters = true_parameters_of_test(simulated)};
  std::optional<RawRecording> raw;
  std::optional<simulation::TrueRecording> recorded;
  if (!outputs.raw.empty()) {
    AXIOMETRY_TRY(summary.samples, simulation::count_samples(request.simulate, request.recording));
    const RawSetting setting{request.simulate.plan.axis.kind, summary.samples, request.recording.rate,
                             request.wavelength};
    AXIOMETRY_TRY(raw, RawRecording::create(outputs.raw, setting));
    AXIOMETRY_TRY(recorded, simulation::record(request.simulate, request.recording,
                                               [&](std::span<const Sample> some) { return raw->write(some); }));
    summary.duration = recorded->duration;
  }
  std::optional<OutputFile> test, truth;
  if (!outputs.test.empty()) {
    AXIOMETRY_TRY(const formats::Format* format, format_by_extension(outputs.test));
    AXIOMETRY_TRY(test, OutputFile::create(outputs.test));
    AXIOMETRY_TRY_VOID(test->write(format->write(simulated.test)));
  }
  if (!outputs.truth.empty()) {
    AXIOMETRY_TRY(truth, OutputFile::create(outputs.truth));
    AXIOMETRY_TRY_VOID(truth->write(json::dump(truth_value(request, simulated, recorded)) + "\n"));
  }
  if (raw) AXIOMETRY_TRY_VOID(raw->commit());
  if (test) AXIOMETRY_TRY_VOID(test->commit());
  if (truth) AXIOMETRY_TRY_VOID(truth->commit());
  return summary;
}

}  // namespace axiometry::app
