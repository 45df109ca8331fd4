// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <utility>
#include <vector>

#include "axiometry/volumetric/curves/beam_row.h"
#include "axiometry/volumetric/curves/coefficients.h"
#include "axiometry/volumetric/machine/error_motion.h"
#include "axiometry/volumetric/machine/machine_model.h"

/// The 21 errors as curves, how well each is known, and what they make of the tool point.
namespace axiometry::volumetric {

/// The share of a row in what is unseen above which the number has no meaning: rounding leaves 1e-9 of directions that
/// are found by eigenvalues, and a tool that is 1 mm off the spindle makes shares of 1e-3.
inline constexpr double told_most = 1e-6;

/// A value with its standard uncertainty.
struct Estimate {
  double value = 0.0;
  double u = 0.0;
};

/// Displacement of the tool point and its covariance. A component that the lengths do not tell, but for a constant of
/// all places with this tool, has no number.
struct ToolPointError {
  std::array<std::optional<double>, 3> error_um;
  Matrix3 covariance_um2{};  ///< rows and columns of components without a number are 0

  bool is_whole() const { return error_um[0] && error_um[1] && error_um[2]; }
  Vector3 error() const { return {*error_um[0], *error_um[1], *error_um[2]}; }  ///< contract: is_whole()
};

class ErrorModel {
 public:
  struct Parts {
    MachineModel machine;
    Coefficients coefficients;
    std::vector<double> values;      ///< raw coefficients, within the gauge
    std::vector<double> covariance;  ///< covariance of the coefficients by rows, coefficients.raw() squared
    /// Directions of raw coefficients, of length 1, of which the lengths say nothing: what has a share in them has no
    /// number.
    std::vector<std::vector<double>> unseen = {};
    TravelBox observed = {};  ///< box of the places where readings were
  };
  /// Contract: sizes as said.
  explicit ErrorModel(Parts parts);

  const MachineModel& machine() const { return parts_.machine; }
  const Coefficients& coefficients() const { return parts_.coefficients; }
  const Parts& parts() const { return parts_; }
  const TravelBox& observed() const { return parts_.observed; }

  /// µm or µrad; absent where the lengths do not tell it. `approach` of the axis: +1, −1 or 0 for the mean.
  std::optional<Estimate> motion(ErrorMotion error, double position_mm, double approach = 0.0) const;
  std::optional<Estimate> squareness(Squareness which) const;

  /// Errors of which at least one number is missing, 0 to 20 in the order of error_names(): of the mean of both
  /// directions, of what these differ by, or of any of them.
  std::vector<std::size_t> unseen_means() const;
  std::vector<std::size_t> unseen_reversals() const;
  std::vector<std::size_t> unseen_errors() const;

  /// δ at q with a tool, to first order (kinematics.h).
  ToolPointError at(Vector3 axes_mm, Vector3 tool_mm, Approaches approaches = {}) const;

  /// What the row makes of the coefficients; absent where the lengths do not tell it.
  std::optional<Estimate> estimate(const BeamRow& row) const;
  bool is_told(const BeamRow& row) const;

 private:
  std::optional<Estimate> estimate(const std::vector<std::pair<std::size_t, double>>& row) const;
  std::vector<std::size_t> touched_errors(std::size_t first_place, std::size_t end_place) const;
  bool is_told_but_for_a_constant(Vector3 axes_mm, Vector3 tool_mm, Approaches approaches, std::size_t component) const;

  Parts parts_;
};

}  // namespace axiometry::volumetric
