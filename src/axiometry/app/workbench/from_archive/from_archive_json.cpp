// SPDX-License-Identifier: Apache-2.0
#include <algorithm>

#include "axiometry/app/files/given_text.h"
#include "axiometry/app/workbench/from_archive/from_archive.h"
#include "axiometry/base/text/text.h"
#include "axiometry/formats/text/json_members.h"

namespace axiometry::app {
namespace {

using formats::JsonMembers;
using json::Value;

Result<InstrumentInputs> inputs_from(const Value& value) {
  AXIOMETRY_TRY(JsonMembers members, JsonMembers::of(value, "instrument"));
  InstrumentInputs inputs;
  AXIOMETRY_TRY(const Value* id, members.required("instrument"));
  AXIOMETRY_TRY(inputs.instrument, given_number("instrument", *id));
  AXIOMETRY_TRY(const Value* version, members.required("version"));
  AXIOMETRY_TRY(inputs.version, given_version("version", *version));
  AXIOMETRY_TRY_VOID(members.take("name", inputs.name));
  AXIOMETRY_TRY(const Value* texts, members.required("inputs"));
  AXIOMETRY_TRY(inputs.inputs, changes_from(*texts));
  if (const Value* left_out = members.optional("left_out")) {  // versions of before have none
    AXIOMETRY_TRY(inputs.left_out, changes_from(*left_out));
  }
  AXIOMETRY_TRY_VOID(members.finish());
  return inputs;
}

Result<KnownCalibration> calibration_from(const Value& value) {
  AXIOMETRY_TRY(JsonMembers members, JsonMembers::of(value, "calibration"));
  KnownCalibration known;
  AXIOMETRY_TRY(const Value* component, members.required("component"));
  AXIOMETRY_TRY(const store::Id number, given_number("component", *component));
  known.calibration.component = static_cast<std::size_t>(number - 1);
  AXIOMETRY_TRY(const Value* id, members.required("instrument"));
  AXIOMETRY_TRY(known.instrument, given_number("instrument", *id));
  AXIOMETRY_TRY(const Value* version, members.required("version"));
  AXIOMETRY_TRY(known.version, given_version("version", *version));
  AXIOMETRY_TRY_VOID(members.take("certificate", known.calibration.certificate));
  AXIOMETRY_TRY_VOID(members.take("calibrated_on", known.calibration.calibrated_on));
  AXIOMETRY_TRY_VOID(members.take("calibration_due", known.calibration.calibration_due));
  AXIOMETRY_TRY_VOID(members.finish());
  return known;
}

Result<AxisLimits> axis_limits_from(const Value& value) {
  AXIOMETRY_TRY(JsonMembers members, JsonMembers::of(value, "axis"));
  AxisLimits axis;
  AXIOMETRY_TRY(const Value* id, members.required("axis"));
  AXIOMETRY_TRY(axis.axis, given_number("axis", *id));
  AXIOMETRY_TRY(const Value* version, members.required("version"));
  AXIOMETRY_TRY(axis.version, given_version("version", *version));
  AXIOMETRY_TRY(const Value* limits, members.required("limits"));
  AXIOMETRY_TRY(axis.limits, limits_from(*limits));
  AXIOMETRY_TRY_VOID(members.take("set_on", axis.set_on));
  AXIOMETRY_TRY_VOID(members.finish());
  return axis;
}

}  // namespace

json::Value limits_to_json(const std::vector<store::Limit>& limits) {
  Value list = Value::array();
  for (const store::Limit& limit : limits) {
    Value& row = list.push(Value::object());
    row.add("parameter", limit.parameter);
    row.add("value", limit.value);
  }
  return list;
}

Result<std::vector<store::Limit>> limits_from(const json::Value& value) {
  AXIOMETRY_TRY(const auto* items, formats::items_in(value, "limits"));
  std::vector<store::Limit> limits;
  for (const Value& item : *items) {
    AXIOMETRY_TRY(JsonMembers members, JsonMembers::of(item, "limit"));
    store::Limit limit;
    AXIOMETRY_TRY(const Value* key, members.required("parameter"));
    AXIOMETRY_TRY(limit.parameter, formats::text_in(*key, "parameter"));
    const auto* parameter = iso230_2::find_parameter(limit.parameter);
    if (parameter == nullptr)
      return fail("found the parameter " + text::quoted(limit.parameter) + ", expected one such as A, R_up or B",
                  key->at());
    limit.parameter = parameter->key;
    if (std::ranges::find(limits, limit.parameter, &store::Limit::parameter) != limits.end())
      return fail("found two limits of " + limit.parameter + ", expected one", item.at());
    AXIOMETRY_TRY(const Value* number, members.required("value"));
    AXIOMETRY_TRY(limit.value, formats::number_in(*number, "value"));
    constexpr double largest = 1e6;  // a metre
    if (!(limit.value > 0.0 && limit.value <= largest))
      return fail("found a limit of " + limit.parameter + " that is not above 0 and at most 1000000", number->at());
    AXIOMETRY_TRY_VOID(members.finish());
    limits.push_back(std::move(limit));
  }
  return limits;
}

json::Value to_json(const FromArchive& taken) {
  Value object = Value::object();
  Value& instruments = object.add("instruments", Value::array());
  for (const InstrumentInputs& inputs : taken.instruments) {
    Value& row = instruments.push(Value::object());
    row.add("instrument", static_cast<double>(inputs.instrument));
    row.add("version", inputs.version);
    row.add("name", inputs.name);
    row.add("inputs", to_json(inputs.inputs));
    if (!inputs.left_out.empty()) row.add("left_out", to_json(inputs.left_out));
  }
  Value& calibrations = object.add("calibrations", Value::array());
  for (const KnownCalibration& known : taken.calibrations) {
    Value& row = calibrations.push(Value::object());
    row.add("component", static_cast<double>(known.calibration.component + 1));
    row.add("instrument", static_cast<double>(known.instrument));
    row.add("version", known.version);
    row.add("certificate", known.calibration.certificate);
    row.add("calibrated_on", known.calibration.calibrated_on);
    row.add("calibration_due", known.calibration.calibration_due);
  }
  Value& axis = object.add("axis", Value());
  if (!taken.axis) return object;
  axis = Value::object();
  axis.add("axis", static_cast<double>(taken.axis->axis));
  axis.add("version", taken.axis->version);
  axis.add("limits", limits_to_json(taken.axis->limits));
  if (!taken.axis->set_on.empty()) axis.add("set_on", taken.axis->set_on);
  return object;
}

Result<FromArchive> from_archive_of(const json::Value& value) {
  AXIOMETRY_TRY(JsonMembers members, JsonMembers::of(value, "from_archive"));
  FromArchive taken;
  AXIOMETRY_TRY(const Value* instruments, members.required("instruments"));
  AXIOMETRY_TRY(const auto* items, formats::items_in(*instruments, "instruments"));
  for (const Value& item : *items) {
    AXIOMETRY_TRY(InstrumentInputs inputs, inputs_from(item));
    taken.instruments.push_back(std::move(inputs));
  }
  if (const Value* calibrations = members.optional("calibrations")) {  // versions of before have none
    AXIOMETRY_TRY(const auto* rows, formats::items_in(*calibrations, "calibrations"));
    for (const Value& row : *rows) {
      AXIOMETRY_TRY(KnownCalibration known, calibration_from(row));
      taken.calibrations.push_back(std::move(known));
    }
  }
  if (const Value* axis = members.optional("axis")) {
    AXIOMETRY_TRY(taken.axis, axis_limits_from(*axis));
  }
  AXIOMETRY_TRY_VOID(members.finish());
  return taken;
}

}  // namespace axiometry::app
