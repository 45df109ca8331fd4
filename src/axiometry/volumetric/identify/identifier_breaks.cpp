// SPDX-License-Identifier: Apache-2.0
#include <algorithm>

#include "axiometry/volumetric/identify/identifier.h"

namespace axiometry::volumetric::detail {
namespace {

constexpr std::size_t breaks_most = 200;

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

/// One by one: with each that is gone the stretch beside the next one is longer.
Result<void> Identifier::drop_unclear_breaks() {
  while (const auto unclear = least_clear_break(problem(), fit_->state, fit_->residuals_um, breaks_)) {
    std::erase(breaks_, *unclear);
    AXIOMETRY_TRY_VOID(start());
    AXIOMETRY_TRY_VOID(refit());
    AXIOMETRY_TRY_VOID(find_outliers());
  }
  return {};
}

}  // namespace axiometry::volumetric::detail
