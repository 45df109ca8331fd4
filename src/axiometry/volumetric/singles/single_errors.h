// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <optional>
#include <string>
#include <vector>

#include "axiometry/base/result.h"
#include "axiometry/model/named_finding.h"
#include "axiometry/volumetric/field/error_model.h"

/// The 21 errors of a machine out of measurements of each alone: straightness, rotations, positioning of one axis after
/// the other, and squareness. Derivation: docs/theory/volumetric.md, "Measured singly".
///
/// A displacement is read where the axis moves the measured point, with the lever r_a of that place (chain.h): what is
/// read is E_a + ω_a × r_a. The rotations of the same axis are therefore taken out of it, and of the squareness what
/// they, and the rotations of the axes before it in the chain, make of the slope of both lines. Constants, and slopes
/// of straightness, belong to no single measurement and are removed (gauge.h). Squareness belongs to the lines as they
/// were read: where a straightness was read beyond the range that all errors of its axis have in common, what its slope
/// is less there comes off.
///
/// Where an error was read in both directions it has, beside the curve of their mean, one of half of their difference,
/// out of which those of the rotations are taken by the same levers. Of an error without it, what its directions differ
/// by has no number; the mean has.
///
/// Squareness is that of the means of both directions; the slopes of the halves of straightness make that of each. An
/// axis that stands still has the rotations of the direction in which it came to rest: by them it turns the line of one
/// behind it in the chain. Where nothing says which direction that was, the squareness is as uncertain as these halves
/// are large.
namespace axiometry::volumetric {

/// What readings in both directions have beside their mean, at the same positions. What both have in common, as what
/// the instrument's zero and its errors are, is not in it.
struct SingleReversal {
  std::vector<double> halves;       ///< half of what is read moving up less what is read moving down, µm, µrad
  std::vector<double> u;            ///< standard uncertainties, independent from one position to the next
  std::vector<double> covariances;  ///< covariance with the mean at the same position
};

/// Readings of one error motion, means over runs and directions; at least two.
struct SingleMotion {
  ErrorMotion error;
  std::vector<double> positions_mm;             ///< positions of its axis, ascending
  std::vector<double> values;                   ///< µm, µrad
  std::vector<double> u;                        ///< standard uncertainties, independent from one position to the next
  std::optional<SingleReversal> reversal = {};  ///< absent where nothing tells the directions apart
  double slope_u_per_mm = 0.0;  ///< standard uncertainty of a slope that all values have in common, µm/mm, µrad/mm
};

struct SingleSquareness {
  Squareness which = Squareness::C0Y;
  double urad = 0.0;
  double u_urad = 0.0;
  /// Its lines are those over the range that all errors of their axis have in common (measured_square.h); else those of
  /// the straightness as it was read.
  bool over_common_range = false;
  /// In which direction each line, in the order of square_lines, was read where it was in one alone: +1, −1; 0 of both.
  std::array<double, 2> directions{};
};

/// Where the axes stood, and which point was measured, while the errors of one axis were.
struct SinglePlace {
  Vector3 axes_mm;  ///< place of the axes; that of the axis itself is not used
  Vector3 tool_mm;
  Approaches approaches{};  ///< direction in which the others came to rest there; 0 where nothing says it
};

struct SingleErrors {
  std::vector<SingleMotion> motions;         ///< motions, each error once
  std::vector<SingleSquareness> squareness;  ///< squareness, each once
  std::array<std::optional<SinglePlace>, axis_count> places{};
  Reversal reversal = Reversal::curves;  ///< how directions are modelled; none: the mean of what was read in both
};

struct SingleModel {
  ErrorModel model;
  std::vector<NamedFinding> findings;
};

inline constexpr std::size_t single_nodes_most = 61;

/// Curves of each axis are straight lines between equidistant nodes over the range that all its errors have in common,
/// as many nodes as the error with the fewest positions has, at most single_nodes_most. An error that was not measured,
/// or from which a rotation that was not measured there cannot be taken out, has no number in the model; nor has
/// squareness where nothing tells over which of several ranges of an axis it was measured.
///
/// Fails on nothing to assemble, displacements or squareness of an axis without a place, an axis whose errors have no
/// range in common, and readings or places beyond the travel.
Result<SingleModel> model_of_singles(MachineModel machine, const SingleErrors& errors);

}  // namespace axiometry::volumetric
