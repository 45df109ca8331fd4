// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "axiometry/model/motion_series.h"
#include "axiometry/standards/error_motions/motion_estimate.h"
#include "axiometry/standards/error_motions/reference_line.h"

/// Straightness, roll, pitch or yaw of an axis from readings at nominal positions in one or both directions.
///
/// At each position i: means ȳ_i↑, ȳ_i↓ and standard deviations s_i↑, s_i↓ (n − 1) over the runs, ȳ_i = (ȳ_i↑ +
/// ȳ_i↓)/2, B_i = ȳ_i↑ − ȳ_i↓, R_i↑ = 4 s_i↑, R_i = max(2 s_i↑ + 2 s_i↓ + |B_i|, R_i↑, R_i↓): as ISO 230-2:2014, 3.11
/// to 3.20, has them of positions. A reference line (reference_line.h) through each of these means; about one line the
/// reversal of the residuals is that of the readings. The error is the range of the residuals, of an angle that of its
/// readings unless a line is asked for. The range over both directions is counted about the line of ȳ_i.
///
/// A slope and a range are sums Σ c_i y_i. Their scatter is that of the same sum of each run, so that what a run has in
/// common, such as a drift of its slope, counts in full; runs are taken as independent of each other. Few runs may
/// agree by chance: where the noise within the runs (about the mean residuals, each run less its own line, or its mean
/// where there is none; s_w with d (n − 1)(m − 2) or d (n − 1)(m − 1) degrees of freedom for d directions) gives a
/// larger U, that counts. Where the highest and lowest residual stand is taken as known: noise makes a range too large
/// rather than too small.
namespace axiometry::error_motions {

enum class PathKind { up, down, mean };
std::string_view path_mark(PathKind kind);  ///< "↑", "↓", "mean"

/// One course of the axis and its line.
struct MotionPath {
  PathKind kind = PathKind::mean;
  std::vector<double> means;      ///< ȳ_i
  std::vector<double> residuals;  ///< ȳ_i less the line
  ReferenceLine line;
  MotionEstimate slope_per_m;  ///< b in unit/m; 0 and without u where there is no line
  MotionEstimate intercept;    ///< a, at position 0
  MotionEstimate range;        ///< highest less lowest residual
  std::size_t highest = 0;     ///< index of the position
  std::size_t lowest = 0;

  bool tells_U() const { return slope_per_m.tells_U() || intercept.tells_U() || range.tells_U(); }
};

struct MotionPosition {
  double position_mm = 0.0;
  std::optional<double> s_up, s_down;                                         ///< s_i↑, s_i↓, with two runs or more
  std::optional<double> reversal;                                             ///< B_i, of both directions
  std::optional<double> repeatability_up, repeatability_down, repeatability;  ///< R_i↑, R_i↓, R_i
};

struct AxisMotion {
  MotionUnit unit = MotionUnit::um;
  Reference reference = Reference::least_squares;
  std::size_t runs = 0;
  std::vector<MotionPosition> positions;
  std::vector<MotionPath> paths;  ///< the direction there is; or ↑, ↓ and their mean

  std::optional<MotionEstimate> range_both;  ///< range over ↑ and ↓ about the line of the mean
  std::optional<MotionEstimate> reversal;    ///< the B_i of largest magnitude, with its sign
  std::optional<double> reversal_mean;       ///< B̄
  std::optional<double> repeatability_up, repeatability_down, repeatability;  ///< maxima of R_i↑, R_i↓, R_i

  /// That of which squareness is made: the mean of both directions, or the one there is.
  const MotionPath& principal() const { return paths.back(); }
  /// Several runs that do not differ, and no instrument whose uncertainty is stated.
  bool repeats_without_U() const { return runs > 1 && std::ranges::none_of(paths, &MotionPath::tells_U); }
};

struct MotionOptions {
  Reference reference = Reference::least_squares;
  std::optional<InstrumentUncertainty> instrument{};
};

/// Cannot fail: a series is whole. O(n) for n readings.
AxisMotion axis_motion(const MotionSeries& series, const MotionOptions& options);

}  // namespace axiometry::error_motions
