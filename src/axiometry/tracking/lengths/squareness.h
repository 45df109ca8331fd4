// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstddef>
#include <limits>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "axiometry/base/quantity.h"
#include "axiometry/base/vector3.h"

/// Scales and squareness from the slopes of lines. To first order, with δ = D p the displacement of a machine with
/// scales e and squareness C0Y, B0Z, A0Z (ISO 230-1; X primary, Y secondary), the relative stretch along a direction u
/// is uᵀ D u = e_x u_x² + e_y u_y² + e_z u_z² − C0Y u_x u_y + B0Z u_x u_z − A0Z u_y u_z.
/// Signs: C0Y = c displaces by (−c y, 0, 0), B0Z = b by (b z, 0, 0), A0Z = a by (0, −a z, 0).
/// Derivation and limits (straight axes, no rotations): docs/theory/squareness.md.
namespace axiometry::tracking {

/// A measured slope: stretch along a direction.
struct LineSlope {
  std::string id;
  Vector3 direction;                  ///< unit vector; its sign does not matter
  double slope_um_per_m = 0.0;        ///< actual over nominal length, less 1: positive where the machine goes too far
  double uncertainty_um_per_m = 0.0;  ///< standard, of this line alone; not above 0: not known
  double length_mm = 0.0;             ///< length of the part that was measured, for notes; 0: not known
  double degrees_of_freedom = std::numeric_limits<double>::infinity();  ///< that its uncertainty is known with
};

/// One of the six unknowns: "EXX slope", "C0Y", …
struct SquarenessTerm {
  std::string id;  ///< "e_x", "e_y", "e_z", "C0Y", "B0Z", "A0Z"
  std::optional<double>
      value_um_per_m;  ///< µm/m, which is µrad for the last three; absent when these lines cannot tell it
  std::optional<double> uncertainty_um_per_m;  ///< standard; absent with the value, and where that of a line is unknown
  double coverage_factor = 2.0;                ///< k of Student's t for 95.45 %: of few targets or runs above 2
};

struct ScalesAndSquareness {
  std::array<SquarenessTerm, 6> terms;
  /// Of the terms in (µm/m)², rows and columns of those that are absent 0; all 0 when unweighted.
  std::array<std::array<double, 6>, 6> covariance_um2_per_m2{};
  std::size_t rank = 0;  ///< how many of 6 combinations of the terms the lines tell
  bool weighted = true;  ///< by 1/σ², as far as each line tells it; else all count alike, because one u is not known
  std::vector<double> residuals_um_per_m;  ///< residual of each line, measured − model
  double chi_squared = 0.0;                ///< Σ weight · residual²; 0 and without meaning when unweighted
  std::size_t degrees_of_freedom = 0;      ///< number of lines − rank
  std::vector<std::string> notes;          ///< limits of the method that concern this result
};

/// Weighted least squares; what the lines cannot tell is left out, not set to zero. `common_scale_um_per_m` is the
/// standard uncertainty that all slopes share (the scale of the instrument): it goes to the scales, not to squareness.
///
/// A combination of the terms that turns a change of itself into less than 1e-4 of it in all slopes together counts as
/// one the lines cannot tell, and a term with more than 1e-5 of such a combination in it is absent. Uncertainties are
/// those of the lines, times √(χ²/ν) where that is above 1 and ν > 0; k after Welch and Satterthwaite from the
/// degrees of freedom of the slopes.
///
/// Needs finite directions of a length above 0, finite slopes and degrees of freedom above 0 (contract). No line: rank
/// 0, all absent.
ScalesAndSquareness estimate_squareness(std::span<const LineSlope> slopes, double common_scale_um_per_m);

}  // namespace axiometry::tracking
