// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "axiometry/app/results/experiment.h"
#include "axiometry/tracking/station/length_difference.h"

/// The use case "what does an error of the station do to lengths": tracking/station/length_difference.h as tables and
/// figures.
namespace axiometry::app {

struct LengthDifferenceRequest {
  Vector3 station_error_mm = {};                       ///< Δ, determined − actual
  std::vector<double> distances_mm = {};               ///< ascending
  std::optional<double> reference_mm = {};             ///< d[n], one of the distances; the last when absent
  std::optional<Vector3> direction = {};               ///< direction of a further line; any length but 0
  std::optional<Vector3> station_uncertainty_mm = {};  ///< standard uncertainties of the station's coordinates
  RangingUncertainty ranging = {};
};

/// One line.
struct LengthDifferenceLine {
  std::string name;  ///< "x", "y", "z", "direction"
  Vector3 direction;
  std::vector<tracking::LengthDifference> values;
  std::vector<Length> bounds;                ///< 95 %; only with the uncertainty of the station
  std::optional<double> negligible_from_mm;  ///< likewise; absent where it is infinite
};

struct LengthDifferences {
  LengthDifferenceRequest request;
  std::size_t reference = 0;
  std::vector<LengthDifferenceLine> lines;  ///< x, y, z, and the direction where one is given
  std::vector<Length> combined;             ///< eq. 23
};

/// Fails on no distance, a reference that is none of them, a direction without length, negative uncertainties.
Result<LengthDifferences> compare_lengths(const LengthDifferenceRequest& request);

/// Table, figures (Figs 11 to 13) and JSON.
Experiment present(const LengthDifferences& result, const report::Options& options);

}  // namespace axiometry::app
