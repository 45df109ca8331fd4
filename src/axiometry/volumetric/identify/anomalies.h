// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <vector>

#include "axiometry/volumetric/identify/equations/least_squares.h"

/// What residuals show that no machine does. Internal to identify().
namespace axiometry::volumetric::detail {

/// A break of the beam within a stretch: its readings before and behind `before` differ.
struct BreakSuspected {
  std::size_t before = 0;  ///< reading
  double jump_um = 0.0;    ///< jump of the residuals
  double statistic = 0.0;
};

/// The clearest break of all stretches: the largest of
///   (S_k − k S_n/n)² / (k (n − k)/n), S the sums of normalised residuals (clipped at 4 robust standard deviations),
/// at least three readings on either side, above 30 + 4 ln n and above what a straight drift explains (of a true drift
/// a step explains at most three quarters, of a true step a drift no more). Noise alone exceeds it less than once in
/// 10⁵ stretches.
std::optional<BreakSuspected> clearest_break(const Problem& problem, std::span<const double> residuals_um);

/// What a break must take of χ² among so many readings.
double break_limit(std::size_t readings);

/// That which the beam ended before a reading at whose place a stretch begins: of the same station, tool and segment.
std::size_t stretch_before(const Unknowns& unknowns, std::size_t reading);

/// By how much all lengths jump at a break before a reading: from the end of the stretch before it to the begin of its
/// own, µm. Dead paths are taken off the length, and are those of the middle of a stretch that drifts.
double jump_um(const Unknowns& unknowns, const State& state, std::size_t before);

/// Of breaks that a fit holds that one whose jump is least beyond the scatter of the two stretches beside it, where it
/// is less than what clearest_break() asks for: what a break seemed to be before others were found need not jump in the
/// end. None where all are clear. One alone, for without it the next may be clear: between two breaks there may be too
/// few readings to tell either.
std::optional<std::size_t> least_clear_break(const Problem& problem, const State& state,
                                             std::span<const double> residuals_um, std::span<const std::size_t> breaks);

/// Whether the residuals drift along their stretches: χ² of the straight lines, over the robust variance, against as
/// many degrees of freedom; the probability of as much or more.
double drift_chance(const Problem& problem, std::span<const double> residuals_um);

/// |v|/σ above which one of n readings is set aside: in one of 1000 calibrations one is that belongs.
double outlier_limit(std::size_t readings);

}  // namespace axiometry::volumetric::detail
