// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "axiometry/model/test.h"
#include "axiometry/standards/iso230_2/inputs/inputs.h"
#include "axiometry/standards/iso230_2/monte_carlo/environment_modes.h"

namespace axiometry::iso230_2 {

/// A weighted sum of readings: Σ w_r x_r.
struct WeightedReadings {
  struct Term {
    std::size_t place = 0;  ///< place of the reading, dense as in Series::make_dense()
    double weight = 0.0;
  };
  std::vector<Term> terms;
  double independent = 0.0;  ///< √Σ w² for noise that is independent from reading to reading
};

/// What the environmental variation does to sums of readings, to first order: white noise, shapes along the time of the
/// test, or what a recording at standstill shows of both. For the law of propagation alone.
class EnvironmentEffect {
 public:
  /// `white_sd`: standard uncertainty of E_VE in one reading, were it white. A recording takes the place of all kinds.
  EnvironmentEffect(const Test& test, const UncertaintyInputs& inputs, double white_sd);

  /// Standard uncertainty of the sum: the largest of what is considered.
  double of(const WeightedReadings& sum) const;

  const std::string& note() const { return note_; }  ///< what is considered; empty where it is white noise alone

 private:
  /// One thing that it may be. Without shapes: white noise alone.
  struct Possibility {
    double white_sd = 0.0;
    EnvironmentModes slow;
    double scale = 1.0;  ///< scale of the shapes
  };

  std::vector<Possibility> possibilities_;
  std::string note_;
};

}  // namespace axiometry::iso230_2
