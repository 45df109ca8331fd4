// SPDX-License-Identifier: Apache-2.0
//
// Deviations from the source: the standard asks for the correction and leaves its form open.
#include "axiometry/standards/nde_correction.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "axiometry/base/text.h"
#include "axiometry/standards/iso230_2_artefact.h"

namespace axiometry {
namespace {

using Part = AppliedExpansionCorrection::Part;

constexpr double reference_temperature = 20.0;
constexpr double um_per_mm = 1000.0;
constexpr double per_um_per_m = 1e-6;

/// The mean of the sensors of a role at the start and the end; nothing without one that was read.
std::optional<Part> mean_of_sensors(const Environment& environment, std::string_view role) {
  double start = 0.0;
  double end = 0.0;
  std::size_t count = 0;
  for (const TemperatureSensor& sensor : environment.sensors) {
    if (!text::equal_ignoring_case(sensor.role, role) || !(sensor.start || sensor.end)) continue;
    start += (sensor.start ? *sensor.start : *sensor.end).in_celsius();
    end += (sensor.end ? *sensor.end : *sensor.start).in_celsius();
    ++count;
  }
  if (count == 0) return std::nullopt;
  const double n = static_cast<double>(count);
  return Part{{}, Temperature::celsius(start / n), Temperature::celsius(end / n), count};
}

Result<Part> machine_part(const Metadata& metadata) {
  auto part = mean_of_sensors(metadata.environment, "machine");
  if (!part)
    return fail(
        "found no temperature of the machine to correct expansion with, expected a sensor with role machine "
        "('sensors')");
  const auto& coefficient =
      metadata.nde.machine_expansion ? metadata.nde.machine_expansion : metadata.axis.scale_expansion;
  if (!coefficient)
    return fail(
        "found no expansion coefficient of the machine to correct with, expected nde.machine_expansion_um_per_m_C or "
        "axis.scale_expansion_um_per_m_C");
  part->expansion = *coefficient;
  return *part;
}

Result<std::optional<Part>> equipment_part(const Metadata& metadata) {
  auto part = mean_of_sensors(metadata.environment, "equipment");
  const auto& coefficient = metadata.nde.equipment_expansion;
  const bool expands = coefficient && coefficient->in_um_per_m_K() != 0.0;
  if (expands && !part)
    return fail(
        "found no temperature of the measuring equipment, whose expansion coefficient is given, expected a sensor with "
        "role equipment ('sensors')");
  if (!coefficient && part)
    return fail(
        "found temperatures of the measuring equipment and no expansion coefficient, expected "
        "nde.equipment_expansion_um_per_m_C (0 for an interferometer that compensates itself)");
  if (!expands) return std::nullopt;
  part->expansion = *coefficient;
  return part;
}

/// α ΔT at a time from 0 (start) to 1 (end).
double strain(const Part& part, double time) {
  const double start = part.start.in_celsius();
  const double temperature = start + time * (part.end.in_celsius() - start);
  return part.expansion.in_um_per_m_K() * per_um_per_m * (temperature - reference_temperature);
}

/// When a reading was taken, as a share of the whole test.
class Clock {
 public:
  Clock(const Series& series, TestCycle cycle)
      : targets_(series.target_count()), runs_(series.run_count()), from_below_(series.has(Direction::up)) {
    directions_ = from_below_ && series.has(Direction::down) ? 2 : 1;
    target_by_target_ = cycle == TestCycle::step || cycle == TestCycle::pilgrim;
  }

  double time(std::size_t target, Direction direction, std::size_t run) const {
    const std::size_t way = direction == Direction::down && from_below_ ? 1 : 0;
    std::size_t place = (target * runs_ + run) * directions_ + way;
    if (!target_by_target_) {
      const std::size_t along = direction == Direction::up ? target : targets_ - 1 - target;
      place = (run * directions_ + way) * targets_ + along;
    }
    const std::size_t last = targets_ * runs_ * directions_ - 1;
    return static_cast<double>(place) / static_cast<double>(last);  // m ≥ 2, so last ≥ 1
  }

 private:
  std::size_t targets_;
  std::size_t runs_;
  bool from_below_;
  std::size_t directions_ = 1;
  bool target_by_target_ = false;
};

/// What is added to a reading x at a target, µm.
double correction_um(const AppliedExpansionCorrection& record, double target_mm, double x_um, double time) {
  const double machine = strain(record.machine, time);
  const double equipment = record.equipment ? strain(*record.equipment, time) : 0.0;
  const double length_um = (target_mm - record.datum.in_native()) * um_per_mm + x_um;
  return length_um * (equipment - machine) / (1.0 + machine);
}

}  // namespace

Result<Test> correct_expansion(Test test) {
  Metadata& metadata = test.metadata;
  if (metadata.axis.kind == AxisKind::rotary)
    return fail("found a rotary axis, expected a linear one to correct for expansion");
  if (metadata.nde.applied == true)
    return fail("found nde.applied = yes, expected readings that are not yet corrected for expansion");
  AppliedExpansionCorrection record;
  AXIOMETRY_TRY(record.machine, machine_part(metadata));
  if (!iso230_2::is_artefact_test(test)) {  // whose expansion is part of its calibrated positions by now
    AXIOMETRY_TRY(record.equipment, equipment_part(metadata));
  }
  const Series& series = test.series;
  record.datum = metadata.nde.datum.value_or(series.targets().front());

  const Clock clock(series, metadata.conditions.cycle);
  std::vector<double> deviations;
  deviations.reserve(2 * series.target_count() * series.run_count());
  std::vector<double> added;
  for (Direction direction : {Direction::up, Direction::down})
    for (std::size_t i = 0; i < series.target_count(); ++i) {
      const double target_mm = series.targets()[i].in_native();
      const auto readings = series.cell(i, direction);
      for (std::size_t j = 0; j < readings.size(); ++j) {
        const double correction = correction_um(record, target_mm, readings[j], clock.time(i, direction, j));
        deviations.push_back(readings[j] + correction);
        if (!std::isnan(correction)) added.push_back(correction);
      }
    }
  record.smallest = Deviation::native(*std::ranges::min_element(added));
  record.largest = Deviation::native(*std::ranges::max_element(added));
  AXIOMETRY_TRY(Series result, Series::make_dense({series.targets().begin(), series.targets().end()},
                                                  series.run_count(), std::move(deviations)));
  if (!test.as_measured) test.as_measured = std::move(test.series);
  test.series = std::move(result);
  metadata.nde.applied = true;
  metadata.nde.machine_expansion = record.machine.expansion;
  metadata.nde.routine = "by this program from start and end temperatures (see Provenance)";
  test.provenance.expansion_correction = record;
  return test;
}

}  // namespace axiometry
