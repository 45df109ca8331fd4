// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>

/// One stream of random numbers for each thing that is drawn (numeric/random/random.h). Internal to the simulation.
namespace axiometry::volumetric::detail {

enum Stream : std::uint64_t {
  stream_curve = 0,  ///< the first of 18, one for each curve
  stream_squareness = 18,
  stream_points,
  stream_dead_path,
  stream_drift,
  stream_noise,
  stream_told_break,
  stream_untold_break,
  stream_lost,
  stream_outlier,
  stream_check,
  stream_order,
  stream_half,  ///< the first of 18, likewise
  stream_scale = stream_half + 18,
};

}  // namespace axiometry::volumetric::detail
