// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>

#include "axiometry/base/number_text.h"
#include "axiometry/tracking/chi_squared.h"
#include "axiometry/tracking/station_checks.h"

namespace axiometry::tracking {
namespace {

/// What may have gone wrong: the length of one point, or all from one point on.
struct Hypothesis {
  std::size_t first = 0;
  bool to_the_end = false;
  double promise = 0.0;  ///< what χ² would lose, to first order
  Minimum minimum{};

  std::vector<double> shape(std::size_t count) const {
    std::vector<double> shape(count, 0.0);
    for (std::size_t i = first; i < (to_the_end ? count : first + 1); ++i) shape[i] = 1.0;
    return shape;
  }
};

/// Every one that the points can tell apart, the most promising first.
std::vector<Hypothesis> hypotheses(std::span<const LocationPoint> points, const RefinedSolution& solution) {
  const std::size_t n = points.size();
  Eigen::MatrixXd rows(static_cast<Eigen::Index>(n), 4);
  Eigen::VectorXd residuals(static_cast<Eigen::Index>(n));
  for (std::size_t i = 0; i < n; ++i) {
    const Vector3 u = 1.0 / solution.distances_mm[i] * (points[i].at_mm - solution.fit.station_mm);
    const double sigma = solution.fit.sigma_mm[i];
    rows.row(static_cast<Eigen::Index>(i)) << -u.x / sigma, -u.y / sigma, -u.z / sigma, -1.0 / sigma;
    residuals[static_cast<Eigen::Index>(i)] = solution.fit.residuals_mm[i] / sigma;
  }
  const Eigen::MatrixXd base = rows.jacobiSvd(Eigen::ComputeThinU).matrixU();
  std::vector<Hypothesis> all;
  for (std::size_t first = 0; first < n; ++first) all.push_back({.first = first});
  for (std::size_t first = 2; first + 1 < n; ++first) all.push_back({.first = first, .to_the_end = true});
  for (Hypothesis& h : all) {
    const std::vector<double> shape = h.shape(n);
    Eigen::VectorXd e(static_cast<Eigen::Index>(n));
    for (std::size_t i = 0; i < n; ++i) e[static_cast<Eigen::Index>(i)] = shape[i] / solution.fit.sigma_mm[i];
    const Eigen::VectorXd free = e - base * (base.transpose() * e);
    const double along = free.dot(residuals);
    h.promise = free.squaredNorm() > 1e-6 * e.squaredNorm() ? along * along / free.squaredNorm() : -1.0;
  }
  std::erase_if(all, [](const Hypothesis& h) { return h.promise < 0.0; });
  std::ranges::stable_sort(all, [](const Hypothesis& a, const Hypothesis& b) { return a.promise > b.promise; });
  return all;
}

std::string words(const Hypothesis& h) {
  // the step is what the lengths would have to be longer
  const std::string amount =
      fmt::format("{} too {}", shown_mm(std::abs(h.minimum.step_mm)), h.minimum.step_mm < 0.0 ? "long" : "short");
  return h.to_the_end
             ? fmt::format("all lengths from point {} on being {} (the beam was broken before it)", h.first + 1, amount)
             : fmt::format("the length of point {} being {}", h.first + 1, amount);
}

}  // namespace

void add_misreading_findings(std::span<const LocationPoint> points, const StationOptions& options,
                             const RefinedSolution& solution, std::vector<Finding>& findings) {
  constexpr std::size_t most_tried = 16;
  const RefinedFit& fit = solution.fit;
  if (fit.degrees_of_freedom < 2 || fit.chance > 1e-4) return;
  if (std::ranges::any_of(solution.distances_mm, [](double length) { return !(length > 0.0); })) return;
  std::vector<Hypothesis> all = hypotheses(points, solution);
  all.resize(std::min(all.size(), most_tried));
  const Vector3 first[] = {fit.station_mm};
  const std::vector<Vector3> starts = starts_around(points, first);
  for (Hypothesis& h : all) {
    const auto minima = refine_from_all(points, options, starts, h.shape(points.size()));
    if (!minima.empty()) h.minimum = minima.front();
  }
  std::erase_if(all, [&](const Hypothesis& h) {
    return !h.minimum.converged || chi_squared_tail(h.minimum.chi_squared, fit.degrees_of_freedom - 1) < 0.001;
  });
  if (all.empty()) return;
  std::ranges::stable_sort(
      all, [](const Hypothesis& a, const Hypothesis& b) { return a.minimum.chi_squared < b.minimum.chi_squared; });
  const Hypothesis& best = all.front();
  std::string message = fmt::format("{} would explain the residuals, chi-squared falling from {} to {}", words(best),
                                    shown_chi_squared(fit.chi_squared), shown_chi_squared(best.minimum.chi_squared));
  for (std::size_t k = 1; k < std::min<std::size_t>(all.size(), 3); ++k)
    message += fmt::format("{} {}", k == 1 ? "; so would" : " or", words(all[k]));
  message += fmt::format("; without it the station would be {}", shown_point(best.minimum.station_mm));
  if (fit.degrees_of_freedom == 2) message += "; this rests on one redundant length, measure more points";
  findings.push_back({std::abs(best.minimum.step_mm) > 0.02, std::move(message)});
}

}  // namespace axiometry::tracking
