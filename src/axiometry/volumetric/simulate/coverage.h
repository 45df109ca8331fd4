// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "axiometry/base/result.h"
#include "axiometry/volumetric/identify/identification.h"
#include "axiometry/volumetric/simulate/simulated_lengths.h"

/// Whether the uncertainties that an identification states are true: the whole procedure many times, each with errors,
/// points, dead paths and noise of its own, and what it states held against what was true.
namespace axiometry::volumetric {

struct CoverageOptions {
  std::size_t trials = 100;
  std::uint64_t seed = 1;
  std::optional<TrueErrors> errors = {};  ///< the same in every trial; else drawn for each, with identify's reversal
  DrawnSize size = {};
  std::size_t points = 100;  ///< points of each station and tool, others in each trial; with reversal in any order
  std::vector<Visit> visits = {};  ///< visits that are the same in every trial, where given
  SimulatedFaults faults = {};
  IdentifyOptions identify = {};
};

/// Of z = (stated − true)/u.
struct Share {
  std::size_t count = 0;
  std::size_t inside = 0;    ///< |z| ≤ 1.96
  double sum_squares = 0.0;  ///< Σ z²

  void add(double z);
  void add(const Share& other);
  double share() const { return count > 0 ? static_cast<double>(inside) / static_cast<double>(count) : 0.0; }
  double rms() const;
};

struct CoverageTrial {
  std::array<Share, 21> errors;  ///< shares at 9 places of each curve; squareness at one; in the order of error_names()
  Share curves;                  ///< share of all of these
  Share directions;              ///< share of each direction at the same places, where directions differ
  Share field;                   ///< three components at 10 places with each tool
  double chi_squared = 0.0;
  std::size_t degrees_of_freedom = 0;
  double field_error_um_squared = 0.0;  ///< mean of |stated − true|², in the gauge
  std::size_t breaks_found = 0;         ///< untold breaks that were found where they were said to be
  std::size_t breaks_wrong = 0;         ///< breaks that were found elsewhere
  std::size_t outliers_found = 0;       ///< set aside
  std::size_t set_aside_wrong = 0;      ///< readings that were right; not those that a break leaves in doubt
};

struct CoverageStudy {
  std::vector<CoverageTrial> trials;  ///< trials that came to an end
  std::size_t failed = 0;
  std::string first_failure = {};

  /// Of all trials that state a value, and the standard error of its share from the scatter among trials: values of one
  /// trial hang together.
  struct Total {
    Share share;
    double standard_error = 0.0;
  };
  Total total(Share CoverageTrial::*which) const;
  double chi_squared_per_dof() const;  ///< Σ χ² / Σ ν
};

/// Trials run side by side; the result does not depend on how many. Fails on no trials or more than 100 000, and as
/// simulate_lengths() does.
Result<CoverageStudy> try_coverage(const MachineModel& machine, const CoverageOptions& options);

}  // namespace axiometry::volumetric
