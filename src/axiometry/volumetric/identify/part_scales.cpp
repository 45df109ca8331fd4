// SPDX-License-Identifier: Apache-2.0
#include "axiometry/volumetric/identify/part_scales.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <set>
#include <utility>

#include "axiometry/volumetric/identify/equations/fit_quality.h"

namespace axiometry::volumetric::detail {
namespace {

constexpr std::array station_shares{0.1, 0.5, 0.9, 0.99, 0.999};  // of the variance, equally likely beforehand
constexpr double usual_share = 0.5;
constexpr double directions_least = 4.0;  // of fewer the spread has no mean square
constexpr double well_told_least = 1e-2;  // of the largest eigenvalue
constexpr double told_least = 1e-4;  // of the largest sum of squares: what is less is what all parts have in common

const Strains all_axes{{1.0, 1.0, 1.0, 0.0, 0.0, 0.0}};

/// Σ of the parts where σ = 1, with the share of the variance that the parts of a station have in common.
Eigen::MatrixXd correlation(const Problem& problem, std::span<const std::size_t> parts, double share) {
  const auto n = static_cast<Eigen::Index>(parts.size());
  Eigen::MatrixXd correlation = Eigen::MatrixXd::Identity(n, n);
  const auto station_of = [&](Eigen::Index k) {
    return problem.unknowns.stations[parts[static_cast<std::size_t>(k)]].station;
  };
  for (Eigen::Index i = 0; i < n; ++i)
    for (Eigen::Index k = 0; k < n; ++k)
      if (i != k && station_of(i) == station_of(k)) correlation(i, k) = share;
  return correlation;
}

/// The normal equations of standard normal numbers that the scales are made of, by principal directions.
struct PrincipalScales {
  Eigen::MatrixXd scales;   ///< scales of the parts by a number of 1, column by column
  Eigen::VectorXd squares;  ///< λ; 0 where the lengths tell nothing
  Eigen::VectorXd rights;   ///< ρ; 0 likewise
  double largest_square = 0.0;

  bool is_told(Eigen::Index k) const { return squares[k] > 0.0; }
  /// What a handful of readings tell is no measure of how far parts differ.
  bool is_well_told(Eigen::Index k) const { return squares[k] > well_told_least * largest_square; }

  double well_told() const {
    double count = 0.0;
    for (Eigen::Index k = 0; k < squares.size(); ++k) count += is_well_told(k) ? 1.0 : 0.0;
    return count;
  }

