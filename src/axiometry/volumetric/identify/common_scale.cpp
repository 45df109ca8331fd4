// SPDX-License-Identifier: Apache-2.0
#include "axiometry/volumetric/identify/common_scale.h"

namespace axiometry::volumetric::detail {

void add_common_scale(const Problem& problem, const State& state, std::span<const Vector3> beams,
                      const LinearSolution& solution, std::vector<double>& covariance) {
  if (!problem.machine.scale_uncertainty) return;
  std::vector<double> distances_m;  // in metres: a scale error of 1 µm/m changes each length by as many micrometres
  for (std::size_t i = 0; i < problem.readings.size(); ++i) {
    const Vector3 s = state.stations_mm[problem.unknowns.stretches[problem.unknowns.stretch_of[i]].virtual_station];
    distances_m.push_back(1e-3 * distance(problem.readings[i].axes_mm + problem.tool_mm(i), s));
  }
  const std::vector<double> change = solution.step(gradient(problem, beams, distances_m));
  const std::size_t n = problem.coefficients.raw();
  const double u = problem.machine.scale_uncertainty->in_um_per_m();
  for (std::size_t i = 0; i < n; ++i)
    for (std::size_t k = 0; k < n; ++k) covariance[i * n + k] += u * u * change[i] * change[k];
}

}  // namespace axiometry::volumetric::detail
