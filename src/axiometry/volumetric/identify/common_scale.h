// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>
#include <vector>

#include "axiometry/volumetric/identify/equations/linear_solution.h"

/// An error that all lengths have in common, as of the wavelength in air. Internal to volumetric/.
namespace axiometry::volumetric::detail {

/// Adds u² c cᵀ to the covariance of raw coefficients, c what 1 µm/m of all lengths does to them and u the machine's
/// scale_uncertainty; nothing where none is stated.
void add_common_scale(const Problem& problem, const State& state, std::span<const Vector3> beams,
                      const LinearSolution& solution, std::vector<double>& covariance);

}  // namespace axiometry::volumetric::detail
