// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "axiometry/base/text/number_text.h"
#include "axiometry/numeric/dense/dense.h"
#include "axiometry/numeric/distributions/chi_square.h"
#include "axiometry/tracking/station/station_checks.h"

namespace axiometry::tracking {
namespace {

/// What may have gone wrong: the length of one point, or all from one point on.
struct Hypothesis {
  std::size_t first = 0;
  bool to_the_end = false;
  double promise = 0.0;  ///< fall of χ² expected to first order
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
  const Eigen::VectorXd free = residuals - base * (base.transpose() * residuals);
  // Of the column e of a hypothesis, 1/σ where the length is wrong: e·e, Uᵀe and e·(residuals free of U). Those of "all
  // from here on" are sums from the end.
  struct Sums {
    double squares = 0.0;
    Eigen::RowVectorXd along = Eigen::RowVectorXd::Zero(4);
    double promise = 0.0;

    double gain() const {
      const double left = squares - along.squaredNorm();
      return left > 1e-6 * squares ? promise * promise / left : -1.0;
    }
  } behind;
  std::vector<Hypothesis> all;
  for (std::size_t i = n; i-- > 0;) {
    const auto row = static_cast<Eigen::Index>(i);
    const double weight = 1.0 / solution.fit.sigma_mm[i];
    const Sums own{weight * weight, weight * base.row(row), weight * free[row]};
    all.push_back({.first = i, .promise = own.gain()});
    behind.squares += own.squares;
    behind.along += own.along;
    behind.promise += own.promise;
    if (i >= 2 && i + 1 < n) all.push_back({.first = i, .to_the_end = true, .promise = behind.gain()});
  }
  std::ranges::sort(all, {}, [](const Hypothesis& h) { return std::pair(h.to_the_end, h.first); });
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
  constexpr double least_chance = 0.001;  // least chance of the residuals that a hypothesis leaves
  const RefinedFit& fit = solution.fit;
  if (fit.degrees_of_freedom < 2 || fit.chance > 1e-4) return;
  if (std::ranges::any_of(solution.distances_mm, [](double length) { return !(length > 0.0); })) return;
  std::vector<Hypothesis> all = hypotheses(points, solution);
  all.resize(std::min(all.size(), most_tried));
  const Vector3 first[] = {fit.station_mm};
  const std::vector<Vector3> starts = starts_around(points, first);
  // Twice: weights of some points are not quite those of all.
  const double most =
      2.0 * numeric::chi_square_quantile(1.0 - least_chance, static_cast<double>(fit.degrees_of_freedom - 1));
  for (Hypothesis& h : all) {
    const auto minima = refine_from_all(points, options, starts, h.shape(points.size()), most);
    if (!minima.empty()) h.minimum = minima.front();
  }
  std::erase_if(all, [&](const Hypothesis& h) {
    return !h.minimum.converged ||
           numeric::chi_square_tail(h.minimum.chi_squared, fit.degrees_of_freedom - 1) < least_chance;
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
  // One redundant length is explained by one of a dozen hypotheses often enough by chance: what a machine may err by
  // speaks for the machine.
  const bool one_check = fit.degrees_of_freedom == 2;
  if (one_check) message += "; this rests on one redundant length, measure more points";
  const bool by_machine = one_check && machine_error_mm(fit) < usual_machine_error_mm;
  findings.push_back({"station-misreading", std::abs(best.minimum.step_mm) > 0.02 && !by_machine, std::move(message)});
}

}  // namespace axiometry::tracking
