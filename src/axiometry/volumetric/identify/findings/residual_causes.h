// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "axiometry/volumetric/identify/identifier.h"

/// What makes residuals larger than was stated, where they show it. Internal to identify().
namespace axiometry::volumetric::detail {

/// Of residuals that are too large by more than chance, that one cause which takes most of what χ² has too much:
/// - another order of the axes in the chain fits (on which side of the foundation an axis is makes no difference to
///   lengths, but to straightness alone);
/// - the errors differ by the direction in which axes came to rest, and were taken not to, where readings are not in
///   rows (is_in_rows());
/// - axes are longer, shorter or less square in some stretches of readings than in others.
/// Only where no finding yet tells what else is wrong with the set-up. The fits that this takes are of 20 000 readings
/// at most, and without what may be known of the curves beside the lengths.
void add_residual_causes(const Identifier& done, const MachineModel& machine, const VolumetricLengths& lengths,
                         bool in_rows, std::vector<VolumetricFinding>& findings);

}  // namespace axiometry::volumetric::detail
