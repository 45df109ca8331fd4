// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "axiometry/model/axis.h"
#include "axiometry/model/tracking.h"
#include "axiometry/standards/iso230_2/assessment/assessment.h"

/// Diagonal displacement tests, ISO 230-6:2002. Its text was not at hand; names, cycle and parameters follow general
/// knowledge: each diagonal is run in both directions, five times, and evaluated as an axis is under ISO 230-2; over
/// the set the largest E and the largest B are told. Errors may cancel along a diagonal, so a small E proves little
/// alone.
namespace axiometry::iso230_6 {

inline constexpr std::string_view edition = "ISO 230-6:2002";

/// A diagonal of the box of travels: of a face (two axes move, the third stands in the middle of its travel) or of the
/// body. Named by the signs of its ends in the order X, Y, Z, first the end where the first moving axis is low:
/// "NNN-PPP"; the axis that stands has 0: "NN0-PP0".
struct Diagonal {
  std::string id;
  Vector3 begin_mm;
  Vector3 end_mm;
};
std::vector<Diagonal> body_diagonals(const TravelBox& box);  ///< NNN-PPP, NNP-PPN, NPN-PNP, NPP-PNN
std::vector<Diagonal> face_diagonals(const TravelBox& box);  ///< NN0-PP0, NP0-PN0, N0N-P0P, N0P-P0N, 0NN-0PP, 0NP-0PN

/// Of a set of diagonals: the largest of each parameter and the diagonal that has it, the first of several that are
/// alike. Absent where no diagonal has it.
struct DiagonalSummary {
  struct Largest {
    std::string id;
    Deviation value;
  };
  std::optional<Largest> E;
  std::optional<Largest> R;
  std::optional<Largest> B;
};
struct NamedEvaluation {
  std::string id;
  const iso230_2::Evaluation& evaluation;
};
DiagonalSummary summarise(std::span<const NamedEvaluation> diagonals);

}  // namespace axiometry::iso230_6
