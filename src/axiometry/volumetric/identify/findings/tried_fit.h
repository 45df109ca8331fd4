// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <span>
#include <vector>

#include "axiometry/volumetric/identify/equations/fit_quality.h"
#include "axiometry/volumetric/identify/identifier.h"

/// What else may be fitted to the lengths, beside what was asked for. Internal to identify().
namespace axiometry::volumetric::detail {

/// What χ² must lose: a few dozen unknowns take less by chance.
inline constexpr double gain_least = 100.0;

/// Whether it takes most of what the other has too much, by more than the number of its unknowns alone does.
bool explains(const FitQuality& other, const FitQuality& own);

struct TriedFit {
  Fit fit;
  FitQuality quality;
};

/// Whether most runs were driven row by row: few positions of an axis, many readings at each. Directions and times then
/// go with the rows, and so does what curves that are too coarse leave: residuals tell neither from chance.
bool is_in_rows(std::span<const VolumetricReading> readings);

/// All that were looked at, or some of very many.
std::vector<std::size_t> readings_to_try(const Identifier& done);

/// From the places of the stations as `done` found them: errors are so small that these hardly depend on them. Scales
/// of the parts are taken out where `done` has some: a fit without them would look worse for what it is not tried for.
std::optional<TriedFit> fitted_to(const Problem& some, const Identifier& done);

Coefficients with_reversal(const Coefficients& c, Reversal reversal);
std::optional<TriedFit> fitted_with(const Coefficients& coefficients, const Identifier& done,
                                    const VolumetricLengths& lengths, std::span<const std::size_t> kept);

/// How well those readings fit what was asked for, by the lengths alone: as they were fitted where that was so.
std::optional<FitQuality> own_quality(const Identifier& done, std::span<const std::size_t> kept);

/// The same without a fit: by the residuals of these readings as all were fitted, with their share of the unknowns.
FitQuality seen_quality(const Identifier& done, std::span<const std::size_t> kept);

/// Residuals of a set-up that is stated wrongly, or of a station that moved, are explained by that.
bool is_stated_wrongly(const std::vector<VolumetricFinding>& findings);
bool is_told_otherwise(const std::vector<VolumetricFinding>& findings);

}  // namespace axiometry::volumetric::detail
