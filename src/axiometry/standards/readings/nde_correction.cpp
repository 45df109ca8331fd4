// SPDX-License-Identifier: Apache-2.0
//
// Deviations from the source: the standard asks for the correction and leaves its form open.
#include "axiometry/standards/readings/nde_correction.h"

#include <fmt/format.h>

#include <string>
#include <utility>

#include "axiometry/base/text/number_text.h"
#include "axiometry/standards/readings/artefact.h"
#include "axiometry/standards/readings/reading_change.h"
#include "axiometry/standards/readings/sensor_mean.h"
#include "axiometry/standards/readings/test_course.h"
#include "axiometry/standards/readings/usual_expansion.h"

namespace axiometry {
namespace {

using Part = AppliedExpansionCorrection::Part;

Part part_of(const SensorMean& mean, ExpansionCoefficient expansion) {
  return {expansion, mean.start, mean.end, mean.sensors};
}

Result<Part> machine_part(const Metadata& metadata) {
  const auto mean = mean_of_sensors(metadata.environment, "machine");
  if (!mean)
    return fail(
        "found no temperature of the machine to correct expansion with, expected a sensor with role machine "
        "('sensors')");
  const auto& coefficient =
      metadata.nde.machine_expansion ? metadata.nde.machine_expansion : metadata.axis.scale_expansion;
  if (!coefficient)
    return fail(
        "found no expansion coefficient of the machine to correct with, expected nde.machine_expansion_um_per_m_C or "
        "axis.scale_expansion_um_per_m_C");
  return part_of(*mean, *coefficient);
}

Result<std::optional<Part>> equipment_part(const Metadata& metadata) {
  const auto mean = mean_of_sensors(metadata.environment, "equipment");
  const auto& coefficient = metadata.nde.equipment_expansion;
  const bool expands = coefficient && coefficient->in_um_per_m_K() != 0.0;
  if (expands && !mean)
    return fail(
        "found no temperature of the measuring equipment, whose expansion coefficient is given, expected a sensor with "
        "role equipment ('sensors')");
  if (!coefficient && mean)
    return fail(
        "found temperatures of the measuring equipment and no expansion coefficient, expected "
        "nde.equipment_expansion_um_per_m_C (0 for an interferometer that compensates itself)");
  if (!expands) return std::nullopt;
  return part_of(*mean, *coefficient);
}

/// α ΔT at a time from 0 (start) to 1 (end).
double strain(const Part& part, double time) {
  const double start = part.start.in_celsius();
  const double temperature = start + time * (part.end.in_celsius() - start);
  return part.expansion.in_um_per_m_K() * iso230_2::strain_per_um_per_m *
         (temperature - iso230_2::reference_temperature);
}

/// What is added to a reading at a displayed length from the datum, µm.
double correction_um(const AppliedExpansionCorrection& record, double length_um, double time) {
  const double machine = strain(record.machine, time);
  const double equipment = record.equipment ? strain(*record.equipment, time) : 0.0;
  return length_um * (equipment - machine) / (1.0 + machine);
}

AppliedCorrection::Detail detail_of(std::string name, const Part& part) {
  return {std::move(name),
          fmt::format("{} µm/(m·°C), {:.2f} °C at the start, {:.2f} °C at the end{}",
                      format_exact(part.expansion.in_um_per_m_K()), part.start.in_celsius(), part.end.in_celsius(),
                      part.sensors > 1 ? fmt::format(" (mean of {} sensors)", part.sensors) : "")};
}

AppliedCorrection listed(const AppliedExpansionCorrection& record, std::string course) {
  AppliedCorrection entry{"nde", "Nominal differential expansion", {}, record.smallest, record.largest};
  entry.details = {detail_of("Expansion of the machine", record.machine)};
  if (record.equipment) entry.details.push_back(detail_of("Expansion of the equipment", *record.equipment));
  entry.details.push_back({"Datum", format_exact(record.datum.in_native()) + " mm"});
  entry.details.push_back({"Course of the test", std::move(course)});
  return entry;
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
  if (!iso230_2::is_artefact_test(test)) {  // the expansion of an artefact is in its calibrated positions already
    AXIOMETRY_TRY(record.equipment, equipment_part(metadata));
  }
  record.datum = datum_of(test);
  std::string course = course_of(test).basis;
  AXIOMETRY_TRY(ChangedTest changed, change_readings(std::move(test), [&](const ReadingAt& reading) {
                  return correction_um(record, reading.length, reading.share);
                }));
  record.smallest = changed.smallest;
  record.largest = changed.largest;
  test = std::move(changed.test);
  metadata.nde.applied = true;
  metadata.nde.machine_expansion = record.machine.expansion;
  metadata.nde.routine = "by this program from start and end temperatures (see Provenance)";
  test.provenance.expansion_correction = record;
  test.provenance.corrections.push_back(listed(record, std::move(course)));
  return test;
}

}  // namespace axiometry
