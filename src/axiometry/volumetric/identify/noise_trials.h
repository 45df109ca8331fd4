// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "axiometry/base/result.h"
#include "axiometry/volumetric/identify/identification.h"

/// What the noise of lengths does to the errors, by trials: a second way to their uncertainties.
namespace axiometry::volumetric {

struct NoiseTrials {
  std::size_t trials = 0;
  std::vector<double> sd;  ///< standard deviation of each raw coefficient over the trials, µm and µrad
};

/// Identifies once, with the sizes of `options` (all of them given), then draws the noise of all lengths anew, σ each,
/// and solves with the factors that are there: errors are so small that a new linearisation would change a trial by
/// 1e-4 of itself. The same seed gives the same trials. Fails as identify() does.
Result<NoiseTrials> noise_trials(const MachineModel& machine, const VolumetricLengths& lengths,
                                 const IdentifyOptions& options, std::size_t trials, std::uint64_t seed);

}  // namespace axiometry::volumetric
