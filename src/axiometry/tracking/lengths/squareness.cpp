// SPDX-License-Identifier: Apache-2.0
#include "axiometry/tracking/lengths/squareness.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <string_view>

#include "axiometry/base/contract.h"
#include "axiometry/numeric/dense/dense.h"
#include "axiometry/standards/error_motions/motion_estimate.h"
#include "axiometry/tracking/station/residual_findings.h"

namespace axiometry::tracking {
namespace {

constexpr Eigen::Index unknowns = 6;
constexpr std::size_t scales = 3;  // the first unknowns are the scales
constexpr std::array<std::string_view, 6> parameter_ids = {"e_x", "e_y", "e_z", "C0Y", "B0Z", "A0Z"};

// 0.1 µm/m in the slopes would be 1 mm/m in a combination that is weaker: no axis is so bad, nothing is told.
constexpr double weakest = 1e-4;
// Of 1 000 µm/m in what cannot be told at most 0.01 µm/m gets into what can.
constexpr double purest = 1e-5;
constexpr double short_line_mm = 300.0;

using Row = Eigen::Matrix<double, 1, unknowns>;
using Matrix = Eigen::Matrix<double, Eigen::Dynamic, unknowns>;

/// uᵀ D u by the six terms.
Row row_of(Vector3 direction) {
  const Vector3 u = unit(direction);
  return Row{u.x * u.x, u.y * u.y, u.z * u.z, -u.x * u.y, u.x * u.z, -u.y * u.z};
}

bool known(double uncertainty) { return std::isfinite(uncertainty) && uncertainty > 0.0; }

/// What the lines tell about the terms, whatever their uncertainties: an orthonormal basis of the combinations that
/// they tell, and of those that they do not.
struct Subspaces {
  Eigen::MatrixXd told;
  Eigen::MatrixXd untold;

