// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "axiometry/base/result.h"
#include "axiometry/volumetric/identify/identification.h"
#include "axiometry/volumetric/simulate/simulated_lengths.h"

/// What a calibration will tell, and how well, before anyone measures: the normal equations of the identification with
/// errors of 0, stations where they are planned and the uncertainty that the machine's file states.
namespace axiometry::volumetric {

struct ExpectOptions {
  CurveKind curves = CurveKind::spline;
  std::array<std::size_t, axis_count> sizes = {5, 5, 5};  ///< spans, or degree: what errors usually need
  bool drift = true;                                      ///< whether dead paths drift, which identify looks for too
};

/// Standard uncertainties of one of the 21 errors, µm or µrad; absent where it is not told.
struct ExpectedError {
  std::optional<double> u_mean;  ///< root mean square of u over 41 positions of the travel
  std::optional<double> u_most;
};

/// Standard uncertainties of the tool point's error, µm: √(u_x² + u_y² + u_z²) over the travels (7 × 7 × 7 places);
/// absent where not all of it is told.
struct ExpectedTool {
  std::size_t tool = 0;
  std::optional<double> u_rms_um;
  std::optional<double> u_most_um;
};

struct Expectation {
  VolumetricRank rank;
  std::size_t readings = 0;
  std::vector<std::size_t> unseen;            ///< places in error_names()
  std::vector<std::string> reasons;           ///< why; empty when all is told
  std::array<ExpectedError, 21> errors;       ///< expected errors in the order of error_names()
  std::vector<ExpectedTool> tools;            ///< tools of the machine, in its order
  std::optional<double> u_rms_um, u_most_um;  ///< root mean square and largest u over all tools
};

/// Fails on sizes of curves that are none, no station or reading, places outside of the travel and a station within
/// 1 mm of a point.
Result<Expectation> expect(const MachineModel& machine, std::span<const Visit> visits, const ExpectOptions& options);

/// For comparing places of stations: the rms of the tool point's standard uncertainty, µm, at the corners and the
/// middle of the travels with curves of degree 3, and 1000 for each direction that is not told. Cheap.
double expected_score(const MachineModel& machine, std::span<const Visit> visits);

}  // namespace axiometry::volumetric
