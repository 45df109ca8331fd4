// SPDX-License-Identifier: Apache-2.0
#include "axiometry/standards/iso230_2/periodic/run_means.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "axiometry/base/counted.h"
#include "axiometry/numeric/dense/dense.h"
#include "axiometry/numeric/distributions/normal_and_student_t.h"
#include "axiometry/numeric/moments.h"

namespace axiometry::iso230_2 {
namespace {

constexpr std::size_t runs_most = 100;  // of which some readings are missing: their shifts are solved for together

/// Readings of the runs that have some, by targets that have some.
struct Readings {
  std::vector<double> places;
  std::vector<std::vector<double>> rows;  ///< NaN where one is missing
  std::size_t runs = 0;
  std::size_t missing = 0;
};

Readings readings_of(const Series& series, Direction direction) {
  std::vector<std::size_t> driven;
  for (std::size_t j = 0; j < series.run_count(); ++j)
    for (std::size_t i = 0; i < series.target_count(); ++i)
      if (!std::isnan(series.cell(i, direction)[j])) {
        driven.push_back(j);
        break;
      }
  Readings readings;
  readings.runs = driven.size();
  for (std::size_t i = 0; i < series.target_count(); ++i) {
    const auto cell = series.cell(i, direction);
    std::vector<double> row;
    for (const std::size_t j : driven) row.push_back(cell[j]);
    const auto absent = static_cast<std::size_t>(std::ranges::count_if(row, [](double x) { return std::isnan(x); }));
    if (absent == row.size()) continue;
    readings.missing += absent;
    readings.places.push_back(series.targets()[i].in_native());
    readings.rows.push_back(std::move(row));
  }
  return readings;
}

/// The shifts of the runs r, with mean 0, of levels l_i and readings l_i + r_j + scatter: by least squares
/// L r = Σ (x_ij − x̄_i), L the Laplacian of runs that share targets, Σ over the targets of diag(b) − b bᵀ/n_i.
struct Shifts {
  std::vector<double> of_runs;
  double scatter = 0.0;  ///< s of a reading about level and shift
  double degrees = 0.0;  ///< of s
  double u_means = 0.0;  ///< what the shifts are uncertain by in the means, rms; wider for few degrees
};

Result<Shifts> shifts_of(const Readings& readings, Direction direction) {
  if (readings.runs > runs_most)
    return fail(fmt::format("found readings missing in {} {}, expected at most {} runs where some are missing",
                            counted(readings.runs, "run"), arrow(direction), runs_most));
  const auto n = static_cast<Eigen::Index>(readings.runs);
  Eigen::MatrixXd laplacian = Eigen::MatrixXd::Zero(n, n);
  Eigen::VectorXd right = Eigen::VectorXd::Zero(n);
  double count = 0.0;
  for (const auto& row : readings.rows) {
    const numeric::Moments cell = numeric::moments(row);
    const double all = static_cast<double>(cell.count);
    count += all;
    for (Eigen::Index j = 0; j < n; ++j) {
      if (std::isnan(row[static_cast<std::size_t>(j)])) continue;
      right[j] += row[static_cast<std::size_t>(j)] - cell.mean;
      laplacian(j, j) += 1.0;
      for (Eigen::Index k = 0; k < n; ++k)
        if (!std::isnan(row[static_cast<std::size_t>(k)])) laplacian(j, k) -= 1.0 / all;
    }
  }
  const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> solved(laplacian);
  const double told_least = 1e-9 * std::max(1.0, solved.eigenvalues()[n - 1]);
  Eigen::VectorXd inverted = solved.eigenvalues();
  Eigen::Index groups = 0;
  for (double& x : inverted) {
    groups += x > told_least ? 0 : 1;
    x = x > told_least ? 1.0 / x : 0.0;
  }
  Shifts shifts;
  shifts.degrees = count - static_cast<double>(readings.rows.size()) - static_cast<double>(n) + 1.0;
  if (groups > 1 || shifts.degrees < 1.0)
    return fail(
        fmt::format("found runs {} that share too few targets, expected runs that go through the same: what "
                    "they are shifted by against each other is not known, and may be taken for an error",
                    arrow(direction)));
  const Eigen::MatrixXd cofactors = solved.eigenvectors() * inverted.asDiagonal() * solved.eigenvectors().transpose();
  const Eigen::VectorXd found = cofactors * right;
  shifts.of_runs.assign(found.begin(), found.end());
  double squares = 0.0, variances = 0.0;
  for (const auto& row : readings.rows) {
    std::vector<double> levelled = row;
    for (std::size_t j = 0; j < levelled.size(); ++j) levelled[j] -= shifts.of_runs[j];
    const numeric::Moments cell = numeric::moments(levelled);
    const double all = static_cast<double>(cell.count);
    if (cell.count > 1) squares += cell.standard_deviation * cell.standard_deviation * (all - 1.0);
    Eigen::VectorXd share(n);
    for (Eigen::Index j = 0; j < n; ++j)
      share[j] = (std::isnan(row[static_cast<std::size_t>(j)]) ? 0.0 : 1.0 / all) - 1.0 / static_cast<double>(n);
    variances += share.dot(cofactors * share);
  }
  shifts.scatter = std::sqrt(squares / shifts.degrees);
  const double wider = numeric::student_t_quantile(numeric::normal_probability(2.0), shifts.degrees) / 2.0;
  shifts.u_means = wider * shifts.scatter * std::sqrt(variances / static_cast<double>(readings.rows.size()));
  return shifts;
}

}  // namespace

Result<RunMeans> run_means_of(const Series& series, Direction direction) {
  const Readings readings = readings_of(series, direction);
  RunMeans means;
  means.places = readings.places;
  means.runs = readings.runs;
  means.missing = readings.missing;
  Shifts shifts;
  if (means.missing > 0) {
    AXIOMETRY_TRY(shifts, shifts_of(readings, direction));
    means.u_means = shifts.u_means;
  }
  double squares = 0.0, cells = 0.0, shares = 0.0;
  for (std::vector<double> row : readings.rows) {
    for (std::size_t j = 0; j < shifts.of_runs.size(); ++j) row[j] -= shifts.of_runs[j];
    const numeric::Moments cell = numeric::moments(row);
    means.values.push_back(cell.mean);
    shares += 1.0 / static_cast<double>(cell.count);
    if (cell.count < 2) continue;
    squares += cell.standard_deviation * cell.standard_deviation / static_cast<double>(cell.count);
    cells += 1.0;
  }
  if (means.missing > 0)  // shifts that were taken out have taken degrees of freedom too
    means.scatter = shifts.scatter * std::sqrt(shares / static_cast<double>(means.places.size()));
  else if (cells > 0.0)
    means.scatter = std::sqrt(squares / cells);
  return means;
}

}  // namespace axiometry::iso230_2
