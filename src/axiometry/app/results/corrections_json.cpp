// SPDX-License-Identifier: Apache-2.0
#include "axiometry/app/results/corrections_json.h"

#include "axiometry/app/results/told_results.h"
#include "axiometry/app/results/uncertainty_json.h"
#include "axiometry/standards/readings/drift.h"

namespace axiometry::app {
namespace {

using json::Value;

Value part_to_json(const AppliedExpansionCorrection::Part& part) {
  Value object = Value::object();
  object.add("expansion_um_per_m_C", part.expansion.in_um_per_m_K());
  object.add("start_C", part.start.in_celsius());
  object.add("end_C", part.end.in_celsius());
  object.add("sensors", part.sensors);
  return object;
}

Value expansion_to_json(const AppliedExpansionCorrection& correction) {
  Value object = Value::object();
  object.add("machine", part_to_json(correction.machine));
  object.add("equipment", correction.equipment ? part_to_json(*correction.equipment) : Value());
  object.add("datum_mm", correction.datum.in_native());
  object.add("smallest_um", correction.smallest.in_native());
  object.add("largest_um", correction.largest.in_native());
  return object;
}

Value correction_to_json(const AppliedCorrection& correction) {
  Value object = Value::object();
  object.add("id", correction.id);
  object.add("title", correction.title);
  object.add("smallest", correction.smallest.in_native());
  object.add("largest", correction.largest.in_native());
  Value& details = object.add("details", Value::array());
  for (const auto& detail : correction.details) {
    Value& row = details.push(Value::object());
    row.add("name", detail.name);
    row.add("value", detail.value);
  }
  return object;
}

void put_corrected_readings(json::Place place, const Series& evaluated, const Series& measured) {
  json::List list(place);
  for (std::size_t i = 0; i < evaluated.target_count(); ++i)
    for (Direction direction : {Direction::up, Direction::down})
      for (std::size_t j = 0; j < evaluated.run_count(); ++j) {
        const auto reading = evaluated.reading(i, direction, j);
        if (!reading) continue;
        json::Object row = list.object();
        row.add("target", evaluated.targets()[i].in_native());
        row.add("direction", direction == Direction::up ? "up" : "down");
        row.add("run", j + 1);
        row.add("deviation", reading->in_native());
        row.add("as_measured", native_number(measured.reading(i, direction, j)));
      }
}

}  // namespace

void add_corrections(json::Object& object, const Test& test) {
  const Provenance& provenance = test.provenance;
  if (!provenance.corrections.empty()) {
    json::List list = object.list("corrections");
    for (const AppliedCorrection& correction : provenance.corrections) list.push(correction_to_json(correction));
  }
  if (provenance.expansion_correction)
    object.add("expansion_correction", expansion_to_json(*provenance.expansion_correction));
  if (test.as_measured) put_corrected_readings(object.at("readings"), test.series, *test.as_measured);
}

void put_drift(json::Place place, const Test& test) {
  const auto drift = drift_of(test);
  if (!drift) return place.put(std::nullopt);
  const bool timed = drift->course.duration.has_value();
  const auto rate = [&](Deviation d) { return timed ? *drift->per_hour(d) : drift->per_reading(d); };
  json::Object object(place);
  object.add(timed ? "per_hour" : "per_reading", rate(drift->over_test));
  object.add("standard_uncertainty", drift->u ? std::optional(rate(*drift->u)) : std::nullopt);
  object.add("over_test", drift->over_test.in_native());
  object.add("degrees_of_freedom", drift->degrees_of_freedom);
  object.add("basis", drift->course.basis);
}

}  // namespace axiometry::app
