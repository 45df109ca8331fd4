// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "axiometry/volumetric/identify/identifier.h"

/// Lengths of two days, or temperatures, within the same stretches. Internal to identify().
namespace axiometry::volumetric::detail {

/// Axes that are longer, shorter or less square in the later lengths of each station, tool and segment than in the
/// earlier ones, beyond any place and dead path of their own of both parts. They are parted where they are taken up
/// again after those of others, or else in their middle. Nothing is told of lengths of two days in any order: these
/// scatter. For readings that are not in rows.
void add_mixed_days(const Identifier& done, std::vector<VolumetricFinding>& findings);

}  // namespace axiometry::volumetric::detail
