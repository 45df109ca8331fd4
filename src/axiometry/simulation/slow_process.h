// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <vector>

#include "axiometry/numeric/random/random.h"

namespace axiometry::simulation {

/// One random quantity each: the streams of the seed.
enum Stream : std::uint64_t {
  stream_pitch = 1,
  stream_stick_slip,
  stream_hunting,
  stream_reading_noise,
  stream_sample_noise,
  stream_drift,
  stream_air,
  stream_outlier,
  stream_outlier_size,
  stream_slip,
  stream_slip_size,
  stream_phases,
  stream_drop_out,
};

/// Nodes of a stationary process within the length or time over which it is correlated.
inline constexpr double nodes_per_correlation = 8.0;

/// A random function of one coordinate, drawn at even nodes and straight between them; outside it keeps the end's
/// value.
class SlowProcess {
 public:
  struct Grid {
    double begin = 0.0;
    double end = 0.0;
    double step = 1.0;
  };

  SlowProcess() = default;  ///< 0 everywhere

  /// Normal, of standard deviation 1, with the correlation `keep` between neighbouring nodes.
  static SlowProcess stationary(numeric::RandomKey key, Grid grid, double keep);
  /// From 0, with independent steps of standard deviation 1.
  static SlowProcess walk(numeric::RandomKey key, Grid grid);

  double at(double x) const;

 private:
  explicit SlowProcess(numeric::RandomKey key, Grid grid);

  double begin_ = 0.0;
  double step_ = 1.0;
  std::vector<double> nodes_;
};

}  // namespace axiometry::simulation
