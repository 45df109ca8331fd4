// SPDX-License-Identifier: Apache-2.0
#include "axiometry/volumetric/identify/part_scales.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "axiometry/volumetric/identify/findings/tried_fit.h"

namespace axiometry::volumetric::detail {
namespace {

constexpr double share_of_station = 0.5;  // of the variance, which the parts of a station have in common
constexpr std::size_t parts_most = 300;
constexpr double well_told_least = 1e-2;  // of the largest eigenvalue
constexpr double told_least = 1e-4;  // of the largest sum of squares: what is less is what all parts have in common

const Strains all_axes{{1.0, 1.0, 1.0, 0.0, 0.0, 0.0}};

/// L of the correlation L Lᵀ of the parts.
Eigen::MatrixXd correlation_factor(const Problem& problem, std::span<const std::size_t> parts) {
  const auto n = static_cast<Eigen::Index>(parts.size());
  Eigen::MatrixXd correlation = Eigen::MatrixXd::Identity(n, n);
  const auto station_of = [&](Eigen::Index k) {
    return problem.unknowns.stations[parts[static_cast<std::size_t>(k)]].station;
  };
  for (Eigen::Index i = 0; i < n; ++i)
    for (Eigen::Index k = 0; k < n; ++k)
      if (i != k && station_of(i) == station_of(k)) correlation(i, k) = share_of_station;
  return correlation.llt().matrixL();
}

/// The normal equations of standard normal numbers that the scales are made of, by principal directions.
struct PrincipalScales {
  Eigen::MatrixXd scales;   ///< scales of the parts by a number of 1, column by column
  Eigen::VectorXd squares;  ///< λ; 0 where the lengths tell nothing
  Eigen::VectorXd rights;   ///< ρ

