// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cmath>
#include <utility>

#include "axiometry/volumetric/identify/identifier.h"

namespace axiometry::volumetric::detail {
namespace {

constexpr std::size_t breaks_most = 200;
constexpr std::size_t heeded_from = 8;  // readings set aside, more than outliers of a short stretch
constexpr std::size_t settling_rounds = 8;
constexpr std::size_t rounds_to_narrow = 4;  // then the ranges of readings in doubt only grow

}  // namespace

/// Among all readings: those behind a break that is not known yet were set aside.
Result<void> Identifier::find_breaks() {
  if (!options_.find_breaks) return {};
  while (judged_.breaks.size() < breaks_most) {
    const bool heeded = heed_stretches_set_aside();
    if (heeded) AXIOMETRY_TRY_VOID(refit());
    const std::vector<double> stated = stated_weights();
    Problem all = problem();
    all.weights = stated;
    const auto found = clearest_break(all, fit_->residuals_um);
    if (!found) return heeded ? find_outliers() : Result<void>{};
    judged_.breaks.insert(std::ranges::upper_bound(judged_.breaks, found->before), found->before);
    judged_.weights = stated;
    judged_.aside.assign(judged_.aside.size(), false);
    AXIOMETRY_TRY_VOID(start());
    AXIOMETRY_TRY_VOID(refit());
    AXIOMETRY_TRY_VOID(find_outliers());
    AXIOMETRY_TRY_VOID(settle_breaks());
  }
  return {};
}

/// Of a stretch with a large break a station found elsewhere may fit a few readings alone, with nearly all set aside:
/// then nothing shows that these are two halves. Whether there was such a stretch.
bool Identifier::heed_stretches_set_aside() {
  std::vector<std::size_t> readings(unknowns_->stretches.size()), aside(readings.size());
  for (std::size_t i = 0; i < judged_.aside.size(); ++i) {
    ++readings[unknowns_->stretch_of[i]];
    if (judged_.aside[i]) ++aside[unknowns_->stretch_of[i]];
  }
  const std::vector<double> stated = stated_weights();
  bool heeded = false;
  for (std::size_t i = 0; i < judged_.aside.size(); ++i) {
    const std::size_t stretch = unknowns_->stretch_of[i];
    if (!judged_.aside[i] || aside[stretch] < heeded_from || 2 * aside[stretch] <= readings[stretch]) continue;
    heeded = true;
    judged_.aside[i] = false;
    judged_.weights[i] = stated[i];
  }
  return heeded;
}

/// Breaks without a drift, where these explain the lengths better than the drift that was found: of one break curves
/// take up a part that shows in all stretches, as a drift does.
Result<void> Identifier::take_breaks_for_drift() {
  if (!options_.find_breaks) return {};
  const double scale = robust_scale(problem(), fit_->residuals_um);
  const double cost_of_drift = cost_of_dead_paths(scale);
  const Judged with_drift = judged_;
  const std::size_t before = judged_.breaks.size();
  AXIOMETRY_TRY_VOID(fit_with_drift(false));
  AXIOMETRY_TRY_VOID(find_breaks());
  if (judged_.breaks.size() > before && cost_of_dead_paths(scale) < cost_of_drift) return {};
  judged_ = with_drift;
  return fit_with_drift(true);
}

/// Σ min(v/sσ, L)² of the lengths, L that beyond which they are set aside, and of each break and drift what it must
/// take of that to be believed: 30 + 4 ln n as of clearest_break(), ln n as by Schwarz.
double Identifier::cost_of_dead_paths(double scale) const {
  const std::vector<double> weights = instrument_weights();
  const double limit = outlier_limit(weights.size());
  double cost = 0.0;
  for (std::size_t i = 0; i < weights.size(); ++i) {
    const double z = std::sqrt(weights[i]) * fit_->residuals_um[i] / scale;
    cost += std::min(z * z, limit * limit);
  }
  const double drifts = drift_ ? static_cast<double>(unknowns_->stretches.size()) : 0.0;
  return cost + static_cast<double>(judged_.breaks.size()) * break_limit(count()) +
         drifts * std::log(static_cast<double>(count()));
}

/// One by one: with each that is gone the stretch beside the next one is longer.
Result<void> Identifier::drop_unclear_breaks() {
  AXIOMETRY_TRY_VOID(settle_breaks());
  while (const auto unclear = least_clear_break(problem(), fit_->state, fit_->residuals_um, judged_.breaks)) {
    std::erase(judged_.breaks, *unclear);
    std::erase_if(judged_.places, [&](const BreakPlace& place) { return place.before == *unclear; });
    AXIOMETRY_TRY_VOID(start());
    AXIOMETRY_TRY_VOID(refit());
    AXIOMETRY_TRY_VOID(find_outliers());
    AXIOMETRY_TRY_VOID(settle_breaks());
  }
  return {};
}

/// A reading on the wrong side of a break bends curves, or is set aside though nothing is wrong with it. Readings in
/// doubt are left out of the fit that says whether they still are: what was fitted to a reading speaks for itself.
Result<void> Identifier::settle_breaks() {
  bool moved = false;
  for (std::size_t round = 0; round < settling_rounds; ++round) {
    const std::vector<double> everything = instrument_weights();
    Problem all = problem();
    all.weights = everything;
    std::vector<BreakPlace> places = break_places(all, fit_->state, fit_->residuals_um, judged_.breaks);
    if (round >= rounds_to_narrow)
      for (std::size_t k = 0; k < places.size(); ++k) {
        places[k].earliest = std::min(places[k].earliest, judged_.places[k].earliest);
        places[k].latest = std::max(places[k].latest, judged_.places[k].latest);
      }
    if (!take_places(std::move(places))) break;
    moved = true;
    AXIOMETRY_TRY_VOID(refit());
    if (options_.find_outliers && set_aside_beyond_limit()) AXIOMETRY_TRY_VOID(refit());
  }
  if (moved) return find_outliers();
  return {};
}

/// Whether anything that is fitted changed. The stretches stay as many, and in their order.
bool Identifier::take_places(std::vector<BreakPlace> places) {
  std::ranges::sort(places, {}, &BreakPlace::before);  // places of interleaved segments may have changed their order
  std::vector<std::size_t> breaks;
  for (const BreakPlace& place : places) breaks.push_back(place.before);
  const Unknowns unknowns = unknowns_of(*coefficients_, lengths_.readings, breaks, drift_);
  std::vector<bool> doubtful(judged_.doubtful.size(), false);
  for (const BreakPlace& place : places) {
    const std::size_t from = stretch_before(unknowns, place.before), to = unknowns.stretch_of[place.before];
    for (std::size_t i = place.earliest; i < place.latest; ++i)
      doubtful[i] = unknowns.stretch_of[i] == from || unknowns.stretch_of[i] == to;
  }
  judged_.places = std::move(places);
  if (breaks == judged_.breaks && doubtful == judged_.doubtful) return false;
  judged_.breaks = std::move(breaks);
  judged_.doubtful = std::move(doubtful);
  unknowns_ = unknowns;
  weigh_what_is_used();
  return true;
}

}  // namespace axiometry::volumetric::detail
