// SPDX-License-Identifier: Apache-2.0
#include <algorithm>

#include "axiometry/volumetric/identify/identifier.h"

namespace axiometry::volumetric::detail {
namespace {

constexpr std::size_t breaks_most = 200;
constexpr std::size_t drop_rounds = 6;

}  // namespace

/// Among all readings: those behind a break that is not known yet were set aside.
Result<void> Identifier::find_breaks() {
  if (!options_.find_breaks) return {};
  while (breaks_.size() < breaks_most) {
    const std::vector<double> stated = stated_weights();
    Problem all = problem();
    all.weights = stated;
    const auto found = clearest_break(all, fit_->residuals_um);
    if (!found) return {};
    breaks_.insert(std::ranges::upper_bound(breaks_, found->before), found->before);
    weights_ = stated;
    aside_.assign(aside_.size(), false);
    AXIOMETRY_TRY_VOID(start());
    AXIOMETRY_TRY_VOID(refit());
    AXIOMETRY_TRY_VOID(find_outliers());
  }
  return {};
}

/// In few rounds: with each that is gone others may be less clear.
Result<void> Identifier::drop_unclear_breaks() {
  for (std::size_t round = 0; round < drop_rounds; ++round) {
    const Problem fitted = problem();
    if (std::erase_if(breaks_, [&](std::size_t before) { return !is_clear_break(fitted, *fit_, before); }) == 0) break;
    AXIOMETRY_TRY_VOID(start());
    AXIOMETRY_TRY_VOID(refit());
    AXIOMETRY_TRY_VOID(find_outliers());
  }
  return {};
}

}  // namespace axiometry::volumetric::detail
