// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "axiometry/base/result.h"
#include "axiometry/model/test.h"

/// Correction of readings for nominal differential expansion (NDE): ISO 230-2:2014, 4.1 and 5.3.1. Derivation:
/// docs/theory/uncertainty.md.
namespace axiometry {

/// The test with its readings brought to 20 °C. A reading at the distance l from the instrument's datum becomes
///
///     l · (1 + α_e ΔT_e)/(1 + α_m ΔT_m)
///
/// with the coefficient and temperature (less 20 °C) of the machine (m) and of the measuring equipment (e): the
/// machine's part was longer than at 20 °C, and so was the scale that read it.
///
/// - Coefficients: `nde.machine_expansion`, else that of the scale; `nde.equipment_expansion`. An interferometer has
///   none (0 or not given): its own compensation is not touched. Nor has an artefact whose calibrated positions were
///   brought to its temperature (artefact.h).
/// - Temperatures: the mean of the sensors with role `machine` (`equipment`), interpolated from start to end over
///   the course of the test (test_course.h). A sensor read only once counts as constant.
/// - Datum: `nde.datum`, else the first target.
///
/// In the result `as_measured` has the readings as they were, provenance what was done, and the metadata say that the
/// correction was applied, with the coefficients used.
///
/// Fails, naming what was found and is missing, on a rotary axis, where the metadata say that the correction was
/// applied already, without a coefficient or temperature of the machine, where the equipment has a coefficient other
/// than 0 and no temperature, or sensors and no coefficient.
Result<Test> correct_expansion(Test test);

}  // namespace axiometry
