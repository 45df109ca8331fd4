// SPDX-License-Identifier: Apache-2.0
#include "axiometry/app/workbench/examples/examples.h"

#include <fmt/format.h>

#include <array>
#include <string>
#include <string_view>
#include <vector>

#include "axiometry/app/workbench/examples/example_table2.h"
#include "axiometry/base/contract.h"
#include "axiometry/formats/format.h"
#include "axiometry/simulation/presets.h"
#include "axiometry/simulation/simulate.h"
#include "axiometry/standards/iso230_2/plan/plan.h"
#include "axiometry/store/own_names.h"

namespace axiometry::app {
namespace {

using Items = std::vector<std::pair<std::string, std::string>>;

/// A machine as its tests name it.
struct ExampleMachine {
  std::string_view name;
  std::string_view manufacturer;
  std::string_view type;
  std::string_view serial_number;
  std::string_view controller;
  std::string_view location;
};

constexpr ExampleMachine milling_machine{
    "Machining centre 7", "Virtual Machine Works", "Vertical machining centre", "VMW-0715",
    "LinuxCNC",           "Hall 2, bay 4"};
constexpr ExampleMachine grinder{"Surface grinder 3", "Virtual Machine Works", "Surface grinding machine",
                                 "VMW-0311",          "Siemens 840D",          "Hall 1, bay 9"};
constexpr ExampleMachine lathe{"Turning centre 12", "Virtual Machine Works", "Turning centre", "VMW-1204",
                               "Fanuc 0i",          "Hall 2, bay 1"};

/// One simulated test.
struct ExampleTest {
  const ExampleMachine& machine;
  std::string_view axis;
  AxisKind kind = AxisKind::linear;
  double travel = 500.0;  ///< mm or °, from 0
  std::string_view date;
  std::string_view number;   ///< of the report, and name of the file
  std::string_view purpose;  ///< "reverification"
  std::string_view comment;
  std::uint64_t seed = 1;
  simulation::VirtualAxis (*fault)(const Plan& plan);
  double backlash = -1.0;  ///< µm or ″ instead of the fault's own; below 0: as it is
};

simulation::VirtualAxis preset(const Plan& plan, std::string_view id) {
  const simulation::Preset* found = simulation::find_preset(id);
  AXIOMETRY_CONTRACT(found != nullptr);
  return found->make(plan);
}

simulation::VirtualAxis good(const Plan& plan) { return preset(plan, "good"); }
simulation::VirtualAxis worn(const Plan& plan) { return preset(plan, "backlash"); }
simulation::VirtualAxis warm(const Plan& plan) { return preset(plan, "thermal"); }
simulation::VirtualAxis bent(const Plan& plan) {
  simulation::VirtualAxis axis = preset(plan, "pitch");
  axis.backlash.size = Deviation::native(2.5);
  return axis;
}
simulation::VirtualAxis wormed(const Plan& plan) {
  simulation::VirtualAxis axis = preset(plan, "cyclic");
  axis.backlash.size = Deviation::native(4.0);
  return axis;
}

constexpr AxisKind linear = AxisKind::linear;
constexpr AxisKind rotary = AxisKind::rotary;
constexpr std::string_view yearly = "reverification";

/// A history of two years: play grows, faster towards the end, until the drive is mended.
const std::array history = {
    ExampleTest{milling_machine, "X", linear, 800.0, "2024-10-14", "MC7-X-2024-4", "acceptance", "", 21, worn, 1.2},
    ExampleTest{milling_machine, "X", linear, 800.0, "2025-01-20", "MC7-X-2025-1", yearly, "", 22, worn, 1.6},
    ExampleTest{milling_machine, "X", linear, 800.0, "2025-04-14", "MC7-X-2025-2", yearly, "", 23, worn, 2.1},
    ExampleTest{milling_machine, "X", linear, 800.0, "2025-07-21", "MC7-X-2025-3", yearly, "", 24, worn, 2.9},
    ExampleTest{milling_machine, "X", linear, 800.0, "2025-10-13", "MC7-X-2025-4", yearly, "", 25, worn, 3.6},
    ExampleTest{milling_machine, "X", linear, 800.0, "2026-01-19", "MC7-X-2026-1", yearly, "", 26, worn, 4.8},
    ExampleTest{milling_machine, "X", linear, 800.0, "2026-04-13", "MC7-X-2026-2", yearly, "", 27, worn, 6.4},
    ExampleTest{milling_machine, "X", linear, 800.0, "2026-04-27", "MC7-X-2026-3", "reverification after repair",
                "Nut of the ball screw preloaded anew, backlash compensation set", 28, worn, 0.8},
};

const std::array others = {
    ExampleTest{grinder, "Z", linear, 400.0, "2026-03-02", "SG3-Z-before", "before compensation", "", 31, bent},
    ExampleTest{grinder, "Z", linear, 400.0, "2026-03-03", "SG3-Z-after", "after compensation", "", 32, good},
    ExampleTest{grinder, "X", linear, 600.0, "2026-03-04", "SG3-X-warm-up", "investigation",
                "Without a warm-up: the ball screw grows while the test runs", 33, warm},
    ExampleTest{lathe, "C", rotary, 360.0, "2026-05-18", "TC12-C", yearly, "", 41, wormed},
    ExampleTest{lathe, "Z", linear, 500.0, "2026-05-19", "TC12-Z", yearly, "", 42, good},
};

store::MachineRecord machine_record(const ExampleMachine& machine) {
  return {.name = std::string(machine.name),
          .manufacturer = std::string(machine.manufacturer),
          .type = std::string(machine.type),
          .serial_number = std::string(machine.serial_number),
          .controller = std::string(machine.controller),
          .location = std::string(machine.location),
          .notes = "A simulated machine, to look at"};
}

struct ExampleCalibration {
  std::string_view certificate;
  std::string_view on;
  std::string_view due;
};
constexpr ExampleCalibration calibrations[] = {{"VI-2024-0108", "2024-01-11", "2025-01-11"},
                                               {"VI-2025-0127", "2025-01-09", "2026-01-09"},
                                               {"VI-2026-0113", "2026-01-13", "2027-01-13"}};

store::InstrumentRecord laser(const ExampleCalibration& calibration) {
  return {
      .role = "Laser interferometer",
      .manufacturer = "Virtual Instruments",
      .type = "VI-80",
      .serial_number = "80-1147",
      .certificate = std::string(calibration.certificate),
      .calibrated_on = std::string(calibration.on),
      .calibration_due = std::string(calibration.due),
      .inputs = {{"uncertainty.device_calibration_um_per_m", "0.4"}, {"uncertainty.device_expansion_um_per_m_C", "0"}},
      .notes = "A simulated instrument; its inputs go into every test that names it"};
}

Result<Plan> plan_of(const ExampleTest& test) {
  iso230_2::PlanRequest request;
  request.axis.name = test.axis;
  request.axis.kind = test.kind;
  request.axis.travel_begin = Position::native(0.0);
  request.axis.travel_end = Position::native(test.travel);
  const bool is_rotary = test.kind == AxisKind::rotary;
  request.axis.expected_period = Position::native(is_rotary ? 4.0 : 10.0);
  request.axis.scale_type = is_rotary ? "Worm gear, 90 teeth, and rotary encoder (simulated)"
                                      : "Ball screw and rotary encoder, pitch 10 mm (simulated)";
  request.axis.compensation = "none";
  request.axis.measurement_line = is_rotary ? "Axis of the spindle" : "200 mm above the middle of the table";
  request.machine = test.machine.name;
  request.date = test.date;
  if (is_rotary) request.count = 12;
  request.feed = is_rotary ? 720.0 : 3000.0;
  request.seed = 7;  // one machine, one test programme over the years
  return iso230_2::make_plan(request);
}

Items metadata_of(const ExampleTest& test) {
  const ExampleMachine& machine = test.machine;
  const store::InstrumentRecord instrument = laser(calibrations[0]);
  Items items = {
      {"test.report_number", std::string(test.number)},
      {"test.date", std::string(test.date)},
      {"test.inspector", "A. Sample"},
      {"test.purpose", std::string(test.purpose)},
      {"test.warm_up", "As in daily use, then one run over the whole travel"},
      {"test.axes_not_under_test", "In the middle of their travels"},
      {"test.tool_offset_mm", "0 0 0"},
      {"test.workpiece_offset_mm", "0 0 0"},
      {"machine.name", std::string(machine.name)},
      {"machine.type", std::string(machine.type)},
      {"machine.serial_number", std::string(machine.serial_number)},
      {"machine.location", std::string(machine.location)},
      {"equipment", ""},  // the simulator names itself there
      {"equipment", fmt::format("{} | {} | {} | {}", instrument.role, instrument.manufacturer, instrument.type,
                                instrument.serial_number)},
      {"environment.air_temperature_start_C", "20.2"},
      {"environment.air_temperature_end_C", "20.6"},
      {"uncertainty.environmental_variation", test.kind == AxisKind::rotary ? "0.6" : "0.5"},
  };
  if (test.kind == AxisKind::rotary) return items;
  const Items of_lengths = {
      {"sensors", "machine | scale, middle of the travel | 20.3 | 20.8"},
      {"sensors", "air | beside the beam | 20.2 | 20.6"},
      {"nde.applied", "yes"},
      {"nde.machine_expansion_um_per_m_C", "11.5"},
      {"nde.routine", "before every reading"},
      {"axis.scale_expansion_um_per_m_C", "11.5"},
      {"uncertainty.misalignment_mm", "1"},
      {"uncertainty.machine_expansion_um_per_m_C", "11.5"},
      {"uncertainty.machine_temperature_range_C", "0.3"},
      {"uncertainty.machine_temperature_difference_C", "0.4"},
      {"uncertainty.machine_expansion_range_um_per_m_C", "2"},
  };
  items.insert(items.end(), of_lengths.begin(), of_lengths.end());
  return items;
}

/// A file that somebody would send.
struct ExampleFile {
  std::string name;
  std::string bytes;
};

Result<std::string> file_of(const ExampleTest& test) {
  simulation::Request request;
  AXIOMETRY_TRY(request.plan, plan_of(test));
  request.axis = test.fault(request.plan);
  if (test.backlash >= 0.0) request.axis.backlash.size = Deviation::native(test.backlash);
  request.seed = test.seed;
  AXIOMETRY_TRY(simulation::SimulatedTest simulated, simulation::simulate(request));
  AXIOMETRY_TRY_VOID(set_metadata(simulated.test.metadata, metadata_of(test)));
  std::string& comment = simulated.test.metadata.conditions.comment;  // says that it is no measurement
  if (!test.comment.empty()) comment = fmt::format("{}. {}", test.comment, comment);
  const formats::Format* format = formats::find_format("json");
  AXIOMETRY_CONTRACT(format != nullptr && format->write != nullptr);
  return format->write(simulated.test);
}

/// In the order in which they come.
Result<std::vector<ExampleFile>> example_files() {
  std::vector<ExampleFile> files = {{"iso230-2-table2.json", std::string(example_table2)}};
  for (const std::span<const ExampleTest> tests :
       {std::span<const ExampleTest>(others), std::span<const ExampleTest>(history)})
    for (const ExampleTest& test : tests) {
      AXIOMETRY_TRY(std::string bytes, file_of(test));
      files.push_back({fmt::format("{}.json", test.number), std::move(bytes)});
    }
  return files;
}

bool is_empty(const store::Counts& counts) {
  return counts.machines + counts.instruments + counts.plans + counts.tests + counts.documents == 0;
}

/// The instrument of all tests, calibrated anew every year.
Result<void> add_laser(store::Transaction& archive, const store::By& by) {
  AXIOMETRY_TRY(auto kept, archive.add(laser(calibrations[0]), by));
  for (const ExampleCalibration& calibration : std::span(calibrations).subspan(1)) {
    const store::By sender{by.actor, fmt::format("calibrated on {}", calibration.on)};
    AXIOMETRY_TRY(kept, archive.change(kept.id, kept.version, laser(calibration), sender));
  }
  return {};
}

/// Machines with what no file says of them, an axis with its limits, and the instrument.
Result<void> add_example_equipment(store::Transaction& archive, const store::By& by) {
  AXIOMETRY_TRY_VOID(add_laser(archive, by));
  const auto add = [&](const ExampleMachine& machine, std::vector<store::AxisRecord> axes) -> Result<void> {
    AXIOMETRY_TRY(const auto added, archive.add(machine_record(machine), by));
    for (store::AxisRecord& axis : axes) {
      axis.machine = added.id;
      AXIOMETRY_TRY_VOID(archive.add(axis, by));
    }
    return {};
  };
  AXIOMETRY_TRY_VOID(add(milling_machine, {{0, "X", "linear", {{"A", 10.0}, {"R", 8.0}, {"B", 5.0}}, ""}}));
  AXIOMETRY_TRY_VOID(add(grinder, {{0, "Z", "linear", {{"A", 8.0}, {"E", 6.0}}, ""}}));
  return add(lathe, {{0, "C", "rotary", {{"A", 20.0}, {"B", 6.0}}, ""}});
}

}  // namespace

Result<std::size_t> add_examples(Workbench& workbench) {
  AXIOMETRY_TRY(const store::Counts counts, workbench.archive().counts());
  if (!is_empty(counts)) return std::size_t{0};
  AXIOMETRY_TRY(const auto files, example_files());
  const store::By by{std::string(store::example_loader), "loaded into an empty archive"};
  return workbench.archive().write([&](store::Transaction& archive) -> Result<std::size_t> {
    AXIOMETRY_TRY(const store::Counts meanwhile, archive.counts());
    if (!is_empty(meanwhile)) return std::size_t{0};
    AXIOMETRY_TRY_VOID(add_example_equipment(archive, by));
    for (const ExampleFile& file : files) {
      const Upload upload{file.name, file.bytes};
      AXIOMETRY_TRY_VOID(workbench.receive(archive, std::span(&upload, 1), by));
    }
    return files.size();
  });
}

}  // namespace axiometry::app
