// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <span>
#include <string>
#include <vector>

#include "axiometry/tracking/lengths/line_evaluation.h"

/// Squareness from the two diagonals of one face (the way of ISO 230-6, whose text was not at hand). In a face with the
/// legs a and b, between axes at 90° + S, the law of cosines gives the diagonals
///   D_1² = a² + b² − 2 a b sin S, D_2² = a² + b² + 2 a b sin S,
/// D_1 from the low ends of both axes to their high ends, and so D_2² − D_1² = 4 a b sin S. To first order, with the
/// slopes s = ΔD/D and the direction u of the first, S = −(s_1 − s_2)/(2 u_a u_b): what the scales of the axes and of
/// the instrument do to both diagonals cancels. Signs are those of squareness.h: C0Y = S in XY, A0Z = S in YZ and
/// B0Z = −S in XZ. Derivation: docs/theory/squareness.md.
namespace axiometry::tracking {

struct FacePair {
  std::string face;                        ///< "XY", "XZ", "YZ"
  std::string first;                       ///< "NN0-PP0": both axes go up
  std::string second;                      ///< "NP0-PN0"
  std::string term;                        ///< "C0Y", "B0Z", "A0Z"
  double slope_difference_um_per_m = 0.0;  ///< s_1 − s_2
  double squareness_um_per_m = 0.0;        ///< µrad
  /// Standard; absent where that of a slope is not known. Without what changed between the two diagonals.
  std::optional<double> uncertainty_um_per_m;
  double coverage_factor = 2.0;  ///< k of Student's t for 95.45 %, from the degrees of freedom of both slopes
};

/// Of each face whose two diagonals are among the slopes, known by their ids (standards/iso230_6.h) and with directions
/// that are those of such diagonals; in the order XY, XZ, YZ.
std::vector<FacePair> face_pairs(std::span<const LineSlope> slopes);
std::vector<FacePair> face_pairs(std::span<const EvaluatedLine> lines);

}  // namespace axiometry::tracking
