// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "axiometry/volumetric/field/error_model.h"

/// What is linear in the errors, as rows of numbers for each raw coefficient, so that sums and differences of places
/// keep their correlation.
namespace axiometry::volumetric {

using DenseRow = std::vector<double>;

/// Adds `weight` times the row of δ along `direction` (any length) at a place, µm.
void add_field(DenseRow& row, const ErrorModel& model, Vector3 axes_mm, Vector3 tool_mm, Vector3 direction,
               Approaches approaches = {}, double weight = 1.0);

/// δ, µm, that raw coefficients make, those of the model or others.
Vector3 field_um(const ErrorModel& model, std::span<const double> coefficients, Vector3 axes_mm, Vector3 tool_mm);

/// Value and standard uncertainty of a row; whether it is told is another question.
Estimate estimate_of(const ErrorModel& model, std::span<const double> row);
/// C a, by which a row is multiplied for a covariance with it.
DenseRow covariance_times(const ErrorModel& model, std::span<const double> row);

/// Whether the lengths tell it. `size` is that of what the row was made of: differences may be nothing but rounding.
bool is_told(const ErrorModel& model, std::span<const double> row, double size = 1.0);

/// The travel that was observed, and places in it by shares from 0 to 1.
Vector3 place_in(const TravelBox& box, Vector3 shares);

}  // namespace axiometry::volumetric
