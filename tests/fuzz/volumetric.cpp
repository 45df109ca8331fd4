// SPDX-License-Identifier: Apache-2.0
//
// Any bytes as each table and document of a volumetric calibration, and a plan's ways as a recording is held against.
#include "axiometry/app/volumetric/part_stops.h"
#include "axiometry/formats/volumetric/machine_json.h"
#include "axiometry/formats/volumetric/true_errors_json.h"
#include "axiometry/formats/volumetric/volumetric_lengths_csv.h"
#include "axiometry/formats/volumetric/volumetric_plan_json.h"
#include "axiometry/formats/volumetric/volumetric_result_json.h"
#include "described.h"

using namespace axiometry;

namespace {

template <typename T>
bool is_sound(const Result<T>& read) {
  if (!read) fuzzing::check_error(read.error());
  return read.has_value();
}

/// Every part has as many stops to be heard as points.
void walk(const volumetric::CalibrationPlan& plan) {
  for (std::size_t part = 1; part <= plan.runs.size(); ++part) {
    if (!app::check_parts(plan, {part, part})) continue;
    const app::PartStops stops = app::part_stops(plan, {part, part});
    AXIOMETRY_CONTRACT(stops.places.size() == plan.runs[part - 1].stops.size());
    AXIOMETRY_CONTRACT(stops.list.stops.size() == stops.places.size());
  }
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string_view bytes = fuzzing::as_text(data, size);
  if (const auto plan = formats::read_volumetric_plan(bytes); is_sound(plan)) {
    const std::string written = formats::write_volumetric_plan(*plan);
    const auto again = formats::read_volumetric_plan(written);
    AXIOMETRY_CONTRACT(again && formats::write_volumetric_plan(*again) == written);
    walk(*plan);
  }
  static const volumetric::MachineModel erring = {.chain = *volumetric::KinematicChain::make("XFYZ"),
                                                  .travel = {{0.0, 0.0, -500.0}, {1000.0, 600.0, 0.0}}};
  is_sound(formats::read_true_errors(bytes, erring));
  if (const auto machine = formats::read_machine(bytes); is_sound(machine)) {
    const std::string written = json::dump(formats::machine_value(machine->machine));
    const auto again = formats::read_machine(written);
    AXIOMETRY_CONTRACT(again && json::dump(formats::machine_value(again->machine)) == written);
  }
  if (const auto lengths = formats::read_volumetric_lengths(bytes); is_sound(lengths)) {
    const auto again = formats::read_volumetric_lengths(formats::write_volumetric_lengths(*lengths));
    AXIOMETRY_CONTRACT(again && again->readings.size() == lengths->readings.size());
  }
  static_cast<void>(formats::is_volumetric_recording(bytes));
  is_sound(formats::read_volume_points(bytes));
  is_sound(formats::read_error_model(bytes));
  return 0;
}
