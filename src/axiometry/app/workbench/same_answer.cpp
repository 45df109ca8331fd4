// SPDX-License-Identifier: Apache-2.0
#include "axiometry/app/workbench/same_answer.h"

#include <algorithm>

namespace axiometry::app {
namespace {

// Every member is named, so that one more does not compile before it is compared.
bool same(const store::Limit& a, const store::Limit& b) {
  const auto& [parameter, value] = a;
  return parameter == b.parameter && value == b.value;
}

bool same(const AxisLimits& a, const AxisLimits& b) {
  const auto& [axis, version, limits, set_on] = a;
  return axis == b.axis && version == b.version && set_on == b.set_on &&
         std::ranges::equal(limits, b.limits, [](const auto& x, const auto& y) { return same(x, y); });
}

bool same(const InstrumentInputs& a, const InstrumentInputs& b) {
  const auto& [instrument, version, name, inputs, left_out] = a;
  return instrument == b.instrument && version == b.version && name == b.name && inputs == b.inputs &&
         left_out == b.left_out;
}

bool same(const KnownCalibration& a, const KnownCalibration& b) {
  const auto& [instrument, version, calibration] = a;
  const auto& [component, certificate, calibrated_on, calibration_due] = calibration;
  return instrument == b.instrument && version == b.version && component == b.calibration.component &&
         certificate == b.calibration.certificate && calibrated_on == b.calibration.calibrated_on &&
         calibration_due == b.calibration.calibration_due;
}

}  // namespace

bool same(const FromArchive& a, const FromArchive& b) {
  const auto& [instruments, calibrations, axis] = a;
  const auto alike = [](const auto& x, const auto& y) { return same(x, y); };
  return std::ranges::equal(instruments, b.instruments, alike) &&
         std::ranges::equal(calibrations, b.calibrations, alike) && axis.has_value() == b.axis.has_value() &&
         (!axis || same(*axis, *b.axis));
}

}  // namespace axiometry::app
