// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <functional>
#include <optional>
#include <span>
#include <vector>

#include "axiometry/volumetric/curves/curve_basis.h"
#include "axiometry/volumetric/machine/error_motion.h"
#include "axiometry/volumetric/machine/machine_model.h"
#include "axiometry/volumetric/machine/volumetric_data.h"

/// How finely the curves of each axis may bend. Internal to identify().
namespace axiometry::volumetric::detail {

/// Over what curves are stated: the travel; where readings leave more than a twentieth of it at an end, to where they
/// reach.
struct CurveDomain {
  double lower_mm = 0.0;
  double upper_mm = 0.0;
  bool is_travel = true;
};
std::array<CurveDomain, axis_count> curve_domains(const TravelBox& travel, const TravelBox& observed);

/// How many positions are not the same to 0.01 mm, as far as that is fewer than `enough`, else `enough`.
std::size_t different_places(std::vector<double> positions_mm, std::size_t enough);

/// As many functions as places go through whatever was read, and nothing shows what lies between: half as many at most.
inline constexpr std::size_t places_for_function = 2;

/// Sizes of the kind of curve that the places of the readings can carry, rising: at least ten readings in each span,
/// and two places for each function. Where no size has two, the least that has one; a finding tells it.
std::vector<std::size_t> supported_sizes(CurveKind kind, const CurveDomain& domain, std::vector<double> positions_mm);

using Sizes = std::array<std::size_t, axis_count>;

/// Corrected Akaike criterion of curves of these sizes; absent where they cannot be fitted.
using Criterion = std::function<std::optional<double>(const Sizes&)>;

/// The sizes with the least criterion: first alike for all axes, then axis by axis for as long as that gains.
Sizes chosen_sizes(const std::array<std::vector<std::size_t>, axis_count>& supported, const Criterion& criterion);

/// n ln(χ²/n) + 2k + 2k(k + 1)/(n − k − 1); absent with fewer than k + 2 readings.
std::optional<double> akaike(double chi_squared, std::size_t readings, std::size_t unknowns);

}  // namespace axiometry::volumetric::detail
