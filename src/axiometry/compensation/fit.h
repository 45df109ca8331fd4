// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <vector>

#include "axiometry/base/result.h"
#include "axiometry/model/axis_correction.h"
#include "axiometry/model/series.h"

/// From a measured series to the table of a control (docs/theory/compensation.md, where the formulas are derived).
namespace axiometry::compensation {

enum class Method {
  least_squares,  ///< node values whose broken line is nearest to all readings
  interpolation,  ///< each node has the mean deviations of the two targets beside it, interpolated linearly
};

struct FitRequest {
  std::vector<double> nodes;  ///< positions of the table, ascending, mm or °; one of them: a backlash alone
  TableCurves curves = TableCurves::each_way;
  Method method = Method::least_squares;
  bool smooth = false;     ///< as far as it foretells targets that were left out better (cross-validation)
  bool hold_ends = false;  ///< nodes beyond the targets take the value at the last target
};

struct Fit {
  AxisCorrection correction;
  double smoothing = 0.0;  ///< λ of the curvature against the readings; 0 without
};

/// The correction −x̄ at the nodes. Of least squares, with h_i the broken line at target i and n_i its readings,
///
///     min Σ n_i (h_i·v + x̄_i)² + ρ n̄ Σ (v_k − v_k⁰)² + λ n̄ Σ (Δ²v_k)²,
///
/// v⁰ the plain interpolation and ρ = 0.02, which keeps nodes between few targets from swinging and decides those
/// without a target beside them; where nodes are the targets the result is −x̄_i, whatever ρ. λ is 0 unless `smooth`,
/// then that of a row of decades which foretells inner targets best that were left out, a tenth of them at a time.
///
/// One curve for both directions lies half the mean reversal beside each of them, also at targets that were approached
/// from one side alone.
///
/// Fails without a reading; on each_way and with_backlash where a direction has no reading; on nodes beyond the
/// targets of a direction that is used (nothing is extrapolated) unless `hold_ends`, naming the range that was
/// measured.
Result<Fit> fit_correction(const Series& series, AxisKind kind, const FitRequest& request);

/// The table of a control that had one while the readings were taken: `existing` + `change`, at the nodes of `change`.
Result<AxisCorrection> updated(const AxisCorrection& existing, const AxisCorrection& change);

/// Of a rotary axis whose positions are a whole turn: the ends are one place and take the mean of both.
Result<AxisCorrection> closed_turn(const AxisCorrection& correction);

/// Raised or lowered as a whole, so that it does nothing at `position`: in the mean of both directions; of a table with
/// a backlash in the positive one.
Result<AxisCorrection> with_zero_at(const AxisCorrection& correction, TableCurves curves, double position);

}  // namespace axiometry::compensation
