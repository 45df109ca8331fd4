// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "axiometry/base/text/number_text.h"
#include "axiometry/volumetric/field/error_model.h"
#include "axiometry/volumetric/identify/identifier.h"
#include "axiometry/volumetric/identify/smoothing.h"

namespace axiometry::volumetric::detail {
Result<void> check_smoothness(const IdentifyOptions& options) {
  const Smoothness& asked = options.smoothness;
  if (asked.kind == Smoothness::Kind::none) return {};
  if (options.curves == CurveKind::legendre)
    return fail(
        "found Legendre polynomials that are to be smooth, expected b-spline or nodes: polynomials are as smooth as "
        "their degree");
  if (asked.kind == Smoothness::Kind::automatic) return {};
  for (const double bend : {asked.displacement_um, asked.rotation_urad})
    if (!(bend >= Smoothness::least && bend <= Smoothness::most))
      return fail(fmt::format("found a smoothness of {}, expected {} to {} (µm, µrad)", format_exact(bend),
                              Smoothness::least, format_exact(Smoothness::most)));
  return {};
}

/// From a fit by the lengths alone, which says what they do not tell and how far they scatter.
Result<void> Identifier::smooth() {
  const Smoothness& asked = options_.smoothness;
  if (asked.kind == Smoothness::Kind::none) return {};
  AXIOMETRY_TRY_VOID(take_finer_sizes());
  const std::size_t told = fit_->solution.told();
  const double nu = static_cast<double>(count()) - static_cast<double>(told);
  const double factor = nu > 0.0 ? std::max(1.0, fit_->chi_squared / nu) : 1.0;
  plain_variances_ = mean_variances(*coefficients_, fit_->solution.coefficient_covariance());
  CurvaturePenalty penalty(*coefficients_, fit_->solution.unseen_errors());
  Bends bends{asked.displacement_um, asked.rotation_urad};
  penalty.set({1.0, 1.0}, factor);
  if (asked.kind == Smoothness::Kind::automatic) {
    const LikeliestBends likeliest = likeliest_bends(problem(), *fit_, penalty);
    bends = likeliest.bends;
    bends_settled_ = likeliest.settled;
  }
  penalty.set(bends, factor);
  penalty_ = std::move(penalty);
  return refit();
}

}  // namespace axiometry::volumetric::detail
