// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <span>
#include <vector>

#include "axiometry/volumetric/identify/findings/tried_fit.h"

/// What directions in which axes came to rest make of residuals, where less or none was asked for. For readings that
/// are not in rows: what is no noise tells no chance. Internal to identify().
namespace axiometry::volumetric::detail {

/// Of no reversal where constants of both directions take most of what χ² has too much.
std::optional<VolumetricFinding> reversal_that_explains(const Identifier& done, const VolumetricLengths& lengths,
                                                        std::span<const std::size_t> kept);

/// Of no reversal where constants of both directions fit better by more than chance, however large residuals are; of
/// constants where curves of both directions do: then the directions differ by more in some places than in others.
/// Where nothing of that is told yet.
void add_reversal_beyond_chance(const Identifier& done, const VolumetricLengths& lengths,
                                std::vector<VolumetricFinding>& findings);

}  // namespace axiometry::volumetric::detail
