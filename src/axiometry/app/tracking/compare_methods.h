// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "axiometry/app/results/experiment.h"
#include "axiometry/model/named_finding.h"
#include "axiometry/tracking/instruments/tracker_kinds.h"

/// The study "why lengths without angles": the uncertainty of the same points, seen from the same stations, by polar
/// measurement (Lee et al., eq. 1) and by multilateration (eq. 2), by the law of propagation and by trials.
namespace axiometry::app {

struct CompareMethodsRequest {
  std::vector<Vector3> points_mm;
  std::vector<std::string> point_names;
  std::vector<Vector3> stations_mm;  ///< upright, their x along X
  /// Of the instrument with angles; needs them.
  tracking::ChosenTracker polar;
  RangingUncertainty polar_changes;  ///< uncertainty of its lengths, taken alone
  RangingUncertainty ranging;        ///< uncertainty of the instrument that gives lengths alone
  std::string ranging_name;          ///< name by which that instrument was asked for
  std::size_t trials = 1000;
  std::uint64_t seed = 1;
};

/// Over all points, relative to the points as a whole.
struct MethodOutcome {
  std::string name;
  std::string id;                   ///< "polar-1", "polar-all", "lengths-of-polar", "multilateration"
  std::string failure;              ///< why there is none; then the others are 0
  Vector3 u_um;                     ///< root mean square of the standard uncertainties of a coordinate
  double u_point_um = 0.0;          ///< root mean square of √(u_x² + u_y² + u_z²)
  double u_point_um_largest = 0.0;  ///< u of the point known worst
  std::string worst_point;
  double trials_point_um = 0.0;  ///< the same as u_point_um, of the trials' scatter
  double told_by_angles = 0.0;   ///< share of the unknowns, 0 to 1
};

struct ComparedMethods {
  CompareMethodsRequest request;
  std::vector<MethodOutcome> methods;
  std::vector<NamedFinding> findings;
};

/// Fails on fewer than three points, more than 2000, no station or more than 20, a station within 1 mm of a point, and
/// an instrument without angles or lengths.
Result<ComparedMethods> compare_methods(const CompareMethodsRequest& request);

Experiment present(const ComparedMethods& compared, const report::Options& options);

}  // namespace axiometry::app
