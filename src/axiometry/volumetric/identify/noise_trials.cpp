// SPDX-License-Identifier: Apache-2.0
#include "axiometry/volumetric/identify/noise_trials.h"

#include <algorithm>
#include <cmath>

#include "axiometry/numeric/random/random.h"
#include "axiometry/volumetric/identify/identifier.h"

namespace axiometry::volumetric {

Result<NoiseTrials> noise_trials(const MachineModel& machine, const VolumetricLengths& lengths,
                                 const IdentifyOptions& options, std::size_t trials, std::uint64_t seed) {
  AXIOMETRY_TRY(detail::Identifier done, detail::Identifier::make(machine, lengths, options));
  AXIOMETRY_TRY_VOID(done.run());
  const detail::Problem problem = done.problem();
  const std::size_t n = done.coefficients().raw();
  std::vector<double> noise(lengths.readings.size()), sums(n, 0.0), squares(n, 0.0);
  for (std::size_t trial = 0; trial < trials; ++trial) {
    numeric::fill_normal({seed, 0, trial}, noise);
    for (std::size_t i = 0; i < noise.size(); ++i) noise[i] *= done.sigmas_um()[i];
    const std::vector<double> change = done.fit().solution.step(detail::gradient(problem, done.fit().beams, noise));
    for (std::size_t k = 0; k < n; ++k) {
      sums[k] += change[k];
      squares[k] += change[k] * change[k];
    }
  }
  NoiseTrials result{trials, std::vector<double>(n)};
  const double count = static_cast<double>(trials);
  for (std::size_t k = 0; k < n; ++k)
    result.sd[k] = std::sqrt(std::max(0.0, squares[k] - sums[k] * sums[k] / count) / (count - 1.0));
  return result;
}

}  // namespace axiometry::volumetric
