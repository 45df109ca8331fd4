// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <optional>
#include <stop_token>
#include <string>
#include <vector>

#include "axiometry/base/result.h"
#include "axiometry/model/named_finding.h"
#include "axiometry/volumetric/field/error_model.h"
#include "axiometry/volumetric/machine/volumetric_data.h"

/// Volumetric calibration: all 21 errors of a machine from the lengths that one tracking interferometer measures from
/// several stations in turn, with several tools (Lee et al. 2016, eq. 2, with the machine's kinematics in place of free
/// points). Derivation, gauge, identifiability: docs/theory/volumetric.md.
namespace axiometry::volumetric {

/// Whether the dead path of a stretch may change with the readings, from its first to its last.
enum class DriftModel {
  automatic,  ///< drift is looked for where the residuals demand it (F test, 1 in 1000)
  none,
  linear,
};

/// What is taken for known of how far curves bend, beside the lengths: nothing, or that the slope of each changes over
/// its range by a normal deviate of some standard deviation (docs/theory/volumetric.md, "Smooth curves").
struct Smoothness {
  enum class Kind {
    none,       ///< curves follow the lengths alone
    automatic,  ///< as the lengths let all curves together appear (restricted maximum likelihood)
    stated,
  };
  /// Bounds of what is stated, and found: below the least a curve is straight for every purpose.
  static constexpr double least = 0.1, most = 1e6;

  Kind kind = Kind::none;
  double displacement_um = 0.0;  ///< stated: that standard deviation, µm from one end of the range to the other
  double rotation_urad = 0.0;    ///< stated: that standard deviation of rotations, µrad
};

struct IdentifyOptions {
  CurveKind curves = CurveKind::spline;
  /// Spans, or degree, of X, Y, Z; 0: as many as the readings support (smallest corrected Akaike criterion).
  std::array<std::size_t, axis_count> sizes{};
  Reversal reversal = Reversal::none;
  Smoothness smoothness = {};  ///< not of Legendre polynomials, which are as smooth as their degree
  DriftModel drift = DriftModel::automatic;
  bool find_breaks = true;       ///< look for breaks of the beam that the file does not tell
  bool find_outliers = true;     ///< set readings aside that no model explains
  bool find_part_scales = true;  ///< look for parts that differ in scale, as of other temperatures
  std::size_t threads = 0;       ///< 0: as many as there are cores. The result does not depend on it
  std::stop_token stop = {};     ///< nobody waits for it any more: fails, as unavailable
};

/// Where the instrument stood, as one tool sees it.
struct IdentifiedStation {
  std::size_t station = 0;
  std::size_t tool = 0;
  Vector3 at_mm;
  Matrix3 covariance_um2{};
  std::size_t readings = 0;
  double rms_um = 0.0;          ///< root mean square of its residuals
  double normalised_rms = 0.0;  ///< root mean square of its residuals over σ
  std::optional<double> scale_um_per_m,
      scale_u_um_per_m;  ///< where parts have scales of their own: that of axes and air
};

/// Parts, a station with a tool each, that were measured at temperatures of their own: their axes, or the air, differ
/// in scale (docs/theory/volumetric.md, "Parts at temperatures of their own").
struct PartScales {
  double spread_um_per_m = 0.0;  ///< standard deviation of a part, in the middle of what it may be
  double chance = 1.0;           ///< chance that scatter alone lets parts differ so much, or more
  bool held = false;             ///< taken out, and in all uncertainties; else too few parts show it
  Vector3 about_mm;              ///< where a scale moves nothing: places of stations are such that it is so
};

struct IdentifiedStretch {
  std::size_t station = 0;  ///< index among `stations` of the identification
  std::size_t segment = 0;
  std::size_t readings = 0;
  double dead_path_mm = 0.0;
  std::optional<double> drift_um;  ///< drift over the stretch
};

/// A break that the file does not tell.
struct FoundBreak {
  std::size_t before_reading = 0;    ///< the likeliest
  double jump_um = 0.0;              ///< jump of the length
  std::size_t earliest_reading = 0;  ///< it was before a reading from this one ...
  std::size_t latest_reading = 0;    ///< ... to here it was: those between tell no more, and are left out

  bool is_certain() const { return earliest_reading == latest_reading; }
};

struct SetAside {
  enum class Reason {
    outlier,
    beside_break,       ///< it may fit: but nothing tells on which side of a break it was measured
    unknown_direction,  ///< nor in which direction axes had come to rest, where that matters
  };
  std::size_t reading = 0;
  double residual_um = 0.0;  ///< measured less what the others predict
  double normalised = 0.0;   ///< residual over its standard uncertainty
  Reason reason = Reason::outlier;
};

struct VolumetricRank {
  std::size_t unknowns = 0;         ///< unknowns under the gauge, stations and dead paths included
  std::size_t errors = 0;           ///< how many of these are coefficients of errors
  std::size_t null_directions = 0;  ///< directions of which the lengths say nothing; 0 when all 21 errors are told
  double condition = 0.0;           ///< condition of the scaled rows
};

/// One of the 18 curves that was taken to be smooth.
struct SmoothedError {
  std::size_t error = 0;    ///< number in the order of error_names()
  double u_ratio = 1.0;     ///< mean standard uncertainty by the lengths alone over that which is stated
  double bias = 0.0;        ///< the most by which the smoothness draws it towards a straight line, µm or µrad
  double bend_ratio = 1.0;  ///< what it was found to bend over what the smoothness lets expect, as a ratio of rms
  double chance = 1.0;      ///< probability that it were found to bend as far, if the smoothness held
};

struct SmoothedCurves {
  double displacement_um = 0.0;  ///< as stated, or as found
  double rotation_urad = 0.0;
  double taken = 0.0;  ///< so many unknowns the smoothness tells, not the lengths
  std::vector<SmoothedError> errors;
};

using VolumetricFinding = NamedFinding;

struct Identification {
  ErrorModel model;
  std::vector<IdentifiedStation> stations;
  std::vector<IdentifiedStretch> stretches;
  std::vector<double> residuals_um;  ///< residual of each reading, measured less predicted; of those set aside too
  std::vector<double> sigmas_um;     ///< standard uncertainty of each reading, as stated
  std::vector<SetAside> set_aside;
  std::vector<FoundBreak> breaks;
  double chi_squared = 0.0;
  std::size_t degrees_of_freedom = 0;
  VolumetricRank rank;
  std::size_t iterations = 0;
  bool drift = false;                      ///< whether dead paths drift in the model
  std::optional<SmoothedCurves> smoothed;  ///< absent: nothing was taken for known of the curves
  std::optional<PartScales>
      part_scales;  ///< absent: not looked for, or no more than chance lets parts differ in one of five calibrations
  std::vector<VolumetricFinding> findings;  ///< serious ones first

  double chi_squared_per_dof() const {
    return degrees_of_freedom > 0 ? chi_squared / static_cast<double>(degrees_of_freedom) : 0.0;
  }
  /// By which covariances are multiplied: χ²/ν where that is above 1.
  double variance_factor() const { return chi_squared_per_dof() > 1.0 ? chi_squared_per_dof() : 1.0; }
};

/// Readings are in the order of measurement. Fails, with the numbers, on tools that the machine does not have, places
/// outside of the travel, lengths that are not finite, stations with too few readings or whose place cannot be found,
/// no more readings than unknowns, polynomials that are to be smooth, and when it does not converge. Errors that the
/// lengths do not tell are no failure: the model has no number for them, and a finding says why.
Result<Identification> identify(const MachineModel& machine, const VolumetricLengths& lengths,
                                const IdentifyOptions& options);

}  // namespace axiometry::volumetric
