// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "axiometry/base/result.h"
#include "axiometry/standards/iso230_2/monte_carlo/monte_carlo.h"
#include "axiometry/standards/iso230_2/monte_carlo/settled_trials.h"

/// The mean deviations at the targets by the Monte Carlo method: what Lira & Cargill, Precision Engineering 28 (2004)
/// 232, state by the law of propagation in their Fig. 3 and Tables 5 and 6. Private to monte_carlo/.
namespace axiometry::iso230_2 {

/// At which targets: all of no more than `most`, else that many from the first to the last, equally far apart in their
/// order.
std::vector<std::size_t> targets_of_means(std::size_t target_count, std::size_t most);

/// Trials of one model for each hypothesis about the noise (at least one), as the parameters are drawn. A mean on which
/// nothing acts is absent: ±0 would be a false claim. Fails as uncertainty::propagate().
Result<std::vector<MeanDistribution>> mean_distributions(std::span<const SettledTrials> models,
                                                         const Evaluation& evaluation,
                                                         std::span<const std::size_t> targets,
                                                         const uncertainty::PropagationOptions& options);

}  // namespace axiometry::iso230_2