  /// What χ² loses by scales that nothing is known of beforehand: the same for every correlation.
  Gained gained() const {
    Gained gained;
    for (Eigen::Index k = 0; k < squares.size(); ++k)
      if (is_told(k)) gained = {gained.chi_squared + rights[k] * rights[k] / squares[k], gained.unknowns + 1.0};
    return gained;
  }
};

PrincipalScales principal_scales(const StrainSystem& system, const Eigen::MatrixXd& correlation) {
  const Eigen::MatrixXd factor = correlation.llt().matrixL();
  const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> solved(factor.transpose() * system.matrix * factor);
  PrincipalScales principal{factor * solved.eigenvectors(), solved.eigenvalues(), {}};
  principal.rights = principal.scales.transpose() * system.right;
  principal.largest_square = principal.squares.maxCoeff();
  const double least = told_least * system.whole.maxCoeff();
  for (Eigen::Index k = 0; k < principal.squares.size(); ++k)
    if (!(principal.squares[k] > least)) principal.squares[k] = principal.rights[k] = 0.0;
  return principal;
}

/// One for each share of the station; of parts that all have one station, or each its own, nothing tells the share.
std::vector<PrincipalScales> principal_by_share(const Problem& problem, std::span<const std::size_t> parts,
                                                const StrainSystem& system) {
  std::set<std::size_t> stations;
  for (const std::size_t part : parts) stations.insert(problem.unknowns.stations[part].station);
  const bool is_told = stations.size() > 1 && stations.size() < parts.size();
  std::vector<PrincipalScales> by_share;
  for (const double share : station_shares)
    if (is_told || share == usual_share)
      by_share.push_back(principal_scales(system, correlation(problem, parts, share)));
  return by_share;
}

/// A standard deviation of the parts with a share, and how likely both are.
struct Spread {
  const PrincipalScales* of = nullptr;
  double um_per_m = 0.0;
  double weight = 0.0;
};

/// Equally likely beforehand up to where the lengths rule σ out, each with the likelihood of what was found,
/// Π N(ρ_k/√λ_k; 0, φ + λ_k σ²), by that of σ = 0: so a direction of which the lengths tell next to nothing weighs
/// nothing.
std::vector<Spread> weighted_spreads(std::span<const PrincipalScales> by_share, double variance_factor) {
  constexpr std::size_t steps = 400;
  constexpr double times_largest = 4.0;
  double largest = 0.0;
  for (const PrincipalScales& principal : by_share)
    for (Eigen::Index k = 0; k < principal.squares.size(); ++k)
      if (principal.is_well_told(k)) largest = std::max(largest, std::abs(principal.rights[k]) / principal.squares[k]);
  std::vector<Spread> spreads;
  double best = -std::numeric_limits<double>::infinity(), sum = 0.0;
  for (const PrincipalScales& principal : by_share)
    for (std::size_t s = 0; s < steps; ++s) {
      const double spread = times_largest * largest * (static_cast<double>(s) + 0.5) / static_cast<double>(steps);
      double log = 0.0;
      for (Eigen::Index k = 0; k < principal.squares.size(); ++k) {
        if (!principal.is_told(k)) continue;
        const double variance = variance_factor + principal.squares[k] * spread * spread;
        const double gained = principal.rights[k] * principal.rights[k] / principal.squares[k];
        log += 0.5 * (gained * (1.0 / variance_factor - 1.0 / variance) - std::log(variance / variance_factor));
      }
      spreads.push_back({&principal, spread, log});
      best = std::max(best, log);
    }
  for (Spread& spread : spreads) sum += spread.weight = std::exp(spread.weight - best);
  for (Spread& spread : spreads) spread.weight /= sum;
  return spreads;
}

/// As likely to be more as to be less: a few stations leave open that it is many times as large, and a mean square
/// would be that.
double median_of(std::vector<Spread> spreads) {
  std::ranges::sort(spreads, {}, &Spread::um_per_m);
  double below = 0.0;
  for (const Spread& spread : spreads)
    if ((below += spread.weight) >= 0.5) return spread.um_per_m;
  return 0.0;
}

/// Mean and covariance of the scales over all that σ and the share may be: of normal ones each is ρσ²/(φ + λσ²) with
/// variance φσ²/(φ + λσ²).
void take_moments(std::span<const PrincipalScales> by_share, double variance_factor, PartScaleFit& found) {
  const Eigen::Index n = by_share.front().squares.size();
  Eigen::VectorXd mean = Eigen::VectorXd::Zero(n);
  Eigen::MatrixXd second_moment = Eigen::MatrixXd::Zero(n, n);
  const std::vector<Spread> spreads = weighted_spreads(by_share, variance_factor);
  for (const PrincipalScales& principal : by_share) {
    Eigen::VectorXd own_mean = Eigen::VectorXd::Zero(n), variance = Eigen::VectorXd::Zero(n);
    Eigen::MatrixXd products = Eigen::MatrixXd::Zero(n, n);
    for (const auto& [of, spread, weight] : spreads) {
      if (of != &principal) continue;
      const double prior = spread * spread;
      const Eigen::VectorXd left_open = (variance_factor + prior * principal.squares.array()).inverse() * prior;
      const Eigen::VectorXd likeliest = left_open.cwiseProduct(principal.rights);
      own_mean += weight * likeliest;
      variance += weight * variance_factor * left_open;
      products.selfadjointView<Eigen::Lower>().rankUpdate(likeliest, weight);
      found.taken += weight * left_open.dot(principal.squares);
    }
    products.diagonal() += variance;
    mean += principal.scales * own_mean;
    second_moment += principal.scales * products.selfadjointView<Eigen::Lower>() * principal.scales.transpose();
  }
  found.told.spread_um_per_m = median_of(spreads);
  found.um_per_m = mean;
  found.covariance = second_moment - mean * mean.transpose();
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
  const std::vector<PrincipalScales> by_share = principal_by_share(problem, found.parts, system);
  const Gained gained = by_share.front().gained();
  const FitQuality larger{fit.chi_squared - gained.chi_squared, degrees_of_freedom - gained.unknowns};
  if (gained.unknowns < 1.0 || larger.degrees_of_freedom < 1.0) return std::nullopt;
  const bool all_explained = !(larger.chi_squared > 0.0) && gained.chi_squared > gained.unknowns;  // but for rounding
  found.told.chance = all_explained ? 0.0 : chance_of(gained, larger);
  found.told.held = by_share.front().well_told() >= directions_least;
  found.told.about_mm = middle_mm;
  take_moments(by_share, std::max(1.0, larger.ratio()), found);
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
