// SPDX-License-Identifier: Apache-2.0
#include "axiometry/simulation/slow_process.h"

#include <algorithm>
#include <cmath>

namespace axiometry::simulation {

SlowProcess::SlowProcess(numeric::RandomKey key, Grid grid) : begin_(grid.begin), step_(grid.step) {
  nodes_.resize(static_cast<std::size_t>(std::ceil((grid.end - grid.begin) / grid.step)) + 2);
  numeric::fill_normal(key, nodes_);
}

SlowProcess SlowProcess::stationary(numeric::RandomKey key, Grid grid, double keep) {
  SlowProcess process(key, grid);
  const double fresh = std::sqrt(1.0 - keep * keep);
  for (std::size_t k = 1; k < process.nodes_.size(); ++k)
    process.nodes_[k] = keep * process.nodes_[k - 1] + fresh * process.nodes_[k];
  return process;
}

SlowProcess SlowProcess::walk(numeric::RandomKey key, Grid grid) {
  SlowProcess process(key, grid);
  process.nodes_[0] = 0.0;
  for (std::size_t k = 1; k < process.nodes_.size(); ++k) process.nodes_[k] += process.nodes_[k - 1];
  return process;
}

double SlowProcess::at(double x) const {
  if (nodes_.empty()) return 0.0;
  const double place = std::clamp((x - begin_) / step_, 0.0, static_cast<double>(nodes_.size() - 1));
  const std::size_t k = std::min(static_cast<std::size_t>(place), nodes_.size() - 2);
  return nodes_[k] + (place - static_cast<double>(k)) * (nodes_[k + 1] - nodes_[k]);
}

}  // namespace axiometry::simulation
