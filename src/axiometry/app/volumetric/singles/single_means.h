// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "axiometry/app/volumetric/singles/run_scatter.h"
#include "axiometry/base/result.h"
#include "axiometry/standards/error_motions/motion_estimate.h"
#include "axiometry/volumetric/singles/single_errors.h"

/// From what was read of an error by direction to what a model is made from: the mean of both directions, and half of
/// what they differ by.
namespace axiometry::app {

struct SingleMeans {
  volumetric::SingleMotion motion;  ///< positions ascending; with reversal where both directions were read
  std::string directions;           ///< "both", "up", "down"
  double reversal = 0.0;            ///< largest |up − down| of both directions
  std::vector<std::string> remarks;
};

/// s is as run_scatter() has it. Of the mean u² = (s↑²/n↑ + s↓²/n↓)/4 + u_I², of the half the first part alone, their
/// covariance (s↑²/n↑ − s↓²/n↓)/4; of one direction s²/n + u_I². What the instrument's uncertainty u_I holds both
/// directions have in common. Of one run, whose s nobody knows, u_I² stands in the half for s²/n: as much as readings
/// with nothing in common have.
///
/// Positions at either end that were approached from one side alone, where others were from both, are left out with a
/// remark, and remarks name the means whose runs scatter unlike the others. Fails on such a position between others, on
/// fewer than two positions, and where nothing tells an uncertainty: no instrument and one run
/// or runs that all agree to the last digit, or an instrument that has none at a position of one run.
Result<SingleMeans> single_means(volumetric::ErrorMotion error, std::vector<PositionMeans> positions,
                                 const std::optional<error_motions::InstrumentUncertainty>& instrument);

/// The refusal of an error, or of a squareness, that has neither runs nor an instrument.
Error no_uncertainty_of(std::string_view name);
Error no_uncertainty_of_equal_runs(std::string_view name);

}  // namespace axiometry::app
