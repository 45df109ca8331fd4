// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "axiometry/base/result.h"
#include "axiometry/volumetric/identify/equations/normal_equations.h"

/// Where the stations stand about, from the lengths to a machine without errors. Internal to identify().
namespace axiometry::volumetric::detail {

/// Every virtual station from its own lengths: eq. 14 of Lee et al. on its longest stretch, refined on all of them with
/// less weight for what does not fit (Huber); from many starts where eq. 14 has no unique solution. Of two places that
/// fit alike (all points on a plane) the one nearer to where the machine's file says that the station stands, or the
/// lower one. Errors, drifts are 0. Fails, naming station and tool, on fewer than 5 readings or points that tell no
/// place.
Result<State> start_state(const Problem& problem, const VolumetricLengths& names);

}  // namespace axiometry::volumetric::detail
