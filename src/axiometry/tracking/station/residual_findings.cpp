// SPDX-License-Identifier: Apache-2.0
#include "axiometry/tracking/station/residual_findings.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>
#include <vector>

#include "axiometry/numeric/distributions/normal_and_student_t.h"
#include "axiometry/numeric/median.h"

namespace axiometry::tracking {

namespace {

constexpr double serious_ratio = 9.0;    // residuals three times as large as stated
constexpr std::size_t few_at_most = 10;  // degrees of freedom: beyond, Student's t for 95 % is 2.2 or less

}  // namespace

std::optional<Finding> chi_squared_finding(double chi_squared, std::size_t degrees_of_freedom) {
  if (degrees_of_freedom == 0) return std::nullopt;
  const auto nu = static_cast<double>(degrees_of_freedom);
  const double ratio = chi_squared / nu;
  const double part = 2.0 / (9.0 * nu);
  const auto bound = [&](double z) { return std::pow(std::max(1.0 - part + z * std::sqrt(part), 0.0), 3.0); };
  if (ratio > bound(3.09))
    return Finding{"tracking-residuals-large", ratio > serious_ratio,
                   fmt::format("the residuals are {:.2f} times as large as stated (χ²/ν = {:.2f}, "
                               "ν = {}); all covariances were multiplied by {:.2f}",
                               std::sqrt(ratio), ratio, degrees_of_freedom, ratio)};
  if (ratio < bound(-3.09) && nu >= 3.0)
    return Finding{"tracking-residuals-small", false,
                   fmt::format("the residuals are {:.2g} times as large as stated (χ²/ν = {:.2g}, ν = {}): "
                               "the uncertainty of the readings is stated too large",
                               std::sqrt(ratio), ratio, degrees_of_freedom)};
  return std::nullopt;
}

std::optional<Finding> few_residuals_finding(double chi_squared, std::size_t degrees_of_freedom) {
  const auto nu = static_cast<double>(degrees_of_freedom);
  if (degrees_of_freedom == 0 || degrees_of_freedom > few_at_most || !(chi_squared > nu)) return std::nullopt;
  return Finding{
      "tracking-residuals-few", false,
      fmt::format("how much larger than stated the residuals are is known with ν = {} only: 95 % needs {:.3g} "
                  "times the standard uncertainties, not 2",
                  degrees_of_freedom, numeric::student_t_quantile(0.975, nu))};
}

double outlier_limit(std::span<const double> normalised) {
  std::vector<double> sizes;
  for (const double x : normalised)
    if (x != 0.0) sizes.push_back(std::abs(x));
  if (sizes.size() < 3) return std::numeric_limits<double>::infinity();
  const auto n = static_cast<double>(sizes.size());
  // The median of |x| of a normal x is 0.6745 σ.
  const double scale = std::max(1.0, numeric::upper_median(std::move(sizes)) / 0.6745);
  return -numeric::normal_quantile(0.025 / n) * scale;
}

}  // namespace axiometry::tracking