  bool is_told(Eigen::Index k) const { return squares[k] > 0.0; }
  /// What a handful of readings tell is no measure of how far parts differ.
  bool is_well_told(Eigen::Index k) const { return squares[k] > well_told_least * squares.maxCoeff(); }
};

PrincipalScales principal_scales(const StrainSystem& system, const Eigen::MatrixXd& factor) {
  const Eigen::MatrixXd matrix = factor.transpose() * system.matrix * factor;
  const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> solved(matrix);
  PrincipalScales principal{factor * solved.eigenvectors(), solved.eigenvalues(), {}};
  principal.rights = principal.scales.transpose() * system.right;
  const double least = told_least * system.whole.maxCoeff();
  for (double& square : principal.squares)
    if (!(square > least)) square = 0.0;
  return principal;
}

/// What their standard deviation σ may be: equally likely beforehand up to where the lengths rule it out, each with the
/// likelihood of what was found, Π N(ρ_k/√λ_k; 0, φ + λ_k σ²).
std::vector<std::pair<double, double>> weighted_spreads(const PrincipalScales& principal, double variance_factor) {
  constexpr std::size_t steps = 400;
  constexpr double times_largest = 4.0;
  double largest = 0.0;
  for (Eigen::Index k = 0; k < principal.squares.size(); ++k)
    if (principal.is_well_told(k)) largest = std::max(largest, std::abs(principal.rights[k]) / principal.squares[k]);
  std::vector<std::pair<double, double>> weighted;
  double best = -std::numeric_limits<double>::infinity(), sum = 0.0;
  for (std::size_t s = 0; s < steps; ++s) {
    const double spread = times_largest * largest * (static_cast<double>(s) + 0.5) / static_cast<double>(steps);
    double log = 0.0;
    for (Eigen::Index k = 0; k < principal.squares.size(); ++k) {
      if (!principal.is_told(k)) continue;
      const double variance = variance_factor + principal.squares[k] * spread * spread;
      log -= 0.5 * (std::log(variance) + principal.rights[k] * principal.rights[k] / principal.squares[k] / variance);
    }
    weighted.emplace_back(spread, log);
    best = std::max(best, log);
  }
  for (auto& [spread, weight] : weighted) sum += weight = std::exp(weight - best);
  for (auto& [spread, weight] : weighted) weight /= sum;
  return weighted;
}

/// Mean and covariance of the scales over all that σ may be: of a normal one each is ρσ²/(φ + λσ²) with variance
/// φσ²/(φ + λσ²).
void take_moments(const PrincipalScales& principal, double variance_factor, PartScaleFit& found) {
  const Eigen::Index n = principal.squares.size();
  Eigen::VectorXd mean = Eigen::VectorXd::Zero(n), variance = Eigen::VectorXd::Zero(n);
  Eigen::MatrixXd products = Eigen::MatrixXd::Zero(n, n);
  double square = 0.0;
  for (const auto& [spread, weight] : weighted_spreads(principal, variance_factor)) {
    const double prior = spread * spread;
    const Eigen::VectorXd share = (variance_factor + prior * principal.squares.array()).inverse() * prior;
    Eigen::VectorXd likeliest = share.cwiseProduct(principal.rights);
    for (Eigen::Index k = 0; k < n; ++k)
      if (!principal.is_told(k)) likeliest[k] = 0.0;
    mean += weight * likeliest;
    variance += weight * variance_factor * share;
    products += weight * likeliest * likeliest.transpose();
    square += weight * prior;
    for (Eigen::Index k = 0; k < n; ++k) found.taken += weight * share[k] * principal.squares[k];
  }
  products -= mean * mean.transpose();
  products.diagonal() += variance;
  found.spread_um_per_m = std::sqrt(square);
  found.um_per_m = principal.scales * mean;
  found.covariance = principal.scales * products * principal.scales.transpose();
}

}  // namespace

std::optional<PartScaleFit> part_scale_fit(const Problem& problem, const Fit& fit, double degrees_of_freedom,
                                           Vector3 middle_mm) {
  const std::vector<VirtualStation>& stations = problem.unknowns.stations;
  std::vector<ReadingGroup> readings(stations.size());
  for (std::size_t i = 0; i < problem.readings.size(); ++i)
    readings[problem.unknowns.stretches[problem.unknowns.stretch_of[i]].virtual_station].push_back(i);
  const auto counts = [&](const ReadingGroup& group) {
    return std::ranges::any_of(group, [&](std::size_t i) { return problem.weights[i] > 0.0; });
  };
  PartScaleFit found;
  for (std::size_t v = 0; v < stations.size(); ++v)
    if (counts(readings[v])) found.parts.push_back(v);
  std::erase_if(readings, [&](const ReadingGroup& group) { return !counts(group); });
  if (found.parts.size() < 2 || found.parts.size() > parts_most) return std::nullopt;

  StrainSystem system = strain_system(problem, fit, readings, {&all_axes, 1}, middle_mm);
  const PrincipalScales principal = principal_scales(system, correlation_factor(problem, found.parts));
  Gained gained;
  for (Eigen::Index k = 0; k < principal.squares.size(); ++k) {
    if (!principal.is_told(k)) continue;
    gained.chi_squared += principal.rights[k] * principal.rights[k] / principal.squares[k];
    gained.unknowns += 1.0;
    found.directions += principal.is_well_told(k) ? 1.0 : 0.0;
  }
  const FitQuality larger{fit.chi_squared - gained.chi_squared, degrees_of_freedom - gained.unknowns};
  if (gained.unknowns < 1.0 || larger.degrees_of_freedom < 1.0) return std::nullopt;
  const bool all_explained = !(larger.chi_squared > 0.0) && gained.chi_squared > gained.unknowns;  // but for rounding
  found.chance = all_explained ? 0.0 : chance_of(gained, larger);
  found.about_mm = middle_mm;
  take_moments(principal, std::max(1.0, larger.ratio()), found);
  found.in_readings_um = strains_in_readings(problem, fit, readings, {&all_axes, 1}, middle_mm, found.um_per_m);
  found.steps = std::move(system.steps);
  return found;
}

void take_out(const PartScaleFit& scales, const Problem& problem, Fit& fit) {
  std::vector<double> change(problem.unknowns.columns, 0.0);
  for (std::size_t p = 0; p < scales.steps.size(); ++p)
    for (std::size_t k = 0; k < change.size(); ++k)
      change[k] -= scales.steps[p][k] * scales.um_per_m[static_cast<Eigen::Index>(p)];
  add_step(problem.unknowns, change, fit.state);
  fit.residuals_um = sights(problem, fit.state).residuals_um;
  for (std::size_t i = 0; i < fit.residuals_um.size(); ++i) fit.residuals_um[i] -= scales.in_readings_um[i];
  fit.chi_squared = chi_squared(problem, fit.residuals_um);
}

std::vector<double> covariance_by_scales(const PartScaleFit& scales, std::size_t column, std::size_t count) {
  const auto n = static_cast<Eigen::Index>(count);
  Eigen::MatrixXd steps(n, scales.um_per_m.size());
  for (Eigen::Index p = 0; p < steps.cols(); ++p)
    for (Eigen::Index k = 0; k < n; ++k)
      steps(k, p) = scales.steps[static_cast<std::size_t>(p)][column + static_cast<std::size_t>(k)];
  const Eigen::MatrixXd left = steps * scales.covariance, covariance = left * steps.transpose();
  return {covariance.data(), covariance.data() + covariance.size()};  // symmetric: by columns as by rows
}

}  // namespace axiometry::volumetric::detail
