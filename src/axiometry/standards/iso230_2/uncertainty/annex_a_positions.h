// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <vector>

#include "axiometry/standards/iso230_2/inputs/resolved_inputs.h"
#include "axiometry/standards/iso230_2/uncertainty/annex_a.h"

/// The mean deviations of the targets by Annex A's contributors; private to annex_a(), whose header has the equations.
namespace axiometry::iso230_2 {

/// What the budget was made for.
struct MeasuredLength {
  double L_m = 0.0;
  AxisKind kind = AxisKind::linear;
  const ResolvedCalibration& calibration;  ///< calibration of the device, or of the artefact in its place
};

/// Of `annex` the budget and the datum are read.
std::vector<AnnexAPosition> annex_a_positions(const AnnexA& annex, const MeasuredLength& length,
                                              const Evaluation& evaluation);

/// n: the smallest number of approaches in any measured cell.
std::size_t smallest_count(const Series& series);

}  // namespace axiometry::iso230_2