  explicit Subspaces(const Matrix& lines) {
    const Eigen::JacobiSVD<Eigen::MatrixXd> svd(lines, Eigen::ComputeFullV);
    const auto rank = (svd.singularValues().array() > weakest).count();
    told = svd.matrixV().leftCols(rank);
    untold = svd.matrixV().rightCols(unknowns - rank);
  }
  bool tells(Eigen::Index term) const { return untold.cols() == 0 || untold.row(term).norm() < purest; }
};

/// 1/σ of each line where σ is known; else the root of what 1/σ² is expected to be after its u, where the variances of
/// lines scatter about that of all as if eight degrees of freedom told it: few readings of its own then move no weight
/// far, and what moves it little moves the U of the terms little (docs/theory/squareness.md).
Eigen::VectorXd weights_of(std::span<const LineSlope> slopes) {
  constexpr double alike = 8.0;
  double sum = 0.0, degrees = 0.0;
  for (const LineSlope& line : slopes) {
    if (!std::isfinite(line.degrees_of_freedom)) continue;
    sum += line.degrees_of_freedom * line.uncertainty_um_per_m * line.uncertainty_um_per_m;
    degrees += line.degrees_of_freedom;
  }
  Eigen::VectorXd weights(static_cast<Eigen::Index>(slopes.size()));
  for (Eigen::Index i = 0; i < weights.size(); ++i) {
    const LineSlope& line = slopes[static_cast<std::size_t>(i)];
    const double own = line.degrees_of_freedom, u = line.uncertainty_um_per_m;
    weights[i] = std::isfinite(own) ? std::sqrt((alike + own) / (alike * sum / degrees + own * u * u)) : 1.0 / u;
  }
  return weights;
}

std::string quantity(double um_per_m) { return fmt::format("{:.3g} µm/m", um_per_m); }

void note_untold(ScalesAndSquareness& result) {
  std::vector<std::string_view> absent;
  for (const SquarenessTerm& term : result.terms)
    if (!term.value_um_per_m) absent.push_back(term.id);
  if (!absent.empty())
    result.notes.push_back(
        fmt::format("These {} lines tell {} combination{} of the six terms; {} cannot be told from "
                    "them and {} left out, not set to zero",
                    result.residuals_um_per_m.size(), result.rank, result.rank == 1 ? "" : "s", fmt::join(absent, ", "),
                    absent.size() == 1 ? "is" : "are"));
}

void note_redundancy(ScalesAndSquareness& result, double inflation) {
  const auto nu = static_cast<double>(result.degrees_of_freedom);
  if (result.degrees_of_freedom == 0) {
    result.notes.push_back("There are no more lines than combinations of terms: nothing checks whether they agree");
    return;
  }
  if (!result.weighted) return;
  if (const auto few = few_residuals_finding(result.chi_squared, result.degrees_of_freedom))
    result.notes.push_back(few->message);
  // The 95 % quantile of χ² is ν + 2√(2ν) within 2 % for ν up to 10.
  if (result.chi_squared > nu + 2.0 * std::sqrt(2.0 * nu))
    result.notes.push_back(
        fmt::format("The lines contradict each other by more than their uncertainties: χ² = {:.3g} for ν = {}; the "
                    "model of straight axes without rotations does not describe this machine, uncertainties are "
                    "multiplied by {:.2g}",
                    result.chi_squared, result.degrees_of_freedom, inflation));
}

void note_limits(ScalesAndSquareness& result, std::span<const LineSlope> slopes) {
  const bool any_square = std::any_of(result.terms.begin() + scales, result.terms.end(),
                                      [](const SquarenessTerm& term) { return term.value_um_per_m.has_value(); });
  if (any_square)
    result.notes.push_back(
        "Axes count as straight and without rotations: what straightness and angular errors (with the tool's offset as "
        "lever) add along these lines is taken for scale or squareness. The result holds for the place of the lines");
  const auto shortest = std::ranges::min_element(slopes, {}, [](const LineSlope& line) {
    return line.length_mm > 0.0 ? line.length_mm : std::numeric_limits<double>::infinity();
  });
  if (shortest->length_mm > 0.0 && shortest->length_mm < short_line_mm)
    result.notes.push_back(
        fmt::format("Line {} is {:.0f} mm long: 1 µm of straightness at one of its ends is {} of slope", shortest->id,
                    shortest->length_mm, quantity(1000.0 / shortest->length_mm)));
}

}  // namespace

ScalesAndSquareness estimate_squareness(std::span<const LineSlope> slopes, double common_scale_um_per_m) {
  ScalesAndSquareness result;
  for (std::size_t k = 0; k < parameter_ids.size(); ++k) result.terms[k].id = parameter_ids[k];
  if (slopes.empty()) return result;

  const auto count = static_cast<Eigen::Index>(slopes.size());
  result.weighted = std::ranges::all_of(slopes, known, &LineSlope::uncertainty_um_per_m);
  Matrix lines(count, unknowns);
  Eigen::VectorXd measured(count);
  const Eigen::VectorXd weights = result.weighted ? weights_of(slopes) : Eigen::VectorXd::Ones(count).eval();
  for (Eigen::Index i = 0; i < count; ++i) {
    const LineSlope& line = slopes[static_cast<std::size_t>(i)];
    AXIOMETRY_CONTRACT(is_finite(line.direction) && norm(line.direction) > 0.0 && std::isfinite(line.slope_um_per_m) &&
                       line.degrees_of_freedom > 0.0);
    lines.row(i) = row_of(line.direction);
    measured[i] = line.slope_um_per_m;
  }

  const Subspaces subspaces(lines);
  const Eigen::MatrixXd weighted = weights.asDiagonal() * lines * subspaces.told;
  const Eigen::ColPivHouseholderQR<Eigen::MatrixXd> qr(weighted);
  const Eigen::VectorXd right = weights.cwiseProduct(measured);
  const Eigen::VectorXd terms = subspaces.told * qr.solve(right);
  const Eigen::VectorXd residuals = measured - lines * terms;
  result.rank = static_cast<std::size_t>(subspaces.told.cols());
  result.degrees_of_freedom = slopes.size() - result.rank;
  result.residuals_um_per_m.assign(residuals.begin(), residuals.end());
  if (result.weighted) result.chi_squared = weights.cwiseProduct(residuals).squaredNorm();

  const auto nu = static_cast<double>(result.degrees_of_freedom);
  const double inflation = result.degrees_of_freedom > 0 ? std::sqrt(std::max(1.0, result.chi_squared / nu)) : 1.0;
  // Of each slope times its weight.
  const Eigen::MatrixXd gains =
      inflation * subspaces.told * Eigen::MatrixXd(qr.solve(Eigen::MatrixXd::Identity(count, count)));
  Eigen::VectorXd own = weights;  // u of each slope times its weight
  if (result.weighted)
    for (Eigen::Index i = 0; i < count; ++i) own[i] *= slopes[static_cast<std::size_t>(i)].uncertainty_um_per_m;
  const Eigen::MatrixXd scaled = gains * own.asDiagonal();
  Eigen::MatrixXd covariance = scaled * scaled.transpose();
  // A scale that all slopes share is e_x = e_y = e_z: u·u = 1.
  covariance.topLeftCorner(scales, scales).array() += common_scale_um_per_m * common_scale_um_per_m;

  for (Eigen::Index k = 0; k < unknowns; ++k) {
    if (!subspaces.tells(k)) continue;
    SquarenessTerm& term = result.terms[static_cast<std::size_t>(k)];
    term.value_um_per_m = terms[k];
    if (!result.weighted) continue;
    term.uncertainty_um_per_m = std::sqrt(covariance(k, k));
    std::vector<error_motions::ScatterPart> parts;
    if (k < static_cast<Eigen::Index>(scales)) parts.push_back({common_scale_um_per_m});
    for (Eigen::Index i = 0; i < count; ++i)
      parts.push_back({std::abs(gains(k, i)), slopes[static_cast<std::size_t>(i)].degrees_of_freedom});
    term.coverage_factor = error_motions::coverage_of(error_motions::combined_scatter(parts).degrees);
    // How much the lines contradict each other is known with ν only.
    if (few_residuals_finding(result.chi_squared, result.degrees_of_freedom))
      term.coverage_factor = std::max(term.coverage_factor, error_motions::coverage_of(nu));
    for (Eigen::Index m = 0; m < unknowns; ++m)
      if (subspaces.tells(m))
        result.covariance_um2_per_m2[static_cast<std::size_t>(k)][static_cast<std::size_t>(m)] = covariance(k, m);
  }

  note_untold(result);
  note_redundancy(result, inflation);
  if (!result.weighted)
    result.notes.push_back("The uncertainty of at least one slope is not known: all lines count alike, none is stated");
  note_limits(result, slopes);
  return result;
}

}  // namespace axiometry::tracking
