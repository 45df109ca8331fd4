// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "axiometry/volumetric/identify/equations/normal_equations.h"

/// Σ w a aᵀ of the rows a of normal_equations.h. Internal to it.
namespace axiometry::volumetric::detail {

/// A sum of readings from `begin` to before `end`, in which each product stands once: those of coefficients right of
/// the diagonal, those of coefficients with squareness, stations and dead paths in the rows of these, where they are
/// next to each other. By rows.
std::vector<double> row_sums(const Problem& problem, std::span<const Vector3> beams, std::size_t begin,
                             std::size_t end);

/// Moves what stands left of the diagonal to the right of it.
void fill_upper_triangle(const Problem& problem, std::vector<double>& sums);

}  // namespace axiometry::volumetric::detail
