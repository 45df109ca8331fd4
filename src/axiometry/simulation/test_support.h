// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "axiometry/simulation/simulate.h"

namespace axiometry::simulation {

/// A plan of the standard cycle in both directions.
inline Plan plan_of(std::vector<double> targets, std::size_t runs = 3) {
  Plan plan;
  for (const double p : targets) plan.targets.push_back(Position::native(p));
  plan.runs = runs;
  plan.overrun = Position::native(5.0);
  plan.feed = 3000.0;
  plan.dwell = Duration::s(1.0);
  return plan;
}

inline Request request_of(VirtualAxis axis, std::uint64_t seed = 7) {
  return {plan_of({0.0, 12.3, 25.1, 50.7}), std::move(axis), {}, seed, ""};
}

inline Deviation um(double x) { return Deviation::native(x); }

}  // namespace axiometry::simulation
