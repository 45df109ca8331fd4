// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <limits>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "axiometry/base/result.h"
#include "axiometry/model/series.h"
#include "axiometry/volumetric/field/error_model.h"

/// What a test along a straight line would show: of one axis after ISO 230-2, of a diagonal after ISO 230-6. The zero
/// of such a curve is a convention, so that the mean of all its deviations is taken away.
namespace axiometry::volumetric {

struct TestedLine {
  std::string name;
  Vector3 from_mm, to_mm;  ///< places of the axes at its ends
  Vector3 tool_mm;
  std::vector<double> positions_mm;  ///< positions of the targets, rising; the deviation is that along the line
  double first_mm = 0.0;             ///< the position that `from_mm` has; of an axis its coordinate
};

struct PredictedLine {
  TestedLine line;
  bool has_directions = false;  ///< whether the model tells them apart on this line; else `down` is `up`
  /// Where other errors differ by direction: those of which nothing tells it and which move this line, in the order of
  /// error_names().
  std::vector<std::size_t> untold_reversals;
  std::vector<Estimate> up, down;  ///< µm, at each target, less the mean of all
  Estimate systematic;             ///< E: largest less smallest of all, µm
  double reversal_um = 0.0;        ///< B: the largest |up − down|
  Estimate slope_um_per_m;         ///< slope of the best straight line through the means of both directions
  /// Of up, and behind it down where there are directions; by rows, µm².
  std::vector<double> covariance_um2;
};

/// By direction where the errors tell it, else the mean of both. Absent where the lengths do not tell that either, but
/// for a constant. Contract: two targets or more, rising, on the line; ends that differ.
std::optional<PredictedLine> predict_line(const ErrorModel& model, TestedLine line);

/// Axis 0 to 2 along itself through `through_mm`, whose coordinate of that axis does not count, over the travel that
/// was observed.
TestedLine axis_line(const ErrorModel& model, std::size_t axis, Vector3 through_mm, Vector3 tool_mm,
                     std::size_t targets = 11);

/// The four diagonals of the body, "PPP-NNN", "NPP-PNN", "PNP-NPN", "PPN-NNP", named by their ends in X, Y and Z (P:
/// the largest coordinate), from the first to the second; and the six of the faces, "XY PP-NN", "XY NP-PN" and so on,
/// where the third axis stands in the middle. Positions are distances from their beginning.
const std::vector<std::string>& diagonal_names();
/// By such a name, by one that begins at the other end, "NNN-PPP", and by those of iso230_6::Diagonal, "NP0-PN0".
/// Absent for others.
std::optional<TestedLine> diagonal_line(const ErrorModel& model, std::string_view name, Vector3 tool_mm,
                                        std::size_t targets = 11);

/// Means of a test that was measured, beside what was predicted at its targets.
struct MeasuredMeans {
  std::vector<double> up_um, down_um;      ///< deviations at each target
  std::vector<double> up_u_um, down_u_um;  ///< standard uncertainties of these means, independent …
  double degrees_of_freedom = std::numeric_limits<double>::infinity();  ///< … that they are known with
  double slope_u_um_per_mm = 0.0;         ///< standard uncertainty of a slope that all have in common …
  double slope_degrees_of_freedom = 1.0;  ///< … that it is known with
  bool both_directions = true;            ///< whether they are two means, and not one in both places
  Direction direction = Direction::up;    ///< direction of a test of one alone
};

/// What a test of both directions shows, and errors without directions cannot: up less down, held against 0.
struct UntoldReversal {
  double largest_um = 0.0;     ///< the largest |up − down|
  std::size_t target = 0;      ///< number of that target
  double systematic_um = 0.0;  ///< E as measured: largest less smallest mean of both directions
  double chi_squared = 0.0;
  std::size_t degrees_of_freedom = 0;
  double probability = 1.0;  ///< probability of a χ² as large or larger without reversal, by F: the scatter is known
                             ///< from the test's readings
};
struct LineComparison {
  bool by_direction = false;           ///< else means of both directions are compared, or
  std::optional<Direction> direction;  ///< the one that was measured, where the errors tell it
  /// Less their mean; up, and behind it down where by direction. Of one direction that of what is predicted is added.
  std::vector<double> measured_um;
  std::vector<double> predicted_um;
  std::vector<double> normalised;  ///< difference over its standard uncertainty
  double chi_squared = 0.0;
  std::size_t degrees_of_freedom = 0;
  double probability = 1.0;  ///< probability of a χ² as large or larger when both agree, by F likewise; along a common
                             ///< slope and across it apart
  std::optional<UntoldReversal> reversal;  ///< reversal in a test of both directions where means of both are compared
};
/// Of a test of one direction that direction, less its own mean. Contract: as many means as targets.
LineComparison compare(const PredictedLine& predicted, const MeasuredMeans& measured);

}  // namespace axiometry::volumetric
