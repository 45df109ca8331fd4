// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "axiometry/base/quantity.h"
#include "axiometry/base/vector3.h"

/// Scales and squareness from the slopes of lines. To first order, with δ = D p the displacement of a machine with
/// scales e and squareness C0Y, B0Z, A0Z (ISO 230-1; X primary, Y secondary), the relative stretch along a direction u
/// is uᵀ D u = e_x u_x² + e_y u_y² + e_z u_z² − C0Y u_x u_y + B0Z u_x u_z − A0Z u_y u_z.
/// Derivation and limits (straight axes, no rotations): docs/theory/squareness.md.
namespace axiometry::tracking {

/// A measured slope: stretch along a direction of length 1.
struct LineSlope {
  std::string id;
  Vector3 direction;
  double slope_um_per_m = 0.0;
  double uncertainty_um_per_m = 0.0;  ///< standard, of this line alone
};

/// One of the six unknowns: "EXX slope", "C0Y", …
struct SquarenessTerm {
  std::string id;  ///< "e_x", "e_y", "e_z", "C0Y", "B0Z", "A0Z"
  std::optional<double>
      value_um_per_m;  ///< µm/m, which is µrad for the last three; absent when these lines cannot tell it
  std::optional<double> uncertainty_um_per_m;  ///< standard
};

struct Squareness {
  std::array<SquarenessTerm, 6> terms;
  std::size_t rank = 0;
  std::vector<double> residuals_um_per_m;  ///< per line, measured − model
  double chi_squared = 0.0;
  std::size_t degrees_of_freedom = 0;
  std::vector<std::string> notes;  ///< limits of the method that concern this result
};

/// Weighted least squares; what the lines cannot tell is left out, not set to zero. `common_scale_um_per_m` is the
/// standard uncertainty that all slopes share (the scale of the instrument): it goes to the scales, not to squareness.
Squareness estimate_squareness(std::span<const LineSlope> slopes, double common_scale_um_per_m);

}  // namespace axiometry::tracking
