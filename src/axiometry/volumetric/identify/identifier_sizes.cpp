// SPDX-License-Identifier: Apache-2.0
#include <algorithm>

#include "axiometry/volumetric/identify/equations/thinned_problem.h"
#include "axiometry/volumetric/identify/identifier.h"

/// How finely curves may bend: the part of Identifier that chooses it.
namespace axiometry::volumetric::detail {
namespace {

constexpr std::size_t choice_readings_most = 40'000;  // sizes of curves are chosen on so many

}  // namespace

/// A fit with these sizes, of some of the readings where these are very many.
std::optional<Identifier::Trial> Identifier::trial(const Sizes& sizes) const {
  const auto coefficients = coefficients_of(sizes);
  if (!coefficients) return std::nullopt;
  const Unknowns unknowns = unknowns_of(*coefficients, lengths_.readings, judged_.breaks, drift_);
  State state = fit_->state;
  state.coefficients.assign(coefficients->raw(), 0.0);
  const std::size_t step = lengths_.readings.size() / choice_readings_most + 1;
  std::vector<std::size_t> some;
  std::size_t used = 0;
  for (std::size_t i = 0; i < judged_.weights.size(); i += step) {
    some.push_back(i);
    if (judged_.weights[i] > 0.0) ++used;
  }
  if (used < coefficients->free() + unknowns.columns - coefficients->raw() + 2) return std::nullopt;
  const ThinnedProblem few({machine_, *coefficients, unknowns, lengths_.readings, tools_mm_, approaches_,
                            judged_.weights, threads(), nullptr, options_.stop},
                           some);
  const auto fit = least_squares(few.problem(), std::move(state));
  if (!fit) return std::nullopt;
  const std::optional<double> value = akaike(fit->chi_squared, used, fit->solution.told());
  if (!value) return std::nullopt;
  return Trial{*value, fit->solution.unseen_errors()};
}

/// Finer curves may ask the points for more than they tell, as where an axis came to its ends from one side alone:
/// none is worth an error that coarser ones tell. What cubics leave untold, no spline tells; other curves seem to.
std::optional<double> Identifier::criterion(const Sizes& sizes, const std::optional<Trial>& coarsest) const {
  std::optional<Trial> tried = trial(sizes);
  if (!tried) return std::nullopt;
  if (options_.curves == CurveKind::spline && coarsest && !std::ranges::includes(coarsest->unseen, tried->unseen))
    return std::nullopt;
  return tried->akaike;
}

/// The criterion takes the fewest spans that the residuals allow, and what these leave out is in no covariance: one
/// step finer, where there are at least twice as many lengths as unknowns then (docs/studies/volumetric-coverage.md).
Sizes Identifier::with_margin(Sizes sizes, const std::optional<Trial>& coarsest) const {
  const Sizes least = sizes;
  for (std::size_t a = 0; a < axis_count; ++a) {
    const auto finer = std::ranges::upper_bound(supported_[a], sizes[a]);
    if (finer != supported_[a].end()) sizes[a] = *finer;
  }
  const auto coefficients = coefficients_of(sizes);
  const std::size_t others = unknowns_->columns - coefficients_->raw();
  const bool is_well_told = coefficients && count() >= 2 * (coefficients->free() + others);
  return is_well_told && criterion(sizes, coarsest) ? sizes : least;
}

Result<void> Identifier::choose_sizes() {
  const bool all_given = std::ranges::none_of(options_.sizes, [](std::size_t size) { return size == 0; });
  if (all_given) return {};
  const auto coarsest = trial({supported_[0].front(), supported_[1].front(), supported_[2].front()});
  const Sizes least = chosen_sizes(supported_, [&](const Sizes& sizes) { return criterion(sizes, coarsest); });
  const Sizes chosen = with_margin(least, coarsest);
  if (chosen == sizes_) return {};
  AXIOMETRY_TRY_VOID(take_sizes(chosen));
  AXIOMETRY_TRY_VOID(start());
  return refit();
}

/// How far smooth curves may bend is the smoothness' to say, not the spans': twice as many where the places carry them,
/// and there are twice as many lengths as unknowns. What is given stays.
Result<void> Identifier::take_finer_sizes() {
  Sizes finer = sizes_;
  for (std::size_t a = 0; a < axis_count; ++a)
    for (const std::size_t size : supported_[a])
      if (size <= 2 * sizes_[a]) finer[a] = std::max(finer[a], size);
  const auto coefficients = coefficients_of(finer);
  const std::size_t others = unknowns_->columns - coefficients_->raw();
  if (finer == sizes_ || !coefficients || count() < 2 * (coefficients->free() + others)) return {};
  // None is worth an error that the present ones tell, nor a fit that fails.
  if (!criterion(finer, trial(sizes_))) return {};
  AXIOMETRY_TRY_VOID(take_sizes(finer));
  AXIOMETRY_TRY_VOID(start());
  return refit();
}

}  // namespace axiometry::volumetric::detail
