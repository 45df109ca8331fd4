// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <optional>
#include <string>
#include <vector>

#include "axiometry/base/result.h"
#include "axiometry/model/axis_correction.h"
#include "axiometry/model/test.h"
#include "axiometry/standards/iso230_2/uncertainty/gum.h"

/// Where an axis stands with a table in its control, and to within what that is known: the uncertainty of mean
/// deviations of Lira & Cargill, Precision Engineering 28 (2004) 232, eq. 8, carried on to positions that are corrected
/// by them. Equations (7) to (10): docs/theory/compensation.md.
///
/// In one direction, with the control's correction c (1) and the mean deviation x̄_i with its u[x̄_i] (their eq. 8, of
/// this machine: s_i/√n and the systematic inputs),
///
///     r_i = x̄_i + c(P_i) − z,     u[r_i] = u[x̄_i]                                        (7)
///     one approach:               u² = u²[x̄_i] + s_i²                                    (8)
///     between targets:            u² = max u²[x̄] + max s² + q²  of both ends           (9)
///
/// z is a number, the mean of all x̄_i + c(P_i) of this test as `zero` says: r_i and its u are those of the position
/// against a zero that is shifted by that number. It has no uncertainty: nothing is said of the mean deviation that
/// another test would find. c is what the control makes of its file, known to the digit, so that rounding is in r and
/// no uncertainty. Between targets r follows the straight line between the means, as far from which the axis may be as
/// inner targets are from the line between others:
///
///     q² = max(D₁²/16, 4/3 D₁² − 61/720 max(0, D₂² − D₁²))                               (10)
///
/// D₁ the root mean square of their distance from the line between the targets beside them, D₂ between those next but
/// one; a smooth curve has D₂ = 4 D₁ and q = D₁/4, one that differs by τ from place to place anyhow D₂ = D₁ = τ √1.5
/// and q = τ √2, the most that a place is from the line (beside a target). Without D₂ (fewer than five targets) it is
/// taken for D₁; without D₁ (fewer than three) nobody knows, nor of a gap over twice the mean one of its direction;
/// in one wider than the mean q grows with its square, as a bow does. What repeats from target to target alike is not
/// seen in it (5.3.2), and a note says so; what the scatter does to means is in it, on the safe side.
///
/// The largest |r| + U is not stated where an effect of unknown size was not corrected (uncorrected_effects.h) or a
/// reading is a gross error (gross_errors.h); an effect of known size is added to it, over the travel or from the datum
/// to the farthest target, whichever is longer (a dead path's is the same everywhere).
namespace axiometry::compensation {

/// In one direction; native deviation unit.
struct CompensatedMean {
  double residual = 0.0;    ///< r_i
  double rounding = 0.0;    ///< share of r_i that the digits of the file make
  std::optional<double> s;  ///< s_i (3.18); absent, as what follows, of fewer than two approaches
  std::optional<iso230_2::ExpandedUncertainty> mean;      ///< uncertainty of r_i
  std::optional<iso230_2::ExpandedUncertainty> approach;  ///< uncertainty of the position at which one approach ends
};

struct CompensatedTarget {
  Position target;
  std::optional<CompensatedMean> up, down;
};

/// Between two targets that follow each other.
struct CompensatedGap {
  Position from, to;
  double residual = 0.0;                                  ///< the largest by amount, with its sign
  std::optional<iso230_2::ExpandedUncertainty> approach;  ///< absent where an end has none, no q, or wide
};

struct CompensatedPositions {
  double zero = 0.0;  ///< z: the new zero, in the deviations as measured with the table
  std::vector<CompensatedTarget> targets;
  std::array<std::vector<CompensatedGap>, 2> gaps;       ///< gaps in ↑ and in ↓
  std::array<std::optional<double>, 2> between_targets;  ///< q, likewise
  /// The largest |r| + U of one approach and what was not corrected, at the targets and from the first of them to the
  /// last; absent where any is not known.
  std::optional<double> at_targets, anywhere;
  std::vector<std::string> notes;  ///< what does not count, was assumed or is not known; sentences without full stop
};

struct TableInControl {
  const AxisCorrection& added;              ///< what the file makes the control add, as its own rule reads it
  const AxisCorrection& unrounded;          ///< correction as it was fitted
  const AxisCorrection* removed = nullptr;  ///< what was active during the test; may be none
};

/// `test` as it was measured, `removed` active. Fails as gum() does. Cost: linear in readings and nodes but for a
/// search in the nodes.
Result<CompensatedPositions> compensated_positions(const Test& test, const TableInControl& table);

}  // namespace axiometry::compensation
