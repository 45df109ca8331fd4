// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <optional>

#include "axiometry/standards/iso230_2/parameters.h"

namespace axiometry::report::plot {

/// From where to where on the deviation axis a parameter reaches, and the targets (index i − 1) where
/// its two ends lie: one and the same target for R and B.
struct Extent {
  Deviation low;
  Deviation high;
  std::size_t low_at = 0;
  std::size_t high_at = 0;
};

using Parameter = std::optional<Deviation> iso230_2::AxisParameters::*;

/// What the dimension line of a parameter spans, so that high − low is the parameter: E and M between
/// extreme means (3.23 to 3.25), A between extreme boundaries mean ± 2s (3.26, 3.27), B between the two
/// means of the target with the largest |B_i| (3.16), R across the widest band of one target (3.20 to
/// 3.22). Where several targets tie, the first. Nothing when the parameter does not exist, and for B̄,
/// a mean of differences that has no ends.
std::optional<Extent> extent(const iso230_2::Evaluation& evaluation, Parameter parameter);

/// Half the width of the band about the mean of one target and direction: 2 s_i, 0 without s_i.
double half_band(const iso230_2::PositionResult& position, Direction direction);

std::optional<Deviation> mean(const iso230_2::PositionResult& position, Direction direction);
std::optional<Deviation> standard_deviation(const iso230_2::PositionResult& position, Direction direction);

}  // namespace axiometry::report::plot
