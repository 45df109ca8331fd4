// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cmath>

#include "axiometry/standards/iso230_2/monte_carlo/posterior.h"

namespace axiometry::iso230_2 {

/// The level that was seen is that of the machine and the mean of n shifts ρ_j + d_j, and any level is as likely as any
/// other before the test: of the long run that mean is an error, of the variance (σ_ρ² + u_d²)/n. Of readings only the
/// mean of d is, u_d²/n; draw_run_shifts() has given each run some of it already, for the machine's share w of what is
/// seen of a run w (u_d² + u²/C), less what single readings bring.
std::vector<double> ReadingPosterior::draw_levels(numeric::RandomKey key, numeric::RandomKey own, std::size_t trials,
                                                  Asked asked) const {
  std::vector<double> levels(trials, 0.0);
  if (exact_ && asked == Asked::readings) return levels;
  const std::size_t cells = cells_.size();
  std::vector<double> uniforms(uniforms_each() * trials), sds(cells * trials), run_sds(trials), normals(trials);
  numeric::fill_uniform({key.seed, key.stream, 2 * key.block}, uniforms);
  draw_spreads(uniforms, {sds, trials}, run_sds);
  numeric::fill_normal(own, normals);
  const double u2 = noise_.reading * noise_.reading, of_run = noise_.run * noise_.run;
  for (std::size_t t = 0; t < trials; ++t) {
    double variance = of_run;
    const double of_machine = run_sds[t] * run_sds[t];
    if (asked == Asked::long_run) {
      variance += of_machine;
    } else if (cells_per_run_ > 0.0 && of_run > 0.0) {
      double scatter = 0.0;
      for (std::size_t c = 0; c < cells; ++c) scatter += sds[c * trials + t] * sds[c * trials + t] / double(cells);
      const double machine = of_machine + scatter / cells_per_run_, measured = of_run + u2 / cells_per_run_;
      const double of_readings = scatter > 0.0 ? scatter / (scatter + u2) * u2 / cells_per_run_ : 0.0;
      variance -= std::max(0.0, machine / (machine + measured) * measured - of_readings);
    }
    levels[t] = std::sqrt(std::max(0.0, variance) / static_cast<double>(runs_)) * normals[t];
  }
  return levels;
}

}  // namespace axiometry::iso230_2
