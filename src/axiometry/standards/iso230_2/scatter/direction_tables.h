// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstddef>
#include <span>
#include <vector>

#include "axiometry/model/series.h"
#include "axiometry/numeric/additive_table.h"

/// The readings of both directions as tables, targets by runs, and what the studies of scatter fit to them.
namespace axiometry::iso230_2::scatter {

inline constexpr std::array<Direction, 2> each_direction = {Direction::up, Direction::down};

inline std::size_t index(Direction d) { return static_cast<std::size_t>(d); }

using Tables = std::array<std::vector<double>, 2>;  ///< ↑ and ↓; NaN where no reading is
using DirectionFits = std::array<numeric::AdditiveFit, 2>;

Tables tables_of(const Series& series);
Series series_of(const Series& like, const Tables& tables);
DirectionFits fits_of(const Tables& tables, std::size_t runs);

/// Of both directions' numbers, one for each run, their mean; of the other where one is NaN.
std::vector<double> means_of(std::span<const double> up, std::span<const double> down);

}  // namespace axiometry::iso230_2::scatter
