// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string_view>
#include <vector>

#include "axiometry/base/result.h"
#include "axiometry/model/test.h"
#include "axiometry/standards/iso230_2/finding.h"

/// A ball array or step gauge in place of the laser interferometer (ISO 230-2:2014, Annex D). The text of the annex was
/// not at hand: what is done follows general knowledge; derivation and sign: docs/theory/artefact.md.
namespace axiometry::iso230_2 {

/// The test with its readings turned from indicated positions to deviations.
///
/// The machine probes the balls or faces of the artefact and says where they are: a reading P_i + x_ij is the position
/// that its scale indicates when the functional point truly stands at the calibrated place. So at the indicated
/// position the axis is off by what it does not indicate, and the deviation (actual less target, 3.6) is
///
///     x'_ij = (C_i − C_1)(1 + α_D ΔT_D) − (P_i − P_1) − x_ij
///
/// with the calibrated positions C at 20 °C. The sign is turned: an axis that travels too far (deviation above 0)
/// indicates too little. C_1 and P_1 are the datum; where the machine's zero is not at the first position all
/// deviations have the same offset, as they have with an interferometer that was set to zero elsewhere, and no
/// parameter but the mean deviations knows of it. The deviation belongs to the indicated position; it stands at the
/// target, which is right to the change of the deviation between them (1 µm for 10 mm at 100 µm/m).
///
/// Expansion: α_D is `nde.equipment_expansion`, else `uncertainty.device_expansion`; ΔT_D the mean of the sensors with
/// role `equipment` less 20 °C, interpolated from start to end over the course of the test. Without a coefficient and
/// sensors the artefact counts as at 20 °C, and a finding says so. Where the readings are already corrected for
/// differential expansion (`nde.applied` = yes) it is not expanded. What the machine expands stays in the deviations,
/// as with an interferometer; correct_expansion() takes it out, without touching the artefact's part again.
///
/// In the result `as_measured` has the readings as they were, and provenance a correction with the id "artefact".
///
/// Fails, naming numbers, on a rotary axis, without calibrated positions, with another number of them than targets,
/// when they do not ascend, when one is off its target by more than a tenth of the smaller interval beside it (both
/// taken from the first), on sensors of the equipment without a coefficient, and when it was done already.
Result<Test> apply_artefact(Test test);

/// The id of the correction in the provenance.
inline constexpr std::string_view artefact_correction = "artefact";

/// Whether apply_artefact() made this test's deviations.
bool is_artefact_test(const Test& test);

/// Whether what is known about an artefact takes the place of the measuring device in the uncertainty.
bool artefact_takes_place_of_device(const Metadata& metadata);

/// What a test with an artefact must say beside what every test must: probing from both sides, an artefact shorter than
/// the axis, its equal steps and the period of the scale, a temperature that is not known, calibrated positions that
/// were not used. Notes and missing items; the number of positions and directions is judged by clause 5.3.
std::vector<Finding> artefact_findings(const Test& test);

}  // namespace axiometry::iso230_2
